/* things.c - what stands in halls by seed: pews, stalls, plinths, books, racks, cars. Declared in
   halls.h. */
#include "kit/scene/halls/halls.h"
#include <math.h>

/* ---- >>single things --------------------------------------------------------------------------------------------- */

/* along x, about the origin, looks along z */
void hall_bench(hall *h, double length, int back)
{
    kit_build *b = h->b;
    const double w = 0.5 * length;
    hall_paint(h, HALL_WOOD);
    for (int side = -1; side < 2; side += 2) {
        const double x = side * (w - 0.04);
        kit_bevelled(b, x - 0.035, 0, -0.24, x + 0.035, back ? 0.62 : 0.41, 0.22, 0.01);
        if (back) kit_box(b, x - 0.03, 0.6, -0.27, x + 0.03, 1.0, -0.17);
    }
    kit_bevelled(b, -w + 0.08, 0.41, -0.2, w - 0.08, 0.45, 0.24, 0.01);
    if (!back) return;
    for (int k = 0; k < 3; k++) kit_box(b, -w + 0.08, 0.52 + 0.16 * k, -0.24, w - 0.08, 0.64 + 0.16 * k, -0.21);
    kit_bevelled(b, -w + 0.05, 0.98, -0.29, w - 0.05, 1.03, -0.16, 0.012);
    kit_box(b, -w + 0.08, 0.7, -0.42, w - 0.08, 0.72, -0.24); /* a shelf for books behind */
}

void hall_chair(hall *h)
{
    kit_build *b = h->b;
    hall_paint(h, HALL_WOOD);
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? 0.19 : -0.19, z = k & 2 ? 0.19 : -0.19;
        kit_box(b, x - 0.018, 0, z - 0.018, x + 0.018, k & 2 ? 0.43 : 0.95, z + 0.018);
    }
    for (int k = 0; k < 3; k++) kit_box(b, -0.17, 0.6 + 0.13 * k, -0.2, 0.17, 0.66 + 0.13 * k, -0.18);
    hall_paint(h, HALL_SECOND);
    kit_bevelled(b, -0.22, 0.43, -0.17, 0.22, 0.48, 0.22, 0.012);
}

