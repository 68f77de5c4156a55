/* planned.h - the costs and the errors of the plan's choices, measured on views of scenes and on scenes by seed. */
#ifndef LAB_PLANNED_H
#define LAB_PLANNED_H

#include "lab/measure/measure.h"

/* The costs and errors of the plan's choices on one view, under one light. */
typedef struct planned_row {
    char name[64];
    int  timed;                             /* 0: costs are predicted, except those of surfels and fields */
    ssgi_plan_scene numbers;
    ssgi_plan_scene captured;               /* what a captured frame tells: no calibration, no slabs */
    double error[SSGI_PLAN_CHOICES], cost[SSGI_PLAN_CHOICES];   /* NAN: the choice does not apply to this view */
} planned_row;

enum { PLANNED_SEEDS = 28, PLANNED_JUDGES = 21, MOST_PLANNED = 512 };

/* Measures views of the scenes that are there: those that fit the plan (fits 1) or those that judge it (0).
   visibility: that alone, without light and bounces. Appends to rows, which has *count rows. Returns -1 on failure. */
int planned_views_measure(planned_row *rows, int *count, int fits, int visibility, kit_error *err);
/* Appends rows of so many scenes by seed, each for visibility, light and bounce. They are kept under build/cache. */
int planned_seeds_measure(planned_row *rows, int *count, int first, int seeds, int visibility, kit_error *err);
/* Measures these rows in one process a core, and keeps them. Call it before this process has a GL context. */
int planned_seeds_ahead(int first, int seeds, int visibility, const char *context, kit_error *err);

/* Replaces a choice's cost, as single times are noisy, by the predicted one times the median ratio of measured to
   predicted cost over the timed views. Surfels and fields keep theirs, which depend on the scene. */
void planned_smooth(planned_row *rows, int count);

#endif
