/* kit_obj.h - shared by the readers of models: growing arrays, names, triangles and their objects. Private to them. */
#ifndef KIT_OBJ_H
#define KIT_OBJ_H

#include "kit/kit.h"

/* A mesh farther from 0 than KIT_AWAY of its diagonals is read about its own middle. The note calls numbers coarse if
   they are spaced wider than KIT_COARSE of the diagonal; floats are, from 170 diagonals on, if a mesh is not moved. */
static const double KIT_AWAY = 100, KIT_COARSE = 2e-5;

/* The input, for error messages: its path, and in a text the line, else 0. */
typedef struct kit_source { const char *path; int line; kit_error *err; } kit_source;

static const float KIT_FARTHEST = 1e15f;   /* the square of a distance must fit a float */
extern const float kit_grey[3];            /* albedo of triangles without a material */

typedef struct kit_array { void *data; size_t count, capacity; } kit_array;
/* Makes room for n more elements; returns the first of them, or NULL with the error written. */
void    *kit_array_add(kit_array *a, size_t n, size_t element, const kit_source *from);

typedef struct kit_key { const char *bytes; size_t length; } kit_key;

/* Triangles in the order of the file. An added name is the name of all triangles until the next one; way 0 and way 1
   are the names of o and g lines, or of their equivalents in another format. */
typedef struct kit_soup {
    kit_array position, normal, albedo;    /* 9, 9, 3 floats a triangle */
    /* float[3]; 3 uint32_t a triangle, which index these; none: only equal positions connect triangles */
    kit_array vertices, vertex;
    kit_array named[2];                    /* kit_key, whose bytes stay until kit_soup_objects */
    kit_array line[2];                     /* uint32_t a triangle: its index in named */
    kit_array number;                      /* uint32_t a triangle: its object's */
    kit_array objects;                     /* kit_object */
    double origin[3];                      /* the mesh's */
} kit_soup;
int  kit_soup_name(kit_soup *s, int way, kit_key name, const kit_source *from);
/* A normal that is NULL or 0 becomes the face's. 1: added; 0: left out because it has no area; -1: failed. */
int  kit_soup_triangle(kit_soup *s, const float *const position[3], const float *const normal[3], const float albedo[3],
                       const kit_source *from);
/* Finds the objects as kit_mesh_obj describes; there must be at least one triangle. */
int  kit_soup_objects(kit_soup *s, const kit_source *from);
/* Fails if there are no triangles. points: the number of vertices without a line or face, a point cloud. */
int  kit_soup_empty(size_t points, const kit_source *from);
/* Moves the result into mesh, with its bounds; object and objects may be NULL. */
void kit_soup_take(kit_soup *s, kit_mesh *mesh, kit_object **object, int *objects);
void kit_soup_free(kit_soup *s);

double kit_diagonal(const float lower[3], const float upper[3]);

/* 1: a mesh read about an origin is farther from it than KIT_AWAY. origin is then the mesh's middle, about which it
   must be read again, at most twice: floats find a middle to 24 bits, and doubles have 53. */
int  kit_origin_move(double origin[3], const float lower[3], const float upper[3]);

enum { KIT_NOTE = 512 };

/* Appends a sentence, given without its full stop, as far as there is room. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void kit_note(char *note, const char *format, ...);
/* Appends that numbers of a kind are coarse, if gap, their spacing, is large beside the bounds. */
void kit_note_gap(char *note, const char *kind, double gap, const float lower[3], const float upper[3]);

#endif
