/* viewer.c - a window onto a scene: methods live, beside another or beside the truth, with their error and GPU times.

      build/viewer room                          build/viewer SCENE.obj --method hsao --right truth
      build/viewer SCENE.gltf --preset best      keys: h; options: --help

   And the example of an embedding in real time: between the two lines of "====" a method is a list of draws from
   ssgi_gl_steps, whichever it is, and one loop allocates, binds and draws them. What stands above is what an engine has
   already (a window, a G-buffer), below is what looks at the result. The kit loads scenes, traces the truth and writes
   pictures; it draws nothing here. */
#define GL_GLEXT_PROTOTYPES
#define GLFW_INCLUDE_NONE
#include <GL/glcorearb.h>
#include <GLFW/glfw3.h>
#include "kit/kit.h"
#include <ctype.h>
#include <float.h>
#include <limits.h>
#include <math.h>
#include <pthread.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#if defined(__GNUC__)
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include <stb/stb_easy_font.h>
#if defined(__GNUC__)
#pragma GCC diagnostic pop
#endif

static int software;                        /* the renderer is a CPU: timer queries would answer before it has drawn */

/* ---- >>gl: what every engine has a wrapper for ------------------------------------------------------------------- */

static GLuint shader_of(GLenum stage, const char *text, kit_error *err)
{
    char log[600] = "";
    GLint good = 0;
    const GLuint s = glCreateShader(stage);
    glShaderSource(s, 1, &text, NULL);
    glCompileShader(s);
    glGetShaderiv(s, GL_COMPILE_STATUS, &good);
    if (good) return s;
    glGetShaderInfoLog(s, sizeof log, NULL, log);
    glDeleteShader(s);
    return kit_fail(err, "a shader does not compile: %.500s", log), 0u;
}

static GLuint program_of(const char *vertex, const char *fragment, kit_error *err)
{
    const GLuint stage[2] = { shader_of(GL_VERTEX_SHADER, vertex, err), shader_of(GL_FRAGMENT_SHADER, fragment, err) };
    const GLuint p = glCreateProgram();
    GLint good = 0;
    for (int i = 0; i < 2 && stage[0] && stage[1]; ++i) glAttachShader(p, stage[i]);
    if (stage[0] && stage[1]) glLinkProgram(p);
    glGetProgramiv(p, GL_LINK_STATUS, &good);
    for (int i = 0; i < 2; ++i) glDeleteShader(stage[i]);
    if (good) return p;
    if (stage[0] && stage[1]) kit_fail(err, "a program does not link");
    glDeleteProgram(p);
    return 0;
}

/* slices 0: a 2D texture, else an array. One level and nearest texels: complete without mips. */
static GLuint texture_of(int width, int height, int slices, GLenum internal, GLenum format, GLenum type,
                         const void *data)
{
    const GLenum target = slices ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D;
    GLuint t;
    glGenTextures(1, &t);
    glBindTexture(target, t);
    if (slices) glTexImage3D(target, 0, (GLint)internal, width, height, slices, 0, format, type, data);
    else        glTexImage2D(target, 0, (GLint)internal, width, height, 0, format, type, data);
    glTexParameteri(target, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
    glTexParameteri(target, GL_TEXTURE_WRAP_S, GL_CLAMP_TO_EDGE);
    glTexParameteri(target, GL_TEXTURE_WRAP_T, GL_CLAMP_TO_EDGE);
    return t;
}

static GLuint framebuffer_of(const GLuint *colour, int colours, GLuint depth)
{
    GLenum attached[8];
    GLuint f;
    glGenFramebuffers(1, &f);
    glBindFramebuffer(GL_FRAMEBUFFER, f);
    for (int i = 0; i < colours; ++i) {
        attached[i] = GL_COLOR_ATTACHMENT0 + (GLenum)i;
        glFramebufferTexture2D(GL_FRAMEBUFFER, attached[i], GL_TEXTURE_2D, colour[i], 0);
    }
    if (depth) glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth, 0);
    glDrawBuffers(colours, attached);
    return f;
}

static void bind(GLuint unit, GLenum target, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(target, texture);
}

/* GPU time of what is drawn between begin and end; its answers come some frames later, and none waits for them. */
enum { RING = 4 };
typedef struct timer { GLuint query[RING]; unsigned turn; double began, ms; } timer;

static void timer_begin(timer *t)
{
    if (software) { glFinish(); t->began = kit_seconds(); return; }
    const unsigned k = t->turn % RING;
    if (!t->query[0]) glGenQueries(RING, t->query);
    if (t->turn >= RING) {
        GLuint there = 0;
        GLuint64 ns = 0;
        glGetQueryObjectuiv(t->query[k], GL_QUERY_RESULT_AVAILABLE, &there);
        if (there) {
            glGetQueryObjectui64v(t->query[k], GL_QUERY_RESULT, &ns);
            t->ms += ((double)ns * 1e-6 - t->ms) * (t->ms > 0 ? 0.1 : 1);
        }
    }
    glBeginQuery(GL_TIME_ELAPSED, t->query[k]);
}

static void timer_end(timer *t)
{
    ++t->turn;
    if (!software) { glEndQuery(GL_TIME_ELAPSED); return; }
    glFinish();
    const double ms = (kit_seconds() - t->began) * 1e3;
    t->ms += (ms - t->ms) * (t->ms > 0 ? 0.3 : 1);
}

/* ---- >>gltf: positions, normals, indices, base colours, the nodes' transforms; nothing else ---------------------- */

/* A value of JSON: kind is one of { [ " 0 t; text: of a string, a number or a word. key: in an object. Both are offsets
   into the file. Its items are so many from first on in gltf's; next is for the parser alone. */
typedef struct json { uint32_t text, length, key, keys; int next, first, items; char kind; } json;

/* What a file may ask for: a small one can name one mesh a thousand times, and so on down. */
enum { DEEPEST = 64, MOST_KEYS = 256, BUFFERS = 16, DEEPEST_NODE = 1000, MOST_PRIMITIVES = 1 << 18,
       MOST_TRIANGLES = 1 << 24 };
static const double FARTHEST = 1e15;        /* as of an OBJ: squares of distances are floats, too */

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
        if (!(fabs(at) <= FARTHEST)) return -1;
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
                return kit_fail(g->err, "%s: a vertex is not within %g of 0", g->path, FARTHEST);
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

static int gltf_load(kit_scene *s, const char *path, kit_error *err)
{
    gltf g = { .path = path, .err = err };
    char *text = NULL;
    size_t size;
    double half = 0;
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
    for (int i = 0; i < 3; ++i) half += pow(0.5 * ((double)s->mesh.upper[i] - (double)s->mesh.lower[i]), 2);
    half = sqrt(half);
    s->name = path;
    s->radius = (float)(0.2 * half);        /* a tenth of the diagonal, as for OBJ */
    s->camera.fovy = 45;
    s->camera.up[1] = 1;
    for (int i = 0; i < 3; ++i) {           /* from the front, above and to the right */
        static const double back[3] = { 0.391, 0.304, 0.869 };
        s->camera.target[i] = 0.5f * (s->mesh.lower[i] + s->mesh.upper[i]);
        s->camera.eye[i] = s->camera.target[i] + (float)(back[i] * half * 2.2);
    }
    return 0;
}

/* ---- >>gbuffer: depth, normals, colours, and what lies behind ---------------------------------------------------- */

typedef struct gbuffer {
    int    width, height;
    GLuint array, vertices, draw, peel;     /* programs */
    GLsizei count;
    GLuint depth, normal, albedo, framebuffer;
    GLuint back, back_framebuffer;          /* depth of the nearest back faces */
    GLuint slabs, seen[2], slab_depth, slab_framebuffer[2];
    timer  time, slab_time;
} gbuffer;

static const char scene_vs[] =
    "#version 330 core\n"
    "layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;\n"
    "layout(location = 2) in vec3 a_face; layout(location = 3) in vec3 a_albedo;\n"
    "uniform mat4 view, projection;\n"
    "out vec3 v_position, v_normal; flat out vec3 v_face, v_albedo;\n"
    "invariant gl_Position;\n"
    "void main() {\n"
    "    vec4 p = view * vec4(a_position, 1.0);\n"
    "    v_position = p.xyz; v_normal = mat3(view) * a_normal; v_face = mat3(view) * a_face; v_albedo = a_albedo;\n"
    "    gl_Position = projection * p;\n"
    "}\n";
static const char scene_fs[] =              /* normals to the side that is seen: meshes are wound as they please */
    "#version 330 core\n"
    "in vec3 v_position, v_normal; flat in vec3 v_face, v_albedo; uniform float flat_view;\n"
    "layout(location = 0) out vec4 o_normal; layout(location = 1) out vec4 o_albedo;\n"
    "void main() {\n"
    "    vec3 face = dot(v_face, flat_view > 0.0 ? vec3(0.0, 0.0, -1.0) : v_position) > 0.0 ? -v_face : v_face;\n"
    "    vec3 n = dot(v_normal, v_normal) > 0.0 ? normalize(v_normal) : face;\n"
    "    o_normal = vec4(dot(n, face) < 0.0 ? -n : n, 0.0); o_albedo = vec4(v_albedo, 1.0);\n"
    "}\n";
