/* kit_gl.h - the GL half of the kit: headless contexts, GL functions, textures, the G-buffer. Not part of the library.

   Rows of textures run bottom-up, as GL has them; rows of kit_image run top-down. One context at a time, on one
   thread. */
#ifndef KIT_GL_H
#define KIT_GL_H

#include "kit/kit.h"
#include "ssgi_gl.h"
#include <GL/glcorearb.h>

/* ---- >>functions -------------------------------------------------------------------------------------------- */

/* Every GL function that the kit loads, by the contexts that must have it. One that the context lacks is NULL.
   CORE: all contexts (GL 4.3, GLES 3.0). ES31: from GLES 3.1 (PatchParameteri: 3.2) on, and desktop. DESKTOP: never in
   GLES, save for glClipControl and glGetQueryObjectui64v, taken there from EXT_clip_control and
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

/* Makes a headless context current and loads the functions; a context that is open is closed first. An empty vertex
   array is bound.
     NULL      KIT_CONTEXT of the environment, which is one of those below; without it "osmesa"; where there is none, as
               Mesa dropped it in 25.1, what the CPU draws through EGL
     "osmesa"  desktop GL core, on the CPU
     "egl"     desktop GL core, on a GPU where there is one, with or without a display: the first EGL device that a GPU
               draws for, else surfaceless, else a software device
     "egl-es"  GLES 3.2, 3.1 or 3.0, likewise */
int         kit_gl_open(const char *context, kit_error *err);
/* The same of a context that is current already, as a window's is; proc: the address of a GL function. GL 3.3 is
   enough, without tessellation. Closing leaves that context to who made it, who closes the kit first. */
int         kit_gl_adopt(void (*(*proc)(const char *name))(void), kit_error *err);
void        kit_gl_close(void);
const char *kit_gl_name(void);                    /* "renderer, version"; "" when nothing is open */
int         kit_gl_is_es(void);
int         kit_gl_is_software(void);

/* A 2D texture, NEAREST, CLAMP_TO_EDGE, one level. internal_format: R8 RG8 RGBA8, R16F RG16F RGBA16F, R32F RG32F
   RGBA32F, R32UI RG32UI RGBA32UI, DEPTH_COMPONENT24, DEPTH_COMPONENT32F; 0 is returned for others. data: as many floats
   a texel as the format has components; of the UI formats their bits, so uint32_t behind the pointer. */
GLuint      kit_texture(int width, int height, GLenum internal_format, const float *data_or_null);
/* The same with layers slices, a 2D array; data slice after slice. Draw into one with glFramebufferTextureLayer. */
GLuint      kit_texture_array(int width, int height, int layers, GLenum internal_format, const float *data_or_null);
void        kit_texture_linear(GLenum target);    /* the texture bound there filters */
/* Reads the lower left width x height texels, the first components of each (1..4). -1: the context cannot read this
   texture. */
int         kit_texture_read(GLuint texture, int width, int height, int components, float *out);
int         kit_texture_slice_read(GLuint array, int slice, int width, int height, int components, float *out);

/* Compiles and links; 0 on failure. The shaders stay attached, so a caller that needs transform feedback names its
   varyings and links again. */
GLuint      kit_program(const char *const *source, const GLenum *stage, int count, kit_error *err);
/* The same of a vertex and a fragment stage, each after the #version line and precisions that suit the context, then
   head (#define lines or ""). */
GLuint      kit_program_text(const char *head, const char *vertex, const char *fragment, kit_error *err);

/* Programs that live as long as the context, by a hash of their texts: compiled once. kept: 0 = there is none. */
GLuint      kit_program_kept(uint64_t key);
int         kit_program_keep(uint64_t key, GLuint program, kit_error *err);
GLuint      kit_program_kept_text(const char *head, const char *vertex, const char *fragment, kit_error *err);

/* Opaque drawing of count vertices: vec3 attributes 0, 1 .. interleaved, uploaded once; both sides, all written, depth
   test LESS. Resting goes back to the vertex array before, framebuffer 0 and program 0, depth and scissor test off,
   until it is used again; closing does the same. */
