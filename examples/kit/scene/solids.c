/* solids.c - builds scenes of closed solids, and of objects that cast. Declared in kit_build.h. */
#include "kit/kit_build.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- >>closed scenes: every solid is a closed two-manifold that touches no other, so depth peeling finds fronts and
   backs in pairs */

void kit_build_cornell(kit_build *b)
{
    const double gap = 0.00002;
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

void kit_build_columns(kit_build *b)
{
    /* the last hides none */
    static const double hidden[4][3] = { {0.88, 0.16, 0.48}, {0.10, 0.24, 0.85}, {0.88, 0.70, 0.06}, {0, 0, 0} };
    const double gap = 0.00002;
    kit_colour(b, 0.60, 0.60, 0.60);
    kit_box(b, -7, -0.2, -1.7, 7, 0, 4); kit_box(b, -7, gap, -1.7, 7, 4, -1.4);
    for (int i = 0; i < 4; i++) {
        const double x = 1.6 * i - 2.4;
        kit_colour(b, 0.80, 0.80, 0.78);
        kit_place_at(b, x, gap, 0, 0);
        if (i & 1) kit_cylinder(b, 0.32, 2.2, 64);
        else kit_box(b, -0.3, 0, -0.3, 0.3, 2.2, 0.3);
        kit_colour(b, hidden[i][0], hidden[i][1], hidden[i][2]);
        kit_place_at(b, 1.153 * x, gap, -0.95, 0);                              /* the object is in line with the eye */
        if (i < 3) kit_box(b, -0.27, 0, -0.28, 0.27, 1.9, 0.28);
    }
    kit_place_at(b, 0, gap, 0, 0);
    /* adds a panel seen edge-on */
    kit_colour(b, 0.10, 0.60, 0.16); kit_box(b, -0.03, 0, -1.2, 0.03, 1.1, 0.2);
    /* this object is outside the image, to the right */
    kit_colour(b, 0.88, 0.24, 0.04); kit_place_at(b, 4.08, gap, -0.63, -28);
    kit_box(b, -0.32, 0, -0.32, 0.32, 1.4, 0.32);
}

void kit_build_plates(kit_build *b)
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

void kit_build_pebbles(kit_build *b)
{
    /* a table's x, z, turn, half sides, height */
    static const double tables[2][6] = { {-0.25, -0.2, 24, 0.24, 0.15, 0.30}, {0.48, 0.22, -31, 0.11, 0.11, 0.17} };
    const double gap = 0.0005, cell = 0.1, leg = 0.007;
    kit_colour(b, 0.60, 0.58, 0.55); kit_box(b, -1.8, -0.1, -1.8, 1.8, 0, 1.8);
    for (int i = 0; i < 24 * 24; i++) {                                  /* one in each cell */
        double x = cell * (i % 24 - 11.5), z = cell * (i / 24 - 11.5), size = kit_between(b, 0.01, 0.032),
               kind = kit_chance(b), tone = kit_between(b, 0.50, 0.72);
        double height = size * kit_between(b, 0.3, 1.5), slack = cell / 2 - 1.42 * size, turn = kit_between(b, 0, 360);
        int blocked = kit_chance(b) < 0.2;
        x += slack * kit_between(b, -1, 1); z += slack * kit_between(b, -1, 1);
        for (int k = 0; k < 2; k++) {                                    /* here is a table's leg */
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

void kit_build_boxes(kit_build *b)
{
    const double gap = 0.00002;
    kit_colour(b, 0.82, 0.82, 0.82);
    kit_begin_object(b, "floor", 0);
    kit_box(b, -9, -0.2, -9, 9, 0, 5);
    for (int i = -1; i <= 1; i++) {
        kit_begin_object(b, "box", 1);
        kit_place_at(b, 1.4 * i, gap, i ? 0.2 : -0.2, 0);
        kit_box(b, -0.5, 0, -0.5, 0.5, i ? 0.8 : 1.1, 0.5);
    }
}

void kit_build_spheres(kit_build *b)
{
    /* a ball's x, z, radius, height above the floor */
    static const double ball[][4] = { {-2.1, -0.6, 1, 0.001}, {-0.45, -1.7, 0.9, 0.001}, {0.95, -0.5, 0.8, 0.05},
                                      {2.3, 0.3, 0.7, 0.001}, {-0.35, 0.5, 0.6, 0.001}, {0.45, 1.45, 0.5, 0.001},
                                      {-1.35, 1.35, 0.5, 0.12} };
    kit_begin_object(b, "floor", 0);
    kit_box(b, -16, -0.2, -16, 16, 0, 8);
    for (size_t i = 0; i < sizeof ball / sizeof *ball; i++) {
        kit_begin_object(b, "ball", 1);
        kit_place_at(b, ball[i][0], ball[i][2] + ball[i][3], ball[i][1], 0);
        kit_patch(b, 128, 64, kit_sphere_surface, &ball[i][2]);
    }
}

void kit_build_blocks(kit_build *b)
{
    const double gap = 0.00002;
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

/* ---- >>occluders: a few shapes of size 1, each used many times -------------------------------------------------- */

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

/* Adds an object that rests on the level y: on the ground if y is 0, else on the object before or its stack. */
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

void kit_build_casters(kit_build *b)
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

void kit_build_crowd(kit_build *b)
{
    build_ground(b, 24);
    for (int i = 0; i < 100; i++) {                                      /* every third object leans or lies */
        const double size = kit_between(b, 0.5, 1.1), x = 1.7 * (i % 10 - 4.5) + kit_between(b, -0.3, 0.3),
                     z = 1.7 * (i / 10 - 4.5) + kit_between(b, -0.3, 0.3);
        const double turn = kit_between(b, 0, 360), tilt = kit_between(b, 20, 160);
        occluder(b, (i + i / 10 * 2) % KINDS, size, x, 0, z, turn, i % 3 ? 0 : tilt);
    }
}
