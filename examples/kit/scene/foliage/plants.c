/* plants.c - low plants of scenes by seed: ferns, flowers, reeds, ivy, what grows in pots. Declared in foliage.h. */
#include "kit/scene/foliage/foliage.h"
#include <math.h>
#include <string.h>

static const double upright[3] = { 0, 1, 0 };
static const float leaves_green[][3] = { { 0.15f, 0.28f, 0.07f }, { 0.22f, 0.34f, 0.10f }, { 0.10f, 0.20f, 0.07f },
                                         { 0.30f, 0.36f, 0.12f }, { 0.34f, 0.38f, 0.28f }, { 0.40f, 0.16f, 0.14f } };

static void take_colour(const kit_build *b, float out[3]) { memcpy(out, b->albedo, sizeof b->albedo); }

/* ---- >>out of one spot ----------------------------------------------------------------------------------------- */

void garden_grow_tuft(kit_build *b, const kit_foil *l, int count, double spread)
{
    float green[3];
    take_colour(b, green);
    for (int k = 0; k < count; k++) {
        const double r = 0.15 * l->length * kit_chance(b), a = kit_between(b, 0, 2 * KIT_PI),
                     at[3] = { r * cos(a), -0.01, r * sin(a) };
        const kit_foil one = { l->outline, l->length * kit_between(b, 0.5, 1.2), l->width,
                               l->bend * kit_between(b, 0.3, 1.4), l->fold };
        double out[3], across[3];
        garden_lean(upright, spread * kit_chance(b), a, out, across);
        for (int i = 0; i < 3; i++) across[i] = -across[i]; /* so that it bends outwards */
        garden_shade(b, green, 0.25);
        garden_grow_leaf(b, &one, at, out, across);
    }
    memcpy(b->albedo, green, sizeof green);
}

/* hosta, agave, iris, house plants */
void garden_grow_rosette(kit_build *b, double length, int kind)
{
    static const kit_foil kinds[] = { { KIT_BROAD, 1, 0.5, 1.5, 0.25 },
                                      { KIT_POINTED, 1, 0.16, -0.5, 0.6 },
                                      { KIT_BLADE, 1, 0.07, 0.8, 0.3 },
                                      { KIT_ROUND, 1, 0.7, 1.2, 0.1 } };
    kit_foil l = kinds[kind & 3];
    l.length *= length;
    l.width *= length;
    KIT_TINT(b, leaves_green, 0.2);
    garden_grow_tuft(b, &l, kind == 2 ? 26 : kind == 1 ? 22 : 14, kind == 2 ? 0.6 : 1.2);
}

void garden_grow_fern(kit_build *b, double length, int fronds)
{
    enum { POINTS = 7, PAIRS = 14 };

    const float green[3] = { (float)kit_between(b, 0.13, 0.26), (float)kit_between(b, 0.28, 0.38), 0.08f };
    for (int k = 0; k < fronds; k++) {
        const double from[3] = { 0, 0, 0 }, size = length * kit_between(b, 0.7, 1.15);
        double at[POINTS][3], way[3], across[3];
        garden_lean(upright, kit_between(b, 0.25, 0.8), 2.39996 * k, way, across);
        garden_wander(b, from, way, size, 0.15, 1.3, at, POINTS);
        garden_shade(b, green, 0.2);
        for (int n = 0; n < 2 * PAIRS; n++) {
            const double f = 0.12 + 0.87 * (n / 2) / PAIRS, part = f * (POINTS - 1), side = n & 1 ? 1 : -1;
            const int j = (int)part;
            const kit_foil leaflet = { KIT_DIAMOND, 0.26 * size * sin(KIT_PI * (0.2 + 0.77 * f)), 0.055 * size, 0.4,
                                       0 };
            double start[3], out[3], flat[3];
            for (int i = 0; i < 3; i++) {
                flat[i] = at[j + 1][i] - at[j][i];
                start[i] = at[j][i] + (part - j) * flat[i];
            }
            kit_unit(flat);
            for (int i = 0; i < 3; i++) out[i] = side * across[i] + 0.35 * flat[i];
            kit_unit(out);
            garden_grow_leaf(b, &leaflet, start, out, flat);
        }
        garden_grow_limb(b, &(kit_limb){ (const double(*)[3])at, POINTS, 0.008 * length, 0.002, 0, 0, 3, 0 });
    }
}

