/* hsao.c - the tables and figures of [HSAO08]. Declared in sheet.h. */
#include "lab/papers/sheet.h"

#define GEFORCE "GeForce 8800 GTX, 2.4 GHz Athlon64 X2"
#define MARCH(set) .method = "hsao-march", .settings = set
#define PEBBLES "pebbles: some hundred small boxes, studs and balls on a ground, for the paper's scanned models. "

/* ---- >>Table 1 --------------------------------------------------------------------------------------------------- */

/* Half of the paper's width and height. */
#define AT(w, h, ho, no, blur, skip) { .what = #w "x" #h, .printed = { ho, no, blur }, \
      MARCH("directions=7,steps=12,normal_rays=1,filter=gaussian,blur=2"), \
      .width = w / 2, .height = h / 2, .slow = skip }
static const paper_row pass_rows[] = {
    AT(640, 480, "7.16", "4.67", "0.71", 0),    AT(800, 600, "10.55", "7.24", "1.33", 1),
    AT(1024, 768, "17.09", "12.53", "2.09", 1), AT(1280, 1024, "30.71", "26.54", "3.23", 1),
    AT(1600, 1153, "39.66", "37.41", "4.35", 0)
};
enum { HORIZON = OWN, NORMAL, BLUR, NORMAL_SHARE, BLUR_SHARE };
static const claim pass_claims[] = {
    { "Normal occlusion with one ray takes about what the horizon does (printed: 0.65 to 0.94 of it)",
      WITHIN(3, 4, 0.5, 1.1), NULL },
    { "The filter takes a tenth of the horizon's time (printed: 0.10 to 0.13)", WITHIN(4, 4, 0.05, 0.2),
      "25 taps of depth and occlusion beside 84 fetches: a CPU's arithmetic hides behind none" },
    { "The time follows the pixels: 6.0 times as many take 5.5 times as long", 0, 4, 0, 4.4, 7.5, NULL }
};

/* The terms apart: without normal rays, with them less that, and a filter behind a gather of one tap. */
static int pass_times(FILE *html, const options *o, const sheet *t, row *rows, kit_error *err)
{
    static const entry parts[] = {
        { "horizon", MARCH("directions=7,steps=12,normal_rays=0,blur=0"), 1 },
        { "both", MARCH("directions=7,steps=12,normal_rays=1,blur=0"), 1 },
        { "one tap", MARCH("directions=1,steps=1,normal_rays=0,blur=0"), 1 },
        { "one tap, filtered", MARCH("directions=1,steps=1,normal_rays=0,filter=gaussian,blur=2"), 1 }
    };
    row part[COUNT(parts)];
    sheet_blank(t, rows);
    for (int i = 0; i < t->count; ++i) {
        stage s;
        double *const own = &rows[i].figure[STAGE];
        if (o->quick && t->rows[i].slow) continue;
        if (sheet_load(&s, t, err) || stage_look(&s, &t->see.view, t->rows[i].width, t->rows[i].height, err)
            || measure_times(part, &s, parts, COUNT(parts), sheet_rounds(o), err))
            return -1;
        if (i + 1 == t->count) sheet_about(html, &s);
        const double unit = part[0].ms / part[0].relative;
        own[0] = part[0].ms;
        own[1] = unit * (part[1].relative - part[0].relative);
        own[2] = unit * (part[3].relative - part[2].relative);
        own[3] = own[1] / own[0];
        own[4] = own[2] / own[0];
        stage_close(&s);
    }
    return 0;
}

static const sheet pass_times_sheet = {
    .paper = "HSAO08", .name = "Table 1", .title = "times of horizon, normal rays and filter at five sizes",
    .theirs = "Milliseconds for the David head of figure 1(b), 750,000 triangles, " GEFORCE "; R = 0.2, N_d = 7, "
              "N_n = 1, N_s = 12.",
    .erratum = "The caption's N_r is N_n.",
    .ours = "Bunny on a floor, half the widths and heights; the 5x5 Gaussian of section 4.1.3. Times are of a software "
            "rasteriser: compare ratios.",
    .head = { "HO, ms", "NO, ms", "blur, ms" },
    .column = { { "HO, ms", HORIZON, 0 }, { "NO, ms", NORMAL, 0 }, { "blur, ms", BLUR, 0 },
                { "NO/HO", NORMAL_SHARE, 2 }, { "blur/HO", BLUR_SHARE, 2 } },
    .rows = WITH_COUNT(pass_rows), .claims = WITH_COUNT(pass_claims),
    .draw = pass_times, .see = { BUNNY_VIEW("bunny-on-floor", 1, 0.2f, NULL), PLAINLY }
};

/* ---- >>Figure 6, Figure 7 ---------------------------------------------------------------------------------------- */

