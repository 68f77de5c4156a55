/* scatter.c - the chart of cost against error: time (or memory) across, share of the error (or the error) up. Declared
   in scatter.h. */
#include "lab/page/scatter.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/page/page.h"
#include "lab/page/svg.h"
#include "lab/page/table.h"

const words scatter_ao = {
    "left is faster, down is closer to the truth; numbers: texel fetches per pixel; grey band: nothing beats these",
    "GL time relative to one unblurred 16-sample SSAO (log scale)",
    "error (RMSE), share of having no AO at all",
    "time",
    "fetches",
    0
};
const words scatter_lit = {
    "left is faster, down is closer to the truth; numbers: texel fetches per pixel; grey band: nothing beats these",
    "GL time relative to one unblurred 16-sample SSAO (log scale)",
    "error (RMSE), share of the truth's mean radiance",
    "time",
    "fetches",
    0
};
const words scatter_turn = { "down is closer to the truth; 1 is as far off as no ambient occlusion at all",
                           "degrees that the camera has turned away from what occludes",
                           "error (RMSE) on the same ground, share of having no AO at all",
                           "degrees",
                           NULL,
                           1 };
const words scatter_field = { "left is smaller, down is closer to the truth; numbers: texels along a side of the cube "
                            "map; grey band: nothing beats these",
                            "bytes of the field, thousands (log scale)",
                            "RMSE of occlusion, hundredths",
                            "kB",
                            "texels a side",
                            0 };

/* ---- >>plot ------------------------------------------------------------------------------------------------------ */

typedef struct box { double x, y, w, h; } box;

enum { MOST_POINTS = 256, MOST_BOXES = 512 };
typedef struct plot {
    FILE        *f;
    const words *words;
    scale        scale;
    double       step, floor;              /* between levels; NAN = there is none */
    const row   *point[MOST_POINTS];       /* of one curve those of less time first */
    int          points, others;           /* curves from others on are other people's, fitted: grey */
    box          taken[MOST_BOXES];        /* by markers, lines and words */
    int          boxes;
} plot;

static void take(plot *p, box b)
{
    if (p->boxes < MOST_BOXES) p->taken[p->boxes++] = b;
}

static double covered(const box *b, const box *taken, int count)
{
    double sum = 0;
    for (const box *t = taken; t < taken + count; ++t) {
        double w = fmin(b->x + b->w, t->x + t->w) - fmax(b->x, t->x),
               h = fmin(b->y + b->h, t->y + t->h) - fmax(b->y, t->y);
        if (w > 0 && h > 0) sum += w * h;
    }
    return sum;
}

/* The place beside a point where its label covers least of what is there already. */
static box place(double x, double y, double w, const box *taken, int count)
{
    static const double offset[8][2] = { { 0, -15 }, { 0, 15 },   { 1, 0 },  { -1, 0 },
                                         { 1, -11 }, { -1, -11 }, { 1, 11 }, { -1, 11 } };
    box best = { 0, 0, 0, 0 };
    double least = HUGE_VAL;
    for (int k = 0; k < 8; ++k) {
        box b = { x - w / 2 + offset[k][0] * (w / 2 + (k < 4 ? 10 : 5)), y + offset[k][1] - 6, w, 12 };
        double cost = 2.0 * k;
        if (b.x < SVG_LEFT || b.x + b.w > SVG_RIGHT || b.y < SVG_TOP || b.y + b.h > SVG_BOTTOM) cost += 1000;
        cost += covered(&b, taken, count);
        if (cost < least) { least = cost; best = b; }
    }
    return best;
}

static int by_relative(const void *a, const void *b)
{
    double x = (*(const row *const *)a)->relative, y = (*(const row *const *)b)->relative;
    return (x > y) - (x < y);
}

static const char *colour_of(const plot *p, int series) { return series < p->others ? svg_colour(series) : "#77777f"; }

/* ---- >>frame ----------------------------------------------------------------------------------------------------- */

/* Which rows are points, and what the frame holds: all of them and the floor; from 0 on unless that leaves most of it
   empty. */
static void plot_scale(plot *p, const row *rows, int count)
{
    scale *s = &p->scale;
    *s = (scale){ HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL, p->words->even };
    for (int i = 0; i < count && p->points < MOST_POINTS; ++i) {
        if (isnan(rows[i].relative)) continue;
        p->point[p->points++] = &rows[i];
        s->x0 = fmin(s->x0, rows[i].relative);
        s->x1 = fmax(s->x1, rows[i].relative);
        s->y0 = fmin(s->y0, rows[i].share);
        s->y1 = fmax(s->y1, rows[i].share);
    }
    if (!isnan(p->floor)) { s->y0 = fmin(s->y0, p->floor); s->y1 = fmax(s->y1, p->floor); }
    if (s->y0 < 0.35 * s->y1) s->y0 = 0;
    p->step = svg_step(0.01, s->y1 - s->y0);
    s->y0 = fmax(0, p->step * floor(s->y0 / p->step - 0.25));
    s->y1 = p->step * ceil(s->y1 / p->step + 0.2);
}

