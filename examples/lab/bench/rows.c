/* rows.c - times methods in turn. Declared in bench.h. */
#include "lab/bench/bench.h"
#include <math.h>
#include <string.h>

static const char *const more[][2] = { { "ssao", "directions=32" },  { "hsao", "normal=depth" },
                                       { "hsao", "thickness=back" }, { "hsao", "thickness=slabs" },
                                       { "hsao", "history=1" },   { "ssdo", "bounce=none" },
                                       { "ssdo", "reuse=1" } };
/* the methods that the bench times without a GPU, as there is no time for all */
static const char *const few[] = { "ssao", "hsao-fast", "hsao", "hsao-best", "ssdo", "s3ho" };

static int chosen(const char *name, const char *asked)
{
    int one_of = 0;
    for (size_t i = 0; i < sizeof few / sizeof *few; ++i) one_of |= !strcmp(name, few[i]);
    return asked ? !strncmp(name, asked, strlen(asked)) : one_of || !kit_gl_is_software(); /* asked "": all */
}

int rows_new(bench_row rows[BENCH_ROWS], const char *asked, kit_error *err)
{
    kit_method m;
    int count = 0;
    for (int i = 0; kit_method_at(&m, i) && count < BENCH_ROWS; ++i) {
        if (!chosen(m.name, asked)) continue;
        rows[count].method = m;
        rows[count++].set = "";
        if (!asked && kit_gl_is_software()) continue;
        for (size_t k = 0; k < sizeof more / sizeof *more && count < BENCH_ROWS; ++k) {
            if (strcmp(more[k][0], m.name)) continue;
            rows[count].method = m;
            rows[count].set = more[k][1];
            if (kit_method_set(&rows[count++].method, more[k][1], err)) return -1;
        }
    }
    return count ? count : kit_fail(err, "--method %s: there is none whose name begins so", asked);
}

void rows_quartiles(double quartile[3], double *v, int count)
{
    quartile[1] = kit_median(v, count);
    for (int k = 0; k < 3; k += 2) {
        const double at = 0.25 * (k + 1) * (count - 1);
        const int i = (int)at, next = i + 1 < count ? i + 1 : i;
        quartile[k] = v[i] + (at - i) * (v[next] - v[i]);
    }
}

/* ---- >>time ------------------------------------------------------------------------------------------------------ */

/* Returns the part of a timing that collects a pass's times; NULL: there are too many parts. */
static part *part_of(timing *t, const kit_pass *p)
{
    const char *name = ssgi_gl_pass_name(p->desc.pass);
    int k = 0;
    while (k < t->parts && strcmp(t->part[k].name, name)) ++k;
    if (k == BENCH_PARTS) return NULL;
    if (k == t->parts) t->part[t->parts++].name = name;
    return &t->part[k];
}

/* Notes how many bytes each pass of a frame moves, once, as they are the same in each round. */
static void note_bytes(timing *t, const kit_run *run)
{
    t->bytes = 0;
    for (int k = 0; k < t->parts; ++k) t->part[k].bytes = 0;
    for (int i = 0; i < run->passes; ++i) {
        const kit_pass *p = &run->pass[i];
        part *of = p->aside ? NULL : part_of(t, p);
        const double bytes = kit_pass_bytes(run, p);
        if (of) of->bytes += bytes;
        t->bytes += bytes;
    }
}

static int most_frames(void) { return kit_gl_is_software() ? BENCH_FRAMES / 4 : BENCH_FRAMES; }

/* Draws frames and times each pass alone. Adds the median times of passes that have one name. */
static int time_passes(timing *t, kit_run *run, unsigned n, double seconds, kit_error *err)
{
    static double ms[KIT_MAX_PASSES][BENCH_FRAMES];
    const double began = kit_seconds();
    int draws = 0;
    while (!draws || (draws < most_frames() && kit_seconds() < began + seconds)) {
        if (kit_frames_still(run, 0, n++, KIT_PASSES, err)) return -1;
        for (int i = 0; i < run->passes; ++i) ms[i][draws] = run->pass[i].ms;
        ++draws;
    }
    note_bytes(t, run);
    for (int k = 0; k < t->parts; ++k) t->part[k].ms[t->rounds] = 0;
    for (int i = 0; i < run->passes; ++i) {
        part *of = run->pass[i].aside ? NULL : part_of(t, &run->pass[i]);
        if (of) of->ms[t->rounds] += kit_median(ms[i], draws);
    }
    return 0;
}

/* Times the frames of a method. Warms up first, so that the GPU runs at its full clock. */
static int time_run(timing *t, kit_run *run, double seconds, int apart, kit_error *err)
{
    const double began = kit_seconds(), warming = kit_gl_is_software() ? 0 : 0.1;
    unsigned n = 0;
    do
        if (kit_frames_still(run, 0, n++, KIT_FRAME, err)) return -1;
    while (n < 200 && kit_seconds() < began + warming);
    const double warm = kit_seconds();
    for (int k = 0; k < most_frames() && (k < 3 || kit_seconds() < warm + seconds); ++k) {
        if (kit_frames_still(run, 0, n++, KIT_FRAME, err)) return -1;
        t->ms[t->frames++] = run->ms;
    }
    return apart ? time_passes(t, run, n, 0.5 * seconds, err) : 0;
}

int rows_time(timing *t, const kit_method *method, const place *p, double seconds, int apart, kit_error *err)
{
    static kit_run run;
    const int lamp = !strcmp(method->name, "dss-gloss") || !strcmp(method->name, "dss-scatter");
    const kit_world world = { p->scene, lamp ? p->both : p->sky };
    if (kit_run_open(&run, p->gbuffer, method, p->scene->radius, &world, err)) return -1;
    const int failed = time_run(t, &run, seconds, apart, err);
    kit_run_close(&run);
    if (!failed) ++t->rounds;
    return failed;
}

/* Draws a row's back faces once more, to time them: the first draw compiled the program. */
static void time_slabs(timing *t, const kit_method *m, const place *p)
{
    const int behind = m->set.thickness, two = behind == SSGI_GL_THICKNESS_SLABS;
    if (behind < SSGI_GL_THICKNESS_BACK || kit_gbuffer_slabs(p->gbuffer, p->scene, 1 + two, NULL)) return;
    t->slabs = t->rounds > 1 ? fmin(t->slabs, p->gbuffer->slab_ms[two]) : p->gbuffer->slab_ms[two];
}

void rows_progress(double more_)
{
    static double done;
    done += more_;
    kit_progress("bench", fmin(done, 0.999));
}

static void time_row(bench_row *r, int size, const place *p, double seconds)
{
    timing *t = &r->at[size];
    kit_error why;
    if (rows_time(t, &r->method, p, seconds, 1, &why)) snprintf(r->why, sizeof r->why, "%.150s", why.text);
    else time_slabs(t, &r->method, p);
}

void rows_round(bench_row *rows, int count, int size, const place *p)
{
    /* half of the time is drawing; the other half is left for compiling and warming up */
    const double seconds = fmax(0, 0.5 * (p->end - kit_seconds()) / count);
    for (int i = 0; i < count; ++i) {
        if (!*rows[i].why && kit_seconds() < p->last) time_row(&rows[i], size, p, seconds);
        rows_progress(p->share / count);
    }
}
