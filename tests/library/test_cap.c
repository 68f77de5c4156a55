/* test_cap.c - ssgi.h's rooms of caps and of reflection, against closed forms. */
#include "frames.h"
#include "ssgi.h"

#include <math.h>
#include <string.h>

#define PI KIT_PI

/* ---- >>cap ------------------------------------------------------------------------------------------------------- */

static void caps(void)
{
    /* by quadrature over azimuths: caps below, across and above the horizon; the same, over half of the sphere; ends */
    static const struct { double solid_angle, cosine, occlusion;
    } rows[] = { { PI / 4, -0.75, 0 },
                 { PI / 4, -0.03125, 0.022492340305020567 },
                 { PI / 4, 0.125, 0.042777206502847248 },
                 { PI / 4, 0.875, 0.205078125 },
                 { PI / 16, 0.03125, 0.0043360642700743697 },
                 { 5 * PI / 4, -0.375, 0.12196989623960146 },
                 { 31 * PI / 16, 0.25, 0.60561821739016908 },
                 { 5 * PI / 2, -0.375, 0.47046421768861002 },
                 { 45 * PI / 16, 0.5625, 0.94551137474100155 },
                 { 15 * PI / 4, -0.0625, 0.96612634172917533 },
                 { 15 * PI / 4, -0.84375, 0.80224609375 },
                 { 0, 1, 0 },
                 { 4 * PI, -1, 1 },
                 { -1, 0.5, 0 },
                 { 13, -0.5, 1 },
                 { PI / 4, 1.5, 0.234375 },
                 { PI / 4, -1.5, 0 } }; /* arguments beyond the ends */
    double worst = 0;
    for (int i = 0; i < ROWS(rows); ++i)
        grow(&worst, ssgi_cap_occlusion(rows[i].solid_angle, rows[i].cosine) - rows[i].occlusion);
    CHECK(worst < 1e-12, "off by %g", worst);
    const double no[] = { NAN, INFINITY, -INFINITY };
    for (int i = 0; i < 3; ++i)
        CHECK(ssgi_cap_occlusion(no[i], 1) == 0 && ssgi_cap_occlusion(PI, no[i]) == ssgi_cap_occlusion(PI, 0),
              "infinite or NaN values: %g, %g", ssgi_cap_occlusion(no[i], 1), ssgi_cap_occlusion(PI, no[i]));
    double before[81] = { 0 };
    for (int i = 0; i <= 160; ++i)
        for (int j = 0; j <= 80; ++j) {
            const double o = 4 * PI * i / 160, c = j / 40.0 - 1, a = ssgi_cap_occlusion(o, c),
                         left = 1 - ssgi_cap_occlusion(4 * PI - o, -c);
            CHECK(fabs(a - left) < 1e-6, "%g sr, cosine %g: %.9g, by the complement %.9g", o, c, a, left);
            CHECK(a >= before[j] - 1e-6 && (!j || a >= before[j - 1] - 1e-6), "%g sr, cosine %g: not monotone", o, c);
            if (i == 80) CHECK(fabs(a - 0.5 - 0.5 * c) < 1e-6, "half of the sphere, cosine %g: %.9g", c, a);
            before[j] = a;
        }
}

/* Returns a value of a table at fractional places, as the header describes it. */
static double looked_up(const float *table, int size, double solid_angle, double cosine)
{
    const double u = (solid_angle / (4 * PI) * (size - 1) + 0.5) / size,
                 v = ((cosine + 1) / 2 * (size - 1) + 0.5) / size, x = u * size - 0.5, y = v * size - 0.5;
    const int i = (int)fmin(x, size - 2), j = (int)fmin(y, size - 2);
    const float *at = table + j * size + i;
    const double low = (double)at[0] + (x - i) * (double)(at[1] - at[0]),
                 high = (double)at[size] + (x - i) * (double)(at[size + 1] - at[size]);
    return low + (y - j) * (high - low);
}

