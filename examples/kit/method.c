/* method.c - the table of methods: settings, passes, running and timing them. */
#include "kit_gl.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>settings: one row a setting; where it goes is its place in a desc or in the frame ----------------------- */

enum { IN_AO, IN_BLUR, IN_BOTH, IN_FRAME /* times the radius */, IN_FRAME_PLAIN, IN_PLAN /* the method's own */ };

typedef struct row { kit_setting setting; int where; size_t offset; } row;
#define AO(field)    IN_AO, offsetof(ssgi_gl_desc, field)
#define BOTH(field)  IN_BOTH, offsetof(ssgi_gl_desc, field)
#define BLUR(field)  IN_BLUR, offsetof(ssgi_gl_desc, field)

static const row noise_row     = { { "noise", "what decorrelates neighbouring pixels", "gradient tile texture", 0, 0, 2, 1 }, AO(noise) };
static const row normal_row    = { { "normal", "normals from the G-buffer, or from depth alone", "gbuffer depth", 0, 0, 1, 1 }, IN_PLAN, 0 };
static const row thickness_row = { { "thickness", "how far behind what is seen things reach, in radii", NULL, 1, 0, 100, 0 }, IN_FRAME, offsetof(ssgi_gl_frame, thickness) };
static const row thin_row      = { { "thin", "1: things reach away from the viewer by thickness, 0: without end", NULL, 0, 0, 1, 1 }, AO(thin) };
static const row half_row      = { { "half", "1: one pixel of every 2x2, brought to full size by the filter", NULL, 0, 0, 1, 1 }, BOTH(half) };
static const row rays_thick_row = { { "thickness", "how far behind what is seen things reach, in radii", NULL, 0.5, 0, 100, 0 }, IN_FRAME, offsetof(ssgi_gl_frame, thickness) };
static const row hard_row      = { { "hard", "1: no attenuation by distance", NULL, 0, 0, 1, 1 }, AO(hard) };
static const row offset_row    = { { "offset", "lift of the receiver along its normal, in half pixels", NULL, 1.5, 0, 100, 0 }, IN_FRAME_PLAIN, offsetof(ssgi_gl_frame, offset) };
static const row blur_row      = { { "blur", "radius of the filter, pixels; 0 = none", NULL, 1, 0, 4, 1 }, IN_PLAN, 0 };
static const row filter_row    = { { "filter", "kind of filter", "bilateral gaussian", 0, 0, 1, 1 }, BLUR(filter) };
static const row compare_row   = { { "filter_normals", "1: the filter compares normals too", NULL, 0, 0, 1, 1 }, BLUR(filter_normals) };
static const row phase_row     = { { "phase", "turns the noise", NULL, 0, 0, 1, 0 }, IN_FRAME_PLAIN, offsetof(ssgi_gl_frame, phase) };

static const row samples_row   = { { "samples", "points per pixel", NULL, 16, 1, 64, 1 }, AO(samples) };
static const row slices_row    = { { "directions", "slices, two directions each", NULL, 1, 1, 32, 1 }, AO(directions) };
static const row dirs_row      = { { "directions", "N_d: directions in the tangent plane", NULL, 6, 1, 32, 1 }, AO(directions) };
static const row steps_row     = { { "steps", "N_s: steps per direction", NULL, 6, 1, 64, 1 }, AO(steps) };
static const row rays_row      = { { "normal_rays", "N_n: rays above the horizon, per direction", NULL, 0, 0, 8, 1 }, AO(normal_rays) };

typedef struct plan { const char *name, *about; int pass, search, preset; const row *rows[KIT_MAX_SETTINGS]; } plan;
#define SLICES { &slices_row, &steps_row, &half_row, &thin_row, &thickness_row, &hard_row, &normal_row, &noise_row, &phase_row, &blur_row, &filter_row, &compare_row }
static const plan plans[] = {
    { "ssao", "point samples in the hemisphere", SSGI_GL_SSAO, 0, SSGI_GL_BALANCED,
      { &samples_row, &half_row, &thin_row, &thickness_row, &offset_row, &normal_row, &noise_row, &phase_row, &blur_row, &filter_row, &compare_row } },
    { "hsao", "horizon search in slices through the view direction", SSGI_GL_HSAO, SSGI_GL_SLICES, SSGI_GL_BALANCED, SLICES },
    { "hsao-fast", "the same, fewer taps", SSGI_GL_HSAO, SSGI_GL_SLICES, SSGI_GL_FAST, SLICES },
    { "hsao-best", "the same, full size, more taps", SSGI_GL_HSAO, SSGI_GL_SLICES, SSGI_GL_BEST, SLICES },
    { "hsao-march", "the paper's horizon march and normal rays", SSGI_GL_HSAO, SSGI_GL_MARCH, SSGI_GL_BALANCED,
      { &dirs_row, &steps_row, &rays_row, &half_row, &thin_row, &rays_thick_row, &hard_row, &offset_row, &normal_row, &noise_row, &phase_row, &blur_row, &filter_row, &compare_row } }
};
enum { PLANS = (int)(sizeof plans / sizeof plans[0]) };

