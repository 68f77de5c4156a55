/* shot.c - draws a scene as one frame of a sweep shows it. Declared in shot.h. */
#include "lab/stability/shot.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>opening --------------------------------------------------------------------------------------------------- */

/* Stores the frame's depth in another format, as look's format says. */
static int recode(shot *s, int format, kit_error *err)
{
    kit_gbuffer *g = &s->gbuffer;
    const float *z = kit_image_channel(&s->frame, "Z"), *p = g->projection;
    const int linear = format == EXACT || format == HALF, reversed = format == REVERSED32;
    float view[16], *texel = malloc((size_t)g->width * (size_t)g->height * sizeof *texel);
    if (!texel) return kit_fail(err, "out of memory");
    g->camera.depth = reversed ? KIT_DEPTH_REVERSED : KIT_DEPTH_NORMAL;
    g->depth_is_linear = linear;
    kit_camera_matrices(&g->camera, view, g->projection);
    for (int i = 0; i < g->width * g->height; ++i) {
        const double d = (double)z[(g->height - 1 - i / g->width) * g->width + i % g->width];
        int e;
        const double m = frexp(d, &e), half = ldexp(rint(ldexp(m, 11)), e - 11);
        const double clip = d > 0 ? ((double)p[14] - (double)p[10] * d) / d : 1 - reversed,
                     window = reversed ? clip : 0.5 + 0.5 * clip;
        texel[i] = (float)(format == EXACT     ? d
                           : format == HALF    ? half > 65504 ? HUGE_VAL : half
                           : format == UNORM24 ? rint(window * 16777215) / 16777215
                                               : window);
    }
    glDeleteTextures(1, &g->depth);
    g->depth = kit_texture(g->width, g->height, linear ? GL_R32F : GL_DEPTH_COMPONENT32F, texel);
    free(texel);
    return 0;
}

/* Finds the pixels that are scored, and the object that each pixel shows. */
static int look_around(shot *s, const look *l, kit_error *err)
{
    const int width = s->gbuffer.width, height = s->gbuffer.height;
    const size_t pixels = (size_t)width * (size_t)height;
    const float *z = kit_image_channel(&s->frame, "Z");
    uint32_t *shown = malloc(pixels * sizeof *shown);
    s->mask = calloc(pixels, sizeof *s->mask);
    s->object = malloc(pixels * sizeof *s->object);
    if (!shown || !s->mask || !s->object) return kit_fail(err, "out of memory");
    if (kit_texture_read(s->gbuffer.object, width, height, 1, (float *)(void *)shown))
        return kit_fail(err, "object numbers cannot be read");
    for (int i = 0; i < width * height; ++i) {
        float p[3];
        s->object[i] = shown[(height - 1 - i / width) * width + i % width];
        if (!(z[i] > 0)) continue;
        kit_camera_point(&s->gbuffer.camera, i % width, i / width, (double)z[i], p);
        s->mask[i] = 1;
        for (int c = 0; c < 3; ++c)
            if (l->where[c] < l->where[3 + c] && (p[c] < l->where[c] || p[c] > l->where[3 + c])) s->mask[i] = 0;
    }
    free(shown);
    return 0;
}

/* Turns a vector v about an axis. */
static void turn(float v[3], const float about[3], float degrees)
{
    const float c = cosf(degrees * DEGREE), s = sinf(degrees * DEGREE);
    double axis[3] = { (double)about[0], (double)about[1], (double)about[2] };
    float out[3], along = 0;
    kit_unit(axis);
    for (int i = 0; i < 3; ++i) along += v[i] * (float)axis[i];
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        out[i] = c * v[i] + s * ((float)axis[j] * v[k] - (float)axis[k] * v[j]) + (1 - c) * along * (float)axis[i];
    }
    memcpy(v, out, sizeof out);
}

