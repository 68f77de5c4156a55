/* seeds.h - scenes drawn from seeds: every row of ambient occlusion's and of light's tables on as many as one likes,
   without times. Seeds below SEEDS_JUDGED may be looked at while settings are tuned; those from there on only report.
   Writes seeds.csv; of seeds to tune on seeds-fit.csv. */
#ifndef LAB_SEEDS_H
#define LAB_SEEDS_H

#include "lab/page/units.h"

enum { SEEDS_JUDGED = 1000 };

int  seeds_units(const options *o);          /* 0: no row is of a method that is asked for */
/* Measures units in processes of their own, one a core, before this one has a GL context: seeds_chart then finds them
   measured. */
int  seeds_ahead(const options *o, kit_error *err);
int  seeds_chart(FILE *record, const options *o, kit_error *err);
void seeds_text(FILE *f);

#endif
