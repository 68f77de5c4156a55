/* seeds_show.h - what was measured on scenes by seed, as text and pages. Private to seeds.c. */
#ifndef LAB_SEEDS_SHOW_H
#define LAB_SEEDS_SHOW_H

#include "lab/measure/spread.h"
#include "lab/page/units.h"

typedef struct seeds {
    const char *base;                        /* of the files' names */
    int         first, count, rows;          /* rows: on each scene */
    const row  *row[MOST_SEEDS];             /* NULL: the scene was left out */
    double      time[MOST_ROWS * 2], mean[MOST_ROWS * 2];    /* of the chart's scenes; NAN: not known */
} seeds;

/* Of seed first + k; NULL past the last. */
const char *seeds_kind(const seeds *s, int k);
/* A scene that was not left out; NULL: there is none. */
const row  *seeds_names(const seeds *s);
/* Whether a row is of light; the i-th row's shares over the scenes, all of them and of one kind. */
int         seeds_lit(const row *r);
spread      seeds_spread(const seeds *s, int i);
spread      seeds_spread_in(const seeds *s, int i, int kind);

void seeds_table_text(FILE *f, const seeds *s);
void seeds_csv(FILE *f, const seeds *s);

#endif
