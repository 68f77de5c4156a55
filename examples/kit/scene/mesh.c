/* mesh.c - reads triangles of Wavefront OBJ files: models of scenes by seed, which are the same on every machine,
   models of tests and, in a build without Assimp, users' files.

   Read: v, vn, f, o, g, mtllib, usemtl; newmtl and Kd. All else is ignored: vt, lines, points, curves, textures. A
   strictly convex polygon becomes a fan. Others are cut by clipping ears in the plane of their largest projection, or
   become a fan if they have more than MOST_EARS corners. Triangles without area are dropped, and so are faces of one or
   two corners, which exporters write. Of several materials with one name the last counts. */
#include "kit/kit_obj.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { MOST_EARS = 1000 };

typedef struct corner { const float *position, *normal; double flat[2]; int next; } corner;
typedef struct material { kit_key name; float albedo[3]; } material;

typedef struct obj {
    kit_source from;
    kit_soup soup;
    kit_array normals;                     /* float[3] */
    kit_array corners;                     /* of the present face */
    kit_array lines;                       /* elements are char *: each line without its end and leading blanks */
    kit_array materials, texts;        /* elements are char *: the texts of the MTL files, into which the names point */
    size_t own_lines;                      /* number of the OBJ's own lines, which come first */
    int bare;                              /* 0; if materials are not read, 1 + the number of MTL files */
    const float *albedo;
} obj;

/* ---- >>lines ----------------------------------------------------------------------------------------------------- */

static int is_blank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f'; }

static char *behind_blanks(char *at)
{
    while (is_blank(*at)) ++at;
    return at;
}

/* Returns the text after a line's first word; NULL if the line has another first word. */
static char *behind(char *line, const char *word)
{
    const size_t length = strlen(word);
    const int is = !strncmp(line, word, length) && (is_blank(line[length]) || !line[length]);
    return is ? behind_blanks(line + length) : NULL;
}

static int add_line(obj *o, char *text)
{
    char **const line = kit_array_add(&o->lines, 1, sizeof *line, &o->from);
    if (line) *line = behind_blanks(text);
    return line ? 0 : -1;
}

/* Splits a text into lines, which may end in CR alone. A backslash at the end continues a line, except in a comment, in
   which it may end a Windows path. The line after a continued one is then empty, so that lines keep their numbers. */
static int split(obj *o, char *text)
{
    if (!strncmp(text, "\xEF\xBB\xBF", 3)) text += 3;    /* byte order mark */
    const char ending = strchr(text, '\n') ? '\n' : '\r';
    while (text) {
        char *end = strchr(text, ending);
        int continued = 0;
        const int comment = *behind_blanks(text) == '#';
        for (; end; end = strchr(end, ending), ++continued) {
            char *const last = end > text && end[-1] == '\r' ? end - 2 : end - 1;
            if (comment || last < text || *last != '\\') break;
            memset(last, ' ', (size_t)(end - last) + 1);
        }
        if (end) *end = 0;
        if (add_line(o, text)) return -1;
        text = end ? end + 1 : NULL;
        while (continued--)
            if (add_line(o, "")) return -1;
    }
    return 0;
}

static int wrong(const obj *o, const char *what, const char *at)
{
    const int length = (int)strcspn(at, " \t\r");
    return length ? kit_fail(o->from.err, "%s line %d: %s, not \"%.*s\"", o->from.path, o->from.line, what,
                             length < 24 ? length : 24, at)
                  : kit_fail(o->from.err, "%s line %d: %s, but the line ends", o->from.path, o->from.line, what);
}

/* Reads count numbers and subtracts an origin unless it is NULL; what: their name in messages. Returns the text after
   them; NULL: they are missing. */
static char *floats(const obj *o, float *out, int count, char *at, const char *what, const double *origin)
{
    for (int i = 0; i < count; ++i) {
        char *end;
        at = behind_blanks(at);
        const float v = origin ? (float)(strtod(at, &end) - origin[i]) : strtof(at, &end);
        const int digits = (long)strcspn(at, "0123456789") < end - at, whole = !*end || is_blank(*end) || *end == '#';
        if (!digits || !whole || !isfinite(v)) {
            wrong(o, digits && whole ? "a number is too large: at most 3.4e38 is possible" : what, at);
            return NULL;
        }
        out[i] = v + 0.0f;                 /* never -0: equal positions have equal bytes */
        at = end;
    }
    return behind_blanks(at);
}

