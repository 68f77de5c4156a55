/* page.h - files that grow in memory and reach the disk whole, or not at all; and records: what a run shows, as JSON,
   which report.js makes a page of and figures.mjs examples/docs/FIGURES.md. C draws no chart and writes no HTML. */
#ifndef LAB_PAGE_H
#define LAB_PAGE_H

#include <stdio.h>
#include "kit/kit.h"

typedef struct page { FILE *file; char *text; size_t size; } page;
int page_open(page *p, kit_error *err);
int page_close(page *p, const char *folder, const char *name, kit_error *err);
void page_into(page *p, FILE *f);     /* what a page holds becomes part of another file */

/* ---- >>records --------------------------------------------------------------------------------------------------- */

/* folder/NAME.js, the page's script of that name, and beside it the page: index.html and what that loads. kind: full,
   quick or part; command: what draws it again. */
int page_begin(page *p, const char *name, const char *kind, const char *command, const char *driver, kit_error *err);
int page_end(page *p, const char *folder, const char *name, kit_error *err);

/* Entries of a record, a line each. Texts are plain: the page escapes them. */
void page_heading(FILE *f, int level, const char *format, ...);         /* 2: a section, 3: a part of it */
void page_paragraph(FILE *f, const char *format, ...);
/* A picture of the folder, slug.png, and under it, where there is one, its difference to the truth. */
void page_figure(FILE *f, const char *slug, const char *label, const char *note, int width, int height, int difference);
void page_key(FILE *f, double range);           /* the differences' colours, full at +-range */
/* The table that a csv holds, which ends there. kind: which of report.js' views shows it, "rows": as it is. */
void page_table(FILE *f, const char *kind, page *csv);
/* The same, and the csv becomes folder/name. */
int page_csv(FILE *f, const char *kind, page *csv, const char *folder, const char *name, kit_error *err);
/* The next field of a csv's line, without quotes around it; it ends there, and at goes on behind it. */
char *page_field(char **at);

#endif
