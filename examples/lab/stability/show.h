/* show.h - shows sweeps: records and tables, and pictures of the worst frames. */
#ifndef LAB_SHOW_H
#define LAB_SHOW_H

#include <stdio.h>
#include "lab/stability/curve.h"

void show_csv_head(FILE *f);
/* Shows one cause: its part of the record and of the CSV, and its pictures in out. */
int  show_cause(FILE *record, FILE *csv, const result *r, const char *out, kit_error *err);
/* Writes lines "cause, what its number means, method, number", with numbers to be read. */
void show_numbers(FILE *f, const result *r);

#endif
