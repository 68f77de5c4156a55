/* line.h - a line of one of the laboratory's tables in csv. Its cells are read by their column. */
#ifndef LAB_LINE_H
#define LAB_LINE_H

#include "lab/measure/csv.h"

/* folder/file.csv, and the number of a line in it. */
typedef struct line { const char *folder, *file; csv of; int at; } line;

/* Reads the file. line_find: goes to the line whose cell equals the first length characters of text; 0: there is none.
   A file without rows, or a cell that cannot be read, ends the program with a sentence (line_fault). */
void line_open(line *l);
int  line_find(line *l, const char *key, const char *text, size_t length);
void line_fault(const line *l, const char *key);

/* A cell as it is; line_text: with {word} replaced by folder/words.csv; NULL: empty. Both last until the program
   ends. */
const char *line_cell(const line *l, const char *key);
const char *line_text(const line *l, const char *key);
/* A cell as a number; 0: empty. line_reals: as so many numbers with blanks between; an empty cell changes nothing. */
int   line_whole(const line *l, const char *key);
float line_real(const line *l, const char *key);
void  line_reals(const line *l, const char *key, const char *text, float *v, int count);
/* Returns which of words, with blanks between, equals the first length characters of text, a part of a cell. */
int   line_word(const line *l, const char *key, const char *words, const char *text, size_t length);
/* Splits a cell at its bars into at most most parts. An empty part is NULL. The rest of out stays as it is. */
void  line_split(const line *l, const char *key, const char **out, int most);

#endif
