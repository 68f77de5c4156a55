/* facades.c - fronts of buildings: windows in their reveals, sills, shutters, balconies, doors, shops, cornices.
   Declared in streets.h. */
#include "kit/scene/streets/streets.h"
#include <math.h>

typedef struct rect {
    double x0, y0, x1, y1;
} rect;

/* looks along +z */
static void face(kit_build *b, double x0, double y0, double x1, double y1, double z)
{
    const double c[4][3] = { { x0, y0, z }, { x1, y0, z }, { x1, y1, z }, { x0, y1, z } };
    if (x1 > x0 && y1 > y0) kit_quad(b, c);
}

/* Wall that looks along +z, clad: 1: lapped boards, 2: courses of blocks with joints, 3: upright battens. */
static void clad(kit_build *b, int kind, double x0, double y0, double x1, double y1)
{
    const double step = kind == 1 ? 0.17 : kind == 2 ? 0.42 : 0.4;
    if (!(x1 > x0 + 1e-3 && y1 > y0 + 1e-3)) return;
    if (kind != 1) face(b, x0, y0, x1, y1, 0);
    for (double y = step * floor(y0 / step); y < y1 && kind == 1; y += step) {
        const double low = fmax(y, y0), top = fmin(y + step, y1), in = 0.004, out = in + 0.028 * (top - low) / step;
        const double board[4][3] = { { x0, low, out }, { x1, low, out }, { x1, top, in }, { x0, top, in } },
                     butt[4][3] = { { x0, low, 0 }, { x1, low, 0 }, { x1, low, out }, { x0, low, out } },
                     left[4][3] = { { x0, low, 0 }, { x0, low, out }, { x0, top, in }, { x0, top, 0 } },
                     right[4][3] = { { x1, low, out }, { x1, low, 0 }, { x1, top, 0 }, { x1, top, in } };
        kit_quad(b, board);
        kit_quad(b, butt);
        kit_quad(b, left);
        kit_quad(b, right);
    }
    for (double y = step * floor(y0 / step); y < y1 && kind == 2; y += step) {
        const double low = fmax(y + 0.025, y0), top = fmin(y + step, y1);
        if (top > low + 0.03) kit_box(b, x0 + 0.002, low, -0.01, x1 - 0.002, top, 0.035);
    }
    for (double x = step * ceil(x0 / step); x < x1 - 0.05 && kind == 3; x += step)
        kit_box(b, x, y0, -0.005, x + 0.05, y1, 0.03);
}

/* ---- >>holes --------------------------------------------------------------------------------------------------- */

/* what of an arch is to the side of its middle by u in [-1, 1] */
static double arch_at(const rect *w, double u)
{
    return w->y1 - 0.5 * (w->x1 - w->x0) * (1 - sqrt(fmax(0, 1 - u * u)));
}

/* the wall between an arch and the rectangle about it, and the arch's soffit */
static void arch(kit_build *b, const rect *w, double deep)
{
    enum { PIECES = 10 };

    const double half = 0.5 * (w->x1 - w->x0), middle = 0.5 * (w->x0 + w->x1);
    for (int k = 0; k < PIECES; k++) {
        const double u0 = -cos(KIT_PI * k / PIECES), u1 = -cos(KIT_PI * (k + 1) / PIECES), x0 = middle + half * u0,
                     x1 = middle + half * u1, y0 = arch_at(w, u0), y1 = arch_at(w, u1);
        const double above[4][3] = { { x0, y0, 0 }, { x1, y1, 0 }, { x1, w->y1, 0 }, { x0, w->y1, 0 } },
                     under[4][3] = { { x0, y0, -deep }, { x1, y1, -deep }, { x1, y1, 0 }, { x0, y0, 0 } };
        kit_quad(b, above);
        kit_quad(b, under);
    }
}

