/* mesh.c - triangles from Wavefront OBJ files; text.c reads their lines, materials.c their MTL files.

   Read: v, vn, f, o, g, mtllib, usemtl; newmtl and Kd. All else is ignored: vt, lines, points, curves, textures.
   Polygons: strictly convex ones become a fan, others are cut by clipping ears in the plane of their largest projection
   (with more than CONCAVE_MOST corners a fan again, for time's sake). Triangles without area are dropped,
   and so are faces of one or two corners, which exporters write.
   Materials: of several with one name the last counts; all mtllib files are read before the first usemtl, each once.
   Time and memory are in proportion to the files' sizes, whatever they hold. */
#include "kit/kit_obj.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define CONCAVE_MOST 1000
#define EAR_TESTS 100                      /* a corner of a polygon; then what is known of the others is believed */

/* ---- faces --------------------------------------------------------------------------------------------------- */

enum { UNKNOWN, EAR, NO_EAR };
typedef struct corner { const float *position, *normal; double flat[2]; int next, ear; } corner;

typedef struct obj {
    kit_soup soup;
    kit_array normals;                         /* float[3] */
    kit_array mtllibs;                         /* mtllib */
    kit_materials materials;
    kit_array corners;                         /* of the present face */
} obj;

static int add_triangle(obj *o, const kit_text *t, const corner *a, const corner *b, const corner *c,
                        const float albedo[3])
{
    const float *const position[3] = { a->position, b->position, c->position };
    const float *const normal[3] = { a->normal, b->normal, c->normal };
    const int added = kit_soup_triangle(&o->soup, position, normal, albedo, t);
    if (added < 1) return added;
    uint32_t *vertex = kit_array_add(&o->soup.vertex, 3, sizeof *vertex, t);
    if (!vertex) return -1;
    for (int k = 0; k < 3; ++k)
        vertex[k] = (uint32_t)((position[k] - (const float *)o->soup.vertices.data) / 3);
    return 0;
}

static double turn(const corner *a, const corner *b, const corner *c) /* > 0: left */
{
    return (b->flat[0] - a->flat[0]) * (c->flat[1] - b->flat[1])
           - (b->flat[1] - a->flat[1]) * (c->flat[0] - b->flat[0]);
}

static int turn_back(const corner *a, const corner *b, const corner *c)
{
    return (b->flat[0] - a->flat[0]) * (c->flat[0] - b->flat[0]) + (b->flat[1] - a->flat[1]) * (c->flat[1] - b->flat[1])
           < 0;
}

static int same(const corner *a, const corner *b) { return a->flat[0] == b->flat[0] && a->flat[1] == b->flat[1]; }

/* Turns the polygon counter-clockwise in a plane; says whether it is strictly convex. */
static int flatten(corner *c, int count)
{
    double n[3] = { 0 }, turned = 0;
    for (int k = 0; k < count; ++k)        /* Newell's normal, about corner 0 to keep the digits */
        for (int i = 0, u, v; i < 3; ++i) {
            const float *o = c[0].position, *p = c[k].position, *q = c[(k + 1) % count].position;
            u = (i + 1) % 3; v = (i + 2) % 3;
            n[i] += ((double)p[u] - (double)o[u]) * ((double)q[v] - (double)o[v])
                    - ((double)p[v] - (double)o[v]) * ((double)q[u] - (double)o[u]);
        }
    int z = fabs(n[0]) > fabs(n[1]) ? (fabs(n[0]) > fabs(n[2]) ? 0 : 2) : fabs(n[1]) > fabs(n[2]) ? 1 : 2;
    for (int k = 0; k < count; ++k) {
        c[k].flat[0] = (double)c[k].position[(z + 1) % 3];
        c[k].flat[1] = n[z] < 0 ? -(double)c[k].position[(z + 2) % 3] : (double)c[k].position[(z + 2) % 3];
        c[k].next = (k + 1) % count;
    }
    for (int k = 0; k < count; ++k) {
        const corner *p = &c[k], *q = &c[(k + 1) % count], *r = &c[(k + 2) % count];
        double left = turn(p, q, r);
        if (!(left > 0)) return 0;
        turned += atan2(left, (q->flat[0] - p->flat[0]) * (r->flat[0] - q->flat[0])
                                  + (q->flat[1] - p->flat[1]) * (r->flat[1] - q->flat[1]));
    }
    return turned < 7;                     /* once around is 2 pi; a star polygon turns more often */
}

