/* crops.c - layouts of foliage.c: terraces, glasshouses, rows of vegetables and of trees. Declared in foliage.h. */
#include "kit/scene/foliage/foliage.h"
#include <math.h>

static const float lawns[][3] = { { 0.14f, 0.24f, 0.06f }, { 0.20f, 0.29f, 0.09f }, { 0.24f, 0.25f, 0.11f } };
static const float gravels[][3] = { { 0.52f, 0.48f, 0.41f }, { 0.60f, 0.57f, 0.52f }, { 0.44f, 0.38f, 0.31f } };

/* ---- >>terraces, glasshouses ----------------------------------------------------------------------------------- */

/* A pergola over a terrace of half sides, and a vine on it. */
static void vine_above(kit_yard *y, double hx, double hz)
{
    kit_build *b = &y->p->b;
    const kit_frame before = garden_set_out(y, "pergola", 0, 0, 0);
    garden_put_pergola(b, 1.7 * hx, 2.4, 1.6 * hz);
    kit_leave(b, before);
    const kit_foil card = { KIT_POINTED, 0.16, 0.13, 0.6, 0 };
    kit_begin_object(b, "vine", -1);
    for (int k = 0; k < 1500; k++) { /* leaves on it and hanging from it */
        const double from[3] = { kit_between(b, -0.9, 0.9) * hx, 2.68 - 0.5 * pow(kit_chance(b), 3),
                                 kit_between(b, -0.95, 0.95) * hz };
        double out[3], across[3];
        garden_lean((const double[3]){ 0, -1, 0 }, kit_between(b, 0.2, 1.9), kit_between(b, 0, 2 * KIT_PI), out,
                    across);
        kit_colour(b, kit_between(b, 0.16, 0.26), kit_between(b, 0.28, 0.36), 0.1);
        if (kit_noise(3, 0.8 * from[0], 0, 0.8 * from[2]) > -0.15) garden_grow_leaf(b, &card, from, out, across);
    }
    garden_sight_above(y, 0, 2.3, 0, 1.4);
}

static void pots_along(kit_yard *y, double hx, double hz)
{
    kit_build *b = &y->p->b;
    double at[2];
    for (int k = 10 + kit_choose(b, 14); k > 0; k--) { /* pots stand along the edges */
        const double s = kit_between(b, -0.95, 0.95), away = kit_between(b, 0.85, 0.95);
        at[0] = k & 1 ? s * hx : (k & 2 ? away : -away) * hx;
        at[1] = k & 1 ? (k % 3 ? away : -0.86) * hz : s * hz;
        if (!garden_is_free(y, at[0], at[1], 0.3) || !garden_has_room(y)) continue;
        garden_take(y, at[0], at[1], 0.3);
        const double tall = kit_between(b, 0.2, 0.6);
        const kit_frame up = kit_enter(b, 0, 0.051, 0, 0, 1);
        garden_set_pot(y, at[0], at[1], tall);
        kit_leave(b, up);
    }
}

void kit_lay_terrace(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const double hx = kit_between(b, 3.2, 5), hz = kit_between(b, 2.4, 3.4), slab = kit_between(b, 0.3, 0.65);
    double at[2];
    KIT_TINT(b, lawns, 0.12);
    garden_lay_flat(y);
    garden_lay_paving(y, -hx, -hz, hx, hz, slab);
    garden_set_house(y, 0, -hz - 0.1, 0, 2 * hx + 2, kit_between(b, 2.7, 5.5));
    if (kit_odds(b, 0.6))
        garden_set_climber(y, kit_between(b, -hx, 0), -hz, 0, kit_between(b, 1.5, 3), kit_between(b, 1.8, 2.6));
    if (kit_odds(b, 0.6)) vine_above(y, hx, hz);
    const kit_frame up = kit_enter(b, 0, 0.051, 0, 0, 1); /* on the slabs */
    garden_set_table(y, kit_between(b, -0.4, 0.4) * hx, kit_between(b, -0.3, 0.4) * hz);
    if (kit_odds(b, 0.6)) garden_set_bench(y, 0.5 * hx, -hz + 0.45, 0);
    kit_leave(b, up);
    pots_along(y, hx, hz);
    const int rail = kit_choose(b, 5);
    if (rail < 4) garden_set_border(y, rail, -hx, hz + 0.3, 0, 2 * hx);
    for (int k = 2 + kit_choose(b, 2); k > 0; k--)
        if (garden_find_spot(y, hz + 3, 11, 1, at) && at[1] > 0)
            garden_set_tree(y, at[0], at[1], kit_choose(b, KIT_GIANT), k > 2 ? 1 : 2);
    garden_set_bushes(y, 5, hx + 1, 11, 1.2);
    garden_sow_grass(y, 2500, 0.1, 10, 12);
    garden_set_far_trees(y, 30, 16, 50);
}

