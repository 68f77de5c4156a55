/* scans.c - scenes by seed: scanned and modelled figures on grounds and among clutter. Declared in kit_seed.h. */
#include "kit/scene/scans/scans.h"
#include <math.h>
#include <string.h>

static const float walls[][3] = { { 0.75f, 0.73f, 0.68f },
                                  { 0.5f, 0.2f, 0.16f },
                                  { 0.28f, 0.36f, 0.32f },
                                  { 0.82f, 0.81f, 0.78f },
                                  { 0.35f, 0.4f, 0.5f } },
                   floors[][3] = {
                       { 0.45f, 0.33f, 0.22f }, { 0.5f, 0.5f, 0.48f }, { 0.3f, 0.29f, 0.28f }, { 0.62f, 0.58f, 0.5f }
                   };

static const int persons[] = { STATUE, STATUE, SEATED, TORSO, BUST },
                 small_ones[] = { BUST, SKULL, BEAST, DRAGON, HAND,   SNAIL,  AMMONITE, CORAL, VASE, VASE,
                                  BOWL, KNOT,  BIRD,  SPONGE, STATUE, SEATED, TORSO,    MASK,  ROOT },
                 all_kinds[] = { STATUE, SEATED,   TORSO, BUST, SKULL, MASK, BEAST, DRAGON, HAND,
                                 SNAIL,  AMMONITE, CORAL, ROOT, VASE,  KNOT, BIRD,  SPONGE };

/* ---- >>grounds ------------------------------------------------------------------------------------------------- */

/* What spans an open roof, a rail with spotlights. */
static void beams(kit_plot *p, double x, double z, double high)
{
    kit_build *b = &p->b;
    const int count = 3 + kit_choose(b, 5), spots = 3 + kit_choose(b, 4);
    const double deep = kit_between(b, 0.08, 0.24), rail = kit_between(b, -0.5, 0.5) * z;
    kit_begin_object(b, "beams", 0);
    scan_tint(b, KIT_OF_WOOD, 0.2);
    for (int k = 0; k < count; k++) {
        const double at = x * (2 * (k + 0.5) / count - 1);
        kit_box(b, at - 0.06, high - deep - 0.04, -z, at + 0.06, high - 0.04, z);
    }
    kit_begin_object(b, "rail", -1);
    kit_colour(b, 0.12, 0.12, 0.12);
    kit_box(b, -x, high - deep - 0.09, rail - 0.015, x, high - deep - 0.06, rail + 0.015);
    for (int k = 0; k < spots; k++) {
        const double at = x * (2 * (k + 0.5) / spots - 1),
                     drop[2][3] = { { at, high - deep - 0.1, rail }, { at, high - deep - 0.25, rail } };
        kit_tube(b, drop, 2, 0.008, 6);
        kit_place_tilted(b, at, high - deep - 0.25, rail, kit_between(b, 0, 360), kit_between(b, 100, 150));
        kit_cylinder(b, 0.05, 0.16, 20);
        kit_place_at(b, 0, 0, 0, 0);
        kit_add_lamp(p, at, high - deep - 0.5, rail);
    }
}

/* boards or tiles that differ a little in height, or one plane */
static void lay_floor(kit_build *b, double x, double z)
{
    const int boards = kit_odds(b, 0.5) ? (int)(2 * x / kit_between(b, 0.12, 0.5)) : 0;
    const double y = boards ? -0.02 : 0, all[4][3] = { { -60, y, 60 }, { 60, y, 60 }, { 60, y, -60 }, { -60, y, -60 } };
    kit_sheet(b, all, KIT_CUTS(kit_both), KIT_CUTS(kit_both));
    for (int k = 0; k < boards; k++) {
        const double x0 = x * (2.0 * k / boards - 1), x1 = x * (2.0 * (k + 1) / boards - 1),
                     cut = kit_between(b, -0.8, 0.8) * z;
        kit_box(b, x0 + 0.003, -0.1, -z, x1 - 0.003, -kit_between(b, 0, 0.003), cut);
        kit_box(b, x0 + 0.003, -0.1, cut + 0.004, x1 - 0.003, -kit_between(b, 0, 0.003), z);
    }
}

