/* sculpt.c - the surface of blended blobs, displaced by noise, as a mesh of surface nets. Declared in scans.h. */
#include "kit/scene/scans/scans.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>blobs --------------------------------------------------------------------------------------------------- */

static kit_blob *add(kit_clay *c, kit_blob blob)
{
    kit_blob *to = &c->blob[c->blobs < KIT_BLOBS ? c->blobs++ : KIT_BLOBS - 1];
    *to = blob;
    return to;
}

kit_blob *scan_limb(kit_clay *c, double x0, double y0, double z0, double r0, double x1, double y1, double z1, double r1,
                    double blend)
{
    return add(c, (kit_blob){ { x0, y0, z0 }, { x1, y1, z1 }, r0, r1, blend, KIT_LIMB, 0 });
}

kit_blob *scan_egg(kit_clay *c, double x, double y, double z, double rx, double ry, double rz, double blend)
{
    return add(c, (kit_blob){ { x, y, z }, { rx, ry, rz }, 0, 0, blend, KIT_EGG, 0 });
}

kit_blob *scan_block(kit_clay *c, double x, double y, double z, double hx, double hy, double hz, double round,
                     double blend)
{
    return add(c, (kit_blob){ { x, y, z }, { hx, hy, hz }, round, 0, blend, KIT_BLOCK, 0 });
}

void scan_mirror(kit_clay *c, int last)
{
    for (int k = 0, from = c->blobs - last; k < last; k++) {
        kit_blob *to = add(c, c->blob[from + k]);
        to->a[0] = -to->a[0];
        if (to->kind == KIT_LIMB) to->b[0] = -to->b[0];
    }
}

void scan_cut_plane(kit_clay *c, double nx, double ny, double nz, double d, double jag)
{
    if (c->cuts < KIT_CUTS_MOST) c->missing[c->cuts++] = (kit_missing){ { nx, ny, nz }, d, jag, 0 };
}

void scan_cut_ball(kit_clay *c, double x, double y, double z, double radius, double jag)
{
    if (c->cuts < KIT_CUTS_MOST) c->missing[c->cuts++] = (kit_missing){ { x, y, z }, radius, jag, 1 };
}

/* ---- >>distance ------------------------------------------------------------------------------------------------ */

static double to_limb(const kit_blob *b, const double p[3])
{
    double along[3], from[3], off[3];
    for (int i = 0; i < 3; i++) {
        along[i] = b->b[i] - b->a[i];
        from[i] = p[i] - b->a[i];
    }
    const double t = fmax(0, fmin(1, kit_dot(from, along) / fmax(1e-12, kit_dot(along, along))));
    for (int i = 0; i < 3; i++) off[i] = from[i] - t * along[i];
    return sqrt(kit_dot(off, off)) - (b->ra + t * (b->rb - b->ra));
}

/* a bound that is exact to first order near the surface */
static double to_egg(const kit_blob *b, const double p[3])
{
    double unit[3], slope[3];
    for (int i = 0; i < 3; i++) {
        unit[i] = (p[i] - b->a[i]) / b->b[i];
        slope[i] = unit[i] / b->b[i];
    }
    const double r = sqrt(kit_dot(unit, unit)), g = sqrt(kit_dot(slope, slope));
    return g > 1e-9 ? r * (r - 1) / g : -fmin(b->b[0], fmin(b->b[1], b->b[2]));
}

static double to_block(const kit_blob *b, const double p[3])
{
    double out = 0, in = -1e9;
    for (int i = 0; i < 3; i++) {
        const double q = fabs(p[i] - b->a[i]) - b->b[i] + b->ra;
        out += q > 0 ? q * q : 0;
        in = fmax(in, q);
    }
    return sqrt(out) + fmin(in, 0) - b->ra;
}

static double to_blob(const kit_blob *b, const double p[3])
{
    return b->kind == KIT_LIMB ? to_limb(b, p) : b->kind == KIT_EGG ? to_egg(b, p) : to_block(b, p);
}

/* the smaller of two, rounded where they differ by less than k */
static double blended(double a, double b, double k)
{
    const double h = k > 0 ? fmax(0, 1 - fabs(a - b) / k) : 0;
    return fmin(a, b) - 0.25 * h * h * k;
}

