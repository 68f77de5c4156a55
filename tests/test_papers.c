/* test_papers.c - the papers' tables and figures that make papers draws: that each is there, with rows that can be
   drawn, and that what a paper says is judged by its rows' figures. */
#include "t.h"
#include "kit/kit_gl.h"
#include "lab/papers/sheet.h"
#include <math.h>
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
    CHECK(p->ours >= 0 && p->ours <= t->count && p->ours != i + 1 && (!p->ours || t->rows[p->ours - 1].method),
          "%s %s, %s: row %d has the library's", t->paper, t->name, p->what, p->ours);
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
        "HSAO08 Figure 12", "HSAO08 Figure 14", "SSDO09 Table 1", "SSDO09 Figure 6", "SSDO09 Figure 7",
        "SSDO09 Figure 9", "SSDO09 Figure 10", "SSDO09 Figure 11", "SSDO09 Figure 12", "SSDO09 Figure 13",
        "SSDO09 Figure 14", "S3HO12 Table 1",
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

/* A statement holds within its range of a row's value over another's, of shares and of times alike, as they are shown;
   what the library has in the place of a published row is judged beside it. */
static void claims_judged(void)
{
    static const paper_row three[] = { { .what = "a", .method = "ssao" },
                                       { .what = "b", .method = "ssao", .base = 1, .ours = 3 },
                                       { .what = "c", .method = "ssao" } };
    static const claim says[] = { { "b errs less", LESS(0, 1, 0), NULL },
                                  { "b takes as long", ALIKE(1, 1, 0, 0.1), NULL },
                                  { "a fifth more", WITHIN(2, 1, ALONE, 19, 21), NULL },
                                  { "within a factor of two", ALIKE(1, 1, 0, 1), NULL },
                                  { "as printed", AS_PRINTED(2, 1, ALONE, 318), NULL } };
    static const sheet t = { .rows = WITH_COUNT(three), .claims = WITH_COUNT(says),
                             .column = { { "error", ERROR, 3 }, { "time", TIME, 2 }, { "+%", OVERHEAD, 0 } } };
    row rows[3];
    claim own;
    for (int i = 0; i < 3; ++i) rows[i] = row_blank(OF_AO, "", "", "", "");
    CHECK(sheet_holds(&t, &says[0], rows) == -1, "what was not drawn is judged");
    rows[0].share = 0.5;
    rows[1].share = 0.4;
    rows[0].relative = 1;
    rows[1].relative = 1.2;
    CHECK(sheet_holds(&t, &says[0], rows) == 1 && sheet_holds(&t, &says[1], rows) == 0
          && sheet_holds(&t, &says[2], rows) == 1, "0.4 beside 0.5, 1.2 beside 1: %d %d %d",
          sheet_holds(&t, &says[0], rows), sheet_holds(&t, &says[1], rows), sheet_holds(&t, &says[2], rows));
    rows[2].share = 0.49996;                           /* 0.500 is shown */
    CHECK(sheet_own(&own, &t, &says[0]) && own.a == 2 && own.b == 0 && sheet_holds(&t, &own, rows) == 0,
          "what the library has in b's place, 0.500, is less than 0.500");
    rows[1].error[1] = 0.6;                            /* of light: irradiance's */
    CHECK(sheet_holds(&t, &says[0], rows) == 0, "an error of 0.6 is less than one of 0.5");
    static const struct { double a, b; int twice, printed; } timed[] = {
        { 11.03, 5.25, 0, 0 }, { 10, 5.25, 1, 0 }, { 10, 19.9, 1, 0 }, { 10, 20, 0, 0 },
        { 14.1, 22.3, 1, 0 }, { 10, 31.1, 0, 0 }, { 10, 31.3, 0, 1 }, { 10, 57.6, 0, 1 }, { 10, 57.8, 0, 0 }
    };
    for (int i = 0; i < COUNT(timed); ++i) {           /* a factor of 1.5 about 318: 212 to 477 */
        rows[0].relative = timed[i].a;
        rows[1].relative = timed[i].b;
        CHECK(sheet_holds(&t, &says[3], rows) == timed[i].twice && sheet_holds(&t, &says[4], rows) == timed[i].printed,
              "%g beside %g: %d %d", timed[i].b, timed[i].a, sheet_holds(&t, &says[3], rows),
              sheet_holds(&t, &says[4], rows));
    }
}

