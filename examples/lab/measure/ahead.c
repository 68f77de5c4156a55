/* ahead.c - measures scenes in one process a core, each with its own GL context. Declared in ahead.h. */
#include "lab/measure/ahead.h"
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <unistd.h>
#include "kit/kit_gl.h"

enum { WORKERS = 8 };

/* Reads scenes' numbers from a pipe until it is empty. Measures each and writes its number to the other pipe. */
static void work(const ahead *a, int numbers_in, int done_out)
{
    kit_error err;
    int k;
    setenv("KIT_THREADS", "1", 1);
    setenv("LP_NUM_THREADS", "0", 1);
    if (!freopen("/dev/null", "w", stderr) || kit_gl_open(a->context, &err)) return;
    if (a->begin && a->begin(a->of, &err)) return;
    while (read(numbers_in, &k, sizeof k) == sizeof k) {
        if (a->one(a->of, k, &err) < 0) continue;
        if (write(done_out, "", 1) != 1) return;
    }
    kit_gl_close();
}

static int cores(const ahead *a)
{
    const char *text = getenv("KIT_THREADS");
    const long there = text && atoi(text) > 0 ? atoi(text) : sysconf(_SC_NPROCESSORS_ONLN);
    const int most = a->count < WORKERS ? a->count : WORKERS;
    return a->context && strcmp(a->context, "osmesa") ? 1 : there > most ? most : (int)there;
}

int ahead_run(const ahead *a, kit_error *err)
{
    const int workers = cores(a);
    int queue[2], done[2], measured = 0;
    char tick;
    if (workers < 2) return 0;
    if (pipe(queue) || pipe(done)) return kit_fail(err, "%s: no pipe to other processes", a->what);
    for (int k = a->first; k < a->first + a->count; ++k)            /* all the numbers fit into the pipe's buffer */
        if (write(queue[1], &k, sizeof k) != sizeof k) return kit_fail(err, "%s: a pipe is full", a->what);
    close(queue[1]);
    fflush(NULL);
    for (int w = 0; w < workers; ++w)
        if (!fork()) {
            close(done[0]);
            work(a, queue[0], done[1]);
            _exit(0);
        }
    close(queue[0]);
    close(done[1]);
    kit_progress(a->what, 0);
    while (read(done[0], &tick, 1) == 1) {
        ++measured;
        kit_progress(a->what, measured < a->count ? measured / (double)a->count : 0.999);
    }
    kit_progress(a->what, 1);
    close(done[0]);
    while (wait(NULL) > 0) {}
    return 0;
}
