/* test_math.c - ssgi.h's rooms of view, kernel and bias against double precision, and the horizon algebra of HSAO's normal rays. */
#include "t.h"
#include "../ssgi.h"

#include <math.h>
#include <string.h>

#define PI 3.14159265358979323846
#define NAMES(why, start) (strncmp(why, start, strlen(start)) == 0)

static uint32_t random_state = 1;

static float uniform(float lower, float upper)
{
    random_state = random_state * 1664525u + 1013904223u;
    return lower + (upper - lower) * (float)(random_state >> 8) * (1.0f / 16777216.0f);
}

/* ---- >>view ------------------------------------------------------------------------------------------------------ */

typedef struct layout { const char *name; int clip, ortho, reversed; double m10, m14; } layout;
enum { LAYOUTS = 9 };

static layout layout_at(int i, double n, double f)
{
    const layout all[LAYOUTS] = {
        { "GL", SSGI_CLIP_GL, 0, 0, -(f + n) / (f - n), -2 * f * n / (f - n) }, { "GL, infinite", SSGI_CLIP_GL, 0, 0, -1, -2 * n },
        { "GL, reversed", SSGI_CLIP_GL, 0, 1, (f + n) / (f - n), 2 * f * n / (f - n) }, { "zero", SSGI_CLIP_ZERO, 0, 0, -f / (f - n), -f * n / (f - n) },
        { "zero, reversed", SSGI_CLIP_ZERO, 0, 1, n / (f - n), f * n / (f - n) }, { "zero, reversed, infinite", SSGI_CLIP_ZERO, 0, 1, 0, n },
        { "orthographic GL", SSGI_CLIP_GL, 1, 0, -2 / (f - n), -(f + n) / (f - n) }, { "orthographic zero", SSGI_CLIP_ZERO, 1, 0, -1 / (f - n), -n / (f - n) },
        { "orthographic zero, reversed", SSGI_CLIP_ZERO, 1, 1, 1 / (f - n), f / (f - n) } };
    return all[i];
}

/* off-centre; y down in every other layout; scaled as a whole in every third */
static void matrix(float m[16], const layout *l, int i)
{
    const float c = i % 3 ? 1.0f : 2.0f;
    const float perspective[16] = { 1.3f * c, 0, 0, 0, 0, (i & 1 ? -2.1f : 2.1f) * c, 0, 0, 0.07f * c, -0.03f * c, (float)l->m10 * c, -c, 0, 0, (float)l->m14 * c, 0 };
    memcpy(m, perspective, sizeof perspective);
    if (l->ortho) { m[12] = m[8]; m[13] = m[9]; m[15] = c; m[8] = m[9] = m[11] = 0; }
}

