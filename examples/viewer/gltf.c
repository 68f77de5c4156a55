/* gltf.c - a .gltf's positions, normals, indices, base colours and its nodes' transforms; nothing else. */
#include "viewer.h"
#include <ctype.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* A value of JSON: kind is one of { [ " 0 t; text: of a string, a number or a word. key: in an object. Both are offsets
   into the file. Its items are so many from first on in gltf's; next is for the parser alone. */
typedef struct json { uint32_t text, length, key, keys; int next, first, items; char kind; } json;

/* What a file may ask for: a small one can name one mesh a thousand times, and so on down. */
enum { DEEPEST = 64, MOST_KEYS = 256, BUFFERS = 16, DEEPEST_NODE = 1000, MOST_PRIMITIVES = 1 << 18,
       MOST_TRIANGLES = 1 << 24 };

typedef struct gltf {
    const char *path, *text, *at, *end;
    kit_error  *err;
    json       *v;
    int        *item, count, room, items, item_room;
    char       *buffer[BUFFERS];
    size_t      size[BUFFERS];
    int         accessors, views, materials, meshes, nodes;         /* arrays */
    size_t      primitives, triangles, triangle_room;               /* how many were asked for; the mesh's room */
    char       *seen;                       /* of a node: it is in the scene */
} gltf;

static int no_memory(const gltf *g) { return kit_fail(g->err, "%s: no memory", g->path); }

static int bad_json(const gltf *g, const char *what)
{
    return kit_fail(g->err, "%s: is not JSON: %s at byte %zu", g->path, what, (size_t)(g->at - g->text));
}

static void skip_space(gltf *g)
{
    while (g->at < g->end && (*g->at == ' ' || *g->at == '\t' || *g->at == '\r' || *g->at == '\n')) ++g->at;
}

static int quoted(gltf *g, uint32_t *text, uint32_t *length)
{
    const char *from = ++g->at;
    while (g->at < g->end && *g->at != '"') g->at += *g->at == '\\' && g->at + 1 < g->end ? 2 : 1;
    if (g->at >= g->end) return bad_json(g, "a string has no end");
    *text = (uint32_t)(from - g->text);
    *length = (uint32_t)(g->at++ - from);
    return 0;
}

static int plain(gltf *g, json *v)          /* a number, which is looked at when it is asked for, or a word */
{
    static const char *const words[] = { "true", "false", "null" };
    const char *from = g->at;
    while (g->at < g->end && (isalnum((unsigned char)*g->at) || *g->at == '-' || *g->at == '+' || *g->at == '.'))
        ++g->at;
    v->length = (uint32_t)(g->at - from);
    v->kind = *from == '-' || isdigit((unsigned char)*from) ? '0' : 't';
    for (int i = 0; i < 3; ++i) if (strlen(words[i]) == v->length && !memcmp(from, words[i], v->length)) return 0;
    if (v->kind == '0') return 0;
    g->at = from;
    return bad_json(g, "neither a value nor an end");
}

/* The values that are chained from first on become the items of a value, side by side. */
static int keep_items(gltf *g, int of, int first)
{
    g->v[of].first = g->items;
    for (int i = first; i >= 0; i = g->v[i].next) {
        if (g->items == g->item_room) {
            int *more = realloc(g->item, (size_t)(g->item_room = 2 * g->item_room + 256) * sizeof *more);
            if (!more) return no_memory(g);
            g->item = more;
        }
        g->item[g->items++] = i;
        ++g->v[of].items;
    }
    if (g->v[of].kind != '{' || g->v[of].items <= MOST_KEYS) return 0;
    return kit_fail(g->err, "%s: an object of %d keys ends at byte %zu: %d at most are read", g->path, g->v[of].items,
                    (size_t)(g->at - g->text), MOST_KEYS);
}

static int key_of(gltf *g, uint32_t *key, uint32_t *keys)
{
    if (g->at >= g->end || *g->at != '"') return bad_json(g, "a key is missing");
    if (quoted(g, key, keys)) return -1;
    skip_space(g);
    if (g->at >= g->end || *g->at != ':') return bad_json(g, "a colon is missing");
    ++g->at;
    return 0;
}

