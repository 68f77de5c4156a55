/* works.c - columns, arches, vaults, roofs, stairs and rails of halls by seed. Declared in halls.h. */
#include "kit/scene/halls/halls.h"
#include <math.h>
#include <string.h>

void hall_paint(hall *h, int which)
{
    const double lighter = kit_between(h->b, 0.94, 1.06);
    double c[3];
    for (int i = 0; i < 3; i++) c[i] = fmin(0.9, lighter * (double)h->paint[which][i]);
    kit_colour(h->b, c[0], c[1], c[2]);
}

/* a point of the current place in the world */
static void in_world(const kit_build *b, const double in[3], double out[3])
{
    const kit_frame *f = &b->frame;
    double p[3];
    kit_rotate(b, in, p);
    for (int i = 0; i < 3; i++) p[i] += b->at[i];
    memcpy(out, p, sizeof p);
    if (!(f->scale > 0)) return;
    const double c = f->turn[0][0], s = f->turn[0][2];
    out[0] = f->scale * (c * p[0] + s * p[2]) + f->at[0];
    out[1] = f->scale * p[1] + f->at[1];
    out[2] = f->scale * (c * p[2] - s * p[0]) + f->at[2];
}

void hall_sight(hall *h, double x, double y, double z, double reach)
{
    const double in[3] = { x, y, z };
    double at[3];
    in_world(h->b, in, at);
    kit_add_sight(h->p, at[0], at[1], at[2], reach);
}

void hall_lamp(hall *h, double x, double y, double z)
{
    const double in[3] = { x, y, z };
    double at[3];
    in_world(h->b, in, at);
    kit_add_lamp(h->p, at[0], at[1], at[2]);
}

void hall_stand(hall *h, double x0, double z0, double x1, double z1, double ceiling)
{
    const double r[4] = { x0, z0, x1, z1 };
    memcpy(h->p->stand, r, sizeof r);
    h->p->ceiling = ceiling;
}

void hall_overview(hall *h, const double r[4], double high)
{
    const double least = fmin(r[2] - r[0], r[3] - r[1]), mid = 0.5 * (r[1] + r[3]);
    for (int k = 0; k < 4; k++) {
        const double x = r[0] + (r[2] - r[0]) * (k + 0.5) / 4;
        hall_sight(h, x, 0.1 * high + 0.25 * high * (k & 1), mid, 0.22 * least + 0.5 * (k & 2));
    }
}

void hall_bar(kit_build *b, const double from[3], const double to[3], double wide, double deep)
{
    double way[3], side[3], up[3], c[8][3];
    for (int i = 0; i < 3; i++) way[i] = to[i] - from[i];
    if (!kit_unit(way)) return;
    const double reference[3] = { 0, fabs(way[1]) > 0.99 ? 0 : 1, fabs(way[1]) > 0.99 ? 1 : 0 };
    kit_cross(way, reference, side);
    kit_unit(side);
    kit_cross(side, way, up);
    for (int k = 0; k < 8; k++)
        for (int i = 0; i < 3; i++)
            c[k][i] = (k & 4 ? to : from)[i] + (k & 1 ? 0.5 : -0.5) * wide * side[i]
                    + (k & 2 ? 0.5 : -0.5) * deep * up[i];
    static const int faces[6][4] = { { 0, 2, 3, 1 }, { 4, 5, 7, 6 }, { 0, 4, 6, 2 },
                                     { 1, 3, 7, 5 }, { 0, 1, 5, 4 }, { 2, 6, 7, 3 } };
    for (int f = 0; f < 6; f++) {
        double q[4][3];
        for (int k = 0; k < 4; k++) memcpy(q[k], c[faces[f][3 - k]], sizeof q[k]);
        kit_quad(b, (const double(*)[3])q);
    }
}

/* ---- >>columns --------------------------------------------------------------------------------------------------- */

