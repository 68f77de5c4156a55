/* views.c - finds the points that a G-buffer shows; adds extra cameras that see them. Declared in kit_run.h. */
#include "kit/kit_run.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Writes the world-space points of a frame into seen, with their sums (x, y, z, count) in sum and the sum of their
   squares. depths gets every 7th depth of the middle of the image; returns the number of these depths. */
static size_t gather_points(kit_seen_places *seen, float *depths, double sum[4], double *squares,
                            const kit_image *frame, const kit_camera *c)
{
    const float *z = kit_image_channel(frame, "Z");
    size_t count = 0;
    for (int i = 0; i < frame->width * frame->height; ++i) {
        const int x = i % frame->width, y = i / frame->width;
        float *at = seen->point[seen->points];
        if (!(z[i] > 0)) continue;
        kit_camera_point(c, x, y, (double)z[i], at);
        at[3] = z[i];
        ++seen->points;
        for (int k = 0; k < 3; ++k) {
            sum[k] += (double)at[k];
            *squares += (double)at[k] * (double)at[k];
        }
        sum[3] += 1;
        const int middle = abs(2 * x - frame->width) < frame->width / 2
                        && abs(2 * y - frame->height) < frame->height / 2;
        if (i % 7 == 0 && middle)
            depths[count++] = z[i];
    }
    return count;
}

int kit_seen(const kit_gbuffer *g, kit_seen_places *seen, kit_error *err)
{
    const kit_camera *c = &g->camera;
    kit_image frame;
    double sum[4] = { 0, 0, 0, 0 }, squares = 0, median = 1;
    memset(seen, 0, sizeof *seen);
    if (kit_gbuffer_read_depth(&frame, g, err)) return -1;
    const size_t room = (size_t)frame.width * (size_t)frame.height + 1;
    float *depths = malloc(room * sizeof *depths);
    seen->point = malloc(room * sizeof *seen->point);
    if (!depths || !seen->point) {
        free(depths);
        free(seen->point);
        seen->point = NULL;
        kit_image_free(&frame);
        return kit_fail(err, "out of memory");
    }
    const size_t count = gather_points(seen, depths, sum, &squares, &frame, c);
    if (count) median = (double)kit_middle(depths, count);
    free(depths);
    kit_image_free(&frame);
    if (!(sum[3] > 0)) sum[3] = 1;
    squares /= sum[3];
    for (int k = 0; k < 3; ++k) {
        seen->all.centre[k] = (float)(sum[k] / sum[3]);
        squares -= sum[k] / sum[3] * (sum[k] / sum[3]);
    }
    kit_camera_point(c, c->width / 2, c->height / 2, median, seen->middle.centre);
    seen->all.radius = (float)(1.8 * sqrt(squares > 0 ? squares : 0)) + fminf(1e-6f, 1e-3f * (float)median);
    seen->middle.radius =
        (float)(c->fovy > 0 ? median * tan((double)c->fovy * KIT_PI / 360) : 0.5 * (double)c->ortho_height)
        * fmaxf(1, (float)c->width / (float)c->height);
    return 0;
}

int kit_view_of(ssgi_view *view, const float projection[16], int depth, int width, int height, kit_error *err)
{
    const char *why = "";
    return ssgi_view_from_projection(view, projection, depth == KIT_DEPTH_NORMAL ? SSGI_CLIP_GL : SSGI_CLIP_ZERO, width,
                                     height, &why)
                   == SSGI_OK
               ? 0
               : kit_fail(err, "%s", why);
}

void kit_rotation_of(float rotation[12], const float a[16], const float b[16])
{
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) {
            rotation[4 * c + r] = 0;
            for (int k = 0; k < 3; ++k) rotation[4 * c + r] += a[4 * k + r] * (b ? b[4 * k + c] : k == c ? 1.0f : 0.0f);
        }
}

