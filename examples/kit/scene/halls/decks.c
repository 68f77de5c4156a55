/* decks.c - halls by seed between piers and columns: a parking deck, a temple in the open. Declared in
   halls.h. */
#include "kit/scene/halls/halls.h"
#include <math.h>
#include <string.h>

/* ---- >>parking deck --------------------------------------------------------------------------------------------- */

static void deck_lines(hall *h, double x0, double x1, double z, double pitch)
{
    kit_colour(h->b, 0.75, 0.74, 0.7);
    for (double x = x0; x <= x1 + 1e-6; x += pitch) kit_level(h->b, x - 0.05, z, x + 0.05, z + 4.8, 0.004);
}

void hall_parking(hall *h)
{
    kit_build *b = h->b;
    const int bays = 4 + kit_choose(b, 3), sloped = kit_odds(b, 0.5);
    const double bay = 7.6, x = bay * bays, z = 17, high = kit_between(b, 2.6, 3.3), r[4] = { 0, 0, x, z };
    static const float grey[3] = { 0.42f, 0.42f, 0.41f };
    for (int k = 0; k < 3; k++) h->paint[HALL_FLOOR][k] = 0.6f * grey[k];
    memcpy(h->paint[HALL_WOOD], h->paint[HALL_STONE], sizeof h->paint[HALL_WOOD]);
    h->floor = 0;
    kit_begin_object(b, "ground", 0);
    hall_floor(h, (const double[4]){ -1.2, -1.2, x + 1.2, z + 1.2 });
    hall_shell(h, (const double[4]){ -1.2, -1.2, x + 1.2, z + 1.2 }, -0.05, high + 0.7, 1);
    kit_begin_object(b, "lines", 0);
    for (int side = 0; side < 2; side++) deck_lines(h, 0.4, x - 0.2, side ? z - 5 : 0.2, bay / 3);
    hall_four_walls(h, r, high, bay, HALL_BLANK, sloped ? HALL_WINDOW : HALL_BLANK);
    hall_roof(h, HALL_BEAMS, r, high - 0.5, bays);
    for (int i = 1; i < bays; i++)
        for (int side = 0; side < 2; side++) {
            kit_begin_object(b, "pier", -1);
            const kit_frame f = kit_enter(b, bay * i, 0, side ? z - 5.3 : 5.3, 0, 1);
            hall_paint(h, HALL_STONE);
            kit_bevelled(b, -0.25, 0, -0.25, 0.25, high + 0.3, 0.25, 0.04);
            kit_colour(b, 0.7, 0.55, 0.08);
            for (int k = 0; k < 3; k++) kit_box(b, -0.26, 0.2 + 0.3 * k, -0.26, 0.26, 0.35 + 0.3 * k, 0.26);
            hall_sight(h, 0, 0.6, 0, 1.2);
            kit_leave(b, f);
        }
    for (int i = 0; i < 6 * bays; i++) {
        const double cx = 0.4 + bay / 3 * (i / 2 + 0.5), cz = i & 1 ? z - 2.5 : 2.5;
        if (kit_odds(b, 0.45)) continue;
        kit_begin_object(b, "car", -1);
        const kit_frame f = kit_enter(b, cx, 0, cz + kit_between(b, -0.15, 0.15),
                                      (kit_odds(b, 0.5) ? 90 : 270) + kit_between(b, -3, 3), 1);
        if (cx < x - 1) {
            hall_car(h);
            hall_sight(h, 0, 0.6, 0, 1.6);
        }
        kit_leave(b, f);
    }
    for (int k = 0; k < 4; k++) { /* pipes and trays below the beams */
        const double pz = 4 + 2.9 * k, from[3] = { 0, high - 0.62 - 0.1 * (k & 1), pz }, to[3] = { x, from[1], pz },
                     run[2][3] = { { 0, from[1], pz }, { x, from[1], pz } };
        kit_begin_object(b, "pipe", -1);
        hall_paint(h, HALL_METAL);
        if (k & 1) hall_bar(b, from, to, 0.3, 0.06);
        else kit_tube(b, run, 2, kit_between(b, 0.04, 0.11), 12);
        hall_sight(h, 0.5 * x, from[1], pz, 1.3);
    }
    for (int i = 0; i < bays; i++) {
        kit_begin_object(b, "lamp", -1);
        const kit_frame f = kit_enter(b, bay * (i + 0.5), high - 0.55, 0.5 * z, 0, 1);
        hall_paint(h, HALL_GLASS);
        kit_bevelled(b, -0.7, 0, -0.08, 0.7, 0.08, 0.08, 0.02);
        hall_lamp(h, 0, -0.2, 0);
        kit_leave(b, f);
    }
    h->top = high;
    hall_furnish(h, HALL_BARE, (const double[4]){ 1, 6.2, x - 1, z - 6.2 });
    hall_stand(h, 0.5, 0.5, x - 0.5, z - 0.5, high - 0.6);
}

/* ---- >>temple: a colonnade in the open -------------------------------------------------------------------------- */

