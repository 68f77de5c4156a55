/* plant.c - rods, beams, pipes, valves, gratings, rails, ladders, steps. Declared in machines.h. */
#include "kit/scene/machines/machines.h"
#include <math.h>
#include <string.h>

void plant_stuff(kit_build *b, int stuff)
{
    static const float steel[][3] = { { 0.58f, 0.58f, 0.58f }, { 0.46f, 0.47f, 0.48f }, { 0.66f, 0.66f, 0.64f } },
                       dark[][3] = { { 0.12f, 0.12f, 0.13f }, { 0.2f, 0.2f, 0.21f }, { 0.16f, 0.14f, 0.13f } },
                       paint[][3] = { { 0.3f, 0.42f, 0.36f },  { 0.14f, 0.27f, 0.46f }, { 0.68f, 0.64f, 0.52f },
                                      { 0.72f, 0.34f, 0.08f }, { 0.74f, 0.58f, 0.1f },  { 0.52f, 0.53f, 0.54f },
                                      { 0.54f, 0.13f, 0.1f },  { 0.2f, 0.4f, 0.42f },   { 0.76f, 0.76f, 0.74f } },
                       pipe[][3] = { { 0.62f, 0.62f, 0.62f }, { 0.22f, 0.4f, 0.24f }, { 0.2f, 0.32f, 0.55f },
                                     { 0.62f, 0.5f, 0.14f },  { 0.52f, 0.2f, 0.12f }, { 0.72f, 0.72f, 0.7f },
                                     { 0.58f, 0.34f, 0.2f },  { 0.4f, 0.38f, 0.36f } },
                       concrete[][3] = { { 0.52f, 0.5f, 0.47f }, { 0.42f, 0.42f, 0.42f }, { 0.6f, 0.58f, 0.54f } },
                       rubber[][3] = { { 0.05f, 0.05f, 0.05f }, { 0.08f, 0.08f, 0.08f }, { 0.5f, 0.1f, 0.06f } },
                       brass[][3] = { { 0.66f, 0.5f, 0.22f }, { 0.62f, 0.36f, 0.24f } },
                       goods[][3] = { { 0.6f, 0.46f, 0.3f }, { 0.66f, 0.52f, 0.36f }, { 0.74f, 0.72f, 0.68f },
                                      { 0.2f, 0.35f, 0.6f }, { 0.7f, 0.2f, 0.14f },   { 0.3f, 0.5f, 0.3f } },
                       plastic[][3] = { { 0.78f, 0.78f, 0.76f }, { 0.16f, 0.16f, 0.17f }, { 0.2f, 0.36f, 0.62f },
                                        { 0.75f, 0.62f, 0.12f }, { 0.62f, 0.14f, 0.1f },  { 0.1f, 0.34f, 0.2f } };
    switch (stuff) {
    case KIT_STEEL: KIT_TINT(b, steel, 0.15); break;
    case KIT_DARK: KIT_TINT(b, dark, 0.2); break;
    case KIT_PAINT: KIT_TINT(b, paint, 0.12); break;
    case KIT_PIPE: KIT_TINT(b, pipe, 0.15); break;
    case KIT_CONCRETE: KIT_TINT(b, concrete, 0.1); break;
    case KIT_RUBBER: KIT_TINT(b, rubber, 0.2); break;
    case KIT_BRASS: KIT_TINT(b, brass, 0.1); break;
    case KIT_GOODS: KIT_TINT(b, goods, 0.15); break;
    default: KIT_TINT(b, plastic, 0.1);
    }
}

/* ---- >>straight ---------------------------------------------------------------------------------------------- */

double plant_aim(kit_build *b, const double from[3], const double to[3])
{
    double d[3];
    for (int i = 0; i < 3; i++) d[i] = to[i] - from[i];
    const double length = sqrt(kit_dot(d, d)), level = sqrt(d[0] * d[0] + d[2] * d[2]);
    kit_place_tilted(b, from[0], from[1], from[2], level > 1e-9 ? atan2(d[0], d[2]) * 180 / KIT_PI : 0,
                     atan2(level, d[1]) * 180 / KIT_PI);
    return length;
}

kit_spot plant_spot_now(const kit_build *b) { return (kit_spot){ { b->at[0], b->at[1], b->at[2] }, b->turn, b->tilt }; }

void plant_go_back(kit_build *b, kit_spot to) { kit_place_tilted(b, to.at[0], to.at[1], to.at[2], to.turn, to.tilt); }

