/* choices.c - the passes, and the choices that change their text, one at a time. Declared in choices.h. */
#include "tools/glsl/choices.h"
#include <stddef.h>
#include <stdio.h>
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
                           CHOICE("orthographic", input.orthographic, 1),
                           CHOICE("linear", input.depth, SSGI_GL_DEPTH_LINEAR),
                           CHOICE("customdepth", input.depth, SSGI_GL_DEPTH_CUSTOM),
                           CHOICE("unsigned", input.normal, SSGI_GL_NORMAL_UNSIGNED),
                           CHOICE("octahedral", input.normal, SSGI_GL_NORMAL_OCTAHEDRAL),
                           CHOICE("fromdepth", input.normal, SSGI_GL_NORMAL_FROM_DEPTH),
                           CHOICE("customnormal", input.normal, SSGI_GL_NORMAL_CUSTOM),
                           CHOICE("world", input.world_normals, 1),
                           CHOICE("jitter", gather.noise, SSGI_GL_NOISE_TEXTURE),
                           CHOICE("points", gather.search, SSGI_GL_SEARCH_POINTS),
                           CHOICE("march", gather.search, SSGI_GL_SEARCH_MARCH),
                           CHOICE("rays", gather.normal_rays, 1),
                           CHOICE("normalterm", gather.terms, SSGI_GL_TERMS_NORMAL),
                           CHOICE("raysterm", gather.terms, SSGI_GL_TERMS_RAYS),
                           CHOICE("spheres", gather.spheres, 1),
                           CHOICE("nofalloff", gather.falloff, SSGI_GL_FALLOFF_NONE),
                           CHOICE("facets", gather.facets, 1),
                           CHOICE("lift", gather.lift, 1),
                           CHOICE("solid", gather.thickness, SSGI_GL_THICKNESS_SOLID),
                           CHOICE("width", gather.thickness, SSGI_GL_THICKNESS_WIDTH),
                           CHOICE("back", gather.thickness, SSGI_GL_THICKNESS_BACK),
                           CHOICE("slabs", gather.thickness, SSGI_GL_THICKNESS_SLABS),
                           CHOICE("steps", gather.steps, 3),
                           CHOICE("square", gather.falloff, SSGI_GL_FALLOFF_SQUARE),
                           CHOICE("kernel", gather.kernel, 1),
                           CHOICE("uniform", gather.uniform, 1),
                           CHOICE("fade", gather.fade, SSGI_GL_FADE_SMOOTH),
                           CHOICE("lambda", gather.fade, SSGI_GL_FADE_LAMBDA),
                           CHOICE("range", gather.range, 1),
                           CHOICE("layers", gather.layers, 2),
                           CHOICE("receiver", light.receiver, 1),
                           CHOICE("views", gather.views, 2),
                           CHOICE("viewlayers", gather.view_layers, 2),
                           CHOICE("sh", light.environment, SSGI_GL_ENVIRONMENT_SH),
                           CHOICE("solidangle", light.bounce, SSGI_GL_BOUNCE_SOLID_ANGLE),
                           CHOICE("patch", light.bounce, SSGI_GL_BOUNCE_PATCH),
                           CHOICE("twosided", light.two_sided, 1),
                           CHOICE("onesided", light.one_sided, 1),
                           CHOICE("clamp", light.clamp, 1),
                           CHOICE("1band", light.bands, 1),
                           CHOICE("2bands", light.bands, 2),
                           CHOICE("3bands", light.bands, 3),
                           CHOICE("4bands", light.bands, 4),
                           CHOICE("packed", light.packed, 1),
                           CHOICE("transfer", light.transfer, SSGI_GL_TRANSFER_BOTH),
                           CHOICE("reflected", light.transfer, SSGI_GL_TRANSFER_REFLECTED),
                           CHOICE("dimmed", light.dimmed, 1),
                           CHOICE("shaded", light.shaded, 1),
                           CHOICE("customharmonics", light.harmonics, SSGI_GL_HARMONICS_CUSTOM),
                           CHOICE("residual", light.residual, 1),
                           CHOICE("bentnormal", light.shading, SSGI_GL_SHADING_BENT_NORMAL),
                           CHOICE("bentcone", light.shading, SSGI_GL_SHADING_BENT_CONE),
                           CHOICE("bent", light.shading, SSGI_GL_SHADING_BENT),
                           CHOICE("lights", light.lights, 1),
                           CHOICE("albedo", light.albedo, 1),
                           CHOICE("map", light.shadow, SSGI_GL_SHADOW_MAP),
                           CHOICE("fill", light.shadow, SSGI_GL_SHADOW_FILL),
                           CHOICE("unshadowed", light.shadow, SSGI_GL_SHADOW_NONE),
                           CHOICE("accumulate", light.accumulate, 1),
                           CHOICE("bounced", light.bounced, 1),
                           CHOICE("direct", light.radiance, SSGI_GL_RADIANCE_DIRECT),
                           CHOICE("both", light.radiance, SSGI_GL_RADIANCE_BOTH),
                           CHOICE("albedos", light.radiance, SSGI_GL_RADIANCE_ALBEDO),
                           CHOICE("objects", input.objects, SSGI_GL_OBJECTS_TEXTURE),
                           CHOICE("customobjects", input.objects, SSGI_GL_OBJECTS_CUSTOM),
                           CHOICE("captable", input.cap_table, 1),
                           CHOICE("light", surfel.effect, SSGI_GL_EFFECT_LIGHT),
                           CHOICE("bounce", surfel.effect, SSGI_GL_EFFECT_BOUNCE),
                           CHOICE("specular", surfel.effect, SSGI_GL_EFFECT_SPECULAR),
                           CHOICE("scatter", surfel.effect, SSGI_GL_EFFECT_SCATTER),
                           CHOICE("customeffect", surfel.effect, SSGI_GL_EFFECT_CUSTOM),
                           CHOICE("levels", surfel.levels, 6),
                           CHOICE("tessellate", surfel.tessellate, 1),
                           CHOICE("centroid", surfel.overhang, SSGI_OVERHANG_CENTROID),
                           CHOICE("lit", surfel.sends, SSGI_GL_SENDS_LIGHTS),
                           CHOICE("customlight", surfel.sends, SSGI_GL_SENDS_CUSTOM),
                           CHOICE("near", surfel.near_samples, 4),
                           CHOICE("enlarge", surfel.enlarge, 1),
                           CHOICE("add", surfel.combine, SSGI_GL_COMBINE_ADD),
                           CHOICE("span", surfel.span, 4),
                           CHOICE("vertical", surfel.axis, 1),
                           CHOICE("half", gather.half, 1),
                           CHOICE("turns", gather.half, 2),
                           CHOICE("colour", filter.quantity, SSGI_GL_QUANTITY_LIGHT),
                           CHOICE("coefficients", filter.quantity, SSGI_GL_QUANTITY_COEFFICIENTS),
                           CHOICE("motion", input.motion, 1),
                           CHOICE("gaussian", filter.kind, SSGI_GL_FILTER_GAUSSIAN),
                           CHOICE("normals", filter.normals, 1),
                           CHOICE("radius2", filter.radius, 2),
                           CHOICE("lefthanded", input.left_handed, 1),
                           CHOICE("oblique", input.oblique, 1),
                           CHOICE("multisampled", input.multisampled, 1),
                           CHOICE("array", input.array, 1) };
