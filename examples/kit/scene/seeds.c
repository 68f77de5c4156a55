/* seeds.c - loads scenes drawn from a seed: names and kinds, and the variations that all of them have: units, wrong
   winding, light. Declared in kit_build.h. */
#include "kit/kit_seed.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { WORD = 96 };

/* kinds of names: a scene built from rows; a model of the catalogue on a floor */
enum { RANDOM, MODELS, PREFIXES };

static const char *const prefixes[PREFIXES] = { "random:", "model:" };

static const struct kind {
    const char *name, *about;
    int indoors;
} kinds[] = { { "rooms", "a furnished room: shelves, rails, blinds, cloth, cables, lamps", 1 },
              { "streets", "a street: facades, balconies, cars, poles, signs, wires", 0 },
              { "halls", "a hall: columns, arches, balconies, stairs, vaults", 1 },
              { "foliage", "trees, hedges, blades and cards of leaves among solids", 0 },
              { "machines", "machines, tanks, pipes, ducts, gratings, ladders", 1 },
              { "scans", "scanned and modelled figures on grounds and among clutter", 0 },
              { "terrain", "rocky ground, stones, cliffs, what stands on it", 0 } };

enum { KINDS = sizeof kinds / sizeof *kinds };

_Static_assert((int)KINDS == (int)KIT_KINDS, "kit.h says how many kinds there are");

/* ---- >>names --------------------------------------------------------------------------------------------------- */

const char *kit_scene_kind(int i, const char **about)
{
    if (i < 0 || i >= KINDS) return NULL;
    if (about) *about = kinds[i].about;
    return kinds[i].name;
}

/* Returns the index of a name's prefix; -1: none. */
static int prefix_of(const char *name)
{
    for (int k = 0; k < PREFIXES; k++)
        if (!strncmp(name, prefixes[k], strlen(prefixes[k]))) return k;
    return -1;
}

int kit_scene_seeded(const char *name) { return prefix_of(name) >= 0; }

/* Splits "random:7", "random:streets:7", "model:chair" or "model:scopia/chair:7": word gets the part before the seed,
   without the prefix; a missing seed is 0. */
static int parse(int64_t *seed, char word[WORD], const char *name, kit_error *err)
{
    const char *const rest = name + strlen(prefixes[prefix_of(name)]), *const colon = strrchr(rest, ':'),
               *const number = colon ? colon + 1 : prefix_of(name) == RANDOM ? rest : rest + strlen(rest);
    size_t used = 0;
    snprintf(word, WORD, "%.*s", (int)((colon ? colon : number) - rest), rest);
    for (*seed = 0; number[used] >= '0' && number[used] <= '9' && used < 10; used++)
        *seed = 10 * *seed + (number[used] - '0');
    if (used > 9 || number[used] || (!used && (colon || prefix_of(name) == RANDOM)))
        return kit_fail(err, "scene '%s': the seed must be a whole number 0..999999999, not '%s'", name, number);
    if (!*word && (colon || prefix_of(name) == MODELS))
        return kit_fail(err, "scene '%s': there is no name before its seed", name);
    return 0;
}

/* Returns the kind that a word names; without a word, the seed's. */
static int kind_of(const char *word, int64_t seed, const char *name, kit_error *err)
{
    char names[256] = "";
    if (!*word) return (int)(seed % KINDS);
    for (int k = 0; k < KINDS; k++) {
        if (!strcmp(kinds[k].name, word)) return k;
        snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", k ? ", " : "", kinds[k].name);
    }
    return kit_fail(err, "scene '%s': '%s' is no kind (%s)", name, word, names);
}

/* ---- >>faults of real models ----------------------------------------------------------------------------------- */

/* Swaps two corners of triangle t; faces: 1 also negates its normals. */
static void invert(kit_mesh *m, size_t t, int faces)
{
    float *const of[2] = { m->position + 9 * t, m->normal + 9 * t };
    for (int k = 0; k < 2; k++)
        for (int i = 0; i < 3; i++) {
            const float swap = of[k][3 + i];
            of[k][3 + i] = of[k][6 + i];
            of[k][6 + i] = swap;
        }
    for (int i = 0; i < 9 && faces; i++) of[1][i] = -of[1][i];
}

/* Gives some objects of every third scene a wrong winding, with or without wrong normals. */
static void wrong_winding(kit_build *b)
{
    kit_scene *s = &b->scene;
    char *way = calloc((size_t)s->objects + 1, 1);
    const double share = kit_chance(b) < 0.34 ? kit_between(b, 0.05, 0.35) : 0;
    if (!way) {
        b->failed = 1;
        return;
    }
    for (int k = 1; k <= s->objects; k++) way[k] = (char)(kit_chance(b) < share ? 1 + 2 * kit_chance(b) : 0);
    for (size_t t = 0; t < s->mesh.triangles; t++)
        if (way[s->mesh.object[t]]) invert(&s->mesh, t, way[s->mesh.object[t]] == 2);
    free(way);
}

