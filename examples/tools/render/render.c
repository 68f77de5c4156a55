/* render.c - renders an image of a scene, or of a captured frame, with one method; its ground truth; scores and times.

      build/render model.glb --method hsao --radius 0.5 --out ao.exr
      build/render room --truth 256 --out truth.exr
      build/render room --method hsao --set samples=8,blur=1 --score truth.exr --time 20
      build/render room --save-gbuffer frame.exr
      build/render --gbuffer frame.exr --out ao.png
      build/render --gbuffer others.exr --fovy 60 --radius 1 --out ao.png
      build/render cornell --method ssdo --light point:0,5,-2.8,20,20,20 --out lit.png
      build/render scene.obj --method ssdo --env probe.hdr --set layers=2 --out lit.exr
      build/render scene.obj --plan visibility:40% --out ao.exr
      build/render room --set history=1 --frames 16 --orbit 0.2 --out frames/%04d.exr
      build/render --help | --list | --list hsao

   Bad input: one line on stderr that names it, status 2, nothing written. Status 1: no choice of --plan meets the error
   that was asked for, and the picture is by the best one. --sequence and --frames write each picture
   when it is drawn, after the list and all of its frames have been read. */
#include "render.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

static int fail(const char *text)
{
    fprintf(stderr, "render: %s\n", text);
    return 2;
}

static void camera_of(kit_camera *c, const options *o, const double origin[3])
{
    for (int i = 0; i < 3 && o->has_camera; ++i) {
        c->eye[i] = (float)(o->camera[i] - origin[i]);
        c->target[i] = (float)(o->camera[3 + i] - origin[i]);
    }
    for (int i = 0; i < 3 && o->has_up; ++i) c->up[i] = (float)o->up[i];
    if (o->fovy > 0) { c->fovy = (float)o->fovy; c->ortho_height = 0; }
    if (o->ortho_height > 0) { c->fovy = 0; c->ortho_height = (float)o->ortho_height; }
    if (o->znear > 0) c->znear = (float)o->znear;
    if (o->zfar > 0) c->zfar = (float)o->zfar;
    if (o->has_near && !(o->znear > 0)) {      /* depths must be positive: the eye moves back, the image stays */
        const double before = 1e-3 * fmax(o->zfar - o->znear, (double)c->ortho_height), by = before - o->znear;
        float view[16], projection[16];
        kit_camera_matrices(c, view, projection);
        for (int i = 0; i < 3; ++i) c->eye[i] = (float)((double)c->eye[i] + by * (double)view[4 * i + 2]);
        c->znear = (float)before;
        if (o->zfar > 0) c->zfar = (float)(o->zfar + by);
    }
    if (o->size[0]) { c->width = o->size[0]; c->height = o->size[1]; }
}

static int camera_check(const kit_camera *c, kit_error *err)
{
    double n = 0, u = 0, d = 0;
    for (int i = 0; i < 3; ++i) {
        const double f = (double)c->target[i] - (double)c->eye[i], up = (double)c->up[i];
        n += f * f;
        u += up * up;
        d += f * up;
    }
    if (!(n > 0)) return kit_fail(err, "--camera: eye and target must differ");
    if (!(u > 0) || d * d > n * u * 0.999999)
        return kit_fail(err, "--up: must not be zero or along the view direction");
    return 0;
}

int render_open_settings(job *j, kit_error *err)
{
    const options *o = &j->o;
    kit_lighting *l = &j->lighting;
    if (kit_method_find(&j->method, o->method, err)) return -1;
    for (int i = 0; i < o->sets; ++i) if (kit_method_set(&j->method, o->set[i], err)) return -1;
    for (; l->lights < o->lights; ++l->lights)
        if (kit_light_parse(&l->light[l->lights], o->light[l->lights], NULL, err)) return -1;
    if (o->env && (kit_env_read(&l->env, o->env, err) || kit_env_adjust(&l->env, o->turn, o->strength, err))) return -1;
    if (!j->method.lit && !o->planned && (o->env || o->lights))
        return kit_fail(err, "%s: method %s is not lit; ssdo is", o->env ? "--env" : "--light", j->method.name);
    if ((j->method.lit || j->method.between) && o->floor)
        return kit_fail(err, "--floor: needs a method of ambient visibility within a radius");
    if (o->colours && (j->method.lit || o->planned))
        return kit_fail(err, "--colours: is of a method of ambient visibility%s", o->planned ? ", not of --plan" : "");
    if (j->method.lit && !o->planned && !o->gbuffer && !o->env && !o->lights && !kit_scene_seeded(o->scene))
        return kit_fail(err, "--method %s: needs light: --env sky, --env FILE or --light sun:..", j->method.name);
    j->r.lit = j->method.lit;
    j->radius = o->radius;
    return kit_gl_open(o->context, err);
}

