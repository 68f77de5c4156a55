/* quiet.c - how much noise the eye sees in an image of ambient visibility, in bands of frequency. --help lists the
   options. Differences are those on smooth surfaces in shade (bands.h). The difference to more slices is known for
   slices alone (hsao and its presets). Ray tracing has a row of its own, the error of half of its rays, which is no
   smaller than its noise. The charts' milliseconds are measured if a GPU draws, else modelled for entries that make
   cost names, as a CPU's time says little about a GPU. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include "lab/measure/csv.h"
#include "lab/measure/folder.h"
#include "lab/measure/measure.h"
#include "lab/measure/peers.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"
#include "lab/measure/bands.h"

#define DEVICE  "RX 6800"
enum { MOST_QUIET = 48, GPU_ROUNDS = 25, MOST_LINES = MOST_QUIET + PEERS_QUICK + 1, CONVERGED = 32 };
enum { NOISE, TRUTH, KINDS };

/* A measured entry. ms: on the GPU that draws, or modelled for DEVICE at 1920x1080; NAN: not known. */
typedef struct line { request entry; char label[336]; double ms; bands of[KINDS]; } line;

typedef struct quiet {
    const char *scene, *pictures, *out, *context;
    int         size[2], rays, lines, peers;           /* lines: entries, then peers, then the truth */
    double      radius;                                /* 0: the scene's own */
    line        line[MOST_LINES];
    stage       stage;
    shaded      shaded;
} quiet;

/* ---- >>measuring ------------------------------------------------------------------------------------------------- */

static int draw(kit_image *out, quiet *q, const char *method, const char *settings, kit_error *err)
{
    kit_run run;
    if (stage_run(&run, &q->stage, method, settings, q->stage.radius, err)) return -1;
    const int failed = stage_settled(out, &q->stage, &run, 0, 0, err);
    kit_run_close(&run);
    return failed;
}

/* Fills in line i: a picture's difference to each reference (NULL: not known). Saves the picture if that is asked. */
static int compare(quiet *q, int i, const kit_image *picture, const kit_image *const reference[KINDS], kit_error *err)
{
    line *l = &q->line[i];
    char slug[64], name[80];
    for (int k = 0; k < KINDS; ++k) {
        l->of[k] = bands_unknown;
        if (reference[k] && bands_of(&l->of[k], &q->shaded, picture, reference[k], err)) return -1;
    }
    if (!q->pictures) return 0;
    pictures_slug(slug, l->label);
    snprintf(name, sizeof name, "%02d-%s", i, slug);
    return pictures_save(picture, "Y", 0, q->pictures, name, ".png", err);
}

static int measure_entry(quiet *q, int i, kit_error *err)
{
    const request *e = &q->line[i].entry;
    const kit_image *reference[KINDS] = { NULL, &q->stage.truth };
    kit_image picture = { .data = NULL }, converged = { .data = NULL };
    char text[320];
    kit_method m;
    if (kit_method_find(&m, e->method, err) || draw(&picture, q, e->method, e->settings, err)) return -1;
    if (m.pass == SSGI_GL_PASS_HSAO && !m.set.normal_rays) {        /* it gathers by slices */
        snprintf(text, sizeof text, "%s%sslices=%d", e->settings, *e->settings ? "," : "", CONVERGED);
        if (draw(&converged, q, e->method, text, err)) return -1;
        reference[NOISE] = &converged;
    }
    const int failed = compare(q, i, &picture, reference, err);
    kit_image_free(&picture);
    kit_image_free(&converged);
    return failed;
}

/* Measures other libraries' effects as lines. Returns how many there are; -1 = failed. */
static int measure_peers(quiet *q, kit_error *err)
{
    const kit_image *const reference[KINDS] = { NULL, &q->stage.truth };
    kit_image picture[PEERS_QUICK];
    row rows[PEERS_QUICK];
    const int count = peers_measure(rows, &q->stage, kit_gl_is_software() ? 0 : GPU_ROUNDS, PEERS_QUICK, picture, err);
    for (int i = 0; i < count; ++i) {
        line *l = &q->line[q->lines];
        *l = (line){ .ms = kit_gl_is_software() ? (double)NAN : rows[i].ms };
        snprintf(l->entry.method, sizeof l->entry.method, "%s", rows[i].label);
        snprintf(l->entry.settings, sizeof l->entry.settings, "%s", rows[i].settings);
        snprintf(l->label, sizeof l->label, "%s", rows[i].label);
        if (compare(q, q->lines++, &picture[i], reference, err)) return -1;
        kit_image_free(&picture[i]);
    }
    return count;
}

/* Measures the truth's noise, by the truth of half of its rays. The rays are a sequence whose first half is evenly
   spread, too. For independent rays the half differs from the whole by the whole's own error; for these by more. */
