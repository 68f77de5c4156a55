/* rooms.h - what rooms.c, space.c, plants.c, shell.c, fittings.c, furniture.c, lounge.c, stations.c, cloth.c, clutter.c
   and shelves.c share: rooms being furnished. Private to them. */
#ifndef KIT_ROOMS_H
#define KIT_ROOMS_H

#include "kit/kit_seed.h"

/* ---- >>room ----------------------------------------------------------------------------------------------------- */

/* What lies about: in homes, kitchens, offices, workshops, bathrooms, nurseries. */
enum { KIT_HOME = 1, KIT_KITCHEN = 2, KIT_OFFICE = 4, KIT_SHOP = 8, KIT_BATH = 16, KIT_NURSERY = 32 };

enum { KIT_CLAIMS = 400 };

typedef struct kit_block {
    double low[3], high[3];
} kit_block;

/* A room about the origin: floor at y = 0, walls at +-size[0] / 2 and +-size[2] / 2, size[1] high. Its own materials;
   claim: the space that is taken. */
typedef struct kit_room {
    kit_plot *p;
    kit_build *b;
    double size[3];
    float wood[3], trim[3], metal[3], cloth[3], accent[3];
    int theme, chair, table, claims;
    double clutter; /* 0: tidy, 1: full */
    kit_block claim[KIT_CLAIMS];
} kit_room;

/* A piece of furniture: x across, y up from 0, z from 0, the wall, to its front; so wide, high and deep. */
typedef void room_piece(kit_room *r, const double s[3]);

/* ---- >>cloth.c: helpers, which leave the place at the frame's origin --------------------------------------------- */

void room_paint(kit_build *b, const float colour[3], double vary);
void room_cover(kit_build *b); /* the colour of a book, a box, a toy */
void room_rod(kit_build *b, double x0, double y0, double z0, double x1, double y1, double z1, double radius);
void room_ball(kit_build *b, double x, double y, double z, double radius, int cells);
void room_ring(kit_build *b, double x, double y, double z, double turn, double tilt, double radius, double tube);
/* an open vessel with an inside, its foot at y */
void room_vessel(kit_build *b, double x, double y, double z, double foot, double rim, double height, double bulge);
void room_pillow(kit_build *b, double x, double y, double z, double turn, double tilt, const double half[3]);
/* a lamp at a place of the frame */
void room_lamp_here(kit_room *r, double x, double y, double z);
void room_sight_here(kit_room *r, double x, double y, double z, double reach);
/* cloth: a sheet through points, normals by differences */
typedef void room_cloth_point(const double *of, double u, double v, double p[3]);
void room_cloth(kit_build *b, int nu, int nv, room_cloth_point *point, const double *of);
/* a cloth over a bar along x at the origin: so wide, hanging down so far before and behind */
void room_hang_cloth(kit_build *b, double width, double before, double behind);

/* ---- >>clutter.c, shelves.c -------------------------------------------------------------------------------------- */

/* things upon a rectangle at height y, no higher than high */
void room_clutter(kit_room *r, double x0, double z0, double x1, double z1, double y, double high, double share);
/* a shelf's board from the origin, x to width, z to depth, with what stands on it */
void room_fill_shelf(kit_room *r, double width, double depth, double high);
void room_plant(kit_room *r, double height);
room_piece kit_boxes_piece, kit_plant_piece, kit_toys_piece;

/* ---- >>furniture.c, lounge.c, stations.c ------------------------------------------------------------------------- */

void room_chair(kit_room *r, int style);                    /* its middle on the origin, looking to +z */
void room_table(kit_room *r, const double s[3], int style); /* its middle on the origin */

enum { KIT_CHAIRS = 8, KIT_TABLES = 5 };

room_piece kit_bookcase, kit_cabinet, kit_drawers, kit_steel_shelf, kit_dining, kit_small_table, kit_stool_piece,
    kit_wall_shelf, kit_railing;
room_piece kit_sofa, kit_lounge, kit_bed, kit_armchair, kit_screen_stand, kit_fireplace, kit_piano, kit_clothes_rack,
    kit_airer, kit_floor_lamp, kit_ladder, kit_bicycle, kit_cot, kit_picture, kit_mirror, kit_clock, kit_coats, kit_rug;
room_piece kit_desk, kit_kitchen, kit_fridge, kit_island, kit_workbench, kit_pegboard, kit_bath, kit_basin, kit_toilet,
    kit_towels, kit_washer, kit_tool_rail, kit_easel;

/* ---- >>fittings.c: in a wall's frame, x along it, z into the room ------------------------------------------------ */

/* An opening in a wall. */
typedef struct kit_opening {
    double x0, x1, y0, y1;
    int door;
} kit_opening;

void room_window(kit_room *r, const kit_opening *o, double thick);
void room_door(kit_room *r, const kit_opening *o, double thick, double open);
void room_corridor(kit_room *r, const kit_opening *o, double thick);
void room_radiator(kit_room *r, double x0, double x1, double top);
void room_pendant(kit_room *r, double drop); /* hangs from the origin */
void room_ceiling_things(kit_room *r);

/* ---- >>rooms.c --------------------------------------------------------------------------------------------------- */

/* Takes a space, unless some of it is taken. */
int room_claim_space(kit_room *r, const kit_block *c, int anyway);
/* a box of a frame turned by quarters, at (x, z) */
kit_block room_quarter_block(double x, double z, int quarter, const double low[3], const double high[3]);

/* ---- >>shell.c --------------------------------------------------------------------------------------------------- */

/* Floor, walls with windows and doors, ceiling or slopes, what is outside; claims what openings need. */
void room_build_shell(kit_room *r, int attic);
/* where a wall's point is, along it from its left corner, so far before it */
void room_wall_point(const kit_room *r, int wall, double along, double before, double out[2]);

#endif
