/* count.h - how often each instruction of a wave is executed, by a walk of the assembly that RADV shows. */
#ifndef COST_COUNT_H
#define COST_COUNT_H

/* Of one lane. transcendental ones are among vector, wide_fetches (of more than 8 bytes) among fetches. */
typedef struct counts {
    double vector, transcendental, scalar_loads, fetches, wide_fetches, scalar;
} counts;

void counts_add(counts *to, const counts *c, double times);

enum { MOST_LOOPS = 32, MOST_BODIES = 8 };

/* BUSY: wherever a condition is not known, the dearer side is executed, and both sides where lanes may differ. CALM:
   inside loops the cheaper side, and no body of an `if` that no lane needs to enter. WEIGHED: bodies count by the share
   of waves of 8x8 texels that enter (share.h); WEIGHED_FLAT: of 16x4. */
typedef enum way { BUSY, CALM, WEIGHED, WEIGHED_FLAT, WAYS } way;

typedef struct walk_report {
    int endless[MOST_LOOPS], loops;         /* the blocks that begin loops whose end is not known */
    int unknown;                            /* conditions, the same for all lanes, that are not known */
} walk_report;

/* body: what each of the bodies that a calm wave skips adds where it is entered, all that it holds among it, in the
   order of the text; bodies: how many there are, of which at most MOST_BODIES are in the array. */
typedef struct counted {
    counts busy, calm, body[MOST_BODIES];
    int bodies;
    walk_report report;
} counted;

/* The text is as LLVM's disassembler writes it, with "BB3:" before blocks. turns: of loops whose end is not known, busy
   and calm. 0, or -1: it is not understood, and *bad points to the line. */
int count_instructions(counted *c, const char *text, const int turns[2], const char **bad);

#endif
