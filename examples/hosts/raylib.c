/* raylib.c - ambient occlusion in raylib 5 or 6, from its depth: 24 boxes on a slab, in uniform light. The code that
   ssgi needs is between the lines of "===="; (1) to (4) are traps of this engine. Debian, from trixie on:
   libraylib-dev.
     cc examples/hosts/raylib.c -lraylib -lGL -lm -o raylib && ./raylib
   ./raylib FILE.png: one picture, after a change of the window's size. Things that must not be dimmed (interface,
   glass, the player's weapon) are drawn after occlude(), into the same target or onto the screen. */
#define GL_GLEXT_PROTOTYPES /* (1) rlgl has no uniform buffers and few formats, so GL is called directly */
#include <GL/gl.h>
#include <GL/glext.h>
#include <raylib.h>
#include <raymath.h>
#include <rlgl.h>
#include <stdio.h>
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"

/* (2) Makes a target whose depth is a texture: LoadRenderTexture makes it a renderbuffer, which shaders cannot read. */
static RenderTexture2D load_target(int width, int height)
{
    RenderTexture2D target = { .id = rlLoadFramebuffer() };
    const int rgba = PIXELFORMAT_UNCOMPRESSED_R8G8B8A8;
    target.texture = (Texture2D){ rlLoadTexture(NULL, width, height, rgba, 1), width, height, 1, rgba };
    target.depth = (Texture2D){ rlLoadTextureDepth(width, height, false), width, height, 1, 19 };
    rlFramebufferAttach(target.id, target.texture.id, RL_ATTACHMENT_COLOR_CHANNEL0, RL_ATTACHMENT_TEXTURE2D, 0);
    rlFramebufferAttach(target.id, target.depth.id, RL_ATTACHMENT_DEPTH, RL_ATTACHMENT_TEXTURE2D, 0);
    return target;
}

/* ==== ssgi ======================================================================================================== */
enum { MOST = SSGI_GL_MAX_STEPS };
static ssgi_gl_step step[MOST];
static int steps;
static GLuint program[MOST], framebuffer[MOST], texture[MOST], block, array;

/* Call it when the size changes. picture: a texture of sRGB-encoded values, which the last step multiplies. */
static const char *resize(GLuint picture, int width, int height)
{
    static char text[2][32768];
    ssgi_gl_chain chain = { .blur = 1, .width = width, .height = height };
    const char *why = "";
    chain.desc.pass = SSGI_GL_PASS_HSAO;
    chain.desc.input.normal = SSGI_GL_NORMAL_FROM_DEPTH;
    chain.desc.filter.onto = SSGI_GL_ONTO_MULTIPLY_SRGB;
    if (ssgi_gl_preset(&chain.desc, SSGI_GL_PRESET_BALANCED, &why)) return why;
    if (!(steps = ssgi_gl_steps(step, MOST, &chain, &why))) return why;
    if (steps > MOST) return "the chain has more steps than SSGI_GL_MAX_STEPS";
    if (!block) {
        glGenBuffers(1, &block), glGenVertexArrays(1, &array);
        glGenTextures(MOST, texture), glGenFramebuffers(MOST, framebuffer);
    }
    for (int i = 0; i < steps; ++i) {
        const ssgi_gl_output *to = step[i].output; /* hsao's steps have one output each; texture -1: the image */
        const GLuint into = to->texture < 0 ? picture : texture[to->texture];
        glBindTexture(GL_TEXTURE_2D, into);
        if (to->texture >= 0) {
            glTexImage2D(GL_TEXTURE_2D, 0, (GLint)to->format->internal, step[i].width, step[i].height, 0,
                         to->format->format, to->format->type, NULL);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[i]);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, into, 0);
        if (program[i]) continue;
        for (int k = 0; k < 2; ++k) ssgi_gl_emit(text[k], sizeof text[k], &step[i].desc, k);
        program[i] = LoadShaderFromMemory(text[SSGI_GL_STAGE_VERTEX], text[SSGI_GL_STAGE_FRAGMENT]).id;
        glUseProgram(program[i]);
        glUniformBlockBinding(program[i], glGetUniformBlockIndex(program[i], "ssgi_frame"), 0);
        for (int k = 0; k < step[i].inputs; ++k)
            glUniform1i(glGetUniformLocation(program[i], step[i].input[k].name), step[i].input[k].unit);
    }
    return NULL;
}

