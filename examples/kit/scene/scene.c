/* scene.c - loads scenes by name, or a model's file with a camera that frames it; places and moves objects. Declared in
   kit.h. */
#include "kit/kit_build.h"
#include "kit/kit_models.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>


const char *kit_scene_builtin(int i, const char **about)
{
    const kit_builtin *b = kit_builtin_at(i);
    if (b && about) *about = b->about;
    return b ? b->name : NULL;
}

/* Continues a scene; after a failure its triangles and objects are unchanged, perhaps with more after them. */
static kit_build resume(const kit_scene *scene)
{
    kit_build b;
    memset(&b, 0, sizeof b);
    b.scene = *scene;
    b.capacity = scene->mesh.triangles;
    return b;
}

/* Frames the bounds from the front, above and to the right, as near as possible with all of their corners in view. */
static void frame_bounds(kit_camera *camera, const kit_mesh *mesh)
{
    double back[3] = { 0.45, 0.35, 1 }, up[3] = { 0, 1, 0 }, right[3], centre[3], distance = 0;
    const double tangent = tan((double)camera->fovy * KIT_PI / 360) / 1.06,
                 aspect = (double)camera->width / camera->height;
    kit_unit(back);
    kit_cross(up, back, right);
    kit_unit(right);
    kit_cross(back, right, up);
    for (int i = 0; i < 3; i++) centre[i] = 0.5 * ((double)mesh->lower[i] + (double)mesh->upper[i]);
    for (int k = 0; k < 8; k++) {
        double corner[3], x, y, z;
        for (int i = 0; i < 3; i++) corner[i] = (double)(k >> i & 1 ? mesh->upper[i] : mesh->lower[i]) - centre[i];
        x = fabs(kit_dot(corner, right)) / (tangent * aspect);
        y = fabs(kit_dot(corner, up)) / tangent;
        z = kit_dot(corner, back);
        distance = fmax(distance, z + fmax(x, y));
    }
    for (int i = 0; i < 3; i++) {
        camera->target[i] = (float)centre[i];
        camera->eye[i] = (float)(centre[i] + distance * back[i]);
    }
}

/* Lists the built-in scenes' names, as far as there is room. */
static void list_names(char *names, size_t size)
{
    size_t used = 0;
    for (int i = 0; kit_builtin_at(i) && used < size; i++)
        used += (size_t)snprintf(names + used, size - used, "%s%s", i ? ", " : "", kit_builtin_at(i)->name);
}

static int from_file(kit_scene *scene, const char *path, int floor_, kit_error *err)
{
    int failed = 0;
    if (access(path, R_OK)) {              /* checked by access, because opening a pipe would wait for its writer */
        char names[sizeof err->text] = "";
        list_names(names, sizeof names);
        return kit_fail(err, "scene '%s': neither a file that can be read nor a built-in scene (%s, random:SEED, "
                             "model:NAME)", path, names);
    }
    if (kit_model_read(&scene->mesh, &scene->object, &scene->objects, scene->note, path, err)) return -1;
    for (int k = 0; k < scene->objects; k++) scene->object[k].shape = -1;
    const double diagonal = kit_diagonal(scene->mesh.lower, scene->mesh.upper);
    scene->name = path;
    scene->about = "model from a file";
    scene->radius = (float)(0.1 * diagonal);
    scene->camera.fovy = 45;
    frame_bounds(&scene->camera, &scene->mesh);
    if (floor_) {
        kit_build b = resume(scene);
        const double x = 0.5 * ((double)scene->mesh.lower[0] + (double)scene->mesh.upper[0]);
        const double z = 0.5 * ((double)scene->mesh.lower[2] + (double)scene->mesh.upper[2]), half = 2.5 * diagonal,
                     y = (double)scene->mesh.lower[1];
        const double corner[4][3] = {
            { x - half, y, z + half }, { x + half, y, z + half }, { x + half, y, z - half }, { x - half, y, z - half }
        };
        kit_colour(&b, 0.8, 0.8, 0.8);
        kit_begin_object(&b, "floor", -1);
        kit_sheet(&b, (const double (*)[3])corner, KIT_CUTS(kit_both), KIT_CUTS(kit_both));
        *scene = b.scene;
        failed = b.failed;
    }
    if (failed || kit_complete(scene, 0)) {
        kit_scene_free(scene);
        return kit_fail(err, "scene '%s': no memory for its floor or objects", path);
    }
    return 0;
}

int kit_scene_load(kit_scene *scene, const char *name_or_path, int floor_, kit_error *err)
{
    kit_scene s;
    memset(&s, 0, sizeof s);
    s.camera.up[1] = 1;
    s.camera.width = 1280;
    s.camera.height = 720;
    for (int i = 0; kit_builtin_at(i); i++) {
        const kit_builtin *from = kit_builtin_at(i);
        kit_build b;
        if (strcmp(name_or_path, from->name)) continue;
        memset(&b, 0, sizeof b);
        b.random = b.object = 1;
        b.scene = s;
        kit_colour(&b, 0.8, 0.8, 0.8);
        from->make(&b);
        if (!b.scene.objects) kit_begin_object(&b, from->name, -1);
        s = b.scene;
        if (b.failed || kit_complete(&s, 0)) {
            kit_scene_free(&s);
            return kit_fail(err, "scene '%s': no memory", name_or_path);
        }
        s.name = from->name;
        s.about = from->about;
        s.radius = from->radius;
        memcpy(s.camera.eye, from->eye, sizeof from->eye);
        memcpy(s.camera.target, from->target, sizeof from->target);
        s.camera.fovy = from->fovy;
        s.camera.znear = from->znear;
        *scene = s;
        return 0;
    }
    if (kit_scene_seeded(name_or_path)) return kit_load_seeded(scene, name_or_path, err);
    if (from_file(&s, name_or_path, floor_, err)) return -1;
    *scene = s;
    return 0;
}

