/* stations.c - where people work and wash: desks, kitchens, workbenches, bathrooms. Declared in rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>

/* ---- >>desks ----------------------------------------------------------------------------------------------------- */

static void monitor(kit_room *r, double x, double y, double z, double turn, double wide)
{
    kit_build *b = r->b;
    const kit_frame before = kit_enter(b, x, y, z, turn, 1);
    const double h = 0.58 * wide;
    kit_colour(b, 0.06, 0.06, 0.065);
    kit_box(b, -0.12, 0, -0.09, 0.12, 0.012, 0.09);
    room_rod(b, 0, 0.012, -0.04, 0, 0.3, -0.04, 0.018);
    kit_bevelled(b, -0.5 * wide, 0.12, -0.02, 0.5 * wide, 0.12 + h, 0.015, 0.004);
    kit_colour(b, 0.16, 0.2, 0.26);
    kit_box(b, -0.5 * wide + 0.01, 0.135, 0.015, 0.5 * wide - 0.01, 0.11 + h, 0.016);
    kit_leave(b, before);
}

static void keyboard(kit_build *b, double x, double y, double z)
{
    kit_place_at(b, x, y, z, kit_between(b, -6, 6));
    kit_colour(b, 0.15, 0.15, 0.16);
    kit_bevelled(b, -0.22, 0.001, -0.07, 0.22, 0.018, 0.07, 0.004);
    kit_colour(b, 0.6, 0.6, 0.6);
    for (int i = 0; i < 75; i++) {
        const double e = -0.212 + 0.0284 * (i % 15), f = -0.063 + 0.0255 * (i / 15);
        kit_box(b, e, 0.018, f, e + 0.023, 0.027, f + 0.021);
    }
    const double mouse[3] = { 0.03, 0.018, 0.052 };
    kit_place_at(b, x + 0.33, y + 0.017, z, kit_between(b, -20, 20));
    kit_cushion(b, mouse, 0.8, 12);
    kit_place_at(b, 0, 0, 0, 0);
}

/* A desk, screens, keyboard, cables, a chair; s: with the chair. */
void kit_desk(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double top[3] = { s[0], 0.74, fmin(0.8, s[2] - 0.5) }, x = 0.5 * s[0];
    const int screens = kit_odds(b, 0.75) ? 1 + (s[0] > 1.3 && kit_odds(b, 0.5)) : 0;
    kit_begin_object(b, "desk", -1);
    kit_frame before = kit_enter(b, 0, 0, 0.5 * top[2], 0, 1);
    room_table(r, top, r->table == 1 ? 0 : r->table);
    kit_leave(b, before);
    if (kit_odds(b, 0.6)) {
        const double chest[3] = { 0.42, 0.6, top[2] - 0.14 };
        before = kit_enter(b, x - 0.32, 0, 0.03, 0, 1);
        const int theme = r->theme;
        r->theme = 0;
        kit_drawers(r, chest);
        r->theme = theme;
        kit_leave(b, before);
    }
    kit_begin_object(b, "desk things", -1);
    for (int i = 0; i < screens; i++)
        monitor(r, screens > 1 ? 0.3 * (2 * i - 1) : -0.05, 0.741, 0.22,
                screens > 1 ? 14 - 28 * i : kit_between(b, -8, 8), kit_between(b, 0.5, 0.6));
    if (screens) {
        keyboard(b, kit_between(b, -0.1, 0.05), 0.74, top[2] - 0.2);
        for (int i = 0; i < 4; i++) {
            const double from[3] = { 0.1 * i - 0.15, 0.755, 0.1 }, over[3] = { from[0] + 0.03, 0.74, 0.006 },
                         to[3] = { 0.25 * i - 0.4, 0.03, 0.03 };
            kit_colour(b, 0.05 + 0.2 * (i & 1), 0.06, 0.07);
            kit_cable(b, from, over, -0.012, 0.0035, 6);
            kit_cable(b, over, to, kit_between(b, -0.02, 0.15), 0.0035, 6);
        }
        room_clutter(r, -x, 0.02, -x + 0.36, top[2], 0.74, 0.5, 2 + 2 * r->clutter);
        room_clutter(r, x - 0.3, 0.02, x, top[2], 0.74, 0.5, 1 + 2 * r->clutter);
    } else room_clutter(r, -x, 0.02, x, top[2], 0.74, 0.5, 1.2 + 2 * r->clutter);
    room_sight_here(r, 0, 0.8, 0.3, 0.5);
    kit_begin_object(b, "chair", -1);
    before = kit_enter(b, kit_between(b, -0.15, 0.15), 0, top[2] + kit_between(b, 0.1, 0.25),
                       180 + kit_between(b, -40, 40), 1);
    room_chair(r, kit_odds(b, 0.6) ? 5 : r->chair);
    kit_leave(b, before);
}

