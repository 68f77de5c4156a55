/* test_field.c - ssgi.h's room of fields, against closed forms, exact solid angles of boxes and balls, reference fits,
   and rays that the tests trace. */
#include "t.h"
/* white-box: this file has its own copy of the library, to reach its private functions */
#define SSGI_STATIC
#define SSGI_IMPLEMENTATION
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "../../ssgi.h"
#include "kit/kit_build.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI KIT_PI

static void direction(double d[3])
{
    const double z = t_within(-1, 1);
    ssgi__polar(d, z, t_within(0, 2 * PI));
}

/* returns centre + r w, as the floats of a point */
static const float *point_at(const float centre[3], double r, const double w[3])
{
    static float p[4][3];
    static int next;
    float *out = p[next = (next + 1) % 4];
    for (int k = 0; k < 3; ++k) out[k] = (float)((centre ? (double)centre[k] : 0) + r * w[k]);
    return out;
}

/* ---- >>field: the parts of a bake -------------------------------------------------------------------------------- */

/* Writes the exact solid angle and vector irradiance of a box about the origin, seen from p outside. Each visible face
   is two triangles [Oosterom, Strackee 1983] and four edges [Lambert]. */
static void box_exact(double out[4], const double half[3], const double p[3])
{
    memset(out, 0, 4 * sizeof *out);
    for (int face = 0; face < 6; ++face) {
        const int n = face / 2, u = (n + 1) % 3, v = (n + 2) % 3;
        const double side = face & 1 ? -1 : 1;
        double q[4][3], sum[3] = { 0 };
        if (p[n] * side <= half[n]) continue;
        for (int k = 0; k < 4; ++k) {
            q[k][n] = side * half[n] - p[n];
            q[k][u] = (k == 1 || k == 2 ? half[u] : -half[u]) - p[u];
            q[k][v] = (k > 1 ? half[v] : -half[v]) - p[v];
        }
        for (int t = 0; t < 2; ++t) {
            const double *a = q[0], *b = q[1 + t], *c = q[2 + t], la = sqrt(kit_dot(a, a)), lb = sqrt(kit_dot(b, b)),
                         lc = sqrt(kit_dot(c, c));
            double x[3];
            kit_cross(b, c, x);
            out[0] += fabs(2 * atan2(kit_dot(a, x), la * lb * lc + kit_dot(a, b) * lc + kit_dot(b, c) * la
                                                        + kit_dot(c, a) * lb));
        }
        for (int k = 0; k < 4; ++k) {
            double x[3];
            kit_cross(q[k], q[(k + 1) % 4], x);
            const double angle = atan2(ssgi__normalise(x), kit_dot(q[k], q[(k + 1) % 4]));
            for (int i = 0; i < 3; ++i) sum[i] += 0.5 * angle * x[i];
        }
        const double towards = sum[n] * q[0][n] < 0 ? -1 : 1;
        for (int k = 0; k < 3; ++k) out[1 + k] += towards * sum[k];
    }
}

typedef struct samples { double radii[64], values[64], directions[64 * 3], w[3]; } samples;

/* Makes exact samples along a ray, with a bake's spacing; half NULL: of the unit ball. */
static void sample_ray(samples *s, const double *half, const double w[3], int count)
{
    const double far_away = half ? 8 * sqrt(kit_dot(half, half)) : 8;
    double near_by = half ? 1e30 : 1;
    memcpy(s->w, w, sizeof s->w);
    ssgi__normalise(s->w);
    for (int k = 0; k < 3 && half; ++k) if (s->w[k] != 0) near_by = fmin(near_by, half[k] / fabs(s->w[k]));
    for (int i = 0; i < count; ++i) {
        double p[3], exact[4];
        s->radii[i] = near_by * pow(far_away / near_by, i / (count - 1.0)) * (i ? 1 : 1 + 1e-9);
        for (int k = 0; k < 3; ++k) p[k] = s->radii[i] * s->w[k];
        if (half) box_exact(exact, half, p);
        else exact[0] = 2 * PI * (1 - sqrt(1 - 1 / (s->radii[i] * s->radii[i])));
        s->values[i] = exact[0];
        if (!half) continue;
        ssgi__normalise(exact + 1);
        memcpy(s->directions + 3 * i, exact + 1, 3 * sizeof(double));
    }
}

static double quadratic(const double q[3], double t)
{
    return q[0] * (1 - t) * (1 - t) + 2 * q[1] * t * (1 - t) + q[2] * t * t;
}

static double least_of(const double q[3])
{
    double least = 1e300;
    for (int i = 0; i < 1000; ++i) least = fmin(least, quadratic(q, i / 999.0));
    return least;
}

static void fits(void)
{
    /* half 0: the ball. error: the optimum, found by another descent from many starts */
    const struct { double half[3], w[3]; int count; double error;
    } rows[] = { { { 1, 1, 1 }, { 1, 0, 0 }, 32, 1.216465e-2 },
                 { { 1, 1, 1 }, { 1, 1, 0 }, 32, 5.168629e-4 },
                 { { 1, 1, 1 }, { 1, 1, 1 }, 32, 4.710741e-8 },
                 { { 1, 1, 1 }, { 6, 3, 2 }, 32, 8.763182e-2 },
                 { { 1, 1, 1 }, { 9, 1, 7 }, 32, 2.554233e-1 },
                 { { 0 }, { 1, 0, 0 }, 16, 4.120544e-2 },
                 { { 0 }, { 1, 0, 0 }, 64, 4.233979e-1 },
                 { { 1, 1, 0.05 }, { 0, 0, 1 }, 16, 0.00679018239 },
                 { { 1, 1, 0.05 }, { 1, 0, 0 }, 16, 9.86588616e-05 },
                 { { 1, 1, 0.05 }, { 1, 1, 0.05 }, 16, 2.60447768e-05 },
                 { { 1, 1, 0.05 }, { -0.511427511, -0.844602922, -0.158391307 }, 16, 2.33613284 },
                 { { 1, 0.1, 0.1 }, { 0.21723003, 0.440070427, -0.871291646 }, 16, 0.0883685306 },
                 { { 1, 1, 1 }, { -0.628675918, 0.66321451, 0.406094945 }, 16, 0.0600108708 },
                 { { 1, 0.3, 0.02 }, { 1, 0, 0 }, 6, 5.7743997e-09 },
                 { { 1, 0.3, 0.02 }, { 1, 1, 0.05 }, 16, 0.00234562866 } };
    static samples s;
    double q[3], worst = 0;
    for (int i = 0; i < ROWS(rows); ++i) {
        sample_ray(&s, rows[i].half[0] > 0 ? rows[i].half : NULL, rows[i].w, rows[i].count);
        const double error = ssgi__field_fit(q, s.radii, s.values, rows[i].count, 4 * PI);
        CHECK((error <= 1.01 * rows[i].error || error <= 1e-6) && least_of(q) * 4 * PI >= 1 - 1e-12,
              "row %d: %.6g, the best is %.6g; 4 pi q = %g", i, error, rows[i].error, least_of(q) * 4 * PI);
        if (rows[i].error > 1e-6) worst = fmax(worst, error / rows[i].error);
    }
    t_note("worst error of a fit: %.4f of the reference's", worst);
    /* slabs, rods, a cube, from all sides and edge-on; and samples that no occluder has */
    static const double halves[4][3] = { { 1, 1, 0.05 }, { 1, 0.1, 0.1 }, { 1, 1, 1 }, { 1, 0.3, 0.02 } };
    for (int i = 0; i < 800; ++i) {
        const int count = 3 + i * 7 % 62;
        const double most = i % 2 ? PI : 4 * PI;
        double w[3], sum = 0;
        direction(w);
        if (i % 10 == 0) w[2] = 0;
        sample_ray(&s, halves[i % 4], w, count);
        for (int k = 0; k < count; ++k)
            s.values[k] = i % 5 ? fmin(s.values[k], most) : i % 3 ? t_within(0, most) : t_within(-1, 1) > 0 ? most : 0;
        const double error = ssgi__field_fit(q, s.radii, s.values, count, most);
        for (int k = 0; k < count; ++k) {
            const double at = (s.radii[k] - s.radii[0]) / (s.radii[count - 1] - s.radii[0]);
            sum += pow(1 / quadratic(q, at) - s.values[k], 2);
        }
        CHECK(least_of(q) * most >= 1 - 1e-12 && fabs(sum - error) <= 1e-9 * sum + 1e-12,
              "occluder %d, %d samples: at least %g, error %g is %g", i, count, least_of(q) * most, error, sum);
    }
}

