/* stores.c - shelves, cabinets, racks, robots, conveyors: what stands in rows. Declared in machines.h. */
#include "kit/scene/machines/machines.h"
#include <math.h>
#include <string.h>

void plant_shelving(kit_build *b)
{
    const double w = kit_between(b, 0.6, 1.2), h = kit_between(b, 1.7, 2.4), d = 0.25;
    const int shelves = 4 + kit_choose(b, 3);
    plant_stuff(b, kit_odds(b, 0.5) ? KIT_PAINT : KIT_STEEL);
    for (int k = 0; k < 4; k++) { /* posts of folded sheet */
        const double x = k & 1 ? w : -w, z = k & 2 ? d : -d, in = k & 1 ? -0.04 : 0.04, deep = k & 2 ? -0.04 : 0.04;
        const double front[4][3] = { { x, 0.001, z }, { x + in, 0.001, z }, { x + in, h, z }, { x, h, z } };
        const double side[4][3] = { { x, 0.001, z }, { x, 0.001, z + deep }, { x, h, z + deep }, { x, h, z } };
        kit_quad(b, front);
        kit_quad(b, side);
    }
    plant_beam(b, KIT_AT(-w, 0.2, -d - 0.004), KIT_AT(w, h - 0.1, -d - 0.004), 0.003, 0.03);
    for (int k = 0; k < shelves; k++)
        kit_box(b, 0.002 - w, 0.12 + (h - 0.14) * k / (shelves - 1) - 0.025, 0.002 - d, w - 0.002,
                0.12 + (h - 0.14) * k / (shelves - 1), d - 0.002);
    kit_place_at(b, 0, 0, 0, 0);
    for (int k = 0; k + 1 < shelves; k++) {
        const double y = 0.122 + (h - 0.14) * k / (shelves - 1), room = (h - 0.14) / (shelves - 1) - 0.06;
        for (double x = 0.05 - w, wide; x < w - 0.12; x += wide + kit_between(b, 0.01, 0.06)) {
            const double tall = fmin(room, kit_between(b, 0.08, 0.4)), deep = kit_between(b, 0.12, 0.22);
            wide = fmin(w - 0.045 - x, kit_between(b, 0.1, 0.35));
            if (kit_odds(b, 0.2)) continue;
            plant_stuff(b, kit_odds(b, 0.5) ? KIT_GOODS : KIT_PLASTIC);
            kit_place_at(b, 0, 0, 0, 0);
            if (kit_odds(b, 0.6)) {
                kit_box(b, x, y, -deep, x + wide, y + tall, deep - 0.01);
                continue;
            }
            kit_place_at(b, x + 0.5 * wide, y, 0, 0);
            kit_cylinder(b, fmin(0.45 * wide, 0.2), tall, 18);
        }
    }
}

static void louvres(kit_build *b, double x0, double x1, double y, double z)
{
    for (int k = 0; k < 8; k++) {
        const double s = y + 0.035 * k, slat[4][3] = {
            { x0, s, z }, { x1, s, z }, { x1, s + 0.022, z + 0.014 }, { x0, s + 0.022, z + 0.014 }
        };
        kit_quad(b, slat);
    }
}

void plant_cabinet(kit_build *b)
{
    const int doors = 1 + kit_choose(b, 3);
    float paint[3];
    const double wide = 0.6, half = 0.5 * wide * doors, h = kit_between(b, 1.4, 2.1), d = 0.22,
                 open = kit_odds(b, 0.25) ? 70 : 0;
    plant_stuff(b, KIT_PAINT);
    memcpy(paint, b->albedo, sizeof paint);
    kit_box(b, -half, 0.1, -d, half, h, d);
    kit_box(b, 0.02 - half, 0.001, 0.02 - d, half - 0.02, 0.1, d - 0.03);
    for (int k = 0; k < doors; k++) {
        const double x = wide * k - half;
        const kit_frame before = kit_enter(b, x + 0.008, 0, d + 0.002, k ? 0 : -open, 1);
        kit_bevelled(b, 0, 0.12, 0, wide - 0.016, h - 0.02, 0.022, 0.004);
        louvres(b, 0.12, wide - 0.14, 0.2, 0.022);
        if (kit_odds(b, 0.5)) louvres(b, 0.12, wide - 0.14, h - 0.4, 0.022);
        kit_colour(b, 0.12, 0.12, 0.12);
        kit_box(b, wide - 0.08, 0.9, 0.022, wide - 0.05, 1.08, 0.045);
        for (int j = 0; j < 4 && kit_odds(b, 0.7); j++) {
            plant_stuff(b, KIT_PLASTIC);
            plant_rod(b, KIT_AT(0.15 + 0.09 * j, h - 0.55, 0.02), KIT_AT(0.15 + 0.09 * j, h - 0.55, 0.045), 0.02, 12);
        }
        kit_leave(b, before);
        memcpy(b->albedo, paint, sizeof paint);
    }
}

