/* plan.c - what report.c shows of the plan: choices measured on scenes that it was not fitted on, and whether it chose
   well; and what the fit reads, whose numbers stand in ssgi.h's room >>plan. Declared in plan.h. */
#include "lab/chart/plan.h"
#include <math.h>
#include <string.h>
#include <unistd.h>
#include "lab/measure/measure.h"
#include "lab/page/page.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

/* turn: of the eye about its target, radians; radius: of the scene's own; objects: occlusion between them, too */
typedef struct plan_view { const char *scene; int fits; float turn, nearer, radius; int objects; } plan_view;
static const plan_view planned_views[] = {
    { "room", 1, 0, 1, 1.2f, 0 },      { "room", 1, -0.25f, 0.9f, 0.45f, 0 },
    { "colonnade", 1, 0, 1, 1.2f, 0 }, { "colonnade", 1, -0.25f, 0.9f, 0.45f, 0 },
    { "cornell", 1, 0, 1, 1.2f, 0 },   { "cornell", 1, -0.25f, 0.9f, 0.45f, 0 },
    { "columns", 1, 0, 1, 1.2f, 0 },   { "columns", 1, 0.7f, 0.8f, 0.45f, 0 },
    { "boxes", 1, 0, 1, 1.2f, 0 },     { "boxes", 1, 0.7f, 0.8f, 0.45f, 0 },
    { "pebbles", 1, 0, 1, 1.2f, 0 },   { "pebbles", 1, 0.7f, 0.8f, 0.45f, 0 },
    { "casters", 1, 0, 1, 1.2f, 1 },   { "casters", 1, 0.7f, 0.8f, 0.45f, 1 },
    { "groove", 1, 0, 1, 1.2f, 0 },    { "slats", 1, 0, 1, 1, 0 },
    { "slats", 1, 0.4f, 0.8f, 0.4f, 0 },       { "iron-bed", 1, 0, 1, 1, 0 },
    { "iron-bed", 1, 0.5f, 0.8f, 0.5f, 0 },    { "stairs", 1, 0, 1, 1, 0 },
    { "stairs", 1, -0.2f, 0.9f, 2, 0 },
    { "bunny", 0, 0, 1, 1.2f, 1 },     { "bunny", 0, 0.7f, 0.8f, 0.45f, 0 },
    { "grass", 0, 0, 1, 1.2f, 0 },     { "grass", 0, 0.7f, 0.8f, 0.45f, 0 },
    { "plates", 0, 0, 1, 1.2f, 0 },    { "plates", 0, 0.7f, 0.8f, 0.45f, 0 },
    { "blocks", 0, 0, 1, 1.2f, 0 },    { "crowd", 0, 0, 1, 1, 1 },
    { "hole", 0, 0, 1, 1.2f, 0 },      { "attic", 0, 0, 1, 1, 0 },
    { "attic", 0, -0.2f, 0.9f, 2, 0 }, { "maple", 0, 0, 1, 1, 0 } };
/* suns: two soft ones, pink and turquoise */
static const char *const planned_lights[] = { "sky", "suns", "probe", "white" };
/* of each wanted */
static const double planned_errors[4][6] = { { 0.015, 0.02, 0.03, 0.045, 0.07, 0.1 },
                                             { 0.03, 0.045, 0.07, 0.1, 0.15, 0.2 },
                                             { 0.03, 0.045, 0.07, 0.1, 0.15, 0.2 },
                                             { 0.01, 0.015, 0.02, 0.03, 0.05, 0.08 } };
enum {
    PLANNED_VIEWS = COUNT(planned_views),
    PLANNED_ERRORS = 6,
    PLANNED_WIDTH = 640,
    PLANNED_HEIGHT = 360,
    JUDGED_WIDTH = 480,
    JUDGED_HEIGHT = 270,
    PLANNED_LIT_WIDTH = 320,
    PLANNED_LIT_HEIGHT = 180,
    PLANNED_SLOW = 20,          /* unblurred 16-sample ssaos */
    PLANNED_STRIDE = 2,         /* of the truth, both ways; of light 3 */
    MOST_PLANNED = 4 * PLANNED_VIEWS
};

