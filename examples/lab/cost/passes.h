/* passes.h - chains and their passes, and the programs that these are made of, each compiled once a family. */
#ifndef COST_PASSES_H
#define COST_PASSES_H

#include "lab/cost/compile.h"
#include "lab/cost/share.h"

enum { MOST_FAMILIES = 4, MOST_PROGRAMS = 512, MOST_CHAINS = 128, MOST_PASSES = 16, SIZES = 4 };
enum { WIDTH = 1920, HEIGHT = 1080 };       /* of the picture that milliseconds are of */

/* What a family's compiler makes of a program. */
typedef struct compiled {
    counts way[WAYS];                       /* of a fragment */
    int untold;                             /* 1: bodies cannot be told apart, so that all counts where it is weighed */
    double vertex;                          /* vector instructions of a vertex */
    walk_report report;
    int vgprs, spilled, scratch, waves;
    double seconds;                         /* of processor, that the compiler takes */
} compiled;

typedef struct cost_program {
    uint64_t key;
    const char *pass;                       /* the first that has it: assumptions on loops go by it */
    ssgi_gl_desc desc;                      /* likewise */
    char *text[STAGES];
    VkShaderStageFlagBits kind[STAGES];
    spirv stage[STAGES];
    int stages, formats, relaxed;           /* relaxed: the texts are OpenGL's, with uniforms in no block */
    VkFormat format[8];
    double seconds;                         /* of processor, that glslang takes */
    compiled of[MOST_FAMILIES];
    kit_error err;
} cost_program;

typedef struct cost_pass {
    const char *name;
    int program, width, height, vertices;   /* vertices: of a surfel; 0: it draws the picture */
    double bytes_in, bytes_out;             /* of the pass */
} cost_pass;

typedef struct cost_chain {
    char name[128];
    cost_pass pass[MOST_PASSES];
    int passes;                             /* 0: Vulkan has not what it asks for */
    double targets[SIZES];                  /* bytes, by size of the picture */
    kit_error lacks;
} cost_chain;

extern const int sizes[SIZES][2];

typedef struct work {
    const char *family[MOST_FAMILIES];
    int families;
    char driver[64];
    csv shares;                             /* as recorded; no rows: none are known */
    cost_program program[MOST_PROGRAMS];
    cost_chain chain[MOST_CHAINS];
    int programs, chains;
} work;

/* A chain; one by its name or as chain_parse reads it; a pair of files, texts or SPIR-V: FILE.frag, FILE.frag.spv, with
   the vertex stage of that name beside it, if it is there. */
int work_add(work *w, const char *name, const ssgi_gl_chain *chain, kit_error *err);
int work_add_chain(work *w, const char *text, kit_error *err);
int work_add_file(work *w, const char *path, kit_error *err);
/* A chain without passes yet; NULL: there are too many. The number of a program with these texts, which it takes over,
   and formats; -1: there are too many. */
cost_chain *work_chain(work *w, const char *name, kit_error *err);
int work_program(work *w, cost_program *p, kit_error *err);
/* Compiles and counts all of it. */
int work_do(work *w, kit_error *err);
void work_free(work *w);

/* What is taken for granted of loops whose end no instruction tells. */
typedef struct assumed { const char *pass; int turns[2]; const char *why; } assumed;    /* BUSY, CALM */
extern const assumed assumptions[];
extern const int assumptions_count;

#endif
