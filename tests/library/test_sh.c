/* test_sh.c - ssgi.h's room of spherical harmonics, against the table of functions and closed forms. */
#include "frames.h"
#include "ssgi.h"

#include <math.h>
#include <string.h>

#define PI KIT_PI

enum { SKY = 64, CUBE = 24 };
static const float axis_z[3] = { 0, 0, 1 };

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
            zonal[l] = (float)(of_cosine[l] * sqrt((2 * l + 1) / (4 * PI)));
        }
        /* the transfer of an open point about any normal */
        ssgi_sh_zonal(turned, 6, zonal, a);
        for (int i = 0; i < 36; ++i)
            CHECK(fabs((double)turned[i] - of_cosine[(int)sqrt(i)] * (double)ya[i]) < 1e-6, "coefficient %d: %g", i,
                  (double)turned[i]);
    }
    for (int l = -1; l < 7; ++l)
        CHECK(fabs((double)ssgi_sh_cosine(l) - (l < 0 || l > 5 ? 0 : of_cosine[l])) < 4e-7, "cosine, band %d: %.9g", l,
              (double)ssgi_sh_cosine(l));
}

static void projections(void)
{
    static float rgb[6 * SKY * SKY], cube[6][3 * CUBE * CUBE];
    const float *const faces[6] = { cube[0], cube[1], cube[2], cube[3], cube[4], cube[5] };
    float given[48] = { 0 }, got[2][48];
    smooth_sky(rgb, given, 2 * SKY, SKY);
    for (int i = 0; i < 6 * CUBE * CUBE; ++i) {
        const int face = i / (CUBE * CUBE), at = i % (CUBE * CUBE);
        const float s = ((float)(at % CUBE) * 2 + 1) / CUBE - 1, t = ((float)(at / CUBE) * 2 + 1) / CUBE - 1,
                    l = sqrtf(1 + s * s + t * t);
        /* OpenGL 4.6 table 8.19 of cube map faces, solved for the direction */
        const float table[6][3] = { { 1, -t, -s }, { -1, -t, s }, { s, 1, t },
                                    { s, -1, -t }, { s, -t, 1 },  { -s, -t, -1 } };
        const float p[3] = { table[face][0] / l, table[face][1] / l, table[face][2] / l };
        for (int c = 0; c < 3; ++c) cube[face][3 * at + c] = (float)series(given + c, 3, 3, p, NULL);
    }
    T_OK(ssgi_sh_project_equirect, got[0], 4, rgb, 2 * SKY, SKY);
    T_OK(ssgi_sh_project_cube, got[1], 4, faces, CUBE);
    for (int i = 0; i < 2 * 48; ++i)
        CHECK(fabsf(got[i / 48][i % 48] - given[i % 48]) < 1e-3f * given[i % 3], "%s, coefficient %d: %g, given %g",
              i < 48 ? "latitude-longitude" : "cube", i % 48, (double)got[i / 48][i % 48], (double)given[i % 48]);
    for (int i = 0; i < 6 * 3 * CUBE * CUBE; ++i) cube[i % 6][i / 6] = 1;
    ssgi_sh_project_cube(got[0], 1, faces, CUBE, NULL);
    CHECK(fabs((double)got[0][0] - 2 * sqrt(PI)) < 1e-6,
          "a cube of ones: %.9g, not 2 sqrt(pi): solid angles do not sum to 4 pi", (double)got[0][0]);
}

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
            const double negative = fmin(series(c, 3, bands, d, NULL), 0);
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
    float w[HARMONICS];
    for (size_t t = 0; t < ROWS(row); ++t) {
        float c[3 * HARMONICS] = { 0 };
        const int bands = row[t].bands;
        double least = 1e30, lowest = 1e30;
        ssgi_sh_light(c, bands, axis_z, 0, one, row[t].window, NULL);
        for (int l = 0; l < bands; ++l)
            CHECK(fabs((double)c[3 * (l * l + l)] - row[t].zonal[l]) < 1e-6, "window %d, zonal %d: %.9g", row[t].window,
                  l, (double)c[3 * (l * l + l)]);
        const double k = (double)c[0] / 0.28209479177, peak = series(c, 3, bands, axis_z, NULL),
                     facing = series(c, 3, bands, axis_z, of_cosine), behind = series(c, 3, bands, nowhere, of_cosine);
        CHECK(fabs(k - row[t].k) < 1e-6 && fabs(peak / row[t].peak - 1) < 1e-6 && fabs(facing - 1) < 1e-5
                  && fabs(behind - row[t].back) < 1e-5,
              "k %.9g, peak %.9g, facing %.9g, behind %.9g", k, peak, facing, behind);
        for (int i = 0; i <= 10000; ++i) {
            const float d[3] = { (float)sin(i * PI / 10000), 0, (float)cos(i * PI / 10000) };
            least = fmin(least, series(c, 3, bands, d, of_cosine));
            lowest = fmin(lowest, series(c, 3, bands, d, NULL));
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
        float d[3], far_away[3], c[3 * HARMONICS] = { 0 }, twice[3 * HARMONICS], w[6], zonal[6], turned[HARMONICS];
        direction(d);
        for (int i = 0; i < 3; ++i) far_away[i] = 40 * d[i];
        T_OK(ssgi_sh_light, c, bands, far_away, sine, red, window);
        for (int i = 0; i < 3; ++i)
            CHECK(fabs(series(c + i, 3, bands, d, of_cosine) / (double)red[i] - (bands > 1 ? 1 : 0.25)) < 1e-5,
                  "%d bands, window %d, sine %g: facing %.9g of %g", bands, window, (double)sine,
                  series(c + i, 3, bands, d, of_cosine), (double)red[i]);
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
        for (int i = 0; i < 3 * HARMONICS; ++i)
            CHECK(fabsf(twice[i] - 2 * c[i]) < 1e-5f && (i < count || c[i] == 0.0f), "twice, coefficient %d: %g and %g",
                  i, (double)c[i], (double)twice[i]);
    }
}

