/* ambient.c - the pages on ambient occlusion, whose chart.csv has the same rows on every scene, and on light on every
   pair of a scene and a probe. Declared in sections.h. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "lab/figures/sections.h"

/* ---- >>scenes ---------------------------------------------------------------------------------------------------- */

enum { MOST_SCENES = 32 };
/* rows: of the first scene, which come first */
typedef struct scenes { csv c; const char *name[MOST_SCENES]; int count, rows; } scenes;

static scenes scenes_of(const char *file)
{
    scenes s = { .c = csv_read(file) };
    for (int i = 0; i < s.c.rows && s.count < MOST_SCENES; ++i)
        if (!i || !csv_same(&s.c, i, i - 1, "scene")) s.name[s.count++] = csv_text(&s.c, i, "scene");
    while (s.rows < s.c.rows && csv_same(&s.c, s.rows, 0, "scene")) ++s.rows;
    return s;
}

/* The row of the k-th scene that is as row is. */
static int row_on(const scenes *s, int k, int row)
{
    const csv *c = &s->c;
    for (int i = 0; i < c->rows; ++i)
        if (!strcmp(csv_text(c, i, "scene"), s->name[k]) && csv_same(c, i, row, "label")
            && csv_same(c, i, row, "method") && csv_same(c, i, row, "settings"))
            return i;
    return -1;
}

static double number_on(const scenes *s, int k, int row, const char *key)
{
    const int at = row_on(s, k, row);
    return at < 0 ? (double)NAN : csv_number(&s->c, at, key);
}

/* The mean over the scenes, without one, if it is named. NAN if a scene does not have it. */
static double mean_on(const scenes *s, int row, const char *key, const char *without)
{
    double sum = 0;
    int n = 0;
    for (int k = 0; k < s->count; ++k) {
        if (without && !strcmp(s->name[k], without)) continue;
        sum += number_on(s, k, row, key);
        ++n;
    }
    return sum / n;
}

/* The worst of the scenes, and which it is. */
static void worst_on(const markdown *m, const scenes *s, int row, const char *key)
{
    double worst = 0;
    int whose = -1;
    for (int k = 0; k < s->count; ++k) {
        const double v = number_on(s, k, row, key);
        if (v > worst) { worst = v; whose = k; }
    }
    if (whose < 0) fputs(" |", m->file);
    else fprintf(m->file, " %.3f, %s |", worst, s->name[whose]);
}

static int is_peer(const scenes *s, int row) { return *csv_text(&s->c, row, "share_fitted") != 0; }

static int has_peers(const scenes *s)
{
    for (int i = 0; i < s->rows; ++i) if (is_peer(s, i)) return 1;
    return 0;
}

/* ---- >>ambient occlusion ----------------------------------------------------------------------------------------- */

static void mean_table(const markdown *m, const scenes *s)
{
    static const struct { const char *key; int digits; const char *without; } shown[] = {
        { "fetches", 1, NULL }, { "bytes", 0, NULL }, { "relative_time", 2, NULL }, { "share", 3, NULL },
        { "share", 3, "plates" }, { "model_error", 3, NULL }, { "noise", 3, NULL }
    };
    markdown_heading(m, "Mean of the scenes",
                     "![Cost against error](pictures/chart.svg)\n\nNoise: deviation over two phases of it; model "
                     "error: RMSE of their mean.",
                     m->chart_note);
    fputs("| method | fetches | bytes | time | error | without `plates` | model error | noise |\n", m->file);
    markdown_ruler(m, 8);
    for (int i = 0; i < s->rows; ++i) {
        if (is_peer(s, i)) continue;
        markdown_settings(m, &s->c, i);
        for (size_t k = 0; k < sizeof shown / sizeof *shown; ++k)
            markdown_number(m, mean_on(s, i, shown[k].key, shown[k].without), shown[k].digits, 0);
        fputc('\n', m->file);
    }
}

/* Of the library's rows, or of others': key, scene by scene. */
static void scenes_table(const markdown *m, const scenes *s, int peers, const char *key)
{
    markdown_heading(m, peers ? "What others have: scene by scene, matched and fitted" : "Scene by scene: error", "",
                     m->chart_note);
    fputs(peers ? "| pass |" : "| method |", m->file);
    for (int k = 0; k < s->count; ++k) fprintf(m->file, " %s |", s->name[k]);
    fputc('\n', m->file);
    markdown_ruler(m, s->count + 1);
    for (int i = 0; i < s->rows; ++i) {
        if (is_peer(s, i) != peers) continue;
        markdown_settings(m, &s->c, i);
        for (int k = 0; k < s->count; ++k) markdown_number(m, number_on(s, k, i, key), 3, 0);
        fputc('\n', m->file);
    }
}

