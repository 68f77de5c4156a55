/* places.c - divides an image into edges, border and interior, to locate its error. Declared in kit.h. */
#include "kit/kit_trace.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A row or a column of the frame, read as u, which is linear on planes: 1/z if perspective, else z. The background of a
   perspective image has u = 0, at which planes end. */
typedef struct line { const float *z; size_t first, step; int count, perspective; double least; } line;

static double u_of(const line *l, int i)
{
    const float z = l->z[l->first + (size_t)i * l->step];
    return !kit_shown(z) ? 0 : l->perspective ? 1 / (double)z : (double)z;
}

/* Returns whether depth jumps between pixel i and the next: u changes by more, or by less, than on both sides. On a
   plane of any tilt the change is constant; at the fold of two planes it is between theirs. */
static int jumps(const line *l, int i)
{
    const float a = l->z[l->first + (size_t)i * l->step], b = l->z[l->first + (size_t)(i + 1) * l->step];
    const double here = u_of(l, i), next = u_of(l, i + 1), step = next - here;
    const double before = here - u_of(l, i - 1), after = u_of(l, i + 2) - next;
    double off = fmax(step - fmax(before, after), fmin(before, after) - step);
    if (!kit_shown(a) && !kit_shown(b)) return 0;
    if (!l->perspective && kit_shown(a) != kit_shown(b)) return 1;
    if (!(off > 0)) return 0;
    if (kit_shown(a) != kit_shown(b)) return 1;
    if (l->perspective) off *= (double)a * (double)b;          /* converts the difference of u to one of depths */
    return off > fmax(l->least, 0.002 * fmin((double)a, (double)b));
}

/* Marks the pixels beside each jump and the next two. The outermost pairs are not tested, because their outer
   neighbours are unknown. */
static void mark(float *edge, const line *l)
{
    for (int i = 1; i + 2 < l->count; ++i) {
        if (!jumps(l, i)) continue;
        for (int k = i - 2; k <= i + 3; ++k)
            if (k >= 0 && k < l->count) edge[l->first + (size_t)k * l->step] = 1;
    }
}

int kit_image_places(kit_image *out, const kit_image *frame, const kit_camera *camera, float radius, kit_error *err)
{
    const float *z = kit_image_channel(frame, "Z");
    const int width = frame->width, height = frame->height;
    const size_t pixels = (size_t)width * (size_t)height;
    line l = { .z = z, .perspective = camera->fovy > 0, .least = 0.05 * (double)radius };
    float view[16], projection[16], *edge;
    kit_camera c = *camera;
    kit_image image;
    if (!z) return kit_fail(err, "frame: channel Z is missing; edges are found by it");
    if (kit_image_new(&image, width, height, "edge,border,interior", err)) return -1;
    c.width = width;
    c.height = height;
    if (!(c.znear > 0)) c.znear = 1;
    if (!(c.zfar > c.znear)) c.zfar = 2 * c.znear;
    kit_camera_matrices(&c, view, projection);
    edge = image.data;
    for (int y = 0; y < height; ++y) {
        l.first = (size_t)y * (size_t)width; l.step = 1; l.count = width;
        mark(edge, &l);
    }
    for (int x = 0; x < width; ++x) {
        l.first = (size_t)x; l.step = (size_t)width; l.count = height;
        mark(edge, &l);
    }
    for (size_t i = 0; i < pixels; ++i) {
        const int x = (int)(i % (size_t)width), y = (int)(i / (size_t)width);
        const double right = fmin(x, width - 1 - x) + 0.5, up = fmin(y, height - 1 - y) + 0.5;
        const double reach = 0.5 * height * (double)projection[5] * (double)radius / (l.perspective ? (double)z[i] : 1);
        const int near = fmin(right, up) < reach, place = edge[i] > 0 ? 0 : near ? 1 : 2;
        edge[i] = 0;
        if (kit_shown(z[i])) edge[(size_t)place * pixels + i] = 1;
    }
    *out = image;
    return 0;
}

int kit_score_places(kit_score_place place[KIT_PLACES], const kit_image *a, const kit_image *b,
    const char *const *channels, int count, const kit_image *places, kit_error *err)
{
    const size_t pixels = (size_t)places->width * (size_t)places->height;
    const float *first = kit_image_channel(a, channels[0]);
    double squares = 0, all = 0;
    kit_score_place p[KIT_PLACES];
    memset(p, 0, sizeof p);
    for (int k = 0; k < KIT_PLACES; ++k) {
        const float *mask = places->data + (size_t)k * pixels;
        int any = 0;
        for (size_t i = 0; i < pixels && !any; ++i) any = mask[i] > 0 && first && !isnan(first[i]);
        if (any && kit_score_channels(&p[k].score, a, b, channels, count, mask, err)) return -1;
        squares += p[k].score.rmse * p[k].score.rmse * (double)p[k].score.pixels;
        all += (double)p[k].score.pixels;
    }
    for (int k = 0; k < KIT_PLACES; ++k) {
        const double own = p[k].score.rmse * p[k].score.rmse * (double)p[k].score.pixels;
        p[k].error = squares > 0 ? own / squares : 0;
        p[k].area = all > 0 ? (double)p[k].score.pixels / all : 0;
    }
    memcpy(place, p, sizeof p);
    return 0;
}