typedef struct kit_soup { GLuint vertex_array, buffer; GLint vertex_array_was; } kit_soup;
void        kit_soup_open(kit_soup *soup, const float *vertices, size_t count, int attributes);
void        kit_soup_rest(kit_soup *soup);
void        kit_soup_use(kit_soup *soup);
void        kit_soup_close(kit_soup *soup);

/* Milliseconds of GL time between the two: a timer query on hardware, the clock around glFinish on software. No
   nesting. */
void        kit_timer_begin(void);
double      kit_timer_end(void);
const char *kit_timer_name(void);                 /* which: "timer queries", "the clock" */

/* ---- >>gbuffer ---------------------------------------------------------------------------------------------- */

typedef struct kit_gbuffer {
    int        width, height;              /* of the textures */
    int        viewport[4];                /* x, y, width, height of the picture in them; origin at the lower left */
    GLuint     depth;                      /* DEPTH_COMPONENT32F window depth, or R32F view depth (0 = background) */
    int        depth_is_linear;            /* 1 = the latter */
    /* RGBA32F, view space, toward the viewer; 0 = background. 0 = there is none: then of depth alone */
    GLuint     normal;
    GLuint     albedo;                     /* RGBA16F; 0 = there is none */
    /* R32UI, number of the object that the first layer shows (kit_mesh), 0 = none; 0 = there is none (frames bring
       none) */
    GLuint     object;
    kit_camera camera;                     /* planes filled in */
    float      projection[16];             /* of the viewport */
    /* RGBA32F, outgoing radiance of the first layer; 0 = there is none (only frames bring it) */
    GLuint     direct;
    /* 1 when not peeled. The second, third .. layer are slices 0, 1 .. of these 2D arrays: */
    int        layers;
    /* kinds as above; normals of even layers point away from the viewer */
    GLuint     layer_depth, layer_normal, layer_albedo;
    /* of depth's kind: the nearest back face. RGBA32F: that; the next front face behind it; the next back face
       behind that. 0 = there is none */
    GLuint     back, slabs;
    double     slab_ms[2];                 /* what drawing those took; frames: 0 */
    GLuint     motion;                     /* RG32F, pixels from where a point was to where it is; 0 = there is none */
} kit_gbuffer;

/* Rasterises a scene, both sides of every triangle. margin: left, bottom, right, top texels added around the picture,
   which hold the background; NULL = none. Leaves framebuffer 0 and program 0 bound, depth test off, clip control at
   GL's default. */
int kit_gbuffer_from_scene(kit_gbuffer *gbuffer, const kit_scene *scene, const kit_camera *camera, const int margin[4],
                           kit_error *err);

/* For who draws many frames of one scene: its triangles are uploaded once, for G-buffers and shadow maps, until they
   are forgotten, which is due before they change, are freed, or the context closes. One mesh at a time. */
int  kit_mesh_keep(const kit_mesh *mesh, kit_error *err);
void kit_mesh_forget(void);
/* That mesh ready to be drawn, its position as attribute 0, until kit_soup_rest; NULL: it is not kept. */
kit_soup *kit_mesh_kept(const kit_mesh *mesh);

/* The same view of a scene, so many pixels wider on each side; planes and depth layout as they are. */
int  kit_gbuffer_widen(kit_gbuffer *wide, const kit_gbuffer *gbuffer, const kit_scene *scene, int pixels,
    kit_error *err);

/* Depth peeling [Everitt 2001]: makes the second and farther layers, up to layers [limit: 1..KIT_MAX_LAYERS] of them in
   all, of a G-buffer that came from this scene, in place of those that it has. A surface is the next layer's when it is
   more than 4e-6 of its view depth behind the last one's, so none is peeled against itself. Normals of odd layers (1st,
   3rd ..) are turned toward the viewer, of even ones away: both sides of a closed solid face open space. Leaves GL as
   kit_gbuffer_from_scene does, and unit 0 without a 2D texture. */
#define KIT_MAX_LAYERS 8
int  kit_gbuffer_peel(kit_gbuffer *gbuffer, const kit_scene *scene, int layers, kit_error *err);

/* Back faces, by winding (counter-clockwise is the front), of a G-buffer that came from this scene: 1: its back, 2: its
   slabs, in place of those that it has. One draw of the scene, or three. Leaves GL as kit_gbuffer_from_scene does. */
