/* scenes.c - the built-in scenes. Declared in kit_build.h. */
#include "kit/kit_build.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>


/* ---- >>shapes of closed form; big planes are cut finer towards the origin, for a rasteriser's sake ----------- */

enum { FAR = 200 };                        /* metres: where the big planes end */
static const double whole[]   = { 0, 1 };
static const double outward[] = { 0, 0.0025, 0.01, 0.03, 0.1, 0.3, 1 };

static void build_plane(kit_build *b)
{
    static const double floor_[4][3] = { {-FAR, 0, FAR}, {FAR, 0, FAR}, {FAR, 0, -FAR}, {-FAR, 0, -FAR} };
    kit_sheet(b, floor_, KIT_CUTS(kit_both), KIT_CUTS(kit_both));
}

static void build_corner(kit_build *b)
{
    static const double floor_[4][3] = { {0, 0, FAR}, {FAR, 0, FAR}, {FAR, 0, -FAR}, {0, 0, -FAR} };
    static const double wall[4][3]   = { {0, 0, FAR}, {0, 0, -FAR}, {0, FAR, -FAR}, {0, FAR, FAR} };
    kit_sheet(b, floor_, KIT_CUTS(outward), KIT_CUTS(kit_both));
    kit_sheet(b, wall, KIT_CUTS(kit_both), KIT_CUTS(outward));
}

static void build_groove(kit_build *b)
{
    static const double left[4][3]  = { {-0.5, 0, -FAR}, {-FAR, 0, -FAR}, {-FAR, 0, FAR}, {-0.5, 0, FAR} };
    static const double right[4][3] = { {0.5, 0, FAR}, {FAR, 0, FAR}, {FAR, 0, -FAR}, {0.5, 0, -FAR} };
    static const double deep[3][4][3] = { { {-0.5, -1, FAR}, {0.5, -1, FAR}, {0.5, -1, -FAR}, {-0.5, -1, -FAR} },
                                          { {-0.5, 0, FAR}, {-0.5, -1, FAR}, {-0.5, -1, -FAR}, {-0.5, 0, -FAR} },
                                          { {0.5, -1, FAR}, {0.5, 0, FAR}, {0.5, 0, -FAR}, {0.5, -1, -FAR} } };
    kit_sheet(b, left, KIT_CUTS(outward), KIT_CUTS(kit_both));
    kit_sheet(b, right, KIT_CUTS(outward), KIT_CUTS(kit_both));
    for (int i = 0; i < 3; i++) kit_sheet(b, deep[i], KIT_CUTS(whole), KIT_CUTS(kit_both));
}

static void build_sphere(kit_build *b)
{
    static const double radius = 1;
    kit_begin_object(b, "plane", 0);
    build_plane(b);
    kit_place_at(b, 0, 1, 0, 0);
    kit_begin_object(b, "ball", 1);
    kit_patch(b, 256, 128, kit_sphere_surface, &radius);
}

static void build_hole(kit_build *b)
{
    static const double top[4][3]  = { {-0.5, 0, 0.5}, {-FAR, 0, FAR}, {FAR, 0, FAR}, {0.5, 0, 0.5} };
    static const double wall[4][3] = { {-0.5, 0, 0.5}, {0.5, 0, 0.5}, {0.5, -1, 0.5}, {-0.5, -1, 0.5} };
    kit_level(b, -0.5, -0.5, 0.5, 0.5, -1);
    for (int i = 0; i < 4; i++) {
        kit_place_at(b, 0, 0, 0, 90 * i);
        kit_sheet(b, top, KIT_CUTS(outward), KIT_CUTS(whole));
        kit_quad(b, wall);
    }
}

/* ---- >>room ------------------------------------------------------------------------------------------------- */

