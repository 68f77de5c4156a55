/* clock.h - times drawing, beside a reference that is drawn in the same rounds. */
#ifndef LAB_CLOCK_H
#define LAB_CLOCK_H

#include "lab/measure/stage.h"

extern const entry clock_reference;            /* the reference, by whose time times are divided */
enum { CHART_ROUNDS = 5, QUICK_ROUNDS = 3 };   /* at most */

/* Draws a run with timing on. Returns milliseconds. */
double clock_draw(kit_run *run);
/* Times once(of, i), which draws number i and returns milliseconds; each was drawn before. In a round each is drawn
   once, between two drawings of the reference, and its time is divided by the mean of theirs. The result is the median.
   Slow rows, and rows whose ratios agree, are left out of late rounds. */
int clock_all(row *rows, stage *s, double (*once)(void *of, int i), void *of, int count, int rounds, kit_error *err);
/* Times runs of methods, and closes them. On a lit stage ambient visibility's time includes passes of lights. */
int clock_runs(row *rows, stage *s, kit_run *run, int count, int rounds, kit_error *err);

#endif
