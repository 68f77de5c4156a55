/* deep.c - what report.c's chart shows of deep screen space: what size, epsilon, levels and the other choices buy;
   where the time goes. Declared in deep.h. */
#include "lab/chart/deep.h"
#include <math.h>
#include <string.h>
#include "lab/chart/deep_stage.h"
#include "lab/measure/halved.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"
#include "lab/page/table.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

#define DSS(label, settings, quick) { label, "dss", settings, quick }
static const entry deep_ao[] = { /* rows of one label make one curve */
    { "ssao", "ssao", "samples=8", 0 },
    { "ssao", "ssao", "", 1 },
    { "hsao", "hsao-fast", "", 1 },
    { "hsao", "hsao", "", 1 },
    { "hsao", "hsao-best", "", 1 },
    { "dss", "dss-fast", "", 1 },
    { "dss", "dss", "", 1 },
    { "dss", "dss-best", "", 1 },
    DSS("dss, small surfels, far, at full size", "half=0,size=0.015,epsilon=0.1,levels=5,near_samples=4", 0),
    DSS("dss, epsilon 0.02, at full size", "half=0,epsilon=0.02", 0)
};
static const entry deep_figure8[] = {
    DSS("epsilon", COARSE ",half=0,levels=4,epsilon=0.2", 1),  DSS("epsilon", COARSE ",half=0,levels=4,epsilon=0.1", 1),
    DSS("epsilon", COARSE ",half=0,levels=4,epsilon=0.02", 1), DSS("levels", COARSE ",half=0,epsilon=0.1,levels=1", 0),
    DSS("levels", COARSE ",half=0,epsilon=0.1,levels=2", 1),   DSS("levels", COARSE ",half=0,epsilon=0.1,levels=6", 0)
};
static const entry deep_choices[] = {
    DSS("defaults", COARSE, 1),
    DSS("every triangle", COARSE ",keep_small=1", 0),
    DSS("no growth off screen: as published", COARSE ",offscreen_growth=0", 0),
    DSS("from the near plane on", COARSE ",near_depth=0", 0),
    DSS("near_samples: 4 points", COARSE ",near_samples=4", 0),
    DSS("full size", COARSE ",half=0", 0),
    DSS("corners move to the centroid: as published", COARSE ",overhang=centroid", 0),
    DSS("larger surfels on farther levels: as published", COARSE ",enlarge=1", 0),
    DSS("form factors add up: as published", COARSE ",combine=add", 0),
    DSS("no smoothing", COARSE ",smooth=0", 0),
    DSS("smoothing compares normals", COARSE ",filter_normals=1", 0),
    DSS("by tessellation", COARSE ",way=capture", 0),
    DSS("by geometry shader", COARSE ",way=direct", 0)
};
static const entry deep_lights[] = {
    { "dss-lit", "dss-lit", COARSE, 1 },
    { "dss-lit", "dss-lit", "", 0 },
    { "dss-lit, epsilon 0.02", "dss-lit", COARSE ",epsilon=0.02,levels=4", 0 },
    { "dss-lit, the sky on surfels that are hidden, too", "dss-lit", COARSE ",sky=1", 0 }
};
static const entry deep_ssdos[] = {
    { "ssdo", "ssdo-fast", "", 0 },
    { "ssdo", "ssdo", "", 1 },
    { "ssdo", "ssdo-best", "", 0 },
    { "ssdo, 4 cameras", "ssdo-points", "views=4", 0 }
};
static const entry deep_mirrors[] = {
    { "dss-gloss", "dss-gloss", "exponent=8,size=0.06", 0 },
    { "dss-gloss", "dss-gloss", "exponent=8,size=0.03", 0 },
    { "dss-gloss", "dss-gloss", "exponent=8", 1 },
    { "dss-gloss, epsilon 0.02", "dss-gloss", "exponent=8,size=0.03,epsilon=0.02", 0 }
};
static const entry deep_marbles[] = {
    { "dss-scatter", "dss-scatter", MARBLE, 1 },
    { "dss-scatter, 5 levels", "dss-scatter", MARBLE ",levels=5", 0 },
    { "dss-scatter, epsilon 0.1", "dss-scatter", MARBLE ",epsilon=0.1", 0 },
    { "dss-scatter, shares of triangles", "dss-scatter", MARBLE ",keep_small=0", 1 }
};
static const entry deep_effects[] = {
    { "ambient occlusion", "dss", "way=capture", 1 },
    { "directional occlusion", "dss-lit", "way=capture,bounce=none", 1 },
    { "directional occlusion, a bounce", "dss-lit", "way=capture", 1 },
    { "one specular bounce", "dss-gloss", "way=capture", 1 },
    { "scattering", "dss-scatter", "way=capture," MARBLE, 1 }
};
/* The same reach, radius sqrt(1 / epsilon - 1) 2^(levels - 1): 16^2 (1/0.1 - 1) = 1/0.000433839 - 1. half: of the
   picture's width and height, brought to full size bilinearly. */
