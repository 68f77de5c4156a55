/* land.c - the ground of landscapes by seed: heights, and a mesh of them that is finer towards the middle. Declared in
   terrain.h. */
#include "kit/scene/terrain/terrain.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>noise ----------------------------------------------------------------------------------------------------- */

static double smooth(double from, double to, double x)
{
    const double t = fmax(0, fmin(1, (x - from) / (to - from)));
    return t * t * (3 - 2 * t);
}

/* to the next octave: turned, so that the lattices do not show */
static void next_octave(double *x, double *z)
{
    const double was = *x;
    *x = 2.03 * (0.8 * was - 0.6 * *z) + 17.3;
    *z = 2.03 * (0.6 * was + 0.8 * *z) - 9.1;
}

static double rolling(unsigned seed, double x, double z, int octaves)
{
    double sum = 0, size = 1;
    for (int i = 0; i < octaves; i++, size *= 2, next_octave(&x, &z))
        sum += kit_noise(seed + (unsigned)i, x, 0.5, z) / size;
    return sum;
}

/* crests where noise is 0, about [0, 1.2]; what is below a crest is smoother, as if worn */
static double ridged(unsigned seed, double x, double z, int octaves)
{
    double sum = 0, size = 1, weight = 1;
    for (int i = 0; i < octaves; i++, size *= 2, next_octave(&x, &z)) {
        const double n = fmax(0, 1 - 1.6 * fabs(kit_noise(seed + (unsigned)i, x, 0.5, z)));
        sum += weight * n * n / size;
        weight = fmin(1, 0.25 + 1.3 * n * n);
    }
    return 0.7 * sum;
}

/* steps: treads that slope a little, steep risers */
static double terraced(double q, double steps, double riser)
{
    const double s = q * steps, k = floor(s), f = s - k;
    return (k + 0.15 * f + 0.85 * smooth(1 - riser, 1, f)) / steps;
}

/* ---- >>heights: x and z in the land's unit of length, results in its unit of height ------------------------------ */

typedef struct land {
    unsigned seed;
    double rough, a, b;
} land;

static double hills(const land *l, double x, double z)
{
    const double calm = 0.25 + 0.75 * smooth(0.2, 1.6, sqrt(x * x + z * z));
    return calm * (0.55 * rolling(l->seed, 0.8 * x, 0.8 * z, 3) + l->rough * ridged(l->seed + 9, x, z, 5))
         + 0.06 * l->rough * rolling(l->seed + 20, 7 * x, 7 * z, 3);
}

static double riverbed(const land *l, double x, double z)
{
    const double d = fabs(x - 0.5 * kit_noise(l->seed, 0.7 * z, 0.5, 0) - 0.2 * kit_noise(l->seed + 1, 2 * z, 0.5, 0))
                   + 0.1 * rolling(l->seed + 2, 2 * x, 2 * z, 3);
    return 0.35 * smooth(0.3, 0.3 + 0.4 * l->a, d) + smooth(0.9, 4, d) * (0.8 + rolling(l->seed + 4, x, z, 4))
         + 0.06 * rolling(l->seed + 7, 5 * x, 3 * z, 4) + 0.1 * l->rough * ridged(l->seed + 3, 2 * x, 2 * z, 4);
}

static double canyon(const land *l, double x, double z)
{
    const double bend = 0.9 * kit_noise(l->seed, 0.5 * z, 0.5, 0) + 0.3 * kit_noise(l->seed + 1, 1.6 * z, 0.5, 0);
    const double d = fabs(x - bend) + 0.3 * rolling(l->seed + 2, 1.3 * x, 1.3 * z, 5)
                   - 0.35 * ridged(l->seed + 5, 0.9 * x, 0.9 * z, 3);
    const double q = smooth(0.2, 1.5, d) * (1 + 0.15 * rolling(l->seed + 8, 0.7 * x, 0.7 * z, 2));
    return 0.9 * terraced(q, l->a, l->b) + 0.1 * q + 0.02 * l->rough * rolling(l->seed + 6, 9 * x, 9 * z, 3);
}

static double scarp(const land *l, double x, double z)
{
    const double d = z + 0.35 * rolling(l->seed, x, z, 3);
    const double fan = 0.6 * smooth(-0.4, 1.3, d) + 0.05 * rolling(l->seed + 3, 3 * x, 3 * z, 4),
                 cliff = smooth(1, 1.25, d + 0.25 * ridged(l->seed + 5, 3 * x, z, 4));
    return fan + cliff * (1 + 0.4 * ridged(l->seed + 6, 1.5 * x, 1.5 * z, 4))
         + 0.05 * l->rough * ridged(l->seed + 7, 6 * x, 6 * z, 3)
         + 0.5 * smooth(1, 5, -d) * (1 + rolling(l->seed + 8, 0.6 * x, 0.6 * z, 4));
}