/* Converts points that the user gives from his coordinates to the scene's. */
static int settle_origin(job *j, const double origin[3], kit_error *err)
{
    memcpy(j->origin, origin, sizeof j->origin);
    for (int i = 0; i < j->o.lights; ++i)
        if (kit_light_parse(&j->lighting.light[i], j->o.light[i], origin, err)) return -1;
    return 0;
}

/* Sets the origin of all frames: that of the first frame's header, or, if the user gives a camera so far from 0 that
   floats would turn it, the eye. */
static int settle_frames(job *j, const options *o, const kit_header *header, kit_error *err)
{
    static const double nearby[3];
    double away = 0, length = 0;
    if (j->framed) return 0;
    j->framed = 1;
    if (!o->has_camera) return settle_origin(j, header->origin, err);
    for (int i = 0; i < 3; ++i) {
        away = fmax(away, fabs(o->camera[i]));
        length += pow(o->camera[3 + i] - o->camera[i], 2);
    }
    return settle_origin(j, away > 1000 * sqrt(length) ? o->camera : nearby, err);
}

/* Takes camera and radius from the frame's header if the user gives none. placed: the camera's place is known. */
static int ask_header(kit_camera *camera, job *j, int *placed, const options *o, kit_error *err)
{
    double *radius = &j->radius;
    const int window = !(o->fovy > 0) && !(o->ortho_height > 0), given = *radius > 0;
    const int wanted = (o->has_camera ? 0 : KIT_HEADER_PLACE) | (window ? KIT_HEADER_WINDOW : 0)
                     | (given ? 0 : KIT_HEADER_RADIUS);
    kit_header header = { 0 };
    if (wanted && kit_exr_header(&header, wanted, o->gbuffer, err)) return -1;
    if (window && !(header.has & KIT_HEADER_WINDOW))
        return kit_fail(err, "--gbuffer %s: needs --fovy or --ortho-height: it carries no camera (worldToCamera)",
                        o->gbuffer);
    if (!given && !(header.has & KIT_HEADER_RADIUS))
        return kit_fail(err, "--gbuffer %s: needs --radius: it carries none (ssgi.radius)", o->gbuffer);
    if (o->sequence && !o->has_camera && !(header.has & KIT_HEADER_PLACE))
        return kit_fail(err, "--gbuffer %s: needs a camera behind its name: it carries none (worldToCamera)",
                        o->gbuffer);
    if (settle_frames(j, o, &header, err)) return -1;
    kit_camera_from_header(camera, &header);
    for (int i = 0; i < 3 && header.has & KIT_HEADER_PLACE; ++i) {
        const double by = header.origin[i] - j->origin[i];
        camera->eye[i] = (float)((double)camera->eye[i] + by);
        camera->target[i] = (float)((double)camera->target[i] + by);
    }
    *placed = o->has_camera || header.has & KIT_HEADER_PLACE;
    if (!given) *radius = (double)header.radius;
    return 0;
}

/* Narrows the camera's angle: the user's angle is that of the whole image, and a frame may be a part of it. */
static int narrow(kit_camera *camera, const options *o, kit_error *err)
{
    kit_header header = { .orthographic = !(camera->fovy > 0), .height = camera->ortho_height };
    if (camera->fovy > 0) header.height = (float)(2 * tan((double)camera->fovy * KIT_PI / 360));
    if (kit_exr_header(&header, KIT_HEADER_PART, o->gbuffer, err)) return -1;
    kit_camera_from_header(camera, &header);
    return 0;
}