static void build_room(kit_build *b)
{
    static const double walls[2][4][3] = { { { 0, 0, 6 }, { 0, 0, 0 }, { 0, 2.8, 0 }, { 0, 2.8, 6 } },
                                           { { 0, 0, 0 }, { 6, 0, 0 }, { 6, 2.8, 0 }, { 0, 2.8, 0 } } };
    static const double ceiling[4][3] = { {0,2.8,0}, {6,2.8,0}, {6,2.8,6}, {0,2.8,6} };
    static const kit_moulding shade[] = { {0.24, 0, 0.08, 0.22, 0.01}, {0.08, 0.22, 0, 0.22, 0} };
    static const kit_moulding vase[] = { { 0, 0, 0.07, 0, 0 },
                                         { 0.07, 0, 0.05, 0.2, 0.06 },
                                         { 0.05, 0.2, 0.065, 0.26, -0.012 },
                                         { 0.065, 0.26, 0, 0.255, 0 } };
    static const double ball = 0.28, globe = 0.09, ring[2] = { 0.16, 0.05 };
    kit_colour(b, 0.62, 0.52, 0.42); kit_level(b, 0, 0, 6, 6, 0);
    kit_colour(b, 0.66, 0.24, 0.18); kit_quad(b, walls[0]);
    kit_colour(b, 0.30, 0.50, 0.34); kit_quad(b, walls[1]);
    kit_colour(b, 0.85, 0.85, 0.83); kit_quad(b, ceiling);
    /* skirting */
    kit_box(b, 0, 0, 0.02, 0.02, 0.1, 6); kit_box(b, 0, 0, 0, 6, 0.1, 0.02);
    kit_box(b, 0, 2.68, 0.1, 0.06, 2.8, 6);
    kit_box(b, 0, 2.68, 0, 6, 2.8, 0.06);
    kit_box(b, 0, 2.74, 0.1, 0.12, 2.8, 6);
    kit_box(b, 0, 2.74, 0, 6, 2.8, 0.12);

    kit_colour(b, 0.55, 0.38, 0.22);                                                                      /* bookcase */
    for (int i = 0; i < 3; i++) kit_box(b, 1.3 + 0.8 * i, 0, 0.02, 1.33 + 0.8 * i, 1.95, 0.3);
    for (int i = 0; i < 6; i++) kit_box(b, 1.33, 0.08 + 0.37 * i, 0.02, 2.9, 0.1 + 0.37 * i, 0.3);
    for (int i = 0; i < 5; i++)
        for (double x = 1.335, width; x < 2.86; x += width + 0.001) {
            double height = kit_between(b, 0.2, 0.33), depth = kit_between(b, 0.2, 0.27), lean = kit_chance(b),
                   tone = kit_between(b, 0.2, 0.7);
            double green = tone * kit_between(b, 0.4, 1.0), blue = tone * kit_between(b, 0.3, 0.9);
            width = kit_between(b, 0.018, 0.06);
            if (lean < 0.1) { width = kit_between(b, 0.1, 0.25); continue; }                              /* a gap */
            /* the middle board */
            if (x < 2.13 && x + width > 2.099) { x = 2.131; width = 0; continue; }
            if (x + width > 2.899) break;
            kit_colour(b, tone, green, blue);
            kit_box(b, x, 0.1 + 0.37 * i, 0.03, x + width, 0.1 + 0.37 * i + height, 0.03 + depth);
        }

    /* radiator, picture */
    kit_colour(b, 0.80, 0.80, 0.78);
    for (int i = 0; i < 14; i++) kit_box(b, 0.06, 0.15, 1.2 + 0.07 * i, 0.16, 0.75, 1.25 + 0.07 * i);
    kit_box(b, 0.09, 0.2, 1.2, 0.13, 0.24, 2.16); kit_box(b, 0.09, 0.66, 1.2, 0.13, 0.7, 2.16);
    kit_colour(b, 0.25, 0.17, 0.10);
    kit_box(b, 0, 1.3, 1.2, 0.04, 1.35, 2.2);
    kit_box(b, 0, 2.0, 1.2, 0.04, 2.05, 2.2);
    kit_box(b, 0, 1.35, 1.2, 0.04, 2.0, 1.25);
    kit_box(b, 0, 1.35, 2.15, 0.04, 2.0, 2.2);
    kit_colour(b, 0.75, 0.70, 0.55); kit_box(b, 0, 1.35, 1.25, 0.01, 2.0, 2.15);

    /* boxes in the corner */
    kit_colour(b, 0.70, 0.62, 0.48);
    kit_place_at(b, 0.55, 0, 0.55, 8);    kit_box(b, -0.38, 0, -0.35, 0.38, 0.7, 0.35);
    kit_place_at(b, 0.5, 0.7, 0.5, -17);  kit_box(b, -0.25, 0, -0.22, 0.25, 0.42, 0.22);
    kit_place_at(b, 0.55, 1.12, 0.52, 31); kit_box(b, -0.13, 0, -0.13, 0.13, 0.22, 0.13);
    kit_colour(b, 0.25, 0.35, 0.60);
    kit_place_at(b, 1.35, 0, 0.75, -24);  kit_box(b, -0.17, 0, -0.14, 0.17, 0.24, 0.14);

    /* rug, table */
    kit_colour(b, 0.45, 0.12, 0.14);
    kit_place_at(b, 2.0, 0, 2.0, 22);     kit_box(b, -1.2, 0, -0.85, 1.2, 0.012, 0.85);
    kit_colour(b, 0.60, 0.42, 0.25);
    kit_box(b, -0.75, 0.71, -0.42, 0.75, 0.75, 0.42);
    kit_box(b, -0.66, 0.62, -0.34, 0.66, 0.71, -0.32); kit_box(b, -0.66, 0.62, 0.32, 0.66, 0.71, 0.34);
    kit_box(b, -0.67, 0.62, -0.34, -0.65, 0.71, 0.34); kit_box(b, 0.65, 0.62, -0.34, 0.67, 0.71, 0.34);
    for (int i = 0; i < 4; i++) {
        double x = i & 1 ? 0.66 : -0.66, z = i & 2 ? 0.33 : -0.33;
        kit_box(b, x - 0.03, 0.012, z - 0.03, x + 0.03, 0.71, z + 0.03);
    }
    kit_colour(b, 0.75, 0.72, 0.66); kit_place_at(b, 2.05, 0.80, 1.72, 0);
    kit_patch(b, 96, 48, kit_torus_surface, ring);
    kit_colour(b, 0.80, 0.55, 0.20); kit_place_at(b, 2.36, 0.84, 2.08, 0);
    kit_patch(b, 64, 32, kit_sphere_surface, &globe);
    kit_colour(b, 0.25, 0.45, 0.55); kit_place_at(b, 1.60, 0.75, 1.92, 0);  kit_turned(b, vase, 4, 64);
    kit_colour(b, 0.20, 0.30, 0.45); kit_place_at(b, 1.72, 0.75, 2.32, 40);
    kit_box(b, -0.15, 0, -0.11, 0.15, 0.035, 0.11);
    kit_colour(b, 0.55, 0.50, 0.40); kit_place_at(b, 1.73, 0.785, 2.31, 58);
    kit_box(b, -0.12, 0, -0.09, 0.12, 0.03, 0.09);
    kit_colour(b, 0.70, 0.70, 0.72); kit_place_at(b, 0.62, ball, 2.75, 0);
    kit_patch(b, 96, 48, kit_sphere_surface, &ball);

    kit_colour(b, 0.75, 0.70, 0.50);                                                                      /* lamp */
    kit_place_at(b, 2.0, 1.75, 1.95, 0);  kit_turned(b, shade, 2, 64);
    kit_box(b, -0.006, 0.22, -0.006, 0.006, 1.05, 0.006);

    kit_colour(b, 0.20, 0.20, 0.22);                                                                      /* railing */
    kit_place_at(b, 3.75, 0, 1.35, -38);
    for (int i = -1; i <= 1; i++) kit_box(b, 0.7 * i - 0.025, 0, -0.025, 0.7 * i + 0.025, 0.98, 0.025);
    for (int i = 1; i < 14; i++)
        if (i != 7) kit_box(b, -0.7 + 0.1 * i - 0.008, 0.12, -0.008, -0.7 + 0.1 * i + 0.008, 0.84, 0.008);
    kit_box(b, -0.7, 0.1, -0.012, 0.7, 0.13, 0.012);
    kit_box(b, -0.7, 0.83, -0.012, 0.7, 0.86, 0.012);
    kit_box(b, -0.76, 0.95, -0.04, 0.76, 0.99, 0.04);
}

/* ---- >>grass ------------------------------------------------------------------------------------------------ */

static double ground(double x, double z, double *dx, double *dz)
{
    *dx = 0.091 * cos(0.7 * x + 0.4) * cos(0.55 * z) + 0.0765 * cos(1.7 * x + 1.1 * z);
    *dz = -0.0715 * sin(0.7 * x + 0.4) * sin(0.55 * z) + 0.0495 * cos(1.7 * x + 1.1 * z);
    return 0.13 * sin(0.7 * x + 0.4) * cos(0.55 * z) + 0.045 * sin(1.7 * x + 1.1 * z);
}

static void ground_surface(const void *shape, double u, double v, kit_vertex *out)
{
    double dx, dz;
    (void)shape;
    out->p[0] = 40 * u - 20; out->p[2] = 26 * v - 20;
    out->p[1] = ground(out->p[0], out->p[2], &dx, &dz);
    out->n[0] = -dx; out->n[1] = 1; out->n[2] = -dz;
    kit_unit(out->n);
}

