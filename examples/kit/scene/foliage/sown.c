/* sown.c - what scenes by seed of plants stand on, and what is set out and sown there. Declared in foliage.h. */
#include "kit/scene/foliage/foliage.h"
#include <math.h>
#include <string.h>

/* ---- >>ground -------------------------------------------------------------------------------------------------- */

static double smooth(double low, double high, double x)
{
    const double t = fmax(0, fmin(1, (x - low) / (high - low)));
    return t * t * (3 - 2 * t);
}

static double height(const kit_plot *of, double x, double z)
{
    const double *s = of->of, r = sqrt(x * x + z * z), f = s[KIT_OFTEN];
    const unsigned seed = (unsigned)s[KIT_SEEDED];
    double h = s[KIT_BUMPS] * kit_fractal(seed, f * x, 0.5, f * z, 3) * smooth(s[KIT_LEVEL], s[KIT_LEVEL] + 4, r + 4);
    h += s[KIT_HILLS] * smooth(18, 60, r) * (0.7 + 0.5 * kit_noise(seed + 7, 0.06 * x, 0, 0.06 * z));
    if (!(s[KIT_HOLLOW_R] > 0)) return h;
    const double dx = x - s[KIT_HOLLOW_X], dz = z - s[KIT_HOLLOW_Z],
                 round = 1 + 0.25 * kit_noise(seed + 3, 0.3 * x, 0, 0.3 * z);
    return h - s[KIT_HOLLOW_DEEP] * (1 - smooth(0.55, 1.15, sqrt(dx * dx + dz * dz) / (round * s[KIT_HOLLOW_R])));
}

/* cells are small in the middle and wide far off */
static double stretched(double t) { return 12 * t + 58 * t * t * t * t * t; }

static void ground_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const kit_plot *p = shape;
    const double x = stretched(2 * u - 1), z = stretched(2 * v - 1), e = 0.05;
    out->p[0] = x;
    out->p[1] = kit_ground_at(p, x, z);
    out->p[2] = z;
    out->n[0] = kit_ground_at(p, x - e, z) - kit_ground_at(p, x + e, z);
    out->n[1] = 2 * e;
    out->n[2] = kit_ground_at(p, x, z - e) - kit_ground_at(p, x, z + e);
    kit_unit(out->n);
}

void garden_lay_ground(kit_yard *y, double bumps, double often, double level, double hills)
{
    kit_plot *p = y->p;
    kit_build *b = &p->b;
    p->of[KIT_BUMPS] = bumps;
    p->of[KIT_OFTEN] = often;
    p->of[KIT_LEVEL] = level;
    p->of[KIT_HILLS] = hills;
    p->of[KIT_SEEDED] = kit_choose(b, 100000);
    p->ground = height;
    kit_begin_object(b, "ground", 0);
    kit_patch(b, 84, 84, ground_surface, p);
}

void garden_lay_path(kit_yard *y, double x, double half, double from, double to)
{
    enum { ACROSS = 6 };

    kit_plot *p = y->p;
    const int pieces = (int)((to - from) / 0.4);
    for (int k = 0; k < pieces * ACROSS; k++) {
        const int along = k / ACROSS, side = k % ACROSS;
        double q[4][3];
        for (int i = 0; i < 4; i++) {
            q[i][2] = from + (to - from) * (along + (i < 2)) / pieces;
            q[i][0] = x + half * (2.0 * (side + (i == 1 || i == 2)) / ACROSS - 1) + 0.3 * sin(0.35 * q[i][2]);
            q[i][1] = kit_ground_at(p, q[i][0], q[i][2]) + 0.045;
        }
        kit_quad(&p->b, (const double(*)[3])q);
    }
    for (double z = from; z < to; z += half) garden_take(y, x + 0.3 * sin(0.35 * z), z, half);
}

/* ---- >>places -------------------------------------------------------------------------------------------------- */

void garden_take(kit_yard *y, double x, double z, double radius)
{
    const double disc[4] = { x, z, radius, radius };
    if (y->takes < KIT_TAKEN) memcpy(y->taken[y->takes++], disc, sizeof disc);
}

