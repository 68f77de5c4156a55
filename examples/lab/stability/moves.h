/* moves.h - how steady methods are while a camera moves past what stands still. */
#ifndef LAB_MOVES_H
#define LAB_MOVES_H

#include "kit/kit.h"
#include "lab/page/page.h"

enum { MOST_MOVES = 24 };

/* scene, method, kind: NULL after the last; without any, those of moves.c. A method may have settings behind a colon.
   from: the first seed of scenes, and number of models. */
typedef struct moves_options {
    const char *scene[MOST_MOVES + 1], *method[MOST_MOVES + 1], *kind[MOST_MOVES + 1];
    int width, rays, from, quick;
} moves_options;

/* Prints a table: of each scene, by its kind of move, and method the deviation over frames of places that are followed,
   less the truth's, while history fills and after; the error of the last frame, and that over the error of the frame
   alone. csv, where it is not NULL: the same as rows. Truths are kept under build/cache. */
int moves(const moves_options *o, FILE *csv, kit_error *err);

#endif
