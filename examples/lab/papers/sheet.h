/* sheet.h - a table or figure of a paper as typed data: what the paper prints, what is drawn here for each row, what
   the paper says of the rows. sheet.c draws it, show.c prints it; a paper's file holds its sheets. */
#ifndef LAB_SHEET_H
#define LAB_SHEET_H

#include <math.h>
#include "lab/chart/deep_stage.h"
#include "lab/page/units.h"

/* What a column shows of a row. OVERHEAD: its time over the row's that it is based on, less 1, in per cent. OWN: what
   the sheet's own drawing left in figure[STAGE + k]. */
typedef enum quantity {
    NO_COLUMN,
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

/* One row. printed: the paper's figures under the sheet's heads. method NULL: not drawn, note says why; else note is a
   remark. */
typedef struct paper_row {
    const char *what;                      /* what the paper sets */
    const char *printed[6];
    const char *method, *settings, *note;
    float reach;                           /* of the sheet's radius; 0: all of it */
    int   width, height;                   /* 0: the sheet's */
    int   base;                            /* of OVERHEAD: that row, from 1 on; 0: none */
    int   ours;                            /* of a published algorithm: the row, from 1 on, that is the library's */
    int   half;                            /* drawn at half the width and height */
    int   slow;                            /* the quick form leaves it out */
} paper_row;

/* What the paper says, as a range of a row's value over another's, in the column of ours; b = ALONE: of the value
   itself. It holds between the bounds, not at them, and is judged by figures as they are shown. Where a row is of an
   algorithm as published, the library's own rows are judged beside it. why: where it does not hold, the reason. */
typedef struct claim { const char *says; int column, a, b; double least, most; const char *why; } claim;
enum { ALONE = -1 };
#define NO_BOUND  ((double)INFINITY)
/* a window around a figure that the paper prints: this factor either way */
#define PRINTED_WITHIN  1.5
#define AS_PRINTED(column, a, b, figure)  column, a, b, (figure) / PRINTED_WITHIN, (figure) * PRINTED_WITHIN
#define WITHIN(column, a, b, least, most) column, a, b, least, most
#define LESS(column, a, b)                column, a, b, -NO_BOUND, 1
#define MUCH_LESS(column, a, b)           column, a, b, -NO_BOUND, 0.7
#define LITTLE_MORE(column, a, b)         column, a, b, -NO_BOUND, 1.1
#define ALIKE(column, a, b, by)           column, a, b, 1.0 / (1.0 + (by)), 1.0 + (by)
/* to a reference: an error of so much of its mean, of ambient visibility of what having no occlusion errs by */
#define SIMILAR(column, a)                column, a, ALONE, -NO_BOUND, 0.15

enum { MOST_HEADS = 6, MOST_PAPER_ROWS = 24 };
typedef struct sheet sheet;
/* Draws it: fills a row each of the sheet's (row_blank where it is not drawn), and writes pictures. 0, or -1. */
typedef int drawing(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err);

struct sheet {
    const char *paper, *name;              /* "HSAO08", "Table 1" */
    const char *title, *theirs;            /* what it shows; on what, with what */
    const char *erratum;                   /* NULL, or where the print is wrong */
    const char *ours;                      /* the scene here, and what else is not the paper's */
    const char *head[MOST_HEADS];          /* of what is printed */
    column      column[MOST_HEADS];        /* of what is measured */
    const paper_row *rows;
    int          count;
    const claim *claims;
    int          claimed;
    drawing     *draw;                     /* sheet_draw, or the sheet's own */
    deep_view    see;
    int          width, height;            /* 0: SHEET_WIDTH x SHEET_HEIGHT */
    int          rays, phases, stride;     /* of the truth; 0: SHEET_RAYS, not asked, every pixel */
    int          pictured;                 /* 1: rows as pictures, beside the truth; 2: the lit's crops, too */
    float        truth;                    /* radius of the truth where it is not the rows'; what it has is not faded */
};
/* halved: even, in the quick form as well */
enum { SHEET_WIDTH = 320, SHEET_HEIGHT = 180, HALVED_HEIGHT = 184, SHEET_RAYS = 64, SHEET_ROUNDS = 3 };

/* What of a paper is on no sheet, and why, or where its like is shown. */
typedef struct absent { const char *name, *why; } absent;
/* The sheets of each paper, in the paper's order. */
typedef struct paper {
    const char *key, *title;
    const sheet *const *sheets;
    int count;
    const absent *absent;
    int absents;
} paper;
extern const paper hsao_paper, ssdo_paper, s3ho_paper, aof_paper, dss_paper;
/* The k-th sheet of all; NULL past the last. */
const sheet *papers_sheet(int k);

/* ---- sheet.c */

/* Methods on the sheet's view beside its truth: errors, times, pictures; once a radius. */
int    sheet_draw(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err);
/* Times alone, once a size. */
int    sheet_times(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err);
/* Rows at full and at half size. */
int    sheet_halves(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err);
/* The view, loaded but not looked at: for drawings of a sheet's own. */
int    sheet_load(stage *s, const sheet *t, kit_error *err);
/* Which of rows from .. to - 1 are drawn, and as what: how many. */
int    sheet_chosen(int *at, entry *entries, const options *o, const sheet *t, int from, int to);
/* All rows as not drawn. */
void   sheet_blank(const sheet *t, row *rows);
/* What stands above pictures: triangles, pixels, radius, rays. */
void   sheet_about(FILE *record, const stage *s);
int    sheet_rounds(const options *o);
/* What was drawn on a stage, rows number at[0 .. count - 1]: into their rows and, where the sheet is pictured, the
   page. Frees the pictures. */
int    sheet_show(FILE *record, const options *o, const sheet *t, const stage *s, kit_image *picture, const row *drawn,
                  const int *at, int count, row *rows, kit_error *err);
/* As it is shown, to its column's digits; NAN: there is none. */
double sheet_value(const sheet *t, const row *rows, int i, int c);
/* What a claim is judged by: a value or a ratio. */
double sheet_judged(const sheet *t, const claim *c, const row *rows);
/* Whether a claim holds: 1, 0; -1 where a row was not drawn. */
int    sheet_holds(const sheet *t, const claim *c, const row *rows);
/* Whether the library's own rows take part in a claim; own: the claim of them. */
int    sheet_own(claim *own, const sheet *t, const claim *c);

/* ---- show.c: a sheet and its rows, as a page's part, as csv, as text */

void   show_csv_head(FILE *f);
void   show_csv(FILE *f, const sheet *t, const row *rows);
void   show_text(FILE *f, const sheet *t, const row *rows);
/* A claim, what came of it, by which figures, and which would have made it otherwise. */
enum { SENTENCE = 1024 };
const char *show_claim(char out[SENTENCE], const sheet *t, const claim *c, const row *rows);
void   show_absent_csv(FILE *f, const paper *p);

#endif
