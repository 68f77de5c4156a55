/* show.c - what was measured as tables and a chart. Declared in bench.h. */
#include "lab/bench/bench.h"
#include <math.h>
#include <string.h>
#include "lab/page/page.h"
#include "lab/page/svg.h"

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
    fprintf(f, "| `%s`%s%s%s |", r->method.name, *r->set ? " `" : "", r->set, *r->set ? "`" : "");
}

static void text_times(FILE *f, const bench *b, bench_row *r)
{
    char n[3][24];
    row_name(f, r);
    for (int s = 0; s < b->sizes; ++s) {
        timing *t = &r->at[s];
        double q[3];
        if (!t->rounds) {
            fputs(" |", f);
            continue;
        }
        rows_quartiles(q, t->ms, t->frames);
        fprintf(f, " %s (%s-%s) |", number(n[1], q[1]), number(n[0], q[0]), number(n[2], q[2]));
    }
    if (*r->why) fprintf(f, " not drawn: %s", r->why);
    for (int k = 0; k < r->at[0].parts; ++k)
        fprintf(f, "%s %s %s", k ? "," : "", r->at[0].part[k].name,
                number(n[0], kit_median(r->at[0].part[k].ms, r->at[0].rounds)));
    if (r->at[0].slabs > 0) fprintf(f, "; and the scene's back faces %s", number(n[0], r->at[0].slabs));
    fputs(" |\n", f);
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
    fprintf(f, " %s |", number(n, q[1]));
    fprintf(f, " %s |", number(n, t->cost.bytes * 1e-6));
    fprintf(f, " %s |", number(n, t->cost.bytes * 1e-6 / q[1]));
    fprintf(f, " %.0f %% |", 100 * ms[BOUND_TRAFFIC] / q[1]);
    for (int k = 0; k < BOUNDS; ++k) fprintf(f, " %s |", number(n, ms[k]));
    fprintf(f, " %s, %.0f %% |\n", bound_name[largest], 100 * ms[largest] / q[1]);
}

static void text_head(FILE *f, const bench *b)
{
    int most = 0, rounds = 0;
    for (int i = 0; i < b->count; ++i)
        for (int s = 0; s < b->sizes; ++s) {
            most = b->row[i].at[s].frames > most ? b->row[i].at[s].frames : most;
            rounds = b->row[i].at[s].rounds > rounds ? b->row[i].at[s].rounds : rounds;
        }
    fprintf(f, "`%s` on %s: `%s`, %zu triangles.\n", b->command, kit_gl_name(), b->scene.name, b->scene.mesh.triangles);
    if (kit_gl_is_software())
        fputs("**No GPU was found: a CPU drew this, small, few rows. These times say nothing about a GPU.**\n", f);
    fprintf(f,
            "Milliseconds of a frame by %s, median (quartiles) of up to %d frames in up to %d rounds of all rows; "
            "passes: each timed alone, so that together they may take longer than the frame.\n",
            kit_timer_name(), most, rounds);
}

static void text_peaks(FILE *f, const bench *b)
{
    char n[3][24];
    fprintf(f,
            "\nWhat bounds these times, at %dx%d. In the same run full-screen passes copied %s GB/s (read and written, "
            "RGBA16F), fetched %s billion texels a second (R32F, neighbours) and made %s billion operations a second "
            "(a multiplication and an addition are two).\n",
            b->size[0][0], b->size[0][1], number(n[0], b->best.bytes * 1e-9), number(n[1], b->best.fetches * 1e-9),
            number(n[2], b->best.operations * 1e-9));
    fprintf(f,
            "Traffic, fetches, operations: the milliseconds that a frame's own would take at these rates.\n"
            "\n"
            "- traffic: every pass reads each texel of its inputs once and writes its outputs once; where a cache "
            "holds one pass's output for the next, a frame can take less;\n"
            "- fetches: the most that a pixel makes, read off the text, in the %.1f %% of the pixels that show a "
            "surface;\n"
            "- operations: the same of operators and calls, the dearer way through each branch, where one on a vector "
            "counts once and any call once: an estimate, mostly too low.\n"
            "\n"
            "A largest near 100 %% is what limits a row; where it is far below, waiting does: latency, caches that "
            "miss, small passes.\n",
            100 * b->covered);
}

