/* panel.c - text over the picture: what is drawn, its passes with their GPU times, the keys. */
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
    "#version 330 core\n"
    "layout(location = 0) in vec3 a_at; uniform vec4 place; // scale, and pixels to the screen\n"
    "void main() { gl_Position = vec4(a_at.xy * place.x * place.yz * 2.0 + vec2(-1.0, 1.0), 0.0, 1.0); }\n";
static const char text_fs[] = "#version 330 core\nuniform vec4 colour; out vec4 o;\nvoid main() { o = colour; }\n";

/* The quads that text is drawn by, and the program. */
int panel_open(viewer *v)
{
    enum { QUADS = 8192 };
    GLuint *index = malloc(QUADS * 6 * sizeof *index), buffers[2];
    if (!index) return kit_fail(&v->err, "out of memory");
    for (GLuint i = 0; i < QUADS * 6; ++i) index[i] = i / 6 * 4 + (const GLuint[]){ 0, 1, 2, 0, 2, 3 }[i % 6];
    v->text = gl_program(text_vs, text_fs, &v->err);
    glGenVertexArrays(1, &v->quads);
    glBindVertexArray(v->quads);
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, QUADS * 6 * (GLsizeiptr)sizeof *index, index, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 16, NULL);
    glEnableVertexAttribArray(0);
    free(index);
    return v->text ? 0 : -1;
}

void panel_say(viewer *v, const char *text)
{
    snprintf(v->note, sizeof v->note, "%.240s", text);
    v->noted = kit_seconds();
}

static const char keys[] =
    "drag\torbit\t\tright drag\tpan\n"
    "wheel\tzoom\t\tr\tcamera back\n"
    "m  M\tmethod: left, right half\n"
    "p  P\tpreset: left, right half\n"
    "s\tsplit: off, a method, the truth\n"
    "arrows\tmove the split\n"
    "b\tbehind surfaces: width for slices, constant, solid, width, back faces, slabs\n"
    "[  ]\tradius\t\tt\thistory\n"
    "n\tnormals: given, from depth\n"
    "e\terror to the truth\n"
    "c\tvisibility on the scene's colours\n"
    "o\tPNG of the window\n"
    "x\tEXR of the left half\n"
    "g\tpanel\t\th\tthese keys\n"
    "q\tquit";

/* Text in quads of 64 bytes: how many. A tab goes on at the next stop; size: of the box around all. */
static int lay_out(float size[2], char *quads, size_t room, float x, float y, const char *text)
{
    enum { STOP = 64, LINE = 12 };
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
        if (n) count += stb_easy_font_print(x + column, y + size[1] - LINE + 2, piece, NULL, quads + 64 * (size_t)count,
                                            (int)(room - 64 * (size_t)count));
        column += (float)stb_easy_font_width(piece);
        size[0] = fmaxf(size[0], column);
        if (*text == '\t') { column = STOP * (floorf(column / STOP) + 1); ++text; }
        else if (*text == '\n') { column = 0; size[1] += LINE; ++text; }
    }
    return count;
}

/* At a corner, or beside it so that it ends in the window: x, y may be as large as they please. */
static void print(viewer *v, float x, float y, float scale, const char *text)
{
    static char quads[1 << 19];
    static const float ink[4] = { 1, 1, 1, 1 }, ground[4] = { 0, 0, 0, 0.66f };
    const float most[2] = { (float)v->camera.width / scale - 8, (float)v->camera.height / scale - 8 }, pad = 4;
    float size[2];
    lay_out(size, quads, sizeof quads, 0, 0, text);
    x = fmaxf(8, floorf(fminf(x, most[0] - size[0])));
    y = fmaxf(8, floorf(fminf(y, most[1] - size[1])));
    const float right = x + size[0] + pad, end = y + size[1] + pad;
    const float box[4][4] = { { x - pad, y - pad }, { right, y - pad }, { right, end }, { x - pad, end } };
    const int count = lay_out(size, quads + sizeof box, sizeof quads - sizeof box, x, y, text);
    memcpy(quads, box, sizeof box);
    glBindVertexArray(v->quads);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)sizeof box * (count + 1), quads, GL_STREAM_DRAW);
    glUseProgram(v->text);
    glUniform4f(glGetUniformLocation(v->text, "place"), scale, 1 / (float)v->camera.width,
                -1 / (float)v->camera.height, 0);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glUniform4fv(glGetUniformLocation(v->text, "colour"), 1, ground);
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, NULL);
    glUniform4fv(glGetUniformLocation(v->text, "colour"), 1, ink);
    glDrawElements(GL_TRIANGLES, 6 * count, GL_UNSIGNED_INT, (const void *)(6 * sizeof(GLuint)));
    glDisable(GL_BLEND);
}

