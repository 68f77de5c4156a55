/* lounge.c - sofas, beds, what stands in homes and hangs on walls. Declared in rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>

/* ---- >>seats ----------------------------------------------------------------------------------------------------- */

/* A throw over an edge along x: width, across the top, down in front, down behind, its seed. */
static void throw_cloth(const double *s, double u, double v, double p[3])
{
    const double soft = 0.04, total = s[1] + s[2] + s[3], along = v * total - s[3], over = fmax(0, along - s[1]),
                 under = fmax(0, -along);
    const unsigned seed = (unsigned)s[4];
    const double rough = kit_fractal(seed, 4 * u * s[0], 4 * v * total, 0, 3), drop = over + under;
    p[0] = s[0] * (u - 0.5) * (1 + 0.08 * kit_noise(seed + 9, 2 * v, 0, 0));
    p[1] = fmax(0.006, 0.018 + 0.012 * rough) - drop * drop / (drop + soft);
    p[2] = fmin(fmax(along, 0), s[1])
         + (over > 0 ? 1 : -1)
               * (0.03 * fmin(1, drop / soft) + 0.02 * drop * rough
                  + 0.02 * fmin(1, drop / 0.2) * kit_noise(seed, 14 * u * s[0], drop, 1));
}

static void cover(kit_build *b, double width, double top, double before, double behind)
{
    const double of[5] = { width, top, before, behind, floor(kit_between(b, 1, 1e6)) };
    room_cloth(b, (int)fmin(64, 12 + 26 * width), 48, throw_cloth, of);
}

static void sofa_legs(kit_room *r, const double s[3])
{
    room_paint(r->b, kit_odds(r->b, 0.5) ? r->wood : r->metal, 0.1);
    for (int i = 0; i < 4; i++) {
        const double x = (i & 1 ? 1 : -1) * (0.5 * s[0] - 0.1), z = i & 2 ? s[2] - 0.1 : 0.1;
        room_rod(r->b, x, 0, z, x, 0.14, z, 0.018);
    }
}

/* Arms: blocks, rolls or boards. */
static void arms(kit_room *r, const double s[3], double arm, int style)
{
    kit_build *b = r->b;
    for (int i = -1; i <= 1; i += 2) {
        const double x = i * (0.5 * s[0] - 0.5 * arm);
        const double block[3] = { 0.5 * arm, 0.24, 0.5 * s[2] - 0.01 };
        if (style == 0) room_pillow(b, x, 0.38, 0.5 * s[2], 0, 0, block);
        if (style == 1) {
            kit_box(b, x - 0.4 * arm, 0.12, 0.04, x + 0.4 * arm, 0.56, s[2] - 0.02);
            room_rod(b, x, 0.56, 0.03, x, 0.56, s[2], 0.5 * arm);
        }
        if (style == 2) kit_bevelled(b, x - 0.5 * arm, 0.12, 0.02, x + 0.5 * arm, 0.6, s[2] - 0.01, 0.012);
    }
}

