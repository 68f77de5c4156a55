/* chains.h - the chains whose shaders are written, counted and checked. */
#ifndef CHAINS_H
#define CHAINS_H

#include "kit/kit.h"
#include "ssgi_gl.h"

enum { MOST_STEPS = 128 }; /* With 8 layers, and 4 extra cameras of 8 layers, a chain has 127. */

/* The i-th chain, in the form that ssgi_gl_chain_of takes: first the library's methods; NULL past the last. */
const char *chain_at(int i);
/* The sentence of a method; "" for other chains. */
const char *chain_about(const char *name);
/* ssgi_gl_chain_of in a dialect, with width and height 1. */
int chain_parse(ssgi_gl_chain *chain, const char *text, int dialect, kit_error *err);
/* Writes all steps of a chain in a dialect and returns their number, at most MOST_STEPS; 0 and an error if it has
   none. */
int chain_steps(ssgi_gl_step steps[MOST_STEPS], const ssgi_gl_chain *chain, int dialect, kit_error *err);

#endif
