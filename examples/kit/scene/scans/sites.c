/* sites.c - scans in the open: ruins, sand, a garden. Declared in scans.h. */
#include "kit/scene/scans/scans.h"
#include <math.h>
#include <string.h>

static const float stones[][3] = {
    { 0.8f, 0.78f, 0.74f }, { 0.72f, 0.68f, 0.6f }, { 0.55f, 0.5f, 0.44f }, { 0.6f, 0.6f, 0.6f }
};
static const int persons[] = { STATUE, STATUE, SEATED, TORSO, BUST };

/* ---- >>grounds ------------------------------------------------------------------------------------------------- */

/* of[0] amplitude, [1] width, [2] ripples, [3] seed, [4] flat within; the ground rises far off */
static double dunes(const void *of, double x, double z)
{
    const double *o = of, far = fmax(0, hypot(x, z) - 14) / 46;
    const unsigned seed = (unsigned)o[3];
    const double wave = kit_fractal(seed, x / o[1], 0, z / o[1], 3), bend = kit_noise(seed + 9u, 0.5 * x, 0, 0.5 * z);
    return o[0] * wave + o[2] * sin(9 * x + 3 * z + 6 * bend)
         + far * far * 9 * (1 + 0.5 * kit_noise(seed, 0.07 * x, 3, 0.07 * z));
}

/* of[4], [5] half sides of a platform about (0, of[6]), turned by of[7] degrees, so high (of[8]), if any */
static double plot_dunes(const kit_plot *p, double x, double z)
{
    const double *o = p->of, c = cos(o[7] * KIT_PI / 180), s = sin(o[7] * KIT_PI / 180), dz = z - o[6];
    return fabs(c * x - s * dz) < o[4] && fabs(s * x + c * dz) < o[5] ? fmax(o[8], dunes(o, x, z)) : dunes(o, x, z);
}

static void open_ground(kit_plot *p, double rough, double wide, double ripples)
{
    kit_build *b = &p->b;
    static const double near_by[4] = { -10, -10, 10, 10 };
    const double of[4] = { rough, wide, ripples, (double)kit_choose(b, 1000) };
    memcpy(p->of, of, sizeof of);
    p->ground = plot_dunes;
    kit_height_field(b, near_by, 120, 120, dunes, p->of);
    for (int k = 0; k < 4; k++) {
        static const double far[4][4] = {
            { -70, -70, -10, 70 }, { 10, -70, 70, 70 }, { -10, -70, 10, -10 }, { -10, 10, 10, 70 }
        };
        kit_height_field(b, far[k], k < 2 ? 30 : 40, k < 2 ? 60 : 30, dunes, p->of);
    }
    p->stand[0] = p->stand[1] = -9;
    p->stand[2] = p->stand[3] = 9;
}

/* ---- >>layouts ------------------------------------------------------------------------------------------------- */

/* Models on the open ground, sunk a little, toppled as far as tilt. */
static void scatter(kit_plot *p, kit_style *s, const int *of, int kinds, int count, double least, double most,
                    double tilt)
{
    kit_build *b = &p->b;
    for (int k = 0; k < count; k++) {
        const double a = kit_between(b, 0, 2 * KIT_PI), r = kit_between(b, 0.5, 1) * (1.5 + 5 * sqrt(kit_chance(b))),
                     high = least * pow(most / least, kit_chance(b)), x = r * cos(a), z = r * sin(a);
        const double lean = kit_odds(b, 0.6) ? kit_between(b, -0.25, 0.25) * tilt : kit_between(b, -1, 1) * tilt;
        const double at[3] = { x, kit_ground_at(p, x, z) - high * kit_between(b, 0.03, 0.16), z };
        scan_place_scan(p, s, scan_next_scan(b, s, of, kinds), at, kit_between(b, 0, 360), lean, high, 1);
    }
}

/* Small stones, joined to one object. */
static void pebbles(kit_plot *p, const kit_style *s, int count, double most)
{
    kit_build *b = &p->b;
    kit_style coarse = *s;
    coarse.cells = 16; /* a stone has half as many */
    kit_begin_object(b, "pebbles", -1);
    for (int k = 0; k < count; k++) {
        const double x = kit_between(b, -5, 5), z = kit_between(b, -5, 5),
                     high = 0.03 * pow(most / 0.03, kit_chance(b));
        const double at[3] = { x, kit_ground_at(p, x, z) - 0.2 * high, z };
        scan_place_scan(p, &coarse, ROCK, at, kit_between(b, 0, 360), 0, high, 0);
    }
}

