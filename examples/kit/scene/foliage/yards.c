/* yards.c - what layouts of foliage.c that are gardened share: paving, houses, borders, beds, what stands in
   them. Declared in foliage.h. */
#include "kit/scene/foliage/foliage.h"
#include <math.h>
#include <string.h>

static const float pavings[][3] = {
    { 0.46f, 0.44f, 0.41f }, { 0.55f, 0.48f, 0.38f }, { 0.40f, 0.26f, 0.20f }, { 0.60f, 0.58f, 0.55f }
};
static const float boxes[][3] = { { 0.12f, 0.22f, 0.06f }, { 0.17f, 0.27f, 0.09f }, { 0.10f, 0.18f, 0.08f } };

/* ground of two triangles */
void garden_lay_flat(kit_yard *y)
{
    kit_begin_object(&y->p->b, "ground", 0);
    kit_level(&y->p->b, -70, -70, 70, 70, 0);
}

/* Slabs with joints between, some of them uneven. */
void garden_lay_paving(kit_yard *y, double x0, double z0, double x1, double z1, double size)
{
    kit_build *b = &y->p->b;
    float tone[3];
    kit_begin_object(b, "paving", 0);
    KIT_TINT(b, pavings, 0.1);
    memcpy(tone, b->albedo, sizeof tone);
    const int nx = (int)((x1 - x0) / size), nz = (int)((z1 - z0) / size);
    for (int k = 0; k < nx * nz; k++) {
        const double x = x0 + size * (k % nx), z = z0 + size * (k / nx), top = 0.05 + kit_between(b, -0.006, 0.006);
        garden_shade(b, tone, 0.12);
        kit_bevelled(b, x + 0.006, -0.1, z + 0.006, x + size - 0.006, top, z + size - 0.006, 0.008);
    }
}

/* Over a house from z = -5 to 0: two sheets that stand out, gables, a chimney. */
static void roof(kit_build *b, double half, double height)
{
    static const float tiles[][3] = { { 0.48f, 0.22f, 0.15f }, { 0.24f, 0.24f, 0.26f }, { 0.38f, 0.27f, 0.20f } };
    const double ridge = height + kit_between(b, 1, 2.4), out = kit_between(b, 0.2, 0.5),
                 low = height - out * (ridge - height) / 2.5, x = half + out,
                 chimney = kit_between(b, -0.6, 0.6) * half;
    const double front[4][3] = { { -x, low, out }, { x, low, out }, { x, ridge, -2.5 }, { -x, ridge, -2.5 } };
    const double back[4][3] = { { x, low, -5 - out }, { -x, low, -5 - out }, { -x, ridge, -2.5 }, { x, ridge, -2.5 } };
    for (int side = -1; side < 2; side += 2) {
        const double g = side * half;
        const kit_vertex gable[3] = { { { g, height, 0 }, { side, 0, 0 } },
                                      { { g, height, -5 }, { side, 0, 0 } },
                                      { { g, ridge - 0.01, -2.5 }, { side, 0, 0 } } };
        kit_triangle(b, &gable[0], &gable[1], &gable[2]);
    }
    KIT_TINT(b, tiles, 0.12);
    kit_quad(b, front);
    kit_quad(b, back);
    kit_bevelled(b, chimney - 0.3, height, -3.6, chimney + 0.3, ridge + 0.7, -3.1, 0.02);
}

/* A house's wall along x at z = 0, facing z, with door, windows, a gutter and a downpipe. */
void garden_set_house(kit_yard *y, double x, double z, double turn, double length, double height)
{
    static const float walls[][3] = {
        { 0.74f, 0.70f, 0.62f }, { 0.55f, 0.34f, 0.26f }, { 0.62f, 0.62f, 0.60f }, { 0.70f, 0.58f, 0.42f }
    };
    kit_build *b = &y->p->b;
    const kit_frame before = garden_set_out(y, "house", x, z, turn);
    const int holes = (int)(length / 2.3);
    KIT_TINT(b, walls, 0.1);
    kit_box(b, -length / 2, -0.2, -5, length / 2, height, 0);
    if (kit_odds(b, 0.75)) roof(b, length / 2, height);
    for (int k = 0; k < holes; k++) {
        const double c = -length / 2 + length * (k + 0.5) / holes, low = k == holes / 2 ? 0.05 : 0.85, top = 2.15,
                     w = k == holes / 2 ? 0.6 : 0.5;
        kit_colour(b, 0.72, 0.71, 0.68);
        for (int side = -1; side < 2; side += 2)
            kit_box(b, c + side * w - 0.05, low, KIT_GAP, c + side * w + 0.05, top, 0.06);
        kit_box(b, c - w + 0.051, top - 0.1, KIT_GAP, c + w - 0.051, top - KIT_GAP, 0.055);
        kit_box(b, c - w - 0.12, low - 0.06, KIT_GAP, c + w + 0.12, low - KIT_GAP, 0.14);
        kit_box(b, c - 0.02, low, 0.012, c + 0.02, top - 0.101, 0.04);
        kit_colour(b, 0.1, 0.12, 0.14);
        kit_box(b, c - w + 0.051, low, KIT_GAP, c + w - 0.051, top - 0.101, 0.01);
        if (k == holes / 2) continue;
        kit_colour(b, 0.2, 0.34, 0.3); /* shutters: sheets */
        for (int side = -1; side < 2; side += 2) {
            const double in = c + side * (w + 0.06), out = c + side * (2 * w),
                         leaf[4][3] = { { in, low, 0.07 }, { out, low, 0.2 }, { out, top, 0.2 }, { in, top, 0.07 } };
            kit_quad(b, leaf);
        }
    }
    const double gutter[2][3] = { { -length / 2, height - 0.08, 0.08 }, { length / 2, height - 0.08, 0.08 } },
                 pipe[3][3] = { { length / 2 - 0.3, height - 0.1, 0.08 },
                                { length / 2 - 0.3, height - 0.35, 0.05 },
                                { length / 2 - 0.3, 0, 0.05 } };
    kit_colour(b, 0.3, 0.3, 0.32);
    kit_tube(b, gutter, 2, 0.06, 8);
    kit_tube(b, pipe, 3, 0.035, 8);
    kit_leave(b, before);
}