/* Places extra camera v so that it looks at a sphere. */
static int extra_camera(kit_camera *c, int v, const float picture[16], const kit_sphere *about, int size,
                        kit_error *err)
{
    const char *why = "";
    float to[16], projection[16], displacement[3], from[16];
    memcpy(from, picture, sizeof from);
    double depth = -(double)from[14];
    for (int k = 0; k < 3; ++k) depth -= (double)from[4 * k + 2] * (double)about->centre[k];
    if (!(c->fovy > 0) && depth > 8 * (double)about->radius)       /* from far away all cameras would see the same */
        from[14] += (float)(depth - 3 * (double)about->radius);
    ssgi_extra_displacement(displacement, v);
    if (ssgi_extra_camera(to, projection, from, about->centre, about->radius, displacement, &why) != SSGI_OK)
        return kit_fail(err, "extra camera: %s", why);
    for (int k = 0; k < 3; ++k) {
        c->eye[k] = -(to[4 * k] * to[12] + to[4 * k + 1] * to[13] + to[4 * k + 2] * to[14]);
        c->up[k] = to[4 * k + 1];
        c->target[k] = c->eye[k] - to[4 * k + 2] * about->radius;
    }
    c->fovy = (float)(2 * atan(1 / (double)projection[5]) * 180 / KIT_PI);
    c->ortho_height = 0;
    c->znear = projection[14] / (projection[10] - 1);
    c->zfar = 0;                           /* the sphere holds visible points alone; the scene continues behind it */
    c->depth = KIT_DEPTH_NORMAL;
    c->shift[0] = c->shift[1] = 0;
    c->width = c->height = size;
    return 0;
}

/* Makes the frames of extra camera v: for its own passes, and for gathers of the main image that read it. */
static void extra_frames(kit_making *m, int v, const ssgi_view *view, const float picture[16], const float to[16])
{
    kit_run *run = m->run;
    ssgi_gl_frame frame = run->frame;
    ssgi_gl_frame_init(&frame, view, run->frame.radius, NULL);
    frame.offset = run->frame.offset;
    frame.thickness_limit = run->frame.thickness_limit;
    frame.fade = run->frame.fade;
    frame.max_slope = run->frame.max_slope;
    frame.lights = run->frame.lights;
    ssgi_gl_harmonics_set(&frame, run->harmonics, m->desc.light.bands, to, NULL);
    kit_rotation_of(frame.rotation, to, NULL);
    run->extra[2 * v] = frame;
    kit_rotation_of(frame.rotation, picture, to);
    run->extra[2 * v + 1] = frame;
}

/* Adds extra camera v: its G-buffer and frames; the depths of its layers go into depth. */
static int add_view(kit_making *m, int v, const float picture[16], const kit_sphere *about, float *depth)
{
    kit_run *run = m->run;
    kit_gbuffer *g = &run->view[v];
    const int size = m->set->view_size, layers = m->desc.gather.view_layers;
    const size_t texels = (size_t)size * (size_t)size;
    kit_camera c = run->gbuffer->camera;
    float to[16], projection[16];
    ssgi_view view;
    if (extra_camera(&c, v, picture, about, size, m->err)
        || kit_gbuffer_from_scene(g, m->world->scene, &c, NULL, m->err)
        || kit_gbuffer_peel(g, m->world->scene, layers, m->err)
        || kit_view_of(&view, g->projection, KIT_DEPTH_NORMAL, size, size, m->err))
        return -1;
    run->views = v + 1;
    kit_camera_matrices(&g->camera, to, projection);
    ssgi_gl_views_set(&run->cameras, v, &view, picture, to, NULL);
    extra_frames(m, v, &view, picture, to);
    for (int j = 0; j < layers; ++j) {
        float *out = depth + texels * (size_t)j;
        if (j ? kit_texture_slice_read(g->layer_depth, j - 1, size, size, 1, out)
              : kit_texture_read(g->depth, size, size, 1, out))
            return kit_fail(m->err, "%s cannot read the extra cameras' depth back", kit_gl_name());
    }
    return 0;
}

int kit_add_views(kit_making *m, const float picture[16], const kit_sphere *about)
{
    kit_run *run = m->run;
    const int size = m->set->view_size, layers = m->desc.gather.view_layers;
    const size_t texels = (size_t)size * (size_t)size * (size_t)layers;
    float *depth = malloc(texels * (size_t)m->desc.gather.views * sizeof *depth);
    int failed = depth ? 0 : kit_fail(m->err, "no memory for %d extra cameras", m->desc.gather.views);
    for (int v = 0; v < m->desc.gather.views && !failed; ++v)
        failed = add_view(m, v, picture, about, depth + texels * (size_t)v);
    if (!failed)
        run->view_depth =
            kit_keep(run, kit_texture_array(size, size, m->desc.gather.views * layers, GL_DEPTH_COMPONENT32F, depth));
    free(depth);
    return failed ? -1 : 0;
}
