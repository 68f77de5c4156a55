/* run.c - a method on a G-buffer: programs, targets, drawing, timing, reading back; frames.c: one frame after another.
   Declared in kit_gl.h. */
#include "kit/kit_run.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>run ------------------------------------------------------------------------------------------------------ */

int kit_dialect(void) { return kit_gl_is_es() ? SSGI_GL_300ES : SSGI_GL_330; }

GLuint kit_pass_program(const ssgi_gl_desc *desc, kit_error *err)
{
    static const GLenum kinds[SSGI_GL_STAGES] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, GL_TESS_CONTROL_SHADER,
                                                  GL_TESS_EVALUATION_SHADER, GL_GEOMETRY_SHADER };
    char *text[SSGI_GL_STAGES];
    const char *source[SSGI_GL_STAGES], *captured[3], *why = "";
    GLenum stages[SSGI_GL_STAGES];
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    GLuint program = 0, block;
    int count = 0, captures = 0, failed = 0;
    if (ssgi_gl_check(desc, &why) != SSGI_OK) { kit_fail(err, "%s", why); return 0; }
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
    if (!program) return 0;
    for (int i = 0, n = ssgi_gl_reflect(desc, io, SSGI_GL_MAX_IO); i < n; ++i)
        if (io[i].kind == SSGI_GL_CAPTURE) captured[captures++] = io[i].name;
    if (captures) {
        glTransformFeedbackVaryings(program, captures, captured, GL_INTERLEAVED_ATTRIBS);
        GLint linked = 0;
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &linked);
        if (!linked) {
            kit_fail(err, "pass %s: its varyings cannot be captured by %s", ssgi_gl_pass_name(desc->pass),
                     kit_gl_name());
            glDeleteProgram(program);
            return 0;
        }
    }
    glUseProgram(program);
    for (int i = 0, n = ssgi_gl_reflect(desc, io, SSGI_GL_MAX_IO); i < n; ++i)
        if (io[i].kind == SSGI_GL_TEXTURE) glUniform1i(glGetUniformLocation(program, io[i].name), io[i].slot);
    for (GLuint k = 0; k < 2; ++k) {
        block = glGetUniformBlockIndex(program, k ? "ssgi_views" : "ssgi_frame");
        if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, k);
    }
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

/* A step's program, framebuffer and targets; textures: what its steps' numbers are, 0 = not yet. NULL on failure. */
static kit_pass *add_pass(kit_making *m, const ssgi_gl_step *step, GLuint textures[], int aside)
{
    kit_run *run = m->run;
    kit_pass *p = &run->pass[run->passes];
    const int camera = step->frame && step->frame < KIT_FRAME_VPLS ? (step->frame - 1) / 2 : -1;
    const kit_gbuffer *g = camera < 0 ? run->gbuffer : &run->view[camera];
    const uint64_t key = ssgi_gl_key(&step->desc);
    GLenum attachment[KIT_MAX_TARGETS];
    if (run->passes == KIT_MAX_PASSES) {
        kit_fail(m->err, "method %s: more than %d passes", m->method->name, KIT_MAX_PASSES);
        return NULL;
    }
    memset(p, 0, sizeof *p);
    p->step = malloc(sizeof *p->step);
    if (!p->step) { kit_fail(m->err, "out of memory"); return NULL; }
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
        return NULL;
    }
    ++run->passes;
    if (!step->outputs) return p;
    glGenFramebuffers(1, &p->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer);
    for (int i = 0; i < step->outputs; ++i) {
        const ssgi_gl_output *o = &step->output[i];
        GLuint *made = &textures[o->texture];
        attachment[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        if (o->slices) {
            const kit_gbuffer *widest = camera < 0 ? g : &run->view[0];
            if (!*made)
                *made = kit_keep(run, kit_texture_array(widest->viewport[2], widest->viewport[3], o->slices,
                                                        o->format->internal, NULL));
            p->slices = *made;
            glFramebufferTextureLayer(GL_FRAMEBUFFER, attachment[i], *made, 0, o->slice);
            continue;
        }
        *made = p->target[i] = kit_keep(run, kit_texture(p->width, p->height, o->format->internal, NULL));
        if (o->kept) p->last[i] = kit_keep(run, kit_texture(p->width, p->height, o->format->internal, NULL));
        glFramebufferTexture2D(GL_FRAMEBUFFER, attachment[i], GL_TEXTURE_2D, *made, 0);
    }
    glDrawBuffers(step->outputs, attachment);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        kit_fail(m->err, "%s cannot draw into the targets of pass %s", kit_gl_name(),
                 ssgi_gl_pass_name(step->desc.pass));
        return NULL;
    }
    for (int i = 0; i < step->outputs; ++i)
        if (step->output[i].format->type != GL_UNSIGNED_INT)
            glClearBufferfv(GL_COLOR, i, (const GLfloat[4]) { 0, 0, 0, 0 });
    if (step->desc.pass != SSGI_GL_SPLAT && !aside)
        run->fetches += kit_fetches(&step->desc) * (double)p->width * p->height
                        / ((double)run->frame.size[0] * run->frame.size[1]);
    return p;
}

