/* oracle.c - where a published method errs: its steps one by one beside what is exact, at a few hundred pixels.

      build/oracle surfels [SCENE ..]           [DSS14] for several sizes of surfel
      build/oracle harmonics [SCENE:ENV:SR ..]  [S3HO12] beside bent cones [SSBN11]; SR: the solid angle of the lobe
                                                that the environment is seen through, 0: as it is

   Each row: RMSE to truth over that of nothing, and the mean difference from truth. */
#include "lab/oracle/oracle.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static float ray_sets[4 * ORACLE_SETS * ORACLE_RAYS];

static void add_pixel(oracle *o, const kit_image *frame, int x, int y)
{
    const size_t pixels = (size_t)frame->width * (size_t)frame->height,
                 i = (size_t)y * (size_t)frame->width + (size_t)x;
    const float z = frame->data[i];
    oracle_pixel *q = &o->pixel[o->pixels];
    float at[3];
    if (!(z > 0)) return;
    *q = (oracle_pixel){ .x = x, .y = y };
    kit_camera_point(&o->g.camera, x, y, (double)z, at);
    for (size_t k = 0; k < 3; ++k) {
        q->p[k] = o->to_view[12 + k];
        for (size_t j = 0; j < 3; ++j) q->p[k] += o->to_view[4 * j + k] * at[j];
        q->n[k] = frame->data[(k + 1) * pixels + i];
    }
    for (int k = 0; k < 3; ++k) q->lifted[k] = q->p[k] + 3e-5f * z * q->n[k];
    ++o->pixels;
}

static int add_pixels(oracle *o, kit_error *err)
{
    kit_image frame;
    if (kit_gbuffer_read(&frame, &o->g, err)) return -1;
    o->pixel = malloc((size_t)(frame.width * frame.height) * sizeof *o->pixel);
    for (int y = ORACLE_APART / 2; y < frame.height && o->pixel; y += ORACLE_APART)
        for (int x = ORACLE_APART / 2; x < frame.width; x += ORACLE_APART) add_pixel(o, &frame, x, y);
    kit_image_free(&frame);
    return o->pixels ? 0 : kit_fail(err, "%s: shows nothing", o->scene.name);
}

static int add_trace(oracle *o, kit_error *err)
{
    const kit_mesh *mesh = &o->scene.mesh;
    const size_t size = ssgi_trace_size(mesh->triangles);
    const char *why = "out of memory";
    o->memory = malloc(size);
    o->position = malloc(9 * mesh->triangles * sizeof(float));
    if (!o->memory || !o->position) return kit_fail(err, "%s", why);
    for (size_t i = 0; i < 9 * mesh->triangles; i += 3)
        for (size_t k = 0; k < 3; ++k) {
            o->position[i + k] = o->to_view[12 + k];
            for (size_t j = 0; j < 3; ++j) o->position[i + k] += o->to_view[4 * j + k] * mesh->position[i + j];
        }
    return ssgi_trace_build(&o->trace, o->memory, size, o->position, 12, NULL, mesh->triangles, &why) == SSGI_OK
             ? 0 : kit_fail(err, "%s", why);
}

int oracle_open(oracle *o, const char *scene, kit_error *err)
{
    float projection[16];
    memset(o, 0, sizeof *o);
    if (kit_scene_load(&o->scene, scene, 0, err)) return -1;
    o->radius = o->scene.radius;
    o->scene.camera.width = ORACLE_WIDTH;
    o->scene.camera.height = ORACLE_HEIGHT;
    if (kit_gbuffer_from_scene(&o->g, &o->scene, &o->scene.camera, NULL, err)) {
        kit_scene_free(&o->scene);
        return -1;
    }
    kit_camera_matrices(&o->g.camera, o->to_view, projection);
    if (!add_pixels(o, err) && !add_trace(o, err)) return 0;
    oracle_close(o);
    return -1;
}

