/* clutter.c - small things that lie about in rooms. Declared in rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>

/* ---- >>things: each stands on the origin ------------------------------------------------------------------------- */

static void book(kit_build *b, double w, double h, double d)
{
    room_cover(b);
    kit_box(b, -w, 0, -d, w, 0.003, d);
    kit_box(b, -w, h - 0.003, -d, w, h, d);
    kit_box(b, -w, 0.003, -d, -w + 0.003, h - 0.003, d);
    kit_colour(b, 0.78, 0.75, 0.66);
    kit_box(b, -w + 0.003, 0.003, -d + 0.004, w - 0.004, h - 0.003, d - 0.004);
}

static void books_lying(kit_room *r)
{
    kit_build *b = r->b;
    double y = 0;
    for (int i = 1 + kit_choose(b, 6); i > 0; i--) {
        const double h = kit_between(b, 0.012, 0.045), w = kit_between(b, 0.07, 0.1);
        kit_place_at(b, 0, y, 0, kit_between(b, -20, 20));
        book(b, w, h, w * kit_between(b, 1.25, 1.5));
        y += h + KIT_GAP;
    }
}

static void vase(kit_room *r)
{
    kit_build *b = r->b;
    const double h = kit_between(b, 0.12, 0.32), foot = kit_between(b, 0.03, 0.06), neck = kit_between(b, 0.018, 0.04);
    const unsigned twigs = kit_odds(b, 0.5) ? 4u + (unsigned)kit_choose(b, 6) : 0;
    const kit_moulding profile[] = { { 0, 0, foot, 0, 0 },
                                     { foot, 0, neck, 0.8 * h, kit_between(b, 0, 0.05) },
                                     { neck, 0.8 * h, neck * 1.4, h, -0.006 },
                                     { neck * 1.4, h, neck * 0.8, 0.9 * h, 0 } };
    room_cover(b);
    kit_turned(b, profile, 4, 32);
    for (unsigned i = 0; i < twigs; i++) {
        const double a = kit_between(b, 0, 360), lean = kit_between(b, 5, 30), high = kit_between(b, 0.12, 0.3);
        const double x = high * sin(lean * KIT_PI / 180) * sin(a * KIT_PI / 180),
                     z = high * sin(lean * KIT_PI / 180) * cos(a * KIT_PI / 180), y = 0.8 * h + high;
        kit_colour(b, 0.24, 0.33, 0.12);
        room_rod(b, 0, 0.7 * h, 0, x, y, z, 0.0015);
        room_cover(b);
        for (int k = 0; k < 5; k++) {
            kit_place_tilted(b, x, y, z, 72 * k, -30);
            kit_leaf(b, 0.025, 0.04, 0.8, 3, 1);
        }
        kit_place_at(b, 0, 0, 0, 0);
    }
}

static void mug(kit_room *r)
{
    kit_build *b = r->b;
    const double rim = kit_between(b, 0.036, 0.045), h = kit_between(b, 0.08, 0.11);
    room_cover(b);
    room_vessel(b, 0, 0, 0, 0.85 * rim, rim, h, kit_between(b, 0, 0.008));
    room_ring(b, rim + 0.012, 0.5 * h, 0, 0, 90, 0.026, 0.004);
}

static void bowl(kit_room *r)
{
    kit_build *b = r->b;
    static const float fruit[][3] = { { 0.7f, 0.12f, 0.08f }, { 0.75f, 0.4f, 0.06f }, { 0.4f, 0.5f, 0.12f } };
    const double rim = kit_between(b, 0.1, 0.15);
    room_cover(b);
    room_vessel(b, 0, 0, 0, 0.4 * rim, rim, 0.55 * rim, 0.03);
    for (int i = kit_odds(b, 0.7) ? 6 : 0; i > 0; i--) {
        KIT_TINT(b, fruit, 0.2);
        room_ball(b, i == 6 ? 0 : 0.5 * rim * cos(1.26 * i), i == 6 ? 0.62 * rim : 0.4 * rim,
                  i == 6 ? 0 : 0.5 * rim * sin(1.26 * i), 0.31 * rim, 12);
    }
}

