/* furniture.c - chairs, tables, shelves and cupboards. Declared in rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>

/* ---- >>chairs: looking to +z, the seat at 0.45 ------------------------------------------------------------------- */

/* Four legs under a seat, its half sides x and z, splayed outwards. */
static void legs(kit_build *b, double x, double z, double top, double splay, double radius)
{
    for (int i = 0; i < 4; i++) {
        const double sx = i & 1 ? 1 : -1, sz = i & 2 ? 1 : -1;
        room_rod(b, sx * (x + splay), 0, sz * (z + splay), sx * x, top, sz * z, radius);
    }
}

static void ladder_back(kit_room *r)
{
    kit_build *b = r->b;
    const int slats = 3 + kit_choose(b, 3);
    for (int i = -1; i <= 1; i += 2) {
        kit_box(b, i * 0.19 - 0.018, 0, 0.16, i * 0.19 + 0.018, 0.44, 0.196);
        kit_box(b, i * 0.19 - 0.018, 0, -0.196, i * 0.19 + 0.018, 0.5, -0.16);
        room_rod(b, i * 0.19, 0.18, -0.17, i * 0.19, 0.18, 0.17, 0.01);
        kit_place_tilted(b, i * 0.19, 0.5, -0.178, 0, -8);
        kit_box(b, -0.017, 0, -0.017, 0.017, 0.5, 0.017);
        kit_place_at(b, 0, 0, 0, 0);
    }
    room_rod(b, -0.18, 0.24, 0.178, 0.18, 0.24, 0.178, 0.01);
    for (int i = 0; i < slats; i++) {
        kit_place_tilted(b, 0, 0.5, -0.178, 0, -8);
        kit_box(b, -0.175, 0.1 + 0.38 * i / slats, -0.007, 0.175, 0.1 + 0.38 * i / slats + 0.05, 0.007);
    }
    kit_place_at(b, 0, 0, 0, 0);
    if (kit_odds(b, 0.5)) room_paint(b, r->cloth, 0.2);
    else kit_colour(b, 0.6, 0.5, 0.32);
    kit_bevelled(b, -0.215, 0.435, -0.2, 0.215, 0.465, 0.21, 0.01);
}

static void spindle_back(kit_room *r)
{
    kit_build *b = r->b;

    enum { ARCH = 20 };

    const double half[3] = { 0.22, 0.022, 0.21 };
    double arch[ARCH + 1][3];
    legs(b, 0.13, 0.13, 0.44, 0.06, 0.013);
    room_rod(b, -0.16, 0.2, 0.16, -0.16, 0.2, -0.16, 0.008);
    room_rod(b, 0.16, 0.2, 0.16, 0.16, 0.2, -0.16, 0.008);
    room_rod(b, -0.16, 0.2, 0, 0.16, 0.2, 0, 0.008);
    room_pillow(b, 0, 0.45, 0, 0, 0, half);
    for (int i = 0; i <= ARCH; i++) {
        const double a = KIT_PI * i / ARCH;
        arch[i][0] = -0.19 * cos(a);
        arch[i][1] = 0.46 + 0.48 * pow(sin(a), 0.6);
        arch[i][2] = -0.15 - 0.07 * pow(sin(a), 0.6);
    }
    kit_tube(b, (const double(*)[3])arch, ARCH + 1, 0.011, 10);
    for (int i = 4; i <= ARCH - 4; i += 2)
        room_rod(b, 0.8 * arch[i][0], 0.46, -0.17, arch[i][0], arch[i][1], arch[i][2], 0.006);
}

/* across, along: a seat that turns up into a back */
static void shell(const double *s, double u, double v, double p[3])
{
    const double x = 2 * u - 1, along = v * 0.78 - 0.24, a = fmin(fmax((along - 0.12) / 0.15, 0), 1.35);
    p[0] = x * (0.22 - 0.05 * v * v);
    p[1] = 0.44
         + (along > 0.12    ? 0.15 * (1 - cos(a)) + fmax(0, along - 0.3225) * 0.97
            : along < -0.18 ? along + 0.18
                            : 0)
         + s[0] * x * x;
    p[2] = along < 0.12 ? -along : -0.12 - 0.15 * sin(a) - fmax(0, along - 0.3225) * 0.22 + 0.12 * x * x * v * v;
}

