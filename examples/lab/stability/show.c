/* show.c - shows sweeps: figures, tables, pictures of the worst frames. Declared in show.h. */
#include "lab/stability/show.h"
#include <math.h>
#include <string.h>
#include "lab/page/page.h"

#define OF_ALONE "error over that of the frame alone"
#define DIFFERENCE "method, truth, difference (full colour: 0.5)"
/* A table by kind of cause: the meaning of its number, the chart's axis, and the words beside a picture. */
static const struct { const char *number, *up, *shown; } kinds[] = {
    [ERROR] = { "largest RMSE to the truth", "RMSE to the truth", DIFFERENCE },
    [PRECISION] = { "greatest depth up to which RMSE stays within 0.02", "RMSE to the picture with exact depth",
                    "with this depth, with exact depth, difference (full colour: 0.5)" },
    [DEVIATION] = { "largest deviation over frames, less the truth's", "deviation over frames",
                    "method, truth, deviation over frames (full colour: 0.05)" },
    [SECOND] = { "largest second difference over frames", "second difference over frames, as deviation",
                 "method, truth, second difference (full colour: 0.05)" },
    [LIT_SECOND] = { "largest second difference, less an open surface's, over the mean",
                     "second difference over frames, over the mean",
                     "method, open surface (both times 0.4), second difference (full colour: 0.05)" },
    [FOLLOWS] = { "largest " OF_ALONE, OF_ALONE, DIFFERENCE },
    [AFTER] = { "largest " OF_ALONE, OF_ALONE, DIFFERENCE },
    [NEWLY] = { "largest error of newly seen surfaces over that of the frame alone",
                "error of newly seen surfaces over that of the frame alone", DIFFERENCE },
    [TRAIL] = { "most of the old picture that is left", "rest of the old picture, of ambient visibility",
                DIFFERENCE },
    [HELD] = { "most pixels, a share of all, that keep more than 0.05 of the old picture",
               "pixels that keep more than 0.05 of the old picture, a share of all", DIFFERENCE },
    [SHADES] = { "1 over the fewest shades of 256", "1 over the number of shades of 256", DIFFERENCE }
};

static const char *settings_of(const curve *c) { return c->method < 0 ? "" : sweeps_method[c->method].settings; }

/* ---- >>page ------------------------------------------------------------------------------------------------------ */

/* Shows the frame in which a curve was worst. */
static int show_worst(FILE *record, const cause *c, const curve *v, const char *out, kit_error *err)
{
    char name[128], note[160], path[4096];
    if (!v->worst.data) return 0;
    snprintf(name, sizeof name, "stability-%s-%s.png", c->name, v->label);
    snprintf(path, sizeof path, "%s/%s", out, name);
    if (kit_png_write(&v->worst, "R,G,B", 0, path, err)) return -1;
    snprintf(name, sizeof name, "stability-%s-%s", c->name, v->label);
    snprintf(note, sizeof note, "at %g: %s", v->at, kinds[c->kind].shown);
    page_figure(record, name, v->label, note, v->worst.width, v->worst.height, 0);
    return 0;
}

void show_csv_head(FILE *f) { fputs("cause,unit,method,settings,value,figure,number\n", f); }

static void csv_rows(FILE *f, const result *r)
{
    for (int i = 0; i < r->curves; ++i)
        for (int k = 0; k < r->points; ++k)
            if (!isnan(r->curve[i].y[k]))
                fprintf(f, "%s,\"%s\",\"%s\",\"%s\",%.6g,%.6g,%.6g\n", r->cause->name, r->cause->across,
                        r->curve[i].label, settings_of(&r->curve[i]), r->x[k], r->curve[i].y[k], r->curve[i].number);
}

int show_cause(FILE *record, FILE *csv, const result *r, const char *out, kit_error *err)
{
    const cause *c = r->cause;
    page own;
    if (page_open(&own, err)) return -1;
    show_csv_head(own.file);
    csv_rows(own.file, r);
    csv_rows(csv, r);
    page_heading(record, 3, "%s", c->title);
    page_paragraph(record, "%s Up: %s. Number: %s.", c->about, c->up ? c->up : kinds[c->kind].up,
                   c->number ? c->number : kinds[c->kind].number);
    page_table(record, c->log ? "sweep-log" : "sweep", &own);
    for (int i = 0; i < r->curves; ++i)
        if (show_worst(record, c, &r->curve[i], out, err)) return -1;
    return 0;
}

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

/* Prints the number of a method's curve, or of the reference beside methods; "" if there is none. */
static const char *number_of(char text[32], const result *r, int method)
{
    *text = 0;
    for (int i = 0; i < r->curves; ++i)
        if (r->curve[i].method == method && !isnan(r->curve[i].number))
            snprintf(text, 32, r->cause->kind == PRECISION ? "%.0f" : "%.4f", r->curve[i].number);
    return text;
}

void show_table_text(FILE *f, const result *results, const int *shown)
{
    char text[32];
    fputs("cause          ", f);
    for (int m = 0; m < sweeps_methods; ++m) fprintf(f, " %10s", sweeps_method[m].label);
    fputs("     beside\n", f);
    for (int k = 0; k < sweeps_causes; ++k) {
        if (!shown[k] || sweeps_cause[k].curves) continue;
        fprintf(f, "%-15s", sweeps_cause[k].name);
        for (int m = 0; m <= sweeps_methods; ++m) {
            const char *number = number_of(text, &results[k], m < sweeps_methods ? m : BESIDE);
            fprintf(f, " %10s", *number ? number : "-");
        }
        fputs("\n", f);
    }
    for (int k = 0; k < sweeps_causes; ++k) {
        if (!shown[k] || !sweeps_cause[k].curves) continue;
        fprintf(f, "%s, %s:", sweeps_cause[k].name, sweeps_cause[k].number);
        for (int i = 0; i < results[k].curves; ++i)
            if (!isnan(results[k].curve[i].number))
                fprintf(f, " %s %.4f;", results[k].curve[i].label, results[k].curve[i].number);
        fputs("\n", f);
    }
}
