/* ahead.h - measures many scenes ahead, without times: one process a core, each with its own GL context. */
#ifndef LAB_AHEAD_H
#define LAB_AHEAD_H

#include "kit/kit.h"

typedef struct ahead {
    const char *what, *context;                /* what: for kit_progress; context: its name in --context */
    int first, count;                          /* numbers for one(): first .. first + count - 1 */
    int  (*begin)(void *of, kit_error *err);   /* each process calls it with its context open; NULL: nothing to call */
    int  (*one)(void *of, int k, kit_error *err);      /* measures scene k and keeps the result */
    void *of;
} ahead;

/* Measures in processes of its own. Call it before this process has a context, as a process with one cannot fork.
   Failures are not reported: the asking process measures that number again and says why. Does nothing on a single core,
   or for another context than the default one. */
int ahead_run(const ahead *a, kit_error *err);

#endif
