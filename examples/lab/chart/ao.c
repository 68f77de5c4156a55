/* ao.c - the sections on ambient occlusion: the demo, a scanned mesh by every method beside the truth; and the chart of
   error against time on every scene, with other libraries' effects. Declared in chart.h. */
#include "lab/chart/chart.h"
#include <string.h>
#include <unistd.h>
#include "lab/measure/mottled.h"
#include "lab/measure/peers.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"

/* ---- >>demo ------------------------------------------------------------------------------------------------------ */

static const float DEMO_ERROR = 0.03f;      /* the RMSE that the demo asks the plan for */
enum { DEMO_ROUNDS = 3, AO_PHASES = 2 };
_Static_assert((int)MOST_ROWS + (int)MOST_PEERS <= (int)MOST_SET_ROWS, "more rows than MOST_SET_ROWS");

/* Measures the demo's methods, and the method that the plan chooses for an error of DEMO_ERROR. */
static int measure_planned(FILE *record, row *rows, stage *s, const entry *entries, int count, kit_image *picture,
                           kit_error *err)
{
    static char settings[256];
    const kit_world world = { &s->scene, NULL };
    entry all[MOST_ENTRIES];
    ssgi_plan_scene numbers;
    ssgi_plan plan;
    if (kit_plan_numbers(&numbers, &s->gbuffer, &world, s->radius, SSGI_PLAN_WANTED_VISIBILITY, err)) return -1;
    numbers.error = DEMO_ERROR;
    numbers.device = SSGI_PLAN_DEVICE_RX_6800;
    if (ssgi_plan_make(&plan, &numbers, NULL) != SSGI_OK) return kit_fail(err, "%s: has no plan", s->name);
    page_paragraph(record, "Planned: ssgi_plan_make was asked for an RMSE of %g. Its answer: %s", (double)DEMO_ERROR,
                   plan.why);
    memcpy(all, entries, (size_t)count * sizeof *all);
    const char *const method = kit_plan_text(settings, &plan, SSGI_PLAN_WANTED_VISIBILITY);
    if (method) all[count++] = (entry){ "planned", method, settings, 1 };
    return measure_entries(rows, s, all, count, DEMO_ROUNDS, 0, picture, err) ? -1 : count;
}

void ao_demo_of(const char *path) { *view_named("bunny") = (view){ .name = path, .path = path, .ground = 1 }; }

const section ao_demo = { .name = "ao", .sets = "ao-demo", .width = 800, .height = 450, .measure = measure_planned,
                          .range = 0.5 };

/* ---- >>peers: other libraries' effects beside the library's rows ------------------------------------------------- */

/* Returns one line: how the peers are scored on the chart, or why there are none. */
static const char *peers_note(void)
{
    return *peers_missing() ? peers_missing()
                            : PEERS_THEY ": the radius matched to ours, after the best fit of two numbers to each "
                                         "picture, which ours does without.";
}

/* ---- >>chart ----------------------------------------------------------------------------------------------------- */

enum { AO_GIVENS = 2 };                           /* rows of the given pictures: the floor and no AO */
static int scenes;                               /* of the chart, with those whose package is missing */

int ao_entries(const options *o)
{
    entry e[MOST_ENTRIES];
    return units_chosen(e, "ao", o);
}

static int units(const options *o)
{
    scenes = 0;
    while (o->scenes ? scenes < o->scenes : view_charted(scenes) != NULL) ++scenes;
    return scenes;
}

/* Returns the k-th view of the scenes in --scene, or without this option of all that are there. */
static view view_at(const options *o, int k)
{
    const view *known = o->scenes ? NULL : view_charted(k);
    for (int i = 0; o->scenes && !known && view_charted(i); ++i)
        if (!strcmp(view_charted(i)->name, o->scene[k])) known = view_charted(i);
    return known ? *known : (view){ .name = o->scene[k], .path = o->scene[k] };
}

static int left_out(const options *o, const view *v)
{
    return !o->scenes && v->package && access(v->path, R_OK);
}

static int unit(FILE *record, const options *o, int k, row *rows, kit_error *err)
{
    static char names[MOST_SCENES][64];
    const view v = view_at(o, k);
    entry entries[MOST_ENTRIES];
    kit_image picture[MOST_ENTRIES];
    const int count = units_chosen(entries, "ao", o);
    mottled m;
    stage s;
    if (!count || left_out(o, &v)) return 0;
    if (!rows) return 1;
    if (stage_load(&s, &v, err)) return -1;
    s.rays = SEED_RAYS;
    if (stage_look(&s, &v, SEED_WIDTH, SEED_HEIGHT, err) || mottled_open(&m, &s, err)) return -1;
    s.stride = SEED_STRIDE;
    if (stage_compare(&s, err) || measure_entries(rows, &s, entries, count, QUICK_ROUNDS, AO_PHASES, picture, err))
        return -1;
    for (int i = 0; i < count; ++i) if (mottled_row(&rows[i], &m, &s, err)) return -1;
    mottled_close(&m);
    const int peers = o->method ? 0 : peers_measure(rows + count + s.givens, &s, QUICK_ROUNDS,
                                                    o->quick ? PEERS_QUICK : MOST_PEERS, NULL, err);
    if (peers < 0) return -1;
    memcpy(names[k], s.name, sizeof names[k]);
    for (int i = 0; i < count + s.givens + peers; ++i) {
        rows[i].scene = names[k];
        if (peers) rows[i].of |= OF_PEER;
    }
    page_heading(record, 3, "%s", s.name);
    if (section_about(record, &s, "", 0, 0, err)
        || pictures_thumbs(record, o->out, units_name(), &s, rows, picture, count, err))
        return -1;
    for (int i = 0; i < count; ++i) kit_image_free(&picture[i]);
    stage_close(&s);
    return count + AO_GIVENS + peers;
}

static void head(FILE *record, const options *o)
{
    page_paragraph(record, "%s", peers_note());
    for (int k = 0; k < scenes; ++k) {
        const view v = view_at(o, k);
        char without[256];
        if (!left_out(o, &v)) continue;
        snprintf(without, sizeof without, "%s: left out, %s is not there; make chart takes it from Debian's %s",
                 v.name, v.path, v.package);
        fprintf(stderr, "report: note: %s\n", without);
        page_paragraph(record, "%s.", without);
    }
}

const section ao_chart = { .name = "ao", .csv = "chart.csv", .title = "Ambient occlusion", .kind = "ambient",
                           .parts = "Scene by scene", .units = units, .unit = unit, .head = head };
