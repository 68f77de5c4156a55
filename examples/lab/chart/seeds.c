/* seeds.c - what report.c shows of scenes drawn from seeds: each is measured as a unit of its own. Declared in
   seeds.h. */
#include "lab/chart/seeds.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/chart/ao.h"
#include "lab/chart/pairs.h"
#include "lab/chart/seeds_show.h"
#include "lab/measure/ahead.h"
#include "lab/measure/measure.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"

/* Truth at every third pixel both ways. */
enum { SEED_WIDTH = 320, SEED_HEIGHT = 180, SEED_RAYS = 256, SEED_LIGHT_RAYS = 256, SEED_NOISY_RAYS = 1024,
    SEEDS = 100, SEEDS_QUICK = 21 };
static const lit seed_light = { NULL, { NULL }, 0, 0, 0, SEED_LIGHT_RAYS, 1, NO_CROPS };

static int first_of(const options *o) { return o->first < 0 ? SEEDS_JUDGED : o->first; }

/* Those to tune on end where those that report begin. */
static int count_of(const options *o)
{
    const int first = first_of(o), count = o->seeds ? o->seeds : o->quick ? SEEDS_QUICK : SEEDS;
    return first < SEEDS_JUDGED && first + count > SEEDS_JUDGED ? SEEDS_JUDGED - first : count;
}

/* ---- >>picture: the scene as its own light shows it -------------------------------------------------------------- */

/* What is seen where there is no surface: the environment. */
static void fill_sky(kit_image *picture, const stage *s)
{
    const size_t pixels = (size_t)picture->width * (size_t)picture->height;
    const float *z = kit_image_channel(&s->frame, "Z");
    for (size_t i = 0; i < pixels; ++i) {
        float origin[3], direction[3], rgb[3];
        if (z[i] > 0) continue;
        kit_camera_ray(&s->gbuffer.camera, (int)(i % (size_t)picture->width), (int)(i / (size_t)picture->width), origin,
                       direction);
        kit_env_radiance(&s->lighting.env, direction, rgb);
        for (size_t c = 0; c < 3; ++c) picture->data[c * pixels + i] = rgb[c];
    }
}

/* Radiance (channels R, G, B first) as a picture of [0, 1): three of four pixels lie below a middle grey's double. */
static int tone_map(kit_image *picture, kit_error *err)
{
    const size_t pixels = (size_t)picture->width * (size_t)picture->height;
    float *bright = malloc(pixels * sizeof *bright);
    if (!bright) return kit_fail(err, "out of memory");
    for (size_t i = 0; i < pixels; ++i)
        bright[i] = fmaxf(picture->data[i], fmaxf(picture->data[pixels + i], picture->data[2 * pixels + i]));
    kit_middle(bright, pixels);                      /* sorts them */
    const float by = -0.6f / fmaxf(bright[pixels * 3 / 4], 1e-6f);
    for (size_t i = 0; i < 3 * pixels; ++i) picture->data[i] = 1 - expf(by * picture->data[i]);
    free(bright);
    return 0;
}

/* out/BASE-SEED.png, by the scene's environment and lights; the stage's light is none again after that. */
static int own_picture(FILE *record, stage *s, const char *out, const char *slug, const char *note, kit_error *err)
{
    kit_image picture;
    if (kit_light_scene(&s->lighting, &s->scene, err) || stage_drawn(&picture, s, "ssdo-best", "", s->radius, err))
        return -1;
    fill_sky(&picture, s);
    if (tone_map(&picture, err) || pictures_save(&picture, "R,G,B", 1, out, slug, ".png", err)) return -1;
    page_figure(record, slug, "by its own light", note, picture.width, picture.height, 0);
    kit_image_free(&picture);
    kit_image_free(&s->lighting.env);
    memset(&s->lighting, 0, sizeof s->lighting);
    return 0;
}

/* ---- >>measure: one scene ---------------------------------------------------------------------------------------- */

/* A seed's stage: quick charts have as large pictures, but fewer rays. 1; 0 = a package that it needs is not there, as
   record (NULL: nobody) is told. */
