/* dss.c - the tables and figures of [DSS14]. Declared in sheet.h. */
#include <math.h>
#include "lab/papers/sheet.h"

/* as published: corners move to the centroid, surfels of farther levels are larger, form factors are of centres */
#define SURFELS_AS   "half=0,overhang=centroid,near_samples=1"
/* and small ones, where nothing else is said */
#define FINE         "size=0.015,epsilon=0.1,levels=5,"
#define SPLATS_AS    SURFELS_AS ",enlarge=1,combine=add"
/* and surfels are all that there is */
#define PUBLISHED    "span=0," SPLATS_AS
/* and triangles smaller than a surfel keep theirs */
#define PUBLISHED_ALL PUBLISHED ",keep_small=1"

/* ---- >>Table 1 --------------------------------------------------------------------------------------------------- */

#define STAGE_ROW(name, ao, do_, gi, sss) { .what = name, .printed = { ao, do_, gi, sss }, .method = "dss", \
      .settings = "way=capture," FINE PUBLISHED }
enum { SPLATTING = 2, TOTAL = 6 };
static const paper_row stage_rows[] = {
    STAGE_ROW("Tessellation", "1.6", "1.6", "1.6", "1.6"), STAGE_ROW("Shuffling", "2", "2", "3", "2"),
    STAGE_ROW("Splatting", "14", "16", "44.7", "14.6"),    STAGE_ROW("Unshuffling", "1", "1", "1.2", "1"),
    STAGE_ROW("Blurring", "3", "3", "5", "2.5"),           STAGE_ROW("Summing", "0.4", "0.4", "0.5", "0.3"),
    STAGE_ROW("Total", "22", "24", "56", "22")
};
static const claim stage_claims[] = {
    { "Splatting takes 64 % of AO", AS_PRINTED(0, SPLATTING, TOTAL, 0.636), NULL },
    { "67 % of DO", AS_PRINTED(1, SPLATTING, TOTAL, 0.667), NULL },
    { "80 % of GI", AS_PRINTED(2, SPLATTING, TOTAL, 0.798), NULL },
    { "and 66 % of SSS", AS_PRINTED(4, SPLATTING, TOTAL, 0.664), NULL },
    { "Tessellation is a small part, 7 % of AO", AS_PRINTED(0, 0, TOTAL, 0.073),
      "geometry stages are a software rasteriser's slowest" }
};
/* A column an effect, a row a stage: of each effect's frame its stages' shares. The quick form has AO alone. */
static int stage_times(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    static const entry effects[] = { { "AO", "dss", "way=capture," FINE PUBLISHED, 1 },
                                     { "DO", "dss-lit", "way=capture,bounce=none," FINE PUBLISHED, 1 },
                                     { "DO, GI", "dss-lit", "way=capture," FINE PUBLISHED, 1 },
                                     { "specular", "dss-gloss", "way=capture," FINE SPLATS_AS, 1 },
                                     { "SSS", "dss-scatter", "way=capture," SURFELS_AS "," MARBLE, 1 },
                                     { "AO, the library's", "dss", "way=capture", 1 } };
    const int count = o->quick ? 1 : COUNT(effects);
    row timed[COUNT(effects)];
    stage s;
    sheet_blank(t, rows);
    if (sheet_load(&s, t, err) || stage_look(&s, &t->see.view, t->width, t->height, err)
        || measure_times(timed, &s, effects, count, o->quick ? 1 : 2, err))
        return -1;
    sheet_about(record, &s);
    for (int e = 0; e < count; ++e)
        for (int i = 0; i <= TOTAL; ++i)
            rows[i].figure[STAGE + e] = timed[e].ms * (i < TOTAL ? timed[e].figure[STAGE + i] : 1);
    stage_close(&s);
    return 0;
}

static const sheet stage_sheet = {
    .paper = "DSS14", .name = "Table 1", .title = "where the time goes, by effect",
    .theirs = "Milliseconds, 512x512, 50,000 triangles; the GPU is not named. The columns add up.",
    .ours = "Bunny, floor and four boxes, 256x256; surfels by tessellation, captured, as published. The third column "
            "has DO and one diffuse bounce; beside it the specular bounce, which the paper does not time, and the "
            "library's AO. The total holds what is no stage: lights, and in the library's AO what is near.",
    .head = { "AO, ms", "DO, ms", "GI, ms", "SSS, ms" },
    .column = { { "AO, ms", OWN, 0 }, { "DO, ms", OWN + 1, 0 }, { "DO and GI, ms", OWN + 2, 0 },
                { "specular, ms", OWN + 3, 0 }, { "SSS, ms", OWN + 4, 0 }, { "the library's AO, ms", OWN + 5, 0 } },
    .rows = WITH_COUNT(stage_rows), .claims = WITH_COUNT(stage_claims), .draw = stage_times,
    .see = WHOLE_LIGHT, .width = 256, .height = 256
};

