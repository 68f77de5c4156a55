/* soup.c - collects triangles in the order in which a reader finds them, and finds the objects that they form. Declared
   in kit_obj.h. */
#include "kit/kit_obj.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const float kit_grey[3] = { 0.8f, 0.8f, 0.8f };

void *kit_array_add(kit_array *a, size_t n, size_t element, const kit_source *from)
{
    if (a->count + n > a->capacity) {
        const size_t capacity = 2 * a->capacity + n + 64;
        void *data = realloc(a->data, capacity * element);
        if (!data) {
            kit_fail(from->err, "%s: no memory for this mesh", from->path);
            return NULL;
        }
        a->data = data;
        a->capacity = capacity;
    }
    a->count += n;
    return (char *)a->data + (a->count - n) * element;
}

void kit_mesh_free(kit_mesh *mesh)
{
    free(mesh->position);
    free(mesh->normal);
    free(mesh->albedo);
    free(mesh->object);
    memset(mesh, 0, sizeof *mesh);
}

void kit_mesh_bounds(kit_mesh *mesh)
{
    for (size_t i = 0; i < 3 * mesh->triangles; i++)
        for (int c = 0; c < 3; c++) {
            float p = mesh->position[3 * i + (size_t)c];
            if (!i || p < mesh->lower[c]) mesh->lower[c] = p;
            if (!i || p > mesh->upper[c]) mesh->upper[c] = p;
        }
}

void kit_soup_free(kit_soup *s)
{
    kit_array *const all[] = { &s->position, &s->normal,  &s->albedo,  &s->vertices, &s->vertex, &s->named[0],
                               &s->named[1], &s->line[0], &s->line[1], &s->number,   &s->objects };
    for (size_t i = 0; i < sizeof all / sizeof *all; ++i) free(all[i]->data);
    memset(s, 0, sizeof *s);
}

int kit_soup_triangle(kit_soup *s, const float *const position[3], const float *const normal[3], const float albedo[3],
                      const kit_source *from)
{
    double e[3][3], n[3], longest = 0;
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < 3; ++i) e[k][i] = (double)position[(k + 1) % 3][i] - (double)position[k][i];
        longest = fmax(longest, kit_dot(e[k], e[k]));
    }
    kit_cross(e[0], e[1], n);
    const double area = sqrt(kit_dot(n, n));
    if (!(area > 1e-9 * longest)) return 0; /* with so small an area floats cannot tell the triangle from a line */
    float *to = kit_array_add(&s->position, 9, sizeof(float), from),
          *turned = kit_array_add(&s->normal, 9, sizeof(float), from);
    float *colour = kit_array_add(&s->albedo, 3, sizeof(float), from);
    if (!to || !turned || !colour) return -1;
    for (int way = 0; way < 2; ++way) {
        uint32_t *line = kit_array_add(&s->line[way], 1, sizeof *line, from);
        if (!line) return -1;
        *line = (uint32_t)(s->named[way].count - 1);
    }
    memcpy(colour, albedo, 3 * sizeof(float));
    for (int k = 0; k < 3; ++k) {
        double own[3];
        for (int i = 0; i < 3; ++i) own[i] = normal[k] ? (double)normal[k][i] : 0;
        const double length = sqrt(kit_dot(own, own));
        memcpy(to + 3 * k, position[k], 3 * sizeof(float));
        for (int i = 0; i < 3; ++i) turned[3 * k + i] = (float)(length > 0 ? own[i] / length : n[i] / area);
    }
    return 1;
}

/* ---- objects ------------------------------------------------------------------------------------------------- */

/* Sets first[i] to the first key whose bytes equal those of key i, by a hash table with open addressing. */
static int first_of_equals(uint32_t *first, const kit_key *keys, size_t count)
{
    size_t size = 16;
    while (size < 2 * count) size *= 2;
    uint32_t *slot = calloc(size, sizeof *slot);        /* index of a key, plus 1; 0: empty */
    for (size_t i = 0; slot && i < count; ++i) {
        size_t at = kit_hash(KIT_HASH, keys[i].bytes, keys[i].length) & (size - 1);
        for (; slot[at]; at = (at + 1) & (size - 1)) {
            const kit_key *const there = &keys[slot[at] - 1];
            if (there->length == keys[i].length && !memcmp(there->bytes, keys[i].bytes, there->length)) break;
        }
        if (!slot[at]) slot[at] = (uint32_t)i + 1;
        first[i] = slot[at] - 1;
    }
    const int failed = !slot;
    free(slot);
    return failed ? -1 : 0;
}

static uint32_t root(uint32_t *parent, uint32_t t)
{
    while (parent[t] != t) {
        parent[t] = parent[parent[t]];
        t = parent[t];
    }
    return t;
}

/* Renumbers kinds below limit from 1 on, by their first use. Returns the number of kinds, -1 without memory. */
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

/* Numbers the triangles' names, o lines (way 0) or g lines (way 1), in the order of their first use. */
static int64_t number_names(uint32_t *number, const kit_soup *s, int way)
{
    const size_t triangles = s->number.count, names = s->named[way].count;
    const uint32_t *line = s->line[way].data;
    uint32_t *first = malloc(names * sizeof *first);
    const int failed = !first || first_of_equals(first, s->named[way].data, names);
    for (size_t t = 0; !failed && t < triangles; ++t) number[t] = first[line[t]];
    free(first);
    return failed ? -1 : number_kinds(number, triangles, names);
}

static uint32_t vertex_of(const uint32_t *vertex, size_t corner) { return vertex ? vertex[corner] : (uint32_t)corner; }