/* a sloped panel with keys, dials, screens over a body */
void plant_desk(kit_build *b)
{
    const double half = kit_between(b, 0.7, 1.3);
    const double side[5][2] = { { -0.35, 0.001 }, { 0.3, 0.001 }, { 0.45, 0.75 }, { -0.1, 1.05 }, { -0.35, 1.05 } };
    plant_stuff(b, KIT_PAINT);
    for (int k = 0; k < 5; k++) {
        const double *p = side[k], *q = side[(k + 1) % 5];
        const double face[4][3] = {
            { half, p[1], p[0] }, { -half, p[1], p[0] }, { -half, q[1], q[0] }, { half, q[1], q[0] }
        };
        kit_quad(b, face);
    }
    for (int s = -1; s < 2; s += 2)
        for (int k = 1; k < 4; k++) {
            const double tri[4][3] = { { s * half, side[0][1], side[0][0] },
                                       { s * half, side[k][1], side[k][0] },
                                       { s * half, side[k + 1][1], side[k + 1][0] },
                                       { s * half, side[0][1], side[0][0] } };
            kit_quad(b, tri);
        }
    const double slope = atan2(0.3, 0.55) * 180 / KIT_PI;
    for (int k = 0; k < 60; k++) {
        const int column = k % 15, row = k / 15;
        const double t = 0.12 + 0.22 * row;
        if (kit_odds(b, 0.25)) continue;
        plant_stuff(b, KIT_PLASTIC);
        kit_place_tilted(b, half * (column - 7) / 8, 0.75 + 0.3 * t, 0.45 - 0.55 * t, 0, slope);
        if (row & 1) kit_cylinder(b, 0.022, 0.02, 12);
        else kit_box(b, -0.025, 0, -0.02, 0.025, 0.012, 0.02);
    }
    const int screens = 2 + kit_choose(b, 2);
    for (int k = 0; k < screens; k++) {
        kit_colour(b, 0.06, 0.06, 0.07);
        kit_place_tilted(b, half * (0.7 * k - 0.6), 1.12, -0.22, 12 - 12.0 * k, -8);
        kit_bevelled(b, -0.28, 0, -0.03, 0.28, 0.36, 0, 0.01);
        kit_colour(b, 0.2, 0.35, 0.45);
        kit_box(b, -0.25, 0.03, -0.005, 0.25, 0.33, 0.003);
        plant_rod(b, KIT_AT(half * (0.7 * k - 0.6), 1.04, -0.25), KIT_AT(half * (0.7 * k - 0.6), 1.2, -0.25), 0.03, 10);
    }
}

/* ---- >>servers ------------------------------------------------------------------------------------------------- */

static void unit(kit_build *b, double y, double high)
{
    const double f = 0.44, t = y + high - 0.004;
    plant_stuff(b, kit_odds(b, 0.7) ? KIT_DARK : KIT_STEEL);
    kit_box(b, -0.22, y, -0.4, 0.22, t, f);
    switch (kit_choose(b, 4)) {
    case 0: /* drives */
        for (int k = 0; k < 8; k++) {
            plant_stuff(b, KIT_DARK);
            kit_box(b, -0.2 + 0.05 * k, y + 0.006, f, -0.157 + 0.05 * k, t - 0.006, f + 0.012);
        }
        break;
    case 1: /* ports with cables */
        for (int k = 0; k < 7; k++) {
            const double x = -0.18 + 0.055 * k, low = y - kit_between(b, 0.05, 0.3);
            const double cable[4][3] = { { x, 0.5 * (y + t), f },
                                         { x, 0.5 * (y + t), f + 0.05 },
                                         { 0.5 * x + 0.12, low, f + 0.06 },
                                         { 0.225, low - 0.05, f + 0.03 } };
            if (kit_odds(b, 0.35)) continue;
            plant_stuff(b, KIT_PLASTIC);
            plant_pipe(b, cable, 4, 0.005, 0);
        }
        break;
    case 2: louvres(b, -0.2, 0.2, y + 0.004, f); break;
    default:
        plant_stuff(b, KIT_STEEL);
        for (int s = -1; s < 2; s += 2) kit_box(b, 0.2 * s - 0.01, y + 0.008, f, 0.2 * s + 0.01, t - 0.008, f + 0.03);
    }
}

