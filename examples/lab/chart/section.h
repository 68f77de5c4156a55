/* section.h - a chart's sections. A section is a list of sets (sets.h). section.c measures sets, and writes a part of
   the page and csv for each. The demo also shows pictures at full size. */
#ifndef LAB_SECTION_H
#define LAB_SECTION_H

#include "lab/chart/sets.h"
#include "lab/measure/measure.h"
#include "lab/page/units.h"

enum { MOST_SET_ROWS = 128 };

typedef struct section section;
/* The rows of a set or a unit; row NULL: it was not measured. */
typedef struct found { row *row; int count; } found;

struct section {
    const char *name, *csv;                /* names of units and of the csv; csv NULL: the record alone */
    const char *sets;                      /* the section's name in sets.csv; NULL: it has units of its own */
    int width, height, stride, rounds;     /* stride: of the truth of light */
    int of[2];                             /* groups of columns of unlit and lit rows; 0: the rows' own */
    const char *method;                    /* for own(): the method that --method must allow */
    /* Measures a set without a view: fills its rows and returns how many there are; -1 = failed. */
    int (*own)(FILE *record, const options *o, row *rows, kit_error *err);
    /* Adds entries to those of a set, and returns how many there are then; -1 = failed. NULL: none. */
    int (*more)(FILE *record, stage *s, entry *entries, int count, kit_error *err);
    /* Fills rows and pictures; given rows follow. NULL: measure_entries does it. */
    int (*measure)(row *rows, stage *s, const entry *entries, int count, kit_image *picture, kit_error *err);
    int probe_times, probe_stride;         /* of the truth's own error: times its rays, at every so many pixels */
    /* For the demo. range: of the shown differences; 0: no pictures. beside: given pictures are shown, too. */
    double range;
    int crop_times, beside;

    /* A section without sets has this many units, each measured by unit(). Their rows make one table, which the view
       kind of report.js shows below title and head; the units' own parts of the page follow. */
    const char *title, *kind;
    int (*units)(const options *o);
    measuring *unit;
    void (*head)(FILE *record, const options *o);
    /* Writes the section's csv from the rows of all units; NULL: the csv is that of table.h. */
    void (*write)(FILE *csv, const options *o, const found *all, int count);
};

/* Returns how many units of a section are asked for. section_chart measures the section. */
int  section_units(const section *c, const options *o);
int  section_chart(FILE *record, const section *c, const options *o, kit_error *err);

#endif
