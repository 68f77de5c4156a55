/* shapes.c - basic shapes of scenes: triangles, boxes, curved patches; objects and their places. Declared in
   kit_build.h. */
#include "kit/kit_build.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>


void kit_colour(kit_build *b, double r, double g, double blue)
{
    b->albedo[0] = (float)r; b->albedo[1] = (float)g; b->albedo[2] = (float)blue;
}

void kit_place_at(kit_build *b, double x, double y, double z, double turn)
{
    b->at[0] = x; b->at[1] = y; b->at[2] = z; b->turn = turn; b->tilt = 0;
}

void kit_place_tilted(kit_build *b, double x, double y, double z, double turn, double tilt)
{
    kit_place_at(b, x, y, z, turn);
    b->tilt = tilt;
}

/* Returns a random number by PCG's hash. */
double kit_chance(kit_build *b)
{
    uint32_t x = b->random = b->random * 747796405u + 2891336453u;
    x = ((x >> ((x >> 28) + 4)) ^ x) * 277803737u;
    return (double)((x >> 22) ^ x) * 0x1p-32;
}

double kit_between(kit_build *b, double low, double high) { return low + (high - low) * kit_chance(b); }

static int grow(kit_build *b)
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

void kit_rotate(const kit_build *b, const double in[3], double out[3])
{
    const double c = cos(b->turn * KIT_PI / 180), s = sin(b->turn * KIT_PI / 180), ct = cos(b->tilt * KIT_PI / 180),
                 st = sin(b->tilt * KIT_PI / 180);
    const double z = st * in[1] + ct * in[2];
    out[0] = c * in[0] + s * z;
    out[1] = ct * in[1] - st * in[2];
    out[2] = -s * in[0] + c * z;
}

/* Transforms a point, or a direction, from a frame to the world. */
static void out_of_frame(const kit_frame *f, double v[3], int point)
{
    const double in[3] = { v[0], v[1], v[2] };
    if (!(f->scale > 0)) return;
    for (int i = 0; i < 3; i++)
        v[i] = (point ? f->scale : 1) * kit_dot(f->turn[i], in) + (point ? f->at[i] : 0);
}

kit_frame kit_enter_tilted(kit_build *b, const double at[3], double turn, double tilt, double size)
{
    const kit_frame before = b->frame;
    double world[3] = { at[0], at[1], at[2] }, axis[3][3];
    out_of_frame(&before, world, 1);
    kit_place_tilted(b, 0, 0, 0, turn, tilt);
    for (int k = 0; k < 3; k++) {
        const double unit[3] = { k == 0, k == 1, k == 2 };
        kit_rotate(b, unit, axis[k]);
        out_of_frame(&before, axis[k], 0);
    }
    for (int i = 0; i < 3; i++)
        for (int k = 0; k < 3; k++) b->frame.turn[i][k] = axis[k][i];
    memcpy(b->frame.at, world, sizeof world);
    b->frame.scale = (before.scale > 0 ? before.scale : 1) * size;
    kit_place_at(b, 0, 0, 0, 0);
    return before;
}

kit_frame kit_enter(kit_build *b, double x, double y, double z, double turn, double size)
{
    const double at[3] = { x, y, z };
    return kit_enter_tilted(b, at, turn, 0, size);
}

void kit_leave(kit_build *b, kit_frame before)
{
    b->frame = before;
    kit_place_at(b, 0, 0, 0, 0);
}

void kit_triangle(kit_build *b, const kit_vertex *v0, const kit_vertex *v1, const kit_vertex *v2)
{
    kit_mesh *m = &b->scene.mesh;
    const kit_vertex *v[3] = { v0, v1, v2 };
    double e1[3], e2[3], face[3], sum[3];
    float *position, *normal;
    for (int i = 0; i < 3; i++) {
        e1[i] = v1->p[i] - v0->p[i];
        e2[i] = v2->p[i] - v0->p[i];
        sum[i] = v0->n[i] + v1->n[i] + v2->n[i];
    }
    kit_cross(e1, e2, face);
    if (!(kit_dot(face, face) > 1e-20) || b->failed) return;
    if (m->triangles == b->capacity && grow(b)) return;
    if (kit_dot(face, sum) < 0) { v[1] = v2; v[2] = v1; }
    position = m->position + 9 * m->triangles;
    normal   = m->normal + 9 * m->triangles;
    for (int k = 0; k < 3; k++, position += 3, normal += 3) {
        double p[3], n[3];
        kit_rotate(b, v[k]->p, p);
        kit_rotate(b, v[k]->n, n);
        for (int i = 0; i < 3; i++) p[i] += b->at[i];
        out_of_frame(&b->frame, p, 1);
        out_of_frame(&b->frame, n, 0);
        for (int i = 0; i < 3; i++) {
            position[i] = (float)p[i];
            normal[i] = (float)n[i];
        }
    }
    memcpy(m->albedo + 3 * m->triangles, b->albedo, sizeof b->albedo);
    m->object[m->triangles++] = b->object;
}