/* blocks of a wall, as they fell */
static void blocks(kit_plot *p, int count)
{
    kit_build *b = &p->b;
    for (int k = 0; k < count; k++) {
        const double x = kit_between(b, -6, 6), z = kit_between(b, -6, 6), h = kit_between(b, 0.15, 0.4),
                     y = kit_ground_at(p, x, z);
        kit_begin_object(b, "block", -1);
        KIT_TINT(b, stones, 0.2);
        kit_place_tilted(b, x, y + 0.4 * h, z, kit_between(b, 0, 360), kit_between(b, -25, 25));
        kit_bevelled(b, -1.7 * h, -h, -h, 1.7 * h, h, h, 0.05 * h);
        kit_add_sight(p, x, y + 0.2, z, 2 * h);
    }
}

/* What is left of a temple: steps, columns, statues and their pieces. */
void scan_ruins(kit_plot *p, kit_style *s)
{
    kit_build *b = &p->b;
    static const int pieces[] = { TORSO, TORSO, DRUM, COLUMN, BUST, HAND, ROCK, SKULL, VASE, STATUE, MASK, BEAST };
    const double turn = kit_between(b, -40, 40), tall = kit_between(b, 1.6, 3.5);
    const int columns = 2 + kit_choose(b, 4);
    kit_begin_object(b, "ground", 0);
    kit_colour(b, 0.42, 0.37, 0.29);
    open_ground(p, kit_between(b, 0.08, 0.25), kit_between(b, 0.9, 2.5), 0);
    const double steps[5] = { 3.6, 1.2, -2, turn, 0.28 };
    memcpy(p->of + 4, steps, sizeof steps);
    const kit_frame before = kit_enter(b, 0, 0, -2, turn, 1);
    kit_begin_object(b, "steps", -1);
    KIT_TINT(b, stones, 0.15);
    for (int k = 0; k < 3; k++)
        kit_bevelled(b, -4 + 0.3 * k, -0.5 + 0.24 * k, -1.6 + 0.3 * k, 4 - 0.3 * k, -0.2 + 0.24 * k, 1.6 - 0.3 * k,
                     0.015);
    s->matter = 0;
    for (int k = 0; k < columns; k++) {
        const double at[3] = { -2.6 + 5.2 * k / (columns - 1), 0.27, -0.3 };
        scan_place_scan(p, s, COLUMN, at, 0, 0, tall, 1);
    }
    if (kit_odds(b, 0.6))
        scan_place_upright(p, s, ANY(b, persons), kit_between(b, -1, 1), 0.27, 0.5, kit_between(b, -30, 30),
                           kit_between(b, 1.4, 2.4));
    kit_leave(b, before);
    s->cells = (int)(0.6 * s->cells);
    scatter(p, s, pieces, (int)(sizeof pieces / sizeof *pieces), 8 + kit_choose(b, 9), 0.3, 1.6, 100);
    blocks(p, 6 + kit_choose(b, 12));
    pebbles(p, s, 50, 0.25);
}

/* Half buried in sand: a colossus, or what the sea left. */
void scan_sands(kit_plot *p, kit_style *s)
{
    kit_build *b = &p->b;
    static const int washed[] = { SNAIL, AMMONITE, CORAL, CORAL, SPONGE, ROOT, VASE, SKULL, ROCK, BOWL },
                     desert[] = { BUST, HAND, TORSO, SKULL, ROOT, DRUM, VASE, BEAST, SEATED, ROCK },
                     giants[] = { BUST, HAND, SEATED, SKULL, BEAST };
    const int sea = kit_odds(b, 0.5);
    kit_begin_object(b, "ground", 0);
    if (sea) kit_colour(b, 0.6, 0.55, 0.43);
    else kit_colour(b, 0.66, 0.5, 0.32);
    open_ground(p, kit_between(b, 0.1, 0.45), kit_between(b, 3, 6), kit_between(b, 0, 0.02));
    if (!sea || kit_odds(b, 0.3)) {
        const double at[3] = { 0, kit_ground_at(p, 0, 0) - 0.3, 0 };
        scan_place_scan(p, s, ANY(b, giants), at, kit_between(b, 0, 360), kit_between(b, -25, 25),
                        kit_between(b, 2, 4.5), 1);
    }
    s->cells = (int)(0.6 * s->cells);
    scatter(p, s, sea ? washed : desert, 10, 12 + kit_choose(b, 10), 0.2, sea ? 1.5 : 1.8, sea ? 35 : 80);
    pebbles(p, s, sea ? 70 : 25, 0.2);
    for (int k = 0, bones = kit_odds(b, 0.5) ? 9 : 0; k < bones; k++) { /* a ribcage */
        kit_begin_object(b, "rib", -1);
        kit_colour(b, 0.78, 0.74, 0.64);
        double at[9][3];
        for (int side = -1; side <= 1; side += 2) {
            for (int i = 0; i < 9; i++) {
                const double a = 0.32 * i - 0.3;
                at[i][0] = side * 0.7 * cos(a) + 2.6;
                at[i][1] = kit_ground_at(p, 2.6, 1) + 0.75 * sin(a);
                at[i][2] = 0.3 * k - 0.5;
            }
            kit_tube(b, (const double(*)[3])at, 9, 0.035, 10);
        }
    }
}

