/* test_surfels.c - surfels on the CPU: tessellation, sizes, reach, bounds, the dipole; and the passes of deep screen
   space, drawn, against brute force and the truth. */
#include "own.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;

static const float one[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };

static ssgi_surfel_source source_of(const float *position, size_t triangles)
{
    ssgi_surfel_source s = { .position = position, .triangles = triangles };
    memcpy(s.to_view, one, sizeof one);
    return s;
}

/* Returns all surfels of a source, which the caller frees. Behind them stay a few that were there before, untouched. */
static ssgi_surfel *surfels_of(size_t *count, const ssgi_surfel_desc *desc, const ssgi_view *view,
                               const ssgi_surfel_source *source)
{
    const char *why = "";
    size_t n = 0;
    if (!CHECK(ssgi_surfels(NULL, 0, &n, desc, view, source, &why) == SSGI_OK, "%s", why)) return NULL;
    ssgi_surfel *s = malloc((n + 1) * sizeof *s), guard;
    memset(&guard, 0x5a, sizeof guard);
    s[n] = guard;
    CHECK(ssgi_surfels(s, n, count, desc, view, source, &why) == SSGI_OK && *count == n
              && !memcmp(&s[n], &guard, sizeof guard),
          "%zu then %zu surfels, or one too many written", n, *count);
    return s;
}

/* Returns the form factor of a surfel's front, seen from a point: r^2 cos cos' / (d^2 + r^2) [DSS14 4, Wallace 1989].
   It is exact on the surfel's axis, and too low beside it if d < 4 r (by half at d = r). */
static float form_factor(const ssgi_surfel *surfel, const float position[3], const float normal[3])
{
    float v[3], d2 = 0, above = 0, before = 0;
    for (int k = 0; k < 3; ++k) {
        v[k] = surfel->position[k] - position[k];
        d2 += v[k] * v[k];
        above += v[k] * normal[k];
        before -= v[k] * surfel->normal[k];
    }
    if (!(above > 0 && before > 0)) return 0;
    return above * before / d2 * (float)ssgi_surfel_form_factor((double)surfel->radius, sqrt((double)d2));
}

/* ---- tessellation ------------------------------------------------------------------------------------------------ */

static void points(void)
{
    static float uvw[3 * 3169 + 1];
    for (int i = 0; i <= 65; ++i) {
        int v = 0;
        for (int segments = i; segments > 0 && i < 65; segments -= 2) v += 3 * segments;
        if (i && i < 65 && i % 2 == 0) ++v;
        uvw[3 * v] = uvw[v ? 3 * v - 1 : 0] = 7;
        CHECK(ssgi_tess_count(i) == v && (ssgi_tess_points(uvw, i, NULL) == SSGI_OK) == (v > 0) && uvw[3 * v] == 7
                  && (!v || uvw[3 * v - 1] <= 1),
              "level %d: %d points, %d expected, or another number of them is written", i, ssgi_tess_count(i), v);
    }
    CHECK(ssgi_tess_count(1) == 3 && ssgi_tess_count(2) == 7 && ssgi_tess_count(4) == 19 && ssgi_tess_count(64) == 3169
              && ssgi_tess_count(-1) == 0 && ssgi_tess_count(0x7fffffff) == 0,
          "the ends of the formula");
}

static void levels(void)
{
    /* at areas where the level's even formula is full, with a float on either side */
    for (int i = 1; i <= 64; ++i)
        for (int k = -1; k <= 1; ++k) {
            const float full = (3 * (float)(i + 1) * (float)(i + 1) + 1) / 4,
                        discs = k ? nextafterf(full, k < 0 ? 0.0f : 1e9f) : full;
            CHECK(ssgi_tess_level(pi * (double)discs, 1) == i, "%.9g discs: level %d, %d expected", (double)discs,
                  ssgi_tess_level(pi * (double)discs, 1), i);
        }
    CHECK(ssgi_tess_level(19 * pi * 0.01, 0.1) == 4 && ssgi_tess_level(1e30, 1) == 64 && ssgi_tess_level(0, 1) == 1
              && ssgi_tess_level(-9, 1) == 1 && ssgi_tess_level(1, 0) == 64 && ssgi_tess_level(1, -1e-3) == 64,
          "19 discs, no area, no radius");
    for (int i = 1; i <= 64; ++i) {
        const double r = ssgi_tess_radius(2.5, ssgi_tess_count(i));
        CHECK(fabs(pi * r * r * ssgi_tess_count(i) / 2.5 - 1) < 1e-12, "level %d: radius %g", i, r);
    }
    CHECK(ssgi_tess_radius(0, 3) == 0 && ssgi_tess_radius(1, 0) == 0 && ssgi_tess_radius(-1, -3) == 0, "no discs");
}

/* ---- surfels of triangles ---------------------------------------------------------------------------------------- */

static double area_of(const ssgi_surfel *s, size_t count)
{
    double sum = 0;
    for (size_t i = 0; i < count; ++i) sum += pi * (double)s[i].radius * (double)s[i].radius;
    return sum;
}

/* Writes the normal of a triangle, of twice its area's length. */
static void normal_of(const float p[9], float n[3])
{
    float u[3], v[3];
    for (int i = 0; i < 3; ++i) { u[i] = p[3 + i] - p[i]; v[i] = p[6 + i] - p[i]; }
    cross(u, v, n);
}

static double area_of_triangle(const float p[9])
{
    float n[3];
    normal_of(p, n);
    return 0.5 * sqrt(dot(n, n));
}

/* Checks that areas add up: of triangles that are split, too; of small triangles, as an expectation. */
static void areas(void)
{
    const kit_camera c[2] = { looking_along_z(160, 90, 0), looking_along_z(160, 90, 1) };
    enum { SMALL = 40000 };
    FREED float *soup = malloc(9 * SMALL * sizeof *soup);
    double worst = 0;
    /* scenes of one triangle each, of all sizes, before and behind the eye */
    for (int k = 0; k < 40; ++k) {
        const ssgi_surfel_desc d = { .size = 0.03f, .keep_small = 1 };
        const float extent = powf(10, 2.5f * t_uniform(0, 1) - 1.5f);
        ssgi_view view;
        size_t n = 0;
        for (int i = 0; i < 9; ++i) soup[i] = extent * t_uniform(-1, 1) - (i % 3 == 2 ? t_uniform(-2, 4) : 0);
        const ssgi_surfel_source one_triangle = source_of(soup, 1);
        if (!view_of(&view, &c[k % 2], 0)) return;
        FREED ssgi_surfel *s = surfels_of(&n, &d, &view, &one_triangle);
        worst = fmax(worst, fabs(area_of(s, n) / area_of_triangle(soup) - 1));
    }
    CHECK(worst < 1e-6, "areas are off by %.2g", worst);
    /* meshes of a square of 1 x 1 in so many triangles, whose areas vary */
    for (int m = 0; m < 2; ++m) {
        const ssgi_surfel_desc d = { .size = 0.012f, .keep_small = 0 };
        ssgi_view view;
        size_t n = 0;
        for (int i = 0; i < SMALL / 2; ++i) {
            const float x0 = (float)(i % 200) / 200, x1 = x0 + 0.005f, y0 = (float)(i / 200) / 100, y1 = y0 + 0.01f,
                        z = -3;
            const float square[18] = { x0, y0, z, x1, y0, z, x0, y1, z, x1, y0, z, x1, y1, z, x0, y1, z };
            memcpy(soup + 18 * i, square, sizeof square);
        }
        if (!view_of(&view, &c[m], 0)) return;
        const ssgi_surfel_source all = source_of(soup, SMALL);
        FREED ssgi_surfel *s = surfels_of(&n, &d, &view, &all);
        const double sum = area_of(s, n), wanted = ssgi_surfel_radius(&view, (double)d.size, 3),
                     /* each is kept with chance p and has area a/p: the sum of a^2 (1/p - 1) = 3 pi r^2 sum a - sum
                        a^2 */
                     variance = 3 * pi * wanted * wanted - 1.0 / SMALL;
        for (size_t i = 0; i < n; ++i)
            CHECK(fabs((double)s[i].radius / wanted - 1) < 1e-5, "radius %g, %g wanted", (double)s[i].radius, wanted);
        CHECK(n > 300 && fabs(sum - 1) < 3.5 * sqrt(variance), "%zu surfels have area %.4f, 1 wanted within %.4f", n,
              sum, sqrt(variance));
        t_note("40 triangles' areas off by %.1e at most; a share of %d: %zu surfels, area %.4f +- %.4f", worst, SMALL,
               n, sum, sqrt(variance));
    }
}

/* Checks ten thousand slivers: surfels stay in their triangles, and so do their discs, if these fit. */
static void slivers(void)
{
    const kit_camera c = looking_along_z(160, 90, 0);
    int flipped = 0, outside = 0, over = 0, half = 0, fits = 0;
    ssgi_view view;
    if (!view_of(&view, &c, 0)) return;
    for (int t = 0; t < 10000; ++t) {
        ssgi_surfel_desc d = { .size = 0.3f * powf(10, -1.3f * t_uniform(0, 1)), .keep_small = 1, .splits = 1 };
        d.overhang = t & 1 ? SSGI_OVERHANG_CENTROID : SSGI_OVERHANG_INCENTRE;
        float p[9], v[3], n[3], side[3], small[9], axis[2][3];
        const float high = powf(10, -3 * t_uniform(0, 1)), apex = 1.5f * t_uniform(0, 1) - 0.25f;
        direction(axis[0]);
        direction(v);
        cross(axis[0], v, axis[1]);
        const float length = sqrtf((float)dot(axis[1], axis[1]));
        for (int k = 0; k < 3; ++k) {
            axis[1][k] /= length;
            p[k] = -0.5f * axis[0][k];
            p[3 + k] = 0.5f * axis[0][k];
            p[6 + k] = (apex - 0.5f) * axis[0][k] + high * axis[1][k];
        }
        const ssgi_surfel_source source = source_of(p, 1);
        size_t count = 0;
        FREED ssgi_surfel *s = surfels_of(&count, &d, &view, &source);
        if (!s || !CHECK(count >= 3, "%zu surfels", count)) return;
        double perimeter = 0;
        int level = 1;
        while (ssgi_tess_count(level) < (int)count) ++level;
        /* the first ring of surfels has the corners of the shrunk triangle */
        for (int k = 0; k < 9; ++k) small[k] = s[k / 3 * level].position[k % 3];
        const double area = area_of_triangle(p);
        normal_of(p, n);
        normal_of(small, side);
        flipped += !(dot(side, n) > 0 && dot(s[0].normal, n) > 0.999 * 2 * area);
        for (int e = 0; e < 3; ++e) {
            for (int k = 0; k < 3; ++k) side[k] = p[3 * ((e + 1) % 3) + k] - p[3 * e + k];
            perimeter += sqrt(dot(side, side));
        }
        const double inner = 2 * area / perimeter, r = (double)s[0].radius;
        const int fit = r <= 0.75 * inner && !d.overhang;
        fits += fit;
        for (size_t i = 0; i < count; ++i)
            for (int e = 0; e < 3; ++e) {
                float inward[3], from[3];
                for (int k = 0; k < 3; ++k) {
                    side[k] = p[3 * ((e + 1) % 3) + k] - p[3 * e + k];
                    from[k] = s[i].position[k] - p[3 * e + k];
                }
                cross(n, side, inward);
                const double distance = dot(from, inward) / sqrt(dot(inward, inward));
                outside += distance < -2e-7;
                half += d.overhang && r <= 0.75 * inner && r - distance > 0.4 * r;
                over += fit && r - distance > 1e-6 * r + 2e-7;                 /* tolerates the rounding of positions */
            }
    }
    CHECK(!flipped && !outside && !over && fits > 2000,
          "%d flipped, %d surfels outside, %d discs over the edge, of %d that fit", flipped, outside, over, fits);
    CHECK(half > 2000, "corners moved as published leave %d discs over edges by 0.4 radii", half);
    t_note("discs fit into %d of 5000", fits);
}