int kit_method_at(kit_method *method, int i)
{
    kit_method m;
    ssgi_gl_desc desc;
    if (i < 0 || i >= PLANS) return 0;
    memset(&m, 0, sizeof m);
    m.name = plans[i].name;
    m.about = plans[i].about;
    memset(&desc, 0, sizeof desc);
    desc.pass = plans[i].pass;
    desc.search = plans[i].search;
    ssgi_gl_preset(&desc, plans[i].preset, NULL);
    for (; plans[i].rows[m.count]; ++m.count) {            /* what the preset sets, the setting starts from */
        const row *w = plans[i].rows[m.count];
        int value = 0;
        m.setting[m.count] = w->setting;
        if (w->where == IN_AO || w->where == IN_BOTH) memcpy(&value, (const char *)&desc + w->offset, sizeof value);
        if (value) m.setting[m.count].value = value;
        if (w == &blur_row) m.setting[m.count].value = desc.filter_radius;
    }
    *method = m;
    return 1;
}

int kit_method_find(kit_method *method, const char *name, kit_error *err)
{
    char names[256] = "";
    kit_method m;
    for (int i = 0; kit_method_at(&m, i); ++i) {
        if (!strcmp(m.name, name)) { *method = m; return 0; }
        snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", i ? ", " : "", m.name);
    }
    return kit_fail(err, "--method %s: there is none of that name (%s)", name, names);
}

static int set_one(kit_method *m, const char *text, size_t length, kit_error *err)
{
    char key[128], *value, *end;
    if (length >= sizeof key) return kit_fail(err, "--set %.40s...: too long", text);
    memcpy(key, text, length);
    key[length] = 0;
    value = strchr(key, '=');
    if (!value) return kit_fail(err, "--set %s: must be key=value", key);
    *value++ = 0;
    for (int i = 0; i < m->count; ++i) {
        kit_setting *s = &m->setting[i];
        double v = -1;
        if (strcmp(s->key, key)) continue;
        if (s->choices) {
            const char *word = s->choices;
            for (int k = 0; *word; ++k) {
                size_t n = strcspn(word, " ");
                if (strlen(value) == n && !strncmp(word, value, n)) v = k;
                word += n + (word[n] ? 1 : 0);
            }
            if (v < 0) return kit_fail(err, "--set %s=%s: must be one of: %s", key, value, s->choices);
        } else {
            v = strtod(value, &end);
            if (end == value || *end || !(v >= s->least && v <= s->most) || (s->whole && v != floor(v)))
                return kit_fail(err, "--set %s=%s: must be a %snumber in %g..%g", key, value, s->whole ? "whole " : "", s->least, s->most);
        }
        s->value = v;
        return 0;
    }
    return kit_fail(err, "--set %s=%s: method %s has no such setting (--list names them)", key, value, m->name);
}

int kit_method_set(kit_method *method, const char *text, kit_error *err)
{
    kit_method m = *method;
    while (*text) {
        size_t n = strcspn(text, ",");
        if (set_one(&m, text, n, err)) return -1;
        text += n + (text[n] ? 1 : 0);
    }
    *method = m;
    return 0;
}

double kit_method_value(const kit_method *method, const char *key)
{
    for (int i = 0; i < method->count; ++i) if (!strcmp(method->setting[i].key, key)) return method->setting[i].value;
    return 0;
}

/* ---- >>run ------------------------------------------------------------------------------------------------------ */

int kit_dialect(void) { return kit_gl_is_es() ? SSGI_GL_300ES : SSGI_GL_330; }

