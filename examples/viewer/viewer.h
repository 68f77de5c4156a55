/* viewer.h - what the viewer's files share; viewer.c says what each of them is for. */
#ifndef VIEWER_H
#define VIEWER_H

#include "kit/kit_gl.h"
#include <pthread.h>

struct GLFWwindow;

enum { VIEWER_PATH = 4096, VIEWER_WISHES = 64,
       VIEWER_STILL = 32 };                 /* frames of a view that stays, after which it is drawn no more */

/* ---- >>truth.c */

typedef struct progress {
    unsigned version;                       /* counts what was added */
    int      tracing, rounds;               /* rays a pixel of the round that is traced now; rounds that are whole */
    float    share;                         /* of that round */
} progress;

typedef struct truth {
    pthread_t          thread;
    pthread_mutex_t    lock;                /* of all below: the thread reads what is wanted and writes what it found */
    pthread_cond_t     wake;
    const kit_scene   *scene;
    const kit_lighting *lighting;
    kit_camera         camera;              /* what is wanted; everything below as well */
    kit_method         method;
    float              radius;
    int                started, quit, failed;
    unsigned           wanted;              /* counts requests: another number cancels what is being traced */
    progress           now;
    float             *rgb;
    int               *rays;                /* a pixel; 0: not known, rgb is a neighbour's */
    kit_error          err;                 /* of what failed */
} truth;

/* Starts over when anything that it depends on is another than before. */
int    truth_want(truth *t, const kit_camera *camera, const kit_method *method, float radius, kit_error *err);
/* Before the scene or its light change: the thread is no more, until truth is wanted again. */
void   truth_stop(truth *t);

/* ---- >>viewer.c */

/* A half of the window: a method on its frames, or the truth. */
typedef struct side {
    kit_method method;
    int        truth;
    kit_frames frames;
    GLuint     picture, framebuffer;        /* visibility or radiance as drawn; alpha 0 where nothing is seen */
    double     error;                       /* to the truth; NAN: not known */
    kit_error  failed;                      /* why it is not drawn; "": it is */
} side;

typedef struct light {
    char         env[VIEWER_PATH];          /* name or path, "": none */
    kit_image    read;                      /* as it was read */
    double       turn, strength;
    int          asked;                     /* by the user: a scene's own light does not take its place */
    kit_lighting now;
    GLuint       texture;                   /* the environment's, for what lies behind the scene; 0: none */
} light;

typedef struct pace {
    double fixed;                           /* share of the window's sides that is drawn; 0: as there is time for */
    int    level, lowest;                   /* of the shares, while the view moves; the lowest of this window */
    int    still;                           /* the view stays: all of the window's size is drawn */
    int    coarse;                          /* while it moves surfels are 2^coarse times as wide */
    double moved;                           /* when it moved last, or another setting was chosen */
    int    opened;                          /* frames since settings changed that were drawn from the G-buffer on */
} pace;

typedef struct viewer {
    struct GLFWwindow *window;
    char         path[VIEWER_PATH];         /* the scene's */
    int          ground;
    kit_scene    scene;
    light        light;
    kit_camera   camera, home;
    float        radius, asked_radius;
    char         wish[VIEWER_WISHES][64];   /* settings that methods get where they have them: key=value */
    int          wishes;
    /* of the window */
    float        split;
    int          split_on, error, colours, help, panel, shots, size[2];
    double       mouse[2];
    pace         pace;
    side         side[2];
    int          kept;                      /* the scene's triangles are on the GPU */
    kit_gbuffer  gbuffer[2], *seen;         /* of this frame and the last; seen: this one's, NULL: none yet */
    float        stood[2][3];               /* slid, in each of them */
    int          drawn[2];                  /* size */
    int          moved, restart, redraw;    /* since the last frame: the view; anything of the methods; the text */
    unsigned     frame, still;              /* all frames; those since the view moved */
    unsigned     mean;                      /* frames at rest whose mean is shown; 0: the last frame is */
    GLuint       mean_picture, mean_framebuffer;
    double       ms;
    /* what moves by itself */
    int          circles, slides;
    double       orbit, last, phase;        /* degrees a frame; seconds; of the object that slides */
    float        slid[3];                   /* it stands so far from its place */
    truth        truth;
    progress     shown;                     /* of the truth, when its picture was made */
    GLuint       truth_picture;
    double       scored;
    GLuint       resolve, display, motion, text, glyphs;
    char         note[1200], title[300];
    double       noted, titled;
    const char  *shot;
    int          frames, command, asks;     /* command: at the end; asks: after the next frame */
    kit_error    err;
} viewer;

