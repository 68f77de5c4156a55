/* plants.c - plants in rooms: leaves without thickness. Declared in rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>

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
