/* sweep.c - sweeps methods through a cause of failure: its frames give an error, flicker, lag or trail at each value.
   Declared in sweep.h. */
#include "lab/stability/sweep.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/stability/shot.h"

/* ---- >>figures of one frame -------------------------------------------------------------------------------------- */

/* Scores only the pixels whose points the frame before did not show. */
static void only_new(shot *s, const shot *last)
{
    for (int i = 0; i < s->frame.width * s->frame.height; ++i) {
        double v;
        float p[3];
        if (!(s->mask[i] > 0)) continue;
        shot_place(s, i, p);
        if (shot_value_at(&v, last, &last->truth[0], p, s->object[i])) s->mask[i] = 0;
    }
}

/* Returns how much of the old picture is still seen, at pixels whose truth has changed: the mean difference to the
   frame alone, counted toward the old truth. share: instead, the share of all pixels at which this difference is above
   HELD_MOST, and raises the error by more than HELD_MOST. */
static const float HELD_MOST = 0.05f;
static double remains(const shot *s, const shot *before, int m, int share)
{
    double sum = 0;
    int count = 0, held = 0;
    for (int i = 0; i < s->frame.width * s->frame.height; ++i) {
        const float now = shot_values(&s->truth[0])[i], was = shot_values(&before->truth[0])[i];
        if (!(s->mask[i] > 0) || !(fabsf(now - was) > 0.05f)) continue;
        const float seen = shot_values(&s->picture[m])[i], alone = shot_values(&s->single[m])[i];
        const float d = was > now ? seen - alone : alone - seen;
        sum += (double)d;
        held += d > HELD_MOST && fabsf(seen - now) - fabsf(alone - now) > HELD_MOST;
        ++count;
    }
    if (share) return (double)held / (s->frame.width * s->frame.height);
    return count ? sum / count : 0;
}

/* ---- >>figures over frames --------------------------------------------------------------------------------------- */

/* Returns the deviation over the frames at points that the first frame shows. second: for light that changes by itself,
   the root mean square of the second difference instead, divided by the root of 6, which noise would have (1 -2 1).
   mean: of the values. */
static double flicker(double *mean, const shot *shots, int frames, const kit_image *const *pictures, int second)
{
    double sum = 0, all = 0, square, middle;
    size_t places = 0;
    for (int i = 0; i < shots->frame.width * shots->frame.height; ++i) {
        if (!shot_varies(&square, &middle, shots, frames, pictures, i, second)) continue;
        sum += square;
        all += middle;
        ++places;
    }
    *mean = all / (double)places;
    return sqrt(sum / (double)places);
}

/* Returns the error of all frames over that of the same frames alone, at points new to each frame. */
static double newly_over_alone(const shot *shots, int frames, int m)
{
    double sum[2] = { 0, 0 };
    for (int k = 1; k < frames; ++k)
        for (int g = 0; g < 2; ++g) {
            const kit_image *picture = g ? &shots[k].single[m] : &shots[k].picture[m];
            const double e = shot_apart(picture, &shots[k].truth[0], shots[k].mask);
            if (e > 0) sum[g] += e * e;
        }
    return sqrt(sum[0] / sum[1]);
}

/* Returns the largest ratio of a frame's error to that of the frame drawn alone, from frame first on. */
static double most_over_alone(const shot *shots, int first, int frames, int m)
{
    double most = 0;
    for (int k = first; k < frames; ++k) {
        const shot *s = &shots[k];
        most = fmax(most, shot_apart(&s->picture[m], &s->truth[0], s->mask)
                              / fmax(shot_apart(&s->single[m], &s->truth[0], s->mask), 1e-4));
    }
    return most;
}

/* Returns a method's flicker, less the truth's except for SECOND; for m below 0 the truth's. */
static double flicker_of(const shot *shots, int frames, int kind, int m, int between)
{
    const kit_image *truths[FRAMES], *pictures[FRAMES];
    const int second = kind != DEVIATION;
    double mean, own, y;
    for (int k = 0; k < frames; ++k) {
        truths[k] = &shots[k].truth[between];
        pictures[k] = m < 0 ? truths[k] : &shots[k].picture[m];
    }
    own = flicker(&mean, shots, frames, truths, second) / (kind == LIT_SECOND ? mean : 1);
    y = flicker(&mean, shots, frames, pictures, second) / (kind == LIT_SECOND ? mean : 1);
    return m >= 0 && kind != SECOND ? sqrt(fmax(0, y * y - own * own)) : y;
}

/* ---- >>points ---------------------------------------------------------------------------------------------------- */

/* Returns the picture with which method m is compared in its last frame. */
static const kit_image *truth_of(const shot *shots, int frames, int kind, int m, int between)
{
    return kind == PRECISION && m >= 0 ? &shots[0].picture[m] : &shots[frames - 1].truth[between];
}

