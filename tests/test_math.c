/* test_math.c - ssgi.h's rooms of view, bias, kernel, sh and environment against double precision and closed forms. */
#include "t.h"
#include "ssgi.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846
#define NAMES(why, start) (strncmp(why, start, strlen(start)) == 0)

/* ---- >>view ------------------------------------------------------------------------------------------------------ */

typedef struct layout { const char *name; int clip, ortho, reversed; double m10, m14; } layout;
enum { LAYOUTS = 9 };

static layout layout_at(int i, double n, double f)
{
    const layout all[LAYOUTS] = { { "GL", SSGI_CLIP_GL, 0, 0, -(f + n) / (f - n), -2 * f * n / (f - n) },
                                  { "GL, infinite", SSGI_CLIP_GL, 0, 0, -1, -2 * n },
                                  { "GL, reversed", SSGI_CLIP_GL, 0, 1, (f + n) / (f - n), 2 * f * n / (f - n) },
                                  { "zero", SSGI_CLIP_ZERO, 0, 0, -f / (f - n), -f * n / (f - n) },
                                  { "zero, reversed", SSGI_CLIP_ZERO, 0, 1, n / (f - n), f * n / (f - n) },
                                  { "zero, reversed, infinite", SSGI_CLIP_ZERO, 0, 1, 0, n },
                                  { "orthographic GL", SSGI_CLIP_GL, 1, 0, -2 / (f - n), -(f + n) / (f - n) },
                                  { "orthographic zero", SSGI_CLIP_ZERO, 1, 0, -1 / (f - n), -n / (f - n) },
                                  { "orthographic zero, reversed", SSGI_CLIP_ZERO, 1, 1, 1 / (f - n), f / (f - n) } };
    return all[i];
}

/* off-centre; y down in every other layout; scaled as a whole in every third */
static void matrix(float m[16], const layout *l, int i)
{
    const float c = i % 3 ? 1.0f : 2.0f;
    const float perspective[16] = { 1.3f * c,
                                    0,
                                    0,
                                    0,
                                    0,
                                    (i & 1 ? -2.1f : 2.1f) * c,
                                    0,
                                    0,
                                    0.07f * c,
                                    -0.03f * c,
                                    (float)l->m10 * c,
                                    -c,
                                    0,
                                    0,
                                    (float)l->m14 * c,
                                    0 };
    memcpy(m, perspective, sizeof perspective);
    if (l->ortho) { m[12] = m[8]; m[13] = m[9]; m[15] = c; m[8] = m[9] = m[11] = 0; }
}

static void views(void)
{
    static const double eyes[] = { 0, 1e5, -1, -50 },     /* how much farther away orthographic eyes stand */
                        units[] = { 1, 1e-6, 1e-17, 1e9 }; /* what others see */
    for (int e = 0; e < 4 * LAYOUTS; ++e) {
        const int i = e / 4, flat = layout_at(i, 1, 100).ortho;
        const double n = flat ? 1 + eyes[e % 4] : units[e % 4], f = flat ? 100 + eyes[e % 4] : 100 * units[e % 4];
        const layout l = layout_at(i, n, f);
        const double depths[3] = { n, 0.5 * (n + f), 0.51 * n + 0.49 * f };
        const float nothing[] = { l.reversed ? 0.0f : 1.0f, NAN, INFINITY, -INFINITY, -0.5f, -1e-30f, 1.5f };
        const char *why = "";
        float m[16];
        ssgi_view view;
        matrix(m, &l, i);
        if (!CHECK(ssgi_view_from_projection(&view, m, l.clip, 1920, 1080, &why) == SSGI_OK, "%s: %s", l.name, why))
            continue;
        CHECK(view.orthographic == l.ortho && view.clear == nothing[0] && view.width == 1920 && view.height == 1080,
              "%s: orthographic %d, clear %g", l.name, view.orthographic, (double)view.clear);
        for (size_t k = 0; k < 3; ++k) {                 /* the matrix as given, in double; window depth as a float */
            const double z = depths[k], w = (double)m[11] * -z + (double)m[15],
                         ndc = ((double)m[10] * -z + (double)m[14]) / w;
            const float window = (float)fmin(fmax(l.clip == SSGI_CLIP_GL ? 0.5 * ndc + 0.5 : ndc, 0), 1);
            const double a = fabs((double)view.depth[0]), b = fabs((double)view.depth[1] * (double)window);
            /* roundings of window depth and of the sum's terms: the layout's own cost */
            const double lost = 1.2e-7 * fmax(a, b), within = l.ortho ? lost : z * z * lost;
            CHECK(fabs((double)ssgi_view_depth(&view, window) - z) <= 1e-6 * fabs(z) + within, "%s: depth %.9g of %g",
                  l.name, (double)ssgi_view_depth(&view, window), z);
            if (l.reversed && !l.ortho && l.clip == SSGI_CLIP_ZERO)
                CHECK(within <= 1e-6 * z, "%s: reversed depth loses %g", l.name, within);
        }
        for (size_t k = 0; k < sizeof nothing / sizeof nothing[0]; ++k)
            CHECK(ssgi_view_depth(&view, nothing[k]) == SSGI_FAR, "%s: window depth %g gives %g", l.name,
                  (double)nothing[k], (double)ssgi_view_depth(&view, nothing[k]));
        for (int k = 0; k < 2000; ++k) {
            const float pixel[2] = { t_uniform(-100, 2020), t_uniform(-100, 1180) }, z = expf(t_uniform(-3, 8));
            float p[3], back[3];
            ssgi_view_position(p, &view, pixel[0], pixel[1], z);
            ssgi_view_project(back, &view, p);
            for (int c = 0; c < 2; ++c) {
                const double w = (double)m[11] * (double)p[2] + (double)m[15],
                             clip =
                                 (double)m[c * 5] * (double)p[c] + (double)m[8 + c] * (double)p[2] + (double)m[12 + c];
                const double by_matrix = (0.5 * clip / w + 0.5) * (c ? 1080 : 1920), was = (double)pixel[c];
                CHECK(fabs(by_matrix - was) < 1e-3 && fabs((double)back[c] - was) < 1e-3,
                      "%s: pixel %.6g, by the matrix %.9g, back %.9g", l.name, was, by_matrix, (double)back[c]);
            }
            CHECK(p[2] == -z && back[2] == z, "%s: depth %g became %g", l.name, (double)z, (double)back[2]);
        }
    }
}

static void bad_views(void)
{
    static const struct { int at; float value; const char *what;
    } wrong[] = { { 0, NAN, "not finite" }, { 14, INFINITY, "not finite" }, { 11, 0, "no w" },
                  { 3, 0.1f, "w of x" },    { 7, 0.1f, "w of y" },          { 15, 1, "w of both" },
                  { 1, 0.1f, "rolled" },    { 4, 0.1f, "rolled" },          { 0, 0, "flat" },
                  { 5, 0, "flat" },         { 14, 0, "no depth" },          { 14, 1e-42f, "too small" },
                  { 0, 1e-42f, "too small" } };
    float good[16], m[16];
    const layout l = layout_at(0, 1, 100);
    ssgi_view view, was;
    const char *why = "";
    memset(&was, 0x5a, sizeof was);
    view = was;
    matrix(good, &l, 1);
    for (size_t i = 0; i < sizeof wrong / sizeof wrong[0]; ++i) {
        memcpy(m, good, sizeof m);
        m[wrong[i].at] = wrong[i].value;
        why = "";
        CHECK(ssgi_view_from_projection(&view, m, SSGI_CLIP_GL, 64, 64, &why) == SSGI_BAD_ARGUMENT
                  && NAMES(why, "projection:"),
              "%s, element %d: \"%s\"", wrong[i].what, wrong[i].at, why);
    }
#define REFUSED(start, ...) \
    CHECK(ssgi_view_from_projection(__VA_ARGS__, NULL) == SSGI_BAD_ARGUMENT \
              && ssgi_view_from_projection(__VA_ARGS__, &why) == SSGI_BAD_ARGUMENT && NAMES(why, start), \
          "%s \"%s\"", start, why)
    REFUSED("view:", NULL, good, 0, 64, 64);
    REFUSED("projection:", &view, NULL, 0, 64, 64);
    for (int k = 0; k < 2; ++k) {
        REFUSED("clip:", &view, good, k ? 2 : -1, 64, 64);
        REFUSED("width:", &view, good, 0, k ? 0 : 65537, 64);
        REFUSED("height:", &view, good, 0, 64, k ? -1 : 65537);
    }
    CHECK(!memcmp(&view, &was, sizeof view), "a refused projection changed the view");
}

static void direction(float d[3])
{
    const float z = t_uniform(-1, 1), a = t_uniform(0, 6.2831853f), r = sqrtf(1 - z * z);
    d[0] = r * cosf(a); d[1] = r * sinf(a); d[2] = z;
}

static double dot(const float *a, const float *b)
{
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

/* Camera axes as a rigid matrix: z any direction, turned about it by chance. */
static void rigid(float m[16], const float z[3])
{
    float x[3], y[3], aside[3];
    double length;
    do { direction(aside); } while (fabs(dot(aside, z)) > 0.9);
    for (int k = 0; k < 3; ++k) x[k] = aside[(k + 1) % 3] * z[(k + 2) % 3] - aside[(k + 2) % 3] * z[(k + 1) % 3];
    length = sqrt(dot(x, x));
    for (int k = 0; k < 3; ++k) x[k] = (float)((double)x[k] / length);
    for (int k = 0; k < 3; ++k) y[k] = z[(k + 1) % 3] * x[(k + 2) % 3] - z[(k + 2) % 3] * x[(k + 1) % 3];
    for (int k = 0; k < 3; ++k) {
        m[4 * k] = x[k];
        m[4 * k + 1] = y[k];
        m[4 * k + 2] = z[k];
        m[4 * k + 3] = 0;
        m[12 + k] = t_uniform(-5, 5);
    }
    m[15] = 1;
}

static void through(const float m[16], const float p[3], float w, float out[3])
{
    for (int i = 0; i < 3; ++i) out[i] = m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i] * w;
}

/* Left-handed: z is all that changes. Oblique: what the matrix, in double, makes of a point comes back. */
static void engines_views(void)
{
    for (int i = 0; i < LAYOUTS; ++i) {
        const layout l = layout_at(i, 1, 100);
        float m[16], last[16];
        ssgi_view right, left, view;
        int seen = 0;
        matrix(m, &l, i);
        memcpy(last, m, sizeof m);
        for (int k = 8; k < 12; ++k) last[k] = -last[k];
        if (!CHECK(ssgi_view_from_projection(&right, m, l.clip, 1920, 1080, NULL) == SSGI_OK
                       && ssgi_view_from_projection(&left, last, l.clip, 1920, 1080, NULL) == SSGI_OK,
                   "%s, left-handed: refused", l.name))
            continue;
        CHECK(!memcmp(&left, &right, sizeof left), "%s: left-handed is another view", l.name);
        m[2] = 0.2f * m[0];
        m[6] = -0.3f * m[0];
        if (!CHECK(ssgi_view_from_projection(&view, m, l.clip, 1920, 1080, NULL) == SSGI_OK, "%s, oblique: refused",
                   l.name))
            continue;
        for (int k = 0; k < 2000; ++k) {
            const float pixel[2] = { t_uniform(0, 1920), t_uniform(0, 1080) }, z = expf(t_uniform(-1, 5));
            float p[3];
            ssgi_view_position(p, &right, pixel[0], pixel[1], z);
            const double w = (double)m[11] * (double)p[2] + (double)m[15],
                         clip = (double)m[2] * (double)p[0] + (double)m[6] * (double)p[1]
                                + (double)m[10] * (double)p[2] + (double)m[14],
                         window = l.clip == SSGI_CLIP_GL ? 0.5 * clip / w + 0.5 : clip / w;
            if (window <= 0 || window >= 1 || (float)window == view.clear) continue;
            const double x = fabs((double)pixel[0] * (double)view.oblique[0]),
                         y = fabs((double)pixel[1] * (double)view.oblique[1]),
                         lost = 3e-7 * (fabs((double)view.depth[0]) + fabs((double)view.depth[1]) * (1 + x + y)),
                         back = (double)ssgi_view_depth_at(&view, pixel[0], pixel[1], (float)window);
            CHECK(fabs(back - (double)z) <= (l.ortho ? lost : (double)z * fmax(back, (double)z) * lost),
                  "%s, oblique: depth %.9g of %g", l.name, back, (double)z);
            CHECK(ssgi_view_near(&view) <= z * 1.0001f, "%s, oblique: the near plane at %g, a point at %g", l.name,
                  (double)ssgi_view_near(&view), (double)z);
            ++seen;
        }
        CHECK(seen > 200, "%s: an oblique view shows %d points", l.name, seen);
    }
}

/* In a world with z mirrored the camera is mirrored, too. */
static void mirrored_cameras(void)
{
    for (int t = 0; t < 100; ++t) {
        const float centre[2][3] = { { 1, 2, 3 }, { 1, 2, -3 } };
        float z[3], main_view[2][16], view[2][16], clip[16], offset[3];
        direction(z);
        rigid(main_view[0], z);
        memcpy(main_view[1], main_view[0], sizeof main_view[0]);
        for (int k = 8; k < 12; ++k) main_view[1][k] = -main_view[0][k];
        direction(offset);
        for (int i = 0; i < 2; ++i)
            CHECK(ssgi_extra_camera(view[i], clip, main_view[i], centre[i], 1, offset, NULL) == SSGI_OK, "refused");
        for (int k = 0; k < 16; ++k)
            CHECK(fabsf(view[0][k] - (k / 4 == 2 ? -1.0f : 1.0f) * view[1][k]) < 2e-5f, "element %d: %g, mirrored %g",
                  k, (double)view[0][k], (double)view[1][k]);
    }
}