/* A piece of wall with a hole in it, as deep; without a floor where it reaches down to the piece's edge. */
static void hole(kit_build *b, int cladding, const rect *c, const rect *w, double deep, int arched)
{
    const double spring = arched ? w->y1 - 0.5 * (w->x1 - w->x0) : w->y1;
    const double
        left[4][3] = { { w->x0, w->y0, 0 }, { w->x0, w->y0, -deep }, { w->x0, spring, -deep }, { w->x0, spring, 0 } },
        right[4][3] = { { w->x1, w->y0, -deep }, { w->x1, w->y0, 0 }, { w->x1, spring, 0 }, { w->x1, spring, -deep } },
        top[4][3] = { { w->x0, w->y1, -deep }, { w->x1, w->y1, -deep }, { w->x1, w->y1, 0 }, { w->x0, w->y1, 0 } },
        floor[4][3] = { { w->x0, w->y0, 0 }, { w->x1, w->y0, 0 }, { w->x1, w->y0, -deep }, { w->x0, w->y0, -deep } };
    clad(b, cladding, c->x0, c->y0, w->x0, c->y1);
    clad(b, cladding, w->x1, c->y0, c->x1, c->y1);
    clad(b, cladding, w->x0, c->y0, w->x1, w->y0);
    clad(b, cladding, w->x0, w->y1, w->x1, c->y1);
    kit_quad(b, left);
    kit_quad(b, right);
    kit_quad(b, floor);
    if (arched) arch(b, w, deep);
    else kit_quad(b, top);
}

/* ---- >>windows ------------------------------------------------------------------------------------------------- */

static void glass(kit_build *b)
{
    static const float panes[][3] = { { 0.05f, 0.06f, 0.07f },
                                      { 0.09f, 0.11f, 0.13f },
                                      { 0.04f, 0.05f, 0.05f },
                                      { 0.18f, 0.2f, 0.22f },
                                      { 0.62f, 0.6f, 0.54f } };
    KIT_TINT(b, panes, 0.3);
}

/* The pane at the back of a hole, in its frame. */
static void sash(kit_build *b, const kit_house *h, const rect *w, double z)
{
    const double thick = 0.05, in = 0.01;
    glass(b);
    face(b, w->x0, w->y0, w->x1, w->y1, z);
    if (!h->fine) return;
    kit_town_paint(b, h->wood);
    kit_box(b, w->x0 - in, w->y0 - in, z - in, w->x0 + thick, w->y1, z + thick);
    kit_box(b, w->x1 - thick, w->y0 - in, z - in, w->x1 + in, w->y1, z + thick);
    kit_box(b, w->x0 + thick, w->y0 - in, z - in, w->x1 - thick, w->y0 + thick, z + thick);
    kit_box(b, w->x0 + thick, w->y1 - thick, z - in, w->x1 - thick, w->y1 + in, z + thick);
    for (int k = 1; k < h->columns; k++) {
        const double x = w->x0 + (w->x1 - w->x0) * k / h->columns;
        kit_box(b, x - 0.025, w->y0 + thick, z - in, x + 0.025, w->y1 - thick, z + 0.8 * thick);
    }
    for (int k = 1; k < h->rows; k++) {
        const double y = w->y0 + (w->y1 - w->y0) * k / h->rows;
        kit_box(b, w->x0 + thick, y - 0.02, z - in, w->x1 - thick, y + 0.02, z + 0.6 * thick);
    }
}

