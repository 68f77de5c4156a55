/* rocks.c - stones as they lie, as they are cut and as they were laid: boulders, menhirs, cairns, arches, basalt,
   ruins. Declared in terrain.h. */
#include "kit/scene/terrain/terrain.h"
#include <math.h>
#include <string.h>

static unsigned draw_seed(kit_build *b) { return (unsigned)(kit_chance(b) * 1e6); }

/* flat, its normal away from what is given */
static void add_flat(kit_build *b, const double p[3][3], const double from[3])
{
    kit_vertex v[3];
    double e1[3], e2[3], n[3], out[3];
    for (int i = 0; i < 3; i++) {
        e1[i] = p[1][i] - p[0][i];
        e2[i] = p[2][i] - p[0][i];
        out[i] = p[0][i] - from[i];
    }
    kit_cross(e1, e2, n);
    if (!kit_unit(n)) return;
    for (int k = 0; k < 3; k++)
        for (int i = 0; i < 3; i++) {
            v[k].p[i] = p[k][i];
            v[k].n[i] = kit_dot(n, out) < 0 ? -n[i] : n[i];
        }
    kit_triangle(b, &v[0], &v[1], &v[2]);
}

/* ---- >>rough ----------------------------------------------------------------------------------------------------- */

static void roughened(const kit_rough *r, double u, double v, kit_vertex *out)
{
    r->base(r->shape, u, v, out);
    const double *p = out->p, k = r->scale, by = r->by * kit_fractal(r->seed, k * p[0], k * p[1], k * p[2], r->octaves);
    for (int i = 0; i < 3; i++) out->p[i] += by * out->n[i];
}

void land_rough_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const kit_rough *r = shape;
    const double e = 2e-3, s = v > 0.5 ? -e : e;
    kit_vertex at_u, at_v;
    double du[3], dv[3], n[3];
    roughened(r, u, v, out);
    roughened(r, u + e, v, &at_u);
    roughened(r, u, v + s, &at_v);
    for (int i = 0; i < 3; i++) {
        du[i] = at_u.p[i] - out->p[i];
        dv[i] = (at_v.p[i] - out->p[i]) * (s < 0 ? -1 : 1);
    }
    kit_cross(du, dv, n);
    if (!(kit_dot(n, n) > 1e-24) || !kit_unit(n)) return;
    const double way = kit_dot(n, out->n) < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) out->n[i] = way * n[i];
}

/* ---- >>boulders -------------------------------------------------------------------------------------------------- */

typedef struct boulder {
    double half[3], rough, layers;
    unsigned seed;
} boulder;

static void boulder_point(const boulder *s, const double way[3], double out[3])
{
    double d[3] = { way[0], way[1], way[2] };
    kit_unit(d);
    const double lump = kit_fractal(s->seed, 1.4 * d[0], 1.4 * d[1], 1.4 * d[2], 3),
                 cleft = fabs(kit_noise(s->seed + 7, 1.2 * d[0], 1.2 * d[1], 1.2 * d[2])),
                 layer = s->layers * sin(16 * d[1] + 2 * kit_noise(s->seed + 9, d[0], d[1], d[2]));
    const double r = 1 + s->rough * (0.5 * lump - 0.7 * exp(-8 * cleft) + 0.25) + layer;
    for (int i = 0; i < 3; i++) out[i] = s->half[i] * r * d[i];
}

static void boulder_vertex(const boulder *s, const double d[3], int facets, kit_vertex *out)
{
    double side[2][3], n[3];
    boulder_point(s, d, out->p);
    memcpy(out->n, out->p, sizeof n);
    if (facets) return;
    for (int k = 0; k < 2; k++) {
        const double e = 0.02;
        double near[3], axis[3] = { 0 };
        axis[fabs(d[0]) < fabs(d[1]) ? 0 : 1] = 1;
        kit_cross(d, axis, near);
        if (k) {
            double other[3];
            kit_cross(d, near, other);
            memcpy(near, other, sizeof near);
        }
        kit_unit(near);
        for (int i = 0; i < 3; i++) near[i] = d[i] + e * near[i];
        boulder_point(s, near, side[k]);
        for (int i = 0; i < 3; i++) side[k][i] -= out->p[i];
    }
    kit_cross(side[0], side[1], n);
    if (!kit_unit(n)) return;
    const double way = kit_dot(n, out->p) < 0 ? -1 : 1;
    for (int i = 0; i < 3; i++) out->n[i] = way * n[i];
}

enum { BOULDER_CELLS = 32 };

