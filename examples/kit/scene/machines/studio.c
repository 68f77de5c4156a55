/* studio.c - machines' other scenes by seed: assemblies seen close in a studio, corridors of panels. Declared in
   machines.h. */
#include "kit/scene/machines/machines.h"
#include <math.h>
#include <string.h>

/* ---- >>studio --------------------------------------------------------------------------------------------------- */

typedef struct exhibit {
    const char *name;
    void (*make)(kit_build *);
    double wide, deep, reach;
} exhibit;

static const exhibit exhibits[] = {
    { "gear train", plant_train, 1.3, 0.9, 0.9 },        { "gearbox", plant_gearbox, 1.4, 0.6, 0.9 },
    { "shaft", plant_coupling, 1.5, 0.5, 0.9 },          { "board", plant_board, 1.25, 1.05, 0.9 },
    { "star engine", plant_star_engine, 1.2, 0.8, 1.1 }, { "stack", plant_stack, 2, 0.5, 1 },
    { "engine", plant_engine, 1.6, 0.9, 1.2 },           { "board", plant_board, 1.25, 1.05, 0.5 }
};

static void show(kit_plot *p, const exhibit *e, double x, double z, double turn, double high)
{
    kit_build *b = &p->b;
    if (high > 0.03) {
        kit_begin_object(b, "plinth", -1);
        const kit_frame stand = kit_enter(b, x, 0, z, turn, 1);
        kit_colour(b, 0.6, 0.6, 0.58);
        kit_bevelled(b, -e->wide - 0.1, 0.001, -e->deep - 0.1, e->wide + 0.1, high, e->deep + 0.1, 0.015);
        kit_leave(b, stand);
    }
    kit_begin_object(b, e->name, -1);
    const kit_frame before = kit_enter(b, x, high, z, turn, 1);
    e->make(b);
    kit_leave(b, before);
    kit_add_sight(p, x, high + 0.4 * e->reach, z, e->reach);
    kit_add_sight(p, x + 0.3, high + 0.3, z + 0.1, 0.45 * e->reach);
    kit_add_sight(p, x - 0.4, high + 0.25, z, 0.3 * e->reach);
}

/* loose parts about an exhibit: bolts, rings, gears, springs */
static void loose_parts(kit_plot *p, double x, double z)
{
    kit_build *b = &p->b;
    kit_begin_object(b, "loose parts", -1);
    for (int k = 0; k < 22; k++) {
        const double a = kit_between(b, 0, 2 * KIT_PI), r = kit_between(b, 0, 0.7), px = x + r * cos(a),
                     pz = z + r * sin(a);
        const double size = kit_between(b, 0.02, 0.05);
        plant_stuff(b, kit_odds(b, 0.6) ? KIT_STEEL : KIT_BRASS);
        kit_place_at(b, px, 0.002, pz, kit_between(b, 0, 90));
        switch (kit_choose(b, 4)) {
        case 0:
            plant_bolt(b, size, 0.8 * size);
            kit_cylinder(b, 0.6 * size, 4 * size, 10);
            break;
        case 1: plant_hoop(b, KIT_AT(px, 0.002 + 0.3 * size, pz), 0, 0, 2 * size, 0.3 * size, 24); break;
        case 2: plant_gear(b, 3 * size, 16, size, 0); break;
        default: plant_rod(b, KIT_AT(px, 0.003 + size, pz), KIT_AT(px + 0.2, 0.003 + size, pz + 0.1), size, 14);
        }
    }
    kit_add_sight(p, x, 0.05, z, 0.5);
}

