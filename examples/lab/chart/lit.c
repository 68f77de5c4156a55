/* lit.c - the sections on light: the demo's pictures, a chart, the effect of layers, cameras and points, and the effect
   of harmonics. Declared in chart.h. */
#include "lab/chart/chart.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

#define PINK  "3.3,0.9,1.9"
#define TURQUOISE "0.5,2.3,2.2"
#define LEFT_SUN(colour)  "sun:-1,0.8,0.35," colour
#define RIGHT_SUN(colour) "sun:1,0.8,0.35," colour

static const lit sun_and_sky = { "sky", { "sun:-1,0.45,0.85,4.4,3.9,3.3" }, 4, 1, 0, 256, 0.4f,
    { { 300, 129, 128, 72 } } };
static const lit sky_boxes   = { "sky", { NULL }, 4, 1, 0, 256, 1, { { 0 } } };
static const lit sky_alone   = { "sky", { NULL }, 0, 1, 0, 256, 1, { { 0 } } };
static const lit lamp        = { NULL, { "point:0,5,-2.8,10,10,10" }, 0, 1, 0, 128, 2, { { 115, 150, 128, 72 } } };
#define BETWEEN_BOXES { { 120, 123, 128, 72 }, { 260, 123, 128, 72 } }
static const lit two_suns    = { NULL, { LEFT_SUN(PINK), RIGHT_SUN(TURQUOISE) }, 0, 0, 1, 64, 0.7f, BETWEEN_BOXES };
static const lit suns_changed = { NULL, { LEFT_SUN(TURQUOISE), RIGHT_SUN(PINK) }, 0, 0, 1, 64, 0.7f, BETWEEN_BOXES };
static const lit yellow_sun  = { "sky", { "sun:1,0.7,0.2,5.5,4.6,2.0" }, 0, 0, 1, 128, 0.4f,
    { { 175, 193, 128, 72 }, { 293, 153, 128, 72 } } };
static const lit probe_alone = { "probe", { NULL }, 0, 0, 0, 2048, 1, { { 0 } } };
static const lit band_lits[] = {
    { "white", { NULL }, 0, 0, 0, 256, 1, { { 0 } } },
    { "sky",   { NULL }, 0, 0, 0, 256, 1, { { 0 } } },
    { NULL, { LEFT_SUN(PINK), RIGHT_SUN(TURQUOISE) }, 0, 0, 1, 256, 1, { { 0 } } },
    { NULL, { LEFT_SUN(PINK), RIGHT_SUN(TURQUOISE) }, 0, 0, 0, 2, 1, { { 0 } } },
    { "probe", { NULL }, 0, 0, 0, 1024, 1, { { 0 } } }
};

#define SCENE(name, scene, lit) &(const view){ name, scene, 0, { 0 }, { 0 }, 0, 0, lit }
#define BOXES(lit) &(const view){ "bunny", BUNNY, 1, { -0.1f, 1.1f, 4.4f }, { 0, -0.25f, 0 }, 32, 0.6f, lit }

/* Explains rows of directions=16,fade=none,range_check=0: they have 16 points, one on each direction, as the papers on
   point sampling have, so that all methods get the same visibility. */