static void shell_chair(kit_room *r)
{
    kit_build *b = r->b;
    const double of[1] = { 0.035 };
    room_paint(b, r->metal, 0.1);
    legs(b, 0.12, 0.12, 0.44, 0.08, 0.008);
    room_rod(b, -0.13, 0.36, 0.13, 0.13, 0.36, -0.13, 0.005);
    room_rod(b, 0.13, 0.36, 0.13, -0.13, 0.36, -0.13, 0.005);
    room_paint(b, kit_odds(b, 0.5) ? r->accent : r->trim, 0.1);
    room_cloth(b, 14, 24, shell, of);
}

static void cantilever(kit_room *r)
{
    kit_build *b = r->b;
    static const double path[][3] = { { 0.22, 0.95, -0.27 },   { 0.22, 0.5, -0.2 },   { 0.22, 0.46, -0.17 },
                                      { 0.22, 0.45, 0.17 },    { 0.22, 0.42, 0.21 },  { 0.22, 0.38, 0.22 },
                                      { 0.22, 0.05, 0.23 },    { 0.22, 0.015, 0.2 },  { 0.22, 0.012, -0.22 },
                                      { -0.22, 0.012, -0.22 }, { -0.22, 0.015, 0.2 }, { -0.22, 0.05, 0.23 },
                                      { -0.22, 0.38, 0.22 },   { -0.22, 0.42, 0.21 }, { -0.22, 0.45, 0.17 },
                                      { -0.22, 0.46, -0.17 },  { -0.22, 0.5, -0.2 },  { -0.22, 0.95, -0.27 } };
    const double
        seat[4][3] = { { -0.22, 0.462, 0.16 }, { 0.22, 0.462, 0.16 }, { 0.22, 0.472, -0.16 }, { -0.22, 0.472, -0.16 } },
        back[4][3] = { { -0.22, 0.64, -0.21 }, { 0.22, 0.64, -0.21 }, { 0.22, 0.92, -0.254 }, { -0.22, 0.92, -0.254 } };
    room_paint(b, r->metal, 0.1);
    kit_tube(b, path, sizeof path / sizeof *path, 0.011, 10);
    room_paint(b, r->accent, 0.2);
    kit_quad(b, seat);
    kit_quad(b, back);
}

