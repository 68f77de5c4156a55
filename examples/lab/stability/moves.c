/* moves.c - how steady methods are while a camera moves past what stands still. Declared in moves.h. */
#include "lab/stability/moves.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "kit/kit_trace.h"
#include "lab/measure/folder.h"
#include "lab/stability/shot.h"

/* The error is that of frame EIGHTH, from 0; deviations are of the frames behind it, by when a history is settled. */
enum { MOVED = 16, EIGHTH = 7, COUNTED = EIGHTH + 1 };

static const char *const own_scenes[] = { "room", "random:halls:7", "random:rooms:12", "random:streets:5", NULL };
static const char *const own_methods[] = { "hsao-fast", "hsao-fast:history=1", "hsao", "hsao:history=1", "hsao-history",
                                           "hsao-best", "hsao-best:history=1", NULL };

/* Kinds of moves, which scenes take in turn: pixels to the right, and share of the way to the target, a frame. */
static const struct {
    float aside, nearer;
} kinds[] = { { 1, 0 }, { 0.7f, 0.002f }, { -0.6f, 0.003f }, { 1.3f, 0 } };

enum { KINDS = sizeof kinds / sizeof *kinds };

/* ---- >>truth ----------------------------------------------------------------------------------------------------- */

/* The same rays at every pixel, so that the truth of a place hardly depends on the pixel that it is seen by. */
static void alike(const kit_truth *job, uint32_t pixel, const kit_place *at, float *value)
{
    (void)pixel;
    *value = kit_ambient_at(&job->ambient, 1, at->origin, at->n);
}

static int truth_of(kit_image *out, const shot *s, int rays, kit_error *err)
{
    const kit_mesh *mesh = &s->scene.mesh;
    const kit_camera *c = &s->gbuffer.camera;
    kit_truth job = { .pixel = alike, .background = 1 };
    char path[256];
    uint64_t h = kit_hash(KIT_HASH, mesh->position, 9 * mesh->triangles * sizeof(float));
    h = kit_hash(h, mesh->normal, 9 * mesh->triangles * sizeof(float));
    h = kit_hash(h, c, sizeof *c);
    h = kit_hash(h, &s->radius, sizeof s->radius);
    snprintf(path, sizeof path, FOLDER_CACHE "/moves-%dx%d-%d-%016llx.exr", c->width, c->height, rays,
             (unsigned long long)h);
    if (!kit_exr_read(out, path, NULL)) return 0;
    return kit_truth_run(&job, out, "Y", &s->scene, c, s->radius, KIT_ATTENUATION_LINEAR, rays, 1, err)
                || folder_make(FOLDER_CACHE, err) || kit_exr_write(out, path, err)
             ? -1
             : 0;
}

/* ---- >>figures --------------------------------------------------------------------------------------------------- */

/* Mean deviation, over the frames that are counted, of places that all of them show. */
static double deviation(const shot *shots, const kit_image *pictures)
{
    double sum = 0;
    size_t places = 0;
    for (int i = 0; i < shots[COUNTED].frame.width * shots[COUNTED].frame.height; ++i) {
        double v[MOVED], mean = 0, square = 0;
        float p[3];
        int shown = shots[COUNTED].mask[i] > 0;
        if (!shown) continue;
        shot_place(&shots[COUNTED], i, p);
        for (int k = COUNTED; k < MOVED && shown; ++k)
            shown = shot_value_at(&v[k], &shots[k], &pictures[k], p, shots[COUNTED].object[i]);
        if (!shown) continue;
        for (int k = COUNTED; k < MOVED; ++k) mean += v[k] / (MOVED - COUNTED);
        for (int k = COUNTED; k < MOVED; ++k) square += (v[k] - mean) * (v[k] - mean) / (MOVED - COUNTED - 1);
        sum += sqrt(square);
        ++places;
    }
    return sum / (double)(places ? places : 1);
}

