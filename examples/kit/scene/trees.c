/* trees.c - trees of scenes by seed: limbs that branch, leaves that are sheets without thickness. Declared in
   kit_plants.h. */
#include "kit/kit_plants.h"
#include <math.h>
#include <string.h>

/* ---- >>leaves -------------------------------------------------------------------------------------------------- */

enum { STATIONS = 7 };
/* half widths along a leaf */
static const struct outline { int cells; double wide[STATIONS]; } outlines[] = {
    [KIT_CARD]    = { 1, { 1, 1 } },
    [KIT_RAGGED]  = { 3, { 0.45, 1, 0.85, 0.3 } },
    [KIT_DIAMOND] = { 2, { 0, 1, 0 } },
    [KIT_POINTED] = { 3, { 0, 1, 0.75, 0 } },
    [KIT_BLADE]   = { 3, { 1, 0.9, 0.6, 0 } },
    [KIT_BROAD]   = { 6, { 0.08, 0.75, 1, 1, 0.85, 0.55, 0 } },
    [KIT_NEEDLE]  = { 1, { 1, 0 } },
    [KIT_ROUND]   = { 4, { 0.3, 0.9, 1, 0.8, 0.2 } }
};

typedef struct blade { const kit_foil *l; const double *at, *along, *across; double up[3]; } blade;

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

void kit_grow_leaf(kit_build *b, const kit_foil *l, const double at[3], const double along[3], const double across[3])
{
    blade s = { l, at, along, across, { 0 } };
    kit_cross(along, across, s.up);
    kit_patch(b, l->fold > 0 ? 2 : 1, outlines[l->outline].cells, blade_surface, &s);
}

void kit_lean(const double way[3], double angle, double spin, double out[3], double across[3])
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

void kit_shade(kit_build *b, const float base[3], double vary)
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

void kit_grow_cluster(kit_build *b, const kit_foil *l, const double at[3], const double along[3], double spread, int count)
{
    const double first = kit_between(b, 0, 2 * KIT_PI);
    for (int k = 0; k < count; k++) {
        const kit_foil one = varied(b, l);
        double out[3], across[3];
        kit_lean(along, spread * kit_between(b, 0.5, 1), first + 2.39996 * k, out, across);
        kit_grow_leaf(b, &one, at, out, across);
    }
}

void kit_grow_cards(kit_build *b, const kit_foil *l, const double at[3], const double along[3], int count)
{
    const double first = kit_between(b, 0, KIT_PI);
    const kit_foil one = varied(b, l);
    double out[3], across[3];
    for (int k = 0; k < count; k++) {
        kit_lean(along, 0, first + KIT_PI * k / count, out, across);
        kit_grow_leaf(b, &one, at, out, across);
    }
}

/* ---- >>limbs --------------------------------------------------------------------------------------------------- */

void kit_wander(kit_build *b, const double from[3], double way[3], double length, double gnarl, double droop,
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

typedef struct skin { const kit_limb *l; double side[3]; } skin;

static void limb_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const skin *s = shape;
    const kit_limb *l = s->l;
    const int last = l->count - 1, k = (int)(v * last + 0.5), from = k ? k - 1 : 0, to = k < last ? k + 1 : last;
    const double a = 2 * KIT_PI * fmod(u, 1), foot = pow(1 - v, 7) * l->flare * (1 + l->lobes * cos(5 * a)),
                 r = (1 - v) * l->r0 + v * l->r1 + foot;
    double way[3], side[3], up[3];
    for (int i = 0; i < 3; i++) way[i] = l->at[to][i] - l->at[from][i];
    kit_unit(way);
    const double along = kit_dot(s->side, way);
    for (int i = 0; i < 3; i++) side[i] = s->side[i] - along * way[i];
    kit_unit(side);
    kit_cross(way, side, up);
    for (int i = 0; i < 3; i++) {
        out->n[i] = cos(a) * side[i] + sin(a) * up[i];
        out->p[i] = l->at[k][i] + r * out->n[i];
    }
}

void kit_grow_limb(kit_build *b, const kit_limb *l)
{
    double way[3], out[3];
    skin s = { l, { 0 } };
    for (int i = 0; i < 3; i++) way[i] = l->at[l->count - 1][i] - l->at[0][i];
    if (!kit_unit(way)) return;
    kit_lean(way, 0, 0, out, s.side);
    kit_patch(b, l->around, l->count - 1, limb_surface, &s);
}

/* ---- >>broad-leaved trees -------------------------------------------------------------------------------------- */

