/* stage.h - a stage: a scene, its light, its G-buffer, its truth and the pictures beside methods; and views of
   charts. */
#ifndef LAB_STAGE_H
#define LAB_STAGE_H

#include "lab/measure/picture.h"
#include "lab/measure/rows.h"

#define BUNNY   "/usr/share/glmark2/models/bunny.obj"
#define BED     "build/models/iron-bed.obj"    /* make chart gets it by examples/kit/models.sh */

/* RAYS: of the truth of ambient visibility, at each pixel. The floor is traced at every FLOOR_STRIDE-th pixel both
   ways, or at every third pixel of a truth that has a stride. */
enum { RAYS = 256, FLOOR_STRIDE = 4 };
/* The truth of light is traced at every LIT_STRIDE-th pixel both ways, the middle one of each block. ON_STRIDE: whether
   the middles of another stride's blocks are traced, too, so that noise can be probed there. */
enum { LIT_STRIDE = 2 };
/* The size at which people look at pictures, and the truth at that size. Its rays keep its noise below a tenth of
   methods' errors, also if small bright parts of an environment bring much of the light. The stride is odd, so that all
   four pixels of a 2x2 are scored equally often, also in gathers of half resolution. */
enum { SEED_WIDTH = 1280, SEED_HEIGHT = 720, SEED_STRIDE = 11, SEED_RAYS = 1024 };
/* Settings may be tuned on seeds below this one. Seeds from it on are for reports alone. */
enum { SEEDS_JUDGED = 1000 };
#define ON_STRIDE(stride) ((stride) % LIT_STRIDE == 0 && (stride) / 2 % LIT_STRIDE == LIT_STRIDE / 2)
/* stage_thrift divides the width and the height of a quick chart's pictures, and its square the truth's rays (at least
   LEAST_RAYS stay). It is 1 until it is set. */
extern int stage_thrift;
enum { QUICK_THRIFT = 2, LEAST_RAYS = 16 };

/* The light of a view (in words of build/render's options), its exposure, and its truth. local: suns are blocked within
   the radius, as the environment is, not by all of the scene; in the truth they are discs of SUN degrees in diameter.
   env NULL: the scene's own, for scenes by seed. */
enum { MOST_SUNS = 2, SUN = 3 };
typedef struct lit {
    const char *env, *light[MOST_SUNS];
    int   boxes, bounce, local, rays;
    float exposure;
} lit;

/* Effects with a truth of their own. hard: an occluder or sender within the radius counts whole. GLOSS: the exponent of
   the lobe. SCATTER: material and its unit; rays are thousands of samples. */
enum { GLOSS = 1, SCATTER };
typedef struct otherwise { int hard, kind; float exponent, unit; const char *material; } otherwise;

/* The place of an object of a scene, by its name. */
typedef struct spot { char name[16]; float size, at[3]; } spot;

/* A view of a scene. Members that are 0 are the scene's own. lit NULL: ambient visibility. rays: of the truth; crop:
   parts of its pictures (x, y, width, height); solid: boxes that are added, six bounds and a colour each; package: the
   one that has the mesh. between 1: occlusion is between objects, and solids do not cast; if any has a spot, those
   without one are hidden in the ground; time: milliseconds that objects have moved. */
enum { MOST_CROPS = 2, MOST_SOLIDS = 4, MOST_SPOTS = 2 };
typedef struct view {
    const char *name, *path, *package;
    int ground, rays, between, crop[MOST_CROPS][4];
    float eye[3], target[3], fovy, radius, solid[MOST_SOLIDS][9];
    const lit *lit;
    otherwise otherwise;
    double time;
    spot spot[MOST_SPOTS];
} view;
/* Makes the path of model number i of those that packages bring, for seed i; models that are neighbours in the
   packages' list have distant numbers. Returns 0 if the package is missing. */
int stage_model(char path[128], int i);

typedef struct given { const char *label, *method; kit_image picture; } given;   /* a picture scored as a row */

typedef struct stage {
    char         name[64];
    kit_scene    scene;
    kit_gbuffer  gbuffer;
    const lit   *lit;
    otherwise    otherwise;
    int          rays, between;                /* rays of the truth; between 1: occlusion is between objects */
    int          stride;                       /* of the truth (0 = 1); the pixels between count as not shown */
    kit_lighting lighting, traced;             /* lighting: for methods; traced: for the truth */
    /* if lit: runs of the suns and point lights with their shadows, without the environment, */
    kit_run      lights;
    /* and the light that ambient visibility must not dim: of suns and point lights, unless suns are local */
    kit_image    direct;
    /* unit: the picture whose error is 1: without light no AO, 1 everywhere; if lit, 0 everywhere */
    kit_image    frame, truth, unit;
    given        given[2];
    int          givens;
    float        radius;
} stage;

/* stage_load: loads the scene and its light; the scene may be changed until stage_look, which draws the G-buffer.
   stage_compare: traces the truth and adds the given pictures; stage_light: the given ones alone, for a truth that is
   not needed whole. stage_show: look and compare; stage_open: all three. */
int stage_load(stage *s, const view *v, kit_error *err);
int stage_look(stage *s, const view *v, int width, int height, kit_error *err);
int stage_light(stage *s, kit_error *err);
int stage_compare(stage *s, kit_error *err);
int stage_show(stage *s, const view *v, int width, int height, kit_error *err);
int stage_open(stage *s, const view *v, int width, int height, kit_error *err);
void stage_close(stage *s);

/* Traces the truth of gbuffer.camera alone, or reads it from build/cache. */
int stage_truth(stage *s, kit_error *err);
/* Two truths of ambient visibility at every pixel, of PAIR_RAYS each, with independent noise: channels Y and again. */
enum { PAIR_RAYS = 64 };
int stage_pair(kit_image *out, const stage *s, kit_error *err);
/* Traces the truth by so many rays, at every stride-th pixel. */
int stage_trace(kit_image *out, const stage *s, int rays, int stride, kit_error *err);
/* Returns the true ambient visibility (channel Y) of a lit stage. */
int stage_visibility(kit_image *out, const stage *s, kit_error *err);
/* Turns a picture of visibility into light: it dims the environment's light, not that of lights. */
int stage_dim(kit_image *visibility, const stage *s, kit_error *err);
/* stage_run opens a run of a method; stage_settled reads its picture after picture_settled; stage_drawn draws a
   method's picture once. On a lit stage pictures are of light. */
int stage_run(kit_run *run, stage *s, const char *method, const char *set, float radius, kit_error *err);
int stage_settled(kit_image *out, const stage *s, kit_run *run, unsigned first, int timed, kit_error *err);
int stage_drawn(kit_image *out, stage *s, const char *method, const char *set, float radius, kit_error *err);

#endif
