/* show.c - shows sweeps: curves, numbers, and pictures of the worst frames. Declared in show.h. */
#include "lab/stability/show.h"
#include <math.h>
#include "lab/page/page.h"
#include "lab/page/pictures.h"

#define OF_ALONE "error over that of the frame alone"
/* By kind of cause: the meaning of its number, the chart's axis up, and what a picture shows; NULL: method, truth,
   difference. */
static const struct { const char *number, *up, *shown; } kinds[] = {
    [ERROR] = { "largest RMSE to the truth", "RMSE to the truth" },
    [PRECISION] = { "greatest depth up to which RMSE stays within 0.02", "RMSE to the picture with exact depth",
                    "with this depth, with exact depth, difference (full colour: 0.5)" },
    [DEVIATION] = { "largest deviation over frames, less the truth's", "deviation over frames",
                    "method, truth, deviation over frames (full colour: 0.05)" },
    [SECOND] = { "largest second difference over frames", "second difference over frames, as deviation",
                 "method, truth, second difference (full colour: 0.05)" },
    [LIT_SECOND] = { "largest second difference, less an open surface's, over the mean",
                     "second difference over frames, over the mean",
                     "method, open surface (both times 0.4), second difference (full colour: 0.05)" },
    [FOLLOWS] = { "largest " OF_ALONE, OF_ALONE },
    [AFTER] = { "largest " OF_ALONE, OF_ALONE },
    [NEWLY] = { "largest error of newly seen surfaces over that of the frame alone",
                "error of newly seen surfaces over that of the frame alone" },
    [TRAIL] = { "most of the old picture that is left", "rest of the old picture, of ambient visibility" },
    [HELD] = { "most pixels, a share of all, that keep more than 0.05 of the old picture",
               "pixels that keep more than 0.05 of the old picture, a share of all" },
    [SHADES] = { "1 over the fewest shades of 256", "1 over the number of shades of 256" }
};

static const char *number_of(const cause *c) { return c->number ? c->number : kinds[c->kind].number; }
static const char *settings_of(const curve *c) { return c->method < 0 ? "" : sweeps_method[c->method].settings; }

void show_csv_head(FILE *f) { fputs("cause,unit,method,settings,value,figure,number\n", f); }

static void csv_rows(FILE *f, const result *r)
{
    for (int i = 0; i < r->curves; ++i)
        for (int k = 0; k < r->points; ++k)
            if (!isnan(r->curve[i].y[k]))
                fprintf(f, "%s,\"%s\",\"%s\",\"%s\",%.6g,%.6g,%.6g\n", r->cause->name, r->cause->across,
                        r->curve[i].label, settings_of(&r->curve[i]), r->x[k], r->curve[i].y[k], r->curve[i].number);
}

/* Shows the frame in which a method was worst. */
static int show_worst(FILE *record, const cause *c, const curve *v, const char *out, kit_error *err)
{
    char slug[128], note[160];
    if (!v->worst.data) return 0;
    snprintf(slug, sizeof slug, "stability-%s-%s", c->name, v->label);
    snprintf(note, sizeof note, "at %g: %s", v->at,
             kinds[c->kind].shown ? kinds[c->kind].shown : "method, truth, difference (full colour: 0.5)");
    page_figure(record, slug, v->label, note, v->worst.width, v->worst.height, 0);
    return pictures_save(&v->worst, "R,G,B", 0, out, slug, ".png", err);
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
                   number_of(c));
    page_table(record, c->log ? "sweep-log" : "sweep", &own);
    for (int i = 0; i < r->curves; ++i)
        if (show_worst(record, c, &r->curve[i], out, err)) return -1;
    return 0;
}

void show_numbers(FILE *f, const result *r)
{
    for (int i = 0; i < r->curves; ++i) {
        const curve *c = &r->curve[i];
        if (isnan(c->number)) continue;
        fprintf(f, r->cause->kind == PRECISION ? "%s,\"%s\",\"%s\",%.0f\n" : "%s,\"%s\",\"%s\",%.4f\n",
                r->cause->name, number_of(r->cause), c->method == BESIDE && !r->cause->curves ? "beside" : c->label,
                c->number);
    }
}