void garden_grow_banana(kit_build *b, double height)
{
    const double trunk[3][3] = { { 0, -0.05, 0 }, { 0.03, 0.25 * height, 0 }, { 0, 0.5 * height, 0.02 } };
    const float green[3] = { 0.24f, 0.36f, 0.1f };
    kit_colour(b, 0.34, 0.36, 0.18);
    garden_grow_limb(b, &(kit_limb){ trunk, 3, 0.035 * height, 0.02 * height, 0.02 * height, 0, 9, 0 });
    for (int k = 0; k < 9; k++) {
        const kit_foil leaf = { KIT_BROAD, height * kit_between(b, 0.5, 0.75), height * kit_between(b, 0.14, 0.2),
                                kit_between(b, 0.6, 1.9), 0.3 };
        double out[3], across[3];
        garden_lean(upright, kit_between(b, 0.1, 0.9), 2.39996 * k, out, across);
        for (int i = 0; i < 3; i++) across[i] = -across[i];
        garden_shade(b, green, 0.2);
        garden_grow_leaf(b, &leaf, trunk[2], out, across);
    }
}

/* ---- >>flowers ------------------------------------------------------------------------------------------------- */

static void blossom(kit_build *b, const double at[3], const double way[3], double size, int kind, const float colour[3])
{
    const kit_foil tulip = { KIT_POINTED, size, 0.6 * size, -0.5, 0.2 },
                   petal = { KIT_DIAMOND, size, 0.4 * size, 0.3, 0 },
                   bell = { KIT_ROUND, 0.6 * size, 0.5 * size, 0.8, 0 };
    double out[3], across[3];
    for (int k = 0; k < 6 && kind == 0; k++) { /* a cup */
        garden_lean(way, 0.35, KIT_PI / 3 * k, out, across);
        garden_shade(b, colour, 0.15);
        garden_grow_leaf(b, &tulip, at, out, across);
    }
    for (int k = 0; k < 13 && (kind == 1 || kind == 2); k++) { /* a disc with rays */
        garden_lean(way, kit_between(b, 1.2, 1.5), 2 * KIT_PI / 13 * k, out, across);
        garden_shade(b, colour, 0.12);
        garden_grow_leaf(b, &petal, at, out, across);
    }
    for (int k = 0; k < 14 && kind > 2; k++) { /* a spike, a ball */
        const double down = kind == 3 ? 0.35 * size * k : 0,
                     spot[3] = { at[0] - way[0] * down, at[1] - way[1] * down, at[2] - way[2] * down };
        garden_lean(way, kind == 3 ? 1.1 : kit_between(b, 0, 2), 2.39996 * k, out, across);
        garden_shade(b, colour, 0.2);
        garden_grow_leaf(b, &bell, spot, out, across);
    }
    if (kind != 1 && kind != 2) return;
    const double heart[3] = { 0.35 * size, 0.2 * size, 0.35 * size };
    kit_place_at(b, at[0], at[1], at[2], 0);
    if (kind == 1) kit_colour(b, 0.75, 0.55, 0.1);
    else kit_colour(b, 0.2, 0.12, 0.06);
    kit_cushion(b, heart, 1, 5);
    kit_place_at(b, 0, 0, 0, 0);
}

