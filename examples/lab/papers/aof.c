/* aof.c - the tables and figures of [AOF05]. Declared in sheet.h. */
#include "lab/chart/fields_stage.h"
#include "lab/papers/sheet.h"

#define RADEON "Pentium 4 at 2.8 GHz, Radeon 9800XT"
enum { FIELD_WIDTH = 320, FIELD_HEIGHT = 180, CROWD_WIDTH = 640, CROWD_HEIGHT = 360 };
static const setup bunny = { { "bunny-on-floor", BUNNY, 1, { -1.4f, 1.1f, 3.7f }, { 0, -0.13f, 0 }, 33, 0, NULL },
                             NO_SPOTS, NO_BOXES, 0, 256 };
static const setup crowd = { WHOLE("crowd", "crowd"), NO_SPOTS, NO_BOXES, 0, 16 };

/* few rays, for the sake of the largest; as published, whose caps are looked up, and by the closed form */
#define TEXELS(n) .method = "aof", .settings = "rays=32,radii=8,cap_table=64,resolution=" #n
#define CLOSED(n) .method = "aof", .settings = "rays=32,radii=8,resolution=" #n

/* Rows from .. to - 1 on the bunny's floor, beside the truth between objects. */
static int on_floor(FILE *record, const options *o, const sheet *t, int from, int to, row *rows, kit_error *err)
{
    int at[MOST_PAPER_ROWS];
    entry entries[MOST_PAPER_ROWS];
    kit_image picture[MOST_PAPER_ROWS];
    row drawn[MOST_PAPER_ROWS + 1];
    const int count = sheet_chosen(at, entries, o, t, from, to);
    stage s;
    if (!count) return 0;
    if (fields_open(&s, &bunny, FIELD_WIDTH, FIELD_HEIGHT, err)
        || fields_measure(drawn, &s, entries, count, picture, err))
        return -1;
    sheet_about(record, &s);
    if (sheet_show(record, o, t, &s, picture, drawn, at, count, rows, err)) return -1;
    stage_close(&s);
    return 0;
}

/* ---- >>Table 2 --------------------------------------------------------------------------------------------------- */

/* The paper's numbers of cubes; here so many of a hundred shapes cast. */
static const int casting[] = { 1, 5, 10, 20 };
enum { CROWD_FROM = 6 };
#define CUBES(n, fps, ms) { .what = #n " cubes, 32x32", .printed = { "97104", "316", fps, ms }, .method = "aof", \
      .settings = "rays=16,cap_table=64,resolution=4", .note = "shapes of a crowd, 4x4" }
static const paper_row resolution_rows[] = {
    { .what = "4x4", TEXELS(4), .note = "not in the paper" },
    { .what = "Tank, 8x8", .printed = { "8400", "62", "136", "7.4" }, TEXELS(8) },
    { .what = "Tank, 16x16", .printed = { "27216", "246", "136", "7.4" }, TEXELS(16) },
    { .what = "Tank, 32x32", .printed = { "97104", "989", "136", "7.4" }, TEXELS(32), .slow = 1 },
    { .what = "Tank, 64x64", .printed = { "365904", "3960", "136", "7.4" }, TEXELS(64), .slow = 1 },
    { .what = "32x32, caps by the closed form", CLOSED(32), .slow = 1, .note = "not in the paper" },
    CUBES(1, "500", "2.0"), CUBES(5, "95", "10.5"), CUBES(10, "44", "22.7"), CUBES(20, "16", "62.5")
};
static const claim resolution_claims[] = {
    { "Memory is as (N + 2)^2: 43.56 times from 8 to 64, border texels included", WITHIN(0, 4, 1, 43, 44.1), NULL },
    { "So is the bake, by the square: 64 times from 8 to 64", AS_PRINTED(1, 4, 1, 63.9),
      "a part of it is the same for any resolution" },
    { "The time of a frame stays, whatever the resolution (64 to 8)", ALIKE(2, 4, 1, 0.1), NULL },
    { "The time of a frame grows with the occluders: 31 times from 1 to 20", AS_PRINTED(2, 9, 6, 31.3),
      "one occluder's time holds the pass itself" },
    { "5.9 times from 5 to 20", AS_PRINTED(2, 9, 7, 5.94), NULL },
    { "A table takes less time than the closed form, which is \"rather expensive\" (32x32)", LESS(2, 3, 5),
      "a CPU computes an arctangent in about the time of four fetches" }
};
/* Who casts changes; what is seen stays. */
static int in_crowd(const options *o, const sheet *t, row *rows, kit_error *err)
{
    kit_run run[COUNT(casting)];
    stage s;
    if (fields_open(&s, &crowd, CROWD_WIDTH, CROWD_HEIGHT, err)) return -1;
    for (int i = 0; i < COUNT(casting); ++i) {
        const paper_row *p = &t->rows[CROWD_FROM + i];
        for (int k = 1; k < s.scene.objects; ++k) s.scene.object[k].casts = k <= casting[i];
        if (stage_run(&run[i], &s, p->method, p->settings, s.radius, err)) return -1;
        kit_run_draw(&run[i], 1);
    }
    if (clock_runs(rows + CROWD_FROM, &s, run, COUNT(casting), sheet_rounds(o), err)) return -1;
    stage_close(&s);
    return 0;
}

