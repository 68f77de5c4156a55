/* others.h - EXR files by OpenEXR's older library, which is C++ beneath a C interface: what it writes is half
   floats R, G, B, A. 0, or -1. */
#ifndef OTHERS_H
#define OTHERS_H
#include <OpenEXR/ImfCRgbaFile.h>

ImfRgba others_pixel(float r, float g, float b, float a);
/* compression: IMF_.._COMPRESSION; tile: the side of a tile, 0 = rows */
int others_write(const char *path, int width, int height, int compression, int tile, const ImfRgba *pixels);
#endif
