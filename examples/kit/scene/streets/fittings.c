/* fittings.c - what is fixed to buildings of streets or stands before them: railings, fences, awnings, fire escapes,
   scaffolds, washing, bunting. Declared in streets.h. */
#include "kit/scene/streets/streets.h"
#include <math.h>
#include <string.h>

void kit_town_to_world(const kit_build *b, double x, double y, double z, double out[3])
{
    const kit_frame *f = &b->frame;
    const double by = f->scale > 0 ? f->scale : 1, turn = atan2(f->turn[0][2], f->turn[0][0]);
    out[0] = by * (cos(turn) * x + sin(turn) * z) + (f->scale > 0 ? f->at[0] : 0);
    out[1] = by * y + (f->scale > 0 ? f->at[1] : 0);
    out[2] = by * (cos(turn) * z - sin(turn) * x) + (f->scale > 0 ? f->at[2] : 0);
}

/* ---- >>railings ------------------------------------------------------------------------------------------------ */

/* A bay of it from the origin along x. */
static void rail_bay(kit_build *b, double length, double high, int kind)
{
    const int bars = (int)fmax(2, floor(length / (kind == KIT_PICKETS ? 0.16 : 0.145)));
    const double pane[4][3] = {
        { 0, 0.06, 0 }, { length, 0.06, 0 }, { length, high - 0.06, 0 }, { 0, high - 0.06, 0 }
    };
    if (kind == KIT_SOLID) {
        kit_box(b, -0.05, 0, -0.05, length + 0.05, high, 0.05);
        return;
    }
    kit_box(b, -0.025, 0, -0.025, 0.025, high, 0.025);
    if (kind == KIT_GLASS) kit_quad(b, pane);
    if (kind == KIT_BARS) {
        kit_box(b, 0.025, 0.06, -0.012, length, 0.09, 0.012);
        for (int k = 1; k < bars; k++)
            kit_box(b, length * k / bars - 0.007, 0.09, -0.007, length * k / bars + 0.007, high - 0.03, 0.007);
    }
    if (kind == KIT_PICKETS) {
        for (int k = 0; k < 2; k++) kit_box(b, 0, 0.2 + 0.45 * k * high, -0.03, length, 0.27 + 0.45 * k * high, -0.005);
        for (int k = 0; k < bars; k++) {
            const double x = length * (k + 0.5) / bars, top = high * 0.93, at[2] = { x - 0.04, x + 0.04 };
            const double point[4][3] = {
                { at[0], top, 0.01 }, { at[1], top, 0.01 }, { x, high, 0.01 }, { x, high, 0.01 }
            };
            kit_box(b, at[0], 0.05, -0.004, at[1], top, 0.016);
            kit_quad(b, point);
        }
    }
    for (int k = 0; k < 5 && kind == KIT_BOARDS; k++)
        kit_box(b, 0, 0.06 + k * (high - 0.1) / 5, 0.026, length, 0.06 + k * (high - 0.1) / 5 + 0.12 * high, 0.045);
    for (int k = 0; k < 2 * bars && kind == KIT_MESH; k++) { /* wires crossing, as thin strips */
        const double x = length * (k >> 1) / bars, to = x + (k & 1 ? -0.5 : 0.5) * high, e = 0.006;
        const double end = fmin(length, fmax(0, to)), up = 0.05 + (high - 0.08) * (end - x) / (to - x);
        const double wire[4][3] = { { x - e, 0.05, 0 }, { x + e, 0.05, 0 }, { end + e, up, 0 }, { end - e, up, 0 } };
        kit_quad(b, wire);
    }
    if (kind != KIT_PICKETS) kit_box(b, -0.02, high - 0.03, -0.035, length + 0.02, high + 0.02, 0.035);
}

