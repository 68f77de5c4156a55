/* harmonics.c - spherical harmonics of occlusion [S3HO12] beside bent cones [SSBN11], step by step: by visibility that
   is ray-traced, then as slices and points see it, then filtered. Declared in oracle.h. */
#include "lab/oracle/oracle.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { BANDS = SSGI_SH_MAX_BANDS, MOST = BANDS * BANDS, ACROSS = 192, DOWN = 96, CELLS = ACROSS * DOWN,
       TRUTH_RAYS = 4096 };
enum { AMBIENT, PLAIN, RESIDUAL = PLAIN + BANDS, OPEN_BANDS = RESIDUAL + BANDS, HANN, POSITIVE, RATIO, BENT_NORMAL,
       BENT_CONE, BANDS_AND_CONE, BANDS_AND_BENT, WAYS };
static const char *const names[WAYS] = {
    [AMBIENT]         = "ambient visibility times open light",
    [PLAIN]           = "1 band", "2 bands", "3 bands", "4 bands: as published", "5 bands", "6 bands",
    [RESIDUAL]        = "1 band, residual", "2 bands, residual", "3 bands, residual",
                        "4 bands, residual: the library's", "5 bands, residual", "6 bands, residual",
    [OPEN_BANDS]      = "what 4 bands lack of open light, alone",
    [HANN]            = "4 bands by Hann's window, residual",
    [POSITIVE]        = "4 bands by the positive window, residual",
    [RATIO]           = "4 bands: their ratio to open ones, times open light",
    [BENT_NORMAL]     = "bent normal",
    [BENT_CONE]       = "bent cone",
    [BANDS_AND_CONE]  = "tried: 4 bands, the rest of light by the cone",
    [BANDS_AND_BENT]  = "tried: 4 bands, the rest by the bent normal"
};

typedef struct cell { float way[3], area, light[3], bands[3]; } cell;  /* of the environment; bands: by its first 4 */

typedef struct job {
    oracle   *o;
    kit_image env;
    float     light[3 * MOST];
    cell      cell[CELLS];
    double   *truth, *open, *way[WAYS];    /* three channels a pixel; open: where nothing occludes */
} job;

static double dot(const float a[3], const float b[3])
{
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

/* Seen through a von Mises-Fisher lobe, as ssgi_environment_map has it. */
static int filter_environment(kit_image *env, double solid_angle, kit_error *err)
{
    enum { WIDTH = 96, HEIGHT = 48 };
    static float way[WIDTH * HEIGHT][3], light[WIDTH * HEIGHT][3];
    const size_t texels = (size_t)env->width * (size_t)env->height;
    double sum[WIDTH * HEIGHT][4] = { { 0 } };
    kit_image filtered;
    for (size_t i = 0; i < texels; ++i) {
        const size_t x = i % (size_t)env->width * WIDTH / (size_t)env->width,
                     y = i / (size_t)env->width * HEIGHT / (size_t)env->height;
        for (size_t c = 0; c < 3; ++c) sum[y * WIDTH + x][c] += (double)env->data[c * texels + i];
        sum[y * WIDTH + x][3] += 1;
    }
    if (kit_image_new(&filtered, WIDTH, HEIGHT, "R,G,B", err)) return -1;
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        kit_env_direction(&filtered, i % WIDTH + 0.5, i / WIDTH + 0.5, way[i]);
        for (int c = 0; c < 3; ++c) light[i][c] = (float)(sum[i][c] / sum[i][3]);
    }
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        double all = 0, mean[3] = { 0 };
        for (int k = 0; k < WIDTH * HEIGHT; ++k) {
            const double weight = sin(KIT_PI * (k / WIDTH + 0.5) / HEIGHT)
                                * exp(4 * KIT_PI / solid_angle * (dot(way[i], way[k]) - 1));
            all += weight;
            for (int c = 0; c < 3; ++c) mean[c] += weight * (double)light[k][c];
        }
        for (int c = 0; c < 3; ++c) filtered.data[c * WIDTH * HEIGHT + i] = (float)(mean[c] / all);
    }
    kit_image_free(env);
    *env = filtered;
    return 0;
}

