/* reflection.c - ways to dim reflected light by ambient visibility, on scenes by seed: ssgi_interreflected beside
   path-traced white rooms, ssgi_specular_visibility beside traced glossy lobes.

   Visibility and bent normals are once traced, which shows the formulas' own error, and once drawn by hsao and by
   s3ho's coefficients of 2 bands. The truth is traced at every 22nd pixel both ways, by 128 rays. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/measure/stage.h"

enum { STRIDE = 22, MANY = 128, WIDTH = 1280, HEIGHT = 720, FIRST = 3 };    /* FIRST: the first channel of light */
static const float albedos[] = KIT_REFLECTED_ALBEDOS, roughnesses[] = KIT_REFLECTED_ROUGHNESSES;
enum { ALBEDOS = (int)(sizeof albedos / sizeof *albedos), LOBES = (int)(sizeof roughnesses / sizeof *roughnesses),
       LIGHTS = ALBEDOS + LOBES };

/* One pixel, [0] traced, [1] drawn: visibility; the mirrored direction's cosine to bent normal and to normal. */
typedef struct seen { double visibility[2], bent[2], normal; } seen;
enum { TRACED, DRAWN };

/* Ways to dim a reflection by visibility. NORMAL, BENT: by functions of ssgi.h, about the normal or the bent normal. */
typedef enum manner { NOTHING, PLAIN, STRONG, NORMAL, BENT } manner;
static const struct { const char *name; int by; manner how; } ways[] = {
    { "nothing is dimmed", TRACED, NOTHING },
    { "visibility, traced", TRACED, PLAIN },
    { "the functions of it, about the normal", TRACED, NORMAL },
    { "the functions of it, about the bent normal", TRACED, BENT },
    { "1 - 1.4 (1 - visibility), traced", TRACED, STRONG },
    { "visibility of hsao", DRAWN, PLAIN },
    { "the functions of it, about the normal", DRAWN, NORMAL },
    { "the functions of it, about s3ho's bent normal", DRAWN, BENT }
};
enum { WAYS = (int)(sizeof ways / sizeof *ways) };

static double dimmed(const seen *s, int light, int by, manner how)
{
    const double v = s->visibility[by];
    if (how == NOTHING) return 1;
    if (how == PLAIN) return v;
    if (how == STRONG) return fmax(1 - 1.4 * (1 - v), 0);
    if (light < ALBEDOS) return (double)ssgi_interreflected((float)v, albedos[light]);
    return (double)ssgi_specular_visibility((float)v, (float)(how == BENT ? s->bent[by] : s->normal), (float)s->normal,
                                            roughnesses[light - ALBEDOS]);
}

/* Returns the cosine between the mirrored view direction and the bent normal of bands 0 and 1, in view space. */
static double cosine_to_bent(const kit_camera *camera, const kit_image *frame, const float *coefficient, int x, int y)
{
    const size_t i = (size_t)y * WIDTH + (size_t)x;
    const double n[3] = { (double)kit_image_channel(frame, "N.X")[i], (double)kit_image_channel(frame, "N.Y")[i],
                          (double)kit_image_channel(frame, "N.Z")[i] };
    double bent[3] = { (double)coefficient[3], (double)coefficient[1], (double)coefficient[2] }, ray[3];
    float to_view[16], projection[16], origin[3], toward[3];
    kit_camera_matrices(camera, to_view, projection);
    kit_camera_ray(camera, x, y, origin, toward);
    for (int k = 0; k < 3; ++k) {
        ray[k] = 0;
        for (int c = 0; c < 3; ++c) ray[k] += (double)to_view[4 * c + k] * (double)toward[c];
    }
    if (!kit_unit(bent)) memcpy(bent, n, sizeof bent);
    return kit_dot(ray, bent) - 2 * kit_dot(ray, n) * kit_dot(n, bent);
}

/* Reads the coefficients that s3ho's filter wrote, the bottom row first. */
static int coefficients_of(float *out, stage *s, kit_error *err)
{
    kit_run run;
    kit_image picture;
    int at;
    if (stage_run(&run, s, "s3ho", "indirect=none,filtered=coefficients,store=float,bands=2", s->radius, err))
        return -1;
    for (at = run.passes - 1; at >= 0 && run.pass[at].desc.pass != SSGI_GL_PASS_BLUR;) --at;
    const int failed = stage_settled(&picture, s, &run, 0, 0, err)
                    || (at < 0 ? kit_fail(err, "s3ho: nothing filters it")
                               : kit_texture_read(run.pass[at].target[0], WIDTH, HEIGHT, 4, out)
                                     && kit_fail(err, "s3ho: it cannot be read"));
    if (!failed) kit_image_free(&picture);
    kit_run_close(&run);
    return failed ? -1 : 0;
}

