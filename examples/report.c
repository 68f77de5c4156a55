/* report.c - what the methods are worth: pictures beside the truth, and speed against accuracy.

      build/report demo  [--out report] [--mesh M.obj]                 pictures, tables and demo.html, in two minutes
      build/report chart [--out report] [--quick] [--scene NAME]...    chart*.csv, chart*.svg and chart.html, in some minutes

   With --mesh or --scene only ambient occlusion is shown; else light, fields and deep screen space, too. Truth is kept under build/cache/. Bad input, or a write that fails: one
   line on stderr, status 2. page.c holds what is written and how, lit.c what is shown of light, fields.c of ambient occlusion fields, deep.c of deep screen space. */
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
enum { RAYS = 256, FLOOR_STRIDE = 4, DEMO_ROUNDS = 7, CHART_ROUNDS = 5, QUICK_ROUNDS = 3 };

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
    { "hsao, full size", "hsao-best",  "directions=1,steps=3",                0 },
    { "hsao, full size", "hsao-best",  "directions=1,steps=4",                1 },
    { "hsao, full size", "hsao-best",  "directions=1,steps=6",                1 },
    { "hsao, full size", "hsao-best",  "directions=2,steps=6",                0 },
    { "hsao, full size", "hsao-best",  "",                                    1 },
    { "hsao, full size", "hsao-best",  "directions=8,steps=12",               0 },
    { "hsao-march",      "hsao-march", "directions=4,steps=6,normal_rays=0",  1 },
    { "hsao-march",      "hsao-march", "directions=4,steps=6,normal_rays=1",  0 },
    { "hsao-march",      "hsao-march", "",                                    1 },
    { "hsao-march",      "hsao-march", "directions=8,steps=18,normal_rays=2", 0 }
};

#define COUNT(table) ((int)(sizeof (table) / sizeof (table)[0]))
enum { MOST_ENTRIES = COUNT(chart_entries) > COUNT(demo_entries) ? COUNT(chart_entries) : COUNT(demo_entries), MOST_ROWS = MOST_ENTRIES + 2, MOST_SCENES = 16 };

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
    { "colonnade", "colonnade", 0, { 0 }, { 0 }, 0, 0, NULL }
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
    if (!s->between && kit_floor_ao(&picture, &s->frame, c, s->radius, KIT_ATTENUATION_LINEAR, RAYS, FLOOR_STRIDE, err)) return -1;
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
    camera.width = width;
    camera.height = height;
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
    kit_image out;
    const size_t pixels = (size_t)visibility->width * (size_t)visibility->height;
    if (!s->givens) return kit_fail(err, "%s: ambient visibility has no environment to dim", s->name);
    if (kit_image_new(&out, visibility->width, visibility->height, KIT_LIT_CHANNELS, err)) return -1;
    for (size_t i = 0; i < pixels * (size_t)out.channels; ++i)
        out.data[i] = s->direct.data[i] + (s->given[0].picture.data[i] - s->direct.data[i]) * visibility->data[i % pixels];
    kit_image_free(visibility);
    *visibility = out;
    return 0;
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

/* Times runs: each once a round between two drawings of the reference, whose mean its time is divided by; medians. Where there is light, ambient visibility's
   includes the lights' passes. Closes the runs. */
static int clock_runs(row *rows, stage *s, kit_run *run, int count, int rounds, kit_error *err)
{
    double *ratio = calloc((size_t)(2 * count * rounds), sizeof *ratio), *ms = ratio + count * rounds, before, after;
    kit_run fixed;
    char what[128];
    if (!ratio) return kit_fail(err, "out of memory");
    if (run_open(&fixed, s, reference.method, reference.settings, s->radius, err)) return -1;
    kit_run_draw(&fixed, 1);
    snprintf(what, sizeof what, "%s: times", s->name);
    kit_progress(what, 0);
    for (int k = 0; k < rounds; ++k) {
        before = draw(&fixed);
        for (int i = 0; i < count; ++i, before = after) {
            ms[i * rounds + k] = draw(&run[i]) + (s->lit && !run[i].lit ? draw(&s->lights) : 0);
            after = draw(&fixed);
            ratio[i * rounds + k] = ms[i * rounds + k] / (0.5 * (before + after));
            kit_progress(what, (k * count + i + 0.99) / (rounds * count));
        }
    }
    kit_progress(what, 1);
    for (int i = 0; i < count; ++i) {
        rows[i].relative = median(ratio + i * rounds, rounds);
        rows[i].ms = median(ms + i * rounds, rounds);
        if (run[i].surfels) count_surfels(&rows[i], &run[i]);
        kit_run_close(&run[i]);
    }
    kit_run_close(&fixed);
    free(ratio);
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
        r->fetches = r->relative = r->ms = (double)NAN;
        if (score(r, s, &s->given[i].picture, err)) return -1;
        if (!strcmp(r->label, "floor") && FLOOR_STRIDE > 1) r->score.ssim = (double)NAN;      /* has no neighbours */
    }
    for (int i = 0; i < count + s->givens; ++i) rows[i].scene = s->name;
    return 0;
}

