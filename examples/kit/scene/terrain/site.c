/* site.c - what landscapes by seed are furnished with: ground, stones, trees, fences, each where there is room for it.
   Declared in terrain.h. */
#include "kit/scene/terrain/terrain.h"
#include <math.h>
#include <string.h>

const kit_soil
    kit_grassy = { { 0.20f, 0.22f, 0.09f }, { 0.34f, 0.33f, 0.30f }, { 0.41f, 0.39f, 0.36f }, KIT_FOREVER, 0, 0.25 },
    kit_heath = { { 0.27f, 0.20f, 0.13f }, { 0.28f, 0.27f, 0.27f }, { 0.41f, 0.39f, 0.36f }, KIT_FOREVER, 0, 0.3 },
    kit_red_rock = { { 0.49f, 0.34f, 0.22f }, { 0.49f, 0.25f, 0.16f }, { 0.51f, 0.37f, 0.25f }, KIT_FOREVER, 1, 0.12 },
    kit_buff_rock = { { 0.52f, 0.44f, 0.33f }, { 0.54f, 0.44f, 0.31f }, { 0.51f, 0.37f, 0.25f }, KIT_FOREVER, 1, 0.12 },
    kit_sand = { { 0.59f, 0.48f, 0.34f }, { 0.57f, 0.45f, 0.30f }, { 0.41f, 0.37f, 0.33f }, KIT_FOREVER, 0, 0.06 },
    kit_basalt = { { 0.11f, 0.10f, 0.09f }, { 0.07f, 0.07f, 0.07f }, { 0.23f, 0.11f, 0.07f }, KIT_FOREVER, 0, 0.3 },
    kit_ice = { { 0.64f, 0.67f, 0.70f }, { 0.47f, 0.58f, 0.66f }, { 0.72f, 0.73f, 0.74f }, KIT_FOREVER, 1, 0.04 },
    kit_limestone = { { 0.45f, 0.43f, 0.36f }, { 0.57f, 0.55f, 0.48f }, { 0.29f, 0.31f, 0.16f }, KIT_FOREVER, 1, 0.1 },
    kit_alpine = { { 0.20f, 0.23f, 0.11f }, { 0.30f, 0.28f, 0.27f }, { 0.71f, 0.72f, 0.74f }, KIT_FOREVER, 1, 0.2 },
    kit_gravel = { { 0.33f, 0.30f, 0.25f }, { 0.30f, 0.27f, 0.23f }, { 0.20f, 0.23f, 0.10f }, KIT_FOREVER, 0, 0.15 },
    kit_chalk = { { 0.28f, 0.31f, 0.15f }, { 0.69f, 0.68f, 0.64f }, { 0.28f, 0.31f, 0.15f }, KIT_FOREVER, 1, 0.08 };

/* ---- >>site ------------------------------------------------------------------------------------------------------ */

void land_set_land(kit_site *s, kit_land land, double length, double height, double a, double b)
{
    double *of = s->p->of;
    of[KIT_OF_LAND] = land;
    of[KIT_OF_SEED] = kit_choose(s->b, 100000);
    of[KIT_OF_LENGTH] = length;
    of[KIT_OF_HEIGHT] = height;
    of[KIT_OF_TURN] = kit_between(s->b, 0, 2 * KIT_PI);
    of[KIT_OF_ROUGH] = kit_between(s->b, 0.25, 1.2);
    of[KIT_OF_A] = a;
    of[KIT_OF_B] = b;
    of[KIT_OF_LEVEL] = -KIT_FOREVER;
    s->p->ground = land_stand;
    of[KIT_OF_SMALL] = s->unit * kit_between(s->b, 0.9, 1.8);
    of[KIT_OF_RELIEF] = s->unit * (land == KIT_DUNES ? 0.04 : kit_between(s->b, 0.04, 0.2));
    s->soil.bands *= 0.06 * height;
}

/* cells about fine wide in the middle; one may stand as far from it as stand */
void land_lay_ground(kit_site *s, double reach, double fine, double stand, double ledges)
{
    kit_lay lay = { 90 + 10 * kit_choose(s->b, 10), kit_odds(s->b, 0.22), reach, 0.5, ledges,
                    0.09 * s->p->of[KIT_OF_HEIGHT] };
    while (lay.finer < 9 && 2 * reach * lay.finer / (lay.cells * sinh(lay.finer)) > fine) lay.finer += 0.25;
    kit_begin_object(s->b, "ground", 0);
    land_build(s->p, &s->soil, &lay);
    s->p->stand[0] = s->p->stand[1] = -stand;
    s->p->stand[2] = s->p->stand[3] = stand;
    kit_place_at(s->b, 0, 0, 0, 0);
}