/* radius, height, depth of the flutes, how many; turns: a rope's */
static void shaft_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = 2 * KIT_PI * fmod(u, 1), w = s[3] * a + s[4] * v, thin = 1 - 0.14 * v * v;
    const double wave = s[4] > 0 ? cos(w) : -fabs(sin(0.5 * w)) * 2, r = s[0] * thin * (1 + s[2] * wave);
    const double slope = s[4] > 0 ? -s[3] * sin(w) : -s[3] * cos(0.5 * w) * (sin(0.5 * w) < 0 ? -1 : 1);
    const double dr = s[0] * thin * s[2] * slope, up = -s[0] * thin * s[2] * s[4] * (s[4] > 0 ? sin(w) : 0) / s[1];
    out->p[0] = r * cos(a);
    out->p[1] = s[1] * v;
    out->p[2] = r * sin(a);
    out->n[0] = r * cos(a) + dr * sin(a);
    out->n[1] = -r * up;
    out->n[2] = r * sin(a) - dr * cos(a);
    kit_unit(out->n);
}

/* square block, base, neck and capital about a shaft from low to high */
static void order(hall *h, double r, double low, double high, double height)
{
    kit_build *b = h->b;
    const double cap = height - high, t = cap / 4;
    const kit_moulding base[] = { { 1.3 * r, 0.3 * r, 1.22 * r, low - 0.25 * r, 0.16 * r },
                                  { 1.15 * r, low - 0.25 * r, 1.02 * r, low, -0.05 * r } };
    const kit_moulding capital[] = { { 0.9 * r, high, 0.9 * r, high + t, 0.03 * r },
                                     { 0.92 * r, high + t, 1.3 * r, height - t, 0.13 * r },
                                     { 1.3 * r, height - t, 1.3 * r, height - 0.9 * t, 0 } };
    kit_box(b, -1.4 * r, 0, -1.4 * r, 1.4 * r, 0.3 * r, 1.4 * r);
    kit_turned(b, base, 2, 16);
    kit_turned(b, capital, 3, 16);
    kit_bevelled(b, -1.4 * r, height - t, -1.4 * r, 1.4 * r, height, 1.4 * r, 0.2 * t);
}

/* two rings of leaves that curl outwards */
static void leaves(hall *h, double r, double high, double height)
{
    const double tall = height - high;
    for (int ring = 0; ring < 2; ring++)
        for (int k = 0; k < 8; k++) {
            const double turn = 45 * (k + 0.5 * ring), a = turn * KIT_PI / 180, from = r * (0.95 + 0.05 * ring);
            kit_place_tilted(h->b, from * sin(a), high + 0.08 * tall + 0.25 * ring * tall, from * cos(a), turn, -88);
            kit_leaf(h->b, 0.75 * r, 0.62 * tall, 1.7, 6, 0);
        }
    kit_place_at(h->b, 0, 0, 0, 0);
}

static void cluster(hall *h, double r, double height)
{
    kit_build *b = h->b;
    const int shafts = 4 + 4 * (r > 0.5);
    const kit_moulding part[] = { { 0.46 * r, 0.4 * r, 0.3 * r, 0.7 * r, 0 },
                                  { 0.27 * r, 0.7 * r, 0.27 * r, height - 1.1 * r, 0 },
                                  { 0.27 * r, height - 1.1 * r, 0.4 * r, height - 0.35 * r, 0 } };
    const kit_moulding core[] = { { 0.72 * r, 0.3 * r, 0.72 * r, height - 0.35 * r, 0 } };
    kit_turned(b, core, 1, 16);
    for (int k = 0; k < shafts; k++) {
        const double a = 2 * KIT_PI * (k + 0.5) / shafts;
        kit_place_at(b, 0.78 * r * cos(a), 0, 0.78 * r * sin(a), 0);
        kit_turned(b, part, 3, 12);
    }
    kit_place_at(b, 0, 0, 0, 22.5);
    kit_cylinder(b, 1.45 * r, 0.42 * r, 8);
    kit_place_at(b, 0, height - 0.36 * r, 0, 22.5);
    kit_cylinder(b, 1.42 * r, 0.36 * r, 8);
    kit_place_at(b, 0, 0, 0, 0);
}

