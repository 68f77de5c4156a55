/* against.h - what has changed since a csv was written. */
#ifndef COST_AGAINST_H
#define COST_AGAINST_H

#include "lab/cost/show.h"

/* Prints the chains that have changed beside those of a file that write_costs or write_recorded wrote. */
int against_show(const work *w, const char *path, kit_error *err);
/* For CI: prints what is wrong, a line each, and returns how much that is: spilled registers, scratch; more than 128
   registers, unless the file has them; 3 % more instructions than the file has. Of another compiler nothing is. */
int against_check(const work *w, const char *path, kit_error *err);

#endif
