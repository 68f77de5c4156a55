/* mottled.h - a row's noise and its error in bands of frequency (lab/measure/bands.h), in thousandths of visibility,
   over smooth surfaces in shade. */
#ifndef LAB_MOTTLED_H
#define LAB_MOTTLED_H

#include "lab/measure/bands.h"

/* Where noise is measured. smooth: the pixels of a smooth surface in shade; pair: two truths of visibility with other
   noise, which light has not. */
typedef struct mottled { shaded smooth; kit_image pair; } mottled;
/* Finds the smooth pixels, traces the truths. Call it between stage_look and stage_compare: all pixels count. */
int  mottled_open(mottled *m, const stage *s, kit_error *err);
void mottled_close(mottled *m);
/* The bands of a picture's error, and of its noise: run draws it with another phase. Without smooth pixels: unknown. */
int  mottled_bands(bands *noise, bands *off, const mottled *m, stage *s, kit_run *run, const kit_image *picture,
                   kit_error *err);
/* Draws a row's method, and fills in the row's bands. */
int  mottled_row(row *r, const mottled *m, stage *s, kit_error *err);

#endif
