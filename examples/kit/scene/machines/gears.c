/* gears.c - assemblies seen close: gears, shafts, a gearbox, a star engine. Declared in machines.h. */
#include "kit/scene/machines/machines.h"
#include <math.h>
#include <string.h>

/* ---- >>gears --------------------------------------------------------------------------------------------------- */

/* the k-th of 4 points a tooth has: on the foot, up, along the head, down */
static void tooth_point(double out[2], double radius, int teeth, int k, double turn)
{
    static const double part[4] = { 0.02, 0.3, 0.48, 0.76 };
    const double depth = 2.2 * radius / teeth,
                 r = k % 4 == 1 || k % 4 == 2 ? radius + 0.45 * depth : radius - 0.55 * depth;
    const double a = 2 * KIT_PI * (k / 4 + part[k % 4] - 0.39) / teeth + turn;
    out[0] = r * cos(a);
    out[1] = r * sin(a);
}

/* the toothed rim, from radius inner on */
static void rim(kit_build *b, double radius, double inner, int teeth, double height, double twist)
{
    const int steps = fabs(twist) > 0 ? 5 : 1;
    for (int k = 0; k < 4 * teeth; k++) {
        double p[2], q[2];
        for (int j = 0; j < steps; j++) {
            const double t0 = (double)j / steps, t1 = (j + 1.0) / steps;
            double p1[2], q1[2];
            tooth_point(p, radius, teeth, k, twist * t0);
            tooth_point(q, radius, teeth, k + 1, twist * t0);
            tooth_point(p1, radius, teeth, k, twist * t1);
            tooth_point(q1, radius, teeth, k + 1, twist * t1);
            const double flank[4][3] = { { q[0], height * t0, q[1] },
                                         { p[0], height * t0, p[1] },
                                         { p1[0], height * t1, p1[1] },
                                         { q1[0], height * t1, q1[1] } };
            kit_quad(b, flank);
        }
        for (int top = 0; top < 2; top++) {
            const double y = top * height;
            tooth_point(p, radius, teeth, k, top * twist);
            tooth_point(q, radius, teeth, k + 1, top * twist);
            const double lp = inner / sqrt(p[0] * p[0] + p[1] * p[1]), lq = inner / sqrt(q[0] * q[0] + q[1] * q[1]);
            const double face[4][3] = {
                { lp * p[0], y, lp * p[1] }, { lq * q[0], y, lq * q[1] }, { q[0], y, q[1] }, { p[0], y, p[1] }
            };
            const double back[4][3] = {
                { p[0], y, p[1] }, { q[0], y, q[1] }, { lq * q[0], y, lq * q[1] }, { lp * p[0], y, lp * p[1] }
            };
            kit_quad(b, top ? face : back);
        }
    }
}

void plant_gear(kit_build *b, double radius, int teeth, double height, double twist)
{
    const double inner = radius * (1 - 3.4 / teeth) * 0.97, hub = 0.32 * inner, web = 0.3 * height, h = height;
    const kit_moulding half[] = { { inner, h, inner, h - web, 0 },
                                  { inner, h - web, hub, h - web, 0 },
                                  { hub, h - web, hub, 1.15 * h, 0 },
                                  { hub, 1.15 * h, 0.6 * hub, 1.15 * h, 0 },
                                  { 0.6 * hub, 1.15 * h, 0.6 * hub, -0.15 * h, 0 },
                                  { 0.6 * hub, -0.15 * h, hub, -0.15 * h, 0 },
                                  { hub, -0.15 * h, hub, web, 0 },
                                  { hub, web, inner, web, 0 },
                                  { inner, web, inner, 0, 0 } };
    rim(b, radius, inner, teeth, h, twist);
    kit_turned(b, half, 9, 36);
}

