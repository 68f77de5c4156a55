/* look.h - scenes by seed for the comparison of two builds, with the truth at some of the pixels. */
#ifndef LAB_LOOK_H
#define LAB_LOOK_H

#include "lab/against/subjects.h"
#include "lab/measure/folder.h"
#include "lab/measure/stage.h"

#define LOOK_FOLDER FOLDER_CACHE "/against"
/* The truth is known at every LOOK_STRIDE-th pixel both ways. The stride is odd, so that all four pixels of a 2x2 are
   judged equally often. A turning camera makes LOOK_FRAMES frames, LOOK_ORBIT degrees apart. */
enum { LOOK_WIDTH = SEED_WIDTH, LOOK_HEIGHT = SEED_HEIGHT, LOOK_STRIDE = SEED_STRIDE, LOOK_FRAMES = 8 };
#define LOOK_ORBIT 0.5

/* One camera's view of a scene. shown: channel Z of each pixel. At the pixels with a truth: middles (Z), truth and
   nothing (the value without occlusion), for visibility and light. light: mean light of unoccluded surfaces. */
typedef struct look { kit_image shown, middles, truth[2], nothing[2]; double light; } look;
typedef struct place { int seed; char name[16], env[32]; look by[VIEWS]; } place;

/* Loads scene random:SEED, saves its frames, and traces or reads the truth that the rows need (wanted[i] is 1 if
   subject i is drawn). A GL context must be open. */
int   place_open(place *p, int seed, const int *wanted, kit_error *err);
look *place_look(place *p, int view);          /* one look for all views with the same camera */
void  place_frame(char path[64], const place *p, int view);
/* Copies the middle pixel of each LOOK_STRIDE x LOOK_STRIDE block. */
int   look_middles(kit_image *out, const kit_image *in, kit_error *err);

#endif