static void centres(void)
{
    const struct { double half[3], w[3], error;
    } rows[] = { { { 1, 1, 1 }, { 6, 3, 2 }, 4.859418e-4 },
                 { { 1, 1, 1 }, { 9, 1, 7 }, 3.280256e-4 },
                 { { 1, 0.5, 0.25 }, { 1, 1, 0 }, 2.658109e-4 },
                 { { 1, 0.5, 0.25 }, { 1, 1, 1 }, 3.920803e-3 },
                 { { 1, 0.5, 0.25 }, { 6, 3, 2 }, 3.163771e-3 },
                 { { 1, 0.5, 0.25 }, { 2, 9, 4 }, 1.193163e-2 },
                 { { 1, 1, 1 }, { 1, 0, 0 }, 0 },
                 { { 1, 1, 1 }, { 1, 1, 0 }, 0 },
                 { { 1, 1, 1 }, { 1, 1, 1 }, 0 },
                 { { 1, 0.5, 0.25 }, { 1, 0, 0 }, 0 } };
    static samples s;
    double c[3], worst = 0;
    for (int i = 0; i < ROWS(rows); ++i) {
        double none = 0;
        sample_ray(&s, rows[i].half, rows[i].w, 32);
        for (int k = 0; k < 32; ++k) none += pow(1 + kit_dot(s.w, s.directions + 3 * k), 2);
        const double error = ssgi__field_centre(c, s.w, s.radii, s.directions, 32, 1e-14);
        CHECK(error <= fmax(1.2 * rows[i].error, 1e-10) && error <= none * (1 + 1e-12) + 1e-28,
              "row %d: %g, the best is %g, c = 0 has %g", i, error, rows[i].error, none);
        if (rows[i].error > 0) worst = fmax(worst, error / rows[i].error);
        else CHECK(sqrt(kit_dot(c, c)) < 1e-3, "row %d is symmetric, c = %g %g %g", i, c[0], c[1], c[2]);
    }
    t_note("worst error of a centre: %.4f of the reference's", worst);
    const double truth[3] = { 0.3, -0.2, 0.4 };
    for (int holes = 0; holes < 3; ++holes) {            /* unknown directions: 0: none; 1: some; 2: all */
        for (int i = 0; i < 32; ++i) {
            for (int k = 0; k < 3; ++k)
                s.directions[3 * i + k] = holes == 2 || (holes && i % 3 == 0) ? 0 : truth[k] - s.radii[i] * s.w[k];
            ssgi__normalise(s.directions + 3 * i);
        }
        const double error = ssgi__field_centre(c, s.w, s.radii, s.directions, 32, 1e-14);
        double off = 0;
        for (int k = 0; k < 3; ++k) off += fabs(c[k] - (holes < 2 ? truth[k] : 0));
        CHECK(off < 1e-6 && error < 1e-14, "one true centre: found %g %g %g, error %g", c[0], c[1], c[2], error);
    }
}

/* ---- occluders --------------------------------------------------------------------------------------------------- */

static const double cube[3] = { 1, 1, 1 };

/* The shape that a test bakes. */
static kit_build shape;

static const kit_mesh *box_mesh(const double half[3])
{
    shape.scene.mesh.triangles = 0;
    kit_box(&shape, -half[0], -half[1], -half[2], half[0], half[1], half[2]);
    return &shape.scene.mesh;
}

static const kit_mesh *table_mesh(void)
{
    shape.scene.mesh.triangles = 0;
    kit_box(&shape, -1, -0.7, 0.8, 1, 0.7, 1);
    for (int k = 0; k < 4; ++k) {
        const double x = k & 1 ? 0.9 : -0.9, y = k & 2 ? 0.6 : -0.6;
        kit_box(&shape, x - 0.08, y - 0.08, -0.9, x + 0.08, y + 0.08, 0.9);
    }
    return &shape.scene.mesh;
}

static const kit_mesh *ball_mesh(void)
{
    static const double radius = 1;
    shape.scene.mesh.triangles = 0;
    kit_patch(&shape, 44, 22, kit_sphere_surface, &radius);
    return &shape.scene.mesh;
}

static int traced_by(ssgi_trace *trace, const kit_mesh *m)
{
    static uint64_t memory[1 << 17];
    return T_OK(ssgi_trace_build, trace, memory, sizeof memory, m->position, 12, NULL, m->triangles);
}

/* Tests rays for a bake: user is the half sides of a box, or the radius of a ball. */
static int box_hit(void *user, const float o[3], const float d[3])
{
    const double *half = (const double *)user;
    double in = 0, out = 1e30;
    for (int k = 0; k < 3; ++k) {
        const double p = (double)o[k], step = fabs((double)d[k]) > 1e-30 ? (double)d[k] : 1e-30,
                     a = (-half[k] - p) / step, b = (half[k] - p) / step;
        in = fmax(in, fmin(a, b));
        out = fmin(out, fmax(a, b));
    }
    return in < out;
}

static int ball_hit(void *user, const float o[3], const float d[3])
{
    const double radius = *(const double *)user, p[3] = { (double)o[0], (double)o[1], (double)o[2] },
                 w[3] = { (double)d[0], (double)d[1], (double)d[2] };
    const double b = kit_dot(p, w), c = kit_dot(p, p) - radius * radius;
    return c < 0 || (b < 0 && b * b > c * kit_dot(w, w));
}

/* Tests rays for a bake: a ball through which half of the rays pass. */
static int porous_hit(void *user, const float o[3], const float d[3])
{
    uint32_t bits[2];
    memcpy(bits, d, sizeof bits);
    return ball_hit(user, o, d) && ((bits[0] * 2654435761u ^ bits[1] * 2246822519u) >> 31);
}

static int nothing_hit(void *user, const float o[3], const float d[3]) { (void)user; (void)o; (void)d; return 0; }

static void threads(void *user, int count, void (*job)(void *context, int i), void *context)
{
    (void)user;
    kit_parallel(NULL, count, job, context);
}
static void backwards(void *user, int count, void (*job)(void *context, int i), void *context)
{
    (void)user;
    while (count) job(context, --count);
}

/* Room for four baked fields, one of which baked() fills. Its work memory is not aligned and ends right at its size. It
   uses threads unless the desc has its own. */
static uint32_t place[4][6 * 66 * 66 * 2 + 1];

static ssgi_field baked(int at, const ssgi_field_desc *desc, const kit_mesh *m)
{
    ssgi_field_desc d = *desc;
    ssgi_field f = { .texels = place[at], .resolution = 2, .reach = 1 };
    const size_t size = ssgi_field_bake_size(&d, m->triangles),
                 used = ssgi_field_size(d.resolution ? d.resolution : 16);
    unsigned char *work = malloc(size + 9);
    if (!d.parallel) d.parallel = threads;
    memset(place[at], 0x5a, sizeof place[at]);
    if (!CHECK(work, "no memory")) return f;
    memset(work, 0x5a, size + 9);
    T_OK(ssgi_field_bake, &f, place[at], work + 1, size, &d, m->position, 3 * sizeof(float), NULL, m->triangles);
    CHECK(work[size + 1] == 0x5a && work[0] == 0x5a && place[at][used / 4] == 0x5a5a5a5au,
          "memory behind the requested texels was written");
    free(work);
    return f;
}

