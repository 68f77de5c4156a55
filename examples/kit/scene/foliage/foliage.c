/* foliage.c - scenes by seed of plants: which layout, in which season. The layouts are in wilds.c, gardens.c and
   crops.c. Declared in kit_seed.h. */
#include "kit/scene/foliage/foliage.h"

void kit_make_foliage(kit_plot *p)
{
    static garden_layout *const layouts[] = { kit_lay_dry,        kit_lay_stones,  kit_lay_pond,       kit_lay_bamboo,
                                              kit_lay_maze,       kit_lay_terrace, kit_lay_orchard,    kit_lay_park,
                                              kit_lay_vegetables, kit_lay_meadow,  kit_lay_woods,      kit_lay_parterre,
                                              kit_lay_garden,     kit_lay_ruin,    kit_lay_greenhouse, kit_lay_jungle };
    static const int seasons[] = { KIT_SUMMER, KIT_SUMMER, KIT_SPRING, KIT_AUTUMN, KIT_BLOSSOM };
    kit_build *b = &p->b;
    kit_yard y = { p, 0, 0, { { 0 } } };
    p->stand[0] = p->stand[1] = -13;
    p->stand[2] = p->stand[3] = 13;
    const int layout = kit_choose(b, (int)(sizeof layouts / sizeof *layouts));
    y.season = seasons[kit_choose(b, 5)];
    layouts[layout](&y);
    for (int k = 0; k < 5; k++)
        garden_sight_above(&y, kit_between(b, -4, 4), kit_between(b, 0.4, 1.6), kit_between(b, -4, 4), 2.2);
}
