/* own.h - a test file's own copy of the library, for its tables of GLSL and rows. */
#ifndef OWN_H
#define OWN_H
#include "t.h"
#define SSGI_STATIC
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"

/* Returns a chain of 8 x 8 pixels in words: a pass, and fields as behind a method's name, such as
   "s3ho,search=points,layers=2". desc_in: its desc. */
static inline ssgi_gl_chain chain_in(const char *words)
{
    const size_t length = strcspn(words, ",");
    ssgi_gl_chain chain;
    int pass = 0, preset;
    memset(&chain, 0, sizeof chain);
    chain.width = chain.height = 8;
    while (pass < SSGI_GL_PASSES && !ssgi_gl__same(ssgi_gl_pass_name(pass), words, length)) ++pass;
    chain.desc.pass = (ssgi_gl_pass)pass;
    const char *const bad = ssgi_gl__set_all(&chain, &preset, words + length + (words[length] == ','));
    CHECK(pass < SSGI_GL_PASSES && !bad, "no chain: %s: %s", words, bad ? bad : "no such pass");
    return chain;
}
static inline ssgi_gl_desc desc_in(const char *words) { return chain_in(words).desc; }

/* Call this first, before passes are asked for their rows. The compiler counts the rows, but one pass may have two. */
static inline int every_pass_has_a_row(void)
{
    int pass = 0;
    while (pass < SSGI_GL_PASSES && ssgi_gl_pass_name(pass)) ++pass;
    return CHECK(pass == SSGI_GL_PASSES, "pass %d has no row in ssgi_gl__passes (ssgi_gl.h, >>passes)", pass);
}
#endif
