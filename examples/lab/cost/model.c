/* model.c - the time of a pass: the longest of four times. Declared in model.h. */
#include "lab/cost/model.h"
#include <math.h>
#include <string.h>

enum { WAVE = 64, WAIT = 320 };             /* lanes of a wave; cycles until a fetch arrives */

const device devices[] = {
    { "RX 6800", "navi21", 60, 2, 32, 2.105, 512, 16, 8, 1 },
    { "Steam Deck", "navi21", 8, 2, 32, 1.6, 88, 16, 8, 1 },
    { "RX 480", "polaris10", 36, 4, 16, 1.266, 256, 4, 4, 0 },
    { "RX 5700 XT", "navi10", 40, 2, 32, 1.905, 448, 16, 8, 1 },
    { "RX Vega 64", "vega10", 64, 4, 16, 1.546, 484, 4, 4, 0 },
    /* for published times alone (xegtao.c): the instructions are those of navi21, whose assembly stands in */
    { "RX 6800 XT", "navi21", 72, 2, 32, 2.25, 512, 16, 8, 1 },
    { "RTX 3070", "navi21", 46, 4, 32, 1.725, 448, 4, 4, 1 },
    { "RTX 2060", "navi21", 30, 4, 16, 1.68, 336, 4, 4, 1 },
    { "GTX 1050", "navi21", 5, 4, 32, 1.455, 112, 8, 8, 1 },
    { "i7-1195G7", "navi21", 6, 16, 8, 1.4, 68.3, 8, 8, 1 }
};
const int devices_count = 5;

const char *const bound_names[BOUNDS] = { "alu", "tex", "hide", "memory" };

double model(const device *d, const load *l, bound *which)
{
    const double cycles = 1e6 * d->gigahertz;                               /* in a millisecond */
    const double lanes = d->units * d->simds * d->lanes, simds = d->units * d->simds;
    const double slow = 4 * l->transcendental, issue = (double)WAVE / d->lanes;
    const double waves = l->pixels / WAVE / simds;                          /* waves that each SIMD executes in all */
    const double alu = d->apart ? fmax(l->vector, slow) : l->vector + slow - l->transcendental;
    const double narrow = l->fetches - l->wide_fetches;
    const double wave = alu * issue + WAIT * l->fetches;
    const double ms[BOUNDS] = {
        l->pixels * alu / lanes / cycles,
        l->pixels * (narrow / d->fetches + l->wide_fetches / d->wide_fetches) / d->units / cycles,
        waves * wave / fmin(l->waves, fmax(waves, 1)) / cycles,
        l->bytes / (1e6 * d->gigabytes)
    };
    *which = ALU;
    for (int i = 0; i < BOUNDS; ++i) if (ms[i] > ms[*which]) *which = (bound)i;
    return ms[*which];
}

const device *device_of(const char *name)
{
    size_t i = 0;
    while (i < sizeof devices / sizeof *devices && strcmp(devices[i].name, name)) ++i;
    return i < sizeof devices / sizeof *devices ? &devices[i] : NULL;
}

trust trust_of(const double *modelled, const double *published, int count)
{
    trust t = { 0, INFINITY, 0 };
    for (int i = 0; i < count; ++i) {
        const double ratio = modelled[i] / published[i];
        t.mean += log(ratio) / count;
        t.least = fmin(t.least, ratio);
        t.most = fmax(t.most, ratio);
    }
    t.mean = exp(t.mean);
    return t;
}
