/* scene.c - scenes by name, built in code, or from an OBJ file with a camera that frames it. Declared in kit.h. */
#include "kit.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/* ---- >>build: triangles, boxes, curved patches; all in local coordinates that at and turn place in the world ---- */

typedef struct build {
    kit_scene scene;
    size_t   capacity;                     /* triangles */
    uint32_t object;                       /* number of the one being built */
    int      failed;                       /* out of memory */
    double   at[3], turn, tilt;            /* turned by tilt degrees about x, then by turn about y, then moved by at */
    float    albedo[3];
    uint32_t random;
} build;

static void colour(build *b, double r, double g, double blue)
{
    b->albedo[0] = (float)r; b->albedo[1] = (float)g; b->albedo[2] = (float)blue;
}

static void place(build *b, double x, double y, double z, double turn)
{
    b->at[0] = x; b->at[1] = y; b->at[2] = z; b->turn = turn; b->tilt = 0;
}

static void place_tilted(build *b, double x, double y, double z, double turn, double tilt)
{
    place(b, x, y, z, turn);
    b->tilt = tilt;
}

/* [0, 1), the same on every machine (PCG hash) */
static double chance(build *b)
{
    uint32_t x = b->random = b->random * 747796405u + 2891336453u;
    x = ((x >> ((x >> 28) + 4)) ^ x) * 277803737u;
    return (double)((x >> 22) ^ x) * 0x1p-32;
}

static double between(build *b, double low, double high) { return low + (high - low) * chance(b); }

