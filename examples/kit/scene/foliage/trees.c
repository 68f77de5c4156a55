/* trees.c - trees of scenes by seed: limbs that branch, leaves that are sheets without thickness. Declared in
   foliage.h. */
#include "kit/scene/foliage/foliage.h"
#include <math.h>
#include <string.h>

/* ---- >>leaves -------------------------------------------------------------------------------------------------- */

enum { STATIONS = 7 };

/* half widths along a leaf */
static const struct outline {
    int cells;
    double wide[STATIONS];
} outlines[] = { [KIT_CARD] = { 1, { 1, 1 } },        [KIT_RAGGED] = { 3, { 0.45, 1, 0.85, 0.3 } },
                 [KIT_DIAMOND] = { 2, { 0, 1, 0 } },  [KIT_POINTED] = { 3, { 0, 1, 0.75, 0 } },
                 [KIT_BLADE] = { 2, { 1, 0.75, 0 } }, [KIT_BROAD] = { 6, { 0.08, 0.75, 1, 1, 0.85, 0.55, 0 } },
                 [KIT_NEEDLE] = { 1, { 1, 0 } },      [KIT_ROUND] = { 4, { 0.3, 0.9, 1, 0.8, 0.2 } } };

typedef struct blade {
    const kit_foil *l;
    const double *at, *along, *across;
    double up[3];
} blade;

static void blade_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const blade *s = shape;
    const struct outline *o = &outlines[s->l->outline];
    const double bend = s->l->bend + 1e-4, a = bend * v, wide = o->wide[(int)(v * o->cells + 0.5)] * s->l->width;
    const double x = wide * (u - 0.5), z = s->l->length * sin(a) / bend, y = s->l->length * (cos(a) - 1) / bend,
                 rise = s->l->fold * fabs(x);
    for (int i = 0; i < 3; i++) {
        out->n[i] = s->up[i] * cos(a) + s->along[i] * sin(a);
        out->p[i] = s->at[i] + x * s->across[i] + z * s->along[i] + y * s->up[i] + rise * out->n[i];
        out->n[i] -= (u > 0.5 ? 1 : u < 0.5 ? -1 : 0) * s->l->fold * s->across[i];
    }
    kit_unit(out->n);
}

void garden_grow_leaf(kit_build *b, const kit_foil *l, const double at[3], const double along[3],
                      const double across[3])
{
    blade s = { l, at, along, across, { 0 } };
    kit_cross(along, across, s.up);
    kit_patch(b, l->fold > 0 ? 2 : 1, outlines[l->outline].cells, blade_surface, &s);
}

void garden_lean(const double way[3], double angle, double spin, double out[3], double across[3])
{
    const double up[3] = { fabs(way[1]) < 0.9 ? 0 : 1, fabs(way[1]) < 0.9 ? 1 : 0, 0 };
    double side[3], front[3], aside[3];
    kit_cross(up, way, side);
    kit_unit(side);
    kit_cross(way, side, front);
    for (int i = 0; i < 3; i++) {
        aside[i] = cos(spin) * side[i] + sin(spin) * front[i];
        out[i] = cos(angle) * way[i] + sin(angle) * aside[i];
    }
    kit_unit(out);
    kit_cross(aside, way, across);
    kit_unit(across);
}

void garden_shade(kit_build *b, const float base[3], double vary)
{
    const double by = 1 + kit_between(b, -vary, vary), warm = 1 + 0.3 * kit_between(b, -vary, vary);
    kit_colour(b, (double)base[0] * by * warm, (double)base[1] * by, (double)base[2] * by);
}

/* the same leaf, a little longer or shorter */
static kit_foil varied(kit_build *b, const kit_foil *l)
{
    const double by = kit_between(b, 0.7, 1.25);
    return (kit_foil){ l->outline, l->length * by, l->width * by, l->bend * kit_between(b, 0.5, 1.3), l->fold };
}

void garden_grow_cluster(kit_build *b, const kit_foil *l, const double at[3], const double along[3], double spread,
                         int count)
{
    const double first = kit_between(b, 0, 2 * KIT_PI);
    for (int k = 0; k < count; k++) {
        const kit_foil one = varied(b, l);
        double out[3], across[3];
        garden_lean(along, spread * kit_between(b, 0.5, 1), first + 2.39996 * k, out, across);
        garden_grow_leaf(b, &one, at, out, across);
    }
}

void garden_grow_cards(kit_build *b, const kit_foil *l, const double at[3], const double along[3], int count)
{
    const double first = kit_between(b, 0, KIT_PI);
    const kit_foil one = varied(b, l);
    double out[3], across[3];
    for (int k = 0; k < count; k++) {
        garden_lean(along, 0, first + KIT_PI * k / count, out, across);
        garden_grow_leaf(b, &one, at, out, across);
    }
}

