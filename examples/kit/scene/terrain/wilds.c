/* wilds.c - what grows, is built and is left in landscapes: trees, driftwood, cacti, huts, boats, shells. Declared in
   terrain.h. */
#include "kit/scene/terrain/terrain.h"
#include <math.h>
#include <string.h>

/* ---- >>wood ------------------------------------------------------------------------------------------------------ */

typedef struct limb {
    const double *from, *over, *to;
    double r0, r1;
} limb;

static void limb_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const limb *l = shape;
    const double a = 2 * KIT_PI * fmod(u, 1), r = v >= 1 ? l->r1 : l->r0 + (l->r1 - l->r0) * v;
    double way[3], side[3], up[3], axis[3] = { 0 }, whole[3];
    for (int i = 0; i < 3; i++) {
        whole[i] = l->to[i] - l->from[i];
        way[i] = (1 - v) * (l->over[i] - l->from[i]) + v * (l->to[i] - l->over[i]);
        out->p[i] = (1 - v) * (1 - v) * l->from[i] + 2 * v * (1 - v) * l->over[i] + v * v * l->to[i];
    }
    /* the axis that lies most across the limb */
    int k = 0;
    for (int i = 1; i < 3; i++)
        if (fabs(whole[i]) < fabs(whole[k])) k = i;
    axis[k] = 1;
    if (!kit_unit(way)) way[1] = 1;
    kit_cross(way, axis, side);
    kit_unit(side);
    kit_cross(way, side, up);
    for (int i = 0; i < 3; i++) {
        out->n[i] = cos(a) * side[i] + sin(a) * up[i];
        out->p[i] += r * out->n[i];
    }
}

void land_bent_limb(kit_build *b, const double from[3], const double over[3], const double to[3], double r0, double r1,
                    int around, int along)
{
    const limb l = { from, over, to, r0, r1 };
    kit_patch(b, around, along, limb_surface, &l);
}

/* a branch and those that grow from it */
static void branch(kit_build *b, const double from[3], const double way[3], double length, double radius, int depth)
{
    double over[3], to[3];
    for (int i = 0; i < 3; i++) {
        over[i] = from[i] + length * (0.5 * way[i] + kit_between(b, -0.1, 0.1));
        to[i] = from[i] + length * (way[i] + kit_between(b, -0.16, 0.16));
    }
    land_bent_limb(b, from, over, to, radius, depth ? 0.55 * radius : 0.1 * radius, 4 + (depth > 0) + 2 * (depth > 1),
                   depth ? 5 : 3);
    for (int k = 0, count = depth ? 2 + kit_choose(b, 3) : 0; k < count; k++) {
        const double t = k ? kit_between(b, 0.4, 0.98) : 1;
        double at[3], turned[3];
        for (int i = 0; i < 3; i++) {
            at[i] = (1 - t) * (1 - t) * from[i] + 2 * t * (1 - t) * over[i] + t * t * to[i];
            turned[i] = way[i] + kit_between(b, -0.85, 0.85);
        }
        turned[1] += 0.15;
        kit_unit(turned);
        branch(b, at, turned, length * kit_between(b, 0.5, 0.75), 0.5 * radius, depth - 1);
    }
}

void land_bare_tree(kit_build *b, double height, int depth)
{
    const double from[3] = { 0, -0.05 * height, 0 };
    double way[3] = { kit_between(b, -0.3, 0.3), 1, kit_between(b, -0.3, 0.3) };
    kit_unit(way);
    branch(b, from, way, 0.45 * height, 0.035 * height, depth);
    for (int k = 0; k < 5; k++) { /* roots */
        const double a = 2 * KIT_PI * (k + kit_chance(b)) / 5, r = kit_between(b, 0.08, 0.15) * height;
        const double top[3] = { 0, 0.05 * height, 0 }, over[3] = { 0.5 * r * cos(a), 0.01 * height, 0.5 * r * sin(a) },
                     to[3] = { r * cos(a), -0.03 * height, r * sin(a) };
        land_bent_limb(b, top, over, to, 0.022 * height, 0.006 * height, 6, 4);
    }
}