void land_lay_water(kit_site *s, double reach, double level)
{
    kit_colour(s->b, 0.10, 0.17 + 0.06 * kit_chance(s->b), 0.20);
    kit_begin_object(s->b, "water", 0);
    kit_level(s->b, -reach, -reach, reach, reach, level);
    s->p->of[KIT_OF_LEVEL] = level;
}

kit_spot land_any_spot(kit_site *s, double near, double far)
{
    const double a = kit_between(s->b, 0, 2 * KIT_PI), r = sqrt(kit_between(s->b, near * near, far * far));
    return (kit_spot){ r * cos(a), r * sin(a) };
}

/* the most level of some */
kit_spot land_level_spot(kit_site *s, double near, double far)
{
    kit_spot best = land_any_spot(s, near, far);
    double least = 1e9;
    for (int k = 0; k < 10; k++) {
        const kit_spot at = land_any_spot(s, near, far);
        const double slope = land_slope(s->p, at.x, at.z, 0.5 * s->unit)
                           + (land_height(s->p, at.x, at.z) < s->p->of[KIT_OF_LEVEL] ? 9 : 0);
        if (slope < least) {
            least = slope;
            best = at;
        }
    }
    return best;
}

/* the least height about a place, where the mesh is coarser than the ground is rough: nothing floats */
static double footing(const kit_site *s, kit_spot at)
{
    const double off = 0.25 * s->unit;
    double y = land_height(s->p, at.x, at.z);
    for (int k = 0; k < 4 && s->unit > 3; k++) {
        const double dx = k & 1 ? off : -off, dz = k & 2 ? off : -off;
        y = fmin(y, land_height(s->p, at.x + dx, at.z + dz));
    }
    return y;
}

kit_frame land_enter_at(kit_site *s, kit_spot at, double sunk, double turn, double size)
{
    return kit_enter(s->b, at.x, footing(s, at) - sunk, at.z, turn, size);
}

kit_frame land_begin_thing(kit_site *s, const char *name, kit_spot at, double sunk, double size)
{
    kit_begin_object(s->b, name, -1);
    return land_enter_at(s, at, sunk, kit_between(s->b, 0, 360), size);
}

void land_see(kit_site *s, kit_spot at, double up, double reach)
{
    kit_add_sight(s->p, at.x, land_height(s->p, at.x, at.z) + up, at.z, reach);
}

/* ---- >>stones ---------------------------------------------------------------------------------------------------- */

void land_stone_colour(kit_site *s) { kit_tint(s->b, (const float(*)[3]) & s->soil.steep, 1, 0.16); }

/* one, about the origin, of the site's kind; fine: cells */
void land_stone(kit_site *s, double size, int fine)
{
    kit_build *b = s->b;
    const double flat = s->stones == KIT_WORN    ? kit_between(b, 0.35, 0.7)
                      : s->stones == KIT_LAYERED ? kit_between(b, 0.3, 0.6)
                                                 : kit_between(b, 0.5, 0.95);
    const double half[3] = { size * kit_between(b, 0.75, 1.15), size * flat, size * kit_between(b, 0.6, 1) };
    if (s->stones == KIT_ANGULAR) land_cut_stone(b, half, 5 + kit_choose(b, 9), kit_between(b, 0.3, 0.55));
    else if (s->stones == KIT_BLOCKS) land_cut_stone(b, half, 1 + kit_choose(b, 4), 0.2);
    else if (s->stones == KIT_WORN) land_rock(b, half, 0.22, 0, fine, 0);
    else if (s->stones == KIT_LAYERED) land_rock(b, half, 0.4, 0.05, fine, 0);
    else land_rock(b, half, kit_between(b, 0.35, 0.6), 0, fine, kit_odds(b, 0.15));
}

void land_strew(kit_site *s, const char *name, kit_spot at, double radius, int count, double least, double most)
{
    kit_begin_object(s->b, name, -1);
    for (int k = 0; k < count; k++) {
        const double t = kit_chance(s->b), size = least * pow(most / least, t * t * t);
        const kit_spot off = land_any_spot(s, 0, radius),
                       to = { at.x + off.x * kit_between(s->b, 0.2, 1), at.z + off.z };
        const kit_frame before = land_enter_at(s, to, -0.25 * size, kit_between(s->b, 0, 360), 1);
        kit_place_tilted(s->b, 0, 0, 0, 0, kit_between(s->b, -20, 20));
        land_stone_colour(s);
        land_stone(s, size, size > 0.4 * most ? 5 : 2);
        kit_leave(s->b, before);
    }
}

