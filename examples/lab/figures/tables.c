/* tables.c - the pages on light, fields and deep screen space: the tables of chart-lit.csv, chart-aof.csv and
   chart-deep.csv, one after the other. Declared in sections.h. */
#include <math.h>
#include <stdio.h>
#include <string.h>
#include "lab/figures/sections.h"

/* What is shown of a row of chart-lit, -aof and -deep, in this order, where a table has it. still: not where all rows
   have the same. when: 0 = always; 1 = where no row is scored; 2 = where there are no phases; 3 = of visibility. */
static const struct shown { const char *key, *head; int digits, sign, still, when; } shown[] = {
    { "triangles",         "triangles",   0, 0, 1, 0 },
    { "resolution",        "texels",      0, 0, 1, 0 },
    { "radii",             "radii",       0, 0, 1, 0 },
    { "rays",              "rays",        0, 0, 1, 0 },
    { "threads",           "threads",     0, 0, 1, 0 },
    { "kilobytes",         "kB",          1, 0, 1, 0 },
    { "bake_seconds",      "bake, s",     1, 0, 0, 0 },
    { "baked_median",      "bake: median", 4, 0, 0, 0 },
    { "baked_p95",         "bake: 95 %",  4, 0, 0, 0 },
    { "baked_most",        "bake: most",  3, 0, 0, 0 },
    { "covered",           "covered",     2, 0, 0, 0 },
    { "pixels_thousands",  "kilopixels",  0, 0, 1, 0 },
    { "surfels",           "surfels",     0, 0, 1, 0 },
    { "splat_pixels",      "splats",      0, 0, 1, 1 },
    { "fetches",           "fetches",     1, 0, 1, 2 },
    { "relative_time",     "time",        2, 0, 0, 0 },
    { "rmse",              "RMSE",        4, 0, 0, 3 },
    { "share",             "share",       3, 0, 0, 3 },
    { "median",            "median",      4, 0, 0, 0 },
    { "p95",               "95 %",        3, 0, 0, 3 },
    { "most",              "most",        3, 0, 0, 0 },
    { "radiance",          "radiance",    3, 0, 0, 2 },
    { "irradiance",        "irradiance",  3, 0, 0, 2 },
    { "irradiance_bias",   "bias",        3, 1, 0, 2 },
    { "bounce",            "bounce",      2, 0, 0, 2 },
    { "bounce_bias",       "bias",        3, 1, 0, 2 },
    { "irradiance_phases", "error",       4, 0, 0, 0 },
    { "irradiance_bias_error", "bias error", 4, 0, 0, 0 },
    { "irradiance_noise",  "noise",       4, 0, 0, 0 },
    { "hue_in_shade_degrees", "hue in shade", 2, 0, 0, 0 },
    { "product",           "1-(1-a)(1-b)", 3, 0, 0, 0 },
    { "max_of_two",        "max(a,b)",    3, 0, 0, 0 },
    { "sum_of_two",        "a+b",         3, 0, 0, 0 },
    { "between",           "between",     3, 0, 0, 0 },
    { "share_surfels",     "surfels, share", 2, 0, 1, 1 },
    { "share_interleave",     "interleave",     2, 0, 0, 1 },
    { "share_splat",       "splat",       2, 0, 0, 1 },
    { "share_deinterleave",   "deinterleave",   2, 0, 0, 1 },
    { "share_smooth",      "smooth",      2, 0, 0, 1 },
    { "share_sum",         "sum",         2, 0, 0, 1 },
    { "varies",            "varies",      4, 0, 0, 0 },
    { "varies_true",       "truth's",     4, 0, 0, 0 },
    { "varies_added",      "added",       4, 0, 0, 0 }
};
enum { SHOWN = sizeof shown / sizeof *shown };

