/* stage.c - a scene, its light, its G-buffer and its truth, which is kept under build/cache; draws methods on it.
   Declared in stage.h. */
#include "lab/measure/stage.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "lab/measure/folder.h"

#define PACKAGE "glmark2-data"             /* the package of Debian that has BUNNY */

int stage_thrift = 1;

/* ---- >>views ----------------------------------------------------------------------------------------------------- */

int stage_model(char path[128], int i)
{
    int models = 0;
    while (kit_scene_model(models)) ++models;
    if (models) snprintf(path, 128, "model:%s:%d", kit_scene_model((int)(i * 263LL % models)), i);
    return models > 0;
}

/* Four coloured boxes around the bunny, just above the floor: six bounds, then the albedo. */
static const float boxes[4][9] = {
    {  1.07f, -0.989f, -0.10f,  1.25f, -0.20f,  0.75f,  0.85f, 0.08f, 0.05f },
    {  0.25f, -0.989f,  0.82f,  0.62f, -0.72f,  1.14f,  0.85f, 0.60f, 0.04f },
    { -1.55f, -0.989f, -0.55f, -0.85f, -0.35f, -0.35f,  0.08f, 0.55f, 0.08f },
    { -0.95f, -0.989f,  0.55f, -0.65f, -0.70f,  0.90f,  0.06f, 0.14f, 0.80f }
};

/* ---- >>truth ----------------------------------------------------------------------------------------------------- */

int stage_trace(kit_image *out, const stage *s, int rays, int stride, kit_error *err)
{
    const otherwise *l = &s->otherwise;
    const int attenuation = l->hard ? KIT_ATTENUATION_NONE : KIT_ATTENUATION_LINEAR;
    ssgi_dipole dipole;
    const kit_material *m;
    if (l->kind == GLOSS)
        return kit_truth_gloss(out, &s->scene, &s->gbuffer.camera, &s->traced, s->radius, attenuation,
                               (double)l->exponent, rays, stride, err);
    if (l->kind == SCATTER) {
        for (int i = 0; (m = kit_material_of(i)) && strcmp(m->name, l->material);) ++i;
        if (!m || ssgi_dipole_set(&dipole, m->sigma_s, m->sigma_a, m->eta, NULL) != SSGI_OK)
            return kit_fail(err, "%s: there is no such material", l->material);
        return kit_truth_scatter(out, &s->scene, &s->gbuffer.camera, &s->traced, &dipole, l->unit, 1000 * (size_t)rays,
                                 stride, err);
    }
    if (s->lit)
        return kit_truth_lit(out, &s->scene, &s->gbuffer.camera, &s->traced, s->radius, attenuation, s->lit->bounce,
                             rays, stride, err);
    if (s->between) return kit_truth_objects(out, &s->scene, &s->gbuffer.camera, rays, stride, err);
    return kit_truth_ao(out, &s->scene, &s->gbuffer.camera, s->radius, KIT_ATTENUATION_LINEAR, rays, stride, err);
}

/* Makes the path of a kept truth. Its name has a hash of all that the truth depends on. paired: it is of stage_pair. */
static void truth_path(char path[256], const stage *s, int paired)
{
    const kit_camera *c = &s->gbuffer.camera;
    const kit_mesh *mesh = &s->scene.mesh;
    const kit_image *env = &s->traced.env;
    const size_t floats = 9 * mesh->triangles * sizeof(float);
    uint64_t h = kit_hash(KIT_HASH, mesh->position, floats);
    h = kit_hash(h, mesh->normal, floats);
    h = kit_hash(h, c, sizeof *c);
    h = kit_hash(h, &s->radius, sizeof s->radius);
    if (s->lit) {
        h = kit_hash(h, mesh->albedo, floats / 3);
        if (env->data) h = kit_hash(h, env->data, 3 * sizeof(float) * (size_t)env->width * (size_t)env->height);
        h = kit_hash(h, s->traced.light, (size_t)s->traced.lights * sizeof(kit_light));
        if (s->traced.reach > 0) h = kit_hash(h, &s->traced.reach, sizeof s->traced.reach);
        if (s->otherwise.hard || s->otherwise.kind) h = kit_hash(h, &s->otherwise, offsetof(otherwise, material));
        if (s->otherwise.material) h = kit_hash(h, s->otherwise.material, strlen(s->otherwise.material));
    }
    if (s->between) h = kit_hash(h, mesh->object, mesh->triangles * sizeof *mesh->object);
    for (int i = 0; i < s->scene.objects && s->between; ++i)
        h = kit_hash(h, &s->scene.object[i].casts, sizeof s->scene.object[i].casts);
    if (s->stride > 1) h = kit_hash(h, &s->stride, sizeof s->stride);
    snprintf(path, 256, FOLDER_CACHE "/%s-%s%dx%d-%g-%d-%016llx.exr", s->name,
             paired                       ? "pair-"
             : s->between                 ? "objects-"
             : !s->lit                    ? ""
             : s->otherwise.kind == GLOSS ? "gloss-"
             : s->otherwise.kind          ? "scatter-"
             : s->lit->bounce             ? "lit-"
                                          : "direct-",
             c->width, c->height, (double)s->radius, s->rays, (unsigned long long)h);
}

