/* lit.h - light: the demo's pictures; error against time, what is hidden, harmonics, bands. _text: the same rows as
   text. Writes chart-lit.csv. */
#ifndef LAB_LIT_H
#define LAB_LIT_H

#include "lab/page/units.h"

int  lit_demo(FILE *record, const char *out, kit_error *err);
void lit_demo_text(FILE *f);
int  lit_units(const options *o);
int  lit_chart(FILE *record, const options *o, kit_error *err);
void lit_chart_text(FILE *f);

#endif
