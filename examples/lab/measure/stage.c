/* stage.c - a scene, its light, its G-buffer and its truth; methods drawn on it, scored and timed. Declared in
   report.h. */
#include "lab/report.h"
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

const entry reference = { "ssao, no blur", "ssao", "samples=16,blur=0", 1 };   /* what times are relative to */
/* a quick chart's pictures have so many times shorter sides, and its truth that squared fewer rays, but no fewer
   than LEAST_RAYS */
int thrift = 1;

/* attic and maple are kept aside while settings are tuned. */
const view views[] = {
    { "bunny",     BUNNY,       1, { -1.4f, 1.1f, 3.7f }, { 0, -0.13f, 0 }, 33, 0.6f, NULL },
    { "room",      "room",      0, { 0 }, { 0 }, 0, 0, NULL },
    { "grass",     "grass",     0, { 0 }, { 0 }, 0, 0, NULL },
    { "colonnade", "colonnade", 0, { 0 }, { 0 }, 0, 0, NULL },
    { "plates",    "plates",    0, { 0 }, { 0 }, 0, 0, NULL },
    { "pebbles",   "pebbles",   0, { 0 }, { 0 }, 0, 0, NULL },
    { "iron-bed",  BED,         1, { -170, 125, 270 }, { 0, 40, 0 }, 32, 20, NULL },
    { "slats",     "slats",     0, { 0 }, { 0 }, 0, 0, NULL },
    { "stairs",    HOUSE,       0, { 10.9f, 1.65f, -0.9f }, { 7.4f, 1.5f, -3.4f }, 60, 0.5f, NULL },
    { "attic",     HOUSE,       0, { 11.3f, 4.9f, -4.9f }, { 7.2f, 2.9f, -2.6f }, 60, 0.6f, NULL },
    { "maple",     MAPLE,       1, { 150, 1350, 500 }, { -60, 840, -40 }, 25, 60, NULL }
};
enum { VIEWS = COUNT(views) };
const int views_count = VIEWS;

const char *packages_of(const char *path)
{
    static const char *const of[][2] = { { BED, "sweethome3d-furniture" }, { MAPLE, "sweethome3d-furniture" },
        { HOUSE, "assimp-testmodels, by assimp-utils" } };
    for (int i = 0; i < COUNT(of) && path; ++i) if (!strcmp(path, of[i][0])) return of[i][1];
    return NULL;
}

/* Four coloured boxes around the bunny, just above the floor. Bounds, albedo. */
static const float boxes[4][9] = {
    {  1.07f, -0.989f, -0.10f,  1.25f, -0.20f,  0.75f,  0.85f, 0.08f, 0.05f },
    {  0.25f, -0.989f,  0.82f,  0.62f, -0.72f,  1.14f,  0.85f, 0.60f, 0.04f },
    { -1.55f, -0.989f, -0.55f, -0.85f, -0.35f, -0.35f,  0.08f, 0.55f, 0.08f },
    { -0.95f, -0.989f,  0.55f, -0.65f, -0.70f,  0.90f,  0.06f, 0.14f, 0.80f }
};

/* ---- >>stage: a scene, its light, its G-buffer, its truth and what else is shown beside methods ------------------ */

int folder(const char *path, kit_error *err)
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

int trace(kit_image *out, const stage *s, int rays, int stride, kit_error *err)
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

/* The truth, from build/cache where it was computed before: the file's name holds a hash of all that it depends on, and
   a few hundred pixels are traced anew, so that another tracer does not reuse it either. */
