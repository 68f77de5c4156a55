/* test_math.c - ssgi.h's rooms of view, bias, kernel, sh and environment, against double precision and closed forms. */
#include "frames.h"
#include "ssgi.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846

void arguments_refused(void); /* in arguments.c */

/* Raises *worst to an error that is larger. NaN counts as infinite. */
static void grow(double *worst, double error)
{
    error = fabs(error);
    if (!(error <= *worst)) *worst = error >= 0 ? error : HUGE_VAL;
}

static double apart(const float *a, const float *b, int count)
{
    double worst = 0;
    for (int i = 0; i < count; ++i) grow(&worst, (double)a[i] - (double)b[i]);
    return worst;
}

static double dot(const float *a, const float *b)
{
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static void cross(float out[3], const float *a, const float *b)
{
    for (int k = 0; k < 3; ++k) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

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

/* Makes a layout's projection: off-centre; every second layout has y down; every third is scaled as a whole */
static void matrix(float m[16], const layout *l, int i)
{
    const float c = i % 3 ? 1.0f : 2.0f, high = i & 1 ? -2.1f : 2.1f;
    const float perspective[16] = { 1.3f * c,  0,          0, 0,
                                    0,         high * c,   0, 0,
                                    0.07f * c, -0.03f * c, (float)l->m10 * c, -c,
                                    0,         0,          (float)l->m14 * c, 0 };
    memcpy(m, perspective, sizeof perspective);
    if (!l->ortho) return;
    memcpy(m + 12, m + 8, 2 * sizeof *m);
    m[15] = c;
    m[8] = m[9] = m[11] = 0;
}

/* Writes normalised device coordinates of a point by the matrix, in double. */
static void by_matrix(double ndc[3], const float m[16], const float p[3])
{
    double w = (double)m[15];
    for (int k = 0; k < 3; ++k) w += (double)m[4 * k + 3] * (double)p[k];
    for (int c = 0; c < 3; ++c) {
        double sum = (double)m[12 + c];
        for (int k = 0; k < 3; ++k) sum += (double)m[4 * k + c] * (double)p[k];
        ndc[c] = sum / w;
    }
}

static void views(void)
{
    static const double eyes[] = { 0, 1e5, -1, -50 },     /* how much farther away orthographic eyes stand */
                        units[] = { 1, 1e-6, 1e-17, 1e9 }; /* of others */
    for (int e = 0; e < 4 * LAYOUTS; ++e) {
        const int i = e / 4, flat = layout_at(i, 1, 100).ortho;
        const double n = flat ? 1 + eyes[e % 4] : units[e % 4], f = flat ? 100 + eyes[e % 4] : 100 * units[e % 4];
        const layout l = layout_at(i, n, f);
        const double depths[3] = { n, 0.5 * (n + f), 0.51 * n + 0.49 * f };
        const float nothing[] = { l.reversed ? 0.0f : 1.0f, NAN, INFINITY, -INFINITY, -0.5f, -1e-30f, 1.5f };
        const char *why = "";
        double ndc[3], off = 0;
        float m[16];
        ssgi_view view;
        matrix(m, &l, i);
        if (!CHECK(ssgi_view_from_projection(&view, m, l.clip, 1920, 1080, &why) == SSGI_OK, "%s: %s", l.name, why))
            continue;
        CHECK(view.orthographic == l.ortho && view.clear == nothing[0] && view.width == 1920 && view.height == 1080,
              "%s: orthographic %d, clear %g", l.name, view.orthographic, (double)view.clear);
        /* Checks that rows which run down are those of the matrix with a negated second row. */
        ssgi_view down, turned;
        memset(&down, 0, sizeof down);
        memset(&turned, 1, sizeof turned);
        ssgi_view_from_projection(&down, m, l.clip + SSGI_CLIP_ROWS_DOWN, 1920, 1080, NULL);
        for (int k = 1; k < 16; k += 4) m[k] = -m[k];
        ssgi_view_from_projection(&turned, m, l.clip, 1920, 1080, NULL);
        for (int k = 1; k < 16; k += 4) m[k] = -m[k];
        CHECK(!memcmp(&down, &turned, sizeof down), "%s: rows that run down", l.name);
        for (size_t k = 0; k < 3; ++k) {                 /* in double, by the matrix; window depth as a float */
            const double z = depths[k], w = (double)m[11] * -z + (double)m[15],
                         deep = ((double)m[10] * -z + (double)m[14]) / w;
            const float window = (float)fmin(fmax(l.clip == SSGI_CLIP_GL ? 0.5 * deep + 0.5 : deep, 0), 1);
            /* the loss of the layout itself: rounding of window depth and of the sum's terms */
            const double lost = 1.2e-7 * fmax(fabs((double)view.depth[0]), fabs((double)(view.depth[1] * window))),
                         within = l.ortho ? lost : z * z * lost, got = (double)ssgi_view_depth(&view, window);
            CHECK(fabs(got - z) <= 1e-6 * fabs(z) + within, "%s: depth %.9g of %g", l.name, got, z);
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
            by_matrix(ndc, m, p);
            for (int c = 0; c < 2; ++c) {
                grow(&off, (0.5 * ndc[c] + 0.5) * (c ? 1080 : 1920) - (double)pixel[c]);
                grow(&off, (double)back[c] - (double)pixel[c]);
            }
            CHECK(p[2] == -z && back[2] == z, "%s: depth %g became %g", l.name, (double)z, (double)back[2]);
        }
        CHECK(off < 1e-3, "%s: a pixel, by the matrix or back, is off by %g", l.name, off);
    }
}

/* Makes a rigid matrix of camera axes: z is given, and the turn about it is random. */
static void rigid(float m[16], const float z[3])
{
    float axis[3][3], aside[3];
    do { direction(aside); } while (fabs(dot(aside, z)) > 0.9);
    cross(axis[0], aside, z);
    const double length = sqrt(dot(axis[0], axis[0]));
    for (int k = 0; k < 3; ++k) axis[0][k] = (float)((double)axis[0][k] / length);
    cross(axis[1], z, axis[0]);
    memcpy(axis[2], z, sizeof axis[2]);
    for (int k = 0; k < 3; ++k) {
        for (int a = 0; a < 3; ++a) m[4 * k + a] = axis[a][k];
        m[4 * k + 3] = 0;
        m[12 + k] = t_uniform(-5, 5);
    }
    m[15] = 1;
}

static void through(const float m[16], const float p[3], float w, float out[3])
{
    for (int i = 0; i < 3; ++i) out[i] = m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i] * w;
}

/* Checks left-handed projections, where only z changes, and oblique ones, by points projected in double. */
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
        CHECK(ssgi_view_from_projection(&right, m, l.clip, 1920, 1080, NULL) == SSGI_OK
                  && ssgi_view_from_projection(&left, last, l.clip, 1920, 1080, NULL) == SSGI_OK
                  && !memcmp(&left, &right, sizeof left),
              "%s: left-handed is another view", l.name);
        m[2] = 0.2f * m[0];
        m[6] = -0.3f * m[0];
        if (!CHECK(ssgi_view_from_projection(&view, m, l.clip, 1920, 1080, NULL) == SSGI_OK, "%s, oblique: refused",
                   l.name))
            continue;
        for (int k = 0; k < 2000; ++k) {
            const float pixel[2] = { t_uniform(0, 1920), t_uniform(0, 1080) }, z = expf(t_uniform(-1, 5));
            float p[3];
            double ndc[3];
            ssgi_view_position(p, &right, pixel[0], pixel[1], z);
            by_matrix(ndc, m, p);
            const double window = l.clip == SSGI_CLIP_GL ? 0.5 * ndc[2] + 0.5 : ndc[2];
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

/* Checks an extra camera whose eye is so many radii from its centre, in any direction or along the main camera's up. A
   world with z mirrored gives a mirrored camera. */
static void extra_camera_at(int t)
{
    float z[3], main_view[16], view[16], mirrored[16], clip[16], centre[3], offset[3], p[3], up[3], pixel[3];
    /* nearer than 1/sin 50 = 1.305 radii the camera's angle is limited */
    const float radius = expf(t_uniform(-3, 3)), far_away = t % 3 ? t_uniform(1.35f, 6) : t_uniform(0.05f, 1.3f);
    const float reach = far_away * radius, within = 1e-4f * (reach + radius + 10);
    const char *why = "";
    ssgi_view v;
    direction(z);
    rigid(main_view, z);
    for (int k = 0; k < 3; ++k) up[k] = main_view[4 * k + 1];
    direction(z);                                        /* a direction from the centre to the new eye */
    if (t % 10 == 0) memcpy(z, up, sizeof z);
    for (int k = 0; k < 3; ++k) offset[k] = t_uniform(-3, 3);
    /* the eye is main eye + radius * displacement; the centre follows from z and the distance */
    for (int k = 0; k < 3; ++k) {
        float eye = 0;
        for (int i = 0; i < 3; ++i) eye += main_view[4 * k + i] * (radius * offset[i] - main_view[12 + i]);
        centre[k] = eye - reach * z[k];
    }
    if (!CHECK(ssgi_extra_camera(view, clip, main_view, centre, radius, offset, &why) == SSGI_OK
                   && ssgi_view_from_projection(&v, clip, SSGI_CLIP_GL, 1000, 1000, &why) == SSGI_OK,
               "%s", why))
        return;
    for (int k = 8; k < 12; ++k) main_view[k] = -main_view[k];
    const float there[3] = { centre[0], centre[1], -centre[2] };
    CHECK(ssgi_extra_camera(mirrored, clip, main_view, there, radius, offset, &why) == SSGI_OK, "%s", why);
    for (int k = 8; k < 12; ++k) mirrored[k] = -mirrored[k];
    CHECK(apart(view, mirrored, 12) < 2e-5
              && apart(view + 12, mirrored + 12, 4) < 2e-6 * (double)(reach + radius + 10),
          "mirrored, off by %g, its place by %g", apart(view, mirrored, 12), apart(view + 12, mirrored + 12, 4));
    through(view, centre, 1, p);
    CHECK(fabsf(p[0]) < within && fabsf(p[1]) < within && fabsf(p[2] + reach) < within,
          "the centre at %g %g %g, %g away", (double)p[0], (double)p[1], (double)p[2], (double)reach);
    through(view, up, 0, p);
    CHECK(t % 10 == 0 || (fabsf(p[0]) < 1e-3f && p[1] > 0), "the main camera's up at %g %g %g", (double)p[0],
          (double)p[1], (double)p[2]);
    for (int i = 0; i < 9; ++i) {
        const int a = i / 3, b = i % 3;
        const float row[3] = { view[a], view[4 + a], view[8 + a] }, other[3] = { view[b], view[4 + b], view[8 + b] };
        CHECK(fabs(dot(row, other) - (a == b)) < 1e-5, "axes %d and %d: %g", a, b, dot(row, other));
    }
    const double near_plane = (double)clip[14] / ((double)clip[10] - 1),
                 far_plane = (double)clip[14] / ((double)clip[10] + 1), want = (double)radius / 50;
    CHECK(fabs(near_plane / want - 1) < 1e-3 && fabs(far_plane / (double)(reach + radius) - 1) < 1e-3,
          "planes %g %g of a sphere of %g at %g", near_plane, far_plane, (double)radius, (double)reach);
    if (t % 3 == 0) {
        CHECK(fabsf(clip[0] - 0.8390996f) < 1e-5f, "near the sphere: %g, not the cotangent of 50 degrees",
              (double)clip[0]);
        return;
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
    /* where the right edge of the camera's view touches the sphere */
    const float touch[3] = { radius * sqrtf(1 - 1 / (far_away * far_away)), 0, -(far_away - 1 / far_away) * radius };
    ssgi_view_project(pixel, &v, touch);
    CHECK(fabsf(pixel[0] - 1000) < 0.1f, "the sphere's outline at %g, not at the edge", (double)pixel[0]);
}

static void extra_cameras(void)
{
    /* the main camera's eye is at (0,0,2), two radii away */
    const float main_view[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -2, 1 }, origin[3] = { 0, 0, 0 },
                onto[3] = { 0, 0, -2 }, above[3] = { 0, 2, -2 };
    static const double angles[4][2] = { { -60, 20 }, { 60, 20 }, { 0, 75 }, { 180, 50 } };      /* to the side, up */
    float view[16], clip[16], d[3];
    for (int t = 0; t < 300; ++t) extra_camera_at(t);
    for (int i = 0; i < 4; ++i) {
        ssgi_extra_displacement(d, i);
        ssgi_extra_camera(view, clip, main_view, origin, 1, d, NULL);
        const double side = angles[i][0] * PI / 180, high = angles[i][1] * PI / 180,
                     turned[3] = { 2 * sin(side) * cos(high), 2 * sin(high), 2 * cos(side) * cos(high) };
        for (int k = 0; k < 3; ++k)                      /* the eye: minus the translation along the axes */
            CHECK(fabs(-dot(view + 4 * k, view + 12) - turned[k]) < 2e-5, "default %d: eye's %d is %g", i, k,
                  -dot(view + 4 * k, view + 12));
    }
    ssgi_extra_camera(view, clip, main_view, origin, 1, above, NULL);
    CHECK(fabsf(view[1]) < 1e-6f && fabsf(view[5]) < 1e-6f && fabsf(view[9] + 1) < 1e-6f,
          "straight above, up is %g %g %g, not forward", (double)view[1], (double)view[5], (double)view[9]);
    memcpy(view, main_view, sizeof view);
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
                const int cell = (int)ceil((double)s[3] * n - 1e-5) - 1;
                right &= s[3] > 0 && s[3] <= 1 && cell >= 0 && cell < n && !stratum[cell < 0 || cell >= n ? 0 : cell]++;
                right &= fabs(dot(s, s) - 1) < 1e-6 && s[2] > 0;
                z += (double)s[2] / n;
                z2 += (double)s[2] * (double)s[2] / n;
            }
            CHECK(right, "set %d of %d: not unit, or lengths not one a stratum in (0,1]", set, n);
            CHECK(fabs(z2 - 0.5) < 1e-6 && fabs(z - 2.0 / 3) < 0.05 / n, "set %d of %d: mean z^2 %.9g, z %.9g", set, n,
                  z2, z);
        }
    }
}

