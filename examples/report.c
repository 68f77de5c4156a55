/* report.c - what the methods are worth: pictures beside the truth, and speed against accuracy.

      build/report demo  [--out report] [--context egl] [--mesh M.obj]     pictures, tables and demo.html, in two minutes
      build/report chart [--out report] [--context egl] [--quick] [--scene NAME]... [--method NAME]     chart*.csv, chart*.svg and index.html, in 20 minutes, or 3
      build/report fit   [--out report] [--context egl]     plan-fit.csv, for fit.c, in 4 minutes

   With --mesh or --scene only ambient occlusion is shown; else light, fields and deep screen space, too. --method: the rows of methods whose names begin so. Truth is kept under
   build/cache/, and so is what an interrupted chart has measured: the same command goes on from there. Bad input, or a write that fails: one line on stderr, status 2. page.c holds what is written and how, lit.c what is
   shown of light, fields.c of ambient occlusion fields, deep.c of deep screen space, plan.c of the plan, peers.c of others' passes, costs.c of what choices cost in SPIR-V. */
#include "kit/kit_gl.h"
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>
#include "page.c"

/* ---- >>tables: what is shown ------------------------------------------------------------------------------------- */

#define BUNNY   "/usr/share/glmark2/models/bunny.obj"
#define PACKAGE "glmark2-data"
#define BED     "build/models/iron-bed.obj"    /* make chart puts it there */
enum { RAYS = 256, FLOOR_STRIDE = 4, DEMO_ROUNDS = 5, CHART_ROUNDS = 5, QUICK_ROUNDS = 3, SLOW = 5, SLOW_ROUNDS = 3, AO_WIDTH = 640, AO_HEIGHT = 360, AO_PHASES = 4 };      /* SLOW: so many times the reference's time */
static int thrift = 1;                         /* a quick chart's pictures have so many times shorter sides, and its truth that squared fewer rays, but no fewer than LEAST_RAYS */
enum { QUICK_THRIFT = 2, LEAST_RAYS = 16 };

typedef struct entry { const char *label, *method, *settings; int quick; } entry;   /* quick: shown by chart --quick too */

static const entry reference = { "ssao, no blur", "ssao", "samples=16,blur=0", 1 };   /* what times are relative to */

static const entry demo_entries[] = {
    { "ssao",       "ssao",       "", 1 },
    { "hsao-fast",  "hsao-fast",  "", 1 },
    { "hsao",       "hsao",       "", 1 },
    { "hsao-best",  "hsao-best",  "", 1 },
    { "hsao-march", "hsao-march", "", 1 }
};

static const entry chart_entries[] = {      /* rows of one label make one curve */
    { "ssao",            "ssao",       "samples=4",                           0 },
    { "ssao",            "ssao",       "samples=8",                           1 },
    { "ssao",            "ssao",       "",                                    1 },
    { "ssao",            "ssao",       "samples=32",                          1 },
    { "ssao, no blur",   "ssao",       "samples=16,blur=0",                   1 },
    { "hsao, half size", "hsao-fast",  "steps=2",                             0 },
    { "hsao, half size", "hsao-fast",  "",                                    1 },
    { "hsao, half size", "hsao-fast",  "steps=4",                             0 },
    { "hsao, half size", "hsao-fast",  "steps=6",                             1 },
    { "hsao, half size", "hsao",       "",                                    1 },
    { "hsao, half size", "hsao",       "directions=3",                        0 },
    { "hsao, half size", "hsao",       "directions=4,steps=8",                1 },
    { "hsao, half size", "hsao",       "directions=6,steps=6",                1 },
    { "hsao, full size", "hsao-best",  "directions=1,steps=3",                0 },
    { "hsao, full size", "hsao-best",  "directions=1,steps=4",                1 },
    { "hsao, full size", "hsao-best",  "directions=1,steps=6",                1 },
    { "hsao, full size", "hsao-best",  "directions=2,steps=6",                0 },
    { "hsao, full size", "hsao-best",  "",                                    1 },
    { "hsao, full size", "hsao-best",  "directions=4,steps=6,blur=2",         1 },
    { "hsao, full size", "hsao-best",  "directions=8,steps=12",               0 },
    { "hsao, thin",      "hsao",       "thin=1,thickness=0.25",               1 },
    { "hsao, thin",      "hsao-best",  "thin=1,thickness=0.25",               0 },
    { "hsao-march",      "hsao-march", "directions=4,steps=6,normal_rays=0",  1 },
    { "hsao-march",      "hsao-march", "directions=4,steps=6,normal_rays=1",  0 },
    { "hsao-march",      "hsao-march", "",                                    1 },
    { "hsao-march",      "hsao-march", "directions=8,steps=18,normal_rays=2", 0 },
    { "ssao, 2 layers",  "ssao",       "layers=2",                            1 },
    { "ssao, 2 layers",  "ssao",       "steps=4,layers=2",                    1 },
    { "march, 2 layers", "hsao-march", "directions=4,steps=6,layers=2",         0 },
    { "march, 2 layers", "hsao-march", "layers=2",                            1 },
    { "4 cameras",       "ssao",       "views=4",                             1 },
    { "4 cameras",       "hsao-march", "directions=4,steps=6,views=4",          0 },
    { "dss",             "dss",        "size=0.03",                           1 },
    { "dss",             "dss",        "",                                    0 }
};

#define COUNT(table) ((int)(sizeof (table) / sizeof (table)[0]))
static const float DEMO_ERROR = 0.03f;      /* what the demo's planned row is asked for */
enum { MOST_ENTRIES = COUNT(chart_entries) > COUNT(demo_entries) ? COUNT(chart_entries) : COUNT(demo_entries) + 1, MOST_ROWS = MOST_ENTRIES + 2, MOST_SCENES = 16 };

/* What lights a view (as build/render's options take it), how it is shown, and its truth. local: suns are blocked as the environment is, within the radius, not by
   all of the scene; in the truth they then are discs of SUN degrees around. */
enum { MOST_SUNS = 2, MOST_CROPS = 2, SUN = 3 };
typedef struct lit {
    const char *env, *light[MOST_SUNS];
    int   boxes, bounce, local, rays;
    float exposure;
    int   crop[MOST_CROPS][4];                 /* x, y, width, height */
} lit;

/* A view of a scene; what is 0 is the scene's own. lit: NULL = ambient visibility. */
typedef struct view { const char *name, *path; int ground; float eye[3], target[3], fovy, radius; const lit *lit; } view;
static const view views[] = {
    { "bunny",     BUNNY,       1, { -1.4f, 1.1f, 3.7f }, { 0, -0.13f, 0 }, 33, 0.6f, NULL },
    { "room",      "room",      0, { 0 }, { 0 }, 0, 0, NULL },
    { "grass",     "grass",     0, { 0 }, { 0 }, 0, 0, NULL },
    { "colonnade", "colonnade", 0, { 0 }, { 0 }, 0, 0, NULL },
    { "plates",    "plates",    0, { 0 }, { 0 }, 0, 0, NULL },
    { "pebbles",   "pebbles",   0, { 0 }, { 0 }, 0, 0, NULL },
    { "iron-bed",  BED,         1, { -170, 125, 270 }, { 0, 40, 0 }, 32, 20, NULL }
};