static const char peel_fs[] =               /* window depth into the channel that the mask leaves */
    "#version 330 core\n"
    "in vec3 v_position; uniform sampler2D before;\n"
    "layout(location = 0) out vec4 o_slab; layout(location = 1) out float o_seen;\n"
    "void main() {\n"
    "    if (!(-v_position.z > 1.000004 * texelFetch(before, ivec2(gl_FragCoord.xy), 0).x)) discard;\n"
    "    o_slab = vec4(gl_FragCoord.z); o_seen = -v_position.z;\n"
    "}\n";

static int gbuffer_open(gbuffer *g, const kit_mesh *mesh, kit_error *err)
{
    float *v = malloc(mesh->triangles * 36 * sizeof *v);
    memset(g, 0, sizeof *g);
    if (!v || mesh->triangles > 0x7fffffff / 3) {
        free(v);
        return kit_fail(err, "%zu triangles are too many", mesh->triangles);
    }
    for (size_t t = 0; t < mesh->triangles; ++t) {
        const float *p = mesh->position + 9 * t;
        float face[3], length = 0;
        for (int i = 0; i < 3; ++i) {
            const int a = (i + 1) % 3, b = (i + 2) % 3;
            face[i] = (p[3 + a] - p[a]) * (p[6 + b] - p[b]) - (p[3 + b] - p[b]) * (p[6 + a] - p[a]);
            length += face[i] * face[i];
        }
        for (int i = 0; i < 3 && length > 0; ++i) face[i] /= sqrtf(length);
        for (size_t k = 0; k < 3; ++k) {
            float *to = v + 36 * t + 12 * k;
            memcpy(to, p + 3 * k, 3 * sizeof *to);
            memcpy(to + 3, mesh->normal + 9 * t + 3 * k, 3 * sizeof *to);
            memcpy(to + 6, face, 3 * sizeof *to);
            memcpy(to + 9, mesh->albedo + 3 * t, 3 * sizeof *to);
        }
    }
    g->count = (GLsizei)(3 * mesh->triangles);
    glGenVertexArrays(1, &g->array);
    glBindVertexArray(g->array);
    glGenBuffers(1, &g->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, g->vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(mesh->triangles * 36 * sizeof *v), v, GL_STATIC_DRAW);
    free(v);
    for (GLuint i = 0; i < 4; ++i) {
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 48, (const void *)(size_t)(12 * i));
        glEnableVertexAttribArray(i);
    }
    g->draw = program_of(scene_vs, scene_fs, err);
    g->peel = program_of(scene_vs, peel_fs, err);
    return g->draw && g->peel ? 0 : -1;
}

static void gbuffer_size(gbuffer *g, int width, int height)
{
    GLuint *const made[] = { &g->depth, &g->normal, &g->albedo, &g->back,
                             &g->slabs, &g->slab_depth, &g->seen[0], &g->seen[1] };
    for (size_t i = 0; i < sizeof made / sizeof *made; ++i) glDeleteTextures(1, made[i]);
    glDeleteFramebuffers(1, &g->framebuffer);
    glDeleteFramebuffers(1, &g->back_framebuffer);
    glDeleteFramebuffers(2, g->slab_framebuffer);
    g->width = width;
    g->height = height;
    g->depth = texture_of(width, height, 0, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    g->normal = texture_of(width, height, 0, GL_RGBA16F, GL_RGBA, GL_FLOAT, NULL);
    g->albedo = texture_of(width, height, 0, GL_RGBA16F, GL_RGBA, GL_FLOAT, NULL);
    g->framebuffer = framebuffer_of((const GLuint[]){ g->normal, g->albedo }, 2, g->depth);
    g->back = texture_of(width, height, 0, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    g->back_framebuffer = framebuffer_of(NULL, 0, g->back);
    g->slabs = texture_of(width, height, 0, GL_RGBA32F, GL_RGBA, GL_FLOAT, NULL);
    g->slab_depth = texture_of(width, height, 0, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    for (int i = 0; i < 2; ++i) g->seen[i] = texture_of(width, height, 0, GL_R32F, GL_RED, GL_FLOAT, NULL);
    for (int i = 0; i < 2; ++i)
        g->slab_framebuffer[i] = framebuffer_of((const GLuint[]){ g->slabs, g->seen[i] }, 2, g->slab_depth);
}

static void gbuffer_use(const gbuffer *g, GLuint program, GLuint framebuffer, const float view[16],
                        const float projection[16])
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, g->width, g->height);
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "view"), 1, GL_FALSE, view);
    glUniformMatrix4fv(glGetUniformLocation(program, "projection"), 1, GL_FALSE, projection);
}

/* behind: SSGI_GL_THICKNESS_BACK wants one more draw, depth alone; _SLABS three, each of which peels by the one before. */
static void gbuffer_draw(gbuffer *g, const float view[16], const float projection[16], int behind)
{
    static const GLfloat none[4], all_far[4] = { 1, 1, 1, 1 }, farthest = 1;
    glBindVertexArray(g->array);
    glEnable(GL_DEPTH_TEST);
    timer_begin(&g->time);
    gbuffer_use(g, g->draw, g->framebuffer, view, projection);
    glUniform1f(glGetUniformLocation(g->draw, "flat_view"), projection[15]);
    for (GLint i = 0; i < 2; ++i) glClearBufferfv(GL_COLOR, i, none);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glDrawArrays(GL_TRIANGLES, 0, g->count);
    timer_end(&g->time);
    if (behind < SSGI_GL_THICKNESS_BACK) { glDisable(GL_DEPTH_TEST); return; }
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    timer_begin(&g->slab_time);
    if (behind == SSGI_GL_THICKNESS_BACK) {
        gbuffer_use(g, g->draw, g->back_framebuffer, view, projection);
        glClearBufferfv(GL_DEPTH, 0, &farthest);
        glDrawArrays(GL_TRIANGLES, 0, g->count);
    }
    for (int i = 0; i < 3 && behind == SSGI_GL_THICKNESS_SLABS; ++i) {
        gbuffer_use(g, g->peel, g->slab_framebuffer[i & 1], view, projection);
        if (!i) {
            glBindFramebuffer(GL_FRAMEBUFFER, g->slab_framebuffer[1]);
            glClearBufferfv(GL_COLOR, 0, all_far);
            glClearBufferfv(GL_COLOR, 1, none);
            glBindFramebuffer(GL_FRAMEBUFFER, g->slab_framebuffer[0]);
        }
        glClearBufferfv(GL_COLOR, 1, (const GLfloat[4]){ 1e18f, 0, 0, 0 });
        glClearBufferfv(GL_DEPTH, 0, &farthest);
        bind(0, GL_TEXTURE_2D, g->seen[!(i & 1)]);
        glColorMaski(0, i == 0, i == 1, i == 2, GL_FALSE);
        glCullFace(i == 1 ? GL_BACK : GL_FRONT);
        glDrawArrays(GL_TRIANGLES, 0, g->count);
    }
    timer_end(&g->slab_time);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}

/* ==== >>ssgi: a method, whichever, by its steps =================================================================== */

enum { STEPS = 32, TEXTURES = 48 };
typedef struct chain {
    ssgi_gl_step step[STEPS];
    int    steps, light, bounce;            /* numbers of the results' textures, -1: there is none */
    GLuint program[STEPS], framebuffer[STEPS][2], texture[TEXTURES][2], block;
    timer  time[STEPS];
    unsigned drawn;                         /* frames; what is kept over them is written in turn */
} chain;

/* Programs by ssgi_gl_key: methods share passes, and what was chosen once may be chosen again. */
static GLuint chain_program(const ssgi_gl_step *s, kit_error *err)
{
    static struct { uint64_t key; GLuint program; } kept[256];
    static int count;
    static char text[2][65536];
    const uint64_t key = ssgi_gl_key(&s->desc);
    GLuint p;
    for (int i = 0; i < count; ++i) if (kept[i].key == key) return kept[i].program;
    for (int i = 0; i < 2; ++i)
        if (ssgi_gl_emit(text[i], sizeof text[i], &s->desc, i) >= sizeof text[i])
            return kit_fail(err, "pass %s: its text is too long", ssgi_gl_pass_name(s->desc.pass)), 0u;
    p = program_of(text[SSGI_GL_VERTEX], text[SSGI_GL_FRAGMENT], err);
    if (!p) return 0;
    glUseProgram(p);
    for (int k = 0; k < s->inputs; ++k) glUniform1i(glGetUniformLocation(p, s->input[k].name), s->input[k].unit);
    glUniformBlockBinding(p, glGetUniformBlockIndex(p, "ssgi_frame"), 0);
    if (count < 256) { kept[count].key = key; kept[count++].program = p; }
    return p;
}

