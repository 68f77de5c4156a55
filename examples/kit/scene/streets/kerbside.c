/* kerbside.c - what stands along streets: cars, bicycles, posts, lamps, signs, bins, benches, shelters, hoardings.
   Declared in streets.h. */
#include "kit/scene/streets/streets.h"
#include <math.h>
#include <string.h>

/* ---- >>vehicles ------------------------------------------------------------------------------------------------ */

static const float paints[][3] = { { 0.7f, 0.7f, 0.7f },   { 0.06f, 0.06f, 0.07f }, { 0.5f, 0.05f, 0.05f },
                                   { 0.1f, 0.18f, 0.38f }, { 0.35f, 0.36f, 0.37f }, { 0.76f, 0.74f, 0.68f },
                                   { 0.15f, 0.28f, 0.2f }, { 0.7f, 0.5f, 0.1f } };

static void cushion_at(kit_build *b, double x, double y, double z, double rx, double ry, double rz, double round,
                       int cells)
{
    const double half[3] = { rx, ry, rz };
    kit_place_at(b, x, y, z, 0);
    kit_cushion(b, half, round, cells);
    kit_place_at(b, 0, 0, 0, 0);
}

/* with its axle along x */
static void wheel(kit_build *b, double x, double z, double radius, double side)
{
    const double tyre[2] = { radius - 0.09, 0.09 };
    static const kit_moulding disc[] = { { 0, 0.05, 0.07, 0.03, 0 },
                                         { 0.07, 0.03, 0.2, 0.06, 0 },
                                         { 0.2, 0.06, 0.23, 0.06, 0 } };
    kit_colour(b, 0.04, 0.04, 0.04);
    kit_place_tilted(b, x, radius, z, side > 0 ? 90 : -90, 90);
    kit_patch(b, 16, 6, kit_torus_surface, tyre);
    kit_colour(b, 0.6, 0.6, 0.62);
    kit_turned(b, disc, 3, 14);
    kit_place_at(b, 0, 0, 0, 0);
}

/* what cars and vans have: wheels, lamps, bumpers, mirrors, plates */
static void trimmings(kit_build *b, double half, double base, double nose)
{
    const double r = 0.32;
    for (int k = 0; k < 4; k++) wheel(b, (k & 1 ? 1 : -1) * (half - 0.07), k & 2 ? base : -base, r, k & 1 ? 1 : -1);
    for (int k = -1; k <= 1; k += 2) {
        kit_colour(b, 0.85, 0.85, 0.82);
        cushion_at(b, k * (half - 0.22), 0.68, nose - 0.06, 0.17, 0.08, 0.08, 0.6, 6);
        kit_colour(b, 0.5, 0.04, 0.03);
        cushion_at(b, k * (half - 0.18), 0.74, -nose + 0.05, 0.13, 0.1, 0.07, 0.5, 6);
        kit_colour(b, 0.08, 0.08, 0.08);
        cushion_at(b, k * (half + 0.09), 0.98, 0.62, 0.1, 0.07, 0.06, 0.6, 6);
    }
    kit_bevelled(b, -half + 0.06, 0.3, nose - 0.2, half - 0.06, 0.46, nose + 0.04, 0.04);
    kit_bevelled(b, -half + 0.06, 0.3, -nose - 0.04, half - 0.06, 0.46, -nose + 0.2, 0.04);
    kit_box(b, -half + 0.15, 0.2, -nose + 0.3, half - 0.15, 0.34, nose - 0.3);
    kit_colour(b, 0.75, 0.75, 0.7);
    kit_box(b, -0.26, 0.4, nose + 0.03, 0.26, 0.51, nose + 0.06);
    kit_box(b, -0.26, 0.5, -nose - 0.03, 0.26, 0.61, -nose + 0.05);
}

