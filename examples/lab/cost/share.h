/* share.h - bodies: what an `if` of the GLSL guards, which a wave leaves out where no lane of it enters; how many waves
   enter, and what a pass costs by that. */
#ifndef COST_SHARE_H
#define COST_SHARE_H

#include "lab/cost/count.h"
#include "lab/measure/csv.h"
#include "ssgi_gl.h"

/* line: no other line of a text has it; tells: goes before it, GLSL that sets told, a bit for each time that a pixel
   comes to the line, and shown, whether something is seen there. times: how often it comes there, 0: directions times
   steps, with each side. */
typedef struct body { const char *name, *line, *tells; int times; } body;
enum { COVER, COVER_SOLID, SECOND, SENT, UNSETTLED, CHANGED, BODIES };
extern const body bodies[BODIES];

/* A stage of a pass, for the caller to free; NULL: it has none, or there is no memory. */
char *text_of(const ssgi_gl_desc *d, int stage);

/* Those that a text has, in its order; how many. */
int bodies_of(int of[BODIES], const char *text);

/* Texels of a wave. */
typedef struct tile { const char *name; int width, height; } tile;
enum { SQUARE, FLAT, SMALL, TILES };
extern const tile tiles[TILES];

/* What a texel tells: of two sides the bits, 1 where it entered; where nothing is seen the second is -1 less them. */
typedef struct told { float entered[2]; } told;

/* How often a wave enters, of the times that it comes to the line, on the mean over those waves of which a texel at
   least shows something. waves: how many of all these are. */
double share_of(const told *texel, int width, int height, const tile *t, int times, double *waves);

/* The share that was recorded (shares.csv) of the gather most like a pass: of its size, by the number of its steps;
   where a camera both stands and turns, of the latter. NAN: there is none. */
double share_recorded(const csv *shares, int which, const ssgi_gl_desc *d, const tile *t);

/* What a wave of a pass executes on the mean. share: of each body that its text has. Where the compiler left as many
   bodies as the text has, or both sides' one after the other, each counts by its own; where the text has one, all that
   may be left out goes by that; where it has none, all counts. -1: bodies cannot be told apart, all counts. */
int weigh(counts *c, const counted *of, const double *share, int count);

#endif