/* Floor and walls without a ceiling: half sides x and z. */
static void courtyard(kit_plot *p, double x, double z, double high)
{
    kit_build *b = &p->b;
    const int pilasters = kit_odds(b, 0.5) ? (int)(x / 1.5) : 0, frames = kit_odds(b, 0.6) ? (int)x : 0;
    kit_begin_object(b, "ground", 0);
    KIT_TINT(b, floors, 0.2);
    lay_floor(b, x, z);
    kit_begin_object(b, "walls", 0);
    KIT_TINT(b, walls, 0.1);
    scan_gallery_wall(b, -x, z, x, z, high, pilasters);
    scan_gallery_wall(b, x, -z, -x, -z, high, pilasters);
    scan_gallery_wall(b, x, z, x, -z, high, 0);
    scan_gallery_wall(b, -x, -z, -x, z, high, 0);
    if (kit_odds(b, 0.6)) beams(p, x, z, high);
    for (int k = 0; k < frames; k++) {
        const kit_frame before = kit_enter(b, -x + 0.01, 0, z * (2 * (k + 0.5) / frames - 1), 90, 1);
        const double wide = kit_between(b, 0.5, 0.9) * fmin(1.6, 1.8 * z / frames);
        kit_begin_object(b, "picture", -1);
        scan_picture(b, wide, kit_between(b, 0.7, 1.4), kit_between(b, 1.4, 1.8));
        kit_leave(b, before);
    }
    p->stand[0] = 0.3 - x;
    p->stand[1] = 0.3 - z;
    p->stand[2] = x - 0.3;
    p->stand[3] = z - 0.3;
}

/* ---- >>layouts ------------------------------------------------------------------------------------------------- */

/* A table's top full of things. */
static void clutter(kit_plot *p, kit_style *s, double wide, double deep, double high)
{
    kit_build *b = &p->b;
    const int across = (int)(wide / 0.36), down = (int)(deep / 0.36);
    for (int k = 0; k < across * down; k++) {
        const double x = (k % across - 0.5 * (across - 1)) * 0.36 + kit_between(b, -0.04, 0.04),
                     z = (double)(k / across - 0.5 * (down - 1)) * 0.36 + kit_between(b, -0.04, 0.04);
        const int what = kit_choose(b, 11);
        const kit_frame before = kit_enter(b, x, high + 0.001, z, kit_between(b, 0, 360), 1);
        if (what > 4 && what < 10) kit_begin_object(b, "clutter", -1);
        if (what < 5) scan_place_upright(p, s, NEXT(b, s, small_ones), 0, 0, 0, 0, kit_between(b, 0.14, 0.42));
        if (what == 5) scan_books(b);
        if (what == 6) scan_bottle(b, kit_between(b, 0.18, 0.34));
        if (what == 7) scan_brushes(b);
        if (what == 8) scan_papers(b, 1 + kit_choose(b, 4));
        if (what == 9) {
            scan_tint(b, KIT_OF_WOOD, 0.2);
            scan_crate(b, kit_between(b, 0.15, 0.28), kit_between(b, 0.08, 0.2));
        }
        if (what > 4 && what < 10) scan_sight(p, 0, 0.08, 0, 0.17);
        kit_leave(b, before);
    }
}

