/* clock.c - times drawing, beside a reference that is drawn in the same rounds. Declared in clock.h. */
#include "lab/measure/clock.h"
#include <math.h>
#include <stdlib.h>

const entry clock_reference = { "ssao, no blur", "ssao", "directions=16,blur=0", 1 };

/* Each row is timed in LEAST_ROUNDS, and no more if it takes SLOW times the reference's time, or its ratios agree. */
enum { LEAST_ROUNDS = 2, SLOW = 5 };
#define AGREED 0.05

double clock_draw(kit_run *run)
{
    kit_run_draw(run, 1);
    return kit_run_ms(run);
}

/* Counts surfels and splats of deep screen space, and writes each stage's share of the last draw's time. */
static void count_surfels(row *r, const kit_run *run)
{
    const double all = kit_run_ms(run);
    r->figure[SURFELS] = (double)run->surfels;
    r->figure[SPLATS] = run->splat_pixels / ((double)run->gbuffer->viewport[2] * run->gbuffer->viewport[3]);
    for (int k = 0; k < STAGES; ++k) r->figure[STAGE + k] = 0;
    for (int i = 0; i < run->passes; ++i) {
        const int at = run->pass[i].desc.pass - SSGI_GL_PASS_SURFELS;
        r->figure[STAGE + (at >= 0 && at < STAGES - 1 ? at : STAGES - 1)] += run->pass[i].ms / all;
    }
}

/* Returns whether all ratios of a row's time to the reference's lie within AGREED of the smallest one. */
static int agreed(const double *ratio, int count)
{
    double least = ratio[0], most = ratio[0];
    for (int k = 1; k < count; ++k) {
        least = fmin(least, ratio[k]);
        most = fmax(most, ratio[k]);
    }
    return most < (1 + AGREED) * least;
}

int clock_all(row *rows, stage *s, double (*once)(void *of, int i), void *of, int count, int rounds, kit_error *err)
{
    double *ratio = calloc((size_t)(2 * count * rounds), sizeof *ratio), *ms = ratio + count * rounds, before, after;
    int *drawn = calloc((size_t)count, sizeof *drawn);
    kit_run fixed;
    char what[128];
    int failed = ratio && drawn
                     ? stage_run(&fixed, s, clock_reference.method, clock_reference.settings, s->radius, err)
                     : kit_fail(err, "out of memory");
    if (failed) { free(ratio); free(drawn); return -1; }
    const double began = kit_seconds();
    do kit_run_draw(&fixed, 1);                             /* draws until a GPU runs at its full clock */
    while (!kit_gl_is_software() && kit_seconds() < began + 0.3);
    snprintf(what, sizeof what, "%s: times", s->name);
    kit_progress(what, 0);
    for (int k = 0; k < rounds; ++k) {
        before = clock_draw(&fixed);
        for (int i = 0; i < count; ++i) {
            double *const r = ratio + i * rounds, *const t = ms + i * rounds;
            if (k >= LEAST_ROUNDS && (t[0] > SLOW * before || agreed(r, drawn[i]))) continue;
            t[drawn[i]] = once(of, i);
            after = clock_draw(&fixed);
            r[drawn[i]] = t[drawn[i]] / (0.5 * (before + after));
            ++drawn[i];
            before = after;
            kit_progress(what, (k * count + i + 0.99) / (rounds * count));
        }
    }
    kit_progress(what, 1);
    for (int i = 0; i < count; ++i) {
        rows[i].relative = kit_median(ratio + i * rounds, drawn[i]);
        rows[i].ms = kit_median(ms + i * rounds, drawn[i]);
    }
    free(drawn);
    kit_run_close(&fixed);
    free(ratio);
    return 0;
}

typedef struct runs { stage *s; kit_run *run; } runs;

static double run_once(void *of, int i)
{
    const runs *all = of;
    return clock_draw(&all->run[i]) + (all->s->lit && !all->run[i].lit ? clock_draw(&all->s->lights) : 0);
}

int clock_runs(row *rows, stage *s, kit_run *run, int count, int rounds, kit_error *err)
{
    runs all = { s, run };
    if (clock_all(rows, s, run_once, &all, count, rounds, err)) return -1;
    for (int i = 0; i < count; ++i) {
        rows[i].bytes = run[i].bytes + (s->lit && !run[i].lit ? s->lights.bytes : 0);
        if (run[i].surfels) count_surfels(&rows[i], &run[i]);
        kit_run_close(&run[i]);
    }
    return 0;
}