void kit_quad(kit_build *b, const double corner[4][3])
{
    kit_vertex v[4];
    double d1[3], d2[3], n[3];
    for (int i = 0; i < 3; i++) {
        d1[i] = corner[2][i] - corner[0][i];
        d2[i] = corner[3][i] - corner[1][i];
    }
    kit_cross(d1, d2, n);
    kit_unit(n);
    for (int k = 0; k < 4; k++) {
        memcpy(v[k].p, corner[k], sizeof v[k].p);
        memcpy(v[k].n, n, sizeof n);
    }
    kit_triangle(b, &v[0], &v[1], &v[2]);
    kit_triangle(b, &v[0], &v[2], &v[3]);
}

void kit_box(kit_build *b, double x0, double y0, double z0, double x1, double y1, double z1)
{
    const double c[6][4][3] = {
        {{x0,y0,z0},{x0,y0,z1},{x0,y1,z1},{x0,y1,z0}}, {{x1,y0,z1},{x1,y0,z0},{x1,y1,z0},{x1,y1,z1}},
        {{x0,y0,z0},{x1,y0,z0},{x1,y0,z1},{x0,y0,z1}}, {{x0,y1,z1},{x1,y1,z1},{x1,y1,z0},{x0,y1,z0}},
        {{x1,y0,z0},{x0,y0,z0},{x0,y1,z0},{x1,y1,z0}}, {{x0,y0,z1},{x1,y0,z1},{x1,y1,z1},{x0,y1,z1}} };
    for (int i = 0; i < 6; i++) kit_quad(b, c[i]);
}

void kit_level(kit_build *b, double x0, double z0, double x1, double z1, double y)
{
    const double c[4][3] = { {x0,y,z1}, {x1,y,z1}, {x1,y,z0}, {x0,y,z0} };
    kit_quad(b, c);
}

void kit_sheet(kit_build *b, const double c[4][3], const double *u, int nu, const double *v, int nv)
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
            kit_quad(b, (const double (*)[3])q);
        }
}

void kit_patch(kit_build *b, int nu, int nv, kit_surface *surface, const void *shape)
{
    for (int j = 0; j < nv; j++)
        for (int i = 0; i < nu; i++) {
            kit_vertex c[4];
            surface(shape, (double)i / nu, (double)j / nv, &c[0]);
            surface(shape, (double)(i + 1) / nu, (double)j / nv, &c[1]);
            surface(shape, (double)(i + 1) / nu, (double)(j + 1) / nv, &c[2]);
            surface(shape, (double)i / nu, (double)(j + 1) / nv, &c[3]);
            kit_triangle(b, &c[0], &c[1], &c[2]);
            kit_triangle(b, &c[0], &c[2], &c[3]);
        }
}

void kit_sphere_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double radius = *(const double *)shape, y = v >= 1 ? 1 : -cos(KIT_PI * v), r = v >= 1 ? 0 : sin(KIT_PI * v),
                 a = 2 * KIT_PI * fmod(u, 1);
    out->n[0] = r * cos(a); out->n[1] = y; out->n[2] = r * sin(a);
    for (int i = 0; i < 3; i++) out->p[i] = radius * out->n[i];
}

void kit_torus_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *r = shape, a = 2 * KIT_PI * fmod(u, 1), t = 2 * KIT_PI * fmod(v, 1);
    out->n[0] = cos(t) * cos(a); out->n[1] = sin(t); out->n[2] = cos(t) * sin(a);
    out->p[0] = (r[0] + r[1] * cos(t)) * cos(a); out->p[1] = r[1] * sin(t); out->p[2] = (r[0] + r[1] * cos(t)) * sin(a);
}

static void moulding_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const kit_moulding *m = shape;
    const double dr = m->r1 - m->r0, dy = m->y1 - m->y0, length = sqrt(dr * dr + dy * dy), a = 2 * KIT_PI * fmod(u, 1);
    const double swell = 4 * v * (1 - v) * m->bulge / length, slope = 4 * (1 - 2 * v) * m->bulge / length;
    const double r = m->r0 + v * dr + swell * dy, y = m->y0 + v * dy - swell * dr;
    const double tr = dr + slope * dy, ty = dy - slope * dr, t = sqrt(tr * tr + ty * ty);
    out->p[0] = r * cos(a); out->p[1] = y; out->p[2] = r * sin(a);
    out->n[0] = ty / t * cos(a); out->n[1] = -tr / t; out->n[2] = ty / t * sin(a);
}

