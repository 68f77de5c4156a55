/* frames.h - vectors, harmonics, pictures of known geometry, and runs on them, which tests share. */
#ifndef FRAMES_H
#define FRAMES_H
#include "owned.h"
#include "t.h"
#include <math.h>
#include <string.h>

/* Sets d to a random unit vector, evenly distributed over the sphere. */
static inline void direction(float d[3])
{
    const float z = t_uniform(-1, 1), r = sqrtf(1 - z * z), a = t_uniform(0, 6.28318531f);
    d[0] = r * cosf(a);
    d[1] = r * sinf(a);
    d[2] = z;
}

/* Raises *worst to an error that is larger. NaN counts as infinite. */
static inline void grow(double *worst, double error)
{
    error = fabs(error);
    if (!(error <= *worst)) *worst = error >= 0 ? error : HUGE_VAL;
}

/* Returns the largest difference between two arrays. */
static inline double apart_by(const float *a, const float *b, int count)
{
    double worst = 0;
    for (int i = 0; i < count; ++i) grow(&worst, (double)a[i] - (double)b[i]);
    return worst;
}

static inline double dot(const float a[3], const float b[3])
{
    return (double)a[0] * (double)b[0] + (double)a[1] * (double)b[1] + (double)a[2] * (double)b[2];
}

static inline void cross(const float a[3], const float b[3], float out[3])
{
    for (int k = 0; k < 3; ++k) out[k] = a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3];
}

/* Packs a texel of pass thickness for ssgi_measured_texel: view depths of a 2x2, thicknesses in radii / 63. */
static inline void pack_measured(uint32_t texel[4], const float z[4], const unsigned thickness[4], int orthographic)
{
    float first = z[0];
    for (int i = 1; i < 4 && !(z[0] < 1e17f); ++i) first = fminf(first, z[i]);
    for (int i = 0; i < 4; ++i) {
        const float kept = orthographic ? i ? z[i] - first : first : z[i] < 1e17f ? z[i] : 2e18f;
        const unsigned own = orthographic && !(z[i] < 1e17f) ? 0 : thickness[i],
                       of_first = z[0] < 1e17f ? thickness[0] : 0;
        memcpy(&texel[i], &kept, sizeof kept);
        if (!orthographic) texel[i] = ((texel[i] + 32) & ~63u) | own;
        else if (i) texel[i] = ((texel[i] + 128) & ~255u) | (of_first >> 2 * (i - 1) & 3) << 6 | own;
    }
}

/* Reads pixel i of such a texel: returns its view depth, and its thickness. */
static inline float unpack_measured(unsigned *thickness, const uint32_t texel[4], int i, int orthographic)
{
    const uint32_t first = (texel[1] >> 6 & 3) | (texel[2] >> 6 & 3) << 2 | (texel[3] >> 6 & 3) << 4,
                   bits = orthographic ? i ? texel[i] & ~255u : 0 : texel[i] & ~63u;
    float z, from;
    *thickness = orthographic && !i ? first : texel[i] & 63;
    memcpy(&z, &bits, sizeof z);
    memcpy(&from, &texel[0], sizeof from);
    return !orthographic ? z : *thickness ? from + z : 1e18f;
}

/* Returns the bits of a half, rounded to the nearest one, or the even one of two; value_of: their value. */
int        half_of(float x);
double     value_of(int half);
/* makes a rigid matrix of camera axes: z is given, and the turn about it is random */
void       rigid_about(float m[16], const float z[3]);
void       through(const float m[16], const float p[3], float w, float out[3]);   /* moves a point by a matrix */

/* returns the occlusion of a point with a normal by a field that a matrix turns, scales and moves */
double     occluded_by(const ssgi_field *f, const ssgi_field_limits *l, const float to[16], const float p[3],
                       const float n[3]);

enum { HARMONICS = SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS };
/* Returns the value of a channel of harmonics in a direction. factor: of each band, NULL: 1. */
double     series(const float *coefficients, int channels, int bands, const float d[3], const double *factor);
/* by band l: 2 pi times the integral of z P_l(z) over [0,1] */
extern const double of_cosine[SSGI_SH_MAX_BANDS];
/* writes a pixel's direction as in OpenEXR: latitude falls from pi/2, longitude from pi; returns its solid angle */
double     equirect(float d[3], int i, int width, int height);
/* makes an environment of bands 0..2 by random coefficients; band 0 keeps it above 0 */
void       smooth_sky(float *rgb, float coefficients[27], int width, int height);