/* Refuses frames whose normals mostly disagree with their depth: a wrong camera turned their world-space normals, and
   the picture would be garbage. In correct scenes at most 15 % disagree; with a quarter turn, nine in ten scenes are
   refused. A wrong lens turns normals by less, but all alike; if a lens that fits better follows from them, it is
   named. */
static int check_normals(job *j, const options *o, const kit_image *frame, const kit_camera *camera, kit_error *err)
{
    enum { ENOUGH = 256 };
    kit_agreement now, then;
    kit_camera other = *camera;
    if (j->method.set.normal || j->method.pass == SSGI_GL_PASS_DEBUG || !kit_image_channel(frame, "N.X")) return 0;
    if (kit_frame_agreement(&now, frame, camera, err)) return -1;
    if (now.pixels < ENOUGH) return 0;
    if (now.off > 0.5)
        return kit_fail(err, "the normals disagree with the depth at %.0f %% of the pixels: is --up right (Blender: "
                             "0,0,1), is --fovy the vertical angle? N.X .. are of view space; --set normal=depth draws "
                             "without them", 100 * now.off);
    if (!(camera->fovy > 0) || now.angle < 2 || j->noted) return 0;
    other.fovy = (float)(atan(tan((double)camera->fovy * KIT_PI / 360) / now.steeper) * 360 / KIT_PI);
    if (kit_frame_agreement(&then, frame, &other, err)) return -1;
    if (then.angle > 0.75 * now.angle) return 0;
    j->noted = 1;
    fprintf(stderr, "render: note: --gbuffer %s: its normals agree with --fovy %.1f better than with %.1f: is that the "
                    "vertical angle?\n", o->gbuffer, (double)other.fovy, (double)camera->fovy);
    return 0;
}

int render_open_frame(kit_gbuffer *g, job *j, const options *o, kit_error *err)
{
    kit_camera camera = { .target = { 0, 0, -1 }, .up = { 0, 1, 0 } };
    kit_image frame;
    kit_error why;
    int failed, placed = 0;
    if (kit_exr_read(&frame, o->gbuffer, err)) return -1;
    camera.width = frame.width;
    camera.height = frame.height;
    failed = ask_header(&camera, j, &placed, o, &why);
    if (!failed) camera_of(&camera, o, j->origin);
    if (!failed && (o->fovy > 0 || o->ortho_height > 0)) failed = narrow(&camera, o, &why);
    if (failed || camera_check(&camera, &why)) {
        kit_image_free(&frame);
        return kit_fail(err, "%s", why.text);
    }
    failed = kit_frame_rename(&frame, o->channel, o->channels, o->layer, &camera, placed, &why)
          || check_normals(j, o, &frame, &camera, &why) || kit_gbuffer_from_frame(g, &frame, &camera, &why);
    kit_image_free(&frame);
    if (failed) return kit_fail(err, "--gbuffer %s: %s", o->gbuffer, why.text);
    if (!j->method.lit || g->direct || o->planned || o->env || o->lights) return 0;
    kit_gbuffer_free(g);
    return kit_fail(err, "--gbuffer %s: --method %s needs light: direct.R .., --env sky, --env FILE or --light sun:..",
                    o->gbuffer, o->method);
}

/* Guesses the radius from the distances between local maxima of the mesh's height. */
static int guess_radius(double *radius, const kit_scene *scene, int quiet, kit_error *err)
{
    static const float up[3] = { 0, 1, 0 };
    const size_t triangles = scene->mesh.triangles, words = 9 * triangles;
    uint32_t *work = malloc(words * sizeof *work + 1);
    float guess = 0;
    size_t tops = 0;
    const char *why = "out of memory";
    const int failed = !work
                    || ssgi_radius_guess(&guess, &tops, scene->mesh.position, 12, NULL, triangles, up, work, words,
                                         &why) != SSGI_OK;
    free(work);
    if (failed) return kit_fail(err, "--radius guess: %s", why);
    *radius = (double)guess;
    if (!quiet) printf("radius %g, of %zu tops\n", *radius, tops);
    return 0;
}

