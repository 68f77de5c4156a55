/* test_light.c - ssdo, lights and emitters through the whole of GL: furnace (of s3ho too), closed forms, layers, extra
   cameras, shadows, virtual lights. */
#include "t.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;
#define TRY(call) CHECK(!(call), "%s", err.text)

enum { W = 112, H = 63 };

/* ---- pictures ---------------------------------------------------------------------------------------------------- */




/* Straight down on the origin, up in the picture is -z; orthographic, `high` units from bottom to top. */
static kit_camera from_above(float high)
{
    kit_camera c = { { 0, 1.8f, 0 }, { 0, 0, 0 }, { 0, 0, -1 }, 0, high, 0.1f, 10, W, H, { 0, 0 }, KIT_DEPTH_NORMAL };
    return c;
}





/* ---- furnace ----------------------------------------------------------------------------------------------------- */

/* Makes every surface of a run send 1 from now on: copies of its emitters, with that radiance, in place of them. */
static int shine(kit_run *run)
{
    const ssgi_gl_desc *d = NULL;                                              /* of the last gather */
    for (int i = 0; i < run->passes; ++i)
        if (run->pass[i].desc.pass == SSGI_GL_PASS_SSDO || run->pass[i].desc.pass == SSGI_GL_PASS_S3HO)
            d = &run->pass[i].desc;
    const struct { const char *array; int width, height, slices;
    } held[2] = { { "t_ssgi_emitters", run->gbuffer->viewport[2], run->gbuffer->viewport[3],
                    d->gather.layers ? d->gather.layers : 1 },
                  { "t_ssgi_view_emitters", run->view[0].width, run->view[0].height,
                    d->gather.views * d->gather.view_layers } };
    const uint32_t one = 256u | 256u << 9 | 256u << 18 | 16u << 27;            /* 256 * 2^-8, three times */
    kit_run_update(run);
    kit_run_draw(run, 0);
    for (int k = 0; k < 2; ++k) {
        const size_t texels = (size_t)held[k].width * (size_t)held[k].height;
        uint32_t *word = malloc(2 * texels * (size_t)held[k].slices * sizeof *word + 1);
        for (int s = 0; s < held[k].slices; ++s)
            if (!CHECK(!kit_texture_slice_read(kit_run_input(run, held[k].array, 0), s, held[k].width,
                                               held[k].height, 2, (float *)(word + 2 * texels * (size_t)s)),
                       "emitters cannot be read"))
                return 0;
        for (size_t i = 0; i < texels * (size_t)held[k].slices; ++i) word[2 * i] = one;
        if (held[k].slices)
            kit_run_input(run, held[k].array, run->texture[run->textures++] = kit_texture_array(
                held[k].width, held[k].height, held[k].slices, GL_RG32UI, (float *)word));
        free(word);
    }
    return 1;
}

static void furnace(void)
{
    enum { SMALL_W = 72, SMALL_H = 40 };
    enum {
        EXACT,
        ONE_SIDED /* no more */,
        TWICE /* two gathers, whose depths are rounded apart: all but a sample in 10,000 */,
        HALVES,
        KINDS
    };
    static const struct { const char *method, *scene, *set; int kind;
    } row[] = { { "ssdo-points", "room", "reuse=1,two_sided=1", EXACT },
                { "ssdo-points", "room", "reuse=1,two_sided=1,environment=sh", EXACT },
                { "ssdo-points", "room", "reuse=1,two_sided=1,fade=smooth,steps=2", EXACT },
                { "ssdo-points", "room", "reuse=1,two_sided=1,uniform=1,sets=16,noise=texture", EXACT },
                { "ssdo-points", "columns", "reuse=1,two_sided=1,layers=2,views=2,view_size=64", EXACT },
                { "ssdo-points", "columns",
                  "reuse=1,two_sided=1,layers=3,views=2,view_size=64,view_layers=2,thickness=solid", EXACT },
                { "ssdo-points", "room", "reuse=1,two_sided=0", ONE_SIDED },
                { "ssdo-points", "columns", "reuse=1,two_sided=0,layers=2,views=2,view_size=64", ONE_SIDED },
                { "ssdo-points", "room", "two_sided=1", TWICE },
                { "ssdo-points", "columns", "two_sided=1,layers=2,views=2,view_size=64", TWICE },
                { "s3ho-points", "room", "two_sided=1,bands=1", EXACT },
                { "s3ho-points", "room", "two_sided=1,bands=2", EXACT },
                { "s3ho-points", "room", "two_sided=1,bands=2,uniform=1", EXACT },
                { "s3ho-points", "columns", "two_sided=1,bands=3,fade=lambda,lambda=1,range=1,steps=2", EXACT },
                { "s3ho-points", "columns", "two_sided=1,layers=2,views=2,view_size=64", EXACT },
                { "s3ho-points", "room", "two_sided=0", ONE_SIDED },
                { "s3ho-points", "room", "two_sided=1,indirect=apart", TWICE },
                { "s3ho-points", "columns", "two_sided=1,indirect=apart,layers=2,views=2,view_size=64", TWICE },
                { "s3ho-points", "room", "two_sided=1,filtered=coefficients", HALVES },
                { "s3ho-points", "columns", "two_sided=1,filtered=coefficients,bands=3,blur=1", HALVES },
                { "ssdo", "room", "reuse=1,two_sided=1", EXACT },
                { "ssdo", "room", "reuse=1,two_sided=1,environment=sh,directions=3,falloff=square", EXACT },
                { "ssdo", "columns", "reuse=1,two_sided=1,thickness=back", EXACT },
                { "ssdo", "columns", "reuse=1,two_sided=1,thickness=slabs", ONE_SIDED },
                { "ssdo", "room", "reuse=1,two_sided=0", ONE_SIDED },
                { "ssdo", "room", "reuse=1,two_sided=1,half=1,blur=1,filter_normals=1", EXACT },
                { "s3ho", "room", "two_sided=1,bands=1", EXACT },
                { "s3ho", "columns", "two_sided=1,bands=2,thickness=solid", EXACT },
                { "s3ho", "room", "two_sided=1,bands=3,thickness=back", EXACT },
                { "s3ho", "room", "two_sided=1", EXACT },
                { "s3ho", "columns", "two_sided=0", ONE_SIDED },
                { "s3ho", "room", "two_sided=1,filtered=coefficients,bands=3,half=1,blur=1", HALVES } };
    static const float uniform[3] = { 3.5449077f, 3.5449077f, 3.5449077f };
    static const int allowed[KINDS] = { 0, SMALL_W * SMALL_H, 33 * SMALL_W * SMALL_H / 10000, 0 };
    double worst[KINDS] = { 0 };
    kit_lighting l;
    if (!lighten(&l, NULL, NULL) || !TRY(kit_image_new(&l.env, 32, 16, "R,G,B", &err))) return;
    for (int i = 0; i < 3 * 32 * 16; ++i) l.env.data[i] = 1;
    for (int i = 0; i < (int)(sizeof row / sizeof row[0]); ++i) {
        double least = 2, most = 0;
        const int kind = row[i].kind;
        const double within = kind == HALVES ? 2e-3 : 1e-5;
        int off = 0;
        kit_scene scene;
        kit_gbuffer g;
        kit_run run;
        kit_image out;
        if (!see(&scene, &g, row[i].scene, NULL, 0, NULL, SMALL_W, SMALL_H)
            || !begin(&run, &g, row[i].method, row[i].set, scene.radius, &scene, &l))
            return;
        /* the picture's have a few 1e-6 in higher bands */
        ssgi_gl_harmonics_set(&run.frame, uniform, 1, NULL, NULL);
        if (!shine(&run) || !drawn(&out, &run)) return;
        const float *light = kit_image_channel(&out, "irradiance.G"), *bounce = kit_image_channel(&out, "bounce.G");
        for (int k = 0; k < SMALL_W * SMALL_H; ++k) {
            const double v = (double)light[k] + (double)bounce[k];
            least = fmin(least, v);
            most = fmax(most, v);
            off += fabs(v - 1) > within;
        }
        CHECK(mean(&out, "bounce.G") > 0.02 && off <= allowed[kind] && most <= 1 + within + (kind == TWICE ? 0.125 : 0)
                  && (kind == ONE_SIDED) == (least < 0.9),
              "%s %s %s: %.6f to %.6f, %d pixels off", row[i].method, row[i].scene, row[i].set, least, most, off);
        worst[kind] = fmax(worst[kind], kind == TWICE ? off : fmax(most - 1, 1 - least));
        kit_run_close(&run); kit_image_free(&out); kit_gbuffer_free(&g); kit_scene_free(&scene);
    }
    t_note("one gather: %.1e off at most, with halves %.1e; two: %g pixels are", worst[EXACT], worst[HALVES],
           worst[TWICE]);
    kit_image_free(&l.env);
}

