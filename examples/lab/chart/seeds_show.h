/* seeds_show.h - what was measured on scenes by seed, as text, CSV and pages. Private to seeds.c. */
#ifndef LAB_SEEDS_SHOW_H
#define LAB_SEEDS_SHOW_H

#include "lab/measure/spread.h"
#include "lab/page/units.h"

enum { MOST_SEED_ROWS = 2 * MOST_ROWS };

typedef struct seeds {
    const char *base;                        /* of the files' names */
    int         first, count, rows;          /* rows: on each scene */
    const row  *row[MOST_SEEDS];             /* NULL: the scene was left out */
    /* of the chart's scenes, or of its pairs of scenes and probes; NAN: not known */
    double      time[MOST_SEED_ROWS], mean[MOST_SEED_ROWS];
} seeds;

/* How a scene and its pictures are called: "rooms-1001". */
void seeds_name(char name[32], int seed);
int  seeds_lit(const row *r);                /* whether a row is of light */

void seeds_table_text(FILE *f, const seeds *s);
void seeds_csv(FILE *f, const seeds *s);
/* Reads what make chart measured of the same rows, where it did. */
void seeds_beside(seeds *s, const char *out);
/* The section: a sheet of pictures, tables, charts. */
int  seeds_section(FILE *html, const seeds *s, const char *out, kit_error *err);
/* A kind's page begins. */
void seeds_kind_head(FILE *html, int tuned, int kind);

#endif
