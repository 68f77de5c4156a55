/* test_stability.c - results of `make stability` that must stay: its own sweeps at the quick values, of a few methods
   each, within the bounds in causes.csv: 15 % above what was measured, or 0.04 if that is a ratio to a single frame. */
#include "t.h"
#include "kit/kit_gl.h"
#include "lab/stability/sweep.h"
#include <string.h>

static const cause *now;

/* Checks that the number of a label's curve, or for "" of the reference beside methods, is in its bound. */
static void bounded(const result *r, const char *label, double least, double most)
{
    const curve *found = NULL;
    for (int k = 0; k < r->curves; ++k)
        if (*label ? !strcmp(r->curve[k].label, label) : r->curve[k].method == BESIDE) found = &r->curve[k];
    if (!CHECK(found != NULL, "%s: there is no curve \"%s\"", now->name, label)) return;
    CHECK(found->number >= least && found->number <= most, "%s: %.4g, at %g, is not in %g .. %g", found->label,
          found->number, found->at, least, most);
    t_note("%s: %.4g", found->label, found->number);
}

static void holds_still(void)
{
    enum { MOST_BOUNDS = 6 };

    static result r;
    struct { char label[32]; double least, most; } bound[MOST_BOUNDS] = { { "", 0, 0 } };
    sweep_options o = { .quick = 1 };
    kit_error err = { "" };
    int bounds = 0, used = 0;
    if (!CHECK(*now->holds && *now->bounds, "%s: has no bound", now->name)) return;
    for (const char *at = now->bounds; *at; at += used, at += *at == '|', ++bounds) {
        const int length = (int)strcspn(at, "=");
        if (!CHECK(bounds < MOST_BOUNDS
                       && sscanf(at + length, "=%lf,%lf%n", &bound[bounds].least, &bound[bounds].most, &used) == 2,
                   "%s: \"%s\" is no bound", now->name, at))
            return;
        snprintf(bound[bounds].label, sizeof bound->label, "%.*s", length, at);
        used += length;
        for (int m = 0; m < sweeps_methods; ++m)
            if (!strcmp(sweeps_method[m].label, bound[bounds].label)) o.methods += o.method[m] = 1;
    }
    cause fewer = *now;                        /* fewer rays, as noise hardly changes errors; of slow light one value */
    if (fewer.kind != DEVIATION) fewer.rays /= 2;
    if (fewer.kind == FOLLOWS && fewer.of & KEPT_LIGHT) fewer.value[0] = fewer.value[3], fewer.value[1] = 0;
    if (!CHECK(!sweep(&r, &fewer, &o, now->name, &err), "%s", err.text)) return;
    for (int i = 0; i < bounds; ++i) bounded(&r, bound[i].label, bound[i].least, bound[i].most);
}

void test_stability(void)
{
    kit_error err = { "" };
    sweeps_load();
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    for (now = sweeps_cause; now < sweeps_cause + sweeps_causes; ++now)
        RUN(*now->holds ? now->holds : now->name, holds_still);
    kit_fields_free();
    kit_gl_close();
}
