/* ornaments.c - what people put among plants in scenes by seed: pots, statues, fountains, tables, tools. Declared in
   foliage.h. */
#include "kit/scene/foliage/foliage.h"
#include <math.h>
#include <string.h>

static const float woods[][3] = { { 0.42f, 0.30f, 0.19f },
                                  { 0.34f, 0.31f, 0.27f },
                                  { 0.52f, 0.40f, 0.26f },
                                  { 0.70f, 0.68f, 0.64f },
                                  { 0.22f, 0.30f, 0.26f } };
static const float stones[][3] = {
    { 0.50f, 0.48f, 0.45f }, { 0.42f, 0.42f, 0.41f }, { 0.58f, 0.52f, 0.42f }, { 0.36f, 0.34f, 0.31f }
};
static const float clays[][3] = {
    { 0.55f, 0.29f, 0.19f }, { 0.48f, 0.24f, 0.15f }, { 0.62f, 0.58f, 0.52f }, { 0.22f, 0.26f, 0.34f }
};

/* ---- >>turned -------------------------------------------------------------------------------------------------- */

double garden_put_pot(kit_build *b, double height, int kind, double *opening)
{
    const double r = height * kit_between(b, 0.42, 0.6), rim = 0.9 * r, foot = kind == 1 ? 0.55 * r : 0.68 * r,
                 bulge = kind == 1 ? 0.35 * r : 0;
    const kit_moulding pot[] = { { 0, 0, foot, 0, 0 },
                                 { foot, 0, r, 0.86 * height, bulge },
                                 { r, 0.86 * height, 1.08 * r, 0.86 * height, 0 },
                                 { 1.08 * r, 0.86 * height, 1.08 * r, height, 0 },
                                 { 1.08 * r, height, rim, height, 0 },
                                 { rim, height, rim, 0.9 * height, 0 } };
    const kit_moulding soil[] = { { rim, 0.9 * height, 0, 0.93 * height, 0 } };
    KIT_TINT(b, clays, 0.15);
    if (kind == 2) {
        kit_bevelled(b, -r, 0, -r, r, 0.9 * height, r, 0.02);
        kit_bevelled(b, -1.06 * r, 0.9 * height + KIT_GAP, -1.06 * r, 1.06 * r, height, 1.06 * r, 0.01);
        *opening = 0.9 * r;
        return height;
    }
    kit_turned(b, pot, 6, 20);
    kit_colour(b, 0.14, 0.1, 0.07);
    kit_turned(b, soil, 1, 20);
    *opening = rim;
    return 0.91 * height;
}

double garden_put_trough(kit_build *b, double x, double height, double z)
{
    const double hx = x / 2, hz = z / 2, t = 0.03;
    KIT_TINT(b, woods, 0.15);
    kit_box(b, -hx, -0.05, -hz, hx, height, -hz + t);
    kit_box(b, -hx, -0.05, hz - t, hx, height, hz);
    kit_box(b, -hx, -0.05, -hz + t, -hx + t, height, hz - t);
    kit_box(b, hx - t, -0.05, -hz + t, hx, height, hz - t);
    kit_colour(b, 0.15, 0.11, 0.08);
    kit_level(b, -hx + t, -hz + t, hx - t, hz - t, 0.85 * height);
    return 0.85 * height;
}

/* a figure without a face, an urn, a ball */
void garden_put_statue(kit_build *b, double height, int kind)
{
    const double base = 0.35 * height, s = height - base, hips[3] = { 0.17 * s, 0.3 * s, 0.14 * s },
                 chest[3] = { 0.16 * s, 0.18 * s, 0.11 * s }, head[3] = { 0.07 * s, 0.09 * s, 0.08 * s },
                 ball[3] = { 0.35 * s, 0.35 * s, 0.35 * s };
    const double arms[5][3] = { { -0.24 * s, base + 0.42 * s, 0.1 * s },
                                { -0.2 * s, base + 0.66 * s, 0 },
                                { 0, base + 0.7 * s, 0 },
                                { 0.2 * s, base + 0.66 * s, 0 },
                                { 0.3 * s, base + 0.9 * s, 0.1 * s } };
    const kit_moulding urn[] = { { 0.12 * s, base, 0.05 * s, base + 0.15 * s, -0.02 * s },
                                 { 0.05 * s, base + 0.15 * s, 0.26 * s, base + 0.7 * s, 0.1 * s },
                                 { 0.26 * s, base + 0.7 * s, 0.3 * s, base + 0.75 * s, 0 },
                                 { 0.3 * s, base + 0.75 * s, 0, base + 0.68 * s, 0 } };
    KIT_TINT(b, stones, 0.12);
    kit_bevelled(b, -0.22 * height, -0.1, -0.22 * height, 0.22 * height, 0.12 * base, 0.22 * height, 0.01);
    kit_bevelled(b, -0.16 * height, 0.12 * base, -0.16 * height, 0.16 * height, 0.88 * base, 0.16 * height, 0.01);
    kit_bevelled(b, -0.2 * height, 0.88 * base, -0.2 * height, 0.2 * height, base, 0.2 * height, 0.015);
    if (kind == 1) {
        kit_turned(b, urn, 4, 24);
        return;
    }
    kit_place_at(b, 0, base + (kind == 2 ? 0.34 : 0.28) * s, 0, 0);
    kit_cushion(b, kind == 2 ? ball : hips, kind == 2 ? 1 : 0.6, 14);
    if (kind == 2) return;
    kit_place_at(b, 0, base + 0.6 * s, 0, 0);
    kit_cushion(b, chest, 0.8, 12);
    kit_place_at(b, 0, base + 0.88 * s, 0.01 * s, 0);
    kit_cushion(b, head, 1, 12);
    kit_place_at(b, 0, 0, 0, 0);
    kit_tube(b, arms, 5, 0.045 * s, 9);
}