static int all_finite(const ssgi_surfel *s, size_t n)
{
    for (size_t i = 0; i < n; ++i) {
        const float *f = s[i].position;
        for (int k = 0; k < 12; ++k) if (!(fabsf(f[k]) < 1e30f)) return 0;
        if (!(s[i].radius > 0 && fabs(dot(s[i].normal, s[i].normal) - 1) < 1e-5 && s[i].seed >= 0 && s[i].seed < 1))
            return 0;
    }
    return 1;
}

/* Checks that a bad or vanishing triangle gives no surfel; an odd one finite surfels, as many as predicted. If its
   corners shrink onto each other, or its normals are not finite, it keeps its own normal. A triangle far from the view
   is left out. A mirrored mesh keeps its outside. */
static void odd_triangles(void)
{
    static const float wrong[9] = { INFINITY, 0, 0, 0, NAN, 0, 0, 0, 0 };
    static const struct { float p[9]; int some; float scale; const float *normal; /* some: below 0: either */
    } row[] = { { { 0, 0, -3, 0, 0, -3, 0, 0, -3 }, 0, 1, NULL },
                { { 0, 0, -3, 1, 1, -3, 2, 2, -3 }, 0, 1, NULL },
                { { 0, 0, -3, 1, 0, -3, 0, NAN, -3 }, 0, 1, NULL },
                { { 0, 0, -3, INFINITY, 0, -3, 0, 1, -3 }, 0, 1, NULL },
                { { 0, 0, -3, 1e30f, 0, -3, 0, 1e30f, -3 }, 0, 1, NULL },
                { { 0, 0, -3, 1e19f, 0, -3, 0, 1e19f, -3 }, 0, 1, NULL },
                { { 0, 0, -3, 1e9f, 0, -3, 0, 1e9f, -3 }, 1, 1, NULL },
                { { 0, 0, -1e9f, 1, 0, -1e9f, 0, 1, -1e9f }, 1, 1, NULL },
                { { 0, 0, 3, 1, 0, 3, 0, 1, 3 }, 1, 1, NULL },
                { { 0, 0, 3, 1, 0, -3, 0, 1, -3 }, 1, 1, NULL },
                { { 1e-20f, 0, -1, 0, 1e-20f, -1, 0, 0, -1 }, 1, 1, NULL },
                { { 1e-30f, 0, -3, 0, 1e-30f, -3, 2e-30f, 2e-30f, -3 }, -1, 1, NULL },
                { { 0, 0, -3, 1e-25f, 0, -3, 0, 1e-25f, -3 }, 0, 1e-25f, NULL },
                { { 1e8f, 0, -1, 1e8f, 100, -1, 1e8f, 0, -100 }, 1, 1, NULL },
                { { 0, 0, 0, 1, 0, 0, 0, 1, 0 }, 1, 1, NULL },
                { { 0, 0, -3, 1, 0, -3, 0, 1, -3 }, 1, 1, wrong } };
    const kit_camera c[2] = { looking_along_z(160, 90, 0), looking_along_z(160, 90, 1) };
    const ssgi_splat splat = { 0 };
    ssgi_view view;
    ssgi_surfel_desc d = { .keep_small = 1, .size = 0.05f };
    for (int i = 0; i < 2 * ROWS(row); ++i) {
        ssgi_surfel_source source = source_of(row[i / 2].p, 1);
        ssgi_surfel_cost cost;
        size_t n = 0;
        source.normal = row[i / 2].normal;
        for (int k = 0; k < 3; ++k) source.to_view[5 * k] = row[i / 2].scale;
        if (!view_of(&view, &c[i % 2], 0)) return;
        FREED ssgi_surfel *s = surfels_of(&n, &d, &view, &source);
        CHECK((row[i / 2].some < 0 || (n > 0) == row[i / 2].some) && all_finite(s, n),
              "view %d, triangle %d: %zu surfels, or not all finite", i % 2, i / 2, n);
        CHECK(ssgi_surfels_predict(&cost, &d, &splat, &view, &source, NULL) == SSGI_OK && cost.surfels == n,
              "view %d, triangle %d: %zu surfels, %zu predicted", i % 2, i / 2, n, cost.surfels);
        CHECK(!row[i / 2].normal || fabsf(s[0].normal[2]) > 0.999f, "a triangle's own normal is %g",
              (double)s[0].normal[2]);
    }
    static const float p[9] = { 5, 0, -3, 6, 0, -3, 5, 1, -3.2f }, tilted[9] = { 0.1f, 0, 1, 0, 0.2f, 1, 0, 0, 2 };
    for (int k = 0; k < 2; ++k) {                                              /* 1.9 beside the frustum */
        const ssgi_surfel_source source = source_of(p, 1);
        size_t n = 0;
        d.max_distance = k ? 2.0f : 0.5f;
        view_of(&view, &c[0], 0);
        ssgi_surfels(NULL, 0, &n, &d, &view, &source, NULL);
        CHECK((n > 0) == k, "most %g: %zu surfels", (double)d.max_distance, n);
    }
    d.max_distance = 0;
    /* mirrored and sheared matrices: with the triangle's own normals, with given ones */
    for (int k = 0; k < 2; ++k) {
        ssgi_surfel_source source = source_of(p, 1);
        size_t n = 0;
        float own[3], copies[9];
        source.to_view[0] = k ? -1 : 1;
        source.to_view[4] = 0.5f;
        normal_of(p, own);
        for (int i = 0; i < 9; ++i) copies[i] = own[i % 3];
        FREED ssgi_surfel *s = surfels_of(&n, &d, &view, &source);
        source.normal = copies;
        FREED ssgi_surfel *same = surfels_of(&n, &d, &view, &source);
        for (size_t i = 0; i < n; ++i)
            CHECK(dot(s[i].normal, same[i].normal) > 0.99999, "mirrored %d: own normals and given ones are apart: %g",
                  k, dot(s[i].normal, same[i].normal));
        source.normal = tilted;
        FREED ssgi_surfel *turned = surfels_of(&n, &d, &view, &source);
        CHECK(turned[0].normal[2] > 0.9f && all_finite(turned, n), "given normals are not followed");
    }
}

/* ---- reach, shells ----------------------------------------------------------------------------------------------- */

static void reach_and_shells(void)
{
    int wrong = 0;
    for (int k = 0; k < 100; ++k) {                        /* places where the brightest surfel brings epsilon */
        const double r = pow(10, 4 * t_within(0, 1) - 2), bright = 0.3 + 5 * t_within(0, 1),
                     epsilon = pow(10, -3 * t_within(0.17, 1)), far = ssgi_surfel_reach(r, bright, epsilon);
        CHECK(bright <= epsilon || fabs(bright * ssgi_surfel_form_factor(r, far) / epsilon - 1) < 1e-9,
              "epsilon %g, brightest %g: reach %g", epsilon, bright, far);
    }
    CHECK(ssgi_surfel_reach(1, 0.01, 0.02) == 0 && ssgi_surfel_reach(1, 0.02, 0.02) == 0,
          "a surfel that is too faint has a reach");
    /* distances also at the borders of levels; no level brings anything beyond most */
    for (int k = 0; k < 3000; ++k) {
        const double reach = 0.1 + t_within(0, 1), most = k % 3 ? 1e18 : 20 * t_within(0, 1),
                     border = ldexp(reach, k % 6), d = k % 5 ? 70 * reach * t_within(0, 1) + 1e-9 : border;
        int in = 0;
        for (int l = 0; l < 7; ++l) {
            double shell[2];
            ssgi_surfel_shell(shell, reach, l, most);
            in += d > shell[0] && d <= shell[1];
        }
        wrong += in != (d <= ldexp(reach, 6) && d <= most);
    }
    CHECK(!wrong, "%d distances are in no shell, or in two", wrong);
    CHECK(ssgi_surfel_reach(-1, 1, 0.1) == 0 && ssgi_surfel_reach(1, 1, 0) == (double)SSGI_FAR
              && ssgi_surfel_reach(1, 5, 0.02) > 15.779 && ssgi_surfel_reach(1, 5, 0.02) < 15.780,
          "reach of no radius, for no epsilon, of 5 at 0.02");
    for (int k = 0; k < 3; ++k) {
        static const double lengths[3][2] = { { 0, 1 }, { 1, 0 }, { 1, -1 } };
        double shell[2] = { 7, 7 };
        ssgi_surfel_shell(shell, lengths[k][0], 2, lengths[k][1]);
        CHECK(shell[0] == 0 && shell[1] == 0, "shell %g to %g", shell[0], shell[1]);
    }
}

/* ---- pixels that splats cover ------------------------------------------------------------------------------------ */

static const float both_sides[3] = { 0, 0, 0 };

