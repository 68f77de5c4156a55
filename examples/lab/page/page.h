/* page.h - a page that grows in memory and reaches the disk whole, or not at all; and the HTML that all pages share. */
#ifndef LAB_PAGE_H
#define LAB_PAGE_H

#include <stdio.h>
#include "kit/kit.h"

typedef struct page { FILE *file; char *text; size_t size; } page;
int page_open(page *p, kit_error *err);
int page_close(page *p, const char *folder, const char *name, kit_error *err);
void page_into(page *p, FILE *f);     /* what a page holds becomes part of another file */

/* What a run's figures come from, for build/figures: a line of its kind (full, quick or part), and one of command,
   commit, machine and driver. */
int page_note(const char *folder, const char *name, const char *kind, const char *command, const char *driver,
              kit_error *err);

void page_escaped(FILE *f, const char *s);
void page_head(FILE *f, const char *title, const char *about);
/* A picture and, under it, its difference to the truth; page_figure begins it, and the caller ends it. */
void page_figure(FILE *f, const char *slug, const char *label, const char *note, int width, int height, int difference);
void page_key(FILE *f, double range);           /* the differences' colours, full at +-range */

#endif
