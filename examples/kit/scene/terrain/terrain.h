/* terrain.h - what landscapes by seed are made of. Private to terrain.c, site.c, land.c, rocks.c, wilds.c. */
#ifndef KIT_TERRAIN_H
#define KIT_TERRAIN_H

#include "kit/kit_seed.h"

/* ---- >>land: the ground's height, and its mesh (land.c) ---------------------------------------------------------- */

typedef enum kit_land {
    KIT_HILLS,
    KIT_RIVERBED,
    KIT_CANYON,
    KIT_SCARP,
    KIT_SHORE,
    KIT_DUNES,
    KIT_MESAS,
    KIT_LAVA,
    KIT_GLACIER,
    KIT_QUARRY,
    KIT_ALPS,
    KIT_PLAIN
} kit_land;

/* What kit_plot's of holds: the land, its seed, its unit of length and of height, a turn in radians, how rough, two
   numbers of the land's own, the level of water; how wide and how high small relief is. */
enum {
    KIT_OF_LAND,
    KIT_OF_SEED,
    KIT_OF_LENGTH,
    KIT_OF_HEIGHT,
    KIT_OF_TURN,
    KIT_OF_ROUGH,
    KIT_OF_A,
    KIT_OF_B,
    KIT_OF_LEVEL,
    KIT_OF_SMALL,
    KIT_OF_RELIEF
};

double land_height(const kit_plot *p, double x, double z);
/* or that of the water above it */
double land_stand(const kit_plot *p, double x, double z);
/* 0: level, 1: at 45 degrees */
double land_slope(const kit_plot *p, double x, double z, double step);

/* Albedo of what is level, steep and high, in bands if banded; high from this height on. */
typedef struct kit_soil {
    float level[3], steep[3], high[3];
    double above, bands, vary;
} kit_soil;

static const double KIT_FOREVER = 1e9;
extern const kit_soil kit_grassy, kit_heath, kit_red_rock, kit_buff_rock, kit_sand, kit_basalt, kit_ice, kit_limestone,
    kit_alpine, kit_gravel, kit_chalk; /* site.c */

/* cells x cells quadrilaterals over a square of half side reach, finer towards the middle by cosh(finer); ledges:
   cliffs are pushed out and in by so much, in layers; facets: flat faces, irregular corners */
typedef struct kit_lay {
    int cells, facets;
    double reach, finer, ledges, layer;
} kit_lay;

void land_build(kit_plot *p, const kit_soil *soil, const kit_lay *lay);

/* ---- >>rocks (rocks.c): about the origin or standing on y = 0, in the colour that is set ------------------------- */

/* a surface roughened along its normal: by so much, features 1 / scale wide */
typedef struct kit_rough {
    kit_surface *base;
    const void *shape;
    unsigned seed;
    double scale, by;
    int octaves;
} kit_rough;

void land_rough_surface(const void *shape, double u, double v, kit_vertex *out);

void land_rock(kit_build *b, const double half[3], double rough, double layers, int cells, int facets);
void land_cut_stone(kit_build *b, const double half[3], int cuts, double deep);
/* a slab that stands, narrower at its top */
void land_menhir(kit_build *b, double width, double thick, double height);
void land_cairn(kit_build *b, double radius, int stones);
void land_arch(kit_build *b, double radius, double thick, int cells);
void land_spire(kit_build *b, double radius, double height, double rough, int cells);
void land_basalt_columns(kit_build *b, double radius, int rows, double height);
/* a wall of laid blocks whose top is broken, along x from the origin */
void land_ruined_wall(kit_build *b, double length, double height, double thick, double course, int bevelled);
void land_drum_column(kit_build *b, double radius, double height, int broken);

/* ---- >>wilds (wilds.c): the same --------------------------------------------------------------------------------- */

/* a bent limb that tapers, round */
void land_bent_limb(kit_build *b, const double from[3], const double over[3], const double to[3], double r0, double r1,
                    int around, int along);
