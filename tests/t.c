/* t.c - the tests' harness. What a test has to say is kept until its line is printed, so that it stands under it. */
#include "t.h"

#include <stdarg.h>
#include <string.h>

int t_passed, t_failed;

enum { SHOWN = 5 };                        /* messages of failed checks a test: the rest is counted */
static char   said[8192];
static size_t length;
static int    bad;

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

int t_check(int ok, const char *file, int line, const char *format, ...)
{
    if (ok || ++bad > SHOWN) return ok;
    va_list args;
    sayf("        %s:%d: ", file, line);
    va_start(args, format);
    say(format, args);
    va_end(args);
    sayf("\n");
    return ok;
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

void t_run(const char *sentence, void (*test)(void))
{
    length = 0;
    said[0] = 0;
    bad = 0;
    test();
    if (bad) ++t_failed; else ++t_passed;
    printf("%-7s %s\n%s", bad ? "FAILED" : "ok", sentence, said);
    if (bad > SHOWN) printf("        and %d more\n", bad - SHOWN);
    fflush(stdout);
}