/* Room for a small field's bytes, and for the work of baking one of few triangles. */
enum { FILE_ROOM = 8192 };
static unsigned char work[1 << 20];

/* Saves a field as bytes. Equal fields have equal bytes. */
static size_t bytes_of(unsigned char out[FILE_ROOM], const ssgi_field *f)
{
    const size_t size = ssgi_field_save(NULL, 0, f);
    CHECK(size && size <= FILE_ROOM && ssgi_field_save(out, size, f) == size, "%zu bytes were not written", size);
    return size;
}

static int same(const ssgi_field *a, const ssgi_field *b)
{
    static unsigned char x[FILE_ROOM], y[FILE_ROOM];
    const size_t n = bytes_of(x, a);
    return n == bytes_of(y, b) && !memcmp(x, y, n);
}

typedef struct cap { float solid_angle, axis[3], fill, hulls; } cap;

static cap cap_at(const ssgi_field *f, const float p[3])
{
    cap c;
    c.hulls = ssgi_field_cap(&c.solid_angle, c.axis, &c.fill, f, p);
    return c;
}

static double occluded(const ssgi_field *f, const ssgi_field_limits *limits, const float p[3], const double n[3])
{
    return (double)ssgi_field_occlusion(f, limits, p, point_at(NULL, 1, n));
}

/* Occlusion without a ramp. */
static double seen(const ssgi_field *f, const float p[3], const double n[3])
{
    return occluded(f, &(ssgi_field_limits){ 0.9999f * f->reach, f->reach, f->inside, 1 }, p, n);
}

/* Returns the largest difference between two fields' occlusion around the hull and the reach. */
static double apart(const ssgi_field *a, const ssgi_field *b)
{
    double most = 0, w[3], n[3];
    for (int i = 0; i < 4000; ++i) {
        const double r = (double)a->radius * exp(t_within(-1, 2));
        direction(w);
        direction(n);
        most = fmax(most, fabs(seen(a, point_at(a->centre, r, w), n) - seen(b, point_at(b->centre, r, w), n)));
    }
    return most;
}

/* ---- samples ----------------------------------------------------------------------------------------------------- */

typedef struct counted { const ssgi_trace *trace; float axis[3], cosine; int rays, outside; } counted;

static int count_hit(void *user, const float o[3], const float d[3])
{
    counted *c = (counted *)user;
    const float along = d[0] * c->axis[0] + d[1] * c->axis[1] + d[2] * c->axis[2],
                length = d[0] * d[0] + d[1] * d[1] + d[2] * d[2];
    ++c->rays;
    c->outside += along < c->cosine - 1e-6f || fabsf(length - 1) > 1e-5f;
    return ssgi_trace_any(c->trace, o, d, 0, 1e30f);
}

static void sampled(void)
{
    static const struct { double w[3], r; } rows[] = { { { 1, 0, 0 }, 1.4 }, { { 1, 0, 0 }, 7 },
                                                       { { 1, 1, 0 }, 2.2 }, { { 1, 1, 1 }, 3.2 },
                                                       { { 6, 3, 2 }, 1.4 }, { { 9, 1, 7 }, 2.7 } };
    ssgi_trace trace;
    double worst = 0, bias = 0;
    if (!traced_by(&trace, box_mesh(cube))) return;
    for (int i = 0; i < ROWS(rows); ++i) {
        double w[3], p[3], exact[4], mean[4] = { 0 }, out[4], again[4], axis[3];
        float cosine = 1;
        memcpy(w, rows[i].w, sizeof w);
        ssgi__normalise(w);
        for (int k = 0; k < 3; ++k) { p[k] = rows[i].r * w[k]; axis[k] = -w[k]; }
        box_exact(exact, cube, p);
        for (int k = 0; k < 8; ++k) {
            double d[3] = { (k & 1 ? 1 : -1) - p[0], (k & 2 ? 1 : -1) - p[1], (k & 4 ? 1 : -1) - p[2] };
            ssgi__normalise(d);
            cosine = fminf(cosine, (float)-kit_dot(d, w));
        }
        for (uint32_t seed = 0; seed < 16; ++seed) {
            ssgi__field_sample(out, NULL, NULL, &trace, NULL, NULL, point_at(NULL, rows[i].r, w), axis, cosine, 4096,
                               seed);
            for (int k = 0; k < 4; ++k) {
                mean[k] += out[k] / 16;
                worst = fmax(worst, fabs(out[k] - exact[k]) / exact[0]);
            }
        }
        for (int k = 0; k < 4; ++k) bias = fmax(bias, fabs(mean[k] - exact[k]) / exact[0]);
        counted c = { &trace, { (float)axis[0], (float)axis[1], (float)axis[2] }, cosine, 0, 0 };
        ssgi__field_sample(again, NULL, NULL, NULL, count_hit, &c, point_at(NULL, rows[i].r, w), axis, cosine, 4096,
                           15);
        CHECK(c.rays == 4096 && !c.outside && !memcmp(out, again, sizeof out),
              "row %d: %d rays, %d of them not in the cone", i, c.rays, c.outside);
    }
    SHOW(worst < 0.006 && bias < 0.001,
         "a cube by 4096 rays: off by up to %.5f of its solid angle, the mean of 16 by %.5f", worst, bias);
}

/* ---- bakes ------------------------------------------------------------------------------------------------------- */

static int ascending(const void *a, const void *b)
{
    return (*(const double *)a > *(const double *)b) - (*(const double *)a < *(const double *)b);
}

static void reported_errors(void)
{
    enum { RECEIVERS = 1000 };
    static double error[RECEIVERS];
    const kit_mesh *m = table_mesh();
    ssgi_trace trace;
    if (!traced_by(&trace, m)) return;
    const ssgi_field_desc d = { .resolution = 8, .radii = 8, .rays = 64 };
    const ssgi_field f = baked(0, &d, m);
    for (int i = 0; i < RECEIVERS; ++i) {
        double w[3], n[3];
        float visible = 0;
        direction(w);
        direction(n);
        if (kit_dot(n, w) > 0.5) for (int k = 0; k < 3; ++k) n[k] = -n[k];
        const double hull = (double)(f.radius / cap_at(&f, point_at(f.centre, (double)f.radius, w)).hulls),
                     r = hull * pow((double)f.reach / hull, t_within(0, 1));
        const float *p = point_at(f.centre, r, w);
        ssgi_trace_visibility(&visible, &trace, p, point_at(NULL, 1, n), 1, 0, 1024, 1, NULL);
        error[i] = fabs(seen(&f, p, n) - 1 + (double)visible);
    }
    qsort(error, RECEIVERS, sizeof *error, ascending);
    const double median = error[RECEIVERS / 2], p95 = error[RECEIVERS * 19 / 20];
    CHECK(fabs(median - (double)f.median) < 0.004 && fabs(p95 - (double)f.p95) < 0.2 * p95 + 0.005,
          "median %.4f, 95 %% within %.4f; reported are %.4f, %.4f", median, p95, (double)f.median, (double)f.p95);
    CHECK(f.median <= f.p95 && f.p95 <= f.max_error && f.p95 < 0.15f, "reported: %g %g %g", (double)f.median,
          (double)f.p95, (double)f.max_error);
    t_note("a table: error %.3f in the middle, 95 %% within %.3f, most %.3f (own rays: %.3f, %.3f)", (double)f.median,
           (double)f.p95, (double)f.max_error, median, p95);
}

