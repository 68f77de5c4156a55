/* page.h - rows of figures, and what they are shown as: text, CSV, SVG charts, HTML. */
#ifndef PAGE_H
#define PAGE_H

#include <stdio.h>
#include "kit/kit.h"

enum {
    OF_AO = 1,
    OF_LIT = 2,
    OF_SPLIT = 4,
    OF_FIELD = 8,
    OF_COST = 16,
    OF_BAKE = 32,
    OF_PAIR = 64,
    OF_FIELDS = OF_FIELD | OF_COST | OF_BAKE | OF_PAIR,
    OF_DEEP = 128,
    OF_DEEP_LIT = 256,
    OF_GROWTH = 512,
    OF_STAGES = 1024,
    OF_TURN = 2048,
    OF_MOTION = 4096,
    OF_PHASES = 8192,
    OF_PEER = 16384,
    OF_PLACES = OF_AO | OF_LIT,
    OF_DEEPS = OF_DEEP | OF_DEEP_LIT | OF_GROWTH | OF_STAGES | OF_TURN | OF_MOTION,
    SPLITS = 5
};

/* What is known of fields: of the bake; of a picture's error beside its score; the occluders' reach as a share of the
   picture, each counted; of two occluders' occlusions. Of deep screen space: what is splatted; its stages' shares of
   the time; how far the camera is turned; what a place's visibility varies by while the camera moves. Of AO, and of
   irradiance: edges, border and interior apart. */
enum {
    TRIANGLES,
    RESOLUTION,
    RADII,
    BAKE_RAYS,
    THREADS,
    SECONDS,
    WORK,
    BYTES,
    BAKED_MEDIAN,
    BAKED_P95,
    BAKED_MOST,
    MEDIAN,
    MOST,
    COVERED,
    BY_PRODUCT,
    BY_MOST,
    BY_SUM,
    BETWEEN,
    SURFELS,
    SPLATS,
    PICTURE,
    STAGE,
    STAGES = 7,
    DEGREES = STAGE + STAGES,
    FLICKER,
    FLICKER_TRUE,
    FLICKER_ADDED,
    FITTED,
    PLACE_ERROR,
    PLACE_AREA = PLACE_ERROR + KIT_PLACES,
    PLACE_RMSE = PLACE_AREA + KIT_PLACES,
    PLACE_BIAS = PLACE_RMSE + KIT_PLACES,
    FIGURES = PLACE_BIAS + KIT_PLACES
};

/* What is known about one setting on one scene (or about the mean of them). What does not apply is NAN. */
typedef struct row {
    const char *scene, *label, *method, *settings;   /* label: names the curve; rows of one curve follow each other */
    double fetches, bytes, relative, ms, share;
    kit_score score;                                 /* of ambient visibility, or of radiance */
    /* the columns that it is shown with; not OF_AO: share is error[0], and these are known: */
    int of;
    /* RMSE and bias of radiance, irradiance, bounce, over the truth's means */
    double error[3], bias[3];
    /* OF_SPLIT, OF_PHASES: irradiance's or visibility's total error, what of it is the model's and noise; hue, of
       all and of what is in shade */
    double split[SPLITS];
    double figure[FIGURES];                          /* OF_FIELDS, OF_DEEPS */
} row;

/* A page grows in memory and reaches the disk whole, or not at all. */
typedef struct page { FILE *file; char *text; size_t size; } page;
int page_open(page *p, kit_error *err);
int page_close(page *p, const char *folder, const char *name, kit_error *err);
void page_into(page *p, FILE *f);     /* what a page holds becomes part of another file */

/* What a run's figures come from, for build/figures: a line of its kind (full, quick or part), and one of command,
   commit, machine and driver. */
int run_note(const char *folder, const char *name, const char *kind, const char *command, kit_error *err);

void escaped(FILE *f, const char *s);
const char *settings_of(const row *r);
void table_text(FILE *f, const row *rows, int count);
void table_html(FILE *f, const row *rows, int count);
void table_csv(FILE *f, const row *rows, int count, int head);

/* What SVG charts are drawn with. */
enum { WIDE = 900, HIGH = 566, LEFT = 74, RIGHT = 876, TOP = 138, BOTTOM = 498 };
/* what lies at the frame's sides; x as logarithms unless even */
typedef struct scale { double x0, x1, y0, y1; int even; } scale;
double across(const scale *s, double v);
double up(const scale *s, double v);
double step_of(double least, double span);           /* 1, 2 or 5 times a power of ten: at most six lines in span */
const char *colour_of(int series);
void marker(FILE *f, int series, double x, double y);

/* what stands at a chart's top and sides; in tooltips (fetches NULL: no numbers beside the points); even: no log
   scale */
typedef struct words { const char *about, *across, *up, *relative, *fetches; int even; } words;
extern const words ao_words, lit_words, turn_words, field_words;
/* rows: points with a relative time; others (floor, no AO) are skipped. floor_: share, NAN = no line. */
void chart_svg(FILE *f, const char *title, const words *w, const row *rows, int count, double floor_);

void html_head(FILE *f, const char *title, const char *about);
/* A picture and, under it, its difference to the truth; the caller ends the figure. */
void figure_html(FILE *f, const char *slug, const char *label, const char *note, int width, int height, int difference);
void key_html(FILE *f, double range);
void html_terms(FILE *f);
void lit_terms(FILE *f);
void field_terms(FILE *f);
void deep_terms(FILE *f);

#endif
