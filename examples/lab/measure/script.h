/* script.h - peers.mjs (make peers), which writes down what effects of other libraries draw. */
#ifndef LAB_SCRIPT_H
#define LAB_SCRIPT_H

#include "kit/kit.h"

#define SCRIPT "build/peers/peers.mjs"

/* Has the script write its manifest, texts and texels for a view into a folder, which is made where it is not there.
   depth: the view depth of the middle of the pixels; quick: fewer effects. 1; 0 = node cannot run it; -1 = failed. */
int script_run(const char *folder, const kit_camera *c, float radius, double depth, int quick, kit_error *err);

#endif