int kit_scene_add_box(kit_scene *scene, const float lower[3], const float upper[3], const float albedo[3],
                      kit_error *err)
{
    const kit_scene before = *scene;
    kit_build b = resume(scene);
    for (int i = 0; i < 3; i++) {
        if (!isfinite(upper[i] - lower[i]) || upper[i] - lower[i] < 1e-4f)
            return kit_fail(err, "box: sides (upper - lower) must be finite and at least 1e-4, not %g",
                            (double)(upper[i] - lower[i]));
        if (!(albedo[i] >= 0 && albedo[i] <= 1))
            return kit_fail(err, "box: albedo must be in [0, 1], not %g", (double)albedo[i]);
        b.albedo[i] = albedo[i];
    }
    kit_begin_object(&b, "box", -1);
    kit_box(&b, (double)lower[0], (double)lower[1], (double)lower[2], (double)upper[0], (double)upper[1],
            (double)upper[2]);
    *scene = b.scene;
    if (b.failed || kit_complete(scene, before.objects)) {
        scene->mesh.triangles = before.mesh.triangles;
        scene->objects = before.objects;
        return kit_fail(err, "scene '%s': no memory for a box", scene->name);
    }
    return 0;
}

int kit_scene_place(kit_scene *scene, int object_, const float to_world[16], kit_error *err)
{
    double column[3][3], third[3], scale;
    if (object_ < 0 || object_ >= scene->objects)
        return kit_fail(err, "scene '%s': there is no object %d (0..%d)", scene->name, object_, scene->objects - 1);
    for (int i = 0; i < 12; i++) if (i % 4 < 3) column[i / 4][i % 4] = (double)to_world[i];
    scale = sqrt(kit_dot(column[0], column[0]));
    kit_cross(column[0], column[1], third);
    for (int i = 0; i < 3; i++) third[i] -= scale * column[2][i];
    if (!(scale > 0 && scale < 1e15) || !(sqrt(kit_dot(third, third)) < 1e-3 * scale * scale)
        || !(fabs(kit_dot(column[0], column[1])) < 1e-3 * scale * scale)
        || !(fabs(kit_dot(column[1], column[1]) - scale * scale) < 2e-3 * scale * scale) || to_world[3] != 0
        || to_world[7] != 0 || to_world[11] != 0 || to_world[15] != 1
        || !(fmaxf(fabsf(to_world[12]), fmaxf(fabsf(to_world[13]), fabsf(to_world[14]))) < 1e15f))
        return kit_fail(err, "scene '%s', object '%s': its place must be a rotation, a uniform scale and a translation",
                        scene->name, scene->object[object_].name);
    kit_set_place(scene, object_, to_world);
    kit_mesh_bounds(&scene->mesh);
    return 0;
}

int kit_scene_slide(kit_scene *scene, const float by[3], int times, kit_error *err)
{
    float to[16];
    int k = 0;
    if (!(by[0] != 0 || by[1] != 0 || by[2] != 0)) return 0;
    while (k < scene->objects && !scene->object[k].casts) ++k;
    if (k == scene->objects) return kit_fail(err, "--slide: scene %s has no object that casts", scene->name);
    if (!times) return 0;
    memcpy(to, scene->object[k].to_world, sizeof to);
    for (int i = 0; i < 3; ++i) to[12 + i] += (float)times * by[i];
    return kit_scene_place(scene, k, to, err);
}

void kit_scene_move(kit_scene *scene, double time)
{
    for (int k = 0; k < scene->objects; k++) {
        const kit_object *o = &scene->object[k];
        const float *from = o->loaded, *base = scene->object[o->base].loaded;
        const int way = o->base % 3, hops = 1 + o->base % 2;
        const double size = sqrt((double)base[0] * (double)base[0] + (double)base[1] * (double)base[1]
                                 + (double)base[2] * (double)base[2]);
        const double start = 2.4 * o->base, now = start + 2 * KIT_PI * time, hop = sin(KIT_PI * time * hops);
        double arm[3];
        kit_build b;
        float m[16];
        if (!(from[15] > 0)) continue;
        memset(&b, 0, sizeof b);
        b.turn = hops > 1 ? 360 * time : -360 * time;
        if (way == 2) b.tilt = 360 * time;
        for (int i = 0; i < 3; i++) arm[i] = (double)from[12 + i] - (double)base[12 + i];
        kit_rotate(&b, arm, b.at);
        for (int i = 0; i < 3; i++) b.at[i] -= arm[i];
        if (way == 0) {
            b.at[0] += 0.3 * size * (cos(now) - cos(start));
            b.at[2] += 0.3 * size * (sin(now) - sin(start));
        }
        if (way == 1) b.at[1] += 0.6 * size * hop * hop;
        kit_pose(&b, from, m);
        kit_place_above(scene, k, m, KIT_GAP);
    }
    kit_mesh_bounds(&scene->mesh);
}
