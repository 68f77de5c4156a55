/* lit.c - ray-traces light of an environment and of lights, and one bounce; one specular bounce. Declared in kit.h. */
#include "kit/kit_trace.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>chance ---------------------------------------------------------------------------------------------------- */

double kit_accumulate(float *cdf, int n)
{
    double total = 0, sum = 0;
    for (int i = 1; i <= n; ++i) total += (double)cdf[i];
    for (int i = 1; i <= n; ++i) {
        sum += (double)cdf[i];
        cdf[i] = total > 0 ? (float)(sum / total) : 0;
    }
    cdf[0] = 0;
    return total / n;
}

double kit_pick(const float *cdf, int n, float u)       /* returns the index at which the running sum is u, in [0, n) */
{
    int low = 0, high = n;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (cdf[middle] <= u) low = middle;
        else high = middle;
    }
    return low + fmin((double)(u - cdf[low]) / (double)(cdf[high] - cdf[low]), 0.999999);
}

/* ---- >>environment ----------------------------------------------------------------------------------------------- */

/* A lamp: a texel much brighter than the other texels. Bilinear interpolation makes it a hat function over its
   neighbours; the other texels are treated as if it were black. */
typedef struct lamp { int x, y; float rgb[3]; } lamp;

enum { MOST_LAMPS = 512 };

static const double LAMP = 50;                  /* times the mean luminance */

static double luminance_of(const kit_image *env, size_t i)
{
    const size_t texels = (size_t)env->width * (size_t)env->height;
    return 0.2126 * (double)env->data[i] + 0.7152 * (double)env->data[texels + i]
           + 0.0722 * (double)env->data[2 * texels + i];
}

/* Takes the lamps, at most the MOST_LAMPS brightest, out of the environment. Each place sends a ray to every lamp, so
   that a lamp's light is noisy only if it is half hidden. Rows at the poles have no lamps: hats are wider there. */
static int lamps_begin(kit_truth *job, kit_image *rest, kit_error *err)
{
    const kit_image *env = &job->lighting->env;
    const size_t texels = (size_t)env->width * (size_t)env->height;
    double mean = 0, least = 0, weight = 0;
    for (int y = 0; y < env->height; ++y) {
        const double area = sin(KIT_PI * (y + 0.5) / env->height);
        for (int x = 0; x < env->width; ++x, weight += area)
            mean += area * luminance_of(env, (size_t)y * (size_t)env->width + (size_t)x);
    }
    for (least = LAMP * mean / weight;; least *= 1.25) {
        job->lamps = 0;
        for (size_t i = (size_t)env->width; i < texels - (size_t)env->width; ++i)
            job->lamps += luminance_of(env, i) > least;
        if (job->lamps <= MOST_LAMPS) break;
    }
    if (!job->lamps || !isfinite(mean)) { job->lamps = 0; return 0; }
    job->lamp = malloc((size_t)job->lamps * sizeof *job->lamp);
    if (!job->lamp || kit_image_new(rest, env->width, env->height, "R,G,B", err))
        return kit_fail(err, "truth: no memory for an environment of %d x %d", env->width, env->height);
    memcpy(rest->data, env->data, 3 * texels * sizeof *rest->data);
    job->lamps = 0;
    for (size_t i = (size_t)env->width; i < texels - (size_t)env->width; ++i) {
        if (!(luminance_of(env, i) > least)) continue;
        lamp *l = &job->lamp[job->lamps++];
        l->x = (int)(i % (size_t)env->width);
        l->y = (int)(i / (size_t)env->width);
        for (size_t c = 0; c < 3; ++c) {
            l->rgb[c] = env->data[c * texels + i];
            rest->data[c * texels + i] = 0;
        }
    }
    job->env = rest;
    return 0;
}

/* Directions are drawn by cells, each a texel or a part of one, by its mean luminance times its solid angle. (For a
   part, its midpoint gives the bilinear mean exactly; for a texel, the midpoints of its quarters do.) Small cells
   follow a light of a few texels, within which radiance varies as much as over the sphere. */
enum { ENV_CELLS = 1 << 21, ENV_PARTS = 4 };