void garden_put_fountain(kit_build *b, double radius)
{
    const double r = radius, in = r - 0.16, bowl = 0.45 * r;
    const kit_moulding basin[] = { { r, -0.1, r, 0.42, 0.03 },
                                   { r, 0.42, r + 0.04, 0.5, 0 },
                                   { r + 0.04, 0.5, in, 0.5, 0 },
                                   { in, 0.5, in, 0.05, 0 } };
    const kit_moulding stem[] = { { 0.2, 0.2, 0.1, 0.7, 0.03 },    { 0.1, 0.7, 0.1, 1.0, -0.02 },
                                  { 0.1, 1.0, bowl, 1.25, -0.06 }, { bowl, 1.25, 0.05, 1.18, 0 },
                                  { 0.07, 1.17, 0.05, 1.5, 0.03 }, { 0.05, 1.5, 0, 1.62, 0.05 } };
    const kit_moulding water[] = { { in, 0.36, 0, 0.36, 0 } };
    KIT_TINT(b, stones, 0.1);
    kit_turned(b, basin, 4, 36);
    kit_turned(b, stem, 6, 24);
    kit_colour(b, 0.12, 0.2, 0.2);
    kit_turned(b, water, 1, 36);
}

/* ---- >>furniture ----------------------------------------------------------------------------------------------- */

void garden_put_pergola(kit_build *b, double x, double height, double z)
{
    const int posts = (int)(x / 2.4) + 1;
    KIT_TINT(b, woods, 0.15);
    for (int k = 0; k <= posts; k++)
        for (int side = -1; side < 2; side += 2) {
            const double px = -x / 2 + x * k / posts, pz = side * z / 2;
            kit_bevelled(b, px - 0.06, -0.1, pz - 0.06, px + 0.06, height, pz + 0.06, 0.01);
        }
    for (int side = -1; side < 2; side += 2)
        kit_box(b, -x / 2 - 0.3, height + KIT_GAP, side * z / 2 - 0.04, x / 2 + 0.3, height + 0.14,
                side * z / 2 + 0.04);
    for (double at = -x / 2 - 0.2; at < x / 2 + 0.25; at += 0.45)
        kit_box(b, at, height + 0.141, -z / 2 - 0.35, at + 0.05, height + 0.27, z / 2 + 0.35);
}

static void chair(kit_build *b)
{
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? 0.19 : -0.19, z = k & 2 ? 0.19 : -0.19;
        const double leg[3][3] = { { 1.1 * x, 0, 1.15 * z },
                                   { x, 0.44, z },
                                   { x, z < 0 ? 0.88 : 0.445, z < 0 ? 1.25 * z : z } };
        kit_tube(b, leg, 3, 0.013, 6);
    }
    for (int k = 0; k < 5; k++) kit_box(b, -0.21, 0.44, -0.2 + 0.084 * k, 0.21, 0.455, -0.13 + 0.084 * k);
    for (int k = 0; k < 3; k++) kit_box(b, -0.2, 0.58 + 0.11 * k, -0.235, 0.2, 0.65 + 0.11 * k, -0.22);
}