/* ---- >>limbs --------------------------------------------------------------------------------------------------- */

void garden_wander(kit_build *b, const double from[3], double way[3], double length, double gnarl, double droop,
                   double at[][3], int count)
{
    memcpy(at[0], from, sizeof at[0]);
    for (int k = 1; k < count; k++) {
        for (int i = 0; i < 3; i++) way[i] += gnarl * kit_between(b, -1, 1) / count;
        way[1] -= droop / count;
        if (!kit_unit(way)) way[1] = -1;
        for (int i = 0; i < 3; i++) at[k][i] = at[k - 1][i] + way[i] * length / (count - 1);
    }
}

typedef struct skin {
    const kit_limb *l;
    double side[3];
} skin;

static double limb_radius(const kit_limb *l, double a, double v)
{
    const double foot = pow(1 - v, 7) * l->flare * (1 + l->lobes * cos(5 * a)), r = (1 - v) * l->r0 + v * l->r1 + foot;
    if (!(l->rough > 0)) return r;
    return r * (1 + l->rough * kit_noise(9, 4 * cos(a), 0.9 * v * (l->count - 1) + 3 * sin(a), 2));
}

static void limb_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const skin *s = shape;
    const kit_limb *l = s->l;
    const int last = l->count - 1, k = (int)(v * last + 0.5), from = k ? k - 1 : 0, to = k < last ? k + 1 : last;
    const double a = 2 * KIT_PI * fmod(u, 1), e = 0.02, low = fmax(0, v - e), high = fmin(1, v + e),
                 r = limb_radius(l, a, v);
    double way[3], side[3], up[3];
    for (int i = 0; i < 3; i++) way[i] = l->at[to][i] - l->at[from][i];
    const double length = sqrt(kit_dot(way, way)) * last / (to - from);
    kit_unit(way);
    const double slope = length > 0 ? (limb_radius(l, a, high) - limb_radius(l, a, low)) / ((high - low) * length) : 0,
                 around = (limb_radius(l, a + e, v) - limb_radius(l, a - e, v)) / (2 * e * fmax(r, 1e-6));
    const double along = kit_dot(s->side, way);
    for (int i = 0; i < 3; i++) side[i] = s->side[i] - along * way[i];
    kit_unit(side);
    kit_cross(way, side, up);
    for (int i = 0; i < 3; i++) {
        out->n[i] = cos(a) * side[i] + sin(a) * up[i];
        out->p[i] = l->at[k][i] + r * out->n[i];
        out->n[i] -= slope * way[i] + around * (cos(a) * up[i] - sin(a) * side[i]);
    }
    kit_unit(out->n);
}

void garden_grow_limb(kit_build *b, const kit_limb *l)
{
    double way[3], out[3];
    skin s = { l, { 0 } };
    for (int i = 0; i < 3; i++) way[i] = l->at[l->count - 1][i] - l->at[0][i];
    if (!kit_unit(way)) return;
    garden_lean(way, 0, 0, out, s.side);
    kit_patch(b, l->around, l->count - 1, limb_surface, &s);
}

/* ---- >>broad-leaved trees -------------------------------------------------------------------------------------- */

static const float barks[][3] = { { 0.24f, 0.18f, 0.13f }, { 0.30f, 0.26f, 0.21f }, { 0.20f, 0.16f, 0.12f } };
static const float greens[][3] = {
    { 0.16f, 0.30f, 0.07f }, { 0.22f, 0.36f, 0.09f }, { 0.12f, 0.24f, 0.08f }, { 0.28f, 0.36f, 0.12f }
};
static const float springs[][3] = { { 0.36f, 0.50f, 0.14f }, { 0.42f, 0.52f, 0.20f }, { 0.30f, 0.46f, 0.10f } };
static const float autumns[][3] = {
    { 0.62f, 0.36f, 0.07f }, { 0.55f, 0.20f, 0.06f }, { 0.68f, 0.52f, 0.12f }, { 0.40f, 0.30f, 0.08f }
};
static const float blossoms[][3] = { { 0.82f, 0.58f, 0.64f }, { 0.85f, 0.80f, 0.78f }, { 0.80f, 0.45f, 0.55f } };

static void draw_colours(kit_build *b, kit_tree *t, int season)
{
    KIT_TINT(b, barks, 0.15);
    memcpy(t->bark, b->albedo, sizeof t->bark);
    if (season == KIT_SUMMER) KIT_TINT(b, greens, 0.15);
    if (season == KIT_SPRING) KIT_TINT(b, springs, 0.12);
    if (season == KIT_AUTUMN) KIT_TINT(b, autumns, 0.15);
    if (season == KIT_BLOSSOM) KIT_TINT(b, blossoms, 0.06);
    memcpy(t->green, b->albedo, sizeof t->green);
}