/* a blade of length, width, bent by bend radians in all from a start lean, in the plane of z and y */
static void blade_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, length = s[0], bend = s[2] + 1e-3, lean = s[3], a = lean + bend * v;
    out->p[0] = s[1] * (u - 0.5) * (1 - v * v);
    out->p[1] = length * (sin(a) - sin(lean)) / bend;                    /* a circular arc */
    out->p[2] = length * (cos(lean) - cos(a)) / bend;
    out->n[0] = 0; out->n[1] = -sin(a); out->n[2] = cos(a);
}

/* how far the stone's skin is from p, in units of the direction's radius: 0 on it */
static double stone(const double *seed, const double p[3])
{
    double q[3] = { p[0] / 1.2, p[1] / 0.75, p[2] };
    double length = sqrt(kit_dot(q, q)), x = q[0] / length, y = q[1] / length, z = q[2] / length, s = seed[1];
    return length - 1 - 0.10 * sin(3 * x + s) * cos(2.5 * z - s) - 0.07 * sin(5 * y + 4 * x + 2 * s)
           - 0.03 * sin(9 * z + 7 * x - s) * cos(8 * y);
}

static void stone_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *seed = shape;
    double d[3], k;
    kit_vertex s;
    kit_sphere_surface(seed, u, v, &s);
    for (int i = 0; i < 3; i++) d[i] = s.n[i] * (i == 0 ? 1.2 : i == 1 ? 0.75 : 1);
    /* the skin is at d * k: stone() is affine along d */
    k = 1 - stone(seed, d);
    for (int i = 0; i < 3; i++) {
        double a[3] = { d[0] * k, d[1] * k, d[2] * k }, c[3];
        memcpy(c, a, sizeof c);
        a[i] -= 1e-4; c[i] += 1e-4;
        out->p[i] = seed[0] * d[i] * k;
        out->n[i] = stone(seed, c) - stone(seed, a);
    }
    kit_unit(out->n);
}

static void build_grass(kit_build *b)
{
    static const double stones[][4] = { { -0.75, 0.7, 0.24, 1 },
                                        { -0.4, 0.95, 0.10, 4 },
                                        { 1.15, -0.6, 0.34, 2.2 },
                                        { 1.75, -0.2, 0.15, 0.3 },
                                        { -2.2, -3.6, 0.6, 5 } };
    double dx, dz;
    kit_colour(b, 0.22, 0.21, 0.09);
    kit_patch(b, 160, 104, ground_surface, NULL);
    for (int i = 0; i < 5; i++) {
        const double *s = stones[i], shape[2] = { s[2], s[3] };
        kit_colour(b, 0.50, 0.48, 0.45);
        kit_place_at(b, s[0], ground(s[0], s[1], &dx, &dz) + 0.3 * s[2], s[1], 70 * i);
        kit_patch(b, 96, 48, stone_surface, shape);
    }
    /* as many to each ring of distances: even on the picture */
    for (int i = 0; i < 20000; i++) {
        double distance = 0.9 * pow(18, kit_chance(b)), angle = kit_between(b, -0.85, 0.85), x = distance * sin(angle),
               z = 3 - distance * cos(angle);
        double length = kit_between(b, 0.12, 0.34), width = kit_between(b, 0.008, 0.016),
               bend = kit_between(b, 0.3, 1.6), lean = kit_between(b, 0, 0.25);
        double shape[4] = { length, width, bend, lean };
        double turn = kit_between(b, 0, 360), green = kit_between(b, 0.7, 1.2), dry = kit_chance(b), inside = 0;
        for (int k = 0; k < 5; k++) {
            double ox = x - stones[k][0], oz = z - stones[k][1];
            inside += sqrt(ox * ox + oz * oz) < 0.9 * stones[k][2];
        }
        if (inside > 0) continue;
        kit_colour(b, green * (0.16 + 0.16 * dry * dry), green * 0.32, green * 0.07);
        kit_place_at(b, x, ground(x, z, &dx, &dz) - 0.01, z, turn);
        kit_patch(b, 1, 5, blade_surface, shape);
    }
}

/* ---- >>colonnade -------------------------------------------------------------------------------------------- */

static void soffit_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = KIT_PI * u;                                 /* radius, spring height, half thickness */
    out->p[0] = s[2] * (2 * v - 1); out->p[1] = s[1] + s[0] * sin(a); out->p[2] = s[0] * cos(a);
    out->n[0] = 0; out->n[1] = -sin(a); out->n[2] = -cos(a);
}

/* a wall along z, thickness 2 t, from the springing to the top, with a round arch between two columns half bays away */
static void arch(kit_build *b, double radius, double spring, double top, double t, double half_bay)
{
    const double shape[3] = { radius, spring, t };
    enum { PIECES = 32 };
    kit_patch(b, PIECES, 1, soffit_surface, shape);
    for (int side = -1; side <= 1; side += 2) {
        double z0 = side * radius, z1 = side * half_bay;
        kit_box(b, -t, spring, z0 < z1 ? z0 : z1, t, top, z0 < z1 ? z1 : z0);
        for (int i = 0; i < PIECES; i++) {
            double a = KIT_PI * i / PIECES, c = KIT_PI * (i + 1) / PIECES, x = side * t;
            double q[4][3] = { { x, spring + radius * sin(a), radius * cos(a) },
                               { x, spring + radius * sin(c), radius * cos(c) },
                               { x, top, radius * cos(c) },
                               { x, top, radius * cos(a) } };
            if (side > 0) {                                              /* turn it to face outwards */
                double swap[3];
                memcpy(swap, q[1], sizeof swap); memcpy(q[1], q[3], sizeof swap); memcpy(q[3], swap, sizeof swap);
            }
            kit_quad(b, (const double (*)[3])q);
        }
    }
}

static void column(kit_build *b)
{
    static const kit_moulding profile[] = { { 0.34, 0.10, 0.34, 0.20, 0.05 },  { 0.34, 0.20, 0.31, 0.20, 0 },
                                            { 0.31, 0.20, 0.29, 0.27, -0.02 }, { 0.29, 0.27, 0.30, 0.27, 0 },
                                            { 0.30, 0.27, 0.30, 0.33, 0.03 },  { 0.30, 0.33, 0.25, 0.33, 0 },
                                            { 0.25, 0.33, 0.21, 2.60, 0.015 }, { 0.21, 2.60, 0.21, 2.65, 0.025 },
                                            { 0.21, 2.65, 0.21, 2.74, 0 },     { 0.21, 2.74, 0.24, 2.74, 0 },
                                            { 0.24, 2.74, 0.34, 2.88, 0.035 } };
    kit_box(b, -0.40, 0, -0.40, 0.40, 0.10, 0.40);
    kit_turned(b, profile, (int)(sizeof profile / sizeof *profile), 64);
    kit_box(b, -0.38, 2.88, -0.38, 0.38, 3.0, 0.38);
}

