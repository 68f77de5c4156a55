/* figures.c - people and animals to sculpt. Declared in scans.h. */
#include "kit/scene/scans/scans.h"
#include <math.h>
#include <string.h>

/* ---- >>people -------------------------------------------------------------------------------------------------- */

/* folds that hang from height of[0] to the ground, so deep, so many; of[4], of[5]: about where */
static double folds(const double of[KIT_RELIEF], const double p[3], double d)
{
    const double down = fmax(0, fmin(1, (of[0] - p[1]) / of[0])), a = atan2(p[2] - of[5], p[0] - of[4]);
    return d + of[1] * down * sin(of[2] * a + of[3] + 5 * p[1]) + 0.4 * of[1] * down * sin(2.3 * of[2] * a - 9 * p[1]);
}

/* A head of size 1 about its middle: skull, face, hair; scaled, moved, nodding by the body's lean. */
static void add_head(kit_build *b, kit_clay *c, double x, double y, double z, double s)
{
    const int hair = kit_choose(b, 4);
    scan_egg(c, x, y + 0.06 * s, z - 0.04 * s, 0.37 * s, 0.43 * s, 0.44 * s, 0.05 * s);
    scan_egg(c, x, y - 0.2 * s, z + 0.1 * s, 0.25 * s, 0.3 * s, 0.26 * s, 0.2 * s); /* jaw */
    scan_egg(c, x + 0.14 * s, y - 0.02 * s, z + 0.42 * s, 0.09 * s, 0.075 * s, 0.1 * s, 0.1 * s)->carved = 1;
    scan_egg(c, x - 0.14 * s, y - 0.02 * s, z + 0.42 * s, 0.09 * s, 0.075 * s, 0.1 * s, 0.1 * s)->carved = 1;
    scan_egg(c, x + 0.14 * s, y - 0.02 * s, z + 0.31 * s, 0.065 * s, 0.06 * s, 0.05 * s, 0.01 * s); /* eyes */
    scan_egg(c, x - 0.14 * s, y - 0.02 * s, z + 0.31 * s, 0.065 * s, 0.06 * s, 0.05 * s, 0.01 * s);
    scan_limb(c, x, y + 0.04 * s, z + 0.36 * s, 0.03 * s, x, y - 0.14 * s, z + 0.43 * s, 0.055 * s, 0.05 * s);
    scan_limb(c, x - 0.08 * s, y - 0.27 * s, z + 0.34 * s, 0.02 * s, x + 0.08 * s, y - 0.27 * s, z + 0.34 * s, 0.02 * s,
              0.03 * s);
    scan_limb(c, x - 0.07 * s, y - 0.325 * s, z + 0.34 * s, 0.022 * s, x + 0.07 * s, y - 0.325 * s, z + 0.34 * s,
              0.022 * s, 0.02 * s);
    scan_egg(c, x, y - 0.46 * s, z + 0.28 * s, 0.08 * s, 0.06 * s, 0.07 * s, 0.1 * s);
    scan_egg(c, x + 0.37 * s, y - 0.06 * s, z - 0.03 * s, 0.035 * s, 0.11 * s, 0.07 * s, 0.02 * s);
    scan_egg(c, x - 0.37 * s, y - 0.06 * s, z - 0.03 * s, 0.035 * s, 0.11 * s, 0.07 * s, 0.02 * s);
    for (int i = 0; i < 46 && hair; i++) { /* curls */
        const double a = kit_between(b, 0.2 * KIT_PI, 1.8 * KIT_PI) + KIT_PI / 2, up = kit_between(b, 0, 1.5),
                     w = cos(up), r = kit_between(b, 0.07, 0.12) * s;
        scan_egg(c, x + 0.38 * s * w * cos(a), y + (0.06 + 0.44 * sin(up)) * s, z + (0.45 * w * sin(a) - 0.05) * s, r,
                 r, r, 0.02 * s);
    }
    if (hair == 2) scan_limb(c, x, y, z - 0.4 * s, 0.22 * s, x, y - 0.75 * s, z - 0.35 * s, 0.12 * s, 0.1 * s);
    if (hair == 3) scan_egg(c, x, y + 0.42 * s, z - 0.32 * s, 0.17 * s, 0.17 * s, 0.17 * s, 0.04 * s);
    for (int i = 0; i < 12 && kit_odds(b, 0.4) && hair == 1; i++) /* a beard */
        scan_egg(c, x + kit_between(b, -0.2, 0.2) * s, y - kit_between(b, 0.38, 0.62) * s,
                 z + kit_between(b, 0.15, 0.3) * s, 0.09 * s, 0.12 * s, 0.09 * s, 0.03 * s);
}