/* a shaft with steps, up from y = 0 */
static void shaft(kit_build *b, double radius, double length)
{
    const double r = radius, s = 0.78 * r;
    const kit_moulding m[] = { { 0, 0, 0.9 * s, 0, 0 },
                               { 0.9 * s, 0, s, 0.1 * r, 0 },
                               { s, 0.1 * r, s, 0.2 * length, 0 },
                               { s, 0.2 * length, r, 0.2 * length, 0 },
                               { r, 0.2 * length, r, 0.8 * length, 0 },
                               { r, 0.8 * length, s, 0.8 * length, 0 },
                               { s, 0.8 * length, s, length - 0.1 * r, 0 },
                               { s, length - 0.1 * r, 0.9 * s, length, 0 },
                               { 0.9 * s, length, 0, length, 0 } };
    kit_turned(b, m, 9, 24);
}

/* a ball bearing, lying on the place's y = 0: two races, balls between */
static void bearing(kit_build *b, double radius, double height)
{
    const double at[3] = { b->at[0], b->at[1], b->at[2] }, ball = 0.12 * radius, y = 0.5 * height;
    for (int k = 0; k < 2; k++) {
        const double in = (k ? 0.86 : 0.5) * radius, out = (k ? 1 : 0.64) * radius;
        const kit_moulding race[] = { { in, 0, out, 0, 0 },
                                      { out, 0, out, height, 0 },
                                      { out, height, in, height, 0 } };
        const kit_moulding bore[] = { { in, height, in, 0, 0 } };
        kit_turned(b, race, 3, 32);
        kit_turned(b, bore, 1, 32);
    }
    for (int k = 0; k < 11; k++) {
        const double a = 2 * KIT_PI * k / 11, in[3] = { 0.75 * radius * cos(a), y, 0.75 * radius * sin(a) };
        double out[3];
        kit_rotate(b, in, out);
        for (int i = 0; i < 3; i++) b->at[i] = at[i] + out[i];
        kit_patch(b, 12, 8, kit_sphere_surface, &ball);
    }
    memcpy(b->at, at, sizeof at);
}

/* a plate with bolts at its corners */
static void bolted_plate(kit_build *b, double x0, double z0, double x1, double z1, double y, double thick)
{
    const double edge = 0.06;
    kit_place_at(b, 0, y, 0, 0);
    kit_bevelled(b, x0, 0, z0, x1, thick, z1, 0.15 * thick);
    for (int k = 0; k < 4; k++) {
        kit_place_at(b, k & 1 ? x1 - edge : x0 + edge, y + thick - 0.001, k & 2 ? z1 - edge : z0 + edge, 17.0 * k);
        plant_bolt(b, 0.03, 0.035);
    }
}

void plant_train(kit_build *b)
{
    const double module = kit_between(b, 0.018, 0.03), thick = kit_between(b, 0.06, 0.14),
                 turn = kit_between(b, 0.5, 0.9);
    const int count = 3 + kit_choose(b, 3), helical = kit_odds(b, 0.5);
    double x = -0.7, z = -0.2, old = 0, heading = 0;
    plant_stuff(b, KIT_DARK);
    bolted_plate(b, -1.25, -0.85, 1.25, 0.85, 0.001, 0.05);
    for (int k = 0; k < count; k++) {
        const int teeth = 12 + kit_choose(b, 26);
        const double r = 0.5 * module * teeth, y = 0.16 + (k & 1 && helical ? 0.004 : 0);
        if (k) {
            x += (old + r) * cos(heading);
            z += (old + r) * sin(heading);
        }
        if (k & 1 || kit_odds(b, 0.6)) plant_stuff(b, KIT_STEEL);
        else plant_stuff(b, KIT_BRASS);
        /* a tooth towards the last gear, a gap where the next comes: near enough */
        kit_place_at(b, x, y, z, -(heading + KIT_PI + (k & 1 ? KIT_PI / teeth : 0)) * 180 / KIT_PI);
        plant_gear(b, r, teeth, thick, helical ? (k & 1 ? -1 : 1) * 2 * thick / r * 0.4 : 0);
        plant_stuff(b, KIT_STEEL);
        kit_place_at(b, x, 0.04, z, 0);
        shaft(b, fmin(0.055, 0.16 * r), thick + kit_between(b, 0.2, 0.5));
        kit_place_at(b, x, 0.052, z, 0);
        bearing(b, fmin(0.14, 0.6 * r), 0.05);
        heading = (k & 1 ? 1 : -1) * turn;
        old = r;
    }
    if (kit_odds(b, 0.5)) return;
    plant_stuff(b, KIT_PAINT);
    bolted_plate(b, -1.2, 0.35, 1.2, 0.8, 0.5, 0.03);
    for (int k = 0; k < 4; k++)
        plant_rod(b, KIT_AT(k & 1 ? 1.1 : -1.1, 0.05, k & 2 ? 0.7 : 0.45),
                  KIT_AT(k & 1 ? 1.1 : -1.1, 0.501, k & 2 ? 0.7 : 0.45), 0.03, 12);
}

