/* picture.h - a method's picture, drawn once; and what a picture holds at a place of the world. */
#ifndef LAB_PICTURE_H
#define LAB_PICTURE_H

#include "kit/kit_gl.h"

/* Opens a run of a method by its name and settings. */
int picture_run(kit_run *run, kit_gbuffer *g, const kit_world *world, const char *method, const char *set, float radius,
                kit_error *err);
/* Draws such a run once, reads its picture and closes it. */
int picture_drawn(kit_image *out, kit_gbuffer *g, const kit_world *world, const char *method, const char *set,
                  float radius, kit_error *err);

/* With a history: SETTLED frames of a still camera, numbered from first, and 1; else one, and 0; -1 = failed. */
enum { SETTLED = 16 };
int picture_settled(kit_run *run, unsigned first, int timed, kit_error *err);

/* A frame's channel Z, its camera, and which object each pixel shows (NULL: not asked). */
typedef struct picture_view {
    const kit_image  *frame;
    const kit_camera *camera;
    const uint32_t   *object;
} picture_view;
/* What a picture's values hold at a place of an object, between four pixels; 0 if the frame shows something else
   there. */
int picture_at(double *value, const float *values, const picture_view *s, const float p[3], uint32_t object);

#endif
