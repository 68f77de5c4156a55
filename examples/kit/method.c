/* method.c - the table of methods: their settings, the passes they are made of, running and timing them. Declared in kit_gl.h. */
#include "kit_gl.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/* ---- >>settings: a row each; where its value goes in a desc or in the frame ---------------------------------------- */

enum { GATHER = 1, LIGHTS = 2, BLUR = 4 /* fields of those passes' descs */, FRAME = 8, SCALED = 16 /* of the frame; times the radius */, PLAN = 0 /* the method asks for it itself */ };

typedef struct row { kit_setting setting; int where; size_t offset; } row;
#define DESC(field)  offsetof(ssgi_gl_desc, field)
#define FRAMED(field) offsetof(ssgi_gl_frame, field)

static const row noise_row     = { { "noise", "what decorrelates neighbouring pixels", "gradient tile texture", 0, 0, 2, 1 }, GATHER | LIGHTS, DESC(noise) };
static const row normal_row    = { { "normal", "normals from the G-buffer, or from depth alone", "gbuffer depth", 0, 0, 1, 1 }, PLAN, 0 };
static const row thickness_row = { { "thickness", "how far behind what is seen things reach, in radii", NULL, 1, 0, 100, 0 }, SCALED, FRAMED(thickness) };
static const row half_thick_row = { { "thickness", "how far behind what is seen things reach, in radii", NULL, 0.5, 0, 100, 0 }, SCALED, FRAMED(thickness) };
static const row most_thick_row = { { "thickness", "how far behind what is seen things reach, in radii", NULL, 0.7, 0, 100, 0 }, SCALED, FRAMED(thickness) };
static const row thin_row      = { { "thin", "1: things reach away from the viewer by thickness, 0: without end", NULL, 0, 0, 1, 1 }, GATHER, DESC(thin) };
static const row half_row      = { { "half", "1: one pixel of every 2x2, brought to full size by the filter", NULL, 0, 0, 1, 1 }, GATHER | BLUR, DESC(half) };
static const row hard_row      = { { "hard", "1: no attenuation by distance", NULL, 0, 0, 1, 1 }, GATHER, DESC(hard) };
static const row offset_row    = { { "offset", "lift of the receiver along its normal, in half pixels", NULL, 1.5, 0, 100, 0 }, FRAME, FRAMED(offset) };
static const row blur_row      = { { "blur", "radius of the filter, pixels; 0 = none", NULL, 1, 0, 4, 1 }, PLAN, 0 };
static const row filter_row    = { { "filter", "kind of filter", "bilateral gaussian", 0, 0, 1, 1 }, BLUR, DESC(filter) };
static const row compare_row   = { { "filter_normals", "1: the filter compares normals too", NULL, 0, 0, 1, 1 }, BLUR, DESC(filter_normals) };
static const row phase_row     = { { "phase", "turns the noise", NULL, 0, 0, 1, 0 }, FRAME, FRAMED(phase) };
static const row layers_row    = { { "layers", "depth layers, peeled; the scene must be of closed solids", NULL, 1, 1, KIT_MAX_LAYERS, 1 }, GATHER | LIGHTS, DESC(layers) };
static const row views_row     = { { "views", "extra cameras; the scene must be of closed solids", NULL, 0, 0, 4, 1 }, GATHER | LIGHTS, DESC(views) };
static const row view_layers_row = { { "view_layers", "depth layers of each extra camera", NULL, 1, 1, KIT_MAX_LAYERS, 1 }, GATHER | LIGHTS, DESC(view_layers) };
static const row view_size_row = { { "view_size", "pixels of an extra camera's side", NULL, 256, 16, 4096, 1 }, PLAN, 0 };

static const row samples_row   = { { "samples", "directions per pixel", NULL, 16, 1, 64, 1 }, GATHER, DESC(samples) };
static const row march_row     = { { "steps", "points along a direction, the first blocked one counts", NULL, 1, 1, 64, 1 }, GATHER, DESC(steps) };
static const row falloff_row   = { { "falloff", "weight of a blocker at distance t: 1 - t/radius, or the square or cube of that ratio", "linear square cube", 0, 0, 2, 1 }, GATHER, DESC(falloff) };
static const row fade_row      = { { "fade", "how blockers fade with the distance at which they are seen", "none smooth lambda lambda-ended", 0, 0, 3, 1 }, GATHER, DESC(fade) };
static const row lambda_row    = { { "lambda", "of that fading, per radius: more is weaker", NULL, 4, 0, 1000, 0 }, FRAME, FRAMED(lambda) };
static const row range_row     = { { "range", "1: what is seen beyond the radius or below the receiver's plane blocks nothing", NULL, 0, 0, 1, 1 }, GATHER, DESC(range) };
static const row fade_from_row = { { "fade_from", "where smooth fading begins, in radii", NULL, 0.3, 0, 1, 0 }, SCALED, FRAMED(fade) };
static const row sets_row      = { { "sets", "sets of directions in a texture, one a pixel; 0 = one set, turned", NULL, 0, 0, 256, 1 }, PLAN, 0 };
static const row slices_row    = { { "directions", "slices, two directions each", NULL, 1, 1, 32, 1 }, GATHER, DESC(directions) };
static const row dirs_row      = { { "directions", "N_d: directions in the tangent plane", NULL, 6, 1, 32, 1 }, GATHER, DESC(directions) };
static const row steps_row     = { { "steps", "N_s: steps per direction", NULL, 6, 1, 64, 1 }, GATHER, DESC(steps) };
static const row rays_row      = { { "normal_rays", "N_n: rays above the horizon, per direction", NULL, 0, 0, 8, 1 }, GATHER, DESC(normal_rays) };

static const row environment_row = { { "environment", "how --env is used", "map sh none", 0, 0, 2, 1 }, PLAN, 0 };
static const row bounce_row    = { { "bounce", "one diffuse bounce, by which estimator", "none solid-angle patch disc", 1, 0, 3, 1 }, GATHER, DESC(bounce) };
static const row reuse_row     = { { "reuse", "1: senders shine with the last frame's light, so that one gather does both", NULL, 0, 0, 1, 1 }, PLAN, 0 };
static const row two_sided_row = { { "two_sided", "1: senders shine from both sides", NULL, 0, 0, 1, 1 }, GATHER, DESC(two_sided) };
static const row nearest_row   = { { "nearest", "clamp of the distance to a patch, in radii", NULL, 0.25, 0, 100, 0 }, FRAME, FRAMED(nearest) };
static const row gain_row      = { { "gain", "area of patches and discs, times pi r^2/N", NULL, 1, 0, 1000, 0 }, FRAME, FRAMED(gain) };
static const row shadows_row   = { { "shadows", "of --light: maps and what their bias loses, maps, points on segments in screen space", "segment map fill none", 2, 0, 3, 1 }, LIGHTS, DESC(shadow) };
static const row shadows_d_row = { { "shadows", "of --light: maps or none", "segment map fill none", 1, 0, 3, 1 }, LIGHTS, DESC(shadow) };
static const row points_row    = { { "points", "on a segment toward a light", NULL, 8, 1, 64, 1 }, LIGHTS, DESC(samples) };
static const row solid_row     = { { "solid", "1: shadows: what is seen reaches away from the viewer without end", NULL, 0, 0, 1, 1 }, PLAN, 0 };
static const row steepest_row  = { { "steepest", "slope up to which the shadow maps' bias follows", NULL, 20, 0, 1000, 0 }, FRAME, FRAMED(steepest) };
static const row shadow_row    = { { "shadow_size", "texels of a shadow map's side", NULL, 1024, 16, 8192, 1 }, PLAN, 0 };
static const row suns_row      = { { "suns", "the environment as so many suns with shadow maps; 0 = by directional occlusion", NULL, 0, 0, 1024, 1 }, PLAN, 0 };
static const row vpls_row      = { { "vpls", "virtual point lights of the first --light, with shadow maps: the bounce beyond the radius", NULL, 0, 0, 4096, 1 }, PLAN, 0 };

static const row bands_row     = { { "bands", "of spherical harmonics: 1, 4, 9 or 16 coefficients", NULL, 4, 1, 4, 1 }, GATHER | BLUR, DESC(bands) };
static const row few_bands_row = { { "bands", "environment=sh: of spherical harmonics", NULL, 3, 1, 4, 1 }, GATHER, DESC(bands) };
static const row store_row     = { { "store", "coefficients as halves, halves packed into integers, or floats", "half packed float", 0, 0, 2, 1 }, PLAN, 0 };
static const row indirect_row  = { { "indirect", "one bounce: no, in one gather with the occlusion, in one of its own", "none joint apart", 1, 0, 2, 1 }, PLAN, 0 };
static const row filtered_row  = { { "filtered", "what the filter works on", "vectors light", 1, 0, 1, 1 }, PLAN, 0 };
static const row dering_row    = { { "dering", "1: weakens the environment's higher bands until it is nowhere negative", NULL, 0, 0, 1, 1 }, PLAN, 0 };
static const row exact_row     = { { "exact", "1: open surfaces get exactly what the light brings, harmonics only tell what is blocked", NULL, 1, 0, 1, 1 }, GATHER, DESC(exact) };
static const row window_row    = { { "window", "of lights as harmonics", "none hann positive", 1, 0, 2, 1 }, PLAN, 0 };
static const row lights_row    = { { "lights", "--light as harmonics, or by maps and segments", "harmonics shadowed", 0, 0, 1, 1 }, PLAN, 0 };
static const row cone_row      = { { "cone", "the environment over the cone of free directions, or its irradiance along their mean", "normal cone", 1, 0, 1, 1 }, PLAN, 0 };

static const row resolution_row = { { "resolution", "texels along a side of a field's cube map; with error at most", NULL, 16, 2, 128, 1 }, PLAN, 0 };
static const row radii_row     = { { "radii", "distances sampled along each direction; with error at most", NULL, 12, 4, 64, 1 }, PLAN, 0 };
static const row rays_a_row    = { { "rays", "a sample of the bake", NULL, 128, 16, 65536, 1 }, PLAN, 0 };
static const row error_row     = { { "error", "above 0: the smallest resolution and fewest radii with which 95 % of receivers are within it", NULL, 0, 0, 1, 0 }, PLAN, 0 };
static const row measure_row   = { { "measure", "what a field keeps: vector irradiance and fill, or solid angle as published", "vector solid-angle", 0, 0, 1, 1 }, GATHER, DESC(measure) };
static const row bits_row      = { { "bits", "a component of a field", "16 8", 0, 0, 1, 1 }, GATHER, DESC(eight_bits) };
static const row storage_row   = { { "storage", "fields as slices of an integer array, or as cube maps", "atlas cube", 0, 0, 1, 1 }, GATHER, DESC(storage) };
static const row cap_row       = { { "cap", "closed form, or a table", "closed table", 0, 0, 1, 1 }, GATHER, DESC(cap) };
static const row table_row     = { { "table_size", "of that table", NULL, 64, 2, 1024, 1 }, PLAN, 0 };
static const row reach_row     = { { "reach", "how far casters go, in radii of their bounding spheres", NULL, 8, 1.5, 64, 0 }, PLAN, 0 };
static const row ramp_row      = { { "ramp", "where they begin to fade, as a share of the reach", NULL, 0.75, 0, 0.99, 0 }, PLAN, 0 };
static const row inside_row    = { { "inside", "A_0: occlusion deep in the convex hull; -1 = as measured", NULL, -1, -1, 1, 0 }, PLAN, 0 };
static const row power_row     = { { "power", "p: how fast it is reached", NULL, 1, 0.01, 100, 0 }, PLAN, 0 };
static const row draw_row      = { { "draw", "casters instanced, or each by a draw of its own", "instanced each", 0, 0, 1, 1 }, PLAN, 0 };
static const row own_row       = { { "own", "1: casters shade themselves too", NULL, 0, 0, 1, 1 }, PLAN, 0 };
static const row casters_row   = { { "casters", "objects that are solid and hold no other, or all", "solid all", 0, 0, 1, 1 }, PLAN, 0 };