int  kit_gbuffer_slabs(kit_gbuffer *gbuffer, const kit_scene *scene, int slabs, kit_error *err);

/* Gives channels of another program's frame the names that kit_gbuffer_from_frame takes: channel[i] is "Z=THEIRS";
   where there is no Z then, those of a view layer of Blender's (layer; NULL: the only one): LAYER.Depth.Z, from 9e9 on
   nothing; .Normal.X .., of the world, which the camera turns (placed: it is known); .DiffCol.R .., .DiffDir.R .. */
int  kit_frame_rename(kit_image *frame, const char *const *channel, int channels, const char *layer,
                      const kit_camera *camera, int placed, kit_error *err);

/* From a frame: channels Z (view depth; <= 0, NaN or infinite = background), N.X N.Y N.Z (view space; made unit; a zero
   normal is taken as +z, -z in even layers; a frame of one layer may lack them) and perhaps albedo.R/G/B; the same as
   layer1.Z, layer1.N.X .. of the second layer, layer2.Z .. of the third, and so on to KIT_MAX_LAYERS; and perhaps
   direct.R/G/B (what is not finite or below 0 becomes 0); back.Z, or back.Z, front2.Z and back2.Z (view depth, 0 =
   nowhere). The camera's size becomes the frame's; its planes, where 0, bracket Z. */
int  kit_gbuffer_from_frame(kit_gbuffer *gbuffer, const kit_image *frame, const kit_camera *camera, kit_error *err);

/* The inverse, of the viewport: those channels of all layers, direct.R/G/B and slabs where there are any; background is
   0 in all. */
int  kit_gbuffer_read(kit_image *frame, const kit_gbuffer *gbuffer, kit_error *err);
int  kit_gbuffer_read_depth(kit_image *frame, const kit_gbuffer *gbuffer, kit_error *err);     /* Z alone */
void kit_gbuffer_free(kit_gbuffer *gbuffer);

/* ---- >>shadow ----------------------------------------------------------------------------------------------- */

typedef struct kit_shadow_camera {
    /* world to light view (the camera along -z); GL's clip space, perspective or orthographic */
    float view[16], projection[16];
    int   tile[4];                         /* x, y, width, height in texels of the atlas */
} kit_shadow_camera;

/* A DEPTH_COMPONENT32F atlas of shadow maps, 1 where nothing is; both sides of every triangle. Tiles must lie in the
   atlas; of tiles that overlap the nearest depth stays. 0 on failure. Leaves GL as kit_gbuffer_from_scene does. */
GLuint kit_shadow_atlas(int width, int height, const kit_scene *scene, const kit_shadow_camera *camera, int count,
                        kit_error *err);

/* A light's reflective shadow map [Dachsbacher and Stamminger 2005] in three arrays of 3 floats a pixel, for the caller
   to free: world position, world normal (unit, toward the light), reflected flux = albedo * the light's power that
   falls on the pixel. POINT: six cube faces of resolution x resolution pixels, power = intensity * the pixel's exact
   solid angle; what is nearer than 1e-4 of the bounds' diagonal is not seen. SUN: one orthographic map around the
   scene's bounds, power = irradiance * the pixel's area. All 0 where a pixel sees no surface. resolution [limit:
   1..4096]. */
int kit_rsm(float **position, float **normal, float **flux, size_t *pixels, const kit_scene *scene,
            const kit_light *light, int resolution, kit_error *err);

/* ---- >>field ------------------------------------------------------------------------------------------------ */

/* The field of a shape, baked on all cores when it is first asked for, then kept until kit_fields_free. NULL on
   failure. seconds: what the bake took; may be NULL. desc's callbacks are not looked at. */
const ssgi_field *kit_field(const kit_mesh *shape, const ssgi_field_desc *desc, double *seconds, kit_error *err);
void   kit_fields_free(void);
/* Pixels within the reach of an occluder's field, summed over the occluders, over the frame's. */
int    kit_fields_cover(double *share, const kit_image *frame, const kit_camera *camera, const kit_scene *scene,
                        const ssgi_field_desc *desc, kit_error *err);
