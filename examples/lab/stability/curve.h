/* curve.h - what a sweep gives: a figure of each method at each value, and what they come to. */
#ifndef LAB_CURVE_H
#define LAB_CURVE_H

#include "lab/stability/sweeps.h"

enum { MOST_CURVES = MOST_METHODS + 1, CURVE_POINTS = 256 };
/* method: which it is; else one of these: not one of them; what they are seen beside */
enum { NO_METHOD = -1, BESIDE = -2 };
typedef struct curve {
    const char *label;
    int       method;
    double    y[CURVE_POINTS], number, at; /* number: what it all comes to; at: where */
    kit_image worst;                       /* the frame there, the truth, what is wrong */
} curve;
struct result { const cause *cause; double x[CURVE_POINTS]; int points, curves; curve curve[MOST_CURVES]; };

/* Another curve, of which nothing is known. */
curve *curve_new(result *r, const char *label, int method);
/* The number becomes v, and at its place, if it is smaller. */
void   curve_raise(curve *c, double v, double at);

#endif