/* Which of ours stand beside others' passes. */
static int beside(const csv *c, int row)
{
    static const char *const of[][2] = { { "hsao-fast", "" }, { "hsao", "" }, { "hsao", "thickness=slabs" },
        { "hsao-history", "" } };
    for (size_t k = 0; k < sizeof of / sizeof *of; ++k)
        if (!strcmp(csv_text(c, row, "method"), of[k][0]) && !strcmp(csv_text(c, row, "settings"), of[k][1])) return 1;
    return 0;
}

static void others_table(const markdown *m, const scenes *s)
{
    markdown_heading(m, "What others have: mean of the scenes",
                     "Passes from npm, driven by their own code, denoisers included, the radius matched to ours and "
                     "the rest\nas it does best in a coarse sweep. Worst: of the scenes. Fitted: after the best gain "
                     "and power for each\npicture, with the truth in hand; ours, first, are raw.",
                     m->chart_note);
    fputs("| pass | fetches | time | raw | worst | fitted | worst |\n", m->file);
    markdown_ruler(m, 7);
    for (int peers = 0; peers < 2; ++peers)
        for (int i = 0; i < s->rows; ++i) {
            if (peers ? !is_peer(s, i) : !beside(&s->c, i)) continue;
            markdown_settings(m, &s->c, i);
            markdown_number(m, mean_on(s, i, "fetches", NULL), 1, 0);
            markdown_number(m, mean_on(s, i, "relative_time", NULL), 2, 0);
            markdown_number(m, mean_on(s, i, "share", NULL), 3, 0);
            worst_on(m, s, i, "share");
            markdown_number(m, peers ? mean_on(s, i, "share_fitted", NULL) : (double)NAN, 3, 0);
            worst_on(m, s, i, "share_fitted");
            fputc('\n', m->file);
        }
}

void section_ambient(const markdown *m)
{
    const scenes s = scenes_of("chart.csv");
    if (!s.count) return;
    mean_table(m, &s);
    scenes_table(m, &s, 0, "share");
    if (!has_peers(&s)) return;
    others_table(m, &s);
    scenes_table(m, &s, 1, "share_fitted");
}

/* ---- >>light ----------------------------------------------------------------------------------------------------- */

/* Light on every pair of a scene and a probe: a method's share of no occlusion's error over all of them. */
void section_pairs(const markdown *m)
{
    const csv c = csv_read("chart-pairs.csv");
    int block = 0;
    if (!c.rows) return;
    while (block < c.rows && csv_same(&c, block, 0, "scene") && csv_same(&c, block, 0, "probe")) ++block;
    if (c.rows % block) return;
    markdown_heading(m, "On every pair of a scene and a probe",
            "RMSE of irradiance over that of no occlusion, no bounce: the mean over the pairs, the worst of them, and "
            "how many are below 1, where a method is better than nothing.", m->chart_note);
    fputs("| method | mean | worst | | below 1 | time |\n|---|---|---|---|---|---|\n", m->file);
    for (int i = 0; i < block - 2; ++i) {           /* the last two: no occlusion, the truth's noise */
        double mean = 0, worst = 0, time = 0;
        int below = 0, whose = i;
        for (int row = i; row < c.rows; row += block) {
            const double share = csv_number(&c, row, "share");
            mean += share * block / c.rows;
            time += csv_number(&c, row, "relative_time") * block / c.rows;
            below += share < 1;
            if (share > worst) { worst = share; whose = row; }
        }
        if (strcmp(csv_text(&c, i, "method"), "none")) markdown_settings(m, &c, i);
        else fprintf(m->file, "| %s |", csv_text(&c, i, "label"));
        fprintf(m->file, " %.3f | %.3f | %s, %s | %d of %d |", mean, worst, csv_text(&c, whose, "scene"),
                csv_text(&c, whose, "probe"), below, c.rows / block);
        markdown_number(m, time, 2, 0);
        fputc('\n', m->file);
    }
    double noise = 0;
    for (int row = block - 1; row < c.rows; row += block) noise = fmax(noise, csv_number(&c, row, "irradiance"));
    fprintf(m->file, "\nThe truth's own noise is at most %.4f of the mean.\n", noise);
}
