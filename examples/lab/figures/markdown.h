/* markdown.h - the page as it is written: headings, tables. */
#ifndef LAB_MARKDOWN_H
#define LAB_MARKDOWN_H

#include <stdio.h>
#include "lab/page/csv.h"

typedef struct markdown {
    FILE       *file;
    int         full;                      /* the page is examples/docs/FIGURES.md */
    /* where the figures of each come from */
    const char *chart_note, *stability_note, *papers_note, *cost_note, *seeds_note;
    char        seeds_run;                 /* f, q, p: whole, quick or in part; 0 = there was none */
} markdown;

/* A heading, what the table is about (pictures as examples/docs has them), and where its figures come from. */
void markdown_heading(const markdown *m, const char *title, const char *about, const char *note);
void markdown_ruler(const markdown *m, int columns);
/* Cells: a number; the settings of a row, which begin a line. */
void markdown_number(const markdown *m, double v, int digits, int sign);
void markdown_settings(const markdown *m, const csv *c, int row);

#endif