/* Returns a curve's figure, from the frames of one value. */
static double figure_of(const shot *shots, int frames, int kind, int m, int between)
{
    const shot *s = &shots[frames - 1];
    switch (kind) {
    case ERROR:
    case PRECISION:
        return shot_apart(m < 0 ? &s->none : &s->picture[m], truth_of(shots, frames, kind, m, between), s->mask);
    case NEWLY:     return newly_over_alone(shots, frames, m);
    case TRAIL:     return remains(s, &shots[CHANGED - 1], m, 0);
    case HELD:      return remains(s, &shots[CHANGED - 1], m, 1);
    case FOLLOWS:   return most_over_alone(shots, 1, frames, m);
    case AFTER:     return most_over_alone(shots, frames - 1, frames, m);
    case SHADES:    return 1.0 / shot_shades(m < 0 ? &s->truth[0] : &s->picture[m], s->mask);
    default:        return flicker_of(shots, frames, kind, m, between);
    }
}

static int flickers(int kind) { return kind == DEVIATION || kind == SECOND || kind == LIT_SECOND; }

/* Puts a method's picture, its truth and their difference side by side, of each stride x stride pixels the middle one.
   Flicker: of the first frame; instead of the difference the deviation over the frames. */
static int strip(kit_image *out, const shot *shots, int frames, int kind, int m, int between, kit_error *err)
{
    const int still = !flickers(kind);
    const shot *s = still ? &shots[frames - 1] : shots;
    const float *is = shot_values(&s->picture[m]), gain = kind == LIT_SECOND ? 0.4f : 1;
    const float *truth = shot_values(still ? truth_of(shots, frames, kind, m, between) : &s->truth[between]);
    const int stride = s->look.stride, width = s->look.width / stride, pixels = width * (s->look.height / stride);
    const kit_image *pictures[FRAMES];
    kit_image apart, zero, colour;
    for (int k = 0; k < frames; ++k) pictures[k] = &shots[k].picture[m];
    kit_image_free(out);
    if (kit_image_new(&apart, width, pixels / width, "Y", err) || kit_image_new(&zero, width, pixels / width, "Y", err)
        || kit_image_new(out, 3 * width, pixels / width, "R,G,B", err))
        return -1;
    for (int i = 0; i < 3 * pixels; ++i) {
        const int at = i % pixels, x = at % width, y = at / width;
        const int from = (y * stride + stride / 2) * s->look.width + x * stride + stride / 2;
        float *const to = &out->data[(i - at) * 3 + y * 3 * width + x];
        double square = 0, mean;
        to[0] = gain * is[from];
        to[width] = gain * truth[from];
        if (i < pixels && !still) shot_varies(&square, &mean, shots, frames, pictures, from, kind != DEVIATION);
        if (i < pixels) apart.data[i] = still ? is[from] - truth[from] : (float)sqrt(square);
    }
    if (kit_image_difference(&colour, &apart, &zero, "Y", still ? 0.5f : 0.05f, err)) return -1;
    for (int i = 0; i < 3 * pixels; ++i) out->data[i / width * 3 * width + 2 * width + i % width] = colour.data[i];
    kit_image_free(&apart);
    kit_image_free(&zero);
    kit_image_free(&colour);
    return 0;
}

/* Adds a point to every curve from the frames of one value, and keeps the worst one of a method as a picture. */
static int point_of(result *r, int point, const shot *shots, int frames, kit_error *err)
{
    const int kind = r->cause->kind;
    for (int i = 0; i < r->curves; ++i) {
        curve *c = &r->curve[i];
        const int m = c->method, between = m >= 0 && sweeps_method[m].of & FAR;
        if (m >= 0 && !shots[frames - 1].picture[m].data) continue;
        c->y[point] = figure_of(shots, frames, kind, m, between);
        if (c->number >= c->y[point]) continue;
        c->number = c->y[point];
        c->at = r->x[point];
        if (m >= 0 && strip(&c->worst, shots, frames, kind, m, between, err)) return -1;
    }
    return 0;
}

/* The number of a curve of PRECISION is the largest value up to which all errors are at most LIMIT. */
static const double LIMIT = 0.02;
static void holds(result *r)
{
    for (curve *c = r->curve; c < r->curve + r->curves; ++c) {
        c->number = 0;
        for (int k = 0; k < r->points && c->y[k] <= LIMIT; ++k) c->number = r->x[k];
    }
}

/* ---- >>sweep ----------------------------------------------------------------------------------------------------- */

