/* mesh.c - triangles from Wavefront OBJ and MTL files.

   Read: v, vn, f, o, g, mtllib, usemtl; newmtl and Kd. All else is ignored: vt, lines, points, curves, textures.
   Polygons: strictly convex ones become a fan, others are cut by clipping ears in the plane of their largest projection
   (with more than CONCAVE_MOST corners a fan again, for time's sake). Triangles without area are dropped.
   Materials: of several with one name the last counts; all mtllib files are read before the first usemtl, each once.
   Time and memory are in proportion to the files' sizes, whatever they hold. */
#include "kit/kit.h"

#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#define CONCAVE_MOST 1000
#define EAR_TESTS 100                      /* a corner of a polygon; then what is known of the others is believed */

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

/* ---- keys ---------------------------------------------------------------------------------------------------- */

typedef struct key { const char *bytes; size_t length; } key;

/* The numbers of keys, found by their bytes. */
typedef struct table { const key *keys; uint32_t *slot; size_t size; uint64_t secret[2]; } table;

static uint64_t rotated(uint64_t v, int bits) { return v << bits | v >> (64 - bits); }

static void sip_round(uint64_t v[4])
{
    v[0] += v[1]; v[1] = rotated(v[1], 13) ^ v[0]; v[0] = rotated(v[0], 32);
    v[2] += v[3]; v[3] = rotated(v[3], 16) ^ v[2];
    v[0] += v[3]; v[3] = rotated(v[3], 21) ^ v[0];
    v[2] += v[1]; v[1] = rotated(v[1], 17) ^ v[2]; v[2] = rotated(v[2], 32);
}

/* SipHash-1-3 [Aumasson and Bernstein 2012]: without the secret nobody writes a file whose keys all share a slot. */
static uint64_t key_hash(const key *k, const uint64_t secret[2])
{
    uint64_t v[4] = { secret[0] ^ 0x736f6d6570736575u, secret[1] ^ 0x646f72616e646f6du, secret[0] ^ 0x6c7967656e657261u,
                      secret[1] ^ 0x7465646279746573u };
    for (size_t i = 0; i <= k->length / 8; ++i) {
        const size_t left = k->length - 8 * i;
        uint64_t word = 0;
        memcpy(&word, k->bytes + 8 * i, left < 8 ? left : 8);
        if (left < 8) word |= (uint64_t)(k->length & 255) << 56;
        v[3] ^= word;
        sip_round(v);
        v[0] ^= word;
    }
    v[2] ^= 255;
    for (int i = 0; i < 3; ++i) sip_round(v);
    return v[0] ^ v[1] ^ v[2] ^ v[3];
}

static int table_open(table *t, const key *keys, size_t count)
{
    *t = (table){ .keys = keys, .size = 16 };
    while (t->size < 2 * count) t->size *= 2;
    t->slot = calloc(t->size, sizeof *t->slot);        /* of a key, plus 1 */
    if (getentropy(t->secret, sizeof t->secret)) t->secret[0] = (uintptr_t)t->slot;
    return t->slot ? 0 : -1;
}

/* Where a key equal to k is, or would be. */
static uint32_t *table_slot(const table *t, const key *k)
{
    size_t at = key_hash(k, t->secret) & (t->size - 1);
    for (; t->slot[at]; at = (at + 1) & (t->size - 1)) {
        const key *there = &t->keys[t->slot[at] - 1];
        if (there->length == k->length && !memcmp(there->bytes, k->bytes, k->length)) break;
    }
    return &t->slot[at];
}

/* Key i, unless one that equals it is in there: the number of the one that is in there now. */
static uint32_t table_add(table *t, uint32_t i)
{
    uint32_t *slot = table_slot(t, &t->keys[i]);
    if (!*slot) *slot = i + 1;
    return *slot - 1;
}

/* ---- materials ----------------------------------------------------------------------------------------------- */

/* way 0: by whole names, way 1: by what stands before a comment */
typedef struct materials {
    array named[2];                        /* key */
    array albedo;                          /* float[3] */
    array text;                            /* char *: the files, which the names are in */
    table found[2];
} materials;

static const float grey[3] = { 0.8f, 0.8f, 0.8f };

/* The rest of the line without blanks at its ends. Names may hold blanks and '#' ("Material #25"): see
   without_comment. */
static key rest(text *t)
{
    const char *end = t->end;
    skip_blanks(t);
    while (end > t->at && blank(end[-1])) --end;
    return (key){ t->at, (size_t)(end - t->at) };
}

static key without_comment(key name)
{
    for (size_t i = 1; i < name.length; ++i)
        if (name.bytes[i] == '#' && blank(name.bytes[i - 1])) {
            while (i > 0 && blank(name.bytes[i - 1])) --i;
            return (key){ name.bytes, i };
        }
    return name;
}

