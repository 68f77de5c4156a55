/* pairs.c - what report.c shows of light on every pair of a scene and a probe: a method that suits one of them only is
   seen to. Declared in pairs.h. */
#include "lab/chart/pairs.h"
#include <math.h>
#include <string.h>
#include <unistd.h>
#include "lab/measure/measure.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"
#include "lab/page/table.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

#define INTERIOR "/usr/share/blender/datafiles/studiolights/world/interior.exr"
#define INTERIOR_PACKAGE "blender-data"

enum { PAIR_WIDTH = 320, PAIR_HEIGHT = 180 };
/* alone, and with boxes beside the bunny; as many rays as bring the truth's noise below 1 % of the mean */
#define LIT(env, rays, exposure) \
    { { env, { NULL }, 0, 0, 0, rays, exposure, NO_CROPS }, { env, { NULL }, 4, 0, 0, rays, exposure, NO_CROPS } }
static const struct { const char *name; lit lit[2]; int quick; } probes[] = {
    { "sky",      LIT("sky", 256, 0.8f),      0 },
    { "windows",  LIT("windows", 1024, 0.6f), 1 },
    { "street",   LIT("street", 256, 1),      1 },
    { "interior", LIT(INTERIOR, 1024, 0.35f), 0 }
};
static const struct { view view; int boxes, quick; } scenes[] = {
    { { "bunny", BUNNY, 1, { -0.1f, 1.1f, 4.4f }, { 0, -0.25f, 0 }, 32, 0.6f, NULL }, 1, 1 },
    { { "columns",   "columns",   0, { 0 }, { 0 }, 0, 0, NULL }, 0, 0 },
    { { "plates",    "plates",    0, { 0 }, { 0 }, 0, 0, NULL }, 0, 0 },
    { { "room",      "room",      0, { 0 }, { 0 }, 0, 0, NULL }, 0, 1 },
    { { "colonnade", "colonnade", 0, { 0 }, { 0 }, 0, 0, NULL }, 0, 0 },
    { { "iron-bed",  BED,         1, { -170, 125, 270 }, { 0, 40, 0 }, 32, 20, NULL }, 0, 0 }
};
static const entry pair_entries[] = {
    { "ssdo-fast",                   "ssdo-fast", "bounce=none",                     0 },
    { "ssdo-fast, 16 frames",        "ssdo-fast", "bounce=none,history=1",           0 },
    { "ssdo",                        "ssdo",      "bounce=none",                     1 },
    { "ssdo, light filtered",        "ssdo",      "bounce=none,restore=none",        1 },
    { "ssdo, slabs",                 "ssdo",      "bounce=none,thickness=slabs",        1 },
    { "ssdo-best",                   "ssdo-best", "bounce=none",                     0 },
    { "ssdo-best, slabs",            "ssdo-best", "bounce=none,thickness=slabs",        0 },
    { "ssdo, points",                "ssdo-points", "bounce=none",                   0 },
    { "s3ho-fast",                   "s3ho-fast", "indirect=none",                   0 },
    { "s3ho-fast, 16 frames",        "s3ho-fast", "indirect=none,history=1",         0 },
    { "s3ho",                        "s3ho",      "indirect=none",                   1 },
    { "s3ho, as published",          "s3ho",      "indirect=none,residual=0",        0 },
    { "s3ho, slabs",                 "s3ho",      "indirect=none,thickness=slabs",      0 },
    { "s3ho-best",                   "s3ho-best", "indirect=none",                   0 },
    { "ssbn",                        "ssbn",      "",                                1 },
    { "ssbn, slabs",                 "ssbn",      "thickness=slabs",                    0 },
    { "hsao-fast times irradiance",  "hsao-fast", "",                                0 },
    { "hsao times irradiance",       "hsao",      "",                                1 },
    { "hsao, slabs, times irradiance", "hsao",    "thickness=slabs",                    0 }
};
enum { SCENES = COUNT(scenes), PROBES = COUNT(probes), PAIRS = SCENES * PROBES, BESIDE = 3 };
static const char scalar_label[] = "true visibility times irradiance", open_label[] = "no occlusion",
                  noise_label[] = "the truth's own noise";