static void plain_table(const markdown *m, const csv *c, int from, int to)
{
    int use[SHOWN], columns = 1;
    const int lit = csv_any(c, from, to, "irradiance"), scored = lit || csv_any(c, from, to, "share");
    const int phases = csv_any(c, from, to, "irradiance_phases"), scenes = csv_varies(c, from, to, "scene");
    for (int i = 0; i < SHOWN; ++i) {
        const struct shown *s = &shown[i];
        use[i] = csv_any(c, from, to, s->key) && !(s->still && to - from > 1 && !csv_varies(c, from, to, s->key))
            && !(s->when == 1 && scored) && !(s->when == 2 && phases) && !(s->when == 3 && lit);
        columns += use[i];
    }
    fputs(scenes ? "| scene | method |" : "| method |", m->file);
    for (int i = 0; i < SHOWN; ++i) if (use[i]) fprintf(m->file, " %s |", shown[i].head);
    fputc('\n', m->file);
    markdown_ruler(m, columns + scenes);
    for (int r = from; r < to; ++r) {
        if (scenes) fprintf(m->file, "| %s ", csv_text(c, r, "scene"));
        markdown_settings(m, c, r);
        for (int i = 0; i < SHOWN; ++i)
            if (use[i]) markdown_number(m, csv_number(c, r, shown[i].key), shown[i].digits, shown[i].sign);
        fputc('\n', m->file);
    }
}

/* What a table is of: the columns that only some kinds have. */
static int kind_of(const csv *c, int row)
{
    static const char *const keys[] = { "degrees", "varies", "product", "threads", "covered", "pixels_thousands" };
    int kind = 0;
    for (int k = 0; k < 6; ++k) if (*csv_text(c, row, keys[k])) kind |= 1 << k;
    return kind;
}
enum { TURNED = 1, PAIRED = 4, COSTING = 16 };

static int table_end(const csv *c, int from)
{
    int to = from + 1;
    while (to < c->rows && strcmp(csv_text(c, to - 1, "method"), "none") && kind_of(c, to) == kind_of(c, from)
        && (csv_same(c, to, from, "scene") || kind_of(c, from) & (PAIRED | COSTING))) ++to;
    return to;
}

/* label: how the first row's begins */
static const struct { const char *file, *scene, *label, *title, *about; } titles[] = {
    { "lit", "bunny", "slices", "Speed against accuracy: bunny and four boxes under a sky, one bounce",
        "![Cost against error, lit](pictures/chart-lit.svg)" },
    { "lit", "bunny", "ambient visibility", "", "" },
    { "lit", "columns", "", "What is hidden: `columns`, made to need several depth layers", "" },
    { "lit", "plates", "", "What is hidden: `plates`, thin plates over a floor", "" },
    { "lit", "room", "", "What is hidden: `room`, whose walls are sheets without thickness", "" },
    { "lit", "blocks-probe", "", "`blocks` under a high-contrast probe: error, its bias and its noise, hue",
      "Two points a direction, no bounce, no filter. Bias error: of the mean over 8 phases of the noise; noise: "
      "deviation over them. "
      "Hue in shade:\nmean angle of rgb to the truth's, degrees, where occluders keep off 5 % of the light or more." },
    { "aof", "ball-on-ground", "field", "What resolution buys: a ball on a ground", "" },
    { "aof", "cube-on-ground", "field", "What resolution buys: a cube on a ground", "" },
    { "aof", "bunny-on-floor", "field", "What resolution buys: the bunny on a floor", "" },
    { "aof", "casters", "", "What resolution buys: two dozen occluders on a ground and on each other", "" },
    { "aof", "bunny-on-floor", "bunny, 69", "What occluders cost a frame",
      "The pass alone, which needs no filter. Covered: pixels within an occluder's reach over the picture's, summed "
      "over the occluders." },
    { "aof", "bake", "", "What a bake takes", "" },
    { "aof", "two-balls", "", "Two occluders, one's occlusion a, the other's b: RMSE of three rules",
      "Between: share of the pixels whose true occlusion lies from max(a, b) to a + b." },
    { "deep", "bunny-on-floor", "ssao", "Speed against accuracy: bunny on a floor", "" },
    { "deep", "room", "ssao", "Speed against accuracy: `room`", "" },
    { "deep", "bunny-on-floor", "epsilon", "Epsilon and levels, surfels of 0.03 (the paper's figure 8)", "" },
    { "deep", "bunny-on-floor", "defaults", "Other choices, one at a time, surfels of 0.03", "" },
    { "deep", "light-fading", "", "Light as `ssdo` has it, which fades within the radius", "" },
    { "deep", "light-whole", "dss-lit", "Light as `dss-lit` has it, which does not fade", "" },
    { "deep", "gloss", "", "One specular bounce: `cornell`, lobe of exponent 8",
        "Irradiance stands for the lobe's radiance." },
    { "deep", "marble", "", "Scattering: the bunny in marble", "Irradiance stands for the radiance that leaves it." },
    { "deep", "bunny-on-floor", "5 levels", "Several levels beside one (the paper's figure 9): all reach as far", "" },
    { "deep", "turn", "", "The camera turns away: error on the same ground",
        "![The camera turns away](pictures/chart-deep-turn.svg)" },
    { "deep", "bunny-on-floor", "hsao", "The camera moves by a pixel a frame: how much visibility at a place varies",
        "" },
    { "deep", "light-whole", "ambient", "Where the time goes: shares of the stages, 512x512", "" },
    { "deep", "bunny-on-floor", "surfels", "How time grows with surfels, pixels and levels", "" }
};

