/* report.c - what the methods are worth: pictures beside the truth, and speed against accuracy.

      build/report demo  [--out report] [--mesh M.obj]                 pictures, a table and demo.html, in a minute
      build/report chart [--out report] [--quick] [--scene NAME]...    chart.csv, chart*.svg and chart.html, in some minutes

   Truth is kept under build/cache/. Bad input, or a write that fails: one line on stderr, status 2. page.c holds what is written and how. */
#include "kit/kit_gl.h"
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include "page.c"

/* ---- >>tables: what is shown ------------------------------------------------------------------------------------- */

#define BUNNY   "/usr/share/glmark2/models/bunny.obj"
#define PACKAGE "glmark2-data"
enum { RAYS = 256, FLOOR_STRIDE = 4, DEMO_ROUNDS = 7, CHART_ROUNDS = 5, QUICK_ROUNDS = 3 };

typedef struct entry { const char *label, *method, *settings; int quick; } entry;   /* quick: shown by chart --quick too */

static const entry reference = { "ssao, no blur", "ssao", "samples=16,blur=0", 1 };   /* what times are relative to */

static const entry demo_entries[] = {
    { "ssao",       "ssao",       "", 1 },
    { "hsao-fast",  "hsao-fast",  "", 1 },
    { "hsao",       "hsao",       "", 1 },
    { "hsao-best",  "hsao-best",  "", 1 },
    { "hsao-march", "hsao-march", "", 1 }
};

static const entry chart_entries[] = {      /* rows of one label make one curve */
    { "ssao",            "ssao",       "samples=4",                           0 },
    { "ssao",            "ssao",       "samples=8",                           1 },
    { "ssao",            "ssao",       "",                                    1 },
    { "ssao",            "ssao",       "samples=32",                          1 },
    { "ssao, no blur",   "ssao",       "samples=16,blur=0",                   1 },
    { "hsao, half size", "hsao-fast",  "steps=2",                             0 },
    { "hsao, half size", "hsao-fast",  "",                                    1 },
    { "hsao, half size", "hsao-fast",  "steps=4",                             0 },
    { "hsao, half size", "hsao-fast",  "steps=6",                             1 },
    { "hsao, half size", "hsao",       "",                                    1 },
    { "hsao, half size", "hsao",       "directions=3",                        0 },
    { "hsao, half size", "hsao",       "directions=4,steps=8",                1 },
    { "hsao, full size", "hsao-best",  "directions=1,steps=3",                0 },
    { "hsao, full size", "hsao-best",  "directions=1,steps=4",                1 },
    { "hsao, full size", "hsao-best",  "directions=1,steps=6",                1 },
    { "hsao, full size", "hsao-best",  "directions=2,steps=6",                0 },
    { "hsao, full size", "hsao-best",  "",                                    1 },
    { "hsao, full size", "hsao-best",  "directions=8,steps=12",               0 },
    { "hsao-march",      "hsao-march", "directions=4,steps=6,normal_rays=0",  1 },
    { "hsao-march",      "hsao-march", "directions=4,steps=6,normal_rays=1",  0 },
    { "hsao-march",      "hsao-march", "",                                    1 },
    { "hsao-march",      "hsao-march", "directions=8,steps=18,normal_rays=2", 0 }
};

#define COUNT(table) ((int)(sizeof (table) / sizeof (table)[0]))
enum { MOST_ENTRIES = COUNT(chart_entries) > COUNT(demo_entries) ? COUNT(chart_entries) : COUNT(demo_entries), MOST_ROWS = MOST_ENTRIES + 2, MOST_SCENES = 16 };

/* A view of a scene; what is 0 is the scene's own. */
typedef struct view { const char *name, *path; int ground; float eye[3], target[3], fovy, radius; } view;
static const view views[] = {
    { "bunny",     BUNNY,       1, { -1.4f, 1.1f, 3.7f }, { 0, -0.13f, 0 }, 33, 0.6f },
    { "room",      "room",      0, { 0 }, { 0 }, 0, 0 },
    { "grass",     "grass",     0, { 0 }, { 0 }, 0, 0 },
    { "colonnade", "colonnade", 0, { 0 }, { 0 }, 0, 0 }
};

/* ---- >>stage: a scene, its G-buffer, its truth and its floor ------------------------------------------------------- */

