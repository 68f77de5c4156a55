/* shop.c - machines, benches, racks, robots and what else stands in plant rooms. Declared in machines.h. */
#include "kit/scene/machines/machines.h"
#include <math.h>
#include <string.h>

/* ---- >>drives -------------------------------------------------------------------------------------------------- */

void plant_motor(kit_build *b, double radius, double length)
{
    const double r = radius, l = length, h = 0.5 * l;
    plant_rod(b, KIT_AT(-h, 0, 0), KIT_AT(h, 0, 0), 0.86 * r, 24);
    plant_rod(b, KIT_AT(h - 0.02, 0, 0), KIT_AT(h + 0.04, 0, 0), r, 24);
    plant_rod(b, KIT_AT(-h - 0.18 * l, 0, 0), KIT_AT(0.02 - h, 0, 0), 0.97 * r, 24);
    for (int k = 0; k < 18; k++) { /* cooling fins */
        const double a = 2 * KIT_PI * k / 18, c = cos(a), s = sin(a), in = 0.84 * r, out = 1.02 * r;
        const double fin[4][3] = { { -0.92 * h, in * c, in * s },
                                   { 0.9 * h, in * c, in * s },
                                   { 0.9 * h, out * c, out * s },
                                   { -0.92 * h, out * c, out * s } };
        kit_place_at(b, 0, 0, 0, 0);
        kit_quad(b, fin);
    }
    kit_bevelled(b, -0.25 * l, 0.9 * r, -0.35 * r, 0.15 * l, 1.35 * r, 0.35 * r, 0.08 * r);
    kit_box(b, -0.8 * h, -1.15 * r, -0.8 * r, -0.5 * h, -0.6 * r, 0.8 * r);
    kit_box(b, 0.5 * h, -1.15 * r, -0.8 * r, 0.8 * h, -0.6 * r, 0.8 * r);
    plant_stuff(b, KIT_STEEL);
    plant_rod(b, KIT_AT(h, 0, 0), KIT_AT(h + 0.4 * r + 0.1, 0, 0), 0.2 * r, 12);
}

/* On a plinth: motor, coupling guard, volute, its pipes upwards to y = 2.2. */
void plant_pump(kit_build *b)
{
    const double r = kit_between(b, 0.18, 0.3), y = 0.15 + 1.25 * r, pipe = 0.32 * r, top = 2.2;
    plant_stuff(b, KIT_CONCRETE);
    kit_bevelled(b, -0.95, 0.001, -0.4, 0.85, 0.12, 0.4, 0.02);
    plant_stuff(b, KIT_DARK);
    kit_box(b, -0.85, 0.121, -0.3, 0.75, 0.16, 0.3);
    plant_stuff(b, KIT_PAINT);
    kit_frame before = kit_enter(b, -0.4, y, 0, 0, 1);
    plant_motor(b, r, 0.7);
    kit_leave(b, before);
    plant_stuff(b, KIT_PAINT);
    plant_rod(b, KIT_AT(0.08, y, 0), KIT_AT(0.28, y, 0), 0.45 * r, 16);
    plant_rod(b, KIT_AT(0.28, y, 0), KIT_AT(0.5, y, 0), 1.05 * r, 28);
    plant_rod(b, KIT_AT(0.26, y, 0), KIT_AT(0.52, y, 0), 0.7 * r, 24);
    kit_box(b, 0.3, 0.14, -0.6 * r, 0.46, y - 0.8 * r, 0.6 * r);
    plant_stuff(b, KIT_PIPE);
    const double out[3][3] = { { 0.39, y, -0.7 * r }, { 0.39, y + 0.5, -0.7 * r }, { 0.39, top, -0.7 * r } };
    const double in[4][3] = { { 0.5, y, 0 }, { 1.1, y, 0 }, { 1.1, top, 0 }, { 1.1, top + 0.02, 0 } };
    plant_pipe(b, out, 3, pipe, 1);
    plant_pipe(b, in, 4, pipe, 1);
    plant_valve(b, KIT_AT(0.39, 1.3, -0.7 * r), kit_odds(b, 0.5) ? 0 : 180, 1, pipe);
    plant_valve(b, KIT_AT(1.1, 1.05, 0), 90, 1, pipe);
    plant_gauge(b, KIT_AT(0.39, 1.75, -0.7 * r + pipe + 0.06), 0, 0.06);
}