int garden_is_free(const kit_yard *y, double x, double z, double radius)
{
    for (int k = 0; k < y->takes; k++) {
        const double dx = x - y->taken[k][0], dz = z - y->taken[k][1], r = radius + y->taken[k][2];
        if (dx * dx + dz * dz < r * r) return 0;
    }
    return 1;
}

/* whether grass grows there */
static int is_bare(const kit_yard *y, double x, double z)
{
    for (int k = 0; k < y->takes; k++) {
        const double dx = x - y->taken[k][0], dz = z - y->taken[k][1], r = y->taken[k][3];
        if (dx * dx + dz * dz < r * r) return 1;
    }
    return 0;
}

int garden_find_spot(kit_yard *y, double near, double far, double radius, double at[2])
{
    for (int k = 0; k < 30; k++) {
        const double r = sqrt(kit_between(&y->p->b, near * near, far * far)), a = kit_between(&y->p->b, 0, 2 * KIT_PI);
        at[0] = r * cos(a);
        at[1] = r * sin(a);
        if (!garden_is_free(y, at[0], at[1], radius)) continue;
        garden_take(y, at[0], at[1], radius);
        if (y->takes < KIT_TAKEN) y->taken[y->takes - 1][3] = 0;
        return 1;
    }
    return 0;
}

kit_frame garden_set_out(kit_yard *y, const char *name, double x, double z, double turn)
{
    if (name) kit_begin_object(&y->p->b, name, -1);
    return kit_enter(&y->p->b, x, kit_ground_at(y->p, x, z), z, turn, 1);
}

int garden_has_room(const kit_yard *y) { return y->p->b.scene.mesh.triangles < KIT_MOST_TRIANGLES; }

void garden_sight_above(kit_yard *y, double x, double up, double z, double reach)
{
    kit_add_sight(y->p, x, kit_ground_at(y->p, x, z) + up, z, reach);
}

/* ---- >>trees --------------------------------------------------------------------------------------------------- */

void garden_set_tree(kit_yard *y, double x, double z, int species, int detail)
{
    kit_build *b = &y->p->b;
    const kit_tree t = garden_draw_tree(b, species, y->season);
    const kit_frame before = garden_set_out(y, "tree", x, z, kit_between(b, 0, 360));
    garden_grow_tree(b, &t, garden_has_room(y) ? detail : 0);
    kit_leave(b, before);
    if (detail < 1) return;
    garden_sight_above(y, x, 0.65 * t.height, z, fmin(2.5, 0.3 * t.height));
    if (detail > 1) garden_sight_above(y, x, 0.5, z, 0.9);
}

void garden_set_conifer(kit_yard *y, double x, double z, double tall, int detail)
{
    kit_build *b = &y->p->b;
    const kit_frame before = garden_set_out(y, "conifer", x, z, kit_between(b, 0, 360));
    garden_grow_conifer(b, tall, garden_has_room(y) ? detail : 0);
    kit_leave(b, before);
    if (detail) garden_sight_above(y, x, 0.3 * tall, z, fmin(2, 0.3 * tall));
}

void garden_set_far_trees(kit_yard *y, int count, double near, double far)
{
    kit_build *b = &y->p->b;
    const int solid = kit_odds(b, 0.5), pointed = kit_odds(b, 0.35);
    const float green[3] = { (float)kit_between(b, 0.10, 0.24), (float)kit_between(b, 0.20, 0.30), 0.09f };
    kit_begin_object(b, "far trees", -1);
    for (int k = 0; k < count; k++) {
        const double a = 2 * KIT_PI * (k + kit_chance(b)) / count, r = kit_between(b, near, far);
        const kit_frame before = garden_set_out(y, NULL, r * cos(a), r * sin(a), kit_between(b, 0, 360));
        kit_colour(b, (double)green[0], (double)green[1], (double)green[2]);
        garden_grow_far_tree(b, kit_between(b, 5, 12), kit_odds(b, 0.85) ? pointed : !pointed, solid);
        kit_leave(b, before);
    }
}

/* ---- >>sown ---------------------------------------------------------------------------------------------------- */