static void extra_cameras(void)
{
    for (int t = 0; t < 300; ++t) {
        float z[3], main_view[16], view[16], clip[16], centre[3], offset[3], p[3], q[3], up[3], pixel[3];
        /* 1/sin 50 = 1.305 radii: nearer, the angle is held */
        const float radius = expf(t_uniform(-3, 3)), far_away = t % 3 ? t_uniform(1.35f, 6) : t_uniform(0.05f, 1.3f);
        const char *why = "";
        ssgi_view v;
        direction(z);
        rigid(main_view, z);
        direction(z);                                    /* from the centre to the new eye */
        /* along the main camera's up */
        if (t % 10 == 0) for (int k = 0; k < 3; ++k) z[k] = main_view[4 * k + 1];
        for (int k = 0; k < 3; ++k) offset[k] = t_uniform(-3, 3);
        /* the eye as main eye + radius * displacement; the centre so that z and the distance come out */
        for (int k = 0; k < 3; ++k) {
            float eye = 0;
            for (int i = 0; i < 3; ++i) eye += main_view[4 * k + i] * (radius * offset[i] - main_view[12 + i]);
            centre[k] = eye - far_away * radius * z[k];
        }
        if (!CHECK(ssgi_extra_camera(view, clip, main_view, centre, radius, offset, &why) == SSGI_OK
                       && ssgi_view_from_projection(&v, clip, SSGI_CLIP_GL, 1000, 1000, &why) == SSGI_OK,
                   "%s", why))
            continue;
        const float reach = far_away * radius, within = 1e-4f * (reach + radius + 10), held = t % 3 == 0 ? 1 : 0;
        through(view, centre, 1, p);
        CHECK(fabsf(p[0]) < within && fabsf(p[1]) < within && fabsf(p[2] + reach) < within,
              "the centre at %g %g %g, %g away", (double)p[0], (double)p[1], (double)p[2], (double)reach);
        for (int k = 0; k < 3; ++k) up[k] = main_view[4 * k + 1];
        through(view, up, 0, q);
        CHECK(t % 10 == 0 || (fabsf(q[0]) < 1e-3f && q[1] > 0), "the main camera's up at %g %g %g", (double)q[0],
              (double)q[1], (double)q[2]);
        for (int a = 0; a < 3; ++a) for (int b = 0; b < 3; ++b) {
                const float row[3] = { view[a], view[4 + a], view[8 + a] },
                            other[3] = { view[b], view[4 + b], view[8 + b] };
                CHECK(fabs(dot(row, other) - (a == b)) < 1e-5, "axes %d and %d: %g", a, b, dot(row, other));
        }
        const double near_plane = (double)clip[14] / ((double)clip[10] - 1),
                     far_plane = (double)clip[14] / ((double)clip[10] + 1), want = (double)radius / 50;
        CHECK(fabs(near_plane / want - 1) < 1e-3 && fabs(far_plane / (double)(reach + radius) - 1) < 1e-3,
              "planes %g %g of a sphere of %g at %g", near_plane, far_plane, (double)radius, (double)reach);
        if (held > 0) {
            CHECK(fabsf(clip[0] - 0.8390996f) < 1e-5f, "near the sphere: %g, not the cotangent of 50 degrees",
                  (double)clip[0]);
            continue;
        }
        for (int i = 0; i < 6; ++i) {
            float extreme[3] = { centre[0], centre[1], centre[2] };
            extreme[i / 2] += i & 1 ? -radius : radius;
            through(view, extreme, 1, p);
            ssgi_view_project(pixel, &v, p);
            CHECK(pixel[0] > -0.1f && pixel[0] < 1000.1f && pixel[1] > -0.1f && pixel[1] < 1000.1f
                      && (double)pixel[2] > near_plane * 0.999 && (double)pixel[2] < far_plane * 1.001,
                  "extreme point %d at %g %g, depth %g", i, (double)pixel[0], (double)pixel[1], (double)pixel[2]);
        }
        /* where the view's right edge touches the sphere */
        const float touch[3] = { radius * sqrtf(1 - 1 / (far_away * far_away)), 0,
                                 -(far_away - 1 / far_away) * radius };
        ssgi_view_project(pixel, &v, touch);
        CHECK(fabsf(pixel[0] - 1000) < 0.1f, "the sphere's outline at %g, not at the edge", (double)pixel[0]);
    }
    /* eye (0,0,2), two radii away */
    const float main_view[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -2, 1 }, origin[3] = { 0, 0, 0 },
                onto[3] = { 0, 0, -2 }, above[3] = { 0, 2, -2 };
    static const double angles[4][2] = { { -60, 20 }, { 60, 20 }, { 0, 75 }, { 180, 50 } };      /* to the side, up */
    float view[16], clip[16], d[3];
    for (int i = 0; i < 4; ++i) {
        ssgi_extra_displacement(d, i);
        ssgi_extra_camera(view, clip, main_view, origin, 1, d, NULL);
        const double side = angles[i][0] * PI / 180, up = angles[i][1] * PI / 180,
                     turned[3] = { 2 * sin(side) * cos(up), 2 * sin(up), 2 * cos(side) * cos(up) };
        for (int k = 0; k < 3; ++k) {                    /* minus translation along the axes: the eye */
            const float column[3] = { view[4 * k], view[4 * k + 1], view[4 * k + 2] };
            CHECK(fabs(-dot(column, view + 12) - turned[k]) < 2e-5, "default %d: eye's %d is %g", i, k,
                  -dot(column, view + 12));
        }
    }
    ssgi_extra_camera(view, clip, main_view, origin, 1, above, NULL);
    CHECK(fabsf(view[1]) < 1e-6f && fabsf(view[5]) < 1e-6f && fabsf(view[9] + 1) < 1e-6f,
          "straight above, up is %g %g %g, not forward", (double)view[1], (double)view[5], (double)view[9]);
    const char *why = "";
    memcpy(view, main_view, sizeof view);
    CHECK(ssgi_extra_camera(view, clip, main_view, origin, 1e-37f, onto, &why) == SSGI_BAD_ARGUMENT
              && NAMES(why, "radius:") && !memcmp(view, main_view, sizeof view),
          "radius 1e-37: \"%s\"", why);
    CHECK(ssgi_extra_camera(view, clip, view, origin, 1, onto, NULL) == SSGI_OK && fabsf(view[10] - 1) < 1e-6f
              && fabsf(view[14]) < 1e-6f,
          "at the centre, output over input: %g %g", (double)view[10], (double)view[14]);
}

/* ---- >>kernel ---------------------------------------------------------------------------------------------------- */

enum { SETS = 16, SAMPLES = 64 };

static void kernels(void)
{
    static float k[4 * SETS * SAMPLES];
    for (int n = 1; n <= SAMPLES; ++n) {
        CHECK(ssgi_kernel(k, SETS, n, NULL) == SSGI_OK, "refused");
        for (int set = 0; set < SETS; ++set) {
            const float *s = k + 4 * set * n;
            double z = 0, z2 = 0;
            int stratum[SAMPLES] = { 0 }, right = 1;
            for (int i = 0; i < n; ++i, s += 4) {
                const double l2 =
                    (double)s[0] * (double)s[0] + (double)s[1] * (double)s[1] + (double)s[2] * (double)s[2];
                const int cell = (int)ceil((double)s[3] * n - 1e-5) - 1;
                right &= s[3] > 0 && s[3] <= 1 && cell >= 0 && cell < n && !stratum[cell < 0 || cell >= n ? 0 : cell]++;
                right &= fabs(l2 - 1) < 1e-6 && s[2] > 0;
                z += (double)s[2] / n; z2 += (double)s[2] * (double)s[2] / n;
            }
            CHECK(right, "set %d of %d: not unit, or lengths not one a stratum in (0,1]", set, n);
            CHECK(fabs(z2 - 0.5) < 1e-6 && fabs(z - 2.0 / 3) < 0.05 / n, "set %d of %d: mean z^2 %.9g, z %.9g", set, n,
                  z2, z);
        }
    }
    float out[1] = { 7 };
    const struct {
        float *out;
        int sets, samples;
        const char *start;
    } bad[] = { { NULL, 1, 1, "out:" },
                { out, 0, 1, "sets:" },
                { out, 4097, 1, "sets:" },
                { out, 1, 0, "samples:" },
                { out, 1, 4097, "samples:" } };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        const char *why = "";
        CHECK(ssgi_kernel(bad[i].out, bad[i].sets, bad[i].samples, &why) == SSGI_BAD_ARGUMENT
                  && NAMES(why, bad[i].start) && out[0] == 7.0f,
              "%s \"%s\"", bad[i].start, why);
    }
}

/* The other kinds: the same points of the square, and the same lengths, with heights whose sums are exact. */
static void spread(void)
{
    static float k[4 * SETS * SAMPLES], d[4 * SETS * SAMPLES];
    const char *why = "";
    for (int n = 1; n <= SAMPLES; n += n < 8 ? 1 : 7) {
        ssgi_kernel(k, SETS, n, NULL);
        CHECK(ssgi_directions(d, SSGI_DIRECTIONS_COSINE, SETS, n, NULL) == SSGI_OK
                  && !memcmp(d, k, (size_t)(4 * SETS * n) * sizeof *d),
              "%d by the cosine are not the kernel's", n);
        for (int kind = SSGI_DIRECTIONS_UNIFORM; kind <= SSGI_DIRECTIONS_SPHERE; ++kind) {
            if (!CHECK(ssgi_directions(d, kind, SETS, n, &why) == SSGI_OK, "%s", why)) return;
            for (int set = 0; set < SETS; ++set) {
                double z = 0, off = 0;
                for (int i = 0; i < n; ++i) {
                    const float *o = d + 4 * (set * n + i), *c = k + 4 * (set * n + i);
                    const double u = 1 - (double)c[2] * (double)c[2], up = (double)o[2];
                    off = fmax(off, fabs((kind == SSGI_DIRECTIONS_SPHERE ? (1 - up) / 2 : 1 - up) - u));
                    off = fmax(off, fabs(dot(o, o) - 1));
                    off = fmax(off, fabs((double)o[0] * (double)c[1] - (double)o[1] * (double)c[0]));
                    off = fmax(off, (double)(o[0] * c[0] + o[1] * c[1] < 0) + fabs((double)(o[3] - c[3])));
                    z += (double)o[2] / n;
                }
                CHECK(off < 1e-6, "kind %d, set %d of %d: a direction or a length is off by %g", kind, set, n, off);
                CHECK(fabs(2 * z - (kind == SSGI_DIRECTIONS_UNIFORM)) < 1e-6, "kind %d, set %d of %d: sum 2 z/n %.9g",
                      kind, set, n, 2 * z);
            }
        }
    }
    d[0] = 7;
    CHECK(ssgi_directions(d, 3, 1, 1, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "kind:") && d[0] == 7
              && ssgi_directions(d, -1, 1, 1, NULL) == SSGI_BAD_ARGUMENT
              && ssgi_directions(d, 1, 1, 4097, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "samples:") && d[0] == 7,
          "\"%s\"", why);
}

/* Windows: w and h worked out by hand. Distance: of a set's nearest copy, squared. */
static void tiles(void)
{
    static const struct {
        int size, sets, w, h, distance;
    } row[] = { { 1, 1, 1, 1, 1 },    { 2, 4, 2, 2, 4 },         { 4, 16, 4, 4, 16 },  { 4, 8, 4, 2, 8 },
                { 8, 16, 4, 4, 16 },  { 8, 32, 8, 4, 32 },       { 8, 64, 8, 8, 64 },  { 6, 12, 6, 2, 8 },
                { 5, 5, 5, 1, 5 },    { 16, 64, 8, 8, 64 },      { 12, 24, 6, 4, 20 }, { 32, 1, 1, 1, 1 },
                { 64, 64, 8, 8, 64 }, { 32, 1024, 32, 32, 1024 } };

    static float t[4 * 64 * 64];
    const char *why = "";
    for (size_t r = 0; r < sizeof row / sizeof *row; ++r) {
        const int n = row[r].size, sets = row[r].sets, w = row[r].w, h = row[r].h;
        static char strata[64 * 64], seen[64 * 64];
        int wrong = 0, nearest = 1 << 30;
        double off = 0;
        if (!CHECK(ssgi_noise_tile(t, n, sets, 6, &why) == SSGI_OK, "%s", why)) return;
        memset(strata, 0, sizeof strata);
        for (int i = 0; i < n * n; ++i) {
            const double turn = (double)t[4 * i + 3], set = turn * sets - 0.5, b = ((double)t[4 * i + 2] + 0.5) * n * n;
            off = fmax(off, fabs(set - floor(set + 0.5)) + fabs(b - floor(b) - 0.5));
            off = fmax(off,
                       fabs((double)t[4 * i] - cos(PI / 3 * turn)) + fabs((double)t[4 * i + 1] - sin(PI / 3 * turn)));
            wrong += turn < 0 || turn >= 1 || b < 0 || b > n * n || strata[(int)b]++;
        }
        CHECK(!wrong && off < 1e-3, "%d x %d, %d sets: %d strata are not had once; off by %g", n, n, sets, wrong, off);
        for (int at = 0; at < n * n; ++at) {
            memset(seen, 0, sizeof seen);
            for (int i = 0; i < w * h; ++i) {
                const int x = (at % n + i % w) % n, y = (at / n + i / w) % n;
                wrong += seen[(int)(t[4 * (y * n + x) + 3] * (float)sets)]++;
            }
            for (int y = -w; y <= w; ++y)
                for (int x = -w; x <= w; ++x) {
                    const int other = (at / n + y + n) % n * n + (at % n + x + n) % n, dd = x * x + y * y;
                    if (dd && dd < nearest && t[4 * other + 3] == t[4 * at + 3]) nearest = dd;
                }
        }
        CHECK(!wrong, "%d x %d: of its windows of %d x %d %d texels repeat a set", n, n, w, h, wrong);
        CHECK(nearest == row[r].distance, "%d x %d, %d sets: a set's copies %g apart", n, n, sets, sqrt(nearest));
    }

    const struct {
        float *out;
        int size, sets, directions;
        const char *start;
    } bad[] = { { NULL, 4, 16, 1, "out:" },     { t, 0, 1, 1, "size:" },          { t, 65, 1, 1, "size:" },
                { t, 4, 0, 1, "sets:" },        { t, 4, 3, 1, "sets:" },          { t, 4, 32, 1, "sets:" },
                { t, 4, 16, 0, "directions:" }, { t, 4, 16, 1025, "directions:" } };

    t[0] = 7;
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i)
        CHECK(ssgi_noise_tile(bad[i].out, bad[i].size, bad[i].sets, bad[i].directions, &why) == SSGI_BAD_ARGUMENT
                  && NAMES(why, bad[i].start) && t[0] == 7,
              "%s \"%s\"", bad[i].start, why);
}