/* In uniform light a white corner sends as much as comes in, bounce after bounce; one bounce leaves some out. */
static void further_bounces(void)
{
    static const char *const sets[2] = { "reuse=1,two_sided=1", "reuse=1,two_sided=1,bounced=1" };
    double plane[2][4], least[2] = { 2, 2 }, most = 0;
    const kit_camera camera = corner_planes(plane, 0.3, 0);
    kit_lighting l;
    kit_image frame;
    kit_gbuffer g;
    if (!lighten(&l, NULL, NULL) || !TRY(kit_image_new(&l.env, 32, 16, "R,G,B", &err))
        || !planes_seen(&frame, &camera, (const double (*)[4])plane, 2, ",albedo.R,albedo.G,albedo.B"))
        return;
    for (int i = 0; i < 3 * 32 * 16; ++i) l.env.data[i] = 1;
    const size_t pixels = (size_t)frame.width * (size_t)frame.height;
    for (size_t i = 0; i < 3 * pixels; ++i) frame.data[4 * pixels + i] = 1;
    if (!TRY(kit_gbuffer_from_frame(&g, &frame, &camera, &err))) return;
    for (int k = 0; k < 2; ++k) {
        kit_image out;
        kit_run run;
        if (!begin(&run, &g, "ssdo", sets[k], 1, NULL, &l)) return;
        if (!drawn(&out, &run)) return;
        for (size_t i = 0; i < pixels; ++i) {
            const double v = (double)kit_image_channel(&out, "irradiance.G")[i]
                           + (double)kit_image_channel(&out, "bounce.G")[i];
            if (!(kit_image_channel(&frame, "Z")[i] > 0)) continue;
            least[k] = fmin(least[k], v);
            if (k) most = fmax(most, v);
        }
        kit_run_close(&run);
        kit_image_free(&out);
    }
    CHECK(least[0] < 0.9 && least[1] > 0.99 && most < 1.01, "one bounce leaves %.4f, further ones %.4f to %.4f",
          least[0], least[1], most);
    t_note("one bounce leaves %.4f, further ones %.4f to %.4f", least[0], least[1], most);
    kit_gbuffer_free(&g);
    kit_image_free(&frame);
    kit_image_free(&l.env);
}

/* ---- open planes ------------------------------------------------------------------------------------------------- */

/* ---- the corner -------------------------------------------------------------------------------------------------- */

static double square_corner(double c)
{
    const double s = sqrt(1 - c * c);
    return (acos(c) - 3 * c * s + 2 * c * c * acos(c)) / pi;
}
static double several_corner(double c, int k)
{
    return k * linear_corner(c) - (k - 1) * (k > 1 ? linear_corner(fmin(1, k * c / (k - 1))) : 0);
}

static const double at[3] = { 0.1, 0.25, 0.5 };

/* The corner's picture, and its camera. wall: what the wall sends; the floor is dark. */
static int corner(kit_gbuffer *g, double c, float wall)
{
    double plane[2][4];
    const kit_camera camera = corner_planes(plane, c, 0);
    const size_t pixels = (size_t)WIDE * HIGH;
    kit_image frame;
    int ok = planes_seen(&frame, &camera, (const double (*)[4])plane, 2, ",direct.R,direct.G,direct.B");
    for (size_t i = 0; ok && i < 3 * pixels; ++i)
        frame.data[4 * pixels + i] = frame.data[2 * pixels + i % pixels] < 0 ? wall : 0;
    ok = ok && TRY(kit_gbuffer_from_frame(g, &frame, &camera, &err));
    kit_image_free(&frame);
    return ok;
}

static void corner_darkens(void)
{
    static const struct {
        const char *set;
        double (*truth)(double);
        int steps;
    } row[] = { { "falloff=linear", linear_corner, 1 },
                { "falloff=square", square_corner, 1 },
                { "steps=2", NULL, 2 },
                { "steps=4", NULL, 4 },
                { "uniform=1", linear_corner, 1 },
                { "uniform=1,environment=sh", linear_corner, 1 },
                { "falloff=linear,environment=sh", linear_corner, 1 } };
    double worst = 0;
    kit_gbuffer g[3];
    kit_lighting l;
    if (!lighten(&l, "white", NULL)) return;
    for (int i = 0; i < 3; ++i) if (!corner(&g[i], at[i], 0)) return;
    for (int m = 0; m < (int)(sizeof row / sizeof row[0]); ++m) {
        kit_run run;
        char set[96];
        snprintf(set, sizeof set, "bounce=none,samples=64,thickness=solid,%s", row[m].set);
        if (!begin(&run, &g[0], "ssdo-points", set, 1, NULL, &l)) return;
        for (int i = 0; i < 3; ++i) {
            const double o = 1 - row_of(&run, &g[i], row_at(at[i]), 8),
                         truth = row[m].truth ? row[m].truth(at[i]) : several_corner(at[i], row[m].steps);
            worst = fmax(worst, fabs(o - truth));
            CHECK(fabs(o - truth) <= 0.003, "%s, c %g: %.4f is dark, truth %.4f", row[m].set, at[i], o, truth);
        }
        kit_run_close(&run);
    }
    t_note("%.4f off at most", worst);
    for (int i = 0; i < 3; ++i) kit_gbuffer_free(&g[i]);
    kit_image_free(&l.env);
}

