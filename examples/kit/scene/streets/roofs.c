/* roofs.c - roofs of buildings and what is on them. Declared in
   streets.h. */
#include "kit/scene/streets/streets.h"
#include <math.h>

/* ---- >>on roofs ------------------------------------------------------------------------------------------------ */

static void chimney(kit_build *b, double x, double y, double z, double high)
{
    static const kit_moulding pot[] = { { 0.13, 0, 0.1, 0.4, 0 },
                                        { 0.1, 0.4, 0.13, 0.45, 0 },
                                        { 0.13, 0.45, 0.09, 0.45, 0 },
                                        { 0.09, 0.45, 0.09, 0.1, 0 } };
    const int pots = 1 + kit_choose(b, 3);
    const double half = 0.2 + 0.17 * pots;
    kit_colour(b, 0.42, 0.26, 0.2);
    kit_box(b, x - half, y, z - 0.3, x + half, y + high, z + 0.3);
    kit_colour(b, 0.55, 0.52, 0.47);
    kit_box(b, x - half - 0.06, y + high + KIT_GAP, z - 0.36, x + half + 0.06, y + high + 0.1, z + 0.36);
    kit_colour(b, 0.55, 0.3, 0.2);
    for (int k = 0; k < pots; k++) {
        kit_place_at(b, x + 0.36 * (k - 0.5 * (pots - 1)), y + high + 0.1, z, 0);
        kit_turned(b, pot, 4, 12);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* A mast with its rods, or a dish. */
static void antenna(kit_build *b, double x, double y, double z)
{
    static const double mast[2][3] = { { 0, -0.2, 0 }, { 0, 2.2, 0 } },
                        boom[2][3] = { { 0, 2.1, -0.6 }, { 0, 2.1, 0.6 } };
    static const kit_moulding dish[] = { { 0, 0, 0.4, 0.12, 0.04 } };
    kit_colour(b, 0.55, 0.56, 0.57);
    kit_place_at(b, x, y, z, kit_between(b, 0, 180));
    kit_tube(b, mast, 2, 0.02, 6);
    if (kit_odds(b, 0.4)) {
        kit_place_tilted(b, x, y + 1, z + 0.1, kit_between(b, -50, 50), 65);
        kit_turned(b, dish, 1, 24);
    } else {
        kit_tube(b, boom, 2, 0.012, 6);
        for (int k = 0; k < 8; k++) {
            const double at = -0.55 + 0.15 * k, half = 0.42 - 0.03 * k,
                         rod[2][3] = { { -half, 2.1, at }, { half, 2.1, at } };
            kit_tube(b, rod, 2, 0.006, 4);
        }
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* A tank of staves on legs. */
static void tank(kit_build *b, double x, double y, double z)
{
    static const kit_moulding cone[] = { { 1.35, 0, 0, 0.8, 0 } };
    const double legs = kit_between(b, 1.2, 2.6);
    kit_colour(b, 0.2, 0.2, 0.2);
    for (int k = 0; k < 4; k++) {
        const double sx = x + (k & 1 ? 0.8 : -0.8), sz = z + (k & 2 ? 0.8 : -0.8);
        const double brace[2][3] = { { sx, y + 0.2, sz },
                                     { k & 2 ? sx : 2 * x - sx, y + legs - 0.2, k & 2 ? 2 * z - sz : sz } };
        kit_box(b, sx - 0.07, y, sz - 0.07, sx + 0.07, y + legs, sz + 0.07);
        kit_tube(b, brace, 2, 0.025, 5);
    }
    kit_box(b, x - 1.1, y + legs + KIT_GAP, z - 1.1, x + 1.1, y + legs + 0.12, z + 1.1);
    kit_colour(b, 0.36, 0.25, 0.17);
    kit_place_at(b, x, y + legs + 0.121, z, 0);
    kit_cylinder(b, 1.2, 2.2, 24);
    kit_place_at(b, x, y + legs + 2.3, z, 0);
    kit_turned(b, cone, 1, 24);
    kit_place_at(b, 0, 0, 0, 0);
    for (int k = 0; k < 4; k++) {
        static const double hoop[2] = { 1.205, 0.02 };
        kit_place_at(b, x, y + legs + 0.35 + 0.5 * k, z, 0);
        kit_patch(b, 24, 4, kit_torus_surface, hoop);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* A machine with fans, feet and a duct. */
static void plant(kit_build *b, double x, double y, double z)
{
    static const double ring[2] = { 0.35, 0.03 };
    const double duct[4][3] = {
        { x + 0.9, y + 0.5, z }, { x + 1.5, y + 0.5, z }, { x + 1.5, y + 0.5, z + 1.1 }, { x + 1.5, y - 0.1, z + 1.1 }
    };
    kit_colour(b, 0.62, 0.63, 0.62);
    kit_bevelled(b, x - 1, y + 0.15, z - 0.5, x + 1, y + 1.1, z + 0.5, 0.04);
    for (int k = 0; k < 2; k++) {
        kit_box(b, x - 0.9 + 1.7 * k, y, z - 0.5, x - 0.8 + 1.7 * k, y + 0.149, z + 0.5);
        kit_place_at(b, x - 0.5 + k, y + 1.12, z, 0);
        kit_patch(b, 20, 6, kit_torus_surface, ring);
        kit_place_at(b, 0, 0, 0, 0);
    }
    kit_tube(b, duct, 4, 0.2, 10);
}

/* tilted panes on feet */
static void panels(kit_build *b, double x, double y, double z)
{
    kit_colour(b, 0.05, 0.06, 0.14);
    for (int k = 0; k < 3; k++) {
        kit_place_tilted(b, x + 1.1 * k, y + 0.55, z, 0, 28);
        kit_box(b, 0, 0, -0.8, 1.05, 0.035, 0.8);
    }
    kit_place_at(b, 0, 0, 0, 0);
    kit_colour(b, 0.6, 0.6, 0.6);
    for (int k = 0; k < 4; k++) kit_box(b, x + 1.05 * k, y, z - 0.65, x + 1.05 * k + 0.05, y + 0.84, z - 0.6);
}

/* the head of a stair, with its door */
static void stair_head(kit_build *b, const kit_house *h, double x, double y, double z)
{
    kit_town_paint(b, h->wall);
    kit_box(b, x, y - 0.01, z - 2.4, x + 2.2, y + 2.4, z);
    kit_town_paint(b, h->trim);
    kit_box(b, x - 0.15, y + 2.4 + KIT_GAP, z - 2.55, x + 2.35, y + 2.55, z + 0.35);
    kit_town_paint(b, h->wood);
    kit_box(b, x + 0.6, y, z - 0.05, x + 1.5, y + 2, z + 0.03);
}

static void flat_roof(kit_build *b, const kit_house *h)
{
    const double e = kit_town_eaves(h), w = h->width, d = h->depth, high = kit_between(b, 0.3, 1.1), t = 0.26;
    const int things = h->fine ? 2 + kit_choose(b, 4) : kit_choose(b, 2);
    kit_colour(b, 0.4, 0.39, 0.37);
    kit_level(b, 0, -d, w, 0, e);
    kit_town_paint(b, h->trim);
    kit_box(b, -0.02, e - 0.11, -t, w + 0.02, e + high, 0.02);
    kit_box(b, -0.02, e - 0.11, -d - 0.02, w + 0.02, e + high, -d + t);
    kit_box(b, -0.02, e - 0.11, -d + t, t, e + high, -t);
    kit_box(b, w - t, e - 0.11, -d + t, w + 0.02, e + high, -t);
    if (w < 5 || d < 6) return;
    stair_head(b, h, kit_between(b, 0.6, w - 3), e, -kit_between(b, 0.5, 1.6) - 0.1 * d);
    for (int k = 0; k < things; k++) {
        const double x = kit_between(b, 1.4, w - 1.4), z = -d + 1.6 + k % 2 * kit_between(b, 0, 0.3 * d);
        switch (kit_choose(b, 5)) {
        case 0: plant(b, fmin(x, w - 2), e, z); break;
        case 1: antenna(b, x, e, z); break;
        case 2:
            if (h->style == KIT_BRICK || h->style == KIT_WAREHOUSE) tank(b, x, e, z);
            else antenna(b, x, e, z);
            break;
        case 3: panels(b, fmax(0.5, fmin(x, w - 4)), e, z); break;
        default: chimney(b, x, e - 0.01, z, kit_between(b, 0.8, 2)); break;
        }
    }
}

/* ---- >>pitched roofs --------------------------------------------------------------------------------------------- */

/* rolls of tiles up a slope: across, up, rolls, deep */
static void rolled_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = 2 * KIT_PI * s[2] * u;
    out->p[0] = s[0] * u;
    out->p[1] = 0.06 + s[3] * sin(a);
    out->p[2] = -s[1] * v;
    out->n[0] = -s[3] * 2 * KIT_PI * s[2] / s[0] * cos(a);
    out->n[1] = 1;
    out->n[2] = 0;
    kit_unit(out->n);
}

/* One slope, its eaves over the wall z = 0, so far out: courses or rolls of tiles, rakes, a gutter. */
static void slope(kit_build *b, const kit_house *h, double width, double run, double rise, int rolled)
{
    const double over = 0.4, pitch = atan2(rise, run), length = (run + over) / cos(pitch) + 0.02, side = 0.3;
    const double under[4][3] = { { 0, 0, -length }, { width, 0, -length }, { width, 0, 0 }, { 0, 0, 0 } };
    const int courses = (int)(length / (h->fine ? 0.3 : 1.5)) + 1;
    const double rolls[4] = { width, length, floor(width * 4), 0.035 };
    const kit_frame was = kit_enter(b, -side, kit_town_eaves(h) - over * tan(pitch), 0, 0, 1);
    width += 2 * side;
    kit_town_paint(b, h->cover);
    kit_place_tilted(b, 0, 0, over, 0, 180 / KIT_PI * pitch);
    if (rolled && h->fine) kit_patch(b, (int)(rolls[2] * 5), 1, rolled_surface, rolls);
    for (int k = 0; k < courses && !(rolled && h->fine); k++) {
        const double z0 = -length * k / courses, z1 = -length * (k + 1) / courses;
        const double top[4][3] = { { 0, 0.09, z0 }, { width, 0.09, z0 }, { width, 0.05, z1 }, { 0, 0.05, z1 } },
                     butt[4][3] = { { 0, 0.05, z0 }, { width, 0.05, z0 }, { width, 0.09, z0 }, { 0, 0.09, z0 } };
        kit_quad(b, top);
        kit_quad(b, butt);
    }
    kit_town_paint(b, h->trim);
    kit_quad(b, under);
    kit_box(b, -0.04, -0.12, -length, 0.01, 0.1, 0.02);
    kit_box(b, width - 0.01, -0.12, -length, width + 0.04, 0.1, 0.02);
    kit_box(b, 0.01, -0.08, -0.03, width - 0.01, 0.04, 0.01);
    if (h->fine) {
        const double gutter[2][3] = { { 0.05, -0.03, over + 0.07 }, { width - 0.05, -0.03, over + 0.07 } };
        kit_place_at(b, 0, 0, 0, 0);
        kit_colour(b, 0.34, 0.35, 0.36);
        kit_tube(b, gutter, 2, 0.065, 8);
    }
    kit_leave(b, was);
}

static void gable_roof(kit_build *b, const kit_house *h, double width, double depth)
{
    const double e = kit_town_eaves(h), run = 0.5 * depth, rise = run * kit_between(b, 0.45, 1.1);
    const double ridge[2][3] = { { -0.3, e + rise + 0.05, -run }, { width + 0.3, e + rise + 0.05, -run } };
    const int rolled = kit_odds(b, 0.4);
    for (int k = 0; k < 2; k++) {
        const kit_frame was = kit_enter(b, k ? width : 0, 0, k ? -depth : 0, 180 * k, 1);
        const kit_vertex end[3] = { { { 0, e, -depth }, { -1, 0, 0 } },
                                    { { 0, e, 0 }, { -1, 0, 0 } },
                                    { { 0, e + rise, -run }, { -1, 0, 0 } } };
        kit_town_paint(b, h->wall);
        kit_triangle(b, &end[0], &end[1], &end[2]);
        slope(b, h, width, run, rise, rolled);
        kit_leave(b, was);
    }
    kit_town_paint(b, h->cover);
    kit_tube(b, ridge, 2, 0.1, 8);
    for (int k = kit_choose(b, 3); k > 0; k--)
        chimney(b, kit_between(b, 0.8, width - 0.8), e + 0.6 * rise, -run + kit_between(b, -1, 1), 0.4 * rise + 0.9);
    if (kit_odds(b, 0.6)) antenna(b, kit_between(b, 1, width - 1), e + rise, -run);
}

/* a dormer in a steep slope whose foot is at y, z = 0 */
static void dormer(kit_build *b, const kit_house *h, double x, double y)
{
    const double wide = 0.6, high = 1.5;
    const double gable[4][3] = { { x - wide, y + high, 0.01 },
                                 { x + wide, y + high, 0.01 },
                                 { x, y + high + 0.45, 0.01 },
                                 { x, y + high + 0.45, 0.01 } };
    kit_town_paint(b, h->trim);
    kit_box(b, x - wide, y + 0.3, -1.4, x - wide + 0.14, y + high, 0);
    kit_box(b, x + wide - 0.14, y + 0.3, -1.4, x + wide, y + high, 0);
    kit_box(b, x - wide + 0.14, y + high - 0.14, -1.4, x + wide - 0.14, y + high, 0);
    kit_box(b, x - wide + 0.14, y + 0.3, -1.4, x + wide - 0.14, y + 0.42, 0.05);
    kit_quad(b, gable);
    kit_colour(b, 0.08, 0.09, 0.1);
    kit_box(b, x - wide + 0.1, y + 0.42, -0.4, x + wide - 0.1, y + high - 0.1, -0.12);
    kit_town_paint(b, h->cover);
    for (int k = -1; k <= 1; k += 2) {
        const double half[4][3] = { { x + k * (wide + 0.12), y + high - 0.05, 0.12 },
                                    { x, y + high + 0.5, 0.12 },
                                    { x, y + high + 0.5, -2.2 },
                                    { x + k * (wide + 0.12), y + high - 0.05, -2.2 } };
        kit_quad(b, half);
    }
}

/* Steep on all sides, flat above. */
static void mansard(kit_build *b, const kit_house *h)
{
    const double e = kit_town_eaves(h), w = h->width, d = h->depth, in = 1.1, top = e + kit_between(b, 2.1, 2.9);
    const double low[4][2] = { { 0, 0 }, { w, 0 }, { w, -d }, { 0, -d } },
                 up[4][2] = { { in, -in }, { w - in, -in }, { w - in, -d + in }, { in, -d + in } };
    kit_town_paint(b, h->cover);
    for (int k = 0; k < 4; k++) {
        const int n = (k + 1) % 4;
        const double side[4][3] = { { low[k][0], e, low[k][1] },
                                    { low[n][0], e, low[n][1] },
                                    { up[n][0], top, up[n][1] },
                                    { up[k][0], top, up[k][1] } };
        static const double cuts[] = { 0, 0.125, 0.25, 0.375, 0.5, 0.625, 0.75, 0.875, 1 }, whole[] = { 0, 1 };
        kit_sheet(b, side, KIT_CUTS(whole), KIT_CUTS(cuts));
    }
    kit_box(b, in - 0.15, top - 0.05, -d + in - 0.15, w - in + 0.15, top + 0.1, -in + 0.15);
    for (double x = 1.8; x < w - 1.5 && h->fine; x += 2.3) dormer(b, h, x, e);
    for (int k = 0; k < 2; k++) chimney(b, k ? w - 0.6 : 0.6, e - 0.1, -kit_between(b, 0.3, 0.7) * d, top - e + 1.1);
    if (kit_odds(b, 0.5)) antenna(b, 0.5 * w, top, -0.5 * d);
}

void kit_town_roof(kit_build *b, const kit_house *h)
{
    if (h->roof == KIT_GABLE) gable_roof(b, h, h->width, h->depth);
    else if (h->roof == KIT_CROSS_GABLE) {
        const kit_frame was = kit_enter(b, h->width, 0, 0, 90, 1);
        gable_roof(b, h, h->depth, h->width);
        kit_leave(b, was);
    } else if (h->roof == KIT_HIP && h->width > 4) mansard(b, h);
    else flat_roof(b, h);
}
