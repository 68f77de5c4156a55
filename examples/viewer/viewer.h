/* viewer.h - shared by the viewer's files; viewer.c says the purpose of each. */
#ifndef VIEWER_H
#define VIEWER_H

#include "kit/kit_gl.h"
#include <pthread.h>

struct GLFWwindow;

enum { VIEWER_PATH = 4096, VIEWER_WISHES = 64,
       VIEWER_STILL = 32 };                 /* frames of a still view after which no more are drawn */

/* ---- >>truth.c */

typedef struct progress {
    unsigned version;                       /* counts additions of rays */
    int      tracing, rounds;               /* rays a pixel that the present round traces; number of finished rounds */
    float    share;                         /* finished share of the present round */
} progress;

typedef struct truth {
    pthread_t          thread;
    pthread_mutex_t    lock;                /* guards all below: the thread reads the request and writes the result */
    pthread_cond_t     wake;
    const kit_scene   *scene;
    const kit_lighting *lighting;
    kit_camera         camera;              /* the request: this member and those below, to radius */
    kit_method         method;
    float              radius;
    int                started, quit, failed;
    unsigned           wanted;              /* number of requests so far: a new number cancels the tracing */
    progress           now;
    float             *rgb;
    int               *rays;                /* number of rays of each pixel; 0: unknown, and rgb is a neighbour's */
    kit_error          err;                 /* why it failed */
} truth;

/* Asks for a ground truth; the tracing starts over if anything differs on which it depends. */
int    truth_want(truth *t, const kit_camera *camera, const kit_method *method, float radius, kit_error *err);
/* Ends the thread, until the ground truth is wanted again; called before the scene or its light change. */
void   truth_stop(truth *t);

/* ---- >>viewer.c */

/* A half of the window: a method on its frames, or the ground truth. */
typedef struct side {
    kit_method method;
    int        truth;
    kit_frames frames;
    GLuint     picture, framebuffer;        /* visibility or radiance before its display; alpha 0 in the background */
    double     error;                       /* RMSE against the ground truth; NAN: not known */
    kit_error  failed;                      /* why the side's method cannot be drawn; "": it can */
} side;

typedef struct light {
    char         env[VIEWER_PATH];          /* name or path, "": none */
    kit_image    read;                      /* before turn and strength */
    double       turn, strength;
    int          asked;                     /* 1: chosen by the user, so that a scene's own light does not replace it */
    kit_lighting now;
    GLuint       texture;                   /* the environment, shown behind the scene; 0: none */
} light;

typedef struct pace {
    double fixed;                          /* share of the window's width and height that is drawn; 0: chosen by time */
    int    level, lowest;               /* indices in the table shares: while the view moves; the last of this window */
    int    still;                           /* 1: the view is at rest, so that the size is the window's */
    int    coarse;                          /* while the view moves, surfels are 2^coarse times as wide */
    double moved;                           /* time of the last movement or change of a setting, seconds */
    int    opened;                          /* frames drawn with a new G-buffer since settings changed */
} pace;

typedef struct viewer {
    struct GLFWwindow *window;
    char         path[VIEWER_PATH];         /* the scene's */
    int          ground;
    kit_scene    scene;
    light        light;
    kit_camera   camera, home;
    float        radius, asked_radius;
    char         wish[VIEWER_WISHES][64];   /* key=value, set in each method that has the key */
    int          wishes;
    /* of the window */
    float        split;
    int          split_on, error, colours, help, panel, shots, size[2];
    double       mouse[2];
    pace         pace;
    side         side[2];
    int          kept;                      /* 1: the scene's triangles are on the GPU */
    kit_gbuffer  gbuffer[2], *seen;       /* of this frame and the last; seen: points to this frame's; NULL: none yet */
    float        stood[2][3];               /* displacement of the sliding object in each G-buffer */
    int          drawn[2];                  /* size */
    int          moved, restart, redraw;    /* changes since the last frame: of the view; of the methods; of the text */
    unsigned     frame, still;              /* number of all frames; number of frames since the view moved */
    unsigned     mean;                      /* number of still frames whose mean is shown; 0: the last frame is shown */
    GLuint       mean_picture, mean_framebuffer;
    double       ms;
    /* automatic motion */
    int          circles, slides;
    double       orbit, last, phase;        /* degrees a frame; seconds; angle of the sliding object on its circle */
    float        slid[3];                   /* displacement of that object */
    truth        truth;
    progress     shown;                     /* progress of the ground truth when it was uploaded */
    GLuint       truth_picture;
    double       scored;
    GLuint       resolve, display, motion, text, glyphs;
    char         note[1200], title[300];
    double       noted, titled;
    const char  *shot;
    int          frames, command, asks;     /* command, asks: print the command line at the end; after the next frame */
    kit_error    err;
} viewer;

