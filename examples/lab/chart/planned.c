/* planned.c - measures the errors of the plan's choices, with their times on views of scenes and without times on
   scenes by seed. Declared in planned.h. */
#include "lab/chart/planned.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "lab/chart/sets.h"
#include "lab/measure/ahead.h"
#include "lab/measure/folder.h"
#include "lab/page/units.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

/* turn: of the eye about its target, in radians; radius: times the scene's own; objects: 1 for occlusion between
   objects */
typedef struct plan_view {
    const char *scene;
    int fits;
    float turn, nearer, radius;
    int objects;
} plan_view;

static const plan_view planned_views[] = {
    { "room", 1, 0, 1, 1.2f, 0 },
    { "colonnade", 1, -0.25f, 0.9f, 0.45f, 0 },
    { "columns", 1, 0.7f, 0.8f, 0.45f, 0 },
    { "pebbles", 1, 0, 1, 1.2f, 0 },
    { "casters", 1, 0.7f, 0.8f, 0.45f, 1 },
    { "iron-bed", 1, 0, 1, 1, 0 },
    { "bunny", 0, 0, 1, 1.2f, 1 },
    { "plates", 0, 0, 1, 1.2f, 0 },
    { "crowd", 0, 0, 1, 1, 1 }
};
/* "suns": two soft suns instead of an environment, a pink and a turquoise one */
static const char *const planned_lights[] = { "sky", "suns", "probe", "white" };

enum {
    PLANNED_VIEWS = COUNT(planned_views),
    PLANNED_SLOW = 20 /* a cost, in times of an unblurred 16-sample ssao */
};

/* ---- >>measuring ------------------------------------------------------------------------------------------------- */

/* Lights the stage by two soft suns, a pink and a turquoise one. */
static int planned_suns(stage *s, kit_error *err)
{
    static const kit_light suns[2] = { { KIT_SUN, { -0.75f, 0.6f, 0.27f }, { 3.3f, 0.9f, 1.9f } },
                                       { KIT_SUN, { 0.75f, 0.6f, 0.27f }, { 0.5f, 2.3f, 2.2f } } };

    enum { SOFT = 14 }; /* degrees */

    kit_image_free(&s->lighting.env);
    memset(&s->lighting.env, 0, sizeof s->lighting.env);
    for (int i = 0; i < 2; ++i)
        if (kit_env_add_sun(&s->lighting.env, &suns[i], SOFT, err)) return -1;
    s->traced = s->lighting;
    return 0;
}

/* Turns a view's eye and moves it nearer to the target. An eye that turned far aside is also lower. */
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

/* Opens the stage of a view. Returns 1; 0 if the package of the scene is missing. */
static int planned_open(stage *s, const plan_view *p, const lit *light, int suns, kit_error *err)
{
    view v = { .name = p->scene, .path = p->scene };
    for (int i = 0; view_charted(i); ++i)
        if (!strcmp(view_charted(i)->name, p->scene)) v = *view_charted(i);
    v.lit = light;
    if (v.package && access(v.path, R_OK)) return 0;
    if (stage_load(s, &v, err) || (suns && planned_suns(s, err))) return -1;
    planned_turn(&v, p, &s->scene);
    return stage_look(s, &v, SEED_WIDTH, SEED_HEIGHT, err) ? -1 : 1;
}

/* Draws and times one choice. Light is drawn as visibility times the light of an unoccluded surface. */
static int planned_draw(kit_image *out, double *time, stage *s, const ssgi_plan *p, int wanted, kit_run *fixed,
                        int timed, kit_error *err)
{
    const kit_world world = { &s->scene, &s->lighting };
    double before, after;
    kit_method m;
    kit_run run;
    *time = 0;
    if (p->method == SSGI_PLAN_METHOD_NOTHING) {
        if (kit_image_new(out, s->frame.width, s->frame.height, "Y", err)) return -1;
        for (int i = 0; i < out->width * out->height; ++i) out->data[i] = 1;
        return s->lit ? stage_dim(out, s, err) : 0;
    }
    if (kit_plan_method(&m, p, wanted, err) || kit_run_open(&run, &s->gbuffer, &m, s->radius, &world, err)
        || stage_settled(out, s, &run, 0, 1, err))
        return -1;
    if (!timed) {
        *time = (double)p->cost;
        kit_run_close(&run);
        return 0;
    }
    const double slow = kit_run_ms(&run); /* a slow choice is not drawn again: this is its time */
    before = clock_draw(fixed);
    const double ms = p->cost < PLANNED_SLOW ? clock_draw(&run) : slow;
    after = clock_draw(fixed);
    *time = ms / (0.5 * (before + after));
    kit_run_close(&run);
    return 0;
}

