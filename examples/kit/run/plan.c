/* plan.c - measures a scene from a G-buffer for ssgi_plan_make, and turns the plan into a method of the kit. Declared
   in kit_gl.h. */
#include "kit/kit_run.h"
#include "kit/kit_trace.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PLACES = 8000, PLACE_RAYS = 64, LIGHT_PLACES = 3000, LIGHT_RAYS = 768 };

/* Indices of images from which a plan is made: ambient visibility of five kinds. A frame without slabs has the first
   three. Only a calibration, which needs a scene, reads the last one. */
enum { HSAO, HSAO_BEST, HSAO_SOLID, HSAO_SLABS, HSAO_FAST, PICTURES };
static const char *const pictures[PICTURES][2] = { { "hsao", "thickness=width" }, { "hsao-best", "thickness=width" },
                                                   { "hsao", "thickness=solid" }, { "hsao", "thickness=slabs" },
                                                   { "hsao-fast", "" } };

/* Surveys the images, without pixels that show no surface. */
static int survey_of(ssgi_survey *survey, kit_image picture[PICTURES], int count, const float *z, kit_error *err)
{
    const size_t pixels = (size_t)picture->width * (size_t)picture->height;
    const char *why = "";
    kit_image hsao;
    if (kit_image_new(&hsao, picture->width, picture->height, "Y", err)) return -1;
    for (size_t i = 0; i < pixels; ++i) hsao.data[i] = z[i] > 0 ? picture[HSAO].data[i] : NAN;
    const int bad = ssgi_survey_of(survey, hsao.data, picture[HSAO_BEST].data, picture[HSAO_SOLID].data,
                                   count > HSAO_SLABS ? picture[HSAO_SLABS].data : NULL, pixels, &why) != SSGI_OK;
    kit_image_free(&hsao);
    return bad ? kit_fail(err, "%s", why) : 0;
}

/* Ray-traces ambient visibility at some pixels, and compares the images with it. */
static int calibrate_visibility(ssgi_calibration *calibration, const kit_image *frame, const kit_image *picture,
                                const kit_scene *scene, const kit_camera *camera, float radius, kit_error *err)
{
    const size_t triangles = scene->mesh.triangles, size = ssgi_trace_size(triangles);
    const float *z = kit_image_channel(frame, "Z"),
                *n[3] = { kit_image_channel(frame, "N.X"), kit_image_channel(frame, "N.Y"),
                          kit_image_channel(frame, "N.Z") };
    float *places = malloc(9 * PLACES * sizeof *places), to_view[16], projection[16], origin[3], ray[3];
    void *memory = malloc(size);
    size_t count = 0;
    ssgi_trace trace;
    ssgi_hit hit;
    const char *why = "";
    int failed = places && memory ? 0 : kit_fail(err, "out of memory");
    kit_camera planes = *camera;
    kit_camera_planes(&planes, &scene->mesh);
    kit_camera_matrices(camera, to_view, projection);
    if (!failed
        && ssgi_trace_build(&trace, memory, size, scene->mesh.position, 3 * sizeof(float), NULL, triangles, &why)
               != SSGI_OK)
        failed = kit_fail(err, "%s", why);
    /* the pixels are those of the R2 sequence over the image */
    for (int i = 0; i < 20 * PLACES && count < PLACES && !failed; ++i) {
        const int x = (int)(fmod(0.7548776662466927 * (i + 1), 1) * frame->width),
                  y = (int)(fmod(0.5698402909980532 * (i + 1), 1) * frame->height);
        const size_t at = (size_t)y * (size_t)frame->width + (size_t)x;
        if (!(z[at] > 0)) continue;
        /* not from the frame's depth, whose rounding exceeds a small radius far away */
        if (!kit_camera_hit(&hit, origin, ray, &trace, &planes, x, y)) continue;
        for (int k = 0; k < 3; ++k) places[3 * count + (size_t)k] = origin[k] + hit.t * ray[k];
        for (int k = 0; k < 3; ++k)
            places[3 * (PLACES + count) + (size_t)k] =
                to_view[4 * k] * n[0][at] + to_view[4 * k + 1] * n[1][at] + to_view[4 * k + 2] * n[2][at];
        places[6 * PLACES + count] = picture[HSAO].data[at];
        places[7 * PLACES + count] = picture[HSAO_SLABS].data[at];
        places[8 * PLACES + count++] = picture[HSAO_FAST].data[at];
    }
    if (!failed && !count) failed = kit_fail(err, "the picture shows nothing");
    if (!failed
        && ssgi_plan_calibrate(calibration, &trace, places, places + 3 * PLACES, places + 6 * PLACES,
                               places + 7 * PLACES, places + 8 * PLACES, count, PLACE_RAYS, radius, &why)
               != SSGI_OK)
        failed = kit_fail(err, "%s", why);
    free(places);
    free(memory);
    return failed;
}