/* Gives each corner its face's normal, on the side of the mesh's own normals. */
static void flatten(kit_mesh *mesh)
{
    for (size_t t = 0; t < mesh->triangles; ++t) {
        const float *const p = mesh->position + 9 * t;
        float *const own = mesh->normal + 9 * t;
        double n[3], along = 0;
        if (!kit_face(p, n)) continue;
        for (int i = 0; i < 9; ++i) along += n[i % 3] * (double)own[i];
        for (int i = 0; i < 9; ++i) own[i] = (float)(along < 0 ? -n[i % 3] : n[i % 3]);
    }
}

int render_slide(job *j, int times, kit_error *err)
{
    const float by[3] = { (float)j->o.slide[0], (float)j->o.slide[1], (float)j->o.slide[2] };
    return kit_scene_slide(&j->scene, by, times, err);
}

int render_open_scene(job *j, kit_error *err)
{
    kit_camera camera;
    if (kit_scene_load(&j->scene, j->o.scene, j->o.ground, err)) return -1;
    if (*j->scene.note) fprintf(stderr, "render: note: %s: %s\n", j->o.scene, j->scene.note);
    if (j->o.flat) flatten(&j->scene.mesh);
    camera = j->scene.camera;
    if (settle_origin(j, j->scene.mesh.origin, err)) return -1;
    camera_of(&camera, &j->o, j->origin);
    if (!j->o.frames && render_slide(j, 1, err)) return -1;
    if (camera_check(&camera, err) || kit_gbuffer_from_scene(&j->gbuffer, &j->scene, &camera, NULL, err)) return -1;
    if (j->o.guess && guess_radius(&j->radius, &j->scene, j->o.json, err)) return -1;
    if (!(j->radius > 0)) j->radius = (double)j->scene.radius;
    j->world.scene = &j->scene;
    const int lit = j->method.lit || render_plans_light(&j->o);
    return j->o.env || j->o.lights || !lit ? 0 : kit_light_scene(&j->lighting, &j->scene, err);
}

/* Replaces --method by the planned method; if the plan is for no method, it makes the image itself. */
static int plan_it(job *j, kit_error *err)
{
    const options *o = &j->o;
    kit_image *picture = &j->r.picture;
    ssgi_plan_scene numbers;
    const char *why = "";
    if (kit_plan_numbers(&numbers, &j->gbuffer, &j->world, (float)j->radius, o->planned - 1, err)) return -1;
    numbers.unit = o->plan_relative ? SSGI_PLAN_UNIT_RELATIVE : SSGI_PLAN_UNIT_RMSE;
    numbers.error = (float)(o->plan_relative ? o->plan[0] / 100 : o->plan[0]);
    numbers.budget = (float)o->plan[1];
    numbers.device = o->plan_in_ms || !(o->plan[1] > 0) ? SSGI_PLAN_DEVICE_RX_6800 : SSGI_PLAN_DEVICE_GPU;
    if (ssgi_plan_make(j->plan, &numbers, &why) != SSGI_OK) return kit_fail(err, "%s", why);
    ssgi_plan_choice(&j->plan[1], j->plan->cheaper, &numbers);
    ssgi_plan_choice(&j->plan[2], j->plan->dearer, &numbers);
    j->r.plan = j->plan;
    j->unmet = numbers.error > 0 && !j->plan->meets;
    if (!o->json) puts(j->plan->why);
    if (j->plan->method == SSGI_PLAN_METHOD_NOTHING) {
        if (kit_image_new(picture, j->gbuffer.viewport[2], j->gbuffer.viewport[3], "Y", err)) return -1;
        for (int i = 0; i < picture->width * picture->height; ++i) picture->data[i] = 1;
    } else if (kit_plan_method(&j->method, j->plan, o->planned - 1, err)) return -1;
    j->r.lit = j->method.lit || render_plans_light(o);
    return 0;
}

static int trace(job *j, kit_error *err)
{
    const kit_method *m = &j->method;
    const kit_camera *camera = &j->gbuffer.camera;
    const float radius = (float)j->radius;
    if (j->o.truth)
        return kit_method_truth(&j->r.picture, m, &j->scene, camera, &j->lighting, radius, j->o.truth, 1, err);
    return kit_floor_ao(&j->r.picture, &j->r.frame, camera, radius, kit_method_attenuation(m), j->o.floor, 1, err);
}

