/* fit.c - fits the table of choices in ssgi.h's room >>plan to the measurements of "report fit": --help says how.

   A choice's squared error is a sum of terms, each times a number that is at least 0. These numbers are found by least
   squares of relative errors, one after another. */
#define SSGI_STATIC
#define SSGI_IMPLEMENTATION
#include "../../ssgi.h"
#include <stdio.h>
#include <stdlib.h>

enum { MOST_ROWS = 8192, MOST_TERMS = SSGI__PLAN_TERMS };
/* A line of the csv. cost: in software; predicted if it was not timed. captured: a frame's survey without slabs. */
typedef struct measured {
    char            view[64];
    ssgi_plan_scene scene;
    ssgi_survey     captured;
    int             choice, timed;
    double          error, cost;
} measured;
typedef struct equation { double term[MOST_TERMS], square; } equation;

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Finds x by least squares. Weights follow predicted errors, so that residues are about those of the logarithm. */
static double solve(double x[MOST_TERMS], const equation *rows, int count, int terms)
{
    double residue = 0;
    for (int k = 0; k < terms; ++k) x[k] = 0;
    for (int round = 0; round < 5; ++round) {
        double normal[MOST_TERMS][MOST_TERMS] = { { 0 } }, right[MOST_TERMS] = { 0 };
        for (int i = 0; i < count; ++i) {
            double at = 0;
            for (int k = 0; k < terms; ++k) at += x[k] * rows[i].term[k];
            const double w = 1 / (rows[i].square * fmax(round ? at : rows[i].square, 0.05 * rows[i].square));
            for (int k = 0; k < terms; ++k) {
                right[k] += w * rows[i].term[k] * rows[i].square;
                for (int l = 0; l < terms; ++l) normal[k][l] += w * rows[i].term[k] * rows[i].term[l];
            }
        }
        for (int step = 0; step < 20000; ++step)
            for (int k = 0; k < terms; ++k) {
                double v = right[k];
                if (!(normal[k][k] > 0)) continue;
                for (int l = 0; l < terms; ++l) v -= normal[k][l] * x[l];
                x[k] = fmax(0, x[k] + v / normal[k][k]);
            }
    }
    for (int i = 0; i < count; ++i) {
        double at = 1e-12;
        for (int k = 0; k < terms; ++k) at += x[k] * rows[i].term[k];
        residue += pow(0.5 * log(at / rows[i].square), 2);
    }
    return count ? sqrt(residue / count) : 0;
}

/* Prints a number as a C literal, such as .12f, with at most three decimals, or 0; then end. Pads it before a comma. */
static void literal(double v, int width, const char *end)
{
    char text[32], padded[40];
    size_t n = (size_t)snprintf(text, sizeof text, "%.*f", v < 0.1 ? 3 : v < 10 ? 2 : 1, v);
    while (n > 3 && text[n - 1] == '0' && text[n - 2] != '.') text[--n] = 0;
    snprintf(padded, sizeof padded, v > 0 ? "%sf%s" : "0%.0s%s", text + (*text == '0'), end);
    printf("%-*s", *end == ',' ? width + 2 : 0, padded);
}

/* Reads a line of plan-fit.csv into a row. */
static int read_row(measured *m, int *fits, const char *line)
{
    ssgi_plan_scene *s = &m->scene;
    float *const v[] = { &s->calibration.unoccluded, &s->calibration.hsao, &s->calibration.slabs, &s->calibration.fast,
                         &s->calibration.s3ho, &s->survey.occlusion, &s->survey.detail, &s->survey.solid,
                         &s->survey.slabs, &s->screen_radius,
                         &s->energy[0], &s->energy[1], &s->energy[2], &s->energy[3] };
    int at;
    memset(m, 0, sizeof *m);
    if (sscanf(line, "%63[^,],%d,%d,%d,%lf,%lf%n", m->view, fits, &s->wanted, &m->choice, &m->error, &m->cost, &at)
        != 6)
        return -1;
    for (size_t k = 0; k < sizeof v / sizeof *v; ++k) {
        int more;
        if (sscanf(line + at, ",%f%n", v[k], &more) != 1) return -1;
        at += more;
    }
    s->calibration.known = 1;
    m->timed = *fits == 1;
    return sscanf(line + at, ",%lf,%lf,%d,%f,%f,%f,%f", &s->surfels, &s->splats, &s->occluders, &s->coverage,
                  &m->captured.occlusion, &m->captured.detail, &m->captured.solid) == 7 ? 0 : -1;
}

