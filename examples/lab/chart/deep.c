/* deep.c - deep screen space: the demo's pictures; what size, epsilon, levels and the other choices buy; where the time
   goes. Declared in chart.h. */
#include "lab/chart/chart.h"
#include "lab/chart/deep_stage.h"
#include "lab/measure/halved.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

#define DSS(label, settings, quick) { label, "dss", settings, quick }
static const entry deep_ao[] = { /* rows of one label make one curve */
    { "ssao", "ssao", "samples=8", 0 },
    { "ssao", "ssao", "", 1 },
    { "hsao", "hsao-fast", "", 1 },
    { "hsao", "hsao", "", 1 },
    { "hsao", "hsao-best", "", 1 },
    { "dss", "dss-fast", "", 1 },
    { "dss", "dss", "", 1 },
    { "dss", "dss-best", "", 1 },
    DSS("dss, small surfels, far, at full size", "half=0,size=0.015,epsilon=0.1,levels=5,near_samples=4", 0),
    DSS("dss, epsilon 0.02, at full size", "half=0,epsilon=0.02", 0)
};
static const entry deep_figure8[] = {
    DSS("epsilon", COARSE ",half=0,levels=4,epsilon=0.2", 1),  DSS("epsilon", COARSE ",half=0,levels=4,epsilon=0.1", 1),
    DSS("epsilon", COARSE ",half=0,levels=4,epsilon=0.02", 1), DSS("levels", COARSE ",half=0,epsilon=0.1,levels=1", 0),
    DSS("levels", COARSE ",half=0,epsilon=0.1,levels=2", 1),   DSS("levels", COARSE ",half=0,epsilon=0.1,levels=6", 0)
};
static const entry deep_choices[] = {
    DSS("defaults", COARSE, 1),
    DSS("every triangle", COARSE ",keep_small=1", 0),
    DSS("no growth off screen: as published", COARSE ",offscreen_growth=0", 0),
    DSS("from the near plane on", COARSE ",near_depth=0", 0),
    DSS("near_samples: 4 points", COARSE ",near_samples=4", 0),
    DSS("full size", COARSE ",half=0", 0),
    DSS("corners move to the centroid: as published", COARSE ",overhang=centroid", 0),
    DSS("larger surfels on farther levels: as published", COARSE ",enlarge=1", 0),
    DSS("form factors add up: as published", COARSE ",combine=add", 0),
    DSS("no smoothing", COARSE ",smooth=0", 0),
    DSS("smoothing compares normals", COARSE ",filter_normals=1", 0),
    DSS("by tessellation", COARSE ",way=capture", 0),
    DSS("by geometry shader", COARSE ",way=direct", 0)
};
static const entry deep_lights[] = {
    { "dss-lit", "dss-lit", COARSE, 1 },
    { "dss-lit", "dss-lit", "", 0 },
    { "dss-lit, epsilon 0.02", "dss-lit", COARSE ",epsilon=0.02,levels=4", 0 },
    { "dss-lit, the sky on surfels that are hidden, too", "dss-lit", COARSE ",sky=1", 0 }
};
static const entry deep_ssdos[] = {
    { "ssdo", "ssdo-fast", "", 0 },
    { "ssdo", "ssdo", "", 1 },
    { "ssdo", "ssdo-best", "", 0 },
    { "ssdo, 4 cameras", "ssdo-points", "views=4", 0 }
};
static const entry deep_mirrors[] = {
    { "dss-gloss", "dss-gloss", "exponent=8,size=0.06", 0 },
    { "dss-gloss", "dss-gloss", "exponent=8,size=0.03", 0 },
    { "dss-gloss", "dss-gloss", "exponent=8", 1 },
    { "dss-gloss, epsilon 0.02", "dss-gloss", "exponent=8,size=0.03,epsilon=0.02", 0 }
};
static const entry deep_marbles[] = {
    { "dss-scatter", "dss-scatter", MARBLE, 1 },
    { "dss-scatter, 5 levels", "dss-scatter", MARBLE ",levels=5", 0 },
    { "dss-scatter, epsilon 0.1", "dss-scatter", MARBLE ",epsilon=0.1", 0 },
    { "dss-scatter, shares of triangles", "dss-scatter", MARBLE ",keep_small=0", 1 }
};
static const entry deep_two[]     = { { "hsao", "hsao", "", 1 }, { "dss", "dss", "", 1 } };
static const entry deep_lit[]     = { { "dss-lit", "dss-lit", "size=0.03", 1 } };
static const entry deep_mirror[]  = { { "dss-gloss", "dss-gloss", "exponent=8", 1 } };
static const entry deep_beside[]  = { { "hsao", "hsao", "", 1 }, { "dss", "dss", COARSE, 1 } };
static const entry deep_under[]   = { { "dss-scatter", "dss-scatter", MARBLE, 1 } };
static const entry deep_effects[] = {
    { "ambient occlusion", "dss", "way=capture", 1 },
    { "directional occlusion", "dss-lit", "way=capture,bounce=none", 1 },
    { "directional occlusion, a bounce", "dss-lit", "way=capture", 1 },
    { "one specular bounce", "dss-gloss", "way=capture", 1 },
    { "scattering", "dss-scatter", "way=capture," MARBLE, 1 }
};
/* The same reach, radius sqrt(1 / epsilon - 1) 2^(levels - 1): 16^2 (1/0.1 - 1) = 1/0.000433839 - 1. half: of the
   picture's width and height, brought to full size bilinearly. */
