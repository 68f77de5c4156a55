/* count.h - counts how often a wave executes each instruction, by a walk through the assembly that RADV prints. */
#ifndef COST_COUNT_H
#define COST_COUNT_H

/* Counts of instructions of one lane. vector includes transcendental; fetches include wide_fetches, of over 8 bytes. */
typedef struct counts {
    double vector, transcendental, scalar_loads, fetches, wide_fetches, scalar;
} counts;

void counts_add(counts *to, const counts *c, double times);

enum { MOST_LOOPS = 32, MOST_BODIES = 8 };

/* How unknown conditions are treated. BUSY: the more expensive side is executed, and both sides if lanes may differ.
   CALM: inside loops the cheaper side, and no body of an `if` that no lane needs to enter. WEIGHED: each body counts by
   the share of waves of 8x8 texels that enter it (share.h); WEIGHED_FLAT: of waves of 16x4. */
typedef enum way { BUSY, CALM, WEIGHED, WEIGHED_FLAT, WAYS } way;

typedef struct walk_report {
    int endless[MOST_LOOPS], loops;         /* loops whose end is unknown, by the label of their first block */
    int unknown;                            /* how many unknown conditions are the same for all lanes */
} walk_report;

/* The counted instructions of a program. body: for each body that a calm wave skips, the instructions that entering it
   adds, inner bodies included, in the order of the text; bodies: how many there are, also beyond the array. */
typedef struct counted {
    counts busy, calm, body[MOST_BODIES];
    int bodies;
    walk_report report;
} counted;

/* Counts by a text that LLVM's disassembler writes, with "BB3:" before blocks. turns: of loops with an unknown end, for
   BUSY and CALM. Returns 0; or -1 if a line is not understood, to which *bad then points. */
int count_instructions(counted *c, const char *text, const int turns[2], const char **bad);

#endif