/* an eighth of it: the side of an octahedron, in rows */
static void boulder_side(kit_build *b, const boulder *s, const double sign[3], int cells, int facets)
{
    static const double middle[3] = { 0, 0, 0 };
    kit_vertex row[2][BOULDER_CELLS + 1];
    for (int j = 0; j <= cells; j++) {
        for (int i = 0; i <= cells - j; i++) {
            double d[3] = { sign[0] * i, sign[1] * j, sign[2] * (cells - i - j) };
            kit_unit(d);
            boulder_vertex(s, d, facets, &row[j & 1][i]);
        }
        const kit_vertex *now = row[j & 1], *old = row[~j & 1];
        for (int i = 0; i <= cells - j && j; i++)
            for (int k = 0; k < 2; k++) {
                const kit_vertex *v[3] = { &old[i + k], &now[i], k ? &now[i + 1] : &old[i + 1] };
                if (k && i == cells - j) continue;
                const double p[3][3] = { { v[0]->p[0], v[0]->p[1], v[0]->p[2] },
                                         { v[1]->p[0], v[1]->p[1], v[1]->p[2] },
                                         { v[2]->p[0], v[2]->p[1], v[2]->p[2] } };
                if (facets) add_flat(b, p, middle);
                else kit_triangle(b, v[0], v[1], v[2]);
            }
    }
}

void land_rock(kit_build *b, const double half[3], double rough, double layers, int cells, int facets)
{
    const boulder s = { { half[0], half[1], half[2] }, rough, layers, draw_seed(b) };
    for (int k = 0; k < 8; k++) {
        const double sign[3] = { k & 1 ? 1 : -1, k & 2 ? 1 : -1, k & 4 ? 1 : -1 };
        boulder_side(b, &s, sign, cells < BOULDER_CELLS ? cells : BOULDER_CELLS, facets);
    }
}

/* ---- >>cut stones: what lies behind every one of some planes ----------------------------------------------------- */

enum { PLANES = 24, CORNERS = 32 };

typedef struct plane {
    double n[3], off;
} plane;

/* what of a polygon lies behind a plane; how many corners that has */
static int clipped(double poly[CORNERS][3], int count, const plane *by)
{
    double out[CORNERS][3];
    int kept = 0;
    for (int k = 0; k < count && kept < CORNERS - 2; k++) {
        const double *p = poly[k], *q = poly[(k + 1) % count];
        const double a = kit_dot(p, by->n) - by->off, c = kit_dot(q, by->n) - by->off;
        if (a <= 0) memcpy(out[kept++], p, sizeof out[0]);
        if ((a < 0 && c > 0) || (a > 0 && c < 0)) {
            for (int i = 0; i < 3; i++) out[kept][i] = p[i] + (q[i] - p[i]) * a / (a - c);
            kept++;
        }
    }
    memcpy(poly, out, (size_t)kept * sizeof out[0]);
    return kept;
}

/* a square of the plane, far larger than the stone */
static void square_of(const plane *s, double poly[CORNERS][3])
{
    double u[3], v[3], axis[3] = { 0 };
    axis[fabs(s->n[0]) < 0.7 ? 0 : 1] = 1;
    kit_cross(s->n, axis, u);
    kit_unit(u);
    kit_cross(s->n, u, v);
    for (int k = 0; k < 4; k++)
        for (int i = 0; i < 3; i++)
            poly[k][i] = s->off * s->n[i] + 9 * ((k == 1 || k == 2 ? 1 : -1) * u[i] + (k > 1 ? 1 : -1) * v[i]);
}

static void cut_by(kit_build *b, const plane *planes, int count, const double half[3])
{
    static const double middle[3] = { 0, 0, 0 };
    for (int k = 0; k < count; k++) {
        double poly[CORNERS][3];
        int corners = 4;
        square_of(&planes[k], poly);
        for (int j = 0; j < count && corners > 2; j++)
            if (j != k) corners = clipped(poly, corners, &planes[j]);
        for (int c = 1; c + 1 < corners; c++) {
            double p[3][3];
            for (int i = 0; i < 3; i++) {
                p[0][i] = half[i] * poly[0][i];
                p[1][i] = half[i] * poly[c][i];
                p[2][i] = half[i] * poly[c + 1][i];
            }
            add_flat(b, (const double(*)[3])p, middle);
        }
    }
}

