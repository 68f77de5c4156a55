/* works.c - closed rooms for machines: walls with relief, doors, trunking, ceilings, floors. In machines.h. */
#include "kit/scene/machines/machines.h"
#include <math.h>
#include <string.h>

/* ---- >>walls --------------------------------------------------------------------------------------------------- */

/* Relief of a wall from x = -half to half, its plane z = 0, looking towards +z. */
static void wall_relief(kit_build *b, double half, double h, int way)
{
    const double step = kit_between(b, 1.6, 3.2);
    const int count = (int)fmax(1, floor(2 * half / step));
    const double wide = 2 * half / count;
    for (int k = 0; k < count; k++) {
        const double x = -half + wide * k;
        if (way == 0) /* panels */
            for (int row = 0; row < 2; row++)
                kit_bevelled(b, x + 0.01, row * 0.5 * h + 0.01, -0.02, x + wide - 0.01, (row + 1) * 0.5 * h - 0.01,
                             0.03, 0.012);
        if (way == 2) kit_box(b, x, 0, -0.01, x + 0.3, h, 0.18); /* piers */
        if (way == 3) {                                          /* steel posts and rails */
            plant_ibeam(b, KIT_AT(x + 0.12, 0, 0.1), KIT_AT(x + 0.12, h, 0.1), 0.18);
            plant_beam(b, KIT_AT(x, 0.45 * h, 0.03), KIT_AT(x + wide, 0.45 * h, 0.03), 0.06, 0.1);
            kit_place_at(b, 0, 0, 0, 0);
        }
    }
    for (double x = -half; way == 1 && x < half - 0.1; x += 0.24) { /* corrugated sheet, one layer */
        static const double step_at[5][2] = {
            { 0, 0.012 }, { 0.08, 0.012 }, { 0.12, 0.06 }, { 0.2, 0.06 }, { 0.24, 0.012 }
        };
        for (int k = 0; k < 4; k++) {
            const double *s = step_at[k], *t = step_at[k + 1];
            const double strip[4][3] = {
                { x + s[0], 0, s[1] }, { x + t[0], 0, t[1] }, { x + t[0], h, t[1] }, { x + s[0], h, s[1] }
            };
            kit_quad(b, strip);
        }
    }
    if (way == 4) { /* blocks, in courses */
        const int rows = (int)fmin(12, h / 0.3), columns = (int)fmin(24, 2 * half / 0.6);
        for (int k = 0; k < rows * columns; k++) {
            const double y = h / rows * (k / columns), cell = 2 * half / columns,
                         shift = k / columns & 1 ? 0.5 * cell : 0, x = -half + cell * (k % columns) + shift;
            kit_box(b, x + 0.008, y + 0.006, -0.01, fmin(half, x + cell) - 0.008, y + h / rows - 0.006, 0.012);
        }
    }
}

