/* exhibits.c - what stands around figures: cloth, plinths, tables, books, bottles, lamps, crates. Declared in
   scans.h. */
#include "kit/scene/scans/scans.h"
#include <math.h>
#include <string.h>

/* ---- >>cloth --------------------------------------------------------------------------------------------------- */

typedef struct drape {
    double wide, high, side, folds, deep, phase;
} drape;

static void drape_point(const drape *d, double u, double v, double p[3])
{
    const double a = 2 * KIT_PI * fmod(u, 1), square = 1 / fmax(fabs(cos(a)), fabs(sin(a)));
    const double s = v * d->side * (0.6 + 0.4 * square), fallen = fmax(0, s - 0.8 * d->wide), round = 0.25 * d->wide;
    const double drop = sqrt(fallen * fallen + round * round) - round, grown = fmin(1, drop / (0.6 * d->high));
    const double wave = sin(d->folds * a + d->phase) + 0.5 * sin((d->folds + 3) * a - 2 * d->phase + 2 * v);
    const double oval = 1 + 0.16 * cos(2 * a + d->phase) + 0.08 * cos(4 * a - d->phase);
    double y = d->high - drop
             + 0.05 * d->wide * kit_noise(7, 3 * s * cos(a) / d->wide, d->phase, 3 * s * sin(a) / d->wide),
           r = oval * (s - fallen) + (fallen - drop) + 0.14 * drop + grown * d->deep * (1 + wave);
    if (y < 0.012) {
        const double over = 0.012 - y, lie = fmin(1, over / (0.3 * d->high));
        r += 0.9 * over;
        y = 0.004 + 0.008 * (1 - lie) + 0.25 * d->deep * fmin(1, 8 * over) * (1 + wave);
    }
    p[0] = r * cos(a);
    p[1] = y;
    p[2] = r * sin(a);
}

/* a normal from differences */
static void drape_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double e = 2e-3, w = fmin(fmax(v, 0.01), 1 - e);
    double p[4][3], du[3], dv[3];
    drape_point(shape, u, v, out->p);
    drape_point(shape, u + 1 - e, w, p[0]);
    drape_point(shape, u + 1 + e, w, p[1]);
    drape_point(shape, u, w - e, p[2]);
    drape_point(shape, u, w + e, p[3]);
    for (int i = 0; i < 3; i++) {
        du[i] = p[1][i] - p[0][i];
        dv[i] = p[3][i] - p[2][i];
    }
    kit_cross(dv, du, out->n);
    if (!kit_unit(out->n)) {
        out->n[0] = out->n[2] = 0;
        out->n[1] = 1;
    }
    for (int i = 0; i < 3 && out->n[1] < 0 && v < 0.05; i++) out->n[i] = -out->n[i];
}

void scan_drape(kit_build *b, double wide, double high, double side)
{
    const drape d = {
        wide, high, side, floor(kit_between(b, 5, 12)), kit_between(b, 0.08, 0.26) * wide, kit_between(b, 0, 6)
    };
    kit_patch(b, 120, 44, drape_surface, &d);
}

/* [0] width, [1] height, [2] out, [3] the bend's radius, [4] waves */
static void sweep_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, arc = 0.5 * KIT_PI * s[3], down = s[1] - s[3], at = v * (down + arc + s[2]);
    const double wave = s[4] * sin(14 * u) * (1 - v);
    const double t = fmax(0, fmin(arc, at - down)) / s[3];
    out->p[0] = s[0] * (u - 0.5);
    out->p[1] = fmax(0, s[3] * (1 - sin(t))) + (at < down ? down - at : 0) + 0.004;
    out->p[2] = s[3] * (1 - cos(t)) + fmax(0, at - down - arc) + wave;
    out->n[0] = -14 * s[4] * cos(14 * u) * (1 - v) / s[0];
    out->n[1] = sin(t);
    out->n[2] = cos(t);
    kit_unit(out->n);
}