static void bounds(void)
{
    double worst[2] = { 0, 0 };
    int outside = 0, loose = 0, some = 0;
    for (int k = 0; k < 1200; ++k) {
        const int flipped = k & 1, orthographic = k >> 1 & 1, half = k >> 2 & 1;
        const float r = powf(10, 2 * t_uniform(0, 1) - 1.3f), front = k % 3 ? 0.05f : t_uniform(0.05f, 2.05f);
        float centre[3], normal[3] = { 0, 0, 0 }, b[4] = { 0 }, low[2] = { 1e9f, 1e9f }, high[2] = { -1e9f, -1e9f };
        kit_camera c = looking_along_z(160, 90, orthographic);
        ssgi_view view;
        c.shift[0] = 30 * t_uniform(0, 1);
        c.shift[1] = -20 * t_uniform(0, 1);
        if (!view_of(&view, &c, flipped)) return;
        for (int i = 0; i < 3; ++i) centre[i] = 4 * t_uniform(0, 1) - (i == 2 ? 3.5f : 2);
        if (half) direction(normal);
        for (int i = 0; i < 3000; ++i) {
            float p[3], out[3];
            direction(p);
            const int behind = dot(p, normal) < 0;
            for (int x = 0; x < 3; ++x) p[x] = centre[x] + r * p[x];
            if (-p[2] < front || behind) continue;
            ssgi_view_project(out, &view, p);
            for (int x = 0; x < 2; ++x) { low[x] = fminf(low[x], out[x]); high[x] = fmaxf(high[x], out[x]); }
        }
        for (int x = 0; x < 2; ++x) {
            low[x] = fmaxf(low[x], 0);
            high[x] = fminf(high[x], (float)(x ? view.height : view.width));
        }
        const int met = low[0] < high[0] && low[1] < high[1],
                  is = ssgi__sphere_bounds(b, &view, centre, normal, r, front),
                  exact = !half || -centre[2] - r * hypotf(normal[0], normal[1]) > front;
        some += met;
        outside += met && !is;
        for (int x = 0; x < 2 && met && is; ++x) {
            const double wide = (double)(high[x] - low[x]),
                         out = fmax((double)(b[x] - low[x]), (double)(high[x] - b[x + 2])),
                         in = fmax((double)(low[x] - b[x]), (double)(b[x + 2] - high[x])) / (wide + 1);
            outside += out > 1e-3;
            loose += exact && in > 0.1;
            worst[0] = fmax(worst[0], out);
            worst[1] = fmax(worst[1], exact ? in : 0);
        }
    }
    CHECK(!outside && 50 * loose < some && some > 400,
          "of %d spheres %d reach out of their bounds (%.3g pixels), %d bounds are loose (%.3f of a sphere)", some,
          outside, worst[0], loose, worst[1]);
    t_note("%d spheres: out by %.1e pixels at most, bounds wider by %.3f of one at most", some, worst[0], worst[1]);
}

/* Checks that a facing surfel is s/2 picture heights wide at any depth, and wider behind the near plane. */
static void radii(void)
{
    kit_camera c = looking_along_z(160, 90, 0);
    for (int k = 0; k < 6; ++k) {
        const float depth = 0.5f + 7 * (float)k, centre[3] = { 0, 0, -depth };
        ssgi_view view;
        float b[4] = { 0 };
        c.fovy = k % 3 ? 20 + 10 * (float)k : 0;
        c.znear = 0.2f;
        c.depth = k % 2 ? KIT_DEPTH_INFINITE : KIT_DEPTH_NORMAL;
        if (k % 3 == 0) c.depth = KIT_DEPTH_REVERSED;
        if (!view_of(&view, &c, k & 1)) return;
        const double r = ssgi_surfel_radius(&view, 0.05, (double)depth);
        CHECK(ssgi__sphere_bounds(b, &view, centre, both_sides, (float)r, 0.2f)
                  && fabs((double)(b[3] - b[1]) / (0.05 * 90) - 1) < 1e-3,
              "depth %g: %g pixels, 4.5 wanted", (double)depth, (double)(b[3] - b[1]));
        CHECK(fabs((double)ssgi_view_near(&view) - 0.2) < 1e-4, "near plane at %g", (double)ssgi_view_near(&view));
        const double behind = ssgi_surfel_radius(&view, 0.05, -(double)depth),
                     before = ssgi_surfel_radius(&view, 0.05, (double)depth + (k % 3 ? 0.4 : 0));
        CHECK(fabs(behind - before) < 1e-5 * r, "behind the eye");
        if (k % 3 == 0) continue;
        const double published = 0.05 * tan((double)c.fovy * pi / 360) * (fabs((double)depth - 0.2) + 0.2);
        CHECK(fabs(r / published - 1) < 1e-5, "depth %g: radius %g, %g published", (double)depth, r, published);
    }
}

/* Checks the numbers that are predicted for a scene, from its triangles and from its surfels. */
static void predictions(void)
{
    static const char *const names[2] = { "boxes", "pebbles" };
    for (int k = 0; k < 2; ++k) {
        OWN(kit_scene) scene = { 0 };
        ssgi_view view;
        ssgi_surfel_cost triangles = { 0 }, surfels = { 0 };
        const ssgi_surfel_desc d = { .size = 0.03f };
        const ssgi_splat splat = { .epsilon = 0.05f, .levels = 4 };
        float projection[16];
        double sum[2] = { 0, 0 }, share[2] = { 0, 0 };
        size_t n = 0;
        if (!TRY(kit_scene_load(&scene, names[k], 0, &err))) return;
        scene.camera.width = 160;
        scene.camera.height = 90;
        kit_camera_planes(&scene.camera, &scene.mesh);
        if (!view_of(&view, &scene.camera, 0)) return;
        ssgi_surfel_source source = source_of(scene.mesh.position, scene.mesh.triangles);
        kit_camera_matrices(&scene.camera, source.to_view, projection);
        FREED ssgi_surfel *s = surfels_of(&n, &d, &view, &source);
        CHECK(ssgi_surfels_predict(&triangles, &d, &splat, &view, &source, NULL) == SSGI_OK && triangles.surfels == n
                  && triangles.splits > 0,
              "%s: %zu predicted, %zu made", names[k], triangles.surfels, n);
        ssgi_splat full;
        ssgi__splat_open(&full, &splat, &view, NULL);
        for (size_t i = 0; i < n; ++i)
            ssgi__splat_pixels(&surfels, &full, &view, s[i].position, s[i].normal, (double)s[i].radius, 1, 1);
        for (int l = 0; l < SSGI_SPLAT_LEVELS; ++l) {
            if (l >= 4) CHECK(triangles.pixels[l] == 0 && surfels.pixels[l] == 0, "level %d is not drawn", l);
            sum[0] += triangles.pixels[l];
            sum[1] += surfels.pixels[l];
        }
        CHECK(fabs(sum[0] / sum[1] - 1) < 0.25 && sum[0] > 0, "%s: %g pixels of triangles, %g of surfels", names[k],
              sum[0], sum[1]);
        for (int i = 0; i < 2; ++i) {
            const ssgi_splat other = { .epsilon = 0.05f, .levels = 4, .part = i ? 0 : 2, .two_sided = i };
            ssgi_surfels_predict(&surfels, &d, &other, &view, &source, NULL);
            for (int l = 0; l < 4; ++l) share[i] += surfels.pixels[l] / sum[0];
        }
        CHECK(share[0] > 0.25 && share[0] < 0.35 && share[1] > 1.15 && share[1] < 2,
              "%s: half size has %.3f of the pixels, both sides %.3f", names[k], share[0], share[1]);
        t_note("%s: %zu surfels, pixels of triangles %.3f of surfels', of half size %.3f, of both sides %.3f", names[k],
               n, sum[0] / sum[1], share[0], share[1]);
    }
}

/* Checks a ground of 2 km, from the eye to the horizon, and a small triangle. The ground is divided until its parts
   suffice, or near the eye ten times. Areas stay, and parts far aside are dropped. */
static void divided(void)
{
    static const float ground[27] = { -1000, 0,    -1000, -1000, 0, 1000, 1000, 0,    -1000, 1000, 0, -1000, -1000, 0,
                                      1000,  1000, 0,     1000,  0, 1,    0,    0.5f, 1,     0,    0, 1.5f,  0 };
    const kit_camera c = {
        .eye = { 0, 2, 6 }, .up = { 0, 1, 0 }, .fovy = 50, .znear = 0.1f, .zfar = 3000, .width = 160, .height = 90
    };
    ssgi_surfel_source source = source_of(ground, 3);
    ssgi_surfel_desc d = { .size = 0.03f, .splits = 8 };
    ssgi_view view;
    float projection[16];
    size_t n = 0, all = 0, again = 0;
    double area = 0;
    int wants = 0, seen = 0;
    if (!view_of(&view, &c, 0)) return;
    kit_camera_matrices(&c, source.to_view, projection);
    CHECK(ssgi_surfels_divide(NULL, 0, &all, &d, &view, &source, NULL) == SSGI_OK && all > 100 && all < 20000,
          "%zu triangles", all);
    FREED float *out = calloc(27 * all + 27, sizeof *out);
    if (!out) return;
    CHECK(ssgi_surfels_divide(out, all / 2, &again, &d, &view, &source, NULL) == SSGI_OK && again == all
              && out[27 * (all / 2)] == 0 && out[27 * (all / 2) + 8] == 0,
          "capacity");
    ssgi_surfels_divide(out, all, &again, &d, &view, &source, NULL);
    for (size_t t = 0; t < all; ++t) {
        const float *v = out + 27 * t;
        ssgi_surfel_source part = source;
        ssgi_surfel_cost cost;
        const ssgi_splat splat = { 0 };
        const double x[2] = { (double)(v[9] - v[0]), (double)(v[18] - v[0]) },
                     z[2] = { (double)(v[11] - v[2]), (double)(v[20] - v[2]) };
        part.position = v;
        part.position_stride = 36;
        part.triangles = 1;
        double middle[3];
        for (int k = 0; k < 3; ++k) {
            middle[k] = (double)source.to_view[12 + k];
            for (int j = 0; j < 9; ++j)
                middle[k] += (double)(source.to_view[4 * (j % 3) + k] * v[9 * (j / 3) + j % 3]) / 3;
        }
        seen += ssgi__view_aside(&view, middle) <= 0;
        if (t + 1 < all) area += 0.5 * fabs(x[0] * z[1] - x[1] * z[0]);
        ssgi_surfels_predict(&cost, &d, &splat, &view, &part, NULL);
        wants += cost.splits > 8 && ssgi__view_aside(&view, middle) <= 0;
    }
    CHECK(fabs(area / 4e6 - 1) < 1e-5, "the ground has %.7g of its area", area / 4e6);
    CHECK(wants == 0 && seen > 20, "%d of the %d in the picture still want more parts", wants, seen);
    CHECK(!memcmp(out + 27 * (all - 1), ground + 18, 12) && out[27 * (all - 1) + 9] == 0.5f && out[27 * all - 3] == 1,
          "the small triangle is another");
    d.max_distance = 1;
    CHECK(ssgi_surfels_divide(NULL, 0, &n, &d, &view, &source, NULL) == SSGI_OK && n < all && n > 10,
          "%zu of %zu within max_distance", n, all);
    T_REFUSED(ssgi_surfels_divide(NULL, 1, &again, &d, &view, &source, &why), SSGI_BAD_ARGUMENT, "out", again, all);
    t_note("a ground of 2 triangles becomes %zu, %d of them in the picture, %zu within 1 of it", all - 1, seen, n - 1);
}

