/* bushes.c - bushes, hedges and clipped shapes of scenes by seed. Declared in foliage.h. */
#include "kit/scene/foliage/foliage.h"
#include <math.h>
#include <string.h>

static const double upright[3] = { 0, 1, 0 };
static const float leaves_green[][3] = { { 0.15f, 0.28f, 0.07f }, { 0.22f, 0.34f, 0.10f }, { 0.10f, 0.20f, 0.07f },
                                         { 0.30f, 0.36f, 0.12f }, { 0.34f, 0.38f, 0.28f }, { 0.40f, 0.16f, 0.14f } };

static void take_colour(const kit_build *b, float out[3]) { memcpy(out, b->albedo, sizeof b->albedo); }

/* ---- >>bushes -------------------------------------------------------------------------------------------------- */

double garden_lump_out(const kit_lump *s, const double way[3])
{
    return 1 + s->strong * kit_fractal(s->seed, s->often * way[0], s->often * way[1], s->often * way[2], s->octaves);
}

void garden_lump_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const kit_lump *s = shape;
    const double unit = 1, e = 0.02;
    double n[3], grow[3];
    kit_sphere_surface(&unit, u, v, out);
    memcpy(n, out->n, sizeof n);
    const double k = garden_lump_out(s, n);
    for (int i = 0; i < 3; i++) {
        double q[3] = { n[0], n[1], n[2] };
        q[i] += e;
        grow[i] = (garden_lump_out(s, q) - k) / e;
        out->p[i] = s->half[i] * k * n[i];
    }
    const double along = kit_dot(grow, n);
    for (int i = 0; i < 3; i++) out->n[i] = (n[i] - (grow[i] - along * n[i]) / k) / s->half[i];
    kit_unit(out->n);
}

/* a point on it in the direction */
static void on_lump(const kit_lump *s, const double way[3], double out[3])
{
    const double k = garden_lump_out(s, way);
    for (int i = 0; i < 3; i++) out[i] = s->half[i] * k * way[i];
}

static void random_way(kit_build *b, double lowest, double out[3])
{
    const double y = kit_between(b, lowest, 1), a = kit_between(b, 0, 2 * KIT_PI), r = sqrt(1 - y * y);
    out[0] = r * cos(a);
    out[1] = y;
    out[2] = r * sin(a);
}

/* Leaves over a lumpy ball about middle. */
static void leafy_lump(kit_build *b, const kit_lump *s, double middle, const kit_foil *leaf, int count, int core)
{
    float green[3];
    take_colour(b, green);
    if (core) {
        kit_lump inner = *s;
        for (int i = 0; i < 3; i++) inner.half[i] *= 0.93;
        kit_colour(b, 0.5 * (double)green[0], 0.5 * (double)green[1], 0.5 * (double)green[2]);
        kit_place_at(b, 0, middle, 0, 0);
        kit_patch(b, 20, 12, garden_lump_surface, &inner);
        kit_place_at(b, 0, 0, 0, 0);
    }
    for (int k = 0; k < count; k++) {
        double way[3], at[3], out[3], across[3];
        random_way(b, -0.75, way);
        on_lump(s, way, at);
        const double in = core ? 0.94 : kit_between(b, 0.6, 1);
        for (int i = 0; i < 3; i++) at[i] *= in;
        at[1] += middle;
        garden_lean(way, kit_between(b, 0.4, 1.3), kit_between(b, 0, 2 * KIT_PI), out, across);
        garden_shade(b, green, 0.25);
        garden_grow_leaf(b, leaf, at, out, across);
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
        garden_lean(upright, kit_between(b, 0.1, 0.8) * fmin(1, width / height), 2.39996 * k, way, across);
        garden_wander(b, from, way, height * kit_between(b, 0.7, 1.15), 0.7, kit_between(b, 0, 0.6), at, POINTS);
        kit_colour(b, 0.28, 0.20, 0.13);
        garden_grow_limb(b, &(kit_limb){ (const double(*)[3])at, POINTS, 0.012, 0.003, 0, 0, 4, 0 });
        for (int n = 1; n < POINTS; n++) {
            garden_shade(b, green, 0.22);
            garden_grow_cluster(b, leaf, at[n], way, 1.2, 6);
        }
    }
}