void scan_backdrop(kit_build *b, double wide, double high, double out)
{
    const double shape[5] = { wide, high, out, fmin(0.9, 0.4 * high), kit_odds(b, 0.5) ? 0 : 0.03 };
    kit_patch(b, shape[4] > 0 ? 60 : 2, 40, sweep_surface, shape);
    kit_colour(b, 0.12, 0.12, 0.13);
    for (int s = -1; s <= 1; s += 2) {
        const double x = s * (0.5 * wide + 0.08), pole[2][3] = { { x, 0.02, -0.04 }, { x, high + 0.08, -0.04 } };
        kit_tube(b, pole, 2, 0.018, 12);
        for (int k = 0; k < 3; k++) {
            const double a = 2.1 * k,
                         leg[2][3] = { { x, 0.4, -0.04 }, { x + 0.4 * cos(a), 0.01, -0.04 + 0.4 * sin(a) } };
            kit_tube(b, leg, 2, 0.01, 8);
        }
    }
    const double bar[2][3] = { { -0.5 * wide - 0.1, high + 0.03, -0.04 }, { 0.5 * wide + 0.1, high + 0.03, -0.04 } };
    kit_tube(b, bar, 2, 0.025, 14);
}

/* ---- >>furniture ----------------------------------------------------------------------------------------------- */

void scan_plinth(kit_build *b, double wide, double high)
{
    const int kind = kit_choose(b, 4);
    const double h = 0.5 * wide;
    if (kind == 0) kit_bevelled(b, -h, 0, -h, h, high, h, 0.008);
    if (kind == 1) {
        kit_bevelled(b, -h, 0, -h, h, 0.12 * high, h, 0.01);
        kit_box(b, -0.84 * h, 0.12 * high, -0.84 * h, 0.84 * h, 0.88 * high, 0.84 * h);
        kit_bevelled(b, -h, 0.88 * high, -h, h, high, h, 0.012);
    }
    if (kind == 2) kit_cylinder(b, h, high, 48);
    if (kind == 3) {
        const kit_moulding profile[] = { { 0, 0, h, 0, 0 },
                                         { h, 0, h, 0.1 * high, 0 },
                                         { h, 0.1 * high, 0.75 * h, 0.2 * high, -0.02 },
                                         { 0.75 * h, 0.2 * high, 0.7 * h, 0.82 * high, 0.01 },
                                         { 0.7 * h, 0.82 * high, h, 0.9 * high, -0.03 },
                                         { h, 0.9 * high, h, high, 0 },
                                         { h, high, 0, high, 0 } };
        kit_turned(b, profile, 7, 40);
    }
}

void scan_table(kit_build *b, double wide, double deep, double high)
{
    const double x = 0.5 * wide, z = 0.5 * deep;
    const int trestle = kit_odds(b, 0.35);
    kit_bevelled(b, -x, high - 0.04, -z, x, high, z, 0.006);
    for (int k = 0; k < 4; k++) {
        const double sx = k & 1 ? 1 : -1, sz = k & 2 ? 1 : -1;
        const double leg[2][3] = { { sx * (x - 0.1), 0.0, sz * (z - 0.06) },
                                   { sx * (x - 0.1), high - 0.06, sz * (trestle ? 0.1 : z - 0.06) } };
        if (trestle) kit_tube(b, leg, 2, 0.022, 8);
        else kit_box(b, leg[0][0] - 0.03, 0, leg[0][2] - 0.03, leg[0][0] + 0.03, high - 0.04, leg[0][2] + 0.03);
    }
    kit_box(b, -x + 0.13, high - 0.12, -0.02, x - 0.13, high - 0.041, 0.02);
}

void scan_bench(kit_build *b, double wide)
{
    kit_bevelled(b, -0.5 * wide, 0.4, -0.22, 0.5 * wide, 0.46, 0.22, 0.01);
    for (int s = -1; s <= 1; s += 2) kit_box(b, s * 0.4 * wide - 0.03, 0, -0.18, s * 0.4 * wide + 0.03, 0.4, 0.18);
}

