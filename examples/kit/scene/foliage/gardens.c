/* gardens.c - layouts of foliage.c: a garden by a house, parks, mazes, parterres, stones. Declared in foliage.h. */
#include "kit/scene/foliage/foliage.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const float lawns[][3] = { { 0.14f, 0.24f, 0.06f }, { 0.20f, 0.29f, 0.09f }, { 0.24f, 0.25f, 0.11f } };
static const float gravels[][3] = { { 0.52f, 0.48f, 0.41f }, { 0.60f, 0.57f, 0.52f }, { 0.44f, 0.38f, 0.31f } };
static const float boxes[][3] = { { 0.12f, 0.22f, 0.06f }, { 0.17f, 0.27f, 0.09f }, { 0.10f, 0.18f, 0.08f } };

/* ---- >>a garden by a house ------------------------------------------------------------------------------------- */

void kit_lay_garden(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const double half = kit_between(b, 5, 7.5);
    const int kind = kit_choose(b, 8), detail = 2;
    double at[2];
    KIT_TINT(b, lawns, 0.12);
    if (kit_odds(b, 0.5)) garden_lay_flat(y);
    else garden_lay_ground(y, 0.05, 0.3, 0, 0);
    if (kit_odds(b, 0.7)) garden_set_house(y, 0, -half - 0.6, 0, 2 * half, kit_between(b, 2.6, 5));
    else garden_set_border(y, kind, -half, -half, 0, 2 * half);
    garden_set_border(y, kind, -half, half, 0, 2 * half);
    garden_set_border(y, kind, half, half, 90, 2 * half);
    if (kit_odds(b, 0.7)) garden_set_border(y, kit_choose(b, 8), -half, half, 90, 2 * half);
    if (kit_odds(b, 0.6)) garden_set_climber(y, half - 0.2, -half + 1, -90, kit_between(b, 1.5, 4), 1.6);
    for (int k = 2 + kit_choose(b, 3); k > 0; k--) {
        const double along = kit_between(b, -0.4, 0.4) * half, edge = half - 1;
        if (k == 4) garden_set_bed(y, -edge, along, 0.45, kit_between(b, 1, 2));
        else garden_set_bed(y, along, k & 1 ? edge : -edge + 0.6, kit_between(b, 1, 2.2), 0.45);
    }
    if (kit_odds(b, 0.8) && garden_find_spot(y, 1, half - 1.5, 1.2, at)) garden_set_table(y, at[0], at[1]);
    if (kit_odds(b, 0.6) && garden_find_spot(y, 1, half - 1, 1, at))
        garden_set_bench(y, at[0], at[1], kit_between(b, 0, 360));
    for (int k = 1 + kit_choose(b, 2); k > 0; k--)
        if (garden_find_spot(y, 2, half - 1, 0.8, at))
            garden_set_tree(y, at[0], at[1], kit_odds(b, 0.5) ? KIT_APPLE : kit_choose(b, KIT_GIANT), detail);
    if (kit_odds(b, 0.4) && garden_find_spot(y, 1, half - 1, 0.7, at))
        garden_set_statue(y, at[0], at[1], kit_between(b, 0.8, 1.6), kit_choose(b, 3));
    if (kit_odds(b, 0.5) && garden_find_spot(y, 1, half - 1, 0.8, at)) {
        const kit_frame before = garden_set_out(y, "barrow", at[0], at[1], kit_between(b, 0, 360));
        garden_put_barrow(b);
        kit_leave(b, before);
        garden_sight_above(y, at[0], 0.4, at[1], 0.8);
    }
    for (int k = kit_choose(b, 6); k > 0; k--)
        if (garden_find_spot(y, 2, half - 0.7, 0.35, at)) garden_set_pot(y, at[0], at[1], kit_between(b, 0.25, 0.5));
    garden_set_bushes(y, 2 + kit_choose(b, 6), 3, half - 0.7, 1);
    garden_sow_grass(y, 7000, kit_between(b, 0.05, 0.14), half, 18);
    garden_set_far_trees(y, 30, half + 8, 50);
}

/* trees to both sides of a path, hedges between them */
static void avenue(kit_yard *y, double half, double apart, int kind, int hedges)
{
    kit_build *b = &y->p->b;
    for (int k = 0; k < 8; k++) {
        const double side = k & 1 ? 1 : -1, z = (k / 2 - 1.5) * apart, x = side * (half + 1.6) + 0.3 * sin(0.35 * z);
        garden_set_tree(y, x, z, kind, k > 1 && k < 6 ? 2 : 1);
        garden_take(y, x, z, 0.9);
        if (!hedges) continue;
        const kit_frame before = garden_set_out(y, "hedge", x + side * 1.2, z + 0.5 * apart, 90);
        KIT_TINT(b, boxes, 0.1);
        garden_grow_hedge(b, 0.85 * apart, kit_between(b, 0.7, 1), 0.6, 0.13, kit_odds(b, 0.5));
        kit_leave(b, before);
        for (double s = -0.5; s <= 0.5; s += 0.2) garden_take(y, x + side * 1.2, z + (0.5 + s) * apart, 0.4);
    }
}

