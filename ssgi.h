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
      environments latitude-longitude pictures as OpenEXR's, rgb interleaved, linear radiance: rgb[3 * (y * width + x) + c], row 0 at +y, the image centre
                   looks to +z, +x is left of the centre; solid angles of texels are exact; values above 1e24 count as that
      errors       functions that can be misused return ssgi_result and, through the last argument (may be NULL), a static sentence that begins
                   with the argument's name; outputs are then untouched. Nothing prints, exits, allocates or keeps state: all is reentrant.

   CONFIG       SSGI_STATIC makes every function static. Nothing else changes the header.
   ROOMS        search for ">>"
      >>types      results
      >>view       projection decode: perspective, orthographic, reversed and infinite depth, off-centre; additional cameras
      >>kernel     low-discrepancy points, sample sets, jitter tile
      >>sh         spherical harmonics: basis, windows, projection of environments, lights and skies, rotation, products
      >>environment  latitude-longitude pictures as octahedral maps over lobes and cones, and as directional lights
      >>vpl        virtual point lights from a reflective shadow map
      >>bias       pixel footprint, normal offset, radius guess, shadow map bias
      >>trace      a small BVH over your triangles: closest hit, any hit

   SOURCES      [HSAO08] Dimitrov, Bavoil, Sainz 2008, Horizon-split ambient occlusion   [SSDO09] Ritschel, Grosch, Seidel 2009, Approximating
                dynamic global illumination in image space   [SA07] Shanmugam, Arikan 2007, Hardware accelerated ambient occlusion
                [RAM01] Ramamoorthi, Hanrahan 2001, An efficient representation for irradiance environment maps   [DEB05] Debevec 2005, A median cut
                algorithm for light probe sampling   [KEL97] Keller 1997, Instant radiosity   [SLO08] Sloan 2008, Stupid spherical harmonics tricks
                [S3HO12] Herholz, Schairer, Schilling, Strasser 2012, Screen space spherical harmonic occlusion
                [SSBN11] Klehm, Ritschel, Eisemann, Seidel 2011, Bent normals and cones in screen-space   */
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

/* An additional camera that sees what the main one does not [SSDO09 section 4]: it stands at the main eye + radius * displacement and looks at centre.
     main_world_to_view  rigid: rotation and translation
     centre, radius      [units: world] [limit: radius > 0] the scene's bounding sphere
     displacement        along the main camera's axes: x right, y up, z toward the viewer
     world_to_view       its up is the main camera's; looking along that, the main camera's forward. At the centre itself it looks as the main camera does.
     projection          GL clip, square, symmetric; the frustum just holds the sphere, but is at most 100 degrees wide (near or inside the sphere);
                         near plane radius / 50: matter that a near plane cuts open would count as seen through; far plane distance + radius
   The outputs may be the inputs. */
SSGI_DEF ssgi_result ssgi_extra_camera(float world_to_view[16], float projection[16], const float main_world_to_view[16], const float centre[3], float radius,
                                       const float displacement[3], const char **why);

/* Displacements to start from, i modulo 4: left, right, above, behind. For a main camera that looks at the centre from two radii away (the sphere then is
   60 degrees wide) they keep that distance and turn about the centre: by 60 degrees to either side and 20 up, 75 up, and to the far side, 50 up. */
SSGI_DEF void ssgi_extra_displacement(int i, float out[3]);

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

/* ==== >>sh ===================================================================================================== */

/* Real spherical harmonics, orthonormal, function m = -l..l of band l at l*l + l + m; no Condon-Shortley sign: band 1 is +y, +z, +x times 0.4886.
   GLSL twins of basis, zonal, rotate and product: ssgi_gl_sh in ssgi_gl.h. */
#define SSGI_SH_MAX_BANDS 6

/* The basis at a unit direction: bands^2 values [limit: bands 0..SSGI_SH_MAX_BANDS, more are taken as that many]. */
SSGI_DEF void  ssgi_sh_basis(float *out, int bands, const float direction[3]);

/* What band l of radiance is multiplied by to become irradiance: pi, 2 pi/3, pi/4, 0, -pi/24, 0; 0 for any other l. [RAM01] */
SSGI_DEF float ssgi_sh_cosine(int l);

/* Radiance projected onto the basis: out[3*i + c], 3 * bands^2 floats. Values that are not finite count as 0.
     bands          [limit: 1..SSGI_SH_MAX_BANDS]
     width, height  [limit: 1..65536]
     faces          six of GL's cube map, in its order and orientation (+x -x +y -y +z -z), rgb interleaved, size * size each [limit: 1..65536] */
SSGI_DEF ssgi_result ssgi_sh_project_equirect(float *out, int bands, const float *rgb, int width, int height, const char **why);
SSGI_DEF ssgi_result ssgi_sh_project_cube(float *out, int bands, const float *const faces[6], int size, const char **why);

/* Windows: what band l is multiplied by so that the series of a narrow light rings less. Beside each, for a directional light in 4 bands that gives a facing surface
   irradiance 1: the series' peak, the least irradiance of an open surface, and the most that its negative part can take from a surface that sees nothing else. */
enum { SSGI_SH_WINDOW_NONE = 0,     /* 1: sharpest, rings most                                         1.20, -0.037, 0.20 */
       SSGI_SH_WINDOW_HANN,         /* (1 + cos(pi l / bands)) / 2 [SLO08, S3HO12]                     0.68, -0.027, 0.035 */
       SSGI_SH_WINDOW_POSITIVE };   /* the bands of ((1 + cos)/2)^(bands-1): nowhere below 0, widest   0.52,  0.020, 0 */

/* A window's factors: bands floats, the first 1 [limit: bands 0..SSGI_SH_MAX_BANDS, more are taken as that many; a window that there is not is none]. */
SSGI_DEF void  ssgi_sh_window(float *out, int bands, int window);

/* A function about +z, zonal[l] its coefficient at l*l + l (the others are 0), turned to a unit direction: out[i] = sqrt(4 pi/(2l+1)) zonal[l] Y_i(direction),
   bands^2 floats [limit: bands as ssgi_sh_basis]. zonal[l] = ssgi_sh_cosine(l) sqrt((2l+1)/(4 pi)) gives the clamped cosine about a normal, which is the
   transfer of an open point: its dot product with radiance is irradiance. */
SSGI_DEF void  ssgi_sh_zonal(float *out, int bands, const float *zonal, const float direction[3]);

/* The function turned as world_to_view turns directions (its rotation [limit: rigid]; NULL: none): what it was along w it becomes along R w.
     coefficients, out  channels * bands^2, [channels * i + c]; out may be coefficients     bands as ssgi_sh_basis     channels [limit: any; below 1 nothing]
   About 10 us for 4 bands. */
SSGI_DEF void  ssgi_sh_rotate(float *out, int bands, const float *coefficients, int channels, const float *world_to_view);

/* The product of two functions, projected back on as many bands (light times visibility, say): exact for that, but a product has up to 2 * bands - 1 bands and those
   above are lost. One channel, bands^2 floats each; out may be a or b. [limit: bands as ssgi_sh_basis] About 20 us for 4 bands. */
SSGI_DEF void  ssgi_sh_product(float *out, int bands, const float *a, const float *b);

/* ADDS a light to radiance, [3*i + c], as windowed zonal harmonics: c_i += irradiance k w_l f_l Y_i(direction), with k such that an unoccluded surface that faces
   the light receives exactly `irradiance`, whatever bands and window. [SLO08, S3HO12; without k it would be 1.06 of it for 4 bands, 0.83 with Hann]
     bands       [limit: 1..SSGI_SH_MAX_BANDS]
     direction   to the light [limit: finite, not 0]; any length
     sine        [limit: 0..1] 0: directional, or a point far away. Above: a sphere of uniform radiance, radius / distance of its centre: f_l, the mean of the
                 Legendre polynomial l over the cap that it fills
     irradiance  of a surface that faces it [limit: finite] beyond +-1e24 it counts as that; below 0 it takes light away
   Series of few bands are below 0 somewhere (see the windows): sum all lights, then clamp irradiance at 0. */
