/* occluders.c - adds occlusion between objects, by the fields of objects that cast. Declared in kit_run.h. */
#include "kit/kit_run.h"
#include <stdlib.h>

/* The fields of a scene's shapes, and a row of t_ssgi_occluders for each object that casts. */
typedef struct occluders {
    const ssgi_field **field;
    ssgi_gl_occluder  *rows;
    int                fields, count;
} occluders;

static void product(float out[16], const float a[16], const float b[16])
{
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
            out[4 * c + r] = 0;
            for (int k = 0; k < 4; ++k) out[4 * c + r] += a[4 * k + r] * b[4 * c + k];
        }
}

/* Adds the row of object i; slice: the layer of its field. */
static int add_row(const kit_making *m, occluders *all, int i, int slice, const float picture[16])
{
    const kit_settings *set = m->set;
    const kit_object *o = &m->world->scene->object[i];
    const char *why = "";
    float to_view[16];
    ssgi_field_limits limits = ssgi_field_limits_of(all->field[slice]);
    product(to_view, picture, o->to_world);
    limits.ramp = (float)set->ramp * limits.reach;
    limits.power = (float)set->power;
    if (set->inside >= 0) limits.inside = (float)set->inside;
    if (ssgi_gl_occluder_set(&all->rows[all->count++], all->field[slice], &limits, to_view, slice, i + 1, &why)
        != SSGI_OK)
        return kit_fail(m->err, "object %s: %s", o->name, why);
    return 0;
}

/* Adds the rows of a shape's objects; its field is baked if one of them casts. */
static int add_shape(kit_making *m, occluders *all, int s, const float picture[16])
{
    const kit_scene *scene = m->world->scene;
    const ssgi_field_desc d = kit_method_field(m->method);
    int slice = -1;
    for (int i = 0; i < scene->objects; ++i) {
        const kit_object *o = &scene->object[i];
        if (o->shape != s || !(m->set->occluders == KIT_OCCLUDERS_ALL || o->casts)) continue;
        if (slice < 0) {
            const ssgi_field *field = kit_field(&scene->shape[s], &d, NULL, m->err);
            if (!field) return -1;
            slice = all->fields++;
            all->field[slice] = field;
            m->run->field_bytes += ssgi_field_size(field->resolution);
        }
        if (add_row(m, all, i, slice, picture)) return -1;
    }
    return 0;
}

static int add_occluders(kit_making *m, occluders *all, const float picture[16])
{
    const kit_scene *scene = m->world->scene;
    kit_run *run = m->run;
    /* rows are ordered by shape, so that each field is baked once */
    for (int s = 0; s < scene->shapes; ++s) if (add_shape(m, all, s, picture)) return -1;
    if (all->count && !(run->fields = kit_keep(run, kit_field_atlas(all->field, all->fields))))
        return kit_fail(m->err, "no memory for %d fields", all->fields);
    m->rows[0] = kit_keep(run, kit_texture(10, all->count ? all->count : 1, GL_RGBA32F, all->rows[0].at));
    if (!m->rows[0]) return kit_fail(m->err, "no memory for %d occluders", all->count);
    const ssgi_gl_chain chain = kit_chain(m);
    if (kit_add_steps(m, &chain, 0, &run->light, NULL)) return -1;
    run->pass[run->passes - 1].instances = run->occluders = all->count;
    return 0;
}

/* Makes the texture t_ssgi_cap if the settings ask for it. */
static int add_cap_table(kit_making *m)
{
    const int size = m->set->cap_table;
    const char *why = "out of memory";
    if (!size) return 0;
    m->desc.input.cap_table = 1;
    float *table = malloc((size_t)size * (size_t)size * sizeof *table);
    if (table && ssgi_cap_table(table, size, &why) == SSGI_OK)
        m->run->cap = kit_keep(m->run, kit_texture(size, size, GL_R32F, table));
    free(table);
    return m->run->cap ? 0 : kit_fail(m->err, "--set cap_table=%d: %s", size, why);
}

int kit_open_field(kit_making *m, const float picture[16])
{
    const kit_scene *scene = m->world->scene;
    occluders all = { 0 };
    int failed;
    if (!scene) return kit_fail(m->err, "method aof: a frame has no objects to bake; it needs a scene");
    if (add_cap_table(m)) return -1;
    if (!m->set->own && m->run->gbuffer->object) m->desc.input.objects = SSGI_GL_OBJECTS_TEXTURE;
    all.field = malloc((size_t)(scene->shapes + 1) * sizeof *all.field);
    all.rows = calloc((size_t)(scene->objects + 1), sizeof *all.rows);
    failed = all.field && all.rows ? add_occluders(m, &all, picture)
                                   : kit_fail(m->err, "no memory for %d objects", scene->objects);
    free(all.field);
    free(all.rows);
    return failed;
}
