/* fittings.c - what is fixed to a room's walls and ceiling: windows, blinds, curtains, doors, radiators, lamps.
   Declared in rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>

/* ---- >>windows --------------------------------------------------------------------------------------------------- */

static void bar(kit_build *b, double x0, double y0, double x1, double y1, double z, double deep)
{
    kit_box(b, x0, y0, z, x1, y1, z + deep);
}

/* Frame and bars. */
static void sash(kit_room *r, const kit_opening *o, double z)
{
    kit_build *b = r->b;
    const double f = 0.055;
    const int across = kit_odds(b, 0.6) ? 1 + (int)((o->x1 - o->x0) / kit_between(b, 0.45, 1.2)) : 1,
              down = kit_odds(b, 0.5) ? 1 + (int)((o->y1 - o->y0) / kit_between(b, 0.4, 1.1)) : 1;
    room_paint(b, kit_odds(b, 0.7) ? r->trim : r->metal, 0.1);
    bar(b, o->x0, o->y0, o->x0 + f, o->y1, z, 0.05);
    bar(b, o->x1 - f, o->y0, o->x1, o->y1, z, 0.05);
    bar(b, o->x0 + f, o->y0, o->x1 - f, o->y0 + f, z, 0.05);
    bar(b, o->x0 + f, o->y1 - f, o->x1 - f, o->y1, z, 0.05);
    for (int i = 1; i < across; i++) {
        const double x = o->x0 + (o->x1 - o->x0) * i / across;
        bar(b, x - 0.018, o->y0 + f, x + 0.018, o->y1 - f, z + 0.005, 0.04);
    }
    for (int i = 1; i < down; i++) {
        const double y = o->y0 + (o->y1 - o->y0) * i / down;
        bar(b, o->x0 + f, y - 0.012, o->x1 - f, y + 0.012, z + 0.012, 0.025);
    }
    room_paint(b, r->metal, 0.1);
    room_rod(b, o->x0 + 0.03, 0.5 * (o->y0 + o->y1), z + 0.07, o->x0 + 0.03, 0.5 * (o->y0 + o->y1) + 0.1, z + 0.07,
             0.008);
}

/* Slats on cords before an opening, drawn down so far. */
static void blind(kit_room *r, const kit_opening *o, double z)
{
    kit_build *b = r->b;
    const double x0 = o->x0 + 0.02, x1 = o->x1 - 0.02, x = 0.5 * (x0 + x1), half = 0.5 * (x1 - x0),
                 down = (o->y1 - o->y0) * kit_between(b, 0.25, 1), tilt = kit_between(b, -5, 65),
                 step = kit_between(b, 0.03, 0.055);
    const int thick = kit_odds(b, 0.3);
    const double sheet[4][3] = { { -half, 0, 0.025 }, { half, 0, 0.025 }, { half, 0, -0.025 }, { -half, 0, -0.025 } };
    room_paint(b, kit_odds(b, 0.6) ? r->trim : r->wood, 0.15);
    bar(b, x0, o->y1 - 0.05, x1, o->y1 - 0.005, z - 0.025, 0.05);
    for (double y = o->y1 - 0.07; y > o->y1 - down; y -= step) {
        kit_place_tilted(b, x, y, z, 0, tilt + kit_between(b, -2, 2));
        if (thick) kit_box(b, -half, -0.0015, -0.025, half, 0.0015, 0.025);
        else kit_quad(b, sheet);
    }
    kit_place_at(b, 0, 0, 0, 0);
    bar(b, x0, o->y1 - down - 0.02, x1, o->y1 - down - 0.005, z - 0.02, 0.04);
    for (int i = -1; i <= 1; i += 2)
        room_rod(b, x + 0.7 * i * half, o->y1 - 0.03, z, x + 0.7 * i * half, o->y1 - down, z, 0.0015);
    room_rod(b, x1 - 0.06, o->y1 - 0.03, z + 0.03, x1 - 0.06, o->y1 - down - 0.15, z + 0.03, 0.002);
}

