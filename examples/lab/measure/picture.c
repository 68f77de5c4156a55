/* picture.c - draws a method's picture, and looks up its value at a point of the scene. Declared in picture.h. */
#include "lab/measure/picture.h"
#include <math.h>
#include <string.h>

int request_read(request *a, kit_method *m, const char *text, kit_error *err)
{
    const char *const colon = strchr(text, ':');
    snprintf(a->method, sizeof a->method, "%.*s", (int)(colon ? colon - text : (long)strlen(text)), text);
    snprintf(a->settings, sizeof a->settings, "%s", colon ? colon + 1 : "");
    return kit_method_find(m, a->method, err) || kit_method_set(m, a->settings, err) ? -1 : 0;
}

int picture_run(kit_run *run, kit_gbuffer *g, const kit_world *world, const char *method, const char *set, float radius,
                kit_error *err)
{
    kit_method m;
    return kit_method_find(&m, method, err) || kit_method_set(&m, set, err)
                   || kit_run_open(run, g, &m, radius, world, err)
               ? -1
               : 0;
}

int picture_drawn(kit_image *out, kit_gbuffer *g, const kit_world *world, const char *method, const char *set,
                  float radius, kit_error *err)
{
    kit_run run;
    if (picture_run(&run, g, world, method, set, radius, err)) return -1;
    kit_run_draw(&run, 0);
    const int failed = kit_run_read(out, &run, err);
    kit_run_close(&run);
    return failed;
}

int picture_settled(kit_run *run, unsigned first, int timed, kit_error *err)
{
    const int kept = kit_run_keeps(run);
    for (unsigned k = 0; k < (kept ? (unsigned)SETTLED : 1); ++k)
        if (kit_frames_still(run, first, k, timed, err)) return -1;
    return kept;
}

int picture_at(double *value, const float *values, const picture_view *s, const float p[3], uint32_t object)
{
    const float *z = kit_image_channel(s->frame, "Z");
    const int width = s->frame->width, height = s->frame->height;
    float to_view[16], projection[16];
    double v[3], at[2], sum = 0;
    kit_camera_matrices(s->camera, to_view, projection);
    for (int r = 0; r < 3; ++r)
        v[r] = (double)(to_view[r] * p[0] + to_view[4 + r] * p[1] + to_view[8 + r] * p[2] + to_view[12 + r]);
    if (!(v[2] < 0)) return 0;
    at[0] = (0.5 - 0.5 * (double)projection[0] * v[0] / v[2]) * width - 0.5;
    at[1] = (0.5 + 0.5 * (double)projection[5] * v[1] / v[2]) * height - 0.5;
    const int x = (int)floor(at[0]), y = (int)floor(at[1]);
    if (x < 0 || y < 0 || x + 1 >= width || y + 1 >= height) return 0;
    for (int k = 0; k < 4; ++k) {
        const int i = (y + (k >> 1)) * width + x + (k & 1);
        const double across = k & 1 ? at[0] - x : 1 - at[0] + x, down = k & 2 ? at[1] - y : 1 - at[1] + y;
        if ((s->object && s->object[i] != object) || !(fabs((double)z[i] + v[2]) < -0.02 * v[2])) return 0;
        sum += across * down * (double)values[i];
    }
    *value = sum;
    return 1;
}
