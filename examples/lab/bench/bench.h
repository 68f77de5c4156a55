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

/* All passes of one name: their time in each round. */
typedef struct part {
    const char *name;
    double ms[BENCH_ROUNDS], bytes;
} part;

/* ms: of each frame; slabs: milliseconds to draw the scene's back faces, 0 if none are drawn. */
typedef struct timing {
    double ms[BENCH_SAMPLES], bytes, slabs;
    int frames, rounds, parts;
    part part[BENCH_PARTS];
} timing;

typedef struct bench_row {
    kit_method method;
    const char *set; /* settings beside the defaults */
    timing at[BENCH_SIZES];
    char why[160]; /* why it cannot be drawn here */
} bench_row;

/* The G-buffer to draw on; when a round should end and when it must (kit_seconds); the round's share of the bench. */
typedef struct place {
    kit_gbuffer *gbuffer;
    const kit_scene *scene;
    const kit_lighting *sky, *both; /* sky and a sun, for scattering and emitting methods */
    double end, last, share;
} place;

/* The methods of build/render --list and some settings, of those whose names begin with asked (NULL: all, or without a
   GPU a few). Returns how many; -1 on failure. */
int rows_new(bench_row rows[BENCH_ROWS], const char *asked, kit_error *err);
/* Times one round of a method: opens it, warms it up and draws up to BENCH_FRAMES frames (on a CPU a quarter) in about
   so many seconds. apart: also times each of its passes alone. */
int rows_time(timing *t, const kit_method *method, const place *p, double seconds, int apart, kit_error *err);
/* Times all rows in turn at a size, and skips those for which no time is left. A row that cannot be drawn says why and
   is skipped from then on. */
void rows_round(bench_row *rows, int count, int size, const place *p);
/* The lower quartile, the median and the upper quartile. Sorts v. */
void rows_quartiles(double quartile[3], double *v, int count);
/* Adds this share to the progress and shows it. The first call has 0. */
void rows_progress(double more);

/* ---- >>plan ------------------------------------------------------------------------------------------------------ */

/* The time of each choice of the plan over the time of an unblurred ssao of 16 samples, which is drawn before each
   choice. 0: not measured. */
typedef struct plan_costs {
    double ratio[SSGI_PLAN_CHOICES];
    char text[SSGI_PLAN_CHOICES][96];
} plan_costs;

/* Chooses what to measure: each choice without surfels and fields, or only one, by its number (-1: all). */
int plan_choose(plan_costs *costs, int only, kit_error *err);
int plan_measure(plan_costs *costs, const place *p, kit_error *err);

/* ---- >>show ------------------------------------------------------------------------------------------------------ */

typedef struct bench {
    bench_row row[BENCH_ROWS];
    int count, sizes, size[BENCH_SIZES][2];
    double best; /* bytes a second */
    plan_costs plan;
    int planned, seconds; /* seconds: of the whole bench */
    kit_scene scene;
    kit_lighting sky, both;
    char command[256];
} bench;

/* Writes bench.csv, the record bench.js and the plan's costs (which make fit reads) into a folder, and prints text. */
int show_all(FILE *f, bench *b, const char *folder, kit_error *err);

#endif