/* Returns the reflectance over a whole plane: the integral of 2 pi r R(r) [JMLH01]. */
static double total_of(const ssgi_dipole *d, int c)
{
    return 0.5 * d->albedo[c] * (exp(-d->sigma_tr[c] * d->z_r[c]) + exp(-d->sigma_tr[c] * d->z_v[c]));
}

static void dipoles(void)
{
    static const struct { const char *name; int channel; double total, at[5];
    } row[] = {
        { "marble", 0, 0.830191456277, { 0.390746495, 0.125447567, 0.0348466917, 0.0090938403, 0.00126669258 } },
        { "marble", 2, 0.752609944803, { 0.731893, 0.135664467, 0.0336750796, 0.00858246198, 0.000760952691 } },
        { "skin1", 1, 0.227331199476, { 0.0628239383, 0.0421611311, 0.0182336317, 0.00341591015, 0.000102548368 } },
        { "ketchup",
          0,
          0.163836010769,
          { 0.00271994156, 0.00265432067, 0.00247143418, 0.00190356964, 0.000557030979 } },
        /* a material, and its dipole's values at 0, .5, 1, 2, 5 mm */
        { "wholemilk", 2, 0.759412709098, { 1.18155066, 0.153520806, 0.0397479523, 0.00776154361, 0.000339423477 } }
    };
    static const double mm[5] = { 0, 0.5, 1, 2, 5 };
    for (int i = 0; i < ROWS(row); ++i) {
        const kit_material *m = NULL;
        ssgi_dipole d;
        for (int k = 0; kit_material_of(k); ++k)
            if (!strcmp(kit_material_of(k)->name, row[i].name)) m = kit_material_of(k);
        if (!CHECK(m && ssgi_dipole_set(&d, m->sigma_s, m->sigma_a, m->eta, NULL) == SSGI_OK, "no %s", row[i].name))
            return;
        const int c = row[i].channel;
        CHECK(fabs(total_of(&d, c) / row[i].total - 1) < 1e-6, "%s: total %.9f", row[i].name,
              total_of(&d, c));
        for (int k = 0; k < 5; ++k)
            CHECK(fabs(ssgi_dipole_reflectance(&d, c, mm[k]) / row[i].at[k] - 1) < 1e-6, "%s at %g mm: %.9g",
                  row[i].name, mm[k], ssgi_dipole_reflectance(&d, c, mm[k]));
    }
    CHECK(!kit_material_of(-1) && !kit_material_of(12) && kit_material_of(11), "materials end elsewhere");
}

/* ---- refusals ---------------------------------------------------------------------------------------------------- */

/* Arguments that no row of test_arguments.c can break, and outputs that are too small. */
static void refusals(void)
{
    static const float p[9] = { 0, 0, -3, 1, 0, -3, 0, 1, -3 }, s[3] = { 1, 1, 1 }, a[3] = { 0.1f, 0.1f, 0.1f },
                       distances[4] = { -1, 0.5f, 2, 1e30f };
    const kit_camera c = looking_along_z(160, 90, 0);
    const ssgi_surfel_desc d = { 0 };
    const ssgi_splat splat = { 0 };
    const ssgi_surfel_source source = source_of(p, 1), nowhere = source_of(NULL, 1);
    ssgi_dipole dipole;
    ssgi_view view;
    struct {
        ssgi_surfel_cost cost;
        ssgi_surfel out[2];
        size_t count;
        int size[2];
        ssgi_gl_frame frame;
    } o, was;
    memset(&was, 0x5a, sizeof was);
    o = was;
    if (!view_of(&view, &c, 0)) return;
#define REFUSED(call, name) T_REFUSED(call, SSGI_BAD_ARGUMENT, name, o, was)
    REFUSED(ssgi_surfels(o.out, 2, &o.count, &d, &view, &nowhere, &why), "source.position");
    REFUSED(ssgi_surfels_predict(&o.cost, &d, &splat, &view, &nowhere, &why), "source.position");
    for (int k = 0; k < ROWS(distances); ++k) { /* a sun that one row follows, for a wider map */
        const ssgi_gl_light suns[2] = { { .min_distance = distances[k] } };
        REFUSED(ssgi_gl_sent_set(&o.frame, NULL, 0, suns, 2, NULL, &why), "lights.min_distance");
    }
#undef REFUSED
    ssgi_dipole_set(&dipole, s, a, 1.3f, NULL);
    CHECK(ssgi_dipole_reflectance(&dipole, 3, 1) == 0 && ssgi_dipole_reflectance(&dipole, -1, 1) == 0
              && ssgi_dipole_reflectance(&dipole, 2, 1) > 0,
          "a channel that there is not");
    /* with a small capacity: as many as fit are written, and the whole count is returned */
    size_t n = 0;
    ssgi_surfels(o.out, 1, &n, &d, &view, &source, NULL);
    CHECK(n > 2 && memcmp(&o.out[0], &was.out[0], sizeof was.out[0])
              && !memcmp(&o.out[1], &was.out[1], sizeof was.out[1]),
          "%zu surfels into one", n);
    CHECK(ssgi_splat_size(o.size, 53, 37, 5, NULL) == SSGI_OK && o.size[0] == 64 && o.size[1] == 48,
          "53 x 37 becomes %d x %d", o.size[0], o.size[1]);
}

/* Checks that level 0 of surfels with a diameter of 0.04 ends at 3 of their radii of 0.02 if epsilon is 0.1. The kit's
   dss asks for as many levels as the radius needs, unless they are set; for half of the radius if occlusion fades. */
static void levels_wanted(void)
{
    static const struct {
        double size, epsilon, radius;
        int levels;
    } row[] = { { 0.04, 0.1, 0, 1 },      { 0.04, 0.1, 0.0599, 1 }, { 0.04, 0.1, 0.0601, 2 }, { 0.04, 0.1, 0.12, 2 },
                { 0.04, 0.1, 0.1201, 3 }, { 0.04, 0.1, 1.91, 6 },   { 0.04, 0.1, 1.93, 7 },   { 0.04, 0.1, 1e9, 7 },
                { 0.04, 1, 0.1, 7 },      { 0, 0.1, 0.1, 7 },       { 0.04, 0.1, NAN, 7 },    { NAN, 0.1, 0.1, 7 } };
    for (int i = 0; i < ROWS(row); ++i)
        CHECK(ssgi_splat_levels(row[i].size, row[i].epsilon, row[i].radius) == row[i].levels,
              "size %g, epsilon %g, radius %g: %d levels", row[i].size, row[i].epsilon, row[i].radius,
              ssgi_splat_levels(row[i].size, row[i].epsilon, row[i].radius));
    kit_method m;
    if (!TRY(kit_method_find(&m, "dss", &err)) || !TRY(kit_method_set(&m, "size=0.04,epsilon=0.1", &err))) return;
    CHECK(kit_method_levels(&m, 0.16) == 2, "dss takes %d levels", kit_method_levels(&m, 0.16));
    if (TRY(kit_method_set(&m, "falloff=none", &err)))
        CHECK(kit_method_levels(&m, 0.16) == 3, "hard, dss takes %d levels", kit_method_levels(&m, 0.16));
}

/* ---- pictures ---------------------------------------------------------------------------------------------------- */

typedef struct deep {
    kit_scene scene;
    kit_gbuffer g;
    kit_run run;
    kit_image frame;
    ssgi_view view;
    float world[16];
} deep;

/* Opens a run of a surfel method. radius 0: no end. custom: the test's own GLSL, or NULL. */
static int begin_deep(deep *d, const char *method, const char *set, float radius, const kit_lighting *lighting,
                      const char *custom)
{
    const kit_world world = { &d->scene, lighting };
    kit_method m;
    if (!TRY(kit_method_find(&m, method, &err)) || !TRY(kit_method_set(&m, "resolution=full", &err))
        || !TRY(kit_method_set(&m, set, &err)))
        return 0;
    m.custom = custom;
    return TRY(kit_run_open(&d->run, &d->g, &m, radius > 0 ? radius : 5e17f, &world, &err));
}

/* Makes a built-in scene with boxes, and its G-buffer. */
static int look(deep *d, const char *scene, const box *boxes, int count, const kit_camera *camera, int w, int h)
{
    float projection[16];
    memset(d, 0, sizeof *d);
    if (!see(&d->scene, &d->g, scene, boxes, count, camera, w, h) || !view_of(&d->view, &d->g.camera, 0)
        || !TRY(kit_gbuffer_read(&d->frame, &d->g, &err)))
        return 0;
    kit_camera_matrices(&d->g.camera, d->world, projection);
    return 1;
}

/* Opens a run of a surfel method on such a scene. */
static int dive(deep *d, const char *scene, const box *boxes, int count, const kit_camera *camera, int w, int h,
                const char *method, const char *set, float radius, const kit_lighting *lighting)
{
    return look(d, scene, boxes, count, camera, w, h)
           && begin_deep(d, method, set, radius, lighting, NULL);
}

static void own_deep(deep *d)
{
    kit_run_close(&d->run);
    kit_image_free(&d->frame);
    kit_gbuffer_free(&d->g);
    kit_scene_free(&d->scene);
}

/* Writes position and normal of a pixel, the top row first. Returns 0 for the background. */
static int seen(const deep *d, int i, float p[3], float n[3])
{
    const size_t pixels = (size_t)d->frame.width * (size_t)d->frame.height;
    const float z = d->frame.data[i];
    if (!(z > 0)) return 0;
    ssgi_view_position(p, &d->view, (float)(i % d->frame.width) + 0.5f,
                       (float)(d->frame.height - 1 - i / d->frame.width) + 0.5f, z);
    for (size_t k = 0; k < 3; ++k) n[k] = d->frame.data[(k + 1) * pixels + (size_t)i];
    return 1;
}

/* Reads the surfels in one of the run's buffers. */
static ssgi_surfel *held(const deep *d, int buffer)
{
    ssgi_surfel *s = malloc((d->run.surfels + 1) * sizeof *s);
    glBindBuffer(GL_ARRAY_BUFFER, d->run.buffers[buffer]);
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)(d->run.surfels * sizeof *s), s);
    return s;
}

/* Replaces the run's surfels (way=cpu), and makes room for lit ones. */
static void hold(deep *d, const ssgi_surfel *s, size_t count)
{
    for (int k = 0; k < 2 && d->run.buffers[k]; ++k) {
        glBindBuffer(GL_ARRAY_BUFFER, d->run.buffers[k]);
        glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(count * sizeof *s), s, GL_STATIC_DRAW);
    }
    d->run.surfels = count;
}