void kit_sofa(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const int style = kit_choose(b, 3), seats = (int)fmax(1, (s[0] - 0.2) / 0.65);
    const double arm = style == 2 ? 0.06 : kit_between(b, 0.13, 0.2), wide = (s[0] - 2 * arm) / seats, high = s[1];
    sofa_legs(r, s);
    room_paint(b, r->cloth, 0.1);
    kit_bevelled(b, -0.5 * s[0] + 0.5 * arm, 0.13, 0.05, 0.5 * s[0] - 0.5 * arm, 0.3, s[2] - 0.03, 0.015);
    const double rest[3] = { 0.5 * s[0] - 0.4 * arm, 0.5 * (high - 0.14), 0.1 };
    room_pillow(b, 0, 0.14 + rest[1], 0.12, 0, -5, rest);
    arms(r, s, arm, style);
    for (int i = 0; i < seats; i++) {
        const double x = (i + 0.5 - 0.5 * seats) * wide, seat[3] = { 0.5 * wide - 0.004, 0.08, 0.5 * (s[2] - 0.2) },
                     back[3] = { 0.48 * wide, 0.5 * (high - 0.36), 0.085 };
        room_pillow(b, x, 0.36, 0.2 + seat[2], kit_between(b, -1, 1), 0, seat);
        room_pillow(b, x, 0.42 + back[1], 0.29, kit_between(b, -3, 3), -14, back);
    }
    for (int i = kit_choose(b, 2 + seats); i > 0; i--) {
        const double half[3] = { kit_between(b, 0.17, 0.23), kit_between(b, 0.15, 0.21), 0.07 };
        room_paint(b, kit_odds(b, 0.5) ? r->accent : r->trim, 0.3);
        room_pillow(b, kit_between(b, -0.42, 0.42) * (s[0] - 2 * arm), 0.43 + half[1], 0.45, kit_between(b, -25, 25),
                    -kit_between(b, 12, 35), half);
    }
    if (!kit_odds(b, 0.35)) return;
    kit_begin_object(b, "throw", -1);
    room_paint(b, r->accent, 0.3);
    kit_place_at(b, kit_between(b, -0.25, 0.25) * s[0], 0.445, 0.35, kit_between(b, -6, 6));
    cover(b, kit_between(b, 0.45, 0.7), s[2] - 0.35, kit_between(b, 0.1, 0.3), 0);
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_armchair(kit_room *r, const double s[3]) { kit_sofa(r, s); }

/* A sofa, a low table on a rug before it, an armchair beside. */
void kit_lounge(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double seat[3] = { fmin(s[0], kit_between(b, 1.6, 2.6)), kit_between(b, 0.72, 0.9), 0.92 };
    const double low[3] = { kit_between(b, 0.7, 1.2), kit_between(b, 0.34, 0.46), kit_between(b, 0.5, 0.7) };
    const double rug[3] = { seat[0] * kit_between(b, 0.8, 1.2), 0.012, s[2] - 0.6 };
    kit_frame before = kit_enter(b, 0, 0, 0.02, 0, 1);
    kit_begin_object(b, "sofa", -1);
    kit_sofa(r, seat);
    room_sight_here(r, 0, 0.5, 0.5, 0.9);
    kit_leave(b, before);
    before = kit_enter(b, kit_between(b, -0.2, 0.2), 0, 0.55, kit_between(b, -4, 4), 1);
    kit_begin_object(b, "rug", -1);
    if (kit_odds(b, 0.75)) kit_rug(r, rug);
    kit_leave(b, before);
    before = kit_enter(b, kit_between(b, -0.2, 0.2), 0.012, 1.25, kit_between(b, -5, 5), 1);
    kit_begin_object(b, "low table", -1);
    kit_small_table(r, low);
    room_sight_here(r, 0, 0.4, 0.3, 0.55);
    kit_leave(b, before);
}

/* A rug: two triangles, or a cloth with waves, or rings; and a fringe. */
void kit_rug(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const int style = kit_choose(b, 3);
    const double x = 0.5 * s[0];
    room_paint(b, kit_odds(b, 0.5) ? r->accent : r->cloth, 0.35);
    if (style == 0 && s[0] < 2.6) {
        kit_place_at(b, 0, 0, 0.5 * s[2], 0);
        kit_cylinder(b, 0.5 * fmin(s[0], s[2]), s[1], 56);
        kit_place_at(b, 0, 0, 0, 0);
        return;
    }
    kit_box(b, -x, 0, 0, x, s[1], s[2]);
    room_paint(b, r->trim, 0.3);
    for (int i = 0; i < 2 && style == 1; i++) {
        const double e = 0.12 + 0.1 * i, y = s[1] + 0.002 + 0.001 * i;
        kit_level(b, -x + e, e, x - e, e + 0.03, y);
        kit_level(b, -x + e, s[2] - e - 0.03, x - e, s[2] - e, y);
        kit_level(b, -x + e, e + 0.03, -x + e + 0.03, s[2] - e - 0.03, y);
        kit_level(b, x - e - 0.03, e + 0.03, x - e, s[2] - e - 0.03, y);
    }
    for (double z = 0.01; z < s[2] && style == 2; z += 0.025)
        for (int k = -1; k <= 1; k += 2) {
            kit_place_at(b, k * x, 0.006, z, 90 * k + kit_between(b, -20, 20));
            kit_leaf(b, 0.012, 0.07, 0.1, 2, 0);
        }
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>beds ------------------------------------------------------------------------------------------------------ */

static void headboard(kit_room *r, double x, double h, int style)
{
    kit_build *b = r->b;
    const double padded[3] = { x, 0.5 * (h - 0.2), 0.05 };
    if (style == 0) room_pillow(b, 0, 0.2 + padded[1], 0.05, 0, 0, padded);
    if (style == 1) {
        room_rod(b, -x, 0, 0.03, -x, h, 0.03, 0.02);
        room_rod(b, x, 0, 0.03, x, h, 0.03, 0.02);
        room_rod(b, -x, h - 0.03, 0.03, x, h - 0.03, 0.03, 0.014);
        room_rod(b, -x, 0.5, 0.03, x, 0.5, 0.03, 0.012);
        for (double e = -x + 0.1; e < x - 0.05; e += 0.1) room_rod(b, e, 0.5, 0.03, e, h - 0.03, 0.03, 0.006);
    }
    if (style == 2) kit_bevelled(b, -x, 0.02, 0.005, x, h, 0.045, 0.006);
}

/* A blanket on a bed: half width, length, drop to the sides, its seed. */
static void blanket(const double *s, double u, double v, double p[3])
{
    const unsigned seed = (unsigned)s[3];
    const double total = 2 * (s[0] + s[2]), along = (u - 0.5) * total, over = fmax(0, fabs(along) - s[0]),
                 end = fmax(0, v * (s[1] + s[2]) - s[1]), drop = fmax(over, end),
                 rough = kit_fractal(seed, 2.2 * along, 2.2 * v * s[1], 0, 4);
    p[0] = copysign(fmin(fabs(along), s[0]) + (over > 0 ? 0.03 + 0.03 * fabs(rough) : 0), along);
    p[1] = fmax(0.008, 0.045 + 0.04 * rough * (drop > 0 ? 0.3 : 1)) - drop * drop / (drop + 0.05);
    p[2] = fmin(v * (s[1] + s[2]), s[1]) + (end > 0 ? 0.03 : 0) + 0.03 * kit_noise(seed + 5, 2 * along, 0, 0);
}

void kit_bed(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], half[3] = { x - 0.03, 0.11, 0.5 * s[2] - 0.07 }, bare = kit_between(b, 0.45, 0.9);
    const double of[4] = { x - 0.01, s[2] - bare - 0.02, kit_between(b, 0.1, 0.3), floor(kit_between(b, 0, 1e6)) };
    room_paint(b, r->wood, 0.1);
    headboard(r, x, s[1], kit_choose(b, 3));
    kit_box(b, -x, 0.16, 0.1, -x + 0.025, 0.32, s[2]);
    kit_box(b, x - 0.025, 0.16, 0.1, x, 0.32, s[2]);
    kit_box(b, -x + 0.025, 0.16, s[2] - 0.025, x - 0.025, 0.32, s[2]);
    for (int i = 0; i < 4; i++)
        kit_box(b, (i & 1 ? x - 0.07 : -x), 0, i & 2 ? s[2] - 0.1 : 0.11, (i & 1 ? x : -x + 0.07), 0.159,
                i & 2 ? s[2] - 0.03 : 0.18);
    for (double z = 0.2; z < s[2] - 0.1; z += 0.13) kit_box(b, -x + 0.026, 0.27, z, x - 0.026, 0.29, z + 0.07);
    kit_colour(b, 0.82, 0.8, 0.76);
    kit_place_at(b, 0, 0.4, 0.08 + half[2], 0);
    kit_cushion(b, half, 0.15, 20);
    for (int i = s[0] > 1.2 ? -1 : 0; i <= 1; i += 2) {
        const double pillow[3] = { fmin(0.34, 0.42 * s[0]), 0.085, 0.22 };
        room_paint(b, i > 0 ? r->trim : r->accent, 0.15);
        room_pillow(b, s[0] > 1.2 ? 0.48 * i * x : 0, 0.57, 0.38, kit_between(b, -8, 8), kit_between(b, -24, -4),
                    pillow);
    }
    kit_begin_object(b, "blanket", -1);
    room_paint(b, r->cloth, 0.2);
    kit_place_at(b, 0, 0.52, bare, 0);
    room_cloth(b, 72, 64, blanket, of);
    kit_place_at(b, 0, 0, 0, 0);
    room_sight_here(r, 0, 0.6, 0.4, 0.5);
    if (!kit_odds(b, 0.5)) return;
    kit_begin_object(b, "throw", -1);
    room_paint(b, r->accent, 0.3);
    kit_place_at(b, kit_between(b, -0.2, 0.2), 0.6, s[2] - 0.75, kit_between(b, -8, 8));
    cover(b, 0.8 * s[0], 0.7, 0.15, 0);
    kit_place_at(b, 0, 0, 0, 0);
}

/* Bars about a mattress. */
void kit_cot(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], half[3] = { x - 0.03, 0.06, 0.5 * s[2] - 0.04 };
    room_paint(b, kit_odds(b, 0.5) ? r->trim : r->wood, 0.1);
    for (int i = 0; i < 2; i++) {
        const double z = i ? s[2] - 0.02 : 0.02, e = i ? x : -x;
        for (int k = 0; k < 2; k++) {
            const double y = k ? s[1] - 0.03 : 0.25;
            kit_box(b, -x, y, z - 0.015, x, y + 0.03, z + 0.015);
            kit_box(b, e - 0.014, y + 0.001, 0.036, e + 0.014, y + 0.029, s[2] - 0.036);
        }
        for (double t = -x + 0.07; t < x; t += 0.075) room_rod(b, t, 0.27, z, t, s[1] - 0.02, z, 0.007);
        for (double t = 0.1; t < s[2] - 0.05; t += 0.075) room_rod(b, e, 0.27, t, e, s[1] - 0.02, t, 0.007);
        kit_box(b, e - 0.02, 0, 0.0, e + 0.02, s[1], 0.04);
        kit_box(b, e - 0.02, 0, s[2] - 0.04, e + 0.02, s[1], s[2]);
    }
    kit_colour(b, 0.8, 0.8, 0.76);
    room_pillow(b, 0, 0.33, 0.5 * s[2], 0, 0, half);
    room_clutter(r, -x + 0.05, 0.05, x - 0.05, s[2] - 0.05, 0.39, 0.35, 1);
    room_paint(b, r->cloth, 0.3);
    kit_place_at(b, 0, s[1] + 0.002, s[2] - 0.02, 0);
    room_hang_cloth(b, 0.6 * s[0], 0.35, 0.2);
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>what stands ----------------------------------------------------------------------------------------------- */

void kit_screen_stand(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double low[3] = { s[0], 0.45, s[2] }, x = 0.42 * s[0], h = 1.12 * x;
    kit_cabinet(r, low);
    kit_colour(b, 0.03, 0.03, 0.035);
    kit_begin_object(b, "screen", -1);
    kit_bevelled(b, -x, 0.53, 0.14, x, 0.53 + h, 0.18, 0.006);
    kit_box(b, -0.25, 0.451, 0.08, 0.25, 0.462, 0.26);
    kit_box(b, -0.04, 0.462, 0.14, 0.04, 0.6, 0.16);
    kit_colour(b, 0.09, 0.1, 0.13);
    kit_box(b, -x + 0.012, 0.545, 0.18, x - 0.012, 0.53 + h - 0.012, 0.181);
    for (int i = 0; i < 3; i++) {
        const double from[3] = { 0.1 * i - 0.1, 0.6, 0.13 }, to[3] = { 0.3 * i - 0.2, 0.3 - 0.12 * i, 0.01 };
        kit_colour(b, 0.06, 0.06, 0.06);
        kit_cable(b, from, to, 0.1, 0.004, 6);
    }
}

void kit_fireplace(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], in = 0.62 * x, top = 0.66 * s[1];
    const double back[4][3] = { { -in, 0.05, 0.01 }, { in, 0.05, 0.01 }, { in, top, 0.01 }, { -in, top, 0.01 } };
    room_paint(b, kit_odds(b, 0.5) ? r->trim : r->wood, 0.2);
    kit_bevelled(b, -x, 0, 0.002, -in, top, s[2], 0.01);
    kit_bevelled(b, in, 0, 0.002, x, top, s[2], 0.01);
    kit_bevelled(b, -x, top + KIT_GAP, 0.002, x, s[1] - 0.06, s[2], 0.01);
    kit_bevelled(b, -x - 0.08, s[1] - 0.059, 0.002, x + 0.08, s[1], s[2] + 0.07, 0.012);
    kit_colour(b, 0.07, 0.06, 0.06);
    kit_quad(b, back);
    kit_box(b, -in, 0, 0.002, in, 0.05, s[2] + 0.3);
    for (int i = 0; i < 6; i++) {
        kit_colour(b, 0.25, 0.17, 0.1);
        room_rod(b, -0.22 + 0.03 * i, 0.1 + 0.06 * (i / 3), 0.1 + 0.08 * (i % 3), 0.2, 0.11 + 0.05 * (i / 2),
                 0.3 - 0.07 * (i % 3), 0.035);
    }
    kit_colour(b, 0.1, 0.1, 0.1);
    for (int i = 0; i < 14; i++)
        room_rod(b, -in + 0.05 + i * (2 * in - 0.1) / 13, 0.05, s[2] + 0.1, -in + 0.05 + i * (2 * in - 0.1) / 13, 0.4,
                 s[2] + 0.1, 0.004);
    room_rod(b, -in + 0.04, 0.4, s[2] + 0.1, in - 0.04, 0.4, s[2] + 0.1, 0.008);
    room_clutter(r, -x, 0.02, x, s[2] + 0.05, s[1], 0.5, 2);
}

