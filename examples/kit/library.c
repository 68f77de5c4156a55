/* library.c - the one file of the kit that holds the library's code. */
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"
