/* houses.c - how buildings of streets look, by style. Declared in streets.h. */
#include "kit/scene/streets/streets.h"
#include <math.h>
#include <string.h>

void kit_town_paint(kit_build *b, const float c[3]) { memcpy(b->albedo, c, sizeof b->albedo); }

void kit_town_keep(const kit_build *b, float c[3]) { memcpy(c, b->albedo, sizeof b->albedo); }

double kit_town_eaves(const kit_house *h) { return h->ground + h->storey * (h->floors - 1); }

/* ---- >>looks --------------------------------------------------------------------------------------------------- */

/* Each number is drawn between two. */
typedef struct look {
    double storey[2], ground[2], bay[2], wide[2], high[2], sill[2], recess[2];
    double shutters, courses, dentils, quoins, arched, shops, balconies, coolers, pots;
    int floors[2];
} look;

static const look looks[KIT_HOUSES] = { [KIT_OLD] = { { 2.9, 3.5 },
                                                      { 3.5, 4.2 },
                                                      { 2.1, 3 },
                                                      { 0.9, 1.15 },
                                                      { 1.6, 2.1 },
                                                      { 0.5, 0.8 },
                                                      { 0.14, 0.32 },
                                                      0.6,
                                                      0.7,
                                                      0.4,
                                                      0.35,
                                                      0.25,
                                                      0.6,
                                                      0.25,
                                                      0.03,
                                                      0.2,
                                                      { 2, 5 } },
                                        [KIT_BRICK] = { { 3, 3.4 },
                                                        { 3.4, 4 },
                                                        { 1.9, 2.6 },
                                                        { 0.9, 1.2 },
                                                        { 1.5, 1.9 },
                                                        { 0.6, 0.9 },
                                                        { 0.1, 0.22 },
                                                        0.1,
                                                        0.5,
                                                        0.7,
                                                        0.2,
                                                        0.25,
                                                        0.7,
                                                        0.05,
                                                        0.2,
                                                        0.08,
                                                        { 3, 6 } },
                                        [KIT_MODERN] = { { 2.7, 3.1 },
                                                         { 3.2, 4.2 },
                                                         { 2.8, 4.4 },
                                                         { 1.6, 3 },
                                                         { 1.5, 2.3 },
                                                         { 0.2, 0.9 },
                                                         { 0.08, 0.4 },
                                                         0,
                                                         0.3,
                                                         0,
                                                         0,
                                                         0,
                                                         0.6,
                                                         0.5,
                                                         0.05,
                                                         0.1,
                                                         { 3, 7 } },
                                        [KIT_PANEL] = { { 2.6, 2.8 },
                                                        { 2.8, 3.4 },
                                                        { 2.4, 3.3 },
                                                        { 1.1, 1.8 },
                                                        { 1.2, 1.5 },
                                                        { 0.8, 0.9 },
                                                        { 0.1, 0.25 },
                                                        0,
                                                        0.2,
                                                        0,
                                                        0,
                                                        0,
                                                        0.3,
                                                        0.3,
                                                        0.4,
                                                        0.1,
                                                        { 4, 8 } },
                                        [KIT_COTTAGE] = { { 2.5, 2.8 },
                                                          { 2.6, 2.9 },
                                                          { 2.2, 3 },
                                                          { 0.9, 1.5 },
                                                          { 1.1, 1.4 },
                                                          { 0.8, 0.9 },
                                                          { 0.08, 0.2 },
                                                          0.5,
                                                          0.2,
                                                          0,
                                                          0.2,
                                                          0.08,
                                                          0,
                                                          0.03,
                                                          0.03,
                                                          0.3,
                                                          { 1, 2 } },
                                        [KIT_WAREHOUSE] = { { 3.5, 4.5 },
                                                            { 4, 5 },
                                                            { 3.4, 4.5 },
                                                            { 1.8, 2.8 },
                                                            { 1.6, 2.4 },
                                                            { 1, 1.4 },
                                                            { 0.1, 0.35 },
                                                            0,
                                                            0.6,
                                                            0.2,
                                                            0.2,
                                                            0.3,
                                                            0.1,
                                                            0,
                                                            0.2,
                                                            0,
                                                            { 1, 3 } },
                                        [KIT_TOWER] = { { 3.3, 3.9 },
                                                        { 4, 6 },
                                                        { 2, 5 },
                                                        { 1.5, 4.6 },
                                                        { 1.6, 3 },
                                                        { 0.3, 0.9 },
                                                        { 0.1, 0.5 },
                                                        0,
                                                        0,
                                                        0,
                                                        0,
                                                        0,
                                                        0,
                                                        0,
                                                        0,
                                                        0,
                                                        { 9, 26 } } };

