/* mesh.c - triangles from Wavefront OBJ and MTL files.

   Read: v, vn, f, o, g, mtllib, usemtl; newmtl and Kd. All else is ignored: vt, lines, points, curves, textures.
   Polygons: strictly convex ones become a fan, others are cut by clipping ears in the plane of their largest projection
   (with more than CONCAVE_MOST corners a fan again, for time's sake). Triangles without area are dropped.
   Materials: of several with one name the last counts; all mtllib files are read before the first usemtl. */
#include "kit.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#define CONCAVE_MOST 1000

void kit_mesh_free(kit_mesh *mesh)
{
    free(mesh->position);
    free(mesh->normal);
    free(mesh->albedo);
    free(mesh->object);
    memset(mesh, 0, sizeof *mesh);
}

/* ---- text ---------------------------------------------------------------------------------------------------- */

#define CONTINUED '\1'                     /* stands where a backslash and a line end were */

/* A cursor over lines: at moves along the present one, end is where it stops. */
typedef struct text {
    const char *path, *at, *end, *next, *last;
    int         line;                      /* that the present one starts on */
    int         following;
    kit_error  *err;
} text;

static const float FARTHEST = 1e15f;        /* squares of distances are floats, too */

static int blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f' || c == CONTINUED; }

/* A backslash at the end of a line continues it; not in a comment, where Windows paths may end so. Lines may end in CR
   alone. */
static void prepare(char *data, size_t size)
{
    char *start = data, *end = data + size;
    const int only_cr = !memchr(data, '\n', size);
    for (char *p = data; only_cr && (p = memchr(p, '\r', (size_t)(end - p))) != NULL; ++p) *p = '\n';
    if (size >= 3 && !memcmp(data, "\xEF\xBB\xBF", 3)) memset(data, ' ', 3);      /* byte order mark */
    while (start < end) {
        char *stop = memchr(start, '\n', (size_t)(end - start));
        if (!stop) stop = end;
        char *p = stop, *first = start;
        while (first < stop && blank(*first)) ++first;
        if (p > start && p[-1] == '\r') --p;
        if (stop < end && p > start && p[-1] == '\\' && *first != '#') {
            memset(p - 1, ' ', (size_t)(stop - p + 1));
            *stop = CONTINUED;
        }
        start = stop + 1;
    }
}

static text text_start(const char *path, const char *data, size_t size, kit_error *err)
{
    return (text){ .path = path, .next = data, .last = data + size, .following = 1, .err = err };
}

static void skip_blanks(text *t) { while (t->at < t->end && blank(*t->at)) ++t->at; }
static int  at_value(text *t) { skip_blanks(t); return t->at < t->end && *t->at != '#'; }

static int next_line(text *t)
{
    if (t->next >= t->last) return 0;
    const char *stop = memchr(t->next, '\n', (size_t)(t->last - t->next));
    t->at = t->next;
    t->end = stop ? stop : t->last;
    t->next = stop ? stop + 1 : t->last;
    t->line = t->following++;
    for (const char *p = t->at; (p = memchr(p, CONTINUED, (size_t)(t->end - p))); ++p) t->following++;
    skip_blanks(t);
    return 1;
}

static int keyword(text *t, const char *word)
{
    size_t n = strlen(word);
    if ((size_t)(t->end - t->at) < n || memcmp(t->at, word, n)) return 0;
    if (t->at + n < t->end && !blank(t->at[n])) return 0;
    t->at += n;
    return 1;
}

static int text_fail(const text *t, const char *what)
{
    int length = 0;
    while (t->at + length < t->end && !blank(t->at[length]) && length < 24) ++length;
    if (!length) return kit_fail(t->err, "%s line %d: %s, but the line ends", t->path, t->line, what);
    return kit_fail(t->err, "%s line %d: %s, not \"%.*s\"", t->path, t->line, what, length, t->at);
}

/* By hand because strtod obeys the locale and is slow. A double carries the digits, so that the float is rounded once
   (almost always). */
