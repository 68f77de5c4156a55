/* util.c - errors, progress, threads, whole files. */
#include "kit.h"

#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

int kit_fail(kit_error *err, const char *format, ...)
{
    if (!err) return -1;
    kit_error line;                        /* an argument may point into *err */
    va_list args;
    va_start(args, format);
    vsnprintf(line.text, sizeof line.text, format, args);
    va_end(args);
    for (char *p = line.text; *p; ++p)     /* file names and library messages can hold line ends */
        if ((unsigned char)*p < ' ' || *p == 127) *p = ' ';
    *err = line;
    return -1;
}

void kit_streams_open(void)
{
    for (int i = 0; i < 3; ++i)
        /* the lowest free one: this */
        if (fcntl(i, F_GETFD) < 0) (void)!open("/dev/null", i ? O_RDONLY : O_WRONLY);
    signal(SIGXFSZ, SIG_IGN);
}

int kit_streams_close(kit_error *err)
{
    errno = 0;
    const int lost = fflush(stdout) || ferror(stdout);
    if (!lost) return 0;
    return kit_fail(err, "standard output: cannot be written%s%s", errno ? ": " : "", errno ? strerror(errno) : "");
}

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

double kit_median(double *v, int count)
{
    qsort(v, (size_t)count, sizeof *v, by_value);
    return count % 2 ? v[count / 2] : 0.5 * (v[count / 2 - 1] + v[count / 2]);
}

uint64_t kit_hash(uint64_t h, const void *data, size_t size)
{
    for (const unsigned char *p = data, *end = p + size; p < end; ++p) h = (h ^ *p) * 1099511628211u;
    return h;
}

double kit_seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

void kit_progress(const char *what, double fraction)
{
    static double started, drawn;
    static int shown;
    static char running[128];                  /* the outermost: what runs inside it does not restart its clock */
    if (!isatty(STDERR_FILENO) || (*running && *what && strcmp(what, running))) return;
    snprintf(running, sizeof running, "%s", fraction >= 1 ? "" : what);
    double now = kit_seconds();
    if (fraction >= 1) {
        if (shown) fputs("\r\033[K", stderr);
        shown = 0;
        return;
    }
    if (fraction <= 0) started = drawn = now; /* the first redraw comes after 0.1 s: short jobs stay quiet */
    if (now - drawn < 0.1) return;
    drawn = now;
    shown = 1;
    double elapsed = now - started;
    fprintf(stderr, "\r\033[K%s %3.0f %%, %.0f s", what, 100 * fraction, elapsed);
    if (fraction > 0.01) fprintf(stderr, ", %.0f s left", elapsed * (1 - fraction) / fraction);
    fflush(stderr);
}

typedef struct parallel {
    int count, block;
    atomic_int next;                        /* passes count by at most a block a thread */
    void (*job)(void *context, int i);
    void *context;
} parallel;

static int parallel_block(parallel *p)     /* 0 when none is left */
{
    int first = atomic_fetch_add(&p->next, p->block);
    if (first >= p->count) return 0;
    int end = p->count - first < p->block ? p->count : first + p->block;
    for (int i = first; i < end; ++i) p->job(p->context, i);
    return 1;
}

static void *parallel_thread(void *argument)
{
    while (parallel_block(argument)) {}
    return NULL;
}

void kit_parallel(const char *what, int count, void (*job)(void *context, int i), void *context)
{
    enum { MOST = 256 };
    const char *text = getenv("KIT_THREADS");
    long wanted = text && atoi(text) > 0 ? atoi(text) : sysconf(_SC_NPROCESSORS_ONLN);
    int threads = wanted < 1 ? 1 : wanted > MOST ? MOST : (int)wanted;
    parallel p = { .count = count, .job = job, .context = context };
    p.block = count / (32 * threads);      /* small enough to even out unequal jobs */
    if (p.block < 1) p.block = 1;
    atomic_init(&p.next, 0);

    pthread_t thread[MOST];
    int started = 0;
    if (what) kit_progress(what, 0);
    while (started < threads - 1 && started < count - 1 && !pthread_create(&thread[started], NULL, parallel_thread, &p))
        ++started;
    while (parallel_block(&p))
        if (what) kit_progress(what, fmin(0.999, (double)atomic_load(&p.next) / count));
    for (int i = 0; i < started; ++i) pthread_join(thread[i], NULL);
    if (what) kit_progress(what, 1);
}