static double error_of(const shot *s, const kit_image *picture, const kit_image *truth)
{
    const float *a = shot_values(picture), *b = shot_values(truth);
    double sum = 0;
    int count = 0;
    for (int i = 0; i < truth->width * truth->height; ++i) {
        if (!(s->mask[i] > 0)) continue;
        sum += (double)((a[i] - b[i]) * (a[i] - b[i]));
        ++count;
    }
    return sqrt(sum / (count ? count : 1));
}

/* ---- >>moves ----------------------------------------------------------------------------------------------------- */

static int method_of(kit_method *m, const char *text, kit_error *err)
{
    char name[64];
    const char *colon = strchr(text, ':');
    snprintf(name, sizeof name, "%.*s", (int)(colon ? colon - text : (long)strlen(text)), text);
    return kit_method_find(m, name, err) || kit_method_set(m, colon ? colon + 1 : "", err) ? -1 : 0;
}

static int draw_all(kit_image *pictures, shot *shots, const char *text, kit_error *err)
{
    static kit_frames frames;
    kit_method m;
    if (method_of(&m, text, err)) return -1;
    for (int k = 0; k < MOVED; ++k) {
        const kit_world world = { &shots[k].scene, &shots[k].lighting };
        if (kit_frames_next(&frames, &shots[k].gbuffer, &m, shots[k].radius, &world, NULL, err)) return -1;
        kit_run_draw(frames.now, 0);
        if (kit_run_read(&pictures[k], frames.now, err)) return -1;
    }
    kit_frames_close(&frames);
    return 0;
}

/* A scene's row of every method: figure[0] deviation, [1] error. */
static int moved(double (*figure)[2], const char *scene, int kind, const char *const *methods, const moves_options *o,
                 kit_error *err)
{
    static shot shots[MOVED];
    kit_image truth[MOVED] = { { 0 } }, picture[MOVED];
    const int none[2] = { 0, 0 };
    for (int k = 0; k < MOVED; ++k) {
        const look l = { .scene = scene,
                         .width = o->width,
                         .height = o->width * 9 / 16,
                         .stride = 1,
                         .aside = kinds[kind].aside * (float)k,
                         .nearer = 1 - powf(1 - kinds[kind].nearer, (float)k) };
        kit_progress(scene, (double)k / MOVED);
        if (shot_open(&shots[k], &l, none, err) || (k >= EIGHTH && truth_of(&truth[k], &shots[k], o->rays, err)))
            return -1;
    }
    const double own = deviation(shots, truth);
    for (int i = 0; methods[i]; ++i) {
        if (draw_all(picture, shots, methods[i], err)) return -1;
        figure[i][0] = deviation(shots, picture) - own;
        figure[i][1] = error_of(&shots[EIGHTH], &picture[EIGHTH], &truth[EIGHTH]);
        for (int k = 0; k < MOVED; ++k) kit_image_free(&picture[k]);
    }
    for (int k = 0; k < MOVED; ++k) {
        shot_close(&shots[k]);
        kit_image_free(&truth[k]);
    }
    kit_progress("", 1);
    return 0;
}

int moves(const moves_options *o, kit_error *err)
{
    const char *const *scenes = o->scene[0] ? o->scene : own_scenes;
    const char *const *methods = o->method[0] ? o->method : own_methods;
    static double figure[MOST_MOVES][MOST_MOVES][2];
    int count = 0;
    for (; scenes[count]; ++count)
        if (moved(figure[count], scenes[count], count % KINDS, methods, o, err)) return -1;
    printf("deviation over the truth's, error of the eighth frame\n%-44s", "");
    for (int k = 0; k < count; ++k) printf(" %-17s", scenes[k]);
    puts(" mean");
    for (int i = 0; methods[i]; ++i) {
        double mean[2] = { 0, 0 };
        printf("%-44s", methods[i]);
        for (int k = 0; k < count; ++k) {
            printf(" %8.5f %7.5f ", figure[k][i][0], figure[k][i][1]);
            for (int c = 0; c < 2; ++c) mean[c] += figure[k][i][c] / count;
        }
        printf(" %8.5f %7.5f\n", mean[0], mean[1]);
    }
    return 0;
}
