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
   the normal rays, each stratified over the size x size texels and decorrelated. [HSAO08 4.1.2, with the range that it means]
     size       [limit: 1..64]     directions [limit: 1..1024]
   Upload as RGBA32F or RGBA16F, size x size, for a desc with noise = SSGI_GL_NOISE_TILE. */
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

/*@TRACE_DECL@*/

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

/*@TRACE_IMPL@*/

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