static const float walls[KIT_HOUSES][5][3] = { { { 0.72f, 0.58f, 0.36f },
                                                 { 0.75f, 0.7f, 0.58f },
                                                 { 0.62f, 0.42f, 0.34f },
                                                 { 0.78f, 0.76f, 0.72f },
                                                 { 0.5f, 0.56f, 0.56f } },
                                               { { 0.36f, 0.17f, 0.12f },
                                                 { 0.44f, 0.24f, 0.17f },
                                                 { 0.5f, 0.36f, 0.26f },
                                                 { 0.3f, 0.19f, 0.15f },
                                                 { 0.55f, 0.48f, 0.4f } },
                                               { { 0.8f, 0.8f, 0.78f },
                                                 { 0.5f, 0.5f, 0.49f },
                                                 { 0.3f, 0.3f, 0.31f },
                                                 { 0.7f, 0.62f, 0.52f },
                                                 { 0.46f, 0.33f, 0.22f } },
                                               { { 0.55f, 0.54f, 0.52f },
                                                 { 0.62f, 0.6f, 0.54f },
                                                 { 0.48f, 0.5f, 0.54f },
                                                 { 0.66f, 0.6f, 0.5f },
                                                 { 0.58f, 0.5f, 0.44f } },
                                               { { 0.8f, 0.78f, 0.74f },
                                                 { 0.55f, 0.6f, 0.58f },
                                                 { 0.5f, 0.28f, 0.2f },
                                                 { 0.72f, 0.64f, 0.46f },
                                                 { 0.45f, 0.5f, 0.56f } },
                                               { { 0.4f, 0.22f, 0.16f },
                                                 { 0.5f, 0.5f, 0.48f },
                                                 { 0.6f, 0.58f, 0.54f },
                                                 { 0.34f, 0.4f, 0.42f },
                                                 { 0.56f, 0.44f, 0.32f } },
                                               { { 0.5f, 0.5f, 0.5f },
                                                 { 0.3f, 0.34f, 0.38f },
                                                 { 0.7f, 0.68f, 0.64f },
                                                 { 0.42f, 0.36f, 0.32f },
                                                 { 0.2f, 0.22f, 0.24f } } };
static const float trims[][3] = {
    { 0.74f, 0.71f, 0.64f }, { 0.6f, 0.57f, 0.5f }, { 0.82f, 0.81f, 0.78f }, { 0.45f, 0.43f, 0.4f }
};
static const float woods[][3] = { { 0.8f, 0.79f, 0.76f }, { 0.14f, 0.26f, 0.18f }, { 0.3f, 0.18f, 0.1f },
                                  { 0.2f, 0.3f, 0.4f },   { 0.12f, 0.12f, 0.12f }, { 0.4f, 0.12f, 0.1f } };
static const float tiles[][3] = {
    { 0.5f, 0.24f, 0.15f }, { 0.2f, 0.2f, 0.22f }, { 0.36f, 0.24f, 0.18f }, { 0.3f, 0.33f, 0.33f }
};

static double drawn(kit_build *b, const double range[2]) { return kit_between(b, range[0], range[1]); }

static int roof_of(kit_build *b, int style)
{
    if (style == KIT_OLD) return kit_odds(b, 0.4) ? KIT_HIP : kit_odds(b, 0.8) ? KIT_GABLE : KIT_CROSS_GABLE;
    if (style == KIT_COTTAGE) return kit_odds(b, 0.6) ? KIT_GABLE : KIT_CROSS_GABLE;
    return style == KIT_WAREHOUSE && kit_odds(b, 0.5) ? KIT_GABLE : KIT_FLAT;
}

void kit_town_draw_house(kit_build *b, kit_house *h, int style)
{
    const look *l = &looks[style];
    memset(h, 0, sizeof *h);
    h->style = style;
    h->fine = style != KIT_TOWER;
    h->sides = KIT_FRONT;
    h->floors = l->floors[0] + kit_choose(b, l->floors[1] - l->floors[0] + 1);
    h->width = 10;
    h->depth = kit_between(b, 8, 12);
    h->storey = drawn(b, l->storey);
    h->ground = drawn(b, l->ground);
    h->bay = drawn(b, l->bay);
    h->window[0] = drawn(b, l->wide);
    h->window[1] = drawn(b, l->high);
    h->sill = drawn(b, l->sill);
    h->recess = drawn(b, l->recess);
    h->shutters = kit_odds(b, l->shutters) ? 1 + kit_odds(b, 0.75) : 0;
    h->courses = kit_odds(b, l->courses) ? 1 + kit_choose(b, 2) : 0;
    h->dentils = kit_odds(b, l->dentils);
    h->quoins = kit_odds(b, l->quoins);
    h->cladding = style == KIT_COTTAGE                   ? kit_odds(b, 0.55)
                : style == KIT_OLD || style == KIT_BRICK ? 2 * kit_odds(b, 0.5)
                : style == KIT_WAREHOUSE                 ? 3 * kit_odds(b, 0.6)
                                                         : 0;
    h->arched = kit_odds(b, l->arched);
    h->columns = 1 + kit_choose(b, 3);
    h->rows = 1 + kit_choose(b, 4);
    h->rail = style < KIT_MODERN ? KIT_BARS : kit_choose(b, 4);
    h->shops = kit_odds(b, 0.25) ? 0 : l->shops;
    h->balconies = kit_odds(b, 0.5) ? l->balconies : 0.2 * l->balconies;
    h->coolers = l->coolers;
    h->pots = kit_odds(b, 0.5) ? l->pots : 0;
    h->awnings = kit_between(b, 0, 1);
    h->roof = roof_of(b, style);
    kit_tint(b, walls[style], 5, 0.12);
    kit_town_keep(b, h->wall);
    KIT_TINT(b, trims, 0.1);
    kit_town_keep(b, h->trim);
    KIT_TINT(b, woods, 0.2);
    kit_town_keep(b, h->wood);
    KIT_TINT(b, tiles, 0.2);
    kit_town_keep(b, h->cover);
}