/* Returns how many frames a value of a cause takes. */
static int frames_of(const cause *c, double value)
{
    if (c->kind == ERROR || c->kind == SHADES) return 1;
    if (c->kind == PRECISION) return 2;
    if (c->kind == AFTER || c->kind == TRAIL || c->kind == HELD) return CHANGED + (int)value;
    return c->kind == FOLLOWS || c->kind == NEWLY || (c->kind == DEVIATION && c->of == KEPT) ? FRAMES : 4;
}

/* Adds a curve for each swept method and for the reference beside them; truths: set to those they need. */
static void curves_of(result *r, const sweep_options *o, int truths[2])
{
    static const char *const beside[] = { [ERROR] = "no AO", [DEVIATION] = "truth", [SECOND] = "truth",
                                          [LIT_SECOND] = "open", [SHADES] = "truth" };
    const cause *c = r->cause;
    const int lit = c->kind == ERROR && c->of & (TURNED | BOUNCED | SHADOWED) && !(c->of & SCREEN);
    if (lit || beside[c->kind]) curve_new(r, lit ? "none" : beside[c->kind], BESIDE);
    for (int m = 0; m < sweeps_methods; ++m) {
        if (!(sweeps_method[m].of & c->of) || (o->methods && !o->method[m])) continue;
        curve_new(r, sweeps_method[m].label, m);
        if (c->kind != PRECISION) truths[sweeps_method[m].of / FAR] = truths[0] = 1;
    }
}

int sweep_asked(const cause *c, const sweep_options *o)
{
    int has = c->curves != NULL && !o->methods;
    for (int m = 0; m < sweeps_methods; ++m) has |= sweeps_method[m].of & c->of && (!o->methods || o->method[m]);
    return has && (!o->causes || o->cause[c - sweeps_cause]);
}

static int draw(shot *s, int m, int width, kit_frames *kept, kit_error *err)
{
    if (sweeps_method[m < 0 ? 0 : m].of & (KEPT | KEPT_LIGHT)) return shot_draw_kept(s, m, &kept[m], err);
    return m >= 0 && width <= sweeps_method[m].widest ? shot_draw(s, m, err) : 0;
}

/* Returns whether a figure of so many frames needs the truth of frame k. */
static int traced(int kind, int k, int first, int frames)
{
    const int last = k == frames - 1;
    return kind == AFTER ? last : kind == TRAIL || kind == HELD ? last || k == CHANGED - 1 : k >= first;
}

/* Draws the frames of one value with all methods, and adds the point of each curve. done, share: for kit_progress. */
static int value_of(result *r, double value, const sweep_options *o, const int truths[2], const char *what, double done,
                    double share, kit_error *err)
{
    static shot shots[FRAMES];
    static kit_frames kept[MOST_METHODS];
    static const int none[2] = { 0, 0 };
    const cause *c = r->cause;
    const int frames = frames_of(c, value);
    const int first = c->kind == DEVIATION && c->of == KEPT ? CHANGED : 0;     /* history fills before */
    look l;
    r->x[r->points] = value;
    for (int k = 0; k < frames; ++k) {
        l = sweeps_look(c, value, k);
        if (o->quick) l.rays /= 2;
        kit_progress(what, done + share * k / frames);
        if (shot_open(&shots[k], &l, traced(c->kind, k, first, frames) ? truths : none, err)) return -1;
        if (c->kind == NEWLY && k) only_new(&shots[k], &shots[k - 1]);
        for (int i = 0; i < r->curves; ++i) {
            if (draw(&shots[k], r->curve[i].method, l.width, kept, err)) return -1;
            kit_progress(what, done + share * (k + (i + 0.99) / r->curves) / frames);
        }
    }
    for (int m = 0; m < sweeps_methods; ++m) kit_frames_close(&kept[m]);
    if (point_of(r, r->points++, shots + first, frames - first, err)) return -1;
    for (int k = 0; k < frames; ++k) shot_close(&shots[k]);
    return 0;
}

int sweep(result *r, const cause *c, const sweep_options *o, const char *what, kit_error *err)
{
    int truths[2] = { 0, 0 }, values = 1;
    for (int i = 0; i < r->curves; ++i) kit_image_free(&r->curve[i].worst);
    memset(r, 0, sizeof *r);
    r->cause = c;
    if (c->curves) return c->curves(r, err);
    while (values < MOST_VALUES && c->value[values] != 0) ++values;
    curves_of(r, o, truths);
    for (int v = 0; v < values; ++v) {
        if (o->quick && (v % 2 != (values - 1) % 2 || sweeps_look(c, c->value[v], 0).width > 1920)) continue;
        if (value_of(r, c->value[v], o, truths, what, (double)v / values, 1.0 / values, err)) return -1;
    }
    kit_progress(what, 1);
    if (c->kind == PRECISION) holds(r);
    return 0;
}
