/* report.c - what the methods are worth: pictures beside the truth, and speed against accuracy.

      build/report demo  [--out report] [--context egl] [--mesh M.obj]     pictures, tables and demo.html, in a minute
      build/report chart [--out report] [--context egl] [--quick] [--scene NAME]... [--method NAME]     chart*.csv,
         chart*.svg and index.html, in a quarter of an hour, or 2 minutes
      build/report light [--out report] [--context egl] [--quick] [--method NAME]     chart-pairs.csv, light.html
      build/report fit   [--out report] [--context egl]     plan-fit.csv, for fit.c
      build/report plan  [--out report] [--context egl]     the chart's part on the plan: plan.csv, plan.html

   With --mesh or --scene only ambient occlusion is shown; else light, fields and deep screen space, too. --method: the
   rows of methods whose names begin so. Truth is kept under build/cache/, and so is what an interrupted chart has
   measured: the same command goes on from there. Bad input, or a write that fails: one line on stderr, status 2.

   stage.c opens scenes, their truth, and measures; parts.c: pictures and tables that are kept; page.c: what is written
   and how; lit.c, pairs.c, fields.c, deep.c, plan.c: what is shown of light, ambient occlusion fields, deep screen
   space, the plan; peers.c: others' passes; costs.c: what choices cost in SPIR-V. */
#include "lab/report.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- >>tables: what is shown of ambient occlusion ---------------------------------------------------------------- */

static const entry demo_entries[] = {
    { "ssao",       "ssao",       "", 1 },
    { "hsao-fast",  "hsao-fast",  "", 1 },
    { "hsao",       "hsao",       "", 1 },
    { "hsao-best",  "hsao-best",  "", 1 },
    { "hsao-march", "hsao-march", "", 1 }
};

static const entry chart_entries[] = {      /* rows of one label make one curve */
    { "ssao",            "ssao",       "samples=8",                           1 },
    { "ssao",            "ssao",       "",                                    1 },
    { "ssao",            "ssao",       "samples=32",                          1 },
    { "ssao, no blur",   "ssao",       "samples=16,blur=0",                   1 },
    { "hsao, half size", "hsao-fast",  "",                                    1 },
    { "hsao, half size", "hsao-fast",  "steps=6",                             1 },
    { "hsao, half size", "hsao",       "",                                    1 },
    { "hsao, half size", "hsao",       "directions=3",                        0 },
    { "hsao, half size", "hsao",       "directions=2,steps=6",                1 },
    { "hsao, half size", "hsao",       "directions=6,steps=6",                1 },
    { "hsao, 16 frames", "hsao-fast",  "history=1",                           1 },
    { "hsao, 16 frames", "hsao-history", "",                                  1 },
    { "hsao, 16 frames", "hsao-history", "behind=slabs",                      0 },
    { "hsao, 16 frames", "hsao",       "history=1",                           0 },
    { "hsao, full size", "hsao-best",  "directions=1,steps=4",                1 },
    { "hsao, full size", "hsao-best",  "directions=1,steps=6",                1 },
    { "hsao, full size", "hsao-best",  "directions=2,steps=6",                0 },
    { "hsao, full size", "hsao-best",  "",                                    1 },
    { "hsao, full size", "hsao-best",  "directions=4,steps=6,blur=2",         1 },
    { "hsao, solid",     "hsao",       "behind=solid",                        1 },
    { "hsao, back faces", "hsao",      "behind=back",                         1 },
    { "hsao, back faces", "hsao-best", "behind=back",                         0 },
    { "hsao, two slabs", "hsao-fast",  "behind=slabs",                        0 },
    { "hsao, two slabs", "hsao",       "behind=slabs",                        1 },
    { "hsao, two slabs", "hsao-best",  "behind=slabs",                        1 },
    { "hsao-march",      "hsao-march", "",                                    1 },
    { "march, 2 layers", "hsao-march", "layers=2",                            1 },
    { "march, 4 cameras", "hsao-march", "directions=4,steps=6,views=4",       0 },
    { "hsao, margin",    "hsao",       "margin=0.25",                         1 },
    { "hsao, margin",    "hsao-best",  "margin=0.25",                         0 },
    { "dss",             "dss",        "",                                    0 }
};

