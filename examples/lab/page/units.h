/* units.h - what a chart is made of: a unit is a table on a scene, its rows and its part of the page. It is kept until
   the chart is whole, so that an interrupted one goes on where it was. */
#ifndef LAB_UNITS_H
#define LAB_UNITS_H

#include <stdio.h>
#include "lab/measure/rows.h"

enum { MOST_SCENES = 16, MOST_SEEDS = 1000 };
/* What a command is asked for; NULL, 0: not. */
typedef struct options {
    const char *out, *mesh, *method, *paper, *context, *scene[MOST_SCENES];
    int quick, scenes;
    int first, seeds;                        /* of scenes by seed: the first, below 0: not said; how many */
    const char *commit;                      /* that draws half of them */
} options;
/* Whether --method asks for a method. */
int units_asked(const options *o, const char *method);

/* What is measured as rows: lines of a csv, of a set each; rows of one label make one curve, and follow each other.
   Without quick in the last column chart --quick leaves one out. Read once, before the others ask. */
#define UNITS_ROWS "examples/lab/chart/rows.csv"
int units_load(kit_error *err);
/* The k-th line's; NULL past the last. Those of a set that are asked for: how many. */
const entry *units_row(int k);
int units_chosen(entry out[MOST_ENTRIES], const char *set, const options *o);

/* Measures the k-th of its kind: its rows, and what stands in the page. How many rows; -1 = failed. rows NULL: whether
   there are any. */
typedef int measuring(FILE *f, const options *o, int k, row *rows, kit_error *err);
/* A hash that goes on over a file; of one that cannot be read it stays. */
uint64_t units_hash(uint64_t h, const char *path);
/* How many of count are there. */
int units_count(measuring *measure, int count, const options *o);
/* all: how many units the chart has. end: of a chart that is whole, whose units need not be kept. */
void units_begin(const options *o, int all);
void units_end(void);
/* One unit: measured, or as an interrupted chart left it. How many rows, 0: none are asked for; -1 = failed. */
int units_measure(FILE *f, const options *o, const char *kind, int k, measuring *measure, row *rows, kit_error *err);
/* What is being measured, "lit-3". */
const char *units_name(void);

#endif
