/* canals.c - a layout of scenes by seed: quays along a canal, its bridges and boats. Declared in streets.h. */
#include "kit/scene/streets/streets.h"
#include <math.h>

/* ---- >>canal --------------------------------------------------------------------------------------------------- */

static const double WATER = -1.5;

static double canal_ground(const kit_plot *p, double x, double z)
{
    (void)z;
    return fabs(x) < p->of[0] ? WATER : 0;
}

/* an arched deck across, above or below: half its span, half its width, its rise, how far down, which way it looks */
static void deck_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, x = s[0] * (2 * u - 1);
    out->p[0] = x;
    out->p[1] = s[2] * (1 - x * x / (s[0] * s[0])) - s[3];
    out->p[2] = s[1] * (2 * v - 1);
    out->n[0] = s[4] * 2 * s[2] * x / (s[0] * s[0]);
    out->n[1] = s[4];
    out->n[2] = 0;
    kit_unit(out->n);
}

static void bridge(kit_build *b, double half)
{
    const double shape[5] = { half + 1.5, kit_between(b, 1.2, 2.5), kit_between(b, 0.5, 1.1), 0, 1 };
    const double below[5] = { shape[0], shape[1], shape[2], 0.35, -1 };
    const double post = shape[0] - 0.2;
    const int pieces = 12, solid = kit_odds(b, 0.5);
    kit_colour(b, 0.46, 0.4, 0.34);
    kit_place_at(b, 0, 0.01, 0, 0);
    kit_patch(b, 24, 1, deck_surface, shape);
    kit_patch(b, 24, 1, deck_surface, below);
    kit_place_at(b, 0, 0, 0, 0);
    for (int k = 0; k < 2 * pieces; k++) { /* its sides and parapets */
        const double z = k < pieces ? -shape[1] : shape[1], x0 = post * (2.0 * (k % pieces) / pieces - 1),
                     x1 = x0 + 2 * post / pieces;
        const double y0 = shape[2] * (1 - x0 * x0 / (shape[0] * shape[0])),
                     y1 = shape[2] * (1 - x1 * x1 / (shape[0] * shape[0]));
        const double rail[2][3] = { { x0, y0 + 0.95, z }, { x1, y1 + 0.95, z } };
        if (solid) kit_box(b, x0, fmin(y0, y1) - 0.42, z - 0.12, x1 - 0.01, 0.5 * (y0 + y1) + 0.8, z + 0.12);
        else {
            kit_box(b, x0, fmin(y0, y1) - 0.42, z - 0.06, x1, fmin(y0, y1) + 0.05, z + 0.06);
            kit_tube(b, rail, 2, 0.03, 8);
            for (int n = 0; n < 8; n++) {
                const double t = n / 8.0, x = x0 + t * (x1 - x0), y = y0 + t * (y1 - y0);
                kit_box(b, x - 0.01, y - 0.05, z - 0.01, x + 0.01, y + 0.95, z + 0.01);
            }
        }
    }
}

/* an open hull with thwarts: half its beam, half its length, depth */
static void hull_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, z = 2 * v - 1, wide = s[0] * sqrt(fmax(0, 1 - z * z * z * z)), a = KIT_PI * (u - 0.5);
    out->p[0] = wide * sin(a);
    out->p[1] = s[2] * (0.25 * z * z - cos(a) * (1 - 0.3 * z * z));
    out->p[2] = s[1] * z;
    out->n[0] = sin(a);
    out->n[1] = -cos(a);
    out->n[2] = 0.3 * z;
    kit_unit(out->n);
}

static void boat(kit_build *b)
{
    const double hull[3] = { kit_between(b, 0.6, 0.9), kit_between(b, 2, 3), 0.7 };
    kit_colour(b, kit_between(b, 0.1, 0.6), kit_between(b, 0.15, 0.35), kit_between(b, 0.1, 0.4));
    kit_place_at(b, 0, 0.45, 0, 0);
    kit_patch(b, 14, 16, hull_surface, hull);
    kit_colour(b, 0.46, 0.34, 0.22);
    for (int k = -1; k <= 1; k++)
        kit_box(b, -0.9 * hull[0], -0.2, 0.9 * k - 0.12, 0.9 * hull[0], -0.16, 0.9 * k + 0.12);
    kit_place_at(b, 0, 0, 0, 0);
    if (kit_odds(b, 0.4)) kit_bevelled(b, -0.7 * hull[0], 0.2, -1.2, 0.7 * hull[0], 1.1, 0.6, 0.08);
}