void plant_engine(kit_build *b)
{
    const int pairs = 2 + kit_choose(b, 4);
    const double half = 0.32 * pairs + 0.15;
    float paint[3];
    plant_stuff(b, KIT_PAINT);
    memcpy(paint, b->albedo, sizeof paint);
    kit_bevelled(b, -half, 0.2, -0.5, half, 0.85, 0.5, 0.06);
    kit_bevelled(b, -half - 0.1, 0.001, -0.6, half + 0.1, 0.2, 0.6, 0.02);
    for (int k = 0; k < 2 * pairs; k++) { /* heads on two banks */
        const double side = k & 1 ? 1 : -1, x = -half + 0.45 + 0.64 * (k / 2);
        const double foot[3] = { x, 0.75, 0.25 * side }, head[3] = { x, 1.35, 0.62 * side },
                     top[3] = { x, 1.47, 0.69 * side };
        plant_stuff(b, KIT_STEEL);
        plant_beam(b, foot, head, 0.44, 0.42);
        memcpy(b->albedo, paint, sizeof paint);
        plant_beam(b, head, top, 0.5, 0.34);
        plant_aim(b, head, top);
        kit_place_tilted(b, top[0], top[1], top[2], b->turn, b->tilt);
        plant_bolt(b, 0.05, 0.06);
        plant_stuff(b, KIT_BRASS);
        const double port[4][3] = {
            { x, 1.15, 0.5 * side }, { x, 1.15, 0.2 * side }, { x, 1.5, 0.14 * side }, { x, 1.62, 0.12 * side }
        };
        plant_pipe(b, port, 4, 0.07, 0);
        plant_rod(b, KIT_AT(x + 0.15, 1.4, 0.84 * side), KIT_AT(x + 0.15, 0.5, 0.56 * side), 0.02, 8);
    }
    plant_stuff(b, KIT_STEEL);
    plant_rod(b, KIT_AT(0.1 - half, 1.72, 0), KIT_AT(half + 0.3, 1.72, 0), 0.17, 24);
    plant_rod(b, KIT_AT(half + 0.3, 1.72, 0), KIT_AT(half + 0.42, 1.72, 0), 0.3, 28);
    plant_rod(b, KIT_AT(half - 0.01, 0.55, 0), KIT_AT(half + 0.14, 0.55, 0), 0.46, 40);
    plant_stuff(b, KIT_DARK);
    for (int k = 0; k < 3; k++) { /* belt pulleys */
        const double y = 0.45 + 0.35 * k, z = k == 1 ? 0.28 : -0.12 * k, r = k ? 0.13 : 0.22;
        plant_rod(b, KIT_AT(-half - 0.12, y, z), KIT_AT(-half - 0.03, y, z), r, 24);
        plant_hoop(b, KIT_AT(-half - 0.09, y, z), 90, 90, r, 0.02, 28);
    }
    kit_place_at(b, 0, 0, 0, 0);
    for (int k = 0; k < 4; k++) {
        const double x = kit_between(b, -half, half), side = kit_odds(b, 0.5) ? 0.52 : -0.52;
        kit_cable(b, KIT_AT(x, 0.6, side), KIT_AT(x + kit_between(b, -0.5, 0.5), 1.2, 1.3 * side), 0.15, 0.018, 8);
        plant_rod(b, KIT_AT(x, 0.5, 0.9 * side), KIT_AT(x, 0.5, 1.35 * side), 0.09, 16);
    }
}

