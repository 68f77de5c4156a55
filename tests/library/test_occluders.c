/* test_occluders.c - fields of occluders, drawn: pictures against closed forms and the CPU, the pixels that a draw
   covers, the combination of occluders. */
#include "t.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static kit_error err;

enum { W = 160, H = 90 };

static int scene_of(kit_scene *scene, kit_gbuffer *g, const char *name, const kit_camera *camera)
{
    return see(scene, g, name, NULL, 0, camera, W, H);
}

/* ---- pictures ---------------------------------------------------------------------------------------------------- */

static int drawn_aof(kit_image *out, kit_gbuffer *g, const kit_scene *scene, const char *set)
{
    const kit_world world = { scene, NULL };
    kit_method m;
    OWN(kit_run) run = { 0 };
    if (!TRY(kit_method_find(&m, "aof", &err)) || !TRY(kit_method_set(&m, "field_resolution=8,radii=8,rays=64", &err))
        || !TRY(kit_method_set(&m, set, &err)) || !TRY(kit_run_open(&run, g, &m, 1, &world, &err)))
        return 0;
    kit_run_draw(&run, 0);
    return TRY(kit_run_read(out, &run, &err));
}

/* Checks every pixel of the plane against the closed form of a ball that rests on it. The ball and the background stay
   open. By a table the picture keeps the error that the table's size allows. */
static void ball_on_a_plane(void)
{
    static const struct { const char *set; double most; } tables[] = { { "cap_table=128", 6.6e-4 },
                                                                       { "cap_table=32", 2.9e-3 } };
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    OWN(kit_image) closed = { 0 }, frame = { 0 };
    double off = 0, sum = 0;
    int plane = 0, own = 0;
    if (!scene_of(&scene, &g, "sphere", NULL) || !drawn_aof(&closed, &g, &scene, "")
        || !TRY(kit_gbuffer_read(&frame, &g, &err)))
        return;
    for (int i = 0; i < W * H; ++i) {
        const float z = kit_image_channel(&frame, "Z")[i];
        float p[3];
        if (z > 0) kit_camera_point(&g.camera, i % W, i / W, (double)z, p);
        const double rho2 = z > 0 ? (double)(p[0] * p[0] + p[2] * p[2]) : 0, dark = 1 - (double)closed.data[i];
        if (!(z > 0) || p[1] > 1e-3f) own += closed.data[i] < 1;
        else if (rho2 < 25) {              /* farther away, occlusion is that of the ramp */
            off = fmax(off, fabs(dark - pow(1 + rho2, -1.5)));
            sum += dark;
            ++plane;
        }
    }
    CHECK(off < 0.012 && plane > 1000 && sum > 0.05 * plane && !own,
          "off by %.4f over %d pixels (mean %.3f), %d of the ball's own shaded", off, plane, sum / plane, own);
    t_note("off by %.4f at most", off);
    for (int n = 0; n < 2; ++n) {
        OWN(kit_image) out = { 0 };
        double worst = 0;
        if (!drawn_aof(&out, &g, &scene, tables[n].set)) return;
        for (int i = 0; i < W * H; ++i) worst = fmax(worst, fabs((double)out.data[i] - (double)closed.data[i]));
        CHECK(worst < tables[n].most && worst > 0.01 * tables[n].most, "%s: off by %.2e", tables[n].set, worst);
        t_note("%s: off by at most %.1e", tables[n].set, worst);
    }
}

/* Checks that a draw covers each occluder's sphere of influence: seen from outside, from within, beside the picture and
   behind the eye. Each leaves its share of what the others leave: compared with the product over all occluders at every
   pixel, on the CPU. In the last row no object occludes. */