/* Middles of patches: about what is worth looking at, most of them. */
static void draw_patches(kit_yard *y, double middle[][3], int count, double reach, double length)
{
    kit_build *b = &y->p->b;
    const int seen = y->p->sights;
    for (int k = 0; k < count; k++) {
        const double r = reach * sqrt(kit_chance(b)), a = kit_between(b, 0, 2 * KIT_PI);
        const kit_sight *s = seen ? &y->p->sight[kit_choose(b, seen)] : NULL;
        const int by_it = s && k % 3;
        middle[k][0] = by_it ? s->at[0] + kit_between(b, -1, 1) : r * cos(a);
        middle[k][1] = by_it ? s->at[2] + kit_between(b, -1, 1) : r * sin(a);
        middle[k][2] = reach * kit_between(b, 0.12, 0.4);
        if (k < 3) garden_sight_above(y, middle[k][0], 0.4 * length, middle[k][1], 0.5 + length);
    }
}

void garden_sow_grass(kit_yard *y, int blades, double length, double reach, int patches)
{
    enum { PATCHES = 40 };

    static const float grass[][3] = { { 0.20f, 0.32f, 0.08f }, { 0.30f, 0.38f, 0.12f }, { 0.42f, 0.40f, 0.18f } };
    kit_build *b = &y->p->b;
    const int tall = length > 0.18, count = 2 * patches < PATCHES ? 2 * patches : PATCHES;
    double middle[PATCHES][3];
    float green[3];
    KIT_TINT(b, grass, 0.15);
    memcpy(green, b->albedo, sizeof green);
    draw_patches(y, middle, count, reach, length);
    kit_begin_object(b, "grass", -1);
    for (int k = 0; k < (tall ? 1.6 : 4.5) * blades && garden_has_room(y); k += 7) {
        const double *m = middle[k / 7 % count], r = m[2] * pow(kit_chance(b), 0.7), a = kit_between(b, 0, 2 * KIT_PI),
                     x = m[0] + r * cos(a), z = m[1] + r * sin(a), long_enough = length * kit_between(b, 0.5, 1.2);
        const kit_foil blade = { tall ? KIT_BLADE : KIT_NEEDLE, long_enough, 0.006 + 0.025 * long_enough,
                                 kit_between(b, 0.4, 1.6), 0 };
        if (is_bare(y, x, z)) continue;
        const kit_frame before = garden_set_out(y, NULL, x, z, kit_between(b, 0, 360));
        garden_shade(b, green, 0.2);
        garden_grow_tuft(b, &blade, 7, tall ? 0.5 : 0.9);
        kit_leave(b, before);
    }
}

void garden_sow_flowers(kit_yard *y, double x, double z, double hx, double hz, int count, double tall)
{
    static const float petals[][3] = { { 0.75f, 0.12f, 0.10f }, { 0.80f, 0.65f, 0.12f }, { 0.78f, 0.76f, 0.74f },
                                       { 0.55f, 0.22f, 0.60f }, { 0.80f, 0.45f, 0.55f }, { 0.25f, 0.28f, 0.65f },
                                       { 0.82f, 0.40f, 0.10f } };
    kit_build *b = &y->p->b;
    const int kind = kit_choose(b, KIT_FLOWERS);
    float colour[3];
    KIT_TINT(b, petals, 0.1);
    memcpy(colour, b->albedo, sizeof colour);
    if (kind == 2) {
        tall *= 2.2;
        count /= 3;
    }
    for (int k = 0; k < count && garden_has_room(y); k++) {
        const double u = kit_between(b, -1, 1), v = kit_between(b, -1, 1);
        const kit_frame before = garden_set_out(y, NULL, x + u * hx, z + v * hz, kit_between(b, 0, 360));
        garden_grow_flower(b, tall * kit_between(b, 0.7, 1.15), kind, colour);
        kit_leave(b, before);
    }
    garden_sight_above(y, x, 0.7 * tall, z, fmin(0.9, fmax(0.35, hx)));
}

