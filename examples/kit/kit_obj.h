/* kit_obj.h - shared by the readers of models: growing arrays, names, triangles and their objects. Private to them. */
#ifndef KIT_OBJ_H
#define KIT_OBJ_H

#include "kit/kit.h"

/* A mesh farther from 0 than KIT_AWAY of its diagonals is read relative to its own middle. The note calls its floats
   coarse if their spacing is above KIT_COARSE of the diagonal, which begins at 170 diagonals if a mesh is not moved. */
static const double KIT_AWAY = 100, KIT_COARSE = 2e-5;

/* The place in the input, for error messages: a file's path and, if it is text, the line; else 0. */
typedef struct kit_source { const char *path; int line; kit_error *err; } kit_source;

static const float KIT_FARTHEST = 1e15f;   /* largest coordinate; the square of a distance must fit a float */
extern const float kit_grey[3];            /* albedo of triangles without a material */

typedef struct kit_array { void *data; size_t count, capacity; } kit_array;
/* Makes room for n more elements; returns the first of them, or NULL after it has written the error. */
void    *kit_array_add(kit_array *a, size_t n, size_t element, const kit_source *from);

typedef struct kit_key { const char *bytes; size_t length; } kit_key;

/* Triangles in the order of the file. An added name is the name of all triangles until the next one; way 0 and way 1
   are the names of o and g lines, or of their equivalents in another format. */
typedef struct kit_soup {
    kit_array position, normal, albedo;    /* 9, 9, 3 floats a triangle */
    /* 3 floats a vertex; 3 uint32_t a triangle, which index these; empty: only equal positions connect triangles */
    kit_array vertices, vertex;
    kit_array named[2];                    /* elements are kit_key; their bytes stay until kit_soup_objects */
    kit_array line[2];                     /* uint32_t a triangle: the index of its name in named */
    kit_array number;                      /* uint32_t a triangle: the number of its object */
    kit_array objects;                     /* kit_object */
    double origin[3];                      /* the mesh's */
} kit_soup;
int  kit_soup_name(kit_soup *s, int way, kit_key name, const kit_source *from);
/* Adds a triangle. A normal that is NULL or 0 becomes the face's. 1: added; 0: left out, it has no area; -1: failed. */
int  kit_soup_triangle(kit_soup *s, const float *const position[3], const float *const normal[3], const float albedo[3],
                       const kit_source *from);
/* Finds the objects as kit_mesh_obj describes; there must be at least one triangle. */
int  kit_soup_objects(kit_soup *s, const kit_source *from);
/* Fails and says why there are no triangles. points: the number of vertices without a line or face, a point cloud. */
int  kit_soup_empty(size_t points, const kit_source *from);
/* Moves the triangles into mesh, with their bounds; object and objects may be NULL. */
void kit_soup_take(kit_soup *s, kit_mesh *mesh, kit_object **object, int *objects);
void kit_soup_free(kit_soup *s);

double kit_diagonal(const float lower[3], const float upper[3]);

/* Returns 1 if a mesh that was read about an origin is farther from it than KIT_AWAY. origin is then the mesh's middle,
   about which it must be read again, at most twice: floats find a middle to 24 bits, and doubles have 53. */
int  kit_origin_move(double origin[3], const float lower[3], const float upper[3]);

enum { KIT_NOTE = 512 };

/* Appends a sentence, given without its full stop, to a note as far as there is room. */
#if defined(__GNUC__)
__attribute__((format(printf, 2, 3)))
#endif
void kit_note(char *note, const char *format, ...);
/* Appends that numbers of a kind are coarse, if their spacing gap is large compared with the bounds. */
void kit_note_gap(char *note, const char *kind, double gap, const float lower[3], const float upper[3]);

#endif