void kit_easel(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double z = s[2];
    room_paint(b, r->wood, 0.1);
    room_rod(b, -0.3, 0, z - 0.05, -0.05, s[1], 0.3, 0.013);
    room_rod(b, 0.3, 0, z - 0.05, 0.05, s[1], 0.3, 0.013);
    room_rod(b, 0, 0, 0.05, 0, s[1] - 0.1, 0.3, 0.013);
    kit_box(b, -0.35, 0.72, z - 0.24, 0.35, 0.745, z - 0.1);
    kit_place_tilted(b, 0, 0.746, z - 0.14, 0, -11);
    kit_colour(b, 0.8, 0.78, 0.72);
    kit_box(b, -0.32, 0, -0.012, 0.32, 0.8, 0.012);
    room_cover(b);
    kit_box(b, -0.2, 0.1, 0.012, 0.24, 0.5, 0.0135);
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>kitchens -------------------------------------------------------------------------------------------------- */

static void tap(kit_room *r, double x, double y, double z)
{
    kit_build *b = r->b;

    enum { ARC = 12 };

    double at[ARC + 2][3] = { { x, y, z } };
    for (int i = 0; i <= ARC; i++) {
        const double a = KIT_PI * i / ARC;
        at[i + 1][0] = x;
        at[i + 1][1] = y + 0.22 + 0.08 * sin(a);
        at[i + 1][2] = z + 0.08 * (1 - cos(a));
    }
    room_paint(b, r->metal, 0.05);
    kit_tube(b, (const double(*)[3])at, ARC + 2, 0.012, 12);
    room_rod(b, x + 0.01, y + 0.08, z, x + 0.07, y + 0.1, z, 0.007);
}

/* A worktop with a hole where the basin is, from x0 to x1. */
static void worktop(kit_room *r, const double s[3], double x0, double x1)
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], y = s[1] - 0.035, z = s[2] + 0.02, z0 = 0.12, z1 = s[2] - 0.08, d = s[1] - 0.2;
    kit_box(b, -x, y, 0.001, x0, s[1], z);
    kit_box(b, x1, y, 0.001, x, s[1], z);
    kit_box(b, x0, y, 0.001, x1, s[1], z0);
    kit_box(b, x0, y, z1, x1, s[1], z);
    const double side[4][4][3] = { { { x0, d, z0 }, { x0, d, z1 }, { x0, s[1], z1 }, { x0, s[1], z0 } },
                                   { { x1, d, z1 }, { x1, d, z0 }, { x1, s[1], z0 }, { x1, s[1], z1 } },
                                   { { x0, d, z0 }, { x0, s[1], z0 }, { x1, s[1], z0 }, { x1, d, z0 } },
                                   { { x0, d, z1 }, { x1, d, z1 }, { x1, s[1], z1 }, { x0, s[1], z1 } } };
    room_paint(b, r->metal, 0.05);
    const double in = 0.002;
    for (int i = 0; i < 4; i++) {
        double c[4][3];
        for (int k = 0; k < 4; k++) {
            c[k][0] = side[i][k][0] + (side[i][k][0] > 0.5 * (x0 + x1) ? -in : in);
            c[k][1] = side[i][k][1] + (side[i][k][1] > s[1] - 0.01 ? 0.002 : 0);
            c[k][2] = side[i][k][2] + (side[i][k][2] > 0.5 * (z0 + z1) ? -in : in);
        }
        kit_quad(b, (const double(*)[3])c);
    }
    kit_level(b, x0, z0, x1, z1, d);
    tap(r, 0.5 * (x0 + x1), s[1], 0.07);
}

