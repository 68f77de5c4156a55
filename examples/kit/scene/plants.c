/* plants.c - lower plants of scenes by seed: bushes, hedges, ferns, flowers, reeds, ivy, what grows in pots. Declared in
   kit_plants.h. */
#include "kit/kit_plants.h"
#include <math.h>
#include <string.h>

static const double upright[3] = { 0, 1, 0 };
static const float leaves_green[][3] = { { 0.15f, 0.28f, 0.07f }, { 0.22f, 0.34f, 0.10f }, { 0.10f, 0.20f, 0.07f },
                                         { 0.30f, 0.36f, 0.12f }, { 0.34f, 0.38f, 0.28f }, { 0.40f, 0.16f, 0.14f } };

static void take_colour(const kit_build *b, float out[3]) { memcpy(out, b->albedo, sizeof b->albedo); }

/* ---- >>bushes -------------------------------------------------------------------------------------------------- */

/* a point on a lumpy ball in the direction, half[3] and seed in s */
static void on_lump(const double *s, const double way[3], double out[3])
{
    const double k = 1 + 0.22 * kit_fractal((unsigned)s[3], 1.6 * way[0], 1.6 * way[1], 1.6 * way[2], 2);
    for (int i = 0; i < 3; i++) out[i] = s[i] * k * way[i];
}

static void lump_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, unit = 1;
    kit_sphere_surface(&unit, u, v, out);
    on_lump(s, out->n, out->p);
}

static void random_way(kit_build *b, double lowest, double out[3])
{
    const double y = kit_between(b, lowest, 1), a = kit_between(b, 0, 2 * KIT_PI), r = sqrt(1 - y * y);
    out[0] = r * cos(a); out[1] = y; out[2] = r * sin(a);
}

/* Leaves over a lumpy ball about middle. */
static void leafy_lump(kit_build *b, const double s[4], double middle, const kit_foil *leaf, int count, int core)
{
    float green[3];
    take_colour(b, green);
    if (core) {
        const double inner[4] = { 0.93 * s[0], 0.93 * s[1], 0.93 * s[2], s[3] };
        kit_colour(b, 0.5 * (double)green[0], 0.5 * (double)green[1], 0.5 * (double)green[2]);
        kit_place_at(b, 0, middle, 0, 0);
        kit_patch(b, 20, 12, lump_surface, inner);
        kit_place_at(b, 0, 0, 0, 0);
    }
    for (int k = 0; k < count; k++) {
        double way[3], at[3], out[3], across[3];
        random_way(b, -0.75, way);
        on_lump(s, way, at);
        const double in = core ? 0.94 : kit_between(b, 0.6, 1);
        for (int i = 0; i < 3; i++) at[i] *= in;
        at[1] += middle;
        kit_lean(way, kit_between(b, 0.4, 1.3), kit_between(b, 0, 2 * KIT_PI), out, across);
        kit_shade(b, green, 0.25);
        kit_grow_leaf(b, leaf, at, out, across);
    }
}

/* Stems out of one spot, leaves along them. */
static void stemmed_bush(kit_build *b, double width, double height, const kit_foil *leaf)
{
    enum { POINTS = 6 };
    const int stems = 12 + kit_choose(b, 8);
    float green[3];
    take_colour(b, green);
    for (int k = 0; k < stems; k++) {
        const double from[3] = { 0, -0.03, 0 };
        double at[POINTS][3], way[3], across[3];
        kit_lean(upright, kit_between(b, 0.1, 0.8) * fmin(1, width / height), 2.39996 * k, way, across);
        kit_wander(b, from, way, height * kit_between(b, 0.7, 1.15), 0.7, kit_between(b, 0, 0.6), at, POINTS);
        kit_colour(b, 0.28, 0.20, 0.13);
        kit_grow_limb(b, &(kit_limb){ (const double (*)[3])at, POINTS, 0.012, 0.003, 0, 0, 4 });
        for (int n = 1; n < POINTS; n++) {
            kit_shade(b, green, 0.22);
            kit_grow_cluster(b, leaf, at[n], way, 1.2, 6);
        }
    }
}

