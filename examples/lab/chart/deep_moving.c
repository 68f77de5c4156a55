/* deep_moving.c - what report.c's chart shows of a camera that turns away from what occludes, and of one that moves.
   Declared in deep_stage.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/chart/deep_stage.h"
#include "lab/page/page.h"

/* The eye turns from what occludes, the box, which leaves the picture; the ground beside it stays. */
enum { TURNS = 9, MOST_FRAMES = 5 };
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
    { "ssao", "ssao", "", 0 },
    { "dss", "dss", COARSE, 1 },
    { "dss, every triangle", "dss", COARSE ",keep_small=1", 0 }
};

_Static_assert(TURNS * COUNT(deep_watched) <= MOST_DEEP, "more rows than MOST_DEEP");

/* ---- >>turn ------------------------------------------------------------------------------------------------------ */

/* How far the camera is turned at step k: small steps where the box leaves. */
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

/* The ground beside the box alone, the same at each step; NULL: no memory. */
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

int deep_turns(FILE *record, int quick, row *rows, kit_error *err)
{
    static const char *const names[3] = { "irradiance.R", "irradiance.G", "irradiance.B" };
    const int steps = quick ? 5 : TURNS;
    int methods = 0;
    for (int k = 0; k < steps; ++k) {
        const float angle = turn_angle(k, steps);
        kit_score none;
        stage s;
        if (turn_open(&s, angle, err)) return -1;
        float *mask = turn_mask(&s);
        if (!mask) return kit_fail(err, "out of memory");
        if (kit_score_channels(&none, &s.given[0].picture, &s.truth, names, 3, mask, err)) return -1;
        methods = 0;
        for (int m = 0; m < COUNT(deep_watched); ++m) {
            const entry *e = &deep_watched[m];
            kit_image picture;
            if (quick && !e->quick) continue;
            row *r = &rows[methods++ * steps + k];
            *r = row_blank(OF_TURN, "turn", e->label, e->method, e->settings);
            if (stage_drawn(&picture, &s, e->method, e->settings, s.radius, err)
                || kit_score_channels(&r->score, &picture, &s.truth, names, 3, mask, err))
                return -1;
            r->figure[DEGREES] = r->relative = (double)(angle - turn_from);
            r->share = r->score.rmse / none.rmse;
            kit_image_free(&picture);
        }
        if (k + 1 == steps)
            deep_about(record, &s,
                       "A tall box on a plane leaves the picture while the camera turns to the right; the ground "
                       "beside it stays, and is what is scored. White light from everywhere.");
        free(mask);
        stage_close(&s);
    }
    return methods * steps;
}

/* ---- >>motion ---------------------------------------------------------------------------------------------------- */

/* What is seen in each frame: the truth's pictures first, then a method's, one after the other. */
enum { MOVED = COUNT(deep_moved) };
typedef struct motion {
    int          frames, methods;
    const entry *entry[MOVED];
    kit_camera   camera[MOST_FRAMES];
    kit_image    frame[MOST_FRAMES], picture[1 + MOVED][MOST_FRAMES];
    double       sum[1 + MOVED];           /* of the places' variances over the frames */
    size_t       places;
} motion;

/* Frame k, step to the right of the one before. */
static int motion_frame(FILE *record, motion *m, int k, kit_error *err)
{
    const float step = 0.01f;
    deep_view see = BUNNY_AO;
    stage s;
    see.view.eye[0] += step * (float)k;
    see.view.target[0] += step * (float)k;
    if (deep_open(&s, &see, err)) return -1;
    for (int i = 0; i < m->methods; ++i)
        if (stage_drawn(&m->picture[1 + i][k], &s, m->entry[i]->method, m->entry[i]->settings, s.radius, err))
            return -1;
    m->camera[k] = s.gbuffer.camera;
    m->picture[0][k] = s.truth;
    m->frame[k] = s.frame;
    memset(&s.truth, 0, sizeof s.truth);
    memset(&s.frame, 0, sizeof s.frame);
    if (!k)
        page_paragraph(record,
                "Bunny on a floor, %d x %d pixels, radius %g. %d frames; camera and target move to the right by "
                "%g each, about a pixel.",
                m->frame[0].width, m->frame[0].height, (double)s.radius, m->frames, (double)step);
    stage_close(&s);
    return 0;
}

/* The place that a pixel of frame 0 shows, in all frames; of one that some frame does not show nothing counts. */
static void motion_place(motion *m, int i)
{
    const int width = m->frame[0].width;
    const float z = kit_image_channel(&m->frame[0], "Z")[i];
    double square[1 + MOVED] = { 0 }, mean[1 + MOVED] = { 0 };
    float p[3];
    int known = z > 0;
    kit_camera_point(&m->camera[0], i % width, i / width, (double)z, p);
    for (int k = 0; k < m->frames && known; ++k) {
        const picture_view seen = { &m->frame[k], &m->camera[k], NULL };
        for (int j = 0; j <= m->methods && known; ++j) {
            double v = 0;
            known = picture_at(&v, m->picture[j][k].data, &seen, p, 0);
            mean[j] += v / m->frames;
            square[j] += v * v;
        }
    }
    if (!known) return;
    for (int j = 0; j <= m->methods; ++j)
        m->sum[j] += fmax(0, square[j] - m->frames * mean[j] * mean[j]) / (m->frames - 1);
    ++m->places;
}

int deep_motion(FILE *record, int quick, row *rows, kit_error *err)
{
    static motion m;
    memset(&m, 0, sizeof m);
    m.frames = quick ? 3 : MOST_FRAMES;
    for (int i = 0; i < MOVED; ++i) if (deep_moved[i].quick || !quick) m.entry[m.methods++] = &deep_moved[i];
    for (int k = 0; k < m.frames; ++k) if (motion_frame(record, &m, k, err)) return -1;
    for (int i = 0; i < m.frame[0].width * m.frame[0].height; ++i) motion_place(&m, i);
    for (int i = 0; i < m.methods; ++i) {
        row *r = &rows[i];
        *r = row_blank(OF_MOTION, "bunny-on-floor", m.entry[i]->label, m.entry[i]->method, m.entry[i]->settings);
        r->score.pixels = m.places;
        r->figure[FLICKER] = sqrt(m.sum[1 + i] / (double)m.places);
        r->figure[FLICKER_TRUE] = sqrt(m.sum[0] / (double)m.places);
        r->figure[FLICKER_ADDED] = sqrt(fmax(0, m.sum[1 + i] - m.sum[0]) / (double)m.places);
    }
    for (int k = 0; k < m.frames; ++k) {
        kit_image_free(&m.frame[k]);
        for (int i = 0; i <= m.methods; ++i) kit_image_free(&m.picture[i][k]);
    }
    return m.methods;
}