static void iron(hall *h, double r, double height)
{
    kit_build *b = h->b;
    const double collar[2] = { 0.62 * r, 0.16 * r };
    const kit_moulding part[] = { { 1.1 * r, 0, 1.1 * r, 0.5 * r, 0 },
                                  { 1.1 * r, 0.5 * r, 0.6 * r, 1.3 * r, -0.1 * r },
                                  { 0.6 * r, 1.3 * r, 0.5 * r, height - 0.1, 0 } };
    kit_turned(b, part, 3, 12);
    for (int k = 0; k < 3; k++) {
        kit_place_at(b, 0, k < 2 ? 1.6 * r + 0.25 * height * k : height - 5 * r, 0, 0);
        kit_patch(b, 14, 7, kit_torus_surface, collar);
    }
    for (int k = 0; k < 4; k++) {
        double at[7][3];
        for (int i = 0; i < 7; i++) {
            const double a = 0.5 * KIT_PI * i / 6;
            at[i][0] = 0.4 * r + 3.2 * r * (1 - cos(a));
            at[i][1] = height - 4 * r + 3.9 * r * sin(a);
            at[i][2] = 0;
        }
        kit_place_at(b, 0, 0, 0, 90 * k);
        kit_tube(b, (const double(*)[3])at, 7, 0.14 * r, 6);
    }
    kit_place_at(b, 0, 0, 0, 0);
    kit_box(b, -r, height - 0.1, -r, r, height, r);
}

static void pier(hall *h, double r, double height)
{
    kit_build *b = h->b;
    kit_bevelled(b, -1.35 * r, 0, -1.35 * r, 1.35 * r, 0.7 * r, 1.35 * r, 0.08 * r);
    kit_bevelled(b, -r, 0.6 * r, -r, r, height - 0.4 * r, r, 0.1 * r);
    for (int k = 0; k < 4 && h->ribs; k++) { /* raised fields */
        kit_place_at(b, 0, 0, 0, 90 * k);
        kit_bevelled(b, -0.6 * r, 1.1 * r, 0.9 * r, 0.6 * r, height - 1.2 * r, 1.06 * r, 0.04 * r);
    }
    kit_place_at(b, 0, 0, 0, 0);
    kit_box(b, -1.15 * r, height - 0.6 * r, -1.15 * r, 1.15 * r, height - 0.32 * r, 1.15 * r);
    kit_bevelled(b, -1.38 * r, height - 0.32 * r, -1.38 * r, 1.38 * r, height, 1.38 * r, 0.08 * r);
}

