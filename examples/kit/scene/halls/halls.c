/* halls.c - halls by seed: naves, courts and halls of bays, drawn from a style. Declared in kit_seed.h. */
#include "kit/scene/halls/halls.h"
#include <math.h>
#include <string.h>

/* ---- >>style ----------------------------------------------------------------------------------------------------- */

/* stone, wall, trim, floor, tile, wood, metal, cloth, second cloth, glass, vault */
static const float styles[][HALL_PAINTS][3] = {
    { { 0.60f, 0.54f, 0.44f },
      { 0.58f, 0.52f, 0.43f },
      { 0.66f, 0.60f, 0.50f },
      { 0.45f, 0.40f, 0.34f },
      { 0.34f, 0.22f, 0.18f }, /* limestone */
      { 0.30f, 0.19f, 0.11f },
      { 0.16f, 0.14f, 0.12f },
      { 0.50f, 0.07f, 0.06f },
      { 0.10f, 0.20f, 0.38f },
      { 0.70f, 0.76f, 0.80f },
      { 0.62f, 0.57f, 0.49f } },
    { { 0.72f, 0.71f, 0.68f },
      { 0.70f, 0.67f, 0.60f },
      { 0.76f, 0.75f, 0.72f },
      { 0.66f, 0.64f, 0.60f },
      { 0.12f, 0.12f, 0.13f }, /* marble */
      { 0.26f, 0.13f, 0.08f },
      { 0.50f, 0.39f, 0.18f },
      { 0.40f, 0.05f, 0.08f },
      { 0.10f, 0.26f, 0.18f },
      { 0.74f, 0.79f, 0.82f },
      { 0.78f, 0.76f, 0.72f } },
    { { 0.44f, 0.25f, 0.19f },
      { 0.46f, 0.28f, 0.21f },
      { 0.60f, 0.55f, 0.47f },
      { 0.30f, 0.28f, 0.27f },
      { 0.24f, 0.22f, 0.21f }, /* brick */
      { 0.34f, 0.22f, 0.13f },
      { 0.10f, 0.16f, 0.14f },
      { 0.62f, 0.46f, 0.12f },
      { 0.12f, 0.30f, 0.26f },
      { 0.68f, 0.74f, 0.76f },
      { 0.55f, 0.46f, 0.38f } },
    { { 0.50f, 0.49f, 0.47f },
      { 0.56f, 0.55f, 0.53f },
      { 0.42f, 0.41f, 0.40f },
      { 0.38f, 0.38f, 0.38f },
      { 0.46f, 0.46f, 0.45f }, /* concrete */
      { 0.52f, 0.38f, 0.22f },
      { 0.22f, 0.23f, 0.25f },
      { 0.65f, 0.32f, 0.06f },
      { 0.15f, 0.33f, 0.45f },
      { 0.72f, 0.78f, 0.80f },
      { 0.60f, 0.60f, 0.58f } },
    { { 0.80f, 0.79f, 0.77f },
      { 0.82f, 0.81f, 0.79f },
      { 0.78f, 0.77f, 0.75f },
      { 0.50f, 0.37f, 0.24f },
      { 0.44f, 0.32f, 0.20f }, /* white */
      { 0.58f, 0.43f, 0.27f },
      { 0.12f, 0.12f, 0.12f },
      { 0.08f, 0.16f, 0.34f },
      { 0.70f, 0.66f, 0.58f },
      { 0.78f, 0.83f, 0.86f },
      { 0.84f, 0.84f, 0.83f } },
    { { 0.40f, 0.42f, 0.40f },
      { 0.33f, 0.40f, 0.37f },
      { 0.58f, 0.50f, 0.32f },
      { 0.30f, 0.17f, 0.12f },
      { 0.52f, 0.46f, 0.36f }, /* painted */
      { 0.22f, 0.12f, 0.07f },
      { 0.42f, 0.31f, 0.12f },
      { 0.36f, 0.06f, 0.14f },
      { 0.58f, 0.48f, 0.20f },
      { 0.74f, 0.76f, 0.70f },
      { 0.50f, 0.52f, 0.58f } },
    { { 0.56f, 0.33f, 0.24f },
      { 0.66f, 0.52f, 0.38f },
      { 0.50f, 0.28f, 0.20f },
      { 0.52f, 0.40f, 0.30f },
      { 0.30f, 0.36f, 0.40f }, /* sandstone */
      { 0.36f, 0.22f, 0.12f },
      { 0.20f, 0.17f, 0.14f },
      { 0.12f, 0.34f, 0.40f },
      { 0.68f, 0.42f, 0.08f },
      { 0.72f, 0.76f, 0.76f },
      { 0.64f, 0.48f, 0.36f } },
};