void oracle_close(oracle *o)
{
    free(o->memory);
    free(o->position);
    free(o->pixel);
    kit_gbuffer_free(&o->g);
    kit_scene_free(&o->scene);
}

void oracle_ray(float d[3], uint32_t of, int i, const float n[3])
{
    const float *local = ray_sets + 4 * ((size_t)(of % ORACLE_SETS) * ORACLE_RAYS + (size_t)i);
    /* a frame about n [Duff et al. 2017] */
    const float sign = n[2] < 0 ? -1.0f : 1.0f, k = -1.0f / (sign + n[2]), m = n[0] * n[1] * k;
    const float s[3] = { 1 + sign * n[0] * n[0] * k, sign * m, -sign * n[0] },
                t[3] = { m, sign + n[1] * n[1] * k, -n[1] };
    for (int c = 0; c < 3; ++c) d[c] = local[0] * s[c] + local[1] * t[c] + local[2] * n[c];
}

float oracle_value(const oracle *o, const kit_image *picture, int pixel, const char *channel)
{
    return kit_image_channel(picture, channel)[o->pixel[pixel].y * picture->width + o->pixel[pixel].x];
}

void oracle_row(const char *name, const double *value, const double *truth, const double *none, int count)
{
    double squares = 0, of_none = 0, bias = 0;
    for (int i = 0; i < count; ++i) {
        squares += (value[i] - truth[i]) * (value[i] - truth[i]);
        of_none += (none[i] - truth[i]) * (none[i] - truth[i]);
        bias += (value[i] - truth[i]) / count;
    }
    printf("%-52s %6.3f %+7.3f\n", name, sqrt(squares / of_none), bias);
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int diagnose_surfels(const char *scene, kit_error *err)
{
    static const double size[] = { 0.06, 0.03, 0.015, 0.0075 };
    oracle o;
    if (oracle_open(&o, scene, err)) return -1;
    int failed = 0;
    for (int i = 0; i < 4 && !failed; ++i) failed = surfels_diagnosis(&o, size[i], err);
    oracle_close(&o);
    return failed;
}

static int diagnose_harmonics(const char *text, kit_error *err)
{
    char scene[64], env[256];
    double solid_angle;
    oracle o;
    if (sscanf(text, "%63[^:]:%255[^:]:%lf", scene, env, &solid_angle) != 3 || !(solid_angle >= 0))
        return kit_fail(err, "%s: must be SCENE:ENV:STERADIANS", text);
    if (oracle_open(&o, scene, err)) return -1;
    const int failed = harmonics_diagnosis(&o, env, solid_angle, err);
    oracle_close(&o);
    return failed;
}

int main(int argc, char **argv)
{
    static const struct {
        const char *name;
        int (*diagnose)(const char *text, kit_error *err);
        const char *of[5];
    } all[] = { { "surfels", diagnose_surfels, { "room", "pebbles", "boxes", "colonnade" } },
                { "harmonics", diagnose_harmonics,
                  { "blocks:probe:0", "blocks:probe:0.3", "blocks:probe:1", "room:windows:0", "columns:sky:0" } } };
    kit_error err = { "" };
    int failed = -1;
    kit_fail(&err, "usage: oracle surfels|harmonics [SCENE ..]");
    for (int k = 0; k < 2 && argc > 1; ++k) {
        if (strcmp(argv[1], all[k].name)) continue;
        failed = ssgi_kernel(ray_sets, ORACLE_SETS, ORACLE_RAYS, NULL) != SSGI_OK || kit_gl_open(NULL, &err);
        for (int i = 0; (argc > 2 ? i < argc - 2 : i < 5 && all[k].of[i]) && !failed; ++i)
            failed = all[k].diagnose(argc > 2 ? argv[2 + i] : all[k].of[i], &err);
        kit_gl_close();
    }
    if (failed) fprintf(stderr, "oracle: %s\n", err.text);
    return failed ? 2 : 0;
}
