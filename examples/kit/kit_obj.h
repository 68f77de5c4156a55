/* kit_obj.h - what the readers of models share: growing arrays, names, triangles and their objects. Private to them. */
#ifndef KIT_OBJ_H
#define KIT_OBJ_H

#include "kit/kit.h"

/* A mesh farther from 0 than so many of its diagonals is read about its own middle. Numbers that lie farther apart than
   such a share of it are said to be coarse; floats do where that is not done, from 170 diagonals on. */
static const double KIT_AWAY = 100, KIT_COARSE = 2e-5;

/* What is read, for errors: its path, and in a text the line, else 0. */
typedef struct kit_source { const char *path; int line; kit_error *err; } kit_source;

static const float KIT_FARTHEST = 1e15f;   /* squares of distances are floats, too */
extern const float kit_grey[3];            /* of what has no material */

typedef struct kit_array { void *data; size_t count, capacity; } kit_array;
/* Room for n more elements; the first of them, or NULL with the error written. */
void    *kit_array_add(kit_array *a, size_t n, size_t element, const kit_source *from);

typedef struct kit_key { const char *bytes; size_t length; } kit_key;

/* Triangles as they are found. A name that is added is that of all triangles until the next; way 0 and way 1 are those
   of o and g lines, or what another format has in their place. */
typedef struct kit_soup {
    kit_array position, normal, albedo;    /* 9, 9, 3 floats a triangle */
    /* float[3], and 3 uint32_t a triangle, which name them; none: places alone say what hangs together */
    kit_array vertices, vertex;
    kit_array named[2];                    /* kit_key, whose bytes stay until kit_soup_objects */
    kit_array line[2];                     /* uint32_t a triangle: which of them */
    kit_array number;                      /* uint32_t a triangle: its object's */
    kit_array objects;                     /* kit_object */
    double origin[3];                      /* the mesh's */
} kit_soup;
int  kit_soup_name(kit_soup *s, int way, kit_key name, const kit_source *from);
/* A normal that is NULL or 0 becomes the face's. 1; or 0: it has no area, and is left out; or -1. */
int  kit_soup_triangle(kit_soup *s, const float *const position[3], const float *const normal[3], const float albedo[3],
                       const kit_source *from);
/* Who they are, as kit_mesh_obj says; of one triangle at least. */
int  kit_soup_objects(kit_soup *s, const kit_source *from);
/* Refuses what has no triangles. points: so many vertices that no line or face joins, a cloud. */
int  kit_soup_empty(size_t points, const kit_source *from);
/* What was found, with its bounds; object and objects NULL: not wanted. */
void kit_soup_take(kit_soup *s, kit_mesh *mesh, kit_object **object, int *objects);
void kit_soup_free(kit_soup *s);

double kit_diagonal(const float lower[3], const float upper[3]);

/* 1: what was read about an origin lies farther from it than KIT_AWAY; the origin is then its middle, about which it is
   to be read anew. Twice at most: floats find a middle to 24 bits, and doubles have 53. */
int  kit_origin_move(double origin[3], const float lower[3], const float upper[3]);

enum { KIT_NOTE = 512 };

/* One sentence more, without its stop, as far as there is room. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void kit_note(char *note, const char *format, ...);
/* That one, where numbers of a kind that are so far apart are coarse beside the bounds. */
void kit_note_gap(char *note, const char *kind, double gap, const float lower[3], const float upper[3]);

#endif