static void build_colonnade(kit_build *b)
{
    enum { BAYS = 8 };
    const double bay = 2.6, first = 5.2, end = first - bay * BAYS,
                 wall[4][3] = { { -4.4, 0, 6 }, { -4.4, 0, end }, { -4.4, 4.9, end }, { -4.4, 4.9, 6 } };
    const double back[4][3] = { {-4.4,0,end}, {2.3,0,end}, {2.3,4.9,end}, {-4.4,4.9,end} };
    kit_colour(b, 0.72, 0.70, 0.64);
    kit_level(b, -4.4, end, 2.3, 6, 0);
    /* steps, outside */
    for (int i = 0; i < 4; i++)
        kit_box(b, 2.3, -0.16 * (i + 1) - 0.02, end, 2.3 + 0.34 * (i + 1), -0.16 * i - (i ? 0 : 1e-3), 6);
    /* and inside */
    for (int i = 0; i < 3; i++) kit_box(b, -1.33, 0.15 * i, end, 1.33, 0.15 * i + 0.15, end + 3.2 - 0.34 * i);
    kit_colour(b, 0.42, 0.45, 0.36); kit_level(b, 2.3, -40, 60, 40, -0.64);
    kit_colour(b, 0.70, 0.58, 0.46); kit_quad(b, wall); kit_quad(b, back);
    for (int i = 0; i <= BAYS; i++)
        for (int row = -1; row <= 1; row += 2) {
            kit_colour(b, 0.78, 0.74, 0.66); kit_place_at(b, 1.75 * row, 0, first - bay * i, 0); column(b);
            kit_colour(b, 0.76, 0.68, 0.58); kit_place_at(b, 1.75 * row, 0, first - bay * i - bay / 2, 0);
            if (i < BAYS) arch(b, bay / 2 - 0.3, 3.0, 4.9, 0.28, bay / 2);
        }
    kit_place_at(b, 0, 0, 0, 0);
    /* ceiling: slab, ribs in two steps */
    kit_colour(b, 0.80, 0.77, 0.70); kit_box(b, -4.4, 4.9, end, 2.03, 5.1, 6);
    for (int step = 0; step < 2; step++) {
        const double half = step ? 0.22 : 0.13, y = step ? 4.75 : 4.55;
        for (int i = 0; i <= 2 * BAYS; i++)
            kit_box(b, -1.47, y, first - bay / 2 * i - half, 1.47, 4.9, first - bay / 2 * i + half);
        for (int i = -1; i <= 1; i++) kit_box(b, 0.98 * i - half + 0.02, y + 0.01, end, 0.98 * i + half - 0.02, 4.9, 6);
    }
    /* pilasters and a bench on the wall */
    for (int i = 0; i < BAYS; i++) {
        kit_place_at(b, -4.4, 0, first - bay * i, 0);
        kit_colour(b, 0.76, 0.70, 0.60); kit_box(b, 0, 0, -0.3, 0.15, 4.9, 0.3);
        kit_colour(b, 0.60, 0.58, 0.54); kit_box(b, 0, 0.40, -2.1, 0.4, 0.48, -0.5);
        kit_box(b, 0, 0, -0.8, 0.35, 0.40, -0.65); kit_box(b, 0, 0, -1.95, 0.35, 0.40, -1.8);
    }
}

/* ---- >>slats: a veranda of things that are thin, most of them with light behind ------------------------------- */

/* hanging from its top edge, s[0] to either side, s[1] long, in s[2] folds of uneven depth, deeper and wider below */
static void curtain_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, folds = 2 * KIT_PI * s[2], a = folds * u + 0.9 * sin(2 * KIT_PI * u + s[3]);
    const double slope = folds + 1.8 * KIT_PI * cos(2 * KIT_PI * u + s[3]), deep = 0.045 + 0.02 * sin(5 * u + s[3]) + 0.035 * v;
    const double drift = 0.07 * v * v, width = 2 * s[0] * (1 + 0.12 * v);
    out->p[0] = width * (u - 0.5); out->p[1] = -s[1] * v; out->p[2] = deep * sin(a) + drift;
    out->n[0] = -(deep * slope * cos(a) + 0.1 * cos(5 * u + s[3]) * sin(a)); out->n[1] = 0; out->n[2] = width;
    kit_unit(out->n);
}

/* an open half pipe along x: half its length, radius */
static void gutter_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = KIT_PI * v;
    out->p[0] = s[0] * (2 * u - 1); out->p[1] = -s[1] * sin(a); out->p[2] = -s[1] * cos(a);
    out->n[0] = 0; out->n[1] = -sin(a); out->n[2] = -cos(a);
}

/* Round links from one point to another, sagging by as much in the middle. */
static void chain(kit_build *b, const double from[3], const double to[3], double sag, const double link[2])
{
    const double way[2] = { to[0] - from[0], to[2] - from[2] }, run = hypot(way[0], way[1]);
    const double turn = 180 / KIT_PI * atan2(way[0], way[1]);
    const double pitch = 2 * link[0] - 3 * link[1], rise = to[1] - from[1];
    double t = 0;
    for (int i = 0; t <= 1; i++) {
        const double slope = rise - 4 * sag * (1 - 2 * t), tilt = 180 / KIT_PI * atan2(slope, run);
        kit_place_tilted(b, from[0] + t * way[0], from[1] + t * rise - 4 * sag * t * (1 - t),
                         from[2] + t * way[1], i & 1 ? turn + 90 : turn, i & 1 ? 90 : -tilt);
        kit_patch(b, 20, 8, kit_torus_surface, link);
        t += pitch / hypot(run, slope);
    }
}

/* A row of slats across: sheets without thickness, or boards. */
static void slats(kit_build *b, const double at[3], double turn, double tilt, double step, int count,
    const double half[3])
{
    const double x = half[0], z = half[2], sheet[4][3] = { {-x, 0, z}, {x, 0, z}, {x, 0, -z}, {-x, 0, -z} };
    for (int i = 0; i < count; i++) {
        kit_place_tilted(b, at[0], at[1] + step * i, at[2], turn, tilt + kit_between(b, -2, 2));
        if (half[1] > 0) kit_box(b, -x, -half[1], -z, x, half[1], z); else kit_quad(b, sheet);
    }
}

