/* truth.c - cameras, ray-traced ambient visibility and its floor (what one depth layer can know), ray-traced light. */
#include "kit/kit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void cross(const double a[3], const double b[3], double out[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

static int normalise(double v[3])                   /* 0 if v has no direction, then left as it is */
{
    const double length = sqrt(dot(v, v));
    if (!(length > 0) || !isfinite(length)) return 0;
    for (int i = 0; i < 3; ++i) v[i] /= length;
    return 1;
}

/* ---- cameras ------------------------------------------------------------------------------------------------ */

/* Rows of the rotation: right, up, backward. An up along the line of sight is replaced by the axis farthest from it, an
   eye on the target looks along -z. */
static void camera_axes(const kit_camera *camera, double axes[3][3])
{
    double *right = axes[0], *up = axes[1], *back = axes[2], wish[3];
    for (int i = 0; i < 3; ++i) {
        back[i] = (double)camera->eye[i] - (double)camera->target[i];
        wish[i] = (double)camera->up[i];
    }
    if (!normalise(back)) back[0] = back[1] = 0, back[2] = 1;
    cross(wish, back, right);
    if (dot(right, right) <= 1e-12 * dot(wish, wish) || !normalise(right)) {
        int least = 0;
        for (int i = 1; i < 3; ++i)
            if (fabs(back[i]) < fabs(back[least])) least = i;
        for (int i = 0; i < 3; ++i) wish[i] = i == least;
        cross(wish, back, right);
        normalise(right);
    }
    cross(back, right, up);
}

/* half the picture's extent: at view depth 1, or orthographic in world units */
static void camera_half(const kit_camera *camera, double half[2])
{
    half[1] = camera->fovy > 0 ? tan((double)camera->fovy * pi / 360) : 0.5 * (double)camera->ortho_height;
    half[0] = half[1] * camera->width / camera->height;
}

/* View-space ray through a pixel's centre: a point at view depth z is o + d z. shift counts in pixels, +x to the right,
   +y upward. */
static void camera_view_ray(const kit_camera *camera, int x, int y, double o[3], double d[3])
{
    double half[2];
    camera_half(camera, half);
    const double at[2] = { half[0] * (2 * (x + 0.5 - (double)camera->shift[0]) / camera->width - 1),
                           half[1] * (1 - 2 * (y + 0.5 + (double)camera->shift[1]) / camera->height) };
    const int flat = !(camera->fovy > 0);
    for (int i = 0; i < 2; ++i) {
        o[i] = flat ? at[i] : 0;
        d[i] = flat ? 0 : at[i];
    }
    o[2] = 0;
    d[2] = -1;
}

/* The near plane lies a little before the bounds, but at a thousandth of the far plane at least: window depth must stay
   usable. */
void kit_camera_planes(kit_camera *camera, const kit_mesh *mesh)
{
    double axes[3][3], nearest = 1e300, farthest = 0;
    camera_axes(camera, axes);
    for (int corner = 0; mesh->triangles && corner < 8; ++corner) {
        double depth = 0;
        for (int i = 0; i < 3; ++i)
            depth -=
                axes[2][i] * ((double)(corner >> i & 1 ? mesh->upper[i] : mesh->lower[i]) - (double)camera->eye[i]);
        nearest = fmin(nearest, depth);
        farthest = fmax(farthest, depth);
    }
    if (!(farthest > 0) || !isfinite(farthest)) farthest = 1;      /* nothing before the camera */
    if (!(camera->zfar > 0)) camera->zfar = (float)fmax(farthest * 1.01, (double)camera->znear * 2);
    if (!(camera->znear > 0))
        camera->znear = (float)fmin(fmax(nearest * 0.99, (double)camera->zfar * 1e-3), (double)camera->zfar * 0.9);
}

void kit_camera_orbit(kit_camera *camera, const kit_camera *from, double degrees)
{
    const double a = degrees * 0.017453292519943295, c = cos(a), s = sin(a);
    double up[3], away[3], length = 0, along = 0;
    for (int i = 0; i < 3; ++i) length += (double)from->up[i] * (double)from->up[i];
    for (int i = 0; i < 3; ++i) {
        up[i] = (double)from->up[i] / sqrt(length);
        away[i] = (double)from->eye[i] - (double)from->target[i];
        along += up[i] * away[i];
    }
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3, n = (i + 2) % 3;
        camera->eye[i] = from->target[i] + (float)(c * away[i] + s * (up[k] * away[n] - up[n] * away[k])
                                                   + (1 - c) * along * up[i]);
    }
}

/* An orthographic camera has no far plane at infinity: INFINITE is REVERSED for it. */
void kit_camera_matrices(const kit_camera *camera, float view[16], float projection[16])
{
    double axes[3][3], half[2], eye[3], p[16] = { 0 };
    const double n = (double)camera->znear, f = (double)camera->zfar;
    const double shift[2] = { 2 * (double)camera->shift[0] / camera->width,
                              2 * (double)camera->shift[1] / camera->height };
    camera_axes(camera, axes);
    camera_half(camera, half);
    for (int i = 0; i < 3; ++i) eye[i] = (double)camera->eye[i];
    memset(view, 0, 16 * sizeof *view);
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) view[4 * c + r] = (float)axes[r][c];
        view[12 + r] = (float)-dot(axes[r], eye);
    }
    view[15] = 1;
    p[0] = 1 / half[0];
    p[5] = 1 / half[1];
    if (camera->fovy > 0) {
        p[8] = -shift[0];
        p[9] = -shift[1];
        p[11] = -1;
        p[10] = camera->depth == KIT_DEPTH_NORMAL     ? -(f + n) / (f - n)
                : camera->depth == KIT_DEPTH_REVERSED ? n / (f - n)
                                                      : 0;
        p[14] = camera->depth == KIT_DEPTH_NORMAL     ? -2 * f * n / (f - n)
                : camera->depth == KIT_DEPTH_REVERSED ? f * n / (f - n)
                                                      : n;
    } else {
        p[12] = shift[0];
        p[13] = shift[1];
        p[15] = 1;
        p[10] = camera->depth == KIT_DEPTH_NORMAL ? -2 / (f - n) : 1 / (f - n);
        p[14] = camera->depth == KIT_DEPTH_NORMAL ? -(f + n) / (f - n) : f / (f - n);
    }
    for (int i = 0; i < 16; ++i) projection[i] = (float)p[i];
}