/* The demo's strip: a camera that comes round to the demo's own in so many frames. */
static const char strip_method[] = "hsao-fast", strip_settings[] = "history=1";
static const double STRIP_DEGREES = 0.2;    /* a frame */
enum { STRIP_DRAWN = 4 };                   /* times, each with noise of its own */
static const float DEMO_ERROR = 0.03f;      /* what the demo's planned row is asked for */
enum { DEMO_ROUNDS = 3, DEMO_WIDTH = 800, DEMO_HEIGHT = 450 };
_Static_assert(COUNT(chart_entries) <= MOST_ENTRIES && COUNT(demo_entries) < MOST_ENTRIES,
    "more rows than MOST_ENTRIES");

/* ---- >>demo ------------------------------------------------------------------------------------------------------ */

static int save_legend(const char *out, kit_error *err)
{
    kit_image ramp, zero, colour;
    if (kit_image_new(&ramp, 512, 16, "Y", err) || kit_image_new(&zero, 512, 16, "Y", err)) return -1;
    for (int i = 0; i < 512 * 16; ++i) ramp.data[i] = (float)(i % 512) / 511 - 0.5f;
    if (kit_image_difference(&colour, &ramp, &zero, "Y", 0.5f, err)
        || save(&colour, "R,G,B", 0, out, "difference-legend", ".png", err))
        return -1;
    kit_image_free(&ramp);
    kit_image_free(&zero);
    kit_image_free(&colour);
    return 0;
}

/* Something to look at while the truth is traced. */
static int first_picture(stage *s, const char *out, kit_error *err)
{
    kit_run run;
    kit_image picture;
    if (run_open(&run, s, "hsao", "", s->radius, err)) return -1;
    kit_run_draw(&run, 0);
    if (kit_run_read(&picture, &run, err) || save(&picture, "Y", 0, out, "hsao", ".png", err)) return -1;
    kit_image_free(&picture);
    kit_run_close(&run);
    return 0;
}

/* One frame alone and the last of SETTLED, beside the truth; each is drawn STRIP_DRAWN times. */
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

/* Error, its mean over the drawings; noise: root of a pixel's variance over them, its mean over the pixels. */
static int strip_score(strip *t, const stage *s, kit_error *err)
{
    const float *z = kit_image_channel(&s->frame, "Z");
    for (int g = 0; g < 2; ++g) {
        double noise = 0;
        size_t pixels = 0;
        row r;
        t->rmse[g] = t->share[g] = 0;
        for (int i = 0; i < STRIP_DRAWN; ++i) {
            if (score(&r, s, &t->picture[g][i], err)) return -1;
            t->rmse[g] += r.score.rmse / STRIP_DRAWN;
            t->share[g] += r.share / STRIP_DRAWN;
        }
        for (int p = 0; p < s->frame.width * s->frame.height; ++p) {
            double sum = 0, squares = 0;
            if (!(z[p] > 0)) continue;
            for (int i = 0; i < STRIP_DRAWN; ++i) {
                const double v = (double)t->picture[g][i].data[p];
                sum += v;
                squares += v * v;
            }
            noise += fmax(0, squares - sum * sum / STRIP_DRAWN) / (STRIP_DRAWN - 1);
            ++pixels;
        }
        t->noise[g] = sqrt(noise / (double)pixels);
    }
    return 0;
}

/* The middle of a picture, each pixel twice. */
static int enlarged(kit_image *out, const kit_image *picture, kit_error *err)
{
    const int left = picture->width / 4, top = picture->height / 2;
    if (kit_image_new(out, picture->width, picture->height, "Y", err)) return -1;
    for (int i = 0; i < out->width * out->height; ++i)
        out->data[i] = kit_image_channel(picture, "Y")[(top + i / out->width / 2) * picture->width
                                                       + left + i % out->width / 2];
    return 0;
}