static void views(void)
{
    const double n = 1, f = 100;
    for (int i = 0; i < LAYOUTS; ++i) {
        const layout l = layout_at(i, n, f);
        const double depths[3] = { n, 0.5 * (n + f), 0.5 * f };
        const float nothing[] = { l.reversed ? 0.0f : 1.0f, NAN, INFINITY, -INFINITY, -0.5f, -1e-30f, 1.5f };
        const char *why = "";
        float m[16];
        ssgi_view view;
        matrix(m, &l, i);
        if (!CHECK(ssgi_view_from_projection(&view, m, l.clip, 1920, 1080, &why) == SSGI_OK, "%s: %s", l.name, why)) continue;
        CHECK(view.orthographic == l.ortho && view.clear == nothing[0] && view.width == 1920 && view.height == 1080, "%s: orthographic %d, clear %g", l.name, view.orthographic, (double)view.clear);
        for (size_t k = 0; k < 3; ++k) {                 /* the matrix as given, in double; window depth as a float */
            const double z = depths[k], w = (double)m[11] * -z + (double)m[15], ndc = ((double)m[10] * -z + (double)m[14]) / w;
            const float window = (float)fmin(fmax(l.clip == SSGI_CLIP_GL ? 0.5 * ndc + 0.5 : ndc, 0), 1);
            const double a = fabs((double)view.depth[0]), b = fabs((double)view.depth[1] * (double)window);
            const double lost = 1.2e-7 * fmax(a, b), within = l.ortho ? lost : z * z * lost;     /* roundings of window depth and of the sum's terms: the layout's own cost */
            CHECK(fabs((double)ssgi_view_depth(&view, window) - z) <= 1e-6 * z + within, "%s: depth %.9g of %g", l.name, (double)ssgi_view_depth(&view, window), z);
            if (l.reversed && !l.ortho && l.clip == SSGI_CLIP_ZERO) CHECK(within <= 1e-6 * z, "%s: reversed depth loses %g", l.name, within);
        }
        for (size_t k = 0; k < sizeof nothing / sizeof nothing[0]; ++k)
            CHECK(ssgi_view_depth(&view, nothing[k]) == SSGI_FAR, "%s: window depth %g gives %g", l.name, (double)nothing[k], (double)ssgi_view_depth(&view, nothing[k]));
        for (int k = 0; k < 2000; ++k) {
            const float pixel[2] = { uniform(-100, 2020), uniform(-100, 1180) }, z = expf(uniform(-3, 8));
            float p[3], back[3];
            ssgi_view_position(&view, pixel[0], pixel[1], z, p);
            ssgi_view_project(&view, p, back);
            for (int c = 0; c < 2; ++c) {
                const double w = (double)m[11] * (double)p[2] + (double)m[15], clip = (double)m[c * 5] * (double)p[c] + (double)m[8 + c] * (double)p[2] + (double)m[12 + c];
                const double by_matrix = (0.5 * clip / w + 0.5) * (c ? 1080 : 1920), was = (double)pixel[c];
                CHECK(fabs(by_matrix - was) < 1e-3 && fabs((double)back[c] - was) < 1e-3, "%s: pixel %.6g, by the matrix %.9g, back %.9g", l.name, was, by_matrix, (double)back[c]);
            }
            CHECK(p[2] == -z && back[2] == z, "%s: depth %g became %g", l.name, (double)z, (double)back[2]);
        }
    }
}

static void bad_views(void)
{
    static const struct { int at; float value; const char *what; } wrong[] = {
        { 0, NAN, "not finite" }, { 14, INFINITY, "not finite" }, { 11, 1, "along +z" }, { 11, 0, "no w" }, { 3, 0.1f, "w of x" }, { 7, 0.1f, "w of y" }, { 15, 1, "w of both" },
        { 1, 0.1f, "skewed" }, { 4, 0.1f, "skewed" }, { 2, 0.1f, "skewed" }, { 6, 0.1f, "skewed" }, { 0, 0, "flat" }, { 5, 0, "flat" }, { 14, 0, "no depth" }, { 14, 1e-42f, "too small" }, { 0, 1e-42f, "too small" } };
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
        CHECK(ssgi_view_from_projection(&view, m, SSGI_CLIP_GL, 64, 64, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "projection:"), "%s, element %d: \"%s\"", wrong[i].what, wrong[i].at, why);
    }
#define REFUSED(start, ...) CHECK(ssgi_view_from_projection(__VA_ARGS__, NULL) == SSGI_BAD_ARGUMENT && ssgi_view_from_projection(__VA_ARGS__, &why) == SSGI_BAD_ARGUMENT \
                                  && NAMES(why, start), "%s \"%s\"", start, why)
    REFUSED("view:", NULL, good, 0, 64, 64);
    REFUSED("projection:", &view, NULL, 0, 64, 64);
    for (int k = 0; k < 2; ++k) {
        REFUSED("clip:", &view, good, k ? 2 : -1, 64, 64);
        REFUSED("width:", &view, good, 0, k ? 0 : 65537, 64);
        REFUSED("height:", &view, good, 0, 64, k ? -1 : 65537);
    }
    CHECK(!memcmp(&view, &was, sizeof view), "a refused projection changed the view");
}

/* ---- >>kernel ---------------------------------------------------------------------------------------------------- */

enum { SETS = 16, SAMPLES = 64 };

