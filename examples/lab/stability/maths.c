/* maths.c - sweeps of the library's CPU functions alone. Declared in maths.h. */
#include "lab/stability/maths.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/stability/shot.h"

/* ---- >>ringing --------------------------------------------------------------------------------------------------- */

enum { ANGLES = 73, SPHERE_POINTS = 40000 };

/* Writes a surface's visibility as harmonics: open, or, in shade, open in a cone of 30 degrees, 45 off the normal. */
static void transfer_of(double transfer[16], int shade)
{
    for (int i = 0; i < SPHERE_POINTS; ++i) {              /* points on a spiral around the normal, the axis z */
        const double z = 1 - (i + 0.5) * 2 / SPHERE_POINTS, s = sqrt(1 - z * z), a = 2.39996322972865 * i;
        const float d[3] = { (float)(s * cos(a)), (float)(s * sin(a)), (float)z };
        float basis[16];
        ssgi_sh_basis(basis, 4, d);
        for (int k = 0; k < 16 && z > 0 && (!shade || d[0] + d[2] > 1.41421356f * 0.8660254f); ++k)
            transfer[k] += z * (double)basis[k] * 12.566370614359172 / SPHERE_POINTS;
    }
}

/* Adds a curve of a point's irradiance while a sun as harmonics turns around it, over that of an open surface that
   faces the sun. The number is the lowest value. */
static int ringing(result *r, int shade, kit_error *err)
{
    static const char *const labels[3][3] = { { "2 bands", "2 bands, Hann", "2 bands, positive" },
                                              { "3 bands", "3 bands, Hann", "3 bands, positive" },
                                              { "4 bands", "4 bands, Hann", "4 bands, positive" } };
    const float white[3] = { 1, 1, 1 };
    double transfer[16] = { 0 };
    transfer_of(transfer, shade);
    r->points = ANGLES;
    curve *truth = curve_new(r, "truth", BESIDE);
    for (int k = 0; k < ANGLES; ++k) {
        r->x[k] = 5 * k - 180;
        const double a = r->x[k] * (double)DEGREE;
        truth->y[k] = fabs(a) < 1.5707 && (!shade || fabs(r->x[k] - 45) < 30) ? cos(a) : 0;
    }
    for (int i = 0; i < 9; ++i) {
        curve *c = curve_new(r, labels[i / 3][i % 3], NO_METHOD);
        const int bands = 2 + i / 3;
        c->number = 0;
        for (int k = 0; k < ANGLES; ++k) {
            const float a = (float)r->x[k] * DEGREE, d[3] = { sinf(a), 0, cosf(a) };
            float light[48] = { 0 };
            const char *why = "";
            if (ssgi_sh_light(light, bands, d, 0, white, i % 3, &why) != SSGI_OK) return kit_fail(err, "%s", why);
            c->y[k] = 0;
            for (int j = 0; j < bands * bands; ++j) c->y[k] += transfer[j] * (double)light[3 * j];
            curve_raise(c, -c->y[k], r->x[k]);
        }
    }
    return 0;
}

int maths_ringing_open(result *r, kit_error *err)     { return ringing(r, 0, err); }
int maths_ringing_in_shade(result *r, kit_error *err) { return ringing(r, 1, err); }

/* ---- >>hull: along a line between a table's legs, facing up ------------------------------------------------------ */

enum { LINE_POINTS = 240, LINE_RAYS = 1024 };
static const float line_up[3] = { 0, 1, 0 };

static void line_place(float p[3], int k)
{
    p[0] = 0.01f * (float)k - 1.195f;
    p[1] = -0.1f;
    p[2] = 0.1f;
}

/* Occlusion by rays. */
static int traced(double v[LINE_POINTS], const kit_mesh *table, kit_error *err)
{
    const char *why = "";
    const size_t size = ssgi_trace_size(table->triangles);
    void *memory = malloc(size);
    ssgi_trace trace;
    if (!memory
        || ssgi_trace_build(&trace, memory, size, table->position, 3 * sizeof(float), NULL, table->triangles, &why)
               != SSGI_OK)
        return kit_fail(err, "table: %s", memory ? why : "out of memory");
    for (int k = 0; k < LINE_POINTS; ++k) {
        float p[3];
        line_place(p, k);
        v[k] = 0;
        for (int i = 0; i < LINE_RAYS; ++i) {
            float u[2];
            ssgi_r2(u, (uint32_t)i);
            const float s = sqrtf(u[0]),
                        d[3] = { s * cosf(6.2831853f * u[1]), sqrtf(1 - u[0]), s * sinf(6.2831853f * u[1]) };
            v[k] += ssgi_trace_any(&trace, p, d, 0, HUGE_VALF) / (double)LINE_RAYS;
        }
    }
    free(memory);
    return 0;
}

/* Fills v with the field's occlusion along the line, with these limits in the hull (below 0: the measured ones). */
static int by_field(double v[LINE_POINTS], const kit_mesh *table, float inside, float power, kit_error *err)
{
    kit_method made;
    if (kit_method_find(&made, "aof", err)) return -1;
    const ssgi_field_desc d = kit_method_field(&made);
    const ssgi_field *f = kit_field(table, &d, NULL, err);
    if (!f) return -1;
    ssgi_field_limits l = ssgi_field_limits_of(f);
    if (inside >= 0) l.inside = inside;
    l.power = power;
    for (int k = 0; k < LINE_POINTS; ++k) {
        float p[3];
        line_place(p, k);
        v[k] = (double)ssgi_field_occlusion(f, &l, p, line_up);
    }
    return 0;
}

