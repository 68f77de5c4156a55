/* show.c - what was measured as text, csv and a record. Declared in bench.h. */
#include "lab/bench/bench.h"
#include <math.h>
#include <string.h>
#include "lab/page/page.h"

/* Three digits; of hundreds all. */
static const char *number(char text[24], double v)
{
    const int decimals = !(v > 0) ? 0 : 2 - (int)floor(log10(v));
    snprintf(text, 24, "%.*f", decimals < 0 ? 0 : decimals > 4 ? 4 : decimals, v);
    return text;
}

/* ---- >>text ------------------------------------------------------------------------------------------------------ */

static void row_name(FILE *f, const bench_row *r)
{
    char name[96];
    snprintf(name, sizeof name, "%s%s%s", r->method.name, *r->set ? " " : "", r->set);
    fprintf(f, "%-32s", name);
}

static void text_times(FILE *f, const bench *b, bench_row *r)
{
    char n[3][24], all[80];
    row_name(f, r);
    for (int s = 0; s < b->sizes; ++s) {
        timing *t = &r->at[s];
        double q[3];
        if (!t->rounds) {
            fprintf(f, " %24s", "-");
            continue;
        }
        rows_quartiles(q, t->ms, t->frames);
        snprintf(all, sizeof all, "%s (%s-%s)", number(n[1], q[1]), number(n[0], q[0]), number(n[2], q[2]));
        fprintf(f, " %24s", all);
    }
    if (*r->why) fprintf(f, "  not drawn: %s", r->why);
    for (int k = 0; k < r->at[0].parts; ++k)
        fprintf(f, "%s %s %s", k ? "," : " ", r->at[0].part[k].name,
                number(n[0], kit_median(r->at[0].part[k].ms, r->at[0].rounds)));
    if (r->at[0].slabs > 0) fprintf(f, "; and the scene's back faces %s", number(n[0], r->at[0].slabs));
    fputc('\n', f);
}

static void text_bounds(FILE *f, const bench *b, bench_row *r)
{
    timing *t = &r->at[0];
    double q[3], ms[BOUNDS];
    char n[24];
    if (!t->rounds) return;
    const int largest = peaks_bounds(ms, &b->best, &t->cost, b->covered);
    rows_quartiles(q, t->ms, t->frames);
    row_name(f, r);
    fprintf(f, " %9s", number(n, q[1]));
    fprintf(f, " %9s", number(n, t->cost.bytes * 1e-6));
    fprintf(f, " %9s", number(n, t->cost.bytes * 1e-6 / q[1]));
    for (int k = 0; k < BOUNDS; ++k) fprintf(f, " %10s", number(n, ms[k]));
    fprintf(f, "  %s, %.0f %%\n", bound_name[largest], 100 * ms[largest] / q[1]);
}

static int most_of(const bench *b, int frames)
{
    int most = 0;
    for (int i = 0; i < b->count; ++i)
        for (int s = 0; s < b->sizes; ++s) {
            const int n = frames ? b->row[i].at[s].frames : b->row[i].at[s].rounds;
            most = n > most ? n : most;
        }
    return most;
}

/* What stands above the times, and above their bounds: for people and for the record. */
static void about_times(char out[1200], const bench *b)
{
    snprintf(out, 1200,
             "%s on %s: %s, %zu triangles.%s Milliseconds of a frame by %s, median (quartiles) of up to %d frames in "
             "up to %d rounds of all rows; passes: each timed alone, so that together they may take longer than the "
             "frame.",
             b->command, kit_gl_name(), b->scene.name, b->scene.mesh.triangles,
             kit_gl_is_software()
                 ? " No GPU was found: a CPU drew this, small, few rows. These times say nothing about a GPU."
                 : "",
             kit_timer_name(), most_of(b, 1), most_of(b, 0));
}

static void about_bounds(char out[1600], const bench *b)
{
    char n[3][24];
    snprintf(out, 1600,
             "What bounds these times, at %dx%d. In the same run full-screen passes copied %s GB/s (read and written, "
             "RGBA16F), fetched %s billion texels a second (R32F, neighbours) and made %s billion operations a second "
             "(a multiplication and an addition are two). Traffic, fetches, operations: the milliseconds that a "
             "frame's own would take at these rates. Traffic: every pass reads each texel of its inputs once and "
             "writes its outputs once; where a cache holds one pass's output for the next, a frame can take less. "
             "Fetches: the most that a pixel makes, read off the text, in the %.1f %% of the pixels that show a "
             "surface. Operations: the same of operators and calls, the dearer way through each branch, where one on a "
             "vector counts once and any call once: an estimate, mostly too low. A largest near 100 %% is what limits "
             "a row; where it is far below, waiting does: latency, caches that miss, small passes.",
             b->size[0][0], b->size[0][1], number(n[0], b->best.bytes * 1e-9), number(n[1], b->best.fetches * 1e-9),
             number(n[2], b->best.operations * 1e-9), 100 * b->covered);
}

