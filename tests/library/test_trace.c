/* test_trace.c - the tracer against brute force; the ray-traced truth and its floor against closed forms. */
#include "t.h"
#include "frames.h"
#include "kit/kit_build.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static kit_error err;

static void own_kit_build(kit_build *b) { kit_scene_free(&b->scene); }

static int build(ssgi_trace *trace, void **memory, const float *position, size_t triangles)
{
    const size_t size = ssgi_trace_size(triangles);
    *memory = malloc(size + 1);
    return CHECK(*memory, "no memory for %zu triangles", triangles)
           && T_OK(ssgi_trace_build, trace, (char *)*memory + 1, size, position, 3 * sizeof(float), NULL, triangles);
}

/* Returns triangle c's distance in double, or -1. wide: how far beyond an edge, in weight, still hits. */
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
    FREED void *memory = NULL;
    int hits = 0;
    t_seed(1);
    for (int t = 0; t < SOUP; ++t) {
        const float size = expf(t_uniform(-5, 0));
        for (int k = 0; k < 3; ++k)
            for (int i = 0; i < 3; ++i)
                soup[t][3 * k + i] = (k ? soup[t][i] : t_uniform(-1, 1)) + (k ? t_uniform(-size, size) : 0);
        if (t % 50 == 1) soup[t][t % 9] = NAN;
        if (t % 50 == 2) soup[t][t % 9] = t & 1 ? INFINITY : -2e12f;
        /* two equal corners */
        if (t % 50 == 3) memcpy(&soup[t][3], soup[t], 3 * sizeof(float));
        if (t % 50 == 4) for (int i = 0; i < 3; ++i) soup[t][6 + i] = soup[t][i];
        if (t % 50 == 5) memcpy(soup[t], soup[t - 5], sizeof soup[t]);                          /* an equal triangle */
        /* huge, below the others */
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
        CHECK(found || (sure > 1e29 && hit.t == -1), "ray %d: the hit at %g was missed, or one written", r, sure);
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
}

/* Checks nested shells, each smaller by a factor, which a split by area would peel off singly. Then thousands of equal
   ones. */
static void deep_trees(void)
{
    enum { SHELLS = 6000, SAME = 20000 };
    FREED float *soup = malloc((SHELLS + SAME) * 9 * sizeof *soup);
    ssgi_trace trace;
    FREED void *memory = NULL, *again = NULL;
    for (int t = 0; t < SHELLS; ++t) {
        const float s = powf(10, 10 - 24.0f * (float)t / SHELLS), c[9] = { s, -s, -s, s, s, -s, s, 0, s };
        memcpy(soup + 9 * t, c, sizeof c);
    }
    for (int t = 0; t < SAME; ++t) {
        const float c[9] = { -1, -1, -1, -1, 1, -1, -1, 0, 1 };
        memcpy(soup + 9 * (SHELLS + t), c, sizeof c);
    }
    if (!build(&trace, &memory, soup, SHELLS + SAME)) return;
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
    for (int i = 0; i < 9 * SAME; ++i) soup[i] = NAN;
    if (build(&trace, &again, soup, SAME))
        CHECK(!ssgi_trace_any(&trace, o, back, 0, 2), "nothing but bad triangles, and a hit");
}

static void sizes(void)
{
    static const float p[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 0 };
    const size_t size = ssgi_trace_size(1);
    struct {
        ssgi_trace trace;
        unsigned char memory[2048];
    } o, was;
    if (!CHECK(size > 0 && size <= sizeof o.memory, "one triangle needs %zu bytes", size)) return;
    memset(&was, 0x5a, sizeof was);
    o = was;
    T_REFUSED(ssgi_trace_build(&o.trace, o.memory, size - 1, p, 12, NULL, 1, &why), SSGI_TOO_SMALL, "size", o, was);
    CHECK(ssgi_trace_size(0) == 0 && ssgi_trace_size((size_t)-1) == 0, "sizes that cannot be have a size");
    /* the stated size must suffice: nothing is written beyond it, for rows with full nodes (512) and for others */
    for (size_t n = 1; n <= 512; ++n) {
        static float soup[512][9];
        for (size_t t = 0; t < n; ++t)
            for (int i = 0; i < 9; ++i) soup[t][i] = p[i] + (i % 3 ? 0 : (float)(n % 2 ? t * t : t));
        const size_t all = ssgi_trace_size(n);
        FREED unsigned char *exact = malloc(all + 64);
        if (!exact) return;
        memset(exact, 0x5a, all + 64);
        CHECK(ssgi_trace_build(&o.trace, exact, all, soup[0], 12, NULL, n, NULL) == SSGI_OK
                  && !memcmp(exact + all, was.memory, 64),
              "%zu triangles: more than %zu bytes were written, or none", n, all);
    }
}

