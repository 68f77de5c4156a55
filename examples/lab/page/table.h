/* table.h - rows as tables: text, HTML, CSV. Which columns is in the rows' of. */
#ifndef LAB_TABLE_H
#define LAB_TABLE_H

#include <stdio.h>
#include "lab/measure/rows.h"

const char *table_settings(const row *r);       /* "defaults" where a method has none beyond them */
void table_text(FILE *f, const row *rows, int count);
/* under a title, where there are any */
void table_titled(FILE *f, const char *title, const row *rows, int count);
void table_html(FILE *f, const row *rows, int count);
void table_csv(FILE *f, const row *rows, int count, int head);

#endif
