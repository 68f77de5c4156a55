/* assimp.c - reads models by Assimp as triangles in world space. Declared in kit_models.h. With KIT_ASSIMP it is
   compiled against the library, else without; no other file knows the library.

   Taken: triangles of all nodes in the file's own pose, for glTF with its initial morph weights; names of nodes and
   meshes, for objects; normals if there are any; base or diffuse colours, times the mean of their texture and the
   corners' colours. Cards are cut by alpha. Not taken: morphs of other formats, animation, lights, cameras, emission,
   glass. Units are the file's; so are axes, except for FBX, and for formats that Assimp turns upright itself (Collada,
   IFC, 3DS).

   Assimp's numbers are floats. If a model is far from 0, an OBJ's text is moved before Assimp reads it, and a glTF's
   node transforms are taken from its JSON; the note says which numbers stay coarse. */
#include "kit/kit_models.h"
#include <stddef.h>

#ifndef KIT_ASSIMP

const char *kit_assimp_version(void) { return NULL; }

int kit_assimp_takes(const char *ending) { return !ending; }

int kit_assimp_read(kit_soup *soup, char *note, size_t size, const char *path, const char *format, kit_error *err)
{
    (void)soup;
    (void)note;
    (void)size;
    return kit_fail(err, "%s: is %s, which this build does not read", path, format);
}

#else

#include <assimp/GltfMaterial.h>
#include <assimp/cimport.h>
#include <assimp/config.h>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <assimp/version.h>
#include <fcntl.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

/* Limits, because a small file may name one mesh a thousand times. CELLS: squares of texels along which cards are cut,
   in all cards and in one card. */
enum {
    MOST_MESHES = 1 << 18,
    MOST_TRIANGLES = 1 << 24,
    MOST_WEIGHTS = 256,
    ALL_CELLS = 1 << 21,
    MOST_CELLS = 4096,
    LEAST_CELLS = 64,
    HALF = 128
};

enum { NO_MASK, WHERE_IT_CUTS, MASK };

/* A texture that was read: its mean colour and mask, of texels whose alpha is at least `least`. */
typedef struct known {
    struct aiString path;
    int bright, least, masked, cuts;
    float mean[3];
    kit_mask mask;
} known;

/* A material as the kit uses it. of: index of the texture that cuts it; -1: none. */
typedef struct look {
    float albedo[3];
    int grey, of, wrap[2];
    unsigned uv;
    double to_texture[2][3]; /* rows; from a mesh's texture coordinates to the texture's */
} look;

/* a transform as rows; the fourth would be 0 0 0 1 */
typedef struct place {
    double m[3][4];
} place;

/* A node of Assimp's, and the JSON of the same node in the glTF file. */
typedef struct twin {
    const struct aiNode *node;
    const char *json;
} twin;

typedef struct reader {
    const struct aiScene *scene;
    place root;       /* turns the model upright and moves it near 0 */
    double origin[3]; /* the point of the file that moves to 0 */
    kit_soup *soup;
    kit_source from;
    char *note;
    int missing, emits, gltf;
    kit_gltf json;
    kit_array twins;  /* elements: twin, sorted by node; empty: another format, or nodes that do not match the file's */
    int precise;        /* 1: transforms are taken from the glTF's JSON */
    int measures;       /* 1: triangles are only measured, to find the bounds */
    float lower[3], upper[3];
    double vertex_gap, node_gap; /* spacing of floats at vertices and at nodes' translations, in world space */
    kit_array textures; /* known */
    look *looks;        /* one a material */
    double cells;       /* how many squares a card is cut into at most */
    size_t meshes, triangles;
    float *position, *normal; /* of the mesh that is being added, 3 a vertex, in world space */
    char *used;               /* 1: a triangle uses the vertex */
    double weight[MOST_WEIGHTS]; /* weights of the morphs of the node that is being read */
    size_t weights;              /* number of weights; 0: the node has none of its own */
} reader;

const char *kit_assimp_version(void)
{
    static char version[64];
    snprintf(version, sizeof version, "%u.%u", aiGetVersionMajor(), aiGetVersionMinor());
    return version;
}

int kit_assimp_takes(const char *ending) { return aiIsExtensionSupported(ending); }

/* ---- >>textures -------------------------------------------------------------------------------------------------- */

static void remark(reader *r, const char *texture, const char *why)
{
    if (!strncmp(texture, "$texture_dummy", 14)) return; /* Assimp's placeholder */
    if (r->missing++) snprintf(r->note, KIT_NOTE, "%d textures could not be read, and are left out", r->missing);
    else kit_note(r->note, "texture %.150s %.60s, and is left out", texture, why);
}

