/* others.h - writes EXR files by OpenEXR's older library, which is C++ with a C interface: half floats R, G, B, A.
   Returns 0, or -1. */
#ifndef OTHERS_H
#define OTHERS_H
#include <OpenEXR/ImfCRgbaFile.h>

ImfRgba others_pixel(float r, float g, float b, float a);
/* Writes a file. compression: IMF_.._COMPRESSION; tile: the side of a tile, 0 = rows */
int others_write(const char *path, int width, int height, int compression, int tile, const ImfRgba *pixels);
#endif
