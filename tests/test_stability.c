/* test_stability.c - what `make stability` finds to hold must go on holding: its own sweeps, the quick values, a few
   methods each. */
#include "t.h"
#include "kit/kit_gl.h"
#include "lab/stability/sweep.h"
#include <string.h>

/* Numbers of a sweep's curves (methods, or what the curve is called) and their bounds; of what is seen beside them, "",
   at least that much is there to get wrong. */
static const struct bounded {
    const char *sentence, *cause;
    struct { const char *label; double least, most; } bound[5];
} bounds[] = {
    { "a bare plane stays open at any tilt", "tilt",
      { { "ssao", 0, 1e-4 }, { "hsao", 0, 1e-4 }, { "hsao-march", 0, 1e-4 }, { "ssdo", 0, 1e-4 } } },
    { "a pole far before a wall has no halo, however thin", "pole",
      { { "ssao", 0, 1e-4 }, { "hsao", 0, 1e-4 }, { "ssdo", 0, 1e-4 } } },
    { "a thin rail over a floor: how thin it is is seen", "rail",
      { { "", 0.2, 1 }, { "hsao", 0.02, 0.065 }, { "hsao-back", 0, 0.06 } } },
    { "halos of a screen end with the radius", "halo",
      { { "", 0.04, 1 }, { "hsao", 0, 0.04 }, { "hsao-back", 0, 0.02 }, { "hsao-march", 0, 0.025 } } },
    { "what has left the screen occludes as surfels, as a field", "off-screen",
      { { "", 0.15, 1 }, { "dss", 0, 0.09 }, { "aof", 0, 0.055 } } },
    { "what the near plane cuts occludes as surfels", "near-plane", { { "", 0.12, 1 }, { "dss", 0, 0.03 } } },
    { "24 bits of depth last to 50,000 near planes", "depth-24", { { "hsao", 5000, 1e5 }, { "ssao", 5000, 1e5 } } },
    { "reversed depth lasts to 800,000", "depth-reversed", { { "hsao", 8e4, 1e5 }, { "ssao", 8e4, 1e5 } } },
    { "a moving camera: little flicker at full size", "camera", { { "hsao-best", 0, 0.01 }, { "ssao", 0, 0.012 } } },
    { "a turning sun: light flickers no more than on open ground", "light",
      { { "", 1e-4, 0.01 }, { "ssdo", 0, 0.001 }, { "s3ho", 0, 0.001 } } },
    { "over frames: a moving camera errs as a single frame at most", "kept-camera",
      { { "hsao-fast-history", 0.5, 1 }, { "hsao-2x10-history", 0.5, 1.05 } } },
    { "over frames: what is newly seen errs as a single frame does", "kept-newly", { { "hsao-history", 0.5, 0.95 } } },
    { "over frames: what appears is seen at once", "kept-appear",
      { { "hsao-fast-history", 0.5, 1.06 }, { "hsao-2x10-history", 0.5, 1.06 } } },
    { "over frames: a box that leaves leaves no trail", "kept-trail-jump", { { "hsao-fast-history", 1e-4, 0.005 } } },
    { "over frames: few pixels hold what was", "kept-held-jump", { { "hsao-history", 1e-5, 0.001 } } },
    { "over frames: and with motion vectors", "kept-held-appear-told", { { "hsao-history", 1e-5, 0.001 } } },
    { "over frames: a box that slides errs as in single frames", "kept-slide",
      { { "hsao-history", 0.5, 1.05 }, { "hsao-2x10-history", 0.5, 1.08 } } },
    { "over frames: a moving camera flickers little", "kept-flicker",
      { { "", 1e-4, 0.01 }, { "hsao-history", 0, 0.004 }, { "hsao-2x10-history", 0, 0.002 } } },
    { "ringing: none with the positive window", "sh-shade",
      { { "4 bands", 0.05, 0.2 }, { "4 bands, Hann", 0, 0.03 }, { "4 bands, positive", 0, 1e-4 } } },
    { "through a field's hull occlusion has no step", "hull-steps", { { "as measured", 0, 0.06 } } }
};
static const struct bounded *now;

static void holds_still(void)
{
    static result r;
    sweep_options o = { .quick = 1 };
    kit_error err = { "" };
    int c = 0;
    while (c < sweeps_causes - 1 && strcmp(sweeps_cause[c].name, now->cause)) ++c;
    for (int i = 0; i < 5 && now->bound[i].label; ++i)
        for (int m = 0; m < sweeps_methods; ++m)
            if (!strcmp(sweeps_method[m].label, now->bound[i].label)) o.methods += o.method[m] = 1;
    cause fewer = sweeps_cause[c];             /* an error hardly sees the truth's noise: far below the bounds */
    if (fewer.kind != DEVIATION) fewer.rays /= 2;
    if (!CHECK(!sweep(&r, &fewer, &o, now->cause, &err), "%s", err.text)) return;
    for (int i = 0; i < 5 && now->bound[i].label; ++i) {
        const curve *found = NULL;
        for (int k = 0; k < r.curves; ++k)
            if (*now->bound[i].label ? !strcmp(r.curve[k].label, now->bound[i].label) : r.curve[k].method == BESIDE)
                found = &r.curve[k];
        if (!CHECK(found != NULL, "%s: there is no curve \"%s\"", now->cause, now->bound[i].label)) continue;
        CHECK(found->number >= now->bound[i].least && found->number <= now->bound[i].most,
              "%s: %.4g, at %g, is not in %g .. %g", found->label, found->number, found->at, now->bound[i].least,
              now->bound[i].most);
        t_note("%s: %.4g", found->label, found->number);
    }
    for (int k = 0; k < r.curves; ++k) kit_image_free(&r.curve[k].worst);
}

void test_stability(void)
{
    kit_error err = { "" };
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    for (size_t i = 0; i < sizeof bounds / sizeof *bounds; ++i) {
        now = &bounds[i];
        RUN(now->sentence, holds_still);
    }
    kit_fields_free();
    kit_gl_close();
}