/* Returns whether a kept truth is still valid: traces a few hundred of its pixels again, fewer if it has a stride, so
   that a changed tracer does not reuse it. -1 = failed. */
static int truth_holds(const stage *s, kit_error *err)
{
    const kit_camera *c = &s->gbuffer.camera;
    const size_t pixels = (size_t)c->width * (size_t)c->height;
    const int stride = s->stride > 1 ? s->stride : 1, odd = 60 / stride | 1;      /* odd: the middles agree */
    kit_image probe;
    int same = s->truth.width == c->width && s->truth.height == c->height;
    if (stage_trace(&probe, s, s->rays, odd * stride, err)) return -1;
    for (int k = 0; k < probe.channels && same; ++k) {
        const float *was = kit_image_channel(&s->truth, probe.name[k]), *is = kit_image_channel(&probe, probe.name[k]);
        same = was != NULL;
        for (size_t i = 0; i < pixels && same; ++i) same = isnan(is[i]) || isnan(was[i]) || is[i] == was[i];
    }
    kit_image_free(&probe);
    return same;
}

int stage_truth(stage *s, kit_error *err)
{
    char path[256];
    kit_error note;
    truth_path(path, s, 0);
    if (!kit_exr_read(&s->truth, path, NULL)) {
        const int holds = truth_holds(s, err);
        if (holds) return holds < 0 ? -1 : 0;
        kit_image_free(&s->truth);
    }
    if (stage_trace(&s->truth, s, s->rays, s->stride > 1 ? s->stride : 1, err)) return -1;
    if (folder_make(FOLDER_CACHE, &note) || kit_exr_write(&s->truth, path, &note))
        fprintf(stderr, "report: note: the truth is not kept: %s\n", note.text);
    return 0;
}

int stage_pair(kit_image *out, const stage *s, kit_error *err)
{
    stage whole = *s;
    char path[256];
    whole.rays = PAIR_RAYS;
    whole.stride = whole.between = 0;
    whole.lit = NULL;
    truth_path(path, &whole, 1);
    if (!kit_exr_read(out, path, NULL)) return 0;
    if (kit_truth_pair(out, &s->scene, &s->gbuffer.camera, s->radius, PAIR_RAYS, err)) return -1;
    return folder_make(FOLDER_CACHE, err) ? -1 : kit_exr_write(out, path, err);
}

int stage_visibility(kit_image *out, const stage *s, kit_error *err)
{
    stage dark = *s;
    char *end = strrchr(dark.name, '-');            /* all probes of a pair's scene share one truth of visibility */
    if (end) *end = 0;
    dark.lit = NULL;
    dark.rays = RAYS;
    memset(&dark.truth, 0, sizeof dark.truth);
    if (stage_truth(&dark, err)) return -1;
    *out = dark.truth;
    return 0;
}

int stage_dim(kit_image *visibility, const stage *s, kit_error *err)
{
    if (!s->givens) return kit_fail(err, "%s: ambient visibility has no environment to dim", s->name);
    return kit_dim(visibility, &s->given[0].picture, &s->direct, err);
}

int stage_run(kit_run *run, stage *s, const char *method, const char *set, float radius, kit_error *err)
{
    const kit_world world = { &s->scene, &s->lighting };
    return picture_run(run, &s->gbuffer, &world, method, set, radius, err);
}

int stage_settled(kit_image *out, const stage *s, kit_run *run, unsigned first, int timed, kit_error *err)
{
    return picture_settled(run, first, timed, err) < 0 || kit_run_read(out, run, err)
                   || (s->lit && !run->lit && stage_dim(out, s, err))
               ? -1
               : 0;
}

int stage_drawn(kit_image *out, stage *s, const char *method, const char *set, float radius, kit_error *err)
{
    const kit_world world = { &s->scene, &s->lighting };
    if (picture_drawn(out, &s->gbuffer, &world, method, set, radius, err)) return -1;
    return s->lit && out->channels == 1 ? stage_dim(out, s, err) : 0;
}

/* ---- >>beside: rows beside the methods --------------------------------------------------------------------------- */

static int give(stage *s, const char *label, const char *method, kit_image *picture)
{
    s->given[s->givens++] = (given){ label, method, *picture };
    return 0;
}

