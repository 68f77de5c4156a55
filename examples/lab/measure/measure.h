/* measure.h - rows of methods on a stage: drawn, scored, timed. */
#ifndef LAB_MEASURE_H
#define LAB_MEASURE_H

#include "lab/measure/clock.h"
#include "lab/measure/score.h"

/* Fills a row an entry, then one for each of what is given: count + s->givens in all. Every entry is drawn once to warm
   up, with a history SETTLED frames (that picture is scored), over so many phases of its noise (0: one, and no split is
   known), then timed; rounds 0: not timed, and closed at once. pictures: NULL, or an empty one an entry. */
int measure_entries(row *rows, stage *s, const entry *entries, int count, int rounds, int phases, kit_image *pictures,
                    kit_error *err);
/* Times alone: no picture, no truth; of a stage that is loaded and looked at. */
int measure_times(row *rows, stage *s, const entry *entries, int count, int rounds, kit_error *err);

#endif