/* Prints median times of each pass over frames of a still view; with history, only of frames after another. */
static int time_passes(job *j, kit_error *err)
{
    const int frames = j->o.time;
    kit_run *run = &j->run;
    j->r.frames = frames;
    j->r.ms = calloc((size_t)run->passes * (size_t)(frames + 1), sizeof *j->r.ms);
    if (!j->r.ms) return kit_fail(err, "out of memory");
    for (int f = 0; f < frames; ++f) {
        if (kit_frames_still(run, 0, (unsigned)f, KIT_PASSES, err)) return -1;
        for (int i = 0; i < run->passes; ++i) j->r.ms[run->passes + i * frames + f] = run->pass[i].ms;
    }
    for (int i = 0; i < run->passes; ++i) j->r.ms[i] = kit_median(j->r.ms + run->passes + i * frames, frames);
    return 0;
}

static int draw(job *j, kit_error *err)
{
    kit_run *run = &j->run;
    if (kit_run_open(run, &j->gbuffer, &j->method, (float)j->radius, &j->world, err)) return -1;
    j->r.run = run;
    if (j->o.time && time_passes(j, err)) return -1;
    for (int k = 0; k < (j->o.still ? j->o.still : 1); ++k)
        if (kit_frames_still(run, 0, (unsigned)k, 0, err)) return -1;
    return kit_run_read(&j->r.picture, run, err);
}

/* Turns visibility into R G B: the surfaces' colours times it; KIT_BEHIND in the background. */
static int colour(kit_image *picture, const kit_gbuffer *g, kit_error *err)
{
    static const char *const names[3] = { "albedo.R", "albedo.G", "albedo.B" };
    const size_t pixels = (size_t)picture->width * (size_t)picture->height;
    kit_image frame, out;
    if (kit_gbuffer_read(&frame, g, err)) return -1;
    if (kit_image_new(&out, picture->width, picture->height, "R,G,B", err)) { kit_image_free(&frame); return -1; }
    const float *z = kit_image_channel(&frame, "Z"), *visible = kit_image_channel(picture, "Y");
    for (size_t c = 0; c < 3; ++c) {
        const float *albedo = kit_image_channel(&frame, names[c]);
        for (size_t i = 0; i < pixels; ++i)
            out.data[c * pixels + i] = z[i] > 0 ? visible[i] * (albedo ? albedo[i] : 0.8f) : KIT_BEHIND;
    }
    kit_image_free(&frame);
    kit_image_free(picture);
    *picture = out;
    return 0;
}

/* Puts the environment into the background. */
static int add_backdrop(kit_image *picture, const kit_gbuffer *g, const kit_image *env, kit_error *err)
{
    const size_t pixels = (size_t)picture->width * (size_t)picture->height;
    kit_image frame;
    if (kit_gbuffer_read(&frame, g, err)) return -1;
    const float *z = kit_image_channel(&frame, "Z");
    for (int i = 0; i < picture->width * picture->height; ++i) {
        float origin[3], direction[3], rgb[3];
        if (z[i] > 0) continue;
        kit_camera_ray(&g->camera, i % picture->width, i / picture->width, origin, direction);
        kit_env_radiance(env, direction, rgb);
        for (size_t c = 0; c < 3; ++c) picture->data[c * pixels + (size_t)i] = rgb[c];
    }
    kit_image_free(&frame);
    return 0;
}

int render_write(const job *j, const kit_gbuffer *g, kit_image *picture, int lit, const char *path, kit_error *err)
{
    const int colours = j->o.colours, rgb = lit || colours;
    if (colours && colour(picture, g, err)) return -1;
    if (j->o.backdrop && lit && add_backdrop(picture, g, &j->lighting.env, err)) return -1;
    return strcmp(strrchr(path, '.'), ".png") ? kit_exr_write(picture, path, err)
                                              : kit_png_write(picture, kit_image_channel(picture, "Y") ? "Y" : "R,G,B", rgb,
                                                                path, err);
}

