/* choices.h - the passes, and the choices that change their text, one at a time. */
#ifndef CHOICES_H
#define CHOICES_H

#include "ssgi_gl.h"

typedef struct choice { const char *name; size_t offset; int value; } choice;
typedef struct variant { const char *title; ssgi_gl_desc desc; } variant;
enum { MOST_CHOICES = 128 };
extern const choice choices[];     /* the first is none */
extern const variant variants[];
extern const int choices_count, variants_count;
ssgi_gl_desc with_choice(ssgi_gl_desc d, int c);     /* with choice c too; 0 is none */

#endif