void kit_piano(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], key = (s[0] - 0.12) / 50;
    room_paint(b, kit_odds(b, 0.5) ? r->metal : r->wood, 0.3);
    kit_bevelled(b, -x, 0.05, 0.005, x, s[1], 0.33, 0.01);
    kit_box(b, -x, 0.6, 0.331, x, 0.68, s[2]);
    for (int i = -1; i <= 1; i += 2) {
        kit_box(b, i * (x - 0.025) - 0.025, 0.681, 0.331, i * (x - 0.025) + 0.025, 0.8, s[2]);
        room_rod(b, i * (x - 0.05), 0, s[2] - 0.06, i * (x - 0.05), 0.6, s[2] - 0.06, 0.03);
    }
    kit_place_tilted(b, 0, 0.86, 0.36, 0, -15);
    kit_box(b, -0.35, 0, 0, 0.35, 0.28, 0.01);
    kit_place_at(b, 0, 0, 0, 0);
    kit_colour(b, 0.82, 0.81, 0.76);
    for (int i = 0; i < 50; i++)
        kit_box(b, -x + 0.06 + key * i, 0.681, 0.36, -x + 0.06 + key * i + key - 0.0012, 0.7, s[2] - 0.02);
    kit_colour(b, 0.04, 0.04, 0.04);
    for (int i = 0; i < 49; i++)
        if (i % 7 != 2 && i % 7 != 6)
            kit_box(b, -x + 0.06 + key * (i + 0.7), 0.7, 0.361, -x + 0.06 + key * (i + 1.3), 0.712,
                    0.36 + 0.6 * (s[2] - 0.38));
    room_clutter(r, -x, 0.02, x, 0.33, s[1], 0.45, 1.5);
    room_sight_here(r, 0, 0.75, s[2], 0.5);
}