void kit_grow_bush(kit_build *b, double width, double height, int kind)
{
    const double s[4] = { width / 2, height / 2, width / 2 * kit_between(b, 0.8, 1.2), kit_choose(b, 10000) };
    const double leaf = kit_between(b, 0.05, 0.11) * (0.6 + 0.4 * height);
    const kit_foil small = { kit_odds(b, 0.5) ? KIT_DIAMOND : KIT_POINTED, leaf, leaf * kit_between(b, 0.4, 0.75), 0.5, 0 };
    float green[3];
    KIT_TINT(b, leaves_green, 0.15);
    take_colour(b, green);
    if (kind == KIT_BUSH_CORE) leafy_lump(b, s, 0.46 * height, &small, 750, 1);
    if (kind == KIT_BUSH_TWIGS) stemmed_bush(b, width, height, &small);
    for (int k = 0; k < 12 && kind == KIT_BUSH_CARDS; k++) {
        const kit_foil card = { KIT_RAGGED, height * kit_between(b, 0.4, 0.6), height * 0.45, 0.4, 0 };
        double way[3], at[3];
        random_way(b, -0.1, way);
        on_lump(s, way, at);
        for (int i = 0; i < 3; i++) at[i] *= 0.5;
        at[1] += 0.35 * height;
        kit_shade(b, green, 0.25);
        kit_grow_cards(b, &card, at, way, 2);
    }
}

/* ---- >>clipped ------------------------------------------------------------------------------------------------- */

/* One face of a hedge: from corner along u and v, facing out. */
static void clipped_face(kit_build *b, const double corner[3], const double u[3], const double v[3], const double out[3],
                         const kit_foil *leaf, double density, int deep)
{
    const double area = sqrt(kit_dot(u, u) * kit_dot(v, v));
    float green[3];
    take_colour(b, green);
    for (int k = 0; k < (int)(area * density); k++) {
        const double s = kit_chance(b), t = kit_chance(b), in = deep ? kit_between(b, -0.25, 0.02) : kit_between(b, -0.05, 0.01);
        double at[3], way[3], across[3];
        for (int i = 0; i < 3; i++) at[i] = corner[i] + s * u[i] + t * v[i] + in * out[i];
        kit_lean(out, kit_between(b, 0.3, 1.3), kit_between(b, 0, 2 * KIT_PI), way, across);
        kit_shade(b, green, 0.25);
        kit_grow_leaf(b, leaf, at, way, across);
    }
    memcpy(b->albedo, green, sizeof green);
}

void kit_grow_hedge(kit_build *b, double x, double height, double z, double leaf, int core)
{
    const kit_foil l = { KIT_DIAMOND, leaf, 0.6 * leaf, 0.3, 0 };
    const double density = 0.75 / (leaf * leaf), hx = x / 2, hz = z / 2;
    const double corner[5][3] = { { -hx, 0, hz }, { -hx, 0, -hz }, { hx, 0, -hz }, { -hx, 0, -hz }, { -hx, height, -hz } };
    const double u[5][3] = { { x, 0, 0 }, { x, 0, 0 }, { 0, 0, z }, { 0, 0, z }, { x, 0, 0 } };
    const double v[5][3] = { { 0, height, 0 }, { 0, height, 0 }, { 0, height, 0 }, { 0, height, 0 }, { 0, 0, z } };
    static const double out[5][3] = { { 0, 0, 1 }, { 0, 0, -1 }, { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 } };
    float green[3];
    take_colour(b, green);
    if (core) {
        const double in = 0.03;
        kit_colour(b, 0.45 * (double)green[0], 0.45 * (double)green[1], 0.45 * (double)green[2]);
        kit_bevelled(b, -hx + in, -0.1, -hz + in, hx - in, height - in, hz - in, fmin(0.06, 0.2 * fmin(x, z)));
        memcpy(b->albedo, green, sizeof green);
    }
    for (int k = 0; k < 5; k++) clipped_face(b, corner[k], u[k], v[k], out[k], &l, density, !core);
}

