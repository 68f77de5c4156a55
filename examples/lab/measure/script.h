/* script.h - runs peers.mjs (make peers), which writes down the draws of other libraries' effects. */
#ifndef LAB_SCRIPT_H
#define LAB_SCRIPT_H

#include "kit/kit.h"

#define SCRIPT "build/peers/peers.mjs"

/* Has the script write its manifest, shaders and texels for a view into a folder, which is made if it is missing.
   depth: the median view depth; quick: fewer effects. Returns 1; 0 = node cannot run it; -1 = failed. */
int script_run(const char *folder, const kit_camera *c, float radius, double depth, int quick, kit_error *err);

#endif
