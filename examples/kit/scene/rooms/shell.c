/* shell.c - a room's floor, walls, ceiling, slopes, and what is seen through its windows. Declared in rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>
#include <string.h>

enum { OPENINGS = 4 };

/* A wall: its length, height, thickness (0: a single layer), openings from left to right. */
typedef struct wall {
    double length, high, thick;
    int openings;
    kit_opening opening[OPENINGS];
} wall;

/* ---- >>walls ----------------------------------------------------------------------------------------------------- */

void room_wall_point(const kit_room *r, int k, double along, double before, double out[2])
{
    const double x = 0.5 * r->size[0], z = 0.5 * r->size[2];
    out[0] = k == 0 ? along - x : k == 1 ? before - x : k == 2 ? x - along : x - before;
    out[1] = k == 0 ? before - z : k == 1 ? z - along : k == 2 ? z - before : along - z;
}

static kit_frame enter_wall(kit_room *r, int k)
{
    double at[2];
    room_wall_point(r, k, 0, 0, at);
    return kit_enter(r->b, at[0], 0, at[1], 90 * k, 1);
}

/* a rectangle of both faces, or of one */
static void both_faces(kit_build *b, double x0, double y0, double x1, double y1, double thick)
{
    const double in[4][3] = { { x0, y0, 0 }, { x1, y0, 0 }, { x1, y1, 0 }, { x0, y1, 0 } },
                 out[4][3] = { { x1, y0, -thick }, { x0, y0, -thick }, { x0, y1, -thick }, { x1, y1, -thick } };
    if (x1 - x0 < 1e-6 || y1 - y0 < 1e-6) return;
    kit_quad(b, in);
    if (thick > 0) kit_quad(b, out);
}

/* the sides of an opening through the wall */
static void reveal(kit_build *b, const kit_opening *o, double t)
{
    const double side[4][4][3] = {
        { { o->x0, o->y0, -t }, { o->x0, o->y1, -t }, { o->x0, o->y1, 0 }, { o->x0, o->y0, 0 } },
        { { o->x1, o->y0, 0 }, { o->x1, o->y1, 0 }, { o->x1, o->y1, -t }, { o->x1, o->y0, -t } },
        { { o->x0, o->y0, 0 }, { o->x1, o->y0, 0 }, { o->x1, o->y0, -t }, { o->x0, o->y0, -t } },
        { { o->x0, o->y1, -t }, { o->x1, o->y1, -t }, { o->x1, o->y1, 0 }, { o->x0, o->y1, 0 } }
    };
    for (int i = 0; i < 4; i++)
        if (!(i == 2 && o->door)) kit_quad(b, side[i]);
}

static void wall_faces(kit_build *b, const wall *w)
{
    double x = 0;
    for (int i = 0; i < w->openings; i++) {
        const kit_opening *o = &w->opening[i];
        both_faces(b, x, 0, o->x0, w->high, w->thick);
        both_faces(b, o->x0, 0, o->x1, o->y0, w->thick);
        both_faces(b, o->x0, o->y1, o->x1, w->high, w->thick);
        if (w->thick > 0) reveal(b, o, w->thick);
        x = o->x1;
    }
    both_faces(b, x, 0, w->length, w->high, w->thick);
}

static int meets(const wall *w, double x0, double y0, double x1, double y1)
{
    for (int i = 0; i < w->openings; i++) {
        const kit_opening *o = &w->opening[i];
        if (x0 < o->x1 + 0.08 && x1 > o->x0 - 0.08 && y0 < o->y1 + 0.08 && y1 > o->y0 - 0.04) return 1;
    }
    return 0;
}

static void claim_on(kit_room *r, int k, double x0, double y0, double x1, double y1, double deep)
{
    double at[2];
    const double low[3] = { x0, y0, 0 }, high[3] = { x1, y1, deep };
    room_wall_point(r, k, 0, 0, at);
    const kit_block c = room_quarter_block(at[0], at[1], k, low, high);
    room_claim_space(r, &c, 1);
}

/* ---- >>what clads walls ------------------------------------------------------------------------------------------ */

