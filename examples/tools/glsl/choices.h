/* choices.h - the passes, and the values of fields that change their shaders. */
#ifndef CHOICES_H
#define CHOICES_H

#include "ssgi_gl.h"

typedef struct choice { char name[40]; size_t offset; int value; } choice;
typedef struct variant { char title[48]; ssgi_gl_desc desc; } variant;     /* "hsao, march" */
/* The i-th value of a field, other than its default, as "thickness-slabs": every word; 1 of switches; every count up to
   4; 3 of larger counts; not of group text. The first choice is none; 0: there is no i-th. */
int choice_at(choice *c, int i);
int variant_at(variant *v, int i);                   /* 0: there is no i-th. By pass, first the plain variant */
ssgi_gl_desc with_choice(ssgi_gl_desc d, int c);     /* adds choice c; 0 is none */

#endif