static void draw_style(hall *h)
{
    kit_build *b = h->b;
    const int which = kit_choose(b, (int)(sizeof styles / sizeof *styles));
    memcpy(h->paint, styles[which], sizeof h->paint);
    for (int k = 0; k < HALL_PAINTS; k++)
        for (int i = 0; i < 3; i++) h->paint[k][i] *= (float)kit_between(b, 0.92, 1.06);
    h->column = which == 3 ? (kit_odds(b, 0.5) ? HALL_PLAIN : HALL_PIER) : kit_choose(b, HALL_COLUMNS);
    h->rail = kit_choose(b, which == 3 || which == 4 ? HALL_RAILS : HALL_GLASS_RAIL);
    h->pointed = kit_odds(b, 0.35);
    h->ribs = kit_odds(b, 0.6);
    h->floor = kit_choose(b, 4);
    h->noise = (unsigned)kit_choose(b, 1 << 20);
}

/* ---- >>arcades --------------------------------------------------------------------------------------------------- */

/* bays of arches on columns along x from 0, above which the wall goes on to height; flat: a beam instead */
static void arcade(hall *h, int bays, double bay, double r, double tall, double height, int kind)
{
    kit_build *b = h->b;
    const double half = 0.5 * bay - 1.15 * r, high = height - tall,
                 rise = fmin(high - 0.3, half * (h->pointed ? 1.5 : 1));
    const hall_panel p = { bay, high, 1.8 * r, half, 0, 0, rise, h->pointed, 18, 1 };
    const int flat = h->column != HALL_CLUSTER && high < 0.75 * half;
    for (int i = 0; i <= bays; i++) {
        kit_begin_object(b, "column", -1);
        const kit_frame f = kit_enter(b, bay * i, 0, 0, 0, 1);
        hall_paint(h, HALL_STONE);
        hall_column(h, kind, r, tall);
        if (i % 3 == 1) {
            hall_sight(h, 0, 0.5, 0, 1.2);
            hall_sight(h, 0, tall, 0, 1.5);
        }
        kit_leave(b, f);
    }
    kit_begin_object(b, "arches", 0);
    for (int i = 0; i < bays && !flat; i++)
        for (int side = 0; side < 2; side++) {
            const kit_frame f = kit_enter(b, bay * (i + 0.5), tall, 0, 180 * side, 1);
            hall_paint(h, HALL_WALL);
            if (!side) hall_wall(h, &p);
            hall_paint(h, HALL_TRIM);
            if (h->ribs) hall_archivolt(h, &p, 0.22, 0.05);
            kit_leave(b, f);
        }
    hall_paint(h, flat ? HALL_STONE : HALL_TRIM);
    if (flat) kit_box(b, -r, tall, -0.95 * r, bays * bay + r, height - 0.01, 0.95 * r);
    kit_bevelled(b, -r, height - 0.3, -1.5 * r, bays * bay + r, height, 1.5 * r, 0.06);
}

static void rails(hall *h, int bays, double bay, double r)
{
    kit_begin_object(h->b, "rail", -1);
    for (int i = 0; i < bays; i++) {
        const kit_frame f = kit_enter(h->b, bay * i + 1.3 * r, 0, 0, 0, 1);
        hall_rail(h, h->rail, bay - 2.6 * r, 0);
        if (i % 2) hall_sight(h, 0.5 * bay, 0.6, 0, 1.3);
        kit_leave(h->b, f);
    }
}

