/* kit_gl.h - the part of the kit that calls GL: headless contexts, GL functions, textures, the G-buffer. Not part
   of the library.

   Rows of textures run bottom-up, as GL has them, rows of kit_image top-down. One context at a time, on one thread. */
#ifndef KIT_GL_H
#define KIT_GL_H

#include "kit/kit.h"
#include "ssgi_gl.h"
#include <GL/glcorearb.h>

/* ---- >>functions -------------------------------------------------------------------------------------------- */

/* The GL functions that the kit loads, grouped by the contexts that must have them; those that a context lacks are
   NULL. CORE: all contexts (GL 4.3, GLES 3.0). ES31: from GLES 3.1 (PatchParameteri: 3.2) on, and desktop. DESKTOP:
   never in GLES, except for glClipControl and glGetQueryObjectui64v, which are then of EXT_clip_control and
   EXT_disjoint_timer_query. */
#define KIT_GL_CORE(X) \
    X(ActiveTexture, ACTIVETEXTURE) X(AttachShader, ATTACHSHADER) X(BeginQuery, BEGINQUERY) \
    X(BeginTransformFeedback, BEGINTRANSFORMFEEDBACK) X(BindBuffer, BINDBUFFER) X(BindBufferBase, BINDBUFFERBASE) \
    X(BindFramebuffer, BINDFRAMEBUFFER) X(BindTexture, BINDTEXTURE) X(BindVertexArray, BINDVERTEXARRAY) \
    X(BlendEquation, BLENDEQUATION) X(BlendFunc, BLENDFUNC) X(BufferData, BUFFERDATA) \
    X(CheckFramebufferStatus, CHECKFRAMEBUFFERSTATUS) X(ClearBufferfv, CLEARBUFFERFV) \
    X(ClearBufferuiv, CLEARBUFFERUIV) X(ColorMask, COLORMASK) X(CompileShader, COMPILESHADER) \
    X(CreateProgram, CREATEPROGRAM) X(CreateShader, CREATESHADER) X(CullFace, CULLFACE) \
    X(DeleteBuffers, DELETEBUFFERS) X(DeleteFramebuffers, DELETEFRAMEBUFFERS) X(DeleteProgram, DELETEPROGRAM) \
    X(DeleteQueries, DELETEQUERIES) X(DeleteShader, DELETESHADER) X(DeleteTextures, DELETETEXTURES) \
    X(DeleteVertexArrays, DELETEVERTEXARRAYS) X(DepthFunc, DEPTHFUNC) X(DepthMask, DEPTHMASK) \
    X(DepthRangef, DEPTHRANGEF) X(Disable, DISABLE) X(DrawArrays, DRAWARRAYS) \
    X(DrawArraysInstanced, DRAWARRAYSINSTANCED) X(DrawBuffers, DRAWBUFFERS) X(Enable, ENABLE) \
    X(EnableVertexAttribArray, ENABLEVERTEXATTRIBARRAY) X(EndQuery, ENDQUERY) \
    X(EndTransformFeedback, ENDTRANSFORMFEEDBACK) X(Finish, FINISH) X(FramebufferTexture2D, FRAMEBUFFERTEXTURE2D) \
    X(FramebufferTextureLayer, FRAMEBUFFERTEXTURELAYER) X(GenBuffers, GENBUFFERS) X(GenFramebuffers, GENFRAMEBUFFERS) \
    X(GenQueries, GENQUERIES) X(GenTextures, GENTEXTURES) X(GenVertexArrays, GENVERTEXARRAYS) \
    X(GetActiveUniformBlockiv, GETACTIVEUNIFORMBLOCKIV) X(GetActiveUniformsiv, GETACTIVEUNIFORMSIV) \
    X(GetError, GETERROR) X(GetFragDataLocation, GETFRAGDATALOCATION) \
    X(GetFramebufferAttachmentParameteriv, GETFRAMEBUFFERATTACHMENTPARAMETERIV) X(GetIntegerv, GETINTEGERV) \
    X(GetProgramInfoLog, GETPROGRAMINFOLOG) X(GetProgramiv, GETPROGRAMIV) X(GetQueryObjectuiv, GETQUERYOBJECTUIV) \
    X(GetShaderInfoLog, GETSHADERINFOLOG) X(GetShaderiv, GETSHADERIV) X(GetString, GETSTRING) \
    X(GetStringi, GETSTRINGI) X(GetUniformBlockIndex, GETUNIFORMBLOCKINDEX) X(GetUniformIndices, GETUNIFORMINDICES) \
    X(GetUniformLocation, GETUNIFORMLOCATION) X(GetUniformiv, GETUNIFORMIV) X(LinkProgram, LINKPROGRAM) \
    X(PixelStorei, PIXELSTOREI) X(ReadPixels, READPIXELS) X(Scissor, SCISSOR) X(ShaderSource, SHADERSOURCE) \
    X(TexImage2D, TEXIMAGE2D) X(TexImage3D, TEXIMAGE3D) X(TexParameteri, TEXPARAMETERI) \
    X(TexSubImage2D, TEXSUBIMAGE2D) X(TransformFeedbackVaryings, TRANSFORMFEEDBACKVARYINGS) X(Uniform1f, UNIFORM1F) \
    X(Uniform1fv, UNIFORM1FV) X(Uniform1i, UNIFORM1I) X(Uniform1iv, UNIFORM1IV) X(Uniform1ui, UNIFORM1UI) \
    X(Uniform2fv, UNIFORM2FV) X(Uniform2iv, UNIFORM2IV) \
    X(Uniform3fv, UNIFORM3FV) X(Uniform4fv, UNIFORM4FV) X(UniformBlockBinding, UNIFORMBLOCKBINDING) \
    X(UniformMatrix3fv, UNIFORMMATRIX3FV) X(UniformMatrix4fv, UNIFORMMATRIX4FV) \
    X(UseProgram, USEPROGRAM) X(VertexAttribDivisor, VERTEXATTRIBDIVISOR) X(VertexAttribPointer, VERTEXATTRIBPOINTER) \
    X(Viewport, VIEWPORT)