static int planned_measure(planned_row *r, stage *s, kit_image *truth, const char *name, int wanted, int timed,
                           kit_error *err)
{
    const kit_world world = { &s->scene, s->lit ? &s->lighting : NULL }, frame = { NULL, world.lighting };
    kit_image picture;
    kit_run fixed;
    ssgi_plan p;
    memset(r, 0, sizeof *r);
    snprintf(r->name, sizeof r->name, "%s", name);
    r->timed = timed;
    if (wanted != SSGI_PLAN_WANTED_OBJECTS
        && kit_plan_numbers(&r->captured, &s->gbuffer, &frame, s->radius, wanted, err))
        return -1;
    if (kit_plan_numbers(&r->numbers, &s->gbuffer, &world, s->radius, wanted, err)) return -1;
    r->numbers.history = r->captured.history = 1;
    if (stage_run(&fixed, s, clock_reference.method, clock_reference.settings, s->radius, err)) return -1;
    kit_run_draw(&fixed, 1);
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
        r->error[i] = r->cost[i] = (double)NAN;
        if (!ssgi_plan_choice(&p, i, &r->numbers)) continue;
        const int time = timed || p.method == SSGI_PLAN_METHOD_DSS || p.method == SSGI_PLAN_METHOD_AOF;
        if (planned_draw(&picture, &r->cost[i], s, &p, wanted, &fixed, time, err)) return -1;
        r->error[i] = kit_plan_error(&picture, truth, &s->frame, wanted);
        kit_image_free(&picture);
    }
    kit_run_close(&fixed);
    return 0;
}

static int is_lit(int wanted) { return wanted == SSGI_PLAN_WANTED_LIGHT || wanted == SSGI_PLAN_WANTED_BOUNCE; }

/* Measures the plan's choices for a wanted quantity on a stage after stage_look, and closes the stage. A quick run, of
   smaller images, traces about as many pixels by fewer rays. */
static int stage_measure(planned_row *r, stage *s, const char *name, int wanted, int rays, int timed, kit_error *err)
{
    kit_image truth;
    s->between = wanted == SSGI_PLAN_WANTED_OBJECTS;
    if (stage_trace(&truth, s, rays / stage_thrift / stage_thrift, SEED_STRIDE / stage_thrift, err)
        || (is_lit(wanted) && stage_light(s, err))
        || planned_measure(r, s, &truth, name, wanted, timed, err))
        return -1;
    kit_image_free(&truth);
    stage_close(s);
    return 0;
}

/* Measures view k for a wanted quantity. Returns 1; 0 if the package of its scene is missing. */
static int planned_view(planned_row *r, int k, int wanted, kit_error *err)
{
    const plan_view *p = &planned_views[k];
    const int lights = is_lit(wanted), white = !p->fits && k % 5 == 0;
    const int turn = (p->fits ? k : k + 1) + (wanted == SSGI_PLAN_WANTED_BOUNCE); /* each view has another light */
    const char *const light = planned_lights[white ? 3 : turn % 3];
    const int suns = !strcmp(light, "suns");
    const lit of_light = { .env = suns ? "white" : light,
                           .bounce = wanted == SSGI_PLAN_WANTED_BOUNCE,
                           .rays = SEED_RAYS,
                           .exposure = 1 };
    char name[64];
    stage s;
    const int there = planned_open(&s, p, lights ? &of_light : NULL, suns, err);
    if (there <= 0) return there;
    snprintf(name, sizeof name, "%s %g%s%s", p->scene, (double)s.radius, lights ? " " : "", lights ? light : "");
    return stage_measure(r, &s, name, wanted, of_light.rays, 1, err) ? -1 : 1;
}