/* ---- >>what hangs ------------------------------------------------------------------------------------------------ */

static void hang(hall *h, const double r[4], double y, int bays)
{
    kit_build *b = h->b;
    const int what = kit_choose(b, 4), each = 1 + kit_choose(b, 2);
    const double bay = (r[2] - r[0]) / bays, mid = 0.5 * (r[1] + r[3]), low = fmin(0.75 * y, kit_between(b, 3, 6));
    for (int i = 0; i < bays; i += each) {
        const double x = r[0] + bay * (i + 0.5);
        kit_begin_object(b, what == 3 ? "cloth" : "lamp", -1);
        kit_frame f = kit_enter(b, x, low, mid, 0, 1);
        if (what == 0) hall_chandelier(h, fmin(1.5, 0.12 * y), y - low);
        if (what == 1) hall_pendant(h, kit_between(b, 0.2, 0.45), y - low);
        if (what < 2) hall_sight(h, 0, 0, 0, 1.5);
        kit_leave(b, f);
        if (what != 3) continue;
        f = kit_enter(b, x, y - 0.4, mid, 90 + kit_between(b, -4, 4), 1);
        hall_banner(h, fmin(2.4, 0.3 * (r[3] - r[1])), fmin(5, 0.5 * y) * kit_between(b, 0.7, 1));
        hall_sight(h, 0, -1.5, 0, 2);
        kit_leave(b, f);
    }
}

/* ---- >>nave ------------------------------------------------------------------------------------------------------ */

typedef struct nave {
    int bays, gallery, aisle_kind;
    double bay, half, wide, r, tall, low, high;
} nave;

static void nave_side(hall *h, const nave *n, int side)
{
    kit_build *b = h->b;
    const double length = n->bay * n->bays;
    const kit_frame f = kit_enter(b, side < 0 ? 0 : length, 0, side * n->half, side < 0 ? 0 : 180, 1);
    const double aisle[4] = { 0, -n->wide, length, 0 };
    const int upper = (h->column + 3) % HALL_COLUMNS;
    arcade(h, n->bays, n->bay, n->r, n->tall, n->low, h->column);
    if (n->aisle_kind == HALL_GROIN) hall_roof(h, HALL_GROIN, aisle, n->tall, n->bays);
    else hall_roof(h, n->aisle_kind, aisle, n->low - 0.9, n->bays);
    kit_begin_object(b, "gallery", 0);
    hall_paint(h, HALL_FLOOR);
    kit_box(b, 0, n->low, -n->wide, length, n->low + 0.14, 0.35);
    if (n->gallery) {
        const kit_frame g = kit_enter(b, 0, n->low + 0.14, 0, 0, 1);
        const double over[4] = { 0, -n->wide, length, 0 };
        arcade(h, n->bays, n->bay, 0.7 * n->r, 0.6 * n->gallery, n->high - n->low - 0.14,
               upper == HALL_TWISTED ? HALL_DORIC : upper);
        rails(h, n->bays, n->bay, 0.7 * n->r);
        hall_roof(h, HALL_BEAMS, over, n->high - n->low - 0.9, n->bays);
        kit_leave(b, g);
    } else {
        const kit_frame g = kit_enter(b, 0, n->low + 0.14, 0.2, 0, 1);
        kit_begin_object(b, "clerestory", 0);
        hall_bays(h, HALL_WINDOW, HALL_WINDOW, n->bays, length, n->high - n->low - 0.14);
        kit_leave(b, g);
    }
    const kit_frame w = kit_enter(b, 0, 0, -n->wide, 0, 1);
    kit_begin_object(b, "wall", 0);
    hall_bays(h, 1 + kit_choose(b, HALL_BAYS - 2), HALL_WINDOW, n->bays, length, n->gallery ? n->high : n->low);
    kit_leave(b, w);
    kit_leave(b, f);
}

