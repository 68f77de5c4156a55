/* fit.c - fits the table of choices in ssgi.h's room >>plan to what "report fit" measured (report/plan-fit.csv), and
   prints it, to be put there.

      build/fit report/plan-fit.csv

   A choice's squared error is a sum of terms, each times a number that is 0 or more: least squares of relative errors,
   by coordinates. */
#define SSGI_STATIC
#define SSGI_IMPLEMENTATION
#include "../ssgi.h"
#include <stdlib.h>

enum { MOST_ROWS = 8192, MOST_TERMS = SSGI__PLAN_TERMS };
typedef struct measured { char view[64]; ssgi_plan_scene scene; int choice; double error, cost; } measured;
typedef struct equation { double term[MOST_TERMS], square; } equation;

static int by_value(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Weights follow the prediction, so that what is left is about the logarithm's. */
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

int main(int argc, char **argv)
{
    static const char *const wanted[] = { "VISIBILITY", "LIGHT", "BOUNCE", "OBJECTS" },
                             *const needs[] = { "NONE", "MAP", "MESH", "", "OCCLUDERS" },
                             *const method[] = { "NOTHING", "HSAO", "MARCH", "SSDO", "S3HO", "SURFELS", "FIELD" };
    static measured row[MOST_ROWS];
    static equation equations[MOST_ROWS];
    double x[MOST_TERMS], costs[MOST_ROWS];
    char line[1024], name[128];
    int count = 0, fits;
    FILE *f = argc == 2 ? fopen(argv[1], "r") : NULL;
    if (!f) {
        fprintf(stderr, argc == 2 ? "fit: %s: cannot be read\n" : "usage: fit plan-fit.csv\n",
                argc == 2 ? argv[1] : "");
        return 2;
    }
    while (count < MOST_ROWS && fgets(line, sizeof line, f)) {
        measured *m = &row[count];
        ssgi_plan_scene *s = &m->scene;
        memset(m, 0, sizeof *m);
        if (sscanf(line, "%127[^,],%d,%d,%d,%lf,%lf,%f,%f,%f,%f,%f,%f,%f,%f,%f,%f,%f,%f,%f,%f,%f,%f,%f", name, &fits,
                   &s->wanted, &m->choice, &m->error, &m->cost, &s->calibration.unoccluded, &s->calibration.hsao,
                   &s->screen_radius, &s->albedo, &s->energy[0], &s->energy[1], &s->energy[2], &s->energy[3],
                   &s->statistics.visible, &s->statistics.blocked[0], &s->statistics.blocked[1],
                   &s->statistics.blocked[2], &s->statistics.offscreen, &s->statistics.square[0],
                   &s->statistics.square[1], &s->statistics.square[2], &s->statistics.square[3])
            != 23) {
            fprintf(stderr, "fit: %s: line %d is not a measured choice\n", argv[1], count + 1);
            return 2;
        }
        s->calibration.known = 1;
        snprintf(m->view, sizeof m->view, "%.63s", name);
        count += fits && m->choice >= 0 && m->choice < SSGI_PLAN_CHOICES;
    }
    fclose(f);
    /* a calibration of some places is noisy: of these views all is known */
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < count; ++k) {
            const ssgi__plan_row *r = &ssgi__plan_rows[row[i].choice];
            if (row[i].scene.wanted != row[k].scene.wanted || strcmp(row[i].view, row[k].view)) continue;
            if (r->method == SSGI_PLAN_NOTHING) row[k].scene.calibration.unoccluded = (float)row[i].error;
            /* the preset BALANCED */
            if (r->method == SSGI_PLAN_HSAO && r->half && r->directions == 2 && r->steps == 8)
                row[k].scene.calibration.hsao = (float)row[i].error;
        }
    for (int c = 0; c < SSGI_PLAN_CHOICES; ++c) {
        const ssgi__plan_row *r = &ssgi__plan_rows[c];
        int n = 0;
        for (int i = 0; i < count; ++i) {
            if (row[i].choice != c) continue;
            costs[n] = row[i].cost;
            equations[n].square = row[i].error * row[i].error;
            ssgi__plan_terms(equations[n++].term, r, &row[i].scene);
        }
        const double spread = n ? solve(x, equations, n, MOST_TERMS) : 0;
        for (int k = 0; k < MOST_TERMS && !n; ++k) x[k] = (double)r->term[k];
        qsort(costs, (size_t)n, sizeof *costs, by_value);
        printf("    SSGI__ROW(%s, %s, %s, %d, %d, %d, %d, %d, %d, %d, %d, %d, ", wanted[r->wanted], method[r->method],
               needs[r->needs], r->half, r->directions, r->samples, r->steps, r->bands, r->layers, r->cameras,
               r->filter, r->resolution);
        printf(r->size > 0 ? "%gf, %.2ff" : "%g, %.2ff", (double)r->size, n ? costs[n / 2] : (double)r->cost);
        for (int k = 0; k < MOST_TERMS; ++k) printf(x[k] < 0.5e-4 ? ", 0" : ", %.4ff", x[k]);
        fputs(c + 1 < SSGI_PLAN_CHOICES ? ")," : ")", stdout);
        fprintf(stderr, "%s choice %d: %d rows, spread %.3f", c ? "\n" : "", c, n, spread);
        putchar('\n');
    }
    /* what a statistics pass alone tells of a calibration */
    for (int of = 0; of < 2; ++of) {
        int n = 0;
        for (int i = 0; i < count; ++i) {
            const ssgi_plan_scene *s = &row[i].scene;
            if (s->wanted || (i && row[i - 1].scene.calibration.unoccluded == s->calibration.unoccluded)) continue;
            equations[n].square = of ? (double)s->calibration.hsao * (double)s->calibration.hsao
                                     : (double)s->calibration.unoccluded * (double)s->calibration.unoccluded;
            for (int k = 0; k < 4; ++k) equations[n].term[k] = (double)s->statistics.square[k];
            ++n;
        }
        const double spread = solve(x, equations, n, 4);
        fprintf(stderr, "\n%s from a statistics pass: %.4g %.4g %.4g %.4g, spread %.3f of %d", of ? "picture" : "open",
                x[0], x[1], x[2], x[3], spread, n);
    }
    fputc('\n', stderr);
    return 0;
}
