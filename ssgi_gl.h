/* ssgi_gl.h - v0.1 - screen-space illumination: the GLSL of every pass, as text. C99, includes ssgi.h only. Licence: end of ssgi.h.

   Do this in *one* C or C++ file:      #define SSGI_IMPLEMENTATION          (unless ssgi.h is implemented elsewhere already)
                                        #define SSGI_GL_IMPLEMENTATION
                                        #include "ssgi_gl.h"

   QUICK USE  (compiled and run by tests/test_build.c; examples/minimal.c is the whole of it with GL around)

      ssgi_gl_desc d = { 0 };                               // every choice at its default; C++: ssgi_gl_desc d = {};
      d.pass = SSGI_GL_HSAO;
      size_t length = ssgi_gl_emit(NULL, 0, &d, SSGI_GL_FRAGMENT);       // snprintf's law
      char *text = (char *)malloc(length + 1);
      ssgi_gl_emit(text, length + 1, &d, SSGI_GL_FRAGMENT);              // compile this with your own GL ...
      ssgi_gl_io row[SSGI_GL_MAX_IO];
      int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO), i;            // ... and bind what it reads and writes:
      for (i = 0; i < rows; ++i)
         if (row[i].kind == SSGI_GL_TEXTURE) printf("unit %d: %s, %s\n", row[i].slot, row[i].name, row[i].format);
      ssgi_gl_frame frame;                                  // what changes per frame: fill, upload as one uniform buffer
      ssgi_gl_frame_init(&frame, &view, 0.5f, NULL);              // view: an ssgi_view, see ssgi.h; radius 0.5 view units

   HOW A PASS IS DRAWN
      Vertex stage and fragment stage from ssgi_gl_emit, an empty vertex array, depth test and blending off, the viewport on the picture inside
      the target, glDrawArrays(GL_TRIANGLES, 0, 3). Textures are read with texelFetch: any filter, any wrap, level 0. The uniform block
      "ssgi_frame" is ssgi_gl_frame byte for byte (std140). In dialects that have layout(binding) the rows' slots are in the text; in the
      others set them once by name (glUniform1i, glUniformBlockBinding). This header calls no GL and includes no GL header.

   PASSES       ssao     fetch -> gather            ambient visibility: point samples in the hemisphere [SA07]
                hsao     fetch -> gather            ambient visibility: horizon search, slices or the paper's march [HSAO08]
                ssdo     fetch -> gather -> light   directional occlusion of an environment, one diffuse bounce, or both [SSDO09]
                lights   fetch -> light             suns, point lights, virtual point lights; shadow maps, or segments in screen space [SSDO09 4, 5]
                senders  fetch -> light             packs what surfaces send, their normal and depth: one fetch a sample for the bounce
                blur     fetch -> filter            smooths what the others wrote, within surfaces

   DIRECTIONAL OCCLUSION AND A BOUNCE, in the order of drawing; all but the first are optional
      ssdo     with an environment writes o_ssgi_light: irradiance over pi, and depth; blur with colour = 1 smooths it
      lights   with accumulate = 1 adds suns and point lights to it; its shadow maps are yours, drawn as ever
      senders  packs albedo * o_ssgi_light (and a radiance of your own) with depth and normal into one slice of t_ssgi_senders; a draw a layer
      ssdo     with a bounce and no environment reads that and writes o_ssgi_bounce; blur. Outgoing radiance = albedo * (light + bounce)
      When senders may shine with the last frame's light, draw senders first, then one ssdo with environment and bounce: two targets, one visibility.

   ROOMS        search for ">>"
      >>desc       what you choose               >>io      what a pass reads and writes       >>frame    what changes per frame
      >>emit       text out                      >>rows    the table of inputs and outputs
      >>fetch  >>visibility  >>gather  >>light  >>filter  the GLSL, one chunk a function      >>passes   the table of passes

   NAMES IN THE TEXT   u_ssgi_* uniforms, t_ssgi_* samplers, o_ssgi_* outputs, ssgi_*() functions, SSGI_* constants; nothing else at global scope. */
#ifndef SSGI_GL_H
#define SSGI_GL_H

#include "ssgi.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ==== >>desc =================================================================================================== */

enum { SSGI_GL_SSAO = 0, SSGI_GL_HSAO, SSGI_GL_SSDO, SSGI_GL_LIGHTS, SSGI_GL_SENDERS, SSGI_GL_BLUR, SSGI_GL_PASSES /* how many */ };   /* desc.pass */
enum { SSGI_GL_330 = 0, SSGI_GL_410, SSGI_GL_450, SSGI_GL_300ES, SSGI_GL_310ES, SSGI_GL_320ES, SSGI_GL_DIALECTS };   /* desc.dialect */
enum { SSGI_GL_VERTEX = 0, SSGI_GL_FRAGMENT, SSGI_GL_STAGES };                                              /* stage of ssgi_gl_emit */

/* desc.depth: what the depth texture holds */
enum { SSGI_GL_DEPTH_WINDOW = 0,     /* hardware depth, any layout that ssgi_view decodes */
       SSGI_GL_DEPTH_LINEAR,         /* positive view depth; <= 0, inf or NaN is background */
       SSGI_GL_DEPTH_CUSTOM };       /* your GLSL in desc.fetch: float ssgi_custom_depth(ivec2 texel, int layer), positive view depth; layer 0 is what is seen */
/* desc.normal: how the normal is had */
enum { SSGI_GL_NORMAL_SIGNED = 0,    /* xyz in [-1,1] (any float or snorm texture), need not be unit */
       SSGI_GL_NORMAL_UNSIGNED,      /* xyz * 0.5 + 0.5 (unorm texture) */
       SSGI_GL_NORMAL_OCTAHEDRAL,    /* xy in [-1,1], octahedral map (RG16_SNORM, RG16F) */
       SSGI_GL_NORMAL_FROM_DEPTH,    /* no texture: from the nearer depth neighbours, 4 more fetches */
       SSGI_GL_NORMAL_CUSTOM };      /* your GLSL in desc.fetch: vec3 ssgi_custom_normal(ivec2 texel), view space */
/* desc.noise: what decorrelates neighbouring pixels */
enum { SSGI_GL_NOISE_GRADIENT = 0,   /* interleaved gradient noise: suits a filter of 3x3 */
       SSGI_GL_NOISE_TILE4,          /* 4x4 tile computed from the pixel: 16 directions x 4 offsets; filter_radius 2 averages exactly one tile */
       SSGI_GL_NOISE_TEXTURE };      /* your texture, tiled: ., ., b, c as ssgi_jitter_tile makes it; 1 more fetch */
/* desc.search */
enum { SSGI_GL_SLICES = 0,           /* hsao: planes through the view direction, both sides in one walk on the screen: the fast way */
       SSGI_GL_MARCH };              /* hsao: the paper's deflected ray, and normal rays above it [HSAO08 3.1-3.3] */
/* desc.falloff: how a blocker's weight falls with its distance t, by how far along their directions samples stand */
enum { SSGI_GL_FALLOFF_LINEAR = 0,   /* 1 - t/radius: lengths uniform, the paper's */
       SSGI_GL_FALLOFF_SQUARE,       /* 1 - (t/radius)^2; what a bounce needs that restores clamped virtual point lights (ssgi_gl_light.least = radius) */
       SSGI_GL_FALLOFF_CUBE };       /* 1 - (t/radius)^3: lengths uniform in volume */
/* desc.environment */
enum { SSGI_GL_ENVIRONMENT_NONE = 0,
       SSGI_GL_ENVIRONMENT_SH,       /* frame.environment: 9 coefficients, all directions for the price of the visibility */
       SSGI_GL_ENVIRONMENT_MAP };    /* one look-up a direction in an octahedral map (ssgi_environment_map), world space */
/* desc.bounce: what a blocked direction brings */
enum { SSGI_GL_BOUNCE_NONE = 0,
       SSGI_GL_BOUNCE_SOLID_ANGLE,   /* the sender's radiance over the sample's solid angle: never more than the brightest sender, no scale */
       SSGI_GL_BOUNCE_PATCH,         /* the paper's: a patch of pi r^2/N, its distance clamped at frame.nearest radii [SSDO09 section 3] */
       SSGI_GL_BOUNCE_DISC };        /* the same patch as a disc, its form factor at most 1 */
/* desc.shadow: what stands between a light and a point */
enum { SSGI_GL_SHADOW_SEGMENT = 0,   /* points on the segment to the light, radius long at most, in screen space */
       SSGI_GL_SHADOW_MAP,           /* your shadow maps, biased so that nothing shadows itself; lights without a map are unshadowed */
       SSGI_GL_SHADOW_FILL,          /* the same, and what the bias loses from points on its segment [SSDO09 section 5]; lights without a map as SEGMENT */
       SSGI_GL_SHADOW_NONE };
/* desc.radiance: what senders send */
enum { SSGI_GL_RADIANCE_LIGHT = 0,   /* albedo times what ssdo or lights wrote */
       SSGI_GL_RADIANCE_DIRECT,      /* your own texture of outgoing radiance */
       SSGI_GL_RADIANCE_BOTH };      /* the sum */
/* desc.filter */
enum { SSGI_GL_BILATERAL = 0,        /* box over a tile, weighted by distance to the centre's tangent plane (position and normal) */
       SSGI_GL_GAUSSIAN };           /* the paper's: Gaussian, weighted by the inverse of the depth difference [HSAO08 4.1.3] */

/* What you choose when a program is built. Zero is the default everywhere; counts become literal constants in the text, and what is off leaves no
   text behind. Fields that a pass does not use are not looked at, but must be in their limits. ssgi_gl_check names the field that is not. */
typedef struct ssgi_gl_desc {
    int pass;               /* SSGI_GL_SSAO .. */
    int dialect;            /* SSGI_GL_330 .. */
    int orthographic;       /* [limit: 0..1]  1: the camera is orthographic (ssgi_view.orthographic says so) */
    int depth;              /* SSGI_GL_DEPTH_WINDOW .. */
    int normal;             /* SSGI_GL_NORMAL_SIGNED .. */
    int world_normals;      /* [limit: 0..1]  1: the normals are in world space; frame.rotation turns them into view space */
    int noise;              /* SSGI_GL_NOISE_GRADIENT .. */
    int samples;            /* ssao, ssdo   [limit: 0..64] [default: 16]  directions per pixel. lights [default: 8]  points on a segment */
    int search;             /* hsao   SSGI_GL_SLICES, SSGI_GL_MARCH */
    int directions;         /* hsao   [limit: 0..32] [default: slices 1, march 6]  slices (two directions each), or N_d */
    int steps;              /* hsao   [limit: 0..64] [default: 6]  per direction: N_s. ssao, ssdo [default: 1]  points along a direction, the first blocked one counts */
    int normal_rays;        /* hsao, march only   [limit: 0..8]  N_n: rays above the horizon, per direction; 0 = none */
    int hard;               /* hsao   [limit: 0..1]  1: no attenuation, all within the radius occludes fully */
    int thin;               /* all but senders, blur   [limit: 0..1]  0: what is seen extends away from the viewer without end; 1: by frame.thickness */
    int falloff;            /* ssao, ssdo   SSGI_GL_FALLOFF_LINEAR .. */
    int kernel;             /* ssao, ssdo   [limit: 0..1]  0: one set in the text, turned by the noise; 1: M sets in a texture, the noise picks one */
    int fade;               /* ssao, ssdo   [limit: 0..1]  1: blockers fade out from frame.fade to the radius, by where the picture shows them */
    int layers;             /* all that test points   [limit: 0..8] [default: 1]  depth layers, peeled: matter is from an odd one to the next; an odd last one as thin says */
    int views;              /* all that test points   [limit: 0..4]  extra cameras: a point that any camera sees in the open is; else blocked if one finds it in matter */
    int view_layers;        /* [limit: 0..8] [default: 1]  depth layers of each extra camera */
    int receiver;           /* ssdo, lights, senders   [limit: 0..7, below layers]  which layer is lit: hidden ones become senders */
    int environment;        /* ssdo   SSGI_GL_ENVIRONMENT_NONE .. */
    int bounce;             /* ssdo   SSGI_GL_BOUNCE_NONE ..; one of the two must not be NONE; both at once share the visibility and write two targets */
    int two_sided;          /* ssdo   [limit: 0..1]  1: senders shine from both sides; 0: only toward their normal */
    int shadow;             /* lights   SSGI_GL_SHADOW_SEGMENT .. */
    int accumulate;         /* lights   [limit: 0..1]  1: adds to t_ssgi_light, what an earlier pass wrote */
    int radiance;           /* senders   SSGI_GL_RADIANCE_LIGHT .. */
    int half;               /* all but lights, senders   [limit: 0..1]  1: gathers draw one pixel of every 2x2, into targets of half size (rounded up); blur brings it to full size */
    int colour;             /* blur   [limit: 0..1]  1: three channels, of ssdo or lights, instead of ambient visibility */
    int filter;             /* blur   SSGI_GL_BILATERAL, SSGI_GL_GAUSSIAN */
    int filter_radius;      /* blur   [limit: 0..4] [default: bilateral 1, Gaussian 2]  pixels: 1 is 3x3; of half-size pixels when half is 1 */
    int filter_normals;     /* blur   [limit: 0..1]  1: neighbours' normals are compared too, 1 more fetch each */
    int lines;              /* [limit: 0..1]  1: #line directives, so that a compiler's "0:N" is line N of this header */
    const char *version;    /* your first line(s) instead of "#version ..", verbatim; NULL = ours. The dialect still decides the rest. */
    const char *fetch;      /* your GLSL, verbatim before ours, for the CUSTOM choices; NULL = none */
} ssgi_gl_desc;

/* Measured settings: the points of the README's chart. Sets the fields of desc->pass and desc->search that trade cost for accuracy (and the filter's,
   so that the same desc serves blur), leaves the others alone.
     hsao slices   FAST half 1x3, BALANCED half 2x6, BEST full size 3x8 (slices x steps)    hsao march   4x6, 6x9 + 1 normal ray, 8x18 + 2, thin
     ssao          8, 16, 32 points, thin               ssdo           half 8, 16, 32 directions
   Bad input leaves desc as it is. */
enum { SSGI_GL_FAST, SSGI_GL_BALANCED, SSGI_GL_BEST };
SSGI_DEF ssgi_result ssgi_gl_preset(ssgi_gl_desc *desc, int preset, const char **why);

/* SSGI_OK, or which field is wrong and what it may be ("desc.steps: must be 0..64"). */
SSGI_DEF ssgi_result ssgi_gl_check(const ssgi_gl_desc *desc, const char **why);

/* ==== >>emit =================================================================================================== */

/* Writes the GLSL of one stage. snprintf's law: returns the length of the whole text without its 0, writes at most capacity bytes, always ends
   them with 0 (when capacity > 0); out may be NULL when capacity is 0. A desc that ssgi_gl_check refuses, or a stage that is none, returns 0 and
   writes nothing. A pure function: the same desc gives the same bytes, whatever the locale. */
SSGI_DEF size_t ssgi_gl_emit(char *out, size_t capacity, const ssgi_gl_desc *desc, int stage);

/* A number for caches of programs: equal when the choices that reach the text are equal (texts in desc.version and desc.fetch by content). */
SSGI_DEF uint64_t ssgi_gl_key(const ssgi_gl_desc *desc);

/* The most texel fetches that a pixel of this pass makes, 0 for a bad desc; what desc.fetch does counts as one; lights: with one light. */
SSGI_DEF int ssgi_gl_fetches(const ssgi_gl_desc *desc);

SSGI_DEF const char *ssgi_gl_pass_name(int pass);         /* "hsao"; NULL past the last */
SSGI_DEF const char *ssgi_gl_dialect_name(int dialect);   /* "330", "300es"; NULL past the last */

/* ==== >>io ===================================================================================================== */

enum { SSGI_GL_TEXTURE, SSGI_GL_PARAM, SSGI_GL_OUTPUT, SSGI_GL_CONSTANT };   /* ssgi_gl_io.kind */

/* One input or output of a pass: the very row that its declaration was printed from. */
typedef struct ssgi_gl_io {
    const char *name;       /* exactly as in the text: "t_ssgi_depth" */
    int         kind;
    const char *type;       /* GLSL: "sampler2D", "vec4" */
    int         slot;       /* TEXTURE: unit (binding in dialects that have it). OUTPUT: location. CONSTANT: its value. PARAM: its block's binding: 0 ssgi_frame, 1 ssgi_views */
    size_t      offset;     /* PARAM: byte in ssgi_gl_frame or ssgi_gl_views = byte in the std140 block. Else 0 */
    const char *format;     /* TEXTURE, OUTPUT: what the texture is. PARAM: units */
} ssgi_gl_io;

#define SSGI_GL_MAX_IO 48

/* Writes the rows of a pass in this variant, in the order of the text, at most capacity of them; returns how many there are, 0 for a bad desc. */
SSGI_DEF int ssgi_gl_reflect(const ssgi_gl_desc *desc, ssgi_gl_io *rows, int capacity);

/* ==== >>frame ================================================================================================== */

/* What changes per frame, for all passes: upload it whole as the uniform block "ssgi_frame" (std140; a pass declares the members that it reads, each in its place). */
typedef struct ssgi_gl_frame {
    float   project[4];     /* from ssgi_view */
    float   unproject[4];
    float   decode[4];      /* depth[0], depth[1], clear, 0 */
    int32_t origin[2];      /* [units: texels]  first texel of the picture in the G-buffer's textures */
    int32_t size[2];        /* [units: pixels]  of the picture */
    int32_t target[2];      /* [units: texels]  first texel of the picture in the targets, and in textures that earlier passes wrote; half of it in those of half size */
    float   radius;         /* [units: view] [limit: > 0]  farthest occluder */
    float   offset;         /* [units: half pixels] [default: 1.5]  lift of the receiver along its normal, for nearest fetches: all that test points */
    float   thickness;      /* [units: view] [limit: >= 0] [default: radius]  how far behind what is seen things are taken to reach (desc.thin); 0.7 of it suits ssdo, half march */
    float   phase;          /* [limit: 0..1]  turns the noise; 0, or another value each frame when frames are averaged */
    float   fade;           /* [units: view] [default: half the radius]  where blockers begin to fade (desc.fade); the radius: nowhere */
    float   nearest;        /* [units: radii] [default: 0.25]  clamp of the distance in BOUNCE_PATCH */
    float   gain;           /* [default: 1]  of the patches' area in BOUNCE_PATCH and BOUNCE_DISC: the paper's strength of the bounce */
    float   steepest;       /* [default: 20]  slope, tan of the angle between light and normal, up to which the bias of shadow maps follows */
    int32_t lights;         /* rows of t_ssgi_lights */
    float   unused[1];
    float   rotation[12];   /* world to view, 3 columns padded to 4 (desc.world_normals, ENVIRONMENT_MAP); identity by default */
    float   environment[36];   /* ENVIRONMENT_SH: ssgi_sh_quadric of the coefficients, turned by world to view; black by default */
} ssgi_gl_frame;

/* Fills a frame: the view, the picture at the origin of textures and targets, defaults everywhere else. radius [units: view] [limit: > 0, finite]. */
SSGI_DEF ssgi_result ssgi_gl_frame_init(ssgi_gl_frame *frame, const ssgi_view *view, float radius, const char **why);

/* The extra cameras (desc.views): the uniform block "ssgi_views", binding 1. Their depths are hardware depths in the slices of one array texture, camera v's
   layer j in slice v * view_layers + j, from texel 0,0 on; each camera may use a part of it. */
typedef struct ssgi_gl_views {
    float   to[4][16];      /* view space to x, y, z, 1: pixels (times z when perspective) and view depth of that camera; column-major */
    float   from[4][16];    /* back */
    float   decode[4][4];   /* ssgi_view.depth[0], [1], clear, orthographic */
    float   size[4][4];     /* [units: pixels]  width, height; slack: what lies less before a surface is not known to be in the open, at depth 1 when perspective; 0 */
} ssgi_gl_views;

/* Sets camera i of 0..3. Both matrices are rigid, world to view: of the camera of the picture, and of the extra one whose projection `view` decodes. */
SSGI_DEF ssgi_result ssgi_gl_views_set(ssgi_gl_views *views, int i, const ssgi_view *view, const float picture_world_to_view[16],
                                       const float extra_world_to_view[16], const char **why);

/* A light: one row of the texture t_ssgi_lights, 8 texels of RGBA32F, byte for byte. All zero but the first eight members is a light without a shadow map.
   A SPOT lights only what its map sees, with desc.shadow MAP or FILL: six of them are a point light with a cube of maps. */