/* ---- >>settings.c: methods and their settings */

/* Sets a half's method by its number, with the user's settings. strict: a setting that it refuses is an error. */
int    method_choose(viewer *v, side *s, int number, int strict);
int    wish(viewer *v, const char *text);           /* adds key=value; returns -1 if there is no room */
int    setting_of(kit_setting *out, const kit_method *m, const char *key); /* returns 0 if the method has no such key */

/* ---- >>load.c: scenes and light. A failure changes nothing */

int    scene_open(viewer *v, const char *path);
int    env_open(viewer *v, const char *name);       /* "": none */
int    env_adjusted(viewer *v);                     /* called after turn or strength changed */
void   light_changed(viewer *v);                    /* before lights change */
kit_light *sun_of(viewer *v);                       /* returns the first sun; adds one if there is none */
void   dropped(viewer *v, const char *path);
void   load_close(viewer *v);

/* ---- >>draw.c: a frame */

int    draw_open(viewer *v);
int    draw_frame(viewer *v);               /* draws the methods' results unless they are up to date */
void   draw_window(viewer *v);              /* draws both halves into the window */
int    draw_settled(const viewer *v);       /* returns 1 if another frame would look the same */
void   draw_forget(viewer *v);              /* called before the scene's triangles change */
void   draw_close(viewer *v);

/* ---- >>motion.c */

int    motion_open(viewer *v);
/* Draws the motion of the sliding object from the last G-buffer to the next into a texture, for history. */
int    motion_draw(viewer *v, kit_gbuffer *next, const kit_gbuffer *last);

/* ---- >>pace.c: the size of frames, by their time */

void   pace_begin(pace *p, const int window[2], int software);
void   pace_size(pace *p, const int window[2], int size[2]);
int    pace_took(pace *p, double ms, int surfels);  /* ms: of a frame; returns 1 if the next one is drawn differently */
double pace_coarse(const pace *p);
void   pace_moves(pace *p);
void   pace_stays(pace *p);                 /* tells that the view is still; later the size is the window's */
int    pace_waits(const pace *p);           /* returns 1 if waiting would not change the size now */
double pace_share(const pace *p);

/* ---- >>panel.c */

int    panel_open(viewer *v);
void   panel_say(viewer *v, const char *text);      /* for some seconds */
int    panel_says(const viewer *v);
void   panel_draw(viewer *v);

/* ---- >>pictures.c */

/* Computes RMSE over pixels with a surface and a ground truth: of visibility, or of radiance over its mean. */
void   side_score(viewer *v, side *s);
int    window_save(viewer *v, const char *path);
void   picture_save(viewer *v, int exr);            /* under an unused name */

/* ---- >>command.c */

/* Prints the command line by which build/render draws the left half's picture, to standard output. */
void   command_print(viewer *v);

/* ---- >>keys.c, input.c, window.c */

typedef struct press { viewer *v; const struct key *key; int shift; } press;
/* A key of the table. by, setting: arguments of press: the amount of a change, or the setting that changes. */
typedef struct key { int code; const char *label, *about; void (*press)(press p); double by; const char *setting; } key;
extern const key keys[];                    /* ends with code 0 */
void   slide_to(viewer *v, const float to[3]);      /* moves the first object that casts by the displacement to */
void   input_open(viewer *v);
void   input_move(viewer *v, double seconds);       /* automatic motion */
int    window_open(viewer *v);
void   window_title(viewer *v);

/* ---- >>arguments.c */

/* The command line. scale, panel, strength: below 0 if not given. */
typedef struct asked {
    const char *scene, *method, *right, *env, *shot, *set[VIEWER_WISHES], *light[KIT_MAX_LIGHTS];
    int         sets, lights, camera, up, size[2], frames, panel, colours, ground, keys, command;
    double      place[6], upward[3], slide[3];
    double      fovy, ortho_height, radius, turn, strength, orbit, scale;
} asked;
int    arguments(viewer *v, asked *to, int argc, char **argv);
int    viewer_help(int argc, char **argv);            /* as kit_help, and the list of keys */

#endif
