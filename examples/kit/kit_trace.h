/* kit_trace.h - shared by camera.c, truth.c, lit.c, scatter.c and floor.c: cameras in doubles, random rays, and
   pictures made of them. Private to them. */
#ifndef KIT_TRACE_H
#define KIT_TRACE_H

#include "kit/kit.h"
#include "ssgi.h"

/* ---- >>camera */

/* Writes the camera's axes, which are the rows of its rotation: right, up, backward. */
void   kit_camera_axes(const kit_camera *camera, double axes[3][3]);
/* Writes half the image's width and height: at view depth 1; in world units if orthographic. */
void   kit_camera_half(const kit_camera *camera, double half[2]);
/* Writes the view-space ray through a pixel's centre: a point at view depth z is o + d z. The camera's shift is in
   pixels, +x to the right, +y upward. */
void   kit_camera_view_ray(const kit_camera *camera, int x, int y, double o[3], double d[3]);
int    kit_camera_check(const kit_camera *camera, const char *what, kit_error *err);

/* ---- >>rays from a point */

typedef struct kit_ambient {
    ssgi_trace trace;
    float      radius;
    int        attenuation, rays;
    const kit_scene *others;        /* if not NULL, only those of its objects count that cast, except object `own` */
    uint32_t   own;
    /* second dimension of Sobol's sequence with bits reversed (the first is the index); their number is a power of two,
       at least `rays` */
    uint32_t  *points;
    uint32_t   mask;                /* number of points less one, which selects the bits of an index */
} kit_ambient;

static inline uint32_t kit_reverse(uint32_t x)
{
    x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
    x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
    x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
    x = (x >> 8 & 0x00ff00ffu) | (x & 0x00ff00ffu) << 8;
    return x >> 16 | x << 16;
}

/* Returns the hash of PCG [O'Neill 2014]. */
static inline uint32_t kit_mix(uint32_t x)
{
    x = x * 747796405u + 2891336453u;
    x = (x >> ((x >> 28) + 4) ^ x) * 277803737u;
    return x >> 22 ^ x;
}

/* Scrambles a point's coordinate by nested uniform scrambling with a hash [Laine and Karras 2011; Burley 2020]. */
static inline uint32_t kit_scramble(uint32_t reversed, uint32_t seed)
{
    uint32_t x = reversed ^ reversed * 0x3d20adeau;
    x += seed;
    x *= seed >> 16 | 1u;
    x ^= x * 0x05526c56u;
    x ^= x * 0x53a22864u;
    return kit_reverse(x);
}

/* Checks the arguments and fills a, except for its member trace; the caller frees points. */
int    kit_ambient_begin(kit_ambient *a, float radius, int attenuation, int rays, const char *what, kit_error *err);
void   kit_ambient_point(const kit_ambient *a, uint32_t i, uint32_t seed, float at[2]);      /* in [0,1)^2 */
/* kit_around writes direction x, y, z in axes about n; the other a cosine-weighted one of a point in [0,1)^2. */
void   kit_around(const float n[3], float x, float y, float z, float d[3]);
void   kit_cosine_direction(const float n[3], const float at[2], float d[3]);
/* Returns the part of a direction's light that the nearest hit within radius blocks, [0,1]; hit may be NULL. */
double kit_occluded(const kit_ambient *a, const float origin[3], const float d[3], ssgi_hit *hit);
/* Writes p moved off its surface along the unit vector lift, by about ten times the rounding of coordinates as large as
   magnitude. */
void   kit_lift_off(const float p[3], float magnitude, const float lift[3], float origin[3]);
float  kit_ambient_at(const kit_ambient *a, uint32_t pixel, const float origin[3], const float n[3]);  /* n unit */
/* Makes a trace of triangles. The caller calls free(memory) after it last uses the trace. */
int    kit_trace_new(ssgi_trace *trace, void **memory, const float *position, const uint32_t *index, size_t triangles,
                     const char *what, kit_error *err);

/* ---- >>a picture of them */

typedef struct kit_place {              /* a place on the surface that a ray hits */
    float origin[3];                /* the point, lifted off the face toward the ray's origin */
    float n[3];                     /* shading normal, turned to the side of the ray's origin */
    const float *albedo;
    uint32_t object;
} kit_place;

typedef struct kit_truth kit_truth;
struct kit_truth {
    kit_ambient         ambient;
    const kit_scene    *scene;
    const kit_mesh     *mesh;       /* its */
    kit_camera          camera;
    kit_image           out;
    int                 stride;
    /* one value a channel */
    void              (*pixel)(const kit_truth *job, uint32_t pixel, const kit_place *at, float *value);
    float               background;
    const kit_lighting *lighting;
    int                 bounce;
    const kit_image    *env;                   /* the lighting's environment, or what is left of it without its lamps */
    float              *env_row, *env_column;   /* running sums, see env_begin; NULL = no environment */
    int                 env_cells[2];           /* columns, rows */
    struct lamp        *lamp;                   /* see lamps_begin */
    int                 lamps;
    double              exponent;   /* of the lobe */
    const struct scattering *within;
};

static inline int kit_shown(float z) { return z > 0 && z < SSGI_FAR; }      /* whether a pixel shows a surface */
static inline int kit_skipped(int x, int y, int stride) { return x % stride != stride / 2 || y % stride != stride / 2; }

static inline double kit_facing(const float n[3], const float d[3])
{
    return (double)n[0] * (double)d[0] + (double)n[1] * (double)d[1] + (double)n[2] * (double)d[2];
}

static inline void kit_mirror(const float d[3], const float n[3], float mirrored[3])    /* n unit */
{
    const float along = 2 * (float)kit_facing(n, d);
    for (int i = 0; i < 3; ++i) mirrored[i] = d[i] - along * n[i];
}

/* Traces a pixel's ray, which it also returns, to the first surface between the near and the far plane, as these cut
   the G-buffer. Returns 0 if there is none. */
int    kit_camera_hit(ssgi_hit *hit, float origin[3], float direction[3], const ssgi_trace *trace,
                      const kit_camera *camera, int x, int y);
void   kit_place_of(const kit_mesh *mesh, const ssgi_hit *hit, const float direction[3], kit_place *at);
/* Computes an image of these channels. job: the caller sets pixel, background and the members that pixel reads. */
int    kit_truth_run(kit_truth *job, kit_image *out, const char *channels, const kit_scene *scene,
                     const kit_camera *camera, float radius, int attenuation, int rays, int stride, kit_error *err);

/* ---- >>lit */

/* Turns the weights at cdf[1..n] into their running sum, from cdf[0] = 0 to cdf[n] = 1 (all 0 if all weights are 0),
   and returns their mean. */
double kit_accumulate(float *cdf, int n);
double kit_pick(const float *cdf, int n, float u);     /* returns the index at which the running sum is u, in [0, n) */
/* Adds up the irradiance over pi at a place and, unless bounce is NULL, the light that the hits around it reflect.
   rays: the numbers of cosine-weighted rays and of rays drawn by the environment, each from point first on. */
void   kit_gather(const kit_truth *job, const kit_place *at, uint32_t seed, uint32_t first, const int rays[2],
                  double irradiance[3], double *bounce);

#endif
