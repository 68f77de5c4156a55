/* stability.c - where methods fail: each is swept through a cause of failure, and its error or flicker plotted against
   it.

      build/stability [--out report] [--quick] [--cause NAME]... [--method NAME]...     stability.html, stability.csv, a
         chart and pictures a cause, a table at the end

   Truth is traced anew each time. Bad input, or a write that fails: one line on stderr, status 2. sweeps.c holds what
   is swept; here is how it is measured and shown. */
#include "kit/kit_gl.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-const-variable"
#include "lab/page/page.h"
#pragma GCC diagnostic pop
#include "sweeps.c"

/* ---- >>shot: a scene as one frame shows it ----------------------------------------------------------------------- */

enum { MOST_FRAMES = FRAMES, MOST_OBJECTS = 64 };
typedef struct shot {
    kit_scene    scene;
    kit_gbuffer  gbuffer;
    kit_lighting lighting;
    kit_image    frame, truth[2], picture[METHODS], single[METHODS];   /* truth: of all, between objects */
    float       *mask, to_world[MOST_OBJECTS][16];       /* mask: above 0 where it is scored */
    uint32_t    *object;
    float        radius;
} shot;

/* Depth as it would be stored elsewhere. */
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

/* What is scored, and which object each pixel shows. */
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
            if (l->where[0][c] < l->where[1][c] && (p[c] < l->where[0][c] || p[c] > l->where[1][c])) s->mask[i] = 0;
    }
    free(shown);
    return 0;
}

/* What is compared: ambient visibility, or, which under white light is the same, irradiance over pi. */
static float *values_of(const kit_image *i) { return kit_image_channel(i, i->channels > 1 ? "irradiance.G" : "Y"); }

static int drawn(kit_image *out, shot *s, const char *name, const char *set_to, float radius, kit_error *err)
{
    const kit_world world = { &s->scene, &s->lighting };
    return kit_run_picture(out, &s->gbuffer, &world, name, set_to, radius, err);
}

/* The same with what the frame before kept, and without, noise alike. */
static int kept(shot *s, int m, kit_frames *frames, kit_error *err)
{
    const kit_world world = { &s->scene, &s->lighting };
    kit_method made;
    if (kit_method_find(&made, methods[m].method, err) || kit_method_set(&made, methods[m].settings, err)
        || kit_frames_next(frames, &s->gbuffer, &made, s->radius, &world, &s->single[m], err))
        return -1;
    kit_run_draw(frames->now, 0);
    return kit_run_read(&s->picture[m], frames->now, err);
}

/* The camera that a look asks for; returns how wide one of its pixels is at the target. */
static float aim(kit_camera *c, const look *l)
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
    const float pixel = 2 * sqrtf(length) * tanf(0.5f * c->fovy * PI_180) / (float)l->height;
    for (int i = 0; i < 3; ++i) {
        const float move = l->aside * pixel * right[i] / sqrtf(size);
        c->eye[i] += move + l->nearer * away[i];
        c->target[i] += move;
    }
    c->width = l->width;
    c->height = l->height;
    if (l->znear > 0) c->znear = l->znear;
    c->zfar = l->zfar;
    c->depth = KIT_DEPTH_REVERSED;
    return pixel;
}