/* an apse behind an arch: half a cylinder, a quarter of a ball */
static void apse_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = KIT_PI * u, turn = v < 0.5 ? 0 : KIT_PI * (v - 0.5), y = v < 0.5 ? 2 * v * s[1] : s[1];
    out->n[0] = -cos(a) * cos(turn);
    out->n[1] = -sin(turn);
    out->n[2] = sin(a) * cos(turn);
    out->p[0] = s[0] * cos(a) * cos(turn);
    out->p[1] = y + s[0] * sin(turn);
    out->p[2] = -s[0] * sin(a) * cos(turn);
}

static void altar(hall *h)
{
    kit_build *b = h->b;
    hall_paint(h, HALL_TRIM);
    for (int k = 0; k < 3; k++)
        kit_bevelled(b, -2.2 + 0.3 * k, 0.15 * k, -1.2 + 0.3 * k, 2.2 - 0.3 * k, 0.15 * (k + 1), 1.6 - 0.3 * k, 0.01);
    kit_bevelled(b, -1.1, 0.45, -0.4, 1.1, 1.4, 0.4, 0.03);
    hall_paint(h, HALL_SECOND);
    kit_box(b, -1.2, 1.4, -0.5, 1.2, 1.43, 0.5);
    for (int k = -2; k < 3; k++) {
        const kit_frame f = kit_enter(b, 0.45 * k, 1.43 + KIT_GAP, -0.2, 0, 1);
        if (k) hall_candles(h, 0.6 - 0.06 * k * k);
        else hall_statue(h, 0.7);
        kit_leave(b, f);
    }
    hall_sight(h, 0, 1, 0, 1.8);
}

static void nave_end(hall *h, const nave *n, int apse)
{
    kit_build *b = h->b;
    const double r = n->half - 0.6, spring = fmin(n->low, n->high - r - 0.4);
    const hall_panel p = { 2 * n->half + 2 * n->wide, n->high + 0.2, 0.4, r, 0, spring, r, 0, 24, 0 };
    const double shape[2] = { r + 0.02, spring };
    kit_begin_object(b, "apse", 0);
    hall_paint(h, HALL_WALL);
    if (!apse) {
        const kit_frame f = kit_enter(b, -n->half - n->wide, 0, 0.2, 0, 1);
        hall_bays(h, HALL_RELIEF, HALL_DOOR, 3, 2 * (n->half + n->wide), n->high);
        kit_leave(b, f);
        return;
    }
    hall_wall(h, &p);
    hall_paint(h, HALL_TRIM);
    hall_archivolt(h, &p, 0.5, 0.1);
    hall_paint(h, HALL_VAULT);
    kit_place_at(b, 0, 0, -0.19, 0);
    kit_patch(b, 32, 24, apse_surface, shape);
    kit_place_at(b, 0, 0, 0, 0);
    hall_floor(h, (const double[4]){ -r, -r - 0.2, r, 0 });
    const kit_frame f = kit_enter(b, 0, 0, -0.1 - 0.3 * r, 0, 1);
    kit_begin_object(b, "altar", -1);
    altar(h);
    kit_leave(b, f);
}

