/* palms.c - trees of scenes by seed that are not broad-leaved: conifers, palms, bamboo, and any far off. Declared in
   foliage.h. */
#include "kit/scene/foliage/foliage.h"
#include <math.h>
#include <string.h>

/* ---- >>conifers ------------------------------------------------------------------------------------------------ */

/* A branch of a needle tree: a twig with sprigs to both sides, or cards. */
static void needle_branch(kit_build *b, const double from[3], double way[3], double length, const float green[3],
                          int detail)
{
    enum { POINTS = 5, SPRIGS = 9 };

    static const double up[3] = { 0, 1, 0 };
    double at[POINTS][3], across[3], along[3];
    kit_cross(up, way, across);
    kit_unit(across);
    garden_shade(b, green, 0.25);
    if (detail < 2) {
        const kit_foil card = { KIT_RAGGED, length, 0.34 * length, 0.7, detail ? 0.5 : 0 };
        garden_grow_leaf(b, &card, from, way, across);
        return;
    }
    garden_wander(b, from, way, length, 0.3, 0.5, at, POINTS);
    for (int k = 0; k < SPRIGS; k++) {
        const double f = 0.15 + 0.85 * k / SPRIGS, part = f * (POINTS - 1);
        const int n = (int)fmin(part, POINTS - 2);
        double start[3], out[3];
        for (int i = 0; i < 3; i++) start[i] = at[n][i] + (part - n) * (at[n + 1][i] - at[n][i]);
        for (int side = -1; side < 2; side += 2) {
            const kit_foil sprig = { KIT_DIAMOND, length * (0.5 - 0.36 * f), 0.11 * length, 0.5, 0 };
            for (int i = 0; i < 3; i++) along[i] = 0.8 * way[i] + side * across[i];
            along[1] += kit_between(b, -0.25, 0.15);
            kit_unit(along);
            kit_cross(up, along, out);
            kit_unit(out);
            garden_shade(b, green, 0.25);
            garden_grow_leaf(b, &sprig, start, along, out);
        }
    }
    kit_colour(b, 0.2, 0.14, 0.1);
    garden_grow_limb(b, &(kit_limb){ (const double(*)[3])at, POINTS, 0.012 * length + 0.006, 0.002, 0, 0, 3, 0 });
}

void garden_grow_conifer(kit_build *b, double height, int detail)
{
    static const float needles[][3] = { { 0.08f, 0.17f, 0.09f }, { 0.12f, 0.22f, 0.10f }, { 0.16f, 0.24f, 0.20f } };
    const double slim = kit_between(b, 0.17, 0.34), clear = kit_between(b, 0.04, 0.3), dip = kit_between(b, -0.5, 0.2);
    const double trunk[4][3] = { { 0, -0.1, 0 }, { 0, 0.3 * height, 0 }, { 0, 0.7 * height, 0 }, { 0, height, 0 } };
    const int whorls = (int)(detail > 1 ? 13 : 9), round = detail > 1 ? 6 : 7;
    float green[3];
    KIT_TINT(b, needles, 0.15);
    memcpy(green, b->albedo, sizeof green);
    kit_colour(b, 0.25, 0.17, 0.12);
    garden_grow_limb(b, &(kit_limb){ trunk, 4, 0.022 * height, 0.002, 0.012 * height, 0.2, detail ? 10 : 6, 0 });
    for (int k = 0; k < whorls * round; k++) {
        const double f = (k + kit_between(b, -1, 1)) / (whorls * round),
                     y = height * (clear + (0.97 - clear) * fmax(0, f)), a = 2.39996 * k, tilt = dip + 0.7 * f;
        const double from[3] = { 0, y, 0 };
        double way[3] = { cos(tilt) * cos(a), sin(tilt), cos(tilt) * sin(a) };
        needle_branch(b, from, way, height * slim * (1.04 - f) * kit_between(b, 0.8, 1.15) + 0.1, green, detail);
    }
}

/* ---- >>palms, bamboo ------------------------------------------------------------------------------------------ */

