/* fences.c - what people put among plants in scenes by seed: stones, logs, benches, fences, walls. Declared in
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

/* ---- >>found --------------------------------------------------------------------------------------------------- */

void garden_put_stone(kit_build *b, const double half[3], int cells)
{
    const kit_lump s = { { half[0], half[1], half[2] }, (unsigned)kit_choose(b, 100000), 0.28, 1.3, 4 };
    KIT_TINT(b, stones, 0.15);
    kit_place_at(b, 0, 0.45 * half[1], 0, 0);
    kit_patch(b, 2 * cells, cells, garden_lump_surface, &s);
    kit_place_at(b, 0, 0, 0, 0);
}

void garden_put_log(kit_build *b, double length, double radius)
{
    enum { POINTS = 7 };

    const double from[3] = { -length / 2, 0.85 * radius, 0 };
    double at[POINTS][3], way[3] = { 1, 0, 0 };
    garden_wander(b, from, way, length, 0.12, 0, at, POINTS);
    for (int k = 0; k < POINTS; k++) at[k][1] = 0.85 * radius;
    kit_colour(b, 0.28, 0.22, 0.16);
    kit_tube(b, (const double(*)[3])at, POINTS, radius, 14);
    for (int k = 0; k < 3; k++) { /* stumps of branches */
        const double a = kit_between(b, 0.2, 2.9), out[3] = { 0.3, sin(a), cos(a) };
        const double *mid = at[1 + k], stub = radius * kit_between(b, 1.3, 2.5);
        const double end[2][3] = { { mid[0], mid[1], mid[2] },
                                   { mid[0] + stub * out[0], mid[1] + stub * out[1], mid[2] + stub * out[2] } };
        kit_tube(b, end, 2, 0.25 * radius, 7);
    }
}

void garden_put_stump(kit_build *b, double radius)
{
    const double h = radius * kit_between(b, 0.8, 2),
                 at[5][3] = { { 0, -0.1, 0 }, { 0, 0.2 * h, 0 }, { 0, 0.5 * h, 0 }, { 0.02, 0.8 * h, 0 }, { 0, h, 0 } };
    const kit_moulding top[] = { { radius, h, 0, h, 0 } };
    kit_colour(b, 0.27, 0.21, 0.15);
    garden_grow_limb(b, &(kit_limb){ at, 5, radius, radius, 0.6 * radius, 0.35, 20, 0 });
    kit_colour(b, 0.58, 0.46, 0.31);
    kit_turned(b, top, 1, 20);
}

/* ---- >>wood ---------------------------------------------------------------------------------------------------- */

void garden_put_bench(kit_build *b, int kind)
{
    const double half = kit_between(b, 0.6, 0.95);
    KIT_TINT(b, woods, 0.15);
    if (kind == 2) { /* a slab on two stones */
        KIT_TINT(b, stones, 0.1);
        kit_bevelled(b, -half, 0.38, -0.2, half, 0.47, 0.2, 0.015);
        kit_bevelled(b, -half + 0.12, -0.05, -0.15, -half + 0.32, 0.379, 0.15, 0.01);
        kit_bevelled(b, half - 0.32, -0.05, -0.15, half - 0.12, 0.379, 0.15, 0.01);
        return;
    }
    for (int k = 0; k < 5; k++) kit_box(b, -half, 0.42, -0.22 + 0.09 * k, half, 0.445, -0.15 + 0.09 * k);
    for (int k = 0; k < 3 && !kind; k++) {
        kit_place_tilted(b, 0, 0.55 + 0.13 * k, -0.25 - 0.025 * k, 0, -10);
        kit_box(b, -half, 0, -0.012, half, 0.09, 0.012);
    }
    kit_place_at(b, 0, 0, 0, 0);
    kit_colour(b, 0.13, 0.13, 0.14);
    for (int side = -1; side < 2; side += 2) {
        const double x = side * (half - 0.12);
        const double leg[5][3] = {
            { x, -0.03, 0.2 }, { x, 0.4, 0.2 }, { x, 0.405, -0.2 }, { x, 0.3, -0.22 }, { x, -0.03, -0.25 }
        };
        const double back[3][3] = { { x, 0.4, -0.22 }, { x, 0.6, -0.29 }, { x, 0.92, -0.35 } };
        const double arm[4][3] = { { x, 0.4, 0.2 }, { x, 0.63, 0.22 }, { x, 0.66, 0.1 }, { x, 0.66, -0.29 } };
        kit_tube(b, leg, 5, 0.018, 7);
        if (kind) continue;
        kit_tube(b, back, 3, 0.018, 7);
        kit_tube(b, arm, 4, 0.016, 7);
    }
}

/* posts so far apart */
static void fence_posts(kit_build *b, double length, double height, double apart, double half)
{
    const int posts = (int)(length / apart) + 1;
    for (int k = 0; k <= posts; k++) {
        const double x = length * k / posts;
        kit_bevelled(b, x - half, -0.3, -half, x + half, height, half, 0.2 * half);
    }
}