/* Shell boiler: round, its doors and burner in front, saddles below, pipes and a flue above. */
void plant_boiler(kit_build *b)
{
    const double r = kit_between(b, 0.8, 1.15), l = kit_between(b, 2.2, 3.6), y = r + 0.35, z = 0.5 * l;
    plant_stuff(b, KIT_PAINT);
    plant_rod(b, KIT_AT(0, y, -z), KIT_AT(0, y, z), r, 48);
    for (int k = 0; k < 5; k++) plant_hoop(b, KIT_AT(0, y, -z + l * (k + 0.1) / 4.2), 0, 90, r, 0.015, 48);
    plant_stuff(b, KIT_DARK);
    plant_rod(b, KIT_AT(0, y, z), KIT_AT(0, y, z + 0.12), 0.93 * r, 40);
    for (int k = 0; k < 16; k++) {
        const double a = 2 * KIT_PI * k / 16;
        kit_place_tilted(b, 0.86 * r * cos(a), y + 0.86 * r * sin(a), z + 0.119, 0, 90);
        plant_bolt(b, 0.035, 0.03);
    }
    plant_stuff(b, KIT_STEEL);
    plant_rod(b, KIT_AT(0, y - 0.25 * r, z + 0.1), KIT_AT(0, y - 0.25 * r, z + 0.5), 0.3 * r, 24);
    kit_place_at(b, 0, y - 0.25 * r, z + 0.62, 0);
    kit_bevelled(b, -0.25 * r, -0.3 * r, -0.15, 0.25 * r, 0.3 * r, 0.25, 0.03);
    plant_flange(b, KIT_AT(0.55 * r, y + 0.2 * r, z + 0.13), KIT_AT(0.55 * r, y + 0.2 * r, 99), 0.12);
    for (int k = 0; k < 3; k++) {
        plant_stuff(b, KIT_CONCRETE);
        kit_place_at(b, 0, 0, (k - 1) * 0.38 * l, 0);
        kit_box(b, -0.85 * r, 0.001, -0.09, 0.85 * r, y - 0.5 * r, 0.09);
    }
    plant_stuff(b, KIT_PIPE);
    for (int k = 0; k < 3; k++) {
        const double at = (k - 0.7) * 0.3 * l,
                     pipe[3][3] = { { 0, y + 0.95 * r, at }, { 0, y + r + 0.6, at }, { 0.1, y + r + 1.3, at } };
        plant_pipe(b, pipe, 3, 0.06 + 0.03 * k, 1);
        plant_valve(b, KIT_AT(0, y + r + 0.3, at), 90, 1, 0.06 + 0.03 * k);
    }
    plant_gauge(b, KIT_AT(-0.4 * r, y + 0.7 * r, z + 0.2), 0, 0.12);
    plant_gauge(b, KIT_AT(0.05 * r, y + 0.75 * r, z + 0.2), 0, 0.1);
}

/* A box of panels with a fan behind its open side, louvres on the other. */
void plant_air_handler(kit_build *b)
{
    const double w = kit_between(b, 0.8, 1.3), h = kit_between(b, 1.5, 2.1), d = 0.6;
    plant_stuff(b, KIT_PAINT);
    kit_box(b, -w, 0.1, -d, w, 0.16, d);
    kit_box(b, -w, h - 0.05, -d, w, h, d);
    kit_box(b, -w, 0.16, -d, w, h - 0.05, 0.03 - d);
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? w - 0.06 : -w, z = k & 2 ? d - 0.06 : 0.03 - d;
        kit_box(b, x, 0.16, z, x + 0.06, h - 0.05, z + (k & 2 ? 0.06 : 0.03));
        kit_box(b, x, 0.001, z, x + 0.06, 0.1, z + 0.06);
    }
    for (double y = 0.2; y < h - 0.12; y += 0.07) /* louvres at either end, without thickness */
        for (int side = -1; side < 2; side += 2) {
            const double x = side * (w - 0.03), slat[4][3] = { { x, y, 0.07 - d },
                                                               { x, y, d - 0.07 },
                                                               { x - 0.03 * side, y + 0.06, d - 0.07 },
                                                               { x - 0.03 * side, y + 0.06, 0.07 - d } };
            kit_quad(b, slat);
        }
    const kit_frame before = kit_enter(b, 0, 0.5 * h + 0.05, d - 0.25, 0, 1);
    plant_fan(b, 0.42 * fmin(2 * w, h), 5 + kit_choose(b, 4));
    kit_leave(b, before);
}

/* ---- >>tools --------------------------------------------------------------------------------------------------- */

