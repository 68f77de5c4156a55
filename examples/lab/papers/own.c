/* own.c - draws the sheets that need a drawing of their own. Declared in sheet.h. */
#include <math.h>
#include "lab/measure/measure.h"
#include "lab/papers/sheet.h"

/* The terms of hsao: without normal rays; with them, less the former; the filter, behind a gather of one sample. */
const entry sheet_parts[PARTS] = {
    { "horizon", "hsao-march", "directions=7,samples=12,normal_rays=0,blur=0", 1 },
    { "both", "hsao-march", "directions=7,samples=12,normal_rays=1,blur=0", 1 },
    { "one tap", "hsao-march", "directions=1,samples=1,normal_rays=0,blur=0", 1 },
    { "one tap, filtered", "hsao-march", "directions=1,samples=1,normal_rays=0,filter=gaussian,blur=2", 1 }
};
void sheet_passes(row *r, const double ms[PARTS])
{
    double *const own = &r->figure[STAGE];
    own[0] = ms[0];
    own[1] = ms[1] - ms[0];
    own[2] = ms[3] - ms[2];
    own[3] = own[1] / own[0];
    own[4] = own[2] / own[0];
}

static int draw_passes(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    row part[PARTS];
    for (int i = 0; i < t->count; ++i) {
        stage s;
        double ms[PARTS];
        if (o->quick && t->rows[i].slow) continue;
        if (sheet_open(&s, t, &t->rows[i], err) || measure_times(part, &s, sheet_parts, PARTS, sheet_rounds(o), err))
            return -1;
        if (i + 1 == t->count) sheet_about(record, &s);
        const double unit = part[0].ms / part[0].relative;
        for (int k = 0; k < PARTS; ++k) ms[k] = unit * part[k].relative;
        sheet_passes(&rows[i], ms);
        stage_close(&s);
    }
    return 0;
}

/* A column for each effect, a row for each stage, the last for the total: each stage's share of the effect's frame. The
   quick form has only the first effect, that of the rows. */
static int draw_stages(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    static const struct { const char *label, *method, *more; } effects[] = {
        { "AO", "dss", "" }, { "DO", "dss-lit", ",bounce=none" }, { "DO, GI", "dss-lit", "" },
        { "specular", "dss-gloss", "way=capture,size=0.015,epsilon=0.1,levels=5,resolution=full,overhang=centroid,"
                                   "near_samples=1,enlarge=1,combine=add" },
        { "SSS", "dss-scatter",
          "way=capture,resolution=full,overhang=centroid,near_samples=1,material=marble,unit=0.05,"
                                "levels=7,epsilon=0.02" },
        { "AO, the library's", "dss", "way=capture" }
    };
    const int count = o->quick ? 1 : COUNT(effects), total = t->count - 1;
    char settings[COUNT(effects)][256];
    entry entries[COUNT(effects)];
    row timed[COUNT(effects)];
    stage s;
    for (int e = 0; e < COUNT(effects); ++e) {
        snprintf(settings[e], sizeof settings[e], "%s%s", e < 3 ? t->rows[0].settings : "", effects[e].more);
        entries[e] = (entry){ effects[e].label, effects[e].method, settings[e], 1 };
    }
    if (sheet_open(&s, t, &t->rows[0], err) || measure_times(timed, &s, entries, count, o->quick ? 1 : 2, err))
        return -1;
    sheet_about(record, &s);
    for (int e = 0; e < count; ++e)
        for (int i = 0; i <= total; ++i)
            rows[i].figure[STAGE + e] = timed[e].ms * (i < total ? timed[e].figure[STAGE + i] : 1);
    stage_close(&s);
    return 0;
}

enum { AVERAGES = 2, OF_THREE = 18 };
/* Averages are means of the loss over all sizes, as in the paper. */
void sheet_rates(const sheet *t, row *rows)
{
    for (int k = 0; k < AVERAGES; ++k) {
        double sum = 0;
        int known = 0;
        for (int i = 1 + k; i < OF_THREE; i += 3) {
            double *const lost = &rows[i].figure[STAGE];
            *lost = 100 * (1 - rows[t->rows[i].base - 1].ms / rows[i].ms);
            if (isnan(*lost)) continue;
            sum += *lost;
            ++known;
        }
        rows[t->count - AVERAGES + k].figure[STAGE] = sum / known;
    }
}

static int draw_rates(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    sheet sizes = *t;
    sizes.count -= AVERAGES;
    sizes.drawn = TIMES;
    if (sheet_draw(record, o, &sizes, rows, err)) return -1;
    sheet_rates(t, rows);
    return 0;
}

/* The last rows are of a crowd, with the same view and other numbers of casting objects. Of a hundred shapes as many
   cast as the paper has cubes. */
static int draw_crowd(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    static const view crowd = { .name = "crowd", .path = "crowd", .between = 1, .rays = 16 };
    static const int casting[] = { 1, 5, 10, 20 };
    enum { CROWD_WIDTH = 640, CROWD_HEIGHT = 360 };
    kit_run run[COUNT(casting)];
    sheet alone = *t;
    stage s;
    alone.count -= COUNT(casting);
    alone.drawn = FIELDS;
    if (sheet_draw(record, o, &alone, rows, err) || stage_open(&s, &crowd, CROWD_WIDTH, CROWD_HEIGHT, err)) return -1;
    for (int i = 0; i < COUNT(casting); ++i) {
        const paper_row *p = &t->rows[alone.count + i];
        for (int k = 1; k < s.scene.objects; ++k) s.scene.object[k].casts = k <= casting[i];
        if (stage_run(&run[i], &s, p->method, p->settings, s.radius, err)) return -1;
        kit_run_draw(&run[i], 1);
    }
    if (clock_runs(rows + alone.count, &s, run, COUNT(casting), sheet_rounds(o), err)) return -1;
    stage_close(&s);
    return 0;
}

int sheet_own_draw(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    switch (t->drawn) {
    case PASSES: return draw_passes(record, o, t, rows, err);
    case STAGES_OF: return draw_stages(record, o, t, rows, err);
    case RATES: return draw_rates(record, o, t, rows, err);
    default: return draw_crowd(record, o, t, rows, err);
    }
}
