/* read.c - reads the sheets from the csv beside this file. Declared in sheet.h. */
#include <stdlib.h>
#include <string.h>
#include "lab/measure/views.h"
#include "lab/papers/sheet.h"

enum { MOST_OF_ALL = 512 };
static sheet sheets[MOST_SHEETS];
static paper_row rows[MOST_OF_ALL];
static claim claims[MOST_OF_ALL];

static line views = { .folder = SHEET_FOLDER, .file = "views" };

/* ---- >>views ----------------------------------------------------------------------------------------------------- */

/* Reads the view of a sheet: a line of views.csv, or else the scene of that name. */
static void read_view(sheet *t, const line *from)
{
    const char *name = line_text(from, "view");
    t->see = (view){ .name = name, .path = name };
    if (name && line_find(&views, "view", name, strlen(name))) view_read(&t->see, &t->lit, &views);
    t->see.radius = line_real(from, "radius");
}

/* ---- >>sheets ---------------------------------------------------------------------------------------------------- */

/* Reads columns as HEAD=QUANTITY.DIGITS; own-1 is the first column of the sheet's own. */
static void read_columns(sheet *t, const line *l)
{
    const char *is[MOST_HEADS] = { NULL };
    line_split(l, "columns", is, MOST_HEADS);
    for (int k = 0; k < MOST_HEADS && is[k]; ++k) {
        const char *of = strrchr(is[k], '='), *digits = strrchr(is[k], '.');
        if (!of || digits < of) line_fault(l, "columns");
        t->column[k].head = strndup(is[k], (size_t)(of - is[k]));
        t->column[k].digits = atoi(digits + 1);
        t->column[k].of = line_word(l, "columns", "time milliseconds overhead error bias bounce radiance noise "
                                                  "bounce-noise model hue mean surfels rmse kilobytes seconds own-1 "
                                                  "own-2 own-3 own-4 own-5 own-6",
                                    of + 1, (size_t)(digits - of - 1));
    }
}

int sheet_rule(claim *c, const char *rule)
{
    static const struct { const char *word; double least, most; } words_of[] = {
        { "less", -HUGE_VAL, 1 }, { "much less", -HUGE_VAL, 0.7 }, { "little more", -HUGE_VAL, 1.1 },
        { "similar", -HUGE_VAL, 0.25 }
    };
    double v, w;
    c->rule = rule;
    for (int k = 0; k < COUNT(words_of); ++k) {
        if (strcmp(rule, words_of[k].word)) continue;
        c->least = words_of[k].least;
        c->most = words_of[k].most;
        return 0;
    }
    if (sscanf(rule, "as printed %lf", &v) == 1) {
        c->least = v / 1.5;
        c->most = v * 1.5;
    } else if (sscanf(rule, "alike %lf", &v) == 1) {
        c->least = 1 / (1 + v);
        c->most = 1 + v;
    } else if (sscanf(rule, "within %lf %lf", &v, &w) == 2) {
        c->least = v;
        c->most = w;
    } else return -1;
    return 0;
}

static void read_row(paper_row *p, const line *l)
{
    *p = (paper_row){ .what = line_text(l, "what"), .method = line_text(l, "method"), .note = line_text(l, "note"),
                      .reach = line_real(l, "reach"), .width = line_whole(l, "width"),
                      .height = line_whole(l, "height"), .base = line_whole(l, "base"), .ours = line_whole(l, "ours"),
                      .half = line_whole(l, "half"), .slow = line_whole(l, "slow") };
    if (p->method && !(p->settings = line_text(l, "settings"))) p->settings = "";
    line_split(l, "printed", p->printed, MOST_HEADS);
}

static void read_claim(claim *c, const sheet *t, const line *l)
{
    const char *head = line_cell(l, "column"), *beside = line_cell(l, "beside");
    *c = (claim){ .says = line_text(l, "says"), .why = line_text(l, "why"), .row = line_whole(l, "row") - 1,
                  .beside = *beside ? atoi(beside) - 1 : ALONE, .unmodelled = line_text(l, "unmodelled") };
    while (c->column < MOST_HEADS && t->column[c->column].head && strcmp(t->column[c->column].head, head))
        ++c->column;
    if (c->column == MOST_HEADS || !t->column[c->column].head) line_fault(l, "column");
    if (sheet_rule(c, line_cell(l, "rule"))) line_fault(l, "rule");
}

/* Whether a line belongs to a sheet. */
static int is_of(const line *l, const sheet *t)
{
    return !strcmp(line_cell(l, "paper"), t->paper)
        && !strcmp(line_cell(l, "figure"), t->name);
}

static void read_sheet(sheet *t, const line *l)
{
    const char *way = line_cell(l, "drawn");
    const int drawn_as = line_word(l, "drawn", "pictures halves fields times passes stages rates crowd", way,
                                   strlen(way));
    *t = (sheet){ .paper = line_text(l, "paper"), .name = line_text(l, "figure"), .title = line_text(l, "title"),
                  .theirs = line_text(l, "theirs"), .erratum = line_text(l, "erratum"), .ours = line_text(l, "ours"),
                  .drawn = (drawing)drawn_as, .width = line_whole(l, "width"), .height = line_whole(l, "height"),
                  .rays = line_whole(l, "rays"), .phases = line_whole(l, "phases"), .stride = line_whole(l, "stride"),
                  .pictured = line_whole(l, "pictured"), .truth = line_real(l, "truth") };
    line_split(l, "heads", t->head, MOST_HEADS);
    read_columns(t, l);
    read_view(t, l);
}

/* Rows and claims stand in the order of the sheets. A line out of order belongs to no sheet. */
static void read_all(void)
{
    line s = { SHEET_FOLDER, .file = "sheets" }, r = { SHEET_FOLDER, .file = "rows" },
         c = { SHEET_FOLDER, .file = "claims" };
    line *const every[] = { &s, &r, &c, &views };
    for (int i = 0; i < COUNT(every); ++i) {
        line_open(every[i]);
        if (every[i]->of.rows > MOST_OF_ALL) line_fault(every[i], "");
    }
    for (; s.at < s.of.rows; ++s.at) {
        sheet *t = &sheets[s.at];
        if (s.at == MOST_SHEETS - 1) line_fault(&s, "paper");
        read_sheet(t, &s);
        t->rows = &rows[r.at];
        t->claims = &claims[c.at];
        for (; r.at < r.of.rows && is_of(&r, t) && t->count < MOST_PAPER_ROWS; ++r.at, ++t->count)
            read_row(&rows[r.at], &r);
        for (; c.at < c.of.rows && is_of(&c, t); ++c.at, ++t->claimed) read_claim(&claims[c.at], t, &c);
    }
    if (r.at < r.of.rows) line_fault(&r, "figure");
    if (c.at < c.of.rows) line_fault(&c, "figure");
}

const sheet *papers_sheet(int k)
{
    if (!sheets->paper) read_all();
    return k < MOST_SHEETS && sheets[k].paper ? &sheets[k] : NULL;
}