static void hob(kit_room *r, double x, double y, double z)
{
    kit_build *b = r->b;
    kit_colour(b, 0.05, 0.05, 0.055);
    kit_bevelled(b, x - 0.29, y, z - 0.25, x + 0.29, y + 0.008, z + 0.25, 0.002);
    for (int i = 0; i < 4; i++) {
        const double e = x + (i & 1 ? 0.14 : -0.14), f = z + (i & 2 ? 0.11 : -0.12);
        kit_colour(b, 0.12, 0.12, 0.12);
        room_ring(b, e, y + 0.016, f, 0, 0, 0.06, 0.009);
        for (int k = 0; k < 4; k++)
            room_rod(b, e + 0.025 * cos(1.57 * k), y + 0.03, f + 0.025 * sin(1.57 * k), e + 0.1 * cos(1.57 * k),
                     y + 0.03, f + 0.1 * sin(1.57 * k), 0.004);
    }
    const double half = 0.1;
    if (kit_odds(b, 0.7)) room_clutter(r, x - half, z - 0.22, x + half, z + 0.2, y + 0.034, 0.26, 0.3);
}

/* Cupboards under a worktop with a sink and a hob, cupboards or shelves above. */
void kit_kitchen(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const int units = (int)(s[0] / 0.58), sink = kit_choose(b, units),
              stove = (sink + 1 + kit_choose(b, units - 1)) % units;
    const double unit = s[0] / units, base[3] = { unit, 0.865, s[2] - 0.02 }, whole[3] = { s[0], 0.9, s[2] - 0.02 };
    const double x0 = -0.5 * s[0] + sink * unit + 0.06, over = kit_between(b, 1.42, 1.55);
    const int theme = r->theme;
    for (int i = 0; i < units; i++) {
        const kit_frame before = kit_enter(b, -0.5 * s[0] + (i + 0.5) * unit, 0, 0, 0, 1);
        kit_begin_object(b, "unit", -1);
        r->theme = 0;
        if (i == stove) kit_washer(r, base);
        else if (kit_odds(b, 0.35)) kit_drawers(r, base);
        else kit_cabinet(r, base);
        r->theme = theme;
        kit_leave(b, before);
    }
    kit_begin_object(b, "worktop", -1);
    room_paint(b, kit_odds(b, 0.5) ? r->wood : r->metal, 0.2);
    worktop(r, whole, x0, x0 + unit - 0.12);
    hob(r, -0.5 * s[0] + (stove + 0.5) * unit, 0.9, 0.5 * s[2]);
    for (int i = 0; i < units; i++) {
        const double e = -0.5 * s[0] + i * unit;
        if (i != sink && i != stove) room_clutter(r, e, 0.02, e + unit, s[2], 0.9, 0.45, 1 + 2 * r->clutter);
        room_sight_here(r, e + 0.5 * unit, 0.95, 0.4, 0.4);
    }
    if (s[1] < 1.6) return;
    for (int i = 0; i < units; i++) {
        const double high[3] = { unit - 0.002, fmin(0.75, s[1] - over), 0.33 }, shelf[3] = { unit, 0.6, 0.26 },
                     rail[3] = { unit, 0.35, 0.1 };
        const kit_frame before = kit_enter(b, -0.5 * s[0] + (i + 0.5) * unit, over, 0, 0, 1);
        const double way = kit_chance(b);
        kit_begin_object(b, "cupboard", -1);
        if (way < 0.45) kit_cabinet(r, high);
        else if (way < 0.75) kit_wall_shelf(r, shelf);
        else kit_tool_rail(r, rail);
        kit_leave(b, before);
    }
}

void kit_fridge(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], cut = 0.65 * s[1], z = s[2] - 0.06;
    room_paint(b, kit_odds(b, 0.6) ? r->trim : r->accent, 0.05);
    kit_bevelled(b, -x, 0.03, 0.01, x, s[1], z, 0.01);
    kit_bevelled(b, -x, 0.05, z + 0.004, x, cut - 0.004, s[2], 0.012);
    kit_bevelled(b, -x, cut + 0.004, z + 0.004, x, s[1], s[2], 0.012);
    room_paint(b, r->metal, 0.1);
    room_rod(b, x - 0.06, 0.6 * cut, s[2] + 0.03, x - 0.06, cut - 0.05, s[2] + 0.03, 0.01);
    room_rod(b, x - 0.06, cut + 0.05, s[2] + 0.03, x - 0.06, 0.5 * (cut + s[1]), s[2] + 0.03, 0.01);
    for (int i = 0; i < 6; i++) {
        room_cover(b);
        kit_place_tilted(b, kit_between(b, -0.6, 0.3) * x, kit_between(b, 0.8, 1.4), s[2] + 0.001, 0, 0);
        kit_box(b, -0.04, 0, 0, 0.04, kit_between(b, 0.05, 0.12), 0.001);
        kit_place_at(b, 0, 0, 0, 0);
    }
    if (s[1] < 1.9) room_clutter(r, -x, 0.02, x, z, s[1], 0.3, 1);
}

