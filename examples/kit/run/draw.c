/* draw.c - draws, times, reads back and closes an open run. Declared in kit_gl.h and kit_run.h. */
#include "kit/kit_run.h"
#include <stdlib.h>
#include <string.h>

GLuint kit_pass_texture(const kit_run *run, const kit_pass *p, const char *name)
{
    const struct { const char *name; GLuint texture;
    } table[] = { { "depth", p->gbuffer->depth },
                  { "layers", p->gbuffer->layer_depth },
                  { "back",
                    p->desc.gather.thickness == SSGI_GL_THICKNESS_SLABS ? p->gbuffer->slabs : p->gbuffer->back },
                  { "views", run->view_depth },
                  { "normal", p->desc.light.receiver ? p->gbuffer->layer_normal
                              : run->normal          ? run->normal
                                                     : p->gbuffer->normal },
                  { "albedo", p->desc.light.receiver ? p->gbuffer->layer_albedo
                              : p->gbuffer->albedo   ? p->gbuffer->albedo
                                                     : run->grey },
                  { "direct", p->gbuffer->direct },
                  { "noise", run->noise },
                  { "kernel", run->kernel },
                  { "environment", run->environment },
                  { "irradiance", run->irradiance },
                  { "lights", p->lights },
                  { "occluders", p->lights },
                  { "fields", run->fields },
                  { "cap", run->cap },
                  { "objects", p->gbuffer->object },
                  { "motion", p->gbuffer->motion },
                  { "shadow", run->atlas } };
    for (int k = 0; k < p->step->inputs; ++k)
        if (p->input[k] && !strcmp(name, p->step->input[k].name)) return p->input[k];
    for (size_t i = 0; i < sizeof table / sizeof table[0]; ++i)
        if (!strcmp(name + strlen("t_ssgi_"), table[i].name)) return table[i].texture;
    return 0;
}

GLenum kit_target_of(const ssgi_gl_io *io)
{
    return strstr(io->type, "2DArray")        ? GL_TEXTURE_2D_ARRAY
           : !strcmp(io->type, "samplerCube") ? GL_TEXTURE_CUBE_MAP
                                              : GL_TEXTURE_2D;
}

static void upload(GLuint buffer, const void *data, size_t size)
{
    glBindBuffer(GL_UNIFORM_BUFFER, buffer);
    glBufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)size, data, GL_DYNAMIC_DRAW);
}

void kit_run_update(kit_run *run)
{
    ssgi_gl_frame vpls = run->frame;
    vpls.lights = run->vpls;
    upload(run->block[0], &run->frame, sizeof run->frame);
    for (int i = 0; i < 2 * run->views; ++i) upload(run->block[1 + i], &run->extra[i], sizeof run->extra[i]);
    upload(run->block[KIT_FRAME_VPLS], &vpls, sizeof vpls);
    upload(run->block[KIT_FRAME_VIEWS], &run->cameras, sizeof run->cameras);
}

static void draw_patches(const kit_pass *p)
{
    /* Mesa's rasteriser draws wrong points beyond 65536 of one tessellated draw. */
    const int all = p->patches[0] + p->patches[1], most = kit_gl_is_software() ? 20 : all;
    glPatchParameteri(GL_PATCH_VERTICES, 3);
    for (int first = 0, count; first < all; first += count) {
        const int end = first < p->patches[0] ? p->patches[0] : all;
        count = end - first < most ? end - first : most;
        glDrawArraysInstanced(GL_PATCHES, 3 * first, 3 * count, first < p->patches[0] ? 1 : p->splits * p->splits);
    }
}

