/* wilds.c - layouts of foliage.c where nobody gardens: woods, meadows, ponds, jungle, bamboo, dry land, ruins.
   Declared in foliage.h. */
#include "kit/scene/foliage/foliage.h"
#include <math.h>
#include <string.h>

static const float soils[][3] = {
    { 0.20f, 0.15f, 0.10f }, { 0.16f, 0.17f, 0.08f }, { 0.24f, 0.19f, 0.12f }, { 0.15f, 0.20f, 0.08f }
};
static const float lawns[][3] = { { 0.16f, 0.24f, 0.07f }, { 0.22f, 0.28f, 0.10f }, { 0.30f, 0.28f, 0.14f } };
static const float sands[][3] = { { 0.58f, 0.47f, 0.32f }, { 0.52f, 0.36f, 0.24f }, { 0.62f, 0.56f, 0.44f } };

/* by how far from the middle a tree stands */
static int detail_at(double r, double fine, double coarse) { return r < fine ? 2 : r < coarse ? 1 : 0; }

static void set_logs(kit_yard *y, int logs, int stumps)
{
    kit_build *b = &y->p->b;
    double at[2];
    for (int k = 0; k < logs + stumps; k++) {
        if (!garden_find_spot(y, 1, 8, 0.7, at)) continue;
        const kit_frame before = garden_set_out(y, k < logs ? "log" : "stump", at[0], at[1], kit_between(b, 0, 360));
        if (k < logs) garden_put_log(b, kit_between(b, 1.5, 4.5), kit_between(b, 0.12, 0.3));
        else garden_put_stump(b, kit_between(b, 0.18, 0.4));
        kit_leave(b, before);
        kit_add_sight(y->p, at[0], kit_ground_at(y->p, at[0], at[1]) + 0.2, at[1], 0.7);
    }
}

static void set_mushrooms(kit_yard *y, int groups)
{
    kit_build *b = &y->p->b;
    double at[2];
    for (int k = 0; k < groups; k++) {
        if (!garden_find_spot(y, 0.5, 7, 0.3, at)) continue;
        kit_begin_object(b, "mushrooms", -1);
        const double size = kit_between(b, 0.06, 0.16);
        for (int n = 3 + kit_choose(b, 7); n > 0; n--) {
            const double x = at[0] + kit_between(b, -0.3, 0.3), z = at[1] + kit_between(b, -0.3, 0.3);
            const kit_frame before = garden_set_out(y, NULL, x, z, 0);
            garden_grow_mushroom(b, size * kit_between(b, 0.5, 1.3));
            kit_leave(b, before);
        }
        kit_add_sight(y->p, at[0], kit_ground_at(y->p, at[0], at[1]) + 0.06, at[1], 0.3);
    }
}

/* ---- >>woods --------------------------------------------------------------------------------------------------- */

void kit_lay_woods(kit_yard *y)
{
    static const int mixes[6][2] = { { KIT_OAK, KIT_BIRCH }, { -1, -1 },      { KIT_BIRCH, -1 },
                                     { KIT_BARE, KIT_BARE }, { KIT_OAK, -1 }, { KIT_POPLAR, KIT_BIRCH } };
    kit_build *b = &y->p->b;
    const int mix = kit_choose(b, 6), trees = 14 + kit_choose(b, 24);
    const double apart = kit_between(b, 0.7, 1.5);
    double at[2];
    KIT_TINT(b, soils, 0.15);
    garden_lay_ground(y, kit_between(b, 0.1, 0.5), kit_between(b, 0.12, 0.3), 0, kit_between(b, 0, 8));
    if (kit_odds(b, 0.4)) {
        kit_colour(b, 0.36, 0.29, 0.2);
        garden_lay_path(y, 0, kit_between(b, 0.5, 0.9), -14, 14);
    }
    for (int k = 0; k < trees; k++) {
        if (!garden_find_spot(y, k < 4 ? 1.5 : 2, k < 4 ? 6 : 20, apart, at)) continue;
        const int kind = mixes[mix][kit_odds(b, 0.3)], detail = detail_at(hypot(at[0], at[1]), 6, 13);
        if (kind < 0) garden_set_conifer(y, at[0], at[1], kit_between(b, 3.5, 13), detail);
        else garden_set_tree(y, at[0], at[1], kind, detail);
    }
    if (mix == 3) y->season = KIT_AUTUMN;
    set_logs(y, kit_choose(b, 4), kit_choose(b, 3));
    garden_set_stones(y, kit_choose(b, 12), 1, 9, kit_between(b, 0.2, 0.9));
    set_mushrooms(y, kit_choose(b, 4));
    if (kit_odds(b, 0.7)) garden_set_ferns(y, 12 + kit_choose(b, 30), 1, 8);
    if (kit_odds(b, 0.7)) garden_set_bushes(y, 4 + kit_choose(b, 8), 2, 9, kit_between(b, 0.6, 1.4));
    if (y->season == KIT_AUTUMN || kit_odds(b, 0.5)) garden_sow_litter(y, 6000, 9);
    garden_sow_cover(y, kit_odds(b, 0.7) ? 1600 : 0, 120, 60, 9);
    garden_sow_grass(y, 5000, kit_between(b, 0.1, 0.35), 8, 14);
    garden_set_far_trees(y, 60, 17, 50);
}

