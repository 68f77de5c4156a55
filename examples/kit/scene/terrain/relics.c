/* relics.c - landscapes by seed that one is close to: ruins, standing stones, caves, ground seen from a span above it.
   Declared in terrain.h. */
#include "kit/scene/terrain/terrain.h"
#include <math.h>
#include <string.h>

/* ---- >>ruins ----------------------------------------------------------------------------------------------------- */

/* columns in rows, some broken, some of their drums fallen, some with a beam */
static void colonnade(kit_site *s, kit_spot at, double turn, int columns)
{
    kit_build *b = s->b;
    const double r = kit_between(b, 0.3, 0.5), tall = kit_between(b, 3, 6), gap = kit_between(b, 2, 3.2),
                 length = gap * (columns - 1);
    double old = 0;
    for (int k = 0; k < columns; k++) {
        const int whole = kit_odds(b, 0.45);
        const double high = whole ? tall : tall * kit_between(b, 0.08, 0.8);
        kit_begin_object(b, "column", -1);
        kit_frame before = kit_enter(b, at.x, land_height(s->p, at.x, at.z), at.z, turn, 1);
        land_stone_colour(s);
        kit_place_at(b, k * gap - 0.5 * length, -0.5, 0, 0);
        kit_bevelled(b, -1.35 * r, 0, -1.35 * r, 1.35 * r, 0.7, 1.35 * r, 0.03);
        kit_place_at(b, k * gap - 0.5 * length, 0.2, 0, kit_between(b, 0, 360));
        land_drum_column(b, r, high, !whole);
        if (whole) {
            kit_place_at(b, k * gap - 0.5 * length, 0.2 + high, 0, 0);
            kit_bevelled(b, -1.3 * r, 0, -1.3 * r, 1.3 * r, 0.3, 1.3 * r, 0.05);
            if (old > 0) kit_bevelled(b, -gap, 0.301, -r, 0.2 * r, 0.85, r, 0.03);
        } else if (kit_odds(b, 0.6)) {
            kit_place_tilted(b, k * gap - 0.5 * length, 0.9 * r, kit_between(b, 0.5, 1), kit_between(b, -50, 50), 90);
            land_drum_column(b, 0.94 * r, kit_between(b, 0.6, 2), 1);
        }
        old = whole;
        kit_leave(b, before);
    }
    land_see(s, at, 0.5 * tall, 0.6 * tall);
    land_see(s, at, 1, 2);
}

/* walls about a rectangle, with what has fallen from them */
static void ruined_house(kit_site *s, kit_spot at)
{
    kit_build *b = s->b;
    const double turn = kit_between(b, 0, 360), w = kit_between(b, 4, 9), d = kit_between(b, 3, 7),
                 h = kit_between(b, 1.5, 5), thick = kit_between(b, 0.35, 0.7), course = kit_between(b, 0.22, 0.5);
    const int bevelled = course > 0.34;
    const double wall[4][4] = {
        { 0, 0, 0, w }, { 0, d, 0, w }, { 0, d - 0.5 * thick, 90, d - thick }, { w, d - 0.5 * thick, 90, d - thick }
    };
    for (int k = 0; k < 4; k++) {
        if (kit_odds(b, 0.15)) continue;
        kit_begin_object(b, "wall", -1);
        const kit_frame before = land_enter_at(s, at, 0.3, turn, 1);
        kit_place_at(b, wall[k][0], 0, wall[k][1], wall[k][2]);
        land_stone_colour(s);
        land_ruined_wall(b, wall[k][3], h * kit_between(b, 0.5, 1), thick, course, bevelled);
        kit_leave(b, before);
    }
    s->stones = KIT_BLOCKS;
    land_strew(s, "rubble", at, 0.7 * w, 40, 0.08, 0.35);
    land_see(s, at, 0.4 * h, 2.5);
    land_see(s, at, 1, 1);
}

/* slabs that do not lie quite level, some missing */
static void paving(kit_site *s, kit_spot at, int across)
{
    kit_build *b = s->b;
    kit_begin_object(b, "paving", -1);
    for (int j = 0; j < across; j++)
        for (int i = 0; i < across; i++) {
            const kit_spot to = { at.x + i - 0.5 * across, at.z + j - 0.5 * across };
            if (kit_odds(b, 0.2)) continue;
            const kit_frame before = land_enter_at(s, to, 0.12, kit_between(b, -2, 2), 1);
            kit_place_tilted(b, 0, 0, 0, 0, kit_between(b, -2.5, 2.5));
            land_stone_colour(s);
            kit_bevelled(b, -0.48, 0, -0.48, 0.48, 0.17, 0.48, 0.02);
            kit_leave(b, before);
        }
    land_see(s, at, 0.1, 1.5);
}

