/* fields.h - ambient occlusion fields: the demo's pictures; error against memory, costs, bakes, two occluders. Writes
   chart-aof.csv. */
#ifndef LAB_FIELDS_H
#define LAB_FIELDS_H

#include "lab/page/units.h"

int  fields_demo(FILE *record, const char *out, kit_error *err);
void fields_demo_text(FILE *f);
int  fields_units(const options *o);
int  fields_chart(FILE *record, const options *o, kit_error *err);
void fields_chart_text(FILE *f);

#endif
