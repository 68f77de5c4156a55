/* sheets.c - chains of the papers' rows, as their runs have them, and their milliseconds. Declared in sheets.h. */
#include "lab/cost/sheets.h"
#include "lab/cost/show.h"
#include "lab/measure/csv.h"
#include "lab/papers/sheet.h"

enum { LOOK_WIDTH = 160, LOOK_HEIGHT = 90 };           /* chains do not depend on the size */

/* Which row, and which part of it, chain number i is of. */
static struct { const sheet *t; int row, part; } of[MOST_CHAINS];

static int add_run(work *w, stage *s, const sheet *t, int at, int part, const entry *e, kit_error *err)
{
    char name[64];
    kit_run run;
    snprintf(name, sizeof name, "%s %.40s, %d", t->paper, t->name, at + 1);
    of[w->chains].t = t;
    of[w->chains].row = at;
    of[w->chains].part = part;
    cost_chain *c = work_chain(w, name, err);
    if (!c || stage_run(&run, s, e->method, e->settings, s->radius, err)) return -1;
    for (int i = 0; i < run.chains; ++i) {
        ssgi_gl_chain chain = run.chain[i];
        chain.precise = 0;                             /* which only errors ask for */
        if (work_add_to(w, c, &chain, err)) return -1;
    }
    kit_run_close(&run);
    return 0;
}

static int add_rows(work *w, const sheet *t, kit_error *err)
{
    int opened = 0;
    stage s;
    for (int i = 0; i < t->count; ++i) {
        const paper_row *p = &t->rows[i];
        const entry whole = { p->what, p->method, p->settings, 1 };
        view seen = t->see;
        const int passes = t->drawn == PASSES;
        if (!sheet_wants_model(t, i)) continue;
        seen.between = t->drawn == FIELDS || t->drawn == CROWD;
        if (!opened && (stage_load(&s, &seen, err) || stage_look(&s, &seen, LOOK_WIDTH, LOOK_HEIGHT, err))) return -1;
        opened = 1;
        for (int k = 0; k < (passes ? PARTS : 1); ++k)
            if (add_run(w, &s, t, i, k, passes ? &sheet_parts[k] : &whole, err)) return -1;
    }
    if (opened) stage_close(&s);
    return 0;
}

int sheets_add(work *w, kit_error *err)
{
    const sheet *t;
    int failed = kit_gl_open(NULL, err);
    for (int k = 0; (t = papers_sheet(k)) != NULL && !failed; ++k) failed = add_rows(w, t, err);
    kit_gl_close();
    return failed;
}

void sheets_write(FILE *f, const work *w)
{
    fputs("paper,figure,row,part,ms\n", f);
    for (int i = 0; i < w->chains; ++i) {
        csv_quote(f, of[i].t->paper);
        fputc(',', f);
        csv_quote(f, of[i].t->name);
        fprintf(f, ",%d,%d,%.4f\n", of[i].row + 1, of[i].part,
                chain_ms(w, &w->chain[i], 0, WEIGHED, &devices[0]));
    }
}
