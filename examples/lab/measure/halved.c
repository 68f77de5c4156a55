/* halved.c - drawn at half the width and height, brought to full size. Declared in halved.h. */
#include "lab/measure/halved.h"

/* A picture of half the width and height brought to full size. */
static int doubled(kit_image *out, const kit_image *small, kit_error *err)
{
    if (kit_image_new(out, 2 * small->width, 2 * small->height, "Y", err)) return -1;
    for (int y = 0; y < out->height; ++y)
        for (int x = 0; x < out->width; ++x) {
            double sum = 0;
            for (int k = 0; k < 4; ++k) {                      /* 9 3 3 1 sixteenths */
                const int near_x = k & 1   ? 0
                                   : x % 2 ? 1
                                           : -1,
                          near_y = k & 2   ? 0
                                   : y % 2 ? 1
                                           : -1,
                          at_x = x / 2 + near_x, at_y = y / 2 + near_y;
                const int px = at_x < 0              ? 0
                               : at_x < small->width ? at_x
                                                     : small->width - 1,
                          py = at_y < 0               ? 0
                               : at_y < small->height ? at_y
                                                      : small->height - 1;
                sum += (k & 1 ? 0.75 : 0.25) * (k & 2 ? 0.75 : 0.25) * (double)small->data[py * small->width + px];
            }
            out->data[y * out->width + x] = (float)sum;
        }
    return 0;
}

/* Drawn once, read, scored. */
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