/* tests grows by the corners that were looked at. */
static int is_ear(const corner *c, int a, int b, int d, size_t *tests)
{
    double left = turn(&c[a], &c[b], &c[d]);
    if (left == 0 && turn_back(&c[a], &c[b], &c[d])) return 1;                  /* a spike without area */
    if (!(left > 0)) return 0;
    for (int k = c[d].next; k != a; k = c[k].next, ++*tests)
        if (turn(&c[a], &c[b], &c[k]) >= 0 && turn(&c[b], &c[d], &c[k]) >= 0 && turn(&c[d], &c[a], &c[k]) >= 0
            && !same(&c[k], &c[a]) && !same(&c[k], &c[b]) && !same(&c[k], &c[d]))
            return 0; /* holes are bridged by doubled corners */
    return 1;
}

/* Cutting an ear changes whether its two neighbours are ears, and no other corner, unless the polygon crosses itself:
   then asking all of them again finds more ears, which is done while it is cheap. Where no ear is left it is cut
   anywhere. */
static int add_concave(obj *o, const kit_text *t, const float albedo[3])
{
    corner *c = o->corners.data;
    int count = (int)o->corners.count, failed = 0;
    const size_t most = EAR_TESTS * (size_t)count;
    size_t tests = 0;
    for (int k = 0; k < count; ++k) c[k].ear = UNKNOWN;
    for (int a = 0, tries = 0; count > 2 && !failed;) {
        const int b = c[a].next, d = c[b].next;
        if (c[b].ear == UNKNOWN || tests < most) c[b].ear = is_ear(c, a, b, d, &tests) ? EAR : NO_EAR;
        if (c[b].ear == NO_EAR && tries++ < count) { a = b; continue; }
        failed = add_triangle(o, t, &c[a], &c[b], &c[d], albedo);
        c[a].next = d;
        c[a].ear = c[d].ear = UNKNOWN;
        a = d;                             /* moving on avoids fans of slivers */
        tries = 0;
        --count;
    }
    return failed;
}

static int add_polygon(obj *o, const kit_text *t, const float albedo[3])
{
    corner *c = o->corners.data;
    int count = (int)o->corners.count, failed = 0;
    if (count > 3 && !flatten(c, count) && count <= CONCAVE_MOST) return add_concave(o, t, albedo);
    for (int k = 2; k < count && !failed; ++k) failed = add_triangle(o, t, &c[0], &c[k - 1], &c[k], albedo);
    return failed;
}

/* "7", "-1", "7/..." : one index, from the end when negative; out: counted from 0. */
static int element_index(kit_text *t, size_t seen, size_t all, const char *what, size_t *out)
{
    const char *start = t->at, *p = t->at;
    int negative = p < t->end && *p == '-';
    size_t v = 0;
    p += negative;
    for (; p < t->end && *p >= '0' && *p <= '9'; ++p) if (v <= all) v = 10 * v + (size_t)(*p - '0');
    if (p == start + negative || (p < t->end && !kit_blank(*p) && *p != '/' && *p != '#'))
        return kit_text_fail(t, "a face needs corners such as 1, 1/2, 1//3 or 1/2/3");
    if (v == 0 || v > (negative ? seen : all))
        return kit_fail(t->err, "%s line %d: there is no %s %.*s (%zu %s)", t->path, t->line, what, (int)(p - start),
                        start, negative ? seen : all, negative ? "before this line" : "in the file");
    t->at = p;
    *out = negative ? seen - v : v - 1;
    return 0;
}

