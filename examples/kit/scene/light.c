/* light.c - makes and reads environments and lights. Declared in kit.h. */
#include "kit/kit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>


void kit_env_place(const kit_image *env, const float direction[3], double at[2])
{
    const double x = (double)direction[0], y = (double)direction[1], z = (double)direction[2];
    at[0] = env->width * fmin(fmax(0.5 - atan2(x, z) / (2 * KIT_PI), 0), 1);
    at[1] = env->height * fmin(fmax(0.5 - atan2(y, sqrt(x * x + z * z)) / KIT_PI, 0), 1);
}

void kit_env_direction(const kit_image *env, double x, double y, float direction[3])
{
    const double longitude = KIT_PI * (1 - 2 * x / env->width), latitude = KIT_PI * (0.5 - y / env->height);
    direction[0] = (float)(sin(longitude) * cos(latitude));
    direction[1] = (float)sin(latitude);
    direction[2] = (float)(cos(longitude) * cos(latitude));
}

void kit_env_radiance(const kit_image *env, const float direction[3], float rgb[3])
{
    double at[2];
    memset(rgb, 0, 3 * sizeof *rgb);
    if (!env->data) return;
    kit_env_place(env, direction, at);
    const int column = (int)floor(at[0] - 0.5), row = (int)floor(at[1] - 0.5);
    for (int k = 0; k < 4; ++k) {
        const int    x = column + (k & 1), y = row + (k >> 1);
        const double weight = (1 - fabs(at[0] - 0.5 - x)) * (1 - fabs(at[1] - 0.5 - y));
        const int    inside[2] = { (x + env->width) % env->width, y < 0 ? 0 : y < env->height ? y : env->height - 1 };
        for (int c = 0; c < 3; ++c)
            rgb[c] +=
                (float)(weight
                        * (double)env->data[((size_t)c * (size_t)env->height + (size_t)inside[1]) * (size_t)env->width
                                            + (size_t)inside[0]]);
    }
}

/* Writes the radiance of "sky": a gradient from horizon to zenith, a glow of 20 degrees half-width about the sun, and a
   ground that begins within 6 degrees below the horizon. The luminance of the irradiance over pi facing up is 1.01. */
static void sky_radiance(const float d[3], double rgb[3])
{
    static const double zenith[3] = { 0.38, 0.66, 1.28 }, horizon[3] = { 1.20, 1.32, 1.42 },
                        glow[3] = { 4.4, 3.1, 1.6 }, ground[3] = { 0.24, 0.17, 0.11 };
    static const double sun[3] = { 0.5792280, 0.5735764, 0.5792280 };
    const double up = (double)d[1], off = 1 - ((double)d[0] * sun[0] + up * sun[1] + (double)d[2] * sun[2]);
    const double high = 1 - pow(1 - fmax(0, up), 3), near_sun = exp2(-off / 0.0603074),
                 t = fmin(1, fmax(0, 1 + up / 0.1)), above = t * t * (3 - 2 * t);
    for (int c = 0; c < 3; ++c)
        rgb[c] = ground[c] + above * (horizon[c] + high * (zenith[c] - horizon[c]) + near_sun * glow[c] - ground[c]);
}

static void white_radiance(const float d[3], double rgb[3]) { (void)d; rgb[0] = rgb[1] = rgb[2] = 1; }

/* A bright spot of an environment: angles and half sizes in degrees; power 2 gives discs, a larger power rectangles. */
typedef struct glow { double longitude, latitude, wide, high, power, rgb[3]; } glow;

/* Returns the weight of a glow: 1 in the middle, 1/2 at the half sizes, 0 beyond 1.4 of them. */
static double glow_at(const glow *g, const float d[3])
{
    const double lon = g->longitude * KIT_PI / 180, lat = g->latitude * KIT_PI / 180;
    const double x = (double)d[0], y = (double)d[1], z = (double)d[2], level = x * sin(lon) + z * cos(lon);
    const double depth = level * cos(lat) + y * sin(lat);
    if (depth <= 0) return 0;
    const double across = atan2(x * cos(lon) - z * sin(lon), depth), up = atan2(y * cos(lat) - level * sin(lat), depth);
    const double off = pow(pow(fabs(across) * 180 / KIT_PI / g->wide, g->power)
                               + pow(fabs(up) * 180 / KIT_PI / g->high, g->power),
                           1 / g->power),
                 t = fmin(1, fmax(0, (1.4 - off) / 0.8));
    return t * t * (3 - 2 * t);
}

static void add_glows(double rgb[3], const float d[3], const glow *glows, size_t count, double unit)
{
    for (size_t i = 0; i < count; ++i) {
        const double is = unit * glow_at(&glows[i], d);
        for (int c = 0; c < 3 && is > 0; ++c) rgb[c] += is * glows[i].rgb[c];
    }
}
#define GLOWS(table) table, sizeof (table) / sizeof (table)[0]

