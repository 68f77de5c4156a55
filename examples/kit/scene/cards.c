/* cards.c - cuts triangles along opaque texels, as in leaves and fences on cards. Declared in kit_models.h.

   A rectangle whose texels are all opaque is one piece, and one whose texels are all transparent none; others are
   halved, down to a texel or a square of several. Both halves of a polygon share the corners on the cut. */
#include "kit/kit_models.h"
#include <math.h>
#include <stdlib.h>

enum { MOST_CORNERS = 24, MOST_TILES = 4096 };

int kit_mask_make(kit_mask *m, const kit_picture *t, int bright, int least)
{
    const size_t w = (size_t)t->width, h = (size_t)t->height, row = w + 1;
    *m = (kit_mask){ .width = t->width, .height = t->height, .sum = calloc(row * (h + 1), sizeof *m->sum) };
    if (!m->sum) return -1;
    for (size_t y = 0; y < h; ++y) {
        uint32_t along = 0;
        for (size_t x = 0; x < w; ++x) {
            const unsigned char *p = t->texel + 4 * (y * w + x);
            along += (bright ? (p[0] + p[1] + p[2]) / 3 : p[3]) >= least;
            m->sum[(y + 1) * row + x + 1] = m->sum[y * row + x + 1] + along;
        }
    }
    return 0;
}

void kit_mask_free(kit_mask *m)
{
    free(m->sum);
    m->sum = NULL;
}

static uint32_t count_of(const kit_mask *m, const int low[2], const int high[2])
{
    const size_t row = (size_t)m->width + 1;
    const uint32_t *top = m->sum + (size_t)low[1] * row, *below = m->sum + (size_t)high[1] * row;
    return below[high[0]] - below[low[0]] - top[high[0]] + top[low[0]];
}

/* A corner of a polygon; at: in texels, x to the right, y down. */
typedef struct corner {
    double at[2], weight[2];
} corner;

typedef struct polygon {
    int count;
    corner c[MOST_CORNERS];
} polygon;

static void add(polygon *p, const corner *c)
{
    if (p->count < MOST_CORNERS) p->c[p->count++] = *c;
}

/* Splits a polygon in two at a line: axis 0: at x = line, 1: at y = line. */
static void halve(const polygon *p, int axis, double line, polygon half[2])
{
    half[0].count = half[1].count = 0;
    for (int k = 0; k < p->count; ++k) {
        const corner *a = &p->c[k], *b = &p->c[(k + 1) % p->count];
        const double from = a->at[axis] - line, to = b->at[axis] - line;
        if (from <= 0) add(&half[0], a);
        if (from >= 0) add(&half[1], a);
        if (from * to >= 0) continue;
        corner on;
        const double t = from / (from - to);
        for (int i = 0; i < 2; ++i) {
            on.at[i] = a->at[i] + t * (b->at[i] - a->at[i]);
            on.weight[i] = a->weight[i] + t * (b->weight[i] - a->weight[i]);
        }
        on.at[axis] = line;
        add(&half[0], &on);
        add(&half[1], &on);
    }
}

typedef struct cutting {
    kit_mask *mask;
    int side; /* width of the smallest squares, in texels */
    kit_piece *piece;
    void *context;
} cutting;

static int give(const cutting *c, const polygon *p)
{
    for (int k = 2; k < p->count; ++k) {
        const corner *const at[3] = { &p->c[0], &p->c[k - 1], &p->c[k] };
        double weight[3][2];
        for (int i = 0; i < 6; ++i) weight[i / 2][i % 2] = at[i / 2]->weight[i % 2];
        if (c->piece(c->context, (const double(*)[2])weight)) return -1;
    }
    return 0;
}

/* Keeps or drops a partly opaque square so that the total area is right: thin leaves stay, wide ones do not grow. */
static int share(const cutting *c, const polygon *p, double there)
{
    double area = 0;
    for (int k = 0; k < p->count; ++k) {
        const double *a = p->c[k].at, *b = p->c[(k + 1) % p->count].at, *o = p->c[0].at;
        area += 0.5 * ((a[0] - o[0]) * (b[1] - o[1]) - (a[1] - o[1]) * (b[0] - o[0]));
    }
    area = fabs(area);
    c->mask->owed += there * area;
    if (c->mask->owed < 0.5 * area) return 0;
    c->mask->owed -= area;
    return give(c, p);
}