/* A ridge under the lamps of a street: nothing is occluded, and light differs across the edge. Default filters leave it
   as it is; the filter that smooths light does not. */
static void creases_stay(void)
{
    static const struct { const char *method, *set; double most, least;
    } row[] = { { "ssdo", "", 0.003, 0 },
                { "ssdo", "environment=sh,", 0.003, 0 },
                { "ssdo-best", "", 0.003, 0 },
                { "ssdo-points", "half=1,", 0.003, 0 },
                { "ssdo", "thickness=slabs,restore=difference,", 0.003, 0 },
                { "ssdo", "restore=none,", 1, 0.005 },
                { "s3ho", "residual=1,", 0.003, 0 },
                { "s3ho", "residual=1,bands=2,indirect=joint,", 0.003, 0 },
                { "s3ho", "residual=1,bands=1,store=packed,lights=harmonics,", 0.003, 0 },
                { "s3ho", "residual=1,restore=none,", 1, 0.005 },
                { "ssbn", "", 0.003, 0 },
                { "ssbn", "cone=normal,", 0.003, 0 } };
    const kit_camera c = looking_along_z(97, 55, 0);
    const double side[2][1][4] = { { { 0.6, 0.1, 0.79372539, -1.5 } }, { { -0.6, 0.1, 0.79372539, -1.5 } } };
    kit_image frame, other;
    kit_gbuffer g;
    kit_lighting l;
    static const char slabs[] = ",back.Z,front2.Z,back2.Z";
    if (!lighten(&l, "street", "point:0.5,1,1,2,1,1") || !planes_seen(&frame, &c, side[0], 1, slabs)
        || !planes_seen(&other, &c, side[1], 1, slabs))
        return;
    const size_t pixels = 97 * 55;
    for (size_t i = 0; i < pixels; ++i)             /* the farther of the two */
        for (size_t k = 4; other.data[i] > frame.data[i] && k > 0; --k)
            frame.data[(k - 1) * pixels + i] = other.data[(k - 1) * pixels + i];
    if (!TRY(kit_gbuffer_from_frame(&g, &frame, &c, &err))) return;
    for (int m = 0; m < (int)(sizeof row / sizeof row[0]); ++m) {
        const int map = row[m].method[3] == 'o' && row[m].method[1] == 's', lamp = strstr(row[m].set, "lights") != NULL;
        const kit_lighting sky = { .env = l.env, .lights = lamp, .light = { l.light[0] } };
        double sum = 0, square = 0;
        char set[128], bare[128];
        kit_image out, open;
        snprintf(set, sizeof set, "blur=1,half=1,steps=4,%s%s", row[m].set, map ? "bounce=none" : "phase=0");
        snprintf(bare, sizeof bare, "%s%s,blur=0,half=0,restore=none", row[m].set, map ? "bounce=none" : "phase=0");
        if (!strcmp(row[m].method, "ssdo-best")) memcpy(strstr(set, "half=1"), "half=0", 6);
        if (!lit(&out, &g, row[m].method, set, 0.1f, NULL, &sky)
            || !lit(&open, &g, row[m].method, bare, 1e-6f, NULL, &sky))
            return;
        for (size_t i = 3 * pixels; i < 6 * pixels; ++i) {
            const double off = (double)out.data[i] - (double)open.data[i];
            sum += (double)open.data[i];
            square += off * off;
        }
        const double rms = sqrt(square * 3 * (double)pixels) / sum;
        CHECK(sum > 0 && rms <= row[m].most && rms >= row[m].least, "%s %s: %.4f of the mean", row[m].method, set, rms);
        t_note("%s %s: %.5f of the mean", row[m].method, row[m].set, rms);
        kit_image_free(&out);
        kit_image_free(&open);
    }
    kit_gbuffer_free(&g);
    kit_image_free(&frame);
    kit_image_free(&other);
    kit_image_free(&l.env);
}

/* Light that grows toward the wall of the corner, or away from it, and across: what slices block of it is what
   directions there bring. The corner upside down has the wall on the slices' other side. */
static void slices_know_directions(void)
{
    static const struct {
        const char *method, *set;
    } row[] = { { "ssdo", "bounce=none,environment=sh,bands=2" },
                { "s3ho", "indirect=none,bands=2" },
                { "s3ho", "indirect=none,bands=4,thickness=solid" } };
    const double r = sqrt(0.5), c = 0.25;
    double worst = 0;
    kit_lighting l;
    kit_gbuffer g[2];
    if (!lighten(&l, "white", NULL)) return;
    for (int down = 0; down < 2; ++down) {
        double plane[2][4];
        const kit_camera camera = corner_planes(plane, c, 0);
        kit_image frame;
        for (int i = 0; i < 2 && down; ++i) plane[i][1] = -plane[i][1];
        if (!planes_seen(&frame, &camera, (const double(*)[4])plane, 2, "")
            || !TRY(kit_gbuffer_from_frame(&g[down], &frame, &camera, &err)))
            return;
        kit_image_free(&frame);
    }
    for (int m = 0; m < (int)(sizeof row / sizeof row[0]); ++m) {
        kit_run run;
        char set[128];
        snprintf(set, sizeof set, "directions=2,%s", row[m].set);
        if (!begin(&run, &g[0], row[m].method, set, 1, NULL, &l)) return;
        for (int k = 0; k < 4; ++k) {
            enum { N = 400 };
            const int down = k & 1, toward = k & 2 ? 1 : -1;
            /* in view space; the wall is at (0, r, -r) */
            const double sign = down ? -1 : 1, b[3] = { 0.3, toward * 0.6 * sign * r, -toward * 0.6 * r };
            float coefficients[48] = { 0 };
            double want = 0;
            for (int i = 0; i < 3; ++i) {
                coefficients[i] = 3.5449077f;
                for (int j = 0; j < 3; ++j) coefficients[3 * (1 + j) + i] = (float)(b[(j + 1) % 3] / 0.48860251);
            }
            for (int i = 0; i < N * N; ++i) {            /* directions by the cosine about the floor's normal */
                const double up = sqrt((i / N + 0.5) / N), a = 6.283185307179586 * (i % N + 0.5) / N,
                             side = sqrt(1 - up * up) * cos(a), wall = sqrt(1 - up * up) * sin(a);
                const double d[3] = { side, sign * (up * r + wall * r), up * r - wall * r },
                             t = wall > 0 ? c / wall : 2;
                want += (1 + b[0] * d[0] + b[1] * d[1] + b[2] * d[2]) * fmin(t, 1) / (N * N);
            }
            ssgi_gl_harmonics_set(&run.frame, coefficients, 2, NULL, NULL);
            const double got = row_of(&run, &g[down], down ? HIGH - 1 - row_at(c) : row_at(c), 16);
            worst = fmax(worst, fabs(got - want));
            CHECK(fabs(got - want) < 0.006, "%s %s, light %s the wall, %s: %.4f, truth %.4f", row[m].method, set,
                  toward > 0 ? "toward" : "off", down ? "down" : "up", got, want);
        }
        kit_run_close(&run);
    }
    for (int i = 0; i < 2; ++i) kit_gbuffer_free(&g[i]);
    t_note("%.4f off at most", worst);
    kit_image_free(&l.env);
}

