/* main.c - runs all tests; the last line is "N passed, N failed". Arguments name groups to run; none = all. Each group
   is a process, with as many at a time as processors. Their outputs come in order, each below the group's name and its
   processor time, which includes programs that it started. */
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>
#include "t.h"

#define ROW(name) { #name, test_##name },
static const struct { const char *name; void (*run)(void); } groups[] = { T_GROUPS(ROW) };
enum { GROUPS = (int)(sizeof groups / sizeof groups[0]) };

static struct { pid_t process; FILE *said; int answer[2], done; double seconds; } job[GROUPS];

/* Changes to the folder above build/, where this program lies, from any folder and environment. */
static int go_home(const char *program)
{
    char *path = realpath(program, NULL), *end = path;
    for (int up = 0; end && up < 2; ++up) if ((end = strrchr(path, '/')) != NULL) *end = 0;
    t_root = path;
    return !end || chdir(path) || access("ssgi_gl.h", R_OK) ? -1 : 0;
}

static void start(int g)
{
    job[g].said = tmpfile();
    fflush(stdout);
    job[g].process = job[g].said && !pipe(job[g].answer) ? fork() : -1;
    if (job[g].process < 0) { perror(groups[g].name); exit(2); }
    if (job[g].process) { close(job[g].answer[1]); return; }
    int counts[2];
    t_passed = t_failed = 0;
    dup2(fileno(job[g].said), STDOUT_FILENO);
    dup2(fileno(job[g].said), STDERR_FILENO);
    groups[g].run();
    fflush(stdout);
    counts[0] = t_passed;
    counts[1] = t_failed;
    _exit(write(job[g].answer[1], counts, sizeof counts) != sizeof counts);
}

static void finish(int g, int status, const struct rusage *spent)
{
    int counts[2] = { 0, 1 };
    job[g].done = 1;
    job[g].seconds = t_seconds(spent);
    if (read(job[g].answer[0], counts, sizeof counts) != sizeof counts)
        dprintf(fileno(job[g].said), "FAILED  the group ended before its tests did: status %d\n", status);
    close(job[g].answer[0]);
    t_passed += counts[0];
    t_failed += counts[1];
}

static void print(int g)
{
    char part[4096];
    printf("%s (%.1f s)\n", groups[g].name, job[g].seconds);
    rewind(job[g].said);
    for (size_t n; (n = fread(part, 1, sizeof part, job[g].said)) > 0;) fwrite(part, 1, n, stdout);
    fclose(job[g].said);
    fflush(stdout);
}

int main(int argc, char **argv)
{
    const long processors = sysconf(_SC_NPROCESSORS_ONLN);
    /* Mesa's software rasteriser would spend most of the time on optimising shaders that draw a few small pictures.
       With vectors of 4 floats a picture is the same on every processor. */
    setenv("GALLIVM_PERF", "nopt", 0);
    setenv("LP_NATIVE_VECTOR_WIDTH", "128", 0);
    setenv("PATH", "/usr/local/bin:/usr/bin:/bin", 0);     /* gcc finds its own parts by it */
    if (go_home(argv[0])) return fprintf(stderr, "test: %s: is not a path of build/test\n", argv[0]), 2;
    int running = 0, next = 0, shown = 0, wanted[GROUPS];
    double all = 0;
    for (int g = 0; g < GROUPS; ++g) {
        wanted[g] = argc < 2 && groups[g].run;
        job[g].done = !wanted[g];
    }
    for (int i = 1; i < argc; ++i) {
        int g = 0;
        while (g < GROUPS && !(groups[g].run && !strcmp(argv[i], groups[g].name))) ++g;
        if (g == GROUPS) return fprintf(stderr, "test: %s: is no group of this program\n", argv[i]), 2;
        wanted[g] = 1;
        job[g].done = 0;
    }
    for (;;) {
        while (next < GROUPS && (running < processors || !running)) {
            if (wanted[next]) { start(next); ++running; }
            ++next;
        }
        for (; shown < GROUPS && job[shown].done; ++shown)
            if (wanted[shown]) {
                print(shown);
                all += job[shown].seconds;
            }
        if (!running) break;
        struct rusage spent;
        int status;
        const pid_t ended = wait4(-1, &status, 0, &spent);
        for (int g = 0; g < GROUPS; ++g)
            if (wanted[g] && !job[g].done && job[g].process == ended) {
                finish(g, status, &spent);
                --running;
            }
    }
    printf("%.1f s of processor\n%d passed, %d failed\n", all, t_passed, t_failed);
    return t_failed != 0;
}
