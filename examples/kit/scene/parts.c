/* parts.c - shapes for scenes by seed, in addition to shapes.c: noise, tubes, cushions, leaves, ground. Declared in
   kit_build.h. */
#include "kit/kit_build.h"
#include <math.h>
#include <string.h>

/* ---- >>noise --------------------------------------------------------------------------------------------------- */

/* Returns a hash of a lattice point, in [-1, 1). */
static double lattice(unsigned seed, int x, int y, int z)
{
    uint32_t h = seed * 0x9e3779b9u ^ (uint32_t)x * 0x85ebca6bu ^ (uint32_t)y * 0xc2b2ae35u ^ (uint32_t)z * 0x27d4eb2fu;
    h = (h ^ h >> 15) * 0x2c1b3c6du;
    h = (h ^ h >> 12) * 0x297a2d39u;
    return (double)(h ^ h >> 15) * 0x1p-31 - 1;
}

double kit_noise(unsigned seed, double x, double y, double z)
{
    const double at[3] = { x, y, z };
    double f[3], sum = 0;
    int cell[3];
    for (int i = 0; i < 3; i++) {
        const double low = floor(at[i]), t = at[i] - low;
        cell[i] = (int)low;
        f[i] = t * t * t * (t * (6 * t - 15) + 10);
    }
    for (int k = 0; k < 8; k++) {
        double w = 1;
        for (int i = 0; i < 3; i++) w *= k >> i & 1 ? f[i] : 1 - f[i];
        sum += w * lattice(seed, cell[0] + (k & 1), cell[1] + (k >> 1 & 1), cell[2] + (k >> 2 & 1));
    }
    return sum;
}

double kit_fractal(unsigned seed, double x, double y, double z, int octaves)
{
    double sum = 0, size = 1;
    for (int i = 0; i < octaves; i++, size *= 2)
        sum += kit_noise(seed + (unsigned)i, size * x, size * y, size * z) / size;
    return sum;
}

/* ---- >>tubes --------------------------------------------------------------------------------------------------- */

enum { TUBE_POINTS = 256 };

/* Writes a unit vector perpendicular to way. */
static void across(const double way[3], double out[3])
{
    const double up[3] = { fabs(way[1]) < 0.9 ? 0 : 1, fabs(way[1]) < 0.9 ? 1 : 0, 0 };
    kit_cross(up, way, out);
    kit_unit(out);
}

/* Writes the k-th of `around` points of a ring about c, whose axes are side and up. */
static void ring_point(kit_vertex *v, const double c[3], const double side[3], const double up[3], double radius, int k,
                       int around)
{
    const double a = 2 * KIT_PI * (k % around) / around, x = cos(a), y = sin(a);
    for (int i = 0; i < 3; i++) {
        v->n[i] = x * side[i] + y * up[i];
        v->p[i] = c[i] + radius * v->n[i];
    }
}

/* Adds a tube's end: a disc that faces way. */
static void cap(kit_build *b, const double c[3], const double side[3], const double up[3], const double way[3],
                double radius, int around)
{
    kit_vertex v[3];
    for (int k = 0; k < around; k++) {
        memcpy(v[0].p, c, sizeof v[0].p);
        ring_point(&v[1], c, side, up, radius, k, around);
        ring_point(&v[2], c, side, up, radius, k + 1, around);
        for (int i = 0; i < 3; i++) memcpy(v[i].n, way, sizeof v[i].n);
        kit_triangle(b, &v[0], &v[1], &v[2]);
    }
}