/* From the shoulder on side s (1, -1): hanging, on the hip, raised, stretched forward, with a staff. */
static void add_arm(kit_build *b, kit_clay *c, const double at[3], double s)
{
    static const double way[5][2][3] = { { { 0.18, -1, 0.05 }, { 0.05, -1, 0.3 } },
                                         { { 0.75, -0.75, -0.3 }, { -0.85, -0.5, 0.5 } },
                                         { { 0.8, 0.6, 0.1 }, { 0.1, 1, 0.2 } },
                                         { { 0.25, -0.5, 0.8 }, { 0, 0.25, 1 } },
                                         { { 0.5, -0.8, 0.35 }, { 0.1, 0.35, 0.9 } } };
    const int pose = kit_choose(b, 5);
    double joint[3][3];
    memcpy(joint[0], at, sizeof joint[0]);
    for (int k = 0; k < 2; k++) {
        double d[3];
        for (int i = 0; i < 3; i++) d[i] = way[pose][k][i] * (i ? 1 : s) + kit_between(b, -0.15, 0.15);
        kit_unit(d);
        for (int i = 0; i < 3; i++) joint[k + 1][i] = joint[k][i] + (k ? 0.15 : 0.165) * d[i];
        scan_limb(c, joint[k][0], joint[k][1], joint[k][2], k ? 0.026 : 0.036, joint[k + 1][0], joint[k + 1][1],
                  joint[k + 1][2], k ? 0.017 : 0.027, 0.02);
        for (int f = 0; f < 5 && k; f++) { /* fingers */
            const double *w = joint[2];
            scan_limb(c, w[0], w[1], w[2], 0.018, w[0] + 0.06 * d[0] + 0.009 * (f - 2) * s, w[1] + 0.06 * d[1],
                      w[2] + 0.06 * d[2] + 0.006 * (f - 2), 0.0075, 0.008);
        }
    }
    if (pose == 4) scan_limb(c, joint[2][0], 0.012, joint[2][2], 0.011, joint[2][0], 1.05, joint[2][2], 0.011, 0.01);
}

static void add_trunk(kit_build *b, kit_clay *c, double y, double wide, int arms)
{
    const double lean = kit_between(b, -0.02, 0.02);
    scan_egg(c, 0, y, 0, 0.085 * wide, 0.075, 0.068, 0.04);
    scan_limb(c, 0, y + 0.05, 0, 0.068 * wide, lean, y + 0.2, 0.005, 0.078 * wide, 0.06);
    scan_egg(c, lean, y + 0.22, 0.01, 0.105 * wide, 0.09, 0.07, 0.05);
    scan_limb(c, lean - 0.1 * wide, y + 0.28, 0, 0.033, lean + 0.1 * wide, y + 0.28, 0, 0.033, 0.05);
    scan_limb(c, lean, y + 0.28, -0.005, 0.036, lean, y + 0.36, 0.01, 0.032, 0.03);
    for (int s = -1; s <= 1 && arms; s += 2) {
        const double at[3] = { lean + s * 0.115 * wide, y + 0.275, 0 };
        add_arm(b, c, at, s);
    }
    add_head(b, c, lean + kit_between(b, -0.01, 0.01), y + 0.405, 0.02, 0.135);
}

static void add_leg(kit_clay *c, const double hip[3], const double knee[3], const double ankle[3])
{
    scan_limb(c, hip[0], hip[1], hip[2], 0.06, knee[0], knee[1], knee[2], 0.037, 0.03);
    scan_limb(c, knee[0], knee[1], knee[2], 0.036, ankle[0], ankle[1], ankle[2], 0.02, 0.02);
    scan_limb(c, knee[0], knee[1] - 0.06, ankle[2] + 0.6 * (knee[2] - ankle[2]) - 0.012, 0.034, ankle[0],
              ankle[1] + 0.05, ankle[2], 0.018, 0.02);
    scan_limb(c, ankle[0], 0.024, ankle[2] - 0.01, 0.022, ankle[0] * 1.2, 0.014, ankle[2] + 0.09, 0.015, 0.015);
}

