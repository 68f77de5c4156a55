/* uses.c - bays of walls, and what a hall by seed is furnished with for its use. Declared in halls.h. */
#include "kit/scene/halls/halls.h"
#include <math.h>

/* ---- >>bays of walls --------------------------------------------------------------------------------------------- */

static void opening(hall *h, hall_panel *p, int kind)
{
    const double most = 0.5 * p->width - 0.45;
    p->half = fmin(most, kind == HALL_NICHE ? 0.75 : kind == HALL_DOOR ? 1.1 : kit_between(h->b, 0.5, 1.2));
    p->rise = p->half * (h->pointed ? 1.6 : 1);
    p->sill = kind == HALL_DOOR ? 0 : kind == HALL_NICHE ? 0.6 : fmin(1.2, 0.25 * p->height);
    p->spring = fmax(p->sill + 0.2, fmin(p->height - p->rise - 0.5, kind == HALL_WINDOW ? 0.68 * p->height : 2.3));
    if (p->spring + p->rise > p->height - 0.1) p->half = 0;
}

static void in_opening(hall *h, const hall_panel *p, int kind)
{
    kit_build *b = h->b;
    if (kind == HALL_WINDOW) hall_glaze(h, p, 2 + (int)(p->half * 3), 2 + (int)(p->spring - p->sill));
    if (kind == HALL_NICHE) {
        const kit_frame f = kit_enter(b, 0, p->sill + KIT_GAP, 0, 0, 1);
        hall_paint(h, HALL_WALL);
        const double r = p->half, t = p->height - p->sill - 0.05;
        for (int k = 0; k < 10; k++) { /* a hollow half round */
            const double a = KIT_PI * k / 10, e = KIT_PI * (k + 1) / 10;
            const double q[4][3] = { { -r * cos(a), 0, -0.19 - 0.55 * r * sin(a) },
                                     { -r * cos(e), 0, -0.19 - 0.55 * r * sin(e) },
                                     { -r * cos(e), t, -0.19 - 0.55 * r * sin(e) },
                                     { -r * cos(a), t, -0.19 - 0.55 * r * sin(a) } };
            kit_quad(b, q);
        }
        kit_box(b, -r, -0.1, -0.2 - 0.6 * r, r, -KIT_GAP, -0.2);
        kit_leave(b, f);
        const kit_frame g = kit_enter(b, 0, p->sill, -0.2, 0, 1);
        if (kit_odds(b, 0.7)) hall_statue(h, fmin(1.9, (p->spring - p->sill) * 1.15));
        else hall_vase(h, fmin(1.2, p->spring - p->sill));
        kit_leave(b, g);
        if (kit_odds(b, 0.6)) hall_sight(h, 0, 1.4, 0, 1.2);
    }
    if (kind == HALL_DOOR) {
        hall_paint(h, HALL_WOOD);
        kit_box(b, -p->half, 0, -0.2, p->half, p->spring + p->rise, -0.12);
        for (int k = 0; k < 8; k++) {
            const double x = (k & 1 ? 0.08 : 0.08 - p->half), y = 0.2 + (p->spring - 0.3) * (k / 2) / 4;
            kit_bevelled(b, x, y, -0.13, x + p->half - 0.16, y + 0.8 * p->spring / 4, -0.08, 0.02);
        }
        if (kit_odds(b, 0.3)) hall_sight(h, 0, 1.3, 0, 1.4);
    }
}

void hall_bay(hall *h, int kind, double width, double height)
{
    kit_build *b = h->b;
    hall_panel p = { width, height, 0.4, 0, 0, 0, 0, h->pointed, 16, 0 };
    if (kind == HALL_WINDOW || kind == HALL_NICHE || kind == HALL_DOOR) opening(h, &p, kind);
    hall_paint(h, HALL_WALL);
    hall_wall(h, &p);
    if (p.half > 0) {
        hall_paint(h, HALL_TRIM);
        if (h->ribs || kind == HALL_DOOR) hall_archivolt(h, &p, 0.16, 0.06);
        in_opening(h, &p, kind);
        return;
    }
    const double w = fmin(0.6 * width, 2.4), tall = fmin(0.45 * height, 2.2);
    const kit_frame f = kit_enter(b, 0, kind == HALL_BOOKS ? 0 : fmin(1.3, 0.3 * height), 0.2, 0, 1);
    if (kind == HALL_PICTURE) hall_picture(h, w * kit_between(b, 0.5, 1), tall * kit_between(b, 0.5, 1));
    if (kind == HALL_RELIEF) hall_relief(h, w, tall);
    if (kind == HALL_BOOKS) hall_bookcase(h, width - 0.5, fmin(0.8 * height, 3));
    if (kind != HALL_BLANK && kit_odds(b, 0.3)) hall_sight(h, 0, 1.2, 0, 1.5);
    kit_leave(b, f);
}