void land_driftwood(kit_build *b, double length)
{
    const double thick = kit_between(b, 0.03, 0.06) * length, from[3] = { -0.5 * length, thick, 0 },
                 over[3] = { 0, kit_between(b, 0.5, 3) * thick, kit_between(b, -0.2, 0.2) * length },
                 to[3] = { 0.5 * length, 0.5 * thick, 0 };
    land_bent_limb(b, from, over, to, thick, 0.35 * thick, 9, 12);
    for (int k = 0, count = 1 + kit_choose(b, 4); k < count; k++) {
        const double t = kit_between(b, -0.4, 0.3) * length, a[3] = { t, thick, 0 },
                     c[3] = { t + 0.12 * length, 3 * thick, kit_between(b, -0.12, 0.12) * length },
                     d[3] = { t + 0.2 * length, kit_between(b, 1, 6) * thick, kit_between(b, -0.25, 0.25) * length };
        land_bent_limb(b, a, c, d, 0.5 * thick, 0.1 * thick, 6, 6);
    }
}

void land_planks(kit_build *b, int count, double length)
{
    for (int k = 0; k < count; k++) {
        kit_place_at(b, kit_between(b, -0.1, 0.1), KIT_GAP + 0.035 * (k / 4), 0.24 * (k % 4) + kit_between(b, 0, 0.03),
                     kit_between(b, -4, 4));
        kit_box(b, -0.5 * length, 0, 0, 0.5 * length, 0.034, 0.2);
    }
}

void land_pole_ladder(kit_build *b, double height)
{
    for (int k = -1; k <= 1; k += 2) kit_box(b, 0.22 * k - 0.025, 0, -0.03, 0.22 * k + 0.025, height, 0.03);
    for (double y = 0.25; y < height - 0.1; y += 0.28) {
        const double rung[2][3] = { { -0.22, y, 0 }, { 0.22, y, 0 } };
        kit_tube(b, rung, 2, 0.016, 6);
    }
}

/* ---- >>what grows ------------------------------------------------------------------------------------------------ */

void land_grass_tuft(kit_build *b, double height, int blades)
{
    for (int k = 0; k < blades; k++) {
        const double a = kit_between(b, 0, 360), r = 0.18 * height * kit_chance(b);
        kit_place_tilted(b, r * sin(a * KIT_PI / 180), -0.02 * height, r * cos(a * KIT_PI / 180), a,
                         -kit_between(b, 55, 88));
        kit_leaf(b, kit_between(b, 0.015, 0.03) * height, height * kit_between(b, 0.6, 1), kit_between(b, 0.3, 1.4), 3,
                 1);
    }
}

/* ragged skirts about a trunk */
static void skirt(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = 2 * KIT_PI * fmod(u, 1),
                 r = v * s[0] * (1 + 0.28 * sin(6 * a + s[2]) + 0.2 * sin(11 * a));
    out->p[0] = r * cos(a);
    out->p[1] = s[1] * (1 - v) - 0.15 * s[1] * v * v * sin(6 * a + s[2]);
    out->p[2] = r * sin(a);
    out->n[0] = cos(a);
    out->n[1] = 0.6;
    out->n[2] = sin(a);
    kit_unit(out->n);
}