static void van(kit_build *b)
{
    float paint[3];
    kit_town_keep(b, paint);
    kit_bevelled(b, -0.95, 0.32, -2.4, 0.95, 2.2, 1.1, 0.12);
    cushion_at(b, 0, 0.72, 1.3, 0.94, 0.4, 1.15, 0.25, 10);
    cushion_at(b, 0, 1.25, 1.05, 0.9, 0.75, 0.75, 0.4, 10);
    kit_colour(b, 0.05, 0.06, 0.07);
    cushion_at(b, 0, 1.45, 1.2, 0.86, 0.38, 0.68, 0.4, 10);
    kit_colour(b, 0.2, 0.2, 0.2);
    for (int k = -1; k <= 1; k += 2) kit_box(b, 0.951 * k - 0.004, 0.6, -0.9, 0.951 * k + 0.004, 0.63, 0.9);
    trimmings(b, 0.94, 1.4, 2.35);
    if (kit_odds(b, 0.4))
        for (int k = 0; k < 4; k++) { /* a ladder on the roof */
            kit_colour(b, 0.5, 0.5, 0.5);
            kit_box(b, -0.5, 2.24, -2 + 0.8 * k, 0.5, 2.3, -1.95 + 0.8 * k);
        }
    kit_town_paint(b, paint);
}

void kit_town_car(kit_build *b)
{
    const int shape = kit_choose(b, 5);
    const double half = kit_between(b, 0.82, 0.9), nose = kit_between(b, 1.9, 2.3),
                 roof = shape == 3 ? 1.7 : kit_between(b, 1.4, 1.52), back = shape == 1 ? nose - 0.2 : nose - 0.8;
    float paint[3];
    KIT_TINT(b, paints, 0.2);
    kit_town_keep(b, paint);
    if (shape == 4) {
        van(b);
        return;
    }
    cushion_at(b, 0, 0.62, 0, half, 0.33, nose, 0.28, 12);
    kit_colour(b, 0.05, 0.06, 0.07);
    cushion_at(b, 0, 0.95, 0.5 * (1 - back) + 0.05, half - 0.1, roof - 0.98, 0.5 * (1 + back), 0.55, 12);
    kit_town_paint(b, paint);
    cushion_at(b, 0, roof - 0.06, 0.5 * (0.55 - back) + 0.06, half - 0.2, 0.07, 0.5 * (0.55 + back) - 0.22, 0.35, 10);
    for (int k = -1; k <= 1; k += 2) { /* pillars */
        const double x = k * (half - 0.09), in = k * (half - 0.2);
        const double front[2][3] = { { x, 0.9, 1.02 }, { in, roof - 0.06, 0.3 } },
                     middle[2][3] = { { x - 0.01 * k, 0.9, -0.2 }, { in + 0.04 * k, roof - 0.06, -0.2 } };
        kit_tube(b, front, 2, 0.04, 5);
        kit_tube(b, middle, 2, 0.05, 5);
    }
    trimmings(b, half, 1.25 + 0.2 * (nose - 1.9), nose - 0.02);
    if (shape != 2) return;
    kit_colour(b, 0.12, 0.12, 0.12); /* a rack with a box */
    for (int k = -1; k <= 1; k += 2)
        kit_box(b, -half + 0.1, roof + 0.05, -0.45 + 0.5 * k, half - 0.1, roof + 0.09, -0.41 + 0.5 * k);
    cushion_at(b, 0.1, roof + 0.27, -0.4, 0.4, 0.18, 0.8, 0.35, 8);
}

/* a tube between two points */
static void rod(kit_build *b, double x0, double y0, double z0, double x1, double y1, double z1, double radius)
{
    const double at[2][3] = { { x0, y0, z0 }, { x1, y1, z1 } };
    kit_tube(b, at, 2, radius, 6);
}