static int by_seed(const void *a, const void *b)
{
    const ssgi_surfel *s = a, *t = b;
    return s->seed < t->seed                 ? -1
           : s->seed > t->seed               ? 1
           : s->position[0] < t->position[0] ? -1
                                             : s->position[0] > t->position[0];
}

/* Makes triangles of all 64 levels, before an orthographic camera, of the area of as many discs as a level has. */
static void every_level(deep *d, double size)
{
    kit_mesh *m = &d->scene.mesh;
    const double r = ssgi_surfel_radius(&d->view, size, 1);
    CHECK(m->triangles >= 64, "%zu triangles", m->triangles);
    for (int i = 0; i < 64; ++i) {
        const double side = sqrt(2 * pi * r * r * (ssgi_tess_count(i + 1) - 0.01));
        const float p[9] = { 0, 0, 0, (float)side, 0, 0, 0, 0, (float)side };
        memcpy(m->position + 9 * i, p, sizeof p);
    }
    m->triangles = 64;
}

/* Checks that tessellation shaders make the CPU's surfels, and that the pictures of all three ways agree. */
static void three_ways(void)
{
    static const char *const ways[] = { "cpu", "capture", "direct" };
    /* normals are not of unit length; if one is 0, a surfel has its triangle's normal */
    static const struct { const char *scene, *set; int orthographic, every; float normals; } row[] = {
        { "boxes", "size=0.04,overhang=centroid", 0, 0, 0 },
        { "pebbles", "size=0.04,overhang=incentre", 1, 0, 0.1f },
        { "pebbles", "size=0.02,splits=1,levels=1,epsilon=0.5", 1, 1, 1 } };
    for (int m = 0; m < ROWS(row); ++m) {
        deep d[3];
        kit_image out[3];
        OWN(kit_scene) scene = { 0 };
        if (!TRY(kit_scene_load(&scene, row[m].scene, 0, &err))) return;
        kit_camera c = scene.camera;
        if (row[m].orthographic) { c.fovy = 0; c.ortho_height = 1; }
        for (int k = 0; k < 3; ++k) {
            char set[64];
            snprintf(set, sizeof set, "%s,way=%s", row[m].set, ways[k]);
            if (!look(&d[k], row[m].scene, NULL, 0, &c, 64, 36)) return;
            for (size_t i = 0; i < 9 * d[k].scene.mesh.triangles; ++i) d[k].scene.mesh.normal[i] *= row[m].normals;
            if (row[m].every) every_level(&d[k], 0.02);
            if (!begin_deep(&d[k], "dss", set, 0.6f, NULL, NULL) || !drawn(&out[k], &d[k].run)) return;
        }
        ssgi_surfel *s[2] = { held(&d[0], 0), held(&d[1], 1) };
        size_t n[2] = { d[0].run.surfels, 0 }, i = 0, k = 0, same = 0;
        double worst = 0, rmse[2];
        /* surfels that another one stands for must have radius 0 */
        for (size_t p = 0; p < d[1].run.surfels; ++p) if (s[1][p].radius > 0) s[1][n[1]++] = s[1][p];
        for (int a = 0; a < 2; ++a) qsort(s[a], n[a], sizeof *s[a], by_seed);
        while (i < n[0] && k < n[1]) {
            if (s[0][i].seed < s[1][k].seed) { ++i; continue; }
            if (s[0][i].seed > s[1][k].seed) { ++k; continue; }
            const float *a = s[0][i++].position, *b = s[1][k++].position;
            const double scale = 1000 * (double)a[3] + 0.1 * sqrt(dot(a, a));   /* tessellators round */
            double off = fabs((double)(a[3] / b[3]) - 1);
            for (int f = 0; f < 11; ++f)
                if (f != 3 && f != 7) off = fmax(off, fabs((double)(a[f] - b[f])) / (f < 3 ? scale : 1));
            same += off < 1e-4;
            worst = fmax(worst, off < 1e-2 ? off : 0);
        }
        CHECK((row[m].every ? n[0] == 70256 : n[0] > 2000) && same * 1000 > 995 * n[0] && same * 1000 > 995 * n[1],
              "%s, %s: of %zu surfels and %zu captured %zu are the same", row[m].scene, row[m].set, n[0], n[1], same);
        for (int a = 0; a < 2; ++a) rmse[a] = difference(&out[0], &out[1 + a]);
        CHECK(rmse[0] < 4e-3 && rmse[1] < 4e-3 && mean(&out[0], "Y") < 0.99,
              "%s, %s: RMSE of capture %.2g, of direct %.2g, mean %.3f", row[m].scene, row[m].set, rmse[0], rmse[1],
              mean(&out[0], "Y"));
        t_note("%s: %zu surfels, %zu captured, %zu the same; worst %.1e; pictures' RMSE %.1e, %.1e", row[m].scene, n[0],
               n[1], same, worst, rmse[0], rmse[1]);
        for (int a = 0; a < 3; ++a) { if (a < 2) free(s[a]); kit_image_free(&out[a]); own_deep(&d[a]); }
    }
}

/* Checks SSGI_GL_PASS_INTERLEAVE: each level has each pixel once, at a random texel of its block. At half resolution
   only the first pixel of every 2x2 counts, at a quarter that of every 4x4. */
static void interleaving(void)
{
    enum { W = 53, H = 37, LEVELS = 5 };
    static const struct {
        const char *set;
        int part, level[2];
    } row[3] = { { "size=0.2,levels=5", 1, { 64, 48 } },
                 { "size=0.2,levels=5,resolution=half", 2, { 32, 32 } },
                 { "size=0.2,levels=5,resolution=quarter", 4, { 16, 16 } } };
    for (int k = 0; k < 3; ++k) {
        const int part = row[k].part, w = (W + part - 1) / part, h = (H + part - 1) / part;
        OWN(deep) d = { 0 };
        int wrong = 0, other = 0, surfaces = 0, level[2] = { 0, 0 };
        if (!dive(&d, "boxes", NULL, 0, NULL, W, H, "dss", row[k].set, 0, NULL)) return;
        kit_run_draw(&d.run, 0);
        ssgi_splat_size(level, w, h, LEVELS, NULL);
        const int wide = level[0], high = level[1];
        FREED float *texel = malloc((size_t)(4 * wide * high * LEVELS) * sizeof *texel);
        if (!CHECK(wide == row[k].level[0] && high == row[k].level[1], "%d x %d", wide, high)
            || !CHECK(!kit_texture_read(kit_run_input(&d.run, "t_ssgi_interleaved", 0), wide, high * LEVELS, 4, texel),
                      "it cannot be read"))
            return;
        for (int y = 0; y < H; y += part)
            for (int x = 0; x < W; x += part) surfaces += d.frame.data[(H - 1 - y) * W + x] > 0;
        for (int l = 0; l < LEVELS; ++l) {
            unsigned char met[H][W] = { { 0 } };
            const int across[2] = { (w + (1 << l) - 1) >> l, (h + (1 << l) - 1) >> l };
            int found = 0;
            for (int y = 0; y < high; ++y)
                for (int x = 0; x < wide; ++x) {
                    const float *p = texel + 4 * ((l * high + y) * wide + x);
                    const int block[2] = { x % across[0], y % across[1] }, sub[2] = { x / across[0], y / across[1] };
                    float at[3];
                    if (p[0] > 1e17f) continue;
                    ssgi_view_project(at, &d.view, p);
                    const int px = (int)floorf(at[0]), py = (int)floorf(at[1]);
                    if (px < 0 || px >= W || py < 0 || py >= H || px % part || py % part) { ++wrong; continue; }
                    const int q[2] = { px / part, py / part };
                    wrong += q[0] >> l != block[0] || q[1] >> l != block[1] || sub[0] >> l || sub[1] >> l
                             || met[py][px]++ || fabs((double)(at[0] - (float)px) - 0.5) > 1e-3
                             || fabs((double)(at[2] / d.frame.data[(H - 1 - py) * W + px]) - 1) > 1e-4;
                    other += (q[0] & ((1 << l) - 1)) != sub[0] || (q[1] & ((1 << l) - 1)) != sub[1];
                    ++found;
                }
            CHECK(found == surfaces, "%s, level %d: %d of %d pixels", row[k].set, l, found, surfaces);
        }
        CHECK(!wrong && 2 * other > 7 * surfaces && surfaces > w * h / 2,
              "%s: %d texels are wrong, %d of %d pixels elsewhere than in fixed order", row[k].set, wrong, other,
              surfaces);
    }
}

/* Surfels, and a method's settings for them. mean: over neighbours and phases, so sub-buffers do not matter. */
typedef struct splatted {
    const ssgi_surfel *s;
    size_t count;
    int levels, hard, enlarge, added, mean;
} splatted;

/* Returns the value that a surfel adds to a pixel (y from the bottom) on the level of its shell. It counts only in its
   own sub-buffer, and there as many times as there are sub-buffers; with mean once, in all. */
static double brought(const deep *d, const splatted *of, const ssgi_surfel *s, int x, int y, const float p[3],
                      const float n[3])
{
    const float v[3] = { s->position[0] - p[0], s->position[1] - p[1], s->position[2] - p[2] };
    const double distance = sqrt(dot(v, v)), radius = (double)d->run.frame.radius,
                 fade = distance > radius ? 0 : of->hard ? 1 : 1 - distance / radius,
                 reach = ssgi_surfel_reach((double)s->radius, 1, (double)d->run.frame.epsilon);
    ssgi_surfel wide = *s;
    int l = 0;
    while (l < of->levels && distance > ldexp(reach, l)) ++l;
    if (l >= of->levels || !(fade > 0)) return 0;
    if (of->mean) return (double)form_factor(s, p, n) * fade;
    const int mask = (1 << l) - 1, seed = (int)(s->seed * 16777216.0f);
    uint32_t h = (uint32_t)(x >> l) * 747796405u + (uint32_t)(y >> l) * 2891336453u + (uint32_t)mask;
    h = ((h >> ((h >> 28) + 4)) ^ h) * 277803737u;
    h ^= h >> 22;
    if (((x ^ (int)h ^ seed) | (y ^ (int)(h >> 8) ^ seed >> 8)) & mask) return 0;
    if (of->enlarge) wide.radius *= (float)(1 << l);
    return (double)form_factor(&wide, p, n) * fade * (of->enlarge ? 1 : 1 << 2 * l);
}

/* Differences between pictures of SSGI_GL_PASS_DSS, _DEINTERLEAVE and _SUM and that sum over all surfels, at every
   step-th pixel; most: the largest sum. A pixel without a surface is 1. */
