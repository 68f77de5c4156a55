/* deep.c - the sections on deep screen space: the demo's pictures; the effect of surfel size, epsilon, levels and other
   choices; the time of each stage. Declared in chart.h. */
#include "lab/chart/chart.h"
#include "lab/chart/deep_stage.h"
#include "lab/measure/halved.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

#define DSS(label, settings, quick) { label, "dss", settings, quick }
/* A table of entries for figure 9 of the paper. Both settings have the same reach, radius sqrt(1 / epsilon - 1)
   2^(levels - 1): 16^2 (1/0.1 - 1) = 1/0.000433839 - 1. half: drawn at half the width and height, and enlarged. */
static const sized deep_figure9[] = {
    { DSS("5 levels", COARSE ",resolution=full,levels=5,epsilon=0.1", 1), 0 },
    { DSS("full size, 1 level", COARSE ",resolution=full,levels=1,epsilon=0.000433839", 1), 0 },
    { DSS("half size, 1 level", COARSE ",resolution=full,levels=1,epsilon=0.000433839", 1), 1 },
    { DSS("half size, 5 levels", COARSE ",resolution=full,levels=5,epsilon=0.1", 0), 1 }
};

typedef struct growth { const char *label, *settings; int width; } growth;
static const growth deep_growth[] = {
    { "surfels", "size=0.06", 320 },
    { "surfels", COARSE, 320 },
    { "surfels", "size=0.015", 320 },
    { "pixels", COARSE, 160 },
    { "pixels", COARSE, 320 },
    { "pixels", COARSE, 640 },
    { "levels", COARSE ",epsilon=0.1,levels=1", 320 },
    { "levels", COARSE ",epsilon=0.1,levels=2", 320 },
    { "levels", COARSE ",epsilon=0.1,levels=4", 320 },
    { "levels", COARSE ",epsilon=0.1,levels=6", 320 }
};

/* ---- >>own sets -------------------------------------------------------------------------------------------------- */

enum { DEEP_ROUNDS = 2, PAPER_SIDE = 512 };

static int full_sizes(FILE *record, const options *o, row *rows, kit_error *err)
{
    static const deep_view see = BUNNY_AO;
    stage s;
    if (deep_open(&s, &see, err)
        || halved_entries(rows, &s, deep_figure9, COUNT(deep_figure9), DEEP_ROUNDS, NULL, err)
        || section_about(record, &s, "Bunny on a floor.", 0, 0, err))
        return -1;
    (void)o;
    for (int i = 0; i < COUNT(deep_figure9); ++i) {
        rows[i].of = OF_DEEP;
        rows[i].scene = see.view.name;
    }
    stage_close(&s);
    return COUNT(deep_figure9);
}

/* Times the entries on one view, without a truth. Returns how many rows it filled. */
static int costs(row *rows, const deep_view *v, int width, int height, const entry *entries, int count, int of,
                 int rounds, kit_error *err)
{
    stage s;
    if (deep_load(&s, v, err) || stage_look(&s, &v->view, width, height, err)
        || measure_times(rows, &s, entries, count, rounds, err))
        return -1;
    for (int i = 0; i < count; ++i) {
        rows[i].of = of;
        rows[i].scene = v->view.name;
        rows[i].figure[PICTURE] = 1e-3 * s.frame.width * s.frame.height;
    }
    stage_close(&s);
    return count;
}

static int stages(FILE *record, const options *o, row *rows, kit_error *err)
{
    static const deep_view lights = WHOLE_LIGHT;
    (void)record;
    entry effects[MOST_ENTRIES];
    return costs(rows, &lights, PAPER_SIDE, PAPER_SIDE, effects, units_chosen(effects, "deep-effects", o), OF_STAGES, 1,
                 err);
}

static int grown(FILE *record, const options *o, row *rows, kit_error *err)
{
    static const deep_view see = BUNNY_AO;
    (void)record;
    (void)o;
    for (int i = 0; i < COUNT(deep_growth); ++i) {
        const growth *g = &deep_growth[i];
        const entry e = { g->label, "dss", g->settings, 1 };
        if (costs(&rows[i], &see, g->width, g->width * 9 / 16, &e, 1, OF_GROWTH, DEEP_ROUNDS, err) < 0) return -1;
    }
    return COUNT(deep_growth);
}

/* ---- >>sections -------------------------------------------------------------------------------------------------- */