static void make_nave(hall *h)
{
    kit_build *b = h->b;
    nave n = { 4 + kit_choose(b, 4),
               kit_odds(b, 0.5) ? 5 : 0,
               kit_odds(b, 0.5)   ? HALL_GROIN
               : kit_odds(b, 0.5) ? HALL_COFFERS
                                  : HALL_BEAMS,
               kit_between(b, 3.2, 5),
               kit_between(b, 3, 5.5),
               kit_between(b, 2.4, 4),
               0,
               kit_between(b, 3.2, 6),
               0,
               0 };
    static const int roofs[] = { HALL_BARREL, HALL_GROIN,    HALL_COFFERS, HALL_TRUSSES,
                                 HALL_GROIN,  HALL_SKYLIGHT, HALL_BEAMS };
    const int roof = roofs[kit_choose(b, 7)], furnishing = kit_choose(b, HALL_FURNISHINGS);
    n.r = kit_between(b, 0.24, 0.36) * (0.6 + 0.1 * n.tall);
    n.low = n.tall + fmax(0.62 * n.bay, n.aisle_kind == HALL_GROIN ? 0.6 * n.wide : 1.6) + 0.4;
    n.high = n.low + (n.gallery ? 3 + 0.55 * n.bay : kit_between(b, 2.5, 4.5));
    const double length = n.bay * n.bays, out = n.half + n.wide, nave_at[4] = { 0, -n.half, length, n.half };
    const double all[4] = { -n.half, -out - 1.2, length + n.half, out + 1.2 },
                 inner[4] = { 1.5, -n.half + 0.8, length - 3, n.half - 0.8 };
    kit_begin_object(b, "ground", 0);
    hall_floor(h, (const double[4]){ -0.3, -out - 1.2, length + 0.3, out + 1.2 });
    hall_shell(h, all, -0.05, n.high + 2 * n.half, 1);
    hall_overview(h, nave_at, n.low);
    for (int side = -1; side < 2; side += 2) nave_side(h, &n, side);
    hall_roof(h, roof, nave_at, n.high, n.bays);
    for (int end = 0; end < 2; end++) {
        const kit_frame f = kit_enter(b, end ? length + 0.2 : -0.2, 0, 0, end ? 270 : 90, 1);
        nave_end(h, &n, end && kit_odds(b, 0.7));
        kit_leave(b, f);
    }
    h->top = n.high;
    hall_furnish(h, furnishing == HALL_STORE ? HALL_BARE : furnishing, inner);
    hang(h, nave_at, n.high, n.bays);
    for (int i = 0; i < n.bays && n.gallery && n.half < 4.5; i++) { /* cloths from side to side */
        if (!kit_odds(b, 0.4)) continue;
        kit_begin_object(b, "cloth", -1);
        const kit_frame f = kit_enter(b, n.bay * (i + 0.5), n.low + 1, n.half, 90, 1);
        hall_drape(h, 2 * n.half, 0.5 * n.bay, kit_between(b, 0.4, 1.4));
        hall_sight(h, n.half, -0.5, 0, 2.5);
        kit_leave(b, f);
    }
    hall_sight(h, 0, n.high, 0, 3);
    memcpy(h->p->stand, (const double[4]){ 0.6, 0.4 - out, length - 0.6, out - 0.4 }, sizeof h->p->stand);
    h->p->ceiling = n.high - 0.3;
}

/* ---- >>court ----------------------------------------------------------------------------------------------------- */

static void fountain(hall *h)
{
    kit_build *b = h->b;
    const double r = kit_between(b, 1, 1.7);
    const kit_moulding basin[] = { { r, 0, r, 0.15, 0 },
                                   { 0.9 * r, 0.15, r, 0.6, -0.03 },
                                   { r, 0.6, 0.85 * r, 0.62, 0.02 },
                                   { 0.85 * r, 0.62, 0.82 * r, 0.3, 0 },
                                   { 0.82 * r, 0.4, 0, 0.4, 0 } };
    const kit_moulding stem[] = { { 0.3, 0.3, 0.12, 0.9, -0.04 },
                                  { 0.12, 0.9, 0.16, 1.3, 0.03 },
                                  { 0.16, 1.3, 0.5 * r, 1.6, -0.08 },
                                  { 0.5 * r, 1.6, 0.45 * r, 1.62, 0 },
                                  { 0.45 * r, 1.62, 0, 1.45, 0 } };
    hall_paint(h, HALL_STONE);
    kit_turned(b, basin, 5, 32);
    kit_turned(b, stem, 5, 20);
    const kit_frame f = kit_enter(b, 0, 1.5, 0, kit_between(b, 0, 90), 1);
    hall_statue(h, 1.1);
    kit_leave(b, f);
    hall_sight(h, 0, 0.9, 0, 1.6);
}