ssgi_gl_chain kit_chain(const kit_making *m)
{
    ssgi_gl_chain chain;
    memset(&chain, 0, sizeof chain);
    chain.desc = m->gather;
    chain.desc.motion = m->kept && m->run->gbuffer->motion;
    chain.width = m->run->gbuffer->viewport[2];
    chain.height = m->run->gbuffer->viewport[3];
    chain.blur = m->blurred > 0;
    chain.history = m->kept;
    chain.precise = 1;
    return chain;
}

int kit_add_steps(kit_making *m, const ssgi_gl_chain *chain, int aside, GLuint *light, GLuint *bounce)
{
    kit_run *run = m->run;
    const char *why = "out of memory";
    GLuint textures[KIT_MAX_TEXTURES] = { 0 };
    const int first = run->passes, count = ssgi_gl_steps(NULL, 0, chain, &why);
    ssgi_gl_step *step = malloc((size_t)(count + 1) * sizeof *step);
    int failed = !count || !step;
    if (failed) kit_fail(m->err, "method %s: %s", m->method->name, why);
    else ssgi_gl_steps(step, count, chain, NULL);
    /* parts are told apart by passes that embedders would not draw; lights are drawn all the same */
    for (int i = 0; i < count && !failed; ++i)
        failed = !add_pass(m, &step[i], textures, aside && step[i].desc.pass != SSGI_GL_LIGHTS);
    for (int i = 0; i < count && !failed; ++i) {
        kit_pass *p = &run->pass[first + i];
        for (int k = 0; k < step[i].inputs; ++k) {
            const ssgi_gl_input *in = &step[i].input[k];
            if (in->texture >= 0) p->input[k] = textures[in->texture];
            for (int o = 0; o < step[i].outputs && in->texture >= 0 && in->last; ++o)
                if (step[i].output[o].texture == in->texture) p->input[k] = p->last[o];
        }
        for (int o = 0; o < step[i].outputs; ++o) {
            if (step[i].output[o].result == SSGI_GL_RESULT_LIGHT && light) *light = p->target[o];
            if (step[i].output[o].result == SSGI_GL_RESULT_BOUNCE && bounce) *bounce = p->target[o];
        }
    }
    free(step);
    return failed ? -1 : 0;
}

