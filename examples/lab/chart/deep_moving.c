/* deep_moving.c - a camera that turns away from an occluder, and a camera that moves. Declared in deep_stage.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/chart/deep_stage.h"

/* A camera turns, in TURNS steps, until the occluding box has left the picture. The ground beside it stays in. */
enum { TURNS = 9, FRAMES = 5 };
static const float turn_eye[3] = { 0.35f, 0.9f, 2.8f }, turn_from = -8, turn_to = 21,
                   ground_bounds[2][3] = { { 0.16f, -0.1f, -0.15f }, { 0.5f, 0.1f, 0.2f } };
#define TURN_BOX { { -0.6f, 0.001f, -0.15f, 0, 1, 0.15f } }

static const lit deep_white = { "white", { NULL }, 0, 0, 0, 64, 1, NO_CROPS };

static const entry deep_watched[] = {
    { "hsao", "hsao", "", 1 },
    { "ssdo", "ssdo", "bounce=none", 1 },
    { "dss", "dss", COARSE, 1 }
};
static const entry deep_moved[] = {
    { "hsao", "hsao", "", 1 },
    { "ssao", "ssao", "", 1 },
    { "dss", "dss", COARSE, 1 },
    { "dss, every triangle", "dss", COARSE ",keep_small=1", 1 }
};

_Static_assert(TURNS * COUNT(deep_watched) <= MOST_SET_ROWS, "more rows than MOST_SET_ROWS");

/* ---- >>turn ------------------------------------------------------------------------------------------------------ */

/* Returns the camera's angle at step k. Steps are small while the box leaves the picture. */
static float turn_angle(int k, int steps)
{
    const float to_go = 1 - (float)k / (float)(steps - 1);
    return turn_to + (turn_from - turn_to) * to_go * to_go;
}

static int turn_open(stage *s, float angle, kit_error *err)
{
    const float a = angle * 0.0174532925f;
    deep_view see = { { "turn", "plane", 0, { 0 }, { 0 }, 30, 0.6f, &deep_white }, TURN_BOX, PLAINLY };
    memcpy(see.view.eye, turn_eye, sizeof turn_eye);
    see.view.target[0] = turn_eye[0] + 2.8f * sinf(a);
    see.view.target[2] = turn_eye[2] - 2.8f * cosf(a);
    return deep_open(s, &see, err);
}

/* Returns a mask of the ground beside the box, the same ground at each step of the camera; NULL: no memory. */
static float *turn_mask(const stage *s)
{
    const int width = s->frame.width, pixels = width * s->frame.height;
    const float *z = kit_image_channel(&s->frame, "Z");
    float *mask = calloc((size_t)pixels, sizeof *mask);
    for (int i = 0; i < pixels && mask; ++i) {
        float p[3];
        if (!(z[i] > 0)) continue;
        kit_camera_point(&s->gbuffer.camera, i % width, i / width, (double)z[i], p);
        mask[i] = 1;
        for (int c = 0; c < 3; ++c) if (p[c] < ground_bounds[0][c] || p[c] > ground_bounds[1][c]) mask[i] = 0;
    }
    return mask;
}

int deep_turns(FILE *record, const options *o, row *rows, kit_error *err)
{
    static const char *const names[3] = { "irradiance.R", "irradiance.G", "irradiance.B" };
    const int steps = o->quick ? 5 : TURNS;
    for (int k = 0; k < steps; ++k) {
        const float angle = turn_angle(k, steps);
        kit_score none;
        stage s;
        if (turn_open(&s, angle, err)) return -1;
        float *mask = turn_mask(&s);
        if (!mask) return kit_fail(err, "out of memory");
        if (kit_score_channels(&none, &s.given[0].picture, &s.truth, names, 3, mask, err)) return -1;
        for (int m = 0; m < COUNT(deep_watched); ++m) {
            const entry *e = &deep_watched[m];
            kit_image picture;
            row *r = &rows[m * steps + k];
            *r = row_blank(OF_TURN, "turn", e->label, e->method, e->settings);
            if (stage_drawn(&picture, &s, e->method, e->settings, s.radius, err)
                || kit_score_channels(&r->score, &picture, &s.truth, names, 3, mask, err))
                return -1;
            r->figure[DEGREES] = r->relative = (double)(angle - turn_from);
            r->share = r->score.rmse / none.rmse;
            kit_image_free(&picture);
        }
        if (k + 1 == steps && section_about(record, &s, "", 0, 0, err)) return -1;
        free(mask);
        stage_close(&s);
    }
    return COUNT(deep_watched) * steps;
}

