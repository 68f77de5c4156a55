/* stability.c - the page on where methods fail: the worst of each sweep. Declared in sections.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/figures/sections.h"

typedef struct named { const char *cause, *title; } named;
static const named sweeps[] = {
    { "tilt", "view tilt to 89 degrees, a bare plane" },
    { "tilt-wall", "the same, a wall beside it" },
    { "pole", "a pole 20 to 0.1 pixels thick, a wall four radii behind" },
    { "rail", "a rail as thin, half a radius over a floor" },
    { "halo", "a wall 0.1 to 30 radii behind an edge" },
    { "slot", "a wall through a slot of 0.2 to 3.2 radii between two sheets" },
    { "radius", "radius 0.1 to 240 pixels (of 240x135)" },
    { "off-screen", "a box slides off the screen" },
    { "turned-off", "the same as the camera turns 0.25 to 8 pixels a frame: second difference" },
    { "hidden", "a box slides behind another" },
    { "near-plane", "a box crosses the near plane" },
    { "depth-16f", "16-bit float view depth: good to" },
    { "depth-24", "24-bit window depth: good to" },
    { "depth-32f", "32-bit float window depth: good to" },
    { "depth-reversed", "reversed 32-bit float depth: good to" },
    { "camera", "camera sideways, 0.1 to 4 pixels a frame: deviation" },
    { "dolly", "camera forward, 0.1 to 3 % a frame: deviation" },
    { "light", "a sun turns 0.25 to 8 degrees a frame: second difference" },
    { "rotation", "an object turns as much: the same, raw" },
    { "resolution", "160x90 to 3840x2160, constant angular radius" }
};
/* of what is averaged over frames */
static const named kept[] = {
    { "kept-camera", "camera sideways, 0 to 4 pixels a frame" },
    { "kept-dolly", "camera forward, 0.1 to 1 %" },
    { "kept-roll", "camera rolls, 0.1 to 1 degree" },
    { "kept-slide", "a box slides, 0.1 to 4 pixels" },
    { "kept-slide-told", "with motion vectors: a box slides, 0.1 to 4 pixels" },
    { "kept-appear", "a box appears" },
    { "kept-jump", "a box is elsewhere at once" },
    { "kept-cut", "a cut that nobody tells of" },
    { "kept-newly", "1 to 8 pixels: what is newly seen alone" },
    { "kept-light", "a sun turns, 0 to 8 degrees" },
    { "kept-trail-appear", "visibility left of what was: a box appears" },
    { "kept-trail-jump", "the same: a box is elsewhere at once" },
    { "kept-held-appear", "share of pixels that hold more than 0.05 of it, 320x180: a box appears" },
    { "kept-held-jump", "the same: a box is elsewhere at once" },
    { "kept-held-appear-told", "with motion vectors: a box appears" },
    { "kept-held-jump-told", "with motion vectors: a box is elsewhere at once" },
    { "kept-flicker", "deviation over the truth's, 0.1 to 1 pixel a frame" }
};
static const char *const sweep_methods[] = { "ssao", "hsao-fast", "hsao", "hsao-back", "hsao-best", "hsao-march",
    "ssdo", "s3ho", "ssbn", "dss", "dss-lit", "aof" };
static const char *const kept_methods[] = { "hsao-fast-history", "hsao-history", "hsao-2x10-history", "ssdo-history",
    "ssdo-fast-history" };
#define COUNT(table) ((int)(sizeof (table) / sizeof (table)[0]))

/* The number of a method for the cause that begins at row; NULL: there is none. */
static const char *number_at(const csv *c, int row, const char *method)
{
    for (int i = row; i < c->rows && csv_same(c, i, row, "cause"); ++i)
        if (!strcmp(csv_text(c, i, "method"), method)) return csv_text(c, i, "number");
    return NULL;
}

static int is_known(const char *number) { return number && *number && strcmp(number, "nan"); }

static const char *title_of(const named *table, int count, const char *cause)
{
    for (int k = 0; k < count; ++k) if (!strcmp(table[k].cause, cause)) return table[k].title;
    return cause;
}

/* Of which kind the cause that begins at row is. */
enum { INSIDE, OF_METHODS, OVER_FRAMES, OF_MATHS };
static int kind_of(const csv *c, int row)
{
    if (row && csv_same(c, row, row - 1, "cause")) return INSIDE;
    if (!strncmp(csv_text(c, row, "cause"), "kept-", strlen("kept-"))) return OVER_FRAMES;
    for (int k = 0; k < COUNT(sweep_methods); ++k) if (number_at(c, row, sweep_methods[k])) return OF_METHODS;
    return OF_MATHS;
}

