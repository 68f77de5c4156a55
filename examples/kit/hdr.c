/* hdr.c - reads Radiance's .hdr by stb. Declared in kit.h. */
#include "kit/kit_image.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <stb/stb_image.h>

/* At the end of a file stb reads zeros, and as run lengths it would read these for ever. So pixel bytes beyond the end
   are 255, a run that soon fills a row. That the end was reached is then an error. */
typedef struct hdr_source { FILE *file; int pixels, ended; } hdr_source;

static int hdr_more(void *user, char *data, int size)
{
    hdr_source *s = user;
    const size_t got = fread(data, 1, (size_t)size, s->file);
    s->ended |= !got;
    if (got || !s->pixels) return (int)got;
    memset(data, 255, (size_t)size);
    return size;
}

static void hdr_skip(void *user, int count) { fseek(((hdr_source *)user)->file, count, SEEK_CUR); }

static int hdr_ended(void *user) { return ((hdr_source *)user)->ended; }

static const stbi_io_callbacks hdr_calls = { hdr_more, hdr_skip, hdr_ended };

/* Returns the least number of bytes of a row: a run has at most 127 values, in two bytes. */
static double hdr_fewest(int width)
{
    const int coded = width >= 8 && width < 32768;
    return coded ? fmin(4.0 * width, 4 + 4 * 2 * ceil(width / 127.0)) : 4.0 * width;
}

static const char *hdr_pixels(hdr_source *s, kit_image *image)
{
    const size_t n = kit_image_pixels(image);
    int width, height, channels;
    rewind(s->file);
    s->pixels = 1;
    float *rgb = stbi_loadf_from_callbacks(&hdr_calls, s, &width, &height, &channels, 3);
    for (size_t i = 0; i < n && rgb; ++i)
        for (size_t c = 0; c < 3; ++c) image->data[c * n + i] = rgb[3 * i + c];
    free(rgb);
    return s->ended ? "the file ends too early" : rgb ? NULL : stbi_failure_reason();
}

int kit_hdr_read(kit_image *image, const char *path, kit_error *err)
{
    hdr_source source = { NULL, 0, 0 };
    kit_image new_ = { 0 };
    size_t size;
    int width, height, channels, failed = 0;
    const char *wrong = NULL;
    if (!(source.file = kit_file_open(&size, path, err))) return -1;
    if (!stbi_is_hdr_from_callbacks(&hdr_calls, &source)) wrong = "is not a Radiance HDR picture";
    rewind(source.file);
    if (!wrong && !stbi_info_from_callbacks(&hdr_calls, &source, &width, &height, &channels))
        wrong = "its header is none of Radiance's: FORMAT=32-bit_rle_rgbe, -Y HEIGHT +X WIDTH";
    if (!wrong && hdr_fewest(width) * height > (double)size)
        failed = kit_fail(err, "%s: its header claims %d x %d pixels, which its %zu bytes cannot hold", path, width,
                          height, size);
    if (!wrong && !failed) failed = kit_image_alloc(&new_, width, height, 3, path, err);
    for (int c = 0; c < 3; ++c) new_.name[c][0] = "RGB"[c];
    source.ended = 0;
    if (!wrong && !failed) wrong = hdr_pixels(&source, &new_);
    fclose(source.file);
    if (wrong) failed = kit_fail(err, "%s: %s", path, wrong);
    if (failed) kit_image_free(&new_);
    else *image = new_;
    return failed;
}
