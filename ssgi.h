/* ssgi.h - v0.1 - screen-space illumination: the CPU maths. C99, no dependencies. Public domain or MIT, as you like: end of file.

   Do this in *one* C or C++ file:      #define SSGI_IMPLEMENTATION
                                        #include "ssgi.h"
   and include it plainly elsewhere. The GLSL of every pass is in ssgi_gl.h, which includes this file.

   QUICK USE  (compiled and run by tests/test_build.c)

      float      projection[16] = { 1.3f,0,0,0,  0,2.4f,0,0,  0,0,-1.002f,-1,  0,0,-0.2002f,0 };   // yours; GL, column-major
      ssgi_view  view;
      const char *why = "";
      if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, 1280, 720, &why) != SSGI_OK) puts(why);
      float p[3];
      ssgi_view_position(&view, 640.5f, 360.5f, ssgi_view_depth(&view, 0.75f), p);                 // a depth texel as a view-space point
      printf("%g %g %g, a pixel is %g wide there\n", p[0], p[1], p[2], ssgi_pixel_footprint(&view, -p[2]));

   CONVENTIONS  (one place; every comment relies on it)
      matrices     float[16], element (row r, column c) at m[c*4 + r]; vectors are columns
      view space   right-handed, +x right, +y up, the camera looks along -z; VIEW DEPTH is the positive distance -z
      pixels       (0,0) is the corner of the first texel, centres at (x+0.5, y+0.5), y as in GL textures (upward when the projection is GL's)
      window depth what the depth texture holds, [0,1]
      units        lengths in your view units, angles in radians, radiance linear
      visibility   V = 1 visible, 0 blocked; occlusion O in [0,1]; ambient visibility (what AO passes write) = 1 - O, cosine-weighted
      errors       functions that can be misused return ssgi_result and, through the last argument (may be NULL), a static sentence that begins
                   with the argument's name; outputs are then untouched. Nothing prints, exits, allocates or keeps state: all is reentrant.

   CONFIG       SSGI_STATIC makes every function static. Nothing else changes the header.
   ROOMS        search for ">>"
      >>types      results
      >>view       projection decode: perspective, orthographic, reversed and infinite depth, off-centre
      >>kernel     low-discrepancy points, sample sets, jitter tile
      >>bias       pixel footprint, normal offset, radius guess
      >>trace      a small BVH over your triangles: closest hit, any hit

   SOURCES      [HSAO08] Dimitrov, Bavoil, Sainz 2008, Horizon-split ambient occlusion   [SSDO09] Ritschel, Grosch, Seidel 2009, Approximating
                dynamic global illumination in image space   [SA07] Shanmugam, Arikan 2007, Hardware accelerated ambient occlusion   */
#ifndef SSGI_H
#define SSGI_H

#include <stddef.h>
#include <stdint.h>

#define SSGI_VERSION 100 /* 0.1.0 */

#ifdef SSGI_STATIC
#define SSGI_DEF static
#else
#define SSGI_DEF extern
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ==== >>types ================================================================================================== */

typedef enum ssgi_result {
    SSGI_OK = 0,
    SSGI_BAD_ARGUMENT,      /* the sentence names it */
    SSGI_TOO_SMALL          /* the memory given does not suffice; the size query tells how much does */
} ssgi_result;

/* ==== >>view =================================================================================================== */

/* How a projection's clip z becomes window depth. */
enum { SSGI_CLIP_GL = 0,    /* NDC z in [-1,1], window depth 0.5 z + 0.5: GL's default */
       SSGI_CLIP_ZERO };    /* NDC z in [0,1] = window depth: glClipControl(.., GL_ZERO_TO_ONE); reversed depth wants this */

/* Everything that the passes know of a camera; made by ssgi_view_from_projection, read-only for you. */
typedef struct ssgi_view {
    float unproject[4];     /* view xy = (pixel * [0,1] + [2,3]) * view depth; orthographic: without "* view depth" */
    float project[4];       /* pixel = view xy / view depth * [0,1] + [2,3];   orthographic: without "/ view depth" */
    float depth[2];         /* 1 / view depth = [0] + [1] * window depth;      orthographic: view depth = ... */
    float clear;            /* the window depth of nothing: 1, or 0 when the projection is reversed */
    int   orthographic;     /* 0 or 1 */
    int   width, height;    /* pixels of the picture */
} ssgi_view;

/* Decodes a projection matrix: perspective or orthographic, any window depth (normal, reversed, infinite far plane), off-centre (sub-pixel jitter,
   stereo), y up or down.
     projection     [limit: w row (0,0,-1,0) or (0,0,0,1) up to a common factor; no skew] right-handed, camera along -z
     clip           SSGI_CLIP_GL or SSGI_CLIP_ZERO
     width, height  [units: pixels] [limit: 1..65536] of the picture that the projection fills
   Computed in double; exact to float rounding. */
SSGI_DEF ssgi_result ssgi_view_from_projection(ssgi_view *view, const float projection[16], int clip, int width, int height, const char **why);

/* View depth of a window depth; anything that is not a surface (the clear value, NaN, beyond [0,1], zero or infinite view depth) gives SSGI_FAR.
   GLSL twin: ssgi_decode. */
SSGI_DEF float ssgi_view_depth(const ssgi_view *view, float window_depth);
#define SSGI_FAR 1e18f      /* the view depth of nothing: far beyond any scene, its square still a float */

/* The view-space point seen at a pixel position (centres at .5) at a view depth; and back: the pixel position of a view-space point, with its depth
   [limit: > 0 when perspective] in out[2]. GLSL twins: ssgi_position, ssgi_project. */
SSGI_DEF void  ssgi_view_position(const ssgi_view *view, float pixel_x, float pixel_y, float view_depth, float out[3]);
SSGI_DEF void  ssgi_view_project(const ssgi_view *view, const float point[3], float out[3]);

/* ==== >>kernel ================================================================================================= */

/* i mirrored about the point in a base [limit: base >= 2], [0,1): van der Corput. Base 2, 3 .. as coordinates: Halton; i/n beside base 2: Hammersley. */
SSGI_DEF float ssgi_radical_inverse(uint32_t base, uint32_t i);

/* The i-th point of the R2 sequence (steps by the powers of the plastic number), [0,1)^2; good for any count, no need to know it beforehand. */
SSGI_DEF void  ssgi_r2(uint32_t i, float out[2]);

