/* bench.c - what every method takes on this machine's GPU, as a table in Markdown.

      build/bench [--context egl | egl-es | osmesa] [--scene NAME] [--method NAME] [--out report/bench.md]

   Every row of build/render --list at its defaults and some settings that engines ask about, at 1920x1080 and
   3840x2160. Milliseconds by timer queries; each row is opened, warmed up and timed once a round, so that rows of all
   kinds share what the clock and the neighbours do; medians. Without a GPU few rows, small, and the table says so.
   With one, report/plan-gpu.csv too: what each choice of the plan takes, for make fit. */
#include "kit/kit_gl.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { ROUNDS = 3, DRAWS = 15, SIZES = 2, MOST = 64, PARTS = 24 };

/* What the command is asked for; method NULL: all. */
typedef struct options { const char *context, *scene, *method, *out; } options;

typedef struct row {
    kit_method  method;
    const char *set;                       /* beyond the defaults */
    double      ms[SIZES][ROUNDS], slabs[SIZES];
    int         timed[SIZES];              /* rounds */
    const char *part[PARTS];               /* passes by name, and what those of a name take together */
    double      part_ms[PARTS];
    int         parts, draws;
    char        why[160];                  /* it cannot be drawn here */
} row;

/* What is drawn, and what it took. */
typedef struct bench {
    row          row[MOST];
    int          count, software, sizes, size[SIZES][2];
    kit_scene    scene;
    kit_lighting sky, both;                /* both: and a sun, which what scatters, and what shines, wants */
} bench;

static const char *const more[][2] = {
    { "ssao", "samples=32" }, { "hsao", "normal=depth" }, { "hsao", "behind=back" }, { "hsao", "behind=slabs" },
    { "hsao", "history=1" }, { "ssdo", "bounce=none" }, { "ssdo", "reuse=1" }
};
/* what a machine without a GPU has time for */
static const char *const few[] = { "ssao", "hsao-fast", "hsao", "hsao-best", "ssdo", "s3ho" };

static int chosen(const char *name, const char *asked, int software)
{
    int one_of = 0;
    for (size_t i = 0; i < sizeof few / sizeof *few; ++i) one_of |= !strcmp(name, few[i]);
    return asked ? !strncmp(name, asked, strlen(asked)) : one_of || !software;    /* "": all */
}

static int rows_new(row *rows, const char *asked, int software, kit_error *err)
{
    kit_method m;
    int count = 0;
    for (int i = 0; kit_method_at(&m, i) && count < MOST; ++i) {
        if (!chosen(m.name, asked, software)) continue;
        rows[count].method = m;
        rows[count++].set = "";
        for (size_t k = 0; k < sizeof more / sizeof *more && (asked || !software) && count < MOST; ++k) {
            if (strcmp(more[k][0], m.name)) continue;
            rows[count].method = m;
            rows[count].set = more[k][1];
            if (kit_method_set(&rows[count++].method, more[k][1], err)) return -1;
        }
    }
    return count ? count : kit_fail(err, "--method %s: there is none whose name begins so", asked);
}

static void note_parts(row *r, const kit_run *run, double pass_ms[][DRAWS])
{
    r->parts = r->draws = 0;
    for (int i = 0; i < run->passes; ++i) {
        const char *name = ssgi_gl_pass_name(run->pass[i].desc.pass);
        int k = 0;
        if (run->pass[i].aside) continue;
        while (k < r->parts && strcmp(r->part[k], name)) ++k;
        if (k == PARTS) continue;
        if (k == r->parts) { r->part[r->parts] = name; r->part_ms[r->parts++] = 0; }
        r->part_ms[k] += kit_median(pass_ms[i], DRAWS);
        ++r->draws;
    }
}

/* One round of a row: warmed up for a tenth of a second, so that the GPU is at its clock. */
static int measure(row *r, int s, kit_gbuffer *g, float radius, const kit_world *world, kit_error *err)
{
    static double pass_ms[KIT_MAX_PASSES][DRAWS];
    static kit_run run;
    double all[DRAWS], began;
    unsigned n = 0;
    int failed;
    if (kit_run_open(&run, g, &r->method, radius, world, err)) return -1;
    began = kit_seconds();
    do failed = kit_frames_still(&run, 0, n++, 1, err); while (!failed && n < 200 && kit_seconds() < began + 0.1);
    for (int k = 0; k < DRAWS && !failed; ++k) {
        failed = kit_frames_still(&run, 0, n++, 1, err);
        all[k] = 0;
        for (int i = 0; i < run.passes; ++i) {
            pass_ms[i][k] = run.pass[i].ms;
            if (!run.pass[i].aside) all[k] += run.pass[i].ms;
        }
    }
    if (!failed) {
        r->ms[s][r->timed[s]++] = kit_median(all, DRAWS);
        if (!s) note_parts(r, &run, pass_ms);
    }
    kit_run_close(&run);
    return failed;
}

