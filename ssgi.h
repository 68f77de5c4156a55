/* ssgi.h - v0.5 - screen-space illumination: the CPU maths. C99, no dependencies. Public domain or MIT: end of file.

   Do this in *one* C or C++ file:      #define SSGI_IMPLEMENTATION
                                        #include "ssgi.h"
   and include it plainly elsewhere. The GLSL of every pass is in ssgi_gl.h, which includes this file.

   QUICK USE  (compiled and run by tests/library/test_build.c)

      float      projection[16] = { 1.3f,0,0,0,  0,2.4f,0,0,  0,0,-1.002f,-1,  0,0,-0.2002f,0 };   // as GL has it
      ssgi_view  view;
      const char *why = "";
      if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, 1280, 720, &why) != SSGI_OK) puts(why);
      float p[3];
      ssgi_view_position(p, &view, 640.5f, 360.5f, ssgi_view_depth(&view, 0.75f));   // a depth texel, in view space
      printf("%g %g %g, a pixel is %g wide there\n", p[0], p[1], p[2], ssgi_pixel_footprint(&view, -p[2]));

   CONVENTIONS  (given once; every comment relies on them)
      matrices     float[16], element (row r, column c) at m[c*4 + r]; vectors are columns
      view space   right-handed, +x right, +y up, the camera looks along -z; VIEW DEPTH is the positive distance -z
      pixels       (0,0) is the corner of the first texel, centres are at (x+0.5, y+0.5), and y grows as in GL textures
                   (upward when the projection is GL's)
      window depth the value that the depth texture holds, in [0,1]
      units        lengths are in your view units, angles in radians; radiance is linear
      visibility   V is 1 where visible, 0 where occluded; occlusion O is in [0,1]; ambient visibility, which AO passes
                   write, is 1 - O, cosine-weighted
      environments latitude-longitude images as in OpenEXR, of linear radiance, rgb[3 * (y * width + x) + c]:
                   row 0 is at +y, the image centre looks to +z, +x is left of the centre; solid angles of texels are
                   exact; values above 1e24 are clamped to 1e24
      errors       functions that can be misused return ssgi_result and, through the last argument (may be NULL), a
                   static sentence that begins with the argument's name; outputs are then untouched. No function prints,
                   exits, allocates or keeps state: all are reentrant.
      twins        the GLSL twin of a function is the one in ssgi_gl.h's shaders that computes the same

   CONFIG       SSGI_STATIC makes every function static. Nothing else changes the header.
   ROOMS        the sections of this file; search for ">>"
      >>types      results
      >>view       projection decode: perspective, orthographic, any handedness and depth; extra cameras
      >>bias       offsets against self-occlusion and self-shadowing; a first guess of the radius
      >>kernel     low-discrepancy points, sample sets, tiles of noise
      >>sh         spherical harmonics: basis, windows, projection of environments, lights, rotation
      >>environment  images as octahedral maps over lobes and cones, and as directional lights; virtual
                   point lights
      >>trace      a small BVH over your triangles: closest hit, any hit
      >>tessellate the points of a tessellated triangle; the level and the radius for its area
      >>surfels    triangles as discs of about equal size on the screen, their reach, and the cost of splatting them
      >>dipole     multiple scattering under surfaces
      >>cap        occlusion of spherical caps, in closed form and as a table
      >>reflection light that occluders reflect (interreflection); the unoccluded share of a glossy lobe
      >>field      ambient occlusion fields: bake, fit, look up, save and load
      >>plan       takes the numbers of a scene, gives a method, settings, predicted error and cost
      and at the end of the file the changes of each version (CHANGES) and the licence

   SOURCES      [HSAO08] Dimitrov, Bavoil, Sainz 2008, Horizon-split ambient occlusion
                [SSDO09] Ritschel, Grosch, Seidel 2009, Approximating dynamic global illumination in image space
                [DSS14]  Nalbach, Ritschel, Seidel 2014, Deep screen space
                [S3HO12] Herholz, Schairer, Schilling, Strasser 2012, Screen space spherical harmonic occlusion
                [SSBN11] Klehm, Ritschel, Eisemann, Seidel 2011, Bent normals and cones in screen-space
                [AOF05]  Kontkanen, Laine 2005, Ambient occlusion fields
                [RAM01]  Ramamoorthi, Hanrahan 2001, An efficient representation for irradiance environment maps
                [DEB05]  Debevec 2005, A median cut algorithm for light probe sampling
                [KEL97]  Keller 1997, Instant radiosity
                [SLO08]  Sloan 2008, Stupid spherical harmonics tricks
                [JMLH01] Jensen, Marschner, Levoy, Hanrahan 2001, A practical model for subsurface light transport
                [JB02]   Jensen, Buhler 2002, A rapid hierarchical rendering technique for translucent materials
                [JWPJ16] Jimenez, Wu, Pesce, Jarabo 2016, Practical real-time strategies for accurate indirect
                         occlusion   */
#ifndef SSGI_H
#define SSGI_H

#include <stddef.h>
#include <stdint.h>

#define SSGI_VERSION_MAJOR 0
#define SSGI_VERSION_MINOR 5
#define SSGI_VERSION (10000 * SSGI_VERSION_MAJOR + 100 * SSGI_VERSION_MINOR)

/* With SSGI_STATIC a compiler would warn of every function that a file does not call, hence the attribute. */
#if defined(SSGI_STATIC) && defined(__GNUC__)
#define SSGI_DEF static __attribute__((unused))
#elif defined(SSGI_STATIC)
#define SSGI_DEF static
#else
#define SSGI_DEF extern
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ==== >>types ================================================================================================== */

/* The last enumerator of each enum type whose values you pass in. With it every int is a value of the type, so that the
   library can read and refuse a bad value, and the type is as wide as an int. */
#define SSGI_FORCE (-0x7fffffff - 1)

typedef enum ssgi_result {
    SSGI_OK = 0,
    SSGI_BAD_ARGUMENT, /* the sentence names the argument */
    SSGI_TOO_SMALL,    /* the memory given is too small; the function that returns its size tells how much is needed */
    SSGI_CANCELLED     /* your progress callback asked for it */
} ssgi_result;

/* ==== >>view =================================================================================================== */

/* The values of `clip` in ssgi_view_from_projection: how a projection's clip z becomes window depth, and y a row. */
enum {
    SSGI_CLIP_GL = 0,       /* NDC z in [-1,1], window depth 0.5 z + 0.5: GL's default */
    SSGI_CLIP_ZERO,         /* NDC z in [0,1] = window depth: GL_ZERO_TO_ONE; use it for reversed depth */
    SSGI_CLIP_ROWS_DOWN = 2 /* added to one of these: row 0 of your textures is at NDC y = 1, the top of the picture, as
                               in D3D, Metal and WebGPU; otherwise it is at NDC y = -1 */
};

/* The camera parameters that the passes use, made by ssgi_view_from_projection; read-only for you. In the comments [k]
   is element k of the member. */
typedef struct ssgi_view {
    float unproject[4]; /* view xy = (pixel * [0,1] + [2,3]) * view depth; orthographic: without "* view depth" */
    float project[4];   /* pixel = view xy / view depth * [0,1] + [2,3];   orthographic: without "/ view depth" */
    float depth[2];     /* 1 / view depth = [0] + [1] * window depth;      orthographic: view depth = ... */
    float clear;        /* the window depth of the background: 1, or 0 if the projection is reversed */
    int orthographic;   /* 0 or 1 */
    int width, height;  /* pixels of the frame */
    float oblique[2];   /* depth[] decodes window depth + dot(pixel, oblique); 0 unless the near plane is oblique */
} ssgi_view;

/* Decodes the projection matrix that GL got. It may be perspective or orthographic, with any window depth (normal,
   reversed, infinite far plane), off-centre (sub-pixel jitter, stereo), with y up or down, with an oblique near plane
   (planar reflections: desc.input.oblique of ssgi_gl.h), right-handed or left-handed.
   If it is left-handed, your camera looks along +z, and view space here is yours with z negated. (An orthographic
   projection counts as left-handed if a right-handed camera would have its whole depth range behind the eye. If the
   depth range of your left-handed orthographic camera reaches behind the eye, negate elements 8 to 11 yourself: its
   matrix is also that of a right-handed camera with reversed depth.)
   With a left-handed camera, negate z of the vectors that you pass in view space (lights; for normals there is
   desc.input.left_handed) and the third row (elements 2, 6, 10, 14) of every matrix to view space, frame.rotation
   included. Vectors that the library returns have z negated, too.
     projection     [limit: w row (0,0,-1,0), (0,0,1,0) or (0,0,0,1) up to a common factor; x and y do not mix]
     clip           SSGI_CLIP_GL or SSGI_CLIP_ZERO, either one + SSGI_CLIP_ROWS_DOWN
     width, height  [units: pixels] [limit: 1..65536] of the frame that the projection fills
   The view is computed in double and exact to float rounding. */
SSGI_DEF ssgi_result ssgi_view_from_projection(ssgi_view *view, const float projection[16], int clip, int width,
                                               int height, const char **why);

/* Returns the view depth [units: view] of a window depth. It is negative behind an orthographic camera's eye, where the
   near plane may lie. The background gives SSGI_FAR: the clear value, NaN, a value outside [0,1], a view depth of
   SSGI_FAR or more, and with perspective a view depth of 1 / SSGI_FAR or less. If view->oblique is not 0, depth depends
   on the pixel, too: use ssgi_view_depth_at, which takes a pixel position, with texel centres at .5. GLSL twin:
   ssgi_window_depth. */
SSGI_DEF float ssgi_view_depth(const ssgi_view *view, float window_depth);
SSGI_DEF float ssgi_view_depth_at(const ssgi_view *view, float pixel_x, float pixel_y, float window_depth);
#define SSGI_FAR 1e18f /* the view depth of the background: it is beyond any scene, and its square is a finite float */

/* ssgi_view_position writes the view-space point that is seen at a pixel position (centres at .5) at a view depth;
   ssgi_view_project writes the pixel position of a view-space point, with its depth [limit: > 0 when perspective] in
   out[2]. GLSL twins: ssgi_position, ssgi_project. */
SSGI_DEF void ssgi_view_position(float out[3], const ssgi_view *view, float pixel_x, float pixel_y, float view_depth);
SSGI_DEF void ssgi_view_project(float out[3], const ssgi_view *view, const float point[3]);

/* Returns the view depth of the near plane that the projection implies [units: view]; for an oblique plane, its least
   view depth in the frame. */
SSGI_DEF float ssgi_view_near(const ssgi_view *view);

/* Returns the size of a pixel [units: view] on a surface that faces the viewer at this view depth: the larger of the
   pixel's two sides. */
SSGI_DEF float ssgi_pixel_footprint(const ssgi_view *view, float view_depth);

/* Makes an extra camera that sees surfaces hidden from the main one [SSDO09 section 4]. It stands at the main eye +
   radius * displacement and looks at centre. From far away all extra cameras would see the same. If the main camera is
   orthographic, pass a matrix whose eye is about 3 radii from the centre.
     main_world_to_view  [limit: rigid: rotation and translation; z may be negated]
     centre, radius      [units: world] [limit: radius > 0] the scene's bounding sphere
     displacement        [units: radii] along the main camera's axes: x right, y up, z toward the viewer
     world_to_view       the extra camera's up direction is the main camera's. If it looks along that direction, its up
                         is the main camera's forward direction. At the centre it looks in the main camera's direction.
                         It is mirrored if the main camera is (left-handed)
     projection          GL clip space, square, symmetric. It encloses the sphere, but is at most 100 degrees wide. The
                         near plane is at 0.02 radii: it is so close because a solid that it cuts would look hollow. The
                         far plane is behind the sphere
   The output arrays may be the input arrays. */
SSGI_DEF ssgi_result ssgi_extra_camera(float world_to_view[16], float projection[16],
                                       const float main_world_to_view[16], const float centre[3], float radius,
                                       const float displacement[3], const char **why);

/* Writes default displacement i modulo 4: left, right, above, behind. If the main camera is two radii from the centre,
   the extra cameras are, too. They are turned about it by 60 degrees to the left or right and 20 up (0, 1), by 75 up
   (2), and to the far side and 50 up (3). */
SSGI_DEF void ssgi_extra_displacement(float out[3], int i);

/* ==== >>bias =================================================================================================== */

/* >>bias in use (compiled and run by tests/library/test_build.c)

      float lift = 1.5f * ssgi_normal_offset(&view, 3.0f);             // of a receiver at view depth 3, by its normal
      float patch = ssgi_shadow_patch(3.0f, 0.8f, 1024);               // the width of a texel of a spot's map there
      float bias = ssgi_shadow_bias(patch, 0.5f, 2.0f * patch, SSGI_BIAS_SAFE); // from 60 degrees off
      printf("lift %g, bias %g\n", lift, bias);   */

/* The functions of >>bias take NaN and floats below 0 as 0, and floats above SSGI_FAR as SSGI_FAR. Their results are
   finite. */

/* Returns the distance by which a receiver is lifted along its normal, so that depths of its own plane, fetched from
   the nearest texel, stay below it: z/(f res) [HSAO08 eq. 13]; for instance 0.00802 at z = 10 for 60 degrees, f =
   1/tan(30 degrees), over 720 pixels. It is half of ssgi_pixel_footprint, since NDC spans 2; if the two sides of a
   pixel are unequal, the larger one counts. With an orthographic projection it is the same at any depth.
     view_depth   [units: view] positive: GL's negative z and NaN count as 0, and the receiver would not be lifted
   The result is in 0..SSGI_FAR. GLSL twin: ssgi_lift, which lifts by frame.offset times this distance: 1.5 times by
   default, since the corners of a pixel need sqrt(2). */
SSGI_DEF float ssgi_normal_offset(const ssgi_view *view, float view_depth);

/* Returns the width of a shadow map's texel on a surface that faces the light: 2 z tan(angle/2)/resolution [SSDO09
   section 5].
     depth        [units: view] z, along the spot's axis, not the distance from the light
     full_angle   [units: rad] [limit: 0..3.14, clamped] of the spot, from edge to edge
     resolution   [units: texels] [limit: 1 or more, less counts as 1] of the map, across that angle
   ssgi_gl_light.patch holds this width for depth 1. */
SSGI_DEF float ssgi_shadow_patch(float depth, float full_angle, int resolution);

/* The values of `kind` in ssgi_shadow_bias: the length across a texel of the shadow map that is halved and multiplied
   by tan(alpha), which gives the bias. */
enum {
    SSGI_BIAS_SAFE = 0,  /* the diagonal: patch/sqrt(2) tan(alpha), which slopes in any direction need */
    SSGI_BIAS_PUBLISHED, /* the side: patch/2 tan(alpha) [SSDO09 section 5], which suffices for slopes along a side
                            alone: a plane that slopes along the diagonal shadows itself */
};

/* Returns the bias of a shadow map: the distance by which a texel has to be moved below its surface, along the map's
   axis, so that a plane does not shadow itself.
     patch    [units: view] width of the texel on a surface that faces the light: ssgi_shadow_patch
     cosine   [limit: 0..1, clamped] of alpha, between the surface's normal and the direction to the light
     most     [units: view] at least 0: a larger bias is cut to it. It is also the bias at 90 degrees, where tan(alpha)
              is infinite, and if cosine is NaN
     kind     SSGI_BIAS_SAFE ..; any other value counts as SAFE
   GLSL twin: ssgi_shadow, with most = patch/sqrt(2) frame.max_slope, for points on the map's axis: there the plane's
   slope against the map is tan(alpha). For other points ssgi_shadow computes that slope. */
SSGI_DEF float ssgi_shadow_bias(float patch, float cosine, float most, int kind);

/* Guesses a radius to begin with: "for a closed polygonal model .. the average distance between two local maxima in the
   geometry" [SSDO09 section 7.2]. A vertex is a maximum if no edge leads up from it and one leads down; a level part of
   the mesh counts once, at its vertex of least x (then y, z). *radius is the mean distance from a maximum to the
   nearest other, over 1024 maxima at most, evenly chosen. With fewer than two maxima (a sphere, a plane) it is a tenth
   of the diagonal of the bounds.
     radius          [units: the mesh's] above 0
     maxima          how many were found; may be NULL
     position, stride_bytes, index, triangles   as in ssgi_trace_build [limit: 1..2^28 triangles]. Vertices at one place
                     are one. Triangles with a coordinate that is not finite or beyond +-1e12 are left out; if no other
                     triangle remains, or all lie in one point, the result is SSGI_BAD_ARGUMENT for position
     up              heights are along it [limit: finite, not 0]; NULL: they are distances from the middle of the bounds
     work            [limit: words >= 9 * triangles, else SSGI_TOO_SMALL] not needed later
   Heights that differ by less than 1e-6 of the diagonal are equal. O(n log n). */
SSGI_DEF ssgi_result ssgi_radius_guess(float *radius, size_t *maxima, const float *position, size_t stride_bytes,
                                       const uint32_t *index, size_t triangles, const float *up, uint32_t *work,
                                       size_t words, const char **why);

/* ==== >>kernel ================================================================================================= */

/* >>kernel in use (compiled and run by tests/library/test_build.c)

      float set[4 * 16], tile[4 * 4 * 4], up = 0.0f;                   // 16 samples; a tile of 4x4 texels of noise
      if (ssgi_kernel(set, 1, 16, &why) != SSGI_OK || ssgi_noise_tile(tile, 4, 16, 16, &why) != SSGI_OK) puts(why);
      for (int i = 0; i < 16; ++i) up += set[4 * i + 2] / 16.0f;       // directions about +z; [4 * i + 3] is a length
      printf("mean height %g, first turn %g\n", up, tile[3]);           // 2/3, since the cosine is in the density   */

/* Returns the radical inverse of i (van der Corput): i's digits in the base, reflected about the radix point. It is in
   [0,1), and 0 for a base below 2. Halton points have the inverses in bases 2, 3 .. as coordinates; Hammersley points
   have i/n and the inverse in base 2. */
SSGI_DEF float ssgi_radical_inverse(uint32_t base, uint32_t i);

/* Writes the i-th point of the R2 sequence in [0,1)^2, which steps by powers of the plastic number. The points are
   evenly spread after any count, so that the count need not be known. */
SSGI_DEF void ssgi_r2(float out[2], uint32_t i);

/* Makes sample sets: out[4 * (set * samples + i)] = x, y, z, length.
     sets       [limit: 1..4096] independent sets, to be interleaved over pixels
     samples    [limit: 1..4096] of each
     xyz        unit directions on the hemisphere about +z, density cos/pi, so that every sample counts 1/n;
                low-discrepancy in each set, the sets rotated against each other
     length     in (0,1], one in each of n equal strata, decorrelated from the direction: the sample stands at
                length * radius. Uniform lengths make point sampling converge to linear attenuation, 1 - t/radius
   [SSDO09 section 3; sets that integrate an unoccluded constant exactly: see examples/docs/PAPERS.md] */
SSGI_DEF ssgi_result ssgi_kernel(float *out, int sets, int samples, const char **why);

/* How directions are spread. The heights of a set's directions (for COSINE the squares of the heights) are the middles
   of equal strata, so that their sum over a set is exact. */
enum {
    SSGI_DIRECTIONS_COSINE = 0, /* the hemisphere about +z, density cos/pi, as in ssgi_kernel. Each counts 1/n */
    SSGI_DIRECTIONS_UNIFORM,    /* the hemisphere, evenly, as published [SSDO09 section 3, S3HO12 2.1]: each sample
                                   stands for 2 pi/n steradians, and with the cosine it counts 2 z/n; the sum of 2 z/n
                                   is 1 */
    SSGI_DIRECTIONS_SPHERE,     /* the whole sphere, evenly: each sample stands for 4 pi/n; the sum of z is 0 */
};

/* Makes sample sets as ssgi_kernel does, with directions of a kind [limit: SSGI_DIRECTIONS_COSINE ..]; the lengths are
   the same. desc.gather.kernel_texture of ssgi_gl.h takes COSINE, or UNIFORM with desc.gather.uniform_directions. */
SSGI_DEF ssgi_result ssgi_directions(float *out, int kind, int sets, int samples, const char **why);

/* Makes a tile of noise, to be repeated over the picture: out[4 * (y * size + x)] = cos a, sin a, b, turn. With
   desc.gather.noise NOISE_TEXTURE, passes of ssgi_gl.h read z and w of it, as RGBA32F or, up to 1024 sets, as RGBA16F;
   x and y are for shaders that turn their own directions, as the paper's does.
     size         [limit: 1..64] texels of a side
     sets         [limit: 1.., a divisor of size * size] each set has equally many texels, with turn = (set + 0.5)/sets.
                  With desc.gather.kernel_texture the turn chooses a row of the texture; other passes turn their
                  directions by it. With size * size sets there are as many turns as texels. Every window of w x h
                  texels, w h = sets, w and h as equal as size allows, has every set once: a filter of that width sums
                  over all sets. Size 4 with 16 sets gives the 4 x 4 sets of [SSDO09, S3HO12]. Neighbours have unlike
                  turns; copies of a set lie as far apart as such windows let them
     directions   [limit: 1..1024] N_d of [HSAO08 4.1.2]: a = 2 pi turn/directions, in [0, 2 pi/directions)
   b, in [-0.5, 0.5], moves the samples, in units of their spacing. Its values are the middles of size * size strata,
   once each, decorrelated from the turn. (The paper's range (-1,1) is twice the spacing, which gains nothing.) The same
   input gives the same tile. */
SSGI_DEF ssgi_result ssgi_noise_tile(float *out, int size, int sets, int directions, const char **why);

/* ==== >>sh ===================================================================================================== */

/* >>sh in use (compiled and run by tests/library/test_build.c)

      float image[3 * 64 * 32], light[3 * 9], basis[9], normal[3] = { 0, 0, 1 }, irradiance = 0.0f;
      for (int i = 0; i < 3 * 64 * 32; ++i) image[i] = 1.0f;           // an environment that is white all around
      if (ssgi_sh_project_equirect(light, 3, image, 64, 32, &why) != SSGI_OK) puts(why);
      ssgi_sh_basis(basis, 3, normal);
      for (int l = 0; l < 3; ++l)                                      // red light that falls on a surface facing +z
         for (int i = l * l; i < (l + 1) * (l + 1); ++i) irradiance += ssgi_sh_cosine(l) * basis[i] * light[3 * i];
      printf("irradiance %g\n", irradiance);                           // pi; 3.1408, since texels have a size   */

/* Real, orthonormal spherical harmonics: function m = -l..l of band l has the index l*l + l + m. They have no
   Condon-Shortley sign: band 1 is +y, +z, +x times 0.4886. GLSL twins of basis, zonal and rotate: ssgi_gl_sh in
   ssgi_gl.h. */
#define SSGI_SH_MAX_BANDS 6

/* Writes the basis at a unit direction: bands^2 values [limit: bands 0..SSGI_SH_MAX_BANDS, a larger number counts as
   SSGI_SH_MAX_BANDS]. */
SSGI_DEF void ssgi_sh_basis(float *out, int bands, const float direction[3]);

/* Returns the factor of band l from radiance to irradiance [RAM01]: pi, 2 pi/3, pi/4, 0, -pi/24, 0; 0 if l is not in
   0..5. */
SSGI_DEF float ssgi_sh_cosine(int l);

/* Projects radiance onto the basis: out[3*i + c], 3 * bands^2 floats. Values that are not finite count as 0.
     bands          [limit: 1..SSGI_SH_MAX_BANDS]
     width, height  [limit: 1..65536]
     faces          six faces of GL's cube map, in its order and orientation (+x -x +y -y +z -z), each size^2 rgb
                    [limit: 1..65536] */
SSGI_DEF ssgi_result ssgi_sh_project_equirect(float *out, int bands, const float *rgb, int width, int height,
                                              const char **why);
SSGI_DEF ssgi_result ssgi_sh_project_cube(float *out, int bands, const float *const faces[6], int size,
                                          const char **why);

/* Windows are factors of the bands that reduce the ringing of a narrow light. Beside each are three numbers for a sun
   in 4 bands that gives a facing surface irradiance 1: the radiance at the peak of the series; the least irradiance
   over all normals; how far below 0 occlusion can take the irradiance. */
enum {
    SSGI_SH_WINDOW_NONE = 0, /* 1.20, -0.037, 0.20    the factors are 1: sharpest, rings most */
    SSGI_SH_WINDOW_HANN,     /* 0.68, -0.027, 0.035   (1 + cos(pi l / bands)) / 2 [SLO08, S3HO12] */
    SSGI_SH_WINDOW_POSITIVE, /* 0.52,  0.020, 0       the bands of ((1 + cos)/2)^(bands-1): nowhere below 0, widest */
};

/* Writes the factors of a window: `bands` floats, of which the first is 1
   [limit: bands as ssgi_sh_basis; a window out of range is NONE]. */
SSGI_DEF void ssgi_sh_window(float *out, int bands, int window);

/* Turns a function about +z to a unit direction. zonal[l] is its coefficient at l*l + l; its other coefficients are 0.
     out[i] = sqrt(4 pi/(2l+1)) zonal[l] Y_i(direction), bands^2 floats [limit: bands as ssgi_sh_basis]
   With zonal[l] = ssgi_sh_cosine(l) sqrt((2l+1)/(4 pi)) the function is the clamped cosine about a normal: the transfer
   of an unoccluded point. */
SSGI_DEF void ssgi_sh_zonal(float *out, int bands, const float *zonal, const float direction[3]);

/* Rotates a function by the rotation R of world_to_view [limit: rigid; NULL: none]: its value along w moves to R w.
     coefficients, out  channels * bands^2, [channels * i + c]; out may be coefficients
     bands, channels    [limit: bands as ssgi_sh_basis; channels below 1: it does nothing]; 4 bands take about 20 us */
SSGI_DEF void ssgi_sh_rotate(float *out, int bands, const float *coefficients, int channels,
                             const float *world_to_view);

/* Writes the energy of each band, bands floats: out[l] is the sum of squares of the band's coefficients, [channels * i
   + c], over m and channels. A coefficient that is not finite makes its band's energy not finite.
     bands, channels    [limit: bands as ssgi_sh_basis; channels below 1 give zeros] */
SSGI_DEF void ssgi_sh_energy(float *out, int bands, const float *coefficients, int channels);

/* ADDS a light to radiance, [3*i + c], as windowed zonal harmonics [SLO08, S3HO12]:
     coefficient i += irradiance k w_l f_l Y_i(direction)
   w_l is the window; k makes an unoccluded surface that faces the light receive exactly `irradiance`, whichever bands
   and window are chosen (without k it would receive 1.06 of it with 4 bands, 0.83 with Hann's window). With one band
   all surfaces receive the same irradiance, whatever their normal: k is 1, and each receives the mean over all normals,
   a quarter.
     bands       [limit: 1..SSGI_SH_MAX_BANDS]
     direction   to the light [limit: finite, not 0], of any length
     sine        [limit: 0..1] of the angular radius. 0: a directional light, f_l = 1. Above 0: a sphere of uniform
                 radiance; the sine is its radius over the distance of its centre, and f_l is the mean of the Legendre
                 polynomial l over its cap
     irradiance  of a surface that faces the light [limit: finite; clamped to +-1e24]; negative values subtract light
     window      SSGI_SH_WINDOW_NONE ..
   Series of few bands are below 0 somewhere (see the windows): sum all lights, then clamp irradiance at 0. A hemisphere
   light, radiance a above and b below, adds sqrt(pi) (a + b) to coefficient 0 and pi (a - b) Y_i(up) to i = 1..3. */
SSGI_DEF ssgi_result ssgi_sh_light(float *coefficients, int bands, const float direction[3], float sine,
                                   const float irradiance[3], int window, const char **why);

/* ==== >>environment ============================================================================================ */

/* ssgi_octahedral_encode writes the point of the square [-1,1]^2 at which the octahedral map about +z has a direction
   of any length but 0, which counts as +z. ssgi_octahedral_decode writes the unit direction of such a point: n =
   vec3(e, 1 - |e.x| - |e.y|); t = max(-n.z, 0); n.xy += n.xy >= 0 ? -t : t; normalize(n). */
SSGI_DEF void ssgi_octahedral_encode(float out[2], const float direction[3]);
SSGI_DEF void ssgi_octahedral_decode(float out[3], const float e[2]);

/* Averages an environment over a lobe about every direction, as an octahedral map: out[3 * (y * size + x) + c] is at e
   = (x + 0.5, y + 0.5) / size * 2 - 1.
     size           [limit: 8..256]
     width, height  [limit: 1..65536] of rgb; values that are negative or not finite count as 0
     solid_angle    [units: sr] [limit: 0, or above] 0: irradiance over pi (the clamped cosine). Above 0: the average
                    over a von Mises-Fisher lobe with kappa = 4 pi / solid_angle, whose width (1 / the integral of its
                    squared density) is nearly solid_angle (exactly: tanh(kappa) times solid_angle). Values between 0
                    and 0.05 count as 0.05.
   A constant environment is kept exactly. The image is first averaged to 96 x 48 cells, which widens a lobe by up to
   0.005 sr. (For a sky of 1 to 4 with a disc of 200, 6 degrees in radius, the result is within 0.6 % of the exact
   average.) An image of 2048 x 1024 at size 64 takes 0.25 s at most at -O2 on one core, and the time grows with size^2.
   The function takes 60 KB of stack. */
SSGI_DEF ssgi_result ssgi_environment_map(float *out, int size, const float *rgb, int width, int height,
                                          float solid_angle, const char **why);

/* Makes an octahedral map as ssgi_environment_map does, but over cones: it holds the mean radiance within the cone
   about every direction, weighted by the cosine to the cone's axis. A bent cone's light [SSBN11] is then one look-up in
   a texture array, whose slice k of n holds the cones of cosine k/n.
     cosine   [limit: 0..0.95] of the cone's half-angle. 0: irradiance over pi
   At the rim the weight is a ramp that reaches one cell of the averaged image, 3.75 degrees, to either side. Below
   cosine 0.07 the ramp is narrower, so that it ends before 90 degrees. */
SSGI_DEF ssgi_result ssgi_environment_cone(float *out, int size, const float *rgb, int width, int height, float cosine,
                                           const char **why);

typedef struct ssgi_sun {
    float direction[3];  /* unit, to the light */
    float irradiance[3]; /* of a surface that faces the sun */
} ssgi_sun;

/* Replaces an environment by directional lights [SSDO09 section 5] by median cut [DEB05]: the region of most luminance
   is halved, along its wider side, until there are `count` regions. A sun lies at its region's centre of luminance and
   carries all of its light: irradiances sum to the integral of radiance over the sphere.
     count          [limit: 1..1024] any, not only powers of two; suns beyond the number of texels are dark, at +y
     width, height  [limit: 1..65536] of rgb; values that are negative or not finite count as 0
   Reads the image about log2(count) times. Takes 30 KB of stack. */
SSGI_DEF ssgi_result ssgi_environment_suns(ssgi_sun *out, int count, const float *rgb, int width, int height,
                                           const char **why);

/* Adds the residual of unoccluded irradiance, the part of it that a few bands lack, to a map. Dimmed by ambient
   visibility and added to the light from the coefficients, the residual makes unoccluded surfaces exact.
     map                 +=  (irradiance of the suns - irradiance reconstructed from the coefficients) / pi. On entry it
                         holds the environment's map: ssgi_environment_map, solid_angle 0; zeros without an environment
     size                [limit: 8..256] of the map
     coefficients        [3*i + c], of environment and suns together
     bands               [limit: 1..SSGI_SH_MAX_BANDS]
     suns                [limit: count 0 or more; may be NULL when 0] */
SSGI_DEF ssgi_result ssgi_sh_residual(float *map, int size, const float *coefficients, int bands, const ssgi_sun *suns,
                                      int count, const char **why);

typedef struct ssgi_vpl {
    float position[3], normal[3];
    float intensity[3]; /* radiant intensity along the normal; in other directions, times the cosine of their angle to
                           the normal */
} ssgi_vpl;

/* Makes virtual point lights [KEL97] of a reflective shadow map. Pixels of the map are chosen in proportion to the
   luminance of their flux, stratified along the map. Each light keeps its pixel's colour and sends an equal share of
   luminance: the luminances of the lights' fluxes, pi * intensity, sum to the map's. A map without flux gives
   SSGI_BAD_ARGUMENT.
     count                    [limit: 1..4096] lights, exactly; a pixel may be chosen more than once
     position, normal, flux   x y z or r g b of pixel k at [3*k]. flux is the power that the pixel's surface reflects;
                              values that are negative or not finite count as 0
     pixels                   [limit: > 0] number of pixels of the map */
SSGI_DEF ssgi_result ssgi_vpl_choose(ssgi_vpl *out, int count, const float *position, const float *normal,
                                     const float *flux, size_t pixels, const char **why);

/* Replaces an area light by virtual point lights [SSDO09 section 5] at places spread evenly over it. Their intensities
   sum to radiance times area.
     count           [limit: 1..4096] point lights; nearer to the area light than sqrt(area/count) single lights become
                     visible: clamp the distance there (ssgi_gl_light.min_distance)
     corner          of a parallelogram with sides a and b, or of a triangle, which is half of that
     a, b            it shines to the side of a x b [limit: area 1e-30..1e13, finite, all within 1e30 of the origin]
     triangle        0 or 1
     radiance        [limit: 0 or above, finite; clamped to 1e24] that leaves the light */
SSGI_DEF ssgi_result ssgi_vpl_area(ssgi_vpl *out, int count, const float corner[3], const float a[3], const float b[3],
                                   int triangle, const float radiance[3], const char **why);

/* ==== >>trace ================================================================================================== */

/* Traces rays against triangles, for the nearest hit or for any hit, to bake fields and to ray-trace references. Build
   once, then trace from any number of threads. Triangles are two-sided; rays do not pass between triangles that share
   an edge, whether or not a compiler fuses multiply and add, nor with -ffast-math.

      size_t      size = ssgi_trace_size(triangles);
      void       *memory = malloc(size);
      ssgi_trace  trace;
      const char *why;
      if (ssgi_trace_build(&trace, memory, size, position, 12, NULL, triangles, &why) != SSGI_OK) puts(why);
      if (ssgi_trace_any(&trace, origin, direction, 0.0f, 1.0f)) puts("something is in between");      */

typedef struct ssgi_trace {
    const void *nodes, *blocks;  /* in the memory given to ssgi_trace_build */
    uint32_t node_count;         /* 0: nothing can be hit */
    uint32_t block_count;        /* blocks of four triangles each */
    uint32_t triangles, skipped; /* the number given; how many of them were left out, as degenerate or out of range */
} ssgi_trace;

typedef struct ssgi_hit {
    float t;    /* origin + t * direction is the point hit */
    float u, v; /* weights of the triangle's second and third corner, in [0,1] */
    uint32_t triangle;
} ssgi_hit;

#define SSGI_TRACE_MAX_TRIANGLES 0x3fffffffu

/* Returns the bytes that ssgi_trace_build needs, about 72 a triangle; 0 for no triangles, for more than
   SSGI_TRACE_MAX_TRIANGLES and for more than size_t can count. */
SSGI_DEF size_t ssgi_trace_size(size_t triangles);

/* Builds the BVH over triangles with corners index[3*i], index[3*i+1], index[3*i+2]; index NULL: 3*i, 3*i+1, 3*i+2.
   position      x y z of vertex k at (const char *)position + k * stride_bytes
   stride_bytes  [limit: 12 or more, a multiple of 4]
   memory        size >= ssgi_trace_size(triangles) bytes of any alignment (else SSGI_TOO_SMALL); the trace points into
                 the memory: keep it where it is. position and index are not needed afterwards.
   Triangles without area, and those with a coordinate that is not finite or beyond +-1e12, are never hit; those smaller
   than about 1e-18 may be missed. Indices are not checked. Building takes O(n log n) time, except for contrived input.
   It allocates nothing and recurses at most 62 deep, whatever the input. */
SSGI_DEF ssgi_result ssgi_trace_build(ssgi_trace *trace, void *memory, size_t size, const float *position,
                                      size_t stride_bytes, const uint32_t *index, size_t triangles, const char **why);

/* Finds the hit with the smallest t in tmin < t < tmax. Returns 1 with *hit filled, or 0 with *hit untouched. The
   direction may have any length, which is the unit of t. tmin and tmax count as 0 if they are below 0 or NaN; tmax may
   be infinite. A ray that is not finite, beyond 1e12, or without direction hits nothing. */
SSGI_DEF int ssgi_trace_closest(ssgi_hit *hit, const ssgi_trace *trace, const float origin[3], const float direction[3],
                                float tmin, float tmax);

/* Returns 1 if there is any hit in tmin < t < tmax, else 0. It stops at the first hit that it finds. */
SSGI_DEF int ssgi_trace_any(const ssgi_trace *trace, const float origin[3], const float direction[3], float tmin,
                            float tmax);

/* Traces the ambient visibility of points by cosine-weighted rays: for instance the self-occlusion of a rigid object,
   as an attribute of its vertices [AOF05 section 1].
     out                `count` values, in [0,1]
     position, normal   x y z of point k at [3*k]; normals of any length
     radius             [units: the mesh's] [limit: above 0; with hard also 0: unlimited] hits beyond the radius do not
                        count
     rays               [limit: 1..65536] a point
     hard               [limit: 0 or 1] 0: a hit at the distance t occludes by 1 - t/radius; 1: fully
   Rays begin off the surface, lifted along the normal by 4e-6 of the largest coordinate in the trace. Lift positions
   yourself if vertex normals differ much from the normals of the faces, since neighbouring faces then occlude. A point
   without a normal, or one that is not finite, counts as visible. The value depends on the trace, the point and the
   normal alone, so that copies of a vertex agree, and each thread may take a part of the points. RMS errors with 256
   and with 1024 rays: beside a wall 0.0006 and 0.00015, with hard 0.005 and 0.002; in a groove with hard 0.007 and
   0.003. */
SSGI_DEF ssgi_result ssgi_trace_visibility(float *out, const ssgi_trace *trace, const float *position,
                                           const float *normal, size_t count, float radius, int rays, int hard,
                                           const char **why);

/* ==== >>tessellate ============================================================================================= */

/* >>tessellate in use (compiled and run by tests/library/test_build.c)

      double area = 2.0;                                               // of a triangle, to be tiled by discs
      int level = ssgi_tess_level(area, 0.1), points = ssgi_tess_count(level);  // 0.1: the discs' radius
      float *uvw = (float *)malloc(sizeof *uvw * 3 * (size_t)points);  // their places in it
      if (ssgi_tess_points(uvw, level, &why) != SSGI_OK) puts(why);
      printf("level %d: %d discs of radius %g\n", level, points, ssgi_tess_radius(area, points));   */

/* Returns the number of points that tessellation hardware generates in a triangle whose levels are all `level`, with
   equal spacing, in point mode [DSS14 section 3.1]: (3/4) i^2 + (3/2) i + 1 at an even level i, 3 ceil(i/2)^2 at an odd
   one: 3, 7, 12, 19 .. 3169. It is 0 for a level outside 1..64. GLSL twin: ssgi_tess_count. */
SSGI_DEF int ssgi_tess_count(int level);

/* Writes the points of a level as gl_TessCoord has them, except for the rounding of GPUs (2e-5). Their order is the
   library's own: in rings from the edges inwards, each ring from a corner around.
     uvw      barycentric coordinates, 3 a point; they sum to 1 [limit: 3 * ssgi_tess_count(level) floats]
     level    [limit: 1..64] */
SSGI_DEF ssgi_result ssgi_tess_points(float *uvw, int level, const char **why);

/* Returns the least level, 1..64, that has a point for each of K discs, where K = area / (pi radius^2) discs of this
   radius together have the triangle's area: ceil(sqrt((4 K - 1) / 3) - 1) [DSS14 section 3.1]. It is 1 for 3 discs or
   fewer, for which the formula has no level, and 64 for more than 3169 discs, which need the triangle split
   (ssgi_surfel_desc.splits). The formula is that of even levels. An odd level has a quarter of a point less than the
   formula says: level 1 is taken for up to 3.25 discs, and 12.1 discs get 12 points.
     area     [units: view^2] 0 or below: level 1
     radius   [units: view] 0 or below: level 64
   It is 1 if either is not a finite float. GLSL twin: ssgi_tess_level, which takes the number of discs. */
SSGI_DEF int ssgi_tess_level(double area, double radius);

/* Returns the radius at which `count` discs together have the triangle's area: sqrt(area / (pi count)) [DSS14 section
   3.1]. It is 0 if area or count is not above 0 or not a finite float.
     count    ssgi_tess_count of the level, or this number times the share of the triangle's points that stay */
SSGI_DEF double ssgi_tess_radius(double area, double count);

/* ==== >>surfels ================================================================================================ */

/* In deep screen space [DSS14] triangles become discs of about equal size on the screen: also triangles that are
   hidden, at grazing angles, off screen or behind the eye. Pass surfels of ssgi_gl.h makes the same surfels on the GPU;
   pass dss takes surfels of either. */

/* A surfel: three vec4 attributes of one instance, byte for byte, as transform feedback captures them. */
typedef struct ssgi_surfel {
    float position[3], radius; /* view space */
    float normal[3], seed;     /* unit; seed, in [0,1), chooses its sub-buffers: on level l the lowest l bits of seed *
                                  2^24 choose the column, and the l bits above the lowest 8 choose the row */
    float colour[3], unused;   /* the source's colour; after lighting the radiance that leaves it (for a bounce) or the
                                  irradiance that it receives (for scattering). Occlusion does not read it */
} ssgi_surfel;

/* ssgi_surfel_desc.overhang: how a triangle shrinks before surfels are placed in it, so that discs of radius r keep off
   its edges. */
typedef enum ssgi_overhang {
    SSGI_OVERHANG_INCENTRE = 0, /* scaled about the centre of the inscribed circle by 1 - r / the circle's radius, at
                                   least 1/4: discs end at the edges if they fit into the triangle */
    SSGI_OVERHANG_CENTROID,     /* as published, corners move by r toward the centroid, which leaves half of the
                                   overhang; they move 0.9 of the way at most, or slivers would turn over [DSS14 3.1] */
    SSGI_OVERHANG_FORCE = SSGI_FORCE
} ssgi_overhang;

/* How ssgi_surfels makes surfels of triangles. A member of 0 has its default. */
typedef struct ssgi_surfel_desc {
    /* [units: image heights] [limit: 0 or 1e-4..1] [default: 0.03] diameter of a surfel that faces the viewer: s in
       [DSS14] */
    float size;
    /* [limit: 0..32] [default: 8] the most parts into which an edge is split if the tessellator's last level, 64, is
       too coarse for the triangle */
    int splits;
    /* [units: radius per distance] [limit: 0..1] [default: 0.1] radius added per distance outside the frustum, since no
       visible pixel is close there; 1e-6 adds practically nothing, as published */
    float offscreen_growth;
    /* [limit: 0..1] 0: a triangle smaller than its three surfels keeps each with probability area / (3 pi r^2), at an
       unchanged radius, so that cost does not grow with mesh detail. 1: it keeps all, as published */
    int keep_small;
    /* [units: view] [limit: >= 0] [default: unlimited] triangles farther outside the frustum than this give no surfels;
       for instance the radius of occlusion */
    float max_distance;
    ssgi_overhang overhang;
} ssgi_surfel_desc;

/* The triangles that become surfels. */
typedef struct ssgi_surfel_source {
    const float *position;                                /* x y z of each vertex */
    const float *normal;                                  /* of each vertex, any length; NULL: the triangle's own */
    const float *colour;                                  /* of each vertex, for ssgi_surfel.colour; NULL: 1 1 1 */
    size_t position_stride, normal_stride, colour_stride; /* [units: bytes] [limit: multiples of 4] 0: three floats,
                                                             without a gap */
    const uint32_t *index;                                /* three vertices for each triangle; NULL: the vertices in
                                                             their order */
    size_t triangles;
    float to_view[16]; /* [limit: finite, invertible] mesh to view space */
} ssgi_surfel_source;

/* Returns the radius of a surfel at a view depth [DSS14 section 3.1]: size tan(alpha/2) (|depth - near| + near), where
   alpha is the vertical angle of view. It is half of `size` image heights on the screen; behind the near plane surfels
   grow again. With an orthographic projection it is half of `size` image heights everywhere. It is 0 if size is not
   above 0, and for arguments that are not finite floats.
     size     [units: image heights] s: ssgi_surfel_desc.size; here 0 does not stand for its default, 0.03
     depth    [units: view] of the triangle's centroid; below 0 behind the eye
   GLSL twin: ssgi_surfel_radius. */
SSGI_DEF double ssgi_surfel_radius(const ssgi_view *view, double size, double depth);

/* Returns the form factor of a disc, to be multiplied by the cosines at both ends: r^2 / (d^2 + r^2) [DSS14 section 4;
   Wallace, Elmquist, Haines 1989]. It is exact on the disc's axis, and too low beside the axis when near: on a parallel
   receiver it is 0.93 .50 .07 of the exact form factor at 15, 45 and 75 degrees from one radius away, .97 .73 .49 from
   two, .99 .91 .84 from four. It is 0 if radius is not above 0, and for arguments that are not finite floats.
     radius, distance   [units: view] the distance is that to the disc's centre */
SSGI_DEF double ssgi_surfel_form_factor(double radius, double distance);

/* Returns the distance at which the contribution of a surfel has fallen to epsilon: radius sqrt(brightest / epsilon -
   1), linear in the radius. It is the paper's getMaxDist [DSS14 sections 3.2, 4]. It is 0 if radius or brightest is not
   above 0, if brightest is epsilon or less, and for arguments that are not finite floats; else it is SSGI_FAR if
   epsilon is 0 or below.
     brightest   the largest component of the radiance that the surfel sends; 1 for occlusion
     epsilon     the contribution at which level 0 of the surfel ends: ssgi_gl_frame.epsilon */
SSGI_DEF double ssgi_surfel_reach(double radius, double brightest, double epsilon);

/* Writes the range of distances d that a level is drawn for, shell[0] < d <= shell[1] [DSS14 section 3.2]. Level 0 is
   for distances up to reach, level l > 0 for those from reach * 2^(l-1) to reach * 2^l. Each distance up to the last
   level's end is in one shell (d = 0 in that of level 0). Both ends are `most` if the level lies beyond `most`, and 0
   if a length is not above 0 or not a finite float.
     reach    [units: view] ssgi_surfel_reach
     level    below 0 as 0, above 64 as 64
     most     [units: view] ssgi_splat.max_distance; SSGI_FAR: unlimited */
SSGI_DEF void ssgi_surfel_shell(double shell[2], double reach, int level, double most);

/* Writes the numbers of ssgi_gl_frame.surfel, with defaults in place: radius per view depth (orthographic: radius),
   view depth of the near plane, offscreen_growth, splits. */
SSGI_DEF ssgi_result ssgi_surfel_scale(float scale[4], const ssgi_surfel_desc *desc, const ssgi_view *view,
                                       const char **why);

/* Subdivides triangles that need more than desc->splits parts an edge, such as a ground that reaches the horizon, into
   four, recursively, at most ten times. Drops triangles farther outside the frustum than desc->max_distance, without
   area, or with corners that are not finite or beyond SSGI_FAR. The others stay unchanged, in their order.
     out      27 floats a triangle: position, normal, colour of each corner in mesh space (normal 0 0 0 or colour 1 1 1
              if the source has none; a component that is not finite becomes 0). They serve as the source of
              ssgi_surfels, and as vertices of the patches that desc.surfel.tessellate draws
     count    how many triangles result; at most `capacity` of them are written */
SSGI_DEF ssgi_result ssgi_surfels_divide(float *out, size_t capacity, size_t *count, const ssgi_surfel_desc *desc,
                                         const ssgi_view *view, const ssgi_surfel_source *source, const char **why);

/* Makes surfels of triangles; their areas sum to the triangle's (on average, if small triangles are thinned: keep_small
   0). Writes at most `capacity` surfels, and to *count their number (to query it, give out NULL and capacity 0).
   Triangles without area, with corners that are not finite or beyond SSGI_FAR, or too small for a radius above 0 give
   no surfels; normals, and components of a colour, that are not finite count as 0. A surfel's seed depends only on the
   vertex indices of its triangle and on its place in the triangle. */
SSGI_DEF ssgi_result ssgi_surfels(ssgi_surfel *out, size_t capacity, size_t *count, const ssgi_surfel_desc *desc,
                                  const ssgi_view *view, const ssgi_surfel_source *source, const char **why);

/* How pass dss splats surfels. The shaders take epsilon, max_distance (as radius) and near_depth from ssgi_gl_frame. */
typedef struct ssgi_splat {
    float epsilon;      /* [limit: 0 or 1e-6..1] [default: 0.3] form factor of a surfel at the distance at which its
                           level 0 ends */
    float max_distance; /* [units: view] [limit: >= 0] [default: unlimited] the occlusion radius */
    float max_radiance; /* [limit: >= 0] [default: 1] for predictions: the largest radiance of a surfel /
                           ssgi_gl_frame.sent */
    float near_depth;   /* [units: view] [limit: >= 0] [default: the near plane] least view depth of the frame's
                           surfaces */
    int levels; /* [limit: 0..SSGI_SPLAT_LEVELS] [default: 4] every level doubles the reach, at about equal cost */
    int part;   /* [limit: 0, 1, 2 or 4] [default: 1] of each axis 1 pixel in `part` is drawn: desc.gather.resolution */
    int two_sided; /* 1: surfels affect pixels behind them, too: desc.light.two_sided, effects SCATTER and CUSTOM */
} ssgi_splat;

enum { SSGI_SPLAT_LEVELS = 7 };

/* Writes the size [units: texels] of one level in the interleaved layout: the size of the interleaved picture, rounded
   up to multiples of 2^(levels - 1). The levels lie below each other in one texture of size[0] x (levels * size[1])
   texels.
     width, height   [limit: 1..65536] of that picture: the frame, or fewer pixels with desc.gather.resolution
     levels          [limit: 1..7] */
SSGI_DEF ssgi_result ssgi_splat_size(int size[2], int width, int height, int levels, const char **why);

/* Returns the least number of levels, 1..SSGI_SPLAT_LEVELS, whose last one ends at the occlusion radius or beyond. It
   is SSGI_SPLAT_LEVELS if none does, and for arguments that are not finite floats. Fewer levels lose far occluders;
   each further level costs as much as those before and finds no occluder.
     size       [units: image heights] [limit: > 0] ssgi_surfel_desc.size
     epsilon    [limit: > 0] ssgi_splat.epsilon
     radius     [units: image heights] the radius as it is seen (ssgi_plan_scene.screen_radius); half of it suffices if
                occlusion fades toward the radius: the level that is saved changes the relative error by less than 0.003
                in the mean of 21 scenes by seed, with one, two and four times their radius, and by 0.047 on the worst
                scene */
SSGI_DEF int ssgi_splat_levels(double size, double epsilon, double radius);

/* The predicted cost of the surfels of a frame. */
typedef struct ssgi_surfel_cost {
    size_t surfels;                   /* number of surfels */
    int splits;                       /* the most parts into which an edge has to be split; may exceed desc->splits */
    double pixels[SSGI_SPLAT_LEVELS]; /* texels that the splats of each level cover, each overlap counted */
} ssgi_surfel_cost;

/* Predicts the cost of a frame's surfels. Surfels are counted exactly; pixels are those of one surfel at the centre of
   each part of a triangle, times the number of surfels of the part (in tests within 1.4 % of the sum over all surfels).
   desc, view and source are as for ssgi_surfels; zeros in splat are the defaults. */
SSGI_DEF ssgi_result ssgi_surfels_predict(ssgi_surfel_cost *cost, const ssgi_surfel_desc *desc, const ssgi_splat *splat,
                                          const ssgi_view *view, const ssgi_surfel_source *source, const char **why);

/* ==== >>dipole ================================================================================================= */

/* Multiple scattering under a surface by the dipole of [JMLH01, JB02; DSS14 section 4], in three channels. Lengths are
   in the unit of the coefficients that ssgi_dipole_set was given. */
typedef struct ssgi_dipole {
    double z_r[3];      /* depth of the real source below the surface */
    double z_v[3];      /* height of the virtual source above the surface */
    double sigma_tr[3]; /* effective transport coefficient */
    double albedo[3];   /* alpha', the reduced albedo */
} ssgi_dipole;

/* Makes the dipole of a material.
     sigma_s    reduced scattering coefficient [units: 1/length] [limit: > 0]
     sigma_a    absorption coefficient [units: 1/length] [limit: >= 0]
     eta        relative index of refraction [limit: 1..3] */
SSGI_DEF ssgi_result ssgi_dipole_set(ssgi_dipole *dipole, const float sigma_s[3], const float sigma_a[3], float eta,
                                     const char **why);

/* Returns the diffuse reflectance R_d [units: 1/length^2] at a distance [limit: >= 0]; 0 for a channel outside 0..2,
   and for a distance that is not a finite float. */
SSGI_DEF double ssgi_dipole_reflectance(const ssgi_dipole *dipole, int channel, double distance);

/* ==== >>cap ==================================================================================================== */

/* >>cap in use (compiled and run by tests/library/test_build.c)

      double share = ssgi_cap_occlusion(1.0, 0.5);                     // of a cap of 1 sr, 60 degrees off the normal
      float table[32 * 32];                                            // the same for all, to be a texture
      if (ssgi_cap_table(table, 32, &why) != SSGI_OK) puts(why);
      printf("it takes %g of the light\n", share);   */

/* Returns the occlusion of a spherical cap, cosine-weighted: the share of a diffuse surface's light that the cap takes,
   in closed form [AOF05 eq. 3; the paper does not give the formula].
     solid_angle  [units: sr] [limit: 0..4 pi, clamped]
     cosine       of the angle between the cap's axis and the surface's normal [limit: -1..1, clamped]
   Arguments that are not finite count as 0. The result is in [0,1] and monotone in both arguments. Its absolute error
   is 1e-12. GLSL twin: ssgi_cap. */
SSGI_DEF double ssgi_cap_occlusion(double solid_angle, double cosine);

/* Writes the occlusion of spherical caps (ssgi_cap_occlusion) as a look-up table [AOF05 section 4.2], for
   desc.input.cap_table of ssgi_gl.h or for your shaders: out[y * size + x] is the occlusion of solid angle 4 pi x /
   (size - 1) and cosine 2 y / (size - 1) - 1. Values stand at the texels' centres: u = (solid_angle / (4 pi) * (size -
   1) + 0.5) / size, v = ((cosine + 1) / 2 * (size - 1) + 0.5) / size.
     out    size * size floats
     size   [limit: 2..4096] largest error of the bilinear value: 2.9e-3 at 32, 1.4e-3 at 64, 6.6e-4 at 128; 8 bits
            a texel add 2e-3 */
SSGI_DEF ssgi_result ssgi_cap_table(float *out, int size, const char **why);

/* Writes the irradiance from the part of an environment within a cap [AOF05 section 6]: pi times the cap's occlusion,
   times the cosine-weighted mean of the environment's radiance over 256 directions of the cap. With the cap of
   ssgi_field_cap it is the irradiance that an occluder takes away: subtract fill times it from unoccluded irradiance.
   With the rest of the sphere (4 pi - solid_angle, -axis), the inverse cap, it is the irradiance that remains.
     coefficients   [3*i + c] of radiance: ssgi_sh_project_equirect
     bands          [limit: 1..SSGI_SH_MAX_BANDS]
     solid_angle    [units: sr] [limit: finite; clamped to 0..4 pi]
     axis, normal   [limit: finite, not 0] in the coefficients' space, of any length
   It is exact if the light is constant, else within 0.5 %, for inverse caps within 1.5 %, of unoccluded irradiance. */
SSGI_DEF ssgi_result ssgi_cap_light(float out[3], const float *coefficients, int bands, float solid_angle,
                                    const float axis[3], const float normal[3], const char **why);

/* ==== >>reflection ============================================================================================= */

/* >>reflection in use (compiled and run by tests/library/test_build.c)

      float lit = ssgi_interreflected(0.4f, 0.8f);                     // in a white room: brighter than 0.4
      float gloss = ssgi_specular_visibility(0.4f, 0.9f, 0.7f, 0.1f);  // of a lobe near the open directions
      printf("%g of the diffuse light, %g of the specular\n", (double)lit, (double)gloss);   */

/* Returns ambient visibility plus the light that occluders reflect, over all bounces. Occluders are assumed to have the
   surface's albedo and to receive as much light. It is a cubic of visibility, fitted to path-traced scenes [JWPJ16
   section 5]. Multiply the environment's diffuse light by it instead of visibility, each channel with its own albedo.
     visibility, albedo   [limit: 0..1, clamped; values that are not finite count as 0]
   The result is in [visibility, 1]. GLSL twin: ssgi_interreflected of ssgi_gl_reflection, of three channels. */
SSGI_DEF float ssgi_interreflected(float visibility, float albedo);

/* Returns the unoccluded share of a glossy lobe. Ambient visibility gives the mean over all directions, and the bent
   normal, which leans away from occluders, gives the change with direction; wide lobes depend less on it. Both terms
   are linear in roughness, fitted to traced lobes of 14 scenes. On 14 other scenes the RMSE relative to no specular
   occlusion is 0.47, 0.37, 0.27 and 0.25 at roughness 0.05, 0.15, 0.35 and 0.7; with ambient visibility instead it is
   0.66, 0.60, 0.50 and 0.40 (build/reflection). Cones for the lobe and the open directions [JWPJ16 section 6] have
   0.77, 0.67, 0.52 and 0.35 on the scenes of the fit.
     visibility        [limit: 0..1, clamped] ambient visibility
     bent, normal      [limit: -1..1, clamped] cosines of the mirrored view direction to the bent normal and to the
                       normal. Without a bent normal 1 - 1.4 * (1 - visibility) does better than this function
     roughness         [limit: 0..1, clamped] GGX's alpha
   Values that are not finite count as 0. The result is in [0,1], and 1 if visibility is 1 and the bent normal is the
   normal. GLSL twin: ssgi_specular_visibility of ssgi_gl_reflection. */
SSGI_DEF float ssgi_specular_visibility(float visibility, float bent, float normal, float roughness);

/* ==== >>field ================================================================================================== */

/* An ambient occlusion field [AOF05] holds the occlusion of its surroundings by a rigid occluder. It is baked once and
   evaluated at any point, at a cost that does not depend on the number of triangles. For each direction of a cube map
   about the occluder's centre the field stores the spherical cap that the occluder subtends, as a function of the
   distance from the centre, between the convex hull and the field's reach.  */

/* >>field in use (compiled and run by tests/library/test_build.c)

      float triangle[9] = { 0, 0, 0,  1, 0, 0,  0, 1, 0 }, point[3] = { 0.3f, 0.3f, 1 }, normal[3] = { 0, 0, -1 };
      ssgi_field field;
      ssgi_field_desc d;
      memset(&d, 0, sizeof d);                                         // every choice at its default, except:
      d.resolution = 8;                                                // 8 x 8 texels a face
      size_t size = ssgi_field_bake_size(&d, 1);                       // of one triangle
      uint32_t *texels = (uint32_t *)malloc(ssgi_field_size(8));
      void *work = malloc(size);
      if (ssgi_field_bake(&field, texels, work, size, &d, triangle, 12, NULL, 1, &why) != SSGI_OK) puts(why);
      free(work);                                                      // the field needs its texels only
      printf("it occludes %g\n", ssgi_field_occlusion(&field, NULL, point, normal));   */

/* How ssgi_field_bake bakes a field. A member of 0 has its default. */
typedef struct ssgi_field_desc {
    int resolution; /* [limit: 0, 2..128] [default: 16] texels along a side of the cube map's faces */
    int radii;      /* [limit: 0, 4..64] [default: 12] number of distances that are sampled along each direction */
    int rays;       /* [limit: 0, 16..65536] [default: 96] rays traced from a point at the hull. Farther out the
                       occluder takes less of the light: there rays * (distance of the hull / distance of the point) are
                       traced, at least 16 */
    float reach;    /* [units: radii of the bounding sphere] [limit: 0, 1.5..64] [default: 8] where the field ends */
    int unfiltered; /* [limit: 0 or 1] 1: directions are sampled at the resolution itself, without the Gaussian, in a
                       quarter of the time: figure 5 of the paper shows the effect on thin parts */
    /* Your ray caster, which returns 1 if the ray meets the occluder at any t > 0. NULL: the library's, which finds the
       hull in any case. */
    int (*hit)(void *user, const float origin[3], const float direction[3]);
    /* Your samples instead of rays [AOF05 section 4.1], rasterised for instance. For point i, whose x y z are at
       point[3 * i] in the mesh's space, out[4 * i] is the solid angle of the occluder [units: sr] and the next three
       floats are its mean direction, from the point to the occluder. The length of this direction tells how far the
       occluder fills its cap; a length of 1, or more than is possible, means that the cap is filled, as in the paper,
       which has unit directions. If a value is not finite, the point counts as seeing nothing of the occluder. The
       function is called once for each direction, with all distances: desc.radii points from near the hull to the
       reach, ascending. The occlusion inside the hull and the reported errors come from rays in any case. NULL:
       rays. */
    void (*sample)(void *user, float *out, const float *point, int count);
    /* Runs jobs on your threads: it calls job(context, i) for every i in [0, count) and returns when all are done.
       NULL: the jobs run one by one. */
    void (*parallel)(void *user, int count, void (*job)(void *context, int i), void *context);
    /* It is called now and then on the caller's thread, with done in [0,1]. If it returns other than 0 before done is
       1, the bake gives up with SSGI_CANCELLED. */
    int (*progress)(void *user, float done);
    void *user; /* handed to all these functions; hit and sample must be reentrant if parallel has threads */
} ssgi_field_desc;

/* A baked field, in the occluder's own coordinates. ssgi_field_bake or ssgi_field_load makes it; it is read-only for
   you. */
typedef struct ssgi_field {
    /* The cube map, to be uploaded as RG32UI: (resolution + 2) x 6 (resolution + 2) texels, with the faces below each
       other in GL's order, each within a border of one texel from its neighbours. Two words a texel hold eight
       components of 8 bits, lowest first: the base-2 logarithms of the distance function's three coefficients; the
       hull's distance; x y z of the characteristic centre, from `centre`; the covered share of the cap. */
    const uint32_t *texels;
    int resolution; /* texels along a side of a face, without the border */
    int radii;      /* number of distances that were sampled along each direction */

    float centre[3], radius; /* [units: the mesh's] the bounding sphere; the centre lies in the convex hull */
    float reach;             /* [units: the mesh's] distance from the centre at which the field ends */
    float inside;            /* A_0: mean occlusion of points in the hull that the mesh does not enclose */
    float low[8], span[8];   /* ranges of the eight stored components: byte 0 stands for low, byte 255 for low + span */

    /* Errors of occlusion as stored, without the ramp, at receivers that the bake did not sample: directions between
       texels, distances between samples, random normals. */
    float median, p95, max_error;
} ssgi_field;

/* How a field fades out, and occlusion inside the convex hull [AOF05 algorithm 1]. */
typedef struct ssgi_field_limits {
    /* Distances from the centre between which occlusion falls to 0 [units: the mesh's]
       [limit: 0 <= ramp < reach <= field->reach] */
    float ramp, reach;
    /* At a share s of the way from the centre to the hull, occlusion is mix(inside, occlusion at the hull, s^power)
       [limit: 0..1 and > 0] */
    float inside, power;
} ssgi_field_limits;

/* Returns the bytes of a field's texels; 0 for a bad resolution [limit: 2..128]. */
SSGI_DEF size_t ssgi_field_size(int resolution);

/* Returns the bytes of a bake's work memory, which is not needed later: about 72 a triangle + 960 resolution^2; 0 for
   bad arguments. */
SSGI_DEF size_t ssgi_field_bake_size(const ssgi_field_desc *desc, size_t triangles);

/* Bakes a field: samples directions at twice the resolution, by rays or from desc.sample, fits each texel, and reduces
   the map to the field's resolution by a Gaussian [AOF05 section 4.1].
     texels     ssgi_field_size(desc's resolution) bytes, which belong to the field from then on
     work       work_size >= ssgi_field_bake_size(desc, triangles) bytes of any alignment
     position, stride_bytes, index, triangles   as in ssgi_trace_build, which names the triangles that are left out
   The same input gives the same bytes, with any number of threads and at any optimisation that keeps IEEE arithmetic
   (not -ffast-math; with FMA instructions -ffp-contract=off). The bake fails with SSGI_BAD_ARGUMENT, SSGI_TOO_SMALL
   (work_size) or SSGI_CANCELLED; *field is then untouched, but texels and work may be written. Resolution 16 with 96
   rays from the hull traces about 3.5 million rays. To reach an error of your choice bake with resolution 4, 8, 16 ..
   until field->p95 is below it. */
SSGI_DEF ssgi_result ssgi_field_bake(ssgi_field *field, uint32_t *texels, void *work, size_t work_size,
                                     const ssgi_field_desc *desc, const float *position, size_t stride_bytes,
                                     const uint32_t *index, size_t triangles, const char **why);

/* Returns limits to start from: a ramp over the last quarter of the reach, inside as measured, power 1. */
SSGI_DEF ssgi_field_limits ssgi_field_limits_of(const ssgi_field *field);

/* Returns the occlusion of a point by the occluder. It is in [0,1], 0 from the reach on, and 0 if a coordinate is not
   finite. Multiply ambient light by 1 - occlusion, once for each occluder. GLSL twin: ssgi_field_occlusion.
     limits           NULL: ssgi_field_limits_of
     point, normal    in the occluder's coordinates; the normal unit */
SSGI_DEF float ssgi_field_occlusion(const ssgi_field *field, const ssgi_field_limits *limits, const float point[3],
                                    const float normal[3]);

/* Writes the cap that an occluder subtends at a point: its solid angle [units: sr], its unit axis, from the point to
   the occluder, and the share of the cap that is covered. In the hull it is the cap at the hull; beyond the field's
   reach solid_angle and fill are those at the reach. ssgi_cap_light gives the irradiance of an environment that the cap
   takes away. Returns the point's distance from the centre over the hull's. No argument may be NULL; a coordinate that
   is not finite counts as the centre's. */
SSGI_DEF float ssgi_field_cap(float *solid_angle, float axis[3], float *fill, const ssgi_field *field,
                              const float point[3]);

/* Saves a field as the bytes of a file, the same on every machine. Returns the number of bytes, 0 if field is NULL or
   without a valid resolution. Writes them if out is not NULL and capacity is at least that number. */
SSGI_DEF size_t ssgi_field_save(void *out, size_t capacity, const ssgi_field *field);

/* Loads a field from the bytes that ssgi_field_save wrote. With texels NULL and size 0 it fills everything except the
   texels: call it so first, to learn the resolution.
     texels, size   [units: bytes] [limit: ssgi_field_size(field->resolution), else SSGI_TOO_SMALL]
     file           SSGI_BAD_ARGUMENT if it is cut short, too long, foreign, of another version, or corrupt */
SSGI_DEF ssgi_result ssgi_field_load(ssgi_field *field, uint32_t *texels, size_t size, const void *file,
                                     size_t file_size, const char **why);

/* ==== >>plan =================================================================================================== */

/* Chooses the cheapest method and settings whose predicted error meets yours, or the least error within your budget.
   The predictions were fitted to ray-traced ground truth at 1280x720 and tested on other scenes:
   examples/docs/PLANNER.md. A survey improves predictions; a calibration improves them most.  */

/* >>plan in use (compiled and run by tests/library/test_build.c)

      ssgi_plan_scene s;
      memset(&s, 0, sizeof s);                                         // a number left 0 is not known
      s.wanted = SSGI_PLAN_WANTED_VISIBILITY;
      s.thickness = SSGI_PLAN_THICKNESS_SLABS;                         // the best that you can draw
      s.error = 0.03f;
      s.screen_radius = 0.2f;
      ssgi_survey_of(&s.survey, hsao, best, solid, slabs, 3000, NULL);  // pictures of hsao, here 3000 pixels of them
      ssgi_plan_calibrate(&s.calibration, &trace, position, normal, hsao, slabs, fast, 3000, 64, radius, NULL);
      ssgi_plan plan;
      if (ssgi_plan_make(&plan, &s, &why) == SSGI_OK) puts(plan.why);
      ssgi_gl_plan(&desc, &plan, NULL);                                // of ssgi_gl.h: sets a desc   */

enum {
    SSGI_PLAN_WANTED_VISIBILITY = 0, /* ambient visibility within a radius, linear attenuation. Errors: its RMSE */
    SSGI_PLAN_WANTED_LIGHT,          /* irradiance from harmonics, which hold an environment and lights. Errors: RMSE
                                        over its mean */
    SSGI_PLAN_WANTED_BOUNCE,         /* that irradiance and one diffuse bounce within the radius. Errors: RMSE of their
                                        sum over its mean */
    SSGI_PLAN_WANTED_OBJECTS,        /* ambient visibility between rigid objects, at any distance. Errors: its RMSE */
};

/* The values of plan.method. If light is wanted, the visibility of HSAO dims the irradiance of harmonics. */
enum {
    SSGI_PLAN_METHOD_NOTHING = 0,
    SSGI_PLAN_METHOD_HSAO,
    SSGI_PLAN_METHOD_SSDO,
    SSGI_PLAN_METHOD_S3HO,
    SSGI_PLAN_METHOD_DSS,
    SSGI_PLAN_METHOD_AOF
};

/* The values of plan.thickness: desc.gather.thickness of ssgi_gl.h with other numbers; ssgi_gl_plan translates. WIDTH
   is the default of chains: ssgi_gl_steps draws pass thickness, and the costs here include it. */
enum {
    SSGI_PLAN_THICKNESS_WIDTH = 0,
    SSGI_PLAN_THICKNESS_CONSTANT, /* needs no pass thickness; may be chosen whatever plan_scene.thickness is */
    SSGI_PLAN_THICKNESS_BACK,
    SSGI_PLAN_THICKNESS_SLABS
};

/* The values of plan_scene.device: the device whose costs count. */
enum {
    SSGI_PLAN_DEVICE_SOFTWARE = 0, /* llvmpipe's costs, measured */
    SSGI_PLAN_DEVICE_GPU,          /* a GPU's, modelled: a Radeon RX 6800 at 1920x1080, by its compiler's instructions;
                                      never measured */
    SSGI_PLAN_DEVICE_RX_6800       /* the costs of DEVICE_GPU, but cost, budget and depth_pass are in milliseconds at
                                      1920x1080 */
};

/* The values of plan_scene.unit: the unit of plan_scene.error. */
enum {
    SSGI_PLAN_UNIT_RMSE = 0, /* the measure of `wanted` itself */
    SSGI_PLAN_UNIT_RELATIVE  /* that measure over its value for an image without occlusion: 0.4 is 40 %. The planner
                                takes that value from the calibration, else from the survey, else a guess */
};

/* A survey: how pictures of one frame's ambient visibility differ, as RMS over the pixels with a surface. Made by
   ssgi_survey_of, whose arguments the members name. */
typedef struct ssgi_survey {
    float occlusion; /* RMS of 1 - visibility, by slabs if they are drawn; 0: no survey */
    float detail;    /* RMS of best - hsao */
    float solid;     /* RMS of solid - hsao */
    float slabs;     /* RMS of slabs - hsao; 0: not drawn */
} ssgi_survey;

/* Makes a survey from pictures of ambient visibility by pass HSAO with slices, at full resolution, filtered, all of one
   radius; each has count floats. A pixel that is NaN in any of them is left out: set pixels without a surface to NaN
   (the pass writes 1 there).
     hsao, best    presets BALANCED and BEST with the default thickness, which in chains is WIDTH
     solid         preset BALANCED with desc.gather.thickness SOLID
     slabs         preset BALANCED with desc.gather.thickness SLABS; may be NULL; the others may not */
SSGI_DEF ssgi_result ssgi_survey_of(ssgi_survey *survey, const float *hsao, const float *best, const float *solid,
                                    const float *slabs, size_t count, const char **why);

/* A calibration: errors of a frame's images against ray-traced ground truth, in the measure of plan_scene.wanted. */
typedef struct ssgi_calibration {
    int known;        /* 0: no calibration */
    float unoccluded; /* error of an image without any occlusion */
    float hsao;       /* error of slices, preset BALANCED, thickness WIDTH; for light: of visibility times the light */
    float slabs;      /* the same as hsao, but with thickness SLABS; 0: not known */
    float fast;       /* the same as hsao, but with preset FAST; 0: not known */
    float s3ho;       /* LIGHT, BOUNCE: error of s3ho, preset BALANCED, thickness WIDTH; 0: not known */
} ssgi_calibration;

/* Calibrates for ambient visibility: traces it at points of a frame and compares. (For light and bounces your own
   renderer would have to do so.) The rays' variance is removed by comparing two halves, so that 64 rays suffice. 3000
   points spread over the frame, 0.2 million rays, give the error over all pixels of the frame within 3 to 6 % in half
   of 27 views, and within 10 % in nine of ten.
     position, normal   of each point, in the trace's space; normals unit, toward the viewer. Take positions from
                        tracing the pixels' rays: those from depth are too coarse far away
     hsao, slabs, fast  ambient visibility in the frame at each point, by the settings of ssgi_calibration; a value that
                        is not finite counts as 1; slabs and fast may be NULL
     count              [limit: > 0] points
     rays               [limit: 2..65536] a point
     radius             [limit: > 0, finite] */
SSGI_DEF ssgi_result ssgi_plan_calibrate(ssgi_calibration *calibration, const ssgi_trace *trace, const float *position,
                                         const float *normal, const float *hsao, const float *slabs, const float *fast,
                                         size_t count, int rays, float radius, const char **why);

/* The known numbers of a scene, and the request. Zero means not known, or the default. Words in capitals before a colon
   are the values of `wanted` for which the member is read. */
typedef struct ssgi_plan_scene {
    /* the request */
    int wanted;   /* SSGI_PLAN_WANTED_VISIBILITY .. */
    int device;   /* SSGI_PLAN_DEVICE_SOFTWARE .. */
    int unit;     /* SSGI_PLAN_UNIT_RMSE or SSGI_PLAN_UNIT_RELATIVE: the unit of `error` */
    float error;  /* [limit: >= 0] 0: the least error that the budget buys */
    float budget; /* [units: time of an unblurred 16-sample ssao on the device; RX_6800: milliseconds of 1920x1080;
                     scale by the pixels for other sizes] [limit: >= 0] 0: unlimited */

    /* the geometry in the frame */
    float screen_radius; /* [limit: >= 0] [default: 0.15] the radius over the frame's height, mean over the visible
                            pixels: radius * view.project[1] / (view depth * height) */
    ssgi_survey survey;
    ssgi_calibration calibration; /* OBJECTS: of its members only `unoccluded` is read */

    /* the light */
    float energy[4]; /* LIGHT, BOUNCE: ssgi_sh_energy of the light, four bands; if the first is 0, those of a clear sky,
                        1 : 0.42 : 0.13 : 0.18 */
    int map;         /* LIGHT, BOUNCE: 1: there is also an image of the environment, which ssdo looks up */

    /* the passes that may be drawn */
    int thickness;    /* the largest that may be chosen: SSGI_PLAN_THICKNESS_WIDTH, _BACK or _SLABS */
    float depth_pass; /* [units: as budget] [limit: >= 0] cost of one depth-only pass; BACK needs 1, SLABS 3 */
    int history;      /* 1: frames may be averaged: the camera's motion is known, and trails may show */
    double surfels;   /* VISIBILITY: number of surfels at size 0.03 (ssgi_surfels_predict) / number of the frame's
                         pixels; 0: surfels may not be made */
    double splats;    /* VISIBILITY: number of texels of their splats at full resolution, all levels / number of the
                         frame's pixels [default: 55] */
    int occluders;    /* OBJECTS: number of occluders that have fields */
    float coverage;   /* OBJECTS: mean share of pixels in an occluder's reach [limit: >= 0] [default: 0.1] */
} ssgi_plan_scene;

typedef struct ssgi_plan {
    int method; /* SSGI_PLAN_METHOD_NOTHING .. */

    /* settings, 0 if the method has none. They are those of ssgi_gl_desc, except: thickness is
       SSGI_PLAN_THICKNESS_WIDTH ..; history is that of ssgi_gl_chain; field_resolution is the resolution of
       ssgi_field_desc, surfel_size the size of ssgi_surfel_desc */
    int thickness, resolution, slices, samples, bands, history, levels, filter_radius, field_resolution;
    float surfel_size;

    /* the predictions for these settings */
    float cost;       /* [units: as budget] with depth passes, without making surfels and fields; at most SSGI_FAR */
    float error;      /* in the measure of `wanted`; at most SSGI_FAR */
    float unoccluded; /* the same of an image without occlusion; error / unoccluded is the relative error */
    int meets;        /* 1: error <= 1.04 x the error asked for, and cost within the budget; 0 if none was asked for */

    /* numbers of choices, for ssgi_plan_choice */
    int choice;  /* this plan's */
    int cheaper; /* the best that costs a twentieth less than this plan, or still less; -1: there is none */
    int dearer;  /* the cheapest whose error is a twentieth smaller, or still smaller; -1: there is none */
    /* sentences: the settings, their error and cost, the property of the scene that decides, both other choices */
    char why[512];
} ssgi_plan;

/* Makes a plan: the cheapest choice that meets the error. If none does, it is the cheapest within 5 % of the best, with
   meets 0 and a `why` that begins "Cannot be met". Bad input gives SSGI_BAD_ARGUMENT and leaves the plan untouched. It
   is a pure function. */
SSGI_DEF ssgi_result ssgi_plan_make(ssgi_plan *plan, const ssgi_plan_scene *scene, const char **why);

/* Writes the planner's choice number i, of SSGI_PLAN_CHOICES, with its predicted error and cost for a scene (whose
   numbers are not checked), meets 0, no other choices and an empty `why`. Returns 1 with *plan filled. Returns 0
   with *plan untouched past the last choice, for NULL, and if the choice does not serve scene->wanted, needs a value
   that the scene does not give, or uses the light's directions though they would gain too little. */
SSGI_DEF int ssgi_plan_choice(ssgi_plan *plan, int i, const ssgi_plan_scene *scene);

enum { SSGI_PLAN_CHOICES = 55 };

#ifdef __cplusplus
}
#endif
#endif /* SSGI_H: END OF HEADER ------------------------------------------------------------------------------- */

#if defined(SSGI_IMPLEMENTATION) && !defined(SSGI_IMPLEMENTED)
#define SSGI_IMPLEMENTED

#include <float.h>
#include <math.h>
#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ==== >>types (implementation) ================================================================================= */

#define SSGI__PI 3.14159265358979323846

/* Marks a private function. Inlining would cost code and compile time; functions that gain by it are plain static. */
#ifdef __GNUC__
#define SSGI__FN static __attribute__((noinline))
#else
#define SSGI__FN static
#endif

SSGI__FN ssgi_result ssgi__bad(const char **why, const char *sentence)
{
    if (why) *why = sentence;
    return SSGI_BAD_ARGUMENT;
}

/* Macros that check the arguments of a function: if a check fails, the function returns the error and writes the
   sentence to its parameter `why`. */
#define SSGI__CHECK(good, sentence) \
    do { \
        if (!(good)) return ssgi__bad(why, sentence); \
    } while (0)
#define SSGI__RANGE(n, least, most) SSGI__CHECK((n) >= least && (n) <= most, #n ": must be " #least ".." #most)
#define SSGI__ZERO_OR(n, name, a, b) SSGI__CHECK(!(n) || ((n) >= a && (n) <= b), name ": must be 0 or " #a ".." #b)
#define SSGI__SIZE(width, height) \
    SSGI__RANGE(width, 1, 65536); \
    SSGI__RANGE(height, 1, 65536)
#define SSGI__THERE(a) SSGI__CHECK(a, #a ": must not be NULL")
#define SSGI__THERE2(a, b) \
    SSGI__THERE(a); \
    SSGI__THERE(b)
#define SSGI__THERE3(a, b, c) \
    SSGI__THERE(a); \
    SSGI__THERE(b); \
    SSGI__THERE(c)
#define SSGI__ENOUGH(size, least, sentence) \
    do { \
        if ((size) < (least)) { \
            ssgi__bad(why, sentence); \
            return SSGI_TOO_SMALL; \
        } \
    } while (0)
#define SSGI__TRY(call) \
    do { \
        const ssgi_result r_ = (call); \
        if (r_ != SSGI_OK) return r_; \
    } while (0)

/* Returns the bits of a float. With -ffast-math compilers assume that arguments and sums are finite; clang 18 and later
   even drops a test of their bits. They assume nothing about a volatile variable. */
static uint32_t ssgi__bits(float x)
{
    uint32_t bits;
    volatile uint32_t kept;
    memcpy(&bits, &x, sizeof bits);
    kept = bits;
    return kept;
}

/* Returns whether x is finite. x must be an input: of a sum a compiler may leave out terms. */
static int ssgi__finite(float x) { return (ssgi__bits(x) & 0x7f800000u) != 0x7f800000u; }

/* Returns whether v is not NULL and all its values are finite. */
SSGI__FN int ssgi__finites(const float *v, int count)
{
    if (!v) return 0;
    while (count > 0 && ssgi__finite(*v)) {
        ++v;
        --count;
    }
    return count == 0;
}

/* Returns whether all values are finite and 0 or more (v must not be NULL). */
SSGI__FN int ssgi__positive(const float *v, int count)
{
    while (count > 0 && ssgi__finite(*v) && *v >= 0.0f) {
        ++v;
        --count;
    }
    return count == 0;
}

/* Returns whether a float can hold x, which is then neither NaN nor infinite. */
SSGI__FN int ssgi__fits(double x)
{
    uint64_t bits;
    volatile uint64_t kept;
    memcpy(&bits, &x, sizeof bits);
    kept = bits;
    return (kept & 0x7fffffffffffffffu) <= 0x47efffffe0000000u; /* FLT_MAX */
}

/* Writes x as a float. Returns 0, and writes 0, if a float cannot hold it. */
SSGI__FN int ssgi__fit(float *out, double x)
{
    const int fits = ssgi__fits(x);
    *out = fits ? (float)x : 0.0f;
    return fits;
}

/* Returns whether x is finite and above 0 as a float, so that doubles hold its square and its inverse. */
SSGI__FN int ssgi__above_zero(double x) { return ssgi__fits(x) && (float)x > 0.0f; }

/* Returns x clamped to 0..most; NaN counts as 0. The bits of NaN and of negative floats are above infinity's. */
static float ssgi__clamped(float x, float most)
{
    if (ssgi__bits(x) > 0x7f800000u) return 0.0f;
    return x < most ? x : most;
}

SSGI__FN int ssgi__within(float x, float least, float most) { return ssgi__finite(x) && x >= least && x <= most; }

/* Returns whether x is 0, which stands for the default, or in least..most. */
SSGI__FN int ssgi__zero_or(float x, float least, float most)
{
    return ssgi__within(x, 0.0f, 0.0f) || ssgi__within(x, least, most);
}

/* Returns a radiance or flux clamped to least..1e24, so that sums over any image stay finite; 0 if it is not finite. */
static double ssgi__light(float x, float least)
{
    return ssgi__finite(x) ? (double)(x < least ? least : x > 1e24f ? 1e24f : x) : 0.0;
}

static double ssgi__luminance(const double rgb[3]) { return 0.2126 * rgb[0] + 0.7152 * rgb[1] + 0.0722 * rgb[2]; }

/* Writes a radiance, clamped by ssgi__light, times a weight. Returns the luminance of the product. */
SSGI__FN double ssgi__light3(double out[3], const float *rgb, float least, double weight)
{
    for (int c = 0; c < 3; ++c) out[c] = weight * ssgi__light(rgb[c], least);
    return ssgi__luminance(out);
}

static float ssgi__min(float a, float b) { return a < b ? a : b; }

static float ssgi__max(float a, float b) { return a > b ? a : b; }

static float ssgi__abs(float a) { return ssgi__max(a, -a); }

SSGI__FN int ssgi__clamp(int a, int least, int most) { return a < least ? least : a > most ? most : a; }

SSGI__FN double ssgi__dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

SSGI__FN void ssgi__cross(double out[3], const double a[3], const double b[3])
{
    out[0] = a[1] * b[2] - a[2] * b[1];
    out[1] = a[2] * b[0] - a[0] * b[2];
    out[2] = a[0] * b[1] - a[1] * b[0];
}

/* Writes a + s b. */
SSGI__FN void ssgi__along(double out[3], const double a[3], double s, const double b[3])
{
    for (int i = 0; i < 3; ++i) out[i] = a[i] + s * b[i];
}

SSGI__FN void ssgi__doubles(double out[3], const float v[3])
{
    for (int i = 0; i < 3; ++i) out[i] = (double)v[i];
}

SSGI__FN void ssgi__floats(float out[3], const double v[3])
{
    for (int i = 0; i < 3; ++i) out[i] = (float)v[i];
}

/* Makes v a unit vector and returns the length that it had. A zero vector stays 0. */
SSGI__FN double ssgi__normalise(double v[3])
{
    const double length = sqrt(ssgi__dot(v, v));
    for (int i = 0; i < 3 && length > 0.0; ++i) v[i] /= length;
    return length;
}

/* Writes two axes perpendicular to a unit vector, and the vector itself as the third axis. */
SSGI__FN void ssgi__axes(float axes[3][3], const double axis[3])
{
    double side[3] = { 0.0, 0.0, 0.0 }, up[3];
    int least = 0;
    for (int i = 1; i < 3; ++i)
        if (fabs(axis[i]) < fabs(axis[least])) least = i;
    side[least] = 1.0;
    ssgi__cross(up, axis, side);
    ssgi__normalise(up);
    ssgi__cross(side, up, axis);
    ssgi__floats(axes[0], side);
    ssgi__floats(axes[1], up);
    ssgi__floats(axes[2], axis);
}

/* Writes the unit vector at a height z and an azimuth. */
SSGI__FN void ssgi__polar(double w[3], double z, double angle)
{
    const double r = sqrt(1.0 - z * z);
    w[0] = r * cos(angle);
    w[1] = r * sin(angle);
    w[2] = z;
}

/* ==== >>view (implementation) ================================================================================== */

SSGI_DEF ssgi_result ssgi_view_from_projection(ssgi_view *view, const float projection[16], int clip, int width,
                                               int height, const char **why)
{
    double m[16], w, scale, shift, skew = 0.0;
    float near_plane;
    ssgi_view v;
    int perspective, fits = 1;
    SSGI__THERE2(view, projection);
    SSGI__CHECK(clip >= SSGI_CLIP_GL && clip <= SSGI_CLIP_ZERO + SSGI_CLIP_ROWS_DOWN,
                "clip: must be SSGI_CLIP_GL or SSGI_CLIP_ZERO, either one + SSGI_CLIP_ROWS_DOWN");
    SSGI__SIZE(width, height);
    SSGI__CHECK(ssgi__finites(projection, 16), "projection: must be finite");
    perspective = projection[11] != 0.0f;
    if (projection[3] != 0.0f || projection[7] != 0.0f
        || (perspective ? projection[15] != 0.0f : !(projection[15] > 0.0f)))
        return ssgi__bad(why, "projection: its w row must be (0,0,-1,0), left-handed (0,0,1,0), or (0,0,0,1)");
    if (projection[1] != 0.0f || projection[4] != 0.0f)
        return ssgi__bad(why, "projection: must not be rolled (elements 1 and 4 are 0): roll world_to_view instead");
    w = fabs((double)projection[perspective ? 11 : 15]);
    for (int i = 0; i < 16; ++i) m[i] = (double)projection[i] / w;
    if (projection[0] == 0.0f || projection[5] == 0.0f)
        return ssgi__bad(why, "projection: elements 0 and 5 must not be 0");
    if (perspective ? projection[14] == 0.0f : projection[10] == 0.0f)
        return ssgi__bad(why, "projection: depth must vary (element 14, orthographic 10)");
    for (int i = 1; i < 16 && clip >= SSGI_CLIP_ROWS_DOWN; i += 4) m[i] = -m[i];
    scale = clip % SSGI_CLIP_ROWS_DOWN == SSGI_CLIP_GL ? 2.0 : 1.0; /* NDC z = scale * window depth + shift */
    shift = clip % SSGI_CLIP_ROWS_DOWN == SSGI_CLIP_GL ? -1.0 : 0.0;
    if (perspective ? m[11] > 0.0 : (m[14] - shift) / m[10] <= 0.0 && (m[14] - shift - scale) / m[10] <= 0.0)
        for (int i = 8; i < 12; ++i) m[i] = -m[i]; /* left-handed: with z negated it is right-handed */

    /* NDC x = m0 x/z - m8 (perspective, z the view depth) or m0 x + m12; pixel = (NDC/2 + 1/2) size. The same for y. */
    memset(&v, 0, sizeof v);
    v.width = width;
    v.height = height;
    v.orthographic = !perspective;
    for (int i = 0; i < 2; ++i) {
        double size = i ? height : width, gain = m[i * 5], centre = perspective ? -m[8 + i] : m[12 + i];
        fits &= ssgi__fit(&v.project[i], gain * 0.5 * size);
        fits &= ssgi__fit(&v.project[2 + i], (centre * 0.5 + 0.5) * size);
        fits &= ssgi__fit(&v.unproject[i], 2.0 / (size * gain));
        fits &= ssgi__fit(&v.unproject[2 + i], -(1.0 + centre) / gain);
        fits &= ssgi__fit(&v.oblique[i], -2.0 * m[2 + 4 * i] / (size * gain * scale));
        skew -= m[2 + 4 * i] * (1.0 + centre) / gain;
    }
    if (perspective) { /* NDC z = m14/z - m10, plus m2 x/z + m6 y/z if it is oblique */
        fits &= ssgi__fit(&v.depth[0], (shift + m[10] - skew) / m[14]);
        fits &= ssgi__fit(&v.depth[1], scale / m[14]);
        v.clear = v.depth[1] > 0.0f ? 0.0f : 1.0f; /* if nearness grows with window depth, depth is reversed */
    } else {                                       /* NDC z = -m10 z + m14, plus m2 x + m6 y */
        fits &= ssgi__fit(&v.depth[0], (m[14] - shift + skew) / m[10]);
        fits &= ssgi__fit(&v.depth[1], -scale / m[10]);
        v.clear = v.depth[1] > 0.0f ? 1.0f : 0.0f;
    }
    SSGI__CHECK(fits, "projection: its elements are too large or too small for float arithmetic");
    near_plane = ssgi_view_near(&v);
    SSGI__CHECK(near_plane > (v.orthographic ? -3e38f : 0.0f) && near_plane < 3e38f,
                "projection: shows nothing that is in front of the camera (elements 10 and 14)");
    *view = v;
    return SSGI_OK;
}

SSGI_DEF float ssgi_view_depth(const ssgi_view *view, float d) { return ssgi_view_depth_at(view, 0.0f, 0.0f, d); }

SSGI_DEF float ssgi_view_depth_at(const ssgi_view *view, float x, float y, float d)
{
    float z = view->depth[0] + view->depth[1] * (d + (x * view->oblique[0] + y * view->oblique[1]));
    if (!ssgi__finite(d) || !(d >= 0.0f && d <= 1.0f) || d == view->clear) return SSGI_FAR;
    if (view->orthographic) return z > -SSGI_FAR && z < SSGI_FAR ? z : SSGI_FAR;
    z = z > 1.0f / SSGI_FAR ? 1.0f / z : SSGI_FAR;
    return z > 1.0f / SSGI_FAR && z < SSGI_FAR ? z : SSGI_FAR;
}

SSGI_DEF void ssgi_view_position(float out[3], const ssgi_view *view, float x, float y, float z)
{
    float k = view->orthographic ? 1.0f : z;
    out[0] = (x * view->unproject[0] + view->unproject[2]) * k;
    out[1] = (y * view->unproject[1] + view->unproject[3]) * k;
    out[2] = -z;
}

SSGI_DEF void ssgi_view_project(float out[3], const ssgi_view *view, const float p[3])
{
    float k = view->orthographic ? 1.0f : 1.0f / -p[2];
    out[2] = -p[2];
    out[0] = p[0] * k * view->project[0] + view->project[2];
    out[1] = p[1] * k * view->project[1] + view->project[3];
}

SSGI_DEF float ssgi_view_near(const ssgi_view *view)
{
    float d = view->depth[0] + view->depth[1] * (1.0f - view->clear);
    for (int i = 0; i < 2; ++i) {
        const float skew = view->depth[1] * view->oblique[i] * (float)(i ? view->height : view->width);
        d += view->orthographic ? ssgi__min(skew, 0.0f) : ssgi__max(skew, 0.0f);
    }
    return view->orthographic ? d : 1.0f / d;
}

SSGI_DEF float ssgi_pixel_footprint(const ssgi_view *view, float z)
{
    const float x = ssgi__abs(view->unproject[0]), y = ssgi__abs(view->unproject[1]);
    return ssgi__max(x, y) * (view->orthographic ? 1.0f : z);
}

/* Returns the distance of a view-space point outside the frustum, 0 inside. It is the largest distance beyond a side
   plane or the near plane. The far plane does not count. */
SSGI__FN double ssgi__view_aside(const ssgi_view *view, const double point[3])
{
    const double z = -point[2];
    double most = (double)ssgi_view_near(view) - z;
    if (!(most > 0.0)) most = 0.0;
    for (int k = 0; k < 4; ++k) { /* left, right, lower, upper */
        const int axis = k / 2, side = k % 2;
        const double pixel = side ? (double)(axis ? view->height : view->width) : 0.0;
        const double edge = pixel * (double)view->unproject[axis] + (double)view->unproject[2 + axis]; /* per depth */
        const double sign = (side != 0) == (view->unproject[axis] > 0.0f) ? 1.0 : -1.0;
        const double d = view->orthographic ? sign * (point[axis] - edge)
                                            : sign * (point[axis] - edge * z) / sqrt(1.0 + edge * edge);
        if (d > most) most = d;
    }
    return most;
}

/* Writes the rotation of the main camera's matrix, with one axis in each row, or refuses a matrix that is not rigid. */
SSGI__FN ssgi_result ssgi__main_axes(double axis[3][3], const float main_world_to_view[16], const char **why)
{
    SSGI__CHECK(ssgi__finites(main_world_to_view, 16), "main_world_to_view: must be finite");
    for (int i = 0; i < 9; ++i) axis[i % 3][i / 3] = (double)main_world_to_view[i / 3 * 4 + i % 3];
    for (int i = 0; i < 9; ++i)
        if (fabs(ssgi__dot(axis[i / 3], axis[i % 3]) - (i / 3 == i % 3 ? 1.0 : 0.0)) > 1e-3)
            return ssgi__bad(why, "main_world_to_view: must be rigid: a rotation and a translation");
    for (int i = 0; i < 4; ++i)
        if (main_world_to_view[4 * i + 3] != (i < 3 ? 0.0f : 1.0f))
            return ssgi__bad(why, "main_world_to_view: its last row must be (0,0,0,1)");
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_extra_camera(float world_to_view[16], float projection[16],
                                       const float main_world_to_view[16], const float centre[3], float radius,
                                       const float displacement[3], const char **why)
{
    const double sin50 = 0.76604444311897803520, cot50 = 0.83909963117728001176; /* sine and cotangent of 50 degrees,
                                                                                    which is half of the widest angle of
                                                                                    view */
    const double r = (double)radius;
    double was[3][3], axis[3][3], turn[3], eye[3] = { 0, 0, 0 }, distance, near_plane, far_plane;
    float view[16] = { 0 }, clip[16] = { 0 };
    int fits = 1;
    ssgi_view seen;
    SSGI__THERE3(world_to_view, projection, main_world_to_view);
    SSGI__TRY(ssgi__main_axes(was, main_world_to_view, why));
    SSGI__CHECK(ssgi__finites(centre, 3), "centre: must be there and finite");
    SSGI__CHECK(ssgi__finite(radius) && radius > 0.0f, "radius: must be finite and above 0");
    SSGI__CHECK(ssgi__finites(displacement, 3), "displacement: must be there and finite");

    /* the new z axis points away from the centre; the new x axis is perpendicular to it and to the main camera's y
       axis, or, if that is the new z axis, to the main camera's z axis */
    for (int k = 0; k < 3; ++k) { /* the main eye stands at minus the translation, in its own axes */
        for (int i = 0; i < 3; ++i)
            eye[k] += was[i][k] * (r * (double)displacement[i] - (double)main_world_to_view[12 + i]);
        axis[2][k] = eye[k] - (double)centre[k];
    }
    distance = ssgi__normalise(axis[2]);
    if (distance < 1e-6 * r) { /* at the centre it looks as the main camera does */
        memcpy(axis[2], was[2], sizeof axis[2]);
        ssgi__normalise(axis[2]);
    }
    ssgi__cross(axis[0], was[1], axis[2]);
    if (ssgi__normalise(axis[0]) < 1e-3) {
        ssgi__cross(axis[0], axis[2], was[2]);
        ssgi__normalise(axis[0]);
    }
    ssgi__cross(axis[1], axis[2], axis[0]);
    ssgi__cross(turn, was[0], was[1]);
    for (int k = 0; k < 3 && ssgi__dot(turn, was[2]) < 0.0; ++k) axis[0][k] = -axis[0][k]; /* mirrored, too */
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 3; ++k) view[4 * k + i] = (float)axis[i][k];
        fits &= ssgi__fit(&view[12 + i], -ssgi__dot(axis[i], eye));
    }
    view[15] = 1.0f;

    near_plane = 0.02 * r;
    far_plane = distance + r;
    fits &= ssgi__fit(&clip[0], distance * sin50 > r ? sqrt((distance - r) * far_plane) / r : cot50);
    clip[5] = clip[0];
    clip[10] = (float)(-(far_plane + near_plane) / (far_plane - near_plane));
    clip[11] = -1.0f;
    fits &= ssgi__fit(&clip[14], -2.0 * far_plane * near_plane / (far_plane - near_plane));
    SSGI__CHECK(fits && ssgi_view_from_projection(&seen, clip, SSGI_CLIP_GL, 65536, 65536, NULL) == SSGI_OK,
                "radius: too small or too large for float arithmetic");
    memcpy(world_to_view, view, sizeof view);
    memcpy(projection, clip, sizeof clip);
    return SSGI_OK;
}

SSGI_DEF void ssgi_extra_displacement(float out[3], int i)
{
    static const float all[4][3] = { { -1.62760f, 0.68404f, -1.06031f },
                                     { 1.62760f, 0.68404f, -1.06031f },
                                     { 0.0f, 1.93185f, -1.48236f },
                                     { 0.0f, 1.53209f, -3.28558f } };
    memcpy(out, all[i & 3], sizeof all[0]);
}

/* ==== >>bias (implementation) ================================================================================== */

/* Returns x clamped to 0..SSGI_FAR; NaN counts as 0. */
SSGI__FN float ssgi__clamped_length(float x) { return ssgi__clamped(x, SSGI_FAR); }

SSGI_DEF float ssgi_normal_offset(const ssgi_view *view, float z)
{
    const double depth = view->orthographic ? 1.0 : (double)ssgi__clamped_length(z);
    const double offset = 0.5 * (double)ssgi_pixel_footprint(view, 1.0f) * depth;
    return offset < (double)SSGI_FAR ? (float)offset : SSGI_FAR;
}

SSGI_DEF float ssgi_shadow_patch(float depth, float full_angle, int resolution)
{
    const double half = 0.5 * (double)ssgi__min(ssgi__clamped_length(full_angle), 3.14f);
    const double patch = 2.0 * (double)ssgi__clamped_length(depth) * tan(half) / (resolution > 1 ? resolution : 1);
    return patch < (double)SSGI_FAR ? (float)patch : SSGI_FAR;
}

SSGI_DEF float ssgi_shadow_bias(float patch, float cosine, float most, int kind)
{
    const double half = (double)ssgi__clamped_length(patch)
                      * (kind == SSGI_BIAS_PUBLISHED ? 0.5 : 0.70710678118654752440);
    const double c = (double)ssgi__min(ssgi__clamped_length(cosine), 1.0f), limit = (double)ssgi__clamped_length(most);
    const double bias = half * sqrt(1.0 - c * c);
    return (float)(bias < limit * c ? bias / c : limit);
}

/* A mesh in which ssgi_radius_guess seeks maxima of height. After sorting, vertices have numbers in the order of their
   positions. */
typedef struct ssgi__peaks {
    const char *position;
    size_t stride;
    const uint32_t *index;
    uint32_t *corner; /* for each vertex a corner, 3 * triangle + k, that lies there */
    uint32_t *vertex; /* for each corner its vertex */
    uint32_t *part;   /* for each vertex an earlier one of its level part, or itself; and flags: SSGI__UP, SSGI__DOWN */
    double up[3], middle[3];
    int along; /* 1: heights are along up; 0: they are distances from middle */
} ssgi__peaks;

#define SSGI__UP 0x80000000u   /* an edge leads up from the part */
#define SSGI__DOWN 0x40000000u /* an edge leads down from the part */
#define SSGI__PART 0x3fffffffu

SSGI__FN void ssgi__peaks_at(double p[3], const ssgi__peaks *m, uint32_t corner)
{
    float v[3];
    memcpy(v, m->position + m->stride * (m->index ? m->index[corner] : corner), sizeof v);
    ssgi__doubles(p, v);
}

/* Returns whether corner a lies before b, by x, then y, then z. */
SSGI__FN int ssgi__peaks_before(const ssgi__peaks *m, uint32_t a, uint32_t b)
{
    double p[3], q[3];
    int axis = 0;
    ssgi__peaks_at(p, m, a);
    ssgi__peaks_at(q, m, b);
    while (axis < 2 && p[axis] == q[axis]) ++axis;
    return p[axis] < q[axis];
}

/* Sifts corner k of a heap of n down, until no corner is before those below it in the heap. */
SSGI__FN void ssgi__peaks_sift(const ssgi__peaks *m, size_t k, size_t n)
{
    const uint32_t moved = m->corner[k];
    for (size_t next; (next = 2 * k + 1) < n; k = next) {
        if (next + 1 < n && ssgi__peaks_before(m, m->corner[next], m->corner[next + 1])) ++next;
        if (!ssgi__peaks_before(m, moved, m->corner[next])) break;
        m->corner[k] = m->corner[next];
    }
    m->corner[k] = moved;
}

/* Sorts n corners, then gives all corners at one place the same vertex. Returns the number of vertices. */
SSGI__FN size_t ssgi__peaks_weld(const ssgi__peaks *m, size_t n)
{
    size_t vertices = 0;
    for (size_t k = n / 2; k-- > 0;) ssgi__peaks_sift(m, k, n);
    for (size_t k = n; k-- > 1;) {
        const uint32_t last = m->corner[0];
        m->corner[0] = m->corner[k];
        m->corner[k] = last;
        ssgi__peaks_sift(m, 0, k);
    }
    for (size_t k = 0; k < n; ++k) {
        const uint32_t corner = m->corner[k];
        if (!vertices || ssgi__peaks_before(m, m->corner[vertices - 1], corner)) m->corner[vertices++] = corner;
        m->vertex[corner] = (uint32_t)vertices - 1;
    }
    return vertices;
}

SSGI__FN double ssgi__peaks_height(const ssgi__peaks *m, uint32_t vertex)
{
    double p[3];
    ssgi__peaks_at(p, m, m->corner[vertex]);
    ssgi__along(p, p, -1.0, m->middle);
    return m->along ? ssgi__dot(p, m->up) : sqrt(ssgi__dot(p, p));
}

/* Returns the first vertex of a vertex's level part. Shortens the way to it for later calls. */
SSGI__FN uint32_t ssgi__peaks_part(const ssgi__peaks *m, uint32_t vertex)
{
    while ((m->part[vertex] & SSGI__PART) != vertex) {
        const uint32_t up = m->part[vertex] & SSGI__PART;
        m->part[vertex] = (m->part[up] & SSGI__PART) | (m->part[vertex] & ~SSGI__PART);
        vertex = m->part[vertex] & SSGI__PART;
    }
    return vertex;
}

/* Takes an edge: joins the level parts of its ends if it is level, else marks the part that it leads up from and the
   part that it leads down from. */
SSGI__FN void ssgi__peaks_edge(const ssgi__peaks *m, uint32_t a, uint32_t b, double level)
{
    const double rise = ssgi__peaks_height(m, b) - ssgi__peaks_height(m, a);
    a = ssgi__peaks_part(m, a);
    b = ssgi__peaks_part(m, b);
    if (rise > level || rise < -level) {
        m->part[a] |= rise > 0.0 ? SSGI__UP : SSGI__DOWN;
        m->part[b] |= rise > 0.0 ? SSGI__DOWN : SSGI__UP;
    } else if (a != b) {
        const uint32_t first = a < b ? a : b, other = a < b ? b : a;
        m->part[first] |= m->part[other] & ~SSGI__PART;
        m->part[other] = first;
    }
}

/* Returns the mean distance from a maximum to the nearest other, over every step-th of the `count` maxima in
   `vertex`. */
SSGI__FN double ssgi__peaks_spacing(const ssgi__peaks *m, const uint32_t *vertex, size_t count)
{
    const size_t step = (count + 1023) / 1024;
    double sum = 0.0;
    for (size_t i = 0; i < count; i += step) {
        double p[3], q[3], nearest = DBL_MAX;
        ssgi__peaks_at(p, m, m->corner[vertex[i]]);
        for (size_t k = 0; k < count; ++k) {
            ssgi__peaks_at(q, m, m->corner[vertex[k]]);
            ssgi__along(q, q, -1.0, p);
            if (k != i && ssgi__dot(q, q) < nearest) nearest = ssgi__dot(q, q);
        }
        sum += sqrt(nearest);
    }
    return sum / (double)((count + step - 1) / step);
}

SSGI_DEF ssgi_result ssgi_radius_guess(float *radius, size_t *maxima, const float *position, size_t stride_bytes,
                                       const uint32_t *index, size_t triangles, const float *up, uint32_t *work,
                                       size_t words, const char **why)
{
    double low[3] = { DBL_MAX, DBL_MAX, DBL_MAX }, high[3] = { -DBL_MAX, -DBL_MAX, -DBL_MAX }, diagonal;
    ssgi__peaks m = { (const char *)position, stride_bytes, index, work, NULL, NULL, { 0 }, { 0 }, up != NULL };
    size_t corners = 0, vertices, found = 0;
    uint32_t *peak;
    SSGI__THERE2(radius, position);
    SSGI__CHECK(stride_bytes >= 12 && stride_bytes % 4 == 0, "stride_bytes: must be 12 or more, a multiple of 4");
    SSGI__CHECK(triangles >= 1 && triangles <= 1u << 28, "triangles: must be 1..2^28");
    SSGI__CHECK(!up || ssgi__finites(up, 3), "up: must be finite, or NULL");
    if (up) ssgi__doubles(m.up, up);
    SSGI__CHECK(!up || ssgi__normalise(m.up) > 0.0, "up: must not be 0");
    SSGI__THERE(work);
    SSGI__ENOUGH(words, 9 * triangles, "words: must be 9 * triangles or more");
    m.vertex = work + 3 * triangles;
    m.part = m.vertex + 3 * triangles;
    for (size_t i = 0; i < 3 * triangles; ++i) m.vertex[i] = SSGI__PART; /* no corner has a vertex yet */
    for (size_t i = 0; i < triangles; ++i) {
        double p[3][3];
        int inside = 1;
        for (int k = 0; k < 3; ++k) ssgi__peaks_at(p[k], &m, (uint32_t)(3 * i) + (uint32_t)k);
        for (int k = 0; k < 9; ++k) inside &= ssgi__fits(p[k / 3][k % 3]) && fabs(p[k / 3][k % 3]) <= 1e12;
        for (int k = 0; k < 3 && inside; ++k) {
            m.corner[corners++] = (uint32_t)(3 * i) + (uint32_t)k;
            for (int c = 0; c < 3; ++c) {
                if (p[k][c] < low[c]) low[c] = p[k][c];
                if (p[k][c] > high[c]) high[c] = p[k][c];
            }
        }
    }
    SSGI__CHECK(corners, "position: must have a triangle that is finite and within 1e12");
    for (int c = 0; c < 3; ++c) m.middle[c] = 0.5 * (low[c] + high[c]);
    ssgi__along(high, high, -1.0, low);
    diagonal = sqrt(ssgi__dot(high, high));
    SSGI__CHECK(diagonal > 1e-30, "position: must not be one point");

    vertices = ssgi__peaks_weld(&m, corners);
    for (size_t i = 0; i < vertices; ++i) m.part[i] = (uint32_t)i;
    for (size_t i = 0; i < 3 * triangles; ++i) {
        const size_t next = i % 3 < 2 ? i + 1 : i - 2;
        if (m.vertex[i] != SSGI__PART) ssgi__peaks_edge(&m, m.vertex[i], m.vertex[next], 1e-6 * diagonal);
    }
    peak = m.vertex; /* m.vertex is not needed any more */
    for (size_t i = 0; i < vertices; ++i)
        if (m.part[i] == ((uint32_t)i | SSGI__DOWN)) peak[found++] = (uint32_t)i;
    *radius = (float)(found > 1 ? ssgi__peaks_spacing(&m, peak, found) : 0.1 * diagonal);
    if (maxima) *maxima = found;
    return SSGI_OK;
}

/* ==== >>kernel (implementation) ================================================================================ */

SSGI_DEF float ssgi_radical_inverse(uint32_t base, uint32_t i)
{
    double f = 1.0, r = 0.0;
    if (base < 2) return 0.0f;
    for (; i; i /= base) {
        f /= (double)base;
        r += f * (double)(i % base);
    }
    return ssgi__min((float)r, 1.0f - FLT_EPSILON / 2); /* as 0.99999999 rounds up to 1 */
}

/* Returns the hash of PCG [O'Neill 2014]. */
SSGI__FN uint32_t ssgi__hash(uint32_t x)
{
    x = x * 747796405u + 2891336453u;
    x = ((x >> ((x >> 28) + 4)) ^ x) * 277803737u;
    return (x >> 22) ^ x;
}

/* Returns a pseudo-random share of a turn, in [0,1). */
SSGI__FN double ssgi__turn(uint32_t seed) { return (double)ssgi__hash(seed) / 4294967296.0; }

SSGI__FN float ssgi__fract(double x)
{
    float f = (float)(x - floor(x));
    return f < 1.0f ? f : 0.0f;
}

SSGI_DEF void ssgi_r2(float out[2], uint32_t i)
{
    out[0] = ssgi__fract(0.5 + 0.75487766624669276005 * (double)i);
    out[1] = ssgi__fract(0.5 + 0.56984029099805326591 * (double)i);
}

/* Writes the direction of ray i in a cone about axes[2]. The rays are spread evenly over the cone; `shift`, in [0,1)^2,
   moves all of them, so that sets of rays differ. */
SSGI__FN void ssgi__cone_ray(float direction[3], float axes[3][3], float cosine, int i, const double shift[2])
{
    float at[2], z, radius, angle;
    ssgi_r2(at, (uint32_t)i);
    z = 1.0f - (1.0f - cosine) * ssgi__fract((double)at[0] + shift[0]);
    radius = sqrtf(z < 1.0f ? 1.0f - z * z : 0.0f);
    angle = 6.2831853f * ssgi__fract((double)at[1] + shift[1]);
    for (int k = 0; k < 3; ++k)
        direction[k] = radius * (cosf(angle) * axes[0][k] + sinf(angle) * axes[1][k]) + z * axes[2][k];
}

SSGI__FN int ssgi__gcd(int a, int b)
{
    while (b) {
        int c = a % b;
        a = b;
        b = c;
    }
    return a;
}

SSGI_DEF ssgi_result ssgi_kernel(float *out, int sets, int samples, const char **why)
{
    return ssgi_directions(out, SSGI_DIRECTIONS_COSINE, sets, samples, why);
}

/* Writes the height of a direction and its distance from the z axis. Of all directions of this kind
   (SSGI_DIRECTIONS_COSINE ..) a share u, in [0,1], is higher than this one. */
SSGI__FN void ssgi__directions_at(double out[2], int kind, double u)
{
    const double most = kind == SSGI_DIRECTIONS_SPHERE ? 2.0 : 1.0;
    out[0] = kind == SSGI_DIRECTIONS_COSINE ? sqrt(1.0 - u) : 1.0 - most * u;
    out[1] = kind == SSGI_DIRECTIONS_COSINE ? sqrt(u) : sqrt(most * u * (2.0 - most * u));
}

SSGI_DEF ssgi_result ssgi_directions(float *out, int kind, int sets, int samples, const char **why)
{
    const double two_pi = 2.0 * SSGI__PI, golden = 0.61803398874989484820;
    int step;
    SSGI__THERE(out);
    SSGI__CHECK(kind >= SSGI_DIRECTIONS_COSINE && kind <= SSGI_DIRECTIONS_SPHERE,
                "kind: must be SSGI_DIRECTIONS_COSINE, _UNIFORM or _SPHERE");
    SSGI__RANGE(sets, 1, 4096);
    SSGI__RANGE(samples, 1, 4096);
    /* a step coprime to the count visits every stratum of length once; a step near (sqrt(2) - 1) times the count makes
       length independent of u and of azimuth */
    for (step = (int)(0.41421356 * samples + 0.5); ssgi__gcd(step, samples) != 1; ++step) {}
    for (int set = 0; set < sets; ++set) {
        double turn = (double)ssgi_radical_inverse(2, (uint32_t)set),
               slide = 1.0 - (double)ssgi_radical_inverse(3, (uint32_t)set + 1);
        for (int i = 0; i < samples; ++i) {
            /* u is stratified at midpoints; the azimuth follows the golden angle, a spiral in which no two samples line
               up */
            double u = ((double)i + 0.5) / samples, phi = two_pi * (fmod((double)i * golden, 1.0) + turn), at[2];
            float *o = out + 4 * ((size_t)set * (size_t)samples + (size_t)i);
            ssgi__directions_at(at, kind, u);
            o[0] = (float)(at[1] * cos(phi));
            o[1] = (float)(at[1] * sin(phi));
            o[2] = (float)at[0];
            o[3] = (float)(((double)(((int64_t)i * step + set) % samples) + slide) / samples);
        }
    }
    return SSGI_OK;
}

/* A block of w x h texels that holds each set of a noise tile once. Copies of the block fill the tile in rows; each row
   is moved left by `shift` texels against the row before. */
typedef struct ssgi__block {
    int w, h, shift;
} ssgi__block;

/* Returns the least squared distance between a texel and the copies of the texel at x, y from it, as the block repeats
   over the plane. */
SSGI__FN int ssgi__block_distance(const ssgi__block *b, int x, int y)
{
    int least = 1 << 30;
    for (int k = -b->w / b->h - 1; k <= b->w / b->h + 1; ++k) {
        int dx = (x - k * b->shift) % b->w, dy = y + k * b->h;
        if (dx < 0) dx += b->w;
        if (dx > b->w - dx) dx = b->w - dx;
        if (!dx && !dy) dx = b->w; /* for the texel itself its nearest copy counts */
        least = dx * dx + dy * dy < least ? dx * dx + dy * dy : least;
    }
    return least;
}

/* Returns the squarest block of `sets` texels that can fill a tile, with the shift by which its copies lie farthest
   apart. */
SSGI__FN ssgi__block ssgi__block_of(int size, int sets)
{
    ssgi__block b = { sets, 1, 0 }, tried;
    int farthest = 0;
    for (int h = 2; h * h <= sets; ++h)
        if (size % h == 0 && sets % h == 0 && size % (sets / h) == 0) b.h = h;
    b.w = sets / b.h;
    tried = b;
    for (tried.shift = 0; tried.shift < b.w; ++tried.shift) {
        if (tried.shift * (size / b.h) % b.w || ssgi__block_distance(&tried, 0, 0) <= farthest) continue;
        farthest = ssgi__block_distance(&tried, 0, 0);
        b.shift = tried.shift;
    }
    return b;
}

/* Numbers the texels of the block at 0, 0. Each next number goes where the influence of the numbered texels is least. A
   texel's influence falls with 1/distance^4 and is a whole number, as floats add those without rounding. out[4 * (y *
   size + x) + 3] is the number, out[.. + 2] the influence. */
SSGI__FN void ssgi__block_order(float *out, int size, const ssgi__block *b)
{
    const int texels = b->w * b->h;
    for (int i = 0; i < texels; ++i) {
        float *o = out + 4 * (i / b->w * size + i % b->w);
        o[2] = 0.0f;
        o[3] = -1.0f;
    }
    for (int number = 0; number < texels; ++number) {
        const float *least = NULL;
        int at = 0;
        for (int i = 0; i < texels; ++i) {
            const float *o = out + 4 * (i / b->w * size + i % b->w);
            if (o[3] >= 0.0f || (least && o[2] >= least[2])) continue;
            least = o;
            at = i;
        }
        out[4 * (at / b->w * size + at % b->w) + 3] = (float)number;
        for (int i = 0; i < texels; ++i) {
            const int dd = ssgi__block_distance(b, i % b->w - at % b->w, i / b->w - at / b->w);
            out[4 * (i / b->w * size + i % b->w) + 2] += (float)((1 << 20) / (dd * dd));
        }
    }
}

SSGI_DEF ssgi_result ssgi_noise_tile(float *out, int size, int sets, int directions, const char **why)
{
    ssgi__block b;
    int texels, copies, step;
    SSGI__THERE(out);
    SSGI__RANGE(size, 1, 64);
    texels = size * size;
    SSGI__CHECK(sets >= 1 && texels % sets == 0, "sets: must be a divisor of size * size");
    SSGI__RANGE(directions, 1, 1024);
    copies = texels / sets;
    b = ssgi__block_of(size, sets);
    /* the step is coprime to the count and near its golden section, so that consecutive numbers are far apart */
    for (step = (int)(0.61803399 * texels + 0.5); ssgi__gcd(step, texels) != 1; ++step) {}
    ssgi__block_order(out, size, &b);
    for (int i = texels - 1; i >= 0; --i) { /* the block at 0, 0 comes last, as the others read it */
        const int x = i % size, y = i / size, row = y / b.h, copy = row * (size / b.w) + x / b.w;
        const int set = (int)out[4 * (y % b.h * size + (x + row * b.shift) % b.w) + 3];
        const double turn = ((double)set + 0.5) / sets, a = 2.0 * SSGI__PI * turn / directions;
        float *o = out + 4 * i;
        o[0] = (float)cos(a);
        o[1] = (float)sin(a);
        o[2] = (float)(((double)((int64_t)(set * copies + copy) * step % texels) + 0.5) / texels - 0.5);
        o[3] = (float)turn;
    }
    return SSGI_OK;
}

/* ==== >>sh (implementation) ==================================================================================== */

#define SSGI__SH_MOST (SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS)

/* Writes the basis at a unit direction. Function m of band l is norm * Q_lm(z) * Re or Im (x + iy)^|m|, where Q_lm
   sin^m is the associated Legendre function without its sign. Q follows by the recurrence in l. */
SSGI__FN void ssgi__sh_basis(double *out, int bands, const double d[3])
{
    /* sqrt((2l+1) (l-m)! / (4 pi (l+m)!)), times sqrt(2) for m > 0, at l (l+1)/2 + m */
    static const double norm[] = { 0.28209479177387814, 0.48860251190291992, 0.48860251190291992, 0.63078313050504009,
                                   0.36418281019735976, 0.18209140509867988, 0.74635266518023080, 0.30469719964297729,
                                   0.09635371475468515, 0.03933623932844291, 0.84628437532163450, 0.26761861742291570,
                                   0.06307831305050400, 0.01685838828361839, 0.00596034033761120, 0.93560257962738880,
                                   0.24157154730437160, 0.04565273128546023, 0.00931882475114763, 0.00219646805807518,
                                   0.00069458418713245 };
    double real = 1.0, imaginary = 0.0, top = 1.0;
    for (int m = 0; m < bands; ++m) {
        double q = top, before = 0.0, turned;
        for (int l = m; l < bands; ++l) {
            const double k = norm[l * (l + 1) / 2 + m] * q,
                         next = ((2 * l + 1) * d[2] * q - (l + m) * before) / (l + 1 - m);
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

static const signed char ssgi__sh_band[SSGI__SH_MOST] = { 0, 1, 1, 1, 2, 2, 2, 2, 2, 3, 3, 3, 3, 3, 3, 3, 4, 4,
                                                          4, 4, 4, 4, 4, 4, 4, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5, 5 };

SSGI__FN int ssgi__sh_limit(int bands) { return ssgi__clamp(bands, 0, SSGI_SH_MAX_BANDS); }

SSGI_DEF void ssgi_sh_basis(float *out, int bands, const float direction[3])
{
    double d[3], basis[SSGI__SH_MOST];
    bands = ssgi__sh_limit(bands);
    ssgi__doubles(d, direction);
    ssgi__sh_basis(basis, bands, d);
    for (int i = 0; i < bands * bands; ++i) out[i] = (float)basis[i];
}

SSGI_DEF float ssgi_sh_cosine(int l)
{
    static const float a[5] = { 3.14159265f, 2.09439510f, 0.785398163f, 0.0f, -0.130899694f };
    return l >= 0 && l < 5 ? a[l] : 0.0f;
}

/* Writes the sine and the cosine of the angle between +y and a row of an environment image; the row is `at` rows from
   the top. Returns the solid angle of a texel there. */
SSGI__FN double ssgi__equirect_row(double polar[2], double at, int width, int height)
{
    polar[0] = sin(SSGI__PI * at / height);
    polar[1] = cos(SSGI__PI * at / height);
    return 4.0 * SSGI__PI / width * polar[0] * sin(0.5 * SSGI__PI / height);
}

/* Writes the direction of a place in an environment image: `at` columns from the left edge, in a row whose angle has
   the sine and cosine `polar`. */
SSGI__FN void ssgi__equirect(double direction[3], const double polar[2], double at, int width)
{
    const double longitude = SSGI__PI * (1.0 - 2.0 * at / width);
    direction[0] = polar[0] * sin(longitude);
    direction[1] = polar[1];
    direction[2] = polar[0] * cos(longitude);
}

SSGI__FN ssgi_result ssgi__equirect_bad(const float *rgb, int width, int height, const char **why)
{
    SSGI__THERE(rgb);
    SSGI__SIZE(width, height);
    return SSGI_OK;
}

/* Adds the light of a texel to the coefficients `sum`. weight is the texel's solid angle. */
SSGI__FN void ssgi__sh_add(double *sum, int bands, const double direction[3], const float *rgb, double weight)
{
    double basis[SSGI__SH_MOST], light[3];
    ssgi__sh_basis(basis, bands, direction);
    ssgi__light3(light, rgb, -1e24f, weight);
    for (int i = 0; i < bands * bands; ++i) ssgi__along(sum + 3 * i, sum + 3 * i, basis[i], light);
}

SSGI__FN ssgi_result ssgi__sh_bad(const float *coefficients, int bands, const char **why)
{
    SSGI__THERE(coefficients);
    SSGI__RANGE(bands, 1, SSGI_SH_MAX_BANDS);
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_sh_project_equirect(float *out, int bands, const float *rgb, int width, int height,
                                              const char **why)
{
    double sum[3 * SSGI__SH_MOST] = { 0.0 };
    SSGI__THERE(out);
    SSGI__TRY(ssgi__sh_bad(out, bands, why));
    SSGI__TRY(ssgi__equirect_bad(rgb, width, height, why));
    for (int y = 0; y < height; ++y) {
        double polar[2], direction[3], weight = ssgi__equirect_row(polar, y + 0.5, width, height);
        for (int x = 0; x < width; ++x, rgb += 3) {
            ssgi__equirect(direction, polar, x + 0.5, width);
            ssgi__sh_add(sum, bands, direction, rgb, weight);
        }
    }
    for (int i = 0; i < 3 * bands * bands; ++i) out[i] = (float)sum[i];
    return SSGI_OK;
}

/* Returns the solid angle of the rectangle from (0,0) to (x,y) at distance 1, negative if x y is. */
SSGI__FN double ssgi__rectangle(double x, double y) { return atan(x * y / sqrt(x * x + y * y + 1.0)); }

/* Writes the unit direction of a place on a face, with s and t in [-1,1], by OpenGL 4.6, table 8.19. */
SSGI__FN void ssgi__cube_direction(double out[3], int face, double s, double t)
{
    static const signed char across[6][3] = { { 0, 0, -1 }, { 0, 0, 1 }, { 1, 0, 0 },
                                              { 1, 0, 0 },  { 1, 0, 0 }, { -1, 0, 0 } };
    static const signed char down[6][3] = { { 0, -1, 0 }, { 0, -1, 0 }, { 0, 0, 1 },
                                            { 0, 0, -1 }, { 0, -1, 0 }, { 0, -1, 0 } };
    for (int i = 0; i < 3; ++i) out[i] = s * across[face][i] + t * down[face][i];
    out[face / 2] = face & 1 ? -1.0 : 1.0;
    ssgi__normalise(out);
}

/* Returns the face of GL's cube map that a direction meets, and in `at` the place on it, in [-1,1]. */
SSGI__FN int ssgi__cube_place(float at[2], const float w[3])
{
    const float x = fabsf(w[0]), y = fabsf(w[1]), z = fabsf(w[2]);
    if (x >= y && x >= z) {
        at[0] = (w[0] < 0.0f ? w[2] : -w[2]) / x;
        at[1] = -w[1] / x;
        return w[0] < 0.0f;
    }
    if (y >= z) {
        at[0] = w[0] / y;
        at[1] = (w[1] < 0.0f ? -w[2] : w[2]) / y;
        return 2 + (w[1] < 0.0f);
    }
    at[0] = (w[2] < 0.0f ? -w[0] : w[0]) / z;
    at[1] = -w[1] / z;
    return 4 + (w[2] < 0.0f);
}

SSGI_DEF ssgi_result ssgi_sh_project_cube(float *out, int bands, const float *const faces[6], int size,
                                          const char **why)
{
    double sum[3 * SSGI__SH_MOST] = { 0.0 };
    SSGI__THERE(out);
    SSGI__TRY(ssgi__sh_bad(out, bands, why));
    SSGI__THERE(faces);
    for (int face = 0; face < 6; ++face) SSGI__CHECK(faces[face], "faces: all six must be there, none NULL");
    SSGI__RANGE(size, 1, 65536);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x) {
            const double s = (2 * x + 1.0) / size - 1.0, t = (2 * y + 1.0) / size - 1.0, h = 1.0 / size;
            const double weight = ssgi__rectangle(s + h, t + h) - ssgi__rectangle(s - h, t + h)
                                - ssgi__rectangle(s + h, t - h) + ssgi__rectangle(s - h, t - h);
            for (int face = 0; face < 6; ++face) {
                double direction[3];
                ssgi__cube_direction(direction, face, s, t);
                ssgi__sh_add(sum, bands, direction, faces[face] + 3 * ((size_t)y * (size_t)size + (size_t)x), weight);
            }
        }
    for (int i = 0; i < 3 * bands * bands; ++i) out[i] = (float)sum[i];
    return SSGI_OK;
}

SSGI_DEF void ssgi_sh_window(float *out, int bands, int window)
{
    double positive = 1.0;
    bands = ssgi__sh_limit(bands);
    for (int l = 0; l < bands; ++l) {
        const double hann = 0.5 + 0.5 * cos(SSGI__PI * l / bands);
        out[l] = (float)(window == SSGI_SH_WINDOW_HANN ? hann : window == SSGI_SH_WINDOW_POSITIVE ? positive : 1.0);
        positive *= (bands - 1.0 - l) / (bands + 1.0 + l); /* p!(p+1)! / ((p-l)!(p+l+1)!), p = bands - 1 */
    }
}

SSGI_DEF void ssgi_sh_zonal(float *out, int bands, const float *zonal, const float direction[3])
{
    bands = ssgi__sh_limit(bands);
    ssgi_sh_basis(out, bands, direction);
    for (int i = 0; i < bands * bands; ++i)
        out[i] *= zonal[ssgi__sh_band[i]] * (float)sqrt((4.0 * SSGI__PI) / (2 * ssgi__sh_band[i] + 1));
}

SSGI_DEF void ssgi_sh_rotate(float *out, int bands, const float *coefficients, int channels, const float *m)
{
    static const float none[12] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0 };
    /* Gauss and Legendre's 6 heights by 11 azimuths are exact for products of two functions of 6 bands */
    static const double gauss[3][2] = { { 0.23861918608319691, 0.46791393457269105 },
                                        { 0.66120938646626451, 0.36076157304813861 },
                                        { 0.93246951420315203, 0.17132449237917034 } };
    /* the matrix is block-diagonal by bands: each row keeps its own band */
    double matrix[SSGI__SH_MOST][2 * SSGI_SH_MAX_BANDS - 1], of[SSGI__SH_MOST], here[SSGI__SH_MOST];
    double there[SSGI__SH_MOST], view[3], world[3], weight;
    bands = ssgi__sh_limit(bands);
    memset(matrix, 0, sizeof matrix);
    if (!m) m = none;
    for (int node = 0; node < 66; ++node) {
        const double *height = gauss[node / 22];
        ssgi__polar(view, node % 2 ? height[0] : -height[0], 2.0 * SSGI__PI * (node / 2 % 11) / 11);
        weight = height[1] * 2.0 * SSGI__PI / 11;
        for (int i = 0; i < 3; ++i)
            world[i] = (double)m[4 * i] * view[0] + (double)m[4 * i + 1] * view[1] + (double)m[4 * i + 2] * view[2];
        ssgi__sh_basis(here, bands, view);
        ssgi__sh_basis(there, bands, world);
        for (int i = 0; i < bands * bands; ++i) {
            const int l = ssgi__sh_band[i];
            for (int j = 0; j < 2 * l + 1; ++j) matrix[i][j] += weight * here[i] * there[l * l + j];
        }
    }
    for (int c = 0; c < channels; ++c) {
        for (int i = 0; i < bands * bands; ++i) of[i] = (double)coefficients[(size_t)channels * (size_t)i + (size_t)c];
        for (int i = 0; i < bands * bands; ++i) {
            const int l = ssgi__sh_band[i];
            double sum = 0.0;
            for (int j = 0; j < 2 * l + 1; ++j) sum += matrix[i][j] * of[l * l + j];
            out[(size_t)channels * (size_t)i + (size_t)c] = (float)sum;
        }
    }
}

SSGI_DEF void ssgi_sh_energy(float *out, int bands, const float *coefficients, int channels)
{
    bands = ssgi__sh_limit(bands);
    for (int l = 0; l < bands; ++l) out[l] = 0.0f;
    for (int i = 0; i < bands * bands; ++i)
        for (int c = 0; c < channels; ++c) {
            const float k = coefficients[(size_t)channels * (size_t)i + (size_t)c];
            out[ssgi__sh_band[i]] += k * k;
        }
}

/* Writes a cap's factors for all bands: the means of the Legendre polynomials over [cosine, 1]. They have a recurrence
   of their own, as differences of polynomials would cancel near cosine 1. */
SSGI__FN void ssgi__sh_cap(double mean[SSGI_SH_MAX_BANDS], double cosine)
{
    mean[0] = 1.0;
    mean[1] = 0.5 + 0.5 * cosine;
    for (int l = 2; l < SSGI_SH_MAX_BANDS; ++l)
        mean[l] = ((2 * l - 1) * cosine * mean[l - 1] - (l - 2) * mean[l - 2]) / (l + 1);
}

/* Makes a unit vector of v. Returns 0 if v is NULL, not finite or 0. */
SSGI__FN int ssgi__direction(double d[3], const float *v)
{
    if (!ssgi__finites(v, 3)) return 0;
    ssgi__doubles(d, v);
    return ssgi__normalise(d) > 0.0;
}

SSGI_DEF ssgi_result ssgi_sh_light(float *coefficients, int bands, const float direction[3], float sine,
                                   const float irradiance[3], int window, const char **why)
{
    double d[3], basis[SSGI__SH_MOST], factor[SSGI_SH_MAX_BANDS], facing = 0.0;
    float weight[SSGI_SH_MAX_BANDS];
    SSGI__TRY(ssgi__sh_bad(coefficients, bands, why));
    SSGI__CHECK(ssgi__direction(d, direction), "direction: must be there, finite and not 0");
    SSGI__CHECK(ssgi__within(sine, 0.0f, 1.0f), "sine: must be 0..1");
    SSGI__CHECK(ssgi__finites(irradiance, 3), "irradiance: must be there and finite");
    SSGI__CHECK(window >= SSGI_SH_WINDOW_NONE && window <= SSGI_SH_WINDOW_POSITIVE,
                "window: must be one of SSGI_SH_WINDOW_");
    ssgi_sh_window(weight, bands, window);
    ssgi__sh_cap(factor, sqrt(1.0 - (double)sine * (double)sine));
    for (int l = 0; l < bands; ++l) {
        factor[l] *= (double)weight[l];
        facing += factor[l] * (double)ssgi_sh_cosine(l) * (2 * l + 1) / (4.0 * SSGI__PI);
    }
    if (bands == 1) facing = 1.0;
    ssgi__sh_basis(basis, bands, d);
    for (int i = 0; i < bands * bands; ++i)
        for (int c = 0; c < 3; ++c)
            coefficients[3 * i + c] += (float)(factor[ssgi__sh_band[i]] * basis[i]
                                               * (ssgi__light(irradiance[c], -1e24f) / facing));
    return SSGI_OK;
}

/* ==== >>environment (implementation) =========================================================================== */

#define SSGI__CELLS_X 96
#define SSGI__CELLS_Y 48

SSGI_DEF void ssgi_octahedral_encode(float out[2], const float d[3])
{
    const double x = (double)d[0], y = (double)d[1], ax = fabs(x), ay = fabs(y), sum = ax + ay + fabs((double)d[2]),
                 scale = sum > 0.0 ? 1.0 / sum : 0.0;
    out[0] = (float)(d[2] < 0.0f ? (1.0 - ay * scale) * (x < 0.0 ? -1.0 : 1.0) : x * scale);
    out[1] = (float)(d[2] < 0.0f ? (1.0 - ax * scale) * (y < 0.0 ? -1.0 : 1.0) : y * scale);
}

SSGI_DEF void ssgi_octahedral_decode(float out[3], const float e[2])
{
    double n[3] = { (double)e[0], (double)e[1], 0.0 }, t;
    n[2] = 1.0 - fabs(n[0]) - fabs(n[1]);
    t = n[2] < 0.0 ? -n[2] : 0.0;
    for (int i = 0; i < 2; ++i) n[i] += n[i] < 0.0 ? t : -t;
    ssgi__normalise(n);
    ssgi__floats(out, n);
}

/* Writes the unit direction of texel number `texel` of an octahedral map. */
SSGI__FN void ssgi__octahedral_texel(float out[3], int texel, int size)
{
    const float e[2] = { (2.0f * (float)(texel % size) + 1.0f) / (float)size - 1.0f,
                         (2.0f * (float)(texel / size) + 1.0f) / (float)size - 1.0f };
    ssgi_octahedral_decode(out, e);
}

/* Writes the intersection of [a, a + la] and [b, b + lb]. */
SSGI__FN void ssgi__overlap(int *begin, int *end, int a, int la, int b, int lb)
{
    *begin = a > b ? a : b;
    *end = a + la < b + lb ? a + la : b + lb;
}

/* Averages the image, whose texels are constant, over cells of exact solid angle; cells may be smaller than texels. */
SSGI__FN void ssgi__environment_cells(float cell[SSGI__CELLS_Y][SSGI__CELLS_X][3], const float *rgb, int width,
                                      int height)
{
    /* rows are in units of 1 / (CELLS_Y * height), columns in units of 1 / (CELLS_X * width) */
    for (int i = 0; i < SSGI__CELLS_Y; ++i) {
        const double unit = (double)height * SSGI__CELLS_Y;
        double sum[SSGI__CELLS_X][3] = { { 0.0 } }, light[3], area = 0.0;
        for (int y = i * height / SSGI__CELLS_Y; y * SSGI__CELLS_Y < (i + 1) * height; ++y) {
            const float *row = rgb + 3 * (size_t)y * (size_t)width;
            int top, bottom, left, right;
            ssgi__overlap(&top, &bottom, y * SSGI__CELLS_Y, SSGI__CELLS_Y, i * height, height);
            const double weight = cos(SSGI__PI * top / unit) - cos(SSGI__PI * bottom / unit);
            area += weight * width;
            for (int j = 0; j < SSGI__CELLS_X; ++j)
                for (int x = j * width / SSGI__CELLS_X; x * SSGI__CELLS_X < (j + 1) * width; ++x) {
                    ssgi__overlap(&left, &right, x * SSGI__CELLS_X, SSGI__CELLS_X, j * width, width);
                    ssgi__light3(light, row + 3 * x, 0.0f, 1.0);
                    ssgi__along(sum[j], sum[j], weight * (right - left), light);
                }
        }
        for (int j = 0; j < SSGI__CELLS_X; ++j)
            for (int c = 0; c < 3; ++c) cell[i][j][c] = (float)(sum[j][c] / area);
    }
}

/* Averages the environment about every direction of an octahedral map. The weight of a cell is 0 up to the cosine
   `least`. Beyond, it is exp(kappa (cosine - 1)), or with kappa 0 the cosine times a ramp, slope (cosine - least) but
   at most 1. */
SSGI__FN ssgi_result ssgi__environment_lobes(float *out, int size, const float *rgb, int width, int height, float kappa,
                                             float least, float slope, const char **why)
{
    float cell[SSGI__CELLS_Y][SSGI__CELLS_X][3], around[SSGI__CELLS_X][2], polar[SSGI__CELLS_Y][3];
    SSGI__THERE(out);
    SSGI__RANGE(size, 8, 256);
    SSGI__TRY(ssgi__equirect_bad(rgb, width, height, why));
    ssgi__environment_cells(cell, rgb, width, height);
    for (int i = 0; i < SSGI__CELLS_Y; ++i) {
        double p[3];
        p[2] = ssgi__equirect_row(p, i + 0.5, SSGI__CELLS_X, SSGI__CELLS_Y);
        ssgi__floats(polar[i], p);
    }
    for (int j = 0; j < SSGI__CELLS_X; ++j) {
        const double level[2] = { 1.0, 0.0 };
        double d[3];
        ssgi__equirect(d, level, j + 0.5, SSGI__CELLS_X);
        around[j][0] = (float)d[0];
        around[j][1] = (float)d[2];
    }
    for (int texel = 0; texel < size * size; ++texel) {
        float d[3], flat[SSGI__CELLS_X], most = -1.0f;
        double sum[3] = { 0, 0, 0 }, all = 0.0;
        ssgi__octahedral_texel(d, texel, size);
        for (int j = 0; j < SSGI__CELLS_X; ++j) {
            flat[j] = d[0] * around[j][0] + d[2] * around[j][1];
            most = flat[j] > most ? flat[j] : most;
        }
        for (int i = 0; i < SSGI__CELLS_Y; ++i) {
            if (d[1] * polar[i][1] + most * polar[i][0] <= least) continue;
            for (int j = 0; j < SSGI__CELLS_X; ++j) {
                const float cosine = d[1] * polar[i][1] + flat[j] * polar[i][0], ramp = (cosine - least) * slope;
                if (cosine <= least) continue;
                const double weight = kappa > 0.0f ? (double)(polar[i][2] * expf(kappa * (cosine - 1.0f)))
                                                   : (double)(polar[i][2] * (ramp < 1.0f ? ramp * cosine : cosine));
                all += weight;
                for (int c = 0; c < 3; ++c) sum[c] += weight * (double)cell[i][j][c];
            }
        }
        for (int c = 0; c < 3; ++c) out[3 * (size_t)texel + (size_t)c] = (float)(sum[c] / all);
    }
    return SSGI_OK;
}

#define SSGI__STEEP 1e30f /* a slope so steep that there is no ramp */

SSGI_DEF ssgi_result ssgi_environment_map(float *out, int size, const float *rgb, int width, int height,
                                          float solid_angle, const char **why)
{
    const float kappa = solid_angle > 0.0f ? 12.5663706f / (solid_angle > 0.05f ? solid_angle : 0.05f) : 0.0f;
    SSGI__CHECK(ssgi__positive(&solid_angle, 1), "solid_angle: must be finite, 0 or above");
    /* beyond cosine 1 - 16 / kappa the lobe is below 1e-7 of its peak */
    return ssgi__environment_lobes(out, size, rgb, width, height, kappa, kappa > 0.0f ? 1.0f - 16.0f / kappa : 0.0f,
                                   SSGI__STEEP, why);
}

SSGI_DEF ssgi_result ssgi_environment_cone(float *out, int size, const float *rgb, int width, int height, float cosine,
                                           const char **why)
{
    /* a cell's width, as a difference of cosines at the rim */
    const float half = ssgi__min(0.0654498469f * sqrtf(ssgi__max(0.0f, 1.0f - cosine * cosine)), cosine);
    SSGI__CHECK(ssgi__within(cosine, 0.0f, 0.95f), "cosine: must be 0..0.95");
    return ssgi__environment_lobes(out, size, rgb, width, height, 0.0f, cosine - half,
                                   half > 0.0f ? 0.5f / half : SSGI__STEEP, why);
}

typedef struct ssgi__region {
    int lower[2], upper[2]; /* columns, rows */
    double energy;
} ssgi__region;

#define SSGI__REGION_BINS 256

/* Sums luminance times solid angle over the lines of a region of the image, which are columns (axis 0) or rows (1).
   Each bin sums 2^shift lines. */
SSGI__FN void ssgi__region_bins(double bin[SSGI__REGION_BINS], const ssgi__region *r, int axis, int shift,
                                const float *rgb, int width, int height)
{
    memset(bin, 0, SSGI__REGION_BINS * sizeof *bin);
    for (int y = r->lower[1]; y < r->upper[1]; ++y) {
        const float *p = rgb + 3 * ((size_t)y * (size_t)width + (size_t)r->lower[0]);
        double polar[2], light[3], weight = ssgi__equirect_row(polar, y + 0.5, width, height);
        for (int x = r->lower[0]; x < r->upper[0]; ++x, p += 3)
            bin[((axis ? y : x) - r->lower[axis]) >> shift] += weight * ssgi__light3(light, p, 0.0f, 1.0);
    }
}

/* Cuts a region of at least two texels, across its wider side, into halves of equal luminance; the other half goes to
   *rest. */
SSGI__FN void ssgi__region_split(ssgi__region *region, ssgi__region *rest, const float *rgb, int width, int height)
{
    double bin[SSGI__REGION_BINS], polar[2], before = 0.0;
    const double half = 0.5 * region->energy;
    ssgi__region part = *region;
    const int columns = part.upper[0] - part.lower[0], rows = part.upper[1] - part.lower[1];
    int axis, shift = 0, last, b, cut;
    ssgi__equirect_row(polar, 0.5 * (part.lower[1] + part.upper[1]), width, height);
    axis = rows > 1 && (columns < 2 || 2.0 * columns * polar[0] / width <= (double)rows / height);
    while ((part.upper[axis] - part.lower[axis] - 1) >> shift >= SSGI__REGION_BINS) ++shift;
    for (;; shift = 0) { /* if the side has more than 256 lines: first finds the bin, then the line in it */
        ssgi__region_bins(bin, &part, axis, shift, rgb, width, height);
        last = (part.upper[axis] - part.lower[axis] - 1) >> shift;
        for (b = 0; b < last && before + bin[b] < half; ++b) before += bin[b];
        cut = part.lower[axis] + (b << shift);
        if (!shift) break;
        part.lower[axis] = cut;
        if (part.upper[axis] > cut + (1 << shift)) part.upper[axis] = cut + (1 << shift);
    }
    /* the cut is before or after the line that holds the median, whichever is nearer to the median */
    if (cut == region->lower[axis] || (cut + 1 < region->upper[axis] && before + bin[b] - half < half - before)) {
        before += bin[b];
        ++cut;
    }
    *rest = *region;
    rest->lower[axis] = region->upper[axis] = cut;
    rest->energy = region->energy - before;
    region->energy = before;
}

/* Makes the sun that replaces a region of the environment image. */
SSGI__FN void ssgi__region_sun(ssgi_sun *sun, const ssgi__region *r, const float *rgb, int width, int height)
{
    double total[3] = { 0, 0, 0 }, mean[3] = { 0, 0, 0 }, polar[2], d[3], light[3], energy = 0.0;
    for (int y = r->lower[1]; y < r->upper[1]; ++y) {
        const float *p = rgb + 3 * ((size_t)y * (size_t)width + (size_t)r->lower[0]);
        const double weight = ssgi__equirect_row(polar, y + 0.5, width, height);
        for (int x = r->lower[0]; x < r->upper[0]; ++x, p += 3) {
            const double luminance = ssgi__light3(light, p, 0.0f, weight);
            energy += luminance;
            ssgi__equirect(d, polar, x + 0.5, width);
            ssgi__along(total, total, 1.0, light);
            ssgi__along(mean, mean, luminance, d);
        }
    }
    if (!(ssgi__normalise(mean) > 1e-6 * energy)) { /* the region is dark, or its light comes evenly from all around */
        ssgi__equirect_row(polar, 0.5 * (r->lower[1] + r->upper[1]), width, height);
        ssgi__equirect(mean, polar, 0.5 * (r->lower[0] + r->upper[0]), width);
    }
    ssgi__floats(sun->direction, mean);
    ssgi__floats(sun->irradiance, total);
}

SSGI_DEF ssgi_result ssgi_environment_suns(ssgi_sun *out, int count, const float *rgb, int width, int height,
                                           const char **why)
{
    ssgi__region region[1024] = { { { 0, 0 }, { width, height }, 0.0 } };
    double bin[SSGI__REGION_BINS];
    int n;
    SSGI__THERE(out);
    SSGI__RANGE(count, 1, 1024);
    SSGI__TRY(ssgi__equirect_bad(rgb, width, height, why));
    ssgi__region_bins(bin, &region[0], 0, 16, rgb, width, height); /* bin 0 has the sum of all columns */
    region[0].energy = bin[0];
    for (n = 1; n < count; ++n) {
        int most = -1;
        for (int i = 0; i < n; ++i) {
            const ssgi__region *r = &region[i];
            if ((r->upper[0] - r->lower[0] > 1 || r->upper[1] - r->lower[1] > 1)
                && (most < 0 || r->energy > region[most].energy))
                most = i;
        }
        if (most < 0) break;
        ssgi__region_split(&region[most], &region[n], rgb, width, height);
    }
    /* when no region is left to split, the other suns are dark: their regions have no texels and lie at +y */
    for (int i = 0; i < count; ++i) ssgi__region_sun(&out[i], &region[i], rgb, width, height);
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_sh_residual(float *map, int size, const float *coefficients, int bands, const ssgi_sun *suns,
                                      int count, const char **why)
{
    SSGI__THERE(map);
    SSGI__RANGE(size, 8, 256);
    SSGI__TRY(ssgi__sh_bad(coefficients, bands, why));
    SSGI__CHECK(count >= 0 && (!count || suns), "suns: must not be NULL when count is not 0");
    for (int texel = 0; texel < size * size; ++texel, map += 3) {
        float n[3], basis[SSGI__SH_MOST];
        double sum[3] = { 0, 0, 0 }, normal[3], v[3];
        ssgi__octahedral_texel(n, texel, size);
        ssgi__doubles(normal, n);
        ssgi_sh_basis(basis, bands, n);
        for (int i = 0; i < bands * bands; ++i) {
            ssgi__doubles(v, coefficients + 3 * i);
            ssgi__along(sum, sum, -((double)ssgi_sh_cosine(ssgi__sh_band[i]) * (double)basis[i]), v);
        }
        for (int i = 0; i < count; ++i) {
            ssgi__doubles(v, suns[i].direction);
            const double cosine = ssgi__dot(normal, v);
            ssgi__doubles(v, suns[i].irradiance);
            if (cosine > 0.0) ssgi__along(sum, sum, cosine, v);
        }
        for (int c = 0; c < 3; ++c) map[c] += (float)(sum[c] / SSGI__PI);
    }
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_vpl_choose(ssgi_vpl *out, int count, const float *position, const float *normal,
                                     const float *flux, size_t pixels, const char **why)
{
    double rgb[3], total = 0.0, sum, here;
    size_t k, last = 0;
    SSGI__THERE(out);
    SSGI__RANGE(count, 1, 4096);
    SSGI__THERE3(position, normal, flux);
    SSGI__CHECK(pixels > 0, "pixels: must be 1 or more");
    for (k = 0; k < pixels; ++k) {
        here = ssgi__light3(rgb, flux + 3 * k, 0.0f, 1.0);
        total += here;
        if (here > 0.0) last = k;
    }
    SSGI__CHECK(total > 0.0, "flux: must be above 0 somewhere");
    sum = here = ssgi__light3(rgb, flux, 0.0f, 1.0);
    k = 0; /* k stays at or before `last`, the last pixel with flux, since rounding may miss the end */
    for (int i = 0; i < count; ++i) {
        const double at = (i + (double)ssgi_radical_inverse(2, (uint32_t)i)) / count * total;
        while (k < last && sum <= at) sum += here = ssgi__light3(rgb, flux + 3 * ++k, 0.0f, 1.0);
        memcpy(out[i].position, position + 3 * k, sizeof out[i].position);
        memcpy(out[i].normal, normal + 3 * k, sizeof out[i].normal);
        for (int c = 0; c < 3; ++c) out[i].intensity[c] = (float)(rgb[c] / here * (total / (SSGI__PI * count)));
    }
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_vpl_area(ssgi_vpl *out, int count, const float corner[3], const float a[3], const float b[3],
                                   int triangle, const float radiance[3], const char **why)
{
    double from[3], side[2][3], normal[3], area;
    SSGI__THERE(out);
    SSGI__RANGE(count, 1, 4096);
    SSGI__CHECK(ssgi__finites(corner, 3), "corner: must be there and finite");
    SSGI__CHECK(ssgi__finites(a, 3), "a: must be there and finite");
    SSGI__CHECK(ssgi__finites(b, 3), "b: must be there and finite");
    SSGI__RANGE(triangle, 0, 1);
    SSGI__CHECK(ssgi__finites(radiance, 3) && ssgi__positive(radiance, 3),
                "radiance: must be there, finite and 0 or more");
    ssgi__doubles(from, corner);
    ssgi__doubles(side[0], a);
    ssgi__doubles(side[1], b);
    ssgi__cross(normal, side[0], side[1]);
    area = ssgi__normalise(normal) * (triangle ? 0.5 : 1.0);
    SSGI__CHECK(area >= 1e-30 && area <= 1e13, "a: must span an area of 1e-30..1e13 with b");
    for (int c = 0; c < 3; ++c)
        SSGI__CHECK(fabs(from[c]) + fabs(side[0][c]) + fabs(side[1][c]) < 1e30,
                    "corner: must lie within 1e30 of the origin, as a and b from it");
    for (int i = 0; i < count; ++i) {
        double u = (i + 0.5) / count, v = fmod(0.5 + 0.61803398874989484820 * i, 1.0), p[3];
        double *const greater = v > u ? &v : &u, *const less = v > u ? &u : &v;
        if (triangle) { /* the square is folded onto one half, where the points are as even as before */
            *less *= 0.5;
            *greater -= *less;
        }
        ssgi__along(p, from, u, side[0]);
        ssgi__along(p, p, v, side[1]);
        ssgi__floats(out[i].position, p);
        ssgi__floats(out[i].normal, normal);
        for (int c = 0; c < 3; ++c) out[i].intensity[c] = (float)(ssgi__light(radiance[c], 0.0f) * area / count);
    }
    return SSGI_OK;
}

/* ==== >>trace (implementation) ================================================================================= */

/* The BVH is a tree with eight children a node and four triangles a leaf, both laid out so that a loop over them is one
   or two vector operations. A large tree does not fit the caches; with eight children a ray waits for fewer nodes one
   after the other. The tree comes from binary splits at the middle of the longest axis; the left side of a split always
   gets a multiple of four triangles. Every leaf but the last is then full, which bounds the memory: with L leaves there
   are at most 4 L / 7 + 1 nodes, as a node with fewer than eight children has only leaves, two at least. */

#define SSGI__TRACE_LIMIT 1e12f /* products of three such lengths stay finite */
#define SSGI__TRACE_LEAF 0x80000000u
#define SSGI__TRACE_NONE 0xffffffffu
#define SSGI__TRACE_DEEP 32 /* binary levels that split in the middle; at most 30 more split by count */
#define SSGI__TRACE_WIDE 8  /* children of a node */
#define SSGI__TRACE_STACK ((SSGI__TRACE_WIDE - 1) * (SSGI__TRACE_DEEP + 30) + SSGI__TRACE_WIDE)

typedef struct ssgi__trace_node {
    float bound[2][3][SSGI__TRACE_WIDE]; /* [0 lower, 1 upper][axis][child] */
    uint32_t child[SSGI__TRACE_WIDE];    /* number of a node, or number of a block + SSGI__TRACE_LEAF */
} ssgi__trace_node;

typedef struct ssgi__trace_block {
    float corner[3][3][4]; /* [corner][axis][triangle] */
    uint32_t triangle[4];
} ssgi__trace_block;

typedef struct ssgi__trace_item {
    float lower[3], upper[3];
    uint32_t triangle;
} ssgi__trace_item;

/* A range of items, which are triangles with their bounds, that becomes one child of a node. */
typedef struct ssgi__trace_range {
    uint32_t first, count, depth;
    float lower[3], upper[3];   /* bounds */
    float clower[3], cupper[3]; /* bounds of the items' centres, times two */
} ssgi__trace_range;

typedef struct ssgi__trace_job {
    ssgi__trace_node *nodes;
    ssgi__trace_block *blocks;
    ssgi__trace_item *items;
    uint32_t node_count;
    const char *position;
    size_t stride;
    const uint32_t *index;
} ssgi__trace_job;

/* Returns whether a point or a direction is finite and within the limit, by the bits: -ffast-math may drop any
   comparison. */
static int ssgi__trace_sane(const float v[3])
{
    const float limit = SSGI__TRACE_LIMIT;
    uint32_t bits[3], most;
    memcpy(bits, v, sizeof bits);
    memcpy(&most, &limit, sizeof most);
    return (bits[0] & 0x7fffffffu) <= most && (bits[1] & 0x7fffffffu) <= most && (bits[2] & 0x7fffffffu) <= most;
}

SSGI_DEF size_t ssgi_trace_size(size_t triangles)
{
    const size_t most = (size_t)-1, blocks = (triangles + 3) / 4, nodes = blocks * 4 / 7 + 1;
    if (triangles == 0 || triangles > SSGI_TRACE_MAX_TRIANGLES) return 0;
    if (blocks > (most - 1024) / (sizeof(ssgi__trace_block) + sizeof(ssgi__trace_node))) return 0;
    return 64 + blocks * sizeof(ssgi__trace_block) + nodes * sizeof(ssgi__trace_node);
}

static const float *ssgi__trace_corner(const ssgi__trace_job *job, uint32_t triangle, uint32_t corner)
{
    const size_t k = (size_t)triangle * 3 + corner;
    return (const float *)(const void *)(job->position + (job->index ? (size_t)job->index[k] : k) * job->stride);
}

/* Fills an item with a triangle's bounds. Returns 0 if the triangle has no area, or is not finite or too far out. */
SSGI__FN int ssgi__trace_item_set(const ssgi__trace_job *job, uint32_t triangle, ssgi__trace_item *item)
{
    const float *a = ssgi__trace_corner(job, triangle, 0), *b = ssgi__trace_corner(job, triangle, 1),
                *c = ssgi__trace_corner(job, triangle, 2);
    double e[3], f[3];
    if (!ssgi__trace_sane(a) || !ssgi__trace_sane(b) || !ssgi__trace_sane(c)) return 0;
    for (int i = 0; i < 3; i++) {
        item->lower[i] = ssgi__min(a[i], ssgi__min(b[i], c[i]));
        item->upper[i] = ssgi__max(a[i], ssgi__max(b[i], c[i]));
        e[i] = (double)b[i] - (double)a[i];
        f[i] = (double)c[i] - (double)a[i];
    }
    item->triangle = triangle;
    return e[1] * f[2] != e[2] * f[1] || e[2] * f[0] != e[0] * f[2] || e[0] * f[1] != e[1] * f[0];
}

SSGI__FN void ssgi__trace_grow(float lower[3], float upper[3], const float l[3], const float u[3])
{
    for (int i = 0; i < 3; i++) {
        lower[i] = ssgi__min(lower[i], l[i]);
        upper[i] = ssgi__max(upper[i], u[i]);
    }
}

/* Sets the bounds of a range from its items. */
SSGI__FN void ssgi__trace_bound(const ssgi__trace_item *items, ssgi__trace_range *range)
{
    for (int i = 0; i < 3; i++) {
        range->lower[i] = range->clower[i] = 4.0f * SSGI__TRACE_LIMIT;
        range->upper[i] = range->cupper[i] = -4.0f * SSGI__TRACE_LIMIT;
    }
    for (uint32_t k = range->first; k < range->first + range->count; k++) {
        float centre[3];
        for (int i = 0; i < 3; i++) centre[i] = items[k].lower[i] + items[k].upper[i];
        ssgi__trace_grow(range->lower, range->upper, items[k].lower, items[k].upper);
        ssgi__trace_grow(range->clower, range->cupper, centre, centre);
    }
}

static float ssgi__trace_area(const float lower[3], const float upper[3])
{
    const float x = upper[0] - lower[0], y = upper[1] - lower[1], z = upper[2] - lower[2];
    return x * y + y * z + z * x;
}

/* Moves the `want` of `count` items whose centres along an axis are smallest to the front [Hoare 1961]. */
SSGI__FN void ssgi__trace_select(ssgi__trace_item *item, uint32_t count, uint32_t want, int axis)
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

/* Splits a range of more than four items in two, in the middle of the longest axis; the split is moved so that the left
   part gets a multiple of four. */
SSGI__FN void ssgi__trace_split(ssgi__trace_item *items, const ssgi__trace_range *range, ssgi__trace_range *left,
                                ssgi__trace_range *right)
{
    ssgi__trace_item *item = items + range->first;
    const uint32_t n = range->count, last = (n - 1) / 4 * 4;
    uint32_t have = n, want = (n / 2 + 3) / 4 * 4;
    int axis = 0;
    for (int i = 1; i < 3; i++)
        if (range->cupper[i] - range->clower[i] > range->cupper[axis] - range->clower[axis]) axis = i;
    if (range->depth < SSGI__TRACE_DEEP && range->cupper[axis] > range->clower[axis]) {
        const float middle = 0.5f * range->clower[axis] + 0.5f * range->cupper[axis];
        uint32_t k;
        for (have = 0, k = 0; k < n; k++)
            if (item[k].lower[axis] + item[k].upper[axis] <= middle) {
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

/* Makes a leaf of a range's items. The items are read before the block is written, as both share memory: see
   ssgi_trace_build. */
SSGI__FN void ssgi__trace_block_set(ssgi__trace_job *job, const ssgi__trace_range *range)
{
    uint32_t id[4];
    ssgi__trace_block *block = job->blocks + range->first / 4;
    for (uint32_t k = 0; k < 4; k++)
        id[k] = k < range->count ? job->items[range->first + k].triangle : SSGI__TRACE_NONE;
    memset(block, 0, sizeof *block); /* a triangle of zeros has no area and is never hit */
    for (uint32_t k = 0; k < 4; k++) {
        block->triangle[k] = id[k];
        for (uint32_t c = 0; k < range->count && c < 3; c++)
            for (int i = 0; i < 3; i++) block->corner[c][i][k] = ssgi__trace_corner(job, id[k], c)[i];
    }
}

/* Writes the box of child k of a node. A ray that meets a triangle has to enter its box, but corners are rounded when
   they are sheared (ssgi__trace_block_hit), which moves a side by some 1e-7 of its length: the box is wider by more.
   ssgi__trace_boxes covers the rounding that grows with the way to the box. */
SSGI__FN void ssgi__trace_box_set(ssgi__trace_node *node, int k, const ssgi__trace_range *range)
{
    float longest = 0.0f;
    for (int i = 0; i < 3; i++) longest = ssgi__max(longest, range->upper[i] - range->lower[i]);
    for (int i = 0; i < 3; i++) {
        const float l = range->lower[i], u = range->upper[i];
        const float slack = 4e-7f * (longest + (u - l)) + 1.2e-7f * ssgi__max(ssgi__abs(l), ssgi__abs(u));
        node->bound[0][i][k] = l - slack;
        node->bound[1][i][k] = u + slack;
    }
}

/* Makes a node of a range, with all below it, and returns its number. The child whose box has the largest area is split
   until there are eight, or until each child fits into a leaf. */
SSGI__FN uint32_t ssgi__trace_node_set(ssgi__trace_job *job, const ssgi__trace_range *whole)
{
    ssgi__trace_range range[SSGI__TRACE_WIDE];
    const uint32_t self = job->node_count++;
    int count = 1;
    range[0] = *whole;
    while (count < SSGI__TRACE_WIDE) {
        int widest = -1;
        float most = 0.0f;
        for (int k = 0; k < count; k++) {
            const float area = ssgi__trace_area(range[k].lower, range[k].upper);
            if (range[k].count > 4 && (widest < 0 || area > most)) {
                widest = k;
                most = area;
            }
        }
        if (widest < 0) break;
        for (int k = count++; k > widest + 1; k--) range[k] = range[k - 1];
        const ssgi__trace_range both = range[widest];
        ssgi__trace_split(job->items, &both, &range[widest], &range[widest + 1]);
    }
    for (int k = 0; k < SSGI__TRACE_WIDE; k++) {
        ssgi__trace_node *node = job->nodes + self;
        for (int i = 0; i < 3; i++) { /* the box of an empty child is inside out and never entered */
            node->bound[0][i][k] = 2.0f * SSGI__TRACE_LIMIT;
            node->bound[1][i][k] = -2.0f * SSGI__TRACE_LIMIT;
        }
        node->child[k] = SSGI__TRACE_LEAF;
        if (k >= count) continue;
        ssgi__trace_box_set(node, k, &range[k]);
        if (range[k].count > 4) node->child[k] = ssgi__trace_node_set(job, &range[k]);
        else {
            ssgi__trace_block_set(job, &range[k]);
            node->child[k] = SSGI__TRACE_LEAF | range[k].first / 4;
        }
    }
    return self;
}

SSGI__FN ssgi_result ssgi__trace_bad(size_t stride_bytes, size_t triangles, const char **why)
{
    SSGI__CHECK(stride_bytes >= 3 * sizeof(float) && stride_bytes % sizeof(float) == 0,
                "stride_bytes: must be 12 or more, a multiple of 4");
    SSGI__CHECK(ssgi_trace_size(triangles), "triangles: must be 1..SSGI_TRACE_MAX_TRIANGLES");
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_trace_build(ssgi_trace *trace, void *memory, size_t size, const float *position,
                                      size_t stride_bytes, const uint32_t *index, size_t triangles, const char **why)
{
    ssgi__trace_job job = { NULL, NULL, NULL, 0, (const char *)position, stride_bytes, index };
    ssgi__trace_range all = { 0, 0, 0, { 0 }, { 0 }, { 0 }, { 0 } };
    const size_t blocks = (triangles + 3) / 4;
    uint32_t count = 0;
    SSGI__THERE3(trace, memory, position);
    SSGI__TRY(ssgi__trace_bad(stride_bytes, triangles, why));
    SSGI__ENOUGH(size, ssgi_trace_size(triangles), "size: must be at least ssgi_trace_size(triangles)");
    char *base = (char *)memory + (64 - (size_t)((uintptr_t)memory & 63)) % 64;
    job.blocks = (ssgi__trace_block *)(void *)base;
    job.nodes = (ssgi__trace_node *)(void *)(base + blocks * sizeof(ssgi__trace_block));
    /* the items end where the blocks end, and blocks are written in the items' order: as four items are smaller than a
       block, no item is overwritten before it is read */
    job.items = (ssgi__trace_item *)(void *)(base + blocks * (sizeof *job.blocks - 4 * sizeof *job.items));
    for (size_t k = 0; k < triangles; k++)
        count += (uint32_t)ssgi__trace_item_set(&job, (uint32_t)k, &job.items[count]);
    all.count = count;
    ssgi__trace_bound(job.items, &all);
    if (count) ssgi__trace_node_set(&job, &all);
    trace->nodes = job.nodes;
    trace->blocks = job.blocks;
    trace->node_count = job.node_count;
    trace->block_count = (count + 3) / 4;
    trace->triangles = (uint32_t)triangles;
    trace->skipped = (uint32_t)triangles - count;
    return SSGI_OK;
}

/* A ray, prepared for its tests against boxes and triangles. */
typedef struct ssgi__trace_ray {
    float origin[3], direction[3];
    float inverse[3]; /* 1 / direction, finite */
    int sign[3];      /* 1 if the direction is negative */
    /* the same ray with x, y, z permuted so that z is the longest axis of its direction, and sheared along z */
    int axis[3];
    float from[3], slope[2];
} ssgi__trace_ray;

/* Returns 0 for a ray that can hit nothing: it is not finite, too far out, or without direction. */
static int ssgi__trace_ray_set(ssgi__trace_ray *ray, const float origin[3], const float direction[3])
{
    float longest = 0.0f;
    if (!ssgi__trace_sane(origin) || !ssgi__trace_sane(direction)) return 0;
    for (int i = 0; i < 3; i++) {
        ray->origin[i] = origin[i];
        ray->direction[i] = direction[i];
        longest = ssgi__max(ssgi__abs(direction[i]), longest);
    }
    if (!(longest > 1e-18f)) return 0;
    for (int i = 0; i < 3; i++) { /* no infinity, as 0 * infinity would be NaN on the face of a box */
        const float least = ssgi__max(longest * 1e-24f, 1e-37f);
        ray->sign[i] = direction[i] < 0.0f;
        ray->inverse[i] = 1.0f / (ray->sign[i] ? ssgi__min(direction[i], -least) : ssgi__max(direction[i], least));
    }
    ray->axis[2] = longest > ssgi__abs(direction[0]) ? longest > ssgi__abs(direction[1]) ? 2 : 1 : 0;
    ray->axis[0] = (ray->axis[2] + 1) % 3;
    ray->axis[1] = (ray->axis[2] + 2) % 3;
    for (int i = 0; i < 3; i++) ray->from[i] = origin[ray->axis[i]];
    for (int i = 0; i < 2; i++) ray->slope[i] = direction[ray->axis[i]] / direction[ray->axis[2]];
    return 1;
}

/* Writes to at[c][i][k] corner c of triangle k, sheared so that the ray is the z axis, and to inside[k] whether the
   ray's line meets the triangle. The sign of a difference of two products tells on which side of the line an edge lies.
   The products are compared, not subtracted: compilers may fuse a product with a difference, and then the two triangles
   at an edge disagree. As these triangles share sheared corners, too, neither edges nor corners leave gaps [Woop,
   Benthin, Wald 2013]. Compilers must not reorder the sums, either: the difference from the origin comes first, as it
   is exact if it is small. */
static void ssgi__trace_block_hit(const ssgi__trace_block *block, const ssgi__trace_ray *ray, float at[3][2][4],
                                  int inside[4])
{
#if defined(__clang__) && __clang_major__ >= 13
#pragma clang fp reassociate(off)
#endif
    const float ox = ray->from[0], oy = ray->from[1], oz = ray->from[2], sx = ray->slope[0], sy = ray->slope[1];
    const int x = ray->axis[0], y = ray->axis[1], z = ray->axis[2];
    const float *x0 = block->corner[0][x], *y0 = block->corner[0][y], *z0 = block->corner[0][z];
    const float *x1 = block->corner[1][x], *y1 = block->corner[1][y], *z1 = block->corner[1][z];
    const float *x2 = block->corner[2][x], *y2 = block->corner[2][y], *z2 = block->corner[2][z];
    for (int k = 0; k < 4; k++) {
        const float az = z0[k] - oz, ax = x0[k] - ox - sx * az, ay = y0[k] - oy - sy * az;
        const float bz = z1[k] - oz, bx = x1[k] - ox - sx * bz, by = y1[k] - oy - sy * bz;
        const float cz = z2[k] - oz, cx = x2[k] - ox - sx * cz, cy = y2[k] - oy - sy * cz;
        const float a0 = cx * by, a1 = cy * bx, b0 = ax * cy, b1 = ay * cx, c0 = bx * ay, c1 = by * ax;
        at[0][0][k] = ax;
        at[0][1][k] = ay;
        at[1][0][k] = bx;
        at[1][1][k] = by;
        at[2][0][k] = cx;
        at[2][1][k] = cy;
        inside[k] = ((a0 < a1) | (b0 < b1) | (c0 < c1)) ^ ((a0 > a1) | (b0 > b1) | (c0 > c1));
    }
}

/* Returns the t at which the ray meets triangle k, whose corners have these weights. It is the t at the triangle's
   plane, in double precision for small details on large triangles. If that t is not between those of the corners, the
   ray runs along the plane, and the result is the weighted mean of the corners' t. */
static float ssgi__trace_distance(const ssgi__trace_block *block, int k, const ssgi__trace_ray *ray,
                                  const float weight[3], float sum)
{
    double e[3], f[3], z[3], facing = 0.0, height = 0.0, low, high;
    const double way = (double)ray->direction[ray->axis[2]];
    for (int i = 0; i < 3; i++) {
        e[i] = (double)block->corner[1][i][k] - (double)block->corner[0][i][k];
        f[i] = (double)block->corner[2][i][k] - (double)block->corner[0][i][k];
        z[i] = (double)block->corner[i][ray->axis[2]][k] - (double)ray->from[2];
    }
    for (int i = 0; i < 3; i++) {
        const int p = i < 2 ? i + 1 : 0, q = i > 0 ? i - 1 : 2;
        const double normal = e[p] * f[q] - e[q] * f[p];
        facing += normal * (double)ray->direction[i];
        height += normal * ((double)block->corner[0][i][k] - (double)ray->origin[i]);
    }
    low = z[0] < z[1] ? z[0] : z[1];
    low = low < z[2] ? low : z[2];
    high = z[0] > z[1] ? z[0] : z[1];
    high = high > z[2] ? high : z[2];
    if (facing < 0.0 || facing > 0.0) {
        const double t = height / facing, slack = 1e-3 * (fabs(low) + fabs(high));
        if (t * way >= low - slack && t * way <= high + slack) return (float)t;
    }
    const double mean = (double)weight[0] * z[0] + (double)weight[1] * z[1] + (double)weight[2] * z[2];
    return (float)(mean / ((double)sum * way));
}

/* Finds the closest hit in tmin < t < tmax of a leaf's triangles, or with `hit` NULL any hit. Returns 1 if there is
   one; *tmax is then its t. */
static int ssgi__trace_leaf(const ssgi__trace_block *block, const ssgi__trace_ray *ray, float tmin, float *tmax,
                            ssgi_hit *hit)
{
    float at[3][2][4];
    int inside[4], found = 0;
    ssgi__trace_block_hit(block, ray, at, inside);
    for (int k = 0; k < 4; k++) {
        if (!inside[k]) continue;
        float weight[3], sum; /* barycentric weights of the corners, not yet over their sum */
        for (int c = 0; c < 3; c++) {
            const int a = c > 0 ? c - 1 : 2, b = c < 2 ? c + 1 : 0;
            weight[c] = at[a][0][k] * at[b][1][k] - at[a][1][k] * at[b][0][k];
        }
        sum = weight[0] + weight[1] + weight[2];
        sum = ssgi__abs(sum) > 0.0f ? sum : 1.0f;
        const float t = ssgi__trace_distance(block, k, ray, weight, sum);
        if (!(t > tmin && t < *tmax)) continue;
        if (!hit) return 1;
        found = 1;
        hit->t = *tmax = t;
        hit->u = ssgi__min(1.0f, ssgi__max(0.0f, weight[1] / sum));
        hit->v = ssgi__min(1.0f - hit->u, ssgi__max(0.0f, weight[2] / sum));
        hit->triangle = block->triangle[k];
    }
    return found;
}

/* Writes the t at which the ray enters and leaves the boxes of a node's children, within tmin .. tmax. The ray misses a
   box if enter > leave. */
static void ssgi__trace_boxes(const ssgi__trace_node *node, const ssgi__trace_ray *ray, float tmin, float tmax,
                              float enter[SSGI__TRACE_WIDE], float leave[SSGI__TRACE_WIDE])
{
    const float *o = ray->origin, *inverse = ray->inverse;
    const int *sign = ray->sign;
    const float *x0 = node->bound[sign[0]][0], *x1 = node->bound[1 - sign[0]][0];
    const float *y0 = node->bound[sign[1]][1], *y1 = node->bound[1 - sign[1]][1];
    const float *z0 = node->bound[sign[2]][2], *z1 = node->bound[1 - sign[2]][2];
    for (int k = 0; k < SSGI__TRACE_WIDE; k++) {
        const float ex = (x0[k] - o[0]) * inverse[0], lx = (x1[k] - o[0]) * inverse[0];
        const float ey = (y0[k] - o[1]) * inverse[1], ly = (y1[k] - o[1]) * inverse[1];
        const float ez = (z0[k] - o[2]) * inverse[2], lz = (z1[k] - o[2]) * inverse[2];
        enter[k] = ssgi__max(ssgi__max(ex, ey), ssgi__max(ez, tmin));
        leave[k] = ssgi__min(ssgi__min(lx, ly), lz) * 1.000001f; /* covers the rounding of both ends [Ize 2013] */
        leave[k] = ssgi__min(leave[k], tmax);
    }
}

/* Walks the tree from near to far, for the closest hit. With `hit` NULL it takes any order and ends at the first hit
   that it finds. Returns 1 if there is a hit, else 0. */
SSGI__FN int ssgi__trace_walk(const ssgi_trace *trace, const float origin[3], const float direction[3], float tmin,
                              float tmax, ssgi_hit *hit)
{
    const ssgi__trace_node *nodes = (const ssgi__trace_node *)trace->nodes;
    const ssgi__trace_block *blocks = (const ssgi__trace_block *)trace->blocks;

    struct {
        uint32_t child;
        float t;
    } stack[SSGI__TRACE_STACK + 1]; /* one entry more than the depth needs, as a child that the ray misses is written
                                       above the top, too */

    ssgi__trace_ray ray;
    int top = 0, found = 0;
    if (trace->node_count == 0 || !ssgi__trace_ray_set(&ray, origin, direction)) return 0;
    stack[top].child = 0;
    stack[top++].t = tmin;
    while (top) {
        const uint32_t child = stack[--top].child;
        float enter[SSGI__TRACE_WIDE], leave[SSGI__TRACE_WIDE];
        const int base = top;
        if (stack[top].t > tmax) continue;
        if (child & SSGI__TRACE_LEAF) {
            found |= ssgi__trace_leaf(blocks + (child & ~SSGI__TRACE_LEAF), &ray, tmin, &tmax, hit);
            if (found && !hit) return 1;
            continue;
        }
        ssgi__trace_boxes(nodes + child, &ray, tmin, tmax, enter, leave);
        /* for the closest hit the nearest child goes on top; for any hit the loop has no branch on `in`, which
           processors often predict wrong */
        for (int k = 0; k < SSGI__TRACE_WIDE; k++) {
            const int in = enter[k] <= leave[k];
            int j = top;
            for (; hit && in && j > base && stack[j - 1].t < enter[k]; j--) stack[j] = stack[j - 1];
            stack[j].child = nodes[child].child[k];
            stack[j].t = enter[k];
            top += in;
        }
    }
    return found;
}

SSGI_DEF int ssgi_trace_closest(ssgi_hit *hit, const ssgi_trace *trace, const float origin[3], const float direction[3],
                                float tmin, float tmax)
{
    return ssgi__trace_walk(trace, origin, direction, ssgi__clamped(tmin, 3e38f), ssgi__clamped(tmax, 3e38f), hit);
}

SSGI_DEF int ssgi_trace_any(const ssgi_trace *trace, const float origin[3], const float direction[3], float tmin,
                            float tmax)
{
    return ssgi__trace_walk(trace, origin, direction, ssgi__clamped(tmin, 3e38f), ssgi__clamped(tmax, 3e38f), NULL);
}

/* Returns the cosine-weighted occlusion of a point whose normal is axes[2], by stratified rays; the seed turns them.
   `hard` is as in ssgi_trace_visibility. */
SSGI__FN double ssgi__trace_occlusion(const ssgi_trace *trace, const float from[3], float axes[3][3], float radius,
                                      int rays, int hard, uint32_t seed)
{
    const double shift = ssgi__turn(seed), spin = ssgi__turn(seed + 0x9e3779b9u);
    double sum = 0.0;
    for (int k = 0; k < rays; ++k) {
        const double u = (k + shift) / rays;
        const double angle = (2.0 * SSGI__PI) * ((double)ssgi_radical_inverse(2, (uint32_t)k) + spin);
        const float x = (float)(sqrt(u) * cos(angle)), y = (float)(sqrt(u) * sin(angle)), z = (float)sqrt(1.0 - u);
        float d[3];
        ssgi_hit hit;
        for (int c = 0; c < 3; ++c) d[c] = axes[0][c] * x + axes[1][c] * y + axes[2][c] * z;
        if (hard) sum += ssgi_trace_any(trace, from, d, 0.0f, radius);
        else if (ssgi_trace_closest(&hit, trace, from, d, 0.0f, radius)) sum += 1.0 - (double)(hit.t / radius);
    }
    return sum / rays;
}

/* Returns the largest absolute value of a coordinate in a trace. */
SSGI__FN float ssgi__trace_extent(const ssgi_trace *trace)
{
    const ssgi__trace_node *root = (const ssgi__trace_node *)trace->nodes;
    float most = 0.0f;
    for (int k = 0; k < SSGI__TRACE_WIDE && trace->node_count; ++k)
        for (int i = 0; i < 3 && root->bound[0][i][k] <= root->bound[1][i][k]; ++i)
            most = ssgi__max(most, ssgi__max(ssgi__abs(root->bound[0][i][k]), ssgi__abs(root->bound[1][i][k])));
    return most;
}

/* Returns a hash of a point's coordinates, by their bits; 0 and -0 give the same hash. */
SSGI__FN uint32_t ssgi__trace_seed(const float p[3])
{
    uint32_t seed = 0, bits;
    for (int i = 0; i < 3; ++i) {
        bits = ssgi__bits(p[i]);
        seed = ssgi__hash(seed ^ (bits & 0x7fffffffu ? bits : 0u));
    }
    return seed;
}

SSGI_DEF ssgi_result ssgi_trace_visibility(float *out, const ssgi_trace *trace, const float *position,
                                           const float *normal, size_t count, float radius, int rays, int hard,
                                           const char **why)
{
    SSGI__THERE2(out, trace);
    SSGI__THERE2(position, normal);
    SSGI__RANGE(rays, 1, 65536);
    SSGI__RANGE(hard, 0, 1);
    SSGI__CHECK(ssgi__finite(radius) && radius >= (hard ? 0.0f : 1e-30f),
                "radius: must be finite and above 0; where hard, 0 is without end");
    const float lift = 4e-6f * ssgi__trace_extent(trace), end = radius > 0.0f ? radius : 3e38f;
    for (size_t i = 0; i < count; ++i) {
        const float *p = position + 3 * i, *n = normal + 3 * i;
        double along[3];
        float axes[3][3], from[3];
        out[i] = 1.0f;
        if (!ssgi__finites(p, 3) || !ssgi__finites(n, 3)) continue;
        ssgi__doubles(along, n);
        if (!(ssgi__normalise(along) > 0.0)) continue;
        ssgi__axes(axes, along);
        for (int k = 0; k < 3; ++k) from[k] = p[k] + lift * axes[2][k];
        out[i] = (float)(1.0 - ssgi__trace_occlusion(trace, from, axes, end, rays, hard, ssgi__trace_seed(p)));
    }
    return SSGI_OK;
}

/* ==== >>tessellate (implementation) ============================================================================ */

#define SSGI__TESS_MOST 3169.0 /* ssgi_tess_count(64): the points of the tessellator's last level */

SSGI_DEF int ssgi_tess_count(int level)
{
    if (level < 1 || level > 64) return 0;
    const int half = (level + 1) / 2;
    return level % 2 ? 3 * half * half : 3 * half * half + 3 * half + 1;
}

/* A point of a tessellated triangle. Points lie in rings; ring 0 is the triangle's edges. At level n each side of ring
   k has n - 2k equal parts, and points stand between them and at the ring's corners. */
typedef struct ssgi__tess_point {
    int level, ring;
    int i;        /* number within the ring */
    int place[3]; /* how many parts the point is away from each side of the ring */
} ssgi__tess_point;

/* Steps to the next point, ring by ring inwards; from { level, 0, -1, { 0 } } it steps to the first. Returns 0 after
   the last. */
SSGI__FN int ssgi__tess_next(ssgi__tess_point *p)
{
    int segments = p->level - 2 * p->ring, side, along;
    if (++p->i >= (segments ? 3 * segments : 1)) {
        ++p->ring;
        p->i = 0;
        segments -= 2;
    }
    if (segments < 0) return 0;
    side = segments ? p->i / segments : 0;
    along = segments ? p->i % segments : 0;
    p->place[side] = segments - along;
    p->place[(side + 1) % 3] = along;
    p->place[(side + 2) % 3] = 0;
    return 1;
}

/* Writes a point's barycentric coordinates. */
SSGI__FN void ssgi__tess_weights(double w[3], const ssgi__tess_point *p)
{
    for (int k = 0; k < 3; ++k) w[k] = (2.0 * p->ring / 3.0 + p->place[k]) / p->level;
}

SSGI_DEF ssgi_result ssgi_tess_points(float *uvw, int level, const char **why)
{
    ssgi__tess_point at = { level, 0, -1, { 0, 0, 0 } };
    SSGI__THERE(uvw);
    SSGI__RANGE(level, 1, 64);
    for (; ssgi__tess_next(&at); uvw += 3) {
        double w[3];
        ssgi__tess_weights(w, &at);
        ssgi__floats(uvw, w);
    }
    return SSGI_OK;
}

SSGI_DEF int ssgi_tess_level(double area, double radius)
{
    double discs;
    if (!ssgi__above_zero(area) || !ssgi__fits(radius)) return 1;
    if (!((float)radius > 0.0f)) return 64;
    discs = area / (SSGI__PI * radius * radius);
    if (!(discs > 3.0)) return 1;
    return discs > SSGI__TESS_MOST ? 64 : (int)ceil(sqrt((4.0 * discs - 1.0) / 3.0) - 1.0 - 1e-5);
}

SSGI_DEF double ssgi_tess_radius(double area, double count)
{
    return ssgi__above_zero(area) && ssgi__above_zero(count) ? sqrt(area / (SSGI__PI * count)) : 0.0;
}

/* ==== >>surfels (implementation) =============================================================================== */

/* Writes to scale[0] the radius per view depth (orthographic: the radius) of surfels of a size, to scale[1] the view
   depth of the near plane. */
SSGI__FN void ssgi__surfel_scale(double scale[2], const ssgi_view *view, double size)
{
    scale[0] = 0.5 * size * view->height / fabs((double)view->project[1]);
    scale[1] = (double)ssgi_view_near(view);
}

SSGI__FN double ssgi__surfel_radius(const double scale[2], int orthographic, double depth)
{
    return orthographic ? scale[0] : scale[0] * (fabs(depth - scale[1]) + scale[1]);
}

SSGI_DEF double ssgi_surfel_radius(const ssgi_view *view, double size, double depth)
{
    double scale[2];
    if (!ssgi__above_zero(size) || !ssgi__fits(depth)) return 0.0;
    ssgi__surfel_scale(scale, view, size);
    return ssgi__surfel_radius(scale, view->orthographic, depth);
}

SSGI_DEF double ssgi_surfel_form_factor(double radius, double distance)
{
    if (!ssgi__above_zero(radius) || !ssgi__fits(distance)) return 0.0;
    return radius * radius / (distance * distance + radius * radius);
}

SSGI_DEF double ssgi_surfel_reach(double radius, double brightest, double epsilon)
{
    if (!ssgi__above_zero(radius) || !ssgi__above_zero(brightest) || !ssgi__fits(epsilon)) return 0.0;
    if (!((float)epsilon > 0.0f)) return (double)SSGI_FAR;
    return brightest > epsilon ? radius * sqrt(brightest / epsilon - 1.0) : 0.0;
}

SSGI_DEF void ssgi_surfel_shell(double shell[2], double reach, int level, double most)
{
    const int finite = ssgi__above_zero(reach) && ssgi__above_zero(most), l = ssgi__clamp(level, 0, 64);
    shell[0] = finite && l > 0 ? fmin(ldexp(reach, l - 1), most) : 0.0;
    shell[1] = finite ? fmin(ldexp(reach, l), most) : 0.0;
}

/* The arguments that surfels are made from, and numbers derived from them. A patch is a triangle or a part of one. */
typedef struct ssgi__surfel_maker {
    const ssgi_view *view;
    const ssgi_surfel_source *source;
    ssgi_surfel_desc desc;
    double scale[2], normals[3][3], side; /* side: -1 if the mesh is mirrored */
} ssgi__surfel_maker;

typedef struct ssgi__patch {
    double at[3][3], normal[3][3], colour[3][3];
    double face[3], area, radius; /* face: the triangle's own unit normal, by the order of its corners */
    int level, alive, count;      /* alive: a bit for each of the three points of level 1 that stays; count: surfels */
    uint32_t key;
} ssgi__patch;

static const float *ssgi__surfel_at(const float *data, size_t stride, size_t i)
{
    return (const float *)(const void *)((const char *)data + i * (stride ? stride : 12));
}

/* Writes position, normal and colour of a vertex. A source without normals gives 0 0 0, one without colours 1 1 1. A
   normal that is not finite becomes 0 0 0, a component of a colour that is not finite 0. */
SSGI__FN void ssgi__surfel_vertex(float v[9], const ssgi_surfel_source *s, size_t vertex)
{
    const float *part[3];
    part[0] = ssgi__surfel_at(s->position, s->position_stride, vertex);
    part[1] = s->normal ? ssgi__surfel_at(s->normal, s->normal_stride, vertex) : NULL;
    part[2] = s->colour ? ssgi__surfel_at(s->colour, s->colour_stride, vertex) : NULL;
    const int normal = ssgi__finites(part[1], 3);
    for (int k = 0; k < 9; ++k) {
        v[k] = part[k / 3] ? part[k / 3][k % 3] : k > 5 ? 1.0f : 0.0f;
        if (k > 5 ? !ssgi__finite(v[k]) : k > 2 && !normal) v[k] = 0.0f;
    }
}

/* Makes a patch, in view space, of a whole triangle of the source. Returns 0 if the triangle gives no surfels. */
SSGI__FN int ssgi__surfel_triangle(ssgi__patch *p, const ssgi__surfel_maker *m, size_t triangle)
{
    const ssgi_surfel_source *s = m->source;
    double a[3], b[3], v[3];
    uint32_t id[3];
    for (int corner = 0; corner < 3; ++corner) {
        const size_t k = 3 * triangle + (size_t)corner, vertex = s->index ? s->index[k] : k;
        float given[9];
        ssgi__surfel_vertex(given, s, vertex);
        if (!ssgi__finites(given, 3)) return 0;
        id[corner] = (uint32_t)vertex & 0xffffffu;
        ssgi__doubles(v, given);
        for (int i = 0; i < 3; ++i) {
            p->at[corner][i] = (double)s->to_view[12 + i];
            for (int n = 0; n < 3; ++n) p->at[corner][i] += (double)s->to_view[4 * n + i] * v[n];
            if (fabs(p->at[corner][i]) > (double)SSGI_FAR) return 0;
        }
        ssgi__doubles(p->colour[corner], given + 6);
        ssgi__doubles(v, given + 3);
        for (int i = 0; i < 3; ++i) p->normal[corner][i] = ssgi__dot(m->normals[i], v);
    }
    /* the key comes from vertex indices, as GPUs number primitives differently */
    p->key = id[0] + (id[1] - id[0]) * 0x9e3779b9u + (id[2] - id[0]) * 0xc2b2ae35u;
    ssgi__along(a, p->at[1], -1.0, p->at[0]);
    ssgi__along(b, p->at[2], -1.0, p->at[0]);
    ssgi__cross(p->face, a, b);
    p->area = 0.5 * ssgi__normalise(p->face);
    for (int i = 0; i < 9 && !s->normal; ++i) p->normal[i / 3][i % 3] = m->side * p->face[i % 3];
    return p->area > 0.0 && ssgi__fits(p->area);
}

/* Returns the smallest radius of surfels in a triangle or part of one (patch), which is the radius at its depth nearest
   to the near plane. A patch that ends between the eye and the near plane gets the radius at the near plane. */
SSGI__FN double ssgi__surfel_finest(const ssgi__patch *p, const ssgi__surfel_maker *m)
{
    double low = 1e300, high = -1e300;
    for (int k = 0; k < 3; ++k) {
        if (-p->at[k][2] < low) low = -p->at[k][2];
        if (-p->at[k][2] > high) high = -p->at[k][2];
    }
    if (low < m->scale[1]) low = high < 0.0 ? high : m->scale[1];
    return ssgi__surfel_radius(m->scale, m->view->orthographic, low);
}

/* Writes a patch's centroid and the largest distance of its corners from the centroid. Returns the centroid's distance
   outside the frustum. */
SSGI__FN double ssgi__surfel_outside(const ssgi__patch *p, const ssgi__surfel_maker *m, double middle[3],
                                     double *extent)
{
    *extent = 0.0;
    for (int i = 0; i < 3; ++i) middle[i] = (p->at[0][i] + p->at[1][i] + p->at[2][i]) / 3.0;
    for (int c = 0; c < 3; ++c) {
        double d[3], length;
        ssgi__along(d, p->at[c], -1.0, middle);
        length = sqrt(ssgi__dot(d, d));
        if (length > *extent) *extent = length;
    }
    return ssgi__view_aside(m->view, middle);
}

/* Returns the number of parts, 1..most, into which each edge of a triangle is split. */
SSGI__FN int ssgi__surfel_splits(const ssgi__patch *whole, const ssgi__surfel_maker *m, int most)
{
    const double r = ssgi__surfel_finest(whole, m),
                 n = ceil(sqrt(whole->area / (SSGI__PI * r * r * SSGI__TESS_MOST)) - 1e-5);
    return n < 1.0 ? 1 : n < most ? (int)n : most;
}

/* Writes the sum of three vectors, those of a triangle's corners, times the weights of the corners. */
SSGI__FN void ssgi__surfel_mix(double out[3], const double (*corner)[3], const double weight[3])
{
    for (int i = 0; i < 3; ++i) out[i] = weight[0] * corner[0][i] + weight[1] * corner[1][i] + weight[2] * corner[2][i];
}

/* Shrinks a triangle or part of one, so that discs keep off its edges: ssgi_overhang. GLSL twin: ssgi_inset. */
SSGI__FN void ssgi__surfel_inset(ssgi__patch *p, int overhang)
{
    double weight[3], d[3], centre[3] = { 0.0, 0.0, 0.0 }, sum = 0.0;
    for (int c = 0; c < 3; ++c) {
        ssgi__along(d, p->at[(c + 2) % 3], -1.0, p->at[(c + 1) % 3]);
        weight[c] = overhang == SSGI_OVERHANG_CENTROID ? 1.0 : sqrt(ssgi__dot(d, d)); /* sides weigh the incentre */
        sum += weight[c];
    }
    for (int c = 0; c < 3; ++c) ssgi__along(centre, centre, weight[c] / sum, p->at[c]);
    for (int c = 0; c < 3; ++c) {
        double kept = 1.0 - p->radius * sum / (2.0 * p->area), least = 0.25;
        ssgi__along(d, p->at[c], -1.0, centre);
        if (overhang == SSGI_OVERHANG_CENTROID) {
            kept = 1.0 - p->radius / sqrt(ssgi__dot(d, d));
            least = 0.1;
        }
        ssgi__along(p->at[c], centre, kept > least ? kept : least, d);
    }
}

/* Makes part number `part` of n * n of a triangle, inset from the part's edges. Returns 0 if the part is too far
   outside the frustum, or thinned out. GLSL twin: main_levels. */
SSGI__FN int ssgi__surfel_part(ssgi__patch *p, const ssgi__surfel_maker *m, const ssgi__patch *whole, int n, int part)
{
    int row = (int)sqrt((double)part), place;
    double middle[3], extent, aside, wanted, share;
    if (row * row > part) --row;
    place = part - row * row;
    for (int c = 0; c < 3; ++c) {
        const int down = row + (place % 2 ? c != 2 && c != 0 : c > 0), across = place / 2 + (place % 2 ? c > 0 : c > 1);
        const double w[3] = { 1.0 - (double)down / n, (double)(down - across) / n, (double)across / n };
        ssgi__surfel_mix(p->at[c], whole->at, w);
        ssgi__surfel_mix(p->normal[c], whole->normal, w);
        ssgi__surfel_mix(p->colour[c], whole->colour, w);
    }
    memcpy(p->face, whole->face, sizeof p->face);
    p->area = whole->area / ((double)n * n);
    aside = ssgi__surfel_outside(p, m, middle, &extent);
    if (m->desc.max_distance > 0.0f && aside - extent > (double)m->desc.max_distance) return 0;
    wanted = ssgi__surfel_radius(m->scale, m->view->orthographic, -middle[2])
           + (double)m->desc.offscreen_growth * aside;
    p->key = whole->key + (uint32_t)part * 0x85ebca6bu;
    p->level = ssgi_tess_level(p->area, wanted);
    share = p->area / (3.0 * SSGI__PI * wanted * wanted);
    if (m->desc.keep_small || share > 1.0) share = 1.0;
    p->alive = 0; /* thins out surfels: multiples of the golden ratio keep an even share along the mesh's order of
                     indices */
    for (int c = 0; c < 3; ++c)
        if ((double)((p->key + (uint32_t)c) * 0x9e3779b9u >> 8) / 16777216.0 < share) p->alive |= 1 << c;
    if (!p->alive) return 0;
    p->count = p->level > 1 ? ssgi_tess_count(p->level) : (p->alive & 1) + (p->alive >> 1 & 1) + (p->alive >> 2);
    p->radius = ssgi_tess_radius(p->area, share * ssgi_tess_count(p->level));
    if (!((float)p->radius > 0.0f)) return 0;
    ssgi__surfel_inset(p, m->desc.overhang);
    return 1;
}

/* Writes the unit normal of a surfel: the mean of the corners' normals, or the triangle's own if that mean is 0. */
SSGI__FN void ssgi__surfel_normal(float out[3], const ssgi__surfel_maker *m, const ssgi__patch *p,
                                  const double weight[3])
{
    double normal[3];
    ssgi__surfel_mix(normal, p->normal, weight);
    if (!(ssgi__normalise(normal) > 0.0))
        for (int i = 0; i < 3; ++i) normal[i] = m->side * p->face[i];
    ssgi__floats(out, normal);
}

/* Makes the surfel at one of the points that the tessellator makes of a patch. GLSL twin: main_points. */
SSGI__FN void ssgi__surfel_point(ssgi_surfel *out, const ssgi__surfel_maker *m, const ssgi__patch *p,
                                 const ssgi__tess_point *point)
{
    const uint32_t number = (uint32_t)(point->place[0] | point->place[1] << 7 | point->ring << 14),
                   h = ssgi__hash(ssgi__hash(p->key) + number);
    double at[3], colour[3], w[3];
    ssgi__tess_weights(w, point);
    ssgi__surfel_mix(at, p->at, w);
    ssgi__surfel_mix(colour, p->colour, w);
    ssgi__floats(out->position, at);
    ssgi__surfel_normal(out->normal, m, p, w);
    ssgi__floats(out->colour, colour);
    out->radius = (float)p->radius;
    out->seed = (float)(h >> 8) / 16777216.0f;
    out->unused = 0.0f;
}

/* Checks an ssgi_surfel_desc and a view, and copies the desc with its defaults in place. */
SSGI__FN ssgi_result ssgi__surfel_desc(ssgi_surfel_desc *out, const ssgi_surfel_desc *desc, const ssgi_view *view,
                                       const char **why)
{
    SSGI__THERE(desc);
    SSGI__CHECK(view && view->width > 0 && view->height > 0, "view: must come from ssgi_view_from_projection");
    SSGI__CHECK(ssgi__zero_or(desc->size, 1e-4f, 1.0f), "desc.size: must be 1e-4..1, or 0 for the default");
    SSGI__CHECK(desc->splits >= 0 && desc->splits <= 32, "desc.splits: must be 0..32");
    SSGI__CHECK(desc->keep_small >= 0 && desc->keep_small <= 1, "desc.keep_small: must be 0 or 1");
    SSGI__CHECK(ssgi__within(desc->offscreen_growth, 0.0f, 1.0f), "desc.offscreen_growth: must be 0..1");
    SSGI__CHECK(ssgi__positive(&desc->max_distance, 1), "desc.max_distance: must be 0 or more and finite");
    SSGI__CHECK(desc->overhang >= 0 && desc->overhang <= SSGI_OVERHANG_CENTROID,
                "desc.overhang: must be SSGI_OVERHANG_INCENTRE or _CENTROID");
    *out = *desc;
    if (!(out->offscreen_growth > 0.0f)) out->offscreen_growth = 0.1f;
    if (!(out->size > 0.0f)) out->size = 0.03f;
    if (!out->splits) out->splits = 8;
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_surfel_scale(float scale[4], const ssgi_surfel_desc *desc, const ssgi_view *view,
                                       const char **why)
{
    ssgi_surfel_desc d;
    double of_view[2];
    SSGI__TRY(ssgi__surfel_desc(&d, desc, view, why));
    SSGI__THERE(scale);
    ssgi__surfel_scale(of_view, view, (double)d.size);
    SSGI__CHECK(ssgi__fits(of_view[0]), "desc.size: is too large for this view");
    scale[0] = (float)of_view[0];
    scale[1] = (float)of_view[1];
    scale[2] = d.offscreen_growth;
    scale[3] = (float)d.splits;
    return SSGI_OK;
}

/* Checks the arguments of ssgi_surfels and fills an ssgi__surfel_maker. The matrix of normals is the cofactors of
   to_view's, so that normals stay perpendicular under any scale; `side` is -1 if to_view mirrors. */
SSGI__FN ssgi_result ssgi__surfel_open(ssgi__surfel_maker *m, const ssgi_surfel_desc *desc, const ssgi_view *view,
                                       const ssgi_surfel_source *source, const char **why)
{
    const ssgi_surfel_source *s = source;
    double a[3][3], c[3], determinant;
    SSGI__TRY(ssgi__surfel_desc(&m->desc, desc, view, why));
    SSGI__THERE(source);
    SSGI__CHECK(s->position, "source.position: must not be NULL");
    SSGI__CHECK((s->position_stride | s->normal_stride | s->colour_stride) % 4 == 0,
                "source: strides must be multiples of 4");
    SSGI__CHECK(ssgi__finites(s->to_view, 16), "source.to_view: must be finite");
    m->view = view;
    m->source = source;
    ssgi__surfel_scale(m->scale, view, (double)m->desc.size);
    for (int k = 0; k < 3; ++k) ssgi__doubles(a[k], s->to_view + 4 * k);
    for (int k = 0; k < 3; ++k) {
        ssgi__cross(c, a[(k + 1) % 3], a[(k + 2) % 3]);
        for (int i = 0; i < 3; ++i) m->normals[i][k] = c[i];
    }
    determinant = m->normals[0][0] * a[0][0] + m->normals[1][0] * a[0][1] + m->normals[2][0] * a[0][2];
    SSGI__CHECK(determinant > 0.0 || determinant < 0.0, "source.to_view: must be invertible");
    m->side = determinant < 0.0 ? -1.0 : 1.0;
    for (int k = 0; k < 9; ++k) m->normals[k / 3][k % 3] *= m->side;
    return SSGI_OK;
}

typedef struct ssgi__divider {
    ssgi__surfel_maker maker;
    float *out;
    size_t capacity, count;
} ssgi__divider;

/* Writes a triangle of 27 floats as it is, or in four parts if it is too large, recursively: ssgi_surfels_divide. */
SSGI__FN void ssgi__surfel_divide(ssgi__divider *d, const float v[27], int depth)
{
    const ssgi__surfel_maker *m = &d->maker;
    ssgi_surfel_source one = *m->source;
    ssgi__surfel_maker sub = *m;
    ssgi__patch p;
    double middle[3], extent, aside, r;
    one.position = v;
    one.normal = one.colour = NULL;
    one.position_stride = 36;
    one.index = NULL;
    sub.source = &one;
    if (!ssgi__surfel_triangle(&p, &sub, 0)) return;
    aside = ssgi__surfel_outside(&p, m, middle, &extent) - extent;
    if (m->desc.max_distance > 0.0f && aside > (double)m->desc.max_distance) return;
    r = ssgi__surfel_finest(&p, m) + (aside > 0.0 ? (double)m->desc.offscreen_growth * aside : 0.0);
    if (depth == 10 || p.area <= SSGI__PI * SSGI__TESS_MOST * r * r * m->desc.splits * m->desc.splits) {
        if (d->count < d->capacity) memcpy(d->out + 27 * d->count, v, 27 * sizeof *v);
        ++d->count;
        return;
    }
    for (int c = 0; c < 4; ++c) { /* parts 0 to 2: corner c and the midpoints of its edges; part 3: the three
                                     midpoints */
        float child[27];
        for (int i = 0; i < 27; ++i) {
            const int k = i / 9, a = c < 3 ? c : k, b = c < 3 ? (c + k) % 3 : (k + 1) % 3;
            child[i] = 0.5f * v[9 * a + i % 9] + 0.5f * v[9 * b + i % 9];
        }
        ssgi__surfel_divide(d, child, depth + 1);
    }
}

SSGI_DEF ssgi_result ssgi_surfels_divide(float *out, size_t capacity, size_t *count, const ssgi_surfel_desc *desc,
                                         const ssgi_view *view, const ssgi_surfel_source *source, const char **why)
{
    ssgi__divider d;
    SSGI__TRY(ssgi__surfel_open(&d.maker, desc, view, source, why));
    SSGI__THERE(count);
    SSGI__CHECK(out || !capacity, "out: must not be NULL when capacity is not 0");
    d.out = out;
    d.capacity = capacity;
    d.count = 0;
    for (size_t i = 0; i < 3 * source->triangles; i += 3) {
        float v[27];
        for (size_t c = 0; c < 3; ++c)
            ssgi__surfel_vertex(v + 9 * c, source, source->index ? source->index[i + c] : i + c);
        ssgi__surfel_divide(&d, v, 0);
    }
    *count = d.count;
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_surfels(ssgi_surfel *out, size_t capacity, size_t *count, const ssgi_surfel_desc *desc,
                                  const ssgi_view *view, const ssgi_surfel_source *source, const char **why)
{
    ssgi__surfel_maker m;
    ssgi__patch whole, p;
    size_t n = 0;
    SSGI__TRY(ssgi__surfel_open(&m, desc, view, source, why));
    SSGI__THERE(count);
    SSGI__CHECK(out || !capacity, "out: must not be NULL when capacity is not 0");
    for (size_t t = 0; t < source->triangles; ++t) {
        const int splits = ssgi__surfel_triangle(&whole, &m, t) ? ssgi__surfel_splits(&whole, &m, m.desc.splits) : 0;
        for (int part = 0; part < splits * splits; ++part) {
            if (!ssgi__surfel_part(&p, &m, &whole, splits, part)) continue;
            if (n >= capacity) {
                n += (size_t)p.count;
                continue;
            }
            for (ssgi__tess_point at = { p.level, 0, -1, { 0, 0, 0 } }; ssgi__tess_next(&at);) {
                if (p.level == 1 && !(p.alive >> at.i & 1)) continue;
                if (n < capacity) ssgi__surfel_point(&out[n], &m, &p, &at);
                ++n;
            }
        }
    }
    *count = n;
    return SSGI_OK;
}

/* Writes the bounds x0, y0, x1, y1 of the pixels that the part of a sphere deeper than front (> 0 when perspective)
   covers, clipped to the frame, exact in each axis [Mara, McGuire 2013]. Unless the normal is 0, only the half of the
   sphere counts that lies before the disc with this unit normal; its bounds are exact if the disc is deeper than front.
   Returns 0, with bounds untouched, if the part covers no pixel. GLSL twin: ssgi_sphere. */
SSGI__FN int ssgi__sphere_bounds(float bounds[4], const ssgi_view *view, const float centre[3], const float normal[3],
                                 float radius, float front)
{
    const double n[3] = { (double)normal[0], (double)normal[1], (double)normal[2] }, z = -(double)centre[2],
                 r = (double)radius, begin = (double)front, chord = r * r - (begin - z) * (begin - z),
                 cut = chord > 0.0 ? sqrt(chord) : 0.0, deep = r * sqrt(n[0] * n[0] + n[1] * n[1]);
    const int size[2] = { view->width, view->height };
    float out[4];
    if (!(z + (n[2] > 0.0 ? deep : r) > begin)) return 0;
    for (int axis = 0; axis < 2; ++axis) {
        const double aside = n[1 - axis] * n[1 - axis];
        for (int high = 0; high < 2; ++high) {
            /* for a lower bound the axis is mirrored, so that it becomes an upper bound; with perspective the bound is
               a slope: that of the tangent, or of the point at which the sphere meets the front */
            const double side = (view->project[axis] < 0.0f) != (high != 0) ? 1.0 : -1.0,
                         x = side * (double)centre[axis], m = side * n[axis], cc = x * x + z * z, off = cc - r * r,
                         t = off > 0.0 ? sqrt(off) : 0.0, depth = z * t - x * r, plane = x * m - z * n[2];
            const double root = off * aside + plane * plane;
            double e = x + (z > begin ? r : cut), disc = x + r * sqrt(aside + n[2] * n[2]), facing = m;
            if (!view->orthographic) {
                e = depth * t > begin * cc ? (x * t + z * r) / depth : (x + cut) / begin;
                disc = (x * z - r * r * n[2] * m + r * sqrt(root > 0.0 ? root : 0.0)) / ((z - deep) * (z + deep));
                facing = z - deep > begin ? m + disc * n[2] : 0.0;
            }
            /* if the sphere's tangent touches the half that does not count, the bound is that of the disc */
            if (facing < 0.0 && disc < e) e = disc;
            e = side * e * (double)view->project[axis] + (double)view->project[2 + axis];
            out[axis + 2 * high] = (float)(e < 0.0 ? 0.0 : e > size[axis] ? size[axis] : e);
        }
        if (!(out[axis] < out[axis + 2])) return 0;
    }
    memcpy(bounds, out, sizeof out);
    return 1;
}

#define SSGI__SPLAT_EPSILON 0.3f /* the default of ssgi_splat.epsilon */

/* Checks an ssgi_splat and copies it with its defaults in place. */
SSGI__FN ssgi_result ssgi__splat_open(ssgi_splat *s, const ssgi_splat *splat, const ssgi_view *view, const char **why)
{
    SSGI__THERE2(splat, view);
    SSGI__CHECK(ssgi__zero_or(splat->epsilon, 1e-6f, 1.0f), "splat.epsilon: must be 1e-6..1, or 0 for the default");
    SSGI__CHECK(ssgi__positive(&splat->max_distance, 1), "splat.max_distance: must be 0 or more and finite");
    SSGI__CHECK(ssgi__positive(&splat->max_radiance, 1), "splat.max_radiance: must be 0 or more and finite");
    SSGI__CHECK(ssgi__positive(&splat->near_depth, 1), "splat.near_depth: must be 0 or more and finite");
    SSGI__CHECK(splat->levels >= 0 && splat->levels <= SSGI_SPLAT_LEVELS, "splat.levels: must be 0..7");
    SSGI__CHECK(splat->part >= 0 && splat->part <= 4 && splat->part != 3, "splat.part: must be 1, 2 or 4");
    SSGI__CHECK(splat->two_sided >= 0 && splat->two_sided <= 1, "splat.two_sided: must be 0 or 1");
    *s = *splat;
    if (!(s->epsilon > 0.0f)) s->epsilon = SSGI__SPLAT_EPSILON;
    if (!(s->max_distance > 0.0f)) s->max_distance = SSGI_FAR;
    if (!(s->max_radiance > 0.0f)) s->max_radiance = 1.0f;
    if (!s->levels) s->levels = 4;
    if (!s->part) s->part = 1;
    if (!(s->near_depth > 0.0f)) s->near_depth = ssgi_view_near(view);
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_splat_size(int size[2], int width, int height, int levels, const char **why)
{
    SSGI__THERE(size);
    SSGI__SIZE(width, height);
    SSGI__RANGE(levels, 1, 7);
    const int l = (1 << (levels - 1)) - 1;
    size[0] = (width + l) & ~l;
    size[1] = (height + l) & ~l;
    return SSGI_OK;
}

SSGI_DEF int ssgi_splat_levels(double size, double epsilon, double radius)
{
    const double reach = ssgi_surfel_reach(0.5 * size, 1.0, epsilon);
    int levels = 1;
    while (levels < SSGI_SPLAT_LEVELS && !(ldexp(reach, levels - 1) >= radius)) ++levels;
    return levels;
}

/* Adds to cost->pixels of each level the texels that `count` surfels of this centre, normal and radius cover. */
SSGI__FN void ssgi__splat_pixels(ssgi_surfel_cost *cost, const ssgi_splat *s, const ssgi_view *view,
                                 const float centre[3], const float normal[3], double radius, double brightest,
                                 double count)
{
    static const float whole[3] = { 0.0f, 0.0f, 0.0f };
    const double reach = ssgi_surfel_reach(radius, brightest, (double)s->epsilon);
    for (int l = 0; l < s->levels; ++l) {
        const double side = ldexp((double)s->part, l);
        double shell[2];
        float b[4];
        ssgi_surfel_shell(shell, reach, l, (double)s->max_distance);
        if (!(shell[1] > shell[0])
            || !ssgi__sphere_bounds(b, view, centre, s->two_sided ? whole : normal, (float)shell[1], s->near_depth))
            continue;
        cost->pixels[l] += count * (ceil((double)b[2] / side) - floor((double)b[0] / side))
                         * (ceil((double)b[3] / side) - floor((double)b[1] / side));
    }
}

SSGI_DEF ssgi_result ssgi_surfels_predict(ssgi_surfel_cost *cost, const ssgi_surfel_desc *desc, const ssgi_splat *splat,
                                          const ssgi_view *view, const ssgi_surfel_source *source, const char **why)
{
    ssgi__surfel_maker m;
    ssgi__patch whole, p;
    ssgi_splat s;
    SSGI__TRY(ssgi__surfel_open(&m, desc, view, source, why));
    SSGI__TRY(ssgi__splat_open(&s, splat, view, why));
    SSGI__THERE(cost);
    memset(cost, 0, sizeof *cost);
    cost->splits = 1;
    for (size_t t = 0; t < source->triangles; ++t) {
        int n = ssgi__surfel_triangle(&whole, &m, t) ? ssgi__surfel_splits(&whole, &m, 1000000) : 0;
        if (n > cost->splits) cost->splits = n;
        if (n > m.desc.splits) n = m.desc.splits;
        for (int part = 0; part < n * n; ++part) {
            static const double middle[3] = { 1.0 / 3.0, 1.0 / 3.0, 1.0 / 3.0 };
            float centre[3], normal[3];
            if (!ssgi__surfel_part(&p, &m, &whole, n, part)) continue;
            for (int k = 0; k < 3; ++k) centre[k] = (float)((p.at[0][k] + p.at[1][k] + p.at[2][k]) / 3.0);
            ssgi__surfel_normal(normal, &m, &p, middle);
            cost->surfels += (size_t)p.count;
            ssgi__splat_pixels(cost, &s, view, centre, normal, p.radius, (double)s.max_radiance, p.count);
        }
    }
    return SSGI_OK;
}

/* ==== >>dipole (implementation) ================================================================================ */

SSGI_DEF ssgi_result ssgi_dipole_set(ssgi_dipole *dipole, const float sigma_s[3], const float sigma_a[3], float eta,
                                     const char **why)
{
    /* F_dr, the diffuse Fresnel reflectance, and A [JMLH01 section 2.3] */
    const double n = (double)eta, inside = -1.440 / (n * n) + 0.710 / n + 0.668 + 0.0636 * n,
                 a = (1.0 + inside) / (1.0 - inside);
    SSGI__THERE3(dipole, sigma_s, sigma_a);
    SSGI__CHECK(ssgi__within(eta, 1.0f, 3.0f), "eta: must be 1..3");
    for (int c = 0; c < 3; ++c) {
        SSGI__CHECK(sigma_s[c] > 0.0f && ssgi__finite(sigma_s[c]), "sigma_s: must be above 0 and finite");
        SSGI__CHECK(ssgi__positive(&sigma_a[c], 1), "sigma_a: must be 0 or more and finite");
    }
    for (int c = 0; c < 3; ++c) {
        const double t = (double)sigma_s[c] + (double)sigma_a[c];
        dipole->z_r[c] = 1.0 / t;
        dipole->z_v[c] = (1.0 + 4.0 / 3.0 * a) / t;
        dipole->sigma_tr[c] = sqrt(3.0 * (double)sigma_a[c] * t);
        dipole->albedo[c] = (double)sigma_s[c] / t;
    }
    return SSGI_OK;
}

SSGI_DEF double ssgi_dipole_reflectance(const ssgi_dipole *d, int c, double r)
{
    double sum = 0.0;
    if (c < 0 || c > 2 || !ssgi__fits(r)) return 0.0;
    for (int k = 0; k < 2; ++k) {
        const double z = k ? d->z_v[c] : d->z_r[c], length = sqrt(r * r + z * z);
        sum += z * (d->sigma_tr[c] + 1.0 / length) * exp(-d->sigma_tr[c] * length) / (length * length);
    }
    return d->albedo[c] / (4.0 * SSGI__PI) * sum;
}

/* ==== >>cap (implementation) =================================================================================== */

/* Integrates the clamped cosine over a cap [AOF05 eq. 3], by the two arcs that bound the cap's part above the
   horizon. */
SSGI_DEF double ssgi_cap_occlusion(double solid_angle, double cosine)
{
    double h = ssgi__fits(solid_angle) && solid_angle > 0.0 ? solid_angle / (2.0 * SSGI__PI) : 0.0;
    double c = !ssgi__fits(cosine) ? 0.0 : cosine < -1.0 ? -1.0 : cosine > 1.0 ? 1.0 : cosine, s, a = 0.0;
    const int large = h > 1.0; /* a cap larger than a hemisphere, whose complement is a cap, too */
    if (large) {
        h = h < 2.0 ? 2.0 - h : 0.0;
        c = -c;
    }
    s = h * (2.0 - h); /* squared sine of its angular radius, as (1 - k)(1 + k) would cancel */
    if (c * c >= s) a = c > 0.0 ? s * c : 0.0;
    else {
        const double x = (1.0 - h) / sqrt(s), w = sqrt(1.0 - c * c / s);
        a = ((c * atan2(w, -x * c) - x * w) * s + atan2(w, x)) / SSGI__PI;
        a = a > 0.0 ? a < 1.0 ? a : 1.0 : 0.0;
    }
    return large ? 1.0 - a : a;
}

SSGI_DEF ssgi_result ssgi_cap_table(float *out, int size, const char **why)
{
    SSGI__THERE(out);
    SSGI__RANGE(size, 2, 4096);
    for (int y = 0; y < size; ++y)
        for (int x = 0; x < size; ++x)
            *out++ = (float)ssgi_cap_occlusion(4.0 * SSGI__PI * x / (size - 1), 2.0 * y / (size - 1) - 1.0);
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_cap_light(float out[3], const float *coefficients, int bands, float solid_angle,
                                    const float axis[3], const float normal[3], const char **why)
{
    enum { directions = 256 };

    const double shift[2] = { 0.0, 0.0 };
    double a[3], n[3], d[3], sum[3] = { 0.0, 0.0, 0.0 }, all = 0.0;
    float axes[3][3], direction[3], basis[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS];
    SSGI__THERE(out);
    SSGI__RANGE(bands, 1, SSGI_SH_MAX_BANDS);
    SSGI__CHECK(ssgi__finites(coefficients, 3 * bands * bands), "coefficients: must not be NULL, and finite");
    SSGI__CHECK(ssgi__finite(solid_angle), "solid_angle: must be finite");
    SSGI__CHECK(ssgi__finites(axis, 3), "axis: must not be NULL, and finite");
    SSGI__CHECK(ssgi__finites(normal, 3), "normal: must not be NULL, and finite");
    ssgi__doubles(a, axis);
    ssgi__doubles(n, normal);
    SSGI__CHECK(ssgi__normalise(a) > 0.0, "axis: must not be 0");
    SSGI__CHECK(ssgi__normalise(n) > 0.0, "normal: must not be 0");
    const double cosine = 1.0 - (double)ssgi__max(0.0f, ssgi__min(solid_angle, 12.5663706f)) / (2.0 * SSGI__PI);
    const double share = SSGI__PI * ssgi_cap_occlusion((double)solid_angle, ssgi__dot(a, n));
    ssgi__axes(axes, a);
    for (int i = 0; i <= directions; ++i) { /* the last direction, the axis, counts if no other is above the horizon */
        const int last = i == directions;
        if (last && all > 0.0) break;
        ssgi__cone_ray(direction, axes, last ? 1.0f : (float)cosine, i, shift);
        ssgi__doubles(d, direction);
        const double facing = last ? 1.0 : ssgi__dot(d, n);
        if (!(facing > 0.0)) continue;
        ssgi_sh_basis(basis, bands, direction);
        all += facing;
        for (int k = 0; k < bands * bands; ++k)
            for (int c = 0; c < 3; ++c) sum[c] += facing * (double)(basis[k] * coefficients[3 * k + c]);
    }
    for (int c = 0; c < 3; ++c) out[c] = (float)(share * sum[c] / all);
    return SSGI_OK;
}

/* ==== >>reflection (implementation) =============================================================================== */

/* Returns x clamped to least..1; 0 if x is not finite. */
SSGI__FN float ssgi__up_to_one(float x, float least)
{
    return ssgi__finite(x) ? ssgi__max(ssgi__min(x, 1.0f), least) : 0.0f;
}

SSGI_DEF float ssgi_interreflected(float visibility, float albedo)
{
    const float v = ssgi__up_to_one(visibility, 0.0f), a = ssgi__up_to_one(albedo, 0.0f);
    const float lit = (((2.0404f * a - 0.3324f) * v + 0.6417f - 4.7951f * a) * v + 2.7552f * a + 0.6903f) * v;
    return ssgi__min(ssgi__max(v, lit), 1.0f);
}

SSGI_DEF float ssgi_specular_visibility(float visibility, float bent, float normal, float roughness)
{
    const float v = ssgi__up_to_one(visibility, 0.0f), r = ssgi__up_to_one(roughness, 0.0f);
    const float away = ssgi__up_to_one(normal, -1.0f) - ssgi__up_to_one(bent, -1.0f);
    return ssgi__up_to_one(1.0f - (0.82f + 0.32f * r) * (1.0f - v) - (2.4f - 1.77f * r) * v * away, 0.0f);
}

/* ==== >>field (implementation) ================================================================================= */

#define SSGI__FIELD_FEW 128  /* corners that approximate the hull */
#define SSGI__FIELD_HELD 512 /* validation positions, with four receivers each */

/* ---- samples */

/* Samples an occluder from a point, by rays within acos(cosine) of a unit axis; `hit` NULL: by ssgi_trace_any.
     out         the solid angle of the directions that are hit, and their integral, the vector irradiance
     occlusion   of four receivers with these normals, or NULL */
SSGI__FN void ssgi__field_sample(double out[4], double occlusion[4], double normal[4][3], const ssgi_trace *trace,
                                 int (*hit)(void *, const float *, const float *), void *user, const float point[3],
                                 const double axis[3], float cosine, int rays, uint32_t seed)
{
    const double share = 2.0 * SSGI__PI * (1.0 - (double)cosine) / rays;
    const double shift[2] = { ssgi__turn(seed), ssgi__turn(seed ^ 0x9e3779b9u) };
    float axes[3][3], d[3];
    double along[3];
    memset(out, 0, 4 * sizeof *out);
    if (occlusion) memset(occlusion, 0, 4 * sizeof *occlusion);
    ssgi__axes(axes, axis);
    for (int i = 0; i < rays; ++i) {
        ssgi__cone_ray(d, axes, cosine, i, shift);
        if (hit ? !hit(user, point, d) : !ssgi_trace_any(trace, point, d, 0.0f, 3e38f)) continue;
        ssgi__doubles(along, d);
        out[0] += share;
        ssgi__along(out + 1, out + 1, share, along);
        for (int k = 0; occlusion && k < 4; ++k) {
            const double facing = ssgi__dot(normal[k], along);
            if (facing > 0.0) occlusion[k] += share / SSGI__PI * facing;
        }
    }
}

/* ---- fits */

/* Solves a x = b for a symmetric 3x3 matrix by Cramer's rule. Returns 0 if the matrix is singular. */
SSGI__FN int ssgi__field_solve(double x[3], double a[3][3], double b[3])
{
    double cross[3], determinant;
    for (int i = 0; i < 3; ++i) {
        ssgi__cross(cross, a[(i + 1) % 3], a[(i + 2) % 3]);
        determinant = ssgi__dot(a[i], cross);
        if (!(fabs(determinant) > 1e-280)) return 0;
        x[i] = ssgi__dot(b, cross) / determinant;
    }
    return 1;
}

/* Adds one equation d . x = r to the normal equations a x = b. */
SSGI__FN void ssgi__field_equation(double a[3][3], double b[3], const double d[3], double r)
{
    for (int i = 0; i < 3; ++i) ssgi__along(a[i], a[i], d[i], d);
    ssgi__along(b, b, r, d);
}

/* Samples of an occluder along a direction w, to which a curve or a centre is fitted. */
typedef struct ssgi__field_data {
    const double *radii, *values, *w; /* values at each radius: a number for a curve, a unit vector for a centre */
    int count, chord;                 /* chord: which error of a centre, see ssgi__field_centre_error */
    double most;                      /* the bound of a curve */
} ssgi__field_data;

typedef double (*ssgi__field_error)(const ssgi__field_data *data, const double u[3], double a[3][3], double b[3]);

/* Moves the three unknowns u by Levenberg and Marquardt's descent until the error is at most `stop` or falls no more,
   and returns the error. f gives the error and, if a is not NULL, adds the normal equations of the error: J J^T to a,
   -J residual to b. A step whose error is not below the last one, or is NaN, was too long: it is tried again with more
   damping. */
SSGI__FN double ssgi__field_descend(double u[3], const ssgi__field_data *data, ssgi__field_error f, double stop)
{
    double damping = 1e-3, error = f(data, u, NULL, NULL);
    for (int step = 0; step < 200 && damping < 1e12 && error > stop; ++step) {
        double a[3][3] = { { 0.0 } }, b[3] = { 0.0 }, m[3][3], v[3], x[3], next = error;
        f(data, u, a, b);
        for (; damping < 1e12; damping *= 8.0) {
            memcpy(m, a, sizeof m);
            memcpy(v, b, sizeof v);
            for (int i = 0; i < 3; ++i) m[i][i] += damping * (a[i][i] + 1e-12 * (a[0][0] + a[1][1] + a[2][2]) + 1e-250);
            if (!ssgi__field_solve(x, m, v)) continue;
            ssgi__along(x, x, 1.0, u);
            next = f(data, x, NULL, NULL);
            if (next < error) break;
        }
        if (!(damping < 1e12)) break;
        memcpy(u, x, sizeof x);
        damping *= 0.1;
        if (error - next < 1e-12 * error && damping < 1e-2) return next;
        error = next;
    }
    return error;
}

/* Writes the coefficients q of the unknowns u, such that the polynomial is above m = 1/most on all of [0,1]: q0 = m +
   e^u0, q2 = m + e^u2, q1 = m - e^((u0 + u2)/2) + e^u1. */
SSGI__FN void ssgi__field_bernstein(double q[3], const double u[3], double most)
{
    q[0] = 1.0 / most + exp(u[0]);
    q[2] = 1.0 / most + exp(u[2]);
    q[1] = 1.0 / most - exp(0.5 * (u[0] + u[2])) + exp(u[1]);
}

/* Returns the sum of squared errors of the curve 1/q of the unknowns u, for ssgi__field_descend. */
SSGI__FN double ssgi__field_distance_error(const ssgi__field_data *data, const double u[3], double a[3][3], double b[3])
{
    const double first = data->radii[0], length = data->radii[data->count - 1] - first;
    double q[3], sum = 0.0;
    for (int i = 0; i < 3; ++i)
        if (!(fabs(u[i]) < 60.0)) return 1e300;
    ssgi__field_bernstein(q, u, data->most);
    for (int i = 0; i < data->count; ++i) {
        const double t = (data->radii[i] - first) / length, c0 = (1.0 - t) * (1.0 - t), c1 = 2.0 * t * (1.0 - t),
                     c2 = t * t;
        const double value = 1.0 / (c0 * q[0] + c1 * q[1] + c2 * q[2]), residual = data->values[i] - value,
                     slope = value * value;
        sum += residual * residual;
        if (a) {
            const double half = -0.5 * exp(0.5 * (u[0] + u[2]));
            const double d[3] = { slope * (c0 * exp(u[0]) + c1 * half), slope * c1 * exp(u[1]),
                                  slope * (c2 * exp(u[2]) + c1 * half) };
            ssgi__field_equation(a, b, d, -residual);
        }
    }
    return sum;
}

/* Fits the curve 1/q to values in 0..most at three or more ascending radii. q is a quadratic in r as published [AOF05
   eq. 6, 9], but held above 1/most from the first radius, t = 0, to the last, t = 1: q = q0 (1-t)^2 + 2 q1 t (1-t) + q2
   t^2. Returns the sum of squared errors. */
SSGI__FN double ssgi__field_fit(double q[3], const double *radii, const double *values, int count, double most)
{
    const double m = 1.0 / most, first = values[0], last = values[count - 1];
    const ssgi__field_data data = { radii, values, NULL, count, 0, most };
    double u[3], error;
    /* the descent starts from the curve through both ends */
    q[0] = first > 1e-9 * most ? 1.0 / first : 1e9 * m;
    q[2] = last > 1e-9 * most ? 1.0 / last : 1e9 * m;
    for (int i = 0; i < 3; i += 2) u[i] = log(q[i] - m > 1e-9 * m ? q[i] - m : 1e-6 * m);
    q[1] = sqrt(q[0] * q[2]) + exp(0.5 * (u[0] + u[2])) - m;
    u[1] = log(q[1] > 1e-3 * m ? q[1] : 1e-3 * m);
    for (int i = 0; i < 3; ++i) u[i] = u[i] < -50.0 ? -50.0 : u[i] > 50.0 ? 50.0 : u[i];
    error = ssgi__field_descend(u, &data, ssgi__field_distance_error, 1e-16 * most * most);
    ssgi__field_bernstein(q, u, most);
    return error;
}

/* Returns the error by which directions miss a point c, for ssgi__field_descend: with `chord` the sum of squared
   chords, |unit vector to c - direction|^2, else that of (1 - cosine)^2. It is 1e300 for a point beyond the hull's
   tangent at the first radius, where directions would flip. */
SSGI__FN double ssgi__field_centre_error(const ssgi__field_data *data, const double c[3], double a[3][3], double b[3])
{
    double sum = 0.0;
    if (!(ssgi__dot(c, data->w) < 0.999999 * data->radii[0])) return 1e300;
    for (int i = 0; i < data->count; ++i) {
        const double *y = data->values + 3 * i;
        double v[3], length, cosine, residual;
        if (!(y[0] * y[0] + y[1] * y[1] + y[2] * y[2] > 0.25)) continue; /* no function calls here, for speed */
        for (int k = 0; k < 3; ++k) v[k] = c[k] - data->radii[i] * data->w[k];
        length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]); /* above 0, as c is below the first radius along w */
        for (int k = 0; k < 3; ++k) v[k] /= length;
        cosine = v[0] * y[0] + v[1] * y[1] + v[2] * y[2];
        residual = 1.0 - cosine;
        sum += data->chord ? 2.0 * residual : residual * residual;
        for (int n = 0; a && n < (data->chord ? 3 : 1); ++n) { /* one row for each residual: of v - y, or of 1 -
                                                                  cosine */
            double d[3], r = data->chord ? v[n] - y[n] : residual;
            for (int k = 0; k < 3; ++k)
                d[k] = (data->chord ? (k == n ? 1.0 : 0.0) - v[n] * v[k] : cosine * v[k] - y[k]) / length;
            ssgi__field_equation(a, b, d, -r);
        }
    }
    return sum;
}

/* Writes the characteristic centre c [AOF05 eq. 7, 10]: the point to which the directions that are seen from radius * w
   lead, or the origin if they do not determine a point. Returns the sum of (1 - cosine)^2, never above that of the
   origin. Since this error is flat near its least, descent on the chords comes first, and descent on the error then
   polishes.
     directions   unit, 3 each; zero vectors do not count
     flat         the origin is the centre if its error is at most this, which is too small to determine a point */
SSGI__FN double ssgi__field_centre(double c[3], const double w[3], const double *radii, const double *directions,
                                   int count, double flat)
{
    ssgi__field_data data = { radii, directions, w, count, 0, 0.0 };
    double at[3] = { 0.0, 0.0, 0.0 }, error, best;
    memset(c, 0, sizeof at);
    best = ssgi__field_centre_error(&data, c, NULL, NULL);
    if (!(best > flat)) return best; /* all directions lead to the origin already, so c is undetermined */
    for (int polish = 0; polish < 2; ++polish) {
        data.chord = !polish;
        ssgi__field_descend(at, &data, ssgi__field_centre_error, 1e-16);
        data.chord = 0;
        error = ssgi__field_centre_error(&data, at, NULL, NULL);
        if (error >= best) continue;
        best = error;
        memcpy(c, at, sizeof at);
    }
    return best;
}

/* ---- the occluder: its place and its convex hull */

typedef struct ssgi__field_occluder {
    ssgi_trace trace;
    double centre[3], radius;
    /* corners of the hull, from the centre, and the distance by which the hull may reach beyond them */
    double few[SSGI__FIELD_FEW][3], loose;
} ssgi__field_occluder;

/* Writes the corner that is farthest along n, from the centre. Returns its distance along n. Nodes whose box ends
   before the farthest corner found so far are skipped. */
SSGI__FN double ssgi__field_farthest(const ssgi__field_occluder *m, const double n[3], double out[3])
{
    const ssgi__trace_node *nodes = (const ssgi__trace_node *)m->trace.nodes;
    const ssgi__trace_block *blocks = (const ssgi__trace_block *)m->trace.blocks;

    struct {
        uint32_t child;
        double most;
    } stack[SSGI__TRACE_STACK];

    double best = -1e300, p[3];
    int top = 0;
    stack[top].child = 0;
    stack[top++].most = 1e300;
    while (top) {
        const uint32_t child = stack[--top].child;
        if (stack[top].most <= best) continue;
        if (child & SSGI__TRACE_LEAF) {
            const ssgi__trace_block *block = blocks + (child & ~SSGI__TRACE_LEAF);
            for (int k = 0; k < 4 && block->triangle[k] != SSGI__TRACE_NONE; ++k)
                for (int c = 0; c < 3; ++c) {
                    for (int i = 0; i < 3; ++i) p[i] = (double)block->corner[c][i][k] - m->centre[i];
                    const double s = ssgi__dot(n, p);
                    if (s > best) {
                        best = s;
                        memcpy(out, p, sizeof p);
                    }
                }
        } else {
            const ssgi__trace_node *node = nodes + child;
            const int base = top;
            for (int k = 0; k < SSGI__TRACE_WIDE; ++k) {
                double most = 0.0;
                int j;
                if (node->bound[0][0][k] > node->bound[1][0][k]) continue; /* empty */
                for (int i = 0; i < 3; ++i) most += n[i] * ((double)node->bound[n[i] > 0.0][i][k] - m->centre[i]);
                if (most <= best) continue;
                for (j = top++; j > base && stack[j - 1].most > most; --j) stack[j] = stack[j - 1];
                stack[j].child = node->child[k];
                stack[j].most = most;
            }
        }
    }
    return best;
}

/* A triangle of hull corners that a ray from the centre crosses, in the plane normal . x = distance. */
typedef struct ssgi__field_portal {
    double corner[3][3], normal[3], distance;
} ssgi__field_portal;

/* Sets the plane of a portal from its three corners. */
SSGI__FN void ssgi__field_portal_plane(ssgi__field_portal *p)
{
    double a[3], b[3];
    ssgi__along(a, p->corner[1], -1.0, p->corner[0]);
    ssgi__along(b, p->corner[2], -1.0, p->corner[0]);
    ssgi__cross(p->normal, a, b);
    ssgi__normalise(p->normal);
    p->distance = ssgi__dot(p->normal, p->corner[0]);
}

/* Returns how far beyond the hull samples of an occluder start, so that none starts inside the mesh. */
SSGI__FN double ssgi__field_slack(const ssgi__field_occluder *m) { return 1e-4 * m->radius; }

/* Returns the distance at which a ray from the centre along w leaves the hull, and in p the portal there. The portal is
   at first a face of a small octahedron about the centre, which counts as part of the hull so that even flat occluders
   have one. The hull's farthest corner along its normal splits it, until no corner is beyond its plane. */
SSGI__FN double ssgi__field_exit(const ssgi__field_occluder *m, const double w[3], ssgi__field_portal *p)
{
    const int turned = (w[0] < 0.0) ^ (w[1] < 0.0) ^ (w[2] < 0.0); /* an odd number of axes is mirrored */
    memset(p, 0, sizeof *p);
    for (int i = 0; i < 3; ++i)
        p->corner[turned && i < 2 ? 1 - i : i][i] = w[i] < 0.0 ? -1e-3 * m->radius : 1e-3 * m->radius;
    for (int step = 0; step < 200; ++step) {
        double farthest[3], inside = -1e300;
        ssgi__field_portal split[3];
        int best = 0;
        ssgi__field_portal_plane(p);
        if (!(ssgi__field_farthest(m, p->normal, farthest) > p->distance + 1e-7 * m->radius)) break;
        for (int i = 0; i < 3; ++i) { /* of the portal's three parts, takes the one that holds the ray by the largest
                                         margin */
            double least = 1e300;
            split[i] = *p;
            memcpy(split[i].corner[i], farthest, sizeof farthest);
            for (int k = 0; k < 3; ++k) {
                double side[3], s;
                ssgi__cross(side, split[i].corner[k], split[i].corner[(k + 1) % 3]);
                s = ssgi__dot(side, w);
                if (s < least) least = s;
            }
            if (least > inside) {
                inside = least;
                best = i;
            }
        }
        *p = split[best];
    }
    const double facing = ssgi__dot(p->normal, w);
    return facing > 1e-9 ? p->distance / facing : m->radius;
}

/* Writes direction i of n that are evenly spread over the sphere, in a spiral by the golden angle. */
SSGI__FN void ssgi__field_spiral(double w[3], int i, int n)
{
    ssgi__polar(w, 1.0 - (2.0 * i + 1.0) / n, 2.39996322972865332 * i);
}

/* Measures an occluder: its centre, its radius, corners of its hull, and how far the hull may reach beyond them. The
   centre is the mean of the farthest corners over all directions: the hull's Steiner point, which is inside. Returns 0
   if the occluder has no extent. */
SSGI__FN int ssgi__field_measure(ssgi__field_occluder *m)
{
    const ssgi__trace_block *blocks = (const ssgi__trace_block *)m->trace.blocks;
    double w[3], p[3], centre[3] = { 0.0, 0.0, 0.0 };
    if (!m->trace.node_count) return 0;
    for (int n = 0; n < SSGI__FIELD_FEW; ++n) {
        ssgi__field_spiral(w, n, SSGI__FIELD_FEW);
        ssgi__field_farthest(m, w, m->few[n]);
        for (int k = 0; k < 3; ++k) centre[k] += m->few[n][k] / SSGI__FIELD_FEW;
    }
    for (int k = 0; k < 3; ++k) {
        volatile float rounded = (float)centre[k]; /* gcc 12's vectoriser drops (double)(float) */
        m->centre[k] = (double)rounded;
    }
    for (int n = 0; n < SSGI__FIELD_FEW; ++n) ssgi__along(m->few[n], m->few[n], -1.0, m->centre);
    for (uint32_t i = 0; i < m->trace.block_count; ++i)
        for (int n = 0; n < 4 && blocks[i].triangle[n] != SSGI__TRACE_NONE; ++n)
            for (int c = 0; c < 3; ++c) {
                for (int k = 0; k < 3; ++k) p[k] = (double)blocks[i].corner[c][k][n] - m->centre[k];
                if (ssgi__dot(p, p) > m->radius) m->radius = ssgi__dot(p, p);
            }
    m->radius = sqrt(m->radius);
    if (!(m->radius > 1e-12)) return 0;
    for (uint32_t i = 0; i < 4 * SSGI__FIELD_FEW; ++i) {
        double most = -1e300, beyond;
        ssgi__field_spiral(w, (int)i, 4 * SSGI__FIELD_FEW);
        for (int n = 0; n < SSGI__FIELD_FEW; ++n) {
            const double s = ssgi__dot(w, m->few[n]);
            if (s > most) most = s;
        }
        beyond = ssgi__field_farthest(m, w, p) - most;
        if (beyond > m->loose) m->loose = beyond;
    }
    m->loose = 1.5 * m->loose + 1e-3 * m->radius; /* a margin, as the hull may reach farther in directions between those
                                                     that were tried */
    return 1;
}

/* Finds a cone from a point outside of the hull that holds all of the occluder. Writes its axis and returns the cosine
   of its half-angle. The cone is about the mean direction to some corners, and wider by the distance that the hull may
   reach beyond them; or it is the half space below the hull's plane. */
SSGI__FN float ssgi__field_cone(double axis[3], const ssgi__field_occluder *m, const double point[3],
                                const double normal[3])
{
    double least = 1.0, d[SSGI__FIELD_FEW][4], ax = 0.0, ay = 0.0, az = 0.0; /* d: unit vectors and lengths */
    for (int i = 0; i < SSGI__FIELD_FEW; ++i) { /* written out, as function calls took an eighth of a bake's time */
        const double x = m->few[i][0] - point[0], y = m->few[i][1] - point[1], z = m->few[i][2] - point[2],
                     length = sqrt(x * x + y * y + z * z), some = length > 0.0 ? length : 1.0;
        ax += d[i][0] = x / some;
        ay += d[i][1] = y / some;
        az += d[i][2] = z / some;
        d[i][3] = length;
    }
    axis[0] = ax;
    axis[1] = ay;
    axis[2] = az;
    if (!(ssgi__normalise(axis) > 0.0)) least = -1.0;
    for (int i = 0; i < SSGI__FIELD_FEW && least > 0.0; ++i) {
        const double c = d[i][0] * axis[0] + d[i][1] * axis[1] + d[i][2] * axis[2], s = m->loose / d[i][3];
        if (c - s - s * s > least + 1e-9) continue; /* `wide` is above c - s - s * s, so it is not the least */
        const double wide = s < 1.0 ? c * sqrt(1.0 - s * s) - sqrt(c < 1.0 ? 1.0 - c * c : 0.0) * s : -1.0;
        if (wide < least) least = wide;
    }
    if (least > 0.0) return (float)(least * (1.0 - 1e-6));
    for (int k = 0; k < 3; ++k) axis[k] = -normal[k];
    return 0.0f;
}

/* ---- baking */

typedef struct ssgi__field_bake {
    const ssgi_field_desc *desc;
    ssgi__field_occluder occluder;
    ssgi_field *field;
    int size;             /* texels along a face of the fine map: twice the field's resolution, or with unfiltered the
                             same */
    float *fine, *coarse; /* maps of eight components a texel, six faces; the coarse one has the field's resolution */
    float *error;         /* errors of validation receivers, in the memory of fine */
    int first;            /* texel of job 0 */
} ssgi__field_bake;

/* Returns the number of texel x, y of a face. If x or y is beyond the face's edges, the texel is one of the
   neighbouring face. */
SSGI__FN size_t ssgi__cube_texel(int face, int x, int y, int size)
{
    if (x < 0 || y < 0 || x >= size || y >= size) {
        double d[3];
        float w[3], at[2];
        ssgi__cube_direction(d, face, (2 * x + 1.0) / size - 1.0, (2 * y + 1.0) / size - 1.0);
        ssgi__floats(w, d);
        face = ssgi__cube_place(at, w);
        x = ssgi__clamp((int)((0.5f * at[0] + 0.5f) * (float)size), 0, size - 1);
        y = ssgi__clamp((int)((0.5f * at[1] + 0.5f) * (float)size), 0, size - 1);
    }
    return (size_t)(face * size + y) * (size_t)size + (size_t)x;
}

/* Samples the occluder from the point at distance r along w from the centre, by rays in the cone that encloses the
   occluder, and writes the point. `sum` is `out` of ssgi__field_sample. */
SSGI__FN void ssgi__field_look(double sum[4], double occlusion[4], double normal[4][3], float point[3],
                               const ssgi__field_bake *b, const double w[3], double r, const ssgi__field_portal *portal,
                               int rays, uint32_t seed)
{
    double at[3], axis[3];
    for (int k = 0; k < 3; ++k) {
        at[k] = r * w[k];
        point[k] = (float)(at[k] + b->occluder.centre[k]);
    }
    const float cosine = ssgi__field_cone(axis, &b->occluder, at, portal->normal);
    ssgi__field_sample(sum, occlusion, normal, &b->occluder.trace, b->desc->hit, b->desc->user, point, axis, cosine,
                       rays, seed);
}

/* Samples the occluder along the direction w, at all of the bake's radii, by desc.sample; each sum is a solid angle and
   a vector irradiance. */
SSGI__FN void ssgi__field_yours(double sum[][4], const ssgi__field_bake *b, const double w[3], const double *radii)
{
    float point[3 * 64], out[4 * 64];
    memset(out, 0, sizeof out);
    for (int i = 0; i < b->desc->radii; ++i)
        for (int k = 0; k < 3; ++k) point[3 * i + k] = (float)(radii[i] * w[k] + b->occluder.centre[k]);
    b->desc->sample(b->desc->user, out, point, b->desc->radii);
    for (int i = 0; i < b->desc->radii; ++i) {
        double length, most;
        memset(sum[i], 0, sizeof sum[i]);
        if (!ssgi__finites(out + 4 * i, 4) || !(out[4 * i] > 0.0f)) continue;
        sum[i][0] = (double)ssgi__min(out[4 * i], 6.28318531f); /* at most a hemisphere, as the point is beyond the
                                                                   hull */
        ssgi__doubles(sum[i] + 1, out + 4 * i + 1);
        length = ssgi__normalise(sum[i] + 1);
        most = 1.0 - sum[i][0] / (4.0 * SSGI__PI); /* length of the mean of all directions in a cap that is filled */
        for (int k = 1; k < 4; ++k) sum[i][k] *= sum[i][0] * (length < most ? length : most);
    }
}

/* Returns how many rays are traced from a point at a distance from the centre. share: the hull's distance / this
   distance. */
SSGI__FN int ssgi__field_rays(int rays, double share)
{
    const int fewer = (int)((double)rays * share);
    return fewer > 16 ? fewer : 16;
}

/* Makes one texel of a bake's fine map: takes samples of the occluder along its direction and fits the components to
   them. */
SSGI__FN void ssgi__field_texel(void *context, int job)
{
    ssgi__field_bake *b = (ssgi__field_bake *)context;
    const int size = b->size, texel = b->first + job, face = texel / (size * size), y = texel / size % size,
              x = texel % size;
    const double reach = (double)b->field->reach;
    float *out = b->fine + 8 * (size_t)texel, point[3];
    double w[3], radii[64], sums[64][4], values[64], directions[3 * 64], q[3], c[3];
    double hull, length, fill = 0.0, seen = 0.0;
    ssgi__field_portal portal;
    ssgi__cube_direction(w, face, (2 * x + 1.0) / size - 1.0, (2 * y + 1.0) / size - 1.0);
    hull = ssgi__field_exit(&b->occluder, w, &portal) + ssgi__field_slack(&b->occluder);
    for (int i = 0; i < b->desc->radii; ++i) radii[i] = hull * pow(reach / hull, (double)i / (b->desc->radii - 1));
    if (b->desc->sample) ssgi__field_yours(sums, b, w, radii);
    for (int i = 0; i < b->desc->radii; ++i) {
        double *sum = sums[i];
        if (!b->desc->sample)
            ssgi__field_look(sum, NULL, NULL, point, b, w, radii[i], &portal,
                             ssgi__field_rays(b->desc->rays, hull / radii[i]), (uint32_t)(texel * 64 + i));
        length = ssgi__normalise(sum + 1);
        values[i] = length < SSGI__PI ? length : SSGI__PI;
        if (sum[0] > 0.0) { /* covered share of the cap with this vector irradiance and solid angle */
            const double edge = 2.0 * length / sum[0] > 1.0 ? 2.0 * length / sum[0] - 1.0 : 0.0,
                         share = length / (SSGI__PI * (1.0 - edge * edge));
            fill += sum[0] * (edge < 0.9999 && share < 1.0 ? share : 1.0);
            seen += sum[0];
        }
        memcpy(directions + 3 * i, sum + 1, 3 * sizeof *sum);
    }
    ssgi__field_fit(q, radii, values, b->desc->radii, SSGI__PI);
    /* the tolerance is the rays' noise: without it a centre near the hull would be fitted to that noise */
    ssgi__field_centre(c, w, radii, directions, b->desc->radii,
                       0.0625 * b->desc->radii / ((double)b->desc->rays * b->desc->rays));
    length = sqrt(ssgi__dot(c, c));
    if (length > b->occluder.radius)
        for (int k = 0; k < 3; ++k) c[k] = c[k] * b->occluder.radius / length;
    q[1] += sqrt(q[0] * q[2]); /* positive if q > 0 on [0,1], so that it has a logarithm; blends of logarithms keep q
                                  positive */
    for (int k = 0; k < 3; ++k) out[k] = ssgi__min((float)(log(q[k]) * 1.44269504088896341), 20.0f);
    out[3] = (float)hull;
    ssgi__floats(out + 4, c);
    out[7] = seen > 0.0 ? (float)(fill / seen) : 1.0f;
}

/* Makes the field's map of a bake's fine map: each texel is a Gaussian mean of 4 x 4 fine texels, with a deviation of
   one fine texel. A fine map of the field's own resolution is copied. */
SSGI__FN void ssgi__field_reduce(const ssgi__field_bake *b)
{
    static const float weight[4] = { 0.13447f, 0.36553f, 0.36553f, 0.13447f };
    const int size = b->field->resolution;
    if (b->size == size) memcpy(b->coarse, b->fine, (size_t)(48 * size * size) * sizeof *b->fine);
    for (int face = 0; face < 6 && b->size > size; ++face)
        for (int y = 0; y < size; ++y)
            for (int x = 0; x < size; ++x) {
                float *out = b->coarse + 8 * ssgi__cube_texel(face, x, y, size);
                for (int n = 0; n < 8; ++n) out[n] = 0.0f;
                for (int i = 0; i < 4; ++i)
                    for (int k = 0; k < 4; ++k) {
                        const float *in = b->fine + 8 * ssgi__cube_texel(face, 2 * x - 1 + k, 2 * y - 1 + i, 2 * size);
                        for (int n = 0; n < 8; ++n) out[n] += weight[i] * weight[k] * in[n];
                    }
            }
}

/* Makes a field's texels of a bake's coarse map, with 8 bits for each component over its range, and with borders. */
SSGI__FN void ssgi__field_quantise(const ssgi__field_bake *b, uint32_t *texels)
{
    ssgi_field *f = b->field;
    const int size = f->resolution;
    float high[8];
    for (int n = 0; n < 8; ++n) {
        f->low[n] = high[n] = b->coarse[n];
        for (int i = 1; i < 6 * size * size; ++i) {
            f->low[n] = ssgi__min(f->low[n], b->coarse[8 * i + n]);
            high[n] = ssgi__max(high[n], b->coarse[8 * i + n]);
        }
        f->span[n] = high[n] - f->low[n];
    }
    f->texels = texels;
    for (int face = 0; face < 6; ++face)
        for (int y = -1; y <= size; ++y)
            for (int x = -1; x <= size; ++x, texels += 2) {
                const int xi = ssgi__clamp(x, 0, size - 1), yi = ssgi__clamp(y, 0, size - 1);
                const int corner = x != xi && y != yi; /* three faces meet there, and the border holds their mean [GL
                                                          8.14] */
                const float *a = b->coarse + 8 * ssgi__cube_texel(face, x, corner ? yi : y, size),
                            *up = b->coarse + 8 * ssgi__cube_texel(face, xi, y, size),
                            *own = b->coarse + 8 * ssgi__cube_texel(face, xi, yi, size);
                texels[0] = texels[1] = 0;
                for (int n = 0; n < 8; ++n) {
                    float v = corner ? (a[n] + up[n] + own[n]) / 3.0f : a[n];
                    v = f->span[n] > 0.0f ? (v - f->low[n]) / f->span[n] * 255.0f + 0.5f : 0.0f;
                    texels[n / 4] |= (uint32_t)(v < 255.0f ? v : 255.0f) << 8 * (n % 4);
                }
            }
}

/* Returns A_0, the mean occlusion of points in the hull, weighted toward the centre. A point does not count if more
   than 95 % of its rays hit, since the mesh then encloses it. If no point counts, A_0 is 1. */
SSGI__FN float ssgi__field_inside(const ssgi__field_bake *b)
{
    const double up[3] = { 0.0, 0.0, 1.0 }, sphere = 4.0 * SSGI__PI;
    double sum = 0.0, weight = 0.0, w[3], out[4];
    ssgi__field_portal portal;
    float point[3];
    for (int i = 0; i < 256; ++i) {
        const double r = ssgi__turn((uint32_t)i);
        ssgi__field_spiral(w, i, 256);
        ssgi__along(w, b->occluder.centre, r * ssgi__field_exit(&b->occluder, w, &portal), w);
        ssgi__floats(point, w);
        ssgi__field_sample(out, NULL, NULL, &b->occluder.trace, b->desc->hit, b->desc->user, point, up, -1.0f, 128,
                           (uint32_t)i);
        if (out[0] > 0.95 * sphere) continue;
        sum += out[0] / sphere * (1.0 - r);
        weight += 1.0 - r;
    }
    return weight > 0.0 ? (float)(sum / weight) : 1.0f;
}

/* Measures the field's errors at validation position i, at four receivers, by 1024 rays. The ramp's limits lie beyond
   the reach, so that occlusion does not fade. */
SSGI__FN void ssgi__field_held(void *context, int i)
{
    ssgi__field_bake *b = (ssgi__field_bake *)context;
    const ssgi_field_limits limits = { 2.0f * b->field->reach, 2.0f * b->field->reach, b->field->inside, 1.0f };
    const double share = 0.999 * ((double)ssgi_radical_inverse(2, (uint32_t)i) + 0.5 / SSGI__FIELD_HELD);
    double w[3], sum[4], occlusion[4], normal[4][3], hull;
    float point[3], facing[3];
    ssgi__field_portal portal;
    ssgi__field_spiral(w, i, SSGI__FIELD_HELD);
    hull = ssgi__field_exit(&b->occluder, w, &portal) + ssgi__field_slack(&b->occluder);
    for (int n = 0; n < 4; ++n) { /* no normal faces straight away from the occluder: occlusion would be 0 */
        ssgi__polar(normal[n], 2.0 * ssgi__turn((uint32_t)(8 * i + n)) - 1.0,
                    2.0 * SSGI__PI * ssgi__turn((uint32_t)(8 * i + n + 4)));
        if (ssgi__dot(normal[n], w) > 0.5)
            for (int k = 0; k < 3; ++k) normal[n][k] = -normal[n][k];
    }
    ssgi__field_look(sum, occlusion, normal, point, b, w, hull * pow((double)b->field->reach / hull, share), &portal,
                     1024, (uint32_t)i ^ 0x55555555u);
    for (int n = 0; n < 4; ++n) {
        ssgi__floats(facing, normal[n]);
        b->error[4 * i + n] = fabsf(ssgi_field_occlusion(b->field, &limits, point, facing) - (float)occlusion[n]);
    }
}

/* Runs job(context, i) for every i in [0, count), by desc->parallel if it is set. */
SSGI__FN void ssgi__field_run(const ssgi_field_desc *desc, int count, void (*job)(void *, int), void *context)
{
    if (desc->parallel) desc->parallel(desc->user, count, job, context);
    else
        for (int i = 0; i < count; ++i) job(context, i);
}

/* Returns the least error that this share of the validation receivers does not exceed. */
SSGI__FN float ssgi__field_rank(const ssgi__field_bake *b, double share)
{
    const int all = 4 * SSGI__FIELD_HELD;
    float least = 1e30f;
    for (int i = 0; i < all; ++i) {
        int within = 0;
        if (!(b->error[i] < least)) continue;
        for (int k = 0; k < all; ++k) within += b->error[k] <= b->error[i];
        if (within >= share * all) least = b->error[i];
    }
    return least;
}

SSGI_DEF size_t ssgi_field_size(int resolution)
{
    if (resolution < 2 || resolution > 128) return 0;
    return (size_t)(12 * (resolution + 2) * (resolution + 2)) * sizeof(uint32_t);
}

/* Returns a copy of a desc, with defaults in place. */
SSGI__FN ssgi_field_desc ssgi__field_resolve(const ssgi_field_desc *desc)
{
    ssgi_field_desc d = *desc;
    if (!d.resolution) d.resolution = 16;
    if (!d.radii) d.radii = 12;
    if (!d.rays) d.rays = 96;
    if (!(d.reach > 0.0f)) d.reach = 8.0f;
    return d;
}

SSGI__FN ssgi_result ssgi__field_check(const ssgi_field_desc *desc, const char **why)
{
    SSGI__THERE(desc);
    SSGI__ZERO_OR(desc->resolution, "desc.resolution", 2, 128);
    SSGI__ZERO_OR(desc->radii, "desc.radii", 4, 64);
    SSGI__ZERO_OR(desc->rays, "desc.rays", 16, 65536);
    SSGI__CHECK(ssgi__zero_or(desc->reach, 1.5f, 64.0f), "desc.reach: must be 0 or 1.5..64");
    SSGI__CHECK(desc->unfiltered == 0 || desc->unfiltered == 1, "desc.unfiltered: must be 0 or 1");
    return SSGI_OK;
}

/* Returns the number of floats that both maps of a bake take; the errors use the fine map's memory. */
SSGI__FN size_t ssgi__field_floats(int resolution)
{
    const size_t fine = (size_t)(8 * 24 * resolution * resolution), held = 4 * SSGI__FIELD_HELD;
    return (fine > held ? fine : held) + fine / 4;
}

SSGI_DEF size_t ssgi_field_bake_size(const ssgi_field_desc *desc, size_t triangles)
{
    if (ssgi__field_check(desc, NULL) != SSGI_OK || !ssgi_trace_size(triangles)) return 0;
    const size_t rest = 64 + ssgi__field_floats(ssgi__field_resolve(desc).resolution) * sizeof(float);
    return rest > (size_t)-1 - ssgi_trace_size(triangles) ? 0 : rest + ssgi_trace_size(triangles);
}

SSGI_DEF ssgi_result ssgi_field_bake(ssgi_field *field, uint32_t *texels, void *work, size_t work_size,
                                     const ssgi_field_desc *desc, const float *position, size_t stride_bytes,
                                     const uint32_t *index, size_t triangles, const char **why)
{
    ssgi__field_bake b;
    ssgi_field f;
    SSGI__THERE3(field, texels, work);
    SSGI__TRY(ssgi__field_check(desc, why));
    SSGI__THERE(position);
    SSGI__TRY(ssgi__trace_bad(stride_bytes, triangles, why));
    SSGI__ENOUGH(work_size, ssgi_field_bake_size(desc, triangles),
                 "work_size: must be at least ssgi_field_bake_size(desc, triangles)");
    const ssgi_field_desc d = ssgi__field_resolve(desc);
    memset(&b, 0, sizeof b);
    memset(&f, 0, sizeof f);
    b.desc = &d;
    b.field = &f;
    b.fine = b.error = (float *)(void *)((char *)work + (64 - (size_t)((uintptr_t)work & 63)) % 64);
    b.coarse = b.fine + ssgi__field_floats(d.resolution) - (size_t)(48 * d.resolution * d.resolution);
    SSGI__TRY(ssgi_trace_build(&b.occluder.trace, b.fine + ssgi__field_floats(d.resolution), ssgi_trace_size(triangles),
                               position, stride_bytes, index, triangles, why));
    SSGI__CHECK(ssgi__field_measure(&b.occluder), "position: no triangle has an area");
    f.radius = (float)b.occluder.radius;
    f.reach = d.reach * f.radius;
    ssgi__floats(f.centre, b.occluder.centre);
    f.inside = ssgi__field_inside(&b);
    f.resolution = d.resolution;
    f.radii = d.radii;
    b.size = d.unfiltered ? d.resolution : 2 * d.resolution;
    const int block = d.resolution * d.resolution, all = 6 * b.size * b.size;
    for (b.first = 0; b.first < all; b.first += block) {
        if (d.progress && d.progress(d.user, (float)b.first / (float)all)) {
            ssgi__bad(why, "desc.progress: gave the bake up");
            return SSGI_CANCELLED;
        }
        ssgi__field_run(&d, all - b.first < block ? all - b.first : block, ssgi__field_texel, &b);
    }
    ssgi__field_reduce(&b);
    ssgi__field_quantise(&b, texels);
    ssgi__field_run(&d, SSGI__FIELD_HELD, ssgi__field_held, &b);
    f.median = ssgi__field_rank(&b, 0.5);
    f.p95 = ssgi__field_rank(&b, 0.95);
    f.max_error = ssgi__field_rank(&b, 1.0);
    if (d.progress) d.progress(d.user, 1.0f);
    *field = f;
    return SSGI_OK;
}

/* ---- looking up */

SSGI_DEF ssgi_field_limits ssgi_field_limits_of(const ssgi_field *field)
{
    const ssgi_field_limits l = { 0.75f * field->reach, field->reach, field->inside, 1.0f };
    return l;
}

/* Fetches a field's eight components along w, bilinear between texels, in their own units. */
SSGI__FN void ssgi__field_fetch(float out[8], const ssgi_field *f, const float w[3])
{
    float at[2];
    const int face = ssgi__cube_place(at, w), row = f->resolution + 2;
    int cell[2];
    for (int k = 0; k < 2; ++k) {
        at[k] = (0.5f * at[k] + 0.5f) * (float)f->resolution + 0.5f;
        cell[k] = ssgi__clamp((int)at[k], 0, f->resolution);
        at[k] -= (float)cell[k];
    }
    for (int n = 0; n < 8; ++n) out[n] = 0.0f;
    for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k) {
            const uint32_t *texel = f->texels + 2 * ((face * row + cell[1] + i) * row + cell[0] + k);
            const float weight = (i ? at[1] : 1.0f - at[1]) * (k ? at[0] : 1.0f - at[0]);
            for (int n = 0; n < 8; ++n) out[n] += weight * (float)(texel[n / 4] >> 8 * (n % 4) & 255u);
        }
    for (int n = 0; n < 8; ++n) out[n] = f->low[n] + out[n] / 255.0f * f->span[n];
}

SSGI_DEF float ssgi_field_occlusion(const ssgi_field *field, const ssgi_field_limits *limits, const float point[3],
                                    const float normal[3])
{
    const ssgi_field_limits l = limits ? *limits : ssgi_field_limits_of(field);
    float solid_angle, fill, axis[3], d[3], hulls, cosine, r, a;
    for (int k = 0; k < 3; ++k) {
        if (!ssgi__finite(point[k]) || !ssgi__finite(normal[k])) return 0.0f;
        d[k] = point[k] - field->centre[k];
    }
    r = sqrtf(d[0] * d[0] + d[1] * d[1] + d[2] * d[2]);
    if (!(r < l.reach)) return 0.0f;
    hulls = ssgi_field_cap(&solid_angle, axis, &fill, field, point);
    cosine = axis[0] * normal[0] + axis[1] * normal[1] + axis[2] * normal[2];
    a = fill * (float)ssgi_cap_occlusion((double)solid_angle, (double)cosine);
    if (hulls < 1.0f) a = l.inside + (a - l.inside) * powf(hulls, l.power);
    if (r > l.ramp) {
        const float t = (r - l.ramp) / (l.reach - l.ramp);
        a *= 1.0f - t * t * (3.0f - 2.0f * t);
    }
    return a > 0.0f ? a < 1.0f ? a : 1.0f : 0.0f;
}

SSGI_DEF float ssgi_field_cap(float *solid_angle, float axis[3], float *fill, const ssgi_field *field,
                              const float point[3])
{
    const float most = 3.14159265f;
    double w[3], v[3];
    float direction[3], c[8], r, hull, t, q0, q1, q2, q, s;
    for (int k = 0; k < 3; ++k) w[k] = ssgi__finite(point[k]) ? (double)point[k] - (double)field->centre[k] : 0.0;
    r = (float)ssgi__normalise(w);
    if (!(r > 0.0f && r < 1e18f)) {
        w[0] = w[1] = 0.0;
        w[2] = 1.0;
        r = r > 1.0f ? 1e18f : 0.0f;
    }
    ssgi__floats(direction, w);
    ssgi__field_fetch(c, field, direction);
    hull = c[3];
    t = r > hull ? r < field->reach ? (r - hull) / (field->reach - hull) : 1.0f : 0.0f;
    q0 = exp2f(c[0]);
    q2 = exp2f(c[2]);
    q1 = exp2f(c[1]) - sqrtf(q0 * q2);
    q = q0 * (1.0f - t) * (1.0f - t) + 2.0f * q1 * t * (1.0f - t) + q2 * t * t;
    s = q * most > 1.0f ? 1.0f / (q * most) : 1.0f; /* vector irradiance over pi */
    *fill = ssgi__min(ssgi__max(c[7], s), 1.0f);
    s /= *fill;
    *solid_angle = 6.2831853f * s / (1.0f + sqrtf(1.0f - s));
    for (int k = 0; k < 3; ++k) v[k] = (double)c[4 + k] - (double)(r > hull ? r : hull) * w[k];
    if (!(ssgi__normalise(v) > 0.0))
        for (int k = 0; k < 3; ++k) v[k] = -w[k];
    ssgi__floats(axis, v);
    return r / hull;
}

/* ---- files: 32-bit words, lowest byte first: magic number, version, resolution, radii; the field's other numbers as
   floats; texels; two words of checksum over all words before */

#define SSGI__FIELD_NUMBERS 25
#define SSGI__FIELD_HEAD (4 + SSGI__FIELD_NUMBERS) /* words before the texels */
#define SSGI__FIELD_MAGIC 0x69677373u              /* "ssgi" */
#define SSGI__FIELD_VERSION 0x32464f41u            /* "AOF2" */

SSGI__FN void ssgi__field_put(unsigned char *out, size_t i, uint32_t word)
{
    for (int k = 0; k < 4; ++k) out[4 * i + (size_t)k] = (unsigned char)(word >> 8 * k);
}

SSGI__FN uint32_t ssgi__field_get(const unsigned char *in, size_t i)
{
    return (uint32_t)in[4 * i] | (uint32_t)in[4 * i + 1] << 8 | (uint32_t)in[4 * i + 2] << 16
         | (uint32_t)in[4 * i + 3] << 24;
}

/* Writes the addresses of a field's floats, in the order of a file. */
SSGI__FN void ssgi__field_numbers(float *number[SSGI__FIELD_NUMBERS], ssgi_field *f)
{
    size_t n = 0;
    for (int k = 0; k < 3; ++k) number[n++] = &f->centre[k];
    number[n++] = &f->radius;
    number[n++] = &f->reach;
    number[n++] = &f->inside;
    for (int k = 0; k < 8; ++k) number[n++] = &f->low[k];
    for (int k = 0; k < 8; ++k) number[n++] = &f->span[k];
    number[n++] = &f->median;
    number[n++] = &f->p95;
    number[n++] = &f->max_error;
}

/* Returns the FNV-1a hash. */
SSGI__FN uint64_t ssgi__field_checksum(const unsigned char *data, size_t size)
{
    uint64_t h = 14695981039346656037u;
    for (; size; --size) h = (h ^ *data++) * 1099511628211u;
    return h;
}

SSGI_DEF size_t ssgi_field_save(void *out, size_t capacity, const ssgi_field *field)
{
    unsigned char *bytes = (unsigned char *)out;
    const size_t words = field ? ssgi_field_size(field->resolution) / 4 : 0,
                 size = words ? 4 * (SSGI__FIELD_HEAD + words + 2) : 0;
    float *number[SSGI__FIELD_NUMBERS];
    ssgi_field f;
    if (!words || capacity < size || !out) return size;
    f = *field;
    ssgi__field_numbers(number, &f);
    ssgi__field_put(bytes, 0, SSGI__FIELD_MAGIC);
    ssgi__field_put(bytes, 1, SSGI__FIELD_VERSION);
    ssgi__field_put(bytes, 2, (uint32_t)field->resolution);
    ssgi__field_put(bytes, 3, (uint32_t)field->radii);
    for (size_t i = 0; i < SSGI__FIELD_NUMBERS; ++i) {
        uint32_t word;
        memcpy(&word, number[i], sizeof word);
        ssgi__field_put(bytes, 4 + i, word);
    }
    for (size_t i = 0; i < words; ++i) ssgi__field_put(bytes, SSGI__FIELD_HEAD + i, field->texels[i]);
    const uint64_t h = ssgi__field_checksum(bytes, size - 8);
    ssgi__field_put(bytes, size / 4 - 2, (uint32_t)h);
    ssgi__field_put(bytes, size / 4 - 1, (uint32_t)(h >> 32));
    return size;
}

/* Reads and checks all of a field's file except the texels. */
SSGI__FN ssgi_result ssgi__field_head(ssgi_field *f, const void *file, size_t size, const char **why)
{
    static const char corrupt[] = "file: is corrupt";
    const unsigned char *bytes = (const unsigned char *)file;
    float *number[SSGI__FIELD_NUMBERS];
    uint32_t head[4] = { 0 };
    size_t words = 0;
    SSGI__THERE(file);
    for (size_t i = 0; i < 4 && 4 * i + 4 <= size; ++i) head[i] = ssgi__field_get(bytes, i);
    SSGI__CHECK(head[0] == SSGI__FIELD_MAGIC && (head[1] & 0xffffffu) == (SSGI__FIELD_VERSION & 0xffffffu),
                "file: is not an ambient occlusion field");
    SSGI__CHECK(head[1] == SSGI__FIELD_VERSION, "file: is of another version");
    SSGI__CHECK(size >= 4 * SSGI__FIELD_HEAD, "file: is cut short");
    memset(f, 0, sizeof *f);
    if (head[2] <= 128u) words = ssgi_field_size((int)head[2]) / 4;
    SSGI__CHECK(words && head[3] <= 64u, corrupt);
    f->resolution = (int)head[2];
    f->radii = (int)head[3];
    SSGI__CHECK(size >= 4 * (SSGI__FIELD_HEAD + words + 2), "file: is cut short");
    SSGI__CHECK(size <= 4 * (SSGI__FIELD_HEAD + words + 2), "file: is longer than its field");
    const uint64_t h = ssgi__field_get(bytes, size / 4 - 2) | (uint64_t)ssgi__field_get(bytes, size / 4 - 1) << 32;
    SSGI__CHECK(ssgi__field_checksum(bytes, size - 8) == h, corrupt);
    ssgi__field_numbers(number, f);
    for (size_t i = 0; i < SSGI__FIELD_NUMBERS; ++i) {
        const uint32_t word = ssgi__field_get(bytes, 4 + i);
        memcpy(number[i], &word, sizeof word);
        SSGI__CHECK(ssgi__within(*number[i], -1e15f, 1e15f), corrupt);
    }
    SSGI__CHECK(ssgi__positive(f->span, 8), corrupt);
    SSGI__CHECK(f->median >= 0.0f && f->p95 >= 0.0f && f->max_error >= 0.0f, corrupt);
    for (int i = 0; i < 3; ++i) /* the logarithms are limited, so that powers of 2, and products of two, are finite */
        SSGI__CHECK(f->low[i] >= -64.0f && f->low[i] + f->span[i] <= 62.0f, corrupt);
    /* no bake makes a radius or a hull's distance smaller than these */
    SSGI__CHECK(f->radius > 9e-13f && f->low[3] > 1e-6f * f->radius && f->reach > f->low[3] + f->span[3], corrupt);
    SSGI__CHECK(ssgi__within(f->inside, 0.0f, 1.0f), corrupt);
    SSGI__CHECK(f->low[7] >= 0.0f && f->low[7] + f->span[7] <= 1.00001f, "file: its covered share must be 0..1");
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_field_load(ssgi_field *field, uint32_t *texels, size_t size, const void *file,
                                     size_t file_size, const char **why)
{
    ssgi_field f;
    SSGI__THERE(field);
    SSGI__TRY(ssgi__field_head(&f, file, file_size, why));
    const size_t words = texels ? ssgi_field_size(f.resolution) / 4 : 0;
    SSGI__ENOUGH(size, 4 * words, "size: must be at least ssgi_field_size of the file's resolution");
    for (size_t i = 0; i < words; ++i) texels[i] = ssgi__field_get((const unsigned char *)file, SSGI__FIELD_HEAD + i);
    f.texels = texels;
    *field = f;
    return SSGI_OK;
}

/* ==== >>plan (implementation) ================================================================================== */

SSGI_DEF ssgi_result ssgi_survey_of(ssgi_survey *survey, const float *hsao, const float *best, const float *solid,
                                    const float *slabs, size_t count, const char **why)
{
    double sum[4] = { 0.0, 0.0, 0.0, 0.0 };
    size_t covered = 0;
    SSGI__THERE3(survey, hsao, best);
    SSGI__THERE(solid);
    for (size_t i = 0; i < count; ++i) {
        const float *const shown[4] = { hsao + i, best + i, solid + i, slabs ? slabs + i : hsao + i };
        double v[4];
        int known = 1;
        for (int k = 0; k < 4; ++k) {
            known &= ssgi__finite(*shown[k]);
            v[k] = (double)*shown[k];
        }
        const double change[4] = { 1.0 - v[3], v[1] - v[0], v[2] - v[0], v[3] - v[0] };
        for (int k = 0; k < 4 && known; ++k) sum[k] += change[k] * change[k];
        covered += (size_t)known;
    }
    for (int k = 0; k < 4; ++k) sum[k] = covered ? fmin(sqrt(sum[k] / (double)covered), (double)SSGI_FAR) : 0.0;
    survey->occlusion = (float)sum[0];
    survey->detail = (float)sum[1];
    survey->solid = (float)sum[2];
    survey->slabs = (float)sum[3];
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_plan_calibrate(ssgi_calibration *calibration, const ssgi_trace *trace, const float *position,
                                         const float *normal, const float *hsao, const float *slabs, const float *fast,
                                         size_t count, int rays, float radius, const char **why)
{
    const float *const shown[4] = { NULL, hsao, slabs, fast };
    double square[4] = { 0.0, 0.0, 0.0, 0.0 };
    SSGI__THERE2(calibration, trace);
    SSGI__THERE3(position, normal, hsao);
    SSGI__CHECK(count, "count: must not be 0");
    SSGI__RANGE(rays, 2, 65536);
    SSGI__CHECK(ssgi__finite(radius) && radius > 0.0f, "radius: must be finite and above 0");
    for (size_t i = 0; i < count; ++i) {
        double along[3], occlusion[2];
        float axes[3][3], from[3];
        ssgi__doubles(along, normal + 3 * i);
        ssgi__normalise(along);
        ssgi__axes(axes, along);
        for (int k = 0; k < 3; ++k) from[k] = position[3 * i + (size_t)k] + 5e-3f * radius * (float)along[k];
        for (int k = 0; k < 2; ++k) /* two estimates of the occlusion, by half of the rays each */
            occlusion[k] = ssgi__trace_occlusion(trace, from, axes, radius, rays / 2, 0,
                                                 (uint32_t)(2 * i) + (uint32_t)k);
        for (int k = 0; k < 4; ++k) {
            const double visible = shown[k] && ssgi__finite(shown[k][i]) ? (double)shown[k][i] : 1.0;
            square[k] += (occlusion[0] - (1.0 - visible)) * (occlusion[1] - (1.0 - visible));
        }
    }
    for (int k = 0; k < 4; ++k) square[k] = square[k] > 0.0 ? sqrt(square[k] / (double)count) : 0.0;
    calibration->known = 1;
    calibration->unoccluded = (float)square[0];
    calibration->hsao = (float)square[1];
    calibration->slabs = slabs ? (float)square[2] : 0.0f;
    calibration->fast = fast ? (float)square[3] : 0.0f;
    calibration->s3ho = 0.0f;
    return SSGI_OK;
}

/* The predicted squared error of a choice is a linear combination of these terms of the scene, with weights that were
   fitted for each choice (make fit). E is the squared error of no ambient occlusion. */
enum {
    SSGI__PLAN_UNOCCLUDED,     /* E */
    SSGI__PLAN_HSAO_ERROR,     /* squared error of hsao */
    SSGI__PLAN_SLABS_ERROR,    /* squared error of hsao with slabs */
    SSGI__PLAN_KIN_ERROR,      /* squared error of hsao's preset FAST if thickness is CONSTANT, else of s3ho */
    SSGI__PLAN_COARSE,         /* E * size of a surfel / screen radius */
    SSGI__PLAN_UNEVEN,         /* E * the light's energy above band 0 / its energy in band 0 */
    SSGI__PLAN_CONSTANT_ERROR, /* 1e-4 */
    SSGI__PLAN_TERMS           /* number of terms */
};

/* A choice: the value of `wanted` that it serves, its settings, its costs in software and on a GPU, and the weights of
   the terms. */
typedef struct ssgi__plan_row {
    signed char wanted, method, thickness, resolution, slices, samples, bands, history, field_resolution;
    float surfel_size, cost[2], term[SSGI__PLAN_TERMS];
} ssgi__plan_row;

/* clang-format off */
#define SSGI__P(wanted, method, thickness, resolution, slices, samples, bands, history, field_resolution, \
                surfel_size, cost, gpu, unoccluded, hsao, slabs, kin, coarse, uneven, constant) \
    { SSGI__PLAN_##wanted, SSGI_PLAN_METHOD_##method, SSGI_PLAN_THICKNESS_##thickness, resolution, slices, samples, \
      bands, history, field_resolution, surfel_size, { cost, gpu }, \
      { unoccluded, hsao, slabs, kin, coarse, uneven, constant } }

enum {
    SSGI__PLAN_V = SSGI_PLAN_WANTED_VISIBILITY,
    SSGI__PLAN_L = SSGI_PLAN_WANTED_LIGHT,
    SSGI__PLAN_B = SSGI_PLAN_WANTED_BOUNCE,
    SSGI__PLAN_O = SSGI_PLAN_WANTED_OBJECTS
};

/* A table of the planner's choices, whose rows make fit prints. NOTHING is no ambient occlusion. The columns from E on
   are the weights of the terms, SSGI__PLAN_UNOCCLUDED and so on, fitted to 28 scenes by seed, 0 to 27, at 1280x720. CPU
   costs were measured in 0.4; those of rows that have changed since are multiplied by the change of their modelled cost
   on a GPU. */
static const ssgi__plan_row ssgi__plan_rows[SSGI_PLAN_CHOICES] = {
  /*                  thickness
                      |         resolution
                      |         |  slices
                      |         |  |  samples
                      |         |  |  |   bands
                      |         |  |  |   |  history                                                coarse
          for         |         |  |  |   |  |  field_resolution                                    |     uneven
          |  method   |         |  |  |   |  |  |  surfel_size
          |  |        |         |  |  |   |  |  |  |      CPU    GPU    E      hsao   slabs  kin    |     |      1e-4 */
  SSGI__P(V, NOTHING, WIDTH,    0, 0, 0,  0, 0, 0, 0,     0,     0,     1.0f,  0,     0,     0,     0,    0,     0),
  SSGI__P(V, HSAO,    CONSTANT, 3, 2, 8,  0, 0, 0, 0,     .64f,  .56f,  .015f, .34f,  0,     .73f,  0,    0,     .77f),
  SSGI__P(V, HSAO,    CONSTANT, 1, 1, 10, 0, 0, 0, 0,     1.27f, 1.11f, 0,     0,     0,     1.0f,  0,    0,     0),
  SSGI__P(V, HSAO,    WIDTH,    1, 1, 8,  0, 0, 0, 0,     1.45f, 1.31f, .004f, 1.07f, 0,     0,     0,    0,     .099f),
  SSGI__P(V, HSAO,    WIDTH,    1, 2, 8,  0, 0, 0, 0,     2.03f, 1.83f, 0,     1.0f,  0,     0,     0,    0,     0),
  SSGI__P(V, HSAO,    WIDTH,    1, 2, 12, 0, 0, 0, 0,     2.33f, 2.32f, 0,     .93f,  0,     0,     0,    0,     .11f),
  SSGI__P(V, HSAO,    WIDTH,    1, 1, 12, 0, 1, 0, 0,     1.97f, 2.15f, 0,     .86f,  0,     0,     0,    0,     0),
  SSGI__P(V, HSAO,    WIDTH,    1, 3, 16, 0, 0, 0, 0,     3.34f, 3.81f, 0,     .88f,  0,     0,     0,    0,     .12f),
  SSGI__P(V, HSAO,    WIDTH,    0, 2, 7,  0, 0, 0, 0,     4.92f, 4.58f, 0,     .9f,   0,     0,     0,    0,     0),
  SSGI__P(V, HSAO,    WIDTH,    0, 2, 12, 0, 0, 0, 0,     6.42f, 6.84f, 0,     .81f,  0,     0,     0,    0,     0),
  SSGI__P(V, HSAO,    BACK,     1, 1, 8,  0, 0, 0, 0,     1.39f, 1.33f, .01f,  .41f,  .71f,  0,     0,    0,     0),
  SSGI__P(V, HSAO,    BACK,     1, 2, 8,  0, 0, 0, 0,     1.99f, 1.85f, .006f, .32f,  .72f,  0,     0,    0,     0),
  SSGI__P(V, HSAO,    SLABS,    1, 1, 8,  0, 0, 0, 0,     2.7f,  1.59f, .004f, 0,     1.09f, 0,     0,    0,     .16f),
  SSGI__P(V, HSAO,    SLABS,    1, 2, 8,  0, 0, 0, 0,     3.55f, 2.3f,  0,     0,     1.0f,  0,     0,    0,     0),
  SSGI__P(V, HSAO,    SLABS,    1, 2, 12, 0, 0, 0, 0,     4.63f, 3.0f,  0,     0,     .92f,  0,     0,    0,     .097f),
  SSGI__P(V, HSAO,    SLABS,    1, 1, 12, 0, 1, 0, 0,     3.57f, 2.54f, 0,     0,     .84f,  0,     0,    0,     0),
  SSGI__P(V, HSAO,    SLABS,    1, 3, 16, 0, 0, 0, 0,     6.52f, 5.05f, 0,     0,     .86f,  0,     0,    0,     .19f),
  SSGI__P(V, HSAO,    SLABS,    0, 2, 7,  0, 0, 0, 0,     10.1f, 5.89f, 0,     0,     .88f,  0,     0,    0,     0),
  SSGI__P(V, HSAO,    SLABS,    0, 2, 12, 0, 0, 0, 0,     12.8f, 9.02f, 0,     0,     .77f,  0,     0,    0,     0),
  SSGI__P(V, DSS,     WIDTH,    3, 2, 8,  0, 0, 0, .03f,  1.28f, 1.84f, .024f, .86f,  0,     0,     .039f,0,     .6f),
  SSGI__P(V, DSS,     WIDTH,    1, 2, 8,  0, 0, 0, .03f,  2.52f, 3.28f, .006f, .83f,  0,     0,     .012f,0,     .07f),
  SSGI__P(V, DSS,     WIDTH,    0, 2, 7,  0, 0, 0, .03f,  5.4f,  8.1f,  0,     .82f,  0,     0,     0,    0,     0),
  SSGI__P(L, NOTHING, WIDTH,    0, 0, 0,  0, 0, 0, 0,     0,     0,     1.0f,  0,     0,     0,     0,    0,     0),
  SSGI__P(L, HSAO,    CONSTANT, 3, 2, 8,  0, 0, 0, 0,     .64f,  .56f,  0,     .25f,  0,     .81f,  0,    .006f, .46f),
  SSGI__P(L, HSAO,    CONSTANT, 1, 1, 10, 0, 0, 0, 0,     1.27f, 1.11f, 0,     0,     0,     1.0f,  0,    0,     0),
  SSGI__P(L, HSAO,    WIDTH,    1, 2, 8,  0, 0, 0, 0,     2.05f, 1.83f, 0,     1.0f,  0,     0,     0,    0,     0),
  SSGI__P(L, HSAO,    SLABS,    1, 2, 8,  0, 0, 0, 0,     3.47f, 2.3f,  0,     0,     1.0f,  0,     0,    0,     0),
  SSGI__P(L, HSAO,    SLABS,    1, 1, 12, 0, 1, 0, 0,     3.64f, 2.54f, 0,     0,     .94f,  0,     0,    0,     .024f),
  SSGI__P(L, S3HO,    WIDTH,    1, 1, 5,  4, 0, 0, 0,     2.45f, 1.83f, .019f, .009f, 0,     1.11f, 0,    .008f, .062f),
  SSGI__P(L, S3HO,    WIDTH,    1, 2, 9,  2, 0, 0, 0,     2.72f, 2.69f, .003f, .13f,  0,     .77f,  0,    .021f, .004f),
  SSGI__P(L, S3HO,    WIDTH,    1, 2, 9,  4, 0, 0, 0,     2.95f, 2.81f, 0,     0,     0,     1.0f,  0,    0,     0),
  SSGI__P(L, S3HO,    SLABS,    1, 2, 9,  4, 0, 0, 0,     4.7f,  3.5f,  0,     0,     .052f, .77f,  0,    .008f, 0),
  SSGI__P(L, S3HO,    SLABS,    0, 2, 9,  4, 0, 0, 0,     13.7f, 9.75f, 0,     0,     0,     .76f,  0,    .002f, 0),
  SSGI__P(L, SSDO,    WIDTH,    1, 1, 5,  0, 0, 0, 0,     1.69f, 1.24f, .006f, .13f,  0,     1.05f, 0,    0,     .23f),
  SSGI__P(L, SSDO,    WIDTH,    1, 2, 9,  0, 0, 0, 0,     2.41f, 2.21f, 0,     0,     0,     .97f,  0,    0,     0),
  SSGI__P(L, SSDO,    WIDTH,    0, 2, 9,  0, 0, 0, 0,     6.63f, 6.95f, 0,     0,     0,     .84f,  0,    0,     0),
  SSGI__P(L, SSDO,    SLABS,    1, 1, 12, 0, 0, 0, 0,     3.48f, 2.12f, 0,     0,     .19f,  .71f,  0,    .004f, 0),
  SSGI__P(L, SSDO,    SLABS,    1, 2, 9,  0, 0, 0, 0,     4.69f, 2.75f, 0,     0,     .041f, .78f,  0,    0,     0),
  SSGI__P(L, SSDO,    SLABS,    0, 2, 9,  0, 0, 0, 0,     14.7f, 8.7f,  0,     0,     0,     .71f,  0,    0,     0),
  SSGI__P(L, SSDO,    SLABS,    1, 1, 6,  0, 1, 0, 0,     3.61f, 2.4f,  0,     0,     .074f, .77f,  0,    .003f, 0),
  SSGI__P(B, NOTHING, WIDTH,    0, 0, 0,  0, 0, 0, 0,     0,     0,     1.0f,  0,     0,     0,     0,    0,     0),
  SSGI__P(B, HSAO,    CONSTANT, 3, 2, 8,  0, 0, 0, 0,     .66f,  .56f,  0,     .23f,  .006f, .79f,  0,    .006f, .46f),
  SSGI__P(B, HSAO,    CONSTANT, 1, 1, 10, 0, 0, 0, 0,     1.3f,  1.11f, 0,     0,     0,     1.0f,  0,    0,     0),
  SSGI__P(B, HSAO,    WIDTH,    1, 2, 8,  0, 0, 0, 0,     1.96f, 1.83f, 0,     1.0f,  0,     0,     0,    0,     0),
  SSGI__P(B, S3HO,    WIDTH,    1, 1, 5,  4, 0, 0, 0,     3.52f, 2.57f, 0,     0,     0,     1.14f, 0,    .018f, 0),
  SSGI__P(B, S3HO,    WIDTH,    1, 2, 9,  4, 0, 0, 0,     4.92f, 3.86f, 0,     0,     0,     1.0f,  0,    0,     0),
  SSGI__P(B, S3HO,    SLABS,    1, 2, 9,  4, 0, 0, 0,     7.35f, 4.41f, 0,     0,     0,     .85f,  0,    .009f, 0),
  SSGI__P(B, SSDO,    WIDTH,    1, 1, 5,  0, 0, 0, 0,     3.55f, 2.6f,  0,     0,     0,     1.06f, 0,    0,     .33f),
  SSGI__P(B, SSDO,    WIDTH,    1, 2, 9,  0, 0, 0, 0,     4.84f, 3.76f, 0,     0,     0,     .83f,  0,    0,     .014f),
  SSGI__P(B, SSDO,    SLABS,    1, 2, 9,  0, 0, 0, 0,     6.93f, 4.3f,  0,     0,     0,     .72f,  0,    0,     0),
  SSGI__P(B, SSDO,    WIDTH,    0, 2, 9,  0, 0, 0, 0,     12.4f, 10.1f, 0,     0,     0,     .72f,  0,    0,     0),
  SSGI__P(B, SSDO,    SLABS,    0, 2, 9,  0, 0, 0, 0,     19.0f, 11.9f, 0,     0,     0,     .61f,  0,    0,     0),
  SSGI__P(O, NOTHING, WIDTH,    0, 0, 0,  0, 0, 0, 0,     0,     0,     1.0f,  0,     0,     0,     0,    0,     0),
  SSGI__P(O, AOF,     WIDTH,    0, 0, 0,  0, 0, 4, 0,     .06f,  .05f,  .014f, 0,     0,     0,     0,    0,     0),
  SSGI__P(O, AOF,     WIDTH,    0, 0, 0,  0, 0, 8, 0,     .06f,  .05f,  .011f, 0,     0,     0,     0,    0,     0)
};
/* clang-format on */

/* A table of the filter radii that the presets have after one frame. The columns are resolutions: full, half, none,
   quarter. With history the radius is 1. */
static const signed char ssgi__plan_filters[SSGI_PLAN_METHOD_AOF + 1][4] = {
    { 0, 0, 0, 0 }, /* nothing */
    { 2, 2, 0, 1 }, /* hsao */
    { 2, 1, 0, 1 }, /* ssdo */
    { 2, 2, 0, 1 }, /* s3ho */
    { 1, 2, 0, 1 }, /* dss */
    { 0, 0, 0, 0 }  /* aof */
};

/* The defaults of numbers that a scene leaves 0. */
#define SSGI__PLAN_RADIUS 0.15   /* screen_radius */
#define SSGI__PLAN_TEXELS 55.0   /* splats */
#define SSGI__PLAN_COVERAGE 0.1f /* coverage */
#define SSGI__PLAN_QUARTER 3     /* a row's resolution: SSGI_GL_RESOLUTION_QUARTER */
/* The milliseconds of an unblurred 16-sample ssao on a Radeon RX 6800 at 1920x1080, modelled (make cost). */
#define SSGI__PLAN_MS 0.184
/* A prediction meets an error that it exceeds by 4 %. With more, plans would miss too often; with less, they would
   often be dearer than they need to be. */
#define SSGI__PLAN_GOAL 1.04
/* An error below a tenth of the one asked for is negligible: squared errors add, so it adds a hundredth. */
#define SSGI__PLAN_NEGLIGIBLE 0.1

/* The energies of a clear sky's bands are those of the examples' "sky". */
static const float ssgi__plan_sky[4] = { 1.0f, 0.42f, 0.13f, 0.18f };

/* Tables of weights (make fit) for visibility, light and light with a bounce; of each the first is for surveys without
   slabs, the second for surveys with slabs. A row gives a squared error, of no occlusion, of hsao or of hsao with
   slabs, as the sum of a survey's squares times the row's weights. The columns are the survey's members: occlusion,
   detail, solid, slabs. */
static const float ssgi__plan_survey[3][2][3][4] = {
    { { { 1.25f, 0, 0, 0 }, { .091f, 2.99f, 0, 0 }, { .0725f, 2.6f, 0, 0 } },
      { { 1.27f, 0, 0, .632f }, { .0602f, 2.38f, 0, 1.34f }, { .0609f, 2.22f, 0, .609f } } },
    { { { 1.3f, 0, 0, 0 }, { .335f, .843f, 0, 0 }, { .292f, 1.04f, 0, 0 } },
      { { 1.28f, 0, 0, 1.4f }, { .302f, .27f, 0, 1.48f }, { .282f, .679f, 0, .721f } } },
    { { { .943f, 0, 0, 0 }, { .414f, .853f, 0, 0 }, { .358f, 1.37f, 0, 0 } },
      { { .908f, 0, 0, 1.44f }, { .394f, .289f, 0, 1.21f }, { .379f, 1.13f, 0, 0 } } }
};

/* A table of weights (make fit) by which the squared errors of hsao's preset FAST and of s3ho follow from others, if
   they are not known: from those of no occlusion and of hsao, and from no occlusion times the light's unevenness. The
   rows are visibility, light, and light with a bounce. */
static const float ssgi__plan_kin[3][2][3] = { { { .0283f, .983f, 0 }, { 0, 0, 0 } },
                                               { { .0454f, .939f, 0 }, { 0, .704f, 0 } },
                                               { { .0118f, 1.04f, 0 }, { .173f, .111f, .0407f } } };

/* A table of costs by device, software and then a GPU: the costs of splats and fields, which are added to a choice's
   own. */
static const struct {
    float texel, surfel; /* cost of as many texels of splats, or surfels, as the frame has pixels */
    float occluder;      /* cost of an occluder that reaches all pixels */
} ssgi__plan_costs[2] = { { 0.173f, 21.3f, 0.75f }, { 0.105f, 7.6f, 0.3f } };

SSGI__FN double ssgi__plan_radius(const ssgi_plan_scene *s)
{
    return s->screen_radius > 0.0f ? (double)s->screen_radius : SSGI__PLAN_RADIUS;
}

static const float *ssgi__plan_energy(const ssgi_plan_scene *s)
{
    return s->energy[0] > 0.0f ? s->energy : ssgi__plan_sky;
}

/* Returns the light's energy above band 0 over its energy in band 0; 0 for visibility. */
SSGI__FN double ssgi__plan_uneven(const ssgi_plan_scene *s)
{
    const float *energy = ssgi__plan_energy(s);
    double uneven = 0.0;
    for (int l = 1; l < 4 && s->wanted; ++l) uneven += (double)energy[l] / (double)energy[0];
    return uneven;
}

/* Writes the squared errors of no occlusion, of hsao, of hsao with slabs, of hsao's preset FAST and of s3ho. They come
   from the calibration, else from the survey, else from a guess. A calibration without slabs scales the error of slabs
   from the survey or the guess. The last two, if they are not known, follow from the first two. */
SSGI__FN void ssgi__plan_errors(double square[5], const ssgi_plan_scene *s)
{
    static const double guess[3] = { 0.02, 0.003, 0.003 };
    const double known[5] = { (double)s->calibration.unoccluded, (double)s->calibration.hsao,
                              (double)s->calibration.slabs, (double)s->calibration.fast, (double)s->calibration.s3ho };
    const float v[4] = { s->survey.occlusion, s->survey.detail, s->survey.solid, s->survey.slabs };
    const int of = s->wanted == SSGI_PLAN_WANTED_LIGHT ? 1 : s->wanted == SSGI_PLAN_WANTED_BOUNCE ? 2 : 0;
    for (int k = 0; k < 3; ++k) {
        square[k] = v[0] > 0.0f ? 1e-6 : guess[k];
        for (int i = 0; i < 4 && v[0] > 0.0f; ++i)
            square[k] += (double)ssgi__plan_survey[of][v[3] > 0.0f][k][i] * (double)v[i] * (double)v[i];
    }
    if (s->calibration.known) {
        square[2] *= known[1] * known[1] / square[1];
        for (int k = 0; k < (known[2] > 0.0 ? 3 : 2); ++k) square[k] = known[k] * known[k];
    }
    for (int k = 3; k < 5; ++k) {
        const float *const weight = ssgi__plan_kin[of][k - 3];
        square[k] = s->calibration.known && known[k] > 0.0
                      ? known[k] * known[k]
                      : ((double)weight[0] + (double)weight[2] * ssgi__plan_uneven(s)) * square[0]
                            + (double)weight[1] * square[1];
    }
}

/* Writes the terms by which a choice's error is predicted for a scene; SSGI__PLAN_COARSE depends on the choice's
   surfel_size. */
SSGI__FN void ssgi__plan_terms(double term[SSGI__PLAN_TERMS], const ssgi__plan_row *row, const ssgi_plan_scene *s)
{
    const double size = (double)row->surfel_size / ssgi__plan_radius(s);
    double square[5];
    ssgi__plan_errors(square, s);
    term[SSGI__PLAN_UNOCCLUDED] = square[0];
    term[SSGI__PLAN_HSAO_ERROR] = square[1];
    term[SSGI__PLAN_SLABS_ERROR] = square[2];
    term[SSGI__PLAN_KIN_ERROR] = square[row->thickness == SSGI_PLAN_THICKNESS_CONSTANT ? 3 : 4];
    term[SSGI__PLAN_COARSE] = square[0] * size;
    term[SSGI__PLAN_UNEVEN] = square[0] * ssgi__plan_uneven(s);
    term[SSGI__PLAN_CONSTANT_ERROR] = 1e-4;
}

/* Returns the error asked for in the measure of `wanted`. */
SSGI__FN double ssgi__plan_goal(const ssgi_plan_scene *s)
{
    double square[5];
    if (s->unit != SSGI_PLAN_UNIT_RELATIVE) return (double)s->error;
    ssgi__plan_errors(square, s);
    return (double)s->error * sqrt(square[0]);
}

/* Returns whether a choice serves scene->wanted, needs nothing that the scene does not give, and gains enough by the
   light's directions if it uses them. */
SSGI__FN int ssgi__plan_fits(const ssgi__plan_row *row, const ssgi_plan_scene *s, const double term[SSGI__PLAN_TERMS])
{
    const int m = row->method;
    if (row->wanted != s->wanted || row->history > s->history) return 0;
    if (row->thickness > s->thickness && row->thickness != SSGI_PLAN_THICKNESS_CONSTANT) return 0;
    if (m == SSGI_PLAN_METHOD_SSDO && !s->map) return 0;
    if (m == SSGI_PLAN_METHOD_DSS && !(s->surfels > 0.0)) return 0;
    if (m == SSGI_PLAN_METHOD_AOF && s->occluders < 1) return 0;
    /* if light comes nearly evenly from everywhere, its directions do not matter: methods that use them are assumed to
       gain a tenth of the uneven term */
    return row->wanted != SSGI_PLAN_WANTED_LIGHT || (m != SSGI_PLAN_METHOD_S3HO && m != SSGI_PLAN_METHOD_SSDO)
        || sqrt(0.1 * term[SSGI__PLAN_UNEVEN]) >= SSGI__PLAN_NEGLIGIBLE * ssgi__plan_goal(s);
}

/* Returns how many pixels of the frame there are for each pixel that a choice draws: 1, 4 or 16, by its resolution. */
SSGI__FN double ssgi__plan_drawn(const ssgi__plan_row *row)
{
    return row->resolution == SSGI__PLAN_QUARTER ? 16.0 : row->resolution ? 4.0 : 1.0;
}

/* Returns a choice's own cost plus the costs of depth passes, fields and surfels. */
SSGI__FN float ssgi__plan_cost(const ssgi__plan_row *row, const ssgi_plan_scene *s)
{
    const int gpu = s->device != SSGI_PLAN_DEVICE_SOFTWARE;
    double cost = (double)row->cost[gpu];
    if (row->method == SSGI_PLAN_METHOD_AOF)
        cost += (double)ssgi__plan_costs[gpu].occluder * s->occluders
              * (double)(s->coverage > 0.0f ? s->coverage : SSGI__PLAN_COVERAGE);
    if (row->method == SSGI_PLAN_METHOD_DSS)
        cost += (double)ssgi__plan_costs[gpu].texel * (s->splats > 0.0 ? s->splats : SSGI__PLAN_TEXELS)
                  / ssgi__plan_drawn(row)
              + (double)ssgi__plan_costs[gpu].surfel * s->surfels;
    if (s->device == SSGI_PLAN_DEVICE_RX_6800) cost *= SSGI__PLAN_MS;
    if (row->thickness >= SSGI_PLAN_THICKNESS_BACK)
        cost += (double)s->depth_pass * (row->thickness == SSGI_PLAN_THICKNESS_SLABS ? 3.0 : 1.0);
    return (float)fmin(cost, (double)SSGI_FAR);
}

SSGI__FN ssgi_result ssgi__plan_bad(const ssgi_plan_scene *s, const char **why)
{
    SSGI__CHECK(s, "scene: must not be NULL");
    SSGI__CHECK(s->wanted >= SSGI_PLAN_WANTED_VISIBILITY && s->wanted <= SSGI_PLAN_WANTED_OBJECTS,
                "scene.wanted: must be SSGI_PLAN_WANTED_VISIBILITY .. SSGI_PLAN_WANTED_OBJECTS");
    SSGI__CHECK(s->unit == SSGI_PLAN_UNIT_RMSE || s->unit == SSGI_PLAN_UNIT_RELATIVE,
                "scene.unit: must be SSGI_PLAN_UNIT_RMSE or SSGI_PLAN_UNIT_RELATIVE");
    SSGI__CHECK(s->device >= 0 && s->device <= 2 && s->thickness >= 0 && s->thickness <= SSGI_PLAN_THICKNESS_SLABS
                    && s->history >= 0 && s->history <= 1 && s->occluders >= 0,
                "scene.device, .thickness, .history, .occluders: must be 0..2, 0..3, 0..1, 0 or more");
    SSGI__CHECK(ssgi__positive(&s->error, 1) && ssgi__positive(&s->budget, 1) && ssgi__positive(&s->screen_radius, 1)
                    && ssgi__positive(&s->depth_pass, 1) && ssgi__positive(&s->coverage, 1),
                "scene.error, .budget, .screen_radius, .depth_pass, .coverage: must be finite and 0 or more");
    SSGI__CHECK(ssgi__fits(s->surfels) && s->surfels >= 0.0 && s->surfels <= 1e18 && ssgi__fits(s->splats)
                    && s->splats >= 0.0 && s->splats <= 1e18,
                "scene.surfels, .splats: must be finite and 0 or more");
    SSGI__CHECK(ssgi__positive(s->energy, 4), "scene.energy: must be finite and 0 or more");
    SSGI__CHECK(ssgi__finite(s->calibration.unoccluded) && ssgi__finite(s->calibration.hsao)
                    && ssgi__finite(s->calibration.slabs) && ssgi__finite(s->calibration.fast)
                    && ssgi__finite(s->calibration.s3ho),
                "scene.calibration: must be finite");
    SSGI__CHECK(ssgi__positive(&s->survey.occlusion, 1) && ssgi__positive(&s->survey.detail, 1)
                    && ssgi__positive(&s->survey.solid, 1) && ssgi__positive(&s->survey.slabs, 1),
                "scene.survey: must be finite and 0 or more");
    return SSGI_OK;
}

/* Appends a word to a sentence, without its terminating 0. Returns the address behind it. */
SSGI__FN char *ssgi__plan_word(char *at, const char *word)
{
    while (*word) *at++ = *word++;
    return at;
}

/* Appends a number of so many decimals, and a word. A number above 99999 is 99999. Returns the address behind them. It
   does not call snprintf: stdio.h is not included here, and a locale would choose the decimal point. */
SSGI__FN char *ssgi__plan_figure(char *at, double x, int decimals, const char *word)
{
    uint32_t unit = 1, n;
    for (int i = 0; i < decimals; ++i) unit *= 10;
    n = (uint32_t)((x < 99999.0 ? x : 99999.0) * unit + 0.5);
    for (uint32_t place = 1000000000u; place; place /= 10) {
        if (place * 10 == unit) *at++ = '.';
        if (n >= place || place <= unit) *at++ = (char)('0' + n / place % 10);
    }
    return ssgi__plan_word(at, word);
}

/* Appends a choice's settings: "hsao half 2x8 slabs". Returns the address behind them. */
SSGI__FN char *ssgi__plan_settings(char *at, const ssgi_plan *plan)
{
    static const char *const method[] = { "nothing", "hsao", "ssdo", "s3ho", "dss", "aof" };
    static const char *const resolution[] = { " full ", " half ", "", " quarter " };
    static const char *const thickness[] = { "", " constant", " back", " slabs" };
    at = ssgi__plan_word(at, method[plan->method]);
    if (plan->field_resolution) return ssgi__plan_figure(ssgi__plan_word(at, " "), plan->field_resolution, 0, "");
    if (!plan->slices) return at;
    at = ssgi__plan_figure(ssgi__plan_word(at, resolution[plan->resolution]), plan->slices, 0, "x");
    at = ssgi__plan_word(ssgi__plan_figure(at, plan->samples, 0, ""), thickness[plan->thickness]);
    if (plan->bands) at = ssgi__plan_figure(ssgi__plan_word(at, " "), plan->bands, 0, " bands");
    return ssgi__plan_word(at, plan->history ? " history" : "");
}

/* Appends a choice's error and cost: ": error 0.0312 (relative 0.309), 0.372 ms". Returns the address behind them. */
SSGI__FN char *ssgi__plan_price(char *at, const ssgi_plan *plan, const ssgi_plan_scene *s)
{
    at = ssgi__plan_figure(ssgi__plan_word(at, ": error "), (double)plan->error, 4, "");
    if (plan->unoccluded > 0.0f)
        at = ssgi__plan_figure(ssgi__plan_word(at, " (relative "), (double)plan->error / (double)plan->unoccluded, 3,
                               ")");
    return ssgi__plan_figure(ssgi__plan_word(at, ", "), (double)plan->cost, 3,
                             s->device == SSGI_PLAN_DEVICE_RX_6800 ? " ms" : " ssaos");
}

/* Appends the sentence that names the property of the scene which decides. Returns the address behind it. */
SSGI__FN char *ssgi__plan_reason(char *at, const ssgi_plan *plan, const ssgi_plan_scene *s)
{
    const float *energy = ssgi__plan_energy(s);
    double square[5];
    ssgi__plan_errors(square, s);
    for (int k = 0; k < 3; ++k) square[k] = sqrt(square[k]);
    if (!plan->meets && s->budget > 0.0f && plan->dearer >= 0)
        return ssgi__plan_figure(ssgi__plan_word(at, ". The budget decides: without occlusion the error is "),
                                 square[0], 4, "");
    if (plan->method == SSGI_PLAN_METHOD_NOTHING)
        return ssgi__plan_figure(ssgi__plan_word(at, ". Occlusion may be left out: without it the error is "),
                                 square[0], 4, "");
    if (plan->method == SSGI_PLAN_METHOD_AOF)
        return ssgi__plan_figure(ssgi__plan_word(at, ". Other objects decide: without them the error is "), square[0],
                                 4, "");
    if (s->wanted == SSGI_PLAN_WANTED_LIGHT && plan->method != SSGI_PLAN_METHOD_HSAO)
        return ssgi__plan_figure(ssgi__plan_word(at, ". The light's directions decide: over band 0, band 1 has "),
                                 (double)energy[1] / (double)energy[0], 2, " of the energy");
    if (s->wanted == SSGI_PLAN_WANTED_BOUNCE && plan->method != SSGI_PLAN_METHOD_HSAO)
        return ssgi__plan_figure(ssgi__plan_word(at, ". The bounce decides: the error of hsao is "), square[1], 4, "");
    if (plan->method == SSGI_PLAN_METHOD_DSS || plan->thickness >= SSGI_PLAN_THICKNESS_BACK) {
        at = ssgi__plan_word(at, ". What is thin or hidden decides: the error of hsao is ");
        return ssgi__plan_figure(ssgi__plan_figure(at, square[1], 4, ", with slabs "), square[2], 4, "");
    }
    at = ssgi__plan_word(at, (double)plan->error < 0.95 * square[1] ? ". Fine detail decides"
                                                                    : ". What is in sight decides");
    at = ssgi__plan_figure(ssgi__plan_word(at, ": without occlusion the error is "), square[0], 4, ", of hsao ");
    return ssgi__plan_figure(at, square[1], 4, "");
}

/* Writes plan->why, with room for the longest of all. */
SSGI__FN void ssgi__plan_why(ssgi_plan *plan, const ssgi_plan_scene *s)
{
    const int relative = s->unit == SSGI_PLAN_UNIT_RELATIVE, asked = s->error > 0.0f;
    const char *const unit = relative ? "a relative error of " : "an error of ";
    char *at = plan->why;
    ssgi_plan other;
    if (asked && !plan->meets)
        at = ssgi__plan_figure(ssgi__plan_word(ssgi__plan_word(at, "Cannot be met: "), unit), (double)s->error, 4,
                               ". ");
    at = ssgi__plan_word(ssgi__plan_settings(at, plan), " is the cheapest choice ");
    if (plan->meets)
        at = ssgi__plan_figure(ssgi__plan_word(ssgi__plan_word(at, "for "), unit), (double)s->error, 4, "");
    else at = ssgi__plan_word(at, s->budget > 0.0f ? "within 5 % of the best in the budget" : "within 5 % of the best");
    at = ssgi__plan_reason(ssgi__plan_price(at, plan, s), plan, s);
    if (ssgi_plan_choice(&other, plan->cheaper, s))
        at = ssgi__plan_price(ssgi__plan_settings(ssgi__plan_word(at, ". Cheaper: "), &other), &other, s);
    if (ssgi_plan_choice(&other, plan->dearer, s))
        at = ssgi__plan_price(ssgi__plan_settings(ssgi__plan_word(at, ". More accurate: "), &other), &other, s);
    *ssgi__plan_word(at, ".") = 0;
}

/* Returns the least error of the choices that cost at most `cost`. NOTHING costs nothing. */
SSGI__FN double ssgi__plan_least(const ssgi_plan_scene *s, float cost)
{
    double least = (double)SSGI_FAR;
    ssgi_plan p;
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i)
        if (ssgi_plan_choice(&p, i, s) && p.cost <= cost) least = fmin(least, (double)p.error);
    return least;
}

/* Returns the number of the cheapest choice whose error and cost are at most these; -1: there is none. */
SSGI__FN int ssgi__plan_cheapest(const ssgi_plan_scene *s, double error, float cost)
{
    ssgi_plan p;
    int best = -1;
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
        if (!ssgi_plan_choice(&p, i, s) || p.cost > cost || (double)p.error > error || (best >= 0 && p.cost >= cost))
            continue;
        cost = p.cost;
        best = i;
    }
    return best;
}

SSGI_DEF ssgi_result ssgi_plan_make(ssgi_plan *plan, const ssgi_plan_scene *s, const char **why)
{
    ssgi_plan best;
    SSGI__THERE(plan);
    SSGI__TRY(ssgi__plan_bad(s, why));
    const double goal = SSGI__PLAN_GOAL * ssgi__plan_goal(s);
    const float budget = s->budget > 0.0f ? s->budget : SSGI_FAR;
    const double nearest = 1.05 * ssgi__plan_least(s, budget);
    ssgi_plan_choice(&best, ssgi__plan_cheapest(s, nearest > goal ? nearest : goal, budget), s);
    best.meets = s->error > 0.0f && (double)best.error <= goal;
    if (best.cost > 0.0f) {
        const float less = best.cost / 1.05f;
        best.cheaper = ssgi__plan_cheapest(s, 1.05 * ssgi__plan_least(s, less), less);
    }
    if (best.error > 0.0f) best.dearer = ssgi__plan_cheapest(s, (double)best.error / 1.05, SSGI_FAR);
    ssgi__plan_why(&best, s);
    *plan = best;
    return SSGI_OK;
}

SSGI_DEF int ssgi_plan_choice(ssgi_plan *plan, int i, const ssgi_plan_scene *s)
{
    const ssgi__plan_row *row = &ssgi__plan_rows[i >= 0 && i < SSGI_PLAN_CHOICES ? i : 0];
    const float *energy;
    double term[SSGI__PLAN_TERMS], square = 0.0;
    if (!plan || !s || i < 0 || i >= SSGI_PLAN_CHOICES) return 0;
    ssgi__plan_terms(term, row, s);
    if (!ssgi__plan_fits(row, s, term)) return 0;
    memset(plan, 0, sizeof *plan);
    plan->choice = i;
    plan->cheaper = plan->dearer = -1;
    plan->method = row->method;
    plan->thickness = row->thickness;
    plan->resolution = row->resolution;
    plan->slices = row->slices;
    plan->samples = row->samples;
    plan->bands = row->bands;
    plan->history = row->history;
    plan->filter_radius = row->history ? 1 : ssgi__plan_filters[row->method][row->resolution];
    plan->field_resolution = row->field_resolution;
    plan->surfel_size = row->surfel_size;
    for (int k = 0; k < SSGI__PLAN_TERMS; ++k) square += term[k] * (double)row->term[k];
    plan->error = (float)fmin(sqrt(square), (double)SSGI_FAR);
    plan->unoccluded = (float)fmin(sqrt(term[SSGI__PLAN_UNOCCLUDED]), (double)SSGI_FAR);
    plan->cost = ssgi__plan_cost(row, s);
    /* bands whose energy is negligible are left out: leaving out a band is assumed to cost a squared error of 0.02 E
       times its energy over that of band 0 */
    energy = ssgi__plan_energy(s);
    while (plan->bands > 1
           && sqrt(0.02 * term[SSGI__PLAN_UNOCCLUDED] * (double)energy[plan->bands - 1] / (double)energy[0])
                  < SSGI__PLAN_NEGLIGIBLE * ssgi__plan_goal(s))
        --plan->bands;
    if (row->method != SSGI_PLAN_METHOD_DSS) return 1;
    plan->levels = ssgi_splat_levels((double)row->surfel_size, (double)SSGI__SPLAT_EPSILON, 0.5 * ssgi__plan_radius(s));
    return 1;
}

#ifdef __cplusplus
}
#endif
#endif /* SSGI_IMPLEMENTATION */

/* COMPATIBILITY From 1.0 on a minor version only adds: sources still compile; names, units and the meanings of zeros
   stay; pixels may change. Before 1.0 a minor version may rename: its changes are listed here, old -> new.
   Binaries: structs grow and their members move between minor versions, so compile the implementation and all that call
   it with the same headers; SSGI_VERSION tells which. Within one version every struct of ssgi_gl_desc is made of ints
   (and two pointers), enumerations are ints by every compiler (SSGI_FORCE), and the block ssgi_frame is the same bytes
   on every platform. A stored field (ssgi_field_save) names its format, and ssgi_field_load refuses another format.
   Keys of shaders (ssgi_gl_key) and numbers of passes hold for one version: store neither.

   CHANGES in 0.5, not released yet
   Each line "old -> new" is a renaming. If words follow, each is appended to both sides: "desc. -> desc.gather. search"
   says that desc.search has become desc.gather.search. awk and GNU sed apply the table to variables that are named as
   here; a compiler reports the rest. To apply the table of 0.4, write 0.4 and 0.3 instead of 0.5 and 0.4:

      awk '/^   CHANGES in 0.5/ { on = 1 } /^   CHANGES in 0.4/ { exit }
           on && $2 == "->" { if (NF == 3) $4 = ""
                              for (i = 4; i <= NF; ++i) print "s/\\<" $1 $i "\\>/" $3 $i "/g" }' ssgi.h >renames.sed
      sed -i -f renames.sed yours.c

   SSGI_GL_HALF_NONE -> SSGI_GL_RESOLUTION_FULL
   SSGI_GL_HALF_FIRST -> SSGI_GL_RESOLUTION_HALF
   SSGI_GL_HALF_IN_TURN -> SSGI_GL_RESOLUTION_HALF_IN_TURN
   SSGI_GL_HALF_ -> SSGI_GL_RESOLUTION_  QUARTER QUARTER_IN_TURN
   SSGI_GL_SIZE_ -> SSGI_GL_SCALE_  FULL HALF LEVELS TILES QUARTER
   SSGI_GL_TERMS_ -> SSGI_GL_MARCH_TERMS_  BOTH HORIZON NORMAL RAYS
   SSGI_GL_PASS_FIELD -> SSGI_GL_PASS_AOF
   SSGI_GL_PASS_SPLAT -> SSGI_GL_PASS_DSS
   SSGI_PLAN_METHOD_FIELD -> SSGI_PLAN_METHOD_AOF
   SSGI_PLAN_METHOD_SURFELS -> SSGI_PLAN_METHOD_DSS
   ssgi_gl_half -> ssgi_gl_resolution
   ssgi_gl_terms -> ssgi_gl_march_terms
   ssgi_cap_occlusionf -> ssgi_cap_occlusion
   desc.gather.directions -> desc.gather.slices
   desc.gather.samples -> desc.gather.directions
   desc.gather.steps -> desc.gather.samples
   desc.gather.half -> desc.gather.resolution
   desc.gather.terms -> desc.gather.march_terms
   desc.gather.spheres -> desc.gather.growing_sphere
   desc.gather.kernel -> desc.gather.kernel_texture
   desc.gather.uniform -> desc.gather.uniform_directions
   desc.gather.range -> desc.gather.range_check
   desc.light.packed -> desc.light.packed_coefficients
   desc.light.dimmed -> desc.light.occluded_emitters
   desc.light.lights -> desc.light.harmonic_lights
   desc.text. -> desc.shader.  dialect lines version fetch
   step.size -> step.scale
   output.slices -> output.layers
   output.slice -> output.layer
   frame.slice -> frame.layer
   u_ssgi_slice -> u_ssgi_layer
   frame.history -> frame.history_frames
   u_ssgi_history -> u_ssgi_history_frames
   plan.resolution -> plan.field_resolution
   plan.half -> plan.resolution
   plan.directions -> plan.slices
   plan.steps -> plan.samples
   plan.size -> plan.surfel_size

   By hand: with SSGI_GL_SEARCH_MARCH desc.gather.directions keeps its name, and so does desc.gather.samples in pass
   LIGHTS, where it counts the points on a segment. In JavaScript Ssgi.text is now Ssgi.shader. ssgi_gl_step_check is
   for any API: it takes a binding for each of step->inputs in their order, not by unit, and in ssgi_gl_bound names of
   formats instead of GL's numbers. In GL ssgi_gl_bound_of makes a binding of the numbers that the struct had.

   An orthographic eye may stand anywhere. If the near plane lies behind the eye or is far away, depth inside the
   shaders begins at the near plane: frame.decode[3] is its view depth, and ssgi_decode returns your own depth, as
   before. ssgi_view_depth is below 0 for points behind an orthographic eye. With an orthographic camera the texture of
   pass thickness holds 32-bit floats.

   A file that defines SSGI_GL_IMPLEMENTATION alone does not compile: define SSGI_IMPLEMENTATION, too, or
   SSGI_IMPLEMENTED_ELSEWHERE if another file has ssgi.h's code. ssgi_gl_frame_history, _views_set, _light_map and
   _harmonics_set refuse matrices that are not rigid, ssgi_gl_sent_set suns whose min_distance is not a number of rows
   that follow, ssgi_field_load a covered share beyond 0..1. With desc.filter.onto ssgi_gl_output.result is NONE for
   every output. Steps of virtual point lights, too, tell the size of your textures that must be as large as the frame.
   New: SSGI_GL_MAX_STEPS. desc.shader.compute: passes that write whole pictures as compute shaders:
   SSGI_GL_STAGE_COMPUTE, ssgi_gl_step.groups, ssgi_gl_output.set and .binding, and desc.shader.output_set,
   .group_width, .group_height.
   make shared builds build/libssgi.so, which has all functions of both headers, for other languages, and
   build/libssgi.h, their declarations without directives, as cffi reads them.

   Methods have names: ssgi_gl_method_at lists them, ssgi_gl_chain_of fills a chain by a name and FIELD=VALUE behind it,
   ssgi_gl_frame_of sets the frame's values that suit a chain, ssgi_gl_steps_of does all of it. The fields of
   ssgi_gl_desc are ordered by who sets them (ssgi_gl_choice.kind), not as in 0.4. ssgi_gl_resolve gives 0 to each field
   that the pass does not look at. ssgi_gl_steps refuses choices of a chain that are out of their limits
   (ssgi_gl_chain_choice_at). The names of tools follow: of build/glsl-text --chain and make cost "hsao-slabs" is now
   "hsao,thickness=slabs", "ssdo" has a bounce ("ssdo,bounce=none" has not), as build/render has had it; so it is with
   "s3ho" ("s3ho,transfer=direct,packed_coefficients=0,restore=ratio"). PASS,PRESET is NAME,PRESET: "dss,best", not
   "splat,best".

   New: pass debug, by the method's name "debug" or chain.desc.pass, paints the faults of depth, normals and the
   block, a colour a fault: ssgi_gl_fault_at, SSGI_GL_FAULTS.

   New fields: gather.facets seeks occluders above the facets that depth shows, where smooth normals on coarse meshes
   or normal maps make facets darken themselves, while light and filters keep your normals. With gather.lift slices lift
   receivers by frame.offset: the edges of splats in clouds of points would else occlude like walls. With
   light.one_sided the unseen side of an emitter sends nothing; without it, that side sends 0.35 of the emitter's
   radiance. With light.clamp no emitter sends more luminance than frame.sent, against fireflies. All are 0 by default.

   desc.shader.uniforms LOOSE declares a uniform for each value of the frame, for engines that have no uniform blocks
   and set values by name (Ogre, Cesium, bgfx, Irrlicht).

   In VULKAN desc.shader.block_set and texture_set are the sets of the uniform blocks and of the textures, and with
   desc.shader.dense bindings have no gaps: for SDL_GPU, and engines that have sets of their own. ssgi_gl_io.set and
   .binding, ssgi_gl_input.set and .binding tell them.

   Plans: plan_scene.unit RELATIVE asks for a part of the error without occlusion. ssgi_plan.unoccluded is that error,
   .choice, .cheaper and .dearer are numbers for ssgi_plan_choice, and .why has several sentences, which begin "Cannot
   be met" where they began "cannot be met". build/render --plan takes 40% for 0.4, counts costs of an RX 6800, not of
   software, and has the exit status 1 if no choice meets the error. The choices are today's presets, with hsao-quarter,
   and predictions were fitted to them anew. A calibration also has the errors of hsao's preset FAST and of s3ho:
   ssgi_plan_calibrate has one more argument, fast, behind slabs.

   Presets are quieter: hsao BALANCED has 2x8 instead of 2x6 and a filter of radius 2. FAST and BEST, the methods
   ssdo-best, dss and those of s3ho have that filter, too. After a gather at half resolution a filter of radius 2 is a
   tent of 5.5 pixels without its corners, at full resolution 5x5 pixels whose border counts half. Set filter.radius = 1
   and gather.samples = 6 to draw as 0.4 did. With chain.history radius 1 suffices, as hsao-history has it. Pass
   thickness reads no normals.

   GLSL has whole words instead of letters, and one quantity a line: shaders compute the same. If your own GLSL
   reads coefficients: ssgi_coefficients.c is now .channel, and the members a to d of ssgi_sh are word0 to word3. Your
   fetch code is called as before.

   Tools: files of make glsl are named by field and word (hsao.450.thickness-slabs.frag), make glsl-in is gone, and no
   tool counts fetches in GLSL any more: make cost counts a compiler's instructions. make dist packs a release. The
   npm package has no folders glsl and wgsl any more: Ssgi.shader makes the GLSL, and package ssgi-wgsl has the WGSL.

   Corrected: rays passed between triangles if multiply and add were fused, past long edges from close by, and through
   triangles that they met along their plane. A wrong count of lights, occluders or levels could keep a GPU busy for
   seconds: shaders now stop at the last row of the texture. Numbers that are not finite were taken for finite by some
   compilers with -ffast-math. Colours of surfels that are not finite count as 0. Shaders divided by 0 in the hull of a
   field that reaches no farther, and for directions of your own along the horizon (bounce PATCH, uniform_directions).

   CHANGES in 0.4, November 2026
   Each thing has one name, the field's own. Enumerators name their group. ssgi_gl_desc has groups, and its enumerations
   are types: an enumerator of another group is a warning in C and an error in C++. A desc of zeros still means every
   default.

   SSGI_GL_ -> SSGI_GL_DIALECT_  300ES 310ES 320ES 330 410 450 VULKAN
   SSGI_GL_ -> SSGI_GL_IO_  ATTRIBUTE CAPTURE CONSTANT OUTPUT PARAM TEXTURE
   SSGI_GL_ -> SSGI_GL_PRESET_  BALANCED BEST FAST
   SSGI_GL_ -> SSGI_GL_FILTER_  BILATERAL GAUSSIAN
   SSGI_GL_ -> SSGI_GL_PASS_  BLUR COMPOSE FIELD HISTORY HSAO LIGHTS S3HO SHADE SMOOTH SPLAT SSAO SSDO SUM SURFELS
   SSGI_GL_ -> SSGI_GL_QUANTITY_  COEFFICIENTS
   SSGI_GL_ -> SSGI_GL_STAGE_  FRAGMENT GEOMETRY TESS_CONTROL TESS_EVALUATION VERTEX
   SSGI_GL_ -> SSGI_GL_SEARCH_  MARCH POINTS SLICES
   SSGI_GL_ -> SSGI_GL_LIGHT_  POINT SPOT SUN VPL
   SSGI_PLAN_ -> SSGI_PLAN_THICKNESS_  BACK SLABS
   SSGI_PLAN_ -> SSGI_PLAN_WANTED_  BOUNCE LIGHT OBJECTS VISIBILITY
   SSGI_PLAN_ -> SSGI_PLAN_METHOD_  FIELD HSAO NOTHING S3HO SSDO SURFELS
   SSGI_PLAN_ -> SSGI_PLAN_DEVICE_  GPU SOFTWARE
   SSGI_GL_CHANGES -> SSGI_GL_PASS_CHANGE_MASK
   SSGI_GL_COLOUR -> SSGI_GL_QUANTITY_LIGHT
   SSGI_GL_GREY -> SSGI_GL_QUANTITY_VISIBILITY
   SSGI_GL_NEARBY -> SSGI_GL_PASS_CHANGE_SHARE
   SSGI_GL_SENDERS -> SSGI_GL_PASS_EMITTERS
   SSGI_GL_SHUFFLE -> SSGI_GL_PASS_INTERLEAVE
   SSGI_GL_UNSHUFFLE -> SSGI_GL_PASS_DEINTERLEAVE
   SSGI_GL_WIDTH -> SSGI_GL_PASS_THICKNESS
   ssgi_add_blocked -> ssgi_add_occluded
   ssgi_blocked -> ssgi_occlusion_at
   ssgi_offer_sender -> ssgi_offer_emitter
   ssgi_point_blocked -> ssgi_point_occlusion
   ssgi_segment_blocked -> ssgi_segment_occlusion
   ssgi_sender -> ssgi_emitter
   ssgi_sender_pixel -> ssgi_emitter_pixel
   ssgi_sender_place -> ssgi_emitter_place
   ssgi_sender_texel -> ssgi_emitter_texel
   chain.vectors -> chain.coefficients
   frame.thickness -> frame.thickness_limit
   o_ssgi_changes -> o_ssgi_change_mask
   o_ssgi_nearby -> o_ssgi_change_share
   o_ssgi_sender -> o_ssgi_emitter
   o_ssgi_shuffled -> o_ssgi_interleaved
   o_ssgi_width -> o_ssgi_thickness
   t_ssgi_changes -> t_ssgi_change_mask
   t_ssgi_nearby -> t_ssgi_change_share
   t_ssgi_senders -> t_ssgi_emitters
   t_ssgi_shuffled -> t_ssgi_interleaved
   t_ssgi_view_senders -> t_ssgi_view_emitters
   t_ssgi_width -> t_ssgi_thickness
   u_ssgi_thickness -> u_ssgi_thickness_limit
   desc.filter -> desc.filter.kind
   desc.colour -> desc.filter.quantity
   desc.filter_radius -> desc.filter.radius
   desc.filter_normals -> desc.filter.normals
   desc. -> desc.input.  orthographic oblique left_handed depth normal world_normals multisampled array motion objects
   desc. -> desc.input.  cap_table
   desc. -> desc.gather.  search directions samples steps normal_rays terms spheres noise kernel uniform half thickness
   desc. -> desc.gather.  layers views view_layers falloff fade range
   desc. -> desc.light.  environment harmonics bounce two_sided radiance receiver shadow accumulate restore bands packed
   desc. -> desc.light.  transfer dimmed shaded residual shading lights albedo
   desc. -> desc.surfel.  effect levels tessellate overhang sends span near_samples enlarge combine axis
   desc. -> desc.filter.  onto
   desc. -> desc.text.  dialect lines version fetch

   By hand: desc.hard = 1 -> desc.gather.falloff = SSGI_GL_FALLOFF_NONE, which points refuse. desc.half has words: NONE,
   FIRST and IN_TURN for 0, 1 and 2. Out parameters come first, now also in ssgi_view_position, _view_project,
   _extra_displacement, _r2, _octahedral_encode, _octahedral_decode, _trace_closest and _field_cap. New:
   ssgi_gl_choice.field, "gather.steps", as sentences name it.

   Pictures by slices change: thickness WIDTH is half as much if a probe found the end of the surface; surfaces between
   samples and beyond the picture are expected to occlude a little; the filter averages less across edges as high as a
   hundredth of the radius. NVIDIA's compiler for GL lost a sign in slices, which came out too bright there. View depths
   of 1 / SSGI_FAR or less are background. ssgi_view_from_projection refuses a projection that shows nothing in front of
   the camera, ssgi_gl_plan an unknown thickness. ssgi_gl_sent_set takes a radiance of 1e-30 or less for 0. Without
   desc.surfel.span SPLAT with EFFECT_LIGHT lights its surfels by the environment, as hidden_sky does: no other step
   sent that light. With one band lights give every normal a quarter of their irradiance, not all of it (ssgi_sh_light,
   desc.light.lights): their bounce was four times too bright. desc.light.residual works for desc.light.lights with bent
   normals and cones, too. The plan's costs of a GPU are modelled from its compiler's instructions.

   Presets of slices are cheaper: hsao FAST 1x10 with thickness CONSTANT, BALANCED 2x8, BEST 2x7; ssdo and s3ho 1x5,
   2x9, full 2x9. FAST sets thickness CONSTANT if it is DEFAULT, the others DEFAULT if it is CONSTANT. Plans may choose
   thickness CONSTANT, no longer SOLID; plan_scene.device RX_6800 has costs in milliseconds; plan_scene.albedo, which no
   prediction read, is gone. New: desc.light.bounced and ssgi_gl_chain.bounced, for further bounces.

   History goes on if the size changes: ssgi_gl_frame_history takes a view of any size, and frame.last_size and
   .last_footprint tell the shaders. ssgi_gl_frame_time counts history in seconds (frame.pace); frame.jitter keeps the
   average sharp if the projection is jittered for TAA. ssgi_gl_frame has 32 bytes more.

   New: ssgi_gl_read, functions by which shaders that light a surface read a result, instead of the filter's pass;
   desc.gather.half QUARTER (the last 4 bits of ssgi_gl_phase are the frame's number now); frame.strength;
   ssgi_gl_chain.rgba8; room >>reflection (ssgi_interreflected, ssgi_specular_visibility), and ssgi_gl_reflection.

   DSS follows desc.gather.half, which saves three quarters of its cost, and a chain with blur = 1 filters its result;
   it has presets. Its slices for near surfaces follow desc.gather, too: by default 2x8 and thickness WIDTH. Defaults:
   size 0.03, not 0.015; epsilon 0.3, not 0.1 (SCATTER wants 0.02); 4 levels, not 5 (SCATTER wants 7). Shaders compute
   the size of a level: ssgi_gl_surfels_set has no argument `levels`, and ssgi_gl_frame, which is 16 bytes shorter, has
   no `level`. New: ssgi_splat.part, .two_sided; ssgi_splat_levels. plan_scene.surfels and .splats count surfels of size
   0.03, and plans of surfels are the presets. Fields are baked with fewer rays for points farther out, and with 96
   instead of 128 at the hull.

   CHANGES in 0.3, November 2026
   Members of ssgi_gl_desc and ssgi_gl_chain stand in another order.
   Renamed: desc.behind, SSGI_GL_BEHIND_* -> desc.thickness, SSGI_GL_THICKNESS_*; plan_scene.behind, plan.behind ->
   .thickness; functions in the GLSL, which has whole words.
   New: pass WIDTH and desc.thickness WIDTH, which ssgi_gl_steps chooses for slices (DEFAULT, the new 0). With BACK and
   SLABS slices need that pass, too: a surface without a back face is as thick as wide, and sheets half as thick,
   instead of frame.thickness.
   SSGI_PLAN_CONSTANT -> SSGI_PLAN_WIDTH: plans are for the default of chains. Presets of slices: FAST 1x6, BALANCED
   half 2x10. After a gather at half resolution the sample closest to the plane counts most. desc.shadow FILL lifts its
   segments twice: it darkened creases. The march's horizon reads desc.layers and desc.views.
   Pass history filters, too, and averages at full resolution: it replaces blur, and chain.history needs chain.blur. Its
   o_ssgi_ao has four channels; with desc.restore o_ssgi_history is kept instead of o_ssgi_light; o_ssgi_means has two.
   Passes changes and nearby stand before it, which ssgi_gl_steps adds; they draw at an eighth of the size (SIZE_TILES).
   desc.half 2: each pixel of 2x2 in turn, by the last bits of ssgi_gl_phase, which is another sequence.
   ssgi_gl_steps refuses a chain that it cannot draw, and names the field; setters refuse NaN and infinity.
   New, the papers' maths: room >>bias (ssgi_normal_offset, ssgi_shadow_patch, ssgi_shadow_bias, ssgi_radius_guess; 0.1
   had them with other arguments), room >>tessellate (ssgi_tess_count, _points, _level, _radius), room >>cap
   (ssgi_cap_occlusion in doubles, ssgi_cap_table, ssgi_cap_light); ssgi_directions, ssgi_noise_tile, ssgi_vpl_area,
   ssgi_trace_visibility; ssgi_surfel_radius, _form_factor, _reach, _shell; ssgi_field_desc.sample, .unfiltered.
   New choices, as the papers publish them: desc.terms and .spheres of the march, .uniform of points, .dimmed of s3ho,
   .cap_table, surfels' .overhang (also of surfel_desc), .enlarge, .combine; .effect and .harmonics CUSTOM, functions in
   desc.fetch.
   New, for Vulkan and WebGPU: formats' names in ssgi_gl_format, bindings and kinds of views in ssgi_gl_input; in
   SSGI_GL_VULKAN directions, steps and samples are specialisation constants. ssgi_gl_bound.magnify: _step_check names
   textures of integers that GL's default filter makes incomplete.
   History interpolates the last frame between four texels, and a camera that moves does not disturb it; means.w is 0.
   The unseen side of a sender sends 0.35 of its radiance, not 0.25. The plan's table is fitted on scenes by seed.

   CHANGES in 0.2, November 2026
   ssgi_sh_lacking -> ssgi_sh_residual; ssgi_trial, ssgi_plan_try -> ssgi_calibration, ssgi_plan_calibrate (one more
   picture); surfel_desc.aside, .every, .most -> .offscreen_growth, .keep_small, .max_distance; splat.most,
   .brightest, .front -> .max_distance, .max_radiance, .near_depth; field.most -> .max_error; dipole.above, .below,
   .fading -> .z_r, .z_v, .sigma_tr; plan_scene.trial, .reach, .cover, .casters -> .calibration, .screen_radius,
   .coverage, .occluders. ssgi_gl.h: VECTORS -> COEFFICIENTS, TRANSFER_FREE -> TRANSFER_DIRECT, caster -> occluder,
   its .reach, .end, .fitted -> .radius, .reach, .baked_reach; desc.exact, .lamps, .closely, .thin -> .residual,
   .lights, .near_samples, .behind; frame.nearest, .steepest, .front -> .distance_clamp, .max_slope, .near_depth;
   light.least -> .min_distance. Removed: SH product, deringing, sky; cap tables, 16-bit and cube-map fields,
   solid-angle measure; surfels' shrink, jitter, enlarge, overlap; splat_predict, materials, dipole_total,
   jitter_tile, field_peek, radius_guess, normal_offset, shadow_patch, shadow_bias; pass SURVEY (ssgi_survey_of reads
   pictures of hsao instead), plan_scene.layers, .cameras, .triangles (.surfels, .behind, .history instead),
   plan.samples.
   New: slices (hsao, ssdo, s3ho), desc.behind BACK and SLABS, .restore, .span, .onto, .motion, .left_handed,
   .oblique, .multisampled, .array; passes HISTORY and COMPOSE; SSGI_GL_VULKAN; ssgi_gl_steps, _step_check, _resolve,
   _choice_at, _member_at, _frame_history, _phase. ssgi_gl_frame grew by history, last_to, last_from, oblique, slice. */

/* --------------------------------------------------------------------------------------------------------------
   This software is available under two licences; choose the one you like.

   1. MIT. Copyright (c) 2026 the ssgi authors.
   Permission is hereby granted, free of charge, to any person obtaining a copy of this software and associated
   documentation files (the "Software"), to deal in the Software without restriction, including without limitation the
   rights to use, copy, modify, merge, publish, distribute, sublicense, and/or sell copies of the Software, and to
   permit persons to whom the Software is furnished to do so, subject to the following conditions: The above copyright
   notice and this permission notice shall be included in all copies or substantial portions of the Software. THE
   SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR IMPLIED, INCLUDING BUT NOT LIMITED TO THE
   WARRANTIES OF MERCHANTABILITY, FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE AUTHORS OR
   COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR
   OTHERWISE, ARISING FROM, OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN THE SOFTWARE.

   2. Public domain (www.unlicense.org). Anyone is free to copy, modify, publish, use, compile, sell, or distribute this
   software, in source or binary form, for any purpose, commercial or non-commercial, and by any means. The authors
   dedicate any and all copyright interest in the software to the public domain, and relinquish in perpetuity all
   present and future rights to it under copyright law. The disclaimer of warranty above applies likewise.
   -------------------------------------------------------------------------------------------------------------- */
