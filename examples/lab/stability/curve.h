/* curve.h - the result of a sweep: a curve of figures for each method, and the one number that sums it up. */
#ifndef LAB_CURVE_H
#define LAB_CURVE_H

#include "lab/stability/sweeps.h"

enum { MOST_CURVES = MOST_METHODS + 1, CURVE_POINTS = 256 };
/* a curve's method: its index, or none, or the reference that methods are seen beside */
enum { NO_METHOD = -1, BESIDE = -2 };
typedef struct curve {
    const char *label;
    int       method;
    double    y[CURVE_POINTS], number, at; /* number: the curve's summary; at: the cause's value where it lies */
    kit_image worst;                       /* the frame at that value, its truth, and their difference */
} curve;
struct result { const cause *cause; double x[CURVE_POINTS]; int points, curves; curve curve[MOST_CURVES]; };

/* Adds a curve without points to a result. Returns it. */
curve *curve_new(result *r, const char *label, int method);
/* Raises the curve's number to v, if it is smaller, and notes the value at which it lies. */
void   curve_raise(curve *c, double v, double at);

#endif