/* The frame of a glasshouse and such panes as are shaded: sheets. */
static void glasshouse(kit_build *b, double hx, double eaves, double ridge, double hz)
{
    const int bays = (int)(2 * hz / 1.2);
    kit_colour(b, 0.78, 0.78, 0.76);
    for (int k = 0; k <= bays; k++) {
        const double z = -hz + 2 * hz * k / bays;
        const double rib[5][3] = {
            { -hx, -0.1, z }, { -hx, eaves, z }, { 0, ridge, z }, { hx, eaves, z }, { hx, -0.1, z }
        };
        kit_tube(b, rib, 5, 0.03, 6);
    }
    for (int k = 0; k < 7; k++) {
        const double f = (k - 3) / 3.0, x = f * hx, h = eaves + (1 - fabs(f)) * (ridge - eaves),
                     bar[2][3] = { { x, h, -hz }, { x, h, hz } };
        kit_tube(b, bar, 2, 0.018, 6);
    }
    for (int side = -1; side < 2; side += 2) { /* knee walls, panes */
        const double x = side * hx, low[4][3] = { { x, -0.1, -hz }, { x, -0.1, hz }, { x, 0.7, hz }, { x, 0.7, -hz } };
        kit_colour(b, 0.5, 0.32, 0.25);
        kit_quad(b, low);
        kit_colour(b, 0.7, 0.74, 0.72);
        for (int k = 0; k < bays; k++) {
            const double z0 = -hz + 2 * hz * k / bays + 0.03, z1 = z0 + 2 * hz / bays - 0.06;
            const double roof[4][3] = { { x, eaves, z0 }, { x, eaves, z1 }, { 0, ridge, z1 }, { 0, ridge, z0 } };
            const double wall[4][3] = {
                { x, 0.75, z0 }, { x, 0.75, z1 }, { x, eaves - 0.03, z1 }, { x, eaves - 0.03, z0 }
            };
            if (kit_odds(b, 0.4)) kit_quad(b, roof);
            if (kit_odds(b, 0.4)) kit_quad(b, wall);
        }
    }
}

/* A table of slats, pots on it. */
static void staging(kit_yard *y, double x, double z, double len)
{
    kit_build *b = &y->p->b;
    const kit_frame before = garden_set_out(y, "staging", x, z, 0);
    kit_colour(b, 0.45, 0.36, 0.26);
    for (int s = 0; s < 6; s++) kit_box(b, -0.45 + 0.155 * s, 0.74, -len, -0.45 + 0.155 * s + 0.12, 0.77, len);
    for (int s = 0; s < 4; s++)
        kit_box(b, (s & 1 ? 0.4 : -0.4) - 0.03, 0.05, (s & 2 ? 0.9 : -0.9) * len - 0.03, (s & 1 ? 0.4 : -0.4) + 0.03,
                0.739, (s & 2 ? 0.9 : -0.9) * len + 0.03);
    kit_leave(b, before);
    for (int s = 0; s < 5; s++) {
        const kit_frame up = kit_enter(b, 0, 0.77 + KIT_GAP, 0, 0, 1);
        if (kit_odds(b, 0.85))
            garden_set_pot(y, x + kit_between(b, -0.2, 0.2), z + len * (s - 2) * 0.42, kit_between(b, 0.12, 0.24));
        kit_leave(b, up);
    }
    garden_sight_above(y, x, 0.95, z, 0.9);
    garden_sight_above(y, x, 0.3, z, 0.6);
}

/* in the middle of a glasshouse */
static void large_plants(kit_yard *y, double hz)
{
    kit_build *b = &y->p->b;
    for (int k = 0; k < 7; k++) {
        const double z = (k - 3) * hz * 0.27, x = kit_between(b, -0.3, 0.3);
        const int kind = kit_choose(b, 5);
        const kit_frame before = garden_set_out(y, "plant", x, z, kit_between(b, 0, 360));
        kit_place_at(b, 0, 0.05, 0, 0);
        if (kind == 0) garden_grow_palm(b, kit_between(b, 0.6, 1.4), 2);
        if (kind == 1) garden_grow_banana(b, kit_between(b, 1.4, 2.3));
        if (kind == 2) garden_grow_cactus(b, kit_between(b, 0.8, 1.9));
        if (kind == 3) garden_grow_fern(b, kit_between(b, 0.6, 1), 12);
        if (kind == 4) garden_grow_rosette(b, kit_between(b, 0.6, 1), kit_choose(b, 4));
        kit_leave(b, before);
        garden_sight_above(y, x, 0.8, z, 0.8);
    }
}