void kit_lay_meadow(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const double tall = kit_between(b, 0.2, 0.55), z = kit_between(b, -7, -4);
    double at[2];
    KIT_TINT(b, lawns, 0.15);
    garden_lay_ground(y, kit_between(b, 0.15, 0.6), kit_between(b, 0.08, 0.2), 0, kit_between(b, 2, 12));
    for (int k = 1 + kit_choose(b, 2); k > 0; k--)
        if (garden_find_spot(y, 3, 8, 1, at)) garden_set_tree(y, at[0], at[1], kit_choose(b, KIT_GIANT), 2);
    garden_set_stones(y, kit_choose(b, 10), 1, 8, kit_between(b, 0.3, 0.9));
    garden_set_bushes(y, kit_choose(b, 5), 3, 10, 1.2);
    if (kit_odds(b, 0.6)) {
        kit_begin_object(b, "fence", -1);
        const int kind = 1 + kit_choose(b, 2);
        for (int k = 0; k < 6; k++) { /* it follows the ground */
            const double x = -12 + 4 * k;
            const kit_frame before = garden_set_out(y, NULL, x, z, 0);
            garden_put_fence(b, 3.95, kit_between(b, 1.05, 1.15), kind);
            kit_leave(b, before);
        }
        kit_add_sight(y->p, 0, kit_ground_at(y->p, 0, z) + 0.6, z, 1);
    }
    for (int k = 2 + kit_choose(b, 5); k > 0; k--)
        if (garden_find_spot(y, 0, 5, 0.1, at)) {
            kit_begin_object(b, "flowers", -1);
            garden_sow_flowers(y, at[0], at[1], kit_between(b, 0.7, 1.8), kit_between(b, 0.7, 1.8), 40,
                               kit_between(b, 0.25, 0.6));
        }
    garden_sow_grass(y, 15000, tall, 6, 20);
    set_mushrooms(y, kit_choose(b, 2));
    garden_set_far_trees(y, 15 + kit_choose(b, 30), 20, 58);
}

/* ---- >>water --------------------------------------------------------------------------------------------------- */

static void lay_water(kit_yard *y, double level)
{
    kit_build *b = &y->p->b;
    const double *of = y->p->of, r = 1.6 * of[KIT_HOLLOW_R];
    const kit_moulding water[] = { { r, 0, 0, 0, 0 } };
    kit_begin_object(b, "water", 0);
    kit_colour(b, 0.08, 0.12, 0.10);
    kit_place_at(b, of[KIT_HOLLOW_X], level, of[KIT_HOLLOW_Z], 0);
    kit_turned(b, water, 1, 24);
    kit_place_at(b, 0, 0, 0, 0);
}