/* ---- >>motion ---------------------------------------------------------------------------------------------------- */

/* The pictures of all frames of the moving camera, first those of the truth, then those of each method. */
enum { MOVED = COUNT(deep_moved) };
static kit_camera camera[FRAMES];
static kit_image frame[FRAMES], moved[1 + MOVED][FRAMES];

/* Opens frame k of the moving camera. Eye and target are a step to the right of those of the frame before. */
static int motion_frame(int k, kit_error *err)
{
    const float step = 0.01f;
    deep_view see = BUNNY_AO;
    stage s;
    see.view.eye[0] += step * (float)k;
    see.view.target[0] += step * (float)k;
    if (deep_open(&s, &see, err)) return -1;
    for (int i = 0; i < MOVED; ++i)
        if (stage_drawn(&moved[1 + i][k], &s, deep_moved[i].method, deep_moved[i].settings, s.radius, err)) return -1;
    camera[k] = s.gbuffer.camera;
    moved[0][k] = s.truth;
    frame[k] = s.frame;
    memset(&s.truth, 0, sizeof s.truth);
    memset(&s.frame, 0, sizeof s.frame);
    stage_close(&s);
    return 0;
}

/* Takes the point of the scene that pixel i of the first frame shows, and adds the variance of its values over the
   frames. Returns 0 and adds nothing if some frame does not show that point. */
static int motion_place(double sum[1 + MOVED], int i)
{
    const int width = frame->width;
    const float z = kit_image_channel(frame, "Z")[i];
    double square[1 + MOVED] = { 0 }, mean[1 + MOVED] = { 0 };
    float p[3];
    if (!(z > 0)) return 0;
    kit_camera_point(camera, i % width, i / width, (double)z, p);
    for (int k = 0; k < FRAMES; ++k) {
        const picture_view seen = { &frame[k], &camera[k], NULL };
        for (int j = 0; j <= MOVED; ++j) {
            double v = 0;
            if (!picture_at(&v, moved[j][k].data, &seen, p, 0)) return 0;
            mean[j] += v / FRAMES;
            square[j] += v * v;
        }
    }
    for (int j = 0; j <= MOVED; ++j) sum[j] += fmax(0, square[j] - FRAMES * mean[j] * mean[j]) / (FRAMES - 1);
    return 1;
}

int deep_motion(FILE *record, const options *o, row *rows, kit_error *err)
{
    double sum[1 + MOVED] = { 0 };
    size_t places = 0;
    (void)record;
    (void)o;
    for (int k = 0; k < FRAMES; ++k) if (motion_frame(k, err)) return -1;
    for (int i = 0; i < frame->width * frame->height; ++i) places += (size_t)motion_place(sum, i);
    for (int i = 0; i < MOVED; ++i) {
        const entry *e = &deep_moved[i];
        rows[i] = row_blank(OF_MOTION, "bunny-on-floor", e->label, e->method, e->settings);
        rows[i].score.pixels = places;
        rows[i].figure[FLICKER] = sqrt(sum[1 + i] / (double)places);
        rows[i].figure[FLICKER_TRUE] = sqrt(sum[0] / (double)places);
        rows[i].figure[FLICKER_ADDED] = sqrt(fmax(0, sum[1 + i] - sum[0]) / (double)places);
    }
    for (int k = 0; k < FRAMES; ++k) {
        kit_image_free(&frame[k]);
        for (int i = 0; i <= MOVED; ++i) kit_image_free(&moved[i][k]);
    }
    return MOVED;
}