static void chain_close(chain *c)
{
    for (int i = 0; i < TEXTURES; ++i) {
        if (c->texture[i][1] != c->texture[i][0]) glDeleteTextures(1, &c->texture[i][1]);
        glDeleteTextures(1, &c->texture[i][0]);
    }
    for (int i = 0; i < STEPS; ++i) {
        glDeleteFramebuffers(2, c->framebuffer[i]);
        if (c->time[i].query[0]) glDeleteQueries(RING, c->time[i].query);
    }
    glDeleteBuffers(1, &c->block);
    memset(c, 0, sizeof *c);
}

static int chain_open(chain *c, const ssgi_gl_chain *want, kit_error *err)
{
    const char *why = "more steps than this example has room for";
    memset(c, 0, sizeof *c);
    c->light = c->bounce = -1;
    c->steps = ssgi_gl_steps(c->step, STEPS, want, &why);
    if (!c->steps || c->steps > STEPS) { c->steps = 0; return kit_fail(err, "%s", why); }
    glGenBuffers(1, &c->block);
    for (int i = 0; i < c->steps; ++i) {
        const ssgi_gl_step *s = &c->step[i];
        if (!(c->program[i] = chain_program(s, err))) return -1;
        for (int turn = 0; turn < 2; ++turn) {              /* what history keeps is there twice */
            GLenum attached[6];
            glGenFramebuffers(1, &c->framebuffer[i][turn]);
            for (int o = 0; o < s->outputs; ++o) {
                const ssgi_gl_output *out = &s->output[o];
                GLuint *t = c->texture[out->texture];
                attached[o] = GL_COLOR_ATTACHMENT0 + (GLenum)o;
                if (!t[turn])
                    t[turn] = turn && !out->kept
                                  ? t[0]
                                  : texture_of(s->width, s->height, out->slices, out->format->internal,
                                               out->format->format, out->format->type, NULL);
                glBindFramebuffer(GL_FRAMEBUFFER, c->framebuffer[i][turn]);
                if (out->slices) glFramebufferTextureLayer(GL_FRAMEBUFFER, attached[o], t[turn], 0, out->slice);
                else             glFramebufferTexture2D(GL_FRAMEBUFFER, attached[o], GL_TEXTURE_2D, t[turn], 0);
                if (out->result == SSGI_GL_RESULT_LIGHT) c->light = out->texture;
                if (out->result == SSGI_GL_RESULT_BOUNCE) c->bounce = out->texture;
            }
            glDrawBuffers(s->outputs, attached);
            if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
                return kit_fail(err, "%s: this GL cannot draw into its targets", ssgi_gl_pass_name(s->desc.pass));
            for (int o = 0; o < s->outputs; ++o) {          /* once, so that no first frame reads what memory held */
                if (s->output[o].format->type == GL_UNSIGNED_INT) glClearBufferuiv(GL_COLOR, o, (const GLuint[4]){ 0 });
                else glClearBufferfv(GL_COLOR, o, (const GLfloat[4]){ 0 });
            }
        }
    }
    return 0;
}

/* yours: textures by their meaning. State that is expected: depth test, blending, culling and scissor off. */
static void chain_draw(chain *c, const ssgi_gl_frame *frame, const GLuint yours[SSGI_GL_YOURS])
{
    const unsigned turn = c->drawn++ & 1;
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, c->block);
    glBufferData(GL_UNIFORM_BUFFER, sizeof *frame, frame, GL_DYNAMIC_DRAW);
    for (int i = 0; i < c->steps; ++i) {
        const ssgi_gl_step *s = &c->step[i];
        for (int k = 0; k < s->inputs; ++k) {
            const ssgi_gl_input *in = &s->input[k];
            bind((GLuint)in->unit, in->target,
                 in->texture < 0 ? yours[in->meaning] : c->texture[in->texture][turn ^ (unsigned)in->last]);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, c->framebuffer[i][turn]);
        glViewport(0, 0, s->width, s->height);
        glUseProgram(c->program[i]);
        timer_begin(&c->time[i]);
        glDrawArraysInstanced(s->primitive, 0, s->vertices, s->instances);
        timer_end(&c->time[i]);
    }
}

static GLuint chain_result(const chain *c, int number) { return number < 0 ? 0 : c->texture[number][!(c->drawn & 1)]; }

/* ================================================================================================================== */

/* ---- >>methods: what may stand on a half of the window ----------------------------------------------------------- */

static const struct { const char *name; int pass, search, lit; float thickness; } methods[] = {
    { "ssao", SSGI_GL_SSAO, 0, 0, 1 },
    { "hsao", SSGI_GL_HSAO, SSGI_GL_SLICES, 0, 0.6f },
    { "hsao-march", SSGI_GL_HSAO, SSGI_GL_MARCH, 0, 0.5f },
    { "ssdo", SSGI_GL_SSDO, SSGI_GL_SLICES, 1, 0.4f },
    { "ssdo-points", SSGI_GL_SSDO, SSGI_GL_POINTS, 1, 0.7f },
    { "s3ho", SSGI_GL_S3HO, SSGI_GL_SLICES, 1, 0.4f }
};
enum { METHODS = (int)(sizeof methods / sizeof *methods), TRUTH = METHODS, OPEN = 32, MAP = 64 };
static const char *const presets[] = { "fast", "balanced", "best" };
static const char *const behinds[] = { "constant", "solid", "back", "slabs" };

typedef struct half {
    int       method, preset, known;        /* known: last is of the frame before */
    chain     chain;
    ssgi_view last;
    float     last_to_view[16], harmonics[48];
    GLuint    environment, irradiance, picture, framebuffer;  /* picture: linear; alpha 0 where nothing is seen */
    double    error;
} half;

/* ---- >>truth: traced by the kit beside the drawing, a 64th of the pixels at a time ------------------------------- */

typedef struct progress {
    unsigned version;                       /* counts what was added */
    int      tracing, rounds;               /* rays a pixel of the round that is traced now; rounds that are whole */
    float    share;                         /* of that round */
} progress;

typedef struct truth {
    pthread_t          thread;
    pthread_mutex_t    lock;                /* of all below: the thread reads what is wanted and writes what it found */
    pthread_cond_t     wake;
    const kit_scene   *scene;
    const kit_lighting *lighting;
    kit_camera         camera;              /* what is wanted; everything below as well */
    float              radius;
    int                lit, started, quit, failed;
    unsigned           wanted;              /* counts requests: another number cancels what is being traced */
    progress           now;
    float             *rgb;
    int               *rays;                /* a pixel; 0: not known, rgb is a neighbour's */
    kit_error          err;                 /* of what failed */
} truth;

/* What the kit skips by stride 8 is cheap, and shift moves which 64th it does not skip. The picture's sides are rounded
   up to multiples of 8; its pixels stay as large. A pixel's number turns its rays: columns on the right and rows above
   that nobody looks at make another number of each 64th, else 8 x 8 pixels would share their noise. */
static kit_camera truth_camera(const kit_camera *c, int i, int j)
{
    const double pi = 3.14159265358979323846;
    kit_camera to = *c;
    to.width = (c->width + 7) / 8 * 8 + 8 * i;
    to.height = (c->height + 7) / 8 * 8 + 8 * j;
    to.fovy = (float)(360 / pi * atan(tan((double)c->fovy * pi / 360) * to.height / c->height));
    to.ortho_height = c->ortho_height * (float)to.height / (float)c->height;
    to.shift[0] = 4 - (float)i + 0.5f * (float)(c->width - to.width);
    to.shift[1] = (float)j - 4 + 0.5f * (float)(to.height - c->height) - 8 * (float)j;
    return to;
}

/* Into the picture; in the first round also into what is not known around it, so that it is seen at once. */
static void truth_add(truth *t, const kit_image *traced, int lit, int rays, int k, int i, int j)
{
    const int above = 8 * j, w = t->camera.width, h = t->camera.height, block = k == 0 ? 8 : k < 4 ? 4 : k < 16 ? 2 : 1;
    const size_t pixels = (size_t)traced->width * (size_t)traced->height;
    for (int y = 4 + above; y < traced->height; y += 8)
        for (int x = 4; x < traced->width; x += 8) {
            const int at[2] = { x + i - 4, y - above + j - 4 };
            if (at[0] >= w) break;
            for (int b = 0; b < block * block; ++b) {
                const int px = at[0] + b % block, py = at[1] + b / block;
                if (px >= w || py >= h || (b && t->rays[py * w + px])) continue;
                for (size_t c = 0; c < 3; ++c)
                    t->rgb[3 * (size_t)(py * w + px) + c] =
                        traced->data[(lit ? c * pixels : 0) + (size_t)y * (size_t)traced->width + (size_t)x];
                if (!b) t->rays[py * w + px] = rays;
            }
        }
    t->now.share = (float)(k + 1) / 64;
    t->now.tracing = rays;
    t->now.rounds += k == 63;
    ++t->now.version;
}

