/* units.h - units of a chart: each is a table on a scene, with its rows and its part of the page. Units are kept until
   the chart is complete, so that an interrupted chart goes on where it was. */
#ifndef LAB_UNITS_H
#define LAB_UNITS_H

#include <stdio.h>
#include "lab/measure/rows.h"

enum { MOST_SCENES = 16, MOST_SEEDS = 1000 };
/* The options of a command; NULL or 0: not given. */
typedef struct options {
    const char *out, *mesh, *method, *paper, *context, *scene[MOST_SCENES];
    int quick, visibility, scenes;                    /* visibility: of the plan alone, without light */
    int first, seeds;                        /* first: seed of the scenes (below 0: not given); seeds: how many */
    const char *drawn;                       /* the hash of this text draws half of the seeds of the chart */
} options;
/* Returns whether the option --method allows this method. */
int units_asked(const options *o, const char *method);

/* The table of rows to be measured, rows.csv: each line is of a set. Rows of one label follow each other and make one
   curve. chart --quick leaves out rows without quick in the last column. Call units_load first. */
#define UNITS_FOLDER "examples/lab/chart"
void units_load(void);
/* Returns the row in the k-th line; NULL past the last. units_chosen: how many rows of a set the options allow, and
   which. */
const entry *units_row(int k);
int units_chosen(entry out[MOST_ENTRIES], const char *set, const options *o);

/* A function that measures the k-th unit: its rows, and its part of the page. Returns how many rows; -1 = failed. rows
   NULL: returns only whether there are any. */
typedef int measuring(FILE *f, const options *o, int k, row *rows, kit_error *err);
/* Adds a file's bytes to a hash. A file that cannot be read leaves the hash as it is. */
uint64_t units_hash(uint64_t h, const char *path);
/* Returns how many of count units have rows that the options allow. */
int units_count(measuring *measure, int count, const options *o);
/* units_begin: finds kept units; all: how many the chart has. units_end: removes them, after a complete chart. */
void units_begin(const options *o, int all);
void units_end(void);
/* Measures a unit, or reads what an interrupted chart kept. Returns how many rows, 0: none; -1 = failed. */
int units_measure(FILE *f, const options *o, const char *kind, int k, measuring *measure, row *rows, kit_error *err);
#endif
