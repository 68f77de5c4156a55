/* hdr.c - Radiance's .hdr in. Declared in kit.h. */
#include "kit/kit_image.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Radiance's format: lines of text, an empty one, the size, then a row after the other of three mantissas and an
   exponent a pixel, flat or each of the four in runs. Not through stb, which takes missing bytes for zeros, makes room
   for whatever a header claims, and has the picture twice. */
typedef struct hdr_source { FILE *file; int left; char line[64]; } hdr_source;

static const char hdr_short[] = "the file ends too early";

/* The header's next line, as much of it as fits; NULL, or what is wrong. */
static const char *hdr_line(hdr_source *s)
{
    size_t length = 0;
    for (int c; (c = getc_unlocked(s->file)) != '\n';) {
        if (c == EOF) return hdr_short;
        if (!s->left--) return "its header does not end within a megabyte";
        if (length + 1 < sizeof s->line) s->line[length++] = (char)c;
    }
    s->line[length] = 0;
    return NULL;
}

static const char *hdr_header(hdr_source *s, int *width, int *height)
{
    const char *wrong = hdr_line(s);
    int known = 0, end = 0;
    if (strcmp(s->line, "#?RADIANCE") && strcmp(s->line, "#?RGBE")) return "is not a Radiance HDR picture";
    while (!wrong && !(wrong = hdr_line(s)) && s->line[0]) known |= !strcmp(s->line, "FORMAT=32-bit_rle_rgbe");
    if (wrong) return wrong;
    if (!known) return "its header must say FORMAT=32-bit_rle_rgbe";
    if ((wrong = hdr_line(s)) != NULL) return wrong;
    if (sscanf(s->line, "-Y %7d +X %7d%n", height, width, &end) != 2 || s->line[end])
        return "its size must be -Y HEIGHT +X WIDTH";
    return NULL;
}

/* Whether rows of such a width may be in runs. */
static int hdr_coded(int width) { return width >= 8 && width < 32768; }

/* The fewest bytes of a row: runs are of 127 at most, in two bytes. */
static double hdr_fewest(int width)
{
    return hdr_coded(width) ? fmin(4.0 * width, 4 + 4 * 2 * ceil(width / 127.0)) : 4.0 * width;
}

static const char *hdr_row(FILE *file, unsigned char (*row)[4], int width)
{
    const size_t pixels = (size_t)width;
    if (fread(row, 4, 1, file) != 1) return hdr_short;
    if (!hdr_coded(width) || row[0][0] != 2 || row[0][1] != 2 || row[0][2] > 127) {
        const size_t got = 1 + fread(row + 1, 4, pixels - 1, file);
        for (size_t x = 0; x < got; ++x)
            if (row[x][0] == 1 && row[x][1] == 1 && row[x][2] == 1) return "its old way of runs is not supported";
        return got < pixels ? hdr_short : NULL;
    }
    if ((row[0][2] << 8 | row[0][3]) != width) return "a row has another width than the picture";
    for (int c = 0; c < 4; ++c)
        for (int x = 0; x < width;) {
            int count = getc_unlocked(file), value = 0;
            const int run = count > 128;
            if (run) count -= 128;
            if (count == EOF) return hdr_short;
            if (!count || count > width - x) return "a run does not fit its row";
            for (int k = 0; k < count; ++k) {
                if (!run || !k) value = getc_unlocked(file);
                if (value == EOF) return hdr_short;
                row[x++][c] = (unsigned char)value;
            }
        }
    return NULL;
}

static const char *hdr_pixels(FILE *file, kit_image *image)
{
    const size_t width = (size_t)image->width, n = kit_image_pixels(image);
    unsigned char (*row)[4] = malloc(4 * width);
    const char *wrong = row ? NULL : "there is not enough memory for it";
    for (size_t i = 0; i < n && !wrong; i += width) {
        wrong = hdr_row(file, row, image->width);
        for (size_t x = 0; x < width && !wrong; ++x) {
            const float unit = row[x][3] ? ldexpf(1, row[x][3] - 128 - 8) : 0;
            for (size_t c = 0; c < 3; ++c) image->data[c * n + i + x] = row[x][c] * unit;
        }
    }
    free(row);
    return wrong;
}

int kit_hdr_read(kit_image *image, const char *path, kit_error *err)
{
    hdr_source source = { .left = 1 << 20 };
    kit_image new_ = { 0 };
    size_t size;
    int width, height, failed = 0;
    if (!(source.file = kit_file_open(&size, path, err))) return -1;
    const char *wrong = hdr_header(&source, &width, &height);
    if (!wrong && hdr_fewest(width) * height > (double)size)
        failed = kit_fail(err, "%s: its header claims %d x %d pixels, which its %zu bytes cannot hold", path, width,
                          height, size);
    if (!wrong && !failed) failed = kit_image_alloc(&new_, width, height, 3, path, err);
    for (int c = 0; c < 3; ++c) new_.name[c][0] = "RGB"[c];
    if (!wrong && !failed) wrong = hdr_pixels(source.file, &new_);
    fclose(source.file);
    if (wrong) failed = kit_fail(err, "%s: %s", path, wrong);
    if (failed) kit_image_free(&new_);
    else *image = new_;
    return failed;
}
