/* relics.c - shells, corals, roots, pots, knots, stones to sculpt. Declared in scans.h. */
#include "kit/scene/scans/scans.h"
#include <math.h>

/* ---- >>of the sea ------------------------------------------------------------------------------------------------ */

/* A spiral of balls that grows by so much a turn and climbs by rise of its radius;
ribs: every other ball is thinner. */
static void add_spiral(kit_clay *c, double turns, double growth, double rise, double ribs)
{
    enum { A_TURN = 26 };

    const int count = (int)(A_TURN * turns);
    double top = 0;
    for (int k = 0; k < count; k++) {
        const double t = (double)(count - 1 - k) / A_TURN, r = 0.36 * pow(growth, -t), a = 2 * KIT_PI * t,
                     size = 0.52 * r * (1 - (k & 1 ? ribs : 0));
        scan_egg(c, r * cos(a), rise * (0.36 - r), r * sin(a), size, size, size, 0.02 * r);
        top = fmin(top, rise * (0.36 - r) - size);
    }
    for (int k = 0; k < count; k++) c->blob[k].a[1] -= top;
}

void kit_snail(kit_build *b, kit_clay *c)
{
    add_spiral(c, kit_between(b, 3, 4.5), kit_between(b, 1.6, 2.1), kit_between(b, 1.6, 3.2), kit_between(b, 0, 0.12));
    const kit_blob *mouth = &c->blob[c->blobs - 1];
    scan_egg(c, mouth->a[0] + 0.06, mouth->a[1], mouth->a[2] + 0.14, 0.13, 0.13, 0.2, 0.03)->carved = 1;
    if (kit_odds(b, 0.5)) {
        c->rough = 0.012;
        c->grain = 0.07;
        c->octaves = 2;
    }
}

/* leans upright on its edge */
void kit_ammonite(kit_build *b, kit_clay *c)
{
    double low = 1;
    add_spiral(c, kit_between(b, 3.5, 5), kit_between(b, 1.5, 1.9), 0, kit_between(b, 0.1, 0.25));
    for (int k = 0; k < c->blobs; k++) {
        kit_blob *e = &c->blob[k];
        e->a[1] = e->a[2];
        e->a[2] = 0;
        low = fmin(low, e->a[1] - e->b[1]);
    }
    for (int k = 0; k < c->blobs; k++) c->blob[k].a[1] -= low + 0.03;
}

/* A stem that forks: from at along way, so thick. */
static void branch(kit_build *b, kit_clay *c, const double at[3], const double way[3], double length, double radius,
                   int depth, double wide, double lift)
{
    double from[3] = { at[0], at[1], at[2] }, d[3] = { way[0], way[1], way[2] };
    const double end = radius * kit_between(b, 0.62, 0.8);
    for (int k = 0; k < 3; k++) {
        const double r0 = radius + (end - radius) * k / 3, r1 = radius + (end - radius) * (k + 1) / 3;
        double to[3];
        for (int i = 0; i < 3; i++) d[i] += kit_between(b, -0.3, 0.3) * wide + (i == 1 ? lift : 0);
        kit_unit(d);
        for (int i = 0; i < 3; i++) to[i] = from[i] + d[i] * length / 3;
        if (to[1] < r1) to[1] = r1;
        scan_limb(c, from[0], from[1], from[2], r0, to[0], to[1], to[2], r1, 0.8 * r1);
        for (int i = 0; i < 3; i++) from[i] = to[i];
    }
    for (int k = 0; k < 2 + kit_choose(b, 2) && depth > 0 && c->blobs < KIT_BLOBS - 6; k++) {
        double out[3];
        for (int i = 0; i < 3; i++) out[i] = d[i] + kit_between(b, -1, 1) * wide * 1.3;
        kit_unit(out);
        branch(b, c, from, out, length * kit_between(b, 0.65, 0.9), end, depth - 1, wide, lift);
    }
}

void kit_coral(kit_build *b, kit_clay *c)
{
    const double wide = kit_between(b, 0.5, 0.9), thick = kit_between(b, 0.03, 0.06);
    scan_egg(c, 0, 0.03, 0, 0.16, 0.06, 0.16, 0.03);
    for (int k = 0; k < 3; k++) {
        const double at[3] = { kit_between(b, -0.06, 0.06), 0.04, kit_between(b, -0.06, 0.06) },
                     way[3] = { kit_between(b, -0.7, 0.7), 1, kit_between(b, -0.7, 0.7) };
        branch(b, c, at, way, 0.3, thick, 3, wide, 0.12);
    }
    c->rough = kit_between(b, 0, 0.008);
    c->grain = 0.03;
    c->octaves = 2;
}

