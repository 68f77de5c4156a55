/* boxes.h - the engine of glfw.c and sdl.c, which has no part of ssgi: 24 boxes on a slab, lit by a sun and by a sky of
   uniform brightness. It draws four textures: the picture, in linear values; its ambient part, which is the sky's
   light; normals, n/2 + 1/2 in view space; depth. The file that includes it declares GL's functions: GL 3.3 core or
   GLES 3.0. */
#include <stdio.h>
#include <stdlib.h>

enum { BOXES_PICTURE, BOXES_AMBIENT, BOXES_NORMAL, BOXES_DEPTH, BOXES_TEXTURES };

static GLuint boxes_texture[BOXES_TEXTURES], boxes_framebuffer, boxes_scene, boxes_shown;

/* column-major, with a vertical angle of 45 degrees, near and far planes at 0.1 and 100; boxes_resize sets the first
   number, by the aspect */
static float boxes_projection[16] = { 0, 0, 0, 0, 0, 2.41421356f, 0, 0, 0, 0, -1.002002f, -1, 0, 0, -0.2002002f, 0 };

/* Box 0 is the slab. All boxes turn about y and are seen from (0, 6, 8); the sun is above the viewer's left
   shoulder. */
static const char boxes_vertex[] =
    "uniform mat4 projection; uniform float angle; flat out vec3 normal;\n"
    "void main() {\n"
    "  int side = gl_VertexID / 6, k = gl_VertexID % 6, corner = k < 3 ? k : k - 2, i = gl_InstanceID;\n"
    "  vec3 p = vec3(ivec3(side, corner, corner >> 1) & 1) * 2.0 - 1.0, n = vec3(p.x, 0, 0);\n"
    "  if (side / 2 == 1) { p = p.zxy; n = n.zxy; }\n"
    "  if (side / 2 == 2) { p = p.yzx; n = n.yzx; }\n"
    "  vec3 size = vec3(0.35 + 0.05 * float(i * 3 % 8), 0.2 + 0.2 * float(i * 7 % 5), 0.35);\n"
    "  size.z += 0.05 * float(i * 5 % 7);\n"
    "  vec3 at = vec3(1.5 * float(i % 5 - 2), size.y, 1.5 * float(i / 5 - 2));\n"
    "  if (i == 0) { size = vec3(4.5, 0.1, 4.5); at = vec3(0, -0.1, 0); }\n"
    "  mat3 turn = mat3(cos(angle), 0, -sin(angle), 0, 1, 0, sin(angle), 0, cos(angle));\n"
    "  mat3 view = mat3(1, 0, 0, 0, 0.8, 0.6, 0, -0.6, 0.8) * turn;\n"
    "  normal = view * n;\n"
    "  gl_Position = projection * vec4(view * (p * size + at) - vec3(0, 0, 10), 1);\n"
    "}\n";
static const char boxes_fragment[] =
    "precision highp float;\n"
    "uniform float sun, sky; flat in vec3 normal;\n"
    "layout(location = 0) out vec4 picture; layout(location = 1) out vec4 ambient;\n"
    "layout(location = 2) out vec4 view_normal;\n"
    "void main() {\n"
    "  ambient = vec4(vec3(sky), 1);\n"
    "  picture = ambient + sun * vec4(1, 0.85, 0.65, 0) * max(dot(normal, vec3(-0.6, 0.64, 0.48)), 0.0);\n"
    "  view_normal = vec4(normal * 0.5 + 0.5, 0);\n"
    "}\n";

/* shaders that show the image, encoded as sRGB */
static const char boxes_show_vertex[] =
    "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0, 1); }\n";
static const char boxes_show_fragment[] =
    "precision highp float;\n"
    "uniform sampler2D picture; out vec4 shown;\n"
    "void main() { shown = vec4(pow(texelFetch(picture, ivec2(gl_FragCoord.xy), 0).rgb, vec3(1.0 / 2.2)), 1); }\n";