static const row size_row      = { { "size", "s: diameter of a surfel, in picture heights", NULL, 0.015, 1e-4, 1, 0 }, PLAN, 0 };
static const row epsilon_row   = { { "epsilon", "the least that a surfel is drawn for", NULL, 0.1, 1e-6, 1, 0 }, FRAME, FRAMED(epsilon) };
static const row deep_epsilon_row = { { "epsilon", "the least that a surfel is drawn for", NULL, 0.02, 1e-6, 1, 0 }, FRAME, FRAMED(epsilon) };
static const row deep_levels_row = { { "levels", "each doubles the reach", NULL, 7, 1, SSGI_SPLAT_LEVELS, 1 }, GATHER, DESC(levels) };
static const row levels_row    = { { "levels", "each doubles the reach", NULL, 5, 1, SSGI_SPLAT_LEVELS, 1 }, GATHER, DESC(levels) };
static const row way_row       = { { "way", "surfels made on the CPU, captured from tessellation, or splatted by a geometry shader at once", "cpu capture direct", 0, 0, 2, 1 }, PLAN, 0 };
static const row near_row      = { { "closely", "points over a surfel, for pixels within 4 of its radii; 1: its centre alone", NULL, 4, 1, 16, 1 }, GATHER, DESC(closely) };
static const row aside_row     = { { "aside", "how much surfels grow with their distance from the frustum, radii", NULL, 0.1, 0, 1, 0 }, PLAN, 0 };
static const row front_row     = { { "front", "1: the nearest depth seen limits splats, 0: the near plane", NULL, 1, 0, 1, 1 }, PLAN, 0 };
static const row both_row      = { { "two_sided", "1: surfels have two sides, as sheets and leaves want it", NULL, 0, 0, 1, 1 }, GATHER, DESC(two_sided) };
static const row every_row     = { { "every", "1: every triangle gives surfels, 0: of small ones a share does", NULL, 0, 0, 1, 1 }, PLAN, 0 };
static const row each_row      = { { "every", "1: every triangle gives surfels, 0: of small ones a share does, which shows", NULL, 1, 0, 1, 1 }, PLAN, 0 };
static const row jitter_row    = { { "jitter", "how far surfels are moved by chance, in radii", NULL, 0, 0, 1, 0 }, PLAN, 0 };
static const row splits_row    = { { "splits", "into how many parts an edge of a large triangle is split at most", NULL, 8, 1, 32, 1 }, PLAN, 0 };
static const row shrink_row    = { { "shrink", "way=cpu: how surfels keep off edges", "incentre centroid", 0, 0, 1, 1 }, PLAN, 0 };
static const row fixed_row     = { { "fixed", "1: the same pixel of every block goes to a sub-buffer, 0: by chance", NULL, 0, 0, 1, 1 }, GATHER, DESC(fixed) };
static const row enlarge_row   = { { "enlarge", "levels make up for fewer surfels by weight, or by radius as published", NULL, 0, 0, 1, 1 }, GATHER, DESC(enlarge) };
static const row overlap_row   = { { "overlap", "where surfels hide each other: form factors as shares of what is left, or added", "share add", 0, 0, 1, 1 }, GATHER, DESC(overlap) };
static const row smooth_row    = { { "smooth", "0: levels are added as they are", NULL, 1, 0, 1, 1 }, PLAN, 0 };
static const row likeness_row  = { { "filter_normals", "1: the smoothing compares normals too", NULL, 0, 0, 1, 1 }, GATHER, DESC(filter_normals) };
static const row exponent_row  = { { "exponent", "of the lobe", NULL, 32, 0, 10000, 0 }, FRAME, FRAMED(exponent) };
static const row sky_row       = { { "sky", "1: --env lights surfels, too, as if nothing stood before them", NULL, 1, 0, 1, 1 }, PLAN, 0 };
static const row material_row  = { { "material", "published constants of scattering", "apple chicken1 chicken2 cream ketchup marble potato skimmilk skin1 skin2 spectralon wholemilk", 5, 0, 11, 1 }, PLAN, 0 };
static const row unit_row      = { { "unit", "world units of a millimetre", NULL, 0.01, 1e-6, 1e6, 0 }, PLAN, 0 };

typedef struct plan { const char *name, *about; int pass, search, preset; const row *rows[KIT_MAX_SETTINGS]; } plan;
#define SLICES { &slices_row, &steps_row, &half_row, &thin_row, &thickness_row, &hard_row, &normal_row, &noise_row, &phase_row, &blur_row, &filter_row, &compare_row }
#define DEEP &layers_row, &views_row, &view_layers_row, &view_size_row
#define SSDO { &few_bands_row, &samples_row, &march_row, &sets_row, &falloff_row, &fade_row, &fade_from_row, &lambda_row, &range_row, &half_row, &thin_row, &most_thick_row, &offset_row, DEEP, &environment_row, &bounce_row, \
    &reuse_row, &two_sided_row, &nearest_row, &gain_row, &shadows_row, &points_row, &solid_row, &steepest_row, &shadow_row, &suns_row, &vpls_row, &normal_row, &noise_row, &phase_row, \
    &blur_row, &filter_row, &compare_row }
#define VECTORS &samples_row, &march_row, &sets_row, &falloff_row, &fade_row, &fade_from_row, &lambda_row, &range_row, &half_row, &thin_row, &most_thick_row, &offset_row, DEEP, &store_row, \
    &filtered_row, &window_row, &lights_row, &shadows_row, &points_row, &solid_row, &steepest_row, &shadow_row, &normal_row, &noise_row, &phase_row, &blur_row, &filter_row, &compare_row
#define S3HO { &bands_row, &indirect_row, &exact_row, &two_sided_row, &dering_row, VECTORS }
#define SURFELS(every, epsilon, levels) &size_row, epsilon, levels, &way_row, &jitter_row, &splits_row, &aside_row, every, &front_row, &shrink_row, &fixed_row, &enlarge_row, &near_row, &overlap_row, &both_row, &smooth_row, &likeness_row, &normal_row
#define LIT_SURFELS &sky_row, &shadows_d_row, &shadow_row, &steepest_row
static const plan plans[] = {
    { "ssao", "point samples in the hemisphere", SSGI_GL_SSAO, 0, SSGI_GL_BALANCED,
      { &samples_row, &march_row, &sets_row, &falloff_row, &fade_row, &fade_from_row, &lambda_row, &range_row, &half_row, &thin_row, &thickness_row, &offset_row, DEEP, &normal_row, &noise_row, &phase_row, &blur_row,
        &filter_row, &compare_row } },
    { "hsao", "horizon search in slices through the view direction", SSGI_GL_HSAO, SSGI_GL_SLICES, SSGI_GL_BALANCED, SLICES },
    { "hsao-fast", "the same, fewer taps", SSGI_GL_HSAO, SSGI_GL_SLICES, SSGI_GL_FAST, SLICES },
    { "hsao-best", "the same, full size, more taps", SSGI_GL_HSAO, SSGI_GL_SLICES, SSGI_GL_BEST, SLICES },
    { "hsao-march", "the paper's horizon march and normal rays", SSGI_GL_HSAO, SSGI_GL_MARCH, SSGI_GL_BALANCED,
      { &dirs_row, &steps_row, &rays_row, &half_row, &thin_row, &half_thick_row, &hard_row, &offset_row, DEEP, &normal_row, &noise_row, &phase_row, &blur_row, &filter_row, &compare_row } },
    { "ssdo", "directional occlusion of --env, --light with shadows, one bounce", SSGI_GL_SSDO, 0, SSGI_GL_BALANCED, SSDO },
    { "ssdo-fast", "the same, half size, fewer directions", SSGI_GL_SSDO, 0, SSGI_GL_FAST, SSDO },
    { "ssdo-best", "the same, more directions", SSGI_GL_SSDO, 0, SSGI_GL_BEST, SSDO },
    { "s3ho", "occlusion as spherical harmonics, --env and --light dotted with it, one bounce", SSGI_GL_S3HO, 0, SSGI_GL_BALANCED, S3HO },
    { "s3ho-fast", "the same, half size, fewer directions", SSGI_GL_S3HO, 0, SSGI_GL_FAST, S3HO },
    { "s3ho-best", "the same, more directions", SSGI_GL_S3HO, 0, SSGI_GL_BEST, S3HO },
    { "ssbn", "bent normals and cones, looked up in --env filtered beforehand", SSGI_GL_S3HO, 0, SSGI_GL_BALANCED, { &cone_row, VECTORS } },
    { "dss", "deep screen space: surfels of all triangles, seen or not, splatted: occlusion", SSGI_GL_SPLAT, SSGI_GL_EFFECT_OCCLUSION, SSGI_GL_BALANCED, { SURFELS(&every_row, &epsilon_row, &levels_row), &hard_row } },
    { "dss-lit", "the same: directional occlusion of --env, --light with shadow maps, one bounce", SSGI_GL_SPLAT, SSGI_GL_EFFECT_LIGHT, SSGI_GL_BALANCED, { SURFELS(&every_row, &epsilon_row, &levels_row), LIT_SURFELS } },
    { "dss-gloss", "the same: one specular bounce; irradiance: radiance of the lobe", SSGI_GL_SPLAT, SSGI_GL_EFFECT_SPECULAR, SSGI_GL_BALANCED, { SURFELS(&every_row, &epsilon_row, &levels_row), LIT_SURFELS, &exponent_row } },
    { "dss-scatter", "the same: multiple scattering under surfaces; irradiance: radiance that leaves them", SSGI_GL_SPLAT, SSGI_GL_EFFECT_SCATTER, SSGI_GL_BALANCED, { SURFELS(&each_row, &deep_epsilon_row, &deep_levels_row), LIT_SURFELS, &material_row, &unit_row } },
    { "aof", "occlusion between a scene's objects, at any distance, from fields baked around each; has no --radius", SSGI_GL_FIELD, 0, SSGI_GL_BALANCED,
      { &resolution_row, &radii_row, &rays_a_row, &error_row, &measure_row, &bits_row, &storage_row, &cap_row, &table_row, &reach_row, &ramp_row, &inside_row, &power_row, &draw_row, &own_row, &casters_row, &normal_row } }
};
enum { PLANS = (int)(sizeof plans / sizeof plans[0]) };

int kit_method_at(kit_method *method, int i)
{
    kit_method m;
    ssgi_gl_desc desc;
    if (i < 0 || i >= PLANS) return 0;
    memset(&m, 0, sizeof m);
    m.name = plans[i].name;
    m.about = plans[i].about;
    m.between = plans[i].pass == SSGI_GL_FIELD;
    m.lit = plans[i].pass == SSGI_GL_SSDO || plans[i].pass == SSGI_GL_S3HO || (plans[i].pass == SSGI_GL_SPLAT && plans[i].search);
    memset(&desc, 0, sizeof desc);
    desc.pass = plans[i].pass;
    if (plans[i].pass == SSGI_GL_SPLAT) desc.effect = plans[i].search; else desc.search = plans[i].search;
    desc.environment = m.lit ? SSGI_GL_ENVIRONMENT_MAP : SSGI_GL_ENVIRONMENT_NONE;
    ssgi_gl_preset(&desc, plans[i].preset, NULL);
    for (; plans[i].rows[m.count]; ++m.count) {            /* what the preset sets, the setting starts from */
        const row *w = plans[i].rows[m.count];
        int value = 0;
        m.setting[m.count] = w->setting;
        if (w->where & GATHER) memcpy(&value, (const char *)&desc + w->offset, sizeof value);
        if (value) m.setting[m.count].value = value;
        if (w == &blur_row) m.setting[m.count].value = desc.filter_radius;
    }
    *method = m;
    return 1;
}

int kit_method_find(kit_method *method, const char *name, kit_error *err)
{
    char names[256] = "";
    kit_method m;
    for (int i = 0; kit_method_at(&m, i); ++i) {
        if (!strcmp(m.name, name)) { *method = m; return 0; }
        snprintf(names + strlen(names), sizeof names - strlen(names), "%s%s", i ? ", " : "", m.name);
    }
    return kit_fail(err, "--method %s: there is none of that name (%s)", name, names);
}

static int set_one(kit_method *m, const char *text, size_t length, kit_error *err)
{
    char key[128], *value, *end;
    if (length >= sizeof key) return kit_fail(err, "--set %.40s...: too long", text);
    memcpy(key, text, length);
    key[length] = 0;
    value = strchr(key, '=');
    if (!value) return kit_fail(err, "--set %s: must be key=value", key);
    *value++ = 0;
    for (int i = 0; i < m->count; ++i) {
        kit_setting *s = &m->setting[i];
        double v = -1;
        if (strcmp(s->key, key)) continue;
        if (s->choices) {
            const char *word = s->choices;
            for (int k = 0; *word; ++k) {
                size_t n = strcspn(word, " ");
                if (strlen(value) == n && !strncmp(word, value, n)) v = k;
                word += n + (word[n] ? 1 : 0);
            }
            if (v < 0) return kit_fail(err, "--set %s=%s: must be one of: %s", key, value, s->choices);
        } else {
            v = strtod(value, &end);
            if (end == value || *end || !(v >= s->least && v <= s->most) || (s->whole && v != floor(v)))
                return kit_fail(err, "--set %s=%s: must be a %snumber in %g..%g", key, value, s->whole ? "whole " : "", s->least, s->most);
        }
        s->value = v;
        return 0;
    }
    return kit_fail(err, "--set %s=%s: method %s has no such setting (--list names them)", key, value, m->name);
}