/* ---- >>Figure 4 -------------------------------------------------------------------------------------------------- */

static const paper_row small_rows[] = {
    { .what = "(a) the size asked for", .method = "dss", .settings = "size=0.06,epsilon=0.1,levels=3," PUBLISHED },
    { .what = "(b) a mesh finer than that", .method = "dss",
      .settings = "size=0.06,epsilon=0.1,levels=3,keep_small=1," PUBLISHED }
};
static const claim small_claims[] = {
    { "Surfels of (b) reach less far, so that it is lighter", LESS(0, 0, 1), NULL }
};
static const sheet small_sheet = {
    .paper = "DSS14", .name = "Figure 4", .title = "too many triangles a pixel",
    .theirs = "Pictures alone: the same settings on a coarse and on a fine mesh.",
    .ours = "Bunny on a floor, 69,000 triangles, surfels of 0.06 picture heights alone, 3 levels. (a): of triangles "
            "smaller than three surfels a share is kept, as if the mesh were coarse; (b): every triangle keeps its "
            "own, as published.",
    .column = { { "mean visibility", MEAN, 3 }, { "error", ERROR, 3 }, { "surfels", SURFELS_DRAWN, 0 },
                { "time", TIME, 1 } },
    .rows = WITH_COUNT(small_rows), .claims = WITH_COUNT(small_claims), .draw = sheet_draw, .see = BUNNY_AO,
    .pictured = 1
};

/* ---- >>Figure 7 -------------------------------------------------------------------------------------------------- */

#define SEVEN "512x512, 50,000 triangles. "
#define RASTERISER "a software rasteriser draws all splats one after another"
static const paper_row ao_rows[] = {
    { .what = "screen space: HBAO", .method = "hsao", .settings = "" },
    { .what = "deep screen space", .printed = { "22" }, .method = "dss", .settings = FINE PUBLISHED_ALL, .ours = 3 },
    { .what = "the library's: near slices, shares", .method = "dss", .settings = "" },
    { .what = "screen space at full size", .method = "hsao-best", .settings = "", .note = "not in the figure" }
};
static const claim ao_claims[] = {
    { "Deep screen space is much nearer to the reference than screen space", MUCH_LESS(0, 1, 0), NULL },
    { "nearer than screen space at full size, too", LESS(0, 1, 3), NULL },
    { "Its quality is similar to the reference's (section 4)", SIMILAR(0, 1), NULL },
    { "at a speed like screen space's", ALIKE(1, 1, 0, 0.5), RASTERISER }
};
static const sheet ao_sheet = {
    .paper = "DSS14", .name = "Figure 7, first row", .title = "ambient occlusion beside screen space",
    .theirs = SEVEN "HBAO, deep screen space, ray tracing.", .ours = "The room; screen space by slices, at half size.",
    .head = { "ms" }, .column = { { "error", ERROR, 3 }, { "time", TIME, 1 }, { "bias", BIAS, 3 } },
    .rows = WITH_COUNT(ao_rows), .claims = WITH_COUNT(ao_claims), .draw = sheet_draw, .see = OWN_VIEW("room"),
    .pictured = 1
};

static const paper_row light_rows[] = {
    { .what = "screen space: SSDO", .method = "ssdo-points", .ours = 3,
      .settings = "uniform=1,sets=16,samples=16,steps=1,range=0,bounce=patch,blur=2,filter_normals=1" },
    { .what = "deep screen space, GI", .printed = { NULL, "56" }, .method = "dss-lit",
      .settings = COARSE ",epsilon=0.1,levels=5," PUBLISHED_ALL, .ours = 4 },
    { .what = "the library's screen space", .method = "ssdo", .settings = "" },
    { .what = "the library's deep screen space", .method = "dss-lit", .settings = COARSE },
    { .what = "deep screen space, DO alone", .printed = { "24" }, .method = "dss-lit",
      .settings = COARSE ",epsilon=0.1,levels=5,bounce=none," PUBLISHED_ALL }
};
static const claim light_claims[] = {
    { "Directional occlusion is nearer to the reference", LESS(0, 1, 0), NULL },
    { "The diffuse bounce is nearer to the reference", LESS(1, 1, 0), NULL },
    { "and similar to it", SIMILAR(1, 1), "surfels do not hide each other" },
    { "at higher speed", LESS(2, 1, 0), RASTERISER }
};
static const sheet light_sheet = {
    .paper = "DSS14", .name = "Figure 7, second and third row", .title = "directional occlusion and a diffuse bounce",
    .theirs = SEVEN "SSDO, deep screen space, path tracing.",
    .ours = "Bunny and four boxes under the sky and a sun; one bounce; nothing fades within the radius.",
    .head = { "DO, ms", "GI, ms" },
    .column = { { "error", ERROR, 3 }, { "bounce's error", BOUNCE_ERROR, 3 }, { "time", TIME, 1 } },
    .rows = WITH_COUNT(light_rows), .claims = WITH_COUNT(light_claims), .draw = sheet_draw, .see = WHOLE_LIGHT,
    .pictured = 1
};

