/* picture.h - draws a method's picture, and looks up its value at a point of the scene. */
#ifndef LAB_PICTURE_H
#define LAB_PICTURE_H

#include "kit/kit_gl.h"

/* A method and its settings, as a command line names them: METHOD or METHOD:KEY=VALUE,.. request_read splits such a
   text and makes the method. */
typedef struct request { char method[64], settings[256]; } request;
int request_read(request *a, kit_method *m, const char *text, kit_error *err);

/* Opens a run: a method with settings, which draws a G-buffer's frame. */
int picture_run(kit_run *run, kit_gbuffer *g, const kit_world *world, const char *method, const char *set, float radius,
                kit_error *err);
/* Opens a run of a method with settings, draws once, reads the picture and closes the run. */
int picture_drawn(kit_image *out, kit_gbuffer *g, const kit_world *world, const char *method, const char *set,
                  float radius, kit_error *err);

/* picture_settled: draws a run. With history: SETTLED frames of a still camera, numbered from first, and returns 1;
   else one frame, and returns 0; -1 = failed. */
enum { SETTLED = 16 };
int picture_settled(kit_run *run, unsigned first, int timed, kit_error *err);

/* A frame by its channel Z, its camera, and the object that each pixel shows (NULL: not needed). */
typedef struct picture_view {
    const kit_image  *frame;
    const kit_camera *camera;
    const uint32_t   *object;
} picture_view;
/* Interpolates a picture's values at a point of an object. Returns 0 if the frame shows another surface there. */
int picture_at(double *value, const float *values, const picture_view *s, const float p[3], uint32_t object);

#endif