/* What a row names: a texture of the steps, or of the G-buffer, or of the run. */
static GLuint texture_of(const kit_run *run, const kit_pass *p, const char *name)
{
    const struct { const char *name; GLuint texture;
    } table[] = { { "depth", p->gbuffer->depth },
                  { "layers", p->gbuffer->layer_depth },
                  { "back", p->desc.thickness == SSGI_GL_THICKNESS_SLABS ? p->gbuffer->slabs : p->gbuffer->back },
                  { "views", run->view_depth },
                  { "normal", p->desc.receiver ? p->gbuffer->layer_normal : p->gbuffer->normal },
                  { "albedo", p->desc.receiver     ? p->gbuffer->layer_albedo
                              : p->gbuffer->albedo ? p->gbuffer->albedo
                                                   : run->grey },
                  { "direct", p->gbuffer->direct },
                  { "noise", run->noise },
                  { "kernel", run->kernel },
                  { "environment", run->environment },
                  { "irradiance", run->irradiance },
                  { "lights", p->lights },
                  { "occluders", p->lights },
                  { "fields", run->fields },
                  { "objects", p->gbuffer->object },
                  { "motion", p->gbuffer->motion },
                  { "shadow", run->atlas } };
    for (int k = 0; k < p->step->inputs; ++k)
        if (p->input[k] && !strcmp(name, p->step->input[k].name)) return p->input[k];
    for (size_t i = 0; i < sizeof table / sizeof table[0]; ++i)
        if (!strcmp(name + strlen("t_ssgi_"), table[i].name)) return table[i].texture;
    return 0;
}

static GLenum target_of(const ssgi_gl_io *io)
{
    return strstr(io->type, "2DArray")        ? GL_TEXTURE_2D_ARRAY
           : !strcmp(io->type, "samplerCube") ? GL_TEXTURE_CUBE_MAP
                                              : GL_TEXTURE_2D;
}

/* Bytes of a texel, and how many texels there are. */
static double texel_of(double *texels, GLuint texture, GLenum target)
{
    static const GLenum bits_of[] = { GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                                      GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE };
    const GLenum face = target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target;
    GLint size[3] = { 0 }, bits = 0, all = 0;
    glBindTexture(target, texture);
    for (GLenum i = 0; i < 2; ++i) glGetTexLevelParameteriv(face, 0, GL_TEXTURE_WIDTH + i, &size[i]);
    glGetTexLevelParameteriv(face, 0, GL_TEXTURE_DEPTH, &size[2]);
    for (size_t i = 0; i < sizeof bits_of / sizeof *bits_of; ++i, all += bits)
        glGetTexLevelParameteriv(face, 0, bits_of[i], &bits);
    glBindTexture(target, 0);
    *texels = (double)size[0] * size[1] * (target == GL_TEXTURE_CUBE_MAP ? 6 : size[2]);
    return all / 8.0;
}

/* The pixels of its targets that a pass draws. */
static double drawn_by(const kit_pass *p)
{
    return p->box[2] ? (double)p->box[2] * p->box[3] : (double)p->width * p->height;
}

/* Those of the picture. */
static double shown_by(const kit_run *run)
{
    return (double)(run->frame.size[0] - 2 * run->margin) * (run->frame.size[1] - 2 * run->margin);
}

static double bytes_of(const kit_run *run)
{
    double bytes = 0;
    for (int i = 0; i < run->passes; ++i) {
        const kit_pass *p = &run->pass[i];
        const int splats = p->desc.pass == SSGI_GL_SPLAT;
        for (int k = 0; k < (p->aside ? 0 : p->rows); ++k) {
            const ssgi_gl_io *io = &p->io[k];
            const kit_gbuffer *g = p->gbuffer;
            const int in = io->kind == SSGI_GL_TEXTURE;
            GLuint texture;
            int slices;
            double texels, texel;
            if (!in && (io->kind != SSGI_GL_OUTPUT || !p->framebuffer)) continue;
            /* without targets of its own it draws into a slice */
            texture = in ? texture_of(run, p, io->name) : p->target[0] ? p->target[io->slot] : p->slices;
            if (!texture) continue;
            /* of the G-buffer's farther layers */
            slices = texture == g->layer_depth ? p->desc.layers - 1 : texture == g->layer_normal
                || texture == g->layer_albedo;
            texel = texel_of(&texels, texture, in ? target_of(io) : p->target[0] ? GL_TEXTURE_2D : GL_TEXTURE_2D_ARRAY);
            if (slices) texels *= (double)slices / (g->layers - 1);
            if (!in) texels = splats ? 2 * run->splat_pixels : drawn_by(p);
            bytes += texel * texels;
        }
        if (splats || p->capture) bytes += (double)run->surfels * sizeof(ssgi_surfel);
    }
    return bytes / shown_by(run);
}