/* A frame with bars before a bright pane, or a door, or a grille. */
static void wall_opening(kit_build *b, double x, double h, int way)
{
    kit_frame before = kit_enter(b, x, 0, 0, 0, 1);
    if (way == 0) {
        const double y0 = fmin(1.2, 0.4 * h), y1 = fmin(h - 0.3, y0 + 1.6);
        kit_colour(b, 0.62, 0.7, 0.78);
        kit_box(b, -0.9, y0, 0.02, 0.9, y1, 0.075);
        plant_stuff(b, KIT_STEEL);
        for (int k = 0; k < 5; k++) kit_box(b, -0.92 + 0.45 * k, y0 - 0.03, 0.07, -0.88 + 0.45 * k, y1 + 0.03, 0.14);
        for (int k = 0; k < 4; k++)
            kit_box(b, -0.92, y0 - 0.03 + (y1 - y0) * k / 3, 0.072, 0.92, y0 + 0.03 + (y1 - y0) * k / 3, 0.13);
        kit_box(b, -1.02, y0 - 0.09, 0.03, 1.02, y0 - 0.03, 0.24);
    } else if (way == 1) {
        const double y1 = fmin(2.1, h - 0.2);
        plant_stuff(b, KIT_PAINT);
        kit_box(b, -0.85, 0.002, 0.02, 0.85, y1 + 0.08, 0.08);
        plant_stuff(b, KIT_PAINT);
        for (int k = 0; k < 2; k++) kit_bevelled(b, -0.77 + 0.78 * k, 0.02, 0.06, -0.01 + 0.78 * k, y1, 0.12, 0.01);
        plant_stuff(b, KIT_STEEL);
        for (int k = -1; k < 2; k += 2) plant_rod(b, KIT_AT(0.1 * k, 0.9, 0.17), KIT_AT(0.1 * k, 1.2, 0.17), 0.014, 10);
        kit_place_at(b, 0, 0, 0, 0);
        kit_box(b, -0.72, 0.05, 0.12, -0.06, 0.3, 0.125);
        kit_box(b, 0.06, 0.05, 0.12, 0.72, 0.3, 0.125);
    } else {
        const double y = 0.55 * h;
        plant_stuff(b, KIT_STEEL);
        kit_box(b, -0.5, y - 0.04, 0.02, 0.5, y, 0.14);
        kit_box(b, -0.5, y + 0.6, 0.02, 0.5, y + 0.64, 0.14);
        kit_box(b, -0.54, y - 0.04, 0.02, -0.5, y + 0.64, 0.14);
        kit_box(b, 0.5, y - 0.04, 0.02, 0.54, y + 0.64, 0.14);
        for (int k = 0; k < 12; k++) {
            const double s = y + 0.05 * k, slat[4][3] = {
                { -0.5, s, 0.13 }, { 0.5, s, 0.13 }, { 0.5, s + 0.05, 0.06 }, { -0.5, s + 0.05, 0.06 }
            };
            kit_quad(b, slat);
        }
    }
    kit_leave(b, before);
}

/* trunking, switches, conduits, signs */
static void wall_clutter(kit_build *b, double half, double h)
{
    const double tray = fmin(h - 0.35, kit_between(b, 2.2, 3));
    plant_stuff(b, KIT_STEEL);
    kit_box(b, 0.05 - half, tray, 0.19, half - 0.05, tray + 0.1, 0.25);
    for (double x = 0.3 - half; x < half; x += 1.1) kit_box(b, x, tray - 0.04, 0.01, x + 0.04, tray, 0.26);
    for (int k = 0; k < (int)(1.2 * half); k++) {
        const double x = kit_between(b, 0.4 - half, half - 0.4), y = kit_between(b, 0.9, 1.6),
                     s = kit_between(b, 0.06, 0.2);
        plant_stuff(b, KIT_STEEL);
        plant_rod(b, KIT_AT(x, y + s, 0.21), KIT_AT(x, tray + 0.01, 0.21), 0.012, 8);
        plant_stuff(b, KIT_PLASTIC);
        kit_place_at(b, x, y, 0.17, 0);
        kit_bevelled(b, -s, -s, 0, s, s, 0.12, 0.01);
        if (kit_odds(b, 0.5)) plant_rod(b, KIT_AT(x, y, 0.28), KIT_AT(x, y, 0.33), 0.3 * s, 12);
    }
    kit_place_at(b, 0, 0, 0, 0);
    if (kit_odds(b, 0.6)) { /* extinguisher */
        const double x = kit_between(b, 0.5 - half, half - 0.5);
        kit_colour(b, 0.6, 0.06, 0.05);
        plant_rod(b, KIT_AT(x, 0.5, 0.3), KIT_AT(x, 0.95, 0.3), 0.08, 18);
        kit_colour(b, 0.08, 0.08, 0.08);
        plant_rod(b, KIT_AT(x, 0.95, 0.3), KIT_AT(x, 1.06, 0.3), 0.03, 10);
        kit_cable(b, KIT_AT(x, 1.03, 0.33), KIT_AT(x + 0.09, 0.7, 0.36), 0.06, 0.012, 8);
    }
}