/* The number of the value that stands at g->at; -1: there is none, and the error says why. */
static int json_parse(gltf *g, int depth)
{
    if (g->count == g->room) {
        json *more = realloc(g->v, (size_t)(g->room = 2 * g->room + 256) * sizeof *more);
        if (!more) return no_memory(g);
        g->v = more;
    }
    const int me = g->count++;
    int first = -1, last = -1;
    skip_space(g);
    if (g->at >= g->end) return bad_json(g, "a value is missing");
    if (depth > DEEPEST)
        return kit_fail(g->err, "%s: at byte %zu more than %d brackets are open", g->path, (size_t)(g->at - g->text),
                        DEEPEST);
    g->v[me] = (json){ .kind = *g->at, .text = (uint32_t)(g->at - g->text), .next = -1 };
    if (*g->at == '"') return quoted(g, &g->v[me].text, &g->v[me].length) ? -1 : me;
    if (*g->at != '{' && *g->at != '[') return plain(g, &g->v[me]) ? -1 : me;
    const char close = *g->at++ == '{' ? '}' : ']';
    for (skip_space(g); g->at < g->end && *g->at != close; skip_space(g)) {
        uint32_t key = 0, keys = 0;
        if (last >= 0 && *g->at != ',') return bad_json(g, "a comma is missing");
        if (last >= 0) { ++g->at; skip_space(g); }
        if (close == '}' && key_of(g, &key, &keys)) return -1;
        const int v = json_parse(g, depth + 1);
        if (v < 0) return -1;
        g->v[v].key = key;
        g->v[v].keys = keys;
        if (last < 0) first = v; else g->v[last].next = v;
        last = v;
    }
    if (g->at >= g->end) return bad_json(g, "a bracket is not closed");
    ++g->at;
    return keep_items(g, me, first) ? -1 : me;
}

static int get(const gltf *g, int of, const char *key)
{
    const size_t length = strlen(key);
    for (int i = 0; of >= 0 && g->v[of].kind == '{' && i < g->v[of].items; ++i) {
        const int k = g->item[g->v[of].first + i];
        if (g->v[k].keys == length && !memcmp(g->text + g->v[k].key, key, length)) return k;
    }
    return -1;
}

static int items(const gltf *g, int of) { return of >= 0 && g->v[of].kind == '[' ? g->v[of].items : 0; }
static int item(const gltf *g, int of, int k) { return k >= 0 && k < items(g, of) ? g->item[g->v[of].first + k] : -1; }

static double number(const gltf *g, int v, double otherwise)     /* NAN: it is none, or more than a float can hold */
{
    char text[128] = "", *end;
    if (v < 0) return otherwise;
    if (g->v[v].kind != '0' || g->v[v].length >= sizeof text) return (double)NAN;
    memcpy(text, g->text + g->v[v].text, g->v[v].length);
    const double value = strtod(text, &end);
    return *end || strpbrk(text, "xX") || !(fabs(value) <= (double)FLT_MAX) ? (double)NAN : value;
}

static int whole_of(const gltf *g, int v, int otherwise)        /* -1: it is no whole number from 0 on */
{
    const double value = number(g, v, otherwise);
    return value >= 0 && value < 2147483648.0 && value == floor(value) ? (int)value : -1;
}

static int whole(const gltf *g, int of, const char *key, int otherwise)
{
    return whole_of(g, get(g, of, key), otherwise);
}

/* count numbers, which stay as they are where nothing is said. */
static int numbers(const gltf *g, int of, const char *key, double *out, int count)
{
    const int list = get(g, of, key);
    if (list < 0) return 0;
    for (int i = 0; i < count; ++i) if (isnan(out[i] = number(g, item(g, list, i), (double)NAN))) return -1;
    return 0;
}

static int says(const gltf *g, int v, const char *text)
{
    return v >= 0 && g->v[v].kind == '"' && g->v[v].length == strlen(text)
           && !memcmp(g->text + g->v[v].text, text, g->v[v].length);
}

/* The elements of an accessor, as floats or as one number; all is checked when it is opened. */
typedef struct elements { const unsigned char *data; size_t stride, size; int count, type; } elements;

