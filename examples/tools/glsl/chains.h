/* chains.h - whole chains: what a method draws, by name and preset. */
#ifndef CHAINS_H
#define CHAINS_H

#include "kit/kit.h"
#include "ssgi_gl.h"

enum { MOST_STEPS = 128 }; /* With 8 layers and 4 extra cameras of 8 layers a chain has 127. */

/* A chain by the name that build/render gives its method, as chain_parse reads it. */
typedef struct chain_named { const char *name, *means, *about; } chain_named;
extern const chain_named chain_names[];
extern const int chain_names_count;

/* PASS[,PRESET][,FIELD=VALUE]..: a pass ssao hsao ssdo s3ho field splat; fast, balanced or best; fields of
   ssgi_gl_desc, enums by their words or numbers, "lights.FIELD" those of ssgi_gl_chain.lights ("lights=1": with no
   choice), and members of ssgi_gl_chain but width and height, which are 1. blur is 1 unless it is given. SSDO without
   an environment or a bounce gets ENVIRONMENT_MAP. What is wrong is an error that names it. */
int chain_parse(ssgi_gl_chain *chain, const char *text, kit_error *err);

/* Members of ssgi_gl_chain that are ints, but width and height; NULL past the last. */
const char *chain_member(const ssgi_gl_chain *chain, int i, int *value);

/* Its steps in a dialect, which are all of MOST_STEPS; 0 and an error where there are none. */
int chain_steps(ssgi_gl_step steps[MOST_STEPS], const ssgi_gl_chain *chain, int dialect, kit_error *err);

#endif
