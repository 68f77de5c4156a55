/* ao.c - the sections on ambient occlusion: the demo, a scanned mesh by every method beside the truth; and the chart of
   error against time on every scene, with other libraries' effects. Declared in chart.h. */
#include "lab/chart/chart.h"
#include <string.h>
#include <unistd.h>
#include "lab/measure/peers.h"
#include "lab/page/page.h"

/* ---- >>demo ------------------------------------------------------------------------------------------------------ */

enum { DEMO_ROUNDS = 3, AO_PHASES = 2 };
_Static_assert((int)MOST_ROWS + (int)MOST_PEERS <= (int)MOST_SET_ROWS, "more rows than MOST_SET_ROWS");

static const float DEMO_ERROR = 0.03f;      /* the RMSE that the demo asks the plan for */

/* Adds the method that the plan chooses for it. */
static int planned(FILE *record, stage *s, entry *entries, int count, kit_error *err)
{
    static char settings[256];
    const kit_world world = { &s->scene, NULL };
    ssgi_plan_scene numbers;
    ssgi_plan plan;
    if (kit_plan_numbers(&numbers, &s->gbuffer, &world, s->radius, SSGI_PLAN_WANTED_VISIBILITY, err)) return -1;
    numbers.error = DEMO_ERROR;
    numbers.device = SSGI_PLAN_DEVICE_RX_6800;
    if (ssgi_plan_make(&plan, &numbers, NULL) != SSGI_OK) return kit_fail(err, "%s: has no plan", s->name);
    page_paragraph(record, "Planned: ssgi_plan_make was asked for an RMSE of %g. Its answer: %s", (double)DEMO_ERROR,
                   plan.why);
    const char *const method = kit_plan_text(settings, &plan, SSGI_PLAN_WANTED_VISIBILITY);
    if (method) entries[count++] = (entry){ "planned", method, settings, 1 };
    return count;
}

void ao_demo_of(const char *path) { *view_named("bunny") = (view){ .name = path, .path = path, .ground = 1 }; }

const section ao_demo = { .name = "ao", .sets = "ao-demo", .width = 800, .height = 450, .rounds = DEMO_ROUNDS,
                          .more = planned, .range = 0.5 };

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
    (void)record;
    static char names[MOST_SCENES][64];
    const view v = view_at(o, k);
    entry entries[MOST_ENTRIES];
    const int count = units_chosen(entries, "ao", o);
    stage s;
    if (!count || left_out(o, &v)) return 0;
    if (!rows) return 1;
    if (stage_load(&s, &v, err)) return -1;
    s.rays = SEED_RAYS;
    if (stage_look(&s, &v, SEED_WIDTH, SEED_HEIGHT, err)) return -1;
    s.stride = SEED_STRIDE;
    if (stage_compare(&s, err) || measure_entries(rows, &s, entries, count, QUICK_ROUNDS, AO_PHASES, NULL, err))
        return -1;
    const int peers = o->method ? 0 : peers_measure(rows + count + s.givens, &s, QUICK_ROUNDS,
                                                    o->quick ? PEERS_QUICK : MOST_PEERS, NULL, err);
    if (peers < 0) return -1;
    memcpy(names[k], s.name, sizeof names[k]);
    for (int i = 0; i < count + s.givens + peers; ++i) {
        rows[i].scene = names[k];
        if (peers) rows[i].of |= OF_PEER;
    }
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
                           .units = units, .unit = unit, .head = head };
