/* passes.c - makes a chain's steps into passes: programs, framebuffers, targets. Declared in kit_gl.h and kit_run.h. */
#include "kit/kit_run.h"
#include <stdlib.h>
#include <string.h>

int kit_dialect(void) { return kit_gl_is_es() ? SSGI_GL_DIALECT_300ES : SSGI_GL_DIALECT_330; }

int kit_compute(void)
{
    const char *const asked = getenv("KIT_COMPUTE");
    if (!asked || kit_gl_is_es()) return SSGI_GL_COMPUTE_NONE;
    return strcmp(asked, "BASIC") ? SSGI_GL_COMPUTE_ALL : SSGI_GL_COMPUTE_BASIC;
}

/* Links the stages of a pass to a program without transform feedback; 0 on failure. */
static GLuint link_stages(const ssgi_gl_desc *desc, kit_error *err)
{
    static const GLenum kinds[SSGI_GL_STAGES] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, GL_TESS_CONTROL_SHADER,
                                                  GL_TESS_EVALUATION_SHADER, GL_GEOMETRY_SHADER,
                                                  GL_COMPUTE_SHADER };
    char *text[SSGI_GL_STAGES];
    const char *source[SSGI_GL_STAGES];
    GLenum stages[SSGI_GL_STAGES];
    GLuint program = 0;
    int count = 0, failed = 0;
    for (int s = 0; s < SSGI_GL_STAGES && !failed; ++s) {
        const size_t n = ssgi_gl_emit(NULL, 0, desc, s);
        if (!n) continue;
        text[count] = malloc(n + 1);
        failed = !text[count];
        if (failed) break;
        ssgi_gl_emit(text[count], n + 1, desc, s);
        source[count] = text[count];
        stages[count++] = kinds[s];
    }
    if (failed) kit_fail(err, "out of memory"); else program = kit_program(source, stages, count, err);
    for (int i = 0; i < count; ++i) free(text[i]);
    return program;
}

/* Names the outputs that transform feedback captures, and links again. */
static int link_captures(GLuint program, const ssgi_gl_desc *desc, const ssgi_gl_io *io, int rows, kit_error *err)
{
    const char *captured[3];
    GLint linked = 0;
    int captures = 0;
    for (int i = 0; i < rows; ++i) if (io[i].kind == SSGI_GL_IO_CAPTURE) captured[captures++] = io[i].name;
    if (!captures) return 0;
    glTransformFeedbackVaryings(program, captures, captured, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &linked);
    return linked ? 0
                  : kit_fail(err, "pass %s: its varyings cannot be captured by %s", ssgi_gl_pass_name(desc->pass),
                             kit_gl_name());
}

void kit_pass_bind(GLuint program, const ssgi_gl_io *io, int rows)
{
    glUseProgram(program);
    for (int i = 0; i < rows; ++i)
        if (io[i].kind == SSGI_GL_IO_TEXTURE) glUniform1i(glGetUniformLocation(program, io[i].name), io[i].slot);
    for (GLuint k = 0; k < 2; ++k) {
        const GLuint block = glGetUniformBlockIndex(program, k ? "ssgi_views" : "ssgi_frame");
        if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, k);
    }
}

GLuint kit_pass_program(const ssgi_gl_desc *desc, kit_error *err)
{
    const char *why = "";
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    if (ssgi_gl_check(desc, &why) != SSGI_OK) { kit_fail(err, "%s", why); return 0; }
    const int rows = ssgi_gl_reflect(desc, io, SSGI_GL_MAX_IO);
    const GLuint program = link_stages(desc, err);
    if (!program) return 0;
    if (link_captures(program, desc, io, rows, err)) { glDeleteProgram(program); return 0; }
    kit_pass_bind(program, io, rows);
    return program;
}

int kit_pass_make(kit_pass *p, kit_error *err)
{
    const int rows = ssgi_gl_reflect(&p->desc, NULL, 0);
    ssgi_gl_io *io = malloc((size_t)(rows + 1) * sizeof *io);
    if (!io) return kit_fail(err, "out of memory");
    if (!p->program) p->program = kit_pass_program(&p->desc, err);
    if (!p->program) { free(io); return -1; }
    free(p->io);
    p->io = io;
    p->rows = ssgi_gl_reflect(&p->desc, io, rows);
    return 0;
}

GLuint kit_keep(kit_run *run, GLuint texture)
{
    if (texture && run->textures < KIT_MAX_TEXTURES) run->texture[run->textures++] = texture;
    return texture;
}

ssgi_gl_chain kit_chain(const kit_making *m)
{
    ssgi_gl_chain chain;
    memset(&chain, 0, sizeof chain);
    chain.desc = m->desc;
    chain.desc.input.motion = m->kept && m->run->gbuffer->motion;
    chain.width = m->run->gbuffer->viewport[2];
    chain.height = m->run->gbuffer->viewport[3];
    chain.blur = m->blurred > 0;
    chain.history = m->kept;
    chain.precise = 1;
    return chain;
}

/* Returns the extra camera of a step; -1: it is the main camera's. */
static int camera_of(const ssgi_gl_step *step)
{
    return step->frame && step->frame < KIT_FRAME_VPLS ? (step->frame - 1) / 2 : -1;
}