/* Harmonics carry the light of --env and --light alone. */
static void harmonics_refuse_direct(void)
{
    static const char *const set[3] = { "", "indirect=apart", "indirect=none" };
    const kit_lighting dark = { .lights = 0 };
    const kit_world world = { NULL, &dark };
    kit_gbuffer g;
    if (!corner(&g, 0.25, 1)) return;
    for (int k = 0; k < 3; ++k) {
        kit_method m;
        kit_run run;
        TRY(kit_method_find(&m, "s3ho", &err) || kit_method_set(&m, set[k], &err));
        const int failed = kit_run_open(&run, &g, &m, 1, &world, &err);
        CHECK(k < 2 ? failed && strstr(err.text, "direct.R") && strstr(err.text, "indirect=none") : !failed,
              "s3ho %s: \"%s\"", set[k], err.text);
        if (!failed) kit_run_close(&run);
    }
    kit_gbuffer_free(&g);
}

static void corner_bounces(void)
{
    static const struct { const char *set; double truth[3], off;
    } row[] = {
        /* Of a wall that sends 1; patches as the paper has them, but never clamped. off: of the value, for areas are
           meant for uniform directions, of which ours, at midpoints of strata, miss some near the horizon: 1/sqrt(N) a
           third. */
        { "bounce=solid-angle,samples=16", { 0.309233, 0.168214, 0.051965 }, 0.01 },
        { "bounce=patch,distance_clamp=0,samples=64", { 0.5523, 0.19207, 0.050944 }, 0.05 },
        { "bounce=patch,distance_clamp=0,samples=16", { 0.5523, 0.19207, 0.050944 }, 0.1 },
        { "bounce=patch,distance_clamp=0,samples=16,uniform=1,sets=16", { 0.5523, 0.19207, 0.050944 }, 0.06 },
        { "bounce=solid-angle,samples=16,uniform=1", { 0.309233, 0.168214, 0.051965 }, 0.02 },
        { "directions=8", { 0.309233, 0.168214, 0.051965 }, 0.02 }
    };
    kit_gbuffer g[3];
    const kit_lighting dark = { .lights = 0 };
    for (int i = 0; i < 3; ++i) if (!corner(&g[i], at[i], 1)) return;
    for (int m = 0; m < (int)(sizeof row / sizeof row[0]); ++m) {
        kit_run run;
        char set[96];
        double found[3];
        snprintf(set, sizeof set, "thickness=solid,%s", row[m].set);
        if (!begin(&run, &g[0], strstr(row[m].set, "samples") ? "ssdo-points" : "ssdo", set, 1, NULL, &dark)) return;
        for (int i = 0; i < 3; ++i) {
            found[i] = row_of(&run, &g[i], row_at(at[i]), 64);
            CHECK(fabs(found[i] - row[m].truth[i]) <= row[m].off * row[m].truth[i], "%s, c %g: %.4f, expected %.4f",
                  row[m].set, at[i], found[i], row[m].truth[i]);
        }
        t_note("%s: %.4f %.4f %.4f", row[m].set, found[0], found[1], found[2]);
        if (run.kernel) {                           /* a kernel of your own, with a direction along the horizon */
            static const float level[4] = { 0.6f, 0.8f, 0, 0.5f };
            glBindTexture(GL_TEXTURE_2D, run.kernel);
            glTexSubImage2D(GL_TEXTURE_2D, 0, 3, 0, 1, 1, GL_RGBA, GL_FLOAT, level);
            const double is = row_of(&run, &g[1], row_at(at[1]), 64);
            CHECK(fabs(is - found[1]) < 0.01 * found[1], "%s, a level direction: %.4f, without it %.4f", row[m].set,
                  is, found[1]);
        }
        kit_run_close(&run);
    }
    for (int i = 0; i < 3; ++i) kit_gbuffer_free(&g[i]);
}

/* ---- layers ------------------------------------------------------------------------------------------------------ */


static void layers_count(void)
{
    static const struct {
        double c, thickness;
        int layers, ends;
    } row[] = { { 0.1, 0.05, 2, 0 }, { 0.1, 0.25, 2, 0 }, { 0.25, 0.1, 2, 0 }, { 0.5, 0.25, 2, 0 },
                { 0.1, 0.05, 1, 0 }, { 0.25, 0.1, 3, 0 }, { 0.25, 0.1, 3, 1 }, { 0.25, 0.1, 1, 1 } };
    const double gap = 0.15, reach = 0.2;                          /* of what has no back, across */
    kit_lighting l;
    double worst = 0;
    if (!lighten(&l, "white", NULL)) return;
    for (int m = 0; m < (int)(sizeof row / sizeof row[0]); ++m) {
        const double c = row[m].c, back = c + row[m].thickness, next = back + gap;
        const double truth =
            linear_corner(c)
            - (row[m].layers > 1 ? linear_corner(back)
               : row[m].ends     ? linear_corner(c + reach)
                                 : 0)
            + (row[m].layers > 2 ? linear_corner(next) - (row[m].ends ? linear_corner(next + reach) : 0) : 0);
        kit_gbuffer g;
        kit_run run;
        char set[96];
        snprintf(set, sizeof set, "bounce=none,samples=64,layers=%d,thickness=%s,thickness_limit=%.6f", row[m].layers,
                 row[m].ends ? "constant" : "solid", reach * sqrt(2));
        if (!slab(&g, c, row[m].thickness, gap, row[m].layers) || !begin(&run, &g, "ssdo-points", set, 1, NULL, &l))
            return;
        const double o = 1 - row_of(&run, &g, row_at(c), 8), noise = 5 * sqrt(truth * (1 - truth) / (64 * 8 * COLUMNS));
        worst = fmax(worst, fabs(o - truth));
        CHECK(fabs(o - truth) <= fmin(noise, 0.003), "ends %d, %d layers, %g thick at %g: %.4f is dark, truth %.4f",
              row[m].ends, row[m].layers, row[m].thickness, c, o, truth);
        kit_run_close(&run);
        kit_gbuffer_free(&g);
    }
    t_note("%.4f off at most", worst);
    kit_image_free(&l.env);
}