/* Draws the length of a scene's unit: a metre, or another unit that people use. */
static double draw_unit(kit_build *b)
{
    static const double units[] = { 1, 1, 1, 1, 1, 100, 100, 39.370079, 0.01, 0.1 };
    return units[(int)(kit_chance(b) * (int)(sizeof units / sizeof *units))];
}

static void scale(kit_scene *s, float by)
{
    for (size_t i = 0; i < 9 * s->mesh.triangles; i++) s->mesh.position[i] *= by;
    for (int i = 0; i < 3; i++) {
        s->camera.eye[i] *= by;
        s->camera.target[i] *= by;
    }
    s->camera.ortho_height *= by;
    s->camera.znear *= by;
    s->radius *= by;
    for (int k = 0; k < s->lights; k++)
        for (int i = 0; i < 3 && s->light[k].kind == KIT_POINT; i++) {
            s->light[k].at[i] *= by;
            s->light[k].colour[i] *= by * by;
        }
}

/* ---- >>light --------------------------------------------------------------------------------------------------- */

static void add_sun(kit_build *b)
{
    kit_scene *s = &b->scene;
    const double turn = kit_between(b, 0, 2 * KIT_PI), high = kit_between(b, 0.25, 1.2),
                 strong = kit_between(b, 1.5, 4);
    kit_light *l = &s->light[s->lights++];
    *l = (kit_light){ KIT_SUN,
                      { (float)(cos(high) * cos(turn)), (float)sin(high), (float)(cos(high) * sin(turn)) },
                      { (float)strong, (float)(strong * (0.8 + 0.15 * high)), (float)(strong * (0.55 + 0.3 * high)) } };
}

static void light_up(kit_plot *p, int indoors)
{
    static const char *const inside[] = { "windows", "windows", "probe", "sky", "white" }, *const outside[] = {
        "sky", "sky", "sky", "street", "white"
    };
    kit_build *b = &p->b;
    kit_scene *s = &b->scene;
    s->env = (indoors ? inside : outside)[(int)(5 * kit_chance(b))];
    if (!indoors && !strcmp(s->env, "sky") && kit_chance(b) < 0.6) add_sun(b);
    for (int k = 0; k < p->lamps && s->lights < KIT_SCENE_LIGHTS; k++) {
        const double strong = kit_between(b, 0.4, 2.5);
        if (kit_chance(b) < 0.4) continue;
        kit_light *l = &s->light[s->lights++];
        *l = (kit_light){ KIT_POINT,
                          { (float)p->lamp[k][0], (float)p->lamp[k][1], (float)p->lamp[k][2] },
                          { (float)strong, (float)(0.82 * strong), (float)(0.6 * strong) } };
    }
}

/* ---- >>a scene ------------------------------------------------------------------------------------------------- */

int kit_load_seeded(kit_scene *scene, const char *name, kit_error *err)
{
    char word[WORD];
    int64_t seed;
    kit_error wrong = { "" };
    if (parse(&seed, word, name, err)) return -1;
    const int alone = prefix_of(name) == MODELS, kind = alone ? 0 : kind_of(word, seed, name, err);
    kit_plot *const p = kind < 0 ? NULL : calloc(1, sizeof *p);
    if (!p) return kind < 0 ? -1 : kit_fail(err, "scene '%s': no memory", name);
    kit_build *b = &p->b;
    kit_scene *s = &b->scene;
    s->camera.up[1] = 1;
    s->camera.width = 1280;
    s->camera.height = 720;
    b->random = (uint32_t)seed * 2654435761u + 40503u * (unsigned)kind + 1;
    kit_colour(b, 0.8, 0.8, 0.8);
    double unit = 1;
    if (alone) unit = kit_build_model(p, word, b->random, &wrong);
    else kit_build_thing(p, kinds[kind].name, b->random, &wrong);
    if (!s->objects) kit_begin_object(b, kinds[kind].name, -1);
    b->frame.scale = 0;
    if (!*wrong.text && !b->failed) {
        kit_mesh_bounds(&s->mesh);
        b->failed = kit_look(s, p, (alone ? KINDS : 1) * (unsigned)seed) != 0;
        light_up(p, !alone && kinds[kind].indoors);
        if (!alone) wrong_winding(b);
        scale(s, (float)(alone ? unit : draw_unit(b)));
        b->failed = b->failed || kit_complete(s, 0);
    }
    const int failed = *wrong.text ? kit_fail(err, "scene '%s': %s", name, wrong.text)
                     : b->failed   ? kit_fail(err, "scene '%s': no memory", name)
                                   : 0;
    s->name = name;
    s->about = alone ? "a model of a package, on a floor" : kinds[kind].about;
    if (failed) kit_scene_free(s);
    else *scene = *s;
    free(p);
    return failed;
}
