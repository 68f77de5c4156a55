/* seeds.c - the chart of scenes by seed, which nobody picked. Each scene is a unit. Declared in chart.h. */
#include "lab/chart/chart.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/measure/ahead.h"
#include "lab/measure/csv.h"
#include "lab/measure/mottled.h"
#include "lab/measure/peers.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

enum { EACH = 3 * KIT_KINDS, MODELS = 7, SEEDS_QUICK = KIT_KINDS, DRAWN_FROM = 10000, DRAWN = 100000 };

/* One measurement of a scene: a set of rows; the first also has the peers'. smaller: divides the picture's width and
   height; stride: of the truth; error: the index of a lit row's error that counts, -1: it is of visibility. */
typedef struct part { const char *what, *rows; int smaller, stride, bounce, error; } part;
static const part parts[] = {
    { "visibility", "seeds",        1, SEED_STRIDE, 0, -1 },
    { "light",      "seeds-light",  1, SEED_STRIDE, 0, 1 },
    { "bounce",     "seeds-bounce", 1, SEED_STRIDE, 1, 2 },
    { "small",      "seeds-small",  4, 3,           0, -1 }
};
enum { PARTS = COUNT(parts) };

/* ---- >>scenes ---------------------------------------------------------------------------------------------------- */

/* A scene of the chart. set: tuned, asked, judged, drawn or models; kind: a word of kit_scene_kind, or models. */
typedef struct place { char name[64], path[128]; const char *set, *kind; int seed; } place;

static const char *drawn_by(const options *o) { return o->drawn ? o->drawn : ""; }

/* Returns the i-th seed drawn by the text's hash, so that nobody saw its scene before. All kinds get as many. */
static int drawn_seed(const options *o, int i)
{
    const uint64_t hash = kit_hash(kit_hash(KIT_HASH, drawn_by(o), strlen(drawn_by(o))), &i, sizeof i);
    return (DRAWN_FROM + (int)(hash % DRAWN)) * KIT_KINDS + i % KIT_KINDS;
}

static int model_of(place *p, int i)
{
    p->seed = i;
    p->kind = "models";
    snprintf(p->name, sizeof p->name, "models-%d", i);
    return stage_model(p->path, i);
}

/* Finds the k-th scene of the chart. Returns 0 if there is none. */
static int place_of(place *p, const options *o, int k)
{
    const int each = o->seeds ? o->seeds : o->quick ? SEEDS_QUICK : EACH;
    *p = (place){ .set = o->first < 0 ? "judged" : o->first < SEEDS_JUDGED ? "tuned" : "asked" };
    if (o->first >= 0) {
        p->seed = o->first + k;
        if (k >= each || (o->first < SEEDS_JUDGED && p->seed >= SEEDS_JUDGED)) return 0;
    } else {
        if (k >= (o->quick ? 1 : 2) * each) {
            p->set = "models";
            return !o->quick && k < 2 * each + MODELS && model_of(p, k - 2 * each);
        }
        if (k >= each) p->set = "drawn";
        p->seed = k < each ? SEEDS_JUDGED + k : drawn_seed(o, k - each);
    }
    p->kind = kit_scene_kind(p->seed % KIT_KINDS, NULL);
    snprintf(p->path, sizeof p->path, "random:%d", p->seed);
    snprintf(p->name, sizeof p->name, "%s-%d", p->kind, p->seed);
    return 1;
}

static int count_of(const options *o)
{
    place p;
    int k = 0;
    while (k < MOST_SEEDS && place_of(&p, o, k)) ++k;
    return k;
}

/* ---- >>measure: one scene ---------------------------------------------------------------------------------------- */

/* Opens a scene's stage. Returns 1; 0 if a package is missing, which is written to record unless that is NULL. */
static int seed_open(FILE *record, stage *s, const view *v, const part *of, kit_error *err)
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
    s->rays = SEED_RAYS;
    if (stage_look(s, v, SEED_WIDTH / of->smaller, SEED_HEIGHT / of->smaller, err)) return -1;
    s->stride = of->stride;
    return 1;
}

/* Shows a row's picture beside the truth. The page folds the pictures of all scenes of a kind together. */
static int show(FILE *record, const options *o, const place *p, const stage *s, const row *r, const kit_image *picture,
                kit_error *err)
{
    char slug[96], note[64];
    page_heading(record, 4, "%s", p->kind);
    snprintf(slug, sizeof slug, "seed-%s", p->name);
    snprintf(note, sizeof note, "error %.3f", r->share);
    if (pictures_thumb(record, o->out, slug, r->label, note, s, picture, err)) return -1;
    strcat(slug, "-truth");
    return pictures_thumb(record, o->out, slug, "ray-traced truth", p->name, s, &s->truth, err);
}