/* Widens the scale by some room at both sides, and draws the lines. */
static void plot_even_ticks(plot *p)
{
    scale *s = &p->scale;
    const double every = svg_step(1, s->x1 - s->x0), room = 0.04 * (s->x1 - s->x0);
    s->x0 -= room;
    s->x1 += room;
    for (double v = every * ceil(s->x0 / every); v < s->x1; v += every) {
        svg_tick(p->f, s, v, "#eeeeee");
        svg_tick_number(p->f, s, v);
    }
}

static void plot_logarithmic_ticks(plot *p)
{
    static const double ticks[] = { 1, 1.5, 2, 3, 5, 7 };
    scale *s = &p->scale;
    double last = -100;
    s->x0 = log(s->x0 * 0.87);
    s->x1 = log(s->x1 * 1.15);
    for (int power = -3; power < 4; ++power)
        for (int k = 0; k < 6; ++k) {
            const double v = ticks[k] * pow(10, power);
            if (log(v) < s->x0 || log(v) > s->x1) continue;
            svg_tick(p->f, s, v, fabs(v - 1) < 1e-9 ? "#b0b0b0" : "#eeeeee");
            if (svg_x(s, v) - last <= 36) continue;
            svg_tick_number(p->f, s, v);
            last = svg_x(s, v);
        }
}

static void plot_frame(plot *p, const char *title)
{
    const scale *s = &p->scale;
    svg_begin(p->f, title);
    fprintf(p->f, "<text x=\"%d\" y=\"54\">%s</text>\n", SVG_LEFT, p->words->about);
    for (double v = s->y0; v < s->y1 + p->step / 2; v += p->step) {
        char number[32];
        snprintf(number, sizeof number, "%.*f", p->step < 0.095 ? 2 : 1, v);
        svg_level(p->f, s, v, v > s->y0 ? "#e4e4e4" : "#888", number);
    }
    if (s->even) plot_even_ticks(p);
    else plot_logarithmic_ticks(p);
    svg_axes(p->f, p->words->across, p->words->up, 24);
}

/* ---- >>floor ----------------------------------------------------------------------------------------------------- */

static void plot_floor(plot *p)
{
    const double y = svg_y(&p->scale, p->floor);
    fprintf(p->f, "<path d=\"M%d %.1fH%d\" stroke=\"#333\" stroke-width=\"1.5\" stroke-dasharray=\"7 5\"/>\n", SVG_LEFT,
            y, SVG_RIGHT);
    take(p, (box){ SVG_LEFT, y - 1.5, SVG_RIGHT - SVG_LEFT, 3 });
}

/* Its words: above or below, where along the line they cover least. */
static void plot_floor_words(plot *p)
{
    enum { ROOM = 412 };
    box best = { 0, 0, 0, 0 };
    double least = HUGE_VAL;
    for (int k = 0; k < 40; ++k) {
        const box b = { SVG_RIGHT - ROOM - (k / 2) * (SVG_RIGHT - SVG_LEFT - ROOM) / 19.0,
                        svg_y(&p->scale, p->floor) + (k % 2 ? 5 : -21), ROOM, 16 };
        const double outside = b.y < SVG_TOP || b.y + b.h > SVG_BOTTOM ? 1e5 : 0,
                     cost = covered(&b, p->taken, p->boxes) + k + outside;
        if (cost < least) { least = cost; best = b; }
    }
    fprintf(p->f,
            "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" fill=\"#222\" stroke=\"#fff\" stroke-width=\"3\" "
            "paint-order=\"stroke\">floor %.3f: exact answer from one depth layer, as thin sheets</text>\n",
            best.x + best.w / 2, best.y + 12.5, p->floor);
    take(p, best);
}

/* ---- >>points ---------------------------------------------------------------------------------------------------- */

/* The Pareto front: what no other point beats. */
static void plot_front(plot *p)
{
    const row *front[MOST_POINTS];
    double least = HUGE_VAL;
    memcpy(front, p->point, (size_t)p->points * sizeof *front);
    qsort(front, (size_t)p->points, sizeof *front, by_relative);
    fputs("<path fill=\"none\" stroke=\"#dedede\" stroke-width=\"15\" stroke-linejoin=\"round\" "
          "stroke-linecap=\"round\" d=\"",
          p->f);
    for (int i = 0; i < p->points; ++i) {
        if (!(front[i]->share < least)) continue;
        fprintf(p->f, "%c%.1f %.1f", least < HUGE_VAL ? 'L' : 'M', svg_x(&p->scale, front[i]->relative),
                svg_y(&p->scale, front[i]->share));
        least = front[i]->share;
    }
    fputs("\"/>\n", p->f);
}

