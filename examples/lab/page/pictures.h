/* pictures.h - pictures that a page shows: exposed, made smaller, kept beside it. */
#ifndef LAB_PICTURES_H
#define LAB_PICTURES_H

#include <stdio.h>
#include "lab/measure/stage.h"

/* out/slug.ending, whose ending tells PNG (names and srgb as kit_png_write has them) from EXR. */
int pictures_save(const kit_image *image, const char *names, int srgb, const char *out, const char *slug,
                  const char *ending, kit_error *err);
void pictures_slug(char slug[64], const char *label);
/* The part of a picture in crop (NULL: all), each pixel times x times: exposed R, G, B and their luminance Y. */
int pictures_exposed(kit_image *out, const kit_image *picture, float exposure, const int *crop, int times,
                     kit_error *err);
/* The difference of a picture's channel Y to the truth's as colours, out/slug-difference.png. */
int pictures_difference(const kit_image *picture, const kit_image *truth, float range, const char *out,
                        const char *slug, kit_error *err);

/* A picture as a page shows it. */
typedef struct pictured { char slug[128]; const char *label; const kit_image *picture; } pictured;
/* A row of figures: the k-th crop of each, exposed, each pixel times x times, as R, G, B. */
int pictures_crops(FILE *f, const char *out, const pictured *p, int count, int k, const int *crop, float exposure,
                   int times, kit_error *err);

/* A small picture of a stage: no wider than 320 pixels, nor finer than its truth. */
int pictures_thumb(FILE *f, const char *out, const char *slug, const char *label, const char *note, const stage *s,
                   const kit_image *picture, kit_error *err);
/* Small pictures: the truth, the best row of those that take no longer than the reference (else the fastest), the best
   of all. name: of what the page shows them in. */
int pictures_thumbs(FILE *f, const char *out, const char *name, const stage *s, const row *rows,
                    const kit_image *pictures, int count, kit_error *err);

#endif
