/* t.h - the tests' harness: a test is a function and a sentence; it passes when all its checks hold. */
#ifndef T_H
#define T_H
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/resource.h>

/* the arguments of the message are evaluated only if it fails */
#define CHECK(condition, ...) t_is((condition) || t_check(__FILE__, __LINE__, __VA_ARGS__))
static inline int t_is(int ok) { return ok; }
#define ROWS(table) ((int)(sizeof(table) / sizeof *(table)))
/* A check that also prints its message as a note if it holds. */
#define SHOW(condition, ...) \
    t_is((condition) ? t_note(__VA_ARGS__), 1 : t_check(__FILE__, __LINE__, __VA_ARGS__))
/* a call that returns 0, or another number and a reason in `err` */
#define TRY(call) CHECK(!(call), "%s", err.text)
/* a function of the library that should succeed, and its arguments before the last one, its reason */
#define T_OK(function, ...) CHECK(function(__VA_ARGS__, &t_why) == SSGI_OK, #function ": %s", t_why)
#define RUN(sentence, function) t_run(sentence, function)
/* A call that is refused: it returns that result, its reason begins with name, and out keeps the value was. */
#define T_REFUSED(call, result, name, out, was) \
    do { \
        const char *why = ""; \
        CHECK((call) == (result) && !strncmp(why, name, strlen(name)) && !memcmp(&(out), &(was), sizeof(out)), \
              "%s: \"%s\", or something was written", name, why); \
    } while (0)

#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
/* Notes a failure and returns 0. The message has the value that was found. Outside of a test the line is FAILED. */
int  t_check(const char *file, int line, const char *format, ...);
/* prints a figure below the test's line */
void t_note(const char *format, ...);
/* runs a test, prints "ok" or "FAILED" and counts it; prints its processor time from 0.3 seconds on */
void t_run(const char *sentence, void (*test)(void));
/* returns seconds of processor: no test may depend on how fast or busy the machine is */
double t_seconds(const struct rusage *spent);
/* returns the processor's seconds until now of this process, or of its children that have ended */
double t_spent(int children);

/* Random numbers, the same in every run [SplitMix64, by which successive numbers are independent]. Each group has its
   own sequence, which t_seed restarts. */
void     t_seed(uint64_t seed);
uint32_t t_below(uint32_t n);                          /* 0 .. n - 1 */
float    t_uniform(float lower, float upper);          /* [lower, upper) */
double   t_within(double lower, double upper);         /* the same in double */

/* Returns whether make test-all runs the group (T_ALL), with more shaders, compilers and inputs. */
int      t_all(void);

extern int t_passed, t_failed;
extern const char *t_why;                  /* the reason of T_OK */
extern const char *t_root;                 /* the repository's folder, in which tests run */

/* The groups of tests: each test_NAME is in its own file, and main.c calls it. Long groups are first, so that a short
   one ends last. A program has the groups of the library or of the examples (Makefile); the others are NULL in it. */
#define T_GROUPS(X) \
    X(build) X(tools) X(text) X(stability) X(errors) X(scenes) X(pipeline) X(history) X(light) X(coefficients) \
    X(surfels) X(occluders) X(trace) X(field) X(files) X(steps) X(read) X(plan) X(twins) X(models) X(seeds) \
    X(library) X(view) X(bias) X(kernel) X(sh) X(environment) X(cap) X(arguments) X(papers) X(cost)
#define T_GROUP(name) __attribute__((weak)) void test_##name(void);
T_GROUPS(T_GROUP)

/* A desc.shader.fetch that has every function that a choice CUSTOM calls. */
#define T_FETCH \
    "float ssgi_custom_depth(ivec2 p, int j) { return float(p.x + j); }\nvec3 ssgi_custom_normal(ivec2 p) { return " \
    "vec3(p, 1.0); }\nuint ssgi_custom_object(ivec2 p) { return uint(p.x); }\n" \
    "vec3 ssgi_custom_surfel(vec3 p, vec3 n, vec3 colour) { return colour * max(n.y, p.x); }\n" \
    "vec3 ssgi_custom_harmonic(int i, vec3 p) { return p * float(i + 1); }\n" \
    "float ssgi_custom_reach(vec3 p, vec3 n, float r, vec3 colour, float e) { return r * colour.x / e; }\nvec4 " \
    "ssgi_custom_effect(vec3 p, vec3 m, float r, vec3 colour, vec3 P, vec3 n) { return vec4(colour * r, dot(m, n)); }"

#endif
