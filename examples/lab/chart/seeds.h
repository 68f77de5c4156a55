/* seeds.h - scenes that nobody picked, at the size at which people look: visibility, light and one bounce by methods,
   and visibility by other libraries, without times. Half of the scenes are seeds from SEEDS_JUDGED on, which only
   report, half are drawn from the commit's hash; models of packages stand beside them. --from: seeds from there on
   instead; those below SEEDS_JUDGED may be looked at while settings are tuned. Writes seeds.csv; of seeds to tune on
   seeds-fit.csv. */
#ifndef LAB_SEEDS_H
#define LAB_SEEDS_H

#include "lab/measure/stage.h"
#include "lab/page/units.h"

int  seeds_units(const options *o);          /* 0: no row is of a method that is asked for */
/* Measures units in processes of their own, one a core, before this one has a GL context: seeds_chart then finds them
   measured. */
int  seeds_ahead(const options *o, kit_error *err);
int  seeds_chart(FILE *record, const options *o, kit_error *err);
void seeds_text(FILE *f);

#endif
