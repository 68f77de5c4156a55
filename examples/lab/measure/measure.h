/* measure.h - rows of methods on a stage: drawn, scored, timed. */
#ifndef LAB_MEASURE_H
#define LAB_MEASURE_H

#include "lab/measure/clock.h"
#include "lab/measure/score.h"

/* Fills a row for each entry, then one for each given picture: count + s->givens in all. Each entry is drawn once to
   warm up, or SETTLED frames with history; that picture is scored. phases: drawn with so many phases of noise, which
   split error from noise (0: no split). rounds: of timing; 0: none. pictures: NULL, or an empty one for each entry. */
int measure_entries(row *rows, stage *s, const entry *entries, int count, int rounds, int phases, kit_image *pictures,
                    kit_error *err);
/* Times entries on a stage after stage_look, without pictures and truth. */
int measure_times(row *rows, stage *s, const entry *entries, int count, int rounds, kit_error *err);

#endif