void kit_make_studio(kit_plot *p)
{
    kit_build *b = &p->b;
    const kit_hall r = { kit_between(b, 7, 11), kit_between(b, 6, 9), kit_between(b, 3.2, 4.5),
                         kit_odds(b, 0.5) ? 0 : kit_choose(b, 6), kit_choose(b, 4) };
    const int count = 2 + kit_choose(b, 3), first = kit_choose(b, 8);
    plant_build_hall(p, &r);
    for (int k = 0; k < count; k++) {
        const double x = count > 1 ? 0.24 * r.w * (k & 1 ? 1 : -1) : 0,
                     z = count > 2 ? 0.22 * r.d * (k & 2 ? 1 : -1) : 0;
        show(p, &exhibits[(first + 3 * k) % 8], x, z, kit_between(b, -25, 25),
             kit_odds(b, 0.6) ? kit_between(b, 0.1, 0.8) : 0);
    }
    for (int k = 0; k < 2; k++) loose_parts(p, kit_between(b, -0.4, 0.4) * r.w, (k ? 0.42 : -0.42) * r.d);
    kit_begin_object(b, "cabinet", -1);
    kit_frame before = kit_enter(b, 0.3 * r.w, 0, 0.6 - 0.5 * r.d, 0, 1);
    plant_cabinet(b);
    kit_leave(b, before);
    kit_begin_object(b, "bench", -1);
    before = kit_enter(b, -0.25 * r.w, 0, 0.7 - 0.5 * r.d, 0, 1);
    plant_bench(b);
    kit_leave(b, before);
    kit_add_sight(p, -0.25 * r.w, 0.95, 0.7 - 0.5 * r.d, 0.6);
    for (int k = 0; k < 4; k++) {
        const double side = k & 1 ? 1 : -1, z = (k & 2 ? 0.2 : -0.22) * r.d;
        kit_begin_object(b, "shelving", -1);
        before = kit_enter(b, side * (0.5 * r.w - 0.5), 0, z, -90 * side, 1);
        if (kit_odds(b, 0.6)) plant_shelving(b);
        else plant_pallet(b);
        kit_leave(b, before);
        kit_add_sight(p, side * (0.5 * r.w - 0.7), 0.8, z, 0.7);
    }
}

/* ---- >>corridor -------------------------------------------------------------------------------------------------- */

/* Small raised forms on a panel of the plane z = 0. */
static void greebles(kit_build *b, double x0, double y0, double x1, double y1, int count)
{
    for (int k = 0; k < count; k++) {
        const double w = kit_between(b, 0.03, 0.25) * (x1 - x0), h = kit_between(b, 0.04, 0.3) * (y1 - y0),
                     deep = kit_between(b, 0.01, 0.08);
        const double x = kit_between(b, x0, x1 - w), y = kit_between(b, y0, y1 - h);
        if (kit_odds(b, 0.3)) plant_stuff(b, kit_odds(b, 0.8) ? KIT_STEEL : KIT_PLASTIC);
        kit_place_at(b, x, y, 0, 0);
        switch (kit_choose(b, 5)) {
        case 0:
        case 1: kit_bevelled(b, 0, 0, -0.02, w, h, deep, 0.2 * fmin(deep, fmin(w, h))); break;
        case 2:
            for (int i = 0; i < 5; i++) kit_box(b, 0, h * i / 5, -0.01, w, h * (i + 0.6) / 5, deep);
            break;
        case 3: plant_rod(b, KIT_AT(x, y, -0.01), KIT_AT(x, y, deep), 0.4 * fmin(w, h) + 0.01, 16); break;
        default: {
            const double pipe[4][3] = {
                { x, y, -0.02 }, { x, y, deep + 0.03 }, { x + w, y + h, deep + 0.03 }, { x + w, y + h, -0.02 }
            };
            plant_pipe(b, pipe, 4, 0.012, 0);
        }
        }
    }
}

typedef struct passage {
    double half, length, h, bay, slope;
    int bays;
    float paint[2][3];
} passage;

/* one bay of one side: a lower, a middle and an upper panel, leaning in above by slope */
static void bay_side(kit_build *b, const passage *g)
{
    const double w = 0.5 * g->bay - 0.1, middle = 0.36 * g->h, upper = 0.72 * g->h;
    const int accent = kit_odds(b, 0.2);
    memcpy(b->albedo, g->paint[accent], sizeof b->albedo);
    kit_place_at(b, 0, 0, 0, 0);
    const double back[4][3] = {
        { -w - 0.1, -0.31, -0.05 }, { w + 0.1, -0.31, -0.05 }, { w + 0.1, g->h, -0.05 }, { -w - 0.1, g->h, -0.05 }
    };
    kit_quad(b, back);
    kit_bevelled(b, -w, 0.05, -0.04, w, middle - 0.02, kit_between(b, 0.02, 0.12), 0.012);
    if (kit_odds(b, 0.8)) kit_bevelled(b, -w, middle, -0.04, w, upper - 0.02, 0.0, 0.01);
    kit_place_tilted(b, 0, upper, 0, 0, g->slope);
    kit_bevelled(b, -w, 0, -0.04, w, (g->h - upper) / cos(g->slope * KIT_PI / 180), 0.02, 0.01);
    plant_stuff(b, KIT_STEEL);
    greebles(b, -w, middle, w, upper, 6 + kit_choose(b, 22));
    plant_rod(b, KIT_AT(-w - 0.1, middle + 0.02, 0.09), KIT_AT(w + 0.1, middle + 0.02, 0.09), 0.022, 10);
}