/* Adds the squared errors of a scene by seed to sum[way][light]. */
static int measure(double sum[WAYS][LIGHTS], int seed, kit_error *err)
{
    static float coefficient[4 * WIDTH * HEIGHT];
    char name[64];
    stage s;
    kit_image truth, hsao;
    kit_run run;
    snprintf(name, sizeof name, "random:%d", seed);
    view v = { .name = name, .path = name };
    if (stage_load(&s, &v, err)) return -1;
    v.radius = s.scene.radius;
    if (stage_look(&s, &v, WIDTH, HEIGHT, err) || stage_run(&run, &s, "hsao", "", s.radius, err)
        || stage_settled(&hsao, &s, &run, 0, 0, err))
        return -1;
    kit_run_close(&run);
    if (coefficients_of(coefficient, &s, err)
        || kit_truth_reflected(&truth, &s.scene, &s.gbuffer.camera, s.radius, MANY, STRIDE, err))
        return -1;
    for (int y = STRIDE / 2; y < HEIGHT; y += STRIDE)
        for (int x = STRIDE / 2; x < WIDTH; x += STRIDE) {
            const size_t i = (size_t)y * WIDTH + (size_t)x, pixels = (size_t)WIDTH * HEIGHT;
            if (isnan(truth.data[i])) continue;
            const float *const drawn_there = coefficient + 4 * ((size_t)(HEIGHT - 1 - y) * WIDTH + (size_t)x);
            const seen at = { { (double)truth.data[i], (double)hsao.data[i] },
                              { (double)truth.data[pixels + i],
                                cosine_to_bent(&s.gbuffer.camera, &s.frame, drawn_there, x, y) },
                              (double)truth.data[2 * pixels + i] };
            for (int w = 0; w < WAYS; ++w)
                for (int light = 0; light < LIGHTS; ++light) {
                    const double is = (double)truth.data[(size_t)(FIRST + light) * pixels + i],
                                 off = dimmed(&at, light, ways[w].by, ways[w].how) - is;
                    sum[w][light] += off * off;
                }
        }
    kit_image_free(&truth);
    kit_image_free(&hsao);
    stage_close(&s);
    return 0;
}

/* The command line. */
typedef struct asked { int from, count; } asked;
static const char usage[] = "reflection [--from SEED] [--count SCENES]";
static const kit_option options[] = {
    { .about = "Compares ways to dim reflected light by ambient visibility with path tracing, on scenes by seed. It "
               "prints a table: a row for each way, a column for each albedo of a white room and for each roughness "
               "of a glossy lobe. An error is divided by that of dimming nothing, and is the mean of the scenes." },
    { "--from", "SEED", "The first seed [1000].", .kind = KIT_WHOLE, .at = offsetof(asked, from), .most = 999999 },
    { "--count", "SCENES", "The number of scenes [14].",
      .kind = KIT_WHOLE, .at = offsetof(asked, count), .least = 1, .most = 1000 },
    { NULL }
};

int main(int argc, char **argv)
{
    asked a = { 1000, 14 };
    double share[WAYS][LIGHTS] = { { 0 } };
    kit_error err = { "" };
    if (kit_help(argc, argv, usage, options)) return 0;
    int failed = kit_options(&a, options, argc, argv, NULL, &err) || kit_gl_open(NULL, &err);
    const int from = a.from, count = a.count;
    for (int k = 0; k < count && !failed; ++k) {
        double sum[WAYS][LIGHTS] = { { 0 } };
        failed = measure(sum, from + k, &err);
        for (int w = 0; w < WAYS; ++w)
            for (int light = 0; light < LIGHTS; ++light) share[w][light] += sqrt(sum[w][light] / sum[0][light]) / count;
    }
    if (failed) {
        fprintf(stderr, "reflection: %s\n", err.text);
        return 2;
    }
    printf("| %d scenes from seed %d | room of albedo", count, from);
    for (int k = 0; k < ALBEDOS; ++k) printf(" %.1f |", (double)albedos[k]);
    printf(" lobe of roughness");
    for (int k = 0; k < LOBES; ++k) printf(" %.2f |", (double)roughnesses[k]);
    puts("");
    for (int i = 0; i <= LIGHTS; ++i) printf("|---");
    puts("|");
    for (int w = 0; w < WAYS; ++w) {
        printf("| %s |", ways[w].name);
        for (int light = 0; light < LIGHTS; ++light) printf(" %.3f |", share[w][light]);
        puts("");
    }
    kit_gl_close();
    return 0;
}
