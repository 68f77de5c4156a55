/* compared.h - how far one picture is from another: RMSE, bias, and whether the difference has a shape. */
#ifndef LAB_COMPARED_H
#define LAB_COMPARED_H

#include "kit/kit.h"

/* The statistics of the difference a - b. values: how many are compared; rmse is NAN if one of them is no number.
   across, down: the autocorrelation of the difference at lags of compared_lag pixels; patches: the correlation between
   the means of neighbouring 8x8 patches; 0 if the difference is the same everywhere. Filtered noise correlates with
   itself a few pixels away, but its means over patches do not. A change of shapes lasts from patch to patch. */
enum { COMPARED_LAGS = 2, COMPARED_PATCH = 8 };
extern const int compared_lag[COMPARED_LAGS];
typedef struct compared {
    size_t values;
    double rmse, bias, across[COMPARED_LAGS], down[COMPARED_LAGS], patches;
} compared;

/* Compares a and b at the pixels at which mask is above 0 (NULL: at all), over all of their channels together. */
int compared_of(compared *out, const kit_image *a, const kit_image *b, const char *const *channels, int count,
                const float *mask, kit_error *err);

/* The RMSE of two pictures against the truth, and the standard error of the difference between the two RMSE, if the
   compared pixels are a random sample of the picture: another pattern of noise would change it by as much. */
typedef struct errors {
    double rmse[2], doubt;
} errors;
int errors_of(errors *out, const kit_image *const picture[2], const kit_image *truth, const char *const *channels,
              int count, const float *mask, kit_error *err);

#endif