/* Adds a given picture without AO. Its radius is so small that nothing blocks the environment, nor local suns. */
static int give_open(stage *s, kit_error *err)
{
    kit_image picture;
    const char *set = s->lit->local ? "bounce=none,blur=0,shadows=none" : "bounce=none,blur=0";
    return stage_drawn(&picture, s, "ssdo-points", set, 1e-4f * s->radius, err) ? -1
                                                                               : give(s, "no AO", "none", &picture);
}

/* Adds a given picture, the floor: the truth that knows only one depth layer, the frame as it is drawn. */
static int give_floor(stage *s, kit_error *err)
{
    const int stride = s->stride > 1 ? 3 * s->stride : FLOOR_STRIDE;
    kit_image picture;
    return kit_floor_ao(&picture, &s->frame, &s->gbuffer.camera, s->radius, KIT_ATTENUATION_LINEAR, s->rays, stride,
                        err)
               ? -1
               : give(s, "floor", "floor", &picture);
}

static int stage_ao(stage *s, kit_error *err)
{
    const kit_camera *c = &s->gbuffer.camera;
    kit_image picture;
    if (kit_image_new(&s->unit, c->width, c->height, "Y", err)
        || kit_image_new(&picture, c->width, c->height, "Y", err))
        return -1;
    for (size_t i = 0; i < (size_t)c->width * (size_t)c->height; ++i) s->unit.data[i] = picture.data[i] = 1;
    return give(s, "no AO", "none", &picture);
}

int stage_light(stage *s, kit_error *err)
{
    if (kit_image_new(&s->unit, s->gbuffer.camera.width, s->gbuffer.camera.height, KIT_LIT_CHANNELS, err)) return -1;
    if (stage_run(&s->lights, s, "ssdo",
                 s->lit->local ? "environment=none,bounce=none,shadows=none" : "environment=none,bounce=none",
                 s->radius, err))
        return -1;
    kit_run_draw(&s->lights, 0);
    if (kit_run_read(&s->direct, &s->lights, err)) return -1;
    if (s->lit->local)
        memset(s->direct.data, 0,
               (size_t)s->direct.width * (size_t)s->direct.height * (size_t)s->direct.channels
                   * sizeof *s->direct.data);
    return !s->otherwise.kind && (s->lighting.env.data || s->lit->local) ? give_open(s, err) : 0;
}

/* ---- >>stage ----------------------------------------------------------------------------------------------------- */

/* Sets the lights of the scene. Local suns are put into the environment of the truth. */
static int light_up(stage *s, kit_error *err)
{
    const lit *l = s->lit;
    const char *env = l->env ? l->env : s->scene.env;
    if (env && kit_env_read(&s->lighting.env, env, err)) return -1;
    for (int i = 0; i < MOST_SUNS && l->light[i]; ++i)
        if (kit_light_parse(&s->lighting.light[s->lighting.lights++], l->light[i], NULL, err)) return -1;
    s->traced = s->lighting;
    if (!l->local) return 0;
    memset(&s->traced, 0, sizeof s->traced);
    if (env && kit_env_read(&s->traced.env, env, err)) return -1;
    for (int i = 0; i < s->lighting.lights; ++i)
        if (kit_env_add_sun(&s->traced.env, &s->lighting.light[i], SUN, err)) return -1;
    return 0;
}

static void place(float to_world[16], float size, const float at[3])
{
    memset(to_world, 0, 16 * sizeof *to_world);
    for (int k = 0; k < 3; ++k) to_world[5 * k] = size;
    memcpy(to_world + 12, at, 3 * sizeof *at);
    to_world[15] = 1;
}

/* Adds a view's solids. Of occlusion between objects these cast nothing; objects move, and go to their spots. */
static int furnish(stage *s, const view *v, kit_error *err)
{
    static const float hidden[3] = { 0, -0.1f, 0 };
    const int own = s->scene.objects;
    int spots = 0;
    if (v->between) kit_scene_move(&s->scene, v->time);
    for (const float (*b)[9] = v->solid; b < v->solid + MOST_SOLIDS && (*b)[4] > (*b)[1]; ++b)
        if (kit_scene_add_box(&s->scene, *b, *b + 3, *b + 6, err)) return -1;
    for (int i = 0; i < s->scene.objects && v->between; ++i) {
        kit_object *o = &s->scene.object[i];
        const spot *at = spots < MOST_SPOTS ? &v->spot[spots] : NULL;
        float to_world[16];
        if (i >= own) o->casts = 0;
        if (!o->casts || !*v->spot->name) continue;
        o->casts = at && !strcmp(at->name, o->name);
        spots += o->casts;
        place(to_world, o->casts ? at->size : 1e-3f, o->casts ? at->at : hidden);
        if (kit_scene_place(&s->scene, i, to_world, err)) return -1;
    }
    return 0;
}