/* Reads the file that a model names, by its path or from the model's folder. */
static int beside(char **data, size_t *size, const reader *r, const char *name)
{
    const char *slash = strrchr(r->from.path, '/'), *base = name + strlen(name);
    const int folder = slash ? (int)(slash - r->from.path) + 1 : 0;
    char path[4096];
    while (base > name && base[-1] != '/' && base[-1] != '\\') --base;
    for (int way = 0; way < 4; ++way) {
        const int own = way == 0 && (*name == '/' || *name == '\\');
        const int length = snprintf(path, sizeof path, "%.*s%s", own ? 0 : folder, r->from.path, way < 2 ? name : base);
        if (length < 0 || (size_t)length >= sizeof path) return -1;
        for (char *p = path + folder, *to = p; way > 0 && (*to = *p) != 0; ++p, ++to) {
            unsigned byte; /* a byte that is escaped as %20, as in URIs */
            if (*p == '\\') *to = '/';
            else if (way & 1 && *p == '%' && sscanf(p + 1, "%2x", &byte) == 1 && byte && p[1] && p[2]) {
                *to = (char)byte;
                p += 2;
            }
        }
        if (!kit_file_read(data, size, path, NULL)) return 0;
    }
    return -1;
}

/* Reads a texture that the model contains uncompressed. */
static int plain_texels(kit_picture *t, const struct aiTexture *from)
{
    const size_t texels = (size_t)from->mWidth * from->mHeight;
    if (texels > 1 << 26 || !(t->texel = malloc(4 * texels + 1))) return -1;
    t->width = (int)from->mWidth;
    t->height = (int)from->mHeight;
    for (size_t i = 0; i < texels; ++i) {
        const struct aiTexel *p = &from->pcData[i];
        const unsigned char rgba[4] = { p->r, p->g, p->b, p->a };
        memcpy(t->texel + 4 * i, rgba, 4);
    }
    return 0;
}

static const struct aiTexture *within(const struct aiScene *s, const char *path)
{
    const unsigned number = *path == '*' ? (unsigned)strtoul(path + 1, NULL, 10) : UINT32_MAX;
    const char *base = path + strlen(path);
    while (base > path && base[-1] != '/' && base[-1] != '\\') --base;
    if (number < s->mNumTextures) return s->mTextures[number];
    for (unsigned i = 0; i < s->mNumTextures; ++i) {
        const char *name = s->mTextures[i]->mFilename.data, *end = name + strlen(name);
        while (end > name && end[-1] != '/' && end[-1] != '\\') --end;
        if (*end && !strcmp(end, base)) return s->mTextures[i];
    }
    return NULL;
}

static int texture_open(kit_picture *t, reader *r, const char *path)
{
    const struct aiTexture *own = within(r->scene, path);
    const char *why = "is not there";
    char *data = NULL;
    size_t size = 0;
    int failed = -1;
    memset(t, 0, sizeof *t);
    if (own && own->mHeight) failed = plain_texels(t, own);
    else if (own) failed = kit_picture_read(t, own->pcData, own->mWidth, &why);
    else if (!beside(&data, &size, r, path)) failed = kit_picture_read(t, data, size, &why);
    free(data);
    if (failed) remark(r, path, why);
    return failed;
}

/* Returns a texture's index; -1: no memory. A texture is opened once for each combination of arguments; one that cannot
   be read is white. */
static int texture_known(reader *r, const struct aiString *path, int bright, int least, int masked)
{
    kit_picture t;
    for (size_t i = 0; i < r->textures.count; ++i) {
        const known *k = (known *)r->textures.data + i;
        if (!strcmp(k->path.data, path->data) && k->bright == bright && k->least == least && k->masked == masked)
            return (int)i;
    }
    known *k = kit_array_add(&r->textures, 1, sizeof *k, &r->from);
    if (!k) return -1;
    *k = (known){ .path = *path, .bright = bright, .least = least, .masked = masked, .mean = { 1, 1, 1 } };
    if (texture_open(&t, r, path->data)) return (int)r->textures.count - 1;
    kit_picture_mean(&t, least, k->mean);
    k->cuts = kit_picture_cuts(&t);
    const int makes = masked == MASK || (masked && k->cuts);
    const int failed = makes && kit_mask_make(&k->mask, &t, bright && !k->cuts, least);
    kit_picture_free(&t);
    if (failed) return kit_fail(r->from.err, "%s: no memory for its textures", r->from.path);
    return (int)r->textures.count - 1;
}

static known *known_of(const reader *r, int i) { return (known *)r->textures.data + i; }

/* ---- >>materials ------------------------------------------------------------------------------------------------- */

/* Converts Assimp's form of KHR_texture_transform, which has another convention, to the extension's own, v down. */
static void gltf_transform(look *l, const struct aiMaterial *m, enum aiTextureType type)
{
    struct aiUVTransform t = { { 0, 0 }, { 1, 1 }, 0 };
    aiGetMaterialUVTransform(m, AI_MATKEY_UVTRANSFORM(type, 0), &t);
    const double c = cos(-(double)t.mRotation), s = sin(-(double)t.mRotation);
    const double x = (double)t.mScaling.x, y = (double)t.mScaling.y;
    const double right = (double)t.mTranslation.x - 0.5 * x * (1 - c + s);
    const double down = 1 - y - (double)t.mTranslation.y + 0.5 * y * (s + c - 1);
    /* u and v of a vertex become u' = c x u + s y (1 - v) + right, v' = 1 - (-s x u + c y (1 - v) + down) */
    const double rows[2][3] = { { c * x, -s * y, s * y + right }, { s * x, c * y, 1 - c * y - down } };
    memcpy(l->to_texture, rows, sizeof rows);
}