void kit_lay_greenhouse(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const double hx = kit_between(b, 2.4, 3.4), hz = kit_between(b, 4, 6), eaves = kit_between(b, 1.9, 2.4),
                 ridge = eaves + kit_between(b, 0.8, 1.5);
    double at[2];
    KIT_TINT(b, lawns, 0.12);
    garden_lay_flat(y);
    garden_lay_paving(y, -hx, -hz, hx, hz, kit_between(b, 0.4, 0.7));
    kit_begin_object(b, "glasshouse", 0);
    glasshouse(b, hx + 0.1, eaves, ridge, hz);
    for (int k = 0; k < 6; k++) { /* tables along the sides, full of pots */
        const double x = (k & 1 ? 1 : -1) * (hx - 0.6), z = (k / 2 - 1) * hz * 0.64, len = 0.28 * hz;
        if (kit_odds(b, 0.15)) {
            garden_set_bed(y, x, z, 0.5, len);
            continue;
        }
        staging(y, x, z, len);
    }
    large_plants(y, hz);
    for (int k = 0; k < 4; k++)
        if (kit_odds(b, 0.6)) {
            const double x = (k & 1 ? 1 : -1) * 0.45 * hx, z = (k & 2 ? 0.4 : -0.4) * hz;
            const kit_frame before = kit_enter(b, 0, eaves - 0.3, 0, 0, 1);
            const double cord[2][3] = { { x, 0.15, z }, { x, 0.3 + 0.5 * (ridge - eaves), z } };
            garden_set_pot(y, x, z, 0.2);
            kit_tube(b, cord, 2, 0.005, 4);
            kit_leave(b, before);
            garden_sight_above(y, x, eaves - 0.1, z, 0.5);
        }
    garden_set_bushes(y, 6, hz + 1, 11, 1);
    if (garden_find_spot(y, hz + 2, 10, 1, at)) garden_set_tree(y, at[0], at[1], kit_choose(b, KIT_GIANT), 1);
    garden_set_far_trees(y, 40, 12, 45);
    y->p->stand[0] = -hx + 0.2;
    y->p->stand[2] = hx - 0.2;
    y->p->stand[1] = -hz - 1;
    y->p->stand[3] = hz + 1;
}

/* ---- >>rows ---------------------------------------------------------------------------------------------------- */

/* Tomatoes on a stake, beans on a tripod of canes. */
static void staked(kit_build *b, double height)
{
    const kit_foil leaf = { KIT_POINTED, 0.11, 0.07, 0.7, 0 };
    const double canes[3][2][3] = { { { -0.25, -0.05, -0.2 }, { 0.02, height, 0 } },
                                    { { 0.28, -0.05, -0.15 }, { -0.02, height, 0.01 } },
                                    { { 0, -0.05, 0.3 }, { 0, height + 0.03, -0.02 } } };
    for (int k = 0; k < 3; k++) {
        kit_colour(b, 0.5, 0.42, 0.25);
        kit_tube(b, canes[k], 2, 0.009, 6);
        for (int n = 0; n < 11; n++) {
            const double f = (n + kit_chance(b)) / 11.5;
            double at[3], out[3], across[3];
            for (int i = 0; i < 3; i++) at[i] = canes[k][0][i] + f * (canes[k][1][i] - canes[k][0][i]);
            garden_lean((const double[3]){ 0, 1, 0 }, kit_between(b, 0.6, 1.6), kit_between(b, 0, 2 * KIT_PI), out,
                        across);
            kit_colour(b, kit_between(b, 0.16, 0.26), kit_between(b, 0.28, 0.38), 0.1);
            garden_grow_cluster(b, &leaf, at, out, 1.1, 6);
        }
    }
}