/* Replaces a row's calibration, which is noisy from few places, by the errors measured on the whole view. */
static void know(measured *row, int count)
{
    for (int i = 0; i < count; ++i) {
        const ssgi__plan_row *r = &ssgi__plan_rows[row[i].choice];
        const int balanced = r->method == SSGI_PLAN_METHOD_HSAO && r->resolution == 1 && r->slices == 2
                          && r->samples == 8;
        for (int k = 0; k < count; ++k) {
            ssgi_calibration *c = &row[k].scene.calibration;
            if (row[i].scene.wanted != row[k].scene.wanted || strcmp(row[i].view, row[k].view)) continue;
            if (r->method == SSGI_PLAN_METHOD_NOTHING) c->unoccluded = (float)row[i].error;
            if (balanced && !r->thickness) c->hsao = (float)row[i].error;
            if (balanced && r->thickness == SSGI_PLAN_THICKNESS_SLABS) c->slabs = (float)row[i].error;
            if (r->thickness == SSGI_PLAN_THICKNESS_CONSTANT && r->resolution == 1) c->fast = (float)row[i].error;
            if (r->method == SSGI_PLAN_METHOD_S3HO && r->resolution == 1 && r->slices == 2 && r->bands == 4
                && !r->thickness)
                c->s3ho = (float)row[i].error;
        }
    }
}

static measured row[MOST_ROWS];
static equation equations[MOST_ROWS];

/* Terms of the cost of surfels: the choice's own cost (slices near by, the filter) at its resolution, the texels of its
   splats, the number of its surfels. */
enum { OF_FULL, OF_HALF, OF_QUARTER, OF_TEXELS, OF_SURFELS, SPLAT_TERMS };

static int own_term(const ssgi__plan_row *r)
{
    return r->resolution == SSGI__PLAN_QUARTER ? OF_QUARTER : r->resolution ? OF_HALF : OF_FULL;
}

/* Fits and prints the cost of splats in software. */
static void fit_splats(int count, double own[MOST_TERMS])
{
    int n = 0;
    for (int i = 0; i < count; ++i) {
        const ssgi__plan_row *r = &ssgi__plan_rows[row[i].choice];
        if (r->method != SSGI_PLAN_METHOD_DSS) continue;
        equations[n] = (equation){ { 0 }, row[i].cost };
        equations[n].term[own_term(r)] = 1;
        equations[n].term[OF_TEXELS] = row[i].scene.splats / ssgi__plan_drawn(r);
        equations[n++].term[OF_SURFELS] = row[i].scene.surfels;
    }
    const double spread = solve(own, equations, n, SPLAT_TERMS);
    fprintf(stderr, "splats: %.4g a texel, %.4g a surfel, spread %.3f of %d\n", own[OF_TEXELS], own[OF_SURFELS],
            2 * spread, n);
}

static const char *const wanted_names[] = { "visibility", "light", "bounce" };

/* Returns whether a line is the first of its view and wanted quantity. */
static int is_first(int i)
{
    return !i || row[i - 1].scene.wanted != row[i].scene.wanted || strcmp(row[i - 1].view, row[i].view) != 0;
}

/* Fits the prediction of a calibration from a survey alone, without slabs and with slabs. */
static void fit_survey(int count, int wanted, int with, int of)
{
    static const char *const names[3] = { "nothing", "hsao", "slabs" };
    double x[MOST_TERMS];
    int n = 0;
    for (int i = 0; i < count; ++i) {
        const ssgi_plan_scene *s = &row[i].scene;
        const ssgi_survey *of_frame = with ? &s->survey : &row[i].captured;
        const float known[3] = { s->calibration.unoccluded, s->calibration.hsao, s->calibration.slabs },
                    v[4] = { of_frame->occlusion, of_frame->detail, of_frame->solid, of_frame->slabs };
        if (s->wanted != wanted || !is_first(i)) continue;
        equations[n].square = (double)known[of] * (double)known[of];
        for (int k = 0; k < 4; ++k) equations[n].term[k] = k < 3 + with ? (double)v[k] * (double)v[k] : 0;
        ++n;
    }
    const double spread = solve(x, equations, n, 4);
    fprintf(stderr, "%s, survey %s slabs, %s: %.4g %.4g %.4g %.4g, spread %.3f of %d\n", wanted_names[wanted],
            with ? "with" : "without", names[of], x[0], x[1], x[2], x[3], spread, n);
}

