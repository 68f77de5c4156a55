/* png.c - writes PNG by stb, and holds stb's readers, which hdr.c and texture.c also use. Declared in kit.h. */
#include "kit/kit_image.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <zlib.h>

/* Compresses a PNG's bytes by zlib: stb's own function ends the program if memory runs out. */
static unsigned char *png_deflate(unsigned char *data, int size, int *packed, int level)
{
    uLongf bytes = compressBound((uLong)size);
    unsigned char *out = malloc(bytes);
    (void)level;
    if (out && compress2(out, &bytes, data, (uLong)size, KIT_ZIP_LEVEL) != Z_OK) {
        free(out);
        out = NULL;
    }
    *packed = (int)bytes;
    return out;
}

#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#pragma GCC diagnostic ignored "-Wdouble-promotion"
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wmissing-field-initializers"
#endif
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG                      /* PNG is read for textures, and for tests that read written files back */
#define STBI_ONLY_JPEG
#define STBI_ONLY_TGA
#define STBI_ONLY_BMP
#define STBI_ONLY_HDR
#define STBI_NO_STDIO
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#define STBIW_ZLIB_COMPRESS png_deflate
#include <stb/stb_image_write.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

static void png_append(void *user, void *data, int size)
{
    kit_memory_file *file = user;              /* stb calls this function once, with the whole file */
    file->data = malloc((size_t)size);
    if (!file->data) return;
    memcpy(file->data, data, (size_t)size);
    file->size = (size_t)size;
}

int kit_png_write(const kit_image *image, const char *names, int srgb, const char *path, kit_error *err)
{
    const float *from[3] = { NULL };
    int channels = 0;
    for (const char *p = names;; ++p) {
        size_t length = strcspn(p, ",");
        char name[32] = { 0 };
        memcpy(name, p, length < 31 ? length : 31);
        if (channels == 3) return kit_fail(err, "%s: a PNG takes 1 or 3 channels, not \"%s\"", path, names);
        if (!(from[channels++] = kit_image_channel(image, name)))
            return kit_fail(err, "%s: the picture has no channel %s", path, name);
        p += length;
        if (!*p) break;
    }
    if (channels == 2) return kit_fail(err, "%s: a PNG takes 1 or 3 channels, not \"%s\"", path, names);
    size_t n = kit_image_pixels(image), k = (size_t)channels;
    kit_memory_file file = { 0 };
    unsigned char *bytes = malloc(n * k);
    for (size_t i = 0; bytes && i < n * k; ++i) {
        double v = (double)from[i % k][i / k];
        v = v > 0 ? fmin(v, 1) : 0;        /* NaN becomes 0 */
        if (srgb) v = v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055;
        bytes[i] = (unsigned char)(255 * v + 0.5);
    }
    if (bytes)
        stbi_write_png_to_func(png_append, &file, image->width, image->height, channels, bytes,
                               image->width * channels);
    free(bytes);
    int failed = file.data ? kit_file_write(path, file.data, file.size, err)
                           : kit_fail(err, "%s: no memory to write a PNG", path);
    free(file.data);
    return failed;
}