/* The environment's coefficients, and its cells. */
static int project(job *j, kit_error *err)
{
    float *rgb = kit_env_interleaved(&j->env);
    const char *why = "out of memory";
    const int failed =
        !rgb || ssgi_sh_project_equirect(j->light, BANDS, rgb, j->env.width, j->env.height, &why) != SSGI_OK;
    free(rgb);
    for (int i = 0; i < CELLS && !failed; ++i) {
        enum { PARTS = 4 };
        cell *e = &j->cell[i];
        const double x = (i % ACROSS + 0.5) / ACROSS * j->env.width, y = (i / ACROSS + 0.5) / DOWN * j->env.height;
        float basis[16];
        kit_env_direction(&j->env, x, y, e->way);
        e->area = (float)(2 * KIT_PI * KIT_PI / CELLS * sin(KIT_PI * (i / ACROSS + 0.5) / DOWN));
        for (int k = 0; k < PARTS * PARTS; ++k) {
            float d[3], one[3];
            kit_env_direction(&j->env, x + ((k % PARTS + 0.5) / PARTS - 0.5) * j->env.width / ACROSS,
                              y + ((k / PARTS + 0.5) / PARTS - 0.5) * j->env.height / DOWN, d);
            kit_env_radiance(&j->env, d, one);
            for (int c = 0; c < 3; ++c) e->light[c] += one[c] / (PARTS * PARTS);
        }
        ssgi_sh_basis(basis, 4, e->way);
        for (int b = 0; b < 16; ++b)
            for (int c = 0; c < 3; ++c) e->bands[c] += basis[b] * j->light[3 * b + c];
    }
    return failed ? kit_fail(err, "%s", why) : 0;
}

/* The mean over the cone about an axis, weighted by the cosine to it: of light, and of its first 4 bands. */
static void cone(const job *j, const double axis[3], double cosine, double light[3], double bands[3])
{
    const float a[3] = { (float)axis[0], (float)axis[1], (float)axis[2] };
    double all = 0;
    memset(light, 0, 3 * sizeof *light);
    memset(bands, 0, 3 * sizeof *bands);
    for (int i = 0; i < CELLS; ++i) {
        const cell *e = &j->cell[i];
        const double c = dot(e->way, a), rim = KIT_PI / DOWN,       /* a ramp as wide as a cell */
                     weight = c > 0 ? c * fmin(fmax((c - cosine) / rim + 0.5, 0), 1) * (double)e->area : 0;
        if (!(weight > 0)) continue;
        all += weight;
        for (int k = 0; k < 3; ++k) {
            light[k] += weight * (double)e->light[k];
            bands[k] += weight * (double)e->bands[k];
        }
    }
    for (int k = 0; k < 3; ++k) light[k] /= all, bands[k] /= all;
}

/* Over pi, by the first coefficients; window NULL: as they are. */
static double dotted(const job *j, const double *transfer, int bands, int channel, const float *window)
{
    double sum = 0;
    for (int l = 0; l < bands; ++l)
        for (int i = l * l; i < (l + 1) * (l + 1); ++i)
            sum += transfer[i] * (double)j->light[3 * i + channel] * (window ? (double)window[l] : 1);
    return sum / KIT_PI;
}

static void to_world(const oracle *o, const float d[3], float out[3])
{
    for (int k = 0; k < 3; ++k)
        out[k] = o->to_view[4 * k] * d[0] + o->to_view[4 * k + 1] * d[1] + o->to_view[4 * k + 2] * d[2];
}