/* Draws a pass that makes surfels or splats them, from triangles or from a buffer. */
static void draw_surfels(kit_run *run, const kit_pass *p)
{
    const int capture = p->capture != 0, counted = capture && run->query;
    GLint was;
    GLuint written = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &was);
    glBindVertexArray(p->array);
    if (capture) {
        glEnable(GL_RASTERIZER_DISCARD);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, p->capture);
        if (counted) glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, run->query);
        glBeginTransformFeedback(GL_POINTS);
    }
    if (p->desc.surfel.tessellate) draw_patches(p);
    else if (capture) glDrawArrays(GL_POINTS, 0, (GLsizei)run->surfels);
    else glDrawArraysInstanced(p->step->primitive, 0, p->step->vertices, (GLsizei)run->surfels);
    if (capture) {
        glEndTransformFeedback();
        if (counted) {
            glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
            glGetQueryObjectuiv(run->query, GL_QUERY_RESULT, &written);
            run->surfels = written;
        }
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
        glDisable(GL_RASTERIZER_DISCARD);
    }
    glBindVertexArray((GLuint)was);
}

static void bind_inputs(const kit_run *run, const kit_pass *p)
{
    for (int k = 0; k < p->rows; ++k)
        if (p->io[k].kind == SSGI_GL_IO_TEXTURE) {
            glActiveTexture(GL_TEXTURE0 + (GLenum)p->io[k].slot);
            glBindTexture(kit_target_of(&p->io[k]), kit_pass_texture(run, p, p->io[k].name));
        }
}

int kit_step_part(const ssgi_gl_step *step)
{
    return step->scale == SSGI_GL_SCALE_TILES ? 8 : step->scale == SSGI_GL_SCALE_QUARTER ? 4
                                              : step->scale == SSGI_GL_SCALE_HALF      ? 2
                                                                                     : 1;
}

/* Sets where a pass draws: its framebuffer, the viewport, and a scissor if it has a box. */
static void bind_targets(const kit_run *run, const kit_pass *p)
{
    const ssgi_gl_step *step = p->step;
    const ssgi_gl_frame *f = step->frame && step->frame < KIT_FRAME_VPLS ? &run->extra[step->frame - 1] : &run->frame;
    const int part = kit_step_part(step);
    /* A pass that makes surfels needs any complete framebuffer; a context without a surface has none. */
    glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer ? p->framebuffer : run->pass[run->passes - 1].framebuffer);
    if (step->scale == SSGI_GL_SCALE_LEVELS) glViewport(0, 0, p->width, p->height);
    else glViewport(f->target[0] / part, f->target[1] / part, (f->size[0] + part - 1) / part,
                    (f->size[1] + part - 1) / part);
    if (!p->box[2]) return;
    glEnable(GL_SCISSOR_TEST);
    glScissor(p->box[0], p->box[1], p->box[2], p->box[3]);
}

/* Sets the uniforms outside the uniform block, for a pass whose program is in use, from its rows. */
static void set_values(const kit_run *run, const kit_pass *p)
{
    const int number = p->step->frame;
    ssgi_gl_frame frame = number && number < KIT_FRAME_VPLS ? run->extra[number - 1] : run->frame;
    if (number == KIT_FRAME_VPLS) frame.lights = run->vpls;
    for (int i = 0; i < p->rows; ++i) {
        if (p->io[i].kind != SSGI_GL_IO_PARAM) continue;
        const GLint place = glGetUniformLocation(p->program, p->io[i].name);
        const char *type = p->io[i].type, *array = strchr(type, '[');
        const void *at = (p->io[i].slot ? (const char *)&run->cameras : (const char *)&frame) + p->io[i].offset;
        const GLsizei count = array ? atoi(array + 1) : 1;
        if (!strncmp(type, "mat3", 4)) {
            GLfloat tight[9];
            for (int k = 0; k < 9; ++k) tight[k] = ((const GLfloat *)at)[4 * (k / 3) + k % 3];
            glUniformMatrix3fv(place, 1, GL_FALSE, tight);
        } else if (!strncmp(type, "mat4", 4)) glUniformMatrix4fv(place, count, GL_FALSE, at);
        else if (!strncmp(type, "vec4", 4)) glUniform4fv(place, count, at);
        else if (!strcmp(type, "vec2")) glUniform2fv(place, 1, at);
        else if (!strcmp(type, "ivec2")) glUniform2iv(place, 1, at);
        else if (!strcmp(type, "int")) glUniform1iv(place, 1, at);
        else glUniform1fv(place, 1, at);
    }
}