/* a stump whose roots creep over the ground */
void kit_root(kit_build *b, kit_clay *c)
{
    const int roots = 4 + kit_choose(b, 4);
    scan_limb(c, 0, 0.1, 0, 0.17, kit_between(b, -0.1, 0.1), kit_between(b, 0.35, 0.8), 0, kit_between(b, 0.09, 0.13),
              0.1);
    if (kit_odds(b, 0.6)) scan_limb(c, 0, 0.3, 0, 0.09, 0.3, 0.6, 0.1, 0.05, 0.06);
    for (int k = 0; k < roots; k++) {
        const double a = 2 * KIT_PI * (k + kit_chance(b)) / roots, at[3] = { 0.08 * cos(a), 0.16, 0.08 * sin(a) },
                     way[3] = { cos(a), -0.35, sin(a) };
        branch(b, c, at, way, 0.32, kit_between(b, 0.05, 0.085), 1 + kit_choose(b, 2), 0.4, -0.05);
    }
    c->rough = 0.018;
    c->grain = 0.09;
    c->octaves = 3;
}

/* walls along a minimal surface, within a ball: sponge */
static double sponge(const double of[KIT_RELIEF], const double p[3], double d)
{
    const double s = of[0], wall = fabs(sin(s * p[0]) * cos(s * p[1]) + sin(s * p[1]) * cos(s * p[2])
                                        + sin(s * p[2]) * cos(s * p[0]) + of[1])
                                     / (1.6 * s)
                                 - of[2];
    return fmax(d, wall);
}

void kit_gyroid(kit_build *b, kit_clay *c)
{
    scan_egg(c, 0, 0.48, 0, kit_between(b, 0.35, 0.5), 0.5, kit_between(b, 0.35, 0.5), 0);
    if (kit_odds(b, 0.5)) scan_egg(c, 0.2, 0.35, 0.1, 0.35, 0.37, 0.35, 0.1);
    c->relief = sponge;
    c->of[0] = kit_between(b, 9, 15);
    c->of[1] = kit_between(b, -0.4, 0.4);
    c->of[2] = kit_between(b, 0.022, 0.04);
}

/* ---- >>turned -------------------------------------------------------------------------------------------------- */

/* A pot's wall: [0] foot, [1] belly, [2] neck, [3] lip radius, [4] flutes, [5] their depth, [6] half the wall,
    [7] twist. */
static double pot(const double of[KIT_RELIEF], const double p[3], double d)
{
    const double y = fmax(0, fmin(1, p[1])), r = sqrt(p[0] * p[0] + p[2] * p[2]), a = atan2(p[2], p[0]);
    const double s = 3 * y, t = s - floor(fmin(s, 2.999)), w = t * t * (3 - 2 * t);
    const int k = (int)fmin(s, 2.999);
    const double out = of[k] + w * (of[k + 1] - of[k]), amid = fmax(0, 1 - fabs(y - 0.42) * 3),
                 wave = of[5] * amid * sin(of[4] * a + of[7] * y) + 0.3 * of[5] * sin(60 * y) * (y > 0.75);
    double wall = fabs(r - out - wave) * 0.8 - of[6];
    wall = fmax(wall, fmax(p[1] - 0.99, 0.005 - p[1]));
    wall = fmin(wall, fmax(fabs(p[1] - 0.025) - 0.02, r - of[0]));
    return d < 0 ? wall : fmin(d + 0.05, wall);
}

/* its block gives the bounds only */
void kit_vase(kit_build *b, kit_clay *c)
{
    c->relief = pot;
    c->of[0] = kit_between(b, 0.1, 0.2);
    c->of[1] = kit_between(b, 0.2, 0.42);
    c->of[2] = kit_between(b, 0.07, 0.3);
    c->of[3] = kit_between(b, 0.1, 0.28);
    c->of[4] = floor(kit_between(b, 5, 26));
    c->of[5] = kit_odds(b, 0.7) ? kit_between(b, 0.008, 0.03) : 0;
    c->of[6] = kit_between(b, 0.02, 0.028);
    c->of[7] = kit_odds(b, 0.4) ? kit_between(b, -12, 12) : 0;
    const double most = fmax(c->of[1], c->of[3]) + 0.05;
    scan_block(c, 0, 0.5, 0, most, 0.5, most, 0, 0);
    if (kit_odds(b, 0.25)) scan_cut_plane(c, 0.5, 1, 0.3, kit_between(b, 0.5, 0.8), 0.1); /* broken */
}

void kit_bowl(kit_build *b, kit_clay *c)
{
    scan_egg(c, 0, 0.5, 0, 0.5, 0.5, 0.5, 0);
    scan_cut_plane(c, 0, 1, 0, kit_between(b, 0.3, 0.55), kit_odds(b, 0.4) ? 0.08 : 0);
    if (kit_odds(b, 0.4)) scan_cut_ball(c, 0.45, 0.35, 0, kit_between(b, 0.15, 0.3), 0.08);
    c->rough = kit_odds(b, 0.5) ? 0.02 : 0;
    c->grain = kit_between(b, 0.1, 0.3);
    c->octaves = 2;
}

