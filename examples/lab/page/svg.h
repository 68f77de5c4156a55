/* svg.h - what SVG charts are drawn with: a frame with a title, scales, ticks, markers. */
#ifndef LAB_SVG_H
#define LAB_SVG_H

#include <stdio.h>

/* of the picture; of the frame in it */
enum { SVG_WIDE = 900, SVG_HIGH = 566, SVG_LEFT = 74, SVG_RIGHT = 876, SVG_TOP = 138, SVG_BOTTOM = 498 };
/* what lies at the frame's sides; x as logarithms unless even */
typedef struct scale { double x0, x1, y0, y1; int even; } scale;
double svg_x(const scale *s, double v);
double svg_y(const scale *s, double v);
double svg_step(double least, double span);          /* 1, 2 or 5 times a power of ten: at most six lines in span */

void svg_begin(FILE *f, const char *title);
void svg_begin_high(FILE *f, const char *title, int high);     /* of another height than SVG_HIGH */
/* A line across the frame and its number, so; one up the frame, and the number under it. */
void svg_level(FILE *f, const scale *s, double v, const char *stroke, const char *number);
void svg_tick(FILE *f, const scale *s, double v, const char *stroke);
void svg_tick_number(FILE *f, const scale *s, double v);
/* up: so far from the left side */
void svg_axes(FILE *f, const char *across, const char *up, int left);
/* Okabe and Ito's palette, told apart by colour-blind eyes too; orange and sky are left for curves five and six. */
const char *svg_colour(int series);
/* a path's attributes: shape by series */
void svg_marker(FILE *f, int series, const char *colour, double x, double y);

#endif
