/* terrain.c - landscapes by seed: which ground, and what lies, grows and was built on it. Declared in kit_seed.h. */
#include "kit/scene/terrain/terrain.h"
#include <math.h>
#include <string.h>

/* ---- >>as large as people ---------------------------------------------------------------------------------------- */

static void hills(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 12, 40);
    s->soil = kit_odds(b, 0.5) ? kit_grassy : kit_heath;
    land_set_land(s, KIT_HILLS, length, length * kit_between(b, 0.12, 0.35), 0, 0);
    land_lay_ground(s, 250, 0.25, 25, 0);
    land_strew_rocks(s, land_some(s, 8, 40), 2, 40, 0.3, kit_between(b, 1.2, 4));
    land_strew_heaps(s, land_some(s, 2, 6), land_some(s, 20, 60), 12, 0.06, 0.4);
    land_put_tufts(s, land_some(s, 2, 6), land_some(s, 6, 14), 12, 0.5);
    land_put_bare_trees(s, land_some(s, 0, 3), 18, 6);
    land_put_firs(s, land_some(s, 0, 4), land_some(s, 3, 9), 12, 60, 7);
    for (int k = land_some(s, 0, 2); k > 0; k--) land_fence_somewhere(s, 14);
    if (kit_odds(b, 0.3)) land_put_hut(s, 4, 14);
    if (kit_odds(b, 0.4)) land_put(s, KIT_TENT, 3, 9, 3);
    if (kit_odds(b, 0.4)) land_put(s, KIT_CAIRN, 2, 9, 1.5);
}

static void riverbed(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 9, 16);
    const int dry = kit_odds(b, 0.5);
    s->soil = kit_gravel;
    s->stones = kit_odds(b, 0.7) ? KIT_WORN : KIT_ROUND;
    land_set_land(s, KIT_RIVERBED, length, kit_between(b, 2.5, 6), kit_between(b, 0.15, 1.2), 0);
    s->p->of[KIT_OF_LEVEL] = -KIT_FOREVER;
    land_lay_ground(s, 220, 0.16, 14, 0);
    if (!dry) land_lay_water(s, 220, land_height(s->p, 0, 0) + kit_between(b, -0.02, 0.15));
    land_strew_heaps(s, land_some(s, 8, 14), land_some(s, 50, 90), 9, 0.05, 0.35);
    land_strew_rocks(s, land_some(s, 8, 25), 1, 25, 0.3, kit_between(b, 0.8, 2.5));
    land_put_some(s, KIT_DRIFTWOOD, land_some(s, 1, 6), 1, 9, 1.2, 4);
    land_put_tufts(s, land_some(s, 1, 5), land_some(s, 5, 12), 16, 0.6);
    land_put_bare_trees(s, land_some(s, 0, 3), 16, 7);
    land_put_firs(s, land_some(s, 0, 5), 7, 18, 70, 9);
    if (kit_odds(b, 0.4))
        land_jetty(s, (kit_spot){ -6, kit_between(b, -3, 3) }, kit_between(b, -30, 30), 12,
                   land_height(s->p, 0, 0) + 1);
    if (kit_odds(b, 0.3)) land_put(s, KIT_BOAT, 2, 8, 4);
}

static void scree(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 10, 30);
    static const kit_soil *const soils[] = { &kit_limestone, &kit_heath, &kit_gravel, &kit_alpine };
    s->soil = *soils[kit_choose(b, 4)];
    s->stones = kit_odds(b, 0.7) ? KIT_ANGULAR : KIT_BLOCKS;
    land_set_land(s, KIT_SCARP, length, length * kit_between(b, 0.6, 1.1), 0, 0);
    land_lay_ground(s, 250, 0.25, 0.9 * length, 0.05 * length);
    land_strew_heaps(s, land_some(s, 10, 16), land_some(s, 40, 70), 0.8 * length, 0.08, 0.6);
    land_strew_rocks(s, land_some(s, 15, 40), 1, length, 0.3, kit_between(b, 1, 3));
    land_put_bare_trees(s, land_some(s, 0, 2), 12, 5);
    land_put_tufts(s, land_some(s, 0, 4), 8, 12, 0.4);
    if (kit_odds(b, 0.5)) land_put(s, KIT_CAIRN, 1, 8, 1.8);
    if (kit_odds(b, 0.3)) land_put_hut(s, 3, 12);
    if (kit_odds(b, 0.5)) land_fence_somewhere(s, 12);
    land_see_land(s, 5, 0.5 * length, 1.2 * length, 0.25 * length);
}