void garden_grow_bush(kit_build *b, double width, double height, int kind)
{
    const double deep = width / 2 * kit_between(b, 0.8, 1.2);
    const kit_lump s = { { width / 2, height / 2, deep }, (unsigned)kit_choose(b, 10000), 0.22, 1.6, 2 };
    const double leaf = kit_between(b, 0.05, 0.11) * (0.6 + 0.4 * height);
    const kit_foil small = { kit_odds(b, 0.5) ? KIT_DIAMOND : KIT_POINTED, leaf, leaf * kit_between(b, 0.4, 0.75), 0.5,
                             0 };
    float green[3];
    KIT_TINT(b, leaves_green, 0.15);
    take_colour(b, green);
    if (kind == KIT_BUSH_CORE) leafy_lump(b, &s, 0.46 * height, &small, 750, 1);
    if (kind == KIT_BUSH_TWIGS) stemmed_bush(b, width, height, &small);
    for (int k = 0; k < 12 && kind == KIT_BUSH_CARDS; k++) {
        const kit_foil card = { KIT_RAGGED, height * kit_between(b, 0.4, 0.6), height * 0.45, 0.4, 0 };
        double way[3], at[3];
        random_way(b, -0.1, way);
        on_lump(&s, way, at);
        for (int i = 0; i < 3; i++) at[i] *= 0.5;
        at[1] += 0.35 * height;
        garden_shade(b, green, 0.25);
        garden_grow_cards(b, &card, at, way, 2);
    }
}

/* ---- >>clipped ------------------------------------------------------------------------------------------------- */

/* One face of a hedge: from corner along u and v, facing out. */
static void clipped_face(kit_build *b, const double corner[3], const double u[3], const double v[3],
                         const double out[3], const kit_foil *leaf, double density, int deep)
{
    const double area = sqrt(kit_dot(u, u) * kit_dot(v, v));
    float green[3];
    take_colour(b, green);
    for (int k = 0; k < (int)(area * density); k++) {
        const double s = kit_chance(b), t = kit_chance(b),
                     in = deep ? kit_between(b, -0.25, 0.02) : kit_between(b, -0.05, 0.01);
        double at[3], way[3], across[3];
        for (int i = 0; i < 3; i++) at[i] = corner[i] + s * u[i] + t * v[i] + in * out[i];
        garden_lean(out, kit_between(b, 0.3, 1.3), kit_between(b, 0, 2 * KIT_PI), way, across);
        garden_shade(b, green, 0.25);
        garden_grow_leaf(b, leaf, at, way, across);
    }
    memcpy(b->albedo, green, sizeof green);
}

void garden_grow_hedge(kit_build *b, double x, double height, double z, double leaf, int core)
{
    const kit_foil l = { KIT_DIAMOND, leaf, 0.6 * leaf, 0.3, 0 };
    const double density = 0.75 / (leaf * leaf), hx = x / 2, hz = z / 2;
    const double corner[5][3] = {
        { -hx, 0, hz }, { -hx, 0, -hz }, { hx, 0, -hz }, { -hx, 0, -hz }, { -hx, height, -hz }
    };
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
        const double way[3] = { cos(a), (r0 - r1) / fabs(y1 - y0), sin(a) },
                     at[3] = { r * cos(a), y0 + t * (y1 - y0), r * sin(a) };
        double unit[3] = { way[0], way[1], way[2] }, out[3], across[3];
        kit_unit(unit);
        garden_lean(unit, kit_between(b, 0.4, 1.3), kit_between(b, 0, 2 * KIT_PI), out, across);
        garden_shade(b, green, 0.25);
        garden_grow_leaf(b, &l, at, out, across);
    }
    memcpy(b->albedo, green, sizeof green);
}

void garden_grow_topiary(kit_build *b, double height, int kind)
{
    const double radius = height * kit_between(b, 0.24, 0.34), leaf = 0.035 + 0.02 * height;
    const kit_lump s = { { radius, radius, radius }, 1, 0.1, 1.6, 2 };
    const kit_foil l = { KIT_DIAMOND, leaf, 0.6 * leaf, 0.3, 0 };
    const double trunk[2][3] = { { 0, -0.05, 0 }, { 0, height - radius, 0 } };
    float green[3];
    kit_colour(b, 0.12, 0.23, 0.08);
    garden_shade(b, b->albedo, 0.2);
    take_colour(b, green);
    if (kind == 1) {
        clipped_cone(b, radius, 0.05 * height, 0.03, height, leaf);
        return;
    }
    for (int k = 0; k < 3 && kind == 2; k++)
        clipped_cone(b, radius * (1 - 0.28 * k), height * (0.12 + 0.3 * k), radius * (0.7 - 0.25 * k),
                     height * (0.34 + 0.3 * k), leaf);
    if (!kind) leafy_lump(b, &s, height - radius, &l, 900, 1);
    kit_colour(b, 0.26, 0.2, 0.14);
    garden_grow_limb(b, &(kit_limb){ trunk, 2, 0.02 + 0.015 * height, 0.02 + 0.01 * height, 0, 0, 8, 0 });
}