typedef struct offset { double worst, most, rmse, bias, dark; int off, pixels; } offset;

static offset compared(const deep *d, const kit_image *out, const splatted *of, int step)
{
    offset o = { 0 };
    const int w = out->width, h = out->height;
    for (int i = 0; i < w * h; i += step) {
        float p[3], n[3];
        double sum = 0;
        const int is_seen = seen(d, i, p, n);
        for (size_t k = 0; k < of->count && is_seen; ++k)
            sum += brought(d, of, &of->s[k], i % w, h - 1 - i / w, p, n);
        const double expected = of->added ? 1 - fmin(sum, 1) : exp(-sum), off = (double)out->data[i] - expected;
        o.off += fabs(off) > 1e-3;
        o.worst = fmax(o.worst, fabs(off));
        o.most = fmax(o.most, sum);
        if (!is_seen) continue;
        o.rmse += off * off;
        o.bias += off;
        o.dark += (1 - expected) * (1 - expected);
        ++o.pixels;
    }
    o.rmse = sqrt(o.rmse / o.pixels);
    o.dark = sqrt(o.dark / o.pixels);
    o.bias /= o.pixels;
    return o;
}

/* Checks that each pixel is the sum over the surfels of its own sub-buffers, and smoothed pixels are so in the mean. A
   picture without surfel buffers (way=direct) is compared with the CPU's surfels. in_turn: surfels may also be numbered
   as in the paper, instead of by a hash: on each level the k-th goes to sub-buffer k modulo 4^level. Sums above 1 are
   shares of what is left, or 1. */
static void as_brute_force(void)
{
    static const struct { const char *set; splatted of; int orthographic, in_turn; float radius;
    } row[] = { { "levels=1,falloff=none,smooth=0,size=0.07", { .levels = 1, .hard = 1 }, 0, 0, 0 },
                { "levels=1,smooth=0,size=0.07", { .levels = 1 }, 1, 0, 0.4f },
                { "levels=4,falloff=none,smooth=0,size=0.07", { .levels = 4, .hard = 1 }, 0, 0, 0 },
                { "levels=4,falloff=none,smooth=0,size=0.06,combine=add", { .levels = 4, .hard = 1, .added = 1 },
                  0, 0, 0 },
                { "levels=4,smooth=0,size=0.06,combine=add,enlarge=1", { .levels = 4, .added = 1, .enlarge = 1 },
                  0, 0, 0.6f },
                { "levels=3,smooth=0,size=0.06,way=direct", { .levels = 3 }, 1, 0, 0.6f },
                { "levels=5,smooth=0,size=0.06", { .levels = 5 }, 0, 1, 0.6f },
                { "levels=4,smooth=1,size=0.06", { .levels = 4, .mean = 1 }, 0, 0, 0.6f } };
    OWN(kit_scene) scene = { 0 };
    if (!TRY(kit_scene_load(&scene, "boxes", 0, &err))) return;
    for (int m = 0; m < ROWS(row); ++m) {
        OWN(deep) d = { 0 }, cpu = { 0 };
        OWN(kit_image) out = { 0 };
        kit_camera c = scene.camera;
        char set[160];
        splatted of = row[m].of;
        if (row[m].orthographic) { c.fovy = 0; c.ortho_height = 2.5f; }
        snprintf(set, sizeof set, "epsilon=0.02,near_samples=1,span=0,%s", row[m].set);
        if (!dive(&d, "boxes", NULL, 0, &c, 96, 54, "dss", set, row[m].radius, NULL)
            || !dive(&cpu, "boxes", NULL, 0, &c, 96, 54, "dss", "size=0.06", row[m].radius, NULL))
            return;
        FREED ssgi_surfel *s = held(strstr(set, "direct") ? &cpu : &d, 0);
        of.s = s;
        of.count = strstr(set, "direct") ? cpu.run.surfels : d.run.surfels;
        for (size_t k = 0; k < of.count && row[m].in_turn; ++k) {
            uint32_t seed = 0;                                                 /* its low bytes are column and row */
            for (int l = 0; l < 8; ++l)
                seed |= (uint32_t)(k >> 2 * l & 1) << l | (uint32_t)(k >> (2 * l + 1) & 1) << (8 + l);
            s[k].seed = (float)seed / 16777216;
        }
        if (row[m].in_turn) hold(&d, s, of.count);
        if (!drawn(&out, &d.run)) return;
        const offset o = compared(&d, &out, &of, 5);
        CHECK(of.mean ? fabs(o.bias) < 5e-4 && o.rmse < 0.02 * o.dark : o.off <= 2,
              "%s: %d pixels off, by %.2g at most, bias %+.5f, RMSE %.4f of %.4f", set, o.off, o.worst, o.bias, o.rmse,
              o.dark);
        CHECK(o.dark > 0.03 && o.pixels > 96 * 9 && (!of.hard || of.levels < 2 || o.most > 1.2),
              "%s: nothing to see, or sums up to %.2f", set, o.most);
        t_note("%s: %zu surfels, %d of %d pixels off by more than 0.001, bias %+.5f, RMSE %.4f (occlusion's %.3f), "
               "sums up to %.2f", row[m].set, of.count, o.off, o.pixels, o.bias, o.rmse, o.dark, o.most);
    }
}

/* Returns a surfel at a point of the world, facing a direction. */
static ssgi_surfel placed(const deep *d, float x, float y, float z, float nx, float ny, float nz, float radius,
                          float seed)
{
    const float p[3] = { x, y, z }, n[3] = { nx, ny, nz };
    ssgi_surfel s = { .radius = radius, .seed = seed, .colour = { 1, 1, 1 } };
    for (int k = 0; k < 3; ++k) {
        s.position[k] = d->world[12 + k];
        for (int i = 0; i < 3; ++i) {
            s.position[k] += d->world[4 * i + k] * p[i];
            s.normal[k] += d->world[4 * i + k] * n[i];
        }
    }
    return s;
}

/* Draws the picture of these surfels alone. */
static int of_these(kit_image *out, deep *d, const ssgi_surfel *s, size_t count)
{
    hold(d, s, count);
    return drawn(out, &d->run);
}

static const box block = { { -0.3f, 0, -0.3f }, { 0.3f, 0.6f, 0.3f } };

/* Checks surfels beside the picture, behind the eye, hidden, across the near plane: each darkens the surface that it
   faces as much as it would in view. Its back does nothing. */
static void unseen(void)
{
    for (int m = 0; m < 2; ++m) {
        OWN(deep) d = { 0 };
        kit_camera c = { { 0, 1.5f, 2 }, { 0, 0, 0 }, { 0, 1, 0 }, m ? 0 : 45, 2, 0.1f, 50, 96, 54, { 11, -5 },
                         m ? KIT_DEPTH_REVERSED : KIT_DEPTH_INFINITE };
        if (!dive(&d, "plane", &block, 1, &c, 96, 54, "dss",
                  "levels=1,falloff=none,smooth=0,epsilon=0.003,near_samples=1,span=0,near_depth=0", 0, NULL))
            return;
        const struct { const char *where; ssgi_surfel s; double least;
        } row[] = { { "off screen", placed(&d, -2.6f, 0.7f, 0, 0.8f, -0.6f, 0, 0.3f, 0), 0.002 },
                    { "behind the eye", placed(&d, 0.1f, 1.2f, 3, 0, -1, 0, 0.5f, 0.3f), 0.002 },
                    { "hidden", placed(&d, 0, 0.2f, -0.5f, 0, -0.6f, -0.8f, 0.2f, 0.7f), 0.0002 },
                    { "across the near plane", placed(&d, 0.05f, 1.4f, 1.9f, 0, -1, 0, 0.4f, 0.9f), 0.002 },
                    { "in view", placed(&d, 0.5f, 0.5f, 0.5f, 0, -1, 0, 0.1f, 0.1f), 0.002 } };
        for (int k = 0; k < 2 * ROWS(row); ++k) {
            const char *const side = k & 1 ? ", its back" : "";
            ssgi_surfel s = row[k / 2].s;
            const splatted of = { .s = &s, .count = 1, .levels = 1, .hard = 1 };
            OWN(kit_image) out = { 0 };
            float at[3];
            ssgi_view_project(at, &d.view, s.position);
            const int x = (int)floorf(at[0]), y = 53 - (int)floorf(at[1]),
                      inside = -s.position[2] > 0.1f && x >= 0 && x < 96 && y >= 0 && y < 54;
            CHECK(k / 2 < 2 ? !inside : k / 2 != 2 || (inside && d.frame.data[y * 96 + x] < -s.position[2] - 0.1f),
                  "%s: it is not", row[k / 2].where);
            for (int i = 0; i < 3 && k & 1; ++i) s.normal[i] = -s.normal[i];
            if (!of_these(&out, &d, &s, 1)) return;
            const offset o = compared(&d, &out, &of, 1);
            CHECK(o.worst < 1e-3 && (k & 1 || 1 - mean(&out, "Y") > row[k / 2].least),
                  "view %d, %s%s: off by %.2g, mean %.5f", m, row[k / 2].where, side, o.worst, 1 - mean(&out, "Y"));
        }
    }
}

/* The test's own GLSL of occlusion: a disc's reach and form factor. */
static const char disc[] =
    "float ssgi_custom_reach(vec3 position, vec3 normal, float radius, vec3 colour, float epsilon) {\n"
    "    return radius * sqrt(1.0 / epsilon - 1.0);\n"
    "}\n"
    "vec4 ssgi_custom_effect(vec3 position, vec3 normal, float radius, vec3 colour, vec3 P, vec3 n) {\n"
    "    vec3 v = position - P;\n"
    "    float d = dot(v, v), rr = radius * radius, w = max(dot(v, n), 0.0) * max(-dot(v, normal), 0.0);\n"
    "    float form = rr * w / (d * (d + rr));\n"
    "    return vec4(form, form * colour.y, 0.0, form);\n"
    "}\n";

static const char reaches_nowhere[] =
    "float ssgi_custom_reach(vec3 p, vec3 n, float r, vec3 c, float e) { return 0.0; }\n"
    "vec4 ssgi_custom_effect(vec3 p, vec3 n, float r, vec3 c, vec3 P, vec3 m) { return vec4(1.0); }\n";

/* Checks that what a custom effect brings equals what the library's own brings, on one level, on several and enlarged.
   Its channels are separate, and an effect without reach adds nothing. */