static GLuint boxes_program(const char *version, const char *vertex, const char *fragment)
{
    const GLuint program = glCreateProgram();
    char log[1000] = "";
    for (int i = 0; i < 2; ++i) {
        const GLuint shader = glCreateShader(i ? GL_FRAGMENT_SHADER : GL_VERTEX_SHADER);
        const char *const text[2] = { version, i ? fragment : vertex };
        glShaderSource(shader, 2, text, NULL);
        glCompileShader(shader);
        glAttachShader(program, shader);
        glGetShaderInfoLog(shader, sizeof log, NULL, log);
        fputs(log, stderr);
    }
    glLinkProgram(program);
    glGetProgramInfoLog(program, sizeof log, NULL, log);
    fputs(log, stderr);
    return program;
}

static void boxes_open(const char *version)
{
    GLuint vertices;
    glGenVertexArrays(1, &vertices);
    glBindVertexArray(vertices); /* a vertex array without attributes: vertices come from gl_VertexID */
    glGenTextures(BOXES_TEXTURES, boxes_texture);
    glGenFramebuffers(1, &boxes_framebuffer);
    boxes_scene = boxes_program(version, boxes_vertex, boxes_fragment);
    boxes_shown = boxes_program(version, boxes_show_vertex, boxes_show_fragment);
}

static void boxes_resize(int w, int h)
{
    static const GLenum attachment[] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2,
                                         GL_DEPTH_ATTACHMENT };
    glBindFramebuffer(GL_FRAMEBUFFER, boxes_framebuffer);
    for (int i = 0; i < BOXES_TEXTURES; ++i) {
        glBindTexture(GL_TEXTURE_2D, boxes_texture[i]);
        if (i == BOXES_DEPTH)
            glTexImage2D(GL_TEXTURE_2D, 0, GL_DEPTH_COMPONENT32F, w, h, 0, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
        else glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB10_A2, w, h, 0, GL_RGBA, GL_UNSIGNED_INT_2_10_10_10_REV, NULL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment[i], GL_TEXTURE_2D, boxes_texture[i], 0);
    }
    glDrawBuffers(3, attachment);
    boxes_projection[0] = boxes_projection[5] * (float)h / (float)w;
}

static void boxes_draw(float angle, float sun, float sky, int w, int h)
{
    glBindFramebuffer(GL_FRAMEBUFFER, boxes_framebuffer);
    glViewport(0, 0, w, h);
    glEnable(GL_DEPTH_TEST);
    glClearColor(sky, sky, sky, 1);
    glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
    glUseProgram(boxes_scene);
    glUniformMatrix4fv(glGetUniformLocation(boxes_scene, "projection"), 1, GL_FALSE, boxes_projection);
    glUniform1f(glGetUniformLocation(boxes_scene, "angle"), angle);
    glUniform1f(glGetUniformLocation(boxes_scene, "sun"), sun);
    glUniform1f(glGetUniformLocation(boxes_scene, "sky"), sky);
    glDrawArraysInstanced(GL_TRIANGLES, 0, 36, 25);
}

static void boxes_show(int w, int h)
{
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, w, h);
    glDisable(GL_DEPTH_TEST);
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, boxes_texture[BOXES_PICTURE]);
    glUseProgram(boxes_shown);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/* Writes the shown image as a PPM. Returns 0, or 1 after it has printed the reason. */
static int boxes_save(const char *path, int w, int h)
{
    unsigned char *pixels = malloc(4 * (size_t)w * (size_t)h);
    FILE *file = pixels ? fopen(path, "wb") : NULL;
    int failed = !file;
    if (file) {
        glReadPixels(0, 0, w, h, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
        fprintf(file, "P6 %d %d 255\n", w, h);
        for (int y = h - 1; y >= 0; --y)
            for (int x = 0; x < w; ++x) fwrite(pixels + 4 * (y * w + x), 3, 1, file);
        failed = ferror(file);
        failed |= fclose(file);
    }
    if (failed) perror(path);
    free(pixels);
    return failed ? 1 : 0;
}
