/* test_bias.c - ssgi.h's room of biases, footprints and the first guess of a radius. */
#include "frames.h"
#include "ssgi.h"

#include <math.h>
#include <string.h>

#define PI KIT_PI

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
    for (size_t i = 0; i < ROWS(row); ++i) {
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
    for (size_t i = 0; i < ROWS(row); ++i) {
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

void test_bias(void)
{
    RUN("footprints and bias: the papers' and the oracles' numbers, what a plane needs, finite whatever comes", biases);
    RUN("a radius to begin with: hills' and corners' spacing; a sphere has none", radii);
}
