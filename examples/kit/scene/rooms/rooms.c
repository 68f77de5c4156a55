/* rooms.c - scenes by seed of furnished rooms: what kinds there are, where the furniture goes. Declared in kit_seed.h,
   rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>
#include <string.h>

/* ---- >>kinds ----------------------------------------------------------------------------------------------------- */

/* Against a wall; in a corner; hanging on a wall,
    from a height on; free; free and turned as it likes; under nothing. */
enum { WALL, CORNER, HANGING, FREE, LOOSE, FLOOR };

/* No more furniture beyond. */
enum { MOST_TRIANGLES = 150000 };

typedef struct piece {
    const char *name;
    room_piece *make;
    int where, least, most;
    double low[3], high[3], y;
} piece;

typedef struct kind {
    const char *name;
    int theme, attic;
    double low[3], high[3];
    const piece *pieces;
    int count;
} kind;

/* clang-format off */
#define PICTURES(n) { "picture", kit_picture, HANGING, 1, n, { 0.25, 0.3, 0.02 }, { 0.9, 0.8, 0.035 }, 1.35 }
#define PLANTS(n)   { "plant", kit_plant_piece, CORNER, 0, n, { 0.4, 0.6, 0.4 }, { 0.6, 1.6, 0.6 }, 0 }
#define LAMPS(n)    { "floor lamp", kit_floor_lamp, CORNER, 0, n, { 0.45, 1.4, 0.45 }, { 0.5, 1.75, 0.5 }, 0 }
#define BOOKS(l, n) { "bookcase", kit_bookcase, WALL, l, n, { 0.6, 0.9, 0.24 }, { 2.2, 2.2, 0.36 }, 0 }
#define BOXES(n)    { "boxes", kit_boxes_piece, CORNER, 0, n, { 0.5, 0.3, 0.45 }, { 0.6, 1.2, 0.5 }, 0 }
#define SHELVES(n)  { "wall shelf", kit_wall_shelf, HANGING, 0, n, { 0.6, 0.4, 0.18 }, { 1.4, 0.8, 0.28 }, 1.3 }
#define CLOCK       { "clock", kit_clock, HANGING, 0, 1, { 0.25, 0.3, 0.04 }, { 0.4, 0.4, 0.04 }, 1.8 }
#define DRAWERS(n)  { "drawers", kit_drawers, WALL, 0, n, { 0.5, 0.7, 0.4 }, { 1.1, 1.2, 0.5 }, 0 }
#define CUPBOARD(n) { "cupboard", kit_cabinet, WALL, 0, n, { 0.6, 0.7, 0.38 }, { 1.8, 2.1, 0.6 }, 0 }
#define RUG(n)      { "rug", kit_rug, FLOOR, 0, n, { 1.2, 0.006, 0.9 }, { 2.6, 0.008, 1.8 }, 0 }
#define STOOLS(n)   { "chair", kit_stool_piece, LOOSE, 0, n, { 0.6, 1, 0.6 }, { 0.6, 1, 0.6 }, 0 }
#define TOYS(n)     { "toys", kit_toys_piece, LOOSE, 0, n, { 0.7, 0.4, 0.6 }, { 1.2, 0.4, 0.9 }, 0 }
#define SMALL(n)    { "small table", kit_small_table, LOOSE, 0, n, { 0.45, 0.45, 0.45 }, { 0.8, 0.72, 0.7 }, 0 }
#define DINING(l)   { NULL, kit_dining, FREE, l, 1, { 2.1, 0.74, 1.9 }, { 3.1, 0.76, 2.1 }, 0 }
#define COATS       { "coats", kit_coats, HANGING, 0, 1, { 0.6, 0.9, 0.18 }, { 1.2, 1, 0.2 }, 0.75 }
#define MIRROR      { "mirror", kit_mirror, HANGING, 0, 1, { 0.5, 0.6, 0.025 }, { 0.8, 1.1, 0.03 }, 0.95 }
#define AIRER(n)    { "airer", kit_airer, LOOSE, 0, n, { 1, 0.9, 0.6 }, { 1.3, 1, 0.7 }, 0 }
#define LADDER      { "ladder", kit_ladder, WALL, 0, 1, { 0.42, 1.6, 0.4 }, { 0.5, 2.2, 0.6 }, 0 }
#define BICYCLE     { "bicycle", kit_bicycle, WALL, 0, 1, { 1.8, 1, 0.6 }, { 1.8, 1.02, 0.6 }, 0 }
#define RAILING     { "railing", kit_railing, FREE, 0, 1, { 1.4, 0.95, 0.1 }, { 3, 1.05, 0.1 }, 0 }
#define DESK(l, n)  { NULL, kit_desk, WALL, l, n, { 1.1, 1.15, 1.4 }, { 1.8, 1.2, 1.6 }, 0 }
#define STEEL(l, n) { "shelving", kit_steel_shelf, WALL, l, n, { 0.8, 1.5, 0.35 }, { 1.6, 2.1, 0.5 }, 0 }
#define CLOTHES     { "clothes", kit_clothes_rack, WALL, 0, 1, { 0.9, 1.4, 0.5 }, { 1.5, 1.6, 0.55 }, 0 }

