/* show.c - what sweeps become: charts, tables, pictures of the worst frames. Declared in show.h. */
#include "lab/stability/show.h"
#include <math.h>
#include <string.h>
#include "lab/page/page.h"
#include "lab/page/svg.h"

#define OF_ALONE "error over that of the frame alone"
#define DIFFERENCE "method, truth, difference (full colour: 0.5)"
/* What the number of a cause is, what its chart shows, and what stands beside a picture. */
static const struct { const char *number, *up, *shown; } kinds[] = {
    [ERROR] = { "largest RMSE to the truth", "RMSE to the truth", DIFFERENCE },
    [PRECISION] = { "greatest depth up to which RMSE stays within 0.02", "RMSE to the picture with exact depth",
                    "with this depth, with exact depth, difference (full colour: 0.5)" },
    [DEVIATION] = { "largest deviation over frames, less the truth's", "deviation over frames",
                    "method, truth, deviation over frames (full colour: 0.05)" },
    [SECOND] = { "largest second difference over frames", "second difference over frames, as deviation",
                 "method, truth, second difference (full colour: 0.05)" },
    [LIT_SECOND] = { "largest second difference, less an open surface's, over the mean",
                     "second difference over frames, over the mean",
                     "method, open surface (both times 0.4), second difference (full colour: 0.05)" },
    [FOLLOWS] = { "largest " OF_ALONE, OF_ALONE, DIFFERENCE },
    [AFTER] = { "largest " OF_ALONE, OF_ALONE, DIFFERENCE },
    [NEWLY] = { "largest error of what is newly seen over that of the frame alone",
                "error of what is newly seen over that of the frame alone", DIFFERENCE },
    [TRAIL] = { "most of what was that is left", "what was before and is still seen, of ambient visibility",
                DIFFERENCE },
    [HELD] = { "most pixels, a share of all, that hold more than 0.05 of what was",
               "pixels that hold more than 0.05 of what was, a share of all", DIFFERENCE }
};

static const char *settings_of(const curve *c) { return c->method < 0 ? "" : sweeps_method[c->method].settings; }

/* ---- >>chart ----------------------------------------------------------------------------------------------------- */

typedef struct lines { FILE *f; const result *r; scale scale; double step, lowest, highest; } lines;

/* What the frame holds: all curves, with some room at the sides, whole steps up. */
static void lines_scale(lines *l)
{
    const result *r = l->r;
    const int logarithmic = r->cause->log;
    scale s = { HUGE_VAL, -HUGE_VAL, 0, 0, !logarithmic };
    for (int k = 0; k < r->points; ++k) {
        s.x0 = fmin(s.x0, r->x[k]);
        s.x1 = fmax(s.x1, r->x[k]);
        for (int i = 0; i < r->curves; ++i)
            if (!isnan(r->curve[i].y[k])) {
                s.y0 = fmin(s.y0, r->curve[i].y[k]);
                s.y1 = fmax(s.y1, r->curve[i].y[k]);
            }
    }
    l->lowest = s.x0;
    l->highest = s.x1;
    l->step = svg_step(1e-5, fmax(s.y1 - s.y0, 1e-4));
    const double room = 0.03 * (logarithmic ? log(s.x1 / s.x0) : s.x1 - s.x0);
    s.x0 = (logarithmic ? log(s.x0) : s.x0) - room;
    s.x1 = (logarithmic ? log(s.x1) : s.x1) + room;
    s.y0 = l->step * floor(s.y0 / l->step);
    s.y1 = l->step * ceil(s.y1 / l->step + 0.05);
    l->scale = s;
}

static void lines_frame(const lines *l)
{
    static const double ticks[3] = { 1, 2, 5 };
    const scale *s = &l->scale;
    const cause *c = l->r->cause;
    const double every = svg_step(0.001, l->highest - l->lowest);
    double last = -100;
    svg_begin(l->f, c->title);
    for (double v = s->y0; v < s->y1 + l->step / 2; v += l->step) {
        const int zero = fabs(v) < l->step / 2;
        char number[32];
        snprintf(number, sizeof number, "%g", zero ? 0 : v);
        svg_level(l->f, s, v, zero ? "#888" : "#e4e4e4", number);
    }
    for (int k = -30; k < 60; ++k) {           /* decades' 1, 2 and 5, or multiples of a step */
        const double v = c->log ? ticks[(k + 30) % 3] * pow(10, (k + 30) / 3 - 10)
                                : every * (ceil(l->lowest / every) + k);
        if (v < l->lowest - 1e-3 * fabs(l->lowest) || v > l->highest + 1e-3 * fabs(l->highest)) continue;
        svg_tick(l->f, s, v, "#eeeeee");
        if (svg_x(s, v) - last < 44) continue;
        last = svg_x(s, v);
        svg_tick_number(l->f, s, v);
    }
    svg_axes(l->f, c->across, c->up ? c->up : kinds[c->kind].up, 20);
}

