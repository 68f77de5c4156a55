/* settings.c - the table of methods and of their settings. Declared in kit_gl.h. */
#include "kit/kit_run.h"
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>settings: a table of rows, each with the field of the desc or the frame that it sets --------------- */

enum {
    GATHER = 1,
    LIGHTS = 2 /* sets a field of the descs of gathers, or of lights */,
    FRAME = 4,
    SCALED = 8 /* sets a member of the frame; or sets it to the value times the radius */,
    PLAN = 0 /* sets nothing: the method's code reads it */
};

/* member: its offset in kit_settings; the member's type decides whether the setting takes whole numbers only */
typedef struct row { kit_setting setting; size_t member; int where; size_t offset; } row;
#define DESC(field)  offsetof(ssgi_gl_desc, field)
#define FRAMED(field) offsetof(ssgi_gl_frame, field)
#define WHOLE(member) _Generic(((const kit_settings *)0)->member, int: 1, double: 0)
/* choices: its words, or NULL if the setting is a number */
/* Make a row with the words and limits of a field of ssgi_gl_desc. COUNT refuses 0, the library's default, so that
   costs can be computed from the count. */
#define OF(name, key, field, where, value, about)    ROW(name, key, about, NULL, value, 0, 0, where, DESC(field))
#define COUNT(name, key, field, where, value, about) ROW(name, key, about, NULL, value, 1, 0, where, DESC(field))
#define ROW(name, key, about, choices, value, least, most, where, offset) \
    static const row name = { { #key, about, choices, value, least, most, WHOLE(key) }, \
                              offsetof(kit_settings, key), where, offset };

ROW(noise_row, noise, "pattern that decorrelates neighbouring pixels", "gradient texture", 0, 0, 1, PLAN, 0)
ROW(normal_row, normal, "normals from the G-buffer, or from depth alone, as where a frame has none",
    "gbuffer depth", 0, 0, 1, PLAN, 0)
OF(left_handed_row, left_handed, input.left_handed, GATHER, 0, "1: projection and normals are given as by an engine "
    "whose camera looks along +z")
ROW(limit_row, thickness_limit, "constant thickness of visible surfaces, or the most that a width counts, in radii",
    NULL, 0, 0, 100, SCALED, FRAMED(thickness_limit))
OF(thickness_row, thickness, gather.thickness, GATHER, 0, "thickness of visible surfaces: as width for slices, "
    "else as constant; thickness_limit; unlimited; their width in the picture; up to the back face; two slabs")
OF(gathered_row, resolution, gather.resolution, GATHER, 0,
   "the pixels that are gathered; the filter fills the others: all, one of every 2x2, or each of the four in "
   "turn; one of every 4x4, or each of the sixteen in turn")
ROW(offset_row, offset, "lift of the receiver along its normal, in half pixels",
    NULL, 0, 0, 100, FRAME, FRAMED(offset))
ROW(blur_row, blur, "radius of the filter, pixels; 0 = none", NULL, 1, 0, 4, PLAN, 0)
OF(filter_row, filter, filter.kind, GATHER, 0, "kind of filter")
OF(compare_row, filter_normals, filter.normals, GATHER, 0, "1: the filter compares normals too")
OF(restore_row, restore, light.restore, GATHER, 1, "the filter smooths light, its ratio to unoccluded light, or its "
    "difference from it")
OF(vector_restore_row, restore, light.restore, GATHER, 1, "the filter smooths light, its ratio to unoccluded light, "
    "or its difference from it (joint: always this)")
ROW(phase_row, phase, "offset of the noise", NULL, 0, 0, 1, FRAME, FRAMED(phase))
COUNT(layers_row, layers, gather.layers, GATHER | LIGHTS, 1, "peeled depth layers; closed solids only")
OF(views_row, views, gather.views, GATHER | LIGHTS, 0, "extra cameras; closed solids only")
COUNT(view_layers_row, view_layers, gather.view_layers, GATHER | LIGHTS, 1, "depth layers of each extra camera")
ROW(view_size_row, view_size, "pixels of an extra camera's side", NULL, 256, 16, 4096, PLAN, 0)

ROW(history_row, history, "1: frames are averaged, at full resolution; the first is that of 0",
    NULL, 0, 0, 1, PLAN, 0)
ROW(margin_row, margin, "G-buffer beyond the image's edges, in radii; scenes only", NULL, 0, 0, 4, PLAN, 0)
COUNT(points_row, directions, gather.directions, GATHER, 16, "directions per pixel")
COUNT(along_row, samples, gather.samples, GATHER, 1,
      "points along a direction; the first occluded one counts. With many points "
      "it is near the receiver, and with thickness=solid everything behind a surface is dark, with a hard edge at the "
      "radius")
OF(falloff_row, falloff, gather.falloff, GATHER, 0, "weight of an occluder at distance t: 1 - t/radius, 1 - "
    "(t/radius)^2, or 1 up to the radius (not of points)")
OF(facets_row, facets, gather.facets, GATHER, 0, "1: occluders are sought above the facets that depth shows, light "
    "meets the given normals: for smooth normals on coarse meshes, and normal maps")
OF(lift_row, lift, gather.lift, GATHER | LIGHTS, 0, "1: slices lift receivers by offset, and normals from depth use "
    "neighbours that far apart: for point clouds, with offset=8, in which each splat's edge is a wall otherwise")
OF(fade_row, fade, gather.fade, GATHER, 0, "weight of an occluder by the distance of the surface in the depth buffer; "
    "none: a far surface sends light as if it were at the point, and a bounce may be worse than no bounce")
ROW(lambda_row, lambda, "rate of that fade, per radius: a larger one leaves less", NULL, 0, 0, 1000, FRAME,
    FRAMED(lambda))
OF(range_row, range_check, gather.range_check, GATHER, 0,
    "1: ignore surfaces beyond the radius or below the receiver's plane")
ROW(fade_from_row, fade_from, "where smooth fading begins, in radii", NULL, 0, 0, 1, SCALED, FRAMED(fade))
ROW(sets_row, sets, "sets of directions in a texture, one per pixel; 0 = one set, rotated", NULL, 0, 0, 256, PLAN, 0)
OF(uniform_row, uniform_directions, gather.uniform_directions, GATHER, 0,
    "1: directions are spread evenly and weighted by the "
    "cosine, as published; 0: their density is the cosine")
COUNT(slices_row, slices, gather.slices, GATHER, 1, "slices, two directions each")
COUNT(directions_row, directions, gather.directions, GATHER, 6, "N_d: directions in the tangent plane")
COUNT(samples_row, samples, gather.samples, GATHER, 6, "N_s: samples along each direction")
OF(rays_row, normal_rays, gather.normal_rays, GATHER, 0, "N_n: rays above the horizon, per direction")
OF(terms_row, march_terms, gather.march_terms, GATHER, 0,
    "horizon and normal rays; either alone; rays over the whole hemisphere, "
    "without a horizon")
OF(sphere_row, growing_sphere, gather.growing_sphere, GATHER, 0,
    "1: the horizon rises only to surfaces within a sphere that "
    "grows with the ray")

ROW(environment_row, environment, "how --env is used", "map sh none", 0, 0, 2, PLAN, 0)
OF(bounce_row, bounce, light.bounce, GATHER, 1, "estimator of one diffuse bounce; patch, as published, has an error of "
    "2.5 times the mean on `room`, no bounce one of 2.2")
ROW(bounced_row, bounced, "1: emitters send the last frame's bounce, too: further bounces", NULL, 0, 0, 1, PLAN, 0)
ROW(reuse_row, reuse, "1: emitters use the last frame's light, so that one gather does both", NULL, 0, 0, 1, PLAN, 0)
OF(two_sided_row, two_sided, light.two_sided, GATHER, 0, "1: emitters are two-sided")
OF(one_sided_row, one_sided, light.one_sided, GATHER, 0, "1: the unseen sides of emitters send nothing; 0: an unseen "
    "side sends 0.35 of their radiance, as most surfaces are lit from there, too")
ROW(clamp_row, clamp, "largest luminance of an emitter, its hue kept, against fireflies; 0: no limit", NULL, 0, 0,
    65408, PLAN, 0)
ROW(distance_clamp_row, distance_clamp, "clamp of the distance to a patch, in radii",
    NULL, 0, 0, 100, FRAME, FRAMED(distance_clamp))
ROW(gain_row, gain, "area of patches, times pi r^2/N", NULL, 0, 0, 1000, FRAME, FRAMED(gain))
OF(shadows_row, shadows, light.shadow, LIGHTS, 2, "shadows of --light: by screen-space segments, maps, maps with "
    "segments over their bias")
OF(shadows_d_row, shadows, light.shadow, LIGHTS, 1, "shadows of --light: by maps, or none")
COUNT(segment_row, points, gather.samples, LIGHTS, 8, "points on a segment toward a light")
ROW(solid_row, solid, "1: in shadows, surfaces have unlimited thickness", NULL, 0, 0, 1, PLAN, 0)
ROW(max_slope_row, max_slope, "largest slope that the shadow maps' bias follows",
    NULL, 0, 0, 1000, FRAME, FRAMED(max_slope))
ROW(shadow_row, shadow_size, "texels of a shadow map's side", NULL, 1024, 16, 8192, PLAN, 0)
ROW(suns_row, suns, "the environment as directional lights with shadow maps; 0: directional occlusion",
    NULL, 0, 0, 1024, PLAN, 0)
ROW(vpls_row, vpls, "virtual point lights of the first --light: the bounce beyond the radius",
    NULL, 0, 0, 4096, PLAN, 0)

COUNT(bands_row, bands, light.bands, GATHER, 4, "bands of spherical harmonics: 1, 4, 9 or 16 coefficients")
COUNT(few_bands_row, bands, light.bands, GATHER, 3, "environment=sh: bands of spherical harmonics")
ROW(store_row, store, "coefficients as halves, halves packed into integers, or floats",
    "half packed float", 0, 0, 2, PLAN, 0)
ROW(packed_row, store, "coefficients that are filtered or lit by lights: halves, packed halves, floats; joint: packed",
    "half packed float", 1, 0, 2, PLAN, 0)
ROW(indirect_row, indirect, "one bounce: none, in the gather of the occlusion, in a gather of its own",
    "none joint apart", 1, 0, 2, PLAN, 0)
OF(occluded_row, occluded_emitters, light.occluded_emitters, GATHER, 0,
    "1: emitters reflect the light that the last frame let through to "
    "them, not all of it: several bounces")
ROW(filtered_row, filtered, "the filter smooths these", "coefficients light", 1, 0, 1, PLAN, 0)
OF(residual_row, residual, light.residual, GATHER, 1, "1: unoccluded irradiance is exact, harmonics give the "
    "occlusion alone; 0: one band lights all normals alike, which is worse than no occlusion")
OF(lamp_residual_row, residual, light.residual, GATHER, 1, "lights=harmonics: 1: unoccluded light is exact, harmonics "
    "give the occlusion alone")
OF(sh_residual_row, residual, light.residual, GATHER, 1, "environment=sh: 1: unoccluded irradiance is exact, "
    "harmonics give the occlusion alone; 0: one band lights all normals alike, which is worse than no occlusion")
ROW(lobes_row, lobes, "a texel of the environment's map is the mean over one of so many directions; 0: the gather's",
    NULL, 0, 0, 1024, PLAN, 0)
ROW(window_row, window, "window over the harmonics of lights", "none hann positive", 1, 0, 2, PLAN, 0)
ROW(lights_row, lights, "--light as harmonics, or by maps and segments, without a bounce",
    "harmonics shadowed", 0, 0, 1, PLAN, 0)
/* As harmonics of two bands a lamp has a wide lobe. In the corner of two endless walls a wall's point has the
   coefficients pi/2 sqrt(1/(4 pi)), and sqrt(3/(4 pi)) times pi/3 along its normal and 2/3 away from the other wall.
   With Hann's window and the residual, a lamp that the point sees, along (1, 1) / sqrt(2), gives 0.47, and one behind
   the other wall, along (1, -1) / sqrt(2), 0.24. The cosine of both is 0.71, so that 0.66 of the visible lamp is left
   and 0.34 of the hidden one. Creases that see the lamp are too dark; if occluders are beyond the radius, this is worse
   than no shadow. */
ROW(shadowed_row, lights, "--light by maps and segments, or as harmonics of two bands, whose lobe is wide: a crease "
    "that sees a light keeps 0.66 of it, a hidden one 0.34; may be worse than no occlusion",
    "harmonics shadowed", 1, 0, 1, PLAN, 0)
ROW(cone_row, cone, "environment over the cone of unoccluded directions, or irradiance along their mean",
    "normal cone", 1, 0, 1, PLAN, 0)

ROW(resolution_row, field_resolution, "texels along a side of a field's cube map", NULL, 16, 2, 128, PLAN, 0)
ROW(radii_row, radii, "distances sampled along each direction", NULL, 12, 4, 64, PLAN, 0)
ROW(rays_a_row, rays, "rays a sample of the bake", NULL, 96, 16, 65536, PLAN, 0)
ROW(unfiltered_row, unfiltered, "1: a bake without the doubled resolution and the Gaussian", NULL, 0, 0, 1, PLAN, 0)
ROW(reach_row, reach, "influence of occluders, in radii of their bounding spheres", NULL, 8, 1.5, 64, PLAN, 0)
ROW(ramp_row, ramp, "where occluders begin to fade, as a share of the reach", NULL, 0.75, 0, 0.99, PLAN, 0)
ROW(inside_row, inside, "A_0: occlusion deep in the convex hull; -1 = as measured", NULL, -1, -1, 1, PLAN, 0)
ROW(power_row, power, "p: exponent of the blend toward A_0", NULL, 1, 0.01, 100, PLAN, 0)
ROW(own_row, own, "1: occluders occlude themselves too", NULL, 0, 0, 1, PLAN, 0)
ROW(occluders_row, occluders, "objects that occlude: solid ones that contain no other, or all",
    "solid all", 0, 0, 1, PLAN, 0)
ROW(cap_table_row, cap_table, "texels along a side of the table that a cap's occlusion is looked up in, 2 or more; "
    "0: its closed form", NULL, 0, 0, 4096, PLAN, 0)

ROW(size_row, size, "s: diameter of a surfel, in image heights", NULL, 0.03, 1e-4, 1, PLAN, 0)
ROW(fine_size_row, size, "s: diameter of a surfel, in image heights", NULL, 0.015, 1e-4, 1, PLAN, 0)
ROW(epsilon_row, epsilon, "smallest form factor that a surfel is drawn for",
    NULL, 0, 1e-6, 1, FRAME, FRAMED(epsilon))
COUNT(deep_levels_row, levels, surfel.levels, GATHER, 7, "levels of sub-buffers: each doubles the reach")
OF(levels_row, levels, surfel.levels, GATHER, 0, "levels of sub-buffers: each doubles the reach; 0: as many as the "
    "radius needs")
ROW(way_row, way, "surfels made on the CPU, captured from tessellation, or splatted by a geometry shader at once",
    "cpu capture direct", 0, 0, 2, PLAN, 0)
COUNT(near_row, near_samples, surfel.near_samples, GATHER, 1, "points over a surfel for pixels within 4 of its radii; "
    "1: its centre alone")
OF(span_row, span, surfel.span, GATHER, 6, "surfaces nearer than so many surfel radii are left to slices, all others "
    "to surfels")
ROW(hidden_sky_row, sky, "1: --env also lights surfels outside the picture, unoccluded; span=0: always all surfels",
    NULL, 0, 0, 1, PLAN, 0)
ROW(sent_row, bounce, "one diffuse bounce of surfels; none: directional occlusion alone",
    "none surfels", 1, 0, 1, PLAN, 0)
ROW(offscreen_growth_row, offscreen_growth, "radius added per distance outside the frustum", NULL, 0.1, 0, 1, PLAN, 0)
ROW(near_depth_row, near_depth, "1: splats end at the frame's least view depth; 0: at the near plane",
    NULL, 1, 0, 1, PLAN, 0)
OF(both_row, two_sided, light.two_sided, GATHER, 0, "1: surfels have two sides, as sheets and leaves need")
ROW(keep_small_row, keep_small, "1: every triangle keeps a surfel; 0: small ones are thinned", NULL, 0, 0, 1, PLAN, 0)
ROW(each_row, keep_small, "1: every triangle keeps a surfel; 0: small ones are thinned, visibly",
    NULL, 1, 0, 1, PLAN, 0)
ROW(splits_row, splits, "largest number of parts of a large triangle's edge", NULL, 8, 1, 32, PLAN, 0)
OF(overhang_row, overhang, surfel.overhang, GATHER, 0, "triangles shrink about their incentre, or as published their "
    "corners move to the centroid")
OF(enlarge_row, enlarge, surfel.enlarge, GATHER, 0, "1: surfels of level l are 2^l times as wide, as published; "
    "0: they count 4^l times")
OF(combine_row, combine, surfel.combine, GATHER, 0, "form factors share the directions that are left, 1 - exp(-sum); "
    "or, as published, add up, to 1 at most")
ROW(smooth_row, smooth, "0: levels are added unfiltered", NULL, 1, 0, 1, PLAN, 0)
OF(likeness_row, filter_normals, filter.normals, GATHER, 0, "1: the smoothing compares normals too")
ROW(exponent_row, exponent, "exponent of the lobe", NULL, 0, 0, 10000, FRAME, FRAMED(exponent))
ROW(sky_row, sky, "1: --env lights surfels too, unoccluded", NULL, 1, 0, 1, PLAN, 0)
ROW(material_row, material, "published scattering constants",
    "apple chicken1 chicken2 cream ketchup marble potato skimmilk skin1 skin2 spectralon wholemilk",
    5, 0, 11, PLAN, 0)
ROW(unit_row, unit, "world units of a millimetre", NULL, 0.01, 1e-6, 1e6, PLAN, 0)

enum { MAX_SETTINGS = 48 };

/* The settings of a kind of methods. search: slices, points or march; for surfels, their effect. bent: if 1, for bent
   normals. */
typedef struct plan {
    int         pass, search, bent;
    const row  *rows[MAX_SETTINGS];
    int         count;
} plan;
/* Makes the list of a kind's rows and their number. More rows than MAX_SETTINGS do not compile. */
#define SETTINGS(...) { __VA_ARGS__ }, COUNTED(sizeof((const row *const[]){ __VA_ARGS__ }) / sizeof(const row *))
#define COUNTED(n) \
    ((int)(n) + 0 * (int)sizeof(struct { \
        _Static_assert((n) <= MAX_SETTINGS, "a method has more than MAX_SETTINGS"); \
        int i; \
    }))
#define ROUGH &facets_row, &lift_row
#define DEEP &layers_row, &views_row, &view_layers_row, &view_size_row
#define POINTS \
    &points_row, &along_row, &sets_row, &uniform_row, &falloff_row, &fade_row, &fade_from_row, &lambda_row, \
        &range_row, &gathered_row, &thickness_row, &limit_row, &offset_row, ROUGH, DEEP
#define WALK &slices_row, &samples_row, &falloff_row, &gathered_row, &thickness_row, &limit_row, &offset_row, ROUGH
#define SSDO(...) \
    SETTINGS(__VA_ARGS__, &few_bands_row, &sh_residual_row, &environment_row, &lobes_row, &bounce_row, &reuse_row, \
             &bounced_row, &two_sided_row, &clamp_row, &distance_clamp_row, &gain_row, &shadows_row, &segment_row, \
             &solid_row, &max_slope_row, \
             &shadow_row, &suns_row, &vpls_row, &normal_row, &noise_row, &phase_row, &blur_row, &filter_row, \
             &restore_row, &compare_row, &margin_row, &history_row)
#define COEFFICIENTS(store, lights, ...) \
    __VA_ARGS__, store, &filtered_row, &window_row, lights, &shadows_row, &segment_row, &solid_row, \
        &max_slope_row, &shadow_row, &normal_row, &noise_row, &phase_row, &blur_row, &filter_row, \
        &vector_restore_row, &compare_row, &margin_row, &history_row
#define S3HO(...) \
    SETTINGS(&bands_row, &indirect_row, &occluded_row, &residual_row, &two_sided_row, &clamp_row, \
             COEFFICIENTS(&packed_row, &lights_row, __VA_ARGS__))
#define SSBN(...) SETTINGS(&cone_row, &lamp_residual_row, COEFFICIENTS(&store_row, &shadowed_row, __VA_ARGS__))
#define SURFELS(size, every, levels, ...) \
    SETTINGS(size, &epsilon_row, levels, &way_row, &splits_row, &overhang_row, &offscreen_growth_row, every, \
             &near_depth_row, &near_row, &both_row, &smooth_row, &likeness_row, &normal_row, &gathered_row, &blur_row, \
             __VA_ARGS__)
#define PUBLISHED &enlarge_row, &combine_row
#define NEAR &span_row, &slices_row, &samples_row, &thickness_row
#define LIT_SURFELS &shadows_d_row, &shadow_row, &max_slope_row
static const plan plans[] = {
    { SSGI_GL_PASS_SSAO, SSGI_GL_SEARCH_SLICES, 0,
      SETTINGS(&points_row, &along_row, &sets_row, &uniform_row, &falloff_row, &fade_row, &fade_from_row, &lambda_row,
               &range_row, &gathered_row, &thickness_row, &limit_row, &offset_row, ROUGH, DEEP, &normal_row, &noise_row,
               &phase_row, &blur_row, &filter_row, &compare_row, &margin_row, &history_row) },
    { SSGI_GL_PASS_HSAO, SSGI_GL_SEARCH_SLICES, 0,
      SETTINGS(&slices_row, &samples_row, &gathered_row, &thickness_row, &limit_row, &falloff_row, &normal_row,
               &noise_row, &phase_row, &blur_row, &filter_row, &compare_row, &margin_row, &history_row,
               &left_handed_row, &offset_row, ROUGH) },
    { SSGI_GL_PASS_HSAO, SSGI_GL_SEARCH_MARCH, 0,
      SETTINGS(&directions_row, &samples_row, &rays_row, &terms_row, &sphere_row, &gathered_row, &thickness_row,
               &limit_row, &falloff_row, &offset_row, ROUGH, DEEP, &normal_row, &noise_row, &phase_row, &blur_row,
               &filter_row, &compare_row, &margin_row, &history_row) },
    { SSGI_GL_PASS_SSDO, SSGI_GL_SEARCH_SLICES, 0, SSDO(WALK, &one_sided_row) },
    { SSGI_GL_PASS_SSDO, SSGI_GL_SEARCH_POINTS, 0, SSDO(POINTS) },
    { SSGI_GL_PASS_S3HO, SSGI_GL_SEARCH_SLICES, 0, S3HO(WALK, &one_sided_row) },
    { SSGI_GL_PASS_S3HO, SSGI_GL_SEARCH_POINTS, 0, S3HO(POINTS) },
    { SSGI_GL_PASS_S3HO, SSGI_GL_SEARCH_SLICES, 1, SSBN(WALK) },
    { SSGI_GL_PASS_S3HO, SSGI_GL_SEARCH_POINTS, 1, SSBN(POINTS) },
    { SSGI_GL_PASS_DSS, SSGI_GL_EFFECT_OCCLUSION, 0,
      SURFELS(&size_row, &keep_small_row, &levels_row, &falloff_row, PUBLISHED, NEAR) },
    { SSGI_GL_PASS_DSS, SSGI_GL_EFFECT_LIGHT, 0,
      SURFELS(&size_row, &keep_small_row, &levels_row, &sent_row, &hidden_sky_row, LIT_SURFELS, PUBLISHED, NEAR) },
    { SSGI_GL_PASS_DSS, SSGI_GL_EFFECT_SPECULAR, 0,
      SURFELS(&fine_size_row, &keep_small_row, &levels_row, &sky_row, LIT_SURFELS, PUBLISHED, &exponent_row) },
    { SSGI_GL_PASS_DSS, SSGI_GL_EFFECT_SCATTER, 0,
      SURFELS(&fine_size_row, &each_row, &deep_levels_row, &sky_row, LIT_SURFELS, &material_row, &unit_row) },
    { SSGI_GL_PASS_DEBUG, 0, 0, SETTINGS(&normal_row) },
    { SSGI_GL_PASS_AOF, 0, 0,
      SETTINGS(&resolution_row, &radii_row, &rays_a_row, &unfiltered_row, &reach_row, &ramp_row, &inside_row,
               &power_row, &own_row, &occluders_row, &normal_row, &cap_table_row) }
};
enum { PLANS = (int)(sizeof plans / sizeof plans[0]) };

static const plan *plan_of(const ssgi_gl_chain *chain)
{
    const ssgi_gl_desc *d = &chain->desc;
    const int search = d->pass == SSGI_GL_PASS_DSS ? (int)d->surfel.effect : (int)d->gather.search;
    int k = 0;
    while (k < PLANS - 1 && (plans[k].pass != (int)d->pass || plans[k].search != search
                             || plans[k].bent != (d->light.shading != SSGI_GL_SHADING_HARMONICS)))
        ++k;
    return &plans[k];
}

/* Returns a row's setting; if it sets a field of the desc, with that field's words and limits. */
static kit_setting setting_of(const row *w)
{
    kit_setting s = w->setting;
    const ssgi_gl_choice *c;
    for (int i = 0; w->where & (GATHER | LIGHTS) && (c = ssgi_gl_choice_at(i)) != NULL; ++i) {
        if (c->offset != w->offset) continue;
        s.choices = *c->values ? c->values : NULL;
        s.most = c->most;
    }
    return s;
}

static double value_of(const kit_settings *set, const row *w)
{
    const char *at = (const char *)set + w->member;
    return w->setting.whole ? *(const int *)(const void *)at : *(const double *)(const void *)at;
}

static void set_value(kit_settings *set, const row *w, double value)
{
    char *at = (char *)set + w->member;
    if (w->setting.whole) *(int *)(void *)at = (int)value; else *(double *)(void *)at = value;
}

int kit_method_setting(kit_setting *setting, const kit_method *method, int i)
{
    const plan *of = method->plan;
    if (i < 0 || i >= of->count) return 0;
    *setting = setting_of(of->rows[i]);
    setting->value = value_of(&method->set, of->rows[i]);
    return 1;
}

/* Returns a setting's initial value: that of the method's chain if it is not 0; that of the frame for a radius of 1; or
   else the row's own. */
static double initial_of(const row *w, const ssgi_gl_chain *chain, const ssgi_gl_frame *frame)
{
    int value = 0;
    float real = 0;
    if (w == &blur_row) return chain->desc.filter.radius;
    if (w == &history_row) return chain->history;
    if (w == &vector_restore_row) return w->setting.value;   /* without a bounce the ratio has an error lower by .02 */
    if (w->where & (FRAME | SCALED)) {
        memcpy(&real, (const char *)frame + w->offset, sizeof real);
        return round(1e6 * (double)real) / 1e6;                         /* rounds to decimals: 0.3f becomes 0.3 */
    }
    if (w->where & GATHER) memcpy(&value, (const char *)&chain->desc + w->offset, sizeof value);
    return value ? value : w->setting.value;
}

/* Makes the chain of a method by its name, and its frame for a radius of 1. */
static ssgi_result library_of(ssgi_gl_chain *chain, ssgi_gl_frame *frame, const char *name, const char **why)
{
    static const float projection[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1, -1, 0, 0, -2, 0 };
    ssgi_view view;
    return ssgi_gl_chain_of(chain, name, why) != SSGI_OK
        || ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, 1, 1, why) != SSGI_OK
             ? SSGI_BAD_ARGUMENT
             : ssgi_gl_frame_of(frame, chain, &view, 1, why);
}

