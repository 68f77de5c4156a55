/* sweep.h - sweeps a method through a cause of failure: draws frames, and makes figures of them. */
#ifndef LAB_SWEEP_H
#define LAB_SWEEP_H

#include "lab/stability/curve.h"

/* The options of build/stability. causes, methods: how many are asked for; 0 = all */
typedef struct sweep_options {
    const char *out;
    int quick, causes, methods, cause[MOST_CAUSES], method[MOST_METHODS];
} sweep_options;

/* Returns whether a cause is asked for, and whether any of the methods that are asked for is swept through it. */
int sweep_asked(const cause *c, const sweep_options *o);

/* Makes the curves of a cause. what: for kit_progress. The result, zero before the first sweep, may be swept again. */
int sweep(result *r, const cause *c, const sweep_options *o, const char *what, kit_error *err);

#endif
