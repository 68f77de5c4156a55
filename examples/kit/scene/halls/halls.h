/* halls.h - what the scenes of halls by seed are built of. Private to halls.c, plans.c, decks.c,
   works.c (columns, arches), vaults.c (roofs, stairs, rails), parts.c (what is thin or hangs),
   things.c (what stands in them) and uses.c (walls' bays, furnishing). */
#ifndef KIT_HALLS_H
#define KIT_HALLS_H

#include "kit/kit_seed.h"

/* materials of a hall, drawn once */
enum {
    HALL_STONE,
    HALL_WALL,
    HALL_TRIM,
    HALL_FLOOR,
    HALL_TILE,
    HALL_WOOD,
    HALL_METAL,
    HALL_CLOTH,
    HALL_SECOND,
    HALL_GLASS,
    HALL_VAULT,
    HALL_PAINTS
};

enum {
    HALL_DORIC,
    HALL_LEAFED,
    HALL_FLUTED,
    HALL_PIER,
    HALL_CLUSTER,
    HALL_IRON,
    HALL_EIGHT,
    HALL_PLAIN,
    HALL_TWISTED,
    HALL_COLUMNS
};

enum { HALL_STONE_RAIL, HALL_IRON_RAIL, HALL_GLASS_RAIL, HALL_WOOD_RAIL, HALL_CROSS_RAIL, HALL_RAILS };

enum { HALL_BARREL, HALL_GROIN, HALL_COFFERS, HALL_BEAMS, HALL_TRUSSES, HALL_SKYLIGHT, HALL_CEILINGS };

enum {
    HALL_PEWS,
    HALL_MUSEUM,
    HALL_MARKET,
    HALL_STATION,
    HALL_READING,
    HALL_STORE,
    HALL_BANQUET,
    HALL_BARE,
    HALL_FURNISHINGS
};

enum { HALL_BLANK, HALL_WINDOW, HALL_NICHE, HALL_PICTURE, HALL_BOOKS, HALL_RELIEF, HALL_DOOR, HALL_BAYS };

typedef struct hall {
    kit_plot *p;
    kit_build *b;
    float paint[HALL_PAINTS][3];
    int column, rail, ceiling, pointed, ribs, floor;
    unsigned noise;
    double top; /* how high the ceiling is: where chains end */
} hall;

/* A wall panel across x, from -width / 2, on y = 0, about z = 0, with an opening: half wide to either side, from sill
   up to spring, then an arch of rise. back: has a back, too. */
typedef struct hall_panel {
    double width, height, thick, half, sill, spring, rise;
    int pointed, cells, back;
} hall_panel;

/* ---- >>works.c: all at the frame's origin, places are set back to it --------------------------------------- */

void hall_paint(hall *h, int which);                                  /* varied a little */
void hall_sight(hall *h, double x, double y, double z, double reach); /* local coordinates */
void hall_lamp(hall *h, double x, double y, double z);
void hall_overview(hall *h, const double r[4], double high); /* sights along the middle of a space */
/* where one may stand */
void hall_stand(hall *h, double x0, double z0, double x1, double z1, double ceiling);
double hall_arch(int pointed, double q); /* 0 at q = -1 and 1, 1 in the middle */
void hall_bar(kit_build *b, const double from[3], const double to[3], double wide, double deep);
void hall_column(hall *h, int kind, double radius, double height);
void hall_wall(hall *h, const hall_panel *panel);
void hall_archivolt(hall *h, const hall_panel *panel, double wide, double proud);
void hall_glaze(hall *h, const hall_panel *panel, int upright, int across);
/* ---- >>vaults.c -------------------------------------------------------------------------------------------- */

/* along x from 0, its edges on y = 0 */
void hall_barrel(kit_build *b, double length, double half, double rise, int pointed, int cells);
void hall_rib(kit_build *b, double half, double rise, int pointed, double wide, double deep);
void hall_groin(hall *h, double half_x, double half_z, double rise);
void hall_stairs(hall *h, double width, int steps, double rise, double run);
/* along x from 0, climbing */
void hall_rail(hall *h, int kind, double length, double climb);
/* over x0, z0, x1, z1 at height y; bays along x */
void hall_roof(hall *h, int kind, const double r[4], double y, int bays);
void hall_floor(hall *h, const double r[4]);
/* looks inwards; top: has one */
void hall_shell(hall *h, const double r[4], double low, double high, int top);

/* ---- >>parts.c ---------------------------------------------------------------------------------------------- */

void hall_banner(hall *h, double width, double length);          /* hangs from y = 0 */
void hall_drape(hall *h, double span, double width, double sag); /* along x from 0, hung at both ends */
void hall_chain(hall *h, double length, double size);            /* up from y = 0 */
void hall_chandelier(hall *h, double radius, double chain);
void hall_pendant(hall *h, double radius, double chain);
void hall_vase(hall *h, double height);
void hall_statue(hall *h, double height);
void hall_bust(hall *h, double height);
void hall_plant(hall *h, double height);
void hall_relief(hall *h, double width, double height); /* on a wall, looks along z */
void hall_picture(hall *h, double width, double height);
void hall_barrier(hall *h, double length); /* posts and ropes along x from 0 */
void hall_candles(hall *h, double height);

/* ---- >>things.c --------------------------------------------------------------------------------------------- */

void hall_bench(hall *h, double length, int back);
void hall_chair(hall *h);
void hall_table(hall *h, double length, double width);
void hall_bookcase(hall *h, double width, double height);
void hall_stall(hall *h);
void hall_rack(hall *h, double length, double height);
void hall_car(hall *h);
void hall_crates(hall *h);
void hall_plinth(hall *h, double width, double height);
/* ---- >>uses.c ---------------------------------------------------------------------------------------------- */

/* a bay of a wall with what belongs to it, looks along z */
void hall_bay(hall *h, int kind, double width, double height);
/* a bay of another kind for every so many-th */
void hall_bays(hall *h, int main, int other, int count, double length, double height);
void hall_four_walls(hall *h, const double r[4], double height, double bay, int main, int other);
void hall_furnish(hall *h, int kind, const double r[4]);

/* ---- >>plans.c ---------------------------------------------------------------------------------------------- */

void hall_theatre(hall *h);
void hall_stair_hall(hall *h);
void hall_rotunda(hall *h);
void hall_parking(hall *h); /* decks.c */
void hall_temple(hall *h);

#endif