static const piece living[] = {
    { NULL, kit_lounge, WALL, 1, 1, { 1.7, 0.9, 1.9 }, { 2.6, 0.9, 2.3 }, 0 },
    { "fireplace", kit_fireplace, WALL, 0, 1, { 1.2, 1.05, 0.32 }, { 1.6, 1.2, 0.4 }, 0 },
    { "screen stand", kit_screen_stand, WALL, 0, 1, { 1.2, 1.2, 0.38 }, { 1.8, 1.5, 0.45 }, 0 },
    { "piano", kit_piano, WALL, 0, 1, { 1.4, 1.15, 0.6 }, { 1.5, 1.25, 0.62 }, 0 },
    BOOKS(0, 2), DINING(0), { "armchair", kit_armchair, LOOSE, 0, 2, { 0.85, 0.75, 0.85 }, { 0.95, 0.95, 0.9 }, 0 },
    CUPBOARD(2), PICTURES(6), LAMPS(2), PLANTS(3), SHELVES(2), SMALL(2), RUG(1), TOYS(1), STOOLS(2), CLOCK
};
static const piece bedroom[] = {
    { "bed", kit_bed, WALL, 1, 2, { 0.95, 0.85, 2.05 }, { 1.9, 1.2, 2.15 }, 0 }, SMALL(2), CUPBOARD(2), DRAWERS(2),
    DESK(0, 1), CLOTHES, RUG(2), PICTURES(5), LAMPS(1), PLANTS(2), BOOKS(0, 1), SHELVES(2), MIRROR, STOOLS(2), COATS,
    { "cot", kit_cot, WALL, 0, 1, { 0.7, 0.85, 1.25 }, { 0.75, 0.95, 1.35 }, 0 }, AIRER(1), TOYS(1), BOXES(2)
};
static const piece kitchen[] = {
    { NULL, kit_kitchen, WALL, 1, 2, { 2.2, 2.2, 0.62 }, { 3.6, 2.25, 0.64 }, 0 },
    { "fridge", kit_fridge, CORNER, 0, 1, { 0.6, 1.5, 0.62 }, { 0.75, 1.95, 0.68 }, 0 },
    { "island", kit_island, FREE, 0, 1, { 1.4, 0.9, 1 }, { 2, 0.9, 1.1 }, 0 }, DINING(0),
    { NULL, kit_kitchen, WALL, 0, 1, { 1.2, 0.95, 0.62 }, { 1.8, 0.95, 0.64 }, 0 }, CUPBOARD(1),
    { "tools", kit_tool_rail, HANGING, 0, 2, { 0.5, 0.35, 0.1 }, { 1.1, 0.4, 0.12 }, 1.35 },
    SHELVES(3), CLOCK, PICTURES(3), STOOLS(3), BOXES(2), PLANTS(1), COATS
};
static const piece office[] = {
    DESK(2, 5), { NULL, kit_desk, FREE, 0, 4, { 1.2, 1.2, 1.4 }, { 1.6, 1.2, 1.5 }, 0 }, STEEL(0, 2), BOOKS(0, 2),
    DRAWERS(2), CUPBOARD(2), PICTURES(3), PLANTS(3), CLOCK, BOXES(3), COATS, STOOLS(2), LAMPS(1), RUG(1), SHELVES(2)
};
static const piece workshop[] = {
    { "workbench", kit_workbench, WALL, 1, 2, { 1.4, 0.88, 0.65 }, { 2.4, 0.95, 0.8 }, 0 },
    { "pegboard", kit_pegboard, HANGING, 1, 2, { 0.9, 0.7, 0.06 }, { 1.8, 1, 0.06 }, 1.25 }, STEEL(1, 3),
    BICYCLE, LADDER,
    { "workbench", kit_workbench, FREE, 0, 1, { 1.4, 0.88, 0.75 }, { 2, 0.95, 0.9 }, 0 }, BOXES(5), CUPBOARD(2),
    { "easel", kit_easel, LOOSE, 0, 1, { 0.8, 1.6, 0.8 }, { 0.8, 1.8, 0.8 }, 0 }, STOOLS(3), DRAWERS(1), SHELVES(3),
    CLOCK,
    RAILING, { "tools", kit_tool_rail, HANGING, 0, 2, { 0.6, 0.35, 0.1 }, { 1.2, 0.4, 0.12 }, 1.4 }
};
static const piece library[] = {
    BOOKS(3, 5), { "bookcase", kit_bookcase, FREE, 0, 2, { 1.2, 1.2, 0.3 }, { 2, 2, 0.36 }, 0 }, DINING(0),
    DESK(0, 2), BOOKS(0, 3),
    { "armchair", kit_armchair, LOOSE, 0, 2, { 0.85, 0.8, 0.85 }, { 0.95, 1, 0.9 }, 0 }, LADDER, SMALL(2), RUG(2),
    LAMPS(2), PICTURES(4),
    RAILING, PLANTS(2), { "fireplace", kit_fireplace, WALL, 0, 1, { 1.2, 1.05, 0.32 }, { 1.6, 1.2, 0.4 }, 0 },
    STOOLS(2), CLOCK
};
static const piece attic[] = {
    { "bed", kit_bed, WALL, 0, 1, { 0.95, 0.8, 2.05 }, { 1.5, 0.85, 2.1 }, 0 }, DESK(0, 1), BOXES(7), RAILING,
    { "bookcase", kit_bookcase, WALL, 1, 3, { 0.7, 0.6, 0.26 }, { 1.6, 0.9, 0.32 }, 0 }, CLOTHES, DRAWERS(2),
    { "armchair", kit_armchair, LOOSE, 0, 1, { 0.85, 0.75, 0.85 }, { 0.9, 0.95, 0.9 }, 0 }, RUG(2), SMALL(2),
    STOOLS(3), TOYS(1), PICTURES(3), LAMPS(1),
    BICYCLE, { "easel", kit_easel, LOOSE, 0, 1, { 0.8, 1.5, 0.8 }, { 0.8, 1.6, 0.8 }, 0 }, PLANTS(2), AIRER(1), LADDER
};
static const piece bathroom[] = {
    { "bath", kit_bath, WALL, 1, 1, { 1.55, 0.62, 0.75 }, { 1.8, 0.66, 0.82 }, 0 },
    { "basin", kit_basin, WALL, 1, 2, { 0.5, 0.9, 0.5 }, { 1.1, 0.92, 0.55 }, 0 },
    { "toilet", kit_toilet, WALL, 1, 1, { 0.75, 0.8, 0.68 }, { 0.8, 0.85, 0.7 }, 0 }, MIRROR, MIRROR,
    { "towels", kit_towels, HANGING, 1, 2, { 0.45, 0.9, 0.13 }, { 0.6, 1.3, 0.14 }, 0.5 },
    { "washer", kit_washer, WALL, 0, 2, { 0.6, 0.86, 0.6 }, { 0.6, 0.88, 0.62 }, 0 }, AIRER(1), SHELVES(3),
    CUPBOARD(1), STOOLS(1), PLANTS(2),
    { "mat", kit_rug, FLOOR, 1, 2, { 0.7, 0.012, 0.5 }, { 0.9, 0.014, 0.6 }, 0 }, COATS, PICTURES(2)
};
static const piece nursery[] = {
    { "cot", kit_cot, WALL, 0, 2, { 0.7, 0.85, 1.25 }, { 0.75, 0.95, 1.35 }, 0 }, TOYS(4), BOOKS(1, 2),
    { "bed", kit_bed, WALL, 0, 1, { 0.9, 0.8, 1.7 }, { 0.95, 0.9, 1.9 }, 0 }, RUG(2), DRAWERS(2), SMALL(2),
    STOOLS(3), DESK(0, 1), PICTURES(6),
    SHELVES(3), LAMPS(1), CUPBOARD(1), BOXES(3), COATS, CLOCK
};