/* along x from 0, pilasters between, skirting and cornice */
void hall_bays(hall *h, int main, int other, int count, double length, double height)
{
    kit_build *b = h->b;
    const double bay = length / count, r = fmin(0.35, 0.05 * height + 0.1);
    const int pilasters = kit_odds(b, 0.7), special = kit_choose(b, count);
    for (int i = 0; i < count; i++) {
        const kit_frame f = kit_enter(b, bay * (i + 0.5), 0, -0.2, 0, 1);
        hall_bay(h,
                 i == special && other == HALL_DOOR ? HALL_DOOR
                 : i & 1 && other != HALL_DOOR      ? other
                                                    : main,
                 bay, height);
        kit_leave(b, f);
    }
    hall_paint(h, HALL_TRIM);
    for (int i = 0; i <= count && pilasters; i++) {
        const double x = bay * i;
        kit_box(b, x - r, 0, 0, x + r, 0.4, 0.2);
        kit_bevelled(b, x - 0.8 * r, 0.4, -0.05, x + 0.8 * r, height - 0.5, 0.14, 0.02);
        kit_bevelled(b, x - r, height - 0.5, -0.05, x + r, height - 0.25, 0.22, 0.03);
    }
    kit_bevelled(b, 0, height - 0.25, -0.05, length, height - 0.02, 0.3, 0.06);
    kit_bevelled(b, 0, height - 0.34, -0.05, length, height - 0.25, 0.18, 0.03);
}

void hall_four_walls(hall *h, const double r[4], double height, double bay, int main, int other)
{
    kit_build *b = h->b;
    const double at[4][2] = { { r[0], r[1] }, { r[0], r[3] }, { r[2], r[3] }, { r[2], r[1] } };
    for (int k = 0; k < 4; k++) {
        const double length = k & 1 ? r[3] - r[1] : r[2] - r[0];
        kit_begin_object(b, "wall", 0);
        const kit_frame f = kit_enter(b, at[k][0], 0, at[k][1], 90 * k, 1);
        hall_bays(h, main, k == 1 ? HALL_DOOR : other, (int)fmax(1, length / bay + 0.5), length, height);
        kit_leave(b, f);
    }
}

/* ---- >>furnishings ----------------------------------------------------------------------------------------------- */

/* a thing on the floor, drawn by its kind */
static void stand(hall *h, int kind, double x, double z, double turn)
{
    static const char *const names[] = { "pews", "plinth", "stall", "bench", "table", "rack", "table", "pot" };
    kit_build *b = h->b;
    kit_begin_object(b, names[kind], -1);
    const kit_frame f = kit_enter(b, x, 0, z, turn, 1);
    if (kind == HALL_MUSEUM) hall_plinth(h, kit_between(b, 0.4, 1), kit_between(b, 0.4, 1.2));
    if (kind == HALL_MARKET) {
        hall_stall(h);
        hall_sight(h, 0, 1, 0.2, 1.6);
    }
    if (kind == HALL_STATION || kind == HALL_BARE) {
        const int what = kit_choose(b, 4);
        if (what == 0) hall_bench(h, 2.2, 1);
        if (what == 1) hall_plant(h, kit_between(b, 0.9, 2));
        if (what == 2) hall_crates(h);
        if (what == 3) hall_candles(h, kit_between(b, 1, 1.7));
        hall_sight(h, 0, 0.7, 0, 1);
    }
    if (kind == HALL_READING || kind == HALL_BANQUET) {
        hall_table(h, 2.6, 1.1);
        for (int k = 0; k < 6; k++) {
            const kit_frame g = kit_enter(b, 0.8 * (k / 2 - 1) + kit_between(b, -0.1, 0.1), 0,
                                          (k & 1 ? 1 : -1) * kit_between(b, 0.6, 0.9),
                                          (k & 1 ? 180 : 0) + kit_between(b, -15, 15), 1);
            if (kit_odds(b, 0.85)) hall_chair(h);
            kit_leave(b, g);
        }
        for (int k = 0; k < 3; k++) {
            const kit_frame g = kit_enter(b, 0.8 * (k - 1), 0.76 + KIT_GAP, kit_between(b, -0.3, 0.3),
                                          kit_between(b, 0, 360), 1);
            hall_paint(h, HALL_SECOND);
            if (kit_odds(b, 0.5)) kit_bevelled(b, -0.12, 0, -0.09, 0.12, 0.05, 0.09, 0.005);
            else if (kind == HALL_BANQUET) hall_candles(h, 0.5);
            else hall_vase(h, kit_between(b, 0.15, 0.4));
            kit_leave(b, g);
        }
        hall_sight(h, 0, 0.8, 0, 1.4);
    }
    kit_leave(b, f);
}