static kit_key trimmed(const char *at, size_t length)
{
    while (length && is_blank(at[length - 1])) --length;
    return (kit_key){ at, length };
}

static kit_key rest_of(const char *at) { return trimmed(at, strlen(at)); }

/* Cuts a comment off a name, if it is no name with it: names may contain blanks and '#' ("Material #25"). */
static kit_key without_comment(kit_key name)
{
    for (size_t i = 1; i < name.length; ++i)
        if (name.bytes[i] == '#' && is_blank(name.bytes[i - 1])) return trimmed(name.bytes, i);
    return name;
}

/* ---- >>materials ------------------------------------------------------------------------------------------------- */

static int read_material_line(obj *o, char *line)
{
    const size_t count = o->materials.count;
    char *at = behind(line, "newmtl");
    if (at) {
        material *const m = kit_array_add(&o->materials, 1, sizeof *m, &o->from);
        if (m) *m = (material){ rest_of(at), { kit_grey[0], kit_grey[1], kit_grey[2] } };
        return m ? 0 : -1;
    }
    if (!(at = behind(line, "Kd")) || !count || !strncmp(at, "xyz", 3) || !strncmp(at, "spectral", 8)) return 0;
    float *const kd = ((material *)o->materials.data)[count - 1].albedo;
    static const char what[] = "Kd needs 1 or 3 numbers";
    if (!(at = floats(o, kd, 1, at, what, NULL))) return -1;
    kd[1] = kd[2] = kd[0];
    if (*at && *at != '#' && !floats(o, kd + 1, 2, at, what, NULL)) return -1;
    for (int i = 0; i < 3; ++i) kd[i] = fmaxf(0, fminf(1, kd[i]));
    return 0;
}

/* Reads a file in the OBJ's folder. Returns -1 if it is missing; its materials stay grey. */
static int read_beside(char path[4096], char **text, const obj *o, kit_key name)
{
    const char *const slash = strrchr(o->from.path, '/');
    size_t size;
    snprintf(path, 4096, "%.*s%.*s", slash && *name.bytes != '/' ? (int)(slash - o->from.path) + 1 : 0, o->from.path,
             (int)name.length, name.bytes);
    for (char *p = path; *p; ++p)
        if (*p == '\\') *p = '/';         /* as Windows writes it */
    return kit_file_read(text, &size, path, NULL);
}

static int read_materials(obj *o, kit_key name)
{
    const kit_source own = o->from;
    char path[4096], *text, **kept;
    if (read_beside(path, &text, o, name) && read_beside(path, &text, o, without_comment(name))) return 0;
    if (!(kept = kit_array_add(&o->texts, 1, sizeof *kept, &own))) {
        free(text);
        return -1;
    }
    *kept = text;
    const size_t first = o->lines.count;
    int failed = split(o, text);
    o->from.path = path;
    for (size_t i = first; i < o->lines.count && !failed; ++i) {
        o->from.line = (int)(i - first) + 1;
        failed = read_material_line(o, ((char **)o->lines.data)[i]);
    }
    o->from = own;
    return failed;
}

static int same_key(kit_key a, kit_key b) { return a.length == b.length && !memcmp(a.bytes, b.bytes, a.length); }

static const float *find_material(const obj *o, kit_key name)
{
    const material *const all = o->materials.data;
    for (size_t i = o->materials.count; i-- > 0;)
        if (same_key(all[i].name, name)) return all[i].albedo;
    for (size_t i = o->materials.count; i-- > 0;)
        if (same_key(without_comment(all[i].name), without_comment(name))) return all[i].albedo;
    return kit_grey;
}

/* ---- >>faces ----------------------------------------------------------------------------------------------------- */

static int add_triangle(obj *o, const corner *a, const corner *b, const corner *c)
{
    const float *const position[3] = { a->position, b->position, c->position };
    const float *const normal[3] = { a->normal, b->normal, c->normal };
    const int added = kit_soup_triangle(&o->soup, position, normal, o->albedo, &o->from);
    if (added < 1) return added;
    uint32_t *vertex = kit_array_add(&o->soup.vertex, 3, sizeof *vertex, &o->from);
    if (!vertex) return -1;
    for (int k = 0; k < 3; ++k) vertex[k] = (uint32_t)((position[k] - (const float *)o->soup.vertices.data) / 3);
    return 0;
}

