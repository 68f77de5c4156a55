/* panel.c - draws text over the image: the methods, their passes with times, the last action, the keys. */
#include "viewer.h"
#include <math.h>
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_easy_font.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

static const char text_vs[] =
    "layout(location = 0) in vec3 a_at; uniform vec4 place; // scale, and pixels to the screen\n"
    "void main() { gl_Position = vec4(a_at.xy * place.x * place.yz * 2.0 + vec2(-1.0, 1.0), 0.0, 1.0); }\n";
static const char text_fs[] = "uniform vec4 colour; out vec4 o;\nvoid main() { o = colour; }\n";

enum { QUADS = 1 << 13, LINE = 12 };

int panel_open(viewer *v)
{
    v->text = kit_program_text("", text_vs, text_fs, &v->err);
    glGenBuffers(1, &v->glyphs);
    return v->text ? 0 : -1;
}

void panel_say(viewer *v, const char *text)
{
    snprintf(v->note, sizeof v->note, "%.1190s", text);
    v->noted = kit_seconds();
    v->redraw = 1;
}

int panel_says(const viewer *v) { return v->noted > 0 && kit_seconds() < v->noted + 5; }

/* ---- >>text ------------------------------------------------------------------------------------------------------ */

typedef struct corner {
    float at[3];
    unsigned char colour[4];
} corner; /* stb_easy_font's */

/* Makes quads of four corners for a text's characters and returns their number. A tab continues at the next tab stop;
   size: that of the box around the text. */
static int lay_out(float size[2], corner *quads, int room, float x, float y, const char *text)
{
    enum { STOP = 64 };

    float column = 0;
    int count = 0;
    size[0] = 0;
    size[1] = LINE - 2;
    while (*text) {
        char piece[200];
        const size_t all = strcspn(text, "\t\n"), n = all < sizeof piece ? all : sizeof piece - 1;
        memcpy(piece, text, n);
        piece[n] = 0;
        text += n;
        if (n)
            count += stb_easy_font_print(x + column, y + size[1] - LINE + 2, piece, NULL, quads + 4 * count,
                                         (int)sizeof(corner) * 4 * (room - count));
        column += (float)stb_easy_font_width(piece);
        size[0] = fmaxf(size[0], column);
        if (*text == '\t') {
            column = STOP * (floorf(column / STOP) + 1);
            ++text;
        } else if (*text == '\n') {
            column = 0;
            size[1] += LINE;
            ++text;
        }
    }
    return count;
}

/* Draws quads as triangles, in one colour. */
static void draw_quads(viewer *v, const corner *quads, int count, const float colour[4])
{
    static float triangles[18 * QUADS];
    kit_soup soup;
    for (int i = 0; i < 6 * count; ++i)
        memcpy(triangles + 3 * i, quads[i / 6 * 4 + (const int[]){ 0, 1, 2, 0, 2, 3 }[i % 6]].at, 3 * sizeof(float));
    kit_soup_open(&soup, triangles, 6 * (size_t)count, 1);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(v->text);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glUniform4fv(glGetUniformLocation(v->text, "colour"), 1, colour);
    glDrawArrays(GL_TRIANGLES, 0, 6 * count);
    glDisable(GL_BLEND);
    kit_soup_close(&soup);
}

/* Returns the scale of text: if possible, the list of keys fits one column. */
static float scale_of(const viewer *v) { return v->help ? v->size[1] >= 700 ? 1.5f : 1 : v->size[1] >= 500 ? 2 : 1; }

/* Prints a text at x, y, or shifted if it would leave the window; x, y may be any numbers. Returns the y above it. */
static float print(viewer *v, float x, float y, const char *text)
{
    static corner quads[4 * QUADS];
    static const float ink[4] = { 1, 1, 1, 1 }, ground[4] = { 0, 0, 0, 0.66f };
    const float scale = scale_of(v), pad = 4;
    const float most[2] = { (float)v->size[0] / scale - 8, (float)v->size[1] / scale - 8 };
    const float place[4] = { scale, 1 / (float)v->size[0], -1 / (float)v->size[1], 0 };
    float size[2];
    lay_out(size, quads, QUADS, 0, 0, text);
    x = fmaxf(8, floorf(fminf(x, most[0] - size[0])));
    y = fmaxf(8, floorf(fminf(y, most[1] - size[1])));
    const float right = x + size[0] + pad, end = y + size[1] + pad;
    const corner box[4] = { { { x - pad, y - pad, 0 }, { 0 } },
                            { { right, y - pad, 0 }, { 0 } },
                            { { right, end, 0 }, { 0 } },
                            { { x - pad, end, 0 }, { 0 } } };
    const int count = lay_out(size, quads, QUADS, x, y, text);
    glUseProgram(v->text);
    glUniform4fv(glGetUniformLocation(v->text, "place"), 1, place);
    draw_quads(v, box, 1, ground);
    draw_quads(v, quads, count, ink);
    return y - 2 * pad;
}

/* Wraps lines to the window's width, at blanks if there are any. */
static void wrap(char *out, size_t size, const char *text, float width)
{
    char line[256];
    size_t used = 0, n = 0, blank = 0;
    for (; *text && used + 2 < size; ++text) {
        line[n++] = *text;
        line[n] = 0;
        if (*text == ' ') blank = used + 1;
        out[used++] = *text;
        if (n + 1 < sizeof line && (float)stb_easy_font_width(line) < width) continue;
        if (blank) {
            out[blank - 1] = '\n';
            n = used - blank;
            memcpy(line, out + blank, n);
            blank = 0;
        } else {
            out[used++] = '\n';
            n = 0;
        }
    }
    out[used] = 0;
}

