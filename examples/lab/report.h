/* report.h - what the units of build/report share. */
#ifndef REPORT_H
#define REPORT_H

#include "lab/page/page.h"
#include "kit/kit_gl.h"

/* ---- >>tables */

#define COUNT(table) ((int)(sizeof (table) / sizeof (table)[0]))
#define BUNNY   "/usr/share/glmark2/models/bunny.obj"
#define PACKAGE "glmark2-data"
#define BED     "build/models/iron-bed.obj"    /* make chart puts these there: examples/kit/models.sh */
#define MAPLE   "build/models/maple.obj"
#define HOUSE   "build/models/fzk-house.obj"

/* of timing: at least LEAST_ROUNDS, then no more where a time is SLOW times the reference's or ratios agree */
enum { RAYS = 256, FLOOR_STRIDE = 4, CHART_ROUNDS = 5, QUICK_ROUNDS = 3, LEAST_ROUNDS = 2, SLOW = 5, AO_WIDTH = 640,
    AO_HEIGHT = 360, AO_PHASES = 2 };
#define AGREED 0.05
/* of light the truth is traced at every LIT_STRIDE-th pixel both ways, and probed at some of these. A stride's pixel is
   the middle one of its block: strides on which that is traced, too */
enum { LIT_STRIDE = 2 };
#define ON_STRIDE(stride) ((stride) % LIT_STRIDE == 0 && (stride) / 2 % LIT_STRIDE == LIT_STRIDE / 2)
/* a quick chart's pictures have so many times shorter sides, and its truth that squared fewer rays, but no fewer than
   LEAST_RAYS */
extern int thrift;
enum { QUICK_THRIFT = 2, LEAST_RAYS = 16 };
enum { MOST_ENTRIES = 48, MOST_ROWS = MOST_ENTRIES + 2, MOST_SCENES = 16 };

/* quick: shown by chart --quick too */
typedef struct entry { const char *label, *method, *settings; int quick; } entry;
extern const entry reference;                  /* what times are relative to */

/* What lights a view (as build/render's options take it), how it is shown, and its truth. local: suns are blocked as
   the environment is, within the radius, not by all of the scene; in the truth they then are discs of SUN degrees
   around. */
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
extern const view views[];
extern const int views_count;
/* The packages that make chart takes such a mesh from; NULL = it is none of these. */
const char *packages_of(const char *path);

/* ---- >>stage.c: a scene, its light, its G-buffer, its truth and what else is shown beside methods */

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

int folder(const char *path, kit_error *err);
/* The truth's rays; every stride-th pixel. */
int trace(kit_image *out, const stage *s, int rays, int stride, kit_error *err);
/* The true ambient visibility (channel Y) of a stage that is lit. */
int stage_visibility(kit_image *out, const stage *s, kit_error *err);
int run_open(kit_run *run, stage *s, const char *method, const char *set, float radius, kit_error *err);
/* Load: the scene and its light; what the scene is of may change until it is shown. Look: what is seen. Compare: its
   truth, and what else is shown beside it. Show: both; open: all three. */
int stage_lit(stage *s, kit_error *err);
int stage_load(stage *s, const view *v, kit_error *err);
int stage_look(stage *s, const view *v, int width, int height, kit_error *err);
int stage_compare(stage *s, kit_error *err);
int stage_show(stage *s, const view *v, int width, int height, kit_error *err);
int stage_open(stage *s, const view *v, int width, int height, kit_error *err);
void stage_close(stage *s);

/* Scores a picture over what the frame shows, and where the picture is known; the unit on the same pixels. */
int score(row *r, const stage *s, const kit_image *picture, kit_error *err);
int light_by(kit_image *visibility, const stage *s, kit_error *err);
double draw(kit_run *run);
/* Times what once(of, i) draws, all drawn before, in ms: each once a round between two drawings of the reference, whose
   mean its time is divided by; medians. */
int clock_all(row *rows, stage *s, double (*once)(void *of, int i), void *of, int count, int rounds, kit_error *err);
/* Times runs, and closes them. */
int clock_runs(row *rows, stage *s, kit_run *run, int count, int rounds, kit_error *err);
/* With a history: SETTLED frames of a still camera, numbered from first, and 1; else one, and 0; -1 = failed. */
enum { SETTLED = 16 };
int draw_settled(kit_run *run, unsigned first, int timed, kit_error *err);
/* Fills a row an entry, then one for each of what is given: count + s->givens in all. Every entry is drawn once to warm
   up, with a history SETTLED frames (that picture is scored), over so many phases of its noise (0: one, and no split is
   known), then timed. pictures: NULL, or an empty one an entry. */