static double shore(const land *l, double x, double z)
{
    const double d = z + 0.3 * rolling(l->seed, 0.8 * x, 0.4 * z, 3), cape = smooth(1.1, 1.9, l->b * x - 0.25 * d);
    const double ripples = 0.004 * sin(55 * d + 4 * kit_noise(l->seed + 4, 3 * x, 0.5, 3 * z))
                         * smooth(1.2, 0, fabs(d));
    const double back = smooth(0.8, l->a, -d);
    return -0.13 * fmin(d, 3) + ripples + back * (0.35 + 0.6 * l->rough * ridged(l->seed + 2, 1.5 * x, 1.5 * z, 5))
         + cape * (0.2 + 1.1 * ridged(l->seed + 6, 1.2 * x, 1.2 * z, 5)) + 0.02 * rolling(l->seed + 8, 6 * x, 6 * z, 3);
}

/* long on the windward side, steep on the other */
static double dunes(const land *l, double x, double z)
{
    const double phase = 1.2 * x + 0.9 * rolling(l->seed, 0.5 * x, 0.5 * z, 2), f = phase - floor(phase);
    const double crest = f < 0.72 ? smooth(0, 0.76, f) : 1 - smooth(0.70, 1.0, f);
    const double tall = 0.55 + 0.45 * kit_noise(l->seed + 3, 0.35 * x, 0.5, 0.35 * z);
    const double ripples = sin(60 * x + 9 * kit_noise(l->seed + 5, 4 * x, 0.5, 4 * z));
    return crest * tall + 0.01 * (0.4 + l->rough) * ripples + 0.25 * rolling(l->seed + 7, 0.4 * x, 0.4 * z, 2);
}

static double mesas(const land *l, double x, double z)
{
    const double m = kit_noise(l->seed, 0.8 * x, 0.5, 0.8 * z) + 0.35 * rolling(l->seed + 1, 2 * x, 2 * z, 4)
                   - 0.5 * smooth(0.9, 0.2, sqrt(x * x + z * z));
    const double apron = 0.3 * smooth(-0.35, 0.25, m), wall = terraced(smooth(0.1, 0.3, m), l->a, l->b);
    return apron + 0.9 * wall + 0.04 * l->rough * rolling(l->seed + 6, 4 * x, 4 * z, 4)
         + 0.02 * l->rough * ridged(l->seed + 11, 5 * x, 5 * z, 3);
}

static double lava(const land *l, double x, double z)
{
    const double flow = x + 0.4 * rolling(l->seed, 0.8 * x, 0.8 * z, 3),
                 ropes = fabs(sin(14 * flow + 3 * kit_noise(l->seed + 2, 2 * x, 0.5, 2 * z)));
    const double crack = fabs(rolling(l->seed + 3, 1.5 * x, 1.5 * z, 3));
    return 0.5 * ridged(l->seed + 5, x, z, 6) + 0.35 * l->rough * ridged(l->seed + 8, 4 * x, 4 * z, 4) + 0.03 * ropes
         - 0.5 * l->a * smooth(0.06, 0, crack) + 0.5 * rolling(l->seed + 12, 0.3 * x, 0.3 * z, 2);
}

static double glacier(const land *l, double x, double z)
{
    const double phase = l->a * (z + 0.12 * x * x + 0.2 * rolling(l->seed, x, z, 3)),
                 f = fabs(phase - floor(phase) - 0.5);
    const double open = 0.10 * smooth(-0.35, 0.5, kit_noise(l->seed + 4, 1.7 * x, 0.5, 1.1 * z)) - 0.01,
                 slot = smooth(open, 0.6 * open, f) * (open > 0 ? 1 : 0);
    const double side = smooth(1.3, 3.5, fabs(x) + 0.4 * rolling(l->seed + 5, x, z, 3));
    return 0.10 * z + 0.08 * rolling(l->seed + 1, x, z, 4) - l->b * slot * (1 - side)
         + side * (0.4 + 1.8 * ridged(l->seed + 7, 0.8 * x, 0.8 * z, 6))
         + l->rough * 0.04 * ridged(l->seed + 9, 5 * x, 5 * z, 3);
}

static double quarry(const land *l, double x, double z)
{
    const double d = fmax(fabs(x), l->b * fabs(z)) + 0.12 * rolling(l->seed, 1.5 * x, 1.5 * z, 2) - 0.25;
    const double pit = terraced(fmax(0, fmin(1, 0.8 * d)), l->a, 0.12);
    const double ramp = smooth(0.16, 0.1, fabs(z - 0.3)) * smooth(0, 0.3, x);
    return (1 - ramp) * pit + ramp * fmax(0, fmin(1, 0.8 * d)) + 0.012 * l->rough * ridged(l->seed + 3, 5 * x, 5 * z, 4)
         + smooth(1.4, 5, d) * (0.4 + 0.8 * rolling(l->seed + 6, 0.6 * x, 0.6 * z, 4));
}

