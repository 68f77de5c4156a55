/* try.c - measures settings on scenes by seed, for tuning: --help says how. The truth is at every eleventh pixel both
   ways, and kept in build/cache. One process a core. Noise and error in bands are of visibility on smooth surfaces in
   shade (lab/measure/bands.h), in thousandths. The bands go to 1.2, 3, 8 and 20 pixels. Noise is the difference of two
   phases; of light it is the difference to the same settings with 32 slices, over the mean light. The error is that
   against two truths at every pixel, without their noise. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include "lab/measure/ahead.h"
#include "lab/measure/folder.h"
#include "lab/measure/mottled.h"
#include "lab/measure/score.h"
#include "lab/measure/spread.h"

enum { MOST_TRIED = 64, MOST_SEEDS = 1000 };
enum { ERROR, NOISE, OFF = NOISE + BANDS, MEASURED = OFF + BANDS };

typedef struct trial {
    int from, count, light, bounce, entries, quick;
    double radius; /* times the scene's own */
    const char *out, *other, *judge;
    request entry[MOST_TRIED];
    double (*seed)[2 * MOST_TRIED][MEASURED]; /* figures by seed, shared by processes; NAN: not measured */
} trial;

/* ---- >>measuring ------------------------------------------------------------------------------------------------- */

/* Returns the error of a picture of visibility, of irradiance or of one bounce. */
static double error_of(const stage *s, const kit_image *picture, kit_error *err)
{
    row r = row_blank(0, s->name, "", "", "");
    if (score_picture(&r, s, picture, err)) return (double)NAN;
    return s->lit ? r.error[s->lit->bounce ? 2 : 1] : r.score.rmse;
}

/* Makes a picture of one channel of irradiance or its bounce, divided by its mean. */
static int grey_of(kit_image *out, const stage *s, const kit_image *light, kit_error *err)
{
    const size_t pixels = (size_t)light->width * (size_t)light->height;
    const float *c[3];
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
        char name[16];
        snprintf(name, sizeof name, "%s.%c", s->lit->bounce ? "bounce" : "irradiance", "RGB"[k]);
        c[k] = kit_image_channel(light, name);
    }
    if (kit_image_new(out, light->width, light->height, "Y", err)) return -1;
    for (size_t i = 0; i < pixels; ++i) sum += (double)(out->data[i] = (c[0][i] + c[1][i] + c[2][i]) / 3);
    for (size_t i = 0; i < pixels; ++i) out->data[i] *= (float)((double)pixels / sum);
    return 0;
}

/* Measures the noise of light by slices; other methods cannot have more of them, and are left out. */
static int noise_of_light(bands *out, stage *s, const request *e, const shaded *m, const kit_image *picture,
                          kit_error *err)
{
    char set[320];
    kit_image more, grey[2];
    kit_method method;
    *out = bands_unknown;
    snprintf(set, sizeof set, "%s%sslices=32", e->settings, *e->settings ? "," : "");
    if (kit_method_find(&method, e->method, err) || kit_method_set(&method, set, NULL)) return 0;
    if (stage_drawn(&more, s, e->method, set, s->radius, err)) return -1;
    const int failed = grey_of(&grey[0], s, picture, err) || grey_of(&grey[1], s, &more, err)
                    || bands_of(out, m, &grey[0], &grey[1], err);
    for (int k = 0; k < 2 && !failed; ++k) kit_image_free(&grey[k]);
    kit_image_free(&more);
    return failed ? -1 : 0;
}

/* Draws one setting and measures its figures. */
static int measure_entry(double figure[MEASURED], stage *s, const request *e, const mottled *m, double nothing,
                         kit_error *err)
{
    bands noise = bands_unknown, off = bands_unknown;
    kit_image picture;
    kit_run run;
    if (stage_run(&run, s, e->method, e->settings, s->radius, err) || stage_settled(&picture, s, &run, 0, 0, err))
        return -1;
    const int failed = !s->lit            ? mottled_bands(&noise, &off, m, s, &run, &picture, err)
                       : m->smooth.pixels ? noise_of_light(&noise, s, e, &m->smooth, &picture, err)
                                          : 0;
    figure[ERROR] = error_of(s, &picture, err) / nothing;
    for (int k = 0; k < BANDS; ++k) {
        figure[NOISE + k] = noise.rms[k];
        figure[OFF + k] = off.rms[k];
    }
    kit_image_free(&picture);
    kit_run_close(&run);
    return failed ? -1 : 0;
}

