/* plan.c - makes chains of the plan's choices, and writes their costs in the plan's unit. Declared in plan.h. */
#include "lab/cost/plan.h"
#include "kit/kit_gl.h"
#include "lab/cost/show.h"

/* For each chain, the number of its choice. Chain 0 is the unit, and has none. */
static int choice[MOST_CHAINS];

int plan_add(work *w, kit_error *err)
{
    ssgi_plan_scene s = { .thickness = SSGI_PLAN_THICKNESS_SLABS, .history = 1, .surfels = 1, .map = 1 };
    if (work_add_chain(w, "ssao,directions=16,blur=0", err)) return -1;
    for (s.wanted = 0; s.wanted < SSGI_PLAN_WANTED_OBJECTS; ++s.wanted)
        for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
            ssgi_gl_chain chain;
            ssgi_plan p;
            char name[16];
            if (!ssgi_plan_choice(&p, i, &s) || p.method == SSGI_PLAN_METHOD_NOTHING) continue;
            snprintf(name, sizeof name, "%d", i);
            choice[w->chains] = i;
            if (kit_plan_chain(&chain, &p, s.wanted, err) || work_add(w, name, &chain, err)) return -1;
        }
    return 0;
}

void plan_write(FILE *f, const work *w)
{
    const double unit = chain_ms(w, &w->chain[0], 0, WEIGHED, &devices[0]), pixels = (double)WIDTH * HEIGHT;
    fprintf(f, "# modelled: %s, %dx%d, %s; make fit-cost\n", devices[0].name, WIDTH, HEIGHT, w->driver);
    for (int i = 1; i < w->chains; ++i) {
        const cost_chain *c = &w->chain[i];
        double ms = 0;
        for (int k = 0; k < c->passes; ++k) {
            const cost_pass *p = &c->pass[k];
            bound which;
            if (!p->vertices) ms += pass_ms(w, p, 0, WEIGHED, &devices[0], &which);
            else /* The plan adds splats by their number, which depends on the scene. */
                fprintf(f, "# %d: %.3g a texel of splats on each pixel, %.3g a surfel\n", choice[i],
                        splat_ms(w, p, 0, WEIGHED, &devices[0], pixels, 0, &which) / unit,
                        splat_ms(w, p, 0, WEIGHED, &devices[0], 1, pixels, &which) / unit);
        }
        if (c->passes) fprintf(f, "%d,%.3f\n", choice[i], ms / unit);
    }
}