static void rib(kit_build *b, const passage *g, double wide)
{
    const double a = g->half, h = g->h, cut = 0.5 * (h - 0.72 * h);
    const double at[6][3] = { { -a, 0, 0 },      { -a, h - cut, 0 }, { cut - a, h, 0 },
                              { a - cut, h, 0 }, { a, h - cut, 0 },  { a, 0, 0 } };
    plant_stuff(b, KIT_DARK);
    for (int k = 0; k < 5; k++) plant_beam(b, at[k], at[k + 1], wide, wide + 0.01 * (k & 1));
    plant_stuff(b, KIT_STEEL);
    for (int k = 0; k < 8; k++) {
        kit_place_tilted(b, (k & 1 ? 1 : -1) * (a - 0.5 * wide + 0.001), 0.3 + 0.25 * k, 0, k & 1 ? -90 : 90, 90);
        plant_bolt(b, 0.025, 0.015);
    }
}

static void end_door(kit_build *b, const passage *g)
{
    const double w = 0.7 * g->half, h = 0.82 * g->h, out = g->half + 0.06,
                 plane[4][3] = { { -out, -0.31, 0 }, { out, -0.31, 0 }, { out, g->h, 0 }, { -out, g->h, 0 } };
    plant_stuff(b, KIT_DARK);
    kit_place_at(b, 0, 0, 0, 0);
    kit_quad(b, plane);
    kit_bevelled(b, -w - 0.15, 0, 0.001, w + 0.15, h + 0.15, 0.15, 0.04);
    plant_stuff(b, KIT_PAINT);
    for (int k = 0; k < 2; k++) kit_bevelled(b, k ? 0.008 : -w, 0.03, 0.1, k ? w : -0.008, h, 0.2, 0.03);
    kit_frame face = kit_enter(b, 0, 0, 0.2, 0, 1);
    greebles(b, -0.9 * w, 0.62 * h, 0.9 * w, 0.95 * h, 9);
    kit_leave(b, face);
    kit_place_at(b, 0, 0, 0.195, 0);
    for (int k = 0; k < 4; k++) {
        const double x = w * (0.5 * k - 0.75);
        kit_bevelled(b, x - 0.2 * w, 0.1, 0, x + 0.2 * w, 0.4 * h, 0.03, 0.02);
    }
    plant_stuff(b, KIT_STEEL);
    for (int k = 0; k < 5; k++)
        plant_rod(b, KIT_AT(-w + 0.05, 0.2 + 0.4 * k, 0.22), KIT_AT(w - 0.05, 0.2 + 0.4 * k, 0.22), 0.014, 8);
    plant_hoop(b, KIT_AT(0, 0.5 * h, 0.25), 0, 90, 0.22, 0.025, 32);
}

/* the floor: plates, or gratings over a channel of pipes */
static void passage_floor(kit_plot *p, const passage *g)
{
    kit_build *b = &p->b;
    const double l = 0.5 * g->length, inner = 0.55 * g->half;
    kit_begin_object(b, "ground", 0);
    plant_stuff(b, KIT_DARK);
    kit_level(b, -g->half - 20, -l - 20, g->half + 20, l + 20, -0.3);
    kit_begin_object(b, "floor", 0);
    plant_stuff(b, KIT_STEEL);
    for (int k = 0; k < g->bays; k++) {
        const double z0 = -l + g->bay * k, z1 = z0 + g->bay;
        for (int s = -1; s < 2; s += 2)
            kit_box(b, s > 0 ? inner : -g->half, -0.05, z0 + 0.005, s > 0 ? g->half : -inner, 0, z1 - 0.005);
        if (kit_odds(b, 0.6)) plant_grating(b, 0.01 - inner, z0 + 0.02, inner - 0.01, z1 - 0.02, -0.005, 0.04);
        else kit_bevelled(b, 0.01 - inner, -0.05, z0 + 0.01, inner - 0.01, 0, z1 - 0.01, 0.01);
    }
    kit_begin_object(b, "pipes below", -1);
    for (int k = 0; k < 5; k++) {
        const double x = inner * (0.4 * k - 0.8), r = kit_between(b, 0.02, 0.06);
        plant_stuff(b, KIT_PIPE);
        plant_rod(b, KIT_AT(x, -0.29 + r, -l), KIT_AT(x, -0.29 + r, l), r, 10);
    }
}

