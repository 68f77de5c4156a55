/* pairs.h - light on every pair of a scene and a probe. Writes chart-pairs.csv. */
#ifndef LAB_PAIRS_H
#define LAB_PAIRS_H

#include "lab/page/units.h"

int  pairs_units(const options *o);
int  pairs_chart(FILE *record, const options *o, kit_error *err);
void pairs_text(FILE *f, const options *o);

#endif