static int elements_of(elements *e, const gltf *g, int accessor, int wide)
{
    const int a = item(g, g->accessors, accessor), v = item(g, g->views, whole(g, a, "bufferView", -1));
    const int buffer = whole(g, v, "buffer", -1), type = whole(g, a, "componentType", -1);
    const int at = whole(g, a, "byteOffset", 0), count = whole(g, a, "count", -1);
    const int from = whole(g, v, "byteOffset", 0), size = whole(g, v, "byteLength", -1),
              stride = whole(g, v, "byteStride", 0);
    const char *why = NULL;
    memset(e, 0, sizeof *e);
    e->size = type == GL_FLOAT || type == GL_UNSIGNED_INT ? 4 : type == GL_UNSIGNED_SHORT ? 2 : 1;
    const size_t tight = (size_t)wide * e->size, step = stride > 0 ? (size_t)stride : tight;
    if (a < 0) why = "is not there";
    else if (get(g, a, "sparse") >= 0) why = "is sparse, which is not read";
    else if (get(g, a, "bufferView") < 0) why = "has no bufferView: compressed meshes are not read";
    else if (v < 0 || buffer < 0 || buffer >= BUFFERS || !g->buffer[buffer])
        why = "is of a bufferView or a buffer that is not there";
    else if (at < 0 || from < 0 || size < 0 || stride < 0 || count < 1)
        why = "has an offset, a length, a stride or a count that is no whole number, or none";
    else if (!says(g, get(g, a, "type"), wide > 1 ? "VEC3" : "SCALAR")
             || (wide > 1 ? type != GL_FLOAT
                          : type != GL_UNSIGNED_INT && type != GL_UNSIGNED_SHORT && type != GL_UNSIGNED_BYTE))
        why = wide > 1 ? "must be three floats an element" : "must be one unsigned integer an element";
    else if ((size_t)from + (size_t)size > g->size[buffer]) why = "is of a bufferView that ends beyond its buffer";
    else if (step < tight) why = "has elements that overlap: its byteStride is too short";
    else if ((size_t)at + (size_t)(count - 1) * step + tight > (size_t)size) why = "ends beyond its bufferView";
    if (why) return kit_fail(g->err, "%s: accessor %d %s", g->path, accessor, why);
    *e = (elements){ (const unsigned char *)g->buffer[buffer] + from + at, step, e->size, count, type };
    return 0;
}

static uint32_t index_at(const elements *e, size_t k)   /* little-endian, as the format is */
{
    const unsigned char *p = e->data + k * e->stride;
    uint32_t v = 0;
    for (size_t i = 0; i < e->size; ++i) v |= (uint32_t)p[i] << 8 * i;
    return v;
}

/* out = m * n; all column-major */
static void times(float out[16], const float m[16], const float n[16])
{
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
            out[4 * c + r] = 0;
            for (int k = 0; k < 4; ++k) out[4 * c + r] += m[4 * k + r] * n[4 * c + k];
        }
}

static int node_matrix(float out[16], const gltf *g, int node)
{
    double m[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 }, q[4] = { 0, 0, 0, 1 }, s[3] = { 1, 1, 1 };
    if (numbers(g, node, "matrix", m, 16) || numbers(g, node, "translation", m + 12, 3)
        || numbers(g, node, "rotation", q, 4) || numbers(g, node, "scale", s, 3)) return -1;
    const double x = q[0], y = q[1], z = q[2], w = q[3];
    const double turn[9] = { 1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (x * z - y * w),
                             2 * (x * y - z * w), 1 - 2 * (x * x + z * z), 2 * (y * z + x * w),
                             2 * (x * z + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y) };
    for (int i = 0; i < 9 && get(g, node, "matrix") < 0; ++i) m[i / 3 * 4 + i % 3] = turn[i] * s[i / 3];
    for (int i = 0; i < 16; ++i) {
        if (!(fabs(m[i]) <= (double)FLT_MAX)) return -1;
        out[i] = (float)m[i];
    }
    return 0;
}

static int unit(const double v[3], float out[3])             /* 0: it has no direction */
{
    const double length = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    if (!(length > 0) || !isfinite(length)) return 0;
    for (int i = 0; i < 3; ++i) out[i] = (float)(v[i] / length);
    return 1;
}

