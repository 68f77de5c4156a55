/* truth.c - ray-traces ground truth: rays from a point, an image of them, ambient visibility. Declared in kit.h and
   kit_trace.h. */
#include "kit/kit_trace.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>rays from a point ----------------------------------------------------------------------------------------- */

int kit_ambient_begin(kit_ambient *a, float radius, int attenuation, int rays, const char *what, kit_error *err)
{
    memset(a, 0, sizeof *a);
    if (attenuation < KIT_ATTENUATION_LINEAR || attenuation > KIT_ATTENUATION_SQUARE)
        return kit_fail(err, "%s: attenuation %d: there is no such", what, attenuation);
    if (!(radius > 0) || (!isfinite(radius) && attenuation != KIT_ATTENUATION_NONE))
        return kit_fail(err, "%s: radius %g: must be above 0, and finite unless nothing is attenuated", what,
                        (double)radius);
    if (rays < 1 || rays > 65536) return kit_fail(err, "%s: rays %d: must be 1..65536", what, rays);
    a->radius = radius;
    a->attenuation = attenuation;
    a->rays = rays;
    while (a->mask + 1 < (uint32_t)rays) a->mask = 2 * a->mask + 1;
    a->points = malloc(((size_t)a->mask + 1) * sizeof *a->points);
    if (!a->points) return kit_fail(err, "%s: no memory for %d rays", what, rays);
    for (uint32_t i = 0; i <= a->mask; ++i) {
        uint32_t second = 0;
        for (uint32_t v = 1u << 31, k = i; k; k >>= 1, v ^= v >> 1)
            if (k & 1u) second ^= v;
        a->points[i] = kit_reverse(second);
    }
    return 0;
}

void kit_ambient_point(const kit_ambient *a, uint32_t i, uint32_t seed, float at[2])     /* in [0,1)^2 */
{
    at[0] = (float)(kit_scramble(i, seed) >> 8) * (1.0f / 16777216.0f);
    at[1] = (float)(kit_scramble(a->points[i], kit_mix(seed ^ 0x9e3779b9u)) >> 8) * (1.0f / 16777216.0f);
}

/* Builds an orthonormal basis about n [Duff et al. 2017]. */
void kit_around(const float n[3], float x, float y, float z, float d[3])
{
    const float sign = n[2] < 0 ? -1.0f : 1.0f, k = -1.0f / (sign + n[2]), m = n[0] * n[1] * k;
    const float s[3] = { 1 + sign * n[0] * n[0] * k, sign * m, -sign * n[0] },
                t[3] = { m, sign + n[1] * n[1] * k, -n[1] };
    for (int i = 0; i < 3; ++i) d[i] = x * s[i] + y * t[i] + z * n[i];
}

void kit_cosine_direction(const float n[3], const float at[2], float d[3])
{
    /* maps the square to a disc by rings [Shirley and Chiu 1997], the disc to a cosine-weighted hemisphere [Malley] */
    const float u = 2 * at[0] - 1, v = 2 * at[1] - 1;
    const int   wide = fabsf(u) > fabsf(v);
    const float ring = wide ? u : v, turn = ring != 0 ? 0.785398163f * (wide ? v / u : u / v) : 0.0f;
    const float along = ring * cosf(turn), across = ring * sinf(turn);
    kit_around(n, wide ? along : across, wide ? across : along, sqrtf(fmaxf(0.0f, 1 - ring * ring)), d);
}

static uint32_t object_of(const kit_mesh *mesh, uint32_t triangle) { return mesh->object ? mesh->object[triangle] : 0; }

static int occluded_by_others(const kit_ambient *a, const float origin[3], const float d[3])
{
    ssgi_hit hit = { 0 };
    while (ssgi_trace_closest(&hit, &a->trace, origin, d, hit.t, a->radius)) {
        const uint32_t number = object_of(&a->others->mesh, hit.triangle);
        if (number && number != a->own && a->others->object[number - 1].casts) return 1;
    }
    return 0;
}

double kit_occluded(const kit_ambient *a, const float origin[3], const float d[3], ssgi_hit *hit)
{
    ssgi_hit nearest;
    if (a->others) return occluded_by_others(a, origin, d);
    if (a->attenuation == KIT_ATTENUATION_NONE && !hit) return ssgi_trace_any(&a->trace, origin, d, 0, a->radius);
    if (!hit) hit = &nearest;
    if (!ssgi_trace_closest(hit, &a->trace, origin, d, 0, a->radius)) return 0;
    const double t = (double)(hit->t / a->radius);
    switch (a->attenuation) {
    case KIT_ATTENUATION_NONE:   return 1;
    case KIT_ATTENUATION_SQUARE: return 1 - t * t;
    default:                     return 1 - t;
    }
}