float shot_aim(kit_camera *c, const look *l)
{
    float away[3], right[3], length = 0, size = 0;
    if (l->fovy > 0) {
        memcpy(c->eye, l->eye, sizeof c->eye);
        memcpy(c->target, l->target, sizeof c->target);
        c->fovy = l->fovy;
    }
    if (l->up[1] != 0 || l->up[2] != 0) memcpy(c->up, l->up, sizeof c->up);
    for (int i = 0; i < 3; ++i) {
        if (l->scale > 0) c->eye[i] *= l->scale;
        if (l->scale > 0) c->target[i] *= l->scale;
        away[i] = c->target[i] - c->eye[i];
        length += away[i] * away[i];
    }
    for (int i = 0; i < 3; ++i) {
        right[i] = away[(i + 1) % 3] * c->up[(i + 2) % 3] - away[(i + 2) % 3] * c->up[(i + 1) % 3];
        size += right[i] * right[i];
    }
    const float pixel = 2 * sqrtf(length) * tanf(0.5f * c->fovy * DEGREE) / (float)l->height;
    for (int i = 0; i < 3; ++i) {
        const float move = l->aside * pixel * right[i] / sqrtf(size);
        c->eye[i] += move + l->nearer * away[i];
        c->target[i] += move;
        away[i] = c->target[i] - c->eye[i];
    }
    if (l->orbit != 0) {
        turn(away, c->up, l->orbit);
        for (int i = 0; i < 3; ++i) c->eye[i] = c->target[i] - away[i];
    }
    if (l->roll != 0) turn(c->up, away, l->roll);
    memcpy(c->shift, l->shift, sizeof c->shift);
    c->width = l->width;
    c->height = l->height;
    if (l->znear > 0) c->znear = l->znear;
    c->zfar = l->zfar;
    c->depth = KIT_DEPTH_REVERSED;
    return pixel;
}

static int drawn(kit_image *out, shot *s, const char *method, const char *set, float radius, kit_error *err)
{
    const kit_world world = { &s->scene, &s->lighting };
    return picture_drawn(out, &s->gbuffer, &world, method, set, radius, err);
}

/* Changes a look's scene: adds boxes; hides all casters but one in the ground, if that is asked for; scales. */
static int furnish(shot *s, const look *l, kit_error *err)
{
    static const float grey[2][3] = { { 0.7f, 0.7f, 0.7f }, { 0, 0, 0 } },
                       hidden[16] = { 1e-3f, 0, 0, 0, 0, 1e-3f, 0, 0, 0, 0, 1e-3f, 0, 0, -0.1f, 0, 1 };
    kit_mesh *mesh = &s->scene.mesh;
    for (const float(*b)[6] = l->box; b < l->box + BOXES && (*b)[4] > (*b)[1]; ++b)
        if (kit_scene_add_box(&s->scene, *b, *b + 3, grey[b + 1 == l->box + l->black], err)) return -1;
    for (int i = 0, found = 0; l->only && i < s->scene.objects; ++i) {
        kit_object *o = &s->scene.object[i];
        const int it = o->casts && !found && !strcmp(o->name, l->only);
        if (!o->casts) continue;
        if (kit_scene_place(&s->scene, i, it ? l->placed : hidden, err)) return -1;
        found |= it;
        o->casts = it;
    }
    for (size_t i = 0; l->scale > 0 && i < 9 * mesh->triangles; ++i) mesh->position[i] *= l->scale;
    for (int i = 0; l->scale > 0 && i < 3; ++i) { mesh->lower[i] *= l->scale; mesh->upper[i] *= l->scale; }
    for (int i = 0; i < s->scene.objects && i < MOST_OBJECTS; ++i)
        memcpy(s->to_world[i], s->scene.object[i].to_world, sizeof s->to_world[i]);
    return 0;
}

/* Makes an environment so many times smaller each way: preparing it for each frame took most of the time. */
static int shrink(kit_image *env, int times, kit_error *err)
{
    kit_image small;
    if (kit_image_new(&small, env->width / times, env->height / times, "R,G,B", err)) return -1;
    for (int i = 0; i < 3 * env->width * env->height; ++i)
        small.data[i / env->width / times * small.width + i % env->width / times] +=
            env->data[i] / (float)(times * times);
    kit_image_free(env);
    *env = small;
    return 0;
}

static int light_up(shot *s, const look *l, kit_error *err)
{
    const float b = 3 * (1 - l->dimmed);
    const kit_light sun = { KIT_SUN, { l->sun[0], l->sun[1], l->sun[2] }, { b, b, b } };
    const int lit = l->sun[1] > 0;
    if (l->lamp < 0) {
        s->lighting.light[s->lighting.lights++] = sun;
        return 0;
    }
    if (l->lamp > 0) return kit_env_add_sun(&s->lighting.env, &sun, (double)l->lamp, err);
    if (kit_env_read(&s->lighting.env, lit ? "sky" : "white", err)) return -1;
    return (lit && kit_env_add_sun(&s->lighting.env, &sun, SUN_DEGREES, err)) || shrink(&s->lighting.env, 4, err) ? -1
                                                                                                               : 0;
}

/* Makes the bounce the light that shot_values finds. */
static void keep_bounce(kit_image *i)
{
    memcpy(kit_image_channel(i, "irradiance.G"), kit_image_channel(i, "bounce.G"),
           (size_t)i->width * (size_t)i->height * sizeof *i->data);
}