/* half its width, length, folds, phase, how much it is drawn in at its middle */
static void curtain(const double *s, double u, double v, double p[3])
{
    const double wide = 2 * s[0] * (1 - s[4] * exp(-30 * (v - 0.6) * (v - 0.6))),
                 a = 2 * KIT_PI * s[2] * u + 0.9 * sin(6 * u + s[3]);
    p[0] = wide * (u - 0.5) + 0.01 * sin(3 * v + 9 * u);
    p[1] = -s[1] * v + 0.006 * sin(a);
    p[2] = (0.025 + 0.012 * sin(5 * u + s[3]) + 0.022 * v) * sin(a + 0.3 * sin(4 * v));
}

static void curtains(kit_room *r, const kit_opening *o)
{
    kit_build *b = r->b;
    const int long_ones = kit_odds(b, 0.6);
    const double z = long_ones ? 0.22 : 0.12, top = o->y1 + 0.08, bottom = long_ones ? 0.03 : fmax(0.03, o->y0 - 0.09),
                 over = kit_between(b, 0.1, 0.3), wide = (o->x1 - o->x0 + 2 * over) * kit_between(b, 0.1, 0.26),
                 tied = kit_odds(b, 0.3) ? 0.45 : 0;
    room_paint(b, r->metal, 0.1);
    room_rod(b, o->x0 - over, top + 0.02, z, o->x1 + over, top + 0.02, z, 0.011);
    room_ball(b, o->x0 - over - 0.01, top + 0.02, z, 0.025, 10);
    room_ball(b, o->x1 + over + 0.01, top + 0.02, z, 0.025, 10);
    for (int k = -1; k <= 1; k += 2) {
        const double x = k < 0 ? o->x0 - over + 0.03 + wide : o->x1 + over - 0.03 - wide,
                     of[5] = { wide, top - bottom, floor(wide * 2 / 0.1), kit_between(b, 0, 6), tied };
        room_rod(b, x, top + 0.02, z, x, top + 0.02, 0.002, 0.006);
        for (int i = 0; i < 7; i++) room_ring(b, x + wide * (i / 3.0 - 1) * 0.95, top + 0.015, z, 90, 90, 0.022, 0.003);
        room_paint(b, r->cloth, 0.15);
        kit_place_at(b, x, top, z, 0);
        room_cloth(b, (int)fmin(110, 10 * of[2]), 22, curtain, of);
        room_paint(b, r->metal, 0.1);
        kit_place_at(b, 0, 0, 0, 0);
    }
}

static void net(kit_room *r, const kit_opening *o, double z)
{
    const double half = 0.48 * (o->x1 - o->x0), of[5] = { half, 0.9 * (o->y1 - o->y0), floor(half * 18), 2, 0 };
    kit_colour(r->b, 0.82, 0.82, 0.8);
    kit_place_at(r->b, 0.5 * (o->x0 + o->x1), o->y1 - 0.04, z, 0);
    room_cloth(r->b, 120, 8, curtain, of);
    kit_place_at(r->b, 0, 0, 0, 0);
}

static void roller(kit_room *r, const kit_opening *o, double z)
{
    const double down = o->y1 - (o->y1 - o->y0) * kit_between(r->b, 0.15, 0.7);
    const double sheet[4][3] = { { o->x0 + 0.03, down, z },
                                 { o->x1 - 0.03, down, z },
                                 { o->x1 - 0.03, o->y1 - 0.04, z },
                                 { o->x0 + 0.03, o->y1 - 0.04, z } };
    room_paint(r->b, r->accent, 0.2);
    kit_quad(r->b, sheet);
    room_rod(r->b, o->x0 + 0.02, o->y1 - 0.035, z, o->x1 - 0.02, o->y1 - 0.035, z, 0.025);
    room_rod(r->b, o->x0 + 0.03, down, z, o->x1 - 0.03, down, z, 0.008);
}