static void skirting(kit_room *r, const wall *w)
{
    double x = 0.001;
    const double high = kit_between(r->b, 0.06, 0.16);
    for (int i = 0; i <= w->openings; i++) {
        const int last = i == w->openings;
        if (!last && !w->opening[i].door) continue;
        const double end = last ? w->length - 0.001 : w->opening[i].x0 - 0.07;
        if (end > x) kit_box(r->b, x, 0.001, 0, end, high, 0.018);
        if (!last) x = w->opening[i].x1 + 0.07;
    }
}

/* Bricks or tiles up to a height, those cut by openings left out. */
static void tiles(kit_room *r, const wall *w, double wide, double high, double top, double deep, int bond)
{
    kit_build *b = r->b;
    const float *const colour = bond ? NULL : r->trim;
    static const float bricks[][3] = { { 0.46f, 0.22f, 0.16f }, { 0.38f, 0.18f, 0.13f }, { 0.55f, 0.32f, 0.24f } };
    const int rows = (int)(top / high);
    for (int j = 0; j < rows; j++)
        for (double x = bond && j & 1 ? -0.5 * wide : 0; x < w->length; x += wide) {
            const double x0 = fmax(0.001, x), x1 = fmin(w->length - 0.001, x + wide - 0.008), y = j * high;
            if (x1 - x0 < 0.02 || meets(w, x0, y, x1, y + high)) continue;
            if (bond) KIT_TINT(b, bricks, 0.2);
            else room_paint(b, kit_odds(b, 0.04) ? r->accent : colour, 0.06);
            kit_box(b, x0, y + 0.004, -0.01, x1, y + high - 0.004, deep * kit_between(b, 0.6, 1));
        }
}

static void panelling(kit_room *r, const wall *w, double top)
{
    kit_build *b = r->b;
    const int posts = 2 + (int)(w->length / kit_between(b, 0.15, 0.8));
    room_paint(b, r->wood, 0.1);
    for (int i = 0; i < posts; i++) {
        const double x = 0.002 + (w->length - 0.064) * i / (posts - 1);
        if (!meets(w, x, 0.1, x + 0.06, top)) kit_box(b, x, 0.1, 0, x + 0.06, top, 0.014);
    }
    for (double x = 0.001; x < w->length - 0.2; x += 0.2)
        if (!meets(w, x, top, x + 0.2, top + 0.05)) kit_box(b, x, top + 0.001, 0, x + 0.1999, top + 0.05, 0.02);
}

static void cladding(kit_room *r, const wall *w, int style, int k, int attic)
{
    kit_begin_object(r->b, "cladding", 0);
    room_paint(r->b, r->trim, 0.04);
    if (style != 2) skirting(r, w);
    if (style == 1 && !(attic && !(k & 1))) panelling(r, w, fmin(1.1, w->high - 0.1));
    if (style == 2) tiles(r, w, 0.2, 0.2, fmin(w->high, 1.7), 0.006, 0);
    if (style == 3 && k < 2) tiles(r, w, 0.26, 0.085, w->high, 0.014, 1);
    if (style == 4 && !attic) {
        kit_bevelled(r->b, 0, w->high - 0.09, 0.0, w->length, w->high - 0.001, 0.07, 0.02);
        kit_box(r->b, 0, w->high - 0.15, 0, w->length, w->high - 0.092, 0.02);
    }
}

/* ---- >>openings -------------------------------------------------------------------------------------------------- */

/* Windows at even distances, a door at one place. */
static void cut_openings(kit_room *r, wall *w, int windows, int door, int middle)
{
    kit_build *b = r->b;
    const int n = windows + door, at = door ? kit_choose(b, n) : -1;
    const double low = kit_odds(b, 0.2) ? 0.12 : kit_between(b, 0.75, 1.1),
                 high = fmin(w->high - 0.25, kit_between(b, 1.95, 2.4)), share = kit_between(b, 0.45, 0.85);
    for (int i = 0; i < n; i++) {
        const double cell = w->length / n, wide = i == at ? kit_between(b, 0.8, 0.92) : fmin(2.2, cell * share - 0.1),
                     x = cell * (i + 0.5) + kit_between(b, -0.5, 0.5) * (middle ? 0.2 : fmax(0, cell - wide - 0.5));
        if (wide < 0.5 || cell < wide + 0.3 || (i != at && high < low + 0.4)) continue;
        w->opening[w->openings++] = (kit_opening){ x - 0.5 * wide, x + 0.5 * wide, i == at ? 0 : low,
                                                   i == at ? 2.05 : high, i == at };
    }
}

