/* dots.h - the chart of many scenes: a line a row, a dot a scene, the mean and its interval. */
#ifndef LAB_DOTS_H
#define LAB_DOTS_H

#include <stdio.h>
#include "kit/kit.h"
#include "lab/measure/spread.h"

/* The i-th row's values are value[i * count] and those after it, in the order of group; NAN: not known. mark: of each
   row what is marked beside, NAN: nothing. */
typedef struct dots {
    int           rows, count, groups;
    const char   *const *label, *const *settings, *const *group_name;
    const double *value, *mark;
    const int    *group;
    const char   *across, *marked;           /* what the values are; what mark is */
} dots;

/* As a file of its own, and inside the page. */
int dots_chart(FILE *html, const char *out, const char *name, const char *title, const dots *d, kit_error *err);

#endif