static int measure_seed(const trial *t, int k, kit_error *err)
{
    char name[32];
    stage s;
    mottled m = { .pair = { .data = NULL } };
    const lit of_light = { .rays = SEED_RAYS, .exposure = 1, .bounce = t->bounce };
    view v = { .name = name, .path = name, .lit = t->light ? &of_light : NULL };
    snprintf(name, sizeof name, "random:%d", t->from + k);
    if (stage_load(&s, &v, err)) return -1;
    v.radius = (float)t->radius * s.scene.radius;
    if (stage_look(&s, &v, SEED_WIDTH, SEED_HEIGHT, err)) return -1;
    if (!t->quick && mottled_open(&m, &s, err)) return -1;
    s.stride = SEED_STRIDE;
    s.rays = SEED_RAYS;
    if (stage_compare(&s, err)) return -1;
    const double nothing = error_of(&s, &s.given[s.givens - 1].picture, err);
    int failed = 0;
    for (int i = 0; i < t->entries && !failed; ++i)
        failed = measure_entry(t->seed[k][i], &s, &t->entry[i], &m, nothing, err);
    mottled_close(&m);
    stage_close(&s);
    return failed;
}

static int measure_one(void *of, int seed, kit_error *err)
{
    trial *t = of;
    return measure_seed(t, seed - t->from, err);
}

/* Measures seeds in one process a core. Those that failed there are measured again here, and err says why. */
static int measure_all(trial *t, kit_error *err)
{
    const ahead a = { "seeds", NULL, t->from, t->count, NULL, measure_one, t };
    for (int k = 0; k < t->count; ++k)
        for (int i = 0; i < MOST_TRIED; ++i) t->seed[k][i][ERROR] = (double)NAN;
    if (ahead_run(&a, err) || kit_gl_open(NULL, err)) return -1;
    for (int k = 0; k < t->count; ++k)
        if (isnan(t->seed[k][t->entries - 1][ERROR]) && measure_seed(t, k, err)) return -1;
    kit_gl_close();
    return 0;
}

/* ---- >>results --------------------------------------------------------------------------------------------------- */

/* Returns statistics of column i's errors, less column from's (unless below 0), by kind of seeds (below 0: all). */
static spread errors_of(const trial *t, int i, int from, int kind)
{
    double value[MOST_SEEDS];
    for (int k = 0; k < t->count; ++k) {
        value[k] = t->seed[k][i][ERROR] - (from < 0 ? 0 : t->seed[k][from][ERROR]);
        if (kind >= 0 && (t->from + k) % KIT_KINDS != kind) value[k] = (double)NAN;
    }
    return spread_of(value, t->count);
}

/* Prints noise or error in bands, in thousandths, over scenes that have it, and the difference to column from's. */
static void print_bands(const trial *t, int i, int from, int first, const char *what)
{
    static double own[MOST_SEEDS], other[MOST_SEEDS];
    printf("%-14s %s", "", what);
    for (int b = first; b < first + BANDS; ++b) {
        int n = 0;
        for (int k = 0; k < t->count; ++k) {
            own[n] = t->seed[k][i][b];
            other[n] = t->seed[k][from][b];
            n += !isnan(own[n]) && !isnan(other[n]);
        }
        if (n) printf(" %6.2f %+5.2f", 1e3 * bands_mean(own, n), 1e3 * (bands_mean(own, n) - bands_mean(other, n)));
    }
    puts("");
}

static void print_row(const trial *t, int i, int from)
{
    const request *e = &t->entry[i % MOST_TRIED];
    const spread own = errors_of(t, i, -1, -1), off = errors_of(t, i, from, -1);
    int better = 0;
    for (int k = 0; k < t->count; ++k) better += t->seed[k][i][ERROR] < t->seed[k][from][ERROR];
    printf("%-14s %-34s %6.4f +- %.4f  worst %.3f (%d)  %+.4f +- %.4f, better on %d\n", e->method, e->settings,
           own.mean, own.half, own.most, t->from + own.worst, off.mean, off.half, better);
    if (!t->quick) print_bands(t, i, from, NOISE, "noise:");
    if (!t->quick && !t->light) print_bands(t, i, from, OFF, "error:");
    printf("%-14s by kind:", "");
    for (int kind = 0; kind < KIT_KINDS; ++kind) {
        const spread of = errors_of(t, i, -1, kind);
        if (of.count)
            printf(" %s %.3f %+.3f", kit_scene_kind(kind, NULL), of.mean, errors_of(t, i, from, kind).mean);
    }
    puts("");
}

static int write_csv(const trial *t, kit_error *err)
{
    FILE *f = fopen(t->out, "w");
    if (!f) return kit_fail(err, "%s: cannot be written", t->out);
    for (int k = 0; k < t->count; ++k) {
        fprintf(f, "%d", t->from + k);
        for (int i = 0; i < t->entries; ++i)
            for (int n = 0; n < MEASURED; ++n) fprintf(f, ",%.6f", t->seed[k][i][n]);
        fputs("\n", f);
    }
    return fclose(f) ? kit_fail(err, "%s: cannot be written", t->out) : 0;
}