static int measure_grain(quiet *q, kit_error *err)
{
    stage half = q->stage;
    line *l = &q->line[q->lines];
    *l = (line){ .entry = { .method = "truth" }, .label = "truth", .ms = (double)NAN };
    snprintf(l->entry.settings, sizeof l->entry.settings, "rays=%d", q->rays);
    half.rays = q->rays / 2;
    memset(&half.truth, 0, sizeof half.truth);
    if (stage_truth(&half, err)) return -1;
    const kit_image *const reference[KINDS] = { NULL, &half.truth };
    const int failed = compare(q, q->lines++, &q->stage.truth, reference, err);
    kit_image_free(&half.truth);
    return failed;
}

/* ---- >>milliseconds ---------------------------------------------------------------------------------------------- */

/* Returns the modelled milliseconds of an entry's chain by make cost: weighed, at 1920x1080; NAN: not known. */
static double ms_of(const line *l, const csv *costs)
{
    char name[336];
    snprintf(name, sizeof name, "%s%s%s", l->entry.method, *l->entry.settings ? "," : "", l->entry.settings);
    for (int i = 0; i < costs->rows; ++i)
        if (!strcasecmp(csv_text(costs, i, "chain"), name) && !*csv_text(costs, i, "pass"))
            return csv_number(costs, i, DEVICE " weighed");
    return (double)NAN;
}

static void take_modelled(quiet *q)
{
    const csv costs = csv_read("report", "cost.csv");
    if (!costs.rows) fputs("quiet: note: no report/cost.csv (make cost): no milliseconds, no charts\n", stderr);
    for (int i = 0; i < q->lines; ++i) q->line[i].ms = ms_of(&q->line[i], &costs);
}

static int measure_ms(quiet *q, kit_error *err)
{
    entry entries[MOST_QUIET];
    row rows[MOST_QUIET];
    for (int i = 0; i < q->lines; ++i)
        entries[i] = (entry){ q->line[i].label, q->line[i].entry.method, q->line[i].entry.settings, 1 };
    if (measure_times(rows, &q->stage, entries, q->lines, GPU_ROUNDS, err)) return -1;
    for (int i = 0; i < q->lines; ++i) q->line[i].ms = rows[i].ms;
    return 0;
}

/* ---- >>results --------------------------------------------------------------------------------------------------- */

#define OF_KIND(kind) kind "_1," kind "_3," kind "_8," kind "_20," kind "_seen"
#define FIGURES_OF "ms," OF_KIND("noise") "," OF_KIND("truth")

static void put_csv(FILE *f, const quiet *q)
{
    fputs("scene,width,height,radius,rays,pixels,method,settings," FIGURES_OF, f);
    for (int i = 0; i < q->lines; ++i) {
        const line *l = &q->line[i];
        fprintf(f, "\n\"%s\",%d,%d,%g,%d,%zu,\"%s\",\"%s\"", q->scene, q->size[0], q->size[1],
                (double)q->stage.radius, q->rays, q->shaded.pixels, l->entry.method, l->entry.settings);
        csv_figure(f, ",%.3f", l->ms);
        for (int k = 0; k < KINDS; ++k)
            for (int b = 0; b <= BANDS; ++b) csv_figure(f, ",%.6f", b < BANDS ? l->of[k].rms[b] : l->of[k].seen);
    }
    fputs("\n", f);
}

