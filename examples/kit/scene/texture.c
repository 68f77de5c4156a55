/* texture.c - reads models' textures: their mean colour, and if alpha cuts holes. Declared in kit_models.h. */
#include "kit/kit_models.h"
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <stb/stb_image.h>

enum { MOST_TEXELS = 1 << 26, CLEAR = 25, OPAQUE = 230 };

int kit_picture_read(kit_picture *t, const void *data, size_t size, const char **why)
{
    int channels;
    memset(t, 0, sizeof *t);
    *why = "is larger than 8192 x 8192";
    if (size > INT_MAX) return -1;
    if (stbi_info_from_memory(data, (int)size, &t->width, &t->height, &channels)) {
        if (t->width > MOST_TEXELS / t->height) return -1;
        t->texel = stbi_load_from_memory(data, (int)size, &t->width, &t->height, &channels, 4);
        *why = "is damaged";
    } else *why = "is no PNG, JPEG, TGA or BMP";
    return t->texel ? 0 : -1;
}

void kit_picture_free(kit_picture *t)
{
    free(t->texel);
    memset(t, 0, sizeof *t);
}

void kit_picture_mean(const kit_picture *t, int least, float rgb[3])
{
    const size_t texels = (size_t)t->width * (size_t)t->height;
    double linear[256], sum[3] = { 0 };
    size_t counted = 0;
    for (int v = 0; v < 256; ++v) /* converts sRGB to linear [IEC 61966-2-1] */
        linear[v] = v <= 10 ? v / 255.0 / 12.92 : pow((v / 255.0 + 0.055) / 1.055, 2.4);
    for (size_t i = 0; i < texels; ++i) {
        if (t->texel[4 * i + 3] < least) continue;
        for (size_t k = 0; k < 3; ++k) sum[k] += linear[t->texel[4 * i + k]];
        ++counted;
    }
    if (!counted && least > 0) {
        kit_picture_mean(t, 0, rgb);
        return;
    }
    for (int k = 0; k < 3; ++k) rgb[k] = (float)(sum[k] / (double)counted);
}

int kit_picture_cuts(const kit_picture *t)
{
    const size_t texels = (size_t)t->width * (size_t)t->height;
    size_t clear = 0, opaque = 0;
    for (size_t i = 0; i < texels; ++i) {
        clear += t->texel[4 * i + 3] < CLEAR;
        opaque += t->texel[4 * i + 3] >= OPAQUE;
    }
    return clear > 0 && opaque > texels / 100 && clear + opaque > texels / 5 * 4;
}