enum { SSGI_GL_SUN = 0, SSGI_GL_POINT, SSGI_GL_SPOT, SSGI_GL_VPL };
typedef struct ssgi_gl_light {
    float at[3], kind;      /* SUN: unit vector to the light; else where it is; view space. kind: SSGI_GL_SUN .. */
    float colour[3], least; /* SUN: irradiance facing it; POINT, SPOT: radiant intensity; VPL: radiant intensity along its normal. least: the distance below which 1/d^2 grows no more */
    float normal[3], patch; /* VPL: unit normal, falls off by the cosine. patch: width of a texel of the map, at depth 1 when perspective (ssgi_shadow_patch) */
    float map[3][4];        /* view space to x, y (texels in the tile, times depth when perspective) and view depth of the light's camera: rows */
    float decode[4];        /* of its ssgi_view: depth[0], [1], clear, orthographic */
    float tile[4];          /* [units: texels]  x, y, width, height of the map in the atlas t_ssgi_shadow; width 0: no map */
} ssgi_gl_light;

/* Gives a light its shadow map: drawn by a camera (rigid world to view, projection decoded as `view`) into texels x, y .. of the atlas. */
SSGI_DEF ssgi_result ssgi_gl_light_map(ssgi_gl_light *light, const ssgi_view *view, int x, int y, const float picture_world_to_view[16],
                                       const float light_world_to_view[16], const char **why);

#ifdef __cplusplus
}
#endif
#endif /* SSGI_GL_H: END OF HEADER ------------------------------------------------------------------------------------- */

#if defined(SSGI_GL_IMPLEMENTATION) && !defined(SSGI_GL_IMPLEMENTED)
#define SSGI_GL_IMPLEMENTED

#include <string.h>

