/* vessels.c - ducts, fans, meshes, perforated sheets, chains, tanks. Declared in machines.h. */
#include "kit/scene/machines/machines.h"
#include <math.h>
#include <string.h>

/* ---- >>sheets ------------------------------------------------------------------------------------------------ */

void plant_duct(kit_build *b, const double from[3], const double to[3], double wide, double high)
{
    const kit_spot before = plant_spot_now(b);
    const double length = plant_aim(b, from, to), w = 0.5 * wide, h = 0.5 * high, rim = high > 0 ? 0.03 : 0.012;
    const double joint = kit_between(b, 0.9, 1.4);
    if (high > 0) kit_box(b, -w, 0, -h, w, length, h);
    else kit_cylinder(b, w, length, 28);
    for (double y = 0.02; y < length; y += joint) {
        const kit_moulding ring[] = { { w - 0.01, y, w + rim, y, 0 },
                                      { w + rim, y, w + rim, y + 0.03, 0 },
                                      { w + rim, y + 0.03, w - 0.01, y + 0.03, 0 } };
        if (high > 0) kit_box(b, -w - rim, y, -h - rim, w + rim, y + 0.03, h + rim);
        else kit_turned(b, ring, 3, 28);
    }
    plant_go_back(b, before);
}

typedef struct blade {
    double from, to, wide, turn, pitch;
} blade;

static void blade_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const blade *s = shape;
    const double r = s->from + v * (s->to - s->from), pitch = s->pitch * (1 - 0.5 * v),
                 across = (u - 0.5) * s->wide * (1 + 0.6 * v), a = s->turn + across * cos(pitch) / r;
    out->p[0] = r * cos(a);
    out->p[1] = r * sin(a);
    out->p[2] = across * sin(pitch) + 0.06 * s->to * sin(KIT_PI * u);
    out->n[0] = sin(pitch) * sin(a);
    out->n[1] = -sin(pitch) * cos(a);
    out->n[2] = cos(pitch);
}

/* Blades without thickness, a hub, a single-layer shroud, a guard of wires. */
void plant_fan(kit_build *b, double radius, int blades)
{
    const kit_frame before = kit_enter(b, 0, 0, 0, 0, 1);
    const kit_moulding shroud[] = { { 1.03 * radius, -0.3 * radius, 1.03 * radius, 0.25 * radius, 0 },
                                    { 1.03 * radius, 0.25 * radius, 1.12 * radius, 0.32 * radius, 0 } };
    plant_stuff(b, KIT_DARK);
    for (int k = 0; k < blades; k++) {
        const blade s = { 0.2 * radius, 0.97 * radius, 0.5 * radius, 2 * KIT_PI * k / blades, 0.7 };
        kit_patch(b, 6, 8, blade_surface, &s);
    }
    plant_stuff(b, KIT_STEEL);
    plant_rod(b, KIT_AT(0, 0, -0.22 * radius), KIT_AT(0, 0, 0.15 * radius), 0.23 * radius, 20);
    plant_aim(b, KIT_AT(0, 0, 0), KIT_AT(0, 0, 1));
    kit_turned(b, shroud, 2, 36);
    for (int k = 1; k < 7; k++)
        plant_hoop(b, KIT_AT(0, 0, 0.29 * radius), 0, 90, 0.17 * k * radius, 0.006 * radius + 0.001, 28);
    for (int k = 0; k < 4; k++) {
        const double x = radius * cos(KIT_PI * k / 4), y = radius * sin(KIT_PI * k / 4);
        plant_rod(b, KIT_AT(-1.05 * x, -1.05 * y, 0.28 * radius), KIT_AT(1.05 * x, 1.05 * y, 0.28 * radius),
                  0.012 * radius, 6);
    }
    kit_leave(b, before);
}

void plant_wires(kit_build *b, double wide, double high, double pitch, double radius)
{
    const int nx = (int)(wide / pitch), ny = (int)(high / pitch);
    const double w = 0.5 * wide, at[3] = { b->at[0], b->at[1], b->at[2] };
    for (int k = 0; k <= nx; k++) {
        const double x = -w + wide * k / nx, wire[2][3] = { { x, 0, -radius }, { x, high, -radius } };
        kit_tube(b, wire, 2, radius, 4);
    }
    for (int k = 0; k <= ny; k++) {
        const double y = high * k / ny, wire[2][3] = { { -w, y, radius }, { w, y, radius } };
        kit_tube(b, wire, 2, radius, 4);
    }
    memcpy(b->at, at, sizeof at);
}