/* ---- >>demo -------------------------------------------------------------------------------------------------------- */

typedef struct options { const char *out, *mesh, *scene[MOST_SCENES]; int quick, scenes; } options;

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

#include "lit.c"
#include "fields.c"
#include "deep.c"

static int demo(const options *o, kit_error *err)
{
    enum { ENTRIES = COUNT(demo_entries) };
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
    if (measure(rows, &s, demo_entries, ENTRIES, DEMO_ROUNDS, picture, err)) return -1;
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
    for (int i = 0; i < ENTRIES; ++i) {
        slug_of(slug, demo_entries[i].label);
        if (kit_image_difference(&difference, &picture[i], &s.truth, "Y", 0.5f, err)) return -1;
        if (save(&picture[i], "Y", 0, o->out, slug, ".png", err) || save(&picture[i], "Y", 0, o->out, slug, ".exr", err)) return -1;
        if (save(&difference, "R,G,B", 0, o->out, slug, "-difference.png", err) || save(&difference, "R,G,B", 0, o->out, slug, "-difference.exr", err)) return -1;
        kit_image_free(&difference);
        kit_image_free(&picture[i]);
        snprintf(note, sizeof note, "time %.2f, error %.3f", rows[i].relative, rows[i].share);
        figure_html(p.file, slug, demo_entries[i].label, note, 1280, 720, 1);
        fputs("</figure>\n", p.file);
    }
    fputs("</div>\n<h3>Figures</h3>\n", p.file);
    table_html(p.file, rows, ENTRIES + 2);
    stage_close(&s);
    for (int k = 0; k < LIT_DEMOS && !o->mesh; ++k) if (lit_demo(p.file, o->out, &lit_demos[k], lit_rows[k], &lit_count[k], err)) return -1;
    if (!o->mesh && (field_demo(p.file, o->out, field_rows, err) || deep_demo(p.file, o->out, deep_sets, err))) return -1;
    html_terms(p.file);
    if (!o->mesh) lit_terms(p.file);
    if (!o->mesh) field_terms(p.file);
    if (!o->mesh) deep_terms(p.file);
    if (page_close(&p, o->out, "demo.html", err)) return -1;
    table_text(stdout, rows, ENTRIES + 2);
    for (int k = 0; k < LIT_DEMOS && !o->mesh; ++k) {
        printf("\n%s\n", lit_demos[k].title);
        table_text(stdout, lit_rows[k], lit_count[k]);
    }
    if (!o->mesh) {
        printf("\n%s\n", field_demo_title);
        table_text(stdout, field_rows, FIELD_DEMO_ROWS);
        deep_text(stdout, deep_sets, DEEP_DEMOS);
    }
    printf("\ntime: relative to one unblurred 16-sample ssao; ms on %s\nshare: RMSE over that of having no AO; floor: the exact answer from one depth layer\n", kit_gl_name());
    if (!o->mesh) printf("radiance, irradiance, bounce and their biases: over the truth's means\n");
    printf("pictures: %s/demo.html\n", o->out);
    return 0;
}

/* ---- >>chart ------------------------------------------------------------------------------------------------------- */

static void mean_of(row *mean, const row (*rows)[MOST_ROWS], int scenes, int count)
{
    for (int i = 0; i < count; ++i) {
        row m = rows[0][i];
        m.scene = "mean";
        m.relative = m.ms = m.share = 0;
        memset(&m.score, 0, sizeof m.score);
        for (int s = 0; s < scenes; ++s) {
            const row *r = &rows[s][i];
            m.relative += r->relative / scenes;
            m.ms += r->ms / scenes;
            m.share += r->share / scenes;
            m.score.rmse += r->score.rmse / scenes;
            m.score.bias += r->score.bias / scenes;
            m.score.p95 += r->score.p95 / scenes;
            m.score.ssim += r->score.ssim / scenes;
            m.score.pixels += r->score.pixels;
        }
        mean[i] = m;
    }
}

