/* minimal.c - the smallest honest embedding. An engine has a GL context, a depth texture, a normal texture and a
   projection matrix; here OSMesa is the context and a few boxes are the scene. Between the two lines of "====" stands
   all that ssgi asks of you. Writes ao.pgm.

      cc examples/minimal.c -lOSMesa -lm && ./a.out */
#define GL_GLEXT_PROTOTYPES
#include <GL/osmesa.h>
#include <GL/glext.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../ssgi_gl.h"

enum { W = 960, H = 540 };

static const char *boxes_vs = /* 40 boxes from gl_VertexID and gl_InstanceID: stands for the engine's geometry */
    "#version 330 core\nuniform mat4 projection; out vec3 normal;\n"
    "void main() {\n"
    "  int f = gl_VertexID / 6, k = gl_VertexID % 6, a = f / 2, c = k < 3 ? k : k - 2, i = gl_InstanceID; mat3 tilt = "
    "mat3(1, 0, 0, 0, 0.9, 0.436, 0, -0.436, 0.9);\n"
    "  vec2 q = vec2(c & 1, c >> 1) * 2.0 - 1.0; float s = float(f & 1) * 2.0 - 1.0;\n"
    "  vec3 p = a == 0 ? vec3(s, q) : a == 1 ? vec3(q.y, s, q.x) : vec3(q, s), r = fract(sin(float(i) * vec3(12.99, "
    "78.23, 37.72)) * 437.5);\n"
    "  vec3 size = i == 0 ? vec3(20, 0.1, 20) : 0.15 + 0.4 * r, at = i == 0 ? vec3(0, -0.1, 0) : vec3(r.z * 8.0 - 4.0, "
    "size.y, r.x * 8.0 - 4.0);\n"
    "  normal = tilt * vec3(a == 0, a == 1, a == 2) * s; gl_Position = projection * vec4(tilt * (p * size + at - "
    "vec3(0, 2.5, 6)), 1);\n"
    "}\n";
static const char *boxes_fs =
    "#version 330 core\nin vec3 normal; out vec4 o;\nvoid main() { o = vec4(normalize(normal), 0); }\n";

static GLuint program(const char *vs, const char *fs)
{
    const char *text[2] = { vs, fs };
    GLuint p = glCreateProgram();
    char log[2000] = "";
    for (int i = 0; i < 2; ++i) {
        GLuint s = glCreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        glShaderSource(s, 1, &text[i], NULL);
        glCompileShader(s);
        glAttachShader(p, s);
    }
    glLinkProgram(p);
    glGetProgramInfoLog(p, sizeof log, NULL, log);
    fputs(log, stderr);
    return p;
}

static GLuint texture(GLenum internal, GLenum format, int w, int h)
{
    GLuint t;
    glGenTextures(1, &t);
    glBindTexture(GL_TEXTURE_2D, t);
    glTexImage2D(GL_TEXTURE_2D, 0, (GLint)internal, w, h, 0, format, GL_FLOAT, NULL);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    return t;
}

static void target(GLuint program_, GLuint color, GLuint depth, int w, int h)   /* what the next draw uses and fills */
{
    GLuint f;
    glGenFramebuffers(1, &f);
    glBindFramebuffer(GL_FRAMEBUFFER, f);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, color, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    glViewport(0, 0, w, h);
    glUseProgram(program_);
}

/* ==== ssgi: from a desc to a program whose samplers and block are bound to their slots =========================== */
static GLuint ssgi_program(const ssgi_gl_desc *d)
{
    static char text[2][32768];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    GLuint p;
    for (int s = 0; s < 2; ++s) ssgi_gl_emit(text[s], sizeof text[s], d, s);
    p = program(text[SSGI_GL_VERTEX], text[SSGI_GL_FRAGMENT]);
    glUseProgram(p);
    for (int i = 0, n = ssgi_gl_reflect(d, row, SSGI_GL_MAX_IO); i < n; ++i)
        if (row[i].kind == SSGI_GL_TEXTURE) glUniform1i(glGetUniformLocation(p, row[i].name), row[i].slot);
    glUniformBlockBinding(p, glGetUniformBlockIndex(p, "ssgi_frame"), 0);
    return p;
}

typedef struct input { const char *name; GLuint texture; } input;

