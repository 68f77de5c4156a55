/* stage.h - a scene as methods and the truth see it: its light, its G-buffer, its truth and what else is shown beside
   methods; and the views that the charts are made of. */
#ifndef LAB_STAGE_H
#define LAB_STAGE_H

#include "lab/measure/picture.h"
#include "lab/measure/rows.h"

#define BUNNY   "/usr/share/glmark2/models/bunny.obj"
#define BED     "build/models/iron-bed.obj"    /* make chart puts these there: examples/kit/models.sh */
#define MAPLE   "build/models/maple.obj"
#define HOUSE   "build/models/fzk-house.obj"

/* of the truth of ambient visibility; the floor is traced at every FLOOR_STRIDE-th pixel both ways (at every third of
   those of the truth where that has a stride) */
enum { RAYS = 256, FLOOR_STRIDE = 4 };
/* of light the truth is traced at every LIT_STRIDE-th pixel both ways, and probed at some of these. A stride's pixel is
   the middle one of its block: strides on which that is traced, too */
enum { LIT_STRIDE = 2 };
/* The size that people look at, and the truth there: so many rays keep its noise below a tenth of methods' errors, also
   where small bright parts of an environment bring much of the light. The stride is odd, so that of each 2x2 every
   pixel is scored alike, for half size gathers at one of these. */
enum { SEED_WIDTH = 1280, SEED_HEIGHT = 720, SEED_STRIDE = 11, SEED_RAYS = 1024 };
/* Seeds below this one may be looked at while settings are tuned; those from it on only report. */
enum { SEEDS_JUDGED = 1000 };
#define ON_STRIDE(stride) ((stride) % LIT_STRIDE == 0 && (stride) / 2 % LIT_STRIDE == LIT_STRIDE / 2)
/* A quick chart's pictures have so many times shorter sides, and its truth that squared fewer rays, but no fewer than
   LEAST_RAYS. 1 until it is set. */
extern int stage_thrift;
enum { QUICK_THRIFT = 2, LEAST_RAYS = 16 };

/* What lights a view (as build/render's options take it), how it is shown, and its truth. local: suns are blocked as
   the environment is, within the radius, not by all of the scene; in the truth they then are discs of SUN degrees
   around. env NULL: the scene's own, of scenes by seed. */
enum { MOST_SUNS = 2, MOST_CROPS = 2, SUN = 3 };
typedef struct lit {
    const char *env, *light[MOST_SUNS];
    int   boxes, bounce, local, rays;
    float exposure;
    int   crop[MOST_CROPS][4];                 /* x, y, width, height */
} lit;

/* A view of a scene; what is 0 is the scene's own. lit: NULL = ambient visibility. */
typedef struct view {
    const char *name, *path;
    int ground;
    float eye[3], target[3], fovy, radius;
    const lit *lit;
} view;
#define NO_CROPS { { 0 } }
extern const view stage_views[];               /* of ambient occlusion's chart; the first is the demo's */
extern const int stage_views_count;
/* Number i of the models that packages bring, seen by seed i; neighbours in their list are far apart in i. 0: there is
   no such package. */
int stage_model(char path[128], int i);
/* The packages that make chart takes such a mesh from; NULL = it is none of these. */
const char *stage_packages(const char *path);

typedef struct given { const char *label, *method; kit_image picture; } given;   /* a row without a method to time */

/* What is lit otherwise. hard: what blocks or sends within the radius counts whole. GLOSS: exponent of the lobe.
   SCATTER: material and its unit; rays are thousands of samples. */
enum { GLOSS = 1, SCATTER };
typedef struct otherwise { int hard, kind; float exponent, unit; const char *material; } otherwise;

typedef struct stage {
    char         name[64];
    kit_scene    scene;
    kit_gbuffer  gbuffer;
    const lit   *lit;
    otherwise    otherwise;
    int          rays, between;                /* of the truth; 1 = occlusion is between objects */
    int          stride;                       /* of the truth, 0 = 1; what is left out counts as not shown */
    kit_lighting lighting, traced;             /* as methods have it, as the truth has it */
    /* lit: suns and point lights with their shadows, without the environment, */
    kit_run      lights;
    /* and what ambient visibility leaves as it is: that, unless suns are local, too */
    kit_image    direct;
    kit_image    places;                       /* edges, border, interior */
    /* unit: what errors are shares of: AO: of no AO's, 1 everywhere; lit: of the mean, 0 everywhere */
    kit_image    frame, truth, unit;
    given        given[2];
    int          givens;
    float        radius;
} stage;

/* Load: the scene and its light; what the scene is of may change until it is shown. Look: what is seen. Compare: its
   truth, and what else is shown beside it; light: the latter alone, where the truth is not wanted whole. Show: look and
   compare; open: all three. */
int stage_load(stage *s, const view *v, kit_error *err);
int stage_look(stage *s, const view *v, int width, int height, kit_error *err);
int stage_light(stage *s, kit_error *err);
int stage_compare(stage *s, kit_error *err);
int stage_show(stage *s, const view *v, int width, int height, kit_error *err);
int stage_open(stage *s, const view *v, int width, int height, kit_error *err);
void stage_close(stage *s);

/* The truth alone, of its camera (gbuffer.camera), from build/cache where it was computed before. */
int stage_truth(stage *s, kit_error *err);
/* Two truths of ambient visibility at every pixel, PAIR_RAYS each, whose noise is independent: channels Y, again. */
enum { PAIR_RAYS = 64 };
int stage_pair(kit_image *out, const stage *s, kit_error *err);
/* The truth's rays; every stride-th pixel. */
int stage_trace(kit_image *out, const stage *s, int rays, int stride, kit_error *err);
/* The true ambient visibility (channel Y) of a stage that is lit. */
int stage_visibility(kit_image *out, const stage *s, kit_error *err);
/* Lit by ambient visibility: it dims the environment's light, not the lights'. */
int stage_dim(kit_image *visibility, const stage *s, kit_error *err);
/* A run of a method on the stage; its picture, settled (see picture_settled); a method's picture, drawn once. Where the
   stage is lit, pictures are of light. */
int stage_run(kit_run *run, stage *s, const char *method, const char *set, float radius, kit_error *err);
int stage_settled(kit_image *out, const stage *s, kit_run *run, unsigned first, int timed, kit_error *err);
int stage_drawn(kit_image *out, stage *s, const char *method, const char *set, float radius, kit_error *err);

#endif