#define PIECES(a) a, (int)(sizeof a / sizeof *a)
static const kind kinds[] = {
    { "living room", KIT_HOME,    0, { 4.2, 2.4, 3.8 }, { 6.4, 3.3, 5.4 },   PIECES(living) },
    { "bedroom",     KIT_HOME,    0, { 3.2, 2.3, 3.2 }, { 5.2, 3, 4.8 },   PIECES(bedroom) },
    { "kitchen",     KIT_KITCHEN, 0, { 3, 2.4, 2.8 },   { 6, 3.2, 5 },     PIECES(kitchen) },
    { "office",      KIT_OFFICE,  0, { 3.5, 2.5, 3.5 }, { 7.6, 3.3, 6 },     PIECES(office) },
    { "workshop",    KIT_SHOP,    0, { 3.5, 2.4, 3.5 }, { 6.6, 3.6, 5.4 },     PIECES(workshop) },
    { "library",     KIT_HOME,    0, { 4, 2.5, 4 },     { 7, 3.6, 6 },     PIECES(library) },
    { "attic",       KIT_HOME,    1, { 4.4, 2.5, 4 },   { 6, 3.2, 6 }, PIECES(attic) },
    { "bathroom",    KIT_BATH,    0, { 2.4, 2.3, 2.4 }, { 3.8, 2.9, 3.6 }, PIECES(bathroom) },
    { "nursery",     KIT_NURSERY, 0, { 3, 2.4, 3 },     { 4.8, 3, 4.6 },   PIECES(nursery) },
    { "studio",      KIT_SHOP,    1, { 4.6, 2.6, 4.2 }, { 6.4, 3.4, 6.2 },     PIECES(workshop) }
};

