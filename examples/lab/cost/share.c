/* share.c - which bodies a text has; what lanes do together. Declared in share.h. */
#include "lab/cost/share.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

#define GATHERED(condition) "told |= uint(" condition ") << uint(times++); shown = true;"

const body bodies[BODIES] = {
    { "cover", "if (any(t.up) || w.rose) {", GATHERED("any(t.up) || w.rose"), 0 },
    { "cover of solids", "if (any(t.up)) {", GATHERED("any(t.up)"), 0 },
    { "second", "if (any(up)) {", GATHERED("any(up)"), 0 },
    { "sent ahead", "if (first.x + second.x > 0.0)", GATHERED("first.x + second.x > 0.0"), 0 },
    { "sent behind", "if (first.y + second.y > 0.0)", GATHERED("first.y + second.y > 0.0"), 0 },
    { "unsettled", "int more = c.settled ? 0 : side * side;", "told = uint(!c.settled); shown = c.z < SSGI_FAR;", 1 },
    { "changed", "for (int k = 0; differ >> uint(k) != 0u; ++k) {", "told = differ; shown = true;", 16 }
};

const tile tiles[TILES] = { { "8x8", 8, 8 }, { "16x4", 16, 4 }, { "8x4", 8, 4 } };

int bodies_of(int of[BODIES], const char *text)
{
    int count = 0;
    for (int i = 0; i < BODIES; ++i) if (strstr(text, bodies[i].line)) of[count++] = i;
    return count;
}

static int ones(uint32_t bits)
{
    int count = 0;
    for (; bits; bits &= bits - 1) ++count;
    return count;
}

double share_of(const told *texel, int width, int height, const tile *t, int times, double *waves)
{
    double entered = 0, held = 0, all = 0;
    for (int y = 0; y < height; y += t->height)
        for (int x = 0; x < width; x += t->width) {
            uint32_t bits = 0;
            int shown = 0;
            for (int k = 0; k < t->width * t->height; ++k) {
                const int across = x + k % t->width, up = y + k / t->width;
                if (across >= width || up >= height) continue;
                bits |= (uint32_t)texel[up * width + across].entered;
                shown |= texel[up * width + across].shown > 0;
            }
            ++all;
            held += shown;
            if (shown) entered += ones(bits);
        }
    *waves = held / all;
    return held > 0 ? entered / (held * times) : 0;
}

double share_recorded(const csv *shares, int which, const ssgi_gl_desc *d, const tile *t)
{
    double least = (double)INFINITY, share = (double)NAN;
    for (int i = 0; i < shares->rows; ++i) {
        const double off = 100 * ((csv_number(shares, i, "half") > 0) != (d->half > 0)) +
                           fabs(csv_number(shares, i, "steps") - d->steps);
        if (strcmp(csv_text(shares, i, "body"), bodies[which].name) || strcmp(csv_text(shares, i, "tile"), t->name) ||
            !strcmp(csv_text(shares, i, "camera"), "stands") || off >= least) continue;
        least = off;
        share = csv_number(shares, i, "share");
    }
    return share;
}

int weigh(counts *c, const counted *of, const double *share, int count)
{
    const int apart = count && of->bodies == count, whole = count == 1 && !apart;
    *c = apart ? of->calm : of->busy;
    for (int i = 0; i < count && apart; ++i) counts_add(c, &of->body[i], share[i]);
    if (whole) {
        counts_add(c, &of->busy, share[0] - 1);
        counts_add(c, &of->calm, 1 - share[0]);
    }
    return count && !apart && !whole ? -1 : 0;
}
