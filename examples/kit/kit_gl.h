/* kit_gl.h - the GL half of the kit: headless contexts, GL functions, textures, the G-buffer. Not part of the library.

   Rows of textures run bottom-up, as GL has them; rows of kit_image run top-down. One context at a time, on one thread. */
#ifndef KIT_GL_H
#define KIT_GL_H

#include "kit.h"
#include <GL/glcorearb.h>

/* ---- >>functions -------------------------------------------------------------------------------------------- */

/* Every GL function that the kit loads, by the contexts that must have it. One that the context lacks is NULL.
   CORE: all contexts (GL 4.3, GLES 3.0). ES31: from GLES 3.1 on, and desktop. DESKTOP: never in GLES, save for
   glClipControl and glGetQueryObjectui64v, taken there from EXT_clip_control and EXT_disjoint_timer_query. */
#define KIT_GL_CORE(X) \
    X(ActiveTexture, ACTIVETEXTURE) X(AttachShader, ATTACHSHADER) X(BeginQuery, BEGINQUERY) X(BindBuffer, BINDBUFFER) \
    X(BindBufferBase, BINDBUFFERBASE) X(BindFramebuffer, BINDFRAMEBUFFER) X(BindTexture, BINDTEXTURE) X(BindVertexArray, BINDVERTEXARRAY) \
    X(BufferData, BUFFERDATA) X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS) X(ClearBufferfv, CLEARBUFFERFV) X(ColorMask, COLORMASK) \
    X(CompileShader, COMPILESHADER) X(CreateProgram, CREATEPROGRAM) X(CreateShader, CREATESHADER) X(DeleteBuffers, DELETEBUFFERS) \
    X(DeleteFramebuffers, DELETEFRAMEBUFFERS) X(DeleteProgram, DELETEPROGRAM) X(DeleteShader, DELETESHADER) X(DeleteTextures, DELETETEXTURES) \
    X(DeleteVertexArrays, DELETEVERTEXARRAYS) X(DepthFunc, DEPTHFUNC) X(DepthMask, DEPTHMASK) X(DepthRangef, DEPTHRANGEF) X(Disable, DISABLE) \
    X(DrawArrays, DRAWARRAYS) X(DrawBuffers, DRAWBUFFERS) X(Enable, ENABLE) X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY) X(EndQuery, ENDQUERY) \
    X(Finish, FINISH) X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D) X(GenBuffers, GENBUFFERS) X(GenFramebuffers, GENFRAMEBUFFERS) \
    X(GenQueries, GENQUERIES) X(GenTextures, GENTEXTURES) X(GenVertexArrays, GENVERTEXARRAYS) X(GetActiveUniformBlockiv, GETACTIVEUNIFORMBLOCKIV) \
    X(GetActiveUniformsiv, GETACTIVEUNIFORMSIV) X(GetError, GETERROR) X(GetFragDataLocation, GETFRAGDATALOCATION) \
    X(GetFramebufferAttachmentParameteriv, GETFRAMEBUFFERATTACHMENTPARAMETERIV) X(GetIntegerv, GETINTEGERV) X(GetProgramInfoLog, GETPROGRAMINFOLOG) \
    X(GetProgramiv, GETPROGRAMIV) X(GetShaderInfoLog, GETSHADERINFOLOG) X(GetShaderiv, GETSHADERIV) X(GetString, GETSTRING) X(GetStringi, GETSTRINGI) \
    X(GetUniformBlockIndex, GETUNIFORMBLOCKINDEX) X(GetUniformIndices, GETUNIFORMINDICES) X(GetUniformiv, GETUNIFORMIV) \
    X(GetUniformLocation, GETUNIFORMLOCATION) X(LinkProgram, LINKPROGRAM) X(PixelStorei, PIXELSTOREI) X(ReadPixels, READPIXELS) X(Scissor, SCISSOR) \
    X(ShaderSource, SHADERSOURCE) X(TexImage2D, TEXIMAGE2D) X(TexParameteri, TEXPARAMETERI) X(TexSubImage2D, TEXSUBIMAGE2D) X(Uniform1i, UNIFORM1I) \
    X(UniformBlockBinding, UNIFORMBLOCKBINDING) X(UniformMatrix4fv, UNIFORMMATRIX4FV) X(UseProgram, USEPROGRAM) \
    X(VertexAttribPointer, VERTEXATTRIBPOINTER) X(Viewport, VIEWPORT)
#define KIT_GL_ES31(X) \
    X(MemoryBarrier, MEMORYBARRIER)
#define KIT_GL_DESKTOP(X) \
    X(ClipControl, CLIPCONTROL) X(GetBufferSubData, GETBUFFERSUBDATA) X(GetQueryObjectui64v, GETQUERYOBJECTUI64V)
#if defined(__GNUC__)
#define KIT_GL_HIDDEN __attribute__((visibility("hidden")))   /* else Mesa's own calls could land on these pointers */
#else
#define KIT_GL_HIDDEN
#endif
#define KIT_GL_DECLARE(name, NAME) extern KIT_GL_HIDDEN PFNGL##NAME##PROC gl##name;
KIT_GL_CORE(KIT_GL_DECLARE)
KIT_GL_ES31(KIT_GL_DECLARE)
KIT_GL_DESKTOP(KIT_GL_DECLARE)
#undef KIT_GL_DECLARE

/* ---- >>gl --------------------------------------------------------------------------------------------------- */

/* Makes a headless context current and loads the functions; a context that is open is closed first. An empty vertex array is bound.
     "osmesa"  desktop GL core, on the CPU; the default when NULL
     "egl"     desktop GL core, on a GPU where there is one
     "egl-es"  GLES 3.2, 3.1 or 3.0, likewise */
