/* districts.c - layouts of scenes by seed: streets, alleys, squares, courts, stairs. Declared in streets.h. */
#include "kit/scene/streets/streets.h"
#include <math.h>
#include <string.h>

static int any_of(kit_build *b, const int *things, int count) { return things[kit_choose(b, count)]; }

#define ANY(b, things) any_of(b, things, (int)(sizeof things / sizeof *things))

/* ---- >>street -------------------------------------------------------------------------------------------------- */

/* Dashes, a crossing, covers: paint and iron on the road along z. */
static void markings(kit_build *b, double half, double far_off)
{
    static const double cover = 0.34;
    kit_colour(b, 0.7, 0.7, 0.67);
    for (double z = -far_off; z < far_off; z += 6) kit_level(b, -0.07, z, 0.07, z + 3, 0.006);
    const double at = kit_between(b, -12, 12);
    for (double x = -half + 0.5; x < half - 0.6 && kit_odds(b, 0.95); x += 1)
        kit_level(b, x, at, x + 0.5, at + 3, 0.007);
    for (int k = 0; k < 4; k++) {
        const double ring[2] = { cover, 0.015 };
        kit_colour(b, 0.2, 0.19, 0.18);
        kit_place_at(b, kit_between(b, -half + 1, half - 1), 0, kit_between(b, -15, 15), 0);
        kit_cylinder(b, cover, 0.012, 20);
        kit_patch(b, 20, 6, kit_torus_surface, ring);
        kit_place_at(b, 0, 0, 0, 0);
    }
}

/* What stands along both kerbs: half of the road, of the whole. */
static void along_kerbs(kit_plot *p, const kit_town *t, double road, double half, double reach)
{
    static const int odd[] = { KIT_BIN,    KIT_BENCH, KIT_BICYCLE, KIT_SIGN, KIT_HYDRANT, KIT_PERSON,
                               KIT_PERSON, KIT_POT,   KIT_CRATES,  KIT_CAFE, KIT_SHELTER, KIT_BOLLARD };
    kit_build *b = &p->b;
    const double dense = kit_between(b, 0.2, 0.9), trees = kit_odds(b, 0.5) ? kit_between(b, 0.3, 0.9) : 0,
                 tall = half > 8;
    for (int side = -1; side <= 1; side += 2) {
        const double face = side < 0 ? 90 : -90;
        for (double z = -reach + 3; z < reach; z += kit_between(b, 5.2, 8))
            if (kit_odds(b, fabs(z) < 15 ? dense : 0.5 * dense))
                kit_town_put(p, KIT_CAR, side * (road - 1.05), 0, z, (side < 0 ? 180 : 0) + kit_between(b, -3, 3));
        for (double z = -reach + 4; z < reach; z += 15)
            kit_town_put(p, tall > 0 ? KIT_TALL_LAMP : KIT_LAMP, side * (road + 0.4), t->pave + 0.01, z, face + 180);
        for (double z = -reach + 9; z < reach; z += 10)
            if (kit_odds(b, trees))
                kit_town_put(p, KIT_TREE, side * (road + 0.8), t->pave + 0.01, z, kit_between(b, 0, 360));
        for (double z = -0.7 * reach; z < 0.7 * reach; z += kit_between(b, 2, 7)) {
            const int what = ANY(b, odd);
            const double x = what == KIT_SIGN || what == KIT_HYDRANT || what == KIT_BOLLARD ? road + 0.4
                           : what == KIT_BICYCLE                                            ? half - 0.4
                                                 : kit_between(b, road + 1, half - 0.7);
            const double turn = what == KIT_PERSON ? kit_between(b, 0, 360) : what == KIT_BICYCLE ? 90 : face;
            if ((what == KIT_CAFE || what == KIT_SHELTER) && half - road < 2.6) continue;
            kit_town_put(p, what, side * x, t->pave + 0.015, z, turn + kit_between(b, -5, 5));
        }
    }
}