static const float barks[][3] = { { 0.24f, 0.18f, 0.13f }, { 0.30f, 0.26f, 0.21f }, { 0.20f, 0.16f, 0.12f } };
static const float greens[][3] = { { 0.16f, 0.30f, 0.07f }, { 0.22f, 0.36f, 0.09f }, { 0.12f, 0.24f, 0.08f },
                                   { 0.28f, 0.36f, 0.12f } };
static const float springs[][3] = { { 0.36f, 0.50f, 0.14f }, { 0.42f, 0.52f, 0.20f }, { 0.30f, 0.46f, 0.10f } };
static const float autumns[][3] = { { 0.62f, 0.36f, 0.07f }, { 0.55f, 0.20f, 0.06f }, { 0.68f, 0.52f, 0.12f },
                                    { 0.40f, 0.30f, 0.08f } };
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

kit_tree kit_draw_tree(kit_build *b, int species, int season)
{
    static const float white_bark[3] = { 0.72f, 0.70f, 0.66f }, grey_bark[3] = { 0.36f, 0.33f, 0.30f };
    static const kit_tree trees[KIT_SPECIES] = {
        /*             height girth clear reach angle droop gnarl taper lobes branches twigs leaves foil */
        [KIT_OAK]    = { 8,  0.28, 0.25, 0.42, 1.00, -0.2, 1.1, 0.55, 0.2, 13, 8, 13, { KIT_POINTED, 0.26, 0.16, 0.5, 0 }, { 0 }, { 0 } },
        [KIT_POPLAR] = { 11, 0.20, 0.10, 0.20, 0.45, -0.5, 0.4, 0.55, 0.1, 22, 5, 11, { KIT_DIAMOND, 0.24, 0.19, 0.2, 0 }, { 0 }, { 0 } },
        [KIT_BIRCH]  = { 9,  0.13, 0.30, 0.26, 0.75, 0.7, 0.5, 0.65, 0.1, 17, 7, 11, { KIT_DIAMOND, 0.18, 0.13, 0.2, 0 }, { 0 }, { 0 } },
        [KIT_WILLOW] = { 7,  0.30, 0.30, 0.46, 0.90, 1.3, 0.7, 0.30, 0.3, 13, 9, 16, { KIT_POINTED, 0.27, 0.05, 0.4, 0 }, { 0 }, { 0 } },
        [KIT_APPLE]  = { 4,  0.13, 0.28, 0.48, 1.05, -0.4, 1.4, 0.40, 0.2, 10, 7, 15, { KIT_POINTED, 0.16, 0.10, 0.6, 0 }, { 0 }, { 0 } },
        [KIT_ACACIA] = { 7,  0.20, 0.62, 0.65, 0.95, 0.6, 0.8, 0.20, 0.2, 12, 9, 12, { KIT_DIAMOND, 0.22, 0.10, 0.3, 0 }, { 0 }, { 0 } },
        [KIT_GIANT]  = { 18, 0.60, 0.45, 0.32, 1.10, 0.2, 0.7, 0.35, 0.6, 13, 8, 13, { KIT_POINTED, 0.50, 0.22, 0.7, 0 }, { 0 }, { 0 } },
        [KIT_BARE]   = { 8,  0.24, 0.22, 0.42, 0.90, -0.3, 1.6, 0.50, 0.3, 13, 9, 0, { KIT_NEEDLE, 0.1, 0.1, 0, 0 }, { 0 }, { 0 } }
    };
    kit_tree t = trees[species];
    t.height *= kit_between(b, 0.75, 1.3);
    t.girth *= kit_between(b, 0.8, 1.3) ;
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
        kit_lean(way, kit_between(b, 0.5, 1.3), 2.39996 * k + kit_between(b, -0.5, 0.5), out, across);
        kit_shade(b, t->green, 0.22);
        kit_grow_leaf(b, &one, from, out, across);
    }
}

/* Cards of leaves instead: so long. */
static void card_twig(kit_build *b, const kit_tree *t, const double at[3], const double way[3], double length, int cards)
{
    const kit_foil card = { KIT_RAGGED, length, 0.75 * length, 0.4 + fmax(0, t->droop), 0 };
    if (!t->leaves) return;
    kit_shade(b, t->green, 0.22);
    kit_grow_cards(b, &card, at, way, cards);
}