/* ---- ssgi_trace_visibility ------------------------------------------------------------------------------------- */

/* Returns closed forms for points on a floor at y = 0, x from 0 to 1: beside an endless wall, attenuated and not; a
   wall of height 1; a groove of width 1 and depth 1. The sheets are so long that their ends do not count. */
static double closed_form(int shape, double x)
{
    const double wall = (1 - x / sqrt(x * x + 1)) / 2;
    if (shape < 2) return shape ? hard_corner(x) : linear_corner(x);
    return shape == 2 ? wall : wall + (1 - (1 - x) / sqrt((1 - x) * (1 - x) + 1)) / 2;
}

/* Adds a wall at x, up from y = 0 and along z. */
static void wall(kit_build *b, double x, double height, double half)
{
    const double corner[4][3] = { { x, 0, half }, { x, 0, -half }, { x, height, -half }, { x, height, half } };
    kit_quad(b, corner);
}

static void visibility(void)
{
    enum { POINTS = 400, SHAPES = 4 };
    static float position[3 * POINTS], normal[3 * POINTS], out[POINTS], other[POINTS];
    for (int shape = 0; shape < SHAPES; ++shape) {
        /* RMSE by 256 and 1024 rays; random rays would have 0.03 and 0.015 at a hard wall */
        static const double rms[SHAPES][2] = { { 7e-4, 2e-4 }, { 5e-3, 1.7e-3 }, { 6e-3, 2.2e-3 }, { 8e-3, 3.3e-3 } };
        OWN(kit_build) b = { .turn = 0 };
        ssgi_trace trace;
        FREED void *memory = NULL;
        kit_level(&b, -100, -100, 100, 100, 0);
        for (int side = 0; side < (shape == 3 ? 2 : 1); ++side) wall(&b, side, shape < 2 ? 100 : 1, 100);
        if (!build(&trace, &memory, b.scene.mesh.position, b.scene.mesh.triangles)) return;
        for (int i = 0; i < POINTS; ++i) {
            const float p[3] = { ((float)i + 0.5f) / POINTS, 0, 3 * sinf((float)i) }, n[3] = { 0, 0.5f, 0 };
            memcpy(position + 3 * i, p, sizeof p);
            memcpy(normal + 3 * i, n, sizeof n);
        }
        for (int r = 0; r < 2; ++r) {
            double square = 0, worst = 0, sum = 0;
            if (!T_OK(ssgi_trace_visibility, out, &trace, position, normal, POINTS, shape < 2 ? 1.0f : 0.0f,
                      256 << 2 * r, shape > 0))
                return;
            for (int i = 0; i < POINTS; ++i) {
                const double off = 1 - (double)out[i] - closed_form(shape, (double)position[3 * i]);
                square += off * off / POINTS;
                sum += off / POINTS;
                worst = fmax(worst, fabs(off));
            }
            SHOW(sqrt(square) < rms[shape][r] && worst < 4 * rms[shape][r] && fabs(sum) < 0.1 * rms[shape][r],
                 "shape %d, %d rays: RMS %.5f, worst %.4f, mean %.5f", shape, 256 << 2 * r, sqrt(square), worst, sum);
        }
        /* a part of the points in reverse order must have the same values */
        for (int i = POINTS / 2; i < POINTS; ++i)
            memcpy(position + 3 * i, position + 3 * (POINTS - 1 - i), 3 * sizeof(float));
        ssgi_trace_visibility(other, &trace, position + 3 * POINTS / 2, normal, POINTS / 2, shape < 2 ? 1.0f : 0.0f,
                              1024, shape > 0, NULL);
        CHECK(other[0] == out[POINTS / 2 - 1] && other[9] == out[POINTS / 2 - 10],
              "shape %d: a point's value depends on its place", shape);
    }
}
static void own_visibility(void)
{
    static const double radius = 2;
    static const float none[6] = { 0, 0, 0, NAN, 1, 0 };
    OWN(kit_build) b = { .at = { 300, -20, 5 } };
    kit_patch(&b, 40, 20, kit_sphere_surface, &radius);
    kit_mesh *m = &b.scene.mesh;
    const size_t corners = 3 * m->triangles;
    FREED float *out = malloc(corners * sizeof *out), *middle = malloc(corners * sizeof *middle);
    float bad[2] = { 7, 7 };
    double least[2] = { 1, 1 }, most = 0;
    ssgi_trace trace;
    FREED void *memory = NULL;
    if (!out || !middle || !build(&trace, &memory, m->position, m->triangles)) return;
    ssgi_trace_visibility(out, &trace, m->position, m->normal, corners, 0, 64, 1, NULL);
    for (size_t i = 0; i < corners; ++i) least[0] = fmin(least[0], (double)out[i]);
    for (size_t i = 0; i < 3 * corners; ++i) m->normal[i] = -m->normal[i];
    ssgi_trace_visibility(out, &trace, m->position, m->normal, corners, 0, 64, 1, NULL);
    for (size_t i = 0; i < corners; ++i) most = fmax(most, (double)out[i]);
    /* aims at middles of faces, which rounding puts on either side */
    for (size_t t = 0; t < m->triangles; ++t) {
        const float *c = m->position + 9 * t;
        for (size_t i = 0; i < 3; ++i) {
            const size_t j = (i + 1) % 3, k = (i + 2) % 3;
            middle[3 * t + i] = (c[i] + c[3 + i] + c[6 + i]) / 3;
            m->normal[3 * t + i] =
                (c[3 + j] - c[j]) * (c[6 + k] - c[k]) - (c[3 + k] - c[k]) * (c[6 + j] - c[j]);
        }
    }
    ssgi_trace_visibility(out, &trace, middle, m->normal, m->triangles, 0, 64, 1, NULL);
    for (size_t t = 0; t < m->triangles; ++t) least[1] = fmin(least[1], (double)out[t]);
    CHECK(!(least[0] < 1) && !(least[1] < 1) && most < 0.02,
          "of a ball's corners %g is seen, of faces' middles %g, of corners from within %g", least[0], least[1], most);
    CHECK(ssgi_trace_visibility(bad, &trace, m->position, none, 2, 1, 16, 0, NULL) == SSGI_OK && bad[0] == 1
              && bad[1] == 1,
          "no normal, and one that is not finite: %g, %g", (double)bad[0], (double)bad[1]);
}