#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
static void add(char *text, size_t size, const char *format, ...)
{
    const size_t at = strlen(text);
    va_list list;
    va_start(list, format);
    vsnprintf(text + at, size - at, format, list);
    va_end(list);
}

static void describe(char *text, size_t size, const viewer *v, const half *h)
{
    double all = 0;
    if (h->method == TRUTH) {
        add(text, size, "ray-traced truth\n%d rays a pixel: %.0f %%", v->shown.tracing, (double)v->shown.share * 100);
        return;
    }
    add(text, size, "%s, %s", methods[h->method].name, presets[h->preset]);
    if (v->error && !isnan(h->error)) add(text, size, "   RMSE %.4f%s", h->error, v->truth.lit ? " of the mean" : "");
    for (int i = 0; i < h->chain.steps; ++i) {
        const ssgi_gl_step *s = &h->chain.step[i];
        all += h->chain.time[i].ms;
        add(text, size, "\n%s\t%dx%d\t%.*f ms", ssgi_gl_pass_name(s->desc.pass), s->width, s->height,
            gl_software ? 0 : 3, h->chain.time[i].ms);
    }
    add(text, size, "\nall\t\t%.*f ms", gl_software ? 0 : 3, all);
}

void panel_draw(viewer *v)
{
    const float scale = v->camera.height >= 500 ? 2 : 1, width = (float)v->camera.width / scale;
    const double about = v->scene.mesh.triangles < 100000 ? 1 : 1e-3;
    const char *slash = strrchr(v->scene.name, '/');
    char text[4096] = "";
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, v->camera.width, v->camera.height);
    if (v->panel) {
        describe(text, sizeof text, v, &v->half[0]);
        print(v, 0, 0, scale, text);
        *text = 0;
        if (v->split_on) {
            describe(text, sizeof text, v, &v->half[1]);
            print(v, v->split * width + 8, 0, scale, text);
            *text = 0;
        }
        add(text, sizeof text, "%s, %.0f%s triangles, %dx%d, G-buffer %.2f ms%s",
            slash ? slash + 1 : v->scene.name, (double)v->scene.mesh.triangles * about, about < 1 ? "k" : "",
            v->camera.width, v->camera.height, v->gbuffer.time.ms, gl_software ? ", drawn by the CPU" : "");
        add(text, sizeof text, "\nradius %.3g, behind: %s", (double)v->radius, behinds[v->behind]);
        if (v->behind >= SSGI_GL_THICKNESS_BACK) add(text, sizeof text, " (%.2f ms)", v->gbuffer.slab_time.ms);
        add(text, sizeof text, "%s%s", v->history ? ", history" : "", v->from_depth ? ", normals from depth" : "");
        if (v->noted > 0 && kit_seconds() < v->noted + 4) add(text, sizeof text, "   %s", v->note);
        else add(text, sizeof text, "   h: keys");
        if (!v->help) print(v, 0, 1e6f, scale, text);
    }
    if (v->help) print(v, 0.5f * width - 230, 0.35f * (float)v->camera.height / scale, scale, keys);
}