int kit_method_set(kit_method *method, const char *text, kit_error *err)
{
    kit_method m = *method;
    while (*text) {
        size_t n = strcspn(text, ",");
        if (set_one(&m, text, n, err)) return -1;
        text += n + (text[n] ? 1 : 0);
    }
    *method = m;
    return 0;
}

double kit_method_value(const kit_method *method, const char *key)
{
    for (int i = 0; i < method->count; ++i) if (!strcmp(method->setting[i].key, key)) return method->setting[i].value;
    return 0;
}

ssgi_field_desc kit_method_field(const kit_method *method)
{
    ssgi_field_desc d;
    memset(&d, 0, sizeof d);
    d.resolution = (int)kit_method_value(method, "resolution");
    d.radii = (int)kit_method_value(method, "radii");
    d.rays = (int)kit_method_value(method, "rays");
    d.measure = (int)kit_method_value(method, "measure");
    d.bits = kit_method_value(method, "bits") > 0 ? 8 : 16;
    d.reach = (float)kit_method_value(method, "reach");
    d.error = (float)kit_method_value(method, "error");
    return d;
}

/* ---- >>run ------------------------------------------------------------------------------------------------------ */

int kit_dialect(void) { return kit_gl_is_es() ? SSGI_GL_300ES : SSGI_GL_330; }

GLuint kit_pass_program(const ssgi_gl_desc *desc, kit_error *err)
{
    static const GLenum kinds[SSGI_GL_STAGES] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER, GL_GEOMETRY_SHADER };
    char *text[SSGI_GL_STAGES];
    const char *source[SSGI_GL_STAGES], *captured[3], *why = "";
    GLenum stages[SSGI_GL_STAGES];
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    GLuint program = 0, block;
    int count = 0, captures = 0, failed = 0;
    if (ssgi_gl_check(desc, &why) != SSGI_OK) { kit_fail(err, "%s", why); return 0; }
    for (int s = 0; s < SSGI_GL_STAGES && !failed; ++s) {
        const size_t n = ssgi_gl_emit(NULL, 0, desc, s);
        if (!n) continue;
        text[count] = malloc(n + 1);
        failed = !text[count];
        if (failed) break;
        ssgi_gl_emit(text[count], n + 1, desc, s);
        source[count] = text[count];
        stages[count++] = kinds[s];
    }
    if (failed) kit_fail(err, "out of memory"); else program = kit_program(source, stages, count, err);
    for (int i = 0; i < count; ++i) free(text[i]);
    if (!program) return 0;
    for (int i = 0, n = ssgi_gl_reflect(desc, io, SSGI_GL_MAX_IO); i < n; ++i) if (io[i].kind == SSGI_GL_CAPTURE) captured[captures++] = io[i].name;
    if (captures) {
        glTransformFeedbackVaryings(program, captures, captured, GL_INTERLEAVED_ATTRIBS);
        GLint linked = 0;
        glLinkProgram(program);
        glGetProgramiv(program, GL_LINK_STATUS, &linked);
        if (!linked) { kit_fail(err, "pass %s: its varyings cannot be captured by %s", ssgi_gl_pass_name(desc->pass), kit_gl_name()); glDeleteProgram(program); return 0; }
    }
    glUseProgram(program);
    for (int i = 0, n = ssgi_gl_reflect(desc, io, SSGI_GL_MAX_IO); i < n; ++i)
        if (io[i].kind == SSGI_GL_TEXTURE) glUniform1i(glGetUniformLocation(program, io[i].name), io[i].slot);
    for (GLuint k = 0; k < 2; ++k) {
        block = glGetUniformBlockIndex(program, k ? "ssgi_views" : "ssgi_frame");
        if (block != GL_INVALID_INDEX) glUniformBlockBinding(program, block, k);
    }
    return program;
}

/* What kit_run_open works with; the run is its result. */
typedef struct making {
    kit_run           *run;
    const plan        *plan;
    const kit_method  *method;
    const kit_world   *world;
    ssgi_gl_desc       gather, lights, blur, shade;
    int                blurred;
    GLuint             rows[1 + KIT_MAX_VIEWS];    /* lights, as the picture's camera and the extra ones have them; 0 = none */
    kit_error         *err;
} making;

static GLuint keep(kit_run *run, GLuint texture)
{
    if (texture && run->textures < KIT_MAX_TEXTURES) run->texture[run->textures++] = texture;
    return texture;
}

/* The format of an output, from its row: vectors as many floats or integers a texel as their bands need. */
static GLenum target_format(const making *m, const ssgi_gl_desc *desc, const ssgi_gl_io *out)
{
    const int stored = (int)kit_method_value(m->method, "store"), more = out->name[strlen(out->name) - 1] != '0';
    if ((desc->pass == SSGI_GL_FIELD || (desc->pass == SSGI_GL_SPLAT && !strcmp(out->type, "float"))) && kit_gl_is_es()) return GL_R16F;         /* blended */
    if (desc->pass == SSGI_GL_SPLAT && kit_gl_is_es()) return GL_RGBA16F;
    if (desc->pass == SSGI_GL_SHUFFLE) return GL_RGBA32UI;
    if (!strcmp(out->type, "float")) return GL_R32F;
    if (!strcmp(out->type, "vec2")) return GL_RG32F;
    if (!strcmp(out->type, "uvec4")) return desc->bands == (more ? 3 : 1) ? GL_R32UI : desc->bands == 2 ? GL_RG32UI : GL_RGBA32UI;
    if (strncmp(out->name, "o_ssgi_sh", 9)) return GL_RGBA32F;
    if (desc->bands == 1 || (desc->bands == 3 && !strcmp(out->name, "o_ssgi_sh2"))) return stored ? GL_R32F : GL_R16F;
    return stored ? GL_RGBA32F : GL_RGBA16F;
}

/* A pass and its targets: own ones, or, when array is not 0, a slice of that. NULL on failure. */
static kit_pass *add_pass(making *m, const ssgi_gl_desc *desc, const kit_gbuffer *g, int frame, GLuint source, GLuint array, int slice)
{
    static const GLenum attachment[KIT_MAX_TARGETS] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2, GL_COLOR_ATTACHMENT3, GL_COLOR_ATTACHMENT4, GL_COLOR_ATTACHMENT5 };
    kit_run *run = m->run;
    kit_pass *p = &run->pass[run->passes];
    const int half = desc->half && desc->pass != SSGI_GL_BLUR, levelled = desc->pass >= SSGI_GL_SHUFFLE && desc->pass <= SSGI_GL_SMOOTH;
    const uint64_t key = ssgi_gl_key(desc);
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    int outputs = 0;
    if (run->passes == KIT_MAX_PASSES) { kit_fail(m->err, "method %s: more than %d passes", m->method->name, KIT_MAX_PASSES); return NULL; }
    memset(p, 0, sizeof *p);
    p->desc = *desc;
    p->gbuffer = g;
    p->frame = frame;
    p->source = source;
    p->vectors = -1;
    p->width = levelled ? run->frame.level[0] : half ? (g->viewport[2] + 1) / 2 : g->viewport[2];
    p->height = levelled ? run->frame.level[1] * desc->levels : half ? (g->viewport[3] + 1) / 2 : g->viewport[3];
    for (int i = 0; i < run->passes && !p->program; ++i) if (run->pass[i].key == key) p->program = run->pass[i].program;
    if (!p->program) p->program = kit_pass_program(desc, m->err);
    if (!p->program) return NULL;
    p->key = key;
    ++run->passes;
    if (desc->pass == SSGI_GL_SURFELS) return p;                    /* draws nothing */
    glGenFramebuffers(1, &p->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer);
    for (int i = 0, n = ssgi_gl_reflect(desc, io, SSGI_GL_MAX_IO); i < n; ++i) {
        if (io[i].kind != SSGI_GL_OUTPUT) continue;
        if (array) glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, array, 0, slice);
        else {
            p->target[outputs] = desc->pass == SSGI_GL_FIELD && p > run->pass ? run->pass[0].target[0]     /* casters are blended over each other */
                                                                              : keep(run, kit_texture(p->width, p->height, target_format(m, desc, &io[i]), NULL));
            glFramebufferTexture2D(GL_FRAMEBUFFER, attachment[outputs], GL_TEXTURE_2D, p->target[outputs], 0);
        }
        ++outputs;
    }
    glDrawBuffers(outputs, attachment);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) { kit_fail(m->err, "%s cannot draw into the targets of pass %s", kit_gl_name(), ssgi_gl_pass_name(desc->pass)); return NULL; }
    if (desc->pass == SSGI_GL_SSDO || desc->pass == SSGI_GL_LIGHTS) for (int i = 0; i < outputs && !array; ++i) glClearBufferfv(GL_COLOR, i, (const GLfloat[4]) { 0, 0, 0, 0 });
    if (desc->pass != SSGI_GL_SPLAT) run->fetches += ssgi_gl_fetches(desc) * (double)p->width * p->height / ((double)run->frame.size[0] * run->frame.size[1]);
    return p;
}

static int add_blur(making *m, GLuint *texture)
{
    kit_pass *p;
    if (!m->blurred) return 0;
    p = add_pass(m, &m->blur, m->run->gbuffer, 0, *texture, 0, 0);
    if (!p) return -1;
    *texture = p->target[0];
    return 0;
}

/* The direct light of a layer that camera v sees (-1: the picture's own): environment, then lights. *light: the texture, 0 = there is none. */
static int add_direct(making *m, const kit_gbuffer *g, int v, int receiver, GLuint *light)
{
    ssgi_gl_desc gather = m->gather, lights = m->lights;
    const int picture = v < 0 && !receiver;
    *light = 0;
    if (v >= 0) {
        gather.views = lights.views = 0;
        gather.layers = lights.layers = m->gather.view_layers;
        gather.depth = lights.depth = SSGI_GL_DEPTH_WINDOW;
        gather.orthographic = lights.orthographic = 0;
    }
    gather.receiver = lights.receiver = receiver;
    if (!picture) gather.normal = lights.normal = SSGI_GL_NORMAL_SIGNED;      /* depth gives the normals of what is seen alone */
    gather.bounce = SSGI_GL_BOUNCE_NONE;
    if (!picture) gather.half = 0;
    if (gather.environment) {
        kit_pass *p = add_pass(m, &gather, g, v < 0 ? 0 : 1 + 2 * v, 0, 0, 0);
        if (!p) return -1;
        *light = p->target[0];
        if (picture && add_blur(m, light)) return -1;
    }
    if (m->rows[1 + v]) {
        kit_pass *p;
        lights.accumulate = *light != 0;
        p = add_pass(m, &lights, g, v < 0 ? 0 : 1 + 2 * v, *light, 0, 0);
        if (!p) return -1;
        p->lights = m->rows[1 + v];
        *light = p->target[0];
    }
    return 0;
}

static int add_senders(making *m, const kit_gbuffer *g, int v, int receiver, GLuint light)
{
    const int albedo = m->gather.pass == SSGI_GL_S3HO;
    ssgi_gl_desc d = m->lights;
    d.pass = SSGI_GL_SENDERS;
    d.receiver = receiver;
    d.layers = v < 0 ? m->gather.layers : m->gather.view_layers;
    d.views = 0;
    if (v >= 0 || receiver) d.normal = SSGI_GL_NORMAL_SIGNED;
    if (v >= 0) {
        d.depth = SSGI_GL_DEPTH_WINDOW;
        d.orthographic = 0;
        d.world_normals = 1;                /* that camera's view space to the picture's */
    }
    d.radiance = albedo ? SSGI_GL_RADIANCE_ALBEDO : light && g->direct ? SSGI_GL_RADIANCE_BOTH : light ? SSGI_GL_RADIANCE_LIGHT : SSGI_GL_RADIANCE_DIRECT;
    return add_pass(m, &d, g, v < 0 ? 0 : 2 + 2 * v, light, v < 0 ? m->run->senders : m->run->view_senders, v < 0 ? receiver : v * m->gather.view_layers + receiver) ? 0 : -1;
}

/* ---- >>cameras: what is seen, extra cameras, shadow maps ----------------------------------------------------------- */

typedef struct sphere { float centre[3], radius; } sphere;