/* Computes the energy of each band of the environment's harmonics. */
static int energy_of(float energy[4], const kit_lighting *light, kit_error *err)
{
    float sh[48] = { 0 };
    if (light->env.data) {
        float *rgb = kit_env_interleaved(&light->env);
        if (!rgb) return kit_fail(err, "out of memory");
        ssgi_sh_project_equirect(sh, 4, rgb, light->env.width, light->env.height, NULL);
        free(rgb);
    }
    ssgi_sh_energy(energy, 4, sh, 3);
    return 0;
}

double kit_plan_error(const kit_image *picture, const kit_image *truth, const kit_image *frame, int wanted)
{
    static const char *const names[2][3] = { { "irradiance.R", "irradiance.G", "irradiance.B" },
                                             { "bounce.R", "bounce.G", "bounce.B" } };
    const float *z = kit_image_channel(frame, "Z");
    const int lit = wanted == SSGI_PLAN_WANTED_LIGHT || wanted == SSGI_PLAN_WANTED_BOUNCE;
    double square = 0, mean = 0;
    size_t count = 0;
    for (int c = 0; c < (lit ? 3 : 1); ++c) {
        const float *a = kit_image_channel(picture, lit ? names[0][c] : "Y"),
                    *b = kit_image_channel(truth, lit ? names[0][c] : "Y");
        const float *more_a = wanted == SSGI_PLAN_WANTED_BOUNCE ? kit_image_channel(picture, names[1][c]) : NULL,
                    *more_b = more_a ? kit_image_channel(truth, names[1][c]) : NULL;
        for (int i = 0; i < truth->width * truth->height; ++i) {
            if (!(z[i] > 0) || isnan(b[i])) continue;
            const double x = (double)a[i] + (more_a ? (double)more_a[i] : 0),
                         y = (double)b[i] + (more_b ? (double)more_b[i] : 0);
            square += (x - y) * (x - y);
            mean += y;
            ++count;
        }
    }
    return sqrt(square / (double)count) / (lit ? mean / (double)count : 1);
}

/* Draws the environment's light on open surfaces, and the lights with their shadows if there are any. */
static int light_of(kit_image *open, kit_image *direct, kit_gbuffer *g, const kit_world *world, float radius,
                    kit_error *err)
{
    memset(direct, 0, sizeof *direct);
    /* no occluder is within so small a radius */
    if (kit_run_picture(open, g, world, "ssdo-points", "bounce=none,blur=0", 1e-4f * radius, err)) return -1;
    if (!world->lighting || !world->lighting->lights) return 0;
    return kit_run_picture(direct, g, world, "ssdo-points", "environment=none,bounce=none", radius, err);
}

/* Calibrates light: ray-traces one pixel in every block, and compares it with s3ho, and with the environment's light
   dimmed by visibility. */
static int calibrate_light(ssgi_calibration *calibration, const kit_image *frame, const kit_image *picture,
                           kit_gbuffer *g, const kit_world *world, float radius, int wanted, kit_error *err)
{
    static const int of[4] = { PICTURES /* none */, HSAO, HSAO_SLABS, HSAO_FAST };
    const int stride = (int)fmax(1, sqrt((double)frame->width * frame->height / LIGHT_PLACES)),
              bounce = wanted == SSGI_PLAN_WANTED_BOUNCE;
    const size_t pixels = (size_t)frame->width * (size_t)frame->height;
    double error[5];
    kit_image truth, lit, open, direct;
    if (light_of(&open, &direct, g, world, radius, err)
        || kit_truth_lit(&truth, world->scene, &g->camera, world->lighting, radius, KIT_ATTENUATION_LINEAR, bounce,
                         LIGHT_RAYS, stride, err))
        return -1;
    for (int k = 0; k < 4; ++k) {
        if (kit_image_new(&lit, frame->width, frame->height, "Y", err)) return -1;
        for (size_t i = 0; i < pixels; ++i) lit.data[i] = of[k] < PICTURES ? picture[of[k]].data[i] : 1;
        if (kit_dim(&lit, &open, direct.data ? &direct : NULL, err)) return -1;
        error[k] = kit_plan_error(&lit, &truth, frame, wanted);
        kit_image_free(&lit);
    }
    if (kit_run_picture(&lit, g, world, "s3ho", bounce ? "" : "indirect=none", radius, err)) return -1;
    error[4] = kit_plan_error(&lit, &truth, frame, wanted);
    kit_image_free(&lit);
    kit_image_free(&truth);
    kit_image_free(&open);
    kit_image_free(&direct);
    /* otherwise no pixel has light */
    if (isfinite(error[0]))
        *calibration = (ssgi_calibration){ 1, (float)error[0], (float)error[1], (float)error[2], (float)error[3],
                                           (float)error[4] };
    return 0;
}