/* Checks that other kinds have the same points of the square and lengths, with heights of exact sums. */
static void spread(void)
{
    static float k[4 * SETS * SAMPLES], d[4 * SETS * SAMPLES];
    for (int n = 1; n <= SAMPLES; n += n < 8 ? 1 : 7) {
        ssgi_kernel(k, SETS, n, NULL);
        CHECK(ssgi_directions(d, SSGI_DIRECTIONS_COSINE, SETS, n, NULL) == SSGI_OK
                  && !memcmp(d, k, (size_t)(4 * SETS * n) * sizeof *d),
              "%d by the cosine are not the kernel's", n);
        for (int i = 0; i < 2 * SETS; ++i) {
            const int kind = i % 2 ? SSGI_DIRECTIONS_UNIFORM : SSGI_DIRECTIONS_SPHERE;
            const float *o = d + 4 * (i / 2 * n), *c = k + 4 * (i / 2 * n);
            double z = 0, off = 0;
            CHECK(ssgi_directions(d, kind, SETS, n, NULL) == SSGI_OK, "refused");
            for (int s = 0; s < n; ++s, o += 4, c += 4) {
                const double u = 1 - (double)c[2] * (double)c[2], up = (double)o[2];
                grow(&off, (kind == SSGI_DIRECTIONS_SPHERE ? (1 - up) / 2 : 1 - up) - u);
                grow(&off, dot(o, o) - 1);
                grow(&off, (double)o[0] * (double)c[1] - (double)o[1] * (double)c[0]);
                grow(&off, (double)(o[0] * c[0] + o[1] * c[1] < 0) + fabs((double)(o[3] - c[3])));
                z += (double)o[2] / n;
            }
            CHECK(off < 1e-6, "kind %d, set %d of %d: a direction or a length is off by %g", kind, i / 2, n, off);
            CHECK(fabs(2 * z - (kind == SSGI_DIRECTIONS_UNIFORM)) < 1e-6, "kind %d, set %d of %d: sum 2 z/n %.9g", kind,
                  i / 2, n, 2 * z);
        }
    }
}