/* Fits the prediction of the error of hsao's preset FAST, or of s3ho, from the others. */
static void fit_kin(int count, int wanted, int is_s3ho)
{
    double x[MOST_TERMS];
    int n = 0;
    for (int i = 0; i < count; ++i) {
        const ssgi_plan_scene *s = &row[i].scene;
        const double e = (double)s->calibration.unoccluded, hsao = (double)s->calibration.hsao,
                     own = (double)(is_s3ho ? s->calibration.s3ho : s->calibration.fast);
        if (s->wanted != wanted || !is_first(i)) continue;
        equations[n].square = own * own;
        equations[n].term[0] = e * e;
        equations[n].term[1] = hsao * hsao;
        equations[n++].term[2] = e * e * ssgi__plan_uneven(s);
    }
    const double spread = solve(x, equations, n, 3);
    fprintf(stderr, "%s, %s: %.4g %.4g %.4g, spread %.3f of %d\n", wanted_names[wanted], is_s3ho ? "s3ho" : "fast",
            x[0], x[1], x[2], spread, n);
}

/* Reads the lines of the csv that fit the plan. Returns how many; -1: one is no row. */
static int read_rows(FILE *f, const char *path)
{
    char line[1024];
    int count = 0, fits;
    for (int k = 1; count < MOST_ROWS && fgets(line, sizeof line, f); ++k) {
        if (read_row(&row[count], &fits, line)) {
            fprintf(stderr, "fit: %s: line %d is not a measured choice\n", path, k);
            return -1;
        }
        count += fits && row[count].choice >= 0 && row[count].choice < SSGI_PLAN_CHOICES;
    }
    return count;
}

/* Reads the time of each choice on a GPU; 0: not known. Lines that begin with # are skipped. -1: a line is no row. */
static int read_gpu(double gpu[SSGI_PLAN_CHOICES], FILE *f, const char *path)
{
    char line[1024];
    for (int k = 1; fgets(line, sizeof line, f); ++k) {
        double ratio;
        int c, end = -1;
        if (*line == '#') continue;
        if (sscanf(line, "%d,%lf %n", &c, &ratio, &end) == 2 && end >= 0 && !line[end] && c >= 0
            && c < SSGI_PLAN_CHOICES && ratio > 0 && ratio < 1e6) {
            gpu[c] = ratio;
            continue;
        }
        fprintf(stderr, "fit: %s: line %d is not a choice and its cost\n", path, k);
        return -1;
    }
    return 0;
}

/* Sets up the equations of a choice's error and returns how many. Also lists its costs on the rows that were timed. */
static int equations_of(double costs[MOST_ROWS], int *timed, int c, int count)
{
    const ssgi__plan_row *r = &ssgi__plan_rows[c];
    int n = 0;
    *timed = 0;
    for (int i = 0; i < count; ++i) {
        if (row[i].choice != c) continue;
        if (row[i].timed) costs[*timed] = row[i].cost;
        *timed += row[i].timed;
        equations[n].square = row[i].error * row[i].error;
        ssgi__plan_terms(equations[n].term, r, &row[i].scene);
        /* the error of a row follows the calibration of the row's own thickness model */
        if (!r->thickness && r->method != SSGI_PLAN_METHOD_DSS) equations[n].term[SSGI__PLAN_SLABS_ERROR] = 0;
        if (r->thickness == SSGI_PLAN_THICKNESS_SLABS) equations[n].term[SSGI__PLAN_HSAO_ERROR] = 0;
        if (r->wanted == SSGI_PLAN_WANTED_VISIBILITY && r->thickness != SSGI_PLAN_THICKNESS_CONSTANT)
            equations[n].term[SSGI__PLAN_KIN_ERROR] = 0;
        ++n;
    }
    return n;
}

/* Returns a choice's cost in software. If it was not measured, it stays as in ssgi.h. */
static double cost_of(double *costs, int n, const ssgi__plan_row *r, double own)
{
    qsort(costs, (size_t)n, sizeof *costs, by_value);
    return r->method == SSGI_PLAN_METHOD_DSS && own > 0 ? own
           : r->method == SSGI_PLAN_METHOD_AOF || !n      ? (double)r->cost[0]
                                                            : costs[n / 2];
}