/* ---- extra cameras ----------------------------------------------------------------------------------------------- */

/* A wall beside the picture, and a plate afloat whose underside the picture does not see, by which points below it seem
   to be blocked. */
static void cameras_know_more(void)
{
    static const box beside = { { -3, 0, -1.2f }, { 3, 0.8f, -0.56f } },
                     plate = { { -0.25f, 0.2f, -0.15f }, { 0.25f, 0.55f, 0.15f } };
    static const struct {
        const char *what;
        const box *added;
        float radius;
    } row[] = { { "wall beside", &beside, 0.4f }, { "plate afloat", &plate, 0.3f } };
    const kit_camera above = from_above(1);
    kit_lighting l;
    if (!lighten(&l, "white", NULL)) return;
    for (int m = 0; m < 2; ++m) {
        kit_scene scene;
        kit_gbuffer g;
        kit_image blind, knowing, truth;
        double error[2] = { 0 }, bias[2] = { 0 };
        int n = 0;
        if (!see(&scene, &g, "plane", row[m].added, 1, &above, W, H)) return;
        if (!lit(&blind, &g, "ssdo-points", "bounce=none,thickness=solid", row[m].radius, &scene, &l)
            || !lit(&knowing, &g, "ssdo-points", "bounce=none,thickness=solid,views=3,view_layers=2", row[m].radius,
                    &scene, &l)
            || !TRY(kit_truth_ao(&truth, &scene, &scene.camera, row[m].radius, KIT_ATTENUATION_LINEAR, 64, 1, &err)))
            return;
        const float *a = kit_image_channel(&blind, "irradiance.G"), *b = kit_image_channel(&knowing, "irradiance.G");
        for (int i = 0; i < W * H; ++i) {
            if (fabsf(a[i] - truth.data[i]) < 0.1f) continue;             /* where the picture alone is wrong */
            for (int k = 0; k < 2; ++k) {
                const double d = (double)(k ? b : a)[i] - (double)truth.data[i];
                bias[k] += d;
                error[k] += fabs(d);
            }
            ++n;
        }
        CHECK(n > 500 && fabs(bias[1]) < 0.2 * fabs(bias[0]) && error[1] < 0.35 * error[0],
              "%s: wrong by %.3f with extra cameras, %.3f without, at %d pixels", row[m].what, bias[1] / n, bias[0] / n,
              n);
        t_note("%s: off by %+.3f with extra cameras, %+.3f without, at %d pixels; |error| %.3f, %.3f", row[m].what,
               bias[1] / n, bias[0] / n, n, error[1] / n, error[0] / n);
        kit_image_free(&blind);
        kit_image_free(&knowing);
        kit_image_free(&truth);
        kit_gbuffer_free(&g);
        kit_scene_free(&scene);
    }
    kit_image_free(&l.env);
}

/* ---- lights ------------------------------------------------------------------------------------------------------ */

/* The floor y = 0, a wall from z = -1 to -1.1; a light before it and one behind, both nearer than the radius; the floor
   before the wall is looked at. */
static void segments_end_at_lights(void)
{
    static const box wall = { { -3, 0, -1.1f }, { 3, 1.5f, -1 } };
    static const struct { const char *light, *set; double z; int shadowed; } row[] = {
        { "point:0,0.3,-0.6,2,2,2", "solid=1", -0.6, 0 }, { "point:0,0.3,-0.6,2,2,2", "solid=0", -0.6, 0 },
        { "point:0,0.3,-1.6,2,2,2", "solid=1", -1.6, 1 }, { "point:0,0.3,-1.6,2,2,2", "solid=0", -1.6, 1 } };
    const kit_camera camera = { { 0, 3, 2 }, { 0, 0.2f, -0.6f }, { 0, 1, 0 },     40, 0, 0.1f, 20, W,
                                H,           { 0, 0 },           KIT_DEPTH_NORMAL };
    kit_scene scene;
    kit_gbuffer g;
    if (!see(&scene, &g, "plane", &wall, 1, &camera, W, H)) return;
    for (int m = 0; m < 4; ++m) {
        kit_image out;
        kit_lighting l;
        char set[96];
        double worst = 0;
        int n = 0, dark = 0;
        snprintf(set, sizeof set, "bounce=none,shadows=segment,points=32,%s", row[m].set);
        if (!lighten(&l, NULL, row[m].light) || !lit(&out, &g, "ssdo-points", set, 2, NULL, &l)) return;
        for (int i = 0; i < W * H; ++i) {
            float o[3], d[3];
            kit_camera_ray(&scene.camera, i % W, i / W, o, d);
            const double t = -(double)o[1] / (double)d[1], x = (double)o[0] + t * (double)d[0],
                         z = (double)o[2] + t * (double)d[2];
            if (fabs(x) > 0.5 || z < -0.5 || z > 0.3) continue;
            const double dd = x * x + 0.3 * 0.3 + (z - row[m].z) * (z - row[m].z),
                         open = 2 * 0.3 / (dd * sqrt(dd)) / pi, v = (double)out.data[3 * W * H + i];
            worst = fmax(worst, fabs(v / open - 1));
            dark += v <= 0;
            ++n;
        }
        CHECK(n > 300 && (row[m].shadowed ? dark == n : worst < 1e-3), "%s, %s: %d of %d pixels are dark, off by %.2e",
              row[m].light, row[m].set, dark, n, worst);
        kit_image_free(&out);
    }
    kit_gbuffer_free(&g); kit_scene_free(&scene);
}

/* A plate seen from its upper side only: the floor under it sees the other one. */
static void backs_are_dark(void)
{
    static const box plate = { { -0.5f, 0.2f, -0.3f }, { 0.5f, 0.22f, 0.3f } };
    const kit_camera above = from_above(1);
    const kit_lighting dark = { .lights = 0 };
    kit_scene scene;
    kit_gbuffer g, shining;
    kit_image frame, full, out;
    double sum[2] = { 0 };
    if (!see(&scene, &g, "plane", &plate, 1, &above, W, H) || !TRY(kit_gbuffer_read(&frame, &g, &err))
        || !TRY(
            kit_image_new(&full, W, H, "Z,N.X,N.Y,N.Z,albedo.R,albedo.G,albedo.B,direct.R,direct.G,direct.B", &err)))
        return;
    memcpy(full.data, frame.data, 7 * W * H * sizeof(float));
    for (int i = 0; i < 3 * W * H; ++i) full.data[7 * W * H + i] = 1;
    if (!TRY(kit_gbuffer_from_frame(&shining, &full, &above, &err))) return;
    for (int both = 0; both < 2; ++both) {
        if (!lit(&out, &shining, "ssdo-points", both ? "thickness=solid,two_sided=1" : "thickness=solid,two_sided=0",
                 0.4f, NULL, &dark))
            return;
        sum[both] = mean(&out, "bounce.G");
        kit_image_free(&out);
    }
    CHECK(sum[0] == 0 && sum[1] > 0.03, "a back sends %.5f when emitters are one-sided, %.5f when they are two-sided",
          sum[0], sum[1]);
    t_note("one-sided %.5f, two-sided %.5f", sum[0], sum[1]);
    kit_image_free(&frame);
    kit_image_free(&full);
    kit_gbuffer_free(&g);
    kit_gbuffer_free(&shining);
    kit_scene_free(&scene);
}