static int texture_of(const reader *r, const struct aiMaterial *m, enum aiTextureType type, struct aiString *path,
                      look *l)
{
    static const double same[2][3] = { { 1, 0, 0 }, { 0, 1, 0 } };

    enum aiTextureMapMode mode[2] = { aiTextureMapMode_Wrap, aiTextureMapMode_Wrap };

    unsigned uv = 0;
    if (!aiGetMaterialTextureCount(m, type)
        || aiGetMaterialTexture(m, type, 0, path, NULL, &uv, NULL, NULL, mode, NULL) != aiReturn_SUCCESS
        || !*path->data)
        return 0;
    l->uv = uv;
    memcpy(l->to_texture, same, sizeof same);
    if (r->gltf) gltf_transform(l, m, type);
    for (int i = 0; i < 2; ++i)
        l->wrap[i] = mode[i] == aiTextureMapMode_Wrap   ? KIT_REPEAT
                   : mode[i] == aiTextureMapMode_Mirror ? KIT_MIRROR
                                                        : KIT_CLAMP;
    return 1;
}

/* Returns the least alpha of opaque texels: the material's in glTF; 0.5 if it gives none; 0: all are opaque. */
static int least_alpha(const reader *r, const struct aiMaterial *m, float factor, int *masked)
{
    struct aiString mode = { 0 };
    float cutoff = 0.5f;
    *masked = WHERE_IT_CUTS;
    if (!r->gltf) return HALF;
    *masked = NO_MASK;
    if (aiGetMaterialString(m, AI_MATKEY_GLTF_ALPHAMODE, &mode) != aiReturn_SUCCESS || !strcmp(mode.data, "OPAQUE"))
        return 0;
    *masked = strcmp(mode.data, "MASK") ? WHERE_IT_CUTS : MASK;
    if (*masked != MASK) return HALF;
    aiGetMaterialFloatArray(m, AI_MATKEY_GLTF_ALPHACUTOFF, &cutoff, NULL);
    const double least = factor > 0 ? ceil(255 * (double)cutoff / (double)factor - 1e-3) : 256;
    return least > 0 ? (int)fmin(least, 256) : 0;
}

static int look_at(reader *r, look *l, const struct aiMaterial *m)
{
    struct aiColor4D colour = { 0.8f, 0.8f, 0.8f, 1 }, light = { 0, 0, 0, 1 };
    struct aiString path = { 0 }, name = { 0 };
    const int coloured = aiGetMaterialColor(m, AI_MATKEY_BASE_COLOR, &colour) == aiReturn_SUCCESS
                      || aiGetMaterialColor(m, AI_MATKEY_COLOR_DIFFUSE, &colour) == aiReturn_SUCCESS;
    aiGetMaterialString(m, AI_MATKEY_NAME, &name);
    aiGetMaterialColor(m, AI_MATKEY_COLOR_EMISSIVE, &light);
    r->emits |= light.r > 0 || light.g > 0 || light.b > 0;
    *l = (look){ .of = -1 };
    const int textured = texture_of(r, m, aiTextureType_BASE_COLOR, &path, l)
                      || texture_of(r, m, aiTextureType_DIFFUSE, &path, l);
    /* Assimp adds this material if a file has none. */
    l->grey = !textured
           && (!coloured || !strcmp(name.data, AI_DEFAULT_MATERIAL_NAME)
               || (!*name.data && colour.r == 1 && colour.g == 1 && colour.b == 1));
    const float rgb[3] = { colour.r, colour.g, colour.b };
    memcpy(l->albedo, rgb, sizeof rgb);
    int masked;
    const int least = least_alpha(r, m, colour.a, &masked);
    const int of = textured ? texture_known(r, &path, 0, least, masked) : -1;
    if (textured && of < 0) return -1;
    for (int k = 0; k < 3 && textured; ++k) l->albedo[k] *= known_of(r, of)->mean[k];
    if (textured && known_of(r, of)->mask.sum) l->of = of;
    if (l->of >= 0 || !texture_of(r, m, aiTextureType_OPACITY, &path, l)) return 0;
    const int opacity = texture_known(r, &path, 1, HALF, MASK);
    if (opacity >= 0 && known_of(r, opacity)->mask.sum) l->of = opacity;
    return opacity < 0 ? -1 : 0;
}

/* ---- >>places ---------------------------------------------------------------------------------------------------- */