/* Greatest difference between the share of points in a box at the origin and its area, over the boxes that the points
   span. */
static double discrepancy(double (*p)[2], int n)
{
    double worst = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            int open = 0, closed = 0;
            for (int k = 0; k < n; ++k) {
                open += p[k][0] < p[i][0] && p[k][1] < p[j][1];
                closed += p[k][0] <= p[i][0] && p[k][1] <= p[j][1];
            }
            worst = fmax(worst, fmax(p[i][0] * p[j][1] - (double)open / n, (double)closed / n - p[i][0] * p[j][1]));
        }
    return worst;
}

static void evenness(void)
{
    static const int sizes[] = { 16, 64, 128 };
    static float k[4 * SETS * 128];
    static double p[128][2];
    for (int s = 0; s < 3; ++s) {
        const int n = sizes[s];
        double mean = 0, worst = 0, random = 0, r2;
        ssgi_kernel(k, SETS, n, NULL);
        for (int set = 0; set < SETS; ++set) {           /* back to the square: azimuth and u */
            for (int i = 0; i < n; ++i) {
                const float *o = k + 4 * (set * n + i);
                const double a = atan2((double)o[1], (double)o[0]) / (2 * PI);
                p[i][0] = a - floor(a); p[i][1] = 1 - (double)o[2] * (double)o[2];
            }
            mean += discrepancy(p, n) / SETS;
            worst = fmax(worst, discrepancy(p, n));
            for (int i = 0; i < n; ++i) { p[i][0] = (double)t_uniform(0, 1); p[i][1] = (double)t_uniform(0, 1); }
            random += discrepancy(p, n) / SETS;
        }
        for (int i = 0; i < n; ++i) {
            float q[2];
            ssgi_r2(q, (uint32_t)i);
            p[i][0] = (double)q[0];
            p[i][1] = (double)q[1];
        }
        r2 = discrepancy(p, n);
        CHECK(worst < log(n) / n && mean < 0.5 * random && r2 < 2 * log(n) / n,
              "%d points: sets %.3f, at worst %.3f, R2 %.3f, random %.3f", n, mean, worst, r2, random);
        t_note("star discrepancy of %d points: sets %.3f, R2 %.3f, random %.3f", n, mean, r2, random);
    }
    CHECK(ssgi_radical_inverse(2, 6) == 0.375f && fabsf(ssgi_radical_inverse(3, 5) - 7.0f / 9) < 1e-7f
              && ssgi_radical_inverse(2, 0xffffffffu) < 1.0f && ssgi_radical_inverse(1, 5) == 0.0f,
          "radical inverse");
}

/* ---- >>sh -------------------------------------------------------------------------------------------------------- */

enum { WIDE = 128, HIGH = 64, CUBE = 24 };

static double sh_sum(const float *coefficients, int channel, const double d[3], const double factor[3])
{
    const float f[3] = { (float)d[0], (float)d[1], (float)d[2] };
    float basis[9];
    double sum = 0;
    ssgi_sh_basis(basis, 3, f);
    for (int l = 0, i = 0; l < 3; ++l)
        for (; i < (l + 1) * (l + 1); ++i) sum += (double)basis[i] * (double)coefficients[3 * i + channel] * factor[l];
    return sum;
}

/* OpenEXR's: latitude falls from pi/2, longitude from pi; +z at the centre, +x left of it. */
static double equirect(double d[3], int x, int y, int width, int height)
{
    const double lat = PI * (0.5 - (y + 0.5) / height), lon = PI - 2 * PI * (x + 0.5) / width;
    d[0] = cos(lat) * sin(lon); d[1] = sin(lat); d[2] = cos(lat) * cos(lon);
    return (sin(lat + PI / 2 / height) - sin(lat - PI / 2 / height)) * 2 * PI / width;
}

static const double ones[3] = { 1, 1, 1 };

/* An environment of bands 0..2 with the coefficients; band 0 lifts it above 0. */
static void smooth(float *rgb, float coefficients[27], int width, int height)
{
    double d[3];
    for (int i = 0; i < 27; ++i) coefficients[i] = i < 3 ? t_uniform(9, 12) : t_uniform(-1, 1);
    for (int i = 0; i < width * height; ++i)
        for (int c = 0; c < 3; ++c) {
            equirect(d, i % width, i / width, width, height);
            rgb[3 * i + c] = (float)sh_sum(coefficients, c, d, ones);
        }
}

static void harmonics(void)
{
    static const double constant[16] = { 0.28209479177387814, 0.48860251190291992, 0.48860251190291992,
                                         0.48860251190291992, 1.0925484305920792,  1.0925484305920792,
                                         0.31539156525252005, 1.0925484305920792,  0.54627421529603959,
                                         0.59004358992664352, 2.8906114426405538,  0.45704579946446577,
                                         0.3731763325901154,  0.45704579946446577, 1.4453057213202769,
                                         0.59004358992664352 };
    for (int t = 0; t < 200; ++t) {
        float a[3], b[3], ya[37], yb[36];
        direction(a); direction(b);
        const double x = (double)a[0], y = (double)a[1], z = (double)a[2], c = dot(a, b);
        const double polynomial[16] = { 1,
                                        y,
                                        z,
                                        x,
                                        x * y,
                                        y * z,
                                        3 * z * z - 1,
                                        x * z,
                                        x * x - y * y,
                                        y * (3 * x * x - y * y),
                                        x * y * z,
                                        y * (5 * z * z - 1),
                                        z * (5 * z * z - 3),
                                        x * (5 * z * z - 1),
                                        z * (x * x - y * y),
                                        x * (x * x - 3 * y * y) };
        const double legendre[6] = { 1,
                                     c,
                                     (3 * c * c - 1) / 2,
                                     (5 * c * c * c - 3 * c) / 2,
                                     (35 * c * c * c * c - 30 * c * c + 3) / 8,
                                     (63 * c * c * c * c * c - 70 * c * c * c + 15 * c) / 8 };
        ya[36] = 7;
        ssgi_sh_basis(ya, t & 1 ? 6 : 99, a); ssgi_sh_basis(yb, 6, b);
        CHECK(ya[36] == 7.0f, "more bands than there are were written");
        for (int i = 0; i < 16; ++i)
            CHECK(fabs((double)ya[i] - constant[i] * polynomial[i]) < 1e-6, "function %d: %.9g, the table has %.9g", i,
                  (double)ya[i], constant[i] * polynomial[i]);
        /* the addition theorem, for the bands that the table leaves out */
        for (int l = 0; l < 6; ++l) {
            double sum = 0;
            for (int i = l * l; i < (l + 1) * (l + 1); ++i) sum += (double)ya[i] * (double)yb[i];
            CHECK(fabs(sum * 4 * PI / (2 * l + 1) - legendre[l]) < 1e-5, "band %d at cosine %g: %.9g, Legendre %.9g", l,
                  c, sum * 4 * PI / (2 * l + 1), legendre[l]);
        }
    }
    for (int l = 0; l < 6; ++l) {                        /* 2 pi times the integral of z P_l(z) over [0,1] */
        static const double want[6] = { 1, 2.0 / 3, 0.25, 0, -1.0 / 24, 0 };
        CHECK(fabs((double)ssgi_sh_cosine(l) / PI - want[l]) < 1e-7, "cosine, band %d: %.9g", l,
              (double)ssgi_sh_cosine(l));
    }
    CHECK(ssgi_sh_cosine(-1) == 0.0f && ssgi_sh_cosine(99) == 0.0f, "cosine beyond the bands");
}

static void projections(void)
{
    static float rgb[3 * WIDE * HIGH], cube[6][3 * CUBE * CUBE];
    const float *const faces[6] = { cube[0], cube[1], cube[2], cube[3], cube[4], cube[5] };
    float given[27], got[48];
    const char *why = "";
    smooth(rgb, given, WIDE, HIGH);
    CHECK(ssgi_sh_project_equirect(got, 4, rgb, WIDE, HIGH, &why) == SSGI_OK, "%s", why);
    for (int i = 0; i < 48; ++i)
        CHECK(fabsf(got[i] - (i < 27 ? given[i] : 0)) < 1e-3f * given[i % 3],
              "latitude-longitude, coefficient %d: %g, given %g", i, (double)got[i], i < 27 ? (double)given[i] : 0);
    for (int i = 0; i < 6 * CUBE * CUBE; ++i) {
        const int face = i / (CUBE * CUBE), at = i % (CUBE * CUBE);
        const double s = (at % CUBE * 2 + 1.0) / CUBE - 1, t = (at / CUBE * 2 + 1.0) / CUBE - 1,
                     length = sqrt(1 + s * s + t * t);
        /* OpenGL 4.6 table 8.19, solved for the direction */
        const double table[6][3] = { { 1, -t, -s }, { -1, -t, s }, { s, 1, t },
                                     { s, -1, -t }, { s, -t, 1 },  { -s, -t, -1 } };
        const double p[3] = { table[face][0] / length, table[face][1] / length, table[face][2] / length };
        for (int c = 0; c < 3; ++c) cube[face][3 * at + c] = (float)sh_sum(given, c, p, ones);
    }
    CHECK(ssgi_sh_project_cube(got, 4, faces, CUBE, &why) == SSGI_OK, "%s", why);
    for (int i = 0; i < 48; ++i)
        CHECK(fabsf(got[i] - (i < 27 ? given[i] : 0)) < 1e-3f * given[i % 3], "cube, coefficient %d: %g, given %g", i,
              (double)got[i], i < 27 ? (double)given[i] : 0);
    for (int f = 0; f < 6; ++f) for (int i = 0; i < 3 * CUBE * CUBE; ++i) cube[f][i] = 1;
    ssgi_sh_project_cube(got, 1, faces, CUBE, NULL);
    CHECK(fabs((double)got[0] - 2 * sqrt(PI)) < 1e-6,
          "a cube of ones: %.9g, not 2 sqrt(pi): solid angles do not sum to 4 pi", (double)got[0]);
}

/* ---- >>sh: windows, lights, rotation, products ------------------------------------------------------------------- */

enum { MOST = SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS, PANELS = 64, COLUMNS = 180, NODES = 2 * PANELS * COLUMNS };

/* Direction i of NODES between two heights: two-point Gauss in panels of z, midpoints in azimuth; returns its solid
   angle. */
static double zone(float d[3], int i, double from, double to)
{
    const int row = i / COLUMNS;
    const double z = from + (to - from) * (row / 2 + 0.5 + (row % 2 - 0.5) / sqrt(3)) / PANELS,
                 a = 2 * PI * (i % COLUMNS + 0.5) / COLUMNS, r = sqrt(1 - z * z);
    d[0] = (float)(r * cos(a)); d[1] = (float)(r * sin(a)); d[2] = (float)z;
    return (to - from) * 2 * PI / NODES;
}

/* The channel at a direction; cosine: its irradiance. */
static double value(const float *coefficients, int channels, int bands, const float d[3], int cosine)
{
    float basis[MOST];
    double sum = 0;
    ssgi_sh_basis(basis, bands, d);
    for (int l = 0, i = 0; l < bands; ++l)
        for (; i < (l + 1) * (l + 1); ++i)
            sum += (double)basis[i] * (double)coefficients[channels * i] * (cosine ? (double)ssgi_sh_cosine(l) : 1);
    return sum;
}

static const float axis_z[3] = { 0, 0, 1 };