SSGI_DEF ssgi_result ssgi_sh_light(float *coefficients, int bands, const float direction[3], float sine, const float irradiance[3], int window, const char **why);

/* ADDS a sky of two constant radiances that meet at the horizon; equal ones add a constant. From 2 bands on its irradiance is exactly the engines' hemisphere light,
   pi * mix(below, above, 0.5 + 0.5 dot(n, up)): of the other bands those that the cosine sees are empty.
     bands, up, above, below   as bands, direction, irradiance of ssgi_sh_light */
SSGI_DEF ssgi_result ssgi_sh_sky(float *coefficients, int bands, const float up[3], const float above[3], const float below[3], const char **why);

/* Weakens the higher bands of radiance, [3*i + c], by 1 / (1 + s l^2 (l+1)^2) [SLO08] with the least s >= 0 that leaves no channel below 0 in any direction, but for
   1e-3 of its mean. Finds the lowest by descent from 200 fixed directions. Band 0 stays as it is, and so does all that is nowhere below 0: s = 0.
     bands         [limit: 1..SSGI_SH_MAX_BANDS]
     coefficients  [limit: finite] a channel whose mean (band 0) is not above 0 has no s: it does not count, but is weakened as the others
     strength      receives s, at most 1e30; may be NULL
   A few milliseconds. */
SSGI_DEF ssgi_result ssgi_sh_dering(float *coefficients, int bands, float *strength, const char **why);

/* ==== >>environment ============================================================================================ */

/* Octahedral map: directions on the square [-1,1]^2 about +z. Any length but 0 (which becomes +z); decoding gives a unit vector.
   GLSL twin of decode: n = vec3(e, 1 - |e.x| - |e.y|); t = max(-n.z, 0); n.xy += n.xy >= 0 ? -t : t; normalize(n). */
SSGI_DEF void  ssgi_octahedral_encode(const float direction[3], float out[2]);
SSGI_DEF void  ssgi_octahedral_decode(const float e[2], float out[3]);

/* An environment seen through a lobe about every direction: an octahedral map, out[3 * (y * size + x) + c] at e = (x + 0.5, y + 0.5) / size * 2 - 1.
     size           [limit: 8..256]
     width, height  [limit: 1..65536] of rgb; values that are negative or not finite count as 0
     solid_angle    [units: sr] [limit: 0, or above] 0: irradiance over pi (the clamped cosine). Above: the average over a von Mises-Fisher lobe with
                    kappa = 4 pi / solid_angle, as wide as 1 / integral p^2 says (nearly: exactly it is tanh(kappa) of that). What lies below 0.05 is taken as 0.05.
   A constant environment comes out as it is. The picture is first averaged to 96 x 48 cells, which makes a lobe wider by up to 0.005 sr.
   (A sky of 1 to 4 with a disc of 200, 6 degrees in radius: within 0.6 % of the exact average.) 2048 x 1024 at size 64: 0.25 s at most at -O2, one core; the time goes
   with size^2 from there. Takes 60 KB of stack. */
SSGI_DEF ssgi_result ssgi_environment_map(float *out, int size, const float *rgb, int width, int height, float solid_angle, const char **why);

/* The same over cones: the mean radiance within the cone about every direction, weighted by the cosine to its axis. A bent cone's light [SSBN11] is one look-up here:
   slice k of n of a texture array, one an aperture, holds cosine k/n.
     cosine   [limit: 0..0.95] of the cone's half-angle. 0: irradiance over pi, the same as ssgi_environment_map with solid angle 0
   A cell is 3.75 degrees wide: the rim is a ramp that wide to either side (less below cosine 0.07: it ends before 90 degrees), so that cells do not show.
   Otherwise, and in its cost, as ssgi_environment_map. */
SSGI_DEF ssgi_result ssgi_environment_cone(float *out, int size, const float *rgb, int width, int height, float cosine, const char **why);

typedef struct ssgi_sun {
    float direction[3];     /* unit, to the light */
    float irradiance[3];    /* on a surface that faces it */
} ssgi_sun;

/* An environment as directional lights [SSDO09 section 5] by median cut [DEB05]: the region of most luminance is halved, along its wider side, until there are count.
   A sun stands at its region's centre of luminance and sends all of its light: irradiances sum to the integral of radiance over the sphere.
     count          [limit: 1..1024] any, not only powers of two; those beyond the picture's texels are dark, at +y
     width, height  [limit: 1..65536] of rgb; values that are negative or not finite count as 0
   Reads the picture about log2(count) times. Takes 30 KB of stack. */
SSGI_DEF ssgi_result ssgi_environment_suns(ssgi_sun *out, int count, const float *rgb, int width, int height, const char **why);

/* What spherical harmonics lack: adds to map, an octahedral map of irradiance over pi (ssgi_environment_map, solid_angle 0; zeros without an environment), that of the
   suns, and takes away what the coefficients, [3*i + c], which stand for all of it, give an open surface. Added to their light, dimmed by occlusion, it makes open surfaces exact.
     size   [limit: 8..256]     bands   [limit: 1..SSGI_SH_MAX_BANDS]     suns   [limit: count 0 or more; may be NULL when 0] */
SSGI_DEF ssgi_result ssgi_sh_lacking(float *map, int size, const float *coefficients, int bands, const ssgi_sun *suns, int count, const char **why);

/* ==== >>vpl ==================================================================================================== */

typedef struct ssgi_vpl {
    float position[3], normal[3];
    float intensity[3];     /* radiant intensity along the normal; intensity * cos theta beside it */
} ssgi_vpl;

/* Virtual point lights [KEL97] from a reflective shadow map: pixels chosen in proportion to the luminance of their flux, stratified along the map.
     count     [limit: 1..4096] of them, exactly; a pixel may be chosen more than once
     position, normal, flux   x y z or r g b of pixel k at [3*k]; flux is what the pixel's surface reflects in all; where it is negative or not finite it counts as 0
   Each keeps its pixel's colour and sends an equal share: luminances of the fluxes (pi * intensity) sum to the map's. Same input, same output.
   A map without flux is SSGI_BAD_ARGUMENT. */
SSGI_DEF ssgi_result ssgi_vpl_choose(ssgi_vpl *out, int count, const float *position, const float *normal, const float *flux, size_t pixels, const char **why);

/* ==== >>bias =================================================================================================== */

/* Width of a pixel on a surface facing the viewer at this view depth [units: view]: the larger of the picture's two axes. */
SSGI_DEF float ssgi_pixel_footprint(const ssgi_view *view, float view_depth);

/* How far HSAO lifts the receiver along its normal so that nearest depth fetches of its own plane stay below it: half a pixel's footprint
   [HSAO08 eq. 13, with positive view depth]; corners of a pixel need sqrt(2) times as much. GLSL twin: ssgi_lift (times u_ssgi_offset). */
SSGI_DEF float ssgi_normal_offset(const ssgi_view *view, float view_depth);

/* A radius to start from when nobody knows one: a tenth of the diagonal of the bounds of what is looked at, but at most what covers a quarter of the
   picture's height at view_depth. Bounds that are empty or not finite give the second alone. Always > 0. */
SSGI_DEF float ssgi_radius_guess(const ssgi_view *view, float view_depth, const float lower[3], const float upper[3]);

