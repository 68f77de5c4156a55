/* thin.c - builds scenes of thin things: grass, a veranda. Declared in kit_build.h. */
#include "kit/kit_build.h"
#include <math.h>
#include <string.h>

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

/* Writes a point of a blade, length by width in the plane of z and y, bent from start lean by bend radians. */
static void blade_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, length = s[0], bend = s[2] + 1e-3, lean = s[3], a = lean + bend * v;
    out->p[0] = s[1] * (u - 0.5) * (1 - v * v);
    out->p[1] = length * (sin(a) - sin(lean)) / bend;                    /* a circular arc */
    out->p[2] = length * (cos(lean) - cos(a)) / bend;
    out->n[0] = 0; out->n[1] = -sin(a); out->n[2] = cos(a);
}

/* Returns a stone's signed distance at p, in units of the stone's radius in that direction: 0 on the surface. */
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
    /* the surface is at d * k, because stone() is affine along d */
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

void kit_build_grass(kit_build *b)
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
    /* equally many blades in each ring of distances, so that they are evenly dense in the image */
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

/* ---- >>slats: a veranda of thin things, most of them lit from behind -------------------------------------------- */

/* Writes a point of a curtain: s[0] half width, s[1] length, s[2] folds of uneven depth, deeper and wider below. */
static void curtain_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, folds = 2 * KIT_PI * s[2], a = folds * u + 0.9 * sin(2 * KIT_PI * u + s[3]);
    const double slope = folds + 1.8 * KIT_PI * cos(2 * KIT_PI * u + s[3]),
                 deep = 0.045 + 0.02 * sin(5 * u + s[3]) + 0.035 * v;
    const double drift = 0.07 * v * v, width = 2 * s[0] * (1 + 0.12 * v);
    out->p[0] = width * (u - 0.5); out->p[1] = -s[1] * v; out->p[2] = deep * sin(a) + drift;
    out->n[0] = -(deep * slope * cos(a) + 0.1 * cos(5 * u + s[3]) * sin(a)); out->n[1] = 0; out->n[2] = width;
    kit_unit(out->n);
}

/* Writes a point of an open half pipe along x: half length, radius. */
static void gutter_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = KIT_PI * v;
    out->p[0] = s[0] * (2 * u - 1); out->p[1] = -s[1] * sin(a); out->p[2] = -s[1] * cos(a);
    out->n[0] = 0; out->n[1] = -sin(a); out->n[2] = -cos(a);
}

/* Adds round links from one point to another, which sag by sag in the middle. */
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

/* Adds a row of slats across: sheets without thickness, or boards. */
static void slats(kit_build *b, const double at[3], double turn, double tilt, double step, int count,
    const double half[3])
{
    const double x = half[0], z = half[2], sheet[4][3] = { {-x, 0, z}, {x, 0, z}, {x, 0, -z}, {-x, 0, -z} };
    for (int i = 0; i < count; i++) {
        kit_place_tilted(b, at[0], at[1] + step * i, at[2], turn, tilt + kit_between(b, -2, 2));
        if (half[1] > 0) kit_box(b, -x, -half[1], -z, x, half[1], z); else kit_quad(b, sheet);
    }
}

static void veranda(kit_build *b)
{
    static const double inner[4][3] = { {-4,0,-0.9}, {4,0,-0.9}, {4,3,-0.9}, {-4,3,-0.9} };
    kit_colour(b, 0.50, 0.40, 0.30);                                /* adds decking over gravel, with gaps of a pixel */
    for (int i = 0; i < 58; i++) kit_box(b, -4 + 0.14 * i, -0.028, 0, -3.868 + 0.14 * i, 0, 5.4);
    kit_colour(b, 0.35, 0.34, 0.32); kit_level(b, -4, 0, 4.12, 5.4, -0.2);
    kit_colour(b, 0.74, 0.71, 0.64);                                    /* adds the wall: window, door, a room behind */
    kit_box(b, -4, -0.2, -0.25, -1.5, 3.2, 0); kit_box(b, -1.5, -0.2, -0.25, 0.35, 0.85, 0);
    kit_box(b, -1.5, 2.2, -0.25, 0.35, 3.2, 0); kit_box(b, 0.35, -0.2, -0.25, 0.95, 3.2, 0);
    kit_box(b, 0.95, 2.25, -0.25, 2.1, 3.2, 0); kit_box(b, 2.1, -0.2, -0.25, 4, 3.2, 0);
    kit_box(b, -4, -0.05, -0.9, 4, 0.001, -0.25);
    kit_colour(b, 0.60, 0.55, 0.50); kit_quad(b, inner);
}

