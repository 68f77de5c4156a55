/* plan.h - the plan on views that it was not fitted on, and what it is fitted to. Writes plan.csv, plan-numbers.csv and
   plan-summary.csv; the fit's plan-fit.csv. */
#ifndef LAB_PLAN_H
#define LAB_PLAN_H

#include "lab/page/units.h"

/* What is measured before there is a context: of the seeds that fit, of those that judge. */
int  plan_fit_ahead(const options *o, kit_error *err);
int  plan_ahead(const options *o, kit_error *err);
int  plan_fit(const char *out, kit_error *err);
int  plan_chart(FILE *record, const options *o, kit_error *err);
void plan_text(FILE *f);

#endif