/* each a thing of its own, some with a smaller one on top */
void land_strew_rocks(kit_site *s, int count, double near, double far, double least, double most)
{
    for (int k = 0; k < count; k++) {
        const double t = kit_chance(s->b), size = least * pow(most / least, t * t);
        const kit_spot at = k & 1 ? land_any_spot(s, near, far) : land_level_spot(s, near, far);
        const kit_frame before = land_begin_thing(
            s, "boulder", at,
            -kit_between(s->b, 0.15, 0.4) * size * (s->stones == KIT_LAYERED || s->stones == KIT_WORN ? 0.4 : 1), 1);
        land_stone_colour(s);
        kit_place_tilted(s->b, 0, 0, 0, 0, kit_between(s->b, -25, 25));
        land_stone(s, size, size > 0.3 * most ? 14 : 7);
        if (kit_odds(s->b, 0.15)) {
            kit_place_tilted(s->b, 0.2 * size, 0.95 * size, 0, kit_between(s->b, 0, 360), kit_between(s->b, -15, 15));
            land_stone(s, 0.5 * size, 9);
        }
        kit_leave(s->b, before);
        if (size > 0.25 * most && k < 20) land_see(s, at, 0.4 * size, 1.4 * size);
    }
}

void land_strew_heaps(kit_site *s, int heaps, int count, double far, double least, double most)
{
    for (int k = 0; k < heaps; k++) {
        const kit_spot at = land_any_spot(s, 0, far);
        const double radius = most * kit_between(s->b, 4, 14);
        land_strew(s, "stones", at, radius, count, least, most);
        if (k < 8) land_see(s, at, 0.3 * most, fmax(2 * most, 0.3 * radius));
    }
}

void land_see_land(kit_site *s, int count, double near, double far, double reach)
{
    for (int k = 0; k < count; k++) {
        kit_spot best = { 0, 0 };
        double most = -1;
        for (int i = 0; i < 8; i++) {
            const kit_spot at = land_any_spot(s, near, far);
            const double slope = land_slope(s->p, at.x, at.z, 0.3 * reach);
            if (slope > most) {
                most = slope;
                best = at;
            }
        }
        land_see(s, best, 0, reach);
    }
}

void land_strew_about_sights(kit_site *s, double probability)
{
    const int sights = s->p->sights;
    for (int k = 0; k < sights; k++) {
        const kit_sight *at = &s->p->sight[k];
        const double most = fmin(0.3 * at->reach, 2 * s->unit) * kit_between(s->b, 0.4, 1);
        if (!kit_odds(s->b, probability) || at->reach > 14 * s->unit) continue;
        land_strew(s, "stones", (kit_spot){ at->at[0], at->at[2] }, 1.6 * fmin(at->reach, 8 * s->unit),
                   land_some(s, 12, 35), 0.1 * most, most);
    }
}

/* ---- >>things ---------------------------------------------------------------------------------------------------- */

void land_put_bare_trees(kit_site *s, int count, double far, double height)
{
    for (int k = 0; k < count; k++) {
        const kit_spot at = land_level_spot(s, 0.1 * far, far);
        const double tall = height * kit_between(s->b, 0.5, 1.2);
        const kit_frame before = land_begin_thing(s, "dead tree", at, 0, 1);
        kit_colour(s->b, 0.36, 0.31, 0.26);
        land_bare_tree(s->b, tall, 2 + kit_choose(s->b, 2));
        kit_leave(s->b, before);
        land_see(s, at, 0.5 * tall, 0.5 * tall);
    }
}

void land_put_tufts(kit_site *s, int patches, int count, double far, double height)
{
    for (int k = 0; k < patches; k++) {
        const kit_spot at = land_level_spot(s, 0, far);
        kit_begin_object(s->b, "grass", -1);
        for (int i = 0; i < count; i++) {
            const kit_spot off = land_any_spot(s, 0, 6 * height), to = { at.x + off.x, at.z + off.z };
            const kit_frame before = land_enter_at(s, to, 0.02 * height, 0, 1);
            static const float greens[][3] = { { 0.30f, 0.34f, 0.12f },
                                               { 0.46f, 0.41f, 0.20f },
                                               { 0.22f, 0.30f, 0.10f } };
            KIT_TINT(s->b, greens, 0.2);
            land_grass_tuft(s->b, height * kit_between(s->b, 0.5, 1.2), 12 + kit_choose(s->b, 16));
            kit_leave(s->b, before);
        }
        land_see(s, at, 0.4 * height, 2.5 * height);
    }
}