/* ---- >>settings.c: methods and what they are asked for */

/* The method whose number that is, with what is wished for; strict: a wish that it does not take is an error. */
int    method_choose(viewer *v, side *s, int number, int strict);
int    wish(viewer *v, const char *text);           /* key=value; -1: there is no room */
int    setting_of(kit_setting *out, const kit_method *m, const char *key);     /* 0: the method has none of that key */

/* ---- >>load.c: scenes and light. What fails leaves all as it was */

int    scene_open(viewer *v, const char *path);
int    env_open(viewer *v, const char *name);       /* "": none */
int    env_adjusted(viewer *v);                     /* once turn or strength are others */
void   light_changed(viewer *v);                    /* before lamps are others */
kit_light *sun_of(viewer *v);                       /* the first one; there is one then */
void   dropped(viewer *v, const char *path);
void   load_close(viewer *v);

/* ---- >>draw.c: a frame */

int    draw_open(viewer *v);
int    draw_frame(viewer *v);               /* of the methods, where anything is to be drawn */
void   draw_window(viewer *v);              /* both halves into the window */
int    draw_settled(const viewer *v);       /* another frame would not differ */
void   draw_forget(viewer *v);              /* before the scene's triangles change */
void   draw_close(viewer *v);

/* ---- >>motion.c */

int    motion_open(viewer *v);
/* What slides, from the last G-buffer to the next: a texture of it, for history. */
int    motion_draw(viewer *v, kit_gbuffer *next, const kit_gbuffer *last);

/* ---- >>pace.c: the size that there is time for */

void   pace_begin(pace *p, const int window[2], int software);
void   pace_size(pace *p, const int window[2], int size[2]);
int    pace_took(pace *p, double ms, int surfels);  /* of such a frame; 1: the next one is drawn otherwise */
double pace_coarse(const pace *p);
void   pace_moves(pace *p);
void   pace_stays(pace *p);                 /* after a while of that the size is the window's */
int    pace_waits(const pace *p);           /* staying would not change the size now */
double pace_share(const pace *p);

/* ---- >>panel.c */

int    panel_open(viewer *v);
void   panel_say(viewer *v, const char *text);      /* for some seconds */
int    panel_says(const viewer *v);
void   panel_draw(viewer *v);

/* ---- >>pictures.c */

/* RMSE where something is seen and the truth is known: of visibility, or of radiance over its mean. */
void   side_score(viewer *v, side *s);
int    window_save(viewer *v, const char *path);
void   picture_save(viewer *v, int exr);            /* under a name that is free */

/* ---- >>command.c */

/* The line that has build/render draw the left half's picture: on standard output. */
void   command_print(viewer *v);

/* ---- >>keys.c, input.c, window.c */

typedef struct press { viewer *v; const struct key *key; int shift; } press;
/* by, setting: by how much it changes, or which setting */
typedef struct key { int code; const char *label, *about; void (*press)(press p); double by; const char *setting; } key;
extern const key keys[];                    /* ends with code 0 */
void   slide_to(viewer *v, const float to[3]);      /* the first object that casts, from its place */
void   input_open(viewer *v);
void   input_move(viewer *v, double seconds);       /* what moves by itself */
int    window_open(viewer *v);
void   window_title(viewer *v);

/* ---- >>arguments.c */

typedef struct asked {
    const char *scene, *method, *right, *env, *set[VIEWER_WISHES], *light[KIT_MAX_LIGHTS];
    int         sets, lights, help, version, camera, up;
    double      place[6], upward[3], slide[3];
    double      fovy, ortho_height;
} asked;
int    arguments(viewer *v, asked *to, int argc, char **argv);
void   usage(void);

#endif
