/* kit_run.h - shared by the files of kit/run: how a run is made ready. Private to them.

   Each file calls only those above it; make tree proves that none call each other in a circle:

     settings.c  methods and their settings
     truth.c     the ray-traced ground truth of a method's result
     draw.c      an open run: drawn, read back, closed
     cost.c      the memory traffic of a run
     passes.c    the steps of a chain as passes
     margin.c    the margin around the picture
     views.c     places that the picture shows, extra cameras
     lights.c    lamps with their shadow maps, the environment
     lit.c, occluders.c, deep.c     light; occlusion by fields; deep screen space
     run.c       makes a method ready
     frames.c    one frame after another
     plan.c      measures a scene for the planner */
#ifndef KIT_RUN_H
#define KIT_RUN_H

#include "kit/kit_gl.h"

/* The state of kit_run_open while it makes a run ready; run is its result. */
typedef struct kit_making {
    kit_run            *run;
    const kit_method   *method;
    const kit_settings *set;                           /* the method's */
    const kit_world    *world;                         /* its lighting is never NULL */
    ssgi_gl_desc        desc, lights;                  /* desc: of the method's main pass; lights: of pass lights */
    int                 blurred, kept;                 /* kept: averaged over frames */
    /* textures of lights as seen by the main camera and by the extra cameras; 0 = none */
    GLuint              rows[1 + KIT_MAX_VIEWS];
    kit_error          *err;
} kit_making;

/* ---- >>settings */

/* Makes the descs, and the members of the frame, from the method's pass and settings; m->desc holds the fields that all
   passes share. */
int       kit_settings_apply(kit_making *m, float radius);
/* Sets those of the method's settings that are fields of the desc to its values; a count of 0 leaves its setting. */
void      kit_method_take(kit_method *method, const ssgi_gl_desc *desc);

/* ---- >>draw */

/* Returns the texture that an input's name means: of the steps, the G-buffer or the run; and where it is bound. */
GLuint    kit_pass_texture(const kit_run *run, const kit_pass *p, const char *name);
GLenum    kit_target_of(const ssgi_gl_io *io);

/* ---- >>cost */

int       kit_step_part(const ssgi_gl_step *step);       /* width of a texel of its targets in pixels */
double    kit_run_bytes(const kit_run *run);           /* see kit_run */

/* ---- >>passes */

GLuint    kit_keep(kit_run *run, GLuint texture);     /* makes the run free the texture; returns it */
/* Returns the chain of the method's gather: blur, history and resolution as the method sets them. */
ssgi_gl_chain kit_chain(const kit_making *m);
/* Adds the chain's steps as passes; light and bounce get its results' textures (may be NULL). aside: see kit_pass. */
int       kit_add_steps(kit_making *m, const ssgi_gl_chain *chain, int aside, GLuint *light, GLuint *bounce);

/* ---- >>margin */

/* Replaces *g by a G-buffer with the method's margin. pixels: the margin's width; -1: kit_run_open's rule decides. */
int       kit_add_margin(kit_making *m, kit_gbuffer **g, float radius, int pixels);
/* Limits the part of its targets that each pass draws: without a margin all; for the result the image, for inputs of a
   filter also the filter's reach, for emitters and the light on them all. */
void      kit_limit_passes(kit_run *run);

/* ---- >>views */

typedef struct kit_sphere { float centre[3], radius; } kit_sphere;
int       kit_view_of(ssgi_view *view, const float projection[16], int depth, int width, int height, kit_error *err);
void      kit_rotation_of(float rotation[12], const float a[16], const float b[16]);     /* a * transpose(b), as mat3 */
/* The world-space points that the G-buffer shows. all: the sphere that holds most of them. middle: a sphere at the
   median depth in the middle of the image, as wide as that depth, for extra cameras. point: each pixel's point and its
   view depth; the caller frees them. */
typedef struct kit_seen_places { kit_sphere all, middle; float (*point)[4]; size_t points; } kit_seen_places;
int       kit_seen(const kit_gbuffer *g, kit_seen_places *seen, kit_error *err);
/* Adds the extra cameras: their G-buffers, their frames, and their depths as one array. */
int       kit_add_views(kit_making *m, const float picture[16], const kit_sphere *about);

/* ---- >>lights */

/* light: in world space; camera: that of the light's shadow map; mapped: 1 if the light has such a map */
typedef struct kit_placed_light { ssgi_gl_light light; kit_camera camera; int mapped; } kit_placed_light;
/* Returns all lights of the world: first the direct ones, of --light and the environment's suns, then virtual point
   lights. A --light's sun has maps that cover the near part of the visible surfaces, all of them, and, for extra
   cameras and surfels, the whole scene. NULL on failure. */
kit_placed_light *kit_placed_lights_new(kit_making *m, const kit_seen_places *seen, int *count, int *direct);
/* Draws their shadow maps as tiles of one atlas, in their order. */
int       kit_add_atlas(kit_making *m, const kit_placed_light *placed, int count);
/* Return lights first .. last - 1 in a camera's view space, one row of t_ssgi_lights each: as an array that the caller
   frees (NULL: no memory), or as a texture. */
ssgi_gl_light *kit_lights_seen(const kit_placed_light *placed, int first, int last, const float picture[16]);
GLuint    kit_light_rows(const kit_placed_light *placed, int first, int last, const float picture[16]);
/* Adds the environment in the forms that passes read: harmonics, a map of means over a solid angle, irradiance (and
   light over cones). */
int       kit_add_environment(kit_making *m);
/* Makes ssgi_environment_map of an interleaved environment with a solid angle or, if that is below 0,
   ssgi_environment_cone with a cosine. */
ssgi_result kit_environment_of(float *out, int size, const float *rgb, const kit_image *env, float solid_angle,
                               float cosine, const char **why);
float    *kit_rgba(float *four, const float *map, int size);    /* copies size * size texels of three floats to four */
void      kit_add_grey(kit_making *m);                 /* makes an albedo texture, 0.8, for a frame that has none */

/* ---- >>lit, occluders, deep: a method's passes, and their inputs from the world */

int       kit_open_lit(kit_making *m, const float picture[16]);
/* Adds the fields and the transforms of the objects that cast. */
int       kit_open_field(kit_making *m, const float picture[16]);
int       kit_open_deep(kit_making *m, const ssgi_view *view, const float picture[16]);

/* ---- >>run */

/* Opens a run as kit_run_open does, with a margin of so many pixels, the last frame's; -1: as the method asks. */
int       kit_run_open_wide(kit_run *run, kit_gbuffer *g, const kit_method *method, float radius,
                            const kit_world *world, int margin, kit_error *err);

#endif