static const sized deep_figure9[] = {
    { DSS("5 levels", COARSE ",half=0,levels=5,epsilon=0.1", 1), 0 },
    { DSS("full size, 1 level", COARSE ",half=0,levels=1,epsilon=0.000433839", 1), 0 },
    { DSS("half size, 1 level", COARSE ",half=0,levels=1,epsilon=0.000433839", 1), 1 },
    { DSS("half size, 5 levels", COARSE ",half=0,levels=5,epsilon=0.1", 0), 1 }
};

typedef struct growth { const char *label, *settings; int width, quick; } growth;
static const growth deep_growth[] = {
    { "surfels", "size=0.06", 320, 1 },
    { "surfels", COARSE, 320, 1 },
    { "surfels", "size=0.015", 320, 0 },
    { "pixels", COARSE, 160, 1 },
    { "pixels", COARSE, 320, 0 },
    { "pixels", COARSE, 640, 0 },
    { "levels", COARSE ",epsilon=0.1,levels=1", 320, 1 },
    { "levels", COARSE ",epsilon=0.1,levels=2", 320, 0 },
    { "levels", COARSE ",epsilon=0.1,levels=4", 320, 1 },
    { "levels", COARSE ",epsilon=0.1,levels=6", 320, 0 }
};

typedef struct deep_table {
    const char *title, *about;
    deep_view see;
    const entry *entries;
    int count, quick;
    int charted;                           /* error against time, too */
} deep_table;
static const deep_table deep_tables[] = { /* one without title goes on with the table before it */
    { "Deep screen space: speed against accuracy, bunny", "Bunny on a floor.",
      BUNNY_AO, WITH_COUNT(deep_ao), 1, 1 },
    { "Deep screen space: speed against accuracy, room", "Room.",
      OWN_VIEW("room"), WITH_COUNT(deep_ao), 0, 1 },
    { "Deep screen space: epsilon and levels",
      "The paper's figure 8: epsilon and levels, surfels of 0.03.", BUNNY_AO,
      WITH_COUNT(deep_figure8), 0, 1 },
    { "Deep screen space: other choices",
      "Bunny on a floor, surfels of 0.03; one choice at a time.", BUNNY_AO,
      WITH_COUNT(deep_choices), 0, 0 },
    { "Deep screen space: light",
      "Bunny and four boxes under the sky and a sun, one bounce. Of ssdo: what "
      "is within the radius weighted by 1 - t/radius, in its truth, too;",
      FADING, WITH_COUNT(deep_ssdos), 1, 0 },
    { NULL, "of dss-lit: all whole, in its truth, too.", WHOLE_LIGHT,
      WITH_COUNT(deep_lights), 1, 0 },
    { "Deep screen space: one specular bounce",
      "Open box under a point light, a lobe of exponent 8. Irradiance stands for "
      "the lobe's radiance.",
      LOBE, WITH_COUNT(deep_mirrors), 0, 0 },
    { "Deep screen space: scattering",
      "A bunny of marble, 4 cm high, lit from behind. Irradiance stands for the "
      "radiance that leaves it.",
      OF_MARBLE, WITH_COUNT(deep_marbles), 0, 0 }
};

enum {
    PAPER_SIDE = 512,
    DEEP_ROUNDS = 2,
    DEEP_TABLES = COUNT(deep_tables),
    FULL_SET = DEEP_TABLES,
    TURN_SET,
    MOTION_SET,
    STAGE_SET,
    GROWTH_SET,
    DEEP_SETS
};
static deep_set sets[DEEP_SETS];

/* ---- >>chart ----------------------------------------------------------------------------------------------------- */

/* Appends a table to the count rows that there are; how many there are then, -1 = failed. */
static int deep_table_of(FILE *record, const deep_table *t, const options *o, row *rows, int count, kit_error *err)
{
    entry entries[MOST_ENTRIES];
    kit_image picture[MOST_ENTRIES];
    const int all = units_chosen(entries, t->entries, t->count, o);
    stage s;
    if (!all || (o->quick && !t->quick)) return count;
    if (!rows) return 1;
    if (deep_load(&s, &t->see, err)) return -1;
    if (s.otherwise.kind == SCATTER) s.rays *= 4;
    if (s.lit) s.stride = LIT_STRIDE;
    if (stage_show(&s, &t->see.view, DEEP_WIDTH, DEEP_HEIGHT, err)) return -1;
    const int more = deep_measure(rows + count, &s, t->see.view.name, entries, all,
                                  t->charted ? QUICK_ROUNDS
                                  : o->quick ? 1
                                             : DEEP_ROUNDS,
                                  picture, err);
    if (more < 0) return -1;
    deep_about(record, &s, t->about);
    if (pictures_thumbs(record, o->out, units_name(), &s, rows + count, picture, all, err)) return -1;
    for (int i = 0; i < all; ++i) kit_image_free(&picture[i]);
    stage_close(&s);
    return count + more;
}

