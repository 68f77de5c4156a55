/* choices.c - the passes, and the choices that change their text, one at a time. Declared in choices.h. */
#include "tools/glsl/choices.h"
#include <stddef.h>
#include <string.h>

#define CUSTOM \
    "float ssgi_custom_depth(ivec2 texel, int layer) { return layer == 0 ? texelFetch(my_gbuffer, texel, 0).w : 0.0; " \
    "}\n" \
    "vec3 ssgi_custom_normal(ivec2 texel) { return texelFetch(my_gbuffer, texel, 0).xyz; }\n" \
    "vec3 ssgi_custom_surfel(vec3 position, vec3 normal, vec3 colour) { return colour * max(normal.y, 0.0); }\n" \
    "vec3 ssgi_custom_harmonic(int i, vec3 position) { return vec3(i == 0 ? 3.5 : position.y); }\n" \
    "uint ssgi_custom_object(ivec2 texel) { return texelFetch(my_gbuffer, texel, 0).w > 1.0 ? 1u : 0u; }\n" \
    "float ssgi_custom_reach(vec3 position, vec3 normal, float radius, vec3 colour, float epsilon) {\n" \
    "    return radius * sqrt(max(colour.x / epsilon - 1.0, 0.0));\n" \
    "}\n" \
    "vec4 ssgi_custom_effect(vec3 position, vec3 normal, float radius, vec3 colour, vec3 P, vec3 n) {\n" \
    "    vec3 v = position - P;\n" \
    "    float d = dot(v, v), facing = max(dot(v, n), 0.0) * max(-dot(v, normal), 0.0);\n" \
    "    float form = radius * radius * facing / (d * (d + radius * radius));\n" \
    "    return form * vec4(colour, 1.0);\n" \
    "}\n"
static const char custom[] = "uniform sampler2D my_gbuffer;\n" CUSTOM,
                  custom_vulkan[] = "layout(set = 1, binding = 0) uniform texture2D my_gbuffer;\n" CUSTOM;

