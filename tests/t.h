/* t.h - the tests' harness: a test is a function and a sentence; it passes when all its checks hold. */
#ifndef T_H
#define T_H
#include <stdio.h>

#define CHECK(condition, ...) t_check((condition) ? 1 : 0, __FILE__, __LINE__, __VA_ARGS__)
#define RUN(sentence, function) t_run(sentence, function)

#if defined(__GNUC__)
__attribute__((format(printf, 4, 5)))
#endif
int  t_check(int ok, const char *file, int line, const char *format, ...); /* the message says what was found; returns ok */
void t_note(const char *format, ...);                                      /* a figure worth printing under the test's line */
void t_run(const char *sentence, void (*test)(void));                      /* runs it, prints "ok" or "FAILED", counts it */

/* one function a file, called by main.c */
void test_trace(void);
void test_files(void);
void test_math(void);
void test_text(void);
void test_pipeline(void);
void test_light(void);
void test_vectors(void);
void test_field(void);
void test_casters(void);
void test_surfels(void);
void test_plan(void);
void test_stability(void);
void test_build(void);
#endif