/* Interleaved gradient noise of a pixel, [0,1): every 3x3 neighbourhood holds nearly evenly spread values [Jimenez 2014]. GLSL twin: ssgi_noise. */
SSGI_DEF float ssgi_gradient_noise(int x, int y);

/* What a kernel's directions fill. */
enum { SSGI_COSINE = 0,     /* hemisphere about +z, density cos/pi: every sample counts 1/n */
       SSGI_HEMISPHERE,     /* hemisphere about +z, uniform: a sample counts 2 z/n; z is stratified at midpoints, so the counts sum to exactly 1 */
       SSGI_SPHERE,         /* whole sphere, uniform */
       SSGI_DISC };         /* unit disc in xy, z = 0, uniform in area; xyz is then the point itself, not a direction */

/* Sample sets: out[4 * (set * samples + i)] = x, y, z, length.
     sets       [limit: 1..4096] independent sets (interleave them over pixels)
     samples    [limit: 1..4096] of each
     xyz        unit directions (SSGI_DISC: points), low-discrepancy in each set, the sets rotated against each other
     length     in (0,1], one in each of n equal strata, decorrelated from the direction: the sample stands at length * radius. Uniform lengths
                make point sampling converge to linear attenuation, 1 - t/radius; sqrt and cbrt of it to 1 - (t/r)^2 and 1 - (t/r)^3.
   [SSDO09 section 3; sets that integrate an unblocked constant exactly: see README, differences from the papers] */
SSGI_DEF ssgi_result ssgi_kernel(float *out, int sets, int samples, int shape, const char **why);

/* HSAO's tile of jitter: out[4 * (y * size + x)] = cos a, sin a, b, c: a in [0, 2 pi/directions), b in [-0.5,0.5] for the steps, c in [0,1) for
   whatever else wants a turn, each stratified over the size x size texels and decorrelated. [HSAO08 4.1.2, with the range that it means]
     size       [limit: 1..64]     directions [limit: 1..1024]
   Upload as RGBA32F or RGBA16F, size x size, for a desc with noise = SSGI_GL_NOISE_TEXTURE. */
SSGI_DEF ssgi_result ssgi_jitter_tile(float *out, int size, int directions, const char **why);

/* ==== >>bias =================================================================================================== */

/* Width of a pixel on a surface facing the viewer at this view depth [units: view]: the larger of the picture's two axes. */
SSGI_DEF float ssgi_pixel_footprint(const ssgi_view *view, float view_depth);

/* How far HSAO lifts the receiver along its normal so that nearest depth fetches of its own plane stay below it: half a pixel's footprint
   [HSAO08 eq. 13, with positive view depth]; corners of a pixel need sqrt(2) times as much. GLSL twin: ssgi_lift (times u_ssgi_offset). */
SSGI_DEF float ssgi_normal_offset(const ssgi_view *view, float view_depth);

/* A radius to start from when nobody knows one: a tenth of the diagonal of the bounds of what is looked at, but at most what covers a quarter of the
   picture's height at view_depth. Bounds that are empty or not finite give the second alone. Always > 0. */
SSGI_DEF float ssgi_radius_guess(const ssgi_view *view, float view_depth, const float lower[3], const float upper[3]);

/* ==== >>trace ================================================================================================== */

/* Rays against triangles: the nearest hit, or whether there is one. For baking fields and for ray-traced reference pictures.
   Build once, trace from any number of threads. Triangles are two-sided; rays do not slip through shared edges.

      size_t      size = ssgi_trace_size(triangles);
      void       *memory = malloc(size);
      ssgi_trace  trace;
      const char *why;
      if (ssgi_trace_build(&trace, memory, size, position, 3 * sizeof(float), NULL, triangles, &why) != SSGI_OK) puts(why);
      if (ssgi_trace_any(&trace, origin, direction, 0.0f, 1.0f)) puts("something is in between");                         */

typedef struct ssgi_trace {
    const void *nodes, *blocks;       /* in the memory given to ssgi_trace_build */
    uint32_t    node_count;           /* 0: nothing can be hit */
    uint32_t    block_count;          /* four triangles each */
    uint32_t    triangles, skipped;   /* as given, and how many of them were degenerate or out of range */
} ssgi_trace;

typedef struct ssgi_hit {
    float    t;                       /* origin + t * direction is the point hit */
    float    u, v;                    /* weights of the triangle's second and third corner, in [0,1]; the first has 1 - u - v */
    uint32_t triangle;
} ssgi_hit;

#define SSGI_TRACE_MAX_TRIANGLES 0x3fffffffu

/* Bytes that ssgi_trace_build needs, about 59 a triangle. 0 when triangles is 0 or above SSGI_TRACE_MAX_TRIANGLES, or when
   size_t cannot hold the answer. */
SSGI_DEF size_t ssgi_trace_size(size_t triangles);

/* Builds over corners index[3*i], index[3*i+1], index[3*i+2] of triangle i; index NULL: corners 3*i, 3*i+1, 3*i+2.
   position    x y z of vertex k at (const char *)position + k * stride_bytes, aligned as floats are
   memory      size >= ssgi_trace_size(triangles) bytes of any alignment; the trace points into it: keep it, do not move it.
               position and index are not needed afterwards.
   Triangles without area, and those with a coordinate that is not finite or beyond +-1e12, are never hit; those smaller than
   about 1e-18 may be missed.
   SSGI_TOO_SMALL when size is; SSGI_BAD_ARGUMENT for NULL, triangles outside 1..SSGI_TRACE_MAX_TRIANGLES or a stride that is below
   12 or no multiple of 4. Then *why names the argument, and trace and memory are untouched. Indices are not checked.
   O(n log n) but for contrived input; no allocation; recursion at most 62 deep, whatever the input. */
SSGI_DEF ssgi_result ssgi_trace_build(ssgi_trace *trace, void *memory, size_t size, const float *position, size_t stride_bytes,
                                      const uint32_t *index, size_t triangles, const char **why);

/* The hit with the smallest t in tmin < t < tmax: 1 and *hit filled, or 0 and *hit untouched. direction need not be unit: t counts
   in its lengths. tmin below 0 is taken as 0. A ray that is not finite, beyond 1e12, or without direction hits nothing. */
SSGI_DEF int ssgi_trace_closest(const ssgi_trace *trace, const float origin[3], const float direction[3], float tmin, float tmax,
                                ssgi_hit *hit);

