/* ao.c - what report.c shows of ambient occlusion: a scanned mesh with every method beside the truth, and error against
   time on every scene, with what others have beside it. Declared in ao.h. */
#include "lab/chart/ao.h"
#include <math.h>
#include <string.h>
#include <unistd.h>
#include "lab/measure/measure.h"
#include "lab/measure/peers.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"
#include "lab/page/table.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

static const entry demo_entries[] = {
    { "ssao",       "ssao",       "", 1 },
    { "hsao-fast",  "hsao-fast",  "", 1 },
    { "hsao",       "hsao",       "", 1 },
    { "hsao-best",  "hsao-best",  "", 1 },
    { "hsao-march", "hsao-march", "", 1 }
};

static const entry chart_entries[] = {      /* rows of one label make one curve */
    { "ssao",             "ssao",         "samples=8",                    1 },
    { "ssao",             "ssao",         "",                             1 },
    { "ssao",             "ssao",         "samples=32",                   1 },
    { "ssao, no blur",    "ssao",         "samples=16,blur=0",            1 },
    { "hsao-fast",        "hsao-fast",    "",                             1 },
    { "hsao, half size",  "hsao",         "directions=1,steps=8",         1 },
    { "hsao, half size",  "hsao",         "",                             1 },
    { "hsao, half size",  "hsao",         "steps=10",                     1 },
    { "hsao, half size",  "hsao",         "directions=3,steps=16",        1 },
    { "hsao, half size",  "hsao",         "directions=4,steps=24",        0 },
    { "hsao, 16 frames",  "hsao-fast",    "history=1",                    1 },
    { "hsao, 16 frames",  "hsao-history", "",                             1 },
    { "hsao, 16 frames",  "hsao-history", "thickness=slabs",              0 },
    { "hsao, full size",  "hsao-best",    "directions=1,steps=6",         1 },
    { "hsao, full size",  "hsao-best",    "",                             1 },
    { "hsao, full size",  "hsao-best",    "directions=4,steps=24",        0 },
    { "hsao, constant",   "hsao",         "thickness=constant",           1 },
    { "hsao, solid",      "hsao",         "thickness=solid",              1 },
    { "hsao, back faces", "hsao",         "thickness=back",               1 },
    { "hsao, two slabs",  "hsao-fast",    "thickness=slabs",              1 },
    { "hsao, two slabs",  "hsao",         "thickness=slabs",              1 },
    { "hsao, two slabs",  "hsao-best",    "thickness=slabs",              1 },
    { "hsao-march",       "hsao-march",   "",                             1 },
    { "march, 2 layers",  "hsao-march",   "layers=2",                     1 },
    { "march, 4 cameras", "hsao-march",   "directions=4,steps=6,views=4", 0 },
    { "hsao, margin",     "hsao",         "margin=0.25",                  1 },
    { "dss",              "dss-fast",     "",                             0 },
    { "dss",              "dss",          "",                             0 },
    { "dss",              "dss-best",     "",                             0 }
};

static const float DEMO_ERROR = 0.03f;      /* what the demo's planned row is asked for */
enum { DEMO_ROUNDS = 3, DEMO_WIDTH = 800, DEMO_HEIGHT = 450, DEMO_ENTRIES = COUNT(demo_entries) + 1,
    AO_PHASES = 2 };
_Static_assert(COUNT(chart_entries) <= MOST_ENTRIES && COUNT(demo_entries) < MOST_ENTRIES,
    "more rows than MOST_ENTRIES");

/* ---- >>demo ------------------------------------------------------------------------------------------------------ */

/* Methods, the last one planned; floor and no AO. Their pictures, until they are shown. */
static struct {
    row       row[DEMO_ENTRIES + 2];
    kit_image picture[DEMO_ENTRIES];
    int       count;
    ssgi_plan plan;
    char      settings[256];               /* of the planned one */
} shown;

static int save_legend(const char *out, kit_error *err)
{
    kit_image ramp, zero, colour;
    if (kit_image_new(&ramp, 512, 16, "Y", err) || kit_image_new(&zero, 512, 16, "Y", err)) return -1;
    for (int i = 0; i < 512 * 16; ++i) ramp.data[i] = (float)(i % 512) / 511 - 0.5f;
    if (kit_image_difference(&colour, &ramp, &zero, "Y", 0.5f, err)
        || pictures_save(&colour, "R,G,B", 0, out, "difference-legend", ".png", err))
        return -1;
    kit_image_free(&ramp);
    kit_image_free(&zero);
    kit_image_free(&colour);
    return 0;
}