void plant_rod(kit_build *b, const double from[3], const double to[3], double radius, int around)
{
    const kit_spot before = plant_spot_now(b);
    const double length = plant_aim(b, from, to);
    kit_cylinder(b, radius, length, around);
    plant_go_back(b, before);
}

void plant_beam(kit_build *b, const double from[3], const double to[3], double wide, double deep)
{
    const kit_spot before = plant_spot_now(b);
    const double length = plant_aim(b, from, to);
    kit_box(b, -0.5 * wide, 0, -0.5 * deep, 0.5 * wide, length, 0.5 * deep);
    plant_go_back(b, before);
}

void plant_ibeam(kit_build *b, const double from[3], const double to[3], double size)
{
    const kit_spot before = plant_spot_now(b);
    const double length = plant_aim(b, from, to), h = 0.5 * size, t = 0.07 * size;
    kit_box(b, -h, 0, h - 2 * t, h, length, h);
    kit_box(b, -h, 0, -h, h, length, 2 * t - h);
    kit_box(b, -t, 0, 2 * t - h, t, length, h - 2 * t);
    plant_go_back(b, before);
}

void plant_bolt(kit_build *b, double radius, double height)
{
    double outline[6][2];
    for (int k = 0; k < 6; k++) {
        outline[k][0] = radius * cos(KIT_PI * k / 3);
        outline[k][1] = -radius * sin(KIT_PI * k / 3);
    }
    kit_prism(b, (const double(*)[2])outline, 6, height);
}

void plant_hoop(kit_build *b, const double at[3], double turn, double tilt, double radius, double thick, int around)
{
    const kit_spot before = plant_spot_now(b);
    const double ring[2] = { radius, thick };
    kit_place_tilted(b, at[0], at[1], at[2], turn, tilt);
    kit_patch(b, around, 8, kit_torus_surface, ring);
    plant_go_back(b, before);
}

/* ---- >>pipes ------------------------------------------------------------------------------------------------- */

static void bolt_circle(kit_build *b, double radius, double y, double size, int count)
{
    const double at[3] = { b->at[0], b->at[1], b->at[2] };
    for (int k = 0; k < count; k++) {
        const double a = 2 * KIT_PI * (k + 0.5) / count, in[3] = { radius * cos(a), y, radius * sin(a) };
        double out[3];
        kit_rotate(b, in, out);
        for (int i = 0; i < 3; i++) b->at[i] = at[i] + out[i];
        plant_bolt(b, size, 1.4 * size);
    }
    memcpy(b->at, at, sizeof at);
}

void plant_flange(kit_build *b, const double at[3], const double towards[3], double radius)
{
    const kit_spot before = plant_spot_now(b);
    const double r = 1.65 * radius, t = 0.22 * radius, gap = 0.05 * radius;
    const kit_moulding plates[] = {
        { 0.9 * radius, -t - gap, r, -t - gap, 0 }, { r, -t - gap, r, -gap, 0 },
        { r, -gap, 1.1 * radius, -gap, 0 },         { 1.1 * radius, -gap, 1.1 * radius, gap, 0 },
        { 1.1 * radius, gap, r, gap, 0 },           { r, gap, r, t + gap, 0 },
        { r, t + gap, 0.9 * radius, t + gap, 0 }
    };
    plant_aim(b, at, towards);
    kit_turned(b, plates, 7, 20);
    bolt_circle(b, 1.38 * radius, t + gap - 0.01 * radius, 0.14 * radius, 8);
    plant_go_back(b, before);
}

static double between(const double a[3], const double c[3], double way[3])
{
    for (int i = 0; i < 3; i++) way[i] = c[i] - a[i];
    const double length = sqrt(kit_dot(way, way));
    kit_unit(way);
    return length;
}

void plant_pipe(kit_build *b, const double at[][3], int count, double radius, int flanges)
{
    enum { ARC = 7, MOST = 24 };

    double path[(ARC + 1) * MOST][3], in[3], out[3];
    int n = 0;
    for (int k = 0; k < count && k < MOST; k++) {
        if (!k || k == count - 1) {
            memcpy(path[n++], at[k], sizeof *path);
            continue;
        }
        const double first = between(at[k - 1], at[k], in), second = between(at[k], at[k + 1], out),
                     cut = fmin(2.6 * radius, 0.45 * fmin(first, second));
        for (int j = 0; j <= ARC; j++, n++) {
            const double t = (double)j / ARC;
            for (int i = 0; i < 3; i++) path[n][i] = at[k][i] - cut * (1 - t) * (1 - t) * in[i] + cut * t * t * out[i];
        }
    }
    const kit_spot before = plant_spot_now(b);
    kit_place_at(b, 0, 0, 0, 0);
    kit_tube(b, (const double(*)[3])path, n, radius, radius > 0.06 ? 18 : radius > 0.02 ? 12 : 8);
    plant_go_back(b, before);
    if (!flanges) return;
    for (int k = 0; k + 1 < count; k++) {
        const double length = between(at[k], at[k + 1], in), cut = k ? 2.9 * radius : 0.5 * radius;
        double place[3];
        if (length < 8 * radius || (k && kit_odds(b, 0.4))) continue;
        for (int i = 0; i < 3; i++) place[i] = at[k][i] + cut * in[i];
        plant_flange(b, place, at[k + 1], radius);
    }
}