#define RADIUS(size, of) { .what = "R = " size, MARCH("directions=6,steps=9,normal_rays=1,blur=0"), .reach = of }
static const paper_row radius_rows[] = { RADIUS("0.02", 0.25f), RADIUS("0.04", 0.5f), RADIUS("0.08", 1),
    RADIUS("0.16", 2), RADIUS("0.32", 4) };
static const claim radius_claims[] = {
    { "A larger R occludes more", LESS(0, 4, 0), NULL },
    { "A larger R wants more rays for the same quality: the same rays are noisier", LESS(2, 0, 4), NULL }
};
static const sheet radius_sheet = {
    .paper = "HSAO08", .name = "Figure 6", .title = "the radius of influence R",
    .theirs = "Pictures alone, without their settings; section 3.6 says what they show.",
    .erratum = "Section 3.6 calls it Table 6.",
    .ours = PEBBLES "R from a quarter of its own 0.08 to four times it; linear attenuation, no filter.",
    .column = { { "mean visibility", MEAN, 3 }, { "error", ERROR, 3 }, { "noise", NOISE, 3 } },
    .rows = WITH_COUNT(radius_rows), .claims = WITH_COUNT(radius_claims),
    .draw = sheet_draw, .see = OWN_VIEW("pebbles"), .phases = 3, .pictured = 1
};

#define DIRECTIONS(n) { .what = "N_d = " #n, MARCH("directions=" #n ",steps=9,normal_rays=0,blur=0") }
static const paper_row direction_rows[] = { DIRECTIONS(1), DIRECTIONS(2), DIRECTIONS(4), DIRECTIONS(6), DIRECTIONS(8),
    DIRECTIONS(16) };
static const claim direction_claims[] = {
    { "The rays, and with them the time, are proportional to N_d (16 to 4)", 2, 5, 2, 3, 5, NULL },
    { "More directions are less noisy", LESS(1, 5, 1), NULL },
    { "Beyond some number they change little: the error of 16 is that of 8", ALIKE(0, 5, 4, 0.1), NULL }
};
static const sheet direction_sheet = {
    .paper = "HSAO08", .name = "Figure 7", .title = "the number of initial directions N_d",
    .theirs = "Pictures alone, without their settings.", .ours = PEBBLES "N_s = 9, no normal rays, no filter.",
    .column = { { "error", ERROR, 3 }, { "noise", NOISE, 3 }, { "time", TIME, 2 } },
    .rows = WITH_COUNT(direction_rows), .claims = WITH_COUNT(direction_claims),
    .draw = sheet_draw, .see = OWN_VIEW("pebbles"), .phases = 3, .pictured = 1
};

/* ---- >>Figure 10 ------------------------------------------------------------------------------------------------- */

#define TERM(letter, name, set) { .what = letter " " name, MARCH("directions=8,steps=18,blur=0," set) }
static const paper_row term_rows[] = {
    TERM("(a)", "horizon occlusion", "terms=horizon"), TERM("(b)", "normal occlusion", "normal_rays=1,terms=normal"),
    TERM("(c)", "final", "normal_rays=1"), TERM("(a)", "by growing spheres", "terms=horizon,spheres=1")
};
static const claim term_claims[] = {
    { "The horizon's part dominates: it occludes more than the normal rays' does", LESS(0, 0, 1), NULL },
    { "The final occlusion has less error than the horizon's alone", LESS(1, 2, 0), NULL },
    { "Growing spheres (section 5) underestimate: they occlude less than (a)", LESS(0, 0, 3), NULL }
};
static const sheet term_sheet = {
    .paper = "HSAO08", .name = "Figure 10", .title = "horizon occlusion, normal occlusion, both",
    .theirs = "Pictures alone, without their settings.",
    .ours = PEBBLES "N_d = 8, N_s = 18, N_n = 1, no filter.",
    .column = { { "mean visibility", MEAN, 3 }, { "error", ERROR, 3 } },
    .rows = WITH_COUNT(term_rows), .claims = WITH_COUNT(term_claims),
    .draw = sheet_draw, .see = OWN_VIEW("pebbles"), .pictured = 1
};

/* ---- >>Figure 11, Figure 14 -------------------------------------------------------------------------------------- */

