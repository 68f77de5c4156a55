/* bench.h - what make bench measures: rows at sizes, what bounds them, the plan's choices.

     peaks.c    what the machine copies at best
     rows.c     methods, timed
     plan.c     the plan's second column of costs
     show.c     csv, text, a record
     bench.c    the command */
#ifndef LAB_BENCH_H
#define LAB_BENCH_H

#include "kit/kit_gl.h"

enum {
    BENCH_SIZES = 3,
    BENCH_ROWS = 64,
    BENCH_PARTS = 24,
    BENCH_ROUNDS = 5,
    BENCH_FRAMES = 48,
    BENCH_PLAN_ROUNDS = 3,
    BENCH_SAMPLES = BENCH_ROUNDS * BENCH_FRAMES
};

/* ---- >>peaks ----------------------------------------------------------------------------------------------------- */

/* Bytes a second of a full-screen pass that copies a texture; what is more than best becomes best. */
int peaks_measure(double *best, kit_error *err);

/* ---- >>rows ------------------------------------------------------------------------------------------------------ */

/* The passes of a name: what they take together, a round each. */
typedef struct part {
    const char *name;
    double ms[BENCH_ROUNDS], bytes;
} part;

/* ms: of frames; slabs: the scene's back faces, 0: none are drawn. */
typedef struct timing {
    double ms[BENCH_SAMPLES], bytes, slabs;
    int frames, rounds, parts;
    part part[BENCH_PARTS];
} timing;

typedef struct bench_row {
    kit_method method;
    const char *set; /* beyond the defaults */
    timing at[BENCH_SIZES];
    char why[160]; /* it cannot be drawn here */
} bench_row;

/* What is drawn on, when that should have ended and when all must have (kit_seconds), and what share of the whole bench
   a round is. */
typedef struct place {
    kit_gbuffer *gbuffer;
    const kit_scene *scene;
    const kit_lighting *sky, *both; /* both: and a sun, which what scatters, and what shines, wants */
    double end, last, share;
} place;

/* Every row of build/render --list, and settings that engines ask about, whose names begin so (NULL: all; of a machine
   without a GPU a few). How many; -1: none. */
int rows_new(bench_row rows[BENCH_ROWS], const char *asked, kit_error *err);
/* One round of a method: opened, warmed up, up to BENCH_FRAMES frames (a CPU: a quarter) for about so many seconds;
   apart: its passes, too, each alone. */
int rows_time(timing *t, const kit_method *method, const place *p, double seconds, int apart, kit_error *err);
/* A round of all rows in turn at a size; those that no time is left for are left out. A row that cannot be drawn says
   why, and is left out from then on. */
void rows_round(bench_row *rows, int count, int size, const place *p);
/* Lower quartile, median, upper quartile; sorts v. */
void rows_quartiles(double quartile[3], double *v, int count);
/* Shows how far the bench is: so much more of it is done; the first time 0. */
void rows_progress(double more);

/* ---- >>plan ------------------------------------------------------------------------------------------------------ */

/* What each choice of the plan takes over what an unblurred ssao of 16 samples takes, which is
   drawn before each. 0: not measured. */
typedef struct plan_costs {
    double ratio[SSGI_PLAN_CHOICES];
    char text[SSGI_PLAN_CHOICES][96];
} plan_costs;

/* What is to be measured: every choice that needs no surfels and no fields; only: that one, -1: all. */
int plan_choose(plan_costs *costs, int only, kit_error *err);
int plan_measure(plan_costs *costs, const place *p, kit_error *err);

/* ---- >>show ------------------------------------------------------------------------------------------------------ */

typedef struct bench {
    bench_row row[BENCH_ROWS];
    int count, sizes, size[BENCH_SIZES][2];
    double best; /* bytes a second */
    plan_costs plan;
    int planned, seconds; /* seconds: for all */
    kit_scene scene;
    kit_lighting sky, both;
    char command[256];
} bench;

/* bench.csv, the record bench.js and the plan's costs (make fit takes a GPU's alone) into a folder; and as text. */
int show_all(FILE *f, bench *b, const char *folder, kit_error *err);

#endif
