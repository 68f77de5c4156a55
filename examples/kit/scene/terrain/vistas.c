/* vistas.c - landscapes by seed that are large, or of rock more than of things: canyons, mountains, mesas, cliffs by
   the sea, highlands, tors. Declared in terrain.h. */
#include "kit/scene/terrain/terrain.h"
#include <math.h>
#include <string.h>

static const kit_soil *one_of(kit_site *s, const kit_soil *const soils[], int count)
{
    return soils[kit_choose(s->b, count)];
}

#define ONE_OF(s, soils) *one_of(s, soils, (int)(sizeof soils / sizeof *soils))

void kit_canyon(kit_site *s)
{
    static const kit_soil *const soils[] = { &kit_red_rock, &kit_red_rock, &kit_buff_rock, &kit_limestone };
    kit_build *b = s->b;
    const int vast = kit_odds(b, 0.45);
    const double u = s->unit = vast ? kit_between(b, 8, 25) : 1, length = 12 * u * kit_between(b, 0.8, 1.5);
    s->soil = ONE_OF(s, soils);
    s->stones = kit_choose(b, 3);
    land_set_land(s, KIT_CANYON, length, length * kit_between(b, 0.6, 1.1), land_some(s, 4, 9),
                  kit_between(b, 0.25, 0.6));
    if (kit_odds(b, 0.3)) s->p->of[KIT_OF_LEVEL] = 0.01 * length;
    land_lay_ground(s, 250 + 10 * length, 0.22 * u, 0.8 * length, 0.045 * length);
    if (s->p->of[KIT_OF_LEVEL] > -1) land_lay_water(s, 250 + 10 * length, 0.01 * length);
    land_strew_rocks(s, land_some(s, 10, 40), u, 1.2 * length, 0.3 * u, u * kit_between(b, 1, 3));
    land_strew_heaps(s, land_some(s, 4, 10), land_some(s, 30, 60), 0.8 * length, 0.06 * u, 0.4 * u);
    land_see_land(s, 9, 0.3 * length, 1.6 * length, 0.3 * length);
    if (vast) land_put_firs(s, land_some(s, 0, 8), 12, 0, length, kit_between(b, 7, 15));
    else {
        land_put_bare_trees(s, land_some(s, 0, 3), 8, 4);
        land_put_tufts(s, land_some(s, 0, 5), 8, 8, 0.4);
        land_put_some(s, KIT_DRIFTWOOD, land_some(s, 0, 3), 1, 6, 1, 3);
        land_put_some(s, KIT_CACTUS, land_some(s, 0, 4), 1, 9, 1, 3);
    }
    if (kit_odds(b, 0.4)) land_put(s, KIT_ARCH, 0.2 * length, 0.7 * length, kit_between(b, 2, 4) * u);
    if (kit_odds(b, 0.4)) land_put_spires(s, land_some(s, 1, 4), 0.3 * length, length, 0.4 * length, kit_choose(b, 2));
}

void kit_mountains(kit_site *s)
{
    static const kit_soil *const soils[] = { &kit_alpine, &kit_alpine, &kit_heath, &kit_limestone, &kit_ice };
    kit_build *b = s->b;
    const double length = kit_between(b, 300, 1500), height = length * kit_between(b, 0.6, 1.0);
    s->unit = 0.03 * length;
    s->soil = ONE_OF(s, soils);
    land_set_land(s, KIT_ALPS, length, height, 0, 0);
    s->soil.above = height * kit_between(b, 0.3, 0.7);
    land_lay_ground(s, 7 * length, 0.025 * length, length, 0.01 * length);
    if (kit_odds(b, 0.4)) land_lay_water(s, 7 * length, height * kit_between(b, 0.03, 0.09));
    land_see_land(s, 10, 0.3 * length, 1.8 * length, 0.3 * length);
    land_see_land(s, 6, 0.1 * length, 0.8 * length, 0.08 * length);
    land_put_firs(s, land_some(s, 4, 14), land_some(s, 10, 25), 0, length, kit_between(b, 10, 22));
    land_strew_rocks(s, land_some(s, 5, 25), 0, 0.8 * length, 0.005 * length, 0.02 * length);
    for (int k = land_some(s, 0, 2); k > 0; k--) land_put_hut(s, 0, 0.4 * length);
}

