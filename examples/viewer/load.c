/* load.c - opens scenes and lights by the kit. They replace the present ones only if all could be read. */
#include "viewer.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* sun of scenes that have no light of their own, unless the user chooses one */
static const kit_light noon = { KIT_SUN, { 0.6536847f, 0.3813161f, 0.6536847f }, { 1.8f, 1.5f, 1.1f } };
static const char *const env_of_scenes = "sky";
static const double strength_of_scenes = 0.7;

void light_changed(viewer *v)
{
    truth_stop(&v->truth);
    v->light.asked = v->restart = 1;
}

kit_light *sun_of(viewer *v)
{
    kit_lighting *l = &v->light.now;
    for (int i = 0; i < l->lights; ++i)
        if (l->light[i].kind == KIT_SUN) return &l->light[i];
    if (l->lights == KIT_MAX_LIGHTS) --l->lights;
    l->light[l->lights] = noon;
    return &l->light[l->lights++];
}

static int copy_of(kit_image *out, const kit_image *from, kit_error *err)
{
    if (kit_image_new(out, from->width, from->height, "R,G,B", err)) return -1;
    memcpy(out->data, from->data, 3 * (size_t)from->width * (size_t)from->height * sizeof *out->data);
    return 0;
}

int env_adjusted(viewer *v)
{
    kit_image env = { 0 };
    if (v->light.read.data
        && (copy_of(&env, &v->light.read, &v->err)
            || kit_env_adjust(&env, v->light.turn, v->light.strength, &v->err))) {
        kit_image_free(&env);
        return -1;
    }
    truth_stop(&v->truth);
    kit_image_free(&v->light.now.env);
    v->light.now.env = env;
    if (v->light.texture) glDeleteTextures(1, &v->light.texture);
    v->light.texture = 0;
    v->restart = 1;
    return 0;
}

int env_open(viewer *v, const char *name)
{
    kit_image was = v->light.read;
    char path[VIEWER_PATH] = "";
    kit_image read = { 0 };
    if (strlen(name) >= sizeof path) return kit_fail(&v->err, "environment %.60s...: its name is too long", name);
    strcpy(path, name);
    if (*name && kit_env_read(&read, name, &v->err)) return -1;
    v->light.read = read;
    if (env_adjusted(v)) {
        v->light.read = was;
        kit_image_free(&read);
        return -1;
    }
    strcpy(v->light.env, path);
    kit_image_free(&was);
    return 0;
}

/* Sets a scene's own light or, if it has none, a sky with a sun. */
static int light_of(viewer *v, const kit_scene *scene)
{
    const int own = scene->env || scene->lights;
    v->light.turn = 0;
    v->light.strength = own ? 1 : strength_of_scenes;
    if (env_open(v, own ? scene->env ? scene->env : "" : env_of_scenes)) return -1;
    v->light.now.lights = own ? scene->lights : 1;
    for (int i = 0; i < v->light.now.lights; ++i) v->light.now.light[i] = own ? scene->light[i] : noon;
    return 0;
}

int scene_open(viewer *v, const char *name)
{
    char path[VIEWER_PATH];
    kit_scene scene;
    if (strlen(name) >= sizeof path) return kit_fail(&v->err, "scene %.60s...: its name is too long", name);
    strcpy(path, name);
    if (kit_scene_load(&scene, path, v->ground, &v->err)) return -1;
    if (!v->light.asked && light_of(v, &scene)) {
        kit_scene_free(&scene);
        return -1;
    }
    truth_stop(&v->truth);
    for (int i = 0; i < v->light.now.lights && v->light.asked; ++i) /* the user's lights do not move with the origin */
        for (int k = 0; k < 3 && v->light.now.light[i].kind == KIT_POINT; ++k)
            v->light.now.light[i].at[k] += (float)(v->scene.mesh.origin[k] - scene.mesh.origin[k]);
    draw_forget(v);
    for (int i = 0; i < 2; ++i) kit_frames_close(&v->side[i].frames);
    kit_fields_free();
    kit_scene_free(&v->scene);
    strcpy(v->path, path);
    v->scene = scene;
    v->scene.name = v->path;
    v->camera = v->home = scene.camera;
    v->radius = v->asked_radius > 0 ? v->asked_radius : scene.radius;
    v->slides = 0;
    v->phase = 0;
    for (int k = 0; k < 3; ++k) v->slid[k] = 0;
    v->restart = 1;
    return 0;
}

void dropped(viewer *v, const char *path)
{
    const char *dot = strrchr(path, '.'), *slash = strrchr(path, '/');
    const int is_env = dot && (!strcasecmp(dot, ".hdr") || !strcasecmp(dot, ".exr"));
    char text[sizeof v->note];
    if (is_env ? env_open(v, path) : scene_open(v, path)) {
        fprintf(stderr, "viewer: %s\n", v->err.text);
        panel_say(v, v->err.text);
        return;
    }
    if (is_env) v->light.asked = 1;
    snprintf(text, sizeof text, "%s is shown%s%s", slash ? slash + 1 : path, is_env ? " as the sky" : "",
             is_env || !*v->scene.note ? "" : ": ");
    if (!is_env) snprintf(text + strlen(text), sizeof text - strlen(text), "%s", v->scene.note);
    panel_say(v, text);
}

void load_close(viewer *v)
{
    kit_fields_free();
    kit_image_free(&v->light.read);
    kit_image_free(&v->light.now.env);
    kit_scene_free(&v->scene);
}