void plant_valve(kit_build *b, const double at[3], double turn, int upright, double radius)
{
    const double tilt = upright ? 90 : 0, r = radius, long_way = 2.2 * r, wheel[2] = { 1.7 * r, 0.16 * r },
                 ball = 1.5 * r;
    const kit_frame before = kit_enter(b, at[0], at[1], at[2], turn, 1);
    kit_patch(b, 20, 12, kit_sphere_surface, &ball);
    plant_flange(b, upright ? KIT_AT(0, long_way, 0) : KIT_AT(long_way, 0, 0),
                 upright ? KIT_AT(0, 9, 0) : KIT_AT(9, 0, 0), r);
    plant_flange(b, upright ? KIT_AT(0, -long_way, 0) : KIT_AT(-long_way, 0, 0),
                 upright ? KIT_AT(0, -9, 0) : KIT_AT(-9, 0, 0), r);
    kit_place_tilted(b, 0, 0, 0, 0, tilt);
    const kit_moulding bonnet[] = { { r, 0, 0.7 * r, 2 * r, 0 },
                                    { 0.7 * r, 2 * r, 1.1 * r, 2 * r, 0 },
                                    { 1.1 * r, 2 * r, 1.1 * r, 2.3 * r, 0 },
                                    { 1.1 * r, 2.3 * r, 0.2 * r, 2.3 * r, 0 },
                                    { 0.2 * r, 2.3 * r, 0.2 * r, 4.4 * r, 0 },
                                    { 0.2 * r, 4.4 * r, 0, 4.4 * r, 0 } };
    kit_turned(b, bonnet, 6, 14);
    plant_stuff(b, KIT_PAINT);
    kit_place_tilted(b, 0, upright ? 0 : 3.8 * r, upright ? 3.8 * r : 0, 0, tilt);
    kit_patch(b, 24, 8, kit_torus_surface, wheel);
    kit_box(b, -1.65 * r, -0.1 * r, -0.14 * r, 1.65 * r, 0.1 * r, 0.14 * r);
    kit_box(b, -0.12 * r, -0.08 * r, -1.65 * r, 0.12 * r, 0.08 * r, 1.65 * r);
    kit_leave(b, before);
}

void plant_gauge(kit_build *b, const double at[3], double turn, double radius)
{
    const kit_frame before = kit_enter(b, at[0], at[1], at[2], turn, 1);
    const double ring[2] = { radius, 0.1 * radius };
    plant_stuff(b, KIT_BRASS);
    plant_rod(b, KIT_AT(0, -2.2 * radius, -0.25 * radius), KIT_AT(0, -0.8 * radius, -0.25 * radius), 0.18 * radius, 8);
    plant_rod(b, KIT_AT(0, 0, -0.5 * radius), KIT_AT(0, 0, -0.05 * radius), radius, 20);
    kit_place_tilted(b, 0, 0, 0, 0, 90);
    kit_patch(b, 20, 6, kit_torus_surface, ring);
    kit_colour(b, 0.82, 0.82, 0.8);
    kit_place_tilted(b, 0, 0, -0.04 * radius, 0, 90);
    kit_cylinder(b, 0.9 * radius, 0.02 * radius, 20);
    kit_colour(b, 0.4, 0.05, 0.04);
    kit_place_at(b, 0, 0, 0, 0);
    kit_box(b, -0.04 * radius, -0.1 * radius, 0, 0.04 * radius, 0.7 * radius, 0.03 * radius);
    kit_leave(b, before);
}

/* ---- >>walkways ------------------------------------------------------------------------------------------------ */