typedef struct stage {
    char        name[64];
    kit_scene   scene;
    kit_gbuffer gbuffer;
    kit_image   frame, truth, floor, open;     /* open: 1 everywhere, the answer of having no AO */
    float       radius;
} stage;

static int folder(const char *path, kit_error *err)
{
    char part[4096];
    struct stat status;
    if (strlen(path) >= sizeof part - 64) return kit_fail(err, "--out %.60s...: too long", path);
    for (size_t i = 1; i <= strlen(path); ++i) {
        if (path[i] != '/' && path[i]) continue;
        memcpy(part, path, i);
        part[i] = 0;
        if (mkdir(part, 0777) && errno != EEXIST) return kit_fail(err, "%s: cannot be made: %s", part, strerror(errno));
    }
    if (stat(path, &status) || !S_ISDIR(status.st_mode)) return kit_fail(err, "%s: is not a folder", path);
    return 0;
}

static uint64_t hashed(uint64_t h, const void *data, size_t size)     /* FNV-1a */
{
    for (const unsigned char *p = data, *end = p + size; p < end; ++p) h = (h ^ *p) * 1099511628211u;
    return h;
}

/* The truth, from build/cache where it was computed before: the file's name holds a hash of all that it depends on, and a few hundred pixels
   are traced anew, so that another tracer does not reuse it either. */
static int truth_of(stage *s, kit_error *err)
{
    const kit_camera *c = &s->gbuffer.camera;
    const size_t floats = 9 * s->scene.mesh.triangles * sizeof(float), pixels = (size_t)c->width * (size_t)c->height;
    uint64_t h = hashed(14695981039346656037u, s->scene.mesh.position, floats);
    char path[256];
    kit_image probe;
    kit_error note;
    h = hashed(h, s->scene.mesh.normal, floats);
    h = hashed(h, c, sizeof *c);
    h = hashed(h, &s->radius, sizeof s->radius);
    snprintf(path, sizeof path, "build/cache/%s-%dx%d-%g-%d-%016llx.exr", s->name, c->width, c->height, (double)s->radius, RAYS, (unsigned long long)h);
    if (!kit_exr_read(&s->truth, path, NULL)) {
        int same = s->truth.channels == 1 && s->truth.width == c->width && s->truth.height == c->height;
        if (kit_truth_ao(&probe, &s->scene, c, s->radius, KIT_ATTENUATION_LINEAR, RAYS, 61, err)) return -1;
        for (size_t i = 0; i < pixels && same; ++i) same = isnan(probe.data[i]) || probe.data[i] == s->truth.data[i];
        kit_image_free(&probe);
        if (same) return 0;
        kit_image_free(&s->truth);
    }
    if (kit_truth_ao(&s->truth, &s->scene, c, s->radius, KIT_ATTENUATION_LINEAR, RAYS, 1, err)) return -1;
    if (folder("build/cache", &note) || kit_exr_write(&s->truth, path, &note)) fprintf(stderr, "report: note: the truth is not kept: %s\n", note.text);
    return 0;
}

static int stage_open(stage *s, const view *v, int width, int height, kit_error *err)
{
    kit_camera camera;
    const char *base = strrchr(v->name, '/');
    struct stat status;
    memset(s, 0, sizeof *s);
    snprintf(s->name, sizeof s->name, "%s", base ? base + 1 : v->name);
    if (strchr(s->name, '.') > s->name) *strchr(s->name, '.') = 0;
    if (!strcmp(v->path, BUNNY) && stat(BUNNY, &status)) return kit_fail(err, "%s: is missing; install the package %s (apt-get install %s)", BUNNY, PACKAGE, PACKAGE);
    if (kit_scene_load(&s->scene, v->path, v->ground, err)) return -1;
    camera = s->scene.camera;
    if (v->fovy > 0) {
        memcpy(camera.eye, v->eye, sizeof v->eye);
        memcpy(camera.target, v->target, sizeof v->target);
        camera.fovy = v->fovy;
    }
    camera.width = width;
    camera.height = height;
    s->radius = v->radius > 0 ? v->radius : s->scene.radius;
    if (kit_gbuffer_from_scene(&s->gbuffer, &s->scene, &camera, NULL, err) || kit_gbuffer_read(&s->frame, &s->gbuffer, err) || truth_of(s, err)) return -1;
    if (kit_floor_ao(&s->floor, &s->frame, &s->gbuffer.camera, s->radius, KIT_ATTENUATION_LINEAR, RAYS, FLOOR_STRIDE, err)) return -1;
    if (kit_image_new(&s->open, width, height, "Y", err)) return -1;
    for (size_t i = 0; i < (size_t)width * (size_t)height; ++i) s->open.data[i] = 1;
    return 0;
}

