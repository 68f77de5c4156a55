/* show.h - shows sweeps: records, tables, pictures of the worst frames. */
#ifndef LAB_SHOW_H
#define LAB_SHOW_H

#include <stdio.h>
#include "lab/stability/curve.h"

void show_csv_head(FILE *f);
/* Shows one cause: its part of the record and of the CSV, and its pictures in out. */
int  show_cause(FILE *record, FILE *csv, const result *r, const char *out, kit_error *err);
/* Prints a row for each cause, a column for each method; causes without methods below. shown: 1 if a cause is
   printed. */
void show_table_text(FILE *f, const result *results, const int *shown);

#endif