static void entablature(hall *h, const double r[4], double y, double wide)
{
    kit_build *b = h->b;
    for (int k = 0; k < 4; k++) {
        const double *s = r,
                     x0 = k < 2  ? s[0] - wide
                        : k == 2 ? s[0] - wide
                                 : s[2] - wide,
                     x1 = k < 2  ? s[2] + wide
                        : k == 2 ? s[0] + wide
                                 : s[2] + wide;
        const double z0 = k == 0 ? s[1] - wide
                        : k == 1 ? s[3] - wide
                                 : s[1] + wide,
                     z1 = k == 0 ? s[1] + wide
                        : k == 1 ? s[3] + wide
                                 : s[3] - wide;
        kit_box(b, x0, y, z0, x1, y + 0.6, z1);
        kit_bevelled(b, x0 - 0.15, y + 0.6, z0 - (k < 2 ? 0.15 : -0.15), x1 + 0.15, y + 0.85,
                     z1 + (k < 2 ? 0.15 : -0.15), 0.05);
        for (double t = 0.2; t < (k < 2 ? x1 - x0 : z1 - z0) - 0.3; t += 0.7)
            for (int side = -1; side < 2; side += 2) {
                const double px = k < 2    ? x0 + t
                                : side < 0 ? x0 - 0.04
                                           : x1 - 0.04,
                             pz = k < 2 ? side < 0 ? z0 - 0.04 : z1 - 0.04 : z0 + t;
                kit_box(b, px, y + 0.25, pz, px + (k < 2 ? 0.3 : 0.08), y + 0.6, pz + (k < 2 ? 0.08 : 0.3));
            }
    }
}

void hall_temple(hall *h)
{
    kit_build *b = h->b;
    const int nx = 5 + kit_choose(b, 4), nz = 3 + kit_choose(b, 2), ruined = kit_odds(b, 0.5);
    const double r = kit_between(b, 0.35, 0.55), bay = r * kit_between(b, 5, 7), tall = r * kit_between(b, 9, 13),
                 x = nx * bay, z = nz * bay;
    const double at[4] = { 0, 0, x, z }, base = 0.66;
    kit_begin_object(b, "ground", 0);
    kit_colour(b, 0.34, 0.31, 0.22);
    kit_level(b, -90, -90, 90 + x, 90 + z, 0);
    kit_begin_object(b, "steps", 0);
    for (int k = 0; k < 3; k++) {
        const double out = 1.8 - 0.4 * k;
        hall_paint(h, HALL_STONE);
        kit_bevelled(b, -out, 0.22 * k - 0.01, -out, x + out, 0.22 * (k + 1), z + out, 0.02);
    }
    for (int i = 0; i <= nx; i++)
        for (int j = 0; j <= nz; j++) {
            if (i % nx && j % nz) continue;
            const double left = ruined && kit_odds(b, 0.3) ? kit_between(b, 0.15, 0.8) : 1;
            kit_begin_object(b, "column", -1);
            const kit_frame f = kit_enter(b, bay * i, base, bay * j, 0, 1);
            hall_paint(h, HALL_STONE);
            if (left < 1) {
                kit_box(b, -1.4 * r, 0, -1.4 * r, 1.4 * r, 0.3 * r, 1.4 * r);
                kit_place_at(b, 0, 0.3 * r, 0, 0);
                kit_cylinder(b, r, left * tall, 24);
            } else hall_column(h, h->column == HALL_IRON ? HALL_FLUTED : h->column, r, tall);
            if ((i + j) % 3 == 0) {
                hall_sight(h, 0, 0.6, 0, 1.5);
                hall_sight(h, 0, left * tall, 0, 1.8);
            }
            kit_leave(b, f);
        }
    hall_overview(h, at, tall);
    kit_begin_object(b, "entablature", 0);
    hall_paint(h, HALL_TRIM);
    if (!ruined) entablature(h, at, base + tall, 1.1 * r);
    if (!ruined) hall_roof(h, kit_odds(b, 0.5) ? HALL_COFFERS : HALL_BEAMS, at, base + tall + 0.45, nx);
    for (int k = 0; k < 26 && ruined; k++) { /* drums and blocks that fell */
        kit_begin_object(b, "drum", -1);
        hall_paint(h, HALL_STONE);
        const double s = r * kit_between(b, 0.5, 1), px = kit_between(b, -5, x + 5),
                     pz = kit_odds(b, 0.5) ? kit_between(b, -6, -2.5) : kit_between(b, z + 2.5, z + 6);
        if (kit_odds(b, 0.5)) {
            kit_place_tilted(b, px, s * 0.95, pz, kit_between(b, 0, 360), 90);
            kit_cylinder(b, s, s * kit_between(b, 0.8, 2.5), 20);
        } else {
            kit_place_tilted(b, px, -0.03, pz, kit_between(b, 0, 360), kit_between(b, -5, 5));
            kit_bevelled(b, -1.3 * s, 0, -0.8 * s, 1.3 * s, s, 0.8 * s, 0.06);
        }
        if (k % 4 == 0) kit_add_sight(h->p, px, s, pz, 1.2);
    }
    kit_place_at(b, 0, 0, 0, 0);
    const kit_frame f = kit_enter(b, 0, base, 0, 0, 1);
    h->top = tall;
    hall_furnish(h, kit_odds(b, 0.5) ? HALL_MUSEUM : HALL_BARE, (const double[4]){ bay, bay, x - bay, z - bay });
    kit_leave(b, f);
    for (int k = 0; k < 14; k++) {
        kit_begin_object(b, "bush", -1);
        const double side = k & 1 ? -1 : 1, px = kit_between(b, -12, x + 12),
                     pz = 0.5 * z + side * (0.5 * z + kit_between(b, 3, 14));
        const kit_frame g = kit_enter(b, px, 0, pz, 0, 1);
        hall_plant(h, kit_between(b, 0.8, 2.2));
        kit_leave(b, g);
        if (k < 4) kit_add_sight(h->p, px, 0.6, pz, 1.2);
    }
    hall_stand(h, -9, -9, x + 9, z + 9, 0);
}