/* Every choice of the plan but surfels and fields: its time over that of an unblurred 16-sample ssao. */
static int plan_csv(const char *path, kit_gbuffer *g, float radius, const kit_world *world, kit_error *err)
{
    ssgi_plan_scene s = { .thickness = SSGI_PLAN_SLABS, .history = 1, .map = 1 };
    row unit = { .set = "samples=16,blur=0" }, r = { .set = "" };
    FILE *f = fopen(path, "w");
    int failed = f ? 0 : kit_fail(err, "%s: cannot be written", path);
    if (!failed)
        failed = kit_method_find(&unit.method, "ssao", err) || kit_method_set(&unit.method, unit.set, err);
    for (s.wanted = 0; s.wanted < 3 && !failed; ++s.wanted)
        for (int i = 0; i < SSGI_PLAN_CHOICES && !failed; ++i) {
            double ratio[ROUNDS];
            ssgi_plan p;
            if (!ssgi_plan_choice(&p, i, &s) || p.method == SSGI_PLAN_NOTHING) continue;
            failed = kit_plan_method(&r.method, &p, s.wanted, err);
            for (int k = 0; k < ROUNDS && !failed; ++k) {
                unit.timed[0] = r.timed[0] = 0;
                failed = measure(&unit, 0, g, radius, world, err) || measure(&r, 0, g, radius, world, err);
                if (!failed) ratio[k] = r.ms[0][0] / unit.ms[0][0];
            }
            if (!failed) fprintf(f, "%d,%g\n", i, kit_median(ratio, ROUNDS));
            kit_progress("the plan's choices", ((double)s.wanted * SSGI_PLAN_CHOICES + i) / (3 * SSGI_PLAN_CHOICES));
        }
    if (f && fclose(f) && !failed) failed = kit_fail(err, "%s: cannot be written", path);
    return failed ? -1 : 0;
}

/* ---- >>writing --------------------------------------------------------------------------------------------------- */

static void print_row(FILE *f, const bench *b, row *r)
{
    const int digits = b->software ? 0 : 3;
    fprintf(f, "| `%s`%s%s%s |", r->method.name, *r->set ? " `" : "", r->set, *r->set ? "`" : "");
    for (int s = 0; s < b->sizes; ++s) {
        if (r->timed[s]) fprintf(f, " %.*f |", digits, kit_median(r->ms[s], r->timed[s]));
        else fputs(" |", f);
    }
    if (*r->why) fprintf(f, " not drawn: %s", r->why);
    for (int k = 0; k < r->parts && !*r->why; ++k)
        fprintf(f, "%s %s %.*f", k ? "," : "", r->part[k], digits, r->part_ms[k]);
    if (r->slabs[0] > 0) fprintf(f, "; and the scene's back faces %.*f", digits, r->slabs[0]);
    fputs(" |\n", f);
}

static void print(FILE *f, bench *b, const char *command)
{
    fprintf(f, "`%s` on %s: `%s`, %zu triangles, medians of %d frames, milliseconds by %s.\n", command, kit_gl_name(),
            b->scene.name, b->scene.mesh.triangles, b->software ? DRAWS : ROUNDS * DRAWS,
            b->software ? "the clock" : "timer queries");
    if (b->software)
        fputs("**No GPU was found: a CPU drew this, small, few rows. These times say nothing about a GPU.**\n", f);
    fputs("\n| method | ", f);
    for (int s = 0; s < b->sizes; ++s) fprintf(f, "%dx%d | ", b->size[s][0], b->size[s][1]);
    fprintf(f, "passes at %dx%d |\n|---|", b->size[0][0], b->size[0][1]);
    for (int s = 0; s < b->sizes; ++s) fputs("--:|", f);
    fputs("---|\n", f);
    for (int i = 0; i < b->count; ++i) print_row(f, b, &b->row[i]);
}