void hall_table(hall *h, double length, double width)
{
    kit_build *b = h->b;
    const double x = 0.5 * length, z = 0.5 * width;
    hall_paint(h, HALL_WOOD);
    kit_bevelled(b, -x, 0.72, -z, x, 0.76, z, 0.01);
    kit_box(b, -x + 0.08, 0.62, -z + 0.08, x - 0.08, 0.72, -z + 0.1);
    kit_box(b, -x + 0.08, 0.62, z - 0.1, x - 0.08, 0.72, z - 0.08);
    static const kit_moulding leg[] = { { 0.03, 0, 0.045, 0.2, 0 },
                                        { 0.045, 0.2, 0.03, 0.5, 0.01 },
                                        { 0.05, 0.5, 0.05, 0.72, 0 } };
    for (int k = 0; k < 4; k++) {
        kit_place_at(b, k & 1 ? x - 0.1 : 0.1 - x, 0, k & 2 ? z - 0.1 : 0.1 - z, 0);
        kit_turned(b, leg, 3, 8);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

void hall_bookcase(hall *h, double width, double height)
{
    kit_build *b = h->b;
    const int shelves = (int)(height / 0.42);
    const double w = 0.5 * width, pitch = height / shelves;
    hall_paint(h, HALL_WOOD);
    for (int side = -1; side < 2; side += 2) kit_box(b, side * w - 0.03, 0, 0, side * w + 0.03, height, 0.36);
    kit_box(b, -w + 0.03, 0, 0, w - 0.03, height, 0.02);
    for (int k = 0; k <= shelves; k++) {
        const double y = pitch * k * 0.985;
        hall_paint(h, HALL_WOOD);
        kit_box(b, -w + 0.03, y, 0.02, w - 0.03, y + 0.03, 0.35);
        for (double x = -w + 0.035, wide; k < shelves && x < w - 0.1; x += wide + 0.002) {
            const double tall = kit_between(b, 0.55, 0.85) * pitch, tone = kit_between(b, 0.12, 0.5);
            wide = kit_between(b, 0.03, 0.1);
            if (kit_odds(b, 0.07)) {
                wide = kit_between(b, 0.1, 0.3);
                continue;
            }
            kit_colour(b, tone, tone * kit_between(b, 0.4, 0.9), tone * kit_between(b, 0.3, 0.9));
            if (x + wide < w - 0.04)
                kit_box(b, x, y + 0.031, 0.1 + 0.08 * kit_chance(b), x + wide, y + 0.03 + tall, 0.33);
        }
    }
    hall_paint(h, HALL_WOOD);
    kit_bevelled(b, -w - 0.07, height, -0.02, w + 0.07, height + 0.14, 0.43, 0.04);
}

/* fruit in boxes, or bales and jars, on trestles below an awning */
void hall_stall(hall *h)
{
    kit_build *b = h->b;
    static const float fruits[][3] = {
        { 0.7f, 0.35f, 0.06f }, { 0.6f, 0.1f, 0.07f }, { 0.25f, 0.45f, 0.1f }, { 0.72f, 0.62f, 0.15f }
    };
    const double wide = kit_between(b, 1.1, 1.6), tall = kit_between(b, 2.1, 2.6);
    hall_paint(h, HALL_WOOD);
    for (int k = 0; k < 4; k++) {
        const double x = k & 1 ? wide : -wide, z = k & 2 ? 0.7 : -0.7;
        kit_box(b, x - 0.03, 0, z - 0.03, x + 0.03, k & 2 ? tall : tall + 0.5, z + 0.03);
    }
    const double rods[2][2][3] = { { { -wide, tall + 0.5, -0.7 }, { wide, tall + 0.5, -0.7 } },
                                   { { -wide, tall, 0.7 }, { wide, tall, 0.7 } } };
    for (int k = 0; k < 2; k++) kit_tube(b, rods[k], 2, 0.02, 6);
    kit_box(b, -wide, 0.7, -0.6, wide, 0.74, 0.66);
    for (int k = 0; k < 8; k++) { /* the awning: stripes of one sheet, sagging */
        const double x0 = wide * (k / 4.0 - 1) * 1.08, x1 = wide * ((k + 1) / 4.0 - 1) * 1.08;
        hall_paint(h, k & 1 ? HALL_CLOTH : HALL_TRIM);
        for (int j = 0; j < 4; j++) {
            const double t0 = j / 4.0, t1 = (j + 1) / 4.0, y0 = tall + 0.53 - 0.5 * t0 - 0.4 * t0 * (1 - t0),
                         y1 = tall + 0.53 - 0.5 * t1 - 0.4 * t1 * (1 - t1);
            const double q[4][3] = { { x0, y1, 1.5 * t1 - 0.75 },
                                     { x1, y1, 1.5 * t1 - 0.75 },
                                     { x1, y0, 1.5 * t0 - 0.75 },
                                     { x0, y0, 1.5 * t0 - 0.75 } };
            kit_quad(b, q);
        }
        const double hem[4][3] = {
            { x0, tall - 0.2, 0.77 }, { x1, tall - 0.2, 0.77 }, { x1, tall + 0.03, 0.75 }, { x0, tall + 0.03, 0.75 }
        };
        kit_quad(b, hem);
    }
    const int boxes = (int)(wide * 4);
    for (int i = 0; i < boxes; i++) {
        const double x = -wide + 0.04 + 2 * wide * i / boxes, e = x + 2 * wide / boxes - 0.05,
                     r = kit_between(b, 0.04, 0.075);
        for (int row = 0; row < 2; row++) {
            const double z = -0.5 + 0.56 * row, y = 0.742 + 0.12 * (1 - row);
            hall_paint(h, HALL_WOOD);
            kit_box(b, x, y, z, e, y + 0.03, z + 0.5);
            kit_box(b, x, y + 0.03, z, x + 0.015, y + 0.14, z + 0.5);
            kit_box(b, e - 0.015, y + 0.03, z, e, y + 0.14, z + 0.5);
            kit_box(b, x + 0.015, y + 0.03, z + 0.485, e - 0.015, y + 0.14, z + 0.5);
            KIT_TINT(b, fruits, 0.1);
            for (int k = 0; k < 16; k++) {
                kit_place_at(b, kit_between(b, x + 0.03 + r, e - 0.03 - r), y + 0.06 + 0.1 * kit_chance(b),
                             z + kit_between(b, 0.08, 0.42), 0);
                kit_patch(b, 6, 3, kit_sphere_surface, &r);
            }
            kit_place_at(b, 0, 0, 0, 0);
        }
    }
}

void hall_crates(hall *h)
{
    kit_build *b = h->b;
    const int stack = 1 + kit_choose(b, 3);
    double y = 0;
    for (int k = 0; k < stack; k++) {
        const double s = kit_between(b, 0.25, 0.5) * (1 - 0.15 * k), tall = kit_between(b, 0.3, 0.8) * s * 2;
        hall_paint(h, HALL_WOOD);
        kit_place_at(b, kit_between(b, -0.06, 0.06), y, kit_between(b, -0.06, 0.06), kit_between(b, -20, 20));
        kit_box(b, -s + 0.02, 0.02, -s + 0.02, s - 0.02, tall - 0.02, s - 0.02);
        for (int side = 0; side < 8; side++) {
            const double z = side & 2 ? s : -s, a = side & 4 ? tall - 0.08 : 0;
            if (side & 1) kit_box(b, -s, a, fmin(z, z * 0.94), s, a + 0.08, fmax(z, z * 0.94));
            else kit_box(b, fmin(z, 0.94 * z), a + 0.001, 0.935 * -s, fmax(z, 0.94 * z), a + 0.079, 0.935 * s);
        }
        y += tall + KIT_GAP;
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* steel uprights, beams, pallets with boxes; along x from 0 */
void hall_rack(hall *h, double length, double height)
{
    kit_build *b = h->b;
    const int bays = (int)fmax(1, length / 2.7), levels = (int)fmax(2, height / 1.6);
    const double bay = length / bays;
    static const float cards[][3] = {
        { 0.56f, 0.42f, 0.27f }, { 0.62f, 0.5f, 0.36f }, { 0.7f, 0.7f, 0.68f }, { 0.25f, 0.35f, 0.5f }
    };
    for (int i = 0; i <= bays; i++)
        for (int side = 0; side < 2; side++) {
            const double x = bay * i, z = side ? 1.0 : 0;
            kit_colour(b, 0.12, 0.2, 0.42);
            kit_box(b, x - 0.05, 0, z - 0.04, x + 0.05, height, z + 0.04);
            for (int k = 0; k < 2 * levels && !side; k++) {
                const double y = height * (k + 0.1) / (2 * levels), from[3] = { x, y, k & 1 ? 0 : 1 },
                             to[3] = { x, y + 0.7, k & 1 ? 1 : 0 };
                if (y + 0.7 < height) hall_bar(b, from, to, 0.03, 0.04);
            }
        }
    for (int i = 0; i < bays; i++)
        for (int k = 0; k < levels; k++) {
            const double x = bay * i, y = 0.14 + (height - 0.2) * k / levels, room = (height - 0.2) / levels - 0.45;
            kit_colour(b, 0.65, 0.28, 0.06);
            for (int side = 0; side < 2 && k; side++)
                kit_box(b, x + 0.05, y - 0.12, side - 0.03, x + bay - 0.05, y - KIT_GAP, side + 0.03);
            for (int n = 0; n < 2; n++) {
                const double px = x + 0.14 + n * (bay - 0.2) / 2, wide = 0.5 * bay - 0.2;
                if (kit_odds(b, 0.15)) continue;
                kit_colour(b, 0.5, 0.38, 0.24);
                for (int m = 0; m < 3; m++) kit_box(b, px, y, 0.02 + 0.44 * m, px + wide, y + 0.1, 0.1 + 0.44 * m);
                for (int m = 0; m < 6; m++)
                    kit_box(b, px + wide * m / 6, y + 0.1, 0, px + wide * (m + 0.75) / 6, y + 0.12, 1);
                KIT_TINT(b, cards, 0.12);
                const int nx = 1 + kit_choose(b, 3), ny = 1 + kit_choose(b, 3);
                const double tall = fmin(1.4, room) * kit_between(b, 0.5, 0.95) / ny;
                for (int m = 0; m < nx * ny; m++) {
                    const double bx = px + wide * (m % nx) / nx, by = y + 0.121 + tall * (m / nx),
                                 in = 0.01 + 0.03 * kit_chance(b);
                    kit_box(b, bx + in, by, 0.05 + in, bx + wide / nx - 0.01, by + tall - 0.005, 0.95 - 0.5 * in);
                }
            }
        }
}

/* an outline of a car's side, blown up: narrower above */
void hall_car(hall *h)
{
    kit_build *b = h->b;
    static const float paints[][3] = { { 0.55f, 0.06f, 0.05f }, { 0.06f, 0.12f, 0.3f },  { 0.7f, 0.7f, 0.7f },
                                       { 0.1f, 0.1f, 0.11f },   { 0.35f, 0.36f, 0.38f }, { 0.5f, 0.42f, 0.15f } };
    static const double side[][3] = { { -2.1, 0.45, 0.8 },   { -2.05, 0.85, 0.82 }, { -1.7, 0.95, 0.84 },
                                      { -1.15, 1.38, 0.66 }, { 0.35, 1.42, 0.66 },  { 1.05, 0.98, 0.82 },
                                      { 1.95, 0.8, 0.8 },    { 2.15, 0.5, 0.76 } };

    enum { N = sizeof side / sizeof *side };

    KIT_TINT(b, paints, 0.1);
    const float paint[3] = { b->albedo[0], b->albedo[1], b->albedo[2] };
    for (int k = 0; k + 1 < N; k++) {
        const double *p = side[k], *q = side[k + 1];
        const double over[4][3] = {
            { p[0], p[1], p[2] }, { q[0], q[1], q[2] }, { q[0], q[1], -q[2] }, { p[0], p[1], -p[2] }
        };
        const int glass = k == 2 || k == 4;
        if (glass) kit_colour(b, 0.05, 0.06, 0.07);
        kit_quad(b, over);
        kit_colour(b, (double)paint[0], (double)paint[1], (double)paint[2]);
        for (int s = -1; s < 2; s += 2) {
            const double wall[4][3] = {
                { p[0], 0.28, 0.84 * s }, { q[0], 0.28, 0.84 * s }, { q[0], q[1], q[2] * s }, { p[0], p[1], p[2] * s }
            };
            const double other[4][3] = {
                { p[0], p[1], p[2] * s }, { q[0], q[1], q[2] * s }, { q[0], 0.28, 0.84 * s }, { p[0], 0.28, 0.84 * s }
            };
            kit_quad(b, s > 0 ? wall : other);
        }
    }
    kit_colour(b, 0.04, 0.04, 0.04);
    kit_box(b, -2.12, 0.24, -0.8, 2.14, 0.5, 0.8);
    for (int k = 0; k < 4; k++) {
        kit_place_tilted(b, k & 1 ? 1.35 : -1.35, 0.31, k & 2 ? 0.66 : -0.86, 0, 90);
        kit_colour(b, 0.04, 0.04, 0.04);
        kit_cylinder(b, 0.31, 0.2, 20);
        kit_place_tilted(b, k & 1 ? 1.35 : -1.35, 0.31, k & 2 ? 0.86 : -0.87, 0, 90);
        kit_colour(b, 0.5, 0.5, 0.5);
        kit_cylinder(b, 0.18, 0.015, 12);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* what stands on it is drawn, too */
void hall_plinth(hall *h, double w, double height)
{
    kit_build *b = h->b;
    const int which = kit_choose(b, 5);
    const double s = 0.5 * w;
    static const double ring[2] = { 0.35, 0.12 };
    hall_paint(h, HALL_TRIM);
    kit_bevelled(b, -1.15 * s, 0, -1.15 * s, 1.15 * s, 0.12, 1.15 * s, 0.02);
    kit_box(b, -s, 0.11, -s, s, height - 0.06, s);
    kit_bevelled(b, -1.1 * s, height - 0.07, -1.1 * s, 1.1 * s, height, 1.1 * s, 0.015);
    const kit_frame f = kit_enter(b, 0, height + KIT_GAP, 0, kit_between(b, -40, 40), 1);
    if (which == 0) hall_bust(h, 0.75);
    else if (which == 1) hall_statue(h, kit_between(b, 0.9, 1.9));
    else if (which == 4) {
        hall_paint(h, HALL_METAL);
        kit_place_tilted(b, 0, 0.46, 0, 0, 78);
        kit_patch(b, 40, 20, kit_torus_surface, ring);
    } else hall_vase(h, kit_between(b, 0.4, 1.1));
    kit_leave(b, f);
    hall_sight(h, 0, height + 0.3, 0, 0.8);
}