static int seed_open(FILE *record, stage *s, const view *v, kit_error *err)
{
    kit_error why = { "" };
    if (stage_load(s, v, &why)) {
        if (strstr(why.text, "is missing; install")) {
            fprintf(stderr, "report: note: left out, %s\n", why.text);
            if (record) page_paragraph(record, "Left out, %s.", why.text);
            return 0;
        }
        return kit_fail(err, "%s", why.text);
    }
    if (stage_look(s, v, SEED_WIDTH * stage_thrift, SEED_HEIGHT * stage_thrift, err)) return -1;
    s->stride = SEED_STRIDE;
    return 1;
}

/* The truth and hsao's picture, beside the scene's. */
static int small_pictures(FILE *record, const stage *s, const char *out, const char *slug, const row *rows,
                          const kit_image *pictures, int count, kit_error *err)
{
    char name[64], note[64];
    snprintf(name, sizeof name, "%s-truth", slug);
    if (pictures_thumb(record, out, name, "true visibility", "", s, &s->truth, err)) return -1;
    for (int i = 0; i < count; ++i) {
        if (strcmp(rows[i].method, "hsao") || *rows[i].settings) continue;
        snprintf(name, sizeof name, "%s-hsao", slug);
        snprintf(note, sizeof note, "error %.3f", rows[i].share);
        if (pictures_thumb(record, out, name, "hsao", note, s, &pictures[i], err)) return -1;
    }
    return 0;
}

/* Ambient visibility's rows, then the floor; its truth, for the caller to free. How many; 0 = the scene is left out. */
static int visible_rows(FILE *record, const options *o, const view *v, row *rows, kit_image *truth, kit_error *err)
{
    entry entries[MOST_ENTRIES];
    kit_image pictures[MOST_ENTRIES];
    const int count = ao_chosen(entries, o);
    char slug[32], note[128];
    stage s;
    const int there = seed_open(record, &s, v, err);
    if (there <= 0) return there;
    snprintf(slug, sizeof slug, "%s", v->name);
    snprintf(note, sizeof note, "%zu triangles, %d lights, %s", s.scene.mesh.triangles, s.scene.lights, s.scene.env);
    page_heading(record, 4, "%s", v->name);
    if (own_picture(record, &s, o->out, slug, note, err) || stage_compare(&s, err)
        || measure_entries(rows, &s, entries, count, 0, 0, pictures, err)
        || small_pictures(record, &s, o->out, slug, rows, pictures, count, err))
        return -1;
    for (int i = 0; i < count; ++i) kit_image_free(&pictures[i]);
    *truth = s.truth;
    memset(&s.truth, 0, sizeof s.truth);
    stage_close(&s);
    return count + 1;                                /* without no AO's row, whose share is 1 */
}

/* The truth's, so that its noise stays below a tenth of what methods err by: in some environments small bright parts
   bring much of the light. */
static int rays_for(const char *env)
{
    return !strcmp(env, "windows") || !strcmp(env, "probe") ? SEED_NOISY_RAYS : SEED_LIGHT_RAYS;
}

/* Light's rows by the scene's environment, then those of the true visibility (visible) and of the truth's noise. */
static int light_rows(const options *o, const view *v, row *rows, kit_image *visible, kit_error *err)
{
    entry entries[MOST_ENTRIES];
    const int count = pairs_chosen(entries, o);
    stage s;
    if (!count) return 0;
    if (seed_open(NULL, &s, v, err) <= 0) return -1;
    s.rays = rays_for(s.scene.env);                  /* a quick chart's, too: noise is not to be scored */
    if (stage_compare(&s, err) || measure_entries(rows, &s, entries, count, 0, 0, NULL, err)) return -1;
    const double open = rows[count].error[1];        /* measure left no occlusion's row there */
    if (stage_dim(visible, &s, err) || score_named(&rows[count], &s, PAIRS_SCALAR, visible, err)
        || score_noise(&rows[count + 1], &s, PAIRS_NOISE, err))
        return -1;
    for (int i = 0; i < count + 2; ++i) rows[i].share = open > 0 ? rows[i].error[1] / open : (double)NAN;
    stage_close(&s);
    return count + 2;
}

