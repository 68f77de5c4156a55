/* kit_image.h - what image.c, exr.c, hdr.c, png.c and score.c share. Private to them. */
#ifndef KIT_IMAGE_H
#define KIT_IMAGE_H

#include "kit/kit.h"

enum { KIT_ZIP_LEVEL = 4 };                /* a few per cent larger than zlib's own 6, twice as fast */

/* A file that is written in memory before it is one. */
typedef struct kit_memory_file { char *data; size_t size, capacity; } kit_memory_file;

/* Room for pixels, all 0, without names; what: whose size it is, for the error. */
int kit_image_alloc(kit_image *image, int width, int height, int channels, const char *what, kit_error *err);

static inline size_t kit_image_pixels(const kit_image *image) { return (size_t)image->width * (size_t)image->height; }

#endif
