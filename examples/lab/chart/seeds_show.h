/* seeds_show.h - what was measured on scenes by seed, as text and CSV. Private to seeds.c. */
#ifndef LAB_SEEDS_SHOW_H
#define LAB_SEEDS_SHOW_H

#include "lab/measure/spread.h"
#include "lab/page/units.h"

enum { MOST_SEED_ROWS = 2 * MOST_ROWS };

typedef struct seeds {
    const char *base;                        /* of the files' names */
    int         first, count, rows;          /* rows: on each scene */
    const row  *row[MOST_SEEDS];             /* NULL: the scene was left out */
} seeds;

/* How a scene and its pictures are called: "rooms-1001". */
void seeds_name(char name[32], int seed);
int  seeds_lit(const row *r);                /* whether a row is of light */

void seeds_table_text(FILE *f, const seeds *s);
void seeds_csv(FILE *f, const seeds *s);

#endif