void plant_rack(kit_build *b)
{
    const double h = 2.05, door = kit_chance(b);
    kit_colour(b, 0.1, 0.1, 0.105);
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? 0.25 : -0.298, z = k & 2 ? 0.45 : -0.5;
        kit_box(b, x, 0.001, z, x + 0.048, h, z + 0.05);
    }
    kit_box(b, -0.298, h, -0.5, 0.298, h + 0.03, 0.5);
    kit_box(b, -0.25, 0.03, -0.49, 0.25, 0.06, 0.49);
    for (int s = -1; s < 2; s += 2) { /* side sheets */
        const double x = 0.296 * s,
                     sheet[4][3] = { { x, 0.03, -0.46 }, { x, 0.03, 0.46 }, { x, h, 0.46 }, { x, h, -0.46 } };
        kit_quad(b, sheet);
    }
    for (double y = 0.08, high; y < h - 0.2; y += high) {
        high = 0.0445 * (1 + kit_choose(b, 4));
        if (kit_odds(b, 0.8)) unit(b, y, high);
        kit_place_at(b, 0, 0, 0, 0);
    }
    if (door > 0.6) return;
    kit_colour(b, 0.13, 0.13, 0.14);
    const kit_frame before = kit_enter(b, -0.295, 0.03, 0.52, door < 0.25 ? kit_between(b, -115, -20) : 0, 1);
    kit_place_at(b, 0.295, 0, 0, 0);
    plant_perforated(b, 0.57, h, 8, 28);
    kit_place_at(b, 0, 0, 0, 0);
    kit_box(b, 0.56, 0, -0.008, 0.59, h, 0.012);
    kit_box(b, 0, 0, -0.008, 0.03, h, 0.012);
    plant_rod(b, KIT_AT(0.545, 0.95, 0.03), KIT_AT(0.545, 1.2, 0.03), 0.01, 8);
    kit_leave(b, before);
}

/* ---- >>lines --------------------------------------------------------------------------------------------------- */

static void gripper(kit_build *b, const double at[3])
{
    plant_stuff(b, KIT_DARK);
    plant_rod(b, KIT_AT(at[0], at[1], at[2]), KIT_AT(at[0], at[1] - 0.12, at[2]), 0.07, 16);
    for (int s = -1; s < 2; s += 2) {
        plant_beam(b, KIT_AT(at[0] + 0.06 * s, at[1] - 0.12, at[2]), KIT_AT(at[0] + 0.14 * s, at[1] - 0.22, at[2]),
                   0.03, 0.05);
        plant_beam(b, KIT_AT(at[0] + 0.14 * s, at[1] - 0.2, at[2]), KIT_AT(at[0] + 0.1 * s, at[1] - 0.36, at[2]), 0.025,
                   0.05);
    }
}