/* ---- truth and floor ------------------------------------------------------------------------------------------- */

/* expected < 0: the pixel does not count */
static void compare(const char *name, const kit_image *y, const double *expected, double rmse, double most)
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
    CHECK(n > y->width * y->height / 10, "%s: only %d pixels count", name, n);
    CHECK(found <= rmse && worst <= most, "%s: RMSE %.4f (at most %.4f), worst pixel %.4f (at most %.4f)", name, found,
          rmse, worst, most);
    t_note("%s: RMSE %.5f, worst pixel %.4f", name, found, worst);
}

/* Scenes: a sheet far from 0; floor and wall; a ball that rests on a plane. */
enum { SHEET, CORNER, RESTING };

static kit_scene built(int what)
{
    static const double radius = 1,
                        sheet[4][3] = { { 100, 200, -50 }, { 107, 203, -52 }, { 108, 199, -46 }, { 101, 196, -44 } };
    kit_build b = { .turn = 0 };
    if (what == SHEET) kit_sheet(&b, sheet, KIT_CUTS(kit_both), KIT_CUTS(kit_both));
    if (what == CORNER) {
        kit_level(&b, 0, -50, 50, 50, 0);
        wall(&b, 0, 50, 50);
    }
    if (what == RESTING) {
        kit_level(&b, -30, -30, 30, 30, 0);
        kit_place_at(&b, 0, 1, 0, 0);
        kit_patch(&b, 200, 100, kit_sphere_surface, &radius);
    }
    kit_mesh_bounds(&b.scene.mesh);
    return b.scene;
}