void kit_lay_park(kit_yard *y)
{
    static const int rows[] = { KIT_OAK, KIT_POPLAR, KIT_OAK, KIT_BIRCH, KIT_BARE, KIT_ACACIA };
    kit_build *b = &y->p->b;
    const double half = kit_between(b, 1.2, 2), apart = kit_between(b, 4.5, 7);
    const int kind = rows[kit_choose(b, 6)], hedges = kit_odds(b, 0.5), middle = kit_choose(b, 3);
    KIT_TINT(b, lawns, 0.12);
    garden_lay_ground(y, kit_between(b, 0, 0.15), 0.15, 0, kit_between(b, 0, 5));
    KIT_TINT(b, gravels, 0.1);
    garden_lay_path(y, 0, half, -16, 16);
    avenue(y, half, apart, kind, hedges);
    for (int k = 0; k < 4; k++) {
        const double side = k & 1 ? 1 : -1, z = (k / 2 - 0.5) * apart * 1.9 + kit_between(b, -0.4, 0.4),
                     x = side * (half + 0.5) + 0.3 * sin(0.35 * z);
        if (kit_odds(b, 0.75)) garden_set_bench(y, x, z, -90 * side);
        const kit_frame before = garden_set_out(y, "lamp", side * (half + 0.3), z + 1.4, 0);
        garden_put_lamp_post(b, kit_between(b, 2.8, 3.4));
        kit_leave(b, before);
        kit_add_lamp(y->p, side * (half + 0.3), 2.6, z + 1.4);
    }
    const double x = -half - 5.5;
    if (!middle) {
        const kit_frame before = garden_set_out(y, "fountain", x, 0, 0);
        garden_put_fountain(b, kit_between(b, 1, 1.8));
        kit_leave(b, before);
        garden_take(y, x, 0, 2);
        garden_sight_above(y, x, 0.6, 0, 1.6);
    } else if (middle == 1) garden_set_statue(y, x, 0, kit_between(b, 1.8, 3), kit_choose(b, 3));
    for (int k = 0; k < 3; k++)
        garden_set_bed(y, (k & 1 ? 1 : -1) * (half + kit_between(b, 3.6, 5)), (k - 1) * 4.5, kit_between(b, 0.7, 1.2),
                       kit_between(b, 0.5, 1.3));
    garden_set_bushes(y, kit_choose(b, 8), 5, 13, 1.3);
    if (y->season == KIT_AUTUMN) garden_sow_litter(y, 2500, 9);
    garden_sow_grass(y, 8000, kit_between(b, 0.06, 0.16), 8, 18);
    garden_set_far_trees(y, 36, 18, 55);
}

/* ---- >>hedges -------------------------------------------------------------------------------------------------- */

/* Every cell opens to the north or the east. */
void kit_lay_maze(kit_yard *y)
{
    enum { CELLS = 7 };

    kit_build *b = &y->p->b;
    const double cell = kit_between(b, 1.5, 2.0), high = kit_between(b, 1.0, 2.1), thick = kit_between(b, 0.4, 0.65),
                 half = CELLS * cell / 2;
    const int core = kit_odds(b, 0.65);
    const double leaf = 0.045 + 0.045 * high;
    float green[3];
    KIT_TINT(b, gravels, 0.1);
    garden_lay_flat(y);
    KIT_TINT(b, boxes, 0.12);
    memcpy(green, b->albedo, sizeof green);
    for (int k = 0; k < (CELLS + 1) * (CELLS + 1); k++) {
        const int i = k % (CELLS + 1), j = k / (CELLS + 1), east = kit_odds(b, 0.5),
                  centre = abs(2 * i - CELLS) < 2 && abs(2 * j - CELLS) < 2;
        for (int way = 0; way < 2; way++) { /* along x, along z */
            const int edge = way ? i == 0 || i == CELLS : j == 0 || j == CELLS, last = way ? j == CELLS : i == CELLS;
            if (last || centre || (edge ? kit_odds(b, 0.12) : way != east)) continue;
            const double x = i * cell - half + (way ? 0 : cell / 2), z = j * cell - half + (way ? cell / 2 : 0);
            const kit_frame before = garden_set_out(y, "hedge", x, z, way ? 90 : 0);
            memcpy(b->albedo, green, sizeof green);
            garden_grow_hedge(b, cell - thick - 0.004 + (way ? 0 : 2 * thick - 0.01), high * (way ? 0.985 : 1), thick,
                              leaf, core);
            kit_leave(b, before);
            if (k % 5 == 0) garden_sight_above(y, x, 0.5 * high, z, 0.8);
        }
    }
    garden_set_statue(y, 0, 0, kit_between(b, 1.4, 2.4), kit_choose(b, 3));
    for (int k = 0; k < 4; k++) {
        const double x = (k & 1 ? 1 : -1) * (half + 1.2), z = (k & 2 ? 1 : -1) * (half + 1.2);
        const kit_frame before = garden_set_out(y, "topiary", x, z, 0);
        garden_grow_topiary(b, kit_between(b, 1.5, 2.6), kit_choose(b, 3));
        kit_leave(b, before);
        garden_sight_above(y, x, 1, z, 1);
    }
    garden_set_bench(y, 0, cell * 0.9, 180);
    if (kit_odds(b, 0.5)) garden_sow_litter(y, 1000, half);
    garden_set_far_trees(y, 44, half + 5, 45);
    y->p->stand[0] = y->p->stand[1] = -half - 2;
    y->p->stand[2] = y->p->stand[3] = half + 2;
}