void kit_town_bicycle(kit_build *b)
{
    static const double tyre[2] = { 0.33, 0.018 };
    for (int k = -1; k <= 1; k += 2) {
        kit_colour(b, 0.05, 0.05, 0.05);
        kit_place_tilted(b, 0.52 * k, 0.35, 0, 0, 90);
        kit_patch(b, 28, 6, kit_torus_surface, tyre);
        kit_place_at(b, 0, 0, 0, 0);
        kit_colour(b, 0.6, 0.6, 0.6);
        for (int n = 0; n < 8; n++) {
            const double a = KIT_PI * n / 4, x = 0.52 * k;
            rod(b, x, 0.35, 0.02, x + 0.33 * cos(a), 0.35 + 0.33 * sin(a), 0, 0.002);
        }
    }
    KIT_TINT(b, paints, 0.2);
    rod(b, -0.52, 0.35, 0, -0.08, 0.33, 0, 0.012);
    rod(b, -0.52, 0.35, 0, -0.2, 0.78, 0, 0.01);
    rod(b, -0.08, 0.33, 0, -0.24, 0.9, 0, 0.015);
    rod(b, -0.08, 0.33, 0, 0.34, 0.74, 0, 0.017);
    rod(b, -0.21, 0.8, 0, 0.32, 0.84, 0, 0.015);
    rod(b, 0.52, 0.35, 0, 0.3, 0.95, 0, 0.015);
    kit_colour(b, 0.1, 0.1, 0.1);
    rod(b, 0.3, 0.97, -0.26, 0.3, 0.97, 0.26, 0.012);
    cushion_at(b, -0.25, 0.93, 0, 0.13, 0.035, 0.07, 0.6, 6);
    rod(b, -0.08, 0.33, -0.09, -0.16, 0.24, -0.09, 0.01);
    rod(b, -0.08, 0.33, 0.09, 0, 0.42, 0.09, 0.01);
    if (kit_odds(b, 0.4)) kit_box(b, 0.4, 0.75, -0.15, 0.68, 0.98, 0.15);
}

/* ---- >>posts --------------------------------------------------------------------------------------------------- */

void kit_town_bollard(kit_build *b)
{
    static const kit_moulding post[] = { { 0.13, 0, 0.1, 0.1, 0 },
                                         { 0.1, 0.1, 0.08, 0.75, 0 },
                                         { 0.08, 0.75, 0.11, 0.78, 0 },
                                         { 0.11, 0.78, 0.11, 0.83, 0.01 },
                                         { 0.11, 0.83, 0, 0.95, 0.03 } };
    kit_turned(b, post, 5, 14);
}

void kit_town_hydrant(kit_build *b)
{
    static const kit_moulding body[] = { { 0.17, 0, 0.17, 0.06, 0 },      { 0.17, 0.06, 0.11, 0.07, 0 },
                                         { 0.11, 0.07, 0.11, 0.5, 0 },    { 0.14, 0.5, 0.14, 0.56, 0.01 },
                                         { 0.14, 0.56, 0.03, 0.7, 0.03 }, { 0.03, 0.7, 0, 0.76, 0 } };
    kit_colour(b, 0.55, 0.1, 0.06);
    kit_turned(b, body, 6, 16);
    rod(b, -0.21, 0.38, 0, 0.21, 0.38, 0, 0.05);
    rod(b, 0, 0.34, 0, 0, 0.34, 0.2, 0.065);
}