void kit_lift_off(const float p[3], float magnitude, const float lift[3], float origin[3])
{
    for (int i = 0; i < 3; ++i) origin[i] = p[i] + lift[i] * 4e-6f * magnitude;
}

float kit_ambient_at(const kit_ambient *a, uint32_t pixel, const float origin[3], const float n[3])
{
    const uint32_t seed = kit_mix(pixel);
    double sum = 0;
    for (uint32_t r = 0; r < (uint32_t)a->rays; ++r) {
        float at[2], d[3];
        kit_ambient_point(a, r, seed, at);
        kit_cosine_direction(n, at, d);
        sum += kit_occluded(a, origin, d, NULL);
    }
    return (float)(1 - sum / a->rays);
}

int kit_trace_new(ssgi_trace *trace, void **memory, const float *position, const uint32_t *index, size_t triangles,
                     const char *what, kit_error *err)
{
    const char *why = "";
    const size_t size = ssgi_trace_size(triangles);
    *memory = size ? malloc(size) : NULL;
    if (!*memory) return kit_fail(err, "%s: no memory to trace %zu triangles", what, triangles);
    if (ssgi_trace_build(trace, *memory, size, position, 3 * sizeof(float), index, triangles, &why) == SSGI_OK)
        return 0;
    free(*memory);
    *memory = NULL;
    return kit_fail(err, "%s: %s", what, why);
}

/* ---- >>a picture of them ----------------------------------------------------------------------------------------- */

void kit_place_of(const kit_mesh *mesh, const ssgi_hit *hit, const float direction[3], kit_place *at)
{
    const float *c = mesh->position + 9 * (size_t)hit->triangle, *cn = mesh->normal + 9 * (size_t)hit->triangle;
    const float w[3] = { 1 - hit->u - hit->v, hit->u, hit->v };
    float p[3], face[3], magnitude = 0;
    double d[3], e[3], f[3], normal[3], shading[3];
    for (int i = 0; i < 3; ++i) {
        p[i] = w[0] * c[i] + w[1] * c[3 + i] + w[2] * c[6 + i];     /* more precise than origin + t direction */
        shading[i] = (double)(w[0] * cn[i] + w[1] * cn[3 + i] + w[2] * cn[6 + i]);
        d[i] = (double)direction[i];
        e[i] = (double)c[3 + i] - (double)c[i];
        f[i] = (double)c[6 + i] - (double)c[i];
        magnitude = fmaxf(magnitude, fmaxf(fabsf(c[i]), fmaxf(fabsf(c[3 + i]), fabsf(c[6 + i]))));
    }
    kit_cross(e, f, normal);
    kit_unit(normal);
    if (!kit_unit(shading)) memcpy(shading, normal, sizeof shading);
    const double side = kit_dot(normal, d) > 0 ? -1 : 1, turn = side * kit_dot(shading, normal) < 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i) {
        face[i] = (float)(side * normal[i]);
        at->n[i] = (float)(turn * shading[i]);
    }
    kit_lift_off(p, magnitude, face, at->origin);
    at->albedo = mesh->albedo + 3 * (size_t)hit->triangle;
    at->object = object_of(mesh, hit->triangle);
}

int kit_camera_hit(ssgi_hit *hit, float origin[3], float direction[3], const ssgi_trace *trace,
                   const kit_camera *camera, int x, int y)
{
    double axes[3][3], d[3];
    kit_camera_axes(camera, axes);
    kit_camera_ray(camera, x, y, origin, direction);
    for (int i = 0; i < 3; ++i) d[i] = (double)direction[i];
    const double slant = -kit_dot(d, axes[2]);
    if (!(camera->fovy > 0)) {                 /* from the near plane on: floats would round a distant eye */
        kit_camera_point(camera, x, y, (double)camera->znear, origin);
        return ssgi_trace_closest(hit, trace, origin, direction, 0, camera->zfar - camera->znear);
    }
    const float first = (float)((double)camera->znear / slant),
                last = camera->depth == KIT_DEPTH_INFINITE ? 1e30f : (float)((double)camera->zfar / slant);
    return ssgi_trace_closest(hit, trace, origin, direction, first, last);
}