void plant_lathe(kit_build *b)
{
    const double half = kit_between(b, 0.8, 1.3), chuck = 0.14;
    plant_stuff(b, KIT_PAINT);
    kit_bevelled(b, -half - 0.1, 0.001, -0.28, 0.55 - half, 0.75, 0.28, 0.02);
    kit_bevelled(b, half - 0.4, 0.001, -0.25, half, 0.72, 0.25, 0.02);
    kit_bevelled(b, -half - 0.1, 0.75, -0.26, 0.5 - half, 1.35, 0.26, 0.04);
    plant_stuff(b, KIT_STEEL);
    kit_box(b, 0.5 - half, 0.72, -0.2, half, 0.84, -0.1);
    kit_box(b, 0.5 - half, 0.72, 0.06, half, 0.84, 0.16);
    for (double x = 0.6 - half; x < half - 0.05; x += 0.25) kit_box(b, x, 0.7, -0.1, x + 0.05, 0.8, 0.06);
    plant_rod(b, KIT_AT(0.5 - half, 1.12, 0), KIT_AT(0.62 - half, 1.12, 0), chuck, 28);
    for (int k = 0; k < 3; k++) {
        const double a = 2 * KIT_PI * k / 3 + 0.4;
        plant_beam(b, KIT_AT(0.64 - half, 1.12 + 0.04 * cos(a), 0.04 * sin(a)),
                   KIT_AT(0.64 - half, 1.12 + 0.12 * cos(a), 0.12 * sin(a)), 0.05, 0.05);
    }
    plant_stuff(b, KIT_BRASS);
    plant_rod(b, KIT_AT(0.62 - half, 1.12, 0), KIT_AT(half - 0.35, 1.12, 0), kit_between(b, 0.02, 0.05), 20);
    plant_stuff(b, KIT_PAINT); /* tailstock, saddle */
    kit_place_at(b, half - 0.22, 0, 0, 0);
    kit_bevelled(b, -0.13, 0.841, -0.16, 0.13, 1.2, 0.14, 0.03);
    plant_stuff(b, KIT_STEEL);
    const double x = kit_between(b, 0.75 - half, half - 0.6);
    kit_place_at(b, x, 0, 0, 0);
    kit_bevelled(b, -0.16, 0.841, -0.22, 0.16, 0.92, 0.2, 0.01);
    kit_box(b, -0.08, 0.92, 0.02, 0.08, 1.02, 0.18);
    kit_bevelled(b, -0.14, 0.55, 0.17, 0.14, 0.85, 0.3, 0.02);
    plant_hoop(b, KIT_AT(x - 0.05, 0.7, 0.34), 0, 90, 0.09, 0.01, 20);
    plant_hoop(b, KIT_AT(half - 0.02, 1.12, 0), 90, 90, 0.1, 0.012, 20);
    plant_stuff(b, KIT_DARK);
    plant_rod(b, KIT_AT(0.5 - half, 0.64, 0.22), KIT_AT(half - 0.4, 0.64, 0.22), 0.015, 8);
    plant_rod(b, KIT_AT(0.5 - half, 0.58, 0.22), KIT_AT(half - 0.4, 0.58, 0.22), 0.012, 8);
    kit_place_at(b, 0, 0, 0, 0);
    kit_box(b, 0.55 - half, 0.3, -0.3, half - 0.4, 0.32, 0.3); /* chip tray */
    const double splash[4][3] = {
        { -half, 0.75, -0.3 }, { half, 0.75, -0.3 }, { half, 1.5, -0.34 }, { -half, 1.5, -0.34 }
    };
    if (kit_odds(b, 0.7)) kit_quad(b, splash);
    for (int k = 0; k < 5; k++)
        plant_rod(b, KIT_AT(-half + 0.05 + 0.09 * k, 1.2, 0.26), KIT_AT(-half + 0.05 + 0.09 * k, 1.2, 0.31), 0.025, 10);
}

