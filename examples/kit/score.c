/* score.c - compares images: scores, colours of differences. Declared in kit.h. */
#include "kit/kit_image.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static int channel_pair(const float **ca, const float **cb, const kit_image *a, const kit_image *b, const char *channel,
                        kit_error *err)
{
    if (a->width != b->width || a->height != b->height)
        return kit_fail(err, "the pictures differ in size: %d x %d and %d x %d", a->width, a->height, b->width,
                        b->height);
    *ca = kit_image_channel(a, channel);
    *cb = kit_image_channel(b, channel);
    if (!*ca || !*cb) return kit_fail(err, "the %s picture has no channel %s", *ca ? "second" : "first", channel);
    return 0;
}

typedef struct ssim_job {
    const float *a, *b, *mask;
    int          width, height;
    double       gauss[11];
    /* one sum a row; added in order, so that the result does not depend on the number of threads */
    double      *sum;
    int         *count;
} ssim_job;

static int ssim_counts(const ssim_job *j, size_t i)
{
    return (!j->mask || j->mask[i] > 0) && isfinite(j->a[i]) && isfinite(j->b[i]);
}

/* Computes the SSIM [Wang et al. 2004] of a row of [0,1] data. The 11 x 11 window is separable. Its weights are divided
   by their sum over the pixels that count, for borders and gaps. Short strips let their columns' sums fit the stack. */
static void ssim_row(void *context, int y)
{
    enum { STRIP = 256, REACH = 5, SUMS = 6 };
    const double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03;
    ssim_job *j = context;
    int known = 0;
    while (known < j->width && !ssim_counts(j, (size_t)y * (size_t)j->width + (size_t)known)) ++known;
    if (known == j->width) return;          /* as in most rows of a ground truth with a stride, where no pixel counts */
    for (int x0 = 0; x0 < j->width; x0 += STRIP) {
        double column[STRIP + 2 * REACH][SUMS] = {{0}};
        int x1 = x0 + STRIP < j->width ? x0 + STRIP : j->width;
        for (int v = y < REACH ? -y : -REACH; v <= REACH && y + v < j->height; ++v)
            for (int x = x0 < REACH ? 0 : x0 - REACH; x < x1 + REACH && x < j->width; ++x) {
                size_t i = (size_t)(y + v) * (size_t)j->width + (size_t)x;
                if (!ssim_counts(j, i)) continue;
                double w = j->gauss[v + REACH], a = (double)j->a[i], b = (double)j->b[i], *s = column[x - x0 + REACH];
                s[0] += w; s[1] += w * a; s[2] += w * b; s[3] += w * a * a; s[4] += w * b * b; s[5] += w * a * b;
            }
        for (int x = x0; x < x1; ++x) {
            if (!ssim_counts(j, (size_t)y * (size_t)j->width + (size_t)x)) continue;
            double s[SUMS] = { 0 };
            for (int u = 0; u < 11; ++u)
                for (int k = 0; k < SUMS; ++k) s[k] += j->gauss[u] * column[x - x0 + u][k];
            double a = s[1] / s[0], b = s[2] / s[0];
            double aa = s[3] / s[0] - a * a, bb = s[4] / s[0] - b * b, ab = s[5] / s[0] - a * b;
            j->sum[y] += (2 * a * b + c1) * (2 * ab + c2) / ((a * a + b * b + c1) * (aa + bb + c2));
            j->count[y]++;
        }
    }
}

/* Returns the smallest of the n values such that at least share * n of them do not exceed it. The bits of positive
   floats have the order of the floats, so two histograms, each of half the bits, find it exactly. */
static float quantile(const float *values, size_t n, double share, size_t *histogram)
{
    size_t   below = 0, rank = (size_t)ceil(share * (double)n);
    uint32_t high = 0;
    for (int half = 0; half < 2; ++half) {
        memset(histogram, 0, 65536 * sizeof *histogram);
        for (size_t i = 0; i < n; ++i) {
            uint32_t bits;
            memcpy(&bits, &values[i], 4);
            if (!half) histogram[bits >> 16]++;
            else if (bits >> 16 == high) histogram[bits & 65535]++;
        }
        uint32_t k = 0;
        while (k < 65535 && below + histogram[k] < rank) below += histogram[k++];
        high = half ? high << 16 | k : k;
    }
    float value;
    memcpy(&value, &high, 4);
    return value;
}