static void lily_pads(kit_yard *y, double level, int pads)
{
    static const double along[3] = { 0, 0, 1 }, across[3] = { 1, 0, 0 };
    static const float pale[3] = { 0.8f, 0.6f, 0.66f };
    kit_build *b = &y->p->b;
    const double *of = y->p->of;
    kit_begin_object(b, "lilies", -1);
    for (int k = 0; k < pads; k++) {
        const double r = of[KIT_HOLLOW_R] * kit_between(b, 0.2, 0.75), a = kit_between(b, 0, 2 * KIT_PI),
                     size = kit_between(b, 0.12, 0.32);
        const double x = of[KIT_HOLLOW_X] + r * cos(a), z = of[KIT_HOLLOW_Z] + r * sin(a),
                     from[3] = { 0, 0, -size / 2 };
        const kit_foil pad = { KIT_ROUND, size, size, -0.15, 0.03 }, petal = { KIT_POINTED, 0.09, 0.04, -0.6, 0.2 };
        const kit_frame before = kit_enter(b, x, level + kit_between(b, 0.005, 0.015), z, kit_between(b, 0, 360), 1);
        kit_colour(b, kit_between(b, 0.15, 0.28), kit_between(b, 0.26, 0.36), 0.1);
        garden_grow_leaf(b, &pad, from, along, across);
        garden_shade(b, pale, 0.1);
        if (k % 5 == 0)
            garden_grow_cluster(b, &petal, (const double[3]){ 0, 0.01, 0 }, (const double[3]){ 0, 1, 0 }, 1, 11);
        kit_leave(b, before);
    }
}

static void jetty(kit_yard *y, double level)
{
    static const float boards[][3] = { { 0.40f, 0.34f, 0.27f }, { 0.34f, 0.31f, 0.28f } };
    kit_build *b = &y->p->b;
    const double x = y->p->of[KIT_HOLLOW_X], z = y->p->of[KIT_HOLLOW_Z] + y->p->of[KIT_HOLLOW_R] * 1.25;
    kit_begin_object(b, "jetty", -1);
    const kit_frame before = kit_enter(b, x, level, z, 180, 1);
    for (int k = 0; k < 24; k++) {
        KIT_TINT(b, boards, 0.15);
        kit_box(b, -0.6 + kit_between(b, -0.02, 0.02), 0.35, 0.16 * k, 0.6, 0.385, 0.16 * k + 0.145);
    }
    for (int k = 0; k < 8; k++) {
        const double px = k & 1 ? 0.5 : -0.5, pz = 0.15 + 1.15 * (k / 2),
                     post[2][3] = { { px * 1.3, -1.2, pz }, { px * 1.3, k > 3 ? 0.8 : 0.5, pz } };
        kit_tube(b, post, 2, 0.06, 9);
        kit_box(b, px - 0.03, 0.25, 0, px + 0.03, 0.349, 3.8);
    }
    kit_leave(b, before);
    kit_add_sight(y->p, x, level + 0.4, z - 2.5, 1.2);
    for (int k = 0; k < 8; k++) garden_take(y, x, z - 0.6 * k, 0.7);
}