enum { DEBUG = -2 };                           /* the number of debug, which has a name, but is no method */

int kit_method_at(kit_method *method, int i)
{
    static const ssgi_gl_method debug = { "debug", "Faults of the inputs.", SSGI_GL_PASS_DEBUG, 0, "" };
    const ssgi_gl_method *named = i == DEBUG ? &debug : ssgi_gl_method_at(i);
    kit_method m;
    ssgi_gl_chain chain;
    ssgi_gl_frame frame;
    if (!named || library_of(&chain, &frame, named->name, NULL) != SSGI_OK) return 0;
    memset(&m, 0, sizeof m);
    m.name = named->name;
    m.about = named->sentence;
    m.number = i;
    m.plan = plan_of(&chain);
    m.pass = named->pass;
    m.effect = chain.desc.surfel.effect;
    m.between = m.pass == SSGI_GL_PASS_AOF;
    m.lit = m.pass == SSGI_GL_PASS_SSDO || m.pass == SSGI_GL_PASS_S3HO || m.effect != SSGI_GL_EFFECT_OCCLUSION;
    for (int k = 0; k < m.plan->count; ++k)
        set_value(&m.set, m.plan->rows[k], initial_of(m.plan->rows[k], &chain, &frame));
    *method = m;
    return 1;
}