void scan_picture(kit_build *b, double wide, double high, double middle)
{
    const double x = 0.5 * wide, y0 = middle - 0.5 * high, y1 = middle + 0.5 * high, f = kit_between(b, 0.03, 0.1);
    static const float frames[][3] = { { 0.5f, 0.36f, 0.14f }, { 0.12f, 0.09f, 0.07f }, { 0.75f, 0.73f, 0.7f } },
                       canvases[][3] = {
                           { 0.35f, 0.25f, 0.16f }, { 0.2f, 0.3f, 0.4f }, { 0.6f, 0.5f, 0.3f }, { 0.6f, 0.2f, 0.15f }
                       };
    KIT_TINT(b, frames, 0.2);
    kit_bevelled(b, -x, y0, 0.005, x, y0 + f, 0.055, 0.012);
    kit_bevelled(b, -x, y1 - f, 0.005, x, y1, 0.055, 0.012);
    kit_bevelled(b, -x, y0 + f, 0.005, -x + f, y1 - f, 0.055, 0.012);
    kit_bevelled(b, x - f, y0 + f, 0.005, x, y1 - f, 0.055, 0.012);
    KIT_TINT(b, canvases, 0.4);
    kit_box(b, -x + f, y0 + f, 0.008, x - f, y1 - f, 0.02);
}

void scan_gallery_wall(kit_build *b, double x0, double z0, double x1, double z1, double high, int pilasters)
{
    const double long_ = hypot(x1 - x0, z1 - z0), turn = -180 / KIT_PI * atan2(z1 - z0, x1 - x0);
    const kit_frame before = kit_enter(b, x0, 0, z0, turn, 1);
    kit_box(b, -0.2, 0, 0, long_ + 0.2, high, 0.25);
    kit_box(b, 0, 0, -0.02, long_, 0.14, -0.0005);
    for (int k = 0; k < pilasters; k++) {
        const double x = long_ * (k + 0.5) / pilasters;
        kit_box(b, x - 0.2, 0.14, -0.08, x + 0.2, high - 0.3, -0.0005);
        kit_bevelled(b, x - 0.25, 0, -0.12, x + 0.25, 0.139, -0.021, 0.01);
        kit_bevelled(b, x - 0.25, high - 0.299, -0.13, x + 0.25, high - 0.18, -0.0005, 0.015);
    }
    if (pilasters) kit_bevelled(b, 0, high - 0.179, -0.16, long_, high - 0.02, -0.0005, 0.03);
    kit_leave(b, before);
}

void scan_barrier(kit_build *b, double wide, double deep)
{
    const double at[5][3] = { { -wide, 0.82, -deep },
                              { -wide, 0.82, deep },
                              { 0, 0.82, deep + 0.1 },
                              { wide, 0.82, deep },
                              { wide, 0.82, -deep } };
    kit_colour(b, 0.62, 0.5, 0.26);
    for (int k = 0; k < 5; k++) {
        kit_place_at(b, at[k][0], 0, at[k][2], 0);
        kit_cylinder(b, 0.14, 0.02, 24);
        kit_place_at(b, at[k][0], 0.02, at[k][2], 0);
        kit_cylinder(b, 0.02, 0.88, 14);
    }
    kit_place_at(b, 0, 0, 0, 0);
    kit_colour(b, 0.45, 0.06, 0.08);
    for (int k = 0; k < 4; k++) kit_cable(b, at[k], at[k + 1], 0.18, 0.016, 8);
}

void scan_crate(kit_build *b, double wide, double high)
{
    const double h = 0.5 * wide;
    const int slats = 2 + kit_choose(b, 4);
    for (int side = 0; side < 4; side++) {
        kit_place_at(b, 0, 0, 0, 90 * side);
        kit_box(b, -h, 0, h - 0.06, -h + 0.04, high, h - 0.021);
        for (int k = 0; k < slats; k++)
            kit_box(b, -h - 0.001, high * (k + 0.06) / slats, h - 0.02, h - 0.021, high * (k + 0.9) / slats, h);
    }
    kit_place_at(b, 0, 0, 0, 0);
    kit_box(b, -h + 0.045, 0.01, -h + 0.045, h - 0.045, 0.03, h - 0.045);
}

