/* cloth.c - what the parts of rooms are made of: rods, rings, vessels, pillows, cloth. Declared in rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>

/* ---- >>helpers --------------------------------------------------------------------------------------------------- */

void room_paint(kit_build *b, const float c[3], double vary)
{
    const double by = 1 + kit_between(b, -vary, vary);
    kit_colour(b, fmin(0.9, by * (double)c[0]), fmin(0.9, by * (double)c[1]), fmin(0.9, by * (double)c[2]));
}

void room_cover(kit_build *b)
{
    static const float covers[][3] = { { 0.55f, 0.12f, 0.10f }, { 0.12f, 0.20f, 0.42f }, { 0.15f, 0.33f, 0.20f },
                                       { 0.75f, 0.70f, 0.60f }, { 0.10f, 0.10f, 0.11f }, { 0.78f, 0.55f, 0.15f },
                                       { 0.82f, 0.82f, 0.80f }, { 0.35f, 0.22f, 0.14f }, { 0.45f, 0.50f, 0.52f },
                                       { 0.60f, 0.30f, 0.35f }, { 0.20f, 0.45f, 0.48f } };
    KIT_TINT(b, covers, 0.25);
}

void room_rod(kit_build *b, double x0, double y0, double z0, double x1, double y1, double z1, double radius)
{
    const double at[2][3] = { { x0, y0, z0 }, { x1, y1, z1 } };
    kit_tube(b, at, 2, radius, radius > 0.015 ? 14 : 8);
}

void room_ball(kit_build *b, double x, double y, double z, double radius, int cells)
{
    kit_place_at(b, x, y, z, 0);
    kit_patch(b, 2 * cells, cells, kit_sphere_surface, &radius);
    kit_place_at(b, 0, 0, 0, 0);
}

void room_ring(kit_build *b, double x, double y, double z, double turn, double tilt, double radius, double tube)
{
    const double ring[2] = { radius, tube };
    kit_place_tilted(b, x, y, z, turn, tilt);
    kit_patch(b, radius > 0.15 ? 40 : 20, 8, kit_torus_surface, ring);
    kit_place_at(b, 0, 0, 0, 0);
}

void room_vessel(kit_build *b, double x, double y, double z, double foot, double rim, double height, double bulge)
{
    const double wall = fmin(0.004 + 0.03 * rim, 0.5 * fmin(foot, rim));
    const kit_moulding profile[] = { { 0, 0, foot, 0, 0 },
                                     { foot, 0, rim, height, bulge },
                                     { rim, height, rim - wall, height, 0 },
                                     { rim - wall, height, foot - wall, wall, -bulge },
                                     { foot - wall, wall, 0, wall, 0 } };
    kit_place_at(b, x, y, z, 0);
    kit_turned(b, profile, 5, rim > 0.1 ? 36 : 24);
    kit_place_at(b, 0, 0, 0, 0);
}

void room_pillow(kit_build *b, double x, double y, double z, double turn, double tilt, const double half[3])
{
    kit_place_tilted(b, x, y, z, turn, tilt);
    kit_cushion(b, half, 0.45, 14);
    kit_place_at(b, 0, 0, 0, 0);
}

/* a point of the frame in the world */
static void world(const kit_build *b, const double in[3], double out[3])
{
    const kit_frame *f = &b->frame;
    const double a = atan2(f->turn[0][2], f->turn[0][0]), scale = f->scale > 0 ? f->scale : 1;
    out[0] = f->at[0] + scale * (cos(a) * in[0] + sin(a) * in[2]);
    out[1] = f->at[1] + scale * in[1];
    out[2] = f->at[2] + scale * (cos(a) * in[2] - sin(a) * in[0]);
}

void room_lamp_here(kit_room *r, double x, double y, double z)
{
    const double in[3] = { x, y, z };
    double at[3];
    world(r->b, in, at);
    kit_add_lamp(r->p, at[0], at[1], at[2]);
}

void room_sight_here(kit_room *r, double x, double y, double z, double reach)
{
    const double in[3] = { x, y, z };
    double at[3];
    world(r->b, in, at);
    kit_add_sight(r->p, at[0], at[1], at[2], reach);
}

typedef struct cloth {
    room_cloth_point *point;
    const double *of;
} cloth;

static void cloth_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const cloth *c = shape;
    const double e = 0.004, u0 = fmax(0, u - e), u1 = fmin(1, u + e), v0 = fmax(0, v - e), v1 = fmin(1, v + e);
    double p[4][3], du[3], dv[3];
    c->point(c->of, u, v, out->p);
    c->point(c->of, u0, v, p[0]);
    c->point(c->of, u1, v, p[1]);
    c->point(c->of, u, v0, p[2]);
    c->point(c->of, u, v1, p[3]);
    for (int i = 0; i < 3; i++) {
        du[i] = p[1][i] - p[0][i];
        dv[i] = p[3][i] - p[2][i];
    }
    kit_cross(dv, du, out->n);
    if (!kit_unit(out->n)) {
        out->n[0] = out->n[2] = 0;
        out->n[1] = 1;
    }
}

void room_cloth(kit_build *b, int nu, int nv, room_cloth_point *point, const double *of)
{
    const cloth c = { point, of };
    kit_patch(b, nu, nv, cloth_surface, &c);
}

/* width, before, behind, seed */
static void hanging(const double *s, double u, double v, double p[3])
{
    const double round = 0.02, arc = KIT_PI * round, along = v * (s[1] + s[2] + arc) - s[1],
                 down = along < 0 ? -along : fmax(0, along - arc), a = fmin(fmax(along / round, 0), KIT_PI);
    const double fold = kit_noise((unsigned)s[3], 9 * u * s[0] / 0.6, 1.5 * down, 0) * fmin(1, down / 0.2);
    p[0] = s[0] * (u - 0.5) * (1 - 0.1 * fmin(1, down)) + 0.012 * fold;
    p[1] = round * sin(a) - down;
    p[2] = round * cos(a) + (along < 0 ? 1 : -1) * 0.022 * (fold + fmin(1, down / 0.2) * 0.8);
}

void room_hang_cloth(kit_build *b, double width, double before, double behind)
{
    const double of[4] = { width, before, behind, floor(kit_between(b, 0, 1e6)) };
    room_cloth(b, 20, 24, hanging, of);
}
