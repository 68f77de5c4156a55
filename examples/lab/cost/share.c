/* share.c - which bodies a shader has, and which of them a wave's lanes enter together. Declared in share.h. */
#include "lab/cost/share.h"
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* GLSL for the gather, where a pixel comes alternately to the two sides of a slice: records a condition as a bit. */
#define GATHERED(condition) "told[times & 1] |= uint(" condition ") << uint(times >> 1); ++times; shown = true;"

const body bodies[BODIES] = {
    { "cover", "if (tap.up || (walked.rose && tap.seen)) {", GATHERED("tap.up || (walked.rose && tap.seen)"), 0 },
    { "cover of solids", "if (tap.up) {", GATHERED("tap.up"), 0 },
    { "second", "if (tap.inside && front_squared < 1.0 && front.y * front_inverse > SSGI_LEVEL) {",
      GATHERED("tap.inside && front_squared < 1.0 && front.y * front_inverse > SSGI_LEVEL"), 0 },
    { "sent", "if (first + second > 0.0) {", GATHERED("first + second > 0.0"), 0 },
    { "unsettled", "int more = centre.frames < SSGI_SETTLED ? side * side : 0;",
      "told.x = uint(centre.frames < SSGI_SETTLED); shown = centre.z < SSGI_FAR;", 1 },
    { "changed", "for (int nth = 0; differ >> uint(nth) != 0u; ++nth) {", "told.x = differ; shown = true;", 16 }
};

const tile tiles[TILES] = { { "8x8", 8, 8 }, { "16x4", 16, 4 } };

char *text_of(const ssgi_gl_desc *d, int stage)
{
    const size_t n = ssgi_gl_emit(NULL, 0, d, stage);
    char *text = n ? malloc(n + 1) : NULL;
    if (text) ssgi_gl_emit(text, n + 1, d, stage);
    return text;
}

int bodies_of(int of[BODIES], const char *text)
{
    int count = 0;
    for (int i = 0; i < BODIES; ++i) if (strstr(text, bodies[i].line)) of[count++] = i;
    return count;
}

double share_of(const told *texel, int width, int height, const tile *t, int times)
{
    double entered = 0, held = 0;
    for (int y = 0; y < height; y += t->height)
        for (int x = 0; x < width; x += t->width) {
            uint32_t bits[2] = { 0, 0 };
            int shown = 0;
            for (int k = 0; k < t->width * t->height; ++k) {
                const int across = x + k % t->width, up = y + k / t->width;
                if (across >= width || up >= height) continue;
                const told *of = &texel[up * width + across];
                const int hidden = of->entered[1] < 0;
                bits[0] |= (uint32_t)of->entered[0];
                bits[1] |= (uint32_t)(hidden ? -1 - of->entered[1] : of->entered[1]);
                shown |= !hidden;
            }
            held += shown;
            if (shown) entered += __builtin_popcount(bits[0]) + __builtin_popcount(bits[1]);
        }
    return held > 0 ? entered / (held * times) : 0;
}

double share_recorded(const csv *shares, int which, const ssgi_gl_desc *d, const tile *t)
{
    double least = (double)INFINITY, share = (double)NAN;
    for (int i = 0; i < shares->rows; ++i) {
        const double off = 100 * ((csv_number(shares, i, "half") > 0) != (d->gather.resolution > 0)) +
                           fabs(csv_number(shares, i, "steps") - d->gather.samples);
        if (strcmp(csv_text(shares, i, "body"), bodies[which].name) || strcmp(csv_text(shares, i, "tile"), t->name) ||
            !strcmp(csv_text(shares, i, "camera"), "stands") || off >= least) continue;
        least = off;
        share = csv_number(shares, i, "share");
    }
    return share;
}

int weigh(counts *c, const counted *of, const double *share, int count)
{
    const int apart = count && (of->bodies == count || of->bodies == 2 * count), whole = count == 1 && !apart;
    *c = apart ? of->calm : of->busy;
    for (int i = 0; i < of->bodies && apart; ++i) counts_add(c, &of->body[i], share[i % count]);
    if (whole) {
        counts_add(c, &of->busy, share[0] - 1);
        counts_add(c, &of->calm, 1 - share[0]);
    }
    return count && !apart && !whole ? -1 : 0;
}