/* What choices cost and err by on one view, under one light. */
typedef struct planned_row {
    char name[64];
    ssgi_plan_scene numbers;
    /* NAN: not for this; operations and fetches of all passes, a pixel */
    double error[SSGI_PLAN_CHOICES], cost[SSGI_PLAN_CHOICES], model[SSGI_PLAN_CHOICES];
} planned_row;

/* ---- >>measuring ------------------------------------------------------------------------------------------------- */

/* Two soft suns, pink and turquoise, in place of the stage's light. */
static int planned_suns(stage *s, kit_error *err)
{
    static const kit_light suns[2] = { { KIT_SUN, { -0.75f, 0.6f, 0.27f }, { 3.3f, 0.9f, 1.9f } },
                                       { KIT_SUN, { 0.75f, 0.6f, 0.27f }, { 0.5f, 2.3f, 2.2f } } };
    enum { SOFT = 14 };                    /* degrees */
    kit_image_free(&s->lighting.env);
    memset(&s->lighting.env, 0, sizeof s->lighting.env);
    for (int i = 0; i < 2; ++i) if (kit_env_add_sun(&s->lighting.env, &suns[i], SOFT, err)) return -1;
    s->traced = s->lighting;
    return 0;
}

/* The view, turned and nearer; from well aside it is from lower, too. */
static void planned_turn(view *v, const plan_view *p, const kit_scene *scene)
{
    if (!(v->fovy > 0)) {
        memcpy(v->eye, scene->camera.eye, sizeof v->eye);
        memcpy(v->target, scene->camera.target, sizeof v->target);
        v->fovy = scene->camera.fovy;
    }
    v->radius = p->radius * (v->radius > 0 ? v->radius : scene->radius);
    const float c = cosf(p->turn), s = sinf(p->turn),
                d[3] = { v->eye[0] - v->target[0], v->eye[1] - v->target[1], v->eye[2] - v->target[2] },
                e[3] = { c * d[0] + s * d[2], p->turn > 0.5f ? 0.7f * d[1] : d[1], c * d[2] - s * d[0] };
    for (int k = 0; k < 3; ++k) v->eye[k] = v->target[k] + p->nearer * e[k];
}

/* 1; 0: its package is not there. */
static int planned_open(stage *s, const plan_view *p, const lit *light, int suns, kit_error *err)
{
    static const int judged[2] = { JUDGED_WIDTH, JUDGED_HEIGHT }, fits[2] = { PLANNED_WIDTH, PLANNED_HEIGHT },
                     is_lit[2] = { PLANNED_LIT_WIDTH, PLANNED_LIT_HEIGHT };
    const int *size = light ? is_lit : p->fits ? fits : judged;
    view v = { p->scene, p->scene, 0, { 0 }, { 0 }, 0, 0, light };
    for (int i = 0; i < stage_views_count; ++i)
        if (!strcmp(stage_views[i].name, p->scene)) { v = stage_views[i]; v.lit = light; }
    if (stage_packages(v.path) && access(v.path, R_OK)) return 0;
    if (stage_load(s, &v, err) || (suns && planned_suns(s, err))) return -1;
    planned_turn(&v, p, &s->scene);
    return stage_look(s, &v, size[0], size[1], err) ? -1 : 1;
}

static double model_of(const kit_run *run) { return KIT_FETCH_OPERATIONS * run->fetches + kit_run_operations(run); }