/* w, h: windows, worked out by hand. distance: squared, between a set's nearest copies. */
static void tiles(void)
{
    static const struct { int size, sets, w, h, distance;
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
            grow(&off, set - floor(set + 0.5));
            grow(&off, b - floor(b) - 0.5);
            grow(&off, (double)t[4 * i] - cos(PI / 3 * turn));
            grow(&off, (double)t[4 * i + 1] - sin(PI / 3 * turn));
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
}

/* Returns the largest difference between a box' share of the points and its area, for boxes at the origin. */
static double discrepancy(double (*p)[2], int n)
{
    double worst = 0;
    for (int i = 0; i < n * n; ++i) {
        const double x = p[i / n][0], y = p[i % n][1];
        int open = 0, closed = 0;
        for (int k = 0; k < n; ++k) {
            open += p[k][0] < x && p[k][1] < y;
            closed += p[k][0] <= x && p[k][1] <= y;
        }
        worst = fmax(worst, fmax(x * y - (double)open / n, (double)closed / n - x * y));
    }
    return worst;
}

static void evenness(void)
{
    static float k[4 * SETS * 128];
    static double p[128][2];
    for (int n = 16; n <= 128; n *= n < 64 ? 4 : 2) {
        double mean = 0, worst = 0, random = 0;
        ssgi_kernel(k, SETS, n, NULL);
        for (int set = 0; set < SETS; ++set) {           /* maps directions back to the square: azimuth and u */
            for (int i = 0; i < n; ++i) {
                const float *o = k + 4 * (set * n + i);
                const double a = atan2((double)o[1], (double)o[0]) / (2 * PI);
                p[i][0] = a - floor(a);
                p[i][1] = 1 - (double)o[2] * (double)o[2];
            }
            mean += discrepancy(p, n) / SETS;
            worst = fmax(worst, discrepancy(p, n));
            for (int i = 0; i < 2 * n; ++i) p[i / 2][i % 2] = (double)t_uniform(0, 1);
            random += discrepancy(p, n) / SETS;
        }
        for (int i = 0; i < n; ++i) {
            float q[2];
            ssgi_r2(q, (uint32_t)i);
            p[i][0] = (double)q[0];
            p[i][1] = (double)q[1];
        }
        const double r2 = discrepancy(p, n);
        CHECK(worst < log(n) / n && mean < 0.5 * random && r2 < 2 * log(n) / n,
              "%d points: sets %.3f, at worst %.3f, R2 %.3f, random %.3f", n, mean, worst, r2, random);
        t_note("star discrepancy of %d points: sets %.3f, R2 %.3f, random %.3f", n, mean, r2, random);
    }
    CHECK(ssgi_radical_inverse(2, 6) == 0.375f && fabsf(ssgi_radical_inverse(3, 5) - 7.0f / 9) < 1e-7f
              && ssgi_radical_inverse(2, 0xffffffffu) < 1.0f && ssgi_radical_inverse(1, 5) == 0.0f,
          "radical inverse");
}

/* ---- >>sh -------------------------------------------------------------------------------------------------------- */

enum { SKY = 64, CUBE = 24, MOST = SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS };
static const float axis_z[3] = { 0, 0, 1 };

/* Returns the value of a channel in a direction. factor: of each band, NULL: 1. */
static double value(const float *coefficients, int channels, int bands, const float d[3], const double *factor)
{
    float basis[MOST];
    double sum = 0;
    ssgi_sh_basis(basis, bands, d);
    for (int l = 0, i = 0; l < bands; ++l)
        for (; i < (l + 1) * (l + 1); ++i)
            sum += (double)basis[i] * (double)coefficients[channels * i] * (factor ? factor[l] : 1);
    return sum;
}

/* A table by band l: 2 pi times the integral of z P_l(z) over [0,1]. */
static const double cosine[SSGI_SH_MAX_BANDS] = { PI, 2 * PI / 3, PI / 4, 0, -PI / 24, 0 };

/* The Legendre polynomial P_l. */
static double legendre(int l, double c)
{
    double now = 1, before = 0;
    for (int k = 0; k < l; ++k) {
        const double next = ((2 * k + 1) * c * now - k * before) / (k + 1);
        before = now;
        now = next;
    }
    return now;
}

/* Writes a pixel's direction as in OpenEXR: latitude falls from pi/2, longitude from pi. Returns a solid angle. */
static double equirect(float d[3], int i, int width, int height)
{
    const double lat = PI * (0.5 - (i / width + 0.5) / height), lon = PI - 2 * PI * (i % width + 0.5) / width;
    d[0] = (float)(cos(lat) * sin(lon));
    d[1] = (float)sin(lat);
    d[2] = (float)(cos(lat) * cos(lon));
    return (sin(lat + PI / 2 / height) - sin(lat - PI / 2 / height)) * 2 * PI / width;
}

/* Makes an environment of bands 0..2 by random coefficients; band 0 keeps it above 0. */
static void smooth(float *rgb, float coefficients[27], int width, int height)
{
    float d[3];
    for (int i = 0; i < 27; ++i) coefficients[i] = i < 3 ? t_uniform(9, 12) : t_uniform(-1, 1);
    for (int i = 0; i < 3 * width * height; ++i) {
        equirect(d, i / 3, width, height);
        rgb[i] = (float)value(coefficients + i % 3, 3, 3, d, NULL);
    }
}

/* Checks the table's functions, and for the bands that it leaves out the addition theorem. */
static void harmonics(void)
{
    static const double constant[16] = { 0.28209479177387814, 0.48860251190291992, 0.48860251190291992,
                                         0.48860251190291992, 1.0925484305920792,  1.0925484305920792,
                                         0.31539156525252005, 1.0925484305920792,  0.54627421529603959,
                                         0.59004358992664352, 2.8906114426405538,  0.45704579946446577,
                                         0.3731763325901154,  0.45704579946446577, 1.4453057213202769,
                                         0.59004358992664352 };
    for (int t = 0; t < 200; ++t) {
        float a[3], b[3], ya[37], yb[36], zonal[6], turned[36];
        direction(a);
        direction(b);
        const double x = (double)a[0], y = (double)a[1], z = (double)a[2], c = dot(a, b);
        const double polynomial[16] = { 1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y,
                                        y * (3 * x * x - y * y), x * y * z, y * (5 * z * z - 1), z * (5 * z * z - 3),
                                        x * (5 * z * z - 1), z * (x * x - y * y), x * (x * x - 3 * y * y) };
        ya[36] = 7;
        ssgi_sh_basis(ya, t & 1 ? 6 : 99, a);
        ssgi_sh_basis(yb, 6, b);
        CHECK(ya[36] == 7.0f, "more bands than there are were written");
        for (int i = 0; i < 16; ++i)
            CHECK(fabs((double)ya[i] - constant[i] * polynomial[i]) < 1e-6, "function %d: %.9g, the table has %.9g", i,
                  (double)ya[i], constant[i] * polynomial[i]);
        for (int l = 0; l < 6; ++l) {
            double sum = 0;
            for (int i = l * l; i < (l + 1) * (l + 1); ++i) sum += (double)ya[i] * (double)yb[i];
            CHECK(fabs(sum * 4 * PI / (2 * l + 1) - legendre(l, c)) < 1e-5, "band %d at cosine %g: %.9g", l, c, sum);
            zonal[l] = (float)(cosine[l] * sqrt((2 * l + 1) / (4 * PI)));
        }
        /* the transfer of an open point about any normal */
        ssgi_sh_zonal(turned, 6, zonal, a);
        for (int i = 0; i < 36; ++i)
            CHECK(fabs((double)turned[i] - cosine[(int)sqrt(i)] * (double)ya[i]) < 1e-6, "coefficient %d: %g", i,
                  (double)turned[i]);
    }
    for (int l = -1; l < 7; ++l)
        CHECK(fabs((double)ssgi_sh_cosine(l) - (l < 0 || l > 5 ? 0 : cosine[l])) < 4e-7, "cosine, band %d: %.9g", l,
              (double)ssgi_sh_cosine(l));
}

static void projections(void)
{
    static float rgb[6 * SKY * SKY], cube[6][3 * CUBE * CUBE];
    const float *const faces[6] = { cube[0], cube[1], cube[2], cube[3], cube[4], cube[5] };
    float given[48] = { 0 }, got[2][48];
    const char *why = "";
    smooth(rgb, given, 2 * SKY, SKY);
    for (int i = 0; i < 6 * CUBE * CUBE; ++i) {
        const int face = i / (CUBE * CUBE), at = i % (CUBE * CUBE);
        const float s = ((float)(at % CUBE) * 2 + 1) / CUBE - 1, t = ((float)(at / CUBE) * 2 + 1) / CUBE - 1,
                    l = sqrtf(1 + s * s + t * t);
        /* OpenGL 4.6 table 8.19 of cube map faces, solved for the direction */
        const float table[6][3] = { { 1, -t, -s }, { -1, -t, s }, { s, 1, t },
                                    { s, -1, -t }, { s, -t, 1 },  { -s, -t, -1 } };
        const float p[3] = { table[face][0] / l, table[face][1] / l, table[face][2] / l };
        for (int c = 0; c < 3; ++c) cube[face][3 * at + c] = (float)value(given + c, 3, 3, p, NULL);
    }
    CHECK(ssgi_sh_project_equirect(got[0], 4, rgb, 2 * SKY, SKY, &why) == SSGI_OK
              && ssgi_sh_project_cube(got[1], 4, faces, CUBE, &why) == SSGI_OK,
          "%s", why);
    for (int i = 0; i < 2 * 48; ++i)
        CHECK(fabsf(got[i / 48][i % 48] - given[i % 48]) < 1e-3f * given[i % 3], "%s, coefficient %d: %g, given %g",
              i < 48 ? "latitude-longitude" : "cube", i % 48, (double)got[i / 48][i % 48], (double)given[i % 48]);
    for (int i = 0; i < 6 * 3 * CUBE * CUBE; ++i) cube[i % 6][i / 6] = 1;
    ssgi_sh_project_cube(got[0], 1, faces, CUBE, NULL);
    CHECK(fabs((double)got[0][0] - 2 * sqrt(PI)) < 1e-6,
          "a cube of ones: %.9g, not 2 sqrt(pi): solid angles do not sum to 4 pi", (double)got[0][0]);
}

/* ---- >>sh: windows, lights, rotation, products ------------------------------------------------------------------- */

/* Returns the most light that a mask takes from any surface by passing only where the series is below 0. */
static double worst_mask(const float *c, int bands)
{
    enum { PANELS = 128, TURNS = 180 };
    double worst = 0;
    for (int degrees = 0; degrees <= 180; degrees += 2) {
        double taken = 0;
        for (int row = 0; row < PANELS; ++row) {         /* at middles of intervals of height and azimuth */
            const double z = 2 * (row + 0.5) / PANELS - 1, r = sqrt(1 - z * z);
            const float d[3] = { (float)r, 0, (float)z };
            const double negative = fmin(value(c, 3, bands, d, NULL), 0);
            for (int k = 0; k < TURNS && negative < 0; ++k)
                taken += negative * 4 * PI / (PANELS * TURNS)
                         * fmax(r * cos(2 * PI * (k + 0.5) / TURNS) * sin(degrees * PI / 180)
                                    + z * cos(degrees * PI / 180), 0);
        }
        worst = fmin(worst, taken);
    }
    return worst;
}

static void windows(void)
{
    static const struct { int window, bands; double k, zonal[4], peak, least_over_peak, back, least, worst;
    } row[] = { { SSGI_SH_WINDOW_NONE, 4, 0.941176471, { 0.26550098, 0.459861188, 0.59367824, 0.702449567 }, 1.1983431,
                  -0.25, 0.0588235294, -0.0372549015, -0.200493339 },
                { SSGI_SH_WINDOW_HANN, 3, 1.42222222, { 0.401201482, 0.521176013, 0.224278446, 0 }, 0.509295818,
                  -0.0666666667, -0.0666666667, -0.0666666667, -0.0682681998 },
                { SSGI_SH_WINDOW_HANN, 4, 1.20044172, { 0.338638357, 0.500642216, 0.378609193, 0.131209261 },
                  0.676891835, -0.0463197199, -0.0246411014, -0.0268969816, -0.0345885498 },
                { SSGI_SH_WINDOW_POSITIVE, 4, 1.63265306, { 0.460562925, 0.478631032, 0.205970002, 0.0348152847 },
                  0.51968961, 0, 0.0204081633, 0.0204081633, 0 } };
    static const float one[3] = { 1, 1, 1 }, nowhere[3] = { 0, 0, -1 };
    float w[MOST];
    for (size_t t = 0; t < sizeof row / sizeof row[0]; ++t) {
        float c[3 * MOST] = { 0 };
        const int bands = row[t].bands;
        double least = 1e30, lowest = 1e30;
        ssgi_sh_light(c, bands, axis_z, 0, one, row[t].window, NULL);
        for (int l = 0; l < bands; ++l)
            CHECK(fabs((double)c[3 * (l * l + l)] - row[t].zonal[l]) < 1e-6, "window %d, zonal %d: %.9g", row[t].window,
                  l, (double)c[3 * (l * l + l)]);
        const double k = (double)c[0] / 0.28209479177, peak = value(c, 3, bands, axis_z, NULL),
                     facing = value(c, 3, bands, axis_z, cosine), behind = value(c, 3, bands, nowhere, cosine);
        CHECK(fabs(k - row[t].k) < 1e-6 && fabs(peak / row[t].peak - 1) < 1e-6 && fabs(facing - 1) < 1e-5
                  && fabs(behind - row[t].back) < 1e-5,
              "k %.9g, peak %.9g, facing %.9g, behind %.9g", k, peak, facing, behind);
        for (int i = 0; i <= 10000; ++i) {
            const float d[3] = { (float)sin(i * PI / 10000), 0, (float)cos(i * PI / 10000) };
            least = fmin(least, value(c, 3, bands, d, cosine));
            lowest = fmin(lowest, value(c, 3, bands, d, NULL));
        }
        const double worst = worst_mask(c, bands);
        CHECK(fabs(least - row[t].least) <= 1e-4 && fabs(lowest / row[t].peak - row[t].least_over_peak) < 1e-4
                  && fabs(worst - row[t].worst) < 2e-4,
              "window %d, %d bands: least irradiance %.6g, of the light %.6g, by any mask %.6g", row[t].window, bands,
              least, lowest / row[t].peak, worst);
    }
    /* the Legendre coefficients of ((1 + z)/2)^p over the first: each is (p - l) / (p + l + 2) times its predecessor */
    for (int bands = 1; bands <= 6; ++bands) {
        double positive = 1;
        for (int window = SSGI_SH_WINDOW_HANN; window <= SSGI_SH_WINDOW_POSITIVE; ++window) {
            w[bands] = 7;
            ssgi_sh_window(w, bands, window);
            for (int l = 0; l < bands; ++l) {
                const double want = window == SSGI_SH_WINDOW_HANN ? pow(cos(PI * l / (2 * bands)), 2) : positive;
                CHECK(fabs((double)w[l] - want) < 1e-6 && w[bands] == 7.0f, "window %d, band %d of %d: %.9g, not %.9g",
                      window, l, bands, (double)w[l], want);
                if (window == SSGI_SH_WINDOW_POSITIVE) positive *= (bands - 1.0 - l) / (bands + 1.0 + l);
            }
        }
    }
    ssgi_sh_window(w, 99, 99);
    CHECK(w[0] == 1.0f && w[5] == 1.0f && w[6] != 1.0f, "a window that there is not");
}

/* Checks that a band's factor of a cap is the mean of its Legendre polynomial over the cap. */
static void lights(void)
{
    static const float sines[] = { 0, 1e-6f, 0.01f, 0.3f, 0.8f, 1 }, red[3] = { 3, 0.5f, -1 };
    for (int t = 0; t < 6 * 6 * 3; ++t) {
        const int bands = 1 + t % 6, window = t / 36, count = 3 * bands * bands;
        const float sine = sines[t / 6 % 6];
        const double from = sqrt(1 - (double)sine * (double)sine);
        float d[3], far_away[3], c[3 * MOST] = { 0 }, twice[3 * MOST], w[6], zonal[6], turned[MOST];
        const char *why = "";
        direction(d);
        for (int i = 0; i < 3; ++i) far_away[i] = 40 * d[i];
        CHECK(ssgi_sh_light(c, bands, far_away, sine, red, window, &why) == SSGI_OK, "%s", why);
        for (int i = 0; i < 3; ++i)
            CHECK(fabs(value(c + i, 3, bands, d, cosine) / (double)red[i] - (bands > 1 ? 1 : 0.25)) < 1e-5,
                  "%d bands, window %d, sine %g: facing %.9g of %g", bands, window, (double)sine,
                  value(c + i, 3, bands, d, cosine), (double)red[i]);
        ssgi_sh_window(w, bands, window);
        for (int l = 0; l < bands; ++l) {
            const double mean = l == 0 || sine < 1e-3f ? 1
                              : (legendre(l - 1, from) - legendre(l + 1, from)) / ((2 * l + 1) * (1 - from));
            zonal[l] = (float)((double)c[0] * (double)w[l] * mean * sqrt(2 * l + 1));
        }
        ssgi_sh_zonal(turned, bands, zonal, d);
        for (int i = 0; i < bands * bands; ++i)
            CHECK(fabsf(c[3 * i] - turned[i]) < 2e-5f, "sine %g, coefficient %d: %g, of the cap %g", (double)sine, i,
                  (double)c[3 * i], (double)turned[i]);
        memcpy(twice, c, sizeof c);
        ssgi_sh_light(twice, bands, d, sine, red, window, NULL);
        for (int i = 0; i < 3 * MOST; ++i)
            CHECK(fabsf(twice[i] - 2 * c[i]) < 1e-5f && (i < count || c[i] == 0.0f), "twice, coefficient %d: %g and %g",
                  i, (double)c[i], (double)twice[i]);
    }
}

static void rotations(void)
{
    for (int t = 0; t < 120; ++t) {
        const int bands = 1 + t % 6, channels = t % 4 * 2 - 1, count = channels * bands * bands;   /* -1: no channels */
        float f[5 * MOST], turned[5 * MOST], twice[5 * MOST], at_once[5 * MOST], z[3], d[3], e[3], m[2][16], both[16];
        for (int i = 0; i < 5 * MOST; ++i) {
            f[i] = t_uniform(-1, 1);
            turned[i] = at_once[i] = 7;
        }
        for (int k = 0; k < 2; ++k) {
            direction(z);
            rigid(m[k], z);
        }
        for (int i = 2; i < 16 && t % 2; i += 4) m[0][i] = -m[0][i];     /* mirrored, as left-handed engines' are */
        for (int i = 0; i < 4; ++i) through(m[1], m[0] + 4 * i, 0, both + 4 * i);
        ssgi_sh_rotate(turned, bands, f, channels, m[0]);
        memcpy(twice, turned, sizeof twice);
        ssgi_sh_rotate(twice, bands, twice, channels, m[1]);
        ssgi_sh_rotate(at_once, bands, f, channels, both);
        CHECK(apart(twice, at_once, 5 * MOST) < 5e-6, "%d bands, %d channels: twice is off by %g", bands, channels,
              apart(twice, at_once, 5 * MOST));
        for (int i = count < 0 ? 0 : count; i < 5 * MOST; ++i) CHECK(turned[i] == 7.0f, "%d is written to", i);
        for (int k = 0; k < 5 * channels; ++k) {
            direction(d);
            through(m[0], d, 0, e);
            const double is = value(turned + k / 5, channels, bands, e, NULL),
                         was = value(f + k / 5, channels, bands, d, NULL);
            CHECK(fabs(is - was) < 2e-5, "%d bands, channel %d: %.9g, before %.9g", bands, k / 5, is, was);
        }
        ssgi_sh_rotate(turned, bands, f, channels, NULL);
        CHECK(count < 0 || apart(turned, f, count) < 1e-6, "no rotation is off by %g", apart(turned, f, count));
    }
}

/* ---- >>environment ----------------------------------------------------------------------------------------------- */

/* Writes the direction of a texel's centre in an octahedral map. */
static void map_direction(float d[3], int size, int at)
{
    const float e[2] = { ((float)(at % size) + 0.5f) / (float)size * 2 - 1,
                         ((float)(at / size) + 0.5f) / (float)size * 2 - 1 };
    ssgi_octahedral_decode(d, e);
}

static void octahedral(void)
{
    static const float zero[3] = { 0, 0, 0 };
    float e[2] = { 7, 7 };
    ssgi_octahedral_encode(e, zero);
    CHECK(e[0] == 0.0f && e[1] == 0.0f, "no direction: %g %g", (double)e[0], (double)e[1]);
    for (int t = 0; t < 3000; ++t) {
        float d[3], back[3];
        direction(d);
        /* axes, edges, corners */
        const int k = t < 13 ? t : t + 1;
        for (int i = 0, by = 1; i < 3 && t < 26; ++i, by *= 3) d[i] = (float)(k / by % 3 - 1);
        const float length = (float)sqrt(dot(d, d)), size = expf(t_uniform(-60, 40));
        for (int i = 0; i < 3; ++i) d[i] /= length;
        const float any[3] = { size * d[0], size * d[1], size * d[2] };
        ssgi_octahedral_encode(e, any);                  /* of any length */
        ssgi_octahedral_decode(back, e);
        CHECK(fabsf(e[0]) <= 1 && fabsf(e[1]) <= 1 && dot(d, back) > 1 - 1e-6 && fabs(dot(back, back) - 1) < 1e-6,
              "%g %g %g to %g %g to %g %g %g", (double)d[0], (double)d[1], (double)d[2], (double)e[0], (double)e[1],
              (double)back[0], (double)back[1], (double)back[2]);
        e[0] = t_uniform(-1, 1);
        e[1] = t_uniform(-1, 1);
        ssgi_octahedral_decode(back, e);                 /* decodes by the GLSL function, word for word */
        float n[3] = { e[0], e[1], 1 - fabsf(e[0]) - fabsf(e[1]) };
        const float fold = fmaxf(-n[2], 0);
        for (int i = 0; i < 2; ++i) n[i] += n[i] >= 0 ? -fold : fold;
        const float l = (float)sqrt(dot(n, n));
        for (int i = 0; i < 3; ++i) n[i] /= l;
        CHECK(apart(back, n, 3) < 1e-6, "decoding %g %g is off by %g", (double)e[0], (double)e[1], apart(back, n, 3));
    }
}

static void environment_maps(void)
{
    enum { SIDE = 32 };
    static const float angles[] = { 0, 1e-6f, 0.05f, 0.39f, 3, 12 };
    static const int sizes[][2] = { { 1, 1 }, { 5, 3 }, { 97, 41 }, { 300, 100 } };
    static float rgb[3 * 300 * 150], map[2][3 * SIDE * SIDE];
    const char *why = "";
    float d[3], given[27];
    for (size_t k = 0; k < sizeof angles / sizeof angles[0]; ++k) {
        const double kappa = 4 * PI / fmax((double)angles[k], 0.05), mean_cosine = 1 / tanh(kappa) - 1 / kappa;
        /* the factor of the lobe in each band */
        const double lobe[3] = { 1, k ? mean_cosine : 2.0 / 3, k ? 1 - 3 * mean_cosine / kappa : 0.25 };
        double worst = 0, mean = 0, all = 0;
        for (int s = 0; s < 4; ++s) {
            const float constant[3] = { 0.7f, 1e4f, 0 };
            for (int i = 0; i < 3 * sizes[s][0] * sizes[s][1]; ++i) rgb[i] = constant[i % 3];
            CHECK(ssgi_environment_map(map[0], 8, rgb, sizes[s][0], sizes[s][1], angles[k], &why) == SSGI_OK, "%s",
                  why);
            for (int i = 0; i < 3 * 64; ++i)
                CHECK(fabsf(map[0][i] - constant[i % 3]) <= 1e-6f * constant[i % 3], "constant, %d x %d, lobe %g: %.9g",
                      sizes[s][0], sizes[s][1], (double)angles[k], (double)map[0][i]);
        }
        smooth(rgb, given, 300, 150);
        ssgi_environment_map(map[0], SIDE, rgb, 300, 150, angles[k], NULL);
        for (int i = 0; i < SIDE * SIDE; ++i) {
            map_direction(d, SIDE, i);
            /* a texel's solid angle is proportional to 1/s^3 */
            const double s = fabs((double)d[0]) + fabs((double)d[1]) + fabs((double)d[2]), weight = s * s * s;
            for (int c = 0; c < 3; ++c)
                grow(&worst, ((double)map[0][3 * i + c] - value(given + c, 3, 3, d, lobe)) * sqrt(4 * PI)
                                 / (double)given[c]);
            mean += weight * (double)map[0][3 * i];
            all += weight;
        }
        CHECK(worst < 3e-3 && fabs(mean / all * sqrt(4 * PI) / (double)given[0] - 1) < 1e-3,
              "lobe %g: off by %g of the mean; mean %.9g of %.9g", (double)angles[k], worst, mean / all,
              (double)given[0] / sqrt(4 * PI));
        t_note("lobe of %g sr: worst error %.2g of the mean", (double)angles[k], worst);
    }
    /* negative, infinite and NaN values must count as 0 in each function */
    ssgi_sun suns[2][5];
    float sh[2][27];
    const float kept = rgb[30000];
    for (int pass = 0; pass < 2; ++pass) {
        rgb[0] = pass ? 0 : NAN;
        rgb[301] = pass ? 0 : INFINITY;
        rgb[20000] = pass ? 0 : -INFINITY;
        ssgi_sh_project_equirect(sh[pass], 3, rgb, 300, 150, NULL);
        rgb[30000] = pass ? 0 : -5;
        ssgi_environment_map(map[pass], SIDE, rgb, 300, 150, 0.39f, NULL);
        ssgi_environment_suns(suns[pass], 5, rgb, 300, 150, NULL);
        rgb[30000] = kept;
    }
    CHECK(!memcmp(sh[0], sh[1], sizeof sh[0]) && !memcmp(map[0], map[1], sizeof map[0])
              && !memcmp(suns[0], suns[1], sizeof suns[0]),
          "an infinite, NaN or negative value does not count as 0");
}

/* Checks a sky of 1 with a disc of 101, which has a radius of 6 degrees and is 40 degrees up: inside of the cones,
   across their rims and outside. */
static void environment_cones(void)
{
    enum { W = 480, H = 240, SIDE = 32, PARTS = 400 };
    static const float cosines[] = { 0, 0.02f, 0.25f, 0.5f, 0.75f, 0.95f };
    static float rgb[3 * W * H], map[3 * SIDE * SIDE], open[3 * SIDE * SIDE];
    const double radius = 6 * PI / 180, high = sin(40 * PI / 180);
    const float sun[3] = { 0.3f, (float)high, (float)sqrt(1 - 0.09 - high * high) };
    const char *why = "";
    float d[3];
    for (int i = 0; i < W * H; ++i) {
        equirect(d, i, W, H);
        rgb[3 * i] = dot(d, sun) > cos(radius) ? 101 : 1;
        rgb[3 * i + 1] = 0.7f;
    }
    CHECK(ssgi_environment_map(open, SIDE, rgb, W, H, 0, NULL) == SSGI_OK
              && ssgi_environment_cone(map, SIDE, rgb, W, H, 0, &why) == SSGI_OK && !memcmp(map, open, sizeof map),
          "cosine 0 is not irradiance %s", why);
    for (size_t k = 0; k < sizeof cosines / sizeof cosines[0]; ++k) {
        const double C = (double)cosines[k], half = fmin(C, 3.75 * PI / 180 * sqrt(1 - C * C)), rim = acos(C),
                     inside = 1e2 * pow(sin(radius), 2) / (1 - C * C);
        double worst = 0, across = 0, through_all = 0;
        for (int s = 0; s < PARTS; ++s) {                /* integrates the documented ramp */
            const double part = (1 - C + half) / PARTS, at = C - half + part * (s + 0.5);
            through_all += 2 * PI * part * at * (half > 0 ? fmin((at - C + half) / (2 * half), 1) : 1);
        }
        ssgi_environment_cone(map, SIDE, rgb, W, H, cosines[k], NULL);
        for (int i = 0; i < SIDE * SIDE; ++i) {
            map_direction(d, SIDE, i);
            const double towards = dot(d, sun), angle = acos(fmin(fmax(towards, -1), 1)), is = (double)map[3 * i];
            double seen = 0;                             /* what the ramp passes of the disc: 12 rings of 24 parts */
            for (int part = 0; part < 12 * 24; ++part) {
                const double r = radius * sqrt((part / 24 + 0.5) / 12), turn = 2 * PI * (part % 24 + 0.5) / 24,
                             at = cos(r) * cos(angle) + sin(r) * sin(angle) * cos(turn),
                             ramp = half > 0 ? fmin(fmax((at - C + half) / (2 * half), 0), 1) : at > 0;
                seen += 2 * PI * (1 - cos(radius)) / (12 * 24) * at * ramp;
            }
            grow(&across, (is - 1 - 1e2 * seen / through_all) / (1 + inside));
            CHECK(fabsf(map[3 * i + 1] / 0.7f - 1) < 1e-6f && map[3 * i + 2] == 0.0f, "constant, cosine %g: %.9g", C,
                  (double)map[3 * i + 1]);
            /* the ramp's and a cell's width */
            if (angle > rim + radius + 0.14) CHECK(fabs(is - 1) < 1e-5, "cosine %g, outside: %.9g", C, is);
            else if (angle < rim - radius - 0.14) grow(&worst, is / (1 + inside * towards) - 1);
        }
        CHECK(worst < 5e-3 && across < 0.02,
              "cosine %g: within the cone off by %g of the exact average, across the rim by %g", C, worst, across);
        t_note("cone of cosine %g: disc inside off by %.2g of its exact average, across the rim by %.2g", C, worst,
               across);
    }
}

/* Sums of an image's suns: of irradiances, the least and most luminance, how many are lit. Directions are unit. */
typedef struct summed { double sum[3], least, most; int lit; } summed;

static summed cut(ssgi_sun *suns, int count, const float *rgb, int width, int height)
{
    static const float luminance[3] = { 0.2126f, 0.7152f, 0.0722f };
    summed s = { { 0, 0, 0 }, 1e30, 0, 0 };
    const char *why = "";
    CHECK(ssgi_environment_suns(suns, count, rgb, width, height, &why) == SSGI_OK, "%s", why);
    for (int i = 0; i < count; ++i) {
        const double light = dot(suns[i].irradiance, luminance);
        for (int c = 0; c < 3; ++c) s.sum[c] += (double)suns[i].irradiance[c];
        s.least = fmin(s.least, light);
        s.most = fmax(s.most, light);
        s.lit += light > 0;
        CHECK(fabs(dot(suns[i].direction, suns[i].direction) - 1) < 1e-6, "sun %d of %d has no direction", i, count);
    }
    return s;
}

static void sunlight(void)
{
    static const int counts[] = { 1, 2, 3, 5, 16, 17, 256, 1000, 1024 };
    static float rgb[3 * 600 * 150];
    static ssgi_sun suns[1024];
    float d[3];
    for (int wide = 0; wide < 2; ++wide) {               /* 1: an image above 256 a side, which is cut in two steps */
        const int width = wide ? 600 : 64, height = wide ? 150 : 32;
        double total[3] = { 0, 0, 0 };
        for (int i = 0; i < 3 * width * height; ++i) {
            rgb[i] = t_uniform(0, 1) * (i / 3 % 97 ? 1 : 20);
            total[i % 3] += (double)rgb[i] * equirect(d, i / 3, width, height);
        }
        for (size_t k = 0; k < sizeof counts / sizeof counts[0]; ++k) {
            const summed s = cut(suns, counts[k], rgb, width, height);
            for (int c = 0; c < 3; ++c)
                CHECK(fabs(s.sum[c] / total[c] - 1) < 1e-5, "%d suns of %d x %d: irradiances sum to %.9g, not %.9g",
                      counts[k], width, height, s.sum[c], total[c]);
            if (wide && counts[k] <= 16 && (counts[k] & (counts[k] - 1)) == 0)
                CHECK(s.most < 1.3 * s.least, "%d suns of %d x %d are not about equal: %g to %g", counts[k], width,
                      height, s.least, s.most);
        }
    }
    for (int t = 0; t < 60; ++t) {                       /* one lit texel must give one sun, exactly there */
        const int width = t % 2 ? 500 : 32, height = 20, at = (int)t_uniform(0, (float)(width * height)),
                  count = 1 + t % 20;
        const double energy = 3 * equirect(d, at, width, height);
        for (int i = 0; i < 3 * width * height; ++i) rgb[i] = i / 3 == at ? 3.0f : 0.0f;
        const summed s = cut(suns, count, rgb, width, height);
        CHECK(s.lit == 1 && fabs(s.sum[0] / energy - 1) < 1e-5, "%d suns of one texel are lit, by %g", s.lit, s.sum[0]);
        for (int i = 0; i < count; ++i)
            CHECK(suns[i].irradiance[1] == 0.0f || apart(suns[i].direction, d, 3) < 1e-6, "texel %d of %d: off by %g",
                  at, width, apart(suns[i].direction, d, 3));
    }
    /* the median by hand: seven texels of 1 beside one of 7 */
    for (int i = 0; i < 24; ++i) rgb[i] = i < 21 ? 1 : 7;
    const summed halves = cut(suns, 2, rgb, 8, 1);
    CHECK(halves.lit == 2 && fabs(halves.most / (3.5 * PI) - 1) < 1e-6 && fabs(halves.least / (3.5 * PI) - 1) < 1e-6,
          "halves of 7 and 7: %g %g", halves.least, halves.most);
    for (int i = 0; i < 18; ++i) rgb[i] = 1;             /* more suns than texels */
    const summed six = cut(suns, 40, rgb, 3, 2);
    CHECK(six.lit == 6 && fabs(six.sum[0] / (4 * PI) - 1) < 1e-6, "%d suns of six texels are lit, by %g", six.lit,
          six.sum[0]);
}

/* Checks the median cut of a white sky by hand. A region's width is its longitudes times the sine at its middle. The
   sphere, 360 by 180 degrees, is cut around, into halves; these, 180 by 180, at the horizon; quarters of 127 by 90
   around; those of 64 by 90 at cosine 1/2. Then upper parts, 45 by 60, are cut at 3/4, lower ones, 87 by 30, around. */
static void white_sky(void)
{
    static const struct { int around; double top, bottom;
    } zone[] = { { 4, 1, 0.75 }, { 4, 0.75, 0.5 }, { 8, 0.5, 0 } };
    enum { HEIGHT = 300, COUNT = 32 }; /* cuts fall near rows: at 69.02 and 100 */
    static float rgb[3 * 600 * HEIGHT];
    static ssgi_sun suns[COUNT];
    for (int i = 0; i < 3 * 600 * HEIGHT; ++i) rgb[i] = 1;
    for (int width = 200; width <= 600; width += 400) {
        cut(suns, COUNT, rgb, width, HEIGHT);
        for (size_t z = 0; z < sizeof zone / sizeof *zone; ++z)
            for (int k = 0; k < 2 * zone[z].around; ++k) {
                /* the integral of the directions of a region, (level, up), on which its light lies */
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
                    there += apart(suns[i].direction, want, 3) < 3e-4
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
    static const float luminance[3] = { 0.2126f, 0.7152f, 0.0722f }, dark[2][3] = { { 0, 0, 0 }, { NAN, -1, 0 } };
    const char *why = "";
    double total = 0;
    for (int i = 0; i < PIXELS; ++i) {
        position[3 * i] = (float)i;
        direction(normal + 3 * i);
        for (int c = 0; c < 3; ++c) flux[3 * i + c] = i % 3 == 1 ? t_uniform(0, 1) * (i % 5 ? 1 : 30) : dark[i % 2][c];
        if (i % 3 == 1) total += dot(flux + 3 * i, luminance);
    }
    for (int count = 1; count <= 4096; count = count * 2 + (count == 64)) {
        int chosen[PIXELS] = { 0 };
        double sum = 0;
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
        for (int k = 0; k < PIXELS; ++k) {               /* strata: a pixel's count is off its share by less than two */
            const double share = k % 3 == 1 ? dot(flux + 3 * k, luminance) / total * count : 0;
            CHECK(fabs(chosen[k] - share) < 2, "%d lights: pixel %d is chosen %d times, its share is %g", count, k,
                  chosen[k], share);
        }
    }
}

/* Checks that a map's rows are the strata of as many lights. In them lights stand in the order of the radical inverse,
   so that each column has one. The first and last pixel are halves, so that no light is where two pixels meet. */
static void vpl_strata(void)
{
    enum { SIDE = 16 };
    static float position[3 * (SIDE * SIDE + 1)], flux[3 * (SIDE * SIDE + 1)];
    ssgi_vpl lights[SIDE];
    for (int side = 1; side <= SIDE; side *= 2) {
        unsigned columns = 0;
        for (int i = 0; i < 3 * (side * side + 1); ++i) {
            position[i] = (float)(i / 3);
            flux[i] = i / 3 % (side * side) ? 3 : 1.5f;
        }
        CHECK(ssgi_vpl_choose(lights, side, position, position, flux, (size_t)(side * side + 1), NULL) == SSGI_OK,
              "refused");
        for (int i = 0; i < side; ++i) {
            const int at = (int)lights[i].position[0];
            CHECK(at / side == i, "%d lights: light %d is in row %d", side, i, at / side);
            columns |= 1u << at % side;
        }
        CHECK(columns == (1u << side) - 1, "%d lights: columns %x", side, columns);
    }
}

/* Checks a sky of two colours and two suns: in any bands, the harmonics and the residual add up to the light of an open
   surface. */
static void lacking(void)
{
    enum { SIDE = 16 };
    static const ssgi_sun suns[2] = { { { 0.6f, 0.48f, 0.64f }, { 3, 2, 1 } }, { { 0, 0, -1 }, { 0.5f, 0, 4 } } };
    static const float up[3] = { 0, 1, 0 }, above[3] = { 1, 2, 3 }, below[3] = { 0.5f, 0.25f, 0 };
    for (int t = 0; t < 3 * SSGI_SH_MAX_BANDS; ++t) {
        const int bands = 1 + t / 3, count = t % 3;
        float map[3 * SIDE * SIDE], coefficients[3 * MOST] = { 0 }, basis[MOST], n[3];
        double want[3 * SIDE * SIDE];
        for (int c = 0; c < 3; ++c) {                    /* the hemisphere light of the header of ssgi_sh_light */
            coefficients[c] = sqrtf((float)PI) * (above[c] + below[c]);
            ssgi_sh_basis(basis, 2, up);
            for (int i = 1; i < 4 && bands > 1; ++i)
                coefficients[3 * i + c] = (float)PI * (above[c] - below[c]) * basis[i];
        }
        for (int k = 0; k < count; ++k)
            ssgi_sh_light(coefficients, bands, suns[k].direction, 0, suns[k].irradiance, k, NULL);
        for (int i = 0; i < 3 * SIDE * SIDE; ++i) {
            map_direction(n, SIDE, i / 3);
            const int c = i % 3;
            want[i] = (double)below[c] + ((double)above[c] - (double)below[c]) * (0.5 + 0.5 * (double)n[1]);
            map[i] = (float)want[i];
            for (int k = 0; k < count; ++k)
                want[i] += fmax(0, dot(n, suns[k].direction)) * (double)suns[k].irradiance[c] / PI;
        }
        CHECK(ssgi_sh_residual(map, SIDE, coefficients, bands, suns, count, NULL) == SSGI_OK, "refused");
        for (int i = 0; i < 3 * SIDE * SIDE; ++i) {
            map_direction(n, SIDE, i / 3);
            const double sum = (double)map[i] + value(coefficients + i % 3, 3, bands, n, cosine) / PI;
            CHECK(fabs(sum - want[i]) < 2e-6, "%d bands, %d suns, texel %d: %.9g, open %.9g", bands, count, i / 3, sum,
                  want[i]);
        }
    }
}

/* Returns the irradiance from a rectangle of radiance 1 at a point before it: the closed form of its form factor. */
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

/* Returns the largest relative error of an area's point lights, at side x side points 1 above it, to wide and high. */
static double off_by(const ssgi_vpl *light, int count, const double half[2], int side, double wide, double high)
{
    double worst = 0;
    for (int k = 0; k < side * side; ++k) {
        const double p[3] = { wide * (2.0 * (k % side) / (side - 1) - 1), high * (2.0 * (k / side) / (side - 1) - 1),
                              1 };
        double got = 0;
        for (int i = 0; i < count; ++i) {
            const double x = p[0] - (double)light[i].position[0], y = p[1] - (double)light[i].position[1];
            got += (double)light[i].intensity[0] / pow(x * x + y * y + 1, 2);
        }
        grow(&worst, got / seen_from(p, half) - 1);
    }
    return worst;
}

static void areas(void)
{
    static const float corner[3] = { -1, -0.5f, 0 }, a[3] = { 2, 0, 0 }, b[3] = { 0, 1, 0 }, radiance[3] = { 1, 0, 3 },
                       other[3] = { 1, 0.5f, 0 }, back[2][3] = { { -2, 0, 0 }, { 0, -1, 0 } },
                       square[3] = { -1, -1, 0 };
    static const double half[2][2] = { { 1, 0.5 }, { 1, 1 } };
    static ssgi_vpl light[4096];
    for (int count = 1; count <= 4096; count *= 4)
        for (int halves = 0; halves < 1 + (count > 1); ++halves) {   /* 1: as two triangles, each of half the lights */
            const int each = halves ? count / 2 : count;
            double sum = 0;
            CHECK(ssgi_vpl_area(light, each, corner, a, b, halves, radiance, NULL) == SSGI_OK
                      && (!halves
                          || ssgi_vpl_area(light + each, each, other, back[0], back[1], 1, radiance, NULL) == SSGI_OK),
                  "refused");
            for (int i = 0; i < count; ++i) {
                const float *p = light[i].position;
                CHECK(fabsf(p[0]) < 1 && fabsf(p[1]) < 0.5f && p[2] == 0 && light[i].normal[2] == 1, "light %d of %d",
                      i, count);
                sum += (double)light[i].intensity[2];
            }
            CHECK(fabs(sum / 6 - 1) < 1e-5, "%d lights: intensity %g of an area of 2", count, sum);
            const double worst = off_by(light, count, half[0], 3, 1, 0.5);
            CHECK(worst < 1.5 / count, "%d lights%s: irradiance off by %.3f", count, halves ? ", triangles" : "",
                  worst);
            if (count == 64) t_note("64 lights%s: irradiance at most %.4f off", halves ? ", triangles" : "", worst);
        }
    for (int k = 0; k < 2; ++k) {              /* PAPERS.md's figures are at a height of half the longer side */
        const float side[3] = { 0, k ? 2 : 1, 0 };
        CHECK(ssgi_vpl_area(light, 64, k ? square : corner, a, side, 0, radiance, NULL) == SSGI_OK, "refused");
        const double worst = off_by(light, 64, half[k], 81, 2, 2);
        CHECK(fabs(worst - (k ? 0.037 : 0.017)) < 0.0005, "64 lights of 2 x %d: off by %.4f", 1 + k, worst);
    }
}

/* ---- >>bias ------------------------------------------------------------------------------------------------------ */

/* Checks biases [HSAO08 4.1.1; SSDO09 5] by the papers' and references' numbers; and input that is none. */
static void biases(void)
{
    static const float m[16] = { 0.9742786f, 0, 0, 0, 0, 1.7320508f, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 };
    static const struct { double angle; int resolution; double z, alpha, patch, published, safe;
    } row[] = { { 60, 1024, 10, 0, 0.0112763724, 0, 0 },
                { 60, 1024, 10, 80, 0.0112763724, 0.031975743, 0.0452205294 },
                { 90, 512, 5, 45, 0.01953125, 0.009765625, 0.0138106793 },
                { 90, 512, 5, 89.9, 0.01953125, 5.59528529, 7.91292834 },
                { 45, 2048, 20, 60, 0.00809010864, 0.0070062396, 0.00990831907 } };
    static const float odd[] = { NAN, INFINITY, -INFINITY, -1, 0, 1, 1e38f };
    static const float wide[2][16] = { { 1.5f, 0, 0, 0, 0, -2.4f, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 },
                                       { 0.02f, 0, 0, 0, 0, 0.05f, 0, 0, 0, 0, -0.02f, 0, 0, 0, -1, 1 } };
    enum { ODD = (int)(sizeof odd / sizeof *odd) };
    ssgi_view v;
    ssgi_view_from_projection(&v, m, SSGI_CLIP_GL, 1280, 720, NULL); /* 60 degrees high */
    const double offset = (double)ssgi_normal_offset(&v, 10);
    CHECK(fabs(offset - 10 / (sqrt(3) * 720)) < 1e-8 && fabs(offset - 0.00802) < 2e-6
              && ssgi_normal_offset(&v, 3) == ssgi_pixel_footprint(&v, 3) / 2,
          "eq. 13: %.9g", offset);
    for (float z = 0.2f; z < 1e4f; z *= 3)     /* of the axis with wider pixels: z / (f res) [HSAO08 eq. 13] */
        for (int ortho = 0; ortho < 2; ++ortho) {
            ssgi_view other;
            ssgi_view_from_projection(&other, wide[ortho], SSGI_CLIP_GL, 1000, 500, NULL);
            const double want = ortho ? 2 / (0.02 * 1000) : (double)(2 * z) / (2.4 * 500),
                         is = (double)ssgi_pixel_footprint(&other, z);
            CHECK(fabs(is / want - 1) < 1e-6, "footprint %g at %g, twice eq. 13 %g", is, (double)z, want);
        }
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
    /* a plane across one texel, with the depth of its middle: how far its nearest corner is before that depth */
    for (int azimuth = 0; azimuth <= 90; azimuth += 15)
        for (int alpha = 15; alpha < 90; alpha += 15) {
            const double a = azimuth * PI / 180, rise = 0.5 * tan(alpha * PI / 180) * (cos(a) + sin(a));
            const float c = (float)cos(alpha * PI / 180);
            const double safe = (double)ssgi_shadow_bias(1, c, 1e9f, SSGI_BIAS_SAFE),
                         published = (double)ssgi_shadow_bias(1, c, 1e9f, SSGI_BIAS_PUBLISHED);
            CHECK(rise <= safe * 1.00001 && (azimuth != 45 || rise > safe * 0.99999),
                  "a plane at %d, %d rises %g, bias %g", azimuth, alpha, rise, safe);
            CHECK((rise <= published * 1.00001) == (azimuth % 90 == 0), "published, at %d, %d: %g for %g", azimuth,
                  alpha, published, rise);
        }
    for (int i = 0; i < ODD * ODD * ODD; ++i) {
        const float a = odd[i % ODD], b = odd[i / ODD % ODD], c = odd[i / ODD / ODD],
                    got[3] = { ssgi_normal_offset(&v, a), ssgi_shadow_patch(a, b, i - 9),
                               ssgi_shadow_bias(a, b, c, i - 2) };
        for (int k = 0; k < 3; ++k)
            CHECK(got[k] >= 0 && got[k] <= SSGI_FAR, "formula %d of %g %g %g: %g", k, (double)a, (double)b, (double)c,
                  (double)got[k]);
        CHECK(b > 0 || c != 1 || got[2] == 1, "cosine %g: %g, not the most", (double)b, (double)got[2]);
        CHECK(a > 0 || (got[0] == 0 && got[1] == 0), "a length of %g: %g %g", (double)a, (double)got[0],
              (double)got[1]);
    }
}

/* Makes n x n hills, of 8 x 8 cells each, turned so that `up` is (0.6, 0, 0.8). The valleys are level. */
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
    enum { SOUP = CELLS * CELLS * 6 };
    static float vertex[CELLS + 1][CELLS + 1][3], soup[SOUP + 3][3], cube[144][3], ball[144][3];
    static uint32_t index[SOUP], work[9 * (2 * CELLS * CELLS + 1)];
    static const int quad[6][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0 }, { 1, 1 }, { 0, 1 } };
    static const float up[3] = { 3, 0, 4 }, high[3] = { 0, 0, 1 };
    /* neither a terrace, between a wall up and a slope down, nor an edge seen from one side alone is a maximum */
    static const float steps[9][3] = { { 1, 0, 1 },  { 2, 0, 2 }, { 2, 1, 2 }, { 0, 0, 1 }, { 1, 0, 1 },
                                       { 0, -1, 0 }, { 5, 0, 0 }, { 6, 0, 2 }, { 5, 1, 1 } };
    const size_t words = sizeof work / sizeof *work, triangles = SOUP / 3;
    const float third = 0.2f * sqrtf(3);       /* a tenth of the cube's diagonal */
    for (int i = 0; i <= CELLS; ++i)
        for (int k = 0; k <= CELLS; ++k) hill(vertex[i][k], i, k, 0.3);
    for (int i = 0; i < SOUP; ++i) {
        const int x = i / 6 / CELLS + quad[i % 6][0], y = i / 6 % CELLS + quad[i % 6][1];
        index[i] = (uint32_t)(x * (CELLS + 1) + y);
        memcpy(soup[i], vertex[x][y], sizeof soup[i]);
    }
    soup[SOUP][1] = NAN;                       /* one more triangle, with a NaN */
    for (int i = 0; i < 144; ++i) {            /* a cube of 2 x 2 quads on each side; the same on the sphere */
        float *p = cube[i];
        const int side = i / 24;
        p[side / 2] = side % 2 ? 1 : -1;
        p[(side / 2 + 1) % 3] = (float)(i % 24 / 12 + quad[i % 6][0]) - 1;
        p[(side / 2 + 2) % 3] = (float)(i / 6 % 2 + quad[i % 6][1]) - 1;
        for (int k = 0; k < 3; ++k) ball[i][k] = p[k] / sqrtf((float)dot(p, p));
    }
    const struct { const char *name; const float *position, *up; const uint32_t *index; size_t triangles, found;
        float radius;
    } row[] = { { "hills", vertex[0][0], up, index, triangles, HILLS * HILLS, 0.3f },
                { "hills without an index", soup[0], up, NULL, triangles + 1, HILLS * HILLS, 0.3f },
                { "a wall's top and a corner", steps[0], high, NULL, 3, 2, 4 },
                { "a cube's corners, from the middle", cube[0], NULL, NULL, 48, 8, 2 },
                { "a cube's top", cube[0], high, NULL, 48, 1, third },
                { "a sphere", ball[0], NULL, NULL, 48, 0, third } };
    const char *why = "";
    for (size_t i = 0; i < sizeof row / sizeof *row; ++i) {
        float radius = 7;
        size_t found = 0;
        CHECK(ssgi_radius_guess(&radius, &found, row[i].position, 12, row[i].index, row[i].triangles, row[i].up, work,
                                9 * row[i].triangles - 1, &why) == SSGI_TOO_SMALL
                  && strncmp(why, "words:", 6) == 0 && radius == 7,
              "%s, a word less: \"%s\"", row[i].name, why);
        CHECK(ssgi_radius_guess(&radius, &found, row[i].position, 12, row[i].index, row[i].triangles, row[i].up, work,
                                words, NULL) == SSGI_OK
                  && found == row[i].found && fabsf(radius / row[i].radius - 1) < 1e-5f,
              "%s: %zu maxima, %g apart", row[i].name, found, (double)radius);
    }
}

/* ---- >>reflection ------------------------------------------------------------------------------------------------ */

/* Equal, or both NaN. */
static int alike(float a, float b) { return !(fabsf(a - b) > 0); }

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
            /* the visibility of a lobe that is open; whose bent normal leans away, and toward it */
            CHECK(ssgi_specular_visibility(1, a, a, v) >= 1 && gloss >= 0 && gloss <= 1
                      && ssgi_specular_visibility(v, 0.7f, 0.7f, a) >= gloss
                      && ssgi_specular_visibility(v, 0.9f, 0.7f, a) >= ssgi_specular_visibility(v, 0.7f, 0.7f, a),
                  "visibility %g, roughness %g: %g", (double)v, (double)a, (double)gloss);
        }
    const double half = (double)ssgi_specular_visibility(0.5f, 0.6f, 0.8f, 0.5f),
                 lit = (double)ssgi_interreflected(0.5f, 0.5f);
    CHECK(fabs(half - (1 - 0.98 * 0.5 - 1.515 * 0.5 * 0.2)) < 1e-6
              && fabs(lit - ((0.6878 * 0.5 - 1.75585) * 0.5 + 2.0679) * 0.5) < 1e-6,
          "half of all: %g, %g", half, lit);
    for (int i = 0; i < 5; ++i)
        CHECK(alike(ssgi_interreflected(odd[i], 0.5f), ssgi_interreflected(of[i], 0.5f))
                  && alike(ssgi_interreflected(0.4f, odd[i]), ssgi_interreflected(0.4f, of[i]))
                  && alike(ssgi_specular_visibility(0.4f, 0.5f, 0.5f, odd[i]),
                           ssgi_specular_visibility(0.4f, 0.5f, 0.5f, of[i]))
                  && alike(ssgi_specular_visibility(odd[i], 0.5f, 0.5f, 0.5f),
                           ssgi_specular_visibility(of[i], 0.5f, 0.5f, 0.5f))
                  && ssgi_specular_visibility(0.4f, odd[i], odd[4 - i], 0.5f) >= 0,
              "of %g", (double)odd[i]);
}

