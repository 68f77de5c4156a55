/* sweeps.h - what is swept: methods, and the causes of failure, each a scene and one thing in it that changes. */
#ifndef LAB_SWEEPS_H
#define LAB_SWEEPS_H

#include "kit/kit.h"

#define DEGREE 0.01745329252f          /* in radians */

/* ---- >>methods --------------------------------------------------------------------------------------------------- */

/* What a method is shown with: all that reads the screen; light, which is ambient visibility when it is white and from
   everywhere; surfels; fields; what back faces mends; a sun that turns. */
enum {
    SCREEN = 1,
    LIGHT = 2,
    OF_SURFELS = 4,
    FIELD = 8,
    THIN = 16,
    TURNED = 32,
    KEPT = 64 /* over frames */,
    KEPT_LIGHT = 128 /* the same, of light */,
    AMBIENT = SCREEN | LIGHT | OF_SURFELS
};
/* widest: picture that it is drawn at */
typedef struct swept { const char *label, *method, *settings; int of, widest; } swept;
enum { MOST_METHODS = 24 };
extern const swept sweeps_method[];
extern const int sweeps_methods;

/* ---- >>causes ---------------------------------------------------------------------------------------------------- */

/* how depth is stored: view depth as 32F; as 16F; window depth */
enum { EXACT = 1, HALF, UNORM24, FLOAT32, REVERSED32 };
enum { BOXES = 3, SUN_DEGREES = 3, MOST_VALUES = 12 };
/* What a frame shows; what is 0 is the scene's own. */
typedef struct look {
    float value;                           /* of the cause, at which frame of it */
    int   frame;
    const char *scene, *only;              /* only: of what casts the first of that name is there alone, placed */
    float placed[16], box[BOXES][6];       /* boxes with y1 > y0 are added */
    float eye[3], target[3], up[3], fovy, znear, zfar;
    /* of the whole scene; the camera then moves by so many of the target's pixels to the right, by that share of the
       way to it, rolls, and goes around the target, in degrees */
    float scale, aside, nearer, roll, orbit;
    float shift[2];                        /* jitter of the projection, in pixels */
    float radius, pixels;                  /* pixels: of the radius at the target */
    float where[6];                        /* what is scored: bounds, on each axis where the lower one is lower */
    float sun[3], dimmed;                  /* direction to the sun, in the sky, and the share of it that is taken away;
                                              else light is white from everywhere */
    float went;                            /* how far the first box moved along x since the frame before */
    int   told;                            /* 1: with motion vectors */
    int   format, width, height, stride, rays, within;   /* within: the truth of a sun is traced, within the radius */
} look;

/* How frames become a figure: RMSE to the truth; to the same picture with exact depth; deviation over frames after
   reprojection, less the truth's; second difference over frames; that of light over its mean, less an open
   surface's; with history, RMSE over that of the frame alone, the most of a sequence, so many frames after CHANGED,
   and, all frames together, where the frame before showed something else; after CHANGED, what is left of what was, and
   the share of pixels where that is more than 0.05. */
enum { ERROR, PRECISION, DEVIATION, SECOND, LIT_SECOND, FOLLOWS, AFTER, NEWLY, TRAIL, HELD };
enum { FRAMES = 16, CHANGED = 8 };
typedef struct result result;
typedef struct cause {
    const char *name, *title, *across, *about;     /* across: what varies, and its unit */
    int kind, of, width, rays, log;        /* log: the axis is logarithmic */
    void (*at)(look *l);
    double value[MOST_VALUES];             /* up to the first 0 after the first value */
    int told, format;                      /* with motion vectors; how depth is stored */
    int (*curves)(result *r, kit_error *err);      /* instead: of the library's maths alone */
    const char *number, *up;               /* what the number is, and the chart's other axis; NULL = the kind's */
    /* What the test group stability holds of the quick values, "": nothing: a sentence, and bounds of curves' numbers,
       "label=least,most|...", no label: of what is seen beside the methods. */
    const char *holds, *bounds;
} cause;

enum { MOST_CAUSES = 48 };
extern cause sweeps_cause[MOST_CAUSES];
extern int sweeps_causes;
/* Their lines; to be read before the others ask. Columns: as cause has them; of: words with + between; depth: as format
   names it; look: a function of sweeps.c or, without values, of maths.c. */
#define SWEEPS_CAUSES "examples/lab/stability/causes.csv"
int sweeps_load(kit_error *err);

/* What a frame of a cause shows, at a value. */
look sweeps_look(const cause *c, double value, int frame);

#endif