static void windows(void)
{
    static const struct { int window, bands; double k, zonal[4], peak, least_over_peak, back, least, worst;
    } row[] = { { SSGI_SH_WINDOW_NONE,
                  4,
                  0.941176471,
                  { 0.26550098, 0.459861188, 0.59367824, 0.702449567 },
                  1.1983431,
                  -0.25,
                  0.0588235294,
                  -0.0372549015,
                  -0.200493339 },
                { SSGI_SH_WINDOW_HANN,
                  3,
                  1.42222222,
                  { 0.401201482, 0.521176013, 0.224278446, 0 },
                  0.509295818,
                  -0.0666666667,
                  -0.0666666667,
                  -0.0666666667,
                  -0.0682681998 },
                { SSGI_SH_WINDOW_HANN,
                  4,
                  1.20044172,
                  { 0.338638357, 0.500642216, 0.378609193, 0.131209261 },
                  0.676891835,
                  -0.0463197199,
                  -0.0246411014,
                  -0.0268969816,
                  -0.0345885498 },
                { SSGI_SH_WINDOW_POSITIVE,
                  4,
                  1.63265306,
                  { 0.460562925, 0.478631032, 0.205970002, 0.0348152847 },
                  0.51968961,
                  0,
                  0.0204081633,
                  0.0204081633,
                  0 } };
    static const float one[3] = { 1, 1, 1 }, nowhere[3] = { 0, 0, -1 };
    float d[3], w[MOST];
    for (size_t t = 0; t < sizeof row / sizeof row[0]; ++t) {
        float c[3 * MOST] = { 0 };
        const int bands = row[t].bands;
        double least = 1e30, worst = 0, lowest = 1e30;
        ssgi_sh_light(c, bands, axis_z, 0, one, row[t].window, NULL);
        for (int l = 0; l < bands; ++l)
            CHECK(fabs((double)c[3 * (l * l + l)] - row[t].zonal[l]) < 1e-6, "window %d, zonal %d: %.9g", row[t].window,
                  l, (double)c[3 * (l * l + l)]);
        CHECK(fabs((double)c[0] / 0.28209479177 - row[t].k) < 1e-6
                  && fabs(value(c, 3, bands, axis_z, 0) / row[t].peak - 1) < 1e-6,
              "k %.9g, peak %.9g", (double)c[0] / 0.28209479177, value(c, 3, bands, axis_z, 0));
        CHECK(fabs(value(c, 3, bands, axis_z, 1) - 1) < 1e-5
                  && fabs(value(c, 3, bands, nowhere, 1) - row[t].back) < 1e-5,
              "facing %.9g, behind %.9g", value(c, 3, bands, axis_z, 1), value(c, 3, bands, nowhere, 1));
        for (int i = 0; i <= 10000; ++i) {
            d[0] = (float)sin(i * PI / 10000); d[1] = 0; d[2] = (float)cos(i * PI / 10000);
            least = fmin(least, value(c, 3, bands, d, 1));
            lowest = fmin(lowest, value(c, 3, bands, d, 0));
        }
        /* a mask that lets through what is below 0, and nothing else */
        for (int degrees = 0; degrees <= 180; degrees += 2) {
            double taken = 0;
            for (int k = 0; k < NODES; ++k) {
                const double area = zone(d, k, -1, 1), cosine = fmax((double)d[0] * sin(degrees * PI / 180)
                                                                         + (double)d[2] * cos(degrees * PI / 180),
                                                                     0);
                static double negative;                  /* of the row of nodes: it varies with z only */
                if (k % COLUMNS == 0) negative = fmin(value(c, 3, bands, d, 0), 0);
                taken += area * negative * cosine;
            }
            worst = fmin(worst, taken);
        }
        CHECK(least >= row[t].least - 1e-4 && least <= row[t].least + 1e-4
                  && fabs(lowest / row[t].peak - row[t].least_over_peak) < 1e-4 && fabs(worst - row[t].worst) < 2e-4,
              "window %d, %d bands: least irradiance %.6g, of the light %.6g, by any mask %.6g", row[t].window, bands,
              least, lowest / row[t].peak, worst);
    }
    /* POSITIVE's: the Legendre coefficients of ((1 + z)/2)^p over the first */
    for (int bands = 1; bands <= 6; ++bands) {
        float y[MOST];
        double projected[6] = { 0 };
        w[bands] = 7;
        ssgi_sh_window(w, bands, SSGI_SH_WINDOW_POSITIVE);
        for (int k = 0; k < NODES; ++k) {
            const double area = zone(d, k, -1, 1);
            ssgi_sh_basis(y, bands, d);
            for (int l = 0; l < bands; ++l)
                projected[l] +=
                    area * (double)y[l * l + l] / sqrt(2 * l + 1) * pow(0.5 + 0.5 * (double)d[2], bands - 1);
        }
        for (int l = 0; l < bands; ++l)
            CHECK(fabs((double)w[l] - projected[l] / projected[0]) < 1e-5,
                  "positive window, band %d of %d: %.9g, not %.9g", l, bands, (double)w[l],
                  projected[l] / projected[0]);
        ssgi_sh_window(w, bands, SSGI_SH_WINDOW_HANN);
        for (int l = 0; l < bands; ++l)
            CHECK(fabs((double)w[l] - pow(cos(PI * l / (2 * bands)), 2)) < 1e-6, "Hann, band %d of %d: %.9g", l, bands,
                  (double)w[l]);
        CHECK(w[bands] == 7.0f, "a window of %d bands wrote more", bands);
    }
    ssgi_sh_window(w, 99, 99);
    CHECK(w[0] == 1.0f && w[5] == 1.0f && w[6] != 1.0f, "a window that there is not");
}

static void lights(void)
{
    static const float sines[] = { 0, 1e-6f, 0.01f, 0.3f, 0.8f, 1 }, red[3] = { 3, 0.5f, -1 };
    for (int t = 0; t < 6 * 6 * 3; ++t) {
        const int bands = 1 + t % 6, window = t / 36;
        const float sine = sines[t / 6 % 6];
        float d[3], far_away[3], c[3 * MOST], point[3 * MOST], again[3 * MOST], w[6], zonal[6], turned[MOST];
        double cap[6] = { 0 };
        const char *why = "";
        direction(d);
        for (int i = 0; i < 3; ++i) far_away[i] = 40 * d[i];
        for (int i = 0; i < 3 * MOST; ++i) c[i] = point[i] = 0;
        CHECK(ssgi_sh_light(c, bands, far_away, sine, red, window, &why) == SSGI_OK, "%s", why);
        for (int i = 0; i < 3; ++i)
            CHECK(fabs(value(c + i, 3, bands, d, 1) / (double)red[i] - (bands > 1 ? 1 : 0.25)) < 1e-5,
                  "%d bands, window %d, sine %g: facing %.9g of %g", bands, window, (double)sine,
                  value(c + i, 3, bands, d, 1), (double)red[i]);
        ssgi_sh_light(point, bands, d, 0, red, window, NULL);
        if (sine < 1e-3f)
            for (int i = 0; i < 3 * bands * bands; ++i)
                CHECK(fabsf(c[i] - point[i]) < 1e-5f, "sine %g, coefficient %d: %g, of a point %g", (double)sine, i,
                      (double)c[i], (double)point[i]);
        for (int k = 0; k < NODES; ++k) {                /* means of the zonal functions over the cap */
            float e[3], y[MOST];
            const double from = sqrt(1 - (double)sine * (double)sine),
                         area = zone(e, k, from, 1) / (2 * PI * (1 - from));
            ssgi_sh_basis(y, 6, e);
            for (int l = 0; l < 6 && from < 1; ++l) cap[l] += area * (double)y[l * l + l];
        }
        ssgi_sh_window(w, bands, window);
        for (int l = 0; l < bands; ++l) zonal[l] = (float)((double)c[0] * sqrt(4 * PI) * (double)w[l] * cap[l]);
        ssgi_sh_zonal(turned, bands, zonal, d);
        if (sine > 1e-3f)
            for (int i = 0; i < bands * bands; ++i)
                CHECK(fabsf(c[3 * i] - turned[i]) < 1e-4f, "sine %g, coefficient %d: %g, of the cap %g", (double)sine,
                      i, (double)c[3 * i], (double)turned[i]);
        memcpy(again, c, sizeof c);
        ssgi_sh_light(again, bands, d, sine, red, window, NULL);
        for (int i = 0; i < 3 * MOST; ++i)
            CHECK(fabsf(again[i] - 2 * c[i]) < 1e-5f && (i < 3 * bands * bands || c[i] == 0.0f),
                  "twice, coefficient %d: %g and %g", i, (double)c[i], (double)again[i]);
    }
}

/* What S3HO's pass sums: visibility times cosine. Columns of closed forms, about +z: open, open where x < 0, open
   beyond 45 degrees. */
static void transfer(void)
{
    static const double table[16][3] = { { 0.886226925453, 0.443113462726, 0.443113462726 },
                                         { 0 },
                                         { 1.02332670795, 0.511663353973, 0.361800627279 },
                                         { 0, -0.325735025589, 0 },
                                         { 0 },
                                         { 0 },
                                         { 0.4954159122, 0.2477079561, -0.12385397805 },
                                         { 0, -0.42904280488, 0 },
                                         { 0 },
                                         { 0 },
                                         { 0 },
                                         { 0 },
                                         { 0, 0, -0.414494690247 },
                                         { 0, -0.304697265699, 0 },
                                         { 0 },
                                         { 0, 0.0786724786566, 0 } };
    float zonal[4], c[16], d[3], y[16];
    double sum[16][3] = { { 0 } };
    for (int l = 0; l < 4; ++l) zonal[l] = ssgi_sh_cosine(l) * sqrtf((float)((2 * l + 1) / (4 * PI)));
    ssgi_sh_zonal(c, 4, zonal, axis_z);
    for (int i = 0; i < 16; ++i)
        CHECK(fabs((double)c[i] - table[i][0]) < 1e-6, "the clamped cosine, coefficient %d: %.9g", i, (double)c[i]);
    for (int part = 0; part < 2; ++part)
        for (int k = 0; k < NODES; ++k) {
            const double weight = zone(d, k, part ? sqrt(0.5) : 0, part ? 1 : sqrt(0.5)) * (double)d[2];
            ssgi_sh_basis(y, 4, d);
            for (int i = 0; i < 16; ++i) {
                sum[i][0] += weight * (double)y[i];
                sum[i][1] += d[0] < 0 ? weight * (double)y[i] : 0;
                sum[i][2] += part ? 0 : weight * (double)y[i];
            }
        }
    for (int i = 0; i < 16; ++i)
        for (int k = 0; k < 3; ++k)
            CHECK(fabs(sum[i][k] - table[i][k]) < 1e-4, "coefficient %d, column %d: %.9g, not %.9g", i, k, sum[i][k],
                  table[i][k]);
    for (int t = 0; t < 100; ++t) {                      /* about any normal */
        direction(d);
        ssgi_sh_zonal(c, 4, zonal, d);
        ssgi_sh_basis(y, 4, d);
        for (int l = 0, i = 0; l < 4; ++l)
            for (; i < (l + 1) * (l + 1); ++i)
                CHECK(fabsf(c[i] - ssgi_sh_cosine(l) * y[i]) < 1e-6f, "coefficient %d: %g", i, (double)c[i]);
    }
}

static void rotations(void)
{
    for (int t = 0; t < 120; ++t) {
        const int bands = 1 + t % 6, channels = t % 4 * 2 - 1;      /* -1 is none */
        float f[5 * MOST], turned[5 * MOST], twice[5 * MOST], at_once[5 * MOST], z[3], d[3], e[3], m[16], m2[16],
            both[16];
        for (int i = 0; i < 5 * MOST; ++i) { f[i] = t_uniform(-1, 1); turned[i] = twice[i] = at_once[i] = 7; }
        direction(z); rigid(m, z);
        for (int i = 2; i < 16 && t % 2; i += 4) m[i] = -m[i];     /* mirrored, as left-handed engines' are */
        direction(z); rigid(m2, z);
        for (int i = 0; i < 4; ++i) through(m2, m + 4 * i, 0, both + 4 * i);
        ssgi_sh_rotate(turned, bands, f, channels, m);
        memcpy(twice, turned, sizeof twice);
        ssgi_sh_rotate(twice, bands, twice, channels, m2);
        ssgi_sh_rotate(at_once, bands, f, channels, both);
        for (int i = 0; i < 5 * MOST; ++i)
            CHECK(i < channels * bands * bands ? fabsf(twice[i] - at_once[i]) < 5e-6f : turned[i] == 7.0f,
                  "%d bands, %d channels, %d: %g in two, %g at once", bands, channels, i, (double)twice[i],
                  (double)at_once[i]);
        for (int c = 0; c < channels; ++c) {
            for (int k = 0; k < 5; ++k) {
                direction(d);
                through(m, d, 0, e);
                CHECK(fabs(value(turned + c, channels, bands, e, 0) - value(f + c, channels, bands, d, 0)) < 2e-5,
                      "%d bands, channel %d: %.9g, before %.9g", bands, c, value(turned + c, channels, bands, e, 0),
                      value(f + c, channels, bands, d, 0));
            }
            for (int l = 0; l < bands; ++l) {
                double was = 0, is = 0;
                for (int i = l * l; i < (l + 1) * (l + 1); ++i) {
                    was += pow((double)f[channels * i + c], 2);
                    is += pow((double)turned[channels * i + c], 2);
                }
                CHECK(fabs(is / was - 1) < 1e-5, "band %d: norm %.9g, before %.9g", l, is, was);
            }
        }
        ssgi_sh_rotate(turned, bands, f, channels, NULL);
        for (int i = 0; i < channels * bands * bands; ++i)
            CHECK(fabsf(turned[i] - f[i]) < 1e-6f, "no rotation, %d: %g, was %g", i, (double)turned[i], (double)f[i]);
    }
}

/* ---- >>environment ----------------------------------------------------------------------------------------------- */