/* A branch from there, so long and thick, with its twigs. */
static void grow_branch(kit_build *b, const kit_tree *t, const double from[3], double way[3], double length,
                        double radius, int detail)
{
    enum { POINTS = 6, TWIG = 4 };
    double at[POINTS][3], twig[TWIG][3];
    kit_wander(b, from, way, length, t->gnarl, t->droop, at, POINTS);
    kit_colour(b, (double)t->bark[0], (double)t->bark[1], (double)t->bark[2]);
    kit_grow_limb(b, &(kit_limb){ (const double (*)[3])at, POINTS, radius, 0.25 * radius, 0, 0, detail > 1 ? 6 : 4 });
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
        kit_lean(along, kit_between(b, 0.4, 1.1), kit_between(b, 0, 2 * KIT_PI), out, across);
        if (detail < 2) {
            if (k % (detail ? 1 : 2) == 0) card_twig(b, t, start, out, size * (detail ? 1.3 : 2), detail ? 2 : 2);
            continue;
        }
        kit_wander(b, start, out, size * (t->droop > 1 ? 2.2 : 1), t->gnarl, t->droop > 1 ? 4 : t->droop, twig, TWIG);
        kit_colour(b, (double)t->bark[0], (double)t->bark[1], (double)t->bark[2]);
        kit_grow_limb(b, &(kit_limb){ (const double (*)[3])twig, TWIG, 0.3 * radius, 0.05 * radius, 0, 0, 3 });
        leaf_twig(b, t, (const double (*)[3])twig, TWIG, t->leaves);
    }
}

void kit_grow_tree(kit_build *b, const kit_tree *t, int detail)
{
    enum { POINTS = 10 };
    const double foot[3] = { 0, -0.15, 0 };
    double at[POINTS][3], way[3] = { kit_between(b, -0.1, 0.1), 1, kit_between(b, -0.1, 0.1) };
    const double spin = kit_between(b, 0, 2 * KIT_PI), trunk = t->height * 0.85;
    kit_wander(b, foot, way, trunk, 0.45 * t->gnarl, -0.6, at, POINTS);
    kit_colour(b, (double)t->bark[0], (double)t->bark[1], (double)t->bark[2]);
    kit_grow_limb(b, &(kit_limb){ (const double (*)[3])at, POINTS, t->girth, 0.15 * t->girth, 0.8 * t->girth, t->lobes,
                                  detail > 1 ? 12 : detail ? 8 : 5 });
    for (int k = 0; k < t->branches; k++) {
        const double up = (k + kit_chance(b)) / t->branches, f = t->clear + (1 - t->clear) * up, part = f * (POINTS - 1);
        const int n = (int)fmin(part, POINTS - 2);
        const double length = t->height * t->reach * (1 - t->taper * up) * kit_between(b, 0.75, 1.15);
        double from[3], along[3], out[3], across[3];
        for (int i = 0; i < 3; i++) {
            along[i] = at[n + 1][i] - at[n][i];
            from[i] = at[n][i] + (part - n) * along[i];
        }
        kit_unit(along);
        kit_lean(along, t->angle * (1 - 0.45 * up) * kit_between(b, 0.8, 1.2), spin + 2.39996 * k, out, across);
        grow_branch(b, t, from, out, length, t->girth * (1 - 0.85 * f) * 0.55, detail);
    }
    grow_branch(b, t, at[POINTS - 1], way, 0.2 * t->height, 0.15 * t->girth, detail);
}

/* ---- >>others -------------------------------------------------------------------------------------------------- */

/* A branch of a needle tree: a twig with sprigs to both sides, or cards. */
static void needle_branch(kit_build *b, const double from[3], double way[3], double length, const float green[3], int detail)
{
    enum { POINTS = 5, SPRIGS = 9 };
    static const double up[3] = { 0, 1, 0 };
    double at[POINTS][3], across[3], along[3];
    kit_cross(up, way, across);
    kit_unit(across);
    kit_shade(b, green, 0.25);
    if (detail < 2) {
        const kit_foil card = { KIT_RAGGED, length, 0.55 * length, 0.7, detail ? 0.5 : 0 };
        kit_grow_leaf(b, &card, from, way, across);
        return;
    }
    kit_wander(b, from, way, length, 0.3, 0.5, at, POINTS);
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
            kit_shade(b, green, 0.25);
            kit_grow_leaf(b, &sprig, start, along, out);
        }
    }
    kit_colour(b, 0.2, 0.14, 0.1);
    kit_grow_limb(b, &(kit_limb){ (const double (*)[3])at, POINTS, 0.012 * length + 0.006, 0.002, 0, 0, 3 });
}