/* folds of a robe from the belt down */
static void add_robe(kit_build *b, kit_clay *c, double y, double wide)
{
    scan_limb(c, 0, y + 0.02, 0, 0.09, 0, 0.03, 0, wide, 0.05);
    scan_block(c, 0, 0.01, 0, wide + 0.01, 0.012, wide + 0.01, 0.004, 0);
    c->relief = folds;
    c->of[0] = y;
    c->of[1] = kit_between(b, 0.008, 0.018);
    c->of[2] = floor(kit_between(b, 7, 16));
    c->of[3] = kit_between(b, 0, 6);
}

void kit_statue(kit_build *b, kit_clay *c)
{
    const double wide = kit_between(b, 0.8, 1.1), free_leg = kit_odds(b, 0.5) ? 1 : -1, step = kit_between(b, 0, 0.1);
    if (kit_odds(b, 0.4)) add_robe(b, c, 0.5, kit_between(b, 0.1, 0.17));
    else
        for (int s = -1; s <= 1; s += 2) {
            const double bent = s * free_leg > 0 ? 1 : 0;
            const double hip[3] = { s * 0.05, 0.5, 0 },
                         knee[3] = { s * (0.055 + 0.02 * bent), 0.28, bent * (0.04 + step) },
                         ankle[3] = { s * (0.06 + 0.03 * bent), 0.05, bent * (step - 0.05) };
            add_leg(c, hip, knee, ankle);
        }
    if (kit_odds(b, 0.4)) /* a cloak behind */
        scan_limb(c, 0, 0.76, -0.05, 0.07, kit_between(b, -0.06, 0.06), 0.06, -0.1, 0.05, 0.02);
    scan_block(c, 0, 0.006, 0, 0.16, 0.008, 0.16, 0.003, 0);
    add_trunk(b, c, 0.54, wide, 1);
}

void kit_seated(kit_build *b, kit_clay *c)
{
    const double seat = kit_between(b, 0.24, 0.29), crossed = kit_odds(b, 0.3) ? 1 : 0;
    for (int s = -1; s <= 1; s += 2) {
        const double up = s > 0 ? crossed : 0;
        const double hip[3] = { s * 0.055, seat + 0.05, 0 },
                     knee[3] = { s * (0.08 - 0.05 * up), seat + 0.06 + 0.05 * up, 0.21 },
                     ankle[3] = { s * (0.07 - 0.16 * up), 0.05 + 0.12 * up, 0.23 + 0.06 * up };
        add_leg(c, hip, knee, ankle);
    }
    if (kit_odds(b, 0.5)) scan_egg(c, 0, seat * 0.5, 0, 0.17, seat * 0.5 + 0.005, 0.15, 0.005); /* a boulder */
    else {
        scan_block(c, 0, 0.5 * seat, -0.02, 0.15, 0.5 * seat, 0.13, 0.01, 0);
        scan_block(c, 0, seat, -0.15, 0.15, seat * 0.9, 0.02, 0.01, 0.01);
    }
    add_trunk(b, c, seat + 0.07, kit_between(b, 0.85, 1.1), 1);
}

/* antique: no arms below the shoulders, legs or head where they broke off */
void kit_torso(kit_build *b, kit_clay *c)
{
    scan_limb(c, 0.055, 0.3, 0, 0.064, 0.06, 0.12, 0.02, 0.05, 0.03);
    scan_limb(c, -0.055, 0.3, 0, 0.064, -0.06, kit_between(b, 0.05, 0.22), 0.03, 0.05, 0.03);
    add_trunk(b, c, 0.33, kit_between(b, 0.85, 1.15), 0);
    if (kit_odds(b, 0.6)) scan_limb(c, 0.12, 0.6, 0, 0.037, 0.17, 0.5, 0.02, 0.03, 0.02);
    if (kit_odds(b, 0.7)) scan_block(c, 0, 0.85, 0, 0.2, 0.15, 0.2, 0, 0.01)->carved = 1;
    scan_limb(c, 0, 0.3, 0, 0.016, 0, 0.03, 0, 0.016, 0); /* on a rod */
    scan_block(c, 0, 0.02, 0, 0.12, 0.02, 0.1, 0.004, 0);
    c->rough = 0.006;
    c->grain = 0.08;
    c->octaves = 3;
}