int kit_score_channel(kit_score *score, const kit_image *a, const kit_image *b, const char *channel, const float *mask,
                      kit_error *err)
{
    ssim_job job = { .mask = mask, .width = a->width, .height = a->height };
    if (channel_pair(&job.a, &job.b, a, b, channel, err)) return -1;
    size_t n = kit_image_pixels(a), rows = (size_t)a->height, pixels = 0;
    float  *absolute = malloc(n * sizeof *absolute);
    size_t *histogram = malloc(65536 * sizeof *histogram);
    job.sum = calloc(rows, sizeof *job.sum);
    job.count = calloc(rows, sizeof *job.count);
    int failed = !absolute || !histogram || !job.sum || !job.count ? kit_fail(err, "no memory to compare pictures") : 0;

    double sum = 0, squares = 0;
    for (size_t i = 0; i < n && !failed; ++i) {
        if (mask && !(mask[i] > 0)) continue;
        double d = (double)job.a[i] - (double)job.b[i];
        if (job.a[i] == job.b[i]) d = 0;   /* two equal infinities */
        if (isnan(d)) continue;
        sum += d;
        squares += d * d;
        absolute[pixels++] = (float)fabs(d);
    }
    if (!failed && !pixels)
        failed =
            kit_fail(err, "nothing to compare in channel %s: no pixel is in the mask and a number in both pictures",
                     channel);
    if (!failed) {
        double ssim = 0, total = 0;
        for (int i = 0; i < 11; ++i) total += job.gauss[i] = exp(-(i - 5) * (i - 5) / (2 * 1.5 * 1.5));
        for (int i = 0; i < 11; ++i) job.gauss[i] /= total;
        kit_parallel(NULL, a->height, ssim_row, &job);
        total = 0;
        for (size_t y = 0; y < rows; ++y) { ssim += job.sum[y]; total += job.count[y]; }
        *score = (kit_score){ .rmse = sqrt(squares / (double)pixels),
                              .bias = sum / (double)pixels,
                              .p95 = (double)quantile(absolute, pixels, 0.95, histogram),
                              .ssim = ssim / total,
                              .pixels = pixels };
    }
    free(absolute); free(histogram); free(job.sum); free(job.count);
    return failed;
}

int kit_score_channels(kit_score *score, const kit_image *a, const kit_image *b, const char *const *channels, int count,
                       const float *mask, kit_error *err)
{
    kit_score one, all = { 0 };
    for (int i = 0; i < count; ++i) {
        if (kit_score_channel(&one, a, b, channels[i], mask, err)) return -1;
        all.rmse += one.rmse * one.rmse / count;
        all.bias += one.bias / count;
        all.p95 += one.p95 / count;
        all.ssim += one.ssim / count;
        all.pixels = one.pixels;
    }
    all.rmse = sqrt(all.rmse);
    *score = all;
    return 0;
}

/* Colours are straight lines in Oklab, so that equal differences look equally different: from near-white (L 0.96) to
   blue and red of the same lightness (0.50) and chroma (0.20), hues 262 and 27 degrees. In sRGB. */
int kit_image_difference(kit_image *out, const kit_image *a, const kit_image *b, const char *channel, float range,
                         kit_error *err)
{
    const float *ca, *cb;
    kit_image image;
    if (channel_pair(&ca, &cb, a, b, channel, err)) return -1;
    if (!(range > 0 && isfinite(range)))
        return kit_fail(err, "the range of the difference must be > 0, not %g", (double)range);
    if (kit_image_new(&image, a->width, a->height, "R,G,B", err)) return -1;
    for (size_t i = 0, n = kit_image_pixels(a); i < n; ++i) {
        double t = ca[i] == cb[i] ? 0 : fmax(-1, fmin(1, ((double)ca[i] - (double)cb[i]) / (double)range));
        if (isnan(ca[i]) || isnan(cb[i])) continue;                             /* black */
        double hue = (t < 0 ? 262 : 27) * KIT_PI / 180, chroma = 0.20 * fabs(t), L = 0.96 - 0.46 * fabs(t);
        double A = chroma * cos(hue), B = chroma * sin(hue);
        double l = pow(L + 0.3963377774 * A + 0.2158037573 * B, 3), m = pow(L - 0.1055613458 * A - 0.0638541728 * B, 3),
               s = pow(L - 0.0894841775 * A - 1.2914855480 * B, 3);
        const double rgb[3] = { 4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s,
                                -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
                                -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s };
        for (size_t c = 0; c < 3; ++c) {
            double v = fmax(0, fmin(1, rgb[c]));
            image.data[c * n + i] = (float)(v <= 0.0031308 ? 12.92 * v : 1.055 * pow(v, 1 / 2.4) - 0.055);
        }
    }
    *out = image;
    return 0;
}
