/* compared.h - how far one picture is from another: by how much, which way, and whether what differs has a shape. */
#ifndef LAB_COMPARED_H
#define LAB_COMPARED_H

#include "kit/kit.h"

/* Of a less b. values: how many were compared. A value that is no number makes rmse none.
   across, down: the autocorrelation of what differs, so many pixels to the right and down; patches: that of its means
   over 8x8 pixels, from one to the next ones. All 0 where nothing differs, or all by the same. Noise that a filter has
   spread is like itself a few pixels away, and its pattern repeats: only means over patches are independent, whatever
   the noise. What a change does to places of a picture lasts from patch to patch. */
enum { COMPARED_LAGS = 2, COMPARED_PATCH = 8 };
extern const int compared_lag[COMPARED_LAGS];
typedef struct compared {
    size_t values;
    double rmse, bias, across[COMPARED_LAGS], down[COMPARED_LAGS], patches;
} compared;

/* Where mask is above 0 (NULL: everywhere); count channels together. */
int compared_of(compared *out, const kit_image *a, const kit_image *b, const char *const *channels, int count,
                const float *mask, kit_error *err);

/* What two pictures err by, and the standard error of the difference of the two, where the pixels that are compared are
   a sample of the picture. Others of the noise as good would move it as much. */
typedef struct errors {
    double rmse[2], doubt;
} errors;
int errors_of(errors *out, const kit_image *const picture[2], const kit_image *truth, const char *const *channels,
              int count, const float *mask, kit_error *err);

#endif