void garden_put_table(kit_build *b, int chairs)
{
    const double r = kit_between(b, 0.38, 0.6), cup[2] = { kit_between(b, -0.2, 0.2), kit_between(b, -0.2, 0.2) };
    const kit_moulding top[] = { { 0, 0.7, r, 0.7, 0 }, { r, 0.7, r, 0.73, 0.004 }, { r, 0.73, 0, 0.73, 0 } };
    const double half[3] = { 0.05, 0.05, 0.05 };
    KIT_TINT(b, woods, 0.1);
    kit_turned(b, top, 3, 28);
    for (int k = 0; k < 3; k++) {
        const double a = 2.0944 * k, leg[4][3] = { { 0.75 * r * cos(a), 0, 0.75 * r * sin(a) },
                                                   { 0.2 * r * cos(a), 0.35, 0.2 * r * sin(a) },
                                                   { 0.3 * r * cos(a), 0.55, 0.3 * r * sin(a) },
                                                   { 0.7 * r * cos(a), 0.7, 0.7 * r * sin(a) } };
        kit_tube(b, leg, 4, 0.014, 7);
    }
    for (int k = 0; k < chairs; k++) {
        const double a = 6.2832 * k / chairs + kit_between(b, -0.2, 0.2), away = r + kit_between(b, 0.15, 0.45);
        const kit_frame before = kit_enter(b, away * sin(a), 0, away * cos(a),
                                           57.29578 * a + 180 + kit_between(b, -15, 15), 1);
        chair(b);
        kit_leave(b, before);
    }
    KIT_TINT(b, clays, 0.2);
    kit_place_at(b, cup[0], 0.731 + half[1], cup[1], 0);
    kit_cushion(b, half, 0.5, 10);
    kit_place_at(b, 0, 0, 0, 0);
}

/* cloth on ribs: sheets that sag between them */
void garden_put_parasol(kit_build *b, double height)
{
    static const float cloths[][3] = {
        { 0.75f, 0.70f, 0.60f }, { 0.6f, 0.14f, 0.12f }, { 0.2f, 0.36f, 0.3f }, { 0.75f, 0.55f, 0.2f }
    };

    enum { RIBS = 8 };

    const double pole[2][3] = { { 0, 0, 0 }, { 0, height, 0 } }, r = kit_between(b, 1.1, 1.6), low = height - 0.45;
    kit_colour(b, 0.6, 0.6, 0.58);
    kit_tube(b, pole, 2, 0.02, 9);
    kit_cylinder(b, 0.25, 0.08, 20);
    KIT_TINT(b, cloths, 0.1);
    for (int k = 0; k < RIBS; k++) {
        const double a = 0.785398 * k, c = a + 0.785398, m = a + 0.392699;
        const double half[4][3] = { { 0, height - 0.05, 0 },
                                    { r * cos(c), low, r * sin(c) },
                                    { 0.93 * r * cos(m), low - 0.02, 0.93 * r * sin(m) },
                                    { r * cos(a), low, r * sin(a) } };
        const double rib[2][3] = { { 0, height - 0.07, 0 }, { r * cos(a), low - 0.02, r * sin(a) } };
        const double hem[4][3] = { { r * cos(a), low, r * sin(a) },
                                   { r * cos(c), low, r * sin(c) },
                                   { r * cos(c), low - 0.15, r * sin(c) },
                                   { r * cos(a), low - 0.15, r * sin(a) } };
        kit_quad(b, half);
        kit_quad(b, hem);
        kit_tube(b, rib, 2, 0.007, 5);
    }
}

void garden_put_lamp_post(kit_build *b, double height)
{
    const double h = height;
    const kit_moulding post[] = { { 0.13, -0.05, 0.12, 0.3, 0.02 },
                                  { 0.12, 0.3, 0.05, 0.5, -0.02 },
                                  { 0.05, 0.5, 0.035, h - 0.5, 0 },
                                  { 0.035, h - 0.5, 0.1, h - 0.42, 0 } };
    const kit_moulding glass[] = { { 0.08, h - 0.42, 0.15, h - 0.1, 0 } };
    const kit_moulding hat[] = { { 0.2, h - 0.1, 0.03, h + 0.05, -0.02 }, { 0.03, h + 0.05, 0, h + 0.14, 0 } };
    kit_colour(b, 0.1, 0.12, 0.11);
    kit_turned(b, post, 4, 12);
    kit_turned(b, hat, 2, 12);
    kit_colour(b, 0.85, 0.82, 0.72);
    kit_turned(b, glass, 1, 8);
}

/* of stone, as in Japanese gardens */
void garden_put_lantern(kit_build *b, double height)
{
    const double h = height;
    const kit_moulding parts[] = { { 0.24 * h, -0.05, 0.2 * h, 0.08 * h, 0 },
                                   { 0.2 * h, 0.08 * h, 0.07 * h, 0.12 * h, 0 },
                                   { 0.07 * h, 0.12 * h, 0.07 * h, 0.5 * h, -0.01 * h },
                                   { 0.07 * h, 0.5 * h, 0.19 * h, 0.56 * h, 0 },
                                   { 0.19 * h, 0.56 * h, 0.19 * h, 0.6 * h, 0 },
                                   { 0.19 * h, 0.6 * h, 0, 0.6 * h, 0 },
                                   { 0.3 * h, 0.78 * h, 0.28 * h, 0.82 * h, 0 },
                                   { 0.28 * h, 0.82 * h, 0.05 * h, 0.93 * h, -0.02 * h },
                                   { 0.05 * h, 0.93 * h, 0, h, 0.02 * h },
                                   { 0, 0.78 * h, 0.3 * h, 0.78 * h, 0 } };
    KIT_TINT(b, stones, 0.12);
    kit_turned(b, parts, 10, 6);
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? 0.11 * h : -0.11 * h, z = k & 2 ? 0.11 * h : -0.11 * h, s = 0.03 * h;
        kit_box(b, x - s, 0.6 * h, z - s, x + s, 0.785 * h, z + s);
    }
}

