/* light.c - environments and lights. */
#include "kit.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

static const double pi = 3.14159265358979323846;

void kit_env_place(const kit_image *env, const float direction[3], double at[2])
{
    const double x = (double)direction[0], y = (double)direction[1], z = (double)direction[2];
    at[0] = env->width * fmin(fmax(0.5 - atan2(x, z) / (2 * pi), 0), 1);
    at[1] = env->height * fmin(fmax(0.5 - atan2(y, sqrt(x * x + z * z)) / pi, 0), 1);
}

void kit_env_direction(const kit_image *env, double x, double y, float direction[3])
{
    const double longitude = pi * (1 - 2 * x / env->width), latitude = pi * (0.5 - y / env->height);
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
            rgb[c] += (float)(weight * (double)env->data[((size_t)c * (size_t)env->height + (size_t)inside[1]) * (size_t)env->width + (size_t)inside[0]]);
    }
}

/* Horizon to zenith, a glow of 20 degrees half-width about the sun's place, and a ground that takes over within 6 degrees below the horizon. The luminance of the
   irradiance over pi facing up is 1. */
static void sky_radiance(const float d[3], double rgb[3])
{
    static const double zenith[3] = { 0.38, 0.66, 1.28 }, horizon[3] = { 1.20, 1.32, 1.42 }, glow[3] = { 4.4, 3.1, 1.6 }, ground[3] = { 0.24, 0.17, 0.11 };
    static const double sun[3] = { 0.5792280, 0.5735764, 0.5792280 };
    const double up = (double)d[1], off = 1 - ((double)d[0] * sun[0] + up * sun[1] + (double)d[2] * sun[2]);
    const double high = 1 - pow(1 - fmax(0, up), 3), near_sun = exp2(-off / 0.0603074), t = fmin(1, fmax(0, 1 + up / 0.1)), above = t * t * (3 - 2 * t);
    for (int c = 0; c < 3; ++c)
        rgb[c] = ground[c] + above * (horizon[c] + high * (zenith[c] - horizon[c]) + near_sun * glow[c] - ground[c]);
}

static int sky_new(kit_image *env, kit_error *err)
{
    if (kit_image_new(env, 512, 256, "R,G,B", err)) return -1;
    for (int y = 0; y < env->height; ++y)
        for (int x = 0; x < env->width; ++x) {
            float  d[3];
            double rgb[3];
            kit_env_direction(env, x + 0.5, y + 0.5, d);
            sky_radiance(d, rgb);
            for (int c = 0; c < 3; ++c) env->data[(c * env->height + y) * env->width + x] = (float)rgb[c];
        }
    return 0;
}

int kit_env_read(kit_image *env, const char *path, kit_error *err)
{
    static const char *const names[3] = { "R", "G", "B" };
    const char *dot = strrchr(path, '.');
    kit_image file, image = { 0 };
    int failed = 0;
    if (!strcmp(path, "sky")) return sky_new(env, err);
    if (!dot || (strcasecmp(dot, ".exr") && strcasecmp(dot, ".hdr"))) return kit_fail(err, "environment %s: must be sky or end in .exr or .hdr", path);
    if ((strcasecmp(dot, ".exr") ? kit_hdr_read : kit_exr_read)(&file, path, err)) return -1;
    for (int c = 0; c < 3 && !failed; ++c)
        if (!kit_image_channel(&file, names[c])) failed = kit_fail(err, "%s: has no channel %s", path, names[c]);
    failed = failed || kit_image_new(&image, file.width, file.height, "R,G,B", err);
    const size_t texels = (size_t)file.width * (size_t)file.height;
    for (size_t c = 0; c < 3 && !failed; ++c) {
        const float *channel = kit_image_channel(&file, names[c]);
        for (size_t i = 0; i < texels; ++i) image.data[c * texels + i] = channel[i] > 0 && isfinite(channel[i]) ? channel[i] : 0;
    }
    kit_image_free(&file);
    if (!failed) *env = image;
    return failed ? -1 : 0;
}

int kit_light_parse(kit_light *light, const char *text, kit_error *err)
{
    static const char *const kinds[] = { [KIT_SUN] = "sun:", [KIT_POINT] = "point:" };
    kit_light read = { 0 };
    double    v[6], length = 1;
    int       ok = 1, used = 0;
    while (read.kind < 2 && strncmp(text, kinds[read.kind], strlen(kinds[read.kind]))) ++read.kind;
    if (read.kind < 2) sscanf(text + strlen(kinds[read.kind]), "%lf,%lf,%lf,%lf,%lf,%lf%n", &v[0], &v[1], &v[2], &v[3], &v[4], &v[5], &used);
    if (!used || text[strlen(kinds[read.kind]) + (size_t)used])
        return kit_fail(err, "light %s: must be point:x,y,z,r,g,b or sun:x,y,z,r,g,b", text);
    if (read.kind == KIT_SUN) length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int i = 0; i < 3; ++i) {
        read.at[i] = (float)(v[i] / length);
        read.colour[i] = (float)v[3 + i];
        ok = ok && isfinite(read.at[i]) && isfinite(read.colour[i]) && read.colour[i] >= 0;
    }
    if (!ok) return kit_fail(err, "light %s: numbers must be finite, colours 0 or more, a sun's direction not 0", text);
    *light = read;
    return 0;
}