static void bottles(kit_room *r)
{
    kit_build *b = r->b;
    for (int i = 1 + kit_choose(b, 4); i > 0; i--) {
        const double h = kit_between(b, 0.16, 0.31), w = kit_between(b, 0.025, 0.042), neck = 0.35 * w;
        const kit_moulding profile[] = { { 0, 0, w, 0, 0 },
                                         { w, 0, w, 0.6 * h, 0 },
                                         { w, 0.6 * h, neck, 0.78 * h, 0.008 },
                                         { neck, 0.78 * h, neck, h, 0 },
                                         { neck, h, 0, h, 0 } };
        kit_colour(b, kit_between(b, 0.05, 0.5), kit_between(b, 0.15, 0.5), kit_between(b, 0.05, 0.4));
        kit_place_at(b, 0.075 * cos(1.6 * i), 0, 0.075 * sin(1.6 * i), 0);
        kit_turned(b, profile, 5, 20);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void plates(kit_room *r)
{
    kit_build *b = r->b;
    const double rim = kit_between(b, 0.09, 0.14);
    const int many = 1 + kit_choose(b, 9);
    for (int i = 0; i < many; i++) {
        kit_colour(b, 0.8, 0.79, 0.75);
        room_vessel(b, kit_between(b, -0.002, 0.002), 0.007 * i, 0, 0.6 * rim, rim, 0.02, -0.003);
    }
}

static void candles(kit_room *r)
{
    kit_build *b = r->b;
    for (int i = 1 + kit_choose(b, 3); i > 0; i--) {
        const double h = kit_between(b, 0.06, 0.2), x = 0.07 * (i - 2), z = kit_between(b, -0.03, 0.03);
        room_paint(b, r->metal, 0.1);
        room_vessel(b, x, 0, z, 0.035, 0.02, 0.04, -0.01);
        kit_colour(b, 0.85, 0.80, 0.68);
        kit_place_at(b, x, 0.004, z, 0);
        kit_cylinder(b, 0.011, h, 16);
        kit_colour(b, 0.1, 0.1, 0.1);
        room_rod(b, 0, h, 0, 0.002, h + 0.01, 0, 0.001);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void photo(kit_room *r)
{
    kit_build *b = r->b;
    const double w = kit_between(b, 0.05, 0.11), h = w * kit_between(b, 1.1, 3);
    kit_place_tilted(b, 0, 0.004, 0.02, 0, -12);
    room_paint(b, r->trim, 0.3);
    kit_box(b, -w, 0, -0.006, w, 0.014, 0.006);
    kit_box(b, -w, h - 0.014, -0.006, w, h, 0.006);
    kit_box(b, -w, 0.014, -0.006, -w + 0.014, h - 0.014, 0.006);
    kit_box(b, w - 0.014, 0.014, -0.006, w, h - 0.014, 0.006);
    room_cover(b);
    kit_box(b, -w + 0.014, 0.014, -0.005, w - 0.014, h - 0.014, 0.001);
    kit_place_at(b, 0, 0, 0, 0);
    kit_box(b, -0.012, 0, -0.09, 0.012, 0.004, -0.02);
}

static void small_plant(kit_room *r) { room_plant(r, kit_between(r->b, 0.18, 0.4)); }

static void laptop(kit_room *r)
{
    kit_build *b = r->b;
    kit_colour(b, 0.5, 0.5, 0.52);
    kit_bevelled(b, -0.16, 0, -0.11, 0.16, 0.016, 0.11, 0.003);
    kit_place_tilted(b, 0, 0.016, -0.108, 0, -kit_between(b, 5, 30));
    kit_box(b, -0.16, 0, -0.006, 0.16, 0.215, 0);
    kit_colour(b, 0.05, 0.06, 0.08);
    kit_box(b, -0.15, 0.012, 0, 0.15, 0.205, 0.001);
    kit_place_at(b, 0, 0, 0, 0);
    for (int i = 0; i < 60; i++)
        kit_box(b, -0.142 + 0.024 * (i % 12), 0.016, -0.085 + 0.024 * (i / 12), -0.122 + 0.024 * (i % 12), 0.018,
                -0.066 + 0.024 * (i / 12));
}

static void papers(kit_room *r)
{
    kit_build *b = r->b;
    const int many = 2 + kit_choose(b, 7);
    for (int i = 0; i < many; i++) {
        kit_colour(b, 0.82, 0.82, 0.78);
        kit_place_tilted(b, kit_between(b, -0.04, 0.04), 0.002 + 0.0015 * i, -0.13, kit_between(b, -25, 25), 0);
        kit_leaf(b, 0.21, 0.29, kit_between(b, -0.12, -0.01), 5, 0);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void pen_cup(kit_room *r)
{
    kit_build *b = r->b;
    room_cover(b);
    room_vessel(b, 0, 0, 0, 0.036, 0.038, 0.1, 0);
    for (int i = 0; i < 7; i++) {
        const double a = 0.9 * i;
        room_cover(b);
        room_rod(b, 0.012 * cos(a + 3), 0.008, 0.012 * sin(a + 3), 0.034 * cos(a), kit_between(b, 0.14, 0.19),
                 0.034 * sin(a), 0.0038);
    }
}

/* A box of card: sheets without thickness, its flaps open, or closed. */
static void carton(kit_room *r)
{
    kit_build *b = r->b;
    const double x = kit_between(b, 0.1, 0.2), z = kit_between(b, 0.08, 0.18), h = kit_between(b, 0.1, 0.3);
    const double c[4][2] = { { -x, z }, { x, z }, { x, -z }, { -x, -z } };
    kit_colour(b, 0.52 * kit_between(b, 0.85, 1.15), 0.38, 0.24);
    if (kit_odds(b, 0.45)) {
        kit_box(b, -x, 0, -z, x, h, z);
        kit_colour(b, 0.65, 0.56, 0.40);
        kit_box(b, -x - 0.001, h - 0.06, -0.025, x + 0.001, h + 0.001, 0.025);
        return;
    }
    kit_level(b, -x, -z, x, z, 0.003);
    for (int i = 0; i < 4; i++) {
        const double *p = c[i], *q = c[(i + 1) % 4], out = kit_between(b, 0.02, 0.12), up = kit_between(b, -0.05, 0.07);
        const double nx = (q[1] - p[1]) / -hypot(q[0] - p[0], q[1] - p[1]),
                     nz = (q[0] - p[0]) / hypot(q[0] - p[0], q[1] - p[1]);
        const double side[4][3] = { { p[0], 0, p[1] }, { q[0], 0, q[1] }, { q[0], h, q[1] }, { p[0], h, p[1] } };
        const double flap[4][3] = { { p[0], h, p[1] },
                                    { q[0], h, q[1] },
                                    { q[0] + out * nx, h + up, q[1] + out * nz },
                                    { p[0] + out * nx, h + up, p[1] + out * nz } };
        kit_quad(b, side);
        kit_quad(b, flap);
    }
    for (int i = 0; i < 5; i++) {
        room_cover(b);
        kit_place_tilted(b, kit_between(b, -0.6, 0.6) * x, 0.1 * h, kit_between(b, -0.5, 0.5) * z,
                         kit_between(b, 0, 90), kit_between(b, -12, 12));
        kit_box(b, -0.03, 0, -0.01, 0.03, kit_between(b, 0.5, 1.05) * h, 0.02);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void globe(kit_room *r)
{
    kit_build *b = r->b;
    room_paint(b, r->wood, 0.2);
    kit_place_at(b, 0, 0, 0, 0);
    kit_cylinder(b, 0.07, 0.02, 28);
    room_rod(b, 0, 0.02, 0, 0, 0.07, 0, 0.008);
    room_ring(b, 0, 0.19, 0, 20, 90, 0.125, 0.005);
    kit_colour(b, 0.15, 0.32, 0.45);
    room_ball(b, 0, 0.19, 0, 0.11, 20);
}

static void cooking_pot(kit_room *r)
{
    kit_build *b = r->b;
    const double w = kit_between(b, 0.08, 0.13), h = kit_between(b, 0.07, 0.18);
    const int lid = kit_odds(b, 0.5), pan = kit_odds(b, 0.4);
    if (kit_odds(b, 0.7)) kit_colour(b, 0.5, 0.5, 0.51);
    else room_cover(b);
    room_vessel(b, 0, 0, 0, w, w * 1.03, pan ? 0.05 : h, 0);
    if (pan) {
        kit_colour(b, 0.06, 0.06, 0.06);
        room_rod(b, w, 0.035, 0, w + 0.19, 0.06, 0, 0.009);
        return;
    }
    for (int i = -1; i <= 1; i += 2) room_ring(b, i * (w + 0.012), 0.75 * h, 0, 0, 0, 0.025, 0.005);
    if (!lid) return;
    const kit_moulding top[] = { { w * 1.04, h + 0.001, 0.02, h + 0.03, 0.008 },
                                 { 0.012, h + 0.02, 0.012, h + 0.05, 0 },
                                 { 0.012, h + 0.05, 0.02, h + 0.06, 0 },
                                 { 0.02, h + 0.06, 0, h + 0.065, 0 } };
    kit_turned(b, top, 4, 28);
}

static void knives_and_board(kit_room *r)
{
    kit_build *b = r->b;
    room_paint(b, r->wood, 0.3);
    kit_place_tilted(b, 0.05, 0.01, -0.04, 0, -14);
    kit_bevelled(b, -0.13, 0, -0.008, 0.11, 0.34, 0.008, 0.003);
    kit_place_tilted(b, -0.05, 0.02, 0.05, 10, -22);
    kit_bevelled(b, -0.05, 0, -0.04, 0.05, 0.2, 0.04, 0.004);
    kit_colour(b, 0.08, 0.08, 0.08);
    for (int i = 0; i < 6; i++)
        kit_box(b, -0.038 + 0.032 * (i % 3), 0.2, -0.025 + 0.03 * (i / 3), -0.022 + 0.032 * (i % 3),
                0.2 + kit_between(b, 0.07, 0.11), -0.013 + 0.03 * (i / 3));
    kit_place_at(b, 0, 0, 0, 0);
}

static void toy_blocks(kit_room *r)
{
    kit_build *b = r->b;
    for (int i = 0; i < 9; i++) {
        room_cover(b);
        kit_place_at(b, i > 6 ? 0 : 0.1 * cos(0.9 * i) * kit_between(b, 0.7, 1.3), i > 6 ? 0.05 * (i - 7) : 0,
                     i > 6 ? 0 : 0.1 * sin(0.9 * i), kit_between(b, 0, 90));
        kit_bevelled(b, -0.024, 0, -0.024, 0.024, 0.048, 0.024, 0.003);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void bear(kit_room *r)
{
    kit_build *b = r->b;
    static const double part[][6] = {
        { 0, 0.11, 0, 0.075, 0.1, 0.065 },         { 0, 0.255, 0.01, 0.065, 0.06, 0.06 },
        { 0.05, 0.31, 0, 0.022, 0.022, 0.012 },    { -0.05, 0.31, 0, 0.022, 0.022, 0.012 },
        { 0.095, 0.15, 0.03, 0.028, 0.06, 0.03 },  { -0.095, 0.15, 0.03, 0.028, 0.06, 0.03 },
        { 0.05, 0.035, 0.09, 0.032, 0.032, 0.08 }, { -0.05, 0.035, 0.09, 0.032, 0.032, 0.08 },
        { 0, 0.24, 0.065, 0.025, 0.02, 0.02 }
    };
    kit_colour(b, 0.42 * kit_between(b, 0.7, 1.3), 0.27, 0.15);
    for (size_t i = 0; i < sizeof part / sizeof *part; i++) {
        kit_place_at(b, part[i][0], part[i][1], part[i][2], 0);
        kit_cushion(b, part[i] + 3, 1, 10);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void tins(kit_room *r)
{
    kit_build *b = r->b;
    const double w = kit_between(b, 0.03, 0.055);
    for (int i = 2 + kit_choose(b, 4); i > 0; i--) {
        const double h = kit_between(b, 0.08, 0.16);
        room_cover(b);
        kit_place_at(b, 2.2 * w * ((i & 1) - 0.5), 0, 2.2 * w * ((i >> 1) - 1), 0);
        kit_cylinder(b, w, h, 22);
        room_paint(b, r->metal, 0.1);
        const kit_moulding lid[] = { { 0.9 * w, h, 1.03 * w, h, 0 },
                                     { 1.03 * w, h, 1.03 * w, h + 0.015, 0 },
                                     { 1.03 * w, h + 0.015, 0, h + 0.015, 0 } };
        kit_turned(b, lid, 3, 22);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void tools(kit_room *r)
{
    kit_build *b = r->b;
    for (int i = 0; i < 4; i++) {
        const double l = kit_between(b, 0.1, 0.16);
        kit_place_at(b, kit_between(b, -0.06, 0.06), 0.014, 0.06 * i - 0.1, kit_between(b, -25, 25));
        room_cover(b);
        room_rod(b, -l, 0, 0, 0, 0, 0, 0.013);
        kit_colour(b, 0.45, 0.45, 0.46);
        room_rod(b, 0, 0, 0, l, 0, 0, 0.005);
        if (i & 1) kit_bevelled(b, l - 0.015, -0.013, -0.05, l + 0.015, 0.014, 0.05, 0.004);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void towels(kit_room *r)
{
    kit_build *b = r->b;
    const int many = 2 + kit_choose(b, 4);
    for (int i = 0; i < many; i++) {
        const double half[3] = { kit_between(b, 0.13, 0.15), 0.026, kit_between(b, 0.1, 0.12) };
        room_paint(b, i & 1 ? r->cloth : r->accent, 0.2);
        kit_place_at(b, 0, 0.024 + 0.048 * i, 0, kit_between(b, -4, 4));
        kit_cushion(b, half, 0.25, 12);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void teapot(kit_room *r)
{
    kit_build *b = r->b;
    static const kit_moulding body[] = { { 0, 0, 0.05, 0, 0 },
                                         { 0.05, 0, 0.035, 0.11, 0.045 },
                                         { 0.037, 0.11, 0.012, 0.128, 0.004 },
                                         { 0.012, 0.128, 0, 0.145, 0.008 } };
    static const double spout[][3] = { { 0.06, 0.04, 0 }, { 0.1, 0.055, 0 }, { 0.12, 0.09, 0 }, { 0.145, 0.115, 0 } };
    room_cover(b);
    kit_turned(b, body, 4, 32);
    kit_tube(b, spout, 4, 0.011, 12);
    room_ring(b, -0.095, 0.065, 0, 0, 90, 0.036, 0.006);
}

static void basket(kit_room *r)
{
    kit_build *b = r->b;
    const double w = kit_between(b, 0.1, 0.16);
    kit_colour(b, 0.5, 0.37, 0.2);
    for (int i = 0; i < 9; i++) room_ring(b, 0, 0.012 + 0.02 * i, 0, 0, 0, w * (0.85 + 0.02 * i), 0.0095);
    kit_cylinder(b, 0.85 * w, 0.012, 24);
    for (int i = 0; i < 4; i++) {
        const double half[3] = { 0.4 * w, 0.35 * w, 0.4 * w };
        room_cover(b);
        room_pillow(b, 0.4 * w * cos(1.57 * i), 0.1 + 0.02 * i, 0.4 * w * sin(1.57 * i), 40 * i, 20, half);
    }
}

static void coil(kit_room *r)
{
    kit_build *b = r->b;

    enum { POINTS = 120 };

    double at[POINTS][3];
    const double w = kit_between(b, 0.05, 0.1);
    for (int i = 0; i < POINTS; i++) {
        const double a = 0.33 * i,
                     wide = w * (1 + 0.08 * kit_noise(3, 0.3 * i, 0, 0)) + (i > 105 ? 0.006 * (i - 105) : 0);
        at[i][0] = wide * cos(a);
        at[i][1] = 0.008 + (i > 105 ? 0 : 0.0004 * i);
        at[i][2] = wide * sin(a);
    }
    room_cover(b);
    kit_tube(b, (const double(*)[3])at, POINTS, 0.005, 7);
}

static void desk_lamp(kit_room *r)
{
    kit_build *b = r->b;
    static const kit_moulding hood[] = { { 0.075, 0, 0.03, 0.09, 0.012 },
                                         { 0.03, 0.09, 0.02, 0.13, 0 },
                                         { 0.02, 0.13, 0, 0.13, 0 } };
    const double x = kit_between(b, -0.12, -0.04), reach = kit_between(b, 0.12, 0.2);
    room_paint(b, kit_odds(b, 0.5) ? r->accent : r->metal, 0.1);
    kit_cylinder(b, 0.085, 0.02, 28);
    room_rod(b, 0, 0.02, 0, x, 0.26, 0, 0.006);
    room_rod(b, 0.012, 0.02, 0, x + 0.012, 0.26, 0, 0.003);
    room_ball(b, x, 0.265, 0, 0.013, 8);
    room_rod(b, x, 0.265, 0, reach, 0.46, 0, 0.006);
    kit_place_tilted(b, reach, 0.35, 0, 90, 12);
    kit_turned(b, hood, 3, 26);
    kit_place_at(b, 0, 0, 0, 0);
    room_lamp_here(r, reach, 0.33, 0);
}

static void table_lamp(kit_room *r)
{
    kit_build *b = r->b;
    const double high = kit_between(b, 0.22, 0.32), wide = kit_between(b, 0.1, 0.17);
    const kit_moulding foot[] = { { 0, 0, 0.07, 0, 0 },
                                  { 0.07, 0, 0.02, high, kit_between(b, -0.03, 0.05) },
                                  { 0.02, high, 0, high, 0 } };
    const kit_moulding shade[] = { { wide, high - 0.02, kit_between(b, 0.5, 1) * wide, high + 0.19, 0 } };
    room_cover(b);
    kit_turned(b, foot, 3, 28);
    kit_colour(b, 0.8, 0.74, 0.62);
    kit_turned(b, shade, 1, 36);
    room_rod(b, 0, high, 0, 0, high + 0.04, 0, 0.012);
    room_ball(b, 0, high + 0.07, 0, 0.035, 12);
    room_lamp_here(r, 0, high + 0.14, 0);
}

/* A closed curve of tube, wound about itself. */
static void knot(kit_room *r)
{
    kit_build *b = r->b;

    enum { POINTS = 128 };

    double at[POINTS + 1][3];
    const double size = kit_between(b, 0.03, 0.045);
    for (int i = 0; i <= POINTS; i++) {
        const double t = 2 * KIT_PI * i / POINTS;
        at[i][0] = size * (sin(t) + 2 * sin(2 * t));
        at[i][1] = 3.4 * size + size * (cos(t) - 2 * cos(2 * t));
        at[i][2] = -size * sin(3 * t);
    }
    room_paint(b, r->metal, 0.3);
    kit_tube(b, (const double(*)[3])at, POINTS + 1, 0.4 * size, 14);
    kit_box(b, -0.05, 0, -0.04, 0.05, 0.02, 0.04);
}

static const struct thing {
    void (*make)(kit_room *);
    double half, high;
    int themes;
} things[] = { { books_lying, 0.15, 0.28, KIT_HOME | KIT_OFFICE | KIT_NURSERY },
               { vase, 0.1, 0.45, KIT_HOME | KIT_KITCHEN },
               { mug, 0.07, 0.11, 63 - KIT_BATH - KIT_NURSERY },
               { bowl, 0.15, 0.15, KIT_HOME | KIT_KITCHEN },
               { bottles, 0.13, 0.31, KIT_KITCHEN | KIT_BATH | KIT_SHOP },
               { plates, 0.15, 0.09, KIT_KITCHEN },
               { candles, 0.12, 0.25, KIT_HOME | KIT_BATH },
               { photo, 0.12, 0.33, KIT_HOME | KIT_OFFICE },
               { small_plant, 0.15, 0.45, 63 - KIT_SHOP - KIT_NURSERY },
               { laptop, 0.2, 0.23, KIT_OFFICE | KIT_HOME },
               { papers, 0.2, 0.05, KIT_OFFICE | KIT_SHOP | KIT_NURSERY },
               { pen_cup, 0.06, 0.19, KIT_OFFICE | KIT_NURSERY | KIT_SHOP },
               { carton, 0.24, 0.37, KIT_SHOP | KIT_OFFICE },
               { globe, 0.13, 0.33, KIT_HOME | KIT_NURSERY | KIT_OFFICE },
               { cooking_pot, 0.17, 0.25, KIT_KITCHEN },
               { knives_and_board, 0.16, 0.36, KIT_KITCHEN },
               { toy_blocks, 0.16, 0.15, KIT_NURSERY },
               { bear, 0.15, 0.33, KIT_NURSERY },
               { tins, 0.14, 0.18, KIT_SHOP | KIT_KITCHEN },
               { tools, 0.22, 0.04, KIT_SHOP },
               { towels, 0.18, 0.3, KIT_BATH },
               { teapot, 0.15, 0.15, KIT_KITCHEN | KIT_HOME },
               { basket, 0.17, 0.2, KIT_BATH | KIT_KITCHEN | KIT_NURSERY },
               { coil, 0.19, 0.06, KIT_SHOP | KIT_OFFICE },
               { desk_lamp, 0.18, 0.5, KIT_OFFICE | KIT_SHOP },
               { table_lamp, 0.17, 0.55, KIT_HOME | KIT_NURSERY },
               { knot, 0.14, 0.28, KIT_HOME | KIT_OFFICE } };

enum { THINGS = sizeof things / sizeof *things, SPOTS = 24 };

static const struct thing *draw_thing(kit_room *r, double high, double half)
{
    for (int k = 0; k < 30; k++) {
        const struct thing *t = &things[kit_choose(r->b, THINGS)];
        if (t->themes & r->theme && t->high <= high && t->half <= half) return t;
    }
    return NULL;
}

static void make_thing(kit_room *r, const struct thing *t, double x, double y, double z, double turn)
{
    const kit_frame before = kit_enter(r->b, x, y + KIT_GAP, z, turn, 1);
    t->make(r);
    kit_leave(r->b, before);
}

void room_clutter(kit_room *r, double x0, double z0, double x1, double z1, double y, double high, double share)
{
    kit_build *b = r->b;
    double spot[SPOTS][3];
    const int tries = (int)(share * (2 + 14 * (x1 - x0) * (z1 - z0))) + 1;
    int used = 0;
    for (int k = 0; k < tries && used < SPOTS; k++) {
        const struct thing *t = draw_thing(r, high, 0.5 * fmin(x1 - x0, z1 - z0) + 0.03);
        if (!t) return;
        const double x = kit_between(b, fmin(x0 + t->half, 0.5 * (x0 + x1)), fmax(x1 - t->half, 0.5 * (x0 + x1))),
                     z = kit_between(b, fmin(z0 + t->half, 0.5 * (z0 + z1)), fmax(z1 - t->half, 0.5 * (z0 + z1)));
        int free = 1;
        for (int i = 0; i < used; i++)
            free = free && hypot(x - spot[i][0], z - spot[i][1]) > 0.9 * (t->half + spot[i][2]);
        if (!free) continue;
        spot[used][0] = x;
        spot[used][1] = z;
        spot[used++][2] = t->half;
        make_thing(r, t, x, y, z, kit_odds(b, 0.5) ? kit_between(b, -25, 25) : kit_between(b, 0, 360));
        if (kit_odds(b, 0.3)) room_sight_here(r, x, y + 0.4 * t->high, z, 1.6 * t->half);
    }
}

/* A pile of boxes, the top one open or not. */
void kit_boxes_piece(kit_room *r, const double s[3])
{
    double y = 0;
    while (y < s[1]) {
        const double by = kit_between(r->b, 1, 1.5);
        const kit_frame before = kit_enter(r->b, kit_between(r->b, -0.05, 0.05), y, 0.5 * s[2],
                                           kit_between(r->b, -15, 15), by);
        const double high = kit_between(r->b, 0.18, 0.3), x = 0.19, z = 0.15;
        if (y + 2 * high * by > s[1]) {
            carton(r);
            y = s[1];
        } else {
            kit_colour(r->b, 0.5 * kit_between(r->b, 0.8, 1.2), 0.37, 0.23);
            kit_box(r->b, -x, 0, -z, x, high, z);
            kit_colour(r->b, 0.66, 0.56, 0.40);
            kit_box(r->b, -x - 0.001, high - 0.08, -0.025, x + 0.001, high + 0.0005, 0.025);
        }
        y += high * by + KIT_GAP;
        kit_leave(r->b, before);
    }
}