#define CHOICE(name, field, value) { name, offsetof(ssgi_gl_desc, field), value }
const choice choices[] = { { "", 0, 0 },
                           CHOICE("orthographic", orthographic, 1),
                           CHOICE("linear", depth, SSGI_GL_DEPTH_LINEAR),
                           CHOICE("customdepth", depth, SSGI_GL_DEPTH_CUSTOM),
                           CHOICE("unsigned", normal, SSGI_GL_NORMAL_UNSIGNED),
                           CHOICE("octahedral", normal, SSGI_GL_NORMAL_OCTAHEDRAL),
                           CHOICE("fromdepth", normal, SSGI_GL_NORMAL_FROM_DEPTH),
                           CHOICE("customnormal", normal, SSGI_GL_NORMAL_CUSTOM),
                           CHOICE("world", world_normals, 1),
                           CHOICE("jitter", noise, SSGI_GL_NOISE_TEXTURE),
                           CHOICE("points", search, SSGI_GL_POINTS),
                           CHOICE("march", search, SSGI_GL_MARCH),
                           CHOICE("rays", normal_rays, 1),
                           CHOICE("normalterm", terms, SSGI_GL_TERMS_NORMAL),
                           CHOICE("raysterm", terms, SSGI_GL_TERMS_RAYS),
                           CHOICE("spheres", spheres, 1),
                           CHOICE("hard", hard, 1),
                           CHOICE("solid", thickness, SSGI_GL_THICKNESS_SOLID),
                           CHOICE("width", thickness, SSGI_GL_THICKNESS_WIDTH),
                           CHOICE("back", thickness, SSGI_GL_THICKNESS_BACK),
                           CHOICE("slabs", thickness, SSGI_GL_THICKNESS_SLABS),
                           CHOICE("steps", steps, 3),
                           CHOICE("square", falloff, SSGI_GL_FALLOFF_SQUARE),
                           CHOICE("kernel", kernel, 1),
                           CHOICE("uniform", uniform, 1),
                           CHOICE("fade", fade, SSGI_GL_FADE_SMOOTH),
                           CHOICE("lambda", fade, SSGI_GL_FADE_LAMBDA),
                           CHOICE("range", range, 1),
                           CHOICE("layers", layers, 2),
                           CHOICE("receiver", receiver, 1),
                           CHOICE("views", views, 2),
                           CHOICE("viewlayers", view_layers, 2),
                           CHOICE("sh", environment, SSGI_GL_ENVIRONMENT_SH),
                           CHOICE("solidangle", bounce, SSGI_GL_BOUNCE_SOLID_ANGLE),
                           CHOICE("patch", bounce, SSGI_GL_BOUNCE_PATCH),
                           CHOICE("twosided", two_sided, 1),
                           CHOICE("1band", bands, 1),
                           CHOICE("2bands", bands, 2),
                           CHOICE("3bands", bands, 3),
                           CHOICE("4bands", bands, 4),
                           CHOICE("packed", packed, 1),
                           CHOICE("transfer", transfer, SSGI_GL_TRANSFER_BOTH),
                           CHOICE("reflected", transfer, SSGI_GL_TRANSFER_REFLECTED),
                           CHOICE("dimmed", dimmed, 1),
                           CHOICE("shaded", shaded, 1),
                           CHOICE("customharmonics", harmonics, SSGI_GL_HARMONICS_CUSTOM),
                           CHOICE("residual", residual, 1),
                           CHOICE("bentnormal", shading, SSGI_GL_SHADING_BENT_NORMAL),
                           CHOICE("bentcone", shading, SSGI_GL_SHADING_BENT_CONE),
                           CHOICE("bent", shading, SSGI_GL_SHADING_BENT),
                           CHOICE("lights", lights, 1),
                           CHOICE("albedo", albedo, 1),
                           CHOICE("map", shadow, SSGI_GL_SHADOW_MAP),
                           CHOICE("fill", shadow, SSGI_GL_SHADOW_FILL),
                           CHOICE("unshadowed", shadow, SSGI_GL_SHADOW_NONE),
                           CHOICE("accumulate", accumulate, 1),
                           CHOICE("direct", radiance, SSGI_GL_RADIANCE_DIRECT),
                           CHOICE("both", radiance, SSGI_GL_RADIANCE_BOTH),
                           CHOICE("albedos", radiance, SSGI_GL_RADIANCE_ALBEDO),
                           CHOICE("objects", objects, SSGI_GL_OBJECTS_TEXTURE),
                           CHOICE("customobjects", objects, SSGI_GL_OBJECTS_CUSTOM),
                           CHOICE("captable", cap_table, 1),
                           CHOICE("light", effect, SSGI_GL_EFFECT_LIGHT),
                           CHOICE("bounce", effect, SSGI_GL_EFFECT_BOUNCE),
                           CHOICE("specular", effect, SSGI_GL_EFFECT_SPECULAR),
                           CHOICE("scatter", effect, SSGI_GL_EFFECT_SCATTER),
                           CHOICE("customeffect", effect, SSGI_GL_EFFECT_CUSTOM),
                           CHOICE("levels", levels, 6),
                           CHOICE("tessellate", tessellate, 1),
                           CHOICE("centroid", overhang, SSGI_OVERHANG_CENTROID),
                           CHOICE("lit", sends, SSGI_GL_SENDS_LIGHTS),
                           CHOICE("customlight", sends, SSGI_GL_SENDS_CUSTOM),
                           CHOICE("near", near_samples, 4),
                           CHOICE("enlarge", enlarge, 1),
                           CHOICE("add", combine, SSGI_GL_COMBINE_ADD),
                           CHOICE("span", span, 4),
                           CHOICE("vertical", axis, 1),
                           CHOICE("half", half, 1),
                           CHOICE("turns", half, 2),
                           CHOICE("colour", colour, SSGI_GL_COLOUR),
                           CHOICE("vectors", colour, SSGI_GL_COEFFICIENTS),
                           CHOICE("motion", motion, 1),
                           CHOICE("gaussian", filter, SSGI_GL_GAUSSIAN),
                           CHOICE("normals", filter_normals, 1),
                           CHOICE("lefthanded", left_handed, 1),
                           CHOICE("oblique", oblique, 1),
                           CHOICE("multisampled", multisampled, 1),
                           CHOICE("array", array, 1) };
const int choices_count = (int)(sizeof choices / sizeof choices[0]);

