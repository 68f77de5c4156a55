/* pace.c - the size that there is time for: so small that a key is answered within a quarter of a second. A key waits
   for the frame that is being drawn, then for its own. A view that stays may take as long as both do but for one that
   moves again. Where surfels take longer than any size saves, they are coarser until the view has stayed a while. */
#include "viewer.h"
#include <math.h>

static const double shares[] = { 1, 0.75, 0.5, 0.375, 0.25, 0.1875, 0.125 };

enum { SHARES = (int)(sizeof shares / sizeof *shares), COARSEST = 3 };

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

/* How many times as wide as they shall be surfels are. */
double pace_coarse(const pace *p) { return p->still || p->fixed > 0 ? 1 : 1 << p->coarse; }

int pace_took(pace *p, double ms, int surfels)
{
    const int was = p->level - p->rest, coarse = p->coarse;
    if (p->fixed > 0) return 0;
    if (!surfels) p->coarse = 0;
    else if (p->still && p->coarse) return 0;      /* that once */
    else if (p->level == p->lowest && ms > most_ms && p->coarse < COARSEST) ++p->coarse;
    else if (p->coarse && 3 * ms < wanted_ms) --p->coarse;
    if (p->coarse != coarse) return 1;
    if (p->rest) p->rest = (int)fmax(0, p->level - level_after(p, ms, was, most_still_ms, still_ms));
    else {
        p->ms = ms;
        p->level = level_after(p, ms, p->level, most_ms, wanted_ms);
    }
    return p->level - p->rest != was;
}

/* After 3, 9, 27 and so many seconds of rest: what took long may have been another program's fault. */
int pace_tries(const pace *p)
{
    return p->still > 0 && !(p->fixed > 0) && !p->coarse && p->level > p->rest
           && kit_seconds() > p->tried + pow(3, fmin(p->still, 4));
}

/* Surfels as they shall be may take longer than a key should wait: they come when none was pressed for a while. */
int pace_waits(const pace *p) { return p->coarse && !p->still && kit_seconds() < p->tried + 0.4; }

void pace_still(pace *p)
{
    const int tries = pace_tries(p);
    if (!(p->fixed > 0) && !p->coarse && !p->still)
        p->rest = (int)fmax(0, p->level - level_of(p->ms, p->level, p->lowest, still_ms));
    if (tries) ++p->rest;
    if (tries || !p->still) {
        ++p->still;
        p->tried = kit_seconds();
    }
}

void pace_moves(pace *p)
{
    p->rest = p->still = 0;
    p->tried = kit_seconds();
}
