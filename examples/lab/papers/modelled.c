/* modelled.c - times of the papers' rows by the model of make cost, for which a software rasteriser's say nothing.
   Declared in sheet.h. */
#include <string.h>
#include "lab/measure/csv.h"
#include "lab/papers/sheet.h"

enum { DIGITS = 2 };                       /* more than of times that are measured */

static csv all;

static int is_of(int at, const sheet *t)
{
    return t->paper && !strcmp(csv_text(&all, at, "paper"), t->paper)
        && !strcmp(csv_text(&all, at, "figure"), t->name);
}

const row *sheet_modelled(sheet *finer, const sheet *t)
{
    static row rows[MOST_PAPER_ROWS];
    double part[MOST_PAPER_ROWS][PARTS];
    int found = 0;
    if (!all.rows) all = csv_read(SHEET_FOLDER, "modelled.csv");
    sheet_blank(t, rows);
    for (int i = 0; i < MOST_PAPER_ROWS; ++i) for (int k = 0; k < PARTS; ++k) part[i][k] = (double)NAN;
    for (int i = 0; i < all.rows; ++i) {
        if (!is_of(i, t)) continue;
        const int at = (int)csv_number(&all, i, "row") - 1;
        const double ms = csv_number(&all, i, "ms");
        if (at < 0 || at >= t->count) continue;
        if (t->drawn == PASSES) part[at][(int)csv_number(&all, i, "part") % PARTS] = ms;
        rows[at].ms = rows[at].relative = ms;
        ++found;
    }
    for (int i = 0; found && t->drawn == PASSES && i < t->count; ++i) sheet_passes(&rows[i], part[i]);
    if (found && t->drawn == RATES) sheet_rates(t, rows);
    *finer = *t;
    for (int c = 0; c < sheet_columns(t); ++c) finer->column[c].digits += DIGITS;
    return found ? rows : NULL;
}

const row *sheet_judge(const sheet **t, const claim *c, const row *rows)
{
    static sheet finer;
    if (!sheet_timed(*t, c->column) || !kit_gl_is_software()) return rows;
    if (c->unmodelled || !(rows = sheet_modelled(&finer, *t))) return NULL;
    *t = &finer;
    return isnan(sheet_judged(&finer, c, rows)) ? NULL : rows;
}

int sheet_wants_model(const sheet *t, int i)
{
    for (int k = 0; k < t->claimed; ++k) {
        const claim *c = &t->claims[k];
        const int at = c->row == i || c->beside == i || t->rows[c->row].base == i + 1;
        if (sheet_timed(t, c->column) && !c->unmodelled && t->rows[i].method && (at || t->drawn == RATES)) return 1;
    }
    return 0;
}
