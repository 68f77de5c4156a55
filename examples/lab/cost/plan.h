/* plan.h - the costs of the plan's choices on a GPU, in the plan's unit: an unblurred ssao of 16 samples. */
#ifndef COST_PLAN_H
#define COST_PLAN_H

#include <stdio.h>
#include "lab/cost/passes.h"

/* Adds chains: that of the unit, and that of every choice that needs neither surfels nor fields. */
int  plan_add(work *w, kit_error *err);
/* Writes a line for each choice, as build/fit reads it: its weighed cost on the first device, over that of the unit. */
void plan_write(FILE *f, const work *w);

#endif
