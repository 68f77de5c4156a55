/* shot.h - a scene as one frame of a sweep shows it, with its truth and the methods' pictures of it. */
#ifndef LAB_SHOT_H
#define LAB_SHOT_H

#include "kit/kit_gl.h"
#include "lab/measure/picture.h"
#include "lab/stability/sweeps.h"

enum { MOST_OBJECTS = 64 };
typedef struct shot {
    kit_scene    scene;
    kit_gbuffer  gbuffer;
    kit_lighting lighting;
    kit_image    frame, truth[2];                          /* truth: of all, between objects */
    kit_image    picture[MOST_METHODS], single[MOST_METHODS];
    float       *mask, to_world[MOST_OBJECTS][16];         /* mask: above 0 where it is scored */
    uint32_t    *object;
    float        radius;
} shot;

/* truths: which are traced. */
int    shot_open(shot *s, const look *l, const int truths[2], kit_error *err);
void   shot_close(shot *s);

/* The camera that a look asks for; returns how wide one of its pixels is at the target. */
float  shot_aim(kit_camera *c, const look *l);
/* Draws method m; with what the frame before kept, and, as single, without, noise alike. */
int    shot_draw(shot *s, int m, kit_error *err);
int    shot_draw_kept(shot *s, int m, kit_frames *frames, kit_error *err);
/* What is compared: ambient visibility, or, which under white light is the same, irradiance over pi. */
float *shot_values(const kit_image *picture);
/* What a picture holds at a place of an object, between four pixels; 0 if the frame shows something else there. */
int    shot_value_at(double *value, const shot *s, const kit_image *picture, const float p[3], uint32_t object);
/* The place that a pixel shows. */
void   shot_place(const shot *s, int pixel, float p[3]);
/* What pictures of so many frames hold at a place that the first one shows, which moves as its object does; 0: some
   frame does not show it. */
int    shot_followed(double *v, const shot *shots, int frames, const kit_image *const *pictures, int pixel);
/* Root of the mean square difference (a NULL: to 1 everywhere) where b is known and it is scored. What is no number is
   off by 1. */
double shot_apart(const kit_image *a, const kit_image *b, const float *mask);

#endif