static void kernels(void)
{
    static float k[4 * SETS * SAMPLES];
    static const char *const names[] = { "cosine", "hemisphere", "sphere", "disc" };
    for (int n = 1; n <= SAMPLES; ++n)
        for (int shape = SSGI_COSINE; shape <= SSGI_DISC; ++shape) {
            CHECK(ssgi_kernel(k, SETS, n, shape, NULL) == SSGI_OK, "refused");
            for (int set = 0; set < SETS; ++set) {
                const float *s = k + 4 * set * n;
                double z = 0, z2 = 0, x2 = 0;
                int stratum[SAMPLES] = { 0 }, right = 1;
                for (int i = 0; i < n; ++i, s += 4) {
                    const double l2 = (double)s[0] * (double)s[0] + (double)s[1] * (double)s[1] + (double)s[2] * (double)s[2];
                    const int cell = (int)ceil((double)s[3] * n - 1e-5) - 1;
                    right &= s[3] > 0 && s[3] <= 1 && cell >= 0 && cell < n && !stratum[cell < 0 || cell >= n ? 0 : cell]++;
                    right &= shape == SSGI_DISC ? l2 <= 1 && s[2] == 0.0f : fabs(l2 - 1) < 1e-6 && (shape == SSGI_SPHERE || s[2] > 0);
                    z += (double)s[2] / n; z2 += (double)s[2] * (double)s[2] / n; x2 += l2 / n;
                }
                CHECK(right, "%s, set %d of %d: not unit, or lengths not one a stratum in (0,1]", names[shape], set, n);
                if (shape == SSGI_HEMISPHERE) CHECK(fabs(2 * z - 1) < 1e-6, "hemisphere, set %d of %d: the counts 2 z/n sum to %.9g", set, n, 2 * z);
                if (shape == SSGI_COSINE) CHECK(fabs(z2 - 0.5) < 1e-6 && fabs(z - 2.0 / 3) < 0.05 / n, "cosine, set %d of %d: mean z^2 %.9g, z %.9g", set, n, z2, z);
                if (shape >= SSGI_SPHERE) CHECK(fabs(z) < 1e-6 && fabs(x2 - (shape == SSGI_DISC ? 0.5 : 1)) < 1e-6, "%s, set %d of %d: mean z %.9g, r^2 %.9g", names[shape], set, n, z, x2);
            }
        }
    float out[1] = { 7 };
    const struct { float *out; int sets, samples, shape; const char *start; } bad[] = { { NULL, 1, 1, 0, "out:" }, { out, 0, 1, 0, "sets:" }, { out, 4097, 1, 0, "sets:" },
        { out, 1, 0, 0, "samples:" }, { out, 1, 4097, 0, "samples:" }, { out, 1, 1, -1, "shape:" }, { out, 1, 1, 4, "shape:" } };
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i) {
        const char *why = "";
        CHECK(ssgi_kernel(bad[i].out, bad[i].sets, bad[i].samples, bad[i].shape, &why) == SSGI_BAD_ARGUMENT && NAMES(why, bad[i].start) && out[0] == 7.0f, "%s \"%s\"", bad[i].start, why);
    }
}