static int number(text *t, float *out, const char *what)
{
    static const double ten[] = { 1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8,  1e9,  1e10, 1e11,
                                  1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20, 1e21, 1e22 };
    skip_blanks(t);
    const char *p = t->at, *end = t->end;
    uint64_t digits = 0;
    int negative = p < end && *p == '-', exponent = 0, any = 0, point = 0;
    if (p < end && (*p == '-' || *p == '+')) ++p;
    for (; p < end; ++p) {
        if (*p == '.' && !point) { point = 1; continue; }
        if (*p < '0' || *p > '9') break;
        any = 1;
        if (digits < 1000000000000000000u) { digits = 10 * digits + (uint64_t)(*p - '0'); exponent -= point; }
        else exponent += !point;
    }
    if (!any) return text_fail(t, what);
    if (p < end && (*p == 'e' || *p == 'E')) {
        int sign = 1, e = 0, some = 0;
        if (++p < end && (*p == '-' || *p == '+')) sign = *p++ == '-' ? -1 : 1;
        for (; p < end && *p >= '0' && *p <= '9'; ++p, some = 1) if (e < 10000) e = 10 * e + *p - '0';
        if (!some) return text_fail(t, what);
        exponent += sign * e;
    }
    if (p < end && !blank(*p) && *p != '#') return text_fail(t, what);
    double v = (double)digits;
    if (exponent >= -22 && exponent <= 22) v = exponent < 0 ? v / ten[-exponent] : v * ten[exponent];
    else if (digits) v = v * pow(10, exponent);
    if (v > (double)FLT_MAX) return text_fail(t, "a number is too large: at most 3.4e38 is possible");
    *out = (float)v;
    if (negative && *out > 0) *out = -*out;  /* never -0: equal positions have equal bytes */
    t->at = p;
    return 0;
}

/* ---- growing arrays ------------------------------------------------------------------------------------------ */

typedef struct array { void *data; size_t count, capacity; } array;

/* Room for n more elements; the first of them, or NULL with the error written. */
static void *array_add(array *a, size_t n, size_t element, const text *t)
{
    if (a->count + n > a->capacity) {
        size_t capacity = 2 * a->capacity + n + 64;
        void *data = realloc(a->data, capacity * element);
        if (!data) { kit_fail(t->err, "%s: no memory for this mesh", t->path); return NULL; }
        a->data = data;
        a->capacity = capacity;
    }
    a->count += n;
    return (char *)a->data + (a->count - n) * element;
}

/* ---- materials ----------------------------------------------------------------------------------------------- */

typedef struct material { char *name; size_t length; float albedo[3]; } material;

static const float grey[3] = { 0.8f, 0.8f, 0.8f };

/* The rest of the line without blanks at its ends. Names may hold blanks and '#' ("Material #25"): see
   without_comment. */
static size_t rest(text *t)
{
    const char *end = t->end;
    skip_blanks(t);
    while (end > t->at && blank(end[-1])) --end;
    return (size_t)(end - t->at);
}

static size_t without_comment(const char *name, size_t length)
{
    for (size_t i = 1; i < length; ++i)
        if (name[i] == '#' && blank(name[i - 1])) {
            while (i > 0 && blank(name[i - 1])) --i;
            return i;
        }
    return length;
}

static const float *material_find(const array *materials, const char *name, size_t length)
{
    const material *m = materials->data;
    for (size_t i = materials->count; i-- > 0;)
        if (m[i].length == length && !memcmp(m[i].name, name, length)) return m[i].albedo;
    length = without_comment(name, length);
    for (size_t i = materials->count; i-- > 0;)
        if (without_comment(m[i].name, m[i].length) == length && !memcmp(m[i].name, name, length)) return m[i].albedo;
    return grey;
}

static int materials_read(array *materials, const char *path, kit_error *err)
{
    char *data;
    size_t size;
    if (kit_file_read(&data, &size, path, NULL)) return 0;                      /* grey, as if there were none */
    prepare(data, size);
    int failed = 0;
    material *now = NULL;
    for (text t = text_start(path, data, size, err); !failed && next_line(&t);) {
        if (keyword(&t, "newmtl")) {
            size_t length = rest(&t);
            now = array_add(materials, 1, sizeof *now, &t);
            if (!now) { failed = -1; break; }
            *now = (material){ .name = malloc(length + 1), .length = length };
            memcpy(now->albedo, grey, sizeof grey);
            if (!now->name) {
                materials->count--;
                failed = kit_fail(err, "%s: no memory for its materials", path);
                break;
            }
            memcpy(now->name, t.at, length);
        } else if (now && keyword(&t, "Kd")) {
            static const char what[] = "Kd needs 1 or 3 numbers";
            float kd[3];
            skip_blanks(&t);
            /* "xyz", "spectral": no rgb */
            if (t.end - t.at >= 3 && (!memcmp(t.at, "xyz", 3) || !memcmp(t.at, "spe", 3))) continue;
            failed = number(&t, &kd[0], what);
            kd[1] = kd[2] = kd[0];
            if (!failed && at_value(&t) && (number(&t, &kd[1], what) || number(&t, &kd[2], what))) failed = -1;
            for (int k = 0; k < 3 && !failed; ++k) now->albedo[k] = fmaxf(0, fminf(1, kd[k]));
        }
    }
    free(data);
    return failed;
}