/* t_ssgi_fields: count fields, a slice each. */
GLuint kit_field_atlas(const ssgi_field *const *field, int count);

/* ---- >>method ----------------------------------------------------------------------------------------------- */

/* What --set chooses, resolved: a member a key, of the same name; --list tells what each one means to its method. A
   method that lacks a key has 0 there. Choices are numbers, in the order of their words: these, or the library's
   (SSGI_GL_THICKNESS_ .. of thickness, SSGI_GL_SHADOW_ .. of shadows, SSGI_SH_WINDOW_ .. of window). */
enum { KIT_ENVIRONMENT_MAP, KIT_ENVIRONMENT_SH, KIT_ENVIRONMENT_NONE };
enum { KIT_STORE_HALF, KIT_STORE_PACKED, KIT_STORE_FLOAT };
enum { KIT_INDIRECT_NONE, KIT_INDIRECT_JOINT, KIT_INDIRECT_APART };
enum { KIT_FILTERED_COEFFICIENTS, KIT_FILTERED_LIGHT };
enum { KIT_LIGHTS_HARMONICS, KIT_LIGHTS_SHADOWED };
enum { KIT_OCCLUDERS_SOLID, KIT_OCCLUDERS_ALL };
enum { KIT_WAY_CPU, KIT_WAY_CAPTURE, KIT_WAY_DIRECT };
typedef struct kit_settings {
    /* where a gather looks */
    int    slices, directions, samples, normal_rays, march_terms, growing_sphere, sets, uniform_directions;
    int    resolution, range_check, noise;
    double offset, phase;                  /* half pixels; [0, 1] */
    int    layers, views, view_layers, view_size;
    double margin;                         /* radii */
    /* what occludes there, and how much of it */
    int    thickness, falloff, fade, normal, left_handed, facets, lift;
    double thickness_limit, fade_from, lambda;   /* radii, radii, per radius */
    /* filters */
    int    blur, filter, filter_normals, restore, history;
    /* light */
    int    environment, bounce, reuse, bounced, two_sided, one_sided, shadows, points, solid, shadow_size, suns, vpls;
    double clamp, distance_clamp, gain, max_slope;    /* radii; 1: a patch's own area; a slope */
    /* as spherical harmonics, or bent normals */
    int    bands, store, indirect, occluded_emitters, filtered, residual, window, lights, cone, lobes;
    /* fields */
    int    field_resolution, radii, rays, unfiltered, own, occluders;
    int    cap_table;                      /* its side; 0: closed form */
    double reach, ramp, inside, power;     /* bounding spheres' radii; of the reach; below 0: as measured; exponent */
    /* surfels */
    int    levels, way, near_samples, span, sky, near_depth, keep_small, splits, smooth, material;
    int    overhang, enlarge, combine;
    double size, epsilon, offscreen_growth, exponent, unit;    /* size: image heights; unit: world's, of a millimetre */
} kit_settings;

/* A setting of a method, as --list shows it: what --set key=value takes. A choice takes one of its words, everything
   else a number in [least, most]. */
typedef struct kit_setting {
    const char *key, *about;
    const char *choices;                   /* "SLICES MARCH": words for 0, 1 .., of any case; NULL = a number */
    double      value, least, most;        /* value: what the method has, at first the default */
    int         whole;                     /* takes whole numbers only */
} kit_setting;

typedef struct kit_method {
    const char  *name, *about;
    int          number;                   /* of kit_method_at, and of ssgi_gl_method_at */
    const struct plan *plan;               /* its settings */
    int          pass, effect;             /* SSGI_GL_PASS_SSAO ..; of surfels SSGI_GL_EFFECT_OCCLUSION .. */
    int          lit;                      /* 0: writes ambient visibility Y */
    int          between;                  /* 1: of other objects alone: its truth is kit_truth_objects */
    const char  *custom;                   /* methods of surfels: GLSL for SSGI_GL_EFFECT_CUSTOM in place of theirs */
    kit_settings set;
} kit_method;