void kit_lay_pond(kit_yard *y)
{
    kit_build *b = &y->p->b;
    double *of = y->p->of, level = -0.35, at[2];
    of[KIT_HOLLOW_R] = kit_between(b, 2.8, 5);
    of[KIT_HOLLOW_DEEP] = 1.1;
    of[KIT_HOLLOW_X] = kit_between(b, -2, 2);
    of[KIT_HOLLOW_Z] = kit_between(b, -2, 1);
    KIT_TINT(b, lawns, 0.15);
    garden_lay_ground(y, kit_between(b, 0.04, 0.12), 0.2, 0, kit_between(b, 0, 8));
    lay_water(y, level);
    lily_pads(y, level, 10 + kit_choose(b, 50));
    if (kit_odds(b, 0.5)) jetty(y, level);
    const int clumps = 6 + kit_choose(b, 10);
    for (int k = 0; k < clumps; k++) {
        const double a = kit_between(b, 0, 2 * KIT_PI), r = of[KIT_HOLLOW_R] * kit_between(b, 0.75, 1.1),
                     tall = kit_between(b, 0.8, 1.9), x = of[KIT_HOLLOW_X] + r * cos(a),
                     z = of[KIT_HOLLOW_Z] + r * sin(a);
        if (!garden_is_free(y, x, z, 0.4)) continue;
        kit_begin_object(b, "reeds", -1);
        for (int n = 12 + kit_choose(b, 30); n > 0; n--) {
            const kit_frame before = garden_set_out(y, NULL, x + kit_between(b, -0.7, 0.7),
                                                    z + kit_between(b, -0.7, 0.7), kit_between(b, 0, 360));
            garden_grow_reed(b, tall * kit_between(b, 0.6, 1.1));
            kit_leave(b, before);
        }
        kit_add_sight(y->p, x, kit_ground_at(y->p, x, z) + 0.5 * tall, z, 0.8);
    }
    garden_take(y, of[KIT_HOLLOW_X], of[KIT_HOLLOW_Z], 0.9 * of[KIT_HOLLOW_R]);
    kit_add_sight(y->p, of[KIT_HOLLOW_X], level, of[KIT_HOLLOW_Z], 1.5);
    for (int k = 2 + kit_choose(b, 4); k > 0; k--)
        if (garden_find_spot(y, of[KIT_HOLLOW_R] + 1, 11, 1, at))
            garden_set_tree(y, at[0], at[1], kit_odds(b, 0.5) ? KIT_WILLOW : kit_choose(b, KIT_GIANT), k > 2 ? 1 : 2);
    garden_set_stones(y, 6 + kit_choose(b, 14), 0.9 * of[KIT_HOLLOW_R], of[KIT_HOLLOW_R] + 2, kit_between(b, 0.3, 0.8));
    garden_set_bushes(y, kit_choose(b, 6), 5, 11, 1.1);
    garden_sow_grass(y, 9000, kit_between(b, 0.12, 0.4), 7, 16);
    garden_set_far_trees(y, 35, 18, 55);
}

/* ---- >>hot ----------------------------------------------------------------------------------------------------- */

static void lianas(kit_yard *y, const double (*tops)[3], int count)
{
    kit_build *b = &y->p->b;
    kit_begin_object(b, "lianas", -1);
    kit_colour(b, 0.25, 0.22, 0.12);
    for (int k = 0; k + 1 < count; k++)
        for (int n = 0; n < 2; n++) {
            double to[3] = { tops[k + 1][0], tops[k + 1][1] - kit_between(b, 0, 3), tops[k + 1][2] };
            kit_cable(b, tops[k], to, kit_between(b, 0.5, 2.5), kit_between(b, 0.012, 0.03), 6);
        }
}

void kit_lay_jungle(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const int giants = 3 + kit_choose(b, 5), palms = kit_choose(b, 10), bananas = 2 + kit_choose(b, 8),
              low = 10 + kit_choose(b, 20);
    double at[2], tops[8][3];
    int hung = 0;
    y->season = KIT_SUMMER;
    KIT_TINT(b, soils, 0.15);
    garden_lay_ground(y, kit_between(b, 0.2, 0.6), kit_between(b, 0.12, 0.3), 0, 6);
    for (int k = 0; k < giants; k++) {
        if (!garden_find_spot(y, 2, k < 3 ? 6 : 13, 1.6, at)) continue;
        garden_set_tree(y, at[0], at[1], KIT_GIANT, hypot(at[0], at[1]) < 7 ? 2 : 1);
        const double top[3] = { at[0], kit_ground_at(y->p, at[0], at[1]) + kit_between(b, 4, 8), at[1] };
        if (hung < 8) memcpy(tops[hung++], top, sizeof top);
    }
    lianas(y, (const double(*)[3])tops, hung);
    for (int k = 0; k < palms + bananas + low; k++) {
        const int palm = k < palms, banana = !palm && k < palms + bananas;
        if (!garden_find_spot(y, 1.2, palm ? 12 : 8, palm || banana ? 0.8 : 0.4, at) || !garden_has_room(y)) continue;
        const double tall = palm ? kit_between(b, 1, 6) : banana ? kit_between(b, 1.5, 3.5) : kit_between(b, 0.4, 1.2);
        const kit_frame before = garden_set_out(y,
                                                palm     ? "palm"
                                                : banana ? "banana"
                                                         : "plant",
                                                at[0], at[1], kit_between(b, 0, 360));
        if (palm) garden_grow_palm(b, tall, hypot(at[0], at[1]) < 8 ? 2 : 1);
        else if (banana) garden_grow_banana(b, tall);
        else garden_grow_rosette(b, tall, kit_choose(b, 4));
        kit_leave(b, before);
        kit_add_sight(y->p, at[0], kit_ground_at(y->p, at[0], at[1]) + 0.7 * tall, at[1],
                      palm ? 1.4 : 0.5 * tall + 0.3);
    }
    garden_set_ferns(y, 10 + kit_choose(b, 25), 0.8, 8);
    set_logs(y, kit_choose(b, 3), 0);
    garden_set_stones(y, kit_choose(b, 8), 1, 8, 0.8);
    garden_sow_cover(y, 1500, 100, 40, 8);
    garden_sow_litter(y, 4000, 7);
    garden_set_far_trees(y, 60, 14, 40);
}