#define NO_BASELINE "the library has no screen-space effect of this kind to set beside it"
static const paper_row gloss_rows[] = {
    { .what = "screen space", .note = NO_BASELINE },
    { .what = "deep screen space", .method = "dss-gloss",
      .settings = "exponent=8,size=0.03,epsilon=0.1,levels=5," SPLATS_AS, .ours = 3 },
    { .what = "the library's", .method = "dss-gloss", .settings = "exponent=8,size=0.03" },
    { .what = "the library's, smaller surfels", .method = "dss-gloss", .settings = "exponent=8",
      .note = "not in the figure" }
};
static const claim gloss_claims[] = {
    { "The quality is like the reference's", SIMILAR(0, 1),
      "surfels do not hide each other, blur what a lobe reflects by their width, and the mean of a box without a sky "
      "is small" }
};
static const sheet gloss_sheet = {
    .paper = "DSS14", .name = "Figure 7, fourth row", .title = "a specular bounce",
    .theirs = SEVEN "Screen space, deep screen space, path tracing; table 1 has no time of it.",
    .ours = "Cornell box, a lobe of exponent 8.", .column = { { "error", ERROR, 3 }, { "time", TIME, 1 } },
    .rows = WITH_COUNT(gloss_rows), .claims = WITH_COUNT(gloss_claims), .draw = sheet_draw, .see = LOBE, .pictured = 1
};

static const paper_row scatter_rows[] = {
    { .what = "screen space", .note = NO_BASELINE },
    { .what = "deep screen space", .printed = { "22" }, .method = "dss-scatter", .settings = MARBLE "," SURFELS_AS,
      .ours = 3, .note = "its levels have one way of counting" },
    { .what = "the library's", .method = "dss-scatter", .settings = MARBLE }
};
static const claim scatter_claims[] = {
    { "The quality is like that of Jensen and Buhler's sum", SIMILAR(0, 1), NULL }
};
static const sheet scatter_sheet = {
    .paper = "DSS14", .name = "Figure 7, fifth row", .title = "scattering under surfaces",
    .theirs = SEVEN "Screen space [Jimenez et al. 2009], deep screen space, the sum over 2 million samples.",
    .ours = "The bunny in marble, lit from behind; truth: the sum over 800 thousand samples.",
    .head = { "ms" }, .column = { { "error", ERROR, 3 }, { "time", TIME, 1 } },
    .rows = WITH_COUNT(scatter_rows), .claims = WITH_COUNT(scatter_claims), .draw = sheet_draw, .see = OF_MARBLE,
    .rays = 800, .pictured = 1, .stride = LIT_STRIDE
};

/* ---- >>Figure 8, Figure 9 ---------------------------------------------------------------------------------------- */

/* as published; then the library's, in rows own */
#define SPLATTED(what_, set, own) \
    { .what = what_, .method = "dss", .settings = COARSE "," set "," PUBLISHED, .ours = own }
