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

void kit_toys_piece(kit_room *r, const double s[3])
{
    const int theme = r->theme;
    r->theme = KIT_NURSERY;
    room_clutter(r, -0.5 * s[0], 0, 0.5 * s[0], s[2], 0, 0.4, 1.2);
    room_cover(r->b);
    room_ball(r->b, kit_between(r->b, -0.3, 0.3) * s[0], 0.11, s[2] + 0.12, 0.11, 24);
    r->theme = theme;
}