/* Leaves on what is turned between two radii. */
static void clipped_cone(kit_build *b, double r0, double y0, double r1, double y1, double leaf)
{
    const kit_foil l = { KIT_DIAMOND, leaf, 0.6 * leaf, 0.3, 0 };
    const kit_moulding profile[] = { { 0, y0, r0, y0, 0 }, { r0, y0, r1, y1, 0 }, { r1, y1, 0, y1, 0 } };
    const int count = (int)(KIT_PI * (r0 + r1) * fabs(y1 - y0) / (leaf * leaf));
    float green[3];
    take_colour(b, green);
    kit_colour(b, 0.5 * (double)green[0], 0.5 * (double)green[1], 0.5 * (double)green[2]);
    kit_turned(b, profile, 3, 20);
    for (int k = 0; k < count; k++) {
        const double t = 1 - sqrt(kit_chance(b)), r = r0 + t * (r1 - r0) - 0.005, a = kit_between(b, 0, 2 * KIT_PI);
        const double way[3] = { cos(a), (r0 - r1) / fabs(y1 - y0), sin(a) }, at[3] = { r * cos(a), y0 + t * (y1 - y0), r * sin(a) };
        double unit[3] = { way[0], way[1], way[2] }, out[3], across[3];
        kit_unit(unit);
        kit_lean(unit, kit_between(b, 0.4, 1.3), kit_between(b, 0, 2 * KIT_PI), out, across);
        kit_shade(b, green, 0.25);
        kit_grow_leaf(b, &l, at, out, across);
    }
    memcpy(b->albedo, green, sizeof green);
}

void kit_grow_topiary(kit_build *b, double height, int kind)
{
    const double radius = height * kit_between(b, 0.24, 0.34), s[4] = { radius, radius, radius, 1 },
                 leaf = 0.035 + 0.02 * height;
    const kit_foil l = { KIT_DIAMOND, leaf, 0.6 * leaf, 0.3, 0 };
    const double trunk[2][3] = { { 0, -0.05, 0 }, { 0, height - radius, 0 } };
    float green[3];
    kit_colour(b, 0.12, 0.23, 0.08);
    kit_shade(b, b->albedo, 0.2);
    take_colour(b, green);
    if (kind == 1) { clipped_cone(b, radius, 0.05 * height, 0.03, height, leaf); return; }
    for (int k = 0; k < 3 && kind == 2; k++)
        clipped_cone(b, radius * (1 - 0.28 * k), height * (0.12 + 0.3 * k), radius * (0.7 - 0.25 * k), height * (0.34 + 0.3 * k), leaf);
    if (!kind) leafy_lump(b, s, height - radius, &l, 900, 1);
    kit_colour(b, 0.26, 0.2, 0.14);
    kit_grow_limb(b, &(kit_limb){ trunk, 2, 0.02 + 0.015 * height, 0.02 + 0.01 * height, 0, 0, 8 });
}

/* ---- >>out of one spot ----------------------------------------------------------------------------------------- */

void kit_grow_tuft(kit_build *b, const kit_foil *l, int count, double spread)
{
    float green[3];
    take_colour(b, green);
    for (int k = 0; k < count; k++) {
        const double r = 0.15 * l->length * kit_chance(b), a = kit_between(b, 0, 2 * KIT_PI), at[3] = { r * cos(a), -0.01, r * sin(a) };
        const kit_foil one = { l->outline, l->length * kit_between(b, 0.5, 1.2), l->width, l->bend * kit_between(b, 0.3, 1.4), l->fold };
        double out[3], across[3];
        kit_lean(upright, spread * kit_chance(b), a, out, across);
        for (int i = 0; i < 3; i++) across[i] = -across[i];                /* so that it bends outwards */
        kit_shade(b, green, 0.25);
        kit_grow_leaf(b, &one, at, out, across);
    }
    memcpy(b->albedo, green, sizeof green);
}

