/* frames.c - draws sequences of frames: a method on one G-buffer after another, or on one that does not change; each
   run follows the one before. Declared in kit_gl.h. */
#include "kit/kit_run.h"
#include <math.h>
#include <string.h>

/* ---- >>follow ---------------------------------------------------------------------------------------------------- */

/* Exchanges textures x and y in all members of two runs that name them. */
static void exchange(kit_run *a, GLuint x, kit_run *b, GLuint y)
{
    for (int r = 0; r < (a == b ? 1 : 2); ++r) {
        kit_run *run = r ? b : a;
        GLuint *places[] = { &run->light, &run->bounce, &run->joint };
        for (int i = 0; i < 3; ++i) *places[i] = *places[i] == x ? y : *places[i] == y ? x : *places[i];
        for (int i = 0; i < run->textures && a != b; ++i)
            run->texture[i] = run->texture[i] == x ? y : run->texture[i] == y ? x : run->texture[i];
        for (int i = 0; i < run->passes; ++i)
            for (int k = 0; k < run->pass[i].step->inputs; ++k) {
                GLuint *in = &run->pass[i].input[k];
                *in = *in == x ? y : *in == y ? x : *in;
            }
    }
}

/* Returns the phase of a frame's noise; from: that of frame 0. */
static float phase_of(float from, unsigned frame)
{
    const double phase = (double)from + (double)ssgi_gl_phase(frame);
    return (float)(phase - floor(phase));
}

/* Resizes a texture of the last frame to the size at which a pass draws now. */
static void fit(GLuint texture, const kit_pass *p, GLenum format)
{
    GLint width, height;
    glBindTexture(GL_TEXTURE_2D, texture);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
    glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_HEIGHT, &height);
    if (width != p->width || height != p->height)
        glTexImage2D(GL_TEXTURE_2D, 0, (GLint)format, p->width, p->height, 0, GL_RGBA, GL_FLOAT, NULL);
}

int kit_run_follow(kit_run *run, kit_run *last, unsigned frame, kit_error *err)
{
    const kit_gbuffer *g = last->gbuffer;
    const char *why = "";
    ssgi_view view;
    float now[16], then[16], projection[16];
    if (run->passes != last->passes) return kit_fail(err, "the last frame had other passes");
    if (kit_view_of(&view, g->projection, g->camera.depth, g->viewport[2], g->viewport[3], err)) return -1;
    kit_camera_matrices(&run->gbuffer->camera, now, projection);
    kit_camera_matrices(&g->camera, then, projection);
    if (ssgi_gl_frame_history(&run->frame, &view, now, then, &why) != SSGI_OK)
        return kit_fail(err, "the last frame: %s", why);
    run->frame.phase = run == last ? ssgi_gl_phase(frame) : phase_of(run->frame.phase, frame);
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i], *from = &last->pass[i];
        for (unsigned k = 0; k < KIT_HISTORIES && p->last[k]; ++k) {
            const GLuint written = from->target[k], other = p->last[k];
            if (run == last) fit(other, p, p->step->output[k].format->internal);
            exchange(run, written, last, other);
            p->last[k] = written;
            from->target[k] = other;
            if (run != last) continue;
            glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + k, GL_TEXTURE_2D, other, 0);
        }
    }
    kit_run_update(run);
    return 0;
}

int kit_run_keeps(const kit_run *run)
{
    int kept = 0;
    for (int i = 0; i < run->passes; ++i) kept |= run->pass[i].desc.pass == SSGI_GL_PASS_HISTORY;
    return kept;
}

/* ---- >>frames ---------------------------------------------------------------------------------------------------- */

/* Draws a run with its frame's noise before it follows another run, thus without history. */
static int draw_alone(kit_image *out, kit_run *run, unsigned frame, kit_error *err)
{
    const float phase = run->frame.phase;
    run->frame.phase = phase_of(phase, frame);
    kit_run_update(run);
    kit_run_draw(run, 0);
    run->frame.phase = phase;
    kit_run_update(run);
    return kit_run_read(out, run, err);
}