_Static_assert(COUNT(pair_entries) + BESIDE <= MOST_ROWS, "more rows than MOST_ROWS");

typedef struct pair { char name[64]; row row[MOST_ROWS]; int count; } pair;   /* entries, then those of the labels */
static pair pairs[PAIRS];

static int there(const options *o, int k)
{
    const int scene = k / PROBES, probe = k % PROBES;
    if (o->quick && !(scenes[scene].quick && probes[probe].quick)) return 0;
    if (!strcmp(scenes[scene].view.path, BED) && access(BED, R_OK)) return 0;
    return strcmp(probes[probe].lit[0].env, INTERIOR) || !access(INTERIOR, R_OK);
}

/* ---- >>measure --------------------------------------------------------------------------------------------------- */

/* The rows that are asked for, of each pair. */
static int pairs_chosen(entry *out, const options *o) { return units_chosen(out, WITH_COUNT(pair_entries), o); }

static int pair_unit(FILE *record, const options *o, int k, row *rows, kit_error *err)
{
    view v = scenes[k / PROBES].view;
    entry entries[MOST_ENTRIES];
    kit_image picture[MOST_ENTRIES], visible;
    const int count = pairs_chosen(entries, o);
    char name[64];
    stage s;
    if (!count || !there(o, k)) return 0;
    if (!rows) return 1;
    snprintf(name, sizeof name, "%s-%s", v.name, probes[k % PROBES].name);
    v.name = name;
    v.lit = &probes[k % PROBES].lit[scenes[k / PROBES].boxes];
    if (stage_load(&s, &v, err) || stage_look(&s, &v, PAIR_WIDTH, PAIR_HEIGHT, err)) return -1;
    s.stride = LIT_STRIDE;
    s.rays = s.lit->rays;                           /* a quick chart's, too: noise below 1 % is what it is for */
    if (stage_compare(&s, err) || measure_entries(rows, &s, entries, count, QUICK_ROUNDS, 0, picture, err)) return -1;
    row *beside = rows + count;                     /* measure left the open row there */
    beside[1] = beside[0];
    beside[1].label = open_label;
    if (stage_visibility(&visible, &s, err) || stage_dim(&visible, &s, err)
        || score_named(&beside[0], &s, scalar_label, &visible, err) || score_noise(&beside[2], &s, noise_label, err))
        return -1;
    snprintf(pairs[k].name, sizeof pairs[k].name, "%s", s.name);
    for (int i = 0; i < count + BESIDE; ++i) {
        rows[i].scene = pairs[k].name;
        rows[i].share = rows[i].error[1] / beside[1].error[1];
    }
    page_heading(record, 3, "%s", s.name);
    page_paragraph(record,
                   "%zu triangles, %d x %d pixels, radius %g, linear attenuation. Truth: %d rays a pixel, every "
                   "second pixel of every second row; its own noise %.4f of the mean.",
                   s.scene.mesh.triangles, s.truth.width, s.truth.height, (double)s.radius, s.rays, beside[2].error[1]);
    if (pictures_thumbs(record, o->out, units_name(), &s, rows, picture, count, err)) return -1;
    for (int i = 0; i < count; ++i) kit_image_free(&picture[i]);
    kit_image_free(&visible);
    stage_close(&s);
    return count + BESIDE;
}

int pairs_units(const options *o) { return units_count(pair_unit, PAIRS, o); }

/* ---- >>pages ----------------------------------------------------------------------------------------------------- */

/* Over the pairs: the i-th row's mean share, the worst and whose it is, how many are below 1, mean time and bias. */
typedef struct summary { double mean, worst, time, bias; int below, pairs; const char *whose; } summary;

static summary summed(int i)
{
    summary s = { 0, 0, 0, 0, 0, 0, "" };
    for (int k = 0; k < PAIRS; ++k) {
        const row *r = &pairs[k].row[i];
        if (!pairs[k].count) continue;
        s.mean += r->share;
        s.time += r->relative;
        s.bias += r->bias[1];
        s.below += r->share < 1;
        ++s.pairs;
        if (r->share > s.worst) { s.worst = r->share; s.whose = r->scene; }
    }
    s.mean /= s.pairs;
    s.time /= s.pairs;
    s.bias /= s.pairs;
    return s;
}

