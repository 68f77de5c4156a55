/* floor.c - ray-traces the floor, the best ambient visibility that one depth layer allows. Declared in kit.h. */
#include "kit/kit_trace.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- floor ---------------------------------------------------------------------------------------------------- */

typedef struct floor_job {
    kit_ambient  ambient;
    kit_camera   camera;
    int          width, height, stride;
    const float *z, *n[3];
    float       *position;          /* 3 floats a pixel, view space */
    uint32_t    *index;             /* a row of 2x2 blocks has up to 2 (width - 1) triangles */
    uint32_t    *count;             /* number of triangles of each row of blocks */
    float       *out;
} floor_job;

/* Writes the frame's unit normal; if it has none, the direction toward the viewer. */
static void floor_normal(const floor_job *job, size_t pixel, const double ray[3], double n[3])
{
    for (int i = 0; i < 3; ++i) n[i] = (double)job->n[i][pixel];
    if (kit_unit(n)) return;
    for (int i = 0; i < 3; ++i) n[i] = -ray[i];
    kit_unit(n);
}

/* Returns the change of view depth from pixel a to pixel b on the tangent plane of a. Beyond 89 degrees (n within 1/64
   of edge-on) the plane is turned back to that. */
static double plane_step(const double a[3], double depth, const double n[3], const double o[3], const double d[3])
{
    double facing = kit_dot(n, d), height = 0;
    facing = fmin(facing, -sqrt(kit_dot(d, d)) / 64);
    for (int i = 0; i < 3; ++i) height += n[i] * (a[i] - o[i] - d[i] * depth);
    return height / facing;
}

/* Returns whether two neighbouring pixels are on one surface: their tangent planes must meet between them. So the
   change in depth must be between the changes that the two planes predict, within a tolerance of half a pixel's
   footprint and half of the smaller change (normals are interpolated, surfaces bend). Planes are joined at any slant,
   and so are creases; silhouettes are cut, because the surface behind does not lead up to them. If only one of the
   planes is steep, its prediction is limited to 16 footprints: to two pixels, the rim of a ball in front of a wall
   looks like a crease. */
static int joined(const floor_job *job, int xa, int ya, int xb, int yb)
{
    const size_t a = (size_t)ya * (size_t)job->width + (size_t)xa, b = (size_t)yb * (size_t)job->width + (size_t)xb;
    double oa[3], da[3], ob[3], db[3], na[3], nb[3], pa[3], pb[3], half[2];
    if (!kit_shown(job->z[a]) || !kit_shown(job->z[b])) return 0;
    const double za = (double)job->z[a], zb = (double)job->z[b];
    kit_camera_half(&job->camera, half);
    kit_camera_view_ray(&job->camera, xa, ya, oa, da);
    kit_camera_view_ray(&job->camera, xb, yb, ob, db);
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
        kit_camera_view_ray(&job->camera, x, y, o, d);
        for (int k = 0; k < 3; ++k)
            job->position[3 * i + (size_t)k] = kit_shown(job->z[i]) ? (float)(o[k] + d[k] * (double)job->z[i]) : 0;
    }
}

/* Chooses the diagonal of a 2x2 block that keeps more triangles, else the shorter in depth. Corners 0 1 over 2 3. */
static void floor_join(void *context, int y)
{
    static const int edge[6][2] = { { 0, 1 }, { 0, 2 }, { 1, 3 }, { 2, 3 }, { 0, 3 }, { 1, 2 } };
    /* a triangle's three corners of the block; its three edges */
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
        job->out[i] = kit_skipped(x, y, job->stride) ? NAN : 1;
        if (kit_skipped(x, y, job->stride) || !kit_shown(job->z[i]) || !job->ambient.trace.node_count) continue;
        kit_camera_view_ray(&job->camera, x, y, o, d);
        floor_normal(job, i, d, normal);
        const float n[3] = { (float)normal[0], (float)normal[1], (float)normal[2] };
        kit_lift_off(p, fmaxf(fabsf(p[2]), fmaxf(fabsf(p[0]), fabsf(p[1]))), n, origin);
        job->out[i] = kit_ambient_at(&job->ambient, (uint32_t)i, origin, n);
    }
}

/* Makes the visible surface as triangles, indices of pixels, and returns their number. */
static size_t floor_triangles(floor_job *job)
{
    const size_t row = 2 * (size_t)(job->width - 1), blocks = (size_t)(job->height - 1);
    size_t triangles = 0;
    kit_parallel(NULL, job->height, floor_place, job);
    kit_parallel(NULL, job->height - 1, floor_join, job);
    for (size_t y = 0; y < blocks; ++y) {               /* moves each row's triangles behind those of the row before */
        memmove(job->index + 3 * triangles, job->index + 3 * row * y, 3 * job->count[y] * sizeof *job->index);
        triangles += job->count[y];
    }
    return triangles;
}

static int floor_trace(kit_image *out, floor_job *job, kit_error *err)
{
    const size_t pixels = (size_t)job->width * (size_t)job->height,
                 most = 2 * (size_t)(job->width - 1) * (size_t)(job->height - 1);
    void *memory = NULL;
    kit_image image;
    job->position = malloc(3 * pixels * sizeof *job->position);
    job->index = malloc((3 * most + 1) * sizeof *job->index);
    job->count = malloc((size_t)job->height * sizeof *job->count);
    if (!job->position || !job->index || !job->count)
        return kit_fail(err, "floor: no memory for %zu pixels", pixels);
    const size_t triangles = floor_triangles(job);
    if (triangles
        && kit_trace_new(&job->ambient.trace, &memory, job->position, job->index, triangles, "floor", err))
        return -1;
    const int failed = kit_image_new(&image, job->width, job->height, "Y", err);
    if (!failed) {
        job->out = image.data;
        kit_parallel("floor", job->height, floor_row, job);
        *out = image;
    }
    free(memory);
    return failed;
}

int kit_floor_ao(kit_image *out, const kit_image *frame, const kit_camera *camera, float radius, int attenuation,
                 int rays, int stride, kit_error *err)
{
    static const char *const names[4] = { "Z", "N.X", "N.Y", "N.Z" };
    floor_job job = { .camera = *camera, .width = frame->width, .height = frame->height, .stride = stride };
    const float *channel[4];
    if (kit_camera_check(camera, "floor", err)) return -1;
    if (stride < 1) return kit_fail(err, "floor: stride %d: must be 1 or more", stride);
    if (frame->width != camera->width || frame->height != camera->height)
        return kit_fail(err, "floor: the frame has %d x %d pixels, the camera %d x %d", frame->width, frame->height,
                        camera->width, camera->height);
    for (int i = 0; i < 4; ++i)
        if (!(channel[i] = kit_image_channel(frame, names[i])))
            return kit_fail(err, "floor: the frame has no channel %s", names[i]);
    job.z = channel[0];
    for (int i = 0; i < 3; ++i) job.n[i] = channel[1 + i];
    if (kit_ambient_begin(&job.ambient, radius, attenuation, rays, "floor", err)) return -1;
    const int failed = floor_trace(out, &job, err);
    free(job.ambient.points);
    free(job.position);
    free(job.index);
    free(job.count);
    return failed ? -1 : 0;
}
