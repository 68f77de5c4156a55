/* kit_seed.h - scenes drawn from a seed, and models of the catalogue by their names. Private to the files of scene/
   that build them: seeds.c reads names and assembles a scene, grammar.c builds things from the rows of tables/,
   catalogue.c finds models, look.c places the camera. */
#ifndef KIT_SEED_H
#define KIT_SEED_H

#include "kit/kit_build.h"

/* ---- >>plot: what a scene is built in --------------------------------------------------------------- */

/* A thing that the camera may look at: a ball with centre at and radius reach. */
typedef struct kit_sight { double at[3], reach; } kit_sight;

enum { KIT_SIGHTS = 64, KIT_LAMPS = 8 };
/* A scene is built in metres, y up, near the origin, one object a thing. Its rows say where the eye may stand and which
   things it may look at. */
typedef struct kit_plot {
    kit_build  b;
    double     stand[4];                   /* x0, z0, x1, z1: the eye is above this rectangle */
    double     ceiling;                    /* the eye stays below it; 0: open sky */
    double     ground[8];                  /* the numbers of the row GROUND; the fifth is the seed of its noise */
    int        sights, lamps;
    kit_sight  sight[KIT_SIGHTS];
    double     lamp[KIT_LAMPS][3];         /* places for point lights */
} kit_plot;

/* Returns the ground's height there; 0 if no row makes a ground. */
double kit_ground_at(const kit_plot *p, double x, double z);

/* Sets the camera and the radius of the finished scene; seed chooses the direction of view and the radius as a share of
   the image's height. Returns -1 if there is no memory. */
int    kit_look(kit_scene *s, kit_plot *p, unsigned seed);

/* ---- >>rows ---------------------------------------------------------------------------------------------------- */

/* A row of tables/. A row THING begins a thing, and all rows up to the next THING are its parts. Other rows place a
   thing or a model, make a shape, or set a property of the scene. Columns are text:

   name    of a thing or a part. Chances are drawn from the names of the parts that lead to a row and the number of
           its copy, so rows and files may be moved, and rows added, without a change to any other.
   at      "COUNT: X Y Z TURN TILT SCALE clear R": COUNT copies (1) at a place in the thing's own axes, tilted about
           x, then turned about y, in degrees; a copy nearer to a claimed disc than R is put elsewhere, or left out.
           Numbers that are missing are 0, SCALE is 1.
   numbers of a THING, "name=number ..": its variables, unless the row that places it gives other values. Of PUT and
           PART "thing|thing name=number ..": the thing, by chance one of several. Of a MODEL names of the catalogue and
           a height in metres; without it, the model's own. Of a shape its measures: see the list of verbs.
   paint   of a shape: a palette; all parts of a thing with the same palette have the same colour of it.
   odds    the chance that the row is made, 1 if it is empty.

   A number is an expression without blanks: + - * / ( ), variables; a~b any number between two; a|b|c one of several;
   a<b, a>b, a=b 1 or 0; sin(x), cos(x), tan(x) in degrees, abs(x), int(x), from(x) 1 from 0 on, else 0, max(x,y),
   pow(x,y). Variables of a copy: i its number, n the number of copies, t = (i + 0.5) / n, u = i / (n - 1), sx and sz the
   signs of four corners, x and z its place, g the height of the ground there. Variables of enclosing things are visible,
   too. */
typedef struct kit_row {
    const char *name;
    int verb;
    const char *at, *numbers, *paint, *odds;
} kit_row;

enum {
    THING,
    PUT,                                   /* a thing that is an object of its own; the camera may look at it */
    PART,                                  /* a thing that is part of the enclosing thing's object */
    MODEL,                               /* a model of the catalogue: an object of its own; the camera may look at it */
    /* shapes */
    BOX,                                   /* numbers: x0 y0 z0 x1 y1 z1 bevel */
    ROD,                                   /* numbers: x0 y0 z0 x1 y1 z1 radius, sides around */
    TURNED,                        /* numbers: r y r y .., radii and heights of a profile about y, from below upwards */
    BALL,                                  /* numbers: x y z of the centre, radii rx ry rz, cells */
    CUSHION,                               /* numbers: x y z, half sides, round from 0 to 1, cells */
    RING,                                  /* numbers: x y z radius, tube radius; a lying ring */
    WIRE,                                  /* numbers: x0 y0 z0 x1 y1 z1 sag radius */
    PRISM,                         /* numbers: height x z x z .., a convex outline, counter-clockwise seen from above */
    LEAF,                                  /* numbers: width length bend cells pointed; a sheet along z */
    PANE,                           /* numbers: x0 y0 z0 x1 y1 z1; a flat sheet between two corners, upright or level */
    CLOTH,                                 /* numbers: width height waves depth; a hanging sheet, folded */
    ROCK,                                  /* numbers: radii rx ry rz, roughness, cells, flat facets or not */
    /* properties of the scene */
    GROUND,                               /* numbers: x0 z0 x1 z1 cells height width octaves of noise; height 0: flat */
    LAMP,                                  /* x y z */
    STAND,                                 /* numbers: x0 z0 x1 z1, the rectangle in which the eye may be */
    CEILING,                               /* height */
    SIGHT                                  /* x y z reach */
};

/* Builds a thing of the tables at the origin, with chances by seed. err must be empty; it gets the fault: a row that
   cannot be read, with its name; a model whose package is missing; no memory. */
void   kit_build_thing(kit_plot *p, const char *thing, uint32_t seed, kit_error *err);
/* Adds a model of the catalogue on a floor, scaled to half a diagonal of 1, the size that camera placement expects;
   seed chooses the points to look at. Returns the length of that 1 in metres; 0: err names the fault. */
double kit_build_model(kit_plot *p, const char *name, uint32_t seed, kit_error *err);
/* Tables of rows; each ends with a row without a name. */
extern const kit_row kit_rows_shared[], kit_rows_rooms[], kit_rows_streets[], kit_rows_halls[], kit_rows_foliage[],
    kit_rows_machines[], kit_rows_scans[], kit_rows_terrain[];

/* ---- >>models -------------------------------------------------------------------------------------------------- */

/* Reads a model of a package, "armchair3" or "scopia/armchair3", unscaled: upright, on y = 0, its middle on the y axis,
   in metres. Models in archives are unpacked once into the user's cache folder. */
int    kit_catalogue_read(kit_mesh *mesh, const char *name, int length, kit_error *err);
int    kit_catalogue_has(const char *name, int length);

#endif
