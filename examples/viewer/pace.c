/* pace.c - chooses the size of frames by the time that they take. While the view moves, a frame takes at most a quarter
   of a second; once it has been still for a while, the size is the window's, however long that takes. If surfels are
   too slow at the least size, they are coarser while the view moves. */
#include "viewer.h"
#include <math.h>

static const double shares[] = { 1,      0.875, 0.75,    0.625,  0.5,     0.4375, 0.375,
                                 0.3125, 0.25,  0.21875, 0.1875, 0.15625, 0.125 };

enum { SHARES = (int)(sizeof shares / sizeof *shares), COARSEST = 3 };

/* a frame's milliseconds between which the size stays, so that it does not oscillate */
static const double most_ms = 250, wanted_ms = 220;
static const double rest_seconds = 0.4;

double pace_share(const pace *p) { return p->fixed > 0 ? p->fixed : p->still ? 1 : shares[p->level]; }

/* Sets the size of images, which are at least 90 pixels high: less would show nothing. */
void pace_size(pace *p, const int window[2], int size[2])
{
    p->lowest = 0;
    while (p->lowest + 1 < SHARES && shares[p->lowest + 1] * window[1] >= 90) ++p->lowest;
    if (p->level > p->lowest) p->level = p->lowest;
    for (int k = 0; k < 2; ++k) size[k] = (int)fmax(8, floor(pace_share(p) * window[k] + 0.5));
}

/* Begins at a size whose first frame does not take seconds, if the CPU draws. */
void pace_begin(pace *p, const int window[2], int software)
{
    p->level = 0;
    while (software && p->level + 1 < SHARES
           && shares[p->level] * shares[p->level] * window[0] * window[1] > 640 * 360.0)
        ++p->level;
}

/* Returns the index of the largest share whose time, predicted by its pixels, is at most wanted_ms. */
static int level_of(const pace *p, double ms)
{
    int level = p->level;
    while (level < p->lowest && ms * pow(shares[level] / shares[p->level], 2) > wanted_ms) ++level;
    while (level > 0 && ms * pow(shares[level - 1] / shares[p->level], 2) <= wanted_ms) --level;
    return level;
}

/* Returns the factor by which surfels are widened now, to be fewer. */
double pace_coarse(const pace *p) { return p->still || p->fixed > 0 ? 1 : 1 << p->coarse; }

int pace_took(pace *p, double ms, int surfels)
{
    const int was = p->level, coarse = p->coarse, level = level_of(p, ms);
    if (p->fixed > 0 || p->still) return 0;
    if (!surfels) p->coarse = 0;
    else if (p->level == p->lowest && ms > most_ms && p->coarse < COARSEST) ++p->coarse;
    else if (p->coarse && 3 * ms < wanted_ms) --p->coarse;
    if (p->coarse != coarse) return 1;
    if (ms > most_ms || level < p->level) p->level = level;
    return p->level != was;
}

int pace_waits(const pace *p) { return p->fixed > 0 || p->still || kit_seconds() < p->moved + rest_seconds; }

void pace_stays(pace *p) { p->still |= !pace_waits(p); }

void pace_moves(pace *p)
{
    p->still = 0;
    p->moved = kit_seconds();
}
