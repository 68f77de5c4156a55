/* test_view.c - ssgi.h's room of views, against matrices in double precision, and of additional cameras. */
#include "frames.h"
#include "ssgi.h"

#include <math.h>
#include <string.h>

#define PI KIT_PI

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
    ssgi_view v;
    direction(z);
    rigid_about(main_view, z);
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
    if (!T_OK(ssgi_extra_camera, view, clip, main_view, centre, radius, offset)
        || !T_OK(ssgi_view_from_projection, &v, clip, SSGI_CLIP_GL, 1000, 1000))
        return;
    for (int k = 8; k < 12; ++k) main_view[k] = -main_view[k];
    const float there[3] = { centre[0], centre[1], -centre[2] };
    T_OK(ssgi_extra_camera, mirrored, clip, main_view, there, radius, offset);
    for (int k = 8; k < 12; ++k) mirrored[k] = -mirrored[k];
    CHECK(apart_by(view, mirrored, 12) < 2e-5
              && apart_by(view + 12, mirrored + 12, 4) < 2e-6 * (double)(reach + radius + 10),
          "mirrored, off by %g, its place by %g", apart_by(view, mirrored, 12), apart_by(view + 12, mirrored + 12, 4));
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

void test_view(void)
{
    RUN("views: every layout decodes its depth, and pixels come back, as by the matrix in double", views);
    RUN("views: left-handed ones are right-handed with z negated; oblique near planes decode as by the matrix in "
        "double",
        engines_views);
    RUN("additional cameras hold the sphere, centred and no wider, with the main camera's up, mirrored where it is",
        extra_cameras);
}
