/* forward.c - ambient occlusion in forward rendering: GLFW 3, GL 3.3 core, multisampled. boxes.h is the engine, whose
   first pass gives depth and normals. Between the lines of "====" hsao draws at half resolution without a filter pass:
   the shader that lights a surface filters it, so that each sample at an edge and the pane of glass have their own
   value. The same shader then adds fog. A sign in front of the camera is not in the first pass, so it occludes nothing,
   and its shader does not read the occlusion.
     cc examples/hosts/forward.c -lglfw -lGL -lm -o forward && ./forward    (Debian: libglfw3-dev)
   ./forward FILE.ppm [SUN SKY]: one picture; with SUN and SKY as the lights' strength, without multisampling, pane,
   sign and fog. The window's size is fixed; glfw.c shows the code for a change of size. */
#define GL_GLEXT_PROTOTYPES /* libGL has all functions; on other systems a loader, such as glad, declares them */
#define GLFW_INCLUDE_GLCOREARB
#include <GLFW/glfw3.h>
#include "boxes.h"
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"

enum { WIDTH = 960, HEIGHT = 540 };

static const char version[] = "#version 330 core\n";

/* ---- the engine's shaders: for the boxes, lit in one pass, and for a sheet of glass or board */
static const char sheet_vertex[] =
    "uniform mat4 projection; uniform vec3 corner[3]; flat out vec3 normal;\n"
    "void main() {\n"
    "  vec3 x = corner[1] - corner[0], y = corner[2] - corner[0];\n"
    "  normal = normalize(cross(x, y));\n"
    "  gl_Position = projection * vec4(corner[0] + float(gl_VertexID & 1) * x + float(gl_VertexID >> 1) * y, 1);\n"
    "}\n";
static const char lit[] =
    "uniform float sun, sky, fog; uniform vec4 colour; flat in vec3 normal; layout(location = 0) out vec4 picture;\n"
    "void main() {\n"
    "  float depth = ssgi_fragment_depth(gl_FragCoord.xy, gl_FragCoord.z);\n"
    "  float visibility = ssgi_visibility_at(gl_FragCoord.xy, depth, normal);\n"
    "  vec3 light = vec3(sky * visibility);\n" /* Visibility only dims the ambient light. */
    "  light += sun * vec3(1, 0.85, 0.65) * max(dot(normal, vec3(-0.6, 0.64, 0.48)), 0.0);\n"
    "  picture = vec4(mix(vec3(sky), colour.rgb * light, exp2(-fog * depth)), colour.a);\n"
    "}\n";
static const char board[] = "out vec4 picture; void main() { picture = vec4(0.2, 0.05, 0.05, 1); }\n";

/* ==== ssgi ======================================================================================================== */
enum { MOST = SSGI_GL_MAX_STEPS };
static ssgi_gl_step step[MOST];
static int steps;
static GLuint gather[MOST], framebuffer[MOST], texture[MOST], block;

/* Gets the steps without the filter and makes their textures; writes functions that read the result. NULL: no error. */
static const char *occlusion(char *functions, size_t size, int width, int height)
{
    static char text[2][32768];
    const ssgi_gl_desc desc = { .pass = SSGI_GL_PASS_HSAO, .input.normal = SSGI_GL_NORMAL_UNSIGNED };
    ssgi_gl_chain chain = { .desc = desc, .width = width, .height = height };
    const char *why = "";
    if (ssgi_gl_preset(&chain.desc, SSGI_GL_PRESET_BALANCED, &why)) return why;
    if (!(steps = ssgi_gl_steps(step, MOST, &chain, &why))) return why;
    if (steps > MOST) return "the chain has more steps than SSGI_GL_MAX_STEPS";
    glGenBuffers(1, &block), glGenTextures(MOST, texture), glGenFramebuffers(MOST, framebuffer);
    for (int i = 0; i < steps; ++i) {
        const ssgi_gl_output *to = step[i].output;
        glBindTexture(GL_TEXTURE_2D, texture[to->texture]);
        glTexImage2D(GL_TEXTURE_2D, 0, (GLint)to->format->internal, step[i].width, step[i].height, 0,
                     to->format->format, to->format->type, NULL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); /* linear filters read integers as 0 */
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[i]);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture[to->texture], 0);
        for (int k = 0; k < 2; ++k) ssgi_gl_emit(text[k], sizeof text[k], &step[i].desc, k);
        glUseProgram(gather[i] = boxes_program("", text[SSGI_GL_STAGE_VERTEX], text[SSGI_GL_STAGE_FRAGMENT]));
        glUniformBlockBinding(gather[i], glGetUniformBlockIndex(gather[i], "ssgi_frame"), 0);
        for (int k = 0; k < step[i].inputs; ++k)
            glUniform1i(glGetUniformLocation(gather[i], step[i].input[k].name), step[i].input[k].unit);
    }
    return ssgi_gl_read(functions, size, &step[steps - 1].desc) < size ? NULL : "the functions need more room";
}