/* clang-format on */
enum { KINDS = sizeof kinds / sizeof *kinds };

/* ---- >>placing --------------------------------------------------------------------------------------------------- */

static void make_piece(kit_room *r, const piece *p, const double s[3], double x, double y, double z, double turn)
{
    kit_build *b = r->b;
    const kit_frame before = kit_enter(b, x, y + KIT_GAP, z, turn, 1);
    if (p->name) kit_begin_object(b, p->name, -1);
    if (p->where != FLOOR) room_sight_here(r, 0, 0.5 * s[1], 0.5 * s[2], fmax(0.35, 0.5 * fmax(s[0], s[1])));
    p->make(r, s);
    kit_leave(b, before);
}

/* Along a wall: at a corner, or anywhere. */
static int against_wall(kit_room *r, const piece *p, const double s[3])
{
    kit_build *b = r->b;
    const double gap = p->where == HANGING ? 0.1 : 0.025, low[3] = { -0.5 * s[0] - 0.02, p->y, 0 },
                 high[3] = { 0.5 * s[0] + 0.02, p->y + s[1] + 0.02, s[2] + (p->where == HANGING ? 0.02 : 0.06) };
    for (int k = 0; k < 40; k++) {
        const int wall = kit_choose(b, 4), corner = p->where == CORNER || (p->where == WALL && kit_odds(b, 0.4));
        const double length = r->size[wall & 1 ? 2 : 0],
                     y = p->where == HANGING ? p->y + kit_between(b, -0.1, 0.2) : p->y;
        double origin[2], along = kit_between(b, 0.5 * s[0] + gap, length - 0.5 * s[0] - gap);
        if (length < s[0] + 2 * gap || y + s[1] > r->size[1] - 0.02) continue;
        if (corner) along = kit_odds(b, 0.5) ? 0.5 * s[0] + gap : length - 0.5 * s[0] - gap;
        room_wall_point(r, wall, along, 0.022, origin);
        kit_block c = room_quarter_block(origin[0], origin[1], wall, low, high);
        c.low[1] = y;
        c.high[1] = y + s[1];
        if (!room_claim_space(r, &c, 0)) continue;
        make_piece(r, p, s, origin[0], y, origin[1], 90 * wall);
        return 1;
    }
    return 0;
}