void plant_perforated(kit_build *b, double wide, double high, int nx, int ny)
{
    static const double edge[8][2] = { { 0.5, 0 },  { 0.5, 0.5 },   { 0, 0.5 },  { -0.5, 0.5 },
                                       { -0.5, 0 }, { -0.5, -0.5 }, { 0, -0.5 }, { 0.5, -0.5 } };
    const double cx = wide / nx, cy = high / ny, r = 0.36 * fmin(cx, cy);
    for (int k = 0; k < nx * ny; k++) {
        const double x = (k % nx + 0.5) * cx - 0.5 * wide, y = (k / nx + 0.5) * cy;
        for (int j = 0; j < 8; j++) {
            const int n = (j + 1) % 8;
            const double a = KIT_PI * j / 4, c = KIT_PI * n / 4;
            const double piece[4][3] = { { x + r * cos(a), y + r * sin(a), 0 },
                                         { x + cx * edge[j][0], y + cy * edge[j][1], 0 },
                                         { x + cx * edge[n][0], y + cy * edge[n][1], 0 },
                                         { x + r * cos(c), y + r * sin(c), 0 } };
            kit_quad(b, piece);
        }
    }
}

static void link_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, longer = 3 * sin(2 * KIT_PI * u);
    kit_torus_surface(shape, u, v, out);
    out->p[2] += 0.5 * s[0] * fmax(-1, fmin(1, longer));
}

void plant_links(kit_build *b, const double from[3], double length, double link)
{
    const kit_spot before = plant_spot_now(b);
    const double ring[2] = { 0.3 * link, 0.09 * link };
    const int count = (int)(length / (0.72 * link));
    for (int k = 0; k < count; k++) {
        kit_place_tilted(b, from[0], from[1] - 0.72 * link * (k + 0.5), from[2], k & 1 ? 90 : 0, 90);
        kit_patch(b, 12, 6, link_surface, ring);
    }
    plant_go_back(b, before);
}

/* ---- >>tanks ------------------------------------------------------------------------------------------------- */

static void vessel(kit_build *b, double radius, double height)
{
    const double d = 0.3 * radius;
    const kit_moulding shell[] = { { 0, 0, radius, d, 0.4 * d },
                                   { radius, d, radius, height - d, 0 },
                                   { radius, height - d, 0, height, 0.4 * d } };
    const double seam[] = { d, 0.35 * height, 0.68 * height, height - d };
    kit_turned(b, shell, 3, 40);
    for (int k = 0; k < 4; k++) {
        const kit_moulding ring[] = { { radius, seam[k] - 0.02, radius + 0.012, seam[k] - 0.01, 0 },
                                      { radius + 0.012, seam[k] - 0.01, radius + 0.012, seam[k] + 0.01, 0 },
                                      { radius + 0.012, seam[k] + 0.01, radius, seam[k] + 0.02, 0 } };
        kit_turned(b, ring, 3, 40);
    }
}

void plant_tank(kit_build *b, double radius, double height, double legs)
{
    const kit_spot before = plant_spot_now(b);
    const double r = 0.8 * radius, nozzle = kit_between(b, 0.05, 0.1), hatch = kit_between(b, 0.3, 0.6);
    kit_place_at(b, 0, legs, 0, 0);
    vessel(b, radius, height);
    for (int k = 0; k < 4; k++) {
        const double x = r * cos(KIT_PI * (k + 0.5) / 2), z = r * sin(KIT_PI * (k + 0.5) / 2);
        plant_rod(b, KIT_AT(x, 0.02, z), KIT_AT(x, legs + 0.25 * radius, z), 0.07 * radius + 0.02, 12);
        kit_place_at(b, x, 0, z, 45.0 * k);
        kit_box(b, -0.15 * radius, 0.001, -0.15 * radius, 0.15 * radius, 0.02, 0.15 * radius);
    }
    plant_rod(b, KIT_AT(0, legs + hatch * height, 0.9 * radius), KIT_AT(0, legs + hatch * height, 1.12 * radius),
              0.28 * radius, 24);
    plant_flange(b, KIT_AT(0, legs + hatch * height, 1.12 * radius), KIT_AT(0, legs + hatch * height, 9),
                 0.24 * radius);
    plant_rod(b, KIT_AT(0, legs + height - 0.05, 0), KIT_AT(0, legs + height + 0.15, 0), nozzle, 16);
    plant_flange(b, KIT_AT(0, legs + height + 0.15, 0), KIT_AT(0, 99, 0), nozzle);
    plant_gauge(b, KIT_AT(0.5 * radius, legs + 0.75 * height, 1.02 * radius), 25, 0.08);
    plant_go_back(b, before);
}

