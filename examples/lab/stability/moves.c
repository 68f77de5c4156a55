/* moves.c - how steady methods are while a camera moves past a scene that stands still. Declared in moves.h. */
#include "lab/stability/moves.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "kit/kit_trace.h"
#include "lab/measure/csv.h"
#include "lab/measure/folder.h"
#include "lab/measure/stage.h"
#include "lab/stability/shot.h"

/* Deviations are taken over the first SPAN frames, in which history fills, and over the SPAN frames after these. */
enum { SPAN = 8, MOVED = 2 * SPAN };

static const char *const own_methods[] = { "hsao-fast", "hsao-fast:history=1", "hsao", "hsao:history=1", "hsao-history",
                                           "hsao-best", NULL };

/* Kinds of moves. Scenes take the first IN_TURN of them in turn, or the others, which a host does to
   frames. A frame's step: pixels to the right, a share of the way to the target, degrees of roll and of orbit. */
enum { EVEN, CUTS, STOPS, JITTERS, RESIZES, UNEVEN };
static const struct kind {
    const char *name;
    float aside, nearer, roll, orbit;
    int how;
} kinds[] = { { "aside", 1, 0, 0, 0, EVEN },       { "forward", 0, 0.005f, 0, 0, EVEN },
              { "roll", 0, 0, 0.3f, 0, EVEN },     { "orbit", 0, 0, 0, 0.25f, EVEN },
              { "cut", 0.7f, 0, 0, 0, CUTS },      { "stop and go", 1, 0, 0, 0, STOPS },
              { "fast", 4, 0, 0, 0, EVEN },        { "slow", 0.3f, 0.001f, 0, 0, EVEN },
              { "still", 0, 0, 0, 0, EVEN },       { "jittered", 0, 0, 0, 0, JITTERS },
              { "resized", 0.7f, 0, 0, 0, RESIZES }, { "uneven", 1, 0, 0, 0, UNEVEN } };
enum { KINDS = sizeof kinds / sizeof *kinds, IN_TURN = 8, OF_SEEDS = 8, OF_MODELS = 8 };

/* Frame by frame: how many steps the camera takes with UNEVEN; the picture's width in eighths with RESIZES. */
static const float step_of[SPAN] = { 1, 1, 0.5f, 3, 0.25f, 1, 2, 0.5f };
static const int eighths[SPAN] = { 8, 8, 7, 6, 6, 7, 8, 5 };

/* ---- >>path ------------------------------------------------------------------------------------------------------ */

/* Returns the i-th number of Halton's sequence for a base. */
static float halton(int i, int base)
{
    float v = 0, share = 1;
    for (; i; i /= base) v += (share /= (float)base) * (float)(i % base);
    return v;
}

static double steps_until(const struct kind *kind, int frame)
{
    double steps = 0;
    for (int k = 1; k <= frame; ++k)
        steps += kind->how == STOPS ? k / 4 % 2 == 0 : kind->how == UNEVEN ? (double)step_of[k % SPAN] : 1;
    return steps;
}

static look look_of(const char *scene, const struct kind *kind, int frame, int width)
{
    const float steps = (float)steps_until(kind, frame);
    const int cut = kind->how == CUTS && frame >= SPAN, eighth = kind->how == RESIZES ? eighths[frame % SPAN] : 8;
    look l = { .scene = scene,
               .width = width * eighth / 8,
               .height = width * 9 / 16 * eighth / 8,
               .stride = 1,
               .aside = kind->aside * steps * (float)eighth / 8 + (cut ? 40.0f : 0),
               .nearer = 1 - powf(1 - kind->nearer, steps) + (cut ? 0.15f : 0),
               .roll = kind->roll * steps,
               .orbit = kind->orbit * steps };
    for (int i = 0; i < 2 && kind->how == JITTERS; ++i) l.shift[i] = halton(1 + frame % 8, 2 + i) - 0.5f;
    return l;
}
/* ---- >>truth ----------------------------------------------------------------------------------------------------- */

/* Traces the same rays at every pixel, so that the truth of a place hardly depends on the pixel that shows it. */
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