int kit_method_find(kit_method *method, const char *name, kit_error *err)
{
    const char *why = "name: must be a method's name alone; settings are given by --set";
    ssgi_gl_chain chain;
    kit_method m;
    for (int i = 0; kit_method_at(&m, i); ++i)
        if (!strcmp(m.name, name)) { *method = m; return 0; }
    if (!strcmp("debug", name)) return !kit_method_at(method, DEBUG);
    ssgi_gl_chain_of(&chain, name, &why);
    return kit_fail(err, "--method %s: %s (--list names all)", name, why + strlen("name: "));
}

/* Returns the number of a word among a setting's words, in any case and with - for _; or a number as it stands. -1: no
   such word. */
static int choice_of(const char *words, const char *value)
{
    int k = 0;
    for (; *words; ++k) {
        const size_t n = strcspn(words, " ");
        size_t i = 0;
        while (i < n && (tolower(words[i]) == value[i] || (words[i] == '_' && value[i] == '-'))) ++i;
        if (i == n && !value[n]) return k;
        words += n + (words[n] ? 1 : 0);
    }
    return *value >= '0' && *value < '0' + k && !value[1] ? *value - '0' : -1;
}

size_t kit_setting_word(char *out, size_t size, const kit_setting *s, int number)
{
    const char *word = s->choices;
    size_t n = 0;
    for (int k = 0; k < number && *word; ++k) {
        word += strcspn(word, " ");
        word += *word == ' ';
    }
    for (; word[n] && word[n] != ' ' && n + 1 < size; ++n) out[n] = (char)tolower(word[n]);
    if (size) out[n] = 0;
    return n;
}

