/* strip.c - the demo of history: one frame alone and the last of sixteen, beside the truth. Declared in chart.h. */
#include "lab/chart/chart.h"
#include <math.h>
#include "lab/page/page.h"
#include "lab/page/pictures.h"

/* The method of the demo of history. Its camera turns for SETTLED frames and ends at the demo's own view. */
static const char strip_method[] = "hsao-fast", strip_settings[] = "history=1";
static const double STRIP_DEGREES = 0.2;    /* for each frame */
enum { STRIP_DRAWN = 4 };                   /* how often each is drawn, with other noise each time */

/* The frame drawn alone, [0], and the last of SETTLED frames, [1]; each is drawn STRIP_DRAWN times. */
typedef struct strip { kit_image picture[2][STRIP_DRAWN]; double rmse[2], share[2], noise[2]; } strip;

static int strip_draw(strip *t, stage *s, kit_error *err)
{
    static kit_frames frames;
    kit_gbuffer seen[SETTLED];
    kit_method m;
    const kit_world world = { &s->scene, NULL };
    if (kit_method_find(&m, strip_method, err) || kit_method_set(&m, strip_settings, err)) return -1;
    for (int k = 0; k < SETTLED; ++k) {
        kit_camera camera = s->gbuffer.camera;
        kit_camera_orbit(&camera, &s->gbuffer.camera, STRIP_DEGREES * (k + 1 - SETTLED));
        if (kit_gbuffer_from_scene(&seen[k], &s->scene, &camera, NULL, err)) return -1;
    }
    for (int i = 0; i < STRIP_DRAWN; ++i) {
        frames.number = (unsigned)(SETTLED * i);
        for (int k = 0; k < SETTLED; ++k) {
            kit_image *alone = k + 1 == SETTLED ? &t->picture[0][i] : NULL;
            kit_progress("a strip of frames", (i * SETTLED + k + 1.0) / (STRIP_DRAWN * SETTLED));
            if (kit_frames_next(&frames, &seen[k], &m, s->radius, &world, alone, err)) return -1;
            kit_run_draw(frames.now, 0);
        }
        if (kit_run_read(&t->picture[1][i], frames.now, err)) return -1;
        kit_frames_close(&frames);
    }
    for (int k = 0; k < SETTLED; ++k) kit_gbuffer_free(&seen[k]);
    return 0;
}

/* Returns the noise of a frame: the mean over the pixels of the root of a pixel's variance over the drawings. */
static double strip_noise(const kit_image picture[STRIP_DRAWN], const kit_image *frame)
{
    const float *z = kit_image_channel(frame, "Z");
    double noise = 0;
    size_t pixels = 0;
    for (int p = 0; p < frame->width * frame->height; ++p) {
        double sum = 0, squares = 0;
        if (!(z[p] > 0)) continue;
        for (int i = 0; i < STRIP_DRAWN; ++i) {
            const double v = (double)picture[i].data[p];
            sum += v;
            squares += v * v;
        }
        noise += fmax(0, squares - sum * sum / STRIP_DRAWN) / (STRIP_DRAWN - 1);
        ++pixels;
    }
    return sqrt(noise / (double)pixels);
}

/* Fills in the error of the two frames, as a mean over the drawings, and their noise. */
static int strip_score(strip *t, const stage *s, kit_error *err)
{
    for (int g = 0; g < 2; ++g) {
        t->rmse[g] = t->share[g] = 0;
        for (int i = 0; i < STRIP_DRAWN; ++i) {
            row r;
            if (score_picture(&r, s, &t->picture[g][i], err)) return -1;
            t->rmse[g] += r.score.rmse / STRIP_DRAWN;
            t->share[g] += r.share / STRIP_DRAWN;
        }
        t->noise[g] = strip_noise(t->picture[g], &s->frame);
    }
    return 0;
}

/* Writes the middle of a picture, enlarged twice. */
static int enlarged(kit_image *out, const kit_image *picture, kit_error *err)
{
    const int left = picture->width / 4, top = picture->height / 2;
    if (kit_image_new(out, picture->width, picture->height, "Y", err)) return -1;
    for (int i = 0; i < out->width * out->height; ++i)
        out->data[i] = kit_image_channel(picture, "Y")[(top + i / out->width / 2) * picture->width
                                                       + left + i % out->width / 2];
    return 0;
}

int strip_demo(FILE *record, const options *o, kit_error *err)
{
    static const char *const slugs[3] = { "strip-one", "strip-frames", "strip-truth" },
                      *const labels[3] = { "one frame", "sixteen frames", "ray-traced truth" };
    const set *demo = ao_demo.sets;
    strip t;
    stage s;
    if (ao_demo.open(&s, &ao_demo, demo, err) || strip_draw(&t, &s, err) || strip_score(&t, &s, err)) return -1;
    page_heading(record, 2, "Over frames");
    page_paragraph(record, "%s, --set %s, while the camera turns by %g degrees a frame: the last frame "
            "alone, as the last of sixteen, and its truth; the middle of the picture, enlarged. Noise: root of a "
            "pixel's variance over %d drawings, its mean over the pixels.",
            strip_method, strip_settings, STRIP_DEGREES, STRIP_DRAWN);
    printf("\n%s %s, the camera turning %g degrees a frame\n", strip_method, strip_settings, STRIP_DEGREES);
    for (int k = 0; k < 3; ++k) {
        kit_image large;
        char note[96] = "";
        if (enlarged(&large, k < 2 ? &t.picture[k][0] : &s.truth, err)
            || pictures_save(&large, "Y", 0, o->out, slugs[k], ".png", err))
            return -1;
        if (k < 2) {
            snprintf(note, sizeof note, "RMSE %.4f, error %.3f, noise %.4f", t.rmse[k], t.share[k], t.noise[k]);
            printf("%-15s %s\n", labels[k], note);
        }
        page_figure(record, slugs[k], labels[k], note, large.width, large.height, 0);
        kit_image_free(&large);
    }
    for (int i = 0; i < 2 * STRIP_DRAWN; ++i) kit_image_free(&t.picture[i % 2][i / 2]);
    stage_close(&s);
    return 0;
}