/* A bar on stands, with clothes. */
void kit_clothes_rack(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0] - 0.03, z = 0.5 * s[2];
    room_paint(b, r->metal, 0.1);
    room_rod(b, -x, s[1], z, x, s[1], z, 0.013);
    for (int i = -1; i <= 1; i += 2) {
        room_rod(b, i * x, 0.05, z, i * x, s[1] + 0.05, z, 0.013);
        room_rod(b, i * x, 0.03, 0.02, i * x, 0.03, s[2] - 0.02, 0.013);
    }
    room_rod(b, -x, 0.16, z, x, 0.16, z, 0.01);
    for (double e = -x + 0.08; e < x - 0.05; e += kit_between(b, 0.05, 0.16)) {
        kit_place_at(b, e, s[1], z, 90 + kit_between(b, -8, 8));
        kit_colour(b, 0.3, 0.3, 0.3);
        room_rod(b, 0, -0.1, 0, 0, 0.01, 0, 0.002);
        room_rod(b, -0.2, -0.17, 0, 0, -0.1, 0, 0.006);
        room_rod(b, 0.2, -0.17, 0, 0, -0.1, 0, 0.006);
        room_cover(b);
        kit_place_at(b, e, s[1] - 0.15, z, b->turn);
        room_hang_cloth(b, kit_between(b, 0.36, 0.44), kit_between(b, 0.5, 0.95), kit_between(b, 0.5, 0.95));
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* Rods on crossed legs, with washing. */
void kit_airer(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0];
    room_paint(b, r->trim, 0.1);
    for (int i = -1; i <= 1; i += 2) {
        room_rod(b, i * x, 0, 0.03, i * x, s[1], s[2] - 0.03, 0.008);
        room_rod(b, i * (x - 0.02), 0, s[2] - 0.03, i * (x - 0.02), s[1], 0.03, 0.008);
        room_rod(b, i * x, s[1], 0, i * x, s[1], s[2], 0.008);
    }
    for (int i = 0; i < 8; i++) {
        const double z = s[2] * i / 7;
        room_paint(b, r->trim, 0.1);
        room_rod(b, -x, s[1], z, x, s[1], z, 0.004);
        if (!kit_odds(b, 0.55)) continue;
        room_cover(b);
        kit_place_at(b, kit_between(b, -0.15, 0.15) * s[0], s[1] - 0.012, z, 0);
        room_hang_cloth(b, kit_between(b, 0.25, 0.6) * s[0], kit_between(b, 0.2, 0.5), kit_between(b, 0.2, 0.5));
        kit_place_at(b, 0, 0, 0, 0);
    }
}

