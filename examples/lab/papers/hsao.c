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
#define ENDS "a ray ends at what it meets, a horizon walks to the radius"
#define SIZE(row, size, no, blur) \
    { "At " size " normal occlusion with one ray takes " #no " of what the horizon does", \
      AS_PRINTED(3, row, ALONE, no), ENDS }, \
    { "and the filter " #blur, AS_PRINTED(4, row, ALONE, blur), \
      "25 taps of depth and occlusion beside 84 fetches: a CPU's arithmetic hides behind none" }
static const claim pass_claims[] = {
    SIZE(0, "640x480", 0.65, 0.10), SIZE(1, "800x600", 0.69, 0.13), SIZE(2, "1024x768", 0.73, 0.12),
    SIZE(3, "1280x1024", 0.86, 0.11), SIZE(4, "1600x1153", 0.94, 0.11),
    { "The time follows the pixels: 6.0 times as many take 5.5 times as long", AS_PRINTED(0, 4, 0, 5.54), NULL }
};

/* The terms apart: without normal rays, with them less that, and a filter behind a gather of one tap. */
static int pass_times(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
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
        if (i + 1 == t->count) sheet_about(record, &s);
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
    { "More directions are less noisy: 16 than 8", LESS(1, 5, 4), NULL },
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
    { "The final occlusion has less error than the horizon's alone", LESS(1, 2, 0), NULL }
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

/* as published, with the 5x5 Gaussian; behind the library's filter: row own, from 1 on */
#define SET(letter, d, s, n, own) { .what = letter " N_d = " #d ", N_s = " #s ", N_n = " #n, \
      MARCH("directions=" #d ",steps=" #s ",normal_rays=" #n ",filter=gaussian,blur=2"), .ours = own }
#define OWN_SET(letter, d, s, n) { .what = letter " the library's filter", \
      MARCH("directions=" #d ",steps=" #s ",normal_rays=" #n) }
#define SLICES \
    { .what = "the library's slices, full size", .method = "hsao-best", .settings = "", .note = "not in the figure" }
static const paper_row quality_rows[] = { SET("(a)", 6, 9, 0, 5), SET("(b)", 8, 18, 0, 6), SET("(c)", 8, 18, 1, 7),
    SET("(d)", 18, 25, 2, 8), OWN_SET("(a)", 6, 9, 0), OWN_SET("(b)", 8, 18, 0), OWN_SET("(c)", 8, 18, 1),
    OWN_SET("(d)", 18, 25, 2), SLICES };
static const claim quality_claims[] = {
    { "(d) is for quality, (a) for speed: (d) errs less", LESS(0, 3, 0), NULL },
    { "Normal rays improve what is close together: (c) errs less than (b)", LESS(0, 2, 1), NULL },
    { "The pictures are similar to a ray tracer's, (d) at least", SIMILAR(0, 3),
      "one depth layer does not show what stands behind studs and balls" }
};
static const sheet quality_sheet = {
    .paper = "HSAO08", .name = "Figure 11", .title = "several sets of parameters beside a ray tracer",
    .theirs = "Pictures of the Buddha, 512x1024, R = 0.3, linear attenuation; (e) by Mental Ray, 256 rays a pixel.",
    .ours = PEBBLES "R = 0.08, linear attenuation, the 5x5 Gaussian of section 4.1.3.",
    .column = { { "error", ERROR, 3 }, { "time", TIME, 2 }, { "bias", BIAS, 3 } },
    .rows = WITH_COUNT(quality_rows), .claims = WITH_COUNT(quality_claims),
    .draw = sheet_draw, .see = OWN_VIEW("pebbles"), .rays = 256, .pictured = 1
};

static const paper_row traced_rows[] = { SET("(a)", 10, 6, 2, 3), SET("(b)", 13, 8, 4, 4), OWN_SET("(a)", 10, 6, 2),
    OWN_SET("(b)", 13, 8, 4), SLICES };
static const claim traced_claims[] = {
    { "(a) is similar to the ray tracer's picture", SIMILAR(0, 0), NULL },
    { "and so is (b)", SIMILAR(0, 1), "one depth layer does not show what stands behind studs and balls" },
    { "More rays and steps err less: (b) than (a)", LESS(0, 1, 0), NULL }
};
static const sheet traced_sheet = {
    .paper = "HSAO08", .name = "Figure 14", .title = "two sets of parameters beside a ray tracer",
    .theirs = "Pictures; (c) by Mental Ray, 256 samples a pixel.",
    .ours = PEBBLES "R = 0.08, the 5x5 Gaussian of section 4.1.3.",
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
    { .what = "32 horizons", MARCH("directions=32,steps=9,normal_rays=0,blur=0") },
    { .what = "8 horizons, a normal ray each", MARCH("directions=8,steps=9,normal_rays=1,blur=0") },
    { .what = "32 horizons, a normal ray each", MARCH("directions=32,steps=9,normal_rays=1,blur=0") }
};
static const claim march_claims[] = {
    { "A ray and a horizon of as many steps take about as long (16 of each)", ALIKE(1, 2, 7, 0.5), ENDS },
    { "Marching converges at a much slower rate: 8 horizons are much less noisy than 16 rays", MUCH_LESS(0, 6, 2),
      NULL },
    { "and so is the whole algorithm of 8 horizons and 8 normal rays", MUCH_LESS(0, 9, 2),
      "normal rays are marched, too, and bring the noise of rays with them" },
    { "Marching converges to a similar image: 64 rays err like the whole algorithm of 32 directions",
      ALIKE(2, 4, 10, 0.1), NULL },
    { "and like 32 horizons alone", ALIKE(2, 4, 8, 0.1), "a horizon does not see what floats above it" }
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
static const absent none[] = {
    { "Figure 1", "a scanned head that is not free to use; figures 11 and 14 are the same comparison" },
    { "Figures 2, 3, 4, 5, 8, 9, 13", "diagrams and pseudo code" },
    { "Equation 4", "the cosine's absence is related work's: the paper computes equation 1, and so does the library" },
    { "Section 6", "\"less quantization of shades of gray\" has no figure in the paper, and none here" }
};
const paper hsao_paper = { "HSAO08", "Dimitrov, Bavoil, Sainz 2008, Horizon-split ambient occlusion",
    WITH_COUNT(sheets), WITH_COUNT(none) };