void scan_pallet(kit_build *b)
{
    for (int k = 0; k < 3; k++) kit_box(b, -0.6, 0, -0.4 + 0.36 * k, 0.6, 0.1, -0.32 + 0.36 * k);
    for (int k = 0; k < 8; k++) kit_box(b, -0.6 + 0.158 * k, 0.1, -0.42, -0.5 + 0.158 * k, 0.125, 0.42);
}

/* ---- >>clutter ------------------------------------------------------------------------------------------------- */

static const float covers[][3] = { { 0.45f, 0.1f, 0.09f }, { 0.1f, 0.2f, 0.4f },  { 0.12f, 0.3f, 0.16f },
                                   { 0.6f, 0.5f, 0.3f },   { 0.2f, 0.14f, 0.1f }, { 0.7f, 0.68f, 0.62f } };

void scan_books(kit_build *b)
{
    double y = KIT_GAP;
    for (int k = 0, count = 2 + kit_choose(b, 6); k < count; k++) {
        const double w = kit_between(b, 0.07, 0.12), d = kit_between(b, 0.1, 0.16), h = kit_between(b, 0.012, 0.045);
        kit_place_at(b, kit_between(b, -0.01, 0.01), y, kit_between(b, -0.01, 0.01), kit_between(b, -25, 25));
        KIT_TINT(b, covers, 0.3);
        kit_box(b, -w, 0, -d, w, 0.003, d);
        kit_box(b, -w, h - 0.003, -d, w, h, d);
        kit_box(b, -w - 0.003, 0, -d, -w, h, d);
        kit_colour(b, 0.78, 0.74, 0.64);
        kit_box(b, -w, 0.003, -d + 0.005, w - 0.006, h - 0.003, d - 0.005);
        y += h + 0.0005;
    }
}

void scan_bottle(kit_build *b, double high)
{
    static const float glass[][3] = {
        { 0.08f, 0.2f, 0.1f }, { 0.3f, 0.14f, 0.05f }, { 0.6f, 0.7f, 0.72f }, { 0.75f, 0.72f, 0.66f }
    };
    const double r = high * kit_between(b, 0.12, 0.24), neck = r * kit_between(b, 0.3, 0.5),
                 s = kit_between(b, 0.5, 0.7) * high;
    const kit_moulding profile[] = { { 0, 0, r, 0, 0 },
                                     { r, 0, r, s, 0 },
                                     { r, s, neck, 0.78 * high, 0.15 * r },
                                     { neck, 0.78 * high, neck, 0.95 * high, 0 },
                                     { neck, 0.95 * high, 1.25 * neck, 0.95 * high, 0 },
                                     { 1.25 * neck, 0.95 * high, 1.2 * neck, high, 0 },
                                     { 1.2 * neck, high, 0, high, 0 } };
    KIT_TINT(b, glass, 0.3);
    kit_turned(b, profile, 7, 32);
}

/* a jar without thickness, brushes in it */
void scan_brushes(kit_build *b)
{
    const double r = kit_between(b, 0.035, 0.06), h = kit_between(b, 0.09, 0.15);
    const kit_moulding jar[] = { { 0, 0.004, r, 0.002, 0 }, { r, 0.002, 0.92 * r, h, 0.006 } };
    KIT_TINT(b, covers, 0.3);
    kit_turned(b, jar, 2, 32);
    for (int k = 0, count = 5 + kit_choose(b, 8); k < count; k++) {
        const double a = kit_between(b, 0, 2 * KIT_PI), l = kit_between(b, 0.2, 0.34), lean = kit_between(b, 0.1, 0.3);
        const double foot[3] = { -0.6 * r * cos(a), 0.01, -0.6 * r * sin(a) },
                     way[3] = { sin(lean) * cos(a), cos(lean), sin(lean) * sin(a) };
        double at[3][3];
        for (int i = 0; i < 3; i++) {
            at[0][i] = foot[i];
            at[1][i] = foot[i] + l * way[i];
            at[2][i] = foot[i] + (l + 0.035) * way[i];
        }
        KIT_TINT(b, covers, 0.3);
        kit_tube(b, (const double(*)[3])at, 2, 0.0035, 7);
        kit_colour(b, 0.25, 0.17, 0.1);
        kit_tube(b, (const double(*)[3])(at + 1), 2, 0.007, 8);
    }
}