static void octahedral(void)
{
    for (int t = 0; t < 3000; ++t) {
        float d[3], e[2], back[3];
        double n[3], fold, length;
        direction(d);
        /* axes, edges, corners */
        if (t < 26) {
            const int k = t < 13 ? t : t + 1;
            for (int i = 0; i < 3; ++i) d[i] = (float)(k / (i == 0 ? 1 : i == 1 ? 3 : 9) % 3 - 1);
        }
        length = sqrt(dot(d, d));
        for (int i = 0; i < 3; ++i) d[i] = (float)((double)d[i] / length);
        const float size = expf(t_uniform(-60, 40)), any[3] = { size * d[0], size * d[1], size * d[2] };
        ssgi_octahedral_encode(e, any);                  /* whatever the length */
        ssgi_octahedral_decode(back, e);
        CHECK(fabsf(e[0]) <= 1 && fabsf(e[1]) <= 1 && dot(d, back) > 1 - 1e-6 && fabs(dot(back, back) - 1) < 1e-6,
              "%g %g %g to %g %g to %g %g %g", (double)d[0], (double)d[1], (double)d[2], (double)e[0], (double)e[1],
              (double)back[0], (double)back[1], (double)back[2]);
        e[0] = t_uniform(-1, 1); e[1] = t_uniform(-1, 1);
        ssgi_octahedral_decode(back, e);                 /* the GLSL twin, word for word */
        n[0] = (double)e[0]; n[1] = (double)e[1]; n[2] = 1 - fabs(n[0]) - fabs(n[1]);
        fold = fmax(-n[2], 0);
        for (int i = 0; i < 2; ++i) n[i] += n[i] >= 0 ? -fold : fold;
        for (int i = 0; i < 3; ++i)
            CHECK(fabs((double)back[i] - n[i] / sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2])) < 1e-6, "decode, %d: %g",
                  i, (double)back[i]);
    }
    const float zero[3] = { 0, 0, 0 };
    float e[2] = { 7, 7 };
    ssgi_octahedral_encode(e, zero);
    CHECK(e[0] == 0.0f && e[1] == 0.0f, "no direction: %g %g", (double)e[0], (double)e[1]);
}

static double map_texel(float d[3], int size, int at)    /* its solid angle, up to a factor */
{
    const float e[2] = { ((float)(at % size) + 0.5f) / (float)size * 2 - 1,
                         ((float)(at / size) + 0.5f) / (float)size * 2 - 1 };
    const double x = fabs((double)e[0]), y = fabs((double)e[1]), z = 1 - x - y, xx = z < 0 ? 1 - y : x,
                 yy = z < 0 ? 1 - x : y;
    ssgi_octahedral_decode(d, e);
    return pow(xx * xx + yy * yy + z * z, -1.5);
}

static void environment_maps(void)
{
    static const float angles[] = { 0, 1e-6f, 0.05f, 0.39f, 3, 12 };
    static const int sizes[][2] = { { 1, 1 }, { 5, 3 }, { 97, 41 }, { 300, 100 } };
    static float rgb[3 * 300 * 150], map[3 * 32 * 32], other[3 * 32 * 32];
    const char *why = "";
    float d[3], given[27];
    for (size_t k = 0; k < sizeof angles / sizeof angles[0]; ++k) {
        const double kappa = angles[k] > 0 ? 4 * PI / fmax((double)angles[k], 0.05) : 0;
        /* what it leaves of a band */
        const double lobe[3] = { 1, k ? 1 / tanh(kappa) - 1 / kappa : 2.0 / 3,
                                 k ? 1 - 3 * (1 / tanh(kappa) - 1 / kappa) / kappa : 0.25 };
        for (int s = 0; s < 4; ++s) {
            for (int i = 0; i < sizes[s][0] * sizes[s][1]; ++i) {
                rgb[3 * i] = 0.7f;
                rgb[3 * i + 1] = 1e4f;
                rgb[3 * i + 2] = 0;
            }
            CHECK(ssgi_environment_map(map, 8, rgb, sizes[s][0], sizes[s][1], angles[k], &why) == SSGI_OK, "%s", why);
            for (int i = 0; i < 64; ++i)
                CHECK(fabsf(map[3 * i] / 0.7f - 1) < 1e-6f && fabsf(map[3 * i + 1] / 1e4f - 1) < 1e-6f
                          && map[3 * i + 2] == 0.0f,
                      "constant, %d x %d, lobe %g: %.9g", sizes[s][0], sizes[s][1], (double)angles[k],
                      (double)map[3 * i]);
        }
        smooth(rgb, given, 300, 150);
        ssgi_environment_map(map, 32, rgb, 300, 150, angles[k], NULL);
        double worst = 0, mean = 0, all = 0;
        for (int i = 0; i < 32 * 32; ++i) {
            const double weight = map_texel(d, 32, i), at[3] = { (double)d[0], (double)d[1], (double)d[2] };
            for (int c = 0; c < 3; ++c)
                worst = fmax(worst, fabs((double)map[3 * i + c] - sh_sum(given, c, at, lobe)) * sqrt(4 * PI)
                                        / (double)given[c]);
            mean += weight * (double)map[3 * i];
            all += weight;
        }
        CHECK(worst < 3e-3 && fabs(mean / all * sqrt(4 * PI) / (double)given[0] - 1) < 1e-3,
              "lobe %g: off by %g of the mean; mean %.9g of %.9g", (double)angles[k], worst, mean / all,
              (double)given[0] / sqrt(4 * PI));
        t_note("lobe of %g sr: worst error %.2g of the mean", (double)angles[k], worst);
    }
    /* what is no light counts as 0, everywhere */
    ssgi_sun suns[2][5];
    float sh[2][27];
    const float kept = rgb[30000];
    for (int pass = 0; pass < 2; ++pass) {
        rgb[0] = pass ? 0 : NAN; rgb[301] = pass ? 0 : INFINITY; rgb[20000] = pass ? 0 : -INFINITY;
        ssgi_sh_project_equirect(sh[pass], 3, rgb, 300, 150, NULL);
        rgb[30000] = pass ? 0 : -5;
        ssgi_environment_map(pass ? other : map, 32, rgb, 300, 150, 0.39f, NULL);
        ssgi_environment_suns(suns[pass], 5, rgb, 300, 150, NULL);
        rgb[30000] = kept;
    }
    CHECK(!memcmp(sh[0], sh[1], sizeof sh[0]) && !memcmp(map, other, sizeof map)
              && !memcmp(suns[0], suns[1], sizeof suns[0]),
          "what is not finite or negative does not count as 0");
}

/* A sky of 1 with a disc of 101, 6 degrees in radius, 40 degrees up: within the cones, across their rims and
   outside. */
static void environment_cones(void)
{
    enum { W = 480, H = 240, SIDE = 32 };
    static const float cosines[] = { 0, 0.02f, 0.25f, 0.5f, 0.75f, 0.95f };
    static float rgb[3 * W * H], map[3 * SIDE * SIDE], open[3 * SIDE * SIDE];
    const double sun[3] = { 0.3, sin(40 * PI / 180), sqrt(1 - 0.09 - pow(sin(40 * PI / 180), 2)) },
                 radius = 6 * PI / 180;
    const char *why = "";
    double p[3];
    float d[3];
    for (int i = 0; i < W * H; ++i) {
        equirect(p, i % W, i / W, W, H);
        const float L = p[0] * sun[0] + p[1] * sun[1] + p[2] * sun[2] > cos(radius) ? 101 : 1;
        rgb[3 * i] = L; rgb[3 * i + 1] = 0.7f; rgb[3 * i + 2] = 0;
    }
    CHECK(ssgi_environment_map(open, SIDE, rgb, W, H, 0, NULL) == SSGI_OK
              && ssgi_environment_cone(map, SIDE, rgb, W, H, 0, &why) == SSGI_OK && !memcmp(map, open, sizeof map),
          "cosine 0 is not irradiance %s", why);
    for (size_t k = 0; k < sizeof cosines / sizeof cosines[0]; ++k) {
        const double C = (double)cosines[k], half = fmin(C, 3.75 * PI / 180 * sqrt(1 - C * C)),
                     inside = 1e2 * pow(sin(radius), 2) / (1 - C * C), rim = acos(C);
        double worst = 0, across = 0;
        ssgi_environment_cone(map, SIDE, rgb, W, H, cosines[k], NULL);
        for (int i = 0; i < SIDE * SIDE; ++i) {
            map_texel(d, SIDE, i);
            const double towards = (double)d[0] * sun[0] + (double)d[1] * sun[1] + (double)d[2] * sun[2],
                         angle = acos(fmin(fmax(towards, -1), 1)), most = 1 + inside, is = (double)map[3 * i];
            /* the disc through the ramp as documented: its rings, by how much of each lies at which cosine */
            double seen = 0, through_all = 0;
            for (int ring = 0; ring < 12; ++ring)
                for (int turn = 0; turn < 24; ++turn) {
                    const double r = radius * sqrt((ring + 0.5) / 12),
                                 cosine = cos(r) * cos(angle) + sin(r) * sin(angle) * cos(2 * PI * (turn + 0.5) / 24);
                    const double ramp = half > 0 ? fmin(fmax((cosine - C + half) / (2 * half), 0), 1) : cosine > 0;
                    seen += 2 * PI * (1 - cos(radius)) / 288 * cosine * ramp;
                }
            for (int s = 0; s < 400; ++s) {
                const double cosine = C - half + (1 - C + half) * (s + 0.5) / 400;
                through_all +=
                    2 * PI * (1 - C + half) / 400 * cosine * (half > 0 ? fmin((cosine - C + half) / (2 * half), 1) : 1);
            }
            across = fmax(across, fabs(is - 1 - 1e2 * seen / through_all) / most);
            CHECK(fabsf(map[3 * i + 1] / 0.7f - 1) < 1e-6f && map[3 * i + 2] == 0.0f, "constant, cosine %g: %.9g", C,
                  (double)map[3 * i + 1]);
            /* ramp and cell */
            if (angle > rim + radius + 0.14) CHECK(fabs(is - 1) < 1e-5, "cosine %g, outside: %.9g", C, is);
            else if (angle < rim - radius - 0.14) worst = fmax(worst, fabs(is / (1 + inside * towards) - 1));
        }
        CHECK(worst < 5e-3 && across < 0.02,
              "cosine %g: within the cone off by %g of the exact average, across the rim by %g", C, worst, across);
        t_note("cone of cosine %g: disc inside off by %.2g of its exact average, across the rim by %.2g", C, worst,
               across);
    }
}

static void sunlight(void)
{
    static const int counts[] = { 1, 2, 3, 5, 16, 17, 256, 1000, 1024 };
    static float rgb[3 * 600 * 150];
    static ssgi_sun suns[1024];
    const char *why = "";
    double d[3];
    for (int wide = 0; wide < 2; ++wide) {               /* sides above 256 are cut in two looks */
        const int width = wide ? 600 : 64, height = wide ? 150 : 32;
        double total[3] = { 0, 0, 0 };
        for (int i = 0; i < width * height; ++i)
            for (int c = 0; c < 3; ++c) {
                rgb[3 * i + c] = t_uniform(0, 1) * (i % 97 ? 1 : 20);
                total[c] += (double)rgb[3 * i + c] * equirect(d, i % width, i / width, width, height);
            }
        for (size_t k = 0; k < sizeof counts / sizeof counts[0]; ++k) {
            double sum[3] = { 0, 0, 0 }, least = 1e30, most = 0;
            int unit = 1;
            CHECK(ssgi_environment_suns(suns, counts[k], rgb, width, height, &why) == SSGI_OK, "%s", why);
            for (int i = 0; i < counts[k]; ++i) {
                const double light = 0.2126 * (double)suns[i].irradiance[0] + 0.7152 * (double)suns[i].irradiance[1]
                                     + 0.0722 * (double)suns[i].irradiance[2];
                for (int c = 0; c < 3; ++c) sum[c] += (double)suns[i].irradiance[c];
                least = fmin(least, light); most = fmax(most, light);
                unit &= fabs(dot(suns[i].direction, suns[i].direction) - 1) < 1e-6;
            }
            for (int c = 0; c < 3; ++c)
                CHECK(fabs(sum[c] / total[c] - 1) < 1e-5, "%d suns of %d x %d: irradiances sum to %.9g, not %.9g",
                      counts[k], width, height, sum[c], total[c]);
            CHECK(unit, "%d suns: a direction is not unit", counts[k]);
            if (wide && counts[k] <= 16 && (counts[k] & (counts[k] - 1)) == 0)
                CHECK(most < 1.3 * least, "%d suns of %d x %d are not about equal: %g to %g", counts[k], width, height,
                      least, most);
        }
    }
    for (int t = 0; t < 60; ++t) {                       /* one lit texel: one sun, exactly there */
        const int width = t % 2 ? 500 : 32, height = 20, at = (int)t_uniform(0, (float)(width * height)),
                  count = 1 + t % 20;
        const double area = equirect(d, at % width, at / width, width, height);
        int lit = 0;
        for (int i = 0; i < 3 * width * height; ++i) rgb[i] = i / 3 == at ? 3.0f : 0.0f;
        ssgi_environment_suns(suns, count, rgb, width, height, NULL);
        for (int i = 0; i < count; ++i) {
            const float *s = suns[i].direction;
            if (suns[i].irradiance[1] == 0.0f) continue;
            ++lit;
            CHECK(fabs((double)s[0] - d[0]) < 1e-6 && fabs((double)s[1] - d[1]) < 1e-6
                      && fabs((double)s[2] - d[2]) < 1e-6
                      && fabs((double)suns[i].irradiance[0] / (3 * area) - 1) < 1e-5,
                  "texel %d of %d: sun at %g %g %g", at, width, (double)s[0], (double)s[1], (double)s[2]);
        }
        CHECK(lit == 1, "%d suns of one texel are lit", lit);
    }
    /* the median by hand: seven texels of 1 beside one of 7 */
    for (int i = 0; i < 24; ++i) rgb[i] = i < 21 ? 1 : 7;
    ssgi_environment_suns(suns, 2, rgb, 8, 1, NULL);
    CHECK(fabs((double)suns[0].irradiance[0] / (7 * PI / 2) - 1) < 1e-6
              && fabs((double)suns[1].irradiance[0] / (7 * PI / 2) - 1) < 1e-6,
          "halves of 7 and 7: %g %g", (double)suns[0].irradiance[0], (double)suns[1].irradiance[0]);
    for (int i = 0; i < 18; ++i) rgb[i] = 1;             /* more suns than texels */
    ssgi_environment_suns(suns, 40, rgb, 3, 2, NULL);
    double sum = 0;
    int lit = 0;
    for (int i = 0; i < 40; ++i) {
        sum += (double)suns[i].irradiance[0];
        lit += suns[i].irradiance[0] > 0;
        CHECK(fabs(dot(suns[i].direction, suns[i].direction) - 1) < 1e-6, "sun %d has no direction", i);
    }
    CHECK(lit == 6 && fabs(sum / (4 * PI) - 1) < 1e-6, "%d suns of six texels are lit, by %g", lit, sum);
}