static void walls(kit_plot *p, const kit_hall *r)
{
    kit_build *b = &p->b;
    const uint32_t alike = kit_draw_seed(b);
    float wall[3];
    plant_stuff(b, kit_odds(b, 0.3) ? KIT_PAINT : KIT_CONCRETE);
    memcpy(wall, b->albedo, sizeof wall);
    for (int k = 0; k < 4; k++) {
        const double half = 0.5 * (k & 1 ? r->d : r->w), away = 0.5 * (k & 1 ? r->w : r->d);
        const double turn = 90.0 * k, x = k == 1 ? -away : k == 3 ? away : 0, z = k == 0 ? -away : k == 2 ? away : 0;
        const double plane[4][3] = { { -half, 0, 0 }, { half, 0, 0 }, { half, r->h, 0 }, { -half, r->h, 0 } };
        const kit_frame before = kit_enter(b, x, 0, z, turn, 1);
        kit_begin_object(b, "wall", 0);
        memcpy(b->albedo, wall, sizeof wall);
        kit_quad(b, plane);
        for (int i = 0; i < 3; i++) b->albedo[i] *= 0.94f;
        kit_chances chances;
        kit_alike(b, alike, &chances);
        wall_relief(b, half, r->h, r->walls);
        kit_resume(b, &chances);
        kit_place_at(b, 0, 0, 0, 0);
        for (double at = 1.3 - half; at < half - 1.2; at += kit_between(b, 2.4, 5))
            if (kit_odds(b, 0.6)) wall_opening(b, at, r->h, kit_choose(b, 3));
        if (kit_odds(b, 0.75)) wall_clutter(b, half, r->h);
        kit_leave(b, before);
        if (k & 1) kit_add_sight(p, 0.8 * x, 1.2, 0.3 * r->d, 1.5);
    }
}

static void truss(kit_build *b, const double from[3], const double to[3], double deep)
{
    const int bays = 8;
    for (int k = 0; k <= bays; k++) {
        double low[2][3];
        for (int j = 0; j < 2; j++)
            for (int i = 0; i < 3; i++)
                low[j][i] = from[i] + (to[i] - from[i]) * fmin(bays, k + j) / bays
                          - (i == 1 && (k + j) & 1 ? 0
                             : i == 1              ? deep
                                                   : 0);
        if (k < bays) plant_beam(b, low[0], low[1], 0.05, 0.05);
    }
    plant_ibeam(b, from, to, 0.14);
    plant_beam(b, KIT_AT(from[0], from[1] - deep, from[2]), KIT_AT(to[0], to[1] - deep, to[2]), 0.1, 0.1);
}

/* ---- >>above and below ------------------------------------------------------------------------------------------ */