static int by_value(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

/* all: the sphere that holds most of what the G-buffer shows, for shadow maps. middle: at the median depth in the middle of the picture, as wide as that,
   for extra cameras. In the world. */
static int seen(const kit_gbuffer *g, sphere *all, sphere *middle, kit_error *err)
{
    kit_image frame;
    const kit_camera *c = &g->camera;
    const float *z;
    float *depths, at[3];
    double sum[4] = { 0, 0, 0, 0 }, squares = 0, median = 1;
    int count = 0;
    if (kit_gbuffer_read(&frame, g, err)) return -1;
    depths = malloc((size_t)(frame.width * frame.height + 1) * sizeof *depths);
    if (!depths) { kit_image_free(&frame); return kit_fail(err, "out of memory"); }
    z = kit_image_channel(&frame, "Z");
    for (int i = 0; i < frame.width * frame.height; i += 7) {
        const int x = i % frame.width, y = i / frame.width;
        if (!(z[i] > 0)) continue;
        kit_camera_point(c, x, y, (double)z[i], at);
        for (int k = 0; k < 3; ++k) {
            sum[k] += (double)at[k];
            squares += (double)at[k] * (double)at[k];
        }
        sum[3] += 1;
        if (abs(2 * x - frame.width) < frame.width / 2 && abs(2 * y - frame.height) < frame.height / 2) depths[count++] = z[i];
    }
    if (count) {
        qsort(depths, (size_t)count, sizeof *depths, by_value);
        median = (double)depths[count / 2];
    }
    free(depths);
    kit_image_free(&frame);
    if (!(sum[3] > 0)) sum[3] = 1;
    squares /= sum[3];
    for (int k = 0; k < 3; ++k) {
        all->centre[k] = (float)(sum[k] / sum[3]);
        squares -= sum[k] / sum[3] * (sum[k] / sum[3]);
    }
    kit_camera_point(c, c->width / 2, c->height / 2, median, middle->centre);
    all->radius = (float)(1.8 * sqrt(squares > 0 ? squares : 0)) + 1e-6f;
    middle->radius = (float)(c->fovy > 0 ? median * tan((double)c->fovy * PI / 360) : 0.5 * (double)c->ortho_height) * fmaxf(1, (float)c->width / (float)c->height);
    return 0;
}

static int view_of(ssgi_view *view, const float projection[16], int depth, int width, int height, kit_error *err)
{
    const char *why = "";
    return ssgi_view_from_projection(view, projection, depth == KIT_DEPTH_NORMAL ? SSGI_CLIP_GL : SSGI_CLIP_ZERO, width, height, &why) == SSGI_OK ? 0 : kit_fail(err, "%s", why);
}

static void rotation_of(float rotation[12], const float a[16], const float b[16])     /* a * transpose(b), as mat3 */
{
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) {
            rotation[4 * c + r] = 0;
            for (int k = 0; k < 3; ++k) rotation[4 * c + r] += a[4 * k + r] * (b ? b[4 * k + c] : k == c ? 1.0f : 0.0f);
        }
}

/* Extra cameras: their G-buffers, their frames, their depths as one array. */
static int add_views(making *m, const float picture[16], const sphere *about)
{
    kit_run *run = m->run;
    const int size = (int)kit_method_value(m->method, "view_size"), layers = m->gather.view_layers;
    const size_t texels = (size_t)size * (size_t)size;
    float *depth = malloc(texels * (size_t)(m->gather.views * layers) * sizeof *depth);
    int failed = !depth;
    if (failed) kit_fail(m->err, "no memory for %d extra cameras", m->gather.views);
    for (int v = 0; v < m->gather.views && !failed; ++v) {
        const char *why = "";
        float to[16], projection[16], displacement[3];
        kit_camera c = run->gbuffer->camera;
        ssgi_view view;
        ssgi_gl_frame frame;
        kit_gbuffer *g = &run->view[v];
        ssgi_extra_displacement(v, displacement);
        if (ssgi_extra_camera(to, projection, picture, about->centre, about->radius, displacement, &why) != SSGI_OK) failed = kit_fail(m->err, "extra camera: %s", why);
        if (failed) break;
        for (int k = 0; k < 3; ++k) {
            c.eye[k] = -(to[4 * k] * to[12] + to[4 * k + 1] * to[13] + to[4 * k + 2] * to[14]);
            c.up[k] = to[4 * k + 1];
            c.target[k] = c.eye[k] - to[4 * k + 2] * about->radius;
        }
        c.fovy = (float)(2 * atan(1 / (double)projection[5]) * 180 / PI);
        c.ortho_height = 0;
        c.znear = projection[14] / (projection[10] - 1);
        c.zfar = 0;                         /* the sphere is of what is seen: behind it the scene goes on */
        c.depth = KIT_DEPTH_NORMAL;
        c.shift[0] = c.shift[1] = 0;
        c.width = c.height = size;
        failed = kit_gbuffer_from_scene(g, m->world->scene, &c, NULL, m->err) || kit_gbuffer_peel(g, m->world->scene, layers, m->err) ||
                 view_of(&view, g->projection, KIT_DEPTH_NORMAL, size, size, m->err);
        if (failed) break;
        run->views = v + 1;
        kit_camera_matrices(&g->camera, to, projection);
        ssgi_gl_views_set(&run->cameras, v, &view, picture, to, NULL);
        frame = run->frame;
        ssgi_gl_frame_init(&frame, &view, run->frame.radius, NULL);
        frame.offset = run->frame.offset;
        frame.thickness = run->frame.thickness;
        frame.fade = run->frame.fade;
        frame.steepest = run->frame.steepest;
        frame.lights = run->frame.lights;
        ssgi_gl_harmonics_set(&frame, run->harmonics, m->gather.bands, to, NULL);
        rotation_of(frame.rotation, to, NULL);
        run->extra[2 * v] = frame;
        rotation_of(frame.rotation, picture, to);
        run->extra[2 * v + 1] = frame;
        for (int j = 0; j < layers && !failed; ++j) {
            float *out = depth + texels * (size_t)(v * layers + j);
            if (j ? kit_texture_slice_read(g->layer_depth, j - 1, size, size, 1, out) : kit_texture_read(g->depth, size, size, 1, out))
                failed = kit_fail(m->err, "%s cannot read the extra cameras' depth back", kit_gl_name());
        }
    }
    if (!failed) run->view_depth = keep(run, kit_texture_array(size, size, m->gather.views * layers, GL_DEPTH_COMPONENT32F, depth));
    free(depth);
    return failed ? -1 : 0;
}

typedef struct lamp { ssgi_gl_light light; kit_camera camera; int mapped; } lamp;     /* in the world; camera: of its map */

static void look(kit_camera *c, const float eye[3], const float along[3], float fovy, float height, float znear, float zfar, int size)
{
    memset(c, 0, sizeof *c);
    for (int k = 0; k < 3; ++k) { c->eye[k] = eye[k]; c->target[k] = eye[k] + along[k]; }
    c->up[fabsf(along[1]) < 0.9f * sqrtf(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]) ? 1 : 0] = 1;
    c->fovy = fovy;
    c->ortho_height = height;
    c->znear = znear;
    c->zfar = zfar;
    c->width = c->height = size;
}

/* A sun's map looks at the sphere of what is seen, from beyond all that could shadow it. */
static lamp sun(const float at[3], const float colour[3], const kit_scene *scene, const sphere *all, int size)
{
    lamp l;
    float eye[3], along[3], nearest = 1e30f, farthest = -1e30f;
    memset(&l, 0, sizeof l);
    memcpy(l.light.at, at, sizeof l.light.at);
    memcpy(l.light.colour, colour, sizeof l.light.colour);
    l.light.kind = SSGI_GL_SUN;
    if (!scene) return l;
    for (int i = 0; i < 8; ++i) {
        float t = 0;
        for (int k = 0; k < 3; ++k) t += ((i >> k & 1 ? scene->mesh.upper[k] : scene->mesh.lower[k]) - all->centre[k]) * at[k];
        nearest = fminf(nearest, t);
        farthest = fmaxf(farthest, t);
    }
    const float margin = 0.01f * (farthest - nearest) + 1e-6f;
    for (int k = 0; k < 3; ++k) { eye[k] = all->centre[k] + at[k] * (farthest + 2 * margin); along[k] = -at[k]; }
    look(&l.camera, eye, along, 0, 2 * all->radius, margin, farthest - nearest + 3 * margin, size);
    l.mapped = 1;
    return l;
}

/* All lights of the world as lamps: --light, the environment's suns, virtual point lights (which the caller counts apart). NULL on failure. */
static lamp *lamps_new(making *m, const sphere *all, int *count, int *direct)
{
    static const float face[6][3] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
    const kit_lighting *lighting = m->world->lighting;
    const kit_scene *scene = m->world->scene;
    const int suns = (int)kit_method_value(m->method, "suns"), vpls = (int)kit_method_value(m->method, "vpls"), mapped = scene && (m->lights.shadow == SSGI_GL_SHADOW_MAP || m->lights.shadow == SSGI_GL_SHADOW_FILL);
    const size_t room = (size_t)(6 * lighting->lights + suns + vpls + 1);
    int size = (int)kit_method_value(m->method, "shadow_size"), n = 0;
    lamp *lamps = calloc(room, sizeof *lamps);
    const char *why = "";
    float extent = 0;
    while (size > 16 && (double)size * ceil(sqrt((double)room)) > 8192) size /= 2;
    if (!lamps) { kit_fail(m->err, "no memory for %d lights", (int)room); return NULL; }
    for (int k = 0; scene && k < 3; ++k) extent += scene->mesh.upper[k] - scene->mesh.lower[k];
    for (int i = 0; i < lighting->lights; ++i) {
        const kit_light *w = &lighting->light[i];
        if (w->kind == KIT_SUN) lamps[n++] = sun(w->at, w->colour, mapped ? scene : NULL, all, size);
        for (int f = 0; w->kind == KIT_POINT && f < (mapped ? 6 : 1); ++f) {
            lamp *l = &lamps[n++];
            memcpy(l->light.at, w->at, sizeof l->light.at);
            memcpy(l->light.colour, w->colour, sizeof l->light.colour);
            l->light.kind = mapped ? SSGI_GL_SPOT : SSGI_GL_POINT;
            l->mapped = mapped;
            look(&l->camera, w->at, face[f], 90, 0, 1e-3f * all->radius, extent, size);
        }
    }
    if (suns && lighting->env.data) {
        ssgi_sun *found = malloc((size_t)suns * sizeof *found);
        if (!found || ssgi_environment_suns(found, suns, m->run->equirect, lighting->env.width, lighting->env.height, &why) != SSGI_OK) { kit_fail(m->err, "suns: %s", why); free(found); free(lamps); return NULL; }
        for (int i = 0; i < suns; ++i) lamps[n++] = sun(found[i].direction, found[i].irradiance, mapped ? scene : NULL, all, size);
        free(found);
    }
    *direct = n;
    if (vpls) {
        float *position, *normal, *flux;
        size_t pixels;
        ssgi_vpl *found = malloc((size_t)vpls * sizeof *found);
        int failed;
        if (!scene || !lighting->lights || !found) { kit_fail(m->err, "--set vpls=%d: needs a scene and a --light", vpls); free(found); free(lamps); return NULL; }
        if (kit_rsm(&position, &normal, &flux, &pixels, scene, &lighting->light[0], 256, m->err)) { free(found); free(lamps); return NULL; }
        failed = ssgi_vpl_choose(found, vpls, position, normal, flux, pixels, &why) != SSGI_OK;
        free(position);
        free(normal);
        free(flux);
        if (failed) { kit_fail(m->err, "vpls: %s", why); free(found); free(lamps); return NULL; }
        for (int i = 0; i < vpls; ++i) {
            lamp *l = &lamps[n++];
            memcpy(l->light.at, found[i].position, sizeof l->light.at);
            memcpy(l->light.normal, found[i].normal, sizeof l->light.normal);
            memcpy(l->light.colour, found[i].intensity, sizeof l->light.colour);
            l->light.kind = SSGI_GL_VPL;
            l->light.least = m->run->frame.radius;
            l->mapped = mapped;
            look(&l->camera, found[i].position, found[i].normal, 150, 0, 2e-3f * all->radius, extent, size);
        }
        free(found);
    }
    *count = n;
    return lamps;
}

/* The lamps' shadow maps, as tiles in the order of the lamps. */
static int add_atlas(making *m, const lamp *lamps, int count)
{
    kit_shadow_camera *camera = malloc((size_t)count * sizeof *camera);
    const int size = count && lamps[0].mapped ? lamps[0].camera.width : 0, columns = size ? 8192 / size < count ? 8192 / size : count : 1;
    int mapped = 0;
    if (!camera) return kit_fail(m->err, "no memory for %d lights", count);
    for (int i = 0; i < count; ++i)
        if (lamps[i].mapped) {
            const int tile[4] = { i % columns * size, i / columns * size, size, size };
            kit_camera_matrices(&lamps[i].camera, camera[mapped].view, camera[mapped].projection);
            memcpy(camera[mapped++].tile, tile, sizeof tile);
        }
    if (mapped) m->run->atlas = keep(m->run, kit_shadow_atlas(columns * size, (count + columns - 1) / columns * size, m->world->scene, camera, mapped, m->err));
    free(camera);
    return mapped && !m->run->atlas ? -1 : 0;
}