void kit_bust(kit_build *b, kit_clay *c)
{
    add_head(b, c, 0, 0.74, 0.02, 0.5);
    scan_limb(c, 0, 0.62, -0.03, 0.1, 0, 0.4, -0.02, 0.11, 0.06);
    scan_limb(c, -0.2, 0.33, -0.02, 0.09, 0.2, 0.33, -0.02, 0.09, 0.12);
    scan_egg(c, 0, 0.28, 0.02, 0.25, 0.16, 0.14, 0.08);
    scan_block(c, 0, 0.0, 0, 0.5, 0.14, 0.4, 0, 0.02)->carved = 1;
    scan_limb(c, 0, 0.16, 0, 0.06, 0, 0.05, 0, 0.09, 0.02);
    scan_block(c, 0, 0.03, 0, 0.13, 0.03, 0.13, 0.008, 0);
    if (kit_odds(b, 0.5)) { /* cloth about the shoulders */
        c->relief = folds;
        c->of[0] = 0.42;
        c->of[1] = 0.03;
        c->of[2] = floor(kit_between(b, 6, 11));
    }
}

void kit_skull(kit_build *b, kit_clay *c)
{
    const double open = kit_between(b, 0, 0.1);
    scan_egg(c, 0, 0.62, -0.1, 0.34, 0.37, 0.44, 0.05);
    scan_egg(c, 0, 0.42, 0.16, 0.25, 0.24, 0.2, 0.12);
    scan_limb(c, -0.2, 0.42, 0.2, 0.06, 0.2, 0.42, 0.2, 0.06, 0.06);
    scan_egg(c, 0.13, 0.52, 0.33, 0.095, 0.085, 0.14, 0.03);
    c->blob[c->blobs - 1].carved = 1;
    scan_egg(c, -0.13, 0.52, 0.33, 0.095, 0.085, 0.14, 0.03)->carved = 1;
    scan_egg(c, 0, 0.38, 0.38, 0.05, 0.08, 0.1, 0.03)->carved = 1;
    scan_egg(c, 0.3, 0.4, 0.0, 0.08, 0.12, 0.14, 0.05);
    c->blob[c->blobs - 1].carved = 1;
    scan_mirror(c, 1);
    for (int s = -1; s <= 1; s += 2) {
        scan_limb(c, s * 0.27, 0.42, -0.02, 0.025, s * 0.22, 0.44, 0.24, 0.035, 0.03); /* cheekbone */
        scan_limb(c, s * 0.24, 0.34 - open, -0.02, 0.04, s * 0.2, 0.12 - open, 0.02, 0.04, 0.02);
        scan_limb(c, s * 0.2, 0.12 - open, 0.02, 0.04, 0, 0.08 - open, 0.3, 0.05, 0.03);
        for (int i = 0; i < 5; i++) {
            const double x = s * (0.02 + 0.038 * i), z = 0.34 - 0.01 * i * i;
            scan_limb(c, x, 0.25, z, 0.022, x, 0.19, z, 0.019, 0.005);
            scan_limb(c, x, 0.16 - open, z - 0.02, 0.019, x, 0.12 - open, z - 0.03, 0.02, 0.01);
        }
    }
    for (int k = 0; k < c->blobs; k++) { /* down to the ground */
        c->blob[k].a[1] += open;
        if (c->blob[k].kind == KIT_LIMB) c->blob[k].b[1] += open;
    }
}