static place place_from(const struct aiMatrix4x4 *m)
{
    return (place){ { { (double)m->a1, (double)m->a2, (double)m->a3, (double)m->a4 },
                      { (double)m->b1, (double)m->b2, (double)m->b3, (double)m->b4 },
                      { (double)m->c1, (double)m->c2, (double)m->c3, (double)m->c4 } } };
}

static int by_node(const void *a, const void *b)
{
    const struct aiNode *const p = ((const twin *)a)->node, *const q = ((const twin *)b)->node;
    return p < q ? -1 : p > q;
}

/* NULL: it has none. */
static const char *json_of(const reader *r, const struct aiNode *n)
{
    const twin key = { n, NULL };
    const twin *found = r->twins.count ? bsearch(&key, r->twins.data, r->twins.count, sizeof key, by_node) : NULL;
    return found ? found->json : NULL;
}

static place place_of(const reader *r, const struct aiNode *n)
{
    const char *json = r->precise ? json_of(r, n) : NULL;
    place p = place_from(&n->mTransformation);
    if (json) kit_gltf_place(p.m, json);
    return p;
}

static int pair(reader *r, const struct aiNode *n, const char *json)
{
    twin *t = json ? kit_array_add(&r->twins, 1, sizeof *t, &r->from) : NULL;
    const char *child = kit_gltf_first(kit_gltf_member(json, "children"));
    if (!t) return -1;
    *t = (twin){ n, json };
    for (unsigned i = 0; i < n->mNumChildren; ++i, child = kit_gltf_next(child))
        if (!child || pair(r, n->mChildren[i], kit_gltf_node(&r->json, child))) return -1;
    return child ? -1 : 0;
}

/* Pairs Assimp's nodes with the file's, which have the same order; above several roots Assimp has a node of its own. */
static void pair_nodes(reader *r)
{
    const struct aiNode *root = r->scene->mRootNode;
    if (!root || kit_gltf_open(&r->json, r->from.path, NULL)) return;
    const char *first = kit_gltf_first(kit_gltf_roots(&r->json)), *next = first ? kit_gltf_next(first) : NULL;
    int failed = !first || (!next && pair(r, root, kit_gltf_node(&r->json, first)));
    for (unsigned i = 0; next && !failed && i < root->mNumChildren; ++i, first = first ? kit_gltf_next(first) : NULL)
        failed = !first || pair(r, root->mChildren[i], kit_gltf_node(&r->json, first));
    if (failed) r->twins.count = 0;
    else qsort(r->twins.data, r->twins.count, sizeof(twin), by_node);
}

/* Returns the distance from a number to the next float. */
static double gap_at(double x)
{
    const float f = fabsf((float)x);
    return (double)nextafterf(f, INFINITY) - (double)f;
}

/* Returns the largest rounding step of the coordinates of a point `at` after the transform p. */
static double gap_of(const place *p, const double at[3])
{
    double most = 0;
    for (int i = 0; i < 3; ++i) {
        double gap = 0;
        for (int k = 0; k < 3; ++k) gap += fabs(p->m[i][k]) * gap_at(at[k]);
        most = fmax(most, gap);
    }
    return most;
}

static place times(const place *a, const place *b)
{
    place out;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 4; ++c) {
            out.m[r][c] = c == 3 ? a->m[r][3] : 0;
            for (int k = 0; k < 3; ++k) out.m[r][c] += a->m[r][k] * b->m[k][c];
        }
    return out;
}

/* Writes the matrix for normals, correct in sign also for mirrors. Returns the determinant. */
static double cofactors(const place *p, double out[3][3])
{
    double determinant = 0;
    for (int r = 0; r < 3; ++r)
        for (int c = 0; c < 3; ++c) {
            const int r1 = (r + 1) % 3, r2 = (r + 2) % 3, c1 = (c + 1) % 3, c2 = (c + 2) % 3;
            out[r][c] = p->m[r1][c1] * p->m[r2][c2] - p->m[r1][c2] * p->m[r2][c1];
        }
    for (int c = 0; c < 3; ++c) determinant += p->m[0][c] * out[0][c];
    for (int i = 0; i < 9 && determinant < 0; ++i) out[i / 3][i % 3] = -out[i / 3][i % 3];
    return determinant;
}

/* Adds a morph's displacement of a vertex, times a weight. */
static void add_morph(double to[3], const struct aiVector3D *base, const struct aiVector3D *morph, double weight)
{
    to[0] += weight * ((double)morph->x - (double)base->x);
    to[1] += weight * ((double)morph->y - (double)base->y);
    to[2] += weight * ((double)morph->z - (double)base->z);
}