static void stage_close(stage *s)
{
    kit_image_free(&s->frame);
    kit_image_free(&s->truth);
    kit_image_free(&s->floor);
    kit_image_free(&s->open);
    kit_gbuffer_free(&s->gbuffer);
    kit_scene_free(&s->scene);
}

/* ---- >>measure ----------------------------------------------------------------------------------------------------- */

static int by_value(const void *a, const void *b)
{
    double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

static double median(double *v, int count)
{
    qsort(v, (size_t)count, sizeof *v, by_value);
    return count % 2 ? v[count / 2] : 0.5 * (v[count / 2 - 1] + v[count / 2]);
}

/* Scores a picture over what the frame shows, and where the picture is known; its share is of no AO's error on the same pixels. */
static int score(row *r, const stage *s, const kit_image *picture, kit_error *err)
{
    const float *z = kit_image_channel(&s->frame, "Z");
    size_t pixels = (size_t)picture->width * (size_t)picture->height;
    float *mask = malloc(pixels * sizeof *mask);
    kit_score nothing;
    int status;
    if (!mask) return kit_fail(err, "out of memory");
    for (size_t i = 0; i < pixels; ++i) mask[i] = isnan(picture->data[i]) ? 0 : z[i];
    status = kit_score_channel(&r->score, picture, &s->truth, "Y", mask, err) || kit_score_channel(&nothing, &s->open, &s->truth, "Y", mask, err) ? -1 : 0;
    free(mask);
    r->share = !status && nothing.rmse > 0 ? r->score.rmse / nothing.rmse : (double)NAN;
    return status;
}

static int run_open(kit_run *run, const stage *s, const entry *e, kit_error *err)
{
    kit_method m;
    return kit_method_find(&m, e->method, err) || kit_method_set(&m, e->settings, err) || kit_run_open(run, (kit_gbuffer *)&s->gbuffer, &m, s->radius, NULL, err) ? -1 : 0;
}

static double draw(kit_run *run)
{
    kit_run_draw(run, 1);
    return kit_run_ms(run);
}

/* Fills a row an entry, then one for the floor and one for no AO; count + 2 in all. Every entry is drawn once to warm up (that picture is scored), then once
   a round between two drawings of the reference, whose mean its time is divided by. pictures: NULL, or an empty one an entry. */
static int measure(row *rows, const stage *s, const entry *entries, int count, int rounds, kit_image *pictures, kit_error *err)
{
    double *ratio = calloc((size_t)(2 * count * rounds), sizeof *ratio), *ms = ratio + count * rounds, before, after;
    kit_run run[MOST_ENTRIES], fixed;
    char what[128];
    if (!ratio) return kit_fail(err, "out of memory");
    snprintf(what, sizeof what, "%s: methods", s->name);
    if (run_open(&fixed, s, &reference, err)) return -1;
    kit_run_draw(&fixed, 1);
    kit_progress(what, 0);
    for (int i = 0; i < count; ++i) {
        kit_image picture;
        memset(&rows[i], 0, sizeof rows[i]);
        rows[i].label = entries[i].label;
        rows[i].method = entries[i].method;
        rows[i].settings = entries[i].settings;
        if (run_open(&run[i], s, &entries[i], err)) return -1;
        rows[i].fetches = run[i].fetches;
        kit_run_draw(&run[i], 1);
        if (kit_run_read(&picture, &run[i], err) || score(&rows[i], s, &picture, err)) return -1;
        if (pictures) pictures[i] = picture; else kit_image_free(&picture);
        kit_progress(what, (i + 1.0) / (count + 1.0));
    }
    kit_progress(what, 1);
    snprintf(what, sizeof what, "%s: times", s->name);
    kit_progress(what, 0);
    for (int k = 0; k < rounds; ++k) {
        before = draw(&fixed);
        for (int i = 0; i < count; ++i, before = after) {
            ms[i * rounds + k] = draw(&run[i]);
            after = draw(&fixed);
            ratio[i * rounds + k] = ms[i * rounds + k] / (0.5 * (before + after));
            kit_progress(what, (k * count + i + 0.99) / (rounds * count));
        }
    }
    kit_progress(what, 1);
    for (int i = 0; i < count; ++i) {
        rows[i].relative = median(ratio + i * rounds, rounds);
        rows[i].ms = median(ms + i * rounds, rounds);
        kit_run_close(&run[i]);
    }
    kit_run_close(&fixed);
    free(ratio);
    for (int i = count; i < count + 2; ++i) {
        memset(&rows[i], 0, sizeof rows[i]);
        rows[i].label = i == count ? "floor" : "no AO";
        rows[i].method = i == count ? "floor" : "none";
        rows[i].settings = "";
        rows[i].fetches = rows[i].relative = rows[i].ms = (double)NAN;
        if (score(&rows[i], s, i == count ? &s->floor : &s->open, err)) return -1;
        if (i == count && FLOOR_STRIDE > 1) rows[i].score.ssim = (double)NAN;      /* has no neighbours */
    }
    for (int i = 0; i < count + 2; ++i) rows[i].scene = s->name;
    return 0;
}

/* ---- >>demo -------------------------------------------------------------------------------------------------------- */

typedef struct options { const char *out, *mesh, *scene[MOST_SCENES]; int quick, scenes; } options;

static int save(const kit_image *image, const char *names, const char *out, const char *slug, const char *ending, kit_error *err)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s%s", out, slug, ending);
    return strstr(ending, ".exr") ? kit_exr_write(image, path, err) : kit_png_write(image, names, 0, path, err);
}