/* A corner in the world, its normal 0 where it has none; -1: it is too far away, or nowhere. */
static int corner(float position[3], float normal[3], const float m[16], const elements *e, const elements *n,
                  uint32_t k)
{
    float p[2][3] = { { 0 } };
    double turned[3] = { 0 };
    memcpy(p[0], e->data + k * e->stride, sizeof p[0]);
    if (n->data) memcpy(p[1], n->data + k * n->stride, sizeof p[1]);
    for (int r = 0; r < 3; ++r) {
        double at = (double)m[12 + r];
        for (int c = 0; c < 3; ++c) {
            double scale = 0;               /* normals turn with the axes and shrink where these stretch */
            for (int i = 0; i < 3; ++i) scale += (double)m[4 * c + i] * (double)m[4 * c + i];
            at += (double)m[4 * c + r] * (double)p[0][c];
            turned[r] += (double)m[4 * c + r] * (double)p[1][c] / fmax(scale, 1e-30);
        }
        if (!(fabs(at) <= VIEWER_FARTHEST)) return -1;
        position[r] = (float)at;
        normal[r] = 0;
    }
    unit(turned, normal);
    return 0;
}

/* The triangle whose corners stand at the mesh's end is part of it, unless it has no area. */
static void keep_triangle(kit_mesh *mesh, const double colour[3])
{
    float *p = mesh->position + 9 * mesh->triangles, *normal = mesh->normal + 9 * mesh->triangles, face[3];
    double across[3];
    for (int i = 0; i < 3; ++i) {
        const int a = (i + 1) % 3, b = (i + 2) % 3;
        across[i] = ((double)p[3 + a] - (double)p[a]) * ((double)p[6 + b] - (double)p[b])
                    - ((double)p[3 + b] - (double)p[b]) * ((double)p[6 + a] - (double)p[a]);
    }
    if (!unit(across, face)) return;
    for (int k = 0; k < 9; k += 3)
        if (normal[k] == 0 && normal[k + 1] == 0 && normal[k + 2] == 0) memcpy(normal + k, face, sizeof face);
    for (int i = 0; i < 3; ++i) mesh->albedo[3 * mesh->triangles + (size_t)i] = (float)fmin(fmax(colour[i], 0), 1);
    ++mesh->triangles;
}

/* One primitive more, and room for its triangles. */
static int make_room(kit_mesh *mesh, gltf *g, size_t more)
{
    float **array[3] = { &mesh->position, &mesh->normal, &mesh->albedo };
    g->triangles += more;
    if (++g->primitives > MOST_PRIMITIVES || g->triangles > MOST_TRIANGLES)
        return kit_fail(g->err, "%s: has more than %d triangles or %d primitives, each counted as often as it is used",
                        g->path, MOST_TRIANGLES, MOST_PRIMITIVES);
    if (mesh->triangles + more <= g->triangle_room) return 0;
    g->triangle_room = 2 * mesh->triangles + more;
    for (int i = 0; i < 3; ++i) {
        float *a = realloc(*array[i], g->triangle_room * (i < 2 ? 9 : 3) * sizeof *a);
        if (!a) return no_memory(g);
        *array[i] = a;
    }
    return 0;
}

/* Triangles of a primitive, at the end of the mesh. */
static int add_primitive(kit_mesh *mesh, gltf *g, int primitive, const float m[16])
{
    const int attributes = get(g, primitive, "attributes"), mode = whole(g, primitive, "mode", 4);
    const int indices = get(g, primitive, "indices"), normals = get(g, attributes, "NORMAL");
    const int material = get(g, primitive, "material");
    const int of = material < 0 ? -1 : item(g, g->materials, whole_of(g, material, -1));
    elements p, n = { 0 }, index = { 0 };
    double colour[3] = { 0.8, 0.8, 0.8 };
    if (mode >= 0 && mode < 4) return make_room(mesh, g, 0);        /* points and lines have no surface */
    if (mode != 4)
        return kit_fail(g->err, "%s: a primitive's mode must be 4, triangles: strips and fans are not read", g->path);
    if ((material >= 0 && of < 0) || numbers(g, get(g, of, "pbrMetallicRoughness"), "baseColorFactor", colour, 3))
        return kit_fail(g->err, "%s: a primitive's material is not there, or its colour is not four numbers", g->path);
    if (elements_of(&p, g, whole(g, attributes, "POSITION", -1), 3)
        || (normals >= 0 && elements_of(&n, g, whole_of(g, normals, -1), 3))
        || (indices >= 0 && elements_of(&index, g, whole_of(g, indices, -1), 1))) return -1;
    if (n.data && n.count != p.count)
        return kit_fail(g->err, "%s: a primitive has %d positions and %d normals", g->path, p.count, n.count);
    const size_t more = (size_t)(index.data ? index.count : p.count) / 3;
    if (make_room(mesh, g, more)) return -1;
    for (size_t t = 0; t < more; ++t) {
        float *at = mesh->position + 9 * mesh->triangles, *normal = mesh->normal + 9 * mesh->triangles;
        for (size_t k = 0; k < 3; ++k) {
            const uint32_t v = index.data ? index_at(&index, 3 * t + k) : (uint32_t)(3 * t + k);
            if (v >= (uint32_t)p.count)
                return kit_fail(g->err, "%s: a triangle names vertex %u of %d", g->path, (unsigned)v, p.count);
            if (corner(at + 3 * k, normal + 3 * k, m, &p, &n, v))
                return kit_fail(g->err, "%s: a vertex is not within %g of 0", g->path, VIEWER_FARTHEST);
        }
        keep_triangle(mesh, colour);
    }
    return 0;
}

