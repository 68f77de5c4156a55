/* folder.h - the folders of outputs and of files that are kept between runs. */
#ifndef LAB_FOLDER_H
#define LAB_FOLDER_H

#include "kit/kit.h"

#define FOLDER_CACHE "build/cache"         /* keeps truths, and results of an interrupted chart */

/* Makes a folder and the folders above it, unless they are there. */
int folder_make(const char *path, kit_error *err);

#endif