static void same_bytes(void)
{
    static const double radii[2] = { 1, 0.4 };
    static float wide[5 * 3 * 256];
    uint32_t index[3 * 256];
    shape.scene.mesh.triangles = 0;
    kit_patch(&shape, 16, 8, kit_torus_surface, radii);
    const kit_mesh torus = shape.scene.mesh;
    ssgi_field_desc d = { .resolution = 4, .radii = 4, .rays = 16 };
    const ssgi_field several = baked(0, &d, &torus);
    d.parallel = backwards;
    const ssgi_field reversed = baked(1, &d, &torus);
    CHECK(same(&several, &reversed), "the order of jobs changes the field");
    d.parallel = NULL;
    const size_t corners = 3 * torus.triangles;
    ssgi_field f = several;
    /* corners in reverse order, five floats each, and an index that undoes this */
    for (size_t i = 0; i < corners; ++i) {
        memcpy(wide + 5 * i, torus.position + 3 * (corners - 1 - i), 3 * sizeof(float));
        index[i] = (uint32_t)(corners - 1 - i);
    }
    T_OK(ssgi_field_bake, &f, place[3], work, sizeof work, &d, wide, 5 * sizeof(float), index, torus.triangles);
    CHECK(same(&several, &f), "one thread, an index and a stride change the field");
    /* a triangle that is not finite, among the others */
    for (int i = 0; i < 9; ++i) wide[i] = i == 4 ? NAN : 3e12f;
    memcpy(wide + 9, torus.position, 9 * torus.triangles * sizeof(float));
    f = baked(3, &d, &(kit_mesh){ .triangles = torus.triangles + 1, .position = wide });
    CHECK(apart(&several, &f) < 1e-3, "a triangle that is not finite changes the field by %g",
          apart(&several, &f));
}

/* Samples made for a bake. half: of a box; NULL: of the unit ball, of which a share `filled` occludes. */
typedef struct rasters {
    const double *half;
    double filled;
    int unit, broken;                      /* unit: directions as in the paper; broken: not finite from there on */
    float reach;
    _Atomic int calls, wrong;              /* of several threads */
} rasters;

static void rasterised(void *user, float *out, const float *point, int count)
{
    rasters *s = (rasters *)user;
    double before = 0;
    ++s->calls;
    for (int i = 0; i < count; ++i) {
        double p[3], exact[4] = { 0 };
        for (int k = 0; k < 3; ++k) p[k] = (double)point[3 * i + k];
        const double r = sqrt(kit_dot(p, p));
        s->wrong += r <= before;
        for (int k = 0, in = 0; k < 3 && s->half; ++k) s->wrong += (in += fabs(p[k]) <= s->half[k]) == 3;
        before = r;
        if (s->half) box_exact(exact, s->half, p);
        else {
            const double sine = fmin(1 / r, 1);        /* the mesh is a bit smaller */
            exact[0] = 2 * PI * (1 - sqrt(1 - sine * sine));
            for (int k = 0; k < 3; ++k) exact[1 + k] = -PI * sine * sine * p[k] / r;
        }
        for (int k = 1; k < 4; ++k) exact[k] /= exact[0];
        if (s->unit) ssgi__normalise(exact + 1);
        exact[0] *= s->half ? 1 : s->filled;
        for (int k = 0; k < 4; ++k) out[4 * i + k] = s->broken > k ? i % 2 ? NAN : INFINITY : (float)exact[k];
    }
    s->wrong += fabs(before / (double)s->reach - 1) > 0.01;
}

/* Checks that a bake by one's own samples, and asked for few rays, equals one of many rays. */
static void own_samples(void)
{
    const double half[3] = { 1, 0.5, 0.25 }, up[3] = { 0, 0, 1 };
    rasters of = { .half = half };
    ssgi_field_desc d = { .resolution = 4, .radii = 6, .rays = 1024, .reach = 4 };
    const ssgi_field traced_field = baked(0, &d, box_mesh(half));
    of.reach = traced_field.reach;
    d.sample = rasterised;
    d.user = &of;
    const ssgi_field exact = baked(1, &d, box_mesh(half));
    const double off = apart(&traced_field, &exact);
    SHOW(off < 0.02 && fabsf(exact.p95 - traced_field.p95) < 0.005f && exact.inside == traced_field.inside,
         "a box by exact samples: off by %.4f, errors %.4f and %.4f", off, (double)exact.p95, (double)traced_field.p95);
    CHECK(of.calls == 24 * 16 && !of.wrong, "%d directions, %d points where they should not be", of.calls, of.wrong);
    for (int broken = 1; broken < 5; ++broken) {
        rasters none = { .half = half, .broken = broken };
        d = (ssgi_field_desc){ .resolution = 2, .radii = 4, .rays = 16, .sample = rasterised, .user = &none };
        const ssgi_field f = baked(2, &d, box_mesh(half));
        CHECK(seen(&f, point_at(NULL, 1.5, up), up) < 1e-4, "an infinite value occludes by %g",
              seen(&f, point_at(NULL, 1.5, up), up));
    }
}

/* Checks the one closed form: a ball that rests on a plane occludes 1/(1 + rho^2)^1.5 of it. By rays, and by a ball
   that lets half of them through; by samples with lengths, and with unit directions as in the paper; by samples of a
   ball that is half holes. */
static void ball_on_plane(void)
{
    static const struct { const char *name; int (*hit)(void *, const float *, const float *); rasters of; double most;
    } rows[] = { { "by rays", ball_hit, { .filled = 1 }, 0.012 },
                 { "by half of the rays", porous_hit, { .filled = 0.5 }, 0.025 },
                 { "by samples", NULL, { .filled = 1 }, 0.006 },
                 { "by unit directions", NULL, { .filled = 1, .unit = 1 }, 0.006 },
                 { "half of it", NULL, { .filled = 0.5 }, 0.006 } };
    const double up[3] = { 0, 1, 0 };
    double radius = 1;
    for (int n = 0; n < ROWS(rows); ++n) {
        rasters of = rows[n].of;
        ssgi_field_desc d = { .resolution = 4, .rays = 16, .sample = rasterised, .user = &of };
        if (rows[n].hit) d = (ssgi_field_desc){ .resolution = 8, .rays = 256, .hit = rows[n].hit, .user = &radius };
        const ssgi_field f = baked(0, &d, ball_mesh());
        const double height = rows[n].hit ? 1 : 1.001;
        double worst = 0;
        for (int i = 0; i <= 600; ++i) {
            const double rho = i * 0.01, a = 2.4 * i, p[3] = { rho * cos(a), -height, rho * sin(a) },
                         exact = of.filled * pow(height * height + rho * rho, -1.5) * height;
            worst = fmax(worst, fabs(seen(&f, point_at(NULL, 1, p), up) - exact));
        }
        SHOW(worst < rows[n].most, "a ball on a plane, %s: occlusion off by up to %.4f", rows[n].name, worst);
    }
}

/* Checks that an unfiltered texel is the fit of its own direction, so that a bake has a quarter of the directions. */
static void unfiltered(void)
{
    double error[2] = { 0, 0 };
    for (int n = 0; n < 2; ++n) {
        rasters of = { .half = cube };
        const ssgi_field_desc d = { .resolution = 6, .radii = 8, .rays = 16, .unfiltered = n, .sample = rasterised,
                                    .user = &of };
        const ssgi_field f = baked(n, &d, box_mesh(cube));
        CHECK(of.calls == (n ? 6 : 24) * 36, "%d: %d directions", n, of.calls);
        for (int i = 0; i < 6 * 36; ++i) {
            double w[3], q[3], radii[8], values[8], exact[4], p[3];
            ssgi__cube_direction(w, i / 36, (2 * (i % 6) + 1.0) / 6 - 1, (2 * (i / 6 % 6) + 1.0) / 6 - 1);
            const double hull = 1.0002 / fmax(fabs(w[0]), fmax(fabs(w[1]), fabs(w[2]))), reach = (double)f.reach;
            for (int j = 0; j < 8; ++j) {
                radii[j] = hull * pow(reach / hull, j / 7.0);
                for (int k = 0; k < 3; ++k) p[k] = radii[j] * w[k];
                box_exact(exact, cube, p);
                values[j] = ssgi__normalise(exact + 1);
            }
            ssgi__field_fit(q, radii, values, 8, PI);
            const cap c = cap_at(&f, point_at(NULL, 1.8, w));
            const double h = (double)c.solid_angle / (2 * PI), one = 1 / quadratic(q, (1.8 - hull) / (reach - hull));
            error[n] = fmax(error[n], fabs((double)c.fill * PI * h * (2 - h) - one) / PI);
        }
    }
    SHOW(error[1] < 0.5 * error[0], "directions of texels: off by %.4f, filtered %.4f", error[1], error[0]);
}

