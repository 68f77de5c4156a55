/* strip.h - a strip of frames: one frame alone beside the last of sixteen, while the camera turns. */
#ifndef LAB_STRIP_H
#define LAB_STRIP_H

#include "lab/measure/stage.h"

int  strip_demo(FILE *record, stage *s, const char *out, kit_error *err);
void strip_text(FILE *f);

#endif
