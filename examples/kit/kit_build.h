/* kit_build.h - shared by shapes.c, parts.c, buildings.c, thin.c, solids.c, scenes.c, scene.c and kit_seed.h: scenes
   while they are built. Private to them. */
#ifndef KIT_BUILD_H
#define KIT_BUILD_H

#include "kit/kit.h"

/* ---- >>shapes: all in local coordinates, see kit_frame ------------------------------------------------------ */

/* Local coordinates of shapes, which are scaled, turned by a matrix, then moved to at. scale 0: the world's own. */
typedef struct kit_frame { double at[3], turn[3][3], scale; } kit_frame;

typedef struct kit_build {
    kit_scene scene;
    size_t   capacity;                     /* triangles */
    uint32_t object;                       /* number of the object that is being built */
    int      failed;                       /* out of memory */
    double   at[3], turn, tilt;            /* turned by tilt degrees about x, then by turn about y, then moved by at */
    kit_frame frame;                       /* the enclosing coordinates, applied after at, turn and tilt */
    float    albedo[3];
    uint32_t random;
} kit_build;

typedef struct kit_vertex { double p[3], n[3]; } kit_vertex;
/* One moulding of a turned profile, from (r0, y0) up to (r1, y1), which swells outwards by bulge at its middle. */
typedef struct kit_moulding { double r0, y0, r1, y1, bulge; } kit_moulding;

void   kit_colour(kit_build *b, double r, double g, double blue);
void   kit_place_at(kit_build *b, double x, double y, double z, double turn);
void   kit_place_tilted(kit_build *b, double x, double y, double z, double turn, double tilt);
double kit_chance(kit_build *b);           /* returns a random number in [0, 1), the same on every machine */
double kit_between(kit_build *b, double low, double high);
void   kit_rotate(const kit_build *b, const double in[3], double out[3]);
void   kit_pose(const kit_build *b, const float from[16], float to[16]);     /* to = from, moved as b's shapes are */

/* Shapes built between enter and leave stand in coordinates of their own: scaled by size, tilted about x, turned by
   degrees about y, then moved. Pairs may nest. enter returns leave's argument. Both set at, turn and tilt back to 0. */
kit_frame kit_enter(kit_build *b, double x, double y, double z, double turn, double size);
kit_frame kit_enter_tilted(kit_build *b, const double at[3], double turn, double tilt, double size);
void   kit_leave(kit_build *b, kit_frame before);

/* Adds a triangle, wound to agree with its vertices' normals, unless it has no area. */
void   kit_triangle(kit_build *b, const kit_vertex *v0, const kit_vertex *v1, const kit_vertex *v2);
/* Adds a flat quad whose front is where the corners run counter-clockwise. */
void   kit_quad(kit_build *b, const double corner[4][3]);
void   kit_box(kit_build *b, double x0, double y0, double z0, double x1, double y1, double z1);
/* Adds a horizontal rectangle whose front is its upper side. */
void   kit_level(kit_build *b, double x0, double z0, double x1, double z1, double y);
/* Adds a flat quad, u = v = 0 at corner 0, u = 1 at corner 1, u = v = 1 at corner 2, cut at the given u and v. */
void   kit_sheet(kit_build *b, const double c[4][3], const double *u, int nu, const double *v, int nv);
#define KIT_CUTS(a) a, (int)(sizeof a / sizeof *a) - 1
/* u and v at which big planes are cut: finer towards their middle, so that a rasteriser interpolates precisely there */
static const double kit_both[] = { 0, 0.35, 0.45, 0.485, 0.495, 0.49875, 0.50125, 0.505, 0.515, 0.55, 0.65, 1 };
/* Writes the point and normal of a surface at u, v in [0, 1]; kit_patch cuts the surface into nu x nv cells. */
typedef void kit_surface(const void *shape, double u, double v, kit_vertex *out);
void   kit_patch(kit_build *b, int nu, int nv, kit_surface *surface, const void *shape);
/* Writes a point of a sphere of radius shape[0] about the origin. */
void   kit_sphere_surface(const void *shape, double u, double v, kit_vertex *out);
/* Writes a point of a lying torus; shape[0] is the radius to the tube's middle, shape[1] the tube's radius. */
void   kit_torus_surface(const void *shape, double u, double v, kit_vertex *out);
void   kit_turned(kit_build *b, const kit_moulding *profile, int count, int around);
void   kit_cylinder(kit_build *b, double radius, double height, int around);             /* closed, on y = 0 */