/* Four coloured boxes around the bunny, just above the floor. Bounds, albedo. */
static const float boxes[4][9] = {
    {  1.07f, -0.989f, -0.10f,  1.25f, -0.20f,  0.75f,  0.85f, 0.08f, 0.05f },
    {  0.25f, -0.989f,  0.82f,  0.62f, -0.72f,  1.14f,  0.85f, 0.60f, 0.04f },
    { -1.55f, -0.989f, -0.55f, -0.85f, -0.35f, -0.35f,  0.08f, 0.55f, 0.08f },
    { -0.95f, -0.989f,  0.55f, -0.65f, -0.70f,  0.90f,  0.06f, 0.14f, 0.80f }
};

/* ---- >>stage: a scene, its light, its G-buffer, its truth and what else is shown beside methods ---------------------- */

typedef struct given { const char *label, *method; kit_image picture; } given;   /* a row without a method to time */

/* What is lit otherwise. hard: what blocks or sends within the radius counts whole. GLOSS: exponent of the lobe. SCATTER: material and its unit; rays are thousands of samples. */
enum { GLOSS = 1, SCATTER };
typedef struct otherwise { int hard, kind; float exponent, unit; const char *material; } otherwise;

typedef struct stage {
    char         name[64];
    kit_scene    scene;
    kit_gbuffer  gbuffer;
    const lit   *lit;
    otherwise    otherwise;
    int          rays, between;                /* of the truth; 1 = occlusion is between objects */
    kit_lighting lighting, traced;             /* as methods have it, as the truth has it */
    kit_run      lights;                       /* lit: suns and point lights with their shadows, without the environment, */
    kit_image    direct;                       /* and what ambient visibility leaves as it is: that, unless suns are local, too */
    kit_image    frame, truth, unit;           /* unit: what errors are shares of: AO: of no AO's, 1 everywhere; lit: of the mean, 0 everywhere */
    given        given[2];
    int          givens;
    float        radius;
} stage;

static int folder(const char *path, kit_error *err)
{
    char part[4096];
    struct stat status;
    if (strlen(path) >= sizeof part - 64) return kit_fail(err, "--out %.60s...: too long", path);
    for (size_t i = 1; i <= strlen(path); ++i) {
        if (path[i] != '/' && path[i]) continue;
        memcpy(part, path, i);
        part[i] = 0;
        if (mkdir(part, 0777) && errno != EEXIST) return kit_fail(err, "%s: cannot be made: %s", part, strerror(errno));
    }
    if (stat(path, &status) || !S_ISDIR(status.st_mode)) return kit_fail(err, "%s: is not a folder", path);
    return 0;
}

static uint64_t hashed(uint64_t h, const void *data, size_t size)     /* FNV-1a */
{
    for (const unsigned char *p = data, *end = p + size; p < end; ++p) h = (h ^ *p) * 1099511628211u;
    return h;
}

static int trace(kit_image *out, const stage *s, int rays, int stride, kit_error *err)
{
    const otherwise *l = &s->otherwise;
    const int attenuation = l->hard ? KIT_ATTENUATION_NONE : KIT_ATTENUATION_LINEAR;
    ssgi_dipole dipole;
    const ssgi_material *m;
    if (l->kind == GLOSS) return kit_truth_gloss(out, &s->scene, &s->gbuffer.camera, &s->traced, s->radius, attenuation, (double)l->exponent, rays, stride, err);
    if (l->kind == SCATTER) {
        for (int i = 0; (m = ssgi_material_of(i)) && strcmp(m->name, l->material);) ++i;
        if (!m || ssgi_dipole_set(&dipole, m->sigma_s, m->sigma_a, m->eta, NULL) != SSGI_OK) return kit_fail(err, "%s: there is no such material", l->material);
        return kit_truth_scatter(out, &s->scene, &s->gbuffer.camera, &s->traced, &dipole, l->unit, 1000 * (size_t)rays, stride, err);
    }
    if (s->lit) return kit_truth_lit(out, &s->scene, &s->gbuffer.camera, &s->traced, s->radius, attenuation, s->lit->bounce, rays, stride, err);
    if (s->between) return kit_truth_objects(out, &s->scene, &s->gbuffer.camera, rays, stride, err);
    return kit_truth_ao(out, &s->scene, &s->gbuffer.camera, s->radius, KIT_ATTENUATION_LINEAR, rays, stride, err);
}

/* The truth, from build/cache where it was computed before: the file's name holds a hash of all that it depends on, and a few hundred pixels
   are traced anew, so that another tracer does not reuse it either. */
static int truth_of(stage *s, kit_error *err)
{
    const kit_camera *c = &s->gbuffer.camera;
    const size_t floats = 9 * s->scene.mesh.triangles * sizeof(float), pixels = (size_t)c->width * (size_t)c->height;
    uint64_t h = hashed(14695981039346656037u, s->scene.mesh.position, floats);
    char path[256];
    kit_image probe;
    kit_error note;
    h = hashed(h, s->scene.mesh.normal, floats);
    h = hashed(h, c, sizeof *c);
    h = hashed(h, &s->radius, sizeof s->radius);
    if (s->lit) {
        h = hashed(h, s->scene.mesh.albedo, floats / 3);
        if (s->traced.env.data) h = hashed(h, s->traced.env.data, 3 * sizeof(float) * (size_t)s->traced.env.width * (size_t)s->traced.env.height);
        h = hashed(h, s->traced.light, (size_t)s->traced.lights * sizeof(kit_light));
        if (s->otherwise.hard || s->otherwise.kind) h = hashed(h, &s->otherwise, offsetof(otherwise, material));
        if (s->otherwise.material) h = hashed(h, s->otherwise.material, strlen(s->otherwise.material));
    }
    if (s->between) h = hashed(h, s->scene.mesh.object, s->scene.mesh.triangles * sizeof *s->scene.mesh.object);
    for (int i = 0; i < s->scene.objects && s->between; ++i) h = hashed(h, &s->scene.object[i].casts, sizeof s->scene.object[i].casts);
    snprintf(path, sizeof path, "build/cache/%s-%s%dx%d-%g-%d-%016llx.exr", s->name, s->between ? "objects-" : !s->lit ? "" : s->otherwise.kind == GLOSS ? "gloss-" : s->otherwise.kind ? "scatter-" : s->lit->bounce ? "lit-" : "direct-", c->width, c->height, (double)s->radius, s->rays, (unsigned long long)h);
    if (!kit_exr_read(&s->truth, path, NULL)) {
        int same = s->truth.width == c->width && s->truth.height == c->height;
        if (trace(&probe, s, s->rays, 61, err)) return -1;
        for (int k = 0; k < probe.channels && same; ++k) {
            const float *was = kit_image_channel(&s->truth, probe.name[k]), *is = kit_image_channel(&probe, probe.name[k]);
            same = was != NULL;
            for (size_t i = 0; i < pixels && same; ++i) same = isnan(is[i]) || is[i] == was[i];
        }
        kit_image_free(&probe);
        if (same) return 0;
        kit_image_free(&s->truth);
    }
    if (trace(&s->truth, s, s->rays, 1, err)) return -1;
    if (folder("build/cache", &note) || kit_exr_write(&s->truth, path, &note)) fprintf(stderr, "report: note: the truth is not kept: %s\n", note.text);
    return 0;
}

