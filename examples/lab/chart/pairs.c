/* pairs.c - light on every pair of a scene and a probe, so that a method that suits only one of them is noticed.
   Declared in chart.h. */
#include "lab/chart/chart.h"
#include <math.h>
#include <string.h>
#include <unistd.h>
#include "lab/measure/csv.h"
#include "lab/page/page.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

#define INTERIOR "/usr/share/blender/datafiles/studiolights/world/interior.exr"
#define INTERIOR_PACKAGE "blender-data"

enum { PAIR_WIDTH = 320, PAIR_HEIGHT = 180 };
/* A table of lights. lit[0]: the probe alone; lit[1]: with boxes by the bunny. Noise is below 1 % of the mean. */
#define LIT(env, rays, exposure) \
    { { env, { NULL }, 0, 0, 0, rays, exposure }, { env, { NULL }, 4, 0, 0, rays, exposure } }
static const struct { const char *name; lit lit[2]; int quick; } probes[] = {
    { "sky",      LIT("sky", 256, 0.8f),      0 },
    { "windows",  LIT("windows", 1024, 0.6f), 1 },
    { "street",   LIT("street", 256, 1),      1 },
    { "interior", LIT(INTERIOR, 1024, 0.35f), 0 }
};
static const struct { const char *view; int boxes, quick; } scenes[] = {
    { "bunny-near", 1, 1 }, { "columns", 0, 0 }, { "plates", 0, 0 }, { "room", 0, 1 }, { "colonnade", 0, 0 },
    { "iron-bed", 0, 0 }
};
enum { SCENES = COUNT(scenes), PROBES = COUNT(probes), PAIRS = SCENES * PROBES, BESIDE = 3 };
static const char scalar_label[] = "true visibility times irradiance", open_label[] = "no occlusion",
                  noise_label[] = "the truth's own noise";

static char names[PAIRS][64];

/* Returns whether the package's probe can be read: OpenEXR's core decodes its compression from version 3.2 on. */
static int interior_is_there(void)
{
    static int known = -1;
    kit_image env;
    kit_error why;
    if (known >= 0) return known;
    known = !access(INTERIOR, R_OK);
    if (known && kit_env_read(&env, INTERIOR, &why)) {
        fprintf(stderr, "report: note: left out, %s\n", why.text);
        known = 0;
    }
    if (known) kit_image_free(&env);
    return known;
}

static int there(const options *o, int k)
{
    const int scene = k / PROBES, probe = k % PROBES;
    if (o->quick && !(scenes[scene].quick && probes[probe].quick)) return 0;
    const view *v = view_named(scenes[scene].view);
    if (v->package && access(v->path, R_OK)) return 0;
    return strcmp(probes[probe].lit[0].env, INTERIOR) || interior_is_there();
}

/* ---- >>section --------------------------------------------------------------------------------------------------- */

static int units(const options *o)
{
    (void)o;
    return PAIRS;
}

static int unit(FILE *record, const options *o, int k, row *rows, kit_error *err)
{
    (void)record;
    view v = *view_named(scenes[k / PROBES].view);
    entry entries[MOST_ENTRIES];
    kit_image visible;
    const int count = units_chosen(entries, "pairs", o);
    char *const name = names[k];
    stage s;
    if (!count || !there(o, k)) return 0;
    if (!rows) return 1;
    snprintf(name, sizeof *names, "%s-%s", v.name, probes[k % PROBES].name);
    v.name = name;
    v.lit = &probes[k % PROBES].lit[scenes[k / PROBES].boxes];
    if (stage_load(&s, &v, err) || stage_look(&s, &v, PAIR_WIDTH, PAIR_HEIGHT, err)) return -1;
    s.stride = LIT_STRIDE;
    s.rays = s.lit->rays;                           /* also in a quick chart: the truth's noise stays below 1 % */
    if (stage_compare(&s, err) || measure_entries(rows, &s, entries, count, QUICK_ROUNDS, 0, NULL, err)) return -1;
    row *beside = rows + count;                     /* the row of no occlusion, which measure added */
    beside[1] = beside[0];
    beside[1].label = open_label;
    if (stage_visibility(&visible, &s, err) || stage_dim(&visible, &s, err)
        || score_named(&beside[0], &s, scalar_label, &visible, err) || score_noise(&beside[2], &s, noise_label, err))
        return -1;
    for (int i = 0; i < count + BESIDE; ++i) {
        rows[i].scene = "irradiance";
        rows[i].share = rows[i].error[1] / beside[1].error[1];
    }
    kit_image_free(&visible);
    stage_close(&s);
    return count + BESIDE;
}

static void write_csv(FILE *f, const options *o, const found *all, int count)
{
    (void)o;
    fputs("scene,probe,label,method,settings,relative_time,irradiance,irradiance_bias,share,pixels\n", f);
    for (int k = 0; k < count; ++k)
        for (int i = 0; i < all[k].count; ++i) {
            const row *r = &all[k].row[i];
            fprintf(f, "\"%s\",\"%s\",\"%s\",\"%s\",\"%s\"", view_named(scenes[k / PROBES].view)->name,
                    probes[k % PROBES].name, r->label, r->method, r->settings);
            csv_figure(f, ",%.6g", r->relative);
            fprintf(f, ",%.6g,%.6g,%.6g,%zu\n", r->error[1], r->bias[1], r->share, r->score.pixels);
        }
}

static void head(FILE *record, const options *o)
{
    page_paragraph(record, "Directional occlusion within the radius, no bounce: RMSE of irradiance over that of no "
                           "occlusion, whose irradiance is exact. Below 1 a method is better than nothing.");
    if (!o->quick && access(BED, R_OK))
        page_paragraph(record, "iron-bed: left out, " BED " is not there; make chart takes it from Debian's package "
                               "sweethome3d-furniture");
    if (!o->quick && access(INTERIOR, R_OK))
        page_paragraph(record, "interior: left out, " INTERIOR " is not there; make chart takes it from Debian's "
                               "package " INTERIOR_PACKAGE);
}

const section pairs_chart = { .name = "pair", .csv = "chart-pairs.csv", .kind = "pairs",
                              .title = "Light on every pair of a scene and a probe", .units = units, .unit = unit,
                              .head = head, .write = write_csv };