void land_fir_tree(kit_build *b, double height, int tiers)
{
    const float *was = b->albedo;
    const float green[3] = { was[0], was[1], was[2] };
    kit_frame before = kit_enter(b, b->at[0], b->at[1], b->at[2], b->turn, 1);
    kit_colour(b, 0.2, 0.14, 0.1);
    kit_place_at(b, 0, -0.05 * height, 0, 0);
    kit_cylinder(b, 0.02 * height, 0.6 * height, 5);
    memcpy(b->albedo, green, sizeof green);
    for (int k = 0; k < tiers; k++) {
        const double t = (double)k / tiers,
                     shape[3] = { height * (0.2 - 0.15 * t), height * 1.5 / tiers, kit_between(b, 0, 6) };
        kit_place_at(b, 0, height * (0.12 + 0.8 * t) - 0.3 * height / tiers, 0, kit_between(b, 0, 360));
        kit_patch(b, 14, 2, skirt, shape);
    }
    kit_leave(b, before);
}

typedef struct ribbed {
    limb along;
    int ribs;
} ribbed;

static void ribbed_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const ribbed *s = shape;
    const double round = v > 0.85 ? sqrt(fmax(0, 1 - pow((v - 0.85) / 0.15, 2))) : 1,
                 rib = 1 - 0.14 * (0.5 + 0.5 * cos(2 * KIT_PI * s->ribs * u));
    limb l = s->along;
    l.r0 *= rib * round;
    l.r1 *= rib * round;
    limb_surface(&l, u, v, out);
}

static void stem(kit_build *b, const double from[3], const double over[3], const double to[3], double radius, int ribs)
{
    const ribbed s = { { from, over, to, radius, 0.9 * radius }, ribs };
    const kit_rough r = { ribbed_surface, &s, 1, 1, 0, 0 };
    kit_patch(b, 4 * ribs, 14, land_rough_surface, &r);
}

void land_cactus(kit_build *b, double height)
{
    const double r = kit_between(b, 0.05, 0.075) * height, foot[3] = { 0, -0.05 * height, 0 },
                 middle[3] = { kit_between(b, -0.03, 0.03) * height, 0.5 * height, 0 }, top[3] = { 0, height, 0 };
    stem(b, foot, middle, top, r, 12);
    for (int k = 0, arms = kit_choose(b, 4); k < arms; k++) {
        const double a = kit_between(b, 0, 2 * KIT_PI), y = kit_between(b, 0.25, 0.5) * height,
                     out = kit_between(b, 2.2, 3.4) * r, end = y + kit_between(b, 0.18, 0.42) * height;
        const double from[3] = { 0.3 * r * cos(a), y, 0.3 * r * sin(a) },
                     over[3] = { 1.5 * out * cos(a), y, 1.5 * out * sin(a) },
                     to[3] = { out * cos(a), end, out * sin(a) };
        stem(b, from, over, to, 0.62 * r, 9);
    }
}

void land_prickly_pear(kit_build *b, double height)
{
    double foot[24][4] = { { 0 } }; /* place, turn of the pads */
    const int pads = 5 + kit_choose(b, 12);
    const double tall = 0.42 * height;
    foot[0][3] = kit_between(b, 0, 180);
    for (int k = 0; k < pads; k++) {
        const double by = k ? kit_between(b, 0.6, 0.95) : 1,
                     half[3] = { 0.35 * tall * by, 0.5 * tall * by, 0.06 * tall };
        const int on = k ? kit_choose(b, (k + 1) / 2) : 0;
        const double turn = foot[on][3] + (k ? kit_between(b, -50, 50) : 0),
                     lean = kit_between(b, -35, 35) * (k ? 1 : 0.2);
        const double up[3] = { 0, half[1], 0 };
        double off[3], x = k ? kit_between(b, -0.22, 0.22) * tall : 0;
        if (k) {
            const double c = cos(foot[on][3] * KIT_PI / 180), s = sin(foot[on][3] * KIT_PI / 180);
            foot[k][0] = foot[on][0] + c * x;
            foot[k][1] = foot[on][1] + 0.8 * tall;
            foot[k][2] = foot[on][2] - s * x;
        }
        foot[k][3] = turn;
        kit_place_tilted(b, 0, 0, 0, turn, lean);
        kit_rotate(b, up, off);
        for (int i = 0; i < 3; i++) b->at[i] = foot[k][i] + 0.9 * off[i];
        kit_cushion(b, half, 0.95, 8);
    }
}