static double alps(const land *l, double x, double z)
{
    const double wx = x + 0.25 * rolling(l->seed + 30, 0.9 * x, 0.9 * z, 2),
                 wz = z + 0.25 * rolling(l->seed + 40, 0.9 * x, 0.9 * z, 2);
    const double vale = smooth(0.1, 1.2, fabs(wx + 0.4 * kit_noise(l->seed, 0.6 * wz, 0.5, 0)));
    return (0.12 + 0.88 * vale) * (0.15 + ridged(l->seed + 2, 0.75 * wx, 0.75 * wz, 8))
             * (0.75 + 0.35 * rolling(l->seed + 14, 0.4 * x, 0.4 * z, 2))
         + 0.02 * l->rough * ridged(l->seed + 21, 6 * x, 6 * z, 4);
}

static double plain(const land *l, double x, double z)
{
    const double away = sqrt(x * x + z * z);
    return 0.4 * rolling(l->seed, x, z, 3) + 0.12 * l->rough * rolling(l->seed + 4, 6 * x, 6 * z, 4)
         + l->a * smooth(2, 30, away) * rolling(l->seed + 6, 0.06 * x, 0.06 * z, 4);
}

double land_height(const kit_plot *p, double x, double z)
{
    static double (*const of_land[])(const land *, double, double) = {
        [KIT_HILLS] = hills,     [KIT_RIVERBED] = riverbed, [KIT_CANYON] = canyon, [KIT_SCARP] = scarp,
        [KIT_SHORE] = shore,     [KIT_DUNES] = dunes,       [KIT_MESAS] = mesas,   [KIT_LAVA] = lava,
        [KIT_GLACIER] = glacier, [KIT_QUARRY] = quarry,     [KIT_ALPS] = alps,     [KIT_PLAIN] = plain
    };
    const double *of = p->of, c = cos(of[KIT_OF_TURN]) / of[KIT_OF_LENGTH],
                 s = sin(of[KIT_OF_TURN]) / of[KIT_OF_LENGTH];
    const land l = { (unsigned)of[KIT_OF_SEED], of[KIT_OF_ROUGH], of[KIT_OF_A], of[KIT_OF_B] };
    const double u = x / of[KIT_OF_SMALL], v = z / of[KIT_OF_SMALL];
    const double patchy = smooth(-0.6, 0.6, kit_noise(l.seed + 90, 0.2 * u, 0.5, 0.2 * v));
    return of[KIT_OF_HEIGHT] * of_land[(int)of[KIT_OF_LAND]](&l, c * x + s * z, c * z - s * x)
         + of[KIT_OF_RELIEF]
               * ((1 - patchy) * rolling(l.seed + 91, u, v, 3) + 1.6 * patchy * ridged(l.seed + 95, u, v, 3));
}

/* where all is large, eyes are higher */
double land_stand(const kit_plot *p, double x, double z)
{
    return fmax(land_height(p, x, z), p->of[KIT_OF_LEVEL] + 0.01) + fmax(0, 0.2 * (p->of[KIT_OF_SMALL] - 2));
}

double land_slope(const kit_plot *p, double x, double z, double step)
{
    const double dx = land_height(p, x + step, z) - land_height(p, x - step, z),
                 dz = land_height(p, x, z + step) - land_height(p, x, z - step);
    return sqrt(dx * dx + dz * dz) / (2 * step);
}

/* ---- >>mesh ------------------------------------------------------------------------------------------------------ */

typedef struct grid {
    const kit_plot *p;
    const kit_lay *lay;
    kit_vertex *v;
    int side;
} grid;

static kit_vertex *corner(const grid *g, int i, int j)
{
    i = i < 0 ? 0 : i >= g->side ? g->side - 1 : i;
    j = j < 0 ? 0 : j >= g->side ? g->side - 1 : j;
    return &g->v[j * g->side + i];
}

static double spread(const kit_lay *l, double k)
{
    return l->reach * sinh(l->finer * (2 * k / l->cells - 1)) / sinh(l->finer);
}

static void find_normal(const grid *g, int i, int j)
{
    double along[3], down[3];
    for (int k = 0; k < 3; k++) {
        along[k] = corner(g, i + 1, j)->p[k] - corner(g, i - 1, j)->p[k];
        down[k] = corner(g, i, j + 1)->p[k] - corner(g, i, j - 1)->p[k];
    }
    kit_cross(down, along, corner(g, i, j)->n);
    kit_unit(corner(g, i, j)->n);
}

