/* folder.h - where outputs go and what is kept between runs lies. */
#ifndef LAB_FOLDER_H
#define LAB_FOLDER_H

#include "kit/kit.h"

#define FOLDER_CACHE "build/cache"         /* truth, and what an interrupted chart has measured */

/* Makes a folder, and those above it, where they are not there. */
int folder_make(const char *path, kit_error *err);

#endif
