/* table.h - writes rows as tables: CSV, parts of a page. A row's member of says which columns it has. */
#ifndef LAB_TABLE_H
#define LAB_TABLE_H

#include <stdio.h>
#include "lab/measure/rows.h"

void table_csv(FILE *f, const row *rows, int count, int head);
/* Adds a table of rows to a record, and once the names and the meanings of the columns. */
int table_page(FILE *f, const char *kind, const row *rows, int count, kit_error *err);
void table_columns(FILE *f);

#endif