/* The whole of a regular file, with a zero after its last byte; the caller frees it. */
int kit_file_read(char **data, size_t *size, const char *path, kit_error *err)
{
    struct stat status;
    if (stat(path, &status)) return kit_fail(err, "%s: cannot be read: %s", path, strerror(errno));
    if (S_ISDIR(status.st_mode)) return kit_fail(err, "%s: is a directory, not a file", path);
    if (!S_ISREG(status.st_mode)) return kit_fail(err, "%s: is not a regular file", path);
    if (status.st_size == 0) return kit_fail(err, "%s: is empty", path);
    FILE *file = fopen(path, "rb");
    if (!file) return kit_fail(err, "%s: cannot be read: %s", path, strerror(errno));
    size_t bytes = (size_t)status.st_size;
    char *text = malloc(bytes + 1);
    size_t got = text ? fread(text, 1, bytes, file) : 0;
    fclose(file);
    if (!text) return kit_fail(err, "%s: no memory for %zu bytes", path, bytes);
    if (got != bytes) {
        free(text);
        return kit_fail(err, "%s: only %zu of %zu bytes could be read", path, got, bytes);
    }
    text[bytes] = 0;
    *data = text;
    *size = bytes;
    return 0;
}

/* Where a path leads: a link's target, even one that is not there yet. NULL: errno says why. */
static char *led_to(const char *path)
{
    enum { MOST_LINKS = 40 };
    char *name = strdup(path);
    for (int i = 0; name && i < MOST_LINKS; ++i) {
        char link[4096];
        const ssize_t length = readlink(name, link, sizeof link - 1);
        if (length < 0) return name;
        link[length] = 0;
        const char *slash = strrchr(name, '/');
        const size_t before = *link == '/' || !slash ? 0 : (size_t)(slash - name) + 1;
        char *next = malloc(before + (size_t)length + 1);
        if (next) {
            memcpy(next, name, before);
            strcpy(next + before, link);
        }
        free(name);
        name = next;
    }
    free(name);
    errno = name ? ELOOP : ENOMEM;
    return NULL;
}

/* Writes beside the target and renames, so that the target is the old file or the whole new one at every moment. */
int kit_file_write(const char *path, const void *data, size_t size, kit_error *err)
{
    struct stat status;
    if (!stat(path, &status) && !S_ISREG(status.st_mode))
        return kit_fail(err, "%s: cannot be written: %s", path,
                        S_ISDIR(status.st_mode) ? "is a directory" : "is not a regular file");
    char *name = led_to(path);             /* a link stays a link: what it points to is replaced */
    size_t length = name ? strlen(name) + 32 : 0;
    char *part = name ? malloc(length) : NULL;
    void (*was)(int) = signal(SIGXFSZ, SIG_IGN);           /* too large: an error, not the end */
    FILE *file = NULL;
    int failed = !name ? errno : !part ? ENOMEM : 0;
    if (part) {
        snprintf(part, length, "%s.%ld.part", name, (long)getpid());
        file = fopen(part, "wb");
        if (!file) failed = errno;
    }
    if (file) {
        if (fwrite(data, 1, size, file) != size) failed = errno ? errno : EIO;
        if (fclose(file) && !failed) failed = errno;
        if (!failed && rename(part, name)) failed = errno;
        if (failed) remove(part);
    }
    signal(SIGXFSZ, was);
    free(part);
    free(name);
    return failed ? kit_fail(err, "%s: cannot be written: %s", path, strerror(failed)) : 0;
}
