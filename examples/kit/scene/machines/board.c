/* board.c - a circuit board: chips, cans, coils, connectors, heat sinks. Declared in machines.h. */
#include "kit/scene/machines/machines.h"
#include <math.h>

/* a chip with bent legs on two sides or on four */
static void chip(kit_build *b, double w, double d)
{
    const double pitch = 0.03, h = 0.035;
    kit_colour(b, 0.07, 0.07, 0.075);
    kit_bevelled(b, -w, 0.008, -d, w, h, d, 0.006);
    kit_colour(b, 0.62, 0.62, 0.6);
    for (int side = 0; side < (d > 0.7 * w ? 4 : 2); side++) {
        const double half = side < 2 ? d : w, run = side < 2 ? w : d, s = side & 1 ? -1 : 1;
        for (double t = 0.02 - run; t < run - 0.015; t += pitch) {
            const double in = s * half, out = s * (half + 0.022);
            const double lead[3][3] = { { side < 2 ? t : in, 0.02, side < 2 ? in : t },
                                        { side < 2 ? t : out, 0.019, side < 2 ? out : t },
                                        { side < 2 ? t : out + 0.01 * s, 0, side < 2 ? out + 0.01 * s : t } };
            kit_tube(b, lead, 3, 0.005, 4);
        }
    }
}

static void heat_sink(kit_build *b, double w, double d)
{
    const int fins = (int)(2 * w / 0.035), pins = kit_odds(b, 0.35);
    const double h = kit_between(b, 0.12, 0.3);
    plant_stuff(b, kit_odds(b, 0.4) ? KIT_DARK : KIT_STEEL);
    kit_box(b, -w, 0.001, -d, w, 0.035, d);
    for (int k = 0; k < fins; k++) {
        const double x = -w + 0.006 + (2 * w - 0.02) * k / (fins - 1);
        if (!pins) kit_box(b, x, 0.035, -d, x + 0.008, h, d);
        for (double z = -d; z < d - 0.02 && pins; z += 0.045) kit_box(b, x, 0.035, z, x + 0.014, h, z + 0.014);
    }
}

static void can(kit_build *b, double r, double h)
{
    const kit_moulding m[] = { { 0, 0.004, r, 0.004, 0 },
                               { r, 0.004, r, 0.15 * h, 0 },
                               { r, 0.15 * h, 0.92 * r, 0.19 * h, 0 },
                               { 0.92 * r, 0.19 * h, r, 0.23 * h, 0 },
                               { r, 0.23 * h, r, 0.96 * h, 0 },
                               { r, 0.96 * h, 0.9 * r, h, 0 },
                               { 0.9 * r, h, 0, 0.98 * h, 0 } };
    plant_stuff(b, kit_odds(b, 0.5) ? KIT_DARK : KIT_PLASTIC);
    kit_turned(b, m, 6, 18);
    kit_colour(b, 0.7, 0.7, 0.7);
    kit_turned(b, m + 6, 1, 18);
}

/* a shell without thickness, open above, with pins in it */
static void connector(kit_build *b, double w)
{
    const double d = 0.05, h = 0.1;
    const double side[4][4][3] = { { { -w, 0, d }, { w, 0, d }, { w, h, d }, { -w, h, d } },
                                   { { w, 0, -d }, { -w, 0, -d }, { -w, h, -d }, { w, h, -d } },
                                   { { w, 0, d }, { w, 0, -d }, { w, h, -d }, { w, h, d } },
                                   { { -w, 0, -d }, { -w, 0, d }, { -w, h, d }, { -w, h, -d } } };
    plant_stuff(b, KIT_PLASTIC);
    for (int k = 0; k < 4; k++) kit_quad(b, side[k]);
    kit_colour(b, 0.7, 0.55, 0.2);
    for (double x = 0.03 - w; x < w - 0.02; x += 0.05)
        for (int row = -1; row < 2; row += 2)
            kit_box(b, x - 0.007, 0.001, 0.022 * row - 0.007, x + 0.007, 0.08, 0.022 * row + 0.007);
}

