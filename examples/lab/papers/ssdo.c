/* ssdo.c - the tables and figures of [SSDO09]. Declared in sheet.h. */
#include "lab/papers/sheet.h"

#define GEFORCE "GeForce 8800 GTX"
/* the paper's points: one a direction, whatever stands behind a surface counts */
#define PLAIN "fade=none,range=0"
/* as published: directions evenly spread, a tile of 4x4 sets, a point a direction, the bounce by patches */
#define SETS "uniform=1,sets=16"
#define PATCHES SETS ",samples=16,steps=1,range=0,bounce=patch"
/* its blur, which heeds the geometry */
#define BLURRED ",blur=2,filter_normals=1"
#define OUR_POINTS "samples=16,steps=2"

/* ---- >>Table 1 --------------------------------------------------------------------------------------------------- */

/* Half of the paper's width and height. */
#define SSAO_AT(w, h, size, n, fps) { .slow = w == 600, .what = size ", N = " #n ", SSAO", .printed = { fps }, \
      .method = "ssao", .settings = "samples=" #n ",blur=0," SETS "," PLAIN, .width = w, .height = h }
#define SSDO_AT(w, h, size, n, row, fps, printed_, time) { .slow = w == 600, .what = size ", N = " #n ", SSDO", \
      .printed = { fps, printed_, time }, .method = "ssdo-points", \
      .settings = "samples=" #n ",steps=1,bounce=none,blur=0," SETS "," PLAIN, .width = w, .height = h, .base = row }
#define BOUNCE_AT(w, h, size, n, row, fps, printed_, time) { .slow = w == 600, \
      .what = size ", N = " #n ", with a bounce", \
      .printed = { fps, printed_, time }, .method = "ssdo-points", \
      .settings = "samples=" #n ",steps=1,bounce=patch,blur=0," SETS "," PLAIN, .width = w, .height = h, .base = row }
#define THREE(w, h, size, n, row, ssao, ssdo, lost, time, bounce, bounce_lost, bounce_time) \
    SSAO_AT(w, h, size, n, ssao), SSDO_AT(w, h, size, n, row, ssdo, lost, time), \
    BOUNCE_AT(w, h, size, n, row, bounce, bounce_lost, bounce_time)
static const paper_row time_rows[] = {
    THREE(512, 384, "1024x768", 8, 1, "81.0", "81.3", "0.2", "-0.4", "65.8", "19.3", "23.1"),
    THREE(512, 384, "1024x768", 16, 4, "58.0", "56.5", "2.6", "2.7", "40.5", "30.2", "43.2"),
    THREE(600, 480, "1200x960", 8, 7, "37.7", "37.5", "0.5", "0.5", "25.5", "32.4", "47.8"),
    THREE(600, 480, "1200x960", 16, 10, "25.4", "23.6", "7.1", "7.6", "14.7", "22.2", "72.8"),
    THREE(800, 600, "1600x1200", 8, 13, "24.8", "24.2", "2.4", "2.5", "15.9", "35.9", "56.0"),
    THREE(800, 600, "1600x1200", 16, 16, "16.8", "15.3", "8.9", "9.8", "9.0", "46.4", "86.7"),
    { .what = "1600x1200, N = 16, SSDO, by harmonics", .method = "ssdo-points",
      .settings = "samples=16,steps=1,environment=sh,residual=0,bounce=none,blur=0," PLAIN, .width = 800, .height = 600,
      .base = 16 },
    { .what = "average of the six, SSDO", .printed = { NULL, "3.6", "3.8" }, .method = "ssdo-points",
      .settings = "bounce=none" },
    { .what = "average of the six, with a bounce", .printed = { NULL, "31.1", "54.9" }, .method = "ssdo-points",
      .settings = "bounce=patch" }
};
enum { AVERAGES = 2 };
#define GEOMETRY "the paper's frames hold 8 ms of geometry, and its shader waits for memory"
#define BOUNCE(row, size, n, more) { "With a bounce, " size ", N = " #n ": " #more " % beyond SSAO", \
      AS_PRINTED(1, row, ALONE, more), GEOMETRY }
