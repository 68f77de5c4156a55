/* placing.c - models of scans by seed, of some matter, placed. Declared in scans.h. */
#include "kit/scene/scans/scans.h"
#include <math.h>
#include <string.h>

/* ---- >>models -------------------------------------------------------------------------------------------------- */

/* detail: cells along the longest side, of those that the scene allows; least: that what is thin in it needs; slim: so
   much of its height is its width */
static const struct model {
    const char *name;
    scan_model_make *make;
    double detail;
    int least;
    double slim;
} models[] = { { "statue", kit_statue, 1.2, 40, 0.35 },  { "seated", kit_seated, 1, 30, 0.4 },
               { "torso", kit_torso, 1, 14, 0.4 },       { "bust", kit_bust, 1, 14, 0.6 },
               { "skull", kit_skull, 0.8, 26, 0.9 },     { "mask", kit_mask, 0.8, 14, 0.8 },
               { "beast", kit_beast, 0.9, 14, 1 },       { "dragon", kit_dragon, 1.2, 56, 1.3 },
               { "hand", kit_hand, 0.9, 26, 0.5 },       { "snail", kit_snail, 0.7, 14, 1 },
               { "ammonite", kit_ammonite, 0.8, 14, 1 }, { "coral", kit_coral, 1, 46, 1 },
               { "root", kit_root, 1, 14, 1.2 },         { "vase", kit_vase, 0.9, 46, 0.7 },
               { "bowl", kit_bowl, 0.6, 14, 1 },         { "knot", kit_knot, 0.9, 32, 0.8 },
               { "rock", kit_rock, 0.5, 8, 0.9 },        { "drum", kit_drum, 0.7, 14, 0.6 },
               { "bird", kit_bird, 0.9, 36, 0.6 },       { "sponge", kit_gyroid, 0.7, 42, 0.9 },
               { "column", kit_column, 1.1, 14, 0.35 },  { "bunny", NULL, 1, 14, 0.8 } };

_Static_assert(sizeof models / sizeof *models == KIT_SCANS, "a row for each");

static const float
    stones[][3] = { { 0.8f, 0.78f, 0.74f }, { 0.72f, 0.68f, 0.6f }, { 0.55f, 0.5f, 0.44f }, { 0.6f, 0.6f, 0.6f } },
    bronzes[][3] = { { 0.3f, 0.22f, 0.12f }, { 0.2f, 0.3f, 0.24f }, { 0.16f, 0.13f, 0.1f } },
    clays[][3] = { { 0.6f, 0.32f, 0.2f }, { 0.7f, 0.5f, 0.36f }, { 0.45f, 0.25f, 0.18f }, { 0.75f, 0.7f, 0.62f } },
    plastics[][3] = { { 0.7f, 0.15f, 0.1f }, { 0.15f, 0.35f, 0.65f }, { 0.8f, 0.6f, 0.1f },
                      { 0.2f, 0.55f, 0.3f }, { 0.8f, 0.8f, 0.8f },    { 0.25f, 0.25f, 0.27f } },
    woods[][3] = { { 0.5f, 0.33f, 0.18f }, { 0.62f, 0.45f, 0.27f }, { 0.3f, 0.19f, 0.11f } };

double scan_slim(int which) { return models[which].slim; }

void scan_tint(kit_build *b, int matter, double vary)
{
    if (matter == KIT_OF_STONE) KIT_TINT(b, stones, vary);
    else if (matter == KIT_OF_BRONZE) KIT_TINT(b, bronzes, vary);
    else if (matter == KIT_OF_CLAY) KIT_TINT(b, clays, vary);
    else if (matter == KIT_OF_PLASTIC) KIT_TINT(b, plastics, vary);
    else KIT_TINT(b, woods, vary);
}

/* a sight in the frame's coordinates */
void scan_sight(kit_plot *p, double x, double y, double z, double reach)
{
    const kit_frame *f = &p->b.frame;
    const double c = f->scale > 0 ? f->turn[0][0] : 1, s = f->turn[0][2], by = f->scale > 0 ? f->scale : 1;
    if (!(f->scale > 0)) kit_add_sight(p, x, y, z, reach);
    else
        kit_add_sight(p, f->at[0] + by * (c * x + s * z), f->at[1] + by * y, f->at[2] + by * (c * z - s * x),
                      by * reach);
}

/* An incomplete scan: what was out of sight is missing. */
static void cut_off(kit_build *b, kit_clay *c)
{
    const double a = kit_between(b, 0, 2 * KIT_PI);
    if (kit_odds(b, 0.5)) scan_cut_plane(c, cos(a), kit_between(b, 0.5, 1.5), sin(a), kit_between(b, 0.6, 0.9), 0.06);
    else
        for (int k = 0; k < 3; k++)
            scan_cut_ball(c, 0.2 * cos(a + 2.1 * k), kit_between(b, 0.2, 0.8), 0.2 * sin(a + 2.1 * k),
                          kit_between(b, 0.06, 0.2), 0.05);
}

/* A model so high, tilted, in the frame; part of an object that has begun when object is 0. */
void scan_place_scan(kit_plot *p, const kit_style *s, int which, const double at[3], double turn, double tilt,
                     double high, int object)
{
    kit_build *b = &p->b;
    kit_clay clay;
    const kit_frame before = kit_enter(b, at[0], at[1], at[2], turn, high);
    memset(&clay, 0, sizeof clay);
    clay.seed = kit_choose(b, 100000);
    clay.facets = s->facets || kit_odds(b, 0.08);
    clay.stain = kit_odds(b, 0.6) ? 0.2 : 0;
    if (which == BUNNY && b->scene.mesh.triangles > 120000) which = KNOT;
    if (object) kit_begin_object(b, models[which].name, -1);
    /* coarser where there are many triangles already */
    const double share = fmax(0.25, fmin(1, 1.5 - (double)b->scene.mesh.triangles / 1.1e5));
    scan_tint(b, kit_odds(b, 0.2) ? kit_choose(b, 5) : s->matter, 0.2);
    kit_place_tilted(b, 0, 0, 0, 0, tilt);
    if (which == BUNNY) kit_model(p, "/usr/share/glmark2/models/bunny.obj", "glmark2-data", 1);
    else {
        models[which].make(b, &clay);
        if (!clay.cuts && kit_odds(b, which == ROCK || which == COLUMN ? 0 : 0.14)) cut_off(b, &clay);
        const double cells = share * models[which].detail * s->cells,
                     least = sqrt(share) * models[which].least * (s->facets ? 0.7 : 1);
        scan_sculpt(b, &clay, (int)fmax(least, fmin(120, cells)));
    }
    kit_place_at(b, 0, 0, 0, 0);
    if (high > 0.1) scan_sight(p, 0, 0.45, 0, 0.55);
    if (high > 0.4 && which != ROCK && kit_odds(b, 0.5)) scan_sight(p, 0, 0.85, 0, 0.22);
    kit_leave(b, before);
}

void scan_place_upright(kit_plot *p, const kit_style *s, int which, double x, double y, double z, double turn,
                        double high)
{
    const double at[3] = { x, y, z };
    scan_place_scan(p, s, which, at, turn, 0, high, 1);
}

/* a model of those, the bunny when one is left */
int scan_next_scan(kit_build *b, kit_style *s, const int *of, int count)
{
    return s->bunnies > 0 && kit_odds(b, 0.5) && s->bunnies-- ? BUNNY : of[kit_choose(b, count)];
}
