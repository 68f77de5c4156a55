/* look.c - places the camera of a scene by seed and sets the radius, by trial images. Declared in kit_seed.h. */
#include "kit/kit_seed.h"
#include "ssgi.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Kinds of views: at eye height; along the ground; from above; from within clutter, some of it cut by the near plane;
   from far away; orthographic. */
enum { EYE, LOW, ABOVE, INSIDE, FAR_OFF, FLAT };

static const int ways[] = { EYE, LOW, ABOVE, INSIDE, EYE, FAR_OFF, ABOVE, INSIDE, LOW, EYE, FLAT, EYE };

enum {
    WAYS = sizeof ways / sizeof *ways,
    ACROSS = 32, /* rays in a row of a trial image */
    DOWN = 18,
    RAYS = ACROSS * DOWN,
    PROBED = 8, /* one hit in so many has its surroundings probed */
    AROUND = 6, /* with so many rays */
    TRIALS = 160
};

/* Radii as shares of the image's height: spread evenly in their logarithm, by the golden ratio. */
static const double LEAST_SHARE = 0.02, MOST_SHARE = 0.3, GOLDEN = 0.6180339887498949;

/* What a trial image shows. seen: share of the rays that hit; backs: share of the hits from behind; near, middle: the
   4th percentile and median of view depth; occlusion: its mean within the radius; occluded: share of the places that
   have some; objects: number of objects hit; largest: share of the hits that are on one object. */
typedef struct shown {
    double seen, backs, nearest, middle, occlusion, occluded, largest;
    int objects;
    float radius;
} shown;

typedef struct viewer {
    const kit_scene *scene;
    const ssgi_trace *trace;
    double share;
    kit_build *b;
} viewer;

/* the picture's axes */
static void axes(const kit_camera *c, double right[3], double up[3], double ahead[3])
{
    const double world_up[3] = { (double)c->up[0], (double)c->up[1], (double)c->up[2] };
    for (int i = 0; i < 3; i++) ahead[i] = (double)c->target[i] - (double)c->eye[i];
    kit_unit(ahead);
    kit_cross(ahead, world_up, right);
    kit_unit(right);
    kit_cross(right, ahead, up);
}

static void ray_of(const kit_camera *c, double x, double y, float origin[3], float direction[3])
{
    const int flat = !(c->fovy > 0);
    const double aspect = (double)c->width / c->height;
    const double half = flat ? 0.5 * (double)c->ortho_height : tan((double)c->fovy * KIT_PI / 360);
    double right[3], up[3], ahead[3];
    axes(c, right, up, ahead);
    for (int i = 0; i < 3; i++) {
        const double off = half * (aspect * x * right[i] + y * up[i]);
        origin[i] = (float)((double)c->eye[i] + (flat ? off : 0));
        direction[i] = (float)(ahead[i] + (flat ? 0 : off));
    }
}

/* Writes the face's normal, turned toward the ray's origin; returns 1 if the ray hits it from behind. */
static int facing(double n[3], const kit_mesh *m, uint32_t triangle, const float direction[3])
{
    const double way[3] = { (double)direction[0], (double)direction[1], (double)direction[2] };
    kit_face(m->position + 9 * (size_t)triangle, n);
    const int behind = kit_dot(n, way) > 0;
    for (int i = 0; i < 3 && behind; i++) n[i] = -n[i];
    return behind;
}

/* Returns the occlusion of a point by some cosine-weighted rays, with linear attenuation. */
static double occluded(const viewer *v, const float at[3], const double n[3], float radius)
{
    double sum = 0;
    float from[3];
    ssgi_hit hit;
    for (int i = 0; i < 3; i++) from[i] = at[i] + 1e-3f * radius * (float)n[i];
    for (int k = 0; k < AROUND; k++) {
        const double y = kit_between(v->b, -1, 1), a = kit_between(v->b, 0, 2 * KIT_PI), r = sqrt(1 - y * y);
        double d[3] = { n[0] + r * cos(a), n[1] + y, n[2] + r * sin(a) };
        kit_unit(d);
        const float way[3] = { (float)d[0], (float)d[1], (float)d[2] };
        if (ssgi_trace_closest(&hit, v->trace, from, way, 0, radius)) sum += 1 - (double)(hit.t / radius);
    }
    return sum / AROUND;
}