static void fence_wires(kit_build *b, double length, double height)
{
    for (int k = 0; k < 5; k++) {
        const double y = height * (0.15 + 0.19 * k), from[3] = { 0, y, 0.05 }, to[3] = { length, y, 0.05 };
        kit_cable(b, from, to, 0.01, 0.003, 4);
    }
}

void garden_put_fence(kit_build *b, double length, double height, int kind)
{
    KIT_TINT(b, woods, 0.15);
    if (kind == 3) { /* panels: sheets between posts */
        const double panel[4][3] = { { 0, 0.08, 0 }, { length, 0.08, 0 }, { length, height, 0 }, { 0, height, 0 } };
        kit_quad(b, panel);
        fence_posts(b, length, height + 0.06, 1.8, 0.045);
        kit_box(b, 0, height - 0.02, -0.03, length, height + 0.015, 0.03);
        return;
    }
    fence_posts(b, length, height, kind == 2 ? 2.5 : 2.0, 0.05);
    if (kind == 2) {
        kit_colour(b, 0.4, 0.4, 0.4);
        fence_wires(b, length, height);
        return;
    }
    for (int k = 0; k < (kind ? 3 : 2); k++) {
        const double y = kind ? height * (0.3 + 0.28 * k) : height * (0.25 + 0.45 * k);
        kit_box(b, 0, y, 0.051, length, y + (kind ? 0.1 : 0.06), 0.076);
    }
    for (double x = 0.05; x < length && !kind; x += 0.11) { /* pales */
        const double low = kit_between(b, 0.03, 0.06), h = height * kit_between(b, 0.93, 0.97);
        const double face[5][2] = { { -0.035, 0 }, { 0.035, 0 }, { 0.035, h }, { 0, h + 0.06 }, { -0.035, h } };
        kit_place_at(b, x, low, 0.09, kit_between(b, -3, 3));
        for (int k = 1; k + 1 < 5; k++) {
            const kit_vertex v[3] = { { { face[0][0], face[0][1], 0 }, { 0, 0, 1 } },
                                      { { face[k][0], face[k][1], 0 }, { 0, 0, 1 } },
                                      { { face[k + 1][0], face[k + 1][1], 0 }, { 0, 0, 1 } } };
            kit_triangle(b, &v[0], &v[1], &v[2]);
        }
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>walls --------------------------------------------------------------------------------------------------- */

/* Courses of blocks, some of them gone from the top: ruin 0 .. 1. */
static void courses(kit_build *b, double length, double height, double thick, double ruin)
{
    const unsigned seed = (unsigned)kit_choose(b, 10000);
    float tone[3];
    KIT_TINT(b, stones, 0.12);
    memcpy(tone, b->albedo, sizeof tone);
    for (double y = -0.1, high; y < height - 0.05; y += high) {
        high = fmin(kit_between(b, 0.17, 0.27), height - y);
        for (double x = 0, wide; x < length - 0.02; x += wide) {
            wide = kit_between(b, 0.25, 0.55);
            if (length - x - wide < 0.2) wide = length - x;
            const double top = height * (1 - ruin * (0.5 + 0.7 * kit_fractal(seed, 0.8 * x, 0, 0, 3))),
                         out = kit_between(b, -0.02, 0.02);
            if (y > 0.2 && y + high > top && ruin > 0) continue;
            garden_shade(b, tone, 0.2);
            kit_bevelled(b, x + 0.006, y + 0.005, -thick / 2 - out, x + wide - 0.006, y + high - 0.005, thick / 2 + out,
                         0.018);
        }
    }
    kit_colour(b, 0.5 * (double)tone[0], 0.5 * (double)tone[1], 0.5 * (double)tone[2]);
    if (!(ruin > 0)) kit_box(b, 0.02, -0.1, -thick / 2 + 0.04, length - 0.02, height - 0.03, thick / 2 - 0.04);
}

/* 0 plaster, 1 blocks, 2 a ruin, 3 a single sheet */
void garden_put_wall(kit_build *b, double length, double height, int kind)
{
    static const float plasters[][3] = {
        { 0.72f, 0.66f, 0.54f }, { 0.75f, 0.72f, 0.68f }, { 0.60f, 0.42f, 0.30f }, { 0.5f, 0.5f, 0.5f }
    };
    const double sheet[4][3] = { { 0, -0.2, 0 }, { length, -0.2, 0 }, { length, height, 0 }, { 0, height, 0 } };
    if (kind == 1 || kind == 2) {
        courses(b, length, height, kit_between(b, 0.3, 0.5), kind == 2 ? kit_between(b, 0.4, 0.8) : 0);
        return;
    }
    KIT_TINT(b, plasters, 0.1);
    if (kind == 3) {
        kit_quad(b, sheet);
        return;
    }
    kit_box(b, 0, -0.2, -0.12, length, height, 0.12);
    KIT_TINT(b, stones, 0.1);
    kit_bevelled(b, -0.05, height + KIT_GAP, -0.18, length + 0.05, height + 0.07, 0.18, 0.015);
}
