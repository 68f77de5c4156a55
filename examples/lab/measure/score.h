/* score.h - how far a picture is from a stage's truth, as figures of a row. */
#ifndef LAB_SCORE_H
#define LAB_SCORE_H

#include "lab/measure/stage.h"

/* Scores a picture over what the frame shows, and where the picture is known; the unit on the same pixels. */
int score_picture(row *r, const stage *s, const kit_image *picture, kit_error *err);

/* A row whose figures come from a picture of light, without a time. */
int score_named(row *r, const stage *s, const char *label, const kit_image *picture, kit_error *err);
/* How far a truth of light is off by itself: against several times its rays. */
int score_noise(row *r, const stage *s, const char *label, kit_error *err);

/* What a row's irradiance or ambient visibility is off by: on the mean over the phases of the noise, and from phase to
   phase. picture: the first phase's; run draws the others; NULL: a picture that has no noise. A second phase that is
   the first over again is the last. */
int score_phases(row *r, stage *s, kit_run *run, int phases, const kit_image *picture, kit_error *err);

#endif