kit_tree garden_draw_tree(kit_build *b, int species, int season)
{
    static const float white_bark[3] = { 0.72f, 0.70f, 0.66f }, grey_bark[3] = { 0.36f, 0.33f, 0.30f };
    /* clang-format off */
    static const kit_tree trees[KIT_SPECIES] = {
        /*             height girth clear reach angle droop gnarl taper lobes branches twigs leaves foil */
        [KIT_OAK]    = { 8,  0.28, 0.25, 0.42, 1.00, -0.2, 1.1, 0.55, 0.2, 13, 8, 13,
                         { KIT_POINTED, 0.26, 0.16, 0.5, 0 }, { 0 }, { 0 } },
        [KIT_POPLAR] = { 11, 0.20, 0.10, 0.20, 0.45, -0.5, 0.4, 0.55, 0.1, 22, 5, 11,
                         { KIT_DIAMOND, 0.24, 0.19, 0.2, 0 }, { 0 }, { 0 } },
        [KIT_BIRCH]  = { 9,  0.13, 0.30, 0.26, 0.75, 0.7, 0.5, 0.65, 0.1, 17, 7, 11,
                         { KIT_DIAMOND, 0.18, 0.13, 0.2, 0 }, { 0 }, { 0 } },
        [KIT_WILLOW] = { 7,  0.30, 0.30, 0.46, 0.90, 1.3, 0.7, 0.30, 0.3, 13, 9, 16,
                         { KIT_POINTED, 0.27, 0.05, 0.4, 0 }, { 0 }, { 0 } },
        [KIT_APPLE]  = { 4,  0.13, 0.28, 0.48, 1.05, -0.4, 1.4, 0.40, 0.2, 10, 7, 15,
                         { KIT_POINTED, 0.16, 0.10, 0.6, 0 }, { 0 }, { 0 } },
        [KIT_ACACIA] = { 7,  0.20, 0.62, 0.65, 0.95, 0.6, 0.8, 0.20, 0.2, 12, 9, 12,
                         { KIT_DIAMOND, 0.22, 0.10, 0.3, 0 }, { 0 }, { 0 } },
        [KIT_GIANT]  = { 18, 0.60, 0.45, 0.32, 1.10, 0.2, 0.7, 0.35, 0.6, 13, 8, 13,
                         { KIT_POINTED, 0.50, 0.22, 0.7, 0 }, { 0 }, { 0 } },
        [KIT_BARE]   = { 8,  0.24, 0.22, 0.42, 0.90, -0.3, 1.6, 0.50, 0.3, 13, 9, 0,
                         { KIT_NEEDLE, 0.1, 0.1, 0, 0 }, { 0 }, { 0 } }
    };
    /* clang-format on */
    kit_tree t = trees[species];
    t.height *= kit_between(b, 0.75, 1.3);
    t.girth *= kit_between(b, 0.8, 1.3);
    t.clear *= kit_between(b, 0.75, 1.25);
    t.reach *= kit_between(b, 0.85, 1.2);
    t.angle *= kit_between(b, 0.85, 1.15);
    t.gnarl *= kit_between(b, 0.6, 1.5);
    t.foil.length *= kit_between(b, 0.85, 1.25);
    draw_colours(b, &t, season);
    if (species == KIT_BIRCH) memcpy(t.bark, white_bark, sizeof white_bark);
    if (species == KIT_BARE || species == KIT_GIANT) memcpy(t.bark, grey_bark, sizeof grey_bark);
    return t;
}

/* Leaves along a twig of which at are points. */
static void leaf_twig(kit_build *b, const kit_tree *t, const double at[][3], int count, int leaves)
{
    for (int k = 0; k < leaves; k++) {
        const double f = (k + 0.7) / leaves * (count - 1);
        const int n = (int)fmin(f, count - 2);
        const kit_foil one = varied(b, &t->foil);
        double way[3], from[3], out[3], across[3];
        for (int i = 0; i < 3; i++) {
            way[i] = at[n + 1][i] - at[n][i];
            from[i] = at[n][i] + (f - n) * way[i];
        }
        kit_unit(way);
        garden_lean(way, kit_between(b, 0.5, 1.3), 2.39996 * k + kit_between(b, -0.5, 0.5), out, across);
        garden_shade(b, t->green, 0.22);
        garden_grow_leaf(b, &one, from, out, across);
    }
}