void garden_grow_flower(kit_build *b, double height, int kind, const float colour[3])
{
    enum { POINTS = 4 };

    static const double foot[3] = { 0, -0.02, 0 };
    const double size = kind == 2 ? 0.13 * height : fmin(0.09, 0.2 * height);
    const kit_foil leaf = { kind == 2 ? KIT_ROUND : KIT_POINTED, 0.4 * height,
                            kind == 2 ? 0.25 * height : 0.08 * height, 0.9, 0 };
    const float green[3] = { 0.2f, 0.33f, 0.1f };
    double at[POINTS][3], way[3] = { kit_between(b, -0.25, 0.25), 1, kit_between(b, -0.25, 0.25) };
    kit_unit(way);
    garden_wander(b, foot, way, height, 0.4, 0, at, POINTS);
    garden_shade(b, green, 0.2);
    garden_grow_limb(
        b, &(kit_limb){ (const double(*)[3])at, POINTS, 0.004 + 0.006 * height, 0.003 + 0.003 * height, 0, 0, 4, 0 });
    garden_grow_cluster(b, &leaf, at[kind == 2 ? 2 : 0], upright, 0.9, kind == 2 ? 5 : 3);
    if (kind == 2) garden_grow_cluster(b, &leaf, at[1], upright, 1.3, 4);
    if (kind == 2) {
        way[0] += 0.7;
        kit_unit(way);
    } /* it looks to one side, as the others do */
    blossom(b, at[POINTS - 1], way, size, kind, colour);
}

void garden_grow_reed(kit_build *b, double height)
{
    enum { POINTS = 5 };

    static const double foot[3] = { 0, -0.3, 0 };
    const kit_foil blade = { KIT_BLADE, 0.8 * height, 0.016, 0.6, 0.2 };
    double at[POINTS][3], way[3] = { kit_between(b, -0.15, 0.15), 1, kit_between(b, -0.15, 0.15) };
    kit_unit(way);
    garden_wander(b, foot, way, height + 0.3, 0.2, 0.1, at, POINTS);
    kit_colour(b, 0.38, 0.38, 0.16);
    garden_grow_limb(b, &(kit_limb){ (const double(*)[3])at, POINTS, 0.006, 0.003, 0, 0, 4, 0 });
    kit_colour(b, 0.26, 0.34, 0.12);
    garden_grow_tuft(b, &blade, 5, 0.35);
    if (!kit_odds(b, 0.6)) return;
    const double head[2][3] = { { at[3][0], at[3][1], at[3][2] },
                                { 0.3 * at[3][0] + 0.7 * at[4][0], 0.3 * at[3][1] + 0.7 * at[4][1],
                                  0.3 * at[3][2] + 0.7 * at[4][2] } };
    kit_colour(b, 0.24, 0.14, 0.08);
    kit_tube(b, head, 2, 0.018, 7);
}

void garden_grow_mushroom(kit_build *b, double height)
{
    static const float caps[][3] = {
        { 0.45f, 0.27f, 0.14f }, { 0.62f, 0.1f, 0.06f }, { 0.7f, 0.62f, 0.5f }, { 0.66f, 0.45f, 0.2f }
    };
    const double r = height * kit_between(b, 0.4, 0.7), stem = 0.16 * height, h = height * kit_between(b, 0.25, 0.5);
    const kit_moulding foot[] = { { 1.3 * stem, -0.02, stem, 0.4 * height, -0.02 * height },
                                  { stem, 0.4 * height, stem, height - 0.9 * h, 0 } };
    const kit_moulding cap[] = { { stem, height - 0.9 * h, r, height - h, 0 }, { r, height - h, 0, height, 0.3 * r } };
    kit_colour(b, 0.72, 0.68, 0.58);
    kit_turned(b, foot, 2, 9);
    KIT_TINT(b, caps, 0.15);
    kit_turned(b, cap, 2, 14);
}

/* ---- >>others -------------------------------------------------------------------------------------------------- */

typedef struct ribbed {
    double radius, height;
    int ribs;
} ribbed;

