/* peers.h - rows of what people would pick instead of this library, drawn, scored and timed on a stage. */
#ifndef LAB_PEERS_H
#define LAB_PEERS_H

#include "lab/measure/stage.h"

#define PEERS_THEY "three.js, n8ao, Babylon.js and PlayCanvas"
enum { MOST_PEERS = 32, PEERS_QUICK = 10 };

/* Rows of ambient visibility: each peer with the radius matched to the stage's, at some of its
   qualities; with room for fewer than MOST_PEERS rows, one of each, PEERS_QUICK in all. figure[FITTED] is the share
   after the best fit, figure[FIT + i] those after each of a table of fits. rounds 0: not timed.
   pictures: NULL, or room for one a row. How many there are; 0 = none, peers_missing() says why; -1 = failed. Their
   names last until the next call. */
int peers_measure(row *rows, stage *s, int rounds, int most, kit_image *pictures, kit_error *err);
/* Why there were none, in one line; "" = there were, or none were asked for. */
const char *peers_missing(void);

#endif