static int run_open(kit_run *run, stage *s, const char *method, const char *set, float radius, kit_error *err)
{
    const kit_world world = { &s->scene, &s->lighting };
    kit_method m;
    return kit_method_find(&m, method, err) || kit_method_set(&m, set, err) || kit_run_open(run, &s->gbuffer, &m, radius, &world, err) ? -1 : 0;
}

static int give(stage *s, const char *label, const char *method, kit_image *picture)
{
    s->given[s->givens++] = (given){ label, method, *picture };
    return 0;
}

/* No AO: a radius so small that nothing is in the environment's way, nor in local suns'. */
static int give_open(stage *s, kit_error *err)
{
    kit_run run;
    kit_image picture;
    if (run_open(&run, s, "ssdo", s->lit->local ? "bounce=none,blur=0,shadows=none" : "bounce=none,blur=0", 1e-4f * s->radius, err)) return -1;
    kit_run_draw(&run, 0);
    if (kit_run_read(&picture, &run, err)) return -1;
    kit_run_close(&run);
    return give(s, "no AO", "none", &picture);
}

static int stage_ao(stage *s, kit_error *err)
{
    const kit_camera *c = &s->gbuffer.camera;
    kit_image picture;
    if (!s->between && kit_floor_ao(&picture, &s->frame, c, s->radius, KIT_ATTENUATION_LINEAR, s->rays, FLOOR_STRIDE, err)) return -1;
    if (!s->between) give(s, "floor", "floor", &picture);
    if (kit_image_new(&s->unit, c->width, c->height, "Y", err) || kit_image_new(&picture, c->width, c->height, "Y", err)) return -1;
    for (size_t i = 0; i < (size_t)c->width * (size_t)c->height; ++i) s->unit.data[i] = picture.data[i] = 1;
    return give(s, "no AO", "none", &picture);
}

static int stage_lit(stage *s, kit_error *err)
{
    if (kit_image_new(&s->unit, s->gbuffer.camera.width, s->gbuffer.camera.height, KIT_LIT_CHANNELS, err)) return -1;
    if (run_open(&s->lights, s, "ssdo", s->lit->local ? "environment=none,bounce=none,shadows=none" : "environment=none,bounce=none", s->radius, err)) return -1;
    kit_run_draw(&s->lights, 0);
    if (kit_run_read(&s->direct, &s->lights, err)) return -1;
    if (s->lit->local) memset(s->direct.data, 0, (size_t)s->direct.width * (size_t)s->direct.height * (size_t)s->direct.channels * sizeof *s->direct.data);
    return !s->otherwise.kind && (s->lighting.env.data || s->lit->local) ? give_open(s, err) : 0;
}

/* What lights the scene; where suns are local, the truth has them in its environment. */
static int light_up(stage *s, kit_error *err)
{
    const lit *l = s->lit;
    if (l->env && kit_env_read(&s->lighting.env, l->env, err)) return -1;
    for (int i = 0; i < MOST_SUNS && l->light[i]; ++i) if (kit_light_parse(&s->lighting.light[s->lighting.lights++], l->light[i], err)) return -1;
    s->traced = s->lighting;
    if (!l->local) return 0;
    memset(&s->traced, 0, sizeof s->traced);
    if (l->env && kit_env_read(&s->traced.env, l->env, err)) return -1;
    for (int i = 0; i < s->lighting.lights; ++i) if (kit_env_add_sun(&s->traced.env, &s->lighting.light[i], SUN, err)) return -1;
    return 0;
}

/* Loads the scene, and its light; what the scene is of may change until it is shown. */
static int stage_load(stage *s, const view *v, kit_error *err)
{
    const char *base = strrchr(v->name, '/');
    struct stat status;
    memset(s, 0, sizeof *s);
    snprintf(s->name, sizeof s->name, "%s", base ? base + 1 : v->name);
    if (strchr(s->name, '.') > s->name) *strchr(s->name, '.') = 0;
    if (!strcmp(v->path, BUNNY) && stat(BUNNY, &status)) return kit_fail(err, "%s: is missing; install the package %s (apt-get install %s)", BUNNY, PACKAGE, PACKAGE);
    if (kit_scene_load(&s->scene, v->path, v->ground, err)) return -1;
    s->lit = v->lit;
    s->rays = s->lit ? s->lit->rays : RAYS;
    if (s->lit) {
        for (int i = 0; i < s->lit->boxes; ++i) if (kit_scene_add_box(&s->scene, boxes[i], boxes[i] + 3, boxes[i] + 6, err)) return -1;
        if (light_up(s, err)) return -1;
    }
    return 0;
}

/* What is seen, without its truth. */
static int stage_look(stage *s, const view *v, int width, int height, kit_error *err)
{
    kit_camera camera = s->scene.camera;
    if (v->fovy > 0) {
        memcpy(camera.eye, v->eye, sizeof v->eye);
        memcpy(camera.target, v->target, sizeof v->target);
        camera.fovy = v->fovy;
    }
    camera.width = width / thrift;
    camera.height = height / thrift;
    if (s->rays > LEAST_RAYS) s->rays = s->rays > LEAST_RAYS * thrift * thrift ? s->rays / (thrift * thrift) : LEAST_RAYS;
    s->radius = v->radius > 0 ? v->radius : s->scene.radius;
    return kit_gbuffer_from_scene(&s->gbuffer, &s->scene, &camera, NULL, err) || kit_gbuffer_read(&s->frame, &s->gbuffer, err) ? -1 : 0;
}

static int stage_show(stage *s, const view *v, int width, int height, kit_error *err)
{
    if (stage_look(s, v, width, height, err) || truth_of(s, err)) return -1;
    return s->lit ? stage_lit(s, err) : stage_ao(s, err);
}

static int stage_open(stage *s, const view *v, int width, int height, kit_error *err)
{
    return stage_load(s, v, err) || stage_show(s, v, width, height, err) ? -1 : 0;
}

static void stage_close(stage *s)
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

/* ---- >>options: what a chart is asked for --------------------------------------------------------------------------- */

typedef struct options { const char *out, *mesh, *method, *context, *scene[MOST_SCENES]; int quick, scenes; } options;

static int asked(const options *o, const char *method) { return !o->method || !strncmp(method, o->method, strlen(o->method)); }

/* The entries that a chart shows; how many. */
static int chosen(entry *out, const entry *entries, int count, const options *o)
{
    int n = 0;
    for (int i = 0; i < count; ++i) if ((entries[i].quick || !o->quick) && asked(o, entries[i].method)) out[n++] = entries[i];
    return n;
}

/* ---- >>measure ----------------------------------------------------------------------------------------------------- */

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *v, int count)
{
    qsort(v, (size_t)count, sizeof *v, by_value);
    return count % 2 ? v[count / 2] : 0.5 * (v[count / 2 - 1] + v[count / 2]);
}