static void ssgi_bind(const ssgi_gl_desc *d, const input *inputs, int count)     /* each texture to its unit, by name */
{
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    for (int i = 0, n = ssgi_gl_reflect(d, row, SSGI_GL_MAX_IO); i < n; ++i)
        for (int k = 0; k < count && row[i].kind == SSGI_GL_TEXTURE; ++k) {
            if (strcmp(row[i].name, inputs[k].name)) continue;
            glActiveTexture(GL_TEXTURE0 + (GLenum)row[i].slot);
            glBindTexture(GL_TEXTURE_2D, inputs[k].texture);
        }
}

static void ambient_occlusion(GLuint depth, GLuint normal, const float projection[16], float radius, GLuint result)
{
    ssgi_gl_desc d = { 0 }, blur;
    ssgi_view view;
    ssgi_gl_frame frame;
    const char *why = "";
    GLuint block, gather, filter, raw = texture(GL_RG32F, GL_RG, (W + 1) / 2, (H + 1) / 2);
    const input inputs[3] = { { "t_ssgi_depth", depth }, { "t_ssgi_normal", normal }, { "t_ssgi_ao", raw } };
    d.pass = SSGI_GL_HSAO;
    ssgi_gl_preset(&d, SSGI_GL_BALANCED, NULL);                    /* half size, 2 slices of 6 steps, 3x3 filter */
    gather = ssgi_program(&d);
    blur = d;
    blur.pass = SSGI_GL_BLUR;
    filter = ssgi_program(&blur);
    if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, W, H, &why)
        || ssgi_gl_frame_init(&frame, &view, radius, &why)) {
        puts(why);
        exit(1);
    }
    glGenBuffers(1, &block);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, block);                 /* from here on: every frame */
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_DYNAMIC_DRAW);
    glDisable(GL_DEPTH_TEST);
    ssgi_bind(&d, inputs, 3);
    target(gather, raw, 0, (W + 1) / 2, (H + 1) / 2);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    ssgi_bind(&blur, inputs, 3);
    target(filter, result, 0, W, H);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}
/* ================================================================================================================== */

int main(void)
{
    static const int attributes[] = { OSMESA_FORMAT,
                                      OSMESA_RGBA,
                                      OSMESA_PROFILE,
                                      OSMESA_CORE_PROFILE,
                                      OSMESA_CONTEXT_MAJOR_VERSION,
                                      3,
                                      OSMESA_CONTEXT_MINOR_VERSION,
                                      3,
                                      0 };
    static unsigned char screen[4 * W * H], pixels[W * H];
    const float n = 0.1f, f = 100.0f, g = 1.0f / tanf(0.4f);
    const float projection[16] = {
        g * H / W, 0, 0, 0, 0, g, 0, 0, 0, 0, -(f + n) / (f - n), -1, 0, 0, -2 * f * n / (f - n), 0
    };
    OSMesaContext context = OSMesaCreateContextAttribs(attributes, NULL);
    GLuint vao, depth, normal, result, boxes;
    FILE *file;
    if (!context || !OSMesaMakeCurrent(context, screen, GL_UNSIGNED_BYTE, W, H)) return puts("no OSMesa context"), 1;
    glGenVertexArrays(1, &vao);
    glBindVertexArray(vao);
    depth = texture(GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, W, H);      /* the engine's G-buffer */
    normal = texture(GL_RGBA16F, GL_RGBA, W, H);
    boxes = program(boxes_vs, boxes_fs);
    target(boxes, normal, depth, W, H);
    glUniformMatrix4fv(glGetUniformLocation(boxes, "projection"), 1, GL_FALSE, projection);
    glEnable(GL_DEPTH_TEST);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 36, 40);

    result = texture(GL_R8, GL_RED, W, H);
    /* ambient visibility: multiply your ambient light by it */
    ambient_occlusion(depth, normal, projection, 0.5f, result);

    glReadPixels(0, 0, W, H, GL_RED, GL_UNSIGNED_BYTE, pixels);
    file = fopen("ao.pgm", "wb");
    if (!file) return puts("ao.pgm cannot be written"), 1;
    fprintf(file, "P5 %d %d 255\n", W, H);
    for (int y = H - 1; y >= 0; --y) fwrite(pixels + y * W, 1, W, file);
    fclose(file);
    return 0;
}