GLuint kit_pass_program(const ssgi_gl_desc *desc, kit_error *err)
{
    static const GLenum stages[] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER };
    char *text[SSGI_GL_STAGES] = { NULL, NULL };
    const char *source[SSGI_GL_STAGES], *why = "";
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    GLuint program = 0, block;
    if (ssgi_gl_check(desc, &why) != SSGI_OK) { kit_fail(err, "%s", why); return 0; }
    for (int s = 0; s < SSGI_GL_STAGES; ++s) {
        size_t n = ssgi_gl_emit(NULL, 0, desc, s) + 1;
        text[s] = malloc(n);
        if (!text[s]) { kit_fail(err, "out of memory"); break; }
        ssgi_gl_emit(text[s], n, desc, s);
        source[s] = text[s];
    }
    if (text[0] && text[1]) program = kit_program(source, stages, SSGI_GL_STAGES, err);
    free(text[0]);
    free(text[1]);
    if (!program) return 0;
    glUseProgram(program);
    for (int i = 0, n = ssgi_gl_reflect(desc, io, SSGI_GL_MAX_IO); i < n; ++i)
        if (io[i].kind == SSGI_GL_TEXTURE) glUniform1i(glGetUniformLocation(program, io[i].name), io[i].slot);
    block = glGetUniformBlockIndex(program, "ssgi_frame");
    if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, 0);
    return program;
}

static int add_pass(kit_run *run, const ssgi_gl_desc *desc, int width, int height, GLenum format, kit_error *err)
{
    kit_pass *p = &run->pass[run->passes];
    GLenum buffer = GL_COLOR_ATTACHMENT0;
    memset(p, 0, sizeof *p);
    p->desc = *desc;
    p->width = width;
    p->height = height;
    p->program = kit_pass_program(desc, err);
    if (!p->program) return -1;
    ++run->passes;
    p->texture = kit_texture(width, height, format, NULL);
    glGenFramebuffers(1, &p->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, p->texture, 0);
    glDrawBuffers(1, &buffer);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) return kit_fail(err, "the context cannot draw into a target of format 0x%x", format);
    run->fetches += ssgi_gl_fetches(desc) * (double)width * height / ((double)run->frame.size[0] * run->frame.size[1]);
    return 0;
}

int kit_run_open(kit_run *run, const kit_gbuffer *g, const kit_method *method, float radius, kit_error *err)
{
    kit_run r;
    ssgi_gl_desc ao, blur;
    ssgi_view view;
    const char *why = "";
    const plan *p = NULL;
    int width = g->viewport[2], height = g->viewport[3], blur_radius = 0;
    memset(&r, 0, sizeof r);
    memset(&ao, 0, sizeof ao);
    for (int i = 0; i < PLANS; ++i) if (!strcmp(plans[i].name, method->name)) p = &plans[i];
    if (!p) return kit_fail(err, "method %s: there is none of that name", method->name);
    if (ssgi_view_from_projection(&view, g->projection, g->camera.depth == KIT_DEPTH_NORMAL ? SSGI_CLIP_GL : SSGI_CLIP_ZERO, width, height, &why) != SSGI_OK
        || ssgi_gl_frame_init(&r.frame, &view, radius, &why) != SSGI_OK) return kit_fail(err, "%s", why);
    r.gbuffer = g;
    r.frame.origin[0] = g->viewport[0];
    r.frame.origin[1] = g->viewport[1];
    ao.pass = p->pass;
    ao.search = p->search;
    ao.dialect = kit_dialect();
    ao.orthographic = view.orthographic;
    ao.depth = g->depth_is_linear ? SSGI_GL_DEPTH_LINEAR : SSGI_GL_DEPTH_WINDOW;
    blur = ao;
    blur.pass = SSGI_GL_BLUR;
    for (int i = 0; i < method->count; ++i) {
        const row *w = p->rows[i];
        double v = method->setting[i].value;
        int whole = (int)v;
        float real = (float)(w->where == IN_FRAME ? v * (double)radius : v);
        if (w->where == IN_AO || w->where == IN_BOTH) memcpy((char *)&ao + w->offset, &whole, sizeof whole);
        if (w->where == IN_BLUR || w->where == IN_BOTH) memcpy((char *)&blur + w->offset, &whole, sizeof whole);
        if (w->where == IN_FRAME || w->where == IN_FRAME_PLAIN) memcpy((char *)&r.frame + w->offset, &real, sizeof real);
        if (w == &blur_row) blur_radius = whole;
        if (w == &normal_row) ao.normal = blur.normal = whole ? SSGI_GL_NORMAL_FROM_DEPTH : SSGI_GL_NORMAL_SIGNED;
    }
    blur.filter_radius = blur_radius;
    if (ao.half && !blur_radius) return kit_fail(err, "--set half=1: needs blur=1 or more, which brings it to full size");
    if (add_pass(&r, &ao, ao.half ? (width + 1) / 2 : width, ao.half ? (height + 1) / 2 : height, GL_RG32F, err) || (blur_radius && add_pass(&r, &blur, width, height, GL_R32F, err))) { kit_run_close(&r); return -1; }
    if (ao.noise == SSGI_GL_NOISE_TEXTURE) {
        float tile[4 * 16];
        ssgi_jitter_tile(tile, 4, ao.directions ? ao.directions : 1, NULL);
        r.noise = kit_texture(4, 4, GL_RGBA32F, tile);
    }
    glGenBuffers(1, &r.block);
    kit_run_update(&r);
    *run = r;
    return 0;
}

