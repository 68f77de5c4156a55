/* csv.h - tables as make cost writes them: cells by row and key. */
#ifndef LAB_CSV_H
#define LAB_CSV_H

typedef struct csv { char *text, **cell; int rows, columns; } csv;      /* cell[0 .. columns - 1]: the heads */

extern const char *csv_folder;             /* where they are */

/* A file of the folder, for the caller to free; NULL: it cannot be read. */
char       *csv_file(const char *name);
/* No rows: there is no such table. One that is none ends the program. Kept until that ends. */
csv         csv_read(const char *name);
const char *csv_text(const csv *c, int row, const char *key);           /* "" = there is none */
double      csv_number(const csv *c, int row, const char *key);         /* NAN = there is none */

#endif