/* Ivy or roses over a length of what stands along x from there. */
void garden_set_climber(kit_yard *y, double x, double z, double turn, double length, double height)
{
    const kit_frame before = garden_set_out(y, "ivy", x, z, turn);
    garden_grow_ivy(&y->p->b, 0, length, height, kit_between(&y->p->b, 0.4, 1));
    kit_leave(&y->p->b, before);
    const double a = turn * KIT_PI / 180;
    garden_sight_above(y, x + 0.5 * length * cos(a), 0.5 * height, z - 0.5 * length * sin(a), 0.8);
}

void garden_set_bench(kit_yard *y, double x, double z, double turn)
{
    const kit_frame before = garden_set_out(y, "bench", x, z, turn);
    garden_put_bench(&y->p->b, kit_choose(&y->p->b, 3));
    kit_leave(&y->p->b, before);
    garden_take(y, x, z, 0.9);
    garden_sight_above(y, x, 0.5, z, 0.9);
}

void garden_set_statue(kit_yard *y, double x, double z, double height, int kind)
{
    const kit_frame before = garden_set_out(y, "statue", x, z, kit_between(&y->p->b, -20, 20));
    garden_put_statue(&y->p->b, height, kind);
    kit_leave(&y->p->b, before);
    garden_take(y, x, z, 0.5);
    garden_sight_above(y, x, 0.6 * height, z, 0.6 * height);
}

void garden_set_table(kit_yard *y, double x, double z)
{
    kit_build *b = &y->p->b;
    const kit_frame before = garden_set_out(y, "table", x, z, kit_between(b, 0, 360));
    garden_put_table(b, 2 + kit_choose(b, 4));
    kit_leave(b, before);
    garden_sight_above(y, x, 0.6, z, 0.9);
    garden_take(y, x, z, 1.2);
    if (kit_odds(b, 0.5)) return;
    const kit_frame again = garden_set_out(y, "parasol", x + 0.9, z + 0.7, 0);
    garden_put_parasol(b, kit_between(b, 2.2, 2.6));
    kit_leave(b, again);
}

/* a fence, wall or hedge along x from there */
void garden_set_border(kit_yard *y, int kind, double x, double z, double turn, double length)
{
    kit_build *b = &y->p->b;
    const double a = turn * KIT_PI / 180, high = kind < 2 ? kit_between(b, 0.9, 1.2) : kit_between(b, 1.6, 2.1);
    const kit_frame before = garden_set_out(y, "border", x, z, turn);
    if (kind < 4) garden_put_fence(b, length, high, kind);
    else if (kind < 7) garden_put_wall(b, length, high, kind == 6 ? 3 : kind - 4);
    else {
        const kit_frame middle = kit_enter(b, length / 2, 0, 0, 0, 1);
        KIT_TINT(b, boxes, 0.1);
        garden_grow_hedge(b, length, high, 0.7, 0.11, kit_odds(b, 0.6));
        kit_leave(b, middle);
    }
    kit_leave(b, before);
    for (double s = 0.3; s < length; s += 0.6) garden_take(y, x + s * cos(a), z - s * sin(a), 0.4);
}

/* A bed of plants in rows between, its edging. */
void garden_set_bed(kit_yard *y, double x, double z, double hx, double hz)
{
    kit_build *b = &y->p->b;
    kit_begin_object(b, "bed", -1);
    const kit_frame before = garden_set_out(y, NULL, x, z, 0);
    garden_put_trough(b, 2 * hx, kit_between(b, 0.1, 0.2), 2 * hz);
    kit_leave(b, before);
    const int sorts = 1 + (int)(hx > hz ? hx : hz);
    for (int k = 0; k < sorts; k++) {
        const double f = (k + 0.5) / sorts * 2 - 1, cx = hx > hz ? x + f * hx : x, cz = hx > hz ? z : z + f * hz;
        if (kit_odds(b, 0.35)) {
            const kit_frame in = garden_set_out(y, "plant", cx, cz, 0);
            kit_place_at(b, 0, 0.1, 0, 0);
            if (kit_odds(b, 0.5)) garden_grow_rosette(b, kit_between(b, 0.35, 0.7), kit_choose(b, 4));
            else garden_grow_bush(b, 0.8, kit_between(b, 0.4, 0.9), kit_choose(b, 2));
            kit_leave(b, in);
            continue;
        }
        kit_begin_object(b, "flowers", -1);
        garden_sow_flowers(y, cx, cz, 0.85 * (hx > hz ? hx / sorts : hx), 0.85 * (hx > hz ? hz : hz / sorts), 40,
                           kit_between(b, 0.3, 0.65));
    }
    for (double s = -1; s <= 1; s += 0.25)
        garden_take(y, x + s * (hx > hz ? hx : 0), z + s * (hx > hz ? 0 : hz), fmin(hx, hz));
}
