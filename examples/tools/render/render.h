/* render.h - shared by build/render's files: the options, the state of a job, the results. */
#ifndef RENDER_H
#define RENDER_H

#include "kit/kit_gl.h"

/* ---- >>options */

enum { RENDER_SETS = 32 };

typedef struct options {
    /* the input: a scene, a frame, or a list of frames; its light */
    const char *scene, *gbuffer, *sequence, *env, *light[KIT_MAX_LIGHTS];
    const char *layer, *channel[RENDER_SETS];          /* names in another program's frame */
    int         channels, lights, ground, flat, frames, still, size[2];
    double      turn, strength;            /* of env */
    double      orbit;                     /* degrees for each frame */
    int         has_camera, has_up, has_near, has_slide;
    double      slide[3];                  /* a frame */
    double      camera[6], up[3];          /* eye, target */
    double      fovy, ortho_height, znear, zfar;       /* 0: not given */
    /* how */
    const char *method, *set[RENDER_SETS], *context;
    int         sets, truth, floor;        /* sets: number of --set; truth, floor: rays a pixel, 0: not asked for */
    double      radius;                    /* in world units; 0: the scene's own, or a guess */
    int         guess;                     /* 1: the radius is guessed from the local maxima of the mesh's y */
    int         planned;                   /* SSGI_PLAN_WANTED_.. plus 1; 0: not asked for */
    double      plan[2];                   /* error, budget */
    int         plan_relative;             /* 1: the error is in percent of that without occlusion */
    int         plan_in_ms;                /* 1: the budget is in milliseconds, not in ssaos */
    /* the output */
    const char *out, *score, *save, *listed;
    int         time, json, list, colours, backdrop;
} options;

/* As kit_help. */
int  render_help(int argc, char **argv);
int  render_parse(options *o, int argc, char **argv, kit_error *err);
/* Prints all methods and scenes, a line each; or the settings of the method of that name. */
int  render_list(const char *name, kit_error *err);
/* Returns whether the plan is for light, which the planned method may compute from ambient visibility. */
int  render_plans_light(const options *o);
/* Replaces the one %d, or %04d, of a path by a number. Returns 0 if it has none, or the result does not fit. */
int  render_numbered(char *out, size_t size, const char *path, int k);

/* ---- >>report */

/* The image, the frame with its foreground, and the scores: of ambient visibility; or of radiance, irradiance and
   bounce, each with its three channels together. */
enum { GROUPS = 3 };

typedef struct result {
    kit_image        picture, frame;
    const kit_run   *run;
    const ssgi_plan *plan;                 /* the plan, the next cheaper and the next dearer choice; NULL: no plan */
    double          *ms;
    int              frames, lit;
    kit_score        score[GROUPS];
    kit_score_place  place[GROUPS][KIT_PLACES];
    double           nothing[GROUPS];          /* error of no occlusion; if lit, mean of the ground truth */
} result;

int  render_score(result *r, const char *path, const kit_camera *camera, double radius, kit_error *err);
void render_report(const options *o, const kit_method *m, const result *r, double radius);

/* ---- >>job: the inputs */

typedef struct job {
    options      o;
    kit_method   method;
    kit_scene    scene;
    kit_gbuffer  gbuffer;
    kit_run      run;
    kit_frames   frames;
    kit_lighting lighting;
    kit_world    world;
    ssgi_plan    plan[3];
    double       radius;
    double       origin[3];                /* the point of the user's coordinates that is 0 in the scene or frame */
    int          framed;                   /* 1: the first frame has set origin */
    int          unmet;                    /* 1: no choice meets the plan's error */
    int          noted;                    /* 1: a note said that a frame's normals fit another lens */
    result       r;
} job;

int  render_open_settings(job *j, kit_error *err);
/* Opens a frame. Its header gives the values that options do not; a radius from it is the job's from then on. */
int  render_open_frame(kit_gbuffer *g, job *j, const options *o, kit_error *err);
int  render_open_scene(job *j, kit_error *err);
/* Moves the first object that casts by --slide, `times` times. */
int  render_slide(job *j, int times, kit_error *err);
/* Writes EXR or PNG, by the path's ending; with --colours or --backdrop if they are given. */
int  render_write(const job *j, const kit_gbuffer *g, kit_image *picture, int lit, const char *path, kit_error *err);

/* ---- >>frames */

/* Draws a picture for each frame and writes it at once; each run takes over the last run's history. */
int  render_play(job *j, kit_error *err);

#endif
