/* bench.h - the parts of make bench: rows at sizes, their bounds, the plan's choices.

     peaks.c    the highest rate at which the machine copies
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

/* Measures how many bytes a second a full-screen pass copies. A higher rate replaces *best. */
int peaks_measure(double *best, kit_error *err);

/* ---- >>rows ------------------------------------------------------------------------------------------------------ */

/* One pass of a method's frame, or several of one name: their time in each round. */
typedef struct part {
    const char *name;
    double ms[BENCH_ROUNDS], bytes;
} part;

/* The times of a row. ms: of each frame; slabs: to draw the scene's back faces, 0 if none are drawn. */
typedef struct timing {
    double ms[BENCH_SAMPLES], bytes, slabs;
    int frames, rounds, parts;
    part part[BENCH_PARTS];
} timing;

typedef struct bench_row {
    kit_method method;
    const char *set; /* settings beside the defaults */
    timing at[BENCH_SIZES];
    char why[160]; /* why this machine cannot draw the row */
} bench_row;

/* The G-buffer of a round; when the round should end and must end (kit_seconds); its part of the bench's progress. */
typedef struct place {
    kit_gbuffer *gbuffer;
    const kit_scene *scene;
    const kit_lighting *sky, *both; /* lights for methods that scatter and that emit */
    double end, last, share;
} place;

/* Makes the rows: the methods of build/render --list and some settings, of those whose names begin with asked (NULL:
   all, or a few without a GPU). Returns how many; -1 on failure. */
int rows_new(bench_row rows[BENCH_ROWS], const char *asked, kit_error *err);
/* Times one round of a method: opens it, warms it up and draws up to BENCH_FRAMES frames (on a CPU a quarter) in about
   so many seconds. apart: also times each of the method's passes alone. */
int rows_time(timing *t, const kit_method *method, const place *p, double seconds, int apart, kit_error *err);
/* Times all rows once at a size, and skips those for which no time is left. A row that cannot be drawn says why and is
   skipped from then on. */
void rows_round(bench_row *rows, int count, int size, const place *p);
/* Writes the lower quartile, the median and the upper quartile of count values. Sorts v. */
void rows_quartiles(double quartile[3], double *v, int count);
/* Adds a part of the bench (0 to 1) to the progress and shows it. The first call has 0. */
void rows_progress(double more);

/* ---- >>plan ------------------------------------------------------------------------------------------------------ */

/* The cost of each choice of the plan: its time over that of an unblurred ssao of 16 samples, which is drawn before
   each choice. 0: not measured. */
typedef struct plan_costs {
    double ratio[SSGI_PLAN_CHOICES];
    char text[SSGI_PLAN_CHOICES][96];
} plan_costs;

/* Chooses which of the plan's choices to time: all without surfels and fields, or only one's number (-1: all). */
int plan_choose(plan_costs *costs, int only, kit_error *err);
int plan_measure(plan_costs *costs, const place *p, kit_error *err);

/* ---- >>show ------------------------------------------------------------------------------------------------------ */

typedef struct bench {
    bench_row row[BENCH_ROWS];
    int count, sizes, size[BENCH_SIZES][2];
    double best; /* bytes a second */
    plan_costs plan;
    int planned, seconds; /* seconds: that the whole bench took */
    kit_scene scene;
    kit_lighting sky, both;
} bench;

/* Writes bench.csv, the record bench.js and the plan's costs (which make fit reads) into a folder, and prints text. */
int show_all(FILE *f, bench *b, const char *folder, kit_error *err);

#endif