static void materials_free(materials *m)
{
    for (size_t i = 0; i < m->text.count; ++i) free(((char **)m->text.data)[i]);
    for (int way = 0; way < 2; ++way) { free(m->named[way].data); free(m->found[way].slot); }
    free(m->albedo.data);
    free(m->text.data);
}

/* A grey one; NULL: no memory. */
static float *material_add(materials *m, key name, const text *t)
{
    key *whole = array_add(&m->named[0], 1, sizeof *whole, t), *bare = array_add(&m->named[1], 1, sizeof *bare, t);
    float *albedo = array_add(&m->albedo, 3, sizeof *albedo, t);
    if (!whole || !bare || !albedo) return NULL;
    *whole = name;
    *bare = without_comment(name);
    return memcpy(albedo, grey, sizeof grey);
}

static int materials_read(materials *m, const char *path, kit_error *err)
{
    char *data;
    size_t size;
    if (kit_file_read(&data, &size, path, NULL)) return 0;                      /* grey, as if there were none */
    prepare(data, size);
    text t = text_start(path, data, size, err);
    char **kept = array_add(&m->text, 1, sizeof *kept, &t);
    if (!kept) { free(data); return -1; }
    *kept = data;
    for (float *now = NULL; next_line(&t);) {
        if (keyword(&t, "newmtl")) {
            if (!(now = material_add(m, rest(&t), &t))) return -1;
        } else if (now && keyword(&t, "Kd")) {
            static const char what[] = "Kd needs 1 or 3 numbers";
            float kd[3];
            skip_blanks(&t);
            /* "xyz", "spectral": no rgb */
            if (t.end - t.at >= 3 && (!memcmp(t.at, "xyz", 3) || !memcmp(t.at, "spe", 3))) continue;
            if (number(&t, &kd[0], what)) return -1;
            kd[1] = kd[2] = kd[0];
            if (at_value(&t) && (number(&t, &kd[1], what) || number(&t, &kd[2], what))) return -1;
            for (int k = 0; k < 3; ++k) now[k] = fmaxf(0, fminf(1, kd[k]));
        }
    }
    return 0;
}

/* A file that an mtllib line names and that is there. */
typedef struct mtllib { char *path; struct { dev_t device; ino_t file; } id; } mtllib;

static int mtllib_add(array *mtllibs, const text *t, key name)
{
    const char *slash = strrchr(t->path, '/');
    const size_t folder = slash && *name.bytes != '/' ? (size_t)(slash - t->path) + 1 : 0;
    const key bare = without_comment(name);
    struct stat status;
    char *path = malloc(folder + name.length + 1);
    if (!path) return kit_fail(t->err, "%s: no memory for the names of its materials' files", t->path);
    memcpy(path, t->path, folder);
    memcpy(path + folder, name.bytes, name.length);
    path[folder + name.length] = 0;
    for (char *p = path + folder; *p; ++p) if (*p == '\\') *p = '/';            /* as Windows writes it */
    int there = !stat(path, &status);
    if (!there && bare.length < name.length) {
        path[folder + bare.length] = 0;
        there = !stat(path, &status);
    }
    mtllib *l = there ? array_add(mtllibs, 1, sizeof *l, t) : NULL;
    if (!l) { free(path); return there ? -1 : 0; }
    memset(l, 0, sizeof *l);               /* id is a key: no byte of it may be left to chance */
    l->path = path;
    l->id.device = status.st_dev;
    l->id.file = status.st_ino;
    return 0;
}

/* A file that is named more than once, however it is spelled, is read once, where the last line that names it has it:
   its materials count then as if it were read each time. */
static int mtllibs_read(materials *m, const array *mtllibs, const text *t)
{
    const mtllib *l = mtllibs->data;
    const size_t count = mtllibs->count;
    table last = { 0 };
    key *id = malloc(count * sizeof *id + 1);
    char *reads = malloc(count + 1);
    int failed = 0;
    for (size_t i = 0; id && i < count; ++i) id[i] = (key){ (const char *)&l[i].id, sizeof l[i].id };
    if (!id || !reads || table_open(&last, id, count))
        failed = kit_fail(t->err, "%s: no memory for the names of its materials' files", t->path);
    for (size_t i = count; !failed && i-- > 0;) reads[i] = table_add(&last, (uint32_t)i) == i;
    for (size_t i = 0; !failed && i < count; ++i) if (reads[i]) failed = materials_read(m, l[i].path, t->err);
    free(last.slot);
    free(id);
    free(reads);
    return failed;
}

/* All are there: from now on they are found. The last of one name goes in first, so that it counts. */
static int materials_close(materials *m, const text *t)
{
    const size_t count = m->named[0].count;
    for (int way = 0; way < 2; ++way) {
        if (table_open(&m->found[way], m->named[way].data, count))
            return kit_fail(t->err, "%s: no memory for its materials", t->path);
        for (size_t i = count; i-- > 0;) table_add(&m->found[way], (uint32_t)i);
    }
    return 0;
}

