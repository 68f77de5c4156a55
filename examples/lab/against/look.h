/* look.h - scenes by seed as two builds get them, with the truth at some of the pixels. */
#ifndef LAB_LOOK_H
#define LAB_LOOK_H

#include "lab/against/subjects.h"
#include "lab/measure/folder.h"
#include "lab/measure/stage.h"

#define LOOK_FOLDER FOLDER_CACHE "/against"
/* The truth is known at every LOOK_STRIDE-th pixel both ways: an odd number, so that of each 2x2 every pixel is judged
   alike. A camera that turns does so for LOOK_FRAMES frames, by LOOK_ORBIT degrees each. */
enum { LOOK_WIDTH = SEED_WIDTH, LOOK_HEIGHT = SEED_HEIGHT, LOOK_STRIDE = SEED_STRIDE, LOOK_FRAMES = 8 };
#define LOOK_ORBIT 0.5

/* By one camera: Z of the frame; at those pixels Z, and of visibility and of light the truth and what nothing done
   gives; the mean light of open surfaces. */
typedef struct look { kit_image shown, middles, truth[2], nothing[2]; double light; } look;
typedef struct place { int seed; char name[16], env[32]; look by[VIEWS]; } place;

/* Loads a scene, saves its frames, knows or traces its truth, as far as rows want it (wanted: 1 for each of subjects
   that does). All in a context that is open. */
int   place_open(place *p, int seed, const int *wanted, kit_error *err);
look *place_look(place *p, int view);          /* views that show the same share one */
void  place_frame(char path[64], const place *p, int view);
/* The middle pixel of each LOOK_STRIDE x LOOK_STRIDE. */
int   look_middles(kit_image *out, const kit_image *in, kit_error *err);

#endif