static void passage_above(kit_plot *p, const passage *g)
{
    kit_build *b = &p->b;
    const double l = 0.5 * g->length, out = g->half + 0.06,
                 plane[4][3] = { { -out, g->h, -l }, { out, g->h, -l }, { out, g->h, l }, { -out, g->h, l } };
    kit_begin_object(b, "ceiling", 0);
    plant_stuff(b, KIT_PAINT);
    kit_quad(b, plane);
    for (int k = 0; k < g->bays; k++) {
        const double z = -l + g->bay * (k + 0.5);
        kit_colour(b, 0.85, 0.86, 0.88);
        if (kit_odds(b, 0.7)) kit_box(b, -0.25, g->h - 0.06, z - 0.3 * g->bay, 0.25, g->h - 0.001, z + 0.3 * g->bay);
        if (kit_odds(b, 0.4)) kit_add_lamp(p, 0, g->h - 0.25, z);
    }
    kit_begin_object(b, "pipes", -1);
    const int pipes = 3 + kit_choose(b, 4);
    for (int k = 0; k < pipes; k++) {
        const double x = (k & 1 ? 1 : -1) * (g->half - 0.35 - 0.11 * (k / 2)), r = kit_between(b, 0.015, 0.05),
                     y = g->h - 0.1 - 0.02 * k;
        plant_stuff(b, KIT_PIPE);
        plant_rod(b, KIT_AT(x, y, -l), KIT_AT(x, y, l), r, 12);
        plant_flange(b, KIT_AT(x, y, kit_between(b, -0.4, 0.4) * l), KIT_AT(x, y, 99), r);
    }
}

void kit_make_passage(kit_plot *p)
{
    kit_build *b = &p->b;
    passage g = {
        kit_between(b, 1.1, 1.9), 0,        kit_between(b, 2.4, 3), kit_between(b, 1.3, 2.2), kit_between(b, 5, 35),
        6 + kit_choose(b, 5),     { { 0 } }
    };
    g.length = g.bays * g.bay;
    for (int k = 0; k < 2; k++) {
        plant_stuff(b, !k && kit_odds(b, 0.6) ? KIT_STEEL : KIT_PAINT);
        memcpy(g.paint[k], b->albedo, sizeof g.paint[k]);
    }
    passage_floor(p, &g);
    passage_above(p, &g);
    for (int k = 0; k <= g.bays; k++) {
        const double z = g.bay * k - 0.5 * g.length;
        kit_begin_object(b, "rib", 0);
        kit_frame before = kit_enter(b, 0, 0, z, 0, 1);
        rib(b, &g, 0.2);
        kit_leave(b, before);
        for (int s = -1; s < 2 && k < g.bays; s += 2) {
            kit_begin_object(b, "panels", -1);
            before = kit_enter(b, s * g.half, 0, z + 0.5 * g.bay, -90.0 * s, 1);
            bay_side(b, &g);
            kit_leave(b, before);
            if (kit_odds(b, 0.4))
                kit_add_sight(p, s * (g.half - 0.2), kit_between(b, 1, 1.6), z + 0.5 * g.bay, kit_between(b, 0.4, 1));
        }
    }
    for (int s = -1; s < 2; s += 2) {
        kit_begin_object(b, "door", -1);
        const kit_frame before = kit_enter(b, 0, 0, 0.5 * s * g.length, s > 0 ? 180 : 0, 1);
        end_door(b, &g);
        kit_leave(b, before);
        kit_add_sight(p, 0, 1, 0.3 * s * g.length, 1.5);
    }
    for (int k = 0; k < 5; k++) { /* what was left there */
        const double s = kit_odds(b, 0.5) ? 1 : -1, z = kit_between(b, -0.4, 0.4) * g.length;
        kit_begin_object(b, k & 1 ? "barrels" : "case", -1);
        const kit_frame before = kit_enter(b, s * (g.half - 0.42), 0, z, 90 + kit_between(b, -10, 10), 0.6);
        if (k & 1) plant_barrels(b);
        else {
            plant_stuff(b, KIT_PLASTIC);
            kit_bevelled(b, -0.6, 0.002, -0.35, 0.6, kit_between(b, 0.4, 0.9), 0.35, 0.04);
        }
        kit_leave(b, before);
        kit_add_sight(p, s * (g.half - 0.42), 0.4, z, 0.5);
    }
    p->stand[0] = 0.3 - g.half;
    p->stand[1] = 0.5 - 0.5 * g.length;
    p->stand[2] = g.half - 0.3;
    p->stand[3] = 0.5 * g.length - 0.5;
    p->ceiling = g.h - 0.15;
}