static int strip_demo(FILE *html, strip *t, stage *s, const char *out, kit_error *err)
{
    static const char *const slugs[3] = { "strip-one", "strip-frames", "strip-truth" },
                      *const labels[3] = { "one frame", "sixteen frames", "ray-traced truth" };
    if (strip_draw(t, s, err) || strip_score(t, s, err)) return -1;
    fprintf(html, "<h2>Over frames</h2>\n<p>%s, --set %s, while the camera turns by %g degrees a frame: the last frame "
            "alone, as the last of sixteen, and its truth; the middle of the picture, enlarged. Noise: root of a "
            "pixel's variance over %d drawings, its mean over the pixels.</p>\n<div class=\"grid\">\n",
            strip_method, strip_settings, STRIP_DEGREES, STRIP_DRAWN);
    for (int k = 0; k < 3; ++k) {
        kit_image large;
        char note[96] = "";
        if (enlarged(&large, k < 2 ? &t->picture[k][0] : &s->truth, err)
            || save(&large, "Y", 0, out, slugs[k], ".png", err))
            return -1;
        if (k < 2) snprintf(note, sizeof note, "RMSE %.4f, error %.3f, noise %.4f", t->rmse[k], t->share[k],
                            t->noise[k]);
        figure_html(html, slugs[k], labels[k], note, large.width, large.height, 0);
        fputs("</figure>\n", html);
        kit_image_free(&large);
    }
    fputs("</div>\n", html);
    for (int i = 0; i < 2 * STRIP_DRAWN; ++i) kit_image_free(&t->picture[i % 2][i / 2]);
    return 0;
}

static void strip_text(FILE *f, const strip *t)
{
    static const char *const labels[2] = { "one frame", "sixteen frames" };
    fprintf(f, "\n%s %s, the camera turning %g degrees a frame\n", strip_method, strip_settings, STRIP_DEGREES);
    for (int k = 0; k < 2; ++k)
        fprintf(f, "%-15s RMSE %.4f, share %.3f, noise %.4f\n", labels[k], t->rmse[k], t->share[k], t->noise[k]);
}

static int demo(const options *o, kit_error *err)
{
    static strip frames;
    enum { ENTRIES = COUNT(demo_entries) + 1 };              /* the last one is planned */
    entry entries[ENTRIES];
    ssgi_plan_scene numbers;
    ssgi_plan plan;
    char planned_set[256];
    view mesh = views[0];
    stage s;
    row rows[ENTRIES + 2];
    kit_image picture[ENTRIES], difference;
    page p;
    char about[512], note[64], slug[64];
    if (o->mesh) { memset(&mesh, 0, sizeof mesh); mesh.name = mesh.path = o->mesh; mesh.ground = 1; }
    if (stage_load(&s, &mesh, err) || stage_look(&s, &mesh, DEMO_WIDTH, DEMO_HEIGHT, err)
        || first_picture(&s, o->out, err) || stage_compare(&s, err)) return -1;
    for (int i = 0; i < 2; ++i) if (save(&s.truth, "Y", 0, o->out, "truth", i ? ".exr" : ".png", err)) return -1;
    if (kit_plan_numbers(&numbers, &s.gbuffer, &(kit_world){ &s.scene, NULL }, s.radius, SSGI_PLAN_VISIBILITY, err))
        return -1;
    numbers.error = DEMO_ERROR;
    numbers.budget = 20;
    if (ssgi_plan_make(&plan, &numbers, NULL) != SSGI_OK) return kit_fail(err, "%s: has no plan", s.name);
    memcpy(entries, demo_entries, sizeof demo_entries);
    entries[ENTRIES - 1] =
        (entry){ "planned", kit_plan_text(planned_set, &plan, SSGI_PLAN_VISIBILITY), planned_set, 1 };
    const int count = plan.method == SSGI_PLAN_NOTHING ? ENTRIES - 1 : ENTRIES;
    if (measure(rows, &s, entries, count, DEMO_ROUNDS, 0, picture, err)) return -1;
    if (save_legend(o->out, err)) return -1;

    if (page_open(&p, err)) return -1;
    snprintf(about, sizeof about,
             "%s, %zu triangles, %d x %d pixels, radius %g. Ambient visibility: white is open, black is closed. Times: "
             "%s.",
             s.name, s.scene.mesh.triangles, s.truth.width, s.truth.height, (double)s.radius, kit_gl_name());
    html_head(p.file,
              o->mesh ? "ssgi: ambient occlusion beside the truth"
                      : "ssgi: ambient occlusion and light beside the truth",
              about);
    snprintf(note, sizeof note, "%d rays a pixel", RAYS);
    fputs("<h2>Ambient occlusion</h2>\n<div class=\"grid\">\n", p.file);
    figure_html(p.file, "truth", "ray-traced truth", note, DEMO_WIDTH, DEMO_HEIGHT, 0);
    key_html(p.file, 0.5);
    fputs("</figure>\n", p.file);
    for (int i = 0; i < count; ++i) {
        slug_of(slug, entries[i].label);
        if (kit_image_difference(&difference, &picture[i], &s.truth, "Y", 0.5f, err)) return -1;
        if (save(&picture[i], "Y", 0, o->out, slug, ".png", err)
            || save(&picture[i], "Y", 0, o->out, slug, ".exr", err))
            return -1;
        if (save(&difference, "R,G,B", 0, o->out, slug, "-difference.png", err)
            || save(&difference, "R,G,B", 0, o->out, slug, "-difference.exr", err))
            return -1;
        kit_image_free(&difference);
        kit_image_free(&picture[i]);
        snprintf(note, sizeof note, "time %.2f, error %.3f", rows[i].relative, rows[i].share);
        figure_html(p.file, slug, entries[i].label, note, DEMO_WIDTH, DEMO_HEIGHT, 1);
        fputs("</figure>\n", p.file);
    }
    fprintf(p.file,
            "</div>\n<p>Planned: ssgi_plan_make was asked for an RMSE of %g. Its answer: ", (double)numbers.error);
    escaped(p.file, plan.why);
    fputs(".</p>\n<h3>Figures</h3>\n", p.file);
    table_html(p.file, rows, count + 2);
    if (strip_demo(p.file, &frames, &s, o->out, err)) return -1;
    stage_close(&s);
    if (!o->mesh && (lit_demo(p.file, o->out, err) || field_demo(p.file, o->out, err)
        || deep_demo(p.file, o->out, err))) return -1;
    html_terms(p.file);
    if (!o->mesh) lit_terms(p.file);
    if (!o->mesh) field_terms(p.file);
    if (!o->mesh) deep_terms(p.file);
    if (page_close(&p, o->out, "demo.html", err)) return -1;
    table_text(stdout, rows, count + 2);
    printf("planned for an RMSE of %g: %s\n", (double)numbers.error, plan.why);
    strip_text(stdout, &frames);
    if (!o->mesh) {
        lit_demo_text(stdout);
        field_demo_text(stdout);
        deep_demo_text(stdout);
    }
    printf("\ntime: relative to one unblurred 16-sample ssao, on %s\nshare: RMSE over that of having no AO; floor: the "
           "exact answer from one depth layer\n",
           kit_gl_name());
    if (!o->mesh) printf("radiance, irradiance, bounce and their biases: over the truth's means\n");
    printf("pictures: %s/demo.html\n", o->out);
    return 0;
}