void kit_camera_ray(const kit_camera *camera, int x, int y, float origin[3], float direction[3])
{
    double axes[3][3], o[3], d[3];
    camera_axes(camera, axes);
    camera_view_ray(camera, x, y, o, d);
    normalise(d);
    for (int i = 0; i < 3; ++i) {
        origin[i] = (float)((double)camera->eye[i] + axes[0][i] * o[0] + axes[1][i] * o[1]);
        direction[i] = (float)(axes[0][i] * d[0] + axes[1][i] * d[1] + axes[2][i] * d[2]);
    }
}

void kit_camera_point(const kit_camera *camera, int x, int y, double view_depth, float point[3])
{
    double axes[3][3], o[3], d[3];
    camera_axes(camera, axes);
    camera_view_ray(camera, x, y, o, d);
    for (int i = 0; i < 3; ++i) {
        double at = (double)camera->eye[i];
        for (int k = 0; k < 3; ++k) at += axes[k][i] * (o[k] + d[k] * view_depth);
        point[i] = (float)at;
    }
}

/* ---- rays from a point ----------------------------------------------------------------------------------------- */

typedef struct ambient {
    ssgi_trace trace;
    float      radius;
    int        attenuation, rays;
    const kit_scene *others;        /* NULL, or only objects of this scene that cast count, except number own */
    uint32_t   own;
    /* Sobol's second dimension, bits reversed (the first dimension's are the index); a power of two of them, rays at
       least */
    uint32_t  *points;
    uint32_t   mask;                /* that power less one */
} ambient;

static uint32_t reverse(uint32_t x)
{
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    x = (x >> 8 & 0x00ff00ffu) | (x & 0x00ff00ffu) << 8;
    return x >> 16 | x << 16;
}

static uint32_t hash(uint32_t x)    /* PCG's [O'Neill 2014] */
{
    x = x * 747796405u + 2891336453u;
    x = (x >> ((x >> 28) + 4) ^ x) * 277803737u;
    return x >> 22 ^ x;
}

/* nested uniform scrambling by a hash [Laine and Karras 2011; Burley 2020] */
static uint32_t scramble(uint32_t reversed, uint32_t seed)
{
    uint32_t x = reversed ^ reversed * 0x3d20adeau;
    x += seed;
    x *= seed >> 16 | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return reverse(x);
}

static int ambient_begin(ambient *a, float radius, int attenuation, int rays, const char *what, kit_error *err)
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
        a->points[i] = reverse(second);
    }
    return 0;
}

static void ambient_point(const ambient *a, uint32_t i, uint32_t seed, float at[2])     /* in [0,1)^2 */
{
    at[0] = (float)(scramble(i, seed) >> 8) * (1.0f / 16777216.0f);
    at[1] = (float)(scramble(a->points[i], hash(seed ^ 0x9e3779b9u)) >> 8) * (1.0f / 16777216.0f);
}

/* from a frame about n [Duff et al. 2017] */
static void turned(const float n[3], float x, float y, float z, float d[3])
{
    const float sign = n[2] < 0 ? -1.0f : 1.0f, k = -1.0f / (sign + n[2]), m = n[0] * n[1] * k;
    const float s[3] = { 1 + sign * n[0] * n[0] * k, sign * m, -sign * n[0] },
                t[3] = { m, sign + n[1] * n[1] * k, -n[1] };
    for (int i = 0; i < 3; ++i) d[i] = x * s[i] + y * t[i] + z * n[i];
}

static void cosine_direction(const float n[3], const float at[2], float d[3])
{
    /* square to disc by rings [Shirley and Chiu 1997], disc to cosine-weighted hemisphere [Malley] */
    const float u = 2 * at[0] - 1, v = 2 * at[1] - 1;
    const int   wide = fabsf(u) > fabsf(v);
    const float ring = wide ? u : v, turn = ring != 0 ? 0.785398163f * (wide ? v / u : u / v) : 0.0f;
    const float along = ring * cosf(turn), across = ring * sinf(turn);
    turned(n, wide ? along : across, wide ? across : along, sqrtf(fmaxf(0.0f, 1 - ring * ring)), d);
}

static uint32_t object_of(const kit_mesh *mesh, uint32_t triangle) { return mesh->object ? mesh->object[triangle] : 0; }

static int blocked_by_others(const ambient *a, const float origin[3], const float d[3])
{
    ssgi_hit hit = { 0 };
    while (ssgi_trace_closest(&a->trace, origin, d, hit.t, a->radius, &hit)) {
        const uint32_t number = object_of(&a->others->mesh, hit.triangle);
        if (number && number != a->own && a->others->object[number - 1].casts) return 1;
    }
    return 0;
}

/* How much the nearest hit within radius takes from a direction, [0,1]; hit: where it is, NULL if that does not
   matter */
static double blocked(const ambient *a, const float origin[3], const float d[3], ssgi_hit *hit)
{
    ssgi_hit nearest;
    if (a->others) return blocked_by_others(a, origin, d);
    if (a->attenuation == KIT_ATTENUATION_NONE && !hit) return ssgi_trace_any(&a->trace, origin, d, 0, a->radius);
    if (!hit) hit = &nearest;
    if (!ssgi_trace_closest(&a->trace, origin, d, 0, a->radius, hit)) return 0;
    const double t = (double)(hit->t / a->radius);
    switch (a->attenuation) {
    case KIT_ATTENUATION_NONE:   return 1;
    case KIT_ATTENUATION_SQUARE: return 1 - t * t;
    default:                     return 1 - t;
    }
}

/* Off the surface at p along the unit vector lift, by some ten times the rounding of points as far from the origin of
   coordinates as magnitude. */
static void lift_off(const float p[3], float magnitude, const float lift[3], float origin[3])
{
    for (int i = 0; i < 3; ++i) origin[i] = p[i] + lift[i] * 4e-6f * magnitude;
}