/* to the clay, of which only some blobs are near */
static double to_clay(const kit_clay *c, const short *near, int count, const double p[3])
{
    double d = 1e9;
    for (int k = 0; k < count; k++) {
        const kit_blob *b = &c->blob[near[k]];
        const double e = to_blob(b, p);
        d = b->carved ? -blended(-d, e, b->blend) : blended(d, e, b->blend);
    }
    if (c->relief) d = c->relief(c->of, p, d);
    if (c->rough > 0 && fabs(d) < 3 * c->rough)
        d += c->rough * kit_fractal((unsigned)c->seed, p[0] / c->grain, p[1] / c->grain, p[2] / c->grain, c->octaves);
    return d;
}

/* ---- >>grid ---------------------------------------------------------------------------------------------------- */

enum { BRICK = 4 }; /* samples along a side of what is sampled or left out together */

/* value: at n[0] x n[1] x n[2] corners, x fastest; net: number of the cell's vertex, at its lower corner, or -1 */
typedef struct grid {
    const kit_clay *clay;
    int n[3];
    double low[3], cell;
    float *value;
    int *net;
    kit_vertex *vertex;
    int vertices, room;
} grid;

static size_t index_of(const grid *g, int x, int y, int z)
{
    return ((size_t)z * (size_t)g->n[1] + (size_t)y) * (size_t)g->n[0] + (size_t)x;
}

static void bounds_of(const kit_clay *c, double low[3], double high[3])
{
    for (int i = 0; i < 3; i++) {
        low[i] = 1e9;
        high[i] = -1e9;
    }
    for (int k = 0; k < c->blobs; k++) {
        const kit_blob *b = &c->blob[k];
        for (int i = 0; i < 3 && !b->carved; i++) {
            const int limb = b->kind == KIT_LIMB;
            low[i] = fmin(low[i], limb ? fmin(b->a[i] - b->ra, b->b[i] - b->rb) : b->a[i] - b->b[i]);
            high[i] = fmax(high[i], limb ? fmax(b->a[i] + b->ra, b->b[i] + b->rb) : b->a[i] + b->b[i]);
        }
    }
}

static int lay_grid(grid *g, const kit_clay *c, int cells)
{
    double high[3], most = 0;
    memset(g, 0, sizeof *g);
    g->clay = c;
    bounds_of(c, g->low, high);
    for (int i = 0; i < 3; i++) most = fmax(most, high[i] - g->low[i]);
    g->cell = most / cells;
    for (int i = 0; i < 3; i++) {
        const double margin = 2 * c->rough + 2.5 * g->cell;
        g->low[i] -= margin;
        g->n[i] = 1 + (int)ceil((high[i] + margin - g->low[i]) / g->cell);
    }
    const size_t size = (size_t)g->n[0] * (size_t)g->n[1] * (size_t)g->n[2];
    g->value = malloc(size * sizeof *g->value);
    g->net = malloc(size * sizeof *g->net);
    return g->value && g->net ? 0 : -1;
}

/* Which of some blobs matter within reach of p; those carved need be near, the others nearly the nearest. */
static int blobs_near(const kit_clay *c, const double p[3], double reach, const short *of, int count, short *near)
{
    double distance[KIT_BLOBS], nearest = 1e9;
    int kept = 0;
    for (int k = 0; k < count; k++) {
        distance[k] = to_blob(&c->blob[of[k]], p);
        if (!c->blob[of[k]].carved) nearest = fmin(nearest, distance[k]);
    }
    for (int k = 0; k < count; k++) {
        const kit_blob *b = &c->blob[of[k]];
        if (distance[k] < 2.3 * reach + 1.5 * b->blend + (b->carved ? 0 : fmax(0, nearest))) near[kept++] = of[k];
    }
    return kept;
}

static void fill(grid *g, const int from[3], int side, const short *near, int count, double everywhere)
{
    for (int z = from[2]; z < from[2] + side && z < g->n[2]; z++)
        for (int y = from[1]; y < from[1] + side && y < g->n[1]; y++)
            for (int x = from[0]; x < from[0] + side && x < g->n[0]; x++) {
                const double q[3] = { g->low[0] + g->cell * x, g->low[1] + g->cell * y, g->low[2] + g->cell * z };
                g->value[index_of(g, x, y, z)] = (float)(count ? to_clay(g->clay, near, count, q) : everywhere);
            }
}