static int truth_primary(const kit_truth *job, int x, int y, kit_place *at)
{
    float origin[3], direction[3];
    ssgi_hit hit;
    if (!kit_camera_hit(&hit, origin, direction, &job->ambient.trace, &job->camera, x, y)) return 0;
    kit_place_of(job->mesh, &hit, direction, at);
    return 1;
}

static void truth_row(void *context, int y)
{
    const kit_truth *job = context;
    const size_t pixels = (size_t)job->out.width * (size_t)job->out.height;
    for (int x = 0; x < job->out.width; ++x) {
        const uint32_t pixel = (uint32_t)y * (uint32_t)job->out.width + (uint32_t)x;
        const int skip = kit_skipped(x, y, job->stride);
        float value[KIT_MAX_CHANNELS];
        kit_place at;
        for (int c = 0; c < job->out.channels; ++c) value[c] = skip ? NAN : job->background;
        if (!skip && truth_primary(job, x, y, &at)) job->pixel(job, pixel, &at, value);
        for (int c = 0; c < job->out.channels; ++c) job->out.data[(size_t)c * pixels + pixel] = value[c];
    }
}

int kit_truth_run(kit_truth *job, kit_image *out, const char *channels, const kit_scene *scene,
                  const kit_camera *camera, float radius, int attenuation, int rays, int stride, kit_error *err)
{
    void *memory = NULL;
    if (kit_camera_check(camera, "truth", err)) return -1;
    if (stride < 1) return kit_fail(err, "truth: stride %d: must be 1 or more", stride);
    if (scene->mesh.triangles == 0) return kit_fail(err, "truth: the scene has no triangles");
    for (int i = 0; i < 3; ++i)
        if (!(fmaxf(fabsf(camera->eye[i]), fmaxf(fabsf(scene->mesh.lower[i]), fabsf(scene->mesh.upper[i]))) <= 1e12f))
            return kit_fail(err, "truth: the scene or its camera reaches beyond 1e12 units, where rays hit nothing");
    if (kit_ambient_begin(&job->ambient, radius, attenuation, rays, "truth", err)) return -1;
    job->scene = scene;
    job->mesh = &scene->mesh;
    job->camera = *camera;
    job->stride = stride;
    kit_camera_planes(&job->camera, job->mesh);
    const int failed =
        kit_trace_new(&job->ambient.trace, &memory, job->mesh->position, NULL, job->mesh->triangles, "truth", err)
        || kit_image_new(&job->out, camera->width, camera->height, channels, err);
    if (!failed) {
        kit_parallel("truth", camera->height, truth_row, job);
        *out = job->out;
    }
    free(job->ambient.points);
    free(memory);
    return failed ? -1 : 0;
}

/* ---- >>ambient visibility ---------------------------------------------------------------------------------------- */

static void ambient_pixel(const kit_truth *job, uint32_t pixel, const kit_place *at, float *value)
{
    *value = kit_ambient_at(&job->ambient, pixel, at->origin, at->n);
}

int kit_truth_ao(kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius, int attenuation,
                 int rays, int stride, kit_error *err)
{
    kit_truth job = { .pixel = ambient_pixel, .background = 1 };
    return kit_truth_run(&job, out, "Y", scene, camera, radius, attenuation, rays, stride, err);
}

static void pair_pixel(const kit_truth *job, uint32_t pixel, const kit_place *at, float *value)
{
    value[0] = kit_ambient_at(&job->ambient, pixel, at->origin, at->n);
    value[1] = kit_ambient_at(&job->ambient, ~pixel, at->origin, at->n);
}

int kit_truth_pair(kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius, int rays,
                   kit_error *err)
{
    kit_truth job = { .pixel = pair_pixel, .background = 1 };
    return kit_truth_run(&job, out, "Y,again", scene, camera, radius, KIT_ATTENUATION_LINEAR, rays, 1, err);
}

static void objects_pixel(const kit_truth *job, uint32_t pixel, const kit_place *at, float *value)
{
    kit_ambient a = job->ambient;
    a.others = job->scene;
    a.own = at->object;
    *value = kit_ambient_at(&a, pixel, at->origin, at->n);
}

int kit_truth_objects(kit_image *out, const kit_scene *scene, const kit_camera *camera, int rays, int stride,
                      kit_error *err)
{
    kit_truth job = { .pixel = objects_pixel, .background = 1 };
    return kit_truth_run(&job, out, "Y", scene, camera, INFINITY, KIT_ATTENUATION_NONE, rays, stride, err);
}