static void folding_chair(kit_room *r)
{
    kit_build *b = r->b;
    for (int i = -1; i <= 1; i += 2) {
        const double x = 0.2 * i, y = 0.18 * i;
        room_rod(b, x, 0, 0.22, x, 0.82, -0.24, 0.012);
        room_rod(b, y, 0, -0.22, y, 0.45, 0.17, 0.012);
    }
    room_rod(b, -0.2, 0.1, 0.164, 0.2, 0.1, 0.164, 0.008);
    room_rod(b, -0.18, 0.1, -0.133, 0.18, 0.1, -0.133, 0.008);
    for (int i = 0; i < 6; i++) kit_box(b, -0.19, 0.445, -0.17 + 0.06 * i, 0.19, 0.46, -0.125 + 0.06 * i);
    for (int i = 0; i < 2; i++) {
        kit_place_tilted(b, 0, 0.66 + 0.09 * i, -0.15 - 0.05 * i, 0, -29);
        kit_box(b, -0.2, 0, 0.012, 0.2, 0.055, 0.024);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void office_chair(kit_room *r)
{
    kit_build *b = r->b;
    const double seat[3] = { 0.24, 0.045, 0.23 }, back[3] = { 0.22, 0.27, 0.035 };
    kit_colour(b, 0.08, 0.08, 0.09);
    for (int i = 0; i < 5; i++) {
        const double x = 0.28 * sin(1.2566 * i), z = 0.28 * cos(1.2566 * i);
        room_rod(b, 0, 0.12, 0, x, 0.075, z, 0.018);
        room_ball(b, x, 0.028, z, 0.028, 8);
    }
    room_rod(b, 0, 0.09, 0, 0, 0.42, 0, 0.025);
    room_rod(b, 0, 0.4, -0.1, 0, 0.66, -0.28, 0.018);
    for (int i = -1; i <= 1; i += 2) {
        room_rod(b, i * 0.27, 0.44, 0, i * 0.27, 0.66, -0.04, 0.014);
        room_rod(b, i * 0.2, 0.43, 0, i * 0.27, 0.44, 0, 0.014);
        kit_bevelled(b, i * 0.27 - 0.03, 0.655, -0.14, i * 0.27 + 0.03, 0.685, 0.12, 0.01);
    }
    room_paint(b, r->cloth, 0.3);
    room_pillow(b, 0, 0.46, 0, 0, 0, seat);
    room_pillow(b, 0, 0.8, -0.26, 0, -10, back);
}

static void padded_chair(kit_room *r)
{
    kit_build *b = r->b;
    const double seat[3] = { 0.23, 0.05, 0.22 }, back[3] = { 0.21, 0.25, 0.035 };
    legs(b, 0.18, 0.17, 0.42, 0.02, 0.016);
    room_paint(b, r->cloth, 0.1);
    room_pillow(b, 0, 0.45, 0, 0, 0, seat);
    room_pillow(b, 0, 0.74, -0.22, 0, -9, back);
}

static void stool(kit_room *r)
{
    kit_build *b = r->b;
    const int three = kit_odds(b, 0.4);
    const double high = kit_between(b, 0.42, 0.7), out = 0.14 + 0.06 * high;
    for (int i = 0; i < 3 + !three; i++) {
        const double a = 2 * KIT_PI * (i + 0.5) / (3 + !three);
        room_rod(b, out * cos(a), 0, out * sin(a), 0.11 * cos(a), high, 0.11 * sin(a), 0.012);
    }
    room_ring(b, 0, 0.4 * high, 0, 0, 0, 0.11 + 0.6 * (out - 0.11), 0.007);
    room_paint(b, kit_odds(b, 0.5) ? r->accent : r->wood, 0.2);
    kit_place_at(b, 0, high, 0, 0);
    kit_cylinder(b, 0.17, 0.035, 32);
    kit_place_at(b, 0, 0, 0, 0);
}

void room_chair(kit_room *r, int style)
{
    static void (*const styles[KIT_CHAIRS])(kit_room *) = { ladder_back,   spindle_back, shell_chair,  cantilever,
                                                            folding_chair, office_chair, padded_chair, stool };
    room_paint(r->b, kit_odds(r->b, 0.85) ? r->wood : r->trim, 0.12);
    styles[style](r);
}

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

static void round_table(kit_build *b, const double s[3])
{
    const double r = 0.5 * fmin(s[0], s[2]), h = s[1];
    const kit_moulding leg[] = { { 0, 0, 0.5 * r, 0, 0 },
                                 { 0.5 * r, 0, 0.5 * r, 0.03, 0 },
                                 { 0.5 * r, 0.03, 0.05, 0.1, -0.02 },
                                 { 0.05, 0.1, 0.04, 0.6 * h, 0.03 },
                                 { 0.04, 0.6 * h, 0.09, h - 0.03, -0.01 } };
    const kit_moulding top[] = { { 0, h - 0.03, r - 0.02, h - 0.03, 0 },
                                 { r - 0.02, h - 0.03, r - 0.02, h, 0.02 },
                                 { r - 0.02, h, 0, h, 0 } };
    kit_turned(b, leg, 5, 28);
    kit_turned(b, top, 3, 64);
}

/* Trestles below the ends. */
static void trestles(kit_build *b, double x, double z, double h)
{
    for (int i = -1; i <= 1; i += 2) {
        const double e = i * (x - 0.22);
        for (int k = -1; k <= 1; k += 2) {
            room_rod(b, e - 0.12, 0, k * (z - 0.06), e, h, k * (z - 0.06), 0.015);
            room_rod(b, e + 0.12, 0, k * (z - 0.06), e, h, k * (z - 0.06), 0.015);
        }
        kit_box(b, e - 0.03, h - 0.06, -z + 0.03, e + 0.03, h - KIT_GAP, z - 0.03);
        kit_box(b, e - 0.09, 0.18, -z + 0.05, e - 0.07, 0.22, z - 0.05);
        kit_box(b, e + 0.07, 0.18, -z + 0.05, e + 0.09, 0.22, z - 0.05);
    }
}

static void steel_frame(kit_room *r, double x, double z, double h)
{
    kit_build *b = r->b;
    room_paint(b, r->metal, 0.1);
    for (int i = -1; i <= 1; i += 2) {
        const double e = i * (x - 0.08);
        for (int k = -1; k <= 1; k += 2)
            kit_box(b, e - 0.02, 0, k * (z - 0.05) - 0.02, e + 0.02, h - 0.03, k * (z - 0.05) + 0.02);
        kit_box(b, e - 0.02, h - 0.03, -z + 0.03, e + 0.02, h - KIT_GAP, z - 0.03);
        kit_box(b, e - 0.019, 0.001, -z + 0.07, e + 0.019, 0.03, z - 0.07);
    }
    room_rod(b, -x + 0.08, h - 0.1, -z + 0.05, x - 0.08, h - 0.4, -z + 0.05, 0.005);
    room_rod(b, x - 0.08, h - 0.1, -z + 0.05, -x + 0.08, h - 0.4, -z + 0.05, 0.005);
}

void room_table(kit_room *r, const double s[3], int style)
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], z = 0.5 * s[2], h = s[1] - 0.03;
    room_paint(b, kit_odds(b, 0.8) ? r->wood : r->trim, 0.15);
    if (style == 1) {
        round_table(b, s);
        return;
    }
    kit_bevelled(b, -x, h, -z, x, s[1], z, 0.004);
    if (style == 0) {
        for (int i = 0; i < 4; i++) {
            const double e = (i & 1 ? 1 : -1) * (x - 0.06), f = (i & 2 ? 1 : -1) * (z - 0.06);
            kit_bevelled(b, e - 0.03, 0, f - 0.03, e + 0.03, h - KIT_GAP, f + 0.03, 0.004);
        }
        kit_box(b, -x + 0.09, h - 0.09, -z + 0.05, x - 0.09, h - KIT_GAP, -z + 0.07);
        kit_box(b, -x + 0.09, h - 0.09, z - 0.07, x - 0.09, h - KIT_GAP, z - 0.05);
        kit_box(b, -x + 0.05, h - 0.09, -z + 0.09, -x + 0.07, h - KIT_GAP, z - 0.09);
        kit_box(b, x - 0.07, h - 0.09, -z + 0.09, x - 0.05, h - KIT_GAP, z - 0.09);
    }
    if (style == 2) {
        room_paint(b, r->metal, 0.2);
        legs(b, x - 0.15, z - 0.12, h, 0.07, 0.013);
    }
    if (style == 3) trestles(b, x, z, h);
    if (style == 4) steel_frame(r, x, z, h);
}

