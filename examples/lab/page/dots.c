/* dots.c - the chart of many scenes. Declared in dots.h. */
#include "lab/page/dots.h"
#include <math.h>
#include <string.h>
#include "lab/page/page.h"
#include "lab/page/svg.h"

/* of a row; where the lines begin and the first one lies; between two groups' dots. Beyond MOST a dot lies at the
   side. */
enum { HIGH = 26, LEFT = 376, FIRST = 112, APART = 2 };
#define MOST 1.4

static double across(double v) { return LEFT + (SVG_RIGHT - LEFT) * fmin(v, MOST) / MOST; }

static const char *colour_of(int group) { return group < 6 ? svg_colour(group) : "#333333"; }

static void legend(FILE *f, const dots *d)
{
    double x = SVG_LEFT + 4;
    fprintf(f, "<text x=\"%d\" y=\"56\">%s; upright: the mean, and its 95 %% interval%s%s</text>\n", SVG_LEFT,
            d->across, *d->marked ? "; rings: " : "", d->marked);
    for (int g = 0; g < d->groups; ++g) {
        fprintf(f, "<circle cx=\"%.1f\" cy=\"78\" r=\"4\" fill=\"%s\"/><text x=\"%.1f\" y=\"82.5\">%s</text>\n", x,
                colour_of(g), x + 8, d->group_name[g]);
        x += 26 + 7.8 * (double)strlen(d->group_name[g]);
    }
}

/* Lines up the frame; 1 is as far off as nothing. */
static void ticks(FILE *f, int bottom)
{
    for (int k = 0; k <= 7; ++k) {
        const double v = 0.2 * k;
        fprintf(f, "<path d=\"M%.1f %dV%d\" stroke=\"%s\"/>", across(v), FIRST - HIGH / 2, bottom,
                k == 5 ? "#888888" : "#eeeeee");
        fprintf(f, "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g%s</text>\n", across(v), bottom + 18, v,
                k == 7 ? "+" : "");
    }
}

static void row_name(FILE *f, const dots *d, int i, double y)
{
    const int named = !i || strcmp(d->label[i], d->label[i - 1]);
    if (named) {
        fprintf(f, "<text x=\"14\" y=\"%.1f\" font-size=\"12\" font-weight=\"600\" fill=\"#222\">", y + 4);
        page_escaped(f, d->label[i]);
        fputs("</text>", f);
    }
    fprintf(f, "<text x=\"%d\" y=\"%.1f\" font-size=\"10.5\" text-anchor=\"end\">", LEFT - 10, y + 4);
    page_escaped(f, d->settings[i]);
    fputs("</text>\n", f);
}

static void row_dots(FILE *f, const dots *d, int i, double y)
{
    for (int g = 0; g < d->groups; ++g) {
        const double at = y + APART * (g - 0.5 * (d->groups - 1));
        fprintf(f, "<path stroke=\"%s\" stroke-width=\"4\" stroke-linecap=\"round\" stroke-opacity=\".55\" d=\"",
                colour_of(g));
        for (int k = 0; k < d->count; ++k)
            if (d->group[k] == g && !isnan(d->value[i * d->count + k]))
                fprintf(f, "M%.1f %.1fh0", across(d->value[i * d->count + k]), at);
        fputs("\"/>\n", f);
    }
}

static void row_drawn(FILE *f, const dots *d, int i)
{
    const double y = FIRST + HIGH * i;
    const spread s = spread_of(d->value + i * d->count, d->count);
    fprintf(f, "<g><title>%s %s: mean %.3f, median %.3f, worst %.3f</title>\n", d->label[i], d->settings[i], s.mean,
            s.median, s.most);
    if (i && strcmp(d->label[i], d->label[i - 1]))
        fprintf(f, "<path d=\"M14 %.1fH%d\" stroke=\"#e4e4e4\"/>\n", y - HIGH / 2, SVG_RIGHT);
    row_name(f, d, i, y);
    row_dots(f, d, i, y);
    if (!isnan(s.half))
        fprintf(f, "<path d=\"M%.1f %.1fH%.1f\" stroke=\"#111\" stroke-width=\"5\" stroke-opacity=\".35\"/>",
                across(s.mean - s.half), y, across(s.mean + s.half));
    if (s.count)
        fprintf(f, "<path d=\"M%.1f %.1fv%d\" stroke=\"#111\" stroke-width=\"2\"/>", across(s.mean), y - 10, 20);
    if (!isnan(d->mark[i]))
        fprintf(f, "<circle cx=\"%.1f\" cy=\"%.1f\" r=\"5\" fill=\"none\" stroke=\"#111\" stroke-width=\"1.5\"/>",
                across(d->mark[i]), y);
    fputs("</g>\n", f);
}

int dots_chart(FILE *html, const char *out, const char *name, const char *title, const dots *d, kit_error *err)
{
    const int bottom = FIRST + HIGH * d->rows - HIGH / 2;
    page p;
    if (page_open(&p, err)) return -1;
    svg_begin_high(p.file, title, bottom + 34);
    legend(p.file, d);
    ticks(p.file, bottom);
    for (int i = 0; i < d->rows; ++i) row_drawn(p.file, d, i);
    fputs("</svg>\n", p.file);
    fflush(p.file);
    fwrite(p.text, 1, p.size, html);
    return page_close(&p, out, name, err);
}