static void env_build_row(void *context, int y)
{
    const kit_truth *job = context;
    const kit_image *env = job->env;
    const int *cells = job->env_cells, parts = cells[0] / env->width, quarters = parts > 1 ? 1 : 4;
    float *column = job->env_column + (size_t)y * ((size_t)cells[0] + 1);
    for (int x = 0; x < cells[0]; ++x) {
        column[x + 1] = 0;
        for (int k = 0; k < quarters; ++k) {
            const double across = quarters > 1 ? 0.25 + 0.5 * (k & 1) : 0.5,
                         down = quarters > 1 ? 0.25 + 0.5 * (k >> 1) : 0.5;
            float d[3], rgb[3];
            kit_env_direction(env, (x + across) / parts, (y + down) / parts, d);
            kit_env_radiance(env, d, rgb);
            column[x + 1] += (0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2]) / (float)quarters;
        }
    }
    job->env_row[y + 1] = (float)(kit_accumulate(column, cells[0]) * sin(KIT_PI * (y + 0.5) / cells[1]));
}

/* Makes running sums over the environment's rows of cells, and along each row. A black one counts as none. */
static int env_begin(kit_truth *job, kit_error *err)
{
    const kit_image *env = job->env;
    int parts = ENV_PARTS;
    if (!env->data) return 0;
    while (parts > 1 && (size_t)env->width * (size_t)env->height * (size_t)(parts * parts) > ENV_CELLS) parts /= 2;
    job->env_cells[0] = parts * env->width;
    job->env_cells[1] = parts * env->height;
    job->env_row = malloc(((size_t)job->env_cells[1] + 1) * sizeof(float));
    job->env_column = malloc((size_t)job->env_cells[1] * ((size_t)job->env_cells[0] + 1) * sizeof(float));
    if (!job->env_row || !job->env_column)
        return kit_fail(err, "truth: no memory for an environment of %d x %d", env->width, env->height);
    kit_parallel(NULL, job->env_cells[1], env_build_row, job);
    if (!(kit_accumulate(job->env_row, job->env_cells[1]) > 0)) {
        free(job->env_row);
        job->env_row = NULL;
    }
    return 0;
}

static void env_direction(const kit_truth *job, const float at[2], float d[3])
{
    const kit_image *env = job->env;
    const int *cells = job->env_cells, parts = cells[0] / env->width;
    const double y = kit_pick(job->env_row, cells[1], at[1]);
    const float *column = job->env_column + (size_t)y * ((size_t)cells[0] + 1);
    kit_env_direction(env, kit_pick(column, cells[0], at[0]) / parts, y / parts, d);
}

static double env_density(const kit_truth *job, const float d[3])       /* probability density of env_direction */
{
    const kit_image *env = job->env;
    const int *cells = job->env_cells, parts = cells[0] / env->width;
    double at[2];
    kit_env_place(env, d, at);
    const size_t x = (size_t)fmin(at[0] * parts, cells[0] - 1), y = (size_t)fmin(at[1] * parts, cells[1] - 1);
    const float *row = job->env_row + y, *column = job->env_column + y * ((size_t)cells[0] + 1) + x;
    const double share = (double)(row[1] - row[0]) * (double)(column[1] - column[0]),
                 flat = sqrt((double)d[0] * (double)d[0] + (double)d[2] * (double)d[2]);
    return share * cells[0] * cells[1] / (2 * KIT_PI * KIT_PI * fmax(flat, 1e-9));
}

/* ---- >>light at a place ------------------------------------------------------------------------------------------ */

static double hat(float u) { return u < 0.5f ? sqrt(2 * (double)u) - 1 : 1 - sqrt(2 - 2 * (double)u); }

/* Adds the light of the lamps: one ray to each, at random within its hat. */
static void add_lamps(const kit_truth *job, const kit_place *at, uint32_t seed, double sum[3])
{
    const double texel = 2 * KIT_PI / job->env->width * KIT_PI / job->env->height;
    for (uint32_t i = 0; i < (uint32_t)job->lamps; ++i) {
        const lamp *l = &job->lamp[i];
        float u[2], d[3];
        kit_ambient_point(&job->ambient, i & job->ambient.mask, seed, u);
        kit_env_direction(job->env, l->x + 0.5 + hat(u[0]), l->y + 0.5 + hat(u[1]), d);
        const double cosine = kit_facing(at->n, d) / KIT_PI,
                     flat = sqrt((double)d[0] * (double)d[0] + (double)d[2] * (double)d[2]);
        if (!(cosine > 0)) continue;
        const double weight = (1 - kit_occluded(&job->ambient, at->origin, d, NULL)) * cosine * texel * flat;
        for (int c = 0; c < 3; ++c) sum[c] += weight * (double)l->rgb[c];
    }
}