#ifdef __cplusplus
extern "C" {
#endif

/* ==== >>features: what a desc asks for, as bits ================================================================== */

/* A row or a chunk exists in a variant when all bits that it needs are set. */
#define SSGI_GL__BIT(n)          ((uint64_t)1 << (n))
#define SSGI_GL__PERSPECTIVE     SSGI_GL__BIT(0)
#define SSGI_GL__ORTHOGRAPHIC    SSGI_GL__BIT(1)
#define SSGI_GL__GBUFFER         SSGI_GL__BIT(2) /* depth or normals are read */
#define SSGI_GL__D_TEXTURE       SSGI_GL__BIT(3) /* depth: through a texture of ours, and what it holds */
#define SSGI_GL__D_WINDOW        SSGI_GL__BIT(4)
#define SSGI_GL__D_LINEAR        SSGI_GL__BIT(5)
#define SSGI_GL__D_CUSTOM        SSGI_GL__BIT(6)
#define SSGI_GL__NORMALS         SSGI_GL__BIT(7) /* normals are read */
#define SSGI_GL__N_TEXTURE       SSGI_GL__BIT(8) /* through a texture of ours, and what it holds */
#define SSGI_GL__N_SIGNED        SSGI_GL__BIT(9)
#define SSGI_GL__N_UNSIGNED      SSGI_GL__BIT(10)
#define SSGI_GL__N_OCTA          SSGI_GL__BIT(11)
#define SSGI_GL__N_CUSTOM        SSGI_GL__BIT(12)
#define SSGI_GL__N_DEPTH         SSGI_GL__BIT(13) /* from depth */
#define SSGI_GL__N_VIEW          SSGI_GL__BIT(14) /* in view space, in world space */
#define SSGI_GL__N_WORLD         SSGI_GL__BIT(15)
#define SSGI_GL__TOWARD          SSGI_GL__BIT(16) /* the direction to the eye is needed */
#define SSGI_GL__NOISE_GRADIENT  SSGI_GL__BIT(17)
#define SSGI_GL__NOISE_TILE4     SSGI_GL__BIT(18)
#define SSGI_GL__NOISE_TEXTURE   SSGI_GL__BIT(19)
#define SSGI_GL__FULL            SSGI_GL__BIT(20) /* size of what gathers draw */
#define SSGI_GL__HALF            SSGI_GL__BIT(21)
#define SSGI_GL__SOLID           SSGI_GL__BIT(22) /* how far what is seen reaches */
#define SSGI_GL__THIN            SSGI_GL__BIT(23)
#define SSGI_GL__FIXED           SSGI_GL__BIT(24) /* thin: by the thickness alone; in lights by a segment's length too */
#define SSGI_GL__REACH           SSGI_GL__BIT(25)
#define SSGI_GL__BLOCKED         SSGI_GL__BIT(26) /* points are tested: ssao, ssdo, lights, normal rays */
#define SSGI_GL__SHALLOW         SSGI_GL__BIT(27) /* against the depth buffer alone; against more */
#define SSGI_GL__DEEP            SSGI_GL__BIT(28)
#define SSGI_GL__LAYERS          SSGI_GL__BIT(29) /* layers of the picture's camera: several, one */
#define SSGI_GL__ONE_LAYER       SSGI_GL__BIT(30)
#define SSGI_GL__VIEWS           SSGI_GL__BIT(31) /* extra cameras */
#define SSGI_GL__LOOK            SSGI_GL__BIT(33) /* the blocker itself is looked at: FADE or SENDERS */
#define SSGI_GL__FADE            SSGI_GL__BIT(34)
#define SSGI_GL__NO_FADE         SSGI_GL__BIT(35)
#define SSGI_GL__SENDERS         SSGI_GL__BIT(36) /* a bounce */
#define SSGI_GL__FIRST           SSGI_GL__BIT(37) /* receiver: what is seen, a hidden layer */
#define SSGI_GL__HIDDEN          SSGI_GL__BIT(38)
#define SSGI_GL__WORLD           SSGI_GL__BIT(39) /* world space is met: normals or an environment */
#define SSGI_GL__PROJECT         SSGI_GL__BIT(40) /* points are lifted and projected, or the width of a pixel is asked for */
#define SSGI_GL__OCTAHEDRON      SSGI_GL__BIT(41) /* an environment map is read, or normals are packed */
#define SSGI_GL__NORMALS_SENT    SSGI_GL__BIT(42) /* senders: their normals matter */
#define SSGI_GL__DEPTHS          SSGI_GL__BIT(43) /* points are tested against depth textures; else against what senders wrote, which holds depth too */
#define SSGI_GL__LAYERS_READ     SSGI_GL__BIT(44) /* hidden layers are read: for the test, or as the receiver */
#define SSGI_GL__INSIDE          SSGI_GL__BIT(45) /* pixels are asked whether they lie in the picture */
#define SSGI_GL__RECEIVED        SSGI_GL__BIT(46) /* what is found depends on where the receiver is */
#define SSGI_GL__SEEN            SSGI_GL__BIT(32) /* the depth of what is seen is read; only that of a hidden receiver */
#define SSGI_GL__UNSEEN          SSGI_GL__BIT(47)
/* From 48 on, the meaning is the pass's own. */
#define SSGI_GL__UNIFORM         SSGI_GL__BIT(48) /* ssao, ssdo: falloff */
#define SSGI_GL__SQUARE          SSGI_GL__BIT(49)
#define SSGI_GL__CUBE            SSGI_GL__BIT(50)
#define SSGI_GL__SINGLE          SSGI_GL__BIT(51) /* points along a direction */
#define SSGI_GL__SEVERAL         SSGI_GL__BIT(52)
#define SSGI_GL__K_TEXT          SSGI_GL__BIT(53) /* kernel */
#define SSGI_GL__K_TEXTURE       SSGI_GL__BIT(54)
#define SSGI_GL__E_LIT           SSGI_GL__BIT(55) /* an environment, and which */
#define SSGI_GL__E_SH            SSGI_GL__BIT(56)
#define SSGI_GL__E_MAP           SSGI_GL__BIT(57)
#define SSGI_GL__SOLID_ANGLE     SSGI_GL__BIT(58) /* bounce */
#define SSGI_GL__AREA            SSGI_GL__BIT(59) /* PATCH or DISC */
#define SSGI_GL__PATCH           SSGI_GL__BIT(60)
#define SSGI_GL__DISC            SSGI_GL__BIT(61)
#define SSGI_GL__ONE_SIDED       SSGI_GL__BIT(62)
#define SSGI_GL__TWO_SIDED       SSGI_GL__BIT(63)
#define SSGI_GL__RAYS            SSGI_GL__BIT(48) /* hsao: march with normal rays */
#define SSGI_GL__LINEAR          SSGI_GL__BIT(49) /* attenuation */
#define SSGI_GL__HARD            SSGI_GL__BIT(50)
#define SSGI_GL__MAPS_READ       SSGI_GL__BIT(48) /* lights: shadow maps */
#define SSGI_GL__SEGMENTS        SSGI_GL__BIT(49) /* points on segments */
#define SSGI_GL__ADD             SSGI_GL__BIT(50) /* accumulate */
#define SSGI_GL__S_LIGHT         SSGI_GL__BIT(48) /* senders: what they send */
#define SSGI_GL__S_DIRECT        SSGI_GL__BIT(49)
#define SSGI_GL__BILATERAL       SSGI_GL__BIT(48) /* blur */
#define SSGI_GL__GAUSSIAN        SSGI_GL__BIT(49)
#define SSGI_GL__F_NORMALS       SSGI_GL__BIT(50) /* compares normals */
#define SSGI_GL__GREY            SSGI_GL__BIT(51)
#define SSGI_GL__COLOUR          SSGI_GL__BIT(52)

typedef struct ssgi_gl__chunk { int line; uint64_t need; const char *text; } ssgi_gl__chunk;
typedef struct ssgi_gl__row { uint64_t need; ssgi_gl_io io; } ssgi_gl__row;   /* CONSTANT: io.offset is the field's place in ssgi_gl_desc */

/* ==== >>rows: inputs and outputs ================================================================================= */

#define SSGI_GL__P(need, name, type, member, units) { need, { "u_ssgi_" name, SSGI_GL_PARAM, type, 0, offsetof(ssgi_gl_frame, member), units } }
#define SSGI_GL__V(need, name, type, member, units) { need, { "u_ssgi_view_" name, SSGI_GL_PARAM, type, 1, offsetof(ssgi_gl_views, member), units } }
#define SSGI_GL__C(need, name, field)                   { need, { name, SSGI_GL_CONSTANT, "int", 0, offsetof(ssgi_gl_desc, field), "" } }
#define SSGI_GL__T(need, name, format)                  { need, { "t_ssgi_" name, SSGI_GL_TEXTURE, "sampler2D", 0, 0, format } }
#define SSGI_GL__A(need, name, type, format)            { need, { "t_ssgi_" name, SSGI_GL_TEXTURE, type "2DArray", 0, 0, format } }
#define SSGI_GL__O(need, name, type, format)            { need, { "o_ssgi_" name, SSGI_GL_OUTPUT, type, 0, 0, format } }

static const ssgi_gl__row ssgi_gl__project     = SSGI_GL__P(0, "project", "vec4", project, "pixels per view xy / depth; pixels");
static const ssgi_gl__row ssgi_gl__unproject   = SSGI_GL__P(0, "unproject", "vec4", unproject, "view xy / depth per pixel");
static const ssgi_gl__row ssgi_gl__decode_row  = SSGI_GL__P(SSGI_GL__D_WINDOW, "decode", "vec4", decode, "window depth to view depth");
static const ssgi_gl__row ssgi_gl__origin      = SSGI_GL__P(SSGI_GL__GBUFFER, "origin", "ivec2", origin, "texels");
static const ssgi_gl__row ssgi_gl__size        = SSGI_GL__P(SSGI_GL__INSIDE, "size", "ivec2", size, "pixels");
static const ssgi_gl__row ssgi_gl__target      = SSGI_GL__P(0, "target", "ivec2", target, "texels");
static const ssgi_gl__row ssgi_gl__radius      = SSGI_GL__P(0, "radius", "float", radius, "view units");
static const ssgi_gl__row ssgi_gl__near_radius = SSGI_GL__P(SSGI_GL__BILATERAL, "radius", "float", radius, "view units");
static const ssgi_gl__row ssgi_gl__offset      = SSGI_GL__P(0, "offset", "float", offset, "half pixels");
static const ssgi_gl__row ssgi_gl__p_project   = SSGI_GL__P(SSGI_GL__BLOCKED, "project", "vec4", project, "pixels per view xy / depth; pixels");
static const ssgi_gl__row ssgi_gl__p_radius    = SSGI_GL__P(SSGI_GL__BLOCKED, "radius", "float", radius, "view units");
static const ssgi_gl__row ssgi_gl__p_offset    = SSGI_GL__P(SSGI_GL__BLOCKED, "offset", "float", offset, "half pixels");
static const ssgi_gl__row ssgi_gl__p_phase     = SSGI_GL__P(SSGI_GL__BLOCKED, "phase", "float", phase, "turns");
static const ssgi_gl__row ssgi_gl__thickness   = SSGI_GL__P(SSGI_GL__THIN, "thickness", "float", thickness, "view units");
static const ssgi_gl__row ssgi_gl__phase       = SSGI_GL__P(0, "phase", "float", phase, "turns");
static const ssgi_gl__row ssgi_gl__rotation    = SSGI_GL__P(SSGI_GL__WORLD, "rotation", "mat3", rotation, "world to view");
static const ssgi_gl__row ssgi_gl__fade_row    = SSGI_GL__P(SSGI_GL__FADE, "fade", "float", fade, "view units");
static const ssgi_gl__row ssgi_gl__nearest     = SSGI_GL__P(SSGI_GL__PATCH, "nearest", "float", nearest, "radii");
static const ssgi_gl__row ssgi_gl__gain        = SSGI_GL__P(SSGI_GL__AREA, "gain", "float", gain, "");
static const ssgi_gl__row ssgi_gl__steepest    = SSGI_GL__P(SSGI_GL__MAPS_READ, "steepest", "float", steepest, "tan");
static const ssgi_gl__row ssgi_gl__lights_row  = SSGI_GL__P(0, "lights", "int", lights, "rows of t_ssgi_lights");
static const ssgi_gl__row ssgi_gl__quadric_row = SSGI_GL__P(SSGI_GL__E_SH, "environment", "vec4[9]", environment, "ssgi_sh_quadric, view space");
static const ssgi_gl__row ssgi_gl__view_to     = SSGI_GL__V(SSGI_GL__VIEWS, "to", "mat4[4]", to, "view space to pixels (times depth) and depth");
static const ssgi_gl__row ssgi_gl__view_from   = SSGI_GL__V(SSGI_GL__VIEWS | SSGI_GL__LOOK, "from", "mat4[4]", from, "and back");
static const ssgi_gl__row ssgi_gl__view_decode = SSGI_GL__V(SSGI_GL__VIEWS, "decode", "vec4[4]", decode, "window depth to view depth; w: orthographic");
static const ssgi_gl__row ssgi_gl__view_size   = SSGI_GL__V(SSGI_GL__VIEWS, "size", "vec4[4]", size, "pixels; z: slack of surfaces, per depth");
static const ssgi_gl__row ssgi_gl__depth_tex   = SSGI_GL__T(SSGI_GL__D_TEXTURE | SSGI_GL__SEEN, "depth", "depth: hardware depth (any DEPTH_COMPONENT, compare mode off) or R32F view depth");
static const ssgi_gl__row ssgi_gl__normal_tex  = SSGI_GL__T(SSGI_GL__N_TEXTURE | SSGI_GL__FIRST, "normal", "normal: RGBA16F, RGB10_A2, RG16F .. as desc.normal says");
static const ssgi_gl__row ssgi_gl__normals_tex = SSGI_GL__A(SSGI_GL__N_TEXTURE | SSGI_GL__HIDDEN, "normal", "sampler", "normals of layers 2 .. in slices 0 ..: as desc.normal says");
static const ssgi_gl__row ssgi_gl__layers_tex  = SSGI_GL__A(SSGI_GL__LAYERS_READ | SSGI_GL__D_TEXTURE, "layers", "sampler", "layers 2 .. in slices 0 ..: as t_ssgi_depth");
static const ssgi_gl__row ssgi_gl__views_tex   = SSGI_GL__A(SSGI_GL__VIEWS | SSGI_GL__DEPTHS, "views", "sampler", "extra cameras: hardware depth, slice camera * view_layers + layer");
static const ssgi_gl__row ssgi_gl__senders_tex = SSGI_GL__A(SSGI_GL__SENDERS, "senders", "usampler", "RG32UI: what senders wrote, a slice a layer");
static const ssgi_gl__row ssgi_gl__view_senders = SSGI_GL__A(SSGI_GL__SENDERS | SSGI_GL__VIEWS, "view_senders", "usampler", "RG32UI: the same of extra cameras, slice camera * view_layers + layer");
static const ssgi_gl__row ssgi_gl__kernel_tex  = SSGI_GL__T(SSGI_GL__K_TEXTURE, "kernel", "RGBA32F or RGBA16F, a row a set: ssgi_kernel, SSGI_COSINE");
static const ssgi_gl__row ssgi_gl__map_tex     = SSGI_GL__T(SSGI_GL__E_MAP, "environment", "RGB32F, RGB16F ..: ssgi_environment_map, a sample's solid angle");
static const ssgi_gl__row ssgi_gl__open_tex    = SSGI_GL__T(SSGI_GL__E_MAP, "irradiance", "RGB32F, RGB16F ..: ssgi_environment_map, solid angle 0");
static const ssgi_gl__row ssgi_gl__lights_tex  = SSGI_GL__T(0, "lights", "RGBA32F, 8 wide: a row a ssgi_gl_light");
static const ssgi_gl__row ssgi_gl__shadow_tex  = SSGI_GL__T(SSGI_GL__MAPS_READ, "shadow", "depth: hardware depth, compare mode off; the shadow maps as tiles");
static const ssgi_gl__row ssgi_gl__added_tex   = SSGI_GL__T(SSGI_GL__ADD, "light", "what an earlier pass wrote: RGBA32F or RGBA16F");
static const ssgi_gl__row ssgi_gl__albedo_tex  = SSGI_GL__T(SSGI_GL__S_LIGHT | SSGI_GL__FIRST, "albedo", "RGBA8, RGBA16F ..: linear albedo");
static const ssgi_gl__row ssgi_gl__albedos_tex = SSGI_GL__A(SSGI_GL__S_LIGHT | SSGI_GL__HIDDEN, "albedo", "sampler", "albedos of layers 2 .. in slices 0 ..");
static const ssgi_gl__row ssgi_gl__s_light_tex = SSGI_GL__T(SSGI_GL__S_LIGHT, "light", "what ssdo or lights wrote: RGBA32F or RGBA16F");
static const ssgi_gl__row ssgi_gl__direct_tex  = SSGI_GL__T(SSGI_GL__S_DIRECT, "direct", "your outgoing radiance: RGBA16F, R11F_G11F_B10F ..");
static const ssgi_gl__row ssgi_gl__noise_tex   = SSGI_GL__T(SSGI_GL__NOISE_TEXTURE, "noise", "RGBA16F, any size: ssgi_jitter_tile");
static const ssgi_gl__row ssgi_gl__ao_tex      = SSGI_GL__T(SSGI_GL__GREY, "ao", "what ssao or hsao wrote: RG32F or RG16F");
static const ssgi_gl__row ssgi_gl__light_tex   = SSGI_GL__T(SSGI_GL__COLOUR, "light", "what ssdo or lights wrote: RGBA32F or RGBA16F");
static const ssgi_gl__row ssgi_gl__ao_out      = SSGI_GL__O(0, "ao", "vec2", "RG32F or RG16F: ambient visibility, view depth for the filter; R8 or R16F if nothing filters");
static const ssgi_gl__row ssgi_gl__blurred_out = SSGI_GL__O(SSGI_GL__GREY, "ao", "float", "R8 or R16F: ambient visibility");
static const ssgi_gl__row ssgi_gl__colour_out  = SSGI_GL__O(SSGI_GL__COLOUR, "light", "vec4", "RGBA32F or RGBA16F: the same three channels, view depth");
static const ssgi_gl__row ssgi_gl__light_out   = SSGI_GL__O(SSGI_GL__E_LIT, "light", "vec4", "RGBA32F or RGBA16F: irradiance over pi, view depth for the filter");
static const ssgi_gl__row ssgi_gl__bounce_out  = SSGI_GL__O(SSGI_GL__SENDERS, "bounce", "vec4", "RGBA32F or RGBA16F: irradiance over pi from the bounce, view depth");
static const ssgi_gl__row ssgi_gl__lights_out  = SSGI_GL__O(0, "light", "vec4", "RGBA32F or RGBA16F: irradiance over pi, view depth");
static const ssgi_gl__row ssgi_gl__sender_out  = SSGI_GL__O(0, "sender", "uvec2", "RG32UI: outgoing radiance as 9 9 9 bits and 5 of exponent; view depth as 6 bits of exponent and 14, octahedral view-space normal as 6 6");
static const ssgi_gl__row ssgi_gl__c_samples   = SSGI_GL__C(0, "SSGI_SAMPLES", samples);
static const ssgi_gl__row ssgi_gl__c_directions = SSGI_GL__C(0, "SSGI_DIRECTIONS", directions);
static const ssgi_gl__row ssgi_gl__c_steps     = SSGI_GL__C(0, "SSGI_STEPS", steps);
static const ssgi_gl__row ssgi_gl__c_several   = SSGI_GL__C(SSGI_GL__SEVERAL, "SSGI_STEPS", steps);
static const ssgi_gl__row ssgi_gl__c_points    = SSGI_GL__C(SSGI_GL__SEGMENTS, "SSGI_SAMPLES", samples);
static const ssgi_gl__row ssgi_gl__c_layers    = SSGI_GL__C(SSGI_GL__DEEP, "SSGI_LAYERS", layers);
static const ssgi_gl__row ssgi_gl__c_views     = SSGI_GL__C(SSGI_GL__VIEWS, "SSGI_VIEWS", views);
static const ssgi_gl__row ssgi_gl__c_view_layers = SSGI_GL__C(SSGI_GL__VIEWS, "SSGI_VIEW_LAYERS", view_layers);
static const ssgi_gl__row ssgi_gl__c_receiver  = SSGI_GL__C(SSGI_GL__HIDDEN, "SSGI_RECEIVER", receiver);
static const ssgi_gl__row ssgi_gl__c_rays      = SSGI_GL__C(SSGI_GL__RAYS, "SSGI_NORMAL_RAYS", normal_rays);
static const ssgi_gl__row ssgi_gl__c_filter    = SSGI_GL__C(0, "SSGI_FILTER_RADIUS", filter_radius);

/* ==== >>fetch: depth, position, normal, noise ==================================================================== */

static const ssgi_gl__chunk ssgi_gl__triangle = { __LINE__ + 1, 0,
    "// one triangle that covers the viewport\n"
    "void main()\n"
    "{\n"
    "    gl_Position = vec4(float((gl_VertexID & 1) * 4) - 1.0, float((gl_VertexID & 2) * 2) - 1.0, 0.0, 1.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__far = { __LINE__ + 1, 0,
    "const float SSGI_FAR = 1e18; // the view depth of nothing\n" };

static const ssgi_gl__chunk ssgi_gl__decode_perspective = { __LINE__ + 1, SSGI_GL__D_WINDOW | SSGI_GL__PERSPECTIVE,
    "float ssgi_decode(float d)\n"
    "{\n"
    "    float w = u_ssgi_decode.x + u_ssgi_decode.y * d;\n"
    "    return d != u_ssgi_decode.z && w > 1.0 / SSGI_FAR ? 1.0 / w : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__decode_orthographic = { __LINE__ + 1, SSGI_GL__D_WINDOW | SSGI_GL__ORTHOGRAPHIC,
    "float ssgi_decode(float d)\n"
    "{\n"
    "    float z = u_ssgi_decode.x + u_ssgi_decode.y * d;\n"
    "    return d != u_ssgi_decode.z && z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__depth_window = { __LINE__ + 1, SSGI_GL__D_WINDOW | SSGI_GL__SEEN,
    "// view depth at a pixel of the picture\n"
    "float ssgi_depth(ivec2 p)\n"
    "{\n"
    "    return ssgi_decode(texelFetch(t_ssgi_depth, p + u_ssgi_origin, 0).x);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__depth_linear = { __LINE__ + 1, SSGI_GL__D_LINEAR | SSGI_GL__SEEN,
    "// view depth at a pixel of the picture\n"
    "float ssgi_depth(ivec2 p)\n"
    "{\n"
    "    float z = texelFetch(t_ssgi_depth, p + u_ssgi_origin, 0).x;\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__depth_custom = { __LINE__ + 1, SSGI_GL__D_CUSTOM | SSGI_GL__FIRST,
    "// view depth at a pixel of the picture\n"
    "float ssgi_depth(ivec2 p)\n"
    "{\n"
    "    float z = ssgi_custom_depth(p + u_ssgi_origin, 0);\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__layer_window = { __LINE__ + 1, SSGI_GL__LAYERS_READ | SSGI_GL__D_WINDOW | SSGI_GL__SEEN,
    "// view depth of a layer at a pixel of the picture; layer 0 is what is seen\n"
    "float ssgi_layer(ivec2 p, int j)\n"
    "{\n"
    "    return j == 0 ? ssgi_depth(p) : ssgi_decode(texelFetch(t_ssgi_layers, ivec3(p + u_ssgi_origin, j - 1), 0).x);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__layer_linear = { __LINE__ + 1, SSGI_GL__LAYERS_READ | SSGI_GL__D_LINEAR | SSGI_GL__SEEN,
    "// view depth of a layer at a pixel of the picture; layer 0 is what is seen\n"
    "float ssgi_layer(ivec2 p, int j)\n"
    "{\n"
    "    if (j == 0) return ssgi_depth(p);\n"
    "    float z = texelFetch(t_ssgi_layers, ivec3(p + u_ssgi_origin, j - 1), 0).x;\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__hidden_window = { __LINE__ + 1, SSGI_GL__D_WINDOW | SSGI_GL__UNSEEN,
    "// view depth of a hidden layer at a pixel of the picture\n"
    "float ssgi_layer(ivec2 p, int j)\n"
    "{\n"
    "    return ssgi_decode(texelFetch(t_ssgi_layers, ivec3(p + u_ssgi_origin, j - 1), 0).x);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__hidden_linear = { __LINE__ + 1, SSGI_GL__D_LINEAR | SSGI_GL__UNSEEN,
    "// view depth of a hidden layer at a pixel of the picture\n"
    "float ssgi_layer(ivec2 p, int j)\n"
    "{\n"
    "    float z = texelFetch(t_ssgi_layers, ivec3(p + u_ssgi_origin, j - 1), 0).x;\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__layer_custom = { __LINE__ + 1, SSGI_GL__LAYERS_READ | SSGI_GL__D_CUSTOM,
    "// view depth of a layer at a pixel of the picture; layer 0 is what is seen\n"
    "float ssgi_layer(ivec2 p, int j)\n"
    "{\n"
    "    float z = ssgi_custom_depth(p + u_ssgi_origin, j);\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__position_perspective = { __LINE__ + 1, SSGI_GL__PERSPECTIVE,
    "// the view-space point seen at a pixel position, at a view depth\n"
    "vec3 ssgi_position(vec2 pixel, float z)\n"
    "{\n"
    "    return vec3((pixel * u_ssgi_unproject.xy + u_ssgi_unproject.zw) * z, -z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__position_orthographic = { __LINE__ + 1, SSGI_GL__ORTHOGRAPHIC,
    "// the view-space point seen at a pixel position, at a view depth\n"
    "vec3 ssgi_position(vec2 pixel, float z)\n"
    "{\n"
    "    return vec3(pixel * u_ssgi_unproject.xy + u_ssgi_unproject.zw, -z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__project_perspective = { __LINE__ + 1, SSGI_GL__PROJECT | SSGI_GL__PERSPECTIVE,
    "// the pixel position of a view-space point in front of the eye\n"
    "vec2 ssgi_project(vec3 P)\n"
    "{\n"
    "    return P.xy * (u_ssgi_project.xy / -P.z) + u_ssgi_project.zw;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__project_orthographic = { __LINE__ + 1, SSGI_GL__PROJECT | SSGI_GL__ORTHOGRAPHIC,
    "// the pixel position of a view-space point\n"
    "vec2 ssgi_project(vec3 P)\n"
    "{\n"
    "    return P.xy * u_ssgi_project.xy + u_ssgi_project.zw;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__footprint_perspective = { __LINE__ + 1, SSGI_GL__PROJECT | SSGI_GL__PERSPECTIVE,
    "// width of a pixel at a view depth\n"
    "float ssgi_footprint(float z)\n"
    "{\n"
    "    return max(abs(u_ssgi_unproject.x), abs(u_ssgi_unproject.y)) * z;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__footprint_orthographic = { __LINE__ + 1, SSGI_GL__PROJECT | SSGI_GL__ORTHOGRAPHIC,
    "// width of a pixel\n"
    "float ssgi_footprint(float z)\n"
    "{\n"
    "    return max(abs(u_ssgi_unproject.x), abs(u_ssgi_unproject.y));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__inside = { __LINE__ + 1, SSGI_GL__INSIDE,
    "bool ssgi_inside(ivec2 p)\n"
    "{\n"
    "    return uint(p.x) < uint(u_ssgi_size.x) && uint(p.y) < uint(u_ssgi_size.y); // negative is large\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__toward_perspective = { __LINE__ + 1, SSGI_GL__TOWARD | SSGI_GL__PERSPECTIVE,
    "// unit vector to the eye\n"
    "vec3 ssgi_toward(vec3 P)\n"
    "{\n"
    "    return P * -inversesqrt(dot(P, P));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__toward_orthographic = { __LINE__ + 1, SSGI_GL__TOWARD | SSGI_GL__ORTHOGRAPHIC,
    "// unit vector to the eye\n"
    "vec3 ssgi_toward(vec3 P)\n"
    "{\n"
    "    return vec3(0.0, 0.0, 1.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__unit = { __LINE__ + 1, SSGI_GL__NORMALS,
    "// a unit normal from whatever the texture held\n"
    "vec3 ssgi_unit(vec3 n)\n"
    "{\n"
    "    float l = dot(n, n);\n"
    "    return l > 1e-12 && l < 1e12 ? n * inversesqrt(l) : vec3(0.0, 0.0, 1.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__texel_first = { __LINE__ + 1, SSGI_GL__N_TEXTURE | SSGI_GL__FIRST,
    "vec4 ssgi_normal_texel(ivec2 p)\n"
    "{\n"
    "    return texelFetch(t_ssgi_normal, p + u_ssgi_origin, 0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__texel_hidden = { __LINE__ + 1, SSGI_GL__N_TEXTURE | SSGI_GL__HIDDEN,
    "vec4 ssgi_normal_texel(ivec2 p)\n"
    "{\n"
    "    return texelFetch(t_ssgi_normal, ivec3(p + u_ssgi_origin, SSGI_RECEIVER - 1), 0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__raw_signed = { __LINE__ + 1, SSGI_GL__N_SIGNED,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    return ssgi_normal_texel(p).xyz;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__raw_unsigned = { __LINE__ + 1, SSGI_GL__N_UNSIGNED,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    return ssgi_normal_texel(p).xyz * 2.0 - 1.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__raw_octahedral = { __LINE__ + 1, SSGI_GL__N_OCTA,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    vec2 e = ssgi_normal_texel(p).xy;\n"
    "    vec3 n = vec3(e, 1.0 - abs(e.x) - abs(e.y));\n"
    "    float t = max(-n.z, 0.0);\n"
    "    return vec3(n.x + (n.x >= 0.0 ? -t : t), n.y + (n.y >= 0.0 ? -t : t), n.z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__raw_custom = { __LINE__ + 1, SSGI_GL__N_CUSTOM,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    return ssgi_custom_normal(p + u_ssgi_origin);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__normal_view = { __LINE__ + 1, SSGI_GL__N_VIEW,
    "// unit view-space normal at a pixel of the picture whose point is P\n"
    "vec3 ssgi_normal(ivec2 p, vec3 P)\n"
    "{\n"
    "    return ssgi_unit(ssgi_raw_normal(p));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__normal_world = { __LINE__ + 1, SSGI_GL__N_WORLD,
    "// unit view-space normal at a pixel of the picture whose point is P\n"
    "vec3 ssgi_normal(ivec2 p, vec3 P)\n"
    "{\n"
    "    return ssgi_unit(u_ssgi_rotation * ssgi_raw_normal(p));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__normal_from_depth = { __LINE__ + 1, SSGI_GL__N_DEPTH,
    "// the neighbour on either side whose depth is nearer, as a difference along +step\n"
    "vec3 ssgi_tangent(ivec2 p, vec3 P, ivec2 step_)\n"
    "{\n"
    "    float a = ssgi_inside(p + step_) ? ssgi_depth(p + step_) : SSGI_FAR, b = ssgi_inside(p - step_) ? ssgi_depth(p - step_) : SSGI_FAR;\n"
    "    vec3 A = ssgi_position(vec2(p + step_) + 0.5, a) - P, B = P - ssgi_position(vec2(p - step_) + 0.5, b);\n"
    "    return abs(A.z) < abs(B.z) ? A : B;\n"
    "}\n"
    "\n"
    "// unit view-space normal at a pixel of the picture whose point is P, facing the viewer\n"
    "vec3 ssgi_normal(ivec2 p, vec3 P)\n"
    "{\n"
    "    vec3 x = ssgi_tangent(p, P, ivec2(1, 0)), y = ssgi_tangent(p, P, ivec2(0, 1));\n"
    "    vec3 n = ssgi_unit(cross(x * inversesqrt(dot(x, x) + 1e-30), y * inversesqrt(dot(y, y) + 1e-30)));\n"
    "    return dot(n, ssgi_toward(P)) < 0.0 ? -n : n;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__noise_tile4 = { __LINE__ + 1, SSGI_GL__NOISE_TILE4,
    "// x, y: in [0,1), evenly spread over every 4x4 block\n"
    "vec2 ssgi_noise(ivec2 p)\n"
    "{\n"
    "    return fract((vec2(float((((p.x + p.y) & 3) << 2) + (p.x & 3)), float((p.y - p.x) & 3) * 4.0) + 0.5) / 16.0 + u_ssgi_phase);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__noise_gradient = { __LINE__ + 1, SSGI_GL__NOISE_GRADIENT,
    "// in [0,1): x interleaved gradient noise, evenly spread over every 3x3 block, y the R2 sequence along the picture\n"
    "vec2 ssgi_noise(ivec2 p)\n"
    "{\n"
    "    vec2 q = vec2(p);\n"
    "    return fract(vec2(52.9829189 * fract(dot(q, vec2(0.06711056, 0.00583715))), dot(q, vec2(0.75487767, 0.56984029))) + u_ssgi_phase);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__noise_texture = { __LINE__ + 1, SSGI_GL__NOISE_TEXTURE,
    "// in [0,1): x turns the directions, y offsets the steps; c and b + 0.5 of ssgi_jitter_tile\n"
    "vec2 ssgi_noise(ivec2 p)\n"
    "{\n"
    "    ivec2 tile = textureSize(t_ssgi_noise, 0);\n"
    "    vec4 j = texelFetch(t_ssgi_noise, ivec2(p.x % tile.x, p.y % tile.y), 0);\n"
    "    return fract(vec2(j.w, j.z + 0.5) + u_ssgi_phase);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__unpack = { __LINE__ + 1, SSGI_GL__SENDERS,
    "// what senders wrote: radiance; view depth; the way of the normal, not unit\n"
    "vec3 ssgi_unpack_radiance(uint u)\n"
    "{\n"
    "    return vec3(float(u & 511u), float((u >> 9u) & 511u), float((u >> 18u) & 511u)) * uintBitsToFloat(((u >> 27u) + 103u) << 23u);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__unpack_depth = { __LINE__ + 1, SSGI_GL__SENDERS,
    "float ssgi_unpack_depth(uint u)\n"
    "{\n"
    "    return u < 0xfffff000u ? uintBitsToFloat(((u >> 12u) + (107u << 14u)) << 9u) : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__unpack_normal = { __LINE__ + 1, SSGI_GL__NORMALS_SENT,
    "vec3 ssgi_unpack_normal(uint u)\n"
    "{\n"
    "    vec2 e = vec2(float(u & 63u), float((u >> 6u) & 63u)) - 32.0;\n"
    "    vec3 n = vec3(e, 31.0 - abs(e.x) - abs(e.y));\n"
    "    float t = max(-n.z, 0.0);\n"
    "    return vec3(n.x + (n.x >= 0.0 ? -t : t), n.y + (n.y >= 0.0 ? -t : t), n.z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__octahedron = { __LINE__ + 1, SSGI_GL__OCTAHEDRON,
    "// a direction on the octahedral map's square, [-1,1]\n"
    "vec2 ssgi_octahedral(vec3 d)\n"
    "{\n"
    "    vec2 e = d.xy / (abs(d.x) + abs(d.y) + abs(d.z));\n"
    "    return d.z >= 0.0 ? e : (1.0 - abs(e.yx)) * vec2(e.x >= 0.0 ? 1.0 : -1.0, e.y >= 0.0 ? 1.0 : -1.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__pack = { __LINE__ + 1, 0,
    "// radiance in [0, 65408] as three mantissas of 9 bits and one exponent\n"
    "uint ssgi_pack_radiance(vec3 c)\n"
    "{\n"
    "    c = clamp(c, 0.0, 65408.0);\n"
    "    float most = max(max(c.x, c.y), max(c.z, 6.1035156e-5)) * 1.0009775; // rounds up to the next exponent where 9 bits would overflow\n"
    "    uint e = min((floatBitsToUint(most) >> 23u) - 111u, 31u);\n"
    "    uvec3 m = min(uvec3(c * uintBitsToFloat((151u - e) << 23u) + 0.5), uvec3(511u));\n"
    "    return m.x | (m.y << 9u) | (m.z << 18u) | (e << 27u);\n"
    "}\n"
    "\n"
    "// view depth in [1e-6, 1e13], to 3e-5 of it, and a normal, to 4 degrees\n"
    "uint ssgi_pack_place(float z, vec3 n)\n"
    "{\n"
    "    uvec2 e = uvec2(round(ssgi_octahedral(n) * 31.0) + 32.0);\n"
    "    return ((((floatBitsToUint(clamp(z, 1e-6, 1e13)) + 256u) >> 9u) - (107u << 14u)) << 12u) | (e.y << 6u) | e.x;\n"
    "}\n" };

/* ==== >>visibility: is this point behind a surface ================================================================ */

static const ssgi_gl__chunk ssgi_gl__lift = { __LINE__ + 1, SSGI_GL__PROJECT,
    "// the receiver lifted along its normal, so that nearest fetches of its own plane stay below it [HSAO08 eq. 13]\n"
    "vec3 ssgi_lift(vec3 P, vec3 n)\n"
    "{\n"
    "    return P + n * (u_ssgi_offset * 0.5 * ssgi_footprint(-P.z));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__back_fixed = { __LINE__ + 1, SSGI_GL__FIXED,
    "// how far what is seen reaches away from the viewer\n"
    "float ssgi_thickness()\n"
    "{\n"
    "    return u_ssgi_thickness;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__back_reach = { __LINE__ + 1, SSGI_GL__REACH,
    "// how far what is seen reaches away from the viewer; a short segment must not end on what floats far before it\n"
    "float ssgi_reach;\n"
    "float ssgi_thickness()\n"
    "{\n"
    "    return min(u_ssgi_thickness, 2.0 * ssgi_reach);\n"
    "}\n" };

/* The blocker itself, where it is looked at: what it sends, how far it is. */

static const ssgi_gl__chunk ssgi_gl__look_from = { __LINE__ + 1, SSGI_GL__RECEIVED,
    "vec3 ssgi_P; // the receiver\n" };
static const ssgi_gl__chunk ssgi_gl__look_normal = { __LINE__ + 1, SSGI_GL__AREA,
    "vec3 ssgi_n; // its normal\n" };

static const ssgi_gl__chunk ssgi_gl__look_head = { __LINE__ + 1, SSGI_GL__LOOK,
    "// the point that camera v shows at a pixel and depth; -1 is the picture's\n"
    "vec3 ssgi_point(int v, ivec2 p, float z)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__look_views = { __LINE__ + 1, SSGI_GL__LOOK | SSGI_GL__VIEWS,
    "    if (v >= 0) return (u_ssgi_view_from[v] * vec4((vec2(p) + 0.5) * (u_ssgi_view_decode[v].w > 0.0 ? 1.0 : z), z, 1.0)).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__look_tail = { __LINE__ + 1, SSGI_GL__LOOK,
    "    return ssgi_position(vec2(p) + 0.5, z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sent_head = { __LINE__ + 1, SSGI_GL__SENDERS,
    "vec4 ssgi_sender; // what the surface found around the sample sends to the receiver, and how near it is\n"
    "\n"
    "// what layer j of camera v holds at a pixel: radiance, normal, view depth\n"
    "uvec2 ssgi_held(int v, ivec2 p, int j)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__sent_views = { __LINE__ + 1, SSGI_GL__SENDERS | SSGI_GL__VIEWS,
    "    if (v >= 0) return texelFetch(t_ssgi_view_senders, ivec3(p, v * SSGI_VIEW_LAYERS + j), 0).xy;\n" };
static const ssgi_gl__chunk ssgi_gl__sent_main = { __LINE__ + 1, SSGI_GL__SENDERS,
    "    return texelFetch(t_ssgi_senders, ivec3(p + u_ssgi_target, j), 0).xy;\n"
    "}\n"
    "\n"
    "// what a surface at Q sends to the receiver\n"
    "vec3 ssgi_sent(uvec2 s, vec3 Q)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__sent_both = { __LINE__ + 1, SSGI_GL__TWO_SIDED | SSGI_GL__SOLID_ANGLE,
    "    return ssgi_unpack_radiance(s.x);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sent_facing = { __LINE__ + 1, SSGI_GL__ONE_SIDED | SSGI_GL__SOLID_ANGLE,
    "    return dot(ssgi_unpack_normal(s.y), ssgi_P - Q) > 0.0 ? ssgi_unpack_radiance(s.x) : vec3(0.0);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sent_area = { __LINE__ + 1, SSGI_GL__AREA,
    "    vec3 d = ssgi_P - Q;\n"
    "    float dd = max(dot(d, d), 1e-30), area = u_ssgi_radius * u_ssgi_radius * u_ssgi_gain, r = -dot(ssgi_n, d), c = dot(normalize(ssgi_unpack_normal(s.y)), d);\n" };
static const ssgi_gl__chunk ssgi_gl__sent_area_both = { __LINE__ + 1, SSGI_GL__AREA | SSGI_GL__TWO_SIDED,
    "    c = abs(c);\n" };
static const ssgi_gl__chunk ssgi_gl__sent_patch = { __LINE__ + 1, SSGI_GL__PATCH,
    "    float least = u_ssgi_nearest * u_ssgi_radius;\n"
    "    return ssgi_unpack_radiance(s.x) * (area * max(r, 0.0) * max(c, 0.0) / (dd * max(dd, least * least)));\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__sent_disc = { __LINE__ + 1, SSGI_GL__DISC,
    "    return ssgi_unpack_radiance(s.x) * (area * max(r, 0.0) * max(c, 0.0) / (dd * (dd + area / float(SSGI_SAMPLES))));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__faded = { __LINE__ + 1, SSGI_GL__FADE,
    "// how much a blocker that the picture shows at Q still blocks\n"
    "float ssgi_faded(vec3 Q)\n"
    "{\n"
    "    return max(1.0 - smoothstep(u_ssgi_fade, u_ssgi_radius * 1.0001, distance(ssgi_P, Q)), 1e-6);\n"
    "}\n" };

/* The shallow test: against the depth buffer alone. */

static const ssgi_gl__chunk ssgi_gl__shallow_head = { __LINE__ + 1, SSGI_GL__BLOCKED | SSGI_GL__SHALLOW,
    "// how much S is blocked: behind what is seen at its pixel; 0 off the picture and behind the eye\n"
    "float ssgi_blocked(vec3 S)\n"
    "{\n"
    "    ivec2 p = ivec2(floor(ssgi_project(S)));\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_depth = { __LINE__ + 1, SSGI_GL__SHALLOW | SSGI_GL__DEPTHS,
    "    float z = ssgi_depth(p), behind = -S.z - z;\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_send = { __LINE__ + 1, SSGI_GL__SHALLOW | SSGI_GL__SENDERS,
    "    uvec2 s = ssgi_held(-1, p, 0);\n"
    "    float z = ssgi_unpack_depth(s.y), behind = -S.z - z;\n"
    "    ssgi_sender.xyz = ssgi_sent(s, ssgi_point(-1, p, z));\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_test = { __LINE__ + 1, SSGI_GL__BLOCKED | SSGI_GL__SHALLOW,
    "    return S.z < 0.0 && ssgi_inside(p) && behind > 0.0\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_thin = { __LINE__ + 1, SSGI_GL__BLOCKED | SSGI_GL__SHALLOW | SSGI_GL__THIN,
    "        && behind < ssgi_thickness()\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_whole = { __LINE__ + 1, SSGI_GL__BLOCKED | SSGI_GL__SHALLOW | SSGI_GL__NO_FADE,
    "        ? 1.0 : 0.0;\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__shallow_fade = { __LINE__ + 1, SSGI_GL__SHALLOW | SSGI_GL__FADE,
    "        ? ssgi_faded(ssgi_point(-1, p, z)) : 0.0;\n"
    "}\n" };

/* The deep test: the same question to depth layers of the picture's camera (v = -1) and of extra ones. */

static const ssgi_gl__chunk ssgi_gl__view_surface = { __LINE__ + 1, SSGI_GL__VIEWS | SSGI_GL__DEPTHS,
    "// view depth of a layer that extra camera v sees\n"
    "float ssgi_view_layer(int v, ivec2 p, int j)\n"
    "{\n"
    "    float d = texelFetch(t_ssgi_views, ivec3(p, v * SSGI_VIEW_LAYERS + j), 0).x, w = u_ssgi_view_decode[v].x + u_ssgi_view_decode[v].y * d;\n"
    "    if (d == u_ssgi_view_decode[v].z || w <= 1.0 / SSGI_FAR) return SSGI_FAR;\n"
    "    return u_ssgi_view_decode[v].w > 0.0 ? w : 1.0 / w;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__surface_head = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__DEPTHS,
    "// view depth of layer j at a pixel of camera v\n"
    "float ssgi_surface(int v, ivec2 p, int j)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__surface_views = { __LINE__ + 1, SSGI_GL__VIEWS | SSGI_GL__DEPTHS,
    "    if (v >= 0) return ssgi_view_layer(v, p, j);\n" };
static const ssgi_gl__chunk ssgi_gl__surface_layers = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__DEPTHS | SSGI_GL__LAYERS,
    "    return ssgi_layer(p, j);\n"
    "}\n" };
