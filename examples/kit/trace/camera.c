/* camera.c - computes axes, matrices, planes, and rays through pixels of cameras. Declared in kit.h and kit_trace.h. */
#include "kit/kit_trace.h"
#include <math.h>
#include <string.h>

/* ---- cameras ------------------------------------------------------------------------------------------------ */

/* Writes the axes as rows of the rotation. An up along the line of sight is replaced by the axis farthest from it; an
   eye at the target looks along -z. */
void kit_camera_axes(const kit_camera *camera, double axes[3][3])
{
    double *right = axes[0], *up = axes[1], *back = axes[2], wish[3];
    for (int i = 0; i < 3; ++i) {
        back[i] = (double)camera->eye[i] - (double)camera->target[i];
        wish[i] = (double)camera->up[i];
    }
    if (!kit_unit(back)) back[0] = back[1] = 0, back[2] = 1;
    kit_cross(wish, back, right);
    if (kit_dot(right, right) <= 1e-12 * kit_dot(wish, wish) || !kit_unit(right)) {
        int least = 0;
        for (int i = 1; i < 3; ++i)
            if (fabs(back[i]) < fabs(back[least])) least = i;
        for (int i = 0; i < 3; ++i) wish[i] = i == least;
        kit_cross(wish, back, right);
        kit_unit(right);
    }
    kit_cross(back, right, up);
}

void kit_camera_half(const kit_camera *camera, double half[2])
{
    half[1] = camera->fovy > 0 ? tan((double)camera->fovy * KIT_PI / 360) : 0.5 * (double)camera->ortho_height;
    half[0] = half[1] * camera->width / camera->height;
}

void kit_camera_view_ray(const kit_camera *camera, int x, int y, double o[3], double d[3])
{
    double half[2];
    kit_camera_half(camera, half);
    const double at[2] = { half[0] * (2 * (x + 0.5 - (double)camera->shift[0]) / camera->width - 1),
                           half[1] * (1 - 2 * (y + 0.5 + (double)camera->shift[1]) / camera->height) };
    const int flat = !(camera->fovy > 0);
    for (int i = 0; i < 2; ++i) {
        o[i] = flat ? at[i] : 0;
        d[i] = flat ? 0 : at[i];
    }
    o[2] = 0;
    d[2] = -1;
}

/* Sets the near plane a little before the bounds, but at least at a thousandth of the far plane, so that window depth
   stays precise. Orthographic depth is uniform, so a far eye must not widen its range. */
void kit_camera_planes(kit_camera *camera, const kit_mesh *mesh)
{
    double axes[3][3], nearest = 1e300, farthest = 0;
    const int flat = !(camera->fovy > 0);
    kit_camera_axes(camera, axes);
    for (int corner = 0; mesh->triangles && corner < 8; ++corner) {
        double depth = 0;
        for (int i = 0; i < 3; ++i)
            depth -=
                axes[2][i] * ((double)(corner >> i & 1 ? mesh->upper[i] : mesh->lower[i]) - (double)camera->eye[i]);
        nearest = fmin(nearest, depth);
        farthest = fmax(farthest, depth);
    }
    if (!(farthest > 0) || !isfinite(farthest)) farthest = 1;  /* nothing is in front of the camera, so any planes do */
    if (flat) {
        const double spare = 0.01 * (farthest - fmin(fmax(nearest, 0), 0.9 * farthest));
        if (!(camera->zfar > 0)) camera->zfar = (float)(fmax(farthest, (double)camera->znear) + spare);
        if (!(camera->znear > 0)) camera->znear = (float)fmax(fmin(nearest, farthest) - spare, 1e-3 * farthest);
        return;
    }
    if (!(camera->zfar > 0)) camera->zfar = (float)fmax(farthest * 1.01, (double)camera->znear * 2);
    if (!(camera->znear > 0))
        camera->znear = (float)fmin(fmax(nearest * 0.99, (double)camera->zfar * 1e-3), (double)camera->zfar * 0.9);
}

void kit_camera_orbit(kit_camera *camera, const kit_camera *from, double degrees)
{
    const double a = degrees * 0.017453292519943295, c = cos(a), s = sin(a);
    double up[3], away[3], length = 0, along = 0;
    for (int i = 0; i < 3; ++i) length += (double)from->up[i] * (double)from->up[i];
    for (int i = 0; i < 3; ++i) {
        up[i] = (double)from->up[i] / sqrt(length);
        away[i] = (double)from->eye[i] - (double)from->target[i];
        along += up[i] * away[i];
    }
    for (int i = 0; i < 3; ++i) {
        const int k = (i + 1) % 3, n = (i + 2) % 3;
        camera->eye[i] = from->target[i] + (float)(c * away[i] + s * (up[k] * away[n] - up[n] * away[k])
                                                   + (1 - c) * along * up[i]);
    }
}

