/* shelves.c - what shelves hold, plants, boxes, toys. Declared in rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>

/* ---- >>shelves --------------------------------------------------------------------------------------------------- */

static void books(kit_room *r, double width, double depth, double high)
{
    kit_build *b = r->b;
    const double tall = kit_between(b, 0.75, 0.97) * fmin(high, 0.36);
    for (double x = 0.004, w; x < width - 0.03; x += w + KIT_GAP) {
        const double h = tall * kit_between(b, 0.75, 1), d = fmin(depth - 0.01, h * kit_between(b, 0.6, 0.75)),
                     lean = kit_chance(b) < 0.06 ? kit_between(b, 6, 16) : 0, a = lean * KIT_PI / 180;
        w = kit_between(b, 0.012, 0.05);
        if (kit_odds(b, 0.03)) {
            x += kit_between(b, 0.03, 0.15);
            continue;
        }
        if (x + w + h * sin(a) > width) break;
        room_cover(b);
        kit_place_at(b, x, KIT_GAP, 0.5 * depth - 0.5 * d, 0);
        if (lean > 0) { /* leaning back to the left: a sheared box */
            const double s = h * sin(a), q[4][2] = { { s, 0 }, { s + w, 0 }, { w, h * cos(a) }, { 0, h * cos(a) } };
            for (int i = 0; i < 4; i++) {
                const double *m = q[i], *n = q[(i + 1) % 4];
                const double side[4][3] = {
                    { m[0], m[1], d }, { m[0], m[1], 0 }, { n[0], n[1], 0 }, { n[0], n[1], d }
                };
                kit_quad(b, side);
            }
            for (int i = 0; i < 2; i++) {
                double end[4][3];
                for (int k = 0; k < 4; k++) {
                    const double *m = q[i ? k : 3 - k];
                    end[k][0] = m[0];
                    end[k][1] = m[1];
                    end[k][2] = i ? d : 0;
                }
                kit_quad(b, (const double(*)[3])end);
            }
            x += s;
        } else kit_box(b, 0, 0, 0, w, h, d);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void files_and_boxes(kit_room *r, double width, double depth, double high)
{
    kit_build *b = r->b;
    const double h = fmin(0.85 * high, 0.32), d = fmin(depth - 0.02, 0.3);
    const int binders = kit_odds(b, 0.5);
    for (double x = 0.01, w; x < width; x += w + (binders ? 0.002 : kit_between(b, 0.01, 0.12))) {
        w = binders ? kit_between(b, 0.05, 0.08) : kit_between(b, 0.18, 0.4);
        if (x + w > width - 0.005) break;
        if (binders || kit_odds(b, 0.5)) room_cover(b);
        else kit_colour(b, 0.5, 0.37, 0.23);
        const double high_one = binders ? h : h * kit_between(b, 0.4, 1);
        kit_box(b, x, KIT_GAP, 0.01, x + w, high_one, d);
        kit_colour(b, 0.8, 0.8, 0.76);
        if (binders) kit_box(b, x + 0.01, 0.45 * h, d, x + w - 0.01, 0.8 * h, d + 0.001);
        else kit_box(b, x - 0.004, high_one - 0.05, 0.006, x + w + 0.004, high_one + 0.004, d + 0.004);
    }
}

void room_fill_shelf(kit_room *r, double width, double depth, double high)
{
    kit_build *b = r->b;
    const double kind = kit_chance(b), part = kit_between(b, 0.35, 1);
    const int reading = r->theme & (KIT_HOME | KIT_NURSERY) || (r->theme & KIT_OFFICE && kit_odds(b, 0.4));
    if (high < 0.12 || kit_odds(b, 0.08)) return;
    if (reading && kind < 0.66) {
        books(r, part * width, depth, high);
        if (part < 0.75) room_clutter(r, part * width, 0.01, width, depth, 0, high, 0.7 + 3 * r->clutter);
    } else if (r->theme & (KIT_OFFICE | KIT_SHOP) && kind < 0.6) files_and_boxes(r, width, depth, high);
    else
        for (double x = 0; x < width - 0.2; x += 0.32)
            room_clutter(r, x, 0.01, fmin(width, x + 0.3), depth, 0, high, 0.5 + r->clutter);
}

/* ---- >>on the floor ---------------------------------------------------------------------------------------------- */

/* Leaves about a stem's end. */
static void leaves(kit_build *b, double height, int style)
{
    const int many = style == 0 ? 9 : style == 1 ? 26 : style == 2 ? 12 : 60;
    for (int i = 0; i < many; i++) {
        const double turn = 137.5 * i + kit_between(b, -20, 20), up = kit_between(b, 0.25, 1), a = turn * KIT_PI / 180,
                     out = style == 0 || style == 3 ? 0.3 * height * kit_between(b, 0.2, 1) : 0.02 * height;
        const double x = out * sin(a),
                     y = style == 1 ? 0.55 * height
                       : style == 2 ? 0
                                    : (0.35 + 0.55 * up) * height,
                     z = out * cos(a);
        kit_colour(b, 0.13 * kit_between(b, 0.7, 1.4), 0.28 * kit_between(b, 0.7, 1.3), 0.08);
        if (style == 0) room_rod(b, 0, 0.1 * height, 0, x, y, z, 0.006 * height);
        kit_place_tilted(b, x, y, z, turn, style == 2 ? -kit_between(b, 72, 90) : -kit_between(b, 5, 65));
        if (style == 0) kit_leaf(b, 0.26 * height, 0.38 * height, 1.1, 7, 1);
        else if (style == 1) kit_leaf(b, 0.04 * height, 0.55 * height, 1.9, 9, 1);
        else if (style == 2) kit_leaf(b, 0.09 * height, height * kit_between(b, 0.6, 1), 0.3, 6, 1);
        else kit_leaf(b, 0.09 * height, 0.13 * height, 0.6, 3, 1);
        kit_place_at(b, 0, 0, 0, 0);
        if (style == 3) room_rod(b, 0, 0.2 * height, 0, x, y, z, 0.003 * height);
    }
}

void room_plant(kit_room *r, double height)
{
    kit_build *b = r->b;
    const double pot = 0.13 * height + 0.025, deep = 1.5 * pot;
    if (kit_odds(b, 0.5)) kit_colour(b, 0.55, 0.27, 0.17);
    else room_cover(b);
    room_vessel(b, 0, 0, 0, 0.72 * pot, pot, deep, kit_odds(b, 0.4) ? 0.02 * height : 0);
    kit_colour(b, 0.12, 0.08, 0.05);
    kit_place_at(b, 0, 0.8 * deep, 0, 0);
    kit_cylinder(b, 0.86 * pot, 0.02 * height, 24);
    kit_place_at(b, 0, 0, 0, 0);
    const int style = kit_choose(b, 4);
    const kit_frame before = kit_enter(b, 0, 0.8 * deep, 0, kit_between(b, 0, 360), 1);
    kit_colour(b, 0.28, 0.2, 0.12);
    if (style == 1 || style == 3) room_rod(b, 0, 0, 0, 0, 0.57 * height, 0, 0.016 * height);
    leaves(b, height - 0.8 * deep, style);
    kit_leave(b, before);
}

void kit_plant_piece(kit_room *r, const double s[3])
{
    const kit_frame before = kit_enter(r->b, 0, 0, 0.5 * s[2], 0, 1);
    room_plant(r, s[1]);
    kit_leave(r->b, before);
}

void kit_toys_piece(kit_room *r, const double s[3])
{
    const int theme = r->theme;
    r->theme = KIT_NURSERY;
    room_clutter(r, -0.5 * s[0], 0, 0.5 * s[0], s[2], 0, 0.4, 1.2);
    room_cover(r->b);
    room_ball(r->b, kit_between(r->b, -0.3, 0.3) * s[0], 0.11, s[2] + 0.12, 0.11, 24);
    r->theme = theme;
}
