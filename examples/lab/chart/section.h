/* section.h - what a chart is made of: sections of sets. A set is a table of rows on one view; the runner measures it,
   and makes a part of the page, lines of a csv and text of it. The demo's sets have their pictures whole, too. */
#ifndef LAB_SECTION_H
#define LAB_SECTION_H

#include "lab/measure/measure.h"
#include "lab/page/units.h"

enum { MOST_SET_ROWS = 128 };

typedef struct set set;
typedef struct section section;
/* What was measured: name is the scene's; row NULL: nothing. */
typedef struct found { char name[64]; row *row; int count; } found;

struct set {
    const char *title, *about;             /* title NULL: it stands under the heading of the set before it */
    const void *see;                       /* what the section's open takes: a view, or a struct that begins with one */
    const char *rows;                      /* a set of UNITS_ROWS */
    int quick;                             /* chart --quick shows it, too */
    const char *kind;                      /* of report.js' views; NULL: "rows" */
    int phases;                            /* of the noise, that it is split by; 0: it is not */
    /* instead of rows: fills them, returns how many; -1 = failed */
    int (*own)(FILE *record, const options *o, row *rows, kit_error *err);
    int crop[MOST_CROPS][4];               /* of the demo's pictures, where the view's light has none */
};

struct section {
    const char *name, *csv;                /* of its units; the csv's, NULL: the record alone has it */
    const char *method;                    /* what --method has to ask for where a set is its own */
    const set *sets;
    int count, width, height, stride, rounds;
    int of[2];                             /* columns of rows that are not lit, that are: without the floor; 0: all */
    int (*open)(stage *s, const section *c, const set *t, kit_error *err);
    /* NULL: measure_entries. Fills rows and pictures, returns how many pictures; given rows follow. */
    int (*measure)(FILE *record, row *rows, stage *s, const entry *entries, int count, kit_image *picture,
                   kit_error *err);
    int probe_times, probe_stride;         /* of section_about */
    /* Of the demo. range: of differences; 0: small pictures alone. beside: what is given is pictured, too. */
    double range;
    int crop_times, beside;
    int (*seen)(kit_image *out, const stage *s, const kit_image *picture, kit_error *err);

    /* Of a section without sets: how many units there are, each measured by unit. All are one table, of a view of
       report.js', under a heading and what head writes; the units' own parts follow. */
    const char *title, *kind, *parts;      /* parts: the heading of these, NULL: none */
    int (*units)(const options *o);
    measuring *unit;
    void (*head)(FILE *record, const options *o);
    void (*write)(FILE *csv, const options *o);      /* NULL: as table.h has it */
    void (*text)(FILE *f);                           /* NULL: a table a set */
    found *found;                                    /* room for what is measured */
};

/* How many units are asked for; how many rows of entries. */
int  section_units(const section *c, const options *o);
int  section_chart(FILE *record, const section *c, const options *o, kit_error *err);
void section_text(FILE *f, const section *c);
/* A line a row of the fullest scene: the spread of its share over all. */
void section_spreads(FILE *f, const section *c, int count);
/* The fullest scene; -1: there is none. The row of every scene that is like one; NULL: a scene has none such. */
int  section_fullest(const section *c, int count);
void section_alike(const row **out, const section *c, int count, const row *like);

/* What stands above a stage's pictures; with the truth's own error, by so many times its rays at every stride-th pixel;
   0: not told. */
int  section_about(FILE *record, stage *s, const char *text, int times, int stride, kit_error *err);

#endif