static int resolutions(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    sheet_blank(t, rows);
    return on_floor(record, o, t, 0, CROWD_FROM, rows, err) || in_crowd(o, t, rows, err) ? -1 : 0;
}

static const sheet resolution_sheet = {
    .paper = "AOF05", .name = "Table 2", .title = "memory, preprocessing and frame rates by resolution and occluders",
    .theirs = "A tank on a box, and cubes on a ground, 1024x768, " RADEON ". The last of the "
              "printed columns is worked out from the frame rates.",
    .erratum = "The text has 17 frames a second for 20 cubes, the table 16. (N+2)^2 6 7 2 bytes give "
               "the table's memory.",
    .ours = "Bunny on a floor at 320x180, 32 rays a sample, 8 radii, all cores; 1 to 20 shapes of a crowd at "
            "640x360. Memory: 8 bits a component, borders included. Caps are looked up in a table of 64x64.",
    .head = { "bytes", "bake, s", "fps", "ms" },
    .column = { { "kB", KILOBYTES, 1 }, { "bake, s", BAKE_SECONDS, 2 }, { "time", TIME, 2 } },
    .rows = WITH_COUNT(resolution_rows), .claims = WITH_COUNT(resolution_claims), .draw = resolutions
};

/* ---- >>Figure 5, Figure 8 ---------------------------------------------------------------------------------------- */

static int pictures_on_floor(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    sheet_blank(t, rows);
    return on_floor(record, o, t, 0, t->count, rows, err);
}

static const paper_row filtered_rows[] = {
    { .what = "left: sampled at 32x32", .method = "aof",
      .settings = "rays=32,radii=8,cap_table=64,unfiltered=1,resolution=32", .slow = 1 },
    { .what = "right: from twice the resolution, by a Gaussian", TEXELS(32), .slow = 1 }
};
static const claim filtered_claims[] = {
    { "The Gaussian takes away what undersampling shows: its RMSE is less", LESS(0, 1, 0), NULL }
};
static const sheet filtered_sheet = {
    .paper = "AOF05", .name = "Figure 5", .title = "undersampling, and a Gaussian from twice the resolution",
    .theirs = "Pictures, both of 32x32 texels a side, contrast raised.",
    .ours = "Bunny on a floor, 32 rays a sample, 8 radii.",
    .column = { { "RMSE", RMSE, 4 }, { "time", TIME, 2 } }, .rows = WITH_COUNT(filtered_rows),
    .claims = WITH_COUNT(filtered_claims), .draw = pictures_on_floor, .pictured = 1
};

static const paper_row texel_rows[] = {
    { .what = "4x4", TEXELS(4), .note = "not in the paper" }, { .what = "8x8", TEXELS(8) },
    { .what = "16x16", TEXELS(16) }, { .what = "32x32", TEXELS(32), .slow = 1 },
    { .what = "64x64", TEXELS(64), .slow = 1 },
    { .what = "32x32, caps by the closed form", CLOSED(32), .slow = 1, .note = "not in the paper" }
};
#define RAYS "from 16x16 on the rays of the bake and the cap itself err more than texels do"
static const claim texel_claims[] = {
    { "Even 8x8 shows smooth, pleasing shadows: its RMSE is 64x64's", ALIKE(0, 1, 4, 0.25), NULL },
    { "Finer cube maps are nearer to the reference: 16x16 than 8x8", LESS(0, 2, 1), NULL },
    { "32x32 than 16x16", LESS(0, 3, 2), RAYS },
    { "and 64x64 than 32x32", LESS(0, 4, 3), RAYS }
};
static const sheet texel_sheet = {
    .paper = "AOF05", .name = "Figure 8", .title = "cube maps from 8x8 to 64x64 beside a reference",
    .theirs = "Pictures: a tank on a box and its shadow on a wall; the reference took hours.",
    .ours = "Bunny on a floor, 32 rays a sample, 8 radii; the bunny itself is not shaded, as occluders do not "
            "see themselves.",
    .column = { { "RMSE", RMSE, 4 }, { "kB", KILOBYTES, 1 }, { "bake, s", BAKE_SECONDS, 2 } },
    .rows = WITH_COUNT(texel_rows), .claims = WITH_COUNT(texel_claims), .draw = pictures_on_floor, .pictured = 1
};

static const sheet *const sheets[] = { &resolution_sheet, &filtered_sheet, &texel_sheet };
static const absent none[] = {
    { "Figures 1, 2, 3, 6", "a tank, which is not free to use, and diagrams" },
    { "Figure 4", "a teapot that a ground cuts: shade within the convex hull; "
      "the scene casters has shapes that lean on each other" },
    { "Figure 7", "20 cubes that shadow each other; the 20 shapes of table 2 and the scene crowd, which has a hundred" }
};
const paper aof_paper = { "AOF05", "Kontkanen, Laine 2005, Ambient occlusion fields", WITH_COUNT(sheets),
    WITH_COUNT(none) };
