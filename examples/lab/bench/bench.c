/* bench.c - measures the time of every method on this machine's GPU, the bounds of that time, and the plan's costs.
   --help lists the options.

   Times every method of build/render --list at its defaults, and some settings that engines ask about. All rows are
   timed in turn, in several rounds, so that a change of the clock or of the load affects all of them. This takes less
   than five minutes on a GPU; without one, less than ten for few rows at small sizes, and the tables say so. With all
   methods on a GPU the plan's choices are measured, too. --plan NUMBER measures that choice alone. */
#include "lab/bench/bench.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/measure/folder.h"

/* The bench's limits in seconds: for all rows, and the part of it that the plan's choices may take. */
enum { LIMIT_GPU = 270, LIMIT_SOFTWARE = 480 };

#define PLAN_SHARE 0.3

/* The options, as indices of their values (NULL: not given), and their table. */
enum { CONTEXT, SCENE, METHOD, SIZE, OUT, PLAN, SECONDS, OPTIONS };
typedef const char *options[OPTIONS];
#define VALUE(k) .kind = KIT_TEXT, .at = (k) * sizeof(const char *)
static const char usage[] = "bench [options]";
static const kit_option table[] = {
    { .about = "Measures the milliseconds of every method on this machine's GPU, and the planner's costs there. It "
               "takes less than five minutes; without a GPU it measures few methods on the CPU, in less than ten. "
               "It prints a table, and writes bench.csv, plan-gpu.csv and report/index.html." },
    { "--context", "NAME", "egl, egl-es or osmesa: the source of the GL context [egl, or osmesa where there is "
                           "none].", VALUE(CONTEXT) },
    { "--scene", "NAME", "The scene, as build/render takes it [room].", VALUE(SCENE) },
    { "--method", "NAME", "Methods whose names begin so, without the planner's choices.", VALUE(METHOD) },
    { "--size", "WxH,..", "The sizes of the image [1920x1080,2560x1440,3840x2160; on a CPU 640x360].", VALUE(SIZE) },
    { "--plan", "yes | no | N", "Whether the planner's choices are measured, or that choice alone.", VALUE(PLAN) },
    { "--seconds", "N", "The time for everything, 1 to 86400 [270; on a CPU 480].", VALUE(SECONDS) },
    { "--out", "FOLDER", "The folder to write into [report].", VALUE(OUT) },
    { NULL }
};

/* Sets the choices of the plan to time and the time limits: by the options, or else to the context's defaults. */
static int limits_of(bench *b, options a, kit_error *err)
{
    int only = -1;
    b->planned = a[PLAN] ? strcmp(a[PLAN], "no") != 0 : !a[METHOD] && !kit_gl_is_software();
    b->seconds = kit_gl_is_software() ? LIMIT_SOFTWARE : LIMIT_GPU;
    if (b->planned && a[PLAN] && strcmp(a[PLAN], "yes")
        && kit_whole("", a[PLAN], 0, SSGI_PLAN_CHOICES - 1, &only, NULL))
        return kit_fail(err, "--plan %s: must be yes, no or 0..%d", a[PLAN], SSGI_PLAN_CHOICES - 1);
    if (a[SECONDS] && kit_whole("--seconds", a[SECONDS], 1, 86400, &b->seconds, err)) return -1;
    return b->planned ? plan_choose(&b->plan, only, err) : 0;
}

static int sizes_of(bench *b, const char *text, kit_error *err)
{
    enum { MOST = 16384 };

    const char *const all = text;
    for (b->sizes = 0; b->sizes < BENCH_SIZES;) {
        int *size = b->size[b->sizes++], n = 0;
        if (sscanf(text, "%dx%d%n", &size[0], &size[1], &n) != 2 || (text[n] && text[n] != ',') || size[0] < 8
            || size[1] < 8 || size[0] > MOST || size[1] > MOST)
            break;
        if (!text[n]) return 0;
        text += n + 1;
    }
    return kit_fail(err, "--size %s: must be up to %d of 8x8 .. %dx%d, by commas", all, BENCH_SIZES, MOST, MOST);
}