int         kit_gl_open(const char *context, kit_error *err);
void        kit_gl_close(void);
const char *kit_gl_name(void);                    /* "renderer, version"; "" when nothing is open */
int         kit_gl_is_es(void);
int         kit_gl_is_software(void);

/* A 2D texture, NEAREST, CLAMP_TO_EDGE, one level. internal_format: R8 RG8 RGBA8, R16F RG16F RGBA16F, R32F RG32F RGBA32F,
   DEPTH_COMPONENT24, DEPTH_COMPONENT32F; 0 is returned for others. data: as many floats a texel as the format has components. */
GLuint      kit_texture(int width, int height, GLenum internal_format, const float *data_or_null);
/* Reads the lower left width x height texels, the first components of each (1..4). -1: the context cannot read this texture. */
int         kit_texture_read(GLuint texture, int width, int height, int components, float *out);

/* Compiles and links; 0 on failure. The shaders stay attached, so a caller that needs transform feedback names its varyings and links again. */
GLuint      kit_program(const char *const *source, const GLenum *stage, int count, kit_error *err);

/* Milliseconds of GL time between the two: a timer query on hardware, the clock around glFinish on software. No nesting. */
void        kit_timer_begin(void);
double      kit_timer_end(void);

/* ---- >>gbuffer ---------------------------------------------------------------------------------------------- */

typedef struct kit_gbuffer {
    int        width, height;              /* of the textures */
    int        viewport[4];                /* x, y, width, height of the picture in them; origin at the lower left */
    GLuint     depth;                      /* DEPTH_COMPONENT32F window depth, or R32F view depth (0 = background) */
    int        depth_is_linear;            /* 1 = the latter */
    GLuint     normal;                     /* RGBA32F, view space, toward the viewer; 0 = background */
    GLuint     albedo;                     /* RGBA16F; 0 = there is none */
    kit_camera camera;                     /* planes filled in */
    float      projection[16];             /* of the viewport */
} kit_gbuffer;

/* Rasterises a scene, both sides of every triangle. margin: left, bottom, right, top texels added around the picture, which hold the
   background; NULL = none. Leaves framebuffer 0 and program 0 bound, depth test off, clip control at GL's default. */
int  kit_gbuffer_from_scene(kit_gbuffer *gbuffer, const kit_scene *scene, const kit_camera *camera, const int margin[4], kit_error *err);

/* From a frame: channels Z (view depth; <= 0, NaN or infinite = background), N.X N.Y N.Z (view space; made unit; a zero normal is taken
   as +z) and perhaps albedo.R/G/B. The camera's size becomes the frame's; its planes, where 0, bracket Z. */
int  kit_gbuffer_from_frame(kit_gbuffer *gbuffer, const kit_image *frame, const kit_camera *camera, kit_error *err);

/* The inverse: Z, N.X, N.Y, N.Z and, where there is albedo, albedo.R/G/B of the viewport; background is 0 in all. */
int  kit_gbuffer_read(kit_image *frame, const kit_gbuffer *gbuffer, kit_error *err);
void kit_gbuffer_free(kit_gbuffer *gbuffer);

/* ---- >>method ----------------------------------------------------------------------------------------------- */

/* A setting of a method: what --set key=value takes. A choice takes one of its words, everything else a number in [least, most]. */
typedef struct kit_setting {
    const char *key, *about;
    const char *choices;                   /* "slices march": words for 0, 1 ..; NULL = a number */
    double      value, least, most;        /* value: the default */
    int         whole;                     /* takes whole numbers only */
} kit_setting;

#define KIT_MAX_SETTINGS 24
typedef struct kit_method {
    const char *name, *about;
    int         lit;                       /* 0: writes ambient visibility Y */
    int         count;
    kit_setting setting[KIT_MAX_SETTINGS];
} kit_method;

/* The i-th method with its settings at their defaults; 0 past the last. */
int  kit_method_at(kit_method *method, int i);
int  kit_method_find(kit_method *method, const char *name, kit_error *err);
/* "key=value"; several separated by commas. On failure nothing has changed. */
int  kit_method_set(kit_method *method, const char *text, kit_error *err);
double kit_method_value(const kit_method *method, const char *key);

#define KIT_MAX_PASSES 8
typedef struct kit_pass {
    ssgi_gl_desc desc;
    GLuint       program, framebuffer, texture;
    int          width, height;            /* of the target */
    double       ms;                       /* of the last kit_run_draw that was timed */
} kit_pass;

/* A method made ready on one G-buffer: programs, targets, uniforms. The G-buffer stays the caller's and must outlive it. */
typedef struct kit_run {
    const kit_gbuffer *gbuffer;
    ssgi_gl_frame      frame;              /* change it as you like before a draw, then kit_run_update */
    int                passes;
    kit_pass           pass[KIT_MAX_PASSES];
    GLuint             block, noise;
    double             fetches;            /* texel fetches a pixel of the picture, all passes */
} kit_run;

int  kit_run_open(kit_run *run, const kit_gbuffer *gbuffer, const kit_method *method, float radius, kit_error *err);
void kit_run_update(kit_run *run);         /* uploads run->frame */
void kit_run_draw(kit_run *run, int timed);
double kit_run_ms(const kit_run *run);     /* sum over the passes of the last timed draw */
int  kit_run_read(kit_image *out, const kit_run *run, kit_error *err);   /* the picture: Y */
void kit_run_close(kit_run *run);

/* Compiles both stages of a pass for the context that is open, with the dialect that suits it, and binds its samplers and block to their slots. */
GLuint kit_pass_program(const ssgi_gl_desc *desc, kit_error *err);
int    kit_dialect(void);

#endif