#define KIT_GL_ES31(X) \
    X(BindImageTexture, BINDIMAGETEXTURE) X(DispatchCompute, DISPATCHCOMPUTE) \
    X(GetTexLevelParameteriv, GETTEXLEVELPARAMETERIV) \
    X(MemoryBarrier, MEMORYBARRIER) X(PatchParameteri, PATCHPARAMETERI)
#define KIT_GL_DESKTOP(X) \
    X(ClipControl, CLIPCONTROL) X(GetBufferSubData, GETBUFFERSUBDATA) X(GetQueryObjectui64v, GETQUERYOBJECTUI64V) \
    X(TexImage2DMultisample, TEXIMAGE2DMULTISAMPLE)
#if defined(__GNUC__)
#define KIT_GL_HIDDEN __attribute__((visibility("hidden")))   /* else Mesa's own calls may be bound to these pointers */
#else
#define KIT_GL_HIDDEN
#endif
#define KIT_GL_DECLARE(name, NAME) extern KIT_GL_HIDDEN PFNGL##NAME##PROC gl##name;
KIT_GL_CORE(KIT_GL_DECLARE)
KIT_GL_ES31(KIT_GL_DECLARE)
KIT_GL_DESKTOP(KIT_GL_DECLARE)
#undef KIT_GL_DECLARE

/* ---- >>gl --------------------------------------------------------------------------------------------------- */

/* Makes a headless context current and loads the functions; an open context is closed first. An empty vertex array is
   bound.
     NULL      the environment variable KIT_CONTEXT, one of the names below; if it is not set, "osmesa", or the software
               device of EGL if there is no OSMesa (Mesa dropped it in 25.1)
     "osmesa"  desktop GL core, on the CPU
     "egl"     desktop GL core, with or without a display: the first EGL device that a GPU draws for, else surfaceless,
               else a software device
     "egl-es"  GLES 3.2, 3.1 or 3.0, on the same devices */
int         kit_gl_open(const char *context, kit_error *err);
/* Uses a context that is current already, such as a window's; proc returns the address of a GL function. GL 3.3
   suffices, without tessellation. Closing the kit leaves that context open; its owner closes the kit first. */
int         kit_gl_adopt(void (*(*proc)(const char *name))(void), kit_error *err);
void        kit_gl_close(void);
const char *kit_gl_name(void);                    /* returns "renderer, version"; "" when no context is open */
int         kit_gl_is_es(void);
int         kit_gl_is_software(void);

/* Makes a 2D texture: NEAREST, CLAMP_TO_EDGE, one level. internal_format: R8 RG8 RGBA8, R16F RG16F RGBA16F, R32F RG32F
   RGBA32F, R32UI RG32UI RGBA32UI, DEPTH_COMPONENT24, DEPTH_COMPONENT32F; for any other it returns 0. data: as many
   floats a texel as the format has components; for a UI format the pointer is to uint32_t. */
GLuint      kit_texture(int width, int height, GLenum internal_format, const float *data_or_null);
/* Makes a 2D array texture of so many layers; data is layer after layer. Draw into a layer with
   glFramebufferTextureLayer. */
