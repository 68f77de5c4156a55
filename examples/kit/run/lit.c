/* lit.c - adds methods that compute light, by directional occlusion or by harmonics. Declared in kit_run.h. */
#include "kit/kit_run.h"
#include <stdlib.h>
#include <string.h>

/* Adds the residual: the unoccluded irradiance of the environment and the suns, minus that of their harmonics. */
static int add_residual(kit_making *m, const ssgi_sun *suns, int count)
{
    enum { OPEN = 32 };
    const kit_image *env = &m->world->lighting->env;
    kit_run *run = m->run;
    const char *why = "out of memory";
    float *map = calloc(3 * OPEN * OPEN, sizeof *map), *four = malloc(4 * OPEN * OPEN * sizeof *four);
    const int failed =
        !map || !four
        || (env->data && kit_environment_of(map, OPEN, run->equirect, env, 0, 0, &why) != SSGI_OK)
        || ssgi_sh_residual(map, OPEN, run->harmonics, m->desc.light.bands, suns, count, &why) != SSGI_OK
        || !(run->irradiance = kit_keep(run, kit_texture_array(OPEN, OPEN, 1, GL_RGBA32F, kit_rgba(four, map, OPEN))));
    free(map);
    free(four);
    return failed ? kit_fail(m->err, "harmonics: %s", why) : 0;
}

/* Adds the lights of s3ho: suns as lobes of the environment's harmonics, the residual of all harmonics, and the other
   lights, which depend on a pixel's place; it moves these to the front of placed. */
static int add_harmonics(kit_making *m, kit_placed_light *placed, int *count)
{
    const int window = m->set->window, bands = m->desc.light.bands;
    kit_run *run = m->run;
    const char *why = "";
    ssgi_sun suns[KIT_MAX_LIGHTS];
    int left = 0, n = 0, failed = 0;
    for (int i = 0; i < *count && !failed; ++i) {
        const ssgi_gl_light *l = &placed[i].light;
        if (l->kind > 0 || m->desc.light.shading) { placed[left++] = placed[i]; continue; }
        memcpy(suns[n].direction, l->at, sizeof suns[n].direction);
        memcpy(suns[n].irradiance, l->colour, sizeof suns[n].irradiance);
        failed = ssgi_sh_light(run->harmonics, bands, l->at, 0, suns[n++].irradiance, window, &why) != SSGI_OK;
    }
    *count = left;
    memset(run->frame.window, 0, sizeof run->frame.window);
    ssgi_sh_window(run->frame.window, bands, window);
    if (failed) return kit_fail(m->err, "harmonics: %s", why);
    return m->desc.light.residual && !m->desc.light.shading ? add_residual(m, suns, n) : 0;
}

/* Adds the passes of s3ho. indirect: 0 no bounce, 1 in one gather with the occlusion, 2 in a gather of its own. For 1,
   a second gather without the bounce shows which part of the result is the bounce. */
static int add_harmonic_light(kit_making *m)
{
    kit_run *run = m->run;
    const int indirect = m->set->indirect, joint = indirect == KIT_INDIRECT_JOINT, store = m->set->store;
    ssgi_gl_chain chain = kit_chain(m), bounce;
    chain.coefficients = m->set->filtered == KIT_FILTERED_COEFFICIENTS;
    chain.precise = store == KIT_STORE_FLOAT ? 2 : 1;
    /* The coefficients of both gathers are packed or neither's are, so that both have the same rounding. */
    chain.desc.light.packed_coefficients = store == KIT_STORE_PACKED || joint;
    chain.desc.light.shaded = !chain.coefficients && !chain.desc.light.shading && !chain.desc.light.harmonic_lights;
    bounce = chain;
    bounce.desc.light.packed_coefficients = 1;
    bounce.desc.light.transfer = joint ? SSGI_GL_TRANSFER_BOTH : SSGI_GL_TRANSFER_REFLECTED;
    /* occluders can send more light than they block, which no ratio restores */
    if (chain.desc.light.restore) bounce.desc.light.restore = SSGI_GL_RESTORE_DIFFERENCE;
    if (joint) chain.desc.light.restore = bounce.desc.light.restore;
    if (m->rows[0] && m->set->lights == KIT_LIGHTS_SHADOWED) chain.lights = m->lights;
    /* the only lights have shadow maps, so that no light needs coefficients */
    if (chain.lights.pass == SSGI_GL_PASS_LIGHTS && !m->world->lighting->env.data) {
        chain.desc.pass = SSGI_GL_PASS_SSDO;
        chain.desc.light.environment = SSGI_GL_ENVIRONMENT_NONE;
        chain.desc.light.bounce = SSGI_GL_BOUNCE_NONE;
        return kit_add_steps(m, &chain, 0, &run->light, NULL);
    }
    if ((indirect && kit_add_steps(m, &bounce, 0, &run->bounce, NULL))
        || kit_add_steps(m, &chain, joint, &run->light, NULL))
        return -1;
    if (joint) {
        const kit_pass *last = &run->pass[run->passes - 1];
        run->joint = run->light;
        for (int k = 0; k < last->step->inputs && last->desc.pass == SSGI_GL_PASS_LIGHTS; ++k)
            if (!strcmp(last->step->input[k].name, "t_ssgi_light")) run->joint = last->input[k];
    }
    return 0;
}