/* a spire wound up, or a fan: thin, open */
static void whorl(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = 7 * KIT_PI * u, k = s[0] * exp(-2.6 * u), t = 2 * KIT_PI * fmod(v + 1, 1),
                 r = 0.55 * k + 0.45 * k * cos(t);
    out->n[0] = cos(t) * cos(a);
    out->n[1] = sin(t);
    out->n[2] = cos(t) * sin(a);
    out->p[0] = r * cos(a);
    out->p[1] = 0.45 * k * sin(t) + 1.9 * (s[0] - k);
    out->p[2] = r * sin(a);
}

static void fan(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = KIT_PI * (0.1 + 0.8 * u), r = s[0] * v * (1 + 0.03 * cos(60 * u));
    out->p[0] = r * cos(a);
    out->p[1] = s[0] * (0.45 * (1 - pow(2 * v - 1, 2)) * sin(KIT_PI * u) + 0.02 * cos(60 * u) * v);
    out->p[2] = r * sin(a);
    out->n[0] = 0;
    out->n[1] = 1;
    out->n[2] = 0;
}

void land_shell(kit_build *b, double size)
{
    const int way = kit_choose(b, 2);
    const kit_rough r = { way ? fan : whorl, &size, 1, 1, 0, 0 };
    if (way) kit_patch(b, 30, 8, land_rough_surface, &r);
    else kit_patch(b, 48, 8, land_rough_surface, &r);
}

/* ---- >>what was built -------------------------------------------------------------------------------------------- */

/* upright, of many widths, not quite flush */
static void boards(kit_build *b, double x0, double x1, double y0, double y1)
{
    for (double x = x0, wide; x < x1; x += wide) {
        const double out = kit_between(b, 0.10, 0.125);
        wide = fmin(kit_between(b, 0.14, 0.26), x1 - x);
        kit_box(b, x, y0, -out, x + wide - 0.008, y1, out);
    }
}

/* a frame that stands out on both sides, bars, dark panes */
static void window(kit_build *b, double x, double sill)
{
    const float wall[3] = { b->albedo[0], b->albedo[1], b->albedo[2] };
    kit_colour(b, 0.6, 0.58, 0.54);
    kit_box(b, x - 0.45, sill - 0.06, -0.19, x + 0.45, sill, 0.19);
    kit_box(b, x - 0.4, sill + 0.8, -0.16, x + 0.4, sill + 0.86, 0.16);
    for (int k = -1; k <= 1; k++) kit_box(b, x + 0.36 * k - 0.03, sill, -0.15, x + 0.36 * k + 0.03, sill + 0.8, 0.15);
    kit_box(b, x - 0.33, sill + 0.37, -0.149, x + 0.33, sill + 0.42, 0.149);
    kit_colour(b, 0.04, 0.05, 0.06);
    kit_box(b, x - 0.33, sill, -0.135, x + 0.33, sill + 0.8, 0.135);
    memcpy(b->albedo, wall, sizeof wall);
}

static void hut_walls(kit_build *b, double w, double d, double h, int logs)
{
    static const double side[4][3] = { { 0, -1, 0 }, { 0, 1, 0 }, { 1, 0, 90 }, { -1, 0, 90 } };
    for (int k = 0; k < 4; k++) {
        const double half = k < 2 ? 0.5 * w : 0.5 * d, off = k < 2 ? 0.5 * d : 0.5 * w;
        const double door = k ? -1 : 0.5;
        kit_place_at(b, side[k][0] * off, 0, side[k][1] * off, side[k][2]);
        for (double y = k < 2 ? -0.4 : -0.28; y < h && logs; y += 0.24) {
            const double log[2][3] = { { -half - 0.25, y, 0 }, { y < 1.9 && door > 0 ? -door : half + 0.25, y, 0 } },
                         rest[2][3] = { { door, y, 0 }, { half + 0.25, y, 0 } };
            kit_tube(b, log, 2, 0.125, 9);
            if (y < 1.9 && door > 0) kit_tube(b, rest, 2, 0.125, 9);
        }
        if (logs) continue;
        boards(b, -half, door > 0 ? -door : half - 0.13, -0.5, h);
        if (door > 0) {
            boards(b, door, half - 0.13, -0.5, h);
            boards(b, -door, door, 1.95, h);
        }
        if (k && 2 * half > 2.4) window(b, kit_between(b, -0.3, 0.3) * half, kit_between(b, 0.8, 1));
    }
}