void land_bare_tree(kit_build *b, double height, int depth);
void land_driftwood(kit_build *b, double length);
void land_grass_tuft(kit_build *b, double height, int blades);
void land_fir_tree(kit_build *b, double height, int tiers);
void land_cactus(kit_build *b, double height);
void land_prickly_pear(kit_build *b, double height);
void land_hut(kit_build *b, double width, double depth, double height);
void land_boat(kit_build *b, double length);
void land_wreck(kit_build *b, double length);
void land_tent(kit_build *b, double width, double length, double height);
void land_shell(kit_build *b, double size);
void land_pole_ladder(kit_build *b, double height);
void land_planks(kit_build *b, int count, double length);

/* ---- >>site: things where there is room for them (site.c) -------------------------------------------------------- */

enum { KIT_ROUND, KIT_ANGULAR, KIT_LAYERED, KIT_WORN, KIT_BLOCKS, KIT_STONE_KINDS };

/* A landscape: its soil, its stones, and how large it is: 1 where a stone one walks around is the thing to look at. */
typedef struct kit_site {
    kit_plot *p;
    kit_build *b;
    kit_soil soil;
    double unit;
    int stones;
} kit_site;

typedef struct kit_spot {
    double x, z;
} kit_spot;

void land_set_land(kit_site *s, kit_land land, double length, double height, double a, double b);
/* cells about fine wide in the middle; one may stand as far from it as stand */
void land_lay_ground(kit_site *s, double reach, double fine, double stand, double ledges);
void land_lay_water(kit_site *s, double reach, double level);

/* so far from the origin; level: the most level of some, above the water */
kit_spot land_any_spot(kit_site *s, double near, double far);
kit_spot land_level_spot(kit_site *s, double near, double far);
kit_frame land_enter_at(kit_site *s, kit_spot at, double sunk, double turn, double size);
kit_frame land_begin_thing(kit_site *s, const char *name, kit_spot at, double sunk, double size);
void land_see(kit_site *s, kit_spot at, double up, double reach);

void land_stone_colour(kit_site *s);
/* one, about the origin, of the site's kind; fine: cells */
void land_stone(kit_site *s, double size, int fine);
/* many in one object, most of them small */
void land_strew(kit_site *s, const char *name, kit_spot at, double radius, int count, double least, double most);
/* each a thing of its own, some with a smaller one on top */
void land_strew_rocks(kit_site *s, int count, double near, double far, double least, double most);
/* heaps of such in as many places */
void land_strew_heaps(kit_site *s, int heaps, int count, double far, double least, double most);
/* makes sights of so many places where the land is steep */
void land_see_land(kit_site *s, int count, double near, double far, double reach);
#define land_some(s, least, most) ((least) + kit_choose((s)->b, (most) - (least) + 1))
/* stones about what is to be seen */
void land_strew_about_sights(kit_site *s, double probability);
void land_put_bare_trees(kit_site *s, int count, double far, double height);
void land_put_tufts(kit_site *s, int patches, int count, double far, double height);
void land_put_firs(kit_site *s, int groups, int count, double near, double far, double height);
void land_fence(kit_site *s, kit_spot from, kit_spot to, double gap);
void land_fence_somewhere(kit_site *s, double far);
/* planks on posts, over what is below */
void land_jetty(kit_site *s, kit_spot from, double turn, double length, double level);
void land_put_hut(kit_site *s, double near, double far);
void land_put_spires(kit_site *s, int count, double near, double far, double height, int caps);

enum {
    KIT_BOAT,
    KIT_WRECK,
    KIT_TENT,
    KIT_CAIRN,
    KIT_DRIFTWOOD,
    KIT_ARCH,
    KIT_CACTUS,
    KIT_PEAR,
    KIT_LOGS,
    KIT_LADDER,
    KIT_SHELL
};

/* one of those, so large, on the ground */
kit_spot land_put(kit_site *s, int what, double near, double far, double size);
void land_put_some(kit_site *s, int what, int count, double near, double far, double least, double most);

/* ---- >>landscapes (vistas.c, relics.c) --------------------------------------------------------------------------- */

typedef void land_landscape(kit_site *s);
land_landscape kit_canyon, kit_mountains, kit_great_mesas, kit_sea_stacks, kit_great_dunes, kit_highlands, kit_hoodoos,
    kit_tors;                                                               /* vistas.c */
land_landscape kit_ruins, kit_standing_stones, kit_cave, kit_pebble_ground; /* relics.c */

#endif
