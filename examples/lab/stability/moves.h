/* moves.h - how steady methods are while a camera moves past what stands still. */
#ifndef LAB_MOVES_H
#define LAB_MOVES_H

#include "kit/kit.h"

enum { MOST_MOVES = 16 };

/* scene, method: NULL after the last; without any, those of moves.c. A method may have settings behind a colon. */
typedef struct moves_options {
    const char *scene[MOST_MOVES + 1], *method[MOST_MOVES + 1];
    int width, rays;
} moves_options;

/* Prints a table: of each method and scene the deviation over frames of places that are followed, less the truth's, and
   the error of the eighth frame. The truth is kept under build/cache. */
int moves(const moves_options *o, kit_error *err);

#endif