/* A leaf of louvres or boards, hinged at x, opened by degrees from lying over the window. */
static void shutter(kit_build *b, const kit_house *h, double x, const rect *w, int side, double open)
{
    const double wide = 0.5 * (w->x1 - w->x0), high = w->y1 - w->y0;
    kit_place_at(b, x, w->y0, 0.025, side < 0 ? -open : 180 + open);
    if (h->shutters == 1) {
        const double sheet[4][3] = { { 0, 0, 0 }, { wide, 0, 0 }, { wide, high, 0 }, { 0, high, 0 } };
        kit_quad(b, sheet);
    } else {
        kit_box(b, 0, 0, -0.018, 0.05, high, 0.018);
        kit_box(b, wide - 0.05, 0, -0.018, wide, high, 0.018);
        for (int k = 0; k < 3; k++)
            kit_box(b, 0.05, k * 0.5 * (high - 0.06), -0.016, wide - 0.05, k * 0.5 * (high - 0.06) + 0.06, 0.016);
        for (double y = 0.12; y < high - 0.1; y += 0.11) {
            const double slat[4][3] = {
                { 0.05, y, 0.02 }, { wide - 0.05, y, 0.02 }, { wide - 0.05, y + 0.05, -0.02 }, { 0.05, y + 0.05, -0.02 }
            };
            kit_quad(b, slat);
        }
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* Earth in a box on the sill, leaves. */
static void flower_box(kit_build *b, const rect *w)
{
    kit_colour(b, 0.36, 0.2, 0.14);
    kit_box(b, w->x0 + 0.05, w->y0 + 0.012, 0.01, w->x1 - 0.05, w->y0 + 0.17, 0.17);
    for (int k = 0; k < 16; k++) {
        const int bloom = kit_odds(b, 0.3);
        if (bloom) kit_colour(b, 0.7, kit_between(b, 0.1, 0.5), kit_between(b, 0.1, 0.5));
        else kit_colour(b, 0.1, kit_between(b, 0.2, 0.36), 0.07);
        kit_place_tilted(b, kit_between(b, w->x0 + 0.1, w->x1 - 0.1), w->y0 + 0.16, kit_between(b, 0.05, 0.14),
                         kit_between(b, 0, 360), kit_between(b, -80, -20));
        kit_leaf(b, kit_between(b, 0.05, 0.1), kit_between(b, 0.12, 0.28), kit_between(b, -1.5, 0), 3, 1);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* An air conditioner on brackets, its fan behind a ring. */
static void cooler(kit_build *b, double x, double y)
{
    static const double ring[2] = { 0.2, 0.014 };
    kit_colour(b, 0.72, 0.71, 0.68);
    kit_bevelled(b, x - 0.4, y, 0.06, x + 0.4, y + 0.56, 0.36, 0.03);
    kit_colour(b, 0.2, 0.2, 0.21);
    for (int k = -1; k <= 1; k += 2)
        kit_box(b, x + 0.3 * k - 0.015, y - 0.03, -0.01, x + 0.3 * k + 0.015, y - KIT_GAP, 0.36);
    kit_place_tilted(b, x - 0.12, y + 0.28, 0.372, 0, 90);
    kit_patch(b, 20, 6, kit_torus_surface, ring);
    kit_place_at(b, 0, 0, 0, 0);
    for (int k = -1; k <= 1; k++)
        kit_box(b, x - 0.32, y + 0.272 + 0.1 * k, 0.355, x + 0.08, y + 0.288 + 0.1 * k, 0.375);
}

static void balcony(kit_build *b, const kit_house *h, const rect *c, double floor)
{
    const double out = kit_between(b, 0.6, 1.3), x0 = c->x0 + 0.12, x1 = c->x1 - 0.12;
    const double rail[4][2] = {
        { x0 + 0.03, 0 }, { x0 + 0.03, out - 0.04 }, { x1 - 0.03, out - 0.04 }, { x1 - 0.03, 0 }
    };
    kit_town_paint(b, h->trim);
    kit_box(b, x0, floor - 0.16, -0.02, x1, floor, out);
    for (int k = 0; k < 2 && h->style < KIT_MODERN; k++) { /* consoles */
        const double x = k ? x1 - 0.3 : x0 + 0.15;
        kit_box(b, x, floor - 0.42, -0.02, x + 0.15, floor - 0.155, 0.4 * out);
        kit_box(b, x + 0.01, floor - 0.28, 0.3 * out, x + 0.14, floor - 0.157, 0.8 * out);
    }
    if (h->rail == KIT_BARS || h->rail == KIT_MESH) kit_colour(b, 0.09, 0.09, 0.1);
    kit_town_railing(b, rail, 4, floor, 1.0, h->rail);
    if (kit_odds(b, 0.3)) {
        const kit_frame was = kit_enter(b, kit_between(b, x0 + 0.35, x1 - 0.35), floor + 0.001, 0.6 * out, 0, 1);
        kit_town_pot(b);
        kit_leave(b, was);
    }
}

/* Sill, lintel or frame in relief. */
static void dressing(kit_build *b, const kit_house *h, const rect *w)
{
    kit_town_paint(b, h->trim);
    kit_box(b, w->x0 - 0.08, w->y0 - 0.07, -0.5 * h->recess, w->x1 + 0.08, w->y0 + 0.01, 0.12);
    if (h->style == KIT_OLD && !h->arched) {
        kit_box(b, w->x0 - 0.14, w->y0 + 0.01, -0.01, w->x0 - 0.005, w->y1, 0.04);
        kit_box(b, w->x1 + 0.005, w->y0 + 0.01, -0.01, w->x1 + 0.14, w->y1, 0.04);
        kit_box(b, w->x0 - 0.14, w->y1 + 0.005, -0.01, w->x1 + 0.14, w->y1 + 0.14, 0.05);
        kit_box(b, w->x0 - 0.2, w->y1 + 0.18, -0.01, w->x1 + 0.2, w->y1 + 0.25, 0.2);
    } else if (h->style == KIT_BRICK) kit_box(b, w->x0 - 0.12, w->y1 + 0.002, -0.01, w->x1 + 0.12, w->y1 + 0.2, 0.05);
    else if (h->cladding == 1)
        for (int k = 0; k < 3; k++) /* boards round it */
            kit_box(b, k == 1 ? w->x1 - 0.005 : w->x0 - 0.1, k == 2 ? w->y1 - 0.005 : w->y0 + 0.01, -0.01,
                    k ? w->x1 + 0.1 : w->x0 + 0.005, k == 2 ? w->y1 + 0.12 : w->y1 - 0.006, k == 2 ? 0.055 : 0.05);
}

static void window(kit_build *b, const kit_house *h, const rect *c, double floor, int front)
{
    const double middle = 0.5 * (c->x0 + c->x1), wide = fmin(h->window[0], c->x1 - c->x0 - 0.2);
    const int tall = h->fine && front && kit_odds(b, h->balconies);
    const rect w = { middle - 0.5 * wide, tall ? floor + 0.08 : floor + h->sill, middle + 0.5 * wide,
                     fmin(floor + h->sill + h->window[1], c->y1 - 0.15) };
    kit_town_paint(b, h->wall);
    hole(b, floor < 1 || h->cladding != 2 ? h->cladding : 0, c, &w, h->recess, h->arched);
    sash(b, h, &w, -h->recess);
    if (!h->fine) return;
    if (tall) {
        balcony(b, h, c, floor);
        return;
    }
    dressing(b, h, &w);
    if (h->shutters && !h->arched && c->x1 - c->x0 > 2 * wide) {
        const double open = kit_odds(b, 0.15) ? kit_between(b, 0, 100) : kit_between(b, 160, 176);
        kit_town_paint(b, h->wood);
        shutter(b, h, w.x0, &w, -1, open);
        shutter(b, h, w.x1, &w, 1, kit_odds(b, 0.8) ? open : 170);
    }
    if (kit_odds(b, h->pots)) flower_box(b, &w);
    else if (kit_odds(b, h->coolers) && w.y0 - floor > 0.65) cooler(b, middle + kit_between(b, -0.4, 0.4), w.y0 - 0.65);
}

/* ---- >>ground floor --------------------------------------------------------------------------------------------- */

static void door(kit_build *b, const kit_house *h, const rect *c)
{
    const double middle = 0.5 * (c->x0 + c->x1), half = 0.55, steps = h->style == KIT_WAREHOUSE ? 0 : kit_choose(b, 4),
                 rise = 0.15 * steps, deep = h->recess + 0.2;
    const rect w = { middle - half, rise, middle + half, fmin(rise + 2.5, c->y1 - 0.15) };
    kit_town_paint(b, h->wall);
    hole(b, h->cladding, c, &w, deep, h->arched);
    kit_colour(b, 0.5, 0.48, 0.45);
    for (int k = 0; k < (int)steps; k++)
        kit_box(b, w.x0 - 0.25, 0, -0.01, w.x1 + 0.25, 0.15 * (k + 1) - 0.002, 0.3 * (steps - k));
    kit_town_paint(b, h->wood);
    face(b, w.x0, w.y0, w.x1, w.y1, -deep);
    if (!h->fine) return;
    for (int k = 0; k < 4; k++) { /* panels, frame */
        const double x = k & 1 ? middle + 0.05 : w.x0 + 0.12, y = rise + (k & 2 ? 1.05 : 0.15);
        kit_box(b, x, y, -deep - 0.01, x + 0.38, y + (k & 2 ? 0.9 : 0.75), -deep + 0.03);
    }
    kit_box(b, w.x0, rise + 2.05, -deep - 0.01, w.x1, rise + 2.13, -deep + 0.07);
    kit_colour(b, 0.6, 0.5, 0.2);
    kit_box(b, middle - 0.015, rise + 0.95, -deep, middle + 0.015, rise + 1.1, -deep + 0.08);
    kit_town_paint(b, h->trim);
    if (kit_odds(b, 0.6)) { /* a hood */
        kit_box(b, w.x0 - 0.3, w.y1 + 0.05, -0.01, w.x1 + 0.3, w.y1 + 0.15, kit_between(b, 0.3, 0.9));
        for (int k = 0; k < 2; k++) {
            const double x = k ? w.x1 + 0.12 : w.x0 - 0.2;
            kit_box(b, x, w.y1 - 0.25, -0.01, x + 0.08, w.y1 + 0.052, 0.2);
        }
    }
}

/* Goods on shelves in a shop that is open to the street. */
static void goods(kit_build *b, const rect *w, double deep)
{
    static const float colours[][3] = { { 0.6f, 0.2f, 0.15f },   { 0.7f, 0.6f, 0.3f },  { 0.2f, 0.35f, 0.5f },
                                        { 0.75f, 0.72f, 0.66f }, { 0.25f, 0.4f, 0.2f }, { 0.4f, 0.26f, 0.14f } };
    for (int k = 0; k < 3; k++) {
        const double y = w->y0 + 0.5 + 0.55 * k;
        kit_colour(b, 0.45, 0.34, 0.22);
        kit_box(b, w->x0 + 0.05, y - 0.03, -deep + 0.02, w->x1 - 0.05, y, -deep + 0.5);
        for (double x = w->x0 + 0.1, wide; x < w->x1 - 0.45; x += wide + 0.03) {
            wide = kit_between(b, 0.1, 0.35);
            KIT_TINT(b, colours, 0.2);
            kit_box(b, x, y + KIT_GAP, -deep + 0.1, x + wide, y + kit_between(b, 0.12, 0.42),
                    -deep + kit_between(b, 0.3, 0.46));
        }
    }
}

static void shop(kit_build *b, const kit_house *h, const rect *c)
{
    static const float boards[][3] = { { 0.5f, 0.1f, 0.08f }, { 0.08f, 0.22f, 0.16f }, { 0.1f, 0.14f, 0.3f },
                                       { 0.75f, 0.7f, 0.6f }, { 0.12f, 0.12f, 0.12f }, { 0.7f, 0.5f, 0.12f } };
    const int open = h->fine && kit_odds(b, 0.35);
    const double deep = open ? kit_between(b, 1.2, 2.5) : kit_between(b, 0.15, 0.6);
    const rect w = { c->x0 + 0.2, 0.05, c->x1 - 0.2, fmin(2.9, c->y1 - 0.7) }, pane = { w.x0, 0.5, w.x1, w.y1 };
    kit_town_paint(b, h->wall);
    hole(b, h->cladding, c, &w, deep, 0);
    if (open) {
        face(b, w.x0, w.y0, w.x1, w.y1, -deep);
        goods(b, &w, deep);
    } else {
        kit_town_paint(b, h->wood);
        kit_box(b, w.x0 - 0.01, 0.04, -deep - 0.02, w.x1 + 0.01, 0.5, -deep + 0.08);
        sash(b, h, &pane, -deep);
    }
    if (!h->fine) return;
    KIT_TINT(b, boards, 0.1);
    kit_box(b, c->x0 + 0.12, w.y1 + 0.08, -0.01, c->x1 - 0.12, w.y1 + 0.55, 0.09);
    kit_box(b, c->x0 + 0.08, w.y1 + 0.55, -0.01, c->x1 - 0.08, w.y1 + 0.6, 0.2);
    if (kit_odds(b, h->awnings)) {
        const kit_frame was = kit_enter(b, c->x0 + 0.1, 0, 0.095, 0, 1);
        kit_town_awning(b, c->x1 - c->x0 - 0.2, w.y1 + 0.05, kit_between(b, 1, 2), kit_between(b, 0.3, 0.8));
        kit_leave(b, was);
    }
}

/* A wide door of ridges that rolls up; perhaps not all the way down. */
static void garage(kit_build *b, const kit_house *h, const rect *c)
{
    const double half = fmin(1.6, 0.5 * (c->x1 - c->x0) - 0.2), middle = 0.5 * (c->x0 + c->x1),
                 top = fmin(2.9, c->y1 - 0.4), low = kit_odds(b, 0.3) ? kit_between(b, 0.4, 2) : 0.02,
                 deep = 0.25 + (low > 0.1 ? 2.5 : 0);
    const rect w = { middle - half, 0.01, middle + half, top };
    kit_town_paint(b, h->wall);
    hole(b, h->cladding, c, &w, deep, 0);
    if (low > 0.1) face(b, w.x0, w.y0, w.x1, w.y1, -deep);
    kit_town_paint(b, h->trim);
    for (double y = low; y < top; y += 0.14) {
        const double a[4][3] = { { w.x0, y, -0.2 },
                                 { w.x1, y, -0.2 },
                                 { w.x1, y + 0.09, -0.16 },
                                 { w.x0, y + 0.09, -0.16 } },
                     c2[4][3] = { { w.x0, y + 0.09, -0.16 },
                                  { w.x1, y + 0.09, -0.16 },
                                  { w.x1, y + 0.14, -0.2 },
                                  { w.x0, y + 0.14, -0.2 } };
        kit_quad(b, a);
        kit_quad(b, c2);
    }
}

/* ---- >>walls --------------------------------------------------------------------------------------------------- */

static void ground_floor(kit_build *b, const kit_house *h, double step, int bays)
{
    const int entrance = kit_choose(b, bays);
    const int wide = h->style == KIT_WAREHOUSE || (h->style == KIT_COTTAGE && bays > 2);
    const int gate = wide ? (entrance + 1 + kit_choose(b, bays)) % bays : -1;
    for (int k = 0; k < bays; k++) {
        const rect c = { step * k, 0, step * (k + 1), h->ground };
        if (k == entrance) door(b, h, &c);
        else if (k == gate) garage(b, h, &c);
        else if (step > 1.8 && kit_odds(b, h->shops)) shop(b, h, &c);
        else window(b, h, &c, 0.25, 0);
    }
}

/* A wall in the plane z = 0 with its windows. */
static void wall(kit_build *b, const kit_house *h, double width, int front)
{
    const int bays = (int)fmax(1, floor(width / h->bay + 0.5));
    const double step = width / bays;
    if (front) ground_floor(b, h, step, bays);
    for (int f = front ? 1 : 0; f < h->floors; f++) {
        const double y = f ? h->ground + h->storey * (f - 1) : 0, top = h->ground + h->storey * f;
        for (int k = 0; k < bays; k++) {
            const rect c = { step * k, y, step * (k + 1), top };
            window(b, h, &c, y + (f ? 0 : 0.25), front);
        }
    }
}

/* Courses between the floors, the cornice, quoins, a plinth. */
static void relief(kit_build *b, const kit_house *h, double width)
{
    const double top = kit_town_eaves(h), out = h->dentils ? 0.35 : 0.18;
    kit_town_paint(b, h->trim);
    for (int f = 0; f < h->floors - 1 && (h->courses > 1 || (!f && h->courses)); f++)
        kit_box(b, -0.04, h->ground + h->storey * f - 0.1, -0.02, width + 0.04, h->ground + h->storey * f + 0.02, 0.09);
    if (h->roof == KIT_FLAT || h->dentils) {
        kit_box(b, -0.1, top - 0.34, -0.02, width + 0.1, top - 0.2, 0.35 * out);
        kit_box(b, -0.1, top - 0.2, -0.02, width + 0.1, top - 0.002, out);
    }
    for (double x = 0.1; x < width - 0.15 && h->dentils; x += 0.45)
        kit_box(b, x, top - 0.5, -0.02, x + 0.15, top - 0.199, 0.8 * out);
    for (double y = 0; y < top - 0.7 && h->quoins; y += 0.8)
        for (int side = 0; side < 2; side++) {
            const double x = side ? width - 0.45 : -0.03;
            kit_box(b, x, y, -0.4, x + 0.48, y + 0.38, 0.035);
        }
}

/* from the eaves down, with its brackets */
static void drainpipe(kit_build *b, const kit_house *h, double x)
{
    const double top = kit_town_eaves(h) - 0.25;
    const double pipe[4][3] = { { x, top, 0.02 }, { x, top - 0.3, 0.16 }, { x, 0.3, 0.16 }, { x + 0.02, 0.08, 0.34 } };
    kit_colour(b, 0.34, 0.35, 0.36);
    kit_tube(b, pipe, 4, 0.05, 8);
    for (double y = 1; y < top - 0.5; y += 2) kit_box(b, x - 0.07, y, -0.01, x + 0.07, y + 0.05, 0.225);
}

void kit_town_raise_house(kit_plot *p, const kit_house *h)
{
    kit_build *b = &p->b;
    const double at[4][4] = { { 0, 0, 0, h->width },
                              { h->width, 0, 90, h->depth },
                              { h->width, -h->depth, 180, h->width },
                              { 0, -h->depth, 270, h->depth } };
    if (h->fine) kit_begin_object(b, "house", -1);
    for (int k = 0; k < 4; k++) {
        const kit_frame was = kit_enter(b, at[k][0], 0, at[k][1], at[k][2], 1);
        if (h->sides >> k & 1) wall(b, h, at[k][3], !k);
        else {
            kit_town_paint(b, h->wall);
            clad(b, h->cladding == 2 ? 0 : h->cladding, 0, 0, at[k][3], kit_town_eaves(h));
        }
        if (h->fine && (!k || h->sides >> k & 1)) relief(b, h, at[k][3]);
        if (h->fine && !k && kit_odds(b, 0.6)) drainpipe(b, h, kit_odds(b, 0.5) ? 0.2 : h->width - 0.25);
        kit_leave(b, was);
    }
    if (h->fine) kit_begin_object(b, "roof", -1);
    kit_town_roof(b, h);
}
