/* read.c - reads the sheets from the csv beside this file. Declared in sheet.h. */
#include <stdlib.h>
#include <string.h>
#include "lab/measure/csv.h"
#include "lab/papers/sheet.h"

enum { MOST_OF_ALL = 512 };
static sheet sheets[MOST_SHEETS];
static paper_row rows[MOST_OF_ALL];
static claim claims[MOST_OF_ALL];

/* A line of a csv. */
typedef struct line { csv of; const char *file; int at; } line;
static line words = { .file = "words" }, views = { .file = "views" };

static void fault(const line *l, const char *key)
{
    if (!l->of.rows) fprintf(stderr, "report: " SHEET_FOLDER "/%s.csv: cannot be read, or has no rows\n", l->file);
    else
        fprintf(stderr, "report: " SHEET_FOLDER "/%s.csv, line %d: %s \"%s\"\n", l->file, l->at + 2, key,
                l->at < l->of.rows ? csv_text(&l->of, l->at, key) : "");
    exit(2);
}

static int find(line *l, const char *key, const char *text, size_t length)
{
    for (l->at = 0; l->at < l->of.rows; ++l->at) {
        const char *is = csv_text(&l->of, l->at, key);
        if (strlen(is) == length && !strncmp(is, text, length)) return 1;
    }
    return 0;
}

/* A cell, in which {word} is replaced, kept until the program ends; NULL: the cell is empty. */
static const char *text_of(const line *l, const char *key)
{
    const char *at = csv_text(&l->of, l->at, key), *end;
    char *out = NULL;
    size_t size;
    if (!*at) return NULL;
    FILE *f = open_memstream(&out, &size);
    for (; f && *at; ++at) {
        if (*at != '{') {
            fputc(*at, f);
            continue;
        }
        if (!(end = strchr(at, '}')) || !find(&words, "word", at + 1, (size_t)(end - at - 1))) fault(l, key);
        fputs(csv_text(&words.of, words.at, "text"), f);
        at = end;
    }
    if (!f || fclose(f)) fault(l, key);
    return out;
}

static int whole(const line *l, const char *key) { return atoi(csv_text(&l->of, l->at, key)); }
static float real(const line *l, const char *key) { return (float)atof(csv_text(&l->of, l->at, key)); }

/* Splits a cell at its bars. An empty part is NULL. The rest of out stays as it is. */
static void split(const line *l, const char *key, const char *out[MOST_HEADS])
{
    char *text = strdup(csv_text(&l->of, l->at, key));
    for (int k = 0; text && *text; ++k) {
        char *const part = strsep(&text, "|");
        if (k == MOST_HEADS) fault(l, key);
        out[k] = *part ? part : NULL;
    }
}

/* ---- >>views ----------------------------------------------------------------------------------------------------- */

static void vector(const line *l, const char *key, float v[3])
{
    const char *text = csv_text(&l->of, l->at, key);
    if (*text && sscanf(text, "%f %f %f", &v[0], &v[1], &v[2]) != 3) fault(l, key);
}

static void read_light(sheet *t, const line *l)
{
    const char *crop[MOST_HEADS] = { NULL };
    lit *is = &t->lit;
    is->env = text_of(l, "env");
    is->light[0] = text_of(l, "light");
    is->boxes = whole(l, "boxes");
    is->bounce = whole(l, "bounce");
    is->rays = whole(l, "rays");
    is->exposure = real(l, "exposure");
    split(l, "crops", crop);
    for (int k = 0; k < MOST_CROPS && crop[k]; ++k) {
        int *c = is->crop[k];
        if (sscanf(crop[k], "%d %d %d %d", &c[0], &c[1], &c[2], &c[3]) != 4) fault(l, "crops");
    }
    if (is->env || is->light[0]) t->see.lit = is;
}

static void read_view(sheet *t, const line *from)
{
    const char *name = text_of(from, "view"), *kind;
    line *l = &views;
    t->see = (view){ .name = name, .path = name, .radius = real(from, "radius") };
    if (!name || !find(l, "view", name, strlen(name))) return;
    t->see.path = text_of(l, "scene");
    if (!strcmp(t->see.path, "bunny")) t->see.path = BUNNY;
    t->see.ground = whole(l, "ground");
    t->see.fovy = real(l, "fovy");
    vector(l, "eye", t->see.eye);
    vector(l, "target", t->see.target);
    read_light(t, l);
    kind = csv_text(&l->of, l->at, "kind");
    t->otherwise = (otherwise){ whole(l, "hard"), !*kind ? 0 : *kind == 'g' ? GLOSS : SCATTER, real(l, "exponent"),
                                real(l, "unit"), text_of(l, "material") };
}

/* ---- >>sheets ---------------------------------------------------------------------------------------------------- */

/* The index of the name that equals the first length characters of text. */
static int one_of(const char *const *names, int count, const char *text, size_t length)
{
    int k = 0;
    while (k < count && (strlen(names[k]) != length || strncmp(names[k], text, length))) ++k;
    return k < count ? k : -1;
}