/* Draws the occlusion; call it every frame after the first pass. Returns an error message or NULL. */
static const char *occlude(const float projection[16], float radius, int width, int height)
{
    ssgi_view view;
    ssgi_gl_frame frame;
    const char *why = "";
    if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, width, height, &why)) return why;
    if (ssgi_gl_frame_init(&frame, &view, radius, &why)) return why;
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, block);
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_DYNAMIC_DRAW);
    glDisable(GL_DEPTH_TEST);
    for (const ssgi_gl_step *s = step; s < step + steps; ++s) {
        for (const ssgi_gl_input *in = s->input; in < s->input + s->inputs; ++in) {
            const int yours = in->meaning == SSGI_GL_YOUR_DEPTH ? BOXES_DEPTH : BOXES_NORMAL;
            glActiveTexture(GL_TEXTURE0 + (GLenum)in->unit);
            glBindTexture(in->target, in->texture < 0 ? boxes_texture[yours] : texture[in->texture]);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[s - step]), glViewport(0, 0, s->width, s->height);
        glUseProgram(gather[s - step]), glDrawArraysInstanced(s->primitive, 0, s->vertices, s->instances);
    }
    return NULL;
}

/* ================================================================================================================== */
static GLuint forward_program(const char *vertex, const char *functions, const char *fragment, float sun, float sky,
                              float fog)
{
    static char text[40000];
    snprintf(text, sizeof text, "%s%s", functions, fragment);
    const GLuint p = boxes_program(version, vertex, text), at = glGetUniformBlockIndex(p, "ssgi_frame");
    if (at != GL_INVALID_INDEX) glUniformBlockBinding(p, at, 0);
    glUseProgram(p);
    glUniformMatrix4fv(glGetUniformLocation(p, "projection"), 1, GL_FALSE, boxes_projection);
    glUniform1f(glGetUniformLocation(p, "sun"), sun), glUniform1f(glGetUniformLocation(p, "sky"), sky);
    glUniform1f(glGetUniformLocation(p, "fog"), fog);
    glUniform4f(glGetUniformLocation(p, "colour"), 1, 1, 1, 1);
    return p;
}

