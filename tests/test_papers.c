/* test_papers.c - the papers' tables and figures that make papers draws: that each is there, with rows that can be
   drawn, and that what a paper says is judged by its rows' figures. */
#include "t.h"
#include "kit/kit_gl.h"
#include "lab/papers/sheet.h"
#include <string.h>

static int heads_of(const sheet *t)
{
    int n = 0;
    while (n < MOST_HEADS && t->head[n]) ++n;
    return n;
}

static int columns_of(const sheet *t)
{
    int n = 0;
    while (n < MOST_HEADS && t->column[n].head) ++n;
    return n;
}

/* A row is drawn by a method that there is, with settings that it takes, or says why not. */
static void paper_row_sound(const sheet *t, int i)
{
    const paper_row *p = &t->rows[i];
    kit_method m;
    kit_error err = { "" };
    CHECK(p->what && *p->what, "%s %s: row %d has no name", t->paper, t->name, i + 1);
    CHECK(p->method || p->note, "%s %s, %s: is not drawn and does not say why", t->paper, t->name, p->what);
    CHECK(!p->method || !(kit_method_find(&m, p->method, &err) || kit_method_set(&m, p->settings, &err)),
          "%s %s, %s: %s", t->paper, t->name, p->what, err.text);
    CHECK(p->base >= 0 && p->base <= i, "%s %s, %s: is based on row %d", t->paper, t->name, p->what, p->base);
    for (int k = heads_of(t); k < 6; ++k)
        CHECK(!p->printed[k], "%s %s, %s: \"%s\" stands under no head", t->paper, t->name, p->what, p->printed[k]);
}

static void sheet_sound(const sheet *t)
{
    int printed[MOST_HEADS] = { 0 }, drawn = 0;
    CHECK(t->title && t->theirs && t->ours && t->draw && t->count > 0 && t->count <= MOST_PAPER_ROWS,
          "%s %s: has no words, or %d rows", t->paper, t->name, t->count);
    for (int i = 0; i < t->count; ++i) {
        paper_row_sound(t, i);
        drawn += t->rows[i].method != NULL;
        for (int k = 0; k < heads_of(t); ++k) printed[k] += t->rows[i].printed[k] != NULL;
    }
    CHECK(drawn && columns_of(t), "%s %s: %d rows are drawn, %d columns shown", t->paper, t->name, drawn,
          columns_of(t));
    for (int k = 0; k < heads_of(t); ++k)
        CHECK(printed[k], "%s %s: nothing stands under \"%s\"", t->paper, t->name, t->head[k]);
    for (int k = 0; k < t->claimed; ++k) {
        const claim *c = &t->claims[k];
        CHECK(c->column < columns_of(t) && c->a < t->count && c->b < t->count && c->a != c->b && c->least < c->most
                  && t->rows[c->a].method && (c->b == ALONE || t->rows[c->b].method),
              "%s %s: \"%s\" is of rows or a column that are not drawn", t->paper, t->name, c->says);
    }
}

/* Every table and figure on the list, in its order, with rows that can be drawn. */
static void papers_whole(void)
{
    static const char *const wanted[] = {
        "HSAO08 Table 1", "HSAO08 Figure 6", "HSAO08 Figure 7", "HSAO08 Figure 10", "HSAO08 Figure 11",
        "HSAO08 Figure 12", "HSAO08 Figure 14", "SSDO09 Table 1", "SSDO09 Figure 6", "SSDO09 Figure 9",
        "SSDO09 Figure 10", "SSDO09 Figure 11", "SSDO09 Figure 12", "SSDO09 Figure 14", "S3HO12 Table 1",
        "S3HO12 Figure 7", "S3HO12 Figure 8", "S3HO12 Figure 9", "AOF05 Table 2", "AOF05 Figure 5", "AOF05 Figure 8",
        "DSS14 Table 1", "DSS14 Figure 4", "DSS14 Figure 7, first row", "DSS14 Figure 7, second and third row",
        "DSS14 Figure 7, fourth row", "DSS14 Figure 7, fifth row", "DSS14 Figure 8", "DSS14 Figure 9"
    };
    const sheet *t;
    int k = 0;
    for (; (t = papers_sheet(k)) != NULL && k < COUNT(wanted); ++k) {
        char name[64];
        snprintf(name, sizeof name, "%s %s", t->paper, t->name);
        CHECK(!strcmp(name, wanted[k]), "%s stands where %s should", name, wanted[k]);
        sheet_sound(t);
    }
    CHECK(!t && k == COUNT(wanted), "%d tables and figures of %d", k, COUNT(wanted));
}

/* A statement holds within its range of a row's value over another's, of shares and of times alike. */
static void claims_judged(void)
{
    static const paper_row two[] = { { .what = "a", .method = "ssao" }, { .what = "b", .method = "ssao", .base = 1 } };
    static const claim says[] = { { "b errs less", LESS(0, 1, 0), NULL },
                                  { "b takes as long", ALIKE(1, 1, 0, 0.1), NULL },
                                  { "a fifth more", WITHIN(2, 1, 19, 21), NULL } };
    static const sheet t = { .rows = WITH_COUNT(two), .claims = WITH_COUNT(says),
                             .column = { { "error", ERROR, 3 }, { "time", TIME, 2 }, { "+%", OVERHEAD, 0 } } };
    row rows[2] = { row_blank(OF_AO, "", "", "", ""), row_blank(OF_AO, "", "", "", "") };
    CHECK(sheet_holds(&t, &says[0], rows) == -1, "what was not drawn is judged");
    rows[0].share = 0.5;
    rows[1].share = 0.4;
    rows[0].relative = 1;
    rows[1].relative = 1.2;
    CHECK(sheet_holds(&t, &says[0], rows) == 1 && sheet_holds(&t, &says[1], rows) == 0
          && sheet_holds(&t, &says[2], rows) == 1, "0.4 beside 0.5, 1.2 beside 1: %d %d %d",
          sheet_holds(&t, &says[0], rows), sheet_holds(&t, &says[1], rows), sheet_holds(&t, &says[2], rows));
    rows[1].error[1] = 0.6;                            /* of light: irradiance's */
    CHECK(sheet_holds(&t, &says[0], rows) == 0, "an error of 0.6 is less than one of 0.5");
}

void test_papers(void)
{
    RUN("every table and figure of the papers has rows that can be drawn, or says why not", papers_whole);
    RUN("what a paper says is judged by the figures of its rows", claims_judged);
}
