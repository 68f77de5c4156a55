/* plan.h - what the plan's choices cost a GPU, in the plan's unit: an unblurred ssao of 16 samples. */
#ifndef COST_PLAN_H
#define COST_PLAN_H

#include <stdio.h>
#include "lab/cost/passes.h"

/* The unit and every choice that needs neither surfels nor fields, as chains. */
int  plan_add(work *w, kit_error *err);
/* Of the first device, weighed: lines as build/fit reads them, a choice and its cost. */
void plan_write(FILE *f, const work *w);

#endif