static void fit_openings(kit_room *r, int k, const wall *w)
{
    kit_build *b = r->b;
    for (int i = 0; i < w->openings; i++) {
        const kit_opening *o = &w->opening[i];
        if (o->door) {
            const int inwards = kit_odds(b, 0.5);
            const double wide = o->x1 - o->x0;
            room_corridor(r, o, w->thick);
            room_door(r, o, w->thick, inwards ? -kit_between(b, 15, 115) : kit_between(b, 0, 100));
            claim_on(r, k, o->x0 - (inwards ? 0.35 : 0.1), 0, o->x1 + 0.1, 2.15, inwards ? wide + 0.05 : 0.7);
            continue;
        }
        room_window(r, o, w->thick);
        claim_on(r, k, o->x0 - 0.3, o->y0 - 0.05, o->x1 + 0.3, o->y1 + 0.15, 0.3);
        if (o->y0 < 0.6 || !kit_odds(b, 0.6)) continue;
        room_radiator(r, o->x0 + 0.1, o->x1 - 0.15, fmin(0.75, o->y0 - 0.1));
        claim_on(r, k, o->x0, 0, o->x1, o->y0, 0.2);
    }
}

/* ---- >>floor and ceiling ----------------------------------------------------------------------------------------- */

static void planks(kit_room *r, double wide, double longest)
{
    kit_build *b = r->b;
    const int flush = kit_odds(b, 0.6);
    const double x0 = -0.5 * r->size[0], z0 = -0.5 * r->size[2];
    kit_colour(b, 0.12, 0.09, 0.07);
    if (!flush) kit_level(b, x0, z0, -x0, -z0, -0.012);
    for (double x = x0; x < -x0; x += wide)
        for (double z = z0 - kit_between(b, 0, 0.9) * longest; z < -z0; z += longest) {
            const double left = x + 0.0015, right = fmin(x + wide - 0.0015, -x0), from = fmax(z, z0),
                         to = fmin(z + longest - 0.003, -z0);
            if (right - left < 0.01 || to - from < 0.01) continue;
            room_paint(b, r->wood, 0.22);
            if (flush) kit_level(b, left - 0.0015, from, fmin(x + wide, -x0), fmin(z + longest, -z0), 0);
            else kit_box(b, left, -0.011, from, right, 0, to);
        }
}

static void floor_of(kit_room *r)
{
    kit_build *b = r->b;
    const double x = 0.5 * r->size[0], z = 0.5 * r->size[2];
    static const float stones[][3] = {
        { 0.55f, 0.53f, 0.50f }, { 0.30f, 0.30f, 0.31f }, { 0.66f, 0.60f, 0.52f }, { 0.45f, 0.30f, 0.22f }
    };
    const int style = kit_choose(b, 4);
    kit_begin_object(b, "floor", 0);
    if (style == 0) {
        planks(r, kit_between(b, 0.09, 0.2), kit_between(b, 1.2, 2.4));
        return;
    }
    KIT_TINT(b, stones, 0.15);
    if (style == 1 || r->size[0] * r->size[2] > 45) {
        kit_level(b, -x, -z, x, z, 0);
        return;
    }
    if (style == 2) {
        room_paint(b, r->cloth, 0.1);
        kit_level(b, -x, -z, x, z, 0);
        return;
    }
    const double step = kit_between(b, 0.28, 0.6);
    const float mine[3] = { b->albedo[0], b->albedo[1], b->albedo[2] };
    const int chequered = kit_odds(b, 0.4);
    kit_colour(b, 0.3, 0.29, 0.27);
    kit_level(b, -x, -z, x, z, -0.003);
    for (int i = 0; - x + i * step < x; i++)
        for (int j = 0; - z + j * step < z; j++) {
            room_paint(b, chequered && (i + j) & 1 ? r->trim : mine, 0.07);
            kit_box(b, -x + i * step + 0.002, -0.0029, -z + j * step + 0.002, fmin(x, -x + (i + 1) * step - 0.002), 0,
                    fmin(z, -z + (j + 1) * step - 0.002));
        }
}