/* ---- >>what it says ---------------------------------------------------------------------------------------------- */

#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
static void
add(char *text, size_t size, const char *format, ...)
{
    const size_t at = strlen(text);
    va_list list;
    va_start(list, format);
    vsnprintf(text + at, size - at, format, list);
    va_end(list);
}

/* Lists passes with their times; successive passes of one kind are one line. */
static void describe_passes(char *text, size_t size, const kit_run *run)
{
    const int digits = kit_gl_is_software() ? 0 : 3;
    double all = 0;
    for (int i = 0, next; i < run->passes; i = next) {
        const kit_pass *p = &run->pass[i];
        double ms = 0;
        for (next = i; next < run->passes && run->pass[next].desc.pass == p->desc.pass; ++next)
            ms += run->pass[next].ms;
        all += ms;
        add(text, size, "\n%s", ssgi_gl_pass_name(p->desc.pass));
        if (next - i > 1) add(text, size, " x %d", next - i);
        add(text, size, "\t%dx%d\t%.*f ms", p->width, p->height, digits, ms);
    }
    add(text, size, "\nall passes\t\t%.*f ms", digits, all);
}

static void describe(char *text, size_t size, const viewer *v, const side *s)
{
    if (s->truth) {
        add(text, size, "ray-traced truth\n%d rays a pixel: %.0f %%", v->shown.tracing, (double)v->shown.share * 100);
        return;
    }
    add(text, size, "%s", s->method.name);
    if (v->error && !isnan(s->error)) add(text, size, "   RMSE %.4f%s", s->error, s->method.lit ? " of the mean" : "");
    if (*s->failed.text) add(text, size, "\nnot drawn");
    else if (s->frames.now) describe_passes(text, size, s->frames.now);
}

/* Writes the scene, the size, and the settings that differ from the method's defaults. */
static void describe_frame(char *text, size_t size, const viewer *v)
{
    const double about = v->scene.mesh.triangles < 100000 ? 1 : 1e-3;
    const char *slash = strrchr(v->path, '/');
    char set[300], size_by[80] = "";
    if (v->pace.fixed > 0) snprintf(size_by, sizeof size_by, "%s", v->pace.fixed < 1 ? ", fixed (f)" : "");
    else if (v->mean > 1) snprintf(size_by, sizeof size_by, ", the mean of %u frames", v->mean);
    else if (pace_share(&v->pace) < 1)
        snprintf(size_by, sizeof size_by, " while it moves, so that a frame takes 250 ms at most (f: fixed)");
    kit_method_text(set, sizeof set, &v->side[0].method);
    add(text, size, "%.60s, %.0f%s triangles, a frame %.0f ms: the scene and all passes%s",
        slash && slash[1] ? slash + 1 : v->path, (double)v->scene.mesh.triangles * about, about < 1 ? "k" : "", v->ms,
        kit_gl_is_software() ? ", drawn by the CPU" : "");
    add(text, size, "\n%dx%d%s\nradius %.3g%s%s\nh: keys", v->drawn[0], v->drawn[1], size_by, (double)v->radius,
        *set ? ", " : "", set);
}

/* Writes the list of keys in as few columns as the window's height allows, at its left side, so that the middle stays
   visible. */
static void describe_keys(char *text, size_t size, const viewer *v)
{
    static const char *const mouse[][2] = { { "drag", "orbit; right drag: pan; wheel: zoom" },
                                            { "drop", "a model, or .hdr .exr as the sky" } };

    enum { MOUSE = (int)(sizeof mouse / sizeof *mouse), STOPS = 4 };

    const int room = (int)fmaxf(1, ((float)v->size[1] / scale_of(v) - 16) / LINE);
    int count = MOUSE;
    while (keys[count - MOUSE].code) ++count;
    const int columns = (count + room - 1) / room, rows = (count + columns - 1) / columns;
    for (int i = 0; i < rows; ++i)
        for (int k = i; k < count; k += rows) {
            const char *label = k < MOUSE ? mouse[k][0] : keys[k - MOUSE].label;
            const char *about = k < MOUSE ? mouse[k][1] : keys[k - MOUSE].about;
            add(text, size, "%s%s\t%s", k == i && i ? "\n" : "", label, about);
            const int stops = k + rows < count ? stb_easy_font_width((char *)(size_t)about) / 64 : STOPS;
            for (int stop = stops; stop < STOPS; ++stop) add(text, size, "\t");
        }
}

void panel_draw(viewer *v)
{
    const float width = (float)v->size[0] / scale_of(v);
    char text[4096] = "", note[sizeof v->note + 100];
    float floor_ = 1e6f;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, v->size[0], v->size[1]);
    if (v->help) {
        describe_keys(text, sizeof text, v);
        print(v, 0, 0, text);
    } else if (v->panel) {
        describe(text, sizeof text, v, &v->side[0]);
        print(v, 0, 0, text);
        *text = 0;
        if (v->split_on) {
            describe(text, sizeof text, v, &v->side[1]);
            print(v, v->split * width + 8, 0, text);
            *text = 0;
        }
        describe_frame(text, sizeof text, v);
        floor_ = print(v, 0, floor_, text);
    }
    if (!panel_says(v)) return;
    wrap(note, sizeof note, v->note, width - 24);
    int lines = 1;
    for (const char *c = note; *c; ++c) lines += *c == '\n';
    print(v, 0, floor_ - (float)(LINE * lines), note);
}