/* Draws a pass by its compute stage. */
static void dispatch(const kit_pass *p)
{
    const ssgi_gl_output *o = p->step->output;
    for (int i = 0; i < p->step->outputs; ++i)
        glBindImageTexture((GLuint)o[i].binding, o[i].layers ? p->slices : p->target[i], 0, GL_FALSE, o[i].layer,
                           GL_WRITE_ONLY, o[i].format->internal);
    glDispatchCompute((GLuint)p->step->groups[0], (GLuint)p->step->groups[1], 1);
    glMemoryBarrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT | GL_FRAMEBUFFER_BARRIER_BIT);
}

void kit_run_draw(kit_run *run, int timed)
{
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, run->block[KIT_FRAME_VIEWS]);
    if (timed == KIT_FRAME) kit_timer_begin();
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        const ssgi_gl_step *step = p->step;
        if (timed == KIT_FRAME && p->aside) continue;
        bind_inputs(run, p);
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, run->block[step->frame]);
        bind_targets(run, p);
        glUseProgram(p->program);
        if (p->desc.shader.uniforms == SSGI_GL_UNIFORMS_LOOSE) set_values(run, p);
        if (timed == KIT_PASSES && !p->aside) kit_timer_begin();
        if (step->clear)
            for (GLint k = 0; k < step->outputs; ++k)
                glClearBufferfv(GL_COLOR, k, (const GLfloat[4]) { step->clear_to, step->clear_to, step->clear_to,
                                                                  step->clear_to });
        if (step->blend[0]) {
            glEnable(GL_BLEND);
            glBlendEquation(step->blend[0]);
            glBlendFunc(step->blend[1], step->blend[2]);
        }
        if (step->groups[0]) dispatch(p);
        else if (p->array) draw_surfels(run, p);
        else
            glDrawArraysInstanced(step->primitive, 0, step->vertices,
                                  step->instances ? step->instances : p->instances);
        glDisable(GL_BLEND);
        if (timed == KIT_PASSES && !p->aside) p->ms = kit_timer_end();
        if (p->box[2]) glDisable(GL_SCISSOR_TEST);
    }
    if (timed == KIT_FRAME) run->ms = kit_timer_end();
    glActiveTexture(GL_TEXTURE0);
}

GLuint kit_run_input(kit_run *run, const char *name, GLuint instead)
{
    GLuint was = 0;
    for (int i = 0; i < run->passes; ++i)
        for (int k = 0; k < run->pass[i].step->inputs; ++k) {
            GLuint *in = &run->pass[i].input[k];
            if (!*in || strcmp(run->pass[i].step->input[k].name, name)) continue;
            if (!was) was = *in;
            if (instead) *in = instead;
        }
    return was;
}

double kit_run_ms(const kit_run *run)
{
    double ms = 0;
    for (int i = 0; i < run->passes; ++i) ms += run->pass[i].ms;
    return ms;
}

/* ---- >>read ------------------------------------------------------------------------------------------------------ */

/* Cuts `pixels` pixels off each side of an image. */
static void cut(kit_image *image, int pixels)
{
    const int width = image->width - 2 * pixels, height = image->height - 2 * pixels;
    for (int c = 0; c < image->channels; ++c)
        for (int y = 0; y < height; ++y)
            memmove(image->data + ((size_t)c * (size_t)height + (size_t)y) * (size_t)width,
                    image->data + ((size_t)c * (size_t)image->height + (size_t)(y + pixels)) * (size_t)image->width
                        + (size_t)pixels, (size_t)width * sizeof *image->data);
    image->width = width;
    image->height = height;
}

static int coloured(const kit_run *run) { return run->lit || run->pass[0].desc.pass == SSGI_GL_PASS_DEBUG; }

