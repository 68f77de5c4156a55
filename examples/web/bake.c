/* bake.c - what the page makes of triangles in a worker, as WebAssembly without a C library: surfels of a view, the
   field of an object. baker.mjs loads it, and gives each function memory from __heap_base on.

   Triangles are nine floats each: positions, normals. What fails returns -1, and bake_why() says why. */
#define SSGI_IMPLEMENTATION
#include "../../ssgi.h"

#include "../tools/wasm/libc/string.c"

#define EXPORT(name) __attribute__((export_name(name)))

static struct {
    const char *why;
    ssgi_view view;
    ssgi_surfel_desc surfels;
    ssgi_surfel_source source;
} now;

EXPORT("bake_why")
const char *bake_why(void) { return now.why; }

/* ---- surfels */

/* What the next are made for: the picture's projection, surfels of this size, occluders this far away at most. */
EXPORT("bake_look")
int bake_look(const float *projection, int width, int height, float size, float reach)
{
    now.surfels = (ssgi_surfel_desc){ .size = size, .max_distance = reach };
    return ssgi_view_from_projection(&now.view, projection, SSGI_CLIP_GL, width, height, &now.why) == SSGI_OK ? 0 : -1;
}

static void look_at(const float *to_view, const float *position, const float *normal, int stride, int triangles)
{
    now.source = (ssgi_surfel_source){ .position = position, .normal = normal, .triangles = (size_t)triangles };
    now.source.position_stride = now.source.normal_stride = (size_t)stride;
    memcpy(now.source.to_view, to_view, sizeof now.source.to_view);
}

/* Triangles near enough, huge ones divided: 27 floats each. Returns how many there are; writes at most `capacity`. */
EXPORT("bake_divide")
int bake_divide(float *out, int capacity, const float *to_view, const float *position, const float *normal,
                int triangles)
{
    size_t count = 0;
    look_at(to_view, position, normal, 12, triangles);
    if (ssgi_surfels_divide(out, (size_t)capacity, &count, &now.surfels, &now.view, &now.source, &now.why) != SSGI_OK)
        return -1;
    return (int)count;
}

/* Those that ask for splits last: the order of build/render, which patches want, so that both have the same surfels. */
EXPORT("bake_sort")
void bake_sort(float *sorted, const float *to_view, const float *divided, int triangles)
{
    const ssgi_splat splat = { 0 };
    size_t small = 0, large = (size_t)triangles;
    for (const float *t = divided; t < divided + 27 * triangles; t += 27) {
        ssgi_surfel_cost cost = { 0 };
        look_at(to_view, t, NULL, 36, 1);
        ssgi_surfels_predict(&cost, &now.surfels, &splat, &now.view, &now.source, NULL);
        memcpy(sorted + 27 * (cost.splits > 1 ? --large : small++), t, 27 * sizeof *t);
    }
}

/* Surfels of such triangles. Returns how many there are; writes at most `capacity`. */
EXPORT("bake_surfels")
int bake_surfels(ssgi_surfel *out, int capacity, const float *to_view, const float *divided, int triangles)
{
    size_t count = 0;
    look_at(to_view, divided, divided + 3, 36, triangles);
    if (ssgi_surfels(out, (size_t)capacity, &count, &now.surfels, &now.view, &now.source, &now.why) != SSGI_OK)
        return -1;
    return (int)count;
}

/* ---- a field */

/* Told by the page how far the bake is, 0 to 1. */
__attribute__((import_module("page"), import_name("progress"))) void page_progress(float done);

static int told(void *user, float done)
{
    (void)user;
    page_progress(done);
    return 0;
}

static ssgi_field_desc field_of(int resolution, int rays)
{
    return (ssgi_field_desc){ .resolution = resolution, .rays = rays, .progress = told };
}

/* Bytes of its work memory, and of its texels; 0: bad numbers. */
EXPORT("bake_field_work")
int bake_field_work(int resolution, int rays, int triangles)
{
    const ssgi_field_desc d = field_of(resolution, rays);
    return (int)ssgi_field_bake_size(&d, (size_t)triangles);
}

EXPORT("bake_field_texels")
int bake_field_texels(int resolution) { return (int)ssgi_field_size(resolution); }

/* Bakes, then writes the field as ssgi_field_save does over the work memory; returns how many bytes. */
EXPORT("bake_field")
int bake_field(void *work, int work_size, uint32_t *texels, int resolution, int rays, const float *position,
               int triangles)
{
    const ssgi_field_desc d = field_of(resolution, rays);
    ssgi_field field;
    if (ssgi_field_bake(&field, texels, work, (size_t)work_size, &d, position, 12, NULL, (size_t)triangles, &now.why)
        != SSGI_OK)
        return -1;
    return (int)ssgi_field_save(work, (size_t)work_size, &field);
}
