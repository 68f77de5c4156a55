/* planned.h - the costs and the errors of the plan's choices, measured on views of scenes and on scenes by seed. */
#ifndef LAB_PLANNED_H
#define LAB_PLANNED_H

#include "lab/measure/measure.h"

/* Costs and errors of the choices on one view, under one light. */
typedef struct planned_row {
    char name[64];
    int  timed;                             /* 0: costs are predicted, but for surfels and fields */
    ssgi_plan_scene numbers;
    ssgi_plan_scene captured;               /* known from the frame alone: no calibration, no slabs */
    double error[SSGI_PLAN_CHOICES], cost[SSGI_PLAN_CHOICES];   /* NAN: the choice is not for this view */
} planned_row;

enum { PLANNED_SEEDS = 28, PLANNED_JUDGES = 21, PLANNED_QUICK_SEEDS = 7, MOST_PLANNED = 512 };

/* Measures views of the scenes that are there, either those that fit the plan (fits 1) or those that judge it (0);
   quick: fewer of them. Appends to rows, which has *count rows. -1 = failed. */
int planned_views_measure(planned_row *rows, int *count, int fits, int quick, kit_error *err);
/* Appends rows of so many scenes by seed, each for visibility, light and bounce. They are kept under build/cache. */
int planned_seeds_measure(planned_row *rows, int *count, int first, int seeds, kit_error *err);
/* Measures and keeps these in one process a core. To be called before there is a GL context. */
int planned_seeds_ahead(int first, int seeds, const char *context, kit_error *err);

/* Single times are noisy. So a choice's cost becomes the predicted one times the median ratio of measured to predicted
   cost over the views that were timed. Surfels and fields keep their costs, as these depend on the scene. */
void planned_smooth(planned_row *rows, int count);

#endif
