/* sweep.h - sweeps a method through a cause of failure: draws frames, and makes figures of them. */
#ifndef LAB_SWEEP_H
#define LAB_SWEEP_H

#include "lab/stability/curve.h"

/* causes, methods: how many are asked for; 0 = all */
typedef struct sweep_options {
    const char *out;
    int quick, causes, methods, cause[MOST_CAUSES], method[MOST_METHODS];
} sweep_options;

/* Whether any of the methods that are asked for is swept through a cause. */
int sweep_has(const cause *c, const sweep_options *o);

/* what: for kit_progress. The caller frees the curves' pictures. */
int sweep(result *r, const cause *c, const sweep_options *o, const char *what, kit_error *err);

#endif
