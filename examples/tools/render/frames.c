/* frames.c - --sequence and --frames: draws an image of each frame. */
#include "render.h"
#include <stdlib.h>
#include <string.h>

/* A line of a sequence's file: the path of a frame, and the camera unless the frame has one. */
typedef struct line {
    const char *frame;
    double camera[6], up[3];
    int has_camera, has_up, number;
} line;

typedef struct sequence { char *text; line *line; int lines; } sequence;

static void sequence_free(sequence *s)
{
    free(s->text);
    free(s->line);
    memset(s, 0, sizeof *s);
}

/* Parses a line of the sequence. Returns 0: it is blank, -1: it is wrong. */
static int parse_line(line *l, char *text)
{
    double v[9] = { 0 };
    int commas = 0;
    text += strspn(text, " \t");
    if (!*text) return 0;
    char *camera = text + strcspn(text, " \t");
    if (*camera) *camera++ = 0;
    camera += strspn(camera, " \t");
    l->frame = text;
    if (!*camera) return 1;
    for (const char *c = camera; *c; ++c) commas += *c == ',';
    if (kit_numbers("camera", camera, v, commas == 8 ? 9 : 6, NULL)) return -1;
    l->has_camera = 1;
    memcpy(l->camera, v, sizeof l->camera);
    memcpy(l->up, v + 6, sizeof l->up);
    l->has_up = commas == 8;
    return 1;
}

/* Reads a sequence's file. Lines end in CR, LF or both. They are numbered from 1, blank lines too, as in an editor. */
static int sequence_read(sequence *s, const char *path, kit_error *err)
{
    size_t size;
    int number = 0, room = 1;
    if (kit_file_read(&s->text, &size, path, err)) return -1;
    for (size_t i = 0; i < size; ++i) room += s->text[i] == '\n' || s->text[i] == '\r';
    s->line = calloc((size_t)room, sizeof *s->line);
    if (!s->line) return kit_fail(err, "--sequence %s: out of memory", path);
    for (char *at = s->text, *end = at + size, *next; at < end; at = next) {
        line *l = &s->line[s->lines];
        const size_t length = strcspn(at, "\r\n");
        l->number = ++number;
        if (at + length < end && !at[length])
            return kit_fail(err, "--sequence %s: line %d: holds a zero byte", path, number);
        next = at + length + (at[length] == '\r' && at[length + 1] == '\n') + 1;
        at[length] = 0;
        const int found = parse_line(l, at);
        if (found < 0)
            return kit_fail(err, "--sequence %s: line %d: must be FRAME.exr [ex,ey,ez,tx,ty,tz[,ux,uy,uz]]", path,
                            number);
        s->lines += found;
    }
    return s->lines ? 0 : kit_fail(err, "--sequence %s: names no frame", path);
}

/* Opens the G-buffer of the frame that a line of the sequence names. */
static int open_line(kit_gbuffer *g, job *j, const line *l, kit_error *err)
{
    const options *o = &j->o;
    options of = *o;
    kit_error why;
    of.gbuffer = l->frame;
    of.has_camera = l->has_camera;
    memcpy(of.camera, l->camera, sizeof of.camera);
    if (l->has_up) memcpy(of.up, l->up, sizeof of.up);
    of.has_up |= l->has_up;
    if (!render_open_frame(g, j, &of, &why)) return 0;
    return kit_fail(err, "--sequence %s: line %d: %s", o->sequence, l->number, why.text);
}

/* Returns the name of a property in which a frame differs from the first frame and on which a method may depend; NULL:
   none. Motion may differ, because a first frame has none. */
static const char *unlike(const kit_gbuffer *g, const kit_gbuffer *first)
{
    return g->width != first->width || g->height != first->height ? "size"
           : g->layers != first->layers                           ? "depth layers"
           : !g->normal != !first->normal                         ? "N.X .."
           : !g->albedo != !first->albedo                         ? "albedo.R .."
           : !g->direct != !first->direct                         ? "direct.R .."
           : !g->back != !first->back                             ? "back.Z"
           : !g->slabs != !first->slabs                           ? "front2.Z"
                                                                  : NULL;
}

/* Reads every frame, and makes the method ready on the first one, before anything is written. */
static int sequence_check(job *j, const sequence *s, kit_error *err)
{
    kit_gbuffer first = { 0 }, g;
    int failed = open_line(&first, j, &s->line[0], err)
              || kit_frames_next(&j->frames, &first, &j->method, (float)j->radius, &j->world, NULL, err);
    kit_frames_close(&j->frames);
    for (int k = 1; k < s->lines && !failed; ++k) {
        const line *l = &s->line[k];
        failed = open_line(&g, j, l, err);
        if (failed) break;
        const char *what = unlike(&g, &first);
        if (what)
            failed = kit_fail(err, "--sequence %s: line %d: %s: must be like the first frame in %s", j->o.sequence,
                              l->number, l->frame, what);
        kit_gbuffer_free(&g);
        kit_progress("frames read", (double)k / s->lines);
    }
    kit_progress("frames read", 1);
    kit_gbuffer_free(&first);
    return failed;
}

/* Opens the G-buffer of frame k. */
static int open_next(kit_gbuffer *g, job *j, const sequence *s, const kit_camera *from, int k, kit_error *err)
{
    kit_camera camera = *from;
    if (j->o.sequence) return open_line(g, j, &s->line[k], err);
    kit_camera_orbit(&camera, from, j->o.orbit * k);
    return render_slide(j, k > 0, err)
        || kit_gbuffer_from_scene(g, &j->scene, &camera, NULL, err);
}

/* Draws and writes frame k. */
static int play_frame(job *j, kit_gbuffer *g, int k, kit_error *err)
{
    char path[4096];
    kit_image picture;
    if (!render_numbered(path, sizeof path, j->o.out, k)) return kit_fail(err, "--out %s: is too long", j->o.out);
    if (kit_frames_next(&j->frames, g, &j->method, (float)j->radius, &j->world, NULL, err)) return -1;
    kit_run_draw(j->frames.now, 0);
    if (kit_run_read(&picture, j->frames.now, err)) return -1;
    const int failed = render_write(j, g, &picture, j->r.lit, path, err);
    kit_image_free(&picture);
    return failed;
}

int render_play(job *j, kit_error *err)
{
    const options *o = &j->o;
    kit_gbuffer shown[2] = { { 0 } };
    sequence s = { 0 };
    if (render_open_settings(j, err)) return -1;
    int failed = o->sequence ? sequence_read(&s, o->sequence, err) || sequence_check(j, &s, err)
                             : render_open_scene(j, err);
    const kit_camera from = j->gbuffer.camera;
    const int count = o->sequence ? s.lines : o->frames;
    for (int k = 0; k < count && !failed; ++k) {
        kit_gbuffer *g = &shown[k & 1];
        failed = open_next(g, j, &s, &from, k, err) || play_frame(j, g, k, err);
        kit_gbuffer_free(&shown[!(k & 1)]);
        kit_progress("frames", (k + 1.0) / count);
    }
    kit_progress("frames", 1);
    kit_frames_close(&j->frames);
    for (int k = 0; k < 2; ++k) kit_gbuffer_free(&shown[k]);
    sequence_free(&s);
    return failed ? -1 : 0;
}