static void coil(kit_build *b, double r)
{
    const double ring[2] = { r, 0.38 * r };
    kit_place_at(b, b->at[0], b->at[1] + 0.45 * r, b->at[2], b->turn);
    const double at[3] = { b->at[0], b->at[1], b->at[2] };
    plant_stuff(b, KIT_DARK);
    kit_patch(b, 28, 10, kit_torus_surface, ring);
    plant_stuff(b, KIT_BRASS);
    for (int k = 0; k < 16; k++) {
        const double a = 2 * KIT_PI * (k + 0.5) / 18;
        plant_hoop(b, KIT_AT(at[0] + r * cos(a), at[1], at[2] + r * sin(a)), -a * 180 / KIT_PI, 90, 0.4 * r, 0.05 * r,
                   12);
    }
}

static void on_the_board(kit_build *b, double x, double z, double cell)
{
    const double turn = 90 * kit_choose(b, 4), s = 0.42 * cell;
    const kit_frame before = kit_enter(b, x, 0.031, z, turn, 1);
    switch (kit_choose(b, 8)) {
    case 0:
    case 1: chip(b, s * kit_between(b, 0.5, 0.85), s * kit_between(b, 0.3, 0.85)); break;
    case 2: heat_sink(b, s * kit_between(b, 0.6, 1), s * kit_between(b, 0.6, 1)); break;
    case 3: connector(b, s * kit_between(b, 0.7, 1)); break;
    case 4: coil(b, 0.5 * s); break;
    case 5:
    case 6:
        for (int k = 0; k < 4; k++) {
            kit_place_at(b, k & 1 ? 0.5 * s : -0.5 * s, 0, k & 2 ? 0.5 * s : -0.5 * s, 0);
            if (kit_odds(b, 0.8)) can(b, kit_between(b, 0.25, 0.42) * s, kit_between(b, 0.1, 0.3));
        }
        break;
    default:
        for (int k = 0; k < 8; k++) { /* resistors */
            const double t = 0.24 * s * (k - 3.5), lead[4][3] = {
                { t, 0, -0.5 * s }, { t, 0.03, -0.5 * s }, { t, 0.03, 0.5 * s }, { t, 0, 0.5 * s }
            };
            kit_place_at(b, 0, 0, 0, 0);
            kit_colour(b, 0.6, 0.6, 0.58);
            kit_tube(b, lead, 4, 0.006, 5);
            plant_stuff(b, KIT_GOODS);
            plant_rod(b, KIT_AT(t, 0.03, -0.25 * s), KIT_AT(t, 0.03, 0.25 * s), 0.025, 10);
        }
    }
    kit_leave(b, before);
}

void plant_board(kit_build *b)
{
    static const float masks[][3] = {
        { 0.05f, 0.24f, 0.1f }, { 0.05f, 0.12f, 0.3f }, { 0.08f, 0.08f, 0.08f }, { 0.4f, 0.06f, 0.05f }
    };
    const double w = 1.2, d = kit_between(b, 0.7, 1), cell = kit_between(b, 0.24, 0.38);
    KIT_TINT(b, masks, 0.1);
    kit_box(b, -w, 0.001, -d, w, 0.03, d);
    for (int k = 0; k < 70; k++) { /* traces */
        const double x = kit_between(b, 0.05 - w, w - 0.4), z = kit_between(b, 0.04 - d, d - 0.3),
                     run = kit_between(b, 0.1, 0.35);
        kit_colour(b, 0.3, 0.36, 0.14);
        if (k & 1) kit_box(b, x, 0.029, z, x + run, 0.0315 + 1e-5 * k, z + 0.012);
        else kit_box(b, x, 0.029, z, x + 0.012, 0.0315 + 1e-5 * k, z + 0.8 * run);
    }
    for (double x = 0.55 * cell - w; x < w - 0.45 * cell; x += cell)
        for (double z = 0.55 * cell - d; z < d - 0.45 * cell; z += cell)
            if (kit_odds(b, 0.88)) on_the_board(b, x, z, cell);
}
