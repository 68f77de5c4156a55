/* own.h - a test file's own copy of the library, for its tables of GLSL and rows. */
#ifndef OWN_H
#define OWN_H
#include "t.h"
#define SSGI_STATIC
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../ssgi_gl.h"
#endif