#define OWN_SPLATTED(what_, set) { .what = what_ ", the library's", .method = "dss", .settings = COARSE "," set }
static const paper_row epsilon_rows[] = {
    SPLATTED("(a) epsilon 0.2, 4 levels", "levels=4,epsilon=0.2", 7),
    SPLATTED("(a) epsilon 0.1, 4 levels", "levels=4,epsilon=0.1", 8),
    SPLATTED("(a) epsilon 0.02, 4 levels", "levels=4,epsilon=0.02", 9),
    SPLATTED("(b) 1 level, epsilon 0.1", "levels=1,epsilon=0.1", 10),
    SPLATTED("(b) 2 levels, epsilon 0.1", "levels=2,epsilon=0.1", 11),
    SPLATTED("(b) 6 levels, epsilon 0.1", "levels=6,epsilon=0.1", 12),
    OWN_SPLATTED("(a) epsilon 0.2, 4 levels", "levels=4,epsilon=0.2"),
    OWN_SPLATTED("(a) epsilon 0.1, 4 levels", "levels=4,epsilon=0.1"),
    OWN_SPLATTED("(a) epsilon 0.02, 4 levels", "levels=4,epsilon=0.02"),
    OWN_SPLATTED("(b) 1 level, epsilon 0.1", "levels=1,epsilon=0.1"),
    OWN_SPLATTED("(b) 2 levels, epsilon 0.1", "levels=2,epsilon=0.1"),
    OWN_SPLATTED("(b) 6 levels, epsilon 0.1", "levels=6,epsilon=0.1")
};
static const claim epsilon_claims[] = {
    { "A smaller epsilon reduces blur and noise: 0.1 errs less than 0.2", LESS(0, 1, 0), NULL },
    { "and 0.02 less than 0.1", LESS(0, 2, 1), NULL },
    { "More levels reach farther: 2 err less than 1", LESS(0, 4, 3), NULL },
    { "and 6 less than 2", LESS(0, 5, 4), NULL }
};
static const sheet epsilon_sheet = {
    .paper = "DSS14", .name = "Figure 8", .title = "epsilon and levels",
    .theirs = "Pictures alone.", .ours = "Bunny on a floor, surfels of 0.03 picture heights.",
    .column = { { "error", ERROR, 3 }, { "time", TIME, 1 }, { "mean visibility", MEAN, 3 } },
    .rows = WITH_COUNT(epsilon_rows), .claims = WITH_COUNT(epsilon_claims), .draw = sheet_draw, .see = BUNNY_AO,
    .pictured = 1
};

/* one level reaches as far as five at an epsilon of 0.1: 16^2 (1/0.1 - 1) = 1/0.000433839 - 1 */
#define ONE_LEVEL "levels=1,epsilon=0.000433839"
static const paper_row size_rows[] = {
    { .what = "(a) half the resolution, enlarged", .method = "dss", .settings = COARSE "," ONE_LEVEL "," PUBLISHED,
      .half = 1, .ours = 4 },
    { .what = "(b) full resolution", .method = "dss", .settings = COARSE "," ONE_LEVEL "," PUBLISHED, .ours = 5 },
    { .what = "(c) ours: 5 levels", .method = "dss", .settings = COARSE ",levels=5,epsilon=0.1," PUBLISHED, .ours = 6 },
    { .what = "(a) the library's", .method = "dss", .settings = COARSE "," ONE_LEVEL, .half = 1 },
    { .what = "(b) the library's", .method = "dss", .settings = COARSE "," ONE_LEVEL },
    { .what = "(c) the library's", .method = "dss", .settings = COARSE ",levels=5,epsilon=0.1" }
};
static const claim size_claims[] = {
    { "Half the resolution loses details: it errs more than the full one", LESS(0, 1, 0), NULL },
    { "The full resolution is slower than levels", LESS(1, 2, 1), NULL },
    { "Levels are fastest, faster than half the resolution", LESS(1, 2, 0),
      "a quarter of the pixels saves a software rasteriser more than levels do" },
    { "and err less than half the resolution", LESS(0, 2, 0), NULL }
};
static const sheet size_sheet = {
    .paper = "DSS14", .name = "Figure 9", .title = "half resolution, full resolution, levels",
    .theirs = "Pictures alone: a window of the Sibenik cathedral.",
    .ours = "Colonnade, surfels of 0.03 picture heights; all reach as far. Enlarging is bilinear, and not in its time.",
    .column = { { "error", ERROR, 3 }, { "time", TIME, 1 } },
    .rows = WITH_COUNT(size_rows), .claims = WITH_COUNT(size_claims), .draw = sheet_halves,
    .see = OWN_VIEW("colonnade"), .pictured = 1
};

static const sheet *const sheets[] = { &stage_sheet, &small_sheet, &ao_sheet, &light_sheet, &gloss_sheet,
    &scatter_sheet, &epsilon_sheet, &size_sheet };
static const absent none[] = {
    { "Figures 1, 3, 5", "scenes that are not free to use, and diagrams" },
    { "Figure 2", "which pixels a splat meets at each level; `build/test surfels` compares levels with a sum over "
      "all surfels" },
    { "Figure 6", "an elephant that gallops: how steady shade is; `make stability` moves the camera over surfels" }
};
const paper dss_paper = { "DSS14", "Nalbach, Ritschel, Seidel 2014, Deep screen space", WITH_COUNT(sheets),
    WITH_COUNT(none) };
