/* kit_seed.h - scenes drawn from a seed, and models of the catalogue by their names. Private to the files of scene/
   that build them: seeds.c reads names and puts a scene together, grammar.c builds what the rows of tables/ say,
   catalogue.c finds models, look.c places the camera. */
#ifndef KIT_SEED_H
#define KIT_SEED_H

#include "kit/kit_build.h"

/* ---- >>plot: what a scene is built on -------------------------------------------------------------------------- */

/* Something worth looking at: a ball around it. */
typedef struct kit_sight { double at[3], reach; } kit_sight;

enum { KIT_SIGHTS = 64, KIT_LAMPS = 8 };
/* A scene is built in metres, y up, near the origin, one object a thing; its rows say where one may stand and what
   there is to look at. */
typedef struct kit_plot {
    kit_build  b;
    double     stand[4];                   /* x0, z0, x1, z1: over which eyes may be */
    double     ceiling;                    /* eyes stay below it; 0: open sky */
    double     ground[8];                  /* the numbers of the row GROUND, the fifth of which is its noise's seed */
    int        sights, lamps;
    kit_sight  sight[KIT_SIGHTS];
    double     lamp[KIT_LAMPS][3];         /* where point lights may hang */
} kit_plot;

/* The ground's height there: 0 where no row makes any. */
double kit_ground_at(const kit_plot *p, double x, double z);

/* Places the camera and the radius for the scene that is built: seed says which way of looking and what share of the
   picture's height the radius takes. -1: no memory. */
int    kit_look(kit_scene *s, kit_plot *p, unsigned seed);

/* ---- >>rows ---------------------------------------------------------------------------------------------------- */

/* A row of tables/: a THING begins, and all rows up to the next one are its parts; the others place a thing or a model,
   make a shape, or say something of the scene. Columns are text:

   name    of a thing, or of a part: chances are drawn by the names of the parts that lead to a row, and by the number
           of its copy, so that rows and files may be moved, and rows added, without a change to any other.
   at      "COUNT: X Y Z TURN TILT SCALE clear R": so many copies (1) at places in the thing's own axes, turned by
           degrees about y, after they are tilted about x; those that would come nearer to a claimed disc than
           R go elsewhere, or are left out. Numbers that are missing are 0, SCALE 1.
   numbers of a THING, "name=number ..": its variables, unless the row that places it gives them others. Of PUT and PART
           "thing|thing name=number ..": which thing, one of several, by chance. Of a MODEL names of the catalogue and a
           height in metres, its own where there is none. Of a shape its measures: see the list of verbs.
   paint   of a shape: a palette; all parts of a thing that name one have the same of its colours.
   odds    the chance that the row is made, 1 where it is empty.

   A number is an expression without blanks: + - * / ( ), variables, a~b any number between two, a|b|c one of several;
   a<b, a>b, a=b 1 or 0; sin(x), cos(x) of degrees, abs(x), int(x). Of a copy: i its number, n how many there are,
   t = (i + 0.5) / n, u = i / (n - 1), sx and sz the signs of four corners, x and z its place, g the height of the
   ground there. Variables of the things around are seen, too. */
typedef struct kit_row {
    const char *name;
    int verb;
    const char *at, *numbers, *paint, *odds;
} kit_row;

enum {
    THING,
    PUT,                                   /* a thing that is an object of its own, and a sight */
    PART,                                  /* a thing that belongs to the one around it */
    MODEL,                                 /* a model of the catalogue, an object of its own, and a sight */
    /* shapes */
    BOX,                                   /* x0 y0 z0 x1 y1 z1 bevel */
    ROD,                                   /* x0 y0 z0 x1 y1 z1 radius around */
    TURNED,                                /* r y r y ..: a line of radii and heights about y, from below upwards */
    BALL,                                  /* x y z rx ry rz cells */
    CUSHION,                               /* x y z half sides, round 0 .. 1, cells */
    RING,                                  /* x y z radius, tube: lying */
    WIRE,                                  /* x0 y0 z0 x1 y1 z1 sag radius */
    PRISM,                                 /* height x z x z ..: a convex outline, counter-clockwise seen from above */
    LEAF,                                  /* width length bend cells pointed: a sheet along z */
    PANE,                                  /* x0 y0 z0 x1 y1 z1: a flat sheet between two corners, upright or level */
    CLOTH,                                 /* width height waves depth: a hanging sheet, folded */
    ROCK,                                  /* rx ry rz rough cells facets */
    /* of the scene */
    GROUND,                                /* x0 z0 x1 z1 cells height width octaves: noise; 0 high, flat */
    LAMP,                                  /* x y z */
    STAND,                                 /* x0 z0 x1 z1: where eyes may be */
    CEILING,                               /* height */
    SIGHT                                  /* x y z reach */
};

/* Builds a thing of the tables at the origin, chances by seed. err, empty before, says what is wrong: a row that cannot
   be read, with its name; a model's package that is missing; no memory. */
void   kit_build_thing(kit_plot *p, const char *thing, uint32_t seed, kit_error *err);
/* A model of the catalogue on a floor, half its diagonal 1, since cameras are for things of that size; seed: for the
   sights on it. What that is in metres; 0: err says what is wrong. */
double kit_build_model(kit_plot *p, const char *name, uint32_t seed, kit_error *err);
/* Tables of rows, which end with one without a name. */
extern const kit_row kit_rows_shared[], kit_rows_rooms[], kit_rows_streets[], kit_rows_halls[], kit_rows_foliage[],
    kit_rows_machines[], kit_rows_scans[], kit_rows_terrain[];

/* ---- >>models -------------------------------------------------------------------------------------------------- */

/* A model that a package brings, "armchair3" or "scopia/armchair3", as it is: upright, on y = 0, its middle on the
   axis, in metres. Those in archives are unpacked, once, into a folder of the user's caches. */
int    kit_catalogue_read(kit_mesh *mesh, const char *name, int length, kit_error *err);
int    kit_catalogue_has(const char *name, int length);

#endif