/* Adds a vertex with its morphs, transformed by p, times a weight. */
static void add_vertex(reader *r, const struct aiMesh *m, unsigned v, const place *p, double turn[3][3], double weight)
{
    if (!r->used[v]) return;
    const struct aiVector3D *at = &m->mVertices[v], *n = m->mNormals ? &m->mNormals[v] : NULL;
    double from[3] = { (double)at->x, (double)at->y, (double)at->z };
    double normal[3] = { n ? (double)n->x : 0, n ? (double)n->y : 0, n ? (double)n->z : 0 };
    double turned[3], length = 0;
    if (r->measures) r->vertex_gap = fmax(r->vertex_gap, gap_of(p, from));
    for (unsigned i = 0; r->gltf && i < m->mNumAnimMeshes; ++i) {
        const struct aiAnimMesh *morph = m->mAnimMeshes[i];
        const double by = !r->weights ? (double)morph->mWeight : i < r->weights && i < MOST_WEIGHTS ? r->weight[i] : 0;
        if (by == 0 || v >= morph->mNumVertices) continue;
        if (morph->mVertices) add_morph(from, at, &morph->mVertices[v], by);
        if (morph->mNormals && n) add_morph(normal, n, &morph->mNormals[v], by);
    }
    for (int i = 0; i < 3; ++i) {
        r->position[3 * (size_t)v + (size_t)i] += (float)(weight * (kit_dot(p->m[i], from) + p->m[i][3]));
        turned[i] = kit_dot(turn[i], normal);
        length += turned[i] * turned[i];
    }
    for (int i = 0; i < 3 && length > 0 && isfinite(length); ++i)
        r->normal[3 * (size_t)v + (size_t)i] += (float)(weight * turned[i] / sqrt(length));
}

/* Finds the node of a name and its transform to the world; returns 0 if there is none. */
static int node_named(const reader *r, const struct aiNode *n, const char *name, const place *above, place *out)
{
    const place own = place_of(r, n);
    *out = times(above, &own);
    if (!strcmp(n->mName.data, name)) return 1;
    const place here = *out;
    for (unsigned i = 0; i < n->mNumChildren; ++i)
        if (n->mChildren[i] && node_named(r, n->mChildren[i], name, &here, out)) return 1;
    return 0;
}

static const place nowhere = { { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, 1, 0 } } };

/* Applies bones to all vertices in the file's own pose; vertices without a bone stay at 0. */
static void hold(reader *r, const struct aiMesh *m, float *held)
{
    for (unsigned b = 0; b < m->mNumBones; ++b) {
        const struct aiBone *bone = m->mBones[b];
        const place offset = place_from(&bone->mOffsetMatrix);
        double turn[3][3];
        place p;
        if (!node_named(r, r->scene->mRootNode, bone->mName.data, &r->root, &p)) continue;
        p = times(&p, &offset);
        cofactors(&p, turn);
        for (unsigned w = 0; w < bone->mNumWeights; ++w) {
            const struct aiVertexWeight *weight = &bone->mWeights[w];
            if (weight->mVertexId >= m->mNumVertices || !(weight->mWeight > 0)) continue;
            add_vertex(r, m, weight->mVertexId, &p, turn, (double)weight->mWeight);
            held[weight->mVertexId] += weight->mWeight;
        }
    }
}

/* ---- >>meshes ---------------------------------------------------------------------------------------------------- */

/* Returns a vertex colour's component as linear: it is linear in glTF and sRGB in other formats. */
static float linear(const reader *r, float v)
{
    const double x = fmax(0, (double)v);
    return r->gltf ? v : (float)(x <= 0.04045 ? x / 12.92 : pow((x + 0.055) / 1.055, 2.4));
}

/* A triangle that is being cut. */
typedef struct card {
    reader *r;
    const float *position[3], *normal[3];
    float albedo[3];
} card;

static int too_many(const reader *r)
{
    return kit_fail(r->from.err,
                    "%s: has more than %d triangles or %d meshes, each counted as often as it is used, cards when cut",
                    r->from.path, MOST_TRIANGLES, MOST_MESHES);
}

static int add_piece(void *context, const double weight[3][2])
{
    const card *c = context;
    float p[3][3], n[3][3];
    const float *position[3] = { p[0], p[1], p[2] }, *normal[3] = { n[0], n[1], n[2] };
    if (++c->r->triangles > MOST_TRIANGLES) return too_many(c->r);
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i) {
            const double first = 1 - weight[k][0] - weight[k][1];
            p[k][i] = (float)(first * (double)c->position[0][i] + weight[k][0] * (double)c->position[1][i]
                              + weight[k][1] * (double)c->position[2][i]);
            n[k][i] = (float)(first * (double)c->normal[0][i] + weight[k][0] * (double)c->normal[1][i]
                              + weight[k][1] * (double)c->normal[2][i]);
        }
    return kit_soup_triangle(c->r->soup, position, normal, c->albedo, &c->r->from) < 0 ? -1 : 0;
}

static void albedo_of(float albedo[3], const reader *r, const look *l, const struct aiMesh *m, const struct aiFace *f)
{
    const struct aiColor4D *own = m->mColors[0];
    for (int k = 0; k < 3; ++k) albedo[k] = !l->grey ? l->albedo[k] : own ? 1 : kit_grey[k];
    for (int k = 0; k < 3 && own; ++k) {
        const struct aiColor4D *a = &own[f->mIndices[0]], *b = &own[f->mIndices[1]], *c = &own[f->mIndices[2]];
        const float *v[3] = { &a->r, &b->r, &c->r };
        albedo[k] *= (linear(r, v[0][k]) + linear(r, v[1][k]) + linear(r, v[2][k])) / 3;
    }
    for (int k = 0; k < 3; ++k) albedo[k] = albedo[k] > 0 ? fminf(albedo[k], 1) : 0;
}