/* Cables across the street, some with flags or washing. */
static void overhead(kit_plot *p, double half, double reach, double clutter)
{
    kit_build *b = &p->b;
    const int kind = kit_choose(b, 4);
    kit_begin_object(b, "cables", -1);
    kit_colour(b, 0.08, 0.08, 0.08);
    for (double z = -reach; z < reach && kind; z += kit_between(b, 4, 14)) {
        const double y = kit_between(b, 5, 7.5), y1 = y + kit_between(b, -0.6, 0.6);
        const double from[3] = { -half - 0.3, y, z }, to[3] = { half + 0.3, y1, z + kit_between(b, -2, 2) };
        const kit_frame was = kit_enter(b, from[0], y, z, 0, 1);
        if (kind == 2 && kit_odds(b, 0.7)) kit_town_bunting(b, 2 * half + 0.6);
        else if (clutter > 0.5 && half < 5) kit_town_laundry(b, 2 * half + 0.6);
        kit_leave(b, was);
        kit_colour(b, 0.08, 0.08, 0.08);
        if (kind != 2) kit_cable(b, from, to, kit_between(b, 0.1, 0.6), 0.012, 5);
    }
    for (int k = 0; k < 4 && kind == 3; k++) { /* wires for trams */
        const double from[3] = { k & 1 ? 1.6 : -1.6, 5.2 + 0.5 * (k / 2), -reach }, to[3] = { from[0], from[1], reach };
        kit_cable(b, from, to, 0.15, 0.012, 5);
    }
}

void kit_town_lay_street(kit_plot *p, kit_town *t)
{
    kit_build *b = &p->b;
    const double road = kit_between(b, 2.8, 6.5), half = road + kit_between(b, 1.6, 3.6),
                 reach = kit_between(b, 22, 34), bend = kit_odds(b, 0.4) ? kit_between(b, -8, 8) : 0,
                 size = kit_odds(b, 0.7) ? kit_between(b, 0.4, 0.9) : 0;
    kit_town_ground(p, 260);
    markings(b, road, reach);
    for (int side = -1; side <= 1; side += 2) {
        const double r[4] = { side < 0 ? -half - 12 : road, -reach - 20, side < 0 ? -road : half + 12, reach + 20 };
        const double paved[4] = { side < 0 ? -half + 0.02 : road + 0.16, -20, side < 0 ? -road - 0.16 : half - 0.02,
                                  20 };
        kit_town_pavement(b, r, t->pave, 0);
        if (size > 0) kit_town_paving(b, paved, t->pave + 0.012, size);
    }
    if (kit_odds(b, 0.3)) { /* setts */
        const double r[4] = { -road + 0.1, -10, road - 0.1, 10 };
        kit_town_paving(b, r, 0.018, 0.25);
    }
    kit_town_row(p, t, -half, reach, -half, -reach);
    kit_town_row(p, t, half, -reach, half, reach);
    if (kit_odds(b, 0.7)) kit_town_row(p, t, -half - 11, -reach - 10, half + 11 + bend, -reach - 10 + bend);
    if (kit_odds(b, 0.5)) kit_town_row(p, t, half + 11, reach + 10, -half - 11, reach + 10 - bend);
    kit_town_skyline(p, 90);
    along_kerbs(p, t, road, half, reach);
    for (int k = kit_choose(b, 3); k > 0; k--)
        kit_town_put(p, KIT_CAR, k & 1 ? -1.7 : 1.7, 0, kit_between(b, -20, 20), k & 1 ? 180 : 0);
    overhead(p, half, reach, 1 - t->upkeep);
    kit_town_sight(p, 0, 3, 0, 9);
    kit_town_sight(p, 0, 2, kit_between(b, -15, 15), 14);
    kit_town_range(p, -half + 1, -0.9 * reach, half - 1, 0.9 * reach);
}

/* ---- >>alley --------------------------------------------------------------------------------------------------- */