/* Greatest difference between the share of points in a box at the origin and its area, over the boxes that the points span. */
static double discrepancy(double (*p)[2], int n)
{
    double worst = 0;
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < n; ++j) {
            int open = 0, closed = 0;
            for (int k = 0; k < n; ++k) { open += p[k][0] < p[i][0] && p[k][1] < p[j][1]; closed += p[k][0] <= p[i][0] && p[k][1] <= p[j][1]; }
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
        ssgi_kernel(k, SETS, n, SSGI_COSINE, NULL);
        for (int set = 0; set < SETS; ++set) {           /* back to the square: azimuth and u */
            for (int i = 0; i < n; ++i) {
                const float *o = k + 4 * (set * n + i);
                const double a = atan2((double)o[1], (double)o[0]) / (2 * PI);
                p[i][0] = a - floor(a); p[i][1] = 1 - (double)o[2] * (double)o[2];
            }
            mean += discrepancy(p, n) / SETS;
            worst = fmax(worst, discrepancy(p, n));
            for (int i = 0; i < n; ++i) { p[i][0] = (double)uniform(0, 1); p[i][1] = (double)uniform(0, 1); }
            random += discrepancy(p, n) / SETS;
        }
        for (int i = 0; i < n; ++i) { float q[2]; ssgi_r2((uint32_t)i, q); p[i][0] = (double)q[0]; p[i][1] = (double)q[1]; }
        r2 = discrepancy(p, n);
        CHECK(worst < log(n) / n && mean < 0.5 * random && r2 < 2 * log(n) / n, "%d points: sets %.3f, at worst %.3f, R2 %.3f, random %.3f", n, mean, worst, r2, random);
        t_note("star discrepancy of %d points: sets %.3f, R2 %.3f, random %.3f", n, mean, r2, random);
    }
    CHECK(ssgi_radical_inverse(2, 6) == 0.375f && fabsf(ssgi_radical_inverse(3, 5) - 7.0f / 9) < 1e-7f && ssgi_radical_inverse(2, 0xffffffffu) < 1.0f && ssgi_radical_inverse(1, 5) == 0.0f, "radical inverse");
    for (int y = -20; y < 200; ++y)
        for (int x = -20; x < 200; ++x) {                /* any 3x3: at most 2 values in a ninth, so gaps stay below 3 of them */
            int cell[9] = { 0 }, most = 0;
            for (int i = 0; i < 9; ++i) {
                const float g = ssgi_gradient_noise(x + i % 3, y + i / 3);
                CHECK(g >= 0 && g < 1, "gradient noise %g at %d, %d", (double)g, x, y);
                if (++cell[(int)(g * 9)] > most) most = cell[(int)(g * 9)];
            }
            CHECK(most <= 2, "gradient noise: %d of 9 values in one ninth at %d, %d", most, x, y);
        }
}

static void jitter(void)
{
    static float tile[4 * 64 * 64];
    for (int size = 1; size <= 64; size = size < 9 ? size + 1 : size * 2 - size % 2)
        for (int directions = 1; directions <= 1024; directions *= 8) {
            char seen[2][64 * 64] = { { 0 } };
            const int n = size * size;
            double mean = 0;
            CHECK(ssgi_jitter_tile(tile, size, directions, NULL) == SSGI_OK, "refused");
            for (int i = 0; i < n; ++i) {
                const float *o = tile + 4 * i;
                const double turn = atan2((double)o[1], (double)o[0]) / (2 * PI), a = (turn < 0 ? turn + 1 : turn) * directions * n, b = ((double)o[2] + 0.5) * n;   /* strata 0 .. n */
                if (CHECK(a > 0 && a < n && b > 0 && b < n && o[3] >= 0 && o[3] < 1, "%d x %d, %d directions, texel %d: %g, %g, %g", size, size, directions, i, a, b, (double)o[3])) seen[0][(int)a] = seen[1][(int)b] = 1;
                mean += (double)o[2] / n;
            }
            for (int i = 0; i < n; ++i)                        /* beyond 100000 a float's cos and sin no longer tell strata apart */
                CHECK((seen[0][i] || n * directions >= 100000) && seen[1][i], "%d x %d, %d directions: stratum %d is empty", size, size, directions, i);
            CHECK(fabs(mean) < 1e-6, "%d x %d: mean offset %g", size, size, mean);
        }
    const char *why = "";
    CHECK(ssgi_jitter_tile(NULL, 4, 6, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "out:"), "%s", why);
    CHECK(ssgi_jitter_tile(tile, 65, 6, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "size:") && ssgi_jitter_tile(tile, 0, 6, NULL) == SSGI_BAD_ARGUMENT, "%s", why);
    CHECK(ssgi_jitter_tile(tile, 4, 0, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "directions:") && ssgi_jitter_tile(tile, 4, 1025, NULL) == SSGI_BAD_ARGUMENT, "%s", why);
}

/* ---- >>bias, >>horizon ------------------------------------------------------------------------------------------- */