void kit_grow_conifer(kit_build *b, double height, int detail)
{
    static const float needles[][3] = { { 0.08f, 0.17f, 0.09f }, { 0.12f, 0.22f, 0.10f }, { 0.16f, 0.24f, 0.20f } };
    const double slim = kit_between(b, 0.17, 0.34), clear = kit_between(b, 0.04, 0.3), dip = kit_between(b, -0.5, 0.2);
    const double trunk[4][3] = { { 0, -0.1, 0 }, { 0, 0.3 * height, 0 }, { 0, 0.7 * height, 0 }, { 0, height, 0 } };
    const int whorls = (int)(detail > 1 ? 13 : 9), round = detail > 1 ? 6 : 5;
    float green[3];
    KIT_TINT(b, needles, 0.15);
    memcpy(green, b->albedo, sizeof green);
    kit_colour(b, 0.25, 0.17, 0.12);
    kit_grow_limb(b, &(kit_limb){ trunk, 4, 0.022 * height, 0.002, 0.012 * height, 0.2, detail ? 10 : 6 });
    for (int k = 0; k < whorls * round; k++) {
        const double f = (k + kit_between(b, -1, 1)) / (whorls * round), y = height * (clear + (0.97 - clear) * fmax(0, f)),
                     a = 2.39996 * k, tilt = dip + 0.7 * f;
        const double from[3] = { 0, y, 0 };
        double way[3] = { cos(tilt) * cos(a), sin(tilt), cos(tilt) * sin(a) };
        needle_branch(b, from, way, height * slim * (1.04 - f) * kit_between(b, 0.8, 1.15) + 0.1, green, detail);
    }
}

/* A frond: a rib that bends down, leaflets to both sides. */
static void grow_frond(kit_build *b, const double from[3], double way[3], double length, const float green[3], int detail)
{
    enum { POINTS = 9 };
    static const double up[3] = { 0, 1, 0 };
    const int pairs = detail > 1 ? 18 : 10;
    double at[POINTS][3], across[3];
    kit_cross(up, way, across);
    kit_unit(across);
    kit_wander(b, from, way, length, 0.2, 1.7, at, POINTS);
    kit_shade(b, green, 0.2);
    for (int k = 0; k < 2 * pairs; k++) {
        const double f = 0.18 + 0.8 * (k / 2) / pairs, part = f * (POINTS - 1), side = k & 1 ? 1 : -1;
        const int n = (int)part;
        const kit_foil leaflet = { KIT_BLADE, length * 0.34 * sin(KIT_PI * (0.15 + 0.8 * f)), 0.018 * length + 0.008, 0.7, 0 };
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
        kit_grow_leaf(b, &leaflet, start, out, flat);
    }
    kit_grow_limb(b, &(kit_limb){ (const double (*)[3])at, POINTS, 0.009 * length, 0.002, 0, 0, detail > 1 ? 4 : 3 });
}

void kit_grow_palm(kit_build *b, double height, int detail)
{
    enum { POINTS = 16 };
    static const double foot[3] = { 0, -0.1, 0 };
    const int fronds = 12 + kit_choose(b, 9);
    const float green[3] = { (float)kit_between(b, 0.18, 0.3), (float)kit_between(b, 0.28, 0.36), 0.1f };
    const double lean = kit_between(b, 0, 0.5), to = kit_between(b, 0, 2 * KIT_PI), length = kit_between(b, 1.5, 2.6);
    double at[POINTS][3], way[3] = { lean * cos(to), 1, lean * sin(to) };
    kit_wander(b, foot, way, height, 0.25, -lean, at, POINTS);
    kit_colour(b, 0.36, 0.30, 0.24);
    kit_grow_limb(b, &(kit_limb){ (const double (*)[3])at, POINTS, 0.13, 0.09, 0.09, 0, detail ? 10 : 6 });
    for (int k = 0; k + 1 < POINTS && detail > 1; k++) {                  /* where old fronds have been */
        const double collar[2][3] = { { at[k][0], at[k][1], at[k][2] },
                                      { at[k][0] + 0.3 * (at[k + 1][0] - at[k][0]), at[k][1] + 0.3 * (at[k + 1][1] - at[k][1]),
                                        at[k][2] + 0.3 * (at[k + 1][2] - at[k][2]) } };
        kit_grow_limb(b, &(kit_limb){ collar, 2, 0.13 - 0.002 * k, 0.16 - 0.002 * k, 0, 0, 10 });
    }
    for (int k = 0; k < fronds; k++) {
        const double a = 2.39996 * k, tilt = kit_between(b, -0.3, 1.2);
        double out[3] = { cos(tilt) * cos(a), sin(tilt), cos(tilt) * sin(a) };
        grow_frond(b, at[POINTS - 1], out, length * kit_between(b, 0.8, 1.1), green, detail);
    }
}

