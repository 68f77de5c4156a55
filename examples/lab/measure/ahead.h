/* ahead.h - many scenes measured ahead, where time is not taken: one process a core, each with its own GL context. */
#ifndef LAB_AHEAD_H
#define LAB_AHEAD_H

#include "kit/kit.h"

typedef struct ahead {
    const char *what, *context;                /* for kit_progress; as --context names it */
    int first, count;                          /* of what is measured */
    int  (*begin)(void *of, kit_error *err);   /* in each process, once there is a context; NULL: nothing */
    int  (*one)(void *of, int k, kit_error *err);      /* measures the k-th, leaves it where the asking one looks */
    void *of;
} ahead;

/* Before this process has a context, from which none could be forked. What fails is left out quietly: the process that
   asked measures it once more, and says why. Nothing is done on one core, or in another context than the default. */
int ahead_run(const ahead *a, kit_error *err);

#endif
