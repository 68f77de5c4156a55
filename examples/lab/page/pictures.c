/* pictures.c - exposes, shrinks and saves the pictures of the page. Declared in pictures.h. */
#include "lab/page/pictures.h"
#include <ctype.h>
#include <math.h>
#include <string.h>
#include "lab/page/page.h"

int pictures_save(const kit_image *image, const char *names, int srgb, const char *out, const char *slug,
                  const char *ending, kit_error *err)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s%s", out, slug, ending);
    return strstr(ending, ".exr") ? kit_exr_write(image, path, err) : kit_png_write(image, names, srgb, path, err);
}

void pictures_slug(char slug[64], const char *label)
{
    size_t n = 0;
    for (; *label && n < 63; ++label)
        if (isalnum((unsigned char)*label)) slug[n++] = (char)tolower((unsigned char)*label);
        else if (n && slug[n - 1] != '-') slug[n++] = '-';
    slug[n] = 0;
}

int pictures_exposed(kit_image *out, const kit_image *picture, float exposure, const int *crop, int times,
                     kit_error *err)
{
    static const char *const names[3] = { "R", "G", "B" };
    static const float weight[3] = { 0.2126f, 0.7152f, 0.0722f };
    const int all[4] = { 0, 0, picture->width, picture->height };
    size_t i = 0;
    if (!crop) crop = all;
    if (kit_image_new(out, crop[2] * times, crop[3] * times, "R,G,B,Y", err)) return -1;
    for (int y = 0; y < out->height; ++y)
        for (int x = 0; x < out->width; ++x, ++i)
            for (size_t c = 0; c < 3; ++c) {
                const int at = (crop[1] + y / times) * picture->width + crop[0] + x / times;
                const float v = exposure * kit_image_channel(picture, picture->channels > 1 ? names[c] : "Y")[at];
                out->data[c * (size_t)out->width * (size_t)out->height + i] = v;
                out->data[3 * (size_t)out->width * (size_t)out->height + i] += weight[c] * v;
            }
    return 0;
}

int pictures_difference(const kit_image *picture, const kit_image *truth, float range, const char *out,
                        const char *slug, kit_error *err)
{
    kit_image difference;
    if (kit_image_difference(&difference, picture, truth, "Y", range, err)
        || pictures_save(&difference, "R,G,B", 0, out, slug, "-difference.png", err))
        return -1;
    kit_image_free(&difference);
    return 0;
}

int pictures_crops(FILE *f, const char *out, const pictured *p, int count, int k, const int *crop, float exposure,
                   int times, kit_error *err)
{
    for (int i = 0; i < count; ++i) {
        kit_image part;
        char name[160];
        snprintf(name, sizeof name, "%s-crop%s", p[i].slug, k ? "-2" : "");
        if (pictures_exposed(&part, p[i].picture, exposure, crop, times, err)
            || pictures_save(&part, "R,G,B", p[i].picture->channels > 1, out, name, ".png", err))
            return -1;
        page_figure(f, name, p[i].label, "", part.width, part.height, 0);
        kit_image_free(&part);
    }
    return 0;
}

/* Shrinks a picture to at most most pixels in width: means over blocks of at least least pixels, without unknown
   ones. */
static int shrunk(kit_image *out, const kit_image *picture, const char *names, int most, int least, kit_error *err)
{
    const int fits = (picture->width + most - 1) / most, block = fits > least ? fits : least;
    if (kit_image_new(out, picture->width / block, picture->height / block, names, err)) return -1;
    for (int c = 0; c < out->channels; ++c) {
        const float *from = kit_image_channel(picture, out->name[c]);
        float *to = kit_image_channel(out, out->name[c]);
        for (int i = 0; i < out->width * out->height; ++i) {
            int known = 0;
            for (int k = 0; k < block * block; ++k) {
                const int x = i % out->width * block + k % block, y = i / out->width * block + k / block;
                const float v = from[y * picture->width + x];
                if (isnan(v)) continue;
                to[i] += v;
                ++known;
            }
            to[i] /= (float)known;
        }
    }
    return 0;
}

int pictures_thumb(FILE *f, const char *out, const char *slug, const char *label, const char *note, const stage *s,
                   const kit_image *picture, kit_error *err)
{
    const char *const names = s->lit ? "R,G,B" : "Y";
    kit_image bright = { 0 }, small;
    if (s->lit && pictures_exposed(&bright, picture, s->lit->exposure, NULL, 1, err)) return -1;
    if (shrunk(&small, s->lit ? &bright : picture, names, 320, s->stride, err)
        || pictures_save(&small, names, s->lit != NULL, out, slug, ".png", err))
        return -1;
    page_figure(f, slug, label, note, small.width, small.height, 0);
    kit_image_free(&bright);
    kit_image_free(&small);
    return 0;
}
