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
    int quick, scenes;
    int first, seeds;                        /* of scenes by seed: the first (below 0: not given), and how many */
    const char *commit;                      /* whose hash draws half of the seeds */
} options;
/* Whether --method allows this method. */
int units_asked(const options *o, const char *method);

/* Rows to be measured, as lines of a csv, each of a set. Rows of one label follow each other and make one curve. chart
   --quick leaves out rows without quick in the last column. Call units_load first. */
#define UNITS_ROWS "examples/lab/chart/rows.csv"
int units_load(kit_error *err);
/* The row in the k-th line; NULL past the last. units_chosen: how many rows of a set the options allow, and which. */
const entry *units_row(int k);
int units_chosen(entry out[MOST_ENTRIES], const char *set, const options *o);

/* Measures the k-th unit: its rows, and its part of the page. Returns how many rows; -1 = failed. rows NULL: returns
   only whether there are any. */
typedef int measuring(FILE *f, const options *o, int k, row *rows, kit_error *err);
/* Adds a file to a hash. A file that cannot be read leaves the hash as it is. */
uint64_t units_hash(uint64_t h, const char *path);
/* How many of count units have rows. */
int units_count(measuring *measure, int count, const options *o);
/* all: how many units the chart has. units_end: after a complete chart, removes the kept units. */
void units_begin(const options *o, int all);
void units_end(void);
/* Measures a unit, or reads what an interrupted chart kept. Returns how many rows, 0: none asked for; -1 = failed. */
int units_measure(FILE *f, const options *o, const char *kind, int k, measuring *measure, row *rows, kit_error *err);
/* The name of the unit that is being measured, such as "lit-3". */
const char *units_name(void);

#endif