static void beach(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 8, 25), c = kit_odds(b, 0.5) ? 1 : -1;
    s->soil = kit_sand;
    s->stones = kit_odds(b, 0.6) ? KIT_WORN : KIT_LAYERED;
    if (kit_odds(b, 0.5)) memcpy(s->soil.steep, kit_gravel.steep, sizeof kit_gravel.steep);
    land_set_land(s, KIT_SHORE, length, 0.3 * length, kit_between(b, 1, 2.5), c);
    s->p->of[KIT_OF_LEVEL] = -0.05 * length;
    land_lay_ground(s, 300, 0.15, 14, 0.02 * length);
    land_lay_water(s, 300, -0.03 * length);
    land_put_some(s, KIT_SHELL, land_some(s, 5, 20), 0.5, 4, 0.04, 0.14);
    land_put_some(s, KIT_DRIFTWOOD, land_some(s, 2, 8), 1, 9, 0.6, 3.5);
    land_strew_heaps(s, land_some(s, 3, 9), land_some(s, 30, 60), 8, 0.03, 0.2);
    land_strew_rocks(s, land_some(s, 5, 30), 1, 20, 0.2, kit_between(b, 0.8, 2.5));
    if (kit_odds(b, 0.6)) land_put(s, KIT_BOAT, 1, 7, kit_between(b, 3, 5));
    if (kit_odds(b, 0.4)) land_put(s, KIT_WRECK, 3, 9, kit_between(b, 6, 12));
    if (kit_odds(b, 0.5))
        land_jetty(s, land_any_spot(s, 1, 5), -s->p->of[KIT_OF_TURN] * 180 / KIT_PI - 90 + kit_between(b, -20, 20), 14,
                   0.5);
    if (kit_odds(b, 0.5)) land_fence_somewhere(s, 12);
    land_put_tufts(s, land_some(s, 0, 6), 10, 12, 0.6);
    if (kit_odds(b, 0.3)) land_put_hut(s, 4, 12);
}

static void dunes(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 12, 40);
    s->soil = kit_sand;
    land_set_land(s, KIT_DUNES, length, length * kit_between(b, 0.16, 0.26), 0, 0);
    land_lay_ground(s, 400, 0.2, 25, 0);
    if (kit_odds(b, 0.4)) land_put(s, KIT_WRECK, 2, 9, kit_between(b, 8, 14));
    for (int k = land_some(s, 1, 3); k > 0; k--) land_fence_somewhere(s, 14);
    land_put_bare_trees(s, land_some(s, 0, 3), 14, 5);
    land_put_tufts(s, land_some(s, 3, 9), land_some(s, 6, 16), 14, 0.6);
    land_strew_rocks(s, land_some(s, 3, 15), 2, 30, 0.2, kit_between(b, 0.8, 3));
    land_strew_heaps(s, land_some(s, 2, 5), 40, 12, 0.03, 0.25);
    if (kit_odds(b, 0.5)) land_put(s, KIT_ARCH, 8, 25, kit_between(b, 2, 6));
    if (kit_odds(b, 0.4)) land_put(s, KIT_TENT, 3, 9, 3.5);
    if (kit_odds(b, 0.3)) land_put_hut(s, 3, 10);
    land_see_land(s, 4, 4, 25, 0.3 * length);
}

static void desert(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 18, 45);
    s->soil = kit_odds(b, 0.6) ? kit_red_rock : kit_buff_rock;
    s->stones = kit_choose(b, 3);
    land_set_land(s, KIT_MESAS, length, kit_between(b, 6, 16), land_some(s, 2, 5), kit_between(b, 0.3, 0.6));
    land_lay_ground(s, 400, 0.25, 28, 0.4);
    land_put_some(s, KIT_CACTUS, land_some(s, 3, 12), 2, 25, 1, 5);
    land_put_some(s, KIT_PEAR, land_some(s, 2, 9), 1, 14, 0.5, 1.6);
    land_strew_rocks(s, land_some(s, 10, 40), 2, 35, 0.2, kit_between(b, 1, 3.5));
    land_strew_heaps(s, land_some(s, 3, 8), 50, 14, 0.04, 0.3);
    land_put_tufts(s, land_some(s, 1, 5), 7, 14, 0.35);
    land_put_bare_trees(s, land_some(s, 0, 2), 14, 4);
    if (kit_odds(b, 0.4)) land_put(s, KIT_ARCH, 8, 25, kit_between(b, 3, 7));
    if (kit_odds(b, 0.4)) land_fence_somewhere(s, 14);
    if (kit_odds(b, 0.3)) land_put_hut(s, 4, 14);
    land_see_land(s, 4, 8, 35, 5);
}