/* Numbers the connected parts likewise: vertices at equal positions are one. */
static int64_t number_parts(uint32_t *number, const kit_soup *s)
{
    const size_t triangles = s->number.count, shared = s->vertices.count / 3;
    const size_t vertices = shared ? shared : 3 * triangles;
    const char *at = shared ? s->vertices.data : s->position.data;
    const uint32_t *vertex = s->vertex.data;
    kit_key *place = calloc(vertices, sizeof *place);
    uint32_t *parent = malloc(vertices * sizeof *parent);
    for (size_t i = 0; place && i < vertices; ++i) place[i] = (kit_key){ at + 12 * i, 12 };
    const int failed = !place || !parent || first_of_equals(parent, place, vertices);
    for (size_t i = 0; !failed && i < 3 * triangles; ++i) {
        const uint32_t a = root(parent, vertex_of(vertex, i / 3 * 3)), b = root(parent, vertex_of(vertex, i));
        parent[a > b ? a : b] = a > b ? b : a;
    }
    for (size_t t = 0; !failed && t < triangles; ++t) number[t] = root(parent, vertex_of(vertex, 3 * t));
    free(place);
    free(parent);
    return failed ? -1 : number_kinds(number, triangles, vertices);
}

typedef struct share {
    size_t triangles;
    uint32_t number;
} share;

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

int kit_soup_name(kit_soup *s, int way, kit_key name, const kit_source *from)
{
    kit_key *k = kit_array_add(&s->named[way], 1, sizeof *k, from);
    if (k) *k = name;
    return k ? 0 : -1;
}

int kit_soup_empty(size_t points, const kit_source *from)
{
    return points ? kit_fail(from->err, "%s: no triangles in it, but a cloud of %zu points: draw them yourself, and "
                                        "give their depth: --gbuffer F.exr --set lift=1,offset=8", from->path, points)
                  : kit_fail(from->err, "%s: no triangles in it", from->path);
}

int kit_soup_objects(kit_soup *s, const kit_source *from)
{
    const size_t triangles = s->position.count / 9;
    uint32_t *number = kit_array_add(&s->number, triangles, sizeof *number, from);
    int way = 0;
    if (!number) return -1;
    int64_t count = number_names(number, s, way);
    if (count == 1) count = number_names(number, s, ++way);
    if (count == 1) count = number_parts(number, s), ++way;
    const int many = count > KIT_MAX_OBJECTS;
    if (count < 0 || (many && keep_largest(number, triangles, (size_t)count)))
        return kit_fail(from->err, "%s: no memory for its objects", from->path);
    if (many) count = KIT_MAX_OBJECTS;
    kit_object *object = kit_array_add(&s->objects, (size_t)count, sizeof *object, from);
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
            const kit_key *name = (const kit_key *)s->named[way].data + ((const uint32_t *)s->line[way].data)[i];
            snprintf(of->name, sizeof of->name, "%.*s", (int)(name->length < 64 ? name->length : 63), name->bytes);
        }
    }
    return 0;
}

double kit_diagonal(const float lower[3], const float upper[3])
{
    double sum = 0;
    for (int i = 0; i < 3; ++i) sum += pow((double)upper[i] - (double)lower[i], 2);
    return sqrt(sum);
}

int kit_origin_move(double origin[3], const float lower[3], const float upper[3])
{
    double middle[3], away = 0;
    const double diagonal = kit_diagonal(lower, upper);
    for (int i = 0; i < 3; ++i) {
        middle[i] = 0.5 * ((double)lower[i] + (double)upper[i]);
        away = fmax(away, fabs(middle[i]));
    }
    if (!(away > KIT_AWAY * diagonal && away <= (double)KIT_FARTHEST)) return 0;
    const double step = diagonal > 0 ? exp2(floor(log2(diagonal))) : 0; /* a power of 2: the number has few digits */
    for (int i = 0; i < 3; ++i) origin[i] += step > 0 ? step * rint(middle[i] / step) : middle[i];
    return 1;
}

void kit_soup_take(kit_soup *s, kit_mesh *mesh, kit_object **object, int *objects)
{
    *mesh = (kit_mesh){ .triangles = s->position.count / 9,
                        .position = s->position.data,
                        .normal = s->normal.data,
                        .albedo = s->albedo.data,
                        .object = s->number.data };
    memcpy(mesh->origin, s->origin, sizeof mesh->origin);
    s->position.data = s->normal.data = s->albedo.data = s->number.data = NULL;
    kit_mesh_bounds(mesh);
    if (!object) return;
    *object = s->objects.data;
    *objects = (int)s->objects.count;
    s->objects.data = NULL;
}

/* ---- >>notes ----------------------------------------------------------------------------------------------------- */

void kit_note(char *note, const char *format, ...)
{
    const size_t used = strlen(note);
    va_list list;
    va_start(list, format);
    char *to = note + used + (used ? (size_t)snprintf(note + used, KIT_NOTE - used, "; ") : 0);
    if (to < note + KIT_NOTE) vsnprintf(to, (size_t)(note + KIT_NOTE - to), format, list);
    va_end(list);
}

void kit_note_gap(char *note, const char *kind, double gap, const float lower[3], const float upper[3])
{
    const double diagonal = kit_diagonal(lower, upper);
    if (gap > KIT_COARSE * diagonal && isfinite(diagonal))
        kit_note(note, "its coordinates are read as %s, which so far from 0 are %.2g apart, %.2g of its size", kind,
                 gap, gap / diagonal);
}
