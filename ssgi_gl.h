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

   PASSES       ssao   fetch -> gather     point samples in the hemisphere [SA07]
                hsao   fetch -> gather     horizon search, slices or the paper's march [HSAO08]
                blur   fetch -> filter     smooths what those two wrote, within surfaces

   ROOMS        search for ">>"
      >>desc       what you choose               >>io      what a pass reads and writes       >>frame    what changes per frame
      >>emit       text out                      >>rows    the table of inputs and outputs
      >>fetch  >>visibility  >>gather  >>filter  the GLSL, one chunk a function               >>passes   the table of passes

   NAMES IN THE TEXT   u_ssgi_* uniforms, t_ssgi_* samplers, o_ssgi_* outputs, ssgi_*() functions, SSGI_* constants; nothing else at global scope. */
#ifndef SSGI_GL_H
#define SSGI_GL_H

#include "ssgi.h"

#ifdef __cplusplus
extern "C" {
#endif

/* ==== >>desc =================================================================================================== */

enum { SSGI_GL_SSAO = 0, SSGI_GL_HSAO, SSGI_GL_BLUR, SSGI_GL_PASSES /* how many */ };                      /* desc.pass */
enum { SSGI_GL_330 = 0, SSGI_GL_410, SSGI_GL_450, SSGI_GL_300ES, SSGI_GL_310ES, SSGI_GL_320ES, SSGI_GL_DIALECTS };   /* desc.dialect */
enum { SSGI_GL_VERTEX = 0, SSGI_GL_FRAGMENT, SSGI_GL_STAGES };                                              /* stage of ssgi_gl_emit */

/* desc.depth: what the depth texture holds */
enum { SSGI_GL_DEPTH_WINDOW = 0,     /* hardware depth, any layout that ssgi_view decodes */
       SSGI_GL_DEPTH_LINEAR,         /* positive view depth; <= 0, inf or NaN is background */
       SSGI_GL_DEPTH_CUSTOM };       /* your GLSL in desc.fetch: float ssgi_custom_depth(ivec2 texel), positive view depth */
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
    int samples;            /* ssao   [limit: 0..64] [default: 16]  points per pixel */
    int search;             /* hsao   SSGI_GL_SLICES, SSGI_GL_MARCH */
    int directions;         /* hsao   [limit: 0..32] [default: slices 1, march 6]  slices (two directions each), or N_d */
    int steps;              /* hsao   [limit: 0..64] [default: 6]  per direction: N_s */
    int normal_rays;        /* hsao, march only   [limit: 0..8]  N_n: rays above the horizon, per direction; 0 = none */
    int hard;               /* hsao   [limit: 0..1]  1: no attenuation, all within the radius occludes fully */
    int thin;               /* ssao, hsao   [limit: 0..1]  0: what is seen extends away from the viewer without end; 1: by frame.thickness */
    int half;               /* all   [limit: 0..1]  1: ssao and hsao draw one pixel of every 2x2, into targets of half size (rounded up); blur brings it to full size */
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
     ssao          8, 16, 32 points, thin
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

/* The most texel fetches that a pixel of this pass makes, 0 for a bad desc; what desc.fetch does counts as one. */
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
    int         slot;       /* TEXTURE: unit (binding in dialects that have it). OUTPUT: location. CONSTANT: its value. PARAM: 0, the block's binding */
    size_t      offset;     /* PARAM: byte in ssgi_gl_frame = byte in the std140 block. Else 0 */
    const char *format;     /* TEXTURE, OUTPUT: what the texture is. PARAM: units */
} ssgi_gl_io;

#define SSGI_GL_MAX_IO 40

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
    float   offset;         /* [units: half pixels] [default: 1.5]  lift of the receiver along its normal: ssao and hsao march, for nearest fetches */
    float   thickness;      /* [units: view] [limit: >= 0] [default: radius]  how far behind what is seen things are taken to reach (desc.thin); half of it suits march */
    float   phase;          /* [limit: 0..1]  turns the noise; 0, or another value each frame when frames are averaged */
    float   unused[2];
    float   rotation[12];   /* world to view, 3 columns padded to 4 (desc.world_normals); identity by default */
} ssgi_gl_frame;