/* Returns the plane that a ray meets first: 1 floor, 2 wall, 0 none; at: the distance from the other plane */
static int corner_hit(const float o[3], const float d[3], double *at)
{
    const double down = d[1] < 0 ? (double)-o[1] / (double)d[1] : 1e30,
                 side = d[0] < 0 ? (double)-o[0] / (double)d[0] : 1e30, t = fmin(down, side);
    const int across = down < side ? 0 : 1;
    *at = (double)o[across] + t * (double)d[across];
    return t > 40 ? 0 : 1 + across;
}

/* Returns the visibility of the point that a pixel's ray meets; below 0: it has no closed form. */
static double expected_of(int what, const float o[3], const float d[3], int hard)
{
    double c = 1, u[2];
    if (what == SHEET) return 1;
    if (what == CORNER) return !corner_hit(o, d, &c) ? -1 : c >= 1 ? 1 : 1 - (hard ? hard_corner(c) : linear_corner(c));
    for (int k = 0; k < 2; ++k) u[k] = (double)(o[2 * k] - d[2 * k] / d[1] * o[1]);
    const double square = u[0] * u[0] + u[1] * u[1];
    return square < 1.02 ? -1 : 1 - pow(1 + square, -1.5);
}

static void closed_forms(void)
{
    /* from: the first of 0 to 3 with a closed form: linear in perspective, linear orthographic, hard in perspective,
       hard orthographic */
    static const struct { const char *name; kit_camera camera; float radius; int rays, from; double rmse, most;
    } row[] = {
        { "a bare plane", { .eye = { 104.0548f, 199.2587f, -48.17f }, .target = { 104.4f, 199.45f, -47.8f },
                            .up = { 0, 1, 0 }, .fovy = 60, .ortho_height = 2, .width = 48, .height = 32 },
          2, 64, 0, 0, 0 },
        { "a corner", { .eye = { 4, 3, 2 }, .target = { 0.3f, 0.3f, 0 }, .up = { 0, 1, 0 }, .fovy = 40,
                        .ortho_height = 4, .width = 80, .height = 60 },
          1, 256, 0, 0.004, 0.02 },
        { "a ball resting on a plane", { .eye = { 0, 5, 0 }, .up = { 0, 0, -1 }, .ortho_height = 7, .width = 64,
                                         .height = 64 },
          1000, 512, 3, 0.004, 0.02 }
    };
    for (int i = 0; i < ROWS(row); ++i) {
        OWN(kit_scene) scene = built(i);
        for (int k = row[i].from; k < 4; ++k) {
            static double expected[80 * 60];
            const int hard = k >> 1;
            kit_camera c = row[i].camera;
            OWN(kit_image) out = { 0 }, some = { 0 };
            int wrong = 0;
            char name[64];
            if (k & 1) c.fovy = 0;
            for (int p = 0; p < c.width * c.height; ++p) {
                float o[3], d[3];
                kit_camera_ray(&c, p % c.width, p / c.width, o, d);
                expected[p] = expected_of(i, o, d, hard);
            }
            if (!TRY(kit_truth_ao(&out, &scene, &c, row[i].radius, hard, row[i].rays, 1, &err))) return;
            snprintf(name, sizeof name, "%s, %d rays, %s", row[i].name, row[i].rays, hard ? "hard" : "linear");
            compare(name, &out, expected, row[i].rmse, row[i].most);
            if (!TRY(kit_truth_ao(&some, &scene, &c, row[i].radius, hard, row[i].rays, 4, &err))) return;
            for (int p = 0; p < c.width * c.height; ++p)
                wrong += p % c.width % 4 == 2 && p / c.width % 4 == 2 ? some.data[p] != out.data[p]
                                                                      : !isnan(some.data[p]);
            CHECK(!wrong, "%s, stride 4: %d pixels are neither the full picture's nor NaN", name, wrong);
        }
    }
}

