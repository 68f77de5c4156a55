/* plan.c - what a scene needs: the numbers that ssgi_plan_make asks for, taken from a G-buffer, and its answer as a
   method of the kit. Part of the kit. */
#include "kit_gl.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { PLACES = 3000, PLACE_RAYS = 64, LIGHT_RAYS = 768 };

/* Draws the pass "statistics" with a run's frame, and reads it. */
static int statistics_of(ssgi_depth_statistics *statistics, const kit_run *run, kit_error *err)
{
    const kit_gbuffer *g = run->gbuffer;
    const int width = (g->viewport[2] + 7) / 8, height = (g->viewport[3] + 7) / 8;
    const GLuint target = kit_texture(width, height, GL_RGBA32F, NULL);
    ssgi_gl_desc desc = run->pass[0].desc;
    const char *why = "";
    float *texels = malloc(4 * (size_t)(width * height) * sizeof *texels);
    GLuint program, framebuffer;
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    int failed;
    desc.pass = SSGI_GL_STATISTICS;
    desc.samples = 0;
    program = kit_pass_program(&desc, err);
    if (!program || !texels) {
        free(texels);
        glDeleteTextures(1, &target);
        return program ? kit_fail(err, "out of memory") : -1;
    }
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, run->block[0]);
    for (int i = 0, n = ssgi_gl_reflect(&desc, io, SSGI_GL_MAX_IO); i < n; ++i) {
        if (io[i].kind != SSGI_GL_TEXTURE) continue;
        glActiveTexture(GL_TEXTURE0 + (GLenum)io[i].slot);
        glBindTexture(GL_TEXTURE_2D, !strcmp(io[i].name, "t_ssgi_depth") ? g->depth : g->normal);
    }
    glActiveTexture(GL_TEXTURE0);
    glViewport(0, 0, width, height);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    failed =
        kit_texture_read(target, width, height, 4, texels) ? kit_fail(err, "the statistics cannot be read back") : 0;
    if (!failed && ssgi_depth_statistics_of(statistics, texels, width, height, 0, &why) != SSGI_OK)
        failed = kit_fail(err, "%s", why);
    glDeleteProgram(program);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &target);
    free(texels);
    return failed;
}

/* Traces some places of a picture of ambient visibility. */
static int calibrate_visibility(ssgi_calibration *calibration, const kit_image *frame, const kit_image *picture,
                                const kit_scene *scene, const kit_camera *camera, float radius, kit_error *err)
{
    const size_t triangles = scene->mesh.triangles, size = ssgi_trace_size(triangles);
    const float *z = kit_image_channel(frame, "Z"),
                *n[3] = { kit_image_channel(frame, "N.X"), kit_image_channel(frame, "N.Y"),
                          kit_image_channel(frame, "N.Z") };
    float *places = malloc(7 * PLACES * sizeof *places), to_view[16], projection[16], origin[3], ray[3];
    void *memory = malloc(size);
    size_t count = 0;
    ssgi_trace trace;
    ssgi_hit hit;
    const char *why = "";
    int failed = places && memory ? 0 : kit_fail(err, "out of memory");
    kit_camera_matrices(camera, to_view, projection);
    if (!failed
        && ssgi_trace_build(&trace, memory, size, scene->mesh.position, 3 * sizeof(float), NULL, triangles, &why)
               != SSGI_OK)
        failed = kit_fail(err, "%s", why);
    /* the R2 sequence over the picture */
    for (int i = 0; i < 20 * PLACES && count < PLACES && !failed; ++i) {
        const int x = (int)(fmod(0.7548776662466927 * (i + 1), 1) * frame->width),
                  y = (int)(fmod(0.5698402909980532 * (i + 1), 1) * frame->height);
        const size_t at = (size_t)y * (size_t)frame->width + (size_t)x;
        if (!(z[at] > 0)) continue;
        /* not from depth, whose rounding is more than a small radius far away */
        kit_camera_ray(camera, x, y, origin, ray);
        if (!ssgi_trace_closest(&trace, origin, ray, 0, 1e12f, &hit)) continue;
        for (int k = 0; k < 3; ++k) places[3 * count + (size_t)k] = origin[k] + hit.t * ray[k];
        for (int k = 0; k < 3; ++k)
            places[3 * (PLACES + count) + (size_t)k] =
                to_view[4 * k] * n[0][at] + to_view[4 * k + 1] * n[1][at] + to_view[4 * k + 2] * n[2][at];
        places[6 * PLACES + count++] = picture->data[at];
    }
    if (!failed && !count) failed = kit_fail(err, "the picture shows nothing");
    if (!failed
        && ssgi_plan_calibrate(calibration, &trace, places, places + 3 * PLACES, places + 6 * PLACES, count, PLACE_RAYS,
                               radius, &why)
               != SSGI_OK)
        failed = kit_fail(err, "%s", why);
    free(places);
    free(memory);
    return failed;
}