static void roof(kit_plot *p, const kit_hall *r)
{
    kit_build *b = &p->b;
    const double w = 0.5 * r->w, d = 0.5 * r->d, h = r->h, e = 40,
                 plane[4][3] = {
                     { -w - e, h, -d - e }, { w + e, h, -d - e }, { w + e, h, d + e }, { -w - e, h, d + e }
                 };
    kit_begin_object(b, "ceiling", 0);
    plant_stuff(b, KIT_CONCRETE);
    kit_quad(b, plane);
    for (double x = 0.8 - w; x < w && r->roof == 0; x += 1.5) kit_box(b, x, h - 0.25, -d, x + 0.2, h - 0.0005, d);
    for (double x = 0.8 - w; x < w && r->roof == 1; x += 3)
        truss(b, KIT_AT(x, h - 0.1, -d), KIT_AT(x, h - 0.1, d), fmin(0.9, 0.15 * h));
    kit_place_at(b, 0, 0, 0, 0);
    for (double x = -w; x < w && r->roof == 2; x += 0.6) { /* hanging tiles */
        kit_box(b, x - 0.012, h - 0.05, -d, x + 0.012, h - 0.001, d);
        for (double z = -d; z < d; z += 0.6)
            if (kit_odds(b, 0.93)) kit_box(b, x + 0.012, h - 0.04, z + 0.012, x + 0.588, h - 0.03, z + 0.588);
    }
    for (double x = -w; x < w - 0.1 && r->roof == 3; x += 0.3) kit_box(b, x, h - 0.08, -d, x + 0.15, h - 0.001, d);
    kit_begin_object(b, "lamps", -1);
    const double down = fmin(1.2, 0.12 * h) + 0.2;
    for (double x = 1.5 - w; x < w - 0.5; x += fmax(2.6, 0.25 * r->w))
        for (double z = 1.4 - d; z < d - 0.5; z += fmax(2.4, 0.3 * r->d)) {
            kit_colour(b, 0.85, 0.85, 0.82);
            kit_place_at(b, x, h - down, z, 0);
            kit_box(b, -0.09, -0.05, -0.65, 0.09, 0, 0.65);
            plant_stuff(b, KIT_STEEL);
            for (int s = -1; s < 2; s += 2)
                plant_rod(b, KIT_AT(x, h - down, z + 0.5 * s), KIT_AT(x, h, z + 0.5 * s), 0.006, 6);
            if (kit_odds(b, 0.5)) kit_add_lamp(p, x, h - down - 0.25, z);
        }
}

static void floor_marks(kit_build *b, const kit_hall *r)
{
    const double w = 0.5 * r->w, d = 0.5 * r->d;
    kit_begin_object(b, "ground", 0);
    plant_stuff(b, KIT_CONCRETE);
    kit_level(b, -w - 40, -d - 40, w + 40, d + 40, 0); /* also for cameras without perspective */
    kit_colour(b, 0.7, 0.58, 0.1);
    if (kit_odds(b, 0.5))
        for (int s = -1; s < 2; s += 2) kit_level(b, 0.8 - w, s * 0.28 * d - 0.04, w - 0.8, s * 0.28 * d + 0.04, 0.002);
    kit_colour(b, 0.16, 0.16, 0.16);
    for (int k = 0; k < 2 && kit_odds(b, 0.5); k++)
        plant_grating(b, 0.5 - w, (k ? 0.42 : -0.46) * r->d, w - 0.5, (k ? 0.45 : -0.43) * r->d, 0.035, 0.03);
}

/* The closed room; one may stand within it. */
void plant_build_hall(kit_plot *p, const kit_hall *r)
{
    floor_marks(&p->b, r);
    walls(p, r);
    roof(p, r);
    p->stand[0] = 0.35 - 0.5 * r->w;
    p->stand[1] = 0.35 - 0.5 * r->d;
    p->stand[2] = 0.5 * r->w - 0.35;
    p->stand[3] = 0.5 * r->d - 0.35;
    p->ceiling = r->h - (r->roof == 1 ? fmin(0.9, 0.15 * r->h) : 0.3);
}

/* ---- >>on the floor --------------------------------------------------------------------------------------------- */

