/* streets.h - what streets by seed are made of. Private to scene/streets.c, districts.c, outskirts.c, canals.c,
   lots.c, houses.c, facades.c, roofs.c, fittings.c, kerbside.c and stalls.c. All of it stands in the frame entered. */
#ifndef KIT_STREETS_H
#define KIT_STREETS_H

#include "kit/kit_seed.h"

/* ---- >>buildings (facades.c, roofs.c) -------------------------------------------------------------------------- */

enum { KIT_OLD, KIT_BRICK, KIT_MODERN, KIT_PANEL, KIT_COTTAGE, KIT_WAREHOUSE, KIT_TOWER, KIT_HOUSES };

enum { KIT_FLAT, KIT_GABLE, KIT_HIP, KIT_CROSS_GABLE }; /* roofs */

enum { KIT_BARS, KIT_BOARDS, KIT_GLASS, KIT_SOLID, KIT_PICKETS, KIT_MESH }; /* railings and fences */

enum { KIT_FRONT = 1, KIT_RIGHT = 2, KIT_BACK = 4, KIT_LEFT = 8, KIT_ROUND = 15 };

/* A building: its front in the plane z = 0, looking along +z, from x = 0 to width; depth behind. */
typedef struct kit_house {
    int style, floors, fine; /* fine 0: as seen from afar, and no objects of its own */
    int sides;               /* those that have windows */
    int cladding;            /* 0: plain; 1: lapped boards, 2: blocks, 3: battens */
    int arched, shutters, courses, dentils, quoins, roof, rail, rows, columns; /* rows, columns: of panes */
    double width, depth, storey, ground, bay, window[2], sill, recess;
    double shops, balconies, coolers, awnings, pots; /* how often */
    float wall[3], trim[3], wood[3], cover[3];       /* cover: the roof's */
} kit_house;

void kit_town_draw_house(kit_build *b, kit_house *h, int style);
void kit_town_raise_house(kit_plot *p, const kit_house *h);
double kit_town_eaves(const kit_house *h); /* how high its walls are */
void kit_town_roof(kit_build *b, const kit_house *h);
void kit_town_fire_escape(kit_build *b, const kit_house *h, double x);
void kit_town_scaffold(kit_build *b, double width, double height, int net);
/* along a line of points x, z, standing on y */
void kit_town_railing(kit_build *b, const double at[][2], int count, double y, double height, int kind);
/* striped, from y at z = 0, out and down, with a valance */
void kit_town_awning(kit_build *b, double width, double y, double out, double drop);

/* ---- >>things (kerbside.c, stalls.c) ---------------------------------------------------------------------------- */

void kit_town_paint(kit_build *b, const float c[3]);
void kit_town_keep(const kit_build *b, float c[3]); /* the colour that is set */
/* a point of the frame in the world */
void kit_town_to_world(const kit_build *b, double x, double y, double z, double out[3]);

void kit_town_car(kit_build *b); /* along z */
void kit_town_bicycle(kit_build *b);
void kit_town_bin(kit_build *b);
void kit_town_dumpster(kit_build *b);
void kit_town_bench(kit_build *b);
void kit_town_bollard(kit_build *b);
void kit_town_hydrant(kit_build *b);
void kit_town_sign_post(kit_build *b);
void kit_town_lamp_post(kit_plot *p, double height); /* its arm along +z */
void kit_town_traffic_light(kit_build *b);
void kit_town_wire_pole(kit_build *b, double height); /* its arms along x */
void kit_town_billboard(kit_build *b);
void kit_town_shelter(kit_build *b);
void kit_town_cone(kit_build *b);
void kit_town_street_tree(kit_build *b, double height);
void kit_town_shrub(kit_build *b, double size);
void kit_town_pot(kit_build *b);
void kit_town_person(kit_build *b, int stone); /* stone: as a statue */
void kit_town_stall(kit_build *b);
void kit_town_cafe(kit_build *b);
void kit_town_crates(kit_build *b);
void kit_town_fountain(kit_build *b);
void kit_town_monument(kit_build *b);
void kit_town_laundry(kit_build *b, double width); /* along x, hanging from y = 0 */
void kit_town_bunting(kit_build *b, double width);
void kit_town_heap(kit_build *b, double size);
void kit_town_pallet(kit_build *b);

/* ---- >>ground, rows, layouts (lots.c; districts.c, outskirts.c, canals.c) ---------------------------------------- */

typedef struct kit_town {
    int style[2], floors, shops; /* floors: at most; 0: as each style has them */
    double upkeep;               /* 0: cluttered .. 1: tidy */
    double pave;                 /* how high pavements are */
    int scaffold;                /* still to be put up */
} kit_town;

void kit_town_ground(kit_plot *p, double size);
/* stones of a size over a rectangle of x, z; at most 2500 */
void kit_town_paving(kit_build *b, const double r[4], double y, double size);
void kit_town_pavement(kit_build *b, const double r[4], double y, double size);
/* houses along a line, x and z, their fronts to its left seen from above walking backwards: towards (-dz, dx) */
void kit_town_row(kit_plot *p, kit_town *t, double x0, double z0, double x1, double z1);
/* houses far off, all around */
void kit_town_skyline(kit_plot *p, double radius);
/* when there are too many of them, in place of another */
void kit_town_sight(kit_plot *p, double x, double y, double z, double reach);
/* begins an object at a place, which is a sight, and enters it */
kit_frame kit_town_stand(kit_plot *p, const char *name, const double at[3], double turn, double reach);

enum {
    KIT_CAR,
    KIT_BICYCLE,
    KIT_BIN,
    KIT_DUMPSTER,
    KIT_BENCH,
    KIT_BOLLARD,
    KIT_HYDRANT,
    KIT_SIGN,
    KIT_LIGHT,
    KIT_POLE,
    KIT_BILLBOARD,
    KIT_SHELTER,
    KIT_CONE,
    KIT_TREE,
    KIT_SHRUB,
    KIT_POT,
    KIT_PERSON,
    KIT_STALL,
    KIT_CAFE,
    KIT_CRATES,
    KIT_FOUNTAIN,
    KIT_MONUMENT,
    KIT_HEAP,
    KIT_PALLET,
    KIT_LAMP,
    KIT_TALL_LAMP,
    KIT_THINGS
};

void kit_town_put(kit_plot *p, int thing, double x, double y, double z, double turn);
/* eyes may be there */
void kit_town_range(kit_plot *p, double x0, double z0, double x1, double z1);
void kit_town_lay_alley(kit_plot *p, kit_town *t);
void kit_town_lay_street(kit_plot *p, kit_town *t);
void kit_town_lay_square(kit_plot *p, kit_town *t);
void kit_town_lay_canal(kit_plot *p, kit_town *t);
void kit_town_lay_steps(kit_plot *p, kit_town *t);
void kit_town_lay_court(kit_plot *p, kit_town *t);
void kit_town_lay_suburb(kit_plot *p, kit_town *t);
void kit_town_lay_city(kit_plot *p, kit_town *t);
void kit_town_lay_site(kit_plot *p, kit_town *t);
void kit_town_lay_forecourt(kit_plot *p, kit_town *t);

#endif