void plant_robot(kit_build *b)
{
    const double lift = kit_between(b, 0.5, 1.3), bow = kit_between(b, -0.9, 0.35);
    const double shoulder[3] = { 0, 0.75, 0.05 }, elbow[3] = { 0, 0.75 + 1.05 * sin(lift), 0.05 + 1.05 * cos(lift) };
    const double wrist[3] = { 0, elbow[1] + 0.95 * sin(bow), elbow[2] + 0.95 * cos(bow) };
    const double palm[3] = { 0, wrist[1] - 0.22, wrist[2] + 0.05 };
    plant_stuff(b, KIT_DARK);
    kit_bevelled(b, -0.4, 0.001, -0.4, 0.4, 0.06, 0.4, 0.01);
    plant_stuff(b, KIT_PAINT);
    const kit_moulding base[] = { { 0, 0.06, 0.34, 0.06, 0 },      { 0.34, 0.06, 0.3, 0.28, 0 },
                                  { 0.3, 0.28, 0.33, 0.3, 0 },     { 0.33, 0.3, 0.33, 0.42, 0 },
                                  { 0.33, 0.42, 0.2, 0.55, 0.02 }, { 0.2, 0.55, 0, 0.56, 0 } };
    kit_turned(b, base, 6, 32);
    plant_beam(b, KIT_AT(0, 0.4, 0), shoulder, 0.26, 0.36);
    plant_beam(b, KIT_AT(0.16, shoulder[1], shoulder[2]), KIT_AT(0.16, elbow[1], elbow[2]), 0.1, 0.22);
    plant_beam(b, elbow, wrist, 0.17, 0.19);
    plant_rod(b, wrist, palm, 0.07, 18);
    const double *joint[3] = { shoulder, elbow, wrist };
    for (int k = 0; k < 3; k++) {
        const double r = 0.2 - 0.045 * k, w = 0.24 - 0.04 * k;
        plant_rod(b, KIT_AT(-w, joint[k][1], joint[k][2]), KIT_AT(w, joint[k][1], joint[k][2]), r, 28);
    }
    plant_stuff(b, KIT_DARK);
    for (int k = 0; k < 3; k++) {
        const double r = 0.15 - 0.04 * k, w = 0.3 - 0.05 * k;
        plant_rod(b, KIT_AT(-w, joint[k][1], joint[k][2]), KIT_AT(w, joint[k][1], joint[k][2]), r, 24);
    }
    kit_cable(b, KIT_AT(-0.12, 0.5, -0.3), KIT_AT(-0.2, elbow[1], elbow[2]), -0.15, 0.025, 8);
    kit_cable(b, KIT_AT(-0.2, elbow[1], elbow[2]), KIT_AT(-0.08, wrist[1], wrist[2]), 0.12, 0.02, 8);
    gripper(b, palm);
}

void plant_conveyor(kit_build *b, double length)
{
    const double half = 0.5 * length, y = kit_between(b, 0.6, 0.85), wide = 0.32;
    const int belt = kit_odds(b, 0.5);
    plant_stuff(b, KIT_PAINT);
    for (int s = -1; s < 2; s += 2) {
        kit_box(b, -half, y - 0.1, s * wide - 0.02 + 0.02 * s, half, y + 0.05, s * wide + 0.02 + 0.02 * s);
        if (kit_odds(b, 0.5)) {
            for (double x = 0.3 - half; x < half; x += 1)
                plant_rod(b, KIT_AT(x, y, s * (wide + 0.05)), KIT_AT(x, y + 0.2, s * (wide + 0.03)), 0.01, 6);
            plant_rod(b, KIT_AT(-half, y + 0.2, s * (wide + 0.02)), KIT_AT(half, y + 0.2, s * (wide + 0.02)), 0.014, 8);
            kit_place_at(b, 0, 0, 0, 0);
        }
    }
    plant_stuff(b, belt ? KIT_RUBBER : KIT_STEEL);
    if (belt) kit_box(b, -half, y - 0.02, 0.005 - wide, half, y + 0.02, wide - 0.005);
    for (double x = 0.08 - half; x < half && !belt; x += 0.13)
        plant_rod(b, KIT_AT(x, y - 0.01, 0.002 - wide), KIT_AT(x, y - 0.01, wide - 0.002), 0.03, 12);
    plant_stuff(b, KIT_STEEL);
    for (double x = 0.25 - half; x < half; x += fmax(1.2, 0.2 * length))
        for (int s = -1; s < 2; s += 2) {
            plant_beam(b, KIT_AT(x, 0.02, s * wide), KIT_AT(x, y - 0.1, s * wide), 0.06, 0.04);
            kit_place_at(b, x, 0, s * wide, 0);
            kit_box(b, -0.07, 0.001, -0.05, 0.07, 0.02, 0.05);
            plant_beam(b, KIT_AT(x, 0.2, -wide), KIT_AT(x, 0.2, wide), 0.03, 0.03);
        }
    const int wares = kit_choose(b, 3);
    for (double x = 0.3 - half; x < half - 0.3; x += kit_between(b, 0.35, 1.1)) {
        const double s = kit_between(b, 0.09, 0.24);
        plant_stuff(b, KIT_GOODS);
        kit_place_at(b, x, y + 0.0205, kit_between(b, -0.06, 0.06), kit_between(b, -20, 20));
        if (wares == 0) kit_box(b, -s, 0, -s, s, kit_between(b, 0.1, 0.4), s);
        if (wares == 1)
            for (int k = 0; k < 4; k++)
                plant_rod(b, KIT_AT(x + 0.05 * (k & 1), y + 0.0205, 0.05 * (k >> 1)),
                          KIT_AT(x + 0.05 * (k & 1), y + 0.2, 0.05 * (k >> 1)), 0.024, 12);
        if (wares == 2) plant_gear(b, 0.7 * s + 0.04, 18, 0.07, 0.1);
    }
}

