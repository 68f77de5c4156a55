/* sheets.h - what rows of the papers' tables and figures cost, of which a paper has times. */
#ifndef COST_SHEETS_H
#define COST_SHEETS_H

#include "lab/cost/passes.h"

/* A chain a row, or a pass of one; their milliseconds, as examples/lab/papers/modelled.csv has them. */
int  sheets_add(work *w, kit_error *err);
void sheets_write(FILE *f, const work *w);

#endif
