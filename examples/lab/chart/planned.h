/* planned.h - what the plan's choices cost and err by: measured on views of scenes, and on scenes by seed. */
#ifndef LAB_PLANNED_H
#define LAB_PLANNED_H

#include "lab/measure/measure.h"

/* What choices cost and err by on one view, under one light. */
typedef struct planned_row {
    char name[64];
    int  timed;                             /* 0: costs are what is predicted, but surfels' and fields' */
    ssgi_plan_scene numbers;
    ssgi_plan_scene captured;               /* of the frame alone: no scene, no calibration, no slabs */
    double error[SSGI_PLAN_CHOICES], cost[SSGI_PLAN_CHOICES];   /* NAN: not for this */
} planned_row;

enum { PLANNED_SEEDS = 28, PLANNED_JUDGES = 21, PLANNED_QUICK_SEEDS = 7, MOST_PLANNED = 512 };

/* The views that fit, or those that judge (fits: 1, 0), of scenes that are there; quick: fewer. Appends to rows, of
   which there are count; -1 = failed. */
int planned_views_measure(planned_row *rows, int *count, int fits, int quick, kit_error *err);
/* The same of count scenes by seed, each for visibility, light, bounce, kept under
   build/cache. */
int planned_seeds_measure(planned_row *rows, int *count, int first, int seeds, kit_error *err);
/* Measures and keeps them, a process a core; before there is a context. */
int planned_seeds_ahead(int first, int seeds, const char *context, kit_error *err);

/* Single times are noisy: a choice's cost becomes what is predicted times the median, over the views that were timed,
   of what it took over that. Surfels and fields, which hang on the scene, stay as measured. */
void planned_smooth(planned_row *rows, int count);

#endif