/* A cloth over a round table: half its width, height, drop, seed. */
static void tablecloth(const double *s, double u, double v, double p[3])
{
    const double a = 2 * KIT_PI * u, d = v * (s[0] + s[2]), down = fmax(0, d - s[0]),
                 soft = down * down / (down + 0.04),
                 fold = down / (s[2] + 0.01) * (0.05 * sin(11 * a) + 0.035 * sin(7 * a + s[3]));
    const double out = fmin(d, s[0] + 0.012) + 0.12 * down + fold * 1.2;
    p[0] = out * cos(a);
    p[1] = s[1] - soft + 0.02 * fold;
    p[2] = out * sin(a);
}

void kit_small_table(kit_room *r, const double s[3])
{
    const kit_frame before = kit_enter(r->b, 0, 0, 0.5 * s[2], 0, 1);
    room_table(r, s, r->table);
    if (r->table == 1 && kit_odds(r->b, 0.4)) {
        const double of[4] = { 0.5 * fmin(s[0], s[2]), s[1] + 0.004, kit_between(r->b, 0.12, 0.5 * s[1]),
                               kit_between(r->b, 0, 6) };
        room_paint(r->b, r->cloth, 0.2);
        room_cloth(r->b, 96, 20, tablecloth, of);
    }
    const double part = r->table == 1 ? 0.34 : 0.46;
    room_clutter(r, -part * s[0], -part * s[2], part * s[0], part * s[2], s[1] + 0.005, 0.5, 0.6 + r->clutter);
    kit_leave(r->b, before);
}

void kit_stool_piece(kit_room *r, const double s[3])
{
    const kit_frame before = kit_enter(r->b, 0, 0, 0.5 * s[2], kit_between(r->b, 0, 360), 1);
    room_chair(r, kit_odds(r->b, 0.5) ? 7 : r->chair);
    kit_leave(r->b, before);
}

static void chair_at(kit_room *r, double x, double z, double turn)
{
    kit_begin_object(r->b, "chair", -1);
    const kit_frame before = kit_enter(r->b, x, 0, z, turn + kit_between(r->b, -12, 12), 1);
    room_chair(r, kit_odds(r->b, 0.12) ? kit_choose(r->b, KIT_CHAIRS) : r->chair);
    kit_leave(r->b, before);
}