/* truths: which are traced. */
static int shot_open(shot *s, const look *l, const int truths[2], kit_error *err)
{
    static const float grey[3] = { 0.7f, 0.7f, 0.7f },
                       hidden[16] = { 1e-3f, 0, 0, 0, 0, 1e-3f, 0, 0, 0, 0, 1e-3f, 0, 0, -0.1f, 0, 1 };
    const int lit = l->sun[1] > 0;
    const kit_light light = { KIT_SUN, { l->sun[0], l->sun[1], l->sun[2] }, { 3, 3, 3 } };
    memset(s, 0, sizeof *s);
    if (kit_scene_load(&s->scene, l->scene, 0, err)) return -1;
    kit_mesh *mesh = &s->scene.mesh;
    for (const float(*b)[6] = l->box; b < l->box + BOXES && (*b)[4] > (*b)[1]; ++b)
        if (kit_scene_add_box(&s->scene, *b, *b + 3, grey, err)) return -1;
    for (int i = 0, found = 0; l->only && i < s->scene.objects; ++i) {     /* others that cast go into the ground */
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
    kit_camera c = s->scene.camera;
    const float pixel = aim(&c, l);
    s->radius = l->pixels > 0 ? l->pixels * pixel
                              : (l->radius > 0 ? l->radius : s->scene.radius) * (l->scale > 0 ? l->scale : 1);
    if (kit_gbuffer_from_scene(&s->gbuffer, &s->scene, &c, NULL, err) || kit_gbuffer_read(&s->frame, &s->gbuffer, err)
        || look_around(s, l, err))
        return -1;
    if ((l->format && recode(s, l->format, err)) || kit_env_read(&s->lighting.env, lit ? "sky" : "white", err))
        return -1;
    if (lit && kit_env_add_sun(&s->lighting.env, &light, SUN_DEGREES, err)) return -1;
    if (truths[0] && lit && l->within)
        return kit_truth_lit(&s->truth[0], &s->scene, &s->gbuffer.camera, &s->lighting, s->radius,
                             KIT_ATTENUATION_LINEAR, 0, l->rays, l->stride, err);
    /* so small a radius is open: light's own change */
    if (truths[0] && lit) return drawn(&s->truth[0], s, "ssdo-points", "bounce=none,blur=0", 1e-4f * s->radius, err);
    if (truths[0]
        && kit_truth_ao(&s->truth[0], &s->scene, &s->gbuffer.camera, s->radius, KIT_ATTENUATION_LINEAR, l->rays,
                        l->stride, err))
        return -1;
    return truths[1] ? kit_truth_objects(&s->truth[1], &s->scene, &s->gbuffer.camera, l->rays, l->stride, err) : 0;
}

static void shot_close(shot *s)
{
    for (int m = 0; m < METHODS; ++m) { kit_image_free(&s->picture[m]); kit_image_free(&s->single[m]); }
    for (int k = 0; k < 2; ++k) kit_image_free(&s->truth[k]);
    kit_image_free(&s->frame);
    kit_image_free(&s->lighting.env);
    kit_gbuffer_free(&s->gbuffer);
    kit_scene_free(&s->scene);
    free(s->mask);
    free(s->object);
}

/* ---- >>measure --------------------------------------------------------------------------------------------------- */

enum { MOST_CURVES = METHODS + 1, MOST_POINTS = 256 };
typedef struct curve {
    const char *label;
    int       method;                      /* -1: not one of them; -2: what they are seen beside */
    double    y[MOST_POINTS], number, at;  /* number: what it all comes to; at: where */
    kit_image worst;                       /* the frame there, the truth, what is wrong */
} curve;
struct result { const cause *cause; double x[MOST_POINTS]; int points, curves; curve curve[MOST_CURVES]; };

static curve *curve_new(result *r, const char *label, int of)
{
    curve *c = &r->curve[r->curves++];
    memset(c, 0, sizeof *c);
    c->label = label;
    c->method = of;
    c->number = c->at = (double)NAN;
    for (int i = 0; i < MOST_POINTS; ++i) c->y[i] = (double)NAN;
    return c;
}

/* Root of the mean square difference (a NULL: 1 everywhere) where b is known and it is scored. What is no number is off
   by 1. */
static double apart(const kit_image *a, const kit_image *b, const float *mask)
{
    double sum = 0;
    size_t count = 0;
    for (int i = 0; i < b->width * b->height; ++i) {
        if (!(mask[i] > 0) || isnan(values_of(b)[i])) continue;
        const double d = (a ? (double)values_of(a)[i] : 1) - (double)values_of(b)[i];
        sum += isnan(d) ? 1 : d * d;
        ++count;
    }
    return sqrt(sum / (double)count);
}

/* What a picture holds at a place of an object, between four pixels; 0 if the frame shows something else there. */
static int held(double *value, const kit_image *picture, const shot *s, const float p[3], uint32_t object)
{
    float to_view[16], projection[16];
    double v[3], at[2], sum = 0;
    const float *z = kit_image_channel(&s->frame, "Z");
    const int width = s->frame.width;
    kit_camera_matrices(&s->gbuffer.camera, to_view, projection);
    for (int r = 0; r < 3; ++r)
        v[r] = (double)(to_view[r] * p[0] + to_view[4 + r] * p[1] + to_view[8 + r] * p[2] + to_view[12 + r]);
    if (!(v[2] < 0)) return 0;
    at[0] = (0.5 - 0.5 * (double)projection[0] * v[0] / v[2]) * width - 0.5;
    at[1] = (0.5 + 0.5 * (double)projection[5] * v[1] / v[2]) * s->frame.height - 0.5;
    const int x = (int)floor(at[0]), y = (int)floor(at[1]);
    if (x < 0 || y < 0 || x + 1 >= width || y + 1 >= s->frame.height) return 0;
    for (int k = 0; k < 4; ++k) {
        const int i = (y + (k >> 1)) * width + x + (k & 1);
        if (s->object[i] != object || !(fabs((double)z[i] + v[2]) < -0.02 * v[2])) return 0;
        sum +=
            (k & 1 ? at[0] - x : 1 - at[0] + x) * (k & 2 ? at[1] - y : 1 - at[1] + y) * (double)values_of(picture)[i];
    }
    *value = sum;
    return 1;
}

/* A place of an object that stands elsewhere in another frame. */
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

/* How much places that the first frame shows vary: their deviation over the frames; or, of what changes anyway, the
   second difference, as the deviation of noise that has it (1 -2 1: root of 6). map: the same of each pixel, 0 where it
   is not known. mean: of what is held. */
static double flicker(float *map, double *mean, const shot *shots, int frames, const kit_image *const *pictures,
                      int second)
{
    const shot *s = &shots[0];
    double sum = 0, all = 0;
    size_t places = 0;
    for (int i = 0; i < s->frame.width * s->frame.height; ++i) {
        const uint32_t o = s->object[i];
        double v[MOST_FRAMES], middle = 0, square = 0;
        float p[3], q[3];
        int known = s->mask[i] > 0;
        map[i] = 0;
        if (known)
            kit_camera_point(&s->gbuffer.camera, i % s->frame.width, i / s->frame.width,
                             (double)kit_image_channel(&s->frame, "Z")[i], p);
        for (int k = 0; k < frames && known; ++k) {
            memcpy(q, p, sizeof q);
            const float *from = s->to_world[(o - 1) % MOST_OBJECTS], *to = shots[k].to_world[(o - 1) % MOST_OBJECTS];
            if (o > 0 && o <= MOST_OBJECTS && memcmp(from, to, sizeof *s->to_world)) carry(q, from, to);
            known = held(&v[k], pictures[k], &shots[k], q, o);
            if (known) middle += v[k] / frames;
        }
        if (!known) continue;
        for (int k = 0; k < frames && !second; ++k) square += (v[k] - middle) * (v[k] - middle) / (frames - 1);
        for (int k = 1; k + 1 < frames && second; ++k)
            square += pow(v[k - 1] - 2 * v[k] + v[k + 1], 2) / (6.0 * (frames - 2));
        map[i] = (float)sqrt(square);
        sum += square;
        all += middle;
        ++places;
    }
    *mean = all / (double)places;
    return sqrt(sum / (double)places);
}

/* Picture, truth and their difference (or what flickers) side by side, of one pixel in stride x stride: as many as the
   truth has. */
static int strip(kit_image *out, const kit_image *a, const kit_image *b, const float *map, const look *l, float gain,
                 kit_error *err)
{
    const int width = l->width / l->stride, height = l->height / l->stride, pixels = width * height;
    kit_image small[3], colour;                /* what is shown: two of these and the difference of two */
    for (int k = 0; k < 3; ++k) {
        if (kit_image_new(&small[k], width, height, "Y", err)) return -1;
        for (int i = 0; i < pixels; ++i) {
            const int from = (i / width * l->stride + l->stride / 2) * l->width + i % width * l->stride + l->stride / 2;
            small[k].data[i] = k < 2 ? values_of(k ? b : a)[from]
                               : map ? map[from] + values_of(b)[from]
                                     : values_of(a)[from];
        }
    }
    if (kit_image_difference(&colour, &small[2], &small[1], "Y", map ? 0.05f : 0.5f, err)
        || kit_image_new(out, 3 * width, height, "R,G,B", err))
        return -1;
    for (int c = 0; c < 3; ++c)
        for (int i = 0; i < pixels; ++i)
            for (int k = 0; k < 3; ++k)
                out->data[(c * height + i / width) * 3 * width + k * width + i % width] =
                    k < 2 ? gain * small[k].data[i] : colour.data[c * pixels + i];
    for (int k = 0; k < 3; ++k) kit_image_free(&small[k]);
    kit_image_free(&colour);
    return 0;
}

/* Scores only places that the frame before did not show. */
static void only_new(shot *s, const shot *last)
{
    for (int i = 0; i < s->frame.width * s->frame.height; ++i) {
        double v;
        float p[3];
        if (!(s->mask[i] > 0)) continue;
        kit_camera_point(&s->gbuffer.camera, i % s->frame.width, i / s->frame.width,
                         (double)kit_image_channel(&s->frame, "Z")[i], p);
        if (held(&v, &last->truth[0], last, p, s->object[i])) s->mask[i] = 0;
    }
}

/* How much of what was before is still seen: where the truth has changed, the picture's mean difference from the frame
   alone, counted toward what was. */
static double remains(const shot *s, const shot *before, int m)
{
    double sum = 0;
    int count = 0;
    for (int i = 0; i < s->frame.width * s->frame.height; ++i) {
        const float now = values_of(&s->truth[0])[i], was = values_of(&before->truth[0])[i];
        if (!(s->mask[i] > 0) || !(fabsf(now - was) > 0.05f)) continue;
        const float d = values_of(&s->picture[m])[i] - values_of(&s->single[m])[i];
        sum += (double)(was > now ? d : -d);
        ++count;
    }
    return count ? sum / count : 0;
}

/* A point of every curve, from the frames of one value; the worst is kept as a picture. */
static int point_of(result *r, int point, const shot *shots, int frames, const look *l, kit_error *err)
{
    const int kind = r->cause->kind, over = kind >= FOLLOWS,
              still = kind == ERROR || kind == PRECISION || over;
    const shot *s = &shots[frames - 1];
    float *map = calloc((size_t)l->width * (size_t)l->height, sizeof *map);
    if (!map) return kit_fail(err, "out of memory");
    for (int i = 0; i < r->curves; ++i) {
        curve *c = &r->curve[i];
        const int m = c->method, between = m >= 0 && methods[m].of == FIELD;
        const kit_image *picture = m < 0 ? NULL : &s->picture[m],
                        *truth = kind == PRECISION && m >= 0 ? &shots[0].picture[m] : &s->truth[between];
        const kit_image *pictures[2][MOST_FRAMES];
        double y, own, mean;
        kit_image worst;
        if (picture && !picture->data) continue;
        for (int k = 0; k < frames && !still; ++k) {
            pictures[0][k] = &shots[k].truth[between];
            pictures[1][k] = picture ? &shots[k].picture[m] : pictures[0][k];
        }
        if (kind == NEWLY) {
            double sum[2] = { 0, 0 };
            for (int k = 1; k < frames; ++k)
                for (int g = 0; g < 2; ++g) {
                    const double e = apart(g ? &shots[k].single[m] : &shots[k].picture[m], &shots[k].truth[0],
                                           shots[k].mask);
                    if (e > 0) sum[g] += e * e;
                }
            y = sqrt(sum[0] / sum[1]);
        } else if (kind == TRAIL) y = remains(s, &shots[CHANGED - 1], m);
        else if (over) {
            y = 0;
            for (int k = kind == AFTER ? frames - 1 : 1; k < frames; ++k)
                y = fmax(y, apart(&shots[k].picture[m], &shots[k].truth[0], shots[k].mask)
                                / fmax(apart(&shots[k].single[m], &shots[k].truth[0], shots[k].mask), 1e-4));
        } else if (still) y = apart(picture, truth, s->mask);
        else {
            own = flicker(map, &mean, shots, frames, pictures[0], kind != DEVIATION) / (kind == LIT_SECOND ? mean : 1);
            y = flicker(map, &mean, shots, frames, pictures[1], kind != DEVIATION) / (kind == LIT_SECOND ? mean : 1);
            if (picture && kind != SECOND) y = sqrt(fmax(0, y * y - own * own));
        }
        c->y[point] = y;
        if (c->number >= y) continue;
        c->number = y;
        c->at = r->x[point];
        if (!picture) continue;
        if (strip(&worst, still ? picture : &shots[0].picture[m], still ? truth : &shots[0].truth[between],
                  still ? NULL : map, l, kind == LIT_SECOND ? 0.4f : 1, err))
            return -1;
        kit_image_free(&c->worst);
        c->worst = worst;
    }
    free(map);
    return 0;
}

/* Where precision holds: the largest value up to which all are within LIMIT. */
static const double LIMIT = 0.02;
static void holds(result *r)
{
    for (curve *c = r->curve; c < r->curve + r->curves; ++c) {
        c->number = 0;
        for (int k = 0; k < r->points && c->y[k] <= LIMIT; ++k) c->number = r->x[k];
    }
}

/* causes, methods: how many are asked for; 0 = all */
typedef struct options { const char *out; int quick, causes, methods, cause[CAUSES], method[METHODS]; } options;

static look look_of(const cause *c, double value, int frame)
{
    look l = { .scene = "plane", .width = c->width, .height = c->width * 9 / 16, .stride = 1, .rays = c->rays };
    c->at(&l, value, frame);
    return l;
}

static int sweep(result *r, const cause *c, const options *o, const char *what, kit_error *err)
{
    static const char *const beside[] = { "no AO", NULL, "truth", "truth", "open", NULL, NULL, NULL, NULL };
    static kit_frames kept_frames[METHODS];
    int frames = c->kind == ERROR ? 1 : c->kind == PRECISION ? 2 : c->kind == FOLLOWS || c->kind == NEWLY ? FRAMES : 4;
    if (c->kind == DEVIATION && c->of == KEPT) frames = FRAMES;
    int truths[2] = { 0, 0 }, values = 1;
    memset(r, 0, sizeof *r);
    r->cause = c;
    if (c->curves) return c->curves(r, err);
    while (values < MOST_VALUES && c->value[values] != 0) ++values;
    if (beside[c->kind]) curve_new(r, beside[c->kind], -2);
    for (int m = 0; m < METHODS; ++m) {
        if (!(methods[m].of & c->of) || (o->methods && !o->method[m])) continue;
        curve_new(r, methods[m].label, m);
        if (c->kind != PRECISION) truths[methods[m].of == FIELD] = truths[0] = 1;
    }
    for (int v = 0; v < values; ++v) {
        static shot shots[MOST_FRAMES];
        look l;
        l = look_of(c, c->value[v], 0);
        if (o->quick && (v % 2 != (values - 1) % 2 || l.width > 1920)) continue;
        r->x[r->points] = c->value[v];
        if (c->kind == AFTER || c->kind == TRAIL) frames = CHANGED + (int)c->value[v];
        for (int k = 0; k < frames; ++k) {
            l = look_of(c, c->value[v], k);
            if (o->quick) l.rays /= 2;
            kit_progress(what, ((double)v * frames + k) / (values * frames));
            if (shot_open(&shots[k], &l, truths, err)) return -1;
            if (c->kind == NEWLY && k) only_new(&shots[k], &shots[k - 1]);
            for (int i = 0; i < r->curves; ++i) {
                const int m = r->curve[i].method;
                if (methods[m < 0 ? 0 : m].of & (KEPT | KEPT_LIGHT)) {
                    if (kept(&shots[k], m, &kept_frames[m], err)) return -1;
                } else if (m >= 0 && l.width <= methods[m].widest
                    && drawn(&shots[k].picture[m], &shots[k], methods[m].method, methods[m].settings, shots[k].radius,
                             err))
                    return -1;
                kit_progress(what, (v * frames + k + (i + 0.99) / r->curves) / (values * frames));
            }
        }
        for (int m = 0; m < METHODS; ++m) kit_frames_close(&kept_frames[m]);
        const int first = c->kind == DEVIATION && c->of == KEPT ? CHANGED : 0;     /* before, there is no history yet */
        if (point_of(r, r->points++, shots + first, frames - first, &l, err)) return -1;
        for (int k = 0; k < frames; ++k) shot_close(&shots[k]);
    }
    kit_progress(what, 1);
    if (c->kind == PRECISION) holds(r);
    return 0;
}

/* ---- >>curves of the library's maths alone ----------------------------------------------------------------------- */

enum { ANGLES = 73, SPHERE_POINTS = 40000 };

/* What a point's irradiance becomes while a sun of harmonics turns around it, over that of an open surface that faces
   it: what it sees is all, or a cone. Lowest values. */
static int ringing(result *r, int shade, kit_error *err)
{
    static const char *const labels[3][3] = { { "2 bands", "2 bands, Hann", "2 bands, positive" },
                                              { "3 bands", "3 bands, Hann", "3 bands, positive" },
                                              { "4 bands", "4 bands, Hann", "4 bands, positive" } };
    const float white[3] = { 1, 1, 1 };
    double transfer[16] = { 0 };
    for (int i = 0; i < SPHERE_POINTS; ++i) {              /* a spiral about the normal, z */
        const double z = 1 - (i + 0.5) * 2 / SPHERE_POINTS, s = sqrt(1 - z * z), a = 2.39996322972865 * i;
        const float d[3] = { (float)(s * cos(a)), (float)(s * sin(a)), (float)z };
        float basis[16];
        ssgi_sh_basis(basis, 4, d);
        for (int k = 0; k < 16 && z > 0 && (!shade || d[0] + d[2] > 1.41421356f * 0.8660254f); ++k)
            transfer[k] += z * (double)basis[k] * 12.566370614359172 / SPHERE_POINTS;
    }
    r->points = ANGLES;
    curve *truth = curve_new(r, "truth", -2);
    for (int k = 0; k < ANGLES; ++k) {
        r->x[k] = 5 * k - 180;
        const double a = r->x[k] * (double)PI_180;
        truth->y[k] = fabs(a) < 1.5707 && (!shade || fabs(r->x[k] - 45) < 30) ? cos(a) : 0;
    }
    for (int i = 0; i < 9; ++i) {
        curve *c = curve_new(r, labels[i / 3][i % 3], -1);
        const int bands = 2 + i / 3;
        c->number = 0;
        for (int k = 0; k < ANGLES; ++k) {
            const float a = (float)r->x[k] * PI_180, d[3] = { sinf(a), 0, cosf(a) };
            float light[48] = { 0 };
            const char *why = "";
            if (ssgi_sh_light(light, bands, d, 0, white, i % 3, &why) != SSGI_OK) return kit_fail(err, "%s", why);
            c->y[k] = 0;
            for (int j = 0; j < bands * bands; ++j) c->y[k] += transfer[j] * (double)light[3 * j];
            if (c->y[k] < -c->number) { c->number = -c->y[k]; c->at = r->x[k]; }
        }
    }
    return 0;
}
static int ringing_open(result *r, kit_error *err)     { return ringing(r, 0, err); }
static int ringing_in_shade(result *r, kit_error *err) { return ringing(r, 1, err); }

/* Along a line between a table's legs, facing up: occlusion by its field and by rays; or what a hundredth of the
   table's size adds to it. Worst error, largest step. */
static int through(result *r, int steps, kit_error *err)
{
    static const struct {
        const char *label;
        float inside, power;
    } kept[] = { { "as measured", -1, 1 }, { "A_0 = 1, p = 2", 1, 2 }, { "A_0 = 0", 0, 1 } };
    enum { RAYS = 1024 };
    const float up[3] = { 0, 1, 0 };
    const char *why = "";
    kit_scene scene;
    const kit_mesh *table = NULL;
    ssgi_trace trace;
    if (kit_scene_load(&scene, "casters", 0, err)) return -1;
    for (int i = 0; i < scene.objects && !table; ++i)
        if (!strcmp(scene.object[i].name, "table")) table = &scene.shape[scene.object[i].shape];
    if (!table) return kit_fail(err, "occluders: has no table");
    const size_t size = ssgi_trace_size(table->triangles);
    void *memory = malloc(size);
    if (!memory
        || ssgi_trace_build(&trace, memory, size, table->position, 3 * sizeof(float), NULL, table->triangles, &why)
               != SSGI_OK)
        return kit_fail(err, "table: %s", memory ? why : "out of memory");
    r->points = 240;
    curve *truth = curve_new(r, "truth", -2);
    for (size_t m = 0; m <= sizeof kept / sizeof *kept; ++m) {
        curve *c = m ? curve_new(r, kept[m - 1].label, -1) : truth;
        const ssgi_field *f = NULL;
        ssgi_field_limits l = { 0, 0, 0, 0 };
        double last = 0;
        if (m) {
            kit_method made;
            if (kit_method_find(&made, "aof", err)) return -1;
            const ssgi_field_desc d = kit_method_field(&made);
            f = kit_field(table, &d, NULL, err);
            if (!f) return -1;
            l = ssgi_field_limits_of(f);
            if (kept[m - 1].inside >= 0) l.inside = kept[m - 1].inside;
            l.power = kept[m - 1].power;
        }
        c->number = 0;
        for (int k = 0; k < r->points; ++k) {
            const float p[3] = { 0.01f * (float)k - 1.195f, -0.1f, 0.1f };
            double v = f ? (double)ssgi_field_occlusion(f, &l, p, up) : 0;
            for (int i = 0; i < RAYS && !f; ++i) {
                float u[2];
                ssgi_r2((uint32_t)i, u);
                const float s = sqrtf(u[0]),
                            d[3] = { s * cosf(6.2831853f * u[1]), sqrtf(1 - u[0]), s * sinf(6.2831853f * u[1]) };
                v += ssgi_trace_any(&trace, p, d, 0, HUGE_VALF) / (double)RAYS;
            }
            r->x[k] = (double)p[0];
            c->y[k] = !steps ? v : k ? v - last : (double)NAN;
            const double bad = fabs(steps ? c->y[k] : v - truth->y[k]);
            if (bad > c->number) { c->number = bad; c->at = r->x[k]; }
            last = v;
        }
    }
    free(memory);
    kit_scene_free(&scene);
    return 0;
}
static int hull(result *r, kit_error *err)       { return through(r, 0, err); }
static int hull_steps(result *r, kit_error *err) { return through(r, 1, err); }

/* How the count of surfels changes a step of 1 % of the distance. Largest change. */
static int popping(result *r, kit_error *err)
{
    static const struct { const char *label; ssgi_surfel_desc d;
    } kept[] = { { "0.03", { .size = 0.03f } },
                 { "0.015", { .size = 0.015f } },
                 { "0.03, every triangle", { .size = 0.03f, .keep_small = 1 } } };
    look l = { .scene = "casters", .width = 320, .height = 180, .stride = 1 };
    const char *why = "";
    kit_scene scene;
    if (kit_scene_load(&scene, l.scene, 0, err)) return -1;
    const kit_mesh *mesh = &scene.mesh;
    float *divided = NULL;
    r->points = 140;
    for (size_t m = 0; m < sizeof kept / sizeof *kept; ++m) {
        curve *c = curve_new(r, kept[m].label, -1);
        size_t last = 0, count = 0, triangles = 0;
        c->number = 0;
        for (int k = -1; k < r->points; ++k, last = count) {
            kit_camera camera_ = scene.camera;
            ssgi_view view;
            ssgi_surfel_source source = { .position = mesh->position,
                                          .normal = mesh->normal,
                                          .triangles = mesh->triangles };
            ssgi_surfel_desc d = kept[m].d;
            float projection[16];
            d.max_distance = scene.radius;
            l.nearer = 1 - (float)pow(1.01, k);
            aim(&camera_, &l);
            kit_camera_planes(&camera_, mesh);
            kit_camera_matrices(&camera_, source.to_view, projection);
            int failed =
                ssgi_view_from_projection(&view, projection, SSGI_CLIP_ZERO, l.width, l.height, &why) != SSGI_OK
                || ssgi_surfels_divide(NULL, 0, &triangles, &d, &view, &source, &why) != SSGI_OK;
            divided = failed ? NULL : realloc(divided, (27 * triangles + 1) * sizeof *divided);
            failed = failed || !divided
                     || ssgi_surfels_divide(divided, triangles, &triangles, &d, &view, &source, &why) != SSGI_OK;
            source.position = divided;
            source.normal = divided + 3;
            source.position_stride = source.normal_stride = 9 * sizeof(float);
            source.triangles = triangles;
            if (failed || ssgi_surfels(NULL, 0, &count, &d, &view, &source, &why) != SSGI_OK)
                return kit_fail(err, "surfels: %s", *why ? why : "out of memory");
            if (k < 0) continue;
            r->x[k] = pow(1.01, k);
            c->y[k] = (double)count / (double)last - 1;
            if (fabs(c->y[k]) > c->number) { c->number = fabs(c->y[k]); c->at = r->x[k]; }
        }
    }
    free(divided);
    kit_scene_free(&scene);
    return 0;
}

/* ---- >>show ------------------------------------------------------------------------------------------------------ */

/* What the number of a cause is, what its chart shows, and what stands beside a picture. */
static const struct { const char *number, *up, *shown;
} kinds[] = { { "largest RMSE to the truth", "RMSE to the truth", "method, truth, difference (full colour: 0.5)" },
              { "greatest depth up to which RMSE stays within 0.02", "RMSE to the picture with exact depth",
                "with this depth, with exact depth, difference (full colour: 0.5)" },
              { "largest deviation over frames, less the truth's", "deviation over frames",
                "method, truth, deviation over frames (full colour: 0.05)" },
              { "largest second difference over frames", "second difference over frames, as deviation",
                "method, truth, second difference (full colour: 0.05)" },
              { "largest second difference, less an open surface's, over the mean",
                "second difference over frames, over the mean",
                "method, open surface (both times 0.4), second difference (full colour: 0.05)" },
              { "largest error over that of the frame alone", "error over that of the frame alone",
                "method, truth, difference (full colour: 0.5)" },
              { "largest error over that of the frame alone", "error over that of the frame alone",
                "method, truth, difference (full colour: 0.5)" },
              { "largest error of what is newly seen over that of the frame alone",
                "error of what is newly seen over that of the frame alone",
                "method, truth, difference (full colour: 0.5)" },
              { "most of what was that is left", "what was before and is still seen, of ambient visibility",
                "method, truth, difference (full colour: 0.5)" } };

static const char *settings(const curve *c) { return c->method < 0 ? "" : methods[c->method].settings; }

static void line_svg(FILE *f, const result *r)
{
    const cause *c = r->cause;
    scale s = { HUGE_VAL, -HUGE_VAL, 0, 0, !c->log };
    double last = -100, legend = LEFT, line = 58;
    for (int k = 0; k < r->points; ++k) {
        s.x0 = fmin(s.x0, r->x[k]);
        s.x1 = fmax(s.x1, r->x[k]);
        for (int i = 0; i < r->curves; ++i)
            if (!isnan(r->curve[i].y[k])) {
                s.y0 = fmin(s.y0, r->curve[i].y[k]);
                s.y1 = fmax(s.y1, r->curve[i].y[k]);
            }
    }
    const double lowest = s.x0, highest = s.x1, every = step_of(0.001, s.x1 - s.x0),
                 step = step_of(1e-5, fmax(s.y1 - s.y0, 1e-4));
    const double room = 0.03 * (c->log ? log(s.x1 / s.x0) : s.x1 - s.x0);
    s.x0 = (c->log ? log(s.x0) : s.x0) - room;
    s.x1 = (c->log ? log(s.x1) : s.x1) + room;
    s.y0 = step * floor(s.y0 / step);
    s.y1 = step * ceil(s.y1 / step + 0.05);
    fprintf(f,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" role=\"img\" "
            "font-family=\"system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif\" font-size=\"13\" "
            "fill=\"#444\">\n<title>%s</title>\n"
            "<rect width=\"%d\" height=\"%d\" rx=\"6\" fill=\"#fff\"/>\n<text x=\"%d\" y=\"32\" font-size=\"17\" "
            "font-weight=\"600\" fill=\"#111\">%s</text>\n",
            WIDE, HIGH, WIDE, HIGH, c->title, WIDE, HIGH, LEFT, c->title);
    for (double v = s.y0; v < s.y1 + step / 2; v += step)
        fprintf(f, "<path d=\"M%d %.1fH%d\" stroke=\"%s\"/><text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%g</text>\n",
                LEFT, up(&s, v), RIGHT, fabs(v) < step / 2 ? "#888" : "#e4e4e4", LEFT - 9, up(&s, v) + 4.5,
                fabs(v) < step / 2 ? 0 : v);
    for (int k = -30; k < 60; ++k) {           /* decades' 1, 2 and 5, or multiples of a step */
        static const double ticks[3] = { 1, 2, 5 };
        const double v = c->log ? ticks[(k + 30) % 3] * pow(10, (k + 30) / 3 - 10) : every * (ceil(lowest / every) + k);
        if (v < lowest - 1e-3 * fabs(lowest) || v > highest + 1e-3 * fabs(highest)) continue;
        fprintf(f, "<path d=\"M%.1f %dV%d\" stroke=\"#eeeeee\"/>", across(&s, v), TOP, BOTTOM);
        if (across(&s, v) - last < 44) continue;
        last = across(&s, v);
        fprintf(f, "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g</text>\n", last, BOTTOM + 20,
                fabs(v) < 1e-9 ? 0 : v);
    }
    fprintf(f,
            "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s</text>\n<text transform=\"translate(20 %d) "
            "rotate(-90)\" text-anchor=\"middle\">%s</text>\n",
            (LEFT + RIGHT) / 2, BOTTOM + 46, c->across, (TOP + BOTTOM) / 2, c->up ? c->up : kinds[c->kind].up);
    for (int i = 0; i < r->curves; ++i) {
        const curve *v = &r->curve[i];
        const int colour = v->method >= 0 ? v->method : i, apart_ = r->points <= 16 ? 1 : 10;
        char move = 'M';
        const double wide = 38 + 7.0 * (double)strlen(v->label);
        if (legend > LEFT && legend + wide > RIGHT) { legend = LEFT; line += 18; }
        const double x = legend;
        legend += wide;
        const char *style = v->method < -1 ? "#333\" stroke-dasharray=\"6 4" : colour_of(colour);
        fprintf(f,
                "<text x=\"%.1f\" y=\"%.1f\" fill=\"#222\">%s</text>\n<path stroke-width=\"2\" stroke=\"%s\" d=\"M%.1f "
                "%.1fh16\"/>\n"
                "<path fill=\"none\" stroke-width=\"2\" stroke-linejoin=\"round\" stroke=\"%s\" d=\"",
                x + 22, line + 4.5, v->label, style, x, line, style);
        for (int k = 0; k < r->points; ++k) {
            if (isnan(v->y[k])) { move = 'M'; continue; }
            fprintf(f, "%c%.1f %.1f", move, across(&s, r->x[k]), up(&s, v->y[k]));
            move = 'L';
        }
        fputs("\"/>\n", f);
        for (int k = -1; k < r->points && v->method > -2; k += k < 0 ? 1 : apart_) {
            if (k >= 0 && isnan(v->y[k])) continue;
            fputs("<path ", f);
            marker(f, colour, k < 0 ? x + 8 : across(&s, r->x[k]), k < 0 ? line : up(&s, v->y[k]));
            if (k < 0) fputs("/>\n", f);
            else fprintf(f, "><title>%s at %g: %.4f</title></path>\n", v->label, r->x[k], v->y[k]);
        }
    }
    fputs("</svg>\n", f);
}


static int page_of(FILE *html, FILE *csv, const result *r, const char *out, kit_error *err)
{
    const cause *c = r->cause;
    char name[128];
    page p;
    if (page_open(&p, err)) return -1;
    line_svg(p.file, r);
    fflush(p.file);
    fprintf(html, "<h2 id=\"%s\">%s</h2>\n<p>%s Beside each method: %s.</p>\n", c->name, c->title, c->about,
            c->number ? c->number : kinds[c->kind].number);
    fwrite(p.text, 1, p.size, html);
    snprintf(name, sizeof name, "stability-%s.svg", c->name);
    if (page_close(&p, out, name, err)) return -1;
    fputs("<div class=\"wide\"><table>\n<tr>", html);
    for (int i = 0; i < r->curves; ++i) fprintf(html, "<th>%s", r->curve[i].label);
    fputs("\n<tr>", html);
    for (int i = 0; i < r->curves; ++i)
        fprintf(html, isnan(r->curve[i].number) ? "<td>&ndash;" : "<td>%.4g", r->curve[i].number);
    fputs("\n</table></div>\n<details><summary>The worst frames</summary>\n<div class=\"grid\">\n", html);
    for (int i = 0; i < r->curves; ++i) {
        const curve *v = &r->curve[i];
        for (int k = 0; k < r->points; ++k)
            if (!isnan(v->y[k]))
                fprintf(csv, "%s,\"%s\",\"%s\",\"%s\",%.6g,%.6g,%.6g\n", c->name, c->across, v->label, settings(v),
                        r->x[k], v->y[k], v->number);
        if (!v->worst.data) continue;
        char path[4096];
        snprintf(name, sizeof name, "stability-%s-%s.png", c->name, v->label);
        snprintf(path, sizeof path, "%s/%s", out, name);
        if (kit_png_write(&v->worst, "R,G,B", 0, path, err)) return -1;
        fprintf(html,
                "<figure><figcaption><b>%s</b><span>at %g: %s</span></figcaption><a href=\"%s\"><img src=\"%s\" "
                "width=\"%d\" height=\"%d\" alt=\"%s\"></a></figure>\n",
                v->label, v->at, kinds[c->kind].shown, name, name, v->worst.width, v->worst.height, v->label);
    }
    fputs("</div></details>\n", html);
    return 0;
}

/* Causes down, methods across; causes of other things below. html: NULL = plain text on standard output. */
static void table_of(FILE *html, const result *results, const int *shown)
{
    char text[32];
    FILE *f = html ? html : stdout;
    fputs(html ? "<h2>One number a method and cause</h2>\n<div class=\"wide\"><table>\n<tr><th>cause"
               : "cause          ",
          f);
    for (int m = 0; m < METHODS; ++m) fprintf(f, html ? "<th>%s" : " %10s", methods[m].label);
    fputs(html ? "<th>beside<th>what\n" : "     beside\n", f);
    for (int k = 0; k < CAUSES; ++k) {
        const result *r = &results[k];
        if (!shown[k] || causes[k].curves) continue;
        fprintf(f, html ? "<tr><td><a href=\"#%s\">%s</a>" : "%s%-15s", html ? causes[k].name : "",
                html ? causes[k].title : causes[k].name);
        for (int m = 0; m <= METHODS; ++m) {
            snprintf(text, sizeof text, html ? "&ndash;" : "-");
            for (int i = 0; i < r->curves; ++i)
                if (r->curve[i].method == (m < METHODS ? m : -2) && !isnan(r->curve[i].number))
                    snprintf(text, sizeof text, causes[k].kind == PRECISION ? "%.0f" : "%.4f", r->curve[i].number);
            fprintf(f, html ? "<td>%s" : " %10s", text);
        }
        if (html) fprintf(f, "<td>%s", kinds[causes[k].kind].number);
        fputs("\n", f);
    }
    fputs(html ? "</table></div>\n<div class=\"wide\"><table>\n" : "", f);
    for (int k = 0; k < CAUSES; ++k) {
        if (!shown[k] || !causes[k].curves) continue;
        fprintf(f, html ? "<tr><td><a href=\"#%s\">%s</a><td>%s" : "%s%s, %s:", html ? causes[k].name : "",
                html ? causes[k].title : causes[k].name, causes[k].number);
        for (int i = 0; i < results[k].curves; ++i)
            if (!isnan(results[k].curve[i].number))
                fprintf(f, html ? "<td>%s: %.4f" : " %s %.4f;", results[k].curve[i].label, results[k].curve[i].number);
        fputs("\n", f);
    }
    if (html) fputs("</table></div>\n", f);
}

static int stability(const options *o, kit_error *err)
{
    static result results[CAUSES];
    int shown[CAUSES], count = 0, done = 0;
    char what[128];
    page html, csv;
    if (mkdir(o->out, 0777) && errno != EEXIST) return kit_fail(err, "%s: cannot be made: %s", o->out, strerror(errno));
    for (int k = 0; k < CAUSES; ++k) count += shown[k] = !o->causes || o->cause[k];
    for (int k = 0; k < CAUSES; ++k) {
        if (!shown[k]) continue;
        snprintf(what, sizeof what, "%d of %d: %s", ++done, count, causes[k].name);
        if (sweep(&results[k], &causes[k], o, what, err)) return -1;
    }
    if (page_open(&html, err) || page_open(&csv, err)) return -1;
    html_head(html.file, "ssgi: where methods fail",
              "Each method is swept through what such methods fail at. Errors are of ambient visibility (0 closed, 1 "
              "open), against ray-traced truth; "
              "no gain, no fit. Methods with light are under white light from everywhere, where irradiance is ambient "
              "visibility.");
    fputs("cause,unit,method,settings,value,figure,number\n", csv.file);
    table_of(html.file, results, shown);
    for (int k = 0; k < CAUSES; ++k) if (shown[k] && page_of(html.file, csv.file, &results[k], o->out, err)) return -1;
    if (page_close(&html, o->out, "stability.html", err) || page_close(&csv, o->out, "stability.csv", err)
        || run_note(o->out, "stability.txt", o->causes || o->methods ? "part" : o->quick ? "quick" : "full",
            o->quick ? "make stability QUICK=1" : "make stability", err)) return -1;
    table_of(NULL, results, shown);
    printf("charts and pictures: %s/stability.html\n", o->out);
    return 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int parse(options *o, int argc, char **argv, kit_error *err)
{
    memset(o, 0, sizeof *o);
    o->out = "report";
    for (int i = 1; i < argc; ++i) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        int k = 0;
        if (!strcmp(a, "--quick")) { o->quick = 1; continue; }
        if (strcmp(a, "--out") && strcmp(a, "--cause") && strcmp(a, "--method"))
            return kit_fail(err, "%s: there is no such argument (--out FOLDER, --quick, --cause NAME, --method NAME)",
                            a);
        if (!v || !*v) return kit_fail(err, "%s: needs a value", a);
        ++i;
        if (!strcmp(a, "--out")) { o->out = v; continue; }
        if (!strcmp(a, "--cause")) {
            while (k < CAUSES && strcmp(causes[k].name, v)) ++k;
            if (k == CAUSES)
                return kit_fail(err, "--cause %s: there is none of that name (stability.html lists them)", v);
            o->causes += !o->cause[k];
            o->cause[k] = 1;
        } else {
            while (k < METHODS && strcmp(methods[k].label, v)) ++k;
            if (k == METHODS) return kit_fail(err, "--method %s: is not swept", v);
            o->methods += !o->method[k];
            o->method[k] = 1;
        }
    }
    return 0;
}

int main(int argc, char **argv)
{
    options o;
    kit_error err = { "" };
    kit_streams_open();
    if (!parse(&o, argc, argv, &err) && !kit_gl_open(NULL, &err) && !stability(&o, &err)) kit_streams_close(&err);
    if (*err.text) {
        kit_progress("", 1);
        fprintf(stderr, "stability: %s\n", err.text);
        return 2;
    }
    kit_fields_free();
    kit_gl_close();
    return 0;
}