static int add_node(kit_mesh *mesh, gltf *g, int k, const float parent[16], int depth)
{
    const int node = item(g, g->nodes, k), children = get(g, node, "children"), mesh_ = get(g, node, "mesh");
    const int of = mesh_ < 0 ? -1 : item(g, g->meshes, whole_of(g, mesh_, -1)), primitives = get(g, of, "primitives");
    float own[16], m[16];
    if (node < 0) return kit_fail(g->err, "%s: a node is named that is not there", g->path);
    if (depth > DEEPEST_NODE)
        return kit_fail(g->err, "%s: node %d has more than %d ancestors", g->path, k, DEEPEST_NODE);
    if (g->seen[k]++) return kit_fail(g->err, "%s: node %d comes twice: it must have one parent at most", g->path, k);
    if (mesh_ >= 0 && of < 0) return kit_fail(g->err, "%s: node %d has a mesh that is not there", g->path, k);
    if (node_matrix(own, g, node))
        return kit_fail(g->err, "%s: node %d has a transform that is not of numbers", g->path, k);
    times(m, parent, own);
    for (int i = 0; i < items(g, primitives); ++i)
        if (add_primitive(mesh, g, item(g, primitives, i), m)) return -1;
    for (int i = 0; i < items(g, children); ++i)
        if (add_node(mesh, g, whole_of(g, item(g, children, i), -1), m, depth + 1)) return -1;
    return 0;
}

static int base64_read(gltf *g, int i, const char *at, const char *end)
{
    static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/", kind[] = ";base64";
    const char *comma = memchr(at, ',', (size_t)(end - at));
    signed char value[256];
    if (!comma || comma - at < (int)sizeof kind - 1 || memcmp(comma - sizeof kind + 1, kind, sizeof kind - 1))
        return kit_fail(g->err, "%s: the uri of buffer %d must be data:..;base64,.. or a file", g->path, i);
    memset(value, -1, sizeof value);
    for (int k = 0; k < 64; ++k) value[(unsigned char)digits[k]] = (signed char)k;
    if (!(g->buffer[i] = malloc((size_t)(end - comma)))) return no_memory(g);
    uint32_t bits = 0, have = 0;
    for (at = comma + 1; at < end && *at != '='; ++at) {
        const int digit = value[(unsigned char)*at];
        if (digit < 0) return kit_fail(g->err, "%s: buffer %d is not base64", g->path, i);
        bits = bits << 6 | (uint32_t)digit;
        have += 6;
        if (have >= 8) g->buffer[i][g->size[i]++] = (char)(bits >> (have -= 8));
    }
    return 0;
}