/* A figure that is being scanned: turntable, backdrop, lamps, cameras, what waits. */
static void studio(kit_plot *p, kit_style *s)
{
    kit_build *b = &p->b;
    const double high = kit_between(b, 0.2, 0.9), disc = kit_between(b, 0.4, 0.8), tall = kit_between(b, 0.5, 1.5);
    courtyard(p, kit_between(b, 3, 5), kit_between(b, 3, 4), kit_between(b, 2.8, 4));
    kit_begin_object(b, "backdrop", -1);
    KIT_TINT(b, walls, 0.2);
    kit_frame before = kit_enter(b, 0, 0, -1.7, 0, 1);
    scan_backdrop(b, kit_between(b, 2.4, 3.6), kit_between(b, 1.9, 2.5), 3);
    kit_leave(b, before);
    kit_begin_object(b, "turntable", -1);
    kit_colour(b, 0.2, 0.2, 0.21);
    kit_place_at(b, 0, 0.01, 0, 0);
    kit_cylinder(b, 0.6 * disc, high - 0.05, 40);
    kit_colour(b, 0.75, 0.75, 0.73);
    kit_place_at(b, 0, high - 0.03, 0, 0);
    kit_cylinder(b, disc, 0.03, 64);
    for (int k = 0; k < 36; k++) { /* marks */
        kit_colour(b, k & 1 ? 0.05 : 0.85, k % 3 ? 0.05 : 0.4, 0.05);
        kit_place_at(b, 0, high, 0, 10 * k);
        kit_box(b, -0.02, 0, 0.86 * disc, 0.02, 0.002, 0.96 * disc);
    }
    kit_place_at(b, 0, 0, 0, 0);
    s->cells = (int)(1.35 * s->cells);
    scan_place_upright(p, s, NEXT(b, s, all_kinds), 0, high + 0.001, 0, kit_between(b, -60, 60), tall);
    s->cells /= 2;
    for (int k = 0, count = kit_choose(b, 5); k < count; k++) {
        const double a = 0.8 + 0.5 * k;
        scan_place_upright(p, s, NEXT(b, s, small_ones), 2.1 * cos(a), 0.002, 2.1 * sin(a), kit_between(b, 0, 360),
                           kit_between(b, 0.2, 0.6));
    }
    for (int k = 0, count = 2 + kit_choose(b, 3); k < count; k++) {
        const double a = -0.4 + 2.2 * k + kit_between(b, 0, 0.5), far = kit_between(b, 1.9, 2.4);
        before = kit_enter(b, far * cos(a), 0.002, far * sin(a), -90 - a * 180 / KIT_PI, 1);
        kit_begin_object(b, "lamp", -1);
        if (k & 1) scan_tripod(b, kit_between(b, 0.9, 1.4));
        else scan_softbox(b, kit_between(b, 1.4, 2));
        scan_sight(p, 0, 1.3, 0, 0.5);
        kit_leave(b, before);
        kit_add_lamp(p, 0.8 * far * cos(a), 1.7, 0.8 * far * sin(a));
    }
    if (kit_odds(b, 0.6)) {
        before = kit_enter(b, -2.3, 0.002, 1.2, 80, 1);
        kit_begin_object(b, "table", 1);
        scan_tint(b, KIT_OF_WOOD, 0.2);
        scan_table(b, 1.3, 0.6, 0.74);
        clutter(p, s, 1.3, 0.6, 0.74);
        kit_leave(b, before);
    }
    const double from[3] = { disc * 0.5, 0.04, 0.1 }, to[3] = { 2.4, 0.03, 1.2 };
    kit_begin_object(b, "cable", -1);
    kit_colour(b, 0.1, 0.1, 0.1);
    kit_cable(b, from, to, 0.005, 0.008, 8);
}

/* Plinths with figures, pictures, benches, ropes. */
static void gallery(kit_plot *p, kit_style *s)
{
    kit_build *b = &p->b;
    const double x = kit_between(b, 3.5, 8), z = kit_between(b, 3, 6), step = kit_between(b, 1.6, 2.6);
    courtyard(p, x, z, kit_between(b, 3.2, 5));
    const int across = (int)((2 * x - 1) / step), down = (int)((2 * z - 1) / step), groups = kit_odds(b, 0.5);
    for (int k = 0, made = 0; k < across * down && made < 14; k++) {
        const double px = (k % across - 0.5 * (across - 1)) * step, pz = (double)(k / across - 0.5 * (down - 1)) * step;
        const int rim = k % across == 0 || k % across == across - 1 || k / across == 0 || k / across == down - 1;
        if (!kit_odds(b, rim ? 0.6 : 0.3)) continue;
        const int which = groups ? ANY(b, persons) : NEXT(b, s, all_kinds), large = which == STATUE || which == SEATED;
        const double tall = large ? kit_between(b, 1.2, 2.1) : kit_between(b, 0.45, 0.9);
        const double high = large ? kit_between(b, 0.2, 0.6) : kit_between(b, 0.7, 1.2);
        const kit_frame before = kit_enter(b, px + kit_between(b, -0.2, 0.2), 0.002, pz + kit_between(b, -0.2, 0.2),
                                           kit_between(b, -30, 30) + (pz > 0 ? 180 : 0), 1);
        kit_begin_object(b, "plinth", -1);
        scan_tint(b, KIT_OF_STONE, 0.15);
        scan_plinth(b, fmax(0.35, tall * fmin(0.9, scan_slim(which))) + 0.1, high);
        scan_place_upright(p, s, which, 0, high + 0.001, 0, 0, tall);
        if (kit_odds(b, 0.2)) {
            kit_begin_object(b, "barrier", -1);
            scan_barrier(b, 0.85, 0.75);
        }
        kit_leave(b, before);
        made++;
    }
    for (int k = 0; k < 3; k++) {
        const kit_frame before = kit_enter(b, kit_between(b, -0.6, 0.6) * x, 0.001,
                                           kit_between(b, -0.8, 0.8) * step * 0.25 + (k - 1) * step * 0.5, 0, 1);
        kit_begin_object(b, "bench", -1);
        scan_tint(b, KIT_OF_WOOD, 0.2);
        scan_bench(b, kit_between(b, 1, 1.8));
        kit_leave(b, before);
    }
}

/* the table's top counts as ground, in some scenes around it, too */
static double on_table(const kit_plot *p, double x, double z)
{
    return fabs(x) < p->of[0] + p->of[3] && fabs(z) < p->of[1] + p->of[3] ? p->of[2] : 0;
}