static void row(kit_yard *y, double x, double z, double half, int sort)
{
    static const kit_foil cabbage = { KIT_ROUND, 0.24, 0.22, -0.6, 0.1 }, leek = { KIT_BLADE, 0.4, 0.035, 1.1, 0.3 },
                          lettuce = { KIT_ROUND, 0.15, 0.13, 0.9, 0 };
    kit_build *b = &y->p->b;
    const double apart = sort == 3 ? 0.7 : sort == 1 ? 0.14 : 0.36;
    kit_begin_object(b, "row", -1);
    for (double s = -half + 0.2; s < half - 0.1 && garden_has_room(y); s += apart * kit_between(b, 0.85, 1.15)) {
        const kit_frame before = garden_set_out(y, NULL, x, z + s, kit_between(b, 0, 360));
        kit_place_at(b, kit_between(b, -0.03, 0.03), 0.12, 0, 0);
        kit_colour(b, kit_between(b, 0.2, 0.3), kit_between(b, 0.32, 0.4), sort == 0 ? 0.24 : 0.12);
        if (sort == 0) garden_grow_tuft(b, &cabbage, 16, 1.2);
        if (sort == 1) garden_grow_tuft(b, &leek, 6, 0.4);
        if (sort == 2) garden_grow_tuft(b, &lettuce, 14, 1.3);
        if (sort == 3) staked(b, kit_between(b, 1.1, 1.9));
        kit_leave(b, before);
    }
}

void kit_lay_vegetables(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const double wide = kit_between(b, 0.55, 0.8), gap = kit_between(b, 0.4, 0.7), half = kit_between(b, 1.5, 2.6);
    const int beds = 4 + kit_choose(b, 3), fence = kit_choose(b, 8);
    double at[2];
    KIT_TINT(b, gravels, 0.1);
    if (kit_odds(b, 0.5)) KIT_TINT(b, lawns, 0.1);
    garden_lay_ground(y, 0.04, 0.3, 0, kit_between(b, 0, 6));
    const double edge = beds * (wide + gap / 2) + 2;
    for (int k = 0; k < 2 * beds; k++) {
        const double x = ((k / 2) - 0.5 * (beds - 1)) * (2 * wide + gap), z = (k & 1 ? 1 : -1) * (half + 0.5);
        const int sort = kit_choose(b, 6);
        const kit_frame before = garden_set_out(y, "raised bed", x, z, 0);
        garden_put_trough(b, 2 * wide, 0.16, 2 * half);
        kit_leave(b, before);
        garden_take(y, x, z, half);
        for (int r = -1; r < 2 && sort < 4; r += sort == 3 ? 3 : 1)
            row(y, x + (sort == 3 ? 0 : 0.6 * wide * r), z, half, sort);
        if (sort == 4) {
            kit_begin_object(b, "flowers", -1);
            garden_sow_flowers(y, x, z, 0.85 * wide, 0.9 * half, 45, 0.45);
        }
        garden_sight_above(y, x, 0.3, z + kit_between(b, -0.5, 0.5) * half, 0.7);
    }
    garden_set_border(y, fence, -edge, -edge, 0, 2 * edge);
    garden_set_border(y, fence, edge, edge, 90, 2 * edge);
    if (kit_odds(b, 0.6)) garden_set_border(y, fence, -edge, edge, 0, 2 * edge);
    if (kit_odds(b, 0.6)) garden_set_house(y, -edge - 0.4, 0, 90, edge, 2.4);
    for (int k = 0; k < 3; k++) {
        if (!garden_find_spot(y, 1, edge - 0.5, 0.6, at)) continue;
        const kit_frame before = garden_set_out(y, k ? "crate" : "barrow", at[0], at[1], kit_between(b, 0, 360));
        if (k) garden_put_crate(b);
        else garden_put_barrow(b);
        kit_leave(b, before);
        garden_sight_above(y, at[0], 0.3, at[1], 0.6);
    }
    for (int k = 1 + kit_choose(b, 2); k > 0; k--)
        if (garden_find_spot(y, edge - 1, edge + 3, 0.5, at)) garden_set_tree(y, at[0], at[1], KIT_APPLE, 2);
    garden_sow_grass(y, 2500, 0.15, edge, 12);
    garden_set_far_trees(y, 36, edge + 8, 50);
}