/* The cosine lobe less what is blocked of it, in the world; both in bands, and ambient visibility. */
static double transfer_of(const oracle *o, int i, double lobe[MOST], double transfer[MOST])
{
    const oracle_pixel *q = &o->pixel[i];
    float zonal[BANDS], basis[MOST], n[3];
    double ambient = 1;
    to_world(o, q->n, n);
    for (int l = 0; l < BANDS; ++l) zonal[l] = ssgi_sh_cosine(l) * (float)sqrt((2 * l + 1) / (4 * KIT_PI));
    ssgi_sh_zonal(basis, BANDS, zonal, n);
    for (int k = 0; k < MOST; ++k) transfer[k] = lobe[k] = (double)basis[k];
    for (int r = 0; r < ORACLE_RAYS; ++r) {
        ssgi_hit hit;
        float d[3], w[3];
        oracle_ray(d, (uint32_t)i, r, q->n);
        if (!ssgi_trace_closest(&hit, &o->trace, q->lifted, d, 0, o->radius)) continue;
        const double blocked = (1 - (double)(hit.t / o->radius)) / ORACLE_RAYS;
        to_world(o, d, w);
        ssgi_sh_basis(basis, BANDS, w);
        ambient -= blocked;
        for (int k = 0; k < MOST; ++k) transfer[k] -= KIT_PI * blocked * (double)basis[k];
    }
    return ambient;
}

/* ssgi_bent of the header: the mean open direction, which band 1 has as y, z, x, and the cosine of a cone's half-angle
   whose mean is as long. */
static double bent_of(double axis[3], const double transfer[MOST], double ambient)
{
    const double way[3] = { transfer[3], transfer[1], transfer[2] }, length = sqrt(kit_dot(way, way)),
                 spread = fmin(fmax(3 * 0.65147002 * length / fmax(ambient, 1e-6) - 2, 0), 1);
    for (int k = 0; k < 3; ++k) axis[k] = way[k] / length;
    return fmin(0.25 * (spread + sqrt(spread * spread + 8 * spread)), 0.97);
}

static void shade_pixel(void *context, int i)
{
    const job *j = context;
    double transfer[MOST], lobe[MOST], axis[3], light[2][3], bands[2][3];
    float window[2][4];
    const double ambient = transfer_of(j->o, i, lobe, transfer), cosine = bent_of(axis, transfer, ambient);
    cone(j, axis, cosine, light[0], bands[0]);
    cone(j, axis, 0, light[1], bands[1]);
    ssgi_sh_window(window[0], 4, SSGI_SH_WINDOW_HANN);
    ssgi_sh_window(window[1], 4, SSGI_SH_WINDOW_POSITIVE);
    for (int c = 0; c < 3; ++c) {
        const size_t at = 3 * (size_t)i + (size_t)c;
        const double open = j->open[at], by_four = dotted(j, transfer, 4, c, NULL),
                     open_four = dotted(j, lobe, 4, c, NULL);
        for (int b = 0; b < BANDS; ++b) {
            j->way[PLAIN + b][at] = dotted(j, transfer, b + 1, c, NULL);
            j->way[RESIDUAL + b][at] = j->way[PLAIN + b][at] + ambient * (open - dotted(j, lobe, b + 1, c, NULL));
        }
        for (int k = 0; k < 2; ++k) {
            j->way[HANN + k][at] =
                dotted(j, transfer, 4, c, window[k]) + ambient * (open - dotted(j, lobe, 4, c, window[k]));
            j->way[BANDS_AND_CONE + k][at] = by_four + ambient * (light[k][c] - bands[k][c]);
        }
        j->way[AMBIENT][at] = ambient * open;
        j->way[OPEN_BANDS][at] = j->truth[at] + open_four - open;
        j->way[RATIO][at] = open * fmin(fmax(by_four / fmax(open_four, 1e-9), 0), 1);
        j->way[BENT_CONE][at] = ambient * light[0][c];
        j->way[BENT_NORMAL][at] = ambient * light[1][c];
    }
}

/* ---- >>pictures, tables ------------------------------------------------------------------------------------------ */

static void values_of(double *out, const oracle *o, const kit_image *picture)
{
    static const char *const channel[3] = { "irradiance.R", "irradiance.G", "irradiance.B" };
    for (int i = 0; i < 3 * o->pixels; ++i) out[i] = (double)oracle_value(o, picture, i / 3, channel[i % 3]);
}

static int trace(double *out, const job *j, const kit_lighting *lighting, float radius, kit_error *err)
{
    kit_image picture;
    if (kit_truth_lit(&picture, &j->o->scene, &j->o->g.camera, lighting, radius, KIT_ATTENUATION_LINEAR, 0, TRUTH_RAYS,
                      ORACLE_APART, err))
        return -1;
    values_of(out, j->o, &picture);
    kit_image_free(&picture);
    return 0;
}