static int chart(const options *o, kit_error *err)
{
    static row rows[MOST_SCENES][MOST_ROWS];
    static char names[MOST_SCENES][64];
    static lit_row_set lit_rows[LIT_SETS];
    static field_row_set field_sets[FIELD_SETS];
    static deep_set deep_sets[DEEP_SETS];
    row mean[MOST_ROWS];
    entry entries[MOST_ENTRIES];
    page html, csv;
    char about[512], title[256], file[128];
    int count = 0, scenes = o->scenes ? o->scenes : COUNT(views), width = o->quick ? 640 : 1280, height = o->quick ? 360 : 720;
    for (int i = 0; i < COUNT(chart_entries); ++i) if (chart_entries[i].quick || !o->quick) entries[count++] = chart_entries[i];
    for (int k = 0; k < scenes; ++k) {
        view v;
        stage s;
        memset(&v, 0, sizeof v);
        if (o->scenes) v.name = v.path = o->scene[k]; else v = views[k];
        for (int i = 0; i < COUNT(views); ++i) if (!strcmp(views[i].name, v.name)) v = views[i];
        if (stage_open(&s, &v, width, height, err) || measure(rows[k], &s, entries, count, o->quick ? QUICK_ROUNDS : CHART_ROUNDS, NULL, err)) return -1;
        memcpy(names[k], s.name, sizeof names[k]);
        for (int i = 0; i < count + 2; ++i) rows[k][i].scene = names[k];
        stage_close(&s);
    }
    count += 2;
    mean_of(mean, (const row (*)[MOST_ROWS])rows, scenes, count);

    if (page_open(&csv, err)) return -1;
    for (int k = 0; k < scenes; ++k) table_csv(csv.file, rows[k], count, !k);
    if (page_close(&csv, o->out, "chart.csv", err)) return -1;

    if (page_open(&html, err)) return -1;
    snprintf(about, sizeof about, "Ambient occlusion against ray-traced truth (%d rays a pixel, linear attenuation), %d x %d pixels. Times: %s.", RAYS, width, height, kit_gl_name());
    html_head(html.file, "ssgi: speed against accuracy", about);
    snprintf(title, sizeof title, scenes > 1 ? "Speed against accuracy, mean of %d scenes" : "Speed against accuracy", scenes);
    fprintf(html.file, "<h2>Mean of the scenes</h2>\n");
    if (chart_of(html.file, o->out, "chart.svg", title, &ao_words, mean, count, mean[count - 2].share, err)) return -1;
    fputs("<p class=\"faint\">Rest the pointer on a point for its settings.</p>\n", html.file);
    table_html(html.file, mean, count);
    fputs("<h2>Scene by scene</h2>\n<div class=\"charts\">\n", html.file);
    for (int k = 0; k < scenes; ++k) {
        snprintf(file, sizeof file, "chart-%.63s.svg", names[k]);
        snprintf(title, sizeof title, "Speed against accuracy: %.63s", names[k]);
        if (chart_of(html.file, o->out, file, title, &ao_words, rows[k], count, rows[k][count - 2].share, err)) return -1;
    }
    fputs("</div>\n", html.file);
    for (int k = 0; k < scenes; ++k) {
        fputs("<details><summary>Figures: ", html.file);
        escaped(html.file, names[k]);
        fputs("</summary>\n", html.file);
        table_html(html.file, rows[k], count);
        fputs("</details>\n", html.file);
    }
    if (!o->scenes && (lit_chart(html.file, o, lit_rows, err) || field_chart(html.file, o, field_sets, err) || deep_chart(html.file, o, deep_sets, err))) return -1;
    html_terms(html.file);
    if (!o->scenes) lit_terms(html.file);
    if (!o->scenes) field_terms(html.file);
    if (!o->scenes) deep_terms(html.file);
    fprintf(html.file, "<p class=\"faint\">The same figures as text: <a href=\"chart.csv\">chart.csv</a>%s.</p>\n", o->scenes ? "" : ", <a href=\"chart-lit.csv\">chart-lit.csv</a>, <a href=\"chart-aof.csv\">chart-aof.csv</a>, <a href=\"chart-deep.csv\">chart-deep.csv</a>");
    if (page_close(&html, o->out, "chart.html", err)) return -1;
    printf("mean of:");
    for (int k = 0; k < scenes; ++k) printf("%s %s", k ? "," : "", names[k]);
    printf("\n");
    table_text(stdout, mean, count);
    if (!o->scenes) lit_chart_text(stdout, lit_rows);
    if (!o->scenes) field_chart_text(stdout, field_sets);
    if (!o->scenes) deep_text(stdout, deep_sets, DEEP_SETS);
    printf("\ntime: relative to one unblurred 16-sample ssao; ms on %s\ncharts: %s/chart.html\n", kit_gl_name(), o->out);
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
        if (strcmp(a, "--out") && strcmp(a, is_chart ? "--scene" : "--mesh")) return kit_fail(err, "%s: %s takes no such argument (report alone prints what there is)", a, argv[1]);
        if (!v || !*v) return kit_fail(err, "%s: needs a value", a);
        ++i;
        if (!strcmp(a, "--out")) o->out = v;
        else if (!is_chart) o->mesh = v;
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
    if (argc < 2) {
        fputs("usage: report demo  [--out FOLDER] [--mesh M.obj]                pictures beside the truth\n"
              "       report chart [--out FOLDER] [--quick] [--scene NAME]...   speed against accuracy\n", stderr);
        return 2;
    }
    is_chart = !strcmp(argv[1], "chart");
    if (!is_chart && strcmp(argv[1], "demo")) kit_fail(&err, "%s: there is no such command (demo, chart)", argv[1]);
    else if (!parse(&o, is_chart, argc, argv, &err) && !folder(o.out, &err) && !kit_gl_open(NULL, &err)
        && !(is_chart ? chart(&o, &err) : demo(&o, &err)) && (fflush(stdout) || ferror(stdout))) kit_fail(&err, "standard output: cannot be written");
    if (*err.text) {
        kit_progress("", 1);
        fprintf(stderr, "report: %s\n", err.text);
        return 2;
    }
    kit_gl_close();
    return 0;
}