/* Predicts the scene's surfels and the pixels under their splats, both over the number of the frame's pixels. */
static int surfels_of(ssgi_plan_scene *s, const kit_gbuffer *g, const kit_scene *scene, float radius, kit_error *err)
{
    const ssgi_surfel_desc desc = { .max_distance = radius };
    kit_method dss;
    if (kit_method_find(&dss, "dss", err)) return -1;
    const ssgi_splat splat = { .max_distance = radius,
                               .levels = kit_method_levels(&dss, (double)s->screen_radius) };
    ssgi_surfel_source source = { .position = scene->mesh.position, .triangles = scene->mesh.triangles };
    ssgi_surfel_cost cost;
    ssgi_view view;
    const char *why = "";
    float projection[16];
    const double pixels = (double)g->viewport[2] * g->viewport[3];
    kit_camera_matrices(&g->camera, source.to_view, projection);
    if (kit_view_of(&view, projection, g->camera.depth, g->viewport[2], g->viewport[3], err)) return -1;
    if (ssgi_surfels_predict(&cost, &desc, &splat, &view, &source, &why) != SSGI_OK)
        return kit_fail(err, "surfels: %s", why);
    s->surfels = (double)cost.surfels / pixels;
    for (int l = 0; l < SSGI_SPLAT_LEVELS; ++l) s->splats += cost.pixels[l] / pixels;
    return 0;
}

/* Finds the pixels under occluders' fields, and the error without fields, by rays at one pixel in every block. */
static int objects_of(ssgi_plan_scene *s, const kit_image *frame, const kit_gbuffer *g, const kit_scene *scene,
                      kit_error *err)
{
    const int stride = (int)fmax(1, sqrt((double)frame->width * frame->height / PLACES));
    kit_image truth, none;
    kit_method m;
    double covered;
    if (kit_method_find(&m, "aof", err)) return -1;
    const ssgi_field_desc desc = kit_method_field(&m);
    if (kit_fields_cover(&covered, frame, &g->camera, scene, &desc, err)) return -1;
    s->coverage = s->occluders ? (float)(covered / s->occluders) : 0;
    if (kit_truth_objects(&truth, scene, &g->camera, PLACE_RAYS, stride, err)
        || kit_image_new(&none, frame->width, frame->height, "Y", err))
        return -1;
    for (int i = 0; i < frame->width * frame->height; ++i) none.data[i] = 1;
    s->calibration.unoccluded = (float)kit_plan_error(&none, &truth, frame, SSGI_PLAN_WANTED_OBJECTS);
    s->calibration.known = 1;
    kit_image_free(&truth);
    kit_image_free(&none);
    return 0;
}

