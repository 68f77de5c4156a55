/* lit.c - light: pictures for the demo, a chart, what layers, cameras and points buy, what harmonics buy. Declared in
   chart.h. */
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

static const entry sun_entries[] = {
    { "SSAO",             "ssao", "",            1 },
    { "SSDO",             "ssdo", "bounce=none", 1 },
    { "SSDO with bounce", "ssdo", "",            1 },
    { "SSDO with bounce, 4 cameras", "ssdo-points", "views=4", 1 }
};
static const entry lamp_entries[] = {
    { "no bounce", "ssdo", "bounce=none", 1 },
    { "bounce",    "ssdo", "",            1 }
};

/* 16 points each, one a direction, as the papers of point sampling have it: the same visibility for all methods. */
#define PLAIN "fade=none,range=0"

static const entry chart_entries[] = {       /* rows of one label make one curve; directions of 4 points */
    { "slices",              "ssdo-fast", "",                                       0 },
    { "slices",              "ssdo", "",                                            1 },
    { "slices",              "ssdo-best", "",                                       1 },
    { "slices, solid",       "ssdo", "thickness=solid",                                0 },
    { "slices, back faces",  "ssdo", "thickness=back",                                 1 },
    { "slices, two slabs",   "ssdo", "thickness=slabs",                                1 },
    { "slices, last frame",   "ssdo", "reuse=1",                                    1 },
    { "slices, last frame",   "ssdo", "reuse=1,margin=0.25",                        1 },
    { "1 layer",             "ssdo-points", "",                                     1 },
    { "1 layer",             "ssdo-points", "samples=16",                                  1 },
    { "1 layer, 1 point a direction", "ssdo-points", "samples=16,steps=1," PLAIN,          1 },
    { "2 layers",            "ssdo-points", "layers=2",                                    1 },
    { "4 cameras",           "ssdo-points", "views=4",                                     1 },
    { "harmonics, 1 layer",  "s3ho-points", "",                                     1 },
    { "harmonics, slices",   "s3ho-fast", "",                                       1 },
    { "harmonics, slices",   "s3ho", "",                                            1 },
    { "harmonics, slices",   "s3ho-best", "",                                       0 }
};
static const entry extension_entries[] = {
    { "slices",                              "ssdo", "",                               1 },
    { "slices, back faces",                  "ssdo", "thickness=back",                    1 },
    { "slices, two slabs",                   "ssdo", "thickness=slabs",                   1 },
    { "1 layer",                             "ssdo-points", "",                        1 },
    { "2 layers",                            "ssdo-points", "layers=2",                       1 },
    { "4 layers",                            "ssdo-points", "layers=4",                       1 },
    { "4 cameras",                           "ssdo-points", "views=4",                        1 },
    { "harmonics, slices",                   "s3ho", "",                               1 },
    { "harmonics, two slabs",                "s3ho", "thickness=slabs",                   1 },
    { "slices, a margin",                    "ssdo", "margin=0.25",                    1 },
    { "slices, last frame",                  "ssdo", "reuse=1",                        1 },
    { "slices, last frame, a margin",        "ssdo", "reuse=1,margin=0.25",            1 }
};
static const entry cost_entries[] = {
    { "ambient visibility", "ssao", "blur=0", 1 },
    { "harmonics", "ssdo-points", "samples=16,steps=1,environment=sh,residual=0,bounce=none,blur=0," PLAIN, 1 },
    { "map", "ssdo-points", "samples=16,steps=1,bounce=none,blur=0," PLAIN, 1 },
    { "map, bounce, of the last frame", "ssdo-points", "samples=16,steps=1,reuse=1,blur=0," PLAIN, 1 },
    { "harmonics, bounce, of the last frame", "ssdo-points",
      "samples=16,steps=1,environment=sh,residual=0,reuse=1,blur=0," PLAIN, 1 }
};

static const entry harmonics_entries[] = {
    { "SSAO",                      "ssao", "",                          1 },
    { "S3HO",                      "s3ho", "indirect=none",             1 },
    { "S3HO, suns not windowed",   "s3ho", "indirect=none,window=none", 1 }
};
static const entry probe_entries[] = {      /* the paper's two steps along a direction */
    { "S3HO",           "s3ho-points", "samples=16,steps=2,indirect=none,residual=0,blur=0," PLAIN, 1 },
    { "S3HO, residual",    "s3ho-points", "samples=16,steps=2,indirect=none,blur=0," PLAIN, 1 },
    { "SSDO, map",      "ssdo-points", "samples=16,steps=2,bounce=none,blur=0," PLAIN, 1 },
    { "SSBN, cone",     "ssbn-points", "samples=16,steps=2,blur=0," PLAIN, 1 },
    { "SSAO",           "ssao", "samples=16,steps=2,blur=0," PLAIN, 1 }
};
static const entry band_entries[] = {
    { "1 band, as published",  "s3ho-points", "bands=1,indirect=none,residual=0", 1 },
    { "2 bands, as published",  "s3ho-points", "bands=2,indirect=none,residual=0", 1 },
    { "3 bands, as published",  "s3ho-points", "bands=3,indirect=none,residual=0", 1 },
    { "4 bands, as published",  "s3ho-points", "bands=4,indirect=none,residual=0", 1 },
    { "1 band",  "s3ho-points", "bands=1,indirect=none", 1 },
    { "2 bands",  "s3ho-points", "bands=2,indirect=none", 1 },
    { "3 bands",  "s3ho-points", "bands=3,indirect=none", 1 },
    { "4 bands",  "s3ho-points", "bands=4,indirect=none", 1 }
};
static const entry vector_entries[] = {
    { "ambient visibility", "ssao", "samples=16,blur=0," PLAIN, 1 },
    { "cone", "ssbn-points", "samples=16,steps=2,blur=0," PLAIN, 1 },
    { "1 band", "s3ho-points", "bands=1,samples=16,steps=1,indirect=none,blur=0," PLAIN, 0 },
    { "2 bands", "s3ho-points", "bands=2,samples=16,steps=1,indirect=none,blur=0," PLAIN, 0 },
    { "3 bands", "s3ho-points", "bands=3,samples=16,steps=1,indirect=none,blur=0," PLAIN, 0 },
    { "4 bands", "s3ho-points", "bands=4,samples=16,steps=1,indirect=none,blur=0," PLAIN, 1 },
    { "4 bands", "s3ho-points", "bands=4,samples=16,steps=2,indirect=none,blur=0," PLAIN, 1 },
    { "4 bands, stored, then met", "s3ho-points",
      "samples=16,steps=2,indirect=none,filtered=coefficients,blur=0," PLAIN, 1 },
    { "4 bands, stored packed", "s3ho-points",
      "samples=16,steps=2,indirect=none,filtered=coefficients,store=packed,blur=0," PLAIN, 1 },
    { "4 bands, bounce in one", "s3ho-points", "samples=16,steps=2,indirect=joint,blur=0," PLAIN, 1 },
    { "4 bands, bounce apart", "s3ho-points", "samples=16,steps=2,indirect=apart,blur=0," PLAIN, 0 }
};

