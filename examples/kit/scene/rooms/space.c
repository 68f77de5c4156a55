/* space.c - what of a room is taken. Declared in rooms.h. */
#include "kit/scene/rooms/rooms.h"
#include <math.h>

int room_claim_space(kit_room *r, const kit_block *c, int anyway)
{
    for (int k = 0; k < r->claims && !anyway; k++) {
        int apart = 0;
        for (int i = 0; i < 3; i++)
            apart = apart || c->low[i] >= r->claim[k].high[i] - 1e-6 || c->high[i] <= r->claim[k].low[i] + 1e-6;
        if (!apart) return 0;
    }
    if (r->claims < KIT_CLAIMS) r->claim[r->claims++] = *c;
    return 1;
}

/* A box of a wall's frame, or of one turned by quarters about (x, z), in the room. */
kit_block room_quarter_block(double x, double z, int quarter, const double low[3], const double high[3])
{
    static const int cosine[4] = { 1, 0, -1, 0 }, sine[4] = { 0, 1, 0, -1 };
    const double c = cosine[quarter & 3], s = sine[quarter & 3];
    const double a[2] = { x + c * low[0] + s * low[2], z + c * low[2] - s * low[0] },
                 e[2] = { x + c * high[0] + s * high[2], z + c * high[2] - s * high[0] };
    const kit_block out = { { fmin(a[0], e[0]), low[1], fmin(a[1], e[1]) },
                            { fmax(a[0], e[0]), high[1], fmax(a[1], e[1]) } };
    return out;
}