/* ---- >>margin: what is seen beyond the picture ------------------------------------------------------------------ */

static int by_value(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* How wide a margin is, in pixels: see kit_run_open. Where the border shows nothing, depth is what all of the picture
   shows; 0 where that shows nothing either. */
static int margin_of(int *pixels, const kit_gbuffer *g, double radius, double margin, kit_error *err)
{
    const int width = g->viewport[2], height = g->viewport[3], most = (width < height ? width : height) / 16 * 4;
    kit_image frame;
    float *depth, *z;
    size_t count = 0;
    double wide = 0;
    if (kit_gbuffer_read(&frame, g, err)) return -1;
    z = kit_image_channel(&frame, "Z");
    depth = malloc((size_t)width * (size_t)height * sizeof *depth);
    for (int all = 0; all < 2 && depth && !count; ++all)
        for (int i = 0; i < width * height; ++i) {
            const int x = i % width, y = i / width, border = !x || !y || x == width - 1 || y == height - 1;
            if (z[i] > 0 && (border || all)) depth[count++] = z[i];
        }
    if (count) {
        qsort(depth, count, sizeof *depth, by_value);
        wide = 0.5 * height * (double)g->projection[5] * radius * margin;
        if (g->camera.fovy > 0) wide /= (double)depth[count / 2];
    }
    kit_image_free(&frame);
    if (!depth) return kit_fail(err, "out of memory");
    free(depth);
    *pixels = wide < most ? 4 * (int)ceil(wide / 4) : most;
    return 0;
}

/* The G-buffer that a method's margin asks for, in place of *g. pixels: its width, -1: to be measured. */
static int add_margin(kit_making *m, kit_gbuffer **g, float radius, int pixels)
{
    kit_run *run = m->run;
    const double margin = kit_method_value(m->method, "margin");
    if (!(margin > 0)) return 0;
    if (!m->world->scene)
        return kit_fail(m->err, "--set margin=%g: a frame holds nothing beyond its border; it needs a scene", margin);
    if (pixels >= 0) run->margin = pixels;
    else if (margin_of(&run->margin, *g, (double)radius, margin, m->err)) return -1;
    if (!run->margin) return 0;
    if (kit_gbuffer_widen(&run->wide, *g, m->world->scene, run->margin, m->err)) return -1;
    *g = &run->wide;
    return 0;
}

static int draws(const kit_pass *p, GLuint texture)
{
    for (int k = 0; texture && k < KIT_MAX_TARGETS; ++k) if (p->target[k] == texture) return 1;
    return 0;
}

/* With a margin: what each pass draws. The result's: the picture; what a filter reads: as far as it reaches; senders,
   and what they are lit by: all of what is seen. */
static void limit_passes(kit_run *run)
{
    enum { ALL = 1 << 20 };
    int rim[KIT_MAX_PASSES], changed = 1;
    const double shown = shown_by(run);
    if (!run->margin) return;
    for (int i = 0; i < run->passes; ++i) {
        const kit_pass *p = &run->pass[i];
        const int result = draws(p, run->light) || draws(p, run->bounce) || draws(p, run->joint);
        rim[i] = !p->target[0] || p->gbuffer != run->gbuffer ? ALL : result ? 0 : -1;
    }
    while (changed) {
        changed = 0;
        for (int j = 0; j < run->passes; ++j) {
            const kit_pass *p = &run->pass[j];
            const int reach = rim[j] + (p->desc.pass == SSGI_GL_BLUR ? 2 * p->desc.filter_radius + 2 : 0);
            const int wanted = reach < ALL ? reach : ALL;
            for (int i = 0; i < run->passes && rim[j] >= 0; ++i) {
                int read = 0;
                for (int k = 0; k < p->step->inputs; ++k) read |= draws(&run->pass[i], p->input[k]);
                if (!read || rim[i] >= wanted) continue;
                rim[i] = wanted;
                changed = 1;
            }
        }
    }
    run->fetches = 0;
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        const int half = p->step->size == SSGI_GL_SIZE_HALF, from = run->margin - rim[i];
        for (int k = 0; k < 2 && rim[i] >= 0 && from > 0; ++k) {
            const int to = run->frame.size[k] - from;
            p->box[k] = half ? from / 2 : from;
            p->box[2 + k] = (half ? (to + 1) / 2 : to) - p->box[k];
        }
        if (!p->aside) run->fetches += kit_fetches(&p->desc) * drawn_by(p) / shown;
    }
}