static int save_legend(const char *out, kit_error *err)
{
    kit_image ramp, zero, colour;
    if (kit_image_new(&ramp, 512, 16, "Y", err) || kit_image_new(&zero, 512, 16, "Y", err)) return -1;
    for (int i = 0; i < 512 * 16; ++i) ramp.data[i] = (float)(i % 512) / 511 - 0.5f;
    if (kit_image_difference(&colour, &ramp, &zero, "Y", 0.5f, err) || save(&colour, "R,G,B", out, "difference-legend", ".png", err)) return -1;
    kit_image_free(&ramp);
    kit_image_free(&zero);
    kit_image_free(&colour);
    return 0;
}

static void slug_of(char slug[64], const char *label)
{
    size_t n = 0;
    for (; *label && n < 63; ++label) if (isalnum((unsigned char)*label)) slug[n++] = (char)tolower((unsigned char)*label); else if (n && slug[n - 1] != '-') slug[n++] = '-';
    slug[n] = 0;
}

static int demo(const options *o, kit_error *err)
{
    enum { ENTRIES = COUNT(demo_entries) };
    view mesh = views[0];
    stage s;
    row rows[ENTRIES + 2];
    kit_image picture[ENTRIES], difference;
    page p;
    char about[512], slug[64];
    if (o->mesh) { memset(&mesh, 0, sizeof mesh); mesh.name = mesh.path = o->mesh; mesh.ground = 1; }
    if (stage_open(&s, &mesh, 1280, 720, err)) return -1;
    if (measure(rows, &s, demo_entries, ENTRIES, DEMO_ROUNDS, picture, err)) return -1;
    if (save(&s.truth, "Y", o->out, "truth", ".png", err) || save(&s.truth, "Y", o->out, "truth", ".exr", err) || save_legend(o->out, err)) return -1;

    if (page_open(&p, err)) return -1;
    snprintf(about, sizeof about, "%s, %zu triangles, %d x %d pixels, radius %g. Ambient visibility: white is open, black is closed. Times: %s.",
             s.name, s.scene.mesh.triangles, s.truth.width, s.truth.height, (double)s.radius, kit_gl_name());
    html_head(p.file, "ssgi: ambient occlusion beside the truth", about);
    fprintf(p.file, "<h2>Pictures</h2>\n<div class=\"grid\">\n<figure><figcaption><b>ray-traced truth</b><span>%d rays a pixel</span></figcaption>"
            "<a href=\"truth.png\"><img src=\"truth.png\" width=\"1280\" height=\"720\" alt=\"ray-traced truth\"></a>"
            "<div class=\"key\"><img src=\"difference-legend.png\" alt=\"blue over white to red\"><div><span>&minus;0.5 too dark</span><span>0</span><span>too bright +0.5</span></div>"
            "<p class=\"faint\">Under each picture: its difference to the truth, in these colours.</p></div></figure>\n", RAYS);
    for (int i = 0; i < ENTRIES; ++i) {
        slug_of(slug, demo_entries[i].label);
        if (kit_image_difference(&difference, &picture[i], &s.truth, "Y", 0.5f, err)) return -1;
        if (save(&picture[i], "Y", o->out, slug, ".png", err) || save(&picture[i], "Y", o->out, slug, ".exr", err)) return -1;
        if (save(&difference, "R,G,B", o->out, slug, "-difference.png", err) || save(&difference, "R,G,B", o->out, slug, "-difference.exr", err)) return -1;
        kit_image_free(&difference);
        kit_image_free(&picture[i]);
        fprintf(p.file, "<figure><figcaption><b>%s</b><span>time %.2f, error %.3f</span></figcaption>", demo_entries[i].label, rows[i].relative, rows[i].share);
        fprintf(p.file, "<a href=\"%s.png\"><img src=\"%s.png\" width=\"1280\" height=\"720\" alt=\"%s\"></a>", slug, slug, demo_entries[i].label);
        fprintf(p.file, "<a href=\"%s-difference.png\"><img src=\"%s-difference.png\" width=\"1280\" height=\"720\" alt=\"difference of %s\"></a></figure>\n", slug, slug, demo_entries[i].label);
    }
    fputs("</div>\n<h2>Figures</h2>\n", p.file);
    table_html(p.file, rows, ENTRIES + 2);
    html_terms(p.file);
    if (page_close(&p, o->out, "demo.html", err)) return -1;
    stage_close(&s);
    table_text(stdout, rows, ENTRIES + 2);
    printf("\ntime: relative to one unblurred 16-sample ssao; ms on %s\nshare: RMSE over that of having no AO; floor: the exact answer from one depth layer\npictures: %s/demo.html\n", kit_gl_name(), o->out);
    return 0;
}

