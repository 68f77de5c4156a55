/* shot.h - draws a scene as one frame of a sweep shows it: its truth and the methods' pictures. */
#ifndef LAB_SHOT_H
#define LAB_SHOT_H

#include "kit/kit_gl.h"
#include "lab/measure/picture.h"
#include "lab/stability/sweeps.h"

enum { MOST_OBJECTS = 64, MOST_FRAMES = 16 };
typedef struct shot {
    kit_scene    scene;
    kit_gbuffer  gbuffer;
    kit_lighting lighting;
    kit_image    frame, truth[2];                          /* truth[1]: of FAR methods */
    kit_image    none;                                     /* without the effect; no data: 1 everywhere */
    kit_image    picture[MOST_METHODS], single[MOST_METHODS];
    float       *mask, to_world[MOST_OBJECTS][16];         /* mask: above 0 at the pixels that are scored */
    uint32_t    *object;
    float        radius;
    look         look;
} shot;

/* Opens the scene, the frame and the truths of a look. truths[k] is 1 if truth k is traced. */
int    shot_open(shot *s, const look *l, const int truths[2], kit_error *err);
void   shot_close(shot *s);

/* Aims a camera as a look says. Returns the width of one of its pixels at the target. */
float  shot_aim(kit_camera *c, const look *l);
/* Draws method m. shot_draw_kept also draws it with history; single has the picture without it, by the same noise. */
int    shot_draw(shot *s, int m, kit_error *err);
int    shot_draw_kept(shot *s, int m, kit_frames *frames, kit_error *err);
/* Returns the values to compare: ambient visibility, or irradiance over pi, which equals it under white light. */
float *shot_values(const kit_image *picture);
/* Returns how many of an image's 256 shades the scored pixels have. */
int    shot_shades(const kit_image *picture, const float *mask);
/* Interpolates a picture at a point of an object. Returns 0 if the frame shows another surface there. */
int    shot_value_at(double *value, const shot *s, const kit_image *picture, const float p[3], uint32_t object);
/* Writes the point of the scene that a pixel shows. */
void   shot_place(const shot *s, int pixel, float p[3]);
/* Writes the variance over so many pictures at the point that a pixel of the first one shows, carried along with its
   object, and the mean. second: instead of the variance a sixth of the mean square of second differences. Returns 0 if
   some frame does not show the point. */
int    shot_varies(double *square, double *mean, const shot *shots, int frames, const kit_image *const *pictures,
                   int pixel, int second);
/* Returns the RMSE between two pictures (a without data: 1 everywhere) over the pixels that are scored and known in b.
   A value that is no number has an error of 1. */
double shot_apart(const kit_image *a, const kit_image *b, const float *mask);

#endif