/* A buffer: behind "base64,", or a file beside the .gltf. */
static int buffer_read(gltf *g, int i, int of)
{
    char name[4096];
    const int uri = get(g, of, "uri"), length = whole(g, of, "byteLength", -1);
    const char *slash = strrchr(g->path, '/'), *at = uri < 0 ? "" : g->text + g->v[uri].text;
    const size_t folder = slash ? (size_t)(slash - g->path) + 1 : 0, size = uri < 0 ? 0 : g->v[uri].length;
    if (uri < 0 || g->v[uri].kind != '"') return kit_fail(g->err, "%s: buffer %d has no uri", g->path, i);
    if (size >= 5 && !memcmp(at, "data:", 5)) { if (base64_read(g, i, at, at + size)) return -1; }
    else {
        if (folder + size >= sizeof name)
            return kit_fail(g->err, "%s: the uri of buffer %d has %zu bytes: no file has so long a name", g->path, i,
                            size);
        memcpy(name, g->path, folder);
        memcpy(name + folder, at, size);
        name[folder + size] = 0;
        if (kit_file_read(&g->buffer[i], &g->size[i], name, g->err)) return -1;
    }
    if (length < 1 || (size_t)length > g->size[i])
        return kit_fail(g->err, "%s: buffer %d has %zu bytes: its byteLength must be 1 to that", g->path, i,
                        g->size[i]);
    g->size[i] = (size_t)length;
    return 0;
}

/* The triangles of the scene that the file says is its own. */
static int gltf_read(kit_mesh *mesh, gltf *g)
{
    static const float one[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    const int root = json_parse(g, 0);
    if (root < 0) return -1;
    skip_space(g);
    if (g->at < g->end) return bad_json(g, "more than one value");
    const int buffers = get(g, root, "buffers"), scenes = get(g, root, "scenes");
    const int scene = item(g, scenes, whole(g, root, "scene", 0)), nodes = get(g, scene, "nodes");
    g->accessors = get(g, root, "accessors");
    g->views = get(g, root, "bufferViews");
    g->materials = get(g, root, "materials");
    g->meshes = get(g, root, "meshes");
    g->nodes = get(g, root, "nodes");
    if (scene < 0) return kit_fail(g->err, "%s: has no scene, or not the one that it names", g->path);
    if (items(g, buffers) > BUFFERS)
        return kit_fail(g->err, "%s: has %d buffers: %d at most are read", g->path, items(g, buffers), BUFFERS);
    for (int i = 0; i < items(g, buffers); ++i) if (buffer_read(g, i, item(g, buffers, i))) return -1;
    if (!(g->seen = calloc((size_t)items(g, g->nodes) + 1, 1))) return no_memory(g);
    for (int i = 0; i < items(g, nodes); ++i)
        if (add_node(mesh, g, whole_of(g, item(g, nodes, i), -1), one, 0)) return -1;
    return mesh->triangles ? 0 : kit_fail(g->err, "%s: holds no triangles", g->path);
}

int gltf_load(kit_scene *s, const char *path, kit_error *err)
{
    gltf g = { .path = path, .err = err };
    char *text = NULL;
    size_t size;
    double reach = 0;
    if (kit_file_read(&text, &size, path, err)) return -1;
    g.text = g.at = text;
    g.end = text + size;
    memset(s, 0, sizeof *s);
    const int failed = size > INT_MAX / 2 ? kit_fail(err, "%s: must not be larger than 1 GiB", path)
                                          : gltf_read(&s->mesh, &g);
    for (int i = 0; i < BUFFERS; ++i) free(g.buffer[i]);
    free(g.v);
    free(g.item);
    free(g.seen);
    free(text);
    if (failed) { kit_mesh_free(&s->mesh); return -1; }
    for (int i = 0; i < 3; ++i) s->mesh.lower[i] = s->mesh.upper[i] = s->mesh.position[i];
    for (size_t i = 0; i < 9 * s->mesh.triangles; ++i) {
        s->mesh.lower[i % 3] = fminf(s->mesh.lower[i % 3], s->mesh.position[i]);
        s->mesh.upper[i % 3] = fmaxf(s->mesh.upper[i % 3], s->mesh.position[i]);
    }
    for (int i = 0; i < 3; ++i) reach += pow(0.5 * ((double)s->mesh.upper[i] - (double)s->mesh.lower[i]), 2);
    reach = sqrt(reach);
    s->name = path;
    s->radius = (float)(0.2 * reach);        /* a tenth of the diagonal, as for OBJ */
    s->camera.fovy = 45;
    s->camera.up[1] = 1;
    for (int i = 0; i < 3; ++i) {           /* from the front, above and to the right */
        static const double back[3] = { 0.391, 0.304, 0.869 };
        s->camera.target[i] = 0.5f * (s->mesh.lower[i] + s->mesh.upper[i]);
        s->camera.eye[i] = s->camera.target[i] + (float)(back[i] * reach * 2.2);
    }
    return 0;
}