void kit_tube(kit_build *b, const double at[][3], int count, double radius, int around)
{
    double side[3] = { 0 }, up[3], old_side[3] = { 0 }, old_up[3] = { 0 }, way[3] = { 0 };
    if (count < 2) return;
    if (count > TUBE_POINTS) count = TUBE_POINTS;
    for (int n = 0; n < count; n++) {
        const double *from = at[n ? n - 1 : 0], *to = at[n + 1 < count ? n + 1 : n];
        double along;
        for (int i = 0; i < 3; i++) way[i] = to[i] - from[i];
        if (!kit_unit(way)) way[1] = 1;
        if (!n) across(way, side);
        along = kit_dot(side, way);
        for (int i = 0; i < 3; i++) side[i] -= along * way[i];
        if (!kit_unit(side)) across(way, side);
        kit_cross(way, side, up);
        for (int k = 0; k < around && n; k++) {
            kit_vertex v[4];
            ring_point(&v[0], at[n - 1], old_side, old_up, radius, k, around);
            ring_point(&v[1], at[n - 1], old_side, old_up, radius, k + 1, around);
            ring_point(&v[2], at[n], side, up, radius, k + 1, around);
            ring_point(&v[3], at[n], side, up, radius, k, around);
            kit_triangle(b, &v[0], &v[1], &v[2]);
            kit_triangle(b, &v[0], &v[2], &v[3]);
        }
        if (!n) {
            const double back[3] = { -way[0], -way[1], -way[2] };
            cap(b, at[0], side, up, back, radius, around);
        }
        memcpy(old_side, side, sizeof side);
        memcpy(old_up, up, sizeof up);
    }
    cap(b, at[count - 1], side, up, way, radius, around);
}

void kit_cable(kit_build *b, const double from[3], const double to[3], double sag, double radius, int around)
{
    enum { PIECES = 16 };

    double at[PIECES + 1][3];
    for (int k = 0; k <= PIECES; k++) {
        const double t = (double)k / PIECES;
        for (int i = 0; i < 3; i++) at[k][i] = (1 - t) * from[i] + t * to[i];
        at[k][1] -= 4 * sag * t * (1 - t);
    }
    kit_tube(b, (const double(*)[3])at, PIECES + 1, radius, around);
}

/* ---- >>solids -------------------------------------------------------------------------------------------------- */

/* shape: half sides, round */
static void cushion_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, power = fmax(0.12, s[3]), a = 2 * KIT_PI * fmod(u, 1), t = KIT_PI * (fmin(v, 1) - 0.5);
    const double ring = v <= 0 || v >= 1 ? 0 : pow(cos(t), power);
    const double c = cos(a), z = sin(a),
                 unit[3] = { copysign(ring * pow(fabs(c), power), c), copysign(pow(fabs(sin(t)), power), t),
                             copysign(ring * pow(fabs(z), power), z) };
    for (int i = 0; i < 3; i++) {
        out->p[i] = s[i] * unit[i];
        out->n[i] = copysign(pow(fabs(unit[i]), 2 / power - 1), unit[i]) / s[i];
    }
    if (!kit_unit(out->n)) {
        out->n[0] = out->n[2] = 0;
        out->n[1] = t > 0 ? 1 : -1;
    }
}

void kit_cushion(kit_build *b, const double half[3], double round, int cells)
{
    const double shape[4] = { half[0], half[1], half[2], round };
    kit_patch(b, 2 * cells, cells, cushion_surface, shape);
}

void kit_prism(kit_build *b, const double outline[][2], int count, double height)
{
    for (int k = 0; k < count; k++) {
        const double *p = outline[k], *q = outline[(k + 1) % count];
        const double side[4][3] = {
            { p[0], 0, p[1] }, { q[0], 0, q[1] }, { q[0], height, q[1] }, { p[0], height, p[1] }
        };
        kit_quad(b, side);
        if (k < 1 || k + 1 >= count) continue;
        kit_vertex top[3] = { { { outline[0][0], height, outline[0][1] }, { 0, 1, 0 } },
                              { { p[0], height, p[1] }, { 0, 1, 0 } },
                              { { q[0], height, q[1] }, { 0, 1, 0 } } };
        kit_triangle(b, &top[0], &top[1], &top[2]);
        for (int i = 0; i < 3; i++) {
            top[i].p[1] = 0;
            top[i].n[1] = -1;
        }
        kit_triangle(b, &top[0], &top[1], &top[2]);
    }
}