static void *truth_thread(void *context)
{
    static const int rounds[] = { 16, 64, 256, 1024 };
    truth *t = context;
    unsigned done = 0;
    pthread_mutex_lock(&t->lock);
    for (;;) {
        while (!t->quit && t->wanted == done) pthread_cond_wait(&t->wake, &t->lock);
        if (t->quit) break;
        const unsigned now = t->wanted;
        const kit_camera camera = t->camera;
        const float radius = t->radius;
        const int lit = t->lit;
        for (int k = 0; k < 64 * 4 && t->wanted == now && !t->quit && !t->failed; ++k) {
            const int rays = rounds[k / 64], b = k % 64;
            const int i = (b & 1) * 4 + (b >> 2 & 1) * 2 + (b >> 4 & 1);
            const int j = (b >> 1 & 1) * 4 + (b >> 3 & 1) * 2 + (b >> 5 & 1);
            const kit_camera part = truth_camera(&camera, i, j);
            kit_image traced;
            kit_error err;
            pthread_mutex_unlock(&t->lock);
            const int failed =
                lit ? kit_truth_lit(&traced, t->scene, &part, t->lighting, radius, KIT_ATTENUATION_LINEAR, 1, rays, 8,
                                    &err)
                    : kit_truth_ao(&traced, t->scene, &part, radius, KIT_ATTENUATION_LINEAR, rays, 8, &err);
            pthread_mutex_lock(&t->lock);
            if (!failed && t->wanted == now) truth_add(t, &traced, lit, rays, b, i, j);
            if (!failed) kit_image_free(&traced);
            else if (t->wanted == now) { t->failed = 1; t->err = err; }
        }
        done = now;
    }
    pthread_mutex_unlock(&t->lock);
    return NULL;
}

/* Starts over when anything that it depends on is another than before. What is wanted is written here alone: it may be
   read here without the lock. */
static int truth_want(truth *t, const kit_camera *camera, float radius, int lit, kit_error *err)
{
    const size_t pixels = (size_t)camera->width * (size_t)camera->height;
    if (t->started && !memcmp(&t->camera, camera, sizeof *camera) && t->radius == radius && t->lit == lit) return 0;
    float *rgb = calloc(3 * pixels, sizeof *rgb);
    int *rays = calloc(pixels, sizeof *rays);
    if (!rgb || !rays) {
        free(rgb);
        free(rays);
        return kit_fail(err, "no memory for a truth of %d x %d", camera->width, camera->height);
    }
    pthread_mutex_lock(&t->lock);
    free(t->rgb);
    free(t->rays);
    t->rgb = rgb;
    t->rays = rays;
    t->camera = *camera;
    t->radius = radius;
    t->lit = lit;
    t->failed = 0;
    t->now = (progress){ .version = t->now.version + 1 };
    ++t->wanted;
    pthread_cond_signal(&t->wake);
    pthread_mutex_unlock(&t->lock);
    if (!t->started) t->started = !pthread_create(&t->thread, NULL, truth_thread, t);
    return t->started ? 0 : kit_fail(err, "no thread for the truth");
}

static void truth_close(truth *t)
{
    pthread_mutex_lock(&t->lock);
    t->quit = 1;
    ++t->wanted;
    pthread_cond_signal(&t->wake);
    pthread_mutex_unlock(&t->lock);
    if (t->started) pthread_join(t->thread, NULL);
    free(t->rgb);
    free(t->rays);
}

/* ---- >>viewer: what is chosen, and a frame of it ----------------------------------------------------------------- */

typedef struct viewer {
    GLFWwindow  *window;
    kit_scene    scene;
    kit_lighting lighting;
    float       *equirect;                  /* the environment's texels, interleaved */
    kit_camera   camera, home;
    float        radius, split;
    int          behind, from_depth, history, split_on, error, colours, help, panel, dirty, shots;
    gbuffer      gbuffer;
    half         half[2];
    truth        truth;
    progress     shown;                     /* of the truth, when its picture was made */
    unsigned     frame;
    double       mouse[2], scored;
    GLuint       resolve, display, text, quads, truth_picture;
    char         note[256];
    double       noted;
    const char  *shot, *env;
    int          frames;
    kit_error    err;
} viewer;

static const char screen_vs[] =
    "#version 330 core\n"
    "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n";
static const char resolve_fs[] =            /* ambient visibility; or albedo * (light + bounce) */
    "#version 330 core\n"
    "uniform sampler2D light, bounce, albedo, depth; uniform int lit; out vec4 o;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
    "    bool seen = texelFetch(depth, p, 0).x < 1.0;\n"
    "    vec3 l = texelFetch(light, p, 0).rgb + (lit > 1 ? texelFetch(bounce, p, 0).rgb : vec3(0.0));\n"
    "    vec3 sent = seen ? texelFetch(albedo, p, 0).rgb * l : vec3(0.0);\n"
    "    o = vec4(lit == 0 ? texelFetch(light, p, 0).xxx : sent, seen);\n"
    "}\n";
static const char display_fs[] =
    "#version 330 core\n"
    "uniform sampler2D half0, half1, albedo; uniform float split; uniform ivec2 kind; out vec4 o;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
    "    bool first = float(p.x) < split;\n"
    "    vec3 c = first ? texelFetch(half0, p, 0).rgb : texelFetch(half1, p, 0).rgb;\n"
    "    int k = first ? kind.x : kind.y; // 0: visibility; 1: the same on colours; 2: radiance\n"
    "    vec4 a = texelFetch(albedo, p, 0);\n"
    "    if (k == 1) c = a.a > 0.0 ? c * a.rgb : vec3(0.2);\n"
    "    vec3 encoded = 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055;\n"
    "    if (k > 0) c = mix(encoded, 12.92 * c, lessThan(c, vec3(0.0031308)));\n"
    "    o = vec4(abs(float(p.x) + 0.5 - split) < 1.0 ? vec3(1.0, 0.6, 0.1) : c, 1.0);\n"
    "}\n";
static const char text_vs[] =
    "#version 330 core\n"
    "layout(location = 0) in vec3 a_at; uniform vec4 place; // scale, and pixels to the screen\n"
    "void main() { gl_Position = vec4(a_at.xy * place.x * place.yz * 2.0 + vec2(-1.0, 1.0), 0.0, 1.0); }\n";
static const char text_fs[] = "#version 330 core\nuniform vec4 colour; out vec4 o;\nvoid main() { o = colour; }\n";

static void say(viewer *v, const char *text)
{
    snprintf(v->note, sizeof v->note, "%.240s", text);
    v->noted = kit_seconds();
}

/* The environment as a half's method reads it: harmonics, a map over a direction's solid angle, irradiance. */
static int environment_open(viewer *v, half *h, const ssgi_gl_desc *d)
{
    const kit_image *env = &v->lighting.env;
    const int harmonics = d->pass == SSGI_GL_S3HO;
    const double share = d->search == SSGI_GL_POINTS ? 2.0 / d->samples : 0.75 / d->directions;
    const float angle = (float)(3.14159265358979323846 * share);    /* of a direction's lobe */
    static float map[3 * MAP * MAP], open[3 * OPEN * OPEN];
    const char *why = "";
    ssgi_result r;
    if (harmonics) {
        r = ssgi_sh_project_equirect(h->harmonics, 4, v->equirect, env->width, env->height, &why);
        if (r == SSGI_OK) r = ssgi_environment_map(open, OPEN, v->equirect, env->width, env->height, 0, &why);
        if (r == SSGI_OK) r = ssgi_sh_residual(open, OPEN, h->harmonics, 4, NULL, 0, &why);
    } else {
        r = ssgi_environment_map(map, MAP, v->equirect, env->width, env->height, angle, &why);
        if (r == SSGI_OK) r = ssgi_environment_cone(open, OPEN, v->equirect, env->width, env->height, 0, &why);
        h->environment = texture_of(MAP, MAP, 0, GL_RGBA32F, GL_RGB, GL_FLOAT, map);
    }
    h->irradiance = texture_of(OPEN, OPEN, 1, GL_RGBA32F, GL_RGB, GL_FLOAT, open);
    return r == SSGI_OK ? 0 : kit_fail(&v->err, "--env: %s", why);
}