void kit_island(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double base[3] = { s[0] - 0.1, 0.86, s[2] - 0.35 }, x = 0.5 * s[0];
    const int theme = r->theme;
    r->theme = 0;
    kit_cabinet(r, base);
    r->theme = theme;
    room_paint(b, r->wood, 0.2);
    kit_bevelled(b, -x, 0.861, 0, x, 0.9, s[2], 0.005);
    room_clutter(r, -x, 0.03, x, s[2] - 0.03, 0.9, 0.45, 0.8 + r->clutter);
    for (int i = -1; i <= 1; i += 2) {
        const kit_frame before = kit_enter(b, 0.25 * i * s[0], 0, s[2] + 0.05, 180, 1);
        kit_begin_object(b, "stool", -1);
        room_chair(r, 7);
        kit_leave(b, before);
    }
}

/* A bar with tools on hooks. */
void kit_tool_rail(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double y = s[1] - 0.02, z = 0.05;
    room_paint(b, r->metal, 0.1);
    room_rod(b, -0.5 * s[0] + 0.02, y, z, 0.5 * s[0] - 0.02, y, z, 0.007);
    for (int i = -1; i <= 1; i += 2)
        room_rod(b, i * (0.5 * s[0] - 0.05), y, 0.001, i * (0.5 * s[0] - 0.05), y, z, 0.006);
    for (double x = -0.5 * s[0] + 0.09; x < 0.5 * s[0] - 0.06; x += kit_between(b, 0.07, 0.13)) {
        const int kind = kit_choose(b, 4);
        const double l = kit_between(b, 0.16, 0.26);
        room_paint(b, r->metal, 0.3);
        room_ring(b, x, y - 0.004, z + 0.004, 90, 90, 0.013, 0.002);
        room_rod(b, x, y - 0.015, z + 0.008, x, y - l, z + 0.008, 0.0045);
        if (kind == 0) {
            const double half[3] = { 0.032, 0.05, 0.004 };
            room_pillow(b, x, y - l - 0.045, z + 0.008, 0, 0, half);
        }
        if (kind == 1) room_vessel(b, x, y - l - 0.03, z + 0.03, 0.02, 0.035, 0.03, 0.008);
        if (kind == 2)
            for (int k = 0; k < 5; k++) room_ring(b, x, y - l - 0.04, z + 0.008, 36 * k, 90, 0.03, 0.0013);
        if (kind == 3) {
            kit_place_tilted(b, x, y - l - 0.09, z, 0, 90);
            kit_cylinder(b, kit_between(b, 0.07, 0.1), 0.025, 30);
            kit_place_at(b, 0, 0, 0, 0);
            x += 0.1;
        }
    }
}

/* A machine with a round door, or an oven. */
void kit_washer(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], z = s[2] - 0.02;
    const int oven = (r->theme & KIT_BATH) == 0;
    room_paint(b, oven ? r->metal : r->trim, 0.1);
    kit_bevelled(b, -x + 0.003, 0.02, 0.005, x - 0.003, s[1], z, 0.006);
    kit_colour(b, 0.07, 0.07, 0.08);
    if (oven) {
        kit_bevelled(b, -x + 0.05, 0.2, z, x - 0.05, 0.62 * s[1], z + 0.012, 0.003);
        room_rod(b, -x + 0.07, 0.68 * s[1], z + 0.035, x - 0.07, 0.68 * s[1], z + 0.035, 0.009);
    } else {
        kit_place_tilted(b, 0, 0.5 * s[1], z, 0, 90);
        kit_cylinder(b, 0.16, 0.014, 36);
        room_paint(b, r->metal, 0.1);
        room_ring(b, 0, 0.5 * s[1], z + 0.01, 0, 90, 0.17, 0.022);
    }
    for (int i = 0; i < 4; i++) {
        room_paint(b, r->metal, 0.2);
        room_rod(b, x * (0.45 * i - 0.65), 0.9 * s[1], z, x * (0.45 * i - 0.65), 0.9 * s[1], z + 0.025, 0.018);
    }
    if (!oven) room_clutter(r, -x, 0.02, x, z, s[1], 0.35, 1.2);
}

