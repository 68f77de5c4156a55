/* viewer.h - what the viewer's files share; viewer.c says what each of them is for. */
#ifndef VIEWER_H
#define VIEWER_H

#define GL_GLEXT_PROTOTYPES
#define GLFW_INCLUDE_NONE
#include <GL/glcorearb.h>
#include "kit/kit.h"
#include <pthread.h>

struct GLFWwindow;

static const double VIEWER_FARTHEST = 1e15;    /* as of an OBJ: squares of distances are floats, too */

/* ---- >>gl.c */

extern int gl_software;                     /* the renderer is a CPU: timer queries would answer before it has drawn */
GLuint gl_program(const char *vertex, const char *fragment, kit_error *err);
/* slices 0: a 2D texture, else an array. One level and nearest texels: complete without mips. */
GLuint gl_texture(int width, int height, int slices, GLenum internal, GLenum format, GLenum type, const void *data);
GLuint gl_framebuffer(const GLuint *colour, int colours, GLuint depth);
void   gl_bind(GLuint unit, GLenum target, GLuint texture);

/* GPU time of what is drawn between begin and end; its answers come some frames later, and none waits for them. */
enum { RING = 4 };
typedef struct timer { GLuint query[RING]; unsigned turn; double began, ms; } timer;
void   timer_begin(timer *t);
void   timer_end(timer *t);

/* ---- >>gbuffer.c */

typedef struct gbuffer {
    int    width, height;
    GLuint array, vertices, draw, peel;     /* programs */
    GLsizei count;
    GLuint depth, normal, albedo, framebuffer;
    GLuint back, back_framebuffer;          /* depth of the nearest back faces */
    GLuint slabs, seen[2], slab_depth, slab_framebuffer[2];
    timer  time, slab_time;
} gbuffer;

int    gbuffer_open(gbuffer *g, const kit_mesh *mesh, kit_error *err);
void   gbuffer_size(gbuffer *g, int width, int height);
/* behind: SSGI_GL_THICKNESS_BACK wants one more draw, depth alone; _SLABS three, each of which peels by the one
   before. */
void   gbuffer_draw(gbuffer *g, const float view[16], const float projection[16], int behind);

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
    float              radius;
    int                lit, started, quit, failed;
    unsigned           wanted;              /* counts requests: another number cancels what is being traced */
    progress           now;
    float             *rgb;
    int               *rays;                /* a pixel; 0: not known, rgb is a neighbour's */
    kit_error          err;                 /* of what failed */
} truth;

/* Starts over when anything that it depends on is another than before. */
int    truth_want(truth *t, const kit_camera *camera, float radius, int lit, kit_error *err);
void   truth_close(truth *t);

/* ---- >>viewer.c: methods, halves of the window, what is chosen */

enum { STEPS = 32, TEXTURES = 48 };
typedef struct chain {
    ssgi_gl_step step[STEPS];
    int    steps, light, bounce;            /* numbers of the results' textures, -1: there is none */
    GLuint program[STEPS], framebuffer[STEPS][2], texture[TEXTURES][2], block;
    timer  time[STEPS];
    unsigned drawn;                         /* frames; what is kept over them is written in turn */
} chain;

typedef struct method { const char *name; int pass, search, lit; float thickness; } method;
enum { METHODS = 6, TRUTH = METHODS, OPEN = 32, MAP = 64 };
extern const method methods[METHODS];
enum { BEHINDS = SSGI_GL_THICKNESS_SLABS + 1 };   /* words of desc.thickness */
extern const char *const presets[3], *const behinds[BEHINDS];

typedef struct half {
    int       method, preset, known;        /* known: last is of the frame before */
    chain     chain;
    ssgi_view last;
    float     last_to_view[16], harmonics[48];
    GLuint    environment, irradiance, picture, framebuffer;  /* picture: linear; alpha 0 where nothing is seen */
    double    error;
} half;

typedef struct viewer {
    struct GLFWwindow *window;
    kit_scene    scene;
    kit_lighting lighting;
    float       *equirect;                  /* the environment's texels, interleaved */
    kit_camera   camera, home;
    float        radius, split;
    int          behind, from_depth, history, split_on, error, colours, help, panel, dirty, shots;
    gbuffer      gbuffer;
    half         half[2];
    truth        truth;
    progress     shown;                     /* of the truth, when its picture was made */
    unsigned     frame;
    double       mouse[2], scored;
    GLuint       resolve, display, text, quads, truth_picture;
    char         note[256];
    double       noted;
    const char  *shot, *env;
    int          frames;
    kit_error    err;
} viewer;

/* ---- >>panel.c */

int    panel_open(viewer *v);
void   panel_say(viewer *v, const char *text);      /* for some seconds */
void   panel_draw(viewer *v);

/* ---- >>pictures.c */

/* RMSE where something is seen and the truth is known: of visibility, or of radiance over its mean. */
void   half_score(viewer *v, half *h);
int    window_save(viewer *v, const char *path);
void   picture_save(viewer *v, int exr);            /* under a name that is free */

/* ---- >>window.c */

int    window_open(viewer *v, const int size[2]);

/* ---- >>arguments.c */

/* What was asked for and is not the viewer's own. */
typedef struct asked {
    const char *scene;
    int         ground, help, camera, up, size[2];
    float       place[6], upward[3], radius[1];
} asked;
extern const char usage[];
int    arguments(viewer *v, asked *to, int argc, char **argv);

#endif