static void rotations(void)
{
    for (int t = 0; t < 120; ++t) {
        const int bands = 1 + t % 6, channels = t % 4 * 2 - 1, count = channels * bands * bands;   /* -1: no channels */
        enum { ALL = 5 * HARMONICS };
        float f[ALL], turned[ALL], twice[ALL], at_once[ALL], z[3], d[3], e[3], m[2][16], both[16];
        for (int i = 0; i < ALL; ++i) {
            f[i] = t_uniform(-1, 1);
            turned[i] = at_once[i] = 7;
        }
        for (int k = 0; k < 2; ++k) {
            direction(z);
            rigid_about(m[k], z);
        }
        for (int i = 2; i < 16 && t % 2; i += 4) m[0][i] = -m[0][i];     /* mirrored, as left-handed engines' are */
        for (int i = 0; i < 4; ++i) through(m[1], m[0] + 4 * i, 0, both + 4 * i);
        ssgi_sh_rotate(turned, bands, f, channels, m[0]);
        memcpy(twice, turned, sizeof twice);
        ssgi_sh_rotate(twice, bands, twice, channels, m[1]);
        ssgi_sh_rotate(at_once, bands, f, channels, both);
        CHECK(apart_by(twice, at_once, ALL) < 5e-6, "%d bands, %d channels: twice is off by %g", bands, channels,
              apart_by(twice, at_once, ALL));
        for (int i = count < 0 ? 0 : count; i < ALL; ++i) CHECK(turned[i] == 7.0f, "%d is written to", i);
        for (int k = 0; k < 5 * channels; ++k) {
            direction(d);
            through(m[0], d, 0, e);
            const double is = series(turned + k / 5, channels, bands, e, NULL),
                         was = series(f + k / 5, channels, bands, d, NULL);
            CHECK(fabs(is - was) < 2e-5, "%d bands, channel %d: %.9g, before %.9g", bands, k / 5, is, was);
        }
        ssgi_sh_rotate(turned, bands, f, channels, NULL);
        CHECK(count < 0 || apart_by(turned, f, count) < 1e-6, "no rotation is off by %g", apart_by(turned, f, count));
    }
}

void test_sh(void)
{
    RUN("harmonics: the table's functions, the addition theorem, the cosine's factors", harmonics);
    RUN("harmonics: latitude-longitude and cube maps give back what made them", projections);
    RUN("windows: the table's rows: zonal factors, irradiance facing, behind and least, the worst that any mask lets "
        "through",
        windows);
    RUN("lights: what faces one receives what was given, of one band all the mean; spheres are caps; they add", lights);
    RUN("rotation: values move with their directions, twice is once by both", rotations);
}