static int standing_free(kit_room *r, const piece *p, const double s[3])
{
    kit_build *b = r->b;
    for (int k = 0; k < 30; k++) {
        const int quarter = kit_choose(b, 4), loose = p->where == LOOSE;
        const double turn = 90 * quarter
                          + (loose              ? kit_between(b, -40, 40)
                             : kit_odds(b, 0.3) ? kit_between(b, -4, 4)
                                                : 0),
                     wide = loose ? 0.5 * hypot(s[0], s[2]) * 0.92 : 0.5 * s[0], deep = loose ? wide : 0.5 * s[2];
        const double low[3] = { -wide - 0.03, p->where == FLOOR ? -0.01 : 0, -deep - 0.03 },
                     high[3] = { wide + 0.03, p->where == FLOOR ? -0.001 : s[1], deep + 0.03 };
        const double reach = quarter & 1 ? deep : wide, other = quarter & 1 ? wide : deep,
                     x0 = 0.5 * r->size[0] - reach - 0.08, z0 = 0.5 * r->size[2] - other - 0.08;
        if (x0 < 0 || z0 < 0) continue;
        const double x = kit_between(b, -x0, x0), z = kit_between(b, -z0, z0), a = turn * KIT_PI / 180;
        const kit_block c = room_quarter_block(x, z, quarter, low, high);
        if (!room_claim_space(r, &c, 0)) continue;
        make_piece(r, p, s, x - 0.5 * s[2] * sin(a), 0, z - 0.5 * s[2] * cos(a), turn);
        return 1;
    }
    return 0;
}

static void add_piece(kit_room *r, const piece *p)
{
    double s[3];
    if (r->b->scene.objects > 215 || r->b->scene.mesh.triangles > MOST_TRIANGLES) return;
    for (int e = 0; e < 3; e++) s[e] = kit_between(r->b, p->low[e], p->high[e]);
    if (p->where == FREE || p->where == LOOSE || p->where == FLOOR) standing_free(r, p, s);
    else against_wall(r, p, s);
}

static void strewn(kit_room *r, const double s[3]) { room_clutter(r, -0.5 * s[0], 0, 0.5 * s[0], s[2], 0, 0.5, 1); }

/* What the kind has, then more of what may be there several times, then things on the floor. */
static void furnish(kit_room *r, const kind *k)
{
    static const piece on_floor = { "things", strewn, LOOSE, 0, 0, { 0.35, 0.4, 0.35 }, { 0.7, 0.4, 0.6 }, 0 };
    kit_build *b = r->b;
    const double area = r->size[0] * r->size[2];
    for (int i = 0; i < k->count; i++) {
        const piece *p = &k->pieces[i];
        const double want = p->least + (p->most - p->least + 0.99) * kit_chance(b) * (0.6 + 0.4 * r->clutter);
        for (int n = (int)fmax(p->least, want); n > 0; n--) add_piece(r, p);
    }
    for (int n = (int)(area * (0.2 + 0.8 * r->clutter)); n > 0; n--) {
        const piece *p = &k->pieces[kit_choose(b, k->count)];
        if (p->most > 1 && p->where != FLOOR) add_piece(r, p);
    }
    for (int n = (int)(area * r->clutter * (r->theme & (KIT_BATH | KIT_KITCHEN) ? 0.1 : 0.35)); n > 0; n--)
        add_piece(r, &on_floor);
}

