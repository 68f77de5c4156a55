/* machines.c - scenes by seed of this kind: plant rooms, workshops, server rooms, lines, corridors, assemblies.
   Declared in kit_seed.h. */
#include "kit/scene/machines/machines.h"
#include <math.h>
#include <string.h>

/* ---- >>placing ------------------------------------------------------------------------------------------------- */

typedef void make(kit_build *b);

/* A thing at a place, and something to look at: reach about a middle so high. as: chances of its own, the same for
   things alike; 0: as they come. */
static void put(kit_plot *p, const char *name, make *thing, const double at[3], double turn, double reach, uint32_t as)
{
    kit_build *b = &p->b;
    kit_chances before_it;
    if (as) kit_alike(b, as, &before_it);
    kit_begin_object(b, name, -1);
    const kit_frame before = kit_enter(b, at[0], at[1], at[2], turn, 1);
    thing(b);
    kit_leave(b, before);
    if (as) kit_resume(b, &before_it);
    kit_add_sight(p, at[0], at[1] + 0.7 * reach, at[2], reach);
}

static void put_pipe(kit_plot *p, const double at[][3], int count, double radius)
{
    kit_begin_object(&p->b, "pipe", -1);
    plant_stuff(&p->b, KIT_PIPE);
    plant_pipe(&p->b, at, count, radius, 1);
}

typedef struct ware {
    const char *name;
    make *thing;
    double reach;
} ware;

static void put_ware(kit_plot *p, const ware *of, double x, double z, double turn, uint32_t as)
{
    put(p, of->name, of->thing, KIT_AT(x, 0, z), turn, of->reach, as);
}

static const ware small[] = { { "pallet", plant_pallet, 0.7 },         { "barrels", plant_barrels, 0.7 },
                              { "stepladder", plant_stepladder, 0.9 }, { "cabinet", plant_cabinet, 0.9 },
                              { "shelving", plant_shelving, 1 },       { "bench", plant_bench, 0.9 } };

/* Things along the walls: cabinets, shelves, benches; here and there a gap. */
static void along_walls(kit_plot *p, const kit_hall *r, const ware *of, int count, double dense)
{
    kit_build *b = &p->b;
    for (int side = 0; side < 4; side++) {
        const double half = 0.5 * (side & 1 ? r->d : r->w), off = 0.5 * (side & 1 ? r->w : r->d) - 0.72;
        for (double t = 1.3 - half; t < half - 1.2; t += kit_between(b, 2.2, 3)) {
            const double x = side == 1 ? -off
                           : side == 3 ? off
                           : side      ? -t
                                       : t,
                         z = side == 0 ? -off
                           : side == 2 ? off
                           : side == 1 ? -t
                                       : t;
            if (!kit_odds(b, dense)) continue;
            put_ware(p, &of[kit_choose(b, count)], x, z, 90.0 * side + kit_between(b, -2, 2), 0);
        }
    }
}

/* Pipes side by side below the ceiling, along x, some going down at the far wall. */
static void overhead_pipes(kit_plot *p, const kit_hall *r, double z, double y, int count)
{
    kit_build *b = &p->b;
    const double w = 0.5 * r->w - 0.12;
    double at = z;
    for (int k = 0; k < count; k++) {
        const double radius = kit_between(b, 0.03, 0.11), drop = kit_between(b, 0.25, w),
                     low = kit_between(b, 0.3, 1.2), back = (z > 0 ? 0.5 : -0.5) * r->d * 0.93;
        const double through[2][3] = { { -w, y + radius, at }, { w, y + radius, at } };
        const double down[5][3] = { { -w, y + radius, at },
                                    { drop, y + radius, at },
                                    { drop, y + radius, back },
                                    { drop, low, back },
                                    { drop, low - 0.2, back } };
        const int straight = kit_odds(b, 0.55);
        put_pipe(p, straight ? through : down, straight ? 2 : 4, radius);
        at += 2.6 * radius + 0.1;
    }
    kit_begin_object(b, "pipe rack", -1);
    plant_stuff(b, KIT_STEEL);
    for (double x = 0.6 - w; x < w; x += 2.2) {
        plant_beam(b, KIT_AT(x, y - 0.03, z - 0.15), KIT_AT(x, y - 0.03, at), 0.06, 0.06);
        for (int s = 0; s < 2; s++)
            plant_rod(b, KIT_AT(x, y - 0.03, s ? at : z - 0.15), KIT_AT(x, r->h, s ? at : z - 0.15), 0.01, 6);
    }
    kit_add_sight(p, kit_between(b, -0.5, 0.5) * w, y, z, 0.8);
}