static int trace(shot *s, const look *l, const int truths[2], kit_error *err)
{
    static const char open[] = "bounce=none,blur=0,shadows=none";
    const kit_camera *c = &s->gbuffer.camera;
    const float nothing = 1e-4f * s->radius;               /* a radius in which nothing blocks */
    const int lit = l->sun[1] > 0;
    for (int k = 0; k < 2; ++k) {
        const int fades = k ? KIT_ATTENUATION_NONE : KIT_ATTENUATION_LINEAR;
        kit_image *truth = &s->truth[k];
        if (!truths[k]) continue;
        /* Without occlusion the truth is the change of the light itself. */
        if (lit && !l->within  ? drawn(truth, s, "ssdo-points", open, nothing, err)
            : lit              ? kit_truth_lit(truth, &s->scene, c, &s->lighting, s->radius, fades, l->bounced, l->rays,
                                               l->stride, err)
            : k                ? kit_truth_objects(truth, &s->scene, c, l->rays, l->stride, err)
                               : kit_truth_ao(truth, &s->scene, c, s->radius, fades, l->rays, l->stride, err))
            return -1;
        if (l->bounced) keep_bounce(truth);
    }
    return l->bounced   ? kit_image_new(&s->none, l->width, l->height, "Y", err)
           : l->lamp != 0 ? drawn(&s->none, s, "ssdo-points", open, nothing, err)
                          : 0;
}

/* Writes the motion vectors of the first box, which moves along the picture's rows; all else stands still. */
static int tell_motion(shot *s, const look *l, kit_error *err)
{
    static const float SLACK = 1e-3f;
    kit_gbuffer *g = &s->gbuffer;
    const float *z = kit_image_channel(&s->frame, "Z"), *b = l->box[0];
    float (*went)[2] = calloc((size_t)g->width * (size_t)g->height, sizeof *went);
    if (!went) return kit_fail(err, "out of memory");
    for (int i = 0; i < g->width * g->height; ++i) {
        float p[3];
        int within = z[i] > 0;
        if (within) shot_place(s, i, p);
        for (int k = 0; k < 3 && within; ++k) within = p[k] > b[k] - SLACK && p[k] < b[3 + k] + SLACK;
        if (within)
            went[(g->height - 1 - i / g->width) * g->width + i % g->width][0] =
                l->went * (float)g->height / (2 * z[i] * tanf(0.5f * g->camera.fovy * DEGREE));
    }
    g->motion = kit_texture(g->width, g->height, GL_RG32F, went[0]);
    free(went);
    return 0;
}

int shot_open(shot *s, const look *l, const int truths[2], kit_error *err)
{
    memset(s, 0, sizeof *s);
    s->look = *l;
    if (kit_scene_load(&s->scene, l->scene, 0, err) || furnish(s, l, err)) return -1;
    kit_camera c = s->scene.camera;
    const float pixel = shot_aim(&c, l), scale = l->scale > 0 ? l->scale : 1;
    s->radius = l->pixels > 0 ? l->pixels * pixel : (l->radius > 0 ? l->radius : s->scene.radius) * scale;
    return kit_gbuffer_from_scene(&s->gbuffer, &s->scene, &c, NULL, err)
                   || kit_gbuffer_read(&s->frame, &s->gbuffer, err) || look_around(s, l, err)
                   || (l->format && recode(s, l->format, err)) || (l->told && tell_motion(s, l, err))
                   || light_up(s, l, err)
               ? -1
               : trace(s, l, truths, err);
}

void shot_close(shot *s)
{
    for (int m = 0; m < MOST_METHODS; ++m) { kit_image_free(&s->picture[m]); kit_image_free(&s->single[m]); }
    for (int k = 0; k < 2; ++k) kit_image_free(&s->truth[k]);
    kit_image_free(&s->none);
    kit_image_free(&s->frame);
    kit_image_free(&s->lighting.env);
    kit_gbuffer_free(&s->gbuffer);
    kit_scene_free(&s->scene);
    free(s->mask);
    free(s->object);
}

/* ---- >>pictures -------------------------------------------------------------------------------------------------- */

float *shot_values(const kit_image *i) { return kit_image_channel(i, i->channels > 1 ? "irradiance.G" : "Y"); }