/* Returns irradiance over pi (green) on the corner's floor or wall at a distance from the other: a sum over a grid of
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

/* environments: street has lamps, each with a ray; windows has none as bright. bounce 1: all rays are random. */
static void lit_corner(void)
{
    static const struct { const char *env; int rays, bounce; double noise;
    } row[] = { { "street", 256, 0, 0.005 }, { "street", 4096, 1, 0.006 }, { "windows", 512, 0, 0.012 } };
    enum { WIDE_ = 4, HIGH_ = 3, PIXELS = WIDE_ * HIGH_ };
    const kit_camera camera = { .eye = { 4, 3, 2 }, .target = { 0.5f, 0.5f, 0 }, .up = { 0, 1, 0 },
                                .ortho_height = 2.4f, .width = WIDE_, .height = HIGH_ };
    OWN(kit_scene) scene = built(CORNER);
    double expected[PIXELS], level = 0;
    for (int k = 0; k < ROWS(row); ++k) {
        OWN(kit_lighting) l = { 0 };
        OWN(kit_image) out = { 0 };
        double off = 0, bias = 0;
        if (!lighten(&l, row[k].env, NULL)) return;
        if (k != 1) level = 0;                             /* the second light keeps the first one's sky */
        for (int i = 0; i < PIXELS && k != 1; ++i) {
            float o[3], d[3];
            double at;
            kit_camera_ray(&camera, i % WIDE_, i / WIDE_, o, d);
            const int plane = corner_hit(o, d, &at);
            expected[i] = corner_light(&l.env, plane == 1, at);
            level += expected[i] / PIXELS;
        }
        if (!TRY(kit_truth_lit(&out, &scene, &camera, &l, 1, KIT_ATTENUATION_LINEAR, row[k].bounce, row[k].rays, 1,
                               &err)))
            return;
        for (int i = 0; i < PIXELS; ++i) {
            const double e = ((double)kit_image_channel(&out, "irradiance.G")[i] - expected[i]) / level;
            off += e * e / PIXELS;
            bias += e / PIXELS;
        }
        SHOW(sqrt(off) < row[k].noise && fabs(bias) < 0.4 * row[k].noise,
             "%s, %d rays: off by %.4f of the mean, bias %+.4f", row[k].env, row[k].rays, sqrt(off), bias);
    }
}

/* Checks a ball, in which a chord is 2 r cos long, by its angle to the normal, and the next chord does not depend on
   it. With linear attenuation visibility is 4 r / (3 R), reflections are a geometric series, and a narrow lobe sees
   hardly more than the chord of the mirrored view. */
static void inside_a_ball(void)
{
    enum { SIZE = 8 };
    static const float albedos[3] = KIT_REFLECTED_ALBEDOS;
    static const double one = 1, radius = 3;
    const double open = 4 / (3 * radius);
    const kit_camera camera = { .eye = { 0.3f, 0.1f, 0.2f }, .target = { 1, 0.2f, 0 }, .up = { 0, 1, 0 }, .fovy = 60,
                                .znear = 0.01f, .zfar = 10, .width = SIZE, .height = SIZE };
    OWN(kit_build) b = { .turn = 0 };
    OWN(kit_image) out = { 0 };
    double lobe = 0, bent = 0;
    kit_patch(&b, 320, 160, kit_sphere_surface, &one);
    kit_mesh_bounds(&b.scene.mesh);
    if (!TRY(kit_truth_reflected(&out, &b.scene, &camera, (float)radius, 1024, 1, &err))) return;
    const float *const normal = kit_image_channel(&out, "normal"), *const by = kit_image_channel(&out, "bent"),
                *const narrow = kit_image_channel(&out, "lobe.1");
    for (int i = 0; i < SIZE * SIZE; ++i) {
        lobe += ((double)narrow[i] - 2 * (double)normal[i] / radius) / (SIZE * SIZE);
        bent = fmax(bent, fabs((double)by[i] - (double)normal[i]));
    }
    CHECK(fabs(mean(&out, "Y") - open) < 1e-3 && bent < 0.05 && fabs(lobe) < 0.02,
          "visibility %.4f, not %.4f; bent normals off by %.3f, a narrow lobe by %.4f", mean(&out, "Y"), open, bent,
          lobe);
    for (int k = 0; k < 3; ++k) {
        static const char *const names[3] = { "white.1", "white.2", "white.3" };
        const double want = open / (1 - (1 - open) * (double)albedos[k]), is = mean(&out, names[k]),
                     fitted = (double)ssgi_interreflected((float)open, albedos[k]);
        CHECK(fabs(is - want) < 2e-3 && fabs(fitted - want) < 0.05, "albedo %g: %.4f, fit %.4f, not %.4f",
              (double)albedos[k], is, fitted, want);
    }
}

