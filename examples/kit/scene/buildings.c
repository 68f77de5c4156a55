/* buildings.c - built-in scenes: a room, a colonnade. Declared in kit_build.h. */
#include "kit/kit_build.h"
#include <math.h>
#include <string.h>

/* Floor, walls, ceiling, skirting. */
static void room_walls(kit_build *b)
{
    static const double walls[2][4][3] = { { { 0, 0, 6 }, { 0, 0, 0 }, { 0, 2.8, 0 }, { 0, 2.8, 6 } },
                                           { { 0, 0, 0 }, { 6, 0, 0 }, { 6, 2.8, 0 }, { 0, 2.8, 0 } } };
    static const double ceiling[4][3] = { {0,2.8,0}, {6,2.8,0}, {6,2.8,6}, {0,2.8,6} };
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
}

static void bookcase(kit_build *b)
{
    kit_colour(b, 0.55, 0.38, 0.22);
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
}

static void radiator_and_picture(kit_build *b)
{
    kit_colour(b, 0.80, 0.80, 0.78);
    for (int i = 0; i < 14; i++) kit_box(b, 0.06, 0.15, 1.2 + 0.07 * i, 0.16, 0.75, 1.25 + 0.07 * i);
    kit_box(b, 0.09, 0.2, 1.2, 0.13, 0.24, 2.16); kit_box(b, 0.09, 0.66, 1.2, 0.13, 0.7, 2.16);
    kit_colour(b, 0.25, 0.17, 0.10);
    kit_box(b, 0, 1.3, 1.2, 0.04, 1.35, 2.2);
    kit_box(b, 0, 2.0, 1.2, 0.04, 2.05, 2.2);
    kit_box(b, 0, 1.35, 1.2, 0.04, 2.0, 1.25);
    kit_box(b, 0, 1.35, 2.15, 0.04, 2.0, 2.2);
    kit_colour(b, 0.75, 0.70, 0.55); kit_box(b, 0, 1.35, 1.25, 0.01, 2.0, 2.15);
}

static void boxes_in_the_corner(kit_build *b)
{
    kit_colour(b, 0.70, 0.62, 0.48);
    kit_place_at(b, 0.55, 0, 0.55, 8);    kit_box(b, -0.38, 0, -0.35, 0.38, 0.7, 0.35);
    kit_place_at(b, 0.5, 0.7, 0.5, -17);  kit_box(b, -0.25, 0, -0.22, 0.25, 0.42, 0.22);
    kit_place_at(b, 0.55, 1.12, 0.52, 31); kit_box(b, -0.13, 0, -0.13, 0.13, 0.22, 0.13);
    kit_colour(b, 0.25, 0.35, 0.60);
    kit_place_at(b, 1.35, 0, 0.75, -24);  kit_box(b, -0.17, 0, -0.14, 0.17, 0.24, 0.14);
}

static void rug_and_table(kit_build *b)
{
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
}

/* Adds things on the table, a ball on the floor, and a lamp above. */
static void on_the_table(kit_build *b)
{
    static const kit_moulding shade[] = { {0.24, 0, 0.08, 0.22, 0.01}, {0.08, 0.22, 0, 0.22, 0} };
    static const kit_moulding vase[] = { { 0, 0, 0.07, 0, 0 },
                                         { 0.07, 0, 0.05, 0.2, 0.06 },
                                         { 0.05, 0.2, 0.065, 0.26, -0.012 },
                                         { 0.065, 0.26, 0, 0.255, 0 } };
    static const double ball = 0.28, globe = 0.09, ring[2] = { 0.16, 0.05 };
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
}

static void room_railing(kit_build *b)
{
    kit_colour(b, 0.20, 0.20, 0.22);
    kit_place_at(b, 3.75, 0, 1.35, -38);
    for (int i = -1; i <= 1; i++) kit_box(b, 0.7 * i - 0.025, 0, -0.025, 0.7 * i + 0.025, 0.98, 0.025);
    for (int i = 1; i < 14; i++)
        if (i != 7) kit_box(b, -0.7 + 0.1 * i - 0.008, 0.12, -0.008, -0.7 + 0.1 * i + 0.008, 0.84, 0.008);
    kit_box(b, -0.7, 0.1, -0.012, 0.7, 0.13, 0.012);
    kit_box(b, -0.7, 0.83, -0.012, 0.7, 0.86, 0.012);
    kit_box(b, -0.76, 0.95, -0.04, 0.76, 0.99, 0.04);
}

void kit_build_room(kit_build *b)
{
    room_walls(b);
    bookcase(b);
    radiator_and_picture(b);
    boxes_in_the_corner(b);
    rug_and_table(b);
    on_the_table(b);
    room_railing(b);
}

/* ---- >>colonnade -------------------------------------------------------------------------------------------- */

static void soffit_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = KIT_PI * u;                          /* shape: radius, spring height, half thickness */
    out->p[0] = s[2] * (2 * v - 1); out->p[1] = s[1] + s[0] * sin(a); out->p[2] = s[0] * cos(a);
    out->n[0] = 0; out->n[1] = -sin(a); out->n[2] = -cos(a);
}

/* Adds a wall along z, 2 t thick, from the springing to the top, with a round arch between two columns, each half_bay
   away. */
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
            if (side > 0) {                                              /* turns the arch to face outwards */
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

void kit_build_colonnade(kit_build *b)
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
    /* pilasters and a bench along the wall */
    for (int i = 0; i < BAYS; i++) {
        kit_place_at(b, -4.4, 0, first - bay * i, 0);
        kit_colour(b, 0.76, 0.70, 0.60); kit_box(b, 0, 0, -0.3, 0.15, 4.9, 0.3);
        kit_colour(b, 0.60, 0.58, 0.54); kit_box(b, 0, 0.40, -2.1, 0.4, 0.48, -0.5);
        kit_box(b, 0, 0, -0.8, 0.35, 0.40, -0.65); kit_box(b, 0, 0, -1.95, 0.35, 0.40, -1.8);
    }
}