/* Writes the radiance of "probe", similar to Debevec's probe of Grace Cathedral: a dim, warm room; stained glass, blue
   and green to +x, amber to -x; a few lamps, warm to -x. The luminance of the irradiance over pi facing up is 1. */
static void probe_radiance(const float d[3], double rgb[3])
{
    static const double low[3] = { 0.090, 0.066, 0.045 }, high[3] = { 0.30, 0.215, 0.13 };
    static const glow glows[] = { { 48, 26, 4, 9, 6, { 3.5, 9.0, 28.0 } },    { 68, 26, 4, 9, 6, { 3.0, 17.0, 6.5 } },
                                  { 88, 26, 4, 9, 6, { 6.0, 16.0, 29.0 } },   { 108, 26, 4, 9, 6, { 2.5, 13.0, 10.0 } },
                                  { 128, 26, 4, 9, 6, { 10.0, 6.0, 25.0 } },  { -112, 24, 4, 9, 6, { 19.0, 9.0, 2.0 } },
                                  { -132, 24, 4, 9, 6, { 16.0, 5.0, 1.5 } },  { 180, 34, 7, 7, 2, { 10.0, 7.0, 8.0 } },
                                  { -62, 36, 3.2, 3.2, 2, { 300, 158, 52 } }, { -88, 18, 3, 3, 2, { 190, 100, 34 } },
                                  { 24, 58, 3, 3, 2, { 105, 112, 118 } },     { 150, 14, 3, 3, 2, { 110, 64, 26 } } };
    const double t = 0.5 + 0.5 * (double)d[1], unit = 1 / 1.4387;
    for (int c = 0; c < 3; ++c) rgb[c] = unit * (low[c] + t * t * (high[c] - low[c]));
    add_glows(rgb, d, GLOWS(glows), unit);
}

/* Writes the radiance of "windows", a room by day: walls and ceiling with 1/40 of the windows' radiance, three tall
   windows toward +x and a wide one toward -x, a ceiling lamp, and sunlight on the floor. The luminance of the
   irradiance over pi facing up is 1. */
static void windows_radiance(const float d[3], double rgb[3])
{
    static const double low[3] = { 0.26, 0.19, 0.13 }, high[3] = { 0.62, 0.58, 0.52 };
    static const glow glows[] = { { 64, 16, 8, 19, 8, { 9.0, 11.5, 15.0 } },  { 90, 16, 8, 19, 8, { 9.5, 12.0, 15.5 } },
                                  { 116, 16, 8, 19, 8, { 9.0, 11.5, 15.0 } }, { -82, 12, 17, 11, 8, { 5.2, 4.6, 3.6 } },
                                  { -128, -40, 11, 7, 6, { 7.5, 6.4, 4.6 } }, { 10, 74, 5, 5, 2, { 14, 10.5, 7 } } };
    const double t = 0.5 + 0.5 * (double)d[1], unit = 1 / 1.21445;
    for (int c = 0; c < 3; ++c) rgb[c] = unit * (low[c] + t * (high[c] - low[c]));
    add_glows(rgb, d, GLOWS(glows), unit);
}

/* Writes the radiance of "street", a street along z at night: a dark sky, facades to both sides with lit windows, and
   six lamps of a degree's half-angle that give nine tenths of the light from less than a thousandth of the sphere. The
   luminance of the irradiance over pi facing up is 1. */
static void street_radiance(const float d[3], double rgb[3])
{
    static const double sky[3] = { 0.016, 0.017, 0.026 }, haze[3] = { 0.13, 0.092, 0.058 },
                        ground[3] = { 0.11, 0.078, 0.045 };
    static const glow glows[] = { { 14, 34, 1, 1, 2, { 2100, 1350, 560 } },   { -22, 21, 1, 1, 2, { 1100, 700, 280 } },
                                  { 58, 52, 1, 1, 2, { 1500, 1500, 1380 } },  { -74, 40, 1, 1, 2, { 2400, 1500, 600 } },
                                  { 142, 28, 1, 1, 2, { 1300, 830, 340 } },   { -158, 24, 1, 1, 2, { 900, 980, 1080 } },
                                  { 84, 10, 2.5, 3.5, 8, { 3.2, 2.3, 1.1 } }, { 101, 22, 2.5, 3.5, 8, { 2.4, 1.7, 1 } },
                                  { 70, 30, 2.2, 3, 8, { 1.2, 1.4, 1.9 } },   { -96, 12, 2.5, 3.5, 8, { 3, 2.2, 1 } },
                                  { -110, 26, 2.2, 3, 8, { 2, 1.5, 0.7 } },   { -64, 3, 9, 2.5, 8, { 5, 0.9, 2.6 } } };
    const double unit = 1 / 1.31662, up = (double)d[1], side = fabs((double)d[0]);
    const double low = exp2(-fmax(0, up) / 0.08), t = fmin(1, fmax(0, 0.5 + up / 0.04));
    const int    facade = up > 0 && up < 0.62 * side * side;
    for (int c = 0; c < 3; ++c)
        rgb[c] = unit * (ground[c] + t * ((facade ? haze[c] : sky[c] + low * (haze[c] - sky[c])) - ground[c]));
    add_glows(rgb, d, GLOWS(glows), unit);
}