/* What the half's method is, as a chain: the desc that an embedder chooses, and what is drawn around it. */
static int half_open(viewer *v, half *h)
{
    const int m = h->method;
    ssgi_gl_chain want;
    const char *why = "";
    chain_close(&h->chain);
    glDeleteTextures(1, &h->environment);
    glDeleteTextures(1, &h->irradiance);
    glDeleteTextures(1, &h->picture);
    glDeleteFramebuffers(1, &h->framebuffer);
    h->environment = h->irradiance = 0;
    h->known = 0;
    h->picture = texture_of(v->gbuffer.width, v->gbuffer.height, 0, GL_RGBA32F, GL_RGBA, GL_FLOAT, NULL);
    h->framebuffer = framebuffer_of(&h->picture, 1, 0);
    if (m == TRUTH) return 0;
    memset(&want, 0, sizeof want);
    want.desc.pass = methods[m].pass;
    want.desc.search = methods[m].search;
    want.desc.environment = methods[m].lit ? SSGI_GL_ENVIRONMENT_MAP : SSGI_GL_ENVIRONMENT_NONE;
    if (ssgi_gl_preset(&want.desc, h->preset, &why) != SSGI_OK) return kit_fail(&v->err, "%s", why);
    want.desc.thickness = v->behind;
    want.desc.orthographic = !(v->camera.fovy > 0);
    want.desc.normal = v->from_depth ? SSGI_GL_NORMAL_FROM_DEPTH : SSGI_GL_NORMAL_SIGNED;
    if (methods[m].pass == SSGI_GL_SSDO) want.desc.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE;
    if (methods[m].pass == SSGI_GL_S3HO) {
        want.desc.bands = 4;
        want.desc.packed = want.desc.shaded = want.desc.residual = 1;
        want.desc.transfer = SSGI_GL_TRANSFER_BOTH;
        want.desc.restore = SSGI_GL_RESTORE_DIFFERENCE;
    }
    want.width = v->gbuffer.width;
    want.height = v->gbuffer.height;
    want.blur = 1;
    want.history = v->history;
    if (methods[m].lit && environment_open(v, h, &want.desc)) return -1;
    return chain_open(&h->chain, &want, &v->err);
}

/* The uniform block of a half: what changes per frame. */
static int frame_of(viewer *v, half *h, ssgi_gl_frame *f, const float to_view[16], const float projection[16])
{
    const char *why = "";
    ssgi_view view;
    if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, v->camera.width, v->camera.height, &why)
        || ssgi_gl_frame_init(f, &view, v->radius, &why)) return kit_fail(&v->err, "%s", why);
    f->thickness = methods[h->method].thickness * v->radius;
    for (int i = 0; i < 12; ++i) f->rotation[i] = i % 4 < 3 ? to_view[i] : 0;
    if (methods[h->method].pass == SSGI_GL_S3HO && ssgi_gl_harmonics_set(f, h->harmonics, 4, to_view, &why))
        return kit_fail(&v->err, "%s", why);
    if (v->history) {
        f->phase = ssgi_gl_phase(v->frame);
        if (h->known && ssgi_gl_frame_history(f, &h->last, to_view, h->last_to_view, &why))
            return kit_fail(&v->err, "%s", why);
    }
    h->last = view;
    memcpy(h->last_to_view, to_view, sizeof h->last_to_view);
    h->known = 1;
    return 0;
}

static int half_draw(viewer *v, half *h, const float to_view[16], const float projection[16])
{
    GLuint yours[SSGI_GL_YOURS] = { 0 };
    ssgi_gl_frame frame;
    const chain *c = &h->chain;
    if (frame_of(v, h, &frame, to_view, projection)) return -1;
    yours[SSGI_GL_YOUR_DEPTH] = v->gbuffer.depth;
    yours[SSGI_GL_YOUR_NORMAL] = v->gbuffer.normal;
    yours[SSGI_GL_YOUR_ALBEDO] = v->gbuffer.albedo;
    yours[SSGI_GL_YOUR_BACK] = v->behind == SSGI_GL_THICKNESS_SLABS ? v->gbuffer.slabs : v->gbuffer.back;
    yours[SSGI_GL_YOUR_ENVIRONMENT] = h->environment;
    yours[SSGI_GL_YOUR_IRRADIANCE] = h->irradiance;
    chain_draw(&h->chain, &frame, yours);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glViewport(0, 0, v->gbuffer.width, v->gbuffer.height);
    glUseProgram(v->resolve);
    bind(0, GL_TEXTURE_2D, chain_result(c, c->light));
    bind(1, GL_TEXTURE_2D, chain_result(c, c->bounce));
    bind(2, GL_TEXTURE_2D, v->gbuffer.albedo);
    bind(3, GL_TEXTURE_2D, v->gbuffer.depth);
    glUniform1i(glGetUniformLocation(v->resolve, "lit"), !methods[h->method].lit ? 0 : c->bounce < 0 ? 1 : 2);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return 0;
}

static float *half_read(const viewer *v, const half *h)      /* four floats a pixel, bottom row first */
{
    float *p = malloc((size_t)v->gbuffer.width * (size_t)v->gbuffer.height * 4 * sizeof *p);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    if (p) glReadPixels(0, 0, v->gbuffer.width, v->gbuffer.height, GL_RGBA, GL_FLOAT, p);
    return p;
}

/* RMSE where something is seen and the truth is known: of visibility, or of radiance over its mean. */
static void half_score(viewer *v, half *h)
{
    const int w = v->gbuffer.width, height = v->gbuffer.height;
    double sum = 0, mean = 0, count = 0;
    float *p;
    h->error = (double)NAN;
    if (h->method == TRUTH || methods[h->method].lit != v->truth.lit || !(p = half_read(v, h))) return;
    pthread_mutex_lock(&v->truth.lock);
    for (int i = 0; i < w * height; ++i) {
        const int from = (height - 1 - i / w) * w + i % w;
        if (!v->truth.rays[i] || !(p[4 * from + 3] > 0)) continue;
        for (int c = 0; c < 3; ++c) {
            const double is = (double)v->truth.rgb[3 * i + c];
            sum += ((double)p[4 * from + c] - is) * ((double)p[4 * from + c] - is);
            mean += is;
            count += 1;
        }
    }
    pthread_mutex_unlock(&v->truth.lock);
    free(p);
    if (count > 0) h->error = sqrt(sum / count) / (v->truth.lit ? fmax(mean / count, 1e-9) : 1);
}

/* The truth so far as a texture; rows turn over. */
static int truth_upload(viewer *v)
{
    const int w = v->truth.camera.width, height = v->truth.camera.height;
    const size_t row = 3 * (size_t)w;
    float *p = NULL;
    pthread_mutex_lock(&v->truth.lock);
    const int failed = v->truth.failed, is_new = v->shown.version != v->truth.now.version;
    if (is_new) p = malloc(row * (size_t)height * sizeof *p);
    for (int y = 0; y < height && p; ++y)
        memcpy(p + row * (size_t)y, v->truth.rgb + row * (size_t)(height - 1 - y), row * sizeof *p);
    v->shown = v->truth.now;
    if (failed) v->err = v->truth.err;
    pthread_mutex_unlock(&v->truth.lock);
    if (failed || !is_new) { free(p); return failed ? -1 : 0; }
    if (!p) return kit_fail(&v->err, "no memory for a truth of %d x %d", w, height);
    glDeleteTextures(1, &v->truth_picture);
    v->truth_picture = texture_of(w, height, 0, GL_RGBA32F, GL_RGB, GL_FLOAT, p);
    free(p);
    return 0;
}

/* ---- >>text ------------------------------------------------------------------------------------------------------ */

static const char keys[] =
    "drag\torbit\t\tright drag\tpan\n"
    "wheel\tzoom\t\tr\tcamera back\n"
    "m  M\tmethod: left, right half\n"
    "p  P\tpreset: left, right half\n"
    "s\tsplit: off, a method, the truth\n"
    "arrows\tmove the split\n"
    "b\tbehind surfaces: constant, solid, back faces, slabs\n"
    "[  ]\tradius\t\tt\thistory\n"
    "n\tnormals: given, from depth\n"
    "e\terror to the truth\n"
    "c\tvisibility on the scene's colours\n"
    "o\tPNG of the window\n"
    "x\tEXR of the left half\n"
    "g\tpanel\t\th\tthese keys\n"
    "q\tquit";

/* Text in quads of 64 bytes: how many. A tab goes on at the next stop; size: of the box around all. */
static int lay_out(float size[2], char *quads, size_t room, float x, float y, const char *text)
{
    enum { STOP = 64, LINE = 12 };
    float column = 0;
    int count = 0;
    size[0] = 0;
    size[1] = LINE - 2;
    while (*text) {
        char piece[200];
        const size_t all = strcspn(text, "\t\n"), n = all < sizeof piece ? all : sizeof piece - 1;
        memcpy(piece, text, n);
        piece[n] = 0;
        text += n;
        if (n) count += stb_easy_font_print(x + column, y + size[1] - LINE + 2, piece, NULL, quads + 64 * (size_t)count,
                                            (int)(room - 64 * (size_t)count));
        column += (float)stb_easy_font_width(piece);
        size[0] = fmaxf(size[0], column);
        if (*text == '\t') { column = STOP * (floorf(column / STOP) + 1); ++text; }
        else if (*text == '\n') { column = 0; size[1] += LINE; ++text; }
    }
    return count;
}