void kit_turned(kit_build *b, const kit_moulding *profile, int count, int around)
{
    for (int i = 0; i < count; i++)
        kit_patch(b, around, profile[i].bulge < 0 || profile[i].bulge > 0 ? 8 : 1, moulding_surface, &profile[i]);
}

void kit_cylinder(kit_build *b, double radius, double height, int around)
{
    const kit_moulding profile[] = { { 0, 0, radius, 0, 0 },
                                     { radius, 0, radius, height, 0 },
                                     { radius, height, 0, height, 0 } };
    kit_turned(b, profile, 3, around);
}

/* ---- >>objects ---------------------------------------------------------------------------------------------- */

void kit_begin_object(kit_build *b, const char *name, int casts)
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

/* Returns the index in the scene's mesh of object k's triangle after t; begin with t = o->first - 1. */
static size_t next_triangle(const kit_scene *s, int k, size_t t)
{
    while (s->mesh.object[++t] != (uint32_t)k + 1) {}
    return t;
}

void kit_set_place(kit_scene *s, int k, const float m[16])
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

/* Makes the `triangles` triangles of object k a shape of its own. */
static int own_shape(kit_scene *s, int k, size_t triangles)
{
    static const float identity[16] = { 1, 0, 0, 0,  0, 1, 0, 0,  0, 0, 1, 0,  0, 0, 0, 1 };
    kit_object *o = &s->object[k];
    kit_mesh shape, *more = realloc(s->shape, ((size_t)s->shapes + 1) * sizeof *more);
    memset(&shape, 0, sizeof shape);
    if (more) s->shape = more;
    shape.triangles = triangles;
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
    kit_mesh_bounds(&shape);
    s->shape[s->shapes] = shape;
    o->shape = s->shapes++;
    kit_set_place(s, k, identity);
    return 0;
}

int kit_own_shape(kit_scene *s, int k)
{
    size_t triangles = 0;
    for (size_t t = s->object[k].first; t < s->mesh.triangles; t++)
        triangles += s->mesh.object[t] == (uint32_t)k + 1;
    return own_shape(s, k, triangles);
}

/* Makes shapes for all objects from first on that have none; it counts their triangles in one pass. */
static int own_shapes(kit_scene *s, int first)
{
    size_t *triangles = calloc((size_t)s->objects + 1, sizeof *triangles);
    int failed = !triangles;
    for (size_t t = 0; t < s->mesh.triangles && !failed; t++) triangles[s->mesh.object[t]]++;
    for (int k = first; k < s->objects && !failed; k++)
        if (s->object[k].shape < 0) failed = own_shape(s, k, triangles[k + 1]);
    free(triangles);
    return failed;
}

static int holds(const kit_object *a, const kit_object *b)
{
    for (int i = 0; i < 3; i++)
        if (a->lower[i] > b->lower[i] || a->upper[i] < b->upper[i]) return 0;
    return 1;
}

/* Returns whether most other objects are within the bounds of object k. */
static int holds_most(const kit_scene *s, int k)
{
    int held = 0;
    for (int i = 0; i < s->objects; i++) held += i != k && holds(&s->object[k], &s->object[i]);
    return 2 * held > s->objects - 1;
}

/* Decides whether object k casts, by kit_scene_load's rule, and whether objects around it still do. */
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

int kit_complete(kit_scene *s, int first)
{
    if (own_shapes(s, first)) return -1;
    for (int k = first; k < s->objects; k++)
        if (s->object[k].casts < 0) judge(s, k);
    kit_mesh_bounds(&s->mesh);
    return 0;
}

void kit_pose(const kit_build *b, const float from[16], float to[16])
{
    for (int j = 0; j < 3; j++) {
        const double axis[3] = { (double)from[4 * j], (double)from[4 * j + 1], (double)from[4 * j + 2] };
        double turned_axis[3];
        kit_rotate(b, axis, turned_axis);
        for (int i = 0; i < 3; i++) to[4 * j + i] = (float)turned_axis[i];
        to[4 * j + 3] = 0;
        to[12 + j] = (float)((double)from[12 + j] + b->at[j]);
    }
    to[15] = 1;
}

void kit_place_above(kit_scene *s, int k, const float m[16], double level)
{
    float raised[16];
    kit_set_place(s, k, m);
    if (!((double)s->object[k].lower[1] < level)) return;
    memcpy(raised, m, sizeof raised);
    raised[13] += (float)(level - (double)s->object[k].lower[1]);
    kit_set_place(s, k, raised);
}

void kit_scene_free(kit_scene *scene)
{
    kit_mesh_free(&scene->mesh);
    for (int i = 0; i < scene->shapes; i++) kit_mesh_free(&scene->shape[i]);
    free(scene->shape);
    free(scene->object);
    memset(scene, 0, sizeof *scene);
}
