/* picture.h - draws a method's picture, and looks up the value at a place of the world. */
#ifndef LAB_PICTURE_H
#define LAB_PICTURE_H

#include "kit/kit_gl.h"

/* Opens a run of a method with settings. */
int picture_run(kit_run *run, kit_gbuffer *g, const kit_world *world, const char *method, const char *set, float radius,
                kit_error *err);
/* Opens such a run, draws once, reads the picture and closes the run. */
int picture_drawn(kit_image *out, kit_gbuffer *g, const kit_world *world, const char *method, const char *set,
                  float radius, kit_error *err);

/* Draws a run. With history: SETTLED frames of a still camera, numbered from first, and returns 1; else one frame, and
   returns 0; -1 = failed. */
enum { SETTLED = 16 };
int picture_settled(kit_run *run, unsigned first, int timed, kit_error *err);

/* A frame's channel Z, its camera, and the object that each pixel shows (NULL: not needed). */
typedef struct picture_view {
    const kit_image  *frame;
    const kit_camera *camera;
    const uint32_t   *object;
} picture_view;
/* Interpolates the picture's values at a place of an object. Returns 0 if the frame shows another place there. */
int picture_at(double *value, const float *values, const picture_view *s, const float p[3], uint32_t object);

#endif