/* One pixel of a shining plane turned to look along it, as slivers at thin edges are: all emitters are edge-on,
   whatever the rounding of their normals. */
static void edge_on_is_dark(void)
{
    const kit_lighting dark = { .lights = 0 };
    double worst = 0;
    for (int k = 0; k < 12; ++k) {
        const double a = (30 + 4.3 * k) * pi / 180, b = 1 + 0.7 * k,
                     n[1][4] = { { sin(a) * cos(b), sin(a) * sin(b), cos(a), -cos(a) } };
        const kit_camera c = looking_along_z(81, 45, 0);
        const int middle = 22 * 81 + 40;
        kit_image frame, out;
        kit_gbuffer g;
        if (!planes_seen(&frame, &c, n, 1, ",direct.R,direct.G,direct.B")) return;
        for (int i = 0; i < 3 * 81 * 45; ++i) kit_image_channel(&frame, "direct.R")[i] = 1;
        kit_image_channel(&frame, "N.X")[middle] = (float)(-cos(a) * cos(b));
        kit_image_channel(&frame, "N.Y")[middle] = (float)(-cos(a) * sin(b));
        kit_image_channel(&frame, "N.Z")[middle] = (float)sin(a);
        if (!TRY(kit_gbuffer_from_frame(&g, &frame, &c, &err)) || !lit(&out, &g, "ssdo", "", 0.3f, NULL, &dark)) return;
        worst = fmax(worst, (double)kit_image_channel(&out, "bounce.G")[middle]);
        kit_image_free(&frame); kit_image_free(&out); kit_gbuffer_free(&g);
    }
    CHECK(worst < 0.01, "a receiver in the plane of its emitters gets %.3f", worst);
}

/* ---- units ------------------------------------------------------------------------------------------------------- */

/* ---- shadow maps ------------------------------------------------------------------------------------------------- */

/* A sun that shines down -z on a plane whose normal stands this far from it, half to the right and half up: its slope
   runs along the map's texels' diagonal. */
static void planes_do_not_shadow_themselves(void)
{
    static const double tilts[] = { 60, 70, 80 };
    kit_lighting l;
    int wrong = 0, seen = 0;
    if (!lighten(&l, NULL, "sun:0,0,1,3,3,3")) return;
    for (int k = 0; k < 6; ++k) {
        const double tilt = tilts[k % 3] * pi / 180, r = sqrt(0.5);
        const double n[3] = { r * sin(tilt), r * sin(tilt), cos(tilt) }, u[3] = { r, -r, 0 },
                     v[3] = { r * cos(tilt), r * cos(tilt), -sin(tilt) };
        kit_scene scene;
        kit_gbuffer g;
        kit_image out;
        if (!TRY(kit_scene_load(&scene, "plane", 0, &err))) return;
        for (size_t i = 0; i < 3 * scene.mesh.triangles; ++i) {     /* y = 0 becomes the plane */
            float *p = scene.mesh.position + 3 * i, *m = scene.mesh.normal + 3 * i;
            const double x = (double)p[0], z = (double)p[2];
            for (int j = 0; j < 3; ++j) { p[j] = (float)(0.02 * (x * u[j] + z * v[j])); m[j] = (float)n[j]; }
        }
        for (int j = 0; j < 3; ++j) {
            scene.mesh.lower[j] = -2; scene.mesh.upper[j] = 2;
            scene.camera.eye[j] = (float)(2 * n[j] + 0.5 * u[j]);
            scene.camera.target[j] = 0;
        }
        scene.camera.width = W; scene.camera.height = H;
        if (!TRY(kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err))
            || !lit(&out, &g, "ssdo-points",
                    k < 3 ? "bounce=none,shadows=map,shadow_size=256" : "bounce=none,shadows=fill,shadow_size=256",
                    0.2f, &scene, &l))
            return;
        for (int i = 0; i < W * H; ++i) {
            const double light = (double)out.data[3 * W * H + i];
            seen += light > 0;
            wrong += !(fabs(light - 3 * cos(tilt) / pi) < 1e-4);
        }
        kit_image_free(&out); kit_gbuffer_free(&g); kit_scene_free(&scene);
    }
    CHECK(!wrong && seen > 3 * W * H, "%d pixels of a bare plane, of %d, are in shadow or wrong", wrong, seen);
}

/* How far every pixel's surface is from what first stands between it and a sun; 0 where nothing does. To be freed. */
static float *blockers_new(const kit_scene *scene, const kit_light *sun)
{
    const int width = scene->camera.width, height = scene->camera.height;
    const size_t size = ssgi_trace_size(scene->mesh.triangles);
    float *distance = calloc((size_t)width * (size_t)height, sizeof *distance);
    void *memory = malloc(size);
    ssgi_trace trace;
    if (!CHECK(distance && memory
                   && ssgi_trace_build(&trace, memory, size, scene->mesh.position, 12, NULL, scene->mesh.triangles,
                                       NULL)
                          == SSGI_OK,
               "no trace"))
        return NULL;
    for (int i = 0; i < width * height; ++i) {
        float o[3], d[3];
        ssgi_hit hit, occluder;
        kit_camera_ray(&scene->camera, i % width, i / width, o, d);
        if (!ssgi_trace_closest(&hit, &trace, o, d, 0, INFINITY)) continue;
        for (int k = 0; k < 3; ++k) o[k] += d[k] * (hit.t - 1e-4f);
        if (ssgi_trace_closest(&occluder, &trace, o, sun->at, 0, INFINITY)) distance[i] = occluder.t;
    }
    free(memory);
    return distance;
}

/* Over a hundred shapes to the far end of the ground: near ones in fine texels, far ones in their shadows all the
   same. */