/* Begins a new object. The first object also has all earlier shapes. casts: 0, 1, or -1, by kit_scene_load's rule. */
void   kit_begin_object(kit_build *b, const char *name, int casts);
/* Writes object k's triangles and bounds for the transform m, but not the mesh's bounds. */
void   kit_set_place(kit_scene *s, int k, const float m[16]);
/* Writes object k's triangles and bounds for m, raised until the object is above a level. */
void   kit_place_above(kit_scene *s, int k, const float m[16], double level);
/* Makes object k's present triangles a shape of its own. */
int    kit_own_shape(kit_scene *s, int k);
/* Completes the objects from number first on (shapes, bounds and whether they cast), and the mesh's bounds. */
int    kit_complete(kit_scene *s, int first);

/* ---- >>parts: more shapes, for scenes by seed ---------------------------------------------------------------- */

/* Returns smooth noise in [-1, 1], features about 1 wide; fractal adds octaves, each half as wide and strong. */
double kit_noise(unsigned seed, double x, double y, double z);
double kit_fractal(unsigned seed, double x, double y, double z, int octaves);
/* Adds a closed round tube through count points, at most 256, with unrounded corners. */
void   kit_tube(kit_build *b, const double at[][3], int count, double radius, int around);
/* Adds a tube from one point to another that sags by sag in the middle. */
void   kit_cable(kit_build *b, const double from[3], const double to[3], double sag, double radius, int around);
/* Adds a closed box of half sides half with rounded corners; round: from 0 (a box) to 1 (a ball). */
void   kit_cushion(kit_build *b, const double half[3], double round, int cells);
/* Adds a box whose edges are cut off at 45 degrees; the cut is bevel wide. */
void   kit_bevelled(kit_build *b, double x0, double y0, double z0, double x1, double y1, double z1, double bevel);
/* Adds a closed prism from y = 0 up; outline: convex, in x and z, counter-clockwise as seen from above. */
void   kit_prism(kit_build *b, const double outline[][2], int count, double height);
/* Adds a flat sheet without thickness that leans: width along x, length along z from the origin, bent down by bend
   radians over its length; if pointed, it has a point at both ends, as a leaf. */
void   kit_leaf(kit_build *b, double width, double length, double bend, int cells, int pointed);
/* A kit_height returns the height of ground at x, z; kit_ground adds it over a rectangle, with smooth normals. */
typedef double kit_height(const void *of, double x, double z);
void   kit_height_field(kit_build *b, const double rectangle[4], int nx, int nz, kit_height *height, const void *of);

/* ---- >>scenes ------------------------------------------------------------------------------------------------ */

static const double KIT_GAP = 0.001;       /* metres between a thing and the surface that it rests on */

typedef struct kit_builtin {
    const char *name, *about;
    void  (*make)(kit_build *);
    float   eye[3], target[3], fovy, znear, radius;
} kit_builtin;
void   kit_build_room(kit_build *b);        /* buildings.c */
void   kit_build_colonnade(kit_build *b);
void   kit_build_grass(kit_build *b);       /* thin.c */
void   kit_build_slats(kit_build *b);
void   kit_build_cornell(kit_build *b);     /* solids.c */
void   kit_build_columns(kit_build *b);
void   kit_build_plates(kit_build *b);
void   kit_build_pebbles(kit_build *b);
void   kit_build_boxes(kit_build *b);
void   kit_build_spheres(kit_build *b);
void   kit_build_blocks(kit_build *b);
void   kit_build_casters(kit_build *b);
void   kit_build_crowd(kit_build *b);
const kit_builtin *kit_builtin_at(int i);  /* NULL past the last */

/* Loads "random:SEED", "random:KIND:SEED", "model:NAME" or "model:NAME:SEED" as a complete scene (seeds.c). */
int    kit_load_seeded(kit_scene *scene, const char *name, kit_error *err);
/* Checks that all things and models exist that the rows of tables/ name (grammar.c). */
int    kit_check_rows(kit_error *err);

#endif