/* The centres of three fine texels, of 16 a side on the cube: two within faces, one beside an edge. */
static const double impulses[3][3] = { { 1, 0.0625, -0.4375 }, { 0.3125, -1, 0.1875 }, { 0.9375, -0.1875, 1 } };

/* Makes samples that in the directions of these texels leave most of the cap open; those of others fill it. */
static void impulse(void *user, float *out, const float *point, int count)
{
    for (int i = 0; i < count; ++i, point += 3, out += 4) {
        const double p[3] = { (double)point[0], (double)point[1], (double)point[2] },
                     most = fmax(fmax(fabs(p[0]), fabs(p[1])), fabs(p[2])), length = sqrt(kit_dot(p, p));
        int here = 0;
        for (int n = 0; n < 3; ++n) {
            double off = 0;
            for (int k = 0; k < 3; ++k) off = fmax(off, fabs(p[k] / most - impulses[n][k]));
            here |= off < 0.04;
        }
        out[0] = *(const float *)user;
        for (int k = 0; k < 3; ++k) out[1 + k] = (float)(-p[k] / length * (here ? 0.25 : 1));
    }
}

/* Checks that a texel is the mean of 4x4 fine ones by a Gaussian with a deviation of one fine texel. A single differing
   fine texel counts by the bell's values at half and at one and a half fine texels, across edges as within faces. */
static void filtered(void)
{
    static float solid_angle = 0.2f;
    const double open = 1 - 0.25 * (double)solid_angle / PI, sum = 2 * (exp(-0.125) + exp(-1.125)),
                 bell[3] = { exp(-0.125) / sum, exp(-1.125) / sum, 0 };
    const ssgi_field_desc d = { .resolution = 8, .radii = 4, .rays = 16, .hit = nothing_hit, .sample = impulse,
                                .user = &solid_angle };
    const ssgi_field f = baked(0, &d, box_mesh(cube));
    double worst = 0;
    for (int i = 0; i < 6 * 64; ++i) {
        const int a = i / 64 % 3;
        double p[3], want = 1;
        p[a] = i / 64 < 3 ? 1 : -1;
        p[(a + 1) % 3] = (i % 8 - 3.5) / 4;
        p[(a + 2) % 3] = (i / 8 % 8 - 3.5) / 4;
        for (int n = 0; n < 3; ++n) {
            const double *q = impulses[n];
            const int b = fabs(q[0]) == 1 ? 0 : fabs(q[1]) == 1 ? 1 : 2;
            double weight = a == b && p[a] != q[a] ? 0 : open;
            for (int k = 0; k < 3; ++k) { /* unfolds a neighbouring face into the plane of this one */
                const double at = k == a ? p[a] * (2 - p[b] * q[b]) : p[k];
                if (k != b) weight *= bell[(int)fmin(2, fabs(at - q[k]) * 8)];
            }
            want -= weight;
        }
        worst = fmax(worst, fabs((double)cap_at(&f, point_at(f.centre, 1.5, p)).fill - want));
    }
    CHECK(worst < 0.51 / 255 * (double)f.span[7] && fabs((double)f.span[7] / (open * bell[0] * bell[0]) - 1) < 1e-4,
          "off by %g, of which storing takes %g; at most %g of an impulse, not %g", worst,
          0.5 / 255 * (double)f.span[7], (double)f.span[7] / open, bell[0] * bell[0]);
}

typedef struct told { int calls, most, descends; float last; } told;

static int keep(void *user, float done)
{
    told *l = (told *)user;
    l->descends += !(done >= l->last && done <= 1);
    l->last = done;
    return ++l->calls == l->most;
}

static void progress(void)
{
    told l = { .most = -1 };
    ssgi_field_desc d = { .resolution = 4, .radii = 4, .rays = 16, .progress = keep, .user = &l };
    const kit_mesh *m = box_mesh(cube);
    ssgi_field f, was;
    memset(&was, 0x5a, sizeof was);
    f = was;
    baked(0, &d, m);
    CHECK(l.calls > 10 && !l.descends && l.last >= 1, "%d calls, %d descend, the last is %g", l.calls, l.descends,
          (double)l.last);
    for (int most = 1; most < l.calls; most += 1 + l.calls / 4) {
        told stop = { .most = most };
        d.user = &stop;
        T_REFUSED(ssgi_field_bake(&f, place[0], work, sizeof work, &d, m->position, 12, NULL, m->triangles, &why),
                  SSGI_CANCELLED, "desc.progress:", f, was);
        CHECK(stop.calls == most, "given up at call %d: %d calls", most, stop.calls);
    }
}

static void bad_arguments(void)
{
    static const struct { const char *says; ssgi_field_desc d;
    } wrong[] = { { "desc.resolution:", { .resolution = 1 } },  { "desc.resolution:", { .resolution = 129 } },
                  { "desc.resolution:", { .resolution = -4 } }, { "desc.radii:", { .radii = 3 } },
                  { "desc.radii:", { .radii = 65 } },           { "desc.rays:", { .rays = 15 } },
                  { "desc.rays:", { .rays = 65537 } },          { "desc.reach:", { .reach = 1.4f } },
                  { "desc.reach:", { .reach = 65 } },           { "desc.reach:", { .reach = -8 } },
                  { "desc.reach:", { .reach = NAN } },          { "desc.reach:", { .reach = INFINITY } },
                  { "desc.unfiltered:", { .unfiltered = 2 } },  { "desc.unfiltered:", { .unfiltered = -1 } } };
    const ssgi_field_desc good = { .resolution = 2, .radii = 4, .rays = 16 };
    const kit_mesh *m = box_mesh(cube);
    const float *p = m->position;
    const size_t n = m->triangles, size = ssgi_field_bake_size(&good, n), most = (size_t)SSGI_TRACE_MAX_TRIANGLES + 1;
    ssgi_field f, was;
    /* a line, nowhere and a point */
    static const float flat[3][9] = { { 1, 1, 1, 2, 2, 2, 4, 4, 4 }, { 2e12f, 0, 0, NAN, 0, 0, 2e12f, 0, 0 },
                                      { 1, 1, 1, 1, 1, 1, 1, 1, 1 } };
    memset(&was, 0x5a, sizeof was);
    f = was;
#define REFUSED(result, name, room, desc, at, count) \
    T_REFUSED(ssgi_field_bake(&f, place[0], work, room, desc, at, 12, NULL, count, &why), result, name, f, was)
    for (int i = 0; i < ROWS(wrong); ++i) {
        REFUSED(SSGI_BAD_ARGUMENT, wrong[i].says, size, &wrong[i].d, p, n);
        CHECK(!ssgi_field_bake_size(&wrong[i].d, n), "row %d has a size", i);
    }
    for (int i = 0; i < 3; ++i) REFUSED(SSGI_BAD_ARGUMENT, "position:", size, &good, flat[i], 1);
    REFUSED(SSGI_TOO_SMALL, "work_size:", size - 1, &good, p, n);
#undef REFUSED
    CHECK(!ssgi_field_bake_size(NULL, 1) && !ssgi_field_bake_size(&good, 0) && !ssgi_field_bake_size(&good, most)
              && !ssgi_field_size(1) && !ssgi_field_size(129) && ssgi_field_size(16) == 6 * 18 * 18 * 8,
          "16 x 16 texels take %zu bytes, or an impossible field has a size", ssgi_field_size(16));
}