/* Width of a shadow map's texel on a surface that faces the light: 2 z tan(angle/2) / resolution. [SSDO09 section 5]
     depth       [units: world] [limit: >= 0] along the spot's axis, not the distance
     full_angle  [units: rad] [limit: 0..pi, exclusive] from edge to edge     resolution  [units: texels] [limit: >= 1] */
SSGI_DEF float ssgi_shadow_patch(float depth, float full_angle, int resolution);

/* The bias that keeps a plane free of its own shadow: patch / sqrt(2) * tan(alpha), alpha between normal and light. The paper's patch / 2 holds only for
   slopes along a texel's side; a slope along its diagonal needs sqrt(2) times that. At most `most`, which is also what cos_alpha <= 0 gets; never below 0;
   finite for all finite input. [limit: patch, most >= 0] */
SSGI_DEF float ssgi_shadow_bias(float patch, float cos_alpha, float most);

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

/* A radiance or a flux: 0 if not finite, and so far from the ends of float that sums over any picture stay finite. */
static double ssgi__light(float x, float least)
{
    if (!ssgi__finite(x)) return 0.0;
    return (double)(x < least ? least : x > 1e24f ? 1e24f : x);
}

static double ssgi__luminance(const double rgb[3]) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

static double ssgi__dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void ssgi__cross(double out[3], const double a[3], const double b[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* returns the length that it had; 0 stays 0 */
static double ssgi__normalise(double v[3])
{
    double length = sqrt(ssgi__dot(v, v));
    int i;
    for (i = 0; i < 3 && length > 0.0; ++i) v[i] /= length;
    return length;
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

SSGI_DEF ssgi_result ssgi_extra_camera(float world_to_view[16], float projection[16], const float main_world_to_view[16], const float centre[3], float radius,
                                       const float displacement[3], const char **why)
{
    const double cos40 = 0.76604444311897803520, r = (double)radius;    /* half of 100 degrees: sine and cosine change places */
    double was[3][3], axis[3][3], eye[3] = { 0, 0, 0 }, distance, cotangent, near_plane, far_plane;
    float view[16] = { 0 }, clip[16] = { 0 };
    int i, k;
    if (!world_to_view) return ssgi__bad(why, "world_to_view: must not be NULL");
    if (!projection) return ssgi__bad(why, "projection: must not be NULL");
    if (!main_world_to_view) return ssgi__bad(why, "main_world_to_view: must not be NULL");
    for (i = 0; i < 16; ++i) {
        if (!ssgi__finite(main_world_to_view[i])) return ssgi__bad(why, "main_world_to_view: must be finite");
        if (i % 4 < 3 && i < 12) was[i % 4][i / 4] = (double)main_world_to_view[i];
    }
    for (i = 0; i < 9; ++i)
        if (fabs(ssgi__dot(was[i / 3], was[i % 3]) - (i / 3 == i % 3 ? 1.0 : 0.0)) > 1e-3) return ssgi__bad(why, "main_world_to_view: must be rigid: a rotation and a translation");
    for (i = 0; i < 4; ++i)
        if (main_world_to_view[4 * i + 3] != (i < 3 ? 0.0f : 1.0f)) return ssgi__bad(why, "main_world_to_view: its last row must be (0,0,0,1)");
    if (!centre) return ssgi__bad(why, "centre: must not be NULL");
    if (!ssgi__finite(centre[0]) || !ssgi__finite(centre[1]) || !ssgi__finite(centre[2])) return ssgi__bad(why, "centre: must be finite");
    if (!ssgi__finite(radius) || !(radius > 0.0f)) return ssgi__bad(why, "radius: must be finite and above 0");
    if (!displacement) return ssgi__bad(why, "displacement: must not be NULL");
    if (!ssgi__finite(displacement[0]) || !ssgi__finite(displacement[1]) || !ssgi__finite(displacement[2])) return ssgi__bad(why, "displacement: must be finite");

    for (k = 0; k < 3; ++k) {                       /* the main eye stands at minus the translation, in its own axes */
        for (i = 0; i < 3; ++i) eye[k] += was[i][k] * (r * (double)displacement[i] - (double)main_world_to_view[12 + i]);
        axis[2][k] = eye[k] - (double)centre[k];
    }
    distance = ssgi__normalise(axis[2]);
    if (distance < 1e-6 * r) {
        memcpy(axis[2], was[2], sizeof axis[2]);
        ssgi__normalise(axis[2]);
    }
    ssgi__cross(axis[0], was[1], axis[2]);
    if (ssgi__normalise(axis[0]) < 1e-3) {
        ssgi__cross(axis[0], axis[2], was[2]);
        ssgi__normalise(axis[0]);
    }
    ssgi__cross(axis[1], axis[2], axis[0]);
    for (i = 0; i < 3; ++i) {
        for (k = 0; k < 3; ++k) view[4 * k + i] = (float)axis[i][k];
        view[12 + i] = (float)-ssgi__dot(axis[i], eye);
    }
    view[15] = 1.0f;
    cotangent = distance * cos40 > r ? sqrt((distance - r) * (distance + r)) / r : 0.83909963117728001176;
    near_plane = 0.02 * r;
    far_plane = distance + r;
    clip[0] = clip[5] = (float)cotangent;
    clip[10] = (float)(-(far_plane + near_plane) / (far_plane - near_plane));
    clip[11] = -1.0f;
    clip[14] = (float)(-2.0 * far_plane * near_plane / (far_plane - near_plane));
    for (i = 0; i < 16; ++i)
        if (!ssgi__finite(view[i]) || !ssgi__finite(clip[i])) return ssgi__bad(why, "radius: too small or too large for float arithmetic");
    memcpy(world_to_view, view, sizeof view);
    memcpy(projection, clip, sizeof clip);
    return SSGI_OK;
}

SSGI_DEF void ssgi_extra_displacement(int i, float out[3])
{
    static const float all[4][3] = { { -1.62760f, 0.68404f, -1.06031f }, { 1.62760f, 0.68404f, -1.06031f }, { 0.0f, 1.93185f, -1.48236f }, { 0.0f, 1.53209f, -3.28558f } };
    memcpy(out, all[i & 3], sizeof all[0]);
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

/* ==== >>sh (implementation) ==================================================================================== */

/* norm * Q_lm(z) * Re or Im (x + iy)^m, where Q_lm sin^m is the associated Legendre function without its sign */
static void ssgi__sh_basis(double *out, int bands, const double d[3])
{
    static const double norm[] = { /* sqrt((2l+1) (l-m)! / (4 pi (l+m)!)), times sqrt(2) for m > 0, at l (l+1)/2 + m */
        0.28209479177387814, 0.48860251190291992, 0.48860251190291992, 0.63078313050504009, 0.36418281019735976, 0.18209140509867988, 0.74635266518023080,
        0.30469719964297729, 0.09635371475468515, 0.03933623932844291, 0.84628437532163450, 0.26761861742291570, 0.06307831305050400, 0.01685838828361839,
        0.00596034033761120, 0.93560257962738880, 0.24157154730437160, 0.04565273128546023, 0.00931882475114763, 0.00219646805807518, 0.00069458418713245 };
    double real = 1.0, imaginary = 0.0, top = 1.0;
    int l, m;
    for (m = 0; m < bands; ++m) {
        double q = top, before = 0.0, turned;
        for (l = m; l < bands; ++l) {
            const double k = norm[l * (l + 1) / 2 + m] * q, next = ((2 * l + 1) * d[2] * q - (l + m) * before) / (l + 1 - m);
            out[l * l + l - m] = k * imaginary;
            out[l * l + l + m] = k * real;
            before = q;
            q = next;
        }
        top *= 2 * m + 1;
        turned = real * d[0] - imaginary * d[1];
        imaginary = real * d[1] + imaginary * d[0];
        real = turned;
    }
}

static int ssgi__sh_limit(int bands) { return bands < 0 ? 0 : bands > SSGI_SH_MAX_BANDS ? SSGI_SH_MAX_BANDS : bands; }

SSGI_DEF void ssgi_sh_basis(float *out, int bands, const float direction[3])
{
    const double d[3] = { (double)direction[0], (double)direction[1], (double)direction[2] };
    double basis[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS];
    int i;
    bands = ssgi__sh_limit(bands);
    ssgi__sh_basis(basis, bands, d);
    for (i = 0; i < bands * bands; ++i) out[i] = (float)basis[i];
}

SSGI_DEF float ssgi_sh_cosine(int l)
{
    static const float a[5] = { 3.14159265f, 2.09439510f, 0.785398163f, 0.0f, -0.130899694f };
    return l >= 0 && l < 5 ? a[l] : 0.0f;
}

/* Sine and cosine of a row's angle from +y, at rows from the top; returns the solid angle of a texel whose centre is there. */
static double ssgi__equirect_row(double polar[2], double at, int width, int height)
{
    const double pi = 3.14159265358979323846;
    polar[0] = sin(pi * at / height);
    polar[1] = cos(pi * at / height);
    return 4.0 * pi / width * polar[0] * sin(0.5 * pi / height);
}

static void ssgi__equirect(double direction[3], const double polar[2], double at, int width)
{
    const double longitude = 3.14159265358979323846 * (1.0 - 2.0 * at / width);
    direction[0] = polar[0] * sin(longitude);
    direction[1] = polar[1];
    direction[2] = polar[0] * cos(longitude);
}

static ssgi_result ssgi__equirect_bad(const float *rgb, int width, int height, const char **why)
{
    if (!rgb) return ssgi__bad(why, "rgb: must not be NULL");
    if (width < 1 || width > 65536) return ssgi__bad(why, "width: must be 1..65536");
    if (height < 1 || height > 65536) return ssgi__bad(why, "height: must be 1..65536");
    return SSGI_OK;
}

typedef struct ssgi__sh_sum { int bands; double of[3 * SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS]; } ssgi__sh_sum;

static void ssgi__sh_add(ssgi__sh_sum *sum, const double direction[3], const float *rgb, double weight)
{
    double basis[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS], light[3];
    int i, c;
    ssgi__sh_basis(basis, sum->bands, direction);
    for (c = 0; c < 3; ++c) light[c] = weight * ssgi__light(rgb[c], -1e24f);
    for (i = 0; i < sum->bands * sum->bands; ++i)
        for (c = 0; c < 3; ++c) sum->of[3 * i + c] += basis[i] * light[c];
}

static ssgi_result ssgi__sh_begin(ssgi__sh_sum *sum, const float *out, int bands, const char **why)
{
    if (!out) return ssgi__bad(why, "out: must not be NULL");
    if (bands < 1 || bands > SSGI_SH_MAX_BANDS) return ssgi__bad(why, "bands: must be 1..SSGI_SH_MAX_BANDS");
    memset(sum, 0, sizeof *sum);
    sum->bands = bands;
    return SSGI_OK;
}

static void ssgi__sh_end(float *out, const ssgi__sh_sum *sum)
{
    int i;
    for (i = 0; i < 3 * sum->bands * sum->bands; ++i) out[i] = (float)sum->of[i];
}

SSGI_DEF ssgi_result ssgi_sh_project_equirect(float *out, int bands, const float *rgb, int width, int height, const char **why)
{
    ssgi__sh_sum sum;
    int x, y;
    if (ssgi__sh_begin(&sum, out, bands, why) != SSGI_OK || ssgi__equirect_bad(rgb, width, height, why) != SSGI_OK) return SSGI_BAD_ARGUMENT;
    for (y = 0; y < height; ++y) {
        double polar[2], direction[3], weight = ssgi__equirect_row(polar, y + 0.5, width, height);
        for (x = 0; x < width; ++x, rgb += 3) {
            ssgi__equirect(direction, polar, x + 0.5, width);
            ssgi__sh_add(&sum, direction, rgb, weight);
        }
    }
    ssgi__sh_end(out, &sum);
    return SSGI_OK;
}

/* solid angle of the rectangle from (0,0) to (x,y) at distance 1 */
static double ssgi__rectangle(double x, double y) { return atan(x * y / sqrt(x * x + y * y + 1.0)); }

SSGI_DEF ssgi_result ssgi_sh_project_cube(float *out, int bands, const float *const faces[6], int size, const char **why)
{
    static const signed char across[6][3] = { { 0, 0, -1 }, { 0, 0, 1 }, { 1, 0, 0 }, { 1, 0, 0 }, { 1, 0, 0 }, { -1, 0, 0 } };   /* of s and t, GL table 8.19 */
    static const signed char down[6][3] = { { 0, -1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 }, { 0, -1, 0 }, { 0, -1, 0 } };
    ssgi__sh_sum sum;
    int x, y, face, i;
    if (ssgi__sh_begin(&sum, out, bands, why) != SSGI_OK) return SSGI_BAD_ARGUMENT;
    if (!faces) return ssgi__bad(why, "faces: must not be NULL");
    for (face = 0; face < 6; ++face)
        if (!faces[face]) return ssgi__bad(why, "faces: all six must be there, none NULL");
    if (size < 1 || size > 65536) return ssgi__bad(why, "size: must be 1..65536");
    for (y = 0; y < size; ++y)
        for (x = 0; x < size; ++x) {
            const double s = (2 * x + 1.0) / size - 1.0, t = (2 * y + 1.0) / size - 1.0, h = 1.0 / size;
            const double weight = ssgi__rectangle(s + h, t + h) - ssgi__rectangle(s - h, t + h) - ssgi__rectangle(s + h, t - h) + ssgi__rectangle(s - h, t - h);
            for (face = 0; face < 6; ++face) {
                double direction[3];
                for (i = 0; i < 3; ++i) direction[i] = s * across[face][i] + t * down[face][i];
                direction[face / 2] = face & 1 ? -1.0 : 1.0;
                ssgi__normalise(direction);
                ssgi__sh_add(&sum, direction, faces[face] + 3 * ((size_t)y * (size_t)size + (size_t)x), weight);
            }
        }
    ssgi__sh_end(out, &sum);
    return SSGI_OK;
}

SSGI_DEF void ssgi_sh_window(float *out, int bands, int window)
{
    double positive = 1.0;
    int l;
    bands = ssgi__sh_limit(bands);
    for (l = 0; l < bands; ++l) {
        out[l] = (float)(window == SSGI_SH_WINDOW_HANN ? 0.5 + 0.5 * cos(3.14159265358979323846 * l / bands) : window == SSGI_SH_WINDOW_POSITIVE ? positive : 1.0);
        positive *= (bands - 1.0 - l) / (bands + 1.0 + l);      /* p!(p+1)! / ((p-l)!(p+l+1)!), p = bands - 1 */
    }
}

SSGI_DEF void ssgi_sh_zonal(float *out, int bands, const float *zonal, const float direction[3])
{
    int l, i = 0;
    bands = ssgi__sh_limit(bands);
    ssgi_sh_basis(out, bands, direction);
    for (l = 0; l < bands; ++l)
        for (; i < (l + 1) * (l + 1); ++i) out[i] *= zonal[l] * (float)sqrt(12.56637061435917295 / (2 * l + 1));
}

/* Direction i of (degree/2 + 1) * (degree + 1), Gauss-Legendre in z by uniform in azimuth, exact for polynomials up to that degree; returns its solid angle. */
static double ssgi__sphere_node(double d[3], int degree, int i)
{
    const double pi = 3.14159265358979323846;
    const int rows = degree / 2 + 1, columns = degree + 1;
    const double azimuth = 2.0 * pi * (i % columns) / columns;
    double z = cos(pi * (i / columns + 0.75) / (rows + 0.5)), slope = 1.0, r;
    int step, l;
    for (step = 0; step < 5; ++step) {              /* Newton, to a zero of the Legendre polynomial */
        double p = 1.0, before = 0.0;
        for (l = 0; l < rows; ++l) {
            const double next = ((2 * l + 1) * z * p - l * before) / (l + 1);
            before = p;
            p = next;
        }
        slope = rows * (z * p - before) / (z * z - 1.0);
        z -= p / slope;
    }
    r = sqrt(1.0 - z * z);
    d[0] = r * cos(azimuth);
    d[1] = r * sin(azimuth);
    d[2] = z;
    return 4.0 * pi / columns / (r * r * slope * slope);
}

SSGI_DEF void ssgi_sh_rotate(float *out, int bands, const float *coefficients, int channels, const float *m)
{
    static const float none[12] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };
    double matrix[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS][2 * SSGI_SH_MAX_BANDS - 1], band[2 * SSGI_SH_MAX_BANDS - 1];     /* bands do not mix: of a row, its own */
    int l, i, j, c, node;
    bands = ssgi__sh_limit(bands);
    memset(matrix, 0, sizeof matrix);
    if (!m) m = none;
    for (node = 0; node < bands * (2 * bands - 1); ++node) {
        double here[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS], there[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS], view[3], world[3], weight;
        weight = ssgi__sphere_node(view, 2 * (bands - 1), node);
        for (i = 0; i < 3; ++i) world[i] = (double)m[4 * i] * view[0] + (double)m[4 * i + 1] * view[1] + (double)m[4 * i + 2] * view[2];
        ssgi__sh_basis(here, bands, view);
        ssgi__sh_basis(there, bands, world);
        for (l = i = 0; l < bands; ++l)
            for (; i < (l + 1) * (l + 1); ++i)
                for (j = 0; j < 2 * l + 1; ++j) matrix[i][j] += weight * here[i] * there[l * l + j];
    }
    for (c = 0; c < channels; ++c)
        for (l = i = 0; l < bands; ++l) {
            for (j = 0; j < 2 * l + 1; ++j) band[j] = (double)coefficients[channels * (l * l + j) + c];
            for (; i < (l + 1) * (l + 1); ++i) {
                double sum = 0.0;
                for (j = 0; j < 2 * l + 1; ++j) sum += matrix[i][j] * band[j];
                out[channels * i + c] = (float)sum;
            }
        }
}

static double ssgi__sh_weakened(const double part[SSGI_SH_MAX_BANDS], int bands, double s)
{
    double sum = 0.0;
    int l;
    for (l = 0; l < bands; ++l) sum += part[l] / (1.0 + s * (l * l * (l + 1) * (l + 1)));
    return sum;
}

/* One of interleaved channels at a direction: part, what every band has there; returns their sum, weakened by s. */
static double ssgi__sh_at(double part[SSGI_SH_MAX_BANDS], int bands, const float *coefficients, int channels, const double d[3], double s)
{
    double basis[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS];
    int l, i = 0;
    ssgi__sh_basis(basis, bands, d);
    for (l = 0; l < bands; ++l)
        for (part[l] = 0.0; i < (l + 1) * (l + 1); ++i) part[l] += basis[i] * (double)coefficients[channels * i];
    return ssgi__sh_weakened(part, bands, s);
}

SSGI_DEF void ssgi_sh_product(float *out, int bands, const float *a, const float *b)
{
    double sum[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS] = { 0.0 }, basis[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS], part[SSGI_SH_MAX_BANDS], d[3];
    int i, node, degree;
    bands = ssgi__sh_limit(bands);
    degree = 3 * (bands - 1);
    for (node = 0; node < (degree / 2 + 1) * (degree + 1); ++node) {
        const double weight = ssgi__sphere_node(d, degree, node), value = weight * ssgi__sh_at(part, bands, a, 1, d, 0.0) * ssgi__sh_at(part, bands, b, 1, d, 0.0);
        ssgi__sh_basis(basis, bands, d);
        for (i = 0; i < bands * bands; ++i) sum[i] += value * basis[i];
    }
    for (i = 0; i < bands * bands; ++i) out[i] = (float)sum[i];
}

/* Means of the Legendre polynomials over [cosine, 1]: what a cap leaves of the bands of a direction. Does not cancel at cosine 1, as differences of polynomials would. */
static void ssgi__sh_cap(double mean[SSGI_SH_MAX_BANDS], double cosine)
{
    int l;
    mean[0] = 1.0;
    mean[1] = 0.5 + 0.5 * cosine;
    for (l = 2; l < SSGI_SH_MAX_BANDS; ++l) mean[l] = ((2 * l - 1) * cosine * mean[l - 1] - (l - 2) * mean[l - 2]) / (l + 1);
}

/* adds factor[l] Y_i(d) times the colour of even or of odd bands */
static void ssgi__sh_add_zonal(float *coefficients, int bands, const double factor[SSGI_SH_MAX_BANDS], const double d[3], double colour[2][3])
{
    double basis[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS];
    int l, i = 0, c;
    ssgi__sh_basis(basis, bands, d);
    for (l = 0; l < bands; ++l)
        for (; i < (l + 1) * (l + 1); ++i)
            for (c = 0; c < 3; ++c) coefficients[3 * i + c] += (float)(factor[l] * basis[i] * colour[l & 1][c]);
}

static int ssgi__finite3(const float *v) { return v && ssgi__finite(v[0]) && ssgi__finite(v[1]) && ssgi__finite(v[2]); }

/* 0 if it is not a direction */
static int ssgi__direction(double d[3], const float *v)
{
    int i;
    if (!ssgi__finite3(v)) return 0;
    for (i = 0; i < 3; ++i) d[i] = (double)v[i];
    return ssgi__normalise(d) > 0.0;
}

static ssgi_result ssgi__sh_bad(const float *coefficients, int bands, const char **why)
{
    if (!coefficients) return ssgi__bad(why, "coefficients: must not be NULL");
    if (bands < 1 || bands > SSGI_SH_MAX_BANDS) return ssgi__bad(why, "bands: must be 1..SSGI_SH_MAX_BANDS");
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_sh_light(float *coefficients, int bands, const float direction[3], float sine, const float irradiance[3], int window, const char **why)
{
    double d[3], factor[SSGI_SH_MAX_BANDS], colour[2][3], facing = 0.0;
    float weight[SSGI_SH_MAX_BANDS];
    int l, c;
    if (ssgi__sh_bad(coefficients, bands, why) != SSGI_OK) return SSGI_BAD_ARGUMENT;
    if (!ssgi__direction(d, direction)) return ssgi__bad(why, "direction: must be there, finite and not 0");
    if (!ssgi__finite(sine) || !(sine >= 0.0f && sine <= 1.0f)) return ssgi__bad(why, "sine: must be 0..1");
    if (!ssgi__finite3(irradiance)) return ssgi__bad(why, "irradiance: must be there and finite");
    if (window < SSGI_SH_WINDOW_NONE || window > SSGI_SH_WINDOW_POSITIVE) return ssgi__bad(why, "window: must be one of SSGI_SH_WINDOW_");
    ssgi_sh_window(weight, bands, window);
    ssgi__sh_cap(factor, sqrt(1.0 - (double)sine * (double)sine));
    for (l = 0; l < bands; ++l) {
        factor[l] *= (double)weight[l];
        facing += factor[l] * (double)ssgi_sh_cosine(l) * (2 * l + 1) / 12.56637061435917295;
    }
    for (c = 0; c < 3; ++c) colour[0][c] = colour[1][c] = ssgi__light(irradiance[c], -1e24f) / facing;
    ssgi__sh_add_zonal(coefficients, bands, factor, d, colour);
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_sh_sky(float *coefficients, int bands, const float up[3], const float above[3], const float below[3], const char **why)
{
    double d[3], factor[SSGI_SH_MAX_BANDS], colour[2][3];
    int c;
    if (ssgi__sh_bad(coefficients, bands, why) != SSGI_OK) return SSGI_BAD_ARGUMENT;
    if (!ssgi__direction(d, up)) return ssgi__bad(why, "up: must be there, finite and not 0");
    if (!ssgi__finite3(above)) return ssgi__bad(why, "above: must be there and finite");
    if (!ssgi__finite3(below)) return ssgi__bad(why, "below: must be there and finite");
    ssgi__sh_cap(factor, 0.0);
    for (c = 0; c < 3; ++c) {                       /* two caps of 2 pi, opposite: of the lower one, odd bands change sign */
        const double a = 6.283185307179586477 * ssgi__light(above[c], -1e24f), b = 6.283185307179586477 * ssgi__light(below[c], -1e24f);
        colour[0][c] = a + b;
        colour[1][c] = a - b;
    }
    ssgi__sh_add_zonal(coefficients, bands, factor, d, colour);
    return SSGI_OK;
}

/* The lowest value of a channel of three weakened by s, and the bands there; 0 and nothing when it is nowhere below 0. */
static double ssgi__sh_lowest(double part[SSGI_SH_MAX_BANDS], int bands, const float *coefficients, double s)
{
    double lowest = 0.0, step, d[3], next[3], found[SSGI_SH_MAX_BANDS], other[SSGI_SH_MAX_BANDS], value, v;
    int node, j, moved;
    for (node = 0; node < 10 * 20; ++node) {
        ssgi__sphere_node(d, 19, node);
        value = ssgi__sh_at(found, bands, coefficients, 3, d, s);
        if (value > lowest + 0.5 * found[0]) continue;      /* the narrowest pit that 6 bands can have rises less from its bottom to the nearest start */
        for (step = 0.1; step > 0.005; step *= moved ? 1.0 : 0.5)
            for (moved = j = 0; j < 6; ++j) {
                memcpy(next, d, sizeof next);
                next[j / 2] += j & 1 ? -step : step;
                ssgi__normalise(next);
                v = ssgi__sh_at(other, bands, coefficients, 3, next, s);
                if (v >= value) continue;
                value = v;
                moved = 1;
                memcpy(d, next, sizeof d);
                memcpy(found, other, sizeof found);
            }
        if (value >= lowest) continue;
        lowest = value;
        memcpy(part, found, sizeof found);
    }
    return lowest;
}

SSGI_DEF ssgi_result ssgi_sh_dering(float *coefficients, int bands, float *strength, const char **why)
{
    double s = 0.0, part[SSGI_SH_MAX_BANDS];
    int i, c, l, raised;
    if (ssgi__sh_bad(coefficients, bands, why) != SSGI_OK) return SSGI_BAD_ARGUMENT;
    for (i = 0; i < 3 * bands * bands; ++i)
        if (!ssgi__finite(coefficients[i])) return ssgi__bad(why, "coefficients: must be finite");
    do                                              /* s rises until the direction that is lowest is not below 0, until none is */
        for (raised = c = 0; c < 3; ++c) {
            double least = s, most = -1.0;
            if (!(coefficients[c] > 0.0f) || ssgi__sh_lowest(part, bands, coefficients + c, s) >= -5e-4 * 0.282094792 * (double)coefficients[c]) continue;
            for (l = 0; l < bands; ++l) most += fabs(part[l]) / part[0];
            for (most = 0.25 * most, i = 0; i < 100; ++i) {     /* at most, the higher bands do not reach band 0 even if all are against it */
                s = 0.5 * (least + most);
                if (ssgi__sh_weakened(part, bands, s) < 0.0) least = s; else most = s;
            }
            s = most;
            raised = 1;
        }
    while (raised);
    for (l = i = 0; l < bands; ++l)
        for (; i < 3 * (l + 1) * (l + 1); ++i) coefficients[i] = (float)((double)coefficients[i] / (1.0 + s * (l * l * (l + 1) * (l + 1))));
    if (strength) *strength = s < 1e30 ? (float)s : 1e30f;
    return SSGI_OK;
}

/* ==== >>environment (implementation) =========================================================================== */

#define SSGI__CELLS_X 96
#define SSGI__CELLS_Y 48

SSGI_DEF void ssgi_octahedral_encode(const float d[3], float out[2])
{
    const double x = (double)d[0], y = (double)d[1], ax = fabs(x), ay = fabs(y), sum = ax + ay + fabs((double)d[2]), scale = sum > 0.0 ? 1.0 / sum : 0.0;
    out[0] = (float)(d[2] < 0.0f ? (1.0 - ay * scale) * (x < 0.0 ? -1.0 : 1.0) : x * scale);
    out[1] = (float)(d[2] < 0.0f ? (1.0 - ax * scale) * (y < 0.0 ? -1.0 : 1.0) : y * scale);
}

SSGI_DEF void ssgi_octahedral_decode(const float e[2], float out[3])
{
    double n[3], t;
    int i;
    n[0] = (double)e[0];
    n[1] = (double)e[1];
    n[2] = 1.0 - fabs(n[0]) - fabs(n[1]);
    t = n[2] < 0.0 ? -n[2] : 0.0;
    for (i = 0; i < 2; ++i) n[i] += n[i] < 0.0 ? t : -t;
    ssgi__normalise(n);
    for (i = 0; i < 3; ++i) out[i] = (float)n[i];
}

/* The picture as cells: averages over their exact solid angle, with texels taken as constant; so a cell may be smaller than a texel. */
static void ssgi__environment_cells(float cell[SSGI__CELLS_Y][SSGI__CELLS_X][3], const float *rgb, int width, int height)
{
    const double pi = 3.14159265358979323846;
    int i, j, x, y, c;
    for (i = 0; i < SSGI__CELLS_Y; ++i) {           /* rows in units of 1 / (CELLS_Y * height), columns in 1 / (CELLS_X * width) */
        double sum[SSGI__CELLS_X][3] = { { 0.0 } }, area = 0.0;
        for (y = i * height / SSGI__CELLS_Y; y * SSGI__CELLS_Y < (i + 1) * height; ++y) {
            const int top = y * SSGI__CELLS_Y > i * height ? y * SSGI__CELLS_Y : i * height;
            const int bottom = (y + 1) * SSGI__CELLS_Y < (i + 1) * height ? (y + 1) * SSGI__CELLS_Y : (i + 1) * height;
            const double weight = cos(pi * top / ((double)height * SSGI__CELLS_Y)) - cos(pi * bottom / ((double)height * SSGI__CELLS_Y));
            const float *row = rgb + 3 * (size_t)y * (size_t)width;
            area += weight * width;
            for (j = 0; j < SSGI__CELLS_X; ++j)
                for (x = j * width / SSGI__CELLS_X; x * SSGI__CELLS_X < (j + 1) * width; ++x) {
                    const int left = x * SSGI__CELLS_X > j * width ? x * SSGI__CELLS_X : j * width;
                    const int right = (x + 1) * SSGI__CELLS_X < (j + 1) * width ? (x + 1) * SSGI__CELLS_X : (j + 1) * width;
                    for (c = 0; c < 3; ++c) sum[j][c] += weight * (right - left) * ssgi__light(row[3 * (size_t)x + (size_t)c], 0.0f);
                }
        }
        for (j = 0; j < SSGI__CELLS_X; ++j)
            for (c = 0; c < 3; ++c) cell[i][j][c] = (float)(sum[j][c] / area);
    }
}

/* Weights: exp(kappa (cosine - 1)), or where kappa is 0 the cosine, ramped up by slope; nothing for cosines up to least. */
static ssgi_result ssgi__environment_lobes(float *out, int size, const float *rgb, int width, int height, float kappa, float least, float slope, const char **why)
{
    float cell[SSGI__CELLS_Y][SSGI__CELLS_X][3], around[SSGI__CELLS_X][2], polar[SSGI__CELLS_Y][3];
    int i, j, c, texel;
    if (!out) return ssgi__bad(why, "out: must not be NULL");
    if (size < 8 || size > 256) return ssgi__bad(why, "size: must be 8..256");
    if (ssgi__equirect_bad(rgb, width, height, why) != SSGI_OK) return SSGI_BAD_ARGUMENT;
    ssgi__environment_cells(cell, rgb, width, height);
    for (i = 0; i < SSGI__CELLS_Y; ++i) {
        double p[2];
        polar[i][2] = (float)ssgi__equirect_row(p, i + 0.5, SSGI__CELLS_X, SSGI__CELLS_Y);
        polar[i][0] = (float)p[0];
        polar[i][1] = (float)p[1];
    }
    for (j = 0; j < SSGI__CELLS_X; ++j) {
        const double level[2] = { 1.0, 0.0 };
        double d[3];
        ssgi__equirect(d, level, j + 0.5, SSGI__CELLS_X);
        around[j][0] = (float)d[0];
        around[j][1] = (float)d[2];
    }
    for (texel = 0; texel < size * size; ++texel) {
        const float e[2] = { (2.0f * (float)(texel % size) + 1.0f) / (float)size - 1.0f, (2.0f * (float)(texel / size) + 1.0f) / (float)size - 1.0f };
        float d[3], flat[SSGI__CELLS_X], most = -1.0f;
        double sum[3] = { 0, 0, 0 }, all = 0.0;
        ssgi_octahedral_decode(e, d);
        for (j = 0; j < SSGI__CELLS_X; ++j) {
            flat[j] = d[0] * around[j][0] + d[2] * around[j][1];
            most = flat[j] > most ? flat[j] : most;
        }
        for (i = 0; i < SSGI__CELLS_Y; ++i) {
            if (d[1] * polar[i][1] + most * polar[i][0] <= least) continue;
            for (j = 0; j < SSGI__CELLS_X; ++j) {
                const float cosine = d[1] * polar[i][1] + flat[j] * polar[i][0], ramp = (cosine - least) * slope;
                double weight;
                if (cosine <= least) continue;
                weight = (double)(polar[i][2] * (kappa > 0.0f ? expf(kappa * (cosine - 1.0f)) : ramp < 1.0f ? ramp * cosine : cosine));
                all += weight;
                for (c = 0; c < 3; ++c) sum[c] += weight * (double)cell[i][j][c];
            }
        }
        for (c = 0; c < 3; ++c) out[3 * (size_t)texel + (size_t)c] = (float)(sum[c] / all);
    }
    return SSGI_OK;
}

#define SSGI__STEEP 1e30f       /* no ramp */

SSGI_DEF ssgi_result ssgi_environment_map(float *out, int size, const float *rgb, int width, int height, float solid_angle, const char **why)
{
    const float kappa = solid_angle > 0.0f ? 12.5663706f / (solid_angle > 0.05f ? solid_angle : 0.05f) : 0.0f;
    if (!ssgi__finite(solid_angle) || !(solid_angle >= 0.0f)) return ssgi__bad(why, "solid_angle: must be finite, 0 or above");
    return ssgi__environment_lobes(out, size, rgb, width, height, kappa, kappa > 0.0f ? 1.0f - 16.0f / kappa : 0.0f, SSGI__STEEP, why);      /* below, less than 1e-7 */
}

SSGI_DEF ssgi_result ssgi_environment_cone(float *out, int size, const float *rgb, int width, int height, float cosine, const char **why)
{
    float half;
    if (!ssgi__finite(cosine) || !(cosine >= 0.0f && cosine <= 0.95f)) return ssgi__bad(why, "cosine: must be 0..0.95");
    half = 0.0654498469f * sqrtf(1.0f - cosine * cosine);       /* a cell's width, as a difference of cosines at the rim */
    if (half > cosine) half = cosine;
    return ssgi__environment_lobes(out, size, rgb, width, height, 0.0f, cosine - half, half > 0.0f ? 0.5f / half : SSGI__STEEP, why);
}

typedef struct ssgi__region { int lower[2], upper[2]; double energy; } ssgi__region;    /* columns, rows */

#define SSGI__REGION_BINS 256

/* Luminance times solid angle of a region's lines across an axis, 2^shift lines a bin. */
static void ssgi__region_bins(double bin[SSGI__REGION_BINS], const ssgi__region *r, int axis, int shift, const float *rgb, int width, int height)
{
    int x, y, c;
    memset(bin, 0, SSGI__REGION_BINS * sizeof *bin);
    for (y = r->lower[1]; y < r->upper[1]; ++y) {
        const float *p = rgb + 3 * ((size_t)y * (size_t)width + (size_t)r->lower[0]);
        double polar[2], light[3], weight = ssgi__equirect_row(polar, y + 0.5, width, height);
        for (x = r->lower[0]; x < r->upper[0]; ++x, p += 3) {
            for (c = 0; c < 3; ++c) light[c] = ssgi__light(p[c], 0.0f);
            bin[((axis ? y : x) - r->lower[axis]) >> shift] += weight * ssgi__luminance(light);
        }
    }
}

/* Cuts a region of at least two texels at its median along its wider side; the other half goes to *rest. */
static void ssgi__region_split(ssgi__region *region, ssgi__region *rest, const float *rgb, int width, int height)
{
    double bin[SSGI__REGION_BINS], polar[2], before = 0.0;
    const double half = 0.5 * region->energy;
    ssgi__region part = *region;
    const int columns = part.upper[0] - part.lower[0], rows = part.upper[1] - part.lower[1];
    int axis, shift = 0, last, b, cut;
    ssgi__equirect_row(polar, 0.5 * (part.lower[1] + part.upper[1]), width, height);
    axis = rows > 1 && (columns < 2 || 2.0 * columns * polar[0] / width <= (double)rows / height);
    while ((part.upper[axis] - part.lower[axis] - 1) >> shift >= SSGI__REGION_BINS) ++shift;
    for (;; shift = 0) {                            /* sides of more than 256: first the bin, then the line within it */
        ssgi__region_bins(bin, &part, axis, shift, rgb, width, height);
        last = (part.upper[axis] - part.lower[axis] - 1) >> shift;
        for (b = 0; b < last && before + bin[b] < half; ++b) before += bin[b];
        cut = part.lower[axis] + (b << shift);
        if (!shift) break;
        part.lower[axis] = cut;
        if (part.upper[axis] > cut + (1 << shift)) part.upper[axis] = cut + (1 << shift);
    }
    /* before or after the line that holds the median, whichever is nearer to it */
    if (cut == region->lower[axis] || (cut + 1 < region->upper[axis] && before + bin[b] - half < half - before)) { before += bin[b]; ++cut; }
    *rest = *region;
    rest->lower[axis] = region->upper[axis] = cut;
    rest->energy = region->energy - before;
    region->energy = before;
}

static void ssgi__region_sun(ssgi_sun *sun, const ssgi__region *r, const float *rgb, int width, int height)
{
    double total[3] = { 0, 0, 0 }, mean[3] = { 0, 0, 0 }, polar[2], d[3], energy = 0.0;
    int x, y, c;
    for (y = r->lower[1]; y < r->upper[1]; ++y) {
        const float *p = rgb + 3 * ((size_t)y * (size_t)width + (size_t)r->lower[0]);
        const double weight = ssgi__equirect_row(polar, y + 0.5, width, height);
        for (x = r->lower[0]; x < r->upper[0]; ++x, p += 3) {
            double light[3], luminance;
            for (c = 0; c < 3; ++c) light[c] = weight * ssgi__light(p[c], 0.0f);
            luminance = ssgi__luminance(light);
            energy += luminance;
            ssgi__equirect(d, polar, x + 0.5, width);
            for (c = 0; c < 3; ++c) { total[c] += light[c]; mean[c] += luminance * d[c]; }
        }
    }
    if (!(ssgi__normalise(mean) > 1e-6 * energy)) { /* dark, or the same all around */
        ssgi__equirect_row(polar, 0.5 * (r->lower[1] + r->upper[1]), width, height);
        ssgi__equirect(mean, polar, 0.5 * (r->lower[0] + r->upper[0]), width);
    }
    for (c = 0; c < 3; ++c) { sun->direction[c] = (float)mean[c]; sun->irradiance[c] = (float)total[c]; }
}

SSGI_DEF ssgi_result ssgi_environment_suns(ssgi_sun *out, int count, const float *rgb, int width, int height, const char **why)
{
    ssgi__region region[1024];
    double bin[SSGI__REGION_BINS];
    int n, i;
    if (!out) return ssgi__bad(why, "out: must not be NULL");
    if (count < 1 || count > 1024) return ssgi__bad(why, "count: must be 1..1024");
    if (ssgi__equirect_bad(rgb, width, height, why) != SSGI_OK) return SSGI_BAD_ARGUMENT;
    region[0].lower[0] = region[0].lower[1] = 0;
    region[0].upper[0] = width;
    region[0].upper[1] = height;
    ssgi__region_bins(bin, &region[0], 0, 16, rgb, width, height);      /* all in one bin */
    region[0].energy = bin[0];
    for (n = 1; n < count; ++n) {
        int most = -1;
        for (i = 0; i < n; ++i) {
            const ssgi__region *r = &region[i];
            if ((r->upper[0] - r->lower[0] > 1 || r->upper[1] - r->lower[1] > 1) && (most < 0 || r->energy > region[most].energy)) most = i;
        }
        if (most < 0) break;
        ssgi__region_split(&region[most], &region[n], rgb, width, height);
    }
    for (i = 0; i < count; ++i) {                   /* none left to split: one without texels, where the first is */
        const ssgi__region none = { { region[0].lower[0], region[0].lower[1] }, { region[0].lower[0], region[0].lower[1] }, 0.0 };
        ssgi__region_sun(&out[i], i < n ? &region[i] : &none, rgb, width, height);
    }
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_sh_lacking(float *map, int size, const float *coefficients, int bands, const ssgi_sun *suns, int count, const char **why)
{
    const double pi = 3.14159265358979323846;
    int texel, i, c, l;
    if (!map) return ssgi__bad(why, "map: must not be NULL");
    if (size < 8 || size > 256) return ssgi__bad(why, "size: must be 8..256");
    if (!coefficients) return ssgi__bad(why, "coefficients: must not be NULL");
    if (bands < 1 || bands > SSGI_SH_MAX_BANDS) return ssgi__bad(why, "bands: must be 1..SSGI_SH_MAX_BANDS");
    if (count < 0 || (count && !suns)) return ssgi__bad(why, "suns: must not be NULL when count is not 0");
    for (texel = 0; texel < size * size; ++texel, map += 3) {
        const float e[2] = { (2.0f * (float)(texel % size) + 1.0f) / (float)size - 1.0f, (2.0f * (float)(texel / size) + 1.0f) / (float)size - 1.0f };
        float n[3], basis[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS];
        double sum[3] = { 0, 0, 0 };
        ssgi_octahedral_decode(e, n);
        ssgi_sh_basis(basis, bands, n);
        for (l = 0, i = 0; l < bands; ++l)
            for (; i < (l + 1) * (l + 1); ++i)
                for (c = 0; c < 3; ++c) sum[c] -= (double)ssgi_sh_cosine(l) * (double)basis[i] * (double)coefficients[3 * i + c];
        for (i = 0; i < count; ++i) {
            const double cosine = (double)n[0] * (double)suns[i].direction[0] + (double)n[1] * (double)suns[i].direction[1] + (double)n[2] * (double)suns[i].direction[2];
            for (c = 0; c < 3; ++c) sum[c] += (cosine > 0.0 ? cosine : 0.0) * (double)suns[i].irradiance[c];
        }
        for (c = 0; c < 3; ++c) map[c] += (float)(sum[c] / pi);
    }
    return SSGI_OK;
}

/* ==== >>vpl (implementation) =================================================================================== */

static double ssgi__vpl_flux(double flux[3], const float *rgb)
{
    int c;
    for (c = 0; c < 3; ++c) flux[c] = ssgi__light(rgb[c], 0.0f);
    return ssgi__luminance(flux);
}

SSGI_DEF ssgi_result ssgi_vpl_choose(ssgi_vpl *out, int count, const float *position, const float *normal, const float *flux, size_t pixels, const char **why)
{
    double rgb[3], total = 0.0, sum, here;
    size_t k, last = 0;
    int i, c;
    if (!out) return ssgi__bad(why, "out: must not be NULL");
    if (count < 1 || count > 4096) return ssgi__bad(why, "count: must be 1..4096");
    if (!position) return ssgi__bad(why, "position: must not be NULL");
    if (!normal) return ssgi__bad(why, "normal: must not be NULL");
    if (!flux) return ssgi__bad(why, "flux: must not be NULL");
    if (pixels < 1) return ssgi__bad(why, "pixels: must be 1 or more");
    for (k = 0; k < pixels; ++k) {
        here = ssgi__vpl_flux(rgb, flux + 3 * k);
        total += here;
        if (here > 0.0) last = k;
    }
    if (!(total > 0.0)) return ssgi__bad(why, "flux: must be above 0 somewhere");
    k = 0;
    sum = here = ssgi__vpl_flux(rgb, flux);
    for (i = 0; i < count; ++i) {                   /* last holds the end against rounding, and against sums in another order */
        const double at = (i + (double)ssgi_radical_inverse(2, (uint32_t)i)) / count * total;
        while (k < last && sum <= at) sum += here = ssgi__vpl_flux(rgb, flux + 3 * ++k);
        for (c = 0; c < 3; ++c) {
            out[i].position[c] = position[3 * k + (size_t)c];
            out[i].normal[c] = normal[3 * k + (size_t)c];
            out[i].intensity[c] = (float)(rgb[c] / here * (total / (3.14159265358979323846 * count)));
        }
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

SSGI_DEF float ssgi_shadow_patch(float depth, float full_angle, int resolution)
{
    return (float)(2.0 * (double)depth * tan(0.5 * (double)full_angle) / (resolution > 1 ? resolution : 1));
}

SSGI_DEF float ssgi_shadow_bias(float patch, float cos_alpha, float most)
{
    const double c = cos_alpha < 1.0f ? (double)cos_alpha : 1.0;
    double bias;
    if (!(c > 0.0)) return most;
    bias = (double)patch * 0.70710678118654752440 * sqrt(1.0 - c * c) / c;
    return bias < (double)most ? bias > 0.0 ? (float)bias : 0.0f : most;
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