void kit_run_update(kit_run *run)
{
    glBindBuffer(GL_UNIFORM_BUFFER, run->block);
    glBufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)sizeof run->frame, &run->frame, GL_DYNAMIC_DRAW);
}

static GLuint texture_of(const kit_run *run, int pass, const char *name)
{
    if (!strcmp(name, "t_ssgi_depth")) return run->gbuffer->depth;
    if (!strcmp(name, "t_ssgi_normal")) return run->gbuffer->normal;
    if (!strcmp(name, "t_ssgi_noise")) return run->noise;
    return run->pass[pass - 1].texture;
}

void kit_run_draw(kit_run *run, int timed)
{
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, run->block);
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        ssgi_gl_io io[SSGI_GL_MAX_IO];
        for (int k = 0, n = ssgi_gl_reflect(&p->desc, io, SSGI_GL_MAX_IO); k < n; ++k)
            if (io[k].kind == SSGI_GL_TEXTURE) {
                glActiveTexture(GL_TEXTURE0 + (GLenum)io[k].slot);
                glBindTexture(GL_TEXTURE_2D, texture_of(run, i, io[k].name));
            }
        glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer);
        if (p->desc.half && p->desc.pass != SSGI_GL_BLUR) glViewport(run->frame.target[0] / 2, run->frame.target[1] / 2, (run->frame.size[0] + 1) / 2, (run->frame.size[1] + 1) / 2);
        else glViewport(run->frame.target[0], run->frame.target[1], run->frame.size[0], run->frame.size[1]);
        glUseProgram(p->program);
        if (timed) kit_timer_begin();
        glDrawArrays(GL_TRIANGLES, 0, 3);
        if (timed) p->ms = kit_timer_end();
    }
    glActiveTexture(GL_TEXTURE0);
}

double kit_run_ms(const kit_run *run)
{
    double ms = 0;
    for (int i = 0; i < run->passes; ++i) ms += run->pass[i].ms;
    return ms;
}

int kit_run_read(kit_image *out, const kit_run *run, kit_error *err)
{
    const kit_pass *p = &run->pass[run->passes - 1];
    kit_image image;
    float *rows;
    if (kit_image_new(&image, p->width, p->height, "Y", err)) return -1;
    rows = malloc((size_t)p->width * (size_t)p->height * sizeof *rows);
    if (!rows || kit_texture_read(p->texture, p->width, p->height, 1, rows)) {
        free(rows);
        kit_image_free(&image);
        return kit_fail(err, "the result cannot be read back");
    }
    for (int y = 0; y < p->height; ++y)
        memcpy(image.data + (size_t)y * (size_t)p->width, rows + (size_t)(p->height - 1 - y) * (size_t)p->width, (size_t)p->width * sizeof *rows);
    free(rows);
    *out = image;
    return 0;
}

void kit_run_close(kit_run *run)
{
    for (int i = 0; i < run->passes; ++i) {
        glDeleteProgram(run->pass[i].program);
        glDeleteFramebuffers(1, &run->pass[i].framebuffer);
        glDeleteTextures(1, &run->pass[i].texture);
    }
    glDeleteBuffers(1, &run->block);
    glDeleteTextures(1, &run->noise);
    memset(run, 0, sizeof *run);
}
