/* kit_models.h - what models.c, mesh.c, gltf.c, assimp.c, texture.c and cards.c share. Private to them. */
#ifndef KIT_MODELS_H
#define KIT_MODELS_H

#include "kit/kit_obj.h"

/* ---- >>models */

/* The triangles of an OBJ, or of what else can be read. note: KIT_NOTE characters, as a scene has it. */
int kit_model_read(kit_mesh *mesh, kit_object **object, int *objects, char *note, const char *path, kit_error *err);

/* ---- >>mesh */

/* The text of an OBJ that lies far from 0, its vertices about its middle, which is then the origin; free(). NULL: it
   lies near, or cannot be read. */
char *kit_obj_moved(double origin[3], const char *path);

/* ---- >>gltf */

/* What a glTF says of its nodes; text: all of it, in which node[i] begins. */
typedef struct kit_gltf {
    char *data, *text;
    kit_array node;                        /* const char * */
} kit_gltf;

/* Its JSON alone; free(data). */
int kit_gltf_text(kit_gltf *g, const char *path, kit_error *err);
/* Its nodes, too; of one that is damaged those before the damage. */
int kit_gltf_open(kit_gltf *g, const char *path, kit_error *err);
void kit_gltf_close(kit_gltf *g);
/* Of a value, which may be NULL: the member of a name; the first element, and the next one; NULL: there is none. */
const char *kit_gltf_member(const char *object, const char *name);
const char *kit_gltf_first(const char *array);
const char *kit_gltf_next(const char *element);
/* The node that an element names. */
const char *kit_gltf_node(const kit_gltf *g, const char *element);
/* Those of the scene that is shown: an array. */
const char *kit_gltf_roots(const kit_gltf *g);
/* How many numbers an array has; so many of them. */
size_t kit_gltf_numbers(double *out, size_t most, const char *array);
/* Rows, from its matrix or its translation, rotation and scale. */
void kit_gltf_place(double m[3][4], const char *node);

/* ---- >>assimp */

/* Version of the library that reads models; NULL: this build has none. */
const char *kit_assimp_version(void);
int kit_assimp_takes(const char *ending); /* ".ply": whether it has a reader for such files */
/* All triangles of a model of size bytes, whose format is called that, and its objects. On a damaged file it may end
   the process. */
int kit_assimp_read(kit_soup *soup, char *note, size_t size, const char *path, const char *format, kit_error *err);

/* ---- >>texture */

/* RGBA, 8 bits each, the first row on top. */
typedef struct kit_picture {
    int width, height;
    unsigned char *texel;
} kit_picture;

/* PNG, JPEG, TGA or BMP; why: what is wrong with it. */
int kit_picture_read(kit_picture *t, const void *data, size_t size, const char **why);
void kit_picture_free(kit_picture *t);
/* Linear, of the texels whose alpha is at least so much; of all if there are none. */
void kit_picture_mean(const kit_picture *t, int least, float rgb[3]);
/* Whether alpha tells apart what is there and what is not: some of it is 0, nearly all of it is 0 or 255. */
int kit_picture_cuts(const kit_picture *t);

/* ---- >>cards */

/* Which texels are there, as sums over all above and left of each corner of texels. */
typedef struct kit_mask {
    int width, height;
    uint32_t *sum;
    double owed;                           /* texels that were there and not given, less those given that were not */
} kit_mask;

enum { KIT_REPEAT, KIT_MIRROR, KIT_CLAMP };

/* Those whose alpha is at least so much; of a picture of opacity without alpha, whose brightness is. */
int kit_mask_make(kit_mask *m, const kit_picture *t, int bright, int least);
void kit_mask_free(kit_mask *m);

/* What is left of a triangle where its texels are there, as triangles: weights of its corners 1 and 2, three times.
   Cut along texels, or along squares of them, so large that there are at most so many of them: they are given or not so
   that as much is left as is there. uv: v is up. */
typedef int kit_piece(void *context, const double weight[3][2]);
int kit_card_cut(kit_mask *m, const int wrap[2], const double uv[3][2], double most, kit_piece *piece,
                 void *context);

#endif
