/* score.h - scores a picture against a stage's truth, as figures of a row. */
#ifndef LAB_SCORE_H
#define LAB_SCORE_H

#include "lab/measure/stage.h"

/* Scores a picture, and the stage's unit, over the pixels that the frame shows and the picture knows. */
int score_picture(row *r, const stage *s, const kit_image *picture, kit_error *err);

/* Makes a row by scoring a picture of light, without a time. */
int score_named(row *r, const stage *s, const char *label, const kit_image *picture, kit_error *err);
/* Makes the row of the truth's own noise in light, by a truth of several times its rays. */
int score_noise(row *r, const stage *s, const char *label, kit_error *err);

/* Splits the error of a row's irradiance or visibility into that of the mean over phases of the noise and the deviation
   from phase to phase. picture: of the first phase; run draws the others (NULL: the picture has no noise). If the
   second phase equals the first, no more are drawn. */
int score_phases(row *r, stage *s, kit_run *run, int phases, const kit_image *picture, kit_error *err);

#endif