void kit_town_railing(kit_build *b, const double at[][2], int count, double y, double height, int kind)
{
    for (int k = 0; k + 1 < count; k++) {
        const double dx = at[k + 1][0] - at[k][0], dz = at[k + 1][1] - at[k][1], length = hypot(dx, dz);
        const int bays = (int)fmax(1, ceil(length / 2.2));
        for (int i = 0; i < bays; i++) {
            const double t = (double)i / bays;
            kit_place_at(b, at[k][0] + t * dx, y, at[k][1] + t * dz, 180 / KIT_PI * atan2(-dz, dx));
            rail_bay(b, length / bays, height, kind);
        }
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>cloth --------------------------------------------------------------------------------------------------- */

static const float cloths[][3] = { { 0.55f, 0.1f, 0.09f },  { 0.1f, 0.26f, 0.2f },  { 0.78f, 0.74f, 0.66f },
                                   { 0.75f, 0.55f, 0.15f }, { 0.12f, 0.2f, 0.42f }, { 0.6f, 0.6f, 0.58f },
                                   { 0.35f, 0.2f, 0.3f } };

void kit_town_awning(kit_build *b, double width, double y, double out, double drop)
{
    float stripe[2][3];
    const int stripes = (int)fmax(3, floor(width / 0.32));
    kit_tint(b, cloths, 7, 0.15);
    kit_town_keep(b, stripe[0]);
    kit_tint(b, cloths + 2, 1, 0.1);
    kit_town_keep(b, stripe[1]);
    for (int k = 0; k < stripes; k++) {
        const double x0 = width * k / stripes, x1 = width * (k + 1) / stripes, low = y - drop;
        const double top[4][3] = { { x0, low, out }, { x1, low, out }, { x1, y, 0 }, { x0, y, 0 } }, hem[4][3] = {
            { x0, low - 0.2, out + 0.02 }, { x1, low - 0.2, out + 0.02 }, { x1, low, out }, { x0, low, out }
        };
        kit_town_paint(b, stripe[k & 1]);
        kit_quad(b, top);
        kit_quad(b, hem);
    }
    kit_colour(b, 0.4, 0.4, 0.4);
    for (int k = 0; k < 2; k++) {
        const double x = k ? width - 0.06 : 0.06,
                     arm[2][3] = { { x, y - drop - 0.3, 0 }, { x, y - drop - 0.03, out - 0.03 } };
        kit_tube(b, arm, 2, 0.014, 5);
    }
}

/* hanging from y = 0, s[0] wide, s[1] long, waves of s[2] from s[3], blown by s[4] */
static void washing_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, deep = 0.01 + 0.05 * v, a = s[2] * u + s[3];
    out->p[0] = s[0] * (u - 0.5);
    out->p[1] = -s[1] * v;
    out->p[2] = deep * sin(a) + s[4] * v * v;
    out->n[0] = -deep * s[2] / s[0] * cos(a);
    out->n[1] = (2 * s[4] * v + 0.05 * sin(a)) / s[1];
    out->n[2] = 1;
    kit_unit(out->n);
}

void kit_town_laundry(kit_build *b, double width)
{
    const double sag = 0.02 * width, from[3] = { 0, 0, 0 }, to[3] = { width, 0, 0 };
    kit_colour(b, 0.5, 0.5, 0.46);
    kit_cable(b, from, to, sag, 0.006, 5);
    for (double x = 0.5, wide; x < width - 0.6; x += wide + kit_between(b, 0.04, 0.5)) {
        wide = kit_between(b, 0.3, 0.9);
        const double cloth[5] = { wide, kit_between(b, 0.4, 1.3), kit_between(b, 5, 14), kit_between(b, 0, 6),
                                  kit_between(b, -0.15, 0.15) };
        const double t = fmin(1, (x + 0.5 * wide) / width);
        KIT_TINT(b, cloths, 0.3);
        kit_place_at(b, x + 0.5 * wide, -4 * sag * t * (1 - t) + 0.01, 0.003, 0);
        kit_patch(b, 12, 4, washing_surface, cloth);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_town_bunting(kit_build *b, double width)
{
    const double sag = 0.06 * width, from[3] = { 0, 0, 0 }, to[3] = { width, 0, 0 };
    kit_colour(b, 0.6, 0.6, 0.56);
    kit_cable(b, from, to, sag, 0.006, 4);
    for (double x = 0.3; x < width - 0.3; x += 0.42) {
        const double t = x / width, y = -4 * sag * t * (1 - t), tip = kit_between(b, -0.1, 0.1);
        const double flag[4][3] = {
            { x + 0.02, y - 0.32, tip }, { x + 0.15, y, 0 }, { x - 0.13, y, 0 }, { x - 0.02, y - 0.32, tip }
        };
        KIT_TINT(b, cloths, 0.3);
        kit_quad(b, flag);
    }
}

/* ---- >>metal --------------------------------------------------------------------------------------------------- */

/* Stairs along x from y0 to y1. */
static void flight(kit_build *b, double x0, double x1, double z0, double z1, double y0, double y1)
{
    const int steps = (int)(fabs(y1 - y0) / 0.2);
    for (int k = 0; k < 2; k++) {
        const double z = k ? z1 : z0, string[2][3] = { { x0, y0, z }, { x1, y1, z } },
                     hand[2][3] = { { x0, y0 + 0.9, z }, { x1, y1 + 0.9, z } };
        kit_tube(b, string, 2, 0.04, 4);
        kit_tube(b, hand, 2, 0.018, 6);
    }
    for (int k = 1; k < steps; k++) {
        const double t = (double)k / steps, x = x0 + t * (x1 - x0), y = y0 + t * (y1 - y0);
        kit_box(b, x - 0.12, y - 0.012, z0, x + 0.12, y + 0.012, z1);
    }
}

void kit_town_fire_escape(kit_build *b, const kit_house *h, double x)
{
    const double wide = 3.6, deep = 1.2;
    const double rail[4][2] = { { x, 0.04 }, { x, deep }, { x + wide, deep }, { x + wide, 0.04 } };
    kit_colour(b, 0.1, 0.1, 0.1);
    for (int f = 1; f < h->floors; f++) {
        const double y = h->ground + h->storey * (f - 1);
        for (int k = 0; k < 12; k++) /* a grating, open where the stair arrives */
            kit_box(b, k < 6 && f > 1 ? x + 0.9 : x, y - 0.03, 0.1 * k + 0.05, x + wide, y, 0.1 * k + 0.09);
        for (int k = 0; k < 3; k++) {
            const double at = x + 0.5 * wide * k, strut[2][3] = { { at, y - 0.9, 0 }, { at, y - 0.05, deep - 0.05 } };
            kit_box(b, at - 0.03, y - 0.1, -0.02, at + 0.03, y - 0.031, deep);
            kit_tube(b, strut, 2, 0.02, 5);
        }
        kit_town_railing(b, rail, 4, y, 0.95, KIT_BARS);
        if (f + 1 < h->floors) flight(b, x + wide - 0.3, x + 0.5, 0.12, 0.62, y, y + h->storey);
    }
    const double ladder = h->ground;
    for (int k = 0; k < 2; k++)
        kit_box(b, x + wide + 0.1 + 0.4 * k, 2, 0.6, x + wide + 0.14 + 0.4 * k, ladder + 1, 0.64);
    for (double y = 2.2; y < ladder + 0.9; y += 0.3)
        kit_box(b, x + wide + 0.14, y, 0.61, x + wide + 0.5, y + 0.025, 0.63);
}

/* one lift of a scaffold: ledgers, planks, toe boards, guard rails */
static void lift(kit_build *b, double width, double y, int left_out)
{
    kit_colour(b, 0.55, 0.56, 0.57);
    for (int k = 0; k < 2; k++) {
        const double z = k ? 1.35 : 0.3, ledger[2][3] = { { -0.2, y, z }, { width + 0.2, y, z } },
                     guard[2][3] = { { -0.1, y + 1.0, z }, { width + 0.1, y + 1.0, z } };
        kit_tube(b, ledger, 2, 0.025, 6);
        if (k) kit_tube(b, guard, 2, 0.025, 6);
    }
    for (int k = 0; k < 4; k++) {
        const double shift = kit_between(b, -0.25, 0.25);
        kit_colour(b, kit_between(b, 0.4, 0.58), 0.4, 0.25);
        if (k == left_out) continue;
        kit_box(b, shift, y + 0.03, 0.34 + 0.25 * k, width + shift, y + 0.07, 0.57 + 0.25 * k);
    }
    kit_box(b, 0, y + 0.071, 1.3, width, y + 0.25, 1.325);
}

void kit_town_scaffold(kit_build *b, double width, double height, int net)
{
    const int bays = (int)fmax(1, floor(width / 2.2 + 0.5)), lifts = (int)fmax(1, floor(height / 2));
    for (int i = 0; i <= bays; i++)
        for (int k = 0; k < 2; k++) {
            const double x = width * i / bays, z = k ? 1.35 : 0.3,
                         pole[2][3] = { { x, 0.02, z }, { x, height + 0.6, z } };
            kit_colour(b, 0.55, 0.56, 0.57);
            kit_tube(b, pole, 2, 0.025, 6);
            kit_box(b, x - 0.1, 0, z - 0.1, x + 0.1, 0.03, z + 0.1);
        }
    for (int j = 1; j <= lifts; j++) {
        lift(b, width, 2 * j - 0.1, kit_choose(b, 9));
        for (int i = 0; i <= bays; i++) {
            const double x = width * i / bays, across[2][3] = { { x, 2 * j - 0.14, 0.05 }, { x, 2 * j - 0.14, 1.5 } },
                         next = width * (i + 1) / bays,
                         brace[2][3] = { { (i + j) & 1 ? x : next, 2 * j - 2, 1.38 },
                                         { (i + j) & 1 ? next : x, 2 * j - 0.1, 1.38 } };
            kit_colour(b, 0.5, 0.5, 0.52);
            kit_tube(b, across, 2, 0.022, 6);
            if (i < bays && (i + j) % 3 == 0) kit_tube(b, brace, 2, 0.022, 6);
        }
    }
    if (!net) return;
    const double from = kit_between(b, 0, 0.5) * width,
                 cloth[5] = { width - from, height - 2, kit_between(b, 12, 30), 1, 0.1 };
    kit_colour(b, 0.2, 0.42, 0.26);
    kit_place_at(b, 0.5 * (width + from), height + 0.2, 1.45, 0);
    kit_patch(b, 60, 12, washing_surface, cloth);
    kit_place_at(b, 0, 0, 0, 0);
}