static const claim time_claims[] = {
    { "Directional occlusion adds little to SSAO: 10 % of its time at most (1600x1200, 16 samples)",
      LITTLE_MORE(0, 16, 15),
      "a look-up of the environment a direction is not small beside one depth fetch; " GEOMETRY },
    { "nor does it by harmonics", LITTLE_MORE(0, 18, 15), "their sum is arithmetic, which a CPU does not hide behind "
      "fetches" },
    { "On average it loses 3.6 % of the frames", AS_PRINTED(2, 19, ALONE, 3.6), GEOMETRY },
    { "and 31.1 % with a bounce", AS_PRINTED(2, 20, ALONE, 31.1), GEOMETRY },
    BOUNCE(2, "1024x768", 8, 23), BOUNCE(5, "1024x768", 16, 43), BOUNCE(8, "1200x960", 8, 48),
    BOUNCE(11, "1200x960", 16, 73), BOUNCE(14, "1600x1200", 8, 56), BOUNCE(17, "1600x1200", 16, 87),
    { "16 samples take 1.6 times as long as 8 (SSDO, 1600x1200)", AS_PRINTED(0, 16, 13, 1.58), NULL },
    { "The time follows the pixels: 2.4 times as many (SSDO, 16 samples) take 3.7 times as long",
      AS_PRINTED(0, 16, 4, 3.69), "the paper's grows faster than its pixels do" }
};

/* And averages: of the six the mean of what is lost, as the paper forms it. */
static int frame_rates(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    sheet sizes = *t;
    sizes.count -= AVERAGES;
    sheet_blank(t, rows);
    if (sheet_times(record, o, &sizes, rows, err)) return -1;
    for (int k = 0; k < AVERAGES; ++k) {
        double sum = 0;
        int known = 0;
        for (int i = 1 + k; i < 18; i += 3) {
            double *const lost = &rows[i].figure[STAGE];
            *lost = 100 * (1 - rows[t->rows[i].base - 1].ms / rows[i].ms);
            if (!isnan(*lost)) { sum += *lost; ++known; }
        }
        rows[sizes.count + k].figure[STAGE] = sum / known;
    }
    return 0;
}

static const lit sky_alone = { "sky", { NULL }, 4, 1, 0, 64, 1, NO_CROPS };
#define BOXES_VIEW(name, radius, lit) \
    { { name, BUNNY, 1, { -0.1f, 1.1f, 4.4f }, { 0, -0.25f, 0 }, 32, radius, lit }, NO_BOX, PLAINLY }
static const sheet time_sheet = {
    .paper = "SSDO09", .name = "Table 1", .title = "frame rates of SSAO, SSDO and SSDO with a bounce",
    .theirs = "Frames a second, the factory of figure 1, 537,000 triangles, " GEFORCE ", one camera, one layer; the "
              "scene alone runs at 124. The last of the printed columns is worked out from the frame rates; the "
              "averages are section 6's.",
    .erratum = "\"+%\" is the loss of frames, not added time: 16.8 to 9.0 is 87 % more time, printed as 46.4. At "
               "1200x960 with 16 samples 22.2 should be 42.1; and the first row has SSDO faster than SSAO.",
    .ours = "Bunny and four boxes under the sky, half the widths and heights, evenly spread directions in 4x4 sets, no "
            "filter; SSAO by ambient visibility alone, SSDO by a look-up a direction, the bounce by patches. Times are "
            "of the passes, without geometry.",
    .head = { "fps", "+%", "time +%" },
    .column = { { "ms", MILLISECONDS, 1 }, { "time +%", OVERHEAD, 0 }, { "frames lost, %", OWN, 1 } },
    .rows = WITH_COUNT(time_rows), .claims = WITH_COUNT(time_claims),
    .draw = frame_rates, .see = BOXES_VIEW("bunny", 0.6f, &sky_alone)
};

/* ---- >>Figure 6: a point light's segment ------------------------------------------------------------------------- */

#define SEGMENT "environment=none,bounce=none,shadows=segment,points=32"
/* as published, where no surface has a far side; a thickness; two layers */
#define THREE_WAYS(of, size, row) \
    { .what = "r_max " size, .method = "ssdo-points", .settings = SEGMENT ",solid=1", .reach = of, .ours = row + 1 }, \
    { .what = "r_max " size ", the library's thickness", .method = "ssdo-points", .settings = SEGMENT, .reach = of, \
      .base = row }, \
    { .what = "r_max " size ", 2 layers", .printed = { "30" }, .method = "ssdo-points", \
      .settings = SEGMENT ",layers=2", .reach = of, .base = row }
static const paper_row segment_rows[] = { THREE_WAYS(0.5f, "0.3", 1), THREE_WAYS(1.0f, "0.6", 4),
    THREE_WAYS(2.0f, "1.2", 7), THREE_WAYS(4.0f, "2.4", 10) };