/* 1 if there is any hit in tmin < t < tmax, else 0. Stops at the first found. */
SSGI_DEF int ssgi_trace_any(const ssgi_trace *trace, const float origin[3], const float direction[3], float tmin, float tmax);

#ifdef __cplusplus
}
#endif
#endif /* SSGI_H: END OF HEADER ---------------------------------------------------------------------------------------- */

#if defined(SSGI_IMPLEMENTATION) && !defined(SSGI_IMPLEMENTED)
#define SSGI_IMPLEMENTED

#include <float.h>
#include <math.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ==== >>types (implementation) ================================================================================= */

static ssgi_result ssgi__bad(const char **why, const char *sentence)
{
    if (why) *why = sentence;
    return SSGI_BAD_ARGUMENT;
}

/* By the bits: -ffast-math lets a compiler assume that x - x == 0. */
static int ssgi__finite(float x)
{
    uint32_t bits;
    memcpy(&bits, &x, sizeof bits);
    return (bits & 0x7f800000u) != 0x7f800000u;
}

/* ==== >>view (implementation) ================================================================================== */

SSGI_DEF ssgi_result ssgi_view_from_projection(ssgi_view *view, const float projection[16], int clip, int width, int height, const char **why)
{
    double m[16], w, scale, shift;
    ssgi_view v;
    int i, perspective;
    if (!view) return ssgi__bad(why, "view: must not be NULL");
    if (!projection) return ssgi__bad(why, "projection: must not be NULL");
    if (clip != SSGI_CLIP_GL && clip != SSGI_CLIP_ZERO) return ssgi__bad(why, "clip: must be SSGI_CLIP_GL or SSGI_CLIP_ZERO");
    if (width < 1 || width > 65536) return ssgi__bad(why, "width: must be 1..65536");
    if (height < 1 || height > 65536) return ssgi__bad(why, "height: must be 1..65536");
    for (i = 0; i < 16; ++i) {
        if (!ssgi__finite(projection[i])) return ssgi__bad(why, "projection: must be finite");
        m[i] = (double)projection[i];
    }
    perspective = projection[11] < 0.0f;
    if (projection[3] != 0.0f || projection[7] != 0.0f || (perspective ? projection[15] != 0.0f : projection[11] != 0.0f || !(projection[15] > 0.0f)))
        return ssgi__bad(why, "projection: its w row must be (0,0,-1,0) or (0,0,0,1); a camera along +z is not right-handed");
    if (projection[1] != 0.0f || projection[4] != 0.0f || projection[2] != 0.0f || projection[6] != 0.0f)
        return ssgi__bad(why, "projection: must not be skewed (elements 1, 2, 4, 6 are 0)");
    w = perspective ? -m[11] : m[15];
    for (i = 0; i < 16; ++i) m[i] /= w;
    if (projection[0] == 0.0f || projection[5] == 0.0f) return ssgi__bad(why, "projection: elements 0 and 5 must not be 0");
    if (perspective ? projection[14] == 0.0f : projection[10] == 0.0f) return ssgi__bad(why, "projection: depth must vary (element 14, orthographic 10)");

    /* NDC x = m0 x/z - m8 (perspective, z the view depth) or m0 x + m12; pixel = (NDC/2 + 1/2) size. The same for y. */
    memset(&v, 0, sizeof v);
    v.width = width; v.height = height; v.orthographic = !perspective;
    for (i = 0; i < 2; ++i) {
        double size = i ? height : width, gain = m[i * 5], centre = perspective ? -m[8 + i] : m[12 + i];
        v.project[i] = (float)(gain * 0.5 * size);
        v.project[2 + i] = (float)((centre * 0.5 + 0.5) * size);
        v.unproject[i] = (float)(2.0 / (size * gain));
        v.unproject[2 + i] = (float)(-(1.0 + centre) / gain);
    }
    scale = clip == SSGI_CLIP_GL ? 2.0 : 1.0;       /* NDC z = scale * window depth + shift */
    shift = clip == SSGI_CLIP_GL ? -1.0 : 0.0;
    if (perspective) {                              /* NDC z = m14/z - m10 */
        v.depth[0] = (float)((shift + m[10]) / m[14]);
        v.depth[1] = (float)(scale / m[14]);
        v.clear = v.depth[1] > 0.0f ? 0.0f : 1.0f;  /* nearness grows with window depth: reversed */
    } else {                                        /* NDC z = -m10 z + m14 */
        v.depth[0] = (float)((m[14] - shift) / m[10]);
        v.depth[1] = (float)(-scale / m[10]);
        v.clear = v.depth[1] > 0.0f ? 1.0f : 0.0f;
    }
    for (i = 0; i < 4; ++i)
        if (!ssgi__finite(v.project[i]) || !ssgi__finite(v.unproject[i]) || !ssgi__finite(v.depth[i & 1]))
            return ssgi__bad(why, "projection: its elements are too large or too small for float arithmetic");
    *view = v;
    return SSGI_OK;
}

SSGI_DEF float ssgi_view_depth(const ssgi_view *view, float d)
{
    float z = view->depth[0] + view->depth[1] * d;
    if (!ssgi__finite(d) || !(d >= 0.0f && d <= 1.0f) || d == view->clear) return SSGI_FAR;
    if (!view->orthographic) z = z > 1.0f / SSGI_FAR ? 1.0f / z : SSGI_FAR;
    return z > 0.0f && z < SSGI_FAR ? z : SSGI_FAR;
}

SSGI_DEF void ssgi_view_position(const ssgi_view *view, float x, float y, float z, float out[3])
{
    float k = view->orthographic ? 1.0f : z;
    out[0] = (x * view->unproject[0] + view->unproject[2]) * k;
    out[1] = (y * view->unproject[1] + view->unproject[3]) * k;
    out[2] = -z;
}

SSGI_DEF void ssgi_view_project(const ssgi_view *view, const float p[3], float out[3])
{
    float k = view->orthographic ? 1.0f : 1.0f / -p[2];
    out[2] = -p[2];
    out[0] = p[0] * k * view->project[0] + view->project[2];
    out[1] = p[1] * k * view->project[1] + view->project[3];
}

/* ==== >>kernel (implementation) ================================================================================ */