/* Something to look at while the truth is traced. */
static int first_picture(stage *s, const char *out, kit_error *err)
{
    kit_image picture;
    if (stage_drawn(&picture, s, "hsao", "", s->radius, err)
        || pictures_save(&picture, "Y", 0, out, "hsao", ".png", err))
        return -1;
    kit_image_free(&picture);
    return 0;
}

/* What the plan takes for DEMO_ERROR. */
static int make_plan(stage *s, kit_error *err)
{
    const kit_world world = { &s->scene, NULL };
    ssgi_plan_scene numbers;
    if (kit_plan_numbers(&numbers, &s->gbuffer, &world, s->radius, SSGI_PLAN_WANTED_VISIBILITY, err)) return -1;
    numbers.error = DEMO_ERROR;
    numbers.budget = 20;
    return ssgi_plan_make(&shown.plan, &numbers, NULL) == SSGI_OK ? 0 : kit_fail(err, "%s: has no plan", s->name);
}

int ao_demo_measure(stage *s, const options *o, kit_error *err)
{
    entry entries[DEMO_ENTRIES];
    view mesh = stage_views[0];
    if (o->mesh) mesh = (view){ .name = o->mesh, .path = o->mesh, .ground = 1 };
    if (stage_load(s, &mesh, err) || stage_look(s, &mesh, DEMO_WIDTH, DEMO_HEIGHT, err)
        || first_picture(s, o->out, err) || stage_compare(s, err))
        return -1;
    for (int i = 0; i < 2; ++i)
        if (pictures_save(&s->truth, "Y", 0, o->out, "truth", i ? ".exr" : ".png", err)) return -1;
    if (make_plan(s, err)) return -1;
    memcpy(entries, demo_entries, sizeof demo_entries);
    const char *method = kit_plan_text(shown.settings, &shown.plan, SSGI_PLAN_WANTED_VISIBILITY);
    entries[DEMO_ENTRIES - 1] = (entry){ "planned", method, shown.settings, 1 };
    shown.count = shown.plan.method == SSGI_PLAN_METHOD_NOTHING ? DEMO_ENTRIES - 1 : DEMO_ENTRIES;
    return measure_entries(shown.row, s, entries, shown.count, DEMO_ROUNDS, 0, shown.picture, err)
                   || save_legend(o->out, err)
               ? -1
               : 0;
}

/* A method's picture and its difference to the truth. */
static int demo_figure(FILE *record, const row *r, kit_image *picture, const stage *s, const char *out, kit_error *err)
{
    static const char *const endings[2] = { ".png", ".exr" }, *const differences[2] = { "-difference.png",
                                                                                       "-difference.exr" };
    kit_image difference;
    char slug[64], note[64];
    pictures_slug(slug, r->label);
    if (kit_image_difference(&difference, picture, &s->truth, "Y", 0.5f, err)) return -1;
    for (int k = 0; k < 2; ++k) if (pictures_save(picture, "Y", 0, out, slug, endings[k], err)) return -1;
    for (int k = 0; k < 2; ++k) if (pictures_save(&difference, "R,G,B", 0, out, slug, differences[k], err)) return -1;
    kit_image_free(&difference);
    kit_image_free(picture);
    snprintf(note, sizeof note, "time %.2f, error %.3f", r->relative, r->share);
    page_figure(record, slug, r->label, note, DEMO_WIDTH, DEMO_HEIGHT, 1);
    return 0;
}

int ao_demo(FILE *record, const stage *s, const char *out, kit_error *err)
{
    char note[64];
    snprintf(note, sizeof note, "%d rays a pixel", RAYS);
    page_heading(record, 2, "Ambient occlusion");
    page_paragraph(record,
                   "%s, %zu triangles, %d x %d pixels, radius %g. Ambient visibility: white is open, black is closed.",
                   s->name, s->scene.mesh.triangles, s->truth.width, s->truth.height, (double)s->radius);
    page_figure(record, "truth", "ray-traced truth", note, DEMO_WIDTH, DEMO_HEIGHT, 0);
    page_key(record, 0.5);
    for (int i = 0; i < shown.count; ++i)
        if (demo_figure(record, &shown.row[i], &shown.picture[i], s, out, err)) return -1;
    page_paragraph(record, "Planned: ssgi_plan_make was asked for an RMSE of %g. Its answer: %s.", (double)DEMO_ERROR,
                   shown.plan.why);
    return table_page(record, "rows", shown.row, shown.count + 2, err);
}