/* A table and its chairs; s: with the chairs. */
void kit_dining(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const int style = r->table, seats = style == 1 ? 0 : (int)((s[0] - 1.1) / 0.6);
    const double top[3] = { s[0] - 1.1, s[1], s[2] - 1.1 }, out = kit_between(b, -0.05, 0.28);
    const kit_frame before = kit_enter(b, 0, 0, 0.5 * s[2], 0, 1);
    kit_begin_object(b, "table", -1);
    room_table(r, top, style);
    const double part = style == 1 ? 0.33 : 0.46;
    room_clutter(r, -part * top[0], -part * top[2], part * top[0], part * top[2], s[1], 0.5, 0.5 + r->clutter);
    room_sight_here(r, 0, s[1], 0, 0.6 * top[0]);
    for (int i = 0; i < seats; i++)
        for (int k = -1; k <= 1; k += 2)
            if (kit_odds(b, 0.85))
                chair_at(r, top[0] * ((i + 0.5) / seats - 0.5), k * (0.5 * top[2] + out), k > 0 ? 180 : 0);
    for (int k = -1; k <= 1 && seats; k += 2)
        if (kit_odds(b, 0.5)) chair_at(r, k * (0.5 * top[0] + 0.15), 0, k > 0 ? 270 : 90);
    const double away = 0.5 * fmin(top[0], top[2]) + out;
    for (int i = 0; i < 4 && !seats; i++) chair_at(r, away * sin(1.57 * i), away * cos(1.57 * i), 180 + 90 * i);
    kit_leave(b, before);
}

/* ---- >>shelves and cupboards ------------------------------------------------------------------------------------- */

static void filled(kit_room *r, double x, double y, double z, double w, double d, double h)
{
    const kit_frame before = kit_enter(r->b, x, y, z, 0, 1);
    room_fill_shelf(r, w, d, h);
    kit_leave(r->b, before);
}

void kit_bookcase(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], t = kit_between(b, 0.018, 0.035), back = kit_odds(b, 0.6) ? 0.008 : 0;
    const int bays = 1 + (int)(s[0] / 0.85), boards = 2 + (int)(s[1] / 0.38);
    const double bay = (s[0] - t) / bays, rise = (s[1] - 0.06 - t) / (boards - 1), y0 = 0.06;
    const float *const colour = kit_odds(b, 0.6) ? r->wood : r->trim;
    room_paint(b, colour, 0.1);
    for (int i = 0; i <= bays; i++) kit_box(b, -x + i * bay, 0, 0.002, -x + i * bay + t, s[1], s[2]);
    if (back > 0) kit_box(b, -x + t, y0, 0.002, x - t, s[1] - t, back);
    for (int k = 0; k < bays; k++)
        for (int i = 0; i < boards; i++) {
            const double left = -x + k * bay + t, y = y0 + i * rise;
            room_paint(b, colour, 0.04);
            kit_box(b, left, y, back, left + bay - t, y + t, s[2] - 0.004);
            if (i + 1 < boards) filled(r, left, y + t, back, bay - t, s[2] - back, rise - t - 0.01);
        }
    room_sight_here(r, kit_between(b, -0.3, 0.3) * s[0], kit_between(b, 0.3, 0.8) * s[1], s[2], 0.4);
    if (s[1] < 1.9 || kit_odds(b, 0.3)) room_clutter(r, -x, 0, x, s[2], s[1], 0.3, 1);
}

void kit_steel_shelf(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0];
    const int boards = 3 + kit_choose(b, 3);
    room_paint(b, r->metal, 0.2);
    for (int i = 0; i < 4; i++) {
        const double e = i & 1 ? x : -x, f = i & 2 ? s[2] : 0.01, in = i & 1 ? -0.035 : 0.035,
                     deep = i & 2 ? -0.035 : 0.035;
        const double flat[4][3] = { { e, 0, f }, { e + in, 0, f }, { e + in, s[1], f }, { e, s[1], f } },
                     side[4][3] = { { e, 0, f }, { e, 0, f + deep }, { e, s[1], f + deep }, { e, s[1], f } };
        kit_quad(b, flat);
        kit_quad(b, side);
    }
    room_rod(b, -x, 0.1, 0.008, x, s[1] - 0.1, 0.008, 0.004);
    room_rod(b, x, 0.1, 0.008, -x, s[1] - 0.1, 0.008, 0.004);
    for (int i = 0; i < boards; i++) {
        const double y = 0.12 + (s[1] - 0.16) * i / (boards - 1);
        room_paint(b, r->metal, 0.1);
        kit_box(b, -x + 0.002, y, 0.013, x - 0.002, y + 0.03, s[2] - 0.003);
        filled(r, -x + 0.03, y + 0.03, 0.03, s[0] - 0.06, s[2] - 0.05,
               i + 1 < boards ? (s[1] - 0.16) / (boards - 1) - 0.04 : 0.35);
    }
}