/* visibility; n unit */
static float ambient_at(const ambient *a, uint32_t pixel, const float origin[3], const float n[3])
{
    const uint32_t seed = hash(pixel);
    double sum = 0;
    for (uint32_t r = 0; r < (uint32_t)a->rays; ++r) {
        float at[2], d[3];
        ambient_point(a, r, seed, at);
        cosine_direction(n, at, d);
        sum += blocked(a, origin, d, NULL);
    }
    return (float)(1 - sum / a->rays);
}

static int skipped(int x, int y, int stride) { return x % stride != stride / 2 || y % stride != stride / 2; }

static int trace_new(ssgi_trace *trace, void **memory, const float *position, const uint32_t *index, size_t triangles,
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

static int camera_check(const kit_camera *camera, const char *what, kit_error *err)
{
    if (camera->width < 1 || camera->height < 1)
        return kit_fail(err, "%s: camera of %d x %d pixels", what, camera->width, camera->height);
    if (!(camera->fovy > 0 ? camera->fovy < 180 : camera->ortho_height > 0))
        return kit_fail(err, "%s: camera: fovy %g must be below 180, or 0 with an ortho_height above 0 (%g)", what,
                        (double)camera->fovy, (double)camera->ortho_height);
    return 0;
}

/* ---- truth ---------------------------------------------------------------------------------------------------- */

typedef struct place {              /* on the surface, as seen along a ray */
    float origin[3];                /* lifted off the face, toward the ray */
    float n[3];                     /* shading normal, turned to that side */
    const float *albedo;
    uint32_t object;
} place;

static void place_at(const kit_mesh *mesh, const ssgi_hit *hit, const float direction[3], place *at)
{
    const float *c = mesh->position + 9 * (size_t)hit->triangle, *cn = mesh->normal + 9 * (size_t)hit->triangle;
    const float w[3] = { 1 - hit->u - hit->v, hit->u, hit->v };
    float p[3], face[3], magnitude = 0;
    double d[3], e[3], f[3], normal[3], shading[3];
    for (int i = 0; i < 3; ++i) {
        p[i] = w[0] * c[i] + w[1] * c[3 + i] + w[2] * c[6 + i];     /* more exact than origin + t direction */
        shading[i] = (double)(w[0] * cn[i] + w[1] * cn[3 + i] + w[2] * cn[6 + i]);
        d[i] = (double)direction[i];
        e[i] = (double)c[3 + i] - (double)c[i];
        f[i] = (double)c[6 + i] - (double)c[i];
        magnitude = fmaxf(magnitude, fmaxf(fabsf(c[i]), fmaxf(fabsf(c[3 + i]), fabsf(c[6 + i]))));
    }
    cross(e, f, normal);
    normalise(normal);
    if (!normalise(shading)) memcpy(shading, normal, sizeof shading);
    const double side = dot(normal, d) > 0 ? -1 : 1, turn = side * dot(shading, normal) < 0 ? -1 : 1;
    for (int i = 0; i < 3; ++i) {
        face[i] = (float)(side * normal[i]);
        at->n[i] = (float)(turn * shading[i]);
    }
    lift_off(p, magnitude, face, at->origin);
    at->albedo = mesh->albedo + 3 * (size_t)hit->triangle;
    at->object = object_of(mesh, hit->triangle);
}

typedef struct truth truth;
struct truth {
    ambient             ambient;
    const kit_scene    *scene;
    const kit_mesh     *mesh;       /* its */
    kit_camera          camera;
    kit_image           out;
    int                 stride;
    /* one value a channel */
    void              (*pixel)(const truth *job, uint32_t pixel, const place *at, float *value);
    float               background;
    const kit_lighting *lighting;
    int                 bounce;
    const kit_image    *env;                    /* the lighting's, or what its lamps leave of it */
    float              *env_row, *env_column;   /* see env_begin; NULL = no environment */
    int                 env_cells[2];           /* columns, rows */
    struct lamp        *lamp;                   /* see lamps_begin */
    int                 lamps;
    double              exponent;   /* of the lobe */
    const struct scattering *within;
};

static int truth_primary(const truth *job, int x, int y, place *at)
{
    float origin[3], direction[3];
    double axes[3][3], d[3];
    ssgi_hit hit;
    camera_axes(&job->camera, axes);
    kit_camera_ray(&job->camera, x, y, origin, direction);
    for (int i = 0; i < 3; ++i) d[i] = (double)direction[i];
    /* the planes cut as they do in the G-buffer */
    const double slant = -dot(d, axes[2]);
    const float  first = (float)((double)job->camera.znear / slant);
    const float last = job->camera.depth == KIT_DEPTH_INFINITE && job->camera.fovy > 0
                           ? 1e30f
                           : (float)((double)job->camera.zfar / slant);
    if (!ssgi_trace_closest(&job->ambient.trace, origin, direction, first, last, &hit)) return 0;
    place_at(job->mesh, &hit, direction, at);
    return 1;
}

static void truth_row(void *context, int y)
{
    const truth *job = context;
    const size_t pixels = (size_t)job->out.width * (size_t)job->out.height;
    for (int x = 0; x < job->out.width; ++x) {
        const uint32_t pixel = (uint32_t)y * (uint32_t)job->out.width + (uint32_t)x;
        const int skip = skipped(x, y, job->stride);
        float value[KIT_MAX_CHANNELS];
        place at;
        for (int c = 0; c < job->out.channels; ++c) value[c] = skip ? NAN : job->background;
        if (!skip && truth_primary(job, x, y, &at)) job->pixel(job, pixel, &at, value);
        for (int c = 0; c < job->out.channels; ++c) job->out.data[(size_t)c * pixels + pixel] = value[c];
    }
}

/* job: pixel, background and what that needs; channels: of the picture */
static int truth_run(truth *job, kit_image *out, const char *channels, const kit_scene *scene, const kit_camera *camera,
                     float radius, int attenuation, int rays, int stride, kit_error *err)
{
    void *memory = NULL;
    if (camera_check(camera, "truth", err)) return -1;
    if (stride < 1) return kit_fail(err, "truth: stride %d: must be 1 or more", stride);
    if (scene->mesh.triangles == 0) return kit_fail(err, "truth: the scene has no triangles");
    if (ambient_begin(&job->ambient, radius, attenuation, rays, "truth", err)) return -1;
    job->scene = scene;
    job->mesh = &scene->mesh;
    job->camera = *camera;
    job->stride = stride;
    kit_camera_planes(&job->camera, job->mesh);
    const int failed =
        trace_new(&job->ambient.trace, &memory, job->mesh->position, NULL, job->mesh->triangles, "truth", err)
        || kit_image_new(&job->out, camera->width, camera->height, channels, err);
    if (!failed) {
        kit_parallel("truth", camera->height, truth_row, job);
        *out = job->out;
    }
    free(job->ambient.points);
    free(memory);
    return failed ? -1 : 0;
}

static void ambient_pixel(const truth *job, uint32_t pixel, const place *at, float *value)
{
    *value = ambient_at(&job->ambient, pixel, at->origin, at->n);
}

int kit_truth_ao(kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius, int attenuation,
                 int rays, int stride, kit_error *err)
{
    truth job = { .pixel = ambient_pixel, .background = 1 };
    return truth_run(&job, out, "Y", scene, camera, radius, attenuation, rays, stride, err);
}

static void objects_pixel(const truth *job, uint32_t pixel, const place *at, float *value)
{
    ambient a = job->ambient;
    a.others = job->scene;
    a.own = at->object;
    *value = ambient_at(&a, pixel, at->origin, at->n);
}

int kit_truth_objects(kit_image *out, const kit_scene *scene, const kit_camera *camera, int rays, int stride,
                      kit_error *err)
{
    truth job = { .pixel = objects_pixel, .background = 1 };
    return truth_run(&job, out, "Y", scene, camera, INFINITY, KIT_ATTENUATION_NONE, rays, stride, err);
}

/* ---- light ------------------------------------------------------------------------------------------------------ */

/* Turns the weights at cdf[1..n] into their running sum, from cdf[0] = 0 to cdf[n] = 1 (all 0 if there is none), and
   returns their mean. */
static double accumulate(float *cdf, int n)
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

static double pick(const float *cdf, int n, float u)        /* where the running sum is u, in [0, n) */
{
    int low = 0, high = n;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        if (cdf[middle] <= u) low = middle;
        else high = middle;
    }
    return low + fmin((double)(u - cdf[low]) / (double)(cdf[high] - cdf[low]), 0.999999);
}

