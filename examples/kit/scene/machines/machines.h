/* machines.h - parts of machines and of plant rooms. Private to the files of scene/ that machines.c calls.
   Unless said otherwise a thing stands on y = 0, its middle on the axis, its front towards +z. */
#ifndef KIT_MACHINES_H
#define KIT_MACHINES_H

#include "kit/kit_seed.h"

/* where the place is, to go back there */
typedef struct kit_spot {
    double at[3], turn, tilt;
} kit_spot;

kit_spot plant_spot_now(const kit_build *b);
void plant_go_back(kit_build *b, kit_spot to);
#define KIT_AT(x, y, z) \
    (const double[3]) { x, y, z }

/* ---- >>plant.c, vessels.c: what runs from one point to another, wherever the place is --------------------------- */

enum { KIT_STEEL, KIT_DARK, KIT_PAINT, KIT_PIPE, KIT_CONCRETE, KIT_RUBBER, KIT_BRASS, KIT_GOODS, KIT_PLASTIC };

void plant_stuff(kit_build *b, int stuff); /* one of its colours */
/* the place's y axis from one point towards another; how far it is */
double plant_aim(kit_build *b, const double from[3], const double to[3]);
void plant_rod(kit_build *b, const double from[3], const double to[3], double radius, int around);
void plant_beam(kit_build *b, const double from[3], const double to[3], double wide, double deep);
void plant_ibeam(kit_build *b, const double from[3], const double to[3], double size);
/* corners as elbows; flanges: with bolts at its ends and beside some elbows (at most 24 points) */
void plant_pipe(kit_build *b, const double at[][3], int count, double radius, int flanges);
void plant_flange(kit_build *b, const double at[3], const double towards[3], double radius);
/* on a pipe along x, its wheel above; upright: on one along y, its wheel towards z */
void plant_valve(kit_build *b, const double at[3], double turn, int upright, double radius);
void plant_bolt(kit_build *b, double radius, double height); /* a hexagon on the place's y = 0 */
void plant_gauge(kit_build *b, const double at[3], double turn, double radius);
void plant_hoop(kit_build *b, const double at[3], double turn, double tilt, double radius, double thick, int around);
void plant_grating(kit_build *b, double x0, double z0, double x1, double z1, double y, double pitch);
void plant_railing(kit_build *b, const double from[3], const double to[3], double height);
/* against a wall that looks towards +z */
void plant_ladder(kit_build *b, double height, int cage);
/* rising towards +z from the origin, with rails */
void plant_steps(kit_build *b, double wide, double height, double run);
void plant_duct(kit_build *b, const double from[3], const double to[3], double wide, double high);
/* level; high 0: round */
void plant_fan(kit_build *b, double radius, int blades); /* about the origin, towards +z */
void plant_wires(kit_build *b, double wide, double high, double pitch, double radius); /* in x and y */
void plant_perforated(kit_build *b, double wide, double high, int nx, int ny);         /* no thickness */
void plant_links(kit_build *b, const double from[3], double length, double link);
void plant_tank(kit_build *b, double radius, double height, double legs);
void plant_lying_tank(kit_build *b, double radius, double length, double legs); /* along x */
void plant_standing_tank(kit_build *b);                                         /* as chance has it */
void plant_resting_tank(kit_build *b);
void plant_column(kit_build *b); /* tall, with pipes and a ladder */
void plant_ball_tank(kit_build *b);

/* ---- >>gears.c, board.c: assemblies seen close ------------------------------------------------------------------ */

/* lying on y = 0, its teeth turned by twist radians over its height */
void plant_gear(kit_build *b, double radius, int teeth, double height, double twist);
void plant_train(kit_build *b);       /* gears that mesh between plates: 2 m wide */
void plant_gearbox(kit_build *b);     /* open in front: shafts and gears */
void plant_coupling(kit_build *b);    /* shaft, bearings, pulleys, coupling on a bed plate */
void plant_board(kit_build *b);       /* a circuit board, 2.4 m wide */
void plant_star_engine(kit_build *b); /* cylinders about a shaft */
void plant_stack(kit_build *b);       /* flanges, springs, rings, exploded along a line */

/* ---- >>works.c -------------------------------------------------------------------------------------------------- */

/* A closed room about the origin: sides along x and z, height; walls 0 panels, 1 corrugated, 2 piers, 3 steel posts,
   4 blocks, 5 plain; roof 0 beams, 1 trusses, 2 tiles, 3 ribs. */
typedef struct kit_hall {
    double w, d, h;
    int walls, roof;
} kit_hall;

void plant_build_hall(kit_plot *p, const kit_hall *r); /* and where one may stand */
void plant_floor_clutter(kit_plot *p, int count);      /* buckets, cones, hoses, sacks, cables */

/* ---- >>studio.c: whole scenes ----------------------------------------------------------------------------------- */

kit_kind_make kit_make_studio, kit_make_passage;

/* ---- >>shop.c, stores.c: machines and what stands about them ---------------------------------------------------- */

void plant_motor(kit_build *b, double radius, double length); /* along x, its axis the place's frame's */
void plant_pump(kit_build *b);
void plant_lathe(kit_build *b);
void plant_pillar_drill(kit_build *b);
void plant_bench(kit_build *b);
void plant_tool_board(kit_build *b); /* hangs on the plane z = 0, its middle the origin */
void plant_shelving(kit_build *b);
void plant_cabinet(kit_build *b);
void plant_desk(kit_build *b);
void plant_rack(kit_build *b);
void plant_robot(kit_build *b);
void plant_conveyor(kit_build *b, double length); /* along x */
void plant_pallet(kit_build *b);
void plant_engine(kit_build *b);
void plant_boiler(kit_build *b);
void plant_air_handler(kit_build *b);
void plant_barrels(kit_build *b);
void plant_hose_reel(kit_build *b); /* hangs on the plane z = 0 */
void plant_stepladder(kit_build *b);

#endif
