/* order.c - prints each pass by its name, with its shader, preset and steps. order.sh compares two orders of their
   enum. */
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "ssgi_gl.h"

#include <stdio.h>

static void print_steps(const ssgi_gl_chain *chain)
{
    static ssgi_gl_step step[64];
    const int count = ssgi_gl_steps(step, 64, chain, NULL);
    for (int i = 0; i < count; ++i) {
        const ssgi_gl_step *const s = &step[i];
        printf("; %s %llx, scale %d %dx%d, draw %x %d %d, blend %x %x %x %d %g", ssgi_gl_pass_name(s->desc.pass),
               (unsigned long long)ssgi_gl_key(&s->desc), s->scale, s->width, s->height, s->primitive, s->vertices,
               s->instances, s->blend[0], s->blend[1], s->blend[2], s->clear, (double)s->clear_to);
        for (int k = 0; k < s->outputs; ++k)
            printf(", %s %s %d %d", s->output[k].name, s->output[k].format ? s->output[k].format->name : "",
                   s->output[k].texture, s->output[k].kept);
    }
}

int main(void)
{
    for (int pass = 0; pass < SSGI_GL_PASSES; ++pass)
        for (int k = 0; k < 64; ++k) {
            ssgi_gl_desc d = { 0 };
            ssgi_gl_chain chain = { 0 };
            d.pass = pass;
            d.shader.dialect = SSGI_GL_DIALECT_450;
            d.gather.resolution = k & 1;
            d.gather.thickness = k & 1 ? SSGI_GL_THICKNESS_SLABS : SSGI_GL_THICKNESS_DEFAULT;
            d.surfel.tessellate = k >> 1 & 1;
            d.gather.search = !(k & 4)                  ? SSGI_GL_SEARCH_SLICES
                            : pass == SSGI_GL_PASS_HSAO ? SSGI_GL_SEARCH_MARCH
                                                        : SSGI_GL_SEARCH_POINTS;
            d.light.environment = SSGI_GL_ENVIRONMENT_SH;
            d.light.bounce = k >> 3 & 1 ? SSGI_GL_BOUNCE_SOLID_ANGLE : SSGI_GL_BOUNCE_NONE;
            d.surfel.effect = k >> 4 & 1 ? SSGI_GL_EFFECT_LIGHT : SSGI_GL_EFFECT_OCCLUSION;
            d.filter.onto = k >> 5 & 1 ? SSGI_GL_ONTO_MULTIPLY : SSGI_GL_ONTO_NONE;
            chain.desc = d;
            chain.lights.pass = d.light.bounce ? SSGI_GL_PASS_LIGHTS : SSGI_GL_PASS_BLUR;
            chain.blur = 1;
            chain.history = chain.surfels = d.surfel.tessellate;
            chain.width = 640;
            chain.height = 360;
            printf("%s %d: %llx", ssgi_gl_pass_name(pass), k, (unsigned long long)ssgi_gl_key(&d));
            print_steps(&chain);
            ssgi_gl_preset(&d, SSGI_GL_PRESET_FAST, NULL);
            printf("; %d %d %d %d\n", d.gather.resolution, d.gather.samples, d.gather.slices, d.gather.directions);
        }
    return 0;
}
