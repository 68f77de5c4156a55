/* fields_stage.c - puts rigid occluders on a stage, and measures rows of their fields. Declared in fields_stage.h. */
#include "lab/chart/fields_stage.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

void fields_place(float to_world[16], float size, const float at[3])
{
    memset(to_world, 0, 16 * sizeof *to_world);
    for (int k = 0; k < 3; ++k) to_world[5 * k] = size;
    memcpy(to_world + 12, at, 3 * sizeof *at);
    to_world[15] = 1;
}

/* Leaves out of the score the pixels that show an object, as an object's field does not shade the object itself. */
static int leave_out(stage *s, int object, kit_error *err)
{
    const int width = s->gbuffer.width, height = s->gbuffer.height;
    float *z = kit_image_channel(&s->frame, "Z");
    uint32_t *shown = malloc((size_t)width * (size_t)height * sizeof *shown);
    GLuint framebuffer;
    if (!shown) return kit_fail(err, "out of memory");
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, s->gbuffer.object, 0);
    glReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, shown);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (shown[(size_t)(height - 1 - y) * (size_t)width + (size_t)x] == (uint32_t)object + 1)
                z[(size_t)y * (size_t)width + (size_t)x] = 0;
    free(shown);
    return 0;
}

int fields_open(stage *s, const setup *f, int width, int height, kit_error *err)
{
    static const float hidden[3] = { 0, -0.1f, 0 }, grey[3] = { 0.72f, 0.72f, 0.7f };
    float to_world[16];
    int spots = 0, occluders = 0, last = 0;
    if (stage_load(s, &f->view, err)) return -1;
    const int own = s->scene.objects;
    kit_scene_move(&s->scene, f->time);
    for (int i = 0; i < COUNT(f->box) && f->box[i][4] > f->box[i][1]; ++i)
        if (kit_scene_add_box(&s->scene, f->box[i], f->box[i] + 3, grey, err)) return -1;
    for (int i = 0; i < s->scene.objects; ++i) {
        kit_object *o = &s->scene.object[i];
        const spot *at = spots < COUNT(f->spot) ? &f->spot[spots] : NULL;
        if (i >= own) o->casts = 0;
        if (!o->casts || !f->spot[0].name) continue;
        o->casts = at && at->name && !strcmp(at->name, o->name);
        spots += o->casts;
        fields_place(to_world, o->casts ? at->size : 1e-3f, o->casts ? at->at : hidden);
        if (kit_scene_place(&s->scene, i, to_world, err)) return -1;
    }
    s->between = 1;
    s->rays = f->rays;
    if (stage_show(s, &f->view, width, height, err)) return -1;
    for (int i = 0; i < s->scene.objects; ++i) if (s->scene.object[i].casts) { ++occluders; last = i; }
    return occluders == 1 ? leave_out(s, last, err) : 0;
}

int fields_desc(ssgi_field_desc *d, const char *settings, kit_error *err)
{
    kit_method m;
    if (kit_method_find(&m, "aof", err) || kit_method_set(&m, settings, err)) return -1;
    *d = kit_method_field(&m);
    return 0;
}

int fields_baked(row *r, const kit_mesh *shape, const ssgi_field_desc *d, kit_error *err)
{
    double seconds;
    const ssgi_field *f = kit_field(shape, d, &seconds, err);
    if (!f) return -1;
    r->figure[TRIANGLES] = fmax(r->figure[TRIANGLES], (double)shape->triangles);
    r->figure[RESOLUTION] = f->resolution;
    r->figure[RADII] = f->radii;
    r->figure[BAKE_RAYS] = d->rays;
    r->figure[WORK] = fmax(r->figure[WORK], 1e-6 * (double)ssgi_field_bake_size(d, shape->triangles));
    r->figure[BYTES] = fmax(r->figure[BYTES], 0) + 1e-3 * (double)ssgi_field_size(f->resolution);
    r->figure[SECONDS] = fmax(r->figure[SECONDS], 0) + seconds;
    r->figure[BAKED_MEDIAN] = fmax(r->figure[BAKED_MEDIAN], (double)f->median);
    r->figure[BAKED_P95] = fmax(r->figure[BAKED_P95], (double)f->p95);
    r->figure[BAKED_MOST] = fmax(r->figure[BAKED_MOST], (double)f->max_error);
    return 0;
}

static int casts(const kit_scene *scene, int shape)
{
    for (int i = 0; i < scene->objects; ++i) if (scene->object[i].casts && scene->object[i].shape == shape) return 1;
    return 0;
}

int fields_measure(row *rows, stage *s, const entry *entries, int count, kit_image *picture, kit_error *err)
{
    const float *z = kit_image_channel(&s->frame, "Z");
    const size_t pixels = (size_t)s->truth.width * (size_t)s->truth.height;
    double *off = malloc(pixels * sizeof *off);
    if (!off) return kit_fail(err, "out of memory");
    if (measure_entries(rows, s, entries, count, QUICK_ROUNDS, 0, picture, err)) return -1;
    for (int i = 0; i <= count; ++i) {
        const kit_image *shown = i < count ? &picture[i] : &s->given[0].picture;
        size_t n = 0;
        ssgi_field_desc d;
        for (int k = 0; k < FIGURES; ++k) rows[i].figure[k] = (double)NAN;
        for (size_t k = 0; k < pixels; ++k) if (z[k] > 0) off[n++] = fabs((double)(shown->data[k] - s->truth.data[k]));
        rows[i].figure[MEDIAN] = kit_median(off, (int)n);
        rows[i].figure[MOST] = off[n - 1];
        if (i == count || fields_desc(&d, entries[i].settings, err)) continue;
        for (int k = 0; k < s->scene.shapes; ++k)
            if (casts(&s->scene, k) && fields_baked(&rows[i], &s->scene.shape[k], &d, err)) return -1;
    }
    free(off);
    return 0;
}
