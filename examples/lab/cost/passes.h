/* passes.h - chains, their passes, and the passes' programs, each of which is compiled once for each family. */
#ifndef COST_PASSES_H
#define COST_PASSES_H

#include "lab/cost/compile.h"
#include "lab/cost/share.h"

enum { MOST_FAMILIES = 4, MOST_PROGRAMS = 512, MOST_CHAINS = 128, MOST_PASSES = 16, SIZES = 4 };
enum { WIDTH = 1920, HEIGHT = 1080 };       /* the picture's size, for all milliseconds */

/* A program as a family's compiler made it. */
typedef struct compiled {
    counts way[WAYS];                       /* of a fragment */
    int untold;                             /* 1: bodies cannot be told apart, so weighed is busy */
    double vertex;                          /* vector instructions of a vertex */
    walk_report report;
    int vgprs, spilled, scratch, waves;
    double seconds;                         /* the compiler's processor time */
} compiled;

typedef struct cost_program {
    uint64_t key;
    const char *pass;                       /* the first pass with this program; assumptions on loops depend on it */
    ssgi_gl_desc desc;                      /* of that pass */
    char *text[SHADER_STAGES];
    VkShaderStageFlagBits kind[SHADER_STAGES];
    spirv stage[SHADER_STAGES];
    int stages, formats, relaxed;           /* relaxed: the shaders are OpenGL's, with uniforms outside of blocks */
    VkFormat format[8];
    double seconds;                         /* glslang's processor time */
    compiled of[MOST_FAMILIES];
    kit_error err;
} cost_program;

typedef struct cost_pass {
    const char *name;
    int program, width, height, vertices;   /* vertices: of a surfel; 0: the pass covers the picture */
    double bytes_in, bytes_out;             /* bytes of the whole pass */
} cost_pass;

typedef struct cost_chain {
    char name[128];
    cost_pass pass[MOST_PASSES];
    int passes;                             /* 0: Vulkan lacks a feature that the chain needs */
    double targets[SIZES];                  /* bytes of all targets, by the picture's size */
    kit_error lacks;
} cost_chain;

extern const int sizes[SIZES][2];

typedef struct work {
    const char *family[MOST_FAMILIES];
    int families;
    char driver[64];
    csv shares;                             /* of shares.csv; no rows: none are recorded */
    cost_program program[MOST_PROGRAMS];
    cost_chain chain[MOST_CHAINS];
    int programs, chains;
} work;

/* Add a chain; a chain by its name or in words as chain_parse reads them; a pair of files, GLSL or SPIR-V: FILE.frag or
   FILE.frag.spv, and the vertex stage of that name, if it is there. */
int work_add(work *w, const char *name, const ssgi_gl_chain *chain, kit_error *err);
int work_add_chain(work *w, const char *text, kit_error *err);
/* A chain's passes to one that has others. */
int work_add_to(work *w, cost_chain *c, const ssgi_gl_chain *chain, kit_error *err);
int work_add_file(work *w, const char *path, kit_error *err);
/* work_chain: a chain without passes; NULL: there are too many. work_program: the index of the program with these
   shaders, which it takes over, and formats; -1: there are too many. */
cost_chain *work_chain(work *w, const char *name, kit_error *err);
int work_program(work *w, cost_program *p, kit_error *err);
/* Compiles all programs and counts their instructions. */
int work_do(work *w, kit_error *err);
void work_free(work *w);

/* Turns that are assumed for loops whose end no instruction tells, by the pass. */
typedef struct assumed { const char *pass; int turns[2]; const char *why; } assumed;    /* for BUSY and CALM */
extern const assumed assumptions[];
extern const int assumptions_count;

#endif