/* hosta, agave, iris, house plants */
void kit_grow_rosette(kit_build *b, double length, int kind)
{
    static const kit_foil kinds[] = { { KIT_BROAD, 1, 0.5, 1.5, 0.25 }, { KIT_POINTED, 1, 0.16, -0.5, 0.6 },
                                      { KIT_BLADE, 1, 0.07, 0.8, 0.3 }, { KIT_ROUND, 1, 0.7, 1.2, 0.1 } };
    kit_foil l = kinds[kind & 3];
    l.length *= length;
    l.width *= length;
    KIT_TINT(b, leaves_green, 0.2);
    kit_grow_tuft(b, &l, kind == 2 ? 26 : kind == 1 ? 22 : 14, kind == 2 ? 0.6 : 1.2);
}

void kit_grow_fern(kit_build *b, double length, int fronds)
{
    enum { POINTS = 7, PAIRS = 14 };
    const float green[3] = { (float)kit_between(b, 0.13, 0.26), (float)kit_between(b, 0.28, 0.38), 0.08f };
    for (int k = 0; k < fronds; k++) {
        const double from[3] = { 0, 0, 0 }, size = length * kit_between(b, 0.7, 1.15);
        double at[POINTS][3], way[3], across[3];
        kit_lean(upright, kit_between(b, 0.25, 0.8), 2.39996 * k, way, across);
        kit_wander(b, from, way, size, 0.15, 1.3, at, POINTS);
        kit_shade(b, green, 0.2);
        for (int n = 0; n < 2 * PAIRS; n++) {
            const double f = 0.12 + 0.87 * (n / 2) / PAIRS, part = f * (POINTS - 1), side = n & 1 ? 1 : -1;
            const int j = (int)part;
            const kit_foil leaflet = { KIT_DIAMOND, 0.26 * size * sin(KIT_PI * (0.2 + 0.77 * f)), 0.055 * size, 0.4, 0 };
            double start[3], out[3], flat[3];
            for (int i = 0; i < 3; i++) {
                flat[i] = at[j + 1][i] - at[j][i];
                start[i] = at[j][i] + (part - j) * flat[i];
            }
            kit_unit(flat);
            for (int i = 0; i < 3; i++) out[i] = side * across[i] + 0.35 * flat[i];
            kit_unit(out);
            kit_grow_leaf(b, &leaflet, start, out, flat);
        }
        kit_grow_limb(b, &(kit_limb){ (const double (*)[3])at, POINTS, 0.008 * length, 0.002, 0, 0, 3 });
    }
}

void kit_grow_banana(kit_build *b, double height)
{
    const double trunk[3][3] = { { 0, -0.05, 0 }, { 0.03, 0.25 * height, 0 }, { 0, 0.5 * height, 0.02 } };
    const float green[3] = { 0.24f, 0.36f, 0.1f };
    kit_colour(b, 0.34, 0.36, 0.18);
    kit_grow_limb(b, &(kit_limb){ trunk, 3, 0.035 * height, 0.02 * height, 0.02 * height, 0, 9 });
    for (int k = 0; k < 9; k++) {
        const kit_foil leaf = { KIT_BROAD, height * kit_between(b, 0.5, 0.75), height * kit_between(b, 0.14, 0.2),
                                kit_between(b, 0.6, 1.9), 0.3 };
        double out[3], across[3];
        kit_lean(upright, kit_between(b, 0.1, 0.9), 2.39996 * k, out, across);
        for (int i = 0; i < 3; i++) across[i] = -across[i];
        kit_shade(b, green, 0.2);
        kit_grow_leaf(b, &leaf, trunk[2], out, across);
    }
}

/* ---- >>flowers ------------------------------------------------------------------------------------------------- */

