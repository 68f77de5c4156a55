/* bands.c - splits the difference between two pictures into bands of frequency. Declared in bands.h. */
#include "lab/measure/bands.h"
#include <math.h>
#include <stdlib.h>

static const float bands_sigma[BANDS] = { 1.2f, 3, 8, 20 };
#define UNKNOWN ((double)NAN)
const bands bands_unknown = { { UNKNOWN, UNKNOWN, UNKNOWN, UNKNOWN }, UNKNOWN };

/* ---- >>blur ------------------------------------------------------------------------------------------------------ */

enum { REACH = 3, MOST_TAPS = 64 };        /* reach of a Gaussian in sigmas; taps on one side of the widest one */

/* Blurs a picture along its rows and transposes it; two such calls are a whole blur. Outside of the picture is 0. */
static void blur_turned(float *to, const float *from, int width, int height, float sigma)
{
    const int taps = (int)ceilf(REACH * sigma);
    float weight[MOST_TAPS], sum = 0;
    for (int k = 0; k <= taps; ++k) {
        weight[k] = expf(-0.5f * (float)(k * k) / (sigma * sigma));
        sum += k ? 2 * weight[k] : weight[k];
    }
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const float *at = from + (size_t)y * (size_t)width + x;
            float value = weight[0] * at[0];
            for (int k = 1; k <= taps; ++k)
                value += weight[k] * ((x >= k ? at[-k] : 0) + (x + k < width ? at[k] : 0));
            to[(size_t)x * (size_t)height + (size_t)y] = value / sum;
        }
}

/* Blurs a picture by a Gaussian. between: room for one picture. */
static void blur(float *to, const float *from, float *between, int width, int height, float sigma)
{
    blur_turned(between, from, width, height, sigma);
    blur_turned(to, between, height, width, sigma);
}

/* ---- >>shaded ---------------------------------------------------------------------------------------------------- */

/* Writes the position that a pixel shows, in view space. Returns 0 if it shows none. */
static int seen_at(double p[3], const stage *s, int x, int y)
{
    const float *projection = s->gbuffer.projection;
    const int width = s->frame.width, height = s->frame.height;
    const double z = (double)kit_image_channel(&s->frame, "Z")[(size_t)y * (size_t)width + (size_t)x];
    p[0] = (2 * (x + 0.5) / width - 1) * z / (double)projection[0];
    p[1] = (1 - 2 * (y + 0.5) / height) * z / (double)projection[5];
    p[2] = -z;
    return z > 0;
}

static int is_smooth(const stage *s, int x, int y)
{
    static const char *const names[3] = { "N.X", "N.Y", "N.Z" };
    const size_t i = (size_t)y * (size_t)s->frame.width + (size_t)x;
    double p[3], q[3], n[3];
    if (!seen_at(p, s, x, y)) return 0;
    for (int k = 0; k < 3; ++k) n[k] = (double)kit_image_channel(&s->frame, names[k])[i];
    const double footprint = -2 * p[2] / ((double)s->gbuffer.projection[5] * s->frame.height);
    for (int k = 0; k < 25; ++k) {
        if (!seen_at(q, s, x + k % 5 - 2, y + k / 5 - 2)) return 0;
        if (!(fabs(kit_dot(n, q) - kit_dot(n, p)) < footprint)) return 0;
    }
    return 1;
}

int shaded_find(shaded *m, const stage *s, const kit_image *visibility, kit_error *err)
{
    const int width = s->frame.width, height = s->frame.height;
    const size_t pixels = (size_t)width * (size_t)height;
    float *const all = calloc((BANDS + 2) * pixels, sizeof *all);
    if (!all) return kit_fail(err, "out of memory");
    *m = (shaded){ .width = width, .height = height, .on = all };
    for (int y = BORDER; y < height - BORDER; ++y)
        for (int x = BORDER; x < width - BORDER; ++x) {
            const size_t i = (size_t)y * (size_t)width + (size_t)x;
            if (!(visibility->data[i] < SHADED) || !is_smooth(s, x, y)) continue;
            m->on[i] = 1;
            ++m->pixels;
        }
    for (size_t k = 0; k < BANDS; ++k) {
        m->weight[k] = all + (k + 1) * pixels;
        blur(m->weight[k], m->on, all + (BANDS + 1) * pixels, width, height, bands_sigma[k]);
    }
    if (m->pixels) return 0;
    shaded_free(m);
    return kit_fail(err, "--scene %s, --size %dx%d: no pixel of a smooth surface in shade is %d pixels away from the "
                         "border", s->name, width, height, BORDER);
}