/* The median cut of a white sky by hand. A region's width is its longitudes times the sine of its middle. The sphere,
   360 degrees by 180, is cut around; halves of 180 by 180 at the horizon; quarters of 127 by 90 around; those of 64
   by 90 at cosine 1/2. The upper parts, 45 by 60, are then cut at cosine 3/4, the lower ones, 87 by 30, around. */
static void white_sky(void)
{
    static const struct { int around; double top, bottom;
    } zone[] = { { 4, 1, 0.75 }, { 4, 0.75, 0.5 }, { 8, 0.5, 0 } };
    enum { HEIGHT = 300, COUNT = 32 }; /* the cuts are near rows: 69.02 and 100 */
    static float rgb[3 * 600 * HEIGHT];
    static ssgi_sun suns[COUNT];
    for (int i = 0; i < 3 * 600 * HEIGHT; ++i) rgb[i] = 1;
    for (int width = 200; width <= 600; width += 400) {
        CHECK(ssgi_environment_suns(suns, COUNT, rgb, width, HEIGHT, NULL) == SSGI_OK, "refused");
        for (size_t z = 0; z < sizeof zone / sizeof *zone; ++z)
            for (int k = 0; k < 2 * zone[z].around; ++k) {
                /* flat, up: a region's directions, integrated */
                const double turn = 2 * PI / zone[z].around, longitude = (k / 2 + 0.5) * turn,
                             a = acos(zone[z].top), b = acos(zone[z].bottom),
                             flat = (b - a - 0.5 * (sin(2 * b) - sin(2 * a))) * sin(turn / 2),
                             up = (pow(zone[z].top, 2) - pow(zone[z].bottom, 2)) / 2 * turn,
                             length = sqrt(flat * flat + up * up);
                const float want[3] = { (float)(flat / length * sin(longitude)),
                                        (float)(k % 2 ? -up / length : up / length),
                                        (float)(flat / length * cos(longitude)) };
                int there = 0;
                for (int i = 0; i < COUNT; ++i)
                    there += fabsf(suns[i].direction[0] - want[0]) < 3e-4f
                             && fabsf(suns[i].direction[1] - want[1]) < 3e-4f
                             && fabsf(suns[i].direction[2] - want[2]) < 3e-4f
                             && fabs((double)suns[i].irradiance[1] * COUNT / (4 * PI) - 1) < 2e-3;
                CHECK(there == 1, "%d x %d: %d suns at %g %g %g, between cosines %g and %g", width, HEIGHT, there,
                      (double)want[0], (double)want[1], (double)want[2], zone[z].bottom, zone[z].top);
            }
    }
}

static void vpls(void)
{
    enum { PIXELS = 500 };
    static float position[3 * PIXELS], normal[3 * PIXELS], flux[3 * PIXELS];
    static ssgi_vpl lights[4096], again[4096];
    static const float luminance[3] = { 0.2126f, 0.7152f, 0.0722f };
    const char *why = "";
    double total = 0;
    for (int i = 0; i < PIXELS; ++i) {
        position[3 * i] = (float)i;
        direction(normal + 3 * i);
        for (int c = 0; c < 3; ++c)
            flux[3 * i + c] = i % 3 == 1   ? t_uniform(0, 1) * (i % 5 ? 1 : 30)
                              : i % 3 == 0 ? 0
                              : c == 0     ? NAN
                              : c == 1     ? -1
                                           : 0;
        if (i % 3 == 1) total += dot(flux + 3 * i, luminance);
    }
    for (int count = 1; count <= 4096; count = count * 2 + (count == 64)) {
        int chosen[PIXELS] = { 0 };
        double sum = 0;
        if (count > 4096) break;
        CHECK(ssgi_vpl_choose(lights, count, position, normal, flux, PIXELS, &why) == SSGI_OK, "%s", why);
        ssgi_vpl_choose(again, count, position, normal, flux, PIXELS, NULL);
        CHECK(!memcmp(lights, again, (size_t)count * sizeof *lights), "%d lights: two calls differ", count);
        for (int i = 0; i < count; ++i) {
            const int k = (int)lights[i].position[0];
            const float *f = flux + 3 * k, *g = lights[i].intensity;
            CHECK(k % 3 == 1 && !memcmp(lights[i].normal, normal + 3 * k, sizeof lights[i].normal),
                  "%d lights: one at pixel %d, which is dark, or another's normal", count, k);
            CHECK(fabsf(g[0] * f[1] - g[1] * f[0]) <= 1e-5f * g[0] * f[1]
                      && fabsf(g[2] * f[1] - g[1] * f[2]) <= 1e-5f * g[2] * f[1],
                  "%d lights: colour of pixel %d", count, k);
            sum += PI * dot(g, luminance);
            ++chosen[k];
        }
        CHECK(fabs(sum / total - 1) < 1e-5, "%d lights send %.9g, the map %.9g", count, sum, total);
        for (int k = 0; k < PIXELS; ++k) {               /* strata: no pixel has two more or less than its share */
            const double share = k % 3 == 1 ? dot(flux + 3 * k, luminance) / total * count : 0;
            CHECK(fabs(chosen[k] - share) < 2, "%d lights: pixel %d is chosen %d times, its share is %g", count, k,
                  chosen[k], share);
        }
    }
}

/* The rows of a map are the strata of as many lights. Within them lights stand in the order of the radical inverse, so
   that each column has one as well. The first and the last pixel are halves: no light is where two pixels meet. */
static void vpl_strata(void)
{
    enum { SIDE = 16 };
    static float position[3 * (SIDE * SIDE + 1)], flux[3 * (SIDE * SIDE + 1)];
    ssgi_vpl lights[SIDE];
    for (int side = 1; side <= SIDE; side *= 2) {
        int columns[SIDE] = { 0 };
        for (int i = 0; i <= side * side; ++i) {
            position[3 * i] = (float)i;
            for (int c = 0; c < 3; ++c) flux[3 * i + c] = i % (side * side) ? 3 : 1.5f;
        }
        CHECK(ssgi_vpl_choose(lights, side, position, position, flux, (size_t)(side * side + 1), NULL)
                  == SSGI_OK,
              "refused");
        for (int i = 0; i < side; ++i) {
            const int at = (int)lights[i].position[0];
            CHECK(at / side == i, "%d lights: light %d is in row %d", side, i, at / side);
            ++columns[at % side];
        }
        for (int k = 0; k < side; ++k) CHECK(columns[k] == 1, "%d lights: column %d has %d", side, k, columns[k]);
    }
}

/* ---- bad arguments of those rooms -------------------------------------------------------------------------------- */

/* A sky of two colours and two suns, in any bands: harmonics and what they lack are together what an open surface
   gets. */
static void lacking(void)
{
    enum { SIDE = 16 };
    static const ssgi_sun suns[2] = { { { 0.6f, 0.48f, 0.64f }, { 3, 2, 1 } }, { { 0, 0, -1 }, { 0.5f, 0, 4 } } };
    static const float up[3] = { 0, 1, 0 }, above[3] = { 1, 2, 3 }, below[3] = { 0.5f, 0.25f, 0 };
    for (int bands = 1; bands <= SSGI_SH_MAX_BANDS; ++bands)
        for (int count = 0; count <= 2; ++count) {
            float map[3 * SIDE * SIDE] = { 0 }, coefficients[3 * MOST] = { 0 }, basis[MOST], n[3];
            for (int c = 0; c < 3; ++c) {                /* the hemisphere light, as ssgi_sh_light's page has it */
                coefficients[c] = sqrtf((float)PI) * (above[c] + below[c]);
                ssgi_sh_basis(basis, 2, up);
                for (int i = 1; i < 4 && bands > 1; ++i)
                    coefficients[3 * i + c] = (float)PI * (above[c] - below[c]) * basis[i];
            }
            for (int k = 0; k < count; ++k)
                ssgi_sh_light(coefficients, bands, suns[k].direction, 0, suns[k].irradiance, k, NULL);
            for (int pass = 0; pass < 2; ++pass)
                for (int i = 0; i < SIDE * SIDE; ++i) {
                    const float e[2] = { (2 * (float)(i % SIDE) + 1) / SIDE - 1,
                                         (2 * (float)(i / SIDE) + 1) / SIDE - 1 };
                    ssgi_octahedral_decode(n, e);
                    ssgi_sh_basis(basis, bands, n);
                    for (int c = 0; c < 3; ++c) {
                        const double sky =
                            (double)below[c] + ((double)above[c] - (double)below[c]) * (0.5 + 0.5 * (double)n[1]);
                        double sum = (double)map[3 * i + c], want = sky;
                        if (!pass) { map[3 * i + c] = (float)sky; continue; }
                        for (int j = 0; j < bands * bands; ++j)
                            sum += (double)ssgi_sh_cosine((int)sqrt(j)) * (double)basis[j]
                                   * (double)coefficients[3 * j + c] / PI;
                        for (int k = 0; k < count; ++k)
                            want += fmax(0, dot(n, suns[k].direction)) * (double)suns[k].irradiance[c] / PI;
                        CHECK(fabs(sum - want) < 2e-6, "%d bands, %d suns, texel %d: %.9g, open %.9g", bands, count, i,
                              sum, want);
                    }
                    if (!pass && i == SIDE * SIDE - 1)
                        CHECK(ssgi_sh_residual(map, SIDE, coefficients, bands, suns, count, NULL) == SSGI_OK,
                              "refused");
                }
        }
}