kit_camera looking_along_z(int width, int height, int orthographic);
/* makes the view of a camera; flipped: upside down */
int        view_of(ssgi_view *view, const kit_camera *c, int flipped);
/* Makes the exact picture of the space that planes x * n = n[3] enclose, from within. Channels: Z, N.X, N.Y, N.Z and
   those of more ("" or ",direct.R,..", which are 0). */
int        planes_seen(kit_image *frame, const kit_camera *c, const double (*plane)[4], int planes, const char *more);
int        flat(const kit_image *frame, int x, int y);          /* whether 7x7 pixels show a surface */
/* makes the picture of planes_seen, and a G-buffer of it */
int        walls(kit_gbuffer *g, kit_image *frame, const kit_camera *c, const double (*plane)[4], int planes,
                 const char *more);
void       turn(kit_run *run, kit_gbuffer *g);                  /* sets another G-buffer of the same size */
/* Gives a pass targets of another size, except layers of arrays. data: what they contain, NULL = anything. */
void       resize(kit_pass *p, int width, int height, const float *data);

/* Floor and wall, seen orthographically from 45 degrees above. A radius of 1 is SPAN pixels down the floor and up the
   wall; it is sqrt(2) times as many sideways and in front of the wall, where the surface behind it is seen. Row
   row_at(c) shows at its centre the floor at distance c from the wall. Drawing is cut to the middle columns of one
   row. */
enum { SPAN = 128, MIDDLE = 182, COLUMNS = 64, WIDE = 2 * MIDDLE + COLUMNS, HIGH = SPAN + 16 + MIDDLE };
int        row_at(double c);
/* returns the camera, and the planes of floor and wall; the wall is moved away by behind */
kit_camera corner_planes(double plane[2][4], double c, double behind);
/* returns the mean over phases of noise of the last pass's first channel, in the middle columns of a row */
double     row_of(kit_run *run, kit_gbuffer *g, int row, int phases);
double     linear_corner(double c), hard_corner(double c);      /* return the occlusion at distance c, in radii */

/* ---- scenes and light; all functions return 1 if they succeed */

typedef struct box { float lower[3], upper[3]; } box;
/* makes light. env: "white", 1 everywhere, or a name for kit_env_read; light: for kit_light_parse; NULL = none */
int        lighten(kit_lighting *l, const char *env, const char *light);
/* Makes a built-in scene with added boxes, and its G-buffer; camera NULL: the scene's own. */
int see(kit_scene *scene, kit_gbuffer *g, const char *name, const box *boxes, int count, const kit_camera *camera,
        int width, int height);
/* A built-in scene, its light and its G-buffer; camera NULL: the scene's own. */
typedef struct scenery { kit_scene scene; kit_lighting light; kit_gbuffer g; } scenery;
int        set_scene(scenery *s, const char *name, const kit_camera *camera, const char *env, const char *light,
                     int width, int height);
void       strike(scenery *s);
static inline void own_scenery(scenery *s) { strike(s); }
/* The corner, with a slab of this thickness as its wall, as layers: the slab's face, its back, and the face of an
   endless wall at gap behind it. */
int        slab(kit_gbuffer *g, double c, double thickness, double gap, int layers);
/* Opens a run of a method at the kit's defaults, except for the settings in set. */
int open_run(kit_run *run, kit_gbuffer *g, const char *method, const char *set, float radius, const kit_scene *scene,
             const kit_lighting *lighting);
/* begin opens a method of light with 33 directions of one point, unfiltered, harmonics as published, except for set.
   drawn reads its picture. The third does both. */
int begin(kit_run *run, kit_gbuffer *g, const char *method, const char *set, float radius, const kit_scene *scene,
          const kit_lighting *lighting);
int        drawn(kit_image *out, kit_run *run);
int lit(kit_image *out, kit_gbuffer *g, const char *method, const char *set, float radius, const kit_scene *scene,
        const kit_lighting *lighting);
double     mean(const kit_image *image, const char *channel);
/* open_vector: writes 16 coefficients of the clamped cosine about a normal, which an open plane has. The other writes
   the light [3*i + c] of so many bands that such coefficients give, as irradiance over pi. */
void       open_vector(double v[16], const double n[3]);
double     met(const double v[16], const float *light, int c, int bands);
/* returns the RMSE between the first channels of two pictures */
double     difference(const kit_image *a, const kit_image *b);
#endif