static void lava_field(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 5, 14);
    s->soil = kit_basalt;
    s->stones = kit_odds(b, 0.5) ? KIT_ANGULAR : KIT_ROUND;
    land_set_land(s, KIT_LAVA, length, length * kit_between(b, 0.25, 0.4),
                  kit_odds(b, 0.7) ? kit_between(b, 0.4, 1.2) : 0, 0);
    land_lay_ground(s, 250, 0.14, 16, 0);
    for (int k = land_some(s, 0, 4); k > 0; k--) {
        const kit_spot at = land_level_spot(s, 1, 12);
        const double radius = kit_between(b, 1, 3.5), tall = kit_between(b, 0.8, 4);
        const kit_frame before = land_begin_thing(s, "basalt", at, 0.3, 1);
        land_stone_colour(s);
        land_basalt_columns(b, radius, land_some(s, 4, 8), tall);
        kit_leave(b, before);
        land_see(s, at, 0.4 * tall, radius);
    }
    land_put_spires(s, land_some(s, 0, 6), 3, 20, kit_between(b, 1.5, 5), 0);
    land_strew_rocks(s, land_some(s, 10, 40), 1, 25, 0.2, kit_between(b, 0.8, 2.5));
    land_strew_heaps(s, land_some(s, 4, 10), 50, 10, 0.05, 0.4);
    land_put_tufts(s, land_some(s, 0, 5), 6, 10, 0.3);
    land_put_bare_trees(s, land_some(s, 0, 2), 10, 3.5);
    land_see_land(s, 5, 1, 14, 0.3 * length);
}

static void crevasses(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 14, 30);
    s->soil = kit_ice;
    land_set_land(s, KIT_GLACIER, length, length * kit_between(b, 0.4, 0.8), kit_between(b, 2, 5),
                  kit_between(b, 0.3, 0.8));
    s->p->of[KIT_OF_TURN] = 0;
    land_lay_ground(s, 300, 0.2, 18, 0.02 * length);
    s->stones = KIT_BLOCKS;
    land_strew_rocks(s, land_some(s, 5, 20), 2, 20, 0.4, kit_between(b, 1, 3));
    s->stones = KIT_ANGULAR;
    memcpy(s->soil.steep, kit_heath.steep, sizeof kit_heath.steep);
    land_strew_rocks(s, land_some(s, 3, 15), 1, 14, 0.2, 1.4);
    land_strew_heaps(s, land_some(s, 2, 6), 50, 12, 0.05, 0.4);
    if (kit_odds(b, 0.5)) land_put(s, KIT_TENT, 2, 8, 2.6);
    if (kit_odds(b, 0.5)) land_put(s, KIT_LADDER, 1, 6, 3.5);
    const kit_spot from = land_any_spot(s, 4, 9), to = land_any_spot(s, 4, 9);
    if (kit_odds(b, 0.5)) land_fence(s, from, to, 3);
    land_see_land(s, 8, 1, 14, 2);
    land_see_land(s, 3, 30, 50, 14);
}

/* three poles, a cable and a block that hangs from it */
static void derrick(kit_site *s, kit_spot at)
{
    kit_build *b = s->b;
    const double tall = kit_between(b, 3.5, 6), wide = 0.4 * tall, half[3] = { 0.5, 0.35, 0.4 };
    const kit_frame before = land_begin_thing(s, "derrick", at, 0.1, 1);
    kit_colour(b, 0.5, 0.35, 0.15);
    for (int k = 0; k < 3; k++) {
        const double a = 2.1 * k,
                     pole[2][3] = { { wide * cos(a), 0, wide * sin(a) }, { -0.1 * cos(a), tall, -0.1 * sin(a) } };
        kit_tube(b, pole, 2, 0.07, 9);
    }
    const double top[3] = { 0, tall - 0.2, 0 }, hook[3] = { 0, 0.45 * tall, 0 }, winch[3] = { 0.6 * wide, 1, 0 };
    kit_cable(b, top, hook, 0, 0.015, 6);
    kit_cable(b, top, winch, 0.1, 0.015, 6);
    kit_place_at(b, 0, 0.45 * tall - half[1], 0, 20);
    land_stone_colour(s);
    land_cut_stone(b, half, 2, 0.15);
    kit_leave(b, before);
    land_see(s, at, 0.4 * tall, 0.5 * tall);
}