static void build_slats(kit_build *b)
{
    static const double link[2] = { 0.024, 0.0045 }, large[2] = { 0.04, 0.008 }, gutter[2] = { 3.4, 0.055 };
    static const double curtain[4] = { 0.62, 2.06, 9, 0.6 }, net[4] = { 0.46, 1.25, 13, 2.2 };
    static const double ball = 0.17, ring[2] = { 0.026, 0.004 };
    static const double blind[3] = { 0.86, 0, 0.024 }, louvre[3] = { 0.25, 0.004, 0.03 };
    static const double inner[4][3] = { {-4,0,-0.9}, {4,0,-0.9}, {4,3,-0.9}, {-4,3,-0.9} };
    static const double hook[3] = { 0.62, 2.66, 0.17 }, drain[3] = { 0.62, 0.02, 0.17 };
    static const double post[3][3] = { {-0.35, 0.92, 2.75}, {1.2, 0.92, 2.2}, {-1.5, 0.92, 3.3} };
    static const double rows[3][3] = { {-0.575, 1.13, -0.06}, {-0.575, 1.62, -0.06}, {-0.575, 1.06, -0.06} };
    kit_colour(b, 0.50, 0.40, 0.30);                                     /* decking over gravel: gaps of a pixel */
    for (int i = 0; i < 58; i++) kit_box(b, -4 + 0.14 * i, -0.028, 0, -3.868 + 0.14 * i, 0, 5.4);
    kit_colour(b, 0.35, 0.34, 0.32); kit_level(b, -4, 0, 4.12, 5.4, -0.2);
    kit_colour(b, 0.74, 0.71, 0.64);                                     /* the wall: window, door, a room behind */
    kit_box(b, -4, -0.2, -0.25, -1.5, 3.2, 0); kit_box(b, -1.5, -0.2, -0.25, 0.35, 0.85, 0);
    kit_box(b, -1.5, 2.2, -0.25, 0.35, 3.2, 0); kit_box(b, 0.35, -0.2, -0.25, 0.95, 3.2, 0);
    kit_box(b, 0.95, 2.25, -0.25, 2.1, 3.2, 0); kit_box(b, 2.1, -0.2, -0.25, 4, 3.2, 0);
    kit_box(b, -4, -0.05, -0.9, 4, 0.001, -0.25);
    kit_colour(b, 0.60, 0.55, 0.50); kit_quad(b, inner);
    kit_colour(b, 0.85, 0.84, 0.80);                                     /* frame, sill, blind with its cords */
    kit_box(b, -1.5, 0.82, -0.2, 0.35, 0.86, 0.06); kit_box(b, -1.5, 2.16, -0.2, 0.35, 2.2, -0.02);
    kit_box(b, -0.595, 0.86, -0.2, -0.555, 2.16, -0.15);
    slats(b, rows[0], 0, 38, 0.044, 11, blind);
    slats(b, rows[1], 0, 12, 0.044, 12, blind);
    slats(b, rows[2], 0, 0, 0.006, 10, blind);
    kit_place_at(b, 0, 0, 0, 0);
    for (int i = 0; i < 3; i++)
        kit_box(b, -1.276 + 0.7 * i, 1.05, -0.037, -1.274 + 0.7 * i, 2.16, -0.035);
    kit_colour(b, 0.55, 0.22, 0.18);                                     /* curtain on rings, a net across the window */
    kit_place_at(b, 1.62, 2.12, 0.13, 0); kit_patch(b, 220, 24, curtain_surface, curtain);
    kit_colour(b, 0.80, 0.80, 0.76);
    kit_place_at(b, -0.95, 2.1, -0.42, 0); kit_patch(b, 260, 12, curtain_surface, net);
    kit_colour(b, 0.30, 0.28, 0.26);
    kit_place_at(b, 0, 0, 0, 0); kit_box(b, 0.85, 2.14, 0.12, 2.4, 2.156, 0.136);
    for (int i = 0; i < 12; i++) {
        kit_place_tilted(b, 1.04 + 0.107 * i, 2.14, 0.13, 90, 90);
        kit_patch(b, 20, 8, kit_torus_surface, ring);
    }
    kit_colour(b, 0.45, 0.44, 0.42);                                     /* gutter on brackets, a chain drains it */
    kit_place_at(b, 0, 2.72, 0.115, 0); kit_patch(b, 1, 14, gutter_surface, gutter);
    kit_place_at(b, 0, 0, 0, 0);
    for (int i = 0; i < 8; i++) kit_box(b, -3.2 + 0.85 * i, 2.63, 0, -3.185 + 0.85 * i, 2.645, 0.175);
    chain(b, hook, drain, 0, link);
    kit_colour(b, 0.36, 0.45, 0.30);                                     /* a screen of three leaves with louvres */
    for (int i = 0; i < 3; i++) {
        const double turn = i == 1 ? -24 : 31, x = -2.72 + 0.50 * i, z = 0.75 + (i == 1 ? 0.02 : 0), high = 1.62;
        const double lowest[3] = { x, 0.20, z };
        kit_place_at(b, x, 0, z, turn);
        for (int k = -1; k <= 1; k += 2)
            kit_box(b, 0.265 * k - 0.02, 0.04, -0.016, 0.265 * k + 0.02, high, 0.016);
        kit_box(b, -0.25, 0.1, -0.014, 0.25, 0.16, 0.014); kit_box(b, -0.25, high - 0.05, -0.014, 0.25, high, 0.014);
        slats(b, lowest, turn, i == 2 ? 70 : 42, 0.05, 28, louvre);
    }
    kit_colour(b, 0.58, 0.40, 0.22);                                     /* a bench of slats */
    kit_place_at(b, -0.75, 0, 0.95, 9);
    for (int i = 0; i < 6; i++) kit_box(b, -0.75, 0.42, -0.21 + 0.075 * i, 0.75, 0.445, -0.155 + 0.075 * i);
    for (int i = 0; i < 4; i++)
        kit_box(b, -0.75, 0.52 + 0.09 * i, -0.27 - 0.014 * i, 0.75, 0.58 + 0.09 * i, -0.25 - 0.014 * i);
    for (int i = -1; i <= 1; i++) {
        const double x0 = 0.66 * i - 0.02, x1 = x0 + 0.04;
        kit_box(b, x0, 0, 0.17, x1, 0.42, 0.21);
        kit_box(b, x0, 0, -0.33, x1, 0.88, -0.29);
        kit_box(b, x0, 0.37, -0.29, x1, 0.42, 0.17);
    }
    kit_colour(b, 0.62, 0.30, 0.20);                                     /* what is solid: a planter, a ball */
    kit_place_at(b, 2.75, 0, 0.45, -14); kit_box(b, -0.22, 0, -0.22, 0.22, 0.5, 0.22);
    kit_colour(b, 0.70, 0.68, 0.62); kit_place_at(b, 0.62, ball + 0.01, 0.75, 0);
    kit_patch(b, 64, 32, kit_sphere_surface, &ball);
    kit_colour(b, 0.20, 0.20, 0.22);                                     /* railing; posts with slack chains */
    kit_place_at(b, 2.2, 0, 1.35, 17);
    for (int i = -1; i <= 1; i++) kit_box(b, 0.95 * i - 0.02, 0, -0.02, 0.95 * i + 0.02, 1.0, 0.02);
    for (int i = 1; i < 19; i++)
        if (i != 10) kit_box(b, -0.956 + 0.1 * i, 0.1, -0.006, -0.944 + 0.1 * i, 0.9, 0.006);
    kit_box(b, -0.95, 0.08, -0.012, 0.95, 0.1, 0.012); kit_box(b, -0.95, 0.9, -0.012, 0.95, 0.925, 0.012);
    kit_box(b, -1.0, 1.0, -0.03, 1.0, 1.03, 0.03);
    for (int i = 0; i < 3; i++) { kit_place_at(b, post[i][0], 0, post[i][2], 0); kit_cylinder(b, 0.022, 0.95, 24); }
    chain(b, post[0], post[1], 0.2, large);
    chain(b, post[0], post[2], 0.22, large);
}