void kit_lay_dry(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const int beach = kit_odds(b, 0.5), plants = 14 + kit_choose(b, 16);
    double at[2];
    KIT_TINT(b, sands, 0.12);
    garden_lay_ground(y, kit_between(b, 0.2, 0.8), kit_between(b, 0.1, 0.2), 0, beach ? 2 : 14);
    garden_set_stones(y, 8 + kit_choose(b, 14), 1, 11, kit_between(b, 0.5, 1.3));
    for (int k = 0; k < plants && garden_has_room(y); k++) {
        const int palm = beach && k < 7;
        if (!garden_find_spot(y, 1.2, 10, 0.7, at)) continue;
        const double tall = palm ? kit_between(b, 1.5, 7) : kit_between(b, 0.4, 2.6);
        const kit_frame before = garden_set_out(y, palm ? "palm" : "plant", at[0], at[1], kit_between(b, 0, 360));
        if (palm) garden_grow_palm(b, tall, 2);
        else if (!beach && kit_odds(b, 0.55)) garden_grow_cactus(b, tall);
        else garden_grow_rosette(b, kit_between(b, 0.4, 1.1), 1 + kit_choose(b, 2));
        kit_leave(b, before);
        kit_add_sight(y->p, at[0], kit_ground_at(y->p, at[0], at[1]) + 0.6 * tall, at[1], 0.4 * fmin(tall, 3) + 0.2);
    }
    for (int k = kit_choose(b, 3); k > 0; k--)
        if (garden_find_spot(y, 3, 10, 1, at)) garden_set_tree(y, at[0], at[1], beach ? KIT_ACACIA : KIT_BARE, 2);
    garden_set_bushes(y, 2 + kit_choose(b, 6), 2, 11, 0.7);
    garden_sow_cover(y, 0, 40, 220, 9);
    garden_sow_grass(y, 2500, 0.4, 9, 10);
    if (beach) set_logs(y, 1 + kit_choose(b, 2), 0);
    if (beach || kit_odds(b, 0.3)) garden_set_far_trees(y, 20, 20, 50);
}

/* ---- >>bamboo -------------------------------------------------------------------------------------------------- */

void kit_lay_bamboo(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const double path = kit_between(b, 0.6, 1.2), tall = kit_between(b, 4, 9);
    const int canes = 45 + kit_choose(b, 55);
    double at[2];
    KIT_TINT(b, soils, 0.15);
    garden_lay_ground(y, kit_between(b, 0.05, 0.25), 0.2, 0, 3);
    kit_colour(b, 0.46, 0.42, 0.36);
    garden_lay_path(y, 0, path, -14, 14);
    for (int k = 0; k < 4 && kit_odds(b, 0.6); k++) {
        const double z = kit_between(b, -6, 6), x = (k & 1 ? 1 : -1) * (path + 0.7) + 0.3 * sin(0.35 * z);
        const kit_frame before = garden_set_out(y, "lantern", x, z, kit_between(b, 0, 60));
        garden_put_lantern(b, kit_between(b, 0.8, 1.6));
        kit_leave(b, before);
        garden_take(y, x, z, 0.4);
        kit_add_sight(y->p, x, kit_ground_at(y->p, x, z) + 0.6, z, 0.7);
    }
    const int fenced = kit_odds(b, 0.5);
    for (int k = 0; k < 24 && fenced; k++) {
        const double z = -12 + k, x = path + 0.2 + 0.3 * sin(0.35 * z);
        const kit_frame before = garden_set_out(y, k ? NULL : "fence", x, z, -90);
        garden_put_fence(b, 1, 0.6, 2);
        kit_leave(b, before);
    }
    for (int k = 0; k < canes && garden_has_room(y); k++) {
        if (!garden_find_spot(y, 0.8, k < 25 ? 6 : 12, 0.15, at)) continue;
        const kit_frame before = garden_set_out(y, k % 3 ? NULL : "bamboo", at[0], at[1], 0);
        garden_grow_bamboo(b, tall * kit_between(b, 0.7, 1.2), hypot(at[0], at[1]) < 7 ? 3 : 1);
        kit_leave(b, before);
        if (k < 10) kit_add_sight(y->p, at[0], kit_between(b, 0.4, 0.7 * tall), at[1], 0.9);
    }
    garden_set_stones(y, 4 + kit_choose(b, 10), 1, 8, 0.5);
    garden_set_ferns(y, kit_choose(b, 20), 1, 8);
    garden_sow_cover(y, 500, 60, 80, 7);
    garden_sow_litter(y, 5000, 7);
    garden_sow_grass(y, 2500, 0.2, 7, 9);
    garden_set_far_trees(y, 60, 14, 40);
}