static void court_side(hall *h, int bays, double bay, double wide, int storeys, double tall, double storey)
{
    kit_build *b = h->b;
    const double r = 0.05 * tall + kit_between(b, 0.04, 0.12), length = bays * bay;
    for (int k = 0; k < storeys; k++) {
        const kit_frame f = kit_enter(b, 0, (storey + 0.1) * k, 0, 0, 1);
        const double walk[4] = { -wide, -wide, length, 0 };
        arcade(h, bays, bay, r * (1 - 0.2 * k), tall * (1 - 0.1 * k), storey,
               k ? (h->column + 1) % HALL_COLUMNS : h->column);
        if (k || kit_odds(b, 0.2)) rails(h, bays, bay, r * (1 - 0.2 * k));
        hall_roof(h, k ? HALL_BEAMS : kit_odds(b, 0.5) ? HALL_COFFERS : HALL_BEAMS, walk, storey - 0.75, bays + 1);
        kit_begin_object(b, "gallery", 0);
        hall_paint(h, HALL_FLOOR);
        kit_box(b, -wide, storey, -wide, length, storey + 0.1, 0.3);
        kit_leave(b, f);
    }
    const kit_frame f = kit_enter(b, 0, storeys * (storey + 0.1), 0, 0, 1);
    const double eave[4][3] = {
        { -0.6, -0.25, 0.7 }, { length + 0.6, -0.25, 0.7 }, { length + wide, 1.2, -wide }, { -wide, 1.2, -wide }
    };
    hall_paint(h, HALL_TILE);
    kit_begin_object(b, "eaves", 0);
    kit_quad(b, eave);
    kit_leave(b, f);
    for (int i = 0; i < bays; i++) {
        if (!kit_odds(b, storeys > 1 ? 0.35 : 0.1)) continue;
        kit_begin_object(b, "cloth", -1);
        const kit_frame g = kit_enter(b, bay * (i + 0.5), storey + 0.9, 0.4, 0, 1);
        hall_banner(h, 0.4 * bay, storey * kit_between(b, 0.3, 0.6));
        hall_sight(h, 0, -1, 0, 1.6);
        kit_leave(b, g);
    }
}

static void make_court(hall *h)
{
    kit_build *b = h->b;
    const int nx = 4 + kit_choose(b, 4), nz = 3 + kit_choose(b, 3), storeys = 1 + kit_odds(b, 0.6),
              open = kit_odds(b, 0.6);
    const double bay = kit_between(b, 2.6, 4), wide = kit_between(b, 2.2, 3.4), tall = kit_between(b, 2.2, 3.8),
                 storey = tall + 0.5 * bay + 0.7;
    const double x = nx * bay, z = nz * bay, high = storeys * (storey + 0.1);
    const double outer[4] = { -wide, -wide, x + wide, z + wide }, inner[4] = { 0.6, 0.6, x - 0.6, z - 0.6 },
                 at[4][2] = { { 0, 0 }, { 0, z }, { x, z }, { x, 0 } };
    kit_begin_object(b, "ground", 0);
    hall_floor(h, (const double[4]){ -wide - 1.2, -wide - 1.2, x + wide + 1.2, z + wide + 1.2 });
    hall_shell(h, (const double[4]){ -wide - 1.2, -wide - 1.2, x + wide + 1.2, z + wide + 1.2 }, -0.05,
               high + (open ? 1.3 : 3), !open);
    hall_paint(h, HALL_FLOOR);
    kit_level(b, -70, -70, 70 + x, 70 + z, -0.06);
    hall_overview(h, (const double[4]){ 0, 0, x, z }, high);
    hall_four_walls(h, outer, high, bay, 1 + kit_choose(b, HALL_BAYS - 2), kit_odds(b, 0.5) ? HALL_DOOR : HALL_WINDOW);
    for (int k = 0; k < 4; k++) {
        const kit_frame f = kit_enter(b, at[k][0], 0, at[k][1], 90 * k, 1);
        court_side(h, k & 1 ? nz : nx, bay, wide, storeys, tall, storey);
        kit_leave(b, f);
    }
    if (!open)
        hall_roof(h, kit_odds(b, 0.7) ? HALL_SKYLIGHT : HALL_TRUSSES, (const double[4]){ 0, 0, x, z }, high + 0.3, nx);
    h->top = high;
    if (kit_odds(b, 0.6)) {
        kit_begin_object(b, "fountain", -1);
        const kit_frame f = kit_enter(b, 0.5 * x, 0, 0.5 * z, 0, 1);
        fountain(h);
        kit_leave(b, f);
        hall_furnish(h, HALL_BARE, (const double[4]){ 0.6, 0.6, 0.3 * x, z - 0.6 });
        hall_furnish(h, HALL_BARE, (const double[4]){ 0.7 * x, 0.6, x - 0.6, z - 0.6 });
    } else hall_furnish(h, kit_odds(b, 0.4) ? HALL_MARKET : kit_odds(b, 0.5) ? HALL_BARE : HALL_MUSEUM, inner);
    memcpy(h->p->stand, (const double[4]){ 0.5 - wide, 0.5 - wide, x + wide - 0.5, z + wide - 0.5 },
           sizeof h->p->stand);
    h->p->ceiling = open ? 0 : high;
}