void kit_town_lay_alley(kit_plot *p, kit_town *t)
{
    static const int odd[] = { KIT_BIN,      KIT_BIN,    KIT_CRATES, KIT_PALLET, KIT_POT,  KIT_BICYCLE,
                               KIT_DUMPSTER, KIT_PERSON, KIT_CRATES, KIT_POT,    KIT_BENCH };
    kit_build *b = &p->b;
    const double half = kit_between(b, 1.3, 2.6), reach = kit_between(b, 14, 24),
                 paved[4] = { -half + 0.02, -12, half - 0.02, 12 };
    kit_town_ground(p, 200);
    kit_town_paving(b, paved, 0.015, kit_between(b, 0.2, 0.5));
    t->pave = 0;
    t->upkeep *= 0.5;
    t->scaffold = 0;
    if (t->style[0] == KIT_COTTAGE) t->style[0] = KIT_OLD;
    kit_town_row(p, t, -half, reach, -half, -reach);
    kit_town_row(p, t, half, -reach, half, reach);
    kit_town_row(p, t, -half - 10, -reach - 5, half + 10, -reach - 5);
    kit_town_row(p, t, half + 10, reach + 6, -half - 10, reach + 6);
    kit_town_skyline(p, 80);
    for (double z = -0.8 * reach; z < 0.8 * reach; z += kit_between(b, 1.2, 4)) {
        const int side = kit_odds(b, 0.5) ? 1 : -1, what = ANY(b, odd);
        const double off = what == KIT_BICYCLE ? 0.35 : what == KIT_DUMPSTER ? 0.8 : what == KIT_BIN ? 0.45 : 0.6;
        kit_town_put(p, what, side * (half - off), 0.02, z, (side > 0 ? -90 : 90) + kit_between(b, -6, 6));
    }
    kit_begin_object(b, "washing", -1);
    for (double z = -0.8 * reach; z < 0.8 * reach; z += kit_between(b, 1.5, 7)) {
        const kit_frame was = kit_enter(b, -half, kit_between(b, 3.2, 9), z, kit_between(b, -8, 8), 1);
        if (kit_odds(b, 0.7)) kit_town_laundry(b, 2 * half);
        else kit_town_bunting(b, 2 * half);
        kit_leave(b, was);
    }
    for (int k = 0; k < 3; k++) kit_add_lamp(p, kit_between(b, -half, half) * 0.8, 3.5, kit_between(b, -10, 10));
    overhead(p, half, reach, 0);
    kit_town_sight(p, 0, 3, 0, 5);
    kit_town_range(p, -0.5 * half, -0.8 * reach, 0.5 * half, 0.8 * reach);
}

/* ---- >>square -------------------------------------------------------------------------------------------------- */

/* A market, tables, trees, or an open place with a few of everything. */
static void on_the_square(kit_plot *p, double half, double y)
{
    static const int few[] = { KIT_BENCH, KIT_BIN,     KIT_PERSON, KIT_PERSON,  KIT_TREE, KIT_LAMP,
                               KIT_CAFE,  KIT_BOLLARD, KIT_POT,    KIT_BICYCLE, KIT_STALL };
    static const int kinds[][4] = { { KIT_STALL, KIT_STALL, KIT_CRATES, KIT_PERSON },
                                    { KIT_CAFE, KIT_CAFE, KIT_POT, KIT_PERSON },
                                    { KIT_TREE, KIT_BENCH, KIT_TREE, KIT_SHRUB },
                                    { KIT_PERSON, KIT_BENCH, KIT_LAMP, KIT_BOLLARD },
                                    { KIT_CAR, KIT_CAR, KIT_CAR, KIT_LAMP } };
    kit_build *b = &p->b;
    const int kind = kit_choose(b, 5);
    const double step = kind < 2 ? kit_between(b, 3.8, 5) : kit_between(b, 5, 7), inner = half - 5;
    for (double x = -inner; x <= inner; x += step)
        for (double z = -inner; z <= inner; z += step) {
            const int what = kit_odds(b, 0.2) ? ANY(b, few) : kinds[kind][kit_choose(b, 4)];
            if (hypot(x, z) < 4 || kit_odds(b, 0.35)) continue;
            kit_town_put(p, what, x + kit_between(b, -0.5, 0.5), y, z + kit_between(b, -0.5, 0.5),
                         (kit_odds(b, 0.5) ? 0 : 180) + kit_between(b, -8, 8)
                             + (what == KIT_PERSON ? kit_between(b, 0, 360) : 0));
        }
}