static void find_normals(const grid *g)
{
    for (int j = 0; j < g->side; j++)
        for (int i = 0; i < g->side; i++) find_normal(g, i, j);
}

static void find_heights(const grid *g, kit_build *b)
{
    for (int j = 0; j < g->side; j++)
        for (int i = 0; i < g->side; i++) {
            const double off = g->lay->facets ? 0.35 : 0;
            kit_vertex *v = corner(g, i, j);
            v->p[0] = spread(g->lay, off > 0 ? i + kit_between(b, -off, off) : i);
            v->p[2] = spread(g->lay, off > 0 ? j + kit_between(b, -off, off) : j);
            v->p[1] = land_height(g->p, v->p[0], v->p[2]);
        }
    find_normals(g);
}

/* Cliffs in layers that stand out and recede: overhangs. */
static void push_ledges(const grid *g)
{
    const unsigned seed = (unsigned)g->p->of[KIT_OF_SEED] + 77;
    for (int k = 0; k < g->side * g->side; k++) {
        kit_vertex *v = &g->v[k];
        const double steep = smooth(0.35, 0.8, 1 - v->n[1]), y = v->p[1] / g->lay->layer;
        const double by = g->lay->ledges * steep
                        * (kit_noise(seed, 0.1 * v->p[0] / g->lay->layer, 1.3 * y, 0.1 * v->p[2] / g->lay->layer)
                           + 0.5 * kit_noise(seed + 1, v->p[0] / g->lay->layer, 3 * y, v->p[2] / g->lay->layer));
        v->p[0] += by * v->n[0];
        v->p[2] += by * v->n[2];
    }
    find_normals(g);
}

/* size: of the blotches */
static void set_colour(kit_build *b, const kit_soil *s, const kit_vertex *v[3], unsigned seed, double size)
{
    double at[3], up = 0, rgb[3];
    for (int i = 0; i < 3; i++) {
        at[i] = (v[0]->p[i] + v[1]->p[i] + v[2]->p[i]) / 3;
        up += v[i]->n[1] / 3;
    }
    const double blotch = kit_noise(seed, at[0] / size, 0.5, at[2] / size);
    const double steep = smooth(0.16, 0.34, 1 - up + 0.06 * blotch),
                 high = smooth(0.95, 1.05, at[1] / s->above + 0.15 * blotch) * smooth(0.45, 0.3, 1 - up);
    const double band = s->bands > 0 ? 1 + 0.3 * steep * kit_noise(seed + 1, 0, at[1] / s->bands, 0.5) : 1;
    for (int i = 0; i < 3; i++) {
        const double ground = (1 - steep) * (double)s->level[i] + steep * (double)s->steep[i];
        rgb[i] = fmin(0.92, ((1 - high) * ground + high * (double)s->high[i]) * band * (1 + s->vary * blotch));
    }
    kit_colour(b, rgb[0], rgb[1], rgb[2]);
}

static void add_triangle(kit_plot *p, const kit_soil *soil, const kit_vertex *a, const kit_vertex *b,
                         const kit_vertex *c, int facets)
{
    const kit_vertex *v[3] = { a, b, c };
    kit_vertex flat[3] = { *a, *b, *c };
    double e1[3], e2[3], n[3];
    set_colour(&p->b, soil, v, (unsigned)p->of[KIT_OF_SEED] + 50, 0.2 * p->of[KIT_OF_LENGTH]);
    if (facets) {
        for (int i = 0; i < 3; i++) {
            e1[i] = b->p[i] - a->p[i];
            e2[i] = c->p[i] - a->p[i];
        }
        kit_cross(e1, e2, n);
        kit_unit(n);
        for (int k = 0; k < 3; k++) memcpy(flat[k].n, n, sizeof n);
    }
    kit_triangle(&p->b, &flat[0], &flat[1], &flat[2]);
}

void land_build(kit_plot *p, const kit_soil *soil, const kit_lay *lay)
{
    grid g = { p, lay, NULL, lay->cells + 1 };
    if ((g.v = malloc((size_t)g.side * (size_t)g.side * sizeof *g.v)) == NULL) {
        p->b.failed = 1;
        return;
    }
    find_heights(&g, &p->b);
    if (lay->ledges > 0) push_ledges(&g);
    for (int j = 0; j < lay->cells; j++)
        for (int i = 0; i < lay->cells; i++) {
            const kit_vertex *c[4] = { corner(&g, i, j), corner(&g, i, j + 1), corner(&g, i + 1, j + 1),
                                       corner(&g, i + 1, j) };
            const int turn = lay->facets ? (i + j) & 1 : 0;
            add_triangle(p, soil, c[turn], c[1 + turn], c[2 + turn], lay->facets);
            add_triangle(p, soil, c[turn], c[2 + turn], c[(3 + turn) & 3], lay->facets);
        }
    free(g.v);
}
