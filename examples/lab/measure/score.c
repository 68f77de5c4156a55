/* score.c - scores a picture against a stage's truth: as a whole, and over the phases of its noise. Declared in
   score.h. */
#include "lab/measure/score.h"
#include <math.h>
#include <stdlib.h>

/* ---- >>picture --------------------------------------------------------------------------------------------------- */

int score_picture(row *r, const stage *s, const kit_image *picture, kit_error *err)
{
    static const char *const names[4][3] = { { "R", "G", "B" },
                                             { "irradiance.R", "irradiance.G", "irradiance.B" },
                                             { "bounce.R", "bounce.G", "bounce.B" },
                                             { "Y", NULL, NULL } };
    const float *z = kit_image_channel(&s->frame, "Z");
    size_t pixels = (size_t)picture->width * (size_t)picture->height;
    float *mask = malloc(pixels * sizeof *mask);
    kit_score here, unit;
    int failed = mask ? 0 : kit_fail(err, "out of memory");
    for (size_t i = 0; i < pixels && mask; ++i) mask[i] = isnan(picture->data[i]) ? 0 : z[i];
    r->of = s->lit ? OF_LIT : s->between ? OF_FIELD : OF_AO;
    for (int k = 0; k < SPLITS; ++k) r->split[k] = (double)NAN;
    for (int k = 0; k < 3; ++k) r->error[k] = r->bias[k] = (double)NAN;
    for (int g = s->lit ? 0 : 3; g < (s->lit ? 3 : 4) && !failed; ++g) {
        failed = kit_score_channels(&here, picture, &s->truth, names[g], s->lit ? 3 : 1, mask, err)
                 || kit_score_channels(&unit, &s->unit, &s->truth, names[g], s->lit ? 3 : 1, mask, err);
        const double share = s->lit ? -unit.bias : unit.rmse, known = share > 0 ? 1 / share : (double)NAN;
        if (s->stride > 1) here.ssim = (double)NAN;      /* SSIM needs neighbours */
        if (g % 3 == 0) r->score = here;
        if (g % 3 == 0) r->share = here.rmse * known;
        if (s->lit) r->error[g] = here.rmse * known;
        if (s->lit) r->bias[g] = here.bias * known;
    }
    free(mask);
    return failed ? -1 : 0;
}

int score_named(row *r, const stage *s, const char *label, const kit_image *picture, kit_error *err)
{
    *r = row_blank(OF_LIT, s->name, label, "none", "");
    return score_picture(r, s, picture, err);
}

/* ---- >>noise of the truth ---------------------------------------------------------------------------------------- */

enum { NOISE_RAYS = 4 };

/* Scores the truth against one of NOISE_RAYS times its rays, at some of its pixels. Those rays begin with the truth's
   own, so the difference is smaller than the error: by sqrt(1 - 1 / NOISE_RAYS), if rays are independent. */
int score_noise(row *r, const stage *s, const char *label, kit_error *err)
{
    kit_image probe;
    const int stride = (s->stride == SEED_STRIDE ? 3 : 5) * s->stride;      /* odd: blocks keep their middles */
    if (stage_trace(&probe, s, NOISE_RAYS * s->rays, stride, err) || score_named(r, s, label, &probe, err))
        return -1;
    kit_image_free(&probe);
    for (int i = 0; i < 3; ++i) {
        r->error[i] /= sqrt(1 - 1.0 / NOISE_RAYS);
        r->bias[i] = 0;
    }
    return 0;
}

/* ---- >>phases of the noise --------------------------------------------------------------------------------------- */

/* Sums over the pictures of several phases of noise, for each value of a picture: of the value, and of its square. */
typedef struct sums {
    const char *const *names;              /* names of the channels */
    size_t  channels, pixels;
    double *sum, *squares;                 /* squares: points to the second half of sum */
    int     drawn, differs;                /* drawn: how many phases; differs: one is unlike the first */
} sums;

static int sums_new(sums *t, const stage *s, kit_error *err)
{
    static const char *const lit_names[6] = { "irradiance.R", "irradiance.G", "irradiance.B",
                                              "bounce.R", "bounce.G", "bounce.B" },
                      *const ao_names[1] = { "Y" };
    *t = (sums){ .names = s->lit ? lit_names : ao_names, .channels = s->lit ? 6 : 1,
                 .pixels = (size_t)s->truth.width * (size_t)s->truth.height };
    t->sum = calloc(2 * t->channels * t->pixels, sizeof *t->sum);
    if (!t->sum) return kit_fail(err, "out of memory");
    t->squares = t->sum + t->channels * t->pixels;
    return 0;
}