static double turn(const corner *a, const corner *b, const corner *c) /* > 0: left */
{
    return (b->flat[0] - a->flat[0]) * (c->flat[1] - b->flat[1])
           - (b->flat[1] - a->flat[1]) * (c->flat[0] - b->flat[0]);
}

static double ahead(const corner *a, const corner *b, const corner *c)
{
    return (b->flat[0] - a->flat[0]) * (c->flat[0] - b->flat[0])
           + (b->flat[1] - a->flat[1]) * (c->flat[1] - b->flat[1]);
}

static int same(const corner *a, const corner *b) { return a->flat[0] == b->flat[0] && a->flat[1] == b->flat[1]; }

/* Projects the polygon counter-clockwise into a plane; returns whether it is strictly convex. */
static int flatten(corner *c, int count)
{
    double n[3] = { 0 }, turned = 0;
    for (int k = 0; k < count; ++k)        /* adds up Newell's normal, relative to corner 0 for precision */
        for (int i = 0; i < 3; ++i) {
            const float *o = c[0].position, *p = c[k].position, *q = c[(k + 1) % count].position;
            const int u = (i + 1) % 3, v = (i + 2) % 3;
            n[i] += ((double)p[u] - (double)o[u]) * ((double)q[v] - (double)o[v])
                    - ((double)p[v] - (double)o[v]) * ((double)q[u] - (double)o[u]);
        }
    const int z = fabs(n[0]) > fabs(n[1]) ? (fabs(n[0]) > fabs(n[2]) ? 0 : 2) : fabs(n[1]) > fabs(n[2]) ? 1 : 2;
    for (int k = 0; k < count; ++k) {
        c[k].flat[0] = (double)c[k].position[(z + 1) % 3];
        c[k].flat[1] = n[z] < 0 ? -(double)c[k].position[(z + 2) % 3] : (double)c[k].position[(z + 2) % 3];
        c[k].next = (k + 1) % count;
    }
    for (int k = 0; k < count; ++k) {
        const corner *p = &c[k], *q = &c[(k + 1) % count], *r = &c[(k + 2) % count];
        if (!(turn(p, q, r) > 0)) return 0;
        turned += atan2(turn(p, q, r), ahead(p, q, r));
    }
    return turned < 7;                     /* one turn is 2 pi; a star polygon turns more than once */
}

static int is_ear(const corner *c, int a, int b, int d)
{
    const double left = turn(&c[a], &c[b], &c[d]);
    if (left == 0 && ahead(&c[a], &c[b], &c[d]) < 0) return 1;                  /* a spike without area */
    if (!(left > 0)) return 0;
    for (int k = c[d].next; k != a; k = c[k].next)
        if (turn(&c[a], &c[b], &c[k]) >= 0 && turn(&c[b], &c[d], &c[k]) >= 0 && turn(&c[d], &c[a], &c[k]) >= 0
            && !same(&c[k], &c[a]) && !same(&c[k], &c[b]) && !same(&c[k], &c[d]))
            return 0;                      /* holes are bridged by corners that occur twice */
    return 1;
}

/* Cuts a polygon into triangles. If no ear is left, for example if it crosses itself, any corner is cut off. */
static int add_polygon(obj *o)
{
    corner *c = o->corners.data;
    int count = (int)o->corners.count, failed = 0;
    if (count < 4 || flatten(c, count) || count > MOST_EARS) {
        for (int k = 2; k < count && !failed; ++k) failed = add_triangle(o, &c[0], &c[k - 1], &c[k]);
        return failed;
    }
    for (int a = 0, tries = 0; count > 2 && !failed;) {
        const int b = c[a].next, d = c[b].next;
        if (!is_ear(c, a, b, d) && tries++ < count) {
            a = b;
            continue;
        }
        failed = add_triangle(o, &c[a], &c[b], &c[d]);
        c[a].next = d;
        a = d;                             /* goes on at the next corner, which avoids fans of slivers */
        tries = 0;
        --count;
    }
    return failed;
}

/* Reads an index, "7", or "-1", which counts from the end; out: counted from 0. */
static int element(const obj *o, char **at, size_t seen, size_t all, const char *what, size_t *out)
{
    char *end;
    const long v = strtol(*at, &end, 10);
    if (end == *at || (*end && !is_blank(*end) && *end != '/' && *end != '#'))
        return wrong(o, "a face needs corners such as 1, 1/2, 1//3 or 1/2/3", *at);
    const size_t back = 0 - (size_t)v;     /* also correct for LONG_MIN, unlike -v */
    if (v == 0 || (v < 0 ? back > seen : (size_t)v > all))
        return kit_fail(o->from.err, "%s line %d: there is no %s %ld (%zu %s)", o->from.path, o->from.line, what, v,
                        v < 0 ? seen : all, v < 0 ? "before this line" : "in the file");
    *out = v < 0 ? seen - back : (size_t)v - 1;
    *at = end;
    return 0;
}

