/* seeds_show.h - what was measured on scenes by seed, as text and CSV. Private to seeds.c. */
#ifndef LAB_SEEDS_SHOW_H
#define LAB_SEEDS_SHOW_H

#include "lab/measure/spread.h"
#include "lab/page/units.h"

enum { MOST_SEED_ROWS = 128 };

/* set: tuned, asked, judged, drawn or models; kind: a word of kit_scene_kind, or models. */
typedef struct place { char name[64], path[128]; const char *set, *kind; int seed; } place;
/* Rows of a scene follow each other by parts, whose name is their scene; those of a part have the same order on every
   scene. */
typedef struct seeds {
    const char *base;                        /* of the files' names */
    int         count, rows[MOST_SEEDS];
    place       place[MOST_SEEDS];
    const row  *row[MOST_SEEDS];             /* NULL: the scene was left out */
} seeds;

void seeds_table_text(FILE *f, const seeds *s);
void seeds_csv(FILE *f, const seeds *s);

#endif