void plant_pillar_drill(kit_build *b)
{
    const double table = kit_between(b, 0.7, 1.0);
    plant_stuff(b, KIT_PAINT);
    kit_bevelled(b, -0.25, 0.001, -0.35, 0.25, 0.08, 0.35, 0.02);
    kit_place_at(b, 0, 1.5, 0.05, 0);
    kit_bevelled(b, -0.16, 0, -0.4, 0.16, 0.4, 0.3, 0.05);
    kit_bevelled(b, -0.18, 0.38, -0.44, 0.18, 0.5, 0.34, 0.04);
    plant_stuff(b, KIT_STEEL);
    plant_rod(b, KIT_AT(0, 0.06, -0.22), KIT_AT(0, 1.6, -0.22), 0.05, 20);
    plant_rod(b, KIT_AT(0, 1.25, 0.18), KIT_AT(0, 1.55, 0.18), 0.05, 16);
    plant_rod(b, KIT_AT(0, 1.05, 0.18), KIT_AT(0, 1.25, 0.18), 0.012, 8);
    plant_beam(b, KIT_AT(0, table - 0.05, -0.28), KIT_AT(0, table - 0.05, 0), 0.16, 0.1);
    kit_place_at(b, 0, table, 0.14, 0);
    kit_bevelled(b, -0.2, 0, -0.2, 0.2, 0.035, 0.2, 0.008);
    kit_box(b, -0.1, 0.036, -0.07, 0.1, 0.1, 0.07);
    plant_stuff(b, KIT_DARK);
    for (int k = 0; k < 3; k++) {
        const double a = 2 * KIT_PI * k / 3 + 0.3, y = 1.62 + 0.24 * cos(a), z = 0.2 + 0.24 * sin(a);
        plant_rod(b, KIT_AT(0.2, 1.62, 0.2), KIT_AT(0.24, y, z), 0.01, 8);
        plant_rod(b, KIT_AT(0.24, y - 0.02, z), KIT_AT(0.24, y + 0.03, z), 0.02, 10);
    }
    plant_rod(b, KIT_AT(0.15, 1.62, 0.2), KIT_AT(0.22, 1.62, 0.2), 0.04, 14);
}

/* lying on a bench at the place's frame: something a person left */
static void bench_tool(kit_build *b, double x, double z, int way)
{
    const kit_frame before = kit_enter(b, x, 0, z, kit_between(b, 0, 360), 1);
    plant_stuff(b, KIT_STEEL);
    switch (way) {
    case 0: /* hammer */
        plant_rod(b, KIT_AT(-0.05, 0.02, 0), KIT_AT(0.06, 0.02, 0), 0.018, 10);
        plant_stuff(b, KIT_GOODS);
        plant_rod(b, KIT_AT(0, 0.016, 0), KIT_AT(0, 0.014, 0.28), 0.012, 8);
        break;
    case 1: /* spanner */
        kit_box(b, -0.012, 0.001, -0.1, 0.012, 0.009, 0.1);
        plant_hoop(b, KIT_AT(0, 0.008, 0.12), 0, 0, 0.02, 0.007, 14);
        break;
    case 2: /* vice */
        plant_stuff(b, KIT_PAINT);
        kit_bevelled(b, -0.08, 0.001, -0.14, 0.08, 0.07, 0.1, 0.01);
        kit_bevelled(b, -0.09, 0.06, -0.06, 0.09, 0.17, 0, 0.008);
        kit_bevelled(b, -0.09, 0.06, 0.05, 0.09, 0.17, 0.11, 0.008);
        plant_rod(b, KIT_AT(0, 0.07, 0.1), KIT_AT(0, 0.07, 0.24), 0.016, 10);
        plant_rod(b, KIT_AT(-0.1, 0.07, 0.22), KIT_AT(0.1, 0.07, 0.22), 0.008, 8);
        break;
    case 3: /* screwdriver */
        plant_rod(b, KIT_AT(0, 0.015, 0), KIT_AT(0, 0.006, 0.14), 0.005, 6);
        plant_stuff(b, KIT_PLASTIC);
        plant_rod(b, KIT_AT(0, 0.016, -0.1), KIT_AT(0, 0.016, 0), 0.015, 10);
        break;
    case 4: plant_gear(b, kit_between(b, 0.05, 0.11), 20, 0.03, 0); break;
    case 5: { /* toolbox, open, its sides without thickness */
        plant_stuff(b, KIT_PAINT);
        const double side[4][4][3] = {
            { { -0.22, 0.002, 0.1 }, { 0.22, 0.002, 0.1 }, { 0.22, 0.16, 0.1 }, { -0.22, 0.16, 0.1 } },
            { { -0.22, 0.002, -0.1 }, { 0.22, 0.002, -0.1 }, { 0.22, 0.16, -0.1 }, { -0.22, 0.16, -0.1 } },
            { { -0.22, 0.002, -0.1 }, { -0.22, 0.002, 0.1 }, { -0.22, 0.16, 0.1 }, { -0.22, 0.16, -0.1 } },
            { { 0.22, 0.002, -0.1 }, { 0.22, 0.002, 0.1 }, { 0.22, 0.16, 0.1 }, { 0.22, 0.16, -0.1 } }
        };
        for (int k = 0; k < 4; k++) kit_quad(b, side[k]);
        plant_rod(b, KIT_AT(-0.22, 0.24, 0), KIT_AT(0.22, 0.24, 0), 0.012, 8);
        for (int k = -1; k < 2; k += 2)
            plant_beam(b, KIT_AT(0.215 * k, 0.1, 0), KIT_AT(0.215 * k, 0.25, 0), 0.008, 0.04);
        break;
    }
    case 6: /* can */
        plant_stuff(b, KIT_PLASTIC);
        kit_cylinder(b, 0.05, 0.15, 18);
        break;
    default: /* paper, cloth */
        plant_stuff(b, KIT_GOODS);
        kit_place_at(b, 0, 0.003, 0, 0);
        kit_leaf(b, 0.21, 0.29, kit_between(b, -0.1, 0.02), 5, 0);
    }
    kit_leave(b, before);
}