void land_hut(kit_build *b, double width, double depth, double height)
{
    const double rise = kit_between(b, 0.3, 0.7) * depth, over = 0.4, x = 0.5 * width + over, z = 0.5 * depth + over;
    const double eave = height - 0.02, drop = over * rise / (0.5 * depth);
    const kit_frame before = kit_enter(b, b->at[0], b->at[1], b->at[2], b->turn, 1);
    hut_walls(b, width, depth, height, kit_odds(b, 0.3));
    kit_place_at(b, 0, 0, 0, 0);
    for (int k = -1; k <= 1; k += 2) {
        const double gable[3][3] = { { k * 0.5 * width, eave, -0.5 * depth },
                                     { k * 0.5 * width, eave, 0.5 * depth },
                                     { k * 0.5 * width, eave + rise, 0 } };
        kit_vertex v[3];
        for (int i = 0; i < 3; i++) {
            memcpy(v[i].p, gable[i], sizeof v[i].p);
            v[i].n[0] = k;
            v[i].n[1] = v[i].n[2] = 0;
        }
        kit_triangle(b, &v[0], &v[1], &v[2]);
    }
    kit_colour(b, kit_between(b, 0.15, 0.4), 0.2, 0.17);
    for (int k = -1; k <= 1; k += 2) {
        const double roof[4][3] = { { -x * k, eave - drop, z * k },
                                    { x * k, eave - drop, z * k },
                                    { x * k, eave + rise, 0 },
                                    { -x * k, eave + rise, 0 } };
        kit_quad(b, roof);
        for (double t = -x + 0.2; t < x; t += 0.45) { /* battens */
            const double from[3] = { t, eave - drop + 0.03, k * z }, to[3] = { t, eave + rise + 0.03, 0 };
            kit_cable(b, from, to, 0, 0.025, 4);
        }
    }
    if (kit_odds(b, 0.6)) { /* a chimney */
        kit_colour(b, 0.34, 0.26, 0.22);
        kit_bevelled(b, 0.3 * width, -0.5, -0.32 - 0.5 * depth, 0.3 * width + 0.6, height + rise + 0.5,
                     0.2 - 0.5 * depth, 0.03);
        kit_box(b, 0.3 * width - 0.06, height + rise + 0.5, -0.38 - 0.5 * depth, 0.3 * width + 0.66,
                height + rise + 0.6, 0.26 - 0.5 * depth);
    }
    kit_colour(b, 0.42, 0.31, 0.2);
    for (int k = 0; k < 24; k++) { /* logs against a gable */
        const double y = 0.09 + 0.17 * (k / 6), off = -0.4 + 0.19 * (k % 6) + 0.09 * (k / 6 % 2);
        const double log[2][3] = { { 0.5 * width + 0.3, y, off }, { 0.5 * width + kit_between(b, 0.75, 0.9), y, off } };
        kit_tube(b, log, 2, kit_between(b, 0.07, 0.09), 7);
    }
    kit_leave(b, before);
}