/* A square bed between low hedges. */
static void quarter(kit_yard *y, double x, double z, double size, double low, int kind, int cross, const float green[3])
{
    kit_build *b = &y->p->b;
    for (int k = 0; k < 4; k++) {
        const double a = 90 * k, out = size / 2 - 0.12;
        const kit_frame before = garden_set_out(y, "hedge", x + out * sin(a * KIT_PI / 180),
                                                z + out * cos(a * KIT_PI / 180), a);
        memcpy(b->albedo, green, sizeof b->albedo);
        garden_grow_hedge(b, k & 1 ? size - 0.52 : size, k & 1 ? low : low - 0.006, 0.26, 0.05, 1);
        kit_leave(b, before);
    }
    const kit_frame before = garden_set_out(y, "topiary", x, z, 0);
    garden_grow_topiary(b, kit_between(b, 1.1, 1.2) + 0.4 * kind, kind);
    kit_leave(b, before);
    garden_sight_above(y, x, 0.7, z, 1);
    kit_begin_object(b, "flowers", -1);
    for (int k = 0; k < 2; k++)
        garden_sow_flowers(y, x + (k ? 0.25 : -0.25) * size, z + (cross ? 0.25 : 0) * size, 0.16 * size,
                           (cross ? 0.16 : 0.36) * size, 34, low + 0.05);
}

/* Low hedges about beds, the same in four quarters. */
void kit_lay_parterre(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const double size = kit_between(b, 2.2, 3.2), way = kit_between(b, 0.8, 1.3), low = kit_between(b, 0.3, 0.6),
                 middle = way + size / 2;
    const int kind = kit_choose(b, 3), cross = kit_odds(b, 0.5), fountain = kit_odds(b, 0.6);
    float green[3];
    KIT_TINT(b, gravels, 0.1);
    garden_lay_flat(y);
    KIT_TINT(b, boxes, 0.1);
    memcpy(green, b->albedo, sizeof green);
    for (int q = 0; q < 4; q++) {
        quarter(y, (q & 1 ? 1 : -1) * middle, (q & 2 ? 1 : -1) * middle, size, low, kind, cross, green);
    }
    if (fountain) {
        const kit_frame before = garden_set_out(y, "fountain", 0, 0, 0);
        garden_put_fountain(b, fmin(1.1, way));
        kit_leave(b, before);
        garden_sight_above(y, 0, 0.8, 0, 1.2);
    } else garden_set_statue(y, 0, 0, kit_between(b, 1.6, 2.4), kit_choose(b, 3));
    const double edge = way + size + 1.6;
    const int around = 4 + kit_choose(b, 4);
    for (int k = 0; k < 4; k++) {
        const double a = 90 * k * KIT_PI / 180;
        if (kit_odds(b, 0.8))
            garden_set_border(y, around, edge * sin(a) - edge * cos(a), edge * cos(a) + edge * sin(a), 90 * k,
                              2 * edge);
        if (kit_odds(b, 0.6)) garden_set_bench(y, 0.85 * edge * sin(a), 0.85 * edge * cos(a), 90 * k + 180);
        for (int side = -1; side < 2; side += 2)
            garden_set_pot(y, way * 1.2 * cos(a) * side + way * sin(a), way * cos(a) - side * way * 1.2 * sin(a), 0.45);
        if (k == 1 || kit_odds(b, 0.4))
            garden_set_conifer(y, (edge + 2.5) * (k & 1 ? 1 : -1), (edge + 2.5) * (k & 2 ? 1 : -1),
                               kit_between(b, 4, 8), 2);
    }
    garden_set_far_trees(y, 40, edge + 7, 50);
}