/* ---- >>open ------------------------------------------------------------------------------------------------------ */

/* What there is to draw on a G-buffer, the caller's or a wider one. */
static int open_on(kit_making *m, kit_gbuffer *g, float radius)
{
    kit_run *run = m->run;
    ssgi_view view;
    const char *why = "";
    float picture[16], projection[16];
    int failed;
    if (kit_view_of(&view, g->projection, g->camera.depth, g->viewport[2], g->viewport[3], m->err)) return -1;
    if (ssgi_gl_frame_init(&run->frame, &view, radius, &why) != SSGI_OK) return kit_fail(m->err, "%s", why);
    run->gbuffer = g;
    run->lit = m->method->lit;
    run->frame.origin[0] = g->viewport[0];
    run->frame.origin[1] = g->viewport[1];
    m->gather.dialect = kit_dialect();
    m->gather.orthographic = view.orthographic;
    m->gather.depth = g->depth_is_linear ? SSGI_GL_DEPTH_LINEAR : SSGI_GL_DEPTH_WINDOW;
    if (kit_settings_apply(m, radius)) return -1;
    if (m->gather.half && !m->blurred)
        return kit_fail(m->err, "--set half=1: needs blur=1 or more, which brings it to full size");
    if (m->gather.layers > g->layers && !m->world->scene)
        return kit_fail(m->err, "--set layers=%d: the frame has %d", m->gather.layers, g->layers);
    if (m->gather.views && !m->world->scene)
        return kit_fail(m->err, "--set views=%d: a frame has one camera; extra ones need a scene", m->gather.views);
    if (m->gather.layers > g->layers && kit_gbuffer_peel(g, m->world->scene, m->gather.layers, m->err)) return -1;
    if (m->gather.thickness >= SSGI_GL_THICKNESS_BACK) {
        const int two = m->gather.thickness == SSGI_GL_THICKNESS_SLABS, missing = !(two ? g->slabs : g->back);
        if (missing && !m->world->scene)
            return kit_fail(m->err, "--set behind=%s: the frame has no channel %s", two ? "slabs" : "back",
                            g->back ? "front2.Z" : "back.Z");
        if (missing && kit_gbuffer_slabs(g, m->world->scene, 1 + two, m->err)) return -1;
    }
    kit_camera_matrices(&g->camera, picture, projection);
    if (run->lit && m->gather.pass != SSGI_GL_SPLAT) {
        failed = kit_open_lit(m, picture);
    } else if (m->gather.pass == SSGI_GL_FIELD) {
        failed = kit_open_field(m, picture);
    } else if (m->gather.pass == SSGI_GL_SPLAT) {
        failed = kit_open_deep(m, &view, picture);
    } else {
        kit_sight seen = { .point = NULL };
        const ssgi_gl_chain chain = kit_chain(m);
        failed = m->gather.views && (kit_seen(g, &seen, m->err) || kit_add_views(m, picture, &seen.middle));
        free(seen.point);
        failed = failed || kit_add_steps(m, &chain, 0, &run->light, NULL);
    }
    if (m->gather.kernel) {
        const int sets = (int)kit_method_value(m->method, "sets");
        float *kernel = malloc(4 * (size_t)(sets * m->gather.samples) * sizeof *kernel);
        if (kernel) ssgi_kernel(kernel, sets, m->gather.samples, NULL);
        run->kernel = kit_keep(run, kernel ? kit_texture(m->gather.samples, sets, GL_RGBA32F, kernel) : 0);
        free(kernel);
    }
    if (m->gather.noise == SSGI_GL_NOISE_TEXTURE) {
        float tile[4 * 16] = { 0 };        /* both strata once each over the 4 x 4 texels, far apart in neighbours */
        for (int i = 0; i < 16; ++i) {
            const int x = i % 4, y = i / 4, a = (2 * x + y) % 4, b = (x + 2 * y) % 4;
            tile[4 * i + 2] = ((float)(4 * b + a) + 0.5f) / 16 - 0.5f;
            tile[4 * i + 3] = (float)fmod((4 * a + b) * 0.61803398874989485, 1);
        }
        run->noise = kit_keep(run, kit_texture(4, 4, GL_RGBA32F, tile));
    }
    if (!failed) limit_passes(run);
    run->bytes = !failed && glGetTexLevelParameteriv ? bytes_of(run) : (double)NAN;
    glGenBuffers(KIT_FRAMES, run->block);
    if (!failed) kit_run_update(run);
    for (int i = 0; i < 2 && !failed && kit_method_value(m->method, "reuse") > 0; ++i)
        kit_run_draw(run, 0);              /* a last frame to reuse */
    return failed ? -1 : 0;
}