/* Slopes over a side wall, with a skylight and rafters; claims what is under them. */
static void slope(kit_room *r, int k, double knee, double run)
{
    kit_build *b = r->b;
    const double rise = r->size[1] - knee, tilt = atan2(run, rise) * 180 / KIT_PI, length = r->size[2],
                 up = hypot(run, rise);
    wall w = { .length = length, .high = up, .thick = kit_odds(b, 0.5) ? 0.2 : 0 };
    for (int i = kit_choose(b, 3); i > 0 && up > 1.4; i--)
        w.opening[w.openings++] = (kit_opening){ length * (w.openings + 0.6) / 3,
                                                 length * (w.openings + 0.6) / 3 + 0.75, 0.25 * up, 0.25 * up + 1, 0 };
    const kit_frame before = enter_wall(r, k);
    room_paint(b, r->trim, 0.05);
    kit_place_tilted(b, 0, knee, 0, 0, tilt);
    wall_faces(b, &w);
    room_paint(b, r->wood, 0.15);
    for (int i = 0; i < w.openings; i++) {
        const kit_opening *o = &w.opening[i];
        kit_box(b, o->x0, o->y0, -0.05, o->x0 + 0.05, o->y1, 0.02);
        kit_box(b, o->x1 - 0.05, o->y0, -0.05, o->x1, o->y1, 0.02);
        kit_box(b, o->x0 + 0.05, o->y0, -0.05, o->x1 - 0.05, o->y0 + 0.05, 0.02);
        kit_box(b, o->x0 + 0.05, o->y1 - 0.05, -0.05, o->x1 - 0.05, o->y1, 0.02);
    }
    const double step = kit_between(b, 0.6, 1.1), deep = kit_between(b, 0.04, 0.16);
    const int rafters = kit_odds(b, 0.6);
    for (double x = 0.2; x < length - 0.1 && rafters; x += step)
        if (!meets(&w, x, 0.5, x + 0.08, 1)) kit_box(b, x, 0, 0.001, x + 0.08, up - 0.03, deep);
    kit_leave(b, before);
    for (int i = 0; i < 8; i++)
        claim_on(r, k, 0, fmax(0.2, knee + rise * i / 8 - 0.12), length, r->size[1], run * (i + 1) / 8 + 0.02);
}

/* ---- >>outside --------------------------------------------------------------------------------------------------- */

static void hills(const double *s, double u, double v, double p[3])
{
    const double a = 2 * KIT_PI * u, high = 8 + 12 * fabs(kit_fractal(7, 4 * cos(a), 4 * sin(a), s[1], 4));
    p[0] = s[0] * cos(a);
    p[1] = s[2] + v * high;
    p[2] = s[0] * sin(a);
}

/* A house over the way, before a wall with windows. */
static void house(kit_room *r, int k, double down)
{
    static const float fronts[][3] = { { 0.66f, 0.58f, 0.46f }, { 0.50f, 0.28f, 0.22f }, { 0.70f, 0.68f, 0.64f } };
    kit_build *b = r->b;
    const double away = kit_between(b, 6, 14), top = kit_between(b, 5.5, 11) - down, length = r->size[k & 1 ? 2 : 0];
    const kit_frame before = enter_wall(r, k);
    kit_begin_object(b, "house", -1);
    KIT_TINT(b, fronts, 0.1);
    kit_box(b, -6, -down, -away - 6, length + 6, top, -away);
    for (int i = 0; i < 24; i++) {
        const double x = -5 + (length + 9) * (i % 6) / 5, y = 1 - down + 2.6 * (i / 6);
        if (y + 1.6 > top) continue;
        kit_colour(b, 0.08, 0.09, 0.11);
        kit_box(b, x, y, -away, x + 1, y + 1.4, -away + 0.03);
        room_paint(b, r->trim, 0.1);
        kit_box(b, x - 0.1, y - 0.08, -away, x + 1.1, y - 0.001, -away + 0.12);
        kit_box(b, x + 0.47, y, -away + 0.03, x + 0.53, y + 1.4, -away + 0.05);
    }
    kit_leave(b, before);
}

