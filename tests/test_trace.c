/* test_trace.c - the tracer against brute force, cameras, the ray-traced truth and its floor against closed forms. */
#include "t.h"
#include "kit/kit.h"
#include "ssgi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static int build(ssgi_trace *trace, void **memory, const float *position, size_t triangles)
{
    const char *why = "";
    const size_t size = ssgi_trace_size(triangles);
    *memory = malloc(size + 1);
    const int ok =
        *memory
        && ssgi_trace_build(trace, (char *)*memory + 1, size, position, 3 * sizeof(float), NULL, triangles, &why)
               == SSGI_OK;
    CHECK(ok, "the tree of %zu triangles was not built: %s", triangles, why);
    return ok;
}

/* Distance to triangle c in double, or -1; wide: how far beyond an edge, in barycentric weight, still counts. */
static double brute(const float *c, const float o[3], const float d[3], double wide)
{
    double e[3], f[3], s[3], p[3], q[3], largest = 0;
    for (int i = 0; i < 9; ++i) {
        if (!(fabsf(c[i]) <= 1e12f)) return -1;
        largest = fmax(largest, (double)fabsf(c[i]));
    }
    for (int i = 0; i < 3; ++i) {
        e[i] = (double)c[3 + i] - (double)c[i];
        f[i] = (double)c[6 + i] - (double)c[i];
        s[i] = (double)o[i] - (double)c[i];
    }
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        p[i] = (double)d[j] * f[k] - (double)d[k] * f[j];
        q[i] = s[j] * e[k] - s[k] * e[j];
    }
    const double det = e[0] * p[0] + e[1] * p[1] + e[2] * p[2];
    if (det == 0) return -1;
    const double u = (s[0] * p[0] + s[1] * p[1] + s[2] * p[2]) / det,
                 v = ((double)d[0] * q[0] + (double)d[1] * q[1] + (double)d[2] * q[2]) / det;
    if (u < -wide || v < -wide || u + v > 1 + wide) return -1;
    return (f[0] * q[0] + f[1] * q[1] + f[2] * q[2]) / det;
}

enum { SOUP = 3000, RAYS = 3000 };

static void against_brute_force(void)
{
    static float soup[SOUP][9];
    ssgi_trace trace;
    void *memory;
    int hits = 0;
    t_seed(1);
    for (int t = 0; t < SOUP; ++t) {
        const float size = expf(t_uniform(-5, 0));
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 3; ++i)
                soup[t][3 * k + i] = (k ? soup[t][i] : t_uniform(-1, 1)) + (k ? t_uniform(-size, size) : 0);
        if (t % 50 == 1) soup[t][t % 9] = NAN;
        if (t % 50 == 2) soup[t][t % 9] = t & 1 ? INFINITY : -2e12f;
        /* two corners the same */
        if (t % 50 == 3) memcpy(&soup[t][3], soup[t], 3 * sizeof(float));
        if (t % 50 == 4) for (int i = 0; i < 3; ++i) soup[t][6 + i] = soup[t][i];
        if (t % 50 == 5) memcpy(soup[t], soup[t - 5], sizeof soup[t]);                          /* the same again */
        /* huge, below the rest */
        if (t % 50 == 6) for (int i = 0; i < 9; ++i) soup[t][i] = i % 3 == 1 ? -1.5f : t_uniform(-100, 100) * 1e6f;
    }
    if (!build(&trace, &memory, soup[0], SOUP)) return;
    CHECK(trace.skipped == 4 * SOUP / 50, "%u triangles were skipped, %d cannot be hit", trace.skipped, 4 * SOUP / 50);
    for (int r = 0; r < RAYS; ++r) {
        float o[3], d[3];
        for (int i = 0; i < 3; ++i) {
            o[i] = t_uniform(-1.4f, 1.4f);
            d[i] = t_uniform(-3, 3) * (r % 7 == i ? 0.0f : 1.0f);
        }
        const float tmax = r % 3 ? t_uniform(0, 0.5f) : 1e9f, tmin = r % 4 ? 0 : t_uniform(0, 0.05f);
        double sure = 1e30, possible = 1e30;
        for (int t = 0; t < SOUP; ++t) {
            const double narrow = brute(soup[t], o, d, -1e-3), wide = brute(soup[t], o, d, 1e-3);
            if (narrow > (double)tmin + 1e-4 && narrow < (double)tmax - 1e-4) sure = fmin(sure, narrow);
            if (wide > (double)tmin - 1e-4 && wide < (double)tmax + 1e-4) possible = fmin(possible, wide);
        }
        ssgi_hit hit = { -1, -1, -1, 0 };
        const int found = ssgi_trace_closest(&hit, &trace, o, d, tmin, tmax),
                  any = ssgi_trace_any(&trace, o, d, tmin, tmax);
        CHECK(found == any, "ray %d: closest says %d, any says %d", r, found, any);
        CHECK(found || sure > 1e29, "ray %d: the hit at %g was missed", r, sure);
        CHECK(found || hit.t == -1, "ray %d: hit was written without a hit", r);
        hits += found;
        if (!found) continue;
        const double t = (double)hit.t;
        CHECK(t >= possible - 1e-4 * (1 + possible) && t <= sure + 1e-4 * (1 + sure),
              "ray %d: hit at %g, brute force between %g and %g", r, t, possible, sure);
        CHECK(t > (double)tmin && t < (double)tmax, "ray %d: hit at %g outside (%g, %g)", r, t, (double)tmin,
              (double)tmax);
        CHECK(hit.u >= 0 && hit.v >= 0 && hit.u + hit.v <= 1.000001f, "ray %d: weights %g %g", r, (double)hit.u,
              (double)hit.v);
        for (int i = 0; i < 3 && hit.triangle < SOUP; ++i) {
            const float *c = soup[hit.triangle];
            const double on = (double)((1 - hit.u - hit.v) * c[i] + hit.u * c[3 + i] + hit.v * c[6 + i]),
                         size = fabs((double)c[i]) + fabs((double)c[3 + i]);
            CHECK(fabs(on - ((double)o[i] + t * (double)d[i])) < 1e-4 + 1e-5 * size,
                  "ray %d: the weights lead to %g, the distance to %g", r, on, (double)o[i] + t * (double)d[i]);
        }
    }
    CHECK(hits > RAYS / 4 && hits < RAYS, "%d of %d rays hit: no test", hits, RAYS);
    const float o[3] = { 0, 0, 0 }, bad[3][3] = { { 0, 0, 0 }, { NAN, 0, 1 }, { 1, INFINITY, 0 } };
    for (int k = 0; k < 3; ++k) CHECK(!ssgi_trace_any(&trace, o, bad[k], 0, 1e9f), "bad direction %d hits", k);
    CHECK(!ssgi_trace_any(&trace, bad[1], soup[0], 0, 1e9f), "an origin that is not a number hits");
    free(memory);
}