/* A curve's line, broken where nothing is known. */
static void lines_line(const lines *l, const curve *v, const char *style)
{
    char move = 'M';
    fprintf(l->f, "<path fill=\"none\" stroke-width=\"2\" stroke-linejoin=\"round\" stroke=\"%s\" d=\"", style);
    for (int k = 0; k < l->r->points; ++k) {
        if (isnan(v->y[k])) { move = 'M'; continue; }
        fprintf(l->f, "%c%.1f %.1f", move, svg_x(&l->scale, l->r->x[k]), svg_y(&l->scale, v->y[k]));
        move = 'L';
    }
    fputs("\"/>\n", l->f);
}

/* Its name at x, y above the frame, and markers: of many points each tenth. */
static void lines_curve(const lines *l, int i, double x, double y)
{
    const result *r = l->r;
    const curve *v = &r->curve[i];
    const int series = v->method >= 0 ? v->method : i, every = r->points <= 16 ? 1 : 10;
    const char *style = v->method == BESIDE ? "#333\" stroke-dasharray=\"6 4" : svg_colour(series);
    fprintf(l->f,
            "<text x=\"%.1f\" y=\"%.1f\" fill=\"#222\">%s</text>\n<path stroke-width=\"2\" stroke=\"%s\" d=\"M%.1f "
            "%.1fh16\"/>\n",
            x + 22, y + 4.5, v->label, style, x, y);
    lines_line(l, v, style);
    if (v->method == BESIDE) return;
    fputs("<path ", l->f);
    svg_marker(l->f, series, svg_colour(series), x + 8, y);
    fputs("/>\n", l->f);
    for (int k = 0; k < r->points; k += every) {
        if (isnan(v->y[k])) continue;
        fputs("<path ", l->f);
        svg_marker(l->f, series, svg_colour(series), svg_x(&l->scale, r->x[k]), svg_y(&l->scale, v->y[k]));
        fprintf(l->f, "><title>%s at %g: %.4f</title></path>\n", v->label, r->x[k], v->y[k]);
    }
}

static void lines_svg(FILE *f, const result *r)
{
    lines l = { .f = f, .r = r };
    double x = SVG_LEFT, y = 58;
    lines_scale(&l);
    lines_frame(&l);
    for (int i = 0; i < r->curves; ++i) {
        const double wide = 38 + 7.0 * (double)strlen(r->curve[i].label);
        if (x > SVG_LEFT && x + wide > SVG_RIGHT) { x = SVG_LEFT; y += 18; }
        lines_curve(&l, i, x, y);
        x += wide;
    }
    fputs("</svg>\n", f);
}

/* ---- >>page ------------------------------------------------------------------------------------------------------ */

/* The frame where a curve was worst. */
static int show_worst(FILE *html, const cause *c, const curve *v, const char *out, kit_error *err)
{
    char name[128], path[4096];
    if (!v->worst.data) return 0;
    snprintf(name, sizeof name, "stability-%s-%s.png", c->name, v->label);
    snprintf(path, sizeof path, "%s/%s", out, name);
    if (kit_png_write(&v->worst, "R,G,B", 0, path, err)) return -1;
    fprintf(html,
            "<figure><figcaption><b>%s</b><span>at %g: %s</span></figcaption><a href=\"%s\"><img src=\"%s\" "
            "width=\"%d\" height=\"%d\" alt=\"%s\"></a></figure>\n",
            v->label, v->at, kinds[c->kind].shown, name, name, v->worst.width, v->worst.height, v->label);
    return 0;
}