void kit_floor_lamp(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double z = 0.5 * s[2], w = kit_between(b, 0.13, 0.2);
    const kit_moulding shade[] = { { w, s[1] - 0.28, kit_between(b, 0.4, 1) * w, s[1], 0 } };
    const int tripod = kit_odds(b, 0.4);
    room_paint(b, tripod ? r->wood : r->metal, 0.1);
    for (int i = 0; i < 3 && tripod; i++)
        room_rod(b, 0.2 * sin(2.1 * i), 0, z + 0.2 * cos(2.1 * i), 0, s[1] - 0.3, z, 0.012);
    if (!tripod) {
        kit_place_at(b, 0, 0, z, 0);
        kit_cylinder(b, 0.14, 0.025, 36);
        kit_place_at(b, 0, 0, 0, 0);
        room_rod(b, 0, 0.02, z, 0, s[1] - 0.1, z, 0.01);
    }
    room_paint(b, r->trim, 0.2);
    kit_place_at(b, 0, 0, z, 0);
    kit_turned(b, shade, 1, 40);
    kit_place_at(b, 0, 0, 0, 0);
    room_ball(b, 0, s[1] - 0.15, z, 0.045, 12);
    const double from[3] = { 0.1, 0.02, z }, to[3] = { 0.22, 0.09, 0.012 };
    kit_colour(b, 0.06, 0.06, 0.06);
    kit_cable(b, from, to, 0.035, 0.004, 6);
    room_lamp_here(r, 0, s[1] - 0.07, z);
}