/* At a corner, or beside it so that it ends in the window: x, y may be as large as they please. */
static void print(viewer *v, float x, float y, float scale, const char *text)
{
    static char quads[1 << 19];
    static const float ink[4] = { 1, 1, 1, 1 }, ground[4] = { 0, 0, 0, 0.66f };
    const float most[2] = { (float)v->camera.width / scale - 8, (float)v->camera.height / scale - 8 }, pad = 4;
    float size[2];
    lay_out(size, quads, sizeof quads, 0, 0, text);
    x = fmaxf(8, floorf(fminf(x, most[0] - size[0])));
    y = fmaxf(8, floorf(fminf(y, most[1] - size[1])));
    const float right = x + size[0] + pad, end = y + size[1] + pad;
    const float box[4][4] = { { x - pad, y - pad }, { right, y - pad }, { right, end }, { x - pad, end } };
    const int count = lay_out(size, quads + sizeof box, sizeof quads - sizeof box, x, y, text);
    memcpy(quads, box, sizeof box);
    glBindVertexArray(v->quads);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)sizeof box * (count + 1), quads, GL_STREAM_DRAW);
    glUseProgram(v->text);
    glUniform4f(glGetUniformLocation(v->text, "place"), scale, 1 / (float)v->camera.width,
                -1 / (float)v->camera.height, 0);
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    glUniform4fv(glGetUniformLocation(v->text, "colour"), 1, ground);
    glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, NULL);
    glUniform4fv(glGetUniformLocation(v->text, "colour"), 1, ink);
    glDrawElements(GL_TRIANGLES, 6 * count, GL_UNSIGNED_INT, (const void *)(6 * sizeof(GLuint)));
    glDisable(GL_BLEND);
}

#if defined(__GNUC__)
__attribute__((format(printf, 3, 4)))
#endif
static void add(char *text, size_t size, const char *format, ...)
{
    const size_t at = strlen(text);
    va_list list;
    va_start(list, format);
    vsnprintf(text + at, size - at, format, list);
    va_end(list);
}

static void describe(char *text, size_t size, const viewer *v, const half *h)
{
    double all = 0;
    if (h->method == TRUTH) {
        add(text, size, "ray-traced truth\n%d rays a pixel: %.0f %%", v->shown.tracing, (double)v->shown.share * 100);
        return;
    }
    add(text, size, "%s, %s", methods[h->method].name, presets[h->preset]);
    if (v->error && !isnan(h->error)) add(text, size, "   RMSE %.4f%s", h->error, v->truth.lit ? " of the mean" : "");
    for (int i = 0; i < h->chain.steps; ++i) {
        const ssgi_gl_step *s = &h->chain.step[i];
        all += h->chain.time[i].ms;
        add(text, size, "\n%s\t%dx%d\t%.*f ms", ssgi_gl_pass_name(s->desc.pass), s->width, s->height, software ? 0 : 3,
            h->chain.time[i].ms);
    }
    add(text, size, "\nall\t\t%.*f ms", software ? 0 : 3, all);
}

static void overlay(viewer *v)
{
    const float scale = v->camera.height >= 500 ? 2 : 1, width = (float)v->camera.width / scale;
    const double about = v->scene.mesh.triangles < 100000 ? 1 : 1e-3;
    const char *slash = strrchr(v->scene.name, '/');
    char text[4096] = "";
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, v->camera.width, v->camera.height);
    if (v->panel) {
        describe(text, sizeof text, v, &v->half[0]);
        print(v, 0, 0, scale, text);
        *text = 0;
        if (v->split_on) {
            describe(text, sizeof text, v, &v->half[1]);
            print(v, v->split * width + 8, 0, scale, text);
            *text = 0;
        }
        add(text, sizeof text, "%s, %.0f%s triangles, %dx%d, G-buffer %.2f ms%s",
            slash ? slash + 1 : v->scene.name, (double)v->scene.mesh.triangles * about, about < 1 ? "k" : "",
            v->camera.width, v->camera.height, v->gbuffer.time.ms, software ? ", drawn by the CPU" : "");
        add(text, sizeof text, "\nradius %.3g, behind: %s", (double)v->radius, behinds[v->behind]);
        if (v->behind >= SSGI_GL_THICKNESS_BACK) add(text, sizeof text, " (%.2f ms)", v->gbuffer.slab_time.ms);
        add(text, sizeof text, "%s%s", v->history ? ", history" : "", v->from_depth ? ", normals from depth" : "");
        if (v->noted > 0 && kit_seconds() < v->noted + 4) add(text, sizeof text, "   %s", v->note);
        else add(text, sizeof text, "   h: keys");
        if (!v->help) print(v, 0, 1e6f, scale, text);
    }
    if (v->help) print(v, 0.5f * width - 230, 0.35f * (float)v->camera.height / scale, scale, keys);
}

/* ---- >>pictures -------------------------------------------------------------------------------------------------- */

static int window_save(viewer *v, const char *path)
{
    const int w = v->camera.width, h = v->camera.height;
    unsigned char *bytes = malloc((size_t)w * (size_t)h * 3);
    kit_image image;
    if (!bytes || kit_image_new(&image, w, h, "R,G,B", &v->err)) { free(bytes); return -1; }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, w, h, GL_RGB, GL_UNSIGNED_BYTE, bytes);
    for (int i = 0; i < w * h; ++i)
        for (int c = 0; c < 3; ++c)
            image.data[c * w * h + i] = (float)bytes[3 * ((h - 1 - i / w) * w + i % w) + c] / 255;
    const int failed = kit_png_write(&image, "R,G,B", 0, path, &v->err);
    kit_image_free(&image);
    free(bytes);
    return failed;
}

static int result_save(viewer *v, const char *path)
{
    const half *h = &v->half[0];
    const int w = v->gbuffer.width, height = v->gbuffer.height;
    kit_image image;
    float *p = half_read(v, h);
    if (!p || kit_image_new(&image, w, height, methods[h->method].lit ? "R,G,B" : "Y", &v->err)) { free(p); return -1; }
    for (int i = 0; i < w * height; ++i)
        for (int c = 0; c < image.channels; ++c)
            image.data[c * w * height + i] = p[4 * ((height - 1 - i / w) * w + i % w) + c];
    free(p);
    const int failed = kit_exr_write(&image, path, &v->err);
    kit_image_free(&image);
    return failed;
}

static void save(viewer *v, int exr)
{
    char path[64];
    do snprintf(path, sizeof path, "ssgi-%04d.%s", ++v->shots, exr ? "exr" : "png"); while (!access(path, F_OK));
    if (exr ? result_save(v, path) : window_save(v, path)) say(v, v->err.text); else say(v, path);
}

/* ---- >>input ----------------------------------------------------------------------------------------------------- */

static void on_key(GLFWwindow *window, int key, int code, int action, int mods)
{
    viewer *v = glfwGetWindowUserPointer(window);
    half *h = &v->half[mods & GLFW_MOD_SHIFT && v->split_on ? 1 : 0];
    (void)code;
    if (action == GLFW_RELEASE) return;
    switch (key) {
    case GLFW_KEY_Q: case GLFW_KEY_ESCAPE: glfwSetWindowShouldClose(window, 1); return;
    case GLFW_KEY_H: v->help = !v->help; return;
    case GLFW_KEY_G: v->panel = !v->panel; return;
    case GLFW_KEY_C: v->colours = !v->colours; return;
    case GLFW_KEY_E: v->error = !v->error; return;
    case GLFW_KEY_O: save(v, 0); return;
    case GLFW_KEY_X: save(v, 1); return;
    case GLFW_KEY_R: memcpy(v->camera.eye, v->home.eye, sizeof v->home.eye);
                     memcpy(v->camera.target, v->home.target, sizeof v->home.target); return;
    case GLFW_KEY_LEFT: v->split = fmaxf(v->split - 0.02f, 0.05f); return;
    case GLFW_KEY_RIGHT: v->split = fminf(v->split + 0.02f, 0.95f); return;
    case GLFW_KEY_LEFT_BRACKET: v->radius /= 1.1f; return;
    case GLFW_KEY_RIGHT_BRACKET: v->radius *= 1.1f; return;
    case GLFW_KEY_S:
        if (!v->split_on) { v->split_on = 1; v->half[1].method = v->half[0].method; }
        else if (v->half[1].method != TRUTH) v->half[1].method = TRUTH;
        else { v->split_on = 0; v->half[1].method = v->half[0].method; }
        break;
    case GLFW_KEY_M: h->method = (h->method + 1) % (METHODS + (h != v->half)); break;
    case GLFW_KEY_P: h->preset = (h->preset + 1) % 3; break;
    case GLFW_KEY_B: v->behind = (v->behind + 1) % 4; break;
    case GLFW_KEY_N: v->from_depth = !v->from_depth; break;
    case GLFW_KEY_T: v->history = !v->history; break;
    default: return;
    }
    v->dirty = 1;
}

