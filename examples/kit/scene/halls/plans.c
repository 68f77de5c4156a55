/* plans.c - halls by seed whose plan is their own: theatre, stairs, rotunda. Declared in halls.h. */
#include "kit/scene/halls/halls.h"
#include <math.h>
#include <string.h>

/* ---- >>theatre: rows climb along z, the stage at z < 0 ---------------------------------------------------------- */

typedef struct rows {
    double width, pitch, step, first;
    int count;
} rows;

static double rows_height(const kit_plot *p, double x, double z)
{
    (void)x;
    return z < p->of[2] ? 0 : fmin(p->of[3], floor((z - p->of[2]) / p->of[0]) + 1) * p->of[1];
}

/* looks along -z */
static void seat(hall *h, int folded)
{
    kit_build *b = h->b;
    hall_paint(h, HALL_WOOD);
    for (int side = -1; side < 2; side += 2)
        kit_bevelled(b, 0.27 * side - 0.025, 0, -0.2, 0.27 * side + 0.025, 0.62, 0.24, 0.01);
    hall_paint(h, HALL_CLOTH);
    kit_place_tilted(b, 0, 0.42, 0.2, 0, 10);
    kit_bevelled(b, -0.24, -0.1, -0.03, 0.24, 0.55, 0.05, 0.025);
    kit_place_tilted(b, 0, 0.42, 0.16, 0, folded ? 80 : 4);
    kit_bevelled(b, -0.235, -0.05, -0.38, 0.235, 0.05, 0, 0.03);
    kit_place_at(b, 0, 0, 0, 0);
}

static void seating(hall *h, const rows *s)
{
    kit_build *b = h->b;
    const int seats = (int)(s->width / 0.6), aisle = seats / 2;
    for (int row = 0; row < s->count; row++) {
        const double y = s->step * (row + 1), z = s->first + s->pitch * row;
        kit_begin_object(b, "tier", 0);
        hall_paint(h, HALL_FLOOR);
        kit_box(b, -0.5 * s->width - 1.2, -0.02, z, 0.5 * s->width + 1.2, y, z + s->pitch);
        kit_begin_object(b, "seats", -1);
        for (int k = 0; k < seats; k++) {
            if (k == aisle || kit_odds(b, 0.01)) continue;
            const double x = 0.6 * (k + 0.5 - 0.5 * seats);
            const kit_frame f = kit_enter(b, x, y, z + 0.5 * s->pitch, 0, 1);
            seat(h, kit_odds(b, 0.7));
            if (k % 7 == 3 && row % 2) hall_sight(h, 0, 0.5, 0, 1.3);
            kit_leave(b, f);
        }
    }
}

static void stage(hall *h, double half, double high)
{
    kit_build *b = h->b;
    const hall_panel p = { 2 * half, high, 0.6, 0.66 * half, 0, 0.42 * high, 0.2 * high, 0, 28, 0 };
    kit_begin_object(b, "proscenium", 0);
    hall_paint(h, HALL_WALL);
    hall_wall(h, &p);
    hall_paint(h, HALL_TRIM);
    hall_archivolt(h, &p, 0.45, 0.2);
    kit_begin_object(b, "stage", 0);
    hall_paint(h, HALL_WOOD);
    kit_box(b, -0.66 * half, 0, -5, 0.66 * half, 0.95, 1.2);
    kit_begin_object(b, "curtain", -1);
    for (int side = -1; side < 2; side += 2) {
        const kit_frame f = kit_enter(b, 0.42 * half * side, 0.66 * high, -0.6, 0, 1);
        hall_banner(h, 0.5 * half, 0.66 * high - 1);
        hall_sight(h, 0, -2, 0, 2.5);
        kit_leave(b, f);
    }
    for (int k = 0; k < 6; k++) {
        static const char *const names[] = { "table", "chair", "vase", "statue", "chair", "crate" };
        kit_begin_object(b, names[k], -1);
        const kit_frame f = kit_enter(b, 0.18 * half * (k - 2.5), 0.95 + KIT_GAP, kit_between(b, -3, 0.4),
                                      kit_between(b, 0, 360), 1);
        if (k == 0) hall_table(h, 1.6, 0.8);
        else if (k == 2) hall_vase(h, 1);
        else if (k == 3) hall_statue(h, 1.8);
        else if (k == 5) hall_crates(h);
        else hall_chair(h);
        hall_sight(h, 0, 0.6, 0, 1.2);
        kit_leave(b, f);
    }
}