/* ---- >>chart ----------------------------------------------------------------------------------------------------- */

enum { AO_GIVENS = 2, CHART_ROWS = MOST_ROWS + MOST_PEERS };   /* methods, floor and no AO; peers */

static void mean_of(row *mean, const row (*rows)[CHART_ROWS], int scenes, int count)
{
    for (int i = 0; i < count; ++i) {
        row m = rows[0][i];
        m.scene = "mean";
        m.bytes = m.relative = m.ms = m.share = m.fetches = m.figure[FITTED] = 0;
        for (int j = PLACE_ERROR; j < PLACE_ERROR + 4 * KIT_PLACES; ++j) m.figure[j] = 0;
        memset(&m.score, 0, sizeof m.score);
        memset(m.split, 0, sizeof m.split);
        for (int s = 0; s < scenes; ++s) {
            const row *r = &rows[s][i];
            m.bytes += r->bytes / scenes;
            m.relative += r->relative / scenes;
            for (int j = 0; j < SPLITS; ++j) m.split[j] += r->split[j] / scenes;
            m.ms += r->ms / scenes;
            m.share += r->share / scenes;
            m.fetches += r->fetches / scenes;
            m.figure[FITTED] += r->figure[FITTED] / scenes;
            for (int j = PLACE_ERROR; j < PLACE_ERROR + 4 * KIT_PLACES; ++j) m.figure[j] += r->figure[j] / scenes;
            m.score.rmse += r->score.rmse / scenes;
            m.score.bias += r->score.bias / scenes;
            m.score.p95 += r->score.p95 / scenes;
            m.score.ssim += r->score.ssim / scenes;
            m.score.pixels += r->score.pixels;
        }
        mean[i] = m;
    }
}

