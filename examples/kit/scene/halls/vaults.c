/* vaults.c - vaults, roofs, floors, stairs and rails of halls by seed. Declared in halls.h. */
#include "kit/scene/halls/halls.h"
#include <math.h>

/* ---- >>vaults ---------------------------------------------------------------------------------------------------- */

/* q = sin(angle): where the vault is, at half * q, rise * arch(q), and its normal, inwards */
static void on_vault(double half, double rise, int pointed, double angle, double at[2], double normal[2])
{
    const double e = 1e-3, low = fmax(-0.5 * KIT_PI, angle - e), high = fmin(0.5 * KIT_PI, angle + e), q = sin(angle);
    at[0] = half * q;
    at[1] = rise * hall_arch(pointed, q);
    normal[0] = rise * (hall_arch(pointed, sin(high)) - hall_arch(pointed, sin(low)));
    normal[1] = -half * (sin(high) - sin(low));
}

typedef struct vault {
    double length, half, rise;
    int pointed;
} vault;

static void barrel_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const vault *s = shape;
    double at[2], n[2];
    on_vault(s->half, s->rise, s->pointed, KIT_PI * (v - 0.5), at, n);
    out->p[0] = s->length * u;
    out->p[1] = at[1];
    out->p[2] = at[0];
    out->n[0] = 0;
    out->n[1] = n[1];
    out->n[2] = n[0];
    kit_unit(out->n);
}

void hall_barrel(kit_build *b, double length, double half, double rise, int pointed, int cells)
{
    const vault s = { length, half, rise, pointed };
    kit_patch(b, 1, cells, barrel_surface, &s);
}

void hall_rib(kit_build *b, double half, double rise, int pointed, double wide, double deep)
{
    enum { PIECES = 20 };

    for (int k = 0; k < PIECES; k++) {
        double p[2][2], n[2][2], in[2][2];
        for (int e = 0; e < 2; e++) {
            on_vault(half, rise, pointed, KIT_PI * ((double)(k + e) / PIECES - 0.5), p[e], n[e]);
            const double length = sqrt(n[e][0] * n[e][0] + n[e][1] * n[e][1]);
            for (int i = 0; i < 2; i++) in[e][i] = p[e][i] + deep * n[e][i] / length;
        }
        for (int side = -1; side < 2; side += 2) {
            const double x = 0.5 * side * wide;
            const double flank[4][3] = {
                { x, p[0][1], p[0][0] }, { x, in[0][1], in[0][0] }, { x, in[1][1], in[1][0] }, { x, p[1][1], p[1][0] }
            };
            const double other[4][3] = {
                { x, p[1][1], p[1][0] }, { x, in[1][1], in[1][0] }, { x, in[0][1], in[0][0] }, { x, p[0][1], p[0][0] }
            };
            kit_quad(b, side > 0 ? flank : other);
        }
        const double under[4][3] = { { -0.5 * wide, in[0][1], in[0][0] },
                                     { 0.5 * wide, in[0][1], in[0][0] },
                                     { 0.5 * wide, in[1][1], in[1][0] },
                                     { -0.5 * wide, in[1][1], in[1][0] } };
        kit_quad(b, under);
    }
}

typedef struct web {
    double half[2], rise;
    int pointed, turned, other;
} web;

static void web_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const web *w = shape;
    const double far = 0.5 * KIT_PI * v;
    double at[2], n[2];
    on_vault(w->half[0], w->rise, w->pointed, (2 * u - 1) * far, at, n);
    const double across = w->half[1] * sin(far) * (w->other ? -1 : 1);
    out->p[w->turned ? 2 : 0] = at[0];
    out->p[1] = at[1];
    out->p[w->turned ? 0 : 2] = across;
    out->n[w->turned ? 2 : 0] = n[0];
    out->n[1] = n[1];
    out->n[w->turned ? 0 : 2] = 0;
    if (!kit_unit(out->n)) out->n[1] = -1;
}