int measure(row *rows, stage *s, const entry *entries, int count, int rounds, int phases, kit_image *pictures,
            kit_error *err);

/* ---- >>parts.c */

typedef struct options { const char *out, *mesh, *method, *context, *scene[MOST_SCENES]; int quick, scenes; } options;
int asked(const options *o, const char *method);
int chosen(entry *out, const entry *entries, int count, const options *o);

int save(const kit_image *image, const char *names, int srgb, const char *out, const char *slug, const char *ending,
         kit_error *err);
void slug_of(char slug[64], const char *label);
/* A chart as a file of its own and inside the page. */
int chart_of(FILE *html, const char *out, const char *name, const char *title, const words *w, const row *rows,
             int count, double floor_, kit_error *err);
/* The part of a picture in crop (NULL: all), each pixel times x times: exposed R, G, B and their luminance Y. */
int exposed(kit_image *out, const kit_image *picture, float exposure, const int *crop, int times, kit_error *err);

/* A table on a scene: its rows, and what stands in the page. Kept until the chart is whole, so that an interrupted one
   goes on where it was. The k-th of its kind: how many rows; -1 = failed. rows NULL: whether there are any. */
typedef int measuring(FILE *html, const options *o, int k, row *rows, kit_error *err);
int planned(measuring *measure_, int count, const options *o);
void units_begin(const options *o, int all);
void units_end(void);
/* One table on one scene: measured, or as an interrupted chart left it. How many rows, 0: none are asked for; -1 =
   failed. */
int unit(FILE *html, const options *o, const char *kind, int k, measuring *measure_, row *rows, kit_error *err);
/* Small pictures: the truth, the best row of those that take no longer than the reference (else the fastest), the best
   of all. */
int thumbs(FILE *html, const char *out, const stage *s, const row *rows, const kit_image *pictures, int count,
           kit_error *err);

/* ---- >>lit.c, pairs.c, fields.c, deep.c, plan.c: what is shown of each; _text: the same rows as text */

int  lit_demo(FILE *html, const char *out, kit_error *err);
void lit_demo_text(FILE *f);
int  lit_units(const options *o);
int  lit_chart(FILE *html, const options *o, kit_error *err);
void lit_chart_text(FILE *f);
/* What a row's irradiance or ambient visibility is off by: on the mean over the phases of the noise, and from phase to
   phase. picture: the first phase's; run draws the others; NULL: a picture that has no noise. A second phase that is
   the first over again is the last. */
int split(row *r, stage *s, kit_run *run, int phases, const kit_image *picture, kit_error *err);
int  pair_units(const options *o);
int  pair_chart(FILE *html, const options *o, kit_error *err);
void pair_text(FILE *f, const options *o);
int  field_demo(FILE *html, const char *out, kit_error *err);
void field_demo_text(FILE *f);
int  field_units(const options *o);
int  field_chart(FILE *html, const options *o, kit_error *err);
void field_chart_text(FILE *f);
row blank(int of, const char *scene, const char *label, const char *settings);
int  deep_demo(FILE *html, const char *out, kit_error *err);
void deep_demo_text(FILE *f);
int  deep_units(const options *o);
int  deep_chart(FILE *html, const options *o, kit_error *err);
void deep_chart_text(FILE *f);

int  plan_fit(const char *out, kit_error *err);
int  plan_chart(FILE *html, const options *o, kit_error *err);
void plan_text(FILE *f);

/* ---- >>peers.c, costs.c */

enum { MOST_PEERS = 32, PEERS_QUICK = 8 };
const char *peers_note(void);
int peers_measure(row *rows, stage *s, int rounds, int most, kit_error *err);
int peers_points(row *points, const row *rows, int methods, int count);
void peers_verdict(FILE *f, const row *rows, int methods, int count);
void peers_terms(FILE *f);
int costs_chart(FILE *html, const char *out, kit_error *err);

#endif