/* Fills a frame: the view, the picture at the origin of textures and targets, defaults everywhere else. radius [units: view] [limit: > 0, finite]. */
SSGI_DEF ssgi_result ssgi_gl_frame_init(ssgi_gl_frame *frame, const ssgi_view *view, float radius, const char **why);

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
#define SSGI_GL__PERSPECTIVE     ((uint64_t)1 << 0)
#define SSGI_GL__ORTHOGRAPHIC    ((uint64_t)1 << 1)
#define SSGI_GL__GBUFFER         ((uint64_t)1 << 2)   /* depth or normals are read */
#define SSGI_GL__D_TEXTURE       ((uint64_t)1 << 3)   /* depth: through a texture of ours, and what it holds */
#define SSGI_GL__D_WINDOW        ((uint64_t)1 << 4)
#define SSGI_GL__D_LINEAR        ((uint64_t)1 << 5)
#define SSGI_GL__D_CUSTOM        ((uint64_t)1 << 6)
#define SSGI_GL__NORMALS         ((uint64_t)1 << 7)   /* normals are read */
#define SSGI_GL__N_TEXTURE       ((uint64_t)1 << 8)   /* through a texture of ours, and what it holds */
#define SSGI_GL__N_SIGNED        ((uint64_t)1 << 9)
#define SSGI_GL__N_UNSIGNED      ((uint64_t)1 << 10)
#define SSGI_GL__N_OCTA          ((uint64_t)1 << 11)
#define SSGI_GL__N_CUSTOM        ((uint64_t)1 << 12)
#define SSGI_GL__N_DEPTH         ((uint64_t)1 << 13)   /* from depth */
#define SSGI_GL__N_VIEW          ((uint64_t)1 << 14)   /* in view space, in world space */
#define SSGI_GL__N_WORLD         ((uint64_t)1 << 15)
#define SSGI_GL__TOWARD          ((uint64_t)1 << 16)   /* the direction to the eye is needed */
#define SSGI_GL__NOISE_GRADIENT  ((uint64_t)1 << 17)
#define SSGI_GL__NOISE_TILE4     ((uint64_t)1 << 18)
#define SSGI_GL__NOISE_TEXTURE   ((uint64_t)1 << 19)
#define SSGI_GL__FULL            ((uint64_t)1 << 20)   /* size of what ssao and hsao draw */
#define SSGI_GL__HALF            ((uint64_t)1 << 21)
#define SSGI_GL__RAYS            ((uint64_t)1 << 22)   /* march with normal rays */
#define SSGI_GL__LINEAR          ((uint64_t)1 << 23)   /* attenuation */
#define SSGI_GL__HARD            ((uint64_t)1 << 24)
#define SSGI_GL__SOLID           ((uint64_t)1 << 25)   /* how far what is seen reaches */
#define SSGI_GL__THIN            ((uint64_t)1 << 26)
#define SSGI_GL__BILATERAL       ((uint64_t)1 << 27)   /* blur */
#define SSGI_GL__GAUSSIAN        ((uint64_t)1 << 28)
#define SSGI_GL__F_NORMALS       ((uint64_t)1 << 29)   /* blur compares normals */
#define SSGI_GL__BLOCKED         ((uint64_t)1 << 30)   /* points are tested: ssao, normal rays */

typedef struct ssgi_gl__chunk { int line; uint64_t need; const char *text; } ssgi_gl__chunk;
typedef struct ssgi_gl__row { uint64_t need; ssgi_gl_io io; } ssgi_gl__row;   /* CONSTANT: io.offset is the field's place in ssgi_gl_desc */

/* ==== >>rows: inputs and outputs ================================================================================= */

#define SSGI_GL__P(need, name, type, member, units) { need, { "u_ssgi_" name, SSGI_GL_PARAM, type, 0, offsetof(ssgi_gl_frame, member), units } }
#define SSGI_GL__C(need, name, field)                   { need, { name, SSGI_GL_CONSTANT, "int", 0, offsetof(ssgi_gl_desc, field), "" } }
#define SSGI_GL__T(need, name, format)                  { need, { "t_ssgi_" name, SSGI_GL_TEXTURE, "sampler2D", 0, 0, format } }
#define SSGI_GL__O(name, type, format)                  { 0, { "o_ssgi_" name, SSGI_GL_OUTPUT, type, 0, 0, format } }

