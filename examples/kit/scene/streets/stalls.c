/* stalls.c - what lives in streets and squares: trees, pots, people, stalls, café tables, crates, fountains, statues,
   heaps. Declared in streets.h. */
#include "kit/scene/streets/streets.h"
#include <math.h>
#include <string.h>

static void ball(kit_build *b, double x, double y, double z, double radius, int cells)
{
    kit_place_at(b, x, y, z, 0);
    kit_patch(b, 2 * cells, cells, kit_sphere_surface, &radius);
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>green --------------------------------------------------------------------------------------------------- */

typedef struct crown {
    double at[3], r[3];
    int leaves;
} crown;

/* cards all through a ball, most of them near its skin */
static void leaves(kit_build *b, const crown *c, double size)
{
    const double green = kit_between(b, 0.8, 1.2), dry = kit_odds(b, 0.15) ? 1 : kit_between(b, 0, 0.3);
    for (int k = 0; k < c->leaves; k++) {
        const double y = kit_between(b, -1, 1), a = kit_between(b, 0, 2 * KIT_PI), r = sqrt(1 - y * y),
                     out = pow(kit_chance(b), 0.4);
        const double shade = green * (0.55 + 0.45 * out) * kit_between(b, 0.8, 1.15);
        kit_colour(b, shade * (0.13 + 0.3 * dry), shade * (0.27 - 0.06 * dry), shade * 0.06);
        kit_place_tilted(b, c->at[0] + c->r[0] * out * r * cos(a), c->at[1] + c->r[1] * out * y,
                         c->at[2] + c->r[2] * out * r * sin(a), kit_between(b, 0, 360), kit_between(b, -70, 70));
        kit_leaf(b, size * kit_between(b, 0.5, 1), size * kit_between(b, 0.8, 1.4), kit_between(b, 0, 1.2), 3, 1);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* A branch that divides; bare twigs at the end. */
static void branch(kit_build *b, const double from[3], const double way[3], double length, double radius, int deep)
{
    double at[4][3];
    memcpy(at[0], from, sizeof at[0]);
    for (int k = 1; k < 4; k++)
        for (int i = 0; i < 3; i++)
            at[k][i] = at[k - 1][i] + length / 3 * way[i] + (i == 1 ? 0.02 : kit_between(b, -0.06, 0.06)) * length;
    kit_tube(b, (const double(*)[3])at, 4, radius, deep > 1 ? 7 : 4);
    for (int k = 0; k < 3 && deep > 0; k++) {
        double on[3] = { way[0] + kit_between(b, -0.8, 0.8), way[1] + kit_between(b, -0.1, 0.4),
                         way[2] + kit_between(b, -0.8, 0.8) };
        kit_unit(on);
        branch(b, at[k ? 3 : 2], on, length * kit_between(b, 0.6, 0.8), 0.6 * radius, deep - 1);
    }
}

static void palm(kit_build *b, double height)
{
    double trunk[6][3];
    for (int k = 0; k < 6; k++) {
        trunk[k][0] = 0.03 * k * k * height / 10;
        trunk[k][1] = height * k / 5;
        trunk[k][2] = 0;
    }
    kit_colour(b, 0.36, 0.29, 0.2);
    kit_tube(b, (const double(*)[3])trunk, 6, 0.16, 10);
    for (int k = 0; k < 26; k++) {
        kit_colour(b, 0.14, kit_between(b, 0.24, 0.32), 0.07);
        kit_place_tilted(b, trunk[5][0], height - 0.1, 0, kit_between(b, 0, 360), kit_between(b, -75, 5));
        kit_leaf(b, 0.5, kit_between(b, 1.8, 2.8), kit_between(b, 0.8, 1.6), 8, 1);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_town_street_tree(kit_build *b, double height)
{
    const double up[3] = { 0, 1, 0 }, foot[3] = { 0, -0.05, 0 }, crown_low = kit_between(b, 0.3, 0.45) * height;
    const int kind = kit_choose(b, 6);
    if (kind == 5) {
        palm(b, height);
        return;
    }
    kit_colour(b, kit_between(b, 0.22, 0.34), 0.23, 0.17);
    branch(b, foot, up, crown_low, 0.025 * height, kind == 4 ? 4 : 2);
    if (kind == 4) return; /* winter */
    const double wide = kind == 3 ? 0.14 : kit_between(b, 0.22, 0.34), middle = 0.5 * (height + crown_low);
    if (kind == 3) { /* slender */
        const crown c = { { 0, middle, 0 }, { wide * height, 0.55 * (height - crown_low) + 0.3, wide * height }, 450 };
        leaves(b, &c, 0.3);
        return;
    }
    for (int k = 0; k < 5; k++) {
        const double a = kit_between(b, 0, 2 * KIT_PI), off = k ? 0.55 * wide * height : 0,
                     r = wide * height * (k ? 0.6 : 0.9);
        const crown c = { { off * cos(a), middle + kit_between(b, -0.12, 0.25) * height, off * sin(a) },
                          { r, 0.7 * r, r },
                          k ? 90 : 220 };
        leaves(b, &c, 0.035 * height + 0.08);
    }
}

void kit_town_shrub(kit_build *b, double size)
{
    const double up[3] = { 0, 1, 0 }, foot[3] = { 0, 0, 0 };
    const crown c = { { 0, 0.6 * size, 0 }, { 0.55 * size, 0.5 * size, 0.55 * size }, 160 };
    kit_colour(b, 0.25, 0.2, 0.15);
    branch(b, foot, up, 0.3 * size, 0.02 * size, 1);
    leaves(b, &c, 0.18 * size);
}

void kit_town_pot(kit_build *b)
{
    static const kit_moulding pot[] = { { 0, 0, 0.13, 0, 0 },          { 0.13, 0, 0.2, 0.3, 0 },
                                        { 0.2, 0.3, 0.22, 0.3, 0 },    { 0.22, 0.3, 0.22, 0.36, 0 },
                                        { 0.22, 0.36, 0.18, 0.36, 0 }, { 0.18, 0.36, 0.17, 0.3, 0 },
                                        { 0.17, 0.3, 0, 0.31, 0 } };
    const crown c = { { 0, kit_between(b, 0.5, 0.75), 0 }, { 0.24, 0.27, 0.24 }, 45 };
    kit_colour(b, 0.5, kit_between(b, 0.24, 0.4), 0.2);
    kit_turned(b, pot, 7, 16);
    leaves(b, &c, 0.16);
}

/* ---- >>people -------------------------------------------------------------------------------------------------- */

static void limb(kit_build *b, const double at[3][3], double radius) { kit_tube(b, at, 3, radius, 8); }

static void cloth_colour(kit_build *b, int stone)
{
    static const float clothes[][3] = { { 0.12f, 0.14f, 0.22f }, { 0.5f, 0.12f, 0.1f },  { 0.6f, 0.56f, 0.46f },
                                        { 0.15f, 0.15f, 0.15f }, { 0.2f, 0.32f, 0.26f }, { 0.7f, 0.68f, 0.66f },
                                        { 0.6f, 0.44f, 0.16f } };
    if (!stone) KIT_TINT(b, clothes, 0.2);
}

void kit_town_person(kit_build *b, int stone)
{
    const double stride = kit_between(b, -0.25, 0.25), swing = kit_between(b, -0.3, 0.3),
                 tall = kit_between(b, 0.92, 1.06);
    const kit_frame was = kit_enter(b, 0, 0, 0, 0, tall);
    const double torso[3] = { 0.2, 0.32, 0.13 };
    const int skirt = kit_odds(b, 0.35);
    cloth_colour(b, stone);
    for (int k = -1; k <= 1; k += 2) {
        const double leg[3][3] = { { 0.1 * k, 0.86, 0 },
                                   { 0.1 * k, 0.46, 0.5 * stride * k + 0.04 },
                                   { 0.1 * k, 0.04, stride * k } };
        limb(b, leg, 0.075);
        kit_place_at(b, 0.1 * k, 0.05, stride * k + 0.06, 0);
        const double shoe[3] = { 0.05, 0.05, 0.13 };
        kit_cushion(b, shoe, 0.6, 5);
        kit_place_at(b, 0, 0, 0, 0);
    }
    cloth_colour(b, stone);
    kit_place_at(b, 0, 1.16, 0, 0);
    kit_cushion(b, torso, 0.65, 8);
    kit_place_at(b, 0, 0, 0, 0);
    if (skirt) {
        static const kit_moulding gown[] = { { 0.34, 0.4, 0.17, 1, 0.03 } };
        kit_turned(b, gown, 1, 18);
    }
    for (int k = -1; k <= 1; k += 2) {
        const double arm[3][3] = { { 0.2 * k, 1.42, 0 },
                                   { 0.27 * k, 1.14, swing * k },
                                   { 0.24 * k, 0.9, swing * k + 0.14 } };
        limb(b, arm, 0.05);
        if (k > 0 && !stone && kit_odds(b, 0.4)) kit_box(b, 0.2, 0.5, swing, 0.28, 0.85, swing + 0.3);
    }
    if (!stone) kit_colour(b, kit_between(b, 0.3, 0.6), 0.35, 0.26);
    ball(b, 0, 1.63, 0.01, 0.11, 7);
    if (!stone) kit_colour(b, kit_between(b, 0.05, 0.4), 0.1, 0.06);
    ball(b, 0, 1.67, -0.025, 0.112, 6);
    kit_leave(b, was);
}

/* ---- >>stalls -------------------------------------------------------------------------------------------------- */

/* A cloth over a table: half of its sides, how far it hangs down. */
static void table_cloth(kit_build *b, double hx, double hz, double top, double hang)
{
    const double y = top + 0.006, c[4][3] = { { -hx, y, hz }, { hx, y, hz }, { hx, y, -hz }, { -hx, y, -hz } };
    kit_quad(b, c);
    for (int k = 0; k < 4; k++) {
        const double *p = c[k], *q = c[(k + 1) % 4];
        const double side[4][3] = { { 1.02 * p[0], y - hang, 1.03 * p[2] },
                                    { 1.02 * q[0], y - hang, 1.03 * q[2] },
                                    { q[0], y, q[2] },
                                    { p[0], y, p[2] } };
        kit_quad(b, side);
    }
}

static void crate(kit_build *b, double x, double y, double z, int full)
{
    static const float fruit[][3] = {
        { 0.7f, 0.3f, 0.06f }, { 0.55f, 0.08f, 0.06f }, { 0.3f, 0.42f, 0.1f }, { 0.72f, 0.6f, 0.12f }
    };
    const kit_frame was = kit_enter(b, x, y, z, kit_between(b, -6, 6), 1);
    kit_colour(b, 0.52, 0.4, 0.25);
    kit_box(b, -0.28, 0, -0.19, 0.28, 0.015, 0.19);
    for (int k = 0; k < 3; k++) {
        const double low = 0.02 + 0.075 * k;
        kit_box(b, -0.28, low, 0.175, 0.28, low + 0.055, 0.19);
        kit_box(b, -0.28, low, -0.19, 0.28, low + 0.055, -0.175);
        kit_box(b, -0.28, low, -0.174, -0.265, low + 0.055, 0.174);
        kit_box(b, 0.265, low, -0.174, 0.28, low + 0.055, 0.174);
    }
    KIT_TINT(b, fruit, 0.2);
    for (int k = 0; k < 20 && full; k++)
        ball(b, -0.2 + 0.1 * (k % 5) + kit_between(b, -0.015, 0.015), 0.17 + kit_between(b, 0, 0.05),
             -0.13 + 0.087 * (k / 5), 0.055, 4);
    kit_leave(b, was);
}

void kit_town_crates(kit_build *b)
{
    const int count = 3 + kit_choose(b, 7);
    for (int k = 0; k < count; k++)
        crate(b, 0.62 * (k % 3), 0.245 * (k / 3), kit_between(b, -0.03, 0.03), k + 3 >= count && kit_odds(b, 0.5));
}

/* s[0], s[1]: half sides; rises to its middle by s[2], sags between its edges by s[3] */
static double canopy_at(const double *s, double x, double z)
{
    return s[2] * (1 - fabs(x) / s[0]) - s[3] * (1 - z * z / (s[1] * s[1]));
}

static void canopy_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, x = s[0] * (2 * u - 1), z = s[1] * (1 - 2 * v);
    out->p[0] = x;
    out->p[1] = canopy_at(s, x, z);
    out->p[2] = z;
    out->n[0] = x < 0 || (u < 0.5 && !(x > 0)) ? -s[2] / s[0] : s[2] / s[0];
    out->n[1] = 1;
    out->n[2] = -2 * s[3] * z / (s[1] * s[1]);
    kit_unit(out->n);
}

void kit_town_stall(kit_build *b)
{
    static const float roofs[][3] = { { 0.6f, 0.12f, 0.1f },
                                      { 0.78f, 0.75f, 0.68f },
                                      { 0.12f, 0.3f, 0.22f },
                                      { 0.16f, 0.24f, 0.5f },
                                      { 0.72f, 0.52f, 0.14f } };
    const double hx = kit_between(b, 1.1, 1.6), hz = kit_between(b, 0.8, 1.1),
                 roof[4] = { hx + 0.15, hz + 0.15, kit_between(b, 0.2, 0.6), 0.12 };
    kit_colour(b, 0.4, 0.4, 0.38);
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? hx : -hx, z = k & 2 ? hz : -hz, post[2][3] = { { x, 0, z }, { x, 2.2, z } };
        kit_tube(b, post, 2, 0.025, 6);
    }
    KIT_TINT(b, roofs, 0.1);
    kit_place_at(b, 0, 2.22, 0, 0);
    kit_patch(b, 14, 6, canopy_surface, roof);
    for (int k = -1; k <= 1; k += 2) { /* the valance */
        const double z = k * roof[1], y = 0.005;
        for (int n = 0; n < 10; n++) {
            const double x0 = roof[0] * (0.2 * n - 1), x1 = x0 + 0.2 * roof[0], y0 = canopy_at(roof, x0, z) + y,
                         y1 = canopy_at(roof, x1, z) + y;
            const double flap[4][3] = { { x0 + 0.02, y0 - 0.25, z + 0.02 * k },
                                        { x1 - 0.02, y1 - 0.25, z + 0.02 * k },
                                        { x1, y1, z },
                                        { x0, y0, z } };
            kit_quad(b, flap);
        }
    }
    kit_colour(b, 0.5, 0.38, 0.24);
    kit_place_at(b, 0, 0, 0, 0);
    kit_box(b, -hx + 0.06, 0.8, 0, hx - 0.06, 0.84, hz - 0.05);
    for (int k = 0; k < 4; k++)
        kit_box(b, k & 1 ? hx - 0.15 : -hx + 0.1, 0, k & 2 ? hz - 0.12 : 0.05, k & 1 ? hx - 0.1 : -hx + 0.15, 0.799,
                k & 2 ? hz - 0.07 : 0.1);
    KIT_TINT(b, roofs, 0.2);
    kit_place_at(b, 0, 0, 0.5 * hz, 0);
    if (kit_odds(b, 0.6)) table_cloth(b, hx - 0.04, 0.5 * hz, 0.84, kit_between(b, 0.15, 0.7));
    kit_place_at(b, 0, 0, 0, 0);
    for (double x = -hx + 0.4; x < hx - 0.25; x += 0.62)
        if (kit_odds(b, 0.85)) crate(b, x, 0.85, 0.5 * hz, 1);
    for (double x = -hx + 0.4; x < hx - 0.25; x += 0.7)
        if (kit_odds(b, 0.6)) crate(b, x, 0, -0.5 * hz, kit_odds(b, 0.3));
}

static void chair(kit_build *b)
{
    static const double half[3] = { 0.2, 0.02, 0.2 };
    kit_place_at(b, 0, 0.45, 0, 0);
    kit_cushion(b, half, 0.4, 6);
    kit_place_at(b, 0, 0, 0, 0);
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? 0.17 : -0.17, z = k & 2 ? 0.17 : -0.17;
        const double leg[2][3] = { { 1.15 * x, 0, 1.15 * z }, { x, z < 0 ? 0.88 : 0.44, z < 0 ? z - 0.06 : z } };
        kit_tube(b, leg, 2, 0.013, 5);
    }
    for (int k = 0; k < 3; k++) kit_box(b, -0.18, 0.6 + 0.1 * k, -0.225, 0.18, 0.65 + 0.1 * k, -0.205);
}

/* A table, chairs round it, perhaps a parasol. */
void kit_town_cafe(kit_build *b)
{
    static const float parasols[][3] = { { 0.78f, 0.74f, 0.64f }, { 0.5f, 0.1f, 0.1f }, { 0.14f, 0.3f, 0.24f } };
    static const kit_moulding shade[] = { { 1.35, 2.1, 0.05, 2.6, 0.04 }, { 1.37, 1.93, 1.35, 2.1, 0 } };
    const int chairs = 2 + kit_choose(b, 3);
    const double start = kit_between(b, 0, 360);
    kit_colour(b, 0.5, 0.48, 0.45);
    kit_place_at(b, 0, 0.72, 0, 0);
    kit_cylinder(b, 0.36, 0.025, 24);
    kit_place_at(b, 0, 0, 0, 0);
    kit_cylinder(b, 0.03, 0.719, 8);
    kit_cylinder(b, 0.22, 0.02, 16);
    kit_colour(b, 0.8, 0.8, 0.78);
    for (int k = 0; k < 2; k++) {
        kit_place_at(b, 0.16 - 0.3 * k, 0.746, 0.1, 0);
        kit_cylinder(b, 0.04, 0.08, 10);
    }
    kit_colour(b, 0.3, kit_between(b, 0.2, 0.4), 0.2);
    for (int k = 0; k < chairs; k++) {
        const double a = start + 360.0 * k / chairs + kit_between(b, -15, 15), r = kit_between(b, 0.55, 0.75),
                     t = a * KIT_PI / 180;
        const kit_frame was = kit_enter(b, r * sin(t), 0, r * cos(t), a + 180, 1);
        chair(b);
        kit_leave(b, was);
    }
    if (!kit_odds(b, 0.55)) return;
    KIT_TINT(b, parasols, 0.1);
    kit_turned(b, shade, 2, 8);
    kit_colour(b, 0.5, 0.42, 0.3);
    kit_cylinder(b, 0.022, 2.62, 8);
}

/* ---- >>stone --------------------------------------------------------------------------------------------------- */

void kit_town_fountain(kit_build *b)
{
    static const kit_moulding stone[] = { { 2.3, 0, 2.3, 0.15, 0 },        { 2.3, 0.15, 2.05, 0.15, 0 },
                                          { 2.05, 0.15, 2.0, 0.5, -0.05 }, { 2.0, 0.5, 2.1, 0.62, 0.02 },
                                          { 2.1, 0.62, 1.8, 0.62, 0.01 },  { 1.8, 0.62, 1.8, 0.3, 0 },
                                          { 1.8, 0.3, 0.4, 0.3, 0 },       { 0.4, 0.3, 0.25, 0.6, -0.04 },
                                          { 0.25, 0.6, 0.2, 1.3, 0.03 },   { 0.2, 1.3, 0.95, 1.65, -0.1 },
                                          { 0.95, 1.65, 0.9, 1.68, 0 },    { 0.9, 1.68, 0.15, 1.5, 0.08 },
                                          { 0.15, 1.5, 0.12, 2, 0.03 },    { 0.12, 2, 0.42, 2.2, -0.05 },
                                          { 0.42, 2.2, 0.1, 2.15, 0.03 },  { 0.1, 2.15, 0, 2.5, 0.06 } };
    kit_colour(b, 0.6, 0.58, 0.52);
    kit_turned(b, stone, (int)(sizeof stone / sizeof *stone), 48);
    kit_colour(b, 0.15, 0.25, 0.26);
    kit_place_at(b, 0, 0.48, 0, 0);
    kit_cylinder(b, 1.795, 0.004, 48);
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_town_monument(kit_build *b)
{
    const double high = kit_between(b, 1.2, 3);
    kit_colour(b, 0.56, 0.54, 0.5);
    for (int k = 0; k < 3; k++)
        kit_box(b, -1.8 + 0.35 * k, 0.18 * k - 0.01, -1.8 + 0.35 * k, 1.8 - 0.35 * k, 0.18 * k + 0.18, 1.8 - 0.35 * k);
    kit_bevelled(b, -0.75, 0.539, -0.75, 0.75, 0.54 + high, 0.75, 0.06);
    kit_bevelled(b, -0.9, 0.54 + high + KIT_GAP, -0.9, 0.9, 0.74 + high, 0.9, 0.05);
    kit_box(b, -0.5, 0.9, 0.74, 0.5, 0.4 + high, 0.77);
    kit_colour(b, 0.2, 0.32, 0.26);
    const kit_frame was = kit_enter(b, 0, 0.741 + high, 0, kit_between(b, -40, 40), 1.5);
    kit_town_person(b, 1);
    kit_leave(b, was);
}

/* ---- >>goods --------------------------------------------------------------------------------------------------- */

typedef struct pile {
    double size;
    unsigned seed;
} pile;

static double pile_height(const void *of, double x, double z)
{
    const pile *h = of;
    const double r = hypot(x, z) / h->size, rough = kit_fractal(h->seed, 2.5 * x / h->size, 0, 2.5 * z / h->size, 4);
    return h->size * (0.55 * fmax(0, 1 - r) + 0.07 * rough * (1.1 - r)) - 0.02;
}

/* of sand or earth */
void kit_town_heap(kit_build *b, double size)
{
    const pile h = { size, (unsigned)kit_choose(b, 1000) };
    const double around[4] = { -1.1 * size, -1.1 * size, 1.1 * size, 1.1 * size };
    kit_colour(b, 0.5, 0.42, 0.3);
    kit_height_field(b, around, 24, 24, pile_height, &h);
}

/* with bricks, sacks or pipes on it */
void kit_town_pallet(kit_build *b)
{
    const int kind = kit_choose(b, 3);
    kit_colour(b, 0.5, 0.4, 0.27);
    for (int k = 0; k < 3; k++) kit_box(b, -0.6, 0, -0.4 + 0.36 * k, 0.6, 0.09, -0.32 + 0.36 * k);
    for (int k = 0; k < 7; k++) kit_box(b, -0.6 + 0.18 * k, 0.09 + KIT_GAP, -0.4, -0.48 + 0.18 * k, 0.115, 0.4);
    if (kind == 0) kit_colour(b, 0.46, 0.22, 0.15);
    for (int k = 0; k < 60 && kind == 0; k++) {
        const double x = -0.55 + 0.22 * (k % 5), y = 0.117 + 0.07 * (k / 15),
                     z = -0.38 + 0.25 * (k / 5 % 3) + kit_between(b, 0, 0.02);
        kit_box(b, x, y, z, x + 0.21, y + 0.066, z + 0.235);
    }
    for (int k = 0; k < 8 && kind == 1; k++) {
        static const double half[3] = { 0.29, 0.09, 0.19 };
        kit_colour(b, 0.62, 0.58, 0.5);
        kit_place_at(b, (k & 1 ? 0.29 : -0.29), 0.2 + 0.165 * (k / 4), (k & 2 ? 0.2 : -0.2), kit_between(b, -5, 5));
        kit_cushion(b, half, 0.5, 8);
        kit_place_at(b, 0, 0, 0, 0);
    }
    for (int k = 0; k < 9 && kind == 2; k++) {
        const double y = 0.17 + 0.1 * (k / 4), z = -0.24 + 0.13 * (k % 4) + 0.06 * (k / 4),
                     pipe[2][3] = { { -1.2, y, z }, { 1.2, y, z } };
        kit_colour(b, 0.5, 0.28, 0.2);
        kit_tube(b, pipe, 2, 0.055, 10);
    }
}
