/* pace.c - the size that there is time for: so small that a key is answered within a quarter of a second. A key waits
   for the frame that is being drawn, then for its own. A view that stays may take as long as both do but for one that
   moves again. */
#include "viewer.h"
#include <math.h>

static const double shares[] = { 1, 0.75, 0.5, 0.375, 0.25, 0.1875, 0.125 };

enum { SHARES = (int)(sizeof shares / sizeof *shares) };

static const double most_ms = 100, wanted_ms = 70, still_ms = 110, most_still_ms = 140;

double pace_share(const pace *p) { return p->fixed > 0 ? p->fixed : shares[p->level - p->rest]; }

/* No picture is lower than 90 pixels for the time's sake: less would show nothing. */
void pace_size(pace *p, const int window[2], int size[2])
{
    p->lowest = 0;
    while (p->lowest + 1 < SHARES && shares[p->lowest + 1] * window[1] >= 90) ++p->lowest;
    if (p->level > p->lowest) p->level = p->lowest;
    if (p->rest > p->level) p->rest = p->level;
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

/* The least level from that one on, or above it, that takes no longer, by its pixels. */
static int level_of(double ms, int from, int lowest, double most)
{
    int level = from;
    while (level < lowest && ms * pow(shares[level] / shares[from], 2) > most) ++level;
    while (level > 0 && ms * pow(shares[level - 1] / shares[from], 2) <= most) --level;
    return level;
}

/* A level is tried, too, that takes too long by its pixels alone: some of the time does not depend on them. What took
   too long is not tried again at once. */
static int level_after(pace *p, double ms, int from, double most, double wanted)
{
    const int level = level_of(ms, from, p->lowest, wanted), may_try = kit_seconds() > p->failed + 3;
    if (ms > most) {
        p->failed = kit_seconds();
        return level;
    }
    if (level < from) return level;
    return from > 0 && ms <= wanted_ms && may_try ? from - 1 : from;
}

int pace_took(pace *p, double ms)
{
    const int was = p->level - p->rest;
    if (p->rest) p->rest = (int)fmax(0, p->level - level_after(p, ms, was, most_still_ms, still_ms));
    else {
        p->ms = ms;
        if (!(p->fixed > 0)) p->level = level_after(p, ms, p->level, most_ms, wanted_ms);
    }
    return p->level - p->rest != was;
}

int pace_tries(const pace *p)
{
    return p->still == 1 && !(p->fixed > 0) && p->level > p->rest && p->failed > 0 && kit_seconds() > p->failed + 3;
}

void pace_still(pace *p)
{
    const int tries = pace_tries(p);
    if (!(p->fixed > 0) && !p->still) p->rest = (int)fmax(0, p->level - level_of(p->ms, p->level, p->lowest, still_ms));
    if (tries) ++p->rest;
    p->still = tries ? 2 : p->still ? p->still : 1;
}

void pace_moves(pace *p) { p->rest = p->still = 0; }