/* Adds the passes of ssdo: the direct light, then its bounce. vpls: virtual point lights give the bounce, and the
   gather the part that their clamp removes. */
static int add_occluded_light(kit_making *m, const kit_placed_light *placed, int direct, int count,
                              const float picture[16])
{
    kit_run *run = m->run;
    ssgi_gl_chain chain = kit_chain(m);
    chain.reuse = m->set->reuse > 0;
    chain.bounced = m->set->bounced > 0;
    chain.vpls = m->set->vpls > 0;
    chain.direct = run->gbuffer->direct != 0;
    if (m->rows[0]) chain.lights = m->lights;
    if (!chain.desc.light.environment && !m->rows[0] && !chain.direct) return 0;     /* there is no light */
    if (kit_add_steps(m, &chain, 0, &run->light, &run->bounce)) return -1;
    for (int i = 0; i < run->passes; ++i)
        if (run->pass[i].step->frame == KIT_FRAME_VPLS)
            run->pass[i].lights = kit_keep(run, kit_light_rows(placed, direct, count, picture));
    run->vpls = count - direct;
    return 0;
}

/* Adds shadow maps of the placed lights, the extra cameras, and the lights in the view space of each camera. */
static int add_sources(kit_making *m, const kit_placed_light *placed, int direct, int count, const float picture[16],
                       const kit_sphere *middle)
{
    kit_run *run = m->run;
    if (m->desc.gather.views && kit_add_views(m, picture, middle)) return -1;
    if (kit_add_atlas(m, placed, count)) return -1;
    for (int v = -1; v < run->views && direct; ++v) {
        float to[16], projection[16];
        if (v >= 0) kit_camera_matrices(&run->view[v].camera, to, projection);
        m->rows[1 + v] = kit_keep(run, kit_light_rows(placed, 0, direct, v < 0 ? picture : to));
        if (!m->rows[1 + v]) return kit_fail(m->err, "no memory for %d lights", direct);
    }
    return 0;
}

int kit_open_lit(kit_making *m, const float picture[16])
{
    static const int environments[] = { SSGI_GL_ENVIRONMENT_MAP, SSGI_GL_ENVIRONMENT_SH, SSGI_GL_ENVIRONMENT_NONE };
    const kit_settings *set = m->set;
    const kit_image *env = &m->world->lighting->env;
    kit_run *run = m->run;
    kit_gbuffer *g = run->gbuffer;
    const int s3ho = m->desc.pass == SSGI_GL_PASS_S3HO, harmonics = s3ho && set->lights == KIT_LIGHTS_HARMONICS;
    int count = 0, direct = 0, failed = 0;
    kit_seen_places seen;
    if (s3ho && set->indirect && g->direct)
        return kit_fail(m->err, "method %s: its bounce has only --env and --light, and would lack the frame's "
                                "direct.R ..: take ssdo, or --set indirect=none", m->method->name);
    if (!env->data) m->desc.light.shading = SSGI_GL_SHADING_HARMONICS;
    m->desc.light.environment = env->data && !set->suns ? environments[set->environment] : SSGI_GL_ENVIRONMENT_NONE;
    if (s3ho) m->desc.light.environment = SSGI_GL_ENVIRONMENT_SH;
    if (!m->blurred || !m->desc.light.environment) m->desc.light.restore = 0;
    if (env->data && kit_add_environment(m)) return -1;
    kit_rotation_of(run->frame.rotation, picture, NULL);
    if (kit_seen(g, &seen, m->err)) return -1;
    kit_placed_light *placed = kit_placed_lights_new(m, &seen, &count, &direct);
    free(seen.point);
    if (!placed) return -1;
    if (s3ho) {
        int lobes = harmonics ? direct : 0;
        failed = add_harmonics(m, placed, &lobes);
        if (harmonics) count = direct = lobes;
        m->desc.light.harmonic_lights = lobes > 0;
    }
    if (m->desc.light.residual && !s3ho && m->desc.light.environment == SSGI_GL_ENVIRONMENT_SH)
        failed = add_residual(m, NULL, 0);
    ssgi_gl_harmonics_set(&run->frame, run->harmonics, m->desc.light.bands, picture, NULL);
    run->frame.lights = direct;
    failed = failed || add_sources(m, placed, direct, count, picture, &seen.middle);
    if (!failed && !g->albedo) kit_add_grey(m);
    failed = failed || (s3ho ? add_harmonic_light(m) : add_occluded_light(m, placed, direct, count, picture));
    free(placed);
    return failed ? -1 : 0;
}