static void custom(void)
{
    static const char *const sets[] = { "levels=1", "levels=4,way=direct", "levels=4,enlarge=1",
                                        "levels=4,combine=add" };
    kit_lighting l;
    if (!lighten(&l, NULL, "point:0,5,0,1,1,1")) return;
    for (int k = 0; k <= ROWS(sets); ++k) {
        const int reaches = k < ROWS(sets);
        char set[2][128];
        deep d[2];
        kit_image out[2];
        double worst = 0, dark = 0;
        snprintf(set[0], sizeof set[0], "size=0.04,falloff=none,near_samples=1,span=0,%s", sets[k % ROWS(sets)]);
        snprintf(set[1], sizeof set[1], "size=0.04,epsilon=0.3,shadows=none,near_samples=1,%s", sets[k % ROWS(sets)]);
        if (!dive(&d[0], "boxes", NULL, 0, NULL, 96, 54, "dss", set[0], 0.6f, NULL) || !drawn(&out[0], &d[0].run)
            || !look(&d[1], "boxes", NULL, 0, NULL, 96, 54)
            || !begin_deep(&d[1], "dss-gloss", set[1], 0.6f, &l, reaches ? disc : reaches_nowhere)
            || !drawn(&out[1], &d[1].run))
            return;
        const float *got = kit_image_channel(&out[1], "irradiance.R"),
                    *green = kit_image_channel(&out[1], "irradiance.G"),
                    *blue = kit_image_channel(&out[1], "irradiance.B");
        for (int i = 0; i < 96 * 54; ++i) {
            const double want = reaches ? 1 - (double)out[0].data[i] : 0;
            worst = fmax(worst, fmax(fabs((double)got[i] - want), (double)blue[i]));
            dark = fmax(dark, (double)green[i]);
        }
        CHECK(worst < 1e-5 && (dark > 0) == reaches, "%d, %s: off by %.2g, by the colour up to %g", k, set[1], worst,
              dark);
        for (int i = 0; i < 2; ++i) { kit_image_free(&out[i]); own_deep(&d[i]); }
    }
}

/* Checks a white plane of surfels under a white sky: the light that leaves it is the dipole's total, also if surfels
   are wider than the light goes deep. */
static void scattering(void)
{
    enum { ROW = 200 };
    static const struct {
        const char *name;
        int number;
        double unit, uneven;
    } row[2] = { { "skin1", 8, 0.05, 0.15 }, { "marble", 5, 0.02, 0.18 } };
    static ssgi_surfel s[ROW * ROW];
    OWN(kit_lighting) l = { 0 };
    if (!lighten(&l, "white", NULL)) return;
    for (int m = 0; m < 2; ++m) {
        char set[128];
        OWN(deep) d = { 0 };
        OWN(kit_image) out = { 0 };
        ssgi_dipole dipole;
        const kit_material *material = kit_material_of(row[m].number);
        const kit_camera c = { { 0, 2, 0 }, { 0, 0, 0 }, { 0, 0, -1 },    0, 1, 0.1f, 50, 48,
                               48,          { 0, 0 },    KIT_DEPTH_NORMAL };
        snprintf(set, sizeof set, "levels=4,epsilon=0.005,size=0.2,material=%s,unit=%g", row[m].name, row[m].unit);
        if (!CHECK(!strcmp(material->name, row[m].name), "%s is not there", row[m].name)
            || !dive(&d, "plane", NULL, 0, &c, 48, 48, "dss-scatter", set, 0, &l))
            return;
        for (int i = 0; i < ROW * ROW; ++i)
            s[i] = placed(&d, 0.03f * ((float)(i % ROW) + t_uniform(0, 1) - ROW / 2), 0,
                          0.03f * ((float)(i / ROW) + t_uniform(0, 1) - ROW / 2), 0, 1, 0, (float)(0.03 / sqrt(pi)),
                          t_uniform(0, 1));
        if (!of_these(&out, &d, s, ROW * ROW)) return;
        ssgi_dipole_set(&dipole, material->sigma_s, material->sigma_a, material->eta, NULL);
        for (int k = 0; k < 3; ++k) {
            static const char *const names[3] = { "irradiance.R", "irradiance.G", "irradiance.B" };
            const double is = mean(&out, names[k]), total = total_of(&dipole, k);
            CHECK(fabs(is / total - 1) < 0.01, "%s %s: %.4f, %.4f expected", row[m].name, names[k], is, total);
            double uneven = 0;
            for (int i = 0; i < 48 * 48; ++i)
                uneven += pow((double)kit_image_channel(&out, names[k])[i] / is - 1, 2) / (48 * 48);
            uneven = sqrt(uneven);
            CHECK(uneven < row[m].uneven, "%s %s: uneven by %.3f: surfels show", row[m].name, names[k], uneven);
            if (!k) t_note("%s, red: %.4f of %.4f, even to %.3f", row[m].name, is, total, uneven);
        }
    }
}

/* Checks that surfels of two sides, light below the surface and one's own effect also reach behind a surfel. */
static void turned_over(void)
{
    static const char even[] =
        "float ssgi_custom_reach(vec3 p, vec3 n, float r, vec3 c, float e) { return r * sqrt(1.0 / e - 1.0); }\n"
        "vec4 ssgi_custom_effect(vec3 p, vec3 n, float r, vec3 c, vec3 P, vec3 m) { return vec4(0.1); }\n";
    static const struct { const char *method, *set, *channel, *custom;
    } row[] = { { "dss", "resolution=half,two_sided=1,near_samples=1,span=0", "Y", NULL },
                { "dss-scatter", "resolution=half,shadows=none,levels=1,epsilon=0.3,unit=0.05", "irradiance.R", NULL },
                { "dss-gloss", "shadows=none", "irradiance.R", even } };
    OWN(kit_lighting) l = { 0 };
    if (!lighten(&l, "white", NULL)) return;
    for (int k = 0; k < ROWS(row); ++k) {
        const kit_lighting *lighting = k ? &l : NULL;
        double is[3] = { 0 };
        OWN(deep) d = { 0 };
        if (!look(&d, "plane", NULL, 0, NULL, 96, 54)
            || !begin_deep(&d, row[k].method, row[k].set, 0, lighting, row[k].custom))
            return;
        for (int i = 0; i < 3; ++i) {
            OWN(kit_image) out = { 0 };
            const ssgi_surfel s = placed(&d, 0.2f, 0.2f, 0, 0, i < 2 ? 1 - 2 * (float)i : 1, 0, i < 2 ? 0.3f : 0, 0);
            if (!of_these(&out, &d, &s, 1)) return;
            is[i] = mean(&out, row[k].channel);
        }
        CHECK(fabs(is[1] - is[2]) > 1e-4 && fabs(is[0] - is[1]) < 1e-3 * fabs(is[1] - is[2]),
              "%s: %g facing up, %g facing down, %g without it", row[k].method, is[0], is[1], is[2]);
    }
}

/* Checks that a filtered picture of half resolution is near full resolution's, with and without slices. */
static void half_size(void)
{
    static const char *const channels[3][3] = { { "Y" },
                                                { "irradiance.R", "irradiance.G", "irradiance.B" },
                                                { "bounce.R", "bounce.G", "bounce.B" } };
    static const double most[2][3] = { { 0.12, 0.013, 0.125 }, { 0.3, 0.018, 0.26 } };
    OWN(kit_lighting) l = { 0 };
    if (!lighten(&l, "sky", "sun:1,2,0.5,2,2,2")) return;
    for (int k = 0; k < 4; ++k) {
        const int lit = k & 1, alone = k >> 1;
        char set[64];
        deep d[2];
        OWN(kit_image) none = { 0 };
        kit_image out[2];
        for (int half = 0; half < 2; ++half) {
            snprintf(set, sizeof set, "size=0.06,levels=4,blur=1,resolution=%s,span=%d", half ? "half" : "full",
                     alone ? 0 : 6);
            if (!dive(&d[half], "boxes", NULL, 0, NULL, 256, 144, lit ? "dss-lit" : "dss", set, 0.6f, lit ? &l : NULL)
                || !drawn(&out[half], &d[half].run))
                return;
        }
        if (!TRY(kit_image_new(&none, 256, 144, lit ? KIT_LIT_CHANNELS : "Y", &err))) return;
        for (int i = 0; i < 256 * 144 && !lit; ++i) none.data[i] = 1;
        for (int b = lit; b < 1 + 2 * lit; ++b) {
            kit_score score, nothing;
            TRY(kit_score_channels(&nothing, &none, &out[0], channels[b], lit ? 3 : 1, NULL, &err));
            TRY(kit_score_channels(&score, &out[1], &out[0], channels[b], lit ? 3 : 1, NULL, &err));
            CHECK(score.rmse < most[alone][b] * nothing.rmse && fabs(score.bias) < 0.002 * nothing.rmse,
                  "%s, %s: differs by %.4f of %.4f, bias %.4f", set, channels[b][0], score.rmse, nothing.rmse,
                  score.bias);
            t_note("%s, %s: differs by %.3f, bias %+.4f", set, channels[b][0], score.rmse / nothing.rmse,
                   score.bias / nothing.rmse);
        }
        for (int half = 0; half < 2; ++half) { kit_image_free(&out[half]); own_deep(&d[half]); }
    }
}

/* Checks a floor within a surfel's radius of a wall. Surfels alone leave it too bright, but slices see the wall. */
static void creases(void)
{
    double rmse[2];
    int pixels = 0;
    for (int k = 0; k < 2; ++k) {
        double squares = 0;
        OWN(deep) d = { 0 };
        OWN(kit_image) out = { 0 };
        if (!dive(&d, "corner", NULL, 0, NULL, 160, 90, "dss", k ? "size=0.05" : "size=0.05,span=0", 0.8f, NULL)
            || !drawn(&out, &d.run))
            return;
        pixels = 0;
        for (int i = 0; i < 160 * 90; ++i) {
            const double z = (double)d.frame.data[i];
            float p[3];
            if (!(z > 0)) continue;
            kit_camera_point(&d.g.camera, i % 160, i / 160, z, p);
            if (fabsf(p[1]) > 1e-3f || p[0] < 1e-3f || (double)p[0] > ssgi_surfel_radius(&d.view, 0.05, z)) continue;
            squares += pow(1 - linear_corner((double)p[0] / 0.8) - (double)out.data[i], 2);
            ++pixels;
        }
        rmse[k] = sqrt(squares / pixels);
    }
    CHECK(pixels > 20 && rmse[1] < 0.09 && rmse[1] < 0.5 * rmse[0], "%d pixels: RMSE %.4f, surfels alone %.4f", pixels,
          rmse[1], rmse[0]);
    t_note("%d pixels: RMSE %.4f, of surfels alone %.4f", pixels, rmse[1], rmse[0]);
}

/* Checks surfels that send 2^-octaves..1, as many in each octave, and their size makes their flux a power of that. Half
   of it is sent above ((1 + 2^(-octaves power)) / 2)^(1 / power). Bins of h = 1/8 octave, in which flux counts as even,
   have an error of the logarithm of at most power h^2 / 8, an exponential's distance from its chord; or one surfel
   more. */