static const sized deep_figure9[] = {
    { DSS("5 levels", COARSE ",half=0,levels=5,epsilon=0.1", 1), 0 },
    { DSS("full size, 1 level", COARSE ",half=0,levels=1,epsilon=0.000433839", 1), 0 },
    { DSS("half size, 1 level", COARSE ",half=0,levels=1,epsilon=0.000433839", 1), 1 },
    { DSS("half size, 5 levels", COARSE ",half=0,levels=5,epsilon=0.1", 0), 1 }
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

/* Times alone, no truth: entries on one picture. How many rows. */
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
    return costs(rows, &lights, PAPER_SIDE, PAPER_SIDE, deep_effects, o->quick ? 1 : COUNT(deep_effects), OF_STAGES, 1,
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
      SEEN BUNNY_AO, .entries = WITH_COUNT(deep_two) },
    { "Deep screen space: light",
      "Bunny and four boxes under the sky and a sun, one bounce; all within the radius counts whole. Surfels of 0.03.",
      SEEN WHOLE_LIGHT, .entries = WITH_COUNT(deep_lit) },
    { "Deep screen space: one specular bounce",
      "Open box under a point light, met by a lobe of exponent 8. Nothing here does that in screen space.",
      SEEN LOBE, .entries = WITH_COUNT(deep_mirror) },
    { "Deep screen space: scattering under the surface",
      "A bunny of marble, 4 cm high, lit from behind. Nothing here does that in screen space. Truth: the dipole over "
      "samples on all of the mesh.",
      SEEN OF_MARBLE, .entries = WITH_COUNT(deep_under) },
    { "Deep screen space: what the picture does not show",
      "Beside the picture: along its left side stands a wall, off the picture.",
      SEEN { { "off-screen", "plane", 0, { 0.15f, 0.9f, 2 }, { 1.2f, 0.1f, 0 }, 30, 0.6f, NULL },
             { { -0.2f, 0.001f, -4, 0, 1, 1.5f } },
             PLAINLY },
      .entries = WITH_COUNT(deep_beside) },
    { NULL,
      "Hidden: a box behind a screen.",
      SEEN { { "hidden", "plane", 0, { 0, 1, 4 }, { 0.15f, 0.15f, 0 }, 26, 0.6f, NULL },
             { { -0.75f, 0.001f, -0.4f, -0.02f, 0.6f, 0.2f }, { -1.2f, 0.001f, 1.2f, 0, 0.75f, 1.24f } },
             PLAINLY },
      .entries = WITH_COUNT(deep_beside) },
    { NULL,
      "At grazing angle: of a box the side that occludes is seen edge-on.",
      SEEN { { "grazing", "plane", 0, { 0, 0.45f, 3.2f }, { 0.1f, 0.3f, 0 }, 24, 0.6f, NULL },
             { { -0.6f, 0.001f, -0.8f, 0, 0.7f, 0.4f } },
             PLAINLY },
      .entries = WITH_COUNT(deep_beside) }
};
static const set sets[] = {
    { "Deep screen space: speed against accuracy, bunny", "Bunny on a floor.",
      SEEN BUNNY_AO, .entries = WITH_COUNT(deep_ao), .quick = 1, .kind = "scatter" },
    { "Deep screen space: speed against accuracy, room", "Room.",
      SEEN OWN_VIEW("room"), .entries = WITH_COUNT(deep_ao), .kind = "scatter" },
    { "Deep screen space: epsilon and levels", "The paper's figure 8: epsilon and levels, surfels of 0.03.",
      SEEN BUNNY_AO, .entries = WITH_COUNT(deep_figure8), .kind = "scatter" },
    { "Deep screen space: other choices", "Bunny on a floor, surfels of 0.03; one choice at a time.",
      SEEN BUNNY_AO, .entries = WITH_COUNT(deep_choices) },
    { "Deep screen space: light",
      "Bunny and four boxes under the sky and a sun, one bounce. Of ssdo: what is within the radius weighted by "
      "1 - t/radius, in its truth, too.",
      SEEN FADING, .entries = WITH_COUNT(deep_ssdos), .quick = 1 },
    { NULL, "Of dss-lit: all whole, in its truth, too.", SEEN WHOLE_LIGHT, .entries = WITH_COUNT(deep_lights),
      .quick = 1 },
    { "Deep screen space: one specular bounce",
      "Open box under a point light, a lobe of exponent 8. Irradiance stands for the lobe's radiance.",
      SEEN LOBE, .entries = WITH_COUNT(deep_mirrors) },
    { "Deep screen space: scattering",
      "A bunny of marble, 4 cm high, lit from behind. Irradiance stands for the radiance that leaves it.",
      SEEN OF_MARBLE, .entries = WITH_COUNT(deep_marbles) },
    { "Deep screen space: full size, half size",
      "The paper's figure 9: all reach as far; half sizes are brought to full size bilinearly, which is not in their "
      "times; their splats are of their own pixels.",
      .own = full_sizes },
    { "Deep screen space: the camera turns away",
      "A tall box on a plane leaves the picture while the camera turns to the right; the ground beside it stays, and "
      "is what is scored. White light from everywhere.",
      .quick = 1, .kind = "turn", .own = deep_turns },
    { "Deep screen space: the camera moves",
      "Bunny on a floor; camera and target move to the right by about a pixel a frame.", .own = deep_motion },
    { "Deep screen space: where the time goes",
      "The paper's test: bunny, floor and four boxes, some 69,000 triangles, 512 x 512 pixels (of a quick chart half "
      "as wide); surfels by tessellation, captured. Shares of one frame's time.",
      .quick = 1, .own = stages },
    { "Deep screen space: what costs grow with", "Bunny on a floor; one thing grows at a time.", .own = grown }
};

/* The demo's truth of what scatters has fewer samples than the chart's. */
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
