/* choices.h - the passes, and values of fields that change their text. */
#ifndef CHOICES_H
#define CHOICES_H

#include "ssgi_gl.h"

typedef struct choice { char name[40]; size_t offset; int value; } choice;
typedef struct variant { char title[48]; ssgi_gl_desc desc; } variant;     /* "hsao, march" */
/* The i-th value of a field that is not its default, as "thickness-slabs": every word, 1 of switches, every number up
   to 4, 3 of what may be larger; not of group text. The first is none; 0: there are fewer. */
int choice_at(choice *c, int i);
int variant_at(variant *v, int i);                   /* 0: there are fewer. By pass, first the plain one */
ssgi_gl_desc with_choice(ssgi_gl_desc d, int c);     /* with choice c too; 0 is none */

#endif