/* ---- >>hall ------------------------------------------------------------------------------------------------------ */

/* four walls of bays, perhaps rows of columns, a roof, one use */
static void make_bays(hall *h)
{
    kit_build *b = h->b;
    static const int uses[] = { HALL_MUSEUM, HALL_MARKET, HALL_STATION, HALL_STORE, HALL_READING, HALL_BANQUET };
    const int use = uses[kit_choose(b, 6)], work = use == HALL_MARKET || use == HALL_STATION || use == HALL_STORE,
              bays = 4 + kit_choose(b, 4);
    const double bay = kit_between(b, 3.4, 5), x = bays * bay, z = kit_between(b, 9, work ? 22 : 14),
                 high = kit_between(b, 4.5, work ? 9 : 8);
    static const int roofs[] = { HALL_COFFERS, HALL_SKYLIGHT, HALL_BARREL, HALL_BEAMS };
    const int roof = work ? (kit_odds(b, 0.7) ? HALL_TRUSSES : HALL_SKYLIGHT) : roofs[kit_choose(b, 4)];
    const double r[4] = { 0, 0, x, z }, in[4] = { 1.6, 1.4, x - 1.6, z - 1.4 };
    if (work) h->column = kit_odds(b, 0.6) ? HALL_IRON : HALL_PIER;
    kit_begin_object(b, "ground", 0);
    hall_floor(h, (const double[4]){ -1.2, -1.2, x + 1.2, z + 1.2 });
    hall_shell(h, (const double[4]){ -1.2, -1.2, x + 1.2, z + 1.2 }, -0.05, high + 0.6 * z + 1, 1);
    hall_overview(h, r, high);
    hall_four_walls(h, r, high, bay, 1 + kit_choose(b, HALL_BAYS - 2), kit_choose(b, HALL_BAYS));
    hall_roof(h, roof, r, high, bays);
    if (use != HALL_STORE && z > 11 && kit_odds(b, 0.6))
        for (int side = 0; side < 2; side++) {
            const kit_frame f = kit_enter(b, 0.5 * bay, 0, side ? z - 2.6 : 2.6, 0, 1);
            arcade(h, bays - 1, bay, 0.06 * high * kit_between(b, 0.5, 1), 0.7 * high, high, h->column);
            kit_leave(b, f);
        }
    h->top = high;
    hall_furnish(h, use, in);
    hang(h, r, high, bays);
    memcpy(h->p->stand, (const double[4]){ 0.5, 0.5, x - 0.5, z - 0.5 }, sizeof h->p->stand);
    h->p->ceiling = high;
}

void kit_make_hall(kit_plot *p)
{
    hall h = { .p = p, .b = &p->b };
    static void (*const plans[])(hall *) = { make_nave,    make_bays,       make_court, hall_theatre,
                                             make_nave,    hall_stair_hall, make_bays,  hall_rotunda,
                                             hall_parking, make_court,      make_bays,  hall_temple };
    draw_style(&h);
    const int plan = kit_choose(&p->b, (int)(sizeof plans / sizeof *plans));
    plans[plan](&h);
}
