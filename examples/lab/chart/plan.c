/* plan.c - report.c's section on the plan: choices measured on scenes that it was not fitted on, and whether it chose
   well; and the data of the fit, whose results stand in ssgi.h's room >>plan. Declared in chart.h. */
#include "lab/chart/chart.h"
#include <math.h>
#include <string.h>
#include "lab/chart/planned.h"
#include "lab/page/page.h"

/* ---- >>judging --------------------------------------------------------------------------------------------------- */

/* Errors are asked for in two ways: as an RMSE, with measured costs in software, and as a relative error, with modelled
   costs on a GPU. */
enum { BY_RMSE, RELATIVE, WAYS };
static const char *const way_names[WAYS] = { "", ", relative errors on a GPU" };
enum { PLANNED_ERRORS = 6 };
/* by the way, and by the wanted quantity */
static const double planned_errors[WAYS][4][PLANNED_ERRORS] = { { { 0.015, 0.02, 0.03, 0.045, 0.07, 0.1 },
                                                                  { 0.03, 0.045, 0.07, 0.1, 0.15, 0.2 },
                                                                  { 0.03, 0.045, 0.07, 0.1, 0.15, 0.2 },
                                                                  { 0.01, 0.015, 0.02, 0.03, 0.05, 0.08 } },
                                                                { { 0.25, 0.3, 0.35, 0.4, 0.5, 0.6 },
                                                                  { 0.3, 0.35, 0.4, 0.5, 0.6, 0.7 },
                                                                  { 0.4, 0.45, 0.5, 0.6, 0.7, 0.8 },
                                                                  { 0.1, 0.15, 0.2, 0.3, 0.4, 0.5 } } };
/* Verdicts on plans: each counts the plans for which it is true or might be. GOOD: at most 1.2 times the error asked
   for, at most 1.25 times the cost of the cheapest choice that meets it. TOLD: the plan says if no choice meets it. MET
   and DEAR count where doing nothing would not do: within 5 % of the error asked for, as the plan promises; and above
   1.5 times the cost of the cheapest choice within them. */
enum { GOOD, GOOD_NEEDED, WITHIN, TOLD, MET, DEAR, VERDICTS };
static const char *const verdict_names[VERDICTS] = { "", ", where doing nothing would not do",
                                                     ", within 1.2 of the error alone",
                                                     ", what no choice meets: told",
                                                     ", within 1.05 where doing nothing would not do",
                                                     ", above 1.5 of the cost there" };
#define PROMISED 1.05
typedef struct verdict { int is[VERDICTS], of[VERDICTS]; } verdict;

static void count(verdict *v, int k, int is)
{
    v->is[k] += is;
    ++v->of[k];
}

static const char *plan_name(char out[320], const ssgi_plan *p, int wanted)
{
    char settings[256];
    const char *name = kit_plan_text(settings, p, wanted);
    snprintf(out, 320, "%s%s%s", name ? name : "nothing", name && *settings ? " " : "", name ? settings : "");
    for (char *at = out; *at; ++at) if (*at == ',') *at = ' ';        /* a comma would begin another cell of the csv */
    return out;
}

static int same_plan(const ssgi_plan *a, const ssgi_plan *b)
{
    return a->method == b->method && a->thickness == b->thickness && a->resolution == b->resolution
           && a->slices == b->slices && a->samples == b->samples && a->bands == b->bands && a->history == b->history
           && a->field_resolution == b->field_resolution && !(fabsf(a->surfel_size - b->surfel_size) > 0);
}

/* How a plan knows its scene: by rays; by a survey; by the part of a survey that a captured frame gives. */
enum { CALIBRATED, SURVEYED, CAPTURED, KNOWN };

/* Returns the measured error of an image without occlusion. */
static double nothing_of(const planned_row *r)
{
    ssgi_plan p;
    int i = 0;
    while (!ssgi_plan_choice(&p, i, &r->numbers)) ++i;                /* nothing is the first choice of each quantity */
    return r->error[i];
}

/* Compares the plan for an error with the cheapest measured choice that meets it. Writes to table (NULL: none) the
   plan's choice, its predicted error, its measured error and cost; the cheapest choice, its error and cost. */