static int add_face(reader *r, const struct aiMesh *m, const struct aiFace *f, int mirrored)
{
    const look *l = &r->looks[m->mMaterialIndex];
    const struct aiVector3D *uv = l->uv < AI_MAX_NUMBER_OF_TEXTURECOORDS ? m->mTextureCoords[l->uv] : NULL;
    double at[3][2];
    card c = { .r = r };
    for (int k = 0; k < 3; ++k) {
        const unsigned v = f->mIndices[mirrored ? 2 - k : k];
        if (v >= m->mNumVertices)
            return kit_fail(r->from.err, "%s: a triangle names vertex %u of %u", r->from.path, v, m->mNumVertices);
        c.position[k] = r->position + 3 * (size_t)v;
        c.normal[k] = r->normal + 3 * (size_t)v;
        for (int i = 0; i < 3; ++i)
            if (!(fabsf(c.position[k][i]) <= KIT_FARTHEST))
                return kit_fail(r->from.err, "%s: a vertex is not within %g of 0: %g", r->from.path,
                                (double)KIT_FARTHEST, (double)c.position[k][i]);
        for (int i = 0; i < 2 && uv; ++i) {
            const double *row = l->to_texture[i];
            at[k][i] = row[0] * (double)uv[v].x + row[1] * (double)uv[v].y + row[2];
        }
    }
    albedo_of(c.albedo, r, l, m, f);
    if (l->of >= 0 && uv)
        return kit_card_cut(&known_of(r, l->of)->mask, l->wrap, (const double(*)[2])at, r->cells, add_piece, &c);
    if (++r->triangles > MOST_TRIANGLES) return too_many(r);
    return kit_soup_triangle(r->soup, c.position, c.normal, c.albedo, &r->from) < 0 ? -1 : 0;
}

static void measure_mesh(reader *r, const struct aiMesh *m)
{
    for (size_t v = 0; v < m->mNumVertices; ++v)
        for (size_t i = 0; i < 3 && r->used[v]; ++i) {
            r->lower[i] = fminf(r->lower[i], r->position[3 * v + i]);
            r->upper[i] = fmaxf(r->upper[i], r->position[3 * v + i]);
        }
}

/* Adds a mesh's triangles, transformed by p; or, while measuring, only widens the bounds. */
static int add_mesh(reader *r, const struct aiMesh *m, const place *p)
{
    const size_t n = m->mNumVertices;
    double turn[3][3];
    if (++r->meshes > MOST_MESHES) return too_many(r);
    if (!(m->mPrimitiveTypes & aiPrimitiveType_TRIANGLE) || !m->mVertices) return 0;
    if (m->mMaterialIndex >= r->scene->mNumMaterials)
        return kit_fail(r->from.err, "%s: a mesh names a material that is not there", r->from.path);
    r->position = calloc(3 * n + 1, sizeof *r->position);
    r->normal = calloc(3 * n + 1, sizeof *r->normal);
    r->used = calloc(n + 1, 1);
    float *held = calloc(n + 1, sizeof *held);
    const int mirrored = cofactors(p, turn) < 0 && !m->mNumBones;
    const int room = r->position && r->normal && r->used && held;
    int failed = room ? 0 : kit_fail(r->from.err, "%s: no memory", r->from.path);
    for (unsigned i = 0; room && i < m->mNumFaces; ++i)
        for (unsigned k = 0; m->mFaces[i].mNumIndices == 3 && k < 3; ++k)
            if (m->mFaces[i].mIndices[k] < n) r->used[m->mFaces[i].mIndices[k]] = 1;
    if (!failed) hold(r, m, held);
    for (unsigned v = 0; !failed && v < n; ++v) {
        if (!(held[v] > 0)) add_vertex(r, m, v, p, turn, 1);
        else
            for (size_t i = 0; i < 3; ++i) r->position[3 * v + i] /= held[v];
    }
    if (r->measures && room) measure_mesh(r, m);
    for (unsigned i = 0; !failed && !r->measures && i < m->mNumFaces; ++i)
        if (m->mFaces[i].mNumIndices == 3) failed = add_face(r, m, &m->mFaces[i], mirrored);
    free(r->position);
    free(r->normal);
    free(r->used);
    free(held);
    return failed;
}

