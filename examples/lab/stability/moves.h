/* moves.h - measures how steady methods are while a camera moves past a scene that stands still. */
#ifndef LAB_MOVES_H
#define LAB_MOVES_H

#include "kit/kit.h"
#include "lab/page/page.h"

enum { MOST_MOVES = 24 };

/* The options of moves. scene and method end with NULL; an empty list stands for that of moves.c. A method may have
   settings after a colon. from: the first seed of scenes, and number of models; count: of scenes, 0: all. */
typedef struct moves_options {
    const char *scene[MOST_MOVES + 1], *method[MOST_MOVES + 1];
    int scenes, methods;                       /* that the command line named */
    int width, rays, from, quick, count, of_hosts;
} moves_options;
#define MOVES_OF_CHARTS .width = 640, .rays = 64

/* Asks for the kinds of frames that a host makes: a camera that stands, jitter, changes of size, uneven time. */
void moves_of_hosts(moves_options *o);

/* Writes csv with a row for each scene, with its kind of move, and each method: the deviation over frames of followed
   points, less the truth's, while history fills and after; the error of the last frame, and that over the error of the
   frame alone; with a standing camera the error after TAA. Truths are kept under build/cache. */
int moves(const moves_options *o, FILE *out, kit_error *err);

#endif