void kit_great_mesas(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 250, 700), height = length * kit_between(b, 0.3, 0.6);
    s->unit = 0.03 * length;
    s->soil = kit_odds(b, 0.7) ? kit_red_rock : kit_buff_rock;
    s->stones = kit_choose(b, 3);
    land_set_land(s, KIT_MESAS, length, height, land_some(s, 2, 5), kit_between(b, 0.3, 0.6));
    land_lay_ground(s, 9 * length, 0.025 * length, length, 0.02 * length);
    land_see_land(s, 10, 0.5 * length, 2 * length, 0.3 * length);
    land_put_spires(s, land_some(s, 0, 6), 0.3 * length, 1.2 * length, 0.35 * length, 0);
    if (kit_odds(b, 0.5)) land_put(s, KIT_ARCH, 0.1 * length, 0.5 * length, 0.06 * length);
    land_strew_rocks(s, land_some(s, 10, 40), 0, length, 0.004 * length, 0.025 * length);
    land_put_some(s, KIT_CACTUS, land_some(s, 2, 9), 2, 30, 2, 6);
    if (kit_odds(b, 0.4)) land_fence_somewhere(s, 30);
}

void kit_sea_stacks(kit_site *s)
{
    static const kit_soil *const soils[] = { &kit_chalk, &kit_limestone, &kit_heath, &kit_buff_rock, &kit_basalt };
    kit_build *b = s->b;
    const double u = s->unit = kit_odds(b, 0.5) ? kit_between(b, 5, 15) : kit_between(b, 1, 2), length = 16 * u;
    s->soil = ONE_OF(s, soils);
    s->stones = kit_choose(b, 3);
    land_set_land(s, KIT_SHORE, length, length * kit_between(b, 0.5, 0.9), kit_between(b, 0.9, 1.1),
                  kit_odds(b, 0.5) ? 1 : -1);
    s->p->of[KIT_OF_LEVEL] = -0.01 * length;
    land_lay_ground(s, 300 + 12 * length, 0.25 * u, length, 0.04 * length);
    land_lay_water(s, 300 + 12 * length, -0.02 * length);
    land_put_spires(s, land_some(s, 3, 9), 0.2 * length, 1.2 * length, 0.45 * length, 0);
    if (kit_odds(b, 0.6)) land_put(s, KIT_ARCH, 0.2 * length, 0.8 * length, 3 * u);
    land_strew_rocks(s, land_some(s, 15, 50), u, length, 0.2 * u, 1.6 * u);
    land_strew_heaps(s, land_some(s, 3, 8), 50, 0.6 * length, 0.05 * u, 0.4 * u);
    land_see_land(s, 8, 0.4 * length, 1.5 * length, 0.25 * length);
    land_put_some(s, KIT_DRIFTWOOD, land_some(s, 0, 5), 1, 9, 1, 4);
    if (kit_odds(b, 0.5)) land_put(s, KIT_BOAT, 1, 0.5 * length, 5);
    if (kit_odds(b, 0.3)) land_put_hut(s, 0.2 * length, 0.9 * length);
}

void kit_great_dunes(kit_site *s)
{
    kit_build *b = s->b;
    const double length = kit_between(b, 80, 300);
    s->unit = 0.03 * length;
    s->soil = kit_sand;
    land_set_land(s, KIT_DUNES, length, length * kit_between(b, 0.2, 0.3), 0, 0);
    land_lay_ground(s, 10 * length, 0.02 * length, length, 0);
    land_see_land(s, 10, 0.1 * length, length, 0.25 * length);
    memcpy(s->soil.steep, kit_red_rock.steep, sizeof kit_red_rock.steep);
    land_put_spires(s, land_some(s, 2, 8), 0.1 * length, length, 0.3 * length, kit_choose(b, 2));
    land_strew_rocks(s, land_some(s, 10, 30), 0, 0.8 * length, 0.01 * length, 0.06 * length);
    land_put_bare_trees(s, land_some(s, 2, 9), 0.3 * length, 8);
    if (kit_odds(b, 0.6)) land_put(s, KIT_WRECK, 3, 0.3 * length, 0.15 * length);
    for (int k = land_some(s, 0, 2); k > 0; k--) land_put_hut(s, 2, 0.3 * length);
}