/* A frond: a rib that bends down, leaflets to both sides. */
static void grow_frond(kit_build *b, const double from[3], double way[3], double length, const float green[3],
                       int detail)
{
    enum { POINTS = 9 };

    static const double up[3] = { 0, 1, 0 };
    const int pairs = detail > 1 ? 18 : 10;
    double at[POINTS][3], across[3];
    kit_cross(up, way, across);
    kit_unit(across);
    garden_wander(b, from, way, length, 0.2, 1.7, at, POINTS);
    garden_shade(b, green, 0.2);
    for (int k = 0; k < 2 * pairs; k++) {
        const double f = 0.18 + 0.8 * (k / 2) / pairs, part = f * (POINTS - 1), side = k & 1 ? 1 : -1;
        const int n = (int)part;
        const kit_foil leaflet = { KIT_BLADE, length * 0.34 * sin(KIT_PI * (0.15 + 0.8 * f)), 0.018 * length + 0.008,
                                   0.7, 0 };
        double start[3], out[3], flat[3];
        for (int i = 0; i < 3; i++) {
            const double step = at[n + 1][i] - at[n][i];
            start[i] = at[n][i] + (part - n) * step;
            flat[i] = step;
            out[i] = side * across[i] + 0.75 * step / (length / (POINTS - 1));
        }
        out[1] += kit_between(b, 0.05, 0.3);
        kit_unit(out);
        kit_unit(flat);
        garden_grow_leaf(b, &leaflet, start, out, flat);
    }
    garden_grow_limb(b, &(kit_limb){ (const double(*)[3])at, POINTS, 0.009 * length, 0.002, 0, 0, detail + 2, 0 });
}

void garden_grow_palm(kit_build *b, double height, int detail)
{
    enum { POINTS = 16 };

    static const double foot[3] = { 0, -0.1, 0 };
    const int fronds = 12 + kit_choose(b, 9);
    const float green[3] = { (float)kit_between(b, 0.18, 0.3), (float)kit_between(b, 0.28, 0.36), 0.1f };
    const double lean = kit_between(b, 0, 0.5), to = kit_between(b, 0, 2 * KIT_PI), length = kit_between(b, 1.5, 2.6);
    double at[POINTS][3], way[3] = { lean * cos(to), 1, lean * sin(to) };
    garden_wander(b, foot, way, height, 0.25, -lean, at, POINTS);
    kit_colour(b, 0.36, 0.30, 0.24);
    garden_grow_limb(b, &(kit_limb){ (const double(*)[3])at, POINTS, 0.13, 0.09, 0.09, 0, detail ? 10 : 6, 0 });
    for (int k = 0; k + 1 < POINTS && detail > 1; k++) { /* where old fronds have been */
        const double collar[2][3] = { { at[k][0], at[k][1], at[k][2] },
                                      { at[k][0] + 0.3 * (at[k + 1][0] - at[k][0]),
                                        at[k][1] + 0.3 * (at[k + 1][1] - at[k][1]),
                                        at[k][2] + 0.3 * (at[k + 1][2] - at[k][2]) } };
        garden_grow_limb(b, &(kit_limb){ collar, 2, 0.13 - 0.002 * k, 0.16 - 0.002 * k, 0, 0, 10, 0 });
    }
    for (int k = 0; k < fronds; k++) {
        const double a = 2.39996 * k, tilt = kit_between(b, -0.3, 1.2);
        double out[3] = { cos(tilt) * cos(a), sin(tilt), cos(tilt) * sin(a) };
        grow_frond(b, at[POINTS - 1], out, length * kit_between(b, 0.8, 1.1), green, detail);
    }
}

