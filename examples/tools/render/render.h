/* render.h - what build/render's files share: what is asked for, what it takes, what was measured. */
#ifndef RENDER_H
#define RENDER_H

#include "kit/kit_gl.h"

/* ---- >>options */

enum { RENDER_SETS = 32 };

typedef struct options {
    /* what to draw: a scene, a frame, or a list of frames */
    const char *scene, *gbuffer, *sequence, *env, *light[KIT_MAX_LIGHTS];
    const char *layer, *channel[RENDER_SETS];          /* of a frame of another program */
    int         channels, lights, ground, flat, frames, still, width, height;
    double      turn, strength;            /* of env */
    double      orbit;                     /* degrees a frame */
    int         has_camera, has_up, has_near, has_slide;
    double      slide[3];                  /* a frame */
    double      camera[6], up[3];          /* eye, target */
    double      fovy, ortho_height, znear, zfar;       /* 0: not said */
    /* how */
    const char *method, *set[RENDER_SETS], *context;
    int         sets, truth, floor;        /* rays; 0: not asked */
    double      radius;                    /* 0: the scene's own, or a guess */
    int         guess;                     /* 1: by its mesh's maxima of y */
    int         planned;                   /* SSGI_PLAN_WANTED_VISIBILITY .. and 1; 0: not asked */
    double      plan[2];                   /* error, budget */
    int         plan_in_ms;                /* the budget is milliseconds of an RX 6800 */
    /* what comes out */
    const char *out, *score, *save, *listed;
    int         time, json, list, help, version, colours, backdrop;
} options;

/* All options. */
void render_usage(FILE *to);
int  render_parse(options *o, int argc, char **argv, kit_error *err);
/* All methods and scenes, a line each; or the settings of one method. */
int  render_list(const char *name, kit_error *err);
int  render_numbers(const char *name, const char *text, double *out, int count, kit_error *err);
/* Of light, which the planned method may bring by ambient visibility. */
int  render_plans_light(const options *o);
/* A path whose one %d, or %04d, is replaced by a number; 0 if it has none, or does not fit. */
int  render_numbered(char *out, size_t size, const char *path, int k);

/* ---- >>report */

/* The picture, its foreground mask, and what was measured: of ambient visibility; or of radiance, irradiance and
   bounce, their three channels together. */
enum { GROUPS = 3 };

typedef struct result {
    kit_image        picture, frame;
    const kit_run   *run;
    const ssgi_plan *plan;
    double          *ms;
    int              frames, lit;
    kit_score        score[GROUPS];
    kit_score_place  place[GROUPS][KIT_PLACES];
    double           nothing[GROUPS];          /* lit: mean of the reference */
} result;

int  render_score(result *r, const char *path, const kit_camera *camera, double radius, kit_error *err);
void render_report(const options *o, const kit_method *m, const result *r, double radius);

/* ---- >>job: what it takes */

typedef struct job {
    options      o;
    kit_method   method;
    kit_scene    scene;
    kit_gbuffer  gbuffer;
    kit_run      run;
    kit_frames   frames;
    kit_lighting lighting;
    kit_world    world;
    ssgi_plan    plan;
    double       radius;
    double       origin[3];                /* the user's coordinates of what stands at 0: the scene's, or a frame's */
    int          framed;                   /* that is settled, by the first frame */
    int          noted;                    /* that a frame's normals agree with another lens */
    result       r;
} job;

int  render_open_settings(job *j, kit_error *err);
/* What options do not say its header does; a radius that nobody gave is the job's from then on. */
int  render_open_frame(kit_gbuffer *g, job *j, const options *o, kit_error *err);
int  render_open_scene(job *j, kit_error *err);
/* Moves the first object that casts by --slide, so many times. */
int  render_slide(job *j, int times, kit_error *err);
/* As its ending says, EXR or PNG; with the colours or the backdrop that are asked for. */
int  render_write(const job *j, const kit_gbuffer *g, kit_image *picture, int lit, const char *path, kit_error *err);

/* ---- >>frames */

/* A picture a frame, written as it is drawn; each run takes over the last one's history. */
int  render_play(job *j, kit_error *err);

#endif
