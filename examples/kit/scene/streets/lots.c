/* lots.c - what layouts of streets are put together of: ground, rows of houses, things put down, a skyline. Declared in
   streets.h. */
#include "kit/scene/streets/streets.h"
#include <math.h>
#include <string.h>

/* ---- >>ground -------------------------------------------------------------------------------------------------- */

void kit_town_ground(kit_plot *p, double size)
{
    static const float roads[][3] = {
        { 0.16f, 0.16f, 0.17f }, { 0.26f, 0.25f, 0.24f }, { 0.34f, 0.32f, 0.29f }, { 0.42f, 0.38f, 0.32f }
    };
    kit_build *b = &p->b;
    kit_begin_object(b, "ground", 0);
    KIT_TINT(b, roads, 0.15);
    kit_level(b, -size, -size, size, size, 0);
}

void kit_town_paving(kit_build *b, const double r[4], double y, double size)
{
    const double area = (r[2] - r[0]) * (r[3] - r[1]), least = sqrt(area / 2500), step = fmax(size, least),
                 joint = fmin(0.03, 0.06 * step), grey = kit_between(b, 0.26, 0.5), bond = kit_odds(b, 0.5) ? 0.5 : 0;
    const int nx = (int)fmax(1, (r[2] - r[0]) / step), nz = (int)fmax(1, (r[3] - r[1]) / step);
    const double sx = (r[2] - r[0]) / nx, sz = (r[3] - r[1]) / nz;
    for (int k = 0; k < nx * nz; k++) {
        const double x0 = r[0] + sx * (k % nx), shift = k % nx & 1 ? bond * sz : 0,
                     z0 = fmin(r[1] + sz * (k / nx) + shift, r[3] - joint), x1 = x0 + sx - joint,
                     z1 = fmin(z0 + sz, r[3]) - joint, e = 0.4 * joint, tone = grey * kit_between(b, 0.8, 1.15);
        const double top = y + kit_between(b, 0, 0.006), low = y - 0.02;
        const double at[4][2] = { { x0, z1 }, { x1, z1 }, { x1, z0 }, { x0, z0 } };
        if (z1 - z0 < 3 * joint) continue;
        kit_colour(b, tone, 0.96 * tone, 0.9 * tone);
        kit_level(b, x0 + e, z0 + e, x1 - e, z1 - e, top);
        for (int i = 0; i < 4; i++) {
            const int n = (i + 1) % 4;
            const double ax = at[i][0] > x0 ? -e : e, az = at[i][1] > z0 ? -e : e, bx = at[n][0] > x0 ? -e : e,
                         bz = at[n][1] > z0 ? -e : e;
            const double side[4][3] = { { at[i][0], low, at[i][1] },
                                        { at[n][0], low, at[n][1] },
                                        { at[n][0] + bx, top, at[n][1] + bz },
                                        { at[i][0] + ax, top, at[i][1] + az } };
            kit_quad(b, side);
        }
    }
}

void kit_town_pavement(kit_build *b, const double r[4], double y, double size)
{
    const double tone = kit_between(b, 0.3, 0.45);
    kit_colour(b, tone, 0.97 * tone, 0.92 * tone);
    kit_box(b, r[0], -0.05, r[1], r[2], y, r[3]);
    if (size > 0) {
        const double in[4] = { r[0] + 0.18, r[1] + 0.18, r[2] - 0.18, r[3] - 0.18 };
        kit_town_paving(b, in, y + 0.012, size);
    }
}

/* ---- >>sights ---------------------------------------------------------------------------------------------------- */

void kit_town_range(kit_plot *p, double x0, double z0, double x1, double z1)
{
    const double stand[4] = { x0, z0, x1, z1 };
    memcpy(p->stand, stand, sizeof stand);
}

void kit_town_sight(kit_plot *p, double x, double y, double z, double reach)
{
    const kit_sight s = { { x, y, z }, reach };
    if (p->sights < KIT_SIGHTS) kit_add_sight(p, x, y, z, reach);
    else p->sight[kit_choose(&p->b, KIT_SIGHTS)] = s;
}

