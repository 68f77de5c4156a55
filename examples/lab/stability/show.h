/* show.h - what sweeps become: charts, tables, pictures of the worst frames. */
#ifndef LAB_SHOW_H
#define LAB_SHOW_H

#include <stdio.h>
#include "lab/stability/curve.h"

/* One cause: its part of the page and of the CSV, its chart and pictures in out. */
int  show_cause(FILE *html, FILE *csv, const result *r, const char *out, kit_error *err);
/* Causes down, methods across; causes of other things below. Of those that are shown. */
void show_table_html(FILE *f, const result *results, const int *shown);
void show_table_text(FILE *f, const result *results, const int *shown);

#endif
