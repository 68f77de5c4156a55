/* image.c - makes float images and finds their channels. exr.c, hdr.c and png.c read and write them, score.c compares
   them. */
#include "kit/kit_image.h"
#include <stdlib.h>
#include <string.h>

int kit_image_alloc(kit_image *image, int width, int height, int channels, const char *what, kit_error *err)
{
    size_t pixels = (size_t)(width > 0 ? width : 0) * (size_t)(height > 0 ? height : 0);
    if (width <= 0 || height <= 0 || width > 65536 || height > 65536 || pixels > ((size_t)1 << 30) / (size_t)channels)
        return kit_fail(err, "%s: a picture of %d x %d with %d channels is not supported", what, width, height,
                        channels);
    float *data = calloc(pixels * (size_t)channels, sizeof *data);
    if (!data)
        return kit_fail(err, "%s: no memory for a picture of %d x %d with %d channels", what, width, height, channels);
    memset(image, 0, sizeof *image);
    image->width = width;
    image->height = height;
    image->channels = channels;
    image->data = data;
    return 0;
}

int kit_image_new(kit_image *image, int width, int height, const char *names, kit_error *err)
{
    char   name[KIT_MAX_CHANNELS][32] = {{0}};
    int    channels = 0;
    for (const char *p = names;; ++p) {
        size_t length = strcspn(p, ",");
        if (length == 0 || length >= sizeof name[0] || channels == KIT_MAX_CHANNELS)
            return kit_fail(err, "channels \"%s\": at most %d names of 1 to 31 characters, separated by commas", names,
                            KIT_MAX_CHANNELS);
        memcpy(name[channels], p, length);
        for (int c = 0; c < channels; ++c)
            if (!strcmp(name[c], name[channels]))
                return kit_fail(err, "channels \"%s\": %s comes twice", names, name[c]);
        ++channels;
        p += length;
        if (!*p) break;
    }
    if (kit_image_alloc(image, width, height, channels, "new picture", err)) return -1;
    memcpy(image->name, name, sizeof name);
    return 0;
}

void kit_image_free(kit_image *image)
{
    free(image->data);
    memset(image, 0, sizeof *image);
}

float *kit_image_channel(const kit_image *image, const char *name)
{
    for (int c = 0; c < image->channels; ++c)
        if (!strcmp(image->name[c], name)) return image->data + (size_t)c * kit_image_pixels(image);
    return NULL;
}