static const claim segment_claims[] = {
    { "Only layers make the shadow right: with two it errs less at r_max 0.3", LESS(0, 2, 0), NULL },
    { "at 0.6", LESS(0, 5, 3), NULL },
    { "at 1.2", LESS(0, 8, 6), NULL },
    { "and at 2.4", LESS(0, 11, 9), NULL },
    { "Layers cost 30 % on average; here at the largest r_max", AS_PRINTED(1, 11, ALONE, 30),
      "the second layer's fetches are counted, its geometry is not" }
};
static const lit point_light = { NULL, { "point:1.6,1.5,0.9,6,6,6" }, 0, 0, 0, 16, 1, NO_CROPS };
static const sheet segment_sheet = {
    .paper = "SSDO09", .name = "Figure 6", .title = "screen-space shadows of a point light by r_max",
    .theirs = "Pictures alone; section 4 has the overhead of layers, 30 % on average.",
    .ours = "Three boxes, a point light without a map; 32 points a segment. The truth has the whole shadow.",
    .head = { "time +%" },
    .column = { { "error", ERROR, 3 }, { "time +%", OVERHEAD, 0 }, { "bias", BIAS, 3 } },
    .rows = WITH_COUNT(segment_rows), .claims = WITH_COUNT(segment_claims),
    .draw = sheet_draw, .pictured = 1,
    .see = { { "boxes", "boxes", 0, { 0 }, { 0 }, 0, 0.6f, &point_light }, NO_BOX, PLAINLY }
};

/* ---- >>Figure 7: cameras ----------------------------------------------------------------------------------------- */

static const paper_row camera_rows[] = {
    { .what = "a single view", .printed = { "49.2" }, .method = "ssdo-points", .settings = PATCHES BLURRED, .ours = 4 },
    { .what = "four more", .printed = { "31.5", "56" }, .method = "ssdo-points", .settings = PATCHES BLURRED ",views=4",
      .base = 1, .ours = 5 },
    { .what = "two layers (section 4)", .printed = { NULL, "30" }, .method = "ssdo-points",
      .settings = PATCHES BLURRED ",layers=2", .base = 1, .ours = 6 },
    { .what = "a single view, the library's points and bounce", .method = "ssdo-points", .settings = "" },
    { .what = "four more, the same", .method = "ssdo-points", .settings = "views=4", .base = 4 },
    { .what = "two layers, the same", .method = "ssdo-points", .settings = "layers=2", .base = 4 }
};
#define CAMERAS "the fetches of five depth buffers are counted, their geometry is not"
static const claim camera_claims[] = {
    { "Occluded objects cast shadows that a single view misses: light errs less with four more", LESS(0, 1, 0), NULL },
    { "Occluded surfaces bounce light: the bounce errs less", LESS(1, 1, 0), NULL },
    { "Four cameras take 56 % more time", AS_PRINTED(2, 1, ALONE, 56), CAMERAS },
    { "two layers 30 %", AS_PRINTED(2, 2, ALONE, 30), CAMERAS },
    { "and cameras no more than the 160 % of a large scene (section 6: 30 to 160 %)", WITHIN(2, 1, ALONE, 30, 160),
      CAMERAS }
};
static const lit sky_bounce = { "sky", { NULL }, 0, 1, 0, 64, 1, NO_CROPS };
static const sheet camera_sheet = {
    .paper = "SSDO09", .name = "Figure 7", .title = "one view, and four more",
    .theirs = "Pictures with frame rates. The second column is added time, worked out here; sections 4 and 6 have 30 % "
              "for two layers, 58 % for cameras in a simple scene, 160 % in a large one.",
    .ours = "White columns with coloured ones behind them, under the sky; one bounce.",
    .head = { "fps", "time +%" },
    .column = { { "error", ERROR, 3 }, { "bounce's error", BOUNCE_ERROR, 3 }, { "time +%", OVERHEAD, 0 } },
    .rows = WITH_COUNT(camera_rows), .claims = WITH_COUNT(camera_claims), .draw = sheet_draw, .pictured = 1,
    .see = { { "columns-sky", "columns", 0, { 0 }, { 0 }, 0, 0, &sky_bounce }, NO_BOX, PLAINLY }
};

/* ---- >>Figure 9: the bias of a shadow map ------------------------------------------------------------------------ */