/* Leaning on the wall. */
void kit_ladder(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0] - 0.03, z = s[2] - 0.03;
    room_paint(b, kit_odds(b, 0.5) ? r->wood : r->metal, 0.1);
    for (int i = -1; i <= 1; i += 2) room_rod(b, i * x, 0.01, z, i * x, s[1], 0.025, 0.02);
    for (double t = 0.12; t < 0.95; t += 0.3 / s[1])
        room_rod(b, -x, t * s[1], z + t * (0.025 - z), x, t * s[1], z + t * (0.025 - z), 0.013);
    if (!kit_odds(b, 0.3)) return;
    room_paint(b, r->cloth, 0.2);
    kit_place_at(b, 0, 0.6 * s[1] + 0.02, z + 0.6 * (0.025 - z), 0);
    room_hang_cloth(b, 1.5 * x, 0.4, 0.3);
    kit_place_at(b, 0, 0, 0, 0);
}

static void wheel(kit_build *b, double x, double z, double radius)
{
    kit_colour(b, 0.05, 0.05, 0.05);
    room_ring(b, x, radius, z, 0, 90, radius - 0.017, 0.016);
    kit_colour(b, 0.6, 0.6, 0.6);
    room_ring(b, x, radius, z, 0, 90, radius - 0.04, 0.008);
    room_rod(b, x, radius, z - 0.05, x, radius, z + 0.05, 0.014);
    for (int i = 0; i < 28; i++) {
        const double a = 2 * KIT_PI * i / 28, e = i & 1 ? 0.03 : -0.03, t = a + (i & 2 ? 0.25 : -0.25);
        room_rod(b, x + 0.02 * cos(t), radius + 0.02 * sin(t), z + e, x + (radius - 0.04) * cos(a),
                 radius + (radius - 0.04) * sin(a), z, 0.0011);
    }
}