void ao_demo_text(FILE *f)
{
    table_text(f, shown.row, shown.count + 2);
    fprintf(f, "planned for an RMSE of %g: %s\n", (double)DEMO_ERROR, shown.plan.why);
}

/* ---- >>peers: what others have, beside the library's rows -------------------------------------------------------- */

/* One line: how they stand on the chart, or why there are none. */
static const char *peers_note(void)
{
    return *peers_missing() ? peers_missing()
                            : PEERS_THEY ": the radius matched to ours, after the best fit of two numbers to each "
                                         "picture, which ours does without.";
}

/* For each peer: does the library, raw, in no more than its time err no more than the peer
   after its fit? Against how many it does, and each that it does not. */
static void peers_verdict(FILE *f, const row *rows, int methods, int count)
{
    int all = 0, met = 0;
    for (int i = methods; i < count; ++i) {
        double best = HUGE_VAL;
        for (int k = 0; k < methods; ++k) if (rows[k].relative <= rows[i].relative) best = fmin(best, rows[k].share);
        ++all;
        if (best <= rows[i].figure[FITTED]) ++met;
        else
            fprintf(f, "%s: %s (%s) errs by %.3f after its fit, the library in that time by %.3f\n", rows->scene,
                    rows[i].label, rows[i].settings, rows[i].figure[FITTED], best);
    }
    if (all)
        fprintf(f,
                "%s: the library errs no more, raw, than %d of %d settings of " PEERS_THEY " in their time after their "
                "fit\n",
                rows->scene, met, all);
}

/* ---- >>chart ----------------------------------------------------------------------------------------------------- */

enum { AO_GIVENS = 2, CHART_ROWS = MOST_ROWS + MOST_PEERS };   /* methods, floor and no AO; peers */
static row rows_of[MOST_SCENES][CHART_ROWS], mean[CHART_ROWS];
static int scenes_shown, mean_rows, method_rows;               /* rows of the mean; those that are not peers' */

static void add(double *to, double v, int scenes) { *to += v / scenes; }

/* Adds a scene's row to the mean of so many. */
static void add_row(row *m, const row *r, int scenes)
{
    add(&m->bytes, r->bytes, scenes);
    add(&m->relative, r->relative, scenes);
    add(&m->ms, r->ms, scenes);
    add(&m->share, r->share, scenes);
    add(&m->fetches, r->fetches, scenes);
    for (int j = 0; j < SPLITS; ++j) add(&m->split[j], r->split[j], scenes);
    add(&m->figure[FITTED], r->figure[FITTED], scenes);
    for (int j = PLACE_ERROR; j < PLACE_ERROR + 4 * KIT_PLACES; ++j) add(&m->figure[j], r->figure[j], scenes);
    add(&m->score.rmse, r->score.rmse, scenes);
    add(&m->score.bias, r->score.bias, scenes);
    add(&m->score.p95, r->score.p95, scenes);
    add(&m->score.ssim, r->score.ssim, scenes);
    m->score.pixels += r->score.pixels;
}

static void mean_of_scenes(void)
{
    for (int i = 0; i < mean_rows; ++i) {
        row m = rows_of[0][i];
        m.scene = "mean";
        m.bytes = m.relative = m.ms = m.share = m.fetches = m.figure[FITTED] = 0;
        for (int j = PLACE_ERROR; j < PLACE_ERROR + 4 * KIT_PLACES; ++j) m.figure[j] = 0;
        memset(&m.score, 0, sizeof m.score);
        memset(m.split, 0, sizeof m.split);
        for (int s = 0; s < scenes_shown; ++s) add_row(&m, &rows_of[s][i], scenes_shown);
        mean[i] = m;
    }
}

/* The k-th scene of those asked for, else of all that are there. */
static view view_at(const options *o, int k)
{
    view v = { .name = o->scenes ? o->scene[k] : stage_views[k].name, .path = o->scenes ? o->scene[k] : NULL };
    for (int i = 0; i < stage_views_count; ++i) if (!strcmp(stage_views[i].name, v.name)) v = stage_views[i];
    return v;
}