void kit_bevelled(kit_build *b, double x0, double y0, double z0, double x1, double y1, double z1, double bevel)
{
    const double low[3] = { x0, y0, z0 }, high[3] = { x1, y1, z1 };
    for (int axis = 0; axis < 3; axis++) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int side = 0; side < 2; side++) {
            static const int cu[4] = { 0, 1, 1, 0 }, cv[4] = { 0, 0, 1, 1 };
            double face[4][3], edge[4][3];
            for (int k = 0; k < 4; k++) { /* the box's faces, smaller by the bevel */
                const int at = side ? k : 3 - k;
                face[k][axis] = side ? high[axis] : low[axis];
                face[k][u] = cu[at] ? high[u] - bevel : low[u] + bevel;
                face[k][v] = cv[at] ? high[v] - bevel : low[v] + bevel;
            }
            kit_quad(b, (const double(*)[3])face);
            for (int other = 0; other < 2; other++) { /* the bevels between this face and those of the next axis */
                const double a = side ? high[axis] : low[axis], in_a = side ? a - bevel : a + bevel,
                             o = other ? high[u] : low[u], in_o = other ? o - bevel : o + bevel;
                const int flip = side == other;
                for (int k = 0; k < 4; k++) {
                    const int at = flip ? k : 3 - k;
                    edge[k][axis] = at == 0 || at == 3 ? a : in_a;
                    edge[k][u] = at == 0 || at == 3 ? in_o : o;
                    edge[k][v] = at < 2 ? low[v] + bevel : high[v] - bevel;
                }
                kit_quad(b, (const double(*)[3])edge);
            }
        }
    }
    for (int k = 0; k < 8; k++) { /* the corners */
        kit_vertex v[3];
        const double s[3] = { k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1 };
        for (int n = 0; n < 3; n++)
            for (int i = 0; i < 3; i++) {
                v[n].p[i] = (s[i] > 0 ? high[i] : low[i]) - (i == n ? 0 : s[i] * bevel);
                v[n].n[i] = s[i] * 0.5773502691896258;
            }
        kit_triangle(b, &v[0], &v[1], &v[2]);
    }
}

/* ---- >>sheets -------------------------------------------------------------------------------------------------- */

typedef struct leaf {
    double width, length, bend;
    int pointed;
} leaf;

static void leaf_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const leaf *l = shape;
    const double bend = l->bend + 1e-4, a = bend * v, wide = l->pointed ? 2 * sqrt(v) * (1 - v) * 1.3 : 1;
    out->p[0] = l->width * (u - 0.5) * wide;
    out->p[1] = l->length * (cos(a) - 1) / bend;
    out->p[2] = l->length * sin(a) / bend;
    out->n[0] = 0;
    out->n[1] = cos(a);
    out->n[2] = sin(a);
}

void kit_leaf(kit_build *b, double width, double length, double bend, int cells, int pointed)
{
    const leaf l = { width, length, bend, pointed };
    kit_patch(b, 1, cells, leaf_surface, &l);
}

typedef struct field {
    const double *rectangle;
    kit_height *height;
    const void *of;
    double step;
} field;

static void field_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const field *f = shape;
    const double x = f->rectangle[0] + u * (f->rectangle[2] - f->rectangle[0]),
                 z = f->rectangle[1] + v * (f->rectangle[3] - f->rectangle[1]), e = f->step;
    out->p[0] = x;
    out->p[1] = f->height(f->of, x, z);
    out->p[2] = z;
    out->n[0] = f->height(f->of, x - e, z) - f->height(f->of, x + e, z);
    out->n[1] = 2 * e;
    out->n[2] = f->height(f->of, x, z - e) - f->height(f->of, x, z + e);
    kit_unit(out->n);
}

void kit_height_field(kit_build *b, const double rectangle[4], int nx, int nz, kit_height *height, const void *of)
{
    const field f = { rectangle, height, of, 0.25 * fabs(rectangle[2] - rectangle[0]) / nx };
    kit_patch(b, nx, nz, field_surface, &f);
}