void land_cut_stone(kit_build *b, const double half[3], int cuts, double deep)
{
    plane planes[PLANES];
    int count = 0;
    for (int k = 0; k < 6; k++) {
        plane *s = &planes[count++];
        for (int i = 0; i < 3; i++) s->n[i] = kit_between(b, -0.16, 0.16);
        s->n[k / 2] = k & 1 ? -1 : 1;
        kit_unit(s->n);
        s->off = kit_between(b, 0.85, 1);
    }
    while (count < PLANES && cuts-- > 0) {
        plane *s = &planes[count++];
        double least = 0;
        for (int i = 0; i < 3; i++) {
            s->n[i] = (kit_odds(b, 0.5) ? 1 : -1) * kit_between(b, 0.15, 1);
            least = fmax(least, fabs(s->n[i]));
        }
        kit_unit(s->n);
        /* from a box's corner towards its middle */
        s->off = (fabs(s->n[0]) + fabs(s->n[1]) + fabs(s->n[2])) * (1 - deep * kit_between(b, 0.3, 1));
    }
    cut_by(b, planes, count, half);
}

/* ---- >>stones that were put somewhere ---------------------------------------------------------------------------- */

void land_menhir(kit_build *b, double width, double thick, double height)
{
    plane planes[12];
    const double half[3] = { 0.5 * width, height, 0.5 * thick };
    int count = 0;
    planes[count++] = (plane){ { 0, -1, 0 }, 0.3 }; /* what is in the ground */
    for (int k = 0; k < 9; k++) {
        const double a = 2 * KIT_PI * (k + kit_between(b, -0.3, 0.3)) / 9;
        plane *s = &planes[count++];
        *s = (plane){ { cos(a), kit_between(b, 0, 0.25), sin(a) }, kit_between(b, 0.8, 1) };
        kit_unit(s->n);
    }
    for (int k = 0; k < 2; k++) {
        plane *s = &planes[count++];
        *s = (plane){ { kit_between(b, -0.35, 0.35), 1, kit_between(b, -0.35, 0.35) }, kit_between(b, 0.8, 1) };
        kit_unit(s->n);
    }
    cut_by(b, planes, count, half);
}

void land_cairn(kit_build *b, double radius, int stones)
{
    double y = 0;
    for (int k = 0; k < stones; k++) {
        const double r = radius * (1 - 0.75 * k / stones),
                     half[3] = { r * kit_between(b, 0.8, 1.1), r * kit_between(b, 0.25, 0.5),
                                 r * kit_between(b, 0.7, 1.0) };
        kit_place_at(b, 0.12 * r * kit_between(b, -1, 1), y + 0.9 * half[1], 0.12 * r * kit_between(b, -1, 1),
                     kit_between(b, 0, 360));
        if (k & 1) land_cut_stone(b, half, 8, 0.35);
        else land_rock(b, half, 0.12, 0, 6, 0);
        y += 1.75 * half[1];
    }
}

/* half a ring that stands, its feet in the ground */
static void arch_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = KIT_PI * (1.2 * u - 0.1), t = 2 * KIT_PI * fmod(v + 1, 1),
                 thick = s[1] * (0.7 + 0.6 * fabs(cos(a)));
    out->n[0] = cos(t) * cos(a);
    out->n[1] = cos(t) * sin(a);
    out->n[2] = sin(t);
    out->p[0] = (s[0] + thick * cos(t)) * cos(a);
    out->p[1] = s[2] * (s[0] + thick * cos(t)) * sin(a);
    out->p[2] = thick * sin(t) * 0.8;
}

void land_arch(kit_build *b, double radius, double thick, int cells)
{
    const double shape[3] = { radius, thick, kit_between(b, 0.7, 1.2) };
    const kit_rough r = { arch_surface, shape, draw_seed(b), 1.2 / thick, 0.35 * thick, 4 };
    kit_patch(b, 2 * cells, cells, land_rough_surface, &r);
}

/* from radius at the foot to a round top */
static void spire_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = 2 * KIT_PI * u, h = fmax(0, fmin(1, v)),
                 r = s[0] * (1 - h) * (0.35 + 0.65 * (1 - h)) + 0.45 * s[0] * sqrt(h * (1 - h));
    out->p[0] = r * cos(a);
    out->p[1] = s[1] * (1.05 * h - 0.05);
    out->p[2] = r * sin(a);
    out->n[0] = cos(a);
    out->n[1] = 0.2 + 3 * h * h * h * h;
    out->n[2] = sin(a);
    kit_unit(out->n);
}

