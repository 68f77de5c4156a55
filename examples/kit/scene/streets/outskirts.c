/* outskirts.c - layouts of scenes by seed: suburbs, cities, building sites, forecourts. Declared in streets.h. */
#include "kit/scene/streets/streets.h"
#include <math.h>
#include <string.h>

static void tube(kit_build *b, double x0, double y0, double z0, double x1, double y1, double z1, double radius)
{
    const double at[2][3] = { { x0, y0, z0 }, { x1, y1, z1 } };
    kit_tube(b, at, 2, radius, 7);
}

/* ---- >>suburb -------------------------------------------------------------------------------------------------- */

/* tufts of grass over a rectangle */
static void tufts(kit_build *b, const double r[4], double y, int count)
{
    for (int k = 0; k < count; k++) {
        kit_colour(b, kit_between(b, 0.12, 0.24), kit_between(b, 0.24, 0.32), 0.07);
        kit_place_tilted(b, kit_between(b, r[0], r[2]), y - 0.01, kit_between(b, r[1], r[3]), kit_between(b, 0, 360),
                         kit_between(b, -85, -40));
        kit_leaf(b, 0.03, kit_between(b, 0.06, 0.16), kit_between(b, 0, 1), 2, 1);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* A porch along the front: posts, a roof, steps. */
static void porch(kit_build *b, const kit_house *h)
{
    const double deep = kit_between(b, 1.4, 2.2), w = h->width;
    const double rail[2][2] = { { 0.1, deep - 0.08 }, { 0.42 * w, deep - 0.08 } };
    kit_town_paint(b, h->trim);
    kit_box(b, 0, -0.1, 0.01, w, 0.02, deep);
    for (int k = 0; k < 4; k++)
        kit_box(b, 0.06 + (w - 0.24) * k / 3, 0.02 + KIT_GAP, deep - 0.14, 0.18 + (w - 0.24) * k / 3, 2.5, deep - 0.02);
    kit_box(b, -0.1, 2.5 + KIT_GAP, -0.01, w + 0.1, 2.62, deep + 0.15);
    kit_town_railing(b, rail, 2, 0.02, 0.8, KIT_BARS);
}

static void home(kit_plot *p, double x, double z, int side, double lot)
{
    kit_build *b = &p->b;
    kit_house h;
    const double turn = side < 0 ? 90 : -90, back = kit_between(b, 4.5, 8), front = (lot - 1) * 0.5;
    const int fence = kit_odds(b, 0.6) ? kit_odds(b, 0.6) ? KIT_PICKETS : KIT_MESH : -1;
    const double line[4][2] = {
        { -front, back - 7 }, { -front, back + 0.4 }, { -front + 0.55 * lot, back + 0.4 }, { front - 1, back + 0.4 }
    };
    kit_town_draw_house(b, &h, kit_odds(b, 0.85) ? KIT_COTTAGE : KIT_MODERN);
    if (h.floors > 2) h.floors = 2;
    h.shops = 0;
    h.sides = KIT_ROUND;
    if (fabs(z) > 12) h.cladding = 0;
    h.width = kit_between(b, 7, lot - 3.5);
    h.depth = kit_between(b, 6.5, 9);
    const kit_frame was = kit_enter(b, x + side * back, 0.1, z, turn, 1);
    const kit_frame at = kit_enter(b, -0.5 * h.width, 0, 0, 0, 1);
    kit_town_raise_house(p, &h);
    if (kit_odds(b, 0.4)) porch(b, &h);
    kit_leave(b, at);
    if (fence >= 0) {
        kit_begin_object(b, "fence", -1);
        kit_town_paint(b, h.trim);
        kit_town_railing(b, line, 3, -0.08, fence == KIT_PICKETS ? 1.0 : 1.3, fence);
    }
    kit_leave(b, was);
    kit_town_sight(p, x + side * back, 2, z, 4);
    kit_town_sight(p, x + side * back, 1.5, z + kit_between(b, -3, 3), 1.8);
    kit_town_sight(p, x + side * back, 5.5, z, 4);
}

static void garden(kit_plot *p, double x, double z, int side, double lot)
{
    static const int odd[] = { KIT_TREE, KIT_TREE,  KIT_SHRUB,   KIT_SHRUB, KIT_SHRUB,
                               KIT_POT,  KIT_BENCH, KIT_BICYCLE, KIT_CAFE,  KIT_BIN };
    kit_build *b = &p->b;
    for (int k = 2 + kit_choose(b, 4); k > 0; k--)
        kit_town_put(p, odd[kit_choose(b, 10)], x + side * kit_between(b, 0.8, 3.6), 0.02,
                     z + kit_between(b, -0.42, 0.3) * lot, kit_between(b, 0, 360));
    if (kit_odds(b, 0.6)) kit_town_put(p, KIT_CAR, x + side * 2.8, 0.03, z + 0.42 * lot, 90 + kit_between(b, -4, 4));
}

static void wires(kit_plot *p, double x, double reach)
{
    kit_build *b = &p->b;
    const double step = 2 * reach / 3;
    for (int k = 0; k < 4; k++) kit_town_put(p, KIT_POLE, x, 0, -reach + step * k, 0);
    kit_begin_object(b, "wires", -1);
    kit_colour(b, 0.07, 0.07, 0.07);
    for (int k = 0; k < 3; k++)
        for (int n = 0; n < 4; n++) {
            const double from[3] = { x - 0.9 + 0.6 * n, 6.9, -reach + step * k },
                         to[3] = { from[0], 6.9, from[2] + step };
            kit_cable(b, from, to, kit_between(b, 0.3, 0.6), 0.012, 4);
        }
}

void kit_town_lay_suburb(kit_plot *p, kit_town *t)
{
    kit_build *b = &p->b;
    const double road = kit_between(b, 2.6, 4), walk = road + 1.8, reach = 28, lot = kit_between(b, 12, 16);
    (void)t;
    kit_town_ground(p, 260);
    kit_colour(b, 0.24, 0.32, 0.12);
    for (int side = -1; side <= 1; side += 2) {
        const double r[4] = { side < 0 ? -walk : road, -60, side < 0 ? -road : walk, 60 },
                     lawn[4] = { side < 0 ? -walk - 6 : walk, -14, side < 0 ? -walk : walk + 6, 14 };
        kit_colour(b, 0.24, 0.32, 0.12);
        kit_box(b, side < 0 ? -260 : walk, -0.1, -260, side < 0 ? -walk : 260, 0.03, 260);
        kit_town_pavement(b, r, 0.12, 0);
        tufts(b, lawn, 0.03, 3500);
        kit_colour(b, 0.4, 0.39, 0.37); /* drives */
        for (double z = -reach; z < reach; z += lot)
            kit_box(b, side < 0 ? -walk - 9 : walk, -0.05, z + 0.42 * lot - 1.3, side < 0 ? -walk : walk + 9, 0.05,
                    z + 0.42 * lot + 1.3);
    }
    for (int side = -1; side <= 1; side += 2)
        for (double z = -reach; z < reach; z += lot) {
            home(p, side * walk, z, side, lot);
            garden(p, side * walk, z, side, lot);
        }
    if (kit_odds(b, 0.75)) wires(p, -road - 0.9, reach + 6);
    kit_town_skyline(p, 110);
    for (int k = 0; k < 9; k++)
        kit_town_put(p, KIT_TREE, (k & 1 ? 1 : -1) * kit_between(b, 20, 34), 0.03, kit_between(b, -40, 40), 0);
    for (int k = kit_choose(b, 4); k > 0; k--)
        kit_town_put(p, KIT_CAR, (k & 1 ? 1 : -1) * (road - 1), 0, kit_between(b, -20, 20), 180 * (k & 1));
    for (int k = 2 + kit_choose(b, 5); k > 0; k--)
        kit_town_put(p, kit_odds(b, 0.5) ? KIT_BIN : KIT_PERSON, (k & 1 ? 1 : -1) * (road + 0.9), 0.121,
                     kit_between(b, -16, 16), kit_between(b, 0, 360));
    kit_town_range(p, -walk - 3.5, -reach, walk + 3.5, reach);
}

/* ---- >>city ---------------------------------------------------------------------------------------------------- */

/* A block that is built on: a tower, steps of them, or a ring of houses. */
static void block(kit_plot *p, double x, double z, double size, double middle)
{
    kit_build *b = &p->b;
    const int steps = kit_odds(b, 0.3) ? 3 : 1;
    const double turn = 90 * kit_choose(b, 4);
    double base = 0, wide = size * kit_between(b, 0.6, 0.95), deep = size * kit_between(b, 0.6, 0.95), top = 0;
    kit_house h;
    kit_town_draw_house(b, &h, kit_odds(b, middle) ? KIT_TOWER : kit_choose(b, 4));
    kit_begin_object(b, "block", -1);
    h.fine = 0;
    h.sides = KIT_ROUND;
    h.arched = 0;
    for (int k = 0; k < steps; k++) {
        h.width = wide;
        h.depth = deep;
        if (k) h.floors = (int)fmax(3, h.floors * 0.6);
        if (h.style == KIT_TOWER && kit_odds(b, 0.85)) h.bay = 2 * fmax(wide, deep);
        h.bay = fmax(h.bay, size / (middle > 0.6 ? 5 : 3.2));
        h.window[0] = (h.style == KIT_TOWER ? 0.9 : 0.55) * fmin(h.bay, wide);
        const kit_frame was = kit_enter(b, x, 0, z, turn, 1), at = kit_enter(b, -0.5 * wide, base, 0.5 * deep, 0, 1);
        kit_town_raise_house(p, &h);
        kit_leave(b, at);
        kit_leave(b, was);
        base += kit_town_eaves(&h) - 0.02;
        top = base;
        wide *= kit_between(b, 0.55, 0.8);
        deep *= kit_between(b, 0.55, 0.8);
    }
    kit_town_sight(p, x, top + 2.5, z, 5);
    kit_town_sight(p, x + 0.5 * size + 4, kit_between(b, 0.2, 0.9) * top, z + 0.5 * size + 4, 0.45 * size);
}

void kit_town_lay_city(kit_plot *p, kit_town *t)
{
    kit_build *b = &p->b;
    const double size = kit_between(b, 18, 30), street = kit_between(b, 9, 16), pitch = size + street;
    const int count = 2 + kit_odds(b, 0.5), park = kit_choose(b, 5);
    (void)t;
    kit_town_ground(p, 900);
    for (int i = -count; i <= count; i++)
        for (int k = -count; k <= count; k++) {
            const double r[4] = { i * pitch - 0.5 * size - 2, k * pitch - 0.5 * size - 2, i * pitch + 0.5 * size + 2,
                                  k * pitch + 0.5 * size + 2 };
            kit_town_pavement(b, r, 0.14, 0);
        }
    for (int i = -count; i <= count; i++)
        for (int k = -count; k <= count; k++)
            if (i || k != park - 2) block(p, i * pitch, k * pitch, size, 0.85 - 0.2 * hypot(i, k));
    for (int k = 0; k < 9; k++)
        kit_town_put(p, KIT_TREE, kit_between(b, -0.45, 0.45) * size, 0.14,
                     (park - 2) * pitch + kit_between(b, -0.45, 0.45) * size, 0);
    for (int k = 0; k < 12; k++) {
        const double along = kit_between(b, -1.4, 1.4) * pitch,
                     lane = (kit_odds(b, 0.5) ? 0.5 : -0.5) * pitch + (k & 1 ? 1.8 : -1.8);
        if (k % 3) kit_town_put(p, KIT_CAR, lane, 0, along, 180 * (k & 1));
        else kit_town_put(p, KIT_CAR, along, 0, lane, 90 + 180 * (k & 1));
    }
    kit_town_skyline(p, (count + 1.2) * pitch);
    kit_town_skyline(p, (count + 2.5) * pitch);
    for (int k = 0; k < 6; k++)
        kit_town_put(p, KIT_TALL_LAMP, 0.5 * size + 1.5, 0.14, kit_between(b, -1, 1) * pitch, 90);
    p->sights -= 12; /* of what is small, only some */
    kit_town_sight(p, 0, 5, 0, 0.5 * pitch);
    kit_town_sight(p, 0.5 * pitch, 15, 0.5 * pitch, 0.7 * pitch);
    kit_town_range(p, -(count + 0.6) * pitch, -(count + 0.6) * pitch, (count + 0.6) * pitch, (count + 0.6) * pitch);
}

/* ---- >>building site -------------------------------------------------------------------------------------------- */

/* Floors and columns without walls, rods sticking out of the top. */
static void skeleton(kit_build *b, int nx, int nz, int floors, double bay)
{
    const double storey = 3.1;
    for (int f = 0; f <= floors; f++) {
        const int built_x = f == floors && nx > 2 ? nx - 1 : nx;
        kit_colour(b, 0.5, 0.5, 0.48);
        if (f) kit_box(b, -0.4, storey * f - 0.25, -0.4, built_x * bay + 0.4, storey * f, nz * bay + 0.4);
        for (int i = 0; i <= nx; i++)
            for (int k = 0; k <= nz; k++) {
                const double x = bay * i, z = bay * k, y = storey * f + (f ? KIT_GAP : -0.1),
                             top = storey * (f + 1) - 0.251;
                if (f == floors && i > built_x) continue;
                kit_colour(b, 0.52, 0.51, 0.49);
                if (f < floors) kit_box(b, x - 0.2, y, z - 0.2, x + 0.2, top, z + 0.2);
                kit_colour(b, 0.3, 0.17, 0.12);
                for (int n = 0; n < 4 && f == floors; n++) {
                    const double rx = x + (n & 1 ? 0.12 : -0.12), rz = z + (n & 2 ? 0.12 : -0.12);
                    tube(b, rx, y - 0.1, rz, rx + kit_between(b, -0.05, 0.05), y + kit_between(b, 0.7, 1.3), rz, 0.012);
                }
            }
    }
    kit_colour(b, 0.45, 0.22, 0.16); /* some walls of brick begun */
    for (int f = 0; f < floors; f++)
        for (int i = 0; i < nx; i++) {
            const double high = kit_between(b, 0, 3.6);
            for (double y = 0; y + 0.2 < fmin(high, 2.7); y += 0.2)
                kit_box(b, bay * i + 0.2, storey * f + y + 0.005, nz * bay - 0.1, bay * (i + 1) - 0.2,
                        storey * f + y + 0.2, nz * bay + 0.1 - (((int)(y * 5)) & 1) * 0.01);
        }
}

/* A lattice of four chords and what braces them, from the origin up. */
static void lattice(kit_build *b, double length, double half)
{
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? half : -half, z = k & 2 ? half : -half;
        tube(b, x, 0, z, x, length, z, 0.06);
    }
    for (double y = 0, step = 2 * half; y + step <= length; y += step)
        for (int side = -1; side <= 1; side += 2) {
            tube(b, side * half, y, -half, side * half, y + step, half, 0.03);
            tube(b, -half, y, side * half, half, y + step, side * half, 0.03);
        }
}

static void crane(kit_build *b, double high)
{
    kit_colour(b, 0.72, 0.52, 0.08);
    lattice(b, high, 0.7);
    kit_box(b, -1.1, high, -1.1, 1.1, high + 0.4, 1.1);
    kit_bevelled(b, 0.9, high + 0.4, -0.8, 2.2, high + 2.4, 0.8, 0.1);
    kit_place_tilted(b, 0, high + 1.2, 0, 0, 90); /* the jib along z */
    lattice(b, 28, 0.5);
    kit_place_tilted(b, 0, high + 1.2, 0, 0, -90);
    lattice(b, 9, 0.5);
    kit_place_at(b, 0, 0, 0, 0);
    tube(b, 0, high + 0.4, 0, 0, high + 5, 0, 0.15);
    tube(b, 0, high + 5, 0, 0, high + 1.7, 20, 0.04);
    tube(b, 0, high + 5, 0, 0, high + 1.7, -8, 0.04);
    tube(b, 0, high + 0.7, 15, 0, 0.5 * high, 15, 0.025);
    kit_colour(b, 0.5, 0.5, 0.48);
    kit_box(b, -0.8, high - 0.8, -8.6, 0.8, high + 0.8, -7);
    kit_bevelled(b, -1, 0.5 * high - 1.2, 14.2, 1, 0.5 * high, 15.8, 0.05);
}

/* ridged walls, doors, feet */
static void container(kit_build *b)
{
    kit_colour(b, kit_between(b, 0.1, 0.6), kit_between(b, 0.2, 0.4), kit_between(b, 0.1, 0.4));
    kit_box(b, -1.2, 0.12, -3, 1.2, 2.6, 3);
    for (double z = -2.85; z < 2.8; z += 0.3)
        for (int side = -1; side <= 1; side += 2)
            kit_box(b, side > 0 ? 1.19 : -1.24, 0.25, z, side > 0 ? 1.24 : -1.19, 2.45, z + 0.15);
    for (int k = 0; k < 4; k++) kit_box(b, -0.9 + 0.55 * k, 0.2, 2.99, -0.86 + 0.55 * k, 2.5, 3.05);
    for (int k = 0; k < 4; k++)
        kit_box(b, k & 1 ? 1.05 : -1.22, 0, k & 2 ? 2.85 : -3.02, k & 1 ? 1.22 : -1.05, 2.64, k & 2 ? 3.02 : -2.85);
}

void kit_town_lay_site(kit_plot *p, kit_town *t)
{
    static const int odd[] = { KIT_PALLET, KIT_PALLET, KIT_PALLET, KIT_HEAP, KIT_DUMPSTER, KIT_CONE,
                               KIT_CONE,   KIT_PERSON, KIT_CAR,    KIT_BIN,  KIT_CRATES };
    kit_build *b = &p->b;
    const double bay = kit_between(b, 4, 5.5), half = kit_between(b, 17, 23);
    const int nx = 2 + kit_choose(b, 3), nz = 1 + kit_choose(b, 2), floors = 2 + kit_choose(b, 4);
    const double ring[5][2] = { { -half, -half }, { half, -half }, { half, half }, { -half, half }, { -half, -half } };
    kit_begin_object(b, "ground", 0);
    kit_colour(b, 0.38, 0.31, 0.23);
    kit_level(b, -260, -260, 260, 260, 0);
    double at[3] = { -0.5 * nx * bay + kit_between(b, -4, 4), 0, -0.5 * nz * bay - kit_between(b, 2, 6) };
    kit_frame was = kit_town_stand(p, "skeleton", at, 0, 5);
    skeleton(b, nx, nz, floors, bay);
    kit_begin_object(b, "scaffold", -1);
    const kit_frame in = kit_enter(b, 0, 0, nz * bay + 0.45, 0, 1);
    if (kit_odds(b, 0.8)) kit_town_scaffold(b, nx * bay, 3.1 * floors, kit_odds(b, 0.5));
    kit_leave(b, in);
    kit_leave(b, was);
    for (int f = 0; f < floors; f++)
        kit_town_sight(p, at[0] + kit_between(b, 0, nx) * bay, 3.1 * f + 1.3, at[2] + nz * bay, kit_between(b, 1, 3));
    if (kit_odds(b, 0.6)) {
        const double stand[3] = { at[0] - 4, 0, at[2] - 2 };
        was = kit_town_stand(p, "crane", stand, kit_between(b, 0, 360), 3);
        crane(b, 3.1 * floors + kit_between(b, 6, 12));
        kit_leave(b, was);
    }
    kit_begin_object(b, "fence", -1);
    kit_colour(b, 0.5, 0.5, 0.5);
    kit_town_railing(b, ring, 5, 0, 2, kit_odds(b, 0.5) ? KIT_MESH : KIT_BOARDS);
    for (int k = 1 + kit_choose(b, 3); k > 0; k--) {
        const double spot[3] = { half - 3 - 3.5 * k, 0, half - 5 };
        was = kit_town_stand(p, "container", spot, kit_between(b, -6, 6), 2);
        container(b);
        kit_leave(b, was);
    }
    for (int k = 14 + kit_choose(b, 20); k > 0; k--)
        kit_town_put(p, odd[kit_choose(b, 11)], kit_between(b, -0.85, 0.85) * half, 0.005,
                     at[2] + nz * bay + kit_between(b, 3, 12), kit_between(b, 0, 360));
    t->shops = 0;
    kit_town_row(p, t, -half - 6, -half - 8, half + 6, -half - 8);
    kit_town_row(p, t, half + 9, -half, half + 9, half);
    kit_town_skyline(p, 70);
    kit_add_lamp(p, 0, 5, at[2] + nz * bay + 4);
    kit_town_sight(p, 0, 2, 0, 9);
    kit_town_range(p, -half + 1, at[2] + 0.3 * bay, half - 1, half - 1);
}

/* ---- >>forecourt ------------------------------------------------------------------------------------------------ */

static void pump(kit_build *b)
{
    static const double hose[7][3] = { { 0.3, 1.4, 0.1 },   { 0.45, 1.2, 0.15 }, { 0.5, 0.6, 0.2 },
                                       { 0.42, 0.3, 0.22 }, { 0.32, 0.35, 0.2 }, { 0.3, 0.8, 0.15 },
                                       { 0.3, 1.05, 0.12 } };
    kit_colour(b, 0.7, 0.68, 0.64);
    kit_bevelled(b, -0.35, 0.15, -0.25, 0.35, 1.9, 0.25, 0.05);
    kit_colour(b, 0.5, 0.08, 0.06);
    kit_box(b, -0.36, 1.6, -0.26, 0.36, 1.85, 0.26);
    kit_colour(b, 0.06, 0.07, 0.08);
    kit_box(b, -0.22, 1.15, 0.24, 0.22, 1.45, 0.265);
    for (int k = -1; k <= 1; k += 2) {
        kit_place_at(b, 0, 0, 0, k > 0 ? 0 : 180);
        kit_tube(b, hose, 7, 0.02, 7);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* A roof on columns, with beams under it and lamps in it. */
static void canopy(kit_build *b, double wide, double deep, double high)
{
    kit_colour(b, 0.72, 0.71, 0.69);
    kit_box(b, -wide, high, -deep, wide, high + 0.7, deep);
    kit_colour(b, 0.6, 0.12, 0.08);
    kit_box(b, -wide - 0.05, high + 0.2, -deep - 0.05, wide + 0.05, high + 0.5, deep + 0.05);
    kit_colour(b, 0.5, 0.5, 0.5);
    for (double x = -wide + 0.6; x < wide - 0.5; x += 1.2)
        kit_box(b, x, high - 0.16, -deep + 0.1, x + 0.1, high - KIT_GAP, deep - 0.1);
    for (int k = 0; k < 4; k++) {
        kit_place_at(b, k & 1 ? 0.6 * wide : -0.6 * wide, 0.14, k & 2 ? 0.55 * deep : -0.55 * deep, 0);
        kit_cylinder(b, 0.2, high - 0.142, 20);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_town_lay_forecourt(kit_plot *p, kit_town *t)
{
    static const int odd[] = { KIT_BIN,     KIT_CONE,  KIT_PERSON, KIT_PALLET, KIT_CRATES,    KIT_SIGN,
                               KIT_BOLLARD, KIT_BENCH, KIT_SHRUB,  KIT_TREE,   KIT_BILLBOARD, KIT_DUMPSTER };
    kit_build *b = &p->b;
    const double wide = kit_between(b, 6, 9), deep = kit_between(b, 4, 6), z0 = kit_between(b, -4, 4),
                 high = kit_between(b, 4.2, 5.5);
    const double at[3] = { 0, 0, z0 }, cars = kit_between(b, 0.3, 0.8);
    kit_town_ground(p, 260);
    kit_colour(b, 0.7, 0.7, 0.66);
    for (int k = 0; k < 14; k++) kit_level(b, -20 + 2.7 * k, -20, -19.9 + 2.7 * k, -15, 0.006);
    kit_frame was = kit_town_stand(p, "canopy", at, 0, 5);
    for (int k = -1; k <= 1; k += 2) {
        kit_colour(b, 0.5, 0.49, 0.47);
        kit_bevelled(b, -0.75 * wide, -0.1, k * 0.55 * deep - 0.6, 0.75 * wide, 0.14, k * 0.55 * deep + 0.6, 0.04);
    }
    canopy(b, wide, deep, high);
    kit_leave(b, was);
    for (int k = 0; k < 4; k++) {
        const double spot[3] = { k & 1 ? 2.2 : -2.2, 0, z0 + (k & 2 ? 0.55 : -0.55) * deep };
        was = kit_town_stand(p, "pump", spot, 0, 1);
        pump(b);
        kit_leave(b, was);
        kit_add_lamp(p, spot[0], high - 0.4, spot[2]);
    }
    for (int k = 0; k < 13; k++)
        if (kit_odds(b, cars))
            kit_town_put(p, KIT_CAR, -18.7 + 2.7 * k, 0, -17.6, (k % 3 ? 180 : 0) + kit_between(b, -4, 4));
    for (int k = 0; k < 3; k++)
        if (kit_odds(b, 0.7)) kit_town_put(p, KIT_CAR, kit_between(b, -4, 4), 0, z0 + (k - 1) * 1.1 * deep + 0.1, 90);
    for (int k = 10 + kit_choose(b, 12); k > 0; k--)
        kit_town_put(p, odd[kit_choose(b, 12)], (k & 1 ? 1 : -1) * kit_between(b, wide + 2, 20), 0.005,
                     kit_between(b, -13, 18), kit_between(b, 0, 360));
    for (int k = 0; k < 4; k++) kit_town_put(p, KIT_TALL_LAMP, -18 + 12 * k, 0, -13.5, 180);
    t->style[0] = kit_odds(b, 0.7) ? KIT_WAREHOUSE : t->style[0];
    t->floors = 3;
    t->pave = 0.01;
    kit_town_row(p, t, -24, -23, 24, -23);
    if (kit_odds(b, 0.6)) kit_town_row(p, t, -25, 20, -25, -20);
    if (kit_odds(b, 0.4)) kit_town_row(p, t, 25, -20, 25, 20);
    kit_town_skyline(p, 85);
    kit_town_sight(p, 0, 2, z0, 9);
    kit_town_range(p, -22, -20, 22, 22);
}