static void move(viewer *v, double right, double up, double turn, double tilt, double zoom)
{
    kit_camera *c = &v->camera;
    double away[3], axis[3], level[3], length = 0, along = 0, flat = 0, m = 0;
    float to_view[16], projection[16];
    const kit_camera from = *c;
    kit_camera_orbit(c, &from, turn);
    for (int i = 0; i < 3; ++i) m += (double)c->up[i] * (double)c->up[i];
    for (int i = 0; i < 3; ++i) {
        axis[i] = (double)c->up[i] / sqrt(m);
        away[i] = (double)c->eye[i] - (double)c->target[i];
        along += away[i] * axis[i];
        length += away[i] * away[i];
    }
    length = sqrt(length);
    for (int i = 0; i < 3; ++i) flat += pow(level[i] = away[i] - along * axis[i], 2);
    flat = sqrt(flat);
    const double angle = fmin(fmax(atan2(flat, along) + tilt, 0.03), 3.11);
    for (int i = 0; i < 3 && flat > 0; ++i)
        c->eye[i] = c->target[i] + (float)(zoom * length * (cos(angle) * axis[i] + sin(angle) * level[i] / flat));
    if (!(c->fovy > 0)) c->ortho_height *= (float)zoom;
    kit_camera_matrices(c, to_view, projection);
    const double unit = c->fovy > 0 ? 2 * length * tan((double)c->fovy * 0.00872664626) : (double)c->ortho_height;
    for (int i = 0; i < 3; ++i) {
        const float by = (float)(unit * (right * (double)to_view[4 * i] + up * (double)to_view[4 * i + 1]));
        c->eye[i] += by;
        c->target[i] += by;
    }
}

static void on_mouse(GLFWwindow *window, double x, double y)
{
    viewer *v = glfwGetWindowUserPointer(window);
    int w, h;
    glfwGetWindowSize(window, &w, &h);
    const double dx = (x - v->mouse[0]) / h, dy = (y - v->mouse[1]) / h;
    const int turns = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_LEFT);
    const int pans = glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_RIGHT)
                     || glfwGetMouseButton(window, GLFW_MOUSE_BUTTON_MIDDLE);
    v->mouse[0] = x;
    v->mouse[1] = y;
    if (turns) move(v, 0, 0, -200 * dx, -3 * dy, 1);
    else if (pans) move(v, -dx, dy, 0, 0, 1);
}

static void on_wheel(GLFWwindow *window, double x, double y)
{
    (void)x;
    move(glfwGetWindowUserPointer(window), 0, 0, 0, 0, pow(0.9, y));
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int fit(viewer *v)                   /* sizes are the window's, programs the choices' */
{
    int w, h;
    glfwGetFramebufferSize(v->window, &w, &h);
    if (w < 1 || h < 1) return 0;
    const int sized = w != v->gbuffer.width || h != v->gbuffer.height;
    if (sized) gbuffer_size(&v->gbuffer, w, h);
    v->camera.width = w;
    v->camera.height = h;
    for (int i = 0; i < 1 + v->split_on && (sized || v->dirty); ++i) if (half_open(v, &v->half[i])) return -1;
    if ((sized || v->dirty) && glGetError() == GL_OUT_OF_MEMORY)
        return kit_fail(&v->err, "the GPU has no memory for a window of %d x %d", w, h);
    v->dirty = 0;
    return 0;
}

static int show(viewer *v)
{
    kit_camera seen = v->camera;
    float to_view[16], projection[16];
    int kind[2];
    if (fit(v)) return -1;
    seen = v->camera;
    kit_camera_planes(&seen, &v->scene.mesh);
    kit_camera_matrices(&seen, to_view, projection);
    gbuffer_draw(&v->gbuffer, to_view, projection, v->behind);
    for (int i = 0; i < 1 + v->split_on; ++i)
        if (v->half[i].method != TRUTH && half_draw(v, &v->half[i], to_view, projection)) return -1;
    ++v->frame;
    if (v->error || (v->split_on && v->half[1].method == TRUTH)) {
        if (truth_want(&v->truth, &seen, v->radius, methods[v->half[0].method].lit, &v->err)) return -1;
        if (kit_seconds() > v->scored + 0.5) {
            for (int i = 0; i < 1 + v->split_on; ++i) half_score(v, &v->half[i]);
            v->scored = kit_seconds();
        }
        if (truth_upload(v)) return -1;
    }
    for (int i = 0; i < 2; ++i) {
        const int lit = v->half[i].method == TRUTH ? v->truth.lit : methods[v->half[i].method].lit;
        kind[i] = lit ? 2 : v->colours;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, v->camera.width, v->camera.height);
    glUseProgram(v->display);
    bind(0, GL_TEXTURE_2D, v->half[0].picture);
    bind(1, GL_TEXTURE_2D, !v->split_on                 ? v->half[0].picture
                           : v->half[1].method == TRUTH ? v->truth_picture
                                                        : v->half[1].picture);
    bind(2, GL_TEXTURE_2D, v->gbuffer.albedo);
    glUniform1f(glGetUniformLocation(v->display, "split"),
                v->split_on ? floorf(v->split * (float)v->camera.width) : 4 * (float)v->camera.width);
    glUniform2i(glGetUniformLocation(v->display, "kind"), kind[0], kind[1]);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    overlay(v);
    return 0;
}

static int programs_open(viewer *v)
{
    static const char *const samplers[][4] = { { "light", "bounce", "albedo", "depth" },
                                               { "half0", "half1", "albedo" } };
    enum { QUADS = 8192 };
    GLuint *index = malloc(QUADS * 6 * sizeof *index), buffers[2];
    const GLuint *const of[2] = { &v->resolve, &v->display };
    if (!index) return kit_fail(&v->err, "out of memory");
    v->resolve = program_of(screen_vs, resolve_fs, &v->err);
    v->display = program_of(screen_vs, display_fs, &v->err);
    v->text = program_of(text_vs, text_fs, &v->err);
    if (!v->resolve || !v->display || !v->text) { free(index); return -1; }
    for (int p = 0; p < 2; ++p) {
        glUseProgram(*of[p]);
        for (int i = 0; i < 4 - p; ++i) glUniform1i(glGetUniformLocation(*of[p], samplers[p][i]), i);
    }
    for (GLuint i = 0; i < QUADS * 6; ++i) index[i] = i / 6 * 4 + (const GLuint[]){ 0, 1, 2, 0, 2, 3 }[i % 6];
    glGenVertexArrays(1, &v->quads);
    glBindVertexArray(v->quads);
    glGenBuffers(2, buffers);
    glBindBuffer(GL_ARRAY_BUFFER, buffers[0]);
    glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, buffers[1]);
    glBufferData(GL_ELEMENT_ARRAY_BUFFER, QUADS * 6 * (GLsizeiptr)sizeof *index, index, GL_STATIC_DRAW);
    glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, 16, NULL);
    glEnableVertexAttribArray(0);
    free(index);
    return 0;
}

static int floats(const char *text, float *out, int count)       /* none farther from 0 than scenes are */
{
    char *end = NULL;
    for (int i = 0; i < count; ++i, text = end + 1) {
        out[i] = strtof(text, &end);
        if (end == text || *end != (i + 1 < count ? ',' : 0) || !(fabs((double)out[i]) <= FARTHEST))
            return -1;
    }
    return 0;
}

static int word(const char *text, const char *const *words, int count)
{
    for (int i = 0; i < count; ++i) if (!strcmp(text, words[i])) return i;
    return -1;
}

static int method_named(const char *name)
{
    for (int i = 0; i < METHODS; ++i) if (!strcmp(name, methods[i].name)) return i;
    return strcmp(name, "truth") ? -1 : TRUTH;
}

static int whole_between(const char *text, int least, int most, int *out)
{
    char *end;
    const long value = strtol(text, &end, 10);
    if (end == text || *end || value < least || value > most) return -1;
    *out = (int)value;
    return 0;
}

static int size_of(const char *text, int size[2])
{
    char width[8] = "";
    const char *x = strchr(text, 'x');
    if (!x || x - text >= (int)sizeof width) return -1;
    memcpy(width, text, (size_t)(x - text));
    return whole_between(width, 16, 16384, &size[0]) || whole_between(x + 1, 16, 16384, &size[1])
           || size[0] * size[1] > 33554432;
}

static const char usage[] =
    "usage: viewer SCENE.obj | SCENE.gltf | NAME   [options]; h in the window lists its keys\n"
    "  --method ssao | hsao | hsao-march | ssdo | ssdo-points | s3ho   [hsao]\n"
    "  --right METHOD | truth     beside it\n"
    "  --preset fast | balanced | best   --behind constant | solid | back | slabs   --normal gbuffer | depth\n"
    "  --radius R  --history  --env sky | FILE  --ground  --size WxH  --camera ex,ey,ez,tx,ty,tz  --up x,y,z\n"
    "  --shot F.png   a picture of the window, then the end   --frames N   so many frames before it   --keys\n";

/* What was asked for and is not the viewer's own. */
typedef struct asked {
    const char *scene;
    int         ground, help, camera, up, size[2];
    float       place[6], upward[3], radius[1];
} asked;

static int must(viewer *v, int good, const char *name, const char *value, const char *what)
{
    return good ? 0 : kit_fail(&v->err, "%s '%s': must %s", name, value, what);
}