int shaded_seen(shaded *m, const stage *s, kit_error *err)
{
    stage all = *s;
    kit_image quiet;
    kit_error none;
    all.lit = NULL;
    *m = (shaded){ .on = NULL };
    if (stage_drawn(&quiet, &all, "hsao-best", "slices=8", s->radius, err)) return -1;
    shaded_find(m, &all, &quiet, &none);
    kit_image_free(&quiet);
    return 0;
}

void shaded_free(shaded *m)
{
    free(m->on);
    *m = (shaded){ .on = NULL };
}

/* ---- >>bands ----------------------------------------------------------------------------------------------------- */

/* Returns the mean of (a - b) (c - d) over the pixels that m counts. */
static double product_of(const float *a, const float *b, const float *c, const float *d, const shaded *m)
{
    const size_t all = (size_t)m->width * (size_t)m->height;
    double sum = 0;
    for (size_t i = 0; i < all; ++i)
        sum += (double)m->on[i] * ((double)a[i] - (double)b[i]) * ((double)c[i] - (double)d[i]);
    return sum / (double)m->pixels;
}

/* Fills BANDS + 1 levels: a - b on the counted pixels, then that blurred by each sigma. room: BANDS + 2 pictures. */
static void levels_of(float *level[BANDS + 1], float *room, const shaded *m, const float *a, const float *b)
{
    const size_t all = (size_t)m->width * (size_t)m->height;
    for (size_t k = 0; k <= BANDS; ++k) level[k] = room + k * all;
    for (size_t i = 0; i < all; ++i) level[0][i] = m->on[i] > 0 ? a[i] - b[i] : 0;
    for (int k = 0; k < BANDS; ++k) {
        blur(level[k + 1], level[0], room + (BANDS + 1) * all, m->width, m->height, bands_sigma[k]);
        for (size_t i = 0; i < all; ++i) level[k + 1][i] = m->on[i] > 0 ? level[k + 1][i] / m->weight[k][i] : 0;
    }
}

int bands_of(bands *out, const shaded *m, const kit_image *a, const kit_image *b, kit_error *err)
{
    const size_t all = (size_t)m->width * (size_t)m->height;
    float *const room = malloc((BANDS + 2) * all * sizeof *room), *l[BANDS + 1];
    if (!room) return kit_fail(err, "out of memory");
    levels_of(l, room, m, a->data, b->data);
    for (int k = 0; k < BANDS; ++k) out->rms[k] = sqrt(product_of(l[k], l[k + 1], l[k], l[k + 1], m));
    out->seen = sqrt(product_of(l[1], l[3], l[1], l[3], m));
    free(room);
    return 0;
}

static double signed_root(double square) { return square < 0 ? -sqrt(-square) : sqrt(square); }

int bands_off(bands *out, const shaded *m, const kit_image *a, const kit_image *pair, kit_error *err)
{
    const size_t all = (size_t)m->width * (size_t)m->height;
    float *const room = malloc(2 * (BANDS + 2) * all * sizeof *room), *l[2][BANDS + 1];
    if (!room) return kit_fail(err, "out of memory");
    for (size_t i = 0; i < 2; ++i) levels_of(l[i], room + i * (BANDS + 2) * all, m, a->data, pair->data + i * all);
    for (int k = 0; k < BANDS; ++k)
        out->rms[k] = signed_root(product_of(l[0][k], l[0][k + 1], l[1][k], l[1][k + 1], m));
    out->seen = signed_root(product_of(l[0][1], l[0][3], l[1][1], l[1][3], m));
    free(room);
    return 0;
}

double bands_mean(const double *rms, int count)
{
    double sum = 0;
    for (int i = 0; i < count; ++i) sum += rms[i] * fabs(rms[i]);
    return signed_root(sum / count);
}

int bands_noise(bands *out, const stage *s, kit_run *run, const shaded *m, const kit_image *picture, kit_error *err)
{
    kit_image other;
    run->frame.phase = 0.5f;
    kit_run_update(run);
    if (stage_settled(&other, s, run, SETTLED, 0, err)) return -1;
    const int failed = bands_of(out, m, &other, picture, err);
    kit_image_free(&other);
    for (int k = 0; k < BANDS && !failed; ++k) out->rms[k] /= sqrt(2);
    out->seen /= sqrt(2);
    return failed;
}