/* Prints a choice's line of the table ssgi__plan_rows. */
static void print_choice(int c, int count, double own[MOST_TERMS], double gpu)
{
    static const char *const wanted[] = { "VISIBILITY", "LIGHT", "BOUNCE", "OBJECTS" },
                             *const method[] = { "NOTHING", "HSAO", "SSDO", "S3HO", "DSS", "AOF" },
                             *const thickness[] = { "WIDTH", "CONSTANT", "BACK", "SLABS" };
    static double costs[MOST_ROWS];
    const ssgi__plan_row *r = &ssgi__plan_rows[c];
    double x[MOST_TERMS];
    int timed;
    const int n = equations_of(costs, &timed, c, count);
    const double spread = n ? solve(x, equations, n, MOST_TERMS) : 0;
    for (int k = 0; k < MOST_TERMS && !n; ++k) x[k] = (double)r->term[k];
    printf("  SSGI__P(%c, %s,%*s %s,%*s %d, %d, %d,%*s %d, %d, %d, ", wanted[r->wanted][0], method[r->method],
           7 - (int)strlen(method[r->method]), "", thickness[r->thickness], 8 - (int)strlen(thickness[r->thickness]),
           "",
           r->resolution, r->slices, r->samples, r->samples < 10, "", r->bands, r->history, r->field_resolution);
    literal((double)r->surfel_size, 5, ",");
    literal(cost_of(costs, timed, r, own[own_term(r)]), 5, ",");
    literal(gpu > 0 ? gpu : (double)r->cost[1], 5, ",");
    for (int k = 0; k < MOST_TERMS; ++k)
        literal(x[k] < 1e-3 ? 0 : x[k], "5555450"[k] - '0', k + 1 < MOST_TERMS ? "," : ")");
    puts(c + 1 < SSGI_PLAN_CHOICES ? "," : "");
    fprintf(stderr, "choice %d: %d rows, spread %.3f\n", c, n, spread);
}

static const char usage[] =
    "usage: fit PLAN-FIT.csv [COSTS.csv]\n"
    "Fits the planner's table to measured errors and prints it, to be put into ssgi.h, room >>plan.\n"
    "  PLAN-FIT.csv            The errors that build/report fit has written. If the file is empty\n"
    "                          (/dev/null), only the column of costs changes.\n"
    "  COSTS.csv               Costs on a GPU: plan-gpu.csv of make bench, which are measured, or\n"
    "                          plan-cost.csv of make cost-plan, which are estimated. A choice that is\n"
    "                          in neither file keeps its costs.\n";

int main(int argc, char **argv)
{
    const char *const asked = argc == 2 ? argv[1] : "";
    double own[MOST_TERMS], gpu[SSGI_PLAN_CHOICES] = { 0 };
    if (!strcmp(asked, "--help") || !strcmp(asked, "-h")) return fputs(usage, stdout) < 0;
    if (!strcmp(asked, "--version")) return printf("ssgi %d.%d\n", SSGI_VERSION_MAJOR, SSGI_VERSION_MINOR) < 0;
    FILE *f = argc == 2 || argc == 3 ? fopen(argv[1], "r") : NULL;
    FILE *measured_gpu = argc == 3 ? fopen(argv[2], "r") : NULL;
    if (!f || (argc == 3 && !measured_gpu)) {
        fprintf(stderr, argc < 2 ? usage : "fit: %s: cannot be read\n", argv[f ? argc - 1 : argc > 1]);
        return 2;
    }
    const int bad = measured_gpu && read_gpu(gpu, measured_gpu, argv[2]), count = bad ? -1 : read_rows(f, argv[1]);
    if (measured_gpu) fclose(measured_gpu);
    fclose(f);
    if (count < 0) return 2;
    know(row, count);
    fit_splats(count, own);
    for (int k = 0; k < 18; ++k) fit_survey(count, k / 6, k / 3 % 2, k % 3);
    for (int k = 0; k < 6; ++k) if (k != 1) fit_kin(count, k / 2, k % 2);       /* 1: visibility by s3ho */
    for (int c = 0; c < SSGI_PLAN_CHOICES; ++c) print_choice(c, count, own, gpu[c]);
    return 0;
}