/* An option with its value, "" where there is none. */
static int option(viewer *v, asked *to, const char *name, const char *value)
{
    static const char *const normals[] = { "gbuffer", "depth" };
    half *left = &v->half[0], *right = &v->half[1];
    if (!strcmp(name, "--method")) {
        left->method = method_named(value);
        return must(v, left->method >= 0 && left->method != TRUTH, name, value,
                    "be ssao, hsao, hsao-march, ssdo, ssdo-points or s3ho");
    }
    if (!strcmp(name, "--right")) {
        v->split_on = v->error = 1;
        right->method = method_named(value);
        return must(v, right->method >= 0, name, value, "be a method or truth");
    }
    if (!strcmp(name, "--preset")) {
        left->preset = right->preset = word(value, presets, 3);
        return must(v, left->preset >= 0, name, value, "be fast, balanced or best");
    }
    if (!strcmp(name, "--behind")) {
        v->behind = word(value, behinds, 4);
        return must(v, v->behind >= 0, name, value, "be constant, solid, back or slabs");
    }
    if (!strcmp(name, "--normal")) {
        v->from_depth = word(value, normals, 2);
        return must(v, v->from_depth >= 0, name, value, "be gbuffer or depth");
    }
    if (!strcmp(name, "--radius"))
        return must(v, !floats(value, to->radius, 1) && *to->radius > 0, name, value,
                    "be a number above 0, at most 1e15");
    if (!strcmp(name, "--camera")) {
        to->camera = 1;
        return must(v, !floats(value, to->place, 6), name, value,
                    "be six numbers with commas between, each within 1e15 of 0");
    }
    if (!strcmp(name, "--up")) {
        to->up = 1;
        return must(v, !floats(value, to->upward, 3), name, value,
                    "be three numbers with commas between, each within 1e15 of 0");
    }
    if (!strcmp(name, "--size"))
        return must(v, !size_of(value, to->size), name, value, "be WxH, each 16..16384, of 33554432 pixels at most");
    if (!strcmp(name, "--frames"))
        return must(v, !whole_between(value, 1, 1000000, &v->frames), name, value, "be a whole number in 1..1000000");
    if (!strcmp(name, "--panel"))
        return must(v, !whole_between(value, 0, 1, &v->panel), name, value, "be 0 or 1");
    if (!strcmp(name, "--env")) {
        v->env = value;
        return must(v, *value, name, value, "name an environment or its file");
    }
    if (!strcmp(name, "--shot")) {
        v->shot = value;
        return must(v, *value, name, value, "name a file");
    }
    return kit_fail(&v->err, "%s: there is no such option (--help names all)", name);
}

static int arguments(viewer *v, asked *to, int argc, char **argv)
{
    for (int i = 1; i < argc; ++i) {
        const char *a = argv[i];
        if (!strcmp(a, "--help") || !strcmp(a, "-h")) to->help = 1;
        else if (!strcmp(a, "--history")) v->history = 1;
        else if (!strcmp(a, "--ground")) to->ground = 1;
        else if (!strcmp(a, "--keys")) v->help = 1;
        else if (*a == '-') { if (option(v, to, a, i + 1 < argc ? argv[i + 1] : "")) return -1; ++i; }
        else if (!to->scene) to->scene = a;
        else return kit_fail(&v->err, "%s: only one scene can be shown (%s is one already)", a, to->scene);
    }
    if (to->help || to->scene) return 0;
    return kit_fail(&v->err, "a scene must be given: SCENE.obj, SCENE.gltf or a built-in name (--help says more)");
}

/* The scene's camera, or what was asked for instead. */
static int camera_of(viewer *v, const asked *to)
{
    kit_camera *c = &v->camera;
    double away[3], length = 0, up = 0, along = 0;
    *c = v->scene.camera;
    c->depth = KIT_DEPTH_NORMAL;
    if (to->camera) { memcpy(c->eye, to->place, sizeof c->eye); memcpy(c->target, to->place + 3, sizeof c->target); }
    if (to->up) memcpy(c->up, to->upward, sizeof c->up);
    for (int i = 0; i < 3; ++i) {
        away[i] = (double)c->eye[i] - (double)c->target[i];
        length += away[i] * away[i];
        up += (double)c->up[i] * (double)c->up[i];
        along += away[i] * (double)c->up[i];
    }
    if (!(length > 0)) return kit_fail(&v->err, "--camera: eye and target must differ");
    if (!(up > 0) || along * along > 0.999999 * length * up)
        return kit_fail(&v->err, "--up: must not be zero or along the view direction");
    v->home = *c;
    return 0;
}

static int open_scene(viewer *v, const asked *to)
{
    const size_t n = strlen(to->scene);
    if (n > 5 && !strcmp(to->scene + n - 5, ".gltf") ? gltf_load(&v->scene, to->scene, &v->err)
                                                     : kit_scene_load(&v->scene, to->scene, to->ground, &v->err))
        return -1;
    if (camera_of(v, to)) return -1;
    v->radius = to->radius[0] > 0 ? to->radius[0] : v->scene.radius;
    if (kit_env_read(&v->lighting.env, v->env, &v->err)) return -1;
    const size_t pixels = (size_t)v->lighting.env.width * (size_t)v->lighting.env.height;
    v->equirect = malloc(3 * pixels * sizeof *v->equirect);
    for (size_t i = 0; v->equirect && i < 3 * pixels; ++i)
        v->equirect[i] = v->lighting.env.data[i % 3 * pixels + i / 3];
    return v->equirect ? 0 : kit_fail(&v->err, "out of memory");
}

static int window_open(viewer *v, const int size[2])
{
    const char *why = "";
    if (!glfwInit()) { glfwGetError(&why); return kit_fail(&v->err, "no window: %s", why ? why : "no display"); }
    glfwWindowHint(GLFW_CONTEXT_VERSION_MAJOR, 3);
    glfwWindowHint(GLFW_CONTEXT_VERSION_MINOR, 3);
    glfwWindowHint(GLFW_OPENGL_PROFILE, GLFW_OPENGL_CORE_PROFILE);
    glfwWindowHint(GLFW_OPENGL_FORWARD_COMPAT, 1);
    glfwWindowHint(GLFW_DEPTH_BITS, 0);
    v->window = glfwCreateWindow(size[0], size[1], "ssgi", NULL, NULL);
    if (!v->window) { glfwGetError(&why); return kit_fail(&v->err, "no window with OpenGL 3.3: %s", why ? why : ""); }
    glfwMakeContextCurrent(v->window);
    glfwSwapInterval(v->shot ? 0 : 1);
    glfwSetWindowUserPointer(v->window, v);
    glfwSetKeyCallback(v->window, on_key);
    glfwSetCursorPosCallback(v->window, on_mouse);
    glfwSetScrollCallback(v->window, on_wheel);
    const char *renderer = (const char *)glGetString(GL_RENDERER);
    software = !renderer || strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe")
               || strstr(renderer, "SwiftShader");
    return 0;
}

/* The frame that --shot is of comes now: those before are drawn, a truth that is looked at has had its first rays. */
static int shot_next(const viewer *v)
{
    return v->shot && v->frame + 1 >= (unsigned)(v->frames ? v->frames : 1)
           && (!v->error || v->shown.rounds);
}

static int run(viewer *v)                   /* until the window is closed, or the picture is taken */
{
    v->truth.scene = &v->scene;
    v->truth.lighting = &v->lighting;
    v->dirty = 1;
    while (!glfwWindowShouldClose(v->window)) {
        glfwPollEvents();
        const int shot = shot_next(v);
        if (shot) v->scored = 0;
        if (show(v)) return -1;
        if (shot && v->error) printf("RMSE %.5f\n", v->half[0].error);
        if (shot) return window_save(v, v->shot);
        glfwSwapBuffers(v->window);
    }
    return 0;
}

int main(int argc, char **argv)
{
    static viewer v;
    asked to = { .size = { 1280, 720 } };
    char cores[32];
    kit_streams_open();
    pthread_mutex_init(&v.truth.lock, NULL);
    pthread_cond_init(&v.truth.wake, NULL);
    v.half[0].error = v.half[1].error = (double)NAN;
    v.half[0].method = v.half[1].method = 1;
    v.half[0].preset = v.half[1].preset = SSGI_GL_BALANCED;
    v.split = 0.5f;
    v.panel = -1;
    v.env = "sky";
    snprintf(cores, sizeof cores, "%ld", sysconf(_SC_NPROCESSORS_ONLN) > 1 ? sysconf(_SC_NPROCESSORS_ONLN) - 1 : 1);
    setenv("KIT_THREADS", cores, 0);        /* one core is left to draw */
    int failed = arguments(&v, &to, argc, argv);
    if (v.panel < 0) v.panel = !v.shot;
    if (!failed && to.help) fputs(usage, stdout);
    else if (!failed)
        failed = open_scene(&v, &to) || window_open(&v, to.size) || gbuffer_open(&v.gbuffer, &v.scene.mesh, &v.err)
              || programs_open(&v) || run(&v);
    truth_close(&v.truth);
    if (v.window) glfwDestroyWindow(v.window);
    glfwTerminate();
    if (!failed) failed = kit_streams_close(&v.err);
    if (failed) fprintf(stderr, "viewer: %s\n", v.err.text);
    kit_image_free(&v.lighting.env);
    kit_scene_free(&v.scene);
    free(v.equirect);
    return failed ? 2 : 0;
}