/* Scores a picture over what the frame shows, and where the picture is known; the unit on the same pixels. */
static int score(row *r, const stage *s, const kit_image *picture, kit_error *err)
{
    static const char *const names[4][3] = { { "R", "G", "B" }, { "irradiance.R", "irradiance.G", "irradiance.B" }, { "bounce.R", "bounce.G", "bounce.B" }, { "Y", NULL, NULL } };
    const float *z = kit_image_channel(&s->frame, "Z");
    size_t pixels = (size_t)picture->width * (size_t)picture->height;
    float *mask = malloc(pixels * sizeof *mask);
    kit_score here, unit;
    int failed = mask ? 0 : kit_fail(err, "out of memory");
    for (size_t i = 0; i < pixels && mask; ++i) mask[i] = isnan(picture->data[i]) ? 0 : z[i];
    r->of = s->lit ? OF_LIT : s->between ? OF_FIELD : OF_AO;
    for (int k = 0; k < SPLITS; ++k) r->split[k] = (double)NAN;
    for (int k = 0; k < 3; ++k) r->error[k] = r->bias[k] = (double)NAN;
    for (int g = s->lit ? 0 : 3; g < (s->lit ? 3 : 4) && !failed; ++g) {
        failed = kit_score_channels(&here, picture, &s->truth, names[g], s->lit ? 3 : 1, mask, err) || kit_score_channels(&unit, &s->unit, &s->truth, names[g], s->lit ? 3 : 1, mask, err);
        const double share = s->lit ? -unit.bias : unit.rmse, known = share > 0 ? 1 / share : (double)NAN;
        if (g % 3 == 0) r->score = here;
        if (g % 3 == 0) r->share = here.rmse * known;
        if (s->lit) r->error[g] = here.rmse * known;
        if (s->lit) r->bias[g] = here.bias * known;
    }
    free(mask);
    return failed ? -1 : 0;
}

/* Lit by ambient visibility: it dims the environment's light, not the lights'. */
static int light_by(kit_image *visibility, const stage *s, kit_error *err)
{
    if (!s->givens) return kit_fail(err, "%s: ambient visibility has no environment to dim", s->name);
    return kit_dim(visibility, &s->given[0].picture, &s->direct, err);
}

static double draw(kit_run *run)
{
    kit_run_draw(run, 1);
    return kit_run_ms(run);
}

/* Deep screen space: what it drew, and its stages' shares of the time of the last draw. */
static void count_surfels(row *r, const kit_run *run)
{
    const double all = kit_run_ms(run);
    r->figure[SURFELS] = (double)run->surfels;
    r->figure[SPLATS] = run->splat_pixels / ((double)run->gbuffer->viewport[2] * run->gbuffer->viewport[3]);
    for (int k = 0; k < STAGES; ++k) r->figure[STAGE + k] = 0;
    for (int i = 0; i < run->passes; ++i) {
        const int at = run->pass[i].desc.pass - SSGI_GL_SURFELS;
        r->figure[STAGE + (at >= 0 && at < STAGES - 1 ? at : STAGES - 1)] += run->pass[i].ms / all;
    }
}

/* Times what once(of, i) draws, all drawn before, in ms: each once a round between two drawings of the reference, whose mean its time is divided by; medians. Slow ones sit out late rounds. */
static int clock_all(row *rows, stage *s, double (*once)(void *of, int i), void *of, int count, int rounds, kit_error *err)
{
    double *ratio = calloc((size_t)(2 * count * rounds), sizeof *ratio), *ms = ratio + count * rounds, before, after;
    kit_run fixed;
    char what[128];
    if (!ratio) return kit_fail(err, "out of memory");
    if (run_open(&fixed, s, reference.method, reference.settings, s->radius, err)) { free(ratio); return -1; }
    kit_run_draw(&fixed, 1);
    snprintf(what, sizeof what, "%s: times", s->name);
    kit_progress(what, 0);
    for (int k = 0; k < rounds; ++k) {
        before = draw(&fixed);
        for (int i = 0; i < count; ++i) {
            if (k >= SLOW_ROUNDS && ms[i * rounds] > SLOW * before) continue;
            ms[i * rounds + k] = once(of, i);
            after = draw(&fixed);
            ratio[i * rounds + k] = ms[i * rounds + k] / (0.5 * (before + after));
            before = after;
            kit_progress(what, (k * count + i + 0.99) / (rounds * count));
        }
    }
    kit_progress(what, 1);
    for (int i = 0; i < count; ++i) {
        const int drawn = rounds > SLOW_ROUNDS && !(ms[i * rounds + SLOW_ROUNDS] > 0) ? SLOW_ROUNDS : rounds;
        rows[i].relative = median(ratio + i * rounds, drawn);
        rows[i].ms = median(ms + i * rounds, drawn);
    }
    kit_run_close(&fixed);
    free(ratio);
    return 0;
}

/* Where there is light, ambient visibility's time includes the lights' passes. */
typedef struct runs { stage *s; kit_run *run; } runs;
static double run_once(void *of, int i)
{
    const runs *all = of;
    return draw(&all->run[i]) + (all->s->lit && !all->run[i].lit ? draw(&all->s->lights) : 0);
}

/* Times runs, and closes them. */
static int clock_runs(row *rows, stage *s, kit_run *run, int count, int rounds, kit_error *err)
{
    runs all = { s, run };
    if (clock_all(rows, s, run_once, &all, count, rounds, err)) return -1;
    for (int i = 0; i < count; ++i) {
        rows[i].bytes = run[i].bytes + (s->lit && !run[i].lit ? s->lights.bytes : 0);
        if (run[i].surfels) count_surfels(&rows[i], &run[i]);
        kit_run_close(&run[i]);
    }
    return 0;
}

/* Fills a row an entry, then one for each of what is given: count + s->givens in all. Every entry is drawn once to warm up (that picture is scored), then
   timed. pictures: NULL, or an empty one an entry. */
static int measure(row *rows, stage *s, const entry *entries, int count, int rounds, kit_image *pictures, kit_error *err)
{
    kit_run run[MOST_ENTRIES];
    char what[128];
    snprintf(what, sizeof what, "%s: methods", s->name);
    kit_progress(what, 0);
    for (int i = 0; i < count; ++i) {
        kit_image picture;
        memset(&rows[i], 0, sizeof rows[i]);
        for (int k = 0; k < FIGURES; ++k) rows[i].figure[k] = (double)NAN;
        rows[i].label = entries[i].label;
        rows[i].method = entries[i].method;
        rows[i].settings = entries[i].settings;
        if (run_open(&run[i], s, entries[i].method, entries[i].settings, s->radius, err)) return -1;
        rows[i].fetches = run[i].fetches + (s->lit && !run[i].lit ? s->lights.fetches : 0);
        kit_run_draw(&run[i], 1);
        if (kit_run_read(&picture, &run[i], err) || (s->lit && !run[i].lit && light_by(&picture, s, err)) || score(&rows[i], s, &picture, err)) return -1;
        if (pictures) pictures[i] = picture; else kit_image_free(&picture);
        kit_progress(what, (i + 1.0) / (count + 1.0));
    }
    kit_progress(what, 1);
    if (clock_runs(rows, s, run, count, rounds, err)) return -1;
    for (int i = 0; i < s->givens; ++i) {
        row *r = &rows[count + i];
        memset(r, 0, sizeof *r);
        for (int k = 0; k < FIGURES; ++k) r->figure[k] = (double)NAN;
        r->label = s->given[i].label;
        r->method = s->given[i].method;
        r->settings = "";
        r->fetches = r->bytes = r->relative = r->ms = (double)NAN;
        if (score(r, s, &s->given[i].picture, err)) return -1;
        if (!strcmp(r->label, "floor") && FLOOR_STRIDE > 1) r->score.ssim = (double)NAN;      /* has no neighbours */
    }
    for (int i = 0; i < count + s->givens; ++i) rows[i].scene = s->name;
    return 0;
}

