/* sweeps.h - the methods that are swept, and the causes of failure, each a scene and one thing in it that changes. */
#ifndef LAB_SWEEPS_H
#define LAB_SWEEPS_H

#include "kit/kit.h"

#define DEGREE 0.01745329252f          /* in radians */

/* ---- >>methods --------------------------------------------------------------------------------------------------- */

/* Bits for the groups of methods that a cause is tried with: all that read the screen; light, which equals ambient
   visibility if it is white from everywhere; surfels; fields; methods that back faces help; a sun that turns. The last
   three are of one thing each: a bounce, a light's shadow, and unfiltered occlusion by so many directions. */
enum {
    SCREEN = 1,
    LIGHT = 2,
    OF_SURFELS = 4,
    FIELD = 8,
    THIN = 16,
    TURNED = 32,
    KEPT = 64 /* with history */,
    KEPT_LIGHT = 128 /* the same, of light */,
    BOUNCED = 256,
    SHADOWED = 512,
    COUNTED = 1024,
    FAR = 2048 /* judged by the second truth, as their occluders do not fade with distance */,
    AMBIENT = SCREEN | LIGHT | OF_SURFELS
};
/* A method that is swept. widest: the largest picture width at which it is drawn */
typedef struct swept { const char *label, *method, *settings; int of, widest; } swept;
enum { MOST_METHODS = 32 };
extern swept sweeps_method[MOST_METHODS];
extern int sweeps_methods;

/* ---- >>causes ---------------------------------------------------------------------------------------------------- */

/* formats of stored depth: view depth as 32F; as 16F; then three of window depth */
enum { EXACT = 1, HALF, UNORM24, FLOAT32, REVERSED32 };
enum { BOXES = 8, SUN_DEGREES = 3, MOST_VALUES = 12 };
/* One frame of a cause. Members that are 0 are the scene's own. */
typedef struct look {
    float value;                           /* value: of the cause; frame: the number of its frame */
    int   frame;
    const char *scene, *only;              /* only: the name of the one caster that stays, at placed */
    float placed[16], box[BOXES][6];       /* placed: a matrix; boxes with y1 > y0 are added */
    int   black;                           /* the number of the box that is black, from 1 on */
    float eye[3], target[3], up[3], fovy, znear, zfar;
    /* scale of the whole scene; then the camera moves: aside by so many of the target's pixels to the right, nearer by
       this share of the way to the target, rolls, and orbits the target, in degrees */
    float scale, aside, nearer, roll, orbit;
    float shift[2];                        /* jitter of the projection, in pixels */
    float radius, pixels;                  /* of occlusion; pixels: as so many pixels at the target */
    float where[6];                        /* bounds of the scored points, on axes with lower < upper */
    float sun[3], dimmed;                  /* direction to a sun in the sky, and the share of it that is taken away;
                                              without it light is white from everywhere */
    float lamp;                            /* above 0: the sun's half-angle in degrees, in a black sky; below: it is no
                                              part of the sky, but a light with a shadow map */
    int   bounced;                         /* 1: the bounce alone is looked at */
    char  set[32];                         /* further settings of each method */
    float went;                            /* how far the first box moved along x since the frame before */
    int   told;                            /* 1: with motion vectors */
    int   format, width, height, stride, rays, within;   /* within 1: a sun's truth is traced within the radius */
} look;

/* Kinds of figures: RMSE to the truth; RMSE to the same picture with exact depth; deviation over frames after
   reprojection, less the truth's; second difference over frames; second difference of light, over its mean, less an
   open surface's. With history: RMSE over that of the frame alone, the largest of a sequence; the same so many frames
   after CHANGED; the same over all frames, at points that the frame before did not show; after CHANGED, how much of the
   old picture remains, and the share of pixels where it is more than 0.05. Then 1 over the number of shades, of the 256
   of an image. */
enum { ERROR, PRECISION, DEVIATION, SECOND, LIT_SECOND, FOLLOWS, AFTER, NEWLY, TRAIL, HELD, SHADES };
enum { FRAMES = 16, CHANGED = 8 };
typedef struct result result;
typedef struct cause {
    const char *name, *title, *across, *about;     /* across: the value that varies, and its unit, for the axis */
    int kind, of, width, rays, log;        /* log 1: the chart's axis across is logarithmic */
    const char *look;
    double value[MOST_VALUES];             /* up to the first 0 after the first value */
    int told, format;                      /* told 1: with motion vectors; format: of depth */
    int (*curves)(result *r, kit_error *err);      /* sweeps the library's CPU functions instead of frames */
    const char *number, *up;               /* the meaning of a curve's number, and the axis up; NULL: the kind's */
    /* A sentence that the test group stability holds for the quick values ("": none), and bounds of curves' numbers:
       "label=least,most|...". Without a label they are of the reference beside the methods. */
    const char *holds, *bounds;
} cause;

enum { MOST_CAUSES = 64 };
extern cause sweeps_cause[MOST_CAUSES];
extern int sweeps_causes;
/* Reads the lines of methods.csv and causes.csv; call it first. Columns: see swept and cause; of: words with + between;
   depth: a name of format; look: rows of looks.csv or, without values, a function of maths.c. */
#define SWEEPS_FOLDER "examples/lab/stability"
void sweeps_load(void);

/* Rows of looks.csv make a frame, one after another. A row sets a member of look to its numbers; "box" adds one; "like"
   does what the rows of another look do; "scene", "only" and "set" are texts, and one that ends with = gets the value.
   Any other word names the number, for the rows behind. Numbers are expressions, as kit_seed.h explains them, of
   named numbers, v (the value), f (the frame), h (the height) and format. */
int  looks_has(const char *name);

/* Returns the look of a cause at a value, in one of its frames. */
look sweeps_look(const cause *c, double value, int frame);

#endif
