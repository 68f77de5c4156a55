/* csv.h - tables: cells by row and key. */
#ifndef LAB_CSV_H
#define LAB_CSV_H

#include <stdio.h>

typedef struct csv { char *text, **cell; int rows, columns; } csv;      /* cell[0 .. columns - 1]: the heads */

extern const char *csv_folder;             /* where they are */

/* A file of the folder, or of an absolute path. No rows: there is no such table. One that is none ends the program.
   Kept until that ends. */
csv         csv_read(const char *name);
/* Of a text from malloc, which it takes over; name: for what is said of one that is none. */
csv         csv_of(char *text, const char *name);
const char *csv_text(const csv *c, int row, const char *key);           /* "" = there is none */
double      csv_number(const csv *c, int row, const char *key);         /* NAN = there is none */

/* A cell of any text. */
void        csv_quote(FILE *f, const char *text);
/* The columns of some keys, with commas between, of those rows that have nothing in the column empty (NULL: of all).
   aligned: to be read; else as csv. */
void        csv_put(FILE *f, const csv *c, const char *keys, const char *empty, int aligned);

#endif