/* The picture of a choice, and its time; of light, what visibility leaves of an open surface's. */
static int planned_draw(kit_image *out, double *time, double *model, stage *s, const ssgi_plan *p, int wanted,
                        kit_run *fixed, kit_error *err)
{
    const kit_world world = { &s->scene, &s->lighting };
    double before, after;
    kit_method m;
    kit_run run;
    *time = *model = 0;
    if (p->method == SSGI_PLAN_NOTHING) {
        if (kit_image_new(out, s->frame.width, s->frame.height, "Y", err)) return -1;
        for (int i = 0; i < out->width * out->height; ++i) out->data[i] = 1;
        return s->lit ? stage_dim(out, s, err) : 0;
    }
    if (kit_plan_method(&m, p, wanted, err) || kit_run_open(&run, &s->gbuffer, &m, s->radius, &world, err)
        || stage_settled(out, s, &run, 0, 1, err))
        return -1;
    *model = model_of(&run);
    const double slow = kit_run_ms(&run);           /* slow choices are timed as they were first drawn */
    before = clock_draw(fixed);
    const double ms = p->cost < PLANNED_SLOW ? clock_draw(&run) : slow;
    after = clock_draw(fixed);
    *time = ms / (0.5 * (before + after));
    kit_run_close(&run);
    return 0;
}

static int planned_measure(planned_row *r, stage *s, kit_image *truth, const char *name, int wanted, kit_error *err)
{
    const kit_world world = { &s->scene, s->lit ? &s->lighting : NULL };
    kit_image picture;
    kit_run fixed;
    ssgi_plan p;
    snprintf(r->name, sizeof r->name, "%s", name);
    if (kit_plan_numbers(&r->numbers, &s->gbuffer, &world, s->radius, wanted, err)) return -1;
    r->numbers.history = 1;
    if (stage_run(&fixed, s, clock_reference.method, clock_reference.settings, s->radius, err)) return -1;
    kit_run_draw(&fixed, 1);
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
        r->error[i] = r->cost[i] = r->model[i] = (double)NAN;
        if (!ssgi_plan_choice(&p, i, &r->numbers)) continue;
        if (planned_draw(&picture, &r->cost[i], &r->model[i], s, &p, wanted, &fixed, err)) return -1;
        r->model[i] /= model_of(&fixed);
        r->error[i] = kit_plan_error(&picture, truth, &s->frame, wanted);
        kit_image_free(&picture);
    }
    kit_run_close(&fixed);
    return 0;
}

/* ---- >>judging --------------------------------------------------------------------------------------------------- */

/* needed: pairs where doing nothing errs by more; within: errors at most 1.2 times what was asked. beyond: what no
   choice meets, of which so many plans say so. */
typedef struct verdict { int pairs, good, needed, good_needed, within, beyond, told; } verdict;

static const char *plan_name(char out[320], const ssgi_plan *p, int wanted)
{
    char set[256];
    const char *name = kit_plan_text(set, p, wanted);
    snprintf(out, 320, name ? "%s %s" : "nothing", name, set);
    for (char *at = out; *at; ++at) if (*at == ',') *at = ' ';        /* CSV */
    return out;
}

static int same_plan(const ssgi_plan *a, const ssgi_plan *b)
{
    return a->method == b->method && a->thickness == b->thickness && a->half == b->half
           && a->directions == b->directions && a->steps == b->steps && a->bands == b->bands && a->history == b->history
           && a->resolution == b->resolution && !(fabsf(a->size - b->size) > 0);
}

/* What the plan takes for an error that is asked for, and the cheapest choice that meets it; below 0: none. */
typedef struct judged {
    const planned_row *row;
    double    asked;
    ssgi_plan plan, cheapest;
    int       taken, best, within, good;
} judged;

/* 0: there is no such plan. */
static int judge(judged *j, const planned_row *r, double asked, int blind, int history)
{
    ssgi_plan_scene numbers = r->numbers;
    *j = (judged){ .row = r, .asked = asked, .taken = -1, .best = -1 };
    numbers.error = (float)asked;
    numbers.history = history;
    if (blind) numbers.calibration.known = 0;
    if (ssgi_plan_make(&j->plan, &numbers, NULL) != SSGI_OK) return 0;
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
        ssgi_plan p;
        if (isnan(r->error[i]) || !ssgi_plan_choice(&p, i, &numbers)) continue;
        if (same_plan(&p, &j->plan)) j->taken = i;
        if (r->error[i] <= asked && (j->best < 0 || r->cost[i] < r->cost[j->best])) j->best = i;
    }
    if (j->best < 0 || j->taken < 0) return 1;
    j->within = r->error[j->taken] <= 1.2 * asked;
    j->good = j->within && r->cost[j->taken] <= 1.25 * r->cost[j->best] + 1e-9;
    ssgi_plan_choice(&j->cheapest, j->best, &r->numbers);
    return 1;
}

