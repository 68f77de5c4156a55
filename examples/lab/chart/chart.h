/* chart.h - the sections of report.c's demo and charts. Each section names its csv. */
#ifndef LAB_CHART_H
#define LAB_CHART_H

#include "lab/chart/section.h"

/* The sections of the demo and of the charts: ambient occlusion, light, fields, deep screen space. ao_chart has all
   scenes and other libraries' effects; ao_entries is how many of its rows are asked for. */
extern const section ao_demo, lit_demo, fields_demo, deep_demo;
extern const section ao_chart, lit_chart, fields_chart, deep_chart;
int  ao_entries(const options *o);
void ao_demo_of(const char *path);            /* shows the mesh at path instead of the demo's own */
/* Charts of light on every pair of a scene and a probe, and of scenes by seed and models. */
extern const section pairs_chart, seeds_chart;
/* Measures the scenes by seed in one process a core, before there is a GL context, and keeps the results. */
int seeds_ahead(const options *o, kit_error *err);

/* plan_chart measures the plan on views that it was not fitted on and writes plan.csv and plan-summary.csv; plan_fit
   writes plan-fit.csv, which build/fit reads. plan_ahead measures the scenes by seed
   that judge the plan, and plan_fit_ahead those that fit it, in one process a core. */
int  plan_ahead(const options *o, kit_error *err);
int  plan_chart(FILE *record, const options *o, kit_error *err);
int  plan_fit_ahead(const options *o, kit_error *err);
int  plan_fit(const options *o, kit_error *err);

#endif
