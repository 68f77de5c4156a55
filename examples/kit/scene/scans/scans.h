/* scans.h - figures as a scanner or a sculptor makes them: blended blobs whose surface is meshed. Private to the
   files of scene/ that build scans: sculpt.c meshes, figures.c and relics.c model, scans.c places them. */
#ifndef KIT_SCANS_H
#define KIT_SCANS_H

#include "kit/kit_seed.h"

/* ---- >>clay ------------------------------------------------------------------------------------------------------ */

enum { KIT_LIMB, KIT_EGG, KIT_BLOCK };

/* A limb goes from a, where its radius is ra, to b, where it is rb; an egg has its middle at a, half axes b;
a block has
   its middle at a, half sides b and edges rounded by ra. Blended into what was there over so much;
   carved: taken away. */
typedef struct kit_blob {
    double a[3], b[3], ra, rb, blend;
    int kind, carved;
} kit_blob;

enum { KIT_BLOBS = 320, KIT_CUTS_MOST = 4, KIT_RELIEF = 8 };

/* distance to the surface, from that of the blobs */
typedef double scan_relief(const double of[KIT_RELIEF], const double p[3], double distance);

/* What lies beyond a plane, dot(n, p) > d, or within a ball about n, radius d, is missing,
    with a jagged edge: the rest is
   an open sheet. */
typedef struct kit_missing {
    double n[3], d, jag;
    int ball;
} kit_missing;

typedef struct kit_clay {
    kit_blob blob[KIT_BLOBS];
    int blobs;
    double rough, grain; /* how far noise moves the surface, how wide its features are */
    int octaves, seed;
    scan_relief *relief; /* or NULL */
    double of[KIT_RELIEF];
    kit_missing missing[KIT_CUTS_MOST];
    int cuts;
    int facets;   /* flat triangles */
    double stain; /* how much albedo varies over it */
} kit_clay;

/* more blobs than there is room for are forgotten */
kit_blob *scan_limb(kit_clay *c, double x0, double y0, double z0, double r0, double x1, double y1, double z1, double r1,
                    double blend);
kit_blob *scan_egg(kit_clay *c, double x, double y, double z, double rx, double ry, double rz, double blend);
kit_blob *scan_block(kit_clay *c, double x, double y, double z, double hx, double hy, double hz, double round,
                     double blend);
/* also at -x what was added last so many times */
void scan_mirror(kit_clay *c, int last);
void scan_cut_plane(kit_clay *c, double nx, double ny, double nz, double d, double jag);
void scan_cut_ball(kit_clay *c, double x, double y, double z, double radius, double jag);

/* The clay's surface, in the colour that is set, at the place that is set: so many cells along its longest side. */
void scan_sculpt(kit_build *b, const kit_clay *c, int cells);

/* ---- >>models ---------------------------------------------------------------------------------------------------- */

/* Adds its blobs to an empty clay: about 1 high or wide, standing on y = 0, facing +z. */
typedef void scan_model_make(kit_build *b, kit_clay *c);
scan_model_make kit_statue, kit_seated, kit_torso, kit_bust, kit_skull, kit_mask, kit_beast, kit_dragon, kit_hand,
    kit_snail, kit_ammonite, kit_coral, kit_root, kit_vase, kit_bowl, kit_knot, kit_rock, kit_drum, kit_bird,
    kit_gyroid, kit_column;

/* ---- >>props: exhibits.c; in metres, standing on y = 0 ----------------------------------------------------------- */

/* a cloth over what is so wide (half) and high; half its own side */
void scan_drape(kit_build *b, double wide, double high, double side);
/* a sheet of paper or cloth that hangs down from so high and runs out forward (+z) over the ground, on two stands */
void scan_backdrop(kit_build *b, double wide, double high, double out);
void scan_plinth(kit_build *b, double wide, double high);
void scan_table(kit_build *b, double wide, double deep, double high);
void scan_books(kit_build *b);
void scan_bottle(kit_build *b, double high);
void scan_brushes(kit_build *b);
void scan_papers(kit_build *b, int count);
void scan_softbox(kit_build *b, double high);
void scan_tripod(kit_build *b, double high);
void scan_crate(kit_build *b, double wide, double high);
void scan_pallet(kit_build *b);
void scan_barrier(kit_build *b, double wide, double deep);
/* a picture's frame with its canvas, hanging on a wall behind (-z), its middle so high */
void scan_picture(kit_build *b, double wide, double high, double middle);
void scan_bench(kit_build *b, double wide);
/* a wall from (x0, z0) to (x1, z1), front on its left, with skirting and perhaps pilasters */
void scan_gallery_wall(kit_build *b, double x0, double z0, double x1, double z1, double high, int pilasters);

/* ---- >>scenes: scans.c, sites.c ---------------------------------------------------------------------------------- */

enum {
    STATUE,
    SEATED,
    TORSO,
    BUST,
    SKULL,
    MASK,
    BEAST,
    DRAGON,
    HAND,
    SNAIL,
    AMMONITE,
    CORAL,
    ROOT,
    VASE,
    BOWL,
    KNOT,
    ROCK,
    DRUM,
    BIRD,
    SPONGE,
    COLUMN,
    BUNNY,
    KIT_SCANS
};

/* What a scene's figures have in common: cells along a side, of which family their colours are, flat triangles,
   how many bunnies are left. */
typedef struct kit_style {
    int cells, matter, facets, bunnies;
} kit_style;

enum { KIT_OF_STONE, KIT_OF_BRONZE, KIT_OF_CLAY, KIT_OF_PLASTIC, KIT_OF_WOOD }; /* kit_style's matter */

void scan_tint(kit_build *b, int matter, double vary);
/* a sight in the frame's coordinates */
void scan_sight(kit_plot *p, double x, double y, double z, double reach);
double scan_slim(int which); /* so much of a model's height is its width */
/* A model so high, tilted, in the frame; part of an object that has begun when object is 0. */
void scan_place_scan(kit_plot *p, const kit_style *s, int which, const double at[3], double turn, double tilt,
                     double high, int object);
void scan_place_upright(kit_plot *p, const kit_style *s, int which, double x, double y, double z, double turn,
                        double high);
/* one of those, or the bunny when one is left */
int scan_next_scan(kit_build *b, kit_style *s, const int *of, int count);
#define ANY(b, of) (of[kit_choose(b, (int)(sizeof of / sizeof *of))])
#define NEXT(b, s, of) scan_next_scan(b, s, of, (int)(sizeof of / sizeof *of))
void scan_ruins(kit_plot *p, kit_style *s);
void scan_sands(kit_plot *p, kit_style *s);
void scan_garden(kit_plot *p, kit_style *s);

#endif
