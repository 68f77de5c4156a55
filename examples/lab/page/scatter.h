/* scatter.h - the chart of cost against error: rows as points, one curve a label. */
#ifndef LAB_SCATTER_H
#define LAB_SCATTER_H

#include <stdio.h>
#include "lab/measure/rows.h"

/* What stands at a chart's top and sides; in tooltips (fetches NULL: no numbers beside the points). even: x is no
   logarithm. */
typedef struct words { const char *about, *across, *up, *relative, *fetches; int even; } words;
extern const words scatter_ao, scatter_lit, scatter_turn, scatter_field;

/* A chart as a file of its own and inside the page. Rows with a relative time are its points, others (floor, no AO) are
   skipped. floor_: a share, NAN = no line. */
int scatter_chart(FILE *html, const char *out, const char *name, const char *title, const words *w, const row *rows,
                  int count, double floor_, kit_error *err);

#endif