static void bad_light(void)
{
    static const float grid[12] = { 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1 },
                       id[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }, c[3] = { 0, 0, -3 },
                       dark[3] = { 0, -1, NAN }, nan[3] = { 0, NAN, 0 };
    static const float scaled[16] = { 2, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },
                       skewed[16] = { 1, 0.1f, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 },
                       tilted[16] = { 1, 0, 0, 0.1f, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    static const float *const faces[6] = { grid, grid, grid, grid, grid, grid }, *const five[6] = { grid, grid, grid,
                                                                                                    NULL, grid, grid };
    static float out[3 * 64], was[3 * 64];
    static ssgi_sun suns[1024];
    static ssgi_vpl lights[4096];
    static const float zero[3] = { 0, 0, 0 }, endless[3] = { 0, 0, INFINITY };
    float *const v = out, *const p = out + 16;
    const char *why;
    for (int i = 0; i < 3 * 64; ++i) out[i] = was[i] = 7;
    memset(suns, 0x5a, sizeof suns);
    memset(lights, 0x5a, sizeof lights);
#define NAMED(start, function, ...) \
    (why = "", CHECK(function(__VA_ARGS__, NULL) == SSGI_BAD_ARGUMENT \
                         && function(__VA_ARGS__, &why) == SSGI_BAD_ARGUMENT && NAMES(why, start), \
                     "%s %s \"%s\"", #function, start, why))
    NAMED("world_to_view:", ssgi_extra_camera, NULL, p, id, c, 1, c);
    NAMED("projection:", ssgi_extra_camera, v, NULL, id, c, 1, c);
    NAMED("centre:", ssgi_extra_camera, v, p, id, NULL, 1, c);
    NAMED("centre:", ssgi_extra_camera, v, p, id, nan, 1, c);
    NAMED("displacement:", ssgi_extra_camera, v, p, id, c, 1, NULL);
    NAMED("displacement:", ssgi_extra_camera, v, p, id, c, 1, nan);
    const float *const wrong[] = { NULL, scaled, skewed, tilted };
    for (int k = 0; k < 4; ++k) NAMED("main_world_to_view:", ssgi_extra_camera, v, p, wrong[k], c, 1, c);
    const float radii[] = { 0, -1, NAN, INFINITY, 1e-44f };
    for (int k = 0; k < 5; ++k) NAMED("radius:", ssgi_extra_camera, v, p, id, c, radii[k], c);
    NAMED("out:", ssgi_sh_project_equirect, NULL, 3, grid, 2, 2);
    NAMED("rgb:", ssgi_sh_project_equirect, out, 3, NULL, 2, 2);
    NAMED("out:", ssgi_sh_project_cube, NULL, 3, faces, 2);
    NAMED("faces:", ssgi_sh_project_cube, out, 3, NULL, 2);
    NAMED("faces:", ssgi_sh_project_cube, out, 3, five, 2);
    NAMED("out:", ssgi_environment_map, NULL, 8, grid, 2, 2, 0);
    NAMED("rgb:", ssgi_environment_map, out, 8, NULL, 2, 2, 0);
    NAMED("out:", ssgi_environment_cone, NULL, 8, grid, 2, 2, 0);
    NAMED("rgb:", ssgi_environment_cone, out, 8, NULL, 2, 2, 0);
    NAMED("map:", ssgi_sh_residual, NULL, 8, grid, 2, suns, 1);
    NAMED("coefficients:", ssgi_sh_residual, out, 8, NULL, 2, suns, 1);
    NAMED("suns:", ssgi_sh_residual, out, 8, grid, 2, NULL, 1);
    NAMED("suns:", ssgi_sh_residual, out, 8, grid, 2, suns, -1);
    NAMED("coefficients:", ssgi_sh_light, NULL, 3, c, 0, grid, 0);
    for (int k = 0; k < 3; ++k) {
        const float *const axis = k == 0   ? NULL
                                  : k == 1 ? nan
                                           : zero,
                           *const colour = k == 1   ? nan
                                           : k == 2 ? endless
                                                    : NULL;
        NAMED("direction:", ssgi_sh_light, out, 3, axis, 0, grid, 0);
        NAMED("sine:", ssgi_sh_light, out, 3, c, k == 0 ? -0.1f : k == 1 ? 1.1f : NAN, grid, 0);
        NAMED("irradiance:", ssgi_sh_light, out, 3, c, 0, colour, 0);
        NAMED("cosine:", ssgi_environment_cone, out, 8, grid, 2, 2, k == 0 ? -0.1f : k == 1 ? 0.96f : NAN);
    }
    NAMED("out:", ssgi_environment_suns, NULL, 8, grid, 2, 2);
    NAMED("rgb:", ssgi_environment_suns, suns, 8, NULL, 2, 2);
    NAMED("out:", ssgi_vpl_choose, NULL, 8, grid, grid, grid, 4);
    NAMED("position:", ssgi_vpl_choose, lights, 8, NULL, grid, grid, 4);
    NAMED("normal:", ssgi_vpl_choose, lights, 8, grid, NULL, grid, 4);
    NAMED("flux:", ssgi_vpl_choose, lights, 8, grid, grid, NULL, 4);
    NAMED("flux:", ssgi_vpl_choose, lights, 8, grid, grid, dark, 1);
    NAMED("pixels:", ssgi_vpl_choose, lights, 8, grid, grid, grid, 0);
    NAMED("out:", ssgi_vpl_area, NULL, 8, c, c, id, 0, grid);
    NAMED("corner:", ssgi_vpl_area, lights, 8, NULL, c, id, 0, grid);
    NAMED("a:", ssgi_vpl_area, lights, 8, c, NULL, id, 0, grid);
    NAMED("b:", ssgi_vpl_area, lights, 8, c, id, nan, 0, grid);
    NAMED("a:", ssgi_vpl_area, lights, 8, c, id, id, 0, grid); /* no area */
    NAMED("triangle:", ssgi_vpl_area, lights, 8, c, c, id, 2, grid);
    NAMED("radiance:", ssgi_vpl_area, lights, 8, c, c, id, 0, c); /* below 0 */
    NAMED("radiance:", ssgi_vpl_area, lights, 8, c, c, id, 0, endless);
    for (int k = 0; k < 2; ++k) {
        const int side = k ? 65537 : 0;
        NAMED("bands:", ssgi_sh_project_equirect, out, k ? 7 : 0, grid, 2, 2);
        NAMED("width:", ssgi_sh_project_equirect, out, 3, grid, side, 2);
        NAMED("height:", ssgi_sh_project_equirect, out, 3, grid, 2, side);
        NAMED("bands:", ssgi_sh_project_cube, out, k ? 7 : 0, faces, 2);
        NAMED("size:", ssgi_sh_project_cube, out, 3, faces, side);
        NAMED("size:", ssgi_environment_map, out, k ? 257 : 7, grid, 2, 2, 0);
        NAMED("width:", ssgi_environment_map, out, 8, grid, side, 2, 0);
        NAMED("height:", ssgi_environment_map, out, 8, grid, 2, side, 0);
        NAMED("bands:", ssgi_sh_light, out, k ? 7 : 0, c, 0, grid, 0);
        NAMED("window:", ssgi_sh_light, out, 3, c, 0, grid, k ? 3 : -1);
        NAMED("size:", ssgi_environment_cone, out, k ? 257 : 7, grid, 2, 2, 0);
        NAMED("size:", ssgi_sh_residual, out, k ? 257 : 7, grid, 2, suns, 1);
        NAMED("bands:", ssgi_sh_residual, out, 8, grid, k ? 7 : 0, suns, 1);
        NAMED("solid_angle:", ssgi_environment_map, out, 8, grid, 2, 2, k ? NAN : -1);
        NAMED("count:", ssgi_environment_suns, suns, k ? 1025 : 0, grid, 2, 2);
        NAMED("width:", ssgi_environment_suns, suns, 8, grid, side, 2);
        NAMED("height:", ssgi_environment_suns, suns, 8, grid, 2, side);
        NAMED("count:", ssgi_vpl_choose, lights, k ? 4097 : 0, grid, grid, grid, 4);
        NAMED("count:", ssgi_vpl_area, lights, k ? 4097 : 0, c, c, id, 0, grid);
    }
    int untouched = !memcmp(out, was, sizeof out);
    for (size_t i = 0; i < sizeof suns; ++i) untouched &= ((const char *)suns)[i] == 0x5a;
    for (size_t i = 0; i < sizeof lights; ++i) untouched &= ((const char *)lights)[i] == 0x5a;
    CHECK(untouched, "a refused call wrote");
}

/* Of a rectangle of radiance L, seen from points before it: the closed form of its form factor, times pi L. */
static double seen_from(const double p[3], const double half[2])
{
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
        const double x = half[0] + (k & 1 ? p[0] : -p[0]), y = half[1] + (k & 2 ? p[1] : -p[1]), h = p[2],
                     X = sqrt(x * x + h * h), Y = sqrt(y * y + h * h);
        sum += (x / X * atan(y / X) + y / Y * atan(x / Y)) / 2;
    }
    return sum;
}

static void areas(void)
{
    static const float corner[3] = { -1, -0.5f, 0 }, a[3] = { 2, 0, 0 }, b[3] = { 0, 1, 0 }, radiance[3] = { 1, 0, 3 },
                       other[3] = { 1, 0.5f, 0 }, back[2][3] = { { -2, 0, 0 }, { 0, -1, 0 } };
    static ssgi_vpl light[4096];
    const char *why = "";
    for (int count = 1; count <= 4096; count *= 4) {
        for (int halves = 0; halves < 2; ++halves) { /* a rectangle; the same as two triangles, half as many each */
            const int each = halves && count > 1 ? count / 2 : count;
            double worst = 0, sum = 0;
            if (!CHECK(ssgi_vpl_area(light, each, corner, a, b, halves, radiance, &why) == SSGI_OK
                           && (each == count
                               || ssgi_vpl_area(light + each, each, other, back[0], back[1], 1, radiance, &why)
                                      == SSGI_OK),
                       "%s", why))
                return;
            if (halves && count == 1) continue;
            for (int i = 0; i < count; ++i) {
                const float *p = light[i].position;
                CHECK(fabsf(p[0]) < 1 && fabsf(p[1]) < 0.5f && p[2] == 0 && light[i].normal[2] == 1, "light %d of %d",
                      i, count);
                sum += (double)light[i].intensity[2];
            }
            CHECK(fabs(sum / 6 - 1) < 1e-5, "%d lights: intensity %g of an area of 2", count, sum);
            for (int k = 0; k < 9; ++k) {
                const double p[3] = { k % 3 - 1, k / 3 * 0.5 - 0.5, 1 }, half[2] = { 1, 0.5 };
                double got = 0;
                for (int i = 0; i < count; ++i) {
                    const double x = p[0] - (double)light[i].position[0], y = p[1] - (double)light[i].position[1],
                                 dd = x * x + y * y + 1;
                    got += (double)light[i].intensity[0] / (dd * dd);
                }
                worst = fmax(worst, fabs(got / seen_from(p, half) - 1));
            }
            CHECK(worst < 1.5 / count, "%d lights%s: irradiance off by %.3f", count, halves ? ", triangles" : "",
                  worst);
            if (count == 64) t_note("64 lights%s: irradiance at most %.4f off", halves ? ", triangles" : "", worst);
        }
    }
    for (int square = 0; square < 2; ++square) { /* what PAPERS.md says of all places at half of the longer side */
        const double half[2] = { 1, square ? 1 : 0.5 };
        const float from[3] = { -1, (float)-half[1], 0 }, side[3] = { 0, 2 * (float)half[1], 0 };
        double worst = 0;
        CHECK(ssgi_vpl_area(light, 64, from, a, side, 0, radiance, NULL) == SSGI_OK, "refused");
        for (int k = 0; k < 81 * 81; ++k) {
            const double p[3] = { k % 81 * 0.05 - 2, k / 81 * 0.05 - 2, 1 };
            double got = 0;
            for (int i = 0; i < 64; ++i) {
                const double x = p[0] - (double)light[i].position[0], y = p[1] - (double)light[i].position[1];
                got += (double)light[i].intensity[0] / pow(x * x + y * y + 1, 2);
            }
            worst = fmax(worst, fabs(got / seen_from(p, half) - 1));
        }
        CHECK(fabs(worst - (square ? 0.037 : 0.017)) < 0.0005, "64 lights of 2 x %d: off by %.4f", 1 + square, worst);
    }
}

/* ---- >>view: footprints ------------------------------------------------------------------------------------------ */

/* [HSAO08 4.1.1; SSDO09 5]: the numbers of papers and oracles; what no number gets. */
static void biases(void)
{
    static const float m[16] = { 0.9742786f, 0, 0, 0, 0, 1.7320508f, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 };

    static const struct {
        double angle;
        int resolution;
        double z, alpha, patch, published, safe;
    } row[] = { { 60, 1024, 10, 0, 0.0112763724, 0, 0 },
                { 60, 1024, 10, 80, 0.0112763724, 0.031975743, 0.0452205294 },
                { 90, 512, 5, 45, 0.01953125, 0.009765625, 0.0138106793 },
                { 90, 512, 5, 89.9, 0.01953125, 5.59528529, 7.91292834 },
                { 45, 2048, 20, 60, 0.00809010864, 0.0070062396, 0.00990831907 } };

    ssgi_view v;
    ssgi_view_from_projection(&v, m, SSGI_CLIP_GL, 1280, 720, NULL); /* 60 degrees high */
    CHECK(fabs((double)ssgi_normal_offset(&v, 10) - 10 / (sqrt(3) * 720)) < 1e-8
              && fabs((double)ssgi_normal_offset(&v, 10) - 0.00802) < 2e-6
              && ssgi_normal_offset(&v, 3) == ssgi_pixel_footprint(&v, 3) / 2,
          "eq. 13: %.9g", (double)ssgi_normal_offset(&v, 10));
    for (size_t i = 0; i < sizeof row / sizeof *row; ++i) {
        const float patch = ssgi_shadow_patch((float)row[i].z, (float)(row[i].angle * PI / 180), row[i].resolution),
                    c = (float)cos(row[i].alpha * PI / 180);
        CHECK(fabs((double)patch / row[i].patch - 1) < 1e-6, "%g degrees: a patch of %.9g", row[i].angle,
              (double)patch);
        for (int kind = SSGI_BIAS_SAFE; kind <= SSGI_BIAS_PUBLISHED; ++kind) {
            const double want = kind ? row[i].published : row[i].safe,
                         got = (double)ssgi_shadow_bias(patch, c, 100, kind);
            CHECK(fabs(got - want) <= 2e-6 * want, "alpha %g, kind %d: %.9g, not %.9g", row[i].alpha, kind, got, want);
            CHECK(ssgi_shadow_bias(patch, c, 1e-3f, kind) == (want > 1e-3 ? 1e-3f : (float)got), "not cut to the most");
        }
    }

    /* a plane over one texel, which has its depth in the middle: how far the nearest corner is before that */
    for (int azimuth = 0; azimuth <= 90; azimuth += 15)
        for (int alpha = 15; alpha < 90; alpha += 15) {
            const double slope = tan(alpha * PI / 180), a = azimuth * PI / 180, rise = 0.5 * slope * (cos(a) + sin(a)),
                         c = cos(alpha * PI / 180), safe = (double)ssgi_shadow_bias(1, (float)c, 1e9f, SSGI_BIAS_SAFE),
                         published = (double)ssgi_shadow_bias(1, (float)c, 1e9f, SSGI_BIAS_PUBLISHED);
            CHECK(rise <= safe * 1.00001 && (azimuth != 45 || rise > safe * 0.99999),
                  "a plane at %d, %d rises %g, bias %g", azimuth, alpha, rise, safe);
            CHECK((rise <= published * 1.00001) == (azimuth % 90 == 0), "published, at %d, %d: %g for %g", azimuth,
                  alpha, published, rise);
        }

    const float odd[] = { NAN, INFINITY, -INFINITY, -1, 0, 1, 1e38f };

    enum { ODD = (int)(sizeof odd / sizeof *odd) };

    for (int i = 0; i < ODD * ODD * ODD; ++i) {
        const float a = odd[i % ODD], b = odd[i / ODD % ODD], c = odd[i / ODD / ODD],
                    got[3] = { ssgi_normal_offset(&v, a), ssgi_shadow_patch(a, b, i - 9),
                               ssgi_shadow_bias(a, b, c, i - 2) };
        for (int k = 0; k < 3; ++k)
            CHECK(got[k] >= 0 && got[k] <= SSGI_FAR, "formula %d of %g %g %g: %g", k, (double)a, (double)b, (double)c,
                  (double)got[k]);
        if (!(b > 0) && c == 1) CHECK(got[2] == 1, "cosine %g: %g, not the most", (double)b, (double)got[2]);
        if (!(a > 0))
            CHECK(got[0] == 0 && got[1] == 0, "a length of %g: %g %g", (double)a, (double)got[0], (double)got[1]);
    }
}

/* n x n hills a spacing apart, each of 8 x 8 cells, turned so that `up` is (0.6, 0, 0.8); the valleys are level. */
enum { HILLS = 5, CELLS = 8 * HILLS };

static void hill(float p[3], int x, int y, double spacing)
{
    const double h = 0.1 * spacing * (1 - cos(PI / 4 * x)) * (1 - cos(PI / 4 * y)), u = x * spacing / 8;
    p[0] = (float)(0.8 * u + 0.6 * h);
    p[1] = (float)(y * spacing / 8);
    p[2] = (float)(-0.6 * u + 0.8 * h);
}

static void radii(void)
{
    static float vertex[CELLS + 1][CELLS + 1][3], soup[CELLS * CELLS * 6 + 3][3];
    static uint32_t index[CELLS * CELLS * 6], work[9 * (2 * CELLS * CELLS + 1)];
    static const int quad[6][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0 }, { 1, 1 }, { 0, 1 } };
    static const float up[3] = { 3, 0, 4 }, high[3] = { 0, 0, 1 }, none[3] = { 0, 0, 0 }, odd[3] = { 0, INFINITY, 0 };
    const size_t words = sizeof work / sizeof *work, triangles = 2 * CELLS * CELLS;
    const char *why = "";
    float radius = 0, again = 0;
    size_t found = 0;
    for (int i = 0; i <= CELLS; ++i)
        for (int k = 0; k <= CELLS; ++k) hill(vertex[i][k], i, k, 0.3);
    for (int i = 0; i < CELLS * CELLS * 6; ++i) {
        const int x = i / 6 / CELLS + quad[i % 6][0], y = i / 6 % CELLS + quad[i % 6][1];
        index[i] = (uint32_t)(x * (CELLS + 1) + y);
        memcpy(soup[i], vertex[x][y], sizeof soup[i]);
    }
    CHECK(ssgi_radius_guess(&radius, &found, vertex[0][0], 12, index, triangles, up, work, words, &why) == SSGI_OK
              && found == HILLS * HILLS && fabsf(radius / 0.3f - 1) < 1e-5f,
          "%zu hills, %g apart: %s", found, (double)radius, why);
    soup[CELLS * CELLS * 6][1] = NAN; /* a triangle more, which is none */
    CHECK(ssgi_radius_guess(&again, NULL, soup[0], 12, NULL, triangles + 1, up, work, words, &why) == SSGI_OK
              && again == radius,
          "without an index: %g, with it %g: %s", (double)again, (double)radius, why);

    /* a terrace, from which a wall leads up and a slope down, is none; an edge is seen from one side alone */
    static const float steps[9][3] = { { 1, 0, 1 },  { 2, 0, 2 }, { 2, 1, 2 }, { 0, 0, 1 }, { 1, 0, 1 },
                                       { 0, -1, 0 }, { 5, 0, 0 }, { 6, 0, 2 }, { 5, 1, 1 } };
    CHECK(ssgi_radius_guess(&radius, &found, steps[0], 12, NULL, 3, high, work, words, NULL) == SSGI_OK && found == 2
              && radius == 4,
          "a wall's top and a corner: %zu maxima, %g apart", found, (double)radius);

    /* a cube of 2 x 2 a side: from the middle its corners are maxima; along an axis its top alone */
    for (int side = 0; side < 6; ++side)
        for (int i = 0; i < 24; ++i) {
            float *p = soup[24 * side + i];
            p[side / 2] = side % 2 ? 1 : -1;
            p[(side / 2 + 1) % 3] = (float)(i / 12 + quad[i % 6][0]) - 1;
            p[(side / 2 + 2) % 3] = (float)(i / 6 % 2 + quad[i % 6][1]) - 1;
        }
    CHECK(ssgi_radius_guess(&radius, &found, soup[0], 12, NULL, 48, NULL, work, words, NULL) == SSGI_OK && found == 8
              && radius == 2,
          "a cube's corners: %zu, %g apart", found, (double)radius);
    CHECK(ssgi_radius_guess(&radius, &found, soup[0], 12, NULL, 48, high, work, words, NULL) == SSGI_OK && found == 1
              && fabsf(radius / (0.2f * sqrtf(3)) - 1) < 1e-6f,
          "a cube's top: %zu maxima, radius %g", found, (double)radius);
    for (int i = 0; i < 144; ++i) { /* on the sphere about it */
        const float l = 1 / sqrtf((float)dot(soup[i], soup[i]));
        for (int k = 0; k < 3; ++k) soup[i][k] *= l;
    }
    CHECK(ssgi_radius_guess(&radius, &found, soup[0], 12, NULL, 48, NULL, work, words, NULL) == SSGI_OK && found == 0
              && fabsf(radius / (0.2f * sqrtf(3)) - 1) < 1e-6f,
          "a sphere: %zu maxima, radius %g", found, (double)radius);

    radius = 7;

    const struct {
        const char *start;
        const float *position, *up;
        size_t stride, triangles, words;
        int result;
    } bad[] = { { "position:", NULL, up, 12, 1, words, SSGI_BAD_ARGUMENT },
                { "stride_bytes:", soup[0], up, 8, 1, words, SSGI_BAD_ARGUMENT },
                { "triangles:", soup[0], up, 12, 0, words, SSGI_BAD_ARGUMENT },
                { "up:", soup[0], none, 12, 1, words, SSGI_BAD_ARGUMENT },
                { "up:", soup[0], odd, 12, 1, words, SSGI_BAD_ARGUMENT },
                { "words:", soup[0], up, 12, 48, 9 * 48 - 1, SSGI_TOO_SMALL },
                { "position:", soup[CELLS * CELLS * 6 - 2], up, 12, 1, words, SSGI_BAD_ARGUMENT } };

    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i)
        CHECK((int)ssgi_radius_guess(&radius, NULL, bad[i].position, bad[i].stride, NULL, bad[i].triangles, bad[i].up,
                                     work, bad[i].words, &why)
                      == bad[i].result
                  && NAMES(why, bad[i].start) && radius == 7,
              "%s \"%s\"", bad[i].start, why);
}