static void heads(const markdown *m, const char *const *methods, int count, const char *last)
{
    fputs("| cause |", m->file);
    for (int k = 0; k < count; ++k) fprintf(m->file, " %s |", methods[k]);
    fprintf(m->file, "%s\n", last);
    markdown_ruler(m, count + 1 + (*last != 0));
}

static void methods_table(const markdown *m, const csv *c)
{
    static const char *const besides[] = { "no AO", "truth", "open" };
    markdown_heading(m, "The worst of each sweep",
                     "RMSE of ambient visibility unless the row says otherwise; 240x135, `dss` "
                     "with `size` 0.03. Good to: the greatest depth at which\n"
                     "RMSE stays below 0.02, near plane 0.1. Deviation: of a place over the frames after true "
                     "reprojection, less the truth's.\n"
                     "Beside: no AO at all, the truth's own flicker, or open ground.",
                     m->stability_note);
    heads(m, sweep_methods, COUNT(sweep_methods), " beside |");
    for (int i = 0; i < c->rows; ++i) {
        const char *beside = NULL;
        if (kind_of(c, i) != OF_METHODS) continue;
        fprintf(m->file, "| %s |", title_of(sweeps, COUNT(sweeps), csv_text(c, i, "cause")));
        for (int k = 0; k < COUNT(besides) && !beside; ++k) beside = number_at(c, i, besides[k]);
        for (int k = 0; k <= COUNT(sweep_methods); ++k) {
            const char *t = k < COUNT(sweep_methods) ? number_at(c, i, sweep_methods[k]) : beside;
            const double v = is_known(t) ? atof(t) : (double)NAN;
            markdown_number(m, v, !(v < 1) || v < 5e-5 ? 0 : v < 0.03 ? 4 : 3, 0);
        }
        fputc('\n', m->file);
    }
}

static void frames_table(const markdown *m, const csv *c)
{
    int begun = 0;
    for (int i = 0; i < c->rows; ++i) {
        const char *cause = csv_text(c, i, "cause");
        const int absolute = !strncmp(cause, "kept-trail", 10) || !strncmp(cause, "kept-held", 9)
            || !strcmp(cause, "kept-flicker");
        if (kind_of(c, i) != OVER_FRAMES) continue;
        if (!begun++) {
            markdown_heading(m, "Over frames",
                             "`history = 1`; the worst of each sweep: error over that of the frame alone, in any of "
                             "16\nframes (after a change: 1 to 8 frames later); 160x90. Below 1 history pays. "
                             "Visibility, shares and deviation are\nabsolute.",
                             m->stability_note);
            heads(m, kept_methods, COUNT(kept_methods), "");
        }
        fprintf(m->file, "| %s |", title_of(kept, COUNT(kept), cause));
        for (int k = 0; k < COUNT(kept_methods); ++k) {
            const char *t = number_at(c, i, kept_methods[k]);
            markdown_number(m, is_known(t) ? atof(t) : (double)NAN, absolute ? 4 : 2, 0);
        }
        fputc('\n', m->file);
    }
}

static void maths_table(const markdown *m, const csv *c)
{
    int begun = 0;
    for (int i = 0; i < c->rows; ++i) {
        if (kind_of(c, i) != OF_MATHS) continue;
        if (!begun++) {
            markdown_heading(m, "The library's maths alone",
                             "Worst of each sweep: most negative irradiance of a sun as harmonics, over what faces "
                             "it; largest error and step of occlusion along\n"
                             "a line through a field's hull; largest change of the number of surfels in a step of "
                             "1 % of the distance.",
                             m->stability_note);
            fputs("| cause | curve | worst |\n|---|---|---|\n", m->file);
        }
        for (int k = i; k < c->rows && csv_same(c, k, i, "cause"); ++k) {
            const char *t = csv_text(c, k, "number");
            if ((k > i && csv_same(c, k, k - 1, "method")) || !is_known(t)) continue;
            fprintf(m->file, "| %s | %s |", csv_text(c, k, "cause"), csv_text(c, k, "method"));
            markdown_number(m, atof(t), 4, 0);
            fputc('\n', m->file);
        }
    }
}

void section_stability(const markdown *m)
{
    const csv c = csv_read("stability.csv");
    if (!c.rows) return;
    fputs(STABILITY_HEADING, m->file);
    methods_table(m, &c);
    frames_table(m, &c);
    maths_table(m, &c);
}
