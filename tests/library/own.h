/* own.h - a test file's own copy of the library, for its tables of GLSL and rows. */
#ifndef OWN_H
#define OWN_H
#include "t.h"
#define SSGI_STATIC
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"

/* Call this first, before passes are asked for their rows. The compiler counts the rows, but one pass may have two. */
static inline int every_pass_has_a_row(void)
{
    int pass = 0;
    while (pass < SSGI_GL_PASSES && ssgi_gl_pass_name(pass)) ++pass;
    return CHECK(pass == SSGI_GL_PASSES, "pass %d has no row in ssgi_gl__passes (ssgi_gl.h, >>passes)", pass);
}
#endif
