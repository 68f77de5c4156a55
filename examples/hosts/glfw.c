/* glfw.c - ambient occlusion in a window: GLFW 3, GL 3.3 core. boxes.h is the engine: it draws a picture, its ambient
   part, normals and depth. Between the lines of "====" ssgi dims the ambient part; the sun's light stays.
     cc examples/hosts/glfw.c -lglfw -lGL -lm -o glfw && ./glfw             (Debian: libglfw3-dev)
   Draw fog, glass, sprites and the player's weapon between occlude and boxes_show, with the depth that occlude read,
   and TAA last: then they are not dimmed. Keep a thing out of that depth if it must not occlude either. ./glfw FILE.ppm
   [SUN SKY]: one picture, after a change of the window's size; SUN and SKY: the lights' strength. */
#define GL_GLEXT_PROTOTYPES /* libGL has all functions; on other systems a loader, such as glad, declares them */
#define GLFW_INCLUDE_GLCOREARB
#include <GLFW/glfw3.h>
#include "boxes.h"
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"

/* ==== ssgi ======================================================================================================== */
enum { MOST = SSGI_GL_MAX_STEPS };
static ssgi_gl_step step[MOST];
static int steps;
static GLuint program[MOST], framebuffer[MOST], texture[MOST], block, yours[SSGI_GL_YOURS];

/* Call it when the size changes: gets the steps and makes their targets. Programs do not depend on the size. */
static const char *resize(int width, int height)
{
    static char text[2][32768];
    const ssgi_gl_desc desc = { .pass = SSGI_GL_PASS_HSAO,
                                .input.normal = SSGI_GL_NORMAL_UNSIGNED,
                                .filter.onto = SSGI_GL_ONTO_AMBIENT };
    ssgi_gl_chain chain = { .desc = desc, .blur = 1, .width = width, .height = height };
    const char *why = "";
    if (ssgi_gl_preset(&chain.desc, SSGI_GL_PRESET_BALANCED, &why)) return why;
    if (!(steps = ssgi_gl_steps(step, MOST, &chain, &why))) return why;
    if (steps > MOST) return "the chain has more steps than SSGI_GL_MAX_STEPS";
    if (!block) glGenBuffers(1, &block), glGenTextures(MOST, texture), glGenFramebuffers(MOST, framebuffer);
    for (int i = 0; i < steps; ++i) {
        const ssgi_gl_output *to = step[i].output; /* hsao's steps have one output each; texture -1: the image */
        const GLuint into = to->texture < 0 ? boxes_texture[BOXES_PICTURE] : texture[to->texture];
        glBindTexture(GL_TEXTURE_2D, into);
        if (to->texture >= 0)
            glTexImage2D(GL_TEXTURE_2D, 0, (GLint)to->format->internal, step[i].width, step[i].height, 0,
                         to->format->format, to->format->type, NULL);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
        glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST); /* linear filters read integers as 0 */
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[i]);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, into, 0);
        if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return "GL refuses a step's texture";
        if (program[i]) continue;
        for (int k = 0; k < 2; ++k) ssgi_gl_emit(text[k], sizeof text[k], &step[i].desc, k);
        glUseProgram(program[i] = boxes_program("", text[SSGI_GL_STAGE_VERTEX], text[SSGI_GL_STAGE_FRAGMENT]));
        glUniformBlockBinding(program[i], glGetUniformBlockIndex(program[i], "ssgi_frame"), 0);
        for (int k = 0; k < step[i].inputs; ++k)
            glUniform1i(glGetUniformLocation(program[i], step[i].input[k].name), step[i].input[k].unit);
    }
    return NULL;
}

/* Call it every frame, with the projection of depth. radius: the distance of the farthest occluders. */
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
            glActiveTexture(GL_TEXTURE0 + (GLenum)in->unit);
            glBindTexture(in->target, in->texture < 0 ? yours[in->meaning] : texture[in->texture]);
        }
        if (s->blend[0]) glEnable(GL_BLEND), glBlendEquation(s->blend[0]), glBlendFunc(s->blend[1], s->blend[2]);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[s - step]), glViewport(0, 0, s->width, s->height);
        glUseProgram(program[s - step]), glDrawArraysInstanced(s->primitive, 0, s->vertices, s->instances);
        glDisable(GL_BLEND);
    }
    return NULL;
}

/* ================================================================================================================== */
int main(int argc, char **argv)
{
    const char *file = argc > 1 ? argv[1] : NULL, *why = "";
    const float sun = argc > 3 ? strtof(argv[2], NULL) : 0.6f, sky = argc > 3 ? strtof(argv[3], NULL) : 0.4f;
    int width = 0, height = 0, w, h;
    GLFWwindow *window = NULL;
    if (glfwInit()) {
        glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3), glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
        glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
        window = glfwCreateWindow(800, 450, "ssgi", NULL, NULL);
    }
    if (!window) return glfwGetError(&why), fprintf(stderr, "glfw: %s\n", why), 1;
    glfwMakeContextCurrent(window), boxes_open("#version 330 core\n");
    yours[SSGI_GL_YOUR_DEPTH] = boxes_texture[BOXES_DEPTH], yours[SSGI_GL_YOUR_NORMAL] = boxes_texture[BOXES_NORMAL];
    yours[SSGI_GL_YOUR_AMBIENT] = boxes_texture[BOXES_AMBIENT];
    for (why = NULL; !glfwWindowShouldClose(window); glfwSwapBuffers(window), glfwPollEvents()) {
        glfwGetFramebufferSize(window, &w, &h);
        if (w < 1 || h < 1) continue; /* minimised */
        if (w != width || h != height) boxes_resize(width = w, height = h), why = resize(w, h);
        boxes_draw(file ? 0.0f : 0.3f * (float)glfwGetTime(), sun, sky, w, h);
        if (why || (why = occlude(boxes_projection, 1, w, h))) return fprintf(stderr, "glfw: %s\n", why), 1;
        boxes_show(w, h);
        if (file && w == 960) return boxes_save(file, w, h);
        if (file) glfwSetWindowSize(window, 960, 540);
    }
}