/* ---- >>stones -------------------------------------------------------------------------------------------------- */

/* stones in moss */
static void stone_group(kit_yard *y, const double at[2])
{
    kit_build *b = &y->p->b;
    for (int n = 1 + kit_choose(b, 4); n > 0; n--) {
        const double s = kit_between(b, 0.2, 0.7), h[3] = { s, s * kit_between(b, 0.6, 1.6), s };
        const kit_frame before = garden_set_out(y, "stone", at[0] + kit_between(b, -0.8, 0.8),
                                                at[1] + kit_between(b, -0.8, 0.8), kit_between(b, 0, 360));
        garden_put_stone(b, h, 24);
        kit_leave(b, before);
    }
    kit_begin_object(b, "moss", -1);
    for (int n = 0; n < 260; n++) {
        const kit_foil blade = { KIT_NEEDLE, 0.07, 0.012, 0.8, 0 };
        const kit_frame before = garden_set_out(y, NULL, at[0] + kit_between(b, -1.1, 1.1) * kit_chance(b),
                                                at[1] + kit_between(b, -1.1, 1.1) * kit_chance(b), 0);
        kit_colour(b, 0.2, 0.28, 0.08);
        garden_grow_tuft(b, &blade, 8, 0.9);
        kit_leave(b, before);
    }
    garden_sight_above(y, at[0], 0.3, at[1], 1);
}

/* along two fences */
static void shrubs(kit_yard *y, double half)
{
    kit_build *b = &y->p->b;
    for (int k = 0; k < 9; k++) {
        const double s = (k + kit_chance(b)) / 9 * 2 - 1, x = k & 1 ? s * half : half - 0.5,
                     z = k & 1 ? -half + 0.4 : s * half;
        if (!garden_is_free(y, x, z, 0.2)) continue;
        const kit_frame before = garden_set_out(y, "shrub", x, z, 0);
        if (k % 3 == 0) garden_grow_bush(b, 1.2, kit_between(b, 0.5, 0.9), KIT_BUSH_CORE);
        else if (k % 3 == 1) garden_grow_topiary(b, kit_between(b, 0.6, 1), 0);
        else
            for (int n = 0; n < 4; n++) garden_grow_bamboo(b, kit_between(b, 2.5, 4), 2);
        kit_leave(b, before);
        garden_sight_above(y, x, 0.5, z, 0.7);
    }
}

/* Raked gravel about stones, clipped shrubs, a maple, a fence of panels. */
void kit_lay_stones(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const double half = kit_between(b, 4.5, 6.5), apart = kit_between(b, 0.14, 0.24);
    const int fence = kit_odds(b, 0.5) ? 3 : 4 + kit_choose(b, 2), groups = 2 + kit_choose(b, 3);
    double at[2];
    KIT_TINT(b, gravels, 0.08);
    garden_lay_flat(y);
    kit_begin_object(b, "raked", -1);
    for (double x = -half; x < half; x += apart) {
        const kit_foil ridge = { KIT_CARD, 2 * half, 0.6 * apart, 0, 0.35 };
        garden_grow_leaf(b, &ridge, (const double[3]){ x, 0.004, -half }, (const double[3]){ 0, 0, 1 },
                         (const double[3]){ 1, 0, 0 });
    }
    for (int k = 0; k < groups; k++) {
        if (!garden_find_spot(y, 0.5, half - 1.5, 1.5, at)) continue;
        stone_group(y, at);
    }
    garden_set_border(y, fence, -half, -half - 0.5, 0, 2 * half);
    garden_set_border(y, fence, half + 0.5, half, 90, 2 * half);
    shrubs(y, half);
    const kit_frame before = garden_set_out(y, "lantern", -half + 1, -half + 1, 30);
    garden_put_lantern(b, kit_between(b, 1, 1.8));
    kit_leave(b, before);
    garden_sight_above(y, -half + 1, 0.7, -half + 1, 0.8);
    y->season = kit_odds(b, 0.6) ? KIT_AUTUMN : y->season;
    if (garden_find_spot(y, 2, half, 0.8, at)) garden_set_tree(y, at[0], at[1], KIT_APPLE, 2);
    if (kit_odds(b, 0.5) && garden_find_spot(y, 2, half + 2, 0.8, at))
        garden_set_conifer(y, at[0], at[1], kit_between(b, 2, 4), 2);
    if (y->season == KIT_AUTUMN) garden_sow_litter(y, 500, half);
    if (kit_odds(b, 0.6)) garden_set_house(y, -half - 1.5, 0, 90, 2 * half, 2.8);
    garden_set_far_trees(y, 40, half + 7, 45);
}