/* Returns whether occlusion is in [0,1] around and in the hull, beyond the reach and at the centre. */
static int sane(const ssgi_field *f)
{
    int ok = isfinite(f->p95) && f->p95 >= 0 && f->p95 <= 1 && f->inside >= 0 && f->inside <= 1;
    for (int i = 0; i < 300; ++i) {
        double w[3], n[3];
        direction(w);
        direction(n);
        const float *p = point_at(f->centre, i ? (double)f->radius * exp(t_within(-3, 3)) : 0, w);
        const double a = occluded(f, NULL, p, n);
        ok &= a >= 0 && a <= 1;
    }
    return ok;
}

static void degenerate(void)
{
    static const struct {
        const char *name;
        float half[3], position[9];        /* half sides of a box, or corners of a triangle */
        int far_away, scaled;              /* far_away: occludes there; scaled: bytes stay equal */
    } rows[] = { { "a triangle", { 0 }, { 0, 0, 0, 1, 0, 0, 0.3f, 1, 0.2f }, 1, 1 },
                 { "a needle", { 0 }, { -1, 0, 0, 1, 0, 0, 1, 1e-4f, 0 }, 0, 1 },
                 { "a flat box", { 1, 0.7f, 0 }, { 0 }, 1, 0 },
                 { "a cube", { 1, 1, 1 }, { 0 }, 1, 1 } };
    const ssgi_field_desc d = { .resolution = 4, .radii = 4, .rays = 16 };
    for (int c = 0; c < ROWS(rows); ++c) {
        const double half[3] = { (double)rows[c].half[0], (double)rows[c].half[1], (double)rows[c].half[2] };
        float corners[9 * 12], moved[9 * 12];
        kit_mesh m = { .triangles = 1, .position = corners };
        memcpy(corners, rows[c].position, sizeof rows[c].position);
        if (half[0] > 0) {
            m.triangles = box_mesh(half)->triangles;
            memcpy(corners, shape.scene.mesh.position, 9 * m.triangles * sizeof *corners);
        }
        const ssgi_field plain = baked(0, &d, &m);
        CHECK(sane(&plain), "%s: not in [0,1]", rows[c].name);
        m.position = moved;
        for (int k = 0; k < 3; ++k) {
            const float scale = k == 0 ? ldexpf(1, -13) : k == 1 ? ldexpf(1, 17) : 1, far_away = k == 2 ? 1e5f : 0;
            if (!(k == 2 ? rows[c].far_away : rows[c].scaled)) continue;
            for (size_t i = 0; i < 9 * m.triangles; ++i) moved[i] = corners[i] * scale + far_away;
            const ssgi_field f = baked(1, &d, &m);
            CHECK(sane(&f), "%s, scaled by %g, %g away: not in [0,1]", rows[c].name, (double)scale, (double)far_away);
            CHECK(k == 2 || (!memcmp(place[0], place[1], ssgi_field_size(4)) && plain.p95 == f.p95
                             && plain.inside == f.inside && f.radius == plain.radius * scale),
                  "%s, scaled by %g, is another field", rows[c].name, (double)scale);
            CHECK(k < 2 || c < 3 || apart(&plain, &f) < 0.1, "%s, %g away: off by %g", rows[c].name,
                  (double)far_away, apart(&plain, &f));
        }
    }
}

static void hulls(void)
{
    const ssgi_field_desc d = { .resolution = 24, .radii = 4, .rays = 16, .hit = nothing_hit };
    for (int i = 0; i < 2; ++i) {
        const float middle[3] = { 0, 0, 0 };
        const kit_mesh *m = i ? box_mesh(cube) : ball_mesh();
        const ssgi_field f = baked(0, &d, m);
        const double dark = seen(&f, point_at(f.centre, 2, cube), cube);
        double worst = 0, creases = 0;
        ssgi_trace trace;
        if (!traced_by(&trace, m)) return;
        for (int k = 0; k < 4000; ++k) {
            double w[3], x[3];
            ssgi_hit hit = { .t = 0 };
            direction(w);
            ssgi_trace_closest(&hit, &trace, middle, point_at(NULL, 1, w), 0, 9);
            const double exact = (double)hit.t,
                         distance = (double)cap_at(&f, point_at(NULL, exact, w)).hulls,
                         off = exact / (double)f.radius * fabs(1 / distance - 1);
            for (int n = 0; n < 3; ++n) x[n] = fabs(w[n]);
            /* the two largest components are near each other at an edge of the cube */
            const double largest = fmax(x[0], fmax(x[1], x[2])),
                         next = fmax(fmin(x[0], x[1]), fmin(fmax(x[0], x[1]), x[2]));
            if (i && next > 0.9 * largest) creases = fmax(creases, off);
            else worst = fmax(worst, off);
        }
        CHECK(dark < 1e-4, "rays that hit nothing: occlusion %g", dark);
        SHOW(worst < 0.0037 && creases < 0.034, "%s's hull: off by up to %.5f radii, %.5f near its edges",
             i ? "a cube" : "a ball", worst, creases);
    }
}

/* Checks that a bake shoots rays into a cone about a few directions that holds all of the mesh, also parts between
   those directions, as of small random triangles near the unit sphere. */
static void cones(void)
{
    static float cloud[9 * 400];
    const kit_mesh of_cloud = { .triangles = 400, .position = cloud };
    double widest = 0;
    int wide = 0, all = 0;
    for (int k = 0; k < 12; ++k) {
        const kit_mesh *m = k == 0 ? ball_mesh() : k == 1 ? box_mesh(cube) : table_mesh();
        double w[3], length = 0;
        for (int i = 0; i < 9 * 400 && k > 2; ++i) {
            if (i % 9 == 0) {
                direction(w);
                length = t_within(0.85, 1);
            }
            cloud[i] = (float)(length * w[i % 3] + t_within(-0.03, 0.03));
        }
        if (k > 2) m = &of_cloud;
        ssgi__field_occluder o = { .radius = 0 };
        if (!traced_by(&o.trace, m) || !CHECK(ssgi__field_measure(&o), "mesh %d", k)) return;
        for (int i = 0; i < 300; ++i) {
            double at[3], axis[3], least = 1;
            ssgi__field_portal portal;
            direction(w);
            const double hull = ssgi__field_exit(&o, w, &portal) + ssgi__field_slack(&o);
            for (int c = 0; c < 3; ++c) at[c] = w[c] * hull * (1 + (i % 4) * t_within(0, 3));
            const double cosine = (double)ssgi__field_cone(axis, &o, at, portal.normal);
            for (size_t t = 0; t < 3 * m->triangles; ++t) {
                double d[3];
                for (int c = 0; c < 3; ++c) d[c] = (double)m->position[3 * t + (size_t)c] - o.centre[c] - at[c];
                ssgi__normalise(d);
                least = fmin(least, kit_dot(d, axis));
            }
            CHECK(least >= cosine - 1e-5, "mesh %d: %.2f degrees outside of the cone", k,
                  (acos(least) - acos(cosine)) * 180 / PI);
            wide += !(cosine > 0);
            ++all;
            if (k < 3 && cosine > 0) widest = fmax(widest, acos(cosine) - acos(least));
        }
    }
    SHOW(wide < all / 2 && widest < 0.5,
         "%d of %d cones are half spaces, those of a ball, a cube and a table wider by up to %.2f", wide, all, widest);
}