/* The k-th scene of those asked for, else of all that are there. */
static view view_at(const options *o, int k)
{
    view v = { .name = o->scenes ? o->scene[k] : views[k].name, .path = o->scenes ? o->scene[k] : NULL };
    for (int i = 0; i < views_count; ++i) if (!strcmp(views[i].name, v.name)) v = views[i];
    return v;
}

static int ao_unit(FILE *html, const options *o, int k, row *rows, kit_error *err)
{
    static char names[MOST_SCENES][64];
    const view v = view_at(o, k);
    entry entries[MOST_ENTRIES];
    kit_image picture[MOST_ENTRIES];
    const int count = chosen(entries, chart_entries, COUNT(chart_entries), o);
    int peers;
    stage s;
    if (!count || (!o->scenes && packages_of(v.path) && access(v.path, R_OK))) return 0;
    if (!rows) return 1;
    if (stage_open(&s, &v, AO_WIDTH, AO_HEIGHT, err)
        || measure(rows, &s, entries, count, QUICK_ROUNDS, AO_PHASES, picture, err))
        return -1;
    peers = o->method
                ? 0
                : peers_measure(rows + count + s.givens, &s, QUICK_ROUNDS, o->quick ? PEERS_QUICK : MOST_PEERS, err);
    if (peers < 0) return -1;
    memcpy(names[k], s.name, sizeof names[k]);
    for (int i = 0; i < count + s.givens + peers; ++i) {
        rows[i].scene = names[k];
        if (peers) rows[i].of |= OF_PEER;
    }
    fputs("<div><h3>", html);
    escaped(html, s.name);
    fprintf(html, "</h3>\n<p>%zu triangles, %d x %d pixels, radius %g. Truth: %d rays a pixel.</p>\n",
            s.scene.mesh.triangles, s.truth.width, s.truth.height, (double)s.radius, s.rays);
    if (thumbs(html, o->out, &s, rows, picture, count, err)) return -1;
    for (int i = 0; i < count; ++i) kit_image_free(&picture[i]);
    stage_close(&s);
    return count + AO_GIVENS + peers;
}

static int ao_chart(FILE *html, const options *o, row *mean, int *count, int *methods, kit_error *err)
{
    static row rows[MOST_SCENES][CHART_ROWS], points[CHART_ROWS];
    const int scenes = o->scenes ? o->scenes : views_count;
    entry entries[MOST_ENTRIES];
    char title[256], file[128];
    page csv, each;
    int shown = 0, drawn;
    *count = CHART_ROWS;
    *methods = chosen(entries, chart_entries, COUNT(chart_entries), o) + AO_GIVENS;
    if (page_open(&csv, err) || page_open(&each, err)) return -1;
    for (int k = 0; k < scenes; ++k) {
        row *r = rows[shown];
        const int n = unit(each.file, o, "ao", k, ao_unit, r, err);
        if (n < 0) return -1;
        if (!n) {
            const view v = view_at(o, k);
            char without[256];
            snprintf(without, sizeof without, "%s: left out, %s is not there; make chart takes it from Debian's %s",
                v.name, v.path, packages_of(v.path));
            fprintf(stderr, "report: note: %s\n", without);
            fprintf(each.file, "<p class=\"faint\">%s.</p>\n", without);
            continue;
        }
        if (n < *count) *count = n;
        snprintf(file, sizeof file, "chart-%.63s.svg", r->scene);
        snprintf(title, sizeof title, "Speed against accuracy: %.63s", r->scene);
        drawn = peers_points(points, r, *methods, n);
        if (chart_of(each.file, o->out, file, title, &ao_words, points, drawn, r[*methods - 2].share, err)) return -1;
        fputs("<details><summary>Figures</summary>\n", each.file);
        table_html(each.file, r, n);
        fputs("</details></div>\n", each.file);
        table_csv(csv.file, r, n, !shown++);
    }
    if (page_close(&csv, o->out, "chart.csv", err)) return -1;
    mean_of(mean, (const row (*)[CHART_ROWS])rows, shown, *count);
    drawn = peers_points(points, mean, *methods, *count);
    snprintf(title, sizeof title, shown > 1 ? "Speed against accuracy, mean of %d scenes" : "Speed against accuracy",
             shown);
    fputs("<h2>Ambient occlusion</h2>\n", html);
    if (chart_of(html, o->out, "chart.svg", title, &ao_words, points, drawn, mean[*methods - 2].share, err)) return -1;
    fprintf(html, "<p class=\"faint\">Rest the pointer on a point for its settings. %s</p>\n", peers_note());
    table_html(html, mean, *count);
    fputs("<h2>Scene by scene</h2>\n<div class=\"charts\">\n", html);
    page_into(&each, html);
    fputs("</div>\n", html);
    return 0;
}

