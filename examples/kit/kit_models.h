/* kit_models.h - shared by models.c, mesh.c, gltf.c, assimp.c, texture.c and cards.c. Private to them. */
#ifndef KIT_MODELS_H
#define KIT_MODELS_H

#include "kit/kit_obj.h"

/* ---- >>models */

/* Reads the triangles of an OBJ or of a format that Assimp reads. note: KIT_NOTE characters, as kit_scene.note. */
int kit_model_read(kit_mesh *mesh, kit_object **object, int *objects, char *note, const char *path, kit_error *err);

/* ---- >>mesh */

/* Returns the text of an OBJ that is far from 0, with its vertices moved so that their middle, origin before that, is
   at 0. The caller calls free(). NULL: the OBJ is near 0, or cannot be read. */
char *kit_obj_moved(double origin[3], const char *path);

/* ---- >>gltf */

/* The nodes of a glTF; text: all of its JSON, in which node[i] points to node i. */
typedef struct kit_gltf {
    char *data, *text;
    kit_array node;                        /* const char * */
} kit_gltf;

/* Reads a glTF's JSON alone; the caller calls free(data). */
int kit_gltf_text(kit_gltf *g, const char *path, kit_error *err);
/* Reads a glTF's JSON and nodes; if the file is damaged, the nodes before the damage. */
int kit_gltf_open(kit_gltf *g, const char *path, kit_error *err);
void kit_gltf_close(kit_gltf *g);
/* Return a part of a JSON value, which may be NULL: its member of a name; its first element, and the next element.
   NULL: there is none. */
const char *kit_gltf_member(const char *object, const char *name);
const char *kit_gltf_first(const char *array);
const char *kit_gltf_next(const char *element);
/* Returns the node whose number a JSON element holds. */
const char *kit_gltf_node(const kit_gltf *g, const char *element);
/* Returns the JSON array of the root nodes of the scene that is shown. */
const char *kit_gltf_roots(const kit_gltf *g);
/* Returns the number of numbers in an array; writes at most `most` of them. */
size_t kit_gltf_numbers(double *out, size_t most, const char *array);
/* Writes a node's transform as rows, from its matrix or its translation, rotation and scale. */
void kit_gltf_place(double m[3][4], const char *node);

/* ---- >>assimp */

/* Returns the version of Assimp, which reads models; NULL: this build has none. */
const char *kit_assimp_version(void);
int kit_assimp_takes(const char *ending); /* ".ply": whether Assimp reads such files */
/* Reads all triangles and objects of a model of size bytes in that format. It may end the process on a damaged file. */
int kit_assimp_read(kit_soup *soup, char *note, size_t size, const char *path, const char *format, kit_error *err);

/* ---- >>texture */

/* An image of a texture: RGBA, 8 bits each, the first row on top. */
typedef struct kit_picture {
    int width, height;
    unsigned char *texel;
} kit_picture;

/* Reads PNG, JPEG, TGA or BMP; why: what is wrong with the data. */
int kit_picture_read(kit_picture *t, const void *data, size_t size, const char **why);
void kit_picture_free(kit_picture *t);
/* Writes the mean colour, linear, of the texels whose alpha is at least `least`; of all texels if there are none. */
void kit_picture_mean(const kit_picture *t, int least, float rgb[3]);
/* Returns whether alpha is a mask: some of it is 0, and nearly all of it is 0 or 255. */
int kit_picture_cuts(const kit_picture *t);

/* ---- >>cards */

/* The opaque texels of a texture as a table of sums: how many there are above and left of each corner of texels. */
typedef struct kit_mask {
    int width, height;
    uint32_t *sum;
    double owed;          /* area of opaque texels that were left out, less that of transparent texels that were kept */
} kit_mask;

enum { KIT_REPEAT, KIT_MIRROR, KIT_CLAMP };

/* Marks texels as opaque if their alpha is at least `least`, or in an opacity map without alpha their brightness. */
int kit_mask_make(kit_mask *m, const kit_picture *t, int bright, int least);
void kit_mask_free(kit_mask *m);

/* Cuts a triangle to its opaque texels and calls piece for each remaining triangle: for its three corners, the weights
   of the corners 1 and 2. It cuts along texels, or along squares of them, so large that there are at most `most`; whole
   squares are kept or left out so that the kept area is the opaque area. uv: v is up. */
typedef int kit_piece(void *context, const double weight[3][2]);
int kit_card_cut(kit_mask *m, const int wrap[2], const double uv[3][2], double most, kit_piece *piece,
                 void *context);

#endif
