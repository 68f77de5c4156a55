/* maths.h - sweeps of CPU functions alone: a sun as harmonics that rings, a field's hull, surfels that pop. */
#ifndef LAB_MATHS_H
#define LAB_MATHS_H

#include "lab/stability/curve.h"

int maths_ringing_open(result *r, kit_error *err);
int maths_ringing_in_shade(result *r, kit_error *err);
int maths_hull(result *r, kit_error *err);
int maths_hull_steps(result *r, kit_error *err);
int maths_popping(result *r, kit_error *err);

#endif