static void draw_sheet(GLuint program, const float corner[9])
{
    glUseProgram(program);
    glUniform3fv(glGetUniformLocation(program, "corner"), 3, corner);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

int main(int argc, char **argv)
{
    /* in view space: the pane stands on the slab in front of some boxes */
    static const float pane[9] = { -2, -2.1f, -7, 2, -2.1f, -7, -2, 0.3f, -5.2f },
                       sign[9] = { 0.05f, -0.08f, -0.2f, 0.1f, -0.08f, -0.2f, 0.05f, -0.04f, -0.2f };
    static char functions[32768];
    const char *file = argc > 1 ? argv[1] : NULL, *why = "";
    const int plain = argc > 3;
    const float sun = plain ? strtof(argv[2], NULL) : 0.6f, sky = plain ? strtof(argv[3], NULL) : 0.4f;
    GLFWwindow *window = NULL;
    GLuint boxes, glass, held, colour, resolved, samples, depth;
    if (glfwInit()) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3), glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE), glfwWindowHint(GLFW_RESIZABLE, GLFW_FALSE);
        window = glfwCreateWindow(WIDTH, HEIGHT, "ssgi", NULL, NULL);
    }
    if (!window) return glfwGetError(&why), fprintf(stderr, "forward: %s\n", why), 1;
    glfwMakeContextCurrent(window), boxes_open(version), boxes_resize(WIDTH, HEIGHT);
    if ((why = occlusion(functions, sizeof functions, WIDTH, HEIGHT))) return fprintf(stderr, "forward: %s\n", why), 1;
    boxes = forward_program(boxes_vertex, functions, lit, sun, sky, plain ? 0 : 0.03f);
    glass = forward_program(sheet_vertex, functions, lit, sun, sky, 0.03f);
    glUniform4f(glGetUniformLocation(glass, "colour"), 0.4f, 0.7f, 0.6f, 0.5f);
    held = forward_program(sheet_vertex, "", board, sun, sky, 0);
    glGenFramebuffers(1, &samples), glBindFramebuffer(GL_FRAMEBUFFER, samples);
    glGenRenderbuffers(1, &colour), glBindRenderbuffer(GL_RENDERBUFFER, colour);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, plain ? 0 : 4, GL_RGBA16F, WIDTH, HEIGHT);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, colour);
    glGenRenderbuffers(1, &depth), glBindRenderbuffer(GL_RENDERBUFFER, depth);
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, plain ? 0 : 4, GL_DEPTH_COMPONENT32F, WIDTH, HEIGHT);
    glFramebufferRenderbuffer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_RENDERBUFFER, depth);
    glGenFramebuffers(1, &resolved), glBindFramebuffer(GL_FRAMEBUFFER, resolved);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, boxes_texture[BOXES_PICTURE], 0);
    for (; !glfwWindowShouldClose(window); glfwSwapBuffers(window), glfwPollEvents()) {
        const float angle = file ? 0.0f : 0.3f * (float)glfwGetTime();
        boxes_draw(angle, sun, sky, WIDTH, HEIGHT); /* draws depth and normals of all occluders */
        if ((why = occlude(boxes_projection, 1, WIDTH, HEIGHT))) return fprintf(stderr, "forward: %s\n", why), 1;
        glActiveTexture(GL_TEXTURE9), glBindTexture(GL_TEXTURE_2D, texture[step[steps - 1].output[0].texture]);
        glBindFramebuffer(GL_FRAMEBUFFER, samples), glViewport(0, 0, WIDTH, HEIGHT), glEnable(GL_DEPTH_TEST);
        glClear(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
        glUseProgram(boxes), glUniform1i(glGetUniformLocation(boxes, "t_ssgi_ao"), 9);
        glUniform1f(glGetUniformLocation(boxes, "angle"), angle);
        glDrawArraysInstanced(GL_TRIANGLES, 0, 36, 25);
        if (!plain) {
            glEnable(GL_BLEND), glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA), glDepthMask(GL_FALSE);
            glUseProgram(glass), glUniform1i(glGetUniformLocation(glass, "t_ssgi_ao"), 9), draw_sheet(glass, pane);
            glDisable(GL_BLEND), glDepthMask(GL_TRUE), draw_sheet(held, sign);
        }
        glBindFramebuffer(GL_READ_FRAMEBUFFER, samples), glBindFramebuffer(GL_DRAW_FRAMEBUFFER, resolved);
        glBlitFramebuffer(0, 0, WIDTH, HEIGHT, 0, 0, WIDTH, HEIGHT, GL_COLOR_BUFFER_BIT, GL_NEAREST);
        boxes_show(WIDTH, HEIGHT);
        if (file) return boxes_save(file, WIDTH, HEIGHT);
    }
}