void plant_gearbox(kit_build *b)
{
    const double w = kit_between(b, 0.8, 1.1), d = 0.45, h = kit_between(b, 0.8, 1.1), t = 0.06;
    const int shafts = 2 + kit_choose(b, 2);
    plant_stuff(b, KIT_PAINT);
    kit_bevelled(b, -w - 0.15, 0.001, -d, w + 0.15, 0.08, d, 0.015);
    kit_box(b, -w, 0.08, -d, w, h, t - d); /* back and ends; the front is off */
    kit_box(b, -w, 0.08, t - d, t - w, h, d);
    kit_box(b, w - t, 0.08, t - d, w, h, d);
    for (int k = 0; k < 5; k++) kit_box(b, w, 0.1, 0.2 * k - 0.41, w + 0.05, h - 0.1, 0.2 * k - 0.39);
    for (int k = 0; k < 14; k++) { /* of the front's joint */
        kit_place_tilted(b, k < 7 ? -w + 0.03 : w - 0.03, 0.15 + (h - 0.22) * (k % 7) / 6, d - 0.001, 0, 90);
        plant_bolt(b, 0.018, 0.02);
    }
    for (int k = 0; k < shafts; k++) {
        const double y = 0.2 + (h - 0.32) * (k + 0.5) / shafts, z = (k & 1 ? 0.12 : -0.1), r = 0.045;
        plant_stuff(b, KIT_STEEL);
        kit_place_tilted(b, -w - 0.25, y, z, 90, 90);
        shaft(b, r, 2 * w + (k ? 0.5 : 0.8));
        for (int side = -1; side < 2; side += 2) {
            kit_place_tilted(b, side * (w - t) - (side > 0 ? 0.07 : 0), y, z, 90, 90);
            bearing(b, 0.15, 0.07);
        }
        for (int g = 0; g < 3; g++) {
            const int teeth = 14 + (7 * g + 9 * k + kit_choose(b, 4)) % 15;
            plant_stuff(b, g == 1 ? KIT_BRASS : KIT_STEEL);
            kit_place_tilted(b, -0.6 * w + 0.52 * w * g + 0.03 * k, y, z, 90, 90);
            plant_gear(b, 0.0118 * teeth, teeth, 0.12, kit_odds(b, 0.5) ? 0.25 : 0);
        }
    }
    if (kit_odds(b, 0.5)) return;
    plant_stuff(b, KIT_PAINT); /* the lid leans in front */
    kit_place_tilted(b, 0.3, 0.02, d + 0.55, 8, -62);
    kit_bevelled(b, -w, 0, 0, w, h, 0.04, 0.01);
}