/* Returns whether the frame's image has the size that the last one had, both without margins. */
static int same_size(const kit_gbuffer *g, const kit_run *last)
{
    const int *was = last->gbuffer->viewport, margin = 2 * last->margin;
    return g->viewport[2] == was[2] - margin && g->viewport[3] == was[3] - margin;
}

/* Returns whether the run can continue the last run's history, which may have another size. */
static int same_passes(const kit_run *run, const kit_run *last)
{
    int same = run->passes == last->passes;
    for (int i = 0; i < run->passes && same; ++i)
        same = ssgi_gl_key(&run->pass[i].desc) == ssgi_gl_key(&last->pass[i].desc);
    return same;
}

/* Separates the jitter of the projection from motion: it is the part of the cameras' difference that shift causes. */
static void keep_jitter(kit_run *run, const float last[4])
{
    ssgi_gl_frame *f = &run->frame;
    for (int k = 0; k < 2; ++k)
        f->jitter[k] = f->project[2 + k] * (float)f->last_size[k] / (float)f->size[k] - last[2 + k];
    kit_run_update(run);
}

/* Measures history in seconds if the caller gives each frame's duration. */
static int keep_time(kit_frames *f, kit_run *run, kit_error *err)
{
    const char *why;
    const float last = f->took > 0 ? f->took : f->elapsed;
    if (!(f->elapsed > 0)) return 0;
    f->took = f->elapsed;
    if (ssgi_gl_frame_time(&run->frame, KIT_MEMORY, f->elapsed, last, &why) != SSGI_OK)
        return kit_fail(err, "%s", why);
    kit_run_update(run);
    return 0;
}

static int follow_or_begin(kit_run *run, kit_run *last, kit_frames *f, kit_error *err)
{
    if (last) {
        float project[4];
        memcpy(project, last->frame.project, sizeof project);
        if (kit_run_follow(run, last, f->number, err) || keep_time(f, run, err)) return -1;
        if (f->jittered) keep_jitter(run, project);
        return 0;
    }
    f->took = f->elapsed;
    run->frame.phase = phase_of(run->frame.phase, f->number);
    kit_run_update(run);
    return 0;
}

int kit_frames_next(kit_frames *f, kit_gbuffer *g, const kit_method *method, float radius, const kit_world *world,
                    kit_image *alone, kit_error *err)
{
    kit_run *last = f->now, *run = &f->run[last == &f->run[0]];
    const int keeps = method->set.history, alike = last && keeps && same_size(g, last);
    kit_image picture = { 0 };
    int failed = kit_run_open_wide(run, g, method, radius, world, alike ? last->margin : -1, err)
              || (alone && draw_alone(&picture, run, keeps ? f->number : 0, err));
    const int follows = !failed && last && keeps && same_passes(run, last);
    failed = failed || (keeps && follow_or_begin(run, follows ? last : NULL, f, err));
    if (failed) {
        kit_image_free(&picture);
        kit_frames_close(f);
        return -1;
    }
    if (last) kit_run_close(last);
    if (alone) *alone = picture;
    f->now = run;
    f->since = follows ? f->since + 1 : 1;
    ++f->number;
    return 0;
}

int kit_frames_again(kit_frames *f, kit_error *err)
{
    if (kit_run_keeps(f->now) && kit_run_follow(f->now, f->now, f->number, err)) {
        kit_frames_close(f);
        return -1;
    }
    ++f->since;
    ++f->number;
    return 0;
}

void kit_frames_close(kit_frames *f)
{
    for (int k = 0; k < 2; ++k) kit_run_close(&f->run[k]);
    f->now = NULL;
    f->number = f->since = 0;
}

int kit_frames_still(kit_run *run, unsigned first, unsigned k, int timed, kit_error *err)
{
    if (kit_run_keeps(run)) {
        if (!k) {
            run->frame.history_frames = 0;
            run->frame.phase = ssgi_gl_phase(first);
            kit_run_update(run);
        } else if (kit_run_follow(run, run, first + k, err)) return -1;
    }
    kit_run_draw(run, timed);
    return 0;
}