static void verdict_add(verdict *v, const judged *j)
{
    if (j->best < 0) {                                          /* nothing meets it */
        ++v->beyond;
        v->told += !j->plan.meets;
    }
    if (j->best < 0 || j->taken < 0) return;
    const int needed = j->cheapest.method != SSGI_PLAN_NOTHING;
    ++v->pairs;
    v->good += j->good;
    v->within += j->within;
    v->needed += needed;
    v->good_needed += needed && j->good;
}

static void judged_print(FILE *html, FILE *csv, const judged *j)
{
    static const char *const names[] = { "visibility", "light", "bounce", "objects" };
    const planned_row *r = j->row;
    const char *wanted = names[r->numbers.wanted];
    const int taken = j->taken, best = j->best;
    char plan[320], cheapest[320];
    plan_name(plan, &j->plan, r->numbers.wanted);
    plan_name(cheapest, &j->cheapest, r->numbers.wanted);
    fprintf(html, "<tr><td>%s<td>%s<td>%.3g<td>%s<td>%.3f<td>%.3f<td>%.2f<td>%s<td>%.3f<td>%.2f<td>%s\n", r->name,
            wanted, j->asked, plan, (double)j->plan.error, r->error[taken], r->cost[taken], cheapest, r->error[best],
            r->cost[best], j->good ? "yes" : "<b>no</b>");
    fprintf(csv, "%s,%s,%g,%s,%g,%g,%g,%s,%g,%g,%d\n", r->name, wanted, j->asked, plan, (double)j->plan.error,
            r->error[taken], r->cost[taken], cheapest, r->error[best], r->cost[best], j->good);
}

/* One row a scene and error asked for: what the plan takes, what it predicts, what is measured, what the cheapest
   choice that meets the error would cost. html, csv NULL: counts alone. */
static void planned_judge(verdict *v, FILE *html, FILE *csv, const planned_row *r, int blind, int history)
{
    for (int k = 0; k < PLANNED_ERRORS; ++k) {
        judged j;
        if (!judge(&j, r, planned_errors[r->numbers.wanted][k], blind, history)) continue;
        verdict_add(v, &j);
        if (html && j.best >= 0 && j.taken >= 0) judged_print(html, csv, &j);
    }
}

static void planned_numbers_csv(FILE *f, const planned_row *r, int fits)
{
    const ssgi_plan_scene *n = &r->numbers;
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
        if (isnan(r->error[i])) continue;
        const double value[] = { r->error[i], r->cost[i], r->model[i], (double)n->calibration.unoccluded,
                                 (double)n->calibration.hsao, (double)n->calibration.slabs,
                                 (double)n->survey.occlusion, (double)n->survey.detail, (double)n->survey.solid,
                                 (double)n->survey.slabs, (double)n->screen_radius, (double)n->albedo,
                                 (double)n->energy[0], (double)n->energy[1], (double)n->energy[2],
                                 (double)n->energy[3], n->surfels, n->splats };
        fprintf(f, "%s,%d,%d,%d", r->name, fits, n->wanted, i);
        for (int k = 0; k < COUNT(value); ++k) fprintf(f, ",%g", value[k]);
        fprintf(f, ",%d,%g\n", n->occluders, (double)n->coverage);
    }
}