/* Of the environment's harmonics. */
static int energy_of(float energy[4], const kit_lighting *light, kit_error *err)
{
    const size_t texels = (size_t)light->env.width * (size_t)light->env.height;
    float sh[48] = { 0 };
    if (light->env.data) {
        float *rgb = malloc(3 * texels * sizeof *rgb);
        if (!rgb) return kit_fail(err, "out of memory");
        for (size_t i = 0; i < 3 * texels; ++i) rgb[i] = light->env.data[i % 3 * texels + i / 3];
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
    double square = 0, mean = 0;
    size_t count = 0;
    for (int c = 0; c < (wanted ? 3 : 1); ++c) {
        const float *a = kit_image_channel(picture, wanted ? names[0][c] : "Y"),
                    *b = kit_image_channel(truth, wanted ? names[0][c] : "Y");
        const float *more_a = wanted == SSGI_PLAN_BOUNCE ? kit_image_channel(picture, names[1][c]) : NULL,
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
    return sqrt(square / (double)count) / (wanted ? mean / (double)count : 1);
}

/* The same of light: the truth of one pixel in every block, visibility dims what the environment brings to open
   surfaces. */
static int calibrate_light(ssgi_calibration *calibration, const kit_image *frame, kit_image *picture, kit_gbuffer *g,
                           const kit_world *world, float radius, int wanted, kit_error *err)
{
    const int stride = (int)fmax(1, sqrt((double)frame->width * frame->height / PLACES));
    kit_image truth, open;
    if (kit_image_new(&open, frame->width, frame->height, "Y", err)) return -1;
    for (int i = 0; i < frame->width * frame->height; ++i) open.data[i] = 1;
    if (kit_light_by(&open, g, world, radius, err) || kit_light_by(picture, g, world, radius, err)
        || kit_truth_lit(&truth, world->scene, &g->camera, world->lighting, radius, KIT_ATTENUATION_LINEAR,
                         wanted == SSGI_PLAN_BOUNCE, LIGHT_RAYS, stride, err))
        return -1;
    const double of_open = kit_plan_error(&open, &truth, frame, wanted),
                 of_picture = kit_plan_error(picture, &truth, frame, wanted);
    kit_image_free(&open);
    kit_image_free(&truth);
    /* else all is dark */
    if (isfinite(of_open)) *calibration = (ssgi_calibration){ 1, (float)of_open, (float)of_picture };
    return 0;
}

int kit_plan_numbers(ssgi_plan_scene *s, kit_gbuffer *g, const kit_world *world, float radius, int wanted, int closed,
                     kit_error *err)
{
    kit_method method;
    kit_run run;
    kit_image frame, picture;
    double reach = 0, albedo = 0;
    size_t seen = 0;
    memset(s, 0, sizeof *s);
    s->wanted = wanted;
    if (kit_method_find(&method, "hsao", err) || kit_run_open(&run, g, &method, radius, world, err)) return -1;
    kit_run_draw(&run, 0);
    int failed = statistics_of(&s->statistics, &run, err) || kit_run_read(&picture, &run, err);
    const double per_depth = fabs((double)run.frame.project[1]);
    kit_run_close(&run);
    if (failed) return -1;
    failed = kit_gbuffer_read(&frame, g, err);
    if (!failed) {
        const float *z = kit_image_channel(&frame, "Z"), *green = kit_image_channel(&frame, "albedo.G");
        for (int i = 0; i < frame.width * frame.height; ++i) {
            if (!(z[i] > 0)) continue;
            reach += (double)radius * per_depth / (g->camera.fovy > 0 ? (double)z[i] : 1) / frame.height;
            albedo += green ? (double)green[i] : 0.8;
            ++seen;
        }
        s->screen_radius = (float)(reach / fmax(1, (double)seen));
        s->albedo = (float)fmin(1, albedo / fmax(1, (double)seen));
        if (world->scene && wanted == SSGI_PLAN_VISIBILITY)
            failed = calibrate_visibility(&s->calibration, &frame, &picture, world->scene, &g->camera, radius, err);
        else if (world->scene && wanted != SSGI_PLAN_OBJECTS && world->lighting)
            failed = calibrate_light(&s->calibration, &frame, &picture, g, world, radius, wanted, err);
        kit_image_free(&frame);
    }
    kit_image_free(&picture);
    s->map = world->lighting && world->lighting->env.data;
    if (!failed && world->lighting) failed = energy_of(s->energy, world->lighting, err);
    if (failed || !world->scene) return failed;
    s->layers = closed ? 4 : 1;
    s->cameras = closed ? 4 : 0;
    s->triangles = (double)world->scene->mesh.triangles;
    for (int i = 0; i < world->scene->objects; ++i) s->occluders += world->scene->object[i].casts > 0;
    return 0;
}

const char *kit_plan_text(char set[256], const ssgi_plan *p, int wanted)
{
    static const char *const names[] = { NULL, "hsao", "hsao-march", "ssdo-points", "s3ho-points", "dss", "aof" };
    /* methods that have a setting */
    enum { ALL = 1 << SSGI_PLAN_HSAO | 1 << SSGI_PLAN_MARCH | 1 << SSGI_PLAN_SSDO | 1 << SSGI_PLAN_S3HO };
    const struct { const char *key; int value, least, of;
    } asked[] = { { "half", p->half, 0, ALL },
                  { "directions", p->directions, 1, ALL },
                  { "samples", p->samples, 1, ALL },
                  { "steps", p->steps, 1, ALL },
                  { "bands", p->bands, 1, ALL },
                  { "layers", p->layers, 2, ALL },
                  { "views", p->cameras, 1, ALL },
                  { "blur", p->filter, 1, ALL },
                  { "levels", p->levels, 1, 1 << SSGI_PLAN_SURFELS },
                  { "resolution", p->resolution, 1, 1 << SSGI_PLAN_FIELD } };
    size_t n = 0;
    *set = 0;
    for (size_t i = 0; i < sizeof asked / sizeof asked[0]; ++i)
        if (asked[i].value >= asked[i].least && asked[i].of >> p->method & 1)
            n += (size_t)snprintf(set + n, 256 - n, "%s%s=%d", n ? "," : "", asked[i].key, asked[i].value);
    if (p->method == SSGI_PLAN_SURFELS) n += (size_t)snprintf(set + n, 256 - n, ",size=%g", (double)p->size);
    if (wanted != SSGI_PLAN_BOUNCE && (p->method == SSGI_PLAN_SSDO || p->method == SSGI_PLAN_S3HO))
        snprintf(set + n, 256 - n, p->method == SSGI_PLAN_SSDO ? ",bounce=none" : ",indirect=none");
    return names[p->method];
}

int kit_plan_method(kit_method *m, const ssgi_plan *p, int wanted, kit_error *err)
{
    char set[256];
    const char *name = kit_plan_text(set, p, wanted);
    return !name                                                          ? kit_fail(err, "nothing needs no method")
           : kit_method_find(m, name, err) || kit_method_set(m, set, err) ? -1
                                                                          : 0;
}

static int lit_of(kit_image *out, kit_gbuffer *g, const kit_world *world, const char *set, float radius, kit_error *err)
{
    kit_method method;
    kit_run run;
    int failed;
    if (kit_method_find(&method, "ssdo-points", err) || kit_method_set(&method, set, err)
        || kit_run_open(&run, g, &method, radius, world, err))
        return -1;
    kit_run_draw(&run, 0);
    failed = kit_run_read(out, &run, err);
    kit_run_close(&run);
    return failed;
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
    const int lights = world->lighting && world->lighting->lights;
    kit_image open, direct = { 0 };
    int failed;
    /* nothing is in the way within so small a radius */
    if (lit_of(&open, g, world, "bounce=none,blur=0", 1e-4f * radius, err)) return -1;
    failed = (lights && lit_of(&direct, g, world, "environment=none,bounce=none", radius, err))
             || kit_dim(visibility, &open, lights ? &direct : NULL, err);
    kit_image_free(&open);
    kit_image_free(&direct);
    return failed ? -1 : 0;
}
