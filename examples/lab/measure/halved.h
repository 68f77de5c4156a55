/* halved.h - rows of ambient visibility drawn at half the width and height, and enlarged, beside rows at full size. */
#ifndef LAB_HALVED_H
#define LAB_HALVED_H

#include "lab/measure/measure.h"

/* An entry. half: drawn at half the width and height, and then enlarged bilinearly, for which no time is counted. */
typedef struct sized { entry entry; int half; } sized;
/* Draws each entry once, scores it and times it. The stage's width and height must be even. pictures: NULL, or an empty
   one for each entry; they get full size. */
int halved_entries(row *rows, stage *s, const sized *entries, int count, int rounds, kit_image *pictures,
                   kit_error *err);

#endif