/* "+%" is of the times beside it, not of a median of ratios. By hand: 65.0 / 45.3 = 1.435, 1.7 / 1.2 = 1.417. */
static void overhead_follows(void)
{
    static const paper_row two[] = { { .what = "a", .method = "ssao" }, { .what = "b", .method = "ssao", .base = 1 } };
    static const sheet by_ms = { .rows = WITH_COUNT(two),
                                 .column = { { "+%", OVERHEAD, 1 }, { "time", TIME, 1 }, { "ms", MILLISECONDS, 1 } } },
                       by_time = { .rows = WITH_COUNT(two), .column = { { "+%", OVERHEAD, 1 }, { "time", TIME, 1 } } },
                       alone = { .rows = WITH_COUNT(two), .column = { { "+%", OVERHEAD, 1 } } };
    row rows[2] = { row_blank(OF_AO, "", "", "", ""), row_blank(OF_AO, "", "", "", "") };
    rows[0].ms = 45.34;
    rows[1].ms = 64.96;
    rows[0].relative = 1.24;
    rows[1].relative = 1.66;
    const double got[] = { sheet_value(&by_ms, rows, 1, 0), sheet_value(&by_time, rows, 1, 0),
                           sheet_value(&alone, rows, 1, 0) };
    CHECK(fabs(got[0] - 43.5) < 1e-9 && fabs(got[1] - 41.7) < 1e-9 && fabs(got[2] - 33.9) < 1e-9
          && isnan(sheet_value(&by_ms, rows, 0, 0)),
          "+%% is %g by milliseconds, %g by shown times, %g by times", got[0], got[1], got[2]);
}

/* The sentence has the figures, what they come to, and the figure at which it would be otherwise. */
static void claims_told(void)
{
    static const paper_row three[] = { { .what = "a", .method = "ssao" }, { .what = "b", .method = "ssao", .ours = 3 },
                                       { .what = "c", .method = "ssao" } };
    static const sheet t = { .rows = WITH_COUNT(three), .column = { { "error", ERROR, 3 } } };
    static const struct { claim says; const char *told; } cases[] = {
        { { "S", LESS(0, 2, 0), NULL }, "S: agrees (0.383 beside 0.458: 0.836 of it; would not at 1 or more)" },
        { { "S", MUCH_LESS(0, 2, 0), "why" },
          "S: does not agree (0.383 beside 0.458: 0.836 of it; would below 0.7); why" },
        { { "S", ALIKE(0, 2, 0, 0.25), "why" },
          "S: agrees (0.383 beside 0.458: 0.836 of it; would not at 0.8 or less, nor at 1.25 or more)" },
        { { "S", AS_PRINTED(0, 2, ALONE, 0.9), NULL }, "S: does not agree (0.383; would between 0.6 and 1.35)" },
        { { "S", WITHIN(0, 2, ALONE, 0.1, NO_BOUND), NULL }, "S: agrees (0.383; would not at 0.1 or less)" },
        { { "S", WITHIN(0, 2, ALONE, 1234, NO_BOUND), NULL }, "S: does not agree (0.383; would above 1234)" },
        { { "S", LESS(0, 1, 0), "why" }, "S: does not agree (0.615 beside 0.458: 1.34 of it; would below 1); as the "
          "library has it, agrees (0.383 beside 0.458: 0.836 of it; would not at 1 or more); why" }
    };
    row rows[3];
    char out[SENTENCE];
    for (int i = 0; i < 3; ++i) rows[i] = row_blank(OF_AO, "", "", "", "");
    rows[0].share = 0.458;
    rows[1].share = 0.615;
    rows[2].share = 0.383;
    for (int i = 0; i < COUNT(cases); ++i)
        CHECK(!strcmp(show_claim(out, &t, &cases[i].says, rows), cases[i].told), "says: %s", out);
    rows[1] = row_blank(OF_AO, "", "", "", "");
    CHECK(strstr(show_claim(out, &t, &cases[6].says, rows), "not known"), "of a row that was not drawn: %s", out);
}

void test_papers(void)
{
    RUN("every table and figure of the papers has rows that can be drawn, or says why not", papers_whole);
    RUN("what a paper says is judged by the figures of its rows", claims_judged);
    RUN("added time is of the times that are shown beside it", overhead_follows);
    RUN("what a paper says is told with the figure at which it would be otherwise", claims_told);
}
