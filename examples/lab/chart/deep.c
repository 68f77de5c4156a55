/* deep.c - the sections on deep screen space: the demo's pictures; the effect of surfel size, epsilon, levels and other
   choices. Declared in chart.h. */
#include "lab/chart/chart.h"
#include "lab/chart/deep_stage.h"

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
      SEEN OF_MARBLE, .rows = "deep-scatter" }
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