void plant_coupling(kit_build *b)
{
    const double y = kit_between(b, 0.3, 0.45), r = kit_between(b, 0.05, 0.08);
    plant_stuff(b, KIT_DARK);
    bolted_plate(b, -1.4, -0.4, 1.4, 0.4, 0.001, 0.08);
    plant_stuff(b, KIT_STEEL);
    kit_place_tilted(b, -1.35, y, 0, 90, 90);
    shaft(b, r, 2.7);
    for (int k = -1; k < 2; k += 2) { /* plummer blocks */
        const double x = 0.85 * k;
        plant_stuff(b, KIT_PAINT);
        kit_place_at(b, x, 0.08, 0, 0);
        kit_bevelled(b, -0.1, 0.001, -0.32, 0.1, 0.08, 0.32, 0.01);
        kit_bevelled(b, -0.08, 0.07, -0.18, 0.08, y - 0.08, 0.18, 0.01);
        plant_rod(b, KIT_AT(x - 0.08, y, 0), KIT_AT(x + 0.08, y, 0), 0.18, 28);
        for (int side = -1; side < 2; side += 2) {
            kit_place_at(b, x, 0.159, 0.26 * side, 10);
            plant_bolt(b, 0.04, 0.04);
        }
    }
    plant_stuff(b, KIT_STEEL);
    plant_flange(b, KIT_AT(0, y, 0), KIT_AT(1, y, 0), 0.17);
    for (int k = 0; k < 5; k++) { /* a pulley's grooves */
        const double x = -0.55 + 0.05 * k;
        const kit_moulding groove[] = { { 0.1, 0, 0.3, 0, 0 },
                                        { 0.3, 0, 0.24, 0.024, 0 },
                                        { 0.24, 0.024, 0.3, 0.048, 0 },
                                        { 0.3, 0.048, 0.1, 0.048, 0 } };
        kit_place_tilted(b, x, y, 0, 90, 90);
        kit_turned(b, groove, 4, 36);
    }
    plant_stuff(b, KIT_BRASS);
    kit_place_tilted(b, 0.35, y, 0, 90, 90);
    plant_gear(b, 0.24, 30, 0.12, 0.3);
    kit_place_tilted(b, 1.2, y, 0, 90, 90);
    bearing(b, 0.2, 0.08);
}

/* ---- >>about a shaft ------------------------------------------------------------------------------------------- */

void plant_star_engine(kit_build *b)
{
    const int cylinders = 5 + 2 * kit_choose(b, 3);
    const double y = 1.25, long_way = kit_between(b, 0.5, 0.62), r = kit_between(b, 0.13, 0.17);
    plant_stuff(b, KIT_PAINT);
    plant_rod(b, KIT_AT(0, y, -0.3), KIT_AT(0, y, 0.22), 0.4, 36);
    plant_rod(b, KIT_AT(0, y, 0.22), KIT_AT(0, y, 0.4), 0.25, 28);
    plant_beam(b, KIT_AT(0, 0, -0.25), KIT_AT(0, y - 0.3, -0.2), 0.3, 0.2);
    kit_place_at(b, 0, 0, 0, 0);
    kit_bevelled(b, -0.6, 0.001, -0.6, 0.6, 0.06, 0.5, 0.01);
    for (int k = 0; k < cylinders; k++) {
        const double a = 2 * KIT_PI * (k + 0.25) / cylinders, dx = cos(a), dy = sin(a);
        plant_stuff(b, KIT_STEEL);
        for (int f = 0; f < 9; f++) { /* fins */
            const double s = 0.42 + (long_way - 0.1) * f / 9, e = s + 0.014;
            plant_rod(b, KIT_AT(s * dx, y + s * dy, 0), KIT_AT(e * dx, y + e * dy, 0), r * (1 - 0.01 * f), 20);
        }
        plant_rod(b, KIT_AT(0.35 * dx, y + 0.35 * dy, 0), KIT_AT((0.4 + long_way) * dx, y + (0.4 + long_way) * dy, 0),
                  0.75 * r, 18);
        plant_stuff(b, KIT_DARK);
        const double top = 0.42 + long_way, pushrod = 0.09;
        plant_beam(b, KIT_AT((top - 0.1) * dx, y + (top - 0.1) * dy, 0),
                   KIT_AT((top + 0.03) * dx, y + (top + 0.03) * dy, 0), 0.2, 0.24);
        for (int side = -1; side < 2; side += 2)
            plant_rod(b, KIT_AT(0.3 * dx - side * pushrod * dy, y + 0.3 * dy + side * pushrod * dx, 0.16),
                      KIT_AT(top * dx - side * pushrod * dy, y + top * dy + side * pushrod * dx, 0.12), 0.015, 8);
        plant_stuff(b, KIT_BRASS);
        const double pipe[4][3] = { { top * dx, y + top * dy, -0.1 },
                                    { top * dx, y + top * dy, -0.34 },
                                    { 0.5 * dx, y + 0.5 * dy, -0.38 },
                                    { 0.2 * dx, y + 0.2 * dy, -0.29 } };
        plant_pipe(b, pipe, 4, 0.035, 0);
    }
    plant_stuff(b, KIT_STEEL);
    plant_rod(b, KIT_AT(0, y, 0.4), KIT_AT(0, y, 0.75), 0.05, 20);
    plant_flange(b, KIT_AT(0, y, 0.5), KIT_AT(0, y, 2), 0.1);
}