/* Measures choices on the k-th view for what is wanted there. quick: fewer rays. 1; 0: its package is not there. */
static int planned_view(planned_row *r, int k, int wanted, int quick, kit_error *err)
{
    const plan_view *p = &planned_views[k];
    const int is_lit = wanted == SSGI_PLAN_LIGHT || wanted == SSGI_PLAN_BOUNCE, white = !p->fits && k % 5 == 0;
    const int turn = (p->fits ? k : k + 1) + (wanted == SSGI_PLAN_BOUNCE);      /* each view has another light */
    const char *const light = planned_lights[white ? 3 : turn % 3];
    const int suns = !strcmp(light, "suns");
    const lit of_light = { .env = suns ? "white" : light, .bounce = wanted == SSGI_PLAN_BOUNCE,
                           .rays = quick ? 128 : 384, .exposure = 1 };
    char name[64];
    stage s;
    kit_image truth;
    const int there = planned_open(&s, p, is_lit ? &of_light : NULL, suns, err);
    if (there <= 0) return there;
    s.between = wanted == SSGI_PLAN_OBJECTS;
    if (stage_trace(&truth, &s, is_lit ? of_light.rays : quick ? 64 : 256, PLANNED_STRIDE + is_lit, err)
        || (is_lit && stage_light(&s, err)))
        return -1;
    snprintf(name, sizeof name, "%s %g%s%s", p->scene, (double)s.radius, is_lit ? " " : "", is_lit ? light : "");
    if (planned_measure(r, &s, &truth, name, wanted, err)) return -1;
    kit_image_free(&truth);
    stage_close(&s);
    return 1;
}

/* The views that fit, or those that judge (which: 1, 0), of scenes that are there; how many rows, -1 = failed. quick:
   fewer. */
static int planned_all(planned_row *rows, int which, int quick, kit_error *err)
{
    int count = 0;
    for (int k = 0, shown = 0; k < PLANNED_VIEWS; ++k) {
        const plan_view *p = &planned_views[k];
        if (p->fits != which || (quick && ++shown % 3 != 1)) continue;
        for (int wanted = 0, there = 1; wanted < (p->objects ? 4 : 3) && there; ++wanted) {
            const int is_lit = wanted == SSGI_PLAN_LIGHT || wanted == SSGI_PLAN_BOUNCE;
            if (is_lit && quick && shown % 2) continue;
            there = planned_view(&rows[count], k, wanted, quick, err);
            if (there < 0) return -1;
            count += there;
        }
        kit_progress("plan", (k + 1.0) / PLANNED_VIEWS);
    }
    kit_progress("plan", 1);
    return count;
}

/* Single times are noisy: a choice's cost becomes what is predicted times the median, over the views, of what it took
   over that. Surfels and fields, which hang on the scene, stay as measured. */
static void planned_smooth(planned_row *rows, int count)
{
    double ratio[MOST_PLANNED];
    ssgi_plan p;
    for (int c = 0; c < SSGI_PLAN_CHOICES; ++c)
        for (int pass = 0, n = 0; pass < 2; ++pass) {
            const double by = pass && n ? kit_median(ratio, n) : 1;
            for (int i = 0; i < count; ++i) {
                if (!(rows[i].cost[c] > 0) || !ssgi_plan_choice(&p, c, &rows[i].numbers)
                    || p.method == SSGI_PLAN_SURFELS || p.method == SSGI_PLAN_FIELD)
                    continue;
                if (pass) rows[i].cost[c] = by * (double)p.cost;
                else ratio[n++] = rows[i].cost[c] / (double)p.cost;
            }
        }
}

/* Everything that the fit reads: examples/lab/fit.c. */
int plan_fit(const char *out, kit_error *err)
{
    static planned_row rows[MOST_PLANNED];
    page csv;
    const int count = planned_all(rows, 1, 0, err);
    if (count < 0 || page_open(&csv, err)) return -1;
    for (int i = 0; i < count; ++i) planned_numbers_csv(csv.file, &rows[i], 1);
    return page_close(&csv, out, "plan-fit.csv", err);
}

/* with a calibration, without; both without history and with */
static verdict verdicts[2];

