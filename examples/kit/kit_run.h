/* kit_run.h - what settings.c, run.c, frames.c, lights.c and deep.c share: how a run is made ready. Private to them. */
#ifndef KIT_RUN_H
#define KIT_RUN_H

#include "kit/kit_gl.h"

/* What kit_run_open works with; the run is its result. */
typedef struct kit_making {
    kit_run           *run;
    const kit_method  *method;
    const kit_world   *world;
    ssgi_gl_desc       gather, lights;                 /* of the pass that the method is named for, and of lights */
    int                blurred, kept;                  /* kept: averaged over frames */
    /* lights, as the picture's camera and the extra ones have them; 0 = none */
    GLuint             rows[1 + KIT_MAX_VIEWS];
    kit_error         *err;
} kit_making;

/* ---- >>settings */

/* The method's pass and settings, over what the passes' descs have in common (m->gather): the descs, and what of the
   frame they set. */
int       kit_settings_apply(kit_making *m, float radius);

/* ---- >>run */

/* kit_run_open with a margin of so many pixels, which is the last frame's; -1: as the picture asks. */
int       kit_run_open_wide(kit_run *run, kit_gbuffer *g, const kit_method *method, float radius,
                            const kit_world *world, int margin, kit_error *err);
GLuint    kit_keep(kit_run *run, GLuint texture);     /* becomes the run's own */
/* The chain of what the method gathers: blur, history and sizes as the method has them. */
ssgi_gl_chain kit_chain(const kit_making *m);
/* The chain's steps as passes, and where their results are (NULL: not asked). aside: see kit_pass. */
int       kit_add_steps(kit_making *m, const ssgi_gl_chain *chain, int aside, GLuint *light, GLuint *bounce);

/* ---- >>lights */

typedef struct kit_sphere { float centre[3], radius; } kit_sphere;
/* in the world; camera: of its map */
typedef struct kit_placed_light { ssgi_gl_light light; kit_camera camera; int mapped; } kit_placed_light;

int       kit_view_of(ssgi_view *view, const float projection[16], int depth, int width, int height, kit_error *err);
void      kit_rotation_of(float rotation[12], const float a[16], const float b[16]);     /* a * transpose(b), as mat3 */
/* What the G-buffer shows, in the world. all: the sphere that holds most of it. middle: at the median depth in the
   middle of the picture, as wide as that, for extra cameras. point: of every pixel, and its depth; for the caller to
   free. */
typedef struct kit_sight { kit_sphere all, middle; float (*point)[4]; size_t points; } kit_sight;
int       kit_seen(const kit_gbuffer *g, kit_sight *seen, kit_error *err);
/* Extra cameras: their G-buffers, their frames, their depths as one array. */
int       kit_add_views(kit_making *m, const float picture[16], const kit_sphere *about);
/* All lights of the world as placed: --light, the environment's suns, virtual point lights (which are not among
   direct). A sun's maps, where it has any, cover all that is seen: --light's the near part of it, all of it, and the
   whole scene, which extra cameras and surfels see. NULL on failure. */
kit_placed_light *kit_placed_lights_new(kit_making *m, const kit_sight *seen, int *count, int *direct);
/* their shadow maps, as tiles in their order */
int       kit_add_atlas(kit_making *m, const kit_placed_light *placed, int count);
/* Lamps first .. last - 1 as a camera has them, one row of t_ssgi_lights each: for the caller to free (NULL: no
   memory), or as a texture. */
ssgi_gl_light *kit_lights_seen(const kit_placed_light *placed, int first, int last, const float picture[16]);
GLuint    kit_light_rows(const kit_placed_light *placed, int first, int last, const float picture[16]);
/* The environment as the passes read it: harmonics, a map over a direction's solid angle, irradiance (and light over
   cones). */
int       kit_add_environment(kit_making *m);
void      kit_add_grey(kit_making *m);                 /* albedo of meshes without a material */
int       kit_open_lit(kit_making *m, const float picture[16]);
int       kit_open_field(kit_making *m, const float picture[16]);

/* ---- >>deep */

int       kit_open_deep(kit_making *m, const ssgi_view *view, const float picture[16]);
void      kit_draw_surfels(kit_run *run, const kit_pass *p);

#endif