/* Reads a texture of the run, rows top-down, into an image's plane and the next two. less: 1 subtracts it from them. */
static int read_planes(const kit_run *run, GLuint source, kit_image *image, size_t plane, int less)
{
    const size_t pixels = (size_t)image->width * (size_t)image->height, width = (size_t)image->width;
    const size_t components = coloured(run) ? 4 : 1, planes = coloured(run) ? 3 : 1;
    float *texels = malloc(pixels * components * sizeof *texels);
    const int failed = !texels || kit_texture_read(source, image->width, image->height, (int)components, texels);
    for (size_t i = 0; i < pixels && !failed; ++i) {
        const float *from = texels + components * (pixels - (i / width + 1) * width + i % width);
        for (size_t c = 0; c < planes; ++c) {
            float *to = &image->data[(plane + c) * pixels + i];
            *to = less ? *to - from[c] : from[c];
        }
    }
    free(texels);
    return failed;
}

/* Computes the outgoing radiance of the visible surfaces from irradiance, bounce and albedo. */
static int add_radiance(kit_image *image, const kit_gbuffer *g, kit_error *err)
{
    static const char *const names[2][3] = { { "albedo.R", "albedo.G", "albedo.B" },
                                             { "direct.R", "direct.G", "direct.B" } };
    const size_t pixels = (size_t)image->width * (size_t)image->height;
    kit_image frame;
    if (kit_gbuffer_read(&frame, g, err)) return -1;
    const float *z = kit_image_channel(&frame, "Z");
    for (size_t c = 0; c < 3; ++c) {
        const float *albedo = kit_image_channel(&frame, names[0][c]), *direct = kit_image_channel(&frame, names[1][c]);
        const float *irradiance = image->data + (3 + c) * pixels, *bounce = image->data + (6 + c) * pixels;
        for (size_t i = 0; i < pixels; ++i)
            if (z[i] > 0)
                image->data[c * pixels + i] = (albedo ? albedo[i] : 0.8f) * (irradiance[i] + bounce[i])
                                              + (direct ? direct[i] : 0.0f);
    }
    kit_image_free(&frame);
    return 0;
}

int kit_run_read(kit_image *out, const kit_run *run, kit_error *err)
{
    const kit_gbuffer *g = run->gbuffer;
    const kit_pass *last = &run->pass[run->passes ? run->passes - 1 : 0];
    const int width = run->lit ? g->viewport[2] : last->width, height = run->lit ? g->viewport[3] : last->height;
    kit_image image;
    int failed;
    const char *const channels = run->lit ? KIT_LIT_CHANNELS : coloured(run) ? "R,G,B" : "Y";
    if (kit_image_new(&image, width, height, channels, err)) return -1;
    failed = run->light && read_planes(run, run->light, &image, run->lit ? 3 : 0, 0);
    if (run->lit && run->bounce) {
        failed = failed || read_planes(run, run->bounce, &image, 6, 0);
        if (run->joint) failed = failed || read_planes(run, run->joint, &image, 6, 1);
    }
    if (failed || (run->lit && add_radiance(&image, g, err))) {
        kit_image_free(&image);
        return kit_fail(err, "the result cannot be read back");
    }
    cut(&image, run->margin);
    *out = image;
    return 0;
}

/* Frees a run. One that was never opened holds nothing, and there may be no context: GL frees only what exists. */
void kit_run_close(kit_run *run)
{
    for (int i = 0; i < run->passes; ++i) {
        if (run->pass[i].framebuffer) glDeleteFramebuffers(1, &run->pass[i].framebuffer);
        free(run->pass[i].io);
        free(run->pass[i].step);
    }
    for (int v = 0; v < KIT_MAX_VIEWS; ++v) if (run->view[v].depth) kit_gbuffer_free(&run->view[v]);
    if (run->wide.depth) kit_gbuffer_free(&run->wide);
    if (run->textures) glDeleteTextures(run->textures, run->texture);
    if (run->arrays[0]) glDeleteVertexArrays(3, run->arrays);
    if (run->buffers[0]) glDeleteBuffers(3, run->buffers);
    if (run->query) glDeleteQueries(1, &run->query);
    if (run->block[0]) glDeleteBuffers(KIT_FRAMES, run->block);
    free(run->equirect);
    memset(run, 0, sizeof *run);
}