static void suns_cover_what_is_seen(void)
{
    enum { WIDTH = 320, HEIGHT = 180 };
    kit_scene scene;
    kit_gbuffer g;
    kit_lighting l;
    kit_image out, truth;
    int wrong[2] = { 0, 0 }, dark = 0;
    if (!TRY(kit_scene_load(&scene, "crowd", 0, &err))) return;
    kit_camera low = scene.camera;
    kit_scene_free(&scene);
    memcpy(low.eye, (float[3]){ 0, 0.6f, 9 }, sizeof low.eye);
    memcpy(low.target, (float[3]){ 0, 0.3f, -5 }, sizeof low.target);
    if (!lighten(&l, NULL, "sun:1,0.3,0.5,3,3,3") || !see(&scene, &g, "crowd", NULL, 0, &low, WIDTH, HEIGHT)
        || !lit(&out, &g, "ssdo", "bounce=none,shadows=map", scene.radius, &scene, &l)
        || !TRY(kit_truth_lit(&truth, &scene, &g.camera, &l, 1, KIT_ATTENUATION_NONE, 0, 1, 1, &err)))
        return;
    for (int i = 3 * WIDTH * HEIGHT; i < 4 * WIDTH * HEIGHT; ++i) {
        dark += !(truth.data[i] > 0);
        wrong[0] += !(truth.data[i] > 0) && out.data[i] > 0;
        wrong[1] += truth.data[i] > 0 && !(out.data[i] > 0);
    }
    CHECK(wrong[0] <= 160 && wrong[1] <= 160 && dark > 20000, "of %d dark pixels %d are lit, %d others dark", dark,
          wrong[0], wrong[1]);
    t_note("of %d dark pixels %d are lit, %d others dark", dark, wrong[0], wrong[1]);
    kit_image_free(&out); kit_image_free(&truth); kit_gbuffer_free(&g); kit_scene_free(&scene);
}

static void fill_brings_contacts_back(void)
{
    enum { WIDTH = 640, HEIGHT = 360 };
    static const char *const sets[2] = { "bounce=none,shadow_size=512,shadows=map",
                                         "bounce=none,shadow_size=512,shadows=fill" };
    kit_scene scene;
    kit_gbuffer g;
    kit_lighting l;
    kit_image out;
    int lost[2] = { 0 }, lit_rightly[2] = { 0 };
    if (!lighten(&l, NULL, "sun:1,0.35,0.3,3,3,3") || !see(&scene, &g, "pebbles", NULL, 0, NULL, WIDTH, HEIGHT)) return;
    float *distance = blockers_new(&scene, &l.light[0]);
    for (int m = 0; m < 2 && distance; ++m) {
        if (!lit(&out, &g, "ssdo-points", sets[m], scene.radius, &scene, &l)) return;
        for (int i = 0; i < WIDTH * HEIGHT; ++i)
            if (out.data[3 * WIDTH * HEIGHT + i] > 0) {            /* a texel is 0.006 wide */
                lost[m] += distance[i] > 0 && distance[i] < 0.01f;
                lit_rightly[m] += distance[i] <= 0;
            }
        kit_image_free(&out);
    }
    CHECK(lost[1] <= 0.7 * lost[0] && lost[0] > 100 && lit_rightly[1] > 0.9985 * lit_rightly[0],
          "%d pixels lit in contact shadows with maps, %d filled; lit rightly %d, %d", lost[0], lost[1], lit_rightly[0],
          lit_rightly[1]);
    t_note("%d pixels lit in contact shadows with maps, %d filled; lit rightly %d, %d", lost[0], lost[1],
           lit_rightly[0], lit_rightly[1]);
    free(distance);
    kit_gbuffer_free(&g); kit_scene_free(&scene);
}

/* Coarse maps, and creases a pixel wide: what is filled is in shadow. */
static void fill_spares_what_is_lit(void)
{
    enum { WIDTH = 320, HEIGHT = 180 };
    static const char *const sets[2] = { "bounce=none,shadow_size=128,shadows=map",
                                         "bounce=none,shadow_size=128,shadows=fill" };
    kit_scene scene;
    kit_gbuffer g;
    kit_lighting l;
    kit_image out[2];
    int rightly = 0, wrongly = 0;
    if (!lighten(&l, NULL, "sun:1,0.35,0.3,3,3,3") || !see(&scene, &g, "boxes", NULL, 0, NULL, WIDTH, HEIGHT)) return;
    float *distance = blockers_new(&scene, &l.light[0]);
    for (int m = 0; m < 2; ++m)
        if (!distance || !lit(&out[m], &g, "ssdo-points", sets[m], scene.radius, &scene, &l)) return;
    for (int i = 0; i < WIDTH * HEIGHT; ++i) {
        const size_t k = (size_t)(3 * WIDTH * HEIGHT + i);
        if (!(out[0].data[k] > 0) || out[1].data[k] > 0) continue;
        rightly += distance[i] > 0;
        wrongly += distance[i] <= 0;
    }
    CHECK(wrongly <= rightly, "%d pixels rightly darkened, %d wrongly", rightly, wrongly);
    t_note("%d pixels rightly darkened, %d wrongly", rightly, wrongly);
    free(distance);
    kit_image_free(&out[0]); kit_image_free(&out[1]);
    kit_gbuffer_free(&g); kit_scene_free(&scene);
}

static void point_light_in_a_box(void)
{
    static const char *const direct[2] = { "bounce=none,shadows=map", "bounce=none,shadows=fill" };
    static const char *const indirect[3] = { "bounce=none,vpls=64,shadow_size=256",
                                             "bounce=solid-angle,vpls=64,shadow_size=256", "bounce=solid-angle" };
    kit_scene scene;
    kit_gbuffer g;
    kit_lighting l;
    kit_image out, truth;
    double share[3] = { 0 }, splash = 0;
    if (!lighten(&l, NULL, "point:0,5,-2.8,15,15,15") || !see(&scene, &g, "cornell", NULL, 0, NULL, W, H) ||
        !TRY(kit_truth_lit(&truth, &scene, &scene.camera, &l, INFINITY, KIT_ATTENUATION_NONE, 1, 64, 1, &err))) return;
    for (int m = 0; m < 2; ++m) {
        const float *b = kit_image_channel(&truth, "irradiance.G");
        int bright = 0, dark = 0;
        if (!lit(&out, &g, "ssdo-points", direct[m], scene.radius, &scene, &l)) return;
        const float *a = kit_image_channel(&out, "irradiance.G");
        for (int i = 0; i < W * H; ++i) {
            bright += a[i] - b[i] > 0.1f * a[i];
            dark += b[i] - a[i] > 0.1f * b[i];
        }
        CHECK(bright + dark < W * H / 100, "%s: %d of %d pixels too bright, %d too dark", direct[m], bright, W * H,
              dark);
        t_note("%s: %d of %d pixels too bright, %d too dark", direct[m], bright, W * H, dark);
        kit_image_free(&out);
    }
    for (int m = 0; m < 3; ++m) {
        if (!lit(&out, &g, "ssdo-points", indirect[m], scene.radius, &scene, &l)) return;
        share[m] = mean(&out, "bounce.G") / mean(&truth, "bounce.G");
        if (!m)
            for (int i = 0; i < W * H; ++i)
                splash = fmax(splash, (double)(kit_image_channel(&out, "bounce.G")[i]
                                               - kit_image_channel(&truth, "bounce.G")[i]));
        kit_image_free(&out);
    }
    splash /= mean(&truth, "bounce.G");
    CHECK(splash < 4, "near a virtual light it is %.2f times the mean too bright", splash);
    CHECK(fabs(share[0] - 1) < 0.25 && share[1] <= 1.1 && share[1] > share[0],
          "virtual lights bring %.3f of the bounce, with what is near %.3f", share[0], share[1]);
    t_note("virtual lights bring %.3f of the bounce, with what is near %.3f, a bounce within the radius alone %.3f; "
           "brightest splash %.2f of the mean",
           share[0], share[1], share[2], splash);
    kit_image_free(&truth); kit_gbuffer_free(&g); kit_scene_free(&scene);
}