static void blossom(kit_build *b, const double at[3], const double way[3], double size, int kind, const float colour[3])
{
    const kit_foil tulip = { KIT_POINTED, size, 0.6 * size, -0.5, 0.2 }, petal = { KIT_DIAMOND, size, 0.4 * size, 0.3, 0 },
                   bell = { KIT_ROUND, 0.6 * size, 0.5 * size, 0.8, 0 };
    double out[3], across[3];
    for (int k = 0; k < 6 && kind == 0; k++) {                             /* a cup */
        kit_lean(way, 0.35, KIT_PI / 3 * k, out, across);
        kit_shade(b, colour, 0.15);
        kit_grow_leaf(b, &tulip, at, out, across);
    }
    for (int k = 0; k < 13 && (kind == 1 || kind == 2); k++) {             /* a disc with rays */
        kit_lean(way, kit_between(b, 1.2, 1.5), 2 * KIT_PI / 13 * k, out, across);
        kit_shade(b, colour, 0.12);
        kit_grow_leaf(b, &petal, at, out, across);
    }
    for (int k = 0; k < 14 && kind > 2; k++) {                             /* a spike, a ball */
        const double down = kind == 3 ? 0.35 * size * k : 0, spot[3] = { at[0] - way[0] * down, at[1] - way[1] * down, at[2] - way[2] * down };
        kit_lean(way, kind == 3 ? 1.1 : kit_between(b, 0, 2), 2.39996 * k, out, across);
        kit_shade(b, colour, 0.2);
        kit_grow_leaf(b, &bell, spot, out, across);
    }
    if (kind != 1 && kind != 2) return;
    const double heart[3] = { 0.35 * size, 0.2 * size, 0.35 * size };
    kit_place_at(b, at[0], at[1], at[2], 0);
    if (kind == 1) kit_colour(b, 0.75, 0.55, 0.1);
    else kit_colour(b, 0.2, 0.12, 0.06);
    kit_cushion(b, heart, 1, 5);
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_grow_flower(kit_build *b, double height, int kind, const float colour[3])
{
    enum { POINTS = 4 };
    static const double foot[3] = { 0, -0.02, 0 };
    const double size = kind == 2 ? 0.13 * height : fmin(0.09, 0.2 * height);
    const kit_foil leaf = { kind == 2 ? KIT_ROUND : KIT_POINTED, 0.4 * height, kind == 2 ? 0.25 * height : 0.08 * height, 0.9, 0 };
    const float green[3] = { 0.2f, 0.33f, 0.1f };
    double at[POINTS][3], way[3] = { kit_between(b, -0.25, 0.25), 1, kit_between(b, -0.25, 0.25) };
    kit_unit(way);
    kit_wander(b, foot, way, height, 0.4, 0, at, POINTS);
    kit_shade(b, green, 0.2);
    kit_grow_limb(b, &(kit_limb){ (const double (*)[3])at, POINTS, 0.004 + 0.006 * height, 0.003 + 0.003 * height, 0, 0, 4 });
    kit_grow_cluster(b, &leaf, at[kind == 2 ? 2 : 0], upright, 0.9, kind == 2 ? 5 : 3);
    if (kind == 2) kit_grow_cluster(b, &leaf, at[1], upright, 1.3, 4);
    if (kind == 2) { way[0] += 0.7; kit_unit(way); }                       /* it looks to one side, as the others do */
    blossom(b, at[POINTS - 1], way, size, kind, colour);
}

void kit_grow_reed(kit_build *b, double height)
{
    enum { POINTS = 5 };
    static const double foot[3] = { 0, -0.3, 0 };
    const kit_foil blade = { KIT_BLADE, 0.8 * height, 0.016, 0.6, 0.2 };
    double at[POINTS][3], way[3] = { kit_between(b, -0.15, 0.15), 1, kit_between(b, -0.15, 0.15) };
    kit_unit(way);
    kit_wander(b, foot, way, height + 0.3, 0.2, 0.1, at, POINTS);
    kit_colour(b, 0.38, 0.38, 0.16);
    kit_grow_limb(b, &(kit_limb){ (const double (*)[3])at, POINTS, 0.006, 0.003, 0, 0, 4 });
    kit_colour(b, 0.26, 0.34, 0.12);
    kit_grow_tuft(b, &blade, 5, 0.35);
    if (!kit_odds(b, 0.6)) return;
    const double head[2][3] = { { at[3][0], at[3][1], at[3][2] },
                                { 0.3 * at[3][0] + 0.7 * at[4][0], 0.3 * at[3][1] + 0.7 * at[4][1], 0.3 * at[3][2] + 0.7 * at[4][2] } };
    kit_colour(b, 0.24, 0.14, 0.08);
    kit_tube(b, head, 2, 0.018, 7);
}

void kit_grow_mushroom(kit_build *b, double height)
{
    static const float caps[][3] = { { 0.45f, 0.27f, 0.14f }, { 0.62f, 0.1f, 0.06f }, { 0.7f, 0.62f, 0.5f }, { 0.66f, 0.45f, 0.2f } };
    const double r = height * kit_between(b, 0.4, 0.7), stem = 0.16 * height, h = height * kit_between(b, 0.25, 0.5);
    const kit_moulding foot[] = { { 1.3 * stem, -0.02, stem, 0.4 * height, -0.02 * height }, { stem, 0.4 * height, stem, height - 0.9 * h, 0 } };
    const kit_moulding cap[] = { { stem, height - 0.9 * h, r, height - h, 0 }, { r, height - h, 0, height, 0.3 * r } };
    kit_colour(b, 0.72, 0.68, 0.58);
    kit_turned(b, foot, 2, 9);
    KIT_TINT(b, caps, 0.15);
    kit_turned(b, cap, 2, 14);
}

/* ---- >>others -------------------------------------------------------------------------------------------------- */

typedef struct ribbed { double radius, height; int ribs; } ribbed;

static void ribbed_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const ribbed *s = shape;
    const double a = 2 * KIT_PI * fmod(u, 1), wave = 1 + 0.16 * cos(s->ribs * a), t = fmin(1, v / 0.85),
                 end = v > 0.85 ? (v - 0.85) / 0.15 : 0, r = s->radius * wave * sqrt(fmax(0, 1 - end * end)),
                 slope = 0.16 * s->ribs * sin(s->ribs * a) / wave;
    out->p[0] = r * cos(a); out->p[2] = r * sin(a);
    out->p[1] = s->height * (0.9 * t + 0.1 * end);
    out->n[0] = (1 - end) * (cos(a) - slope * sin(a)); out->n[1] = end + 0.01; out->n[2] = (1 - end) * (sin(a) + slope * cos(a));
    kit_unit(out->n);
}