/* ---- >>workshops ------------------------------------------------------------------------------------------------- */

void kit_workbench(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0];
    room_paint(b, r->wood, 0.2);
    kit_bevelled(b, -x, s[1] - 0.07, 0.005, x, s[1], s[2], 0.006);
    for (int i = 0; i < 4; i++) {
        const double e = (i & 1 ? 1 : -1) * (x - 0.1), f = i & 2 ? s[2] - 0.08 : 0.08;
        kit_box(b, e - 0.05, 0, f - 0.05, e + 0.05, s[1] - 0.071, f + 0.05);
    }
    kit_box(b, -x + 0.15, 0.2, 0.04, x - 0.15, 0.23, s[2] - 0.04);
    kit_frame before = kit_enter(b, -x + 0.16, 0.231, 0.06, 0, 1);
    room_fill_shelf(r, s[0] - 0.32, s[2] - 0.12, 0.4);
    kit_leave(b, before);
    room_paint(b, r->metal, 0.2); /* a vice */
    kit_bevelled(b, -x + 0.2, s[1] + 0.001, s[2] - 0.1, -x + 0.36, s[1] + 0.15, s[2] - 0.04, 0.006);
    kit_bevelled(b, -x + 0.2, s[1] + 0.03, s[2] + 0.02, -x + 0.36, s[1] + 0.15, s[2] + 0.07, 0.006);
    room_rod(b, -x + 0.28, s[1] + 0.06, s[2] - 0.04, -x + 0.28, s[1] + 0.06, s[2] + 0.16, 0.016);
    room_rod(b, -x + 0.18, s[1] + 0.06, s[2] + 0.15, -x + 0.38, s[1] + 0.06, s[2] + 0.15, 0.006);
    room_clutter(r, -x + 0.4, 0.02, x, s[2], s[1], 0.5, 1.5 + 2 * r->clutter);
    room_sight_here(r, -x + 0.28, s[1] + 0.1, s[2], 0.3);
}

/* A saw, a hammer, a spanner or a pair of pincers, hanging on a board. */
static void hung_tool(kit_room *r, double x, double y)
{
    kit_build *b = r->b;
    const double l = kit_between(b, 0.1, 0.3), z = 0.025;
    const int kind = kit_choose(b, 4);
    room_paint(b, r->metal, 0.3);
    room_rod(b, x, y, 0.01, x, y, 0.05, 0.003);
    if (kind == 0) {
        const double blade[4][3] = { { x - 0.05, y - 0.1, z },
                                     { x + 0.05, y - 0.1, z },
                                     { x + 0.02, y - 0.16 - l, z },
                                     { x - 0.015, y - 0.16 - l, z } };
        kit_quad(b, blade);
        room_paint(b, r->wood, 0.2);
        room_ring(b, x, y - 0.055, z, 0, 90, 0.036, 0.012);
    } else if (kind == 1) {
        kit_bevelled(b, x - 0.06, y - 0.02, z - 0.012, x + 0.05, y + 0.012, z + 0.014, 0.004);
        room_paint(b, r->wood, 0.3);
        room_rod(b, x, y - 0.02, z, x, y - 0.04 - l, z, 0.012);
    } else if (kind == 2) {
        room_ring(b, x, y - 0.01, z, 0, 90, 0.016, 0.006);
        kit_bevelled(b, x - 0.009, y - 0.03 - l, z - 0.004, x + 0.009, y - 0.022, z + 0.004, 0.002);
        room_ring(b, x, y - 0.045 - l, z, 0, 90, 0.018, 0.006);
    } else
        for (int k = -1; k <= 1; k += 2) {
            room_rod(b, x + 0.03 * k, y - l, z, x - 0.012 * k, y - 0.02, z, 0.007);
            room_rod(b, x - 0.012 * k, y - 0.02, z, x, y + 0.03, z, 0.006);
        }
}

void kit_pegboard(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    room_paint(b, kit_odds(b, 0.5) ? r->trim : r->wood, 0.2);
    kit_box(b, -0.5 * s[0], 0, 0.002, 0.5 * s[0], s[1], 0.01);
    for (double y = s[1] - 0.08; y > 0.25; y -= 0.36)
        for (double x = -0.5 * s[0] + 0.08; x < 0.5 * s[0] - 0.05; x += kit_between(b, 0.08, 0.2)) hung_tool(r, x, y);
    room_sight_here(r, 0.2 * s[0], 0.6 * s[1], 0, 0.3);
}