/* Cards of leaves instead, along a twig that is so long. */
static void card_twig(kit_build *b, const kit_tree *t, const double at[3], const double way[3], double length,
                      int spots)
{
    const double size = spots > 1 ? 0.5 * length : 0.9 * length;
    const kit_foil card = { KIT_RAGGED, size, 0.7 * size, 0.4 + fmax(0, t->droop), 0 };
    for (int k = 0; k < spots && t->leaves; k++) {
        const double f = length * (k + kit_chance(b)) / spots, turn = kit_between(b, 0, 2 * KIT_PI),
                     from[3] = { at[0] + f * way[0], at[1] + f * way[1], at[2] + f * way[2] };
        double out[3], across[3];
        garden_lean(way, kit_between(b, 0.2, 1), turn, out, across);
        garden_shade(b, t->green, 0.22);
        garden_grow_cards(b, &card, from, out, 2);
    }
}

/* A branch from there, so long and thick, with its twigs. */
static void grow_branch(kit_build *b, const kit_tree *t, const double from[3], double way[3], double length,
                        double radius, int detail)
{
    enum { POINTS = 6, TWIG = 3 };

    double at[POINTS][3], twig[TWIG][3];
    garden_wander(b, from, way, length, t->gnarl, t->droop, at, POINTS);
    kit_colour(b, (double)t->bark[0], (double)t->bark[1], (double)t->bark[2]);
    const int around = detail > 1 ? 6 : 4;
    garden_grow_limb(b, &(kit_limb){ (const double(*)[3])at, POINTS, radius, 0.25 * radius, 0, 0, around, 0 });
    for (int k = 0; k < t->twigs; k++) {
        const double f = 0.25 + 0.75 * (k + kit_chance(b)) / t->twigs, part = f * (POINTS - 1);
        const int n = (int)fmin(part, POINTS - 2);
        const double size = length * kit_between(b, 0.3, 0.5) * (1.15 - 0.5 * f);
        double start[3], along[3], out[3], across[3];
        for (int i = 0; i < 3; i++) {
            along[i] = at[n + 1][i] - at[n][i];
            start[i] = at[n][i] + (part - n) * along[i];
        }
        kit_unit(along);
        garden_lean(along, kit_between(b, 0.4, 1.1), kit_between(b, 0, 2 * KIT_PI), out, across);
        if (detail < 2) {
            if (k % (detail ? 1 : 2) == 0) card_twig(b, t, start, out, size * (detail ? 1.2 : 1.6), detail ? 4 : 1);
            continue;
        }
        garden_wander(b, start, out, size * (t->droop > 1 ? 2.2 : 1), t->gnarl, t->droop > 1 ? 4 : t->droop, twig,
                      TWIG);
        kit_colour(b, (double)t->bark[0], (double)t->bark[1], (double)t->bark[2]);
        garden_grow_limb(b, &(kit_limb){ (const double(*)[3])twig, TWIG, 0.3 * radius, 0.05 * radius, 0, 0, 3, 0 });
        leaf_twig(b, t, (const double(*)[3])twig, TWIG, t->leaves);
    }
}

void garden_grow_tree(kit_build *b, const kit_tree *t, int detail)
{
    enum { POINTS = 15 };

    const double foot[3] = { 0, -0.15, 0 };
    double at[POINTS][3], way[3] = { kit_between(b, -0.1, 0.1), 1, kit_between(b, -0.1, 0.1) };
    const double spin = kit_between(b, 0, 2 * KIT_PI), trunk = t->height * 0.85;
    garden_wander(b, foot, way, trunk, 0.45 * t->gnarl, -0.6, at, POINTS);
    kit_colour(b, (double)t->bark[0], (double)t->bark[1], (double)t->bark[2]);
    garden_grow_limb(b,
                     &(kit_limb){ (const double(*)[3])at, POINTS, t->girth, 0.15 * t->girth, 0.8 * t->girth, t->lobes,
                                  detail > 1 ? 26
                                  : detail   ? 9
                                             : 5,
                                  detail > 1 ? 0.16 : 0 });
    for (int k = 0; k < t->branches; k++) {
        const double up = (k + kit_chance(b)) / t->branches, f = t->clear + (1 - t->clear) * up,
                     part = f * (POINTS - 1);
        const int n = (int)fmin(part, POINTS - 2);
        const double length = t->height * t->reach * (1 - t->taper * up) * kit_between(b, 0.75, 1.15);
        double from[3], along[3], out[3], across[3];
        for (int i = 0; i < 3; i++) {
            along[i] = at[n + 1][i] - at[n][i];
            from[i] = at[n][i] + (part - n) * along[i];
        }
        kit_unit(along);
        garden_lean(along, t->angle * (1 - 0.45 * up) * kit_between(b, 0.8, 1.2), spin + 2.39996 * k, out, across);
        grow_branch(b, t, from, out, length, t->girth * (1 - 0.85 * f) * 0.55, detail);
    }
    grow_branch(b, t, at[POINTS - 1], way, 0.2 * t->height, 0.15 * t->girth, detail);
}