void room_window(kit_room *r, const kit_opening *o, double thick)
{
    kit_build *b = r->b;
    const double deep = fmax(thick, 0.06), z = thick > 0.1 ? -0.75 * thick : -0.05;
    kit_begin_object(b, "window", -1);
    sash(r, o, z);
    room_paint(b, r->trim, 0.05);
    if (o->y0 > 0.3) {
        kit_bevelled(b, o->x0 - 0.06, o->y0 - 0.035, -deep, o->x1 + 0.06, o->y0 + 0.002, 0.06, 0.006);
        if (thick > 0.15 && kit_odds(b, 0.7)) room_clutter(r, o->x0, z + 0.05, o->x1, 0.05, o->y0 + 0.002, 0.3, 1);
    }
    room_sight_here(r, 0.5 * (o->x0 + o->x1), 0.5 * (o->y0 + o->y1), 0, 0.55 * (o->y1 - o->y0));
    const int dressed = kit_choose(b, 8);
    kit_begin_object(b, "blind", -1);
    if (dressed < 2) blind(r, o, thick > 0.1 ? -0.06 : 0.035);
    if (dressed == 2) roller(r, o, thick > 0.1 ? -0.06 : 0.035);
    if (dressed == 3) net(r, o, thick > 0.12 ? -0.07 : 0.06);
    if (dressed == 3 || dressed == 4 || kit_odds(b, 0.25)) {
        kit_begin_object(b, "curtain", -1);
        curtains(r, o);
    }
}

