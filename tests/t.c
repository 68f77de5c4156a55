/* t.c - the tests' harness. A test's messages are kept until its line is printed, so that they stand below it. */
#include "t.h"

#include <stdarg.h>
#include <stdlib.h>
#include <string.h>

static uint64_t state;
void t_seed(uint64_t seed) { state = seed; }
static uint64_t drawn(void)
{
    uint64_t z = state += 0x9e3779b97f4a7c15u;
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return z ^ z >> 31;
}
uint32_t t_below(uint32_t n) { return (uint32_t)((drawn() >> 32) * n >> 32); }
float    t_uniform(float lower, float upper)
{
    return lower + (upper - lower) * (float)(drawn() >> 40) / 16777216.0f;
}
double   t_within(double lower, double upper)
{
    return lower + (upper - lower) * (double)(drawn() >> 11) / 9007199254740992.0;
}

int t_all(void) { return getenv("T_ALL") != NULL; }

int t_passed, t_failed;
const char *t_why = "";
const char *t_root;

enum { SHOWN = 5 };                        /* how many failures of a test are printed; others are only counted */
static char   said[8192];
static size_t length;
static int    bad, running;

static void say(const char *format, va_list args)
{
    size_t room = sizeof said - length;
    int n = vsnprintf(said + length, room, format, args);
    if (n > 0) length += (size_t)n < room ? (size_t)n : room - 1;
}

#if defined(__GNUC__)
__attribute__((format(printf, 1, 2)))
#endif
static void sayf(const char *format, ...)
{
    va_list args;
    va_start(args, format);
    say(format, args);
    va_end(args);
}

int t_check(const char *file, int line, const char *format, ...)
{
    va_list args;
    if (!running) {
        ++t_failed;
        printf("FAILED  ");
        va_start(args, format);
        vprintf(format, args);
        va_end(args);
        printf("\n        %s:%d: outside any test\n", file, line);
        return 0;
    }
    if (++bad > SHOWN) return 0;
    sayf("        %s:%d: ", file, line);
    va_start(args, format);
    say(format, args);
    va_end(args);
    sayf("\n");
    return 0;
}

void t_note(const char *format, ...)
{
    va_list args;
    sayf("        ");
    va_start(args, format);
    say(format, args);
    va_end(args);
    sayf("\n");
}

double t_seconds(const struct rusage *spent)
{
    return (double)(spent->ru_utime.tv_sec + spent->ru_stime.tv_sec)
           + 1e-6 * (double)(spent->ru_utime.tv_usec + spent->ru_stime.tv_usec);
}

double t_spent(int children)
{
    struct rusage spent;
    getrusage(children ? RUSAGE_CHILDREN : RUSAGE_SELF, &spent);
    return t_seconds(&spent);
}

void t_run(const char *sentence, void (*test)(void))
{
    if (t_failed && getenv("T_FIRST")) return; /* make mutants needs only the first failure */
    char took[32] = "";
    const double began = t_spent(0) + t_spent(1);
    length = 0;
    said[0] = 0;
    bad = 0;
    running = 1;
    test();
    running = 0;
    if (bad) ++t_failed; else ++t_passed;
    const double seconds = t_spent(0) + t_spent(1) - began;
    if (seconds >= 0.3) snprintf(took, sizeof took, " (%.1f s)", seconds);
    printf("%-7s %s%s\n%s", bad ? "FAILED" : "ok", sentence, took, said);
    if (bad > SHOWN) printf("        and %d more\n", bad - SHOWN);
    fflush(stdout);
}