/* Nested shells shrink by a factor each: area would peel them off one by one. Then thousands that nothing can tell
   apart. */
static void deep_trees(void)
{
    enum { SHELLS = 6000, SAME = 20000 };
    float *soup = malloc((SHELLS + SAME) * 9 * sizeof *soup);
    ssgi_trace trace;
    void *memory;
    for (int t = 0; t < SHELLS; ++t) {
        const float s = powf(10, 10 - 24.0f * (float)t / SHELLS), c[9] = { s, -s, -s, s, s, -s, s, 0, s };
        memcpy(soup + 9 * t, c, sizeof c);
    }
    for (int t = 0; t < SAME; ++t) {
        const float c[9] = { -1, -1, -1, -1, 1, -1, -1, 0, 1 };
        memcpy(soup + 9 * (SHELLS + t), c, sizeof c);
    }
    if (!build(&trace, &memory, soup, SHELLS + SAME)) { free(soup); return; }
    const float o[3] = { 0, 0, 0 }, forth[3] = { 1, 0, 0 }, back[3] = { -1, 0, 0 };
    float tmin = 0;
    int counted = 0;
    ssgi_hit hit;
    while (counted <= SHELLS && ssgi_trace_closest(&hit, &trace, o, forth, tmin, 1e11f)) {
        tmin = hit.t;
        ++counted;
    }
    CHECK(counted == SHELLS, "%d of %d shells were hit one after the other", counted, SHELLS);
    CHECK(ssgi_trace_closest(&hit, &trace, o, back, 0, 2) && hit.t == 1.0f, "coincident triangles: not hit at 1");
    free(memory);
    for (int i = 0; i < 9 * SAME; ++i) soup[i] = NAN;
    if (build(&trace, &memory, soup, SAME))
        CHECK(!ssgi_trace_any(&trace, o, back, 0, 2), "nothing but bad triangles, and a hit");
    free(memory);
    free(soup);
}

/* lumpy: the radius varies from place to place */
static void ball(kit_mesh *mesh, int rings, const float centre[3], float radius, float lumpy)
{
    const int around = 2 * rings;
    mesh->position = realloc(mesh->position, (mesh->triangles + (size_t)(2 * rings * around)) * 9 * sizeof(float));
    mesh->normal = realloc(mesh->normal, (mesh->triangles + (size_t)(2 * rings * around)) * 9 * sizeof(float));
    if (!mesh->position || !mesh->normal) exit(1);
    for (int y = 0; y < rings; ++y)
        for (int x = 0; x < around; ++x)
            for (int k = 0; k < 6; ++k) {
                static const int dx[6] = { 0, 1, 1, 0, 1, 0 }, dy[6] = { 0, 0, 1, 0, 1, 1 };
                const double a = 6.283185307179586 * ((x + dx[k]) % around) / around,
                             b = 3.141592653589793 * (y + dy[k]) / rings;
                const double n[3] = { sin(b) * cos(a), cos(b), sin(b) * sin(a) };
                for (int i = 0; i < 3; ++i) {
                    const size_t at =
                        9 * (mesh->triangles + (size_t)(2 * (y * around + x) + k / 3)) + (size_t)(3 * (k % 3) + i);
                    mesh->normal[at] = (float)n[i];
                    mesh->position[at] =
                        centre[i]
                        + (float)((double)radius * n[i]
                                  * (1 + (double)lumpy * sin(40 * n[0]) * sin(37 * n[1]) * sin(31 * n[2])));
                }
            }
    mesh->triangles += (size_t)(2 * rings * around);
}