static void what_a_draw_covers(void)
{
    static const struct { float eye[3], target[3], fovy, height; int depth;
    } camera[] = { { { 0, 6, 12 }, { 0, 0, 0 }, 45, 0, KIT_DEPTH_NORMAL },
                   { { 0.3f, 1.2f, 0.5f }, { 3, 0, -2 }, 100, 0, KIT_DEPTH_INFINITE },
                   { { 6, 8, 4 }, { 0, 0, 0 }, 0, 9, KIT_DEPTH_REVERSED },
                   { { 1, 9, 1 }, { 1, 0, 1.01f }, 30, 0, KIT_DEPTH_NORMAL },
                   { { -5, 2, 0 }, { 5, 1, 0.4f }, 60, 0, KIT_DEPTH_NORMAL },
                   { { 0, 6, 12 }, { 0, 0, 0 }, 45, 0, KIT_DEPTH_NORMAL } };
    enum { SHAPES = 8 };
    const char *set = "reach=2.5,ramp=0.6";
    double worst = 0;
    for (int m = 0; m < ROWS(camera); ++m) {
        OWN(kit_scene) scene = { 0 };
        OWN(kit_gbuffer) g = { 0 };
        kit_camera c;
        OWN(kit_image) out = { 0 }, frame = { 0 };
        if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
        c = scene.camera;
        memcpy(c.eye, camera[m].eye, sizeof c.eye);
        memcpy(c.target, camera[m].target, sizeof c.target);
        c.fovy = camera[m].fovy;
        c.ortho_height = camera[m].height;
        c.depth = camera[m].depth;
        c.shift[0] = 7;
        c.width = W;
        c.height = H;
        const int margin[4] = { 5, 3, 2, 9 };
        kit_scene_move(&scene, 0.2 * m);
        for (int o = 0; o < scene.objects; ++o) scene.object[o].casts &= m + 1 < ROWS(camera);
        if (!TRY(kit_gbuffer_from_scene(&g, &scene, &c, margin, &err)) || !drawn_aof(&out, &g, &scene, set)
            || !TRY(kit_gbuffer_read(&frame, &g, &err)))
            return;
        float view[16], projection[16];
        FREED float *number = malloc((size_t)g.width * (size_t)g.height * sizeof *number);
        kit_camera_matrices(&g.camera, view, projection);
        CHECK(!kit_texture_read(g.object, g.width, g.height, 1, number), "object numbers cannot be read");
        const ssgi_field_desc d = { .resolution = 8, .radii = 8, .rays = 64, .reach = 2.5f };
        const ssgi_field *field[SHAPES] = { NULL };
        double off = 0;
        int met = 0;
        if (!CHECK(scene.shapes <= SHAPES, "%d shapes", scene.shapes)) return;
        for (int o = 0; o < scene.objects; ++o) {
            const int shape = scene.object[o].shape;
            if (scene.object[o].casts
                && !CHECK((field[shape] = kit_field(&scene.shape[shape], &d, NULL, &err)) != NULL, "%s", err.text))
                return;
        }
        for (int i = 0; i < W * H; ++i) {
            const float z = kit_image_channel(&frame, "Z")[i];
            uint32_t shown;
            double expected = 1;
            int by = 0;
            float p[3], n[3];
            memcpy(&shown, &number[(g.viewport[1] + H - 1 - i / W) * g.width + g.viewport[0] + i % W], sizeof shown);
            if (z > 0) {
                kit_camera_point(&g.camera, i % W, i / W, (double)z, p);
                for (int k = 0; k < 3; ++k) {
                    static const char *const names[3] = { "N.X", "N.Y", "N.Z" };
                    n[k] = 0;
                    for (int j = 0; j < 3; ++j) n[k] += view[4 * k + j] * kit_image_channel(&frame, names[j])[i];
                }
            }
            for (int o = 0; o < scene.objects && z > 0; ++o) {
                const kit_object *object = &scene.object[o];
                if (!object->casts || shown == (uint32_t)o + 1) continue;
                const ssgi_field *f = field[object->shape];
                ssgi_field_limits l = ssgi_field_limits_of(f);
                l.ramp = 0.6f * l.reach;
                const double taken = occluded_by(f, &l, object->to_world, p, n);
                expected *= 1 - taken;
                by += taken > 0.02;
            }
            off = fmax(off, fabs(expected - (double)out.data[i]));
            met += by > 1;
        }
        worst = fmax(worst, off);
        CHECK(off < 2e-3 && (met > 300) == (m + 1 < ROWS(camera)), "camera %d: off by %.2g, %d pixels see several", m,
              off, met);
    }
    t_note("six cameras, off by %.1e at most", worst);
}

/* Checks what no row of test_arguments.c can break: a field without texels, limits of this field, a sheared matrix. */
static void refusals(void)
{
    OWN(kit_scene) scene = { 0 };
    ssgi_gl_occluder occluder, was;
    const float aside[3] = { 0.48f, 0.64f, 0.6f };
    float m[16];
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
    const ssgi_field_desc d = { .resolution = 4, .radii = 8, .rays = 64 };
    const ssgi_field *f = kit_field(&scene.shape[scene.object[3].shape], &d, NULL, &err);
    if (!CHECK(f, "%s", err.text)) return;
    const ssgi_field_limits fine = ssgi_field_limits_of(f);
    memset(&was, 0x5a, sizeof was);
    occluder = was;
    rigid_about(m, aside);
    for (int i = 0; i < 12; ++i) m[i] *= 2;
#define REFUSED(name, ...) T_REFUSED(ssgi_gl_occluder_set(__VA_ARGS__, &why), SSGI_BAD_ARGUMENT, name, occluder, was)
    const ssgi_field none = { .resolution = f->resolution, .reach = f->reach };
    REFUSED("field", &occluder, &none, &fine, m, 0, 0);
    const struct { const char *name; ssgi_field_limits l; } bad[] = {
        { "limits.reach", { fine.reach, fine.reach, fine.inside, 1 } },
        { "limits.reach", { fine.ramp, 1.01f * fine.reach, fine.inside, 1 } },
        { "limits.inside", { fine.ramp, fine.reach, 1.1f, 1 } },
        { "limits.power", { fine.ramp, fine.reach, fine.inside, 0 } } };
    for (int k = 0; k < ROWS(bad); ++k) REFUSED(bad[k].name, &occluder, f, &bad[k].l, m, 0, 0);
    m[4] += m[0];                              /* sheared */
    REFUSED("mesh_to_view", &occluder, f, &fine, m, 0, 0);
#undef REFUSED
    m[4] -= m[0];
    for (int i = 2; i < 16; i += 4) m[i] = -m[i];          /* a left-handed engine's */
    CHECK(ssgi_gl_occluder_set(&occluder, f, &fine, m, 0, 0, NULL) == SSGI_OK, "a mirrored occluder is refused");
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            float to = 0;
            for (int j = 0; j < 3; ++j) to += occluder.to_field[i][j] * m[4 * k + j];
            CHECK(fabsf(to - (float)(i == k)) < 1e-6f, "a mirrored occluder: %d %d is %g", i, k, (double)to);
        }
}

void test_occluders(void)
{
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("a ball on a plane is its closed form", ball_on_a_plane);
    RUN("a draw covers each occluder's sphere of influence from anywhere, and takes its share of what is left",
        what_a_draw_covers);
    RUN("an occluder that cannot be set is refused", refusals);
    kit_fields_free();
    kit_gl_close();
}