/* Cuts a polygon, which is inside the rectangle of texels from low to high, to its opaque texels. */
static int cut(const cutting *c, const polygon *p, const int low[2], const int high[2])
{
    const int wide = high[0] - low[0], tall = high[1] - low[1], axis = tall > wide;
    const uint32_t there = p->count < 3 ? 0 : count_of(c->mask, low, high), all = (uint32_t)wide * (uint32_t)tall;
    if (!there) return 0;
    if (there == all) return give(c, p);
    if ((axis ? tall : wide) <= c->side) return share(c, p, (double)there / all);
    const int middle = low[axis] + (high[axis] - low[axis]) / 2;
    int lower[2] = { high[0], high[1] }, upper[2] = { low[0], low[1] };
    polygon half[2];
    lower[axis] = upper[axis] = middle;
    halve(p, axis, middle, half);
    return cut(c, &half[0], low, lower) || cut(c, &half[1], upper, high) ? -1 : 0;
}

/* Returns the width of the squares in texels, such that at most `most` of them meet the triangle. */
static int side_of(const double at[3][2], double most)
{
    double area = 0, edges = 0;
    int side = 1;
    for (int k = 0; k < 3; ++k) {
        const double *a = at[k], *b = at[(k + 1) % 3];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
        edges += fabs(b[0] - a[0]) + fabs(b[1] - a[1]);
    }
    while (side < 1 << 26 && fabs(area) / side / side + edges / side > most) side *= 2;
    return side;
}

/* Cuts the part of a triangle, in texels, that is in one tile of a repeated texture; if the texture is clamped, all
   that is beyond an edge belongs to the tile there. */
static int cut_tile(const cutting *c, const int wrap[2], const double at[3][2], const int tile[2])
{
    const int size[2] = { c->mask->width, c->mask->height }, low[2] = { 0, 0 };
    polygon p = { .count = 3 }, half[2];
    for (int k = 0; k < 3; ++k) {
        p.c[k].weight[0] = k == 1;
        p.c[k].weight[1] = k == 2;
        for (int i = 0; i < 2; ++i) {
            const double x = at[k][i] - (double)tile[i] * size[i];
            p.c[k].at[i] = wrap[i] == KIT_MIRROR && tile[i] & 1 ? size[i] - x : x;
        }
    }
    for (int i = 0; i < 2; ++i) {
        if (wrap[i] == KIT_CLAMP) continue;
        halve(&p, i, 0, half);
        p = half[1];
        halve(&p, i, size[i], half);
        p = half[0];
    }
    return cut(c, &p, low, size);
}

int kit_card_cut(kit_mask *m, const int wrap[2], const double uv[3][2], double most, kit_piece *piece, void *context)
{
    static const double whole[3][2] = { { 0, 0 }, { 1, 0 }, { 0, 1 } };
    const int size[2] = { m->width, m->height };
    double at[3][2], tiles = 1;
    int first[2] = { 0, 0 }, last[2] = { 0, 0 }, tile[2];
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 2; ++i) {
            if (!(fabs(uv[k][i]) < 1e6)) return piece(context, whole);
            at[k][i] = (i ? 1 - uv[k][i] : uv[k][i]) * size[i];
        }
    for (int i = 0; i < 2; ++i) {
        if (wrap[i] == KIT_CLAMP) continue;
        first[i] = (int)floor(fmin(at[0][i], fmin(at[1][i], at[2][i])) / size[i]);
        last[i] = (int)ceil(fmax(at[0][i], fmax(at[1][i], at[2][i])) / size[i]) - 1;
        if (last[i] < first[i]) last[i] = first[i];
        tiles *= 1.0 + last[i] - first[i];
    }
    if (tiles > MOST_TILES) return piece(context, whole);
    const cutting c = { .mask = m, .side = side_of((const double(*)[2])at, most), .piece = piece, .context = context };
    for (tile[1] = first[1]; tile[1] <= last[1]; ++tile[1])
        for (tile[0] = first[0]; tile[0] <= last[0]; ++tile[0])
            if (cut_tile(&c, wrap, (const double(*)[2])at, tile)) return -1;
    return 0;
}