static void bias(void)
{
    static const float m[2][16] = { { 1.5f, 0, 0, 0, 0, -2.4f, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 }, { 0.02f, 0, 0, 0, 0, 0.05f, 0, 0, 0, 0, -0.02f, 0, 0, 0, -1, 1 } };
    static const float small[] = { 0, 0, 0 }, box[] = { 0.3f, 0.4f, 0 }, huge[] = { 1e30f, 1e30f, 1e30f }, none[] = { NAN, 1, 1 }, below[] = { -1, 1, 1 }, tight[] = { 1e-3f, 1e-3f, 1e-3f };
    for (int ortho = 0; ortho < 2; ++ortho) {
        ssgi_view v;
        ssgi_view_from_projection(&v, m[ortho], SSGI_CLIP_GL, 1000, 500, NULL);
        for (float z = 0.2f; z < 1e4f; z *= 3) {             /* [HSAO08 eq. 13] z / (f res), the axis whose pixels are wider; f: element 0 or 5 */
            const double x = 1 / ((double)m[ortho][0] * 1000), y = 1 / (fabs((double)m[ortho][5]) * 500), want = fmax(x, y) * (ortho ? 1 : (double)z);
            CHECK(fabs((double)ssgi_normal_offset(&v, z) / want - 1) < 1e-6 && fabs((double)ssgi_pixel_footprint(&v, z) / (2 * want) - 1) < 1e-6, "offset %g at %g, eq. 13 %g", (double)ssgi_normal_offset(&v, z), (double)z, want);
            const double most = 0.25 * 500 * 2 * want;
            CHECK(fabs((double)ssgi_radius_guess(&v, z, small, tight) / 1.7320508e-4 - 1) < 1e-5, "a small box: %g", (double)ssgi_radius_guess(&v, z, small, tight));
            CHECK(fabs((double)ssgi_radius_guess(&v, z, small, box) / fmin(0.05, most) - 1) < 1e-5, "a box of diagonal 0.5 at %g: %g", (double)z, (double)ssgi_radius_guess(&v, z, small, box));
            const float *const odd[] = { small, huge, none, below };
            for (int k = 0; k < 4; ++k) CHECK(fabs((double)ssgi_radius_guess(&v, z, small, odd[k]) / most - 1) < 1e-6, "box %d: %g, a quarter of the height is %g", k, (double)ssgi_radius_guess(&v, z, small, odd[k]), most);
        }
    }
}

/* The loops of ssgi_horizon and ssgi_above, with what they find given: horizons that rise to H, rays above it. [ERRATA 5.1, 5.6] */
static void horizons(void)
{
    static const double constant[] = { 0, 0.3, 0.5, 0.8, 1 };
    for (int t = 0; t < 2000; ++t) {
        const int directions = 1 + t % 8, rays = 1 + t / 8 % 8, steps = 12;
        double below = 0, above = 0, want = 0;
        for (int i = 0; i < directions; ++i) {
            const double top = t < 5 ? constant[t] : (double)uniform(0, 1);
            double H = 0, sum = 0;
            for (int s = 0; s < steps; ++s) {                /* only rises count */
                const double found = s == steps - 1 ? top : (double)uniform(-1, 1) * top;
                if (found > H) { sum += found * found - H * H; H = found; }
            }
            for (int k = 0; k < rays; ++k) {
                const double zz = H * H + (1 - H * H) * (k + (double)uniform(0, 1)) / rays;
                CHECK(sqrt(zz) >= H - 1e-12 && zz <= 1, "a normal ray at z %.9g, below the horizon %.9g", sqrt(zz), H);
                above += (1 - H * H) / rays / directions;
            }
            below += sum / directions;
            want += top * top / directions;
        }
        CHECK(fabs(below - want) < 1e-12 && fabs(below + above - 1) < 1e-12, "O_T %.12g, H^2 %.12g, with all rays blocked %.12g", below, want, below + above);
    }
}

void test_math(void)
{
    RUN("views: every layout decodes its depth, and pixels come back, as by the matrix in double", views);
    RUN("views: bad projections are named and leave the view as it was", bad_views);
    RUN("kernels: counts sum to 1, one length a stratum, unit directions, moments of their shape", kernels);
    RUN("points are spread far better than random; noise is even over 3x3", evenness);
    RUN("jitter: angles and offsets stratified over the tile", jitter);
    RUN("the offset is half a pixel's footprint; a radius stays within the picture", bias);
    RUN("horizons: increments sum to H^2, normal rays weigh what is left", horizons);
}
