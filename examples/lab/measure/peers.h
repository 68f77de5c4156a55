/* peers.h - rows of other libraries' effects, drawn, scored and timed on a stage. */
#ifndef LAB_PEERS_H
#define LAB_PEERS_H

#include "lab/measure/stage.h"

#define PEERS_THEY "three.js, n8ao, Babylon.js and PlayCanvas"
enum { MOST_PEERS = 32, PEERS_QUICK = 10 };

/* Fills rows of ambient visibility: each peer with the stage's radius, at some of its qualities; if most is below
   MOST_PEERS, one quality of each, PEERS_QUICK in all. figure[FITTED]: the relative error after the best fit;
   figure[FIT + i]: after each of a table of fits. rounds 0: not timed. pictures: NULL, or room for one a row. Returns
   how many rows; 0 = none, peers_missing() says why; -1 = failed. The rows' names last until the next call. */
int peers_measure(row *rows, stage *s, int rounds, int most, kit_image *pictures, kit_error *err);
/* Returns why there were no peers, in one line; "": there were, or none were asked for. */
const char *peers_missing(void);

#endif