#define SET(letter, d, s, n) { .what = letter " N_d = " #d ", N_s = " #s ", N_n = " #n, \
      MARCH("directions=" #d ",steps=" #s ",normal_rays=" #n) }
static const paper_row quality_rows[] = { SET("(a)", 6, 9, 0), SET("(b)", 8, 18, 0), SET("(c)", 8, 18, 1),
    SET("(d)", 18, 25, 2) };
static const claim quality_claims[] = {
    { "(d) is for quality, (a) for speed: (d) errs less", LESS(0, 3, 0), NULL },
    { "and takes longer", LESS(1, 0, 3), NULL },
    { "Normal rays improve what is close together: (c) errs less than (b)", LESS(0, 2, 1), NULL },
    { "The pictures are similar to a ray tracer's: the best leaves less than half of no occlusion's error",
      WITHIN(0, 3, 0, 0.5), NULL }
};
static const sheet quality_sheet = {
    .paper = "HSAO08", .name = "Figure 11", .title = "several sets of parameters beside a ray tracer",
    .theirs = "Pictures of the Buddha, 512x1024, R = 0.3, linear attenuation; (e) by Mental Ray, 256 rays a pixel.",
    .ours = PEBBLES "R = 0.08, linear attenuation, the filter on.",
    .column = { { "error", ERROR, 3 }, { "time", TIME, 2 }, { "bias", BIAS, 3 } },
    .rows = WITH_COUNT(quality_rows), .claims = WITH_COUNT(quality_claims),
    .draw = sheet_draw, .see = OWN_VIEW("pebbles"), .rays = 256, .pictured = 1
};

static const paper_row traced_rows[] = { SET("(a)", 10, 6, 2), SET("(b)", 13, 8, 4) };
static const claim traced_claims[] = {
    { "Both are similar to the ray tracer's: they leave less than half of no occlusion's error", WITHIN(0, 0, 0, 0.5),
      NULL },
    { "More rays and steps err less: (b) than (a)", LESS(0, 1, 0), NULL }
};
static const sheet traced_sheet = {
    .paper = "HSAO08", .name = "Figure 14", .title = "two sets of parameters beside a ray tracer",
    .theirs = "Pictures; (c) by Mental Ray, 256 samples a pixel.", .ours = PEBBLES "R = 0.08, the filter on.",
    .column = { { "error", ERROR, 3 }, { "time", TIME, 2 }, { "bias", BIAS, 3 } },
    .rows = WITH_COUNT(traced_rows), .claims = WITH_COUNT(traced_claims),
    .draw = sheet_draw, .see = OWN_VIEW("pebbles"), .rays = 256, .pictured = 1
};

/* ---- >>Figure 12 ------------------------------------------------------------------------------------------------- */

#define RAYS_MARCHED(n, d, each) { .what = #n " rays, marched", \
      MARCH("directions=" #d ",normal_rays=" #each ",terms=rays,steps=9,blur=0") }
static const paper_row march_rows[] = {
    RAYS_MARCHED(4, 4, 1), RAYS_MARCHED(8, 8, 1), RAYS_MARCHED(16, 16, 1), RAYS_MARCHED(32, 32, 1),
    RAYS_MARCHED(64, 32, 2),
    { .what = "4 horizons", MARCH("directions=4,steps=9,normal_rays=0,blur=0") },
    { .what = "8 horizons", MARCH("directions=8,steps=9,normal_rays=0,blur=0") },
    { .what = "16 horizons", MARCH("directions=16,steps=9,normal_rays=0,blur=0") },
    { .what = "32 horizons", MARCH("directions=32,steps=9,normal_rays=0,blur=0") }
};
static const claim march_claims[] = {
    { "A ray and a horizon of as many steps take about as long (16 of each)", ALIKE(1, 2, 7, 1), NULL },
    { "Horizons converge faster: 8 are less noisy than 8 rays", LESS(0, 6, 1), NULL },
    { "and less than 16 rays", LESS(0, 6, 2), NULL },
    { "Marching more rays converges: 64 are less noisy than 4", LESS(0, 4, 0), NULL }
};
static const sheet march_sheet = {
    .paper = "HSAO08", .name = "Figure 12", .title = "ray marching alone beside the horizons",
    .theirs = "Pictures alone: first row ray marching, second row horizons, more rays from left to right.",
    .ours = PEBBLES "Rays by the cosine through the whole hemisphere, marched in 9 steps (terms=rays); horizons of "
                    "9 steps; no filter.",
    .column = { { "noise", NOISE, 3 }, { "time", TIME, 2 }, { "error", ERROR, 3 } },
    .rows = WITH_COUNT(march_rows), .claims = WITH_COUNT(march_claims),
    .draw = sheet_draw, .see = OWN_VIEW("pebbles"), .phases = 3, .pictured = 1
};

static const sheet *const sheets[] = { &pass_times_sheet, &radius_sheet, &direction_sheet, &term_sheet, &quality_sheet,
    &march_sheet, &traced_sheet };
const paper hsao_paper = { "HSAO08", "Dimitrov, Bavoil, Sainz 2008, Horizon-split ambient occlusion",
    WITH_COUNT(sheets) };