static void sums_add(sums *t, const kit_image *picture)
{
    for (size_t c = 0; c < t->channels; ++c) {
        const float *v = kit_image_channel(picture, t->names[c]);
        for (size_t i = 0; i < t->pixels; ++i) {
            double *const sum = &t->sum[c * t->pixels + i];
            t->differs |= t->drawn && (double)v[i] * t->drawn != *sum;
            *sum += (double)v[i];
            t->squares[c * t->pixels + i] += (double)v[i] * (double)v[i];
        }
    }
    ++t->drawn;
}

/* Draws the next phase of the noise. With history its frames have numbers that no other phase has. */
static int sums_draw(sums *t, const stage *s, kit_run *run, int phases, kit_error *err)
{
    kit_image now;
    run->frame.phase = (float)t->drawn / (float)phases;
    kit_run_update(run);
    if (stage_settled(&now, s, run, SETTLED * (unsigned)t->drawn, 0, err)) return -1;
    sums_add(t, &now);
    kit_image_free(&now);
    return 0;
}

/* Sums over the pixels: of the truth, of the mean picture's squared error, of the variances; of the error of hue,
   everywhere and in shade, with its weights; of the bounce only truth and variances. */
typedef struct errors { double level, off, noise, values, hue[2], weight[2], bounce, bounce_noise; } errors;

/* Returns a value's variance over the drawn phases. */
static double variance(const sums *t, size_t k)
{
    const double mean = t->sum[k] / t->drawn;
    return t->differs ? fmax(0, t->squares[k] / t->drawn - mean * mean) * t->drawn / (t->drawn - 1) : 0;
}

/* Adds pixel i to the sums of errors. open: the unoccluded light; NULL for visibility. */
static void errors_add(errors *e, const sums *t, size_t i, const float *const *truth, const float *const *open)
{
    static const double luminance[3] = { 0.2126, 0.7152, 0.0722 };
    double of[2] = { 0, 0 }, product = 0, bright = 0, unoccluded = 0, turned = 0;
    for (size_t c = 3; c < t->channels; ++c) {
        e->bounce += (double)truth[c][i];
        e->bounce_noise += variance(t, c * t->pixels + i);
    }
    for (size_t c = 0; c < t->channels && c < 3; ++c) {
        const double is = t->sum[c * t->pixels + i] / t->drawn, should = (double)truth[c][i];
        e->level += should;
        e->off += (is - should) * (is - should);
        e->noise += variance(t, c * t->pixels + i);
        of[0] += is * is;
        of[1] += should * should;
        product += is * should;
        if (open[c]) bright += luminance[c] * should;
        if (open[c]) unoccluded += luminance[c] * (double)open[c][i];
        e->values += 1;
    }
    if (of[0] > 0 && of[1] > 0) turned = acos(fmin(1, product / sqrt(of[0] * of[1])));
    for (int k = 0; k < (bright < 0.95 * unoccluded ? 2 : 1); ++k) {
        e->hue[k] += bright * turned;
        e->weight[k] += bright;
    }
}

int score_phases(row *r, stage *s, kit_run *run, int phases, const kit_image *picture, kit_error *err)
{
    const float *z = kit_image_channel(&s->frame, "Z"), *truth[6], *open[6] = { NULL };
    errors e = { 0 };
    sums t;
    if (sums_new(&t, s, err)) return -1;
    sums_add(&t, picture);
    while (run && t.drawn < (t.drawn == 2 && !t.differs ? 2 : phases))
        if (sums_draw(&t, s, run, phases, err)) { free(t.sum); return -1; }
    for (size_t c = 0; c < t.channels; ++c) {
        truth[c] = kit_image_channel(&s->truth, t.names[c]);
        if (s->lit && s->givens) open[c] = kit_image_channel(&s->given[0].picture, t.names[c]);
    }
    for (size_t i = 0; i < t.pixels; ++i)
        if (z[i] > 0 && !isnan(t.sum[i])) errors_add(&e, &t, i, truth, open);
    const double level = s->lit ? e.level / e.values : 1;
    r->of = s->lit ? OF_SPLIT : r->of | OF_PHASES;
    r->split[SPLIT_ALL] = sqrt((e.off + e.noise * (t.drawn - 1) / t.drawn) / e.values) / level;
    r->split[SPLIT_MODEL] = sqrt(fmax(0, e.off - e.noise / t.drawn) / e.values) / level;
    r->split[SPLIT_NOISE] = run ? sqrt(e.noise / e.values) / level : (double)NAN;
    r->split[SPLIT_BOUNCE] = e.bounce > 0 ? sqrt(e.bounce_noise * e.values) / e.bounce : (double)NAN;
    for (int k = 0; k < 2; ++k) r->split[SPLIT_HUE + k] = e.hue[k] / e.weight[k] * 180 / acos(-1);
    free(t.sum);
    return 0;
}