/* Checks the floor on planes through (0, 0, -8), at an angle to the viewer. A square in front of one is too far away to
   be joined to it or to occlude it. Occluders must be in view, a radius around. */
static void floors(void)
{
    enum { W = 96, H = 72 };
    static const struct { const char *name; int planes; double angle; float radius; int rays, square; double rmse, most;
    } row[] = { { "floor: a plane to the horizon", 1, 12, 2, 32, 0, 0, 0 },
                { "floor: a corner", 2, 45, 1, 128, 0, 0.015, 0.1 },
                { "floor: a corner at a grazing angle", 2, 12, 1, 128, 0, 0.015, 0.1 },
                { "floor: a square far before a wall", 1, 90, 3.5f, 32, 1, 0, 0 } };
    for (int k = 0; k < 2 * ROWS(row); ++k) {
        static double expected[W * H];
        const int i = k / 2;
        const double a = row[i].angle * KIT_PI / 180, n[2][4] = { { 0, cos(a), sin(a), -8 * sin(a) },
                                                                 { 0, -sin(a), cos(a), -8 * cos(a) } };
        kit_camera camera = looking_along_z(W, H, k & 1);
        OWN(kit_image) frame = { 0 }, out = { 0 };
        ssgi_view view;
        camera.ortho_height = 6;
        if (!view_of(&view, &camera, 0) || !planes_seen(&frame, &camera, n, row[i].planes, "")) return;
        for (int p = 0; p < W * H; ++p) {
            const int x = p % W, y = p / W, middle = x > W / 3 && x < 2 * W / 3 && y > H / 4 && y < 3 * H / 4;
            float at[3];
            if (row[i].square && middle) frame.data[p] = 3;
            ssgi_view_position(at, &view, (float)x + 0.5f, (float)(H - 1 - y) + 0.5f, frame.data[p]);
            double c = 1;
            for (int j = 0; j < row[i].planes && row[i].planes > 1; ++j) {
                const double off = kit_dot(n[j], (const double[3]){ (double)at[0], (double)at[1], (double)at[2] })
                                   - n[j][3];
                c = fmin(c, off > 1e-4 ? off / (double)row[i].radius : 1);
            }
            expected[p] = row[i].planes > 1 && !middle ? -1 : c < 1 ? 1 - linear_corner(c) : 1;
        }
        if (!TRY(kit_floor_ao(&out, &frame, &camera, row[i].radius, KIT_ATTENUATION_LINEAR, row[i].rays, 1, &err)))
            return;
        compare(row[i].name, &out, expected, row[i].rmse, row[i].most);
    }
}

void test_trace(void)
{
    RUN("the tree finds what brute force finds, among broken, huge and doubled triangles", against_brute_force);
    RUN("triangles that coincide or shrink without end are all found", deep_trees);
    RUN("memory of the size that is asked for suffices, and a byte less is refused", sizes);
    RUN("visibility of points: corner, wall and groove are their closed forms, by the point alone", visibility);
    RUN("a ball's own corners and faces are open, from within closed", own_visibility);
    RUN("truth: a bare plane is exactly open; a corner and a ball on a plane agree with their closed forms, "
        "pixel by pixel",
        closed_forms);
    RUN("truth: a corner under windows and under lamps of a few texels is what all directions sum to", lit_corner);
    RUN("truth: within a ball reflections are a series, a narrow lobe is a chord", inside_a_ball);
    RUN("floor: planes are open, creases closed, silhouettes cut", floors);
}