/* The rows that are asked for, on each scene; how many. */
static int ao_chosen(entry *out, const options *o) { return units_chosen(out, WITH_COUNT(chart_entries), o); }

int ao_entries(const options *o)
{
    entry e[MOST_ENTRIES];
    return ao_chosen(e, o);
}

static int ao_unit(FILE *record, const options *o, int k, row *rows, kit_error *err)
{
    static char names[MOST_SCENES][64];
    const view v = view_at(o, k);
    entry entries[MOST_ENTRIES];
    kit_image picture[MOST_ENTRIES];
    const int count = ao_chosen(entries, o);
    int peers;
    stage s;
    if (!count || (!o->scenes && stage_packages(v.path) && access(v.path, R_OK))) return 0;
    if (!rows) return 1;
    if (stage_load(&s, &v, err)) return -1;
    s.rays = SEED_RAYS;
    if (stage_look(&s, &v, SEED_WIDTH, SEED_HEIGHT, err)) return -1;
    s.stride = SEED_STRIDE;
    if (stage_compare(&s, err)
        || measure_entries(rows, &s, entries, count, QUICK_ROUNDS, AO_PHASES, picture, err))
        return -1;
    peers = o->method
                ? 0
                : peers_measure(rows + count + s.givens, &s, QUICK_ROUNDS, o->quick ? PEERS_QUICK : MOST_PEERS, NULL,
                                err);
    if (peers < 0) return -1;
    memcpy(names[k], s.name, sizeof names[k]);
    for (int i = 0; i < count + s.givens + peers; ++i) {
        rows[i].scene = names[k];
        if (peers) rows[i].of |= OF_PEER;
    }
    page_heading(record, 3, "%s", s.name);
    page_paragraph(record, "%zu triangles, %d x %d pixels, radius %g. Truth: %d rays at every %dth pixel both ways.",
                   s.scene.mesh.triangles, s.truth.width, s.truth.height, (double)s.radius, s.rays, s.stride);
    if (pictures_thumbs(record, o->out, units_name(), &s, rows, picture, count, err)) return -1;
    for (int i = 0; i < count; ++i) kit_image_free(&picture[i]);
    stage_close(&s);
    return count + AO_GIVENS + peers;
}

int ao_units(const options *o) { return units_count(ao_unit, o->scenes ? o->scenes : stage_views_count, o); }

static void left_out(FILE *record, const view *v)
{
    char without[256];
    snprintf(without, sizeof without, "%s: left out, %s is not there; make chart takes it from Debian's %s", v->name,
             v->path, stage_packages(v->path));
    fprintf(stderr, "report: note: %s\n", without);
    page_paragraph(record, "%s.", without);
}

/* The k-th scene: its pictures, its rows in the CSV. */
static int scene_chart(FILE *record, FILE *csv, const options *o, int k, kit_error *err)
{
    row *r = rows_of[scenes_shown];
    const int count = units_measure(record, o, "ao", k, ao_unit, r, err);
    if (count < 0) return -1;
    if (!count) {
        const view v = view_at(o, k);
        left_out(record, &v);
        return 0;
    }
    if (count < mean_rows) mean_rows = count;
    table_csv(csv, r, count, !scenes_shown++);
    return 0;
}

int ao_chart(FILE *record, const options *o, kit_error *err)
{
    const int scenes = o->scenes ? o->scenes : stage_views_count;
    page csv, each;
    mean_rows = CHART_ROWS;
    method_rows = ao_entries(o) + AO_GIVENS;
    if (page_open(&csv, err) || page_open(&each, err)) return -1;
    for (int k = 0; k < scenes; ++k) if (scene_chart(each.file, csv.file, o, k, err)) return -1;
    mean_of_scenes();
    page_heading(record, 2, "Ambient occlusion");
    page_paragraph(record, "%s", peers_note());
    if (page_csv(record, "ambient", &csv, o->out, "chart.csv", err)) return -1;
    page_heading(record, 2, "Scene by scene");
    page_into(&each, record);
    return 0;
}

void ao_text(FILE *f)
{
    fprintf(f, "ambient occlusion, %s\n", mean->scene);
    table_text(f, mean, mean_rows);
    fprintf(f, "%s\n", peers_note());
    if (mean_rows > method_rows) peers_verdict(f, mean, method_rows, mean_rows);
}
