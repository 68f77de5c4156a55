/* chart.h - what report.c's demo and charts are made of. A section's csv is named in it. */
#ifndef LAB_CHART_H
#define LAB_CHART_H

#include "lab/chart/section.h"

/* Ambient occlusion, light, fields, deep screen space: the demo's, the chart's. ao_chart: on all scenes, with what
   others have beside it; its entries are how many rows are asked for. */
extern const section ao_demo, lit_demo, fields_demo, deep_demo;
extern const section ao_chart, lit_chart, fields_chart, deep_chart;
int  ao_entries(const options *o);
void ao_demo_of(const char *path);            /* another mesh than the demo's own */
/* Light on every pair of a scene and a probe; scenes by seed and models. */
extern const section pairs_chart, seeds_chart;
/* Measures seeds, a process a core, before there is a context, and keeps them. */
int seeds_ahead(const options *o, kit_error *err);

/* One frame alone beside the last of sixteen, while the camera turns: of the demo. */
int strip_demo(FILE *record, const options *o, kit_error *err);

/* The plan on views that it was not fitted on: plan.csv, plan-seeds.csv, plan-numbers.csv, plan-summary.csv; and what
   it is fitted to: plan-fit.csv. ahead: as seeds_ahead, of the seeds that judge, of those that fit. */
int  plan_ahead(const options *o, kit_error *err);
int  plan_chart(FILE *record, const options *o, kit_error *err);
void plan_text(FILE *f);
int  plan_fit_ahead(const options *o, kit_error *err);
int  plan_fit(const char *out, kit_error *err);

#endif
