/* seeds_show.c - scenes by seed as text and CSV: what their rows say together. Declared in seeds_show.h. */
#include "lab/chart/seeds_show.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/measure/peers.h"

/* The scene with the most rows, whose order all have; -1: there is none. */
static int fullest(const seeds *s)
{
    int most = -1;
    for (int k = 0; k < s->count; ++k)
        if (s->row[k] && (most < 0 || s->rows[k] > s->rows[most])) most = k;
    return most;
}

static int same(const row *a, const row *b)
{
    return !strcmp(a->scene, b->scene) && !strcmp(a->label, b->label) && !strcmp(a->method, b->method)
        && !strcmp(a->settings, b->settings);
}

/* The row of every scene that is like one; NULL: a scene has none such. */
static void rows_like(const row *out[MOST_SEEDS], const seeds *s, const row *like)
{
    for (int k = 0; k < s->count; ++k) {
        out[k] = NULL;
        for (int i = 0; s->row[k] && i < s->rows[k] && !out[k]; ++i)
            if (same(&s->row[k][i], like)) out[k] = &s->row[k][i];
    }
}

/* The fit of one gain and exponent that is best over all scenes; -1: it is not a peer's row. */
static int fit_of_all(const row *const *rows, int count, const row *like)
{
    int best = -1;
    double least = HUGE_VAL;
    for (int fit = 0; fit < FITS && like->of & OF_PEER; ++fit) {
        double sum = 0;
        for (int k = 0; k < count; ++k)
            if (rows[k]) sum += rows[k]->figure[FIT + fit];
        if (!(sum < least)) continue;
        least = sum;
        best = fit;
    }
    return best;
}

/* ---- >>text ------------------------------------------------------------------------------------------------------ */

static void row_text(FILE *f, const seeds *s, const row *like)
{
    const row *rows[MOST_SEEDS];
    double share[MOST_SEEDS];
    char name[192];
    rows_like(rows, s, like);
    for (int k = 0; k < s->count; ++k) share[k] = rows[k] ? rows[k]->share : (double)NAN;
    const spread all = spread_of(share, s->count);
    snprintf(name, sizeof name, "%s%s%s", like->label, *like->settings ? " " : "", like->settings);
    fprintf(f, "%-10s %-48.48s %6.3f +- %5.3f  median %6.3f  worst %6.3f  %s\n", like->scene, name, all.mean, all.half,
            all.median, all.most, all.worst < 0 ? "" : s->place[all.worst].name);
}

void seeds_table_text(FILE *f, const seeds *s)
{
    const int first = fullest(s);
    int out = 0;
    if (first < 0) return;
    for (int k = 0; k < s->count; ++k) out += !s->row[k];
    fprintf(f, "\n%d scenes by seed: RMSE over that of no occlusion; %d left out for want of a package\n",
            s->count - out, out);
    for (int i = 0; i < s->rows[first]; ++i) row_text(f, s, &s->row[first][i]);
}

/* ---- >>csv ------------------------------------------------------------------------------------------------------- */

static void figure_csv(FILE *f, double v)
{
    if (isnan(v)) fputc(',', f);
    else fprintf(f, ",%.6g", v);
}

/* fit: of all scenes; -1: there is none. */
static void row_csv(FILE *f, const place *p, const row *r, int fit)
{
    const int is_lit = !(r->of & OF_AO), peer = (r->of & OF_PEER) != 0;
    fprintf(f, "%d,%s,%s,%s,\"%s\",\"%s\",\"%s\"", p->seed, p->set, p->kind, r->scene, r->label, r->method,
            r->settings);
    figure_csv(f, r->share);
    figure_csv(f, peer ? r->figure[FITTED] : (double)NAN);
    figure_csv(f, fit < 0 ? (double)NAN : r->figure[FIT + fit]);
    figure_csv(f, is_lit ? r->bias[strcmp(r->scene, "bounce") ? 1 : 2] : r->score.bias);
    for (int k = 0; k < NOISE_BANDS; ++k) figure_csv(f, 1e3 * r->figure[NOISE_BAND + k]);
    for (int k = 0; k < NOISE_BANDS; ++k) figure_csv(f, 1e3 * r->figure[ERROR_BAND + k]);
    fputc('\n', f);
}

void seeds_csv(FILE *f, const seeds *s)
{
    const int first = fullest(s);
    fputs("seed,set,kind,what,label,method,settings,share,fitted,fitted_all,bias,noise_1,noise_3,noise_8,noise_20,"
          "error_1,error_3,error_8,error_20\n",
          f);
    for (int i = 0; first >= 0 && i < s->rows[first]; ++i) {
        const row *rows[MOST_SEEDS], *like = &s->row[first][i];
        rows_like(rows, s, like);
        const int fit = fit_of_all(rows, s->count, like);
        for (int k = 0; k < s->count; ++k)
            if (rows[k]) row_csv(f, &s->place[k], rows[k], fit);
    }
}
