/* curve.c - makes the curves of a sweep. Declared in curve.h. */
#include "lab/stability/curve.h"
#include <math.h>
#include <string.h>

curve *curve_new(result *r, const char *label, int method)
{
    curve *c = &r->curve[r->curves++];
    memset(c, 0, sizeof *c);
    c->label = label;
    c->method = method;
    c->number = c->at = (double)NAN;
    for (int i = 0; i < CURVE_POINTS; ++i) c->y[i] = (double)NAN;
    return c;
}

void curve_raise(curve *c, double v, double at)
{
    if (!(v > c->number)) return;
    c->number = v;
    c->at = at;
}
