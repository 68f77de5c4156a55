/* page.h - files that grow in memory and reach the disk whole, or not at all; and records: results of a run as JSON,
   which report.js and figures.mjs (examples/docs/FIGURES.md) show. C draws no chart and writes no HTML. */
#ifndef LAB_PAGE_H
#define LAB_PAGE_H

#include <stdio.h>
#include "kit/kit.h"

typedef struct page { FILE *file; char *text; size_t size; } page;
int page_open(page *p, kit_error *err);
int page_close(page *p, const char *folder, const char *name, kit_error *err);
void page_into(page *p, FILE *f);     /* copies what was written to the page so far into f */

/* ---- >>records --------------------------------------------------------------------------------------------------- */

/* Begins folder/NAME.js, a script of the page, and copies the page, index.html and its scripts, beside it. kind: full,
   quick or part; command: the command that measures it again. */
int page_begin(page *p, const char *name, const char *kind, const char *command, const char *driver, kit_error *err);
int page_end(page *p, const char *folder, const char *name, kit_error *err);

/* These functions add an entry to a record, one line each. Texts are plain: the page escapes them. */
/* level 2: of a section, 3: of a part of it, 4: of folded pairs of pictures */
void page_heading(FILE *f, int level, const char *format, ...);
void page_paragraph(FILE *f, const char *format, ...);
/* Adds a picture, slug.png in the record's folder, and below it, if difference is 1, its difference to the truth. */
void page_figure(FILE *f, const char *slug, const char *label, const char *note, int width, int height, int difference);
void page_key(FILE *f, double range);           /* adds a ramp of the colours of differences, -range to +range */
/* Adds the table in a csv, and closes the csv. kind: the view of report.js that shows it; "rows": as it is. */
void page_table(FILE *f, const char *kind, page *csv);
/* Does as page_table does, and also writes the csv to folder/name. */
int page_csv(FILE *f, const char *kind, page *csv, const char *folder, const char *name, kit_error *err);

#endif