void land_put_firs(kit_site *s, int groups, int count, double near, double far, double height)
{
    for (int k = 0; k < groups; k++) {
        const kit_spot at = land_level_spot(s, near, far);
        kit_begin_object(s->b, "firs", -1);
        for (int i = 0; i < count; i++) {
            static const float greens[][3] = { { 0.08f, 0.16f, 0.07f }, { 0.11f, 0.19f, 0.08f } };
            const kit_spot off = land_any_spot(s, 0, 4.5 * height), to = { at.x + off.x, at.z + off.z };
            if (land_slope(s->p, to.x, to.z, 0.3 * height) > 0.8) continue;
            const kit_frame before = land_enter_at(s, to, 0, kit_between(s->b, 0, 360), 1);
            KIT_TINT(s->b, greens, 0.2);
            land_fir_tree(s->b, height * kit_between(s->b, 0.5, 1.2), 5);
            kit_leave(s->b, before);
        }
        land_see(s, at, 0.4 * height, 1.5 * height);
    }
}

/* posts along a line over the ground, rails or wires between them */
void land_fence(kit_site *s, kit_spot from, kit_spot to, double gap)
{
    kit_build *b = s->b;
    const double dx = to.x - from.x, dz = to.z - from.z, length = sqrt(dx * dx + dz * dz);
    const int posts = (int)(length / gap) + 1, wires = 2 + kit_choose(b, 3), rails = kit_odds(b, 0.5);
    double old[3] = { 0 };
    kit_begin_object(b, "fence", -1);
    kit_colour(b, 0.40, 0.33, 0.26);
    for (int k = 0; k <= posts; k++) {
        const double t = (double)k / posts, x = from.x + t * dx, z = from.z + t * dz, y = land_height(s->p, x, z);
        const double now[3] = { x, y, z };
        kit_place_tilted(b, x, y - 0.3, z, kit_between(b, 0, 90), kit_between(b, -6, 6));
        kit_box(b, -0.05, 0, -0.05, 0.05, kit_between(b, 1.35, 1.5), 0.05);
        kit_place_at(b, 0, 0, 0, 0);
        for (int i = 0; i < wires && k; i++) {
            const double up = 0.95 * (i + 1) / wires, p[3] = { old[0], old[1] + up, old[2] },
                         q[3] = { now[0], now[1] + up + kit_between(b, -0.05, 0.05), now[2] };
            if (kit_odds(b, 0.08)) continue;
            kit_cable(b, p, q, rails ? 0.02 : 0.05, rails ? 0.035 : 0.004, rails ? 6 : 3);
        }
        memcpy(old, now, sizeof old);
    }
    land_see(s, (kit_spot){ 0.5 * (from.x + to.x), 0.5 * (from.z + to.z) }, 0.6, 2);
}

void land_fence_somewhere(kit_site *s, double far)
{
    const kit_spot from = land_any_spot(s, 0.3 * far, far), to = land_any_spot(s, 0.3 * far, far);
    land_fence(s, from, to, 2.2);
}

/* planks on posts, over what is below */
void land_jetty(kit_site *s, kit_spot from, double turn, double length, double level)
{
    kit_build *b = s->b;
    kit_begin_object(b, "jetty", -1);
    const kit_frame before = kit_enter(b, from.x, level, from.z, turn, 1);
    kit_colour(b, 0.44, 0.37, 0.29);
    for (double x = 0; x < length; x += 0.16)
        kit_box(b, x, kit_between(b, -0.006, 0), -0.75 + kit_between(b, -0.04, 0.04), x + 0.145, 0.03, 0.75);
    for (int side = -1; side <= 1; side += 2) {
        kit_box(b, 0, -0.16, 0.6 * side - 0.05, length, -0.008, 0.6 * side + 0.05);
        for (double x = 0.3; x < length; x += 1.9) {
            const double post[2][3] = { { x, -4, 0.72 * side }, { x, kit_between(b, 0.15, 0.9), 0.72 * side } };
            kit_tube(b, post, 2, 0.075, 9);
        }
    }
    kit_leave(b, before);
    const double a = turn * KIT_PI / 180;
    kit_add_sight(s->p, from.x + 0.5 * length * cos(a), level, from.z - 0.5 * length * sin(a), 2.5);
}