static const float *material_find(const materials *m, key name)
{
    const key wanted[2] = { name, without_comment(name) };
    for (int way = 0; way < 2; ++way) {
        const uint32_t slot = *table_slot(&m->found[way], &wanted[way]);
        if (slot) return (const float *)m->albedo.data + 3 * (slot - 1);
    }
    return grey;
}

/* ---- faces --------------------------------------------------------------------------------------------------- */

enum { UNKNOWN, EAR, NO_EAR };
typedef struct corner { const float *position, *normal; double flat[2]; int next, ear; } corner;

typedef struct obj {
    array vertices, normals;               /* float[3] */
    array mtllibs;                         /* mtllib */
    materials materials;
    array corners;                         /* of the present face */
    array position, normal, albedo;        /* 9, 9, 3 floats a triangle */
    array vertex;                          /* 3 uint32_t a triangle */
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
    uint32_t *vertex = array_add(&o->vertex, 3, sizeof *vertex, t);
    if (!position || !normal || !colour || !vertex) return -1;
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
        vertex[k] = (uint32_t)((p[k]->position - (const float *)o->vertices.data) / 3);
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
static int add_concave(obj *o, const text *t, const float albedo[3])
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

static int add_polygon(obj *o, const text *t, const float albedo[3])
{
    corner *c = o->corners.data;
    int count = (int)o->corners.count, failed = 0;
    if (count > 3 && !flatten(c, count) && count <= CONCAVE_MOST) return add_concave(o, t, albedo);
    for (int k = 2; k < count && !failed; ++k) failed = add_triangle(o, t, &c[0], &c[k - 1], &c[k], albedo);
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
    table t;
    if (table_open(&t, keys, count)) return -1;
    for (size_t i = 0; i < count; ++i) first[i] = table_add(&t, (uint32_t)i);
    free(t.slot);
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

/* and of the parts that hang together: vertices at one place are one. */
static int64_t number_parts(uint32_t *number, const obj *o)
{
    const size_t triangles = o->number.count, vertices = o->vertices.count / 3;
    const uint32_t *vertex = o->vertex.data;
    key *place = calloc(vertices, sizeof *place);
    uint32_t *parent = malloc(vertices * sizeof *parent);
    for (size_t i = 0; place && i < vertices; ++i) place[i] = (key){ (const char *)o->vertices.data + 12 * i, 12 };
    const int failed = !place || !parent || first_of_equals(parent, place, vertices);
    for (size_t i = 0; !failed && i < 3 * triangles; ++i) {
        const uint32_t a = root(parent, vertex[i / 3 * 3]), b = root(parent, vertex[i]);
        parent[a > b ? a : b] = a > b ? b : a;
    }
    for (size_t t = 0; !failed && t < triangles; ++t) number[t] = root(parent, vertex[3 * t]);
    free(place);
    free(parent);
    return failed ? -1 : number_kinds(number, triangles, vertices);
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
static int name_add(obj *o, int way, key name, const text *t)
{
    key *k = array_add(&o->named[way], 1, sizeof *k, t);
    if (k) *k = name;
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
    for (int64_t k = 0; k < count; ++k) object[k].first = SIZE_MAX;
    for (size_t i = 0; i < triangles; ++i) {
        kit_object *of = &object[number[i] - 1];
        if (of->first != SIZE_MAX) continue;
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
            const key name = rest(&t);
            if (name.length && mtllib_add(&o->mtllibs, &t, name)) return -1;
        }
    }
    size_t seen_vertices = 0, seen_normals = 0;
    const float *albedo = grey;
    int way;
    text t = text_start(path, data, size, err);
    if (mtllibs_read(&o->materials, &o->mtllibs, &t) || materials_close(&o->materials, &t)) return -1;
    for (way = 0; way < 2; ++way) if (name_add(o, way, (key){ "default", 7 }, &t)) return -1;
    while (next_line(&t)) {
        if (keyword(&t, "f")) { if (face(o, &t, seen_vertices, seen_normals, albedo)) return -1; }
        else if (keyword(&t, "v")) ++seen_vertices;
        else if (keyword(&t, "vn")) ++seen_normals;
        else if (keyword(&t, "usemtl")) {
            albedo = material_find(&o->materials, rest(&t));
        } else if ((way = keyword(&t, "g")) || keyword(&t, "o")) {
            if (name_add(o, way, without_comment(rest(&t)), &t)) return -1;
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
    if (size / 2 > UINT32_MAX) {            /* names, of 2 bytes at least, and vertices have numbers of 32 bits */
        free(data);
        return kit_fail(err, "%s: must not be larger than 8 GiB", path);
    }
    prepare(data, size);
    int failed = obj_read(&o, path, data, size, err);
    free(data);
    for (size_t i = 0; i < o.mtllibs.count; ++i) free(((mtllib *)o.mtllibs.data)[i].path);
    materials_free(&o.materials);
    free(o.vertices.data); free(o.normals.data); free(o.vertex.data); free(o.corners.data); free(o.mtllibs.data);
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