/* blocks as they are cut, in rows and on each other */
static void block_stack(kit_site *s, kit_spot at)
{
    kit_build *b = s->b;
    const double w = kit_between(b, 0.8, 1.8), h = kit_between(b, 0.5, 1), d = kit_between(b, 0.6, 1.2);
    const kit_frame before = land_begin_thing(s, "blocks", at, 0.05, 1);
    for (int row = 0, count = land_some(s, 2, 4); row < count; row++)
        for (int k = 0; k < count - row; k++) {
            kit_place_at(b, (k + 0.5 * row) * (w + 0.12) + kit_between(b, -0.05, 0.05), row * (h + 0.06),
                         kit_between(b, -0.15, 0.15), kit_between(b, -5, 5));
            land_stone_colour(s);
            kit_bevelled(b, 0, 0, 0, w, h, d, kit_between(b, 0.01, 0.05));
            for (int i = 0; i < 2 && row; i++)
                kit_box(b, w * (0.2 + 0.5 * i), -0.06, 0.05, w * (0.3 + 0.5 * i), 0, d - 0.05);
        }
    kit_leave(b, before);
    land_see(s, at, h, 1.5 * w);
}

static void quarry(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 12, 25);
    static const kit_soil *const soils[] = { &kit_limestone, &kit_chalk, &kit_buff_rock, &kit_gravel };
    s->soil = *soils[kit_choose(b, 4)];
    s->stones = KIT_BLOCKS;
    land_set_land(s, KIT_QUARRY, length, length * kit_between(b, 0.4, 0.9), land_some(s, 3, 6),
                  kit_between(b, 0.7, 1.3));
    land_lay_ground(s, 250, 0.2, length, 0.01 * length);
    for (int k = land_some(s, 3, 9); k > 0; k--) block_stack(s, land_level_spot(s, 1, 0.8 * length));
    if (kit_odds(b, 0.7)) derrick(s, land_level_spot(s, 0.5, 5));
    land_put_some(s, KIT_LADDER, land_some(s, 0, 3), 2, 9, 3, 5);
    land_put_some(s, KIT_LOGS, land_some(s, 0, 3), 2, 9, 2, 4);
    land_strew_rocks(s, land_some(s, 8, 25), 1, length, 0.3, kit_between(b, 0.8, 2));
    land_strew_heaps(s, land_some(s, 4, 9), 60, 9, 0.05, 0.4);
    if (kit_odds(b, 0.3)) land_put_hut(s, 3, 8);
    if (kit_odds(b, 0.5)) land_fence_somewhere(s, 0.9 * length);
    land_see_land(s, 6, 0.4 * length, length, 0.2 * length);
}

/* ---- >>which ----------------------------------------------------------------------------------------------------- */

void kit_make_terrain(kit_plot *p)
{
    static land_landscape *const landscapes[] = { hills,
                                                  riverbed,
                                                  scree,
                                                  beach,
                                                  dunes,
                                                  desert,
                                                  lava_field,
                                                  crevasses,
                                                  quarry,
                                                  kit_canyon,
                                                  kit_mountains,
                                                  kit_great_mesas,
                                                  kit_sea_stacks,
                                                  kit_great_dunes,
                                                  kit_highlands,
                                                  kit_hoodoos,
                                                  kit_tors,
                                                  kit_ruins,
                                                  kit_ruins,
                                                  kit_standing_stones,
                                                  kit_cave,
                                                  kit_cave,
                                                  kit_pebble_ground,
                                                  kit_pebble_ground };
    kit_site s = { p, &p->b, kit_grassy, 1, 0 };
    s.stones = kit_choose(s.b, KIT_STONE_KINDS);
    landscapes[kit_choose(s.b, (int)(sizeof landscapes / sizeof *landscapes))](&s);
    if (kit_odds(s.b, 0.8)) land_strew_about_sights(&s, kit_between(s.b, 0.3, 1));
    while (p->sights < 6) land_see(&s, land_any_spot(&s, 0, 6 * s.unit), 0.3 * s.unit, s.unit);
}
