/* foliage.h - what gardens and woods by seed are planted with: trees.c and palms.c grow trees, bushes.c and plants.c
   what is lower, fences.c and ornaments.c are what people put among them, sown.c and yards.c set it out, wilds.c,
   gardens.c and crops.c say where, foliage.c chooses among them. Private to these. All of it stands on y = 0
   at the origin of the frame that is entered. */
#ifndef KIT_FOLIAGE_H
#define KIT_FOLIAGE_H

#include "kit/kit_seed.h"

/* ---- >>leaves: sheets without thickness ------------------------------------------------------------------------ */

enum kit_leaf_outline { KIT_CARD, KIT_RAGGED, KIT_DIAMOND, KIT_POINTED, KIT_BLADE, KIT_BROAD, KIT_NEEDLE, KIT_ROUND };

/* fold: how far the edges rise from the midrib, as a share of the width; bend: radians down over the length */
typedef struct kit_foil {
    int outline;
    double length, width, bend, fold;
} kit_foil;

/* from at along a unit vector; across: about which it lies flat */
void garden_grow_leaf(kit_build *b, const kit_foil *l, const double at[3], const double along[3],
                      const double across[3]);
/* so many leaves about a direction, spread by so many radians from it */
void garden_grow_cluster(kit_build *b, const kit_foil *l, const double at[3], const double along[3], double spread,
                         int count);
/* cards through each other along a direction, as games have them */
void garden_grow_cards(kit_build *b, const kit_foil *l, const double at[3], const double along[3], int count);
/* a unit vector that leans from way by so many radians towards spin, and one across it */
void garden_lean(const double way[3], double angle, double spin, double out[3], double across[3]);
/* the colour that is set, lighter or darker by up to vary of it */
void garden_shade(kit_build *b, const float base[3], double vary);

/* ---- >>trees --------------------------------------------------------------------------------------------------- */

/* Points of something that grows from there in a direction, which ends as it has become. */
void garden_wander(kit_build *b, const double from[3], double way[3], double length, double gnarl, double droop,
                   double at[][3], int count);

/* a round limb that tapers; its foot is wider by flare and has lobes; rough: how uneven its bark is */
typedef struct kit_limb {
    const double (*at)[3];
    int count;
    double r0, r1, flare, lobes;
    int around;
    double rough;
} kit_limb;

void garden_grow_limb(kit_build *b, const kit_limb *l);

enum kit_species {
    KIT_OAK,
    KIT_POPLAR,
    KIT_BIRCH,
    KIT_WILLOW,
    KIT_APPLE,
    KIT_ACACIA,
    KIT_GIANT,
    KIT_BARE,
    KIT_SPECIES
};

enum kit_season { KIT_SUMMER, KIT_SPRING, KIT_AUTUMN, KIT_BLOSSOM };

typedef struct kit_tree {
    double height, girth;       /* metres; of the trunk's radius */
    double clear;               /* share of the height below the branches */
    double reach, angle;        /* of the longest branch, of the height; from the trunk, radians */
    double droop, gnarl, taper; /* branches bend down by; are crooked by; are shorter at the top by */
    double lobes;
    int branches, twigs, leaves; /* of the trunk, of a branch, of a twig */
    kit_foil foil;
    float bark[3], green[3];
} kit_tree;

kit_tree garden_draw_tree(kit_build *b, int species, int season);
/* detail 2: twigs and leaves; 1: cards of leaves; 0: a few large cards */
void garden_grow_tree(kit_build *b, const kit_tree *t, int detail);
void garden_grow_conifer(kit_build *b, double height, int detail);
void garden_grow_palm(kit_build *b, double height, int detail);
void garden_grow_bamboo(kit_build *b, double height, int leaves);
/* far: a trunk and a lump or cards */
void garden_grow_far_tree(kit_build *b, double height, int pointed, int solid);

/* ---- >>lumps: balls of half sides, uneven by so much ------------------------------------------------------------ */

typedef struct kit_lump {
    double half[3];
    unsigned seed;
    double strong, often;
    int octaves;
} kit_lump;

double garden_lump_out(const kit_lump *s, const double way[3]); /* how far out it is, in that direction */
void garden_lump_surface(const void *shape, double u, double v, kit_vertex *out);

/* ---- >>lower plants -------------------------------------------------------------------------------------------- */

enum kit_bush { KIT_BUSH_CORE, KIT_BUSH_TWIGS, KIT_BUSH_CARDS, KIT_BUSHES };

void garden_grow_bush(kit_build *b, double width, double height, int kind);
/* clipped: over x and z from the middle, leaves on a core or without it */
void garden_grow_hedge(kit_build *b, double x, double height, double z, double leaf, int core);
/* clipped to a ball, a cone or tiers */
void garden_grow_topiary(kit_build *b, double height, int kind);
/* blades or leaves out of one spot */
void garden_grow_tuft(kit_build *b, const kit_foil *l, int count, double spread);
void garden_grow_rosette(kit_build *b, double length, int kind);
void garden_grow_fern(kit_build *b, double length, int fronds);
void garden_grow_banana(kit_build *b, double height);

enum { KIT_FLOWERS = 5 };

void garden_grow_flower(kit_build *b, double height, int kind, const float colour[3]);
void garden_grow_reed(kit_build *b, double height);
void garden_grow_mushroom(kit_build *b, double height);
void garden_grow_cactus(kit_build *b, double height);
/* ivy over the plane z = 0, in front of it, between x0 and x1, up to height */
void garden_grow_ivy(kit_build *b, double x0, double x1, double height, double cover);

