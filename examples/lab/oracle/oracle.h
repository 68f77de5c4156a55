/* oracle.h - what oracle.c lends to surfels.c and harmonics.c: a few hundred pixels of a scene, known exactly.

   All is in the picture's view space, y up, the camera looking down -z. */
#ifndef ORACLE_H
#define ORACLE_H
#include "kit/kit_gl.h"

enum { ORACLE_WIDTH = 320, ORACLE_HEIGHT = 180, ORACLE_APART = 12 };

typedef struct oracle_pixel {
    int   x, y;                            /* of the picture, row 0 at the top */
    float p[3], n[3], lifted[3];           /* lifted: where rays start */
} oracle_pixel;

typedef struct oracle {
    kit_scene     scene;
    kit_gbuffer   g;
    ssgi_trace    trace;                   /* of the scene's triangles */
    void         *memory;
    float        *position;
    float         to_view[16], radius;
    oracle_pixel *pixel;                   /* every ORACLE_APART-th both ways that shows something */
    int           pixels;
} oracle;

enum { ORACLE_SETS = 16, ORACLE_RAYS = 1024 };

int    oracle_open(oracle *o, const char *scene, kit_error *err);
void   oracle_close(oracle *o);
/* Ray number i of a pixel or surfel, by the cosine about n. */
void   oracle_ray(float d[3], uint32_t of, int i, const float n[3]);
/* The pixel's value in a picture as build/render writes it. */
float  oracle_value(const oracle *o, const kit_image *picture, int pixel, const char *channel);

/* RMSE of count values over that of nothing (what none has in its place), and the mean difference, printed as a row. */
void   oracle_row(const char *name, const double *value, const double *truth, const double *none, int count);

int    surfels_diagnosis(oracle *o, double size, kit_error *err);
/* env: as kit_env_read takes it; solid_angle: of the lobe that it is seen through, 0: as it is. */
int    harmonics_diagnosis(oracle *o, const char *env, double solid_angle, kit_error *err);

#endif