static const ssgi_gl__row ssgi_gl__project     = SSGI_GL__P(0, "project", "vec4", project, "pixels per view xy / depth; pixels");
static const ssgi_gl__row ssgi_gl__unproject   = SSGI_GL__P(0, "unproject", "vec4", unproject, "view xy / depth per pixel");
static const ssgi_gl__row ssgi_gl__decode_row  = SSGI_GL__P(SSGI_GL__D_WINDOW, "decode", "vec4", decode, "window depth to view depth");
static const ssgi_gl__row ssgi_gl__origin      = SSGI_GL__P(SSGI_GL__GBUFFER, "origin", "ivec2", origin, "texels");
static const ssgi_gl__row ssgi_gl__size        = SSGI_GL__P(0, "size", "ivec2", size, "pixels");
static const ssgi_gl__row ssgi_gl__target      = SSGI_GL__P(0, "target", "ivec2", target, "texels");
static const ssgi_gl__row ssgi_gl__radius      = SSGI_GL__P(0, "radius", "float", radius, "view units");
static const ssgi_gl__row ssgi_gl__near_radius = SSGI_GL__P(SSGI_GL__BILATERAL, "radius", "float", radius, "view units");
static const ssgi_gl__row ssgi_gl__offset      = SSGI_GL__P(0, "offset", "float", offset, "half pixels");
static const ssgi_gl__row ssgi_gl__thickness   = SSGI_GL__P(SSGI_GL__THIN, "thickness", "float", thickness, "view units");
static const ssgi_gl__row ssgi_gl__phase       = SSGI_GL__P(0, "phase", "float", phase, "turns");
static const ssgi_gl__row ssgi_gl__rotation    = SSGI_GL__P(SSGI_GL__N_WORLD, "rotation", "mat3", rotation, "world to view");
static const ssgi_gl__row ssgi_gl__depth_tex   = SSGI_GL__T(SSGI_GL__D_TEXTURE, "depth", "depth: hardware depth (any DEPTH_COMPONENT, compare mode off) or R32F view depth");
static const ssgi_gl__row ssgi_gl__normal_tex  = SSGI_GL__T(SSGI_GL__N_TEXTURE, "normal", "normal: RGBA16F, RGB10_A2, RG16F .. as desc.normal says");
static const ssgi_gl__row ssgi_gl__noise_tex   = SSGI_GL__T(SSGI_GL__NOISE_TEXTURE, "noise", "RGBA16F, any size: ssgi_jitter_tile");
static const ssgi_gl__row ssgi_gl__ao_tex      = SSGI_GL__T(0, "ao", "what ssao or hsao wrote: RG32F or RG16F");
static const ssgi_gl__row ssgi_gl__ao_out      = SSGI_GL__O("ao", "vec2", "RG32F or RG16F: ambient visibility, view depth for the filter; R8 or R16F if nothing filters");
static const ssgi_gl__row ssgi_gl__blurred_out = SSGI_GL__O("ao", "float", "R8 or R16F: ambient visibility");
static const ssgi_gl__row ssgi_gl__c_samples   = SSGI_GL__C(0, "SSGI_SAMPLES", samples);
static const ssgi_gl__row ssgi_gl__c_directions = SSGI_GL__C(0, "SSGI_DIRECTIONS", directions);
static const ssgi_gl__row ssgi_gl__c_steps     = SSGI_GL__C(0, "SSGI_STEPS", steps);
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