void hall_column(hall *h, int kind, double r, double height)
{
    kit_build *b = h->b;
    const double low = r, high = height - (kind == HALL_LEAFED ? 2.4 : 1.1) * r;
    const double flutes[] = { r, high - low, kind == HALL_TWISTED ? 0.1 : 0.045, kind == HALL_TWISTED ? 3 : 18,
                              kind == HALL_TWISTED ? 5 * KIT_PI : 0 };
    const kit_moulding shaft[] = { { r, low, 0.88 * r, high, 0.03 * r } };
    const kit_moulding plain[] = { { r, 0, r, height - 1.2 * r, 0 },
                                   { r, height - 1.2 * r, 1.9 * r, height - 0.15 * r, -0.2 * r },
                                   { 1.9 * r, height - 0.15 * r, 1.9 * r, height, 0 },
                                   { 1.9 * r, height, 0, height, 0 } };
    if (kind == HALL_PIER) pier(h, r, height);
    else if (kind == HALL_CLUSTER) cluster(h, r, height);
    else if (kind == HALL_IRON) iron(h, 0.6 * r, height);
    else if (kind == HALL_PLAIN) kit_turned(b, plain, 4, 24);
    else if (kind == HALL_EIGHT) {
        order(h, r, low, high, height);
        kit_place_at(b, 0, low, 0, 22.5);
        for (int k = 0; k < 8; k++) {
            const double a = KIT_PI * k / 4, e = KIT_PI * (k + 1) / 4, t = height - 2.1 * r;
            const double q[4][3] = { { r * cos(e), 0, r * sin(e) },
                                     { r * cos(a), 0, r * sin(a) },
                                     { 0.9 * r * cos(a), t, 0.9 * r * sin(a) },
                                     { 0.9 * r * cos(e), t, 0.9 * r * sin(e) } };
            kit_quad(b, q);
        }
    } else {
        order(h, r, low, high, height);
        if (kind == HALL_LEAFED) leaves(h, r, high, height);
        kit_place_at(b, 0, kind == HALL_FLUTED || kind == HALL_TWISTED ? low : 0, 0, 0);
        if (kind == HALL_FLUTED) kit_patch(b, 72, 4, shaft_surface, flutes);
        else if (kind == HALL_TWISTED) kit_patch(b, 30, 40, shaft_surface, flutes);
        else kit_turned(b, shaft, 1, 24);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>arches ---------------------------------------------------------------------------------------------------- */

double hall_arch(int pointed, double q)
{
    const double k = pointed ? 0.6 : 0, r = 1 + k, a = fmin(1, fabs(q)) + k;
    return sqrt(fmax(0, r * r - a * a)) / sqrt(r * r - k * k);
}

/* corners in x and y, counter-clockwise seen from the front */
static void face(kit_build *b, double x0, double y0, double x1, double y1, double x2, double y2, double x3, double y3,
                 double z, int back)
{
    const double c[4][3] = { { x0, y0, z }, { x1, y1, z }, { x2, y2, z }, { x3, y3, z } };
    double turned[4][3];
    for (int k = 0; k < 4; k++) memcpy(turned[k], c[back ? 3 - k : k], sizeof turned[k]);
    kit_quad(b, (const double(*)[3])turned);
}

/* the k-th of the cells' corners along the arch, wider by so much */
static void on_arch(const hall_panel *p, int k, double wider, double out[2])
{
    const double q = sin(KIT_PI * ((double)k / p->cells - 0.5));
    out[0] = (p->half + wider) * q;
    out[1] = p->spring + (p->rise + wider) * hall_arch(p->pointed, q);
}

static void reveal_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const hall_panel *p = shape;
    double at[2], before[2], after[2];
    hall_panel fine = *p;
    const int k = (int)lround(u * p->cells);
    on_arch(p, k, 0, at);
    fine.cells = 16 * p->cells;
    on_arch(&fine, 16 * k - (k > 0), 0, before);
    on_arch(&fine, 16 * k + (k < p->cells), 0, after);
    out->p[0] = at[0];
    out->p[1] = at[1];
    out->p[2] = p->thick * (v - 0.5);
    out->n[0] = after[1] - before[1];
    out->n[1] = before[0] - after[0];
    out->n[2] = 0;
    kit_unit(out->n);
}

static void reveal(kit_build *b, const hall_panel *p)
{
    const double h = p->half, z = 0.5 * p->thick;
    kit_patch(b, p->cells, 1, reveal_surface, p);
    if (p->spring > p->sill + 1e-6) {
        const double left[4][3] = {
            { -h, p->sill, z }, { -h, p->sill, -z }, { -h, p->spring, -z }, { -h, p->spring, z }
        };
        const double right[4][3] = { { h, p->sill, -z }, { h, p->sill, z }, { h, p->spring, z }, { h, p->spring, -z } };
        kit_quad(b, left);
        kit_quad(b, right);
    }
    if (p->sill > 0) kit_level(b, -h, -z, h, z, p->sill);
}

void hall_wall(hall *h, const hall_panel *p)
{
    kit_build *b = h->b;
    const double w = 0.5 * p->width, o = p->half, t = p->height;
    for (int back = 0; back <= p->back; back++) {
        const double z = (back ? -0.5 : 0.5) * p->thick;
        if (!(o > 0)) {
            face(b, -w, 0, w, 0, w, t, -w, t, z, back);
            continue;
        }
        face(b, -w, 0, -o, 0, -o, t, -w, t, z, back);
        face(b, o, 0, w, 0, w, t, o, t, z, back);
        if (p->sill > 0) face(b, -o, 0, o, 0, o, p->sill, -o, p->sill, z, back);
        for (int k = 0; k < p->cells; k++) {
            double a[2], e[2];
            on_arch(p, k, 0, a);
            on_arch(p, k + 1, 0, e);
            face(b, a[0], a[1], e[0], e[1], e[0], t, a[0], t, z, back);
        }
    }
    if (o > 0) reveal(b, p);
    for (int side = -1; side < 2 && p->back && o > 0; side += 2) { /* what rests on capitals, seen from below */
        const double x0 = side < 0 ? -w : o, x1 = side < 0 ? -o : w, z = 0.5 * p->thick;
        const double under[4][3] = { { x0, 0, -z }, { x1, 0, -z }, { x1, 0, z }, { x0, 0, z } };
        kit_quad(b, under);
    }
}

void hall_archivolt(hall *h, const hall_panel *p, double wide, double proud)
{
    kit_build *b = h->b;
    const double z = 0.5 * p->thick, f = z + proud;
    for (int k = 0; k < p->cells; k++) {
        double in[2][2], out[2][2];
        for (int e = 0; e < 2; e++) {
            on_arch(p, k + e, 0, in[e]);
            on_arch(p, k + e, wide, out[e]);
        }
        face(b, in[0][0], in[0][1], in[1][0], in[1][1], out[1][0], out[1][1], out[0][0], out[0][1], f, 0);
        const double over[4][3] = { { out[0][0], out[0][1], f },
                                    { out[1][0], out[1][1], f },
                                    { out[1][0], out[1][1], z },
                                    { out[0][0], out[0][1], z } };
        const double under[4][3] = {
            { in[0][0], in[0][1], z }, { in[1][0], in[1][1], z }, { in[1][0], in[1][1], f }, { in[0][0], in[0][1], f }
        };
        kit_quad(b, over);
        kit_quad(b, under);
    }
    const double top = p->spring + p->rise;
    kit_bevelled(b, -0.5 * wide, top - 0.15 * wide, z - 0.02, 0.5 * wide, top + 1.4 * wide, f + 0.6 * proud,
                 0.1 * wide);
}

void hall_glaze(hall *h, const hall_panel *p, int upright, int across)
{
    kit_build *b = h->b;
    const double z = -0.45 * p->thick, o = p->half;
    hall_paint(h, HALL_GLASS);
    for (int k = 0; k < p->cells; k++) {
        double a[2], e[2];
        on_arch(p, k, 0, a);
        on_arch(p, k + 1, 0, e);
        face(b, a[0], p->sill, e[0], p->sill, e[0], e[1], a[0], a[1], z, 0);
    }
    hall_paint(h, HALL_METAL);
    for (int k = 1; k < upright; k++) {
        const double q = 2.0 * k / upright - 1, from[3] = { o * q, p->sill, z + 0.03 },
                     to[3] = { o * q, p->spring + p->rise * hall_arch(p->pointed, q), z + 0.03 };
        hall_bar(b, from, to, 0.05, 0.06);
    }
    for (int k = 0; k <= across; k++) {
        const double y = p->sill + (p->spring - p->sill) * k / across;
        const double from[3] = { -o, y, z + 0.025 }, to[3] = { o, y, z + 0.025 };
        hall_bar(b, from, to, 0.045, 0.04);
    }
}