#define SEEN &(const deep_view)
static const set demos[] = {
    { "Deep screen space: ambient occlusion",
      "Discs of all triangles, seen or not, take from the ambient light of the pixels around them. Bunny on a floor.",
      SEEN BUNNY_AO, .rows = "deep-demo" },
    { "Deep screen space: light",
      "Bunny and four boxes under the sky and a sun, one bounce; all within the radius counts whole. Surfels of 0.03.",
      SEEN WHOLE_LIGHT, .rows = "deep-demo-light" },
    { "Deep screen space: one specular bounce",
      "Open box under a point light, met by a lobe of exponent 8. No method in screen space does that here.",
      SEEN LOBE, .rows = "deep-demo-gloss" },
    { "Deep screen space: scattering under the surface",
      "A bunny of marble, 4 cm high, lit from behind. No method in screen space here does that. Truth: the dipole "
      "over samples on all of the mesh.",
      SEEN OF_MARBLE, .rows = "deep-demo-scatter" },
    { "Deep screen space: objects that the picture does not show",
      "Beside the picture: along its left side stands a wall, off the picture.",
      SEEN { { "off-screen", "plane", 0, { 0.15f, 0.9f, 2 }, { 1.2f, 0.1f, 0 }, 30, 0.6f, NULL },
             { { -0.2f, 0.001f, -4, 0, 1, 1.5f } },
             PLAINLY },
      .rows = "deep-demo-hidden" },
    { NULL,
      "Hidden: a box behind a screen.",
      SEEN { { "hidden", "plane", 0, { 0, 1, 4 }, { 0.15f, 0.15f, 0 }, 26, 0.6f, NULL },
             { { -0.75f, 0.001f, -0.4f, -0.02f, 0.6f, 0.2f }, { -1.2f, 0.001f, 1.2f, 0, 0.75f, 1.24f } },
             PLAINLY },
      .rows = "deep-demo-hidden" },
    { NULL,
      "At a grazing angle: the side of a box that occludes is seen edge-on.",
      SEEN { { "grazing", "plane", 0, { 0, 0.45f, 3.2f }, { 0.1f, 0.3f, 0 }, 24, 0.6f, NULL },
             { { -0.6f, 0.001f, -0.8f, 0, 0.7f, 0.4f } },
             PLAINLY },
      .rows = "deep-demo-hidden" }
};
static const set sets[] = {
    { "Deep screen space: speed against accuracy, bunny", "Bunny on a floor.",
      SEEN BUNNY_AO, .rows = "deep", .quick = 1, .kind = "scatter" },
    { "Deep screen space: speed against accuracy, room", "Room.",
      SEEN OWN_VIEW("room"), .rows = "deep", .kind = "scatter" },
    { "Deep screen space: epsilon and levels", "The paper's figure 8: epsilon and levels, surfels of 0.03.",
      SEEN BUNNY_AO, .rows = "deep-levels", .kind = "scatter" },
    { "Deep screen space: other choices", "Bunny on a floor, surfels of 0.03; one choice at a time.",
      SEEN BUNNY_AO, .rows = "deep-choices" },
    { "Deep screen space: light",
      "Bunny and four boxes under the sky and a sun, one bounce. In ssdo and its truth, hits within the radius "
      "have the weight 1 - t/radius.",
      SEEN FADING, .rows = "deep-ssdo", .quick = 1 },
    { NULL, "In dss-lit and its truth, all hits count in full.", SEEN WHOLE_LIGHT, .rows = "deep-light",
      .quick = 1 },
    { "Deep screen space: one specular bounce",
      "Open box under a point light, a lobe of exponent 8. Irradiance stands for the lobe's radiance.",
      SEEN LOBE, .rows = "deep-gloss" },
    { "Deep screen space: scattering",
      "A bunny of marble, 4 cm high, lit from behind. Irradiance stands for the radiance that leaves it.",
      SEEN OF_MARBLE, .rows = "deep-scatter" },
    { "Deep screen space: full size, half size",
      "The paper's figure 9: all reach as far; half sizes are brought to full size bilinearly, which is not in their "
      "times; their splats are of their own pixels.",
      .own = full_sizes },
    { "Deep screen space: the camera turns away",
      "A tall box on a plane leaves the picture while the camera turns to the right; the ground beside it stays, "
      "and is scored. White light from everywhere.",
      .quick = 1, .kind = "turn", .own = deep_turns },
    { "Deep screen space: the camera moves",
      "Bunny on a floor; camera and target move to the right by about a pixel a frame.", .own = deep_motion },
    { "Deep screen space: where the time goes",
      "The paper's test: bunny, floor and four boxes, some 69,000 triangles, 512 x 512 pixels (of a quick chart half "
      "as wide); surfels by tessellation, captured. Shares of one frame's time.",
      .quick = 1, .own = stages },
    { "Deep screen space: how costs grow", "Bunny on a floor; one thing grows at a time.", .own = grown }
};

/* Opens the stage of a set. The demo traces fewer samples than the chart for the truth of scattered light. */
static int open(stage *s, const section *c, const set *t, kit_error *err)
{
    if (deep_load(s, t->see, err)) return -1;
    if (s->otherwise.kind == SCATTER) s->rays = c->csv ? 4 * s->rays : s->rays / 2;
    if (s->lit) s->stride = c->stride;
    return stage_show(s, t->see, c->width, c->height, err);
}

static found demo_found[COUNT(demos)], chart_found[COUNT(sets)];
const section deep_demo = { .name = "deep", .sets = WITH_COUNT(demos), .width = DEEP_WIDTH, .height = DEEP_HEIGHT,
                            .rounds = 1, .of = { OF_DEEP, OF_DEEP_LIT }, .open = open, .range = 0.3,
                            .found = demo_found };
const section deep_chart = { .name = "deep", .csv = "chart-deep.csv", .method = "dss", .sets = WITH_COUNT(sets),
                             .width = DEEP_WIDTH, .height = DEEP_HEIGHT, .stride = LIT_STRIDE, .rounds = QUICK_ROUNDS,
                             .of = { OF_DEEP, OF_DEEP_LIT }, .open = open, .found = chart_found };
