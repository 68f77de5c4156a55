/* kit_run.h - what the files of kit/run share: how a run is made ready. Private to them.

   Each calls those above it alone; make tree proves that none call each other in a circle:

     settings.c  what a method is
     truth.c     the ray-traced truth of what a method computes
     draw.c      a run that is open: drawn, read back, closed
     cost.c      what it costs
     passes.c    the steps of a chain as passes
     margin.c    what is seen beyond the picture
     views.c     what is seen, extra cameras
     lights.c    lamps with their shadow maps, the environment
     lit.c, occluders.c, deep.c     light; occlusion by fields; deep screen space
     run.c       a method made ready
     frames.c    one frame after another
     plan.c      what a scene needs */
#ifndef KIT_RUN_H
#define KIT_RUN_H

#include "kit/kit_gl.h"

/* What kit_run_open works with; the run is its result. */
typedef struct kit_making {
    kit_run            *run;
    const kit_method   *method;
    const kit_settings *set;                           /* the method's */
    const kit_world    *world;                         /* its lighting is never NULL */
    ssgi_gl_desc        desc, lights;                  /* of the pass that the method is named for, and of lights */
    int                 blurred, kept;                 /* kept: averaged over frames */
    /* lights, as the picture's camera and the extra ones have them; 0 = none */
    GLuint              rows[1 + KIT_MAX_VIEWS];
    kit_error          *err;
} kit_making;

/* ---- >>settings */

/* The method's pass and settings, over what the passes' descs have in common (m->desc): the descs, and what of the
   frame they set. */
int       kit_settings_apply(kit_making *m, float radius);
/* The settings that are fields of the desc become what it has there; a count that it leaves 0 stays. */
void      kit_method_take(kit_method *method, const ssgi_gl_desc *desc);

/* ---- >>draw */

/* What a row names: a texture of the steps, or of the G-buffer, or of the run; and where it is bound. */
GLuint    kit_pass_texture(const kit_run *run, const kit_pass *p, const char *name);
GLenum    kit_target_of(const ssgi_gl_io *io);

/* ---- >>cost */

int       kit_step_part(const ssgi_gl_step *step);       /* how many pixels are as wide as a texel of its targets */
double    kit_run_bytes(const kit_run *run);           /* see kit_run */

/* ---- >>passes */

GLuint    kit_keep(kit_run *run, GLuint texture);     /* becomes the run's own */
/* The chain of what the method gathers: blur, history and sizes as the method has them. */
ssgi_gl_chain kit_chain(const kit_making *m);
/* The chain's steps as passes, and where their results are (NULL: not asked). aside: see kit_pass. */
int       kit_add_steps(kit_making *m, const ssgi_gl_chain *chain, int aside, GLuint *light, GLuint *bounce);

/* ---- >>margin */

/* The G-buffer that a method's margin asks for, in place of *g. pixels: its width, -1: to be measured. */
int       kit_add_margin(kit_making *m, kit_gbuffer **g, float radius, int pixels);
/* With a margin: what each pass draws. The result's: the picture; what a filter reads: as far as it reaches; emitters,
   and what they are lit by: all of what is seen. */
void      kit_limit_passes(kit_run *run);

/* ---- >>views */

typedef struct kit_sphere { float centre[3], radius; } kit_sphere;
int       kit_view_of(ssgi_view *view, const float projection[16], int depth, int width, int height, kit_error *err);
void      kit_rotation_of(float rotation[12], const float a[16], const float b[16]);     /* a * transpose(b), as mat3 */
/* What the G-buffer shows, in the world. all: the sphere that holds most of it. middle: at the median depth in the
   middle of the picture, as wide as that, for extra cameras. point: of every pixel, and its depth; for the caller to
   free. */
typedef struct kit_seen_places { kit_sphere all, middle; float (*point)[4]; size_t points; } kit_seen_places;
int       kit_seen(const kit_gbuffer *g, kit_seen_places *seen, kit_error *err);
/* Extra cameras: their G-buffers, their frames, their depths as one array. */
int       kit_add_views(kit_making *m, const float picture[16], const kit_sphere *about);

/* ---- >>lights */

/* in the world; camera: of its map */
typedef struct kit_placed_light { ssgi_gl_light light; kit_camera camera; int mapped; } kit_placed_light;
/* All lights of the world as placed: --light, the environment's suns, virtual point lights (which are not among
   direct). A sun's maps, where it has any, cover all that is seen: --light's the near part of it, all of it, and the
   whole scene, which extra cameras and surfels see. NULL on failure. */
kit_placed_light *kit_placed_lights_new(kit_making *m, const kit_seen_places *seen, int *count, int *direct);
/* their shadow maps, as tiles in their order */
int       kit_add_atlas(kit_making *m, const kit_placed_light *placed, int count);
/* Lamps first .. last - 1 as a camera has them, one row of t_ssgi_lights each: for the caller to free (NULL: no
   memory), or as a texture. */
ssgi_gl_light *kit_lights_seen(const kit_placed_light *placed, int first, int last, const float picture[16]);
GLuint    kit_light_rows(const kit_placed_light *placed, int first, int last, const float picture[16]);
/* The environment as the passes read it: harmonics, a map over a direction's solid angle, irradiance (and light over
   cones). */
int       kit_add_environment(kit_making *m);
/* ssgi_environment_map of a solid angle, or where that is below 0 ssgi_environment_cone of a cosine, of an environment
   that is interleaved */
ssgi_result kit_environment_of(float *out, int size, const float *rgb, const kit_image *env, float solid_angle,
                               float cosine, const char **why);
float    *kit_rgba(float *four, const float *map, int size);    /* size * size texels of three floats, as four */
void      kit_add_grey(kit_making *m);                 /* albedo of meshes without a material */

/* ---- >>lit, occluders, deep: a method's passes, and what they need of the world */

int       kit_open_lit(kit_making *m, const float picture[16]);
/* The casting objects' fields, and where they stand. */
int       kit_open_field(kit_making *m, const float picture[16]);
int       kit_open_deep(kit_making *m, const ssgi_view *view, const float picture[16]);

/* ---- >>run */

/* kit_run_open with a margin of so many pixels, which is the last frame's; -1: as the picture asks. */
int       kit_run_open_wide(kit_run *run, kit_gbuffer *g, const kit_method *method, float radius,
                            const kit_world *world, int margin, kit_error *err);

#endif