int show_cause(FILE *html, FILE *csv, const result *r, const char *out, kit_error *err)
{
    const cause *c = r->cause;
    char name[128];
    page p;
    if (page_open(&p, err)) return -1;
    lines_svg(p.file, r);
    fflush(p.file);
    fprintf(html, "<h2 id=\"%s\">%s</h2>\n<p>%s Beside each method: %s.</p>\n", c->name, c->title, c->about,
            c->number ? c->number : kinds[c->kind].number);
    fwrite(p.text, 1, p.size, html);
    snprintf(name, sizeof name, "stability-%s.svg", c->name);
    if (page_close(&p, out, name, err)) return -1;
    fputs("<div class=\"wide\"><table>\n<tr>", html);
    for (int i = 0; i < r->curves; ++i) fprintf(html, "<th>%s", r->curve[i].label);
    fputs("\n<tr>", html);
    for (int i = 0; i < r->curves; ++i)
        fprintf(html, isnan(r->curve[i].number) ? "<td>&ndash;" : "<td>%.4g", r->curve[i].number);
    fputs("\n</table></div>\n<details><summary>The worst frames</summary>\n<div class=\"grid\">\n", html);
    for (int i = 0; i < r->curves; ++i) {
        const curve *v = &r->curve[i];
        for (int k = 0; k < r->points; ++k)
            if (!isnan(v->y[k]))
                fprintf(csv, "%s,\"%s\",\"%s\",\"%s\",%.6g,%.6g,%.6g\n", c->name, c->across, v->label,
                        settings_of(v), r->x[k], v->y[k], v->number);
        if (show_worst(html, c, v, out, err)) return -1;
    }
    fputs("</div></details>\n", html);
    return 0;
}

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

/* The number of a method, or of what is beside them; "" if there is none. */
static const char *number_of(char text[32], const result *r, int method)
{
    *text = 0;
    for (int i = 0; i < r->curves; ++i)
        if (r->curve[i].method == method && !isnan(r->curve[i].number))
            snprintf(text, 32, r->cause->kind == PRECISION ? "%.0f" : "%.4f", r->curve[i].number);
    return text;
}

void show_table_html(FILE *f, const result *results, const int *shown)
{
    char text[32];
    fputs("<h2>One number a method and cause</h2>\n<div class=\"wide\"><table>\n<tr><th>cause", f);
    for (int m = 0; m < sweeps_methods; ++m) fprintf(f, "<th>%s", sweeps_method[m].label);
    fputs("<th>beside<th>what\n", f);
    for (int k = 0; k < sweeps_causes; ++k) {
        const cause *c = &sweeps_cause[k];
        if (!shown[k] || c->curves) continue;
        fprintf(f, "<tr><td><a href=\"#%s\">%s</a>", c->name, c->title);
        for (int m = 0; m <= sweeps_methods; ++m) {
            const char *number = number_of(text, &results[k], m < sweeps_methods ? m : BESIDE);
            fprintf(f, "<td>%s", *number ? number : "&ndash;");
        }
        fprintf(f, "<td>%s\n", kinds[c->kind].number);
    }
    fputs("</table></div>\n<div class=\"wide\"><table>\n", f);
    for (int k = 0; k < sweeps_causes; ++k) {
        const cause *c = &sweeps_cause[k];
        if (!shown[k] || !c->curves) continue;
        fprintf(f, "<tr><td><a href=\"#%s\">%s</a><td>%s", c->name, c->title, c->number);
        for (int i = 0; i < results[k].curves; ++i)
            if (!isnan(results[k].curve[i].number))
                fprintf(f, "<td>%s: %.4f", results[k].curve[i].label, results[k].curve[i].number);
        fputs("\n", f);
    }
    fputs("</table></div>\n", f);
}

void show_table_text(FILE *f, const result *results, const int *shown)
{
    char text[32];
    fputs("cause          ", f);
    for (int m = 0; m < sweeps_methods; ++m) fprintf(f, " %10s", sweeps_method[m].label);
    fputs("     beside\n", f);
    for (int k = 0; k < sweeps_causes; ++k) {
        if (!shown[k] || sweeps_cause[k].curves) continue;
        fprintf(f, "%-15s", sweeps_cause[k].name);
        for (int m = 0; m <= sweeps_methods; ++m) {
            const char *number = number_of(text, &results[k], m < sweeps_methods ? m : BESIDE);
            fprintf(f, " %10s", *number ? number : "-");
        }
        fputs("\n", f);
    }
    for (int k = 0; k < sweeps_causes; ++k) {
        if (!shown[k] || !sweeps_cause[k].curves) continue;
        fprintf(f, "%s, %s:", sweeps_cause[k].name, sweeps_cause[k].number);
        for (int i = 0; i < results[k].curves; ++i)
            if (!isnan(results[k].curve[i].number))
                fprintf(f, " %s %.4f;", results[k].curve[i].label, results[k].curve[i].number);
        fputs("\n", f);
    }
}