void kit_town_lay_square(kit_plot *p, kit_town *t)
{
    kit_build *b = &p->b;
    const double half = kit_between(b, 13, 24), gap = kit_between(b, 2, 4), in = half - 3.2,
                 r[4] = { -in, -in, in, in };
    kit_town_ground(p, 260);
    t->pave = 0.02;
    kit_town_paving(b, r, 0.015, kit_between(b, 0.5, 1.2));
    for (int k = 0; k < 4; k++) {
        const double a = KIT_PI / 2 * k, c = cos(a), s = sin(a), x0 = -half + gap, x1 = half, z = -half;
        kit_town_row(p, t, c * x0 + s * z, c * z - s * x0, c * x1 + s * z, c * z - s * x1);
    }
    kit_town_skyline(p, 75);
    if (kit_odds(b, 0.5)) kit_town_put(p, KIT_FOUNTAIN, 0, 0.02, 0, 0);
    else kit_town_put(p, kit_odds(b, 0.7) ? KIT_MONUMENT : KIT_TREE, 0, 0.02, 0, 0);
    on_the_square(p, half, 0.022);
    if (kit_odds(b, 0.4)) overhead(p, half, 0.7 * half, 0);
    kit_town_sight(p, 0, 2, 0, 7);
    kit_town_sight(p, 0, 3, 0, 12);
    kit_town_range(p, -half + 1.2, -half + 1.2, half - 1.2, half - 1.2);
}

/* ---- >>court --------------------------------------------------------------------------------------------------- */

void kit_town_lay_court(kit_plot *p, kit_town *t)
{
    static const int odd[] = { KIT_BIN,  KIT_BIN,    KIT_BICYCLE, KIT_BICYCLE, KIT_POT, KIT_POT,   KIT_BENCH,
                               KIT_CAFE, KIT_CRATES, KIT_PALLET,  KIT_SHRUB,   KIT_CAR, KIT_PERSON };
    kit_build *b = &p->b;
    const double hx = kit_between(b, 5, 9), hz = kit_between(b, 5, 10),
                 in[4] = { -hx + 0.7, -hz + 0.7, hx - 0.7, hz - 0.7 };
    kit_town_ground(p, 200);
    kit_town_paving(b, in, 0.015, kit_between(b, 0.25, 0.7));
    t->pave = 0.005;
    t->shops = kit_odds(b, 0.2);
    kit_town_row(p, t, -hx, -hz, hx, -hz);
    kit_town_row(p, t, hx, -hz, hx, hz);
    kit_town_row(p, t, hx, hz, -hx, hz);
    kit_town_row(p, t, -hx, hz, -hx, -hz);
    if (kit_odds(b, 0.6)) kit_town_put(p, KIT_TREE, kit_between(b, -2, 2), 0.01, kit_between(b, -2, 2), 0);
    else if (kit_odds(b, 0.5)) kit_town_put(p, KIT_FOUNTAIN, 0, 0.02, 0, 0);
    for (int k = 6 + kit_choose(b, 16); k > 0; k--) {
        const int side = kit_choose(b, 4), what = ANY(b, odd), z_side = side & 1;
        const double along = kit_between(b, -0.8, 0.8) * (z_side ? hz : hx), off = what == KIT_CAR     ? 2.3
                                                                                 : what == KIT_CAFE    ? 1.6
                                                                                 : what == KIT_BICYCLE ? 0.4
                                                                                                       : 0.7;
        const double out = (z_side ? hx : hz) - off, x = z_side ? (side == 1 ? out : -out) : along,
                     z = z_side    ? along
                       : side == 0 ? -out
                                   : out;
        kit_town_put(p, what, x, 0.02, z,
                     (side == 0   ? 0
                      : side == 1 ? -90
                      : side == 2 ? 180
                                  : 90)
                         + kit_between(b, -6, 6));
    }
    kit_begin_object(b, "washing", -1);
    for (int k = kit_choose(b, 5); k > 0; k--) {
        const kit_frame was = kit_enter(b, -hx, kit_between(b, 3, 8), kit_between(b, -0.8, 0.8) * hz, 0, 1);
        kit_town_laundry(b, 2 * hx);
        kit_leave(b, was);
    }
    kit_add_lamp(p, -hx + 0.5, 3.2, 0);
    kit_add_lamp(p, hx - 0.5, 3.2, kit_between(b, -3, 3));
    kit_town_sight(p, 0, 1.5, 0, 4);
    kit_town_range(p, -hx + 1, -hz + 1, hx - 1, hz - 1);
}

/* ---- >>steps --------------------------------------------------------------------------------------------------- */