static int add_node(reader *r, const struct aiNode *n, const place *above)
{
    const place own = place_of(r, n), p = times(above, &own);
    const double at[3] = { own.m[0][3], own.m[1][3], own.m[2][3] };
    if (r->measures) r->node_gap = fmax(r->node_gap, gap_of(above, at));
    for (unsigned i = 0; i < n->mNumMeshes; ++i) {
        const struct aiMesh *m = r->scene->mMeshes[n->mMeshes[i]];
        const kit_key name[2] = { { n->mName.data, n->mName.length }, { m->mName.data, m->mName.length } };
        const int names = !r->measures;
        if (names && (kit_soup_name(r->soup, 0, name[0], &r->from) || kit_soup_name(r->soup, 1, name[1], &r->from)))
            return -1;
        r->weights = kit_gltf_numbers(r->weight, MOST_WEIGHTS, kit_gltf_member(json_of(r, n), "weights"));
        if (add_mesh(r, m, &p)) return -1;
    }
    for (unsigned i = 0; i < n->mNumChildren; ++i)
        if (n->mChildren[i] && add_node(r, n->mChildren[i], &p)) return -1;
    return 0;
}

/* ---- >>far away -------------------------------------------------------------------------------------------------- */

static int measure(reader *r)
{
    for (int i = 0; i < 3; ++i) {
        r->lower[i] = INFINITY;
        r->upper[i] = -INFINITY;
        r->root.m[i][3] = 0 - r->origin[i];
    }
    r->vertex_gap = r->node_gap = 0;
    r->meshes = 0;
    r->measures = 1;
    const int failed = add_node(r, r->scene->mRootNode, &r->root);
    r->measures = 0;
    r->meshes = 0;
    return failed;
}

/* Takes transforms from the file's JSON, if it has one and floats are too coarse; then moves the model near 0. */
static int approach(reader *r)
{
    if (r->gltf) pair_nodes(r);
    if (measure(r)) return -1;
    r->precise = r->twins.count && r->node_gap > KIT_COARSE * kit_diagonal(r->lower, r->upper);
    if (r->precise && measure(r)) return -1;
    for (int turn = 0; turn < 2 && kit_origin_move(r->origin, r->lower, r->upper); ++turn)
        if (measure(r)) return -1;
    if (r->precise) r->node_gap = 0;
    return 0;
}

/* ---- >>guard ----------------------------------------------------------------------------------------------------- */

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
enum { SANITIZED = 1 }; /* a sanitizer reserves the whole address space, so that memory cannot be limited */
#else
enum { SANITIZED = 0 };
#endif

/* What guard_open changes while Assimp reads: output is discarded; time and memory are limited to more than a good file
   of that size needs. */
typedef struct guard {
    int printed[2];
    struct rlimit time, memory;
} guard;

static void guard_open(guard *g, size_t size)
{
    static const int ends[] = { SIGSEGV, SIGBUS, SIGILL, SIGFPE, SIGABRT };
    const int nothing = open("/dev/null", O_WRONLY | O_CLOEXEC);
    for (size_t i = 0; i < sizeof ends / sizeof *ends; ++i) signal(ends[i], SIG_DFL);
    for (int i = 0; i < 2; ++i) {
        g->printed[i] = dup(1 + i);
        if (nothing >= 0) dup2(nothing, 1 + i);
    }
    if (nothing >= 0) close(nothing);
    getrlimit(RLIMIT_CPU, &g->time);
    getrlimit(RLIMIT_AS, &g->memory);
    struct rlimit time = g->time, memory = g->memory, none = { 0, 0 };
    const rlim_t seconds = 15 + 10 * (rlim_t)(size >> 20);
    const rlim_t bytes = ((rlim_t)3 << 30) + 100 * (rlim_t)size;
    if (time.rlim_cur > seconds) time.rlim_cur = seconds;
    if (memory.rlim_cur > bytes) memory.rlim_cur = bytes;
    setrlimit(RLIMIT_CORE, &none);
    setrlimit(RLIMIT_CPU, &time);
    if (!SANITIZED) setrlimit(RLIMIT_AS, &memory);
}

static void guard_close(const guard *g)
{
    setrlimit(RLIMIT_CPU, &g->time);
    if (!SANITIZED) setrlimit(RLIMIT_AS, &g->memory);
    for (int i = 0; i < 2; ++i) {
        if (g->printed[i] < 0) close(1 + i);
        else {
            dup2(g->printed[i], 1 + i);
            close(g->printed[i]);
        }
    }
}

/* ---- >>axes ------------------------------------------------------------------------------------------------------ */

static int number_of(const struct aiMetadata *data, const char *key, int otherwise)
{
    for (unsigned i = 0; i < data->mNumProperties; ++i)
        if (!strcmp(data->mKeys[i].data, key) && data->mValues[i].mType == AI_INT32)
            return *(const int32_t *)data->mValues[i].mData;
    return otherwise;
}