static void text_plan(FILE *f, const bench *b)
{
    char n[24];
    fprintf(f,
            "\nThe plan's costs on this machine, in unblurred 16-sample `ssao`s at %dx%d, each measured right after "
            "one; %s.\n\n| choice | method, settings | cost |\n|--:|---|--:|\n",
            b->size[0][0], b->size[0][1],
            kit_gl_is_software() ? "a CPU's, which the table of ssgi.h has from `make fit`"
                                 : "`make fit` puts them into ssgi.h's second column, `make fit-gpu` them alone");
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i)
        if (b->plan.ratio[i] > 0) fprintf(f, "| %d | `%s` | %s |\n", i, b->plan.text[i], number(n, b->plan.ratio[i]));
}

void show_text(FILE *f, bench *b)
{
    text_head(f, b);
    fputs("\n| method | ", f);
    for (int s = 0; s < b->sizes; ++s) fprintf(f, "%dx%d | ", b->size[s][0], b->size[s][1]);
    fprintf(f, "passes at %dx%d |\n|---|", b->size[0][0], b->size[0][1]);
    for (int s = 0; s < b->sizes; ++s) fputs("--:|", f);
    fputs("---|\n", f);
    for (int i = 0; i < b->count; ++i) text_times(f, b, &b->row[i]);
    text_peaks(f, b);
    fputs("\n| method | ms | MB a frame | GB/s | of copying | traffic | fetches | operations | largest, of the time |\n"
          "|---|--:|--:|--:|--:|--:|--:|--:|---|\n",
          f);
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

/* ---- >>chart ----------------------------------------------------------------------------------------------------- */

/* of a row; where the scale begins, and the first row lies */
enum { HIGH = 26, LEFT = 260, FIRST = 128 };

typedef struct axis {
    double least, most;
} axis; /* logarithms to base ten */

static double across(const axis *a, double ms)
{
    return LEFT + (SVG_RIGHT - LEFT) * fmin(1, fmax(0, (log10(ms) - a->least) / (a->most - a->least)));
}

/* Whole powers of ten around times and bounds. */
static axis axis_of(const bench *b)
{
    axis a = { HUGE_VAL, -HUGE_VAL };
    for (int i = 0; i < b->count; ++i) {
        const timing *t = &b->row[i].at[0];
        double v[BOUNDS + 1];
        if (!t->rounds) continue;
        peaks_bounds(v, &b->best, &t->cost, b->covered);
        v[BOUNDS] = t->ms[t->frames / 2];
        for (int k = 0; k <= BOUNDS; ++k)
            if (v[k] > 0) {
                a.least = fmin(a.least, floor(log10(v[k])));
                a.most = fmax(a.most, ceil(log10(v[k])));
            }
    }
    return a.most > a.least ? a : (axis){ -2, 2 };
}

static void chart_axis(FILE *f, const axis *a, int bottom)
{
    for (double k = a->least; k <= a->most; k += 1) {
        const double x = across(a, pow(10, k));
        fprintf(f,
                "<path d=\"M%.1f %dV%d\" stroke=\"#dddddd\"/><text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g"
                "</text>\n",
                x, FIRST - HIGH / 2, bottom, x, bottom + 18, pow(10, k));
    }
    fprintf(f, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">milliseconds, as logarithms</text>\n",
            (LEFT + SVG_RIGHT) / 2, bottom + 38);
}

static void chart_legend(FILE *f, const bench *b)
{
    char about[400];
    snprintf(about, sizeof about, "%.120s%s, %dx%d", kit_gl_name(), kit_gl_is_software() ? ": a CPU, no GPU" : "",
             b->size[0][0], b->size[0][1]);
    fprintf(f, "<text x=\"%d\" y=\"56\">", SVG_LEFT);
    page_escaped(f, about);
    fprintf(f,
            "</text>\n<path stroke=\"#cfd4da\" stroke-width=\"12\" d=\"M%d 80h14\"/><path stroke=\"#111\" "
            "stroke-width=\"3\" d=\"M%d 73v14\"/><text x=\"%d\" y=\"84.5\">time "
            "(median; line: quartiles)</text>\n",
            SVG_LEFT, SVG_LEFT + 14, SVG_LEFT + 22);
    for (int k = 0; k < BOUNDS; ++k) {
        const int x = SVG_LEFT + 250 + 130 * k;
        fputs("<path ", f);
        svg_marker(f, k, svg_colour(k), x, 80);
        fprintf(f, "/><text x=\"%d\" y=\"84.5\">%s</text>\n", x + 12, bound_name[k]);
    }
    fprintf(f,
            "<text x=\"%d\" y=\"104\" font-size=\"11\">marks: what each alone would take at the machine's best rate"
            "</text>\n",
            SVG_LEFT + 242);
}

static void chart_row(FILE *f, const bench *b, bench_row *r, const axis *a, double y)
{
    timing *t = &r->at[0];
    double q[3], bound[BOUNDS];
    peaks_bounds(bound, &b->best, &t->cost, b->covered);
    rows_quartiles(q, t->ms, t->frames);
    fprintf(f, "<text x=\"%d\" y=\"%.1f\" font-size=\"12\" text-anchor=\"end\" fill=\"#222\">%s %s</text>\n", LEFT - 10,
            y + 4, r->method.name, r->set);
    fprintf(f,
            "<path d=\"M%d %.1fH%.1f\" stroke=\"#cfd4da\" stroke-width=\"12\"/><path d=\"M%.1f %.1fv14\" "
            "stroke=\"#111\" stroke-width=\"3\"/><path d=\"M%.1f %.1fH%.1f\" stroke=\"#111\" stroke-width=\"1.5\"/>\n",
            LEFT, y, across(a, q[1]), across(a, q[1]), y - 7, across(a, q[0]), y, across(a, q[2]));
    for (int k = 0; k < BOUNDS; ++k) {
        if (!(bound[k] > 0)) continue;
        fputs("<path ", f);
        svg_marker(f, k, svg_colour(k), across(a, bound[k]), y + 6 * (k - 1));
        fputs("/>\n", f);
    }
}

static void chart(FILE *f, bench *b)
{
    const axis a = axis_of(b);
    int rows = 0;
    for (int i = 0; i < b->count; ++i) rows += b->row[i].at[0].rounds > 0;
    const int bottom = FIRST + HIGH * rows - HIGH / 2;
    svg_begin_high(f, "Time of each method, and what bounds it", bottom + 52);
    chart_legend(f, b);
    chart_axis(f, &a, bottom);
    rows = 0;
    for (int i = 0; i < b->count; ++i)
        if (b->row[i].at[0].rounds) chart_row(f, b, &b->row[i], &a, FIRST + HIGH * rows++);
    fputs("</svg>\n", f);
}

/* ---- >>all ------------------------------------------------------------------------------------------------------- */

int show_all(bench *b, const char *folder, kit_error *err)
{
    const struct {
        const char *name;
        void (*show)(FILE *, bench *);
        int there;
    } files[] = { { "bench.md", show_text, 1 },
                  { "bench.csv", csv_all, 1 },
                  { "bench.svg", chart, 1 },
                  { show_plan_name(), csv_plan, b->planned } };

    for (size_t i = 0; i < sizeof files / sizeof *files; ++i) {
        page p;
        if (!files[i].there) continue;
        if (page_open(&p, err)) return -1;
        files[i].show(p.file, b);
        if (page_close(&p, folder, files[i].name, err)) return -1;
    }
    return 0;
}