GLuint      kit_texture_array(int width, int height, int layers, GLenum internal_format, const float *data_or_null);
void        kit_texture_linear(GLenum target);    /* sets the filters of the texture bound to target to LINEAR */
/* Reads the lower left width x height texels, the first `components` (1..4) of each. Returns -1 if the context cannot
   read this texture. */
int         kit_texture_read(GLuint texture, int width, int height, int components, float *out);
int         kit_texture_slice_read(GLuint array, int slice, int width, int height, int components, float *out);

/* Compiles and links a program; returns 0 on failure. The shaders stay attached, so a caller that needs transform
   feedback names its varyings and links again. */
GLuint      kit_program(const char *const *source, const GLenum *stage, int count, kit_error *err);
/* Makes a program of a vertex and a fragment shader. Before each go the #version line and precisions that suit the
   context, then head (#define lines or ""). */
GLuint      kit_program_text(const char *head, const char *vertex, const char *fragment, kit_error *err);

/* Keep programs in a cache by a hash of their source, as long as the context lives. kept returns 0 if it has none. */
GLuint      kit_program_kept(uint64_t key);
int         kit_program_keep(uint64_t key, GLuint program, kit_error *err);
GLuint      kit_program_kept_text(const char *head, const char *vertex, const char *fragment, kit_error *err);

/* Draws count vertices, uploaded once, with interleaved vec3 attributes 0, 1 ..: opaque, both sides, all channels
   written, depth test LESS. Resting restores the previous vertex array and sets framebuffer 0, program 0, no depth test
   and no scissor test, until the soup is used again; closing does the same. */
typedef struct kit_soup { GLuint vertex_array, buffer; GLint vertex_array_was; } kit_soup;
void        kit_soup_open(kit_soup *soup, const float *vertices, size_t count, int attributes);
void        kit_soup_rest(kit_soup *soup);
void        kit_soup_use(kit_soup *soup);
void        kit_soup_close(kit_soup *soup);

/* Measure the milliseconds of GL time between begin and end: by a timer query on hardware, by the clock around glFinish
   in software. No nesting. */
void        kit_timer_begin(void);
double      kit_timer_end(void);
const char *kit_timer_name(void);                 /* returns "timer queries" or "the clock" */

/* ---- >>gbuffer ---------------------------------------------------------------------------------------------- */

typedef struct kit_gbuffer {
    int        width, height;              /* of the textures */
    int        viewport[4];         /* x, y, width, height of the image within the textures; origin at the lower left */
    GLuint     depth;                      /* DEPTH_COMPONENT32F window depth, or R32F view depth (0 = background) */
    int        depth_is_linear;            /* 1 = the latter */
    /* RGBA32F, view space, toward the viewer; 0 = background. Texture 0: normals are derived from depth */
    GLuint     normal;
    GLuint     albedo;                     /* RGBA16F; texture 0: none */
    /* R32UI, number of the object that the first layer shows (kit_mesh), 0 = no object. Texture 0: frames have none */
    GLuint     object;
    kit_camera camera;                     /* planes filled in */
    float      projection[16];             /* of the viewport */
    /* RGBA32F, outgoing radiance of the first layer. Texture 0: there is none; only frames have it */
    GLuint     direct;
    /* 1 if not peeled. The second, third .. depth layers are array layers 0, 1 .. of these textures: */
    int        layers;
    /* in the formats of depth, normal and albedo; normals of even layers point away from the viewer */
    GLuint     layer_depth, layer_normal, layer_albedo;
    /* back: the nearest back face, in the format of depth. slabs: RGBA32F, the depths of the nearest back face, of the
       next front face behind it, and of the next back face behind that. Texture 0: not drawn */
    GLuint     back, slabs;
    double     slab_ms[2];                 /* milliseconds that drawing back and slabs took; 0 with a frame */
    GLuint     motion;                     /* RG32F, pixels that a point moved since the last frame; 0: none */
} kit_gbuffer;

/* Rasterises both sides of every triangle of a scene. margin: texels of background that are added at the left, bottom,
   right and top of the picture; NULL = none. Leaves framebuffer 0 and program 0 bound, depth test off, clip control at
   GL's default. */
int kit_gbuffer_from_scene(kit_gbuffer *gbuffer, const kit_scene *scene, const kit_camera *camera, const int margin[4],
                           kit_error *err);

/* kit_mesh_keep uploads a scene's triangles once, for the G-buffers and shadow maps of many frames. Call
   kit_mesh_forget before the triangles change or are freed, and before the context closes. One mesh at a time. */