/* ---- >>closed scenes: every solid is a closed two-manifold that touches no other, so depth peeling finds fronts and
   backs in pairs */

static void build_cornell(kit_build *b)
{
    const double gap = 0.003;
    kit_colour(b, 0.73, 0.73, 0.73);
    kit_begin_object(b, "walls", 0);
    /* floor, ceiling, back */
    kit_box(b, -2.98, -0.2, -5.79, 2.98, 0, 0); kit_box(b, -2.98, 5.49, -5.79, 2.98, 5.69, 0);
    kit_box(b, -2.98, gap, -5.79, 2.98, 5.49 - gap, -5.59);
    kit_begin_object(b, "low box", 1);
    kit_place_at(b, 0.925, gap, -1.69, -17);  kit_box(b, -0.825, 0, -0.825, 0.825, 1.65, 0.825);
    kit_begin_object(b, "high box", 1);
    kit_place_at(b, -0.905, gap, -3.51, 17);  kit_box(b, -0.825, 0, -0.825, 0.825, 3.30, 0.825);
    b->object = 1;                                                       /* walls again */
    kit_place_at(b, 0, 0, 0, 0);
    kit_colour(b, 0.63, 0.06, 0.05); kit_box(b, -2.98, gap, -5.59 + gap, -2.78, 5.49 - gap, 0);
    kit_colour(b, 0.14, 0.45, 0.09); kit_box(b, 2.78, gap, -5.59 + gap, 2.98, 5.49 - gap, 0);
}

static void build_columns(kit_build *b)
{
    /* none behind the last */
    static const double hidden[4][3] = { {0.88, 0.16, 0.48}, {0.10, 0.24, 0.85}, {0.88, 0.70, 0.06}, {0, 0, 0} };
    const double gap = 0.003;
    kit_colour(b, 0.60, 0.60, 0.60);
    kit_box(b, -7, -0.2, -1.7, 7, 0, 4); kit_box(b, -7, gap, -1.7, 7, 4, -1.4);
    for (int i = 0; i < 4; i++) {
        const double x = 1.6 * i - 2.4;
        kit_colour(b, 0.80, 0.80, 0.78);
        kit_place_at(b, x, gap, 0, 0);
        if (i & 1) kit_cylinder(b, 0.32, 2.2, 64);
        else kit_box(b, -0.3, 0, -0.3, 0.3, 2.2, 0.3);
        kit_colour(b, hidden[i][0], hidden[i][1], hidden[i][2]);
        kit_place_at(b, 1.153 * x, gap, -0.95, 0);                              /* in line with the eye */
        if (i < 3) kit_box(b, -0.27, 0, -0.28, 0.27, 1.9, 0.28);
    }
    kit_place_at(b, 0, gap, 0, 0);
    /* a panel seen edge-on */
    kit_colour(b, 0.10, 0.60, 0.16); kit_box(b, -0.03, 0, -1.2, 0.03, 1.1, 0.2);
    /* right of the picture */
    kit_colour(b, 0.88, 0.24, 0.04); kit_place_at(b, 4.08, gap, -0.63, -28);
    kit_box(b, -0.32, 0, -0.32, 0.32, 1.4, 0.32);
}

static void build_plates(kit_build *b)
{
    static const double lying[2] = { 0.5, 0.05 }, standing[2] = { 0.42, 0.035 };
    kit_colour(b, 0.62, 0.60, 0.57); kit_box(b, -7, -0.2, -7, 7, 0, 4);
    kit_colour(b, 0.75, 0.72, 0.66);
    kit_place_at(b, -0.65, 0.95, -0.35, 18);  kit_box(b, -0.7, -0.015, -0.45, 0.7, 0.015, 0.45);
    kit_place_at(b, 0.95, 0.28, 0.75, -12);   kit_box(b, -0.42, -0.015, -0.32, 0.42, 0.015, 0.32);
    kit_colour(b, 0.70, 0.26, 0.20); kit_place_at(b, -0.75, 0.4, -0.2, 30);
    kit_box(b, -0.38, -0.012, -0.3, 0.38, 0.012, 0.3);
    kit_colour(b, 0.24, 0.42, 0.66);
    kit_place_tilted(b, 1.15, 0.75, -0.55, -35, 35);
    kit_box(b, -0.4, -0.012, -0.4, 0.4, 0.012, 0.4);
    kit_colour(b, 0.30, 0.55, 0.28); kit_place_at(b, -1.0, 0.12, 1.0, 35);
    kit_box(b, -0.45, 0, -0.012, 0.45, 0.5, 0.012);
    kit_colour(b, 0.78, 0.62, 0.22); kit_place_at(b, 0.2, 1.3, 0.15, -30);
    kit_box(b, -1.6, -0.03, -0.03, 1.6, 0.03, 0.03);
    kit_place_tilted(b, 0.1, 0.42, 1.2, 80, 12);
    kit_box(b, -0.025, -0.025, -0.75, 0.025, 0.025, 0.75);
    kit_colour(b, 0.68, 0.68, 0.70);
    kit_place_at(b, 0.3, 0.55, 0.1, 0);                  kit_patch(b, 96, 24, kit_torus_surface, lying);
    kit_place_tilted(b, -1.75, 0.5, 0.35, 50, 70);    kit_patch(b, 96, 24, kit_torus_surface, standing);
}