#include "peers.c"
#include "costs.c"

/* ---- >>demo -------------------------------------------------------------------------------------------------------- */

static int save(const kit_image *image, const char *names, int srgb, const char *out, const char *slug, const char *ending, kit_error *err)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s%s", out, slug, ending);
    return strstr(ending, ".exr") ? kit_exr_write(image, path, err) : kit_png_write(image, names, srgb, path, err);
}

static int save_legend(const char *out, kit_error *err)
{
    kit_image ramp, zero, colour;
    if (kit_image_new(&ramp, 512, 16, "Y", err) || kit_image_new(&zero, 512, 16, "Y", err)) return -1;
    for (int i = 0; i < 512 * 16; ++i) ramp.data[i] = (float)(i % 512) / 511 - 0.5f;
    if (kit_image_difference(&colour, &ramp, &zero, "Y", 0.5f, err) || save(&colour, "R,G,B", 0, out, "difference-legend", ".png", err)) return -1;
    kit_image_free(&ramp);
    kit_image_free(&zero);
    kit_image_free(&colour);
    return 0;
}

static void slug_of(char slug[64], const char *label)
{
    size_t n = 0;
    for (; *label && n < 63; ++label) if (isalnum((unsigned char)*label)) slug[n++] = (char)tolower((unsigned char)*label); else if (n && slug[n - 1] != '-') slug[n++] = '-';
    slug[n] = 0;
}

/* A chart as a file of its own and inside the page. */
static int chart_of(FILE *html, const char *out, const char *name, const char *title, const words *w, const row *rows, int count, double floor_, kit_error *err)
{
    page p;
    if (page_open(&p, err)) return -1;
    chart_svg(p.file, title, w, rows, count, floor_);
    fflush(p.file);
    fwrite(p.text, 1, p.size, html);
    return page_close(&p, out, name, err);
}

/* The part of a picture in crop (NULL: all), each pixel times x times: exposed R, G, B and their luminance Y. */
static int exposed(kit_image *out, const kit_image *picture, float exposure, const int *crop, int times, kit_error *err)
{
    static const char *const names[3] = { "R", "G", "B" };
    static const float weight[3] = { 0.2126f, 0.7152f, 0.0722f };
    const int all[4] = { 0, 0, picture->width, picture->height };
    size_t i = 0;
    if (!crop) crop = all;
    if (kit_image_new(out, crop[2] * times, crop[3] * times, "R,G,B,Y", err)) return -1;
    for (int y = 0; y < out->height; ++y)
        for (int x = 0; x < out->width; ++x, ++i)
            for (size_t c = 0; c < 3; ++c) {
                const float v = exposure * kit_image_channel(picture, names[c])[(size_t)(crop[1] + y / times) * (size_t)picture->width + (size_t)(crop[0] + x / times)];
                out->data[c * (size_t)out->width * (size_t)out->height + i] = v;
                out->data[3 * (size_t)out->width * (size_t)out->height + i] += weight[c] * v;
            }
    return 0;
}

/* Means of blocks of pixels: no wider than most. */
static int shrunk(kit_image *out, const kit_image *picture, const char *names, int most, kit_error *err)
{
    const int block = (picture->width + most - 1) / most;
    if (kit_image_new(out, picture->width / block, picture->height / block, names, err)) return -1;
    for (int c = 0; c < out->channels; ++c) {
        const float *from = kit_image_channel(picture, out->name[c]);
        float *to = kit_image_channel(out, out->name[c]);
        for (int y = 0; y < out->height * block; ++y)
            for (int x = 0; x < out->width * block; ++x) to[y / block * out->width + x / block] += from[y * picture->width + x] / (float)(block * block);
    }
    return 0;
}

/* ---- >>units: what a chart is made of ------------------------------------------------------------------------------ */

/* A table on a scene: its rows, and what stands in the page. Kept until the chart is whole, so that an interrupted one goes on where it was. */
typedef int measuring(FILE *html, const options *o, int k, row *rows, kit_error *err);      /* the k-th of its kind: how many rows; -1 = failed. rows NULL: whether there are any */
enum { MOST_UNITS = 64 };
static struct { uint64_t key; int all, count, measured; double begun; char now[32], path[MOST_UNITS][96]; } units;

static uint64_t hashed_file(uint64_t h, const char *path)
{
    char *data;
    size_t size;
    if (kit_file_read(&data, &size, path, NULL)) return h;
    h = hashed(h, data, size);
    free(data);
    return h;
}

static int planned(measuring *measure_, int count, const options *o)
{
    int sum = 0;
    for (int k = 0; k < count; ++k) sum += measure_(NULL, o, k, NULL, NULL);
    return sum;
}

/* What all units depend on: the program with its tables, what it is asked for, meshes. */
static void units_begin(const options *o, int all)
{
    const char *const text[] = { kit_gl_name(), o->out, o->method ? o->method : "", o->quick ? "quick" : "" };
    memset(&units, 0, sizeof units);
    units.all = all;
    units.begun = kit_seconds();
    units.key = hashed_file(hashed_file(hashed_file(14695981039346656037u, "/proc/self/exe"), BUNNY), BED);
    for (int i = 0; i < COUNT(text); ++i) units.key = hashed(units.key, text[i], strlen(text[i]) + 1);
    for (int i = 0; i < o->scenes; ++i) units.key = hashed_file(hashed(units.key, o->scene[i], strlen(o->scene[i]) + 1), o->scene[i]);
}

static void units_end(void)
{
    for (int i = 0; i < units.count; ++i) remove(units.path[i]);
}

/* Whether the pictures that a part of the page shows are still in the folder. */
static int pictured(const char *html, const char *out)
{
    char path[4096];
    while ((html = strstr(html, "src=\"")) != NULL) {
        html += strlen("src=\"");
        snprintf(path, sizeof path, "%s/%.*s", out, (int)strcspn(html, "\""), html);
        if (access(path, R_OK)) return 0;
    }
    return 1;
}