/* Saves the G-buffer with its camera and radius, and with the depth layers and slabs that the settings added. */
static int save_frame(job *j, kit_error *err)
{
    kit_header header = { .has = KIT_HEADER_RADIUS, .radius = (float)j->radius };
    kit_image frame;
    int failed = 0;
    memcpy(header.origin, j->origin, sizeof header.origin);
    kit_camera_to_header(&header, &j->gbuffer.camera);
    if (!j->o.sets || !j->world.scene) return kit_exr_write_frame(&j->r.frame, &header, j->o.save, err);
    if (!j->r.run && kit_run_open(&j->run, &j->gbuffer, &j->method, (float)j->radius, &j->world, err)) return -1;
    failed = kit_gbuffer_read(&frame, j->run.gbuffer, err);
    if (!j->r.run) kit_run_close(&j->run);
    if (failed) return -1;
    failed = kit_exr_write_frame(&frame, &header, j->o.save, err);
    kit_image_free(&frame);
    return failed;
}

/* Prints which normals the ground truth and the scores use, if the mesh's normals differ from its faces'. */
static int tell_normals(const job *j, kit_error *err)
{
    const options *o = &j->o;
    kit_agreement a;
    if (!o->scene || !(o->truth || o->score)) return 0;
    if (kit_frame_agreement(&a, &j->r.frame, &j->gbuffer.camera, err)) return -1;
    if (!(a.angle > 5)) return 0;
    const int faces = !o->truth && (o->flat || j->method.set.normal || j->method.set.facets);
    fprintf(stderr, "render: note: --%s: is about %s; the mesh's own normals lean off its faces by %.0f degrees "
                    "(median)%s\n",
            o->truth ? "truth" : "score", faces ? "the faces" : "the mesh's own normals", a.angle,
            o->truth ? "; --flat: about the faces"
            : faces  ? "; a --truth with --flat is about the faces, too"
                     : "; --set facets=1, or normal=depth: about the faces, as a --truth with --flat");
    return 0;
}

static int do_job(job *j, kit_error *err)
{
    const options *o = &j->o;
    result *r = &j->r;
    if (o->sequence || o->frames) return render_play(j, err);
    if (render_open_settings(j, err)
        || (o->gbuffer ? render_open_frame(&j->gbuffer, j, o, err) : render_open_scene(j, err))
        || kit_gbuffer_read(&r->frame, &j->gbuffer, err)) return -1;
    if (tell_normals(j, err) || (o->planned && plan_it(j, err))) return -1;
    if (o->truth || o->floor) {
        if (trace(j, err)) return -1;
    } else if (!r->picture.data && (o->out || o->score || o->time) && draw(j, err)) return -1;
    const int dims = r->lit && r->picture.channels == 1;       /* a plan may dim light by ambient visibility */
    if (dims && kit_light_by(&r->picture, &j->gbuffer, &j->world, (float)j->radius, err)) return -1;
    if (o->score && render_score(r, o->score, &j->gbuffer.camera, j->radius, err)) return -1;
    if (o->save && save_frame(j, err)) return -1;
    if (o->out && render_write(j, &j->gbuffer, &r->picture, r->lit, o->out, err)) return -1;
    render_report(o, &j->method, r, j->radius);
    return 0;
}

static void end_job(job *j)
{
    free(j->r.ms);
    if (j->r.run) kit_run_close(&j->run);
    kit_fields_free();
    kit_gbuffer_free(&j->gbuffer);
    kit_image_free(&j->r.picture);
    kit_image_free(&j->r.frame);
    kit_image_free(&j->lighting.env);
    kit_scene_free(&j->scene);
    kit_gl_close();
}

int main(int argc, char **argv)
{
    static job j;
    kit_error err = { "" };
    int failed;
    kit_streams_open();
    if (render_help(argc, argv)) return kit_streams_close(&err) ? fail(err.text) : 0;
    j.world.lighting = &j.lighting;
    failed = render_parse(&j.o, argc, argv, &err);
    if (!failed && j.o.list) failed = render_list(j.o.listed, &err);
    else if (!failed) failed = do_job(&j, &err);
    if (failed) return fail(err.text);
    if (kit_streams_close(&err)) return fail(err.text);
    if (!j.o.list) end_job(&j);
    return j.unmet;
}
