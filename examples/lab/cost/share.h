/* share.h - bodies. A body is guarded by an `if` of the GLSL, and a wave skips it if none of its lanes enters it. How
   many waves enter a body, and the cost of a pass by that. */
#ifndef COST_SHARE_H
#define COST_SHARE_H

#include "lab/cost/count.h"
#include "lab/measure/csv.h"
#include "ssgi_gl.h"

/* line: a line that occurs once in a shader. tells: GLSL that goes before the line; it sets a bit of told each time
   that a pixel comes to the line and enters the body, and sets shown if a surface is seen there. times: how often a
   pixel comes to the line; 0: directions times steps, for each of two sides. */
typedef struct body { const char *name, *line, *tells; int times; } body;
enum { COVER, COVER_SOLID, SECOND, SENT, UNSETTLED, CHANGED, BODIES };
extern const body bodies[BODIES];

/* Returns the shader of a stage of a pass, which the caller frees; NULL: there is no such stage, or no memory. */
char *text_of(const ssgi_gl_desc *d, int stage);

/* Finds the bodies that a shader has, in its order. Returns how many. */
int bodies_of(int of[BODIES], const char *text);

/* The rectangle of texels that a wave covers. */
typedef struct tile { const char *name; int width, height; } tile;
enum { SQUARE, FLAT, TILES };
extern const tile tiles[TILES];

/* A texel's bits for two sides of a slice, 1 if it entered. Without a surface the second is -1 less its bits. */
typedef struct told { float entered[2]; } told;

/* Returns how often a wave enters a body, of the times that it comes to the line: the mean over the waves of which at
   least one texel shows a surface. */
double share_of(const told *texel, int width, int height, const tile *t, int times);

/* Returns the share that shares.csv records for the gather most like a pass: by its resolution first, then by the
   number of its samples; rows of a camera that stands do not count. NAN: there is none. */
double share_recorded(const csv *shares, int which, const ssgi_gl_desc *d, const tile *t);

/* Weighs counts to the mean work of a wave. share: of each body in the shader. If the compiler left as many bodies as
   the shader has, or twice as many for the two sides, each counts by its own share. If the shader has one body, all
   that may be skipped counts by its share. If it has none, all counts. -1: bodies cannot be told apart, and all
   counts. */
int weigh(counts *c, const counted *of, const double *share, int count);

#endif