/* The i-th method with its settings at their defaults; 0 past the last. */
int  kit_method_at(kit_method *method, int i);
int  kit_method_find(kit_method *method, const char *name, kit_error *err);
/* "key=value"; several separated by commas. On failure nothing has changed. */
int  kit_method_set(kit_method *method, const char *text, kit_error *err);
int  kit_method_setting(kit_setting *setting, const kit_method *method, int i);    /* its i-th; 0 past the last */
/* The word of a setting's number, in small letters, as kit_method_set takes it. Returns its length. */
size_t kit_setting_word(char *out, size_t size, const kit_setting *setting, int number);
/* The settings that are not the method's defaults, as kit_method_set takes them; "" = none. */
void kit_method_text(char *text, size_t size, const kit_method *method);
ssgi_field_desc kit_method_field(const kit_method *method);    /* what aof's settings ask of a bake */
/* Levels of surfels that a radius wants, in image heights as it is seen. Half of it suffices where occlusion fades;
   light, which does not, has a larger error with another level. */
int  kit_method_levels(const kit_method *method, double radius);
int  kit_method_attenuation(const kit_method *method);         /* KIT_ATTENUATION_LINEAR .. of its occluders */
/* The ray-traced truth of what a method computes, as kit_truth_ao and its like have it; of dss-scatter rays are
   thousands of samples. */
int  kit_method_truth(kit_image *out, const kit_method *method, const kit_scene *scene, const kit_camera *camera,
                      const kit_lighting *lighting, float radius, int rays, int stride, kit_error *err);

/* What a method may need beyond the G-buffer: the scene, to peel, for extra cameras and shadow maps (NULL with a
   frame); light, for lit methods (NULL = none). */
typedef struct kit_world { const kit_scene *scene; const kit_lighting *lighting; } kit_world;

enum { KIT_MAX_TARGETS = 6, KIT_HISTORIES = 2, KIT_MAX_PASSES = 128, KIT_MAX_TEXTURES = 192, KIT_MAX_VIEWS = 4,
       /* uniform buffers: the picture's frame, two an extra camera, then these */
       KIT_FRAME_VPLS = 1 + 2 * KIT_MAX_VIEWS, KIT_FRAME_VIEWS, KIT_FRAMES };
typedef struct kit_pass {
    ssgi_gl_desc       desc;
    const kit_gbuffer *gbuffer;
    ssgi_gl_step      *step;               /* desc is its, until a test gives the pass another */
    /* target: 0 when it draws into one of slices, an array */
    GLuint             program, framebuffer, target[KIT_MAX_TARGETS], slices;
    GLuint             input[16];          /* of the step's inputs those that steps wrote; 0: others */
    GLuint             last[KIT_HISTORIES]; /* history: what it wrote for the last frame */
    GLuint             lights;             /* t_ssgi_lights or t_ssgi_occluders */
    int                instances;          /* field: occluders */
    GLuint             array, capture;     /* surfels, splat: vertex array; what transform feedback writes */
    /* triangles, small ones and behind them those that are split, as patches; 0: surfels of a buffer, all of the
       run's */
    int                patches[2], splits;
    int                aside;              /* only there to tell the result's parts apart: neither timed nor counted */
    int                width, height;
    int                box[4];             /* x, y, width, height: what is drawn of its targets; 0 = all */
    ssgi_gl_io        *io;                 /* what it reads and writes: so many rows */
    int                rows;
    double             ms;                 /* of the last kit_run_draw that timed passes */
} kit_pass;

/* ---- >>run -------------------------------------------------------------------------------------------------- */

/* A method made ready on one G-buffer: programs, targets, uniforms, and what it needs of the world. The G-buffer stays
   the caller's and must outlive it. */