static void judge(verdict *v, FILE *table, const planned_row *r, double asked, int known, int history, int way)
{
    static const char *const names[] = { "visibility", "light", "bounce", "objects" };
    ssgi_plan_scene numbers = known == CAPTURED ? r->captured : r->numbers;
    ssgi_plan plan, cheapest, p;
    double cost[SSGI_PLAN_CHOICES], least = HUGE_VAL;
    int taken = -1, best = -1;
    char text[2][320];
    numbers.error = (float)asked;
    numbers.unit = way == RELATIVE ? SSGI_PLAN_UNIT_RELATIVE : SSGI_PLAN_UNIT_RMSE;
    numbers.device = way == RELATIVE ? SSGI_PLAN_DEVICE_RX_6800 : SSGI_PLAN_DEVICE_SOFTWARE;
    asked *= way == RELATIVE ? nothing_of(r) : 1;
    numbers.history = history;
    if (known != CALIBRATED) numbers.calibration.known = 0;
    if (!(numbers.screen_radius > 0) || ssgi_plan_make(&plan, &numbers, NULL) != SSGI_OK) return;
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
        if (isnan(r->error[i]) || !ssgi_plan_choice(&p, i, &numbers)) continue;
        cost[i] = way == RELATIVE ? (double)p.cost : r->cost[i];
        if (same_plan(&p, &plan)) taken = i;
        if (r->error[i] <= asked && (best < 0 || cost[i] < cost[best])) best = i;
        if (r->error[i] <= PROMISED * asked) least = fmin(least, cost[i]);
    }
    if (taken >= 0 && least > 0 && least < HUGE_VAL) {                /* 0: doing nothing does */
        count(v, MET, r->error[taken] <= PROMISED * asked);
        count(v, DEAR, cost[taken] > 1.5 * least);
    }
    if (best < 0) count(v, TOLD, !plan.meets);
    if (best < 0 || taken < 0) return;
    const int within = r->error[taken] <= 1.2 * asked,
              good = within && cost[taken] <= 1.25 * cost[best] + 1e-9;
    ssgi_plan_choice(&cheapest, best, &numbers);
    count(v, GOOD, good);
    count(v, WITHIN, within);
    if (cheapest.method != SSGI_PLAN_METHOD_NOTHING) count(v, GOOD_NEEDED, good);
    if (table)
        fprintf(table, "%s,%s,%g,%s,%g,%g,%g,%s,%g,%g,%d\n", r->name, names[r->numbers.wanted], asked,
                plan_name(text[0], &plan, r->numbers.wanted), (double)plan.error, r->error[taken], cost[taken],
                plan_name(text[1], &cheapest, r->numbers.wanted), r->error[best], cost[best], good);
}

/* Writes a row's numbers as lines of a csv. fits: 1; 2 if its choices were not timed. */
static void planned_numbers_csv(FILE *f, const planned_row *r, int fits)
{
    const ssgi_plan_scene *n = &r->numbers;
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
        if (isnan(r->error[i])) continue;
        const double value[] = { r->error[i], r->cost[i], (double)n->calibration.unoccluded,
                                 (double)n->calibration.hsao, (double)n->calibration.slabs,
                                 (double)n->calibration.fast, (double)n->calibration.s3ho,
                                 (double)n->survey.occlusion, (double)n->survey.detail, (double)n->survey.solid,
                                 (double)n->survey.slabs, (double)n->screen_radius,
                                 (double)n->energy[0], (double)n->energy[1], (double)n->energy[2],
                                 (double)n->energy[3], n->surfels, n->splats };
        fprintf(f, "%s,%d,%d,%d", r->name, fits, n->wanted, i);
        for (int k = 0; k < COUNT(value); ++k) fprintf(f, ",%g", value[k]);
        const ssgi_survey *seen = &r->captured.survey;
        fprintf(f, ",%d,%g,%g,%g,%g\n", n->occluders, (double)n->coverage, (double)seen->occlusion,
                (double)seen->detail, (double)seen->solid);
    }
}

int plan_fit_ahead(const options *o, kit_error *err)
{
    return planned_seeds_ahead(0, PLANNED_SEEDS, o->visibility, o->context, err);
}

