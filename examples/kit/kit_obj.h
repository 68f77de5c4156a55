/* kit_obj.h - what the readers of models share: lines of OBJ and MTL, materials, triangles and their objects. Private
   to them. */
#ifndef KIT_OBJ_H
#define KIT_OBJ_H

#include "kit/kit.h"
#include <sys/types.h>

/* ---- >>text */

#define KIT_CONTINUED '\1'                 /* stands where a backslash and a line end were */

/* A cursor over lines: at moves along the present one, end is where it stops. */
typedef struct kit_text {
    const char *path, *at, *end, *next, *last;
    int         line;                      /* that the present one starts on */
    int         following;
    kit_error  *err;
} kit_text;

static const float KIT_FARTHEST = 1e15f;   /* squares of distances are floats, too */

static inline int kit_blank(char c)
{
    return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f' || c == KIT_CONTINUED;
}

/* A backslash at the end of a line continues it; not in a comment, where Windows paths may end so. Lines may end in CR
   alone. */
void     kit_text_prepare(char *data, size_t size);
kit_text kit_text_start(const char *path, const char *data, size_t size, kit_error *err);
void     kit_skip_blanks(kit_text *t);
int      kit_at_value(kit_text *t);                    /* after blanks: neither the line's end nor a comment */
int      kit_next_line(kit_text *t);
int      kit_keyword(kit_text *t, const char *word);   /* 1: the line goes on with it, and the cursor is behind it */
int      kit_text_fail(const kit_text *t, const char *what);
int      kit_number(kit_text *t, float *out, const char *what);

/* ---- >>growing arrays */

/* ---- growing arrays ------------------------------------------------------------------------------------------ */

typedef struct kit_array { void *data; size_t count, capacity; } kit_array;
/* Room for n more elements; the first of them, or NULL with the error written. */
void    *kit_array_add(kit_array *a, size_t n, size_t element, const kit_text *t);

/* ---- >>keys */

/* ---- keys ---------------------------------------------------------------------------------------------------- */

typedef struct kit_key { const char *bytes; size_t length; } kit_key;

/* The numbers of keys, found by their bytes. */
typedef struct kit_table { const kit_key *keys; uint32_t *slot; size_t size; uint64_t secret[2]; } kit_table;
int       kit_table_open(kit_table *t, const kit_key *keys, size_t count);
/* Where a key equal to k is, or would be. */
uint32_t *kit_table_slot(const kit_table *t, const kit_key *k);
/* Key i, unless one that equals it is in there: the number of the one that is in there now. */
uint32_t  kit_table_add(kit_table *t, uint32_t i);

/* ---- >>materials */

/* ---- materials ----------------------------------------------------------------------------------------------- */

/* way 0: by whole names, way 1: by what stands before a comment */
typedef struct kit_materials {
    kit_array named[2];                        /* key */
    kit_array albedo;                          /* float[3] */
    kit_array text;                            /* char *: the files, which the names are in */
    kit_table found[2];
} kit_materials;

/* A file that an mtllib line names and that is there. */
typedef struct kit_mtllib { char *path; struct { dev_t device; ino_t file; } id; } kit_mtllib;

extern const float kit_grey[3];            /* of what has no material */
/* The rest of the line without blanks at its ends. Names may hold blanks and '#' ("Material #25"): see
   kit_without_comment. */
kit_key  kit_rest(kit_text *t);
kit_key  kit_without_comment(kit_key name);
int      kit_mtllib_add(kit_array *mtllibs, const kit_text *t, kit_key name);
/* A file that is named more than once, however it is spelled, is read once, where the last line that names it has it:
   its materials count then as if it were read each time. */
int      kit_mtllibs_read(kit_materials *m, const kit_array *mtllibs, const kit_text *t);
/* All are there: from now on they are found. The last of one name goes in first, so that it counts. */
int      kit_materials_close(kit_materials *m, const kit_text *t);
const float *kit_material_find(const kit_materials *m, kit_key name);
void     kit_materials_free(kit_materials *m);

/* ---- >>soup */

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
} kit_soup;
int  kit_soup_name(kit_soup *s, int way, kit_key name, const kit_text *t);
/* A normal that is NULL or 0 becomes the face's. 1; or 0: it has no area, and is left out; or -1. */
int  kit_soup_triangle(kit_soup *s, const float *const position[3], const float *const normal[3], const float albedo[3],
                       const kit_text *t);
/* Who they are, as kit_mesh_obj says; of one triangle at least. */
int  kit_soup_objects(kit_soup *s, const kit_text *t);
/* What was found, with its bounds; object and objects NULL: not wanted. */
void kit_soup_take(kit_soup *s, kit_mesh *mesh, kit_object **object, int *objects);
void kit_soup_free(kit_soup *s);

#endif
