/* show.c - prints a paper's table or figure beside the results here, as csv. Declared in sheet.h. */
#include <math.h>
#include <string.h>
#include "lab/measure/csv.h"
#include "lab/page/page.h"
#include "lab/papers/sheet.h"

/* Our cell of a row; "" if there is none. */
static const char *cell(char text[32], const sheet *t, const row *rows, int i, int c)
{
    const double v = sheet_value(t, rows, i, c);
    if (isnan(v)) return "";
    snprintf(text, 32, "%.*f", t->column[c].digits, fabs(v) < 0.5 * pow(10, -t->column[c].digits) ? 0.0 : v);
    return text;
}

static const char *number(char text[32], double v)
{
    snprintf(text, 32, fabs(v) < 1000 ? "%.3g" : "%.0f", v);
    return text;
}

/* Writes the bounds beyond which a claim that holds would fail, or within which another would hold. */
static void put_bounds(FILE *f, const claim *c, int holds)
{
    const int lower = isfinite(c->least), upper = isfinite(c->most);
    char least[32], most[32];
    number(least, c->least);
    number(most, c->most);
    if (holds > 0 && lower && upper) fprintf(f, "would not at %s or less, nor at %s or more", least, most);
    else if (holds > 0) fprintf(f, "would not at %s or %s", lower ? least : most, lower ? "less" : "more");
    else if (lower && upper) fprintf(f, "would%s between %s and %s", holds ? " agree" : "", least, most);
    else fprintf(f, "would%s %s %s", holds ? " agree" : "", lower ? "above" : "below", lower ? least : most);
}

static void put_verdict(FILE *f, const sheet *t, const claim *c, const row *rows)
{
    const int holds = sheet_holds(t, c, rows);
    const row *drawn = rows;
    char a[32], b[32], of[32];
    rows = sheet_judge(&t, c, rows);
    if (rows != drawn) fputs("by the model of a GPU it ", f);
    fprintf(f, "%s (%s", holds ? "agrees" : "does not agree", cell(a, t, rows, c->row, c->column));
    if (c->beside != ALONE)
        fprintf(f, " beside %s: %s of it", cell(b, t, rows, c->beside, c->column),
                number(of, sheet_judged(t, c, rows)));
    fputs("; ", f);
    put_bounds(f, c, holds);
    fputc(')', f);
}

const char *show_claim(char out[SENTENCE], const sheet *t, const claim *c, const row *rows)
{
    FILE *f = fmemopen(out, SENTENCE, "w");
    claim own;
    out[0] = 0;
    if (!f) return out;
    fprintf(f, "%s: ", c->says);
    if (sheet_holds(t, c, rows) == UNJUDGED) {
        fprintf(f, "not judged here, because %s (", c->unmodelled ? c->unmodelled : "its times are not modelled");
        put_bounds(f, c, UNJUDGED);
        fputc(')', f);
    } else if (sheet_holds(t, c, rows) == UNKNOWN) fputs("not known, for a row of it was not drawn", f);
    else put_verdict(f, t, c, rows);
    if (sheet_own(&own, t, c) && sheet_holds(t, &own, rows) >= 0) {
        fputs("; as the library has it, ", f);
        put_verdict(f, t, &own, rows);
    }
    if (c->why && !sheet_holds(t, c, rows)) fprintf(f, "; %s", c->why);
    fclose(f);
    return out;
}

/* ---- >>csv: a line for each cell, from which FIGURES.md's part is made ------------------------------------------- */

static void csv_cell(FILE *f, const sheet *t, int r, const char *kind, const char *head, const char *text)
{
    csv_quote(f, t->paper);
    fputc(',', f);
    csv_quote(f, t->name);
    fprintf(f, ",%d,%s,", r, kind);
    csv_quote(f, head);
    fputc(',', f);
    csv_quote(f, text ? text : "");
    fputc('\n', f);
}

void show_csv_head(FILE *f) { fputs("paper,figure,row,kind,head,text\n", f); }

void show_csv(FILE *f, const sheet *t, const row *rows)
{
    static const char *const came_to[] = { "not judged", "unknown", "differs", "agrees" };
    char text[32], said[SENTENCE];
    sheet finer;
    const row *modelled = sheet_modelled(&finer, t);
    csv_cell(f, t, 0, "title", "", t->title);
    csv_cell(f, t, 0, "theirs", "", t->theirs);
    if (t->erratum) csv_cell(f, t, 0, "erratum", "", t->erratum);
    csv_cell(f, t, 0, "ours", "", t->ours);
    for (int i = 0; i < t->count; ++i) {
        const paper_row *p = &t->rows[i];
        csv_cell(f, t, i + 1, "what", "", p->what);
        csv_cell(f, t, i + 1, "method", p->method ? p->method : "", p->method ? p->settings : NULL);
        if (p->note) csv_cell(f, t, i + 1, "note", "", p->note);
        for (int k = 0; k < sheet_heads(t); ++k) csv_cell(f, t, i + 1, "printed", t->head[k], p->printed[k]);
        for (int c = 0; c < sheet_columns(t); ++c)
            csv_cell(f, t, i + 1, sheet_timed(t, c) ? "time" : "measured", t->column[c].head,
                     cell(text, t, rows, i, c));
        for (int c = 0; modelled && c < sheet_columns(t); ++c)
            if (sheet_timed(t, c))
                csv_cell(f, t, i + 1, "modelled", t->column[c].head, cell(text, &finer, modelled, i, c));
    }
    for (int k = 0; k < t->claimed; ++k) {
        csv_cell(f, t, -1 - k, "rule", t->column[t->claims[k].column].head, t->claims[k].rule);
        csv_cell(f, t, -1 - k, "claim", came_to[2 + sheet_holds(t, &t->claims[k], rows)],
                 show_claim(said, t, &t->claims[k], rows));
    }
}

void show_absent(FILE *record, FILE *f, const char *paper)
{
    const csv absent = csv_read(SHEET_FOLDER, "absent.csv");
    for (int i = 0; i < absent.rows; ++i) {
        const sheet none = { .paper = paper, .name = csv_text(&absent, i, "name") };
        const char *why = csv_text(&absent, i, "why");
        if (strcmp(csv_text(&absent, i, "paper"), paper)) continue;
        if (f) csv_cell(f, &none, 0, "absent", "", why);
        if (record) page_paragraph(record, "[%s] %s: %s", paper, none.name, why);
    }
}
