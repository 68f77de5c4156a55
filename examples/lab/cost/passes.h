/* passes.h - chains, their passes, and the passes' programs, each of which is compiled once for each GPU family. */
#ifndef COST_PASSES_H
#define COST_PASSES_H

#include "lab/cost/compile.h"
#include "lab/cost/share.h"

enum { MOST_FAMILIES = 4, MOST_PROGRAMS = 512, MOST_CHAINS = 128, MOST_PASSES = 16 };
enum { WIDTH = 1920, HEIGHT = 1080 };       /* the picture's size, for all modelled milliseconds */

/* A program as the compiler made it for one GPU family, and its counts. */
typedef struct compiled {
    counts way[WAYS];                       /* of a fragment */
    int untold;                             /* 1: bodies cannot be told apart: weighed counts are busy ones */
    double vertex;                          /* vector instructions of one vertex */
    walk_report report;
    int vgprs, spilled, scratch, waves;
    double seconds;                         /* the compiler's processor time */
} compiled;

typedef struct cost_program {
    uint64_t key;
    const char *pass;                       /* the first pass with it, whose loops' assumed turns it takes */
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
    int program, width, height, vertices;   /* vertices: of each surfel drawn; 0: one triangle over the picture */
    double bytes_in, bytes_out;             /* bytes that the whole pass reads and writes */
} cost_pass;

typedef struct cost_chain {
    char name[128];
    cost_pass pass[MOST_PASSES];
    int passes;                             /* 0: Vulkan lacks a feature that the chain needs */
    double targets;                         /* bytes of all the chain's targets */
    kit_error lacks;
} cost_chain;

typedef struct work {
    const char *family[MOST_FAMILIES];
    int families;
    char driver[64];
    csv shares;                             /* shares.csv; without rows no shares are recorded */
    cost_program program[MOST_PROGRAMS];
    cost_chain chain[MOST_CHAINS];
    int programs, chains;
} work;

/* Add a chain: one that is made; one by its name or in words that chain_parse reads; a pair of files, GLSL or SPIR-V:
   FILE.frag or FILE.frag.spv, and the vertex stage of that name, if it is there. */
int work_add(work *w, const char *name, const ssgi_gl_chain *chain, kit_error *err);
int work_add_chain(work *w, const char *text, kit_error *err);
/* A chain's passes to one that has others. */
int work_add_to(work *w, cost_chain *c, const ssgi_gl_chain *chain, kit_error *err);
int work_add_file(work *w, const char *path, kit_error *err);
/* work_chain adds a chain without passes; NULL: there are too many. work_program returns the index of the program with
   these formats and shaders, which it takes over; -1: there are too many. */
cost_chain *work_chain(work *w, const char *name, kit_error *err);
int work_program(work *w, cost_program *p, kit_error *err);
/* Compiles all programs and counts their instructions. */
int work_do(work *w, kit_error *err);
void work_free(work *w);

/* A pass's loops whose end no instruction tells: the turns that are assumed for them, for BUSY and CALM. */
typedef struct assumed { const char *pass; int turns[2]; } assumed;
extern const assumed assumptions[];
extern const int assumptions_count;

#endif