int  kit_mesh_keep(const kit_mesh *mesh, kit_error *err);
void kit_mesh_forget(void);
/* Returns the kept mesh, ready to be drawn by attribute 0, its position, until kit_soup_rest; NULL: not kept. */
kit_soup *kit_mesh_kept(const kit_mesh *mesh);

/* Draws a G-buffer of the same view, `pixels` wider on each side; near and far planes and depth layout stay. */
int  kit_gbuffer_widen(kit_gbuffer *wide, const kit_gbuffer *gbuffer, const kit_scene *scene, int pixels,
    kit_error *err);

/* Peels depth [Everitt 2001]: replaces the second and farther layers of a G-buffer that came from this scene, up to
   `layers` layers in all [limit: 1..KIT_MAX_LAYERS]. A surface is of the next layer if it is more than 4e-6 of its view
   depth behind the last layer, so none is peeled against itself. Normals of odd layers (1st, 3rd ..) are turned toward
   the viewer, of even layers away: both sides of a closed solid face open space. Leaves GL as kit_gbuffer_from_scene
   does, and no 2D texture bound to unit 0. */
#define KIT_MAX_LAYERS 8
int  kit_gbuffer_peel(kit_gbuffer *gbuffer, const kit_scene *scene, int layers, kit_error *err);

/* Draws a G-buffer's back faces, by winding (counter-clockwise is the front), from the scene that it came from. slabs
   1: only the nearest, one draw of the scene; 2: slabs, three draws. Leaves GL as kit_gbuffer_from_scene does. */
int  kit_gbuffer_slabs(kit_gbuffer *gbuffer, const kit_scene *scene, int slabs, kit_error *err);

/* Gives channels of another program's frame the names that kit_gbuffer_from_frame takes: channel[i] is "Z=THEIRS". If
   there is no Z then, those of Blender's view layer `layer` (NULL: the only one): LAYER.Depth.Z (background from 9e9
   on); .Normal.X .., in world space, which the camera turns if placed says that it is known; .DiffCol.R .., .DiffDir.R
   .. */
int  kit_frame_rename(kit_image *frame, const char *const *channel, int channels, const char *layer,
                      const kit_camera *camera, int placed, kit_error *err);

/* Makes a G-buffer from a frame. Channels: Z (view depth; <= 0, NaN or infinite = background), N.X N.Y N.Z (view space;
   made unit; a zero normal becomes +z, -z in even layers; a frame of one layer may lack them). Optional: albedo.R/G/B;
   layer1.Z, layer1.N.X .. of the second layer, layer2.Z .. of the third, up to KIT_MAX_LAYERS; direct.R/G/B (values
   that are not finite or below 0 become 0); back.Z, or back.Z, front2.Z and back2.Z (view depth, 0 = no such face). The
   camera takes the frame's size, and planes around Z if its own are 0. */
int  kit_gbuffer_from_frame(kit_gbuffer *gbuffer, const kit_image *frame, const kit_camera *camera, kit_error *err);

/* Reads a G-buffer back as a frame, without the margin: the channels of all layers that kit_gbuffer_from_frame takes,
   direct.R/G/B and slabs if the G-buffer has them; background is 0 in all. */
int  kit_gbuffer_read(kit_image *frame, const kit_gbuffer *gbuffer, kit_error *err);
int  kit_gbuffer_read_depth(kit_image *frame, const kit_gbuffer *gbuffer, kit_error *err);     /* Z alone */
void kit_gbuffer_free(kit_gbuffer *gbuffer);

/* ---- >>shadow ----------------------------------------------------------------------------------------------- */

typedef struct kit_shadow_camera {
    /* from world to light view (the camera looks along -z); to GL's clip space, perspective or orthographic */
    float view[16], projection[16];
    int   tile[4];                         /* x, y, width, height in texels of the atlas */
} kit_shadow_camera;

/* Draws a DEPTH_COMPONENT32F atlas of shadow maps of both sides of every triangle, 1 where nothing is. Tiles must be
   inside it; where tiles overlap the nearest depth stays. 0 on failure. Leaves GL as kit_gbuffer_from_scene does. */
GLuint kit_shadow_atlas(int width, int height, const kit_scene *scene, const kit_shadow_camera *camera, int count,
                        kit_error *err);

/* Renders a light's reflective shadow map [Dachsbacher and Stamminger 2005] as three arrays of 3 floats a pixel, which
   the caller frees: world position; world normal (unit, toward the light); reflected flux = albedo * the light's power
   that falls on the pixel. POINT: six cube faces of resolution x resolution pixels, power = intensity * the pixel's
   exact solid angle; surfaces nearer than 1e-4 of the bounds' diagonal are not seen. SUN: one orthographic map around
   the scene's bounds, power = irradiance * the pixel's area. Empty pixels are 0. resolution [limit: 1..4096]. */