/* One table on one scene: measured, or as an interrupted chart left it. How many rows, 0: none are asked for; -1 = failed. */
static int unit(FILE *html, const options *o, const char *kind, int k, measuring *measure_, row *rows, kit_error *err)
{
    char *path = units.path[units.count], *text, *at, left[64] = "";
    size_t size;
    int count = measure_(NULL, o, k, NULL, NULL);
    page part, kept;
    kit_error note;
    if (!count) return 0;
    ++units.count;
    snprintf(units.now, sizeof units.now, "%s-%d", kind, k);
    snprintf(path, sizeof *units.path, "build/cache/unit-%s-%016llx", units.now, (unsigned long long)units.key);
    if (!kit_file_read(&text, &size, path, NULL)) {            /* text stays: rows point into it */
        memcpy(&count, text, sizeof count);
        memcpy(rows, text + sizeof count, (size_t)count * sizeof *rows);
        at = text + sizeof count + (size_t)count * sizeof *rows;
        for (int i = 0; i < count; ++i) {
            const char **name[] = { &rows[i].scene, &rows[i].label, &rows[i].method, &rows[i].settings };
            for (int j = 0; j < COUNT(name); ++j, at += strlen(at) + 1) *name[j] = at;
        }
        if (pictured(at, o->out)) {
            fputs(at, html);
            return count;
        }
    }
    if (units.measured) snprintf(left, sizeof left, ", about %.0f min left", ceil((kit_seconds() - units.begun) / units.measured * (units.all - units.count + 1) / 60));
    if (isatty(2)) fprintf(stderr, "%d of %d%s\n", units.count, units.all, left);
    if (page_open(&part, err)) return -1;
    count = measure_(part.file, o, k, rows, err);
    ++units.measured;
    fflush(part.file);
    if (count >= 0 && !page_open(&kept, err)) {
        fwrite(&count, sizeof count, 1, kept.file);
        fwrite(rows, sizeof *rows, (size_t)count, kept.file);
        for (int i = 0; i < count; ++i) fprintf(kept.file, "%s%c%s%c%s%c%s%c", rows[i].scene, 0, rows[i].label, 0, rows[i].method, 0, rows[i].settings, 0);
        fwrite(part.text, 1, part.size, kept.file);
        if (folder("build/cache", &note) || page_close(&kept, "build/cache", path + strlen("build/cache/"), &note)) fprintf(stderr, "report: note: what is measured is not kept: %s\n", note.text);
    }
    page_into(&part, html);
    return count;
}

/* Small pictures: the truth, the best row of those that take no longer than the reference (else the fastest), the best of all. */
static int thumbs(FILE *html, const char *out, const stage *s, const row *rows, const kit_image *pictures, int count, kit_error *err)
{
    static const char *const endings[] = { "truth", "fast", "best" };
    const char *const names = s->lit ? "R,G,B" : "Y";
    int fast = 0, best = 0;
    for (int i = 1; i < count; ++i) {
        const row *r = &rows[i], *f = &rows[fast];
        if (f->relative > 1 ? r->relative < f->relative : r->relative < 1 && r->score.rmse < f->score.rmse) fast = i;
        if (r->score.rmse < rows[best].score.rmse) best = i;
    }
    fputs("<div class=\"grid thumbs\">\n", html);
    for (int k = 0; k < (best == fast ? 2 : 3); ++k) {
        const row *r = &rows[k > 1 ? best : fast];
        const kit_image *from = k ? &pictures[r - rows] : &s->truth;
        kit_image bright = { 0 }, small;
        char slug[160], label[160], note[64] = "";
        if (s->lit && exposed(&bright, from, s->lit->exposure, NULL, 1, err)) return -1;
        if (shrunk(&small, s->lit ? &bright : from, names, 320, err)) return -1;
        snprintf(slug, sizeof slug, "thumb-%s-", units.now);
        slug_of(slug + strlen(slug), s->name);
        snprintf(slug + strlen(slug), sizeof slug - strlen(slug), "-%s", endings[k]);
        snprintf(label, sizeof label, k ? "%s, %s" : "ray-traced truth", r->label, settings_of(r));
        if (k) snprintf(note, sizeof note, "time %.2f, error %.3f", r->relative, r->share);
        if (save(&small, names, s->lit != NULL, out, slug, ".png", err)) return -1;
        figure_html(html, slug, label, note, small.width, small.height, 0);
        fputs("</figure>\n", html);
        kit_image_free(&bright);
        kit_image_free(&small);
    }
    fputs("</div>\n", html);
    return 0;
}

#include "lit.c"
#include "fields.c"
#include "deep.c"
#include "plan.c"

static int demo(const options *o, kit_error *err)
{
    enum { ENTRIES = COUNT(demo_entries) + 1 };              /* the last one is planned */
    entry entries[ENTRIES];
    ssgi_plan_scene numbers;
    ssgi_plan plan;
    char planned_set[256];
    view mesh = views[0];
    stage s;
    row rows[ENTRIES + 2], lit_rows[LIT_DEMOS][MOST_ROWS], field_rows[FIELD_DEMO_ROWS];
    static deep_set deep_sets[DEEP_DEMOS];
    int lit_count[LIT_DEMOS];
    kit_image picture[ENTRIES], difference;
    page p;
    char about[512], note[64], slug[64];
    if (o->mesh) { memset(&mesh, 0, sizeof mesh); mesh.name = mesh.path = o->mesh; mesh.ground = 1; }
    if (stage_open(&s, &mesh, 1280, 720, err)) return -1;
    if (kit_plan_numbers(&numbers, &s.gbuffer, &(kit_world){ &s.scene, NULL }, s.radius, SSGI_PLAN_VISIBILITY, 0, err)) return -1;
    numbers.error = DEMO_ERROR;
    numbers.budget = 20;
    if (ssgi_plan_make(&plan, &numbers, NULL) != SSGI_OK) return kit_fail(err, "%s: has no plan", s.name);
    memcpy(entries, demo_entries, sizeof demo_entries);
    entries[ENTRIES - 1] = (entry){ "planned", kit_plan_text(planned_set, &plan, SSGI_PLAN_VISIBILITY), planned_set, 1 };
    const int count = plan.method == SSGI_PLAN_NOTHING ? ENTRIES - 1 : ENTRIES;
    if (measure(rows, &s, entries, count, DEMO_ROUNDS, picture, err)) return -1;
    if (save(&s.truth, "Y", 0, o->out, "truth", ".png", err) || save(&s.truth, "Y", 0, o->out, "truth", ".exr", err) || save_legend(o->out, err)) return -1;

    if (page_open(&p, err)) return -1;
    snprintf(about, sizeof about, "%s, %zu triangles, %d x %d pixels, radius %g. Ambient visibility: white is open, black is closed. Times: %s.",
             s.name, s.scene.mesh.triangles, s.truth.width, s.truth.height, (double)s.radius, kit_gl_name());
    html_head(p.file, o->mesh ? "ssgi: ambient occlusion beside the truth" : "ssgi: ambient occlusion and light beside the truth", about);
    snprintf(note, sizeof note, "%d rays a pixel", RAYS);
    fputs("<h2>Ambient occlusion</h2>\n<div class=\"grid\">\n", p.file);
    figure_html(p.file, "truth", "ray-traced truth", note, 1280, 720, 0);
    key_html(p.file, 0.5);
    fputs("</figure>\n", p.file);
    for (int i = 0; i < count; ++i) {
        slug_of(slug, entries[i].label);
        if (kit_image_difference(&difference, &picture[i], &s.truth, "Y", 0.5f, err)) return -1;
        if (save(&picture[i], "Y", 0, o->out, slug, ".png", err) || save(&picture[i], "Y", 0, o->out, slug, ".exr", err)) return -1;
        if (save(&difference, "R,G,B", 0, o->out, slug, "-difference.png", err) || save(&difference, "R,G,B", 0, o->out, slug, "-difference.exr", err)) return -1;
        kit_image_free(&difference);
        kit_image_free(&picture[i]);
        snprintf(note, sizeof note, "time %.2f, error %.3f", rows[i].relative, rows[i].share);
        figure_html(p.file, slug, entries[i].label, note, 1280, 720, 1);
        fputs("</figure>\n", p.file);
    }
    fprintf(p.file, "</div>\n<p>Planned: ssgi_plan_make was asked for an RMSE of %g. Its answer: ", (double)numbers.error);
    escaped(p.file, plan.why);
    fputs(".</p>\n<h3>Figures</h3>\n", p.file);
    table_html(p.file, rows, count + 2);
    stage_close(&s);
    for (int k = 0; k < LIT_DEMOS && !o->mesh; ++k) if (lit_demo(p.file, o->out, &lit_demos[k], lit_rows[k], &lit_count[k], err)) return -1;
    if (!o->mesh && (field_demo(p.file, o->out, field_rows, err) || deep_demo(p.file, o->out, deep_sets, err))) return -1;
    html_terms(p.file);
    if (!o->mesh) lit_terms(p.file);
    if (!o->mesh) field_terms(p.file);
    if (!o->mesh) deep_terms(p.file);
    if (page_close(&p, o->out, "demo.html", err)) return -1;
    table_text(stdout, rows, count + 2);
    printf("planned for an RMSE of %g: %s\n", (double)numbers.error, plan.why);
    for (int k = 0; k < LIT_DEMOS && !o->mesh; ++k) {
        printf("\n%s\n", lit_demos[k].title);
        table_text(stdout, lit_rows[k], lit_count[k]);
    }
    if (!o->mesh) {
        printf("\n%s\n", field_demo_title);
        table_text(stdout, field_rows, FIELD_DEMO_ROWS);
        deep_text(stdout, deep_sets, DEEP_DEMOS);
    }
    printf("\ntime: relative to one unblurred 16-sample ssao, on %s\nshare: RMSE over that of having no AO; floor: the exact answer from one depth layer\n", kit_gl_name());
    if (!o->mesh) printf("radiance, irradiance, bounce and their biases: over the truth's means\n");
    printf("pictures: %s/demo.html\n", o->out);
    return 0;
}