/* To the file, and to standard output. */
static int print_both(bench *b, const options *a, kit_error *err)
{
    char command[256] = "make bench";
    FILE *f = fopen(a->out, "w");
    if (!f) return kit_fail(err, "%s: cannot be written", a->out);
    if (strcmp(a->context, "egl")) snprintf(command, sizeof command, "make bench CONTEXT=%.100s", a->context);
    if (strcmp(a->scene, "room"))
        snprintf(command + strlen(command), sizeof command - strlen(command), " SCENE=%.100s", a->scene);
    print(f, b, command);
    const int failed = fclose(f) ? kit_fail(err, "%s: cannot be written", a->out) : 0;
    print(stdout, b, command);
    return failed;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int parse(options *a, int argc, char **argv, kit_error *err)
{
    *a = (options){ "egl", "room", NULL, "report/bench.md" };
    for (int i = 1; i + 1 < argc; i += 2) {
        if (!strcmp(argv[i], "--context")) a->context = argv[i + 1];
        else if (!strcmp(argv[i], "--scene")) a->scene = argv[i + 1];
        else if (!strcmp(argv[i], "--method")) a->method = argv[i + 1];
        else if (!strcmp(argv[i], "--out")) a->out = argv[i + 1];
        else return kit_fail(err, "%s: there is no such option (--context, --scene, --method, --out)", argv[i]);
    }
    return argc % 2 ? 0 : kit_fail(err, "%s: needs a value", argv[argc - 1]);
}

static int bench_open(bench *b, const options *a, kit_error *err)
{
    static const int large[SIZES][2] = { { 1920, 1080 }, { 3840, 2160 } }, small[2] = { 480, 270 };
    static const kit_light sun = { KIT_SUN, { 0.4f, 0.8f, 0.45f }, { 3, 2.8f, 2.4f } };
    if (kit_gl_open(a->context, err) || kit_scene_load(&b->scene, a->scene, 0, err)
        || kit_env_read(&b->sky.env, "sky", err))
        return -1;
    b->software = kit_gl_is_software();
    b->sizes = b->software ? 1 : SIZES;
    memcpy(b->size, large, sizeof large);
    if (b->software) memcpy(b->size[0], small, sizeof small);
    b->both = b->sky;
    b->both.lights = 1;
    b->both.light[0] = sun;
    b->count = rows_new(b->row, a->method, b->software, err);
    return b->count < 0 ? -1 : 0;
}

/* What the scene's back faces take, where a row asks for them; anew: the first was of a cold program. */
static void time_slabs(row *r, int s, int round, kit_gbuffer *g, const kit_scene *scene)
{
    const int behind = r->method.set.behind, two = behind == SSGI_GL_THICKNESS_SLABS;
    if (behind < SSGI_GL_THICKNESS_BACK || kit_gbuffer_slabs(g, scene, 1 + two, NULL)) return;
    r->slabs[s] = round ? fmin(r->slabs[s], g->slab_ms[two]) : g->slab_ms[two];
}

/* All rows at one size. A row that cannot be drawn says why, and is left out from then on. */
static int bench_size(bench *b, int s, const options *a, kit_error *err)
{
    const kit_world world = { &b->scene, &b->sky }, with_sun = { &b->scene, &b->both };
    kit_camera camera = b->scene.camera;
    kit_gbuffer g;
    camera.width = b->size[s][0];
    camera.height = b->size[s][1];
    if (kit_gbuffer_from_scene(&g, &b->scene, &camera, NULL, err)) return -1;
    for (int k = 0; k < (b->software ? 1 : ROUNDS); ++k)
        for (int i = 0; i < b->count; ++i) {
            row *r = &b->row[i];
            const int lamp = !strcmp(r->method.name, "dss-gloss") || !strcmp(r->method.name, "dss-scatter");
            kit_error why;
            if (!*r->why && measure(r, s, &g, b->scene.radius, lamp ? &with_sun : &world, &why))
                snprintf(r->why, sizeof r->why, "%.150s", why.text);
            time_slabs(r, s, k, &g, &b->scene);
            kit_progress(s ? "3840x2160" : "1920x1080",
                         ((double)k * b->count + i + 1) / (b->count * (ROUNDS + 0.01)));
        }
    const int wants_plan = !s && !a->method && !b->software,
              failed = wants_plan ? plan_csv("report/plan-gpu.csv", &g, b->scene.radius, &world, err) : 0;
    kit_progress("", 1);
    if (!failed) kit_gbuffer_free(&g);
    return failed;
}

int main(int argc, char **argv)
{
    static bench b;
    kit_error err = { "" };
    options a;
    kit_streams_open();
    int failed = parse(&a, argc, argv, &err) || bench_open(&b, &a, &err);
    for (int s = 0; s < b.sizes && !failed; ++s) failed = bench_size(&b, s, &a, &err);
    failed = failed || print_both(&b, &a, &err);
    kit_fields_free();
    kit_image_free(&b.sky.env);
    kit_scene_free(&b.scene);
    if (!failed) failed = kit_streams_close(&err);
    if (failed) { fprintf(stderr, "bench: %s\n", err.text); return 2; }
    kit_gl_close();
    return 0;
}