#define EXACTLY ",half=0,directions=16,steps=32,blur=0"
#define POINTS ",samples=32,steps=2,blur=0,fade=none,range=0"
static const struct { const char *name, *method, *set; } pictures[] = {
    { "s3ho, 16 slices of 32 steps, unfiltered", "s3ho", "indirect=none" EXACTLY },
    { "the same, as published", "s3ho", "indirect=none,residual=0" EXACTLY },
    { "ssbn, as many", "ssbn", "cone=cone" EXACTLY },
    { "s3ho at full size, ratio filtered", "s3ho", "indirect=none,half=0,restore=ratio" },
    { "the same, difference", "s3ho", "indirect=none,half=0,restore=difference" },
    { "the same, light", "s3ho", "indirect=none,half=0,restore=none" },
    { "the same, coefficients", "s3ho", "indirect=none,half=0,filtered=coefficients" },
    { "ssbn at full size, ratio filtered", "ssbn", "half=0,restore=ratio" },
    { "the same, light", "ssbn", "half=0,restore=none" },
    { "s3ho", "s3ho", "indirect=none" },
    { "ssbn", "ssbn", "" },
    { "ssdo", "ssdo", "bounce=none" },
    { "s3ho-points, 32 samples, as published", "s3ho-points", "indirect=none,residual=0" POINTS },
    { "the same, residual", "s3ho-points", "indirect=none" POINTS },
    { "ssbn-points, 32 samples", "ssbn-points", "cone=cone" POINTS }
};
enum { PICTURES = (int)(sizeof pictures / sizeof *pictures) };

static int draw(job *j, double *drawn, const kit_lighting *lighting, kit_error *err)
{
    const kit_world world = { &j->o->scene, lighting };
    for (int k = 0; k < PICTURES; ++k) {
        kit_image seen;
        if (kit_run_picture(&seen, &j->o->g, &world, pictures[k].method, pictures[k].set, j->o->radius, err)) return -1;
        values_of(drawn, j->o, &seen);
        kit_image_free(&seen);
        oracle_row(pictures[k].name, drawn, j->truth, j->open, 3 * j->o->pixels);
    }
    fflush(stdout);
    return 0;
}

int harmonics_diagnosis(oracle *o, const char *env, double solid_angle, kit_error *err)
{
    static job j;
    const int count = 3 * o->pixels;
    double *all = calloc((WAYS + 3) * (size_t)count, sizeof *all), mean = 0, squares = 0;
    kit_lighting lighting = { .lights = 0 };
    memset(&j, 0, sizeof j);
    j.o = o;
    j.truth = all;
    if (!all) return kit_fail(err, "out of memory");
    j.open = all + count;
    for (int w = 0; w < WAYS; ++w) j.way[w] = all + (3 + w) * count;
    int failed = kit_env_read(&j.env, env, err) || (solid_angle > 0 && filter_environment(&j.env, solid_angle, err))
              || project(&j, err);
    lighting.env = j.env;
    failed = failed || trace(j.truth, &j, &lighting, o->radius, err)
          || trace(j.open, &j, &lighting, 1e-5f * o->radius, err);
    if (!failed) {
        kit_parallel("pixels", o->pixels, shade_pixel, &j);
        for (int i = 0; i < count; ++i) {
            mean += j.truth[i] / count;
            squares += (j.open[i] - j.truth[i]) * (j.open[i] - j.truth[i]) / count;
        }
        printf("\n%s under %s, %g sr: %d pixels of %d rays, mean %.3f, error of no occlusion %.4f\n", o->scene.name,
               env, solid_angle, o->pixels, TRUTH_RAYS, mean, sqrt(squares));
        for (int w = 0; w < WAYS; ++w) oracle_row(names[w], j.way[w], j.truth, j.open, count);
        failed = draw(&j, all + 2 * count, &lighting, err);
    }
    kit_image_free(&j.env);
    free(all);
    return failed ? -1 : 0;
}
