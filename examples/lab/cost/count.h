/* count.h - how often each instruction of a wave is executed, by a walk of the assembly that RADV shows. */
#ifndef COST_COUNT_H
#define COST_COUNT_H

/* Of one lane. transcendental ones are among vector, wide_fetches (of more than 8 bytes) among fetches. */
typedef struct counts {
    double vector, transcendental, scalar_loads, fetches, wide_fetches, buffer_loads, scalar, exports;
} counts;

enum { MOST_LOOPS = 32 };

/* BUSY: wherever a condition is not known, the dearer side is executed, and both sides where lanes may differ. CALM:
   inside loops the cheaper side, and no body of an `if` that no lane needs to enter. */
typedef enum way { BUSY, CALM } way;

typedef struct walk_report {
    int endless[MOST_LOOPS], loops;         /* the blocks that begin loops whose end is not known */
    int unknown;                            /* conditions, the same for all lanes, that are not known */
} walk_report;

/* The text is as LLVM's disassembler writes it, with "BB3:" before blocks. turns: of loops whose end is not known. 0,
   or -1: it is not understood, and *bad points to the line. */
int count_instructions(counts *c, walk_report *report, const char *text, way how, int turns, const char **bad);

#endif