void kit_bicycle(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double z = 0.5 * s[2], w = 0.335;
    static const double tube[][5] = { { -0.5, 0.335, -0.08, 0.3, 0.01 },  { -0.5, 0.335, -0.16, 0.82, 0.009 },
                                      { -0.08, 0.3, -0.19, 0.92, 0.016 }, { -0.16, 0.82, 0.36, 0.86, 0.017 },
                                      { -0.08, 0.3, 0.38, 0.74, 0.019 },  { 0.35, 0.95, 0.4, 0.68, 0.02 },
                                      { 0.4, 0.68, 0.53, 0.335, 0.013 },  { -0.08, 0.3, 0.02, 0.18, 0.01 },
                                      { -0.08, 0.3, -0.18, 0.42, 0.01 } };
    const double seat[3] = { 0.13, 0.03, 0.07 };
    wheel(b, -0.5, z, w);
    wheel(b, 0.53, z, w);
    room_paint(b, r->accent, 0.3);
    for (size_t i = 0; i < sizeof tube / sizeof *tube; i++)
        room_rod(b, tube[i][0], tube[i][1], z, tube[i][2], tube[i][3], z, tube[i][4]);
    kit_colour(b, 0.07, 0.07, 0.07);
    room_pillow(b, -0.2, 0.94, z, 0, 0, seat);
    room_rod(b, 0.35, 0.96, z - 0.27, 0.35, 0.96, z + 0.27, 0.012);
    room_ring(b, -0.08, 0.3, z + 0.04, 0, 90, 0.09, 0.006);
    room_rod(b, 0.02, 0.18, z + 0.03, 0.02, 0.18, z + 0.13, 0.012);
    room_rod(b, -0.18, 0.42, z - 0.12, -0.18, 0.42, z - 0.03, 0.012);
}

/* ---- >>what hangs: its lower edge at y = 0 ----------------------------------------------------------------------- */