/* ---- >>chart ------------------------------------------------------------------------------------------------------- */

static void mean_of(row *mean, const row (*rows)[MOST_ROWS], int scenes, int count)
{
    for (int i = 0; i < count; ++i) {
        row m = rows[0][i];
        m.scene = "mean";
        m.relative = m.ms = m.share = 0;
        memset(&m.score, 0, sizeof m.score);
        for (int s = 0; s < scenes; ++s) {
            const row *r = &rows[s][i];
            m.relative += r->relative / scenes;
            m.ms += r->ms / scenes;
            m.share += r->share / scenes;
            m.score.rmse += r->score.rmse / scenes;
            m.score.bias += r->score.bias / scenes;
            m.score.p95 += r->score.p95 / scenes;
            m.score.ssim += r->score.ssim / scenes;
            m.score.pixels += r->score.pixels;
        }
        mean[i] = m;
    }
}

/* A chart as a file of its own and inside the page. */
static int chart_of(FILE *html, const char *out, const char *name, const char *title, const row *rows, int count, kit_error *err)
{
    page p;
    if (page_open(&p, err)) return -1;
    chart_svg(p.file, title, rows, count, rows[count - 2].share);
    fflush(p.file);
    fwrite(p.text, 1, p.size, html);
    return page_close(&p, out, name, err);
}