/* an open hull of one layer: u along, v from gunwale to gunwale */
static void hull(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, t = 2 * u - 1, a = KIT_PI * v, full = pow(fmax(0, 1 - pow(fabs(t), 2.2)), 0.7) + 0.01;
    out->p[0] = 0.5 * s[0] * (t + 0.05 * t * sin(a) * -1);
    out->p[1] = 0.16 * s[0] * (1 + 0.5 * t * t - sin(a) * (0.9 * pow(full, 0.3)));
    out->p[2] = 0.17 * s[0] * full * cos(a);
    out->n[0] = 0;
    out->n[1] = -sin(a);
    out->n[2] = cos(a);
}

void land_boat(kit_build *b, double length)
{
    const kit_rough skin = { hull, &length, 1, 1, 0, 0 };
    kit_patch(b, 32, 16, land_rough_surface, &skin);
    for (int k = -1; k <= 1; k++) {
        const double x = 0.22 * k * length, z = 0.145 * length * (k ? 0.9 : 1);
        kit_box(b, x - 0.04 * length, 0.11 * length, -z, x + 0.04 * length, 0.12 * length, z);
    }
    for (int side = -1; side <= 1; side += 2) {
        double rail[17][3];
        for (int k = 0; k <= 16; k++) {
            kit_vertex v;
            hull(&length, 0.02 + 0.06 * k, side > 0 ? 0 : 1, &v);
            memcpy(rail[k], v.p, sizeof rail[k]);
        }
        kit_tube(b, (const double(*)[3])rail, 17, 0.008 * length, 6);
    }
}

/* keel and ribs, half sunk */
void land_wreck(kit_build *b, double length)
{
    const double thick = 0.012 * length;
    for (int k = -7; k <= 7; k++)
        for (int side = -1; side <= 1; side += 2) {
            const double t = k / 8.0, wide = 0.2 * length * (1 - t * t), x = 0.5 * t * length,
                         tall = kit_between(b, 0.1, 0.34) * length;
            const double from[3] = { x, -0.03 * length, 0 }, over[3] = { x, -0.03 * length, side * 1.25 * wide },
                         to[3] = { x, tall, side * wide };
            if (kit_odds(b, 0.15)) continue;
            land_bent_limb(b, from, over, to, thick, 0.7 * thick, 6, 9);
        }
    const double stern[3] = { -0.5 * length, 0.02 * length, 0 }, middle[3] = { 0, -0.06 * length, 0 },
                 bow[3] = { 0.55 * length, 0.2 * length, 0 };
    land_bent_limb(b, stern, middle, bow, 1.4 * thick, 1.2 * thick, 8, 20);
}

void land_tent(kit_build *b, double width, double length, double height)
{
    const double w = 0.5 * width, l = 0.5 * length;
    const double back[3][3] = { { -l, 0, -w }, { -l, 0, w }, { -l, height, 0 } };
    kit_vertex v[3];
    for (int k = -1; k <= 1; k += 2) {
        const double cloth[4][3] = {
            { -l * k, 0.02, w * k }, { l * k, 0.02, w * k }, { l * k, height, 0 }, { -l * k, height, 0 }
        };
        const double pole[2][3] = { { k * (l - 0.03), -0.1, 0 }, { k * (l - 0.03), height + 0.06, 0 } };
        const double top[3] = { k * l, height, 0 }, peg[3] = { k * (l + 1), 0, 0.3 * k };
        kit_quad(b, cloth);
        kit_tube(b, pole, 2, 0.02, 6);
        kit_cable(b, top, peg, 0.03, 0.006, 4);
        for (int j = -1; j <= 1; j++) {
            const double eave[3] = { 0.9 * j * l, 0.3 * height, 0.7 * w * k },
                         end[3] = { 0.9 * j * l, 0, (w + 0.7) * k };
            kit_cable(b, eave, end, 0.02, 0.006, 4);
        }
    }
    for (int i = 0; i < 3; i++) {
        memcpy(v[i].p, back[i], sizeof v[i].p);
        v[i].n[0] = -1;
        v[i].n[1] = v[i].n[2] = 0;
    }
    kit_triangle(b, &v[0], &v[1], &v[2]);
}