/* Reads the figures that another build's --out wrote into the columns from MOST_TRIED on. */
static int read_other(trial *t, kit_error *err)
{
    FILE *f = fopen(t->other, "r");
    int seed, bad = !f;
    for (int k = 0; k < t->count && !bad; ++k) {
        bad = fscanf(f, "%d", &seed) != 1 || seed != t->from + k;
        for (int i = 0; i < t->entries && !bad; ++i)
            for (int n = 0; n < MEASURED && !bad; ++n) bad = fscanf(f, ",%lf", &t->seed[k][MOST_TRIED + i][n]) != 1;
    }
    if (f) fclose(f);
    return bad ? kit_fail(err, "--against %s: was not written by try for these seeds and settings", t->other) : 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static const char usage[] = "try [options] METHOD[:KEY=VALUE,..] ..";
#define TO(member) .at = offsetof(trial, member)
static const kit_option options[] = {
    { .about = "Tries settings on scenes by seed. For each it prints the relative error, the noise, and the "
               "difference from the first settings, scene by scene. Images are 1280x720." },
    { "METHOD[:KEY=VALUE,..]", NULL, "A method and its settings, as build/render takes them: hsao:samples=12.",
      .kind = KIT_TOLD },
    { "--from", "SEED", "The first seed [0].", .kind = KIT_WHOLE, TO(from), .most = 999999 },
    { "--count", "N", "The number of scenes, at least 2 [28].",
      .kind = KIT_WHOLE, TO(count), .least = 2, .most = MOST_SEEDS },
    { "--light", NULL, "Measures irradiance under the scenes' own environments, without a bounce. Noise of this and "
                       "of --bounce is that to 32 slices, over the mean.", .kind = KIT_FLAG, TO(light) },
    { "--bounce", NULL, "Measures one bounce alone.", .kind = KIT_FLAG, TO(bounce) },
    { "--radius", "F", "Multiplies the radius of each scene by F [1].",
      .kind = KIT_NUMBER, TO(radius), .least = 1e-6, .most = 1e6 },
    { "--quick", NULL, "Measures the error alone, not the noise.", .kind = KIT_FLAG, TO(quick) },
    { "--judge", "yes", "Allows seeds from 1000 on. The charts report on these, so that nothing may be tuned on "
                        "them.", .kind = KIT_TEXT, TO(judge) },
    { "--against", "F.csv", "Compares with the file that another build wrote for the same settings in the same "
                            "order, for example in another work tree.", .kind = KIT_TEXT, TO(other) },
    { "--out", "F.csv", "The file to write [build/try.csv]: the seed, then for each of the settings the error, four "
                        "bands of noise and four of error. nan is not measured. examples/lab/ranks.py compares the "
                        "ranks of two such files.", .kind = KIT_TEXT, TO(out) },
    { NULL }
};

static int add_entry(void *to, const char *text, kit_error *err)
{
    trial *const t = to;
    kit_method m;
    if (t->entries == MOST_TRIED) return kit_fail(err, "%s: at most %d settings", text, MOST_TRIED);
    return request_read(&t->entry[t->entries++], &m, text, err);
}

static int parse(trial *t, int argc, char **argv, kit_error *err)
{
    *t = (trial){ .count = 28, .radius = 1, .out = "build/try.csv" };
    if (kit_options(t, options, argc, argv, add_entry, err)) return -1;
    t->light |= t->bounce;
    if (!(t->judge && !strcmp(t->judge, "yes")) && t->from + t->count > SEEDS_JUDGED)
        return kit_fail(err, "--from, --count: seeds from %d on need --judge yes, for nobody tunes on them",
                        SEEDS_JUDGED);
    return t->entries ? 0 : kit_fail(err, "a method is missing: %s (--help explains it)", usage);
}

int main(int argc, char **argv)
{
    static trial t;
    kit_error err = { "" };
    if (kit_help(argc, argv, usage, options)) return 0;
    int failed = parse(&t, argc, argv, &err);
    if (!failed) {
        t.seed = mmap(NULL, MOST_SEEDS * sizeof *t.seed, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
        if (t.seed == MAP_FAILED || folder_make(FOLDER_CACHE, &err)) failed = kit_fail(&err, "out of memory");
    }
    if (!failed) failed = measure_all(&t, &err) || write_csv(&t, &err) || (t.other && read_other(&t, &err));
    if (failed) {
        fprintf(stderr, "try: %s\n", err.text);
        return 2;
    }
    for (int i = 0; i < t.entries; ++i) print_row(&t, i, t.other ? MOST_TRIED + i : 0);
    return 0;
}
