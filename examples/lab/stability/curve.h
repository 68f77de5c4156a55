/* curve.h - the result of a sweep: a curve of figures for each method, and the one number that sums it up. */
#ifndef LAB_CURVE_H
#define LAB_CURVE_H

#include "lab/stability/sweeps.h"

enum { MOST_CURVES = MOST_METHODS + 1, CURVE_POINTS = 256 };
/* method: its index; NO_METHOD: not of one; BESIDE: the reference that methods are seen beside */
enum { NO_METHOD = -1, BESIDE = -2 };
typedef struct curve {
    const char *label;
    int       method;
    double    y[CURVE_POINTS], number, at; /* number: the curve's summary; at: the value where it lies */
    kit_image worst;                       /* at that value: the frame, the truth, their difference */
} curve;
struct result { const cause *cause; double x[CURVE_POINTS]; int points, curves; curve curve[MOST_CURVES]; };

/* Adds a curve without results. */
curve *curve_new(result *r, const char *label, int method);
/* Raises the number to v, if it is smaller, and notes its place. */
void   curve_raise(curve *c, double v, double at);

#endif