/* ---- >>what stands among them ---------------------------------------------------------------------------------- */

void garden_put_stone(kit_build *b, const double half[3], int cells);
void garden_put_log(kit_build *b, double length, double radius);
void garden_put_stump(kit_build *b, double radius);
void garden_put_bench(kit_build *b, int kind);

/* along x from 0 */
enum { KIT_FENCES = 4 };

void garden_put_fence(kit_build *b, double length, double height, int kind);
void garden_put_wall(kit_build *b, double length, double height, int kind);
/* gives the height of its soil; opening: its radius */
double garden_put_pot(kit_build *b, double height, int kind, double *opening);
double garden_put_trough(kit_build *b, double x, double height, double z);
void garden_put_statue(kit_build *b, double height, int kind);
void garden_put_fountain(kit_build *b, double radius);
void garden_put_pergola(kit_build *b, double x, double height, double z);
void garden_put_table(kit_build *b, int chairs);
void garden_put_parasol(kit_build *b, double height);
void garden_put_lamp_post(kit_build *b, double height);
void garden_put_lantern(kit_build *b, double height);
void garden_put_ladder(kit_build *b, double length);
void garden_put_barrow(kit_build *b);
void garden_put_crate(kit_build *b);

/* ---- >>yards --------------------------------------------------------------------------------------------------- */

enum { KIT_TAKEN = 400, KIT_MOST_TRIANGLES = 165000 };

/* What is being laid out; taken: discs that things stand on, x, z, radius, and the radius of no grass. */
typedef struct kit_yard {
    kit_plot *p;
    int season, takes;
    double taken[KIT_TAKEN][4];
} kit_yard;

/* what p->of says of the ground: it rises and falls by so much, so often a metre; beyond level metres alone; hills far
   off; a hollow */
enum kit_ground_shape {
    KIT_BUMPS,
    KIT_OFTEN,
    KIT_SEEDED,
    KIT_LEVEL,
    KIT_HILLS,
    KIT_HOLLOW_X,
    KIT_HOLLOW_Z,
    KIT_HOLLOW_R,
    KIT_HOLLOW_DEEP
};

/* the ground in the colour that is set: bumps, how often, level within, hills */
void garden_lay_ground(kit_yard *y, double bumps, double often, double level, double hills);
void garden_take(kit_yard *y, double x, double z, double radius);
int garden_is_free(const kit_yard *y, double x, double z, double radius);
/* a free disc between two distances from the middle, which is taken; 0: none */
int garden_find_spot(kit_yard *y, double near, double far, double radius, double at[2]);
/* A new object on the ground there, if it has a name; what kit_leave takes. */
kit_frame garden_set_out(kit_yard *y, const char *name, double x, double z, double turn);
void garden_sight_above(kit_yard *y, double x, double up, double z, double reach);
int garden_has_room(const kit_yard *y); /* for more triangles */
void garden_set_tree(kit_yard *y, double x, double z, int species, int detail);
void garden_set_conifer(kit_yard *y, double x, double z, double height, int detail);
void garden_set_pot(kit_yard *y, double x, double z, double height);
/* by so many, over discs about random middles within reach */
void garden_sow_grass(kit_yard *y, int blades, double length, double reach, int patches);
void garden_sow_flowers(kit_yard *y, double x, double z, double hx, double hz, int count, double height);
void garden_sow_litter(kit_yard *y, int leaves, double reach);
/* low leaves, twigs that lie about, pebbles */
void garden_sow_cover(kit_yard *y, int plants, int twigs, int pebbles, double reach);
void garden_set_stones(kit_yard *y, int count, double near, double far, double size);
void garden_set_bushes(kit_yard *y, int count, double near, double far, double size);
void garden_set_ferns(kit_yard *y, int count, double near, double far);
void garden_set_far_trees(kit_yard *y, int count, double near, double far);
/* a strip along z at x, on the ground */
void garden_lay_path(kit_yard *y, double x, double half, double from, double to);

/* beside them (yards.c): ground of two triangles; slabs; a house's wall along x that faces z; ivy along x from there;
   and what is set about */
void garden_lay_flat(kit_yard *y);
void garden_lay_paving(kit_yard *y, double x0, double z0, double x1, double z1, double size);
void garden_set_house(kit_yard *y, double x, double z, double turn, double length, double height);
void garden_set_climber(kit_yard *y, double x, double z, double turn, double length, double height);
void garden_set_bench(kit_yard *y, double x, double z, double turn);
void garden_set_statue(kit_yard *y, double x, double z, double height, int kind);
void garden_set_table(kit_yard *y, double x, double z);
/* kind: fences, 4 to 6 walls, 7 a hedge; along x from there */
void garden_set_border(kit_yard *y, int kind, double x, double z, double turn, double length);
void garden_set_bed(kit_yard *y, double x, double z, double hx, double hz);

typedef void garden_layout(kit_yard *y);
garden_layout kit_lay_woods, kit_lay_meadow, kit_lay_pond, kit_lay_jungle, kit_lay_bamboo, kit_lay_dry, kit_lay_ruin,
    kit_lay_garden, kit_lay_park, kit_lay_maze, kit_lay_parterre, kit_lay_terrace, kit_lay_greenhouse,
    kit_lay_vegetables, kit_lay_orchard, kit_lay_stones;

#endif
