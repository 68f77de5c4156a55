/* measure.c - draws, scores and times rows of methods on a stage. Declared in measure.h. */
#include "lab/measure/measure.h"
#include <math.h>
#include <string.h>

/* Opens a run of a method, draws it and reads its picture, which the caller frees. The run is timed later. */
static int measure_entry(row *r, kit_run *run, kit_image *picture, stage *s, const entry *e, int phases, kit_error *err)
{
    *r = row_blank(0, s->name, e->label, e->method, e->settings);
    if (stage_run(run, s, e->method, e->settings, s->radius, err)) return -1;
    return stage_settled(picture, s, run, 0, 1, err) || score_picture(r, s, picture, err)
                   || (phases && score_phases(r, s, run, phases, picture, err))
               ? -1
               : 0;
}

static int measure_given(row *r, stage *s, const given *g, int phases, kit_error *err)
{
    *r = row_blank(0, s->name, g->label, g->method, "");
    if (score_picture(r, s, &g->picture, err) || (phases && score_phases(r, s, NULL, phases, &g->picture, err)))
        return -1;
    if (!strcmp(r->label, "floor") && FLOOR_STRIDE > 1) r->score.ssim = (double)NAN;      /* no neighbours */
    return 0;
}

int measure_entries(row *rows, stage *s, const entry *entries, int count, int rounds, int phases, kit_image *pictures,
                    kit_error *err)
{
    kit_run run[MOST_ENTRIES];
    char what[128];
    snprintf(what, sizeof what, "%s: methods", s->name);
    kit_progress(what, 0);
    for (int i = 0; i < count; ++i) {
        kit_image picture;
        if (measure_entry(&rows[i], &run[i], &picture, s, &entries[i], phases, err)) return -1;
        if (!rounds) kit_run_close(&run[i]);
        if (pictures) pictures[i] = picture; else kit_image_free(&picture);
        kit_progress(what, (i + 1.0) / (count + 1.0));
    }
    kit_progress(what, 1);
    if (rounds && clock_runs(rows, s, run, count, rounds, err)) return -1;
    for (int i = 0; i < s->givens; ++i)
        if (measure_given(&rows[count + i], s, &s->given[i], phases, err)) return -1;
    return 0;
}

int measure_times(row *rows, stage *s, const entry *entries, int count, int rounds, kit_error *err)
{
    kit_run run[MOST_ENTRIES];
    for (int i = 0; i < count; ++i) {
        rows[i] = row_blank(0, s->name, entries[i].label, entries[i].method, entries[i].settings);
        if (stage_run(&run[i], s, entries[i].method, entries[i].settings, s->radius, err)) return -1;
        kit_run_draw(&run[i], 1);
    }
    return clock_runs(rows, s, run, count, rounds, err);
}