static void footprints(void)
{
    static const float m[2][16] = { { 1.5f, 0, 0, 0, 0, -2.4f, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 },
                                    { 0.02f, 0, 0, 0, 0, 0.05f, 0, 0, 0, 0, -0.02f, 0, 0, 0, -1, 1 } };
    for (int ortho = 0; ortho < 2; ++ortho) {
        ssgi_view v;
        ssgi_view_from_projection(&v, m[ortho], SSGI_CLIP_GL, 1000, 500, NULL);
        /* [HSAO08 eq. 13] z / (f res), the axis whose pixels are wider; f: element 0 or 5 */
        for (float z = 0.2f; z < 1e4f; z *= 3) {
            const double x = 1 / ((double)m[ortho][0] * 1000), y = 1 / (fabs((double)m[ortho][5]) * 500),
                         want = fmax(x, y) * (ortho ? 1 : (double)z);
            CHECK(fabs((double)ssgi_pixel_footprint(&v, z) / (2 * want) - 1) < 1e-6,
                  "footprint %g at %g, twice eq. 13 %g", (double)ssgi_pixel_footprint(&v, z), (double)z, want);
        }
    }
}

/* ---- >>reflection ------------------------------------------------------------------------------------------------ */

static void reflections(void)
{
    static const float odd[] = { NAN, INFINITY, -INFINITY, -1, 2 }, of[] = { 0, 0, 0, 0, 1 };
    enum { STEPS = 32 };
    for (int i = 0; i <= STEPS; ++i)
        for (int k = 0; k <= STEPS; ++k) {
            const float v = (float)i / STEPS, a = (float)k / STEPS, lit = ssgi_interreflected(v, a),
                        gloss = ssgi_specular_visibility(v, 0.3f, 0.7f, a);
            CHECK(lit >= v && lit <= 1 && (!k || lit >= ssgi_interreflected(v, (float)(k - 1) / STEPS))
                      && (v < 1 || lit >= 1) && (v > 0 || !(lit > 0)),
                  "visibility %g, albedo %g: %g", (double)v, (double)a, (double)lit);
            /* the share of an open lobe, of one that its normal leans away from, and toward */
            CHECK(ssgi_specular_visibility(1, a, a, v) >= 1 && gloss >= 0 && gloss <= 1
                      && ssgi_specular_visibility(v, 0.7f, 0.7f, a) >= gloss
                      && ssgi_specular_visibility(v, 0.9f, 0.7f, a) >= ssgi_specular_visibility(v, 0.7f, 0.7f, a),
                  "visibility %g, roughness %g: %g", (double)v, (double)a, (double)gloss);
        }
    CHECK(fabs((double)ssgi_specular_visibility(0.5f, 0.6f, 0.8f, 0.5f) - (1 - 0.98 * 0.5 - 1.515 * 0.5 * 0.2)) < 1e-6
              && fabs((double)ssgi_interreflected(0.5f, 0.5f) - ((0.6878 * 0.5 - 1.75585) * 0.5 + 2.0679) * 0.5) < 1e-6,
          "half of all: %g, %g", (double)ssgi_specular_visibility(0.5f, 0.6f, 0.8f, 0.5f),
          (double)ssgi_interreflected(0.5f, 0.5f));
    for (int i = 0; i < 5; ++i) {
        CHECK(!(fabsf(ssgi_interreflected(odd[i], 0.5f) - ssgi_interreflected(of[i], 0.5f)) > 0)
                  && !(fabsf(ssgi_interreflected(0.4f, odd[i]) - ssgi_interreflected(0.4f, of[i])) > 0)
                  && !(fabsf(ssgi_specular_visibility(0.4f, 0.5f, 0.5f, odd[i])
                             - ssgi_specular_visibility(0.4f, 0.5f, 0.5f, of[i])) > 0)
                  && !(fabsf(ssgi_specular_visibility(odd[i], 0.5f, 0.5f, 0.5f)
                             - ssgi_specular_visibility(of[i], 0.5f, 0.5f, 0.5f)) > 0),
              "of %g", (double)odd[i]);
        CHECK(ssgi_specular_visibility(0.4f, odd[i], odd[4 - i], 0.5f) >= 0, "cosines %g, %g", (double)odd[i],
              (double)odd[4 - i]);
    }
}

void test_math(void)
{
    RUN("views: every layout decodes its depth, and pixels come back, as by the matrix in double", views);
    RUN("views: bad projections are named and leave the view as it was", bad_views);
    RUN("views: left-handed ones are right-handed with z negated; oblique near planes decode as by the matrix in "
        "double",
        engines_views);
    RUN("additional cameras are mirrored where the main one is", mirrored_cameras);
    RUN("additional cameras hold the sphere, centred and no wider, with the main camera's up", extra_cameras);
    RUN("kernels: counts sum to 1, one length a stratum, unit directions, moments of their shape", kernels);
    RUN("directions of every kind are the kernel's points of the square, with sums that are exact", spread);
    RUN("tiles of noise: every window has every set once, every stratum is there, copies are far apart", tiles);
    RUN("points are spread far better than random", evenness);
    RUN("a pixel's footprint", footprints);
    RUN("bias: the papers' and the oracles' numbers, what a plane needs, finite whatever comes", biases);
    RUN("a radius to begin with: hills' and corners' spacing; a sphere has none", radii);
    RUN("harmonics: the table's functions, the addition theorem, the cosine's factors", harmonics);
    RUN("harmonics: latitude-longitude and cube maps give back what made them", projections);
    RUN("windows: the table's rows: zonal factors, irradiance facing, behind and least, the worst that any mask lets "
        "through",
        windows);
    RUN("lights: what faces one receives what was given, of one band all the mean; spheres are caps; they add", lights);
    RUN("transfer: the cosine's series, behind a wall and below a cap", transfer);
    RUN("what harmonics lack of open surfaces makes them exact", lacking);
    RUN("rotation: values move with their directions, twice is once by both", rotations);
    RUN("octahedral: there and back, as the GLSL twin", octahedral);
    RUN("environment maps: constants exact, each band as the lobe leaves it, the mean kept", environment_maps);
    RUN("cones: cosine 0 is irradiance, constants exact, a disc inside, across the rim and outside", environment_cones);
    RUN("suns: no light lost, about equal shares, one texel is one sun", sunlight);
    RUN("suns: a white sky is cut where it is wider on the sphere, at its median", white_sky);
    RUN("virtual point lights: the map's flux in all, only where it is lit, by share", vpls);
    RUN("virtual point lights: of a square of pixels that are all as bright, one a row and one a column", vpl_strata);
    RUN("area lights as points: the closed form of a rectangle", areas);
    RUN("reflections: between visibility and 1; nothing occluded is 1; no number gives none", reflections);
    RUN("cameras and lights: bad arguments are named, outputs stay", bad_light);
}