/* With a margin the picture is what the middle of a larger picture is, bit by bit; what lies around it is not drawn. */
static void margins(void)
{
    static const struct { const char *method, *set; int rim; } rows[] = {
        { "ssao", "samples=5,normal=depth,blur=2", 6 }, { "hsao", "directions=1,steps=3,blur=2", 6 },
        { "hsao-best", "directions=1,steps=3,blur=0", 0 },
        { "hsao-march", "directions=2,steps=3,normal_rays=1,layers=2", 4 },
        { "ssdo-points", "samples=4,steps=1,environment=none", -1 },
        { "ssdo", "directions=1,steps=3,half=1,bounce=none", 4 },
        { "ssdo", "directions=1,steps=3,half=0,reuse=1", -1 },
        { "s3ho", "directions=1,steps=3,bands=2,half=1", -1 },
        { "s3ho-points", "samples=4,steps=1,bands=2,filtered=coefficients,indirect=apart,blur=2", -1 },
        { "ssbn", "directions=1,steps=3,half=0,blur=0", 0 } };
    const kit_camera camera = { { 4.55f, 1.75f, 4.25f }, { 1.35f, 0.85f, 0.85f }, { 0, 1, 0 }, 0, 3, 0.1f, 12, 67, 49,
                                { 3, -2 }, KIT_DEPTH_NORMAL };
    kit_lighting l;
    kit_scene scene;
    kit_gbuffer g;
    if (!lighten(&l, "sky", "sun:1,2,1,3,3,3") || !see(&scene, &g, "room", NULL, 0, &camera, 67, 49)) return;
    const kit_world world = { &scene, &l };
    for (int r = 0; r < (int)(sizeof rows / sizeof *rows); ++r) {
        kit_method m;
        kit_run run;
        kit_gbuffer wide;
        kit_image inner, whole;
        int off = 0, shown = 0;
        /* orthographic: 0.45 units are 0.45 * 49 / 3 = 7.35 pixels, 1.5 radii 11.03: over the most, 49 / 16 * 4 */
        const int expected = r % 2 ? 12 : 8;
        if (!TRY(kit_method_find(&m, rows[r].method, &err)) || !TRY(kit_method_set(&m, rows[r].set, &err))) return;
        if (!TRY(kit_gbuffer_widen(&wide, &g, &scene, expected, &err))) return;
        if (!TRY(kit_run_open(&run, &wide, &m, 0.45f, &world, &err))) return;
        kit_run_draw(&run, 0);
        if (!TRY(kit_run_read(&whole, &run, &err))) return;
        kit_run_close(&run);
        kit_method_set(&m, r % 2 ? "margin=1.7" : "margin=1", NULL);
        if (!TRY(kit_run_open(&run, &g, &m, 0.45f, &world, &err))) return;
        kit_run_draw(&run, 0);
        if (!TRY(kit_run_read(&inner, &run, &err))) return;
        CHECK(run.margin == expected, "%s: a margin of %d pixels, not %d", m.name, run.margin, expected);
        CHECK(inner.width == 67 && inner.height == 49, "%s: the picture is %d x %d", m.name, inner.width, inner.height);
        for (int c = 0; c < inner.channels; ++c)
            for (int y = 0; y < inner.height; ++y)
                off += memcmp(inner.data + (c * 49 + y) * 67, kit_image_channel(&whole, inner.name[c])
                              + (y + expected) * whole.width + expected, 67 * sizeof(float)) != 0;
        CHECK(!off, "%s %s: %d rows are not those of a larger picture", m.name, rows[r].set, off);
        const kit_pass *p =
            &run.pass[run.pass[0].desc.pass == SSGI_GL_PASS_THICKNESS]; /* widths are of all that is seen */
        const int half = p->desc.gather.half ? 2 : 1, drawn_columns = half * p->box[2];
        CHECK(rows[r].rim < 0 ? !p->box[2] : abs(drawn_columns - 67 - 2 * rows[r].rim) < half, "%s %s: its first pass "
              "draws %d columns", m.name, rows[r].set, drawn_columns);
        for (int i = 0; i < run.passes; ++i) shown += run.pass[i].box[2] == 67 && run.pass[i].box[3] == 49;
        CHECK(shown, "%s %s: no pass draws the picture alone", m.name, rows[r].set);
        kit_run_close(&run);
        kit_gbuffer_free(&wide);
        kit_image_free(&inner);
        kit_image_free(&whole);
    }
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
    kit_image_free(&l.env);
}

void test_light(void)
{
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("furnace: in uniform light every pixel gets exactly what comes in", furnace);
    RUN("further bounces: a white corner in uniform light ends as bright as what comes in", further_bounces);
    RUN("the corner darkens by its closed forms, for every falloff and number of steps", corner_darkens);
    RUN("creases stay sharp where nothing is occluded, with the default filters", creases_stay);
    RUN("what slices block of light that has a direction is what comes from there", slices_know_directions);
    RUN("the corner's bounce is what each estimator's expectation is", corner_bounces);
    RUN("a frame's own radiance, which harmonics cannot carry, is refused", harmonics_refuse_direct);
    RUN("two layers see through behind a slab, an odd last one is solid or ends", layers_count);
    RUN("extra cameras add what the picture lacks, and take back what it gets wrong", cameras_know_more);
    RUN("a segment ends at its light", segments_end_at_lights);
    RUN("an emitter seen from behind is dark, unless both sides shine", backs_are_dark);
    RUN("an emitter seen edge-on is dark", edge_on_is_dark);
    RUN("with a margin the picture is the middle of a larger one, drawn alone", margins);
    RUN("a plane does not shadow itself in a map", planes_do_not_shadow_themselves);
    RUN("a sun's maps cover all that is seen", suns_cover_what_is_seen);
    RUN("of what the maps' bias loses a third is filled, and next to nothing darkened", fill_brings_contacts_back);
    RUN("where creases are a pixel wide, what is filled is in shadow", fill_spares_what_is_lit);
    RUN("a point light, and its virtual lights", point_light_in_a_box);
    kit_gl_close();
}