static void spring(kit_build *b, double x, double y, double length, double radius, int turns)
{
    double at[200][3];
    const int count = 16 * turns < 200 ? 16 * turns : 200;
    for (int k = 0; k < count; k++) {
        const double a = 2 * KIT_PI * k / 16;
        at[k][0] = x + length * k / count;
        at[k][1] = y + radius * cos(a);
        at[k][2] = radius * sin(a);
    }
    kit_place_at(b, 0, 0, 0, 0);
    kit_tube(b, (const double(*)[3])at, count, 0.14 * radius, 8);
}

void plant_stack(kit_build *b)
{
    const double y = kit_between(b, 0.6, 0.9), start = -1.8;
    double x = start;
    plant_stuff(b, KIT_DARK);
    kit_place_at(b, 0, 0, 0, 0);
    kit_box(b, -1.9, 0.001, -0.12, 1.9, 0.05, 0.12);
    for (int side = -1; side < 2; side += 2)
        kit_box(b, 1.8 * side - 0.04, 0.05, -0.05, 1.8 * side + 0.04, y - 0.02, 0.05);
    plant_stuff(b, KIT_STEEL);
    plant_rod(b, KIT_AT(start - 0.1, y, 0), KIT_AT(-start + 0.1, y, 0), 0.022, 12);
    while (x < -start - 0.3) {
        const double r = kit_between(b, 0.15, 0.45), long_way = kit_between(b, 0.04, 0.3);
        plant_stuff(b, kit_odds(b, 0.5) ? KIT_STEEL : kit_odds(b, 0.5) ? KIT_BRASS : KIT_PAINT);
        kit_place_tilted(b, x, y, 0, 90, 90);
        switch (kit_choose(b, 6)) {
        case 0: plant_gear(b, r, 16 + kit_choose(b, 20), 0.6 * long_way + 0.03, 0.2); break;
        case 1: plant_flange(b, KIT_AT(x + 0.05, y, 0), KIT_AT(9, y, 0), 0.55 * r); break;
        case 2: bearing(b, 0.8 * r, 0.08); break;
        case 3: spring(b, x, y, fmax(0.15, long_way), 0.5 * r, 6); break;
        case 4: {
            const kit_moulding open[] = { { 0.05, 0, r, 0, 0 }, { r, 0, r, long_way, 0 } }; /* a cup */
            kit_turned(b, open, 2, 36);
            break;
        }
        default: plant_hoop(b, KIT_AT(x + 0.04, y, 0), 90, 90, 0.7 * r, 0.035, 36);
        }
        x += fmax(0.12, 0.7 * long_way) + kit_between(b, 0.06, 0.16);
    }
}