const variant variants[] = {
    { "`ssao`", { .pass = SSGI_GL_SSAO } },
    { "`hsao`, slices", { .pass = SSGI_GL_HSAO } },
    { "`hsao`, march", { .pass = SSGI_GL_HSAO, .search = SSGI_GL_MARCH } },
    { "`ssdo`, map", { .pass = SSGI_GL_SSDO, .environment = SSGI_GL_ENVIRONMENT_MAP } },
    { "`ssdo`, sh", { .pass = SSGI_GL_SSDO, .environment = SSGI_GL_ENVIRONMENT_SH } },
    { "`ssdo`, bounce", { .pass = SSGI_GL_SSDO, .bounce = SSGI_GL_BOUNCE_SOLID_ANGLE } },
    { "`s3ho`", { .pass = SSGI_GL_S3HO } },
    { "`s3ho`, transfer, packed", { .pass = SSGI_GL_S3HO, .transfer = SSGI_GL_TRANSFER_BOTH, .packed = 1 } },
    { "`s3ho`, transfer, packed, dimmed",
      { .pass = SSGI_GL_S3HO, .transfer = SSGI_GL_TRANSFER_BOTH, .packed = 1, .dimmed = 1 } },
    { "`s3ho`, shaded", { .pass = SSGI_GL_S3HO, .shaded = 1 } },
    { "`lights`", { .pass = SSGI_GL_LIGHTS } },
    { "`lights`, maps", { .pass = SSGI_GL_LIGHTS, .shadow = SSGI_GL_SHADOW_FILL } },
    { "`senders`", { .pass = SSGI_GL_SENDERS } },
    { "`shade`", { .pass = SSGI_GL_SHADE } },
    { "`shade`, packed, lights", { .pass = SSGI_GL_SHADE, .packed = 1, .lights = 1 } },
    { "`shade`, bent cone", { .pass = SSGI_GL_SHADE, .shading = SSGI_GL_SHADING_BENT_CONE } },
    { "`field`", { .pass = SSGI_GL_FIELD } },
    { "`field`, objects", { .pass = SSGI_GL_FIELD, .objects = SSGI_GL_OBJECTS_TEXTURE } },
    { "`field`, cap table", { .pass = SSGI_GL_FIELD, .cap_table = 1 } },
    { "`surfels`, from triangles", { .pass = SSGI_GL_SURFELS, .dialect = SSGI_GL_410, .tessellate = 1 } },
    { "`surfels`, lit", { .pass = SSGI_GL_SURFELS, .sends = SSGI_GL_SENDS_LIGHTS } },
    { "`shuffle`", { .pass = SSGI_GL_SHUFFLE } },
    { "`splat`, occlusion", { .pass = SSGI_GL_SPLAT } },
    { "`splat`, light", { .pass = SSGI_GL_SPLAT, .effect = SSGI_GL_EFFECT_LIGHT } },
    { "`unshuffle`", { .pass = SSGI_GL_UNSHUFFLE } },
    { "`smooth`", { .pass = SSGI_GL_SMOOTH } },
    { "`sum`", { .pass = SSGI_GL_SUM } },
    { "`blur`", { .pass = SSGI_GL_BLUR } },
    { "`blur`, colour", { .pass = SSGI_GL_BLUR, .colour = SSGI_GL_COLOUR } },
    { "`blur`, vectors", { .pass = SSGI_GL_BLUR, .colour = SSGI_GL_COEFFICIENTS } },
    { "`history`", { .pass = SSGI_GL_HISTORY } },
    { "`history`, colour", { .pass = SSGI_GL_HISTORY, .colour = SSGI_GL_COLOUR } },
    { "`history`, motion", { .pass = SSGI_GL_HISTORY, .motion = 1 } },
    { "`changes`", { .pass = SSGI_GL_CHANGES } },
    { "`changes`, colour", { .pass = SSGI_GL_CHANGES, .colour = SSGI_GL_COLOUR } },
    { "`changes`, motion", { .pass = SSGI_GL_CHANGES, .motion = 1 } },
    { "`nearby`", { .pass = SSGI_GL_NEARBY } },
    { "`compose`", { .pass = SSGI_GL_COMPOSE } },
    { "`width`", { .pass = SSGI_GL_WIDTH } }
};
const int variants_count = (int)(sizeof variants / sizeof variants[0]);

ssgi_gl_desc with_choice(ssgi_gl_desc d, int c)
{
    if (c) memcpy((char *)&d + choices[c].offset, &choices[c].value, sizeof(int));
    if (d.depth == SSGI_GL_DEPTH_CUSTOM || d.normal == SSGI_GL_NORMAL_CUSTOM || d.objects == SSGI_GL_OBJECTS_CUSTOM
        || d.harmonics == SSGI_GL_HARMONICS_CUSTOM
        || (d.sends == SSGI_GL_SENDS_CUSTOM && (d.pass == SSGI_GL_SURFELS || d.pass == SSGI_GL_SPLAT))
        || (d.effect == SSGI_GL_EFFECT_CUSTOM
            && (d.pass == SSGI_GL_SPLAT || d.pass == SSGI_GL_UNSHUFFLE || d.pass == SSGI_GL_SMOOTH
                || d.pass == SSGI_GL_SUM)))
        d.fetch = d.dialect == SSGI_GL_VULKAN ? custom_vulkan : custom;
    return d;
}