static void text_plan(FILE *f, const bench *b)
{
    char n[24];
    fprintf(f,
            "\nThe plan's costs on this machine, in unblurred 16-sample ssaos at %dx%d, each measured right after one; "
            "%s.\n",
            b->size[0][0], b->size[0][1],
            kit_gl_is_software() ? "a CPU's, which the table of ssgi.h has from make fit"
                                 : "make fit puts them into ssgi.h's second column, make fit-gpu them alone");
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i)
        if (b->plan.ratio[i] > 0) fprintf(f, "%3d  %-60s %s\n", i, b->plan.text[i], number(n, b->plan.ratio[i]));
}

void show_text(FILE *f, bench *b)
{
    char about[1600], size[32];
    about_times(about, b);
    fprintf(f, "%s\n\n%-32s", about, "method, settings");
    for (int s = 0; s < b->sizes; ++s) {
        snprintf(size, sizeof size, "%dx%d", b->size[s][0], b->size[s][1]);
        fprintf(f, " %24s", size);
    }
    fprintf(f, "  passes at %dx%d\n", b->size[0][0], b->size[0][1]);
    for (int i = 0; i < b->count; ++i) text_times(f, b, &b->row[i]);
    about_bounds(about, b);
    fprintf(f, "\n%s\n\n%-32s %9s %9s %9s", about, "method, settings", "ms", "MB", "GB/s");
    for (int k = 0; k < BOUNDS; ++k) fprintf(f, " %10s", bound_name[k]);
    fputs("  largest, of the time\n", f);
    for (int i = 0; i < b->count; ++i) text_bounds(f, b, &b->row[i]);
    if (b->planned) text_plan(f, b);
}

/* ---- >>csv ------------------------------------------------------------------------------------------------------- */

static void csv_row(FILE *f, const bench *b, const bench_row *r, int s, const char *pass, double *ms, int count,
                    const kit_cost *cost)
{
    double q[3], bound[BOUNDS];
    rows_quartiles(q, ms, count);
    peaks_bounds(bound, &b->best, cost, b->covered);
    fprintf(f, "%s,\"%s\",%d,%d,%s,%d,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g", r->method.name, r->set, b->size[s][0],
            b->size[s][1], pass, count, q[1], q[0], q[2], cost->bytes, b->covered * cost->fetches,
            b->covered * cost->operations);
    for (int k = 0; k < BOUNDS; ++k) fprintf(f, ",%.6g", bound[k]);
    fputc('\n', f);
}

static void csv_all(FILE *f, bench *b)
{
    fputs("method,settings,width,height,pass,measured,ms,lower_quartile,upper_quartile,bytes,fetches,operations", f);
    for (int k = 0; k < BOUNDS; ++k) fprintf(f, ",%s_ms", bound_name[k]);
    fputc('\n', f);
    for (int i = 0; i < b->count; ++i)
        for (int s = 0; s < b->sizes; ++s) {
            timing *t = &b->row[i].at[s];
            if (!t->rounds) continue;
            csv_row(f, b, &b->row[i], s, "frame", t->ms, t->frames, &t->cost);
            for (int k = 0; k < t->parts; ++k)
                csv_row(f, b, &b->row[i], s, t->part[k].name, t->part[k].ms, t->rounds, &t->part[k].cost);
        }
}

static void csv_plan(FILE *f, bench *b)
{
    fprintf(f, "# %s, %dx%d, %s\n", kit_gl_name(), b->size[0][0], b->size[0][1], b->scene.name);
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i)
        if (b->plan.ratio[i] > 0) fprintf(f, "%d,%g\n", i, b->plan.ratio[i]);
}

const char *show_plan_name(void) { return kit_gl_is_software() ? "plan-software.csv" : "plan-gpu.csv"; }

/* ---- >>all ------------------------------------------------------------------------------------------------------- */

int show_all(bench *b, const char *folder, kit_error *err)
{
    char about[1600];
    page record, csv, plan;
    if (page_begin(&record, "bench", "full", b->command, kit_gl_name(), err) || page_open(&csv, err)) return -1;
    page_heading(record.file, 2, "Milliseconds of each method, and what bounds them");
    about_times(about, b);
    page_paragraph(record.file, "%s", about);
    about_bounds(about, b);
    page_paragraph(record.file, "%s", about);
    csv_all(csv.file, b);
    if (page_csv(record.file, "bench", &csv, folder, "bench.csv", err) || page_end(&record, folder, "bench", err))
        return -1;
    if (!b->planned) return 0;
    if (page_open(&plan, err)) return -1;
    csv_plan(plan.file, b);
    return page_close(&plan, folder, show_plan_name(), err);
}
