/* seeds_show.c - scenes by seed as text and pages: what their rows say together. Declared in seeds_show.h. */
#include "lab/chart/seeds_show.h"
#include <math.h>
#include <string.h>
#include "lab/page/table.h"

/* ---- >>spread ---------------------------------------------------------------------------------------------------- */

const char *seeds_kind(const seeds *s, int k)
{
    return k < s->count ? kit_scene_kind((s->first + k) % KIT_KINDS, NULL) : NULL;
}

const row *seeds_names(const seeds *s)
{
    for (int k = 0; k < s->count; ++k) if (s->row[k]) return s->row[k];
    return NULL;
}

int seeds_lit(const row *r) { return (r->of & OF_LIT) != 0; }

spread seeds_spread_in(const seeds *s, int i, int kind)
{
    double share[MOST_SEEDS];
    int kinds[MOST_SEEDS];
    for (int k = 0; k < s->count; ++k) {
        share[k] = s->row[k] ? s->row[k][i].share : (double)NAN;
        kinds[k] = (s->first + k) % KIT_KINDS;
    }
    return spread_in(share, kind < 0 ? NULL : kinds, kind, s->count);
}

spread seeds_spread(const seeds *s, int i) { return seeds_spread_in(s, i, -1); }

/* ---- >>text ------------------------------------------------------------------------------------------------------ */

static void head_text(FILE *f, int lit)
{
    fprintf(f, "%-32s %-30s %6s %6s %6s %6s %5s %3s", lit ? "light" : "ambient occlusion", "settings", "mean", "+-",
            "median", "worst", "seed", ">1");
    for (int k = 0; k < KIT_KINDS; ++k) fprintf(f, " %8s", kit_scene_kind(k, NULL));
    fputc('\n', f);
}

void seeds_table_text(FILE *f, const seeds *s)
{
    const row *names = seeds_names(s);
    int left_out = 0;
    for (int k = 0; k < s->count; ++k) left_out += !s->row[k];
    fprintf(f, "\nscenes by seed, %d to %d%s: RMSE over that of no occlusion\n", s->first, s->first + s->count - 1,
            left_out ? ", but those whose package is not there" : "");
    for (int i = 0; i < s->rows; ++i) {
        const row *r = &names[i];
        const spread all = seeds_spread(s, i);
        if (!i || seeds_lit(r) != seeds_lit(r - 1)) head_text(f, seeds_lit(r));
        fprintf(f, "%-32s %-30s %6.3f %6.3f %6.3f %6.3f %5d %3d", r->label, table_settings(r), all.mean, all.half,
                all.median, all.most, s->first + all.worst, all.above);
        for (int k = 0; k < KIT_KINDS; ++k) fprintf(f, " %8.3f", seeds_spread_in(s, i, k).mean);
        fputc('\n', f);
    }
}

/* ---- >>csv ------------------------------------------------------------------------------------------------------- */

void seeds_csv(FILE *f, const seeds *s)
{
    fputs("seed,kind,what,label,method,settings,share,bias,time\n", f);
    for (int k = 0; k < s->count; ++k)
        for (int i = 0; i < s->rows && s->row[k]; ++i) {
            const row *r = &s->row[k][i];
            fprintf(f, "%d,%s,%s,\"%s\",%s,\"%s\",%.6g,%.6g,\n", s->first + k, seeds_kind(s, k),
                    seeds_lit(r) ? "light" : "ao", r->label, r->method, r->settings, r->share,
                    seeds_lit(r) ? r->bias[1] : r->score.bias);
        }
}