/* Makes a pass's framebuffer and its targets, cleared to black. textures: by the steps' numbers; 0 = not yet made. */
static int add_targets(kit_making *m, kit_pass *p, GLuint textures[])
{
    kit_run *run = m->run;
    const ssgi_gl_step *step = p->step;
    const kit_gbuffer *widest = camera_of(step) < 0 ? run->gbuffer : &run->view[0];
    GLenum attachment[KIT_MAX_TARGETS];
    glGenFramebuffers(1, &p->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer);
    for (int i = 0; i < step->outputs; ++i) {
        const ssgi_gl_output *o = &step->output[i];
        const GLenum format = o->format->internal;
        GLuint *made = &textures[o->texture];
        attachment[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        if (o->layers) {
            if (!*made)
                *made = kit_keep(run, kit_texture_array(widest->viewport[2], widest->viewport[3], o->layers, format,
                                                        NULL));
            p->slices = *made;
            glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment[i], *made, 0, o->layer);
            continue;
        }
        *made = p->target[i] = kit_keep(run, kit_texture(p->width, p->height, format, NULL));
        if (o->kept) p->last[i] = kit_keep(run, kit_texture(p->width, p->height, format, NULL));
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment[i], GL_TEXTURE_2D, *made, 0);
    }
    glDrawBuffers(step->outputs, attachment);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
        return kit_fail(m->err, "%s cannot draw into the targets of pass %s", kit_gl_name(),
                        ssgi_gl_pass_name(step->desc.pass));
    for (int i = 0; i < step->outputs; ++i)
        if (step->output[i].format->type != GL_UNSIGNED_INT)
            glClearBufferfv(GL_COLOR, i, (const GLfloat[4]) { 0, 0, 0, 0 });
    return 0;
}

/* Adds a step as a pass: its program and targets. */
static int add_pass(kit_making *m, const ssgi_gl_step *step, GLuint textures[], int aside)
{
    kit_run *run = m->run;
    kit_pass *p = &run->pass[run->passes];
    const int camera = camera_of(step);
    const kit_gbuffer *g = camera < 0 ? run->gbuffer : &run->view[camera];
    const uint64_t key = ssgi_gl_key(&step->desc);
    if (run->passes == KIT_MAX_PASSES)
        return kit_fail(m->err, "method %s: more than %d passes", m->method->name, KIT_MAX_PASSES);
    memset(p, 0, sizeof *p);
    p->step = malloc(sizeof *p->step);
    if (!p->step) return kit_fail(m->err, "out of memory");
    *p->step = *step;
    p->desc = step->desc;
    p->gbuffer = g;
    p->aside = aside;
    p->lights = m->rows[1 + camera];
    p->width = camera < 0 ? step->width : g->viewport[2];
    p->height = camera < 0 ? step->height : g->viewport[3];
    p->program = kit_program_kept(key);
    const int compiled = !p->program;
    if (kit_pass_make(p, m->err) || (compiled && kit_program_keep(key, p->program, m->err))) {
        free(p->step);
        return -1;
    }
    ++run->passes;
    return step->outputs ? add_targets(m, p, textures) : 0;
}

/* Connects a pass's inputs and finds the result. last: the last frame's textures by step number; 0 = not kept. */
static void connect(kit_pass *p, const GLuint textures[], const GLuint last[], GLuint *light, GLuint *bounce)
{
    const ssgi_gl_step *step = p->step;
    for (int k = 0; k < step->inputs; ++k) {
        const ssgi_gl_input *in = &step->input[k];
        if (in->texture < 0) continue;
        p->input[k] = in->last && last[in->texture] ? last[in->texture] : textures[in->texture];
    }
    for (int o = 0; o < step->outputs; ++o) {
        if (step->output[o].result == SSGI_GL_RESULT_LIGHT && light) *light = p->target[o];
        if (step->output[o].result == SSGI_GL_RESULT_BOUNCE && bounce) *bounce = p->target[o];
    }
}

int kit_add_steps(kit_making *m, const ssgi_gl_chain *chain, int aside, GLuint *light, GLuint *bounce)
{
    kit_run *run = m->run;
    const char *why = "out of memory";
    GLuint textures[KIT_MAX_TEXTURES] = { 0 }, last[KIT_MAX_TEXTURES] = { 0 };
    const int first = run->passes, count = ssgi_gl_steps(NULL, 0, chain, &why);
    ssgi_gl_step *step = malloc((size_t)(count + 1) * sizeof *step);
    int failed = !count || !step;
    if (failed) kit_fail(m->err, "method %s: %s", m->method->name, why);
    else ssgi_gl_steps(step, count, chain, NULL);
    /* passes aside compute a part of the result for tests, not for an embedder; passes of lights are drawn anyway */
    for (int i = 0; i < count && !failed; ++i)
        failed = add_pass(m, &step[i], textures, aside && step[i].desc.pass != SSGI_GL_PASS_LIGHTS);
    for (int i = first; i < run->passes; ++i)
        for (int o = 0; o < KIT_HISTORIES; ++o)
            if (run->pass[i].last[o]) last[run->pass[i].step->output[o].texture] = run->pass[i].last[o];
    for (int i = 0; i < count && !failed; ++i) connect(&run->pass[first + i], textures, last, light, bounce);
    if (!aside && run->chains < 2) run->chain[run->chains++] = *chain;
    free(step);
    return failed ? -1 : 0;
}
