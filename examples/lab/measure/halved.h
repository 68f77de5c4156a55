/* halved.h - rows drawn at half the width and height beside whole ones: ambient visibility, brought to full size. */
#ifndef LAB_HALVED_H
#define LAB_HALVED_H

#include "lab/measure/measure.h"

/* half: of the picture's width and height, brought to full size bilinearly, which is not in its time */
typedef struct sized { entry entry; int half; } sized;
/* Each drawn once, scored, timed; sides of the stage's picture even. pictures: NULL, or an empty one an entry, of full
   size. */
int halved_entries(row *rows, stage *s, const sized *entries, int count, int rounds, kit_image *pictures,
                   kit_error *err);

#endif
