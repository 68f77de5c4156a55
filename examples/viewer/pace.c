/* pace.c - the size that there is time for: so small that a key is answered within a quarter of a second. A key waits
   for the frame that is being drawn, then for its own. */
#include "viewer.h"
#include <math.h>

static const double shares[] = { 1, 0.75, 0.5, 0.375, 0.25, 0.1875, 0.125 };

enum { SHARES = (int)(sizeof shares / sizeof *shares) };

static const double most_ms = 100, wanted_ms = 70;

double pace_share(const pace *p) { return p->fixed > 0 ? p->fixed : shares[p->level]; }

void pace_size(const pace *p, const int window[2], int size[2])
{
    for (int k = 0; k < 2; ++k) size[k] = (int)fmax(8, floor(pace_share(p) * window[k] + 0.5));
}

/* Where a CPU draws, the first frame is not of a size that it would take seconds for. */
void pace_begin(pace *p, const int window[2], int software)
{
    p->level = 0;
    while (software && p->level + 1 < SHARES
           && shares[p->level] * shares[p->level] * window[0] * window[1] > 640 * 360.0)
        ++p->level;
}

/* What a size takes is guessed from its pixels; of the time that does not depend on them too much is expected, so that
   a larger size is not tried in vain. */
int pace_took(pace *p, double ms)
{
    const int was = p->level;
    int level = was;
    p->ms = ms;
    if (p->fixed > 0) return 0;
    if (ms > most_ms)
        while (level + 1 < SHARES && ms * pow(shares[level] / shares[was], 2) > wanted_ms) ++level;
    else
        while (level > 0 && ms * pow(shares[level - 1] / shares[was], 2) <= wanted_ms) --level;
    p->level = level;
    return level != was;
}