/* Adds a frame, a sill and a blind with its cords. */
static void window_and_blind(kit_build *b)
{
    static const double blind[3] = { 0.86, 0, 0.024 };
    static const double rows[3][3] = { {-0.575, 1.13, -0.06}, {-0.575, 1.62, -0.06}, {-0.575, 1.06, -0.06} };
    kit_colour(b, 0.85, 0.84, 0.80);
    kit_box(b, -1.5, 0.82, -0.2, 0.35, 0.86, 0.06); kit_box(b, -1.5, 2.16, -0.2, 0.35, 2.2, -0.02);
    kit_box(b, -0.595, 0.86, -0.2, -0.555, 2.16, -0.15);
    slats(b, rows[0], 0, 38, 0.044, 11, blind);
    slats(b, rows[1], 0, 12, 0.044, 12, blind);
    slats(b, rows[2], 0, 0, 0.006, 10, blind);
    kit_place_at(b, 0, 0, 0, 0);
    for (int i = 0; i < 3; i++)
        kit_box(b, -1.276 + 0.7 * i, 1.05, -0.037, -1.274 + 0.7 * i, 2.16, -0.035);
}

/* Adds a curtain on rings and a net across the window. */
static void curtains(kit_build *b)
{
    static const double curtain[4] = { 0.62, 2.06, 9, 0.6 }, net[4] = { 0.46, 1.25, 13, 2.2 };
    static const double ring[2] = { 0.026, 0.004 };
    kit_colour(b, 0.55, 0.22, 0.18);
    kit_place_at(b, 1.62, 2.12, 0.13, 0); kit_patch(b, 220, 24, curtain_surface, curtain);
    kit_colour(b, 0.80, 0.80, 0.76);
    kit_place_at(b, -0.95, 2.1, -0.42, 0); kit_patch(b, 260, 12, curtain_surface, net);
    kit_colour(b, 0.30, 0.28, 0.26);
    kit_place_at(b, 0, 0, 0, 0); kit_box(b, 0.85, 2.14, 0.12, 2.4, 2.156, 0.136);
    for (int i = 0; i < 12; i++) {
        kit_place_tilted(b, 1.04 + 0.107 * i, 2.14, 0.13, 90, 90);
        kit_patch(b, 20, 8, kit_torus_surface, ring);
    }
}

/* Adds the gutter on brackets and a chain that drains it. */
static void gutter_and_chain(kit_build *b)
{
    static const double link[2] = { 0.024, 0.0045 }, gutter[2] = { 3.4, 0.055 };
    static const double hook[3] = { 0.62, 2.66, 0.17 }, drain[3] = { 0.62, 0.02, 0.17 };
    kit_colour(b, 0.45, 0.44, 0.42);
    kit_place_at(b, 0, 2.72, 0.115, 0); kit_patch(b, 1, 14, gutter_surface, gutter);
    kit_place_at(b, 0, 0, 0, 0);
    for (int i = 0; i < 8; i++) kit_box(b, -3.2 + 0.85 * i, 2.63, 0, -3.185 + 0.85 * i, 2.645, 0.175);
    chain(b, hook, drain, 0, link);
}

/* Adds a screen of three leaves with louvres. */
static void screen(kit_build *b)
{
    static const double louvre[3] = { 0.25, 0.004, 0.03 };
    kit_colour(b, 0.36, 0.45, 0.30);
    for (int i = 0; i < 3; i++) {
        const double turn = i == 1 ? -24 : 31, x = -2.72 + 0.50 * i, z = 0.75 + (i == 1 ? 0.02 : 0), high = 1.62;
        const double lowest[3] = { x, 0.20, z };
        kit_place_at(b, x, 0, z, turn);
        for (int k = -1; k <= 1; k += 2)
            kit_box(b, 0.265 * k - 0.02, 0.04, -0.016, 0.265 * k + 0.02, high, 0.016);
        kit_box(b, -0.25, 0.1, -0.014, 0.25, 0.16, 0.014); kit_box(b, -0.25, high - 0.05, -0.014, 0.25, high, 0.014);
        slats(b, lowest, turn, i == 2 ? 70 : 42, 0.05, 28, louvre);
    }
}

static void bench(kit_build *b)
{
    kit_colour(b, 0.58, 0.40, 0.22);
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
}

/* The solid things. */
static void planter_and_ball(kit_build *b)
{
    static const double ball = 0.17;
    kit_colour(b, 0.62, 0.30, 0.20);
    kit_place_at(b, 2.75, 0, 0.45, -14); kit_box(b, -0.22, 0, -0.22, 0.22, 0.5, 0.22);
    kit_colour(b, 0.70, 0.68, 0.62); kit_place_at(b, 0.62, ball + 0.01, 0.75, 0);
    kit_patch(b, 64, 32, kit_sphere_surface, &ball);
}

/* Adds a railing, and posts with slack chains. */
static void railing_and_posts(kit_build *b)
{
    static const double large[2] = { 0.04, 0.008 };
    static const double post[3][3] = { {-0.35, 0.92, 2.75}, {1.2, 0.92, 2.2}, {-1.5, 0.92, 3.3} };
    kit_colour(b, 0.20, 0.20, 0.22);
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

void kit_build_slats(kit_build *b)
{
    veranda(b);
    window_and_blind(b);
    curtains(b);
    gutter_and_chain(b);
    screen(b);
    bench(b);
    planter_and_ball(b);
    railing_and_posts(b);
}
