/* agree.c - measures whether the normals of a frame fit its depth under the camera. Declared in kit.h. */
#include "kit/kit_trace.h"
#include <math.h>
#include <stdlib.h>

/* about so many pixels of a row are checked */
enum { ACROSS = 512 };

/* Writes the vector from the pixel before to the next, along a row (axis 0, to the right) or column (1, up), in view
   space. Returns 0 if they are not on one surface: on a plane u (1/z; z if orthographic) has one step. */
static int along(const kit_camera *camera, const float *z, int x, int y, int axis, double way[3])
{
    const int step[2] = { axis ? 0 : 1, axis ? -1 : 0 }, next = step[0] + step[1] * camera->width;
    const float depth[3] = { z[-next], *z, z[next] };
    double u[3], o[3], d[3];
    for (int i = 0; i < 3; ++i) {
        if (!kit_shown(depth[i])) return 0;
        u[i] = camera->fovy > 0 ? 1 / (double)depth[i] : (double)depth[i];
    }
    const double before = u[1] - u[0], after = u[2] - u[1];
    if (fabs(after - before) > 0.5 * fmin(fabs(before), fabs(after)) + 1e-3 * u[1]) return 0;
    for (int i = 0; i < 3; ++i) way[i] = 0;
    for (int side = -1; side < 2; side += 2) {
        kit_camera_view_ray(camera, x + side * step[0], y + side * step[1], o, d);
        for (int i = 0; i < 3; ++i) way[i] += side * (o[i] + d[i] * (double)depth[side + 1]);
    }
    return 1;
}

/* Returns the tangent of the angle to the view axis; 0 near 0 and 90 degrees, where rounding hides a lens. */
static double slope(const double n[3])
{
    const double across = hypot(n[0], n[1]);
    return across > 0.3 && n[2] > 0.2 ? across / n[2] : 0;
}

int kit_frame_agreement(kit_agreement *out, const kit_image *frame, const kit_camera *camera, kit_error *err)
{
    static const char *const names[4] = { "Z", "N.X", "N.Y", "N.Z" };
    const int larger = frame->width > frame->height ? frame->width : frame->height, stride = 1 + larger / ACROSS;
    kit_camera c = *camera;
    kit_agreement a = { .steeper = 1 };
    const float *channel[4];
    int sloped = 0;
    for (int i = 0; i < 4; ++i)
        if (!(channel[i] = kit_image_channel(frame, names[i])))
            return kit_fail(err, "frame: channel %s is missing", names[i]);
    c.width = frame->width;
    c.height = frame->height;
    double *angle = malloc(2 * (ACROSS + 1) * (ACROSS + 1) * sizeof *angle);
    if (!angle) return kit_fail(err, "frame: out of memory");
    double *const steeper = angle + (ACROSS + 1) * (ACROSS + 1);
    for (int y = 1; y + 1 < c.height; y += stride)
        for (int x = 1; x + 1 < c.width; x += stride) {
            const size_t at = (size_t)y * (size_t)c.width + (size_t)x;
            double right[3], up[3], n[3], of_depth[3];
            for (int i = 0; i < 3; ++i) n[i] = (double)channel[1 + i][at];
            if (!kit_unit(n) || !along(&c, channel[0] + at, x, y, 0, right)
                || !along(&c, channel[0] + at, x, y, 1, up)) continue;
            kit_cross(right, up, of_depth);
            if (!kit_unit(of_depth)) continue;
            const double cosine = kit_dot(n, of_depth), given = slope(n), found = slope(of_depth);
            angle[a.pixels] = acos(fmax(-1, fmin(1, cosine))) * 180 / KIT_PI;
            a.off += angle[a.pixels++] > KIT_OFF;
            if (cosine > 0.5 && given > 0 && found > 0) steeper[sloped++] = given / found;
        }
    if (a.pixels) a.off /= a.pixels, a.angle = kit_median(angle, a.pixels);
    if (sloped) a.steeper = kit_median(steeper, sloped);
    free(angle);
    *out = a;
    return 0;
}