#define MAP "environment=none,bounce=none,shadow_size=128,shadows="
static const paper_row bias_rows[] = {
    { .what = "without depth bias", .method = "ssdo-points", .settings = MAP "map,max_slope=0" },
    { .what = "classic depth bias", .printed = { "218" }, .method = "ssdo-points", .settings = MAP "map" },
    { .what = "screen-space visibility, 16 samples", .printed = { "103", "112" }, .method = "ssdo-points",
      .settings = MAP "fill,points=16,solid=1", .base = 2, .ours = 5 },
    { .what = "with depth peeling, 8 samples", .printed = { "73", "199" }, .method = "ssdo-points",
      .settings = MAP "fill,points=8,layers=2", .base = 2 },
    { .what = "16 samples, the library's thickness", .method = "ssdo-points", .settings = MAP "fill,points=16",
      .base = 2 }
};
static const claim bias_claims[] = {
    { "Without a bias surfaces shadow themselves: it errs most", LESS(0, 1, 0), NULL },
    { "The bias loses contacts that screen-space visibility brings back: it errs less", LESS(0, 2, 1),
      "a surface without a far side blocks segments that pass behind it" },
    { "and so with layers", LESS(0, 3, 1),
      "what is behind the first layer is thinner here than a texel of the map" },
    { "Screen-space visibility costs 112 % with 16 samples", AS_PRINTED(1, 2, ALONE, 112),
      "16 tests stand beside a single look-up in the map: the paper's times hold the geometry, too" },
    { "and 199 % with layers and 8 samples", AS_PRINTED(1, 3, ALONE, 199), NULL }
};
static const lit low_sun = { NULL, { "sun:1,0.35,0.3,3,3,3" }, 0, 0, 0, 16, 1,
    { { 96, 64, 80, 45 }, { 168, 96, 80, 45 } } };
static const sheet bias_sheet = {
    .paper = "SSDO09", .name = "Figure 9", .title = "contact shadows that a map's depth bias loses",
    .theirs = "Frames a second at 1024x768 with a map of 1024x1024. The second column is added time, worked out here.",
    .ours = "Pebbles under a low sun, 320x180 with a map of 128x128.",
    .head = { "fps", "time +%" }, .column = { { "error", ERROR, 4 }, { "time +%", OVERHEAD, 0 }, { "bias", BIAS, 4 } },
    .rows = WITH_COUNT(bias_rows), .claims = WITH_COUNT(bias_claims),
    .draw = sheet_draw, .pictured = 2,
    .see = { { "pebbles-sun", "pebbles", 0, { 0 }, { 0 }, 0, 0, &low_sun }, NO_BOX, PLAINLY }
};

/* ---- >>Figure 10: the environment as lights ---------------------------------------------------------------------- */

static const paper_row natural_rows[] = {
    { .what = "256 lights, classic bias", .printed = { "54.0" }, .method = "ssdo",
      .settings = "bounce=none,suns=64,shadow_size=256,shadows=map", .note = "64 lights" },
    { .what = "256 lights, screen-space visibility", .printed = { "25.2", "114" }, .method = "ssdo",
      .settings = "bounce=none,suns=64,shadow_size=256,shadows=fill", .note = "64 lights", .base = 1 },
    { .what = "directional occlusion alone", .method = "ssdo", .settings = "bounce=none",
      .note = "not in the figure: within r_max" }
};
static const claim natural_claims[] = {
    { "Screen-space visibility removes the bias: it errs less", LESS(0, 1, 0),
      "as in figure 9 the bias here loses little; what the segments add is also noise" },
    { "It costs 114 %", AS_PRINTED(1, 1, ALONE, 114), NULL },
    { "Lights with maps see all of the scene: they err less than directional occlusion alone", LESS(0, 0, 2), NULL }
};
static const lit whole_sky = { "sky", { NULL }, 0, 0, 0, 128, 1, NO_CROPS };
static const sheet natural_sheet = {
    .paper = "SSDO09", .name = "Figure 10", .title = "natural illumination by lights with maps",
    .theirs = "Frames a second at 512x512, 256 lights with a map of 512x512 each. The second column is added time, "
              "worked out here.",
    .ours = "Three boxes under the sky, 64 lights with maps of 256x256; the truth is blocked by all of the scene.",
    .head = { "fps", "time +%" },
    .column = { { "error", ERROR, 4 }, { "time +%", OVERHEAD, 0 }, { "ms", MILLISECONDS, 0 } },
    .rows = WITH_COUNT(natural_rows), .claims = WITH_COUNT(natural_claims),
    .draw = sheet_draw, .pictured = 1, .truth = 30,
    .see = { { "boxes-sky", "boxes", 0, { 0 }, { 0 }, 0, 0, &whole_sky }, NO_BOX, PLAINLY }
};