/* ---- >>ruins --------------------------------------------------------------------------------------------------- */

void kit_lay_ruin(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const int walls = 3 + kit_choose(b, 4);
    double at[2];
    KIT_TINT(b, lawns, 0.15);
    garden_lay_ground(y, kit_between(b, 0.05, 0.3), kit_between(b, 0.15, 0.3), 0, kit_between(b, 0, 10));
    for (int k = 0; k < walls; k++) { /* about a court */
        const double turn = 90 * (k % 4) + kit_between(b, -8, 8), out = k < 4 ? kit_between(b, 2.5, 4.5) : 7,
                     a = turn * KIT_PI / 180, length = kit_between(b, 3, 6), high = kit_between(b, 1, 3.4),
                     x = out * sin(a), z = out * cos(a), fx = x - 0.5 * length * cos(a), fz = z + 0.5 * length * sin(a);
        const kit_frame before = garden_set_out(y, "wall", fx, fz, turn);
        garden_put_wall(b, length, high, 2);
        kit_leave(b, before);
        for (int n = 0; n < 8; n++)
            garden_take(y, fx + length * (n + 0.5) / 8 * cos(a), fz - length * (n + 0.5) / 8 * sin(a), 0.35);
        kit_add_sight(y->p, x, kit_ground_at(y->p, x, z) + 0.5 * high, z, 0.5 * high + 0.3);
        if (kit_odds(b, 0.3)) continue;
        const kit_frame again = garden_set_out(y, "ivy", fx, fz, turn);
        const kit_frame front = kit_enter(b, 0, 0, 0.27, 0, 1);
        garden_grow_ivy(b, 0.1, length * kit_between(b, 0.5, 0.95), 0.9 * high, kit_between(b, 0.4, 0.9));
        kit_leave(b, front);
        kit_leave(b, again);
    }
    if (kit_odds(b, 0.6)) {
        const kit_frame before = garden_set_out(y, "statue", 0.3, 0, kit_between(b, 0, 360));
        garden_put_statue(b, kit_between(b, 1.2, 2.2), kit_choose(b, 3));
        kit_leave(b, before);
        garden_take(y, 0.3, 0, 0.6);
        kit_add_sight(y->p, 0.3, 1, 0, 1);
    }
    garden_set_stones(y, 14 + kit_choose(b, 14), 1, 8, 0.5);
    for (int k = 1 + kit_choose(b, 4); k > 0; k--)
        if (garden_find_spot(y, 2, 10, 0.9, at))
            garden_set_tree(y, at[0], at[1], kit_choose(b, KIT_SPECIES), k > 2 ? 1 : 2);
    set_logs(y, kit_choose(b, 3), kit_choose(b, 2));
    garden_set_bushes(y, 2 + kit_choose(b, 5), 2, 10, 1);
    garden_set_ferns(y, kit_choose(b, 20), 1, 8);
    garden_sow_cover(y, 700, 20, 100, 8);
    garden_sow_grass(y, 9000, kit_between(b, 0.12, 0.3), 7, 16);
    garden_set_far_trees(y, 30, 20, 55);
}