static void handle(kit_room *r, double x, double y, double z, int style)
{
    room_paint(r->b, r->metal, 0.1);
    if (style == 0) room_ball(r->b, x, y, z + 0.012, 0.014, 8);
    if (style == 1) kit_box(r->b, x - 0.006, y - 0.06, z, x + 0.006, y + 0.06, z + 0.022);
    if (style == 2) room_ring(r->b, x, y, z + 0.004, 0, 90, 0.022, 0.004);
}

/* A front of a door: flat, or with a frame about a panel. */
static void front(kit_room *r, double x0, double y0, double x1, double y1, double z, int panelled)
{
    kit_build *b = r->b;
    const double f = 0.055;
    if (!panelled || x1 - x0 < 0.2 || y1 - y0 < 0.2) {
        kit_bevelled(b, x0, y0, z, x1, y1, z + 0.018, 0.002);
        return;
    }
    kit_box(b, x0, y0, z, x0 + f, y1, z + 0.02);
    kit_box(b, x1 - f, y0, z, x1, y1, z + 0.02);
    kit_box(b, x0 + f, y0, z, x1 - f, y0 + f, z + 0.02);
    kit_box(b, x0 + f, y1 - f, z, x1 - f, y1, z + 0.02);
    kit_bevelled(b, x0 + f, y0 + f, z, x1 - f, y1 - f, z + 0.012, 0.004);
}

/* the carcass: sides, top, bottom, back; its front open */
static void carcass(kit_build *b, const double s[3], double foot)
{
    const double x = 0.5 * s[0], t = 0.018, z = s[2] - 0.022;
    kit_box(b, -x, foot, 0.002, -x + t, s[1] - t, z);
    kit_box(b, x - t, foot, 0.002, x, s[1] - t, z);
    kit_box(b, -x + t, foot, 0.002, x - t, foot + t, z);
    kit_bevelled(b, -x - 0.01, s[1] - t, 0.002, x + 0.01, s[1], s[2] + 0.006, 0.003);
    kit_box(b, -x + t, foot + t, 0.002, x - t, s[1] - t, 0.01);
}

void kit_cabinet(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const float *const colour = kit_odds(b, 0.6) ? r->wood : r->trim;
    const int panelled = kit_odds(b, 0.5), knob = kit_choose(b, 3), doors = s[0] < 0.55 ? 1 : (int)(s[0] / 0.45);
    const double foot = kit_odds(b, 0.4) ? 0.15 : 0.06, wide = s[0] / doors, z = s[2] - 0.02;
    room_paint(b, colour, 0.1);
    carcass(b, s, foot);
    if (foot > 0.1) legs(b, 0.5 * s[0] - 0.06, 0.001, foot, 0.03, 0.014);
    else kit_box(b, -0.5 * s[0] + 0.03, 0, 0.02, 0.5 * s[0] - 0.03, foot, s[2] - 0.06);
    for (int i = 0; i < doors; i++) {
        const double x0 = -0.5 * s[0] + i * wide + 0.002, x1 = x0 + wide - 0.004;
        if (kit_odds(b, 0.12)) { /* open */
            const kit_frame before = kit_enter(b, x0, 0, z, -kit_between(b, 40, 100), 1);
            room_paint(b, colour, 0.05);
            front(r, 0, foot + 0.003, wide - 0.004, s[1] - 0.022, 0, panelled);
            kit_leave(b, before);
            filled(r, x0 + 0.02, foot + 0.02, 0.02, wide - 0.04, s[2] - 0.07, 0.5 * (s[1] - foot));
            room_sight_here(r, 0.5 * (x0 + x1), 0.5 * s[1], z, 0.45);
            continue;
        }
        room_paint(b, colour, 0.05);
        front(r, x0, foot + 0.003, x1, s[1] - 0.022, z, panelled);
        handle(r, i & 1 ? x0 + 0.05 : x1 - 0.05, fmin(0.8 * s[1], fmax(0.55 * s[1], 1)), z + 0.019, knob);
    }
    if (s[1] < 1.5) room_clutter(r, -0.5 * s[0], 0, 0.5 * s[0], s[2], s[1], 0.5, 1 + r->clutter);
    else if (kit_odds(b, 0.4)) room_clutter(r, -0.5 * s[0], 0, 0.5 * s[0], s[2], s[1], 0.25, 1);
}

