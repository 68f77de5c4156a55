/* scatter.c - sums multiple scattering under surfaces over the whole mesh. Declared in kit.h. */
#include "kit/kit_trace.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- under surfaces ------------------------------------------------------------------------------------------- */

enum { REFLECTANCES = 16384 };                  /* entries of the table of the dipole's reflectance by distance */

typedef struct scattering {
    kit_truth job;
    float *area;                                /* running sum of area over the triangles */
    /* position, irradiance over pi: 4 floats a sample; once all are made, only lit samples */
    float *sample;
    size_t samples;
    float  per_unit, table[REFLECTANCES][4]; /* entries per world unit of distance; a sample's area times reflectance */
} scattering;

static void scatter_place(void *context, int block)
{
    scattering *s = context;
    const kit_mesh *mesh = s->job.mesh;
    const size_t first = (size_t)block << 10, end = first + 1024 < s->samples ? first + 1024 : s->samples;
    for (size_t i = first; i < end; ++i) {
        static const int none[2] = { 0, 0 };
        float u[2];
        ssgi_r2(u, (uint32_t)i);
        const float root = sqrtf(u[0]);
        const ssgi_hit hit = { .triangle = (uint32_t)kit_pick(s->area, (int)mesh->triangles,
                                                          (float)(((double)i + 0.5) / (double)s->samples)),
                               .u = root * (1 - u[1]),
                               .v = root * u[1] };
        const float *n = mesh->normal + 9 * (size_t)hit.triangle;
        float *sample = s->sample + 8 * i, inward[3];
        double light[3] = { 0 };
        kit_place p;
        for (int k = 0; k < 3; ++k) inward[k] = -n[k] - n[3 + k] - n[6 + k];
        kit_place_of(mesh, &hit, inward, &p);
        kit_gather(&s->job, &p, 0, 0, none, light, NULL);
        memcpy(sample, p.origin, sizeof p.origin);
        for (int c = 0; c < 3; ++c) sample[4 + c] = (float)light[c];
    }
}

static void scatter_pixel(const kit_truth *job, uint32_t pixel, const kit_place *at, float *value)
{
    const scattering *s = job->within;
    double all[3] = { 0 };
    (void)pixel;
    for (size_t i = 0; i < s->samples;) {
        float sum[4] = { 0, 0, 0, 0 };
        /* sums few samples at a time, because long float sums lose precision */
        for (const size_t end = i + 256 < s->samples ? i + 256 : s->samples; i < end; ++i) {
            const float *p = s->sample + 8 * i, x = p[0] - at->origin[0], y = p[1] - at->origin[1],
                        z = p[2] - at->origin[2];
            /* d stays in the table: no distance exceeds the bounds' diagonal */
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
        kit_cross(e, f, n);
        s->area[t + 1] = (float)(0.5 * sqrt(kit_dot(n, n)));
    }
    area = kit_accumulate(s->area, (int)mesh->triangles) * (double)mesh->triangles;
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
    if (kit_trace_new(&s->job.ambient.trace, &memory, mesh->position, NULL, mesh->triangles, "truth", err)) return -1;
    kit_parallel("irradiance", (int)((samples + 1023) >> 10), scatter_place, s);
    free(memory);
    s->samples = 0;
    for (size_t i = 0; i < samples; ++i) {                     /* dark samples send nothing */
        const float *from = s->sample + 8 * i;
        if (from[4] + from[5] + from[6] > 0) memmove(s->sample + 8 * s->samples++, from, 8 * sizeof *from);
    }
    return 0;
}

int kit_truth_scatter(kit_image *out, const kit_scene *scene, const kit_camera *camera, const kit_lighting *lighting,
                      const ssgi_dipole *dipole, float unit, size_t samples, int stride, kit_error *err)
{
    kit_truth job = { .pixel = scatter_pixel, .lighting = lighting };
    scattering *s = calloc(1, sizeof *s);
    int failed = 0;
    if (samples < 1 || samples > 1u << 26 || !(unit > 0))
        failed = kit_fail(err, "truth: %zu samples, unit %g: must be 1..2^26, above 0", samples, (double)unit);
    else if (lighting->lights < 0 || lighting->lights > KIT_MAX_LIGHTS)
        failed = kit_fail(err, "truth: %d lights: must be 0..%d", lighting->lights, KIT_MAX_LIGHTS);
    else if (!s) failed = kit_fail(err, "truth: out of memory");
    else failed = scatter_begin(s, samples, scene, lighting, dipole, unit, err);
    job.within = s;
    failed = failed
          || kit_truth_run(&job, out, KIT_LIT_CHANNELS, scene, camera, INFINITY, KIT_ATTENUATION_NONE, 1, stride, err);
    if (s) { free(s->area); free(s->sample); }
    free(s);
    return failed ? -1 : 0;
}