static int chart(const options *o, kit_error *err)
{
    static row rows[MOST_SCENES][MOST_ROWS];
    static char names[MOST_SCENES][64];
    row mean[MOST_ROWS];
    entry entries[MOST_ENTRIES];
    page html, csv;
    char about[512], title[256], file[128];
    int count = 0, scenes = o->scenes ? o->scenes : COUNT(views), width = o->quick ? 640 : 1280, height = o->quick ? 360 : 720;
    for (int i = 0; i < COUNT(chart_entries); ++i) if (chart_entries[i].quick || !o->quick) entries[count++] = chart_entries[i];
    for (int k = 0; k < scenes; ++k) {
        view v;
        stage s;
        memset(&v, 0, sizeof v);
        if (o->scenes) v.name = v.path = o->scene[k]; else v = views[k];
        for (int i = 0; i < COUNT(views); ++i) if (!strcmp(views[i].name, v.name)) v = views[i];
        if (stage_open(&s, &v, width, height, err) || measure(rows[k], &s, entries, count, o->quick ? QUICK_ROUNDS : CHART_ROUNDS, NULL, err)) return -1;
        memcpy(names[k], s.name, sizeof names[k]);
        for (int i = 0; i < count + 2; ++i) rows[k][i].scene = names[k];
        stage_close(&s);
    }
    count += 2;
    mean_of(mean, (const row (*)[MOST_ROWS])rows, scenes, count);

    if (page_open(&csv, err)) return -1;
    for (int k = 0; k < scenes; ++k) table_csv(csv.file, rows[k], count, !k);
    if (page_close(&csv, o->out, "chart.csv", err)) return -1;

    if (page_open(&html, err)) return -1;
    snprintf(about, sizeof about, "Ambient occlusion against ray-traced truth (%d rays a pixel, linear attenuation), %d x %d pixels. Times: %s.", RAYS, width, height, kit_gl_name());
    html_head(html.file, "ssgi: speed against accuracy", about);
    snprintf(title, sizeof title, scenes > 1 ? "Speed against accuracy, mean of %d scenes" : "Speed against accuracy", scenes);
    fprintf(html.file, "<h2>Mean of the scenes</h2>\n");
    if (chart_of(html.file, o->out, "chart.svg", title, mean, count, err)) return -1;
    fputs("<p class=\"faint\">Rest the pointer on a point for its settings.</p>\n", html.file);
    table_html(html.file, mean, count);
    fputs("<h2>Scene by scene</h2>\n<div class=\"charts\">\n", html.file);
    for (int k = 0; k < scenes; ++k) {
        snprintf(file, sizeof file, "chart-%.63s.svg", names[k]);
        snprintf(title, sizeof title, "Speed against accuracy: %.63s", names[k]);
        if (chart_of(html.file, o->out, file, title, rows[k], count, err)) return -1;
    }
    fputs("</div>\n", html.file);
    for (int k = 0; k < scenes; ++k) {
        fputs("<details><summary>Figures: ", html.file);
        escaped(html.file, names[k]);
        fputs("</summary>\n", html.file);
        table_html(html.file, rows[k], count);
        fputs("</details>\n", html.file);
    }
    html_terms(html.file);
    fputs("<p class=\"faint\">The same figures as text: <a href=\"chart.csv\">chart.csv</a>.</p>\n", html.file);
    if (page_close(&html, o->out, "chart.html", err)) return -1;
    printf("mean of:");
    for (int k = 0; k < scenes; ++k) printf("%s %s", k ? "," : "", names[k]);
    printf("\n");
    table_text(stdout, mean, count);
    printf("\ntime: relative to one unblurred 16-sample ssao; ms on %s\ncharts: %s/chart.html\n", kit_gl_name(), o->out);
    return 0;
}

/* ---- >>main -------------------------------------------------------------------------------------------------------- */

static int parse(options *o, int is_chart, int argc, char **argv, kit_error *err)
{
    memset(o, 0, sizeof *o);
    o->out = "report";
    for (int i = 2; i < argc; ++i) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        if (is_chart && !strcmp(a, "--quick")) { o->quick = 1; continue; }
        if (strcmp(a, "--out") && strcmp(a, is_chart ? "--scene" : "--mesh")) return kit_fail(err, "%s: %s takes no such argument (report alone prints what there is)", a, argv[1]);
        if (!v || !*v) return kit_fail(err, "%s: needs a value", a);
        ++i;
        if (!strcmp(a, "--out")) o->out = v;
        else if (!is_chart) o->mesh = v;
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
    if (argc < 2) {
        fputs("usage: report demo  [--out FOLDER] [--mesh M.obj]                pictures beside the truth\n"
              "       report chart [--out FOLDER] [--quick] [--scene NAME]...   speed against accuracy\n", stderr);
        return 2;
    }
    is_chart = !strcmp(argv[1], "chart");
    if (!is_chart && strcmp(argv[1], "demo")) kit_fail(&err, "%s: there is no such command (demo, chart)", argv[1]);
    else if (!parse(&o, is_chart, argc, argv, &err) && !folder(o.out, &err) && !kit_gl_open(NULL, &err)
        && !(is_chart ? chart(&o, &err) : demo(&o, &err)) && (fflush(stdout) || ferror(stdout))) kit_fail(&err, "standard output: cannot be written");
    if (*err.text) {
        kit_progress("", 1);
        fprintf(stderr, "report: %s\n", err.text);
        return 2;
    }
    kit_gl_close();
    return 0;
}