const int choices_count = (int)(sizeof choices / sizeof choices[0]);

/* Sections of PASSES.md beside the plain one that each pass has. */
typedef struct section { const char *which; ssgi_gl_desc desc; } section;
static const section sections[] = {
    { "march", { .pass = SSGI_GL_PASS_HSAO, .gather.search = SSGI_GL_SEARCH_MARCH } },
    { "map", { .pass = SSGI_GL_PASS_SSDO, .light.environment = SSGI_GL_ENVIRONMENT_MAP } },
    { "sh", { .pass = SSGI_GL_PASS_SSDO, .light.environment = SSGI_GL_ENVIRONMENT_SH } },
    { "bounce", { .pass = SSGI_GL_PASS_SSDO, .light.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE } },
    { "transfer, packed",
      { .pass = SSGI_GL_PASS_S3HO, .light.transfer = SSGI_GL_TRANSFER_BOTH, .light.packed = 1 } },
    { "transfer, packed, dimmed",
      { .pass = SSGI_GL_PASS_S3HO, .light.transfer = SSGI_GL_TRANSFER_BOTH, .light.packed = 1, .light.dimmed = 1 } },
    { "shaded", { .pass = SSGI_GL_PASS_S3HO, .light.shaded = 1 } },
    { "maps", { .pass = SSGI_GL_PASS_LIGHTS, .light.shadow = SSGI_GL_SHADOW_FILL } },
    { "packed, lights", { .pass = SSGI_GL_PASS_SHADE, .light.packed = 1, .light.lights = 1 } },
    { "bent cone", { .pass = SSGI_GL_PASS_SHADE, .light.shading = SSGI_GL_SHADING_BENT_CONE } },
    { "objects", { .pass = SSGI_GL_PASS_FIELD, .input.objects = SSGI_GL_OBJECTS_TEXTURE } },
    { "cap table", { .pass = SSGI_GL_PASS_FIELD, .input.cap_table = 1 } },
    { "from triangles",
      { .pass = SSGI_GL_PASS_SURFELS, .text.dialect = SSGI_GL_DIALECT_410, .surfel.tessellate = 1 } },
    { "lit", { .pass = SSGI_GL_PASS_SURFELS, .surfel.sends = SSGI_GL_SENDS_LIGHTS } },
    { "light", { .pass = SSGI_GL_PASS_SPLAT, .surfel.effect = SSGI_GL_EFFECT_LIGHT } },
    { "light", { .pass = SSGI_GL_PASS_BLUR, .filter.quantity = SSGI_GL_QUANTITY_LIGHT } },
    { "coefficients", { .pass = SSGI_GL_PASS_BLUR, .filter.quantity = SSGI_GL_QUANTITY_COEFFICIENTS } },
    { "light", { .pass = SSGI_GL_PASS_HISTORY, .filter.quantity = SSGI_GL_QUANTITY_LIGHT } },
    { "motion", { .pass = SSGI_GL_PASS_HISTORY, .input.motion = 1 } },
    { "light", { .pass = SSGI_GL_PASS_CHANGE_MASK, .filter.quantity = SSGI_GL_QUANTITY_LIGHT } },
    { "motion", { .pass = SSGI_GL_PASS_CHANGE_MASK, .input.motion = 1 } }
};