void kit_drawers(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const float *const colour = kit_odds(b, 0.6) ? r->wood : r->accent;
    const int rows = 3 + kit_choose(b, 3), knob = kit_choose(b, 3);
    const double rise = (s[1] - 0.1) / rows, x = 0.5 * s[0];
    room_paint(b, colour, 0.1);
    carcass(b, s, 0.08);
    legs(b, x - 0.05, 0.001, 0.08, 0.01, 0.02);
    for (int i = 0; i < rows; i++) {
        const double y0 = 0.083 + i * rise, y1 = y0 + rise - 0.005,
                     out = kit_odds(b, 0.25) ? kit_between(b, 0.05, 0.25) : 0, z = s[2] - 0.02 + out;
        room_paint(b, colour, 0.05);
        front(r, -x + 0.003, y0, x - 0.003, y1, z, 0);
        if (out > 0) {
            kit_box(b, -x + 0.03, y0 + 0.02, 0.03, -x + 0.04, y1 - 0.03, z);
            kit_box(b, x - 0.04, y0 + 0.02, 0.03, x - 0.03, y1 - 0.03, z);
            kit_box(b, -x + 0.04, y0 + 0.02, 0.03, x - 0.04, y0 + 0.03, z);
            room_paint(b, r->cloth, 0.3);
            const double half[3] = { 0.6 * x, 0.4 * rise, 0.12 };
            room_pillow(b, 0, y0 + 0.4 * rise, z - 0.14, 0, 0, half);
        }
        for (int k = -1; k <= 1; k += 2) handle(r, k * 0.25 * s[0], 0.5 * (y0 + y1), z + 0.018, knob);
    }
    room_clutter(r, -x, 0, x, s[2], s[1], 0.5, 1 + r->clutter);
}

void kit_wall_shelf(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const int boards = s[1] > 0.5 ? 2 : 1;
    for (int i = 0; i < boards; i++) {
        const double y = 0.02 + 0.36 * i;
        room_paint(b, r->wood, 0.15);
        kit_box(b, -0.5 * s[0], y, 0.001, 0.5 * s[0], y + 0.022, s[2]);
        room_paint(b, r->metal, 0.15);
        for (int k = -1; k <= 1; k += 2) {
            const double x = k * 0.36 * s[0];
            kit_box(b, x - 0.01, y - 0.16, 0.0005, x + 0.01, y, 0.006);
            room_rod(b, x, y - 0.15, 0.005, x, y, s[2] - 0.03, 0.005);
        }
        filled(r, -0.5 * s[0], y + 0.022, 0.01, s[0], s[2] - 0.01, 0.3);
    }
}

/* A railing of bars or of wires, along x. */
void kit_railing(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], z = 0.5 * s[2];
    const int bars = kit_odds(b, 0.6), posts = 2 + (int)(s[0] / 1.2);
    room_paint(b, bars ? r->wood : r->metal, 0.15);
    for (int i = 0; i < posts; i++) {
        const double e = -x + 0.03 + (s[0] - 0.06) * i / (posts - 1);
        kit_box(b, e - 0.025, 0, z - 0.025, e + 0.025, s[1] - 0.04, z + 0.025);
    }
    kit_bevelled(b, -x - 0.04, s[1] - 0.04, z - 0.035, x + 0.04, s[1], z + 0.035, 0.01);
    if (bars) {
        kit_box(b, -x, 0.08, z - 0.015, x, 0.11, z + 0.015);
        for (double e = -x + 0.12; e < x; e += 0.11) room_rod(b, e, 0.1, z, e, s[1] - 0.03, z, 0.009);
    } else
        for (double y = 0.12; y < s[1] - 0.08; y += 0.11) room_rod(b, -x, y, z, x, y, z, 0.003);
}