/* Reads columns as HEAD=QUANTITY.DIGITS; own-1 is the first column of the sheet's own. */
static void read_columns(sheet *t, const line *l)
{
    static const char *const names[] = { "time", "milliseconds", "overhead", "error", "bias", "bounce", "radiance",
                                         "noise", "bounce-noise", "model", "hue", "mean", "surfels", "rmse",
                                         "kilobytes", "seconds", "own-1", "own-2", "own-3", "own-4", "own-5", "own-6" };
    const char *is[MOST_HEADS] = { NULL };
    split(l, "columns", is);
    for (int k = 0; k < MOST_HEADS && is[k]; ++k) {
        const char *of = strrchr(is[k], '='), *digits = strrchr(is[k], '.');
        const int which = of && digits > of ? one_of(names, COUNT(names), of + 1, (size_t)(digits - of - 1)) : -1;
        if (which < 0) fault(l, "columns");
        t->column[k] = (column){ strndup(is[k], (size_t)(of - is[k])), which, atoi(digits + 1) };
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
    *p = (paper_row){ .what = text_of(l, "what"), .method = text_of(l, "method"), .note = text_of(l, "note"),
                      .reach = real(l, "reach"), .width = whole(l, "width"), .height = whole(l, "height"),
                      .base = whole(l, "base"), .ours = whole(l, "ours"), .half = whole(l, "half"),
                      .slow = whole(l, "slow") };
    if (p->method && !(p->settings = text_of(l, "settings"))) p->settings = "";
    split(l, "printed", p->printed);
}

static void read_claim(claim *c, const sheet *t, const line *l)
{
    const char *head = csv_text(&l->of, l->at, "column"), *beside = csv_text(&l->of, l->at, "beside");
    *c = (claim){ .says = text_of(l, "says"), .why = text_of(l, "why"), .row = whole(l, "row") - 1,
                  .beside = *beside ? atoi(beside) - 1 : ALONE, .unmodelled = text_of(l, "unmodelled") };
    while (c->column < MOST_HEADS && t->column[c->column].head && strcmp(t->column[c->column].head, head))
        ++c->column;
    if (c->column == MOST_HEADS || !t->column[c->column].head) fault(l, "column");
    if (sheet_rule(c, csv_text(&l->of, l->at, "rule"))) fault(l, "rule");
}

/* Whether a line belongs to a sheet. */
static int is_of(const line *l, const sheet *t)
{
    return !strcmp(csv_text(&l->of, l->at, "paper"), t->paper)
        && !strcmp(csv_text(&l->of, l->at, "figure"), t->name);
}

static void read_sheet(sheet *t, const line *l)
{
    static const char *const ways[] = { "pictures", "halves", "fields", "times", "passes", "stages", "rates", "crowd" };
    const char *way = csv_text(&l->of, l->at, "drawn");
    const int drawn_as = one_of(ways, COUNT(ways), way, strlen(way));
    if (drawn_as < 0) fault(l, "drawn");
    *t = (sheet){ .paper = text_of(l, "paper"), .name = text_of(l, "figure"), .title = text_of(l, "title"),
                  .theirs = text_of(l, "theirs"), .erratum = text_of(l, "erratum"), .ours = text_of(l, "ours"),
                  .drawn = (drawing)drawn_as, .width = whole(l, "width"), .height = whole(l, "height"),
                  .rays = whole(l, "rays"), .phases = whole(l, "phases"), .stride = whole(l, "stride"),
                  .pictured = whole(l, "pictured"), .truth = real(l, "truth") };
    split(l, "heads", t->head);
    read_columns(t, l);
    read_view(t, l);
}

/* Rows and claims stand in the order of the sheets. A line out of order belongs to no sheet. */
static void read_all(void)
{
    line s = { .file = "sheets" }, r = { .file = "rows" }, c = { .file = "claims" };
    line *const every[] = { &s, &r, &c, &words, &views };
    for (int i = 0; i < COUNT(every); ++i) {
        char name[16];
        snprintf(name, sizeof name, "%s.csv", every[i]->file);
        every[i]->of = csv_read_in(SHEET_FOLDER, name);
        if (!every[i]->of.rows || every[i]->of.rows > MOST_OF_ALL) fault(every[i], "");
    }
    for (; s.at < s.of.rows; ++s.at) {
        sheet *t = &sheets[s.at];
        if (s.at == MOST_SHEETS - 1) fault(&s, "paper");
        read_sheet(t, &s);
        t->rows = &rows[r.at];
        t->claims = &claims[c.at];
        for (; r.at < r.of.rows && is_of(&r, t) && t->count < MOST_PAPER_ROWS; ++r.at, ++t->count)
            read_row(&rows[r.at], &r);
        for (; c.at < c.of.rows && is_of(&c, t); ++c.at, ++t->claimed) read_claim(&claims[c.at], t, &c);
    }
    if (r.at < r.of.rows) fault(&r, "figure");
    if (c.at < c.of.rows) fault(&c, "figure");
}

const sheet *papers_sheet(int k)
{
    if (!sheets->paper) read_all();
    return k < MOST_SHEETS && sheets[k].paper ? &sheets[k] : NULL;
}
