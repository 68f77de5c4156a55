/* library_gl.c - the one file of the kit that holds ssgi_gl.h's code. */
#define SSGI_IMPLEMENTED_ELSEWHERE
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"
