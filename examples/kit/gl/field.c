/* field.c - ambient occlusion fields of a scene's shapes, and their textures. Declared in kit_gl.h. */
#include "kit/kit_gl.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>baked: each shape is baked once in a process -------------------------------------------------------------- */

typedef struct baked { struct baked *next; uint64_t key; ssgi_field field; double seconds; uint32_t texels[]; } baked;
static baked *all;

static void in_parallel(void *user, int count, void (*job)(void *context, int i), void *context)
{
    (void)user;
    kit_parallel(NULL, count, job, context);
}

static int shown(void *user, float done)
{
    kit_progress(user, (double)done);
    return 0;
}

const ssgi_field *kit_field(const kit_mesh *shape, const ssgi_field_desc *desc, double *seconds, kit_error *err)
{
    ssgi_field_desc d = *desc;
    const size_t texels = ssgi_field_size(d.resolution ? d.resolution : 16),
                 size = ssgi_field_bake_size(&d, shape->triangles);
    uint64_t key = kit_hash(KIT_HASH, shape->position, 9 * shape->triangles * sizeof(float));
    const char *why = "out of memory";
    void *work;
    baked *b;
    key = kit_hash(key, &d.resolution, offsetof(ssgi_field_desc, hit));
    for (b = all; b && b->key != key; b = b->next) {}
    if (!b) {
        const double began = kit_seconds();
        int failed;
        d.parallel = in_parallel;
        d.progress = shown;
        d.user = "baking a field";
        b = malloc(sizeof *b + texels);
        work = malloc(size + 1);
        failed = !b || !work
                 || ssgi_field_bake(&b->field, b->texels, work, size, &d, shape->position, 3 * sizeof(float), NULL,
                                    shape->triangles, &why)
                        != SSGI_OK;
        free(work);
        if (failed) {
            free(b);
            kit_fail(err, "field: %s", why);
            return NULL;
        }
        b->seconds = kit_seconds() - began;
        b->key = key;
        b->next = all;
        all = b;
    }
    if (seconds) *seconds = b->seconds;
    return &b->field;
}

void kit_fields_free(void)
{
    while (all) {
        baked *next = all->next;
        free(all);
        all = next;
    }
}

/* ---- >>coverage -------------------------------------------------------------------------------------------------- */

int kit_fields_cover(double *share, const kit_image *frame, const kit_camera *camera, const kit_scene *scene,
                     const ssgi_field_desc *desc, kit_error *err)
{
    const float *z = kit_image_channel(frame, "Z");
    size_t pixels = 0;
    for (int i = 0; i < scene->objects; ++i) {
        const kit_object *o = &scene->object[i];
        const ssgi_field *f = o->casts ? kit_field(&scene->shape[o->shape], desc, NULL, err) : NULL;
        const double size = (double)hypotf(hypotf(o->to_world[0], o->to_world[1]), o->to_world[2]);
        if (!o->casts) continue;
        if (!f) return -1;
        for (int p = 0; p < frame->width * frame->height; ++p) {
            float point[3];
            double square = 0;
            if (!(z[p] > 0)) continue;
            kit_camera_point(camera, p % frame->width, p / frame->width, (double)z[p], point);
            for (int k = 0; k < 3; ++k) {
                const float *m = o->to_world + k,
                            off = point[k] - (m[0] * f->centre[0] + m[4] * f->centre[1] + m[8] * f->centre[2] + m[12]);
                square += (double)(off * off);
            }
            pixels += square < (double)(f->reach * f->reach) * size * size;
        }
    }
    *share = (double)pixels / ((double)frame->width * frame->height);
    return 0;
}

/* ---- >>textures -------------------------------------------------------------------------------------------------- */

GLuint kit_field_atlas(const ssgi_field *const *field, int count)
{
    int most = 2;
    GLuint texture = 0;
    uint32_t *data;
    for (int i = 0; i < count; ++i) if (field[i]->resolution > most) most = field[i]->resolution;
    const size_t row = 2 * (size_t)(most + 2), slice = row * 6 * (size_t)(most + 2);
    data = calloc(slice * (size_t)count, sizeof *data);
    for (int i = 0; i < count && data; ++i) {
        const size_t own = 2 * (size_t)(field[i]->resolution + 2);
        for (size_t y = 0; y < 6 * (size_t)(field[i]->resolution + 2); ++y)
            memcpy(data + (size_t)i * slice + y * row, field[i]->texels + y * own, own * sizeof *data);
    }
    if (data)
        texture = kit_texture_array(most + 2, 6 * (most + 2), count, GL_RG32UI, (const float *)(const void *)data);
    free(data);
    return texture;
}