/* Measures the rows of ambient visibility, with the floor and the peers. The caller frees the truth. Returns how many
   rows; 0 = the scene is left out. */
static int visible_rows(FILE *record, const options *o, const place *p, row *rows, kit_image *truth, kit_error *err)
{
    const view v = { .name = p->name, .path = p->path };
    entry entries[MOST_ENTRIES];
    const int count = units_chosen(entries, parts->rows, o);
    kit_image picture[MOST_ENTRIES];
    int shown = 0;
    mottled m;
    stage s;
    const int there = seed_open(record, &s, &v, parts, err);
    if (there <= 0) return there;
    if (mottled_open(&m, &s, err) || stage_compare(&s, err)
        || measure_entries(rows, &s, entries, count, 0, 0, picture, err))
        return -1;
    for (int i = 0; i < count; ++i) {
        if (entries[i].quick && mottled_row(&rows[i], &m, &s, err)) return -1;
        if (!strcmp(entries[i].method, "hsao") && !*entries[i].settings) shown = i;
    }
    if (count && show(record, o, p, &s, &rows[shown], &picture[shown], err)) return -1;
    for (int i = 0; i < count; ++i) kit_image_free(&picture[i]);
    const int most = o->quick ? PEERS_QUICK : MOST_PEERS, behind = count + 1;     /* behind the floor's row */
    const int peers = o->method ? 0 : peers_measure(rows + behind, &s, 0, most, NULL, err);
    for (int i = 0; i < peers; ++i) rows[behind + i].of |= OF_PEER;
    mottled_close(&m);
    *truth = s.truth;
    memset(&s.truth, 0, sizeof s.truth);
    stage_close(&s);
    return peers < 0 ? -1 : behind + peers;
}

/* Measures the rows of a part in a small picture: light by the scene's environment, or its one bounce. Adds two rows:
   true visibility times light, and the truth's noise. */
static int part_rows(const options *o, const place *p, const part *of, row *rows, kit_image *visible, kit_error *err)
{
    const lit light = { .rays = SEED_RAYS, .exposure = 1, .bounce = of->bounce };
    const view v = { .name = p->name, .path = p->path, .lit = of->error < 0 ? NULL : &light };
    entry entries[MOST_ENTRIES];
    int count = units_chosen(entries, of->rows, o);
    stage s;
    if (!count) return 0;
    if (seed_open(NULL, &s, &v, of, err) <= 0) return -1;
    if (stage_compare(&s, err) || measure_entries(rows, &s, entries, count, 0, 0, NULL, err)) return -1;
    if (of->error < 0) {
        stage_close(&s);
        return count;
    }
    const double open = rows[count].error[of->error];               /* measure_entries put no occlusion's row there */
    if (!of->bounce
        && (stage_dim(visible, &s, err) || score_named(&rows[count++], &s, "true visibility", visible, err)))
        return -1;
    if (score_noise(&rows[count++], &s, "noise of the truth", err)) return -1;
    for (int i = 0; i < count; ++i) rows[i].share = open > 0 ? rows[i].error[of->error] / open : (double)NAN;
    stage_close(&s);
    return count;
}

static int unit(FILE *record, const options *o, int k, row *rows, kit_error *err)
{
    kit_image truth = { 0 };
    place p;
    entry entries[MOST_ENTRIES];
    int count = 0;
    for (int i = 0; i < PARTS && !rows; ++i) count += units_chosen(entries, parts[i].rows, o);
    if (!rows) return count > 0;
    place_of(&p, o, k);
    for (int i = 0; i < PARTS; ++i) {
        const int more = i ? part_rows(o, &p, &parts[i], rows + count, &truth, err)
                           : visible_rows(record, o, &p, rows, &truth, err);
        for (int j = 0; j < more; ++j) rows[count + j].scene = parts[i].what;
        count += more > 0 ? more : 0;
        if (more < 0 || (!i && !more)) {
            kit_image_free(&truth);
            return more;
        }
    }
    kit_image_free(&truth);
    return count;
}

/* ---- >>ahead ----------------------------------------------------------------------------------------------------- */

/* The options and rows of one process that seeds_ahead starts. unseen: a part of the page that is never shown. */
typedef struct ahead_of { const options *o; row *rows; page unseen; } ahead_of;

static int begin(void *of, kit_error *err)
{
    ahead_of *a = of;
    a->rows = calloc(MOST_SET_ROWS, sizeof *a->rows);
    if (!a->rows) return kit_fail(err, "out of memory");
    units_begin(a->o, count_of(a->o));
    return page_open(&a->unseen, err);
}

static int one(void *of, int k, kit_error *err)
{
    ahead_of *a = of;
    return units_measure(a->unseen.file, a->o, "seed", k, unit, a->rows, err);
}