/* Call it every frame, with the projection that depth was drawn with: rlGetMatrixProjection() within BeginMode3D. */
static const char *occlude(GLuint depth, Matrix projection, float radius, int width, int height)
{
    ssgi_view view;
    ssgi_gl_frame frame;
    const char *why = "";
    if (ssgi_view_from_projection(&view, MatrixToFloat(projection), SSGI_CLIP_GL, width, height, &why)) return why;
    if (ssgi_gl_frame_init(&frame, &view, radius, &why)) return why;
    rlDrawRenderBatchActive(); /* (3) draws raylib's pending batch first */
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, block);
    glBufferData(GL_UNIFORM_BUFFER, sizeof frame, &frame, GL_DYNAMIC_DRAW);
    glBindVertexArray(array);
    glDisable(GL_DEPTH_TEST), glDisable(GL_CULL_FACE), glDisable(GL_BLEND);
    for (const ssgi_gl_step *s = step; s < step + steps; ++s) {
        for (const ssgi_gl_input *in = s->input; in < s->input + s->inputs; ++in) { /* raylib gives only depth */
            glActiveTexture(GL_TEXTURE0 + (GLenum)in->unit);
            glBindTexture(in->target, in->texture < 0 ? depth : texture[in->texture]);
        }
        if (s->blend[0]) glEnable(GL_BLEND), glBlendEquation(s->blend[0]), glBlendFunc(s->blend[1], s->blend[2]);
        glBindFramebuffer(GL_FRAMEBUFFER, framebuffer[s - step]), glViewport(0, 0, s->width, s->height);
        glUseProgram(program[s - step]), glDrawArraysInstanced(s->primitive, 0, s->vertices, s->instances);
    }
    /* (4) rlgl caches GL's state, so GL's is restored */
    glBindVertexArray(0), glUseProgram(0), glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glActiveTexture(GL_TEXTURE0), glEnable(GL_BLEND), glEnable(GL_CULL_FACE);
    glBlendEquation(GL_FUNC_ADD), glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    return NULL;
}
/* ================================================================================================================== */

int main(int argc, char **argv)
{
    RenderTexture2D target = { 0 };
    const Camera3D camera = { { 0, 6, 8 }, { 0, 0, 0 }, { 0, 1, 0 }, 45, CAMERA_PERSPECTIVE };
    const char *why = NULL;
    SetTraceLogLevel(LOG_WARNING);
    SetConfigFlags(FLAG_WINDOW_RESIZABLE);
    InitWindow(800, 450, "ssgi");
    rlSetClipPlanes(0.1, 100);
    for (int k = 0; !WindowShouldClose() && !why; ++k) {
        const int width = GetScreenWidth(), height = GetScreenHeight();
        if (width != target.texture.width || height != target.texture.height) {
            if (target.id) UnloadRenderTexture(target);
            target = load_target(width, height);
            why = resize(target.texture.id, width, height);
        }
        BeginTextureMode(target);
        ClearBackground(WHITE);
        BeginMode3D(camera);
        const Matrix projection = rlGetMatrixProjection();
        for (int i = 0; i < 25; ++i) {
            const float high = 0.2f + 0.2f * (float)(i * 7 % 5);
            const Vector3 at = { 1.5f * (float)(i % 5 - 2), high, 1.5f * (float)(i / 5 - 2) }, slab = { 0, -0.1f, 0 };
            if (i) DrawCube(at, 0.7f + 0.1f * (float)(i * 3 % 8), 2 * high, 0.7f + 0.1f * (float)(i * 5 % 7), WHITE);
            else DrawCube(slab, 9, 0.2f, 9, WHITE);
        }
        EndMode3D();
        EndTextureMode();
        if (!why) why = occlude(target.depth.id, projection, 1, width, height);
        BeginDrawing();
        DrawTextureRec(target.texture, (Rectangle){ 0, 0, (float)width, (float)-height }, (Vector2){ 0, 0 }, WHITE);
        EndDrawing();
        if (argc < 2) continue;
        if (width != 960) { SetWindowSize(960, 540); continue; }
        Image picture = LoadImageFromTexture(target.texture);
        ImageFlipVertical(&picture);
        ExportImage(picture, argv[1]);
        break;
    }
    if (why) fprintf(stderr, "raylib: %s\n", why);
    return why != NULL;
}