void kit_grow_bamboo(kit_build *b, double height, int leaves)
{
    enum { POINTS = 14 };
    static const double foot[3] = { 0, -0.05, 0 };
    static const float canes[][3] = { { 0.30f, 0.38f, 0.12f }, { 0.42f, 0.42f, 0.16f }, { 0.20f, 0.30f, 0.12f } };
    const kit_foil leaf = { KIT_POINTED, 0.26, 0.035, 0.6, 0 };
    const double radius = height * kit_between(b, 0.006, 0.01), lean = kit_between(b, 0, 0.25), to = kit_between(b, 0, 6.283);
    double at[POINTS][3], way[3] = { 0, 1, 0 };
    KIT_TINT(b, canes, 0.15);
    way[0] = 0.3 * lean * cos(to); way[2] = 0.3 * lean * sin(to);
    kit_wander(b, foot, way, height, 0.15, lean, at, POINTS);
    for (int k = 0; k + 1 < POINTS; k++) {
        const double thick = radius * (1 - 0.85 * k / POINTS);
        double joint[3][3], out[3], across[3];
        for (int i = 0; i < 3; i++) {
            joint[0][i] = at[k][i];
            joint[1][i] = at[k][i] + 0.06 * (at[k + 1][i] - at[k][i]);
            joint[2][i] = at[k + 1][i];
        }
        kit_grow_limb(b, &(kit_limb){ (const double (*)[3])joint, 3, thick, thick * 0.93, 0.25 * thick, 0, 8 });
        for (int n = 0; n < leaves && k > 4; n++) {
            const double f = kit_chance(b), spot[3] = { at[k][0] + f * (at[k + 1][0] - at[k][0]), at[k][1] + f * (at[k + 1][1] - at[k][1]),
                                                        at[k][2] + f * (at[k + 1][2] - at[k][2]) };
            double twig[3][3];
            kit_lean(way, kit_between(b, 0.5, 1.2), kit_between(b, 0, 2 * KIT_PI), out, across);
            kit_wander(b, spot, out, kit_between(b, 0.2, 0.7), 0.3, 0.5, twig, 3);
            kit_grow_limb(b, &(kit_limb){ (const double (*)[3])twig, 3, 0.006, 0.002, 0, 0, 3 });
            kit_grow_cluster(b, &leaf, twig[2], out, 1.1, 5);
            kit_grow_cluster(b, &leaf, twig[1], out, 1.2, 2);
        }
    }
}

/* a ball with lumps: half[3], seed */
static void lump_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, unit = 1;
    kit_sphere_surface(&unit, u, v, out);
    const double k = 1 + 0.3 * kit_fractal((unsigned)s[3], 1.7 * out->n[0], 1.7 * out->n[1], 1.7 * out->n[2], 2);
    for (int i = 0; i < 3; i++) out->p[i] = s[i] * k * out->n[i];
}

void kit_grow_far_tree(kit_build *b, double height, int pointed, int solid)
{
    static const double up[3] = { 0, 1, 0 };
    const double trunk[2][3] = { { 0, -1, 0 }, { 0, 0.6 * height, 0 } };
    float green[3];
    memcpy(green, b->albedo, sizeof green);
    kit_colour(b, 0.22, 0.17, 0.13);
    kit_grow_limb(b, &(kit_limb){ trunk, 2, 0.03 * height, 0.01 * height, 0, 0, 5 });
    kit_shade(b, green, 0.2);
    if (solid) {
        const double lump[4] = { height * (pointed ? 0.17 : 0.3), height * 0.38, height * (pointed ? 0.17 : 0.3),
                                 kit_choose(b, 1000) };
        kit_place_at(b, 0, 0.6 * height, 0, 0);
        kit_patch(b, 12, 8, lump_surface, lump);
        kit_place_at(b, 0, 0, 0, 0);
    } else for (int k = 0; k < 4; k++) {
        const double f = k / 4.0, from[3] = { 0, height * (0.2 + 0.7 * f), 0 };
        const kit_foil card = { pointed ? KIT_DIAMOND : KIT_RAGGED, 0.4 * height, height * (pointed ? 0.5 - 0.35 * f : 0.6 - 0.1 * f), 0.1, 0 };
        kit_shade(b, green, 0.2);
        kit_grow_cards(b, &card, from, up, 2);
    }
    memcpy(b->albedo, green, sizeof green);
}
