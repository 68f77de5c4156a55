/* test_kernel.c - ssgi.h's room of points, sample sets and tiles of noise. */
#include "frames.h"
#include "ssgi.h"

#include <math.h>
#include <string.h>

#define PI KIT_PI

enum { SETS = 16, SAMPLES = 64 };

static void kernels(void)
{
    static float k[4 * SETS * SAMPLES];
    for (int n = 1; n <= SAMPLES; ++n) {
        T_OK(ssgi_kernel, k, SETS, n);
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
            T_OK(ssgi_directions, d, kind, SETS, n);
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
    for (size_t r = 0; r < ROWS(row); ++r) {
        const int n = row[r].size, sets = row[r].sets, w = row[r].w, h = row[r].h;
        static char strata[64 * 64], seen[64 * 64];
        int wrong = 0, nearest = 1 << 30;
        double off = 0;
        if (!T_OK(ssgi_noise_tile, t, n, sets, 6)) return;
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

void test_kernel(void)
{
    RUN("kernels: counts sum to 1, one length a stratum, unit directions, moments of their shape", kernels);
    RUN("directions of every kind are the kernel's points of the square, with sums that are exact", spread);
    RUN("tiles of noise: every window has every set once, every stratum is there, copies are far apart", tiles);
    RUN("points are spread far better than random", evenness);
}