int kit_rsm(float **position, float **normal, float **flux, size_t *pixels, const kit_scene *scene,
            const kit_light *light, int resolution, kit_error *err);

/* ---- >>field ------------------------------------------------------------------------------------------------ */

/* Returns the field of a shape, baked on all cores when it is first asked for, then kept until kit_fields_free. NULL on
   failure. seconds: the time of the bake; may be NULL. desc's callbacks are ignored. */
const ssgi_field *kit_field(const kit_mesh *shape, const ssgi_field_desc *desc, double *seconds, kit_error *err);
void   kit_fields_free(void);
/* Writes the number of pixels that each occluder's field reaches, summed over the occluders, over all pixels. */
int    kit_fields_cover(double *share, const kit_image *frame, const kit_camera *camera, const kit_scene *scene,
                        const ssgi_field_desc *desc, kit_error *err);
/* Makes the texture t_ssgi_fields: count fields, one in each array layer. */
GLuint kit_field_atlas(const ssgi_field *const *field, int count);

/* ---- >>method ----------------------------------------------------------------------------------------------- */

/* The settings of --set, resolved: each member has the name of its key; --list says what it means to its method. A
   method that lacks a key has 0 there. A choice is a number in the order of its words: these, or the library's
   (SSGI_GL_THICKNESS_ .. of thickness, SSGI_GL_SHADOW_ .. of shadows, SSGI_SH_WINDOW_ .. of window). */
enum { KIT_ENVIRONMENT_MAP, KIT_ENVIRONMENT_SH, KIT_ENVIRONMENT_NONE };
enum { KIT_STORE_HALF, KIT_STORE_PACKED, KIT_STORE_FLOAT };
enum { KIT_INDIRECT_NONE, KIT_INDIRECT_JOINT, KIT_INDIRECT_APART };
enum { KIT_FILTERED_COEFFICIENTS, KIT_FILTERED_LIGHT };
enum { KIT_LIGHTS_HARMONICS, KIT_LIGHTS_SHADOWED };
enum { KIT_OCCLUDERS_SOLID, KIT_OCCLUDERS_ALL };
enum { KIT_WAY_CPU, KIT_WAY_CAPTURE, KIT_WAY_DIRECT };
typedef struct kit_settings {
    /* these members choose the samples of a gather */
    int    slices, directions, samples, normal_rays, march_terms, growing_sphere, sets, uniform_directions;
    int    resolution, range_check, noise;
    double offset, phase;                  /* offset: in half pixels; phase: of the noise, [0, 1] */
    int    layers, views, view_layers, view_size;
    double margin;                         /* radii */
    /* how much they occlude */
    int    thickness, falloff, fade, normal, left_handed, facets, lift;
    double thickness_limit, fade_from, lambda;   /* in radii; in radii; a rate of decay per radius */
    /* filters */
    int    blur, filter, filter_normals, restore, history;
    /* light */
    int    environment, bounce, reuse, bounced, two_sided, one_sided, shadows, points, solid, shadow_size, suns, vpls;
    double clamp, distance_clamp, gain, max_slope;    /* a luminance; in radii; a factor of a sample's area; a slope */
    /* settings of methods of light as spherical harmonics, or by bent normals */
    int    bands, store, indirect, occluded_emitters, filtered, residual, window, lights, cone, lobes;
    /* fields */
    int    field_resolution, radii, rays, unfiltered, own, occluders;
    int    cap_table;                      /* width and height of t_ssgi_cap in texels; 0: closed form */
    double reach, ramp, inside, power;    /* in bounding spheres' radii; of the reach; below 0: measured; an exponent */
    /* surfels */
    int    levels, way, near_samples, span, sky, near_depth, keep_small, splits, smooth, material;
    int    overhang, enlarge, combine;
    double size, epsilon, offscreen_growth, exponent, unit;    /* size: image heights; unit: world units per mm */
} kit_settings;

/* A setting of a method, as --list shows it and --set key=value takes it. A choice takes one of its words, any other
   setting a number in [least, most]. */
typedef struct kit_setting {
    const char *key, *about;
    const char *choices;                   /* words for 0, 1 .., as "SLICES MARCH", in any case; NULL = a number */
    double      value, least, most;        /* value: the method's present one, at first the default */
    int         whole;                     /* takes whole numbers only */
} kit_setting;

