/* choices.c - the descs of every pass, with the values of fields that change their shaders. Declared in choices.h. */
#include "tools/glsl/choices.h"
#include <ctype.h>
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

int choice_at(choice *c, int i)
{
    const ssgi_gl_choice *field;
    *c = (choice){ "", 0, 0 };
    if (!i--) return 1;
    for (int k = 0; (field = ssgi_gl_choice_at(k)) != NULL; ++k) {
        const int each = *field->values || field->most <= 4, values = each ? field->most : 1;
        if (!strcmp(field->name, "pass") || !strncmp(field->field, "shader.", 7)) continue;
        if (i >= values) {
            i -= values;
            continue;
        }
        c->offset = field->offset;
        c->value = each ? i + 1 : 3;
        const char *word = field->values;
        for (int w = 0; w < c->value && *word; ++w) word += strcspn(word, " ") + 1;
        if (*word) snprintf(c->name, sizeof c->name, "%s-%.*s", field->name, (int)strcspn(word, " "), word);
        else if (field->most > 1) snprintf(c->name, sizeof c->name, "%s-%d", field->name, c->value);
        else snprintf(c->name, sizeof c->name, "%s", field->name);
        for (char *at = c->name; *at; ++at) *at = (char)tolower((unsigned char)*at);
        return 1;
    }
    return 0;
}

/* A table of sections of PASSES.md, in addition to each pass's plain section, by heading: the desc. */
typedef struct section { const char *which; ssgi_gl_desc desc; } section;
static const section sections[] = {
    { "march", { .pass = SSGI_GL_PASS_HSAO, .gather.search = SSGI_GL_SEARCH_MARCH } },
    { "map", { .pass = SSGI_GL_PASS_SSDO, .light.environment = SSGI_GL_ENVIRONMENT_MAP } },
    { "sh", { .pass = SSGI_GL_PASS_SSDO, .light.environment = SSGI_GL_ENVIRONMENT_SH } },
    { "bounce", { .pass = SSGI_GL_PASS_SSDO, .light.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE } },
    { "transfer, packed",
      { .pass = SSGI_GL_PASS_S3HO, .light.transfer = SSGI_GL_TRANSFER_BOTH, .light.packed_coefficients = 1 } },
    { "transfer, packed, dimmed",
      { .pass = SSGI_GL_PASS_S3HO, .light.transfer = SSGI_GL_TRANSFER_BOTH, .light.packed_coefficients = 1,
        .light.occluded_emitters = 1 } },
    { "shaded", { .pass = SSGI_GL_PASS_S3HO, .light.shaded = 1 } },
    { "maps", { .pass = SSGI_GL_PASS_LIGHTS, .light.shadow = SSGI_GL_SHADOW_FILL } },
    { "packed, lights", { .pass = SSGI_GL_PASS_SHADE, .light.packed_coefficients = 1, .light.harmonic_lights = 1 } },
    { "bent cone", { .pass = SSGI_GL_PASS_SHADE, .light.shading = SSGI_GL_SHADING_BENT_CONE } },
    { "objects", { .pass = SSGI_GL_PASS_AOF, .input.objects = SSGI_GL_OBJECTS_TEXTURE } },
    { "cap table", { .pass = SSGI_GL_PASS_AOF, .input.cap_table = 1 } },
    { "from triangles",
      { .pass = SSGI_GL_PASS_SURFELS, .shader.dialect = SSGI_GL_DIALECT_410, .surfel.tessellate = 1 } },
    { "lit", { .pass = SSGI_GL_PASS_SURFELS, .surfel.sends = SSGI_GL_SENDS_LIGHTS } },
    { "light", { .pass = SSGI_GL_PASS_DSS, .surfel.effect = SSGI_GL_EFFECT_LIGHT } },
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
    choice changed;
    if (c && choice_at(&changed, c)) memcpy((char *)&d + changed.offset, &changed.value, sizeof(int));
    if (d.input.depth == SSGI_GL_DEPTH_CUSTOM || d.input.normal == SSGI_GL_NORMAL_CUSTOM
        || d.input.objects == SSGI_GL_OBJECTS_CUSTOM || d.light.harmonics == SSGI_GL_HARMONICS_CUSTOM
        || (d.surfel.sends == SSGI_GL_SENDS_CUSTOM && (d.pass == SSGI_GL_PASS_SURFELS || d.pass == SSGI_GL_PASS_DSS))
        || (d.surfel.effect == SSGI_GL_EFFECT_CUSTOM
            && (d.pass == SSGI_GL_PASS_DSS || d.pass == SSGI_GL_PASS_DEINTERLEAVE || d.pass == SSGI_GL_PASS_SMOOTH
                || d.pass == SSGI_GL_PASS_SUM)))
        d.shader.fetch = d.shader.dialect == SSGI_GL_DIALECT_VULKAN ? custom_vulkan : custom;
    return d;
}