void kit_mask(kit_build *b, kit_clay *c)
{
    add_head(b, c, 0, 0.5, 0, 1);
    scan_cut_plane(c, 0, 0, -1, kit_between(b, -0.14, 0.02), kit_odds(b, 0.5) ? 0.04 : 0);
    scan_cut_plane(c, 0, -1, 0, -0.04, 0);
    if (kit_odds(b, 0.6)) {
        scan_cut_ball(c, 0.14, 0.48, 0.36, 0.07, 0);
        scan_cut_ball(c, -0.14, 0.48, 0.36, 0.07, 0);
        scan_cut_ball(c, 0, 0.2, 0.36, 0.07, 0.01);
    }
}

/* ---- >>animals ------------------------------------------------------------------------------------------------- */

/* A leg on both sides at z, from height y: so thick, its joint bent back or forth. */
static void add_legs(kit_clay *c, double x, double y, double z, double thick, double bend, double stride)
{
    for (int s = -1; s <= 1; s += 2) {
        const double foot = z + s * stride;
        scan_limb(c, s * x, y, z, 1.5 * thick, s * x * 1.1, 0.52 * y, z + bend + 0.5 * s * stride, 0.85 * thick, 0.04);
        scan_limb(c, s * x * 1.1, 0.52 * y, z + bend + 0.5 * s * stride, 0.85 * thick, s * x * 1.1, 0.05, foot,
                  0.6 * thick, 0.02);
        scan_limb(c, s * x * 1.1, 0.03, foot, 0.7 * thick, s * x * 1.1, 0.025, foot + thick, 0.55 * thick, 0.02);
    }
}

/* a curve of limbs that bend by so much a piece about x, then about y */
static void add_curve(kit_clay *c, double at[3], double rise, double turn, const double bend[2], double length,
                      int pieces, double r0, double r1)
{
    for (int k = 0; k < pieces; k++) {
        const double from = r0 + (r1 - r0) * k / pieces, to = r0 + (r1 - r0) * (k + 1) / pieces;
        const double x = at[0], y = at[1], z = at[2], step = length / pieces;
        at[0] += step * cos(rise) * sin(turn);
        at[1] += step * sin(rise);
        at[2] += step * cos(rise) * cos(turn);
        at[1] = fmax(at[1], to);
        scan_limb(c, x, y, z, from, at[0], at[1], at[2], to, 0.4 * from);
        rise += bend[0];
        turn += bend[1];
    }
}

static void add_muzzle(kit_build *b, kit_clay *c, const double at[3], double s, int horned)
{
    const double x = at[0], y = at[1], z = at[2], ear = kit_between(b, 0.6, 1.8);
    scan_egg(c, x, y, z, 0.8 * s, 0.85 * s, s, 0.3 * s);
    scan_limb(c, x, y - 0.1 * s, z + 0.5 * s, 0.6 * s, x, y - 0.4 * s, z + 1.7 * s, 0.34 * s, 0.4 * s);
    scan_limb(c, x, y - 0.55 * s, z + 0.3 * s, 0.3 * s, x, y - 0.9 * s, z + 1.4 * s, 0.2 * s, 0.2 * s); /* jaw */
    for (int k = -1; k <= 1; k += 2) {
        scan_egg(c, x + k * 0.6 * s, y + 0.25 * s, z + 0.65 * s, 0.2 * s, 0.2 * s, 0.22 * s, 0.03 * s);
        scan_limb(c, x + k * 0.5 * s, y + 0.6 * s, z - 0.2 * s, 0.24 * s, x + k * 0.8 * s, y + (0.7 + 0.6 * ear) * s,
                  z - 0.5 * s, 0.1 * s, 0.1 * s);
        if (!horned) continue;
        double tip[3] = { x + k * 0.4 * s, y + 0.6 * s, z };
        const double bend[2] = { -0.3, k * 0.25 };
        add_curve(c, tip, 1.5, k * 2.4, bend, 2.2 * s, 7, 0.26 * s, 0.05 * s);
    }
}