static const pair *first_pair(void)
{
    for (int k = 0; k < PAIRS; ++k) if (pairs[k].count) return &pairs[k];
    return NULL;
}

static void missing(FILE *f, const options *o)
{
    if (!o->quick && access(BED, R_OK))
        fprintf(f, "iron-bed: left out, " BED " is not there; make chart takes it from Debian's package "
                   "sweethome3d-furniture\n");
    if (!o->quick && access(INTERIOR, R_OK))
        fprintf(f, "interior: left out, " INTERIOR " is not there; make chart takes it from Debian's package "
                   INTERIOR_PACKAGE "\n");
}

void pairs_text(FILE *f, const options *o)
{
    const pair *first = first_pair();
    if (!first) return;
    const int rows = first->count - 1;
    fprintf(f, "\nLight on every pair of a scene and a probe: RMSE of irradiance over that of no occlusion\n");
    fprintf(f, "%-32s %-30s %6s %6s %-20s %8s %6s %7s\n", "method", "settings", "mean", "worst", "", "below 1", "time",
            "bias");
    for (int i = 0; i < rows; ++i) {
        const row *r = &first->row[i];
        const summary s = summed(i);
        char time[16] = "-", below[32];
        if (!isnan(s.time)) snprintf(time, sizeof time, "%.2f", s.time);
        snprintf(below, sizeof below, "%d of %d", s.below, s.pairs);
        fprintf(f, "%-32s %-30s %6.3f %6.3f %-20s %8s %6s %+7.3f\n", r->label, table_settings(r), s.mean, s.worst,
                s.whose, below, time, s.bias);
    }
    fprintf(f, "%-20s", "pair");
    for (int i = 0; i < rows - 1; ++i) fprintf(f, " %6d", i + 1);
    fprintf(f, " %8s %6s\n", "nothing", "noise");
    for (int k = 0; k < PAIRS; ++k) {
        const pair *p = &pairs[k];
        if (!p->count) continue;
        fprintf(f, "%-20s", p->row->scene);
        for (int i = 0; i < rows - 1; ++i) fprintf(f, " %6.3f", p->row[i].share);
        fprintf(f, " %8.4f %6.4f\n", p->row[rows - 1].error[1], p->row[rows].error[1]);
    }
    fprintf(f, "columns: the methods above in their order; nothing, noise: RMSE of no occlusion, and of the truth "
               "itself, over the mean\n");
    missing(f, o);
}

int pairs_chart(FILE *record, const options *o, kit_error *err)
{
    page csv, each;
    int shown = 0;
    if (page_open(&csv, err) || page_open(&each, err)) return -1;
    fputs("scene,probe,label,method,settings,relative_time,irradiance,irradiance_bias,share,pixels\n", csv.file);
    for (int k = 0; k < PAIRS; ++k) {
        pair *p = &pairs[k];
        p->count = units_measure(each.file, o, "pair", k, pair_unit, p->row, err);
        if (p->count < 0) return -1;
        shown += p->count > 0;
        for (int i = 0; i < p->count; ++i) {
            const row *r = &p->row[i];
            fprintf(csv.file, "\"%s\",\"%s\",\"%s\",\"%s\",\"%s\",", scenes[k / PROBES].view.name,
                    probes[k % PROBES].name, r->label, r->method, r->settings);
            if (!isnan(r->relative)) fprintf(csv.file, "%.6g", r->relative);
            fprintf(csv.file, ",%.6g,%.6g,%.6g,%zu\n", r->error[1], r->bias[1], r->share, r->score.pixels);
        }
    }
    if (shown) {
        page_heading(record, 2, "Light on every pair of a scene and a probe");
        page_paragraph(record, "Directional occlusion within the radius, no bounce: RMSE of irradiance over that of no "
                               "occlusion, whose irradiance is exact. Below 1 a method is better than nothing.");
    }
    if (page_csv(record, "pairs", &csv, o->out, "chart-pairs.csv", err)) return -1;
    page_into(&each, record);
    return 0;
}