typedef struct kit_run {
    kit_gbuffer  *gbuffer;
    ssgi_gl_frame frame;                   /* change it as you like before a draw, then kit_run_update */
    int           lit, passes, textures, views, vpls;
    kit_pass      pass[KIT_MAX_PASSES];
    /* the result: ambient visibility or irradiance over pi; that of the bounce */
    GLuint        light, bounce;
    GLuint        texture[KIT_MAX_TEXTURES];   /* all that are the run's own */
    GLuint        normal;                  /* left_handed: the G-buffer's with z the other way; 0 = as it has them */
    GLuint        noise, kernel, environment, irradiance, view_depth, atlas, grey, cap;
    GLuint        block[KIT_FRAMES];
    kit_gbuffer   view[KIT_MAX_VIEWS];     /* of the extra cameras */
    int           margin;                  /* pixels beyond each side of the picture that a gather sees; 0 = none */
    kit_gbuffer   wide;                    /* with a margin: what is drawn on in place of the caller's */
    /* theirs, and with the rotation from their view space to the picture's */
    ssgi_gl_frame extra[2 * KIT_MAX_VIEWS];
    ssgi_gl_views cameras;
    GLuint        fields;                  /* field: all shapes' fields as one array */
    int           occluders;
    size_t        surfels;                 /* that the splats' buffer holds */
    /* predicted, all splats of the first splat pass; of each level */
    double        splat_pixels, level_pixels[SSGI_SPLAT_LEVELS];
    GLuint        arrays[3], buffers[3], query;
    size_t        field_bytes;             /* of those fields */
    GLuint        joint;                   /* what bounce holds beside the bounce; 0 = nothing */
    /* the environment, interleaved; its harmonics, if a pass reads them (with the suns, as lobes, for s3ho) */
    float        *equirect, harmonics[48];
    /* moved a pixel of the picture, all passes: each reads each texel of its inputs once and writes each of its
       outputs once, as stored, of farther layers those that it asks for; of splats surfels once and each texel that
       they cover, read and written. NAN: the context cannot tell */
    double        bytes;
    double        ms;                      /* of the last kit_run_draw that timed the frame */
} kit_run;

/* Peels the G-buffer as far as the method asks, when the world has a scene. Setting margin: the radius times it, as
   projected at the median depth along the picture's border, rounded up to a multiple of 4 pixels (so that half size's
   pixels and tiles of noise lie as without), at most a quarter of the picture's shorter side. A larger G-buffer is
   drawn, and the frame's size is its; a scissor keeps passes to the picture and what filters reach, all but emitters of
   light and what these are lit by. */
int kit_run_open(kit_run *run, kit_gbuffer *gbuffer, const kit_method *method, float radius, const kit_world *world,
                 kit_error *err);
void kit_run_update(kit_run *run);         /* uploads run->frame */
/* KIT_PASSES: each pass apart, by a timer of its own that waits for all before it. KIT_FRAME: all in one, as a frame of
   an engine's; passes that only tell parts apart are not drawn then. */
enum { KIT_UNTIMED, KIT_PASSES, KIT_FRAME };
void kit_run_draw(kit_run *run, int timed);
double kit_pass_bytes(const kit_run *run, const kit_pass *pass);   /* of one frame, as run->bytes counts them */
/* The texture of the run that inputs of that name read; 0: none is read. instead, unless 0, replaces it for all. */
GLuint kit_run_input(kit_run *run, const char *name, GLuint instead);
double kit_run_ms(const kit_run *run);     /* sum over the passes of the last timed draw */
/* The picture: Y, or R G B (outgoing radiance; where there is no albedo, it is 0.8), irradiance.R .., bounce.R ..
   (irradiance over pi, before albedo). */
int  kit_run_read(kit_image *out, const kit_run *run, kit_error *err);
void kit_run_close(kit_run *run);          /* leaves it all zero; fine of one that is, with no context, too */
/* One picture of a method by its name, with settings as kit_method_set takes them: opened, drawn, read and closed. */
int  kit_run_picture(kit_image *out, kit_gbuffer *gbuffer, const kit_world *world, const char *method, const char *set,
                     float radius, kit_error *err);

/* ---- >>frames ----------------------------------------------------------------------------------------------- */

/* Before a draw: makes the run the frame after last's, a run of the same method on a picture of any size, which
   must not be drawn any more: its history is the run's now. Or the run itself, once drawn. frame: its number. */
int  kit_run_follow(kit_run *run, kit_run *last, unsigned frame, kit_error *err);
int  kit_run_keeps(const kit_run *run);    /* 1: a pass of it averages over frames */

