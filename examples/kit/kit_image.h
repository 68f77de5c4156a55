/* kit_image.h - shared by image.c, exr.c, hdr.c, png.c and score.c. Private to them. */
#ifndef KIT_IMAGE_H
#define KIT_IMAGE_H

#include "kit/kit.h"

enum { KIT_ZIP_LEVEL = 4 };            /* of zlib in EXR files: twice as fast as level 6, files a few per cent larger */

/* A file that is built in memory before it is written. */
typedef struct kit_memory_file { char *data; size_t size, capacity; } kit_memory_file;

/* Allocates pixels, all 0, without channel names. what: what has this size, for the error message. */
int kit_image_alloc(kit_image *image, int width, int height, int channels, const char *what, kit_error *err);

static inline size_t kit_image_pixels(const kit_image *image) { return (size_t)image->width * (size_t)image->height; }

#endif