/* What --method names must be there. */
static int check_asked(const options *o, kit_error *err)
{
    entry e[MOST_ENTRIES];
    kit_method m;
    int known = 0;
    for (int i = 0; kit_method_at(&m, i); ++i) known |= asked(o, m.name);
    if (!known)
        return kit_fail(err, "--method %s: no method's name begins so (build/render --list names all)", o->method);
    return o->scenes && !chosen(e, chart_entries, COUNT(chart_entries), o)
               ? kit_fail(err,
                          "--method %s: no row of ambient occlusion's chart is of such a method, and --scene shows "
                          "that alone",
                          o->method)
               : 0;
}

static int chart(const options *o, kit_error *err)
{
    static row mean[CHART_ROWS];
    entry e[MOST_ENTRIES];
    page html;
    char about[512];
    int count = 0, methods = 0;
    const int ao = chosen(e, chart_entries, COUNT(chart_entries), o) > 0, all = !o->scenes;
    if (check_asked(o, err)) return -1;
    if (o->quick) thrift = QUICK_THRIFT;
    units_begin(o, planned(ao_unit, all ? views_count : o->scenes, o)
        + (all ? lit_units(o) + pair_units(o) + field_units(o) + deep_units(o) : 0));
    if (page_open(&html, err)) return -1;
    snprintf(about, sizeof about,
             "Raw output against ray-traced truth: no gain, no exponent fitted; linear attenuation where nothing else "
             "is said. Times: %s.%s",
             kit_gl_name(), o->quick ? " The quick form: smaller pictures, fewer rays, fewer rows." : "");
    html_head(html.file, "ssgi: speed against accuracy", about);
    if (ao && ao_chart(html.file, o, mean, &count, &methods, err)) return -1;
    if (all && (lit_chart(html.file, o, err) || pair_chart(html.file, o, err) || field_chart(html.file, o, err)
        || deep_chart(html.file, o, err))) return -1;
    if (all && !o->method && plan_chart(html.file, o, err)) return -1;
    if (all && !o->method && !o->quick && costs_chart(html.file, o->out, err)) return -1;
    const struct { const char *name; int rows; } csv[] = { { "chart.csv", ao },
        { "chart-lit.csv", all && lit_units(o) }, { "chart-pairs.csv", all && pair_units(o) },
        { "chart-aof.csv", all && field_units(o) },
        { "chart-deep.csv", all && deep_units(o) } };
    html_terms(html.file);
    if (count > methods) peers_terms(html.file);
    if (all) lit_terms(html.file);
    if (all) field_terms(html.file);
    if (all) deep_terms(html.file);
    fputs("<p class=\"faint\">The same figures as text:", html.file);
    for (int i = 0; i < COUNT(csv); ++i)
        if (csv[i].rows) fprintf(html.file, " <a href=\"%s\">%s</a>", csv[i].name, csv[i].name);
    fputs("</p>\n", html.file);
    if (page_close(&html, o->out, "index.html", err) || run_note(o->out, "chart.txt", o->method || o->scenes ? "part"
        : o->quick ? "quick" : "full", o->quick ? "make chart QUICK=1" : "make chart", err)) return -1;
    units_end();
    if (ao) {
        printf("ambient occlusion, %s\n", mean->scene);
        table_text(stdout, mean, count);
        printf("%s\n", peers_note());
        if (count > methods) peers_verdict(stdout, mean, methods, count);
    }
    if (all) lit_chart_text(stdout);
    if (all) pair_text(stdout, o);
    if (all) field_chart_text(stdout);
    if (all) deep_chart_text(stdout);
    if (all && !o->method) plan_text(stdout);
    printf("\ntime: relative to one unblurred 16-sample ssao, on %s\ncharts: %s/index.html\n", kit_gl_name(), o->out);
    return 0;
}