/* Returns the mean over pixels of the deviation over SPAN frames, at the points that all of the frames show. */
static double deviation(const shot *shots, const kit_image *pictures)
{
    const kit_image *each[SPAN];
    double sum = 0, square, mean;
    size_t places = 0;
    for (int k = 0; k < SPAN; ++k) each[k] = &pictures[k];
    for (int i = 0; i < shots->frame.width * shots->frame.height; ++i) {
        if (!shot_varies(&square, &mean, shots, SPAN, each, i, 0)) continue;
        sum += sqrt(square);
        ++places;
    }
    return sum / (double)(places ? places : 1);
}

/* Returns the error of pictures after a host's TAA, with a camera that stands: their exponential average by a tenth,
   against the truth's mean over the last SPAN frames. */
static double error_by_taa(const shot *s, const kit_image *pictures, const kit_image *truths)
{
    double sum = 0;
    int count = 0;
    for (int i = 0; i < s->frame.width * s->frame.height; ++i) {
        double seen = 0, truth = 0;
        int shown = 1;
        for (int k = 0; k < MOVED && shown; ++k) {
            shown = s[k].mask[i] > 0;
            seen += ((double)shot_values(&pictures[k])[i] - seen) * fmax(1.0 / (k + 1), 0.1);
            if (k >= SPAN) truth += (double)shot_values(&truths[k])[i] / SPAN;
        }
        if (!shown) continue;
        sum += (seen - truth) * (seen - truth);
        ++count;
    }
    return sqrt(sum / (count ? count : 1));
}

/* ---- >>moves ----------------------------------------------------------------------------------------------------- */

/* A row's figures: the deviation while history fills, and after; the error of the last frame, with history and drawn
   alone; the error after TAA. */
enum { FILLING, FILLED, LAST, ALONE, BY_TAA, MOVE_FIGURES };

/* Takes a word off the method's text. "turned METHOD" has another noise in each frame, though it keeps no history.
   "place METHOD" is not told that only jitter changed the projection. */
static int told(const char **text, const char *word)
{
    const size_t length = strlen(word);
    if (strncmp(*text, word, length)) return 0;
    *text += length;
    return 1;
}

/* Draws all frames of a method. pictures: of these frames, then of the last frame drawn alone. */
static int draw_all(kit_image *pictures, shot *shots, const char *text, const struct kind *kind, kit_error *err)
{
    static kit_frames frames;
    request a;
    kit_method m;
    const int turned = told(&text, "turned "), place = told(&text, "place ");
    if (request_read(&a, &m, text, err)) return -1;
    for (int k = 0; k < MOVED; ++k) {
        const kit_world world = { &shots[k].scene, &shots[k].lighting };
        kit_image *alone = k == MOVED - 1 ? &pictures[MOVED] : NULL;
        frames.elapsed = kind->how == UNEVEN ? step_of[k % SPAN] : 0;
        frames.jittered = kind->how == JITTERS && !place;
        if (kit_frames_next(&frames, &shots[k].gbuffer, &m, shots[k].radius, &world, alone, err)) return -1;
        if (turned) {
            frames.now->frame.phase = ssgi_gl_phase((uint32_t)k);
            kit_run_update(frames.now);
        }
        kit_run_draw(frames.now, 0);
        if (kit_run_read(&pictures[k], frames.now, err)) return -1;
    }
    kit_frames_close(&frames);
    return 0;
}

static int stands(const struct kind *kind)
{
    return !(fabsf(kind->aside) + fabsf(kind->nearer) + fabsf(kind->roll) + fabsf(kind->orbit) > 0);
}

/* Returns 1 for pairs that mean nothing: turned noise is for TAA by a standing camera, "place" only for jitter. */
static int skipped(const char *method, const struct kind *kind)
{
    return (told(&method, "turned ") && !stands(kind)) || (told(&method, "place ") && kind->how != JITTERS);
}

