/* test_environment.c - ssgi.h's room of environments: octahedral maps, cones, suns and virtual point lights. */
#include "frames.h"
#include "ssgi.h"

#include <math.h>
#include <string.h>

#define PI KIT_PI

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
        CHECK(fabsf(e[0]) <= 1 && fabsf(e[1]) <= 1 && apart_by(d, back, 3) < 1e-6 && fabs(dot(back, back) - 1) < 1e-6,
              "%g %g %g to %g %g to %g %g %g", (double)d[0], (double)d[1], (double)d[2], (double)e[0], (double)e[1],
              (double)back[0], (double)back[1], (double)back[2]);
    }
}

static void environment_maps(void)
{
    enum { SIDE = 32 };
    static const float angles[] = { 0, 1e-6f, 0.05f, 0.39f, 3, 12 };
    static const int sizes[][2] = { { 1, 1 }, { 5, 3 }, { 97, 41 }, { 300, 100 } };
    static float rgb[3 * 300 * 150], map[2][3 * SIDE * SIDE];
    float d[3], given[27];
    for (size_t k = 0; k < sizeof angles / sizeof angles[0]; ++k) {
        const double kappa = 4 * PI / fmax((double)angles[k], 0.05), mean_cosine = 1 / tanh(kappa) - 1 / kappa;
        /* the factor of the lobe in each band */
        const double lobe[3] = { 1, k ? mean_cosine : 2.0 / 3, k ? 1 - 3 * mean_cosine / kappa : 0.25 };
        double worst = 0, mean = 0, all = 0;
        for (int s = 0; s < 4; ++s) {
            const float constant[3] = { 0.7f, 1e4f, 0 };
            for (int i = 0; i < 3 * sizes[s][0] * sizes[s][1]; ++i) rgb[i] = constant[i % 3];
            T_OK(ssgi_environment_map, map[0], 8, rgb, sizes[s][0], sizes[s][1], angles[k]);
            for (int i = 0; i < 3 * 64; ++i)
                CHECK(fabsf(map[0][i] - constant[i % 3]) <= 1e-6f * constant[i % 3], "constant, %d x %d, lobe %g: %.9g",
                      sizes[s][0], sizes[s][1], (double)angles[k], (double)map[0][i]);
        }
        smooth_sky(rgb, given, 300, 150);
        ssgi_environment_map(map[0], SIDE, rgb, 300, 150, angles[k], NULL);
        for (int i = 0; i < SIDE * SIDE; ++i) {
            map_direction(d, SIDE, i);
            /* a texel's solid angle is proportional to 1/s^3 */
            const double s = fabs((double)d[0]) + fabs((double)d[1]) + fabs((double)d[2]), weight = s * s * s;
            for (int c = 0; c < 3; ++c)
                grow(&worst, ((double)map[0][3 * i + c] - series(given + c, 3, 3, d, lobe)) * sqrt(4 * PI)
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
    float d[3];
    for (int i = 0; i < W * H; ++i) {
        equirect(d, i, W, H);
        rgb[3 * i] = dot(d, sun) > cos(radius) ? 101 : 1;
        rgb[3 * i + 1] = 0.7f;
    }
    T_OK(ssgi_environment_map, open, SIDE, rgb, W, H, 0);
    T_OK(ssgi_environment_cone, map, SIDE, rgb, W, H, 0);
    CHECK(!memcmp(map, open, sizeof map), "cosine 0 is not irradiance");
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
        SHOW(worst < 5e-3 && across < 0.02,
             "cone of cosine %g: disc inside off by %.2g of its exact average, across the rim by %.2g", C, worst,
             across);
    }
}

static const float luminance[3] = { 0.2126f, 0.7152f, 0.0722f };

/* Sums of an image's suns: of irradiances, the least and most luminance, how many are lit. Directions are unit. */
typedef struct summed { double sum[3], least, most; int lit; } summed;

static summed cut(ssgi_sun *suns, int count, const float *rgb, int width, int height)
{
    summed s = { { 0, 0, 0 }, 1e30, 0, 0 };
    T_OK(ssgi_environment_suns, suns, count, rgb, width, height);
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
            CHECK(suns[i].irradiance[1] == 0.0f || apart_by(suns[i].direction, d, 3) < 1e-6,
                  "texel %d of %d: off by %g", at, width, apart_by(suns[i].direction, d, 3));
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
                    there += apart_by(suns[i].direction, want, 3) < 3e-4
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
    static const float dark[2][3] = { { 0, 0, 0 }, { NAN, -1, 0 } };
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
        T_OK(ssgi_vpl_choose, lights, count, position, normal, flux, PIXELS);
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
        T_OK(ssgi_vpl_choose, lights, side, position, position, flux, (size_t)(side * side + 1));
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
        float map[3 * SIDE * SIDE], coefficients[3 * HARMONICS] = { 0 }, basis[HARMONICS], n[3];
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
        T_OK(ssgi_sh_residual, map, SIDE, coefficients, bands, suns, count);
        for (int i = 0; i < 3 * SIDE * SIDE; ++i) {
            map_direction(n, SIDE, i / 3);
            const double sum = (double)map[i] + series(coefficients + i % 3, 3, bands, n, of_cosine) / PI;
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
            T_OK(ssgi_vpl_area, light, each, corner, a, b, halves, radiance);
            if (halves) T_OK(ssgi_vpl_area, light + each, each, other, back[0], back[1], 1, radiance);
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
        T_OK(ssgi_vpl_area, light, 64, k ? square : corner, a, side, 0, radiance);
        const double worst = off_by(light, 64, half[k], 81, 2, 2);
        CHECK(fabs(worst - (k ? 0.037 : 0.017)) < 0.0005, "64 lights of 2 x %d: off by %.4f", 1 + k, worst);
    }
}

void test_environment(void)
{
    RUN("octahedral: there and back, as the GLSL twin", octahedral);
    RUN("environment maps: constants exact, each band as the lobe leaves it, the mean kept", environment_maps);
    RUN("cones: cosine 0 is irradiance, constants exact, a disc inside, across the rim and outside", environment_cones);
    RUN("what harmonics lack of open surfaces makes them exact", lacking);
    RUN("suns: no light lost, about equal shares, one texel is one sun", sunlight);
    RUN("suns: a white sky is cut where it is wider on the sphere, at its median", white_sky);
    RUN("virtual point lights: the map's flux in all, only where it is lit, by share", vpls);
    RUN("virtual point lights: of a square of pixels that are all as bright, one a row and one a column", vpl_strata);
    RUN("area lights as points: the closed form of a rectangle", areas);
}