static void overhead_duct(kit_plot *p, const kit_hall *r, double z, double y)
{
    kit_build *b = &p->b;
    const double w = 0.5 * r->w - 0.02, wide = kit_between(b, 0.4, 0.9),
                 high = kit_odds(b, 0.5) ? kit_between(b, 0.3, 0.5) : 0;
    const double side = z > 0 ? -1 : 1, reach = 0.5 * r->d - fabs(z), tall = high > 0 ? high : wide;
    kit_begin_object(b, "duct", -1);
    plant_stuff(b, KIT_STEEL);
    plant_duct(b, KIT_AT(-w, y, z), KIT_AT(w, y, z), wide, high);
    for (double x = 1.2 - w; x < w - 0.6; x += 2.8) {
        plant_duct(b, KIT_AT(x, y, z), KIT_AT(x, y, z + side * fmin(1.6, reach)), 0.6 * wide, 0.7 * high);
        plant_duct(b, KIT_AT(x + 1.1, y - 0.45 * tall, z), KIT_AT(x + 1.1, y - 0.5 * tall - 0.25, z), 0.36,
                   high > 0 ? 0.36 : 0);
        plant_rod(b, KIT_AT(x + 0.5, y, z + 0.5 * wide + 0.04), KIT_AT(x + 0.5, r->h, z + 0.5 * wide + 0.04), 0.008, 6);
        plant_rod(b, KIT_AT(x + 0.5, y, z - 0.5 * wide - 0.04), KIT_AT(x + 0.5, r->h, z - 0.5 * wide - 0.04), 0.008, 6);
    }
    kit_add_sight(p, 0, y, z, 1);
}

/* A walkway at height y along x with rails, posts, a ladder or steps. */
static void catwalk(kit_plot *p, double x0, double x1, double z, double y, int ways)
{
    kit_build *b = &p->b;
    const double wide = kit_between(b, 0.8, 1.2), z1 = z + wide;
    kit_begin_object(b, "catwalk", -1);
    plant_stuff(b, KIT_STEEL);
    kit_place_at(b, 0, 0, 0, 0);
    plant_grating(b, x0, z, x1, z1, y, 0.05);
    for (double x = x0; x <= x1 + 0.1; x += (x1 - x0) / fmax(2, floor((x1 - x0) / 2.5)))
        for (int s = 0; s < 2; s++) plant_ibeam(b, KIT_AT(x, 0.002, s ? z1 : z), KIT_AT(x, y - 0.14, s ? z1 : z), 0.1);
    for (int s = 0; s < 2; s++) plant_ibeam(b, KIT_AT(x0, y - 0.09, s ? z1 : z), KIT_AT(x1, y - 0.09, s ? z1 : z), 0.1);
    kit_begin_object(b, "railing", -1);
    plant_stuff(b, KIT_PAINT);
    plant_railing(b, KIT_AT(x0, y, z), KIT_AT(x1, y, z), 1.05);
    plant_railing(b, KIT_AT(x0 + 1, y, z1), KIT_AT(x1, y, z1), 1.05);
    kit_begin_object(b, ways ? "ladder" : "steps", -1);
    const kit_frame before = ways ? kit_enter(b, x0 + 0.5, 0, z1, 0, 1)
                                  : kit_enter(b, x0 + 0.5, 0, z1 + 0.05 + y * 0.9, 180, 1);
    if (ways) plant_ladder(b, y, y > 2.8);
    else plant_steps(b, 0.8, y, 0.9 * y);
    kit_leave(b, before);
    kit_add_sight(p, x0 + 0.5, 0.7 * y, z1 + 0.3, 1.2);
    kit_add_sight(p, 0.5 * (x0 + x1), y + 0.3, z + 0.5 * wide, 1.1);
}

