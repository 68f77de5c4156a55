/* choices.h - the passes, and the choices that change their text, one at a time. */
#ifndef CHOICES_H
#define CHOICES_H

#include "ssgi_gl.h"

typedef struct choice { const char *name; size_t offset; int value; } choice;
typedef struct variant { char title[48]; ssgi_gl_desc desc; } variant;     /* "hsao, march" */
enum { MOST_CHOICES = 128 };
extern const choice choices[];     /* the first is none */
extern const int choices_count;
int variant_at(variant *v, int i);                   /* 0: there are fewer. By pass, first the plain one */
ssgi_gl_desc with_choice(ssgi_gl_desc d, int c);     /* with choice c too; 0 is none */

#endif