static void cross(const double a[3], const double b[3], double out[3])
{
    for (int i = 0; i < 3; i++) out[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
}

static double dot(const double a[3], const double b[3]) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void unit(double v[3])
{
    double length = sqrt(dot(v, v));
    for (int i = 0; i < 3; i++) v[i] = length > 0 ? v[i] / length : 0;
}

typedef struct vertex { double p[3], n[3]; } vertex;

static int grow(build *b)
{
    kit_mesh *m = &b->scene.mesh;
    size_t capacity = b->capacity ? 2 * b->capacity : 4096;
    float *position, *normal, *albedo;
    uint32_t *object;
    if ((position = realloc(m->position, capacity * 9 * sizeof *position)) != NULL) m->position = position;
    if ((normal   = realloc(m->normal,   capacity * 9 * sizeof *normal)) != NULL)   m->normal = normal;
    if ((albedo   = realloc(m->albedo,   capacity * 3 * sizeof *albedo)) != NULL)   m->albedo = albedo;
    if ((object   = realloc(m->object,   capacity * sizeof *object)) != NULL) {
        if (!m->object) memset(object, 0, m->triangles * sizeof *object);
        m->object = object;
    }
    if (!position || !normal || !albedo || !object) { b->failed = 1; return -1; }
    b->capacity = capacity;
    return 0;
}

static void rotate(const build *b, const double in[3], double out[3])
{
    const double c = cos(b->turn * PI / 180), s = sin(b->turn * PI / 180), ct = cos(b->tilt * PI / 180), st = sin(b->tilt * PI / 180);
    const double z = st * in[1] + ct * in[2];
    out[0] = c * in[0] + s * z;
    out[1] = ct * in[1] - st * in[2];
    out[2] = -s * in[0] + c * z;
}

/* Wound to agree with the vertices' normals; nothing when it has no area. */
static void triangle(build *b, const vertex *v0, const vertex *v1, const vertex *v2)
{
    kit_mesh *m = &b->scene.mesh;
    const vertex *v[3] = { v0, v1, v2 };
    double e1[3], e2[3], face[3], sum[3];
    float *position, *normal;
    for (int i = 0; i < 3; i++) {
        e1[i] = v1->p[i] - v0->p[i];
        e2[i] = v2->p[i] - v0->p[i];
        sum[i] = v0->n[i] + v1->n[i] + v2->n[i];
    }
    cross(e1, e2, face);
    if (!(dot(face, face) > 1e-20) || b->failed) return;
    if (m->triangles == b->capacity && grow(b)) return;
    if (dot(face, sum) < 0) { v[1] = v2; v[2] = v1; }
    position = m->position + 9 * m->triangles;
    normal   = m->normal + 9 * m->triangles;
    for (int k = 0; k < 3; k++, position += 3, normal += 3) {
        double p[3], n[3];
        rotate(b, v[k]->p, p);
        rotate(b, v[k]->n, n);
        for (int i = 0; i < 3; i++) {
            position[i] = (float)(b->at[i] + p[i]);
            normal[i] = (float)n[i];
        }
    }
    memcpy(m->albedo + 3 * m->triangles, b->albedo, sizeof b->albedo);
    m->object[m->triangles++] = b->object;
}

/* flat, its front where the corners run counter-clockwise */
static void quad(build *b, const double corner[4][3])
{
    vertex v[4];
    double d1[3], d2[3], n[3];
    for (int i = 0; i < 3; i++) {
        d1[i] = corner[2][i] - corner[0][i];
        d2[i] = corner[3][i] - corner[1][i];
    }
    cross(d1, d2, n);
    unit(n);
    for (int k = 0; k < 4; k++) {
        memcpy(v[k].p, corner[k], sizeof v[k].p);
        memcpy(v[k].n, n, sizeof n);
    }
    triangle(b, &v[0], &v[1], &v[2]);
    triangle(b, &v[0], &v[2], &v[3]);
}

static void box(build *b, double x0, double y0, double z0, double x1, double y1, double z1)
{
    const double c[6][4][3] = {
        {{x0,y0,z0},{x0,y0,z1},{x0,y1,z1},{x0,y1,z0}}, {{x1,y0,z1},{x1,y0,z0},{x1,y1,z0},{x1,y1,z1}},
        {{x0,y0,z0},{x1,y0,z0},{x1,y0,z1},{x0,y0,z1}}, {{x0,y1,z1},{x1,y1,z1},{x1,y1,z0},{x0,y1,z0}},
        {{x1,y0,z0},{x0,y0,z0},{x0,y1,z0},{x1,y1,z0}}, {{x0,y0,z1},{x1,y0,z1},{x1,y1,z1},{x0,y1,z1}} };
    for (int i = 0; i < 6; i++) quad(b, c[i]);
}

/* horizontal rectangle, seen from above */
static void level(build *b, double x0, double z0, double x1, double z1, double y)
{
    const double c[4][3] = { {x0,y,z1}, {x1,y,z1}, {x1,y,z0}, {x0,y,z0} };
    quad(b, c);
}

/* a surface over u, v in [0, 1], with its own normals, as nu x nv cells */
static void patch(build *b, int nu, int nv, void (*surface)(const void *shape, double u, double v, vertex *out), const void *shape)
{
    for (int j = 0; j < nv; j++)
        for (int i = 0; i < nu; i++) {
            vertex c[4];
            surface(shape, (double)i / nu, (double)j / nv, &c[0]);
            surface(shape, (double)(i + 1) / nu, (double)j / nv, &c[1]);
            surface(shape, (double)(i + 1) / nu, (double)(j + 1) / nv, &c[2]);
            surface(shape, (double)i / nu, (double)(j + 1) / nv, &c[3]);
            triangle(b, &c[0], &c[1], &c[2]);
            triangle(b, &c[0], &c[2], &c[3]);
        }
}

/* sphere of radius shape[0] about the origin */
static void sphere_surface(const void *shape, double u, double v, vertex *out)
{
    const double radius = *(const double *)shape, y = v >= 1 ? 1 : -cos(PI * v), r = v >= 1 ? 0 : sin(PI * v), a = 2 * PI * fmod(u, 1);
    out->n[0] = r * cos(a); out->n[1] = y; out->n[2] = r * sin(a);
    for (int i = 0; i < 3; i++) out->p[i] = radius * out->n[i];
}

/* lying ring: shape[0] to the middle of the tube, shape[1] the tube */
static void torus_surface(const void *shape, double u, double v, vertex *out)
{
    const double *r = shape, a = 2 * PI * fmod(u, 1), t = 2 * PI * fmod(v, 1);
    out->n[0] = cos(t) * cos(a); out->n[1] = sin(t); out->n[2] = cos(t) * sin(a);
    out->p[0] = (r[0] + r[1] * cos(t)) * cos(a); out->p[1] = r[1] * sin(t); out->p[2] = (r[0] + r[1] * cos(t)) * sin(a);
}

/* One moulding of a turned profile, from (r0, y0) upwards to (r1, y1), swelling outwards by bulge in its middle. */
typedef struct moulding { double r0, y0, r1, y1, bulge; } moulding;

static void moulding_surface(const void *shape, double u, double v, vertex *out)
{
    const moulding *m = shape;
    const double dr = m->r1 - m->r0, dy = m->y1 - m->y0, length = sqrt(dr * dr + dy * dy), a = 2 * PI * fmod(u, 1);
    const double swell = 4 * v * (1 - v) * m->bulge / length, slope = 4 * (1 - 2 * v) * m->bulge / length;
    const double r = m->r0 + v * dr + swell * dy, y = m->y0 + v * dy - swell * dr;
    const double tr = dr + slope * dy, ty = dy - slope * dr, t = sqrt(tr * tr + ty * ty);
    out->p[0] = r * cos(a); out->p[1] = y; out->p[2] = r * sin(a);
    out->n[0] = ty / t * cos(a); out->n[1] = -tr / t; out->n[2] = ty / t * sin(a);
}

static void turned(build *b, const moulding *profile, int count, int around)
{
    for (int i = 0; i < count; i++)
        patch(b, around, profile[i].bulge < 0 || profile[i].bulge > 0 ? 8 : 1, moulding_surface, &profile[i]);
}

/* closed, standing on y = 0 */
static void cylinder(build *b, double radius, double height, int around)
{
    const moulding profile[] = { {0, 0, radius, 0, 0}, {radius, 0, radius, height, 0}, {radius, height, 0, height, 0} };
    turned(b, profile, 3, around);
}

/* ---- >>objects ---------------------------------------------------------------------------------------------- */

/* What comes now is a new object; the first one has all that came before, too. casts -1: to be judged. */
static void object(build *b, const char *name, int casts)
{
    kit_scene *s = &b->scene;
    kit_object *more = realloc(s->object, ((size_t)s->objects + 1) * sizeof *more);
    if (!more) { b->failed = 1; return; }
    s->object = more;
    more += s->objects;
    memset(more, 0, sizeof *more);
    snprintf(more->name, sizeof more->name, "%s", name);
    more->first = s->objects ? s->mesh.triangles : 0;
    more->shape = -1;
    more->casts = casts;
    b->object = (uint32_t)++s->objects;
}

static void bounds(kit_mesh *mesh)
{
    for (size_t i = 0; i < 3 * mesh->triangles; i++)
        for (int c = 0; c < 3; c++) {
            float p = mesh->position[3 * i + (size_t)c];
            if (!i || p < mesh->lower[c]) mesh->lower[c] = p;
            if (!i || p > mesh->upper[c]) mesh->upper[c] = p;
        }
}

/* where object k's triangle after t is, in the scene's mesh; from t = o->first - 1 */
static size_t next_triangle(const kit_scene *s, int k, size_t t)
{
    while (s->mesh.object[++t] != (uint32_t)k + 1) {}
    return t;
}

/* Writes object k's triangles and bounds; the mesh's bounds are left. */
static void set_place(kit_scene *s, int k, const float m[16])
{
    kit_object *o = &s->object[k];
    const kit_mesh *shape = &s->shape[o->shape];
    const double scale = sqrt((double)m[0] * (double)m[0] + (double)m[1] * (double)m[1] + (double)m[2] * (double)m[2]);
    for (size_t from = 0, t = o->first - 1; from < 3 * shape->triangles; from++) {
        if (from % 3 == 0) t = next_triangle(s, k, t);
        float *position = s->mesh.position + 9 * t + from % 3 * 3, *normal = s->mesh.normal + 9 * t + from % 3 * 3;
        for (int i = 0; i < 3; i++) {
            double p = (double)m[12 + i], n = 0;
            for (int j = 0; j < 3; j++) {
                p += (double)m[4 * j + i] * (double)shape->position[3 * from + (size_t)j];
                n += (double)m[4 * j + i] * (double)shape->normal[3 * from + (size_t)j];
            }
            position[i] = (float)p;
            normal[i] = (float)(n / scale);
            if (!from || position[i] < o->lower[i]) o->lower[i] = position[i];
            if (!from || position[i] > o->upper[i]) o->upper[i] = position[i];
        }
    }
    memcpy(o->to_world, m, sizeof o->to_world);
}

/* Makes object k's triangles, as they are, a shape of its own. */
static int own_shape(kit_scene *s, int k)
{
    static const float identity[16] = { 1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1 };
    kit_object *o = &s->object[k];
    kit_mesh shape, *more = realloc(s->shape, ((size_t)s->shapes + 1) * sizeof *more);
    memset(&shape, 0, sizeof shape);
    if (more) s->shape = more;
    for (size_t t = o->first; t < s->mesh.triangles; t++) shape.triangles += s->mesh.object[t] == (uint32_t)k + 1;
    shape.position = malloc(shape.triangles * 9 * sizeof *shape.position + 1);
    shape.normal = malloc(shape.triangles * 9 * sizeof *shape.normal + 1);
    if (!more || !shape.position || !shape.normal) {
        kit_mesh_free(&shape);
        return -1;
    }
    for (size_t i = 0, t = o->first - 1; i < shape.triangles; i++) {
        t = next_triangle(s, k, t);
        memcpy(shape.position + 9 * i, s->mesh.position + 9 * t, 9 * sizeof *shape.position);
        memcpy(shape.normal + 9 * i, s->mesh.normal + 9 * t, 9 * sizeof *shape.normal);
    }
    bounds(&shape);
    s->shape[s->shapes] = shape;
    o->shape = s->shapes++;
    set_place(s, k, identity);
    return 0;
}

static int holds(const kit_object *a, const kit_object *b)
{
    for (int i = 0; i < 3; i++)
        if (a->lower[i] > b->lower[i] || a->upper[i] < b->upper[i]) return 0;
    return 1;
}

/* most of the others are within its bounds */
static int holds_most(const kit_scene *s, int k)
{
    int held = 0;
    for (int i = 0; i < s->objects; i++) held += i != k && holds(&s->object[k], &s->object[i]);
    return 2 * held > s->objects - 1;
}

/* whether object k casts, by kit_scene_load's rule, and whether what holds it still does */
static void judge(kit_scene *s, int k)
{
    kit_object *o = &s->object[k];
    float side[3], least, most;
    for (int i = 0; i < 3; i++) side[i] = o->upper[i] - o->lower[i];
    least = fminf(side[0], fminf(side[1], side[2]));
    most = fmaxf(side[0], fmaxf(side[1], side[2]));
    o->casts = !(least < 1e-3f * most) && !holds_most(s, k);
    for (int i = 0; i < s->objects; i++)
        if (i != k && holds(&s->object[i], o) && holds_most(s, i)) s->object[i].casts = 0;
}

/* Completes what has been built: the objects' shapes and bounds, from number first on, whether they cast, and the mesh's bounds. */
static int complete(kit_scene *s, int first)
{
    for (int k = first; k < s->objects; k++)
        if (s->object[k].shape < 0 && own_shape(s, k)) return -1;
    for (int k = first; k < s->objects; k++)
        if (s->object[k].casts < 0) judge(s, k);
    bounds(&s->mesh);
    return 0;
}

/* ---- >>shapes of closed form; big planes are cut finer towards the origin, for a rasteriser's sake ----------- */

enum { FAR = 200 };                        /* metres: where the big planes end */
static const double whole[]   = { 0, 1 };
static const double outward[] = { 0, 0.0025, 0.01, 0.03, 0.1, 0.3, 1 };
static const double both[]    = { 0, 0.35, 0.45, 0.485, 0.495, 0.49875, 0.50125, 0.505, 0.515, 0.55, 0.65, 1 };
#define CUTS(a) a, (int)(sizeof a / sizeof *a) - 1

/* a flat quad from corner 0 (u = v = 0) by corner 1 (u = 1) to corner 2 (u = v = 1), cut at the given u and v */
static void sheet(build *b, const double c[4][3], const double *u, int nu, const double *v, int nv)
{
    static const int du[4] = { 0, 1, 1, 0 }, dv[4] = { 0, 0, 1, 1 };
    for (int j = 0; j < nv; j++)
        for (int i = 0; i < nu; i++) {
            double q[4][3];
            for (int k = 0; k < 4; k++)
                for (int x = 0; x < 3; x++) {
                    double s = u[i + du[k]], t = v[j + dv[k]];
                    q[k][x] = (1 - t) * ((1 - s) * c[0][x] + s * c[1][x]) + t * ((1 - s) * c[3][x] + s * c[2][x]);
                }
            quad(b, (const double (*)[3])q);
        }
}

static void build_plane(build *b)
{
    static const double floor_[4][3] = { {-FAR, 0, FAR}, {FAR, 0, FAR}, {FAR, 0, -FAR}, {-FAR, 0, -FAR} };
    sheet(b, floor_, CUTS(both), CUTS(both));
}

static void build_corner(build *b)
{
    static const double floor_[4][3] = { {0, 0, FAR}, {FAR, 0, FAR}, {FAR, 0, -FAR}, {0, 0, -FAR} };
    static const double wall[4][3]   = { {0, 0, FAR}, {0, 0, -FAR}, {0, FAR, -FAR}, {0, FAR, FAR} };
    sheet(b, floor_, CUTS(outward), CUTS(both));
    sheet(b, wall, CUTS(both), CUTS(outward));
}

static void build_groove(build *b)
{
    static const double left[4][3]  = { {-0.5, 0, -FAR}, {-FAR, 0, -FAR}, {-FAR, 0, FAR}, {-0.5, 0, FAR} };
    static const double right[4][3] = { {0.5, 0, FAR}, {FAR, 0, FAR}, {FAR, 0, -FAR}, {0.5, 0, -FAR} };
    static const double deep[3][4][3] = { { {-0.5, -1, FAR}, {0.5, -1, FAR}, {0.5, -1, -FAR}, {-0.5, -1, -FAR} },
                                          { {-0.5, 0, FAR}, {-0.5, -1, FAR}, {-0.5, -1, -FAR}, {-0.5, 0, -FAR} },
                                          { {0.5, -1, FAR}, {0.5, 0, FAR}, {0.5, 0, -FAR}, {0.5, -1, -FAR} } };
    sheet(b, left, CUTS(outward), CUTS(both));
    sheet(b, right, CUTS(outward), CUTS(both));
    for (int i = 0; i < 3; i++) sheet(b, deep[i], CUTS(whole), CUTS(both));
}

static void build_sphere(build *b)
{
    static const double radius = 1;
    object(b, "plane", 0);
    build_plane(b);
    place(b, 0, 1, 0, 0);
    object(b, "ball", 1);
    patch(b, 256, 128, sphere_surface, &radius);
}

static void build_hole(build *b)
{
    static const double top[4][3]  = { {-0.5, 0, 0.5}, {-FAR, 0, FAR}, {FAR, 0, FAR}, {0.5, 0, 0.5} };
    static const double wall[4][3] = { {-0.5, 0, 0.5}, {0.5, 0, 0.5}, {0.5, -1, 0.5}, {-0.5, -1, 0.5} };
    level(b, -0.5, -0.5, 0.5, 0.5, -1);
    for (int i = 0; i < 4; i++) {
        place(b, 0, 0, 0, 90 * i);
        sheet(b, top, CUTS(outward), CUTS(whole));
        quad(b, wall);
    }
}

/* ---- >>room ------------------------------------------------------------------------------------------------- */

static void build_room(build *b)
{
    static const double walls[2][4][3] = { {{0,0,6},{0,0,0},{0,2.8,0},{0,2.8,6}}, {{0,0,0},{6,0,0},{6,2.8,0},{0,2.8,0}} };
    static const double ceiling[4][3] = { {0,2.8,0}, {6,2.8,0}, {6,2.8,6}, {0,2.8,6} };
    static const moulding shade[] = { {0.24, 0, 0.08, 0.22, 0.01}, {0.08, 0.22, 0, 0.22, 0} };
    static const moulding vase[] = { {0, 0, 0.07, 0, 0}, {0.07, 0, 0.05, 0.2, 0.06}, {0.05, 0.2, 0.065, 0.26, -0.012}, {0.065, 0.26, 0, 0.255, 0} };
    static const double ball = 0.28, globe = 0.09, ring[2] = { 0.16, 0.05 };
    colour(b, 0.62, 0.52, 0.42); level(b, 0, 0, 6, 6, 0);
    colour(b, 0.66, 0.24, 0.18); quad(b, walls[0]);
    colour(b, 0.30, 0.50, 0.34); quad(b, walls[1]);
    colour(b, 0.85, 0.85, 0.83); quad(b, ceiling);
    box(b, 0, 0, 0.02, 0.02, 0.1, 6); box(b, 0, 0, 0, 6, 0.1, 0.02);                                  /* skirting */
    box(b, 0, 2.68, 0.1, 0.06, 2.8, 6); box(b, 0, 2.68, 0, 6, 2.8, 0.06); box(b, 0, 2.74, 0.1, 0.12, 2.8, 6); box(b, 0, 2.74, 0, 6, 2.8, 0.12);

    colour(b, 0.55, 0.38, 0.22);                                                                      /* bookcase */
    for (int i = 0; i < 3; i++) box(b, 1.3 + 0.8 * i, 0, 0.02, 1.33 + 0.8 * i, 1.95, 0.3);
    for (int i = 0; i < 6; i++) box(b, 1.33, 0.08 + 0.37 * i, 0.02, 2.9, 0.1 + 0.37 * i, 0.3);
    for (int i = 0; i < 5; i++)
        for (double x = 1.335, width; x < 2.86; x += width + 0.001) {
            double height = between(b, 0.2, 0.33), depth = between(b, 0.2, 0.27), lean = chance(b), tone = between(b, 0.2, 0.7);
            double green = tone * between(b, 0.4, 1.0), blue = tone * between(b, 0.3, 0.9);
            width = between(b, 0.018, 0.06);
            if (lean < 0.1) { width = between(b, 0.1, 0.25); continue; }                              /* a gap */
            if (x < 2.13 && x + width > 2.099) { x = 2.131; width = 0; continue; }                    /* the middle board */
            if (x + width > 2.899) break;
            colour(b, tone, green, blue);
            box(b, x, 0.1 + 0.37 * i, 0.03, x + width, 0.1 + 0.37 * i + height, 0.03 + depth);
        }

    colour(b, 0.80, 0.80, 0.78);                                                                      /* radiator, picture */
    for (int i = 0; i < 14; i++) box(b, 0.06, 0.15, 1.2 + 0.07 * i, 0.16, 0.75, 1.25 + 0.07 * i);
    box(b, 0.09, 0.2, 1.2, 0.13, 0.24, 2.16); box(b, 0.09, 0.66, 1.2, 0.13, 0.7, 2.16);
    colour(b, 0.25, 0.17, 0.10);
    box(b, 0, 1.3, 1.2, 0.04, 1.35, 2.2); box(b, 0, 2.0, 1.2, 0.04, 2.05, 2.2); box(b, 0, 1.35, 1.2, 0.04, 2.0, 1.25); box(b, 0, 1.35, 2.15, 0.04, 2.0, 2.2);
    colour(b, 0.75, 0.70, 0.55); box(b, 0, 1.35, 1.25, 0.01, 2.0, 2.15);

    colour(b, 0.70, 0.62, 0.48);                                                                      /* boxes in the corner */
    place(b, 0.55, 0, 0.55, 8);    box(b, -0.38, 0, -0.35, 0.38, 0.7, 0.35);
    place(b, 0.5, 0.7, 0.5, -17);  box(b, -0.25, 0, -0.22, 0.25, 0.42, 0.22);
    place(b, 0.55, 1.12, 0.52, 31); box(b, -0.13, 0, -0.13, 0.13, 0.22, 0.13);
    colour(b, 0.25, 0.35, 0.60);
    place(b, 1.35, 0, 0.75, -24);  box(b, -0.17, 0, -0.14, 0.17, 0.24, 0.14);

    colour(b, 0.45, 0.12, 0.14);                                                                      /* rug, table */
    place(b, 2.0, 0, 2.0, 22);     box(b, -1.2, 0, -0.85, 1.2, 0.012, 0.85);
    colour(b, 0.60, 0.42, 0.25);
    box(b, -0.75, 0.71, -0.42, 0.75, 0.75, 0.42);
    box(b, -0.66, 0.62, -0.34, 0.66, 0.71, -0.32); box(b, -0.66, 0.62, 0.32, 0.66, 0.71, 0.34);
    box(b, -0.67, 0.62, -0.34, -0.65, 0.71, 0.34); box(b, 0.65, 0.62, -0.34, 0.67, 0.71, 0.34);
    for (int i = 0; i < 4; i++) {
        double x = i & 1 ? 0.66 : -0.66, z = i & 2 ? 0.33 : -0.33;
        box(b, x - 0.03, 0.012, z - 0.03, x + 0.03, 0.71, z + 0.03);
    }
    colour(b, 0.75, 0.72, 0.66); place(b, 2.05, 0.80, 1.72, 0);  patch(b, 96, 48, torus_surface, ring);
    colour(b, 0.80, 0.55, 0.20); place(b, 2.36, 0.84, 2.08, 0);  patch(b, 64, 32, sphere_surface, &globe);
    colour(b, 0.25, 0.45, 0.55); place(b, 1.60, 0.75, 1.92, 0);  turned(b, vase, 4, 64);
    colour(b, 0.20, 0.30, 0.45); place(b, 1.72, 0.75, 2.32, 40); box(b, -0.15, 0, -0.11, 0.15, 0.035, 0.11);
    colour(b, 0.55, 0.50, 0.40); place(b, 1.73, 0.785, 2.31, 58); box(b, -0.12, 0, -0.09, 0.12, 0.03, 0.09);
    colour(b, 0.70, 0.70, 0.72); place(b, 0.62, ball, 2.75, 0);  patch(b, 96, 48, sphere_surface, &ball);

    colour(b, 0.75, 0.70, 0.50);                                                                      /* lamp */
    place(b, 2.0, 1.75, 1.95, 0);  turned(b, shade, 2, 64); box(b, -0.006, 0.22, -0.006, 0.006, 1.05, 0.006);

    colour(b, 0.20, 0.20, 0.22);                                                                      /* railing */
    place(b, 3.75, 0, 1.35, -38);
    for (int i = -1; i <= 1; i++) box(b, 0.7 * i - 0.025, 0, -0.025, 0.7 * i + 0.025, 0.98, 0.025);
    for (int i = 1; i < 14; i++) if (i != 7) box(b, -0.7 + 0.1 * i - 0.008, 0.12, -0.008, -0.7 + 0.1 * i + 0.008, 0.84, 0.008);
    box(b, -0.7, 0.1, -0.012, 0.7, 0.13, 0.012); box(b, -0.7, 0.83, -0.012, 0.7, 0.86, 0.012); box(b, -0.76, 0.95, -0.04, 0.76, 0.99, 0.04);
}

/* ---- >>grass ------------------------------------------------------------------------------------------------ */

static double ground(double x, double z, double *dx, double *dz)
{
    *dx = 0.091 * cos(0.7 * x + 0.4) * cos(0.55 * z) + 0.0765 * cos(1.7 * x + 1.1 * z);
    *dz = -0.0715 * sin(0.7 * x + 0.4) * sin(0.55 * z) + 0.0495 * cos(1.7 * x + 1.1 * z);
    return 0.13 * sin(0.7 * x + 0.4) * cos(0.55 * z) + 0.045 * sin(1.7 * x + 1.1 * z);
}

static void ground_surface(const void *shape, double u, double v, vertex *out)
{
    double dx, dz;
    (void)shape;
    out->p[0] = 40 * u - 20; out->p[2] = 26 * v - 20;
    out->p[1] = ground(out->p[0], out->p[2], &dx, &dz);
    out->n[0] = -dx; out->n[1] = 1; out->n[2] = -dz;
    unit(out->n);
}

/* a blade of length, width, bent by bend radians in all from a start lean, in the plane of z and y */
static void blade_surface(const void *shape, double u, double v, vertex *out)
{
    const double *s = shape, length = s[0], bend = s[2] + 1e-3, lean = s[3], a = lean + bend * v;
    out->p[0] = s[1] * (u - 0.5) * (1 - v * v);
    out->p[1] = length * (sin(a) - sin(lean)) / bend;                    /* a circular arc */
    out->p[2] = length * (cos(lean) - cos(a)) / bend;
    out->n[0] = 0; out->n[1] = -sin(a); out->n[2] = cos(a);
}

/* how far the stone's skin is from p, in units of the direction's radius: 0 on it */
static double stone(const double *seed, const double p[3])
{
    double q[3] = { p[0] / 1.2, p[1] / 0.75, p[2] };
    double length = sqrt(dot(q, q)), x = q[0] / length, y = q[1] / length, z = q[2] / length, s = seed[1];
    return length - 1 - 0.10 * sin(3 * x + s) * cos(2.5 * z - s) - 0.07 * sin(5 * y + 4 * x + 2 * s) - 0.03 * sin(9 * z + 7 * x - s) * cos(8 * y);
}

static void stone_surface(const void *shape, double u, double v, vertex *out)
{
    const double *seed = shape;
    double d[3], k;
    vertex s;
    sphere_surface(seed, u, v, &s);
    for (int i = 0; i < 3; i++) d[i] = s.n[i] * (i == 0 ? 1.2 : i == 1 ? 0.75 : 1);
    k = 1 - stone(seed, d);                                              /* the skin is at d * k: stone() is affine along d */
    for (int i = 0; i < 3; i++) {
        double a[3] = { d[0] * k, d[1] * k, d[2] * k }, c[3];
        memcpy(c, a, sizeof c);
        a[i] -= 1e-4; c[i] += 1e-4;
        out->p[i] = seed[0] * d[i] * k;
        out->n[i] = stone(seed, c) - stone(seed, a);
    }
    unit(out->n);
}

static void build_grass(build *b)
{
    static const double stones[][4] = { {-0.75, 0.7, 0.24, 1}, {-0.4, 0.95, 0.10, 4}, {1.15, -0.6, 0.34, 2.2}, {1.75, -0.2, 0.15, 0.3}, {-2.2, -3.6, 0.6, 5} };
    double dx, dz;
    colour(b, 0.22, 0.21, 0.09);
    patch(b, 160, 104, ground_surface, NULL);
    for (int i = 0; i < 5; i++) {
        const double *s = stones[i], shape[2] = { s[2], s[3] };
        colour(b, 0.50, 0.48, 0.45);
        place(b, s[0], ground(s[0], s[1], &dx, &dz) + 0.3 * s[2], s[1], 70 * i);
        patch(b, 96, 48, stone_surface, shape);
    }
    for (int i = 0; i < 20000; i++) {                                    /* as many to each ring of distances: even on the picture */
        double distance = 0.9 * pow(18, chance(b)), angle = between(b, -0.85, 0.85), x = distance * sin(angle), z = 3 - distance * cos(angle);
        double length = between(b, 0.12, 0.34), width = between(b, 0.008, 0.016), bend = between(b, 0.3, 1.6), lean = between(b, 0, 0.25);
        double shape[4] = { length, width, bend, lean };
        double turn = between(b, 0, 360), green = between(b, 0.7, 1.2), dry = chance(b), inside = 0;
        for (int k = 0; k < 5; k++) {
            double ox = x - stones[k][0], oz = z - stones[k][1];
            inside += sqrt(ox * ox + oz * oz) < 0.9 * stones[k][2];
        }
        if (inside > 0) continue;
        colour(b, green * (0.16 + 0.16 * dry * dry), green * 0.32, green * 0.07);
        place(b, x, ground(x, z, &dx, &dz) - 0.01, z, turn);
        patch(b, 1, 5, blade_surface, shape);
    }
}

/* ---- >>colonnade -------------------------------------------------------------------------------------------- */

static void soffit_surface(const void *shape, double u, double v, vertex *out)
{
    const double *s = shape, a = PI * u;                                 /* radius, spring height, half thickness */
    out->p[0] = s[2] * (2 * v - 1); out->p[1] = s[1] + s[0] * sin(a); out->p[2] = s[0] * cos(a);
    out->n[0] = 0; out->n[1] = -sin(a); out->n[2] = -cos(a);
}

/* a wall along z, thickness 2 t, from the springing to the top, with a round arch between two columns half bays away */
static void arch(build *b, double radius, double spring, double top, double t, double half_bay)
{
    const double shape[3] = { radius, spring, t };
    enum { PIECES = 32 };
    patch(b, PIECES, 1, soffit_surface, shape);
    for (int side = -1; side <= 1; side += 2) {
        double z0 = side * radius, z1 = side * half_bay;
        box(b, -t, spring, z0 < z1 ? z0 : z1, t, top, z0 < z1 ? z1 : z0);
        for (int i = 0; i < PIECES; i++) {
            double a = PI * i / PIECES, c = PI * (i + 1) / PIECES, x = side * t;
            double q[4][3] = { {x, spring + radius * sin(a), radius * cos(a)}, {x, spring + radius * sin(c), radius * cos(c)},
                               {x, top, radius * cos(c)}, {x, top, radius * cos(a)} };
            if (side > 0) {                                              /* turn it to face outwards */
                double swap[3];
                memcpy(swap, q[1], sizeof swap); memcpy(q[1], q[3], sizeof swap); memcpy(q[3], swap, sizeof swap);
            }
            quad(b, (const double (*)[3])q);
        }
    }
}

static void column(build *b)
{
    static const moulding profile[] = {
        { 0.34, 0.10, 0.34, 0.20,  0.05 }, { 0.34, 0.20, 0.31, 0.20, 0 }, { 0.31, 0.20, 0.29, 0.27, -0.02 }, { 0.29, 0.27, 0.30, 0.27, 0 },
        { 0.30, 0.27, 0.30, 0.33,  0.03 }, { 0.30, 0.33, 0.25, 0.33, 0 }, { 0.25, 0.33, 0.21, 2.60, 0.015 },
        { 0.21, 2.60, 0.21, 2.65,  0.025 }, { 0.21, 2.65, 0.21, 2.74, 0 }, { 0.21, 2.74, 0.24, 2.74, 0 }, { 0.24, 2.74, 0.34, 2.88, 0.035 } };
    box(b, -0.40, 0, -0.40, 0.40, 0.10, 0.40);
    turned(b, profile, (int)(sizeof profile / sizeof *profile), 64);
    box(b, -0.38, 2.88, -0.38, 0.38, 3.0, 0.38);
}

static void build_colonnade(build *b)
{
    enum { BAYS = 8 };
    const double bay = 2.6, first = 5.2, end = first - bay * BAYS, wall[4][3] = { {-4.4,0,6}, {-4.4,0,end}, {-4.4,4.9,end}, {-4.4,4.9,6} };
    const double back[4][3] = { {-4.4,0,end}, {2.3,0,end}, {2.3,4.9,end}, {-4.4,4.9,end} };
    colour(b, 0.72, 0.70, 0.64);
    level(b, -4.4, end, 2.3, 6, 0);
    for (int i = 0; i < 4; i++) box(b, 2.3, -0.16 * (i + 1) - 0.02, end, 2.3 + 0.34 * (i + 1), -0.16 * i - (i ? 0 : 1e-3), 6);   /* steps, outside */
    for (int i = 0; i < 3; i++) box(b, -1.33, 0.15 * i, end, 1.33, 0.15 * i + 0.15, end + 3.2 - 0.34 * i);                          /* and inside */
    colour(b, 0.42, 0.45, 0.36); level(b, 2.3, -40, 60, 40, -0.64);
    colour(b, 0.70, 0.58, 0.46); quad(b, wall); quad(b, back);
    for (int i = 0; i <= BAYS; i++)
        for (int row = -1; row <= 1; row += 2) {
            colour(b, 0.78, 0.74, 0.66); place(b, 1.75 * row, 0, first - bay * i, 0); column(b);
            colour(b, 0.76, 0.68, 0.58); place(b, 1.75 * row, 0, first - bay * i - bay / 2, 0);
            if (i < BAYS) arch(b, bay / 2 - 0.3, 3.0, 4.9, 0.28, bay / 2);
        }
    place(b, 0, 0, 0, 0);
    colour(b, 0.80, 0.77, 0.70); box(b, -4.4, 4.9, end, 2.03, 5.1, 6);                                /* ceiling: slab, ribs in two steps */
    for (int step = 0; step < 2; step++) {
        const double half = step ? 0.22 : 0.13, y = step ? 4.75 : 4.55;
        for (int i = 0; i <= 2 * BAYS; i++) box(b, -1.47, y, first - bay / 2 * i - half, 1.47, 4.9, first - bay / 2 * i + half);
        for (int i = -1; i <= 1; i++) box(b, 0.98 * i - half + 0.02, y + 0.01, end, 0.98 * i + half - 0.02, 4.9, 6);
    }
    for (int i = 0; i < BAYS; i++) {                                                                  /* pilasters and a bench on the wall */
        place(b, -4.4, 0, first - bay * i, 0);
        colour(b, 0.76, 0.70, 0.60); box(b, 0, 0, -0.3, 0.15, 4.9, 0.3);
        colour(b, 0.60, 0.58, 0.54); box(b, 0, 0.40, -2.1, 0.4, 0.48, -0.5);
        box(b, 0, 0, -0.8, 0.35, 0.40, -0.65); box(b, 0, 0, -1.95, 0.35, 0.40, -1.8);
    }
}

/* ---- >>closed scenes: every solid is a closed two-manifold that touches no other, so depth peeling finds fronts and backs in pairs ---- */

static void build_cornell(build *b)
{
    const double gap = 0.003;
    colour(b, 0.73, 0.73, 0.73);
    object(b, "walls", 0);
    box(b, -2.98, -0.2, -5.79, 2.98, 0, 0); box(b, -2.98, 5.49, -5.79, 2.98, 5.69, 0);                /* floor, ceiling, back */
    box(b, -2.98, gap, -5.79, 2.98, 5.49 - gap, -5.59);
    object(b, "low box", 1);
    place(b, 0.925, gap, -1.69, -17);  box(b, -0.825, 0, -0.825, 0.825, 1.65, 0.825);
    object(b, "high box", 1);
    place(b, -0.905, gap, -3.51, 17);  box(b, -0.825, 0, -0.825, 0.825, 3.30, 0.825);
    b->object = 1;                                                       /* walls again */
    place(b, 0, 0, 0, 0);
    colour(b, 0.63, 0.06, 0.05); box(b, -2.98, gap, -5.59 + gap, -2.78, 5.49 - gap, 0);
    colour(b, 0.14, 0.45, 0.09); box(b, 2.78, gap, -5.59 + gap, 2.98, 5.49 - gap, 0);
}

static void build_columns(build *b)
{
    static const double hidden[4][3] = { {0.88, 0.16, 0.48}, {0.10, 0.24, 0.85}, {0.88, 0.70, 0.06}, {0, 0, 0} };   /* none behind the last */
    const double gap = 0.003;
    colour(b, 0.60, 0.60, 0.60);
    box(b, -7, -0.2, -1.7, 7, 0, 4); box(b, -7, gap, -1.7, 7, 4, -1.4);
    for (int i = 0; i < 4; i++) {
        const double x = 1.6 * i - 2.4;
        colour(b, 0.80, 0.80, 0.78);
        place(b, x, gap, 0, 0);
        if (i & 1) cylinder(b, 0.32, 2.2, 64);
        else box(b, -0.3, 0, -0.3, 0.3, 2.2, 0.3);
        colour(b, hidden[i][0], hidden[i][1], hidden[i][2]);
        place(b, 1.153 * x, gap, -0.95, 0);                              /* in line with the eye */
        if (i < 3) box(b, -0.27, 0, -0.28, 0.27, 1.9, 0.28);
    }
    place(b, 0, gap, 0, 0);
    colour(b, 0.10, 0.60, 0.16); box(b, -0.03, 0, -1.2, 0.03, 1.1, 0.2);                              /* a panel seen edge-on */
    colour(b, 0.88, 0.24, 0.04); place(b, 4.08, gap, -0.63, -28);                                     /* right of the picture */
    box(b, -0.32, 0, -0.32, 0.32, 1.4, 0.32);
}

static void build_plates(build *b)
{
    static const double lying[2] = { 0.5, 0.05 }, standing[2] = { 0.42, 0.035 };
    colour(b, 0.62, 0.60, 0.57); box(b, -7, -0.2, -7, 7, 0, 4);
    colour(b, 0.75, 0.72, 0.66);
    place(b, -0.65, 0.95, -0.35, 18);  box(b, -0.7, -0.015, -0.45, 0.7, 0.015, 0.45);
    place(b, 0.95, 0.28, 0.75, -12);   box(b, -0.42, -0.015, -0.32, 0.42, 0.015, 0.32);
    colour(b, 0.70, 0.26, 0.20); place(b, -0.75, 0.4, -0.2, 30);               box(b, -0.38, -0.012, -0.3, 0.38, 0.012, 0.3);
    colour(b, 0.24, 0.42, 0.66); place_tilted(b, 1.15, 0.75, -0.55, -35, 35);  box(b, -0.4, -0.012, -0.4, 0.4, 0.012, 0.4);
    colour(b, 0.30, 0.55, 0.28); place(b, -1.0, 0.12, 1.0, 35);                box(b, -0.45, 0, -0.012, 0.45, 0.5, 0.012);
    colour(b, 0.78, 0.62, 0.22); place(b, 0.2, 1.3, 0.15, -30);                box(b, -1.6, -0.03, -0.03, 1.6, 0.03, 0.03);
    place_tilted(b, 0.1, 0.42, 1.2, 80, 12);                                   box(b, -0.025, -0.025, -0.75, 0.025, 0.025, 0.75);
    colour(b, 0.68, 0.68, 0.70);
    place(b, 0.3, 0.55, 0.1, 0);                  patch(b, 96, 24, torus_surface, lying);
    place_tilted(b, -1.75, 0.5, 0.35, 50, 70);    patch(b, 96, 24, torus_surface, standing);
}

static void build_pebbles(build *b)
{
    static const double tables[2][6] = { {-0.25, -0.2, 24, 0.24, 0.15, 0.30}, {0.48, 0.22, -31, 0.11, 0.11, 0.17} };   /* x, z, turn, half sides, height */
    const double gap = 0.0005, cell = 0.1, leg = 0.007;
    colour(b, 0.60, 0.58, 0.55); box(b, -1.8, -0.1, -1.8, 1.8, 0, 1.8);
    for (int i = 0; i < 24 * 24; i++) {                                  /* one to a cell, and within it */
        double x = cell * (i % 24 - 11.5), z = cell * (i / 24 - 11.5), size = between(b, 0.01, 0.032), kind = chance(b), tone = between(b, 0.50, 0.72);
        double height = size * between(b, 0.3, 1.5), slack = cell / 2 - 1.42 * size, turn = between(b, 0, 360);
        int blocked = chance(b) < 0.2;
        x += slack * between(b, -1, 1); z += slack * between(b, -1, 1);
        for (int k = 0; k < 2; k++) {                                    /* a table's leg is here */
            const double *t = tables[k], c = cos(t[2] * PI / 180), s = sin(t[2] * PI / 180), dx = x - t[0], dz = z - t[1];
            blocked |= hypot(fabs(c * dx - s * dz) - t[3], fabs(s * dx + c * dz) - t[4]) < 1.42 * (size + leg);
        }
        if (blocked) continue;
        colour(b, tone, 0.97 * tone, 0.92 * tone);
        place(b, x, kind < 0.25 ? gap + size : gap, z, turn);
        if (kind < 0.25) patch(b, 24, 12, sphere_surface, &size);
        else if (kind < 0.55) cylinder(b, size, 0.6 * height, 20);
        else box(b, -size, 0, -0.7 * size, size, height, 0.7 * size);
    }
    colour(b, 0.56, 0.44, 0.33);
    for (int k = 0; k < 2; k++) {
        const double *t = tables[k], x = t[3], z = t[4], y = t[5];
        place(b, t[0], gap, t[1], t[2]);
        box(b, -x - 0.02, y + gap, -z - 0.02, x + 0.02, y + 0.02, z + 0.02);
        for (int i = -1; i <= 1; i += 2)
            for (int j = -1; j <= 1; j += 2) box(b, i * x - leg, 0, j * z - leg, i * x + leg, y, j * z + leg);
    }
}

static void build_boxes(build *b)
{
    const double gap = 0.0005;
    colour(b, 0.82, 0.82, 0.82);
    object(b, "floor", 0);
    box(b, -9, -0.2, -9, 9, 0, 5);
    for (int i = -1; i <= 1; i++) {
        object(b, "box", 1);
        place(b, 1.4 * i, gap, i ? 0.2 : -0.2, 0);
        box(b, -0.5, 0, -0.5, 0.5, i ? 0.8 : 1.1, 0.5);
    }
}

static void build_blocks(build *b)
{
    const double gap = 0.0005;
    colour(b, 0.82, 0.82, 0.82);
    object(b, "floor", 0);
    box(b, -12, -0.2, -12, 12, 0, 7);
    for (int i = 0; i < 12; i++) {
        const double wide = between(b, 0.26, 0.38), deep = between(b, 0.26, 0.38), high = between(b, 0.5, 2.2);
        object(b, "block", 1);
        place(b, 1.05 * (i % 4 - 1.5) + between(b, -0.1, 0.1), gap, 1.05 * (i / 4 - 1) + between(b, -0.1, 0.1), 0);
        box(b, -wide, 0, -deep, wide, high, deep);
    }
}

/* ---- >>casters: a few shapes of size 1, many times over ------------------------------------------------------- */

static const double GAP = 0.001;           /* between what rests and what it rests on */

static void make_cube(build *b) { box(b, -0.5, -0.5, -0.5, 0.5, 0.5, 0.5); }

static void make_ball(build *b)
{
    static const double radius = 0.5;
    patch(b, 48, 24, sphere_surface, &radius);
}

static void make_torus(build *b)
{
    static const double ring[2] = { 0.37, 0.13 };
    patch(b, 48, 20, torus_surface, ring);
}

static void make_cone(build *b)
{
    static const moulding profile[] = { {0, -0.5, 0.45, -0.5, 0}, {0.45, -0.5, 0, 0.5, 0} };
    turned(b, profile, 2, 48);
}

static void make_table(build *b)
{
    box(b, -0.6, 0.3, -0.4, 0.6, 0.36, 0.4);
    for (int i = 0; i < 4; i++) {
        const double x = i & 1 ? 0.53 : -0.53, z = i & 2 ? 0.33 : -0.33;
        box(b, x - 0.04, -0.36, z - 0.04, x + 0.04, 0.3, z + 0.04);
    }
}

enum { CUBE, BALL, TORUS, CONE, TABLE, KINDS };
static const struct { const char *name; void (*make)(build *); double albedo[3]; } kinds[KINDS] = {
    { "cube",  make_cube,  {0.78, 0.74, 0.66} }, { "ball",  make_ball, {0.70, 0.42, 0.34} }, { "torus", make_torus, {0.40, 0.55, 0.66} },
    { "cone",  make_cone,  {0.72, 0.62, 0.30} }, { "table", make_table, {0.48, 0.58, 0.42} } };

/* from, turned and moved by b */
static void pose(const build *b, const float from[16], float to[16])
{
    for (int j = 0; j < 3; j++) {
        const double axis[3] = { (double)from[4 * j], (double)from[4 * j + 1], (double)from[4 * j + 2] };
        double turned_axis[3];
        rotate(b, axis, turned_axis);
        for (int i = 0; i < 3; i++) to[4 * j + i] = (float)turned_axis[i];
        to[4 * j + 3] = 0;
        to[12 + j] = (float)((double)from[12 + j] + b->at[j]);
    }
    to[15] = 1;
}

/* raised as far as it takes to be above a level */
static void place_above(kit_scene *s, int k, const float m[16], double level)
{
    float raised[16];
    set_place(s, k, m);
    if (!((double)s->object[k].lower[1] < level)) return;
    memcpy(raised, m, sizeof raised);
    raised[13] += (float)(level - (double)s->object[k].lower[1]);
    set_place(s, k, raised);
}

/* An object of a kind, resting on the level y: the ground at 0, else on the object before or its stack. */
static void caster(build *b, int kind, double size, double x, double y, double z, double turn, double tilt)
{
    kit_scene *s = &b->scene;
    const int k = s->objects;
    float m[16] = { (float)size, 0, 0, 0,  0, (float)size, 0, 0,  0, 0, (float)size, 0,  0, 0, 0, 1 };
    place(b, 0, 0, 0, 0);
    colour(b, kinds[kind].albedo[0], kinds[kind].albedo[1], kinds[kind].albedo[2]);
    object(b, kinds[kind].name, 1);
    kinds[kind].make(b);
    if (b->failed) return;
    for (int i = 0; i < k; i++)
        if (!strcmp(s->object[i].name, kinds[kind].name)) s->object[k].shape = s->object[i].shape;
    if (s->object[k].shape < 0 && own_shape(s, k)) { b->failed = 1; return; }
    place_tilted(b, x, y, z, turn, tilt);
    pose(b, m, m);
    place_above(s, k, m, y + GAP);
    memcpy(s->object[k].loaded, s->object[k].to_world, sizeof m);
    s->object[k].base = y > 0 ? s->object[k - 1].base : k;
}

static void build_ground(build *b, double half)
{
    colour(b, 0.72, 0.72, 0.70);
    object(b, "ground", 0);
    box(b, -half, -0.2, -half, half, 0, half);
}

static void build_casters(build *b)
{
    static const struct { int kind; double size, x, y, z, turn, tilt; } set[] = {
        { CUBE, 1.2, -2.6, 0, -1.6, 20, 0 },   { CUBE, 0.7, -2.5, 1.2, -1.6, 55, 0 },  { BALL, 0.5, -2.5, 1.9, -1.6, 0, 0 },
        { CUBE, 0.8, -1.6, 0, -0.5, -12, 0 },  { CUBE, 1.0, -0.35, 0, -1.9, 38, 0 },   { CUBE, 0.6, -3.5, 0, 0.1, 5, 0 },
        { CUBE, 0.5, -0.6, 0, 0.5, 62, 0 },    { CUBE, 0.35, -0.6, 0.5, 0.5, 20, 0 },  { CUBE, 0.9, -2.45, 0, 0.75, 30, 33 },
        { TABLE, 1.7, 1.5, 0, -1.1, -18, 0 },  { CONE, 0.7, 1.05, 1.224, -1.2, 0, 0 }, { TORUS, 0.8, 1.9, 1.224, -0.95, 0, 0 },
        { BALL, 0.3, 1.9, 1.224, -0.95, 0, 0 }, { BALL, 0.7, 1.4, 0, -1.0, 0, 0 },
        { BALL, 1.1, 3.2, 0, 0.5, 0, 0 },      { CONE, 1.3, 0.6, 0, 0.7, 0, 0 },       { CONE, 0.9, 2.0, 0, 1.4, 40, 114 },
        { TORUS, 1.2, -1.4, 0, 1.7, 0, 0 },    { TORUS, 1.1, 3.55, 0, -1.2, 60, 72 },  { TORUS, 0.7, 0.1, 0, 1.9, 25, 90 },
        { TABLE, 0.8, 1.1, 0, 2.3, 30, 180 },  { TABLE, 0.9, -3.7, 0, 1.6, -40, 90 },  { BALL, 0.6, -2.4, 0, 2.2, 0, 0 }, { CUBE, 0.45, 2.9, 0, 2.1, 15, 45 } };
    build_ground(b, 14);
    for (size_t i = 0; i < sizeof set / sizeof *set; i++)
        caster(b, set[i].kind, set[i].size, set[i].x, set[i].y, set[i].z, set[i].turn, set[i].tilt);
}

static void build_crowd(build *b)
{
    build_ground(b, 24);
    for (int i = 0; i < 100; i++) {                                      /* every third leans or lies */
        const double size = between(b, 0.5, 1.1), x = 1.7 * (i % 10 - 4.5) + between(b, -0.3, 0.3), z = 1.7 * (i / 10 - 4.5) + between(b, -0.3, 0.3);
        const double turn = between(b, 0, 360), tilt = between(b, 20, 160);
        caster(b, (i + i / 10 * 2) % KINDS, size, x, 0, z, turn, i % 3 ? 0 : tilt);
    }
}

/* ---- >>scenes ----------------------------------------------------------------------------------------------- */

static const struct builtin {
    const char *name, *about;
    void  (*make)(build *);
    float   eye[3], target[3], fovy, znear, radius;
} builtins[] = {
    { "room",      "corner of a furnished room: boxes, books, thin railing, torus, lamp", build_room, {4.55f, 1.75f, 4.25f}, {1.35f, 0.85f, 0.85f}, 50, 0.1f, 0.5f },
    { "grass",     "some thousands of bent blades on rolling ground, with stones", build_grass, {0, 0.85f, 3}, {0, 0.05f, 0.2f}, 42, 0.05f, 0.3f },
    { "colonnade", "columns, arches, coffered ceiling and steps", build_colonnade, {-0.75f, 1.75f, 2.9f}, {0.35f, 2.0f, -6}, 55, 0.05f, 0.8f },
    { "cornell",   "open box: red and green walls, two white boxes", build_cornell, {0, 2.745f, 7.7f}, {0, 2.745f, 0}, 38, 0.1f, 1.5f },
    { "columns",   "white columns, coloured ones hidden behind them, a box beside the picture", build_columns, {0, 1.7f, 6.2f}, {0, 0.95f, 0}, 33, 0.1f, 1 },
    { "plates",    "thin plates, bars and hoops floating over a floor", build_plates, {1.3f, 3.3f, 4.0f}, {0, 0.45f, 0.05f}, 36, 0.1f, 0.8f },
    { "pebbles",   "some hundred small boxes, studs and balls, two tables on thin legs", build_pebbles, {0.35f, 0.65f, 1.5f}, {0.05f, 0.08f, 0}, 36, 0.05f, 0.08f },
    { "boxes",     "three white boxes near each other on a floor", build_boxes, {0.25f, 3.3f, 3.6f}, {0, 0.3f, 0}, 34, 0.1f, 0.6f },
    { "blocks",    "a dozen of white tower blocks, from above", build_blocks, {2.4f, 6.0f, 4.6f}, {0.1f, 0.5f, 0.1f}, 31, 0.1f, 0.5f },
    { "casters",   "two dozen shapes standing, leaning, lying on a ground and on each other", build_casters, {2.2f, 5.6f, 8.3f}, {0, 0.4f, 0}, 34, 0.1f, 0.8f },
    { "crowd",     "a hundred such shapes on a wide ground", build_crowd, {5.5f, 9.5f, 16}, {0, 0, 0.8f}, 33, 0.1f, 0.8f },
    { "plane",     "one big square", build_plane, {0, 1.5f, 2}, {0, 0, 0}, 45, 0.1f, 0.5f },
    { "corner",    "floor (y = 0) and wall (x = 0) at a right angle", build_corner, {3.2f, 1.9f, 2.6f}, {0.4f, 0.5f, 0}, 40, 0.1f, 0.5f },
    { "groove",    "a square groove in a plane, 1 wide and 1 deep, along z", build_groove, {0.9f, 2.4f, 2.6f}, {0, -0.3f, 0}, 34, 0.1f, 0.5f },
    { "sphere",    "a sphere of radius 1 on a big plane", build_sphere, {1.5f, 3.6f, 4.2f}, {0, 0.7f, 0}, 34, 0.1f, 1 },
    { "hole",      "a cubic hole in a plane, 1 wide and 1 deep", build_hole, {0.9f, 2.2f, 1.9f}, {0, -0.3f, 0}, 30, 0.1f, 0.5f },
};
enum { BUILTINS = sizeof builtins / sizeof *builtins };

const char *kit_scene_builtin(int i, const char **about)
{
    if (i < 0 || i >= BUILTINS) return NULL;
    if (about) *about = builtins[i].about;
    return builtins[i].name;
}

/* what goes on building a scene; failing leaves its triangles and objects as they were, with more after them perhaps */
static build resume(const kit_scene *scene)
{
    build b;
    memset(&b, 0, sizeof b);
    b.scene = *scene;
    b.capacity = scene->mesh.triangles;
    return b;
}

/* from the front, above and to the right, as near as has all corners of the bounds in view */
static void frame_bounds(kit_camera *camera, const kit_mesh *mesh)
{
    double back[3] = { 0.45, 0.35, 1 }, up[3] = { 0, 1, 0 }, right[3], centre[3], distance = 1e-6;
    const double tangent = tan((double)camera->fovy * PI / 360) / 1.06, aspect = (double)camera->width / camera->height;
    unit(back);
    cross(up, back, right);
    unit(right);
    cross(back, right, up);
    for (int i = 0; i < 3; i++) centre[i] = 0.5 * ((double)mesh->lower[i] + (double)mesh->upper[i]);
    for (int k = 0; k < 8; k++) {
        double corner[3], x, y, z;
        for (int i = 0; i < 3; i++) corner[i] = (double)(k >> i & 1 ? mesh->upper[i] : mesh->lower[i]) - centre[i];
        x = fabs(dot(corner, right)) / (tangent * aspect); y = fabs(dot(corner, up)) / tangent; z = dot(corner, back);
        distance = fmax(distance, z + fmax(x, y));
    }
    for (int i = 0; i < 3; i++) {
        camera->target[i] = (float)centre[i];
        camera->eye[i] = (float)(centre[i] + distance * back[i]);
    }
}

static int from_file(kit_scene *scene, const char *path, int floor_, kit_error *err)
{
    FILE *file = fopen(path, "rb");
    double diagonal = 0;
    int failed = 0;
    if (!file) {
        char names[160] = "";
        for (int i = 0; i < BUILTINS; i++) {
            strcat(names, i ? ", " : "");
            strcat(names, builtins[i].name);
        }
        return kit_fail(err, "scene '%s': neither a file that can be read nor a built-in scene (%s)", path, names);
    }
    fclose(file);
    if (kit_mesh_obj(&scene->mesh, &scene->object, &scene->objects, path, err)) return -1;
    for (int k = 0; k < scene->objects; k++) scene->object[k].shape = -1;
    for (int i = 0; i < 3; i++) diagonal += pow((double)scene->mesh.upper[i] - (double)scene->mesh.lower[i], 2);
    diagonal = sqrt(diagonal);
    scene->name = path;
    scene->about = "OBJ file";
    scene->radius = (float)(0.1 * diagonal);
    scene->camera.fovy = 45;
    frame_bounds(&scene->camera, &scene->mesh);
    if (floor_) {
        build b = resume(scene);
        const double x = 0.5 * ((double)scene->mesh.lower[0] + (double)scene->mesh.upper[0]);
        const double z = 0.5 * ((double)scene->mesh.lower[2] + (double)scene->mesh.upper[2]), half = 2.5 * diagonal, y = (double)scene->mesh.lower[1];
        const double corner[4][3] = { {x - half, y, z + half}, {x + half, y, z + half}, {x + half, y, z - half}, {x - half, y, z - half} };
        colour(&b, 0.8, 0.8, 0.8);
        object(&b, "floor", -1);
        sheet(&b, (const double (*)[3])corner, CUTS(both), CUTS(both));
        *scene = b.scene;
        failed = b.failed;
    }
    if (failed || complete(scene, 0)) {
        kit_scene_free(scene);
        return kit_fail(err, "scene '%s': no memory for its floor or objects", path);
    }
    return 0;
}

int kit_scene_load(kit_scene *scene, const char *name_or_path, int floor_, kit_error *err)
{
    kit_scene s;
    memset(&s, 0, sizeof s);
    s.camera.up[1] = 1;
    s.camera.width = 1280;
    s.camera.height = 720;
    for (int i = 0; i < BUILTINS; i++) {
        const struct builtin *from = &builtins[i];
        build b;
        if (strcmp(name_or_path, from->name)) continue;
        memset(&b, 0, sizeof b);
        b.random = b.object = 1;
        b.scene = s;
        colour(&b, 0.8, 0.8, 0.8);
        from->make(&b);
        if (!b.scene.objects) object(&b, from->name, -1);
        s = b.scene;
        if (b.failed || complete(&s, 0)) {
            kit_scene_free(&s);
            return kit_fail(err, "scene '%s': no memory", name_or_path);
        }
        s.name = from->name;
        s.about = from->about;
        s.radius = from->radius;
        memcpy(s.camera.eye, from->eye, sizeof from->eye);
        memcpy(s.camera.target, from->target, sizeof from->target);
        s.camera.fovy = from->fovy;
        s.camera.znear = from->znear;
        *scene = s;
        return 0;
    }
    if (from_file(&s, name_or_path, floor_, err)) return -1;
    *scene = s;
    return 0;
}

void kit_scene_free(kit_scene *scene)
{
    kit_mesh_free(&scene->mesh);
    for (int i = 0; i < scene->shapes; i++) kit_mesh_free(&scene->shape[i]);
    free(scene->shape);
    free(scene->object);
    memset(scene, 0, sizeof *scene);
}

int kit_scene_add_box(kit_scene *scene, const float lower[3], const float upper[3], const float albedo[3], kit_error *err)
{
    const kit_scene before = *scene;
    build b = resume(scene);
    for (int i = 0; i < 3; i++) {
        if (!isfinite(upper[i] - lower[i]) || upper[i] - lower[i] < 1e-4f)
            return kit_fail(err, "box: sides (upper - lower) must be finite and at least 1e-4, not %g", (double)(upper[i] - lower[i]));
        if (!(albedo[i] >= 0 && albedo[i] <= 1)) return kit_fail(err, "box: albedo must be in [0, 1], not %g", (double)albedo[i]);
        b.albedo[i] = albedo[i];
    }
    object(&b, "box", -1);
    box(&b, (double)lower[0], (double)lower[1], (double)lower[2], (double)upper[0], (double)upper[1], (double)upper[2]);
    *scene = b.scene;
    if (b.failed || complete(scene, before.objects)) {
        scene->mesh.triangles = before.mesh.triangles;
        scene->objects = before.objects;
        return kit_fail(err, "scene '%s': no memory for a box", scene->name);
    }
    return 0;
}

int kit_scene_place(kit_scene *scene, int object_, const float to_world[16], kit_error *err)
{
    double column[3][3], third[3], scale;
    if (object_ < 0 || object_ >= scene->objects) return kit_fail(err, "scene '%s': there is no object %d (0..%d)", scene->name, object_, scene->objects - 1);
    for (int i = 0; i < 12; i++) if (i % 4 < 3) column[i / 4][i % 4] = (double)to_world[i];
    scale = sqrt(dot(column[0], column[0]));
    cross(column[0], column[1], third);
    for (int i = 0; i < 3; i++) third[i] -= scale * column[2][i];
    if (!(scale > 0 && scale < 1e15) || !(sqrt(dot(third, third)) < 1e-3 * scale * scale) || !(fabs(dot(column[0], column[1])) < 1e-3 * scale * scale) ||
        !(fabs(dot(column[1], column[1]) - scale * scale) < 2e-3 * scale * scale) || to_world[3] != 0 || to_world[7] != 0 || to_world[11] != 0 || to_world[15] != 1 ||
        !(fmaxf(fabsf(to_world[12]), fmaxf(fabsf(to_world[13]), fabsf(to_world[14]))) < 1e15f))
        return kit_fail(err, "scene '%s', object '%s': its place must be a rotation, a uniform scale and a translation", scene->name, scene->object[object_].name);
    set_place(scene, object_, to_world);
    bounds(&scene->mesh);
    return 0;
}

void kit_scene_move(kit_scene *scene, double time)
{
    for (int k = 0; k < scene->objects; k++) {
        const kit_object *o = &scene->object[k];
        const float *from = o->loaded, *base = scene->object[o->base].loaded;
        const int way = o->base % 3, hops = 1 + o->base % 2;
        const double size = sqrt((double)base[0] * (double)base[0] + (double)base[1] * (double)base[1] + (double)base[2] * (double)base[2]);
        const double start = 2.4 * o->base, now = start + 2 * PI * time, hop = sin(PI * time * hops);
        double arm[3];
        build b;
        float m[16];
        if (!(from[15] > 0)) continue;
        memset(&b, 0, sizeof b);
        b.turn = hops > 1 ? 360 * time : -360 * time;
        if (way == 2) b.tilt = 360 * time;
        for (int i = 0; i < 3; i++) arm[i] = (double)from[12 + i] - (double)base[12 + i];
        rotate(&b, arm, b.at);
        for (int i = 0; i < 3; i++) b.at[i] -= arm[i];
        if (way == 0) {
            b.at[0] += 0.3 * size * (cos(now) - cos(start));
            b.at[2] += 0.3 * size * (sin(now) - sin(start));
        }
        if (way == 1) b.at[1] += 0.6 * size * hop * hop;
        pose(&b, from, m);
        place_above(scene, k, m, GAP);
    }
    bounds(&scene->mesh);
}