static int face(obj *o, char *at, size_t vertices, size_t normals)
{
    o->corners.count = 0;
    while (*(at = behind_blanks(at)) && *at != '#') {
        size_t vertex, normal;
        corner *c = kit_array_add(&o->corners, 1, sizeof *c, &o->from);
        if (!c || element(o, &at, vertices, o->soup.vertices.count / 3, "vertex", &vertex)) return -1;
        *c = (corner){ .position = (const float *)o->soup.vertices.data + 3 * vertex };
        if (*at != '/') continue;
        const size_t unused = strspn(at + 1, "-0123456789");                    /* vt */
        at += 1 + unused;
        if (!unused && *at != '/') return wrong(o, "a face needs corners such as 1, 1/2, 1//3 or 1/2/3", at);
        if (*at != '/') continue;
        ++at;
        if (element(o, &at, normals, o->normals.count / 3, "vn", &normal)) return -1;
        c->normal = (const float *)o->normals.data + 3 * normal;
    }
    if (!o->corners.count)
        return kit_fail(o->from.err, "%s line %d: a face needs at least 3 corners", o->from.path, o->from.line);
    return add_polygon(o);
}

/* ---- >>all ------------------------------------------------------------------------------------------------------- */

/* Reads vertices and normals first, because they may come after the faces that use them. */
static int read_vertices(obj *o)
{
    char *at;
    for (size_t i = 0; i < o->own_lines; ++i) {
        char *const line = ((char **)o->lines.data)[i];
        const int normal = (at = behind(line, "vn")) != NULL;
        o->from.line = (int)i + 1;
        if (normal || (at = behind(line, "v")) != NULL) {
            float *const v = kit_array_add(normal ? &o->normals : &o->soup.vertices, 3, sizeof *v, &o->from);
            if (!v || !floats(o, v, 3, at, normal ? "vn needs 3 numbers" : "v needs 3 numbers", NULL)) return -1;
            for (int k = 0; k < 3 && !normal; ++k)
                if (fabsf(v[k]) > KIT_FARTHEST)
                    return kit_fail(o->from.err, "%s line %d: a coordinate of %g: must be within %g of 0", o->from.path,
                                    o->from.line, (double)v[k], (double)KIT_FARTHEST);
        } else if ((at = behind(line, "mtllib")) != NULL && *at) {
            if (o->bare) ++o->bare;
            else if (read_materials(o, rest_of(at))) return -1;
        }
    }
    return 0;
}

/* Writes the bounds of the vertices that faces use. */
static void bounds_of_faces(const obj *o, float lower[3], float upper[3])
{
    const long all = (long)(o->soup.vertices.count / 3);
    long seen = 0;
    for (int k = 0; k < 3; ++k) {
        lower[k] = INFINITY;
        upper[k] = -INFINITY;
    }
    for (size_t i = 0; i < o->own_lines; ++i) {
        char *const line = ((char **)o->lines.data)[i], *at = behind(line, "f");
        seen += behind(line, "v") != NULL;
        for (; at && *at && *at != '#'; at = behind_blanks(at + strcspn(at, " \t\r\v\f"))) {
            const long named = strtol(at, NULL, 10), vertex = named < 0 ? seen + named : named - 1;
            if (vertex < 0 || vertex >= all) continue;
            for (int k = 0; k < 3; ++k) {
                const float v = ((const float *)o->soup.vertices.data)[3 * vertex + k];
                lower[k] = fminf(lower[k], v);
                upper[k] = fmaxf(upper[k], v);
            }
        }
    }
}

/* Reads vertices that are far from 0 again, in double, about their middle. */
static int move_origin(obj *o)
{
    float lower[3], upper[3];
    char *at;
    bounds_of_faces(o, lower, upper);
    for (int turn = 0; turn < 2 && kit_origin_move(o->soup.origin, lower, upper); ++turn) {
        float *v = o->soup.vertices.data;
        for (size_t i = 0; i < o->own_lines; ++i)
            if ((at = behind(((char **)o->lines.data)[i], "v")) != NULL) {
                if (!floats(o, v, 3, at, "v needs 3 numbers", o->soup.origin)) return -1;
                v += 3;
            }
        bounds_of_faces(o, lower, upper);
    }
    return 0;
}