/* ---- >>Figure 11, Figure 12: virtual point lights ---------------------------------------------------------------- */

#define VPLS "environment=none,vpls=64,shadow_size=64,"
static const paper_row radiosity_rows[] = {
    { .what = "instant radiosity", .method = "ssdo-points", .settings = VPLS "bounce=none,shadows=map" },
    { .what = "with screen-space shadow correction", .method = "ssdo-points",
      .settings = VPLS "bounce=none,shadows=fill", .base = 1 }
};
static const claim radiosity_claims[] = {
    { "Small shadows that the bias loses come back: the bounce errs less", LESS(0, 1, 0),
      "64 lights blend: what one lacks at a contact is a 64th, below the error of so few lights" }
};
static const lit bunny_lamp = { NULL, { "point:-1.5,1.6,2.2,14,13,12" }, 4, 1, 0, 512, 0.9f, NO_CROPS };
static const sheet radiosity_sheet = {
    .paper = "SSDO09", .name = "Figure 11", .title = "instant radiosity with screen-space shadow correction",
    .theirs = "Pictures alone: small details, such as toes, lose their shadows to the bias.",
    .ours = "Bunny and four boxes under a lamp, 64 virtual lights with maps of 64x64; the truth has the whole bounce.",
    .column = { { "bounce's error", BOUNCE_ERROR, 4 }, { "time +%", OVERHEAD, 0 },
                { "radiance's", RADIANCE_ERROR, 4 } },
    .rows = WITH_COUNT(radiosity_rows), .claims = WITH_COUNT(radiosity_claims),
    .draw = sheet_draw, .pictured = 1, .truth = 60, .stride = LIT_STRIDE,
    .see = BOXES_VIEW("bunny-lamp", 0.4f, &bunny_lamp)
};

static const paper_row both_rows[] = {
    { .what = "virtual lights, shadow correction", .method = "ssdo-points",
      .settings = VPLS "bounce=none,shadows=fill" },
    { .what = "and the bounce in screen space", .method = "ssdo-points",
      .settings = VPLS "shadows=fill," PATCHES BLURRED, .base = 1, .ours = 3 },
    { .what = "and the library's bounce", .method = "ssdo-points",
      .settings = VPLS "bounce=solid-angle,shadows=fill", .base = 1 },
    { .what = "the bounce in screen space alone", .method = "ssdo-points",
      .settings = "environment=none," PATCHES BLURRED, .note = "not in the figure", .ours = 5 },
    { .what = "the library's bounce alone", .method = "ssdo-points", .settings = "environment=none,bounce=solid-angle",
      .note = "not in the figure" }
};
static const claim both_claims[] = {
    { "The bounce in screen space adds what virtual lights lack nearby: the bounce errs less", LESS(0, 1, 0), NULL },
    { "Alone it lacks what is far: it errs more than virtual lights do", LESS(0, 0, 3), NULL }
};
static const lit box_lamp = { NULL, { "point:0,5,-2.8,15,15,15" }, 0, 1, 0, 512, 1.4f, NO_CROPS };
static const sheet both_sheet = {
    .paper = "SSDO09", .name = "Figure 12", .title = "instant radiosity with a bounce in screen space",
    .theirs = "Pictures alone; the indirect light is scaled to show its effects.",
    .ours = "Cornell box, 64 virtual lights with maps of 64x64; the truth has the whole bounce.",
    .column = { { "bounce's error", BOUNCE_ERROR, 4 }, { "time +%", OVERHEAD, 0 },
                { "radiance's", RADIANCE_ERROR, 4 } },
    .rows = WITH_COUNT(both_rows), .claims = WITH_COUNT(both_claims),
    .draw = sheet_draw, .pictured = 1, .truth = 100, .stride = LIT_STRIDE,
    .see = { { "cornell-lamp", "cornell", 0, { 0 }, { 0 }, 0, 0, &box_lamp }, NO_BOX, PLAINLY }
};

/* ---- >>Figure 13: a reference with one bounce -------------------------------------------------------------------- */