/* ---- >>things -------------------------------------------------------------------------------------------------- */

kit_frame kit_town_stand(kit_plot *p, const char *name, const double at[3], double turn, double reach)
{
    kit_begin_object(&p->b, name, -1);
    kit_town_sight(p, at[0], at[1] + 0.6 * reach, at[2], reach);
    return kit_enter(&p->b, at[0], at[1], at[2], turn, 1);
}

static const struct thing {
    const char *name;
    double reach;
    void (*make)(kit_build *);
} things[KIT_THINGS] = { [KIT_CAR] = { "car", 1.8, kit_town_car },
                         [KIT_BICYCLE] = { "bicycle", 0.8, kit_town_bicycle },
                         [KIT_BIN] = { "bin", 0.6, kit_town_bin },
                         [KIT_DUMPSTER] = { "dumpster", 1.1, kit_town_dumpster },
                         [KIT_BENCH] = { "bench", 0.9, kit_town_bench },
                         [KIT_BOLLARD] = { "bollard", 0.6, kit_town_bollard },
                         [KIT_HYDRANT] = { "hydrant", 0.5, kit_town_hydrant },
                         [KIT_SIGN] = { "sign", 1.6, kit_town_sign_post },
                         [KIT_LIGHT] = { "light", 2, kit_town_traffic_light },
                         [KIT_BILLBOARD] = { "billboard", 4, kit_town_billboard },
                         [KIT_SHELTER] = { "shelter", 1.9, kit_town_shelter },
                         [KIT_CONE] = { "cone", 0.5, kit_town_cone },
                         [KIT_POT] = { "pot", 0.5, kit_town_pot },
                         [KIT_STALL] = { "stall", 1.7, kit_town_stall },
                         [KIT_CAFE] = { "table", 1.2, kit_town_cafe },
                         [KIT_CRATES] = { "crates", 0.8, kit_town_crates },
                         [KIT_FOUNTAIN] = { "fountain", 2.2, kit_town_fountain },
                         [KIT_MONUMENT] = { "monument", 3, kit_town_monument },
                         [KIT_PALLET] = { "pallet", 0.8, kit_town_pallet } };

void kit_town_put(kit_plot *p, int thing, double x, double y, double z, double turn)
{
    kit_build *b = &p->b;
    const double at[3] = { x, y, z }, tall = thing == KIT_TREE      ? kit_between(b, 4, 9)
                                           : thing == KIT_TALL_LAMP ? kit_between(b, 6, 9)
                                                                    : 3.6;
    const struct thing *t = &things[thing];
    const char *name = thing == KIT_TREE   ? "tree"
                     : thing == KIT_SHRUB  ? "shrub"
                     : thing == KIT_PERSON ? "person"
                     : thing == KIT_HEAP   ? "heap"
                     : thing == KIT_POLE   ? "pole"
                     : t->make             ? t->name
                                           : "lamp";
    const kit_frame was = kit_town_stand(p, name, at, turn, t->make ? t->reach : thing == KIT_TREE ? 0.45 * tall : 1.1);
    kit_colour(b, 0.2, 0.2, 0.21);
    if (t->make) t->make(b);
    else if (thing == KIT_TREE) kit_town_street_tree(b, tall);
    else if (thing == KIT_SHRUB) kit_town_shrub(b, kit_between(b, 0.8, 1.8));
    else if (thing == KIT_PERSON) kit_town_person(b, 0);
    else if (thing == KIT_HEAP) kit_town_heap(b, kit_between(b, 1.2, 2.6));
    else if (thing == KIT_POLE) kit_town_wire_pole(b, kit_between(b, 7, 9));
    else kit_town_lamp_post(p, tall);
    kit_leave(b, was);
}

/* ---- >>houses -------------------------------------------------------------------------------------------------- */