static int mtllib_read(array *materials, const text *t, const char *name, size_t length)
{
    const char *slash = strrchr(t->path, '/');
    size_t folder = slash && *name != '/' ? (size_t)(slash - t->path) + 1 : 0, bare = without_comment(name, length);
    char *path = malloc(folder + length + 1);
    if (!path) return kit_fail(t->err, "%s: no memory", t->path);
    memcpy(path, t->path, folder);
    memcpy(path + folder, name, length);
    path[folder + length] = 0;
    for (char *p = path + folder; *p; ++p) if (*p == '\\') *p = '/';            /* as Windows writes it */
    if (access(path, F_OK)) path[folder + bare] = 0;
    int failed = materials_read(materials, path, t->err);
    free(path);
    return failed;
}

/* ---- faces --------------------------------------------------------------------------------------------------- */

typedef struct corner { const float *position, *normal; double flat[2]; int next; } corner;
typedef struct key { const char *bytes; size_t length; } key;

typedef struct obj {
    array vertices, normals, materials;    /* float[3], float[3], material */
    array corners;                         /* of the present face */
    array position, normal, albedo;        /* 9, 9, 3 floats a triangle */
    /* key: names on o lines, on g lines; the first is that of what comes before any */
    array named[2];
    array line[2];                         /* uint32_t a triangle: which of them */
    array number;                          /* uint32_t a triangle: its object's */
    array objects;                         /* kit_object */
} obj;