static void sent_by_half(void)
{
    enum { N = 1 << 14 };
    static ssgi_surfel surfel[N];
    static const float sky[3] = { 0.25f, 1, 0.5f };
    static const double powers[] = { 1, 2, 3, 0, -1 };
    for (int k = 0; k < ROWS(powers); ++k) {
        const double power = powers[k], h = log(2) / 8;
        double worst = 0;
        for (double octaves = 1; octaves < 32; octaves *= 1.1) {
            ssgi_gl_frame frame = { .sent = 0 };
            for (int i = 0; i < N; ++i) {
                const float sent = (float)exp2(-octaves * (i + 0.5) / N);
                surfel[i] = (ssgi_surfel){ .radius = (float)(1e-3 * pow((double)sent, (power - 1) / 2)),
                                           .colour = { sent, sent, sent } };
            }
            CHECK(ssgi_gl_sent_set(&frame, surfel, N, NULL, 0, sky, NULL) == SSGI_OK, "refused");
            const double half = power == 0 ? -octaves / 2 * log(2) : log((1 + exp2(-octaves * power)) / 2) / power,
                         off = fabs(log((double)frame.sent) - half),
                         most = fabs(power) * h * h / 8 + octaves * log(2) / N;
            CHECK(off < most, "flux by power %g over %g octaves: %g, not %g", power, octaves, (double)frame.sent,
                  exp(half));
            worst = fmax(worst, off / most);
        }
        t_note("flux by power %g: off by %.2f of the bins' most", power, worst);
    }
}

/* Checks that one surfel alone in its bin counts at the bin's middle, 1/16 octave below what it sends in its largest
   component: colour times irradiance over pi. */
static void sent_by_one(void)
{
    static const ssgi_surfel surfel = { .position = { 1, 2, -5 }, .radius = 0.1f, .normal = { 0, 0, 1 },
                                        .colour = { 0.5f, 0.25f, 0.125f } };
    /* a map of 8 x 8 texels, in which the surfel is at x, y and a depth of z */
#define MAP(x, y, z) \
    .tile = { 3, 5, 8, 8 }, \
    .map = { { (x) * (z), 0, 0, 0 }, { 0, (y) * (z) / 2, 0, 0 }, { 0, 0, (z) / -10.0f, (z) / 2.0f } }
#define SIDE 1, 5, -1 /* at a distance of 5, 4/5 of it along the surfel's normal */
    static const struct { const char *what; ssgi_gl_light light; double facing; int sky;
    } row[] = {
        { "a sun", { .at = { 0, 0.6f, 0.8f } }, 0.8, 0 },
        { "a sun behind", { .at = { 0, 0.6f, -0.8f } }, 0, 0 },
        { "a sun with a wider map, in two rows", { .at = { 0, 0.6f, 0.8f }, .min_distance = 1 }, 0.8 / 2, 0 },
        { "a point", { .kind = SSGI_GL_LIGHT_POINT, .at = { SIDE } }, 0.8 / 25, 0 },
        { "a near point", { .kind = SSGI_GL_LIGHT_POINT, .at = { 1, 2, -4.9f }, .min_distance = 0.5f }, 4, 0 },
        { "a virtual point", { .kind = SSGI_GL_LIGHT_VPL, .at = { SIDE }, .normal = { 0, -1, 0 } }, 0.8 * 0.6 / 25, 0 },
        { "a virtual point that faces away",
          { .kind = SSGI_GL_LIGHT_VPL, .at = { SIDE }, .normal = { 0, 1, 0 } },
          0,
          0 },
        { "a spot without a map", { .kind = SSGI_GL_LIGHT_SPOT, .at = { SIDE } }, 0.8 / 25, 0 },
        { "a spot", { .kind = SSGI_GL_LIGHT_SPOT, .at = { SIDE }, MAP(7.9f, 0.1f, 4) }, 0.8 / 25, 0 },
        { "beyond its map's right", { .kind = SSGI_GL_LIGHT_SPOT, .at = { SIDE }, MAP(8.1f, 1, 4) }, 0, 0 },
        { "beyond its left", { .kind = SSGI_GL_LIGHT_SPOT, .at = { SIDE }, MAP(-0.1f, 1, 4) }, 0, 0 },
        { "beyond its top", { .kind = SSGI_GL_LIGHT_SPOT, .at = { SIDE }, MAP(1, 8.1f, 4) }, 0, 0 },
        { "beyond its bottom", { .kind = SSGI_GL_LIGHT_SPOT, .at = { SIDE }, MAP(1, -0.1f, 4) }, 0, 0 },
        { "a sun with a map", { .at = { 0, 0.6f, 0.8f }, MAP(9, 9, 4) }, 0.8, 0 },
        { "a sun and the sky", { .at = { 0, 0.6f, 0.8f } }, 0.8, 1 },
        { "the sky", { .at = { 0, 0, -1 } }, 0, 1 },
    };
    for (int i = 0; i < ROWS(row); ++i) {
        static const float colour[3] = { 2, 16, 8 }, sky[3] = { 0.75f, 0.25f, 0.5f };
        ssgi_gl_light light[2] = { row[i].light, row[i].light };
        ssgi_gl_frame frame = { .sent = 7 };
        double sent = 0;
        memcpy(light[0].colour, colour, sizeof colour);
        memcpy(light[1].colour, colour, sizeof colour);
        if (light[1].kind == SSGI_GL_LIGHT_SUN) light[1].min_distance = 0; /* no row of a wider map follows */
        for (int c = 0; c < 3; ++c)
            sent = fmax(sent, (double)surfel.colour[c] * ((row[i].sky ? (double)sky[c] : 0)
                                                          + 2 * (double)colour[c] * row[i].facing / pi));
        const double want = sent > 0 ? sent * exp2(-1.0 / 16) : 7;
        CHECK(ssgi_gl_sent_set(&frame, &surfel, 1, light, 2, row[i].sky ? sky : NULL, NULL) == SSGI_OK
                  && fabs((double)frame.sent / want - 1) < 1e-5,
              "%s: %g, not %g", row[i].what, (double)frame.sent, want);
    }
#undef MAP
#undef SIDE
}

/* Checks that without slices surfels send their colour times the white sky they see. The bounce is albedo times the
   missing light, by the sky's brightness. Without it the light is the same, and the truth has no bounce, either. */
static void sky_returned(void)
{
    static const struct { const char *set; float sky; } row[] = { { "span=0,size=0.05,bounce=none", 1 },
                                                                  { "span=0,size=0.05", 1 },
                                                                  { "span=0,size=0.05,way=direct", 1 },
                                                                  { "span=0,size=0.05", 0.1f },
                                                                  { "span=0,size=0.05", 100 } };
    double none = 0;
    for (int k = 0; k < ROWS(row); ++k) {
        kit_method m;
        OWN(kit_lighting) l = { 0 };
        OWN(kit_image) out = { 0 }, truth = { 0 };
        OWN(deep) d = { 0 };
        if (!lighten(&l, "white", NULL)) return;
        for (int i = 0; i < 3 * l.env.width * l.env.height; ++i) l.env.data[i] = row[k].sky;
        if (!dive(&d, "corner", NULL, 0, NULL, 64, 36, "dss-lit", row[k].set, 0.8f, &l) || !drawn(&out, &d.run)) return;
        const double light = mean(&out, "irradiance.G") / (double)row[k].sky,
                     bounce = mean(&out, "bounce.G") / (double)row[k].sky,
                     want = k ? (double)d.scene.mesh.albedo[1] * (1 - light) : 0;
        if (!k) none = light;
        CHECK(fabs(light / none - 1) < 1e-3 && (!k || want > 0.01) && fabs(bounce - want) <= 0.05 * want,
              "%s under %g: light %.4f, not %.4f, bounce %.4f, not %.4f", row[k].set, (double)row[k].sky, light, none,
              bounce, want);
        if (!k && TRY(kit_method_find(&m, "dss-lit", &err)) && TRY(kit_method_set(&m, row[k].set, &err))
            && TRY(kit_method_truth(&truth, &m, &d.scene, &d.g.camera, &l, 0.8f, 4, 1, &err)))
            CHECK(mean(&truth, "bounce.G") == 0 && mean(&truth, "irradiance.G") > 0.5, "its truth has a bounce of %g",
                  mean(&truth, "bounce.G"));
        t_note("under a white sky of %g %.4f of it is missing, %.4f comes back", (double)row[k].sky, 1 - light, bounce);
    }
}

void test_surfels(void)
{
    RUN("points of all 64 levels are counted and placed as the tessellator does", points);
    RUN("levels: the fewest points for the area, at least 1, on either side of every border", levels);
    RUN("surfels have their triangles' area: split ones, and by chance small ones", areas);
    RUN("of 10,000 slivers none turns over, no surfel is outside; discs end at edges where they fit", slivers);
    RUN("degenerate, endless, tiny, far and mirrored triangles", odd_triangles);
    RUN("a reach ends where epsilon is brought; every distance is in one shell", reach_and_shells);
    RUN("bounds of spheres and halves of them hold what is deeper than the front, and no more", bounds);
    RUN("surfels are as large on the screen as asked for", radii);
    RUN("predicted surfels are exact, pixels near", predictions);
    RUN("levels of splats: the fewest that end beyond the radius", levels_wanted);
    RUN("huge triangles are divided, small ones stay", divided);
    RUN("dipoles as published", dipoles);
    RUN("bad arguments are named and nothing is written", refusals);
    RUN("half of the flux is sent above the radiance that is found, to a bin's share", sent_by_half);
    RUN("one surfel sends what each kind of light and the sky give it", sent_by_one);
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("tessellation shaders make the CPU's surfels; three ways give one picture", three_ways);
    RUN("interleaving deals every pixel out once a level", interleaving);
    RUN("each pixel is what brute force over its own sub-buffers is, also where they are in turn or overlap",
        as_brute_force);
    RUN("surfels beside the picture, behind the eye, hidden and across the near plane darken what they face", unseen);
    RUN("an effect and a reach of one's own: a disc is what occlusion is", custom);
    RUN("of two sides, under the surface and by one's own effect a surfel reaches what is behind it", turned_over);
    RUN("a scattering plane is as bright as its dipole's total", scattering);
    RUN("beside a wall slices see what surfels are too coarse for", creases);
    RUN("without slices surfels reflect what they take of a white sky, from 0.1 to 100; bounce=none: nothing",
        sky_returned);
    RUN("of half size occlusion, light and bounce are near those of full size", half_size);
    kit_gl_close();
}