/* Adds one direction's contribution to the environment's irradiance over pi. The strategies cosine and env have rays[0]
   and rays[1] rays: multiple importance sampling with the balance heuristic [Veach and Guibas 1995], so it does not
   matter which one drew the direction. */
static void add_env(const kit_truth *job, const float n[3], const float d[3], double visible, const int rays[2],
                    double sum[3])
{
    const double cosine = kit_facing(n, d) / KIT_PI;
    float rgb[3];
    if (!job->env_row || !(cosine > 0)) return;
    kit_env_radiance(job->env, d, rgb);
    const double weight = visible * cosine / (rays[0] * cosine + rays[1] * env_density(job, d));
    for (int c = 0; c < 3; ++c) sum[c] += weight * (double)rgb[c];
}

static void add_light(const kit_truth *job, const kit_place *at, const kit_light *light, double sum[3])
{
    const int sun = light->kind == KIT_SUN;
    float to[3];
    for (int i = 0; i < 3; ++i) to[i] = light->at[i] - (sun ? 0 : at->origin[i]);
    const double length = sqrt(kit_facing(to, to)),
                 weight = kit_facing(at->n, to) / length / KIT_PI / (sun ? 1 : length * length);
    if (!(weight > 0) || !isfinite(weight)) return;
    /* the ray ends before the light, so that a surface around it does not shadow it */
    const float all = sun ? INFINITY : 0.99999f, reach = job->lighting->reach;
    if (ssgi_trace_any(&job->ambient.trace, at->origin, to, 0, reach > 0 ? fminf(all, reach / (float)length) : all))
        return;
    for (int c = 0; c < 3; ++c) sum[c] += weight * (double)light->colour[c];
}

/* Adds the light that the hit of ray number r sends back, times the weight. */
static void add_sent(const kit_truth *job, const ssgi_hit *hit, const float d[3], uint32_t r, uint32_t seed,
                     double weight, int rays, double sum[3])
{
    const uint32_t hit_seed = kit_mix(seed ^ 0xc2b2ae35u), shuffle = kit_mix(seed ^ 0x27d4eb2fu);
    const int one[2] = { job->env_row != NULL, job->env_row != NULL };
    double light[3] = { 0 };
    kit_place next;
    kit_place_of(job->mesh, hit, d, &next);
    /* the index is shuffled, so that hits and directions from there stay independent */
    kit_gather(job, &next, hit_seed, kit_scramble(kit_reverse(r), shuffle) & job->ambient.mask, one, light, NULL);
    for (int c = 0; c < 3; ++c) sum[c] += weight * (double)next.albedo[c] * light[c] / rays;
}

void kit_gather(const kit_truth *job, const kit_place *at, uint32_t seed, uint32_t first, const int rays[2],
                   double irradiance[3], double *bounce)
{
    const kit_ambient *a = &job->ambient;
    const uint32_t env_seed = kit_mix(seed ^ 0x85ebca6bu);
    float u[2], d[3];
    for (uint32_t r = 0; r < (uint32_t)rays[0]; ++r) {
        ssgi_hit hit;
        kit_ambient_point(a, first + r, seed, u);
        kit_cosine_direction(at->n, u, d);
        const double weight = kit_occluded(a, at->origin, d, bounce ? &hit : NULL);
        add_env(job, at->n, d, 1 - weight, rays, irradiance);
        if (bounce && weight > 0) add_sent(job, &hit, d, r, seed, weight, rays[0], bounce);
    }
    for (uint32_t r = 0; r < (uint32_t)rays[1]; ++r) {
        kit_ambient_point(a, first + r, env_seed, u);
        env_direction(job, u, d);
        if (kit_facing(at->n, d) > 0)
            add_env(job, at->n, d, 1 - kit_occluded(a, at->origin, d, NULL), rays, irradiance);
    }
    for (int i = 0; i < job->lighting->lights; ++i) add_light(job, at, &job->lighting->light[i], irradiance);
}

/* ---- >>pictures -------------------------------------------------------------------------------------------------- */