static const ssgi_gl__chunk ssgi_gl__surface_one = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__DEPTHS | SSGI_GL__ONE_LAYER,
    "    return ssgi_depth(p);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__offer = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SENDERS,
    "vec3 ssgi_way; // from the receiver to the sample\n"
    "\n"
    "// of the surfaces around the sample that send anything the sender is the one nearest to that way\n"
    "void ssgi_offer(uvec2 s, vec3 Q)\n"
    "{\n"
    "    vec3 L = ssgi_sent(s, Q), d = cross(Q - ssgi_P, ssgi_way);\n"
    "    float gap = dot(d, d);\n"
    "    if (gap < ssgi_sender.w && L != vec3(0.0)) ssgi_sender = vec4(L, gap);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__matter_head = { __LINE__ + 1, SSGI_GL__DEEP,
    "// Where depth s stands at a pixel of camera v: above 0 inside matter, which is from an odd layer to the next; -1 seen in the open, by more than the slack; 0 not known.\n"
    "float ssgi_matter(int v, ivec2 p, float s, int layers, float slack)\n"
    "{\n" };
static const ssgi_gl__chunk ssgi_gl__matter_solid = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SOLID,
    "    // matter whose far side is no layer has no end\n" };
static const ssgi_gl__chunk ssgi_gl__matter_thin = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__THIN,
    "    // matter whose far side is no layer is ssgi_thickness() thick, and what lies behind it is not known\n" };
static const ssgi_gl__chunk ssgi_gl__matter_loop = { __LINE__ + 1, SSGI_GL__DEEP,
    "    float found = 0.0;\n"
    "    bool known = false;\n"
    "    for (int j = 0; j < layers; j += 2) {\n" };
static const ssgi_gl__chunk ssgi_gl__matter_depths = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__DEPTHS,
    "        float near = ssgi_surface(v, p, j), far = j + 1 < layers ? ssgi_surface(v, p, j + 1) : SSGI_FAR, back = far;\n" };
static const ssgi_gl__chunk ssgi_gl__matter_held = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SENDERS,
    "        uvec2 a = ssgi_held(v, p, j), b = j + 1 < layers ? ssgi_held(v, p, j + 1) : uvec2(0xffffffffu);\n"
    "        float near = ssgi_unpack_depth(a.y), far = ssgi_unpack_depth(b.y), back = far;\n" };
static const ssgi_gl__chunk ssgi_gl__matter_back = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__THIN,
    "        if (far >= SSGI_FAR) back = near + ssgi_thickness();\n" };
static const ssgi_gl__chunk ssgi_gl__matter_inside = { __LINE__ + 1, SSGI_GL__DEEP,
    "        bool inside = !known && s > near && s < back;\n"
    "        if (!known && s <= near - slack) found = -1.0;\n" };
static const ssgi_gl__chunk ssgi_gl__matter_offer = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SENDERS,
    "        if (inside) {\n"
    "            ssgi_offer(a, ssgi_point(v, p, near));\n"
    "            if (far < SSGI_FAR) ssgi_offer(b, ssgi_point(v, p, far));\n"
    "        }\n" };
static const ssgi_gl__chunk ssgi_gl__matter_fade = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__FADE,
    "        if (inside) found = ssgi_faded(ssgi_point(v, p, s - near < far - s ? near : far));\n" };
static const ssgi_gl__chunk ssgi_gl__matter_whole = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__NO_FADE,
    "        if (inside) found = 1.0;\n" };
static const ssgi_gl__chunk ssgi_gl__matter_tail = { __LINE__ + 1, SSGI_GL__DEEP,
    "        known = known || s < back || far >= SSGI_FAR; // within the slack before a surface nothing is known either\n"
    "    }\n"
    "    return found;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__deep_head = { __LINE__ + 1, SSGI_GL__DEEP,
    "// how much S is blocked: inside matter\n"
    "float ssgi_blocked(vec3 S)\n"
    "{\n"
    "    ivec2 p = ivec2(floor(ssgi_project(S)));\n" };
static const ssgi_gl__chunk ssgi_gl__deep_reset = { __LINE__ + 1, SSGI_GL__DEEP | SSGI_GL__SENDERS,
    "    ssgi_sender = vec4(0.0, 0.0, 0.0, SSGI_FAR);\n"
    "    ssgi_way = S - ssgi_P;\n" };
static const ssgi_gl__chunk ssgi_gl__deep_main = { __LINE__ + 1, SSGI_GL__DEEP,
    "    float found = S.z < 0.0 && ssgi_inside(p) ? ssgi_matter(-1, p, -S.z, SSGI_LAYERS, 0.0) : 0.0;\n" };
static const ssgi_gl__chunk ssgi_gl__deep_views = { __LINE__ + 1, SSGI_GL__VIEWS,
    "    for (int v = 0; v < SSGI_VIEWS; ++v) { // whoever sees it in the open is right\n"
    "        vec3 q = (u_ssgi_view_to[v] * vec4(S, 1.0)).xyz;\n"
    "        p = ivec2(floor(u_ssgi_view_decode[v].w > 0.0 ? q.xy : q.xy / q.z));\n"
    "        if (q.z > 0.0 && p.x >= 0 && p.y >= 0 && p.x < int(u_ssgi_view_size[v].x) && p.y < int(u_ssgi_view_size[v].y)) {\n"
    "            float m = ssgi_matter(v, p, q.z, SSGI_VIEW_LAYERS, u_ssgi_view_size[v].z * (u_ssgi_view_decode[v].w > 0.0 ? 1.0 : q.z));\n"
    "            found = min(found, m) < 0.0 ? -1.0 : max(found, m);\n"
    "        }\n"
    "    }\n" };
static const ssgi_gl__chunk ssgi_gl__deep_tail = { __LINE__ + 1, SSGI_GL__DEEP,
    "    return max(found, 0.0);\n"
    "}\n" };

/* ==== >>gather: what a pixel collects ============================================================================= */