int stage_load(stage *s, const view *v, kit_error *err)
{
    const char *base = strrchr(v->name, '/');
    struct stat status;
    memset(s, 0, sizeof *s);
    snprintf(s->name, sizeof s->name, "%s", base ? base + 1 : v->name);
    if (strchr(s->name, '.') > s->name) *strchr(s->name, '.') = 0;
    if (!strcmp(v->path, BUNNY) && stat(BUNNY, &status))
        return kit_fail(err, "%s: is missing; install the package %s (apt-get install %s)", BUNNY, PACKAGE, PACKAGE);
    if (kit_scene_load(&s->scene, v->path, v->ground, err)) return -1;
    if (*s->scene.note) fprintf(stderr, "report: note: %s: %s\n", v->path, s->scene.note);
    s->lit = v->lit;
    s->otherwise = v->otherwise;
    s->between = v->between;
    s->rays = v->rays ? v->rays : s->lit ? s->lit->rays : RAYS;
    if (s->lit) {
        for (int i = 0; i < s->lit->boxes; ++i)
            if (kit_scene_add_box(&s->scene, boxes[i], boxes[i] + 3, boxes[i] + 6, err)) return -1;
        if (light_up(s, err)) return -1;
    }
    return furnish(s, v, err);
}

int stage_look(stage *s, const view *v, int width, int height, kit_error *err)
{
    kit_camera camera = s->scene.camera;
    if (v->fovy > 0) {
        memcpy(camera.eye, v->eye, sizeof v->eye);
        memcpy(camera.target, v->target, sizeof v->target);
        camera.fovy = v->fovy;
    }
    camera.width = width / stage_thrift;
    camera.height = height / stage_thrift;
    const int fewer = stage_thrift * stage_thrift;
    if (s->rays > LEAST_RAYS) s->rays = s->rays > LEAST_RAYS * fewer ? s->rays / fewer : LEAST_RAYS;
    s->radius = v->radius > 0 ? v->radius : s->scene.radius;
    return kit_gbuffer_from_scene(&s->gbuffer, &s->scene, &camera, NULL, err)
        || kit_gbuffer_read(&s->frame, &s->gbuffer, err) ? -1 : 0;
}

/* Of a single occluder, leaves out of the score the pixels that show it, as its field does not shade itself. */
static int leave_out(stage *s, kit_error *err)
{
    const int width = s->gbuffer.width, height = s->gbuffer.height;
    float *z = kit_image_channel(&s->frame, "Z");
    int occluders = 0, object = 0;
    for (int i = 0; i < s->scene.objects; ++i)
        if (s->scene.object[i].casts && ++occluders) object = i;
    if (occluders != 1) return 0;
    uint32_t *shown = malloc((size_t)width * (size_t)height * sizeof *shown);
    if (!shown) return kit_fail(err, "out of memory");
    if (kit_texture_read(s->gbuffer.object, width, height, 1, (float *)(void *)shown))
        return kit_fail(err, "object numbers cannot be read");
    for (int i = 0; i < width * height; ++i)
        if (shown[(height - 1 - i / width) * width + i % width] == (uint32_t)object + 1) z[i] = 0;
    free(shown);
    return 0;
}

int stage_compare(stage *s, kit_error *err)
{
    const size_t pixels = (size_t)s->frame.width * (size_t)s->frame.height;
    if (stage_truth(s, err) || (!s->lit && !s->between && give_floor(s, err))) return -1;
    for (size_t i = 0; i < pixels; ++i)
        if (isnan(s->truth.data[i])) kit_image_channel(&s->frame, "Z")[i] = 0;
    if (s->between && leave_out(s, err)) return -1;
    return s->lit ? stage_light(s, err) : stage_ao(s, err);
}

int stage_show(stage *s, const view *v, int width, int height, kit_error *err)
{
    return stage_look(s, v, width, height, err) || stage_compare(s, err) ? -1 : 0;
}

int stage_open(stage *s, const view *v, int width, int height, kit_error *err)
{
    return stage_load(s, v, err) || stage_show(s, v, width, height, err) ? -1 : 0;
}

void stage_close(stage *s)
{
    for (int i = 0; i < s->givens; ++i) kit_image_free(&s->given[i].picture);
    kit_image_free(&s->frame);
    kit_image_free(&s->truth);
    kit_image_free(&s->unit);
    kit_image_free(&s->direct);
    if (s->lit && s->lit->local) kit_image_free(&s->traced.env);
    kit_image_free(&s->lighting.env);
    kit_run_close(&s->lights);
    kit_gbuffer_free(&s->gbuffer);
    kit_scene_free(&s->scene);
}