static void lit_pixel(const kit_truth *job, uint32_t pixel, const kit_place *at, float *value)
{
    const int by_env = job->env_row ? job->ambient.rays / 2 : 0,
              rays[2] = { job->env_row || job->bounce ? job->ambient.rays - by_env : 0, by_env };
    double irradiance[3] = { 0 }, bounce[3] = { 0 };
    kit_gather(job, at, kit_mix(pixel), 0, rays, irradiance, job->bounce ? bounce : NULL);
    add_lamps(job, at, kit_mix(pixel ^ 0x165667b1u), irradiance);
    for (int c = 0; c < 3; ++c) {
        value[c] = (float)((double)at->albedo[c] * (irradiance[c] + bounce[c]));
        value[3 + c] = (float)irradiance[c];
        value[6 + c] = (float)bounce[c];
    }
}

/* Ray-traces an image of light. job: the caller sets pixel and the members that pixel reads. */
static int lit_run(kit_truth *job, kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius,
                   int attenuation, int rays, int stride, kit_error *err)
{
    const kit_lighting *lighting = job->lighting;
    if (lighting->lights < 0 || lighting->lights > KIT_MAX_LIGHTS)
        return kit_fail(err, "truth: %d lights: must be 0..%d", lighting->lights, KIT_MAX_LIGHTS);
    if (lighting->env.data && lighting->env.channels < 3)
        return kit_fail(err, "truth: the environment has %d channels: must have 3", lighting->env.channels);
    kit_image rest = { 0 };
    job->env = &lighting->env;
    const int failed =
        (job->pixel == lit_pixel && !job->bounce && lighting->env.data && lamps_begin(job, &rest, err))
        || env_begin(job, err)
        || kit_truth_run(job, out, KIT_LIT_CHANNELS, scene, camera, radius, attenuation, rays, stride, err);
    free(job->env_row);
    free(job->env_column);
    free(job->lamp);
    kit_image_free(&rest);
    return failed ? -1 : 0;
}

int kit_truth_lit(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                  float radius, int attenuation, int bounce, int rays, int stride, kit_error *err)
{
    kit_truth job = { .pixel = lit_pixel, .lighting = lighting, .bounce = bounce };
    if (bounce != 0 && bounce != 1) return kit_fail(err, "truth: bounce %d: must be 0 or 1", bounce);
    return lit_run(&job, out, scene, camera, radius, attenuation, rays, stride, err);
}

static void gloss_pixel(const kit_truth *job, uint32_t pixel, const kit_place *at, float *value)
{
    const kit_ambient *a = &job->ambient;
    const uint32_t seed = kit_mix(pixel);
    float origin[3], toward[3], mirrored[3];
    double sum[3] = { 0 };
    kit_camera_ray(&job->camera, (int)(pixel % (uint32_t)job->camera.width), (int)(pixel / (uint32_t)job->camera.width),
                   origin, toward);
    kit_mirror(toward, at->n, mirrored);
    for (uint32_t r = 0; r < (uint32_t)a->rays; ++r) {
        ssgi_hit hit;
        float u[2], d[3];
        kit_ambient_point(a, r, seed, u);
        const double z = pow((double)u[0], 1 / (job->exponent + 1)), flat = sqrt(fmax(0, 1 - z * z)),
                     turn = 2 * KIT_PI * (double)u[1];
        kit_around(mirrored, (float)(flat * cos(turn)), (float)(flat * sin(turn)), (float)z, d);
        const double weight = kit_facing(at->n, d) > 0 ? kit_occluded(a, at->origin, d, &hit) : 0;
        if (weight > 0) add_sent(job, &hit, d, r, seed, weight, a->rays, sum);
    }
    for (int c = 0; c < 3; ++c) {
        value[c] = (float)((double)at->albedo[c] * sum[c]);
        value[3 + c] = (float)sum[c];
        value[6 + c] = 0;
    }
}

int kit_truth_gloss(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                    float radius, int attenuation, double exponent, int rays, int stride, kit_error *err)
{
    kit_truth job = { .pixel = gloss_pixel, .lighting = lighting, .exponent = exponent };
    if (!(exponent >= 0 && exponent <= 1e5)) return kit_fail(err, "truth: exponent %g: must be 0..1e5", exponent);
    return lit_run(&job, out, scene, camera, radius, attenuation, rays, stride, err);
}
