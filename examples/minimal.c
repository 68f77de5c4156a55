/* minimal.c - a whole program, which writes ao.pgm: OSMesa gives the engine's context, its scene is a few boxes, and
   ssgi's part is between the lines of "====". It compiles at each call; examples/hosts compile once. cc
   examples/minimal.c -lOSMesa -lm && ./a.out or, without OSMesa (Mesa dropped it in 25.1), by EGL: -lEGL -lGL -lm */
#include <stdio.h>
#define GL_GLEXT_PROTOTYPES
#if __has_include(<GL/osmesa.h>)
#include <GL/osmesa.h>
static int open_context(void)
{
    static unsigned char screen[4];
    OSMesaContext context = OSMesaCreateContextExt(OSMESA_RGBA, 0, 0, 0, NULL);
    return context && OSMesaMakeCurrent(context, screen, GL_UNSIGNED_BYTE, 1, 1);
}
#else
#include <EGL/egl.h>
#include <EGL/eglext.h>
#include <GL/gl.h>
static int open_context(void)
{
    EGLDisplay display = eglGetPlatformDisplay(EGL_PLATFORM_SURFACELESS_MESA, NULL, NULL);
    return eglInitialize(display, NULL, NULL) && eglBindAPI(EGL_OPENGL_API)
           && eglMakeCurrent(display, NULL, NULL, eglCreateContext(display, NULL, NULL, NULL));
}
#endif
#include <GL/glext.h>
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../ssgi_gl.h"
enum { W = 960, H = 540 };
static const char *boxes_vs = "#version 330 core\nuniform mat4 projection; out vec3 normal;\nvoid main() {\n"
    "  int f = gl_VertexID / 6, k = gl_VertexID % 6, a = f / 2, c = k < 3 ? k : k - 2, i = gl_InstanceID;\n"
    "  vec2 q = vec2(c & 1, c >> 1) * 2.0 - 1.0; float s = float(f & 1) * 2.0 - 1.0;\n"
    "  vec3 p = a < 1 ? vec3(s, q) : a < 2 ? vec3(q.y, s, q.x) : vec3(q, s), r = fract(sin(vec3(i) * vec3(3, 5, 7)));\n"
    "  vec3 size = i == 0 ? vec3(20, 0.1, 20) : 0.15 + 0.4 * r, at = vec3(r.z * 8.0 - 4.0, size.y, r.x * 8.0 - 4.0);\n"
    "  mat3 tilt = mat3(1, 0, 0, 0, 0.9, 0.436, 0, -0.436, 0.9); normal = tilt * vec3(a == 0, a == 1, a == 2) * s;\n"
    "  if (i == 0) at = vec3(0); gl_Position = projection * vec4(tilt * (p * size + at - vec3(0, 2.5, 6)), 1);\n}\n";
static const char *boxes_fs = "#version 330 core\nin vec3 normal; out vec4 o;\nvoid main() { o = vec4(normal, 0); }\n";
static GLuint program(const char *vs, const char *fs)
{
    GLuint p = glCreateProgram();
    for (int i = 0; i < 2; ++i) {
        GLuint s = glCreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        glShaderSource(s, 1, i ? &fs : &vs, NULL), glCompileShader(s), glAttachShader(p, s);
    }
    return glLinkProgram(p), glUseProgram(p), p;
}
static GLuint target(GLenum attachment, GLenum internal, GLenum format, GLenum type, int w, int h)
{
    GLuint t;
    glGenTextures(1, &t), glBindTexture(GL_TEXTURE_2D, t);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)internal, w, h, 0, format, type, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);     /* else integer textures read 0 */
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, t, 0);
    return t;
}
/* ==== ssgi: ambient visibility is what the framebuffer holds that is bound last =================================== */
static int draw(const char *method, const ssgi_view *view, float radius, const GLuint yours[SSGI_GL_YOURS])
{
    static char text[2][32768];
    ssgi_gl_step step[SSGI_GL_MAX_STEPS], *s = step;
    ssgi_gl_frame frame;
    GLuint made[SSGI_GL_MAX_STEPS], name, p;
    const char *why = "the chain has more steps than SSGI_GL_MAX_STEPS";
    const int count = ssgi_gl_steps_of(step, SSGI_GL_MAX_STEPS, &frame, method, view, radius, &why);
    if (count < 1 || count > SSGI_GL_MAX_STEPS) return puts(why), 0;
    glGenBuffers(1, &name), glBindBufferBase(GL_UNIFORM_BUFFER, 0, name);
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_DYNAMIC_DRAW);
    for (; s < step + count; ++s) {
        for (int k = 0; k < 2; ++k) ssgi_gl_emit(text[k], sizeof text[k], &s->desc, k);
        p = program(text[0], text[1]), glUniformBlockBinding(p, glGetUniformBlockIndex(p, "ssgi_frame"), 0);
        glGenFramebuffers(1, &name), glBindFramebuffer(GL_FRAMEBUFFER, name);
        for (const ssgi_gl_output *o = s->output; o < s->output + s->outputs; ++o)
            made[o->texture] = target(GL_COLOR_ATTACHMENT0 + (GLenum)(o - s->output), o->format->internal,
                                      o->format->format, o->format->type, s->width, s->height);
        for (const ssgi_gl_input *in = s->input; in < s->input + s->inputs; ++in) {
            glUniform1i(glGetUniformLocation(p, in->name), in->unit);
            glActiveTexture(GL_TEXTURE0 + (GLenum)in->unit);
            glBindTexture(in->target, in->texture < 0 ? yours[in->meaning] : made[in->texture]);
        }
        glViewport(0, 0, s->width, s->height), glDrawArraysInstanced(s->primitive, 0, s->vertices, s->instances);
    }
    return 1;
}
/* ================================================================================================================== */
int main(void)
{
    static unsigned char pixels[W * H];
    const float g = 2.365f, projection[16] = { g * H / W, 0, 0, 0, 0, g, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2002f, 0 };
    GLuint name, yours[SSGI_GL_YOURS];
    ssgi_view view;
    if (!open_context()) return puts("no GL context"), 1;
    glGenFramebuffers(1, &name), glBindFramebuffer(GL_FRAMEBUFFER, name);
    yours[SSGI_GL_YOUR_DEPTH] = target(GL_DEPTH_ATTACHMENT, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, W, H);
    yours[SSGI_GL_YOUR_NORMAL] = target(GL_COLOR_ATTACHMENT0, GL_RGBA16F, GL_RGBA, GL_FLOAT, W, H);
    glUniformMatrix4fv(glGetUniformLocation(program(boxes_vs, boxes_fs), "projection"), 1, GL_FALSE, projection);
    glViewport(0, 0, W, H), glEnable(GL_DEPTH_TEST), glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 36, 40), glDisable(GL_DEPTH_TEST);
    ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, W, H, NULL);
    if (!draw("hsao", &view, 0.5f, yours)) return 1;                         /* radius: 0.5 units of the scene */
    glReadPixels(0, 0, W, H, GL_RED, GL_UNSIGNED_BYTE, pixels);
    FILE *file = fopen("ao.pgm", "wb");
    if (!file) return perror("ao.pgm"), 1;
    fprintf(file, "P5 %d %d 255\n", W, H);
    for (int y = H - 1; y >= 0; --y) fwrite(pixels + y * W, 1, W, file);
    return fclose(file);
}