typedef struct kit_method {
    const char  *name, *about;
    int          number;                   /* index in kit_method_at and in ssgi_gl_method_at */
    const struct plan *plan;               /* its settings */
    int          pass, effect;             /* SSGI_GL_PASS_SSAO ..; for surfels, SSGI_GL_EFFECT_OCCLUSION .. */
    int          lit;                      /* 0: writes ambient visibility Y; 1: writes light */
    int          between;                /* 1: occlusion by other objects only; its ground truth is kit_truth_objects */
    const char  *custom;                   /* for methods of surfels: GLSL for SSGI_GL_EFFECT_CUSTOM */
    kit_settings set;
} kit_method;

/* Writes the i-th method with its settings at their defaults; returns 0 past the last. */
int  kit_method_at(kit_method *method, int i);
int  kit_method_find(kit_method *method, const char *name, kit_error *err);
/* Sets "key=value", or several separated by commas. On failure nothing has changed. */
int  kit_method_set(kit_method *method, const char *text, kit_error *err);
int  kit_method_setting(kit_setting *setting, const kit_method *method, int i);  /* the i-th; returns 0 past the last */
/* Writes the word of a setting's number, in small letters, as kit_method_set takes it. Returns its length. */
size_t kit_setting_word(char *out, size_t size, const kit_setting *setting, int number);
/* Writes the settings that differ from the method's defaults, as kit_method_set takes them; "" if there are none. */
void kit_method_text(char *text, size_t size, const kit_method *method);
ssgi_field_desc kit_method_field(const kit_method *method);    /* returns the desc of a bake by the settings of aof */
/* Returns the number of surfel levels for a radius in image heights. Half the radius suffices if occlusion fades with
   distance; light does not fade, and has a larger error with any other number. */
int  kit_method_levels(const kit_method *method, double radius);
int  kit_method_attenuation(const kit_method *method);         /* KIT_ATTENUATION_.. of its occluders */
/* Ray-traces the ground truth of a method's result, by kit_truth_ao and its like; for dss-scatter, rays counts
   thousands of samples. */
int  kit_method_truth(kit_image *out, const kit_method *method, const kit_scene *scene, const kit_camera *camera,
                      const kit_lighting *lighting, float radius, int rays, int stride, kit_error *err);

/* Inputs of a method beyond the G-buffer: the scene, for peeling, extra cameras and shadow maps (NULL with a frame),
   and light, for lit methods (NULL = none). */
typedef struct kit_world { const kit_scene *scene; const kit_lighting *lighting; } kit_world;

enum { KIT_MAX_TARGETS = 6, KIT_HISTORIES = 2, KIT_MAX_PASSES = 128, KIT_MAX_TEXTURES = 192, KIT_MAX_VIEWS = 4,
       /* indices of uniform buffers: one for the image's frame, two for each extra camera, then these */
       KIT_FRAME_VPLS = 1 + 2 * KIT_MAX_VIEWS, KIT_FRAME_VIEWS, KIT_FRAMES };
typedef struct kit_pass {
    ssgi_gl_desc       desc;
    const kit_gbuffer *gbuffer;
    ssgi_gl_step      *step;     /* a step of the chain; its desc is the pass's, unless a test gives the pass another */
    /* textures that it writes, by slot; if target[0] is 0, it draws into a layer of the array texture slices */
    GLuint             program, framebuffer, target[KIT_MAX_TARGETS], slices;
    GLuint             input[16];          /* textures of inputs that other steps wrote; 0: any other input */
    GLuint             last[KIT_HISTORIES]; /* with history: the outputs of this pass in the last frame */
    GLuint             lights;             /* t_ssgi_lights or t_ssgi_occluders */
    int                instances;          /* field: occluders */
    GLuint             array, capture; /* for surfels and splats: vertex array; buffer that transform feedback writes */
    /* numbers of triangles drawn whole, and of those split into splits^2 parts; 0: the run's surfels are drawn */
    int                patches[2], splits;
    int                aside;              /* 1: computes a part of the result, for tests; not timed nor counted */
    int                width, height;
    int                box[4];             /* x, y, width, height of the part of its targets that is drawn; 0 = all */
    ssgi_gl_io        *io;                 /* the pass's inputs and outputs: a table of `rows` rows */
    int                rows;
    double             ms;                 /* milliseconds in the last kit_run_draw with KIT_PASSES */
} kit_pass;

/* ---- >>run -------------------------------------------------------------------------------------------------- */

/* A method that is ready to draw on one G-buffer: programs, targets, uniforms, and its inputs from the world. The
   caller keeps the G-buffer, which must outlive the run. */