int kit_plan_numbers(ssgi_plan_scene *s, kit_gbuffer *g, const kit_world *world, float radius, int wanted,
                     kit_error *err)
{
    const kit_world dark = { world->scene, NULL };
    const int slabs = world->scene || g->slabs,
              count = world->scene ? PICTURES : slabs ? HSAO_FAST : HSAO_SLABS;
    kit_image frame, picture[PICTURES];
    memset(s, 0, sizeof *s);
    s->wanted = wanted;
    s->thickness = slabs   ? SSGI_PLAN_THICKNESS_SLABS
                       : g->back ? SSGI_PLAN_THICKNESS_BACK
                                 : SSGI_PLAN_THICKNESS_WIDTH;
    for (int k = 0; k < count; ++k)
        if (kit_run_picture(&picture[k], g, &dark, pictures[k][0], pictures[k][1], radius, err)) return -1;
    if (kit_gbuffer_read(&frame, g, err)) return -1;
    s->screen_radius = (float)kit_screen_radius(&frame, &g->camera, radius);
    s->map = world->lighting && world->lighting->env.data;
    int failed = survey_of(&s->survey, picture, count, kit_image_channel(&frame, "Z"), err);
    if (!failed && world->scene && wanted == SSGI_PLAN_WANTED_VISIBILITY)
        failed = calibrate_visibility(&s->calibration, &frame, picture, world->scene, &g->camera, radius, err);
    else if (!failed && world->scene && wanted != SSGI_PLAN_WANTED_OBJECTS && world->lighting)
        failed = calibrate_light(&s->calibration, &frame, picture, g, world, radius, wanted, err);
    for (int i = 0; world->scene && i < world->scene->objects; ++i)
        s->occluders += world->scene->object[i].casts > 0;
    if (!failed && world->scene && wanted == SSGI_PLAN_WANTED_OBJECTS)
        failed = objects_of(s, &frame, g, world->scene, err);
    for (int k = 0; k < count; ++k) kit_image_free(&picture[k]);
    kit_image_free(&frame);
    if (!failed && world->lighting) failed = energy_of(s->energy, world->lighting, err);
    return failed || !world->scene ? failed : surfels_of(s, g, world->scene, radius, err);
}

int kit_plan_chain(ssgi_gl_chain *chain, const ssgi_plan *p, int wanted, kit_error *err)
{
    const char *why = "";
    memset(chain, 0, sizeof *chain);
    if (wanted == SSGI_PLAN_WANTED_BOUNCE && p->method == SSGI_PLAN_METHOD_S3HO) {
        chain->desc.light.transfer = SSGI_GL_TRANSFER_BOTH;
        chain->desc.light.packed_coefficients = 1;
    }
    if (ssgi_gl_plan(&chain->desc, p, &why) != SSGI_OK) return kit_fail(err, "%s", why);
    if (wanted == SSGI_PLAN_WANTED_BOUNCE && p->method == SSGI_PLAN_METHOD_SSDO) {
        chain->desc.light.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE;
        chain->reuse = 1;
    }
    chain->blur = p->filter_radius > 0;
    chain->history = p->history;
    return 0;
}

int kit_plan_method(kit_method *m, const ssgi_plan *p, int wanted, kit_error *err)
{
    ssgi_gl_chain chain;
    char size[32] = "";
    int i = 0;
    if (kit_plan_chain(&chain, p, wanted, err)) return -1;
    while (kit_method_at(m, i++) && m->pass != (int)chain.desc.pass) {}     /* searches the plain method of its pass */
    kit_method_take(m, &chain.desc);
    m->set.blur = chain.blur ? chain.desc.filter.radius : 0;
    m->set.history = chain.history;
    m->set.reuse = chain.reuse;
    m->set.indirect = chain.desc.light.transfer ? KIT_INDIRECT_JOINT : KIT_INDIRECT_NONE;
    if (p->field_resolution) m->set.field_resolution = p->field_resolution;
    if (p->surfel_size > 0) snprintf(size, sizeof size, "size=%g", (double)p->surfel_size);
    return kit_method_set(m, size, err);
}

const char *kit_plan_text(char set[256], const ssgi_plan *p, int wanted)
{
    kit_method m;
    kit_error err;
    if (kit_plan_method(&m, p, wanted, &err)) return NULL;
    kit_method_text(set, 256, &m);
    return m.name;
}

int kit_dim(kit_image *visibility, const kit_image *open, const kit_image *direct, kit_error *err)
{
    const size_t pixels = (size_t)visibility->width * (size_t)visibility->height;
    kit_image out;
    if (kit_image_new(&out, visibility->width, visibility->height, KIT_LIT_CHANNELS, err)) return -1;
    for (size_t i = 0; i < pixels * (size_t)out.channels; ++i) {
        const float d = direct ? direct->data[i] : 0;
        out.data[i] = d + (open->data[i] - d) * visibility->data[i % pixels];
    }
    kit_image_free(visibility);
    *visibility = out;
    return 0;
}

int kit_light_by(kit_image *visibility, kit_gbuffer *g, const kit_world *world, float radius, kit_error *err)
{
    kit_image open, direct;
    int failed = light_of(&open, &direct, g, world, radius, err);
    if (failed) return -1;
    failed = kit_dim(visibility, &open, direct.data ? &direct : NULL, err);
    kit_image_free(&open);
    kit_image_free(&direct);
    return failed;
}