int shot_draw(shot *s, int m, kit_error *err)
{
    char settings[128];
    snprintf(settings, sizeof settings, "%s%s", sweeps_method[m].settings, s->look.set);
    if (drawn(&s->picture[m], s, sweeps_method[m].method, settings, s->radius, err)) return -1;
    if (s->look.bounced) keep_bounce(&s->picture[m]);
    return 0;
}

int shot_draw_kept(shot *s, int m, kit_frames *frames, kit_error *err)
{
    const kit_world world = { &s->scene, &s->lighting };
    kit_method made;
    if (kit_method_find(&made, sweeps_method[m].method, err) || kit_method_set(&made, sweeps_method[m].settings, err)
        || kit_frames_next(frames, &s->gbuffer, &made, s->radius, &world, &s->single[m], err))
        return -1;
    kit_run_draw(frames->now, 0);
    return kit_run_read(&s->picture[m], frames->now, err);
}

int shot_value_at(double *value, const shot *s, const kit_image *picture, const float p[3], uint32_t object)
{
    const picture_view seen = { &s->frame, &s->gbuffer.camera, s->object };
    return picture_at(value, shot_values(picture), &seen, p, object);
}

void shot_place(const shot *s, int pixel, float p[3])
{
    const int width = s->frame.width;
    kit_camera_point(&s->gbuffer.camera, pixel % width, pixel / width,
                     (double)kit_image_channel(&s->frame, "Z")[pixel], p);
}

/* ---- >>figures --------------------------------------------------------------------------------------------------- */

double shot_apart(const kit_image *a, const kit_image *b, const float *mask)
{
    double sum = 0;
    size_t count = 0;
    for (int i = 0; i < b->width * b->height; ++i) {
        if (!(mask[i] > 0) || isnan(shot_values(b)[i])) continue;
        const double d = (a->data ? (double)shot_values(a)[i] : 1) - (double)shot_values(b)[i];
        sum += isnan(d) ? 1 : d * d;
        ++count;
    }
    return sqrt(sum / (double)count);
}

int shot_shades(const kit_image *picture, const float *mask)
{
    int seen[256] = { 0 }, count = 0;
    for (int i = 0; i < picture->width * picture->height; ++i) {
        int *shade = &seen[(int)(fminf(fmaxf(shot_values(picture)[i], 0), 1) * 255 + 0.5f)];
        count += mask[i] > 0 && !*shade;
        *shade |= mask[i] > 0;
    }
    return count;
}

/* Carries a point p along with its object, which stands elsewhere in another frame. */
static void carry(float p[3], const float *from, const float *to)
{
    const float square = from[0] * from[0] + from[1] * from[1] + from[2] * from[2];
    float q[3];
    for (int k = 0; k < 3; ++k)
        q[k] = (from[4 * k] * (p[0] - from[12]) + from[4 * k + 1] * (p[1] - from[13])
                + from[4 * k + 2] * (p[2] - from[14]))
               / square;
    for (int k = 0; k < 3; ++k) p[k] = to[k] * q[0] + to[4 + k] * q[1] + to[8 + k] * q[2] + to[12 + k];
}

/* Writes the values of so many pictures at the point that a pixel of the first one shows, carried along with its
   object. Returns 0 if some frame does not show the point. */
static int followed(double *v, const shot *shots, int frames, const kit_image *const *pictures, int pixel)
{
    const uint32_t o = shots->object[pixel];
    float p[3];
    if (!(shots->mask[pixel] > 0)) return 0;
    shot_place(shots, pixel, p);
    for (int k = 0; k < frames; ++k) {
        const float *from = shots->to_world[(o - 1) % MOST_OBJECTS], *to = shots[k].to_world[(o - 1) % MOST_OBJECTS];
        float q[3];
        memcpy(q, p, sizeof q);
        if (o > 0 && o <= MOST_OBJECTS && memcmp(from, to, sizeof *shots->to_world)) carry(q, from, to);
        if (!shot_value_at(&v[k], &shots[k], pictures[k], q, o)) return 0;
    }
    return 1;
}

int shot_varies(double *square, double *mean, const shot *shots, int frames, const kit_image *const *pictures,
                int pixel, int second)
{
    double v[MOST_FRAMES];
    if (!followed(v, shots, frames, pictures, pixel)) return 0;
    *mean = *square = 0;
    for (int k = 0; k < frames; ++k) *mean += v[k] / frames;
    for (int k = 0; k < frames && !second; ++k) *square += (v[k] - *mean) * (v[k] - *mean) / (frames - 1);
    for (int k = 1; k + 1 < frames && second; ++k)
        *square += pow(v[k - 1] - 2 * v[k] + v[k + 1], 2) / (6.0 * (frames - 2));
    return 1;
}
