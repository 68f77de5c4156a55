/* show.c - the bench's results as csv, as text and as a record. Declared in bench.h. */
#include "lab/bench/bench.h"
#include <string.h>
#include "lab/measure/csv.h"
#include "lab/page/page.h"

#define KEYS "method,settings,width,height,pass,measured,ms,lower_quartile,upper_quartile,bytes,traffic_ms"

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

/* Writes the texts that explain the table of times and the table of bounds, for stdout and for the record. */
static void about_times(char out[1200], const bench *b)
{
    snprintf(out, 1200,
             "%s: %s, %zu triangles.%s Milliseconds of a frame by %s, median (quartiles) of up to %d frames in "
             "up to %d rounds of all rows; passes: each timed alone, so that together they may take longer than the "
             "frame.",
             kit_gl_name(), b->scene.name, b->scene.mesh.triangles,
             kit_gl_is_software()
                 ? " No GPU was found: a CPU drew this, small, few rows. These times say nothing about a GPU."
                 : "",
             kit_timer_name(), most_of(b, 1), most_of(b, 0));
}

static void about_bounds(char out[1600], const bench *b)
{
    snprintf(out, 1600,
             "The limits of these times, at %dx%d. In the same run full-screen passes copied %.3g GB/s (read and "
             "written, RGBA16F). Traffic: the milliseconds that a frame's own would take at this rate, if every"
             " pass reads each texel of its inputs once and writes its outputs once. If a cache holds one "
             "pass's output for the next, a frame can take less. Near 100 %% of the time, traffic limits a row. Far"
             " below, instructions limit it (make cost counts them), or waiting: latency, caches that miss, small "
             "passes.",
             b->size[0][0], b->size[0][1], b->best * 1e-9);
}

/* ---- >>csv ------------------------------------------------------------------------------------------------------- */

static void csv_row(FILE *f, const bench *b, const bench_row *r, int s, const char *pass, double *ms, int count,
                    double bytes)
{
    double q[3];
    rows_quartiles(q, ms, count);
    fprintf(f, "%s,\"%s\",%d,%d,%s,%d,%.6g,%.6g,%.6g,%.6g,%.6g\n", r->method.name, r->set, b->size[s][0],
            b->size[s][1], pass, count, q[1], q[0], q[2], bytes, bytes / b->best * 1e3);
}

static void csv_all(FILE *f, bench *b)
{
    fputs(KEYS "\n", f);
    for (int i = 0; i < b->count; ++i)
        for (int s = 0; s < b->sizes; ++s) {
            timing *t = &b->row[i].at[s];
            if (!t->rounds) continue;
            csv_row(f, b, &b->row[i], s, "frame", t->ms, t->frames, t->bytes);
            for (int k = 0; k < t->parts; ++k)
                csv_row(f, b, &b->row[i], s, t->part[k].name, t->part[k].ms, t->rounds, t->part[k].bytes);
        }
}

static void csv_plan(FILE *f, const bench *b)
{
    fprintf(f, "# %s, %dx%d, %s\n", kit_gl_name(), b->size[0][0], b->size[0][1], b->scene.name);
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i)
        if (b->plan.ratio[i] > 0) fprintf(f, "%d,%g\n", i, b->plan.ratio[i]);
}

/* ---- >>all ------------------------------------------------------------------------------------------------------- */

/* Prints the csv as a text, and below it the rows that could not be drawn. */
static void text_all(FILE *f, const bench *b, const csv *c, const char *times, const char *bounds)
{
    fprintf(f, "%s\n\n%s\n\n", times, bounds);
    csv_put(f, c, KEYS, NULL, 1);
    for (int i = 0; i < b->count; ++i) {
        const bench_row *r = &b->row[i];
        if (*r->why) fprintf(f, "%s %s: not drawn: %s\n", r->method.name, r->set, r->why);
        if (r->at[0].slabs > 0)
            fprintf(f, "%s %s: and the scene's back faces %.3g ms\n", r->method.name, r->set, r->at[0].slabs);
    }
    if (!b->planned) return;
    fprintf(f, "\nThe plan's costs on this machine, in unblurred 16-sample ssaos at %dx%d, each measured right after "
               "one; %s.\n", b->size[0][0], b->size[0][1],
            kit_gl_is_software() ? "a CPU's, which the table of ssgi.h has from make fit"
                                 : "make fit puts them into ssgi.h's second column, make fit-gpu them alone");
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i)
        if (b->plan.ratio[i] > 0) fprintf(f, "%3d  %-60s %.3g\n", i, b->plan.text[i], b->plan.ratio[i]);
}

int show_all(FILE *f, bench *b, const char *folder, kit_error *err)
{
    char times[1200], bounds[1600];
    page record, table, plan;
    if (page_begin(&record, "bench", "full", "make bench", kit_gl_name(), err) || page_open(&table, err)) return -1;
    about_times(times, b);
    about_bounds(bounds, b);
    page_heading(record.file, 2, "Milliseconds of each method, and their limits");
    page_paragraph(record.file, "%s", times);
    page_paragraph(record.file, "%s", bounds);
    csv_all(table.file, b);
    fflush(table.file);
    const csv all = csv_of(strdup(table.text), "bench.csv");
    text_all(f, b, &all, times, bounds);
    if (page_csv(record.file, "bench", &table, folder, "bench.csv", err) || page_end(&record, folder, "bench", err))
        return -1;
    if (!b->planned) return 0;
    if (page_open(&plan, err)) return -1;
    csv_plan(plan.file, b);
    return page_close(&plan, folder, kit_gl_is_software() ? "plan-software.csv" : "plan-gpu.csv", err);
}