void plant_bench(kit_build *b)
{
    const double half = kit_between(b, 0.8, 1.2), top = 0.88;
    plant_stuff(b, KIT_GOODS);
    kit_box(b, -half, top - 0.05, -0.35, half, top, 0.35);
    if (kit_odds(b, 0.5)) kit_box(b, 0.06 - half, 0.2, -0.3, half - 0.06, 0.23, 0.28);
    plant_stuff(b, KIT_PAINT);
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? half - 0.1 : 0.04 - half, z = k & 2 ? 0.25 : -0.31;
        kit_box(b, x, 0.001, z, x + 0.06, top - 0.05, z + 0.06);
    }
    if (kit_odds(b, 0.6)) { /* drawers */
        kit_box(b, half - 0.62, 0.25, -0.3, half - 0.12, top - 0.051, 0.3);
        for (int k = 0; k < 3; k++) {
            kit_box(b, half - 0.6, 0.27 + 0.185 * k, 0.3, half - 0.14, 0.44 + 0.185 * k, 0.318);
            plant_rod(b, KIT_AT(half - 0.5, 0.38 + 0.185 * k, 0.335), KIT_AT(half - 0.24, 0.38 + 0.185 * k, 0.335),
                      0.008, 8);
        }
    }
    const kit_frame before = kit_enter(b, 0, top + 0.001, 0, 0, 1);
    for (int k = 0; k < 9; k++)
        bench_tool(b, -half + (k + 0.5) * 2 * half / 9, kit_between(b, -0.2, 0.18), kit_choose(b, 8));
    kit_leave(b, before);
}

void plant_tool_board(kit_build *b)
{
    plant_stuff(b, KIT_PAINT);
    kit_place_at(b, 0, -0.5, 0.03, 0);
    plant_perforated(b, 1.8, 1, 27, 15);
    plant_stuff(b, KIT_STEEL);
    for (int k = 0; k < 12; k++) {
        const double x = -0.8 + 0.145 * k, y = kit_between(b, 0.1, 0.4), long_way = kit_between(b, 0.15, 0.6);
        const int way = kit_choose(b, 4);
        plant_rod(b, KIT_AT(x, y, 0.03), KIT_AT(x, y + 0.01, 0.08), 0.004, 6);
        plant_stuff(b, kit_odds(b, 0.5) ? KIT_STEEL : KIT_PLASTIC);
        if (way == 0) plant_hoop(b, KIT_AT(x, y - 0.06, 0.055), 0, 90, 0.055, 0.008, 18);
        else plant_beam(b, KIT_AT(x, y - long_way, 0.055), KIT_AT(x, y, 0.055), 0.012 + 0.01 * way, 0.008);
        if (way == 2) plant_rod(b, KIT_AT(x - 0.05, y - 0.02, 0.07), KIT_AT(x + 0.05, y - 0.02, 0.07), 0.016, 8);
        if (way == 3) plant_rod(b, KIT_AT(x, y - long_way - 0.1, 0.06), KIT_AT(x, y - long_way, 0.06), 0.018, 8);
    }
}