void garden_grow_bamboo(kit_build *b, double height, int leaves)
{
    enum { POINTS = 14 };

    static const double foot[3] = { 0, -0.05, 0 };
    static const float canes[][3] = { { 0.30f, 0.38f, 0.12f }, { 0.42f, 0.42f, 0.16f }, { 0.20f, 0.30f, 0.12f } };
    const kit_foil leaf = { KIT_POINTED, 0.26, 0.035, 0.6, 0 };
    const double radius = height * kit_between(b, 0.006, 0.01), lean = kit_between(b, 0, 0.25),
                 to = kit_between(b, 0, 6.283);
    double at[POINTS][3], way[3] = { 0, 1, 0 };
    KIT_TINT(b, canes, 0.15);
    way[0] = 0.3 * lean * cos(to);
    way[2] = 0.3 * lean * sin(to);
    garden_wander(b, foot, way, height, 0.15, lean, at, POINTS);
    for (int k = 0; k + 1 < POINTS; k++) {
        const double thick = radius * (1 - 0.85 * k / POINTS);
        double joint[3][3], out[3], across[3];
        for (int i = 0; i < 3; i++) {
            joint[0][i] = at[k][i];
            joint[1][i] = at[k][i] + 0.06 * (at[k + 1][i] - at[k][i]);
            joint[2][i] = at[k + 1][i];
        }
        garden_grow_limb(b, &(kit_limb){ (const double(*)[3])joint, 3, thick, thick * 0.93, 0.25 * thick, 0, 8, 0 });
        for (int n = 0; n < leaves && k > 4; n++) {
            const double f = kit_chance(b),
                         spot[3] = { at[k][0] + f * (at[k + 1][0] - at[k][0]), at[k][1] + f * (at[k + 1][1] - at[k][1]),
                                     at[k][2] + f * (at[k + 1][2] - at[k][2]) };
            double twig[3][3];
            garden_lean(way, kit_between(b, 0.5, 1.2), kit_between(b, 0, 2 * KIT_PI), out, across);
            garden_wander(b, spot, out, kit_between(b, 0.2, 0.7), 0.3, 0.5, twig, 3);
            garden_grow_limb(b, &(kit_limb){ (const double(*)[3])twig, 3, 0.006, 0.002, 0, 0, 3, 0 });
            garden_grow_cluster(b, &leaf, twig[2], out, 1.1, 5);
            garden_grow_cluster(b, &leaf, twig[1], out, 1.2, 2);
        }
    }
}

/* ---- >>far off ------------------------------------------------------------------------------------------------- */

void garden_grow_far_tree(kit_build *b, double height, int pointed, int solid)
{
    static const double up[3] = { 0, 1, 0 };
    const double trunk[2][3] = { { 0, -1, 0 }, { 0, 0.6 * height, 0 } };
    float green[3];
    memcpy(green, b->albedo, sizeof green);
    kit_colour(b, 0.22, 0.17, 0.13);
    garden_grow_limb(b, &(kit_limb){ trunk, 2, 0.03 * height, 0.01 * height, 0, 0, 5, 0 });
    garden_shade(b, green, 0.2);
    if (solid) {
        const kit_lump lump = { { height * (pointed ? 0.17 : 0.3), height * 0.38, height * (pointed ? 0.17 : 0.3) },
                                (unsigned)kit_choose(b, 1000),
                                0.3,
                                1.7,
                                2 };
        kit_place_at(b, 0, 0.6 * height, 0, 0);
        kit_patch(b, 12, 8, garden_lump_surface, &lump);
        kit_place_at(b, 0, 0, 0, 0);
    }
    for (int k = 0; k < 26 && !solid; k++) { /* cards about the trunk */
        const double up_there = kit_chance(b), a = 2.39996 * k,
                     wide = height * (pointed ? 0.2 * (1.05 - up_there) : 0.27 * sqrt(1.05 - up_there * up_there)),
                     r = wide * sqrt(kit_chance(b)),
                     from[3] = { r * cos(a), height * (0.22 + 0.68 * up_there), r * sin(a) };
        const kit_foil card = { KIT_RAGGED, 0.16 * height, 0.14 * height, 0.5, 0 };
        double out[3], across[3];
        garden_lean(up, kit_between(b, 0.3, 1.6), a, out, across);
        garden_shade(b, green, 0.22);
        garden_grow_cards(b, &card, from, out, 1 + k % 2);
    }
    memcpy(b->albedo, green, sizeof green);
}