/* Lamps first .. last - 1 as a camera has them, one row of t_ssgi_lights each. */
static GLuint rows_of(const lamp *lamps, int first, int last, const float picture[16])
{
    const int size = first < last ? lamps[first].camera.width : 1, columns = size ? (8192 / size < last ? 8192 / size : last) : 1;
    ssgi_gl_light *rows = malloc((size_t)(last - first) * sizeof *rows);
    GLuint texture;
    for (int i = first; rows && i < last; ++i) {
        ssgi_gl_light *l = &rows[i - first];
        *l = lamps[i].light;
        for (int k = 0; k < 3; ++k) {
            l->at[k] = l->normal[k] = l->kind > 0 ? picture[12 + k] : 0;
            if (l->kind > 0) l->normal[k] = 0;
            for (int j = 0; j < 3; ++j) {
                l->at[k] += picture[4 * j + k] * lamps[i].light.at[j];
                l->normal[k] += picture[4 * j + k] * lamps[i].light.normal[j];
            }
        }
        if (lamps[i].mapped) {
            float view[16], projection[16];
            ssgi_view decoded;
            kit_camera_matrices(&lamps[i].camera, view, projection);
            ssgi_view_from_projection(&decoded, projection, SSGI_CLIP_GL, size, size, NULL);
            ssgi_gl_light_map(l, &decoded, i % columns * size, i / columns * size, picture, view, NULL);
        }
    }
    texture = rows ? kit_texture(8, last - first, GL_RGBA32F, &rows[0].at[0]) : 0;
    free(rows);
    return texture;
}

/* ---- >>open ----------------------------------------------------------------------------------------------------- */

/* size * size texels of three floats, as four */
static float *rgba(float *four, const float *map, int size)
{
    for (int i = 0; i < size * size; ++i) {
        memcpy(four + 4 * i, map + 3 * i, 3 * sizeof *map);
        four[4 * i + 3] = 1;
    }
    return four;
}

/* The environment as the passes read it: harmonics, a map over a direction's solid angle, irradiance (and, behind it, light over cones). */
static int add_environment(making *m)
{
    enum { SIZE = 64, OPEN = 32, CONES = 8 };
    const kit_image *env = &m->world->lighting->env;
    const size_t pixels = (size_t)env->width * (size_t)env->height;
    const int s3ho = m->gather.pass == SSGI_GL_S3HO, cones = s3ho && m->shade.shading, mapped = !s3ho && m->gather.environment == SSGI_GL_ENVIRONMENT_MAP;
    const int slices = m->shade.shading == SSGI_GL_SHADING_BENT_CONE ? CONES : 1, open_too = mapped || cones;
    kit_run *run = m->run;
    const char *why = "out of memory";
    float *map = malloc(3 * SIZE * SIZE * sizeof *map), *four = malloc(4 * SIZE * SIZE * sizeof *four), *open = malloc(4 * CONES * OPEN * OPEN * sizeof *open);
    int failed;
    run->equirect = malloc(3 * pixels * sizeof *run->equirect);
    failed = !map || !four || !open || !run->equirect;
    for (size_t i = 0; !failed && i < 3 * pixels; ++i) run->equirect[i] = env->data[i % 3 * pixels + i / 3];
    if (!failed && ((s3ho && !cones) || m->gather.environment == SSGI_GL_ENVIRONMENT_SH))
        failed = ssgi_sh_project_equirect(run->harmonics, m->gather.bands, run->equirect, env->width, env->height, &why) != SSGI_OK
                 || (kit_method_value(m->method, "dering") > 0 && ssgi_sh_dering(run->harmonics, m->gather.bands, NULL, &why) != SSGI_OK);
    if (!failed && mapped)
        failed = ssgi_environment_map(map, SIZE, run->equirect, env->width, env->height, m->gather.samples ? (float)(2 * PI / m->gather.samples) : (float)PI * run->frame.epsilon /* of surfels at the end of a shell */, &why) != SSGI_OK
                 || !(run->environment = keep(run, kit_texture(SIZE, SIZE, GL_RGBA32F, rgba(four, map, SIZE))));
    for (int k = 0; k < slices && !failed && open_too; ++k) {
        failed = ssgi_environment_cone(map, OPEN, run->equirect, env->width, env->height, (float)k / (float)slices, &why) != SSGI_OK;
        rgba(open + 4 * k * OPEN * OPEN, map, OPEN);
    }
    if (!failed && open_too) failed = !(run->irradiance = keep(run, kit_texture_array(OPEN, OPEN, slices, GL_RGBA32F, open)));
    free(map);
    free(four);
    free(open);
    return failed ? kit_fail(m->err, "--env: %s", why) : 0;
}

/* From the settings: the passes' descs, and what of the frame they set. */
static void settings(making *m, float radius)
{
    ssgi_gl_desc *to[3] = { &m->gather, &m->lights, &m->blur };
    for (int i = 0; i < m->method->count; ++i) {
        const row *w = m->plan->rows[i];
        const double v = m->method->setting[i].value;
        const int whole = (int)v;
        const float real = (float)(w->where == SCALED ? v * (double)radius : v);
        for (int k = 0; k < 3; ++k) if (w->where & 1 << k) memcpy((char *)to[k] + w->offset, &whole, sizeof whole);
        if (w->where & (FRAME | SCALED)) memcpy((char *)&m->run->frame + w->offset, &real, sizeof real);
    }
    m->blurred = (int)kit_method_value(m->method, "blur");
    m->blur.filter_radius = m->blurred;
    m->gather.kernel = kit_method_value(m->method, "sets") > 0;
    m->lights.thin = !(kit_method_value(m->method, "solid") > 0);
    if (m->gather.pass == SSGI_GL_S3HO) {
        const int bent = !m->gather.bands;
        if (bent) {
            m->gather.bands = 2;
            m->shade.shading = kit_method_value(m->method, "cone") > 0 ? SSGI_GL_SHADING_BENT_CONE : SSGI_GL_SHADING_BENT_NORMAL;
        }
        m->gather.packed = (int)kit_method_value(m->method, "store") == 1;
        m->shade.bands = m->blur.bands = m->gather.bands;
        m->shade.half = m->gather.half && kit_method_value(m->method, "filtered") > 0;
        m->shade.exact = m->gather.exact;
        m->shade.normal = m->gather.normal;
        if (!(kit_method_value(m->method, "lights") > 0)) m->lights.shadow = SSGI_GL_SHADOW_NONE;
    }
    if (kit_method_value(m->method, "normal") > 0) m->gather.normal = m->lights.normal = m->blur.normal = SSGI_GL_NORMAL_FROM_DEPTH;
}

/* s3ho: a vector a pixel, or one a channel, met with the light; *light: what comes out. When nothing else wants the vectors, the gather meets it itself. aside: see kit_pass. */
static int add_vectors(making *m, int transfer, int aside, GLuint *light)
{
    kit_run *run = m->run;
    const int vectors = !(kit_method_value(m->method, "filtered") > 0), first = run->passes;
    ssgi_gl_desc gather = m->gather, blur = m->blur, shade = m->shade;
    const double fetches = run->fetches;
    kit_pass *p;
    gather.transfer = blur.transfer = shade.transfer = transfer;
    gather.packed = blur.packed = shade.packed = m->gather.packed || transfer || aside;      /* parts are told apart after the same rounding */
    gather.shaded = !vectors && !shade.shading && !shade.lamps;
    blur.colour = SSGI_GL_VECTORS;
    p = add_pass(m, &gather, run->gbuffer, 0, 0, 0, 0);
    if (p && vectors && m->blurred && (p = add_pass(m, &blur, run->gbuffer, 0, 0, 0, 0))) p->vectors = run->passes - 2;
    if (p && !gather.shaded && (p = add_pass(m, &shade, run->gbuffer, 0, 0, 0, 0))) p->vectors = run->passes - 2;
    if (!p) return -1;
    p->lights = m->rows[0];
    *light = p->target[0];
    if (!vectors && add_blur(m, light)) return -1;
    if (aside) run->fetches = fetches;
    for (int i = first; i < run->passes; ++i) run->pass[i].aside = aside;
    return 0;
}

/* s3ho: suns as lobes of the environment's harmonics; the lamps that are left, which depend on where a pixel is, to the front; and what all of those harmonics lack. */
static int add_harmonics(making *m, lamp *lamps, int *count)
{
    enum { OPEN = 32 };
    const kit_image *env = &m->world->lighting->env;
    const int window = (int)kit_method_value(m->method, "window"), bands = m->gather.bands;
    kit_run *run = m->run;
    const char *why = "out of memory";
    ssgi_sun suns[KIT_MAX_LIGHTS];
    float *map = calloc(3 * OPEN * OPEN, sizeof *map), *four = malloc(4 * OPEN * OPEN * sizeof *four);
    int left = 0, n = 0, failed = !map || !four;
    for (int i = 0; i < *count && !failed; ++i) {
        const ssgi_gl_light *l = &lamps[i].light;
        if (l->kind > 0 || m->shade.shading) { lamps[left++] = lamps[i]; continue; }
        memcpy(suns[n].direction, l->at, sizeof suns[n].direction);
        memcpy(suns[n].irradiance, l->colour, sizeof suns[n].irradiance);
        failed = ssgi_sh_light(run->harmonics, bands, l->at, 0, suns[n++].irradiance, window, &why) != SSGI_OK;
    }
    *count = left;
    memset(run->frame.window, 0, sizeof run->frame.window);
    ssgi_sh_window(run->frame.window, bands, window);
    if (m->gather.exact && !m->shade.shading && !failed)
        failed = (env->data && ssgi_environment_map(map, OPEN, run->equirect, env->width, env->height, 0, &why) != SSGI_OK)
                 || ssgi_sh_lacking(map, OPEN, run->harmonics, bands, suns, n, &why) != SSGI_OK || !(run->irradiance = keep(run, kit_texture_array(OPEN, OPEN, 1, GL_RGBA32F, rgba(four, map, OPEN))));
    free(map);
    free(four);
    return failed ? kit_fail(m->err, "harmonics: %s", why) : 0;
}