void test_math(void)
{
    RUN("views: every layout decodes its depth, and pixels come back, as by the matrix in double", views);
    RUN("views: left-handed ones are right-handed with z negated; oblique near planes decode as by the matrix in "
        "double",
        engines_views);
    RUN("additional cameras hold the sphere, centred and no wider, with the main camera's up, mirrored where it is",
        extra_cameras);
    RUN("kernels: counts sum to 1, one length a stratum, unit directions, moments of their shape", kernels);
    RUN("directions of every kind are the kernel's points of the square, with sums that are exact", spread);
    RUN("tiles of noise: every window has every set once, every stratum is there, copies are far apart", tiles);
    RUN("points are spread far better than random", evenness);
    RUN("footprints and bias: the papers' and the oracles' numbers, what a plane needs, finite whatever comes", biases);
    RUN("a radius to begin with: hills' and corners' spacing; a sphere has none", radii);
    RUN("harmonics: the table's functions, the addition theorem, the cosine's factors", harmonics);
    RUN("harmonics: latitude-longitude and cube maps give back what made them", projections);
    RUN("windows: the table's rows: zonal factors, irradiance facing, behind and least, the worst that any mask lets "
        "through",
        windows);
    RUN("lights: what faces one receives what was given, of one band all the mean; spheres are caps; they add", lights);
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
    RUN("bad arguments are named, outputs stay", arguments_refused);
}