static int seed_unit(FILE *record, const options *o, int seed, row *rows, kit_error *err)
{
    char path[32], name[32], lit_name[48];
    kit_image truth = { 0 };
    if (!rows) return 1;
    snprintf(path, sizeof path, "random:%d", seed);
    seeds_name(name, seed);
    snprintf(lit_name, sizeof lit_name, "%s-light", name);
    const view v = { .name = name, .path = path }, in_light = { .name = lit_name, .path = path, .lit = &seed_light };
    const int visible = visible_rows(record, o, &v, rows, &truth, err);
    const int light = visible > 0 ? light_rows(o, &in_light, rows + visible, &truth, err) : 0;
    kit_image_free(&truth);
    if (visible <= 0 || light < 0) return visible < 0 || light < 0 ? -1 : 0;
    for (int i = 0; i < visible + light; ++i) rows[i].scene = "";
    return visible + light;
}

int seeds_units(const options *o)
{
    entry entries[MOST_ENTRIES];
    return ao_chosen(entries, o) || pairs_chosen(entries, o) ? count_of(o) : 0;
}

/* ---- >>ahead ----------------------------------------------------------------------------------------------------- */

/* What a process measures goes into the units that are kept. */
typedef struct ahead_of { const options *o; row *rows; page unseen; } ahead_of;

static int begin(void *of, kit_error *err)
{
    ahead_of *a = of;
    if (a->o->quick) stage_thrift = QUICK_THRIFT;
    a->rows = calloc(MOST_SEED_ROWS, sizeof *a->rows);
    if (!a->rows) return kit_fail(err, "out of memory");
    units_begin(a->o, count_of(a->o));
    return page_open(&a->unseen, err);
}

static int one(void *of, int seed, kit_error *err)
{
    ahead_of *a = of;
    return units_measure(a->unseen.file, a->o, "seed", seed, seed_unit, a->rows, err);
}

int seeds_ahead(const options *o, kit_error *err)
{
    ahead_of of = { .o = o };
    const ahead a = { "scenes by seed", o->context, first_of(o), count_of(o), begin, one, &of };
    return ahead_run(&a, err);
}

/* ---- >>section --------------------------------------------------------------------------------------------------- */

static seeds all;

/* A scene's rows, kept for the tables; those before it were of as many. */
static int take(int k, const row *rows, int count, kit_error *err)
{
    row *own = malloc((size_t)count * sizeof *own);
    if (!own) return kit_fail(err, "out of memory");
    memcpy(own, rows, (size_t)count * sizeof *own);
    free((void *)all.row[k]);
    all.rows = count;
    all.row[k] = own;
    return 0;
}

/* The seeds' rows; each scene's pictures. */
static int measure_all(FILE *record, const options *o, kit_error *err)
{
    row *rows = calloc(MOST_SEED_ROWS, sizeof *rows);
    int failed = rows ? 0 : kit_fail(err, "out of memory");
    for (int k = 0; k < MOST_SEEDS; ++k) free((void *)all.row[k]);
    all = (seeds){ .base = first_of(o) < SEEDS_JUDGED ? "seeds-fit" : "seeds", .first = first_of(o),
                   .count = count_of(o) };
    for (int k = 0; k < all.count && !failed; ++k) {
        const int seed = all.first + k, count = units_measure(record, o, "seed", seed, seed_unit, rows, err);
        failed = count < 0 || (count && take(k, rows, count, err));
    }
    free(rows);
    return failed ? -1 : 0;
}

int seeds_chart(FILE *record, const options *o, kit_error *err)
{
    char name[64];
    page csv, pictures;
    if (page_open(&pictures, err) || measure_all(pictures.file, o, err) || page_open(&csv, err)) return -1;
    seeds_csv(csv.file, &all);
    snprintf(name, sizeof name, "%s.csv", all.base);
    page_heading(record, 2, "Scenes by seed");
    page_paragraph(record,
                   "Seeds %d to %d, none of them picked by hand: kind, things, camera, radius, units and light are "
                   "drawn from the seed. %s Shares: RMSE over that of no occlusion, so a pass above 1 is worse than "
                   "none.",
                   all.first, all.first + all.count - 1,
                   all.first < SEEDS_JUDGED
                       ? "Seeds below 1000 may be looked at while settings are tuned."
                       : "Seeds from 1000 on only report: settings are tuned on those below 1000.");
    if (page_csv(record, "seeds", &csv, o->out, name, err)) return -1;
    page_into(&pictures, record);
    return 0;
}

void seeds_text(FILE *f) { seeds_table_text(f, &all); }