void land_put_hut(kit_site *s, double near, double far)
{
    const kit_spot at = land_level_spot(s, near, far);
    const double w = kit_between(s->b, 3, 6), d = kit_between(s->b, 2.6, 4.2);
    const kit_frame before = land_begin_thing(s, "hut", at, 0, 1);
    kit_colour(s->b, 0.42, 0.33, 0.24);
    land_hut(s->b, w, d, kit_between(s->b, 2.1, 2.6));
    kit_leave(s->b, before);
    if (kit_odds(s->b, 0.4)) land_see(s, at, 1.5, 5);
}

/* one of the things above, so large, on the ground */
kit_spot land_put(kit_site *s, int what, double near, double far, double size)
{
    static const char *const names[] = { "boat",   "wreck",        "tent",   "cairn",  "driftwood", "arch",
                                         "cactus", "prickly pear", "planks", "ladder", "shell" };
    static const float colours[][3] = { { 0.45f, 0.20f, 0.16f }, { 0.28f, 0.22f, 0.17f },
                                        { 0.75f, 0.45f, 0.15f }, { 0, 0, 0 },
                                        { 0.55f, 0.50f, 0.44f }, { 0, 0, 0 },
                                        { 0.24f, 0.36f, 0.18f }, { 0.32f, 0.44f, 0.22f },
                                        { 0.50f, 0.40f, 0.28f }, { 0.46f, 0.36f, 0.25f },
                                        { 0.80f, 0.68f, 0.58f } };
    kit_build *b = s->b;
    const kit_spot at = land_level_spot(s, near, far);
    const kit_frame before = land_begin_thing(s, names[what], at, what == KIT_SHELL ? 0.05 * size : 0, 1);
    if (what == KIT_CAIRN || what == KIT_ARCH) land_stone_colour(s);
    else kit_tint(b, &colours[what], 1, 0.2);
    if (what == KIT_BOAT) kit_place_tilted(b, 0, 0.02 * size, 0, 0, kit_between(b, -18, 18));
    if (what == KIT_SHELL) kit_place_tilted(b, 0, 0.05 * size, 0, 0, kit_between(b, -50, 50));
    if (what == KIT_LADDER) kit_place_tilted(b, 0, 0, 0, 0, kit_between(b, -86, -60));
    if (what == KIT_BOAT) land_boat(b, size);
    else if (what == KIT_WRECK) land_wreck(b, size);
    else if (what == KIT_TENT) land_tent(b, 0.8 * size, size, 0.55 * size);
    else if (what == KIT_CAIRN) land_cairn(b, 0.4 * size, 5 + kit_choose(b, 5));
    else if (what == KIT_DRIFTWOOD) land_driftwood(b, size);
    else if (what == KIT_ARCH) land_arch(b, size, 0.25 * size, 28);
    else if (what == KIT_CACTUS) land_cactus(b, size);
    else if (what == KIT_PEAR) land_prickly_pear(b, size);
    else if (what == KIT_LOGS) land_planks(b, 4 + kit_choose(b, 12), size);
    else if (what == KIT_LADDER) land_pole_ladder(b, size);
    else land_shell(b, size);
    kit_leave(b, before);
    land_see(s, at, 0.3 * size, what == KIT_ARCH ? 1.4 * size : 0.7 * size);
    return at;
}

void land_put_some(kit_site *s, int what, int count, double near, double far, double least, double most)
{
    for (int k = 0; k < count; k++) land_put(s, what, near, far, kit_between(s->b, least, most));
}

void land_put_spires(kit_site *s, int count, double near, double far, double height, int caps)
{
    for (int k = 0; k < count; k++) {
        const kit_spot at = land_any_spot(s, near, far);
        const double tall = height * kit_between(s->b, 0.4, 1.1), thick = tall * kit_between(s->b, 0.14, 0.3);
        const kit_frame before = land_begin_thing(s, "spire", at, 0.1 * tall, 1);
        land_stone_colour(s);
        land_spire(s->b, thick, tall, kit_between(s->b, 0.25, 0.55), 18);
        if (caps) {
            const double half[3] = { 0.75 * thick, 0.35 * thick, 0.7 * thick };
            kit_place_at(s->b, 0, 1.02 * tall, 0, 0);
            land_stone_colour(s);
            land_rock(s->b, half, 0.4, 0.04, 10, 0);
        }
        kit_leave(s->b, before);
        land_see(s, at, 0.5 * tall, 0.6 * tall);
    }
}