void hall_groin(hall *h, double half_x, double half_z, double rise)
{
    kit_build *b = h->b;
    hall_paint(h, HALL_VAULT);
    for (int k = 0; k < 4; k++) {
        const web w = { { k & 1 ? half_z : half_x, k & 1 ? half_x : half_z }, rise, h->pointed, k & 1, k >> 1 };
        kit_patch(b, 12, 8, web_surface, &w);
    }
    if (!h->ribs) return;
    hall_paint(h, HALL_STONE);
    for (int side = -1; side < 2; side += 2) {
        double at[21][3];
        for (int k = 0; k <= 20; k++) {
            const double q = sin(KIT_PI * (k / 20.0 - 0.5));
            at[k][0] = half_x * q;
            at[k][2] = side * half_z * q;
            at[k][1] = rise * hall_arch(h->pointed, q) - 0.03;
        }
        kit_tube(b, (const double(*)[3])at, 21, 0.09, 6);
    }
    static const double boss = 0.2;
    kit_place_at(b, 0, rise - 0.08, 0, 0);
    kit_patch(b, 10, 6, kit_sphere_surface, &boss);
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>roofs ----------------------------------------------------------------------------------------------------- */

static void plane_below(kit_build *b, const double r[4], double y)
{
    const double c[4][3] = { { r[0], y, r[1] }, { r[2], y, r[1] }, { r[2], y, r[3] }, { r[0], y, r[3] } };
    kit_quad(b, c);
}

/* Beams both ways; those along z end at those along x. */
static void grid(hall *h, const double r[4], double y, int nx, int nz, double wide, double deep)
{
    kit_build *b = h->b;
    const double dz = (r[3] - r[1]) / nz, dx = (r[2] - r[0]) / nx;
    for (int j = 0; j <= nz; j++) {
        const double z = r[1] + dz * j;
        kit_box(b, r[0], y - deep, z - 0.5 * wide, r[2], y, z + 0.5 * wide);
        for (int i = 0; i <= nx && j < nz; i++) {
            const double x = r[0] + dx * i;
            kit_box(b, x - 0.5 * wide, y - deep, z + 0.5 * wide, x + 0.5 * wide, y, z + dz - 0.5 * wide);
        }
    }
}

static void coffers(hall *h, const double r[4], double y, int nx, int nz)
{
    kit_build *b = h->b;
    const double dx = (r[2] - r[0]) / nx, dz = (r[3] - r[1]) / nz, deep = 0.2 + 0.08 * dx, knob = 0.06 + 0.03 * dx;
    hall_paint(h, HALL_VAULT);
    plane_below(b, r, y + deep);
    hall_paint(h, HALL_TRIM);
    grid(h, r, y + deep, nx, nz, 0.3, deep);
    for (int i = 0; i < nx * nz && h->ribs; i++) {
        kit_place_at(b, r[0] + dx * (i % nx + 0.5), y + deep, r[1] + dz * (i / nx + 0.5), 0);
        kit_patch(b, 10, 5, kit_sphere_surface, &knob);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

static void beams(hall *h, const double r[4], double y, int bays)
{
    kit_build *b = h->b;
    const double dx = (r[2] - r[0]) / bays, deep = 0.18 + 0.03 * (r[3] - r[1]);
    hall_paint(h, HALL_VAULT);
    plane_below(b, r, y + deep + 0.14);
    for (int i = 0; i <= bays; i++) {
        const double x = r[0] + dx * i;
        hall_paint(h, HALL_WOOD);
        kit_bevelled(b, x - 0.16, y, r[1], x + 0.16, y + deep, r[3], 0.03);
    }
    for (double z = r[1] + 0.3; z < r[3]; z += 0.62) kit_box(b, r[0], y + deep, z, r[2], y + deep + 0.14, z + 0.11);
}

/* across z from -half to half, on y = 0 */
static void truss(hall *h, double half, double rise, int steel)
{
    kit_build *b = h->b;
    const double w = steel ? 0.12 : 0.24, d = steel ? 0.14 : 0.3;
    const double foot[2][3] = { { 0, 0, -half }, { 0, 0, half } }, top[3] = { 0, rise, 0 };
    const int panels = steel ? 8 : 4;
    double low[3] = { 0 }, high[3] = { 0 }, last[3] = { 0, 0, -half };
    hall_bar(b, foot[0], foot[1], w, d);
    for (int k = 0; k < 2; k++) hall_bar(b, foot[k], top, w * 0.98, d);
    for (int k = 1; k < panels; k++) {
        const double z = half * (2.0 * k / panels - 1);
        low[2] = high[2] = z;
        high[1] = rise * (1 - fabs(z) / half);
        hall_bar(b, low, high, 0.7 * w, 0.6 * d);
        if (k > 1) hall_bar(b, z <= 0 ? last : high, z <= 0 ? high : last, 0.5 * w, 0.5 * d);
        last[2] = z;
        last[1] = z < 0 ? 0 : 0;
    }
}

static void trusses(hall *h, const double r[4], double y, int bays)
{
    kit_build *b = h->b;
    const double half = 0.5 * (r[3] - r[1]), rise = half * kit_between(b, 0.35, 0.7), mid = 0.5 * (r[1] + r[3]);
    const int steel = h->column == HALL_IRON || h->column == HALL_PLAIN;
    const int glazed = kit_odds(b, 0.5);
    for (int side = -1; side < 2; side += 2) {
        const double z = mid + side * half, over = 0.3, g = mid + 0.5 * side * half;
        const double c[2][3] = { { r[0], y + over, z }, { r[0], y + over + rise, mid } };
        double q[4][3] = {
            { c[0][0], c[0][1], z }, { r[2], c[0][1], z }, { r[2], c[1][1], mid }, { r[0], c[1][1], mid }
        };
        hall_paint(h, HALL_VAULT);
        if (side > 0)
            for (int k = 0; k < 4; k++) q[k][0] = r[0] + r[2] - q[k][0];
        kit_quad(b, (const double(*)[3])q);
        hall_paint(h, steel ? HALL_METAL : HALL_WOOD);
        for (int k = 1; k < 7; k++) { /* purlins */
            const double t = k / 7.0, from[3] = { r[0], y + over + t * rise - 0.07, z + t * (mid - z) };
            const double to[3] = { r[2], from[1], from[2] };
            hall_bar(b, from, to, 0.1, 0.14);
        }
        for (int i = 0; i < bays && glazed; i++) { /* roof lights */
            const double dx = (r[2] - r[0]) / bays, x0 = r[0] + dx * (i + 0.15), x1 = x0 + 0.7 * dx;
            const double lift = y + over + 0.5 * rise - 0.02, e = 0.2 * half;
            double pane[4][3] = { { x0, lift - 0.2 * rise, g + side * e },
                                  { x1, lift - 0.2 * rise, g + side * e },
                                  { x1, lift + 0.2 * rise, g - side * e },
                                  { x0, lift + 0.2 * rise, g - side * e } };
            hall_paint(h, HALL_GLASS);
            if (side > 0)
                for (int k = 0; k < 4; k++) pane[k][0] = x0 + x1 - pane[k][0];
            kit_quad(b, (const double(*)[3])pane);
        }
    }
    hall_paint(h, steel ? HALL_METAL : HALL_WOOD);
    const int count = steel ? bays : bays + 1;
    for (int i = 0; i <= count; i++) {
        const kit_frame f = kit_enter(b, r[0] + (r[2] - r[0]) * i / count, y, mid, 0, 1);
        truss(h, half, rise, steel);
        kit_leave(b, f);
    }
}

static void skylight(hall *h, const double r[4], double y, int bays)
{
    kit_build *b = h->b;
    const double in = fmin(1.6, 0.25 * (r[3] - r[1])), lift = 0.9;
    const double inner[4] = { r[0] + in, r[1] + in, r[2] - in, r[3] - in };
    const double c[4][3] = { { r[0], y, r[1] }, { r[2], y, r[1] }, { r[2], y, r[3] }, { r[0], y, r[3] } };
    const double i[4][3] = {
        { inner[0], y, inner[1] }, { inner[2], y, inner[1] }, { inner[2], y, inner[3] }, { inner[0], y, inner[3] }
    };
    for (int k = 0; k < 4; k++) {
        const int n = (k + 1) % 4;
        const double border[4][3] = {
            { c[k][0], y, c[k][2] }, { c[n][0], y, c[n][2] }, { i[n][0], y, i[n][2] }, { i[k][0], y, i[k][2] }
        };
        const double upright[4][3] = { { i[k][0], y, i[k][2] },
                                       { i[n][0], y, i[n][2] },
                                       { i[n][0], y + lift, i[n][2] },
                                       { i[k][0], y + lift, i[k][2] } };
        hall_paint(h, HALL_VAULT);
        kit_quad(b, border);
        kit_quad(b, upright);
    }
    hall_paint(h, HALL_GLASS);
    plane_below(b, inner, y + lift);
    hall_paint(h, HALL_METAL);
    grid(h, inner, y + lift, 2 * bays, (int)(1.4 * (inner[3] - inner[1])) + 1, 0.06, 0.16);
    hall_paint(h, HALL_TRIM);
    kit_box(b, r[0], y - 0.35, r[1], r[2], y - 0.01, r[1] + 0.3);
    kit_box(b, r[0], y - 0.35, r[3] - 0.3, r[2], y - 0.01, r[3]);
}

/* a barrel, or groins, bay by bay, with ribs between them */
static void vaulted(hall *h, int kind, const double r[4], double y, int bays)
{
    kit_build *b = h->b;
    const double length = r[2] - r[0], bay = length / bays, half = 0.5 * (r[3] - r[1]), mid = 0.5 * (r[1] + r[3]);
    const double rise = half * (h->pointed ? 1.15 : 0.85);
    for (int i = 0; i <= bays; i++) {
        const kit_frame f = kit_enter(b, r[0] + bay * i, y, mid, 0, 1);
        hall_paint(h, HALL_STONE);
        hall_rib(b, half, rise, h->pointed, kind == HALL_BARREL ? 0.45 : 0.3, 0.18);
        hall_paint(h, HALL_VAULT);
        if (kind == HALL_BARREL && i < bays) hall_barrel(b, bay, half, rise, h->pointed, 28);
        kit_place_at(b, 0, 0, 0, 0);
        kit_leave(b, f);
        if (kind == HALL_BARREL || i == bays) continue;
        const kit_frame g = kit_enter(b, r[0] + bay * (i + 0.5), y, mid, 0, 1);
        hall_groin(h, 0.5 * bay, half, rise);
        kit_leave(b, g);
    }
    hall_paint(h, HALL_TRIM);
    for (int side = 0; side < 2 && kind == HALL_BARREL; side++) { /* lengthwise ribs and a cornice */
        const double z = side ? r[3] - 0.25 : r[1];
        kit_bevelled(b, r[0], y - 0.25, z, r[2], y, z + 0.25, 0.06);
    }
    for (int k = 1; k < 8 && kind == HALL_BARREL && h->ribs; k++) {
        const double q = sin(KIT_PI * (k / 8.0 - 0.5)),
                     from[3] = { r[0], y + rise * hall_arch(h->pointed, q), mid + half * q };
        const double to[3] = { r[2], from[1], from[2] };
        hall_bar(b, from, to, 0.28, 0.28);
    }
}

void hall_roof(hall *h, int kind, const double r[4], double y, int bays)
{
    const double bay = (r[2] - r[0]) / bays;
    const int across = (int)((r[3] - r[1]) / bay + 0.5);
    kit_begin_object(h->b, "roof", 0);
    if (kind == HALL_COFFERS) coffers(h, r, y, bays * 2, across < 1 ? 2 : across * 2);
    if (kind == HALL_BEAMS) beams(h, r, y, bays);
    if (kind == HALL_TRUSSES) trusses(h, r, y, bays);
    if (kind == HALL_SKYLIGHT) skylight(h, r, y, bays);
    if (kind == HALL_BARREL || kind == HALL_GROIN) vaulted(h, kind, r, y, bays);
}

void hall_shell(hall *h, const double r[4], double low, double high, int top)
{
    kit_build *b = h->b;
    const double c[4][2] = { { r[0], r[1] }, { r[2], r[1] }, { r[2], r[3] }, { r[0], r[3] } };
    hall_paint(h, HALL_WALL);
    for (int k = 0; k < 4; k++) {
        const double *p = c[k], *q = c[(k + 1) % 4];
        const double wall[4][3] = {
            { p[0], low, p[1] }, { q[0], low, q[1] }, { q[0], high, q[1] }, { p[0], high, p[1] }
        };
        kit_quad(b, wall);
    }
    if (top) plane_below(b, r, high);
}

/* ---- >>floors, stairs, rails ------------------------------------------------------------------------------------- */

/* one plane; tiles of two colours; bands */
void hall_floor(hall *h, const double r[4])
{
    kit_build *b = h->b;
    const double tile = h->floor == 2 ? 0.9 : 1.6;
    hall_paint(h, HALL_FLOOR);
    if (h->floor == 0) {
        kit_level(b, r[0], r[1], r[2], r[3], 0);
        return;
    }
    const int nx = (int)ceil((r[2] - r[0]) / tile), nz = (int)ceil((r[3] - r[1]) / tile);
    const double dx = (r[2] - r[0]) / nx, dz = (r[3] - r[1]) / nz;
    for (int j = 0; j < nz; j++)
        for (int i = 0; i < nx; i++) {
            if (h->floor == 3 && i) continue;
            hall_paint(h, (h->floor == 3 ? j % 3 == 0 : (i + j) & 1) ? HALL_TILE : HALL_FLOOR);
            kit_level(b, r[0] + dx * i, r[1] + dz * j, h->floor == 3 ? r[2] : r[0] + dx * (i + 1), r[1] + dz * (j + 1),
                      0);
        }
}

void hall_stairs(hall *h, double width, int steps, double rise, double run)
{
    kit_build *b = h->b;
    const double w = 0.5 * width;
    for (int k = 0; k < steps; k++) {
        const double x = run * k, y = rise * (k + 1);
        hall_paint(h, HALL_STONE);
        kit_box(b, x, 0, -w, x + run, y - 0.04, w);
        hall_paint(h, HALL_TRIM);
        kit_bevelled(b, x - 0.03, y - 0.04, -w - 0.02, x + run - 0.03, y, w + 0.02, 0.008);
    }
}

static void baluster(hall *h, int kind, double height)
{
    kit_build *b = h->b;
    const double s = height / 0.75;
    const kit_moulding turned[] = { { 0.075, 0, 0.075, 0.05 * s, 0 },       { 0.05, 0.05 * s, 0.085, 0.2 * s, 0 },
                                    { 0.085, 0.2 * s, 0.07, 0.32 * s, 0 },  { 0.07, 0.32 * s, 0.038, 0.52 * s, 0 },
                                    { 0.038, 0.52 * s, 0.06, 0.62 * s, 0 }, { 0.06, 0.62 * s, 0.075, 0.68 * s, 0 },
                                    { 0.075, 0.68 * s, 0.075, 0.75 * s, 0 } };
    if (kind == HALL_STONE_RAIL) kit_turned(b, turned, 7, 8);
    else if (kind == HALL_WOOD_RAIL) kit_box(b, -0.03, 0, -0.03, 0.03, height, 0.03);
    else kit_box(b, -0.009, 0, -0.009, 0.009, height, 0.009);
}

/* from corner to corner, between posts */
static void crossed(kit_build *b, double length, double climb, double pitch)
{
    const int n = (int)fmax(1, length / pitch);
    for (int k = 0; k < n; k++)
        for (int way = 0; way < 2; way++) {
            const double a = length * k / n, e = length * (k + 1) / n, t = climb / length;
            const double from[3] = { way ? e : a, 0.1 + t * (way ? e : a), 0.01 * way };
            const double to[3] = { way ? a : e, 0.92 + t * (way ? a : e), 0.01 * way };
            hall_bar(b, from, to, 0.025, 0.025);
        }
}

void hall_rail(hall *h, int kind, double length, double climb)
{
    kit_build *b = h->b;
    const int stone = kind == HALL_STONE_RAIL, wood = kind == HALL_WOOD_RAIL, open = kind == HALL_IRON_RAIL;
    const double t = climb / length, pitch = stone ? 0.27 : wood ? 0.17 : open ? 0.13 : 1.4;
    const double thick = stone ? 0.22 : 0.07, from[3] = { 0, 1.0, 0 }, to[3] = { length, 1.0 + climb, 0 };
    const double low[3] = { 0, stone ? 0.08 : 0.1, 0 }, low_end[3] = { length, low[1] + climb, 0 };
    const int n = (int)fmax(1, length / pitch);
    hall_paint(h, stone ? HALL_TRIM : wood ? HALL_WOOD : HALL_METAL);
    hall_bar(b, from, to, thick, stone ? 0.12 : 0.06);
    hall_bar(b, low, low_end, stone ? 0.2 : 0.03, stone ? 0.16 : 0.03);
    for (int k = 0; k < n && (stone || wood || open); k++) {
        const double x = length * (k + 0.5) / n;
        kit_place_at(b, x, 0.1 + t * x, 0, 0);
        baluster(h, kind, 0.87);
    }
    kit_place_at(b, 0, 0, 0, 0);
    if (kind == HALL_CROSS_RAIL) crossed(b, length, climb, 0.9);
    if (kind == HALL_GLASS_RAIL) { /* without thickness */
        const double pane[4][3] = {
            { 0.03, 0.12, 0 }, { length - 0.03, 0.12 + climb, 0 }, { length - 0.03, 0.95 + climb, 0 }, { 0.03, 0.95, 0 }
        };
        hall_paint(h, HALL_GLASS);
        kit_quad(b, pane);
    }
    hall_paint(h, stone ? HALL_TRIM : wood ? HALL_WOOD : HALL_METAL);
    const int posts = (int)fmax(1, length / (stone ? 4 : 2));
    for (int k = 0; k <= posts; k++) {
        const double x = length * k / posts, w = stone ? 0.17 : wood ? 0.05 : 0.025;
        kit_box(b, x - w, t * x - (climb > 0 ? 0.1 : 0), -w, x + w, t * x + (stone ? 1.14 : 1.0), w);
    }
}