#define LOCAL "Suns are local: blocked within the radius as the environment is, not by the whole scene."
enum { PROBE_STRIDE = 14, PHASES = 8 };
_Static_assert(ON_STRIDE(PROBE_STRIDE), "noise is probed where there is no truth");
static const set demos[] = {
    { "Light: a sky and a sun",
      "Bunny and four boxes under the built-in sky and a sun with shadows.",
      BOXES(&sun_and_sky), .entries = WITH_COUNT(sun_entries) },
    { "Light: one lamp, one bounce", "Open box under a point light with shadows, no environment.",
      SCENE("cornell", "cornell", &lamp), .entries = WITH_COUNT(lamp_entries) },
    { "Harmonics: two suns",
      "Three white boxes between a pink sun from the left and a turquoise one from the right. " LOCAL,
      SCENE("boxes", "boxes", &two_suns), .entries = WITH_COUNT(harmonics_entries) },
    { "Harmonics: the suns changed over", "The same boxes, turquoise from the left, pink from the right. " LOCAL,
      SCENE("boxes-changed", "boxes", &suns_changed), .entries = WITH_COUNT(harmonics_entries) },
    { "Harmonics: a sky and a bright sun",
      "White blocks under the built-in sky and a yellow sun from the right; below, their shadow side and their sunny "
      "side. " LOCAL,
      SCENE("blocks", "blocks", &yellow_sun), .entries = WITH_COUNT(harmonics_entries) }
};
static const set sets[] = {
    { "Light: speed against accuracy",
      "Bunny and four boxes under the sky, one bounce.",
      BOXES(&sky_boxes), .entries = WITH_COUNT(chart_entries), .quick = 1, .kind = "light" },
    { "What light costs",
      "The same scene; 16 directions, no filter.",
      BOXES(&sky_boxes), .entries = WITH_COUNT(cost_entries) },
    { "What is hidden: columns",
      "Made to need more than one depth layer: coloured columns behind white ones, a box beside the picture.",
      SCENE("columns", "columns", &sky_alone), .entries = WITH_COUNT(extension_entries) },
    { "What is hidden: plates", "Made to need more: thin plates, bars and hoops over a floor.",
      SCENE("plates", "plates", &sky_alone), .entries = WITH_COUNT(extension_entries), .quick = 1 },
    { "What is hidden: room",
      "Not made for it: its walls, floor and ceiling are sheets, where layers and cameras want closed solids, and "
      "cameras stand outside.",
      SCENE("room", "room", &sky_alone), .entries = WITH_COUNT(extension_entries) },
    { "What harmonics cost",
      "Bunny and four boxes under the sky, no filter but where it says so. Filtering vectors is filtering before they "
      "meet the light.",
      BOXES(&sky_boxes), .entries = WITH_COUNT(vector_entries) },
    { "Under a high-contrast probe",
      "White blocks in a dim room with coloured windows and lamps, no bounce, no filter. Hue, in degrees: the mean "
      "angle between rgb vectors, weighted by the truth's luminance; and of that, what occluders keep 5 % or more of "
      "the light from.",
      SCENE("blocks-probe", "blocks", &probe_alone), .entries = WITH_COUNT(probe_entries), .quick = 1,
      .phases = PHASES },
    { "How many bands", "White: radiance 1 from everywhere.",
      SCENE("boxes-white", "boxes", &band_lits[0]), .entries = WITH_COUNT(band_entries) },
    { NULL, "Sky: the built-in one.", SCENE("boxes-sky", "boxes", &band_lits[1]), .entries = WITH_COUNT(band_entries) },
    { NULL, "Local suns: pink from the left, turquoise from the right. " LOCAL,
      SCENE("boxes-suns", "boxes", &band_lits[2]), .entries = WITH_COUNT(band_entries) },
    { NULL, "Suns: the same pictures against the whole scene's sharp shadows.",
      SCENE("boxes-sharp", "boxes", &band_lits[3]), .entries = WITH_COUNT(band_entries) },
    { NULL, "Probe: a dim room with coloured windows and lamps.",
      SCENE("boxes-probe", "boxes", &band_lits[4]), .entries = WITH_COUNT(band_entries) }
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