/* ---- >>style ----------------------------------------------------------------------------------------------------- */

static void keep(const kit_build *b, float out[3]) { memcpy(out, b->albedo, sizeof b->albedo); }

static void draw_style(kit_room *r)
{
    static const float woods[][3] = { { 0.55f, 0.38f, 0.22f },
                                      { 0.30f, 0.18f, 0.10f },
                                      { 0.68f, 0.54f, 0.36f },
                                      { 0.42f, 0.24f, 0.13f },
                                      { 0.74f, 0.66f, 0.52f } };
    static const float trims[][3] = {
        { 0.84f, 0.83f, 0.80f }, { 0.75f, 0.72f, 0.64f }, { 0.30f, 0.36f, 0.34f }, { 0.62f, 0.66f, 0.68f }
    };
    static const float metals[][3] = {
        { 0.55f, 0.55f, 0.56f }, { 0.10f, 0.10f, 0.11f }, { 0.58f, 0.45f, 0.22f }, { 0.35f, 0.36f, 0.38f }
    };
    static const float cloths[][3] = { { 0.45f, 0.43f, 0.40f }, { 0.20f, 0.28f, 0.38f }, { 0.50f, 0.20f, 0.16f },
                                       { 0.66f, 0.60f, 0.48f }, { 0.22f, 0.33f, 0.24f }, { 0.36f, 0.22f, 0.34f },
                                       { 0.76f, 0.74f, 0.70f } };
    static const float accents[][3] = { { 0.72f, 0.38f, 0.10f }, { 0.16f, 0.40f, 0.44f }, { 0.62f, 0.16f, 0.14f },
                                        { 0.24f, 0.26f, 0.44f }, { 0.70f, 0.60f, 0.22f }, { 0.34f, 0.44f, 0.22f } };
    kit_build *b = r->b;
    KIT_TINT(b, woods, 0.15);
    keep(b, r->wood);
    KIT_TINT(b, trims, 0.08);
    keep(b, r->trim);
    KIT_TINT(b, metals, 0.1);
    keep(b, r->metal);
    KIT_TINT(b, cloths, 0.15);
    keep(b, r->cloth);
    KIT_TINT(b, accents, 0.15);
    keep(b, r->accent);
    r->chair = kit_choose(b, KIT_CHAIRS - 1);
    r->table = kit_choose(b, KIT_TABLES);
    r->clutter = kit_between(b, 0.05, 1);
}

void kit_make_room(kit_plot *p)
{
    kit_build *b = &p->b;
    kit_room room = { .p = p, .b = b }, *r = &room;
    const kind *k = &kinds[kit_choose(b, KINDS)];
    draw_style(r);
    r->theme = k->theme;
    for (int i = 0; i < 3; i++) r->size[i] = kit_between(b, k->low[i], k->high[i]);
    p->stand[0] = -0.5 * r->size[0] + 0.12;
    p->stand[1] = -0.5 * r->size[2] + 0.12;
    p->stand[2] = -p->stand[0];
    p->stand[3] = -p->stand[1];
    p->ceiling = r->size[1];
    room_build_shell(r, k->attic);
    kit_add_sight(p, 0, 0.4 * r->size[1], 0, 0.3 * fmin(r->size[0], r->size[2]));
    furnish(r, k);
    const kit_frame before = kit_enter(b, 0, r->size[1], 0, 0, 1);
    room_ceiling_things(r);
    kit_leave(b, before);
}