static int open_lit(making *m, const float picture[16])
{
    static const int environments[] = { SSGI_GL_ENVIRONMENT_MAP, SSGI_GL_ENVIRONMENT_SH, SSGI_GL_ENVIRONMENT_NONE };
    static const kit_lighting dark;
    kit_run *run = m->run;
    kit_gbuffer *g = run->gbuffer;
    const int suns = (int)kit_method_value(m->method, "suns"), vpls = (int)kit_method_value(m->method, "vpls"), s3ho = m->gather.pass == SSGI_GL_S3HO;
    const int indirect = (int)kit_method_value(m->method, "indirect"), bounce = s3ho ? indirect : m->gather.bounce, harmonics = s3ho && !(kit_method_value(m->method, "lights") > 0);
    const kit_lighting *lighting = m->world->lighting ? m->world->lighting : &dark;
    const kit_world world = { m->world->scene, lighting };
    int count = 0, direct = 0, failed;
    sphere all, middle;
    lamp *lamps;
    GLuint light = 0, received = 0;
    m->world = &world;
    m->blur.colour = SSGI_GL_COLOUR;
    if (!lighting->env.data) m->shade.shading = SSGI_GL_SHADING_HARMONICS;
    m->gather.environment = lighting->env.data && !suns ? environments[(int)kit_method_value(m->method, "environment")] : SSGI_GL_ENVIRONMENT_NONE;
    if (lighting->env.data && add_environment(m)) return -1;
    rotation_of(run->frame.rotation, picture, NULL);
    if (seen(g, &all, &middle, m->err)) return -1;
    lamps = lamps_new(m, &all, &count, &direct);
    if (!lamps) return -1;
    if (s3ho) {
        int lobes = harmonics ? direct : 0;
        if (add_harmonics(m, lamps, &lobes)) { free(lamps); return -1; }
        if (harmonics) count = direct = lobes;
        m->shade.lamps = lobes > 0;
    }
    ssgi_gl_harmonics_set(&run->frame, run->harmonics, m->gather.bands, picture, NULL);
    run->frame.lights = direct;
    failed = (m->gather.views && add_views(m, picture, &middle)) || add_atlas(m, lamps, count);
    for (int v = -1; v < run->views && direct && !failed; ++v) {
        float to[16], projection[16];
        if (v >= 0) kit_camera_matrices(&run->view[v].camera, to, projection);
        m->rows[1 + v] = keep(run, rows_of(lamps, 0, direct, v < 0 ? picture : to));
        failed = !m->rows[1 + v] && kit_fail(m->err, "no memory for %d lights", direct);
    }
    if (!failed && !g->albedo) {                     /* the grey of meshes without a material */
        const size_t texels = (size_t)g->width * (size_t)g->height;
        float *grey = malloc(4 * texels * sizeof *grey);
        for (size_t i = 0; grey && i < 4 * texels; ++i) grey[i] = 0.8f;
        run->grey = keep(run, grey ? kit_texture(g->width, g->height, GL_RGBA16F, grey) : 0);
        free(grey);
    }
    if (!failed && bounce) {
        run->senders = keep(run, kit_texture_array(g->viewport[2], g->viewport[3], m->gather.layers, GL_RG32UI, NULL));
        if (run->views) run->view_senders = keep(run, kit_texture_array(run->view[0].width, run->view[0].height, run->views * m->gather.view_layers, GL_RG32UI, NULL));
    }
    for (int v = 0; v < run->views && bounce && !failed; ++v)           /* hidden senders: lit in their own camera's picture */
        for (int j = 0; j < m->gather.view_layers && !failed; ++j)
            failed = (!s3ho && add_direct(m, &run->view[v], v, j, &light)) || ((s3ho || light) && add_senders(m, &run->view[v], v, j, light));
    for (int j = m->gather.layers - 1; j > 0 && bounce && !failed; --j)
        failed = (!s3ho && add_direct(m, g, -1, j, &light)) || ((s3ho || light) && add_senders(m, g, -1, j, light));
    if (!failed && s3ho) {
        ssgi_gl_desc d = m->lights;
        kit_pass *p;
        failed = (bounce && add_senders(m, g, -1, 0, 0)) || add_vectors(m, SSGI_GL_TRANSFER_FREE, indirect == 1, &light);
        if (!failed && bounce) failed = add_vectors(m, indirect == 1 ? SSGI_GL_TRANSFER_BOTH : SSGI_GL_TRANSFER_REFLECTED, 0, &received);
        if (indirect == 1) run->joint = light;
        if (!failed && !harmonics && m->rows[0]) {
            d.accumulate = 1;
            p = add_pass(m, &d, g, 0, light, 0, 0);
            failed = !p;
            if (p) { p->lights = m->rows[0]; light = p->target[0]; }
        }
    } else if (!failed && bounce && m->gather.environment && kit_method_value(m->method, "reuse") > 0) {
        kit_pass *p, *senders;
        failed = add_senders(m, g, -1, 0, 1);        /* its source is set below */
        senders = &run->pass[run->passes - 1];
        p = failed ? NULL : add_pass(m, &m->gather, g, 0, 0, 0, 0);
        failed = !p;
        light = p ? p->target[0] : 0;
        received = p ? p->target[1] : 0;
        failed = failed || add_blur(m, &light) || add_blur(m, &received);
        if (!failed && m->rows[0]) {
            ssgi_gl_desc d = m->lights;
            d.accumulate = 1;
            p = add_pass(m, &d, g, 0, light, 0, 0);
            failed = !p;
            if (p) { p->lights = m->rows[0]; light = p->target[0]; }
        }
        senders->source = light;
    } else if (!failed) {
        failed = add_direct(m, g, -1, 0, &light);
        if (!failed && bounce && (light || g->direct)) {
            ssgi_gl_desc d = m->gather;
            kit_pass *p;
            d.environment = SSGI_GL_ENVIRONMENT_NONE;
            if (vpls) {                     /* what the clamp of the virtual point lights leaves out: just that falloff, of single points */
                d.falloff = SSGI_GL_FALLOFF_SQUARE;
                d.fade = d.range = 0;
                d.samples = d.samples * d.steps < 64 ? d.samples * d.steps : 64;
                d.steps = 1;
            }
            failed = add_senders(m, g, -1, 0, light);
            p = failed ? NULL : add_pass(m, &d, g, 0, 0, 0, 0);
            failed = !p;
            if (p) received = p->target[0];
            failed = failed || add_blur(m, &received);
        }
    }
    if (!failed && vpls) {
        ssgi_gl_desc d = m->lights;
        kit_pass *p;
        d.accumulate = received != 0;
        p = add_pass(m, &d, g, KIT_FRAME_VPLS, received, 0, 0);
        failed = !p;
        if (p) {
            p->lights = keep(run, rows_of(lamps, direct, count, picture));
            received = p->target[0];
        }
        run->vpls = count - direct;
    }
    free(lamps);
    run->light = light;
    run->bounce = received;
    return failed ? -1 : 0;
}

/* Casters first .. last - 1 of the rows in one draw. */
static int add_casters(making *m, const ssgi_gl_caster *rows, int first, int last, const GLuint *cube)
{
    kit_run *run = m->run;
    const GLuint rows_texture = keep(run, kit_texture(10, last > first ? last - first : 1, GL_RGBA32F, rows[first].at));
    kit_pass *p = add_pass(m, &m->gather, run->gbuffer, 0, 0, 0, 0);
    if (!p) return -1;
    p->lights = rows_texture;
    p->instances = last - first;
    if (cube) memcpy(p->cube, cube, sizeof p->cube);
    run->light = p->target[0];
    return rows_texture ? 0 : kit_fail(m->err, "no memory for %d casters", last - first);
}

/* The casting objects' fields, and where they stand. */
static int open_field(making *m, const float picture[16])
{
    const kit_scene *scene = m->world->scene;
    const int all = kit_method_value(m->method, "casters") > 0, each = kit_method_value(m->method, "draw") > 0;
    kit_run *run = m->run;
    ssgi_field_desc d;
    const ssgi_field **field;
    int *slice, fields = 0, count = 0, failed = 0;
    ssgi_gl_caster *rows;
    const char *why = "";
    if (!scene) return kit_fail(m->err, "method aof: a frame has no objects to bake; it needs a scene");
    d = kit_method_field(m->method);
    if (kit_method_value(m->method, "own") <= 0 && run->gbuffer->object) m->gather.objects = SSGI_GL_OBJECTS_TEXTURE;
    field = malloc((size_t)(scene->shapes + 1) * sizeof *field);
    slice = malloc((size_t)(scene->shapes + 1) * sizeof *slice);
    rows = calloc((size_t)(scene->objects + 1), sizeof *rows);
    if (!field || !slice || !rows) failed = kit_fail(m->err, "no memory for %d objects", scene->objects);
    for (int s = 0; s < scene->shapes && !failed; ++s) {       /* rows come shape after shape */
        const int first = count;
        slice[s] = -1;
        for (int i = 0; i < scene->objects && !failed; ++i) {
            const kit_object *o = &scene->object[i];
            float to_view[16];
            ssgi_field_limits limits;
            if (o->shape != s || !(all || o->casts)) continue;
            if (slice[s] < 0) {
                slice[s] = fields;
                field[fields] = kit_field(&scene->shape[s], &d, NULL, m->err);
                if (!field[fields]) { failed = -1; break; }
                run->field_bytes += ssgi_field_size(field[fields]->resolution, field[fields]->bits);
                ++fields;
            }
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 4; ++r) {
                    to_view[4 * c + r] = 0;
                    for (int k = 0; k < 4; ++k) to_view[4 * c + r] += picture[4 * k + r] * o->to_world[4 * c + k];
                }
            limits = ssgi_field_limits_of(field[slice[s]]);
            limits.ramp = (float)kit_method_value(m->method, "ramp") * limits.reach;
            limits.power = (float)kit_method_value(m->method, "power");
            if (kit_method_value(m->method, "inside") >= 0) limits.inside = (float)kit_method_value(m->method, "inside");
            if (ssgi_gl_caster_set(&rows[count++], field[slice[s]], &limits, to_view, slice[s], i + 1, &why) != SSGI_OK) failed = kit_fail(m->err, "object %s: %s", o->name, why);
        }
        if (failed || first == count) continue;
        if (m->gather.storage) {
            GLuint cube[2];
            if (!kit_field_cubes(cube, field[slice[s]])) failed = kit_fail(m->err, "--set storage=cube: %s has no cube maps of %d bits", kit_gl_name(), d.bits);
            for (int k = 0; k < 2; ++k) keep(run, cube[k]);
            for (int i = first; i < count && !failed; i += each ? 1 : count - first) failed = add_casters(m, rows, i, each ? i + 1 : count, cube);
        }
    }
    if (!failed && !count) failed = add_casters(m, rows, 0, 0, NULL);
    if (!failed && count && !m->gather.storage) {
        run->fields = keep(run, kit_field_atlas(field, fields));
        if (!run->fields) failed = kit_fail(m->err, "no memory for %d fields", fields);
        for (int i = 0; i < count && !failed; i += each ? 1 : count) failed = add_casters(m, rows, i, each ? i + 1 : count, NULL);
    }
    if (!failed && m->gather.cap) {
        const int size = (int)kit_method_value(m->method, "table_size");
        float *table = malloc((size_t)size * (size_t)size * sizeof *table);
        if (table) ssgi_cap_table(table, size, NULL);
        run->cap = keep(run, table ? kit_texture(size, size, GL_R16F, table) : 0);
        glBindTexture(GL_TEXTURE_2D, run->cap);
        kit_texture_linear(GL_TEXTURE_2D);
        free(table);
    }
    run->casters = count;
    free(field);
    free(slice);
    free(rows);
    return failed ? -1 : 0;
}

/* ---- >>deep: surfels, and the passes that splat them ------------------------------------------------------------------- */

/* A vertex array of vec3 or vec4 attributes, interleaved. */
static GLuint array_of(GLuint buffer, int attributes, int components, GLuint divisor)
{
    GLuint array;
    GLint was;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &was);
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    for (GLuint i = 0; i < (GLuint)attributes; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, components, GL_FLOAT, GL_FALSE, attributes * components * 4, (const void *)(size_t)(i * (GLuint)components * 4));
        glVertexAttribDivisor(i, divisor);
    }
    glBindVertexArray((GLuint)was);
    return array;
}

static GLuint buffer_of(const void *data, size_t size)
{
    GLuint buffer;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)size, data, GL_STATIC_DRAW);
    return buffer;
}

/* The scene's triangles for patches, 9 floats a vertex, huge ones divided: small ones first, then those that ask for splits. NULL: no memory. */
static float *patches_of(const kit_scene *scene, const ssgi_surfel_desc *d, const ssgi_view *view, const float picture[16], int grey, int patches[2])
{
    const kit_mesh *mesh = &scene->mesh;
    const ssgi_splat splat = { 0 };
    ssgi_surfel_source source = { .position = mesh->position, .normal = mesh->normal, .triangles = mesh->triangles };
    float *colour = malloc((9 * mesh->triangles + 1) * sizeof *colour), *divided = NULL, *sorted = NULL;
    size_t count = 0, n[2] = { 0, 0 };
    for (size_t i = 0; colour && i < 9 * mesh->triangles; ++i) colour[i] = grey ? 1 : mesh->albedo[i / 9 * 3 + i % 3];
    source.colour = colour;
    memcpy(source.to_view, picture, sizeof source.to_view);
    if (colour && ssgi_surfels_divide(NULL, 0, &count, d, view, &source, NULL) == SSGI_OK) {
        divided = malloc((27 * count + 1) * sizeof *divided);
        sorted = malloc((27 * count + 1) * sizeof *sorted);
        if (divided) ssgi_surfels_divide(divided, count, &count, d, view, &source, NULL);
    }
    for (size_t t = 0; t < count && divided && sorted; ++t) {      /* large ones from the end on */
        ssgi_surfel_cost cost = { 0 };
        ssgi_surfel_source one = { .position = divided + 27 * t, .position_stride = 36, .triangles = 1 };
        memcpy(one.to_view, picture, sizeof one.to_view);
        ssgi_surfels_predict(&cost, d, &splat, view, &one, NULL);
        const int large = cost.splits > 1;
        memcpy(sorted + 27 * (large ? count - ++n[1] : n[0]++), divided + 27 * t, 27 * sizeof *sorted);
    }
    for (int k = 0; k < 2; ++k) patches[k] = (int)n[k];
    if (!divided) { free(sorted); sorted = NULL; }
    free(divided);
    free(colour);
    return sorted;
}

/* splat .. sum of one effect; *out: what comes out. */
static int add_splats(making *m, const kit_pass *from, int effect, GLuint *out)
{
    kit_run *run = m->run;
    ssgi_gl_desc d = m->gather;
    kit_pass *p;
    GLuint levels;
    d.effect = effect;
    if (effect == SSGI_GL_EFFECT_OCCLUSION || effect == SSGI_GL_EFFECT_LIGHT) d.sends = SSGI_GL_SENDS_COLOUR;
    p = add_pass(m, &d, run->gbuffer, 0, 0, 0, 0);
    if (!p) return -1;
    p->lights = m->rows[0];
    p->array = from->array;
    memcpy(p->patches, from->patches, sizeof p->patches);
    p->splits = from->splits;
    levels = p->target[0];
    for (int i = SSGI_GL_UNSHUFFLE; i <= SSGI_GL_SUM; ++i)
        for (d.axis = 0; d.axis < (i == SSGI_GL_SMOOTH ? 2 : 1); ++d.axis) {
            if (i == SSGI_GL_SMOOTH && (d.levels < 2 || !(kit_method_value(m->method, "smooth") > 0))) continue;
            d.pass = i;
            p = add_pass(m, &d, run->gbuffer, 0, levels, 0, 0);
            if (!p) return -1;
            levels = p->target[0];
        }
    *out = levels;
    return 0;
}