static const ssgi_gl__chunk ssgi_gl__basis = { __LINE__ + 1, 0,
    "// any rotation that takes +z to the unit vector n [Duff et al. 2017]\n"
    "mat3 ssgi_basis(vec3 n)\n"
    "{\n"
    "    float s = n.z >= 0.0 ? 1.0 : -1.0, a = -1.0 / (s + n.z), b = n.x * n.y * a;\n"
    "    return mat3(1.0 + s * n.x * n.x * a, s * b, -s * n.x, b, s + n.y * n.y * a, -n.y, n);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__kernel = { __LINE__ + 1, SSGI_GL__K_TEXT, "" };   /* printed by ssgi_gl__put_kernel */

/* Points along directions: ssao and ssdo are this one loop; what they do with a blocked direction differs. */

static const ssgi_gl__chunk ssgi_gl__points_ao = { __LINE__ + 1, 0,
    "// occlusion from point samples: directions by the cosine, lengths such that it converges to the attenuation that desc.falloff names\n"
    "float ssgi_occlusion(ivec2 p, vec3 P, vec3 n, vec2 xi)\n"
    "{\n"
    "    float sum = 0.0;\n" };

static const ssgi_gl__chunk ssgi_gl__points_ssdo = { __LINE__ + 1, 0,
    "// what directions by the cosine bring: an environment where they are free, a sender's light where they are blocked [SSDO09 section 3]\n"
    "void ssgi_gather(vec3 P, vec3 n, vec2 xi)\n"
    "{\n" };

static const ssgi_gl__chunk ssgi_gl__points_from = { __LINE__ + 1, SSGI_GL__RECEIVED,
    "    ssgi_P = P;\n" };

static const ssgi_gl__chunk ssgi_gl__points_normal = { __LINE__ + 1, SSGI_GL__AREA,
    "    ssgi_n = n;\n" };

static const ssgi_gl__chunk ssgi_gl__points_turn = { __LINE__ + 1, SSGI_GL__K_TEXT,
    "    float a = 6.28318531 * xi.x, c = cos(a), s = sin(a);\n"
    "    mat3 basis = ssgi_basis(n) * mat3(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0);\n" };

static const ssgi_gl__chunk ssgi_gl__points_pick = { __LINE__ + 1, SSGI_GL__K_TEXTURE,
    "    int set = int(xi.x * float(textureSize(t_ssgi_kernel, 0).y));\n"
    "    mat3 basis = ssgi_basis(n);\n" };

static const ssgi_gl__chunk ssgi_gl__points_sh = { __LINE__ + 1, SSGI_GL__E_SH,
    "    vec3 first = vec3(0.0), square = vec3(0.0), mixed = vec3(0.0); // moments of the blocked directions, about n: x y z, xx yy zz, xy yz zx\n" };

static const ssgi_gl__chunk ssgi_gl__points_map = { __LINE__ + 1, SSGI_GL__E_MAP,
    "    mat3 world = transpose(u_ssgi_rotation) * basis;\n"
    "    vec3 all = vec3(0.0), dark = vec3(0.0);\n" };

static const ssgi_gl__chunk ssgi_gl__points_bounce = { __LINE__ + 1, SSGI_GL__SENDERS,
    "    vec3 bounce = vec3(0.0);\n" };

static const ssgi_gl__chunk ssgi_gl__points_loop = { __LINE__ + 1, 0,
    "    vec3 start = ssgi_lift(P, n);\n"
    "    for (int i = 0; i < SSGI_SAMPLES; ++i) {\n" };

static const ssgi_gl__chunk ssgi_gl__points_constant = { __LINE__ + 1, SSGI_GL__K_TEXT,
    "        vec4 k = SSGI_KERNEL[i];\n" };

static const ssgi_gl__chunk ssgi_gl__points_fetched = { __LINE__ + 1, SSGI_GL__K_TEXTURE,
    "        vec4 k = texelFetch(t_ssgi_kernel, ivec2(i, set), 0);\n" };

static const ssgi_gl__chunk ssgi_gl__points_single = { __LINE__ + 1, SSGI_GL__SINGLE,
    "        float blocked = ssgi_blocked(start + basis * k.xyz * (u_ssgi_radius * ssgi_length(fract(k.w + xi.y))));\n" };

static const ssgi_gl__chunk ssgi_gl__points_several = { __LINE__ + 1, SSGI_GL__SEVERAL,
    "        vec3 w = basis * k.xyz * u_ssgi_radius;\n"
    "        float t = fract(k.w + xi.y), blocked = 0.0;\n"
    "        for (int j = 0; j < SSGI_STEPS && blocked <= 0.0; ++j) blocked = ssgi_blocked(start + w * ssgi_length((float(j) + t) / float(SSGI_STEPS)));\n" };

static const ssgi_gl__chunk ssgi_gl__length_uniform = { __LINE__ + 1, SSGI_GL__UNIFORM,
    "// where on its direction a sample stands\n"
    "float ssgi_length(float xi)\n"
    "{\n"
    "    return xi;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__length_square = { __LINE__ + 1, SSGI_GL__SQUARE,
    "// where on its direction a sample stands\n"
    "float ssgi_length(float xi)\n"
    "{\n"
    "    return sqrt(xi);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__length_cube = { __LINE__ + 1, SSGI_GL__CUBE,
    "// where on its direction a sample stands\n"
    "float ssgi_length(float xi)\n"
    "{\n"
    "    return pow(xi, 1.0 / 3.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sum_ao = { __LINE__ + 1, 0,
    "        sum += blocked;\n"
    "    }\n"
    "    return sum / float(SSGI_SAMPLES);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__sum_sh = { __LINE__ + 1, SSGI_GL__E_SH,
    "        vec3 b = blocked * k.xyz;\n"
    "        first += b;\n"
    "        square += b * k.xyz;\n"
    "        mixed += b * k.yzx;\n" };

static const ssgi_gl__chunk ssgi_gl__sum_map = { __LINE__ + 1, SSGI_GL__E_MAP,
    "        vec3 L = ssgi_environment(world * k.xyz);\n"
    "        all += L;\n"
    "        dark += L * blocked;\n" };

static const ssgi_gl__chunk ssgi_gl__sum_angle = { __LINE__ + 1, SSGI_GL__SOLID_ANGLE,
    "        bounce += ssgi_sender.xyz * blocked;\n" };

static const ssgi_gl__chunk ssgi_gl__sum_area = { __LINE__ + 1, SSGI_GL__AREA,
    "        bounce += ssgi_sender.xyz * (blocked * 0.5 / max(k.z, 0.05)); // as often as if directions were uniform, which the area is meant for\n" };

static const ssgi_gl__chunk ssgi_gl__points_end = { __LINE__ + 1, 0,
    "    }\n" };

static const ssgi_gl__chunk ssgi_gl__light_sh = { __LINE__ + 1, SSGI_GL__E_SH,
    "    // the cosine lobe's own moments are exact, so that only what is blocked is noisy; the environment is a quadric\n"
    "    float seen = 1.0 - (square.x + square.y + square.z) / float(SSGI_SAMPLES);\n"
    "    first = vec3(0.0, 0.0, 2.0 / 3.0) - first / float(SSGI_SAMPLES);\n"
    "    square = vec3(0.25, 0.25, 0.5) - square / float(SSGI_SAMPLES);\n"
    "    mixed /= float(-SSGI_SAMPLES);\n"
    "    mat3 turned = basis * mat3(square.x, mixed.x, mixed.z, mixed.x, square.y, mixed.y, mixed.z, mixed.y, square.z);\n"
    "    first = basis * first;\n"
    "    square = turned[0] * basis[0] + turned[1] * basis[1] + turned[2] * basis[2];\n"
    "    mixed = turned[0] * basis[0].yzx + turned[1] * basis[1].yzx + turned[2] * basis[2].yzx;\n"
    "    o_ssgi_light.xyz = max(vec3(ssgi_quadric(0, square, seen, mixed, first), ssgi_quadric(3, square, seen, mixed, first), ssgi_quadric(6, square, seen, mixed, first)), 0.0);\n" };

static const ssgi_gl__chunk ssgi_gl__light_map = { __LINE__ + 1, SSGI_GL__E_MAP,
    "    // the share of the samples' light that is free, of what the open pixel gets: exact where nothing is blocked\n"
    "    o_ssgi_light.xyz = ssgi_open(world[2]) * (1.0 - dark / max(all, 1e-30));\n" };

static const ssgi_gl__chunk ssgi_gl__light_bounce = { __LINE__ + 1, SSGI_GL__SENDERS,
    "    o_ssgi_bounce.xyz = bounce / float(SSGI_SAMPLES);\n" };

static const ssgi_gl__chunk ssgi_gl__points_close = { __LINE__ + 1, 0,
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__attenuation_linear = { __LINE__ + 1, SSGI_GL__LINEAR,
    "// weight of an occluder at a distance [HSAO08 3.5]\n"
    "float ssgi_attenuation(float d)\n"
    "{\n"
    "    return max(1.0 - d / u_ssgi_radius, 0.0);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__attenuation_hard = { __LINE__ + 1, SSGI_GL__HARD,
    "// weight of an occluder at a distance: all within the radius count alike\n"
    "float ssgi_attenuation(float d)\n"
    "{\n"
    "    return d < u_ssgi_radius ? 1.0 : 0.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__normal_ray = { __LINE__ + 1, SSGI_GL__RAYS,
    "// occlusion along one ray from the lifted receiver: the weight of the first blocked step\n"
    "float ssgi_ray(vec3 start, vec3 direction, float xi)\n"
    "{\n"
    "    for (int i = 0; i < SSGI_STEPS; ++i) {\n"
    "        float d = u_ssgi_radius * (float(i) + xi) / float(SSGI_STEPS);\n"
    "        if (ssgi_blocked(start + direction * d) > 0.0) return ssgi_attenuation(d);\n"
    "    }\n"
    "    return 0.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__march = { __LINE__ + 1, 0,
    "// Horizon of one tangent direction t by deflecting a ray toward the surface [HSAO08 fig. 4]: x is H, the sine of its elevation, y the\n"
    "// occlusion below it, the sum of the increments of H^2, each attenuated by the distance at which it was found.\n"
    "vec2 ssgi_horizon(vec3 P, vec3 start, vec3 n, vec3 t, float beta)\n"
    "{\n"
    "    vec3 h = t;\n"
    "    vec2 r = vec2(0.0);\n"
    "    for (int i = 1; i <= SSGI_STEPS; ++i) {\n"
    "        vec3 Q = start + h * (u_ssgi_radius * (float(i) + beta) / float(SSGI_STEPS));\n"
    "        if (Q.z >= 0.0) break;\n"
    "        ivec2 q = ivec2(floor(ssgi_project(Q)));\n"
    "        if (!ssgi_inside(q)) break;\n"
    "        float z = ssgi_depth(q);\n"
    "        vec3 d = ssgi_position(vec2(q) + 0.5, z) - P;\n"
    "        float x = dot(d, t), y = dot(d, n), l = length(d);\n"
    "        if (z < -Q.z && l < u_ssgi_radius && x > 0.0) {\n"
    "            float H = y * inversesqrt(x * x + y * y);\n"
    "            if (H > r.x) {\n"
    "                r = vec2(H, r.y + (H * H - r.x * r.x) * ssgi_attenuation(l));\n"
    "                h = H * n + sqrt(max(1.0 - H * H, 0.0)) * t;\n"
    "            }\n"
    "        }\n"
    "    }\n"
    "    return r;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__above_rays = { __LINE__ + 1, SSGI_GL__RAYS,
    "// occlusion above a horizon H in direction t: equal weights over z^2 in [H^2, 1] [HSAO08 3.3, corrected]\n"
    "float ssgi_above(vec3 start, vec3 n, vec3 t, float H, vec2 xi)\n"
    "{\n"
    "    float sum = 0.0;\n"
    "    for (int k = 0; k < SSGI_NORMAL_RAYS; ++k) {\n"
    "        float zz = H * H + (1.0 - H * H) * (float(k) + xi.x) / float(SSGI_NORMAL_RAYS);\n"
    "        sum += ssgi_ray(start, n * sqrt(zz) + t * sqrt(1.0 - zz), xi.y);\n"
    "    }\n"
    "    return (1.0 - H * H) * sum / float(SSGI_NORMAL_RAYS);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__gather_march_head = { __LINE__ + 1, 0,
    "// occlusion: horizons of SSGI_DIRECTIONS tangent directions [HSAO08 eq. 6]\n"
    "float ssgi_occlusion(ivec2 p, vec3 P, vec3 n, vec2 xi)\n"
    "{\n"
    "    mat3 basis = ssgi_basis(n);\n"
    "    vec3 start = ssgi_lift(P, n);\n"
    "    float sum = 0.0;\n"
    "    for (int i = 0; i < SSGI_DIRECTIONS; ++i) {\n"
    "        float a = 6.28318531 * (float(i) + xi.x) / float(SSGI_DIRECTIONS);\n"
    "        vec3 t = basis[0] * cos(a) + basis[1] * sin(a);\n"
    "        vec2 h = ssgi_horizon(P, start, n, t, xi.y - 0.5);\n"
    "        sum += h.y;\n" };

static const ssgi_gl__chunk ssgi_gl__gather_march_rays = { __LINE__ + 1, SSGI_GL__RAYS,
    "        sum += ssgi_above(start, n, t, h.x, vec2(fract(xi.x * 3.0 + float(i) * 0.61803399), xi.y));\n" };

static const ssgi_gl__chunk ssgi_gl__gather_march_tail = { __LINE__ + 1, 0,
    "    }\n"
    "    return sum / float(SSGI_DIRECTIONS);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__arc = { __LINE__ + 1, 0,
    "// Occlusion of a slice's two sides from the tangent plane up to elevations with cosines c and sines s: the integral of sin x cos(g - x), where\n"
    "// g is the signed angle from the view direction to the projected normal; half its cosine and +-half its sine are given.\n"
    "vec2 ssgi_arc(vec2 c, vec2 s, float cosg, vec2 sing)\n"
    "{\n"
    "    vec2 x = abs(c), e = sqrt(max(1.0 - x, 0.0)) * (1.5707288 + x * (-0.2121144 + x * (0.0742610 - 0.0187293 * x))); // acos, error < 7e-5\n"
    "    return cosg * s * s + sing * (mix(e, 3.14159265 - e, lessThan(c, vec2(0.0))) - s * c);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__screen_perspective = { __LINE__ + 1, SSGI_GL__PERSPECTIVE,
    "// pixels that a small step along t from P covers, per unit of length\n"
    "vec2 ssgi_screen(vec3 P, vec3 t)\n"
    "{\n"
    "    return (t.xy - P.xy * (t.z / P.z)) * (u_ssgi_project.xy / -P.z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__screen_orthographic = { __LINE__ + 1, SSGI_GL__ORTHOGRAPHIC,
    "// pixels that a small step along t from P covers, per unit of length\n"
    "vec2 ssgi_screen(vec3 P, vec3 t)\n"
    "{\n"
    "    return t.xy * u_ssgi_project.xy;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__slices_head = { __LINE__ + 1, 0,
    "// Occlusion: horizons on both sides (.x, .y) of SSGI_DIRECTIONS planes through the view direction. n over the length l of its projection makes\n"
    "// dot(d, n) the height over the tangent plane within the slice: exactly 0 on a plane, wherever texels lie. Each rise of a horizon is attenuated\n"
    "// by the mean distance of the taps that it lies between. Sines of elevations below SSGI_LEVEL count as 0: normals of 10 bits do not know better;\n"
    "// beyond the zenith those below SSGI_OVER do: that is rounding, or a tap that a texel's centre took off the slice.\n"
    "const float SSGI_LEVEL = 0.004, SSGI_OVER = 0.4;\n"
    "float ssgi_occlusion(ivec2 p, vec3 P, vec3 normal, vec2 xi)\n"
    "{\n"
    "    vec2 pixel = vec2(p) + 0.5;\n"
    "    vec3 V = ssgi_toward(P);\n"
    "    mat3 basis = ssgi_basis(V);\n"
    "    float total = 0.0;\n"
    "    for (int i = 0; i < SSGI_DIRECTIONS; ++i) {\n"
    "        float phi = 3.14159265 * (float(i) + xi.x) / float(SSGI_DIRECTIONS);\n"
    "        vec3 slice = basis[0] * cos(phi) + basis[1] * sin(phi);\n"
    "        float a = dot(normal, slice), b = dot(normal, V), l = max(sqrt(a * a + b * b), 1e-4), cosg = b / l, sing = a / l;\n"
    "        vec2 pixels = ssgi_screen(P, slice) * u_ssgi_radius;\n"
    "        vec3 t = slice * cosg - V * sing, n = normal / l;\n"
    "        vec2 low = vec2(1.0), below = vec2(0.0), sum = vec2(0.0), sings = vec2(0.5, -0.5) * sing;\n"
    "        cosg *= 0.5;\n" };

static const ssgi_gl__chunk ssgi_gl__slices_thin = { __LINE__ + 1, SSGI_GL__THIN,
    "        vec3 back = vec3(dot(t, V) * vec2(1.0, -1.0), dot(n, V)) * u_ssgi_thickness; // what is seen reaches so far away from the viewer\n" };

static const ssgi_gl__chunk ssgi_gl__slices_last = { __LINE__ + 1, SSGI_GL__LINEAR,
    "        vec2 last = vec2(0.0);\n" };

static const ssgi_gl__chunk ssgi_gl__slices_loop = { __LINE__ + 1, 0,
    "        for (int k = 0; k < SSGI_STEPS; ++k) {\n"
    "            vec2 u = (float(k) + vec2(xi.y, 1.0 - xi.y)) / float(SSGI_STEPS);\n"
    "            u *= u;\n"
    "            ivec2 q0 = ivec2(floor(pixel + pixels * u.x)), q1 = ivec2(floor(pixel - pixels * u.y));\n"
    "            vec3 d0 = ssgi_position(vec2(q0) + 0.5, ssgi_depth(q0)) - P, d1 = ssgi_position(vec2(q1) + 0.5, ssgi_depth(q1)) - P;\n"
    "            vec2 x = vec2(dot(d0, t), -dot(d1, t)), y = vec2(dot(d0, n), dot(d1, n));\n"
    "            vec2 far = max(sqrt(vec2(dot(d0, d0), dot(d1, d1))), 1e-18), h = min(y / far, 1.0), c = sqrt(1.0 - h * h) * mix(vec2(1.0), vec2(-1.0), lessThan(x, vec2(0.0)));\n"
    "            vec2 above = ssgi_arc(c, h, cosg, sings);\n"
    "            bvec2 rises = bvec2(h.x > (x.x < 0.0 ? SSGI_OVER : SSGI_LEVEL) && c.x < low.x && far.x < u_ssgi_radius && ssgi_inside(q0),\n"
    "                                h.y > (x.y < 0.0 ? SSGI_OVER : SSGI_LEVEL) && c.y < low.y && far.y < u_ssgi_radius && ssgi_inside(q1));\n" };

static const ssgi_gl__chunk ssgi_gl__slices_gap = { __LINE__ + 1, SSGI_GL__THIN,
    "            vec2 xb = x - back.xy, yb = y - back.z, rb = inversesqrt(xb * xb + yb * yb), cb = xb * rb; // light passes between its back and low\n"
    "            below = mix(below, ssgi_arc(cb, yb * rb, cosg, sings), bvec2(rises.x && yb.x > 0.0 && cb.x < low.x, rises.y && yb.y > 0.0 && cb.y < low.y));\n" };

static const ssgi_gl__chunk ssgi_gl__slices_linear = { __LINE__ + 1, SSGI_GL__LINEAR,
    "            sum += mix(vec2(0.0), (above - below) * (1.0 - 0.5 * (far + last) / u_ssgi_radius), rises);\n"
    "            last = min(far, u_ssgi_radius);\n" };

static const ssgi_gl__chunk ssgi_gl__slices_hard = { __LINE__ + 1, SSGI_GL__HARD,
    "            sum += mix(vec2(0.0), above - below, rises);\n" };

static const ssgi_gl__chunk ssgi_gl__slices_tail = { __LINE__ + 1, 0,
    "            low = mix(low, c, rises);\n"
    "            below = mix(below, above, rises);\n"
    "        }\n"
    "        total += l * (sum.x + sum.y);\n"
    "    }\n"
    "    return total / float(SSGI_DIRECTIONS);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__main_full = { __LINE__ + 1, SSGI_GL__FULL,
    "void main()\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - u_ssgi_target;\n"
    "    vec2 xi = ssgi_noise(p);\n" };

static const ssgi_gl__chunk ssgi_gl__main_half = { __LINE__ + 1, SSGI_GL__HALF,
    "void main() // one pixel of every 2x2\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - u_ssgi_target / 2;\n"
    "    vec2 xi = ssgi_noise(p);\n"
    "    p *= 2;\n" };

static const ssgi_gl__chunk ssgi_gl__main_ao = { __LINE__ + 1, 0,
    "    float z = ssgi_depth(p);\n"
    "    o_ssgi_ao = vec2(1.0, SSGI_FAR);\n"
    "    if (z < SSGI_FAR) {\n"
    "        vec3 P = ssgi_position(vec2(p) + 0.5, z);\n"
    "        o_ssgi_ao = vec2(clamp(1.0 - ssgi_occlusion(p, P, ssgi_normal(p, P), xi), 0.0, 1.0), z);\n"
    "    }\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__main_depth = { __LINE__ + 1, SSGI_GL__FIRST,
    "    float z = ssgi_depth(p);\n" };
static const ssgi_gl__chunk ssgi_gl__main_layer = { __LINE__ + 1, SSGI_GL__HIDDEN,
    "    float z = ssgi_layer(p, SSGI_RECEIVER);\n" };
static const ssgi_gl__chunk ssgi_gl__main_light = { __LINE__ + 1, SSGI_GL__E_LIT,
    "    o_ssgi_light = vec4(0.0, 0.0, 0.0, z);\n" };
static const ssgi_gl__chunk ssgi_gl__main_bounce = { __LINE__ + 1, SSGI_GL__SENDERS,
    "    o_ssgi_bounce = vec4(0.0, 0.0, 0.0, z);\n" };
static const ssgi_gl__chunk ssgi_gl__main_ssdo = { __LINE__ + 1, 0,
    "    if (z < SSGI_FAR) {\n"
    "        vec3 P = ssgi_position(vec2(p) + 0.5, z);\n"
    "        ssgi_gather(P, ssgi_normal(p, P), xi);\n"
    "    }\n"
    "}\n" };

/* ==== >>light: environment, lights, senders ======================================================================== */

static const ssgi_gl__chunk ssgi_gl__quadric = { __LINE__ + 1, SSGI_GL__E_SH,
    "// one channel of the environment over moments: xx yy zz, 1, xy yz zx, x y z\n"
    "float ssgi_quadric(int i, vec3 square, float one, vec3 mixed, vec3 first)\n"
    "{\n"
    "    return dot(u_ssgi_environment[i].xyz, square) + u_ssgi_environment[i].w * one + dot(u_ssgi_environment[i + 1].xyz, mixed) + dot(u_ssgi_environment[i + 2].xyz, first);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__environment = { __LINE__ + 1, SSGI_GL__E_MAP,
    "// radiance of the environment about a world-space direction\n"
    "vec3 ssgi_environment(vec3 d)\n"
    "{\n"
    "    ivec2 size = textureSize(t_ssgi_environment, 0);\n"
    "    return texelFetch(t_ssgi_environment, min(ivec2((ssgi_octahedral(d) * 0.5 + 0.5) * vec2(size)), size - 1), 0).xyz;\n"
    "}\n"
    "\n"
    "vec3 ssgi_open_texel(ivec2 p, ivec2 last)\n"
    "{\n"
    "    if (p.x < 0 || p.x > last.x) p = ivec2(clamp(p.x, 0, last.x), last.y - p.y); // over an edge the square goes on mirrored\n"
    "    if (p.y < 0 || p.y > last.y) p = ivec2(last.x - p.x, clamp(p.y, 0, last.y));\n"
    "    return texelFetch(t_ssgi_irradiance, p, 0).xyz;\n"
    "}\n"
    "\n"
    "// irradiance over pi of an open surface with a world-space normal, between four texels\n"
    "vec3 ssgi_open(vec3 n)\n"
    "{\n"
    "    ivec2 last = textureSize(t_ssgi_irradiance, 0) - 1;\n"
    "    vec2 t = (ssgi_octahedral(n) * 0.5 + 0.5) * vec2(last + 1) - 0.5;\n"
    "    ivec2 p = ivec2(floor(t));\n"
    "    t -= vec2(p);\n"
    "    return mix(mix(ssgi_open_texel(p, last), ssgi_open_texel(p + ivec2(1, 0), last), t.x),\n"
    "               mix(ssgi_open_texel(p + ivec2(0, 1), last), ssgi_open_texel(p + 1, last), t.x), t.y);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__segment = { __LINE__ + 1, SSGI_GL__SEGMENTS,
    "// 1 where any point of a segment from the lifted receiver is blocked\n"
    "float ssgi_segment(vec3 start, vec3 along, float xi)\n"
    "{\n"
    "    for (int i = 0; i < SSGI_SAMPLES; ++i)\n"
    "        if (ssgi_blocked(start + along * ((float(i + 1) - xi) / float(SSGI_SAMPLES))) > 0.0) return 1.0;\n"
    "    return 0.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__shadow_map = { __LINE__ + 1, SSGI_GL__MAPS_READ,
    "// 1 where the map of light i shadows P. Its texels are taken to lie below the surface by the bias that keeps a plane from shadowing itself: half a\n"
    "// texel's diagonal times the plane's slope against the map; bias returns that along the ray to the light, -1 where no map sees P [SSDO09 section 5, corrected]\n"
    "float ssgi_shadow(int i, vec3 P, vec3 n, float d, float cosine, float patch_, out float bias)\n"
    "{\n"
    "    vec4 decode = texelFetch(t_ssgi_lights, ivec2(6, i), 0), tile = texelFetch(t_ssgi_lights, ivec2(7, i), 0), axis = texelFetch(t_ssgi_lights, ivec2(5, i), 0), Q = vec4(P, 1.0);\n"
    "    vec3 q = vec3(dot(texelFetch(t_ssgi_lights, ivec2(3, i), 0), Q), dot(texelFetch(t_ssgi_lights, ivec2(4, i), 0), Q), dot(axis, Q));\n"
    "    bool flat_ = decode.w > 0.0;\n"
    "    vec2 t = floor(flat_ ? q.xy : q.xy / q.z);\n"
    "    bias = -1.0;\n"
    "    if (q.z <= 0.0 || t.x < 0.0 || t.y < 0.0 || t.x >= tile.z || t.y >= tile.w) return 0.0;\n"
    "    float across = dot(n, axis.xyz), length_ = flat_ ? 1.0 : d / q.z; // of the ray, per depth\n"
    "    float size = flat_ ? patch_ : patch_ * q.z;\n"
    "    float b = size * 0.70710678 * min(sqrt(max(1.0 - across * across, 0.0)) / (cosine * length_), u_ssgi_steepest);\n"
    "    float s = texelFetch(t_ssgi_shadow, ivec2(tile.xy + t), 0).x, w = decode.x + decode.y * s;\n"
    "    float z = s == decode.z || w <= 1.0 / SSGI_FAR ? SSGI_FAR : flat_ ? w : 1.0 / w;\n"
    "    bias = b * length_;\n"
    "    float slack = 0.02 * size + 3e-7 * abs(decode.y) * (flat_ ? 1.0 : q.z * q.z) - 2e-5 * P.z; // and what depths of the map and of P are rounded by\n"
    "    return q.z - b - slack > z ? 1.0 : 0.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__lights_head = { __LINE__ + 1, 0,
    "void main()\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - u_ssgi_target;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_noise = { __LINE__ + 1, SSGI_GL__SEGMENTS,
    "    vec2 xi = ssgi_noise(p);\n" };
static const ssgi_gl__chunk ssgi_gl__lights_begin = { __LINE__ + 1, 0,
    "    o_ssgi_light = vec4(0.0, 0.0, 0.0, z);\n"
    "    if (z >= SSGI_FAR) return;\n"
    "    vec3 P = ssgi_position(vec2(p) + 0.5, z), n = ssgi_normal(p, P), sum = vec3(0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__lights_lift = { __LINE__ + 1, SSGI_GL__SEGMENTS,
    "    vec3 start = ssgi_lift(P, n);\n" };
static const ssgi_gl__chunk ssgi_gl__lights_loop = { __LINE__ + 1, 0,
    "    for (int i = 0; i < u_ssgi_lights; ++i) {\n"
    "        vec4 at = texelFetch(t_ssgi_lights, ivec2(0, i), 0), colour = texelFetch(t_ssgi_lights, ivec2(1, i), 0), facing = texelFetch(t_ssgi_lights, ivec2(2, i), 0);\n"
    "        vec3 l = at.w > 0.5 ? at.xyz - P : at.xyz;\n"
    "        float dd = max(dot(l, l), 1e-30), d = sqrt(dd);\n"
    "        l /= d;\n"
    "        float cosine = dot(n, l), g = cosine;\n"
    "        if (at.w > 0.5) g /= max(dd, colour.w * colour.w);\n"
    "        if (at.w > 2.5) g *= max(-dot(facing.xyz, l), 0.0);\n"
    "        if (cosine <= 0.0 || g <= 0.0) continue;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_reach = { __LINE__ + 1, SSGI_GL__SEGMENTS,
    "        float reach = at.w > 0.5 ? min(u_ssgi_radius, d) : u_ssgi_radius;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_map = { __LINE__ + 1, SSGI_GL__MAPS_READ,
    "        float bias;\n"
    "        if (ssgi_shadow(i, P, n, d, cosine, facing.w, bias) > 0.0 || (bias < 0.0 && at.w > 1.5 && at.w < 2.5)) continue;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_fill = { __LINE__ + 1, SSGI_GL__MAPS_READ | SSGI_GL__SEGMENTS,
    "        if (bias >= 0.0) reach = min(reach, max(bias, 1.5 * ssgi_footprint(z))); // a segment shorter than a pixel finds nothing\n" };
static const ssgi_gl__chunk ssgi_gl__lights_limit = { __LINE__ + 1, SSGI_GL__REACH,
    "        ssgi_reach = reach;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_segment = { __LINE__ + 1, SSGI_GL__SEGMENTS,
    "        g *= 1.0 - ssgi_segment(start, l * reach, fract(xi.y + 0.61803399 * float(i)));\n" };
static const ssgi_gl__chunk ssgi_gl__lights_tail = { __LINE__ + 1, 0,
    "        sum += colour.xyz * g;\n"
    "    }\n"
    "    o_ssgi_light.xyz = sum * 0.31830989;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_add = { __LINE__ + 1, SSGI_GL__ADD,
    "    o_ssgi_light.xyz += texelFetch(t_ssgi_light, p + u_ssgi_target, 0).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__lights_end = { __LINE__ + 1, 0,
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__senders_head = { __LINE__ + 1, 0,
    "    o_ssgi_sender = uvec2(0u, 0xffffffffu);\n"
    "    if (z >= SSGI_FAR) return;\n"
    "    vec3 sum = vec3(0.0);\n" };
static const ssgi_gl__chunk ssgi_gl__senders_first = { __LINE__ + 1, SSGI_GL__S_LIGHT | SSGI_GL__FIRST,
    "    sum += texelFetch(t_ssgi_albedo, p + u_ssgi_origin, 0).xyz * texelFetch(t_ssgi_light, p + u_ssgi_target, 0).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__senders_hidden = { __LINE__ + 1, SSGI_GL__S_LIGHT | SSGI_GL__HIDDEN,
    "    sum += texelFetch(t_ssgi_albedo, ivec3(p + u_ssgi_origin, SSGI_RECEIVER - 1), 0).xyz * texelFetch(t_ssgi_light, p + u_ssgi_target, 0).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__senders_direct = { __LINE__ + 1, SSGI_GL__S_DIRECT,
    "    sum += texelFetch(t_ssgi_direct, p + u_ssgi_origin, 0).xyz;\n" };
static const ssgi_gl__chunk ssgi_gl__senders_tail = { __LINE__ + 1, 0,
    "    o_ssgi_sender = uvec2(ssgi_pack_radiance(sum), ssgi_pack_place(z, ssgi_normal(p, ssgi_position(vec2(p) + 0.5, z))));\n"
    "}\n" };

/* ==== >>filter ==================================================================================================== */

static const ssgi_gl__chunk ssgi_gl__plane_perspective = { __LINE__ + 1, SSGI_GL__BILATERAL | SSGI_GL__PERSPECTIVE,
    "// dot(k, vec3(o, 1)) * z - dot(n, P): how far the point seen o pixels from P at depth z lies off the plane through P\n"
    "vec3 ssgi_plane(vec3 P, vec3 n)\n"
    "{\n"
    "    return vec3(n.xy * u_ssgi_unproject.xy, dot(n, P) / -P.z);\n"
    "}\n"
    "float ssgi_off_plane(vec3 k, vec2 o, vec3 P, float z)\n"
    "{\n"
    "    return abs((dot(k.xy, o) + k.z) * z + k.z * P.z);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__plane_orthographic = { __LINE__ + 1, SSGI_GL__BILATERAL | SSGI_GL__ORTHOGRAPHIC,
    "// how far the point seen o pixels from P at depth z lies off the plane through P\n"
    "vec3 ssgi_plane(vec3 P, vec3 n)\n"
    "{\n"
    "    return vec3(n.xy * u_ssgi_unproject.xy, n.z);\n"
    "}\n"
    "float ssgi_off_plane(vec3 k, vec2 o, vec3 P, float z)\n"
    "{\n"
    "    return abs(dot(k.xy, o) - k.z * (z + P.z));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__blur_head = { __LINE__ + 1, 0,
    "void main()\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - u_ssgi_target;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_full_grey = { __LINE__ + 1, SSGI_GL__FULL | SSGI_GL__GREY,
    "    vec2 sum = texelFetch(t_ssgi_ao, p + u_ssgi_target, 0).xy;\n"
    "    float z = sum.y;\n"
    "    sum.y = 1.0;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_full_colour = { __LINE__ + 1, SSGI_GL__FULL | SSGI_GL__COLOUR,
    "    vec4 sum = texelFetch(t_ssgi_light, p + u_ssgi_target, 0);\n"
    "    float z = sum.w;\n"
    "    sum.w = 1.0;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_half_grey = { __LINE__ + 1, SSGI_GL__HALF | SSGI_GL__GREY,
    "    vec2 sum = vec2(0.0);\n"
    "    float z = ssgi_depth(p);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_half_colour = { __LINE__ + 1, SSGI_GL__HALF | SSGI_GL__COLOUR,
    "    vec4 sum = vec4(0.0);\n"
    "    float z = ssgi_depth(p);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_centre = { __LINE__ + 1, 0,
    "    vec3 P = ssgi_position(vec2(p) + 0.5, z);\n"
    "    float footprint = ssgi_footprint(z);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_normal = { __LINE__ + 1, SSGI_GL__BILATERAL,
    "    vec3 n = ssgi_normal(p, P), plane = ssgi_plane(P, n);\n"
    "    float near = 1.0 / (0.05 * u_ssgi_radius + footprint);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_loop = { __LINE__ + 1, 0,
    "    for (int y = -SSGI_FILTER_RADIUS; y <= SSGI_FILTER_RADIUS; ++y)\n"
    "        for (int x = -SSGI_FILTER_RADIUS; x <= SSGI_FILTER_RADIUS; ++x) {\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tap_full = { __LINE__ + 1, SSGI_GL__FULL,
    "            if (x == 0 && y == 0) continue;\n"
    "            ivec2 o = ivec2(x, y), q = p + o, at = q + u_ssgi_target;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tap_half = { __LINE__ + 1, SSGI_GL__HALF,
    "            ivec2 h = p / 2 + ivec2(x, y), q = h * 2, o = q - p, at = h + u_ssgi_target / 2;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tap_grey = { __LINE__ + 1, SSGI_GL__GREY,
    "            vec2 s = texelFetch(t_ssgi_ao, at, 0).xy;\n"
    "            float d = s.y;\n"
    "            s.y = 1.0;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tap_colour = { __LINE__ + 1, SSGI_GL__COLOUR,
    "            vec4 s = texelFetch(t_ssgi_light, at, 0);\n"
    "            float d = s.w;\n"
    "            s.w = 1.0;\n" };

static const ssgi_gl__chunk ssgi_gl__weight_gaussian = { __LINE__ + 1, SSGI_GL__GAUSSIAN,
    "            // Gaussian over its depth difference, softened by a pixel's footprint [HSAO08 4.1.3]\n"
    "            float w = exp(-0.5 * float(x * x + y * y) / (0.25 * float(SSGI_FILTER_RADIUS * SSGI_FILTER_RADIUS) + 0.25)) * footprint / (footprint + abs(d - z));\n" };

static const ssgi_gl__chunk ssgi_gl__weight_bilateral = { __LINE__ + 1, SSGI_GL__BILATERAL,
    "            // nearness to the tangent plane of the centre\n"
    "            float off = ssgi_off_plane(plane, vec2(o), P, d) * near;\n" };

static const ssgi_gl__chunk ssgi_gl__weight_box = { __LINE__ + 1, SSGI_GL__BILATERAL | SSGI_GL__FULL,
    "            float w = max(1.0 - off, 0.0); // a box that covers one tile of noise\n"
    "            if (SSGI_FILTER_RADIUS > 1 && abs(x) == SSGI_FILTER_RADIUS) w *= 0.5;\n"
    "            if (SSGI_FILTER_RADIUS > 1 && abs(y) == SSGI_FILTER_RADIUS) w *= 0.5;\n" };

static const ssgi_gl__chunk ssgi_gl__weight_tent = { __LINE__ + 1, SSGI_GL__BILATERAL | SSGI_GL__HALF,
    "            vec2 tent = float(2 * SSGI_FILTER_RADIUS + 2) - abs(vec2(o));\n"
    "            float w = tent.x * tent.y * max(1.0 - off, 1e-3 / (1.0 + off)); // never 0: where nothing fits, the nearest\n" };

static const ssgi_gl__chunk ssgi_gl__weight_normals = { __LINE__ + 1, SSGI_GL__F_NORMALS,
    "            w *= max(dot(n, ssgi_normal(q, ssgi_position(vec2(q) + 0.5, d))), 1e-3);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tail = { __LINE__ + 1, 0,
    "            if (ssgi_inside(q) && d < SSGI_FAR) sum += s * w;\n"
    "        }\n" };

static const ssgi_gl__chunk ssgi_gl__blur_grey = { __LINE__ + 1, SSGI_GL__GREY,
    "    o_ssgi_ao = z < SSGI_FAR && sum.y > 0.0 ? sum.x / sum.y : 1.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__blur_colour = { __LINE__ + 1, SSGI_GL__COLOUR,
    "    o_ssgi_light = vec4(z < SSGI_FAR && sum.w > 0.0 ? sum.xyz / sum.w : vec3(0.0), z);\n"
    "}\n" };

/* ==== >>passes: what each is made of ============================================================================== */

/* In the order of the text; what a variant does not need falls out by its bits. */
#define SSGI_GL__PROJECTIONS(name) &ssgi_gl__##name##_perspective, &ssgi_gl__##name##_orthographic
#define SSGI_GL__FETCH  &ssgi_gl__far, &ssgi_gl__inside, SSGI_GL__PROJECTIONS(decode), &ssgi_gl__depth_window, &ssgi_gl__depth_linear, &ssgi_gl__depth_custom, \
                        &ssgi_gl__layer_window, &ssgi_gl__layer_linear, &ssgi_gl__hidden_window, &ssgi_gl__hidden_linear, &ssgi_gl__layer_custom, SSGI_GL__PROJECTIONS(position), SSGI_GL__PROJECTIONS(toward), &ssgi_gl__unit, \
                        &ssgi_gl__texel_first, &ssgi_gl__texel_hidden, &ssgi_gl__raw_signed, &ssgi_gl__raw_unsigned, &ssgi_gl__raw_octahedral, &ssgi_gl__raw_custom, \
                        &ssgi_gl__normal_view, &ssgi_gl__normal_world, &ssgi_gl__normal_from_depth
#define SSGI_GL__GATHER &ssgi_gl__noise_tile4, &ssgi_gl__noise_gradient, &ssgi_gl__noise_texture, &ssgi_gl__basis
#define SSGI_GL__TEST   SSGI_GL__PROJECTIONS(project), SSGI_GL__PROJECTIONS(footprint), &ssgi_gl__lift, &ssgi_gl__back_fixed, &ssgi_gl__back_reach, &ssgi_gl__look_from, &ssgi_gl__look_normal, &ssgi_gl__look_head, \
                        &ssgi_gl__look_views, &ssgi_gl__look_tail, &ssgi_gl__unpack, &ssgi_gl__unpack_depth, &ssgi_gl__unpack_normal, &ssgi_gl__sent_head, &ssgi_gl__sent_views, &ssgi_gl__sent_main, \
                        &ssgi_gl__sent_both, &ssgi_gl__sent_facing, &ssgi_gl__sent_area, &ssgi_gl__sent_area_both, &ssgi_gl__sent_patch, &ssgi_gl__sent_disc, &ssgi_gl__faded, \
                        &ssgi_gl__shallow_head, &ssgi_gl__shallow_depth, &ssgi_gl__shallow_send, &ssgi_gl__shallow_test, &ssgi_gl__shallow_thin, &ssgi_gl__shallow_whole, &ssgi_gl__shallow_fade, \
                        &ssgi_gl__view_surface, &ssgi_gl__surface_head, &ssgi_gl__surface_views, &ssgi_gl__surface_layers, &ssgi_gl__surface_one, &ssgi_gl__offer, \
                        &ssgi_gl__matter_head, &ssgi_gl__matter_solid, &ssgi_gl__matter_thin, &ssgi_gl__matter_loop, &ssgi_gl__matter_depths, &ssgi_gl__matter_held, &ssgi_gl__matter_back, &ssgi_gl__matter_inside, \
                        &ssgi_gl__matter_offer, &ssgi_gl__matter_fade, &ssgi_gl__matter_whole, &ssgi_gl__matter_tail, &ssgi_gl__deep_head, &ssgi_gl__deep_reset, \
                        &ssgi_gl__deep_main, &ssgi_gl__deep_views, &ssgi_gl__deep_tail
#define SSGI_GL__LOOP   &ssgi_gl__points_turn, &ssgi_gl__points_pick, &ssgi_gl__points_sh, &ssgi_gl__points_map, &ssgi_gl__points_bounce, &ssgi_gl__points_loop, \
                        &ssgi_gl__points_constant, &ssgi_gl__points_fetched, &ssgi_gl__points_single, &ssgi_gl__points_several
#define SSGI_GL__LENGTH &ssgi_gl__kernel, &ssgi_gl__length_uniform, &ssgi_gl__length_square, &ssgi_gl__length_cube
#define SSGI_GL__READS  &ssgi_gl__unproject, &ssgi_gl__decode_row, &ssgi_gl__origin, &ssgi_gl__size, &ssgi_gl__target
#define SSGI_GL__MAPS   &ssgi_gl__depth_tex, &ssgi_gl__layers_tex, &ssgi_gl__normal_tex, &ssgi_gl__normals_tex, &ssgi_gl__noise_tex
#define SSGI_GL__DEEP_C &ssgi_gl__c_layers, &ssgi_gl__c_views, &ssgi_gl__c_view_layers
#define SSGI_GL__CAMERAS &ssgi_gl__view_to, &ssgi_gl__view_from, &ssgi_gl__view_decode, &ssgi_gl__view_size

static const ssgi_gl__chunk *const ssgi_gl__vertex_chunks[] = { &ssgi_gl__triangle, NULL };
static const ssgi_gl__row *const ssgi_gl__vertex_rows[] = { NULL };

static const ssgi_gl__chunk *const ssgi_gl__ssao_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__TEST, SSGI_GL__LENGTH, &ssgi_gl__points_ao, &ssgi_gl__points_from, SSGI_GL__LOOP, &ssgi_gl__sum_ao, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_ao, NULL };
static const ssgi_gl__row *const ssgi_gl__ssao_rows[] = {
    &ssgi_gl__c_samples, &ssgi_gl__c_several, SSGI_GL__DEEP_C, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__offset, &ssgi_gl__thickness, &ssgi_gl__phase,
    &ssgi_gl__fade_row, &ssgi_gl__rotation, SSGI_GL__CAMERAS, SSGI_GL__MAPS, &ssgi_gl__views_tex, &ssgi_gl__kernel_tex, &ssgi_gl__ao_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__slices_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__PROJECTIONS(screen), &ssgi_gl__arc, &ssgi_gl__slices_head, &ssgi_gl__slices_thin, &ssgi_gl__slices_last, &ssgi_gl__slices_loop,
    &ssgi_gl__slices_gap, &ssgi_gl__slices_linear, &ssgi_gl__slices_hard, &ssgi_gl__slices_tail, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_ao, NULL };
static const ssgi_gl__row *const ssgi_gl__slices_rows[] = {
    &ssgi_gl__c_directions, &ssgi_gl__c_steps, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__thickness, &ssgi_gl__phase, &ssgi_gl__rotation, SSGI_GL__MAPS, &ssgi_gl__ao_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__march_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__TEST, &ssgi_gl__attenuation_linear, &ssgi_gl__attenuation_hard, &ssgi_gl__march, &ssgi_gl__normal_ray, &ssgi_gl__above_rays,
    &ssgi_gl__gather_march_head, &ssgi_gl__gather_march_rays, &ssgi_gl__gather_march_tail, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_ao, NULL };
static const ssgi_gl__row *const ssgi_gl__march_rows[] = {
    &ssgi_gl__c_directions, &ssgi_gl__c_steps, &ssgi_gl__c_rays, SSGI_GL__DEEP_C, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__offset, &ssgi_gl__thickness,
    &ssgi_gl__phase, &ssgi_gl__rotation, SSGI_GL__CAMERAS, SSGI_GL__MAPS, &ssgi_gl__views_tex, &ssgi_gl__ao_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__ssdo_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__TEST, &ssgi_gl__quadric, &ssgi_gl__octahedron, &ssgi_gl__environment, SSGI_GL__LENGTH, &ssgi_gl__points_ssdo, &ssgi_gl__points_from, &ssgi_gl__points_normal,
    SSGI_GL__LOOP, &ssgi_gl__sum_sh, &ssgi_gl__sum_map, &ssgi_gl__sum_angle, &ssgi_gl__sum_area, &ssgi_gl__points_end, &ssgi_gl__light_sh, &ssgi_gl__light_map, &ssgi_gl__light_bounce,
    &ssgi_gl__points_close, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_depth, &ssgi_gl__main_layer, &ssgi_gl__main_light, &ssgi_gl__main_bounce, &ssgi_gl__main_ssdo, NULL };
static const ssgi_gl__row *const ssgi_gl__ssdo_rows[] = {
    &ssgi_gl__c_samples, &ssgi_gl__c_several, SSGI_GL__DEEP_C, &ssgi_gl__c_receiver, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__offset, &ssgi_gl__thickness,
    &ssgi_gl__phase, &ssgi_gl__fade_row, &ssgi_gl__nearest, &ssgi_gl__gain, &ssgi_gl__rotation, &ssgi_gl__quadric_row, SSGI_GL__CAMERAS, SSGI_GL__MAPS, &ssgi_gl__views_tex, &ssgi_gl__senders_tex, &ssgi_gl__view_senders,
    &ssgi_gl__kernel_tex, &ssgi_gl__map_tex, &ssgi_gl__open_tex, &ssgi_gl__light_out, &ssgi_gl__bounce_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__lights_chunks[] = {
    SSGI_GL__FETCH, &ssgi_gl__noise_tile4, &ssgi_gl__noise_gradient, &ssgi_gl__noise_texture, SSGI_GL__TEST, &ssgi_gl__segment, &ssgi_gl__shadow_map, &ssgi_gl__lights_head, &ssgi_gl__lights_noise, &ssgi_gl__main_depth,
    &ssgi_gl__main_layer, &ssgi_gl__lights_begin, &ssgi_gl__lights_lift, &ssgi_gl__lights_loop, &ssgi_gl__lights_reach, &ssgi_gl__lights_map, &ssgi_gl__lights_fill,
    &ssgi_gl__lights_limit, &ssgi_gl__lights_segment, &ssgi_gl__lights_tail, &ssgi_gl__lights_add, &ssgi_gl__lights_end, NULL };
static const ssgi_gl__row *const ssgi_gl__lights_rows[] = {
    &ssgi_gl__c_points, SSGI_GL__DEEP_C, &ssgi_gl__c_receiver, &ssgi_gl__p_project, SSGI_GL__READS, &ssgi_gl__p_radius, &ssgi_gl__p_offset, &ssgi_gl__thickness, &ssgi_gl__p_phase,
    &ssgi_gl__steepest, &ssgi_gl__lights_row, &ssgi_gl__rotation, SSGI_GL__CAMERAS, SSGI_GL__MAPS, &ssgi_gl__views_tex, &ssgi_gl__lights_tex, &ssgi_gl__shadow_tex, &ssgi_gl__added_tex, &ssgi_gl__lights_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__senders_chunks[] = {
    SSGI_GL__FETCH, &ssgi_gl__octahedron, &ssgi_gl__pack, &ssgi_gl__lights_head, &ssgi_gl__main_depth, &ssgi_gl__main_layer, &ssgi_gl__senders_head, &ssgi_gl__senders_first,
    &ssgi_gl__senders_hidden, &ssgi_gl__senders_direct, &ssgi_gl__senders_tail, NULL };
static const ssgi_gl__row *const ssgi_gl__senders_rows[] = {
    &ssgi_gl__c_receiver, SSGI_GL__READS, &ssgi_gl__rotation, SSGI_GL__MAPS, &ssgi_gl__albedo_tex, &ssgi_gl__albedos_tex, &ssgi_gl__s_light_tex, &ssgi_gl__direct_tex, &ssgi_gl__sender_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__blur_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__PROJECTIONS(footprint), SSGI_GL__PROJECTIONS(plane), &ssgi_gl__blur_head, &ssgi_gl__blur_full_grey, &ssgi_gl__blur_full_colour, &ssgi_gl__blur_half_grey,
    &ssgi_gl__blur_half_colour, &ssgi_gl__blur_centre, &ssgi_gl__blur_normal, &ssgi_gl__blur_loop, &ssgi_gl__blur_tap_full, &ssgi_gl__blur_tap_half, &ssgi_gl__blur_tap_grey,
    &ssgi_gl__blur_tap_colour, &ssgi_gl__weight_gaussian, &ssgi_gl__weight_bilateral, &ssgi_gl__weight_box, &ssgi_gl__weight_tent, &ssgi_gl__weight_normals, &ssgi_gl__blur_tail,
    &ssgi_gl__blur_grey, &ssgi_gl__blur_colour, NULL };
static const ssgi_gl__row *const ssgi_gl__blur_rows[] = {
    &ssgi_gl__c_filter, SSGI_GL__READS, &ssgi_gl__near_radius, &ssgi_gl__rotation, SSGI_GL__MAPS, &ssgi_gl__ao_tex, &ssgi_gl__light_tex, &ssgi_gl__blurred_out, &ssgi_gl__colour_out, NULL };

typedef struct ssgi_gl__pass {
    const char *name;
    int pass, search;                       /* the desc that it is for; search -1: any */
    const ssgi_gl__chunk *const *chunks[SSGI_GL_STAGES];
    const ssgi_gl__row *const *rows[SSGI_GL_STAGES];
} ssgi_gl__pass;

static const ssgi_gl__pass ssgi_gl__passes[] = {
    { "ssao", SSGI_GL_SSAO, -1,             { ssgi_gl__vertex_chunks, ssgi_gl__ssao_chunks },   { ssgi_gl__vertex_rows, ssgi_gl__ssao_rows } },
    { "hsao", SSGI_GL_HSAO, SSGI_GL_SLICES, { ssgi_gl__vertex_chunks, ssgi_gl__slices_chunks }, { ssgi_gl__vertex_rows, ssgi_gl__slices_rows } },
    { "hsao", SSGI_GL_HSAO, SSGI_GL_MARCH,  { ssgi_gl__vertex_chunks, ssgi_gl__march_chunks },  { ssgi_gl__vertex_rows, ssgi_gl__march_rows } },
    { "ssdo", SSGI_GL_SSDO, -1,             { ssgi_gl__vertex_chunks, ssgi_gl__ssdo_chunks },   { ssgi_gl__vertex_rows, ssgi_gl__ssdo_rows } },
    { "lights", SSGI_GL_LIGHTS, -1,         { ssgi_gl__vertex_chunks, ssgi_gl__lights_chunks }, { ssgi_gl__vertex_rows, ssgi_gl__lights_rows } },
    { "senders", SSGI_GL_SENDERS, -1,       { ssgi_gl__vertex_chunks, ssgi_gl__senders_chunks }, { ssgi_gl__vertex_rows, ssgi_gl__senders_rows } },
    { "blur", SSGI_GL_BLUR, -1,             { ssgi_gl__vertex_chunks, ssgi_gl__blur_chunks },   { ssgi_gl__vertex_rows, ssgi_gl__blur_rows } }
};
enum { SSGI_GL__ROWS = (int)(sizeof ssgi_gl__passes / sizeof ssgi_gl__passes[0]) };

static const ssgi_gl__pass *ssgi_gl__find(const ssgi_gl_desc *d)
{
    int i;
    for (i = 0; i < SSGI_GL__ROWS; ++i)
        if (ssgi_gl__passes[i].pass == d->pass && (ssgi_gl__passes[i].search < 0 || ssgi_gl__passes[i].search == d->search)) return &ssgi_gl__passes[i];
    return NULL;
}

/* ==== >>desc (implementation) ===================================================================================== */

static ssgi_result ssgi_gl__bad(const char **why, const char *sentence)
{
    if (why) *why = sentence;
    return SSGI_BAD_ARGUMENT;
}

typedef struct ssgi_gl__field { size_t offset; int most; const char *sentence; } ssgi_gl__field;

/* Every int of ssgi_gl_desc, in order: 0 .. most. */
#define SSGI_GL__F(field, most, text) { offsetof(ssgi_gl_desc, field), most, "desc." #field ": must be " text }
static const ssgi_gl__field ssgi_gl__fields[] = {
    SSGI_GL__F(pass, SSGI_GL_PASSES - 1, "a pass, SSGI_GL_SSAO .."),
    SSGI_GL__F(dialect, SSGI_GL_DIALECTS - 1, "a dialect, SSGI_GL_330 .."),
    SSGI_GL__F(orthographic, 1, "0 or 1"),
    SSGI_GL__F(depth, SSGI_GL_DEPTH_CUSTOM, "SSGI_GL_DEPTH_WINDOW, _LINEAR or _CUSTOM"),
    SSGI_GL__F(normal, SSGI_GL_NORMAL_CUSTOM, "SSGI_GL_NORMAL_SIGNED, _UNSIGNED, _OCTAHEDRAL, _FROM_DEPTH or _CUSTOM"),
    SSGI_GL__F(world_normals, 1, "0 or 1"),
    SSGI_GL__F(noise, SSGI_GL_NOISE_TEXTURE, "SSGI_GL_NOISE_GRADIENT, _TILE4 or _TEXTURE"),
    SSGI_GL__F(samples, 64, "0..64"),
    SSGI_GL__F(search, SSGI_GL_MARCH, "SSGI_GL_SLICES or SSGI_GL_MARCH"),
    SSGI_GL__F(directions, 32, "0..32"),
    SSGI_GL__F(steps, 64, "0..64"),
    SSGI_GL__F(normal_rays, 8, "0..8"),
    SSGI_GL__F(hard, 1, "0 or 1"),
    SSGI_GL__F(thin, 1, "0 or 1"),
    SSGI_GL__F(falloff, SSGI_GL_FALLOFF_CUBE, "SSGI_GL_FALLOFF_LINEAR, _SQUARE or _CUBE"),
    SSGI_GL__F(kernel, 1, "0 or 1"),
    SSGI_GL__F(fade, 1, "0 or 1"),
    SSGI_GL__F(layers, 8, "0..8"),
    SSGI_GL__F(views, 4, "0..4"),
    SSGI_GL__F(view_layers, 8, "0..8"),
    SSGI_GL__F(receiver, 7, "0..7"),
    SSGI_GL__F(environment, SSGI_GL_ENVIRONMENT_MAP, "SSGI_GL_ENVIRONMENT_NONE, _SH or _MAP"),
    SSGI_GL__F(bounce, SSGI_GL_BOUNCE_DISC, "SSGI_GL_BOUNCE_NONE, _SOLID_ANGLE, _PATCH or _DISC"),
    SSGI_GL__F(two_sided, 1, "0 or 1"),
    SSGI_GL__F(shadow, SSGI_GL_SHADOW_NONE, "SSGI_GL_SHADOW_SEGMENT, _MAP, _FILL or _NONE"),
    SSGI_GL__F(accumulate, 1, "0 or 1"),
    SSGI_GL__F(radiance, SSGI_GL_RADIANCE_BOTH, "SSGI_GL_RADIANCE_LIGHT, _DIRECT or _BOTH"),
    SSGI_GL__F(half, 1, "0 or 1"),
    SSGI_GL__F(colour, 1, "0 or 1"),
    SSGI_GL__F(filter, SSGI_GL_GAUSSIAN, "SSGI_GL_BILATERAL or SSGI_GL_GAUSSIAN"),
    SSGI_GL__F(filter_radius, 4, "0..4"),
    SSGI_GL__F(filter_normals, 1, "0 or 1"),
    SSGI_GL__F(lines, 1, "0 or 1")
};

static int ssgi_gl__get(const ssgi_gl_desc *d, size_t offset)
{
    int value;
    memcpy(&value, (const char *)d + offset, sizeof value);
    return value;
}

SSGI_DEF ssgi_result ssgi_gl_check(const ssgi_gl_desc *desc, const char **why)
{
    size_t i;
    if (!desc) return ssgi_gl__bad(why, "desc: must not be NULL");
    for (i = 0; i < sizeof ssgi_gl__fields / sizeof ssgi_gl__fields[0]; ++i) {
        int value = ssgi_gl__get(desc, ssgi_gl__fields[i].offset);
        if (value < 0 || value > ssgi_gl__fields[i].most) return ssgi_gl__bad(why, ssgi_gl__fields[i].sentence);
    }
    if (desc->normal_rays && desc->pass == SSGI_GL_HSAO && desc->search == SSGI_GL_SLICES)
        return ssgi_gl__bad(why, "desc.normal_rays: slices see what is above the horizon themselves; only SSGI_GL_MARCH has normal rays");
    if (desc->world_normals && desc->normal == SSGI_GL_NORMAL_FROM_DEPTH)
        return ssgi_gl__bad(why, "desc.world_normals: normals from depth are in view space");
    if (desc->half && desc->pass == SSGI_GL_BLUR && desc->filter == SSGI_GL_GAUSSIAN)
        return ssgi_gl__bad(why, "desc.filter: only SSGI_GL_BILATERAL brings half size to full");
    if (desc->pass == SSGI_GL_SSDO && desc->environment == SSGI_GL_ENVIRONMENT_NONE && desc->bounce == SSGI_GL_BOUNCE_NONE)
        return ssgi_gl__bad(why, "desc.environment: ssdo needs an environment, a bounce or both");
    if (desc->receiver && desc->receiver >= desc->layers)
        return ssgi_gl__bad(why, "desc.receiver: must be below desc.layers");
    if (desc->receiver && desc->normal == SSGI_GL_NORMAL_FROM_DEPTH)
        return ssgi_gl__bad(why, "desc.receiver: hidden layers need their normals");
    if (!desc->fetch && (desc->depth == SSGI_GL_DEPTH_CUSTOM || desc->normal == SSGI_GL_NORMAL_CUSTOM))
        return ssgi_gl__bad(why, "desc.fetch: must hold ssgi_custom_depth or ssgi_custom_normal when depth or normal is CUSTOM");
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_preset(ssgi_gl_desc *desc, int preset, const char **why)
{
    static const struct counts { unsigned char half, samples, directions, steps, rays, thin; } table[5][3] = {    /* FAST, BALANCED, BEST */
        { { 0, 8, 0, 0, 0, 1 }, { 0, 16, 0, 0, 0, 1 }, { 0, 32, 0, 0, 0, 1 } },      /* ssao */
        { { 1, 0, 1, 3, 0, 0 }, { 1, 0, 2, 6, 0, 0 }, { 0, 0, 3, 8, 0, 0 } },        /* slices */
        { { 0, 0, 4, 6, 0, 1 }, { 0, 0, 6, 9, 1, 1 }, { 0, 0, 8, 18, 2, 1 } },       /* march: rays past a solid foreground would all end on it */
        { { 1, 8, 0, 0, 0, 1 }, { 0, 16, 0, 0, 0, 1 }, { 0, 32, 0, 0, 0, 1 } },      /* ssdo */
        { { 0, 4, 0, 0, 0, 1 }, { 0, 8, 0, 0, 0, 1 }, { 0, 16, 0, 0, 0, 1 } } };     /* lights */
    const struct counts *c;
    ssgi_result r = ssgi_gl_check(desc, why);
    if (r != SSGI_OK) return r;
    if (preset < SSGI_GL_FAST || preset > SSGI_GL_BEST) return ssgi_gl__bad(why, "preset: must be SSGI_GL_FAST, _BALANCED or _BEST");
    c = &table[desc->pass == SSGI_GL_SSAO ? 0 : desc->pass == SSGI_GL_SSDO ? 3 : desc->pass == SSGI_GL_LIGHTS ? 4 : desc->search == SSGI_GL_SLICES ? 1 : 2][preset];
    desc->half = c->half;
    if (c->samples) {
        desc->samples = c->samples;
    } else {
        desc->directions = c->directions;
        desc->steps = c->steps;
        desc->normal_rays = c->rays;
    }
    desc->thin = c->thin;
    desc->filter = SSGI_GL_BILATERAL;
    desc->filter_radius = 1;
    desc->noise = SSGI_GL_NOISE_GRADIENT;
    return SSGI_OK;
}

/* The desc with its defaults in place. */
static ssgi_gl_desc ssgi_gl__resolve(const ssgi_gl_desc *desc)
{
    ssgi_gl_desc d = *desc;
    if (!d.samples) d.samples = d.pass == SSGI_GL_LIGHTS ? 8 : 16;
    if (!d.directions) d.directions = d.search == SSGI_GL_MARCH ? 6 : 1;
    if (!d.steps) d.steps = d.pass == SSGI_GL_HSAO ? 6 : 1;
    if (!d.filter_radius) d.filter_radius = d.filter == SSGI_GL_GAUSSIAN ? 2 : 1;
    if (!d.layers) d.layers = 1;
    if (!d.view_layers) d.view_layers = 1;
    return d;
}

static uint64_t ssgi_gl__features(const ssgi_gl_desc *d)
{
    static const uint64_t normal_kind[] = { SSGI_GL__N_SIGNED | SSGI_GL__N_TEXTURE, SSGI_GL__N_UNSIGNED | SSGI_GL__N_TEXTURE, SSGI_GL__N_OCTA | SSGI_GL__N_TEXTURE,
                                            SSGI_GL__N_DEPTH | SSGI_GL__TOWARD, SSGI_GL__N_CUSTOM };
    static const uint64_t noise_kind[] = { SSGI_GL__NOISE_GRADIENT, SSGI_GL__NOISE_TILE4, SSGI_GL__NOISE_TEXTURE };
    static const uint64_t falloff_kind[] = { SSGI_GL__UNIFORM, SSGI_GL__SQUARE, SSGI_GL__CUBE };
    static const uint64_t bounce_kind[] = { 0, SSGI_GL__SENDERS | SSGI_GL__SOLID_ANGLE, SSGI_GL__SENDERS | SSGI_GL__AREA | SSGI_GL__PATCH, SSGI_GL__SENDERS | SSGI_GL__AREA | SSGI_GL__DISC };
    static const uint64_t light_kind[] = { 0, SSGI_GL__E_LIT | SSGI_GL__E_SH, SSGI_GL__E_LIT | SSGI_GL__E_MAP };
    static const uint64_t shadow_kind[] = { SSGI_GL__SEGMENTS | SSGI_GL__BLOCKED, SSGI_GL__MAPS_READ, SSGI_GL__MAPS_READ | SSGI_GL__SEGMENTS | SSGI_GL__BLOCKED, 0 };
    static const uint64_t radiance_kind[] = { SSGI_GL__S_LIGHT, SSGI_GL__S_DIRECT, SSGI_GL__S_LIGHT | SSGI_GL__S_DIRECT };
    const int blur = d->pass == SSGI_GL_BLUR, hsao = d->pass == SSGI_GL_HSAO, slices = hsao && d->search == SSGI_GL_SLICES, points = d->pass == SSGI_GL_SSAO || d->pass == SSGI_GL_SSDO;
    const int sized = blur || hsao || points, hidden = d->receiver && (d->pass == SSGI_GL_SSDO || d->pass == SSGI_GL_LIGHTS || d->pass == SSGI_GL_SENDERS);
    const int normals = !blur || d->filter == SSGI_GL_BILATERAL, depth = !blur || d->half || (normals && d->normal == SSGI_GL_NORMAL_FROM_DEPTH);
    uint64_t f = d->orthographic ? SSGI_GL__ORTHOGRAPHIC : SSGI_GL__PERSPECTIVE;
    f |= hidden ? SSGI_GL__HIDDEN : SSGI_GL__FIRST;
    if (sized) f |= d->half ? SSGI_GL__HALF : SSGI_GL__FULL;
    if (depth || normals) f |= SSGI_GL__GBUFFER;
    if (depth) {
        f |= d->depth == SSGI_GL_DEPTH_WINDOW ? SSGI_GL__D_WINDOW : d->depth == SSGI_GL_DEPTH_LINEAR ? SSGI_GL__D_LINEAR : SSGI_GL__D_CUSTOM;
        if (d->depth != SSGI_GL_DEPTH_CUSTOM) f |= SSGI_GL__D_TEXTURE;
    }
    if (normals) {
        f |= SSGI_GL__NORMALS | normal_kind[d->normal];
        if (d->normal != SSGI_GL_NORMAL_FROM_DEPTH) f |= d->world_normals ? SSGI_GL__N_WORLD | SSGI_GL__WORLD : SSGI_GL__N_VIEW;
    }
    switch (d->pass) {
    case SSGI_GL_SSAO: f |= SSGI_GL__BLOCKED; break;
    case SSGI_GL_HSAO:
        f |= d->hard ? SSGI_GL__HARD : SSGI_GL__LINEAR;
        if (slices) f |= SSGI_GL__TOWARD | (d->thin ? SSGI_GL__THIN : SSGI_GL__SOLID);
        else if (d->normal_rays) f |= SSGI_GL__RAYS | SSGI_GL__BLOCKED;
        break;
    case SSGI_GL_SSDO:
        f |= SSGI_GL__BLOCKED | bounce_kind[d->bounce] | light_kind[d->environment];
        if (d->environment == SSGI_GL_ENVIRONMENT_MAP) f |= SSGI_GL__WORLD;
        if (d->bounce) f |= d->two_sided ? SSGI_GL__TWO_SIDED : SSGI_GL__ONE_SIDED;
        if ((f & SSGI_GL__ONE_SIDED) || (f & SSGI_GL__AREA)) f |= SSGI_GL__NORMALS_SENT;
        break;
    case SSGI_GL_LIGHTS:
        f |= shadow_kind[d->shadow];
        if (d->accumulate) f |= SSGI_GL__ADD;
        break;
    case SSGI_GL_SENDERS: f |= radiance_kind[d->radiance]; break;
    default:
        f |= (d->filter == SSGI_GL_GAUSSIAN ? SSGI_GL__GAUSSIAN : SSGI_GL__BILATERAL) | (d->colour ? SSGI_GL__COLOUR : SSGI_GL__GREY);
        if (d->filter == SSGI_GL_BILATERAL && d->filter_normals) f |= SSGI_GL__F_NORMALS;
    }
    if (blur || (hsao && !slices) || (f & SSGI_GL__BLOCKED)) f |= SSGI_GL__PROJECT;
    if (d->pass == SSGI_GL_SENDERS || (d->pass == SSGI_GL_SSDO && d->environment == SSGI_GL_ENVIRONMENT_MAP)) f |= SSGI_GL__OCTAHEDRON;
    if (points) {
        f |= falloff_kind[d->falloff] | (d->steps > 1 ? SSGI_GL__SEVERAL : SSGI_GL__SINGLE) | (d->kernel ? SSGI_GL__K_TEXTURE : SSGI_GL__K_TEXT);
        if (d->fade) f |= SSGI_GL__FADE;
    }
    if (hsao || (f & SSGI_GL__BLOCKED)) f |= noise_kind[d->noise];
    if (f & SSGI_GL__BLOCKED) {
        f |= d->thin ? SSGI_GL__THIN | (d->pass == SSGI_GL_LIGHTS ? SSGI_GL__REACH : SSGI_GL__FIXED) : SSGI_GL__SOLID;
        if (d->views) f |= SSGI_GL__VIEWS;
        if (f & (SSGI_GL__FADE | SSGI_GL__SENDERS)) f |= SSGI_GL__LOOK;
        if (!(f & SSGI_GL__FADE)) f |= SSGI_GL__NO_FADE;
        f |= d->layers > 1 || d->views ? SSGI_GL__DEEP : SSGI_GL__SHALLOW;
    }
    if ((f & SSGI_GL__BLOCKED) && !(f & SSGI_GL__SENDERS)) f |= SSGI_GL__DEPTHS;
    if ((f & (SSGI_GL__FADE | SSGI_GL__NORMALS_SENT)) || ((f & SSGI_GL__DEEP) && (f & SSGI_GL__SENDERS))) f |= SSGI_GL__RECEIVED;
    f |= hidden && !(f & SSGI_GL__DEPTHS) ? SSGI_GL__UNSEEN : SSGI_GL__SEEN;
    if (blur || hsao || (f & (SSGI_GL__BLOCKED | SSGI_GL__N_DEPTH))) f |= SSGI_GL__INSIDE;
    if (f & SSGI_GL__DEEP) f |= d->layers > 1 ? SSGI_GL__LAYERS : SSGI_GL__ONE_LAYER;
    if (hidden || ((f & SSGI_GL__DEPTHS) && (f & SSGI_GL__LAYERS))) f |= SSGI_GL__LAYERS_READ;
    return f;
}

SSGI_DEF const char *ssgi_gl_pass_name(int pass)
{
    int i;
    for (i = 0; i < SSGI_GL__ROWS; ++i) if (ssgi_gl__passes[i].pass == pass) return ssgi_gl__passes[i].name;
    return NULL;
}

typedef struct ssgi_gl__dialect { const char *name, *version; int es, bindings; } ssgi_gl__dialect;
static const ssgi_gl__dialect ssgi_gl__dialects[] = {
    { "330", "#version 330 core\n", 0, 0 }, { "410", "#version 410 core\n", 0, 0 }, { "450", "#version 450 core\n", 0, 1 },
    { "300es", "#version 300 es\n", 1, 0 }, { "310es", "#version 310 es\n", 1, 1 }, { "320es", "#version 320 es\n", 1, 1 }
};

SSGI_DEF const char *ssgi_gl_dialect_name(int dialect)
{
    return dialect >= 0 && dialect < SSGI_GL_DIALECTS ? ssgi_gl__dialects[dialect].name : NULL;
}

SSGI_DEF int ssgi_gl_fetches(const ssgi_gl_desc *desc)
{
    ssgi_gl_desc d;
    uint64_t f;
    int n, test;
    if (ssgi_gl_check(desc, NULL) != SSGI_OK) return 0;
    d = ssgi_gl__resolve(desc);
    f = ssgi_gl__features(&d);
    n = 1 + (f & SSGI_GL__N_DEPTH ? 4 : f & SSGI_GL__NORMALS ? 1 : 0) + (f & SSGI_GL__NOISE_TEXTURE ? 1 : 0);
    test = (f & SSGI_GL__LAYERS ? d.layers : 1) + (f & SSGI_GL__VIEWS ? d.views * d.view_layers : 0);
    switch (d.pass) {
    case SSGI_GL_SSAO: return n + d.samples * (d.steps * test + d.kernel);
    case SSGI_GL_SSDO: return n + d.samples * (d.steps * test + d.kernel + (f & SSGI_GL__E_MAP ? 1 : 0)) + (f & SSGI_GL__E_MAP ? 4 : 0);
    case SSGI_GL_HSAO: return n + d.directions * d.steps * (d.search == SSGI_GL_SLICES ? 2 : 1 + d.normal_rays * test);
    case SSGI_GL_LIGHTS: return n + 3 + (f & SSGI_GL__MAPS_READ ? 6 : 0) + (f & SSGI_GL__SEGMENTS ? d.samples * test : 0) + d.accumulate;
    case SSGI_GL_SENDERS: return n + (f & SSGI_GL__S_LIGHT ? 2 : 0) + (f & SSGI_GL__S_DIRECT ? 1 : 0);
    default: {
        const int side = 2 * d.filter_radius + 1;
        n -= !d.half;                           /* depth comes with the centre */
        return n + side * side + (f & SSGI_GL__F_NORMALS ? (f & SSGI_GL__N_DEPTH ? 4 : 1) * (side * side - 1) : 0);
    } }
}

/* ==== >>emit (implementation) ===================================================================================== */

/* Writes, measures and hashes in one. */
typedef struct ssgi_gl__text { char *out; size_t capacity, length; uint64_t hash; } ssgi_gl__text;

static void ssgi_gl__put(ssgi_gl__text *t, const char *s)
{
    for (; *s; ++s, ++t->length) {
        if (t->length + 1 < t->capacity) t->out[t->length] = *s;
        t->hash = (t->hash ^ (uint64_t)(unsigned char)*s) * 1099511628211u;
    }
}

static void ssgi_gl__put_int(ssgi_gl__text *t, int value)
{
    char digits[12];
    int i = (int)sizeof digits - 1;
    unsigned int v = value < 0 ? 0u - (unsigned int)value : (unsigned int)value;
    digits[i] = 0;
    do digits[--i] = (char)('0' + v % 10); while (v /= 10);
    if (value < 0) ssgi_gl__put(t, "-");
    ssgi_gl__put(t, digits + i);
}

/* 7 decimals by integers: printf's follow the locale. [limit: |x| < 100] */
static void ssgi_gl__put_float(ssgi_gl__text *t, float x)
{
    int v = (int)((double)x * 1e7 + (x < 0.0f ? -0.5 : 0.5)), k;
    if (v < 0) { ssgi_gl__put(t, "-"); v = -v; }
    ssgi_gl__put_int(t, v / 10000000);
    ssgi_gl__put(t, ".");
    for (k = 1000000; k > 1 && v % 10000000 < k; k /= 10) ssgi_gl__put(t, "0");
    ssgi_gl__put_int(t, v % 10000000);
}

static void ssgi_gl__line(ssgi_gl__text *t, const ssgi_gl_desc *d, int line)
{
    if (!d->lines) return;
    ssgi_gl__put(t, "#line ");
    ssgi_gl__put_int(t, line);
    ssgi_gl__put(t, "\n");
}

/* The points of SSAO, as ssgi_kernel makes them. */
static void ssgi_gl__put_kernel(ssgi_gl__text *t, int samples)
{
    float k[4 * 64];
    int i;
    ssgi_kernel(k, 1, samples, SSGI_COSINE, NULL);
    ssgi_gl__put(t, "// ssgi_kernel: cosine-weighted directions about +z, w: length\nconst vec4 SSGI_KERNEL[");
    ssgi_gl__put_int(t, samples);
    ssgi_gl__put(t, "] = vec4[");
    ssgi_gl__put_int(t, samples);
    ssgi_gl__put(t, "](");
    for (i = 0; i < 4 * samples; ++i) {
        ssgi_gl__put(t, i == 0 ? "\n    vec4(" : i % 4 == 0 ? "),\n    vec4(" : ", ");
        ssgi_gl__put_float(t, k[i]);
    }
    ssgi_gl__put(t, "));\n");
}

/* Only rows that exist in this variant, slots given in their order. */
static int ssgi_gl__collect(const ssgi_gl__row *const *rows, const ssgi_gl_desc *d, uint64_t features, ssgi_gl_io *out, int capacity)
{
    int n = 0, textures = 0, outputs = 0;
    for (; *rows; ++rows) {
        ssgi_gl_io io = (*rows)->io;
        if (((*rows)->need & features) != (*rows)->need) continue;
        if (io.kind == SSGI_GL_TEXTURE) io.slot = textures++;
        if (io.kind == SSGI_GL_OUTPUT) io.slot = outputs++;
        if (io.kind == SSGI_GL_CONSTANT) { io.slot = ssgi_gl__get(d, io.offset); io.offset = 0; }
        if (n < capacity) out[n] = io;
        ++n;
    }
    return n;
}

static size_t ssgi_gl__size_of(const char *type)
{
    static const struct size { const char *type; size_t bytes; } sizes[] = { { "float", 4 }, { "int", 4 }, { "ivec2", 8 }, { "vec4", 16 }, { "mat3", 48 },
                                                                            { "vec4[9]", 144 }, { "mat4[4]", 256 }, { "vec4[4]", 64 } };
    size_t i = 0;
    while (strcmp(sizes[i].type, type)) ++i;        /* the rows above have no others */
    return sizes[i].bytes;
}

/* A uniform block: members in the order of its struct, gaps where this pass reads nothing. */
static void ssgi_gl__put_block(ssgi_gl__text *t, const ssgi_gl_io *io, int n, int block, int bindings)
{
    size_t at = 0;
    int gaps = 0;
    for (;;) {
        const ssgi_gl_io *next = NULL;
        int i;
        for (i = 0; i < n; ++i)
            if (io[i].kind == SSGI_GL_PARAM && io[i].slot == block && io[i].offset >= at && (!next || io[i].offset < next->offset)) next = &io[i];
        if (!next) break;
        if (!at && !gaps) {
            ssgi_gl__put(t, "layout(std140");
            if (bindings) ssgi_gl__put(t, block ? ", binding = 1" : ", binding = 0");
            ssgi_gl__put(t, block ? ") uniform ssgi_views {\n" : ") uniform ssgi_frame {\n");
        }
        while (at < next->offset) {
            size_t gap = at % 16 == 0 && next->offset - at >= 16 ? (next->offset - at) / 16 * 16 : 4;
            ssgi_gl__put(t, gap == 4 ? "    float u_ssgi_gap" : "    vec4 u_ssgi_gap");
            ssgi_gl__put_int(t, 10 * block + gaps++);
            if (gap > 16) {
                ssgi_gl__put(t, "[");
                ssgi_gl__put_int(t, (int)(gap / 16));
                ssgi_gl__put(t, "]");
            }
            ssgi_gl__put(t, ";\n");
            at += gap;
        }
        ssgi_gl__put(t, "    ");
        ssgi_gl__put(t, next->type);
        ssgi_gl__put(t, " ");
        ssgi_gl__put(t, next->name);
        ssgi_gl__put(t, *next->format ? "; // " : ";");
        ssgi_gl__put(t, next->format);
        ssgi_gl__put(t, "\n");
        at = next->offset + ssgi_gl__size_of(next->type);
    }
    if (at) ssgi_gl__put(t, "};\n");
}

static void ssgi_gl__write(ssgi_gl__text *t, const ssgi_gl_desc *desc, int stage)
{
    ssgi_gl_desc d = ssgi_gl__resolve(desc);
    const ssgi_gl__pass *pass = ssgi_gl__find(&d);
    const ssgi_gl__dialect *dialect = &ssgi_gl__dialects[d.dialect];
    const ssgi_gl__chunk *const *chunk = pass->chunks[stage];
    uint64_t features = ssgi_gl__features(&d);
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    int n = ssgi_gl__collect(pass->rows[stage], &d, features, io, SSGI_GL_MAX_IO), i;

    ssgi_gl__put(t, d.version ? d.version : dialect->version);
    if (d.version && *d.version && d.version[strlen(d.version) - 1] != '\n') ssgi_gl__put(t, "\n");
    if (dialect->es) {
        ssgi_gl__put(t, "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n");
        for (i = 0; i < n && !strstr(io[i].type, "2DArray"); ++i) {}
        if (i < n) ssgi_gl__put(t, "precision highp sampler2DArray;\nprecision highp usampler2DArray;\n");
    }
    for (i = 0; i < n; ++i) {
        if (io[i].kind != SSGI_GL_CONSTANT) continue;
        ssgi_gl__put(t, "const int ");
        ssgi_gl__put(t, io[i].name);
        ssgi_gl__put(t, " = ");
        ssgi_gl__put_int(t, io[i].slot);
        ssgi_gl__put(t, ";\n");
    }
    ssgi_gl__put_block(t, io, n, 0, dialect->bindings);
    ssgi_gl__put_block(t, io, n, 1, dialect->bindings);
    for (i = 0; i < n; ++i) {
        if (io[i].kind != SSGI_GL_TEXTURE && io[i].kind != SSGI_GL_OUTPUT) continue;
        if (io[i].kind == SSGI_GL_OUTPUT || dialect->bindings) {
            ssgi_gl__put(t, io[i].kind == SSGI_GL_OUTPUT ? "layout(location = " : "layout(binding = ");
            ssgi_gl__put_int(t, io[i].slot);
            ssgi_gl__put(t, ") ");
        }
        ssgi_gl__put(t, io[i].kind == SSGI_GL_OUTPUT ? "out " : "uniform ");
        ssgi_gl__put(t, io[i].type);
        ssgi_gl__put(t, " ");
        ssgi_gl__put(t, io[i].name);
        ssgi_gl__put(t, "; // ");
        ssgi_gl__put(t, io[i].format);
        ssgi_gl__put(t, "\n");
    }
    if (d.fetch && stage == SSGI_GL_FRAGMENT) {
        ssgi_gl__put(t, "\n");
        ssgi_gl__put(t, d.fetch);
        ssgi_gl__put(t, "\n");
    }
    for (; *chunk; ++chunk) {
        if (((*chunk)->need & features) != (*chunk)->need) continue;
        if ((*chunk)->text[0] != ' ') ssgi_gl__put(t, "\n");       /* chunks that begin inside a function continue it */
        ssgi_gl__line(t, &d, (*chunk)->line);
        if (*chunk == &ssgi_gl__kernel) ssgi_gl__put_kernel(t, d.samples);
        ssgi_gl__put(t, (*chunk)->text);
    }
}

SSGI_DEF size_t ssgi_gl_emit(char *out, size_t capacity, const ssgi_gl_desc *desc, int stage)
{
    ssgi_gl__text t;
    if (ssgi_gl_check(desc, NULL) != SSGI_OK || stage < 0 || stage >= SSGI_GL_STAGES || (!out && capacity)) return 0;
    memset(&t, 0, sizeof t);
    t.out = out;
    t.capacity = capacity;
    ssgi_gl__write(&t, desc, stage);
    if (capacity) out[t.length < capacity ? t.length : capacity - 1] = 0;
    return t.length;
}

SSGI_DEF int ssgi_gl_reflect(const ssgi_gl_desc *desc, ssgi_gl_io *rows, int capacity)
{
    ssgi_gl_desc d;
    if (ssgi_gl_check(desc, NULL) != SSGI_OK || (!rows && capacity > 0)) return 0;
    d = ssgi_gl__resolve(desc);
    return ssgi_gl__collect(ssgi_gl__find(&d)->rows[SSGI_GL_FRAGMENT], &d, ssgi_gl__features(&d), rows, capacity);
}

SSGI_DEF uint64_t ssgi_gl_key(const ssgi_gl_desc *desc)
{
    uint64_t h = 14695981039346656037u;     /* FNV-1a over the very texts */
    ssgi_gl__text t;
    int stage;
    if (ssgi_gl_check(desc, NULL) != SSGI_OK) return 0;
    for (stage = 0; stage < SSGI_GL_STAGES; ++stage) {
        memset(&t, 0, sizeof t);
        t.hash = h;
        ssgi_gl__write(&t, desc, stage);
        h = t.hash;
    }
    return h;
}

/* ==== >>frame (implementation) ==================================================================================== */

SSGI_DEF ssgi_result ssgi_gl_frame_init(ssgi_gl_frame *frame, const ssgi_view *view, float radius, const char **why)
{
    ssgi_gl_frame f;
    if (!frame) return ssgi_gl__bad(why, "frame: must not be NULL");
    if (!view || view->width < 1 || view->height < 1) return ssgi_gl__bad(why, "view: must come from ssgi_view_from_projection");
    if (!(radius > 0.0f && radius < SSGI_FAR)) return ssgi_gl__bad(why, "radius: must be > 0 and finite");
    memset(&f, 0, sizeof f);
    memcpy(f.project, view->project, sizeof f.project);
    memcpy(f.unproject, view->unproject, sizeof f.unproject);
    f.decode[0] = view->depth[0];
    f.decode[1] = view->depth[1];
    f.decode[2] = view->clear;
    f.size[0] = view->width;
    f.size[1] = view->height;
    f.radius = radius;
    f.offset = 1.5f;
    f.thickness = radius;
    f.fade = 0.5f * radius;
    f.nearest = 0.25f;
    f.gain = 1.0f;
    f.steepest = 20.0f;
    f.rotation[0] = f.rotation[5] = f.rotation[10] = 1.0f;
    *frame = f;
    return SSGI_OK;
}

/* a * b of two rigid world-to-view matrices: a after the inverse of b */
static void ssgi_gl__relative(double out[16], const float a[16], const float b[16])
{
    int r, c, k;
    for (c = 0; c < 4; ++c)
        for (r = 0; r < 4; ++r) {
            double sum = c == 3 ? (double)a[12 + r] : 0.0;
            for (k = 0; k < 3; ++k) {
                double inverse = 0.0;               /* element k, c of b's: the transposed rotation; its translation is that times -t */
                int i;
                if (c < 3) inverse = (double)b[4 * k + c];
                else for (i = 0; i < 3; ++i) inverse -= (double)b[4 * k + i] * (double)b[12 + i];
                sum += (double)a[4 * k + r] * inverse;
            }
            out[4 * c + r] = sum;
        }
}

/* Column-major: a point of the picture's view space to x, y (pixels, times depth when perspective), view depth, 1 of another camera; and back. */
static void ssgi_gl__to_pixels(float to[16], float from[16], const ssgi_view *view, const float picture[16], const float other[16])
{
    double m[16], b[16];
    int c, r;
    ssgi_gl__relative(m, other, picture);
    ssgi_gl__relative(b, picture, other);
    for (c = 0; c < 4; ++c) {
        const double z = -m[4 * c + 2], unit = view->orthographic ? (c == 3 ? 1.0 : 0.0) : z;
        to[4 * c + 0] = (float)((double)view->project[0] * m[4 * c + 0] + (double)view->project[2] * unit);
        to[4 * c + 1] = (float)((double)view->project[1] * m[4 * c + 1] + (double)view->project[3] * unit);
        to[4 * c + 2] = (float)z;
        to[4 * c + 3] = c == 3 ? 1.0f : 0.0f;
    }
    for (r = 0; r < 4; ++r) {       /* view xy = pixel * unproject.xy + unproject.zw, the latter times depth or not */
        const double shift = b[r] * (double)view->unproject[2] + b[4 + r] * (double)view->unproject[3];
        from[r] = (float)(b[r] * (double)view->unproject[0]);
        from[4 + r] = (float)(b[4 + r] * (double)view->unproject[1]);
        from[8 + r] = (float)((view->orthographic ? 0.0 : shift) - b[8 + r]);
        from[12 + r] = (float)((view->orthographic ? shift : 0.0) + b[12 + r]);
    }
}

static ssgi_result ssgi_gl__check_camera(const ssgi_view *view, const float *picture, const float *other, const char *name, const char **why)
{
    int i;
    if (!view || view->width < 1 || view->height < 1) return ssgi_gl__bad(why, "view: must come from ssgi_view_from_projection");
    if (!picture) return ssgi_gl__bad(why, "picture_world_to_view: must not be NULL");
    if (!other) return ssgi_gl__bad(why, name);
    for (i = 0; i < 16; ++i)
        if (!(picture[i] > -SSGI_FAR && picture[i] < SSGI_FAR && other[i] > -SSGI_FAR && other[i] < SSGI_FAR))
            return ssgi_gl__bad(why, "picture_world_to_view: both matrices must be finite");
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_views_set(ssgi_gl_views *views, int i, const ssgi_view *view, const float picture_world_to_view[16],
                                       const float extra_world_to_view[16], const char **why)
{
    ssgi_result r;
    if (!views) return ssgi_gl__bad(why, "views: must not be NULL");
    if (i < 0 || i > 3) return ssgi_gl__bad(why, "i: must be 0..3");
    r = ssgi_gl__check_camera(view, picture_world_to_view, extra_world_to_view, "extra_world_to_view: must not be NULL", why);
    if (r != SSGI_OK) return r;
    ssgi_gl__to_pixels(views->to[i], views->from[i], view, picture_world_to_view, extra_world_to_view);
    views->decode[i][0] = view->depth[0];
    views->decode[i][1] = view->depth[1];
    views->decode[i][2] = view->clear;
    views->decode[i][3] = (float)view->orthographic;
    views->size[i][0] = (float)view->width;
    views->size[i][1] = (float)view->height;
    views->size[i][2] = 2.0f * ssgi_pixel_footprint(view, 1.0f);
    views->size[i][3] = 0.0f;
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_light_map(ssgi_gl_light *light, const ssgi_view *view, int x, int y, const float picture_world_to_view[16],
                                       const float light_world_to_view[16], const char **why)
{
    float to[16], from[16];
    ssgi_result r;
    int i, k;
    if (!light) return ssgi_gl__bad(why, "light: must not be NULL");
    if (x < 0 || y < 0) return ssgi_gl__bad(why, "x: the tile must lie in the atlas, x and y >= 0");
    r = ssgi_gl__check_camera(view, picture_world_to_view, light_world_to_view, "light_world_to_view: must not be NULL", why);
    if (r != SSGI_OK) return r;
    ssgi_gl__to_pixels(to, from, view, picture_world_to_view, light_world_to_view);
    for (i = 0; i < 3; ++i)
        for (k = 0; k < 4; ++k) light->map[i][k] = to[4 * k + i];
    light->patch = ssgi_pixel_footprint(view, 1.0f);
    light->decode[0] = view->depth[0];
    light->decode[1] = view->depth[1];
    light->decode[2] = view->clear;
    light->decode[3] = (float)view->orthographic;
    light->tile[0] = (float)x;
    light->tile[1] = (float)y;
    light->tile[2] = (float)view->width;
    light->tile[3] = (float)view->height;
    return SSGI_OK;
}

#ifdef __cplusplus
}
#endif
#endif /* SSGI_GL_IMPLEMENTATION; the licence stands at the end of ssgi.h */