static const struct {
    const char *name;
    void (*radiance)(const float d[3], double rgb[3]);
} built_in[] = { { "sky", sky_radiance },         { "probe", probe_radiance },   { "windows", windows_radiance },
                 { "street", street_radiance }, { "white", white_radiance } };

static int drawn(kit_image *env, void (*radiance)(const float d[3], double rgb[3]), kit_error *err)
{
    if (kit_image_new(env, 512, 256, "R,G,B", err)) return -1;
    for (int y = 0; y < env->height; ++y)
        for (int x = 0; x < env->width; ++x) {
            float  d[3];
            double rgb[3];
            kit_env_direction(env, x + 0.5, y + 0.5, d);
            radiance(d, rgb);
            for (int c = 0; c < 3; ++c) env->data[(c * env->height + y) * env->width + x] = (float)rgb[c];
        }
    return 0;
}

int kit_env_add_sun(kit_image *env, const kit_light *sun, double degrees, kit_error *err)
{
    const glow disc = { atan2((double)sun->at[0], (double)sun->at[2]) * 180 / KIT_PI,
                        asin(fmin(fmax((double)sun->at[1], -1), 1)) * 180 / KIT_PI,
                        degrees,
                        degrees,
                        2,
                        { 0 } };
    const int  width = env->data ? env->width : 1024, height = env->data ? env->height : 512;
    double     facing = 0;
    if (!(degrees >= 180.0 / height && degrees <= 45))
        return kit_fail(err, "sun of half-angle %g: must be a texel's %g to 45 degrees", degrees, 180.0 / height);
    if (!env->data && kit_image_new(env, width, height, "R,G,B", err)) return -1;
    for (int pass = 0; pass < 2; ++pass)                /* the first pass sums the disc's irradiance at radiance 1 */
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x) {
                float d[3];
                kit_env_direction(env, x + 0.5, y + 0.5, d);
                const double weight = glow_at(&disc, d), cosine = (double)d[0] * (double)sun->at[0]
                                                                  + (double)d[1] * (double)sun->at[1]
                                                                  + (double)d[2] * (double)sun->at[2];
                if (!pass)
                    facing += weight * cosine * 2 * KIT_PI / width * KIT_PI / height * sin(KIT_PI * (y + 0.5) / height);
                for (int c = 0; c < 3 && pass; ++c)
                    env->data[(c * height + y) * width + x] += (float)(weight / facing * (double)sun->colour[c]);
            }
    return 0;
}

int kit_env_read(kit_image *env, const char *path, kit_error *err)
{
    static const char *const names[3] = { "R", "G", "B" };
    const char *dot = strrchr(path, '.');
    kit_image file, image = { 0 };
    int failed = 0;
    for (size_t i = 0; i < sizeof built_in / sizeof built_in[0]; ++i)
        if (!strcmp(path, built_in[i].name)) return drawn(env, built_in[i].radiance, err);
    if (!dot || (strcasecmp(dot, ".exr") && strcasecmp(dot, ".hdr")))
        return kit_fail(err, "environment %s: must be sky, probe, windows, street, white or end in .exr or .hdr", path);
    if ((strcasecmp(dot, ".exr") ? kit_hdr_read : kit_exr_read)(&file, path, err)) return -1;
    for (int c = 0; c < 3 && !failed; ++c)
        if (!kit_image_channel(&file, names[c])) failed = kit_fail(err, "%s: has no channel %s", path, names[c]);
    failed = failed || kit_image_new(&image, file.width, file.height, "R,G,B", err);
    const size_t texels = (size_t)file.width * (size_t)file.height;
    for (size_t c = 0; c < 3 && !failed; ++c) {
        const float *channel = kit_image_channel(&file, names[c]);
        for (size_t i = 0; i < texels; ++i)
            image.data[c * texels + i] = channel[i] > 0 && isfinite(channel[i]) ? channel[i] : 0;
    }
    kit_image_free(&file);
    if (!failed) *env = image;
    return failed ? -1 : 0;
}