int kit_run_open_wide(kit_run *run, kit_gbuffer *g, const kit_method *method, float radius, const kit_world *world,
                      int margin, kit_error *err)
{
    static const kit_world nothing;
    kit_making m = { .run = run, .method = method, .world = world ? world : &nothing, .err = err };
    int failed;
    memset(run, 0, sizeof *run);           /* in place: passes point at its extra cameras */
    failed = add_margin(&m, &g, radius, margin) || open_on(&m, g, radius);
    if (failed) kit_run_close(run);
    return failed ? -1 : 0;
}

int kit_run_open(kit_run *run, kit_gbuffer *g, const kit_method *method, float radius, const kit_world *world,
                 kit_error *err)
{
    return kit_run_open_wide(run, g, method, radius, world, -1, err);
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
void kit_run_draw(kit_run *run, int timed)
{
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, run->block[KIT_FRAME_VIEWS]);
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        const ssgi_gl_step *step = p->step;
        const ssgi_gl_frame *f =
            step->frame && step->frame < KIT_FRAME_VPLS ? &run->extra[step->frame - 1] : &run->frame;
        const int half = step->size == SSGI_GL_SIZE_HALF, levels = step->size == SSGI_GL_SIZE_LEVELS;
        for (int k = 0; k < p->rows; ++k)
            if (p->io[k].kind == SSGI_GL_TEXTURE) {
                glActiveTexture(GL_TEXTURE0 + (GLenum)p->io[k].slot);
                glBindTexture(target_of(&p->io[k]), texture_of(run, p, p->io[k].name));
            }
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, run->block[step->frame]);
        /* surfels: any complete one, which a context without a surface has not */
        glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer ? p->framebuffer : run->pass[run->passes - 1].framebuffer);
        if (levels) glViewport(0, 0, p->width, p->height);
        else glViewport(f->target[0] >> half, f->target[1] >> half, (f->size[0] + half) >> half,
                        (f->size[1] + half) >> half);
        if (p->box[2]) {
            glEnable(GL_SCISSOR_TEST);
            glScissor(p->box[0], p->box[1], p->box[2], p->box[3]);
        }
        glUseProgram(p->program);
        if (timed && !p->aside) kit_timer_begin();
        if (step->clear)
            for (GLint k = 0; k < step->outputs; ++k)
                glClearBufferfv(GL_COLOR, k, (const GLfloat[4]) { step->clear_to, step->clear_to, step->clear_to,
                                                                  step->clear_to });
        if (step->blend[0]) {
            glEnable(GL_BLEND);
            glBlendEquation(step->blend[0]);
            glBlendFunc(step->blend[1], step->blend[2]);
        }
        if (p->array) kit_draw_surfels(run, p);
        else
            glDrawArraysInstanced(step->primitive, 0, step->vertices,
                                  step->instances ? step->instances : p->instances);
        glDisable(GL_BLEND);
        if (timed && !p->aside) p->ms = kit_timer_end();
        if (p->box[2]) glDisable(GL_SCISSOR_TEST);
    }
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