typedef struct kit_run {
    kit_gbuffer  *gbuffer;
    ssgi_gl_frame frame;                   /* change it as you like before a draw, then call kit_run_update */
    int           lit, passes, textures, views, vpls;
    kit_pass      pass[KIT_MAX_PASSES];
    ssgi_gl_chain chain[2];                /* the chains of these passes, without passes that are aside */
    int           chains;
    /* textures of the result: ambient visibility, or irradiance over pi; and the bounce's irradiance over pi */
    GLuint        light, bounce;
    GLuint        texture[KIT_MAX_TEXTURES];   /* all textures that the run frees */
    GLuint        normal;               /* if left_handed is set: normals with z negated; 0 = the G-buffer's are read */
    GLuint        noise, kernel, environment, irradiance, view_depth, atlas, grey, cap;
    GLuint        block[KIT_FRAMES];
    kit_gbuffer   view[KIT_MAX_VIEWS];     /* of the extra cameras */
    int           margin;                  /* pixels beyond each side of the picture that a gather sees */
    kit_gbuffer   wide;                    /* with a margin: the G-buffer that replaces the caller's */
    /* the extra cameras' frames; then the same with the rotation from their view space to that of the main camera */
    ssgi_gl_frame extra[2 * KIT_MAX_VIEWS];
    ssgi_gl_views cameras;
    GLuint        fields;                  /* for fields: those of all shapes as one array texture */
    int           occluders;
    size_t        surfels;                 /* in the splats' buffer */
    /* predicted number of pixels of all splats in the first pass of splats; and of each surfel level */
    double        splat_pixels, level_pixels[SSGI_SPLAT_LEVELS];
    GLuint        arrays[3], buffers[3], query;
    size_t        field_bytes;             /* memory of fields */
    GLuint        joint;                   /* texture of a term that is also added to bounce; 0 = none */
    /* radiance of the environment, three floats a texel; its harmonics, which with s3ho include suns */
    float        *equirect, harmonics[48];
    /* bytes that all passes move, for each pixel of the image. Each pass reads each texel of its inputs once (of
       farther layers, only those that it uses) and writes each of its outputs once, in their stored formats; splats
       read each surfel once, and read and write each texel that they cover. NAN: the context cannot count those */
    double        bytes;
    double        ms;                      /* milliseconds of the last kit_run_draw that timed the frame */
} kit_run;

/* Makes a run ready. If the world has a scene, peels the G-buffer as the method asks. With the setting margin a larger
   G-buffer is drawn, and the frame has its size. The margin is the radius times that setting, projected at the median
   depth of the picture's border, rounded up to a multiple of 4 pixels (so that pixels of half resolution and tiles of
   noise stay in place), at most a quarter of the picture's shorter side. A scissor limits passes to the picture and the
   reach of its filters, except for emitters of light and the light that falls on them. */
int kit_run_open(kit_run *run, kit_gbuffer *gbuffer, const kit_method *method, float radius, const kit_world *world,
                 kit_error *err);
void kit_run_update(kit_run *run);         /* uploads run->frame */
/* How a draw is timed. KIT_PASSES: each pass by a timer of its own, which waits for all passes before it. KIT_FRAME:
   all in one, as an engine's frame; passes that only show a part of the result are then not drawn. */
enum { KIT_UNTIMED, KIT_PASSES, KIT_FRAME };
void kit_run_draw(kit_run *run, int timed);
double kit_pass_bytes(const kit_run *run, const kit_pass *pass);   /* the pass's bytes in one frame; see run->bytes */
/* Returns the texture that inputs of that name read in the run; 0: no pass reads it. instead, if not 0, replaces it. */
GLuint kit_run_input(kit_run *run, const char *name, GLuint instead);
double kit_run_ms(const kit_run *run);     /* returns the sum over the passes of the last timed draw */
/* Reads the result: Y; or R G B (outgoing radiance, with albedo 0.8 if there is none), irradiance.R .., bounce.R ..
   (irradiance over pi, before albedo). */
int  kit_run_read(kit_image *out, const kit_run *run, kit_error *err);
void kit_run_close(kit_run *run);          /* frees and zeroes all of it; also without a context, or if it is zero */
/* Draws one image by a method's name and its settings, for kit_method_set: opens, draws, reads, closes a run. */
int  kit_run_picture(kit_image *out, kit_gbuffer *gbuffer, const kit_world *world, const char *method, const char *set,
                     float radius, kit_error *err);

/* ---- >>frames ----------------------------------------------------------------------------------------------- */

/* Makes a run, before it is drawn, the frame after last's. last is a run of the same method on an image of any size; it
   must not be drawn again, because the run takes its history. It may be the run itself, once drawn. */