static const ssgi_gl__chunk ssgi_gl__depth_window = { __LINE__ + 1, SSGI_GL__D_WINDOW,
    "// view depth at a pixel of the picture\n"
    "float ssgi_depth(ivec2 p)\n"
    "{\n"
    "    return ssgi_decode(texelFetch(t_ssgi_depth, p + u_ssgi_origin, 0).x);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__depth_linear = { __LINE__ + 1, SSGI_GL__D_LINEAR,
    "// view depth at a pixel of the picture\n"
    "float ssgi_depth(ivec2 p)\n"
    "{\n"
    "    float z = texelFetch(t_ssgi_depth, p + u_ssgi_origin, 0).x;\n"
    "    return z > 0.0 && z < SSGI_FAR ? z : SSGI_FAR;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__depth_custom = { __LINE__ + 1, SSGI_GL__D_CUSTOM,
    "// view depth at a pixel of the picture\n"
    "float ssgi_depth(ivec2 p)\n"
    "{\n"
    "    float z = ssgi_custom_depth(p + u_ssgi_origin);\n"
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

static const ssgi_gl__chunk ssgi_gl__project_perspective = { __LINE__ + 1, SSGI_GL__PERSPECTIVE,
    "// the pixel position of a view-space point in front of the eye\n"
    "vec2 ssgi_project(vec3 P)\n"
    "{\n"
    "    return P.xy * (u_ssgi_project.xy / -P.z) + u_ssgi_project.zw;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__project_orthographic = { __LINE__ + 1, SSGI_GL__ORTHOGRAPHIC,
    "// the pixel position of a view-space point\n"
    "vec2 ssgi_project(vec3 P)\n"
    "{\n"
    "    return P.xy * u_ssgi_project.xy + u_ssgi_project.zw;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__footprint_perspective = { __LINE__ + 1, SSGI_GL__PERSPECTIVE,
    "// width of a pixel at a view depth\n"
    "float ssgi_footprint(float z)\n"
    "{\n"
    "    return max(abs(u_ssgi_unproject.x), abs(u_ssgi_unproject.y)) * z;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__footprint_orthographic = { __LINE__ + 1, SSGI_GL__ORTHOGRAPHIC,
    "// width of a pixel\n"
    "float ssgi_footprint(float z)\n"
    "{\n"
    "    return max(abs(u_ssgi_unproject.x), abs(u_ssgi_unproject.y));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__inside = { __LINE__ + 1, 0,
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

static const ssgi_gl__chunk ssgi_gl__raw_signed = { __LINE__ + 1, SSGI_GL__N_SIGNED,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    return texelFetch(t_ssgi_normal, p + u_ssgi_origin, 0).xyz;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__raw_unsigned = { __LINE__ + 1, SSGI_GL__N_UNSIGNED,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    return texelFetch(t_ssgi_normal, p + u_ssgi_origin, 0).xyz * 2.0 - 1.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__raw_octahedral = { __LINE__ + 1, SSGI_GL__N_OCTA,
    "vec3 ssgi_raw_normal(ivec2 p)\n"
    "{\n"
    "    vec2 e = texelFetch(t_ssgi_normal, p + u_ssgi_origin, 0).xy;\n"
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

/* ==== >>visibility: is this point behind a surface ================================================================ */

static const ssgi_gl__chunk ssgi_gl__lift = { __LINE__ + 1, 0,
    "// the receiver lifted along its normal, so that nearest fetches of its own plane stay below it [HSAO08 eq. 13]\n"
    "vec3 ssgi_lift(vec3 P, vec3 n)\n"
    "{\n"
    "    return P + n * (u_ssgi_offset * 0.5 * ssgi_footprint(-P.z));\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__behind = { __LINE__ + 1, SSGI_GL__BLOCKED,
    "// how far S lies behind the surface seen at its pixel; 0 before it, behind the eye or off the picture\n"
    "float ssgi_behind(vec3 S)\n"
    "{\n"
    "    if (S.z >= 0.0) return 0.0;\n"
    "    ivec2 p = ivec2(floor(ssgi_project(S)));\n"
    "    return ssgi_inside(p) ? max(-S.z - ssgi_depth(p), 0.0) : 0.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__blocked_solid = { __LINE__ + 1, SSGI_GL__BLOCKED | SSGI_GL__SOLID,
    "// 1 where S lies behind what is seen, else 0\n"
    "float ssgi_blocked(vec3 S)\n"
    "{\n"
    "    return ssgi_behind(S) > 0.0 ? 1.0 : 0.0;\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__blocked_thin = { __LINE__ + 1, SSGI_GL__BLOCKED | SSGI_GL__THIN,
    "// 1 where S lies within u_ssgi_thickness behind what is seen, else 0\n"
    "float ssgi_blocked(vec3 S)\n"
    "{\n"
    "    float behind = ssgi_behind(S);\n"
    "    return behind > 0.0 && behind < u_ssgi_thickness ? 1.0 : 0.0;\n"
    "}\n" };

/* ==== >>gather: what a pixel collects ============================================================================= */

static const ssgi_gl__chunk ssgi_gl__basis = { __LINE__ + 1, 0,
    "// any rotation that takes +z to the unit vector n [Duff et al. 2017]\n"
    "mat3 ssgi_basis(vec3 n)\n"
    "{\n"
    "    float s = n.z >= 0.0 ? 1.0 : -1.0, a = -1.0 / (s + n.z), b = n.x * n.y * a;\n"
    "    return mat3(1.0 + s * n.x * n.x * a, s * b, -s * n.x, b, s + n.y * n.y * a, -n.y, n);\n"
    "}\n" };

static const ssgi_gl__chunk ssgi_gl__kernel = { __LINE__ + 1, 0, "" };   /* printed by ssgi_gl__put_kernel */

static const ssgi_gl__chunk ssgi_gl__gather_points = { __LINE__ + 1, 0,
    "// occlusion from point samples: directions by the cosine, lengths uniform, so that it converges to linear attenuation\n"
    "float ssgi_occlusion(ivec2 p, vec3 P, vec3 n, vec2 xi)\n"
    "{\n"
    "    float a = 6.28318531 * xi.x, c = cos(a), s = sin(a), sum = 0.0;\n"
    "    mat3 basis = ssgi_basis(n) * mat3(c, s, 0.0, -s, c, 0.0, 0.0, 0.0, 1.0);\n"
    "    vec3 start = ssgi_lift(P, n);\n"
    "    for (int i = 0; i < SSGI_SAMPLES; ++i) {\n"
    "        vec4 k = SSGI_KERNEL[i];\n"
    "        sum += ssgi_blocked(start + basis * k.xyz * (u_ssgi_radius * fract(k.w + xi.y)));\n"
    "    }\n"
    "    return sum / float(SSGI_SAMPLES);\n"
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

static const ssgi_gl__chunk ssgi_gl__blur_full = { __LINE__ + 1, SSGI_GL__FULL,
    "void main()\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - u_ssgi_target;\n"
    "    vec2 centre = texelFetch(t_ssgi_ao, p + u_ssgi_target, 0).xy, sum = vec2(centre.x, 1.0);\n"
    "    float z = centre.y;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_half = { __LINE__ + 1, SSGI_GL__HALF,
    "void main()\n"
    "{\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) - u_ssgi_target;\n"
    "    vec2 sum = vec2(0.0);\n"
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
    "            ivec2 o = ivec2(x, y), q = p + o;\n"
    "            vec2 s = texelFetch(t_ssgi_ao, q + u_ssgi_target, 0).xy;\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tap_half = { __LINE__ + 1, SSGI_GL__HALF,
    "            ivec2 h = p / 2 + ivec2(x, y), q = h * 2, o = q - p;\n"
    "            vec2 s = texelFetch(t_ssgi_ao, h + u_ssgi_target / 2, 0).xy;\n" };

static const ssgi_gl__chunk ssgi_gl__weight_gaussian = { __LINE__ + 1, SSGI_GL__GAUSSIAN,
    "            // Gaussian over its depth difference, softened by a pixel's footprint [HSAO08 4.1.3]\n"
    "            float w = exp(-0.5 * float(x * x + y * y) / (0.25 * float(SSGI_FILTER_RADIUS * SSGI_FILTER_RADIUS) + 0.25)) * footprint / (footprint + abs(s.y - z));\n" };

static const ssgi_gl__chunk ssgi_gl__weight_bilateral = { __LINE__ + 1, SSGI_GL__BILATERAL,
    "            // nearness to the tangent plane of the centre\n"
    "            float off = ssgi_off_plane(plane, vec2(o), P, s.y) * near;\n" };

static const ssgi_gl__chunk ssgi_gl__weight_box = { __LINE__ + 1, SSGI_GL__BILATERAL | SSGI_GL__FULL,
    "            float w = max(1.0 - off, 0.0); // a box that covers one tile of noise\n"
    "            if (SSGI_FILTER_RADIUS > 1 && abs(x) == SSGI_FILTER_RADIUS) w *= 0.5;\n"
    "            if (SSGI_FILTER_RADIUS > 1 && abs(y) == SSGI_FILTER_RADIUS) w *= 0.5;\n" };

static const ssgi_gl__chunk ssgi_gl__weight_tent = { __LINE__ + 1, SSGI_GL__BILATERAL | SSGI_GL__HALF,
    "            vec2 tent = float(2 * SSGI_FILTER_RADIUS + 2) - abs(vec2(o));\n"
    "            float w = tent.x * tent.y * max(1.0 - off, 1e-3 / (1.0 + off)); // never 0: where nothing fits, the nearest\n" };

static const ssgi_gl__chunk ssgi_gl__weight_normals = { __LINE__ + 1, SSGI_GL__F_NORMALS,
    "            w *= max(dot(n, ssgi_normal(q, ssgi_position(vec2(q) + 0.5, s.y))), 1e-3);\n" };

static const ssgi_gl__chunk ssgi_gl__blur_tail = { __LINE__ + 1, 0,
    "            if (ssgi_inside(q) && s.y < SSGI_FAR) sum += vec2(s.x, 1.0) * w;\n"
    "        }\n"
    "    o_ssgi_ao = z < SSGI_FAR && sum.y > 0.0 ? sum.x / sum.y : 1.0;\n"
    "}\n" };

/* ==== >>passes: what each is made of ============================================================================== */

/* In the order of the text; what a variant does not need falls out by its bits. */
#define SSGI_GL__PROJECTIONS(name) &ssgi_gl__##name##_perspective, &ssgi_gl__##name##_orthographic
#define SSGI_GL__FETCH  &ssgi_gl__far, &ssgi_gl__inside, SSGI_GL__PROJECTIONS(decode), &ssgi_gl__depth_window, &ssgi_gl__depth_linear, &ssgi_gl__depth_custom, \
                        SSGI_GL__PROJECTIONS(position), SSGI_GL__PROJECTIONS(toward), &ssgi_gl__unit, &ssgi_gl__raw_signed, &ssgi_gl__raw_unsigned, \
                        &ssgi_gl__raw_octahedral, &ssgi_gl__raw_custom, &ssgi_gl__normal_view, &ssgi_gl__normal_world, &ssgi_gl__normal_from_depth
#define SSGI_GL__GATHER &ssgi_gl__noise_tile4, &ssgi_gl__noise_gradient, &ssgi_gl__noise_texture, &ssgi_gl__basis
#define SSGI_GL__POINTS SSGI_GL__PROJECTIONS(project), SSGI_GL__PROJECTIONS(footprint), &ssgi_gl__lift, &ssgi_gl__behind, &ssgi_gl__blocked_solid, &ssgi_gl__blocked_thin
#define SSGI_GL__READS  &ssgi_gl__unproject, &ssgi_gl__decode_row, &ssgi_gl__origin, &ssgi_gl__size, &ssgi_gl__target
#define SSGI_GL__MAPS   &ssgi_gl__rotation, &ssgi_gl__depth_tex, &ssgi_gl__normal_tex, &ssgi_gl__noise_tex

static const ssgi_gl__chunk *const ssgi_gl__vertex_chunks[] = { &ssgi_gl__triangle, NULL };
static const ssgi_gl__row *const ssgi_gl__vertex_rows[] = { NULL };

static const ssgi_gl__chunk *const ssgi_gl__ssao_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__POINTS, &ssgi_gl__kernel, &ssgi_gl__gather_points, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_ao, NULL };
static const ssgi_gl__row *const ssgi_gl__ssao_rows[] = {
    &ssgi_gl__c_samples, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__offset, &ssgi_gl__thickness, &ssgi_gl__phase, SSGI_GL__MAPS, &ssgi_gl__ao_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__slices_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__PROJECTIONS(screen), &ssgi_gl__arc, &ssgi_gl__slices_head, &ssgi_gl__slices_thin, &ssgi_gl__slices_last, &ssgi_gl__slices_loop,
    &ssgi_gl__slices_gap, &ssgi_gl__slices_linear, &ssgi_gl__slices_hard, &ssgi_gl__slices_tail, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_ao, NULL };
static const ssgi_gl__row *const ssgi_gl__slices_rows[] = {
    &ssgi_gl__c_directions, &ssgi_gl__c_steps, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__thickness, &ssgi_gl__phase, SSGI_GL__MAPS, &ssgi_gl__ao_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__march_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__GATHER, SSGI_GL__POINTS, &ssgi_gl__attenuation_linear, &ssgi_gl__attenuation_hard, &ssgi_gl__march, &ssgi_gl__normal_ray, &ssgi_gl__above_rays,
    &ssgi_gl__gather_march_head, &ssgi_gl__gather_march_rays, &ssgi_gl__gather_march_tail, &ssgi_gl__main_full, &ssgi_gl__main_half, &ssgi_gl__main_ao, NULL };
static const ssgi_gl__row *const ssgi_gl__march_rows[] = {
    &ssgi_gl__c_directions, &ssgi_gl__c_steps, &ssgi_gl__c_rays, &ssgi_gl__project, SSGI_GL__READS, &ssgi_gl__radius, &ssgi_gl__offset, &ssgi_gl__thickness, &ssgi_gl__phase, SSGI_GL__MAPS,
    &ssgi_gl__ao_out, NULL };

static const ssgi_gl__chunk *const ssgi_gl__blur_chunks[] = {
    SSGI_GL__FETCH, SSGI_GL__PROJECTIONS(footprint), SSGI_GL__PROJECTIONS(plane), &ssgi_gl__blur_full, &ssgi_gl__blur_half, &ssgi_gl__blur_centre, &ssgi_gl__blur_normal,
    &ssgi_gl__blur_loop, &ssgi_gl__blur_tap_full, &ssgi_gl__blur_tap_half, &ssgi_gl__weight_gaussian, &ssgi_gl__weight_bilateral, &ssgi_gl__weight_box, &ssgi_gl__weight_tent,
    &ssgi_gl__weight_normals, &ssgi_gl__blur_tail, NULL };
static const ssgi_gl__row *const ssgi_gl__blur_rows[] = {
    &ssgi_gl__c_filter, SSGI_GL__READS, &ssgi_gl__near_radius, SSGI_GL__MAPS, &ssgi_gl__ao_tex, &ssgi_gl__blurred_out, NULL };

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
    SSGI_GL__F(half, 1, "0 or 1"),
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
    if (!desc->fetch && (desc->depth == SSGI_GL_DEPTH_CUSTOM || desc->normal == SSGI_GL_NORMAL_CUSTOM))
        return ssgi_gl__bad(why, "desc.fetch: must hold ssgi_custom_depth or ssgi_custom_normal when depth or normal is CUSTOM");
    return SSGI_OK;
}

SSGI_DEF ssgi_result ssgi_gl_preset(ssgi_gl_desc *desc, int preset, const char **why)
{
    static const struct counts { unsigned char half, samples, directions, steps, rays; } table[3][3] = {    /* FAST, BALANCED, BEST */
        { { 0, 8, 0, 0, 0 }, { 0, 16, 0, 0, 0 }, { 0, 32, 0, 0, 0 } },      /* ssao */
        { { 1, 0, 1, 3, 0 }, { 1, 0, 2, 6, 0 }, { 0, 0, 3, 8, 0 } },        /* slices */
        { { 0, 0, 4, 6, 0 }, { 0, 0, 6, 9, 1 }, { 0, 0, 8, 18, 2 } } };     /* march */
    const struct counts *c;
    ssgi_result r = ssgi_gl_check(desc, why);
    if (r != SSGI_OK) return r;
    if (preset < SSGI_GL_FAST || preset > SSGI_GL_BEST) return ssgi_gl__bad(why, "preset: must be SSGI_GL_FAST, _BALANCED or _BEST");
    c = &table[desc->pass == SSGI_GL_SSAO ? 0 : desc->search == SSGI_GL_SLICES ? 1 : 2][preset];
    desc->half = c->half;
    if (desc->pass == SSGI_GL_SSAO) {
        desc->samples = c->samples;
    } else {
        desc->directions = c->directions;
        desc->steps = c->steps;
        desc->normal_rays = c->rays;
    }
    desc->thin = desc->pass == SSGI_GL_SSAO || desc->search == SSGI_GL_MARCH;   /* rays past a solid foreground would all end on it */
    desc->filter = SSGI_GL_BILATERAL;
    desc->filter_radius = 1;
    desc->noise = SSGI_GL_NOISE_GRADIENT;
    return SSGI_OK;
}

/* The desc with its defaults in place. */
static ssgi_gl_desc ssgi_gl__resolve(const ssgi_gl_desc *desc)
{
    ssgi_gl_desc d = *desc;
    if (!d.samples) d.samples = 16;
    if (!d.directions) d.directions = d.search == SSGI_GL_MARCH ? 6 : 1;
    if (!d.steps) d.steps = 6;
    if (!d.filter_radius) d.filter_radius = d.filter == SSGI_GL_GAUSSIAN ? 2 : 1;
    return d;
}

static uint64_t ssgi_gl__features(const ssgi_gl_desc *d)
{
    uint64_t f = d->orthographic ? SSGI_GL__ORTHOGRAPHIC : SSGI_GL__PERSPECTIVE;
    int blur = d->pass == SSGI_GL_BLUR, march = d->pass == SSGI_GL_HSAO && d->search == SSGI_GL_MARCH, slices = d->pass == SSGI_GL_HSAO && !march;
    int normals = !blur || d->filter == SSGI_GL_BILATERAL, depth = !blur || d->half || (normals && d->normal == SSGI_GL_NORMAL_FROM_DEPTH);
    f |= d->half ? SSGI_GL__HALF : SSGI_GL__FULL;
    if (depth || normals) f |= SSGI_GL__GBUFFER;
    if (depth) {
        f |= d->depth == SSGI_GL_DEPTH_WINDOW ? SSGI_GL__D_WINDOW : d->depth == SSGI_GL_DEPTH_LINEAR ? SSGI_GL__D_LINEAR : SSGI_GL__D_CUSTOM;
        if (d->depth != SSGI_GL_DEPTH_CUSTOM) f |= SSGI_GL__D_TEXTURE;
    }
    if (normals) {
        static const uint64_t how[] = { SSGI_GL__N_SIGNED | SSGI_GL__N_TEXTURE, SSGI_GL__N_UNSIGNED | SSGI_GL__N_TEXTURE, SSGI_GL__N_OCTA | SSGI_GL__N_TEXTURE,
                                        SSGI_GL__N_DEPTH | SSGI_GL__TOWARD, SSGI_GL__N_CUSTOM };
        f |= SSGI_GL__NORMALS | how[d->normal];
        if (d->normal != SSGI_GL_NORMAL_FROM_DEPTH) f |= d->world_normals ? SSGI_GL__N_WORLD : SSGI_GL__N_VIEW;
    }
    if (!blur) f |= d->noise == SSGI_GL_NOISE_TILE4 ? SSGI_GL__NOISE_TILE4 : d->noise == SSGI_GL_NOISE_GRADIENT ? SSGI_GL__NOISE_GRADIENT : SSGI_GL__NOISE_TEXTURE;
    if (slices) f |= SSGI_GL__TOWARD;
    if (march || slices) f |= d->hard ? SSGI_GL__HARD : SSGI_GL__LINEAR;
    if (march && d->normal_rays) f |= SSGI_GL__RAYS;
    if (d->pass == SSGI_GL_SSAO || (f & SSGI_GL__RAYS)) f |= SSGI_GL__BLOCKED;
    if (slices || (f & SSGI_GL__BLOCKED)) f |= d->thin ? SSGI_GL__THIN : SSGI_GL__SOLID;
    if (blur) f |= d->filter == SSGI_GL_GAUSSIAN ? SSGI_GL__GAUSSIAN : SSGI_GL__BILATERAL;
    if (blur && d->filter == SSGI_GL_BILATERAL && d->filter_normals) f |= SSGI_GL__F_NORMALS;
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
    int n;
    if (ssgi_gl_check(desc, NULL) != SSGI_OK) return 0;
    d = ssgi_gl__resolve(desc);
    f = ssgi_gl__features(&d);
    n = (f & SSGI_GL__N_DEPTH ? 4 : f & SSGI_GL__NORMALS ? 1 : 0) + (f & SSGI_GL__NOISE_TEXTURE ? 1 : 0);
    switch (d.pass) {
    case SSGI_GL_SSAO: return n + 1 + d.samples;
    case SSGI_GL_HSAO: return n + 1 + d.directions * d.steps * (d.search == SSGI_GL_SLICES ? 2 : 1 + d.normal_rays);
    default: {
        int side = 2 * d.filter_radius + 1;
        return n + side * side + (d.half ? 1 : 0) + (f & SSGI_GL__F_NORMALS ? n * (side * side - 1) : 0);
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
    return !strcmp(type, "mat3") ? 48 : !strcmp(type, "vec4") ? 16 : !strcmp(type, "float") ? 4 : 8;
}

/* The uniform block: members in the order of ssgi_gl_frame, gaps where this pass reads nothing. */
static void ssgi_gl__put_block(ssgi_gl__text *t, const ssgi_gl_io *io, int n, int bindings)
{
    size_t at = 0;
    int gaps = 0;
    for (;;) {
        const ssgi_gl_io *next = NULL;
        int i;
        for (i = 0; i < n; ++i)
            if (io[i].kind == SSGI_GL_PARAM && io[i].offset >= at && (!next || io[i].offset < next->offset)) next = &io[i];
        if (!next) break;
        if (!at && !gaps) ssgi_gl__put(t, bindings ? "layout(std140, binding = 0) uniform ssgi_frame {\n" : "layout(std140) uniform ssgi_frame {\n");
        for (; at < next->offset; ++gaps) {
            size_t gap = at % 16 == 0 && next->offset - at >= 16 ? 16 : 4;
            ssgi_gl__put(t, gap == 16 ? "    vec4 u_ssgi_gap" : "    float u_ssgi_gap");
            ssgi_gl__put_int(t, gaps);
            ssgi_gl__put(t, ";\n");
            at += gap;
        }
        ssgi_gl__put(t, "    ");
        ssgi_gl__put(t, next->type);
        ssgi_gl__put(t, " ");
        ssgi_gl__put(t, next->name);
        ssgi_gl__put(t, "; // ");
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
    if (dialect->es) ssgi_gl__put(t, "precision highp float;\nprecision highp int;\nprecision highp sampler2D;\n");
    for (i = 0; i < n; ++i) {
        if (io[i].kind != SSGI_GL_CONSTANT) continue;
        ssgi_gl__put(t, "const int ");
        ssgi_gl__put(t, io[i].name);
        ssgi_gl__put(t, " = ");
        ssgi_gl__put_int(t, io[i].slot);
        ssgi_gl__put(t, ";\n");
    }
    ssgi_gl__put_block(t, io, n, dialect->bindings);
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
    f.rotation[0] = f.rotation[5] = f.rotation[10] = 1.0f;
    *frame = f;
    return SSGI_OK;
}

#ifdef __cplusplus
}
#endif
#endif /* SSGI_GL_IMPLEMENTATION; the licence stands at the end of ssgi.h */