void plant_grating(kit_build *b, double x0, double z0, double x1, double z1, double y, double pitch)
{
    const int along = (int)((z1 - z0) / pitch), across = (int)((x1 - x0) / (3 * pitch));
    for (int k = 1; k < along; k++) { /* bars on edge, without thickness */
        const double z = z0 + (z1 - z0) * k / along;
        const double bar[4][3] = { { x0, y - 0.03, z }, { x1, y - 0.03, z }, { x1, y, z }, { x0, y, z } };
        kit_quad(b, bar);
    }
    for (int k = 1; k < across; k++) {
        const double x = x0 + (x1 - x0) * k / across;
        kit_box(b, x - 0.004, y - 0.012, z0, x + 0.004, y - 0.004, z1);
    }
    kit_box(b, x0, y - 0.035, z0 - 0.006, x1, y + 0.002, z0);
    kit_box(b, x0, y - 0.035, z1, x1, y + 0.002, z1 + 0.006);
    kit_box(b, x0 - 0.006, y - 0.034, z0, x0, y + 0.001, z1);
    kit_box(b, x1, y - 0.034, z0, x1 + 0.006, y + 0.001, z1);
}

void plant_railing(kit_build *b, const double from[3], const double to[3], double height)
{
    double way[3];
    const double length = between(from, to, way);
    const int posts = (int)fmax(1, ceil(length / 1.4));
    for (int k = 0; k <= posts; k++) {
        const double t = length * k / posts, x = from[0] + t * way[0], y = from[1] + t * way[1],
                     z = from[2] + t * way[2];
        plant_rod(b, KIT_AT(x, y - 0.02, z), KIT_AT(x, y + height, z), 0.018, 8);
    }
    for (int k = 1; k < 4; k++) {
        const double up = k == 3 ? height : 0.37 * k * height;
        plant_rod(b, KIT_AT(from[0], from[1] + up, from[2]), KIT_AT(to[0], to[1] + up, to[2]), k == 3 ? 0.024 : 0.014,
                  8);
    }
    if (fabs(way[1]) > 0.05) return;
    const double board[4][3] = { { from[0], from[1], from[2] },
                                 { to[0], to[1], to[2] },
                                 { to[0], to[1] + 0.1, to[2] },
                                 { from[0], from[1] + 0.1, from[2] } };
    kit_place_at(b, 0, 0, 0, 0);
    kit_quad(b, board);
}

void plant_ladder(kit_build *b, double height, int cage)
{
    const kit_spot before = plant_spot_now(b);
    for (int side = -1; side < 2; side += 2)
        plant_beam(b, KIT_AT(0.24 * side, 0.0, 0.16), KIT_AT(0.24 * side, height + 0.9, 0.16), 0.015, 0.06);
    for (double y = 0.28; y < height; y += 0.28)
        plant_rod(b, KIT_AT(-0.235, y, 0.16), KIT_AT(0.235, y, 0.16), 0.012, 8);
    for (double y = 0.8; y < height; y += 1.6)
        for (int side = -1; side < 2; side += 2)
            plant_beam(b, KIT_AT(0.24 * side, y, 0), KIT_AT(0.24 * side, y, 0.14), 0.012, 0.04);
    for (double y = 2.3; y < height + 0.9 && cage; y += 0.8) {
        double hoop[13][3];
        for (int k = 0; k <= 12; k++) {
            const double a = KIT_PI * k / 12;
            hoop[k][0] = 0.34 * cos(a);
            hoop[k][1] = y;
            hoop[k][2] = 0.19 + 0.55 * sin(a);
        }
        kit_place_at(b, 0, 0, 0, 0);
        kit_tube(b, (const double(*)[3])hoop, 13, 0.01, 6);
    }
    for (int k = 1; k < 6 && cage && height > 2.6; k++) {
        const double a = KIT_PI * k / 6, x = 0.35 * cos(a), z = 0.19 + 0.56 * sin(a);
        plant_beam(b, KIT_AT(x, 2.25, z), KIT_AT(x, height + 0.9, z), 0.03, 0.008);
    }
    plant_go_back(b, before);
}

void plant_steps(kit_build *b, double wide, double height, double run)
{
    const kit_spot before = plant_spot_now(b);
    const int count = (int)fmax(2, floor(height / 0.19));
    const double half = 0.5 * wide, rise = height / count, tread = run / count;
    for (int k = 0; k < count; k++) {
        kit_place_at(b, 0, 0, 0, 0);
        plant_grating(b, -half, tread * k, half, tread * (k + 1) + 0.02, rise * (k + 1), 0.035);
    }
    for (int side = -1; side < 2; side += 2) {
        const double x = side * (half + 0.02);
        plant_beam(b, KIT_AT(x, 0.04, 0), KIT_AT(x, height - 0.02, run), 0.025, 0.22);
        plant_railing(b, KIT_AT(x, rise, 0.02), KIT_AT(x, height, run), 0.95);
    }
    plant_go_back(b, before);
}
