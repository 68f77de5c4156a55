/* section.h - a chart's sections. A section is a list of sets; a set is a table of rows on one view. section.c measures
   sets, and makes a part of the page, lines of a csv and text of each. The demo also shows pictures at full size. */
#ifndef LAB_SECTION_H
#define LAB_SECTION_H

#include "lab/measure/measure.h"
#include "lab/page/units.h"

enum { MOST_SET_ROWS = 128 };

typedef struct set set;
typedef struct section section;
/* The rows of a set or a unit. name: of its scene; row NULL: nothing was measured. */
typedef struct found { char name[64]; row *row; int count; } found;

struct set {
    const char *title, *about;             /* title NULL: under the heading of the set before it */
    const void *see;                       /* for the section's open: a view, or a struct that begins with one */
    const char *rows;                      /* the name of a set of UNITS_ROWS */
    int quick;                             /* 1: chart --quick shows it, too */
    const char *kind;                      /* the view of report.js that shows it; NULL: "rows" */
    int phases;                            /* phases that split error from noise; 0: no split */
    /* Instead of rows: fills the rows and returns how many there are; -1 = failed. */
    int (*own)(FILE *record, const options *o, row *rows, kit_error *err);
    int crop[MOST_CROPS][4];               /* of the demo's pictures, if the view's light has no crops */
};

struct section {
    const char *name, *csv;                /* names of its units and of its csv; NULL: no csv, only the record */
    const char *method;                    /* the method that --method must allow for a set with own */
    const set *sets;
    int count, width, height, stride, rounds;
    int of[2];                             /* columns of unlit and lit rows, with no floor; 0: the rows' own */
    int (*open)(stage *s, const section *c, const set *t, kit_error *err);
    /* Fills rows and pictures and returns how many pictures; given rows follow. NULL: measure_entries. */
    int (*measure)(FILE *record, row *rows, stage *s, const entry *entries, int count, kit_image *picture,
                   kit_error *err);
    int probe_times, probe_stride;         /* for section_about */
    /* For the demo. range: of the differences; 0: small pictures alone. beside: given pictures are shown, too. */
    double range;
    int crop_times, beside;
    int (*seen)(kit_image *out, const stage *s, const kit_image *picture, kit_error *err);

    /* A section without sets has this many units, each measured by unit. They make one table, shown by the view kind of
       report.js below title and head; the units' own parts of the page follow. */
    const char *title, *kind, *parts;      /* parts: the heading above these, NULL: none */
    int (*units)(const options *o);
    measuring *unit;
    void (*head)(FILE *record, const options *o);
    void (*write)(FILE *csv, const options *o);      /* NULL: the csv of table.h */
    void (*text)(FILE *f);                           /* NULL: a table for each set */
    found *found;                                    /* room for the results */
};

/* How many units are asked for. The next two measure the section and print its text. */
int  section_units(const section *c, const options *o);
int  section_chart(FILE *record, const section *c, const options *o, kit_error *err);
void section_text(FILE *f, const section *c);
/* Prints a line for each row of the fullest scene: the spread of its error over all scenes. */
void section_spreads(FILE *f, const section *c, int count);
/* The scene with the most rows; -1: none. section_alike: every scene's row that is like the given one, else NULL. */
int  section_fullest(const section *c, int count);
void section_alike(const row **out, const section *c, int count, const row *like);

/* Writes the text above a stage's pictures. If times is not 0, it has the truth's own error, measured with so many
   times its rays at every stride-th pixel. */
int  section_about(FILE *record, stage *s, const char *text, int times, int stride, kit_error *err);

#endif