/* Opens a GL context. Without a context's name: EGL's, or the CPU's if there is no EGL. */
static int context_open(const char *context, kit_error *err)
{
    if (context || !kit_gl_open("egl", err)) return context ? kit_gl_open(context, err) : 0;
    fprintf(stderr, "bench: %s\nbench: no GPU is found that way; the CPU draws\n", err->text);
    return kit_gl_open(NULL, err);
}

static int bench_open(bench *b, options a, kit_error *err)
{
    static const kit_light sun = { KIT_SUN, { 0.4f, 0.8f, 0.45f }, { 3, 2.8f, 2.4f } };
    if (context_open(a[CONTEXT], err)) return -1;
    const char *size = a[SIZE] ? a[SIZE] : kit_gl_is_software() ? "640x360" : "1920x1080,2560x1440,3840x2160";
    if (sizes_of(b, size, err) || limits_of(b, a, err)
        || kit_scene_load(&b->scene, a[SCENE] ? a[SCENE] : "room", 0, err)
        || kit_env_read(&b->sky.env, "sky", err))
        return -1;
    b->both = b->sky;
    b->both.lights = 1;
    b->both.light[0] = sun;
    b->count = rows_new(b->row, a[METHOD], err);
    return b->count < 0 || folder_make(a[OUT], err) ? -1 : 0;
}

/* Times the rows at size s. end: when the rows, the plan's choices (0: not at this size) and the bench must end. */
static int bench_size(bench *b, int s, const double end[3], kit_error *err)
{
    kit_camera camera = b->scene.camera;
    kit_gbuffer g;
    camera.width = b->size[s][0];
    camera.height = b->size[s][1];
    if (kit_gbuffer_from_scene(&g, &b->scene, &camera, NULL, err)) return -1;
    place p = {
        &g, &b->scene, &b->sky, &b->both, end[0], end[2], (1 - PLAN_SHARE * b->planned) / (b->sizes * BENCH_ROUNDS)
    };
    int failed = 0, k = 0;
    for (double longest = 0; k < BENCH_ROUNDS && !failed && (!k || kit_seconds() + longest < end[0]); ++k) {
        const double began = kit_seconds();
        p.end = began + (end[0] - began) / (BENCH_ROUNDS - k);
        rows_round(b->row, b->count, s, &p);
        failed = peaks_measure(&b->best, err);
        longest = kit_seconds() - began;
    }
    rows_progress(p.share * (BENCH_ROUNDS - k));
    p.end = end[1];
    p.share = PLAN_SHARE / BENCH_PLAN_ROUNDS;
    if (!failed && end[1] > 0) failed = plan_measure(&b->plan, &p, err);
    kit_gbuffer_free(&g);
    return failed;
}

static int bench_all(bench *b, kit_error *err)
{
    const double began = kit_seconds(), limit = b->seconds, plan = b->planned ? PLAN_SHARE * limit : 0;
    int failed = 0;
    rows_progress(0);
    for (int s = 0; s < b->sizes && !failed; ++s) {
        /* The plan's choices are timed after the first size. The other sizes share the time that is left. */
        const double now = kit_seconds(), rows = now + (began + limit - now - (s ? 0 : plan)) / (b->sizes - s);
        /* the first size is drawn however long it takes */
        const double end[3] = { rows, b->planned && !s ? rows + plan : 0, s ? began + limit : HUGE_VAL };
        failed = bench_size(b, s, end, err);
    }
    kit_progress("bench", 1);
    return failed;
}

int main(int argc, char **argv)
{
    static bench b;
    kit_error err = { "" };
    options a = { [OUT] = "report" };
    if (kit_help(argc, argv, usage, table)) return 0;
    kit_streams_open();
    int failed = kit_options(a, table, argc, argv, NULL, &err) || bench_open(&b, a, &err) || bench_all(&b, &err)
              || show_all(stdout, &b, a[OUT], &err);
    kit_fields_free();
    kit_image_free(&b.sky.env);
    kit_scene_free(&b.scene);
    if (!failed) failed = kit_streams_close(&err);
    if (failed) {
        fprintf(stderr, "bench: %s\n", err.text);
        return 2;
    }
    kit_gl_close();
    return 0;
}
