/* mottled.h - a row's noise and its error beside the truth by bands of frequency (lab/measure/bands.h), thousandths of
   visibility, where a smooth surface is in shade. */
#ifndef LAB_MOTTLED_H
#define LAB_MOTTLED_H

#include "lab/measure/bands.h"

/* Where a stage is smooth and in shade, and two truths of it. */
typedef struct mottled { shaded smooth; kit_image pair; } mottled;
/* Of a stage that is looked at and not compared yet: all of its frame counts. */
int  mottled_open(mottled *m, const stage *s, kit_error *err);
void mottled_close(mottled *m);
/* Draws the row's method anew, and its next phase. */
int  mottled_row(row *r, const mottled *m, stage *s, kit_error *err);

#endif