/* A sculptor's table, a still life: things among things, cloth, a sheet behind. */
static void table(kit_plot *p, kit_style *s)
{
    kit_build *b = &p->b;
    const double wide = kit_between(b, 1.4, 2.8), deep = kit_between(b, 0.8, 1.5), high = kit_between(b, 0.7, 0.95);
    courtyard(p, kit_between(b, 2.2, 4), kit_between(b, 2, 3), kit_between(b, 2.6, 3.6));
    p->of[0] = 0.5 * wide;
    p->of[1] = 0.5 * deep;
    p->of[2] = high;
    p->of[3] = kit_odds(b, 0.7) ? 1 : 0;
    p->ground = on_table;
    kit_begin_object(b, "table", 1);
    scan_tint(b, KIT_OF_WOOD, 0.2);
    scan_table(b, wide, deep, high);
    if (kit_odds(b, 0.4)) {
        const kit_frame before = kit_enter(b, 0, 0.01, -0.5 * deep - 0.25, 0, 1);
        kit_begin_object(b, "backdrop", -1);
        KIT_TINT(b, walls, 0.2);
        scan_backdrop(b, wide + 0.5, 2, 0.02);
        kit_leave(b, before);
    }
    s->cells = (int)(0.62 * s->cells);
    clutter(p, s, wide, deep, high);
    for (int k = 0; k < 4; k++) {
        const kit_frame before = kit_enter(b, (k - 1.5) * 0.9, 0.002, 0.5 * deep + 0.6, kit_between(b, -30, 30), 1);
        if (kit_odds(b, 0.6)) {
            kit_begin_object(b, k & 1 ? "stool" : "crate", -1);
            scan_tint(b, KIT_OF_WOOD, 0.2);
            if (k & 1) scan_plinth(b, 0.35, 0.48);
            else scan_crate(b, 0.45, 0.35);
            scan_sight(p, 0, 0.3, 0, 0.4);
        }
        kit_leave(b, before);
    }
    for (int k = -1; k <= 1; k += 2) kit_add_lamp(p, 0.4 * k * wide, high + 0.9, 0.2 * deep);
}

/* A cabinet of compartments, each with its frame; small figures within. */
static void cabinet(kit_plot *p, kit_style *s, int across, int rows, double side)
{
    kit_build *b = &p->b;
    const double x = 0.5 * across * side, top = 0.3 + rows * side, deep = 0.7 * side;
    kit_begin_object(b, "cabinet", -1);
    scan_tint(b, KIT_OF_WOOD, 0.2);
    kit_box(b, -x, 0, -0.02, x, top, 0);
    for (int k = 0; k <= across; k++) kit_box(b, -x + k * side - 0.012, 0, 0.001, -x + k * side + 0.012, top, deep);
    for (int k = 0; k <= rows; k++)
        for (int i = 0; i < across; i++)
            kit_box(b, -x + i * side + 0.0125, 0.28 + k * side, 0.001, -x + (i + 1) * side - 0.0125, 0.3 + k * side,
                    deep - 0.002);
    for (int k = 0; k < rows * across; k++) {
        const double px = -x + (k % across + 0.5) * side, y = 0.3 + (double)(k / across) * side, h = 0.5 * side - 0.014,
                     f = 0.02;
        kit_colour(b, 0.5, 0.4, 0.2);
        kit_place_at(b, px, y, deep - 0.001, 0);
        kit_box(b, -h, 0, 0, h, f, 0.012);
        kit_box(b, -h, side - 0.02 - f, 0, h, side - 0.021, 0.012);
        kit_box(b, -h, f, 0, f - h, side - 0.02 - f, 0.012);
        kit_box(b, h - f, f, 0, h, side - 0.02 - f, 0.012);
        kit_colour(b, 0.85, 0.84, 0.8);
        kit_place_tilted(b, px, y + 0.001, deep - 0.03, 0, -60);
        kit_leaf(b, 0.06, 0.04, 0.05, 1, 0); /* a label */
    }
    kit_place_at(b, 0, 0, 0, 0);
    for (int k = 0; k < rows * across; k++) {
        const double px = -x + (k % across + 0.5) * side, y = 0.3 + (double)(k / across) * side + 0.001;
        const int which = NEXT(b, s, small_ones);
        const double most = side * fmin(0.8, 0.62 / scan_slim(which));
        if (kit_odds(b, 0.88))
            scan_place_upright(p, s, which, px, y, 0.5 * deep, kit_between(b, -40, 40), most * kit_between(b, 0.7, 1));
    }
}