int variant_at(variant *v, int i)
{
    for (int pass = 0; pass < SSGI_GL_PASSES; ++pass)
        for (int k = -1; k < (int)(sizeof sections / sizeof *sections); ++k) {
            const section of = k < 0 ? (section){ "", { .pass = pass } } : sections[k];
            if ((int)of.desc.pass != pass || ssgi_gl_check(&of.desc, NULL) != SSGI_OK || i--) continue;
            snprintf(v->title, sizeof v->title, "%s%s%s", ssgi_gl_pass_name(pass), *of.which ? ", " : "", of.which);
            v->desc = of.desc;
            return 1;
        }
    return 0;
}

ssgi_gl_desc with_choice(ssgi_gl_desc d, int c)
{
    if (c) memcpy((char *)&d + choices[c].offset, &choices[c].value, sizeof(int));
    if (d.input.depth == SSGI_GL_DEPTH_CUSTOM || d.input.normal == SSGI_GL_NORMAL_CUSTOM
        || d.input.objects == SSGI_GL_OBJECTS_CUSTOM || d.light.harmonics == SSGI_GL_HARMONICS_CUSTOM
        || (d.surfel.sends == SSGI_GL_SENDS_CUSTOM && (d.pass == SSGI_GL_PASS_SURFELS || d.pass == SSGI_GL_PASS_SPLAT))
        || (d.surfel.effect == SSGI_GL_EFFECT_CUSTOM
            && (d.pass == SSGI_GL_PASS_SPLAT || d.pass == SSGI_GL_PASS_DEINTERLEAVE || d.pass == SSGI_GL_PASS_SMOOTH
                || d.pass == SSGI_GL_PASS_SUM)))
        d.text.fetch = d.text.dialect == SSGI_GL_DIALECT_VULKAN ? custom_vulkan : custom;
    return d;
}
