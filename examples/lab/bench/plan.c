/* plan.c - this machine's second column of the plan's costs. Declared in bench.h. */
#include "lab/bench/bench.h"
#include <string.h>

typedef struct choice {
    kit_method method;
    int number, rounds;
    double ratio[BENCH_PLAN_ROUNDS];
} choice;

static choice all[3 * SSGI_PLAN_CHOICES];
static int count;

int plan_choose(plan_costs *costs, int only, kit_error *err)
{
    ssgi_plan_scene s = { .thickness = SSGI_PLAN_THICKNESS_SLABS, .history = 1, .map = 1 };
    count = 0;
    for (s.wanted = 0; s.wanted < 3; ++s.wanted)
        for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
            char set[256];
            ssgi_plan p;
            if (only >= 0 && i != only) continue;
            if (!ssgi_plan_choice(&p, i, &s) || p.method == SSGI_PLAN_METHOD_NOTHING) continue;
            all[count].number = i;
            all[count].rounds = 0;
            if (kit_plan_method(&all[count].method, &p, s.wanted, err)) return -1;
            snprintf(costs->text[i], sizeof costs->text[i], "%s %.80s", kit_plan_text(set, &p, s.wanted), set);
            ++count;
        }
    return count ? 0 : kit_fail(err, "--plan %d: that choice is not one of a gather and its filters", only);
}

/* Draws an unblurred ssao, then the plan's choice, and notes the ratio of their times. */
static int compare(choice *c, const kit_method *unit, const place *p, double seconds, kit_error *err)
{
    timing of[2] = { { .frames = 0 }, { .frames = 0 } };
    if (rows_time(&of[0], unit, p, seconds, 0, err) || rows_time(&of[1], &c->method, p, seconds, 0, err)) return -1;
    c->ratio[c->rounds++] = kit_median(of[1].ms, of[1].frames) / kit_median(of[0].ms, of[0].frames);
    return 0;
}

int plan_measure(plan_costs *costs, const place *p, kit_error *err)
{
    kit_method unit;
    double longest = 0;
    if (kit_method_find(&unit, "ssao", err) || kit_method_set(&unit, "directions=16,blur=0", err)) return -1;
    for (int k = 0; k < BENCH_PLAN_ROUNDS && (!k || kit_seconds() + longest < p->end); ++k) {
        const double began = kit_seconds(), seconds = (p->end - began) / (4 * count * (BENCH_PLAN_ROUNDS - k));
        for (int i = 0; i < count; ++i) {
            if (compare(&all[i], &unit, p, seconds, err)) return -1;
            rows_progress(p->share / count);
        }
        longest = kit_seconds() - began;
    }
    for (int i = 0; i < count; ++i) costs->ratio[all[i].number] = kit_median(all[i].ratio, all[i].rounds);
    return 0;
}
