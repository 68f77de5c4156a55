/* look.c - scenes by seed: their frames, and their truth, which is kept under build/cache. Declared in look.h. */
#include "lab/against/look.h"
#include <math.h>
#include <stdlib.h>

look *place_look(place *p, int by) { return &p->by[by == SLABS || by == SCENE ? FRAME : by]; }

void place_frame(char path[64], const place *p, int by)
{
    static const char *const of[VIEWS] = { "", "-slabs", "-orthographic", "", "-turned" };
    snprintf(path, 64, LOOK_FOLDER "/%d%s.exr", p->seed, of[by]);
}

int look_middles(kit_image *out, const kit_image *in, kit_error *err)
{
    const char *names = in->channels > 1 ? KIT_LIT_CHANNELS : in->name[0];
    if (kit_image_new(out, in->width / LOOK_STRIDE, in->height / LOOK_STRIDE, names, err)) return -1;
    for (int c = 0; c < out->channels; ++c) {
        const float *from = kit_image_channel(in, out->name[c]);
        float *to = kit_image_channel(out, out->name[c]);
        for (int i = 0; i < out->width * out->height; ++i) {
            const int x = i % out->width, y = i / out->width;
            to[i] = from[(y * LOOK_STRIDE + LOOK_STRIDE / 2) * in->width + x * LOOK_STRIDE + LOOK_STRIDE / 2];
        }
    }
    return 0;
}

/* Traces the truth and takes the middle pixel of each block of LOOK_STRIDE x LOOK_STRIDE pixels. */
static int trace(kit_image *out, const stage *s, const lit *light, float radius, kit_error *err)
{
    stage of = *s;
    of.lit = light;
    of.radius = radius;
    of.rays = SEED_RAYS;
    of.stride = LOOK_STRIDE;
    if (stage_truth(&of, err)) return -1;
    const int failed = look_middles(out, &of.truth, err);
    kit_image_free(&of.truth);
    return failed;
}

/* The scene's own light with a bounce and without. OPEN: a factor so small that OPEN * radius reaches no occluder. */
static const lit own_light = { .rays = SEED_RAYS, .exposure = 1, .bounce = 1 },
                 open_light = { .rays = SEED_RAYS, .exposure = 1 };
static const float OPEN = 1e-4f;

static int know_visibility(look *l, const stage *s, kit_error *err)
{
    if (trace(&l->truth[0], s, NULL, s->radius, err)
        || kit_image_new(&l->nothing[0], l->middles.width, l->middles.height, "Y", err))
        return -1;
    for (int i = 0; i < l->middles.width * l->middles.height; ++i) l->nothing[0].data[i] = 1;
    return 0;
}

static int know_light(look *l, const stage *s, kit_error *err)
{
    double sum = 0, values = 0;
    if (trace(&l->truth[1], s, &own_light, s->radius, err)
        || trace(&l->nothing[1], s, &open_light, OPEN * s->radius, err))
        return -1;
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < l->middles.width * l->middles.height; ++i) {
            if (!(l->middles.data[i] > 0)) continue;
            sum += (double)kit_image_channel(&l->nothing[1], quantities[IRRADIANCE].channel[c])[i];
            values += 1;
        }
    l->light = sum / values;
    return l->light > 0 ? 0 : kit_fail(err, "%s: has no light", s->name);
}

static int save(const stage *s, const place *p, int by, kit_error *err)
{
    kit_header header = { .has = KIT_HEADER_RADIUS, .radius = s->radius };
    kit_image frame;
    char path[64];
    place_frame(path, p, by);
    if (kit_gbuffer_read(&frame, &s->gbuffer, err)) return -1;
    kit_camera_to_header(&header, &s->gbuffer.camera);
    const int failed = kit_exr_write_frame(&frame, &header, path, err);
    kit_image_free(&frame);
    return failed;
}

/* Returns the height of an orthographic view: the perspective view's height at the median of the visible depths. */
static float ortho_height(const kit_camera *camera, const kit_image *shown)
{
    const int pixels = shown->width * shown->height;
    size_t count = 0;
    float *z = malloc((size_t)pixels * sizeof *z), height = 1;
    for (int i = 0; i < pixels && z; ++i)
        if (shown->data[i] > 0) z[count++] = shown->data[i];
    if (count) height = (float)(2 * tan((double)camera->fovy * KIT_PI / 360) * (double)kit_middle(z, count));
    free(z);
    return height;
}

/* Returns the truths that the rows of a view need: 1 for visibility, plus 2 for light. */
static int wants(const int *wanted, int by)
{
    int all = 0;
    for (int i = 0; i < subjects_count; ++i)
        if (wanted[i] && subjects[i].view == by) all |= 1 << quantities[subjects[i].quantity].lit;
    return all;
}

static int see(place *p, stage *s, int by, const int *wanted, kit_error *err)
{
    look *l = place_look(p, by);
    const int of = wants(wanted, by) | (by == FRAME ? wants(wanted, SLABS) | wants(wanted, SCENE) : 0);
    kit_camera camera = s->scene.camera;
    camera.width = LOOK_WIDTH;
    camera.height = LOOK_HEIGHT;
    if (by == ORTHOGRAPHIC) {
        camera.ortho_height = ortho_height(&camera, &p->by[FRAME].shown);
        camera.fovy = 0;
    }
    if (by == TURNED) kit_camera_orbit(&camera, &s->scene.camera, LOOK_ORBIT * (LOOK_FRAMES - 1));
    if (by != FRAME && !of) return 0;
    if (kit_gbuffer_from_scene(&s->gbuffer, &s->scene, &camera, NULL, err)
        || kit_gbuffer_read_depth(&l->shown, &s->gbuffer, err) || look_middles(&l->middles, &l->shown, err)
        || save(s, p, by, err))
        return -1;
    if (by == FRAME && wants(wanted, SLABS)
        && (kit_gbuffer_slabs(&s->gbuffer, &s->scene, 2, err) || save(s, p, SLABS, err)))
        return -1;
    if ((of & 1 && know_visibility(l, s, err)) || (of & 2 && know_light(l, s, err))) return -1;
    kit_gbuffer_free(&s->gbuffer);
    return 0;
}

int place_open(place *p, int seed, const int *wanted, kit_error *err)
{
    stage s;
    p->seed = seed;
    snprintf(p->name, sizeof p->name, "random:%d", seed);
    const view v = { .name = p->name, .path = p->name, .lit = &own_light };
    if (stage_load(&s, &v, err)) return -1;
    snprintf(p->env, sizeof p->env, "%s", s.scene.env);
    s.radius = s.scene.radius;
    if (see(p, &s, FRAME, wanted, err) || see(p, &s, ORTHOGRAPHIC, wanted, err) || see(p, &s, TURNED, wanted, err))
        return -1;
    stage_close(&s);
    return 0;
}