void garden_put_ladder(kit_build *b, double length)
{
    const double tilt = 14;
    KIT_TINT(b, woods, 0.15);
    kit_place_tilted(b, 0, -0.02, 0, 0, tilt);
    for (int side = -1; side < 2; side += 2)
        kit_box(b, side * 0.22 - 0.02, 0, -0.025, side * 0.22 + 0.02, length, 0.025);
    for (double y = 0.25; y < length - 0.1; y += 0.3) {
        const double rung[2][3] = { { -0.2, y, 0 }, { 0.2, y, 0 } };
        kit_tube(b, rung, 2, 0.015, 7);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

void garden_put_barrow(kit_build *b)
{
    static const double ring[2] = { 0.17, 0.035 };
    const double tub[5][4][3] = {
        { { -0.25, 0.3, -0.3 }, { -0.25, 0.3, 0.35 }, { 0.25, 0.3, 0.35 }, { 0.25, 0.3, -0.3 } },
        { { -0.25, 0.3, -0.3 }, { 0.25, 0.3, -0.3 }, { 0.34, 0.6, -0.45 }, { -0.34, 0.6, -0.45 } },
        { { 0.25, 0.3, 0.35 }, { -0.25, 0.3, 0.35 }, { -0.34, 0.6, 0.65 }, { 0.34, 0.6, 0.65 } },
        { { 0.25, 0.3, -0.3 }, { 0.25, 0.3, 0.35 }, { 0.34, 0.6, 0.65 }, { 0.34, 0.6, -0.45 } },
        { { -0.25, 0.3, 0.35 }, { -0.25, 0.3, -0.3 }, { -0.34, 0.6, -0.45 }, { -0.34, 0.6, 0.65 } }
    };
    kit_colour(b, 0.2, 0.36, 0.24);
    for (int k = 0; k < 5; k++) kit_quad(b, tub[k]);
    kit_colour(b, 0.3, 0.3, 0.32);
    for (int side = -1; side < 2; side += 2) {
        const double x = 0.2 * side, frame[4][3] = {
            { 0.2 * x, 0.2, 0.8 }, { x, 0.28, 0.3 }, { 1.1 * x, 0.3, -0.4 }, { 1.5 * x, 0.55, -1.05 }
        };
        const double leg[3][3] = { { x, 0.28, -0.2 }, { 1.1 * x, 0, -0.35 }, { 1.1 * x, 0.29, -0.42 } };
        kit_tube(b, frame, 4, 0.016, 7);
        kit_tube(b, leg, 3, 0.014, 7);
    }
    kit_place_tilted(b, 0, 0.2, 0.8, 90, 90);
    kit_colour(b, 0.06, 0.06, 0.06);
    kit_patch(b, 24, 10, kit_torus_surface, ring);
    kit_place_at(b, 0, 0, 0, 0);
}

void garden_put_crate(kit_build *b)
{
    static const float fruit[][3] = { { 0.6f, 0.12f, 0.08f }, { 0.62f, 0.52f, 0.14f }, { 0.4f, 0.5f, 0.14f } };
    const double ball[3] = { 0.04, 0.038, 0.04 };
    KIT_TINT(b, woods, 0.15);
    kit_box(b, -0.25, 0, -0.17, 0.25, 0.012, 0.17);
    for (int k = 0; k < 3; k++)
        for (int side = -1; side < 2; side += 2) {
            const double y = 0.03 + 0.085 * k, z = side * 0.18, x = side * 0.258;
            kit_box(b, -0.25, y, z - 0.007, 0.25, y + 0.065, z + 0.007);
            kit_box(b, x - 0.007, y, -0.187, x + 0.007, y + 0.065, 0.187);
        }
    const int full = kit_odds(b, 0.7) ? 30 : 0;
    for (int k = 0; k < full; k++) {
        KIT_TINT(b, fruit, 0.15);
        kit_place_at(b, -0.2 + 0.082 * (k % 6) + kit_between(b, -0.01, 0.01), kit_between(b, 0.16, 0.2),
                     -0.13 + 0.065 * (k / 6 % 5), 0);
        kit_cushion(b, ball, 1, 7);
    }
    kit_place_at(b, 0, 0, 0, 0);
}