/* The points in the cube from which a bake looks, and how many of their rays hit. */
typedef struct looks { int points, rays[256], hits[256]; float from[256][3]; } looks;

/* Tests rays for a bake: low directions hit, as many as the point's share of the way out. Near the centre all hit. */
static int low_hit(void *user, const float o[3], const float d[3])
{
    looks *l = (looks *)user;
    const float r = fmaxf(fmaxf(fabsf(o[0]), fabsf(o[1])), fabsf(o[2]));
    const int hit = r < 0.3f || d[2] < 2 * r - 1, last = l->points - 1;
    if (r >= 1 || (last == 255 && memcmp(l->from[last], o, sizeof l->from[0]))) return 0;
    if (last < 0 || memcmp(l->from[last], o, sizeof l->from[0])) memcpy(l->from[l->points++], o, sizeof l->from[0]);
    ++l->rays[l->points - 1];
    l->hits[l->points - 1] += hit;
    return hit;
}

/* A_0 of a cube that occludes a point at a share r of the way out by r; below 0.3 and above 0.95 it encloses the point.
   A point counts by 1 - r, its weight of A_0. So A_0 is this mean over the bake's points; and it is the ratio of the
   integrals of r (1 - r) and 1 - r, from which that of 256 points deviates by 0.013. */
static void toward_the_centre(void)
{
    static looks l;
    const ssgi_field_desc d = { .resolution = 2, .radii = 4, .rays = 16, .hit = low_hit, .user = &l };
    const ssgi_field f = baked(0, &d, box_mesh(cube));
    const double even = (pow(0.95, 2) - pow(0.3, 2)) / 2,
                 closed = (even - (pow(0.95, 3) - pow(0.3, 3)) / 3) / (0.65 - even);
    double sum = 0, weight = 0;
    for (int i = 0; i < l.points; ++i) {
        const double share = (double)l.hits[i] / l.rays[i];
        double r = 0;
        for (int k = 0; k < 3; ++k) {
            const double way = (double)l.from[i][k] - (double)f.centre[k];
            r = fmax(r, way / ((way > 0 ? 1 : -1) - (double)f.centre[k]));
        }
        if (share > 0.95) continue;
        sum += share * (1 - r);
        weight += 1 - r;
    }
    SHOW(l.points == 256 && fabs((double)f.inside - sum / weight) < 1e-5 && fabs((double)f.inside - closed) < 0.03,
         "%.6f; of its %d points %.6f; by the integrals %.3f", (double)f.inside, l.points, sum / weight, closed);
}

/* Tests rays for a bake without an occluder, so that texels are unlike their neighbours. */
static int wild_hit(void *user, const float o[3], const float d[3])
{
    const double p[3] = { (double)o[0], (double)o[1], (double)o[2] }, r = sqrt(kit_dot(p, p));
    const double chance = sin(7 * p[0] / r + 1) * sin(6 * p[1] / r + 2) * sin(5 * p[2] / r + 3) + 0.3 * sin(r);
    (void)user;
    return sin(40 * (double)d[0] + 30 * (double)d[1] + 20 * (double)d[2]) < 1.5 * chance;
}

static void borders(void)
{
    double half[3] = { 1, 0.5, 0.25 };
    const ssgi_field_desc d = { .resolution = 5, .radii = 6, .rays = 64, .hit = wild_hit };
    const ssgi_field f = baked(0, &d, box_mesh(half));
    double step = 0, lower = 1, upper = 0;
    for (int i = 0; i < 6000; ++i) {                     /* across an edge; one in four near a corner */
        const int a = i % 3, b = (a + 1) % 3;
        const double sa = i & 8 ? 1 : -1, sb = i & 16 ? 1 : -1,
                     along = i % 4 ? t_within(-1, 1) : (i & 32 ? 1 : -1) * t_within(0.999, 1.0005),
                     r = (double)f.radius * exp(t_within(0, 2));
        double w[2][3], n[3], o[2];
        cap c[2];
        direction(n);
        for (int k = 0; k < 2; ++k) {
            w[k][a] = sa * (k ? 1 + 5e-5 : 1 - 5e-5);
            w[k][b] = sb * (k ? 1 - 5e-5 : 1 + 5e-5);
            w[k][(a + 2) % 3] = along;
            ssgi__normalise(w[k]);
            o[k] = seen(&f, point_at(f.centre, r, w[k]), n);
            c[k] = cap_at(&f, point_at(f.centre, r, w[k]));
            lower = fmin(lower, o[k]);
            upper = fmax(upper, o[k]);
        }
        step = fmax(step, fabs(o[0] - o[1]));
        step = fmax(step, (double)(fabsf(c[0].solid_angle - c[1].solid_angle) / 12.6f + fabsf(c[0].fill - c[1].fill)
                                   + fabsf(c[0].hulls / c[1].hulls - 1)));
        for (int k = 0; k < 3; ++k) step = fmax(step, (double)fabsf(c[0].axis[k] - c[1].axis[k]));
    }
    SHOW(step < 1e-3 && upper - lower > 0.3, "at most %.1e across edges and corners, of a field from %.2f to %.2f",
         step, lower, upper);
}

static void limits(void)
{
    double half[3] = { 1, 0.5, 0.25 };
    const ssgi_field_desc d = { .resolution = 8, .radii = 6, .rays = 64, .hit = box_hit, .user = half };
    const ssgi_field f = baked(0, &d, box_mesh(half));
    const ssgi_field_limits of = ssgi_field_limits_of(&f), ramp = { 2, 5, 0.3f, 2 };
    CHECK(of.ramp == 0.75f * f.reach && of.reach == f.reach && of.inside == f.inside && of.power == 1
              && fabsf(f.reach - 8 * f.radius) < 1e-4f,
          "limits %g %g %g %g", (double)of.ramp, (double)of.reach, (double)of.inside, (double)of.power);
    double bent = 0, jump = 0;
    for (int i = 0; i < 500; ++i) {
        double w[3], n[3];
        direction(w);
        direction(n);
        const double hull = 1 / (double)cap_at(&f, point_at(f.centre, 1, w)).hulls;
#define AT(r) occluded(&f, &ramp, point_at(f.centre, r, w), n)
        for (int k = 1; k < 4; ++k) {                    /* from ramp to reach it falls as 1 - smoothstep */
            const double t = k / 4.0;
            bent = fmax(bent, fabs(AT(2 + 3 * t)
                                   - (1 - t * t * (3 - 2 * t)) * seen(&f, point_at(f.centre, 2 + 3 * t, w), n)));
        }
        bent = fmax(bent, fabs(AT(1.99) - seen(&f, point_at(f.centre, 1.99, w), n)) + AT(5.0001) + AT(1e6));
        bent = fmax(bent, fabs(AT(hull / 2) - (0.3 + 0.25 * (AT(hull) - 0.3))));
        jump = fmax(jump, fabs(AT(hull * 0.99999) - AT(hull * 1.00001)));
        CHECK(occluded(&f, NULL, point_at(f.centre, (double)f.reach * 1.0001, w), n) == 0,
              "beyond the reach there is occlusion");
    }
    const float up[3] = { 0, 0, 1 };
    CHECK(bent < 1e-5 && jump < 2e-3, "off by %g, a jump of %g at the hull", bent, jump);
    CHECK(fabsf(ssgi_field_occlusion(&f, &ramp, f.centre, up) - 0.3f) < 1e-6f
              && fabsf(ssgi_field_occlusion(&f, NULL, f.centre, up) - f.inside) < 1e-6f,
          "at the centre %g", (double)ssgi_field_occlusion(&f, &ramp, f.centre, up));
    const float odd[] = { NAN, INFINITY, -INFINITY, 1e38f, -3e38f, 1e-42f, 2e18f };
    for (int i = 0; i < 6 * ROWS(odd); ++i) {
        const float value = odd[i / 6];
        const int k = i % 6;
        float p[3] = { 1, 2, 0 }, normal[3] = { 0, 0, 1 };
        *(k < 3 ? &p[k] : &normal[k - 3]) = value;
        const float a = ssgi_field_occlusion(&f, NULL, p, normal);
        const cap c = cap_at(&f, p);
        CHECK(a >= 0 && a <= 1 && (isfinite(value) || a == 0), "%g in %d: occlusion %g", (double)value, k, (double)a);
        CHECK(isfinite(c.solid_angle + c.axis[0] + c.axis[1] + c.axis[2] + c.fill + c.hulls),
              "%g in %d: cap %g, axis %g %g %g, %g hulls", (double)value, k, (double)c.solid_angle, (double)c.axis[0],
              (double)c.axis[1], (double)c.axis[2], (double)c.hulls);
    }
}