void kit_grow_cactus(kit_build *b, double height)
{
    const ribbed trunk = { 0.09 * height + 0.03, height, 9 + kit_choose(b, 5) };
    const int arms = height > 0.8 ? kit_choose(b, 4) : 0;
    kit_colour(b, 0.2, kit_between(b, 0.28, 0.36), 0.16);
    kit_patch(b, 4 * trunk.ribs, 20, ribbed_surface, &trunk);
    for (int k = 0; k < arms; k++) {
        const double y = height * kit_between(b, 0.3, 0.55), a = 2.2 * k, r = trunk.radius, away = 0.2 * height + r,
                     top = y + height * kit_between(b, 0.2, 0.4);
        const double elbow[5][3] = { { 0.5 * r * cos(a), y, 0.5 * r * sin(a) }, { 0.8 * away * cos(a), y + 0.02, 0.8 * away * sin(a) },
                                     { away * cos(a), y + 0.3 * r, away * sin(a) }, { away * cos(a), y + 1.2 * r, away * sin(a) },
                                     { away * cos(a), top, away * sin(a) } };
        const double tip[3] = { 0.6 * r, 0.5 * r, 0.6 * r };
        kit_tube(b, elbow, 5, 0.6 * r, 14);
        kit_place_at(b, elbow[4][0], top, elbow[4][2], 0);
        kit_cushion(b, tip, 1, 8);
        kit_place_at(b, 0, 0, 0, 0);
    }
}

void kit_grow_ivy(kit_build *b, double x0, double x1, double height, double cover)
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
        kit_tube(b, (const double (*)[3])at, POINTS, 0.009, 4);
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
        kit_shade(b, green, 0.3);
        kit_grow_leaf(b, &leaf, at, down, across);
    }
}