static void quays(kit_plot *p, double half, double edge, double reach, const double bridges[2])
{
    static const int odd[] = { KIT_TREE,    KIT_TREE, KIT_BENCH, KIT_LAMP, KIT_BICYCLE, KIT_PERSON,
                               KIT_BOLLARD, KIT_CAFE, KIT_BIN,   KIT_POT,  KIT_CAR,     KIT_CRATES };
    kit_build *b = &p->b;
    for (int side = -1; side <= 1; side += 2)
        for (double z = -0.9 * reach; z < 0.9 * reach; z += kit_between(b, 2, 5)) {
            if (fabs(z - bridges[0]) < 3.2 || fabs(z - bridges[1]) < 3.2) continue;
            const int what = odd[kit_choose(b, (int)(sizeof odd / sizeof *odd))];
            const double x = what == KIT_CAR                        ? 0.5 * (half + edge)
                           : what == KIT_CAFE || what == KIT_PERSON ? kit_between(b, half + 1.2, edge - 1)
                                                                    : half + 0.8;
            kit_town_put(p, what, side * x, 0.02, z,
                         (what == KIT_CAR || what == KIT_BICYCLE ? 90 * (what == KIT_BICYCLE)
                          : side < 0                             ? 90
                                                                 : -90)
                             + kit_between(b, -8, 8));
        }
    for (int k = 2 + kit_choose(b, 5); k > 0; k--) {
        const double at[3] = { (k & 1 ? 1 : -1) * (half - 1.1), WATER, kit_between(b, -0.8, 0.8) * reach };
        const kit_frame was = kit_town_stand(p, "boat", at, kit_between(b, -4, 4), 1.6);
        boat(b);
        kit_leave(b, was);
    }
}

void kit_town_lay_canal(kit_plot *p, kit_town *t)
{
    kit_build *b = &p->b;
    const double half = kit_between(b, 3, 6.5), edge = half + kit_between(b, 3.5, 7), reach = kit_between(b, 22, 30),
                 size = kit_between(b, 0.4, 0.9);
    const double rail = kit_odds(b, 0.4), bar[2][2][2] = { { { -half - 0.2, -reach }, { -half - 0.2, -3 } },
                                                           { { half + 0.2, 3 }, { half + 0.2, reach } } };
    kit_begin_object(b, "ground", 0);
    kit_colour(b, 0.1, 0.14, 0.13);
    kit_level(b, -half - 1, -260, half + 1, 260, WATER);
    for (int side = -1; side <= 1; side += 2) {
        const double r[4] = { side < 0 ? -edge + 0.02 : half + 0.42, -14, side < 0 ? -half - 0.42 : edge - 0.02, 14 };
        kit_colour(b, 0.33, 0.31, 0.28);
        kit_box(b, side < 0 ? -260 : half, WATER - 0.5, -260, side < 0 ? -half : 260, 0, 260);
        kit_town_paving(b, r, 0.015, size);
        kit_colour(b, 0.5, 0.48, 0.44); /* copings */
        for (double z = -reach; z < reach; z += 1.2)
            kit_box(b, side < 0 ? -half - 0.4 : half - 0.08, -0.12, z, side < 0 ? -half + 0.08 : half + 0.4, 0.06,
                    z + 1.18);
    }
    const double bridges[2] = { kit_between(b, -6, 2), kit_between(b, 14, 20) };
    t->pave = 0.02;
    kit_town_row(p, t, -edge, reach, -edge, -reach);
    kit_town_row(p, t, edge, -reach, edge, reach);
    kit_town_skyline(p, 85);
    quays(p, half, edge, reach, bridges);
    for (int k = 0; k < 2; k++) {
        const double at[3] = { 0, 0, bridges[k] };
        const kit_frame was = kit_town_stand(p, "bridge", at, 0, 0.8 * half);
        bridge(b, half);
        kit_leave(b, was);
    }
    kit_begin_object(b, "railing", -1);
    kit_colour(b, 0.1, 0.1, 0.1);
    for (int k = 0; k < 2 && rail > 0; k++) kit_town_railing(b, bar[k], 2, 0.06, 0.9, KIT_BARS);
    p->of[0] = half;
    p->ground = canal_ground;
    kit_town_range(p, -edge + 1, -0.9 * reach, edge - 1, 0.9 * reach);
}
