/* table.h - rows as tables: text, CSV, parts of a page. Which columns is in the rows' of. */
#ifndef LAB_TABLE_H
#define LAB_TABLE_H

#include <stdio.h>
#include "lab/measure/rows.h"

const char *table_settings(const row *r);       /* "defaults" where a method has none beyond them */
void table_text(FILE *f, const row *rows, int count);
/* under a title, where there are any */
void table_titled(FILE *f, const char *title, const row *rows, int count);
/* The mean of rows: of their first one's names, and of each column. */
void table_mean(row *mean, const row *const *rows, int count);
void table_csv(FILE *f, const row *rows, int count, int head);
/* Entries of a record: rows; what columns are called there, and what they mean, once. */
int table_page(FILE *f, const char *kind, const row *rows, int count, kit_error *err);
void table_columns(FILE *f);

#endif