/* Parses the value of a setting. */
static int parse_value(double *out, const kit_setting *s, const char *text, kit_error *err)
{
    char *end;
    if (s->choices) {
        char words[256] = "", *end_ = words;
        *out = choice_of(s->choices, text);
        for (int k = 0; k <= (int)s->most && *out < 0; ++k) {
            if (k) *end_++ = ' ';
            end_ += kit_setting_word(end_, sizeof words - 1 - (size_t)(end_ - words), s, k);
        }
        return *out < 0 ? kit_fail(err, "--set %s=%s: must be one of: %s", s->key, text, words) : 0;
    }
    *out = strtod(text, &end);
    if (end == text || *end || !(*out >= s->least && *out <= s->most) || (s->whole && *out != floor(*out)))
        return kit_fail(err, "--set %s=%s: must be a %snumber in %g..%g", s->key, text, s->whole ? "whole " : "",
                        s->least, s->most);
    return 0;
}

static int set_one(kit_method *m, const char *text, size_t length, kit_error *err)
{
    const plan *of = m->plan;
    char key[128], *value;
    if (length >= sizeof key) return kit_fail(err, "--set %.40s...: too long", text);
    memcpy(key, text, length);
    key[length] = 0;
    value = strchr(key, '=');
    if (!value) return kit_fail(err, "--set %s: must be key=value", key);
    *value++ = 0;
    const char *name = strcmp(key, "behind") ? key : "thickness";
    if (name != key)
        fputs("--set behind: the setting is thickness since version 0.4; behind is taken until 1.0\n", stderr);
    for (int i = 0; i < of->count; ++i) {
        double v;
        const kit_setting s = setting_of(of->rows[i]);
        if (strcmp(s.key, name)) continue;
        if (parse_value(&v, &s, value, err)) return -1;
        set_value(&m->set, of->rows[i], v);
        return 0;
    }
    return kit_fail(err, "--set %s=%s: method %s has no such setting (--list %s names them)", key, value, m->name,
                    m->name);
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

void kit_method_take(kit_method *method, const ssgi_gl_desc *desc)
{
    const plan *of = method->plan;
    for (int i = 0; i < of->count; ++i) {
        const row *w = of->rows[i];
        int value;
        if (!(w->where & GATHER)) continue;
        memcpy(&value, (const char *)desc + w->offset, sizeof value);
        if (value >= w->setting.least) set_value(&method->set, w, value);
    }
}

void kit_method_text(char *text, size_t size, const kit_method *method)
{
    const plan *of = method->plan;
    kit_method plain;
    size_t used = 0;
    kit_method_at(&plain, method->number);
    *text = 0;
    for (int i = 0; i < of->count && used < size; ++i) {
        const kit_setting s = setting_of(of->rows[i]);
        const double value = value_of(&method->set, of->rows[i]);
        if (value == value_of(&plain.set, of->rows[i])) continue;
        used += (size_t)snprintf(text + used, size - used, "%s%s=", used ? "," : "", s.key);
        if (used >= size) break;
        used += s.choices ? kit_setting_word(text + used, size - used, &s, (int)value)
                          : (size_t)snprintf(text + used, size - used, "%.17g", value);
    }
}

int kit_method_levels(const kit_method *method, double radius)
{
    const kit_settings *set = &method->set;
    return ssgi_splat_levels(set->size, set->epsilon, set->falloff == SSGI_GL_FALLOFF_NONE ? radius : 0.5 * radius);
}

ssgi_field_desc kit_method_field(const kit_method *method)
{
    ssgi_field_desc d;
    memset(&d, 0, sizeof d);
    d.resolution = method->set.field_resolution;
    d.radii = method->set.radii;
    d.rays = method->set.rays;
    d.reach = (float)method->set.reach;
    d.unfiltered = method->set.unfiltered;
    return d;
}

/* ---- >>apply ---------------------------------------------------------------------------------------------------- */

static int check_combination(const kit_making *m)
{
    const kit_settings *set = m->set;
    if (m->kept && !set->blur)
        return kit_fail(m->err, "--set history=1: filters its average; it needs blur=1 or more");
    if (m->kept && m->desc.pass == SSGI_GL_PASS_S3HO && set->filtered != KIT_FILTERED_LIGHT)
        return kit_fail(m->err, "--set history=1: averages light, not coefficients; it needs filtered=light");
    if (set->indirect == KIT_INDIRECT_JOINT && set->store != KIT_STORE_PACKED)
        return kit_fail(m->err, "--set store=%s: one gather with the bounce packs its coefficients: it needs "
                                "indirect=none or apart", set->store == KIT_STORE_FLOAT ? "float" : "half");
    if (set->occluded_emitters
        && (set->indirect != KIT_INDIRECT_JOINT || set->filtered != KIT_FILTERED_COEFFICIENTS || !set->blur
            || set->margin > 0))
        return kit_fail(m->err, "--set occluded_emitters=1: reads the last frame's filtered coefficients: it needs "
                                "indirect=joint, filtered=coefficients, blur=1 or more and margin=0");
    return 0;
}

int kit_settings_apply(kit_making *m, float radius)
{
    const plan *of = m->method->plan;
    const kit_settings *set = m->set;
    ssgi_gl_desc *to[2] = { &m->desc, &m->lights };
    m->desc.pass = of->pass;
    if (of->pass == SSGI_GL_PASS_DSS) m->desc.surfel.effect = of->search; else m->desc.gather.search = of->search;
    if (m->method->custom) {
        m->desc.surfel.effect = SSGI_GL_EFFECT_CUSTOM;
        m->desc.shader.fetch = m->method->custom;
    }
    m->lights = m->desc;
    m->lights.pass = SSGI_GL_PASS_LIGHTS;
    for (int i = 0; i < of->count; ++i) {
        const row *w = of->rows[i];
        const double v = value_of(set, w);
        const int whole = (int)v;
        const float real = (float)(w->where == SCALED ? v * (double)radius : v);
        for (int k = 0; k < 2; ++k) if (w->where & 1 << k) memcpy((char *)to[k] + w->offset, &whole, sizeof whole);
        if (w->where & (FRAME | SCALED)) memcpy((char *)&m->run->frame + w->offset, &real, sizeof real);
    }
    m->blurred = set->blur;
    m->kept = set->history;
    if (check_combination(m)) return -1;
    m->desc.filter.radius = set->blur;
    m->desc.gather.noise = m->lights.gather.noise = set->noise;
    m->desc.gather.kernel_texture = set->sets > 0;
    m->desc.light.clamp = set->clamp > 0;
    if (set->clamp > 0) m->run->frame.sent = (float)set->clamp;
    m->lights.gather.thickness = set->solid ? SSGI_GL_THICKNESS_SOLID : SSGI_GL_THICKNESS_CONSTANT;
    if (m->desc.pass == SSGI_GL_PASS_S3HO) {
        if (!m->desc.light.bands) {            /* bent normals */
            m->desc.light.bands = 2;
            m->desc.light.shading = set->cone ? SSGI_GL_SHADING_BENT_CONE : SSGI_GL_SHADING_BENT_NORMAL;
        }
        m->desc.light.packed_coefficients = set->store == KIT_STORE_PACKED;
        if (set->lights == KIT_LIGHTS_HARMONICS) m->lights.light.shadow = SSGI_GL_SHADOW_NONE;
    }
    if (set->normal || !m->run->gbuffer->normal)
        m->desc.input.normal = m->lights.input.normal = SSGI_GL_NORMAL_FROM_DEPTH;
    return 0;
}