/* A parallelogram of n x n x 2 triangles with the corner p and the sides a, b. */
static void sheet(kit_mesh *mesh, int n, const float p[3], const float a[3], const float b[3])
{
    const size_t more = (size_t)(2 * n * n);
    mesh->position = realloc(mesh->position, (mesh->triangles + more) * 9 * sizeof(float));
    mesh->normal = realloc(mesh->normal, (mesh->triangles + more) * 9 * sizeof(float));
    if (!mesh->position || !mesh->normal) exit(1);
    float normal[3], length = 0;
    for (int i = 0; i < 3; ++i) {
        normal[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        length += normal[i] * normal[i];
    }
    float *to = mesh->position + 9 * mesh->triangles, *up = mesh->normal + 9 * mesh->triangles;
    for (int q = 0; q < n * n; ++q)
        for (int k = 0; k < 6; ++k) {
            static const int da[6] = { 0, 1, 1, 0, 1, 0 }, db[6] = { 0, 0, 1, 0, 1, 1 };
            for (int i = 0; i < 3; ++i) {
                *to++ = p[i] + a[i] * (float)(q % n + da[k]) / (float)n + b[i] * (float)(q / n + db[k]) / (float)n;
                *up++ = normal[i] / sqrtf(length);
            }
        }
    mesh->triangles += more;
}

static void bounds(kit_mesh *mesh)
{
    for (int i = 0; i < 3; ++i) mesh->lower[i] = mesh->upper[i] = mesh->position[i];
    for (size_t k = 0; k < 9 * mesh->triangles; ++k) {
        mesh->lower[k % 3] = fminf(mesh->lower[k % 3], mesh->position[k]);
        mesh->upper[k % 3] = fmaxf(mesh->upper[k % 3], mesh->position[k]);
    }
}

static void no_cracks(void)
{
    kit_mesh mesh = { 0 };
    const float middle[3] = { 0.1f, 0.2f, -0.3f };
    ball(&mesh, 60, middle, 1, 0.2f);
    ssgi_trace trace;
    void *memory;
    int missed = 0, shot = 0;
    if (!build(&trace, &memory, mesh.position, mesh.triangles)) return;
    t_seed(7);
    for (size_t t = 0; t < mesh.triangles; ++t)
        for (int k = 0; k < 6; ++k, ++shot) {                               /* at corners, and along edges */
            const float *p = mesh.position + 9 * t + 3 * (k % 3), *q = mesh.position + 9 * t + 3 * ((k + 1) % 3);
            float o[3], d[3], along = k < 3 ? 0 : t_uniform(0, 1);
            for (int i = 0; i < 3; ++i) {
                o[i] = middle[i] + t_uniform(-0.5f, 0.5f);
                d[i] = p[i] + along * (q[i] - p[i]) - o[i];
            }
            missed += !ssgi_trace_any(&trace, o, d, 0, 1e9f);
        }
    CHECK(missed == 0, "%d of %d rays slipped through edges or corners of a closed surface", missed, shot);
    free(memory);
    kit_mesh_free(&mesh);
}

static void bad_arguments(void)
{
    static const float triangle[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
    static unsigned char memory[2048], before[2048];
    const size_t size = ssgi_trace_size(1);
    ssgi_trace trace, same;
    if (!CHECK(size > 0 && size <= sizeof memory, "one triangle needs %zu bytes", size)) return;
    memset(memory, 0x5a, sizeof memory);
    memcpy(before, memory, sizeof memory);
    memset(&trace, 0x5a, sizeof trace);
    memcpy(&same, &trace, sizeof trace);
    for (int k = 0; k < 8; ++k) {
        static const char *const names[8] = { "trace",        "memory",    "position",  "stride_bytes",
                                              "stride_bytes", "triangles", "triangles", "size" };
        const char *why = "";
        const size_t many = SSGI_TRACE_MAX_TRIANGLES;
        const ssgi_result result = ssgi_trace_build(k == 0 ? NULL : &trace, k == 1 ? NULL : memory,
                                                    k == 7 ? size - 1 : size, k == 2 ? NULL : triangle,
                                                    k == 3   ? 8
                                                    : k == 4 ? 14
                                                             : 12,
                                                    NULL,
                                                    k == 5   ? 0
                                                    : k == 6 ? many + 1
                                                             : 1,
                                                    &why);
        CHECK(result == (k == 7 ? SSGI_TOO_SMALL : SSGI_BAD_ARGUMENT), "bad %s: result %d", names[k], (int)result);
        CHECK(!strncmp(why, names[k], strlen(names[k])), "bad %s: \"%s\"", names[k], why);
    }
    CHECK(!memcmp(memory, before, sizeof memory) && !memcmp(&trace, &same, sizeof trace),
          "a refused build wrote something");
    CHECK(ssgi_trace_size(0) == 0 && ssgi_trace_size((size_t)-1) == 0, "sizes that cannot be have a size");
    /* the size named suffices: nothing is written beyond it, of even rows, whose nodes are full (512), and of others */
    for (size_t n = 1; n <= 512; ++n) {
        static float soup[512][9];
        for (size_t t = 0; t < n; ++t)
            for (int i = 0; i < 9; ++i) soup[t][i] = triangle[i] + (i % 3 ? 0 : (float)(n % 2 ? t * t : t));
        const size_t all = ssgi_trace_size(n);
        unsigned char *exact = malloc(all + 64);
        if (!exact) return;
        memset(exact, 0x5a, all + 64);
        CHECK(ssgi_trace_build(&trace, exact, all, soup[0], 12, NULL, n, NULL) == SSGI_OK, "%zu triangles were refused",
              n);
        for (size_t i = all; i < all + 64; ++i)
            CHECK(exact[i] == 0x5a, "%zu triangles: byte %zu of %zu was written", n, i, all);
        free(exact);
    }
}

/* ---- cameras --------------------------------------------------------------------------------------------------- */

static void transform(const float m[16], const double in[4], double out[4])
{
    for (int r = 0; r < 4; ++r)
        out[r] = (double)m[r] * in[0] + (double)m[4 + r] * in[1] + (double)m[8 + r] * in[2] + (double)m[12 + r] * in[3];
}

static void cameras(void)
{
    for (int k = 0; k < 24; ++k) {
        kit_camera camera = { .eye = { 3, 2, 5 },
                              .target = { -0.5f, 0.25f, 1 },
                              .up = { 0.1f, 1, 0.2f },
                              .fovy = k & 1 ? 0.0f : 55.0f,
                              .ortho_height = 4,
                              .znear = 0.5f,
                              .zfar = 20,
                              .width = 97,
                              .height = 64,
                              .shift = { k & 2 ? 20.25f : 0.0f, k & 2 ? 11.5f : 0.0f },
                              .depth = k / 4 % 3 };
        if (k >= 12)
            camera.up[0] = camera.eye[0] - camera.target[0], camera.up[1] = camera.eye[1] - camera.target[1],
            camera.up[2] = camera.eye[2] - camera.target[2];
        float view[16], projection[16], o[3], d[3];
        const double top = camera.depth == KIT_DEPTH_NORMAL ? -1 : 1, bottom = camera.depth == KIT_DEPTH_NORMAL ? 1 : 0;
        const int endless = camera.depth == KIT_DEPTH_INFINITE && camera.fovy > 0;
        kit_camera_matrices(&camera, view, projection);
        for (int i = 0; i < 60; ++i) {
            const int x = i * 37 % camera.width, y = i * 23 % camera.height;
            kit_camera_ray(&camera, x, y, o, d);
            for (int plane = 0; plane < 2; ++plane) {
                double p[4] = { 0, 0, 0, 1 }, v[4], c[4], axis[4];
                for (int j = 0; j < 3; ++j) p[j] = (double)d[j];
                p[3] = 0;
                transform(view, p, axis);                                   /* the ray's slope: how far to a plane */
                const double depth = plane ? (endless ? 1e7 : 20.0) : 0.5;
                for (int j = 0; j < 3; ++j) p[j] = (double)o[j] + (double)d[j] * depth / -axis[2];
                p[3] = 1;
                transform(view, p, v);
                transform(projection, v, c);
                const double px = (c[0] / c[3] * 0.5 + 0.5) * camera.width,
                             py = (0.5 - c[1] / c[3] * 0.5) * camera.height, z = c[2] / c[3];
                CHECK(fabs(px - x - 0.5) < 1e-3 && fabs(py - y - 0.5) < 1e-3,
                      "camera %d: the ray of pixel %d, %d comes out at %.4f, %.4f", k, x, y, px, py);
                CHECK(fabs(z - (plane ? bottom : top)) < 1e-4, "camera %d: the %s plane has depth %g", k,
                      plane ? "far" : "near", z);
            }
            CHECK(fabs((double)(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]) - 1) < 1e-6,
                  "camera %d: direction is not unit", k);
        }
        const double target[4] = { -0.5, 0.25, 1, 1 };
        double v[4], c[4];
        transform(view, target, v);
        transform(projection, v, c);
        const double px = (c[0] / c[3] * 0.5 + 0.5) * 97, py = (0.5 - c[1] / c[3] * 0.5) * 64;
        CHECK(fabs(px - 48.5 - (double)camera.shift[0]) < 1e-3 && fabs(py - 32 + (double)camera.shift[1]) < 1e-3,
              "camera %d: the target is seen at %g, %g", k, px, py);
    }
}

/* ---- truth and floor ------------------------------------------------------------------------------------------- */

static double corner_occlusion(double c, int attenuation)      /* of a wall at the distance c radii */
{
    const double s = sqrt(fmax(0, 1 - c * c));
    if (c >= 1) return 0;
    if (attenuation == KIT_ATTENUATION_NONE) return (acos(c) - c * s) / 3.141592653589793;
    return (acos(c) + c * s - (c > 0 ? 2 * c * log((1 + s) / c) : 0)) / 3.141592653589793;
}

/* expected < 0: not counted */
static void compare(const char *what, const kit_image *y, const double *expected, double rmse, double most)
{
    double sum = 0, worst = 0;
    int n = 0;
    for (int i = 0; i < y->width * y->height; ++i)
        if (expected[i] >= 0) {
            const double e = (double)y->data[i] - expected[i];
            sum += e * e;
            worst = fmax(worst, fabs(e));
            ++n;
        }
    const double found = sqrt(sum / (n + !n));
    CHECK(n > y->width * y->height / 10, "%s: only %d pixels count", what, n);
    CHECK(found <= rmse && worst <= most, "%s: RMSE %.4f (at most %.4f), worst pixel %.4f (at most %.4f)", what, found,
          rmse, worst, most);
    t_note("%s: RMSE %.5f, worst pixel %.4f", what, found, worst);
}

static void bare_plane(void)
{
    static const float p[3] = { 100, 200, -50 }, a[3] = { 7, 3, -2 }, b[3] = { 1, -4, 6 };
    for (int k = 0; k < 4; ++k) {
        kit_scene scene = { 0 };
        kit_image y;
        kit_error err = { "" };
        kit_camera camera = { .eye = { 104, 199.5f, -48 },
                              .target = { 103.5f, 199.4f, -48.3f },
                              .up = { 0, 1, 0 },
                              .fovy = k & 2 ? 0.0f : 60.0f,
                              .ortho_height = 2,
                              .width = 48,
                              .height = 32 };
        for (int i = 0; i < 3; ++i)
            camera.eye[i] = p[i] + 0.5f * (a[i] + b[i])
                            + 0.3f
                                  * (i == 0   ? 10.0f
                                     : i == 1 ? -44.0f
                                              : -31.0f)
                                  / 54.7f,
            camera.target[i] = p[i] + 0.55f * (a[i] + b[i]);
        sheet(&scene.mesh, k & 1 ? 40 : 1, p, a, b);
        bounds(&scene.mesh);
        if (!CHECK(!kit_truth_ao(&y, &scene, &camera, 2, k & 1, 64, 1, &err), "%s", err.text)) return;
        int shaded = 0;
        for (int i = 0; i < 48 * 32; ++i) shaded += y.data[i] != 1.0f;
        CHECK(shaded == 0, "%d pixels of a bare plane are not exactly open (camera %d)", shaded, k);
        kit_image_free(&y);
        kit_mesh_free(&scene.mesh);
    }
}

/* ---- ssgi_trace_visibility ------------------------------------------------------------------------------------- */

/* Points on a floor at y = 0, between x = 0 and 1, by closed forms: beside a wall without end, attenuated and not; a
   wall of the height 1; a groove of the width 1 and depth 1. The sheets are so long that their ends do not count. */
static double closed_form(int shape, double x)
{
    const double wall = (1 - x / sqrt(x * x + 1)) / 2;
    if (shape < 2) return corner_occlusion(x, shape ? KIT_ATTENUATION_NONE : KIT_ATTENUATION_LINEAR);
    return shape == 2 ? wall : wall + (1 - (1 - x) / sqrt((1 - x) * (1 - x) + 1)) / 2;
}

static void visibility(void)
{
    enum { POINTS = 400, SHAPES = 4 };
    static const float floor_at[3] = { -100, 0, -100 }, along[3] = { 200, 0, 0 }, deep[3] = { 0, 0, 200 };
    static float position[3 * POINTS], normal[3 * POINTS], out[POINTS], other[POINTS];
    for (int shape = 0; shape < SHAPES; ++shape) {
        /* of 256 and 1024 rays; by chance alone a hard wall would err by 0.03 and 0.015 */
        static const double rms[SHAPES][2] = { { 7e-4, 2e-4 }, { 5e-3, 1.7e-3 }, { 6e-3, 2.2e-3 }, { 8e-3, 3.3e-3 } };
        const float up[3] = { 0, shape < 2 ? 100.0f : 1.0f, 0 };
        kit_mesh mesh = { 0 };
        ssgi_trace trace;
        void *memory;
        const char *why = "";
        sheet(&mesh, 1, floor_at, deep, along);
        for (int side = 0; side < (shape == 3 ? 2 : 1); ++side) {
            const float p[3] = { (float)side, 0, -100 };
            sheet(&mesh, 1, p, up, deep);
        }
        if (!build(&trace, &memory, mesh.position, mesh.triangles)) return;
        for (int i = 0; i < POINTS; ++i) {
            const float p[3] = { ((float)i + 0.5f) / POINTS, 0, 3 * sinf((float)i) }, n[3] = { 0, 0.5f, 0 };
            memcpy(position + 3 * i, p, sizeof p);
            memcpy(normal + 3 * i, n, sizeof n);
        }
        for (int r = 0; r < 2; ++r) {
            double square = 0, worst = 0, sum = 0;
            if (!CHECK(ssgi_trace_visibility(out, &trace, position, normal, POINTS, shape < 2 ? 1.0f : 0.0f,
                                             256 << 2 * r, shape > 0, &why)
                           == SSGI_OK,
                       "%s", why))
                return;
            for (int i = 0; i < POINTS; ++i) {
                const double off = 1 - (double)out[i] - closed_form(shape, (double)position[3 * i]);
                square += off * off / POINTS;
                sum += off / POINTS;
                worst = fmax(worst, fabs(off));
            }
            CHECK(sqrt(square) < rms[shape][r] && worst < 4 * rms[shape][r] && fabs(sum) < 0.1 * rms[shape][r],
                  "shape %d, %d rays: RMS %.5f, worst %.4f, mean %.5f", shape, 256 << 2 * r, sqrt(square), worst, sum);
            t_note("shape %d, %d rays: RMS %.5f, worst %.4f, mean %.5f", shape, 256 << 2 * r, sqrt(square), worst, sum);
        }
        /* a part of the points, and turned about, is the same */
        for (int i = POINTS / 2; i < POINTS; ++i)
            memcpy(position + 3 * i, position + 3 * (POINTS - 1 - i), 3 * sizeof(float));
        ssgi_trace_visibility(other, &trace, position + 3 * POINTS / 2, normal, POINTS / 2, shape < 2 ? 1.0f : 0.0f,
                              1024, shape > 0, NULL);
        CHECK(other[0] == out[POINTS / 2 - 1] && other[9] == out[POINTS / 2 - 10],
              "shape %d: a point's value depends on its place", shape);
        free(memory);
        kit_mesh_free(&mesh);
    }
}

static void own_visibility(void)
{
    kit_mesh mesh = { 0 };
    ssgi_trace trace;
    void *memory;
    const char *why = "";
    static const float middle[3] = { 300, -20, 5 }, none[6] = { 0, 0, 0, NAN, 1, 0 };
    ball(&mesh, 20, middle, 2, 0);
    const size_t corners = 3 * mesh.triangles;
    float *out = malloc(corners * sizeof *out), *normal = malloc(3 * corners * sizeof *normal), bad[2];
    if (!out || !normal || !build(&trace, &memory, mesh.position, mesh.triangles)) return;
    double least = 1, most = 0;
    for (size_t i = 0; i < 3 * corners; ++i) normal[i] = mesh.position[i] - middle[i % 3];
    CHECK(ssgi_trace_visibility(out, &trace, mesh.position, normal, corners, 0, 64, 1, &why) == SSGI_OK, "%s", why);
    for (size_t i = 0; i < corners; ++i) least = fmin(least, (double)out[i]);
    CHECK(least == 1, "a ball's own corners: %g is seen", least);
    for (size_t i = 0; i < 3 * corners; ++i) normal[i] = -normal[i];
    ssgi_trace_visibility(out, &trace, mesh.position, normal, corners, 0, 64, 1, &why);
    for (size_t i = 0; i < corners; ++i) most = fmax(most, (double)out[i]);
    CHECK(most < 0.02, "corners of a ball, from within: %g is seen", most);
    /* middles of its faces, which rounding puts to either side of them */
    float *middles = malloc(3 * mesh.triangles * sizeof *middles);
    for (size_t t = 0; t < mesh.triangles && middles; ++t) {
        const float *c = mesh.position + 9 * t;
        for (int i = 0; i < 3; ++i) {
            const int j = (i + 1) % 3, k = (i + 2) % 3;
            middles[3 * t + (size_t)i] = (c[i] + c[3 + i] + c[6 + i]) / 3;
            normal[3 * t + (size_t)i] = (c[3 + j] - c[j]) * (c[6 + k] - c[k]) - (c[3 + k] - c[k]) * (c[6 + j] - c[j]);
        }
        float out_of = 0;
        for (size_t i = 0; i < 3; ++i) out_of += normal[3 * t + i] * (middles[3 * t + i] - middle[i]);
        for (size_t i = 0; i < 3 && out_of < 0; ++i) normal[3 * t + i] *= -1;
    }
    if (middles) ssgi_trace_visibility(out, &trace, middles, normal, mesh.triangles, 0, 64, 1, &why);
    least = 1;
    for (size_t t = 0; t < mesh.triangles; ++t) least = fmin(least, (double)out[t]);
    CHECK(middles && least == 1, "middles of a ball's faces: %g is seen", least);
    free(middles);
    CHECK(ssgi_trace_visibility(bad, &trace, mesh.position, none, 2, 1, 16, 0, NULL) == SSGI_OK && bad[0] == 1
              && bad[1] == 1,
          "no normal, and one that is not finite: %g, %g", (double)bad[0], (double)bad[1]);
    for (int k = 0; k < 9; ++k) {
        static const char *const names[] = { "out", "trace", "position", "normal", "radius", "radius", "rays", "rays",
                                             "hard" };
        bad[0] = 7;
        CHECK(ssgi_trace_visibility(k == 0 ? NULL : bad, k == 1 ? NULL : &trace, k == 2 ? NULL : mesh.position,
                                    k == 3 ? NULL : normal, 1,
                                    k == 4   ? 0.0f
                                    : k == 5 ? -1.0f
                                             : 1.0f,
                                    k == 6   ? 0
                                    : k == 7 ? 65537
                                             : 16,
                                    k == 5   ? 1
                                    : k == 8 ? 2
                                             : 0,
                                    &why)
                      == SSGI_BAD_ARGUMENT
                  && !strncmp(why, names[k], strlen(names[k])) && bad[0] == 7,
              "bad %s: \"%s\"", names[k], why);
    }
    free(out);
    free(normal);
    free(memory);
    kit_mesh_free(&mesh);
}

/* the plane y = 0 or x = 0 of the corner that a ray meets first: 1 floor, 2 wall, 0 none; at: where */
static int corner_hit(const float o[3], const float d[3], double at[3])
{
    const double down = d[1] < 0 ? (double)-o[1] / (double)d[1] : 1e30,
                 side = d[0] < 0 ? (double)-o[0] / (double)d[0] : 1e30, t = fmin(down, side);
    for (int i = 0; i < 3; ++i) at[i] = (double)o[i] + t * (double)d[i];
    return t > 40 ? 0 : down < side ? 1 : 2;
}

static void corner(void)
{
    static const float p[3] = { 0, 0, -50 }, x[3] = { 50, 0, 0 }, y[3] = { 0, 50, 0 }, z[3] = { 0, 0, 100 };
    static double expected[80 * 60];
    kit_scene scene = { 0 };
    sheet(&scene.mesh, 1, p, z, x);
    sheet(&scene.mesh, 1, p, y, z);
    bounds(&scene.mesh);
    for (int k = 0; k < 4; ++k) {
        kit_camera camera = { .eye = { 4, 3, 2 },
                              .target = { 0.3f, 0.3f, 0 },
                              .up = { 0, 1, 0 },
                              .fovy = k & 2 ? 0.0f : 40.0f,
                              .ortho_height = 4,
                              .width = 80,
                              .height = 60 };
        kit_image out;
        kit_error err = { "" };
        for (int i = 0; i < 80 * 60; ++i) {
            float o[3], d[3];
            double at[3];
            kit_camera_ray(&camera, i % 80, i / 80, o, d);
            const int plane = corner_hit(o, d, at);
            expected[i] = plane ? 1 - corner_occlusion(at[plane == 1 ? 0 : 1], k & 1) : -1;
        }
        if (!CHECK(!kit_truth_ao(&out, &scene, &camera, 1, k & 1, 256, 1, &err), "%s", err.text)) break;
        compare(k & 1 ? "corner, 256 rays, hard" : "corner, 256 rays, linear", &out, expected, 0.004, 0.02);
        kit_image_free(&out);
    }
    kit_mesh_free(&scene.mesh);
}

/* Irradiance over pi (green) on the corner's floor or wall, at a distance from the other: every direction of a grid of
   four cells a texel, dimmed by the other plane within radius 1. */
static double corner_light(const kit_image *env, int floor_, double distance)
{
    double sum = 0;
    for (int y = 0; y < 2 * env->height; ++y) {
        const double area = acos(-1) * acos(-1) / env->width / env->height / 2
                            * sin(acos(-1) * (y + 0.5) / (2 * env->height));
        for (int x = 0; x < 2 * env->width; ++x) {
            float d[3], rgb[3];
            kit_env_direction(env, 0.5 * (x + 0.5), 0.5 * (y + 0.5), d);
            const double up = (double)d[!!floor_], across = (double)d[!floor_], t = across < 0 ? distance / -across : 2;
            if (up <= 0) continue;
            kit_env_radiance(env, d, rgb);
            sum += up * area * fmin(1, t) * (double)rgb[1];
        }
    }
    return sum / acos(-1);
}

/* street: lamps, a ray each; windows: none are that bright. bounce 1: all by chance alone. */
static void lit_corner(void)
{
    static const struct { const char *env; int rays, bounce; double noise;
    } row[] = { { "street", 256, 0, 0.005 }, { "street", 4096, 1, 0.006 }, { "windows", 512, 0, 0.012 } };
    static const float p[3] = { 0, 0, -50 }, x[3] = { 50, 0, 0 }, y[3] = { 0, 50, 0 }, z[3] = { 0, 0, 100 };
    enum { WIDE = 4, HIGH = 3 };
    kit_camera camera = { .eye = { 4, 3, 2 }, .target = { 0.5f, 0.5f, 0 }, .up = { 0, 1, 0 }, .ortho_height = 2.4f,
                          .width = WIDE, .height = HIGH };
    kit_scene scene = { 0 };
    double expected[WIDE * HIGH], level = 0;
    sheet(&scene.mesh, 1, p, z, x);
    sheet(&scene.mesh, 1, p, y, z);
    bounds(&scene.mesh);
    scene.mesh.albedo = calloc(3 * scene.mesh.triangles, sizeof *scene.mesh.albedo);
    for (int k = 0; k < 3; ++k) {
        kit_lighting l = { .lights = 0 };
        kit_image out;
        kit_error err = { "" };
        double off = 0, bias = 0;
        if (!CHECK(!kit_env_read(&l.env, row[k].env, &err), "%s", err.text)) break;
        if (k != 1) level = 0;                             /* the second has the first's sky */
        for (int i = 0; i < WIDE * HIGH && k != 1; ++i) {
            float o[3], d[3];
            double at[3];
            kit_camera_ray(&camera, i % WIDE, i / WIDE, o, d);
            const int plane = corner_hit(o, d, at);
            expected[i] = corner_light(&l.env, plane == 1, at[plane == 1 ? 0 : 1]);
            level += expected[i] / (WIDE * HIGH);
        }
        if (!CHECK(!kit_truth_lit(&out, &scene, &camera, &l, 1, KIT_ATTENUATION_LINEAR, row[k].bounce, row[k].rays, 1,
                                  &err), "%s", err.text)) break;
        const float *is = kit_image_channel(&out, "irradiance.G");
        for (int i = 0; i < WIDE * HIGH; ++i) {
            const double e = ((double)is[i] - expected[i]) / level;
            off += e * e / (WIDE * HIGH);
            bias += e / (WIDE * HIGH);
        }
        CHECK(sqrt(off) < row[k].noise && fabs(bias) < 0.4 * row[k].noise, "%s, %d rays: off by %.4f of the mean, bias "
              "%+.4f", row[k].env, row[k].rays, sqrt(off), bias);
        t_note("%s, %d rays: off by %.4f of the mean, bias %+.4f", row[k].env, row[k].rays, sqrt(off), bias);
        kit_image_free(&out);
        kit_image_free(&l.env);
    }
    kit_mesh_free(&scene.mesh);
}

static void ball_on_plane(void)
{
    static const float p[3] = { -30, 0, -30 }, z[3] = { 0, 0, 60 }, x[3] = { 60, 0, 0 }, middle[3] = { 0, 1, 0 };
    static double expected[64 * 64];
    kit_scene scene = { 0 };
    kit_camera camera = { .eye = { 0, 5, 0 }, .up = { 0, 0, -1 }, .ortho_height = 7, .width = 64, .height = 64 };
    kit_image out;
    kit_error err = { "" };
    sheet(&scene.mesh, 1, p, z, x);
    ball(&scene.mesh, 100, middle, 1, 0);
    bounds(&scene.mesh);
    for (int i = 0; i < 64 * 64; ++i) {
        const double u = (i % 64 + 0.5) * 7 / 64 - 3.5, v = (i / 64 + 0.5) * 7 / 64 - 3.5, rho = u * u + v * v;
        expected[i] = rho < 1.02 ? -1 : 1 - pow(1 + rho, -1.5);
    }
    if (CHECK(!kit_truth_ao(&out, &scene, &camera, 1000, KIT_ATTENUATION_NONE, 512, 1, &err), "%s", err.text)) {
        compare("ball resting on a plane, 512 rays, hard", &out, expected, 0.004, 0.02);
        kit_image_free(&out);
    }
    kit_mesh_free(&scene.mesh);
}

/* Within a ball a chord is 2 r cos long, by its angle to the normal, and the next one does not depend on it. With
   linear attenuation visibility is 4 r / (3 R), reflections are a geometric series, and a narrow lobe sees hardly more
   than the chord that mirrors the view. */
static void inside_a_ball(void)
{
    enum { SIZE = 8 };
    static const float middle[3] = { 0, 0, 0 }, albedos[3] = KIT_REFLECTED_ALBEDOS;
    const double radius = 3, open = 4 / (3 * radius);
    kit_scene scene = { 0 };
    kit_camera camera = { .eye = { 0.3f, 0.1f, 0.2f }, .target = { 1, 0.2f, 0 }, .up = { 0, 1, 0 }, .fovy = 60,
                          .znear = 0.01f, .zfar = 10, .width = SIZE, .height = SIZE };
    kit_image out;
    kit_error err = { "" };
    double mean[4] = { 0 }, lobe = 0, bent = 0;
    ball(&scene.mesh, 160, middle, 1, 0);
    bounds(&scene.mesh);
    if (CHECK(!kit_truth_reflected(&out, &scene, &camera, (float)radius, 1024, 1, &err), "%s", err.text)) {
        const float *const normal = kit_image_channel(&out, "normal"), *const by = kit_image_channel(&out, "bent"),
                    *const narrow = kit_image_channel(&out, "lobe.1");
        for (int i = 0; i < SIZE * SIZE; ++i) {
            mean[0] += (double)out.data[i] / (SIZE * SIZE);
            for (int k = 0; k < 3; ++k) {
                const char *const names[3] = { "white.1", "white.2", "white.3" };
                mean[1 + k] += (double)kit_image_channel(&out, names[k])[i] / (SIZE * SIZE);
            }
            lobe += ((double)narrow[i] - 2 * (double)normal[i] / radius) / (SIZE * SIZE);
            bent = fmax(bent, fabs((double)by[i] - (double)normal[i]));
        }
        CHECK(fabs(mean[0] - open) < 1e-3 && bent < 0.05 && fabs(lobe) < 0.02,
              "visibility %.4f, not %.4f; bent normals off by %.3f, a narrow lobe by %.4f", mean[0], open, bent, lobe);
        for (int k = 0; k < 3; ++k) {
            const double want = open / (1 - (1 - open) * (double)albedos[k]);
            const double fitted = (double)ssgi_interreflected((float)open, albedos[k]);
            CHECK(fabs(mean[1 + k] - want) < 2e-3, "albedo %g: %.4f, not %.4f", (double)albedos[k], mean[1 + k], want);
            CHECK(fabs(fitted - want) < 0.05, "albedo %g: fit %.4f, ball %.4f", (double)albedos[k], fitted, want);
        }
        kit_image_free(&out);
    }
    kit_mesh_free(&scene.mesh);
}

static void threads(void)
{
    static const float p[3] = { -3, 0, -3 }, z[3] = { 0, 0, 6 }, x[3] = { 6, 0, 0 }, middle[3] = { 0, 1, 0 };
    const char *old = getenv("KIT_THREADS");
    char kept[32] = "";
    kit_scene scene = { 0 };
    kit_camera camera = { .eye = { 3, 3, 4 },
                          .target = { 0, 0.5f, 0 },
                          .up = { 0, 1, 0 },
                          .fovy = 40,
                          .width = 61,
                          .height = 47,
                          .depth = KIT_DEPTH_INFINITE };
    kit_image out[3];
    if (old) snprintf(kept, sizeof kept, "%s", old);
    sheet(&scene.mesh, 3, p, z, x);
    ball(&scene.mesh, 20, middle, 1, 0.1f);
    bounds(&scene.mesh);
    int ok = 1;
    for (int k = 0; k < 3; ++k) {
        setenv("KIT_THREADS", k ? "2" : "1", 1);
        ok = ok && !kit_truth_ao(&out[k], &scene, &camera, 1, KIT_ATTENUATION_LINEAR, 16, k == 2 ? 4 : 1, NULL);
    }
    if (old) setenv("KIT_THREADS", kept, 1);
    else unsetenv("KIT_THREADS");
    if (!CHECK(ok, "no truth")) return;
    int shaded = 0, wrong = 0;
    CHECK(!memcmp(out[0].data, out[1].data, 61 * 47 * sizeof(float)), "1 and 2 threads differ");
    for (int i = 0; i < 61 * 47; ++i) {
        const int kept_pixel = i % 61 % 4 == 2 && i / 61 % 4 == 2;
        shaded += out[0].data[i] < 0.99f;
        wrong += kept_pixel ? out[2].data[i] != out[0].data[i] : !isnan(out[2].data[i]);
    }
    CHECK(shaded > 100, "only %d pixels are shaded: no test", shaded);
    CHECK(wrong == 0, "stride 4: %d pixels are neither the full picture's nor NaN where they should be", wrong);
    CHECK(kit_truth_ao(&out[0], &scene, &camera, -1, KIT_ATTENUATION_LINEAR, 16, 1, NULL) == -1,
          "a negative radius passes");
    for (int k = 0; k < 3; ++k) kit_image_free(&out[k]);
    kit_mesh_free(&scene.mesh);
}

/* Every edge of a closed solid is some other triangle's, the other way round; a bit of the picture lies in contact
   shadow. */
static void solids(void)
{
    static const struct { const char *name; size_t boxes; } scenes[] = { { "boxes", 4 }, { "blocks", 13 } };
    for (size_t k = 0; k < sizeof scenes / sizeof *scenes; ++k) {
        kit_scene s;
        kit_image y;
        kit_error err = { "" };
        size_t open_edges = 0, dark = 0, pixels = 64 * 36;
        if (!CHECK(!kit_scene_load(&s, scenes[k].name, 0, &err), "%s", err.text)) return;
        const size_t edges = 3 * s.mesh.triangles;
        CHECK(s.mesh.triangles == 12 * scenes[k].boxes, "%s: %zu triangles", s.name, s.mesh.triangles);
        for (size_t i = 0; i < edges; ++i) {
            int others = 0;
            for (size_t j = 0; j < edges; ++j) {
                const float *a = s.mesh.position + 3 * i, *b = s.mesh.position + 3 * j,
                            *a2 = s.mesh.position + 3 * (i - i % 3 + (i + 1) % 3),
                            *b2 = s.mesh.position + 3 * (j - j % 3 + (j + 1) % 3);
                others += !memcmp(a, b2, 3 * sizeof *a) && !memcmp(a2, b, 3 * sizeof *a);
            }
            open_edges += others != 1;
        }
        CHECK(open_edges == 0, "%s: %zu of %zu edges are not shared by two triangles", s.name, open_edges, edges);
        s.camera.width = 64;
        s.camera.height = 36;
        if (!CHECK(!kit_truth_ao(&y, &s, &s.camera, s.radius, KIT_ATTENUATION_LINEAR, 16, 1, &err), "%s", err.text))
            return;
        for (size_t i = 0; i < pixels; ++i) dark += y.data[i] < 0.8f;
        CHECK(dark > pixels / 50 && dark < pixels / 3, "%s: %zu of %zu pixels lie in contact shadow", s.name, dark,
              pixels);
        t_note("%s: %.1f %% of the picture in contact shadow", s.name, 100.0 * (double)dark / (double)pixels);
        kit_image_free(&y);
        kit_scene_free(&s);
    }
}

/* ray and ball of radius 1: the nearer distance, or 1e30 */
static double ball_hit(const float o[3], const float d[3], const double middle[3])
{
    double b = 0, c = -1;
    for (int i = 0; i < 3; ++i) {
        const double s = (double)o[i] - middle[i];
        b += s * (double)d[i];
        c += s * s;
    }
    return b * b < c ? 1e30 : -b - sqrt(b * b - c);
}

/* Frames worked out by hand: 0 a plane to the horizon, 1 a corner, 2 a corner with its floor seen at a grazing angle, 3
   a ball far before a wall. */
static void floors(void)
{
    enum { W = 96, H = 72 };
    static double expected[W * H];
    for (int k = 0; k < 8; ++k) {
        const int what = k % 4, flat = k / 4;
        kit_camera camera = { .eye = { 4, 3, 2 },
                              .target = { 0.3f, 0.3f, 0 },
                              .up = { 0, 1, 0 },
                              .fovy = flat ? 0.0f : 40.0f,
                              .ortho_height = 3,
                              .width = W,
                              .height = H };
        const float eyes[4][3] = { { 4, 3, 2 }, { 4, 3, 2 }, { 5, 0.9f, 1 }, { 0, 0, 10 } },
                    targets[4][3] = { { 0, 2.8f, 0 }, { 0.3f, 0.3f, 0 }, { 0, 0.5f, 0 }, { 0, 0, 0 } };
        const double middle[3] = { 0, 0, 5 };
        kit_image frame, out;
        kit_error err = { "" };
        float view[16], projection[16];
        memcpy(camera.eye, eyes[what], sizeof camera.eye);
        memcpy(camera.target, targets[what], sizeof camera.target);
        camera.znear = 0.1f, camera.zfar = 100;
        kit_camera_matrices(&camera, view, projection);
        if (!CHECK(!kit_image_new(&frame, W, H, "Z,N.X,N.Y,N.Z", &err), "%s", err.text)) return;
        for (int i = 0; i < W * H; ++i) {
            float o[3], d[3];
            double at[4] = { 0, 0, 0, 1 }, n[4] = { 0, 0, 0, 0 }, v[4];
            int hit = 1;
            kit_camera_ray(&camera, i % W, i / W, o, d);
            expected[i] = 1;
            if (what == 3) {
                const double t = fmin(ball_hit(o, d, middle), (double)(-o[2] / d[2]));
                for (int j = 0; j < 3; ++j) at[j] = (double)o[j] + t * (double)d[j];
                for (int j = 0; j < 3; ++j) n[j] = at[2] > 1 ? at[j] - middle[j] : j == 2;
            } else if (what == 0) {
                hit = d[1] < 0;
                for (int j = 0; j < 3; ++j) at[j] = (double)o[j] - (double)d[j] * (double)o[1] / (double)d[1];
                n[1] = 1;
            } else {
                hit = corner_hit(o, d, at);
                n[hit == 1] = 1;
                if (hit) expected[i] = 1 - corner_occlusion(at[hit == 1 ? 0 : 1], KIT_ATTENUATION_LINEAR);
            }
            transform(view, at, v);
            frame.data[i] = hit ? (float)-v[2] : i & 1 ? INFINITY : 0;
            transform(view, n, v);
            for (int j = 0; j < 3; ++j) frame.data[(j + 1) * W * H + i] = (float)v[j];
            /* what occludes must be in view, a radius around */
            if (what && what < 3 && (i % W < W / 3 || i % W > 2 * W / 3 || i / W < H / 4 || i / W > 3 * H / 4))
                expected[i] = -1;
        }
        const float radius = what == 3 ? 3.5f : what == 0 ? 2 : 0.5f;
        if (what == 1 || what == 2)
            for (int i = 0; i < W * H; ++i)
                if (expected[i] >= 0) {
                    float o[3], d[3];
                    double at[3];
                    kit_camera_ray(&camera, i % W, i / W, o, d);
                    const int hit = corner_hit(o, d, at);
                    expected[i] =
                        hit ? 1 - corner_occlusion(at[hit == 1 ? 0 : 1] / (double)radius, KIT_ATTENUATION_LINEAR) : -1;
                }
        if (CHECK(!kit_floor_ao(&out, &frame, &camera, radius, KIT_ATTENUATION_LINEAR,
                                what == 1 || what == 2 ? 128 : 32, 1, &err),
                  "%s", err.text)) {
            static const char *const names[4] = { "floor: a plane to the horizon", "floor: a corner",
                                                  "floor: a corner at a grazing angle",
                                                  "floor: a ball far before a wall" };
            compare(names[what], &out, expected, what == 0 || what == 3 ? 0 : 0.015, what == 0 || what == 3 ? 0 : 0.1);
            kit_image_free(&out);
        }
        kit_image_free(&frame);
    }
}

void test_trace(void)
{
    RUN("the tree finds what brute force finds, among broken, huge and doubled triangles", against_brute_force);
    RUN("triangles that coincide or shrink without end are all found", deep_trees);
    RUN("no ray slips between triangles that share an edge", no_cracks);
    RUN("bad arguments are named and leave everything as it was", bad_arguments);
    RUN("camera rays and matrices agree, in every depth layout", cameras);
    RUN("visibility of points: corner, wall and groove are their closed forms, by the point alone", visibility);
    RUN("a ball's own corners and faces are open, from within closed; bad arguments are named", own_visibility);
    RUN("truth: a bare plane is exactly open", bare_plane);
    RUN("truth: a corner agrees with its closed form", corner);
    RUN("truth: a corner under windows and under lamps of a few texels is what all directions sum to", lit_corner);
    RUN("truth: a ball on a plane agrees with its closed form", ball_on_plane);
    RUN("truth: within a ball reflections are a series, a narrow lobe is a chord", inside_a_ball);
    RUN("truth: the number of threads changes nothing, stride leaves pixels out", threads);
    RUN("boxes and blocks are closed solids with shadows at their feet", solids);
    RUN("floor: planes are open, creases closed, silhouettes cut", floors);
}