/* Writes the matrices. An orthographic camera has no far plane at infinity: INFINITE is REVERSED for it. */
void kit_camera_matrices(const kit_camera *camera, float view[16], float projection[16])
{
    double axes[3][3], half[2], eye[3], p[16] = { 0 };
    const double n = (double)camera->znear, f = (double)camera->zfar;
    const double shift[2] = { 2 * (double)camera->shift[0] / camera->width,
                              2 * (double)camera->shift[1] / camera->height };
    kit_camera_axes(camera, axes);
    kit_camera_half(camera, half);
    for (int i = 0; i < 3; ++i) eye[i] = (double)camera->eye[i];
    memset(view, 0, 16 * sizeof *view);
    for (int r = 0; r < 3; ++r) {
        for (int c = 0; c < 3; ++c) view[4 * c + r] = (float)axes[r][c];
        view[12 + r] = (float)-kit_dot(axes[r], eye);
    }
    view[15] = 1;
    p[0] = 1 / half[0];
    p[5] = 1 / half[1];
    if (camera->fovy > 0) {
        p[8] = -shift[0];
        p[9] = -shift[1];
        p[11] = -1;
        p[10] = camera->depth == KIT_DEPTH_NORMAL     ? -(f + n) / (f - n)
                : camera->depth == KIT_DEPTH_REVERSED ? n / (f - n)
                                                      : 0;
        p[14] = camera->depth == KIT_DEPTH_NORMAL     ? -2 * f * n / (f - n)
                : camera->depth == KIT_DEPTH_REVERSED ? f * n / (f - n)
                                                      : n;
    } else {
        p[12] = shift[0];
        p[13] = shift[1];
        p[15] = 1;
        p[10] = camera->depth == KIT_DEPTH_NORMAL ? -2 / (f - n) : 1 / (f - n);
        p[14] = camera->depth == KIT_DEPTH_NORMAL ? -(f + n) / (f - n) : f / (f - n);
    }
    for (int i = 0; i < 16; ++i) projection[i] = (float)p[i];
}

void kit_camera_to_header(kit_header *header, const kit_camera *camera)
{
    float view[16], projection[16];
    double half[2];
    kit_camera_matrices(camera, view, projection);
    kit_camera_half(camera, half);
    for (int i = 0; i < 16; ++i) header->world_to_camera[i] = i % 4 == 2 ? 0 - view[i] : view[i];
    header->orthographic = !(camera->fovy > 0);
    header->height = (float)(2 * half[1]);
    for (int i = 0; i < 2; ++i)
        header->centre[i] = (float)(0 - 2 * half[1] * (double)camera->shift[i] / camera->height);
    header->has |= KIT_HEADER_PLACE | KIT_HEADER_WINDOW;
}

void kit_camera_from_header(kit_camera *camera, const kit_header *header)
{
    const float *m = header->world_to_camera;
    if (header->has & KIT_HEADER_PLACE) {
        double eye[3], far = 1;
        for (int i = 0; i < 3; ++i) {
            eye[i] = 0;
            for (int k = 0; k < 3; ++k) eye[i] -= (double)m[4 * i + k] * (double)m[12 + k];
            far = fmax(far, fabs(eye[i]));        /* from a far eye, a target at distance 1 would be lost in rounding */
        }
        for (int i = 0; i < 3; ++i) {
            camera->eye[i] = (float)eye[i];
            camera->target[i] = (float)(eye[i] + far * (double)m[4 * i + 2]);
            camera->up[i] = m[4 * i + 1];
        }
    }
    if (!(header->has & KIT_HEADER_WINDOW)) return;
    camera->fovy = header->orthographic ? 0 : (float)(360 / KIT_PI * atan((double)header->height / 2));
    camera->ortho_height = header->orthographic ? header->height : 0;
    for (int i = 0; i < 2; ++i)
        camera->shift[i] = (float)(0 - (double)header->centre[i] * camera->height / (double)header->height);
}

void kit_camera_ray(const kit_camera *camera, int x, int y, float origin[3], float direction[3])
{
    double axes[3][3], o[3], d[3];
    kit_camera_axes(camera, axes);
    kit_camera_view_ray(camera, x, y, o, d);
    kit_unit(d);
    for (int i = 0; i < 3; ++i) {
        origin[i] = (float)((double)camera->eye[i] + axes[0][i] * o[0] + axes[1][i] * o[1]);
        direction[i] = (float)(axes[0][i] * d[0] + axes[1][i] * d[1] + axes[2][i] * d[2]);
    }
}

void kit_camera_point(const kit_camera *camera, int x, int y, double view_depth, float point[3])
{
    double axes[3][3], o[3], d[3];
    kit_camera_axes(camera, axes);
    kit_camera_view_ray(camera, x, y, o, d);
    for (int i = 0; i < 3; ++i) {
        double at = (double)camera->eye[i];
        for (int k = 0; k < 3; ++k) at += axes[k][i] * (o[k] + d[k] * view_depth);
        point[i] = (float)at;
    }
}

double kit_screen_radius(const kit_image *frame, const kit_camera *camera, float radius)
{
    const float *z = kit_image_channel(frame, "Z");
    double sum = 0;
    float to_view[16], projection[16];
    size_t seen = 0;
    kit_camera_matrices(camera, to_view, projection);
    for (int i = 0; i < frame->width * frame->height; ++i) {
        if (!(z[i] > 0)) continue;
        sum += camera->fovy > 0 ? 1 / (double)z[i] : 1;
        ++seen;
    }
    return fabs((double)projection[5]) / 2 * (double)radius * sum / fmax(1, (double)seen);
}

int kit_camera_check(const kit_camera *camera, const char *what, kit_error *err)
{
    if (camera->width < 1 || camera->height < 1)
        return kit_fail(err, "%s: camera of %d x %d pixels", what, camera->width, camera->height);
    if (!(camera->fovy > 0 ? camera->fovy < 180 : camera->ortho_height > 0))
        return kit_fail(err, "%s: camera: fovy %g must be below 180, or 0 with an ortho_height above 0 (%g)", what,
                        (double)camera->fovy, (double)camera->ortho_height);
    return 0;
}
