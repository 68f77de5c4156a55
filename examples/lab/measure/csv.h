/* csv.h - tables, whose cells are found by row and key. */
#ifndef LAB_CSV_H
#define LAB_CSV_H

#include <stdio.h>

typedef struct csv { char *text, **cell; int rows, columns; } csv;      /* the first row of cells names the columns */

/* Reads a file of a folder, or of an absolute path, and keeps it until the program ends. Returns no rows if there is no
   such file. A file that is no table ends the program. */
csv         csv_read(const char *folder, const char *name);
/* Makes a table of a text from malloc, which it takes over. name: for the error message if the text is no table. */
csv         csv_of(char *text, const char *name);
const char *csv_text(const csv *c, int row, const char *key);           /* "": there is no such cell */
double      csv_number(const csv *c, int row, const char *key);         /* NAN: there is no such number */

/* Writes a text as a cell of a csv, in quotes. csv_figure: a number behind a comma (",%.6g"); NAN: the comma alone. */
void        csv_quote(FILE *f, const char *text);
void        csv_figure(FILE *f, const char *format, double v);
/* Writes the columns of keys, which are separated by commas, of the rows whose cell in the column empty has no text
   (NULL: of all rows). aligned: padded for reading; else as csv. */
void        csv_put(FILE *f, const csv *c, const char *keys, const char *empty, int aligned);

#endif