/* Measures the figures of every method in a scene, under one kind of move. */
static int moved(double (*figure)[MOVE_FIGURES], const char *scene, const struct kind *kind, const char *const *methods,
                 const moves_options *o, kit_error *err)
{
    static shot shots[MOVED];
    kit_image truth[MOVED] = { { 0 } }, picture[MOVED + 1] = { { 0 } };
    const int none[2] = { 0, 0 };
    double own[2];
    for (int k = 0; k < MOVED; ++k) {
        const look l = look_of(scene, kind, k, o->width);
        kit_progress(scene, (double)k / MOVED);
        if (shot_open(&shots[k], &l, none, err) || truth_of(&truth[k], &shots[k], o->rays, err)) return -1;
    }
    for (int h = 0; h < 2; ++h) own[h] = deviation(shots + h * SPAN, truth + h * SPAN);
    for (int i = 0; methods[i]; ++i) {
        const shot *last = &shots[MOVED - 1];
        if (skipped(methods[i], kind)) continue;
        if (draw_all(picture, shots, methods[i], kind, err)) return -1;
        for (int h = 0; h < 2; ++h) figure[i][h] = deviation(shots + h * SPAN, picture + h * SPAN) - own[h];
        for (int k = 0; k < 2; ++k)
            figure[i][LAST + k] = shot_apart(&picture[MOVED - 1 + k], &truth[MOVED - 1], last->mask);
        figure[i][BY_TAA] = stands(kind) ? error_by_taa(shots, picture, truth) : (double)NAN;
        for (int k = 0; k <= MOVED; ++k) kit_image_free(&picture[k]);
    }
    for (int k = 0; k < MOVED; ++k) {
        shot_close(&shots[k]);
        kit_image_free(&truth[k]);
    }
    kit_progress("", 1);
    return 0;
}

/* The methods that draw frames as hosts make them, on OF_HOSTS scenes. */
static const char *const host_methods[] = { "hsao-fast", "turned hsao-fast", "hsao-fast:history=1", "turned hsao",
                                            "hsao-history", "place hsao-history", "hsao-best", NULL };
enum { OF_HOSTS = 8 };

void moves_of_hosts(moves_options *o)
{
    o->of_hosts = 1;
    memcpy(o->method, host_methods, sizeof host_methods);
    o->count = OF_HOSTS;
}

static const struct kind *kind_of(const moves_options *o, int k)
{
    return &kinds[o->of_hosts ? IN_TURN + k % (KINDS - IN_TURN) : k % IN_TURN];
}

/* Makes the path of the k-th scene. Returns 0 if there is none. */
static int scene_of(char path[128], const moves_options *o, int k)
{
    if (o->scene[0]) {
        if (o->scene[k]) snprintf(path, 128, "%s", o->scene[k]);
        return o->scene[k] != NULL;
    }
    if (o->count && k >= o->count) return 0;
    if (k >= OF_SEEDS) return k < OF_SEEDS + (o->quick ? 0 : OF_MODELS) && stage_model(path, o->from + k - OF_SEEDS);
    snprintf(path, 128, "random:%d", o->from + k);
    return 1;
}

int moves(const moves_options *o, FILE *out, kit_error *err)
{
    const char *const *methods = o->method[0] ? o->method : own_methods;
    static double figure[MOST_MOVES][MOVE_FIGURES];
    char scene[128];
    fputs("move,scene,method,filling,filled,error,over alone,by TAA\n", out);
    for (int k = 0; scene_of(scene, o, k); ++k) {
        const struct kind *kind = kind_of(o, k);
        if (moved(figure, scene, kind, methods, o, err)) return -1;
        for (int i = 0; methods[i]; ++i) {
            const double *f = figure[i];
            if (skipped(methods[i], kind)) continue;
            fprintf(out, "%s,%s,\"%s\",%.6f,%.6f,%.5f,%.4f", kind->name, scene, methods[i], f[FILLING], f[FILLED],
                    f[LAST], f[LAST] / f[ALONE]);
            csv_figure(out, ",%.5f", f[BY_TAA]);
            fputc('\n', out);
        }
        fflush(out);
    }
    return 0;
}