void plant_lying_tank(kit_build *b, double radius, double length, double legs)
{
    const kit_spot before = plant_spot_now(b);
    kit_place_tilted(b, -0.5 * length, legs + radius, 0, 90, 90);
    vessel(b, radius, length);
    for (int side = -1; side < 2; side += 2) {
        const double x = 0.28 * side * length;
        kit_place_at(b, x, 0, 0, 0);
        kit_box(b, -0.07, 0.001, -0.8 * radius, 0.07, legs + 0.42 * radius, 0.8 * radius);
        kit_box(b, -0.2, 0.001, -0.9 * radius, 0.2, 0.05, 0.9 * radius);
        plant_rod(b, KIT_AT(x, legs + 1.9 * radius, 0), KIT_AT(x, legs + 2.3 * radius, 0), 0.16 * radius, 16);
        plant_flange(b, KIT_AT(x, legs + 2.3 * radius, 0), KIT_AT(x, 99, 0), 0.15 * radius);
    }
    plant_gauge(b, KIT_AT(0.1 * length, legs + radius, 1.03 * radius), 0, 0.07 + 0.05 * radius);
    plant_go_back(b, before);
}

/* ---- >>tanks with what belongs to them -------------------------------------------------------------------------- */

void plant_standing_tank(kit_build *b)
{
    const double radius = kit_between(b, 0.45, 0.8), height = kit_between(b, 1.6, 2.6);
    plant_stuff(b, kit_odds(b, 0.6) ? KIT_STEEL : KIT_PAINT);
    plant_tank(b, radius, height, kit_between(b, 0.3, 0.6));
}

void plant_resting_tank(kit_build *b)
{
    const double radius = kit_between(b, 0.4, 0.75), length = kit_between(b, 1.8, 3);
    plant_stuff(b, kit_odds(b, 0.6) ? KIT_PAINT : KIT_STEEL);
    plant_lying_tank(b, radius, length, kit_between(b, 0.2, 0.7));
}

void plant_column(kit_build *b)
{
    const double radius = kit_between(b, 0.5, 1.1), height = kit_between(b, 4.5, 8);
    plant_stuff(b, KIT_STEEL);
    plant_tank(b, radius, height, kit_between(b, 0.8, 1.4));
    plant_stuff(b, KIT_PIPE);
    for (int k = 0; k < 3; k++) {
        const double a = kit_between(b, 2, 5), y = height * (0.35 + 0.2 * k), c = cos(a), s = sin(a),
                     out = radius + 0.35 + 0.1 * k;
        const double pipe[4][3] = { { 0.95 * radius * c, y, 0.95 * radius * s },
                                    { out * c, y, out * s },
                                    { out * c, 0.3, out * s },
                                    { (out + 1) * c, 0.3, (out + 1) * s } };
        plant_pipe(b, pipe, 4, 0.05 + 0.03 * k, 1);
    }
    plant_stuff(b, KIT_PAINT);
    const kit_frame before = kit_enter(b, 0, 0, 0, kit_between(b, 60, 300), 1);
    const kit_frame inner = kit_enter(b, 0, 0, radius, 0, 1);
    plant_ladder(b, height, 1);
    kit_leave(b, inner);
    kit_leave(b, before);
    for (int k = 0; k < 2 && height > 5; k++)
        plant_hoop(b, KIT_AT(0, height * (0.5 + 0.3 * k), 0), 0, 0, radius + 0.9, 0.022, 40);
}

void plant_ball_tank(kit_build *b)
{
    const double radius = kit_between(b, 1.2, 1.9), y = radius + 1;
    plant_stuff(b, KIT_PAINT);
    kit_place_at(b, 0, y, 0, 0);
    kit_patch(b, 56, 32, kit_sphere_surface, &radius);
    plant_hoop(b, KIT_AT(0, y, 0), 0, 0, radius, 0.03, 56);
    for (int k = 0; k < 8; k++) {
        const double a = 2 * KIT_PI * k / 8, n = a + 2 * KIT_PI / 8, r = 0.97 * radius;
        plant_rod(b, KIT_AT(r * cos(a), 0, r * sin(a)), KIT_AT(r * cos(a), y, r * sin(a)), 0.09, 12);
        plant_rod(b, KIT_AT(r * cos(a), 0.3, r * sin(a)), KIT_AT(r * cos(n), y - 0.4, r * sin(n)), 0.02, 8);
    }
    plant_stuff(b, KIT_PIPE);
    const double pipe[4][3] = { { 0, 1.05, 0 }, { 0, 0.35, 0 }, { radius + 0.8, 0.35, 0 }, { radius + 0.8, 1.4, 0 } };
    plant_pipe(b, pipe, 4, 0.12, 1);
    plant_valve(b, KIT_AT(radius, 0.35, 0), 0, 0, 0.12);
}
