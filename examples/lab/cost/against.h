/* against.h - compares the costs that one run of make cost counts with those of an older csv. */
#ifndef COST_AGAINST_H
#define COST_AGAINST_H

#include "lab/measure/csv.h"
#include "kit/kit.h"

/* The columns of recorded.csv: those that cost-record keeps of the rows of whole chains. */
#define RECORDED_KEYS "family,driver,chain,pass,busy,calm,weighed,weighed 16x4,transcendental_busy,vgprs"

/* Prints the chains whose costs differ from those in path: a csv that write_costs wrote, or recorded.csv. */
int against_show(const csv *now, const char *path, kit_error *err);
/* Checks recorded chains for CI: prints a line for each fault and returns how many there are. Faults are spilled
   registers; scratch memory; more than 128 registers, unless the file has as many; 3 % more instructions than the file
   has. A file of another compiler has no faults. */
int against_check(const csv *now, const char *path, kit_error *err);

#endif