static int by_number(const void *a, const void *b)
{
    const uint32_t x = *(const uint32_t *)a, y = *(const uint32_t *)b;
    return (x > y) - (x < y);
}

/* Counts the objects that are hit, and finds the largest share of the hits on one; sorts the hits' objects. */
static void count_objects(shown *s, uint32_t *object, int hits)
{
    qsort(object, (size_t)hits, sizeof *object, by_number);
    for (int k = 0, same = 0; k < hits; k++) {
        same = k && object[k] == object[k - 1] ? same + 1 : 1;
        s->objects += same == 1;
        s->largest = fmax(s->largest, (double)same / hits);
    }
}

static shown look_through(const viewer *v, const kit_camera *c)
{
    shown s = { 0 };
    float depth[RAYS], place[RAYS][3];
    uint32_t object[RAYS];
    double normal[RAYS][3];
    int hits = 0, backs = 0, probed = 0;
    for (int k = 0; k < RAYS; k++) {
        float origin[3], direction[3];
        ssgi_hit hit;
        ray_of(c, (2 * (k % ACROSS) + 1.0) / ACROSS - 1, 1 - (2 * (k / ACROSS) + 1.0) / DOWN, origin, direction);
        if (!ssgi_trace_closest(&hit, v->trace, origin, direction, c->znear, 1e6f)) continue;
        backs += facing(normal[hits], &v->scene->mesh, hit.triangle, direction);
        for (int i = 0; i < 3; i++) place[hits][i] = origin[i] + hit.t * direction[i];
        object[hits] = v->scene->mesh.object[hit.triangle];
        depth[hits++] = hit.t;
    }
    s.seen = (double)hits / RAYS;
    if (!hits) return s;
    s.backs = (double)backs / hits;
    s.middle = (double)kit_middle(depth, (size_t)hits);        /* sorts them */
    s.nearest = (double)depth[hits / 25];
    const double height = c->fovy > 0 ? 2 * tan((double)c->fovy * KIT_PI / 360) * s.middle : (double)c->ortho_height;
    s.radius = (float)(v->share * height);
    for (int k = 0; k < hits; k += PROBED, probed++) {
        const double o = occluded(v, place[k], normal[k], s.radius);
        s.occlusion += o;
        s.occluded += o > 0.01;
    }
    s.occlusion /= probed;
    s.occluded /= probed;
    count_objects(&s, object, hits);
    return s;
}

/* ---- >>trials -------------------------------------------------------------------------------------------------- */

static double clamped(double v, double low, double high) { return fmax(low, fmin(high, v)); }

/* Places a camera that looks at a thing from a direction and a distance, but inside the area for the eye. */
static void stand_at(kit_camera *c, const kit_plot *p, const double at[3], double turn, double away, double height)
{
    const double x = clamped(at[0] + away * cos(turn), p->stand[0], p->stand[2]),
                 z = clamped(at[2] + away * sin(turn), p->stand[1], p->stand[3]);
    double y = kit_ground_at(p, x, z) + height;
    if (p->ceiling > 0) y = fmin(y, p->ceiling - 0.15);
    const double eye[3] = { x, y, z };
    for (int i = 0; i < 3; i++) {
        c->eye[i] = (float)eye[i];
        c->target[i] = (float)at[i];
    }
}