void kit_town_sign_post(kit_build *b)
{
    const double high = kit_between(b, 2.1, 2.9);
    const int kind = kit_choose(b, 3);
    kit_colour(b, 0.5, 0.51, 0.52);
    rod(b, 0, 0, 0, 0, high, 0, 0.03);
    if (kind == 0) kit_colour(b, 0.6, 0.08, 0.06);
    else if (kind == 1) kit_colour(b, 0.08, 0.16, 0.42);
    else kit_colour(b, 0.78, 0.78, 0.75);
    if (kind < 2) {
        kit_place_tilted(b, 0, high - 0.32, 0.03, 0, 90);
        kit_cylinder(b, 0.3, 0.015, kind ? 24 : 8);
    } else
        for (int k = 0; k < 3; k++) { /* names of streets */
            kit_place_at(b, 0, high - 0.1 - 0.24 * k, 0, 55 * k);
            kit_box(b, -0.42, -0.09, 0.03, 0.42, 0.09, 0.045);
        }
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_town_lamp_post(kit_plot *p, double height)
{
    static const kit_moulding foot[] = { { 0.2, 0, 0.2, 0.12, 0 },
                                         { 0.2, 0.12, 0.1, 0.25, -0.02 },
                                         { 0.1, 0.25, 0.1, 0.9, 0 },
                                         { 0.1, 0.9, 0.13, 0.95, 0.01 },
                                         { 0.13, 0.95, 0.06, 1.05, 0 } };
    static const kit_moulding globe[] = { { 0.08, 0, 0.2, 0.3, 0.02 },
                                          { 0.24, 0.3, 0.05, 0.45, 0.02 },
                                          { 0.05, 0.45, 0, 0.6, 0 } };
    kit_build *b = &p->b;
    double at[3];
    kit_colour(b, 0.13, 0.15, 0.14);
    kit_turned(b, foot, 5, 14);
    if (height < 5) { /* a lantern on top */
        rod(b, 0, 1, 0, 0, height - 0.4, 0, 0.05);
        kit_place_at(b, 0, height - 0.4, 0, 0);
        kit_turned(b, globe, 3, 12);
        kit_place_at(b, 0, 0, 0, 0);
        kit_town_to_world(b, 0, height - 0.7, 0.3, at);
    } else {
        const double arm[6][3] = {
            { 0, 1, 0 },      { 0, height - 0.8, 0 }, { 0, height - 0.3, 0.15 }, { 0, height - 0.08, 0.5 },
            { 0, height, 1 }, { 0, height, 1.6 }
        };
        kit_tube(b, arm, 6, 0.055, 8);
        cushion_at(b, 0, height - 0.02, 1.75, 0.15, 0.07, 0.4, 0.5, 8);
        kit_town_to_world(b, 0, height - 0.4, 1.75, at);
    }
    kit_add_lamp(p, at[0], at[1], at[2]);
}

void kit_town_traffic_light(kit_build *b)
{
    kit_colour(b, 0.12, 0.12, 0.12);
    rod(b, 0, 0, 0, 0, 3.4, 0, 0.06);
    for (int n = 0; n < 2; n++) {
        kit_place_at(b, 0, 2.3, 0, 90 * n);
        kit_bevelled(b, -0.16, 0, 0.08, 0.16, 0.95, 0.3, 0.03);
        for (int k = 0; k < 3; k++) { /* lenses under their hoods */
            static const double lens = 0.1;
            static const kit_moulding hood[] = { { 0.13, 0, 0.12, 0.2, 0 } };
            kit_colour(b, k == 2 ? 0.6 : 0.1, k == 2 ? 0.06 : 0.3 - 0.1 * k, 0.05);
            kit_place_tilted(b, n ? 0.28 : 0, 2.47 + 0.3 * k, n ? 0 : 0.28, 90 * n, 90);
            kit_patch(b, 10, 6, kit_sphere_surface, &lens);
            kit_colour(b, 0.12, 0.12, 0.12);
            kit_turned(b, hood, 1, 14);
        }
    }
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_town_wire_pole(kit_build *b, double height)
{
    static const kit_moulding knob[] = { { 0.03, 0, 0.05, 0.06, 0.01 }, { 0.05, 0.06, 0, 0.12, 0.01 } };
    static const kit_moulding pole[] = { { 0.16, 0, 0.11, 1, 0 }, { 0.11, 1, 0, 1, 0 } };
    kit_moulding shaft[2];
    memcpy(shaft, pole, sizeof shaft);
    shaft[0].y1 = shaft[1].y0 = shaft[1].y1 = height;
    kit_colour(b, 0.3, 0.23, 0.17);
    kit_turned(b, shaft, 2, 12);
    for (int k = 0; k < 2; k++) {
        kit_colour(b, 0.3, 0.23, 0.17);
        kit_box(b, -1, height - 0.5 - 0.8 * k, 0.1, 1, height - 0.38 - 0.8 * k, 0.22);
        kit_colour(b, 0.5, 0.5, 0.48);
        for (int n = 0; n < 4; n++) {
            kit_place_at(b, -0.9 + 0.6 * n, height - 0.379 - 0.8 * k, 0.16, 0);
            kit_turned(b, knob, 2, 8);
        }
        kit_place_at(b, 0, 0, 0, 0);
    }
    if (!kit_odds(b, 0.4)) return;
    kit_place_at(b, 0.3, height - 2.6, 0, 0); /* a transformer */
    kit_cylinder(b, 0.24, 0.8, 14);
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_town_cone(kit_build *b)
{
    static const kit_moulding cone[] = { { 0.16, 0.03, 0.025, 0.7, 0 }, { 0.025, 0.7, 0, 0.7, 0 } };
    kit_colour(b, 0.75, 0.22, 0.05);
    kit_box(b, -0.2, 0, -0.2, 0.2, 0.035, 0.2);
    kit_turned(b, cone, 2, 14);
}

/* ---- >>things to use --------------------------------------------------------------------------------------------- */

void kit_town_bin(kit_build *b)
{
    static const kit_moulding body[] = { { 0, 0, 0.24, 0, 0 },
                                         { 0.24, 0, 0.29, 0.85, 0 },
                                         { 0.29, 0.85, 0.26, 0.85, 0 },
                                         { 0.26, 0.85, 0.22, 0.1, 0 },
                                         { 0.22, 0.1, 0, 0.1, 0 } };
    KIT_TINT(b, paints, 0.2);
    if (kit_odds(b, 0.5)) {
        kit_turned(b, body, 5, 18);
        return;
    }
    for (int k = -1; k <= 1; k += 2) wheel(b, 0.22 * k, -0.24, 0.12, k); /* with wheels and a lid */
    kit_colour(b, 0.12, kit_between(b, 0.14, 0.3), 0.14);
    kit_bevelled(b, -0.28, 0.06, -0.3, 0.28, 0.95, 0.3, 0.03);
    kit_place_tilted(b, 0, 0.96, -0.33, 0, kit_odds(b, 0.3) ? -40 : 2);
    kit_bevelled(b, -0.3, 0, 0, 0.3, 0.06, 0.68, 0.02);
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_town_dumpster(kit_build *b)
{
    const double side[4][2] = { { -0.9, 0.55 }, { 0.9, 0.55 }, { 1.0, -0.55 }, { -1.0, -0.55 } };
    kit_colour(b, 0.12, kit_between(b, 0.2, 0.34), 0.2);
    kit_place_at(b, 0, 0.15, 0, 0);
    kit_prism(b, side, 4, 1.0);
    kit_place_at(b, 0, 0, 0, 0);
    for (int k = 0; k < 5; k++) kit_box(b, -0.85 + 0.4 * k, 0.2, 0.54, -0.78 + 0.4 * k, 1.1, 0.6);
    kit_box(b, -1.05, 1.1, -0.6, 1.05, 1.16, 0.6);
    kit_colour(b, 0.08, 0.08, 0.08);
    for (int k = 0; k < 2; k++) {
        kit_place_tilted(b, k ? 0.02 : -1, 1.17, -0.56, 0, k ? -2 : kit_between(b, -100, -2));
        kit_box(b, 0, 0, 0, 0.98, 0.03, 1.15);
    }
    kit_place_at(b, 0, 0, 0, 0);
    for (int k = 0; k < 4; k++)
        kit_box(b, (k & 1 ? 0.7 : -0.8), 0, (k & 2 ? 0.3 : -0.4), (k & 1 ? 0.8 : -0.7), 0.16, (k & 2 ? 0.4 : -0.3));
}

void kit_town_bench(kit_build *b)
{
    const int back = kit_odds(b, 0.7);
    kit_colour(b, 0.48, 0.33, 0.2);
    for (int i = 0; i < 6; i++) kit_box(b, -0.85, 0.43, -0.23 + 0.08 * i, 0.85, 0.46, -0.17 + 0.08 * i);
    for (int i = 0; i < 4 && back; i++)
        kit_box(b, -0.85, 0.54 + 0.1 * i, -0.29 - 0.02 * i, 0.85, 0.61 + 0.1 * i, -0.27 - 0.02 * i);
    kit_colour(b, 0.1, 0.1, 0.1);
    for (int i = -1; i <= 1; i++) {
        const double x = 0.7 * i, leg[4][3] = { { x, 0, 0.2 }, { x, 0.4, 0.22 }, { x, 0.41, -0.2 }, { x, 0, -0.28 } };
        kit_tube(b, leg, 4, 0.022, 6);
        if (back) rod(b, x, 0.41, -0.22, x, 0.95, -0.37, 0.02);
        if (i) rod(b, x, 0.65, -0.29, x, 0.65, 0.2, 0.02);
    }
}

void kit_town_shelter(kit_build *b)
{
    static const double glass[3][4][3] = {
        { { -1.8, 0.2, -0.7 }, { 1.8, 0.2, -0.7 }, { 1.8, 2.2, -0.7 }, { -1.8, 2.2, -0.7 } },
        { { -1.8, 0.2, -0.7 }, { -1.8, 0.2, 0.4 }, { -1.8, 2.2, 0.4 }, { -1.8, 2.2, -0.7 } },
        { { 1.8, 0.2, 0.4 }, { 1.8, 0.2, -0.7 }, { 1.8, 2.2, -0.7 }, { 1.8, 2.2, 0.4 } }
    };
    kit_colour(b, 0.3, 0.36, 0.38);
    for (int k = 0; k < 3; k++) kit_quad(b, glass[k]);
    kit_colour(b, 0.18, 0.19, 0.2);
    for (int k = 0; k < 5; k++) rod(b, -1.8 + 0.9 * k, 0, -0.73, -1.8 + 0.9 * k, 2.4, -0.73, 0.035);
    for (int k = -1; k <= 1; k += 2) rod(b, 1.8 * k, 0, 0.42, 1.8 * k, 2.4, 0.42, 0.035);
    kit_bevelled(b, -2, 2.4, -0.9, 2, 2.52, 0.8, 0.03);
    kit_colour(b, 0.5, 0.36, 0.22);
    for (int k = 0; k < 3; k++) kit_box(b, -1.4, 0.45, -0.6 + 0.13 * k, 0.8, 0.48, -0.5 + 0.13 * k);
    for (int k = 0; k < 2; k++) kit_box(b, -1.2 + 1.7 * k, 0, -0.5, -1.12 + 1.7 * k, 0.449, -0.3);
    kit_colour(b, 0.7, 0.5, 0.3);
    kit_box(b, 0.95, 0.4, -0.69, 1.7, 1.9, -0.62);
}

void kit_town_billboard(kit_build *b)
{
    static const float posters[][3] = {
        { 0.7f, 0.25f, 0.15f }, { 0.2f, 0.45f, 0.6f }, { 0.8f, 0.75f, 0.5f }, { 0.3f, 0.5f, 0.25f }
    };
    const double low = kit_between(b, 1, 4), wide = kit_between(b, 2, 3.5), high = 0.55 * wide * 2;
    kit_colour(b, 0.3, 0.3, 0.31);
    for (int k = -2; k <= 2; k++) {
        rod(b, 0.45 * wide * k, 0, -0.2, 0.45 * wide * k, low + high, -0.2, 0.06);
        rod(b, 0.45 * wide * k, 0, -1.6, 0.45 * wide * k, low + 0.6 * high, -0.22, 0.05);
    }
    KIT_TINT(b, posters, 0.2);
    kit_box(b, -wide, low, -0.13, wide, low + high, -0.05);
    KIT_TINT(b, posters, 0.2);
    kit_box(b, -0.6 * wide, low + 0.2 * high, -0.06, 0.1 * wide, low + 0.8 * high, -0.045);
    kit_colour(b, 0.5, 0.45, 0.38);
    kit_box(b, -wide - 0.1, low - 0.12, -0.16, wide + 0.1, low - KIT_GAP, 0);
    kit_box(b, -wide - 0.1, low + high + KIT_GAP, -0.16, wide + 0.1, low + high + 0.12, 0);
    for (int k = -1; k <= 1; k++) rod(b, 0.7 * wide * k, low + high, 0, 0.7 * wide * k, low + high + 0.2, 0.9, 0.02);
}