/* ---- files ------------------------------------------------------------------------------------------------------- */

static void repair(unsigned char *file, size_t size)      /* writes FNV-1a of all bytes before it: the checksum */
{
    uint64_t h = 14695981039346656037u;
    for (size_t i = 0; i < size - 8; ++i) h = (h ^ file[i]) * 1099511628211u;
    for (int k = 0; k < 8; ++k) file[size - 8 + (size_t)k] = (unsigned char)(h >> 8 * k);
}

static void files(void)
{
    double half[3] = { 1, 0.5, 0.25 };
    const ssgi_field_desc d = { .resolution = 3, .radii = 6, .rays = 64, .hit = box_hit, .user = half };
    const ssgi_field f = baked(0, &d, box_mesh(half));
    ssgi_field g, was;
    static unsigned char file[FILE_ROOM], copy[FILE_ROOM + 4];
    unsigned char small[64];
    const size_t size = bytes_of(file, &f), room = ssgi_field_size(3);
    size_t bytes = 0;
    const char *text = "";
    memset(&was, 0x5a, sizeof was);
    memset(small, 0x5a, sizeof small);
    CHECK(ssgi_field_save(small, sizeof small, &f) == size && ssgi_field_save(file, 0, &f) == size && small[0] == 0x5a,
          "capacity too small: something was written");
    CHECK(ssgi_field_load(&g, NULL, 0, file, size, &text) == SSGI_OK && (bytes = ssgi_field_size(g.resolution)) == room
              && !g.texels,
          "%zu bytes of texels, not %zu: %s", bytes, room, text);
    memset(place[1], 0x5a, sizeof place[1]);
    CHECK(ssgi_field_load(&g, place[1], bytes, file, size, &text) == SSGI_OK && g.texels == place[1] && same(&f, &g)
              && !memcmp(place[0], place[1], room) && place[1][room / 4] == 0x5a5a5a5au,
          "the loaded field differs from the saved one: %s", text);
    g.texels = f.texels;
    CHECK(!memcmp(&f, &g, offsetof(ssgi_field, max_error) + sizeof g.max_error),
          "the loaded numbers differ from the saved ones");
    g = was;
#define REFUSED(name, result, ...) T_REFUSED(ssgi_field_load(__VA_ARGS__, &why), result, name, g, was)
    REFUSED("field:", SSGI_BAD_ARGUMENT, NULL, place[2], room, file, size);
    REFUSED("file:", SSGI_BAD_ARGUMENT, &g, place[2], room, NULL, size);
    REFUSED("size:", SSGI_TOO_SMALL, &g, place[2], room - 1, file, size);
    memset(place[2], 0x5a, sizeof place[2]);
    memcpy(copy, file, size);
    memset(copy + size, 0, 4);
    for (size_t n = 0; n <= size + 4; ++n)           /* cut, and too long */
        if (n != size) REFUSED("file:", SSGI_BAD_ARGUMENT, &g, place[2], sizeof place[2], copy, n);
    CHECK(ssgi_field_load(&g, NULL, 0, file, size - 1, NULL) == SSGI_BAD_ARGUMENT, "a file that is cut has a head");
    repair(copy, size + 4);
    REFUSED("file:", SSGI_BAD_ARGUMENT, &g, place[2], sizeof place[2], copy, size + 4);
    copy[7] = '1';                                   /* version 1 of the file, with 16 bits a number */
    repair(copy, size);
    REFUSED("file: is of another version", SSGI_BAD_ARGUMENT, &g, place[2], sizeof place[2], copy, size);
    copy[6] = 'X';
    repair(copy, size);
    REFUSED("file: is not an ambient occlusion field", SSGI_BAD_ARGUMENT, &g, place[2], sizeof place[2], copy, size);
    enum { RADIUS = 16 + 4 * 3, LOW = 16 + 4 * 6, SPAN = 16 + 4 * 14 };
    static const struct { const char *start; int at; float value;       /* numbers that no bake writes */
    } numbers[] = { { "file: its covered share", LOW + 4 * 7, -0.01f },
                    { "file: its covered share", LOW + 4 * 7, 1.1f },
                    { "file: its covered share", SPAN + 4 * 7, 1.1f },
                    { "file: is corrupt", LOW, 63 },                   /* a logarithm whose power of 2 is squared */
                    { "file: is corrupt", LOW + 4 * 3, 1e-30f },       /* the hull, a divisor of distances */
                    { "file: is corrupt", RADIUS, 1e-30f } };
    for (int i = 0; i < ROWS(numbers); ++i) {
        memcpy(copy, file, size);
        memcpy(copy + numbers[i].at, &numbers[i].value, 4);
        repair(copy, size);
        REFUSED(numbers[i].start, SSGI_BAD_ARGUMENT, &g, place[2], sizeof place[2], copy, size);
    }
    memcpy(copy, file, size);
    for (size_t i = 0; i < size; ++i) {              /* the checksum notices every byte */
        copy[i] ^= (unsigned char)(1 + i % 255);
        REFUSED("file:", SSGI_BAD_ARGUMENT, &g, place[2], sizeof place[2], copy, size);
        copy[i] = file[i];
    }
#undef REFUSED
    CHECK(place[2][0] == 0x5a5a5a5au && !ssgi_field_save(NULL, 0, NULL),
          "texels of a corrupt file were written, or no field has a size");
}

void test_field(void)
{
    RUN("fits reach the reference's error for cubes, slabs and a ball, and never hold more than the sphere", fits);
    RUN("centres reach the reference's error, stay put where nothing tells, and find one that is there", centres);
    RUN("samples are a cube's exact solid angle and vector irradiance, by rays in the cone only", sampled);
    RUN("the errors that a bake reports are those of receivers and rays of one's own", reported_errors);
    RUN("a field has the same bytes with one thread, several, an index and a stride", same_bytes);
    RUN("samples of one's own give the field of exact rays", own_samples);
    RUN("a ball on a plane has the closed form's contact shadow, by rays and by samples", ball_on_plane);
    RUN("unfiltered texels are what their own directions fit", unfiltered);
    RUN("texels are means by a Gaussian, a fine texel in deviation, across edges too", filtered);
    RUN("progress ascends to 1, and giving up leaves the field untouched", progress);
    RUN("bad descs, meshes and sizes are named and leave the field untouched", bad_arguments);
    RUN("triangles, needles, flat occluders, far, tiny and huge ones stay in [0,1]; scale does not matter", degenerate);
    RUN("hulls are where the mesh ends", hulls);
    RUN("cones to which rays are confined hold all of a mesh", cones);
    RUN("inside a hull points that are not enclosed count by what is left of the way to it", toward_the_centre);
    RUN("there is no seam at edges and corners", borders);
    RUN("limits: ramp, reach, inside and power; points that are not finite", limits);
    RUN("files load as they were saved; cut, long, foreign and corrupt ones are refused", files);
}
