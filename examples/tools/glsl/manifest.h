/* manifest.h - lists the files of glsl.c as JSON for build steps in any language, and the fields of a desc as
   TypeScript. */
#ifndef MANIFEST_H
#define MANIFEST_H

#include "kit/kit.h"
#include "ssgi_gl.h"

extern const char *const endings[SSGI_GL_STAGES + 1];          /* file endings by stage: "vert" ..; functions: "glsl" */

/* Adds a variant's files by stage, NULL for a stage that it lacks; nothing if an earlier variant is the same. */
void manifest_variant(const ssgi_gl_desc *d, const char *const files[SSGI_GL_STAGES]);
void manifest_functions(const char *file);                     /* adds a file of functions only */
/* Adds a chain's steps and the files of each by stage; nothing if that name and dialect exist. */
void manifest_chain(const char *name, const char *about, const ssgi_gl_chain *chain, const ssgi_gl_step *steps,
                    int count, const char *const (*files)[SSGI_GL_STAGES]);
int  manifest_write(const char *path, kit_error *err);
void manifest_types(void);

#endif
