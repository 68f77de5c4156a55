/* sheet.h - a table or figure of a paper: what the paper prints, what is drawn here for each row, what the paper says
   of the rows. The csv beside this file hold them, and read.c reads these; sheet.c draws a sheet, own.c those that are
   drawn in a way of their own, show.c prints them.

   papers    the papers, in order
   sheets    a line a table or figure. heads: of what is printed, with | between; columns: HEAD=QUANTITY.DIGITS of what
             is measured; drawn: how (below); view: a line of views, else a scene of that name; phases, stride, rays: of
             the noise and of the truth; pictured: 1 has rows as pictures beside the truth, 2 the light's crops, too;
             truth: the radius of the truth where it is not the rows', which then has no fade; below 0: lights, too,
             are shadowed within the rows' radius alone
   rows      printed: the paper's figures under the heads; no method: not drawn, and note says why, else note is a
             remark; reach: of the sheet's radius, empty for all of it; base: the row, from 1 on, that overhead is over;
             ours: of a published algorithm the row that is the library's; half: drawn at half the width and height;
             slow: the quick form leaves it out
   claims    what the paper says of a row, or of a row beside another, in a column, as a rule (below); why: where it
             does not hold, the reason
   views     what is seen, what lights it, and its truth, as lab/measure/stage.h has them
   absent    what of a paper is on no sheet, and why, or where its like is shown
   words     what {word} in any of these texts stands for */
#ifndef LAB_SHEET_H
#define LAB_SHEET_H

#include <math.h>
#include "lab/measure/stage.h"
#include "lab/page/units.h"

/* What a column shows of a row, by the names that read.c has. OVERHEAD: its time over the row's that it is based on,
   less 1, in per cent. OWN: what the sheet's own drawing left in figure[STAGE + k]. */
typedef enum quantity {
    TIME,              /* over that of one unblurred 16-sample ssao */
    MILLISECONDS,
    OVERHEAD,          /* of the MILLISECONDS that the sheet shows, else of its TIME */
    ERROR,             /* of visibility: share of no occlusion's; of irradiance: over its mean */
    BIAS,              /* of the same */
    BOUNCE_ERROR,      /* over the bounce's mean */
    RADIANCE_ERROR,
    NOISE,             /* deviation over the phases of the noise; irradiance's over its mean */
    BOUNCE_NOISE,      /* the bounce's, over its mean */
    MODEL_ERROR,       /* RMSE of the mean over them */
    HUE,               /* degrees, of what is in shade */
    MEAN,              /* where something is seen: of visibility; of the bounce */
    SURFELS_DRAWN,
    RMSE,
    KILOBYTES,
    BAKE_SECONDS,
    OWN
} quantity;
typedef struct column { const char *head; int of, digits; } column;

/* PICTURES: beside the truth, with errors and times, once a radius; HALVES: each at full or at half size; FIELDS: of
   occlusion between objects. TIMES: alone, once a size. The others: own.c. */
typedef enum drawing { PICTURES, HALVES, FIELDS, TIMES, PASSES, STAGES_OF, RATES, CROWD } drawing;

enum { MOST_HEADS = 6, MOST_PAPER_ROWS = 24, MOST_SHEETS = 48 };
typedef struct paper_row {
    const char *what, *printed[MOST_HEADS], *method, *settings, *note;
    float reach;
    int   width, height, base, ours, half, slow;
} paper_row;

/* A range of a row's value over another's, in a column; beside = ALONE: of the value itself. It holds between the
   bounds, not at them, and is judged by figures as they are shown. Where a row is of an algorithm as published, the
   library's own rows are judged beside it. */
typedef struct claim { const char *says, *why, *rule; int column, row, beside; double least, most; } claim;
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
    otherwise    otherwise;
    int          width, height;            /* 0: SHEET_WIDTH x SHEET_HEIGHT */
    int          rays, phases, stride;     /* 0: SHEET_RAYS, not asked, every pixel */
    int          pictured;
    float        truth;
} sheet;
enum { SHEET_WIDTH = 320, SHEET_HEIGHT = 180, SHEET_RAYS = 64, SHEET_ROUNDS = 3 };

/* ---- read.c */

#define SHEET_FOLDER "examples/lab/papers"
/* The k-th sheet of all; NULL past the last. What the csv have wrong ends the program in a sentence. */
const sheet *papers_sheet(int k);
/* The bounds of a rule: "less", "much less", "little more" (than the row beside it), "alike 0.1" (within a tenth of
   it), "similar" (to a reference: an error below a quarter of its mean, or of visibility a quarter of the error of no
   occlusion), "as printed 5.5" (by a factor of 1.5 either way), "within 19 21". -1: it is none. */
int sheet_rule(claim *c, const char *rule);

/* ---- sheet.c, own.c */

/* Fills a row each of the sheet's (row_blank where it is not drawn), and writes pictures. 0, or -1. */
int  sheet_draw(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err);
/* In a way of its own. */
int  sheet_own_draw(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err);
/* Opens a stage for the rows of one radius and size that begin with a row. */
int  sheet_open(stage *s, const sheet *t, const paper_row *first, kit_error *err);
int  sheet_rounds(const options *o);
/* All rows as not drawn. */
void sheet_blank(const sheet *t, row *rows);
/* What stands above pictures: triangles, pixels, radius, rays. */
void sheet_about(FILE *record, const stage *s);
/* How many heads, and columns. */
int  sheet_heads(const sheet *t);
int  sheet_columns(const sheet *t);
/* As it is shown, to its column's digits; NAN: there is none. */
double sheet_value(const sheet *t, const row *rows, int i, int c);
/* What a claim is judged by: a value or a ratio. */
double sheet_judged(const sheet *t, const claim *c, const row *rows);
/* Whether a column holds times, which no other run repeats. */
int    sheet_timed(const sheet *t, int c);
/* Whether a claim holds: 1, 0; UNKNOWN: a row was not drawn; UNJUDGED: of times by a software rasteriser. */
enum { UNKNOWN = -1, UNJUDGED = -2 };
int    sheet_holds(const sheet *t, const claim *c, const row *rows);
/* Whether the library's own rows take part in a claim; own: the claim of them. */
int    sheet_own(claim *own, const sheet *t, const claim *c);

/* ---- show.c: a sheet and its rows, as csv, as text */

void   show_csv_head(FILE *f);
void   show_csv(FILE *f, const sheet *t, const row *rows);
/* What of a paper is on no sheet: on the page, or as csv. */
void   show_absent(FILE *record, FILE *f, const char *paper);
void   show_text(FILE *f, const sheet *t, const row *rows);
/* A claim, what came of it, by which figures, and which would have made it otherwise. */
enum { SENTENCE = 1024 };
const char *show_claim(char out[SENTENCE], const sheet *t, const claim *c, const row *rows);

#endif
