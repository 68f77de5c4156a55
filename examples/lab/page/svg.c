/* svg.c - what SVG charts are drawn with. Declared in svg.h. */
#include "lab/page/svg.h"
#include <math.h>
#include "lab/page/page.h"

double svg_x(const scale *s, double v)
{
    return SVG_LEFT + (SVG_RIGHT - SVG_LEFT) * ((s->even ? v : log(v)) - s->x0) / (s->x1 - s->x0);
}

double svg_y(const scale *s, double v) { return SVG_BOTTOM - (SVG_BOTTOM - SVG_TOP) * (v - s->y0) / (s->y1 - s->y0); }

double svg_step(double least, double span)
{
    double s = least;
    for (int i = 0; span / s > 5; ++i) s *= i % 3 == 1 ? 2.5 : 2;
    return s;
}

void svg_begin(FILE *f, const char *title) { svg_begin_high(f, title, SVG_HIGH); }

void svg_begin_high(FILE *f, const char *title, int high)
{
    fprintf(f,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" role=\"img\" "
            "font-family=\"system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif\" font-size=\"13\" "
            "fill=\"#444\">\n<title>",
            SVG_WIDE, high, SVG_WIDE, high);
    page_escaped(f, title);
    fprintf(f,
            "</title>\n<rect width=\"%d\" height=\"%d\" rx=\"6\" fill=\"#fff\"/>\n<text x=\"%d\" y=\"32\" "
            "font-size=\"17\" font-weight=\"600\" fill=\"#111\">",
            SVG_WIDE, high, SVG_LEFT);
    page_escaped(f, title);
    fputs("</text>\n", f);
}

void svg_level(FILE *f, const scale *s, double v, const char *stroke, const char *number)
{
    fprintf(f, "<path d=\"M%d %.1fH%d\" stroke=\"%s\"/><text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%s</text>\n",
            SVG_LEFT, svg_y(s, v), SVG_RIGHT, stroke, SVG_LEFT - 9, svg_y(s, v) + 4.5, number);
}

void svg_tick(FILE *f, const scale *s, double v, const char *stroke)
{
    fprintf(f, "<path d=\"M%.1f %dV%d\" stroke=\"%s\"/>", svg_x(s, v), SVG_TOP, SVG_BOTTOM, stroke);
}

void svg_tick_number(FILE *f, const scale *s, double v)
{
    fprintf(f, "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g</text>\n", svg_x(s, v), SVG_BOTTOM + 20,
            fabs(v) < 1e-9 ? 0 : v);
}

void svg_axes(FILE *f, const char *across, const char *up, int left)
{
    fprintf(f,
            "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s</text>\n<text transform=\"translate(%d %d) "
            "rotate(-90)\" text-anchor=\"middle\">%s</text>\n",
            (SVG_LEFT + SVG_RIGHT) / 2, SVG_BOTTOM + 46, across, left, (SVG_TOP + SVG_BOTTOM) / 2, up);
}

const char *svg_colour(int series)
{
    static const char *const colours[] = { "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#B07A00", "#3A9BD9" };
    return colours[series % (int)(sizeof colours / sizeof colours[0])];
}

void svg_marker(FILE *f, int series, const char *colour, double x, double y)
{
    fprintf(f, "fill=\"%s\" stroke=\"#fff\" stroke-width=\"1.5\"", colour);
    if (series % 4 == 0) fprintf(f, " d=\"M%.1f %.1fa5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0 -11 0z\"", x - 5.5, y);
    if (series % 4 == 1) fprintf(f, " d=\"M%.1f %.1fh10v10h-10z\"", x - 5, y - 5);
    if (series % 4 == 2) fprintf(f, " d=\"M%.1f %.1fl6.5 11.5h-13z\"", x, y - 7);
    if (series % 4 == 3) fprintf(f, " d=\"M%.1f %.1fl7 7l-7 7l-7 -7z\"", x, y - 7);
}