static void hedge(kit_plot *p, double x0, double z0, double x1, double z1, double high)
{
    kit_build *b = &p->b;
    kit_clay clay;
    memset(&clay, 0, sizeof clay);
    kit_begin_object(b, "hedge", -1);
    kit_colour(b, 0.12, 0.24 + kit_between(b, -0.04, 0.06), 0.07);
    scan_block(&clay, 0.5 * (x0 + x1), 0.5 * high, 0.5 * (z0 + z1), 0.5 * fabs(x1 - x0), 0.5 * high,
               0.5 * fabs(z1 - z0), 0.1, 0);
    clay.rough = 0.07;
    clay.grain = 0.13;
    clay.octaves = 2;
    clay.stain = 0.5;
    clay.facets = 1;
    clay.seed = kit_choose(b, 9999);
    scan_sculpt(b, &clay, 48);
}

/* A garden: a fountain, statues on plinths, hedges, urns, paving. */
void scan_garden(kit_plot *p, kit_style *s)
{
    kit_build *b = &p->b;
    const double r = kit_between(b, 1, 1.8), rim = kit_between(b, 0.35, 0.6), out = kit_between(b, 3.6, 5);
    static const int tops[] = { STATUE, SEATED, BEAST, DRAGON, BIRD, KNOT, SNAIL, HAND, BUST };
    const int round = 4 + 2 * kit_choose(b, 3), urns = kit_odds(b, 0.5);
    const kit_moulding basin[] = { { r + 0.25, 0, r + 0.2, 0.1, 0 },
                                   { r + 0.2, 0.1, r + 0.1, rim - 0.08, -0.05 },
                                   { r + 0.1, rim - 0.08, r + 0.16, rim, 0.03 },
                                   { r + 0.16, rim, r, rim, 0 },
                                   { r, rim, r - 0.1, 0.1, 0 },
                                   { r - 0.1, 0.1, 0, 0.1, 0 } };
    kit_begin_object(b, "ground", 0);
    kit_colour(b, 0.24, 0.33, 0.14);
    open_ground(p, 0.02, 2, 0);
    kit_begin_object(b, "paving", 0);
    KIT_TINT(b, stones, 0.1);
    for (int k = 0; k < 400; k++) {
        const double x = 0.5 * (k % 20) - 5, z = 0.5 * (double)(k / 20) - 5;
        if (hypot(x + 0.25, z + 0.25) > out - 0.3 && fabs(x + 0.25) > 0.6 && fabs(z + 0.25) > 0.6) continue;
        kit_box(b, x + 0.01, -0.2, z + 0.01, x + 0.49, 0.05 + kit_between(b, 0, 0.012), z + 0.49);
    }
    kit_begin_object(b, "fountain", 1);
    KIT_TINT(b, stones, 0.15);
    kit_place_at(b, 0, 0.06, 0, 0);
    kit_turned(b, basin, 6, 72);
    kit_place_at(b, 0, 0.165, 0, 0);
    scan_plinth(b, 0.7, 0.9);
    kit_add_sight(p, 0, rim, 0, r);
    scan_place_upright(p, s, NEXT(b, s, tops), 0, 1.066, 0, kit_between(b, 0, 360), kit_between(b, 0.8, 1.7));
    s->cells = (int)(0.6 * s->cells);
    for (int k = 0; k < round; k++) {
        const double a = 2 * KIT_PI * (k + 0.5) / round;
        const kit_frame before = kit_enter(b, out * cos(a), 0, out * sin(a), -90 - a * 180 / KIT_PI, 1);
        const int which = urns && k & 1 ? VASE : ANY(b, persons);
        kit_begin_object(b, "plinth", -1);
        KIT_TINT(b, stones, 0.15);
        scan_plinth(b, 0.7, 0.8);
        scan_place_upright(p, s, which, 0, 0.801, 0, 0, which == STATUE ? 1.7 : which == VASE ? 0.7 : 1);
        kit_leave(b, before);
    }
    for (int k = 0; k < 4; k++) {
        const double high = kit_between(b, 0.7, 2.2), far = out + 1.4, sx = k & 1 ? 1 : -1, sz = k & 2 ? 1 : -1;
        hedge(p, sx * 0.9, sz * far, sx * (far + 0.4), sz * (far + 0.7), high);
        hedge(p, sx * far, sz * 0.9, sx * (far + 0.7), sz * (far - 0.05), high);
    }
}
