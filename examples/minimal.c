/* minimal.c - the smallest honest embedding. An engine has a GL context, depth, normals and a projection matrix; here
   OSMesa is the context and a few boxes are the scene. Between the lines of "====" stands all that ssgi asks of you:
   a loop over its steps. Writes ao.pgm.      cc examples/minimal.c -lOSMesa -lm && ./a.out */
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>
#include <math.h>
#include <stdio.h>
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../ssgi_gl.h"

enum { W = 960, H = 540 };
static const char *boxes_vs = "#version 330 core\nuniform mat4 projection; out vec3 normal;\n"   /* the engine's scene */
    "void main() {\n"
    "  int f = gl_VertexID / 6, k = gl_VertexID % 6, a = f / 2, c = k < 3 ? k : k - 2, i = gl_InstanceID;\n"
    "  vec2 q = vec2(c & 1, c >> 1) * 2.0 - 1.0; float s = float(f & 1) * 2.0 - 1.0;\n"
    "  vec3 p = a == 0 ? vec3(s, q) : a == 1 ? vec3(q.y, s, q.x) : vec3(q, s);\n"
    "  vec3 r = fract(sin(float(i) * vec3(12.99, 78.23, 37.72)) * 437.5), size = i == 0 ? vec3(20, 0.1, 20) : 0.15 + 0.4 * r;\n"
    "  vec3 at = i == 0 ? vec3(0, -0.1, 0) : vec3(r.z * 8.0 - 4.0, size.y, r.x * 8.0 - 4.0) - vec3(0);\n"
    "  mat3 tilt = mat3(1, 0, 0, 0, 0.9, 0.436, 0, -0.436, 0.9); normal = tilt * vec3(a == 0, a == 1, a == 2) * s;\n"
    "  gl_Position = projection * vec4(tilt * (p * size + at - vec3(0, 2.5, 6)), 1);\n}\n";
static const char *boxes_fs =
    "#version 330 core\nin vec3 normal; out vec4 o;\nvoid main() { o = vec4(normalize(normal), 0); }\n";

static GLuint program(const char *vs, const char *fs)
{
    GLuint p = glCreateProgram();
    for (int i = 0; i < 2; ++i) {
        GLuint s = glCreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        glShaderSource(s, 1, i ? &fs : &vs, NULL);
        glCompileShader(s);
        glAttachShader(p, s);
    }
    glLinkProgram(p);
    glUseProgram(p);
    return p;
}
static GLuint target(GLenum internal, GLenum format, GLenum type, int w, int h, GLenum attachment)
{
    GLuint t;
    glGenTextures(1, &t);
    glBindTexture(GL_TEXTURE_2D, t);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)internal, w, h, 0, format, type, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glFramebufferTexture2D(GL_FRAMEBUFFER, attachment, GL_TEXTURE_2D, t, 0);
    return t;
}

/* ==== ssgi ======================================================================================================== */
static ssgi_gl_step step[8];
static GLuint shader[8], framebuffer[8], made[8], yours[SSGI_GL_YOURS];
static int ssgi_open(const ssgi_gl_chain *chain)                                              /* once */
{
    static char text[2][32768];
    int i, k, count = ssgi_gl_steps(step, 8, chain, NULL);
    for (i = 0; i < count; ++i) {
        for (k = 0; k < 2; ++k) ssgi_gl_emit(text[k], sizeof text[k], &step[i].desc, k);
        shader[i] = program(text[SSGI_GL_VERTEX], text[SSGI_GL_FRAGMENT]);
        glUniformBlockBinding(shader[i], glGetUniformBlockIndex(shader[i], "ssgi_frame"), 0);
        for (k = 0; k < step[i].inputs; ++k)
            glUniform1i(glGetUniformLocation(shader[i], step[i].input[k].name), step[i].input[k].unit);
        glGenFramebuffers(1, &framebuffer[i]);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[i]);
        for (k = 0; k < step[i].outputs; ++k) {
            const ssgi_gl_output *o = &step[i].output[k];
            made[o->texture] = target(o->format->internal, o->format->format, o->format->type, step[i].width,
                                      step[i].height, GL_COLOR_ATTACHMENT0 + (GLenum)k);
        }
    }
    return count;
}
static void ssgi_draw(int count, const ssgi_gl_frame *frame)                                  /* every frame */
{
    glBufferData(GL_UNIFORM_BUFFER, sizeof *frame, frame, GL_DYNAMIC_DRAW);
    for (int i = 0; i < count; ++i) {
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[i]);
        glViewport(0, 0, step[i].width, step[i].height);
        glUseProgram(shader[i]);
        for (int k = 0; k < step[i].inputs; ++k) {
            const ssgi_gl_input *in = &step[i].input[k];
            glActiveTexture(GL_TEXTURE0 + (GLenum)in->unit);
            glBindTexture(in->target, in->texture < 0 ? yours[in->meaning] : made[in->texture]);
        }
        glDrawArraysInstanced(step[i].primitive, 0, step[i].vertices, step[i].instances);
    }
}
