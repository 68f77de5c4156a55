/* reflected.c - ray-traces the light that ambient visibility approximates: of a white room whose surfaces reflect, and
   of glossy lobes. Declared in kit.h. */
#include "kit/kit_trace.h"
#include <math.h>

static const float albedos[] = KIT_REFLECTED_ALBEDOS, roughnesses[] = KIT_REFLECTED_ROUGHNESSES;
enum { ALBEDOS = (int)(sizeof albedos / sizeof *albedos), LOBES = (int)(sizeof roughnesses / sizeof *roughnesses) };

/* Adds light of 1 from outside the radius that reaches the place after any number of reflections: at each surface a
   path continues with the weight of the occluder there. */
static void white_of(const kit_ambient *a, const kit_mesh *mesh, const kit_place *at, const float first[3],
                     uint32_t seed, double sum[ALBEDOS])
{
    enum { REFLECTIONS = 24 };
    kit_place from = *at;
    double sent[ALBEDOS];
    float d[3] = { first[0], first[1], first[2] };
    for (int k = 0; k < ALBEDOS; ++k) sent[k] = 1;
    for (uint32_t i = 0; i < REFLECTIONS; ++i) {
        ssgi_hit hit;
        kit_place next;
        float u[2];
        const double taken = kit_occluded(a, from.origin, d, &hit);
        for (int k = 0; k < ALBEDOS; ++k) {
            sum[k] += sent[k] * (1 - taken);
            sent[k] *= taken * (double)albedos[k];
        }
        if (!(sent[ALBEDOS - 1] > 1e-4)) return;   /* the last albedo is the greatest, so that nothing is left of any */
        kit_place_of(mesh, &hit, d, &next);
        from = next;
        kit_ambient_point(a, seed & a->mask, kit_mix(seed + i), u);
        kit_cosine_direction(from.n, u, d);
    }
}

/* Returns the visible part of a lobe: half vectors of GGX's distribution about the normal mirror the view. */
static double lobe_of(const kit_ambient *a, const kit_place *at, const float toward[3], double roughness, uint32_t seed)
{
    double open = 0, all = 0;
    for (uint32_t r = 0; r < (uint32_t)a->rays; ++r) {
        float u[2], h[3], d[3];
        kit_ambient_point(a, r, seed, u);
        const double z = sqrt((1 - (double)u[0]) / (1 + (roughness * roughness - 1) * (double)u[0])),
                     flat = sqrt(fmax(0, 1 - z * z)), turn = 2 * KIT_PI * (double)u[1];
        kit_around(at->n, (float)(flat * cos(turn)), (float)(flat * sin(turn)), (float)z, h);
        kit_mirror(toward, h, d);
        if (!(kit_facing(h, toward) < 0) || !(kit_facing(at->n, d) > 0)) continue;
        ++all;
        open += 1 - kit_occluded(a, at->origin, d, NULL);
    }
    return all > 0 ? open / all : 1;
}

static void reflected_pixel(const kit_truth *job, uint32_t pixel, const kit_place *at, float *value)
{
    const kit_ambient *a = &job->ambient;
    const uint32_t seed = kit_mix(pixel);
    double white[ALBEDOS] = { 0 }, bent[3] = { 0 }, open = 0;
    float origin[3], toward[3], mirrored[3];
    kit_camera_ray(&job->camera, (int)(pixel % (uint32_t)job->camera.width), (int)(pixel / (uint32_t)job->camera.width),
                   origin, toward);
    kit_mirror(toward, at->n, mirrored);
    for (uint32_t r = 0; r < (uint32_t)a->rays; ++r) {
        float u[2], d[3];
        kit_ambient_point(a, r, seed, u);
        kit_cosine_direction(at->n, u, d);
        const double is = 1 - kit_occluded(a, at->origin, d, NULL);
        open += is;
        for (int i = 0; i < 3; ++i) bent[i] += is * (double)d[i];
        white_of(a, job->mesh, at, d, kit_mix(seed + r), white);
    }
    if (!kit_unit(bent)) for (int i = 0; i < 3; ++i) bent[i] = (double)at->n[i];
    *value++ = (float)(open / a->rays);
    *value++ = (float)(bent[0] * (double)mirrored[0] + bent[1] * (double)mirrored[1] + bent[2] * (double)mirrored[2]);
    *value++ = (float)kit_facing(at->n, mirrored);
    for (int k = 0; k < ALBEDOS; ++k) *value++ = (float)(white[k] / a->rays);
    for (int k = 0; k < LOBES; ++k)
        *value++ = (float)lobe_of(a, at, toward, (double)roughnesses[k], kit_mix(seed + (uint32_t)k));
}

int kit_truth_reflected(kit_image *out, const kit_scene *scene, const kit_camera *camera, float radius, int rays,
                        int stride, kit_error *err)
{
    kit_truth job = { .pixel = reflected_pixel, .background = NAN };
    return kit_truth_run(&job, out, KIT_REFLECTED_CHANNELS, scene, camera, radius, KIT_ATTENUATION_LINEAR, rays, stride,
                         err);
}