static void balcony(hall *h, double length, double deep)
{
    kit_build *b = h->b;
    kit_begin_object(b, "balcony", -1);
    hall_paint(h, HALL_TRIM);
    kit_bevelled(b, 0, -0.3, -0.3, length, 0, deep, 0.08);
    for (double x = 0.4; x < length - 0.3; x += 0.9) kit_bevelled(b, x, -0.6, -0.3, x + 0.2, -0.29, 0.7 * deep, 0.05);
    const kit_frame f = kit_enter(b, 0, 0, deep - 0.15, 0, 1);
    hall_rail(h, h->rail, length, 0);
    kit_leave(b, f);
    for (double x = 0.6; x < length - 0.4; x += 0.75) {
        const kit_frame g = kit_enter(b, x, KIT_GAP, 0.5 * deep - 0.2, 180, 1);
        seat(h, 0);
        kit_leave(b, g);
    }
    hall_sight(h, 0.5 * length, 0.2, deep, 2);
}

void hall_theatre(hall *h)
{
    kit_build *b = h->b;
    const int count = 7 + kit_choose(b, 6), tiers = kit_choose(b, 3);
    const rows s = { kit_between(b, 9, 16), kit_between(b, 0.9, 1.05), kit_between(b, 0.12, 0.32), 3.5, count };
    const double half = 0.5 * s.width + 1.2, end = s.first + s.pitch * count + 1.5, top = s.step * count,
                 high = top + kit_between(b, 6, 8);
    const double r[4] = { -half, 0, half, end };
    if (h->paint[HALL_CLOTH][0] < 0.3f && kit_odds(b, 0.5))
        memcpy(h->paint[HALL_CLOTH], (const float[3]){ 0.42f, 0.05f, 0.06f }, 3 * sizeof(float));
    kit_begin_object(b, "ground", 0);
    hall_floor(h, (const double[4]){ -half - 1.2, -6, half + 1.2, end + 1.2 });
    hall_shell(h, (const double[4]){ -half - 1.2, -6, half + 1.2, end + 1.2 }, -0.05, high + half + 3, 1);
    hall_paint(h, HALL_FLOOR);
    kit_box(b, -half, -0.02, end - 1.5, half, top, end);
    hall_overview(h, r, high);
    hall_four_walls(h, r, high, 4, kit_odds(b, 0.5) ? HALL_BLANK : HALL_NICHE, HALL_RELIEF);
    const kit_frame f = kit_enter(b, 0, 0, 0.35, 0, 1);
    stage(h, half, high);
    kit_leave(b, f);
    seating(h, &s);
    for (int k = 0; k < tiers; k++)
        for (int side = 0; side < 3; side++) {
            const double y = top + 2.4 + 2.6 * k, length = side == 1 ? 2 * half : end - 3;
            if (y > high - 2.2) continue;
            const kit_frame g = kit_enter(b, side < 2 ? (side ? half : -half) : half, y,
                                          side ? side == 1 ? end : 3 : end, side ? side == 1 ? 180 : 270 : 90, 1);
            balcony(h, length, side == 1 ? 2.4 : 1.3);
            kit_leave(b, g);
        }
    hall_roof(h, kit_odds(b, 0.5) ? HALL_COFFERS : HALL_BEAMS, r, high, 4);
    kit_begin_object(b, "chandelier", -1);
    const kit_frame g = kit_enter(b, 0, high - 2.6, 0.5 * end, 0, 1);
    hall_chandelier(h, 1.5, 1.1);
    hall_sight(h, 0, 0, 0, 2);
    kit_leave(b, g);
    const double of[] = { s.pitch, s.step, s.first, count };
    memcpy(h->p->of, of, sizeof of);
    h->p->ground = rows_height;
    hall_stand(h, 0.5 - half, 1, half - 0.5, end - 0.4, high);
}

/* ---- >>stairs --------------------------------------------------------------------------------------------------- */