static int truth_of(stage *s, kit_error *err)
{
    const kit_camera *c = &s->gbuffer.camera;
    const size_t floats = 9 * s->scene.mesh.triangles * sizeof(float), pixels = (size_t)c->width * (size_t)c->height;
    uint64_t h = kit_hash(KIT_HASH, s->scene.mesh.position, floats);
    char path[256];
    kit_image probe;
    kit_error note;
    h = kit_hash(h, s->scene.mesh.normal, floats);
    h = kit_hash(h, c, sizeof *c);
    h = kit_hash(h, &s->radius, sizeof s->radius);
    if (s->lit) {
        h = kit_hash(h, s->scene.mesh.albedo, floats / 3);
        if (s->traced.env.data)
            h = kit_hash(h, s->traced.env.data,
                         3 * sizeof(float) * (size_t)s->traced.env.width * (size_t)s->traced.env.height);
        h = kit_hash(h, s->traced.light, (size_t)s->traced.lights * sizeof(kit_light));
        if (s->otherwise.hard || s->otherwise.kind) h = kit_hash(h, &s->otherwise, offsetof(otherwise, material));
        if (s->otherwise.material) h = kit_hash(h, s->otherwise.material, strlen(s->otherwise.material));
    }
    if (s->between) h = kit_hash(h, s->scene.mesh.object, s->scene.mesh.triangles * sizeof *s->scene.mesh.object);
    for (int i = 0; i < s->scene.objects && s->between; ++i)
        h = kit_hash(h, &s->scene.object[i].casts, sizeof s->scene.object[i].casts);
    if (s->stride > 1) h = kit_hash(h, &s->stride, sizeof s->stride);
    snprintf(path, sizeof path, "build/cache/%s-%s%dx%d-%g-%d-%016llx.exr", s->name,
             s->between                   ? "objects-"
             : !s->lit                    ? ""
             : s->otherwise.kind == GLOSS ? "gloss-"
             : s->otherwise.kind          ? "scatter-"
             : s->lit->bounce             ? "lit-"
                                          : "direct-",
             c->width, c->height, (double)s->radius, s->rays, (unsigned long long)h);
    if (!kit_exr_read(&s->truth, path, NULL)) {
        int same = s->truth.width == c->width && s->truth.height == c->height;
        if (trace(&probe, s, s->rays, 61, err)) return -1;
        for (int k = 0; k < probe.channels && same; ++k) {
            const float *was = kit_image_channel(&s->truth, probe.name[k]),
                        *is = kit_image_channel(&probe, probe.name[k]);
            same = was != NULL;
            for (size_t i = 0; i < pixels && same; ++i) same = isnan(is[i]) || isnan(was[i]) || is[i] == was[i];
        }
        kit_image_free(&probe);
        if (same) return 0;
        kit_image_free(&s->truth);
    }
    if (trace(&s->truth, s, s->rays, s->stride > 1 ? s->stride : 1, err)) return -1;
    if (folder("build/cache", &note) || kit_exr_write(&s->truth, path, &note))
        fprintf(stderr, "report: note: the truth is not kept: %s\n", note.text);
    return 0;
}

int stage_visibility(kit_image *out, const stage *s, kit_error *err)
{
    stage dark = *s;
    char *end = strrchr(dark.name, '-');            /* of a pair: one truth for all its probes */
    if (end) *end = 0;
    dark.lit = NULL;
    dark.rays = RAYS;
    memset(&dark.truth, 0, sizeof dark.truth);
    if (truth_of(&dark, err)) return -1;
    *out = dark.truth;
    return 0;
}

int run_open(kit_run *run, stage *s, const char *method, const char *set, float radius, kit_error *err)
{
    const kit_world world = { &s->scene, &s->lighting };
    kit_method m;
    return kit_method_find(&m, method, err) || kit_method_set(&m, set, err)
                   || kit_run_open(run, &s->gbuffer, &m, radius, &world, err)
               ? -1
               : 0;
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
    if (run_open(&run, s, "ssdo-points", s->lit->local ? "bounce=none,blur=0,shadows=none" : "bounce=none,blur=0",
                 1e-4f * s->radius, err))
        return -1;
    kit_run_draw(&run, 0);
    if (kit_run_read(&picture, &run, err)) return -1;
    kit_run_close(&run);
    return give(s, "no AO", "none", &picture);
}

static int stage_ao(stage *s, kit_error *err)
{
    const kit_camera *c = &s->gbuffer.camera;
    kit_image picture;
    if (!s->between
        && kit_floor_ao(&picture, &s->frame, c, s->radius, KIT_ATTENUATION_LINEAR, s->rays, FLOOR_STRIDE, err))
        return -1;
    if (!s->between) give(s, "floor", "floor", &picture);
    if (kit_image_new(&s->unit, c->width, c->height, "Y", err)
        || kit_image_new(&picture, c->width, c->height, "Y", err))
        return -1;
    for (size_t i = 0; i < (size_t)c->width * (size_t)c->height; ++i) s->unit.data[i] = picture.data[i] = 1;
    return give(s, "no AO", "none", &picture);
}

