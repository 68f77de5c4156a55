/* kit_seed.h - scenes drawn from a seed. Private to the files of scene/ that build them: seeds.c reads names and puts
   a scene together, look.c places its camera, parts.c is what kinds share; a kind is a file. */
#ifndef KIT_SEED_H
#define KIT_SEED_H

#include "kit/kit_build.h"

/* ---- >>plot: what a kind builds on ---------------------------------------------------------------------------- */

/* Something worth looking at: a ball around it. */
typedef struct kit_sight { double at[3], reach; } kit_sight;

enum { KIT_SIGHTS = 64, KIT_LAMPS = 8, KIT_DRAWN = 8192 /* places that draw; more of them share */ };
/* A kind builds its scene in metres, y up, near the origin, with chances drawn from b, one object a thing, and says
   where one may stand and what there is to look at. */
typedef struct kit_plot {
    kit_build  b;
    uint32_t   drawn[KIT_DRAWN];           /* b.drawn */
    double     stand[4];                   /* x0, z0, x1, z1: over which eyes may be */
    double     ceiling;                    /* eyes stay below it; 0: open sky */
    /* the ground's height, NULL: 0 everywhere; of: for it */
    double   (*ground)(const struct kit_plot *of, double x, double z);
    double     of[16];
    int        sights, lamps;
    kit_sight  sight[KIT_SIGHTS];
    double     lamp[KIT_LAMPS][3];         /* where point lights may hang */
    const char *missing;                   /* the file that is not there, whose package */
    const char *package;
} kit_plot;

typedef void kit_kind_make(kit_plot *p);
kit_kind_make kit_make_room, kit_make_street, kit_make_hall, kit_make_foliage, kit_make_machine, kit_make_scan,
    kit_make_terrain;

/* More of them than there is room for are forgotten. */
void   kit_add_sight(kit_plot *p, double x, double y, double z, double reach);
void   kit_add_lamp(kit_plot *p, double x, double y, double z);
double kit_ground_at(const kit_plot *p, double x, double z);

/* Places the camera and the radius for the scene that is built: seed says which way of looking and what share of the
   picture's height the radius takes. -1: no memory. */
int    kit_look(kit_scene *s, kit_plot *p, unsigned seed);

/* ---- >>chances ------------------------------------------------------------------------------------------------- */

/* C leaves open in which order a call's arguments are worked out, and compilers differ. So a chance does not follow
   from those before it, but from where in the text it is drawn and how often it has been drawn there. (A function that
   draws must not be called twice among one call's arguments.) */
#define KIT_PLACE __func__, __COUNTER__
double kit_chance_at(kit_build *b, const char *function, unsigned number);      /* [0, 1) */
#define kit_chance(b) kit_chance_at(b, KIT_PLACE)
#define kit_between(b, low, high) kit_mixed(low, high, kit_chance(b))
static inline double kit_mixed(double low, double high, double part) { return low + (high - low) * part; }
#define kit_choose(b, count) ((int)(kit_chance(b) * (count)))                   /* 0 .. count - 1 */
#define kit_odds(b, probability) (kit_chance(b) < (probability))                /* 1 with that probability */
/* What is drawn between alike and resume follows from a seed alone, not 0: the same for the same seed. */
typedef struct kit_chances { uint32_t random, drawn[KIT_DRAWN]; } kit_chances;
void   kit_alike(kit_build *b, uint32_t seed, kit_chances *before);
void   kit_resume(kit_build *b, const kit_chances *before);
#define kit_draw_seed(b) (1u + (uint32_t)(kit_chance(b) * 4e9))
/* one of a few colours that go together: albedo as kit_colour sets it, varied a little */
#define kit_tint(b, palette, count, vary) kit_tint_at(b, palette, count, vary, KIT_PLACE)
void   kit_tint_at(kit_build *b, const float palette[][3], int count, double vary, const char *function,
                   unsigned number);
#define KIT_TINT(b, palette, vary) kit_tint(b, palette, (int)(sizeof palette / sizeof *palette), vary)
/* smooth noise in [-1, 1], features about 1 wide; fractal: octaves of it, each half as wide and half as strong */
double kit_noise(unsigned seed, double x, double y, double z);
double kit_fractal(unsigned seed, double x, double y, double z, int octaves);

/* ---- >>parts: beside those of kit_build.h, in local coordinates as they are ------------------------------------ */

/* closed, round, through so many points, corners as they are (at most 256 points) */
void   kit_tube(kit_build *b, const double at[][3], int count, double radius, int around);
/* a tube from one point to another that sags by so much in the middle */
void   kit_cable(kit_build *b, const double from[3], const double to[3], double sag, double radius, int around);
/* closed: a box of half sides whose corners are rounded, round 0 .. 1 (a ball) */
void   kit_cushion(kit_build *b, const double half[3], double round, int cells);
/* box with edges cut off at 45 degrees by so much */
void   kit_bevelled(kit_build *b, double x0, double y0, double z0, double x1, double y1, double z1, double bevel);
/* closed, from y = 0 up: a convex outline in x and z, counter-clockwise seen from above */
void   kit_prism(kit_build *b, const double outline[][2], int count, double height);
/* a flat sheet without thickness that leans: width along x, length along z from the origin, bent down by bend radians
   over its length; as a leaf it is pointed at both ends */
void   kit_leaf(kit_build *b, double width, double length, double bend, int cells, int pointed);
/* ground over a rectangle, with smooth normals: height(of, x, z) */
typedef double kit_height(const void *of, double x, double z);
void   kit_height_field(kit_build *b, const double rectangle[4], int nx, int nz, kit_height *height, const void *of);
/* A mesh file, standing upright on y = 0, so high, its middle on the axis, in the colour that is set. -1: it cannot be
   read; the scene then fails with the name of the package that brings it. */
int    kit_model(kit_plot *p, const char *path, const char *package, double height);

#endif