static kit_camera try_way(kit_plot *p, int way, kit_camera c)
{
    kit_build *b = &p->b;
    const kit_sight *s = &p->sight[(int)(kit_chance(b) * p->sights)];
    const double reach = s->reach, turn = kit_between(b, 0, 2 * KIT_PI), ground = kit_ground_at(p, s->at[0], s->at[2]);
    double at[3];
    for (int i = 0; i < 3; i++) at[i] = s->at[i] + kit_between(b, -0.4, 0.4) * reach;
    c.fovy = (float)kit_between(b, 40, 68);
    c.znear = 0.02f;
    /* Compilers evaluate arguments in different orders, so random numbers are drawn before the call. */
    if (way == EYE) {
        const double away = reach * kit_between(b, 1.2, 3) + 0.8, height = kit_between(b, 1.35, 1.75);
        stand_at(&c, p, at, turn, away, height);
    }
    if (way == LOW) {
        at[1] = ground + kit_between(b, 0.1, 0.6) * fmin(reach, 1);
        const double away = reach * kit_between(b, 1.1, 3) + 0.3, height = kit_between(b, 0.06, 0.35);
        stand_at(&c, p, at, turn, away, height);
    }
    if (way == ABOVE) {
        const double steep = kit_between(b, 0.6, 1.3), away = reach * kit_between(b, 1.8, 4) + 0.5;
        stand_at(&c, p, at, turn, away * cos(steep), at[1] - ground + away * sin(steep));
    }
    if (way == INSIDE) {
        const double away = reach * kit_between(b, 0.3, 0.9), height = reach * kit_between(b, -0.4, 0.8);
        stand_at(&c, p, at, turn, away, fmax(0.05, s->at[1] - ground + height));
        c.fovy = (float)kit_between(b, 50, 78);
    }
    if (way == FAR_OFF || way == FLAT) {
        const double steep = kit_between(b, 0.03, 0.8), away = reach * kit_between(b, 5, 12);
        stand_at(&c, p, at, turn, away * cos(steep), at[1] - ground + away * sin(steep));
        double d[3];
        for (int i = 0; i < 3; i++) d[i] = (double)c.eye[i] - (double)c.target[i];
        const double distance = sqrt(kit_dot(d, d)), tall = reach * kit_between(b, 1.5, 2.6);
        c.fovy = (float)clamped(360 / KIT_PI * atan(0.5 * tall / distance), 8, 60);
        if (way == FLAT) {
            c.fovy = 0;
            c.ortho_height = (float)tall;
        }
    }
    return c;
}

/* Returns the quality of a trial image; from 1 on it is good enough. */
static double worth(const shown *s, int way, int indoors, double share)
{
    const double wanted = 0.2 * pow(share, 0.6), nearest = way == INSIDE ? 0.03 : 0.25;
    double w = fmin(1, s->occlusion / wanted);
    w *= fmin(1, s->occluded / pow(share, 0.5));
    w *= fmin(1, s->objects / (way == INSIDE ? 4.0 : 6.0));
    w *= s->largest > 0.75 ? 0.7 : 1;
    w *= fmin(1, s->seen / (indoors ? 0.97 : 0.6));
    w *= s->backs > 0.35 ? 0.3 : 1;
    w *= s->nearest < nearest ? 0.4 : 1;
    w *= s->nearest > 0.7 * s->middle && way != FLAT && way != FAR_OFF && way != ABOVE ? 0.7 : 1;
    return w;
}

int kit_look(kit_scene *s, kit_plot *p, unsigned seed)
{
    const size_t size = ssgi_trace_size(s->mesh.triangles);
    const int way = ways[seed / KIT_KINDS % WAYS];
    const double turn = GOLDEN * (seed + 0.5), part = turn - floor(turn);
    void *memory = malloc(size + 1);
    ssgi_trace trace;
    kit_camera best = s->camera;
    double most = -1;
    if (!memory || !p->sights
        || ssgi_trace_build(&trace, memory, size, s->mesh.position, 3 * sizeof(float), NULL, s->mesh.triangles, NULL)
               != SSGI_OK) {
        free(memory);
        return -1;
    }
    const viewer v = { s, &trace, LEAST_SHARE * pow(MOST_SHARE / LEAST_SHARE, part), &p->b };
    for (int k = 0; k < TRIALS && most < 1; k++) {
        kit_camera c = try_way(p, way, s->camera);
        shown now = look_through(&v, &c);
        const double w = worth(&now, way, p->ceiling > 0, v.share);
        if (w <= most) continue;
        most = w;
        /* half of the cameras within clutter cut the nearest surfaces by the near plane */
        c.znear = (float)fmax(0.005, way == INSIDE && seed & 1 ? 1.1 * now.nearest : 0.35 * now.nearest);
        best = c;
        s->radius = now.radius;
    }
    s->camera = best;
    free(memory);
    return 0;
}