static int face(obj *o, kit_text *t, size_t seen_vertices, size_t seen_normals, const float albedo[3])
{
    o->corners.count = 0;
    while (kit_at_value(t)) {
        size_t vertex, normal, unused;
        corner *c = kit_array_add(&o->corners, 1, sizeof *c, t);
        if (!c || element_index(t, seen_vertices, o->soup.vertices.count / 3, "vertex", &vertex)) return -1;
        *c = (corner){ .position = (const float *)o->soup.vertices.data + 3 * vertex };
        if (t->at == t->end || *t->at != '/') continue;
        ++t->at;
        /* never used: any index will do */
        if ((t->at == t->end || *t->at != '/') && element_index(t, SIZE_MAX / 2, SIZE_MAX / 2, "vt", &unused))
            return -1;
        if (t->at == t->end || *t->at != '/') continue;
        ++t->at;
        if (element_index(t, seen_normals, o->normals.count / 3, "vn", &normal)) return -1;
        c->normal = (const float *)o->normals.data + 3 * normal;
    }
    if (o->corners.count < 1 || o->corners.count > 1 << 30)
        return kit_fail(t->err, "%s line %d: a face needs at least 3 corners, this has %zu", t->path, t->line,
                        o->corners.count);
    return add_polygon(o, t, albedo);
}

/* First what faces refer to (it may come after them), then the faces. */
static int obj_read(obj *o, const char *path, const char *data, size_t size, kit_error *err)
{
    float *v;
    for (kit_text t = kit_text_start(path, data, size, err); kit_next_line(&t);) {
        int normal = 0;
        if (kit_keyword(&t, "v") || (normal = kit_keyword(&t, "vn"))) {
            if (!(v = kit_array_add(normal ? &o->normals : &o->soup.vertices, 3, sizeof *v, &t))) return -1;
            for (int i = 0; i < 3; ++i) {
                if (kit_number(&t, &v[i], normal ? "vn needs 3 numbers" : "v needs 3 numbers")) return -1;
                if (!normal && fabsf(v[i]) > KIT_FARTHEST)
                    return kit_fail(err, "%s line %d: a coordinate of %g: must be within %g of 0", path, t.line,
                        (double)v[i], (double)KIT_FARTHEST);
            }
        } else if (kit_keyword(&t, "mtllib")) {
            const kit_key name = kit_rest(&t);
            if (name.length && kit_mtllib_add(&o->mtllibs, &t, name)) return -1;
        }
    }
    size_t seen_vertices = 0, seen_normals = 0;
    const float *albedo = kit_grey;
    int way;
    kit_text t = kit_text_start(path, data, size, err);
    if (kit_mtllibs_read(&o->materials, &o->mtllibs, &t) || kit_materials_close(&o->materials, &t)) return -1;
    for (way = 0; way < 2; ++way) if (kit_soup_name(&o->soup, way, (kit_key){ "default", 7 }, &t)) return -1;
    while (kit_next_line(&t)) {
        if (kit_keyword(&t, "f")) { if (face(o, &t, seen_vertices, seen_normals, albedo)) return -1; }
        else if (kit_keyword(&t, "v")) ++seen_vertices;
        else if (kit_keyword(&t, "vn")) ++seen_normals;
        else if (kit_keyword(&t, "usemtl")) {
            albedo = kit_material_find(&o->materials, kit_rest(&t));
        } else if ((way = kit_keyword(&t, "g")) || kit_keyword(&t, "o")) {
            if (kit_soup_name(&o->soup, way, kit_without_comment(kit_rest(&t)), &t)) return -1;
        }
    }
    return o->soup.position.count ? kit_soup_objects(&o->soup, &t)
                                  : kit_fail(err, "%s: no triangles in this OBJ file", path);
}

int kit_mesh_obj(kit_mesh *mesh, kit_object **object, int *objects, const char *path, kit_error *err)
{
    char *data;
    size_t size;
    obj o;
    memset(&o, 0, sizeof o);
    if (kit_file_read(&data, &size, path, err)) return -1;
    if (size / 2 > UINT32_MAX) {            /* names, of 2 bytes at least, and vertices have numbers of 32 bits */
        free(data);
        return kit_fail(err, "%s: must not be larger than 8 GiB", path);
    }
    kit_text_prepare(data, size);
    int failed = obj_read(&o, path, data, size, err);
    free(data);
    for (size_t i = 0; i < o.mtllibs.count; ++i) free(((kit_mtllib *)o.mtllibs.data)[i].path);
    kit_materials_free(&o.materials);
    free(o.normals.data); free(o.corners.data); free(o.mtllibs.data);
    if (!failed) kit_soup_take(&o.soup, mesh, object, objects);
    kit_soup_free(&o.soup);
    return failed;
}
