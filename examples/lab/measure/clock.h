/* clock.h - what drawing takes, beside a reference that is drawn in the same rounds. */
#ifndef LAB_CLOCK_H
#define LAB_CLOCK_H

#include "lab/measure/stage.h"

extern const entry clock_reference;            /* what times are relative to */
enum { CHART_ROUNDS = 5, QUICK_ROUNDS = 3 };   /* at the most */

/* A timed draw; milliseconds. */
double clock_draw(kit_run *run);
/* Times what once(of, i) draws, all drawn before, in ms: each once a round between two drawings of the reference, whose
   mean its time is divided by; medians. What is slow, or agrees with itself, sits out late rounds. */
int clock_all(row *rows, stage *s, double (*once)(void *of, int i), void *of, int count, int rounds, kit_error *err);
/* Times runs, and closes them. Where there is light, ambient visibility's time includes the lights' passes. */
int clock_runs(row *rows, stage *s, kit_run *run, int count, int rounds, kit_error *err);

#endif