/* ---- >>layouts: rooms -------------------------------------------------------------------------------------------- */

static const ware plant[] = { { "pump", plant_pump, 1 },
                              { "air handler", plant_air_handler, 1.1 },
                              { "tank", plant_standing_tank, 1.3 },
                              { "tank", plant_resting_tank, 1.2 },
                              { "engine", plant_engine, 1.3 },
                              { "motor pump", plant_pump, 0.9 } };

static void plant_room(kit_plot *p)
{
    kit_build *b = &p->b;
    const kit_hall r = { kit_between(b, 8, 13), kit_between(b, 6.5, 10), kit_between(b, 3.4, 4.8), kit_choose(b, 6),
                         kit_choose(b, 4) };
    const int count = (int)((r.w - 2) / 2.6);
    plant_build_hall(p, &r);
    const ware *first = &plant[kit_choose(b, 4)], *second = &plant[kit_choose(b, 6)];
    const uint32_t as = kit_draw_seed(b);
    for (int k = 0; k < count; k++) {
        const double x = (k - 0.5 * (count - 1)) * 2.6;
        put_ware(p, first, x, 0.12 * r.d, 0, kit_odds(b, 0.75) ? as : 0);
        if (kit_odds(b, 0.7)) put_ware(p, second, x, 1.4 - 0.5 * r.d, 0, kit_odds(b, 0.5) ? as : 0);
    }
    overhead_pipes(p, &r, 0.12 * r.d - 0.3, 2.35, 2 + kit_choose(b, 4));
    if (kit_odds(b, 0.7)) overhead_duct(p, &r, -0.2 * r.d, r.h - 0.7);
    along_walls(p, &r, small, 5, 0.5);
}

static const ware shop_things[] = { { "lathe", plant_lathe, 1 },
                                    { "lathe", plant_lathe, 0.8 },
                                    { "pillar drill", plant_pillar_drill, 0.9 },
                                    { "bench", plant_bench, 0.8 },
                                    { "gearbox", plant_gearbox, 0.8 } };

static void workshop(kit_plot *p)
{
    kit_build *b = &p->b;
    const kit_hall r = { kit_between(b, 8, 13), kit_between(b, 6.5, 9.5), kit_between(b, 3.2, 5.5), kit_choose(b, 6),
                         kit_choose(b, 4) };
    static const ware beside[] = { { "bench", plant_bench, 0.7 },
                                   { "shelving", plant_shelving, 1 },
                                   { "cabinet", plant_cabinet, 0.9 },
                                   { "bench", plant_bench, 0.5 },
                                   { "barrels", plant_barrels, 0.6 } };
    plant_build_hall(p, &r);
    const int rows = 2 + kit_choose(b, 2);
    for (int k = 0; k < rows; k++)
        for (double x = 2.2 - 0.5 * r.w; x < 0.5 * r.w - 1.8; x += kit_between(b, 2.5, 3.2))
            put_ware(p, &shop_things[kit_choose(b, 5)], x, (k - 0.7) * 2.3,
                     kit_odds(b, 0.7) ? 0 : kit_between(b, 60, 120), 0);
    along_walls(p, &r, beside, 5, 0.85);
    for (int k = 0; k < 3; k++)
        put(p, "tool board", plant_tool_board, KIT_AT((0.3 * k - 0.3) * r.w, 1.75, 0.2 - 0.5 * r.d), 0, 0.6, 0);
    put(p, "hose reel", plant_hose_reel, KIT_AT(0.2 - 0.5 * r.w, 1.8, kit_between(b, -0.3, 0.3) * r.d), 90, 0.4, 0);
    kit_begin_object(b, "hoist", -1);
    plant_stuff(b, KIT_PAINT);
    const double y = r.h - 1, x = kit_between(b, -2, 2);
    plant_ibeam(b, KIT_AT(x, y, -0.5 * r.d), KIT_AT(x, y, 0.5 * r.d), 0.25);
    plant_rod(b, KIT_AT(x - 0.2, y - 0.3, 0.5), KIT_AT(x + 0.2, y - 0.3, 0.5), 0.15, 24);
    plant_stuff(b, KIT_STEEL);
    plant_links(b, KIT_AT(x, y - 0.42, 0.5), kit_between(b, 0.6, 1.2), 0.07);
    plant_links(b, KIT_AT(x + 0.1, y - 0.42, 0.5), y - 1.2, 0.04);
    kit_add_sight(p, x, y - 0.6, 0.5, 0.6);
}