/* A texel that outshines the rest: bilinear look-ups make it a hat over the texels around, and the rest of the map is
   what it would be with this texel black. */
typedef struct lamp { int x, y; float rgb[3]; } lamp;
enum { MOST_LAMPS = 512 };
static const double LAMP = 50;                  /* times the mean luminance */

static double luminance_of(const kit_image *env, size_t i)
{
    const size_t texels = (size_t)env->width * (size_t)env->height;
    return 0.2126 * (double)env->data[i] + 0.7152 * (double)env->data[texels + i]
           + 0.0722 * (double)env->data[2 * texels + i];
}

/* Takes the lamps, MOST_LAMPS of the brightest, out of the environment: each gets a ray from every place, so that what
   they bring is noisy only where they are half hidden. The rows at the poles have none: there hats are wider. */
static int lamps_begin(truth *job, kit_image *rest, kit_error *err)
{
    const kit_image *env = &job->lighting->env;
    const size_t texels = (size_t)env->width * (size_t)env->height;
    double mean = 0, least = 0, weight = 0;
    for (int y = 0; y < env->height; ++y) {
        const double area = sin(pi * (y + 0.5) / env->height);
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

/* Directions are picked by cells of a texel or of a part of one: by the mean luminance that bilinear look-ups find in
   it (the midpoint of a part tells exactly, those of a texel's quarters as well), times its solid angle. Small cells
   follow a light of a few texels, within which radiance varies as much as over the sphere. */
enum { ENV_CELLS = 1 << 21, ENV_PARTS = 4 };

static void env_build_row(void *context, int y)
{
    const truth *job = context;
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
    job->env_row[y + 1] = (float)(accumulate(column, cells[0]) * sin(pi * (y + 0.5) / cells[1]));
}

/* Running sums: over the rows of cells of the environment, and along each of them. A black one is none. */
static int env_begin(truth *job, kit_error *err)
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
    if (!(accumulate(job->env_row, job->env_cells[1]) > 0)) {
        free(job->env_row);
        job->env_row = NULL;
    }
    return 0;
}

static void env_direction(const truth *job, const float at[2], float d[3])
{
    const kit_image *env = job->env;
    const int *cells = job->env_cells, parts = cells[0] / env->width;
    const double y = pick(job->env_row, cells[1], at[1]);
    const float *column = job->env_column + (size_t)y * ((size_t)cells[0] + 1);
    kit_env_direction(env, pick(column, cells[0], at[0]) / parts, y / parts, d);
}

static double env_density(const truth *job, const float d[3])       /* of env_direction, per unit of solid angle */
{
    const kit_image *env = job->env;
    const int *cells = job->env_cells, parts = cells[0] / env->width;
    double at[2];
    kit_env_place(env, d, at);
    const size_t x = (size_t)fmin(at[0] * parts, cells[0] - 1), y = (size_t)fmin(at[1] * parts, cells[1] - 1);
    const float *row = job->env_row + y, *column = job->env_column + y * ((size_t)cells[0] + 1) + x;
    const double share = (double)(row[1] - row[0]) * (double)(column[1] - column[0]),
                 flat = sqrt((double)d[0] * (double)d[0] + (double)d[2] * (double)d[2]);
    return share * cells[0] * cells[1] / (2 * pi * pi * fmax(flat, 1e-9));
}

static double facing(const float n[3], const float d[3])
{
    return (double)n[0] * (double)d[0] + (double)n[1] * (double)d[1] + (double)n[2] * (double)d[2];
}

static double hat(float u) { return u < 0.5f ? sqrt(2 * (double)u) - 1 : 1 - sqrt(2 - 2 * (double)u); }

/* What the lamps bring, a ray to each, by chance within its hat. */
static void add_lamps(const truth *job, const place *at, uint32_t seed, double sum[3])
{
    const double texel = 2 * pi / job->env->width * pi / job->env->height;
    for (uint32_t i = 0; i < (uint32_t)job->lamps; ++i) {
        const lamp *l = &job->lamp[i];
        float u[2], d[3];
        ambient_point(&job->ambient, i & job->ambient.mask, seed, u);
        kit_env_direction(job->env, l->x + 0.5 + hat(u[0]), l->y + 0.5 + hat(u[1]), d);
        const double cosine = facing(at->n, d) / pi,
                     flat = sqrt((double)d[0] * (double)d[0] + (double)d[2] * (double)d[2]);
        if (!(cosine > 0)) continue;
        const double weight = (1 - blocked(&job->ambient, at->origin, d, NULL)) * cosine * texel * flat;
        for (int c = 0; c < 3; ++c) sum[c] += weight * (double)l->rgb[c];
    }
}

/* One direction's share of the environment's irradiance over pi, where strategies cosine and env take rays[0] and
   rays[1] of them: multiple importance sampling with the balance heuristic [Veach and Guibas 1995], so that it does not
   matter whose direction it is. */
static void add_env(const truth *job, const float n[3], const float d[3], double visible, const int rays[2],
                    double sum[3])
{
    const double cosine = facing(n, d) / pi;
    float rgb[3];
    if (!job->env_row || !(cosine > 0)) return;
    kit_env_radiance(job->env, d, rgb);
    const double weight = visible * cosine / (rays[0] * cosine + rays[1] * env_density(job, d));
    for (int c = 0; c < 3; ++c) sum[c] += weight * (double)rgb[c];
}

static void add_light(const truth *job, const place *at, const kit_light *light, double sum[3])
{
    const int sun = light->kind == KIT_SUN;
    float to[3];
    for (int i = 0; i < 3; ++i) to[i] = light->at[i] - (sun ? 0 : at->origin[i]);
    const double length = sqrt(facing(to, to)), weight = facing(at->n, to) / length / pi / (sun ? 1 : length * length);
    if (!(weight > 0) || !isfinite(weight)) return;
    /* what holds the light does not shadow it */
    if (ssgi_trace_any(&job->ambient.trace, at->origin, to, 0, sun ? INFINITY : 0.99999f)) return;
    for (int c = 0; c < 3; ++c) sum[c] += weight * (double)light->colour[c];
}

static void gather(const truth *job, const place *at, uint32_t seed, uint32_t first, const int rays[2],
                   double irradiance[3], double *bounce);

/* What the hit of ray number r sends back, weighted */
static void add_sent(const truth *job, const ssgi_hit *hit, const float d[3], uint32_t r, uint32_t seed, double weight,
                     int rays, double sum[3])
{
    const uint32_t hit_seed = hash(seed ^ 0xc2b2ae35u), shuffle = hash(seed ^ 0x27d4eb2fu);
    const int one[2] = { job->env_row != NULL, job->env_row != NULL };
    double light[3] = { 0 };
    place next;
    place_at(job->mesh, hit, d, &next);
    /* shuffled: hits and directions from there stay independent */
    gather(job, &next, hit_seed, scramble(reverse(r), shuffle) & job->ambient.mask, one, light, NULL);
    for (int c = 0; c < 3; ++c) sum[c] += weight * (double)next.albedo[c] * light[c] / rays;
}

/* Adds up the irradiance over pi at a place; and, unless bounce is NULL, that of light which the hits around reflect.
   rays: by cosine, by environment, both from point first on. */
static void gather(const truth *job, const place *at, uint32_t seed, uint32_t first, const int rays[2],
                   double irradiance[3], double *bounce)
{
    const ambient *a = &job->ambient;
    const uint32_t env_seed = hash(seed ^ 0x85ebca6bu);
    float u[2], d[3];
    for (uint32_t r = 0; r < (uint32_t)rays[0]; ++r) {
        ssgi_hit hit;
        ambient_point(a, first + r, seed, u);
        cosine_direction(at->n, u, d);
        const double weight = blocked(a, at->origin, d, bounce ? &hit : NULL);
        add_env(job, at->n, d, 1 - weight, rays, irradiance);
        if (bounce && weight > 0) add_sent(job, &hit, d, r, seed, weight, rays[0], bounce);
    }
    for (uint32_t r = 0; r < (uint32_t)rays[1]; ++r) {
        ambient_point(a, first + r, env_seed, u);
        env_direction(job, u, d);
        if (facing(at->n, d) > 0) add_env(job, at->n, d, 1 - blocked(a, at->origin, d, NULL), rays, irradiance);
    }
    for (int i = 0; i < job->lighting->lights; ++i) add_light(job, at, &job->lighting->light[i], irradiance);
}

static void lit_pixel(const truth *job, uint32_t pixel, const place *at, float *value)
{
    const int by_env = job->env_row ? job->ambient.rays / 2 : 0,
              rays[2] = { job->env_row || job->bounce ? job->ambient.rays - by_env : 0, by_env };
    double irradiance[3] = { 0 }, bounce[3] = { 0 };
    gather(job, at, hash(pixel), 0, rays, irradiance, job->bounce ? bounce : NULL);
    add_lamps(job, at, hash(pixel ^ 0x165667b1u), irradiance);
    for (int c = 0; c < 3; ++c) {
        value[c] = (float)((double)at->albedo[c] * (irradiance[c] + bounce[c]));
        value[3 + c] = (float)irradiance[c];
        value[6 + c] = (float)bounce[c];
    }
}

/* job: pixel and what that needs */
static int lit_run(truth *job, kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius,
                   int attenuation, int rays, int stride, kit_error *err)
{
    const kit_lighting *lighting = job->lighting;
    if (lighting->lights < 0 || lighting->lights > KIT_MAX_LIGHTS)
        return kit_fail(err, "truth: %d lights: must be 0..%d", lighting->lights, KIT_MAX_LIGHTS);
    if (lighting->env.data && lighting->env.channels < 3)
        return kit_fail(err, "truth: the environment has %d channels: must have 3", lighting->env.channels);
    kit_image rest = { 0 };
    job->env = &lighting->env;
    const int failed = (job->pixel == lit_pixel && !job->bounce && lighting->env.data && lamps_begin(job, &rest, err))
                       || env_begin(job, err)
                       || truth_run(job, out, KIT_LIT_CHANNELS, scene, camera, radius, attenuation, rays, stride, err);
    free(job->env_row);
    free(job->env_column);
    free(job->lamp);
    kit_image_free(&rest);
    return failed ? -1 : 0;
}

int kit_truth_lit(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                  float radius, int attenuation, int bounce, int rays, int stride, kit_error *err)
{
    truth job = { .pixel = lit_pixel, .lighting = lighting, .bounce = bounce };
    if (bounce != 0 && bounce != 1) return kit_fail(err, "truth: bounce %d: must be 0 or 1", bounce);
    return lit_run(&job, out, scene, camera, radius, attenuation, rays, stride, err);
}

static void gloss_pixel(const truth *job, uint32_t pixel, const place *at, float *value)
{
    const ambient *a = &job->ambient;
    const uint32_t seed = hash(pixel);
    float origin[3], toward[3], mirrored[3];
    double sum[3] = { 0 };
    kit_camera_ray(&job->camera, (int)(pixel % (uint32_t)job->camera.width), (int)(pixel / (uint32_t)job->camera.width),
                   origin, toward);
    const float along = 2 * (float)facing(at->n, toward);
    for (int i = 0; i < 3; ++i) mirrored[i] = toward[i] - along * at->n[i];
    for (uint32_t r = 0; r < (uint32_t)a->rays; ++r) {
        ssgi_hit hit;
        float u[2], d[3];
        ambient_point(a, r, seed, u);
        const double z = pow((double)u[0], 1 / (job->exponent + 1)), flat = sqrt(fmax(0, 1 - z * z)),
                     turn = 2 * pi * (double)u[1];
        turned(mirrored, (float)(flat * cos(turn)), (float)(flat * sin(turn)), (float)z, d);
        const double weight = facing(at->n, d) > 0 ? blocked(a, at->origin, d, &hit) : 0;
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
    truth job = { .pixel = gloss_pixel, .lighting = lighting, .exponent = exponent };
    if (!(exponent >= 0 && exponent <= 1e5)) return kit_fail(err, "truth: exponent %g: must be 0..1e5", exponent);
    return lit_run(&job, out, scene, camera, radius, attenuation, rays, stride, err);
}

/* ---- under surfaces ------------------------------------------------------------------------------------------- */

enum { REFLECTANCES = 16384 };                  /* the dipole's, by distance, a table of them */
typedef struct scattering {
    truth  job;
    float *area;                                /* running sum over the triangles */
    /* position, irradiance over pi: 4 each; of the lit ones alone when all are made */
    float *sample;
    size_t samples;
    float  per_unit, table[REFLECTANCES][4];    /* table entries a world unit; times a sample's area; the fourth is 0 */
} scattering;

static void scatter_place(void *context, int block)
{
    scattering *s = context;
    const kit_mesh *mesh = s->job.mesh;
    const size_t first = (size_t)block << 10, end = first + 1024 < s->samples ? first + 1024 : s->samples;
    for (size_t i = first; i < end; ++i) {
        static const int none[2] = { 0, 0 };
        float u[2];
        ssgi_r2((uint32_t)i, u);
        const float root = sqrtf(u[0]);
        const ssgi_hit hit = { .triangle = (uint32_t)pick(s->area, (int)mesh->triangles,
                                                          (float)(((double)i + 0.5) / (double)s->samples)),
                               .u = root * (1 - u[1]),
                               .v = root * u[1] };
        const float *n = mesh->normal + 9 * (size_t)hit.triangle;
        float *sample = s->sample + 8 * i, inward[3];
        double light[3] = { 0 };
        place p;
        for (int k = 0; k < 3; ++k) inward[k] = -n[k] - n[3 + k] - n[6 + k];
        place_at(mesh, &hit, inward, &p);
        gather(&s->job, &p, 0, 0, none, light, NULL);
        memcpy(sample, p.origin, sizeof p.origin);
        for (int c = 0; c < 3; ++c) sample[4 + c] = (float)light[c];
    }
}

static void scatter_pixel(const truth *job, uint32_t pixel, const place *at, float *value)
{
    const scattering *s = job->within;
    double all[3] = { 0 };
    (void)pixel;
    for (size_t i = 0; i < s->samples;) {
        float sum[4] = { 0, 0, 0, 0 };
        /* few at a time: sums of floats */
        for (const size_t end = i + 256 < s->samples ? i + 256 : s->samples; i < end; ++i) {
            const float *p = s->sample + 8 * i, x = p[0] - at->origin[0], y = p[1] - at->origin[1],
                        z = p[2] - at->origin[2];
            /* none is farther than the bounds' diagonal */
            const float d = s->per_unit * sqrtf(x * x + y * y + z * z), t = d - (float)(int)d, *a = s->table[(int)d];
            for (int c = 0; c < 4; ++c) sum[c] += p[4 + c] * (a[c] + t * (a[4 + c] - a[c]));
        }
        for (int c = 0; c < 3; ++c) all[c] += (double)sum[c];
    }
    for (int c = 0; c < 3; ++c) {
        value[c] = (float)((double)at->albedo[c] * all[c]);
        value[3 + c] = (float)all[c];
        value[6 + c] = 0;
    }
}

static int scatter_begin(scattering *s, size_t samples, const kit_scene *scene, const kit_lighting *lighting,
                         const ssgi_dipole *dipole, float unit, kit_error *err)
{
    const kit_mesh *mesh = &scene->mesh;
    double area = 0, diagonal = 0;
    void *memory = NULL;
    s->samples = samples;
    s->area = calloc(mesh->triangles + 1, sizeof *s->area);
    s->sample = calloc(8 * samples, sizeof *s->sample);
    if (!s->area || !s->sample) return kit_fail(err, "truth: no memory for %zu samples", samples);
    for (size_t t = 0; t < mesh->triangles; ++t) {
        const float *p = mesh->position + 9 * t;
        double e[3], f[3], n[3];
        for (int k = 0; k < 3; ++k) {
            e[k] = (double)p[3 + k] - (double)p[k];
            f[k] = (double)p[6 + k] - (double)p[k];
        }
        cross(e, f, n);
        s->area[t + 1] = (float)(0.5 * sqrt(dot(n, n)));
    }
    area = accumulate(s->area, (int)mesh->triangles) * (double)mesh->triangles;
    for (int k = 0; k < 3; ++k)
        diagonal +=
            ((double)mesh->upper[k] - (double)mesh->lower[k]) * ((double)mesh->upper[k] - (double)mesh->lower[k]);
    diagonal = sqrt(diagonal);
    s->per_unit = (float)((REFLECTANCES - 2) / diagonal);
    for (int k = 0; k < REFLECTANCES; ++k)
        for (int c = 0; c < 3; ++c)
            s->table[k][c] = (float)(ssgi_dipole_reflectance(dipole, c, k / (double)s->per_unit / (double)unit)
                                     / ((double)unit * (double)unit) * area / (double)samples);
    s->job.scene = scene;
    s->job.mesh = mesh;
    s->job.lighting = lighting;
    if (trace_new(&s->job.ambient.trace, &memory, mesh->position, NULL, mesh->triangles, "truth", err)) return -1;
    kit_parallel("irradiance", (int)((samples + 1023) >> 10), scatter_place, s);
    free(memory);
    s->samples = 0;
    for (size_t i = 0; i < samples; ++i) {                     /* dark ones send nothing */
        const float *from = s->sample + 8 * i;
        if (from[4] + from[5] + from[6] > 0) memmove(s->sample + 8 * s->samples++, from, 8 * sizeof *from);
    }
    return 0;
}

int kit_truth_scatter(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                      const ssgi_dipole *dipole, float unit, size_t samples, int stride, kit_error *err)
{
    truth job = { .pixel = scatter_pixel, .lighting = lighting };
    scattering *s = calloc(1, sizeof *s);
    int failed = 0;
    if (samples < 1 || samples > 1u << 26 || !(unit > 0))
        failed = kit_fail(err, "truth: %zu samples, unit %g: must be 1..2^26, above 0", samples, (double)unit);
    else if (lighting->lights < 0 || lighting->lights > KIT_MAX_LIGHTS)
        failed = kit_fail(err, "truth: %d lights: must be 0..%d", lighting->lights, KIT_MAX_LIGHTS);
    else if (!s) failed = kit_fail(err, "truth: out of memory");
    else failed = scatter_begin(s, samples, scene, lighting, dipole, unit, err);
    job.within = s;
    failed =
        failed || truth_run(&job, out, KIT_LIT_CHANNELS, scene, camera, INFINITY, KIT_ATTENUATION_NONE, 1, stride, err);
    if (s) { free(s->area); free(s->sample); }
    free(s);
    return failed ? -1 : 0;
}

/* ---- floor ---------------------------------------------------------------------------------------------------- */

typedef struct floor_job {
    ambient      ambient;
    kit_camera   camera;
    int          width, height, stride;
    const float *z, *n[3];
    float       *position;          /* 3 a pixel, view space */
    uint32_t    *index;             /* a row of 2x2 blocks has room for 2 (width - 1) triangles */
    uint32_t    *count;             /* triangles of each row of blocks */
    float       *out;
} floor_job;

static int surface(const floor_job *job, size_t pixel) { return job->z[pixel] > 0 && job->z[pixel] < SSGI_FAR; }

/* unit, as the frame gives it; toward the viewer where it gives none */
static void floor_normal(const floor_job *job, size_t pixel, const double ray[3], double n[3])
{
    for (int i = 0; i < 3; ++i) n[i] = (double)job->n[i][pixel];
    if (normalise(n)) return;
    for (int i = 0; i < 3; ++i) n[i] = -ray[i];
    normalise(n);
}

/* How much the view depth grows from pixel a to pixel b on the tangent plane of a. Beyond 89 degrees (n within 1/64 of
   edge-on) the plane is turned back. */
static double plane_step(const double a[3], double depth, const double n[3], const double o[3], const double d[3])
{
    double facing = dot(n, d), height = 0;
    facing = fmin(facing, -sqrt(dot(d, d)) / 64);
    for (int i = 0; i < 3; ++i) height += n[i] * (a[i] - o[i] - d[i] * depth);
    return height / facing;
}

/* Whether two neighbouring pixels lie on one surface: the tangent planes must meet between them. So the step in depth
   from one to the other must lie between the steps that either plane predicts, give or take half a pixel's footprint
   and half of the smaller step (normals are interpolated, surfaces bend). Planes stay joined at any slant, creases too;
   silhouettes are cut, as what lies behind does not lead up to them. Where only one of the planes is steep, it predicts
   16 footprints at most: the rim of a ball in front of a wall looks like a crease to two pixels. */
static int joined(const floor_job *job, int xa, int ya, int xb, int yb)
{
    const size_t a = (size_t)ya * (size_t)job->width + (size_t)xa, b = (size_t)yb * (size_t)job->width + (size_t)xb;
    double oa[3], da[3], ob[3], db[3], na[3], nb[3], pa[3], pb[3], half[2];
    if (!surface(job, a) || !surface(job, b)) return 0;
    const double za = (double)job->z[a], zb = (double)job->z[b];
    camera_half(&job->camera, half);
    camera_view_ray(&job->camera, xa, ya, oa, da);
    camera_view_ray(&job->camera, xb, yb, ob, db);
    floor_normal(job, a, da, na);
    floor_normal(job, b, db, nb);
    for (int i = 0; i < 3; ++i) {
        pa[i] = oa[i] + da[i] * za;
        pb[i] = ob[i] + db[i] * zb;
    }
    const double footprint = 2 * half[1] / job->height * (job->camera.fovy > 0 ? fmin(za, zb) : 1);
    double from_a = plane_step(pa, za, na, ob, db), from_b = -plane_step(pb, zb, nb, oa, da);
    const double step = zb - za, least = fmin(fabs(from_a), fabs(from_b)), slack = 0.5 * (footprint + least),
                 most = 16 * footprint + 2 * least;
    from_a = fmax(-most, fmin(most, from_a));
    from_b = fmax(-most, fmin(most, from_b));
    return step >= fmin(from_a, from_b) - slack && step <= fmax(from_a, from_b) + slack;
}

static void floor_place(void *context, int y)
{
    const floor_job *job = context;
    for (int x = 0; x < job->width; ++x) {
        const size_t i = (size_t)y * (size_t)job->width + (size_t)x;
        double o[3], d[3];
        camera_view_ray(&job->camera, x, y, o, d);
        for (int k = 0; k < 3; ++k)
            job->position[3 * i + (size_t)k] = surface(job, i) ? (float)(o[k] + d[k] * (double)job->z[i]) : 0;
    }
}

/* Of the two diagonals of a block, the one that keeps more triangles, else the shorter in depth. Corners 0 1 over 2
   3. */
static void floor_join(void *context, int y)
{
    static const int edge[6][2] = { { 0, 1 }, { 0, 2 }, { 1, 3 }, { 2, 3 }, { 0, 3 }, { 1, 2 } };
    /* corners; edges */
    static const int triple[4][6] = {
        { 0, 2, 3, 1, 3, 4 }, { 0, 3, 1, 0, 2, 4 }, { 0, 2, 1, 0, 1, 5 }, { 1, 2, 3, 2, 3, 5 }
    };
    const floor_job *job = context;
    uint32_t *index = job->index + 6 * (size_t)y * (size_t)(job->width - 1), count = 0;
    for (int x = 0; x + 1 < job->width; ++x) {
        const uint32_t first = (uint32_t)y * (uint32_t)job->width + (uint32_t)x;
        const uint32_t corner[4] = { first, first + 1, first + (uint32_t)job->width, first + (uint32_t)job->width + 1 };
        int on[6], whole[4];
        for (int e = 0; e < 6; ++e)
            on[e] =
                joined(job, x + (edge[e][0] & 1), y + (edge[e][0] >> 1), x + (edge[e][1] & 1), y + (edge[e][1] >> 1));
        for (int t = 0; t < 4; ++t) whole[t] = on[triple[t][3]] && on[triple[t][4]] && on[triple[t][5]];
        const int kept = whole[0] + whole[1] - whole[2] - whole[3];
        const float down = fabsf(job->z[corner[0]] - job->z[corner[3]]),
                    up = fabsf(job->z[corner[1]] - job->z[corner[2]]);
        const int t0 = kept > 0 || (kept == 0 && down <= up) ? 0 : 2;
        for (int t = t0; t < t0 + 2; ++t)
            if (whole[t]) {
                for (int k = 0; k < 3; ++k) index[3 * count + (uint32_t)k] = corner[triple[t][k]];
                ++count;
            }
    }
    job->count[y] = count;
}

static void floor_row(void *context, int y)
{
    const floor_job *job = context;
    for (int x = 0; x < job->width; ++x) {
        const size_t i = (size_t)y * (size_t)job->width + (size_t)x;
        const float *p = job->position + 3 * i;
        double o[3], d[3], normal[3];
        float origin[3];
        job->out[i] = skipped(x, y, job->stride) ? NAN : 1;
        if (skipped(x, y, job->stride) || !surface(job, i) || !job->ambient.trace.node_count) continue;
        camera_view_ray(&job->camera, x, y, o, d);
        floor_normal(job, i, d, normal);
        const float n[3] = { (float)normal[0], (float)normal[1], (float)normal[2] };
        lift_off(p, fmaxf(fabsf(p[2]), fmaxf(fabsf(p[0]), fabsf(p[1]))), n, origin);
        job->out[i] = ambient_at(&job->ambient, (uint32_t)i, origin, n);
    }
}

int kit_floor_ao(kit_image *out, const kit_image *frame, const kit_camera *camera, float radius, int attenuation,
                 int rays, int stride, kit_error *err)
{
    static const char *const names[4] = { "Z", "N.X", "N.Y", "N.Z" };
    floor_job job = { .camera = *camera, .width = frame->width, .height = frame->height, .stride = stride };
    kit_image image = { 0 };
    void *memory = NULL;
    size_t triangles = 0;
    int failed;
    const float *channel[4];
    if (camera_check(camera, "floor", err)) return -1;
    if (stride < 1) return kit_fail(err, "floor: stride %d: must be 1 or more", stride);
    if (frame->width != camera->width || frame->height != camera->height)
        return kit_fail(err, "floor: the frame has %d x %d pixels, the camera %d x %d", frame->width, frame->height,
                        camera->width, camera->height);
    for (int i = 0; i < 4; ++i)
        if (!(channel[i] = kit_image_channel(frame, names[i])))
            return kit_fail(err, "floor: the frame has no channel %s", names[i]);
    job.z = channel[0];
    for (int i = 0; i < 3; ++i) job.n[i] = channel[1 + i];
    if (ambient_begin(&job.ambient, radius, attenuation, rays, "floor", err)) return -1;
    const size_t pixels = (size_t)job.width * (size_t)job.height, row = 2 * (size_t)(job.width - 1),
                 blocks = (size_t)(job.height - 1);
    job.position = malloc(3 * pixels * sizeof *job.position);
    job.index = malloc((3 * row * blocks + 1) * sizeof *job.index);
    job.count = malloc((blocks + 1) * sizeof *job.count);
    failed = !job.position || !job.index || !job.count;
    if (failed) kit_fail(err, "floor: no memory for %zu pixels", pixels);
    if (!failed) {
        kit_parallel(NULL, job.height, floor_place, &job);
        kit_parallel(NULL, job.height - 1, floor_join, &job);
        for (size_t y = 0; y < blocks; ++y) {           /* close the gaps between the rows */
            memmove(job.index + 3 * triangles, job.index + 3 * row * y, 3 * job.count[y] * sizeof *job.index);
            triangles += job.count[y];
        }
        failed = triangles && trace_new(&job.ambient.trace, &memory, job.position, job.index, triangles, "floor", err);
    }
    failed = failed || kit_image_new(&image, job.width, job.height, "Y", err);
    if (!failed) {
        job.out = image.data;
        kit_parallel("floor", job.height, floor_row, &job);
        *out = image;
    }
    free(job.ambient.points);
    free(job.position);
    free(job.index);
    free(job.count);
    free(memory);
    return failed ? -1 : 0;
}
