/* rows.h - a row: the results of one setting of a method on one scene. measure/ fills rows, page/ shows them. */
#ifndef LAB_ROWS_H
#define LAB_ROWS_H

#include "kit/kit.h"

#define COUNT(table) ((int)(sizeof (table) / sizeof (table)[0]))
#define WITH_COUNT(table) table, COUNT(table)      /* a table and its length, for two members or arguments */

/* The groups of columns that a row has, as bits of its member of. */
enum {
    OF_AO = 1,
    OF_LIT = 2,
    OF_SPLIT = 4,
    OF_FIELD = 8,
    OF_BAKE = 16,
    OF_FIELDS = OF_FIELD | OF_BAKE,
    OF_DEEP = 32,
    OF_DEEP_LIT = 64,
    OF_PHASES = 128,
    OF_PEER = 256,
    OF_DEEPS = OF_DEEP | OF_DEEP_LIT
};

/* Indices of split: with several phases of the noise: the error in all, the model's part of it, and the noise; the
   error of hue in degrees, everywhere and in shade; the bounce's noise. */
enum { SPLIT_ALL, SPLIT_MODEL, SPLIT_NOISE, SPLIT_HUE, SPLIT_HUE_IN_SHADE, SPLIT_BOUNCE, SPLITS };

/* Sizes of tables: noise bands (lab/measure/bands.h); gains and exponents of a peer's fits (lab/measure/peers.h). */
enum { NOISE_BANDS = 4, FIT_GAINS = 9, FIT_EXPONENTS = 9, FITS = 2 * FIT_GAINS * FIT_EXPONENTS };

/* Indices of figure. Fields: the bake; a picture's error. Deep screen space: surfels and splats; each stage's share of
   the time. The mean of a picture where it shows surfaces. */
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
    SURFELS,
    SPLATS,
    STAGE,
    STAGES = 7,
    FITTED = STAGE + STAGES,
    LEVEL,
    NOISE_BAND,
    ERROR_BAND = NOISE_BAND + NOISE_BANDS,
    FIT = ERROR_BAND + NOISE_BANDS,
    FIGURES = FIT + FITS
};

/* The results of one setting on one scene. A figure that does not apply is NAN. scene: or "mean", of several scenes. */
typedef struct row {
    const char *scene, *label, *method, *settings;   /* rows of one label follow each other and make one curve */
    double bytes, relative, ms, share;
    kit_score score;                                 /* the errors of ambient visibility, or of radiance if lit */
    /* the groups of columns; without OF_AO the next two are known, and share is error[0]: */
    int of;
    /* RMSE and bias of radiance, irradiance and bounce, each over the mean of its truth */
    double error[3], bias[3];
    double split[SPLITS];                            /* of irradiance if of has OF_SPLIT, of visibility if OF_PHASES */
    double figure[FIGURES];                          /* OF_FIELDS, OF_DEEPS */
} row;

/* A method to be measured as a row. quick: chart --quick shows it, too */
typedef struct entry { const char *label, *method, *settings; int quick; } entry;

enum { MOST_ENTRIES = 48, MOST_ROWS = MOST_ENTRIES + 2 };

/* Returns a row with names and without results: all figures are NAN. */
row row_blank(int of, const char *scene, const char *label, const char *method, const char *settings);

#endif