/* terraces: how long, how high each is above the last, how many to either side */
static double terrace_ground(const kit_plot *p, double x, double z)
{
    const double k = floor(z / p->of[0] + 0.5), along = z - p->of[0] * (k - 0.5), run = p->of[3];
    (void)x;
    const double step = fmax(-p->of[2], fmin(p->of[2], k));
    return p->of[1] * (step - (along < run && step > -p->of[2] && !(k > p->of[2]) ? 1 - along / run : 0));
}

/* A terrace and the flight up to it, which begins at z = 0; long, half as wide, rising by so much. */
static void terrace(kit_build *b, double length, double half, double rise, double run)
{
    const int steps = (int)floor(rise / 0.155 + 0.5);
    const double paved[4] = { -half + 0.02, run + 0.02, half - 0.02, length };
    const double hand[4][3] = {
        { 0, -rise + 0.1, 0 }, { 0, -rise + 0.95, -0.02 }, { 0, 0.95, run }, { 0, 0, run + 0.1 }
    };
    kit_colour(b, 0.44, 0.42, 0.38);
    kit_box(b, -half - 14, -9, run, half + 14, 0, length);
    for (int side = -1; side <= 1; side += 2)
        kit_box(b, side < 0 ? -half - 14 : half, -9, 0, side < 0 ? -half : half + 14, 0.001, run);
    for (int k = 0; k < steps; k++) {
        const double y = -rise + rise * (k + 1) / (steps + 1), z = run * k / steps;
        kit_box(b, -half, -9, z + 0.03, half, y - 0.05, run);
        kit_box(b, -half + 0.001, y - 0.051, z, half - 0.001, y, z + run / steps + 0.03);
    }
    kit_town_paving(b, paved, 0.015, kit_between(b, 0.4, 0.6));
    kit_colour(b, 0.1, 0.1, 0.1);
    kit_tube(b, hand, 4, 0.025, 8);
}

void kit_town_lay_steps(kit_plot *p, kit_town *t)
{
    static const int odd[] = { KIT_POT,     KIT_POT, KIT_BENCH,  KIT_PERSON, KIT_LAMP, KIT_CAFE,
                               KIT_BICYCLE, KIT_BIN, KIT_CRATES, KIT_SHRUB,  KIT_TREE };
    kit_build *b = &p->b;
    const double length = kit_between(b, 7, 10), half = kit_between(b, 2, 4), rise = kit_between(b, 0.9, 1.6),
                 run = 1.9 * rise;
    const double of[4] = { length, rise, 2, run };
    kit_begin_object(b, "ground", 0);
    kit_colour(b, 0.36, 0.34, 0.31);
    kit_level(b, -260, -260, 260, 260, -3 * rise);
    memcpy(p->of, of, sizeof of);
    p->ground = terrace_ground;
    for (int k = -2; k <= 2; k++) {
        const kit_frame was = kit_enter(b, 0, rise * k, (k - 0.5) * length, 0, 1);
        terrace(b, k == 2 ? 60 : length, half, rise, run);
        kit_leave(b, was);
    }
    for (int k = -2; k <= 2; k++) {
        const double z = (k - 0.5) * length;
        t->pave = rise * k + 0.002;
        kit_town_row(p, t, -half, z + length, -half, z + 0.05);
        kit_town_row(p, t, half, z + 0.05, half, z + length);
        for (int n = 2 + kit_choose(b, 3); n > 0; n--) {
            const int side = kit_odds(b, 0.5) ? 1 : -1, what = ANY(b, odd);
            kit_town_put(p, what, side * (half - (what == KIT_CAFE ? 1.1 : 0.55)), rise * k + 0.022,
                         z + kit_between(b, run + 0.5, length - 0.5), (side < 0 ? 90 : -90) + kit_between(b, -8, 8));
        }
    }
    t->pave = 2 * rise;
    kit_town_row(p, t, half + 12, 2.5 * length + 7, -half - 12, 2.5 * length + 7);
    kit_town_skyline(p, 70);
    overhead(p, half, length, 1 - t->upkeep);
    kit_town_sight(p, 0, 1.5, 0, 6);
    kit_town_range(p, -0.6 * half, -2.4 * length, 0.6 * half, 2.4 * length);
}