static void picture_frame(kit_build *b, double x, double h, double w, double deep)
{
    kit_box(b, -x, 0, 0.001, x, w, deep);
    kit_box(b, -x, h - w, 0.001, x, h, deep);
    kit_box(b, -x, w, 0.001, -x + w, h - w, deep);
    kit_box(b, x - w, w, 0.001, x, h - w, deep);
}

void kit_picture(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double x = 0.5 * s[0], w = kit_between(b, 0.015, 0.05), m = kit_between(b, 0, 0.2) * x + w;
    kit_begin_object(b, "picture", -1);
    room_paint(b, kit_odds(b, 0.5) ? r->wood : r->metal, 0.3);
    picture_frame(b, x, s[1], w, s[2]);
    kit_colour(b, 0.8, 0.79, 0.74);
    kit_box(b, -x + w, w, 0.001, x - w, s[1] - w, 0.007);
    room_cover(b);
    kit_box(b, -x + m + 0.01, m + 0.01, 0.007, x - m - 0.01, s[1] - m - 0.01, 0.0085);
    room_cover(b);
    kit_box(b, -0.3 * x, m + 0.02, 0.0085, 0.5 * x, 0.5 * s[1], 0.0095);
}

void kit_mirror(kit_room *r, const double s[3])
{
    const double x = 0.5 * s[0];
    room_paint(r->b, r->wood, 0.3);
    if (kit_odds(r->b, 0.4)) {
        kit_place_tilted(r->b, 0, 0.5 * s[1], 0.002, 0, 90);
        kit_colour(r->b, 0.6, 0.62, 0.63);
        kit_cylinder(r->b, x, 0.01, 48);
        room_paint(r->b, r->metal, 0.2);
        room_ring(r->b, 0, 0.5 * s[1], 0.012, 0, 90, x, 0.012);
        return;
    }
    picture_frame(r->b, x, s[1], 0.05, s[2]);
    kit_colour(r->b, 0.6, 0.62, 0.63);
    kit_box(r->b, -x + 0.05, 0.05, 0.001, x - 0.05, s[1] - 0.05, 0.012);
}

void kit_clock(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    const double w = 0.5 * s[0];
    kit_colour(b, 0.8, 0.8, 0.76);
    kit_place_tilted(b, 0, w, 0.001, 0, 90);
    kit_cylinder(b, 0.95 * w, 0.015, 40);
    room_paint(b, r->wood, 0.3);
    room_ring(b, 0, w, 0.018, 0, 90, 0.95 * w, 0.016);
    kit_colour(b, 0.06, 0.06, 0.06);
    room_rod(b, 0, w, 0.02, 0.3 * w, 1.4 * w, 0.02, 0.004);
    room_rod(b, 0, w, 0.024, -0.6 * w, 1.2 * w, 0.024, 0.003);
    for (int i = 0; i < 12; i++)
        room_ball(b, 0.8 * w * cos(0.5236 * i), w + 0.8 * w * sin(0.5236 * i), 0.016, 0.006, 6);
}

/* A board with hooks and what hangs there. */
void kit_coats(kit_room *r, const double s[3])
{
    kit_build *b = r->b;
    room_paint(b, r->wood, 0.1);
    kit_bevelled(b, -0.5 * s[0], s[1] - 0.1, 0.001, 0.5 * s[0], s[1], 0.02, 0.004);
    for (double x = -0.5 * s[0] + 0.1; x < 0.5 * s[0] - 0.05; x += 0.17) {
        room_paint(b, r->metal, 0.1);
        room_rod(b, x, s[1] - 0.06, 0.02, x, s[1] - 0.06, 0.06, 0.006);
        room_ball(b, x, s[1] - 0.055, 0.065, 0.011, 8);
        if (kit_odds(b, 0.4)) continue;
        room_cover(b);
        kit_place_at(b, x, s[1] - 0.07, 0.1, kit_between(b, -30, 30));
        room_hang_cloth(b, kit_between(b, 0.15, 0.34), kit_between(b, 0.4, 0.85) * s[1],
                        kit_between(b, 0.3, 0.6) * s[1]);
        kit_place_at(b, 0, 0, 0, 0);
    }
}