static void ribbed_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const ribbed *s = shape;
    const double a = 2 * KIT_PI * fmod(u, 1), wave = 1 + 0.16 * cos(s->ribs * a), t = fmin(1, v / 0.85),
                 end = v > 0.85 ? (v - 0.85) / 0.15 : 0, r = s->radius * wave * sqrt(fmax(0, 1 - end * end)),
                 slope = 0.16 * s->ribs * sin(s->ribs * a) / wave;
    out->p[0] = r * cos(a);
    out->p[2] = r * sin(a);
    out->p[1] = s->height * (0.9 * t + 0.1 * end);
    out->n[0] = (1 - end) * (cos(a) - slope * sin(a));
    out->n[1] = end + 0.01;
    out->n[2] = (1 - end) * (sin(a) + slope * cos(a));
    kit_unit(out->n);
}

void garden_grow_cactus(kit_build *b, double height)
{
    const ribbed trunk = { 0.09 * height + 0.03, height, 9 + kit_choose(b, 5) };
    const int arms = height > 0.8 ? kit_choose(b, 4) : 0;
    kit_colour(b, 0.2, kit_between(b, 0.28, 0.36), 0.16);
    kit_patch(b, 4 * trunk.ribs, 20, ribbed_surface, &trunk);
    for (int k = 0; k < arms; k++) {
        const double y = height * kit_between(b, 0.3, 0.55), a = 2.2 * k, r = trunk.radius, away = 0.2 * height + r,
                     top = y + height * kit_between(b, 0.2, 0.4);
        const double elbow[5][3] = { { 0.5 * r * cos(a), y, 0.5 * r * sin(a) },
                                     { 0.8 * away * cos(a), y + 0.02, 0.8 * away * sin(a) },
                                     { away * cos(a), y + 0.3 * r, away * sin(a) },
                                     { away * cos(a), y + 1.2 * r, away * sin(a) },
                                     { away * cos(a), top, away * sin(a) } };
        const double tip[3] = { 0.45 * r, 0.4 * r, 0.45 * r };
        kit_tube(b, elbow, 5, 0.45 * r, 14);
        kit_place_at(b, elbow[4][0], top, elbow[4][2], 0);
        kit_cushion(b, tip, 1, 8);
        kit_place_at(b, 0, 0, 0, 0);
    }
}

void garden_grow_ivy(kit_build *b, double x0, double x1, double height, double cover)
{
    enum { POINTS = 9 };

    const double area = (x1 - x0) * height, out_of_wall[3] = { 0, 0, 1 };
    const unsigned seed = (unsigned)kit_choose(b, 100000);
    const float green[3] = { (float)kit_between(b, 0.1, 0.3), (float)kit_between(b, 0.2, 0.3), 0.07f };
    kit_colour(b, 0.25, 0.19, 0.14);
    for (int k = 0; k < (int)(2 * (x1 - x0)) + 1; k++) {
        double at[POINTS][3] = { { kit_between(b, x0, x1), -0.05, 0.012 } };
        for (int n = 1; n < POINTS; n++) {
            at[n][0] = fmax(x0, fmin(x1, at[n - 1][0] + kit_between(b, -0.16, 0.16)));
            at[n][1] = n * height * 0.8 / (POINTS - 1);
            at[n][2] = 0.012;
        }
        kit_tube(b, (const double(*)[3])at, POINTS, 0.009, 4);
    }
    for (int k = 0; k < (int)fmin(7000, area * 420 * cover); k++) {
        const double x = kit_between(b, x0, x1), f = kit_chance(b), y = height * f, size = kit_between(b, 0.05, 0.11);
        const kit_foil leaf = { KIT_DIAMOND, size, 0.9 * size, 0.4, 0 };
        const double at[3] = { x, y, kit_between(b, 0.004, 0.07) };
        double down[3] = { kit_between(b, -0.6, 0.6), -1, kit_between(b, 0.2, 0.9) }, across[3];
        if (kit_fractal(seed, 0.9 * x, 0.9 * y, 0, 3) > 1.3 * cover - 0.7 * f) continue;
        kit_unit(down);
        kit_cross(down, out_of_wall, across);
        kit_unit(across);
        garden_shade(b, green, 0.3);
        garden_grow_leaf(b, &leaf, at, down, across);
    }
}
