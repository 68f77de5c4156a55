/* truth.c - the ray-traced ground truth of a method's result. Declared in kit_gl.h. */
#include "kit/kit_run.h"
#include <math.h>

/* Ray-traces deep screen space, without attenuation: occluders and emitters have full weight within the radius. */
static int trace_deep(kit_image *out, const kit_method *m, const kit_scene *scene, const kit_camera *camera,
                      const kit_lighting *lighting, float radius, int rays, int stride, kit_error *err)
{
    ssgi_dipole dipole;
    if (m->effect == SSGI_GL_EFFECT_SCATTER) {
        const kit_material *of = kit_material_of(m->set.material);
        if (ssgi_dipole_set(&dipole, of->sigma_s, of->sigma_a, of->eta, NULL) != SSGI_OK)
            return kit_fail(err, "--set material=%s: has no dipole", of->name);
        return kit_truth_scatter(out, scene, camera, lighting, &dipole, (float)m->set.unit, 1000 * (size_t)rays, stride,
                                 err);
    }
    if (m->effect == SSGI_GL_EFFECT_SPECULAR)
        return kit_truth_gloss(out, scene, camera, lighting, radius, KIT_ATTENUATION_NONE, m->set.exponent, rays,
                               stride, err);
    return kit_truth_lit(out, scene, camera, lighting, radius, KIT_ATTENUATION_NONE, m->set.bounce, rays, stride, err);
}

int kit_method_truth(kit_image *out, const kit_method *m, const kit_scene *scene, const kit_camera *camera,
                     const kit_lighting *lighting, float radius, int rays, int stride, kit_error *err)
{
    const int attenuation = kit_method_attenuation(m);
    if (m->effect != SSGI_GL_EFFECT_OCCLUSION)
        return trace_deep(out, m, scene, camera, lighting, radius, rays, stride, err);
    if (m->lit) {
        const int vpls = m->set.vpls > 0, bounce = m->set.bounce || m->set.indirect || vpls;
        const int all = m->set.suns || vpls; /* shadows have unlimited range */
        return kit_truth_lit(out, scene, camera, lighting, all ? INFINITY : radius,
                             all ? KIT_ATTENUATION_NONE : attenuation, bounce, rays, stride, err);
    }
    if (m->between) return kit_truth_objects(out, scene, camera, rays, stride, err);
    return kit_truth_ao(out, scene, camera, radius, attenuation, rays, stride, err);
}

int kit_method_attenuation(const kit_method *m)
{
    static const int falloffs[] = { KIT_ATTENUATION_LINEAR, KIT_ATTENUATION_SQUARE, KIT_ATTENUATION_NONE };
    return falloffs[m->set.falloff];
}
