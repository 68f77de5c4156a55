/* sheet.h - a sheet is a table or figure of a paper: its printed figures, the figures drawn here for each row, and the
   paper's claims on the rows. The csv beside this file have the sheets, and read.c reads them; sheet.c draws a sheet,
   own.c draws those that need a drawing of their own, show.c prints them.

   papers    the papers, in order
   sheets    a line for each table or figure. heads: of the printed figures, with | between; columns, for each measured
             figure: HEAD=QUANTITY.DIGITS; drawn: how (below); view: a line of views, else a scene of that name;
             phases, stride, rays: of the noise and of the truth; pictured: 1 shows the rows' pictures beside the
             truth, 2 the light's crops, too; truth: the radius of the truth, if it is not that of the rows, and then
             it has no fade; below 0: lights, too, are shadowed within the rows' radius alone
   rows      printed: the paper's figures under the heads; no method: not drawn, and note says why, else note is a
             remark; reach: a part of the sheet's radius, empty: all of it; base: for overhead, the row, from 1 on, that
             it is relative to; ours: for a published algorithm, the row of the library's own; half: drawn at half the
             width and height; slow: the quick form leaves it out
   claims    a statement of the paper on a row, or on a row beside another, in a column, as a rule (below); why: the
             reason if it does not hold; unmodelled: for times, the reason why make cost's model cannot judge them
   modelled  milliseconds of rows by that model (build/cost --papers), which judge times if a software rasteriser draws;
             part: which of a row's passes, from 0 on, on a sheet that is drawn as passes
   views     the scene, its light and its truth, as in lab/measure/views.h
   absent    parts of a paper that are on no sheet, and why, or where a similar one is shown
   words     the text that replaces {word} in any of these texts */
#ifndef LAB_SHEET_H
#define LAB_SHEET_H

#include <math.h>
#include "lab/measure/stage.h"
#include "lab/page/units.h"

/* The quantity of a column, by its name in read.c. OVERHEAD: its time over that of its base, less 1, in per cent. OWN:
   a figure of the sheet's own drawing, figure[STAGE + k]. */
typedef enum quantity {
    TIME,              /* over that of one unblurred 16-sample ssao */
    MILLISECONDS,
    OVERHEAD,          /* of MILLISECONDS if the sheet shows them, else of TIME */
    ERROR,             /* of visibility: over that of no occlusion; of irradiance: over its mean */
    BIAS,              /* divided as ERROR is */
    BOUNCE_ERROR,      /* over the bounce's mean */
    RADIANCE_ERROR,
    NOISE,             /* deviation over the phases of the noise; of irradiance: over its mean */
    BOUNCE_NOISE,      /* of the bounce, over its mean */
    MODEL_ERROR,       /* RMSE of the mean over the phases */
    HUE,               /* degrees, over pixels in shade */
    MEAN,              /* over pixels with a surface: of visibility; of the bounce */
    SURFELS_DRAWN,
    RMSE,
    KILOBYTES,
    BAKE_SECONDS,
    OWN
} quantity;
typedef struct column { const char *head; int of, digits; } column;

/* PICTURES: beside the truth, with errors and times, one radius after another; HALVES: each at full or at half size;
   FIELDS: of occlusion between objects. TIMES: times alone, one size after another. The others: own.c. */
typedef enum drawing { PICTURES, HALVES, FIELDS, TIMES, PASSES, STAGES_OF, RATES, CROWD } drawing;

enum { MOST_HEADS = 6, MOST_PAPER_ROWS = 24, MOST_SHEETS = 48 };
typedef struct paper_row {
    const char *what, *printed[MOST_HEADS], *method, *settings, *note;
    float reach;
    int   width, height, base, ours, half, slow;
} paper_row;

/* Claims that a row's value in a column, divided by another row's (beside = ALONE: the value itself), lies between two
   bounds, and not at them. It is judged by figures with as many digits as are shown. If the row is of an algorithm as
   published, the library's own row is judged, too. */
typedef struct claim { const char *says, *why, *rule, *unmodelled; int column, row, beside; double least, most; } claim;
enum { ALONE = -1 };