static void plan_html_head(FILE *html)
{
    fputs("<h2>What a scene needs</h2>\n<p>ssgi_plan_make on scenes that it was not fitted on: for each error asked "
          "for, what it takes and what that turns out to err by and to cost, beside the cheapest choice that "
          "meets the error. Good: at most 1.25 times that cost, at most 1.2 times that error. Pairs whose error no "
          "choice meets are counted apart. Names: scene, radius, light.</p>\n"
          "<div "
          "class=\"wide\"><table>\n<tr><th>scene<th>wanted<th>asked<th>plan<th>predicted<th>measured<th>cost<th>"
          "cheapest that meets it<th>error<th>cost<th>good\n",
          html);
}

static void plan_html_end(FILE *html)
{
    const verdict *v = verdicts;
    fprintf(html,
            "</table></div>\n<p>Without history, as above, and with it, good: %d of %d; where doing nothing would not "
            "do: %d of %d; within 1.2 of the error alone: %d. From a survey, without a calibration: %d of %d, %d. Of "
            "errors that no choice meets the plan reports %d of %d, without a calibration %d. The same as text: "
            "<a href=\"plan.csv\">plan.csv</a>, <a href=\"plan-numbers.csv\">plan-numbers.csv</a>.</p>\n",
            v[0].good, v[0].pairs, v[0].good_needed, v[0].needed, v[0].within, v[1].good, v[1].pairs, v[1].within,
            v[0].told, v[0].beyond, v[1].told);
}

static int plan_summary(const char *out, kit_error *err)
{
    const verdict *v = verdicts;
    const struct { const char *what; int good, pairs; } lines[] = {
        { "with a calibration", v[0].good, v[0].pairs },
        { "\"with a calibration, where doing nothing would not do\"", v[0].good_needed, v[0].needed },
        { "\"with a calibration, within 1.2 of the error alone\"", v[0].within, v[0].pairs },
        { "\"without a calibration, from a survey\"", v[1].good, v[1].pairs },
        { "\"the same, within 1.2 of the error alone\"", v[1].within, v[1].pairs },
        { "\"what no choice meets, told\"", v[0].told, v[0].beyond },
        { "\"the same, without a calibration\"", v[1].told, v[1].beyond }
    };
    page csv;
    if (page_open(&csv, err)) return -1;
    fputs("what,good,pairs\n", csv.file);
    for (int i = 0; i < COUNT(lines); ++i)
        fprintf(csv.file, "%s,%d,%d\n", lines[i].what, lines[i].good, lines[i].pairs);
    return page_close(&csv, out, "plan-summary.csv", err);
}

int plan_chart(FILE *html, const options *o, kit_error *err)
{
    static planned_row rows[MOST_PLANNED];
    page csv, numbers;
    const int count = planned_all(rows, 0, o->quick, err);
    memset(verdicts, 0, sizeof verdicts);
    if (count < 0 || page_open(&csv, err) || page_open(&numbers, err)) return -1;
    planned_smooth(rows, count);
    plan_html_head(html);
    fputs("scene,wanted,asked,plan,predicted,measured,cost,cheapest,cheapest_error,cheapest_cost,good\n", csv.file);
    for (int i = 0; i < count; ++i) {
        for (int history = 0; history < 2; ++history) {
            planned_judge(&verdicts[0], history ? NULL : html, history ? NULL : csv.file, &rows[i], 0, history);
            planned_judge(&verdicts[1], NULL, NULL, &rows[i], 1, history);
        }
        planned_numbers_csv(numbers.file, &rows[i], 0);
    }
    plan_html_end(html);
    return plan_summary(o->out, err) || page_close(&csv, o->out, "plan.csv", err)
                   || page_close(&numbers, o->out, "plan-numbers.csv", err)
               ? -1
               : 0;
}

void plan_text(FILE *f)
{
    const verdict *v = verdicts;
    fprintf(f,
            "\nplan, on scenes that it was not fitted on: good %d of %d; where something is needed %d of %d; without a "
            "calibration %d of %d; what cannot be met is told %d times of %d\n",
            v[0].good, v[0].pairs, v[0].good_needed, v[0].needed, v[1].good, v[1].pairs, v[0].told, v[0].beyond);
}
