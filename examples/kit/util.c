/* util.c - errors, progress, threads, whole files, JSON. Declared in kit.h. */
#include "kit/kit.h"
#include "ssgi.h"

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
    kit_error line;                        /* a copy, because an argument may point into *err */
    va_list args;
    va_start(args, format);
    vsnprintf(line.text, sizeof line.text, format, args);
    va_end(args);
    for (char *p = line.text; *p; ++p)     /* line ends become blanks: file names and library messages can hold some */
        if ((unsigned char)*p < ' ' || *p == 127) *p = ' ';
    *err = line;
    return -1;
}

void kit_streams_open(void)
{
    for (int i = 0; i < 3; ++i)
        /* open() returns the lowest free descriptor, which is i */
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

static int by_float(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

float kit_middle(float *v, size_t count)
{
    qsort(v, count, sizeof *v, by_float);
    return v[count / 2];
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
    static char running[128];                  /* name of the outermost activity; inner ones do not restart its clock */
    if (!isatty(STDERR_FILENO) || (*running && *what && strcmp(what, running))) return;
    snprintf(running, sizeof running, "%s", fraction >= 1 ? "" : what);
    double now = kit_seconds();
    if (fraction >= 1) {
        if (shown) fputs("\r\033[K", stderr);
        shown = 0;
        return;
    }
    if (fraction <= 0) started = drawn = now; /* drawn first after 0.1 s, so that short jobs stay quiet */
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
    atomic_int next;                        /* index of the next job; may exceed count by one block a thread */
    void (*job)(void *context, int i);
    void *context;
} parallel;

static int parallel_block(parallel *p)     /* returns 0 if no block is left */
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
    p.block = count / (32 * threads);      /* jobs a block: small enough to balance unequal jobs */
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

FILE *kit_file_open(size_t *size, const char *path, kit_error *err)
{
    struct stat status;
    FILE *stream = NULL;
    const int file = open(path, O_RDONLY | O_NONBLOCK | O_CLOEXEC);      /* O_NONBLOCK: does not wait if it is a pipe */
    if (file < 0 || fstat(file, &status)) kit_fail(err, "%s: cannot be read: %s", path, strerror(errno));
    else if (S_ISDIR(status.st_mode)) kit_fail(err, "%s: is a directory, not a file", path);
    else if (!S_ISREG(status.st_mode)) kit_fail(err, "%s: is not a regular file", path);
    else if (status.st_size == 0) kit_fail(err, "%s: is empty", path);
    else if (!(stream = fdopen(file, "rb"))) kit_fail(err, "%s: cannot be read: %s", path, strerror(errno));
    if (stream) *size = (size_t)status.st_size;
    else if (file >= 0) close(file);
    return stream;
}

int kit_file_read(char **data, size_t *size, const char *path, kit_error *err)
{
    size_t bytes;
    FILE *file = kit_file_open(&bytes, path, err);
    if (!file) return -1;
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

/* Returns the target of a path, through links, even if it does not exist yet. NULL: errno names the reason. */
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

/* Makes a temporary file in the target's folder. Its name is short enough for any file system, however long the
   target's is, and no other writer has it. */
enum { PART_NAME = 160 };
static int part_open(char *part, int folder, const char *base, mode_t mode)
{
    static atomic_uint parts;
    int kept = (int)strnlen(base, 100), file;
    while (kept && ((unsigned char)base[kept] & 0xc0) == 0x80) --kept;         /* only whole characters */
    do {
        snprintf(part, PART_NAME, "%.*s.%ld-%u.part", kept, base, (long)getpid(), atomic_fetch_add(&parts, 1));
        file = openat(folder, part, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, mode);
    } while (file < 0 && errno == EEXIST);     /* a killed program may have left such a file */
    return file;
}

/* Returns 0, or errno. */
static int write_all(int file, const char *data, size_t size)
{
    for (size_t done = 0; done < size;) {
        const ssize_t wrote = write(file, data + done, size - done);
        if (wrote >= 0) done += (size_t)wrote;
        else if (errno != EINTR) return errno;
    }
    return 0;
}

/* Writes a temporary file, then renames it; returns 0, or errno. was: the file that it replaces, or NULL. */
static int replace(int folder, const char *base, const struct stat *was, const void *data, size_t size)
{
    char part[PART_NAME];
    const int file = part_open(part, folder, base, was ? was->st_mode & 0777 : 0666);
    if (file < 0) return errno;
    int failed = write_all(file, data, size);
    if (was) {
        /* the system may refuse a change of owner; the file's mode is then no wider than the old one's */
        (void)!fchown(file, was->st_uid, was->st_gid);
        (void)!fchmod(file, was->st_mode & 0777);
    }
    if (close(file) && !failed) failed = errno;
    if (!failed && renameat(folder, part, folder, base)) failed = errno;
    if (failed) unlinkat(folder, part, 0);
    return failed;
}

/* Writes a temporary file and renames it, so that the target is the old file or the whole new one at every moment. */
int kit_file_write(const char *path, const void *data, size_t size, kit_error *err)
{
    struct stat was;
    const int exists = !stat(path, &was);
    if (exists && !S_ISREG(was.st_mode))
        return kit_fail(err, "%s: cannot be written: %s", path,
                        S_ISDIR(was.st_mode) ? "is a directory" : "is not a regular file");
    char *name = led_to(path);             /* a link stays a link: its target is replaced */
    if (!name) return kit_fail(err, "%s: cannot be written: %s", path, strerror(errno));
    char *slash = strrchr(name, '/');
    const char *base = slash ? slash + 1 : name;
    const char *within = !slash ? "." : slash == name ? "/" : name;
    if (slash && slash != name) *slash = 0;
    const int folder = open(within, O_PATH | O_DIRECTORY | O_CLOEXEC);
    int failed = folder < 0 ? errno : 0;
    if (!failed) {
        /* A signal that ends the program waits for the rename, else the temporary file would remain. A file above the
           size limit raises a signal for this thread: here that is an error, not the end. */
        static const struct timespec at_once = { 0, 0 };
        sigset_t all, before, too_large;
        sigfillset(&all);
        sigemptyset(&too_large);
        sigaddset(&too_large, SIGXFSZ);
        pthread_sigmask(SIG_BLOCK, &all, &before);
        failed = replace(folder, base, exists ? &was : NULL, data, size);
        if (failed == EFBIG) sigtimedwait(&too_large, NULL, &at_once);
        pthread_sigmask(SIG_SETMASK, &before, NULL);
        close(folder);
    }
    free(name);
    return failed ? kit_fail(err, "%s: cannot be written: %s", path, strerror(failed)) : 0;
}

/* ---- JSON --------------------------------------------------------------------------------------------------- */

/* Returns the number of bytes of the UTF-8 character at s, 0 if it is invalid: a longer form of a shorter one, half of
   a UTF-16 pair, or above U+10FFFF (the Unicode standard's table 3-7). */
static int utf8_length(const unsigned char *s)
{
    static const struct { unsigned char first, last, low, high; int length; } forms[] = {
        { 0x01, 0x7f, 0x00, 0x00, 1 }, { 0xc2, 0xdf, 0x80, 0xbf, 2 }, { 0xe0, 0xe0, 0xa0, 0xbf, 3 },
        { 0xe1, 0xec, 0x80, 0xbf, 3 }, { 0xed, 0xed, 0x80, 0x9f, 3 }, { 0xee, 0xef, 0x80, 0xbf, 3 },
        { 0xf0, 0xf0, 0x90, 0xbf, 4 }, { 0xf1, 0xf3, 0x80, 0xbf, 4 }, { 0xf4, 0xf4, 0x80, 0x8f, 4 }
    };
    for (size_t i = 0; i < sizeof forms / sizeof *forms; ++i) {
        if (*s < forms[i].first || *s > forms[i].last) continue;
        if (forms[i].length > 1 && (s[1] < forms[i].low || s[1] > forms[i].high)) return 0;
        for (int k = 2; k < forms[i].length; ++k) if ((s[k] & 0xc0) != 0x80) return 0;
        return forms[i].length;
    }
    return 0;
}

void kit_print_words(const char *text, int column, int indent, int most)
{
    const char *between = "";
    for (size_t n; *(text += strspn(text, " \n")); text += n) {
        n = strcspn(text, " \n");
        if (*between && column + 1 + (int)n > most) {
            printf("\n%*s", indent, "");
            column = indent;
            between = "";
        }
        column += printf("%s%.*s", between, (int)n, text);
        between = " ";
    }
    putchar('\n');
}

void kit_json_string(FILE *out, const char *text)
{
    putc('"', out);
    for (const unsigned char *s = (const unsigned char *)text; *s;) {
        const int length = utf8_length(s);
        if (!length) fputs("\\ufffd", out);
        else if (*s < ' ') fprintf(out, "\\u%04x", (unsigned)*s);
        else {
            if (*s == '"' || *s == '\\') putc('\\', out);
            fwrite(s, 1, (size_t)length, out);
        }
        s += length ? length : 1;
    }
    putc('"', out);
}

void kit_json_number(FILE *out, double v, int decimals)
{
    if (!isfinite(v)) fputs("null", out);
    else if (decimals < 0) fprintf(out, "%.*g", -decimals, v);
    else fprintf(out, "%.*f", decimals, v);
}

double kit_dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

void kit_cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; ++i) out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

int kit_unit(double v[3])
{
    const double length = sqrt(kit_dot(v, v));
    if (!(length > 0) || !isfinite(length)) return 0;
    for (int i = 0; i < 3; ++i) v[i] /= length;
    return 1;
}

int kit_face(const float corner[9], double n[3])
{
    double a[3], b[3];
    for (int i = 0; i < 3; ++i) {
        a[i] = (double)corner[3 + i] - (double)corner[i];
        b[i] = (double)corner[6 + i] - (double)corner[i];
    }
    kit_cross(a, b, n);
    return kit_unit(n);
}