int kit_env_adjust(kit_image *env, double degrees, double strength, kit_error *err)
{
    const double shift = fmod(degrees / 360, 1) * env->width, down = floor(shift);
    const float share = (float)(shift - down), scale = (float)strength;
    const size_t width = (size_t)env->width, whole = (size_t)((int)down + 2 * env->width);
    float *row = malloc((width + 1) * sizeof *row);
    if (!row) return kit_fail(err, "environment: out of memory");
    for (size_t y = 0; y < (size_t)env->channels * (size_t)env->height; ++y) {
        float *to = env->data + y * width;
        memcpy(row, to, width * sizeof *row);
        for (size_t x = 0; x < width; ++x)
            to[x] = scale * ((1 - share) * row[(x + whole) % width] + share * row[(x + whole + 1) % width]);
    }
    free(row);
    return 0;
}

int kit_light_parse(kit_light *light, const char *text, const double origin[3], kit_error *err)
{
    static const char *const kinds[] = { [KIT_SUN] = "sun:", [KIT_POINT] = "point:" };
    kit_light read = { 0 };
    double    v[6], length = 1;
    int       ok = 1, small = 1, used = 0;
    while (read.kind < 2 && strncmp(text, kinds[read.kind], strlen(kinds[read.kind]))) ++read.kind;
    if (read.kind < 2)
        sscanf(text + strlen(kinds[read.kind]), "%lf,%lf,%lf,%lf,%lf,%lf%n", &v[0], &v[1], &v[2], &v[3], &v[4], &v[5],
               &used);
    if (!used || text[strlen(kinds[read.kind]) + (size_t)used])
        return kit_fail(err, "light %s: must be point:x,y,z,r,g,b or sun:x,y,z,r,g,b", text);
    if (read.kind == KIT_SUN) length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; ++i) {
        read.at[i] = (float)(v[i] / length - (origin && read.kind == KIT_POINT ? origin[i] : 0));
        read.colour[i] = (float)v[3 + i];
        ok = ok && isfinite(read.at[i]) && isfinite(read.colour[i]) && read.colour[i] >= 0;
        small = small && fabs(v[i]) <= KIT_MOST && v[3 + i] <= KIT_MOST;
    }
    if (!ok) return kit_fail(err, "light %s: numbers must be finite, colours 0 or more, a sun's direction not 0", text);
    if (!small) return kit_fail(err, "light %s: its numbers must be in -%g..%g", text, KIT_MOST, KIT_MOST);
    *light = read;
    return 0;
}

const kit_material *kit_material_of(int i)
{
    static const kit_material materials[] = {
        { "apple",      { 2.29f, 2.39f, 1.97f }, { 0.0030f, 0.0034f, 0.046f }, 1.3f },
        { "chicken1",   { 0.15f, 0.21f, 0.38f }, { 0.015f, 0.077f, 0.19f }, 1.3f },
        { "chicken2",   { 0.19f, 0.25f, 0.32f }, { 0.018f, 0.088f, 0.20f }, 1.3f },
        { "cream",      { 7.38f, 5.47f, 3.15f }, { 0.0002f, 0.0028f, 0.0163f }, 1.3f },
        { "ketchup",    { 0.18f, 0.07f, 0.03f }, { 0.061f, 0.97f, 1.45f }, 1.3f },
        { "marble",     { 2.19f, 2.62f, 3.00f }, { 0.0021f, 0.0041f, 0.0071f }, 1.5f },
        { "potato",     { 0.68f, 0.70f, 0.55f }, { 0.0024f, 0.0090f, 0.12f }, 1.3f },
        { "skimmilk",   { 0.70f, 1.22f, 1.90f }, { 0.0014f, 0.0025f, 0.0142f }, 1.3f },
        { "skin1",      { 0.74f, 0.88f, 1.01f }, { 0.032f, 0.17f, 0.48f }, 1.3f },
        { "skin2",      { 1.09f, 1.59f, 1.79f }, { 0.013f, 0.070f, 0.145f }, 1.3f },
        { "spectralon", { 11.6f, 20.4f, 14.9f }, { 0.0f, 0.0f, 0.0f }, 1.3f },
        { "wholemilk",  { 2.55f, 3.21f, 3.77f }, { 0.0011f, 0.0024f, 0.014f }, 1.3f } };
    return i >= 0 && i < (int)(sizeof materials / sizeof materials[0]) ? &materials[i] : NULL;
}

float *kit_env_interleaved(const kit_image *env)
{
    const size_t texels = (size_t)env->width * (size_t)env->height;
    float *rgb = malloc(3 * texels * sizeof *rgb);
    for (size_t i = 0; rgb && i < 3 * texels; ++i) rgb[i] = env->data[i % 3 * texels + i / 3];
    return rgb;
}

int kit_light_scene(kit_lighting *lighting, const kit_scene *scene, kit_error *err)
{
    if (scene->env && kit_env_read(&lighting->env, scene->env, err)) return -1;
    for (int i = 0; i < scene->lights; i++) lighting->light[lighting->lights++] = scene->light[i];
    return 0;
}