static void cable_tray(kit_plot *p, double x0, double x1, double z, double y)
{
    kit_build *b = &p->b;
    kit_begin_object(b, "cable tray", -1);
    plant_stuff(b, KIT_STEEL);
    kit_place_at(b, 0, 0, 0, 0);
    for (int s = -1; s < 2; s += 2) kit_box(b, x0, y, z + 0.2 * s - 0.006, x1, y + 0.08, z + 0.2 * s + 0.006);
    for (double x = x0 + 0.1; x < x1; x += 0.3) kit_box(b, x, y + 0.005, z - 0.194, x + 0.03, y + 0.015, z + 0.194);
    for (int k = 0; k < 14; k++) {
        double at[12][3];
        const double lane = kit_between(b, -0.17, 0.17);
        plant_stuff(b, KIT_PLASTIC);
        for (int i = 0; i < 12; i++) {
            at[i][0] = x0 + (x1 - x0) * i / 11;
            at[i][1] = y + 0.03 + 0.012 * (k % 4) + 0.004 * sin(2.0 * i + k);
            at[i][2] = z + lane + 0.02 * sin(1.3 * i + 2 * k);
        }
        kit_place_at(b, 0, 0, 0, 0);
        kit_tube(b, (const double(*)[3])at, 12, kit_between(b, 0.006, 0.016), 6);
        if (kit_odds(b, 0.6))
            kit_cable(b, KIT_AT(at[5][0] + 0.1 * k, y + 0.05, z + 0.19), KIT_AT(at[5][0] + 0.1 * k, 2.09, z + 0.45),
                      0.12, 0.008, 6);
    }
    kit_add_sight(p, 0.5 * (x0 + x1), y, z, 0.6);
}

static void server_room(kit_plot *p)
{
    kit_build *b = &p->b;
    const int rows = 2 + kit_choose(b, 2), each = 4 + kit_choose(b, 4), gaps = kit_odds(b, 0.4);
    const kit_hall r = { 0.6 * each + 3.6, 2.3 * rows + 1.8, kit_between(b, 2.7, 3.4), kit_odds(b, 0.6) ? 0 : 5,
                         kit_odds(b, 0.6) ? 2 : 3 };
    plant_build_hall(p, &r);
    kit_begin_object(b, "floor tiles", 0);
    for (double x = -0.5 * r.w; x < 0.5 * r.w - 0.3; x += 0.6)
        for (double z = -0.5 * r.d; z < 0.5 * r.d - 0.3; z += 0.6) {
            kit_colour(b, 0.55, 0.56, 0.57);
            kit_place_at(b, x + 0.3, 0.012, z, 0);
            if (kit_odds(b, 0.9)) {
                kit_box(b, -0.296, -0.01, 0.004, 0.296, 0, 0.596);
                continue;
            }
            kit_place_tilted(b, x + 0.3, 0.012, z, 0, 90);
            plant_perforated(b, 0.592, 0.592, 10, 10);
        }
    for (int k = 0; k < rows; k++) {
        const double z = (k - 0.5 * (rows - 1)) * 2.3;
        for (int i = 0; i < each; i++)
            if (!gaps || kit_odds(b, 0.8))
                put(p, "rack", plant_rack, KIT_AT(0.6 * (i - 0.5 * (each - 1)), 0.013, z), k & 1 ? 180 : 0,
                    i % 3 ? 0.6 : 1, 0);
        cable_tray(p, 0.05 - 0.5 * r.w, 0.5 * r.w - 0.05, z - 0.1, 2.3);
    }
    put_ware(p, &(ware){ "air handler", plant_air_handler, 1 }, 0.8 - 0.5 * r.w, 0, 90, 0);
    put_ware(p, &(ware){ "desk", plant_desk, 0.9 }, 0.5 * r.w - 0.7, 0, -90, 0);
    if (kit_odds(b, 0.5)) put_ware(p, &(ware){ "stepladder", plant_stepladder, 0.9 }, 0, 1.1, 30, 0);
}

