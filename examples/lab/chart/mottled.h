/* mottled.h - a row's noise and its error in bands of frequency (lab/measure/bands.h), in thousandths of visibility,
   over smooth surfaces in shade. */
#ifndef LAB_MOTTLED_H
#define LAB_MOTTLED_H

#include "lab/measure/bands.h"

/* smooth: the pixels of a stage that show a smooth surface in shade; pair: two truths of the stage. */
typedef struct mottled { shaded smooth; kit_image pair; } mottled;
/* The stage must be looked at, and not compared yet: then all pixels of its frame count. */
int  mottled_open(mottled *m, const stage *s, kit_error *err);
void mottled_close(mottled *m);
/* Draws the row's method once more with each of two phases of its noise, and fills in the bands. */
int  mottled_row(row *r, const mottled *m, stage *s, kit_error *err);

#endif
