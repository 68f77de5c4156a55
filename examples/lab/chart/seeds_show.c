/* seeds_show.c - scenes by seed as text and CSV: what their rows say together. Declared in seeds_show.h. */
#include "lab/chart/seeds_show.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/chart/seeds.h"

void seeds_name(char name[32], int seed)
{
    snprintf(name, 32, "%s-%d", kit_scene_kind(seed % KIT_KINDS, NULL), seed);
}

int seeds_lit(const row *r) { return (r->of & OF_LIT) != 0; }

static const char *kind_of(const seeds *s, int k) { return kit_scene_kind((s->first + k) % KIT_KINDS, NULL); }

/* A scene that was not left out; NULL: there is none. */
static const row *names_of(const seeds *s)
{
    for (int k = 0; k < s->count; ++k) if (s->row[k]) return s->row[k];
    return NULL;
}

/* The method comes first where the label does not tell it. */
static const char *settings_of(char out[160], const row *r)
{
    const int none = !strcmp(r->method, "none") || !strcmp(r->method, "floor"),
              told = none || !strcmp(r->label, r->method);
    snprintf(out, 160, "%s%s%s", told ? "" : r->method, told || !*r->settings ? "" : " ",
             told && !none && !*r->settings ? "defaults" : r->settings);
    return out;
}

/* ---- >>spread ---------------------------------------------------------------------------------------------------- */

/* The i-th row's shares over the scenes; less those of another row, where that is not below 0. */
static void shares(double *out, const seeds *s, int i, int less)
{
    for (int k = 0; k < s->count; ++k)
        out[k] = s->row[k] ? s->row[k][i].share - (less < 0 ? 0 : s->row[k][less].share) : (double)NAN;
}

static spread spread_of_row(const seeds *s, int i, int less)
{
    double share[MOST_SEEDS];
    shares(share, s, i, less);
    return spread_of(share, s->count);
}

static double mean_in(const seeds *s, int i, int kind)
{
    double share[MOST_SEEDS];
    int kinds[MOST_SEEDS];
    shares(share, s, i, -1);
    for (int k = 0; k < s->count; ++k) kinds[k] = (s->first + k) % KIT_KINDS;
    return spread_in(share, kinds, kind, s->count).mean;
}

/* The first row of light, and past the last. */
static int lit_from(const seeds *s)
{
    int i = 0;
    while (i < s->rows && !seeds_lit(&names_of(s)[i])) ++i;
    return i;
}

/* ---- >>text ------------------------------------------------------------------------------------------------------ */

static void head_text(FILE *f, int lit)
{
    fprintf(f, "%-32s %-40s %6s %6s %6s %6s %5s %3s", lit ? "light" : "ambient occlusion", "", "mean", "+-", "median",
            "worst", "seed", ">1");
    for (int k = 0; k < KIT_KINDS; ++k) fprintf(f, " %8s", kit_scene_kind(k, NULL));
    fputc('\n', f);
}

static void figure_text(FILE *f, int width, int digits, double v)
{
    if (isnan(v)) fprintf(f, " %*s", width, "-");
    else fprintf(f, " %*.*f", width, digits, v);
}

static void row_text(FILE *f, const seeds *s, int i)
{
    const row *r = &names_of(s)[i];
    const spread all = spread_of_row(s, i, -1);
    char text[160];
    fprintf(f, "%-32s %-40s", r->label, settings_of(text, r));
    figure_text(f, 6, 3, all.mean);
    figure_text(f, 6, 3, all.half);
    figure_text(f, 6, 3, all.median);
    figure_text(f, 6, 3, all.most);
    fprintf(f, " %5d %3d", s->first + all.worst, all.above);
    for (int k = 0; k < KIT_KINDS; ++k) figure_text(f, 8, 3, mean_in(s, i, k));
    fputc('\n', f);
}

static int left_out(const seeds *s)
{
    int n = 0;
    for (int k = 0; k < s->count; ++k) n += !s->row[k];
    return n;
}

void seeds_table_text(FILE *f, const seeds *s)
{
    if (!s->rows) return;
    fprintf(f, "\nscenes by seed, %d to %d: RMSE over that of no occlusion; %d left out for want of a package\n",
            s->first, s->first + s->count - 1, left_out(s));
    for (int i = 0; i < s->rows; ++i) {
        if (!i || i == lit_from(s)) head_text(f, i == lit_from(s));
        row_text(f, s, i);
    }
}

/* ---- >>csv ------------------------------------------------------------------------------------------------------- */

static void figure_csv(FILE *f, double v)
{
    if (isnan(v)) fputc(',', f);
    else fprintf(f, ",%.6g", v);
}

void seeds_csv(FILE *f, const seeds *s)
{
    fputs("seed,kind,what,label,method,settings,share,bias\n", f);
    for (int k = 0; k < s->count; ++k)
        for (int i = 0; i < s->rows && s->row[k]; ++i) {
            const row *r = &s->row[k][i];
            fprintf(f, "%d,%s,%s,\"%s\",%s,\"%s\"", s->first + k, kind_of(s, k), seeds_lit(r) ? "light" : "ao",
                    r->label, r->method, r->settings);
            figure_csv(f, r->share);
            figure_csv(f, seeds_lit(r) ? r->bias[1] : r->score.bias);
            fputc('\n', f);
        }
}