/* Leaves that have fallen: single quads on the ground. */
void garden_sow_litter(kit_yard *y, int leaves, double reach)
{
    static const float browns[][3] = {
        { 0.40f, 0.24f, 0.10f }, { 0.52f, 0.34f, 0.12f }, { 0.30f, 0.20f, 0.12f }, { 0.50f, 0.20f, 0.08f }
    };
    kit_build *b = &y->p->b;
    kit_begin_object(b, "litter", -1);
    for (int k = 0; k < leaves && garden_has_room(y); k++) {
        const double r = reach * pow(kit_chance(b), 0.7), a = kit_between(b, 0, 2 * KIT_PI),
                     size = kit_between(b, 0.05, 0.12);
        const kit_foil leaf = { KIT_POINTED, size, 0.6 * size, kit_between(b, -0.8, 1), 0 };
        const double at[3] = { 0, kit_between(b, 0.012, 0.04), 0 }, rise = kit_between(b, -0.1, 0.35),
                     along[3] = { 0, sin(rise), cos(rise) }, across[3] = { 1, 0, 0 };
        const kit_frame before = garden_set_out(y, NULL, r * cos(a), r * sin(a), kit_between(b, 0, 360));
        KIT_TINT(b, browns, 0.25);
        garden_grow_leaf(b, &leaf, at, along, across);
        kit_leave(b, before);
    }
}

static void sow_low_leaves(kit_yard *y, int plants, double reach)
{
    static const float greens[][3] = { { 0.18f, 0.34f, 0.10f }, { 0.26f, 0.36f, 0.12f }, { 0.12f, 0.24f, 0.10f } };
    kit_build *b = &y->p->b;
    const int outline = kit_odds(b, 0.5) ? KIT_ROUND : KIT_DIAMOND;
    const double size = kit_between(b, 0.06, 0.18);
    KIT_TINT(b, greens, 0.15);
    kit_begin_object(b, "cover", -1);
    for (int k = 0; k < plants && garden_has_room(y); k++) {
        const double r = reach * sqrt(kit_chance(b)), a = kit_between(b, 0, 2 * KIT_PI), x = r * cos(a), z = r * sin(a);
        const kit_foil leaf = { outline, size * kit_between(b, 0.6, 1.3), 0.7 * size, 0.8, 0 };
        if (kit_noise(5, 0.5 * x, 0, 0.5 * z) < -0.1 || is_bare(y, x, z)) continue;
        const kit_frame before = garden_set_out(y, NULL, x, z, kit_between(b, 0, 360));
        garden_grow_tuft(b, &leaf, 5, 1.1);
        kit_leave(b, before);
    }
}

void garden_sow_cover(kit_yard *y, int plants, int twigs, int pebbles, double reach)
{
    static const float greys[][3] = { { 0.45f, 0.42f, 0.38f }, { 0.32f, 0.30f, 0.28f }, { 0.55f, 0.50f, 0.44f } };
    kit_build *b = &y->p->b;
    sow_low_leaves(y, plants, reach);
    kit_begin_object(b, "twigs and pebbles", -1);
    for (int k = 0; k < twigs + pebbles && garden_has_room(y); k++) {
        const double r = reach * sqrt(kit_chance(b)), a = kit_between(b, 0, 2 * KIT_PI), s = kit_between(b, 0.02, 0.06);
        const double half[3] = { s, 0.6 * s, 0.8 * s }, from[3] = { 0, 0.015, 0 };
        const kit_frame before = garden_set_out(y, NULL, r * cos(a), r * sin(a), kit_between(b, 0, 360));
        double at[5][3], way[3] = { 1, 0.05, 0 };
        garden_wander(b, from, way, kit_between(b, 0.2, 0.9), 1, 0, at, 5);
        kit_colour(b, 0.30, 0.24, 0.18);
        if (k < twigs) kit_tube(b, (const double(*)[3])at, 5, kit_between(b, 0.004, 0.014), 5);
        else KIT_TINT(b, greys, 0.15);
        if (k >= twigs) kit_cushion(b, half, 0.9, 5);
        kit_leave(b, before);
    }
}

/* ---- >>set out ------------------------------------------------------------------------------------------------- */

