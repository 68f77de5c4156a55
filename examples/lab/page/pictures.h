/* pictures.h - exposes, shrinks and saves the pictures of the page. */
#ifndef LAB_PICTURES_H
#define LAB_PICTURES_H

#include <stdio.h>
#include "lab/measure/stage.h"

/* Writes out/slug.ending as PNG or EXR, by the ending; names and srgb: see kit_png_write. */
int pictures_save(const kit_image *image, const char *names, int srgb, const char *out, const char *slug,
                  const char *ending, kit_error *err);
void pictures_slug(char slug[64], const char *label);
/* Cuts a picture's crop (NULL: all), enlarged so many times: exposed R, G, B (of a picture of one channel: grey), and
   their luminance Y. */
int pictures_exposed(kit_image *out, const kit_image *picture, float exposure, const int *crop, int times,
                     kit_error *err);
/* Writes a picture's difference to the truth in channel Y as colours: out/slug-difference.png. */
int pictures_difference(const kit_image *picture, const kit_image *truth, float range, const char *out,
                        const char *slug, kit_error *err);

/* A picture in a row of pictures, with its name and its label on the page. */
typedef struct pictured { char slug[128]; const char *label; const kit_image *picture; } pictured;
/* Shows a row of pictures: the k-th crop of each, exposed, enlarged so many times, as R, G, B. */
int pictures_crops(FILE *f, const char *out, const pictured *p, int count, int k, const int *crop, float exposure,
                   int times, kit_error *err);

/* Shows a stage's picture, shrunk to at most 320 pixels in width, and no finer than its truth. */
int pictures_thumb(FILE *f, const char *out, const char *slug, const char *label, const char *note, const stage *s,
                   const kit_image *picture, kit_error *err);

#endif