static void left_behind(kit_build *b, int way)
{
    static const kit_moulding bucket[] = { { 0, 0.002, 0.11, 0.002, 0 },
                                           { 0.11, 0.002, 0.15, 0.28, 0 } }, /* one layer */
        cone[] = { { 0.13, 0.03, 0.03, 0.5, 0 }, { 0.03, 0.5, 0, 0.5, 0 } };
    const double half[3] = { kit_between(b, 0.15, 0.3), kit_between(b, 0.06, 0.12), kit_between(b, 0.1, 0.2) };
    switch (way) {
    case 0:
        plant_stuff(b, KIT_PLASTIC);
        kit_turned(b, bucket, 2, 24);
        plant_hoop(b, KIT_AT(0, 0.28, 0), 0, 0, 0.15, 0.006, 24);
        break;
    case 1:
        kit_colour(b, 0.72, 0.25, 0.05);
        kit_box(b, -0.18, 0.002, -0.18, 0.18, 0.03, 0.18);
        kit_turned(b, cone, 2, 20);
        break;
    case 2:
        plant_stuff(b, KIT_RUBBER);
        for (int k = 0; k < 5; k++)
            plant_hoop(b, KIT_AT(0.01 * k, 0.02 + 0.036 * k, 0.012 * (k & 1)), 0, 0, 0.25, 0.019, 28);
        break;
    case 3:
        plant_stuff(b, KIT_GOODS);
        kit_place_at(b, 0, half[1] + 0.002, 0, 0);
        kit_cushion(b, half, 0.5, 12); /* a sack */
        break;
    case 4:
        for (int k = 0; k < 6; k++) { /* lengths of pipe, open */
            const kit_moulding pipe[] = { { 0.04, 0, 0.04, 1.2 + 0.1 * k, 0 } };
            plant_stuff(b, KIT_STEEL);
            kit_place_tilted(b, 0.083 * (k % 3) + (k > 2 ? 0.04 : 0), k > 2 ? 0.114 : 0.042, 0, 0, 90);
            kit_turned(b, pipe, 1, 16);
        }
        break;
    default: plant_stuff(b, KIT_GOODS); kit_bevelled(b, -half[0], 0.002, -half[2], half[0], 3 * half[1], half[2], 0.01);
    }
}

/* whether something tall enough to be a sight of its own stands there */
static int taken(const kit_plot *p, int sights, double x, double z)
{
    for (int k = 0; k < sights; k++) {
        const kit_sight *s = &p->sight[k];
        if (s->reach > 0.55 && s->at[1] < 2 && hypot(x - s->at[0], z - s->at[2]) < 0.8 * s->reach + 0.25) return 1;
    }
    return 0;
}

void plant_floor_clutter(kit_plot *p, int count)
{
    kit_build *b = &p->b;
    const double *s = p->stand;
    const int sights = p->sights;
    for (int k = 0; k < count; k++) {
        double x = kit_between(b, s[0], s[2]), z = kit_between(b, s[1], s[3]);
        for (int i = 0; i < 8 && taken(p, sights, x, z); i++) {
            x = kit_between(b, s[0], s[2]);
            z = kit_between(b, s[1], s[3]);
        }
        const int way = kit_choose(b, 6), more = 1 + kit_choose(b, 2);
        kit_begin_object(b, "left behind", -1);
        for (int i = 0; i < more; i++) {
            const kit_frame before = kit_enter(b, x + 0.45 * i, 0, z + 0.3 * i, kit_between(b, 0, 360), 1);
            left_behind(b, i ? kit_choose(b, 6) : way);
            kit_leave(b, before);
        }
        if (k % 9 == 0) kit_add_sight(p, x + 0.2, 0.3, z + 0.15, 0.9);
    }
    kit_begin_object(b, "cables", -1);
    for (int k = 0; k < count / 2; k++) { /* lying about */
        double at[24][3];
        const double x = kit_between(b, s[0], 0.5 * s[2]), z = kit_between(b, s[1], s[3]),
                     radius = kit_between(b, 0.006, 0.02);
        for (int i = 0; i < 24; i++) {
            at[i][0] = x + 0.13 * i + 0.15 * sin(0.9 * i + k);
            at[i][1] = radius + 0.002;
            at[i][2] = z + 0.5 * kit_noise(b->random, 0.25 * i, 0.5, 0.5);
            if (at[i][2] < s[1] || at[i][2] > s[3]) at[i][2] = z;
        }
        plant_stuff(b, KIT_RUBBER);
        kit_tube(b, (const double(*)[3])at, 24, radius, 8);
    }
}