/* A curve's line through points from .. to - 1; takes the boxes of markers and line, for words to avoid. */
static void plot_line(plot *p, int from, int to, int series)
{
    double x0 = 0, y0 = 0;
    fprintf(p->f, "<path fill=\"none\" stroke-width=\"2.5\" stroke-linejoin=\"round\" stroke=\"%s\"%s d=\"",
            colour_of(p, series), series < p->others ? "" : " stroke-dasharray=\"6 4\"");
    for (int k = from; k < to; ++k) {
        const double x = svg_x(&p->scale, p->point[k]->relative), y = svg_y(&p->scale, p->point[k]->share);
        fprintf(p->f, "%c%.1f %.1f", k > from ? 'L' : 'M', x, y);
        take(p, (box){ x - 8, y - 8, 16, 16 });
        for (int j = 1; k > from && j < 12; ++j) {
            const double t = j / 12.0;
            take(p, (box){ x0 + (x - x0) * t - 3, y0 + (y - y0) * t - 3, 6, 6 });
        }
        x0 = x;
        y0 = y;
    }
    fputs("\"/>\n", p->f);
}

/* Curves, and their names in lines above the frame. */
static void plot_curves(plot *p)
{
    int legend = SVG_LEFT, line = 76;
    for (int i = 0, to = 0, series = 0; i < p->points; i = to, ++series) {
        const row *first = p->point[i];
        for (to = i; to < p->points && !strcmp(p->point[to]->label, first->label);) ++to;
        qsort(p->point + i, (size_t)(to - i), sizeof *p->point, by_relative);
        first = p->point[i];
        if (!series || !(first->of & OF_PEER) || isnan(first->figure[FITTED])) p->others = series + 1;
        plot_line(p, i, to, series);
        const char *fitted = series < p->others ? "" : ", fitted";
        const int room = 32 + (int)(6.8 * (double)(strlen(first->label) + strlen(fitted)));
        if (legend > SVG_LEFT && legend + room > SVG_RIGHT) { legend = SVG_LEFT; line += 17; }
        fputs("<path ", p->f);
        svg_marker(p->f, series, colour_of(p, series), legend + 7, line);
        fprintf(p->f, "/><text x=\"%d\" y=\"%.1f\" fill=\"#222\">", legend + 21, line + 4.5);
        page_escaped(p->f, first->label);
        fprintf(p->f, "%s</text>\n", fitted);
        legend += room;
    }
}

/* A marker and its tooltip. */
static void plot_point(const plot *p, const row *r, int series)
{
    fputs("<path ", p->f);
    svg_marker(p->f, series, colour_of(p, series), svg_x(&p->scale, r->relative), svg_y(&p->scale, r->share));
    fputs("><title>", p->f);
    page_escaped(p->f, r->label);
    fputs(": ", p->f);
    page_escaped(p->f, table_settings(r));
    fprintf(p->f, "\n%s %.2f, error %.3f", p->words->relative, r->relative, r->share);
    if (p->words->fetches) fprintf(p->f, ", %.1f %s", r->fetches, p->words->fetches);
    fputs("</title></path>\n", p->f);
}

/* The number beside a marker. */
static void plot_number(plot *p, const row *r, int series)
{
    char text[32];
    const int n = snprintf(text, sizeof text, r->fetches < 100 ? "%.3g" : "%.0f", r->fetches);
    const box b = place(svg_x(&p->scale, r->relative), svg_y(&p->scale, r->share), 7.2 * n, p->taken, p->boxes);
    fprintf(p->f,
            "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" font-size=\"12\" fill=\"%s\" "
            "stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\">%s</text>\n",
            b.x + b.w / 2, b.y + 10.5, colour_of(p, series), text);
    take(p, b);
}

/* All markers, then all numbers: these lie on top. */
static void plot_points(plot *p)
{
    for (int pass = 0; pass < (p->words->fetches ? 2 : 1); ++pass)
        for (int i = 0, series = 0; i < p->points; ++i) {
            if (i && strcmp(p->point[i]->label, p->point[i - 1]->label)) ++series;
            if (pass) plot_number(p, p->point[i], series);
            else plot_point(p, p->point[i], series);
        }
}

static void scatter_svg(FILE *f, const char *title, const words *w, const row *rows, int count, double floor_)
{
    static plot p;
    memset(&p, 0, sizeof p);
    p.f = f;
    p.words = w;
    p.floor = floor_;
    plot_scale(&p, rows, count);
    plot_frame(&p, title);
    if (!isnan(floor_)) plot_floor(&p);
    if (!w->even) plot_front(&p);
    plot_curves(&p);
    if (!isnan(floor_)) plot_floor_words(&p);
    plot_points(&p);
    fputs("</svg>\n", f);
}

int scatter_chart(FILE *html, const char *out, const char *name, const char *title, const words *w, const row *rows,
                  int count, double floor_, kit_error *err)
{
    page p;
    if (page_open(&p, err)) return -1;
    scatter_svg(p.file, title, w, rows, count, floor_);
    fflush(p.file);
    fwrite(p.text, 1, p.size, html);
    return page_close(&p, out, name, err);
}