/* cat, dog, horse, cow: by how high, how thick, how long in the neck */
void kit_beast(kit_build *b, kit_clay *c)
{
    const double tall = kit_between(b, 0.32, 0.55), fat = kit_between(b, 0.09, 0.16), neck = kit_between(b, 0.1, 0.34),
                 thick = kit_between(b, 0.025, 0.05), stride = kit_between(b, -0.08, 0.08);
    const double nod[2] = { -0.12, kit_between(b, -0.12, 0.12) },
                 wag[2] = { kit_between(b, -0.2, 0.25), kit_between(b, -0.3, 0.3) };
    double tail[3] = { 0, tall + 0.06, -0.34 }, throat[3] = { 0, tall + 0.06, 0.28 };
    scan_limb(c, 0, tall, -0.24, fat, 0, tall + kit_between(b, -0.04, 0.03), 0, fat * 0.95, 0.08);
    scan_limb(c, 0, tall, 0, fat, 0, tall + 0.03, 0.24, fat * 0.95, 0.08);
    add_legs(c, fat * 0.7, tall, -0.26, thick, -0.05, stride);
    add_legs(c, fat * 0.65, tall, 0.25, thick, 0.02, -stride);
    add_curve(c, throat, 0.9, 0, nod, neck, 4, fat * 0.75, fat * 0.5);
    add_curve(c, tail, kit_between(b, -1, 0.8), KIT_PI, wag, kit_between(b, 0.1, 0.45), 7, 0.035, 0.012);
    add_muzzle(b, c, throat, fat * 0.62, kit_odds(b, 0.35));
    if (kit_odds(b, 0.3)) {
        c->rough = 0.012;
        c->grain = 0.05;
        c->octaves = 2;
    } /* shaggy */
}

/* ribs fan out from the shoulder; the skin between is thin */
static void add_wing(kit_build *b, kit_clay *c, double spread)
{
    const double root[3] = { 0.06, 0.47, 0.08 }, lift = kit_between(b, 0.3, 0.6);
    double last[3] = { 0 };
    for (int k = 0; k < 5; k++) {
        const double a = 0.2 + 0.42 * k, far = spread * (1 - 0.07 * k);
        const double tip[3] = { root[0] + far * cos(lift) * sin(1.3 - 0.16 * k),
                                root[1] + far * sin(lift) * cos(0.3 * k), root[2] - far * sin(a) * 0.7 };
        scan_limb(c, root[0], root[1], root[2], 0.02, tip[0], tip[1], tip[2], 0.008, 0.01);
        scan_mirror(c, 1);
        for (int i = 1; i < 9 && k; i++) {
            const double t = 0.1 * i, sag = 0.03 * sin(t * 3);
            scan_limb(c, root[0] + t * (last[0] - root[0]), root[1] + t * (last[1] - root[1]),
                      root[2] + t * (last[2] - root[2]), 0.01, root[0] + t * (tip[0] - root[0]),
                      root[1] + t * (tip[1] - root[1]) - sag * 0.3, root[2] + t * (tip[2] - root[2]), 0.01, 0.035);
            scan_mirror(c, 1);
        }
        memcpy(last, tip, sizeof last);
    }
}

void kit_dragon(kit_build *b, kit_clay *c)
{
    const double side = kit_odds(b, 0.5) ? 1 : -1, coil[2] = { 0.03, side * kit_between(b, 0.2, 0.42) },
                 rear[2] = { -0.2, side * 0.1 };
    double tail[3] = { 0, 0.33, -0.2 }, neck[3] = { 0, 0.42, 0.18 };
    scan_limb(c, 0, 0.35, -0.2, 0.1, 0, 0.38, 0.05, 0.12, 0.08);
    scan_limb(c, 0, 0.38, 0.05, 0.12, 0, 0.42, 0.2, 0.09, 0.08);
    add_legs(c, 0.09, 0.34, -0.18, 0.036, -0.05, 0.04);
    add_legs(c, 0.09, 0.36, 0.18, 0.034, 0.04, -0.05);
    add_curve(c, tail, -0.5, KIT_PI, coil, 0.9, 14, 0.085, 0.012);
    add_curve(c, neck, 1.15, 0, rear, 0.42, 7, 0.075, 0.05);
    add_muzzle(b, c, neck, 0.062, 1);
    for (int k = c->blobs - 1, step = 0; k >= 0; k--) /* spikes along the back */
        if (c->blob[k].kind == KIT_LIMB && fabs(c->blob[k].a[0]) < 0.25 && c->blob[k].ra > 0.035
            && c->blob[k].a[1] > 0.1 && c->blobs < KIT_BLOBS - 90 && step++ < 24) {
            const kit_blob *at = &c->blob[k];
            scan_limb(c, at->a[0], at->a[1] + at->ra, at->a[2], 0.018, at->a[0], at->a[1] + at->ra + 0.05,
                      at->a[2] - 0.03, 0.003, 0.01);
        }
    if (kit_odds(b, 0.75)) add_wing(b, c, kit_between(b, 0.4, 0.65));
    c->rough = 0.004;
    c->grain = 0.02;
    c->octaves = 1;
}

