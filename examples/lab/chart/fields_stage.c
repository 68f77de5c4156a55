/* fields_stage.c - measures rows of the fields of rigid occluders. Declared in fields_stage.h. */
#include "lab/chart/fields_stage.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

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