static int full_sizes_of(FILE *record, int quick, row *rows, kit_error *err)
{
    static const deep_view see = BUNNY_AO;
    sized entries[COUNT(deep_figure9)];
    int count = 0;
    stage s;
    for (int i = 0; i < COUNT(deep_figure9); ++i)
        if (!quick || deep_figure9[i].entry.quick) entries[count++] = deep_figure9[i];
    if (deep_open(&s, &see, err) || halved_entries(rows, &s, entries, count, quick ? 1 : DEEP_ROUNDS, NULL, err))
        return -1;
    for (int i = 0; i < count; ++i) {
        rows[i].of = OF_DEEP;
        rows[i].scene = see.view.name;
    }
    deep_about(record, &s,
               "The paper's figure 9: all reach as far; half sizes are brought to full size bilinearly, which is not "
               "in their times; their splats are of their own pixels.");
    stage_close(&s);
    return count;
}

/* Times alone, no truth: entries on one picture. How many rows. */
static int deep_costs(row *rows, const deep_view *v, int width, int height, const entry *entries, int count, int of,
                      int rounds, kit_error *err)
{
    stage s;
    if (deep_load(&s, v, err) || stage_look(&s, &v->view, width, height, err)
        || measure_times(rows, &s, entries, count, rounds, err))
        return -1;
    for (int i = 0; i < count; ++i) {
        rows[i].of = of;
        rows[i].scene = v->view.name;
        rows[i].figure[PICTURE] = 1e-3 * s.frame.width * s.frame.height;
    }
    stage_close(&s);
    return count;
}

static int growth_of(int quick, row *rows, kit_error *err)
{
    int count = 0;
    static const deep_view see = BUNNY_AO;
    for (int i = 0; i < COUNT(deep_growth); ++i) {
        const growth *g = &deep_growth[i];
        const entry e = { g->label, "dss", g->settings, 1 };
        if (quick && !g->quick) continue;
        if (deep_costs(&rows[count++], &see, g->width, g->width * 9 / 16, &e, 1, OF_GROWTH, quick ? 1 : DEEP_ROUNDS,
                       err)
            < 0)
            return -1;
    }
    return count;
}

static const char *deep_title(int k)
{
    static const char *const titles[] = { "Deep screen space: full size, half size",
                                          "Deep screen space: the camera turns away",
                                          "Deep screen space: the camera moves",
                                          "Deep screen space: where the time goes",
                                          "Deep screen space: what costs grow with" };
    return k < DEEP_TABLES ? deep_tables[k].title : titles[k - DEEP_TABLES];
}

static int deep_unit(FILE *record, const options *o, int k, row *rows, kit_error *err)
{
    static const deep_view lights = WHOLE_LIGHT;
    int count = 0;
    if (rows) page_heading(record, 2, "%s", deep_title(k));
    if (k < DEEP_TABLES) {
        for (int j = k; deep_tables[k].title && j < DEEP_TABLES && (j == k || !deep_tables[j].title) && count >= 0; ++j)
            count = deep_table_of(record, &deep_tables[j], o, rows, count, err);
        return count;
    }
    if (!units_asked(o, "dss") || (o->quick && k != TURN_SET && k != STAGE_SET)) return 0;
    if (!rows) return 1;
    if (k == STAGE_SET)
        page_paragraph(record,
                "The paper's test: bunny, floor and four boxes, some 69,000 triangles, %d x %d pixels; surfels by "
                "tessellation, captured. Shares of one frame's time.",
                PAPER_SIDE / stage_thrift, PAPER_SIDE / stage_thrift);
    if (k == GROWTH_SET) page_paragraph(record, "Bunny on a floor; one thing grows at a time.");
    return k == FULL_SET     ? full_sizes_of(record, o->quick, rows, err)
           : k == TURN_SET   ? deep_turns(record, o->quick, rows, err)
           : k == MOTION_SET ? deep_motion(record, o->quick, rows, err)
           : k == STAGE_SET  ? deep_costs(rows, &lights, PAPER_SIDE, PAPER_SIDE, deep_effects,
                                         o->quick ? 1 : COUNT(deep_effects), OF_STAGES, 1, err)
                             : growth_of(o->quick, rows, err);
}

int deep_units(const options *o) { return units_count(deep_unit, DEEP_SETS, o); }

int deep_chart(FILE *record, const options *o, kit_error *err)
{
    int shown = 0;
    page csv;
    if (page_open(&csv, err)) return -1;
    for (int k = 0; k < DEEP_SETS; ++k) {
        deep_set *set = &sets[k];
        set->title = deep_title(k);
        set->count = units_measure(record, o, "deep", k, deep_unit, set->row, err);
        if (set->count < 0) return -1;
        if (!set->count) continue;
        const int charted = k < DEEP_TABLES && deep_tables[k].charted;
        if (table_page(record, k == TURN_SET ? "turn" : charted ? "scatter" : "rows", set->row, set->count, err))
            return -1;
        table_csv(csv.file, set->row, set->count, !shown++);
    }
    return page_close(&csv, o->out, "chart-deep.csv", err);
}

void deep_chart_text(FILE *f)
{
    for (int k = 0; k < DEEP_SETS; ++k) table_titled(f, sets[k].title, sets[k].row, sets[k].count);
}