static int read_faces(obj *o)
{
    size_t vertices = 0, normals = 0;
    int joined = 0;
    o->albedo = kit_grey;
    for (int way = 0; way < 2; ++way)
        if (kit_soup_name(&o->soup, way, (kit_key){ "default", 7 }, &o->from)) return -1;
    for (size_t i = 0; i < o->own_lines; ++i) {
        char *const line = ((char **)o->lines.data)[i], *at;
        int way = 0;
        o->from.line = (int)i + 1;
        joined |= behind(line, "f") != NULL || behind(line, "l") != NULL;
        if ((at = behind(line, "f")) != NULL) {
            if (face(o, at, vertices, normals)) return -1;
        } else if (behind(line, "v")) ++vertices;
        else if (behind(line, "vn")) ++normals;
        else if ((at = behind(line, "usemtl")) != NULL) o->albedo = find_material(o, rest_of(at));
        else if ((at = behind(line, "o")) != NULL || (way = 1, at = behind(line, "g")) != NULL) {
            if (kit_soup_name(&o->soup, way, without_comment(rest_of(at)), &o->from)) return -1;
        }
    }
    return o->soup.position.count ? kit_soup_objects(&o->soup, &o->from)
                                  : kit_soup_empty(joined ? 0 : vertices, &o->from);
}

static void obj_free(obj *o)
{
    kit_soup_free(&o->soup);
    for (size_t i = 0; i < o->texts.count; ++i) free(((char **)o->texts.data)[i]);
    free(o->texts.data);
    free(o->materials.data);
    free(o->lines.data);
    free(o->normals.data);
    free(o->corners.data);
}

/* Returns all lines, with moved vertices, and MTL files by full paths, because they are in the OBJ's folder. */
static char *text_of(const obj *o, size_t room)
{
    const char *const slash = strrchr(o->from.path, '/');
    const float *v = o->soup.vertices.data;
    char *const text = malloc(room), *to = text, *rest;
    float were[3];
    for (size_t i = 0; text && i < o->own_lines; ++i) {
        char *const line = ((char **)o->lines.data)[i];
        if ((rest = behind(line, "v")) != NULL && (rest = floats(o, were, 3, rest, "", NULL)) != NULL) {
            to += sprintf(to, "v %.9g %.9g %.9g %s\n", (double)v[0], (double)v[1], (double)v[2], rest);
            v += 3;
        } else if (slash && (rest = behind(line, "mtllib")) != NULL && *rest != '/') {
            to += sprintf(to, "mtllib %.*s/%s\n", (int)(slash - o->from.path), o->from.path, rest);
        } else to += sprintf(to, "%s\n", line);
    }
    return text;
}

char *kit_obj_moved(double origin[3], const char *path)
{
    enum { NUMBERS = 64 }; /* bytes for three numbers */

    obj o = { .from = { path, 0, NULL }, .bare = 1 };
    char *text, *moved = NULL;
    size_t size;
    if (kit_file_read(&text, &size, path, NULL)) return NULL;
    int failed = split(&o, text);
    o.own_lines = o.lines.count;
    failed = failed || read_vertices(&o) || move_origin(&o);
    memcpy(origin, o.soup.origin, sizeof o.soup.origin);
    if (!failed && (origin[0] != 0 || origin[1] != 0 || origin[2] != 0))
        moved = text_of(&o, size + o.own_lines + NUMBERS * (o.soup.vertices.count / 3 + 1)
                                + (size_t)o.bare * strlen(path));
    obj_free(&o);
    free(text);
    return moved;
}

int kit_mesh_obj(kit_mesh *mesh, kit_object **object, int *objects, const char *path, kit_error *err)
{
    obj o = { .from = { path, 0, err } };
    char *text;
    size_t size;
    if (kit_file_read(&text, &size, path, err)) return -1;
    int failed = split(&o, text);
    o.own_lines = o.lines.count;
    failed = failed || read_vertices(&o) || move_origin(&o) || read_faces(&o);
    if (!failed) kit_soup_take(&o.soup, mesh, object, objects);
    obj_free(&o);
    free(text);
    return failed ? -1 : 0;
}