void room_radiator(kit_room *r, double x0, double x1, double top)
{
    kit_build *b = r->b;
    const int ribs = kit_odds(b, 0.6);
    kit_begin_object(b, "radiator", -1);
    room_paint(b, r->trim, 0.05);
    if (ribs)
        for (double x = x0 + 0.03; x < x1 - 0.03; x += 0.055) {
            const double half[3] = { 0.022, 0.5 * (top - 0.12), 0.045 };
            kit_place_at(b, x, 0.5 * (top + 0.12), 0.1, 0);
            kit_cushion(b, half, 0.3, 8);
        }
    else {
        kit_bevelled(b, x0, 0.14, 0.12, x1, top, 0.14, 0.004);
        kit_box(b, x0, 0.14, 0.06, x1, top, 0.075);
        for (double x = x0 + 0.02; x < x1; x += 0.03) kit_box(b, x, 0.17, 0.076, x + 0.001, top - 0.02, 0.119);
        for (double x = x0 + 0.03; x < x1 - 0.03; x += 0.05) kit_box(b, x, 0.17, 0.14, x + 0.02, top - 0.03, 0.146);
    }
    kit_place_at(b, 0, 0, 0, 0);
    room_rod(b, x0 + 0.02, 0.2, 0.1, x1 - 0.02, 0.2, 0.1, 0.012);
    room_rod(b, x1 - 0.03, 0.2, 0.1, x1 + 0.05, 0.2, 0.1, 0.01);
    room_rod(b, x1 + 0.05, 0, 0.1, x1 + 0.05, 0.2, 0.1, 0.01);
    kit_colour(b, 0.8, 0.8, 0.8);
    room_rod(b, x1 + 0.05, 0.2, 0.1, x1 + 0.05, 0.2, 0.18, 0.02);
    if (!kit_odds(b, 0.25)) return;
    kit_begin_object(b, "cloth", -1);
    room_paint(b, r->cloth, 0.3);
    kit_place_at(b, 0.5 * (x0 + x1), top + 0.005, 0.1, 0);
    room_hang_cloth(b, 0.4 * (x1 - x0), 0.3, 0.02);
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>doors ----------------------------------------------------------------------------------------------------- */

static void leaf(kit_room *r, double w, double h)
{
    kit_build *b = r->b;
    const int rows = 1 + kit_choose(b, 3);
    room_paint(b, kit_odds(b, 0.5) ? r->trim : r->wood, 0.1);
    kit_box(b, 0.004, 0.008, -0.02, w - 0.004, h - 0.004, 0.02);
    for (int i = 0; i < rows * 2; i++) {
        const double x0 = i & 1 ? 0.53 * w : 0.12 * w, y0 = 0.1 + (h - 0.2) * (i / 2) / rows,
                     y1 = y0 + (h - 0.2) / rows - 0.08;
        for (int k = -1; k <= 1; k += 2)
            kit_bevelled(b, x0, y0, k > 0 ? 0.02 : -0.03, x0 + 0.35 * w, y1, k > 0 ? 0.03 : -0.02, 0.004);
    }
    room_paint(b, r->metal, 0.1);
    for (int k = -1; k <= 1; k += 2) {
        room_rod(b, w - 0.07, 1.02, k * 0.02, w - 0.07, 1.02, k * 0.06, 0.009);
        room_rod(b, w - 0.07, 1.02, k * 0.06, w - 0.18, 1.02, k * 0.06, 0.008);
    }
}

void room_door(kit_room *r, const kit_opening *o, double thick, double open)
{
    kit_build *b = r->b;
    const double f = 0.07, out = 0.018;
    kit_begin_object(b, "door frame", -1);
    room_paint(b, r->trim, 0.05);
    kit_box(b, o->x0 - f, 0, -thick, o->x0 + 0.004, o->y1 + f, out);
    kit_box(b, o->x1 - 0.004, 0, -thick, o->x1 + f, o->y1 + f, out);
    kit_box(b, o->x0 + 0.004, o->y1 - 0.004, -thick, o->x1 - 0.004, o->y1 + f, out);
    room_sight_here(r, 0.5 * (o->x0 + o->x1), 1.1, 0, 0.9);
    kit_begin_object(b, "door", -1);
    const kit_frame before = kit_enter(b, o->x0 + 0.006, 0, open < 0 ? out + 0.022 : -thick - 0.022, open, 1);
    leaf(r, o->x1 - o->x0 - 0.012, o->y1 - 0.006);
    kit_leave(b, before);
}

void room_corridor(kit_room *r, const kit_opening *o, double thick)
{
    kit_build *b = r->b;
    const double x0 = o->x0 - 1.1, x1 = o->x1 + 1.1, z = -thick - 0.002, e = z - 1.5, y = o->y1 + 0.35;
    const double wall[4][4][3] = { { { x1, 0, e }, { x0, 0, e }, { x0, y, e }, { x1, y, e } },
                                   { { x0, 0, e }, { x0, 0, z }, { x0, y, z }, { x0, y, e } },
                                   { { x1, 0, z }, { x1, 0, e }, { x1, y, e }, { x1, y, z } },
                                   { { x0, y, e }, { x0, y, z }, { x1, y, z }, { x1, y, e } } };
    kit_begin_object(b, "corridor", 0);
    room_paint(b, r->trim, 0.3);
    for (int i = 0; i < 4; i++) kit_quad(b, wall[i]);
    room_paint(b, r->wood, 0.2);
    kit_level(b, x0, e, x1, -thick, 0);
    const double own[3] = { 0.8, 0.8, 0.3 }, frame[3] = { 0.4, 0.5, 0.03 };
    kit_frame before = kit_enter(b, kit_between(b, o->x0, o->x1), 0, e, 0, 1);
    kit_begin_object(b, "cupboard", -1);
    if (kit_odds(b, 0.6)) kit_cabinet(r, own);
    kit_leave(b, before);
    before = kit_enter(b, 0.5 * (o->x0 + o->x1), 1.4, e, 0, 1);
    kit_picture(r, frame);
    kit_leave(b, before);
    room_lamp_here(r, 0.5 * (o->x0 + o->x1), y - 0.3, e + 0.8);
}

/* ---- >>lamps and ceiling ----------------------------------------------------------------------------------------- */

void room_pendant(kit_room *r, double drop)
{
    kit_build *b = r->b;
    const int style = kit_choose(b, 5);
    const double w = kit_between(b, 0.14, 0.28);
    kit_colour(b, 0.1, 0.1, 0.1);
    room_rod(b, 0, 0, 0, 0, -drop, 0, 0.004);
    kit_place_at(b, 0, -0.03, 0, 0);
    kit_cylinder(b, 0.05, 0.029, 24);
    room_paint(b, style & 1 ? r->trim : r->accent, 0.2);
    kit_place_at(b, 0, -drop, 0, 0);
    if (style == 0) { /* a bell without thickness */
        const kit_moulding bell[] = { { w, -0.8 * w, 0.05, 0, 0.06 }, { 0.05, 0, 0, 0.02, 0 } };
        kit_turned(b, bell, 2, 40);
    } else if (style == 1) { /* a drum */
        const kit_moulding drum[] = { { w, -w, w, 0, 0 } };
        kit_turned(b, drum, 1, 44);
    } else if (style == 2) { /* a globe */
        room_ball(b, 0, -drop - 0.6 * w, 0, 0.6 * w, 24);
    } else if (style == 3) { /* arms with bulbs */
        for (int i = 0; i < 6; i++) {
            const double x = 1.3 * w * cos(1.0472 * i), z = 1.3 * w * sin(1.0472 * i);
            room_rod(b, 0, 0, 0, x, -0.06, z, 0.007);
            room_rod(b, x, -0.06, z, x, 0.02, z, 0.012);
        }
        for (int i = 0; i < 6; i++)
            room_ball(b, 1.3 * w * cos(1.0472 * i), -drop + 0.05, 1.3 * w * sin(1.0472 * i), 0.03, 10);
    } else
        for (int i = 0; i < 7; i++) { /* rings of paper */
            const double a = KIT_PI * (i + 0.5) / 7;
            room_ring(b, 0, -drop - w + w * cos(a), 0, 0, 0, 1.1 * w * sin(a) + 0.02, 0.012);
        }
    kit_place_at(b, 0, 0, 0, 0);
    if (style < 2) {
        kit_colour(b, 0.85, 0.83, 0.75);
        room_ball(b, 0, -drop - 0.35 * w, 0, 0.04, 12);
    }
    room_sight_here(r, 0, -drop, 0, 1.6 * w);
    room_lamp_here(r, 0, -drop - (style == 2 || style == 4 ? 2.1 : 1.1) * w, 0);
}

/* Blades about a shaft. */
static void fan(kit_room *r)
{
    kit_build *b = r->b;
    kit_begin_object(b, "fan", -1);
    room_paint(b, r->metal, 0.2);
    room_rod(b, 0, 0, 0, 0, -0.3, 0, 0.012);
    kit_place_at(b, 0, -0.38, 0, 0);
    kit_cylinder(b, 0.1, 0.1, 28);
    room_paint(b, r->wood, 0.1);
    for (int i = 0; i < 4; i++) {
        kit_place_tilted(b, 0.1 * sin(1.5708 * i), -0.33, 0.1 * cos(1.5708 * i), 90 * i, 2);
        kit_box(b, -0.06, -0.004, 0, 0.06, 0.004, 0.55);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* A string of bulbs from wall to wall. */
static void bulbs(kit_room *r)
{
    kit_build *b = r->b;
    const double x = 0.5 * r->size[0] - 0.02, z = kit_between(b, -0.35, 0.35) * r->size[2],
                 sag = kit_between(b, 0.1, 0.3), y = -0.12;
    const double from[3] = { -x, y, z }, to[3] = { x, y, -0.6 * z };
    kit_begin_object(b, "bulbs", -1);
    kit_colour(b, 0.1, 0.1, 0.1);
    kit_cable(b, from, to, sag, 0.004, 6);
    for (int i = 1; i < 14; i++) {
        const double t = i / 14.0, h = y - 4 * sag * t * (1 - t);
        kit_colour(b, 0.1, 0.1, 0.1);
        room_rod(b, (2 * t - 1) * x, h, z * (1 - 1.6 * t), (2 * t - 1) * x, h - 0.04, z * (1 - 1.6 * t), 0.01);
        kit_colour(b, 0.85, 0.8, 0.6);
        room_ball(b, (2 * t - 1) * x, h - 0.065, z * (1 - 1.6 * t), 0.028, 10);
    }
}

static void beams(kit_room *r)
{
    kit_build *b = r->b;
    const double step = kit_between(b, 0.6, 1.3), w = kit_between(b, 0.05, 0.1), h = kit_between(b, 0.1, 0.22);
    kit_begin_object(b, "beams", -1);
    for (double z = -0.5 * r->size[2] + 0.5 * step; z < 0.5 * r->size[2] - w; z += step) {
        room_paint(b, r->wood, 0.2);
        kit_bevelled(b, -0.5 * r->size[0] + 0.001, -h, z - w, 0.5 * r->size[0] - 0.001, -0.001, z + w, 0.008);
    }
}

static void pipes(kit_room *r)
{
    kit_build *b = r->b;
    const double x = 0.5 * r->size[0] - 0.01, z = kit_between(b, -0.3, 0.3) * r->size[2];
    kit_begin_object(b, "pipes", -1);
    for (int i = 0; i < 4; i++) {
        const double w = i ? 0.018 : kit_between(b, 0.06, 0.14), at = z + 0.16 * i + (i ? 0.1 : 0), y = -0.06 - w;
        room_paint(b, i == 2 ? r->accent : r->metal, 0.2);
        room_rod(b, -x, y, at, x, y, at, w);
        for (double e = -x + 0.4; e < x; e += 1.3) {
            room_ring(b, e, y, at, 90, 90, w, 0.008);
            room_rod(b, e, y + w, at, e, -0.002, at, 0.004);
        }
    }
}

/* A rail with spots. */
static void spots(kit_room *r)
{
    kit_build *b = r->b;
    const double x = 0.35 * r->size[0], z = kit_between(b, -0.25, 0.25) * r->size[2];
    kit_begin_object(b, "spots", -1);
    kit_colour(b, 0.12, 0.12, 0.12);
    kit_box(b, -x, -0.03, z - 0.015, x, -0.001, z + 0.015);
    for (int i = 0; i < 5; i++) {
        kit_place_tilted(b, x * (0.45 * i - 0.9), -0.16, z, kit_between(b, 0, 360), kit_between(b, 10, 40));
        const kit_moulding can[] = { { 0.035, -0.08, 0.04, -0.08, 0 },
                                     { 0.04, -0.08, 0.04, 0.05, 0 },
                                     { 0.04, 0.05, 0, 0.06, 0 },
                                     { 0, -0.04, 0.035, -0.08, 0 } };
        kit_turned(b, can, 4, 22);
        kit_place_at(b, x * (0.45 * i - 0.9), -0.16, z, 0);
        room_rod(b, 0, 0, 0, 0, 0.135, 0, 0.008);
    }
    kit_place_at(b, 0, 0, 0, 0);
    room_lamp_here(r, 0, -0.4, z);
}

/* In a frame at the ceiling's middle. */
void room_ceiling_things(kit_room *r)
{
    kit_build *b = r->b;
    const int style = kit_choose(b, 7), count = 1 + (int)(r->size[0] / 3.2);
    if (style == 0) fan(r);
    if (style == 1) bulbs(r);
    if (style == 2 || (style == 5 && kit_odds(b, 0.5))) beams(r);
    if (style == 3 || (r->theme == KIT_SHOP && kit_odds(b, 0.5))) pipes(r);
    if (style == 4) spots(r);
    for (int i = 0; i < count && style != 0; i++) {
        const double x = r->size[0] * ((i + 0.5) / count - 0.5), z = kit_between(b, -0.2, 0.2) * r->size[2];
        const kit_frame before = kit_enter(b, x, -0.002, z, 0, 1);
        kit_begin_object(b, "lamp", -1);
        room_pendant(r, kit_between(b, 0.25, 0.3 * r->size[1]));
        kit_leave(b, before);
    }
}
