/* compared.c - compares pictures value by value; the autocorrelation of their difference. Declared in compared.h. */
#include "lab/against/compared.h"
#include <math.h>
#include <stdlib.h>

const int compared_lag[COMPARED_LAGS] = { 1, 3 };

/* The difference of two pictures in one channel; a value is NAN if its pixel is not compared. */
typedef struct difference {
    int width, height;
    float *value;
    size_t values;
    double sum, squares;
} difference;

static void add(difference *d, int i, double v)
{
    d->value[i] = (float)v;
    d->sum += v;
    d->squares += v * v;
    ++d->values;
}

static double correlation(const difference *d, int right, int down)
{
    const double mean = d->sum / (double)d->values, variance = d->squares / (double)d->values - mean * mean;
    double sum = 0;
    size_t pairs = 0;
    for (int y = 0; y + down < d->height; ++y)
        for (int x = 0; x + right < d->width; ++x) {
            const float *at = &d->value[y * d->width + x], *to = at + down * d->width + right;
            if (isnan(*at) || isnan(*to)) continue;
            sum += ((double)*at - mean) * ((double)*to - mean);
            ++pairs;
        }
    return pairs && variance > 1e-9 * mean * mean ? sum / (double)pairs / variance : 0;
}

/* Adds the mean difference of each 8x8 patch of pixels in which more than half are compared. */
static void add_patches(difference *patches, const difference *d)
{
    enum { PIXELS = COMPARED_PATCH * COMPARED_PATCH };

    for (int k = 0; k < patches->width * patches->height; ++k) {
        const int x = k % patches->width * COMPARED_PATCH, y = k / patches->width * COMPARED_PATCH;
        double sum = 0;
        int known = 0;
        for (int i = 0; i < PIXELS; ++i) {
            const float v = d->value[(y + i / COMPARED_PATCH) * d->width + x + i % COMPARED_PATCH];
            if (isnan(v)) continue;
            sum += (double)v;
            ++known;
        }
        patches->value[k] = NAN;
        if (known > PIXELS / 2) add(patches, k, sum / known);
    }
}

/* Adds one channel's sums of differences to out, and its correlations times weight. */
static void compare(compared *out, difference *d, difference *patches, double weight)
{
    for (int l = 0; l < COMPARED_LAGS; ++l) {
        out->across[l] += weight * correlation(d, compared_lag[l], 0);
        out->down[l] += weight * correlation(d, 0, compared_lag[l]);
    }
    add_patches(patches, d);
    out->patches += weight * (correlation(patches, 1, 0) + correlation(patches, 0, 1)) / 2;
    out->values += d->values;
    out->bias += d->sum;
    out->rmse += d->squares;
}

int compared_of(compared *out, const kit_image *a, const kit_image *b, const char *const *channels, int count,
                const float *mask, kit_error *err)
{
    const size_t pixels = (size_t)a->width * (size_t)a->height;
    compared c = { 0 };
    if (a->width != b->width || a->height != b->height)
        return kit_fail(err, "the pictures differ in size: %dx%d and %dx%d", a->width, a->height, b->width, b->height);
    float *room = malloc(2 * pixels * sizeof *room);
    int failed = room ? 0 : kit_fail(err, "out of memory");
    for (int k = 0; k < count && !failed; ++k) {
        const float *of_a = kit_image_channel(a, channels[k]), *of_b = kit_image_channel(b, channels[k]);
        difference d = { a->width, a->height, room, 0, 0, 0 };
        difference patches = { a->width / COMPARED_PATCH, a->height / COMPARED_PATCH, room + pixels, 0, 0, 0 };
        if (!of_a || !of_b) {
            failed = kit_fail(err, "the %s picture has no channel %s", of_a ? "second" : "first", channels[k]);
            continue;
        }
        for (size_t i = 0; i < pixels; ++i) {
            d.value[i] = NAN;
            if (!mask || mask[i] > 0) add(&d, (int)i, (double)of_a[i] - (double)of_b[i]);
        }
        compare(&c, &d, &patches, 1.0 / count);
    }
    free(room);
    if (!failed && !c.values) failed = kit_fail(err, "the pictures have no pixel to compare");
    if (failed) return -1;
    c.bias /= (double)c.values;
    c.rmse = sqrt(c.rmse / (double)c.values);
    *out = c;
    return 0;
}

int errors_of(errors *out, const kit_image *const picture[2], const kit_image *truth, const char *const *channels,
              int count, const float *mask, kit_error *err)
{
    const size_t pixels = (size_t)truth->width * (size_t)truth->height;
    double sum = 0, squares = 0;
    errors e = { 0 };
    compared c = { 0 };
    for (int k = 0; k < 2; ++k) {
        if (compared_of(&c, picture[k], truth, channels, count, mask, err)) return -1;
        e.rmse[k] = c.rmse;
    }
    const double known = (double)c.values / count;
    for (size_t i = 0; i < pixels; ++i) {
        double more = 0; /* squared error of b less that of a */
        if (mask && !(mask[i] > 0)) continue;
        for (int k = 0; k < count; ++k) {
            const double is = (double)kit_image_channel(truth, channels[k])[i],
                         first = (double)kit_image_channel(picture[0], channels[k])[i] - is,
                         second = (double)kit_image_channel(picture[1], channels[k])[i] - is;
            more += (second * second - first * first) / count;
        }
        sum += more;
        squares += more * more;
    }
    const double variance = fmax(0, squares / known - sum / known * (sum / known));
    if (variance > 0) e.doubt = sqrt(variance / known) / (e.rmse[0] + e.rmse[1]);
    *out = e;
    return 0;
}
