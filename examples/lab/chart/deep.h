/* deep.h - deep screen space: the demo's pictures; error against time, choices, a camera that turns or moves, where the
   time goes. Writes chart-deep.csv. */
#ifndef LAB_DEEP_H
#define LAB_DEEP_H

#include "lab/page/units.h"

int  deep_demo(FILE *record, const char *out, kit_error *err);
void deep_demo_text(FILE *f);
int  deep_units(const options *o);
int  deep_chart(FILE *record, const options *o, kit_error *err);
void deep_chart_text(FILE *f);

#endif