static int add_triangle(obj *o, const text *t, const corner *a, const corner *b, const corner *c, const float albedo[3])
{
    const corner *const p[3] = { a, b, c };
    double e[3][3], n[3], longest = 0;
    for (int k = 0; k < 3; ++k) {
        double squared = 0;
        for (int i = 0; i < 3; ++i) e[k][i] = (double)p[(k + 1) % 3]->position[i] - (double)p[k]->position[i];
        for (int i = 0; i < 3; ++i) squared += e[k][i] * e[k][i];
        longest = fmax(longest, squared);
    }
    for (int i = 0; i < 3; ++i) n[i] = e[0][(i + 1) % 3] * e[1][(i + 2) % 3] - e[0][(i + 2) % 3] * e[1][(i + 1) % 3];
    double area = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    if (!(area > 1e-9 * longest)) return 0;  /* thinner than floats can tell from a line */
    float *position = array_add(&o->position, 9, sizeof(float), t),
          *normal = array_add(&o->normal, 9, sizeof(float), t);
    float *colour = array_add(&o->albedo, 3, sizeof(float), t);
    if (!position || !normal || !colour) return -1;
    for (int way = 0; way < 2; ++way) {
        uint32_t *line = array_add(&o->line[way], 1, sizeof *line, t);
        if (!line) return -1;
        *line = (uint32_t)(o->named[way].count - 1);
    }
    memcpy(colour, albedo, 3 * sizeof(float));
    for (int k = 0; k < 3; ++k) {
        double own[3], length = 0;
        for (int i = 0; i < 3; ++i) own[i] = p[k]->normal ? (double)p[k]->normal[i] : 0;
        length = sqrt(own[0] * own[0] + own[1] * own[1] + own[2] * own[2]);
        memcpy(position + 3 * k, p[k]->position, 3 * sizeof(float));
        for (int i = 0; i < 3; ++i) normal[3 * k + i] = (float)(length > 0 ? own[i] / length : n[i] / area);
    }
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

static int is_ear(const corner *c, int a, int b, int d)
{
    double left = turn(&c[a], &c[b], &c[d]);
    if (left == 0 && turn_back(&c[a], &c[b], &c[d])) return 1;                  /* a spike without area */
    if (!(left > 0)) return 0;
    for (int k = c[d].next; k != a; k = c[k].next)
        if (turn(&c[a], &c[b], &c[k]) >= 0 && turn(&c[b], &c[d], &c[k]) >= 0 && turn(&c[d], &c[a], &c[k]) >= 0
            && !same(&c[k], &c[a]) && !same(&c[k], &c[b]) && !same(&c[k], &c[d]))
            return 0; /* holes are bridged by doubled corners */
    return 1;
}

static int add_polygon(obj *o, const text *t, const float albedo[3])
{
    corner *c = o->corners.data;
    int count = (int)o->corners.count, failed = 0;
    if (count == 3 || flatten(c, count) || count > CONCAVE_MOST) {
        for (int k = 2; k < count && !failed; ++k) failed = add_triangle(o, t, &c[0], &c[k - 1], &c[k], albedo);
        return failed;
    }
    for (int a = 0, tries = 0; count > 2 && !failed;) {
        int b = c[a].next, d = c[b].next;
        /* none left (it crosses itself): cut anywhere */
        if (tries++ < count && !is_ear(c, a, b, d)) { a = b; continue; }
        failed = add_triangle(o, t, &c[a], &c[b], &c[d], albedo);
        c[a].next = d;
        a = d;                             /* moving on avoids fans of slivers */
        tries = 0;
        --count;
    }
    return failed;
}

/* "7", "-1", "7/..." : one index, from the end when negative; out: counted from 0. */
static int element_index(text *t, size_t seen, size_t all, const char *what, size_t *out)
{
    const char *start = t->at, *p = t->at;
    int negative = p < t->end && *p == '-';
    size_t v = 0;
    p += negative;
    for (; p < t->end && *p >= '0' && *p <= '9'; ++p) if (v < (size_t)1 << 40) v = 10 * v + (size_t)(*p - '0');
    if (p == start + negative || (p < t->end && !blank(*p) && *p != '/' && *p != '#'))
        return text_fail(t, "a face needs corners such as 1, 1/2, 1//3 or 1/2/3");
    if (v == 0 || v > (negative ? seen : all))
        return kit_fail(t->err, "%s line %d: there is no %s %.*s (%zu %s)", t->path, t->line, what, (int)(p - start),
                        start, negative ? seen : all, negative ? "before this line" : "in the file");
    t->at = p;
    *out = negative ? seen - v : v - 1;
    return 0;
}

static int face(obj *o, text *t, size_t seen_vertices, size_t seen_normals, const float albedo[3])
{
    o->corners.count = 0;
    while (at_value(t)) {
        size_t vertex, normal, unused;
        corner *c = array_add(&o->corners, 1, sizeof *c, t);
        if (!c || element_index(t, seen_vertices, o->vertices.count / 3, "vertex", &vertex)) return -1;
        *c = (corner){ .position = (const float *)o->vertices.data + 3 * vertex };
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
    if (o->corners.count < 3 || o->corners.count > 1 << 30)
        return kit_fail(t->err, "%s line %d: a face needs at least 3 corners, this has %zu", t->path, t->line,
                        o->corners.count);
    return add_polygon(o, t, albedo);
}

/* ---- objects ------------------------------------------------------------------------------------------------- */

/* first[i]: the first of the keys whose bytes are those of key i */
static int first_of_equals(uint32_t *first, const key *keys, size_t count)
{
    size_t size = 16;
    while (size < 2 * count) size *= 2;
    uint32_t *slot = calloc(size, sizeof *slot);       /* of a key, plus 1 */
    if (!slot) return -1;
    for (size_t i = 0; i < count; ++i) {
        const key *k = &keys[i];
        uint32_t hash = 2166136261u;                    /* FNV-1a */
        for (size_t b = 0; b < k->length; ++b) hash = (hash ^ (uint8_t)k->bytes[b]) * 16777619u;
        size_t at = hash & (size - 1);
        while (slot[at]
               && (keys[slot[at] - 1].length != k->length || memcmp(keys[slot[at] - 1].bytes, k->bytes, k->length)))
            at = (at + 1) & (size - 1);
        if (!slot[at]) slot[at] = (uint32_t)i + 1;
        first[i] = slot[at] - 1;
    }
    free(slot);
    return 0;
}

static uint32_t root(uint32_t *parent, uint32_t t)
{
    while (parent[t] != t) {
        parent[t] = parent[parent[t]];
        t = parent[t];
    }
    return t;
}

/* Makes kinds below limit into numbers from 1 on, in the order in which they come; how many, -1 without memory */
static int64_t number_kinds(uint32_t *kind, size_t count, size_t limit)
{
    uint32_t *number = calloc(limit, sizeof *number), numbers = 0;
    for (size_t i = 0; number && i < count; ++i) {
        if (!number[kind[i]]) number[kind[i]] = ++numbers;
        kind[i] = number[kind[i]];
    }
    free(number);
    return number ? (int64_t)numbers : -1;
}

/* The same of the names that triangles have by o lines (way 0) or g lines (way 1), */
static int64_t number_names(uint32_t *number, const obj *o, int way)
{
    const size_t triangles = o->number.count, names = o->named[way].count;
    const uint32_t *line = o->line[way].data;
    uint32_t *first = malloc(names * sizeof *first);
    const int failed = !first || first_of_equals(first, o->named[way].data, names);
    for (size_t t = 0; !failed && t < triangles; ++t) number[t] = first[line[t]];
    free(first);
    return failed ? -1 : number_kinds(number, triangles, names);
}

/* and of the parts that hang together. */
static int64_t number_parts(uint32_t *number, const obj *o)
{
    const size_t triangles = o->number.count, corners = 3 * triangles;
    key *place = calloc(corners, sizeof *place);
    uint32_t *first = malloc(corners * sizeof *first);
    for (size_t i = 0; place && i < corners; ++i) place[i] = (key){ (const char *)o->position.data + 12 * i, 12 };
    const int failed = !place || !first || first_of_equals(first, place, corners);
    for (size_t t = 0; t < triangles; ++t) number[t] = (uint32_t)t;
    for (size_t i = 0; !failed && i < corners; ++i) {
        const uint32_t a = root(number, (uint32_t)(i / 3)), b = root(number, first[i] / 3);
        number[a > b ? a : b] = a > b ? b : a;
    }
    for (size_t t = 0; t < triangles; ++t) number[t] = root(number, (uint32_t)t);
    free(place);
    free(first);
    return failed ? -1 : number_kinds(number, triangles, triangles);
}

typedef struct share { size_t triangles; uint32_t number; } share;

static int by_size(const void *a, const void *b)
{
    const share *p = a, *q = b;
    return p->triangles != q->triangles ? (p->triangles < q->triangles ? 1 : -1) : p->number < q->number ? -1 : 1;
}

/* Keeps the KIT_MAX_OBJECTS - 1 numbers with most triangles, in their order; all others become KIT_MAX_OBJECTS. */
static int keep_largest(uint32_t *number, size_t triangles, size_t numbers)
{
    share *shares = calloc(numbers, sizeof *shares);
    uint32_t *kept = calloc(numbers, sizeof *kept), next = 0;
    const int failed = !shares || !kept;
    if (!failed) {
        for (size_t i = 0; i < numbers; ++i) shares[i].number = (uint32_t)i;
        for (size_t t = 0; t < triangles; ++t) shares[number[t] - 1].triangles++;
        qsort(shares, numbers, sizeof *shares, by_size);
        for (size_t i = 0; i < KIT_MAX_OBJECTS - 1; ++i) kept[shares[i].number] = 1;
        for (size_t i = 0; i < numbers; ++i) kept[i] = kept[i] ? ++next : KIT_MAX_OBJECTS;
        for (size_t t = 0; t < triangles; ++t) number[t] = kept[number[t] - 1];
    }
    free(shares);
    free(kept);
    return failed ? -1 : 0;
}

/* What comes now has this name. */
static int name_add(obj *o, int way, const char *name, size_t length, const text *t)
{
    key *k = array_add(&o->named[way], 1, sizeof *k, t);
    if (k) *k = (key){ name, length };
    return k ? 0 : -1;
}

static int objects_find(obj *o, const text *t)
{
    const size_t triangles = o->position.count / 9;
    uint32_t *number = array_add(&o->number, triangles, sizeof *number, t);
    int way = 0;
    if (!number) return -1;
    int64_t count = number_names(number, o, way);
    if (count == 1) count = number_names(number, o, ++way);
    if (count == 1) count = number_parts(number, o), ++way;
    const int many = count > KIT_MAX_OBJECTS;
    if (count < 0 || (many && keep_largest(number, triangles, (size_t)count)))
        return kit_fail(t->err, "%s: no memory for its objects", t->path);
    if (many) count = KIT_MAX_OBJECTS;
    kit_object *object = array_add(&o->objects, (size_t)count, sizeof *object, t);
    if (!object) return -1;
    memset(object, 0, (size_t)count * sizeof *object);
    for (size_t i = triangles; i-- > 0;) {
        kit_object *of = &object[number[i] - 1];
        of->first = i;
        of->casts = many && number[i] == KIT_MAX_OBJECTS ? 0 : -1;
        if (!of->casts) snprintf(of->name, sizeof of->name, "rest");
        else if (way == 2) snprintf(of->name, sizeof of->name, "part %u", (unsigned)number[i]);
        else {
            const key *name = (const key *)o->named[way].data + ((const uint32_t *)o->line[way].data)[i];
            snprintf(of->name, sizeof of->name, "%.*s", (int)(name->length < 64 ? name->length : 63), name->bytes);
        }
    }
    return 0;
}

/* First what faces refer to (it may come after them), then the faces. */
static int obj_read(obj *o, const char *path, const char *data, size_t size, kit_error *err)
{
    float *v;
    for (text t = text_start(path, data, size, err); next_line(&t);) {
        int normal = 0;
        if (keyword(&t, "v") || (normal = keyword(&t, "vn"))) {
            if (!(v = array_add(normal ? &o->normals : &o->vertices, 3, sizeof *v, &t))) return -1;
            for (int i = 0; i < 3; ++i) {
                if (number(&t, &v[i], normal ? "vn needs 3 numbers" : "v needs 3 numbers")) return -1;
                if (!normal && fabsf(v[i]) > FARTHEST)
                    return kit_fail(err, "%s line %d: a coordinate of %g: must be within %g of 0", path, t.line,
                        (double)v[i], (double)FARTHEST);
            }
        } else if (keyword(&t, "mtllib")) {
            size_t length = rest(&t);
            if (length && mtllib_read(&o->materials, &t, t.at, length)) return -1;
        }
    }
    size_t seen_vertices = 0, seen_normals = 0;
    const float *albedo = grey;
    int way;
    text t = text_start(path, data, size, err);
    for (way = 0; way < 2; ++way) if (name_add(o, way, "default", 7, &t)) return -1;
    while (next_line(&t)) {
        if (keyword(&t, "f")) { if (face(o, &t, seen_vertices, seen_normals, albedo)) return -1; }
        else if (keyword(&t, "v")) ++seen_vertices;
        else if (keyword(&t, "vn")) ++seen_normals;
        else if (keyword(&t, "usemtl")) {
            size_t length = rest(&t);
            albedo = material_find(&o->materials, t.at, length);
        } else if ((way = keyword(&t, "g")) || keyword(&t, "o")) {
            const size_t length = rest(&t);
            if (name_add(o, way, t.at, without_comment(t.at, length), &t)) return -1;
        }
    }
    return o->position.count ? objects_find(o, &t) : kit_fail(err, "%s: no triangles in this OBJ file", path);
}

int kit_mesh_obj(kit_mesh *mesh, kit_object **object, int *objects, const char *path, kit_error *err)
{
    char *data;
    size_t size;
    obj o;
    memset(&o, 0, sizeof o);
    if (kit_file_read(&data, &size, path, err)) return -1;
    prepare(data, size);
    int failed = obj_read(&o, path, data, size, err);
    free(data);
    for (size_t i = 0; i < o.materials.count; ++i) free(((material *)o.materials.data)[i].name);
    free(o.vertices.data); free(o.normals.data); free(o.materials.data); free(o.corners.data);
    for (int way = 0; way < 2; ++way) { free(o.named[way].data); free(o.line[way].data); }
    kit_mesh read = { .triangles = o.position.count / 9,
                      .position = o.position.data,
                      .normal = o.normal.data,
                      .albedo = o.albedo.data,
                      .object = o.number.data };
    if (failed || !object) free(o.objects.data);
    if (failed) {
        kit_mesh_free(&read);
        return -1;
    }
    for (int i = 0; i < 3; ++i) {
        read.lower[i] = read.upper[i] = read.position[i];
        for (size_t k = 0; k < 3 * read.triangles; ++k) {
            read.lower[i] = fminf(read.lower[i], read.position[3 * k + (size_t)i]);
            read.upper[i] = fmaxf(read.upper[i], read.position[3 * k + (size_t)i]);
        }
    }
    *mesh = read;
    if (object) {
        *object = o.objects.data;
        *objects = (int)o.objects.count;
    }
    return 0;
}