/* Vines along wires between posts. */
static void vines(kit_yard *y, double x, double half)
{
    const kit_foil leaf = { KIT_POINTED, 0.14, 0.13, 0.7, 0 };
    kit_build *b = &y->p->b;
    kit_begin_object(b, "vines", -1);
    for (double z = -half; z < half && garden_has_room(y); z += 1.1) {
        const kit_frame before = garden_set_out(y, NULL, x, z, 0);
        const double foot[3] = { 0, -0.05, 0 }, post[2][3] = { { 0.06, -0.2, 0.5 }, { 0.06, 1.75, 0.5 } };
        double at[6][3], way[3] = { kit_between(b, -0.2, 0.2), 1, kit_between(b, -0.3, 0.3) };
        kit_colour(b, 0.45, 0.4, 0.35);
        kit_tube(b, post, 2, 0.03, 7);
        for (int k = 0; k < 3; k++) {
            const double h = 0.8 + 0.4 * k;
            kit_cable(b, (const double[3]){ 0.09, h, -0.6 }, (const double[3]){ 0.09, h, 0.5 }, 0.01, 0.003, 4);
        }
        garden_wander(b, foot, way, 0.9, 1.2, 0, at, 6);
        kit_colour(b, 0.25, 0.19, 0.14);
        garden_grow_limb(b, &(kit_limb){ (const double(*)[3])at, 6, 0.035, 0.02, 0.01, 0, 6, 0 });
        for (int k = 0; k < 60; k++) {
            const double from[3] = { kit_between(b, -0.12, 0.2), kit_between(b, 0.7, 1.8), kit_between(b, -0.6, 0.5) };
            double out[3], across[3];
            garden_lean((const double[3]){ 0, -1, 0 }, kit_between(b, 0.3, 1.5), kit_between(b, 0, 2 * KIT_PI), out,
                        across);
            kit_colour(b, kit_between(b, 0.18, 0.32), kit_between(b, 0.26, 0.36), 0.1);
            garden_grow_leaf(b, &leaf, from, out, across);
        }
        kit_leave(b, before);
    }
    garden_sight_above(y, x, 1.1, kit_between(b, -0.4, 0.4) * half, 1);
    for (double z = -half; z < half; z += 0.6) garden_take(y, x, z, 0.4);
}

static void orchard_tree(kit_yard *y, double x, double z, int kind)
{
    kit_build *b = &y->p->b;
    const double r = hypot(x, z), dx = kit_between(b, -0.3, 0.3), dz = kit_between(b, -0.3, 0.3);
    garden_set_tree(y, x + dx, z + dz, kind, r < 5 ? 2 : r < 10 ? 1 : 0);
    garden_take(y, x + dx, z + dz, 0.5);
    if (r > 6 || kit_odds(b, 0.8)) return;
    const kit_frame before = garden_set_out(y, "ladder", x + dx, z + dz + 0.85, 180);
    garden_put_ladder(b, kit_between(b, 2.2, 3));
    kit_leave(b, before);
    garden_sight_above(y, x, 1, z + 0.8, 1);
}

void kit_lay_orchard(kit_yard *y)
{
    kit_build *b = &y->p->b;
    const double apart = kit_between(b, 3, 4.5);
    const int vineyard = kit_odds(b, 0.35), kind = kit_odds(b, 0.75) ? KIT_APPLE : KIT_OAK;
    double at[2];
    KIT_TINT(b, lawns, 0.12);
    garden_lay_ground(y, kit_between(b, 0.05, 0.3), 0.12, 0, kit_between(b, 2, 12));
    for (int k = -3; k <= 3 && vineyard; k++) vines(y, k * kit_between(b, 1.9, 2.1), kit_between(b, 8, 10));
    for (int k = 0; k < 25 && !vineyard; k++) orchard_tree(y, (k % 5 - 2.4) * apart, (k / 5 - 2.4) * apart, kind);
    if (kit_odds(b, 0.6)) garden_set_border(y, kit_choose(b, 3), -10, -12, 0, 20);
    for (int k = 0; k < 5; k++) {
        if (!garden_find_spot(y, 1, 6, 0.5, at)) continue;
        const kit_frame before = garden_set_out(y, k ? "crate" : "barrow", at[0], at[1], kit_between(b, 0, 360));
        if (k) garden_put_crate(b);
        else garden_put_barrow(b);
        const kit_frame stacked = kit_enter(b, 0.02, 0.28, 0.01, kit_between(b, -12, 12), 1);
        if (k == 1) garden_put_crate(b);
        kit_leave(b, stacked);
        kit_leave(b, before);
        garden_sight_above(y, at[0], 0.25, at[1], 0.6);
    }
    garden_set_bushes(y, kit_choose(b, 4), 7, 12, 1.2);
    if (y->season == KIT_AUTUMN) garden_sow_litter(y, 2000, 9);
    garden_sow_grass(y, 9000, kit_between(b, 0.1, 0.35), 7, 16);
    garden_set_far_trees(y, 30, 20, 55);
}