/* ---- >>chart ------------------------------------------------------------------------------------------------------- */

enum { AO_GIVENS = 2, CHART_ROWS = MOST_ROWS + MOST_PEERS };   /* methods, floor and no AO; peers */

static void mean_of(row *mean, const row (*rows)[CHART_ROWS], int scenes, int count)
{
    for (int i = 0; i < count; ++i) {
        row m = rows[0][i];
        m.scene = "mean";
        m.bytes = m.relative = m.ms = m.share = m.fetches = m.figure[FITTED] = 0;
        memset(&m.score, 0, sizeof m.score);
        memset(m.split, 0, sizeof m.split);
        for (int s = 0; s < scenes; ++s) {
            const row *r = &rows[s][i];
            m.bytes += r->bytes / scenes;
            m.relative += r->relative / scenes;
            for (int j = 0; j < SPLITS; ++j) m.split[j] += r->split[j] / scenes;
            m.ms += r->ms / scenes;
            m.share += r->share / scenes;
            m.fetches += r->fetches / scenes;
            m.figure[FITTED] += r->figure[FITTED] / scenes;
            m.score.rmse += r->score.rmse / scenes;
            m.score.bias += r->score.bias / scenes;
            m.score.p95 += r->score.p95 / scenes;
            m.score.ssim += r->score.ssim / scenes;
            m.score.pixels += r->score.pixels;
        }
        mean[i] = m;
    }
}

/* The k-th scene of those asked for, else of all that are there. */
static view view_at(const options *o, int k)
{
    view v = { .name = o->scenes ? o->scene[k] : views[k].name, .path = o->scenes ? o->scene[k] : NULL };
    for (int i = 0; i < COUNT(views); ++i) if (!strcmp(views[i].name, v.name)) v = views[i];
    return v;
}

static int ao_unit(FILE *html, const options *o, int k, row *rows, kit_error *err)
{
    static char names[MOST_SCENES][64];
    const view v = view_at(o, k);
    entry entries[MOST_ENTRIES];
    kit_image picture[MOST_ENTRIES];
    const int count = chosen(entries, chart_entries, COUNT(chart_entries), o);
    int peers;
    stage s;
    if (!count || (!o->scenes && !strcmp(v.path, BED) && access(BED, R_OK))) return 0;
    if (!rows) return 1;
    if (stage_open(&s, &v, AO_WIDTH, AO_HEIGHT, err) || measure(rows, &s, entries, count, o->quick ? QUICK_ROUNDS : CHART_ROUNDS, picture, err)) return -1;
    if (splits(rows, &s, entries, count, AO_PHASES, err)) return -1;
    peers = o->method ? 0 : peers_measure(rows + count + s.givens, &s, QUICK_ROUNDS, o->quick ? PEERS_QUICK : MOST_PEERS, err);
    if (peers < 0) return -1;
    memcpy(names[k], s.name, sizeof names[k]);
    for (int i = 0; i < count + s.givens + peers; ++i) {
        rows[i].scene = names[k];
        if (peers) rows[i].of |= OF_PEER;
    }
    fputs("<div><h3>", html);
    escaped(html, s.name);
    fprintf(html, "</h3>\n<p>%zu triangles, %d x %d pixels, radius %g. Truth: %d rays a pixel.</p>\n", s.scene.mesh.triangles, s.truth.width, s.truth.height, (double)s.radius, s.rays);
    if (thumbs(html, o->out, &s, rows, picture, count, err)) return -1;
    for (int i = 0; i < count; ++i) kit_image_free(&picture[i]);
    stage_close(&s);
    return count + AO_GIVENS + peers;
}

static int ao_chart(FILE *html, const options *o, row *mean, int *count, int *methods, kit_error *err)
{
    static row rows[MOST_SCENES][CHART_ROWS], points[CHART_ROWS];
    const int scenes = o->scenes ? o->scenes : COUNT(views);
    entry entries[MOST_ENTRIES];
    char title[256], file[128];
    page csv, each;
    int shown = 0, drawn;
    *count = CHART_ROWS;
    *methods = chosen(entries, chart_entries, COUNT(chart_entries), o) + AO_GIVENS;
    if (page_open(&csv, err) || page_open(&each, err)) return -1;
    for (int k = 0; k < scenes; ++k) {
        row *r = rows[shown];
        const int n = unit(each.file, o, "ao", k, ao_unit, r, err);
        if (n < 0) return -1;
        if (!n) {
            static const char *const without = "iron-bed: left out, " BED " is not there; make chart takes it from Debian's package sweethome3d-furniture";
            fprintf(stderr, "report: note: %s\n", without);
            fprintf(each.file, "<p class=\"faint\">%s.</p>\n", without);
            continue;
        }
        if (n < *count) *count = n;
        snprintf(file, sizeof file, "chart-%.63s.svg", r->scene);
        snprintf(title, sizeof title, "Speed against accuracy: %.63s", r->scene);
        drawn = peers_points(points, r, *methods, n);
        if (chart_of(each.file, o->out, file, title, &ao_words, points, drawn, r[*methods - 2].share, err)) return -1;
        fputs("<details><summary>Figures</summary>\n", each.file);
        table_html(each.file, r, n);
        fputs("</details></div>\n", each.file);
        table_csv(csv.file, r, n, !shown++);
    }
    if (page_close(&csv, o->out, "chart.csv", err)) return -1;
    mean_of(mean, (const row (*)[CHART_ROWS])rows, shown, *count);
    drawn = peers_points(points, mean, *methods, *count);
    snprintf(title, sizeof title, shown > 1 ? "Speed against accuracy, mean of %d scenes" : "Speed against accuracy", shown);
    fputs("<h2>Ambient occlusion</h2>\n", html);
    if (chart_of(html, o->out, "chart.svg", title, &ao_words, points, drawn, mean[*methods - 2].share, err)) return -1;
    fprintf(html, "<p class=\"faint\">Rest the pointer on a point for its settings. %s</p>\n", peers_note());
    table_html(html, mean, *count);
    fputs("<h2>Scene by scene</h2>\n<div class=\"charts\">\n", html);
    page_into(&each, html);
    fputs("</div>\n", html);
    return 0;
}