/* Returns the rotation that turns an FBX upright: the file names its axes, but Assimp does not apply them. */
static place upright(const struct aiScene *s)
{
    static const char *const axis[3] = { "CoordAxis", "UpAxis", "FrontAxis" };
    static const char *const sign[3] = { "CoordAxisSign", "UpAxisSign", "FrontAxisSign" };
    place p = { .m = { { 0 } } };
    double turn[3][3];
    for (int i = 0; i < 3; ++i) {
        const int of = s->mMetaData ? number_of(s->mMetaData, axis[i], i) : i;
        if (of < 0 || of > 2) return nowhere;
        p.m[i][of] = s->mMetaData && number_of(s->mMetaData, sign[i], 1) < 0 ? -1 : 1;
    }
    return cofactors(&p, turn) > 0 ? p : nowhere;
}

/* ---- >>all ------------------------------------------------------------------------------------------------------- */

static int open_looks(reader *r)
{
    const struct aiScene *s = r->scene;
    size_t cards = 0;
    r->looks = calloc(s->mNumMaterials + 1, sizeof *r->looks);
    if (!r->looks) return kit_fail(r->from.err, "%s: no memory", r->from.path);
    for (unsigned i = 0; i < s->mNumMaterials; ++i)
        if (look_at(r, &r->looks[i], s->mMaterials[i])) return -1;
    for (unsigned i = 0; i < s->mNumMeshes; ++i)
        if (s->mMeshes[i]->mMaterialIndex < s->mNumMaterials && r->looks[s->mMeshes[i]->mMaterialIndex].of >= 0)
            cards += s->mMeshes[i]->mNumFaces;
    r->cells = fmax(LEAST_CELLS, fmin(MOST_CELLS, ALL_CELLS / fmax((double)cards, 1)));
    return 0;
}

static int assimp_fail(const char *path, const char *format, kit_error *err)
{
    const char *said = aiGetErrorString();
    size_t n = strlen(said);
    while (n > 0 && strchr(". \n", said[n - 1])) --n;
    if (!n || !strncmp(said, "No suitable reader", 18))
        return kit_fail(err,
                        "%s: is %s that cannot be read: it is damaged, or of a version that Assimp %s does not know",
                        path, format, kit_assimp_version());
    return kit_fail(err, "%s: is %s that cannot be read: %.*s", path, format, (int)(n < 400 ? n : 400), said);
}

/* Returns the number of points in meshes without faces, or whose faces are points. */
static size_t points_of(const struct aiScene *scene)
{
    size_t points = 0;
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
        if (!(scene->mMeshes[i]->mPrimitiveTypes & ~(unsigned)aiPrimitiveType_POINT))
            points += scene->mMeshes[i]->mNumVertices;
    return points;
}

/* Adds the triangles and objects of Assimp's scene. */
static int take_scene(reader *r)
{
    const struct aiNode *root = r->scene->mRootNode;
    if (open_looks(r) || (root && (approach(r) || add_node(r, root, &r->root)))) return -1;
    const double gap = fmax(r->vertex_gap, r->node_gap);
    if (r->soup->position.count) {
        kit_note_gap(r->note, "floats", gap, r->lower, r->upper);
        if (r->emits) kit_note(r->note, "its materials emit light, which is not read");
        return kit_soup_objects(r->soup, &r->from);
    }
    return gap > KIT_COARSE * kit_diagonal(r->lower, r->upper)
             ? kit_fail(r->from.err,
                        "%s: no triangles in it: its corners are read as floats, which are %.2g apart there",
                        r->from.path, gap)
             : kit_soup_empty(points_of(r->scene), &r->from);
}

int kit_assimp_read(kit_soup *soup, char *note, size_t size, const char *path, const char *format, kit_error *err)
{
    reader r = {
        .soup = soup, .from = { path, 0, err }, .note = note, .gltf = !strncmp(format, "glTF", 4)
    };
    const unsigned how = aiProcess_Triangulate | (r.gltf ? 0u : aiProcess_TransformUVCoords);
    double moved[3] = { 0 };
    char *const text = strcmp(format, "OBJ") ? NULL : kit_obj_moved(moved, path);
    guard g;
    struct aiPropertyStore *set = aiCreatePropertyStore();
    if (set) aiSetImportPropertyInteger(set, AI_CONFIG_IMPORT_NO_SKELETON_MESHES, 1);
    guard_open(&g, size);
    r.scene = text ? aiImportFileFromMemoryWithProperties(text, (unsigned)strlen(text), how, "obj", set)
                   : aiImportFileExWithProperties(path, how, NULL, set);
    guard_close(&g);
    if (set) aiReleasePropertyStore(set);
    free(text);
    if (!r.scene) return assimp_fail(path, format, err);
    r.root = strncmp(format, "FBX", 3) ? nowhere : upright(r.scene);
    const int failed = take_scene(&r);
    for (int i = 0; i < 3; ++i) soup->origin[i] = moved[i] + r.origin[i];
    for (size_t i = 0; i < r.textures.count; ++i) kit_mask_free(&((known *)r.textures.data)[i].mask);
    free(r.textures.data);
    free(r.looks);
    free(r.twins.data);
    kit_gltf_close(&r.json);
    aiReleaseImport(r.scene);
    return failed;
}

#endif