/* ---- >>layouts: halls -------------------------------------------------------------------------------------------- */

static void process_hall(kit_plot *p)
{
    static const ware tall[] = { { "column", plant_column, 2.6 },
                                 { "ball", plant_ball_tank, 1.9 },
                                 { "column", plant_column, 1.6 },
                                 { "tank", plant_resting_tank, 1.2 },
                                 { "tank", plant_standing_tank, 1.2 } };
    kit_build *b = &p->b;
    const kit_hall r = { kit_between(b, 16, 24), kit_between(b, 13, 18), kit_between(b, 9.5, 13), 1 + kit_choose(b, 3),
                         kit_odds(b, 0.7) ? 1 : 3 };
    const double y = kit_between(b, 2.4, 4);
    plant_build_hall(p, &r);
    for (double x = 3 - 0.5 * r.w; x < 0.5 * r.w - 2.5; x += kit_between(b, 3.4, 4.6))
        for (int row = 0; row < 2; row++) {
            const double z = row ? 0.22 * r.d : -0.3 * r.d;
            put_ware(p, &tall[kit_choose(b, 5)], x + kit_between(b, -0.3, 0.3), z, kit_between(b, -40, 40), 0);
        }
    catwalk(p, 1 - 0.5 * r.w, 0.5 * r.w - 1, -0.6, y, kit_odds(b, 0.5));
    overhead_pipes(p, &r, -2.2, y + 0.5, 3 + kit_choose(b, 4));
    overhead_pipes(p, &r, 1.4, y + kit_between(b, 0.2, 2), 2 + kit_choose(b, 4));
    for (int k = 0; k < 5; k++)
        put_ware(p, &plant[kit_odds(b, 0.7) ? 0 : 1], kit_between(b, -0.38, 0.38) * r.w, 0.4 * r.d, 180, 0);
    along_walls(p, &r, small, 4, 0.3);
}

static void fence(kit_build *b)
{
    plant_stuff(b, KIT_PAINT);
    for (int s = -1; s < 2; s += 2) plant_beam(b, KIT_AT(0.98 * s, 0.002, 0), KIT_AT(0.98 * s, 2, 0), 0.05, 0.05);
    plant_beam(b, KIT_AT(-0.95, 1.95, 0), KIT_AT(0.95, 1.95, 0), 0.03, 0.03);
    plant_beam(b, KIT_AT(-0.95, 0.2, 0), KIT_AT(0.95, 0.2, 0), 0.03, 0.03);
    plant_stuff(b, KIT_DARK);
    kit_place_at(b, 0, 0.2, 0, 0);
    plant_wires(b, 1.9, 1.75, 0.06, 0.0025);
}

static void long_conveyor(kit_build *b) { plant_conveyor(b, 9); }

static void short_conveyor(kit_build *b) { plant_conveyor(b, 3); }