void kit_ruins(kit_site *s)
{
    static const kit_soil *const soils[] = { &kit_grassy, &kit_limestone, &kit_sand, &kit_buff_rock, &kit_heath };
    kit_build *b = s->b;
    const int way = kit_choose(b, 3);
    s->soil = *soils[kit_choose(b, 5)];
    if (kit_odds(b, 0.5)) memcpy(s->soil.steep, kit_limestone.steep, sizeof kit_limestone.steep);
    land_set_land(s, s->soil.level[0] > 0.7f ? KIT_DUNES : KIT_HILLS, kit_between(b, 25, 50), kit_between(b, 1.5, 6), 0,
                  0);
    land_lay_ground(s, 250, 0.25, 20, 0);
    for (int k = way ? land_some(s, 1, 3) : 0; k > 0; k--)
        colonnade(s, land_any_spot(s, 0, 8), kit_choose(b, 2) * 90 + kit_between(b, -5, 5), land_some(s, 3, 6));
    for (int k = way != 1 ? land_some(s, 1, 4) : 0; k > 0; k--) ruined_house(s, land_any_spot(s, 2, 14));
    if (kit_odds(b, 0.6)) paving(s, land_level_spot(s, 0, 5), land_some(s, 4, 9));
    land_strew_rocks(s, land_some(s, 5, 20), 1, 25, 0.2, 1.2);
    land_strew_heaps(s, land_some(s, 3, 8), 40, 12, 0.05, 0.35);
    land_put_tufts(s, land_some(s, 1, 7), 9, 14, 0.5);
    land_put_bare_trees(s, land_some(s, 0, 3), 14, 6);
    land_put_firs(s, land_some(s, 0, 4), 5, 14, 50, 8);
    if (kit_odds(b, 0.3)) land_put(s, KIT_LADDER, 1, 6, 3.5);
}

/* ---- >>standing stones ------------------------------------------------------------------------------------------- */

/* a ring of them, some missing, some with lintels */
static void ring(kit_site *s, double radius, int count, double tall, int lintels)
{
    kit_build *b = s->b;
    const double width = 2 * KIT_PI * radius / count * kit_between(b, 0.35, 0.6),
                 thick = width * kit_between(b, 0.4, 0.8);
    for (int k = 0; k < count; k++) {
        const double a = 2 * KIT_PI * k / count, middle = a + KIT_PI / count,
                     high = lintels ? tall : tall * kit_between(b, 0.5, 1.15);
        const kit_spot at = { radius * cos(a), radius * sin(a) };
        if (kit_odds(b, 0.15)) continue;
        kit_begin_object(b, "menhir", -1);
        kit_frame before = land_enter_at(s, at, 0, 90 - a * 180 / KIT_PI, 1);
        const int fallen = kit_odds(b, 0.12);
        kit_place_tilted(b, 0, fallen ? 0.4 * thick : 0, 0, kit_between(b, -12, 12),
                         fallen ? 85 : kit_between(b, -6, 6));
        land_stone_colour(s);
        land_menhir(b, width, thick, high);
        kit_leave(b, before);
        if (k % 4 == 0) land_see(s, at, 0.5 * high, 0.7 * high);
        if (!lintels || kit_odds(b, 0.4)) continue;
        const double half[3] = { KIT_PI * radius / count * 1.05, 0.28 * thick + 0.1, 0.45 * thick };
        kit_begin_object(b, "lintel", -1);
        before = kit_enter(b, radius * cos(middle), land_height(s->p, at.x, at.z) + 0.86 * tall + half[1],
                           radius * sin(middle), 90 - middle * 180 / KIT_PI, 1);
        land_cut_stone(b, half, 3, 0.15);
        kit_leave(b, before);
    }
}