SSGI_DEF float ssgi_radical_inverse(uint32_t base, uint32_t i)
{
    double f = 1.0, r = 0.0;
    float result;
    if (base < 2) return 0.0f;
    for (; i; i /= base) { f /= (double)base; r += f * (double)(i % base); }
    result = (float)r;
    return result < 1.0f ? result : 1.0f - FLT_EPSILON / 2;  /* 0.99999999 rounds up to 1 */
}

static float ssgi__fract(double x)
{
    float f = (float)(x - floor(x));
    return f < 1.0f ? f : 0.0f;
}

SSGI_DEF void ssgi_r2(uint32_t i, float out[2])
{
    out[0] = ssgi__fract(0.5 + 0.75487766624669276005 * (double)i);
    out[1] = ssgi__fract(0.5 + 0.56984029099805326591 * (double)i);
}

SSGI_DEF float ssgi_gradient_noise(int x, int y)
{
    return ssgi__fract(52.9829189 * (double)ssgi__fract(0.06711056 * (double)x + 0.00583715 * (double)y));
}

static int ssgi__gcd(int a, int b)
{
    while (b) { int c = a % b; a = b; b = c; }
    return a;
}

SSGI_DEF ssgi_result ssgi_kernel(float *out, int sets, int samples, int shape, const char **why)
{
    const double two_pi = 6.28318530717958647693, golden = 0.61803398874989484820;
    int set, i, step;
    if (!out) return ssgi__bad(why, "out: must not be NULL");
    if (sets < 1 || sets > 4096) return ssgi__bad(why, "sets: must be 1..4096");
    if (samples < 1 || samples > 4096) return ssgi__bad(why, "samples: must be 1..4096");
    if (shape < SSGI_COSINE || shape > SSGI_DISC) return ssgi__bad(why, "shape: must be SSGI_COSINE, _HEMISPHERE, _SPHERE or _DISC");
    /* A step coprime to the count visits every stratum of length once; near sqrt(2)-1 of it, so that lengths follow neither u nor the azimuth. */
    for (step = (int)(0.41421356 * samples + 0.5); ssgi__gcd(step, samples) != 1; ++step) {}
    for (set = 0; set < sets; ++set) {
        double turn = (double)ssgi_radical_inverse(2, (uint32_t)set), slide = 1.0 - (double)ssgi_radical_inverse(3, (uint32_t)set + 1);
        for (i = 0; i < samples; ++i) {
            /* u stratified at midpoints; azimuth by the golden angle, a spiral in which no two samples line up */
            double u = ((double)i + 0.5) / samples, phi = two_pi * (fmod((double)i * golden, 1.0) + turn), r, z;
            float *o = out + 4 * ((size_t)set * (size_t)samples + (size_t)i);
            switch (shape) {
            case SSGI_COSINE:     r = sqrt(u); z = sqrt(1.0 - u); break;
            case SSGI_HEMISPHERE: z = u; r = sqrt(1.0 - z * z); break;
            case SSGI_SPHERE:     z = 1.0 - 2.0 * u; r = sqrt(1.0 - z * z); break;
            default:              r = sqrt(u); z = 0.0; break;
            }
            o[0] = (float)(r * cos(phi)); o[1] = (float)(r * sin(phi)); o[2] = (float)z;
            o[3] = (float)(((double)(((int64_t)i * step + set) % samples) + slide) / samples);
        }
    }
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_jitter_tile(float *out, int size, int directions, const char **why)
{
    const double two_pi = 6.28318530717958647693;
    int i, n = size * size, m;
    if (!out) return ssgi__bad(why, "out: must not be NULL");
    if (size < 1 || size > 64) return ssgi__bad(why, "size: must be 1..64");
    if (directions < 1 || directions > 1024) return ssgi__bad(why, "directions: must be 1..1024");
    /* (a, b) = (m x + y, x + m y) mod size visits every pair once when m^2 - 1 is coprime to size, and moves neighbours far apart when m is not 0. */
    for (m = 2; m < size && ssgi__gcd(m * m - 1, size) != 1; ++m) {}
    if (m >= size) m = 0;
    for (i = 0; i < n; ++i) {
        int x = i % size, y = i / size, a = (m * x + y) % size, b = (x + m * y) % size;
        double turn = two_pi / directions * ((double)(a * size + b) + 0.5) / n;
        float *o = out + 4 * (size_t)i;
        o[0] = (float)cos(turn); o[1] = (float)sin(turn);
        o[2] = (float)(((double)(b * size + a) + 0.5) / n - 0.5);
        o[3] = ssgi__fract((double)(a * size + b) * 0.61803398874989484820);
    }
    return SSGI_OK;
}

/* ==== >>bias (implementation) ================================================================================== */

SSGI_DEF float ssgi_pixel_footprint(const ssgi_view *view, float z)
{
    float x = view->unproject[0] < 0.0f ? -view->unproject[0] : view->unproject[0];
    float y = view->unproject[1] < 0.0f ? -view->unproject[1] : view->unproject[1];
    return (x > y ? x : y) * (view->orthographic ? 1.0f : z);
}

SSGI_DEF float ssgi_normal_offset(const ssgi_view *view, float z) { return 0.5f * ssgi_pixel_footprint(view, z); }

SSGI_DEF float ssgi_radius_guess(const ssgi_view *view, float z, const float lower[3], const float upper[3])
{
    float most = 0.25f * (float)view->height * ssgi_pixel_footprint(view, z), sum = 0.0f, guess;
    int i;
    for (i = 0; i < 3; ++i) {
        float d = upper[i] - lower[i];
        if (!ssgi__finite(d) || d < 0.0f) return most;
        sum += d * d;
    }
    guess = 0.1f * (float)sqrt((double)sum);
    return guess > 0.0f && guess < most ? guess : most;
}

/* ==== >>trace (implementation) ================================================================================= */

/* A tree with four children a node and four triangles a leaf, both laid out so that a loop over the four is one vector
   operation. It comes from binary splits by surface area [Wald 2007], whose left side always gets a multiple of four
   triangles: every leaf is then full, which bounds the memory exactly: with L leaves there are at most 2 L / 3 + 1 nodes,
   as a node with fewer than four children has only leaves. */

#define SSGI__TRACE_LIMIT  1e12f                  /* products of three such lengths stay finite */
#define SSGI__TRACE_LEAF   0x80000000u
#define SSGI__TRACE_NONE   0xffffffffu
#define SSGI__TRACE_BINS   16
#define SSGI__TRACE_SAH    32                     /* binary levels split by area; below it by count: at most 30 more */
#define SSGI__TRACE_STACK  (3 * (SSGI__TRACE_SAH + 30) + 4)

typedef struct ssgi__trace_node {
    float    bound[2][3][4];                      /* lower and upper; axis; child */
    uint32_t child[4];                            /* node, or block + LEAF */
} ssgi__trace_node;

typedef struct ssgi__trace_block {
    float    corner[3][3][4];                     /* corner; axis; triangle */
    uint32_t triangle[4];
} ssgi__trace_block;

typedef struct ssgi__trace_item { float lower[3], upper[3]; uint32_t triangle; } ssgi__trace_item;

typedef struct ssgi__trace_range {                /* items to become one child */
    uint32_t first, count, depth;
    float    lower[3], upper[3];                  /* bounds */
    float    clower[3], cupper[3];                /* bounds of the centres, times two */
} ssgi__trace_range;

typedef struct ssgi__trace_job {
    ssgi__trace_node  *nodes;
    ssgi__trace_block *blocks;
    ssgi__trace_item  *items;
    uint32_t           node_count;
    const char        *position;
    size_t             stride;
    const uint32_t    *index;
} ssgi__trace_job;

static float ssgi__trace_min(float a, float b) { return a < b ? a : b; }
static float ssgi__trace_max(float a, float b) { return a > b ? a : b; }
static float ssgi__trace_abs(float a) { return ssgi__trace_max(a, -a); }

/* finite and within the limit, by the bits: -ffast-math may drop any comparison */
static int ssgi__trace_sane(float x)
{
    const float limit = SSGI__TRACE_LIMIT;
    uint32_t bits, most;
    memcpy(&bits, &x, sizeof bits);
    memcpy(&most, &limit, sizeof most);
    return (bits & 0x7fffffffu) <= most;
}

static void ssgi__trace_layout(size_t triangles, size_t *blocks, size_t *nodes)
{
    *blocks = (triangles + 3) / 4;
    *nodes = *blocks * 2 / 3 + 1;
}

SSGI_DEF size_t ssgi_trace_size(size_t triangles)
{
    size_t blocks, nodes;
    const size_t most = (size_t)-1;
    if (triangles == 0 || triangles > SSGI_TRACE_MAX_TRIANGLES) return 0;
    ssgi__trace_layout(triangles, &blocks, &nodes);
    if (blocks > (most - 1024) / (sizeof(ssgi__trace_block) + sizeof(ssgi__trace_node))) return 0;
    return 64 + blocks * sizeof(ssgi__trace_block) + nodes * sizeof(ssgi__trace_node);
}

static const float *ssgi__trace_corner(const ssgi__trace_job *job, uint32_t triangle, uint32_t corner)
{
    const size_t k = (size_t)triangle * 3 + corner;
    return (const float *)(const void *)(job->position + (job->index ? (size_t)job->index[k] : k) * job->stride);
}

static int ssgi__trace_item_set(const ssgi__trace_job *job, uint32_t triangle, ssgi__trace_item *item)
{
    const float *a = ssgi__trace_corner(job, triangle, 0), *b = ssgi__trace_corner(job, triangle, 1), *c = ssgi__trace_corner(job, triangle, 2);
    double e[3], f[3];
    int i;
    for (i = 0; i < 3; i++) {
        if (!ssgi__trace_sane(a[i]) || !ssgi__trace_sane(b[i]) || !ssgi__trace_sane(c[i])) return 0;
        item->lower[i] = ssgi__trace_min(a[i], ssgi__trace_min(b[i], c[i]));
        item->upper[i] = ssgi__trace_max(a[i], ssgi__trace_max(b[i], c[i]));
        e[i] = (double)b[i] - (double)a[i];
        f[i] = (double)c[i] - (double)a[i];
    }
    item->triangle = triangle;
    return e[1] * f[2] != e[2] * f[1] || e[2] * f[0] != e[0] * f[2] || e[0] * f[1] != e[1] * f[0];
}

static void ssgi__trace_bound(const ssgi__trace_item *items, ssgi__trace_range *range)
{
    uint32_t k;
    int i;
    for (i = 0; i < 3; i++) {
        range->lower[i] = range->clower[i] = 4.0f * SSGI__TRACE_LIMIT;
        range->upper[i] = range->cupper[i] = -4.0f * SSGI__TRACE_LIMIT;
    }
    for (k = range->first; k < range->first + range->count; k++)
        for (i = 0; i < 3; i++) {
            const float lower = items[k].lower[i], upper = items[k].upper[i], centre = lower + upper;
            range->lower[i] = ssgi__trace_min(range->lower[i], lower);
            range->upper[i] = ssgi__trace_max(range->upper[i], upper);
            range->clower[i] = ssgi__trace_min(range->clower[i], centre);
            range->cupper[i] = ssgi__trace_max(range->cupper[i], centre);
        }
}

static float ssgi__trace_area(const float lower[3], const float upper[3])
{
    const float x = upper[0] - lower[0], y = upper[1] - lower[1], z = upper[2] - lower[2];
    return x * y + y * z + z * x;
}

/* puts the items with the smallest centres along axis into the first want of count places [Hoare 1961] */
static void ssgi__trace_select(ssgi__trace_item *item, uint32_t count, uint32_t want, int axis)
{
    int64_t lower = 0, upper = (int64_t)count - 1, goal = (int64_t)want;
    while (lower < upper) {
        const ssgi__trace_item *middle = &item[lower + (upper - lower) / 2];
        const float pivot = middle->lower[axis] + middle->upper[axis];
        int64_t i = lower, j = upper;
        while (i <= j) {
            while (i < upper && item[i].lower[axis] + item[i].upper[axis] < pivot) i++;
            while (j > lower && item[j].lower[axis] + item[j].upper[axis] > pivot) j--;
            if (i <= j) {
                const ssgi__trace_item swap = item[i];
                item[i++] = item[j];
                item[j--] = swap;
            }
        }
        if (goal <= j) upper = j;
        else if (goal >= i) lower = i;
        else return;
    }
}

/* the cut of least surface area times leaves between the bins of an axis; 0 if all centres coincide */
static int ssgi__trace_cut(const ssgi__trace_item *item, const ssgi__trace_range *range, const float scale[3], int *axis, int *cut)
{
    float lower[3][SSGI__TRACE_BINS][3], upper[3][SSGI__TRACE_BINS][3], best = 0.0f;
    uint32_t count[3][SSGI__TRACE_BINS], k;
    int a, b, i, found = 0;
    for (a = 0; a < 3; a++)
        for (b = 0; b < SSGI__TRACE_BINS; b++) {
            count[a][b] = 0;
            for (i = 0; i < 3; i++) {
                lower[a][b][i] = 2.0f * SSGI__TRACE_LIMIT;
                upper[a][b][i] = -2.0f * SSGI__TRACE_LIMIT;
            }
        }
    for (k = 0; k < range->count; k++)
        for (a = 0; a < 3; a++) {
            b = (int)((item[k].lower[a] + item[k].upper[a] - range->clower[a]) * scale[a]);
            b = b < SSGI__TRACE_BINS ? b : SSGI__TRACE_BINS - 1;
            count[a][b]++;
            for (i = 0; i < 3; i++) {
                lower[a][b][i] = ssgi__trace_min(lower[a][b][i], item[k].lower[i]);
                upper[a][b][i] = ssgi__trace_max(upper[a][b][i], item[k].upper[i]);
            }
        }
    for (a = 0; a < 3; a++) {
        float    right[SSGI__TRACE_BINS], l[3], u[3];
        uint32_t n = 0;
        if (!(scale[a] > 0.0f)) continue;
        for (i = 0; i < 3; i++) { l[i] = 2.0f * SSGI__TRACE_LIMIT; u[i] = -2.0f * SSGI__TRACE_LIMIT; }
        for (b = SSGI__TRACE_BINS - 1; b > 0; b--) {
            n += count[a][b];
            for (i = 0; i < 3; i++) { l[i] = ssgi__trace_min(l[i], lower[a][b][i]); u[i] = ssgi__trace_max(u[i], upper[a][b][i]); }
            right[b] = n ? ssgi__trace_area(l, u) * (float)((n + 3) / 4) : 0.0f;
        }
        n = 0;
        for (i = 0; i < 3; i++) { l[i] = 2.0f * SSGI__TRACE_LIMIT; u[i] = -2.0f * SSGI__TRACE_LIMIT; }
        for (b = 0; b + 1 < SSGI__TRACE_BINS; b++) {
            float cost;
            n += count[a][b];
            for (i = 0; i < 3; i++) { l[i] = ssgi__trace_min(l[i], lower[a][b][i]); u[i] = ssgi__trace_max(u[i], upper[a][b][i]); }
            if (n == 0 || n == range->count) continue;
            cost = ssgi__trace_area(l, u) * (float)((n + 3) / 4) + right[b + 1];
            if (!found || cost < best) { best = cost; *axis = a; *cut = b; found = 1; }
        }
    }
    return found;
}

/* splits a range of more than four in two, the first with a multiple of four items */
static void ssgi__trace_split(ssgi__trace_item *items, const ssgi__trace_range *range, ssgi__trace_range *left, ssgi__trace_range *right)
{
    ssgi__trace_item *item = items + range->first;
    const uint32_t n = range->count, last = (n - 1) / 4 * 4;
    uint32_t have = n, want = (n / 2 + 3) / 4 * 4;
    float scale[3], extent[3];
    int axis = 0, cut = 0, i;
    for (i = 0; i < 3; i++) {
        extent[i] = range->cupper[i] - range->clower[i];
        scale[i] = extent[i] > 1e-30f ? (float)SSGI__TRACE_BINS * 0.99999f / extent[i] : 0.0f;
        if (extent[i] > extent[axis]) axis = i;
    }
    if (range->depth < SSGI__TRACE_SAH && ssgi__trace_cut(item, range, scale, &axis, &cut)) {
        uint32_t k;
        for (have = 0, k = 0; k < n; k++)
            if ((int)((item[k].lower[axis] + item[k].upper[axis] - range->clower[axis]) * scale[axis]) <= cut) {
                const ssgi__trace_item swap = item[k];
                item[k] = item[have];
                item[have++] = swap;
            }
        want = (have + 2) / 4 * 4;
        want = want < 4 ? 4 : want;
    }
    want = want > last ? last : want;
    if (want < have) ssgi__trace_select(item, have, want, axis);
    if (want > have) ssgi__trace_select(item + have, n - have, want - have, axis);
    left->first = range->first;
    left->count = want;
    right->first = range->first + want;
    right->count = n - want;
    left->depth = right->depth = range->depth + 1;
    ssgi__trace_bound(items, left);
    ssgi__trace_bound(items, right);
}

/* the first items are spent when their block is written, which is why both may share memory (see ssgi_trace_build) */
static void ssgi__trace_block_set(ssgi__trace_job *job, const ssgi__trace_range *range)
{
    uint32_t id[4], k, c;
    ssgi__trace_block *block = job->blocks + range->first / 4;
    for (k = 0; k < 4; k++) id[k] = k < range->count ? job->items[range->first + k].triangle : SSGI__TRACE_NONE;
    memset(block, 0, sizeof *block);                /* a triangle of zeros has no area: never hit */
    for (k = 0; k < 4; k++) {
        block->triangle[k] = id[k];
        for (c = 0; k < range->count && c < 3; c++) {
            const float *p = ssgi__trace_corner(job, id[k], c);
            block->corner[c][0][k] = p[0];
            block->corner[c][1][k] = p[1];
            block->corner[c][2][k] = p[2];
        }
    }
}

static uint32_t ssgi__trace_node_set(ssgi__trace_job *job, const ssgi__trace_range *whole)
{
    ssgi__trace_range range[4];
    const uint32_t self = job->node_count++;
    int count = 1, i, k;
    range[0] = *whole;
    while (count < 4) {
        int widest = -1;
        float most = 0.0f;
        for (k = 0; k < count; k++) {
            const float area = ssgi__trace_area(range[k].lower, range[k].upper);
            if (range[k].count > 4 && (widest < 0 || area > most)) { widest = k; most = area; }
        }
        if (widest < 0) break;
        for (k = count; k > widest + 1; k--) range[k] = range[k - 1];
        {
            const ssgi__trace_range both = range[widest];
            ssgi__trace_split(job->items, &both, &range[widest], &range[widest + 1]);
        }
        count++;
    }
    for (k = 0; k < 4; k++) {
        ssgi__trace_node *node = job->nodes + self;
        for (i = 0; i < 3; i++) {                   /* an empty child's box is inside out: never entered */
            node->bound[0][i][k] = k < count ? range[k].lower[i] : 2.0f * SSGI__TRACE_LIMIT;
            node->bound[1][i][k] = k < count ? range[k].upper[i] : -2.0f * SSGI__TRACE_LIMIT;
        }
        node->child[k] = SSGI__TRACE_LEAF;
        if (k >= count) continue;
        if (range[k].count > 4) node->child[k] = ssgi__trace_node_set(job, &range[k]);
        else {
            ssgi__trace_block_set(job, &range[k]);
            node->child[k] = SSGI__TRACE_LEAF | range[k].first / 4;
        }
    }
    return self;
}

SSGI_DEF ssgi_result ssgi_trace_build(ssgi_trace *trace, void *memory, size_t size, const float *position, size_t stride_bytes,
                                      const uint32_t *index, size_t triangles, const char **why)
{
    if (!trace) return ssgi__bad(why, "trace: must not be NULL");
    if (!memory) return ssgi__bad(why, "memory: must not be NULL");
    if (!position) return ssgi__bad(why, "position: must not be NULL");
    if (stride_bytes < 3 * sizeof(float) || stride_bytes % sizeof(float)) return ssgi__bad(why, "stride_bytes: must be 12 or more, a multiple of 4");
    if (!ssgi_trace_size(triangles)) return ssgi__bad(why, "triangles: must be 1..SSGI_TRACE_MAX_TRIANGLES");
    if (size < ssgi_trace_size(triangles)) {
        ssgi__bad(why, "size: must be at least ssgi_trace_size(triangles)");
        return SSGI_TOO_SMALL;
    }
    {
        ssgi__trace_job job;
        ssgi__trace_range all;
        size_t blocks, nodes;
        uint32_t k, count = 0;
        char *base = (char *)memory + (64 - (size_t)((uintptr_t)memory & 63)) % 64;
        ssgi__trace_layout(triangles, &blocks, &nodes);
        job.blocks = (ssgi__trace_block *)(void *)base;
        job.nodes = (ssgi__trace_node *)(void *)(base + blocks * sizeof(ssgi__trace_block));
        /* the items end where the blocks end, and blocks are written in the items' order: as four items are smaller than a block,
           no item is overwritten before it is spent */
        job.items = (ssgi__trace_item *)(void *)(base + blocks * (sizeof(ssgi__trace_block) - 4 * sizeof(ssgi__trace_item)));
        job.node_count = 0;
        job.position = (const char *)position;
        job.stride = stride_bytes;
        job.index = index;
        for (k = 0; k < (uint32_t)triangles; k++) count += (uint32_t)ssgi__trace_item_set(&job, k, &job.items[count]);
        if (count) {
            all.first = all.depth = 0;
            all.count = count;
            ssgi__trace_bound(job.items, &all);
            ssgi__trace_node_set(&job, &all);
        }
        trace->nodes = job.nodes;
        trace->blocks = job.blocks;
        trace->node_count = job.node_count;
        trace->block_count = (count + 3) / 4;
        trace->triangles = (uint32_t)triangles;
        trace->skipped = (uint32_t)triangles - count;
    }
    return SSGI_OK;
}

typedef struct ssgi__trace_ray {
    float origin[3], slope[2];                    /* x, y, z permuted so that z is the direction's longest axis */
    int   axis[3];
} ssgi__trace_ray;

/* weight[c][k]: unnormalised barycentric weight of corner c of triangle k; outside[k] above 0: the ray's line misses it. The corners are
   sheared so that the ray is the z axis; a weight's sign is then exact for the sheared corners, which triangles share: neither edges nor
   corners leave gaps [Woop, Benthin, Wald 2013]. */
static void ssgi__trace_block_hit(const ssgi__trace_block *block, const ssgi__trace_ray *ray, float weight[3][4], float outside[4])
{
    const float ox = ray->origin[0], oy = ray->origin[1], oz = ray->origin[2], sx = ray->slope[0], sy = ray->slope[1];
    const float *x0 = block->corner[0][ray->axis[0]], *y0 = block->corner[0][ray->axis[1]], *z0 = block->corner[0][ray->axis[2]];
    const float *x1 = block->corner[1][ray->axis[0]], *y1 = block->corner[1][ray->axis[1]], *z1 = block->corner[1][ray->axis[2]];
    const float *x2 = block->corner[2][ray->axis[0]], *y2 = block->corner[2][ray->axis[1]], *z2 = block->corner[2][ray->axis[2]];
    int k;
    for (k = 0; k < 4; k++) {
        const float az = z0[k] - oz, ax = x0[k] - ox - sx * az, ay = y0[k] - oy - sy * az;
        const float bz = z1[k] - oz, bx = x1[k] - ox - sx * bz, by = y1[k] - oy - sy * bz;
        const float cz = z2[k] - oz, cx = x2[k] - ox - sx * cz, cy = y2[k] - oy - sy * cz;
        const float a = cx * by - cy * bx, b = ax * cy - ay * cx, c = bx * ay - by * ax;
        const float least = ssgi__trace_min(a, ssgi__trace_min(b, c)), most = ssgi__trace_max(a, ssgi__trace_max(b, c));
        weight[0][k] = a;
        weight[1][k] = b;
        weight[2][k] = c;
        outside[k] = ssgi__trace_min(-least, most);
    }
}

/* where the ray meets the plane of triangle k, -1 if it lies in the plane; in double, or a ball on a wide floor would sink in */
static float ssgi__trace_distance(const ssgi__trace_block *block, int k, const float o[3], const float d[3])
{
    double e[3], f[3], facing = 0.0, height = 0.0;
    int i;
    for (i = 0; i < 3; i++) {
        e[i] = (double)block->corner[1][i][k] - (double)block->corner[0][i][k];
        f[i] = (double)block->corner[2][i][k] - (double)block->corner[0][i][k];
    }
    for (i = 0; i < 3; i++) {
        const int p = i < 2 ? i + 1 : 0, q = i > 0 ? i - 1 : 2;
        const double normal = e[p] * f[q] - e[q] * f[p];
        facing += normal * (double)d[i];
        height += normal * ((double)block->corner[0][i][k] - (double)o[i]);
    }
    return facing < 0.0 || facing > 0.0 ? (float)(height / facing) : -1.0f;
}

/* hit NULL: any hit will do */
static int ssgi__trace_walk(const ssgi_trace *trace, const float origin[3], const float direction[3], float tmin, float tmax, ssgi_hit *hit)
{
    const ssgi__trace_node *nodes = (const ssgi__trace_node *)trace->nodes;
    const ssgi__trace_block *blocks = (const ssgi__trace_block *)trace->blocks;
    struct { uint32_t child; float t; } stack[SSGI__TRACE_STACK];
    const float o[3] = { origin[0], origin[1], origin[2] }, d[3] = { direction[0], direction[1], direction[2] };
    ssgi__trace_ray ray;
    float weight[3][4], enter[4], leave[4], inverse[3], longest, size = 0.0f;
    int sign[3], top = 0, found = 0, i, k;
    for (i = 0; i < 3; i++) size += ssgi__trace_abs(o[i]) + ssgi__trace_abs(d[i]);
    longest = ssgi__trace_max(ssgi__trace_abs(d[0]), ssgi__trace_max(ssgi__trace_abs(d[1]), ssgi__trace_abs(d[2])));
    if (!ssgi__trace_sane(size) || !(longest > 1e-18f) || trace->node_count == 0) return 0;
    for (i = 0; i < 3; i++) {                       /* no infinity: 0 * infinity would be NaN on the face of a box */
        const float least = longest * 1e-12f;
        sign[i] = d[i] < 0.0f;
        inverse[i] = 1.0f / (sign[i] ? ssgi__trace_min(d[i], -least) : ssgi__trace_max(d[i], least));
    }
    ray.axis[2] = longest > ssgi__trace_abs(d[0]) ? longest > ssgi__trace_abs(d[1]) ? 2 : 1 : 0;
    ray.axis[0] = (ray.axis[2] + 1) % 3;
    ray.axis[1] = (ray.axis[2] + 2) % 3;
    for (i = 0; i < 3; i++) ray.origin[i] = o[ray.axis[i]];
    for (i = 0; i < 2; i++) ray.slope[i] = d[ray.axis[i]] / d[ray.axis[2]];
    tmin = tmin > 0.0f ? tmin : 0.0f;
    stack[top].child = 0;
    stack[top++].t = tmin;
    while (top) {
        const uint32_t child = stack[--top].child;
        if (stack[top].t > tmax) continue;
        if (child & SSGI__TRACE_LEAF) {
            const ssgi__trace_block *block = blocks + (child & ~SSGI__TRACE_LEAF);
            ssgi__trace_block_hit(block, &ray, weight, enter);
            for (k = 0; k < 4; k++) {
                float t, sum;
                if (enter[k] > 0.0f) continue;
                t = ssgi__trace_distance(block, k, o, d);
                sum = weight[0][k] + weight[1][k] + weight[2][k];
                if (!(t > tmin && t < tmax && ssgi__trace_abs(sum) > 0.0f)) continue;
                if (!hit) return 1;
                found = 1;
                hit->t = tmax = t;
                hit->u = ssgi__trace_min(1.0f, ssgi__trace_max(0.0f, weight[1][k] / sum));
                hit->v = ssgi__trace_min(1.0f - hit->u, ssgi__trace_max(0.0f, weight[2][k] / sum));
                hit->triangle = block->triangle[k];
            }
        } else {
            const ssgi__trace_node *node = nodes + child;
            const float *x0 = node->bound[sign[0]][0], *x1 = node->bound[1 - sign[0]][0];
            const float *y0 = node->bound[sign[1]][1], *y1 = node->bound[1 - sign[1]][1];
            const float *z0 = node->bound[sign[2]][2], *z1 = node->bound[1 - sign[2]][2];
            const int base = top;
            for (k = 0; k < 4; k++) {               /* the slack covers the rounding of both ends [Ize 2013] */
                const float ex = (x0[k] - o[0]) * inverse[0], ey = (y0[k] - o[1]) * inverse[1], ez = (z0[k] - o[2]) * inverse[2];
                const float lx = (x1[k] - o[0]) * inverse[0], ly = (y1[k] - o[1]) * inverse[1], lz = (z1[k] - o[2]) * inverse[2];
                enter[k] = ssgi__trace_max(ssgi__trace_max(ex, ey), ssgi__trace_max(ez, tmin));
                leave[k] = ssgi__trace_min(ssgi__trace_min(lx, ly), lz) * 1.0000006f;
                leave[k] = ssgi__trace_min(leave[k], tmax);
            }
            for (k = 0; k < 4; k++)
                if (enter[k] <= leave[k]) {
                    int j = top++;
                    for (; hit && j > base && stack[j - 1].t < enter[k]; j--) stack[j] = stack[j - 1];
                    stack[j].child = node->child[k];
                    stack[j].t = enter[k];
                }
        }
    }
    return found;
}

SSGI_DEF int ssgi_trace_closest(const ssgi_trace *trace, const float origin[3], const float direction[3], float tmin, float tmax, ssgi_hit *hit)
{
    return ssgi__trace_walk(trace, origin, direction, tmin, tmax, hit);
}

SSGI_DEF int ssgi_trace_any(const ssgi_trace *trace, const float origin[3], const float direction[3], float tmin, float tmax)
{
    return ssgi__trace_walk(trace, origin, direction, tmin, tmax, NULL);
}

#ifdef __cplusplus
}
#endif
#endif /* SSGI_IMPLEMENTATION */

/* ---------------------------------------------------------------------------------------------------------------------------
   This software is available under two licences; choose the one you like.

   1. MIT. Copyright (c) 2026 the ssgi authors.
   Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated documentation files (the
   "Software"), to deal in the Software without restriction, including without limitation the rights to use, copy, modify, merge, publish,
   distribute, sublicense, and/or sell copies of the Software, and to permit persons to whom the Software is furnished to do so, subject to
   the following conditions: The above copyright notice and this permission notice shall be included in all copies or substantial portions
   of the Software. THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
   WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR COPYRIGHT HOLDERS
   BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM, OUT OF OR IN
   CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.

   2. Public domain (www.unlicense.org). Anyone is free to copy, modify, publish, use, compile, sell, or distribute this software, in source
   or binary form, for any purpose, commercial or non-commercial, and by any means. The authors dedicate any and all copyright interest in
   the software to the public domain, and relinquish in perpetuity all present and future rights to it under copyright law. The disclaimer
   of warranty above applies likewise.
   --------------------------------------------------------------------------------------------------------------------------- */
