/* parts.c - cloths, chains, lamps, vases, figures, reliefs of halls by seed. Declared in halls.h. */
#include "kit/scene/halls/halls.h"
#include <math.h>
#include <string.h>

/* ---- >>cloth ----------------------------------------------------------------------------------------------------- */

/* half the width, length, folds, phase, depth of the folds */
static void banner_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, folds = 2 * KIT_PI * s[2], a = folds * u + 0.8 * sin(2 * KIT_PI * u + s[3]);
    const double slope = folds + 1.6 * KIT_PI * cos(2 * KIT_PI * u + s[3]), deep = s[4] * (0.35 + 0.65 * v);
    out->p[0] = 2 * s[0] * (u - 0.5);
    out->p[1] = -s[1] * v + 0.02 * s[1] * v * sin(7 * u + s[3]);
    out->p[2] = deep * sin(a) + 0.03 * s[1] * v * v * sin(s[3]);
    out->n[0] = -deep * slope * cos(a);
    out->n[1] = 0;
    out->n[2] = 2 * s[0];
    kit_unit(out->n);
}

void hall_banner(hall *h, double width, double length)
{
    kit_build *b = h->b;
    const double s[] = { 0.5 * width, length, 1.5 + floor(width * kit_between(b, 1, 3)), kit_between(b, 0, 6),
                         kit_between(b, 0.03, 0.09) };
    const double from[3] = { -0.56 * width, 0.02, 0 }, to[3] = { 0.56 * width, 0.02, 0 };
    const double rod[2][3] = { { from[0], from[1], 0 }, { to[0], to[1], 0 } };
    hall_paint(h, kit_odds(b, 0.6) ? HALL_CLOTH : HALL_SECOND);
    kit_patch(b, 28 + (int)(6 * width), 6 + (int)length, banner_surface, s);
    hall_paint(h, HALL_METAL);
    kit_tube(b, rod, 2, 0.025, 8);
}

/* span, width, sag, phase */
static void drape_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, across = v - 0.5, ends = fabs(2 * u - 1), hang = 4 * u * (1 - u);
    const double a = 4 * KIT_PI * v + s[3], fold = 0.05 + 0.1 * ends;
    out->p[0] = s[0] * u;
    out->p[1] = -s[2] * hang * (1 - 0.5 * across * across) + fold * s[1] * 0.4 * sin(a);
    out->p[2] = s[1] * across * (1 - 0.3 * ends * ends);
    const double dx = -4 * s[2] * (1 - 2 * u) / s[0], dz = fold * 0.4 * 4 * KIT_PI * cos(a);
    out->n[0] = -dx;
    out->n[1] = 1;
    out->n[2] = -dz;
    kit_unit(out->n);
}

void hall_drape(hall *h, double span, double width, double sag)
{
    const double s[] = { span, width, sag, kit_between(h->b, 0, 6) };
    hall_paint(h, kit_odds(h->b, 0.5) ? HALL_CLOTH : HALL_SECOND);
    kit_patch(h->b, 30, 20, drape_surface, s);
}

/* ---- >>what hangs ------------------------------------------------------------------------------------------------ */

