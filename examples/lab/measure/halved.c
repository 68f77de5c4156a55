/* halved.c - draws at half the width and height, and enlarges to full size. Declared in halved.h. */
#include "lab/measure/halved.h"

/* Returns the second nearest of count texels to pixel i of a picture twice as wide. The nearest is texel i / 2. */
static int beside(int i, int count)
{
    const int to = i / 2 + (i % 2 ? 1 : -1);
    return to < 0 ? 0 : to < count ? to : count - 1;
}

/* Enlarges a picture to twice the width and height, bilinearly: weights of 9, 3, 3, 1 sixteenths. */
static int doubled(kit_image *out, const kit_image *small, kit_error *err)
{
    if (kit_image_new(out, 2 * small->width, 2 * small->height, "Y", err)) return -1;
    for (int y = 0; y < out->height; ++y)
        for (int x = 0; x < out->width; ++x) {
            const float *near = small->data + y / 2 * small->width,
                        *far = small->data + beside(y, small->height) * small->width;
            const int at = x / 2, next = beside(x, small->width);
            out->data[y * out->width + x] = 0.5625f * near[at] + 0.1875f * (near[next] + far[at]) + 0.0625f * far[next];
        }
    return 0;
}

/* Draws an entry at half the width and height or at full size, reads the picture and scores it. */
static int halved_entry(row *r, kit_run *run, kit_image *picture, stage *s, stage *half, const sized *e, kit_error *err)
{
    kit_image small;
    *r = row_blank(0, s->name, e->entry.label, e->entry.method, e->entry.settings);
    if (stage_run(run, e->half ? half : s, r->method, r->settings, s->radius, err)) return -1;
    kit_run_draw(run, 1);
    if (kit_run_read(e->half ? &small : picture, run, err) || (e->half && doubled(picture, &small, err))) return -1;
    if (e->half) kit_image_free(&small);
    return score_picture(r, s, picture, err);
}

int halved_entries(row *rows, stage *s, const sized *entries, int count, int rounds, kit_image *pictures,
                   kit_error *err)
{
    kit_run run[MOST_ENTRIES];
    stage half = *s;
    kit_camera camera = s->gbuffer.camera;
    camera.width /= 2;
    camera.height /= 2;
    if (kit_gbuffer_from_scene(&half.gbuffer, &s->scene, &camera, NULL, err)) return -1;
    for (int i = 0; i < count; ++i) {
        kit_image picture;
        if (halved_entry(&rows[i], &run[i], &picture, s, &half, &entries[i], err)) return -1;
        if (pictures) pictures[i] = picture; else kit_image_free(&picture);
    }
    const int failed = clock_runs(rows, s, run, count, rounds, err);
    kit_gbuffer_free(&half.gbuffer);
    return failed;
}