int plan_ahead(const options *o, kit_error *err)
{
    return planned_seeds_ahead(SEEDS_JUDGED, PLANNED_JUDGES, o->quick || o->visibility, o->context, err);
}

/* Writes the csv that examples/lab/fit.c reads. */
int plan_fit(const options *o, kit_error *err)
{
    static planned_row rows[MOST_PLANNED];
    page table;
    int count = 0;
    if (planned_views_measure(rows, &count, 1, o->visibility, err)
        || planned_seeds_measure(rows, &count, 0, PLANNED_SEEDS, o->visibility, err) || page_open(&table, err))
        return -1;
    for (int i = 0; i < count; ++i) planned_numbers_csv(table.file, &rows[i], rows[i].timed ? 1 : 2);
    return page_close(&table, o->out, "plan-fit.csv", err);
}

/* Two sets of scenes: named ones and those by seed. A set's verdicts, by how the plan is asked and how it knows a
   scene, count plans with and without history. */
enum { SCENES, SEEDS, SETS };
static verdict verdicts[WAYS][SETS][KNOWN];

static const char *const known_names[KNOWN] = { "with a calibration", "without a calibration, from a survey",
                                                "of a captured frame: survey without slabs, no surfels" };
static const char *const set_names[SETS] = { "scenes", "by seed" };

/* Writes the verdicts. */
static int plan_summary(FILE *record, const char *out, kit_error *err)
{
    page table;
    if (page_open(&table, err)) return -1;
    fputs("what,good,pairs\n", table.file);
    for (int k = 0; k < WAYS * SETS * KNOWN; ++k) {
        const verdict *v = &verdicts[k / KNOWN / SETS][k / KNOWN % SETS][k % KNOWN];
        for (int i = 0; i < VERDICTS && v->of[GOOD]; ++i)
            fprintf(table.file, "\"%s%s, %s%s\",%d,%d\n", set_names[k / KNOWN % SETS], way_names[k / KNOWN / SETS],
                    known_names[k % KNOWN], verdict_names[i], v->is[i], v->of[i]);
    }
    return page_csv(record, "rows", &table, out, "plan-summary.csv", err);
}

/* Judges rows first .. count - 1, which are of one set, counts the verdicts, and writes a table (NULL: none). */
static void judge_all(int scenes, FILE *table, const planned_row *rows, int first, int count)
{
    for (int i = first; i < count; ++i)
        for (int known = 0; known < KNOWN; ++known)
            for (int k = 0; k < WAYS * 2 * PLANNED_ERRORS; ++k) {
                const int way = k / PLANNED_ERRORS / 2, history = k / PLANNED_ERRORS % 2;
                judge(&verdicts[way][scenes][known], known == CALIBRATED && !history && !way ? table : NULL, &rows[i],
                      planned_errors[way][rows[i].numbers.wanted][k % PLANNED_ERRORS], known, history, way);
            }
}

int plan_chart(FILE *record, const options *o, kit_error *err)
{
    static planned_row rows[MOST_PLANNED];
    page table;
    int views = 0, count;
    if (planned_views_measure(rows, &views, 0, o->quick || o->visibility, err)) return -1;
    count = views;
    if (planned_seeds_measure(rows, &count, SEEDS_JUDGED, PLANNED_JUDGES, o->quick || o->visibility, err)
        || page_open(&table, err))
        return -1;
    fputs("scene,wanted,asked,plan,predicted,measured,cost,cheapest,cheapest_error,cheapest_cost,good\n", table.file);
    memset(verdicts, 0, sizeof verdicts);
    planned_smooth(rows, count);
    judge_all(SCENES, table.file, rows, 0, views);
    judge_all(SEEDS, NULL, rows, views, count);
    page_heading(record, 2, "What a scene needs");
    page_paragraph(record,
                   "ssgi_plan_make on scenes that it was not fitted on: for each error asked for, its choice and the "
                   "error and the cost of that, beside the cheapest choice that meets the error. Good: "
                   "at most 1.25 times that cost, at most 1.2 times that error. Pairs whose error no choice meets are "
                   "counted apart. Names: scene, radius, light.");
    return plan_summary(record, o->out, err) || page_csv(record, "plan", &table, o->out, "plan.csv", err)
               ? -1
               : 0;
}