int  kit_run_follow(kit_run *run, kit_run *last, unsigned frame, kit_error *err);
int  kit_run_keeps(const kit_run *run);    /* returns 1 if one of its passes averages over frames */

/* Draws a method on one G-buffer after another. Set it all to zero first; close it whether or not a call failed. */
typedef struct kit_frames {
    kit_run  run[2];
    kit_run *now;                       /* the run of the present frame, which the caller draws and reads; NULL: none */
    unsigned number;                       /* index of the next frame, which selects its noise; the first may be any */
    unsigned since;                        /* number of consecutive frames up to now, including the present one */
    /* duration of the next frame in 60ths of a second; KIT_MEMORY of these are averaged. 0: 16 frames are averaged */
    float elapsed, took;                   /* took: set by kit_frames_next */
    int jittered;                          /* 1: camera.shift is jitter of the projection, not motion */
} kit_frames;
#define KIT_MEMORY 16.0f

/* Opens the next frame. If the method keeps history, it follows the last frame, with its margin. History begins anew if
   the passes differ, and after kit_frames_close, which the caller calls before it shows another scene. The last frame
   is closed here; its G-buffer must live until then. alone: gets the frame's picture with the same noise, without
   history; may be NULL. On failure all is closed. */
int  kit_frames_next(kit_frames *frames, kit_gbuffer *gbuffer, const kit_method *method, float radius,
                     const kit_world *world, kit_image *alone, kit_error *err);
/* Begins the next frame on the same G-buffer, once `now` is drawn; no run is opened. */
int  kit_frames_again(kit_frames *frames, kit_error *err);
void kit_frames_close(kit_frames *frames); /* may be called again */
/* Draws frame k, numbered first + k, of a picture that does not change. If history is kept, the run follows itself from
   k = 1 on; k = 0 begins anew. */
int  kit_frames_still(kit_run *run, unsigned first, unsigned k, int timed, kit_error *err);

/* ---- >>plan: measures a scene for the planner --------------------------------------------------------------- */

/* Measures a picture for ssgi_plan_make, all its numbers except error, budget, device and history: a survey; if there
   is a scene, a calibration by ray tracing and the cost of its surfels; the environment's harmonics. */
int kit_plan_numbers(ssgi_plan_scene *numbers, kit_gbuffer *gbuffer, const kit_world *world, float radius, int wanted,
                     kit_error *err);
/* kit_plan_chain writes a plan as a chain: the desc of ssgi_gl_plan, and the members that it leaves to its caller.
   kit_plan_method writes it as a method. Both fail for a plan of NOTHING. */
int  kit_plan_chain(ssgi_gl_chain *chain, const ssgi_plan *plan, int wanted, kit_error *err);
int  kit_plan_method(kit_method *method, const ssgi_plan *plan, int wanted, kit_error *err);
/* Returns that method's name; NULL for NOTHING. set gets what differs from its defaults, for kit_method_set. */
const char *kit_plan_text(char set[256], const ssgi_plan *plan, int wanted);
/* Returns an image's error as plans define it, over pixels that show a surface and whose ground truth is known (not
   NAN): the RMSE of Y; or that of irradiance, or of irradiance and bounce, over their mean. */
double kit_plan_error(const kit_image *picture, const kit_image *truth, const kit_image *frame, int wanted);
/* Turns ambient visibility (channel Y) into light (KIT_LIT_CHANNELS): the light of open surfaces times visibility,
   except for direct, which is not dimmed (NULL: none). */
int  kit_dim(kit_image *visibility, const kit_image *open, const kit_image *direct, kit_error *err);
/* Turns ambient visibility into light: the environment's on open surfaces, dimmed, and lights with their shadows. */
int  kit_light_by(kit_image *visibility, kit_gbuffer *gbuffer, const kit_world *world, float radius, kit_error *err);

/* ---- >>passes ----------------------------------------------------------------------------------------------- */

/* Compiles all stages of a pass in the dialect of the open context, and binds its samplers and block to their slots. */
GLuint kit_pass_program(const ssgi_gl_desc *desc, kit_error *err);
/* Binds the samplers and block of a program that has the rows of a pass. */
void   kit_pass_bind(GLuint program, const ssgi_gl_io *io, int rows);
/* Sets a pass's table of inputs and outputs by its desc, and links its program if it has none. */
int    kit_pass_make(kit_pass *pass, kit_error *err);
int    kit_dialect(void);
/* Returns SSGI_GL_COMPUTE_ALL if KIT_COMPUTE is in the environment, or SSGI_GL_COMPUTE_BASIC if it is "BASIC", and the
   context is desktop GL: gathers and filters, except those of surfels and fields, are then compute stages. */
int    kit_compute(void);

#endif
