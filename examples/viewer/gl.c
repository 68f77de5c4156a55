/* gl.c - what every engine has a wrapper for: programs, textures, framebuffers, timers. */
#include "viewer.h"

int gl_software;

static GLuint shader_of(GLenum stage, const char *text, kit_error *err)
{
    char log[600] = "";
    GLint good = 0;
    const GLuint s = glCreateShader(stage);
    glShaderSource(s, 1, &text, NULL);
    glCompileShader(s);
    glGetShaderiv(s, GL_COMPILE_STATUS, &good);
    if (good) return s;
    glGetShaderInfoLog(s, sizeof log, NULL, log);
    glDeleteShader(s);
    return kit_fail(err, "a shader does not compile: %.500s", log), 0u;
}

GLuint gl_program(const char *vertex, const char *fragment, kit_error *err)
{
    const GLuint stage[2] = { shader_of(GL_VERTEX_SHADER, vertex, err), shader_of(GL_FRAGMENT_SHADER, fragment, err) };
    const GLuint p = glCreateProgram();
    GLint good = 0;
    for (int i = 0; i < 2 && stage[0] && stage[1]; ++i) glAttachShader(p, stage[i]);
    if (stage[0] && stage[1]) glLinkProgram(p);
    glGetProgramiv(p, GL_LINK_STATUS, &good);
    for (int i = 0; i < 2; ++i) glDeleteShader(stage[i]);
    if (good) return p;
    if (stage[0] && stage[1]) kit_fail(err, "a program does not link");
    glDeleteProgram(p);
    return 0;
}

GLuint gl_texture(int width, int height, int slices, GLenum internal, GLenum format, GLenum type,
                         const void *data)
{
    const GLenum target = slices ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
    GLuint t;
    glGenTextures(1, &t);
    glBindTexture(target, t);
    if (slices) glTexImage3D(target, 0, (GLint)internal, width, height, slices, 0, format, type, data);
    else        glTexImage2D(target, 0, (GLint)internal, width, height, 0, format, type, data);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return t;
}

GLuint gl_framebuffer(const GLuint *colour, int colours, GLuint depth)
{
    GLenum attached[8];
    GLuint f;
    glGenFramebuffers(1, &f);
    glBindFramebuffer(GL_FRAMEBUFFER, f);
    for (int i = 0; i < colours; ++i) {
        attached[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        glFramebufferTexture2D(GL_FRAMEBUFFER, attached[i], GL_TEXTURE_2D, colour[i], 0);
    }
    if (depth) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    glDrawBuffers(colours, attached);
    return f;
}

void gl_bind(GLuint unit, GLenum target, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target, texture);
}

void timer_begin(timer *t)
{
    if (gl_software) { glFinish(); t->began = kit_seconds(); return; }
    const unsigned k = t->turn % RING;
    if (!t->query[0]) glGenQueries(RING, t->query);
    if (t->turn >= RING) {
        GLuint there = 0;
        GLuint64 ns = 0;
        glGetQueryObjectuiv(t->query[k], GL_QUERY_RESULT_AVAILABLE, &there);
        if (there) {
            glGetQueryObjectui64v(t->query[k], GL_QUERY_RESULT, &ns);
            t->ms += ((double)ns * 1e-6 - t->ms) * (t->ms > 0 ? 0.1 : 1);
        }
    }
    glBeginQuery(GL_TIME_ELAPSED, t->query[k]);
}

void timer_end(timer *t)
{
    ++t->turn;
    if (!gl_software) { glEndQuery(GL_TIME_ELAPSED); return; }
    glFinish();
    const double ms = (kit_seconds() - t->began) * 1e3;
    t->ms += (ms - t->ms) * (t->ms > 0 ? 0.3 : 1);
}