#define LOCAL "Suns are local: blocked within the radius as the environment is, not by the whole scene."
enum { PROBE_STRIDE = 14, PHASES = 8 };
_Static_assert(ON_STRIDE(PROBE_STRIDE), "noise is probed where there is no truth");
static const set demos[] = {
    { "Light: a sky and a sun",
      "Bunny and four boxes under the built-in sky and a sun with shadows.",
      BOXES(&sun_and_sky), .rows = "lit-sun" },
    { "Light: one lamp, one bounce", "Open box under a point light with shadows, no environment.",
      SCENE("cornell", "cornell", &lamp), .rows = "lit-lamp" },
    { "Harmonics: two suns",
      "Three white boxes between a pink sun from the left and a turquoise one from the right. " LOCAL,
      SCENE("boxes", "boxes", &two_suns), .rows = "lit-harmonics" },
    { "Harmonics: the suns changed over", "The same boxes, turquoise from the left, pink from the right. " LOCAL,
      SCENE("boxes-changed", "boxes", &suns_changed), .rows = "lit-harmonics" },
    { "Harmonics: a sky and a bright sun",
      "White blocks under the built-in sky and a yellow sun from the right; below, their shadow side and their sunny "
      "side. " LOCAL,
      SCENE("blocks", "blocks", &yellow_sun), .rows = "lit-harmonics" }
};
static const set sets[] = {
    { "Light: speed against accuracy",
      "Bunny and four boxes under the sky, one bounce.",
      BOXES(&sky_boxes), .rows = "lit", .quick = 1, .kind = "light" },
    { "What light costs",
      "The same scene; 16 directions, no filter.",
      BOXES(&sky_boxes), .rows = "lit-cost" },
    { "What is hidden: columns",
      "Made to need more than one depth layer: coloured columns behind white ones, a box beside the picture.",
      SCENE("columns", "columns", &sky_alone), .rows = "lit-hidden" },
    { "What is hidden: plates", "Made to need more: thin plates, bars and hoops over a floor.",
      SCENE("plates", "plates", &sky_alone), .rows = "lit-hidden", .quick = 1 },
    { "What is hidden: room",
      "Not made for it: its walls, floor and ceiling are sheets, where layers and cameras want closed solids, and "
      "cameras stand outside.",
      SCENE("room", "room", &sky_alone), .rows = "lit-hidden" },
    { "What harmonics cost",
      "Bunny and four boxes under the sky, no filter but where it says so. Filtering vectors is filtering before they "
      "meet the light.",
      BOXES(&sky_boxes), .rows = "lit-vectors" },
    { "Under a high-contrast probe",
      "White blocks in a dim room with coloured windows and lamps, no bounce, no filter. Hue, in degrees: the mean "
      "angle between rgb vectors, weighted by the truth's luminance; and of that, what occluders keep 5 % or more of "
      "the light from.",
      SCENE("blocks-probe", "blocks", &probe_alone), .rows = "lit-probe", .quick = 1,
      .phases = PHASES },
    { "How many bands", "White: radiance 1 from everywhere.",
      SCENE("boxes-white", "boxes", &band_lits[0]), .rows = "lit-bands" },
    { NULL, "Sky: the built-in one.", SCENE("boxes-sky", "boxes", &band_lits[1]), .rows = "lit-bands" },
    { NULL, "Local suns: pink from the left, turquoise from the right. " LOCAL,
      SCENE("boxes-suns", "boxes", &band_lits[2]), .rows = "lit-bands" },
    { NULL, "Suns: the same pictures against the whole scene's sharp shadows.",
      SCENE("boxes-sharp", "boxes", &band_lits[3]), .rows = "lit-bands" },
    { NULL, "Probe: a dim room with coloured windows and lamps.",
      SCENE("boxes-probe", "boxes", &band_lits[4]), .rows = "lit-bands" }
};

/* ---- >>sections -------------------------------------------------------------------------------------------------- */

static int open(stage *s, const section *c, const set *t, kit_error *err)
{
    if (stage_load(s, t->see, err)) return -1;
    s->stride = c->stride;
    return stage_show(s, t->see, c->width, c->height, err);
}

static found demo_found[COUNT(demos)], chart_found[COUNT(sets)];
const section lit_demo = { .name = "lit", .sets = WITH_COUNT(demos), .width = 480, .height = 270, .rounds = 2,
                           .open = open, .probe_times = 4, .probe_stride = PROBE_STRIDE, .range = 0.2,
                           .crop_times = 4, .beside = 1, .found = demo_found };
const section lit_chart = { .name = "lit", .csv = "chart-lit.csv", .sets = WITH_COUNT(sets), .width = 320,
                            .height = 180, .stride = LIT_STRIDE, .rounds = CHART_ROUNDS, .open = open,
                            .probe_times = 4, .probe_stride = PROBE_STRIDE, .found = chart_found };