static void cap_tables(void)
{
    static const struct { int size; double most, rms;
    } sizes[] = { { 32, 2.9e-3, 3.8e-4 }, { 64, 1.4e-3, 1e-4 }, { 128, 6.6e-4, 2.8e-5 } };
    static float table[128 * 128];
    T_OK(ssgi_cap_table, table, 65);
    for (int i = 0; i < 65 * 65; ++i) {
        const double is = (double)table[i], exact = ssgi_cap_occlusion(4 * PI * (i % 65) / 64, i / 65 / 32.0 - 1);
        CHECK(fabs(is - exact) < 1e-7, "texel %d, %d: %.9g, not %.9g", i % 65, i / 65, is, exact);
    }
    for (int n = 0; n < 3; ++n) {
        const int size = sizes[n].size;
        double most = 0, square = 0;
        ssgi_cap_table(table, size, NULL);
        for (int i = 0; i <= 500; ++i)
            for (int j = 0; j <= 500; ++j) {
                const double o = 4 * PI * i / 500, c = j / 250.0 - 1,
                             off = looked_up(table, size, o, c) - ssgi_cap_occlusion(o, c);
                most = fmax(most, fabs(off));
                square += off * off / (501 * 501);
                if (i == 500) CHECK(fabs(looked_up(table, size, o, c) - 1) < 1e-6, "all of the sphere, cosine %g", c);
            }
        SHOW(most < sizes[n].most && most > 0.8 * sizes[n].most && sqrt(square) < 1.1 * sizes[n].rms,
             "%d: off by at most %.2e, RMS %.1e", size, most, sqrt(square));
    }
}

/* Checks light through a cap: constant light gives exactly the cap's share of pi; other light gives its sum over fine
   steps; a cap and its inverse together give all. */
static void cap_lights(void)
{
    enum { BANDS = 3, STEPS = 400 };
    float c[3 * BANDS * BANDS] = { 0 }, basis[BANDS * BANDS], out[3], rest[3], axis[3], away[3], normal[3], d[3];
    double worst = 0, whole = 0;
    c[0] = 2 * sqrtf(4 * (float)PI);
    c[1] = 0.5f * c[0];
    for (int i = 0; i < 200; ++i) {
        direction(axis);
        direction(normal);
        const float o = i == 7 ? 20 : t_uniform(0, 4 * (float)PI),
                    longer[3] = { 3 * normal[0], 3 * normal[1], 3 * normal[2] };
        const double occlusion = ssgi_cap_occlusion((double)o, dot(axis, normal));
        CHECK(ssgi_cap_light(out, c, 1, o, axis, longer, NULL) == SSGI_OK
                  && fabs((double)out[0] - 2 * PI * occlusion) < 1e-5 && fabsf(2 * out[1] - out[0]) < 1e-6f
                  && out[2] == 0,
              "constant light: %g %g %g, occlusion %g", (double)out[0], (double)out[1], (double)out[2], occlusion);
    }
    for (int k = 0; k < 3 * BANDS * BANDS; ++k) c[k] = k < 3 ? 2 : t_uniform(-0.3f, 0.3f);
    for (int t = 0; t < 12; ++t) {
        double sum[3] = { 0 }, open[3] = { 0 };
        direction(axis);
        direction(normal);
        const double o = t_within(0.1, 2 * PI), least = 1 - o / (2 * PI);
        for (int i = 0; i < STEPS * STEPS; ++i) {
            const double facing = equirect(d, i, STEPS, STEPS) * dot(d, normal);
            if (facing < 0) continue;
            ssgi_sh_basis(basis, BANDS, d);
            for (int k = 0; k < 3 * BANDS * BANDS; ++k) {
                const double light = facing * (double)(basis[k / 3] * c[k]);
                open[k % 3] += light;
                if (dot(d, axis) > least) sum[k % 3] += light;
            }
        }
        for (int k = 0; k < 3; ++k) away[k] = -axis[k];
        ssgi_cap_light(out, c, BANDS, (float)o, axis, normal, NULL);
        ssgi_cap_light(rest, c, BANDS, (float)(4 * PI - o), away, normal, NULL);
        for (int j = 0; j < 3; ++j) {
            grow(&worst, ((double)out[j] - sum[j]) / open[j]);
            grow(&whole, ((double)(out[j] + rest[j]) - open[j]) / open[j]);
        }
    }
    SHOW(worst < 0.005 && whole < 0.02, "caps: off by %.4f of the whole light, with the inverse cap by %.4f", worst,
         whole);
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

void test_cap(void)
{
    RUN("a cap under the cosine is the closed form in all its branches, complementary and monotone", caps);
    RUN("a table of caps is the closed form at its texels, and between them as close as its size says", cap_tables);
    RUN("light of a cap is its share of constant light, and what fine steps sum to of any other", cap_lights);
    RUN("reflections: between visibility and 1; nothing occluded is 1; no number gives none", reflections);
}