static void build_pebbles(kit_build *b)
{
    /* x, z, turn, half sides, height */
    static const double tables[2][6] = { {-0.25, -0.2, 24, 0.24, 0.15, 0.30}, {0.48, 0.22, -31, 0.11, 0.11, 0.17} };
    const double gap = 0.0005, cell = 0.1, leg = 0.007;
    kit_colour(b, 0.60, 0.58, 0.55); kit_box(b, -1.8, -0.1, -1.8, 1.8, 0, 1.8);
    for (int i = 0; i < 24 * 24; i++) {                                  /* one to a cell, and within it */
        double x = cell * (i % 24 - 11.5), z = cell * (i / 24 - 11.5), size = kit_between(b, 0.01, 0.032),
               kind = kit_chance(b), tone = kit_between(b, 0.50, 0.72);
        double height = size * kit_between(b, 0.3, 1.5), slack = cell / 2 - 1.42 * size, turn = kit_between(b, 0, 360);
        int blocked = kit_chance(b) < 0.2;
        x += slack * kit_between(b, -1, 1); z += slack * kit_between(b, -1, 1);
        for (int k = 0; k < 2; k++) {                                    /* a table's leg is here */
            const double *t = tables[k], c = cos(t[2] * KIT_PI / 180), s = sin(t[2] * KIT_PI / 180), dx = x - t[0],
                         dz = z - t[1];
            blocked |= hypot(fabs(c * dx - s * dz) - t[3], fabs(s * dx + c * dz) - t[4]) < 1.42 * (size + leg);
        }
        if (blocked) continue;
        kit_colour(b, tone, 0.97 * tone, 0.92 * tone);
        kit_place_at(b, x, kind < 0.25 ? gap + size : gap, z, turn);
        if (kind < 0.25) kit_patch(b, 24, 12, kit_sphere_surface, &size);
        else if (kind < 0.55) kit_cylinder(b, size, 0.6 * height, 20);
        else kit_box(b, -size, 0, -0.7 * size, size, height, 0.7 * size);
    }
    kit_colour(b, 0.56, 0.44, 0.33);
    for (int k = 0; k < 2; k++) {
        const double *t = tables[k], x = t[3], z = t[4], y = t[5];
        kit_place_at(b, t[0], gap, t[1], t[2]);
        kit_box(b, -x - 0.02, y + gap, -z - 0.02, x + 0.02, y + 0.02, z + 0.02);
        for (int i = -1; i <= 1; i += 2)
            for (int j = -1; j <= 1; j += 2) kit_box(b, i * x - leg, 0, j * z - leg, i * x + leg, y, j * z + leg);
    }
}

static void build_boxes(kit_build *b)
{
    const double gap = 0.0005;
    kit_colour(b, 0.82, 0.82, 0.82);
    kit_begin_object(b, "floor", 0);
    kit_box(b, -9, -0.2, -9, 9, 0, 5);
    for (int i = -1; i <= 1; i++) {
        kit_begin_object(b, "box", 1);
        kit_place_at(b, 1.4 * i, gap, i ? 0.2 : -0.2, 0);
        kit_box(b, -0.5, 0, -0.5, 0.5, i ? 0.8 : 1.1, 0.5);
    }
}

static void build_blocks(kit_build *b)
{
    const double gap = 0.0005;
    kit_colour(b, 0.82, 0.82, 0.82);
    kit_begin_object(b, "floor", 0);
    kit_box(b, -12, -0.2, -12, 12, 0, 7);
    for (int i = 0; i < 12; i++) {
        const double wide = kit_between(b, 0.26, 0.38), deep = kit_between(b, 0.26, 0.38),
                     high = kit_between(b, 0.5, 2.2);
        kit_begin_object(b, "block", 1);
        kit_place_at(b, 1.05 * (i % 4 - 1.5) + kit_between(b, -0.1, 0.1), gap,
            1.05 * (i / 4 - 1) + kit_between(b, -0.1, 0.1), 0);
        kit_box(b, -wide, 0, -deep, wide, high, deep);
    }
}

/* ---- >>occluders: a few shapes of size 1, many times over ------------------------------------------------------- */

static void make_cube(kit_build *b) { kit_box(b, -0.5, -0.5, -0.5, 0.5, 0.5, 0.5); }

static void make_ball(kit_build *b)
{
    static const double radius = 0.5;
    kit_patch(b, 48, 24, kit_sphere_surface, &radius);
}

static void make_torus(kit_build *b)
{
    static const double ring[2] = { 0.37, 0.13 };
    kit_patch(b, 48, 20, kit_torus_surface, ring);
}

static void make_cone(kit_build *b)
{
    static const kit_moulding profile[] = { {0, -0.5, 0.45, -0.5, 0}, {0.45, -0.5, 0, 0.5, 0} };
    kit_turned(b, profile, 2, 48);
}

static void make_table(kit_build *b)
{
    kit_box(b, -0.6, 0.3, -0.4, 0.6, 0.36, 0.4);
    for (int i = 0; i < 4; i++) {
        const double x = i & 1 ? 0.53 : -0.53, z = i & 2 ? 0.33 : -0.33;
        kit_box(b, x - 0.04, -0.36, z - 0.04, x + 0.04, 0.3, z + 0.04);
    }
}

enum { CUBE, BALL, TORUS, CONE, TABLE, KINDS };
static const struct { const char *name; void (*make)(kit_build *); double albedo[3];
} kinds[KINDS] = { { "cube", make_cube, { 0.78, 0.74, 0.66 } },
                   { "ball", make_ball, { 0.70, 0.42, 0.34 } },
                   { "torus", make_torus, { 0.40, 0.55, 0.66 } },
                   { "cone", make_cone, { 0.72, 0.62, 0.30 } },
                   { "table", make_table, { 0.48, 0.58, 0.42 } } };

/* An object of a kind, resting on the level y: the ground at 0, else on the object before or its stack. */
static void occluder(kit_build *b, int kind, double size, double x, double y, double z, double turn, double tilt)
{
    kit_scene *s = &b->scene;
    const int k = s->objects;
    float m[16] = { (float)size, 0, 0, 0,  0, (float)size, 0, 0,  0, 0, (float)size, 0,  0, 0, 0, 1 };
    kit_place_at(b, 0, 0, 0, 0);
    kit_colour(b, kinds[kind].albedo[0], kinds[kind].albedo[1], kinds[kind].albedo[2]);
    kit_begin_object(b, kinds[kind].name, 1);
    kinds[kind].make(b);
    if (b->failed) return;
    for (int i = 0; i < k; i++)
        if (!strcmp(s->object[i].name, kinds[kind].name)) s->object[k].shape = s->object[i].shape;
    if (s->object[k].shape < 0 && kit_own_shape(s, k)) { b->failed = 1; return; }
    kit_place_tilted(b, x, y, z, turn, tilt);
    kit_pose(b, m, m);
    kit_place_above(s, k, m, y + KIT_GAP);
    memcpy(s->object[k].loaded, s->object[k].to_world, sizeof m);
    s->object[k].base = y > 0 ? s->object[k - 1].base : k;
}

static void build_ground(kit_build *b, double half)
{
    kit_colour(b, 0.72, 0.72, 0.70);
    kit_begin_object(b, "ground", 0);
    kit_box(b, -half, -0.2, -half, half, 0, half);
}