/* What --method names must be there. */
static int check_asked(const options *o, kit_error *err)
{
    entry e[MOST_ENTRIES];
    kit_method m;
    int known = 0;
    for (int i = 0; kit_method_at(&m, i); ++i) known |= asked(o, m.name);
    if (!known) return kit_fail(err, "--method %s: no method's name begins so (build/render --list names all)", o->method);
    return o->scenes && !chosen(e, chart_entries, COUNT(chart_entries), o) ? kit_fail(err, "--method %s: no row of ambient occlusion's chart is of such a method, and --scene shows that alone", o->method) : 0;
}

static int chart(const options *o, kit_error *err)
{
    static lit_row_set lit_rows[LIT_SETS];
    static field_row_set field_sets[FIELD_SETS];
    static deep_set deep_sets[DEEP_SETS];
    static row mean[CHART_ROWS];
    verdict verdicts[2];
    entry e[MOST_ENTRIES];
    page html;
    char about[512];
    int count = 0, methods = 0;
    const int ao = chosen(e, chart_entries, COUNT(chart_entries), o) > 0, all = !o->scenes;
    if (check_asked(o, err)) return -1;
    if (o->quick) thrift = QUICK_THRIFT;
    units_begin(o, planned(ao_unit, all ? COUNT(views) : o->scenes, o) + (all ? planned(lit_unit, LIT_SETS, o) + planned(field_unit, FIELD_SETS, o) + planned(deep_unit, DEEP_SETS, o) : 0));
    if (page_open(&html, err)) return -1;
    snprintf(about, sizeof about, "Raw output against ray-traced truth: no gain, no exponent fitted; linear attenuation where nothing else is said. Times: %s.%s", kit_gl_name(),
        o->quick ? " The quick form: smaller pictures, fewer rays, fewer rows." : "");
    html_head(html.file, "ssgi: speed against accuracy", about);
    if (ao && ao_chart(html.file, o, mean, &count, &methods, err)) return -1;
    if (all && (lit_chart(html.file, o, lit_rows, err) || field_chart(html.file, o, field_sets, err) || deep_chart(html.file, o, deep_sets, err))) return -1;
    if (all && !o->method && (plan_chart(html.file, o, verdicts, err) || (!o->quick && costs_chart(html.file, o->out, err)))) return -1;
    const struct { const char *name; int rows; } csv[] = { { "chart.csv", ao }, { "chart-lit.csv", all && planned(lit_unit, LIT_SETS, o) }, { "chart-aof.csv", all && planned(field_unit, FIELD_SETS, o) },
        { "chart-deep.csv", all && planned(deep_unit, DEEP_SETS, o) } };
    html_terms(html.file);
    if (count > methods) peers_terms(html.file);
    if (all) lit_terms(html.file);
    if (all) field_terms(html.file);
    if (all) deep_terms(html.file);
    fputs("<p class=\"faint\">The same figures as text:", html.file);
    for (int i = 0; i < COUNT(csv); ++i) if (csv[i].rows) fprintf(html.file, " <a href=\"%s\">%s</a>", csv[i].name, csv[i].name);
    fputs("</p>\n", html.file);
    if (page_close(&html, o->out, "index.html", err)) return -1;
    units_end();
    if (ao) {
        printf("ambient occlusion, %s\n", mean->scene);
        table_text(stdout, mean, count);
        printf("%s\n", peers_note());
        if (count > methods) peers_verdict(stdout, mean, methods, count);
    }
    if (all) lit_chart_text(stdout, lit_rows);
    if (all) field_chart_text(stdout, field_sets);
    if (all) deep_text(stdout, deep_sets, DEEP_SETS);
    if (all && !o->method) plan_text(stdout, verdicts);
    printf("\ntime: relative to one unblurred 16-sample ssao, on %s\ncharts: %s/index.html\n", kit_gl_name(), o->out);
    return 0;
}

/* ---- >>main -------------------------------------------------------------------------------------------------------- */

static int parse(options *o, int is_chart, int argc, char **argv, kit_error *err)
{
    memset(o, 0, sizeof *o);
    o->out = "report";
    for (int i = 2; i < argc; ++i) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        if (is_chart && !strcmp(a, "--quick")) { o->quick = 1; continue; }
        if (strcmp(a, "--out") && strcmp(a, "--context") && strcmp(a, is_chart ? "--scene" : "--mesh") && (!is_chart || strcmp(a, "--method"))) return kit_fail(err, "%s: %s takes no such argument (report alone prints what there is)", a, argv[1]);
        if (!v || !*v) return kit_fail(err, "%s: needs a value", a);
        ++i;
        if (!strcmp(a, "--out")) o->out = v;
        else if (!strcmp(a, "--context")) o->context = v;
        else if (!is_chart) o->mesh = v;
        else if (!strcmp(a, "--method")) o->method = v;
        else if (o->scenes == MOST_SCENES) return kit_fail(err, "--scene %s: at most %d of them", v, MOST_SCENES);
        else o->scene[o->scenes++] = v;
    }
    return 0;
}

int main(int argc, char **argv)
{
    options o;
    kit_error err = { "" };
    int is_chart;
    kit_streams_open();
    if (argc < 2) {
        fputs("usage: report demo  [--out FOLDER] [--context osmesa | egl | egl-es] [--mesh M.obj]     pictures beside the truth\n"
              "       report chart [--out FOLDER] [--context ...] [--quick] [--scene NAME]... [--method NAME]     speed against accuracy\n"
              "       report fit   [--out FOLDER] [--context ...]     what the plan's table is fitted to\n", stderr);
        return 2;
    }
    is_chart = !strcmp(argv[1], "chart");
    const int is_fit = !strcmp(argv[1], "fit");
    if (!is_chart && !is_fit && strcmp(argv[1], "demo")) kit_fail(&err, "%s: there is no such command (demo, chart, fit)", argv[1]);
    else if (!parse(&o, is_chart, argc, argv, &err) && !folder(o.out, &err) && !kit_gl_open(o.context, &err)
        && !(is_chart ? chart(&o, &err) : is_fit ? plan_fit(o.out, &err) : demo(&o, &err))) kit_streams_close(&err);
    if (*err.text) {
        kit_progress("", 1);
        fprintf(stderr, "report: %s\n", err.text);
        return 2;
    }
    kit_gl_close();
    return 0;
}