void hall_stair_hall(hall *h)
{
    kit_build *b = h->b;
    const int steps = 18 + kit_choose(b, 10);
    const double rise = 0.165, run = kit_between(b, 0.3, 0.36), wide = kit_between(b, 2.4, 4.4), up = rise * steps,
                 flight = run * steps;
    const double z = kit_between(b, 5.5, 8), x = flight + 5, far = x + kit_between(b, 3, 5),
                 high = up + kit_between(b, 4, 5.5), walk = 2.2;
    const double r[4] = { 0, -z, far, z };
    kit_begin_object(b, "ground", 0);
    hall_floor(h, (const double[4]){ -1.2, -z - 1.2, far + 1.2, z + 1.2 });
    hall_shell(h, (const double[4]){ -1.2, -z - 1.2, far + 1.2, z + 1.2 }, -0.05, high + z + 1, 1);
    hall_overview(h, r, high);
    hall_four_walls(h, r, high, 3.8, 1 + kit_choose(b, HALL_BAYS - 2), HALL_PICTURE);
    static const int roofs[] = { HALL_COFFERS, HALL_SKYLIGHT, HALL_BARREL };
    hall_roof(h, roofs[kit_choose(b, 3)], r, high, 5);
    kit_begin_object(b, "stairs", 0);
    const kit_frame f = kit_enter(b, x - flight, 0, 0, 0, 1);
    hall_stairs(h, wide, steps, rise, run);
    hall_sight(h, 0.3 * flight, 0.3 * up, 0, 1.8);
    hall_sight(h, 0.8 * flight, 0.8 * up, 0, 2.2);
    for (int side = -1; side < 2; side += 2) {
        kit_begin_object(b, "rail", -1);
        const kit_frame g = kit_enter(b, 0.1, rise + 0.05, side * (0.5 * wide - 0.15), 0, 1);
        hall_rail(h, h->rail, flight - 0.2, up - rise);
        hall_sight(h, 0.5 * flight, 0.5 * up + 0.5, 0, 1.3);
        kit_leave(b, g);
        kit_begin_object(b, "newel", -1);
        const kit_frame n = kit_enter(b, -0.5, 0, side * (0.5 * wide + 0.2), 0, 1);
        hall_plinth(h, 0.55, 1.3);
        kit_leave(b, n);
    }
    kit_leave(b, f);
    kit_begin_object(b, "gallery", 0);
    hall_paint(h, HALL_FLOOR);
    kit_box(b, x, up - 0.35, -z, far, up, z);
    for (int side = 0; side < 2; side++) kit_box(b, 0, up - 0.35, side ? z - walk : -z, x, up, side ? z : walk - z);
    for (int side = -1; side < 2; side += 2) {
        kit_begin_object(b, "rail", -1);
        const kit_frame g = kit_enter(b, 0, up, side * (z - walk + 0.12), 0, 1);
        hall_rail(h, h->rail, x, 0);
        hall_sight(h, 0.5 * x, 0.6, 0, 1.6);
        kit_leave(b, g);
        const kit_frame e = kit_enter(b, x + 0.12, up, side > 0 ? z - walk : -0.5 * wide, 90, 1);
        hall_rail(h, h->rail, z - walk - 0.5 * wide, 0);
        kit_leave(b, e);
        for (int k = 0; k < 5; k++) {
            kit_begin_object(b, "column", -1);
            const double at = 0.6 + (x - 0.6) * k / 4;
            const kit_frame c = kit_enter(b, at, 0, side * (z - walk + 0.3), 0, 1);
            hall_paint(h, HALL_STONE);
            hall_column(h, h->column, 0.26, up - 0.34);
            if (k % 2) hall_sight(h, 0, 0.6, 0, 1.4);
            kit_leave(b, c);
            const kit_frame d = kit_enter(b, at, up, side * (z - walk - 0.4 + 0.3 + 0.75), 0, 1);
            hall_column(h, h->column, 0.2, high - up);
            kit_leave(b, d);
        }
    }
    h->top = high;
    hall_furnish(h, HALL_BARE, (const double[4]){ x + 0.5, -z + 1, far - 0.5, z - 1 });
    hall_furnish(h, HALL_MUSEUM, (const double[4]){ 0.8, -z + 0.8, x, -0.5 * wide - 0.7 });
    hall_furnish(h, HALL_BARE, (const double[4]){ 0.8, 0.5 * wide + 0.7, x, z - 0.8 });
    kit_begin_object(b, "chandelier", -1);
    const kit_frame g = kit_enter(b, 0.4 * x, high - 2, 0, 0, 1);
    hall_chandelier(h, 1.1, 0.9);
    hall_sight(h, 0, 0, 0, 1.6);
    kit_leave(b, g);
    hall_stand(h, 0.5, 0.5 - z, far - 0.5, z - 0.5, high);
}

/* ---- >>rotunda -------------------------------------------------------------------------------------------------- */