int planned_views_measure(planned_row *rows, int *count, int fits, int visibility, kit_error *err)
{
    for (int k = 0; k < PLANNED_VIEWS; ++k) {
        const plan_view *p = &planned_views[k];
        if (p->fits != fits) continue;
        for (int wanted = 0, there = 1; wanted < (visibility ? 1 : p->objects ? 4 : 3) && there; ++wanted) {
            there = planned_view(&rows[*count], k, wanted, err);
            if (there < 0) return -1;
            *count += there;
        }
        kit_progress("plan", (k + 1.0) / PLANNED_VIEWS);
    }
    kit_progress("plan", 1);
    return 0;
}

/* ---- >>seeds ----------------------------------------------------------------------------------------------------- */

enum { SEED_WANTED = 3 }; /* visibility, light, bounce */

static int seed_measure(planned_row *r, int seed, int wanted, kit_error *err)
{
    const lit light = { .bounce = wanted == SSGI_PLAN_WANTED_BOUNCE, .rays = SEED_RAYS, .exposure = 1 };
    char name[32];
    const view v = { .name = name, .path = name, .lit = is_lit(wanted) ? &light : NULL };
    stage s;
    snprintf(name, sizeof name, "random:%d", seed);
    return stage_load(&s, &v, err) || stage_look(&s, &v, SEED_WIDTH, SEED_HEIGHT, err)
                   || stage_measure(r, &s, name, wanted, light.rays, 0, err)
               ? -1
               : 0;
}

/* Returns a hash of this program and its tables, on which the kept results depend. */
static uint64_t program(void) { return units_hash(KIT_HASH, "/proc/self/exe"); }

/* Measures the row of a scene by seed, or reads it from build/cache if it is there. */
static int seed_row(planned_row *r, int seed, int wanted, uint64_t key, kit_error *err)
{
    char path[128], *data;
    size_t size;
    kit_error note;
    snprintf(path, sizeof path, FOLDER_CACHE "/planned-%d-%d-%d-%016llx", seed, wanted,
             SEED_HEIGHT / stage_thrift, (unsigned long long)key);
    if (!kit_file_read(&data, &size, path, NULL)) {
        const int whole = size == sizeof *r;
        if (whole) memcpy(r, data, size);
        free(data);
        if (whole) return 0;
    }
    if (seed_measure(r, seed, wanted, err)) return -1;
    if (folder_make(FOLDER_CACHE, &note) || kit_file_write(path, r, sizeof *r, &note))
        fprintf(stderr, "report: note: measurements are not kept: %s\n", note.text);
    return 0;
}

int planned_seeds_measure(planned_row *rows, int *count, int first, int seeds, int visibility, kit_error *err)
{
    const int each = visibility ? 1 : SEED_WANTED;
    const uint64_t key = program();
    for (int k = 0; k < each * seeds; ++k) {
        if (seed_row(&rows[(*count)++], first + k / each, k % each, key, err)) return -1;
        kit_progress("plan, by seed", (k + 1.0) / (each * seeds));
    }
    kit_progress("plan, by seed", 1);
    return 0;
}

/* What keep_one keeps. */
typedef struct kept { uint64_t key; int visibility; } kept;

static int keep_one(void *of, int seed, kit_error *err)
{
    const kept *k = of;
    planned_row r;
    for (int wanted = 0; wanted < (k->visibility ? 1 : SEED_WANTED); ++wanted)
        if (seed_row(&r, seed, wanted, k->key, err)) return -1;
    return 0;
}

int planned_seeds_ahead(int first, int seeds, int visibility, const char *context, kit_error *err)
{
    kept k = { program(), visibility };
    const ahead a = { "plan, by seed", context, first, seeds, NULL, keep_one, &k };
    return ahead_run(&a, err);
}

void planned_smooth(planned_row *rows, int count)
{
    double ratio[MOST_PLANNED];
    ssgi_plan p;
    for (int c = 0; c < SSGI_PLAN_CHOICES; ++c)
        for (int pass = 0, n = 0; pass < 2; ++pass) {
            const double by = pass && n ? kit_median(ratio, n) : 1;
            for (int i = 0; i < count; ++i) {
                if (!(rows[i].cost[c] > 0) || !ssgi_plan_choice(&p, c, &rows[i].numbers)
                    || p.method == SSGI_PLAN_METHOD_DSS || p.method == SSGI_PLAN_METHOD_AOF)
                    continue;
                if (pass) rows[i].cost[c] = by * (double)p.cost;
                else if (rows[i].timed) ratio[n++] = rows[i].cost[c] / (double)p.cost;
            }
        }
}