static void pews(hall *h, const double r[4])
{
    kit_build *b = h->b;
    const double mid = 0.5 * (r[1] + r[3]), wide = 0.5 * (r[3] - r[1]) - 1.4;
    int n = 0;
    for (double x = r[0] + 2.5; x < r[2] - 4; x += 1.05)
        for (int side = -1; side < 2; side += 2, n++) {
            if (n % 6 == 0) kit_begin_object(b, "pews", -1);
            const kit_frame f = kit_enter(b, x, 0, mid + side * (0.75 + 0.5 * wide), 90 + kit_between(b, -1, 1), 1);
            hall_bench(h, wide, 1);
            if (n % 5 == 0) hall_sight(h, 0, 0.6, 0, 1.2);
            kit_leave(b, f);
        }
}

static void racks(hall *h, const double r[4])
{
    kit_build *b = h->b;
    const double aisle = kit_between(b, 2.4, 3.6), tall = kit_between(b, 3, fmax(3.2, fmin(6, h->top - 1)));
    for (double z = r[1] + 0.3; z < r[3] - 1.4; z += aisle + 2.4) {
        for (int k = 0; k < 2 && z + 1.2 * k < r[3] - 1.2; k++) {
            kit_begin_object(b, "rack", -1);
            const kit_frame f = kit_enter(b, r[0] + 2, 0, z + 1.2 * k, 0, 1);
            hall_rack(h, r[2] - r[0] - 4, tall);
            hall_sight(h, 0.25 * (r[2] - r[0]), 1.2, 0.5, 1.5);
            hall_sight(h, 0.6 * (r[2] - r[0]), 2.2, 0.5, 2.4);
            kit_leave(b, f);
        }
        for (int k = 0; k < 3; k++)
            stand(h, HALL_BARE, kit_between(b, r[0] + 1, r[2] - 1), z + 2.4 + 0.5 * aisle, kit_between(b, 0, 360));
    }
}

void hall_furnish(hall *h, int kind, const double r[4])
{
    kit_build *b = h->b;
    static const double pitch_x[] = { 1, 3.5, 4.2, 4.5, 4, 1, 3.6, 5 }, pitch_z[] = { 1, 3.2, 4, 4.5, 3.4, 1, 3, 4.5 };
    if (kind == HALL_PEWS) {
        pews(h, r);
        return;
    }
    if (kind == HALL_STORE) {
        racks(h, r);
        return;
    }
    const int nx = (int)fmin(7, fmax(1, (r[2] - r[0] - 1) / pitch_x[kind])),
              nz = (int)fmin(5, fmax(1, (r[3] - r[1] - 1) / pitch_z[kind]));
    const double dx = (r[2] - r[0]) / nx, dz = (r[3] - r[1]) / nz,
                 loose = kind == HALL_READING || kind == HALL_BANQUET ? 0.02 : 0.12;
    for (int i = 0; i < nx * nz; i++) {
        const double x = r[0] + dx * (i % nx + 0.5 + kit_between(b, -loose, loose)),
                     z = r[1] + dz * (i / nx + 0.5 + kit_between(b, -loose, loose));
        if (kit_odds(b, 0.12)) continue;
        stand(h, kind, x, z,
              kind == HALL_MARKET ? 180 * (i / nx & 1) + kit_between(b, -6, 6)
              : loose > 0.1       ? 90 * kit_choose(b, 4) + kit_between(b, -9, 9)
                                  : 0);
    }
    if (kind != HALL_MUSEUM || !kit_odds(b, 0.7)) return;
    kit_begin_object(b, "barrier", -1);
    const kit_frame f = kit_enter(b, r[0] + 1.5, 0, r[1] + 0.9, 0, 1);
    hall_barrier(h, r[2] - r[0] - 3);
    kit_leave(b, f);
}