void scan_papers(kit_build *b, int count)
{
    for (int k = 0; k < count; k++) {
        kit_place_at(b, kit_between(b, -0.15, 0.15), 0.002 + 0.003 * k, kit_between(b, -0.15, 0.15),
                     kit_between(b, 0, 360));
        kit_colour(b, kit_between(b, 0.65, 0.85), kit_between(b, 0.65, 0.8), kit_between(b, 0.55, 0.78));
        kit_leaf(b, 0.21, 0.297, -kit_between(b, 0.02, 0.5), 8, 0);
    }
}

/* ---- >>light stands -------------------------------------------------------------------------------------------- */

void scan_tripod(kit_build *b, double high)
{
    const double pole[2][3] = { { 0, 0.35 * high, 0 }, { 0, high, 0 } };
    kit_colour(b, 0.1, 0.1, 0.11);
    kit_tube(b, pole, 2, 0.014, 12);
    for (int k = 0; k < 3; k++) {
        const double a = 2 * KIT_PI * k / 3 + 0.4, out = 0.34 * high;
        const double leg[2][3] = { { 0, 0.6 * high, 0 }, { out * cos(a), 0.012, out * sin(a) } };
        kit_tube(b, leg, 2, 0.011, 8);
    }
    kit_box(b, -0.07, high, -0.05, 0.07, high + 0.1, 0.05); /* a camera */
    kit_place_tilted(b, 0, high + 0.05, 0.05, 0, 90);
    kit_cylinder(b, 0.035, 0.09, 20);
    kit_place_at(b, 0, 0, 0, 0);
}

/* looks along +z, downwards */
void scan_softbox(kit_build *b, double high)
{
    const double pole[2][3] = { { 0, 0.01, 0 }, { 0, high, 0 } }, s = kit_between(b, 0.25, 0.45), back = 0.12;
    kit_colour(b, 0.1, 0.1, 0.11);
    kit_tube(b, pole, 2, 0.013, 10);
    for (int k = 0; k < 3; k++) {
        const double a = 2 * KIT_PI * k / 3, leg[2][3] = { { 0, 0.45, 0 }, { 0.4 * cos(a), 0.01, 0.4 * sin(a) } };
        kit_tube(b, leg, 2, 0.009, 8);
    }
    kit_place_tilted(b, 0, high, 0, 0, 20);
    kit_box(b, -0.06, -0.06, -0.2, 0.06, 0.06, 0.0);
    for (int side = 0; side < 4; side++) { /* an open hood */
        static const double x[5] = { -1, 1, 1, -1, -1 }, y[5] = { -1, -1, 1, 1, -1 };
        const double q[4][3] = { { 0.06 * x[side], 0.06 * y[side], 0.001 },
                                 { 0.06 * x[side + 1], 0.06 * y[side + 1], 0.001 },
                                 { s * x[side + 1], s * y[side + 1], 0.3 },
                                 { s * x[side], s * y[side], 0.3 } };
        kit_quad(b, q);
    }
    const double face[4][3] = {
        { -s, -s, 0.3 - back }, { s, -s, 0.3 - back }, { s, s, 0.3 - back }, { -s, s, 0.3 - back }
    };
    double inner[4][3];
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++) inner[k][i] = (i < 2 ? 0.6 : 1) * face[k][i];
    kit_colour(b, 0.88, 0.87, 0.84);
    kit_quad(b, (const double(*)[3])inner);
    kit_place_at(b, 0, 0, 0, 0);
}
