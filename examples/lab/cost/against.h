/* against.h - what has changed since a csv was written. */
#ifndef COST_AGAINST_H
#define COST_AGAINST_H

#include "lab/measure/csv.h"
#include "kit/kit.h"

/* What cost-record keeps of the lines of whole chains. */
#define RECORDED_KEYS "family,driver,chain,pass,busy,calm,weighed,weighed 16x4,transcendental_busy,vgprs"

/* Prints the chains that have changed beside those of a file that write_costs wrote, or of what is recorded. */
int against_show(const csv *now, const char *path, kit_error *err);
/* For CI: prints what is wrong, a line each, and returns how much that is: spilled registers, scratch; more than 128
   registers, unless the file has them; 3 % more instructions than the file has. Of another compiler nothing is. */
int against_check(const csv *now, const char *path, kit_error *err);

#endif