/* The least depth that the G-buffer shows, a little less; stays where it shows nothing. */
static int nearest_of(float *front, const kit_gbuffer *g, kit_error *err)
{
    kit_image frame;
    float least = INFINITY;
    if (kit_gbuffer_read(&frame, g, err)) return -1;
    const float *z = kit_image_channel(&frame, "Z");
    for (int i = 0; i < frame.width * frame.height; ++i) if (z[i] > 0 && z[i] < least) least = z[i];
    if (least < INFINITY) *front = fmaxf(0.999f * least, *front);
    kit_image_free(&frame);
    return 0;
}

static int open_deep(making *m, const ssgi_view *view, const float picture[16])
{
    static const kit_lighting dark;
    kit_run *run = m->run;
    kit_gbuffer *g = run->gbuffer;
    const kit_scene *scene = m->world->scene;
    const int way = (int)kit_method_value(m->method, "way"), effect = m->gather.effect, lit = effect != SSGI_GL_EFFECT_OCCLUSION;
    const ssgi_surfel_desc d = { (float)kit_method_value(m->method, "size"), (float)kit_method_value(m->method, "jitter"), (int)kit_method_value(m->method, "splits"), (int)kit_method_value(m->method, "shrink"),
                                 fmaxf((float)kit_method_value(m->method, "aside"), 1e-6f), (int)kit_method_value(m->method, "every"), run->frame.radius < 1e17f ? run->frame.radius : 0 };
    ssgi_splat splat = { .epsilon = run->frame.epsilon, .most = run->frame.radius < 1e17f ? run->frame.radius : 0, .levels = m->gather.levels };
    const kit_lighting *lighting = m->world->lighting ? m->world->lighting : &dark;
    const kit_world world = { scene, lighting };
    ssgi_surfel_cost cost;
    kit_pass from = { 0 }, *p;
    const char *why = "";
    float *vertices;
    ssgi_surfel *surfels = NULL;
    int patches[2], failed = 0, direct = 0, lamps_count = 0;
    GLuint light = 0, bounce = 0;
    if (!scene) return kit_fail(m->err, "method %s: a frame has no triangles to make surfels of; it needs a scene", m->method->name);
    if (way && !glPatchParameteri) return kit_fail(m->err, "--set way: %s has no tessellation", kit_gl_name());
    if (ssgi_gl_surfels_set(&run->frame, view, &d, m->gather.levels, picture, &why) != SSGI_OK) return kit_fail(m->err, "%s", why);
    m->world = &world;
    if (kit_method_value(m->method, "front") > 0 && nearest_of(&run->frame.front, g, m->err)) return -1;
    splat.front = run->frame.front;
    if (lit) {
        sphere all, middle;
        lamp *lamps;
        rotation_of(run->frame.rotation, picture, NULL);
        m->gather.environment = SSGI_GL_ENVIRONMENT_MAP;
        if (lighting->env.data && add_environment(m)) return -1;
        if (!lighting->env.data || !(kit_method_value(m->method, "sky") > 0)) m->gather.environment = SSGI_GL_ENVIRONMENT_NONE;      /* of surfels: what splats hide is seen all the same */
        if (seen(g, &all, &middle, m->err)) return -1;
        lamps = lamps_new(m, &all, &lamps_count, &direct);
        if (!lamps) return -1;
        failed = add_atlas(m, lamps, lamps_count);
        m->rows[0] = failed ? 0 : keep(run, direct ? rows_of(lamps, 0, direct, picture) : kit_texture(8, 1, GL_RGBA32F, NULL));
        free(lamps);
        run->frame.lights = direct;
        m->gather.shadow = m->lights.shadow;
        m->gather.sends = SSGI_GL_SENDS_LIGHTS;
        if (failed) return -1;
    }
    vertices = patches_of(scene, &d, view, picture, effect == SSGI_GL_EFFECT_SCATTER, patches);
    for (int pass = 0; pass < 2 && vertices && !failed; ++pass) {           /* counts, then surfels */
        ssgi_surfel_source source = { .position = vertices, .normal = vertices + 3, .colour = vertices + 6, .position_stride = 36, .normal_stride = 36, .colour_stride = 36, .triangles = (size_t)(patches[0] + patches[1]) };
        memcpy(source.to_view, picture, sizeof source.to_view);
        if (pass) surfels = malloc((run->surfels + 1) * sizeof *surfels);
        failed = (pass && !surfels) || ssgi_surfels(surfels, pass ? run->surfels : 0, &run->surfels, &d, view, &source, &why) != SSGI_OK;
    }
    if (!vertices || failed) { free(vertices); free(surfels); return kit_fail(m->err, "surfels: %s", *why ? why : "out of memory"); }
    ssgi_splat_predict(&cost, &splat, view, surfels, run->surfels, NULL);
    for (int l = 0; l < m->gather.levels; ++l) run->splat_pixels += cost.pixels[l];
    run->fetches += run->splat_pixels / ((double)view->width * view->height);
    if (way) run->buffers[0] = buffer_of(vertices, 27 * (size_t)(patches[0] + patches[1]) * sizeof *vertices);
    else run->buffers[0] = buffer_of(surfels, (run->surfels + 1) * sizeof *surfels);
    run->arrays[0] = array_of(run->buffers[0], 3, way ? 3 : 4, way ? 0 : 1);
    if (way == 1 || lit) run->buffers[1] = buffer_of(NULL, (3 * run->surfels + run->surfels / 16 + 1024) * sizeof *surfels);
    free(vertices);
    free(surfels);
    m->gather.tessellate = way > 0;
    if (way) m->gather.dialect = kit_gl_is_es() ? SSGI_GL_320ES : SSGI_GL_410;
    from.array = run->arrays[0];
    if (way) memcpy(from.patches, patches, sizeof patches);
    from.splits = d.splits;
    if (way == 1 || (lit && !way)) {                        /* surfels come out of a pass: from patches, or lit */
        ssgi_gl_desc made = m->gather;
        made.pass = SSGI_GL_SURFELS;
        if (!way) run->arrays[2] = array_of(run->buffers[0], 3, 4, 0);
        p = add_pass(m, &made, g, 0, 0, 0, 0);
        if (!p) return -1;
        p->lights = m->rows[0];
        p->array = way ? run->arrays[0] : run->arrays[2];
        memcpy(p->patches, from.patches, sizeof p->patches);
        p->splits = d.splits;
        p->capture = run->buffers[1];
        run->arrays[1] = from.array = array_of(run->buffers[1], 3, 4, 1);
        from.patches[0] = from.patches[1] = 0;
        m->gather.tessellate = 0;
        if (way) glGenQueries(1, &run->query);
    }
    {
        ssgi_gl_desc shuffle = m->gather;
        shuffle.pass = SSGI_GL_SHUFFLE;
        p = add_pass(m, &shuffle, g, 0, 0, 0, 0);
        if (!p) return -1;
        run->shuffled = p->target[0];
    }
    if (effect == SSGI_GL_EFFECT_LIGHT) {
        if (lighting->env.data && add_splats(m, &from, SSGI_GL_EFFECT_LIGHT, &light)) return -1;
        if (direct) {
            ssgi_gl_desc lights = m->lights;
            lights.accumulate = light != 0;
            p = add_pass(m, &lights, g, 0, light, 0, 0);
            if (!p) return -1;
            p->lights = m->rows[0];
            light = p->target[0];
        }
        if (add_splats(m, &from, SSGI_GL_EFFECT_BOUNCE, &bounce)) return -1;
    } else if (effect == SSGI_GL_EFFECT_SCATTER) {
        const ssgi_material *material = ssgi_material_of((int)kit_method_value(m->method, "material"));
        ssgi_dipole dipole;
        ssgi_dipole_set(&dipole, material->sigma_s, material->sigma_a, material->eta, NULL);
        ssgi_gl_dipole_set(&run->frame, &dipole, (float)kit_method_value(m->method, "unit"), NULL);
        failed = add_splats(m, &from, effect, &light);
    } else failed = add_splats(m, &from, effect, &light);
    run->light = light;
    run->bounce = bounce;
    return failed ? -1 : 0;
}

static GLuint texture_of(const kit_run *run, const kit_pass *p, const char *name)
{
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    for (int i = 0, n = p->vectors < 0 ? 0 : ssgi_gl_reflect(&run->pass[p->vectors].desc, io, SSGI_GL_MAX_IO); i < n; ++i)
        if (io[i].kind == SSGI_GL_OUTPUT && !strcmp(io[i].name + 1, name + 1)) return run->pass[p->vectors].target[io[i].slot];
    const struct { const char *name; GLuint texture; } table[] = {
        { "depth", p->gbuffer->depth }, { "layers", p->gbuffer->layer_depth }, { "views", run->view_depth }, { "normal", p->desc.receiver ? p->gbuffer->layer_normal : p->gbuffer->normal },
        { "albedo", p->desc.receiver ? p->gbuffer->layer_albedo : p->gbuffer->albedo ? p->gbuffer->albedo : run->grey }, { "direct", p->gbuffer->direct }, { "noise", run->noise },
        { "kernel", run->kernel }, { "environment", run->environment }, { "irradiance", run->irradiance }, { "senders", run->senders }, { "view_senders", run->view_senders },
        { "shuffled", run->shuffled }, { "levels", p->source }, { "lights", p->lights }, { "casters", p->lights }, { "fields", run->fields }, { "field", p->cube[0] }, { "field_centre", p->cube[1] }, { "cap", run->cap }, { "objects", p->gbuffer->object }, { "shadow", run->atlas }, { "light", p->source }, { "ao", p->source } };
    for (size_t i = 0; i < sizeof table / sizeof table[0]; ++i) if (!strcmp(name + strlen("t_ssgi_"), table[i].name)) return table[i].texture;
    return 0;
}

static GLenum target_of(const ssgi_gl_io *io) { return strstr(io->type, "2DArray") ? GL_TEXTURE_2D_ARRAY : !strcmp(io->type, "samplerCube") ? GL_TEXTURE_CUBE_MAP : GL_TEXTURE_2D; }

/* Bytes of a texel, and how many texels there are. */
static double texel_of(double *texels, GLuint texture, GLenum target)
{
    static const GLenum bits_of[] = { GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE, GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE };
    const GLenum face = target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target;
    GLint size[3] = { 0 }, bits = 0, all = 0;
    glBindTexture(target, texture);
    for (GLenum i = 0; i < 2; ++i) glGetTexLevelParameteriv(face, 0, GL_TEXTURE_WIDTH + i, &size[i]);
    glGetTexLevelParameteriv(face, 0, GL_TEXTURE_DEPTH, &size[2]);
    for (size_t i = 0; i < sizeof bits_of / sizeof *bits_of; ++i, all += bits) glGetTexLevelParameteriv(face, 0, bits_of[i], &bits);
    glBindTexture(target, 0);
    *texels = (double)size[0] * size[1] * (target == GL_TEXTURE_CUBE_MAP ? 6 : size[2]);
    return all / 8.0;
}

static double bytes_of(const kit_run *run)
{
    double bytes = 0;
    for (int i = 0; i < run->passes; ++i) {
        const kit_pass *p = &run->pass[i];
        const int splats = p->desc.pass == SSGI_GL_SPLAT;
        ssgi_gl_io io[SSGI_GL_MAX_IO];
        for (int k = 0, n = p->aside ? 0 : ssgi_gl_reflect(&p->desc, io, SSGI_GL_MAX_IO); k < n; ++k) {
            const int in = io[k].kind == SSGI_GL_TEXTURE;
            const GLuint texture = in ? texture_of(run, p, io[k].name) : p->target[0] ? p->target[io[k].slot] : run->senders;      /* without targets of its own it draws into a slice */
            const kit_gbuffer *g = p->gbuffer;
            const int slices = texture == g->layer_depth ? p->desc.layers - 1 : texture == g->layer_normal || texture == g->layer_albedo;      /* of the G-buffer's farther layers */
            double texels, texel;
            if ((!in && (io[k].kind != SSGI_GL_OUTPUT || !p->framebuffer)) || !texture) continue;
            texel = texel_of(&texels, texture, in ? target_of(&io[k]) : p->target[0] ? GL_TEXTURE_2D : GL_TEXTURE_2D_ARRAY);
            if (slices) texels *= (double)slices / (g->layers - 1);
            if (!in) texels = splats ? 2 * run->splat_pixels : (double)p->width * p->height;
            bytes += texel * texels;
        }
        if (splats || p->capture) bytes += (double)run->surfels * sizeof(ssgi_surfel);
    }
    return bytes / ((double)run->frame.size[0] * run->frame.size[1]);
}