typedef struct sheet {
    const char *paper, *name, *title, *theirs, *erratum, *ours, *head[MOST_HEADS];
    column      column[MOST_HEADS];
    const paper_row *rows;
    int          count;
    const claim *claims;
    int          claimed;
    drawing      drawn;
    view         see;
    lit          lit;
    int          width, height;            /* 0: SHEET_WIDTH x SHEET_HEIGHT */
    int          rays, phases, stride;     /* 0: SHEET_RAYS, not measured, every pixel */
    int          pictured;
    float        truth;
} sheet;
enum { SHEET_WIDTH = 320, SHEET_HEIGHT = 180, SHEET_RAYS = 64, SHEET_ROUNDS = 3 };

/* ---- read.c */

#define SHEET_FOLDER "examples/lab/papers"
/* The k-th of all sheets; NULL past the last. A mistake in the csv ends the program with a sentence. */
const sheet *papers_sheet(int k);
/* The bounds of a rule: "less", "much less", "little more" (than the row beside it), "alike 0.1" (within a tenth of
   it), "similar" (to a reference: an error below a quarter of its mean; of visibility, below a quarter of the error of
   no occlusion), "as printed 5.5" (within a factor of 1.5), "within 19 21". -1: there is no such rule. */
int sheet_rule(claim *c, const char *rule);

/* ---- sheet.c, own.c */

/* Fills a row for each of the sheet's (row_blank if it is not drawn), and writes pictures. Returns 0, or -1. */
int  sheet_draw(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err);
/* Draws a sheet in a way of its own. */
int  sheet_own_draw(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err);
/* Opens a stage for the rows of one radius and size. first: the first of these rows. */
int  sheet_open(stage *s, const sheet *t, const paper_row *first, kit_error *err);
int  sheet_rounds(const options *o);
/* Fills all rows as not drawn. */
void sheet_blank(const sheet *t, row *rows);
/* Writes the text above pictures: triangles, pixels, radius, rays. */
void sheet_about(FILE *record, const stage *s);
/* How many heads a sheet has; sheet_columns: how many columns. */
int  sheet_heads(const sheet *t);
int  sheet_columns(const sheet *t);
/* The value of a cell, rounded to its column's digits; NAN: there is none. */
double sheet_value(const sheet *t, const row *rows, int i, int c);
/* The value or ratio by which a claim is judged. */
double sheet_judged(const sheet *t, const claim *c, const row *rows);
/* Whether a column holds times, which another run would not repeat. */
int    sheet_timed(const sheet *t, int c);
/* Whether a claim holds: 1, 0; UNKNOWN: a row was not drawn; UNJUDGED: it is on times, and a CPU drew. */
enum { UNKNOWN = -1, UNJUDGED = -2 };
int    sheet_holds(const sheet *t, const claim *c, const row *rows);
/* Whether the library's own rows take part in a claim; own: the claim on those rows. */
int    sheet_own(claim *own, const sheet *t, const claim *c);
/* What is drawn of a row that is drawn as passes, and its figures of the milliseconds of these. */
enum { PARTS = 4 };
extern const entry sheet_parts[PARTS];
void   sheet_passes(row *r, const double ms[PARTS]);
/* Of times of all sizes which frames are lost, and the averages below them. */
void   sheet_rates(const sheet *t, row *rows);

/* ---- modelled.c: times by the model of make cost */

/* A sheet's rows as modelled, which last until the next call, and the sheet with more digits, as a GPU takes few
   milliseconds; NULL: there are none. */
const row *sheet_modelled(sheet *finer, const sheet *t);
/* What judges a claim: the rows; of times that a software rasteriser took, the modelled ones, with a sheet that shows
   more digits of them; NULL: nothing does. */
const row *sheet_judge(const sheet **t, const claim *c, const row *rows);
/* Whether a row is one of a claim on times that is to be modelled. */
int    sheet_wants_model(const sheet *t, int i);

/* ---- show.c: a sheet and its rows, as csv */

void   show_csv_head(FILE *f);
void   show_csv(FILE *f, const sheet *t, const row *rows);
/* Shows the parts of a paper that are on no sheet: on the page, or as csv. */
void   show_absent(FILE *record, FILE *f, const char *paper);
/* A claim, its outcome, the figures that decided it, and the bounds beyond which it would be another. */
enum { SENTENCE = 1024 };
const char *show_claim(char out[SENTENCE], const sheet *t, const claim *c, const row *rows);

#endif