int seeds_ahead(const options *o, kit_error *err)
{
    ahead_of of = { .o = o };
    const ahead a = { "scenes by seed", o->context, 0, count_of(o), begin, one, &of };
    return ahead_run(&a, err);
}

/* ---- >>csv ------------------------------------------------------------------------------------------------------- */

/* Returns the index of the best gain and exponent over all scenes; -1: the row is not a peer's. */
static int fit_of_all(const row *const *rows, int count, const row *like)
{
    int best = -1;
    double least = HUGE_VAL;
    for (int fit = 0; fit < FITS && like->of & OF_PEER; ++fit) {
        double sum = 0;
        for (int k = 0; k < count; ++k)
            if (rows[k]) sum += rows[k]->figure[FIT + fit];
        if (!(sum < least)) continue;
        least = sum;
        best = fit;
    }
    return best;
}

/* Writes a row's line. fit: the index of the fit over all scenes; -1: none. */
static void row_csv(FILE *f, const place *p, const row *r, int fit)
{
    const int is_lit = !(r->of & OF_AO), peer = (r->of & OF_PEER) != 0;
    fprintf(f, "%d,%s,%s,%s,\"%s\",\"%s\",\"%s\"", p->seed, p->set, p->kind, r->scene, r->label, r->method,
            r->settings);
    csv_figure(f, ",%.6g", r->share);
    csv_figure(f, ",%.6g", peer ? r->figure[FITTED] : (double)NAN);
    csv_figure(f, ",%.6g", fit < 0 ? (double)NAN : r->figure[FIT + fit]);
    csv_figure(f, ",%.6g", is_lit ? r->bias[strcmp(r->scene, "bounce") ? 1 : 2] : r->score.bias);
    for (int k = 0; k < NOISE_BANDS; ++k) csv_figure(f, ",%.6g", r->figure[NOISE_BAND + k]);
    for (int k = 0; k < NOISE_BANDS; ++k) csv_figure(f, ",%.6g", r->figure[ERROR_BAND + k]);
    fputc('\n', f);
}

static int same(const row *a, const row *b)
{
    return !strcmp(a->scene, b->scene) && !strcmp(a->label, b->label) && !strcmp(a->method, b->method)
        && !strcmp(a->settings, b->settings);
}

/* Finds the row of each scene that is like the given one, or NULL. */
static void alike(const row **out, const found *all, int count, const row *like)
{
    for (int k = 0; k < count; ++k) {
        out[k] = NULL;
        for (int i = 0; all[k].row && i < all[k].count && !out[k]; ++i)
            if (same(&all[k].row[i], like)) out[k] = &all[k].row[i];
    }
}

/* Writes the csv: one setting of the scene with the most rows after the other, each on all scenes. */
static void write_csv(FILE *f, const options *o, const found *all, int count)
{
    int first = 0;
    for (int k = 1; k < count; ++k)
        if (all[k].count > all[first].count) first = k;
    fputs("seed,set,kind,what,label,method,settings,share,fitted,fitted_all,bias,noise_1,noise_3,noise_8,noise_20,"
          "error_1,error_3,error_8,error_20\n",
          f);
    for (int i = 0; i < all[first].count; ++i) {
        const row *rows[MOST_SEEDS], *like = &all[first].row[i];
        alike(rows, all, count, like);
        const int fit = fit_of_all(rows, count, like);
        for (int k = 0; k < count; ++k) {
            place p;
            place_of(&p, o, k);
            if (rows[k]) row_csv(f, &p, rows[k], fit);
        }
    }
}

/* ---- >>section --------------------------------------------------------------------------------------------------- */

static void head(FILE *record, const options *o)
{
    page_paragraph(record,
                   "%d scenes, none of them picked by hand: kind, things, camera, radius, units and light are drawn "
                   "from a seed. Judged: seeds from %d on, on which nothing is tuned. Drawn: seeds by the hash of "
                   "code %s. Models: of packages, seen as a seed says. %d x %d pixels, the truth %d rays at every "
                   "%dth pixel both ways. Shares: RMSE over that of no occlusion, so a pass above 1 is worse than "
                   "none. Noise: thousandths of visibility, between two phases, where a smooth surface is in shade.",
                   count_of(o), SEEDS_JUDGED, *drawn_by(o) ? drawn_by(o) : "(none)", SEED_WIDTH / stage_thrift,
                   SEED_HEIGHT / stage_thrift, SEED_RAYS / (stage_thrift * stage_thrift), SEED_STRIDE);
    if (*peers_missing()) page_paragraph(record, "%s", peers_missing());
}

const section seeds_chart = { .name = "seed", .csv = "seeds.csv", .kind = "seeds", .title = "Scenes by seed",
                              .units = count_of, .unit = unit, .head = head, .write = write_csv };