int stage_lit(stage *s, kit_error *err)
{
    if (kit_image_new(&s->unit, s->gbuffer.camera.width, s->gbuffer.camera.height, KIT_LIT_CHANNELS, err)) return -1;
    if (run_open(&s->lights, s, "ssdo",
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

/* What lights the scene; where suns are local, the truth has them in its environment. */
static int light_up(stage *s, kit_error *err)
{
    const lit *l = s->lit;
    if (l->env && kit_env_read(&s->lighting.env, l->env, err)) return -1;
    for (int i = 0; i < MOST_SUNS && l->light[i]; ++i)
        if (kit_light_parse(&s->lighting.light[s->lighting.lights++], l->light[i], err)) return -1;
    s->traced = s->lighting;
    if (!l->local) return 0;
    memset(&s->traced, 0, sizeof s->traced);
    if (l->env && kit_env_read(&s->traced.env, l->env, err)) return -1;
    for (int i = 0; i < s->lighting.lights; ++i)
        if (kit_env_add_sun(&s->traced.env, &s->lighting.light[i], SUN, err)) return -1;
    return 0;
}

/* Loads the scene, and its light; what the scene is of may change until it is shown. */
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
    s->lit = v->lit;
    s->rays = s->lit ? s->lit->rays : RAYS;
    if (s->lit) {
        for (int i = 0; i < s->lit->boxes; ++i)
            if (kit_scene_add_box(&s->scene, boxes[i], boxes[i] + 3, boxes[i] + 6, err)) return -1;
        if (light_up(s, err)) return -1;
    }
    return 0;
}

/* What is seen, without its truth. */
int stage_look(stage *s, const view *v, int width, int height, kit_error *err)
{
    kit_camera camera = s->scene.camera;
    if (v->fovy > 0) {
        memcpy(camera.eye, v->eye, sizeof v->eye);
        memcpy(camera.target, v->target, sizeof v->target);
        camera.fovy = v->fovy;
    }
    camera.width = width / thrift;
    camera.height = height / thrift;
    if (s->rays > LEAST_RAYS)
        s->rays = s->rays > LEAST_RAYS * thrift * thrift ? s->rays / (thrift * thrift) : LEAST_RAYS;
    s->radius = v->radius > 0 ? v->radius : s->scene.radius;
    return kit_gbuffer_from_scene(&s->gbuffer, &s->scene, &camera, NULL, err)
        || kit_gbuffer_read(&s->frame, &s->gbuffer, err)
        || kit_image_places(&s->places, &s->frame, &s->gbuffer.camera, s->radius, err) ? -1 : 0;
}

int stage_compare(stage *s, kit_error *err)
{
    const size_t pixels = (size_t)s->frame.width * (size_t)s->frame.height;
    if (truth_of(s, err)) return -1;
    for (size_t i = 0; i < pixels; ++i) {
        if (!isnan(s->truth.data[i])) continue;
        kit_image_channel(&s->frame, "Z")[i] = 0;
        for (size_t k = 0; k < KIT_PLACES; ++k) s->places.data[k * pixels + i] = 0;
    }
    return s->lit ? stage_lit(s, err) : stage_ao(s, err);
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
    kit_image_free(&s->places);
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

/* ---- >>measure --------------------------------------------------------------------------------------------------- */

/* Edges, border and interior apart. */
static int score_places(row *r, const stage *s, const kit_image *picture, const char *const *channels, kit_error *err)
{
    kit_score_place place[KIT_PLACES];
    if (s->places.width != picture->width || s->places.height != picture->height) return 0;
    if (kit_score_places(place, picture, &s->truth, channels, s->lit ? 3 : 1, &s->places, err)) return -1;
    for (int k = 0; k < KIT_PLACES; ++k) {
        const double none = place[k].score.pixels ? 0 : (double)NAN;
        r->figure[PLACE_ERROR + k] = place[k].error;
        r->figure[PLACE_AREA + k] = place[k].area;
        r->figure[PLACE_RMSE + k] = place[k].score.rmse + none;
        r->figure[PLACE_BIAS + k] = place[k].score.bias + none;
    }
    return 0;
}

/* Scores a picture over what the frame shows, and where the picture is known; the unit on the same pixels. */
int score(row *r, const stage *s, const kit_image *picture, kit_error *err)
{
    static const char *const names[4][3] = { { "R", "G", "B" },
                                             { "irradiance.R", "irradiance.G", "irradiance.B" },
                                             { "bounce.R", "bounce.G", "bounce.B" },
                                             { "Y", NULL, NULL } };
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
        failed = kit_score_channels(&here, picture, &s->truth, names[g], s->lit ? 3 : 1, mask, err)
                 || kit_score_channels(&unit, &s->unit, &s->truth, names[g], s->lit ? 3 : 1, mask, err);
        const double share = s->lit ? -unit.bias : unit.rmse, known = share > 0 ? 1 / share : (double)NAN;
        if (s->stride > 1) here.ssim = (double)NAN;      /* has no neighbours */
        if (g % 3 == 0) r->score = here;
        if (g % 3 == 0) r->share = here.rmse * known;
        if (s->lit) r->error[g] = here.rmse * known;
        if (s->lit) r->bias[g] = here.bias * known;
        if (!failed && (g == 1 || (g == 3 && !s->between))) failed = score_places(r, s, picture, names[g], err);
    }
    free(mask);
    return failed ? -1 : 0;
}

/* Lit by ambient visibility: it dims the environment's light, not the lights'. */
int light_by(kit_image *visibility, const stage *s, kit_error *err)
{
    if (!s->givens) return kit_fail(err, "%s: ambient visibility has no environment to dim", s->name);
    return kit_dim(visibility, &s->given[0].picture, &s->direct, err);
}

double draw(kit_run *run)
{
    kit_run_draw(run, 1);
    return kit_run_ms(run);
}

/* With a history: so many frames of a still camera, numbered from first; else one. */
int draw_settled(kit_run *run, unsigned first, int timed, kit_error *err)
{
    const int kept = kit_run_keeps(run);
    for (unsigned k = 0; k < (kept ? (unsigned)SETTLED : 1); ++k)
        if (kit_frames_still(run, first, k, timed, err)) return -1;
    return kept;
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

/* Whether so many ratios lie within AGREED of their least. */
static int agreed(const double *ratio, int count)
{
    double least = ratio[0], most = ratio[0];
    for (int k = 1; k < count; ++k) {
        least = fmin(least, ratio[k]);
        most = fmax(most, ratio[k]);
    }
    return most < (1 + AGREED) * least;
}

/* Times what once(of, i) draws, all drawn before, in ms: each once a round between two drawings of the reference, whose
   mean its time is divided by; medians. What is slow, or agrees with itself, sits out late rounds. */
int clock_all(row *rows, stage *s, double (*once)(void *of, int i), void *of, int count, int rounds, kit_error *err)
{
    double *ratio = calloc((size_t)(2 * count * rounds), sizeof *ratio), *ms = ratio + count * rounds, before, after;
    int *drawn = calloc((size_t)count, sizeof *drawn);
    kit_run fixed;
    char what[128];
    int failed = ratio && drawn ? run_open(&fixed, s, reference.method, reference.settings, s->radius, err)
                                : kit_fail(err, "out of memory");
    if (failed) { free(ratio); free(drawn); return -1; }
    kit_run_draw(&fixed, 1);
    snprintf(what, sizeof what, "%s: times", s->name);
    kit_progress(what, 0);
    for (int k = 0; k < rounds; ++k) {
        before = draw(&fixed);
        for (int i = 0; i < count; ++i) {
            double *const r = ratio + i * rounds, *const t = ms + i * rounds;
            if (k >= LEAST_ROUNDS && (t[0] > SLOW * before || agreed(r, drawn[i]))) continue;
            t[drawn[i]] = once(of, i);
            after = draw(&fixed);
            r[drawn[i]] = t[drawn[i]] / (0.5 * (before + after));
            ++drawn[i];
            before = after;
            kit_progress(what, (k * count + i + 0.99) / (rounds * count));
        }
    }
    kit_progress(what, 1);
    for (int i = 0; i < count; ++i) {
        rows[i].relative = kit_median(ratio + i * rounds, drawn[i]);
        rows[i].ms = kit_median(ms + i * rounds, drawn[i]);
    }
    free(drawn);
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
int clock_runs(row *rows, stage *s, kit_run *run, int count, int rounds, kit_error *err)
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

/* Fills a row an entry, then one for each of what is given: count + s->givens in all. Every entry is drawn once to warm
   up, with a history SETTLED frames (that picture is scored), over so many phases of its noise (0: one, and no split is
   known), then timed. pictures: NULL, or an empty one an entry. */
int measure(row *rows, stage *s, const entry *entries, int count, int rounds, int phases, kit_image *pictures,
            kit_error *err)
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
        if (draw_settled(&run[i], 0, 1, err) < 0 || kit_run_read(&picture, &run[i], err)
            || (s->lit && !run[i].lit && light_by(&picture, s, err))
            || score(&rows[i], s, &picture, err)
            || (phases && split(&rows[i], s, &run[i], phases, &picture, err)))
            return -1;
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
        if (score(r, s, &s->given[i].picture, err)
            || (phases && split(r, s, NULL, phases, &s->given[i].picture, err)))
            return -1;
        if (!strcmp(r->label, "floor") && FLOOR_STRIDE > 1) r->score.ssim = (double)NAN;      /* has no neighbours */
    }
    for (int i = 0; i < count + s->givens; ++i) rows[i].scene = s->name;
    return 0;
}
