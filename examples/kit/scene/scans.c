/* scans.c - scenes by seed of this kind. Declared in kit_seed.h. */
#include "kit/kit_seed.h"
#include <math.h>

void kit_make_scan(kit_plot *p)
{
    kit_build *b = &p->b;
    kit_begin_object(b, "ground", 0);
    kit_level(b, -20, -20, 20, 20, 0);
    for (int i = 0; i < 20; i++) {
        const double half[3] = { kit_between(b, 0.2, 0.8), kit_between(b, 0.2, 0.8), kit_between(b, 0.2, 0.8) };
        kit_begin_object(b, "thing", -1);
        kit_place_at(b, kit_between(b, -4, 4), half[1], kit_between(b, -4, 4), kit_between(b, 0, 360));
        if (i & 1) kit_bevelled(b, -half[0], -half[1], -half[2], half[0], half[1], half[2], 0.1);
        else kit_cushion(b, half, 0.3, 16);
        kit_add_sight(p, b->at[0], b->at[1], b->at[2], 0.8);
    }
    p->stand[0] = p->stand[1] = -12;
    p->stand[2] = p->stand[3] = 12;
}