void plant_pallet(kit_build *b)
{
    plant_stuff(b, KIT_GOODS);
    for (int k = 0; k < 5; k++) kit_box(b, -0.6, 0.12, -0.4 + 0.17 * k, 0.6, 0.145, -0.28 + 0.17 * k);
    for (int k = 0; k < 3; k++) kit_box(b, -0.58 + 0.53 * k, 0.001, -0.4, -0.48 + 0.53 * k, 0.12, 0.4);
    const int layers = kit_choose(b, 4), nx = 2 + kit_choose(b, 3), nz = 1 + kit_choose(b, 3);
    const double w = 1.16 / nx, d = 0.76 / nz, h = kit_between(b, 0.2, 0.4);
    plant_stuff(b, KIT_GOODS);
    for (int k = 0; k < layers * nx * nz; k++) {
        const int i = k % nx, j = k / nx % nz, l = k / (nx * nz);
        if (l == layers - 1 && kit_odds(b, 0.3)) continue;
        kit_place_at(b, -0.58 + (i + 0.5) * w, 0.146 + l * (h + 0.002), -0.38 + (j + 0.5) * d, kit_between(b, -2, 2));
        kit_box(b, -0.48 * w, 0, -0.48 * d, 0.48 * w, h, 0.48 * d);
    }
}

void plant_barrels(kit_build *b)
{
    const int count = 1 + kit_choose(b, 5);
    plant_stuff(b, KIT_PAINT);
    for (int k = 0; k < count; k++) {
        const double r = 0.29;
        const kit_moulding m[] = { { 0, 0.02, r - 0.01, 0.02, 0 }, { r, 0, r, 0.3, 0 },
                                   { r, 0.3, r, 0.34, 0.012 },     { r, 0.34, r, 0.58, 0 },
                                   { r, 0.58, r, 0.62, 0.012 },    { r, 0.62, r, 0.9, 0 },
                                   { r, 0.88, 0, 0.88, 0 } };
        kit_place_at(b, 0.62 * (k % 2) - 0.3 + kit_between(b, 0, 0.02), 0.001, 0.62 * (k / 2) - 0.4, 30 * k);
        if (kit_odds(b, 0.3)) plant_stuff(b, KIT_PAINT);
        kit_turned(b, m, kit_odds(b, 0.15) ? 6 : 7, 28); /* some are open */
    }
}

void plant_hose_reel(kit_build *b)
{
    plant_stuff(b, KIT_PLASTIC);
    for (int k = 0; k < 2; k++) plant_rod(b, KIT_AT(0, 0, 0.06 + 0.2 * k), KIT_AT(0, 0, 0.075 + 0.2 * k), 0.3, 32);
    plant_rod(b, KIT_AT(0, 0, 0), KIT_AT(0, 0, 0.3), 0.1, 18);
    plant_stuff(b, KIT_RUBBER);
    for (int k = 0; k < 8; k++)
        plant_hoop(b, KIT_AT(0, 0, 0.095 + 0.041 * (k % 4)), 0, 90, 0.16 + 0.045 * (k / 4), 0.02, 28);
    kit_cable(b, KIT_AT(0.2, -0.05, 0.2), KIT_AT(0.5, -0.6, 0.3), 0.35, 0.02, 8);
}

void plant_stepladder(kit_build *b)
{
    const double h = kit_between(b, 1.2, 2.2), spread = 0.22 * h;
    plant_stuff(b, KIT_STEEL);
    for (int s = -1; s < 2; s += 2) {
        plant_beam(b, KIT_AT(0.24 * s, 0.005, spread), KIT_AT(0.18 * s, h, 0.03), 0.02, 0.06);
        plant_beam(b, KIT_AT(0.24 * s, 0.005, -spread), KIT_AT(0.18 * s, h, -0.03), 0.02, 0.04);
        plant_rod(b, KIT_AT(0.21 * s, 0.45 * h, 0.57 * spread), KIT_AT(0.21 * s, 0.45 * h, -0.57 * spread), 0.005, 6);
    }
    for (double y = 0.25; y < h; y += 0.25) {
        const double z = 0.03 + (spread - 0.03) * (1 - y / h);
        kit_place_at(b, 0, y, z, 0);
        kit_box(b, -0.21, -0.02, -0.05, 0.21, 0, 0.04);
    }
}