/* Light on every pair alone: light.html. */
static int light(const options *o, kit_error *err)
{
    page html;
    if (o->quick) thrift = QUICK_THRIFT;
    if (o->scenes) return kit_fail(err, "--scene: light shows pairs of all scenes and probes (--quick: few)");
    if (check_asked(o, err)) return -1;
    units_begin(o, pair_units(o));
    if (page_open(&html, err)) return -1;
    html_head(html.file, "ssgi: light on every pair", kit_gl_name());
    if (pair_chart(html.file, o, err)) return -1;
    html_terms(html.file);
    if (page_close(&html, o->out, "light.html", err)) return -1;
    units_end();
    pair_text(stdout, o);
    printf("\ntime: relative to one unblurred 16-sample ssao, on %s\npictures: %s/light.html\n", kit_gl_name(), o->out);
    return 0;
}

/* The plan on views that it was not fitted on, alone: plan.html. */
static int plan(const options *o, kit_error *err)
{
    page html;
    if (page_open(&html, err)) return -1;
    html_head(html.file, "ssgi: the plan", kit_gl_name());
    if (plan_chart(html.file, o, err)) return -1;
    html_terms(html.file);
    if (page_close(&html, o->out, "plan.html", err)) return -1;
    plan_text(stdout);
    return 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int parse(options *o, int is_chart, int argc, char **argv, kit_error *err)
{
    memset(o, 0, sizeof *o);
    o->out = "report";
    for (int i = 2; i < argc; ++i) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        if (is_chart && !strcmp(a, "--quick")) { o->quick = 1; continue; }
        if (strcmp(a, "--out") && strcmp(a, "--context") && strcmp(a, is_chart ? "--scene" : "--mesh")
            && (!is_chart || strcmp(a, "--method")))
            return kit_fail(err, "%s: %s takes no such argument (report alone prints what there is)", a, argv[1]);
        if (!v || !*v) return kit_fail(err, "%s: needs a value", a);
        ++i;
        if (!strcmp(a, "--out")) o->out = v;
        else if (!strcmp(a, "--context")) o->context = v;
        else if (!is_chart) o->mesh = v;
        else if (!strcmp(a, "--method")) o->method = v;
        else if (o->scenes == MOST_SCENES) return kit_fail(err, "--scene %s: at most %d of them", v, MOST_SCENES);
        else o->scene[o->scenes++] = v;
    }
    return 0;
}

int main(int argc, char **argv)
{
    options o;
    kit_error err = { "" };
    int is_chart;
    kit_streams_open();
    if (argc < 2) {
        fputs("usage: report demo  [--out FOLDER] [--context osmesa | egl | egl-es] [--mesh M.obj]     pictures beside "
              "the truth\n"
              "       report chart [--out FOLDER] [--context ...] [--quick] [--scene NAME]... [--method NAME]     "
              "speed against accuracy\n"
              "       report light [--out FOLDER] [--context ...] [--quick] [--method NAME]     the chart's part on "
              "light, every pair\n"
              "       report fit   [--out FOLDER] [--context ...]     what the plan's table is fitted to\n"
              "       report plan  [--out FOLDER] [--context ...]     the plan on views that it was not fitted on\n",
              stderr);
        return 2;
    }
    const int is_light = !strcmp(argv[1], "light");
    is_chart = is_light || !strcmp(argv[1], "chart");
    const int is_fit = !strcmp(argv[1], "fit"), is_plan = !strcmp(argv[1], "plan");
    if (!is_chart && !is_fit && !is_plan && strcmp(argv[1], "demo"))
        kit_fail(&err, "%s: there is no such command (demo, chart, light, fit, plan)", argv[1]);
    else if (!parse(&o, is_chart, argc, argv, &err) && !folder(o.out, &err) && !kit_gl_open(o.context, &err)
        && !(is_light ? light(&o, &err)
             : is_chart ? chart(&o, &err)
             : is_fit   ? plan_fit(o.out, &err)
             : is_plan  ? plan(&o, &err)
                        : demo(&o, &err)))
        kit_streams_close(&err);
    if (*err.text) {
        kit_progress("", 1);
        fprintf(stderr, "report: %s\n", err.text);
        return 2;
    }
    kit_gl_close();
    return 0;
}