static void line_hall(kit_plot *p)
{
    kit_build *b = &p->b;
    const kit_hall r = { kit_between(b, 12, 18), kit_between(b, 9, 13), kit_between(b, 4.5, 7), kit_choose(b, 4),
                         kit_odds(b, 0.6) ? 1 : kit_choose(b, 4) };
    const int lines = 1 + kit_choose(b, 2);
    const uint32_t as = kit_draw_seed(b);
    plant_build_hall(p, &r);
    for (int k = 0; k < lines; k++) {
        const double z = lines > 1 ? 3.4 * k - 1.7 : 0;
        put(p, "conveyor", long_conveyor, KIT_AT(0, 0, z), 0, 1.2, 0);
        kit_add_sight(p, -2.5, 0.8, z, 0.7);
        kit_add_sight(p, 2.5, 0.8, z, 0.7);
        put(p, "conveyor", short_conveyor, KIT_AT(kit_odds(b, 0.5) ? 5.1 : -5.1, 0, z + 1.2), 90, 1, 0);
        for (int i = 0; i < 4; i++) {
            const double x = -3.6 + 2.4 * i + kit_between(b, -0.3, 0.3), side = i & 1 ? 1 : -1;
            if (kit_odds(b, 0.8))
                put(p, "robot", plant_robot, KIT_AT(x, 0, z + 1.3 * side),
                    side > 0 ? 180 + kit_between(b, -40, 40) : kit_between(b, -40, 40), 1.2,
                    as + (uint32_t)kit_choose(b, 4) * 2);
        }
    }
    if (kit_odds(b, 0.75))
        for (double x = -4; x < 4.5; x += 2.01) put(p, "fence", fence, KIT_AT(x, 0, 0.36 * r.d), 0, 0.9, as);
    put_ware(p, &(ware){ "desk", plant_desk, 0.9 }, kit_between(b, -3, 3), 0.42 * r.d, 180, 0);
    along_walls(p, &r, small, 5, 0.6);
    overhead_duct(p, &r, kit_between(b, -0.3, 0.3) * r.d, r.h - 1.5);
    if (kit_odds(b, 0.6)) catwalk(p, 0.8 - 0.5 * r.w, 0.5 * r.w - 0.8, 0.4 - 0.5 * r.d, kit_between(b, 2.4, 2.9), 0);
    for (int k = 0; k < 4; k++)
        put_ware(p, &small[0], kit_between(b, -0.4, 0.4) * r.w, kit_between(b, 0.24, 0.3) * r.d,
                 kit_between(b, -30, 30), 0);
}

static void boiler_hall(kit_plot *p)
{
    kit_build *b = &p->b;
    const int boilers = 2 + kit_choose(b, 2), engines = kit_odds(b, 0.5);
    const kit_hall r = { 3.4 * boilers + 4, kit_between(b, 9, 12), kit_between(b, 5, 7), kit_choose(b, 5),
                         kit_choose(b, 4) };
    const uint32_t as = kit_draw_seed(b);
    plant_build_hall(p, &r);
    for (int k = 0; k < boilers; k++) {
        const double x = 3.3 * (k - 0.5 * (boilers - 1));
        put(p, engines ? "engine" : "boiler", engines ? plant_engine : plant_boiler, KIT_AT(x, 0, -0.8),
            engines ? 90 : 0, 1.6, as);
        kit_add_sight(p, x, 1.4, 1, 0.6);
        put_ware(p, &plant[kit_choose(b, 4)], x, 0.34 * r.d, 180, 0);
    }
    catwalk(p, 0.9 - 0.5 * r.w, 0.5 * r.w - 0.9, 0.35 - 0.5 * r.d, kit_between(b, 2.4, 3), 1);
    overhead_pipes(p, &r, -1.6, r.h - 1.7, 3 + kit_choose(b, 3));
    overhead_duct(p, &r, 1.5, r.h - 0.8);
    along_walls(p, &r, small, 4, 0.4);
}

void kit_make_machine(kit_plot *p)
{
    static kit_kind_make *const layouts[] = { plant_room,  workshop,        server_room,      process_hall,   line_hall,
                                              boiler_hall, kit_make_studio, kit_make_passage, kit_make_studio };
    const int layout = kit_choose(&p->b, sizeof layouts / sizeof *layouts), tidy = kit_odds(&p->b, 0.35);
    layouts[layout](p);
    if (layouts[layout] != kit_make_passage) plant_floor_clutter(p, tidy ? 3 : 8 + kit_choose(&p->b, 10));
}