double kit_run_operations(const kit_run *run)
{
    double operations = 0;
    for (int i = 0; i < run->passes; ++i) {
        const kit_pass *p = &run->pass[i];
        const double texels = p->desc.pass == SSGI_GL_SPLAT ? run->splat_pixels : drawn_by(p);
        if (!p->aside && p->step->outputs) operations += kit_operations(&p->desc) * texels;
    }
    return operations / shown_by(run);
}

double kit_run_ms(const kit_run *run)
{
    double ms = 0;
    for (int i = 0; i < run->passes; ++i) ms += run->pass[i].ms;
    return ms;
}

/* Takes so many pixels off each side. */
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

int kit_run_read(kit_image *out, const kit_run *run, kit_error *err)
{
    const kit_gbuffer *g = run->gbuffer;
    const kit_pass *last = &run->pass[run->passes ? run->passes - 1 : 0];
    const int width = run->lit ? g->viewport[2] : last->width, height = run->lit ? g->viewport[3] : last->height,
              components = run->lit ? 4 : 1;
    const size_t pixels = (size_t)width * (size_t)height;
    const GLuint source[3] = { run->light, run->bounce, run->bounce ? run->joint : 0 };
    kit_image image, frame;
    float *texels = malloc(pixels * (size_t)components * sizeof *texels);
    int failed = 0;
    if (!texels) return kit_fail(err, "out of memory");
    if (kit_image_new(&image, width, height, run->lit ? KIT_LIT_CHANNELS : "Y", err)) {
        free(texels);
        return -1;
    }
    for (int s = 0; s < (run->lit ? 3 : 1) && !failed; ++s) {
        if (!source[s]) continue;
        failed = kit_texture_read(source[s], width, height, components, texels) != 0;
        for (size_t i = 0; i < pixels && !failed; ++i) {
            const size_t from = pixels - (i / (size_t)width + 1) * (size_t)width + i % (size_t)width;
            if (!run->lit) image.data[i] = texels[from];
            for (size_t c = 0; c < 3 && run->lit; ++c) {
                float *to = &image.data[(s ? 6 + c : 3 + c) * pixels + i];
                *to = s < 2 ? texels[4 * from + c] : *to - texels[4 * from + c];
            }
        }
    }
    free(texels);
    if (!failed && run->lit && !(failed = kit_gbuffer_read(&frame, g, err))) {
        static const char *const names[2][3] = { { "albedo.R", "albedo.G", "albedo.B" },
                                                 { "direct.R", "direct.G", "direct.B" } };
        const float *z = kit_image_channel(&frame, "Z");
        for (size_t c = 0; c < 3; ++c) {
            const float *albedo = kit_image_channel(&frame, names[0][c]),
                        *direct = kit_image_channel(&frame, names[1][c]);
            for (size_t i = 0; i < pixels; ++i)
                if (z[i] > 0)
                    image.data[c * pixels + i] =
                        (albedo ? albedo[i] : 0.8f)
                            * (image.data[(3 + c) * pixels + i] + image.data[(6 + c) * pixels + i])
                        + (direct ? direct[i] : 0.0f);
        }
        kit_image_free(&frame);
    }
    if (failed) { kit_image_free(&image); return kit_fail(err, "the result cannot be read back"); }
    cut(&image, run->margin);
    *out = image;
    return 0;
}

/* A run that was never opened holds nothing, and perhaps there is no context: GL is called for what is there alone. */
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