void kit_bird(kit_build *b, kit_clay *c)
{
    const double up = kit_between(b, 0.4, 1.1), length = kit_between(b, 0.1, 0.4);
    const double bend[2] = { 0.1, 0 }, nod[2] = { -0.3, 0 };
    double neck[3] = { 0, 0.62, 0.14 }, tail[3] = { 0, 0.45, -0.15 };
    scan_egg(c, 0, 0.5, 0, 0.14, 0.18, 0.2, 0.05);
    add_curve(c, neck, 1.5, 0, nod, length, 6, 0.1, 0.05);
    scan_egg(c, neck[0], neck[1], neck[2], 0.075, 0.075, 0.085, 0.04);
    scan_limb(c, 0, neck[1], neck[2] + 0.06, 0.03, 0, neck[1] - 0.03, neck[2] + 0.19, 0.004, 0.01);
    add_curve(c, tail, -0.4, KIT_PI, bend, 0.35, 4, 0.07, 0.03);
    for (int k = 0; k < 7; k++) /* feathers */
        for (int s = -1; s <= 1; s += 2)
            scan_limb(c, s * 0.13, 0.6 - 0.03 * k, 0.08 - 0.03 * k, 0.03, s * (0.15 + 0.05 * up * (7 - k) * up),
                      0.42 + 0.1 * up * (7 - k) * up - 0.02 * k, -0.22 - 0.012 * k, 0.014, 0.012);
    for (int s = -1; s <= 1; s += 2) {
        scan_limb(c, s * 0.05, 0.36, 0, 0.03, s * 0.06, 0.05, 0.03, 0.014, 0.02);
        for (int t = -1; t <= 1; t++)
            scan_limb(c, s * 0.06, 0.04, 0.03, 0.013, s * 0.06 + 0.04 * t, 0.015, 0.1, 0.008, 0.01);
    }
    scan_block(c, 0, 0.004, 0.02, 0.14, 0.008, 0.14, 0.002, 0);
}

/* out of its wrist, the fingers more or less bent */
void kit_hand(kit_build *b, kit_clay *c)
{
    const double spread = kit_between(b, 0.02, 0.14);
    scan_limb(c, 0, 0.0, 0, 0.12, 0, 0.3, 0, 0.105, 0.05);
    scan_egg(c, 0, 0.42, 0, 0.17, 0.17, 0.085, 0.08);
    for (int f = 0; f < 5; f++) {
        static const double from[5][2] = { { 0.14, 0.36 },
                                           { 0.12, 0.56 },
                                           { 0.045, 0.59 },
                                           { -0.035, 0.58 },
                                           { -0.11, 0.53 } },
                            length[5] = { 0.11, 0.145, 0.165, 0.15, 0.115 };
        double x = from[f][0], y = from[f][1], z = 0, curl = f ? 0.1 : 0.3;
        const double bend = kit_between(b, 0.05, 0.75), out = f ? spread * (2.3 - f) : 0.9;
        for (int k = 0; k < 3; k++, curl += bend) {
            const double l = length[f] * (1 - 0.2 * k), r = 0.044 - 0.005 * k;
            const double x1 = x + l * sin(out) * cos(curl), y1 = y + l * cos(out) * cos(curl), z1 = z + l * sin(curl);
            scan_limb(c, x, y, z, r, x1, y1, z1, r - 0.006, 0.02);
            x = x1;
            y = y1;
            z = z1;
        }
    }
    scan_block(c, 0, -0.2, 0, 0.3, 0.2, 0.3, 0, 0.005)->carved = 1;
}