void kit_standing_stones(kit_site *s)
{
    static const kit_soil *const soils[] = { &kit_grassy, &kit_heath, &kit_alpine, &kit_ice };
    kit_build *b = s->b;
    s->soil = *soils[kit_choose(b, 4)];
    memcpy(s->soil.steep, kit_heath.steep, sizeof kit_heath.steep);
    land_set_land(s, KIT_HILLS, kit_between(b, 25, 60), kit_between(b, 1.5, 8), 0, 0);
    land_lay_ground(s, 300, 0.2, 18, 0);
    const double tall = kit_between(b, 1.6, 4.5), radius = kit_between(b, 4, 9);
    ring(s, radius, land_some(s, 8, 20), tall, kit_odds(b, 0.5));
    if (kit_odds(b, 0.5)) ring(s, 0.5 * radius, land_some(s, 4, 7), 1.3 * tall, kit_odds(b, 0.5));
    land_strew_rocks(s, land_some(s, 5, 25), 1, 25, 0.2, 1.2);
    land_strew_heaps(s, land_some(s, 1, 4), 40, 12, 0.05, 0.3);
    land_put_tufts(s, land_some(s, 2, 8), 10, 10, 0.45);
    land_put_bare_trees(s, land_some(s, 0, 3), 14, 6);
    if (kit_odds(b, 0.5)) land_put(s, KIT_CAIRN, 2, 9, 1.6);
    if (kit_odds(b, 0.4)) land_fence_somewhere(s, 16);
}

/* ---- >>cave ------------------------------------------------------------------------------------------------------ */

/* half axes, and which part of u and v is there */
typedef struct shell {
    double half[3], part[4];
} shell;

static void shell_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const shell *s = shape;
    const double a = 2 * KIT_PI * (s->part[0] + (s->part[1] - s->part[0]) * u),
                 t = KIT_PI * (s->part[2] + (s->part[3] - s->part[2]) * v);
    const double d[3] = { sin(t) * cos(a), -cos(t), sin(t) * sin(a) };
    for (int i = 0; i < 3; i++) {
        out->p[i] = s->half[i] * d[i];
        out->n[i] = -d[i] / s->half[i];
    }
    kit_unit(out->n);
}

/* the walls and the roof about the origin, open towards +x from v0 up to v1 over a part of the turn */
static void cave_shell(kit_site *s, const double half[3], double mouth, int cells)
{
    const double lip = 0.66;
    const int kept = (int)((1 - mouth) * 2 * cells), high = (int)(cells * (1 - lip)) + 1;
    const double off = 0.5 * mouth;
    const shell parts[2] = { { { half[0], half[1], half[2] }, { off, off + kept * 0.5 / cells, 0.3, lip } },
                             { { half[0], half[1], half[2] }, { off, 1 + off, lip, 1 } } };
    const unsigned seed = (unsigned)kit_choose(s->b, 100000);
    const double scale = kit_between(s->b, 1.5, 3) / half[0];
    for (int k = 0; k < 2; k++) {
        const kit_rough r = { shell_surface, &parts[k], seed, scale, 0.24 * half[1], 4 };
        kit_patch(s->b, k ? 2 * cells : kept, k ? high : cells / 2, land_rough_surface, &r);
    }
}

/* how high the roof is, without its roughness */
static double roof(const double half[3], kit_spot at)
{
    const double x = at.x / half[0], z = at.z / half[2];
    return half[1] * sqrt(fmax(0.01, 1 - x * x - z * z));
}

static void dripstones(kit_site *s, const double half[3], int count, double u)
{
    kit_build *b = s->b;
    for (int k = 0; k < count; k++) {
        kit_spot at = land_any_spot(s, 0, 0.8 * fmin(half[0], half[2]));
        const double top = roof(half, at), ground = land_height(s->p, at.x, at.z),
                     length = u * kit_between(b, 0.6, 2.5), thick = length * kit_between(b, 0.07, 0.16);
        const int way = kit_choose(b, 4);
        kit_begin_object(b, way > 2 ? "pillar" : "dripstone", -1);
        land_stone_colour(s);
        if (way != 1) {
            kit_place_tilted(b, at.x, top + 0.12 * half[1], at.z, 0, 180);
            land_spire(b, thick * (way > 2 ? 3 : 1.4),
                       0.25 * half[1] + (way > 2 ? 0.75 : 0.2 + 0.1 * length) * (top - ground), 0.2, 12);
        }
        if (way) {
            kit_place_at(b, at.x, ground, at.z, 0);
            land_spire(b, thick * (way > 2 ? 3 : 1.5), way > 2 ? 0.6 * (top - ground) : length, 0.25, 12);
            land_see(s, at, 0.4 * length, 0.6 * length);
        }
        kit_place_at(b, 0, 0, 0, 0);
    }
}