/* What is put before a house that stands, in its frame. */
static void before_it(kit_plot *p, kit_town *t, const kit_house *h)
{
    kit_build *b = &p->b;
    if (t->scaffold && kit_odds(b, 0.4)) {
        t->scaffold = 0;
        kit_begin_object(b, "scaffold", -1);
        kit_town_scaffold(b, h->width - 0.4, kit_town_eaves(h) + 0.5, kit_odds(b, 0.5));
    } else if (h->style == KIT_BRICK && h->width > 5.5 && h->floors > 2 && kit_odds(b, 0.55)) {
        kit_begin_object(b, "fire escape", -1);
        kit_town_fire_escape(b, h, kit_between(b, 0.4, h->width - 4.6));
    }
}

/* what is far off has fewer parts */
static void plainer(kit_house *h)
{
    h->rows = 1 + (h->rows > 2);
    if (h->columns > 2) h->columns = 2;
    h->dentils = 0;
    if (h->shutters > 1) h->shutters = 1;
    if (h->rail == KIT_BARS) h->balconies *= 0.4;
    h->pots = 0;
    h->cladding = 0;
}

void kit_town_row(kit_plot *p, kit_town *t, double x0, double z0, double x1, double z1)
{
    kit_build *b = &p->b;
    const double dx = x1 - x0, dz = z1 - z0, length = hypot(dx, dz), turn = 180 / KIT_PI * atan2(-dz, dx);
    const double ux = dx / length, uz = dz / length;
    for (double at = 0, wide; at < length - 2.5; at += wide + 0.02) {
        kit_house h;
        const int style = t->style[kit_odds(b, 0.3)];
        const double back = kit_odds(b, 0.3) ? kit_between(b, 0, 0.4) : 0;
        double eye[3];
        kit_town_draw_house(b, &h, style);
        wide = style == KIT_MODERN || style == KIT_PANEL || style == KIT_WAREHOUSE ? kit_between(b, 11, 22)
                                                                                   : kit_between(b, 5, 13);
        if (length - at - wide < 4) wide = length - at;
        h.width = wide;
        if (t->floors && h.floors > t->floors) h.floors = t->floors - kit_choose(b, 2);
        if (h.floors < 1) h.floors = 1;
        if (!t->shops) h.shops = 0;
        h.coolers *= 2 * (1 - t->upkeep);
        if (hypot(x0 + ux * (at + 0.5 * wide), z0 + uz * (at + 0.5 * wide)) > 14) plainer(&h);
        const kit_frame was = kit_enter(b, x0 + ux * at - uz * -back, t->pave, z0 + uz * at - ux * back, turn, 1);
        kit_town_raise_house(p, &h);
        before_it(p, t, &h);
        for (int k = 0; k < 2; k++) {
            kit_town_to_world(b, kit_between(b, 0.2, 0.8) * wide, k ? kit_between(b, 0.4, 1) * kit_town_eaves(&h) : 1.8,
                              0.3, eye);
            if (kit_odds(b, hypot(eye[0], eye[2]) < 16 ? 0.5 : 0.15))
                kit_town_sight(p, eye[0], eye[1], eye[2], kit_between(b, 1.8, 4));
        }
        kit_leave(b, was);
    }
}

void kit_town_skyline(kit_plot *p, double radius)
{
    kit_build *b = &p->b;
    const int count = 16 + kit_choose(b, 14);
    kit_begin_object(b, "skyline", -1);
    for (int k = 0; k < count; k++) {
        static const int styles[] = { KIT_TOWER, KIT_PANEL, KIT_OLD, KIT_MODERN };
        kit_house h;
        const double a = 360.0 * (k + kit_between(b, -0.3, 0.3)) / count, t = a * KIT_PI / 180,
                     r = radius * kit_between(b, 1, 1.5);
        kit_town_draw_house(b, &h, styles[kit_choose(b, 4)]);
        h.fine = 0;
        h.floors = h.floors > 14 ? 14 : h.floors;
        h.width = h.bay = kit_between(b, 0.18, 0.3) * radius;
        h.window[0] = 0.9 * h.width;
        h.arched = 0;
        const kit_frame was = kit_enter(b, r * sin(t), 0, r * cos(t), a + 180, 1);
        kit_town_raise_house(p, &h);
        kit_leave(b, was);
    }
}