void hall_chain(hall *h, double length, double size)
{
    kit_build *b = h->b;
    const double link[2] = { 0.5 * size, 0.13 * size };
    const double pitch = 0.72 * size;
    const int n = (int)(length / pitch);
    hall_paint(h, HALL_METAL);
    if (n > 60) { /* a rod where links were too many */
        const double rod[2][3] = { { 0, 0, 0 }, { 0, length, 0 } };
        kit_tube(b, rod, 2, 0.12 * size, 6);
        return;
    }
    for (int k = 0; k <= n; k++) {
        kit_place_tilted(b, 0, pitch * k, 0, 90 * (k & 1), 90);
        kit_patch(b, 8, 5, kit_torus_surface, link);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

void hall_chandelier(hall *h, double r, double chain)
{
    kit_build *b = h->b;
    const int arms = 6 + 2 * kit_choose(b, 4), tiers = 1 + kit_odds(b, 0.4);
    const kit_moulding stem[] = { { 0, -0.1 * r, 0.09 * r, 0.05 * r, 0.03 * r },
                                  { 0.09 * r, 0.05 * r, 0.04 * r, 0.4 * r, -0.03 * r },
                                  { 0.04 * r, 0.4 * r, 0.07 * r, 0.9 * r, 0.03 * r },
                                  { 0.07 * r, 0.9 * r, 0, r, 0 } };
    hall_paint(h, HALL_METAL);
    kit_turned(b, stem, 4, 12);
    for (int tier = 0; tier < tiers; tier++)
        for (int k = 0; k < arms; k++) {
            double at[9][3];
            const double reach = r * (1 - 0.4 * tier), up = 0.5 * r * tier;
            for (int i = 0; i < 9; i++) {
                const double t = i / 8.0;
                at[i][0] = reach * t;
                at[i][1] = up + 0.3 * r * (1.6 * t * t - t + 0.3);
                at[i][2] = 0;
            }
            kit_place_at(b, 0, 0, 0, 360.0 * (k + 0.5 * tier) / arms);
            hall_paint(h, HALL_METAL);
            kit_tube(b, (const double(*)[3])at, 9, 0.02 * r, 6);
            const double a = b->turn * KIT_PI / 180, x = reach * cos(a), z = -reach * sin(a), y = at[8][1];
            const kit_moulding cup[] = { { 0.02 * r, y, 0.1 * r, y + 0.06 * r, 0.01 * r },
                                         { 0.1 * r, y + 0.06 * r, 0, y + 0.06 * r, 0 } };
            kit_place_at(b, x, 0, z, 0);
            kit_turned(b, cup, 2, 8);
            kit_colour(b, 0.85, 0.82, 0.72);
            kit_place_at(b, x, y + 0.05 * r, z, 0);
            kit_cylinder(b, 0.035 * r, 0.25 * r, 8);
        }
    const double hoop[2] = { 0.98 * r, 0.025 * r };
    hall_paint(h, HALL_METAL);
    kit_place_at(b, 0, 0.27 * r, 0, 0);
    kit_patch(b, 40, 6, kit_torus_surface, hoop);
    kit_place_at(b, 0, 0, 0, 0);
    hall_lamp(h, 0, -0.3 * r, 0);
    const kit_frame f = kit_enter(b, 0, r, 0, 0, 1);
    if (chain > 0.2) hall_chain(h, chain, 0.14);
    kit_leave(b, f);
}

void hall_pendant(hall *h, double r, double chain)
{
    kit_build *b = h->b;
    const int kind = kit_choose(b, 3);
    const kit_moulding shade[] = { { r, 0, 0.25 * r, 0.7 * r, 0.12 * r }, { 0.25 * r, 0.7 * r, 0.1 * r, 0.9 * r, 0 } };
    const kit_moulding lantern[] = { { 0, 0, 0.5 * r, 0.2 * r, 0 },
                                     { 0.5 * r, 0.2 * r, 0.6 * r, 1.4 * r, 0 },
                                     { 0.75 * r, 1.4 * r, 0, 2 * r, -0.1 * r } };
    const double globe = 0.6 * r, rod[2][3] = { { 0, (kind ? 1.2 : 0.85) * r, 0 }, { 0, chain + r, 0 } };
    hall_paint(h, kind == 2 ? HALL_GLASS : HALL_METAL);
    if (kind == 0) kit_turned(b, shade, 2, 20); /* open below */
    if (kind == 1) kit_turned(b, lantern, 3, 6);
    kit_place_at(b, 0, kind == 2 ? 0.7 * r : 0.35 * r, 0, 0);
    if (kind == 2) kit_patch(b, 18, 10, kit_sphere_surface, &globe);
    kit_place_at(b, 0, 0, 0, 0);
    hall_paint(h, HALL_METAL);
    kit_tube(b, rod, 2, 0.012, 6);
    hall_lamp(h, 0, -0.2, 0);
}

void hall_candles(hall *h, double height)
{
    kit_build *b = h->b;
    const double s = height;
    const kit_moulding stem[] = { { 0, 0, 0.16 * s, 0, 0 },
                                  { 0.16 * s, 0, 0.03 * s, 0.12 * s, -0.02 * s },
                                  { 0.03 * s, 0.12 * s, 0.02 * s, 0.45 * s, 0.008 * s },
                                  { 0.02 * s, 0.45 * s, 0.03 * s, 0.5 * s, 0.02 * s },
                                  { 0.03 * s, 0.5 * s, 0.015 * s, 0.82 * s, 0 },
                                  { 0.015 * s, 0.82 * s, 0.07 * s, 0.86 * s, 0 },
                                  { 0.07 * s, 0.86 * s, 0, 0.85 * s, 0 } };
    hall_paint(h, HALL_METAL);
    kit_turned(b, stem, 7, 12);
    kit_colour(b, 0.86, 0.83, 0.74);
    kit_place_at(b, 0, 0.85 * s, 0, 0);
    kit_cylinder(b, 0.025 * s, 0.15 * s, 8);
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>what stands ----------------------------------------------------------------------------------------------- */

/* of a profile by chance, hollow at its mouth */
void hall_vase(hall *h, double s)
{
    kit_build *b = h->b;
    const double foot = s * kit_between(b, 0.1, 0.2), belly = s * kit_between(b, 0.18, 0.4),
                 neck = s * kit_between(b, 0.05, 0.16), mouth = neck * kit_between(b, 1.05, 2),
                 waist = s * kit_between(b, 0.04, 0.15), mid = s * kit_between(b, 0.3, 0.65);
    const kit_moulding profile[] = { { 0, 0, foot, 0, 0 },
                                     { foot, 0, 0.7 * foot, waist, -0.02 * s },
                                     { 0.7 * foot, waist, belly, mid, 0.06 * s },
                                     { belly, mid, neck, 0.86 * s, 0.05 * s },
                                     { neck, 0.86 * s, mouth, s, -0.02 * s },
                                     { mouth, s, 0.85 * mouth, 0.99 * s, 0 },
                                     { 0.85 * mouth, 0.99 * s, 0.8 * neck, 0.85 * s, 0 },
                                     { 0.8 * neck, 0.85 * s, 0, 0.8 * s, 0 } };
    kit_colour(b, kit_between(b, 0.15, 0.75), kit_between(b, 0.15, 0.6), kit_between(b, 0.1, 0.6));
    kit_turned(b, profile, 8, 24);
    for (int side = 0; side < 2 && s > 0.4 && belly > 0.25 * s; side++) {
        double at[9][3];
        for (int i = 0; i < 9; i++) {
            const double a = KIT_PI * i / 8;
            at[i][0] = 0.9 * neck + 0.15 * s * sin(a);
            at[i][1] = 0.79 * s - 0.12 * s * cos(a);
            at[i][2] = 0;
        }
        kit_place_at(b, 0, 0, 0, 180 * side);
        kit_tube(b, (const double(*)[3])at, 9, 0.02 * s, 7);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* radius at the hem and at the waist, height, folds, phase, sway */
static void robe_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const double *s = shape, a = 2 * KIT_PI * fmod(u, 1), fade = 1 - 0.75 * v, deep = 0.13 * fade;
    const double w = s[3] * a + s[4] + 1.5 * v, r = (s[0] + (s[1] - s[0]) * v * (1.3 - 0.3 * v)) * (1 + deep * sin(w));
    const double dr = (s[0] + (s[1] - s[0]) * v) * deep * s[3] * cos(w);
    out->p[0] = r * cos(a) + s[5] * v * v;
    out->p[1] = s[2] * v;
    out->p[2] = 0.8 * r * sin(a);
    out->n[0] = 0.8 * (r * cos(a) + dr * sin(a));
    out->n[1] = 0.2 * (s[0] - s[1]);
    out->n[2] = r * sin(a) - dr * cos(a);
    kit_unit(out->n);
}

static void head(hall *h, double s)
{
    kit_build *b = h->b;
    const double skull[3] = { 0.042 * s, 0.058 * s, 0.052 * s }, hair[3] = { 0.05 * s, 0.04 * s, 0.055 * s },
                 nose[3] = { 0.008 * s, 0.018 * s, 0.014 * s }, at[3] = { b->at[0], b->at[1], b->at[2] },
                 turn = b->turn;
    const double neck[2][3] = { { 0, -0.09 * s, -0.01 * s }, { 0, -0.02 * s, 0 } };
    kit_tube(b, neck, 2, 0.027 * s, 10);
    kit_cushion(b, skull, 0.9, 14);
    kit_place_at(b, at[0] + 0.05 * s * sin(turn * KIT_PI / 180), at[1] - 0.005 * s,
                 at[2] + 0.05 * s * cos(turn * KIT_PI / 180), turn);
    kit_cushion(b, nose, 0.8, 6);
    kit_place_at(b, at[0], at[1] + 0.03 * s, at[2] - 0.01 * s, turn);
    kit_cushion(b, hair, 0.8, 10);
}

static void arm(hall *h, double s, int side)
{
    kit_build *b = h->b;
    const double x = side * 0.115 * s, reach = kit_between(b, -0.03, 0.16) * s, lift = kit_between(b, -0.2, 0.28) * s;
    const double elbow[3] = { x + side * 0.05 * s, 0.6 * s, 0.03 * s },
                 shoulder[3] = { x - side * 0.01 * s, 0.79 * s, 0 },
                 wrist[3] = { x * kit_between(b, 0.3, 1.4), 0.6 * s + 0.5 * lift, 0.07 * s + reach };
    double at[2][3];
    static const double ball = 1;
    memcpy(at[0], shoulder, sizeof shoulder);
    memcpy(at[1], elbow, sizeof elbow);
    kit_tube(b, (const double(*)[3])at, 2, 0.033 * s, 10);
    memcpy(at[0], wrist, sizeof wrist);
    kit_tube(b, (const double(*)[3])at, 2, 0.026 * s, 10);
    const double joint[3][4] = { { shoulder[0], shoulder[1], shoulder[2], 0.042 * s },
                                 { elbow[0], elbow[1], elbow[2], 0.033 * s },
                                 { wrist[0], wrist[1], wrist[2], 0.036 * s } };
    for (int k = 0; k < 3; k++) {
        const double r = joint[k][3] * ball;
        kit_place_at(b, joint[k][0], joint[k][1], joint[k][2], 0);
        kit_patch(b, 10, 6, kit_sphere_surface, &r);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* a figure in a robe, on a base of its own */
void hall_statue(hall *h, double s)
{
    kit_build *b = h->b;
    const double robe[] = {
        0.17 * s, 0.085 * s, 0.58 * s, 7 + kit_choose(b, 5), kit_between(b, 0, 6), kit_between(b, -0.02, 0.02) * s
    };
    const double chest[3] = { 0.115 * s, 0.155 * s, 0.075 * s },
                 shawl[] = { 0.2 * s, 0.5 * s, 3.5, kit_between(b, 0, 6), 0.02 * s };
    hall_paint(h, kit_odds(b, 0.7) ? HALL_STONE : HALL_METAL);
    kit_cylinder(b, 0.22 * s, 0.05 * s, 20);
    kit_place_at(b, 0, 0.05 * s, 0, 0);
    kit_patch(b, 44, 8, robe_surface, robe);
    kit_place_at(b, robe[5], 0.7 * s, 0, 0);
    kit_cushion(b, chest, 0.8, 14);
    kit_place_at(b, 0, 0, 0, 0);
    for (int side = -1; side < 2; side += 2) arm(h, s, side);
    kit_place_at(b, robe[5], 0.93 * s, 0.01 * s, kit_between(b, -30, 30));
    head(h, s);
    kit_place_tilted(b, 0, 0.8 * s, -0.085 * s, 180, -4);
    if (kit_odds(b, 0.5)) kit_patch(b, 24, 8, banner_surface, shawl);
    kit_place_at(b, 0, 0, 0, 0);
}

void hall_bust(hall *h, double s)
{
    kit_build *b = h->b;
    const double shoulders[3] = { 0.32 * s, 0.2 * s, 0.18 * s };
    const kit_moulding foot[] = { { 0, 0, 0.16 * s, 0, 0 },
                                  { 0.16 * s, 0, 0.09 * s, 0.2 * s, -0.02 * s },
                                  { 0.09 * s, 0.2 * s, 0.2 * s, 0.3 * s, 0 } };
    hall_paint(h, kit_odds(b, 0.7) ? HALL_STONE : HALL_METAL);
    kit_turned(b, foot, 3, 16);
    kit_place_at(b, 0, 0.42 * s, 0, 0);
    kit_cushion(b, shoulders, 0.75, 14);
    kit_place_at(b, 0, 0.8 * s, 0.01 * s, kit_between(b, -25, 25));
    head(h, 3.2 * s);
    kit_place_at(b, 0, 0, 0, 0);
}

void hall_plant(hall *h, double s)
{
    kit_build *b = h->b;
    const double pot = s * kit_between(b, 0.14, 0.24), deep = s * kit_between(b, 0.2, 0.36);
    const kit_moulding profile[] = { { 0, 0, 0.7 * pot, 0, 0 },
                                     { 0.7 * pot, 0, pot, 0.85 * deep, 0.02 * s },
                                     { 1.1 * pot, 0.85 * deep, 1.1 * pot, deep, 0 },
                                     { 1.1 * pot, deep, 0.9 * pot, deep, 0 },
                                     { 0.9 * pot, deep, 0.9 * pot, 0.85 * deep, 0 },
                                     { 0.9 * pot, 0.85 * deep, 0, 0.87 * deep, 0 } };
    static const float pots[][3] = { { 0.55f, 0.27f, 0.16f }, { 0.6f, 0.58f, 0.54f }, { 0.18f, 0.2f, 0.22f } };
    const int leaves = 24 + kit_choose(b, 40), pointed = kit_odds(b, 0.7);
    const double width = s * kit_between(b, 0.05, 0.14), steep = kit_between(b, 20, 60);
    KIT_TINT(b, pots, 0.1);
    kit_turned(b, profile, 6, 20);
    for (int k = 0; k < leaves; k++) {
        const double length = (s - deep) * kit_between(b, 0.6, 1.15), up = kit_between(b, 0.86, 1 + 0.3 * (k & 1));
        kit_colour(b, kit_between(b, 0.07, 0.2), kit_between(b, 0.22, 0.42), kit_between(b, 0.05, 0.12));
        kit_place_tilted(b, 0, deep * up, 0, kit_between(b, 0, 360), -steep - kit_between(b, 0, 85 - steep));
        kit_leaf(b, width, length, kit_between(b, 0.4, 1.6), 5, pointed);
    }
    kit_place_at(b, 0, 0, 0, 0);
}

/* ---- >>on walls -------------------------------------------------------------------------------------------------- */

typedef struct relief {
    double width, height, deep;
    unsigned seed;
    int kind;
} relief;

/* how far a relief stands out: figures as soft blobs, ornament as waves, a rosette */
static double carved(const relief *r, double u, double v)
{
    const double x = (u - 0.5) * r->width, y = (v - 0.5) * r->height;
    const double edge = fmin(fmin(u, 1 - u) * r->width, fmin(v, 1 - v) * r->height), fade = fmin(1, edge / 0.12);
    double up;
    if (r->kind == 0) up = fmax(0, kit_fractal(r->seed, 2.2 * x, 2.2 * y, 0.5, 3) + 0.25);
    else if (r->kind == 1) {
        const double d = sqrt(x * x + y * y) / (0.45 * fmin(r->width, r->height)), a = atan2(y, x);
        up = d > 1 ? 0.05 : (0.55 + 0.45 * cos(8 * a + 2 * sin(6 * d))) * (1 - d * d) + 0.2 * cos(12 * d) * d;
    } else up = 0.5 + 0.5 * sin(9 * x + 1.5 * sin(5 * y)) * cos(7 * y);
    return r->deep * fade * up;
}

static void relief_surface(const void *shape, double u, double v, kit_vertex *out)
{
    const relief *r = shape;
    const double e = 4e-3;
    out->p[0] = (u - 0.5) * r->width;
    out->p[1] = v * r->height;
    out->p[2] = carved(r, u, v) + 0.02;
    out->n[0] = -(carved(r, u + e, v) - carved(r, u - e, v)) / (2 * e * r->width);
    out->n[1] = -(carved(r, u, v + e) - carved(r, u, v - e)) / (2 * e * r->height);
    out->n[2] = 1;
    kit_unit(out->n);
}

/* four mouldings about a field, mitred by overlap of one pair */
static void surround(hall *h, double w, double height, double wide, double deep)
{
    kit_build *b = h->b;
    kit_bevelled(b, -0.5 * w - wide, -wide, 0, 0.5 * w + wide, 0, deep, 0.25 * wide);
    kit_bevelled(b, -0.5 * w - wide, height, 0, 0.5 * w + wide, height + wide, deep, 0.25 * wide);
    kit_bevelled(b, -0.5 * w - wide, 0, 0, -0.5 * w, height, deep, 0.25 * wide);
    kit_bevelled(b, 0.5 * w, 0, 0, 0.5 * w + wide, height, deep, 0.25 * wide);
}

void hall_relief(hall *h, double width, double height)
{
    const relief r = { width, height, kit_between(h->b, 0.06, 0.2), h->noise + (unsigned)kit_choose(h->b, 1000),
                       kit_choose(h->b, 3) };
    hall_paint(h, HALL_STONE);
    kit_patch(h->b, (int)fmin(30, 16 * width), (int)fmin(30, 16 * height), relief_surface, &r);
    surround(h, width, height, 0.1, 0.12);
}

void hall_picture(hall *h, double width, double height)
{
    kit_build *b = h->b;
    double low[3], high[3];
    for (int i = 0; i < 3; i++) {
        low[i] = kit_between(b, 0.05, 0.4);
        high[i] = kit_between(b, 0.2, 0.75);
    }
    for (int k = 0; k < 5; k++) { /* land, sky and what stands there */
        const double y0 = height * k / 5, y1 = height * (k + 1) / 5, t = k < 2 ? 0.3 * k : 0.5 + 0.12 * k;
        const double q[4][3] = {
            { -0.5 * width, y0, 0.03 }, { 0.5 * width, y0, 0.03 }, { 0.5 * width, y1, 0.03 }, { -0.5 * width, y1, 0.03 }
        };
        kit_colour(b, low[0] + t * (high[0] - low[0]), low[1] + t * (high[1] - low[1]),
                   low[2] + t * (high[2] - low[2]));
        kit_quad(b, q);
    }
    hall_paint(h, kit_odds(b, 0.5) ? HALL_WOOD : HALL_METAL);
    surround(h, width, height, kit_between(b, 0.05, 0.14), 0.07);
}

void hall_barrier(hall *h, double length)
{
    kit_build *b = h->b;
    const int n = (int)fmax(1, length / 1.6);
    for (int k = 0; k <= n; k++) {
        const double x = length * k / n, from[3] = { x, 0.88, 0 }, to[3] = { length * (k + 1) / n, 0.88, 0 };
        static const kit_moulding post[] = { { 0, 0, 0.16, 0, 0 },
                                             { 0.16, 0, 0.15, 0.02, 0 },
                                             { 0.15, 0.02, 0.025, 0.05, 0 },
                                             { 0.025, 0.05, 0.025, 0.9, 0 },
                                             { 0.04, 0.9, 0, 0.96, 0.02 } };
        hall_paint(h, HALL_METAL);
        kit_place_at(b, x, 0, 0, 0);
        kit_turned(b, post, 5, 10);
        kit_place_at(b, 0, 0, 0, 0);
        hall_paint(h, HALL_CLOTH);
        if (k < n) kit_cable(b, from, to, 0.25, 0.018, 6);
    }
}