/* Adds a curve of values, or of their steps over a hundredth of the table. Number: worst error or largest step. */
static void line_curve(result *r, const char *label, int method, const double *v, const double *truth, int steps)
{
    curve *c = curve_new(r, label, method);
    c->number = 0;
    for (int k = 0; k < LINE_POINTS; ++k) {
        float p[3];
        line_place(p, k);
        r->x[k] = (double)p[0];
        c->y[k] = !steps ? v[k] : k ? v[k] - v[k - 1] : (double)NAN;
        curve_raise(c, fabs(steps ? c->y[k] : v[k] - truth[k]), r->x[k]);
    }
}

static int through(result *r, int steps, kit_error *err)
{
    static const struct { const char *label; float inside, power; } kept[] = {
        { "as measured", -1, 1 }, { "A_0 = 1, p = 2", 1, 2 }, { "A_0 = 0", 0, 1 }
    };
    double truth[LINE_POINTS], v[LINE_POINTS];
    kit_scene scene;
    const kit_mesh *table = NULL;
    if (kit_scene_load(&scene, "casters", 0, err)) return -1;
    for (int i = 0; i < scene.objects && !table; ++i)
        if (!strcmp(scene.object[i].name, "table")) table = &scene.shape[scene.object[i].shape];
    if (!table) return kit_fail(err, "occluders: has no table");
    if (traced(truth, table, err)) return -1;
    r->points = LINE_POINTS;
    line_curve(r, "truth", BESIDE, truth, truth, steps);
    for (size_t m = 0; m < sizeof kept / sizeof *kept; ++m) {
        if (by_field(v, table, kept[m].inside, kept[m].power, err)) return -1;
        line_curve(r, kept[m].label, NO_METHOD, v, truth, steps);
    }
    kit_scene_free(&scene);
    return 0;
}

int maths_hull(result *r, kit_error *err)       { return through(r, 0, err); }
int maths_hull_steps(result *r, kit_error *err) { return through(r, 1, err); }

/* ---- >>popping --------------------------------------------------------------------------------------------------- */

enum { APPROACH_POINTS = 140, APPROACH_WIDTH = 320, APPROACH_HEIGHT = 180 };

/* Counts the surfels that a scene makes at a multiple of the nearest distance. divided: room, kept between calls. */
static int surfels_at(size_t *count, float **divided, const kit_scene *scene, ssgi_surfel_desc d, double times,
                      kit_error *err)
{
    const kit_mesh *mesh = &scene->mesh;
    const look l = { .scene = scene->name, .width = APPROACH_WIDTH, .height = APPROACH_HEIGHT, .stride = 1,
                     .nearer = 1 - (float)times };
    const char *why = "";
    kit_camera camera = scene->camera;
    ssgi_surfel_source source = { .position = mesh->position, .normal = mesh->normal, .triangles = mesh->triangles };
    ssgi_view view;
    size_t triangles = 0;
    float projection[16], *more = NULL;
    d.max_distance = scene->radius;
    shot_aim(&camera, &l);
    kit_camera_planes(&camera, mesh);
    kit_camera_matrices(&camera, source.to_view, projection);
    int failed = ssgi_view_from_projection(&view, projection, SSGI_CLIP_ZERO, l.width, l.height, &why) != SSGI_OK
                 || ssgi_surfels_divide(NULL, 0, &triangles, &d, &view, &source, &why) != SSGI_OK;
    if (!failed) more = realloc(*divided, (27 * triangles + 1) * sizeof *more);
    if (more) *divided = more;
    failed = !more || ssgi_surfels_divide(more, triangles, &triangles, &d, &view, &source, &why) != SSGI_OK;
    source.position = more;
    source.normal = more ? more + 3 : NULL;
    source.position_stride = source.normal_stride = 9 * sizeof(float);
    source.triangles = triangles;
    if (failed || ssgi_surfels(NULL, 0, count, &d, &view, &source, &why) != SSGI_OK)
        return kit_fail(err, "surfels: %s", *why ? why : "out of memory");
    return 0;
}

/* Adds curves of the surfels' count's change over a step of 1 % of the distance. The number is the largest one. */
int maths_popping(result *r, kit_error *err)
{
    static const struct { const char *label; ssgi_surfel_desc d; } kept[] = {
        { "0.03", { .size = 0.03f } }, { "0.015", { .size = 0.015f } },
        { "0.03, every triangle", { .size = 0.03f, .keep_small = 1 } }
    };
    kit_scene scene;
    float *divided = NULL;
    if (kit_scene_load(&scene, "casters", 0, err)) return -1;
    r->points = APPROACH_POINTS;
    for (size_t m = 0; m < sizeof kept / sizeof *kept; ++m) {
        curve *c = curve_new(r, kept[m].label, NO_METHOD);
        size_t last = 0, count = 0;
        c->number = 0;
        for (int k = -1; k < r->points; ++k, last = count) {
            if (surfels_at(&count, &divided, &scene, kept[m].d, pow(1.01, k), err)) return -1;
            if (k < 0) continue;
            r->x[k] = pow(1.01, k);
            c->y[k] = (double)count / (double)last - 1;
            curve_raise(c, fabs(c->y[k]), r->x[k]);
        }
    }
    free(divided);
    kit_scene_free(&scene);
    return 0;
}