/* Angles across. */
static void turn_table(const markdown *m, const csv *c, int from, int to)
{
    fputs("| degrees |", m->file);
    int last = from;
    for (; last < to && csv_same(c, last, from, "label"); ++last)
        fprintf(m->file, " %.0f |", csv_number(c, last, "degrees"));
    fputc('\n', m->file);
    markdown_ruler(m, last - from + 1);
    for (int r = from; r < to; ++r) {
        const int first = r == from || !csv_same(c, r, r - 1, "label");
        if (first && r > from) fputc('\n', m->file);
        if (first) markdown_settings(m, c, r);
        markdown_number(m, csv_number(c, r, "share"), 2, 0);
    }
    fputc('\n', m->file);
}

/* Tables of bands follow each other, one a light. */
#define BANDS "boxes-"
static int of_bands(const csv *c, int row) { return !strncmp(csv_text(c, row, "scene"), BANDS, strlen(BANDS)); }

/* Numbers of bands down, lights across. */
static void bands_table(const markdown *m, const csv *c, int from)
{
    const int end = table_end(c, from);
    fputs("| |", m->file);
    int lights = 0;
    for (int t = from; t < c->rows && of_bands(c, t); t = table_end(c, t), ++lights)
        fprintf(m->file, " %s |", csv_text(c, t, "scene") + strlen(BANDS));
    fputs(" time |\n", m->file);
    markdown_ruler(m, lights + 2);
    for (int r = from; r < end; ++r) {
        double time = 0;
        fprintf(m->file, "| %s |", strcmp(csv_text(c, r, "method"), "none") ? csv_text(c, r, "label") : "nothing");
        for (int t = from, k = 0; k < lights; t = table_end(c, t), ++k) {
            const int at = t + r - from;
            const int there = at < table_end(c, t) && csv_same(c, at, r, "label");
            markdown_number(m, there ? csv_number(c, at, "irradiance") : (double)NAN, 3, 0);
            time += csv_number(c, at, "relative_time") / lights;
        }
        markdown_number(m, time, 2, 0);
        fputc('\n', m->file);
    }
}

/* What a table's heading says; title "": it is the next of those about costs. */
static void find_title(const char **title, const char **about, const char *kind, const char *scene, const char *label)
{
    *title = scene;
    *about = "";
    for (size_t k = 0; k < sizeof titles / sizeof *titles; ++k) {
        if (strcmp(kind, titles[k].file) || strcmp(scene, titles[k].scene)
            || strncmp(label, titles[k].label, strlen(titles[k].label)))
            continue;
        *title = titles[k].title;
        *about = titles[k].about;
        return;
    }
}

void section_tables(const markdown *m, const char *kind, const char *name)
{
    const csv c = csv_read(name);
    int costs = 0;
    for (int from = 0, to; from < c.rows; from = to) {
        const char *title, *about;
        to = table_end(&c, from);
        if (of_bands(&c, from)) {
            markdown_heading(m, "How many bands: irradiance of `boxes` under five lights, its error over its mean",
                             "Suns: as they are blocked within the radius; sharp: with the whole scene's shadows. "
                             "Time: mean of the five.",
                             m->chart_note);
            bands_table(m, &c, from);
            while (to < c.rows && of_bands(&c, to)) to = table_end(&c, to);
            continue;
        }
        find_title(&title, &about, kind, csv_text(&c, from, "scene"), csv_text(&c, from, "label"));
        if (!*title)
            title = costs++ ? "What harmonics cost: the same scene"
                            : "What light costs: the same scene, 16 directions, no filter";
        markdown_heading(m, title, about, m->chart_note);
        if (kind_of(&c, from) & TURNED) turn_table(m, &c, from, to);
        else plain_table(m, &c, from, to);
    }
}