/* So many samples a side, by eighths; far from the surface all have their middle's value. */
static void sample(grid *g, const int from[3], int side, const short *of, int count)
{
    const double reach = 0.5 * sqrt(3) * (side - 1) * g->cell;
    short near[KIT_BLOBS];
    double p[3];
    if (from[0] >= g->n[0] || from[1] >= g->n[1] || from[2] >= g->n[2]) return;
    for (int i = 0; i < 3; i++) p[i] = g->low[i] + g->cell * (from[i] + 0.5 * (side - 1));
    count = blobs_near(g->clay, p, reach, of, count, near);
    const double middle = to_clay(g->clay, near, count, p);
    if (fabs(middle) > 1.6 * reach + 2 * g->cell + 3 * g->clay->rough) fill(g, from, side, near, 0, middle);
    else if (side <= BRICK) fill(g, from, side, near, count, middle);
    else
        for (int k = 0; k < 8; k++) {
            const int half = side / 2,
                      at[3] = { from[0] + (k & 1) * half, from[1] + (k >> 1 & 1) * half, from[2] + (k >> 2) * half };
            sample(g, at, half, near, count);
        }
}

static void sample_all(grid *g)
{
    static const int from[3] = { 0, 0, 0 };
    short all[KIT_BLOBS];
    int side = BRICK;
    for (int k = 0; k < g->clay->blobs; k++) all[k] = (short)k;
    while (side < g->n[0] || side < g->n[1] || side < g->n[2]) side *= 2;
    sample(g, from, side, all, g->clay->blobs);
}

/* ---- >>nets ---------------------------------------------------------------------------------------------------- */

/* the mean of where the cell's edges cross the surface, in cells from its lower corner; 0: none does */
static int crossing(const float corner[8], double out[3])
{
    int crossed = 0;
    out[0] = out[1] = out[2] = 0;
    for (int k = 0; k < 8; k++)
        for (int i = 0; i < 3; i++) {
            const int to = k | 1 << i;
            if (to == k || (corner[k] < 0) == (corner[to] < 0)) continue;
            const double t = (double)corner[k] / ((double)corner[k] - (double)corner[to]);
            for (int j = 0; j < 3; j++) out[j] += i == j ? t : k >> j & 1;
            crossed++;
        }
    for (int i = 0; i < 3 && crossed; i++) out[i] /= crossed;
    return crossed;
}

/* the trilinear interpolant's gradient */
static void gradient(const float corner[8], const double at[3], double out[3])
{
    for (int i = 0; i < 3; i++) {
        const int u = (i + 1) % 3, v = (i + 2) % 3;
        out[i] = 0;
        for (int k = 0; k < 8; k++)
            out[i] += (k >> i & 1 ? 1 : -1) * (double)corner[k] * (k >> u & 1 ? at[u] : 1 - at[u])
                    * (k >> v & 1 ? at[v] : 1 - at[v]);
    }
    if (!kit_unit(out)) out[1] = 1;
}

static int add_vertex(grid *g, const int at[3], const float corner[8], const double in[3])
{
    if (g->vertices == g->room) {
        const int room = g->room ? 2 * g->room : 4096;
        kit_vertex *more = realloc(g->vertex, (size_t)room * sizeof *more);
        if (!more) return -1;
        g->vertex = more;
        g->room = room;
    }
    kit_vertex *v = &g->vertex[g->vertices];
    for (int i = 0; i < 3; i++) v->p[i] = g->low[i] + g->cell * (at[i] + in[i]);
    gradient(corner, in, v->n);
    return g->vertices++;
}

static int find_vertices(grid *g)
{
    for (int z = 0; z < g->n[2]; z++)
        for (int y = 0; y < g->n[1]; y++)
            for (int x = 0; x < g->n[0]; x++) {
                const int at[3] = { x, y, z };
                int *net = &g->net[index_of(g, x, y, z)];
                float corner[8];
                double in[3];
                *net = -1;
                if (x + 1 == g->n[0] || y + 1 == g->n[1] || z + 1 == g->n[2]) continue;
                for (int k = 0; k < 8; k++)
                    corner[k] = g->value[index_of(g, x + (k & 1), y + (k >> 1 & 1), z + (k >> 2))];
                if (crossing(corner, in) && (*net = add_vertex(g, at, corner, in)) < 0) return -1;
            }
    return 0;
}