/* u is a whole turn: its noise is of the place, so its ends meet */
void land_spire(kit_build *b, double radius, double height, double rough, int cells)
{
    const double shape[2] = { radius, height };
    const kit_rough r = { spire_surface, shape, draw_seed(b), 0.9 / radius, rough * radius, 4 };
    kit_patch(b, cells, 2 * cells, land_rough_surface, &r);
}

/* six-sided columns that stand close, higher towards the middle */
void land_basalt_columns(kit_build *b, double radius, int rows, double height)
{
    const double step = radius / (rows + 0.5), size = 0.565 * step;
    const unsigned seed = draw_seed(b);
    for (int j = -rows; j <= rows; j++)
        for (int i = -rows; i <= rows; i++) {
            const double x = step * (i + 0.5 * (j & 1)), z = 0.866 * step * j, away = sqrt(x * x + z * z) / radius;
            double outline[6][2];
            if (away > 1 + 0.2 * kit_noise(seed, 3 * x / radius, 0, 3 * z / radius)) continue;
            const double tall = height * (1 - 0.8 * away * away)
                                  * (0.55 + 0.45 * kit_noise(seed + 1, 2 * x / radius, 0, 2 * z / radius))
                              + kit_between(b, 0, 0.5) * step;
            for (int k = 0; k < 6; k++) {
                const double a = KIT_PI * (k + 0.5) / 3 + kit_between(b, -0.06, 0.06);
                outline[k][0] = size * cos(a);
                outline[k][1] = -size * sin(a);
            }
            kit_place_at(b, x, -0.3 * height, z, 0);
            kit_prism(b, (const double(*)[2])outline, 6, 0.3 * height + fmax(0.1 * step, tall));
        }
}

/* ---- >>ruins ----------------------------------------------------------------------------------------------------- */

void land_ruined_wall(kit_build *b, double length, double height, double thick, double course, int bevelled)
{
    const unsigned seed = draw_seed(b);
    const int opening = kit_odds(b, 0.6), rows = (int)(height / course);
    const double from = kit_between(b, 0.25, 0.5) * length, to = from + kit_between(b, 0.8, 1.6),
                 head = kit_between(b, 0.55, 0.9) * height, sill = kit_odds(b, 0.5) ? 0 : 0.3 * height;
    for (int j = 0; j < rows; j++)
        for (double x = j & 1 ? -0.3 * course : 0, wide; x < length; x += wide) {
            wide = course * kit_between(b, 1.1, 2.6);
            const double y = j * course, m = x + 0.5 * wide;
            if (y > height * (0.62 + 0.55 * kit_noise(seed, 0.45 * m / height * 3, 0, 0.5))) continue;
            if (opening && m > from && m < to && y >= sill && y < head) continue;
            const double g = 0.006, out = kit_between(b, -0.025, 0.025), deep = 0.5 * thick + out;
            if (bevelled) kit_bevelled(b, x + g, y, -deep, x + wide - g, y + course - g, deep, 0.06 * course);
            else kit_box(b, x + g, y, -deep, x + wide - g, y + course - g, deep);
        }
}

/* fluted: shape: radius at the foot, height, how much a slanted break takes, its direction */
static void drum_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = 2 * KIT_PI * u, flute = fabs(sin(10 * a)),
                 r = s[0] * (1 - 0.12 * v) * (0.94 + 0.06 * sqrt(flute));
    const double top = s[1] * (1 - s[2] * (0.5 + 0.5 * cos(a - s[3]) + 0.15 * sin(7 * a)));
    out->p[0] = r * cos(a);
    out->p[1] = v * top;
    out->p[2] = r * sin(a);
    out->n[0] = cos(a);
    out->n[1] = 0;
    out->n[2] = sin(a);
}

static void drum_top(const void *shape, double u, double v, kit_vertex *out)
{
    kit_vertex rim;
    drum_surface(shape, u, 1, &rim);
    const double *s = shape;
    out->p[0] = v * rim.p[0];
    out->p[2] = v * rim.p[2];
    out->p[1] = v * rim.p[1] + (1 - v) * s[1] * (1 - 0.5 * s[2]);
    out->n[0] = out->n[2] = 0;
    out->n[1] = 1;
}

void land_drum_column(kit_build *b, double radius, double height, int broken)
{
    const double shape[4] = { radius, height, broken ? kit_between(b, 0.05, 0.25) : 0, kit_between(b, 0, 2 * KIT_PI) };
    const kit_rough flutes = { drum_surface, shape, 0, 1, 0, 0 };
    kit_patch(b, 60, 4, land_rough_surface, &flutes);
    kit_patch(b, 60, 2, drum_top, shape);
}
