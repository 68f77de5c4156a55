/* show.h - what sweeps become: records, tables, pictures of the worst frames. */
#ifndef LAB_SHOW_H
#define LAB_SHOW_H

#include <stdio.h>
#include "lab/stability/curve.h"

void show_csv_head(FILE *f);
/* One cause: its part of the record and of the CSV, its pictures in out. */
int  show_cause(FILE *record, FILE *csv, const result *r, const char *out, kit_error *err);
/* Causes down, methods across; causes of other things below. Of those that are shown. */
void show_table_text(FILE *f, const result *results, const int *shown);

#endif
