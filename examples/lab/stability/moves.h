/* moves.h - how steady methods are while a camera moves past what stands still. */
#ifndef LAB_MOVES_H
#define LAB_MOVES_H

#include "kit/kit.h"
#include "lab/page/page.h"

enum { MOST_MOVES = 24 };

/* scene, method, kind: NULL after the last; without any, those of moves.c. A method may have settings behind a colon.
   from: the first seed of scenes, and number of models; count: of scenes, 0: all. */
typedef struct moves_options {
    const char *scene[MOST_MOVES + 1], *method[MOST_MOVES + 1], *kind[MOST_MOVES + 1];
    int width, rays, from, quick, count;
} moves_options;

/* Kinds of frames that a host makes, besides those of moves: a camera that stands, jitter, changes of size, uneven
   time. */
void moves_of_hosts(moves_options *o);

/* Prints a table: of each scene, by its kind of move, and method the deviation over frames of places that are followed,
   less the truth's, while history fills and after; the error of the last frame, and that over the error of the frame
   alone; where the camera stands the error of TAA's picture. csv, where it is not NULL: the same as rows, beneath their
   names. Truths are kept under build/cache. */
int moves(const moves_options *o, FILE *csv, kit_error *err);

#endif
