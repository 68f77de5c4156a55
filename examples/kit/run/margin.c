/* margin.c - adds the margin around the image: a wider G-buffer, and the part of it that each pass draws. Declared in
   kit_run.h. */
#include "kit/kit_run.h"
#include <math.h>
#include <stdlib.h>

/* Computes the width of a margin in pixels: see kit_run_open. If the border shows no surface, the depths of the whole
   image count; the margin is 0 if it shows none either. */
static int margin_of(int *pixels, const kit_gbuffer *g, double radius, double margin, kit_error *err)
{
    const int width = g->viewport[2], height = g->viewport[3], most = (width < height ? width : height) / 16 * 4;
    kit_image frame;
    float *depth, *z;
    size_t count = 0;
    double wide = 0;
    if (kit_gbuffer_read_depth(&frame, g, err)) return -1;
    z = kit_image_channel(&frame, "Z");
    depth = malloc((size_t)width * (size_t)height * sizeof *depth);
    for (int all = 0; all < 2 && depth && !count; ++all)
        for (int i = 0; i < width * height; ++i) {
            const int x = i % width, y = i / width, border = !x || !y || x == width - 1 || y == height - 1;
            if (z[i] > 0 && (border || all)) depth[count++] = z[i];
        }
    if (count) {
        const double median = (double)kit_middle(depth, count);
        wide = 0.5 * height * (double)g->projection[5] * radius * margin;
        if (g->camera.fovy > 0) wide /= median;
    }
    kit_image_free(&frame);
    if (!depth) return kit_fail(err, "out of memory");
    free(depth);
    *pixels = wide < most ? 4 * (int)ceil(wide / 4) : most;
    return 0;
}

int kit_add_margin(kit_making *m, kit_gbuffer **g, float radius, int pixels)
{
    kit_run *run = m->run;
    const double margin = m->set->margin;
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

/* Finds how many pixels beyond the image each pass draws; ALL: the whole margin; -1: no pass reads its outputs. */
enum { ALL = 1 << 20 };
static void rims_of(const kit_run *run, int rim[KIT_MAX_PASSES])
{
    int changed = 1;
    for (int i = 0; i < run->passes; ++i) {
        const kit_pass *p = &run->pass[i];
        const int result = draws(p, run->light) || draws(p, run->bounce) || draws(p, run->joint);
        const int all = !p->target[0] || p->gbuffer != run->gbuffer || p->desc.pass == SSGI_GL_PASS_THICKNESS
                     || p->step->scale == SSGI_GL_SCALE_TILES;
        rim[i] = all ? ALL : result ? 0 : -1;
    }
    while (changed) {
        changed = 0;
        for (int j = 0; j < run->passes; ++j) {
            const kit_pass *p = &run->pass[j];
            const int filters = p->desc.pass == SSGI_GL_PASS_BLUR || p->desc.pass == SSGI_GL_PASS_HISTORY;
            const int texel = p->desc.gather.resolution >= SSGI_GL_RESOLUTION_QUARTER ? 4 : 2;
            const int reach = rim[j] + (filters ? texel * (p->desc.filter.radius + 1) : 0);
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
}

void kit_limit_passes(kit_run *run)
{
    int rim[KIT_MAX_PASSES];
    if (!run->margin) return;
    rims_of(run, rim);
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        const int part = kit_step_part(p->step), from = run->margin - rim[i];
        for (int k = 0; k < 2 && rim[i] >= 0 && from > 0; ++k) {
            const int to = run->frame.size[k] - from;
            p->box[k] = from / part;
            p->box[2 + k] = (to + part - 1) / part - p->box[k];
        }
    }
}
