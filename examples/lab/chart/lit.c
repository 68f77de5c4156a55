/* lit.c - what report.c shows of light: pictures for the demo, a chart, what layers, cameras and points buy, what
   harmonics buy. Declared in lit.h. */
#include "lab/chart/lit.h"
#include <math.h>
#include <string.h>
#include "lab/measure/measure.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"
#include "lab/page/table.h"

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

#define SCENE(name, scene, lit) { name, scene, 0, { 0 }, { 0 }, 0, 0, lit }
#define BOXES_VIEW "bunny", BUNNY, 1, { -0.1f, 1.1f, 4.4f }, { 0, -0.25f, 0 }, 32, 0.6f

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

static const entry deep_entries[] = {       /* rows of one label make one curve; directions of 4 points */
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

typedef struct lit_table {
    const char *title, *about;
    view view;
    const entry *entries;
    int count, of, quick;
} lit_table;
#define LOCAL "Suns are local: blocked within the radius as the environment is, not by the whole scene."
static const lit_table lit_demos[] = {
    { "Light: a sky and a sun",
      "Bunny and four boxes under the built-in sky and a sun with shadows.",
      { BOXES_VIEW, &sun_and_sky },
      WITH_COUNT(sun_entries),
      OF_LIT,
      0 },
    { "Light: one lamp, one bounce", "Open box under a point light with shadows, no environment.",
      SCENE("cornell", "cornell", &lamp), WITH_COUNT(lamp_entries), OF_LIT, 0 },
    { "Harmonics: two suns",
      "Three white boxes between a pink sun from the left and a turquoise one from the right. " LOCAL,
      SCENE("boxes", "boxes", &two_suns), WITH_COUNT(harmonics_entries), OF_LIT, 0 },
    { "Harmonics: the suns changed over", "The same boxes, turquoise from the left, pink from the right. " LOCAL,
      SCENE("boxes-changed", "boxes", &suns_changed), WITH_COUNT(harmonics_entries), OF_LIT, 0 },
    { "Harmonics: a sky and a bright sun",
      "White blocks under the built-in sky and a yellow sun from the right; below, their shadow side and their sunny "
      "side. " LOCAL,
      SCENE("blocks", "blocks", &yellow_sun), WITH_COUNT(harmonics_entries), OF_LIT, 0 }
};
static const lit_table lit_tables[] = {
    { "Light: speed against accuracy",
      "Bunny and four boxes under the sky, one bounce.",
      { BOXES_VIEW, &sky_boxes },
      WITH_COUNT(deep_entries),
      OF_LIT,
      1 },
    { "What light costs",
      "The same scene; 16 directions, no filter.",
      { BOXES_VIEW, &sky_boxes },
      WITH_COUNT(cost_entries),
      OF_LIT,
      0 },
    { "What is hidden: columns",
      "Made to need more than one depth layer: coloured columns behind white ones, a box beside the picture.",
      SCENE("columns", "columns", &sky_alone), WITH_COUNT(extension_entries), OF_LIT, 0 },
    { "What is hidden: plates", "Made to need more: thin plates, bars and hoops over a floor.",
      SCENE("plates", "plates", &sky_alone), WITH_COUNT(extension_entries), OF_LIT, 1 },
    { "What is hidden: room",
      "Not made for it: its walls, floor and ceiling are sheets, where layers and cameras want closed solids, and "
      "cameras stand outside.",
      SCENE("room", "room", &sky_alone), WITH_COUNT(extension_entries), OF_LIT, 0 },
    { "What harmonics cost",
      "Bunny and four boxes under the sky, no filter but where it says so. Filtering vectors is filtering before they "
      "meet the light.",
      { BOXES_VIEW, &sky_boxes },
      WITH_COUNT(vector_entries),
      OF_LIT,
      0 },
    { "Under a high-contrast probe",
      "White blocks in a dim room with coloured windows and lamps, no bounce, no filter. Hue, in degrees: the mean "
      "angle between rgb vectors, weighted by the truth's luminance; and of that, what occluders keep 5 % or more of "
      "the light from.",
      SCENE("blocks-probe", "blocks", &probe_alone), WITH_COUNT(probe_entries), OF_SPLIT, 1 }
};

/* The same entries under one light each; shown as one table. */
static const char *const bands_title = "How many bands";
#define BANDS(name, lit) SCENE(name, "boxes", lit), WITH_COUNT(band_entries), OF_LIT, 0
static const lit_table band_tables[] = {
    { "white", "White: radiance 1 from everywhere.", BANDS("boxes-white", &band_lits[0]) },
    { "sky", "Sky: the built-in one.", BANDS("boxes-sky", &band_lits[1]) },
    { "local suns", "Local suns: pink from the left, turquoise from the right. " LOCAL,
      BANDS("boxes-suns", &band_lits[2]) },
    { "suns", "Suns: the same pictures against the whole scene's sharp shadows.",
      BANDS("boxes-sharp", &band_lits[3]) },
    { "probe", "Probe: a dim room with coloured windows and lamps.", BANDS("boxes-probe", &band_lits[4]) }
};
enum {
    LIT_DEMOS = COUNT(lit_demos),
    LIT_TABLES = COUNT(lit_tables),
    BAND_TABLES = COUNT(band_tables),
    LIT_SETS = LIT_TABLES + BAND_TABLES,
    LIT_WIDTH = 320,
    LIT_HEIGHT = 180,
    PROBE_STRIDE = 14,
    PHASES = 8
};
typedef struct lit_row_set { row row[MOST_ROWS]; int count; } lit_row_set;
_Static_assert(ON_STRIDE(PROBE_STRIDE), "noise is probed where there is no truth");
static lit_row_set demo_sets[LIT_DEMOS], sets[LIT_SETS];

/* ---- >>demo ------------------------------------------------------------------------------------------------------ */

/* What stands under a heading: scene, radius, resolution, truth, and how far the truth itself is off, by tracing some
   of it with more rays. */
static int lit_about(FILE *record, stage *s, const lit_table *t, kit_error *err)
{
    char bounce[32] = "";
    kit_image probe;
    row noise;
    if (stage_trace(&probe, s, 4 * s->rays, PROBE_STRIDE, err) || score_picture(&noise, s, &probe, err)) return -1;
    kit_image_free(&probe);
    if (s->lit->bounce) snprintf(bounce, sizeof bounce, ", bounce %.3f", noise.error[2]);
    page_paragraph(record,
            "%s %zu triangles, %d x %d pixels, radius %g, linear attenuation. Truth: %d rays a pixel%s; its "
            "own error, over the means: radiance %.4f, irradiance %.4f%s.",
            t->about, s->scene.mesh.triangles, s->truth.width, s->truth.height, (double)s->radius, s->rays,
            s->stride > 1 ? ", every second pixel of every second row" : "",
            noise.error[0], noise.error[1], bounce);
    return 0;
}

enum { CROP_TIMES = 4, DEMO_WIDTH = 480, DEMO_HEIGHT = 270, DEMO_ROUNDS = 2 };

/* One figure: the picture, exposed, and its difference to the truth's exposed luminance; without a row it is the
   truth. */
static int demo_figure(FILE *record, const char *out, const stage *s, const pictured *p, const row *r,
                       const kit_image *luminance, kit_error *err)
{
    const double range = 0.2;
    kit_image whole;
    char note[64];
    if (pictures_exposed(&whole, p->picture, s->lit->exposure, NULL, 1, err)
        || pictures_save(&whole, "R,G,B", 1, out, p->slug, ".png", err))
        return -1;
    if (!r) snprintf(note, sizeof note, "%d rays a pixel", s->lit->rays);
    else if (isnan(r->relative)) snprintf(note, sizeof note, "error %.3f", r->share);
    else snprintf(note, sizeof note, "time %.2f, error %.3f", r->relative, r->share);
    page_figure(record, p->slug, p->label, note, whole.width, whole.height, r != NULL);
    if (!r) page_key(record, range);
    if (r && pictures_difference(&whole, luminance, (float)range, out, p->slug, err)) return -1;
    kit_image_free(&whole);
    return 0;
}

/* The truth, what is given, methods: whole, then in part. rows: methods, what is given. */
static int demo_figures(FILE *record, const char *out, const stage *s, const lit_table *t, const row *rows,
                        const kit_image *picture, kit_error *err)
{
    const int count = t->count + s->givens;
    pictured p[1 + MOST_ROWS];
    kit_image luminance;
    if (pictures_exposed(&luminance, &s->truth, s->lit->exposure, NULL, 1, err)) return -1;
    for (int i = 0; i <= count; ++i) {
        const int at = i > s->givens ? i - 1 - s->givens : t->count + i - 1;
        p[i].label = i ? rows[at].label : "ray-traced truth";
        p[i].picture = !i ? &s->truth : i > s->givens ? &picture[at] : &s->given[i - 1].picture;
        snprintf(p[i].slug, sizeof p[i].slug, "lit-%s-", t->view.name);
        pictures_slug(p[i].slug + strlen(p[i].slug), p[i].label);
        if (demo_figure(record, out, s, &p[i], i ? &rows[at] : NULL, &luminance, err)) return -1;
    }
    kit_image_free(&luminance);
    for (int k = 0; k < MOST_CROPS && s->lit->crop[k][2]; ++k) {
        const int *crop = s->lit->crop[k];
        if (pictures_crops(record, out, p, count + 1, k, crop, s->lit->exposure, CROP_TIMES, err)) return -1;
        page_paragraph(record, "%d x %d pixels of each, from %d, %d on, every pixel as %d x %d.",
                       crop[2], crop[3], crop[0], crop[1], CROP_TIMES, CROP_TIMES);
    }
    return 0;
}

static int demo_of(FILE *record, const char *out, const lit_table *t, row *rows, int *count, kit_error *err)
{
    kit_image picture[MOST_ROWS];
    stage s;
    if (stage_open(&s, &t->view, DEMO_WIDTH, DEMO_HEIGHT, err)
        || measure_entries(rows, &s, t->entries, t->count, DEMO_ROUNDS, 0, picture, err))
        return -1;
    page_heading(record, 2, "%s", t->title);
    if (lit_about(record, &s, t, err)) return -1;
    *count = t->count + s.givens;
    page_paragraph(record,
                   "Exposure %g, clamped at 1, sRGB; the environment itself is not drawn. Differences are of exposed "
                   "luminance.",
                   (double)s.lit->exposure);
    if (demo_figures(record, out, &s, t, rows, picture, err)) return -1;
    for (int i = 0; i < t->count; ++i) kit_image_free(&picture[i]);
    for (int i = 0; i < *count; ++i) rows[i].scene = t->view.name;
    if (table_page(record, "rows", rows, *count, err)) return -1;
    stage_close(&s);
    return 0;
}

int lit_demo(FILE *record, const char *out, kit_error *err)
{
    for (int k = 0; k < LIT_DEMOS; ++k)
        if (demo_of(record, out, &lit_demos[k], demo_sets[k].row, &demo_sets[k].count, err)) return -1;
    return 0;
}

void lit_demo_text(FILE *f)
{
    for (int k = 0; k < LIT_DEMOS; ++k) table_titled(f, lit_demos[k].title, demo_sets[k].row, demo_sets[k].count);
}

/* ---- >>chart ----------------------------------------------------------------------------------------------------- */

/* A row a number of bands, two columns a light: irradiance's error and the time. */
static void bands_table(FILE *f, const lit_row_set *band)
{
    fputs("bands  ", f);
    for (int k = 0; k < BAND_TABLES; ++k) fprintf(f, " %10s   time", band_tables[k].title);
    for (int i = 0; i < band->count; ++i) {
        fprintf(f, "\n%-7s", band->row[i].label);
        for (int k = 0; k < BAND_TABLES; ++k) {
            const row *r = &band[k].row[i];
            char error[32], time[32];
            snprintf(error, sizeof error, i < band[k].count ? "%.4f" : "-", r->error[1]);
            snprintf(time, sizeof time, i < band[k].count && !isnan(r->relative) ? "%.2f" : "-", r->relative);
            fprintf(f, " %10s %6s", error, time);
        }
    }
    fputs("\n", f);
}

static const lit_table *lit_table_at(int k) { return k < LIT_TABLES ? &lit_tables[k] : &band_tables[k - LIT_TABLES]; }

static int lit_unit(FILE *record, const options *o, int k, row *rows, kit_error *err)
{
    const lit_table *t = lit_table_at(k);
    entry entries[MOST_ENTRIES];
    kit_image picture[MOST_ENTRIES];
    const int count = units_chosen(entries, t->entries, t->count, o);
    stage s;
    if (!count || (o->quick && !t->quick)) return 0;
    if (!rows) return 1;
    if (stage_load(&s, &t->view, err)) return -1;
    s.stride = LIT_STRIDE;
    if (stage_show(&s, &t->view, LIT_WIDTH, LIT_HEIGHT, err)
        || measure_entries(rows, &s, entries, count, o->quick ? QUICK_ROUNDS : CHART_ROUNDS,
                           t->of == OF_SPLIT ? PHASES : 0, picture, err))
        return -1;
    for (int i = 0; i < count + s.givens; ++i) rows[i].scene = t->view.name;
    if (k <= LIT_TABLES) page_heading(record, 2, "%s", k < LIT_TABLES ? t->title : bands_title);
    if (lit_about(record, &s, t, err)) return -1;
    if (k < LIT_TABLES && pictures_thumbs(record, o->out, units_name(), &s, rows, picture, count, err)) return -1;
    for (int i = 0; i < count; ++i) kit_image_free(&picture[i]);
    stage_close(&s);
    return count + s.givens;
}

int lit_units(const options *o) { return units_count(lit_unit, LIT_SETS, o); }

int lit_chart(FILE *record, const options *o, kit_error *err)
{
    int shown = 0;
    page csv;
    if (page_open(&csv, err)) return -1;
    for (int k = 0; k < LIT_SETS; ++k) {
        lit_row_set *set = &sets[k];
        set->count = units_measure(record, o, "lit", k, lit_unit, set->row, err);
        if (set->count < 0) return -1;
        if (!set->count) continue;
        if (table_page(record, k ? "rows" : "light", set->row, set->count, err)) return -1;
        table_csv(csv.file, set->row, set->count, !shown++);
    }
    return page_close(&csv, o->out, "chart-lit.csv", err);
}

void lit_chart_text(FILE *f)
{
    for (int k = 0; k < LIT_TABLES; ++k) table_titled(f, lit_tables[k].title, sets[k].row, sets[k].count);
    if (!sets[LIT_TABLES].count) return;
    fprintf(f, "\n%s\n", bands_title);
    bands_table(f, sets + LIT_TABLES);
}