void kit_cave(kit_site *s)
{
    static const kit_soil *const soils[] = { &kit_limestone, &kit_buff_rock, &kit_gravel, &kit_ice, &kit_basalt };
    kit_build *b = s->b;
    const double u = kit_between(b, 0.7, 2), half[3] = { 9 * u * kit_between(b, 0.8, 1.3), u * kit_between(b, 3.2, 6),
                                                         8 * u * kit_between(b, 0.7, 1.2) };
    const double mouth = kit_odds(b, 0.7) ? kit_between(b, 0.06, 0.2) : 0;
    const int choice = kit_choose(b, 5);
    s->unit = u;
    s->soil = *soils[choice];
    if (choice < 3) memcpy(s->soil.level, kit_gravel.level, sizeof kit_gravel.level);
    land_set_land(s, KIT_PLAIN, 4 * u, 0.9 * u, 6, 0);
    land_lay_ground(s, 200, 0.1 * u, 0.6 * fmin(half[0], half[2]), 0);
    kit_begin_object(b, "cave", 0);
    land_stone_colour(s);
    cave_shell(s, half, mouth, land_some(s, 28, 60));
    s->p->ceiling = 0.55 * half[1];
    if (kit_odds(b, 0.4)) land_lay_water(s, 0.9 * half[0], kit_between(b, -0.25, 0) * u);
    if (kit_odds(b, 0.75)) dripstones(s, half, land_some(s, 8, 40), u);
    land_strew_rocks(s, land_some(s, 6, 30), u, 0.85 * half[0], 0.2 * u, u * kit_between(b, 0.5, 1.3));
    land_strew_heaps(s, land_some(s, 3, 8), 40, 0.5 * half[0], 0.04 * u, 0.3 * u);
    if (kit_odds(b, 0.4)) land_put(s, KIT_LADDER, 1, 0.4 * half[0], 3);
    if (kit_odds(b, 0.4)) land_put_some(s, KIT_LOGS, land_some(s, 1, 2), 1, 0.5 * half[0], 1.5, 3);
    if (kit_odds(b, 0.3)) land_put(s, KIT_TENT, 1, 0.4 * half[0], 2.4);
    if (kit_odds(b, 0.3)) land_jetty(s, (kit_spot){ -3, 1 }, kit_between(b, 0, 360), 5, 0.5);
    for (int k = 0; k < 4; k++) {
        const kit_spot at = land_any_spot(s, 0.2 * half[0], 0.6 * fmin(half[0], half[2]));
        kit_add_lamp(s->p, at.x, land_height(s->p, at.x, at.z) + 0.35 * half[1], at.z);
        land_see(s, at, 0.2 * half[1], 0.2 * half[0]);
    }
}

/* ---- >>close to the ground --------------------------------------------------------------------------------------- */

void kit_pebble_ground(kit_site *s)
{
    static const kit_soil *const soils[] = { &kit_gravel, &kit_sand, &kit_limestone, &kit_basalt, &kit_grassy };
    kit_build *b = s->b;
    const double u = s->unit = kit_between(b, 0.12, 0.4);
    s->soil = *soils[kit_choose(b, 5)];
    s->stones = kit_odds(b, 0.6) ? KIT_WORN : kit_choose(b, KIT_STONE_KINDS);
    land_set_land(s, KIT_PLAIN, 4 * u, 0.5 * u, 40, 0);
    land_lay_ground(s, 120, 0.08 * u, 6 * u, 0);
    memcpy(s->soil.steep, kit_odds(b, 0.5) ? kit_heath.steep : s->soil.steep, sizeof s->soil.steep);
    const int dense = kit_odds(b, 0.5);
    for (int k = 0; k < (dense ? 14 : 5); k++)
        land_strew(s, "pebbles", land_any_spot(s, 0, 4 * u), 5 * u, 60, 0.07 * u, 0.4 * u);
    land_strew_rocks(s, land_some(s, 8, 40), 0.2 * u, 8 * u, 0.2 * u, u * kit_between(b, 0.5, 1.5));
    if (kit_odds(b, 0.6)) land_put_some(s, KIT_SHELL, land_some(s, 3, 15), 0.1 * u, 4 * u, 0.1 * u, 0.4 * u);
    if (kit_odds(b, 0.7)) land_put_some(s, KIT_DRIFTWOOD, land_some(s, 2, 9), 0.1 * u, 5 * u, u, 4 * u);
    land_put_tufts(s, land_some(s, 0, 6), land_some(s, 4, 10), 5 * u, kit_between(b, 0.8, 2) * u);
    if (kit_odds(b, 0.3)) land_put(s, KIT_CAIRN, u, 4 * u, 2 * u);
    land_strew_rocks(s, land_some(s, 3, 9), 3, 40, 0.3, 2);
    land_put_bare_trees(s, land_some(s, 0, 2), 20, 6);
    land_put_firs(s, land_some(s, 0, 4), 8, 20, 60, 8);
}
