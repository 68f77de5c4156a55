/* ao.h - ambient occlusion: the demo's pictures, and the chart of it on all scenes, with what others have beside it.
   Writes chart.csv. */
#ifndef LAB_AO_H
#define LAB_AO_H

#include "lab/measure/stage.h"
#include "lab/page/units.h"

/* The demo's scene, its truth and methods: measured, for the page after that, and for strip.h. */
int  ao_demo_measure(stage *s, const options *o, kit_error *err);
int  ao_demo(FILE *record, const stage *s, const char *out, kit_error *err);
void ao_demo_text(FILE *f);

int  ao_entries(const options *o);            /* how many rows are asked for */
int  ao_units(const options *o);
int  ao_chart(FILE *record, const options *o, kit_error *err);
void ao_text(FILE *f);

#endif