/* radius, panels round, panels up; looks inwards, fields pressed in */
static void dome_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = 2 * KIT_PI * fmod(u, 1), t = 0.44 * KIT_PI * v;
    const double field = pow(
        fmax(0, sin(s[1] * 0.5 * a) * sin(s[1] * 0.5 * a) * sin(KIT_PI * s[2] * v) * sin(KIT_PI * s[2] * v)), 0.35);
    const double r = s[0] + s[3] * field;
    out->n[0] = -cos(t) * cos(a);
    out->n[1] = -sin(t);
    out->n[2] = -cos(t) * sin(a);
    for (int i = 0; i < 3; i++) out->p[i] = -r * out->n[i];
}

void hall_rotunda(hall *h)
{
    kit_build *b = h->b;
    const int n = 8 + 2 * kit_choose(b, 4);
    const double radius = kit_between(b, 5, 8.5), tall = kit_between(b, 3, 4.8), side = 2 * radius * tan(KIT_PI / n),
                 out = radius + kit_between(b, 2.2, 3.4);
    const double span = 2 * out * tan(KIT_PI / n), half = 0.5 * side - 0.45,
                 high = tall + half * (h->pointed ? 1.5 : 1) + 1, corner = radius / cos(KIT_PI / n);
    const double dome[] = { corner, n, 4, h->ribs ? 0.3 : 0.02 }, all[4] = { -out - 2, -out - 2, out + 2, out + 2 };
    kit_begin_object(b, "ground", 0);
    hall_floor(h, all);
    hall_shell(h, all, -0.05, high + radius + 4, 1);
    for (int k = 0; k < n; k++) {
        const double turn = 360.0 * k / n, a = turn * KIT_PI / 180, c = a + KIT_PI / n;
        const hall_panel p = { side, high - tall, 0.6, half, 0, 0, half * (h->pointed ? 1.5 : 1), h->pointed, 18, 1 };
        kit_begin_object(b, "arch", 0);
        kit_frame f = kit_enter(b, -radius * sin(a), tall, -radius * cos(a), turn, 1);
        hall_paint(h, HALL_WALL);
        hall_wall(h, &p);
        hall_paint(h, HALL_TRIM);
        hall_archivolt(h, &p, 0.22, 0.06);
        kit_bevelled(b, -0.5 * side, high - tall - 0.35, 0.2, 0.5 * side, high - tall, 0.6, 0.08);
        kit_leave(b, f);
        f = kit_enter(b, -out * sin(a), 0, -out * cos(a), turn, 1);
        kit_begin_object(b, "wall", 0);
        hall_bay(h, k & 1 ? HALL_NICHE : k ? HALL_WINDOW : HALL_DOOR, span, high);
        hall_paint(h, HALL_VAULT);
        const double over[4][3] = { { -0.5 * span, high, 0 },
                                    { 0.5 * span, high, 0 },
                                    { 0.5 * side, high, out - radius },
                                    { -0.5 * side, high, out - radius } };
        kit_quad(b, over);
        kit_leave(b, f);
        kit_begin_object(b, "column", -1);
        f = kit_enter(b, -corner * sin(c), 0, -corner * cos(c), turn + 180.0 / n, 1);
        hall_paint(h, HALL_STONE);
        hall_column(h, h->column, 0.34, tall);
        hall_sight(h, 0, k & 1 ? 0.5 : tall, 0, 1.3);
        kit_leave(b, f);
    }
    hall_overview(h, (const double[4]){ -radius, -radius, radius, radius }, high);
    kit_begin_object(b, "dome", 0);
    hall_paint(h, HALL_VAULT);
    kit_place_at(b, 0, high - 0.02, 0, 90);
    kit_patch(b, 12 * n, 48, dome_surface, dome);
    kit_place_at(b, 0, 0, 0, 0);
    hall_sight(h, 0, high + 0.4 * radius, 0, 0.7 * radius);
    h->top = high;
    kit_begin_object(b, "middle", -1);
    const kit_frame f = kit_enter(b, 0, 0, 0, 0, 1);
    hall_plinth(h, 1.6, 1);
    kit_leave(b, f);
    hall_furnish(h, kit_odds(b, 0.5) ? HALL_MUSEUM : HALL_BARE,
                 (const double[4]){ -0.6 * radius, -0.6 * radius, 0.6 * radius, 0.6 * radius });
    kit_begin_object(b, "chandelier", -1);
    const kit_frame g = kit_enter(b, 0, high, 0, 0, 1);
    if (kit_odds(b, 0.6)) hall_chandelier(h, 1.2, 0.9 * corner - 1);
    kit_leave(b, g);
    hall_stand(h, -0.65 * out, -0.65 * out, 0.65 * out, 0.65 * out, high + 0.3 * radius);
}