void kit_highlands(kit_site *s)
{
    static const kit_soil *const soils[] = { &kit_grassy, &kit_heath, &kit_alpine, &kit_chalk };
    kit_build *b = s->b;
    const double length = kit_between(b, 100, 500);
    s->unit = 0.03 * length;
    s->soil = ONE_OF(s, soils);
    land_set_land(s, KIT_HILLS, length, length * kit_between(b, 0.3, 0.6), 0, 0);
    s->soil.above = s->p->of[KIT_OF_HEIGHT] * kit_between(b, 0.7, 1.2);
    land_lay_ground(s, 9 * length, 0.02 * length, length, kit_odds(b, 0.5) ? 0.02 * length : 0);
    land_see_land(s, 8, 0.1 * length, length, 0.25 * length);
    land_put_firs(s, land_some(s, 3, 15), land_some(s, 8, 20), 0, 0.6 * length, kit_between(b, 8, 16));
    land_strew_rocks(s, land_some(s, 20, 60), 0, 0.6 * length, 0.005 * length, 0.03 * length);
    for (int k = land_some(s, 0, 3); k > 0; k--) land_put_hut(s, 2, 0.3 * length);
    for (int k = land_some(s, 0, 3); k > 0; k--) land_fence_somewhere(s, fmin(60, 0.2 * length));
    land_put_bare_trees(s, land_some(s, 0, 4), 0.2 * length, 10);
}

void kit_hoodoos(kit_site *s)
{
    kit_build *b = s->b;
    const double u = s->unit = kit_between(b, 1, 5);
    s->soil = kit_odds(b, 0.5) ? kit_red_rock : kit_buff_rock;
    s->stones = kit_odds(b, 0.5) ? KIT_LAYERED : KIT_ROUND;
    land_set_land(s, kit_odds(b, 0.5) ? KIT_MESAS : KIT_HILLS, 20 * u, 8 * u, land_some(s, 2, 5), 0.5);
    land_lay_ground(s, 400, 0.2 * u, 18 * u, 0.5 * u);
    land_put_spires(s, land_some(s, 15, 45), 2 * u, 18 * u, kit_between(b, 3, 6) * u, kit_odds(b, 0.6));
    land_strew_rocks(s, land_some(s, 10, 30), u, 20 * u, 0.2 * u, u * kit_between(b, 0.7, 1.5));
    land_strew_heaps(s, land_some(s, 3, 8), 40, 12 * u, 0.04 * u, 0.3 * u);
    land_put_tufts(s, land_some(s, 0, 4), 7, 8, 0.4);
    land_put_bare_trees(s, land_some(s, 0, 3), 12, 4);
    if (kit_odds(b, 0.5)) land_put(s, KIT_ARCH, 4 * u, 12 * u, 3 * u);
}

/* large stones on each other, about a middle */
static void tor(kit_site *s, kit_spot at, double size)
{
    kit_build *b = s->b;
    kit_begin_object(b, "tor", -1);
    for (int k = 0, count = land_some(s, 5, 14); k < count; k++) {
        const double tier = floor(k / 4.0), r = size * kit_between(b, 0.7, 1.1) * (1 - 0.13 * tier);
        const kit_spot off = land_any_spot(s, 0, size * fmax(0.15, 1.4 - 0.5 * tier)),
                       to = { at.x + off.x, at.z + off.z };
        const kit_frame before = land_enter_at(s, at, -size * (0.35 + 0.85 * tier), 0, 1);
        kit_place_tilted(b, to.x - at.x, 0, to.z - at.z, kit_between(b, 0, 360), kit_between(b, -12, 12));
        land_stone_colour(s);
        land_stone(s, r, 14);
        kit_leave(b, before);
    }
    land_see(s, at, 1.2 * size, 2 * size);
}

void kit_tors(kit_site *s)
{
    static const kit_soil *const soils[] = { &kit_grassy, &kit_heath, &kit_buff_rock, &kit_gravel };
    kit_build *b = s->b;
    const double most = kit_between(b, 1, 2.5);
    s->soil = ONE_OF(s, soils);
    land_set_land(s, KIT_HILLS, kit_between(b, 15, 30), kit_between(b, 2, 7), 0, 0);
    land_lay_ground(s, 250, 0.25, 20, 0);
    for (int k = land_some(s, 2, 7); k > 0; k--) tor(s, land_any_spot(s, 2, 16), most * kit_between(b, 0.6, 1));
    land_strew_rocks(s, land_some(s, 15, 60), 1, 30, 0.2, 1.6 * most);
    land_strew_heaps(s, land_some(s, 2, 5), 40, 12, 0.06, 0.4);
    land_put_tufts(s, land_some(s, 1, 7), 10, 14, 0.5);
    land_put_bare_trees(s, land_some(s, 0, 3), 14, 5);
    if (kit_odds(b, 0.4)) land_fence_somewhere(s, 14);
    if (kit_odds(b, 0.4)) land_put(s, KIT_TENT, 2, 9, 2.6);
}
