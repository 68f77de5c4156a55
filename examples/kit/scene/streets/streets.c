/* streets.c - scenes by seed of streets: which layout there is. Declared in kit_seed.h. */
#include "kit/scene/streets/streets.h"
#include <string.h>

void kit_make_street(kit_plot *p)
{
    static void (*const layouts[])(kit_plot *,
                                   kit_town *) = { kit_town_lay_street, kit_town_lay_square, kit_town_lay_alley,
                                                   kit_town_lay_suburb, kit_town_lay_court,  kit_town_lay_street,
                                                   kit_town_lay_city,   kit_town_lay_site,   kit_town_lay_forecourt,
                                                   kit_town_lay_canal,  kit_town_lay_steps };
    static const int old[][2] = { { KIT_OLD, KIT_OLD },         { KIT_BRICK, KIT_OLD },   { KIT_BRICK, KIT_MODERN },
                                  { KIT_MODERN, KIT_PANEL },    { KIT_OLD, KIT_COTTAGE }, { KIT_PANEL, KIT_WAREHOUSE },
                                  { KIT_WAREHOUSE, KIT_BRICK }, { KIT_OLD, KIT_MODERN } };
    kit_build *b = &p->b;
    kit_town t = { { 0 }, 0, kit_odds(b, 0.7), kit_chance(b), kit_between(b, 0.1, 0.17), kit_odds(b, 0.35) };
    const int which = kit_choose(b, (int)(sizeof layouts / sizeof *layouts));
    memcpy(t.style, old[kit_choose(b, 8)], sizeof t.style);
    layouts[which](p, &t);
}