void garden_set_stones(kit_yard *y, int count, double near, double far, double size)
{
    kit_build *b = &y->p->b;
    for (int k = 0; k < count && garden_has_room(y); k++) {
        const double s = size * kit_between(b, 0.25, 1) * kit_between(b, 0.5, 1);
        const double half[3] = { s * kit_between(b, 0.8, 1.3), s * kit_between(b, 0.5, 0.9), s };
        double at[2];
        if (!garden_find_spot(y, near, far, s, at)) continue;
        const kit_frame before = garden_set_out(y, "stone", at[0], at[1], kit_between(b, 0, 360));
        garden_put_stone(b, half, s > 0.3 ? 22 : 12);
        kit_leave(b, before);
        if (k < 4) garden_sight_above(y, at[0], 0.4 * s, at[1], 1.3 * s + 0.1);
    }
}

void garden_set_bushes(kit_yard *y, int count, double near, double far, double size)
{
    kit_build *b = &y->p->b;
    const int kind = kit_choose(b, KIT_BUSHES);
    for (int k = 0; k < count && garden_has_room(y); k++) {
        const double tall = size * kit_between(b, 0.5, 1.2), wide = tall * kit_between(b, 0.8, 1.5);
        double at[2];
        if (!garden_find_spot(y, near, far, 0.4 * wide, at)) continue;
        const kit_frame before = garden_set_out(y, "bush", at[0], at[1], kit_between(b, 0, 360));
        garden_grow_bush(b, wide, tall, kit_odds(b, 0.6) ? kind : kit_choose(b, KIT_BUSHES));
        kit_leave(b, before);
        if (k < 4) garden_sight_above(y, at[0], 0.5 * tall, at[1], 0.6 * tall + 0.2);
    }
}

void garden_set_ferns(kit_yard *y, int count, double near, double far)
{
    kit_build *b = &y->p->b;
    for (int k = 0; k < count && garden_has_room(y); k++) {
        const double size = kit_between(b, 0.35, 0.95);
        double at[2];
        if (!garden_find_spot(y, near, far, 0.4 * size, at)) continue;
        const kit_frame before = garden_set_out(y, k % 4 ? NULL : "ferns", at[0], at[1], 0);
        garden_grow_fern(b, size, 6 + kit_choose(b, 6));
        kit_leave(b, before);
        if (k < 4) garden_sight_above(y, at[0], 0.3 * size, at[1], 0.9 * size);
    }
}

/* A pot and what grows in it. */
void garden_set_pot(kit_yard *y, double x, double z, double tall)
{
    static const float green[3] = { 0.22f, 0.34f, 0.1f }, red[3] = { 0.7f, 0.15f, 0.12f };
    kit_build *b = &y->p->b;
    const int kind = kit_choose(b, 7);
    double opening;
    const kit_frame outer = garden_set_out(y, "pot", x, z, kit_between(b, 0, 360));
    const double soil = garden_put_pot(b, tall, kit_choose(b, 3), &opening);
    const kit_frame inner = kit_enter(b, 0, soil, 0, 0, 1);
    if (kind < 2) garden_grow_rosette(b, tall * kit_between(b, 0.9, 1.8), kit_choose(b, 4));
    if (kind == 2) garden_grow_topiary(b, kit_between(b, 0.7, 1.5), kit_choose(b, 3));
    if (kind == 3) garden_grow_fern(b, 1.4 * tall, 9);
    if (kind == 4) garden_grow_bush(b, 2.2 * opening + 0.2, kit_between(b, 0.5, 1.1), kit_choose(b, 2));
    if (kind == 5) garden_grow_cactus(b, tall * kit_between(b, 0.8, 2.2));
    for (int k = 0; k < 14 && kind == 6; k++) {
        const double a = 2.4 * k, r = 0.8 * opening * sqrt(k / 14.0);
        const kit_frame before = kit_enter(b, r * cos(a), 0, r * sin(a), 57 * a, 1);
        garden_shade(b, green, 0.2);
        garden_grow_flower(b, tall * kit_between(b, 0.5, 0.9), 1, red);
        kit_leave(b, before);
    }
    kit_leave(b, inner);
    kit_leave(b, outer);
    garden_sight_above(y, x, tall, z, 0.35 + 0.8 * tall);
}
