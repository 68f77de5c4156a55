/* seeds.c - the page on scenes by seed: of seeds.csv each row's mean with its interval, median, worst, by kind; beside
   it the scenes of chart.csv and the seeds that settings were tuned on, of seeds-fit.csv. Declared in sections.h. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "kit/kit.h"
#include "lab/figures/sections.h"
#include "lab/measure/spread.h"

/* rows: of each scene, one scene after the other. */
typedef struct scenes { csv c; int rows, count; } scenes;

static scenes scenes_of(const char *name)
{
    scenes s = { .c = csv_read(name) };
    while (s.rows < s.c.rows && csv_same(&s.c, s.rows, 0, "seed")) ++s.rows;
    if (s.rows && !(s.c.rows % s.rows) && s.c.rows / s.rows <= MOST_SPREAD) s.count = s.c.rows / s.rows;
    return s;
}

static int seed_of(const scenes *s, int k) { return (int)csv_number(&s->c, k * s->rows, "seed"); }

/* The i-th row's shares; kind: of each scene. */
static void shares(double *share, int *kind, const scenes *s, int i)
{
    for (int k = 0; k < s->count; ++k) {
        share[k] = csv_number(&s->c, k * s->rows + i, "share");
        kind[k] = seed_of(s, k) % KIT_KINDS;
    }
}

static const char *kind_name(const scenes *s, int kind)
{
    for (int k = 0; k < s->count; ++k)
        if (seed_of(s, k) % KIT_KINDS == kind) return csv_text(&s->c, k * s->rows, "kind");
    return NULL;
}

/* Whether a row of another table is of the same method. */
static int same_row(const csv *a, int i, const csv *b, int j)
{
    static const char *const keys[] = { "label", "method", "settings" };
    for (int k = 0; k < 3; ++k) if (strcmp(csv_text(a, i, keys[k]), csv_text(b, j, keys[k]))) return 0;
    return 1;
}

/* The mean of a row's shares in another table; what: of that kind alone, NULL: where none are told apart. */
static double mean_beside(const csv *c, int i, const csv *beside, const char *what)
{
    double sum = 0;
    int n = 0;
    for (int j = 0; j < beside->rows; ++j) {
        if (!same_row(c, i, beside, j) || (what && strcmp(csv_text(beside, j, "what"), what))) continue;
        sum += csv_number(beside, j, "share");
        ++n;
    }
    return n ? sum / n : (double)NAN;
}

static void table_head(const markdown *m, const scenes *s, const char *beside, int fitted)
{
    int columns = 7 + fitted;
    fputs("| method | mean | median | worst, seed | above 1 |", m->file);
    for (int k = 0; k < KIT_KINDS; ++k)
        if (kind_name(s, k)) { fprintf(m->file, " %s |", kind_name(s, k)); ++columns; }
    fprintf(m->file, " %s | more by |%s\n", beside, fitted ? " tuned, more by |" : "");
    markdown_ruler(m, columns);
}

static void table_row(const markdown *m, const scenes *s, int i, const csv *beside, const csv *fit)
{
    double share[MOST_SPREAD];
    int kind[MOST_SPREAD];
    const char *what = csv_text(&s->c, i, "what");
    shares(share, kind, s, i);
    const spread all = spread_of(share, s->count);
    const double other = mean_beside(&s->c, i, beside, NULL);
    if (strcmp(csv_text(&s->c, i, "method"), "none")) markdown_settings(m, &s->c, i);
    else fprintf(m->file, "| %s |", csv_text(&s->c, i, "label"));
    fprintf(m->file, " %.3f", all.mean);
    if (!isnan(all.half)) fprintf(m->file, " &plusmn; %.3f", all.half);
    fprintf(m->file, " | %.3f | %.3f, %d | %d |", all.median, all.most, seed_of(s, all.worst < 0 ? 0 : all.worst),
            all.above);
    for (int k = 0; k < KIT_KINDS; ++k)
        if (kind_name(s, k)) markdown_number(m, spread_in(share, kind, k, s->count).mean, 3, 0);
    markdown_number(m, other, 3, 0);
    markdown_number(m, other - all.mean, 3, 1);
    if (fit->rows) markdown_number(m, mean_beside(&s->c, i, fit, what) - all.mean, 3, 1);
    fputc('\n', m->file);
}

/* Rows of a kind: "ao" or "light". */
static void table(const markdown *m, const scenes *s, const char *what, const char *beside_name, const csv *beside,
                  const csv *fit)
{
    table_head(m, s, beside_name, fit->rows > 0);
    for (int i = 0; i < s->rows; ++i)
        if (!strcmp(csv_text(&s->c, i, "what"), what) && !strstr(csv_text(&s->c, i, "label"), "noise"))
            table_row(m, s, i, beside, fit);
    for (int i = 0; i < s->rows; ++i) {
        double share[MOST_SPREAD];
        int kind[MOST_SPREAD];
        if (strcmp(csv_text(&s->c, i, "what"), what) || !strstr(csv_text(&s->c, i, "label"), "noise")) continue;
        shares(share, kind, s, i);
        const spread noise = spread_of(share, s->count);
        fprintf(m->file, "\nThe truth's own noise: a mean of %.3f, at most %.3f.\n", noise.mean, noise.most);
    }
}

void section_seeds(const markdown *m)
{
    const scenes s = scenes_of("seeds.csv");
    const csv ambient = csv_read("chart.csv"), pairs = csv_read("chart-pairs.csv"), fit = csv_read("seeds-fit.csv");
    char about[1024];
    if (!s.count || (m->full && m->seeds_run != 'f')) return;
    fputs("\n## Scenes by seed\n", m->file);
    snprintf(about, sizeof about,
             "%d scenes, seeds %d to %d, none picked by hand; seeds from 1000 on only report, settings are tuned on "
             "those below. Error over that of no occlusion: the mean with its 95 %% interval (1.96 standard errors), "
             "on how many scenes a method is worse than nothing; beside it the mean of the chart's scenes and what "
             "that is more by%s.",
             s.count, seed_of(&s, 0), seed_of(&s, s.count - 1),
             fit.rows ? "; tuned, more by: the mean of the seeds below 1000, less this one" : "");
    markdown_heading(m, "Ambient occlusion by seed", about, m->seeds_note);
    table(m, &s, "ao", "chart's", &ambient, &fit);
    if (!csv_any(&s.c, 0, s.rows, "what") || strcmp(csv_text(&s.c, s.rows - 1, "what"), "light")) return;
    markdown_heading(m, "Light by seed",
                     "Irradiance within the radius, no bounce, by the environment that the seed brings; beside it the "
                     "mean of the pairs of a scene and a probe.", m->seeds_note);
    table(m, &s, "light", "pairs'", &pairs, &fit);
}