static void outside(kit_room *r, double down)
{
    const double of[3] = { 60, kit_between(r->b, 0, 99), -down };
    kit_begin_object(r->b, "ground", 0);
    kit_colour(r->b, 0.25, 0.27, 0.16);
    kit_level(r->b, -62, -62, 62, 62, -down);
    kit_colour(r->b, 0.16, 0.22, 0.14);
    room_cloth(r->b, 160, 4, hills, of);
}

void room_build_shell(kit_room *r, int attic)
{
    static const float paints[][3] = { { 0.80f, 0.79f, 0.76f }, { 0.72f, 0.66f, 0.55f }, { 0.42f, 0.50f, 0.52f },
                                       { 0.56f, 0.60f, 0.48f }, { 0.66f, 0.42f, 0.34f }, { 0.30f, 0.34f, 0.42f },
                                       { 0.76f, 0.70f, 0.44f } };
    static const int plain[7] = { 0, 0, 0, 1, 1, 3, 4 };
    kit_build *b = r->b;
    const double thick = kit_odds(b, 0.35) ? 0 : kit_between(b, 0.1, 0.4), down = kit_between(b, 0.2, 5),
                 knee = kit_between(b, 0.8, 1.3),
                 run = attic ? fmin(0.36 * r->size[0], (r->size[1] - knee) * kit_between(b, 0.8, 1.4)) : 0;
    const int one_sided = kit_odds(b, 0.3), door = kit_choose(b, 2) * 2, sunny = attic ? 0 : kit_choose(b, 4),
              style = r->theme == KIT_BATH                        ? 2
                    : r->theme == KIT_KITCHEN && kit_odds(b, 0.4) ? 2
                                                                  : plain[kit_choose(b, 7)];
    outside(r, down);
    floor_of(r);
    for (int k = 0; k < 4; k++) {
        const int low = attic && k & 1 && !(one_sided && k == 1);
        wall w = { .length = r->size[k & 1 ? 2 : 0], .high = low ? knee : r->size[1], .thick = thick };
        const int windows = low                        ? 0
                          : k == sunny                 ? 1 + (w.length > 3.4) + (w.length > 5.5)
                          : !attic && kit_odds(b, 0.3) ? 1
                                                       : attic && !(k & 1);
        cut_openings(r, &w, attic && k == door ? 0 : windows, k == door, attic);
        const kit_frame before = enter_wall(r, k);
        kit_begin_object(b, "wall", 0);
        KIT_TINT(b, paints, 0.06);
        wall_faces(b, &w);
        cladding(r, &w, style, k, attic);
        fit_openings(r, k, &w);
        kit_leave(b, before);
        if (windows && kit_odds(b, 0.85)) house(r, k, down);
        kit_begin_object(b, "slope", 0);
        if (low) slope(r, k, knee, run);
    }
    const double x = 0.5 * r->size[0], z = 0.5 * r->size[2], y = r->size[1];
    const double ceiling[4][3] = { { -x, y, -z }, { x, y, -z }, { x, y, z }, { -x, y, z } };
    kit_begin_object(b, "ceiling", 0);
    room_paint(b, r->trim, 0.05);
    kit_quad(b, ceiling);
    if (!attic) return;
    r->p->ceiling = knee + 0.7 * (y - knee);
    if (!one_sided) r->p->stand[0] = -x + 0.75 * run;
    r->p->stand[2] = x - 0.75 * run;
}