static void build_casters(kit_build *b)
{
    static const struct { int kind; double size, x, y, z, turn, tilt;
    } set[] = { { CUBE, 1.2, -2.6, 0, -1.6, 20, 0 },    { CUBE, 0.7, -2.5, 1.2, -1.6, 55, 0 },
                { BALL, 0.5, -2.5, 1.9, -1.6, 0, 0 },   { CUBE, 0.8, -1.6, 0, -0.5, -12, 0 },
                { CUBE, 1.0, -0.35, 0, -1.9, 38, 0 },   { CUBE, 0.6, -3.5, 0, 0.1, 5, 0 },
                { CUBE, 0.5, -0.6, 0, 0.5, 62, 0 },     { CUBE, 0.35, -0.6, 0.5, 0.5, 20, 0 },
                { CUBE, 0.9, -2.45, 0, 0.75, 30, 33 },  { TABLE, 1.7, 1.5, 0, -1.1, -18, 0 },
                { CONE, 0.7, 1.05, 1.224, -1.2, 0, 0 }, { TORUS, 0.8, 1.9, 1.224, -0.95, 0, 0 },
                { BALL, 0.3, 1.9, 1.224, -0.95, 0, 0 }, { BALL, 0.7, 1.4, 0, -1.0, 0, 0 },
                { BALL, 1.1, 3.2, 0, 0.5, 0, 0 },       { CONE, 1.3, 0.6, 0, 0.7, 0, 0 },
                { CONE, 0.9, 2.0, 0, 1.4, 40, 114 },    { TORUS, 1.2, -1.4, 0, 1.7, 0, 0 },
                { TORUS, 1.1, 3.55, 0, -1.2, 60, 72 },  { TORUS, 0.7, 0.1, 0, 1.9, 25, 90 },
                { TABLE, 0.8, 1.1, 0, 2.3, 30, 180 },   { TABLE, 0.9, -3.7, 0, 1.6, -40, 90 },
                { BALL, 0.6, -2.4, 0, 2.2, 0, 0 },      { CUBE, 0.45, 2.9, 0, 2.1, 15, 45 } };
    build_ground(b, 14);
    for (size_t i = 0; i < sizeof set / sizeof *set; i++)
        occluder(b, set[i].kind, set[i].size, set[i].x, set[i].y, set[i].z, set[i].turn, set[i].tilt);
}

static void build_crowd(kit_build *b)
{
    build_ground(b, 24);
    for (int i = 0; i < 100; i++) {                                      /* every third leans or lies */
        const double size = kit_between(b, 0.5, 1.1), x = 1.7 * (i % 10 - 4.5) + kit_between(b, -0.3, 0.3),
                     z = 1.7 * (i / 10 - 4.5) + kit_between(b, -0.3, 0.3);
        const double turn = kit_between(b, 0, 360), tilt = kit_between(b, 20, 160);
        occluder(b, (i + i / 10 * 2) % KINDS, size, x, 0, z, turn, i % 3 ? 0 : tilt);
    }
}

/* ---- >>all -------------------------------------------------------------------------------------------------- */

static const kit_builtin builtins[] = {
    { "room",
      "corner of a furnished room: boxes, books, thin railing, torus, lamp",
      build_room,
      { 4.55f, 1.75f, 4.25f },
      { 1.35f, 0.85f, 0.85f },
      50,
      0.1f,
      0.5f },
    { "grass",
      "some thousands of bent blades on rolling ground, with stones",
      build_grass,
      { 0, 0.85f, 3 },
      { 0, 0.05f, 0.2f },
      42,
      0.05f,
      0.3f },
    { "colonnade",
      "columns, arches, coffered ceiling and steps",
      build_colonnade,
      { -0.75f, 1.75f, 2.9f },
      { 0.35f, 2.0f, -6 },
      55,
      0.05f,
      0.8f },
    { "cornell",
      "open box: red and green walls, two white boxes",
      build_cornell,
      { 0, 2.745f, 7.7f },
      { 0, 2.745f, 0 },
      38,
      0.1f,
      1.5f },
    { "columns",
      "white columns, coloured ones hidden behind them, a box off screen",
      build_columns,
      { 0, 1.7f, 6.2f },
      { 0, 0.95f, 0 },
      33,
      0.1f,
      1 },
    { "plates",
      "thin plates, bars and hoops floating over a floor",
      build_plates,
      { 1.3f, 3.3f, 4.0f },
      { 0, 0.45f, 0.05f },
      36,
      0.1f,
      0.8f },
    { "pebbles",
      "some hundred small boxes, studs and balls, two tables on thin legs",
      build_pebbles,
      { 0.35f, 0.65f, 1.5f },
      { 0.05f, 0.08f, 0 },
      36,
      0.05f,
      0.08f },
    { "slats",
      "a veranda: blinds, louvres, decking, curtains, railing, chains, a gutter",
      build_slats,
      { -1.9f, 1.65f, 4.6f },
      { 0.35f, 1.0f, 0.2f },
      42,
      0.1f,
      0.4f },
    { "boxes",
      "three white boxes near each other on a floor",
      build_boxes,
      { 0.25f, 3.3f, 3.6f },
      { 0, 0.3f, 0 },
      34,
      0.1f,
      0.6f },
    { "blocks",
      "a dozen of white tower blocks, from above",
      build_blocks,
      { 2.4f, 6.0f, 4.6f },
      { 0.1f, 0.5f, 0.1f },
      31,
      0.1f,
      0.5f },
    { "casters",
      "two dozen shapes standing, leaning, lying on a ground and on each other",
      build_casters,
      { 2.2f, 5.6f, 8.3f },
      { 0, 0.4f, 0 },
      34,
      0.1f,
      0.8f },
    { "crowd",
      "a hundred such shapes on a wide ground",
      build_crowd,
      { 5.5f, 9.5f, 16 },
      { 0, 0, 0.8f },
      33,
      0.1f,
      0.8f },
    { "plane", "one big square", build_plane, { 0, 1.5f, 2 }, { 0, 0, 0 }, 45, 0.1f, 0.5f },
    { "corner",
      "floor (y = 0) and wall (x = 0) at a right angle",
      build_corner,
      { 3.2f, 1.9f, 2.6f },
      { 0.4f, 0.5f, 0 },
      40,
      0.1f,
      0.5f },
    { "groove",
      "a square groove in a plane, 1 wide and 1 deep, along z",
      build_groove,
      { 0.9f, 2.4f, 2.6f },
      { 0, -0.3f, 0 },
      34,
      0.1f,
      0.5f },
    { "sphere",
      "a sphere of radius 1 on a big plane",
      build_sphere,
      { 1.5f, 3.6f, 4.2f },
      { 0, 0.7f, 0 },
      34,
      0.1f,
      1 },
    { "hole",
      "a cubic hole in a plane, 1 wide and 1 deep",
      build_hole,
      { 0.9f, 2.2f, 1.9f },
      { 0, -0.3f, 0 },
      30,
      0.1f,
      0.5f },
};
enum { BUILTINS = sizeof builtins / sizeof *builtins };

const kit_builtin *kit_builtin_at(int i) { return i >= 0 && i < BUILTINS ? &builtins[i] : NULL; }