/* A method on one G-buffer after another. All zero before the first; closed whatever became of it. */
typedef struct kit_frames {
    kit_run  run[2];
    kit_run *now;                          /* the frame's, for the caller to draw and read; NULL: there is none */
    unsigned number;                       /* of the next frame, which its noise goes by; the first may be any */
    unsigned since;                        /* frames that follow each other up to now, this one among them */
    /* how long the next frame takes, in 60ths of a second: KIT_MEMORY of these are averaged then. 0: 16 frames are */
    float elapsed, took;                   /* took: kit_frames_next's own */
    int jittered;                          /* 1: camera.shift is jitter, and nothing that moves */
} kit_frames;
#define KIT_MEMORY 16.0f

/* Opens the next frame. Where the method keeps history, it follows the last one, with the margin that this had, unless
   that had other passes: history begins anew then, as it does after kit_frames_close, which who shows
   another scene calls. The last one is closed, and its G-buffer must live until then. alone: the frame's picture by the
   same noise, but without history; NULL: not asked. On failure all is closed. */
int  kit_frames_next(kit_frames *frames, kit_gbuffer *gbuffer, const kit_method *method, float radius,
                     const kit_world *world, kit_image *alone, kit_error *err);
/* The next frame is of the same G-buffer, once now is drawn: nothing is opened. */
int  kit_frames_again(kit_frames *frames, kit_error *err);
void kit_frames_close(kit_frames *frames); /* fine to call again */
/* Draws frame k of a picture that stays as it is, numbered from first on: where history is kept, the run follows itself
   from k = 1 on; 0 begins anew. */
int  kit_frames_still(kit_run *run, unsigned first, unsigned k, int timed, kit_error *err);

/* ---- >>plan: what a scene needs ----------------------------------------------------------------------------- */

/* The numbers of a picture that ssgi_plan_make asks for, but error, budget, device and history: a survey; where there
   is a scene, a calibration by tracing it and what surfels of it cost; the harmonics of the environment. */
int kit_plan_numbers(ssgi_plan_scene *numbers, kit_gbuffer *gbuffer, const kit_world *world, float radius, int wanted,
                     kit_error *err);
/* A plan as a chain: the desc that ssgi_gl_plan makes of it, and what that leaves to its caller. The same as a method.
   A plan of NOTHING fails. */
int  kit_plan_chain(ssgi_gl_chain *chain, const ssgi_plan *plan, int wanted, kit_error *err);
int  kit_plan_method(kit_method *method, const ssgi_plan *plan, int wanted, kit_error *err);
/* That method, and those of its settings that are not its defaults, as kit_method_set takes them; NULL for NOTHING. */
const char *kit_plan_text(char set[256], const ssgi_plan *plan, int wanted);
/* A picture's error as plans have it, where the frame shows something and the truth is known (not NAN): RMSE of Y; of
   irradiance, or with the bounce, over their mean. */
double kit_plan_error(const kit_image *picture, const kit_image *truth, const kit_image *frame, int wanted);
/* Ambient visibility (channel Y) becomes light (KIT_LIT_CHANNELS): the light of open surfaces, dimmed by it but for the
   part that is direct (NULL: none). */
int  kit_dim(kit_image *visibility, const kit_image *open, const kit_image *direct, kit_error *err);
/* The same: what the environment brings to an open surface, dimmed, and the lights with their shadows. */
int  kit_light_by(kit_image *visibility, kit_gbuffer *gbuffer, const kit_world *world, float radius, kit_error *err);

/* ---- >>passes ----------------------------------------------------------------------------------------------- */

/* Compiles all stages of a pass for the context that is open, with the dialect that suits it, and binds its samplers
   and block to their slots. */
GLuint kit_pass_program(const ssgi_gl_desc *desc, kit_error *err);
/* Binds those of a program that has the rows of a pass. */
void   kit_pass_bind(GLuint program, const ssgi_gl_io *io, int rows);
/* Gives a pass the rows of its desc, and its program where that is 0. */
int    kit_pass_make(kit_pass *pass, kit_error *err);
int    kit_dialect(void);
/* SSGI_GL_COMPUTE_ALL if KIT_COMPUTE is in the environment, _BASIC if it is "BASIC", and the context is desktop GL:
   gathers and filters, but not those of surfels and fields, are compute stages. */
int    kit_compute(void);

#endif