static int write_files(const quiet *q, kit_error *err)
{
    page record, table;
    if (folder_make("report", err) || page_begin(&record, "quiet", "full", "build/quiet", kit_gl_name(), err)
        || page_open(&table, err))
        return -1;
    page_heading(record.file, 2, "What the eye sees as mottling");
    page_paragraph(record.file,
                   "%s, %d x %d pixels, radius %g: RMS of visibility over %zu pixels of smooth surfaces in shade, by "
                   "bands of pixels, and of 1.2 to 8. Noise: beside the same with 32 directions. Truth: ray-traced, "
                   "%d rays a pixel; its own row is the error of half of its rays, which is no smaller than its noise. "
                   "Milliseconds: %s.",
                   q->stage.name, q->size[0], q->size[1], (double)q->stage.radius, q->shaded.pixels, q->rays,
                   kit_gl_is_software() ? "of a " DEVICE " at 1920x1080, modelled" : kit_gl_name());
    put_csv(table.file, q);
    fflush(table.file);
    const csv all = csv_of(strdup(table.text), q->out);
    csv_put(stdout, &all, "method,settings," FIGURES_OF, NULL, 1);
    const int failed = kit_file_write(q->out, table.text, table.size, err);
    page_table(record.file, "quiet", &table);
    return page_end(&record, "report", "quiet", err) || failed ? -1 : 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int add_entry(void *to, const char *text, kit_error *err)
{
    quiet *const q = to;
    kit_method m;
    if (q->lines == MOST_QUIET) return kit_fail(err, "%s: at most %d entries", text, MOST_QUIET);
    line *l = &q->line[q->lines++];
    if (request_read(&l->entry, &m, text, err)) return -1;
    snprintf(l->label, sizeof l->label, "%s", text);
    if (*l->entry.settings) l->label[strlen(l->entry.method)] = ' ';
    return m.lit || m.between ? kit_fail(err, "%s: does not draw ambient visibility of the whole scene", text) : 0;
}

static const char usage[] = "quiet [options] [METHOD[:KEY=VALUE,..]] ..";
#define TO(member) offsetof(quiet, member)
static const kit_option options[] = {
    { .about = "Measures the noise that the eye sees in an image of ambient visibility, in bands of frequency. It "
               "draws one frame; methods that keep history draw a view that stays until it has settled. For each "
               "entry it prints the RMS difference from the same settings with 32 slices (noise), and from ray tracing "
               "(truth). It adds charts to report/index.html." },
    { "METHOD[:KEY=VALUE,..]", NULL, "A method of ambient visibility and its settings, as build/render takes them. "
                                     "Without any, the presets are drawn, and the effects that make peers brought.",
      .kind = KIT_TOLD },
    { "--scene", "NAME", "A built-in scene, random:SEED, or the file of a model, which stands on a floor [spheres].",
      .kind = KIT_TEXT, .at = TO(scene) },
    { "--size", "WxH", "The size of the image in pixels, each 64 to 8192 [960x540].",
      .kind = KIT_SIZE, .at = TO(size), .least = 64, .most = 8192 },
    { "--radius", "R", "The radius, in units of the scene [the scene's own].",
      .kind = KIT_NUMBER, .at = TO(radius), .least = 1e-12, .most = 1e9 },
    { "--rays", "N", "The rays of the ground truth for each pixel [256].",
      .kind = KIT_WHOLE, .at = TO(rays), .least = 2, .most = 65536 },
    { "--pictures", "FOLDER", "Writes each image there, NN-METHOD.png.",
      .kind = KIT_TEXT, .at = TO(pictures) },
    { "--out", "F.csv", "The file to write [build/quiet.csv].", .kind = KIT_TEXT, .at = TO(out) },
    { "--context", "NAME", "osmesa, egl or egl-es: the source of the GL context. If a GPU draws, milliseconds are "
                           "measured; otherwise they are estimated.", .kind = KIT_TEXT, .at = TO(context) },
    { NULL }
};

static int parse(quiet *q, int argc, char **argv, kit_error *err)
{
    static const char *const presets[] = { "hsao-fast", "hsao", "hsao:slices=3", "hsao-history", "hsao-best",
                                           "hsao:thickness=slabs", "ssao" };
    *q = (quiet){ .scene = "spheres", .out = "build/quiet.csv", .size = { 960, 540 }, .rays = RAYS };
    if (kit_options(q, options, argc, argv, add_entry, err)) return -1;
    q->peers = !q->lines;
    for (int i = 0; i < COUNT(presets) && q->peers; ++i) if (add_entry(q, presets[i], err)) return -1;
    return 0;
}

static int measure(quiet *q, kit_error *err)
{
    const view v = { .name = q->scene, .path = q->scene, .ground = 1, .radius = (float)q->radius };
    stage *s = &q->stage;
    kit_image smooth;
    if (folder_make(FOLDER_CACHE, err) || (q->pictures && folder_make(q->pictures, err)) || kit_gl_open(q->context, err)
        || stage_load(s, &v, err))
        return -1;
    s->rays = q->rays;
    if (stage_show(s, &v, q->size[0], q->size[1], err)
        || draw(&smooth, q, "hsao-best", "resolution=full,history=0,slices=32,samples=20", err)
        || shaded_find(&q->shaded, s, &smooth, err))
        return -1;
    kit_image_free(&smooth);
    if (kit_gl_is_software()) take_modelled(q);
    else if (measure_ms(q, err)) return -1;
    const int entries = q->lines;
    for (int i = 0; i < entries; ++i)
        if (measure_entry(q, i, err)) return -1;
    const int peers = q->peers ? measure_peers(q, err) : 0;
    if (peers < 0 || measure_grain(q, err)) return -1;
    if (q->peers && *peers_missing()) puts(peers_missing());
    return write_files(q, err);
}

int main(int argc, char **argv)
{
    static quiet q;
    kit_error err = { "" };
    if (kit_help(argc, argv, usage, options)) return 0;
    if (parse(&q, argc, argv, &err) || measure(&q, &err)) {
        fprintf(stderr, "quiet: %s\n", err.text);
        return 2;
    }
    shaded_free(&q.shaded);
    stage_close(&q.stage);
    kit_gl_close();
    return 0;
}