static int is_missing(const kit_clay *c, const double p[3])
{
    for (int k = 0; k < c->cuts; k++) {
        const kit_missing *m = &c->missing[k];
        const double off[3] = { p[0] - m->n[0], p[1] - m->n[1], p[2] - m->n[2] };
        const double d = m->ball ? m->d - sqrt(kit_dot(off, off)) : kit_dot(p, m->n) - m->d;
        if (d > (m->jag > 0 ? m->jag * kit_fractal((unsigned)c->seed + 77u, 9 * p[0], 9 * p[1], 9 * p[2], 3) : 0))
            return 1;
    }
    return 0;
}

static void emit(kit_build *b, const grid *g, const kit_vertex *v0, const kit_vertex *v1, const kit_vertex *v2)
{
    const kit_clay *c = g->clay;
    kit_vertex v[3] = { *v0, *v1, *v2 };
    double middle[3], e[2][3], face[3], sum[3];
    float albedo[3];
    for (int i = 0; i < 3; i++) {
        middle[i] = (v0->p[i] + v1->p[i] + v2->p[i]) / 3;
        e[0][i] = v1->p[i] - v0->p[i];
        e[1][i] = v2->p[i] - v0->p[i];
        sum[i] = v0->n[i] + v1->n[i] + v2->n[i];
    }
    if (is_missing(c, middle)) return;
    kit_cross(e[0], e[1], face);
    if (c->facets && kit_unit(face))
        for (int k = 0; k < 3; k++)
            for (int i = 0; i < 3; i++) v[k].n[i] = kit_dot(face, sum) < 0 ? -face[i] : face[i];
    memcpy(albedo, b->albedo, sizeof albedo);
    if (c->stain > 0) {
        const double by =
            1 + c->stain * kit_fractal((unsigned)c->seed + 5u, 5 * middle[0], 5 * middle[1], 5 * middle[2], 2);
        for (int i = 0; i < 3; i++) b->albedo[i] = (float)fmax(0.02, fmin(0.92, by * (double)albedo[i]));
    }
    kit_triangle(b, &v[0], &v[1], &v[2]);
    memcpy(b->albedo, albedo, sizeof albedo);
}

static double apart(const kit_vertex *a, const kit_vertex *b)
{
    const double d[3] = { a->p[0] - b->p[0], a->p[1] - b->p[1], a->p[2] - b->p[2] };
    return kit_dot(d, d);
}

/* the quad about the edge from a corner along an axis, when the surface crosses it; cut along its shorter diagonal */
static void span(kit_build *b, const grid *g, const int at[3], int axis)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    int to[3] = { at[0], at[1], at[2] };
    const kit_vertex *c[4];
    if (++to[axis] == g->n[axis] || !at[u] || !at[v]) return;
    if ((g->value[index_of(g, at[0], at[1], at[2])] < 0) == (g->value[index_of(g, to[0], to[1], to[2])] < 0)) return;
    for (int k = 0; k < 4; k++) {
        int cell[3] = { at[0], at[1], at[2] };
        cell[u] -= k == 1 || k == 2;
        cell[v] -= k > 1;
        const int net = g->net[index_of(g, cell[0], cell[1], cell[2])];
        if (net < 0) return;
        c[k] = &g->vertex[net];
    }
    const int turned = apart(c[1], c[3]) < apart(c[0], c[2]);
    emit(b, g, c[turned], c[turned + 1], c[turned + 2]);
    emit(b, g, c[turned], c[turned + 2], c[(turned + 3) % 4]);
}

void scan_sculpt(kit_build *b, const kit_clay *c, int cells)
{
    grid g;
    int at[3];
    if (!c->blobs) return;
    if (lay_grid(&g, c, cells)) b->failed = 1;
    if (!b->failed) sample_all(&g);
    if (!b->failed && find_vertices(&g)) b->failed = 1;
    for (at[2] = 0; at[2] < g.n[2] && !b->failed; at[2]++)
        for (at[1] = 0; at[1] < g.n[1]; at[1]++)
            for (at[0] = 0; at[0] < g.n[0]; at[0]++)
                for (int axis = 0; axis < 3; axis++) span(b, &g, at, axis);
    free(g.value);
    free(g.net);
    free(g.vertex);
}