/* ---- >>bathrooms ------------------------------------------------------------------------------------------------- */

/* a tub: half its length and width, height, the share of its inside */
static void tub(const double *s, double u, double v, double p[3])
{
    const double a = 2 * KIT_PI * u, c = cos(a), z = sin(a),
                 up = v < 0.45 ? v / 0.45
                    : v < 0.55 ? 1
                               : fmax(0.12, 1 - (v - 0.55) / 0.3),
                 in = v < 0.45 ? 0.8 + 0.2 * up
                    : v < 0.55 ? 1 - (v - 0.45)
                    : v < 0.85 ? 0.72 + 0.18 * (1 - (v - 0.55) / 0.3)
                               : 0.72 * (1 - (v - 0.85) / 0.15);
    p[0] = s[0] * in * copysign(pow(fabs(c), s[3]), c);
    p[1] = s[2] * up;
    p[2] = s[1] * in * copysign(pow(fabs(z), s[3]), z);
}

void kit_bath(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const int stands = kit_odds(b, 0.5);
    const double of[4] = { 0.5 * s[0] - 0.02, 0.5 * s[2] - 0.02, s[1] - 0.1, stands ? 0.75 : 0.3 }, z = 0.5 * s[2];
    kit_colour(b, 0.82, 0.82, 0.8);
    kit_place_at(b, 0, 0.1, z, 0);
    room_cloth(b, 80, 48, tub, of);
    kit_place_at(b, 0, 0, 0, 0);
    if (!stands) {
        kit_box(b, -0.5 * s[0], 0, s[2] - 0.02, 0.5 * s[0], s[1] - 0.03, s[2]);
        kit_box(b, -0.5 * s[0], 0, 0.002, -0.5 * s[0] + 0.02, s[1] - 0.03, s[2] - 0.021);
        kit_box(b, 0.5 * s[0] - 0.02, 0, 0.002, 0.5 * s[0], s[1] - 0.03, s[2] - 0.021);
    } else
        for (int i = 0; i < 4; i++)
            room_ball(b, (i & 1 ? 0.6 : -0.6) * of[0], 0.055, z + (i & 2 ? 0.5 : -0.5) * of[1], 0.055, 10);
    tap(r, 0, s[1] - 0.02, 0.03);
    if (kit_odds(b, 0.6)) { /* a shower and its curtain */

        enum { HOSE = 20 };

        double hose[HOSE + 1][3];
        for (int i = 0; i <= HOSE; i++) {
            const double t = (double)i / HOSE;
            hose[i][0] = 0.15 * sin(3 * t) - 0.3;
            hose[i][1] = s[1] + 0.1 + 1.2 * t - 1.2 * t * (1 - t);
            hose[i][2] = 0.03 + 0.05 * sin(KIT_PI * t);
        }
        room_paint(b, r->metal, 0.1);
        kit_tube(b, (const double(*)[3])hose, HOSE + 1, 0.008, 8);
        room_rod(b, -0.28, s[1] + 0.3, 0.04, -0.28, s[1] + 1.4, 0.04, 0.01);
        room_rod(b, -0.28, s[1] + 1.35, 0.04, -0.28, s[1] + 1.3, 0.14, 0.012);
        room_rod(b, -0.5 * s[0], 2, s[2] - 0.04, 0.5 * s[0], 2, s[2] - 0.04, 0.011);
        room_paint(b, r->cloth, 0.2);
        kit_place_at(b, 0.3 * s[0], 1.98, s[2] - 0.03, 0);
        room_hang_cloth(b, 0.36 * s[0], 1.5, 0.03);
        kit_place_at(b, 0, 0, 0, 0);
    }
    if (!kit_odds(b, 0.5)) return;
    room_paint(b, r->accent, 0.2);
    kit_place_at(b, -0.25 * s[0], s[1] + 0.01, s[2] - 0.03, 180);
    room_hang_cloth(b, 0.4, 0.2, 0.35);
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_basin(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double under[3] = { s[0], s[1] - 0.14, s[2] - 0.05 }, x = 0.5 * s[0];
    if (kit_odds(b, 0.6)) {
        const int theme = r->theme;
        r->theme = 0;
        kit_cabinet(r, under);
        r->theme = theme;
        kit_colour(b, 0.82, 0.82, 0.8);
        room_vessel(b, 0, s[1] - 0.139, 0.5 * s[2], 0.12, 0.2, 0.14, 0.03);
        room_clutter(r, -x, 0.02, -0.22, s[2] - 0.06, s[1] - 0.14, 0.3, 1.5);
    } else {
        const kit_moulding foot[] = { { 0.11, 0, 0.07, s[1] - 0.2, -0.01 } };
        kit_colour(b, 0.82, 0.82, 0.8);
        kit_place_at(b, 0, 0, 0.5 * s[2], 0);
        kit_turned(b, foot, 1, 32);
        kit_place_at(b, 0, 0, 0, 0);
        room_vessel(b, 0, s[1] - 0.2, 0.5 * s[2], 0.1, 0.5 * s[2] - 0.01, 0.2, 0.05);
        kit_bevelled(b, -0.12, s[1] - 0.1, 0.002, 0.12, s[1], 0.08, 0.008);
        room_paint(b, r->metal, 0.1);
        room_rod(b, 0, s[1] - 0.25, 0.2, 0, s[1] - 0.3, 0.01, 0.016);
    }
    tap(r, 0, s[1] - (x > 0.35 ? 0.1 : 0), 0.045);
}

void kit_toilet(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double z = 0.42, seat[2] = { 0.155, 0.03 };
    const kit_moulding bowl[] = { { 0.12, 0, 0.1, 0.15, 0.01 },
                                  { 0.1, 0.15, 0.18, 0.38, -0.02 },
                                  { 0.18, 0.38, 0.13, 0.385, 0 },
                                  { 0.13, 0.385, 0.05, 0.22, -0.03 },
                                  { 0.05, 0.22, 0, 0.2, 0 } };
    kit_colour(b, 0.82, 0.82, 0.8);
    kit_place_at(b, 0, 0, z, 0);
    kit_turned(b, bowl, 5, 40);
    kit_place_at(b, 0, 0.395, z, 0);
    kit_patch(b, 40, 10, kit_torus_surface, seat);
    kit_place_at(b, 0, 0, 0, 0);
    kit_box(b, -0.1, 0.02, 0.1, 0.1, 0.36, 0.4);
    kit_bevelled(b, -0.19, 0.38, 0.005, 0.19, s[1], 0.19, 0.02);
    kit_place_tilted(b, 0, 0.42, 0.24, 0, kit_odds(b, 0.5) ? -8 : 88);
    kit_bevelled(b, -0.17, 0, -0.012, 0.17, 0.36, 0.012, 0.01);
    room_paint(b, r->metal, 0.1);
    kit_place_tilted(b, 0.33, 0.7, 0.08, 90, 90);
    room_rod(b, 0, -0.07, 0, 0, 0.07, 0, 0.006);
    kit_colour(b, 0.82, 0.82, 0.8);
    kit_place_tilted(b, 0.28, 0.7, 0.08, 90, 90);
    kit_cylinder(b, 0.055, 0.1, 28);
    kit_place_at(b, 0, 0, 0, 0);
}

/* A rail, or a ladder of rails, with towels. */
void kit_towels(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0];
    room_paint(b, r->metal, 0.05);
    for (int i = -1; i <= 1; i += 2) {
        room_rod(b, i * x, 0, 0.08, i * x, s[1], 0.08, 0.014);
        room_rod(b, i * x, 0.05, 0.001, i * x, 0.05, 0.08, 0.009);
        room_rod(b, i * x, s[1] - 0.05, 0.001, i * x, s[1] - 0.05, 0.08, 0.009);
    }
    for (double y = 0.04; y < s[1]; y += 0.09)
        if (fmod(y, 0.45) < 0.32) room_rod(b, -x, y, 0.08, x, y, 0.08, 0.009);
    for (int i = 0; i < 2; i++) {
        if (kit_odds(b, 0.3)) continue;
        room_paint(b, i ? r->cloth : r->accent, 0.3);
        kit_place_at(b, kit_between(b, -0.1, 0.1) * x, (i ? 0.5 : 0.97) * s[1], 0.08, 0);
        room_hang_cloth(b, kit_between(b, 0.6, 0.85) * s[0], kit_between(b, 0.25, 0.4) * s[1], 0.2 * s[1]);
        kit_place_at(b, 0, 0, 0, 0);
    }
}