/* ---- >>stone --------------------------------------------------------------------------------------------------- */

void kit_knot(kit_build *b, kit_clay *c)
{
    enum { PIECES = 96 };

    static const int kinds[5][2] = { { 2, 3 }, { 3, 2 }, { 2, 5 }, { 3, 4 }, { 5, 2 } };
    const int *of = kinds[kit_choose(b, 5)];
    const double thick = kit_between(b, 0.035, 0.07), deep = kit_between(b, 0.12, 0.17);
    double last[3] = { 0 };
    for (int k = 0; k <= PIECES; k++) {
        const double t = 2 * KIT_PI * (k % PIECES) / PIECES, r = 0.28 + deep * cos(of[1] * t),
                     p[3] = { r * cos(of[0] * t), 0.5 + r * sin(of[0] * t), deep * sin(of[1] * t) };
        if (k) scan_limb(c, last[0], last[1], last[2], thick, p[0], p[1], p[2], thick, 0.25 * thick);
        for (int i = 0; i < 3; i++) last[i] = p[i];
    }
    scan_block(c, 0, 0.03, 0, 0.15, 0.03, 0.15, 0.005, 0.02);
}

void kit_rock(kit_build *b, kit_clay *c)
{
    for (int k = 0; k < 4; k++)
        scan_egg(c, kit_between(b, -0.25, 0.25), kit_between(b, 0.1, 0.35), kit_between(b, -0.2, 0.2),
                 kit_between(b, 0.15, 0.3), kit_between(b, 0.15, 0.3), kit_between(b, 0.15, 0.3), 0.1);
    for (int k = 0; k < 4; k++) {
        const double a = kit_between(b, 0, 2 * KIT_PI);
        scan_block(c, 0.75 * cos(a), kit_between(b, 0.2, 0.7), 0.75 * sin(a), 0.35, 0.35, 0.35, 0.01, 0.01)->carved = 1;
    }
    c->rough = kit_between(b, 0.01, 0.04);
    c->grain = kit_between(b, 0.08, 0.25);
    c->octaves = 3;
}

/* of[0] flutes about the axis, radius of[1], depth of[2], up to of[3] from the middle */
static double flutes(const double of[KIT_RELIEF], const double p[3], double d)
{
    const double r = sqrt(p[0] * p[0] + p[2] * p[2]), at = fabs(sin(0.5 * of[0] * atan2(p[2], p[0])));
    return fabs(p[1] - 0.5) > of[3] ? d : fmax(d, r - of[1] - of[2] * (1 - 1.4 * sqrt(at)));
}

/* a piece of a fluted column, broken off at the top */
void kit_drum(kit_build *b, kit_clay *c)
{
    scan_block(c, 0, 0.5, 0, 0.3, 0.5, 0.3, 0.01, 0);
    for (int k = 0; k < 2; k++)
        scan_egg(c, kit_between(b, -0.3, 0.3), 1.02, kit_between(b, -0.3, 0.3), 0.3, kit_between(b, 0.1, 0.5), 0.3,
                 0.02)
            ->carved = 1;
    c->relief = flutes;
    c->of[0] = 16;
    c->of[1] = 0.27;
    c->of[2] = 0.03;
    c->of[3] = 9;
    c->rough = 0.008;
    c->grain = 0.08;
    c->octaves = 3;
}

/* whole, with base and capital, or a stump */
void kit_column(kit_build *b, kit_clay *c)
{
    const int whole = kit_odds(b, 0.4);
    const double high = whole ? 1 : kit_between(b, 0.25, 0.9);
    scan_block(c, 0, 0.5 * high, 0, 0.1, 0.5 * high, 0.1, 0.004, 0);
    scan_block(c, 0, 0.02, 0, 0.15, 0.02, 0.15, 0.004, 0);
    scan_limb(c, 0, 0.055, 0, 0.125, 0, 0.056, 0, 0.125, 0.01);
    if (whole) {
        scan_egg(c, 0, 0.91, 0, 0.135, 0.05, 0.135, 0.01);
        scan_block(c, 0, 0.965, 0, 0.16, 0.035, 0.16, 0.006, 0);
    } else scan_egg(c, kit_between(b, -0.12, 0.12), high, 0.05, 0.1, kit_between(b, 0.04, 0.15), 0.1, 0.01)->carved = 1;
    c->relief = flutes;
    c->of[0] = 16;
    c->of[1] = 0.095;
    c->of[2] = 0.012;
    c->of[3] = 0.36;
    c->rough = 0.003;
    c->grain = 0.04;
    c->octaves = 2;
}