int kit_run_open(kit_run *run, kit_gbuffer *g, const kit_method *method, float radius, const kit_world *world, kit_error *err)
{
    static const kit_world nothing;
    making m = { .run = run, .method = method, .world = world ? world : &nothing, .err = err };
    ssgi_view view;
    const char *why = "";
    float picture[16], projection[16];
    int failed;
    memset(run, 0, sizeof *run);           /* in place: passes point at its extra cameras */
    for (int i = 0; i < PLANS; ++i) if (!strcmp(plans[i].name, method->name)) m.plan = &plans[i];
    if (!m.plan) return kit_fail(err, "method %s: there is none of that name", method->name);
    if (view_of(&view, g->projection, g->camera.depth, g->viewport[2], g->viewport[3], err)) return -1;
    if (ssgi_gl_frame_init(&run->frame, &view, radius, &why) != SSGI_OK) return kit_fail(err, "%s", why);
    run->gbuffer = g;
    run->lit = method->lit;
    run->frame.origin[0] = g->viewport[0];
    run->frame.origin[1] = g->viewport[1];
    m.gather.pass = m.plan->pass;
    if (m.plan->pass == SSGI_GL_SPLAT) m.gather.effect = m.plan->search; else m.gather.search = m.plan->search;
    m.gather.dialect = kit_dialect();
    m.gather.orthographic = view.orthographic;
    m.gather.depth = g->depth_is_linear ? SSGI_GL_DEPTH_LINEAR : SSGI_GL_DEPTH_WINDOW;
    m.lights = m.blur = m.gather;
    m.lights.pass = SSGI_GL_LIGHTS;
    m.blur.pass = SSGI_GL_BLUR;
    m.shade = m.blur;
    m.shade.pass = SSGI_GL_SHADE;
    settings(&m, radius);
    if (m.gather.half && !m.blurred) return kit_fail(err, "--set half=1: needs blur=1 or more, which brings it to full size");
    if (m.gather.layers > g->layers && !m.world->scene) return kit_fail(err, "--set layers=%d: the frame has %d", m.gather.layers, g->layers);
    if (m.gather.views && !m.world->scene) return kit_fail(err, "--set views=%d: a frame has one camera; extra ones need a scene", m.gather.views);
    if (m.gather.layers > g->layers && kit_gbuffer_peel(g, m.world->scene, m.gather.layers, err)) return -1;
    kit_camera_matrices(&g->camera, picture, projection);
    if (run->lit && m.gather.pass != SSGI_GL_SPLAT) {
        failed = open_lit(&m, picture);
    } else if (m.gather.pass == SSGI_GL_FIELD) {
        failed = open_field(&m, picture);
    } else if (m.gather.pass == SSGI_GL_SPLAT) {
        failed = open_deep(&m, &view, picture);
    } else {
        kit_pass *p;
        sphere all, middle;
        failed = m.gather.views && (seen(g, &all, &middle, err) || add_views(&m, picture, &middle));
        p = failed ? NULL : add_pass(&m, &m.gather, g, 0, 0, 0, 0);
        failed = !p;
        if (p) run->light = p->target[0];
        failed = failed || add_blur(&m, &run->light);
    }
    if (m.gather.kernel) {
        const int sets = (int)kit_method_value(method, "sets");
        float *kernel = malloc(4 * (size_t)(sets * m.gather.samples) * sizeof *kernel);
        if (kernel) ssgi_kernel(kernel, sets, m.gather.samples, NULL);
        run->kernel = keep(run, kernel ? kit_texture(m.gather.samples, sets, GL_RGBA32F, kernel) : 0);
        free(kernel);
    }
    if (m.gather.noise == SSGI_GL_NOISE_TEXTURE) {
        float tile[4 * 16];
        ssgi_jitter_tile(tile, 4, m.gather.directions ? m.gather.directions : 1, NULL);
        run->noise = keep(run, kit_texture(4, 4, GL_RGBA32F, tile));
    }
    run->bytes = !failed && glGetTexLevelParameteriv ? bytes_of(run) : (double)NAN;
    glGenBuffers(KIT_FRAMES, run->block);
    if (!failed) kit_run_update(run);
    if (!failed && kit_method_value(method, "reuse") > 0) for (int i = 0; i < 2; ++i) kit_run_draw(run, 0);      /* a last frame to reuse */
    if (failed) { kit_run_close(run); return -1; }
    return 0;
}

static void upload(GLuint buffer, const void *data, size_t size)
{
    glBindBuffer(GL_UNIFORM_BUFFER, buffer);
    glBufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)size, data, GL_DYNAMIC_DRAW);
}

void kit_run_update(kit_run *run)
{
    ssgi_gl_frame vpls = run->frame;
    vpls.lights = run->vpls;
    upload(run->block[0], &run->frame, sizeof run->frame);
    for (int i = 0; i < 2 * run->views; ++i) upload(run->block[1 + i], &run->extra[i], sizeof run->extra[i]);
    upload(run->block[KIT_FRAME_VPLS], &vpls, sizeof vpls);
    upload(run->block[KIT_FRAME_VIEWS], &run->cameras, sizeof run->cameras);
}

/* Makes surfels or splats them, from patches or from a buffer. */
static void draw_surfels(kit_run *run, const kit_pass *p)
{
    const int capture = p->capture != 0, counted = capture && run->query;
    GLint was;
    GLuint written = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &was);
    glBindVertexArray(p->array);
    if (capture) {
        glEnable(GL_RASTERIZER_DISCARD);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, p->capture);
        if (counted) glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, run->query);
        glBeginTransformFeedback(GL_POINTS);
    } else {
        glClearBufferfv(GL_COLOR, 0, (const GLfloat[4]) { 0, 0, 0, 0 });
        glEnable(GL_BLEND);
        glBlendFunc(GL_ONE, GL_ONE);
    }
    if (p->desc.tessellate) {
        glPatchParameteri(GL_PATCH_VERTICES, 3);
        const int all = p->patches[0] + p->patches[1], most = kit_gl_is_software() ? 20 : all;      /* Mesa mixes up points beyond 65536 that one draw tessellates */
        for (int first = 0, count; first < all; first += count) {
            const int end = first < p->patches[0] ? p->patches[0] : all;
            count = end - first < most ? end - first : most;
            glDrawArraysInstanced(GL_PATCHES, 3 * first, 3 * count, first < p->patches[0] ? 1 : p->splits * p->splits);
        }
    } else if (capture) glDrawArrays(GL_POINTS, 0, (GLsizei)run->surfels);
    else glDrawArraysInstanced(GL_TRIANGLES, 0, 6 * p->desc.levels, (GLsizei)run->surfels);
    if (capture) {
        glEndTransformFeedback();
        if (counted) {
            glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
            glGetQueryObjectuiv(run->query, GL_QUERY_RESULT, &written);
            run->surfels = written;
        }
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
        glDisable(GL_RASTERIZER_DISCARD);
    } else glDisable(GL_BLEND);
    glBindVertexArray((GLuint)was);
}

void kit_run_draw(kit_run *run, int timed)
{
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, run->block[KIT_FRAME_VIEWS]);
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        const ssgi_gl_frame *f = p->frame > 0 && p->frame < KIT_FRAME_VPLS ? &run->extra[p->frame - 1] : &run->frame;
        ssgi_gl_io io[SSGI_GL_MAX_IO];
        for (int k = 0, n = ssgi_gl_reflect(&p->desc, io, SSGI_GL_MAX_IO); k < n; ++k)
            if (io[k].kind == SSGI_GL_TEXTURE) {
                glActiveTexture(GL_TEXTURE0 + (GLenum)io[k].slot);
                glBindTexture(target_of(&io[k]), texture_of(run, p, io[k].name));
            }
        glBindBufferBase(GL_UNIFORM_BUFFER, 0, run->block[p->frame]);
        glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer ? p->framebuffer : run->pass[run->passes - 1].framebuffer);     /* surfels: any complete one, which a context without a surface has not */
        if (p->desc.pass >= SSGI_GL_SHUFFLE && p->desc.pass <= SSGI_GL_SMOOTH) glViewport(0, 0, p->width, p->height);
        else if (p->desc.half && p->desc.pass != SSGI_GL_BLUR) glViewport(f->target[0] / 2, f->target[1] / 2, (f->size[0] + 1) / 2, (f->size[1] + 1) / 2);
        else glViewport(f->target[0], f->target[1], f->size[0], f->size[1]);
        glUseProgram(p->program);
        if (timed && !p->aside) kit_timer_begin();
        if (p->desc.pass == SSGI_GL_FIELD) {
            if (!i) glClearBufferfv(GL_COLOR, 0, (const GLfloat[4]) { 1, 1, 1, 1 });
            glEnable(GL_BLEND);
            glBlendFunc(GL_DST_COLOR, GL_ZERO);
            glDrawArraysInstanced(GL_TRIANGLES, 0, 6, p->instances);
            glDisable(GL_BLEND);
        } else if (p->array) draw_surfels(run, p);
        else glDrawArrays(GL_TRIANGLES, 0, 3);
        if (timed && !p->aside) p->ms = kit_timer_end();
    }
    glActiveTexture(GL_TEXTURE0);
}

double kit_run_ms(const kit_run *run)
{
    double ms = 0;
    for (int i = 0; i < run->passes; ++i) ms += run->pass[i].ms;
    return ms;
}

int kit_run_read(kit_image *out, const kit_run *run, kit_error *err)
{
    const kit_gbuffer *g = run->gbuffer;
    const kit_pass *last = &run->pass[run->passes ? run->passes - 1 : 0];
    const int width = run->lit ? g->viewport[2] : last->width, height = run->lit ? g->viewport[3] : last->height, components = run->lit ? 4 : 1;
    const size_t pixels = (size_t)width * (size_t)height;
    const GLuint source[3] = { run->light, run->bounce, run->bounce ? run->joint : 0 };
    kit_image image, frame;
    float *texels = malloc(pixels * (size_t)components * sizeof *texels);
    int failed = 0;
    if (!texels || kit_image_new(&image, width, height, run->lit ? KIT_LIT_CHANNELS : "Y", err)) { free(texels); return -1; }
    for (int s = 0; s < (run->lit ? 3 : 1) && !failed; ++s) {
        if (!source[s]) continue;
        failed = kit_texture_read(source[s], width, height, components, texels) != 0;
        for (size_t i = 0; i < pixels && !failed; ++i) {
            const size_t from = pixels - (i / (size_t)width + 1) * (size_t)width + i % (size_t)width;
            if (!run->lit) image.data[i] = texels[from];
            for (size_t c = 0; c < 3 && run->lit; ++c) {
                float *to = &image.data[(s ? 6 + c : 3 + c) * pixels + i];
                *to = s < 2 ? texels[4 * from + c] : *to - texels[4 * from + c];
            }
        }
    }
    free(texels);
    if (!failed && run->lit && !(failed = kit_gbuffer_read(&frame, g, err))) {
        static const char *const names[2][3] = { { "albedo.R", "albedo.G", "albedo.B" }, { "direct.R", "direct.G", "direct.B" } };
        const float *z = kit_image_channel(&frame, "Z");
        for (size_t c = 0; c < 3; ++c) {
            const float *albedo = kit_image_channel(&frame, names[0][c]), *direct = kit_image_channel(&frame, names[1][c]);
            for (size_t i = 0; i < pixels; ++i)
                if (z[i] > 0)
                    image.data[c * pixels + i] = (albedo ? albedo[i] : 0.8f) * (image.data[(3 + c) * pixels + i] + image.data[(6 + c) * pixels + i]) + (direct ? direct[i] : 0.0f);
        }
        kit_image_free(&frame);
    }
    if (failed) { kit_image_free(&image); return kit_fail(err, "the result cannot be read back"); }
    *out = image;
    return 0;
}

void kit_run_close(kit_run *run)
{
    for (int i = 0; i < run->passes; ++i) {
        int shared = 0;
        for (int k = 0; k < i; ++k) shared |= run->pass[k].program == run->pass[i].program;
        if (!shared) glDeleteProgram(run->pass[i].program);
        glDeleteFramebuffers(1, &run->pass[i].framebuffer);
    }
    for (int v = 0; v < KIT_MAX_VIEWS; ++v) kit_gbuffer_free(&run->view[v]);
    glDeleteTextures(run->textures, run->texture);
    glDeleteVertexArrays(3, run->arrays);
    glDeleteBuffers(3, run->buffers);
    if (run->query) glDeleteQueries(1, &run->query);
    glDeleteBuffers(KIT_FRAMES, run->block);
    free(run->equirect);
    memset(run, 0, sizeof *run);
}