static void museum(kit_plot *p, kit_style *s)
{
    kit_build *b = &p->b;
    const double x = kit_between(b, 2.2, 3.5), z = kit_between(b, 1.8, 2.6), side = kit_between(b, 0.42, 0.7);
    const int across = (int)((2 * x - 0.6) / side), rows = (int)(2.2 / side), both = kit_odds(b, 0.4);
    courtyard(p, x, z, kit_between(b, 3, 4));
    s->cells = (int)(s->cells * (both ? 0.42 : 0.5));
    kit_frame before = kit_enter(b, 0, 0.001, -z + 0.2, 0, 1);
    cabinet(p, s, across > 6 ? 6 : across, rows, side);
    kit_leave(b, before);
    if (both) {
        before = kit_enter(b, 0.4, 0.001, z - 0.2, 180, 1);
        cabinet(p, s, across > 5 ? 4 : across - 1, rows - 1, side);
        kit_leave(b, before);
    }
    before = kit_enter(b, 0, 0.001, 0.3, kit_between(b, -10, 10), 1);
    kit_begin_object(b, "bench", -1);
    scan_tint(b, KIT_OF_WOOD, 0.2);
    scan_bench(b, 1.4);
    kit_leave(b, before);
    s->cells *= 2;
    before = kit_enter(b, 1.3, 0.001, 0.3, 0, 1);
    kit_begin_object(b, "plinth", -1);
    scan_tint(b, KIT_OF_STONE, 0.15);
    scan_plinth(b, 0.5, 0.9);
    scan_place_upright(p, s, ANY(b, persons), 0, 0.901, 0, kit_between(b, 0, 360), 0.8);
    kit_leave(b, before);
}

/* A store: figures on pallets, some under sheets, crates, things that lean. */
static void store(kit_plot *p, kit_style *s)
{
    kit_build *b = &p->b;
    const double x = kit_between(b, 2.6, 5), z = kit_between(b, 2.6, 4);
    courtyard(p, x, z, kit_between(b, 3, 4.5));
    s->cells = (int)(0.62 * s->cells);
    const int across = (int)((2 * x - 0.4) / 1.35), down = (int)((2 * z - 0.4) / 1.3);
    for (int k = 0, made = 0; k < across * down; k++) {
        const double px = (k % across - 0.5 * (across - 1)) * 1.35, pz = (double)(k / across - 0.5 * (down - 1)) * 1.3;
        const int what = kit_choose(b, 9);
        const kit_frame before = kit_enter(b, px + kit_between(b, -0.08, 0.08), 0.001, pz, kit_between(b, -12, 12), 1);
        scan_sight(p, 0, 0.6, 0, 0.7);
        if (what < 6) {
            kit_begin_object(b, "pallet", -1);
            scan_tint(b, KIT_OF_WOOD, 0.2);
            scan_pallet(b);
        }
        if (what < 4 && made < 12) {
            const int which = NEXT(b, s, all_kinds);
            scan_place_upright(p, s, which, 0, 0.126, 0, kit_between(b, 0, 360),
                               fmin(kit_between(b, 0.8, 1.9), 0.95 / scan_slim(which)));
            made++;
        }
        if (what == 4 || what == 5) {
            const double high = kit_between(b, 0.5, 1.6);
            kit_begin_object(b, "cloth", -1);
            KIT_TINT(b, walls, 0.2);
            scan_drape(b, kit_between(b, 0.2, 0.4), high, high + kit_between(b, -0.2, 0.4));
        }
        if (what == 6) {
            kit_begin_object(b, "crate", -1);
            scan_tint(b, KIT_OF_WOOD, 0.2);
            scan_crate(b, kit_between(b, 0.5, 0.9), kit_between(b, 0.4, 1));
        }
        if (what == 7) scan_place_upright(p, s, ROCK, 0, 0.001, 0, 0, 0.8);
        kit_leave(b, before);
    }
}

void kit_make_scan(kit_plot *p)
{
    static void (*const layouts[])(kit_plot *, kit_style *) = { studio, gallery,    table,      museum,
                                                                store,  scan_ruins, scan_sands, scan_garden };
    kit_build *b = &p->b;
    kit_style s;
    s.cells = (int)(40 * pow(2, kit_chance(b)));
    s.facets = kit_odds(b, 0.2);
    if (s.facets) s.cells /= 2;
    s.matter = kit_choose(b, 5);
    s.bunnies = kit_odds(b, 0.4) ? 1 + kit_odds(b, 0.2) : 0;
    layouts[kit_choose(b, (int)(sizeof layouts / sizeof *layouts))](p, &s);
}