static const paper_row faithful_rows[] = {
    { .what = "directional occlusion and a bounce, N = 16", .method = "ssdo-points", .settings = PATCHES BLURRED,
      .ours = 2 },
    { .what = "the library's points and bounce", .method = "ssdo-points", .settings = OUR_POINTS },
    { .what = "the library's slices", .method = "ssdo", .settings = "", .note = "not in the figure" },
    { .what = "no bounce", .method = "ssdo-points", .settings = PATCHES BLURRED ",bounce=none",
      .note = "not in the figure" },
    { .what = "N = 8", .method = "ssdo-points", .settings = PATCHES BLURRED ",samples=8" },
    { .what = "N = 4 of 4 points each", .method = "ssdo-points", .settings = PATCHES BLURRED ",samples=4,steps=4",
      .note = "not in the paper: more directions find an emitter, each with a patch of the same area" }
};
static const claim faithful_claims[] = {
    { "Directional occlusion is faithfully reproduced", SIMILAR(0, 0), NULL },
    { "and so is indirect lighting", SIMILAR(1, 0), NULL },
    { "its bounce errs less than none at all would", LESS(1, 0, 3), NULL },
    { "and with N = 8", LESS(1, 4, 3), NULL }
};
static const sheet faithful_sheet = {
    .paper = "SSDO09", .name = "Figure 13", .title = "beside a reference with one bounce",
    .theirs = "Pictures: an environment and a point light; PBRT with one bounce.",
    .ours = "The room under the sky; distances to patches are clamped to a quarter of r_max.",
    .column = { { "error", ERROR, 3 }, { "bounce's error", BOUNCE_ERROR, 3 }, { "bounce's mean", MEAN, 4 } },
    .rows = WITH_COUNT(faithful_rows), .claims = WITH_COUNT(faithful_claims), .draw = sheet_draw, .pictured = 1,
    .see = { { "room-sky", "room", 0, { 0 }, { 0 }, 0, 0, &sky_bounce }, NO_BOX, PLAINLY }
};

/* ---- >>Figure 14: r_max ------------------------------------------------------------------------------------------ */

#define REACH(of, size, own) \
    { .what = "r_max " size, .method = "ssdo-points", .settings = PATCHES BLURRED, .reach = of, .ours = own }, \
    { .what = "r_max " size ", the library's bounce", .method = "ssdo-points", .settings = OUR_POINTS, .reach = of }
static const paper_row reach_rows[] = { REACH(0.25f, "0.15", 2), REACH(0.5f, "0.3", 4), REACH(1.0f, "0.6", 6),
    { .what = "r_max 0.6, no bounce", .method = "ssdo-points", .settings = OUR_POINTS ",bounce=none", .reach = 1,
      .note = "not in the figure" },
    REACH(2.0f, "1.2", 9) };
static const claim reach_claims[] = {
    { "The bounce errs less than none at all would", LESS(1, 4, 6), NULL },
    { "The larger r_max, the more is out of sight: light errs more", LESS(0, 0, 7), NULL }
};
static const lit sun_and_sky = { "sky", { "sun:-1,0.45,0.85,4.4,3.9,3.3" }, 4, 1, 0, 64, 0.4f, NO_CROPS };
static const sheet reach_sheet = {
    .paper = "SSDO09", .name = "Figure 14", .title = "light and one bounce by r_max",
    .theirs = "Pictures alone: a point light with a map, and an environment.",
    .ours = "Bunny and four boxes under the sky and a sun with a map; each r_max has its own truth. Distances to "
            "patches are clamped to a quarter of r_max, where the paper has 1, of units that it does not give.",
    .column = { { "error", ERROR, 3 }, { "bounce's error", BOUNCE_ERROR, 3 }, { "bounce's mean", MEAN, 4 } },
    .rows = WITH_COUNT(reach_rows), .claims = WITH_COUNT(reach_claims),
    .draw = sheet_draw, .pictured = 1, .see = BOXES_VIEW("bunny-sun", 0.6f, &sun_and_sky)
};

static const sheet *const sheets[] = { &time_sheet, &segment_sheet, &camera_sheet, &bias_sheet, &natural_sheet,
    &radiosity_sheet, &both_sheet, &faithful_sheet, &reach_sheet };
static const absent none[] = {
    { "Figures 1, 3", "scenes that are not free to use; README.md has pictures of directional occlusion and a bounce" },
    { "Figures 2, 5, 8", "diagrams" },
    { "Figure 4", "a bounce that fades as its emitter is hidden; `make stability` slides a box behind a screen" }
};
const paper ssdo_paper = { "SSDO09",
    "Ritschel, Grosch, Seidel 2009, Approximating dynamic global illumination in image space", WITH_COUNT(sheets),
    WITH_COUNT(none) };
