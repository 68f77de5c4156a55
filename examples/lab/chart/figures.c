/* figures.c - examples/docs/FIGURES.md from the csv that make chart and make stability write.

      build/figures [report]

   Reads chart.txt and stability.txt (kind, command, commit, machine, driver) and the csv beside them. When both are of
   full runs the page is examples/docs/FIGURES.md, and the charts that it shows go to examples/docs/pictures; else it is
   FIGURES.md in the folder of the csv, for a quick run should not replace a full one. After a run of a part (SCENE,
   METHOD) all stays as it is. Bad input, or a write that fails: one line on stderr, status 2; the page is then as it
   was. */
#include "kit/kit.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>csv ------------------------------------------------------------------------------------------------------- */

enum { MOST_COLUMNS = 64, MOST_LINES = 8192, MOST_KEYS = 64 };
typedef struct csv { char *text, **cell; int rows, columns; } csv;      /* cell[0 .. columns - 1]: the heads */

static const char *folder = "report";

static char *file_text(const char *name)
{
    char path[1024];
    FILE *f;
    char *text = NULL;
    long size = -1;
    snprintf(path, sizeof path, "%s/%s", folder, name);
    f = fopen(path, "rb");
    if (!f) return NULL;
    if (!fseek(f, 0, SEEK_END) && (size = ftell(f)) >= 0 && !fseek(f, 0, SEEK_SET)) text = calloc((size_t)size + 1, 1);
    if (text && fread(text, 1, (size_t)size, f) != (size_t)size) { free(text); text = NULL; }
    fclose(f);
    return text;
}

/* heads: of a file that has none in its first line; NULL = it has. 0 rows: there is none such. */
static csv csv_read(const char *name, const char *heads)
{
    csv c = { NULL, NULL, 0, 0 };
    char *in = file_text(name), *out;
    int cells = 0;
    if (!in || !*in) return c;
    const size_t most = strlen(in) + (heads ? strlen(heads) : 0) + 2;
    char *all = malloc(most);
    c.cell = malloc(sizeof *c.cell * most);
    if (!all || !c.cell) { fputs("figures: out of memory\n", stderr); exit(2); }
    snprintf(all, most, "%s%s%s", heads ? heads : "", heads ? "\n" : "", in);
    free(in);
    c.text = in = out = all;
    while (*in) {
        int quoted = 0;
        c.cell[cells++] = out;
        for (; *in && (quoted || (*in != ',' && *in != '\n')); ++in) {
            if (*in != '"') *out++ = *in;
            else if (quoted && in[1] == '"') *out++ = *in++;
            else quoted = !quoted;
        }
        const char end = *in;
        if (end) ++in;
        *out++ = 0;
        if (end == ',') continue;
        if (!c.columns) c.columns = cells;
        if (cells % c.columns) { fprintf(stderr, "figures: %s: line %d has another number of columns\n", name,
            cells / c.columns + 1); exit(2); }
    }
    c.rows = c.columns ? cells / c.columns - 1 : 0;
    return c;
}

static const char *text_of(const csv *c, int row, const char *key)
{
    for (int i = 0; i < c->columns; ++i) if (!strcmp(c->cell[i], key)) return c->cell[(row + 1) * c->columns + i];
    return "";
}

static double number_of(const csv *c, int row, const char *key)
{
    const char *t = text_of(c, row, key);
    return *t ? atof(t) : (double)NAN;
}

static int same(const csv *c, int a, int b, const char *key) { return !strcmp(text_of(c, a, key), text_of(c, b, key)); }

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

static FILE *page;
static const char *chart_note, *stability_note;
static int full;                                  /* both runs are full ones: the page is examples/docs/FIGURES.md */

static void number(double v, int digits, int sign)
{
    if (isnan(v)) fputs(" |", page);
    else fprintf(page, sign ? " %+.*f |" : " %.*f |", digits, fabs(v) < 0.5 * pow(10, -digits) ? 0.0 : v);
}

static void heading(const char *title, const char *about, const char *note)
{
    fprintf(page, "\n### %s\n\n", title);
    for (const char *s = about; *s; ++s) {        /* beside the csv the pictures are in no folder */
        fputc(*s, page);
        if (!full && !strncmp(s, "(pictures/", 10)) s += 9;
    }
    if (*about) fputs("\n\n", page);
    fprintf(page, "*%s*\n\n", note);
}

static void ruler(int columns)
{
    fputc('|', page);
    while (columns--) fputs("---|", page);
    fputc('\n', page);
}

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
    { "share_shuffle",     "shuffle",     2, 0, 0, 1 },
    { "share_splat",       "splat",       2, 0, 0, 1 },
    { "share_unshuffle",   "unshuffle",   2, 0, 0, 1 },
    { "share_smooth",      "smooth",      2, 0, 0, 1 },
    { "share_sum",         "sum",         2, 0, 0, 1 },
    { "varies",            "varies",      4, 0, 0, 0 },
    { "varies_true",       "truth's",     4, 0, 0, 0 },
    { "varies_added",      "added",       4, 0, 0, 0 }
};
enum { SHOWN = sizeof shown / sizeof *shown };

static int any(const csv *c, int from, int to, const char *key)
{
    for (int i = from; i < to; ++i) if (*text_of(c, i, key)) return 1;
    return 0;
}

static int varies(const csv *c, int from, int to, const char *key)
{
    for (int i = from + 1; i < to; ++i) if (*text_of(c, i, key) && !same(c, from, i, key)) return 1;
    return 0;
}

/* The method's own name comes first where the label does not tell it. */
static void settings(const csv *c, int row)
{
    const char *label = text_of(c, row, "label"), *method = text_of(c, row, "method"), *set = text_of(c, row,
        "settings");
    if (!strcmp(method, "none")) { fputs("| nothing |", page); return; }
    if (!strcmp(method, "floor")) { fputs("| exact answer from one layer, thin sheets |", page); return; }
    fprintf(page, "| %s", label);
    if (strcmp(label, method) && strstr("hsao hsao-fast hsao-best hsao-march hsao-history ssao ssdo ssdo-fast "
        "s3ho s3ho-fast", method))
        fprintf(page, ", `%s`", method);
    const char *const mark = strchr(set, ' ') ? "" : "`";      /* others' passes have words, ours have settings */
    if (*set) fprintf(page, ": %s", mark);
    for (const char *s = set; *s; ++s) {
        fputc(*s, page);
        if (*s == ',' && s[1] != ' ') fputc(' ', page);
    }
    fprintf(page, "%s |", *set ? mark : "");
}

static void plain_table(const csv *c, int from, int to)
{
    int use[SHOWN], columns = 1;
    const int lit = any(c, from, to, "irradiance"), scored = lit || any(c, from, to, "share");
    const int phases = any(c, from, to, "irradiance_phases"), scenes = varies(c, from, to, "scene");
    for (int i = 0; i < SHOWN; ++i) {
        const struct shown *s = &shown[i];
        use[i] = any(c, from, to, s->key) && !(s->still && to - from > 1 && !varies(c, from, to, s->key))
            && !(s->when == 1 && scored) && !(s->when == 2 && phases) && !(s->when == 3 && lit);
        columns += use[i];
    }
    fputs(scenes ? "| scene | method |" : "| method |", page);
    for (int i = 0; i < SHOWN; ++i) if (use[i]) fprintf(page, " %s |", shown[i].head);
    fputc('\n', page);
    ruler(columns + scenes);
    for (int r = from; r < to; ++r) {
        if (scenes) fprintf(page, "| %s ", text_of(c, r, "scene"));
        settings(c, r);
        for (int i = 0; i < SHOWN; ++i) if (use[i]) number(number_of(c, r, shown[i].key), shown[i].digits,
            shown[i].sign);
        fputc('\n', page);
    }
}

/* What a table is of: the columns that only some kinds have. */
static int kind_of(const csv *c, int row)
{
    static const char *const keys[] = { "degrees", "varies", "product", "threads", "covered", "pixels_thousands" };
    int kind = 0;
    for (int k = 0; k < 6; ++k) if (*text_of(c, row, keys[k])) kind |= 1 << k;
    return kind;
}
enum { TURNED = 1, PAIRED = 4, COSTING = 16 };

static int table_end(const csv *c, int from)
{
    int to = from + 1;
    while (to < c->rows && strcmp(text_of(c, to - 1, "method"), "none") && kind_of(c, to) == kind_of(c, from)
        && (same(c, to, from, "scene") || kind_of(c, from) & (PAIRED | COSTING))) ++to;
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
      "Hue in shade:\nmean angle of rgb to the truth's, degrees, where blockers keep off 5 % of the light or more." },
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
static void turn_table(const csv *c, int from, int to)
{
    fputs("| degrees |", page);
    int last = from;
    while (last < to && same(c, last, from, "label")) { fprintf(page, " %.0f |", number_of(c, last,
        "degrees")); ++last; }
    fputc('\n', page);
    ruler(last - from + 1);
    for (int r = from; r < to; ++r) {
        if (r == from || !same(c, r, r - 1, "label")) { if (r > from) fputc('\n', page); settings(c, r); }
        number(number_of(c, r, "share"), 2, 0);
    }
    fputc('\n', page);
}

/* Numbers of bands down, lights across. */
static void bands_table(const csv *c, int from)
{
    const int end = table_end(c, from);
    fputs("| |", page);
    int lights = 0;
    for (int t = from; t < c->rows && !strncmp(text_of(c, t, "scene"), "boxes-", 6); t = table_end(c, t),
        ++lights) fprintf(page, " %s |", text_of(c, t, "scene") + 6);
    fputs(" time |\n", page);
    ruler(lights + 2);
    for (int r = from; r < end; ++r) {
        double time = 0;
        fprintf(page, "| %s |", strcmp(text_of(c, r, "method"), "none") ? text_of(c, r, "label") : "nothing");
        for (int t = from, k = 0; k < lights; t = table_end(c, t), ++k) {
            const int at = t + r - from;
            number(at < table_end(c, t) && same(c, at, r, "label") ? number_of(c, at, "irradiance") : (double)NAN, 3,
                0);
            time += number_of(c, at, "relative_time") / lights;
        }
        number(time, 2, 0);
        fputc('\n', page);
    }
}

static void tables_of(const char *file, const char *name)
{
    const csv c = csv_read(name, NULL);
    int bunnies = 0;
    for (int from = 0, to; from < c.rows; from = to) {
        const char *scene = text_of(&c, from, "scene"), *label = text_of(&c, from, "label");
        const char *title = scene, *about = "";
        to = table_end(&c, from);
        if (!strncmp(scene, "boxes-", 6)) {
            heading("How many bands: irradiance of `boxes` under five lights, its error over its mean",
                "Suns: as they are blocked within the radius; sharp: with the whole scene's shadows. Time: mean of "
                "the five.", chart_note);
            bands_table(&c, from);
            while (to < c.rows && !strncmp(text_of(&c, to, "scene"), "boxes-", 6)) to = table_end(&c, to);
            continue;
        }
        for (size_t k = 0; k < sizeof titles / sizeof *titles; ++k)
            if (!strcmp(file, titles[k].file) && !strcmp(scene, titles[k].scene) && !strncmp(label, titles[k].label,
                strlen(titles[k].label))) {
                title = titles[k].title;
                about = titles[k].about;
                break;
            }
        if (!*title) title = bunnies++ ? "What harmonics cost: the same scene"
            : "What light costs: the same scene, 16 directions, no filter";
        heading(title, about, chart_note);
        if (kind_of(&c, from) & TURNED) turn_table(&c, from, to); else plain_table(&c, from, to);
    }
}

/* ---- >>ambient: chart.csv, the same rows on every scene ---------------------------------------------------------- */

/* The row of a scene that is as row is. */
static int row_on(const csv *c, const char *scene, int row)
{
    for (int i = 0; i < c->rows; ++i)
        if (!strcmp(text_of(c, i, "scene"), scene) && same(c, i, row, "label") && same(c, i, row, "method")
            && same(c, i, row, "settings")) return i;
    return -1;
}

/* The mean over the scenes, without one, if it is named. NAN if a scene does not have it. */
static double mean_on(const csv *c, const char *const *scenes, int count, int row, const char *key, const char *without)
{
    double sum = 0;
    int n = 0;
    for (int k = 0; k < count; ++k) {
        const int at = without && !strcmp(scenes[k], without) ? -2 : row_on(c, scenes[k], row);
        if (at == -2) continue;
        sum += at < 0 ? (double)NAN : number_of(c, at, key);
        ++n;
    }
    return sum / n;
}

/* The worst of the scenes, and which it is. */
static void worst_on(const csv *c, const char *const *scenes, int count, int row, const char *key)
{
    double worst = 0;
    int whose = -1;
    for (int k = 0; k < count; ++k) {
        const int at = row_on(c, scenes[k], row);
        const double v = at < 0 || !*text_of(c, at, key) ? (double)NAN : number_of(c, at, key);
        if (v > worst) { worst = v; whose = k; }
    }
    if (whose < 0) fputs(" |", page);
    else fprintf(page, " %.3f, %s |", worst, scenes[whose]);
}

/* Which of ours stand beside others' passes. */
static int beside(const csv *c, int row)
{
    static const char *const of[][2] = { { "hsao-fast", "" }, { "hsao", "" }, { "hsao", "behind=slabs" },
        { "hsao-history", "" } };
    for (size_t k = 0; k < sizeof of / sizeof *of; ++k)
        if (!strcmp(text_of(c, row, "method"), of[k][0]) && !strcmp(text_of(c, row, "settings"), of[k][1])) return 1;
    return 0;
}

static void others(const csv *c, const char *const *scenes, int count, int first)
{
    int any = 0;
    for (int i = 0; i < first; ++i) any |= *text_of(c, i, "share_fitted") != 0;
    if (!any) return;
    heading("What others have: mean of the scenes",
            "Passes from npm, driven by their own code, denoisers included, the radius matched to ours and the rest\n"
            "as it does best in a coarse sweep. Worst: of the scenes. Fitted: after the best gain and power for each\n"
            "picture, with the truth in hand; ours, first, are raw.", chart_note);
    fputs("| pass | fetches | time | raw | worst | fitted | worst |\n", page);
    ruler(7);
    for (int peers = 0; peers < 2; ++peers)
        for (int i = 0; i < first; ++i) {
            if (peers ? !*text_of(c, i, "share_fitted") : !beside(c, i)) continue;
            settings(c, i);
            number(mean_on(c, scenes, count, i, "fetches", NULL), 1, 0);
            number(mean_on(c, scenes, count, i, "relative_time", NULL), 2, 0);
            number(mean_on(c, scenes, count, i, "share", NULL), 3, 0);
            worst_on(c, scenes, count, i, "share");
            number(peers ? mean_on(c, scenes, count, i, "share_fitted", NULL) : (double)NAN, 3, 0);
            worst_on(c, scenes, count, i, "share_fitted");
            fputc('\n', page);
        }
}

static void ambient(void)
{
    const csv c = csv_read("chart.csv", NULL);
    const char *scenes[32];
    int count = 0, first = 0;
    for (int i = 0; i < c.rows && count < 32; ++i) if (!i || !same(&c, i, i - 1,
        "scene")) scenes[count++] = text_of(&c, i, "scene");
    if (!count) return;
    while (first < c.rows && !strcmp(text_of(&c, first, "scene"), scenes[0])) ++first;
    heading("Mean of the scenes", "![Cost against error](pictures/chart.svg)\n\nNoise: deviation over two phases "
            "of it; model error: RMSE of their mean.", chart_note);
    fputs("| method | fetches | bytes | time | error | without `plates` | model error | noise |\n", page);
    ruler(8);
    for (int i = 0; i < first; ++i) {
        if (*text_of(&c, i, "share_fitted")) continue;
        settings(&c, i);
        number(mean_on(&c, scenes, count, i, "fetches", NULL), 1, 0);
        number(mean_on(&c, scenes, count, i, "bytes", NULL), 0, 0);
        number(mean_on(&c, scenes, count, i, "relative_time", NULL), 2, 0);
        number(mean_on(&c, scenes, count, i, "share", NULL), 3, 0);
        number(mean_on(&c, scenes, count, i, "share", "plates"), 3, 0);
        number(mean_on(&c, scenes, count, i, "model_error", NULL), 3, 0);
        number(mean_on(&c, scenes, count, i, "noise", NULL), 3, 0);
        fputc('\n', page);
    }
    for (int peers = 0; peers < 2; ++peers) {
        int begun = 0;
        if (peers) others(&c, scenes, count, first);
        for (int i = 0; i < first; ++i) {
            if ((*text_of(&c, i, "share_fitted") != 0) != peers) continue;
            if (!begun++) {
                heading(peers ? "What others have: scene by scene, matched and fitted" : "Scene by scene: error", "",
                        chart_note);
                fputs(peers ? "| pass |" : "| method |", page);
                for (int k = 0; k < count; ++k) fprintf(page, " %s |", scenes[k]);
                fputc('\n', page);
                ruler(count + 1);
            }
            settings(&c, i);
            for (int k = 0; k < count; ++k) {
                const int at = row_on(&c, scenes[k], i);
                number(at < 0 ? (double)NAN : number_of(&c, at, peers ? "share_fitted" : "share"), 3, 0);
            }
            fputc('\n', page);
        }
    }
}

/* Light on every pair of a scene and a probe: a method's share of no occlusion's error over all of them. */
static void pairs(void)
{
    const csv c = csv_read("chart-pairs.csv", NULL);
    int block = 0;
    if (!c.rows) return;
    while (block < c.rows && same(&c, block, 0, "scene") && same(&c, block, 0, "probe")) ++block;
    if (c.rows % block) return;
    heading("On every pair of a scene and a probe",
            "RMSE of irradiance over that of no occlusion, no bounce: the mean over the pairs, the worst of them, and "
            "how many are below 1, where a method is better than nothing.", chart_note);
    fputs("| method | mean | worst | | below 1 | time |\n|---|---|---|---|---|---|\n", page);
    for (int i = 0; i < block - 2; ++i) {           /* the last two: no occlusion, the truth's noise */
        double mean = 0, worst = 0, time = 0;
        int below = 0, whose = i;
        for (int row = i; row < c.rows; row += block) {
            const double share = number_of(&c, row, "share");
            mean += share * block / c.rows;
            time += number_of(&c, row, "relative_time") * block / c.rows;
            below += share < 1;
            if (share > worst) { worst = share; whose = row; }
        }
        if (strcmp(text_of(&c, i, "method"), "none")) settings(&c, i);
        else fprintf(page, "| %s |", text_of(&c, i, "label"));
        fprintf(page, " %.3f | %.3f | %s, %s | %d of %d |", mean, worst, text_of(&c, whose, "scene"),
                text_of(&c, whose, "probe"), below, c.rows / block);
        number(time, 2, 0);
        fputc('\n', page);
    }
    double noise = 0;
    for (int row = block - 1; row < c.rows; row += block) noise = fmax(noise, number_of(&c, row, "irradiance"));
    fprintf(page, "\nThe truth's own noise is at most %.4f of the mean.\n", noise);
}

/* ---- >>rest: the plan, costs, stability -------------------------------------------------------------------------- */

static void plan(void)
{
    const csv c = csv_read("plan.csv", NULL), all = csv_read("plan-summary.csv", NULL);
    if (!c.rows) return;
    fputs("\n## The plan, on views that it was not fitted on\n", page);
    heading("Good plans", "Good: at most 1.25 times the cost of the cheapest choice that meets the error, and at "
        "most 1.2 times the error asked for.", chart_note);
    fputs("| | good |\n|---|---|\n", page);
    for (int i = 0; i < all.rows; ++i) fprintf(page, "| %s | %s of %s |\n", text_of(&all, i, "what"), text_of(&all, i,
        "good"), text_of(&all, i, "pairs"));
    heading("View by view, without history", "", chart_note);
    fputs("| scene, radius, light | wanted | good |\n|---|---|---|\n", page);
    for (int from = 0, to; from < c.rows; from = to) {
        int good = 0;
        for (to = from; to < c.rows && same(&c, to, from, "scene") && same(&c, to, from,
            "wanted"); ++to) good += atoi(text_of(&c, to, "good"));
        fprintf(page, "| %s | %s | %d of %d |\n", text_of(&c, from, "scene"), text_of(&c, from, "wanted"), good,
            to - from);
    }
}

static void costs(void)
{
    const csv c = csv_read("costs.csv", NULL);
    if (!c.rows) return;
    fputs("\n## What choices cost\n", page);
    heading("Instructions and fetches of the fragment stages",
        "As glslang compiles them to SPIR-V, loops counted once, not optimised. Fetching: instructions that fetch; "
        "texels: the most that a pixel fetches.", chart_note);
    fputs("| pass | instructions | fetching | texels | what choices add, instructions |\n|---|---|---|---|---|\n",
        page);
    const char *const base = text_of(&c, 0, "choice");
    for (int i = 0; i < c.rows; ++i) {
        int more = 0;
        if (strcmp(text_of(&c, i, "stage"), "frag") || strcmp(text_of(&c, i, "choice"), base)) continue;
        fprintf(page, "| %s | %s | %s | %s |", text_of(&c, i, "pass"), text_of(&c, i, "instructions"), text_of(&c, i,
            "fetch_instructions"), text_of(&c, i, "texels_a_pixel"));
        for (int k = 0; k < c.rows; ++k) {
            const double d = number_of(&c, k, "instructions") - number_of(&c, i, "instructions");
            if (k == i || !same(&c, i, k, "pass") || strcmp(text_of(&c, k, "stage"), "frag") || fabs(d) < 0.5) continue;
            fprintf(page, "%s %s %+.0f", more++ ? "," : "", text_of(&c, k, "choice"), d);
        }
        fputs(" |\n", page);
    }
}

/* The number of a method for the cause that begins at row; NULL: there is none. */
static const char *number_at(const csv *c, int row, const char *method)
{
    for (int i = row; i < c->rows && same(c, i, row, "cause"); ++i) if (!strcmp(text_of(c, i, "method"),
        method)) return text_of(c, i, "number");
    return NULL;
}

static int over_frames(const char *cause) { return !strncmp(cause, "kept-", strlen("kept-")); }

/* The sweeps of what is averaged over frames. */
static void frames(const csv *c)
{
    static const struct { const char *cause, *title; } named[] = {
        { "kept-camera", "camera sideways, 0 to 4 pixels a frame" }, { "kept-dolly", "camera forward, 0.1 to 1 %" },
        { "kept-roll", "camera rolls, 0.1 to 1 degree" }, { "kept-slide", "a box slides, 0.1 to 4 pixels" },
        { "kept-appear", "a box appears" }, { "kept-jump", "a box is elsewhere at once" },
        { "kept-cut", "a cut that nobody tells of" }, { "kept-newly", "1 to 8 pixels: what is newly seen alone" },
        { "kept-light", "a sun turns, 0 to 8 degrees" },
        { "kept-trail-appear", "visibility left of what was: a box appears" },
        { "kept-trail-jump", "the same: a box is elsewhere at once" },
        { "kept-flicker", "deviation over the truth's, 0.1 to 1 pixel a frame" } };
    static const char *const methods[] = { "hsao-fast-history", "hsao-history", "hsao-2x8-history", "ssdo-history",
        "ssdo-fast-history" };
    enum { METHODS = sizeof methods / sizeof *methods };
    int begun = 0;
    for (int i = 0; i < c->rows; ++i) {
        const char *cause = text_of(c, i, "cause"), *title = cause;
        if ((i && same(c, i, i - 1, "cause")) || !over_frames(cause)) continue;
        if (!begun++) {
            heading("Over frames", "`history = 1`; the worst of each sweep: error over that of the frame alone, in "
                "any of 16\nframes (after a change: 1 to 8 frames later); 160x90. Below 1 history pays. Visibility "
                "and deviation are absolute.",
                stability_note);
            fputs("| cause |", page);
            for (int m = 0; m < METHODS; ++m) fprintf(page, " %s |", methods[m]);
            fputs("\n", page);
            ruler(METHODS + 1);
        }
        for (size_t k = 0; k < sizeof named / sizeof *named; ++k)
            if (!strcmp(named[k].cause, cause)) title = named[k].title;
        const int absolute = !strncmp(cause, "kept-trail", 10) || !strcmp(cause, "kept-flicker");
        fprintf(page, "| %s |", title);
        for (int m = 0; m < METHODS; ++m) {
            const char *t = number_at(c, i, methods[m]);
            number(t && strcmp(t, "nan") ? atof(t) : (double)NAN, absolute ? 4 : 2, 0);
        }
        fputc('\n', page);
    }
}

static void stability(void)
{
    static const struct { const char *cause, *title; } named[] = {
        { "tilt", "view tilt to 89 degrees, a bare plane" }, { "tilt-wall", "the same, a wall beside it" },
        { "pole", "a pole 20 to 0.1 pixels thick, a wall four radii behind" }, { "rail",
            "a rail as thin, half a radius over a floor" },
        { "halo", "a wall 0.1 to 30 radii behind an edge" }, { "radius", "radius 0.1 to 240 pixels (of 240x135)" },
        { "off-screen", "a box slides off the screen" }, { "hidden", "a box slides behind another" }, { "near-plane",
            "a box crosses the near plane" },
        { "depth-16f", "16-bit float view depth: good to" }, { "depth-24", "24-bit window depth: good to" },
        { "depth-32f", "32-bit float window depth: good to" }, { "depth-reversed",
            "reversed 32-bit float depth: good to" },
        { "camera", "camera sideways, 0.1 to 4 pixels a frame: deviation" }, { "dolly",
            "camera forward, 0.1 to 3 % a frame: deviation" },
        { "light", "a sun turns 0.25 to 8 degrees a frame: second difference" }, { "rotation",
            "an object turns as much: the same, raw" },
        { "resolution", "160x90 to 3840x2160, constant angular radius" } };
    static const char *const methods[] = { "ssao", "hsao-fast", "hsao", "hsao-back", "hsao-best", "hsao-march",
        "ssdo", "s3ho", "ssbn", "dss", "dss-lit", "aof" };
    enum { METHODS = sizeof methods / sizeof *methods };
    const csv c = csv_read("stability.csv", NULL);
    int begun = 0;
    if (!c.rows) return;
    fputs("\n## Where methods fail\n", page);
    heading("The worst of each sweep", "RMSE of ambient visibility unless the row says otherwise; 240x135, `dss` "
        "with `size` 0.03. Good to: the greatest depth at which\n"
        "RMSE stays below 0.02, near plane 0.1. Deviation: of a place over the frames after true reprojection, less "
        "the truth's.\n"
        "Beside: no AO at all, the truth's own flicker, or open ground.", stability_note);
    fputs("| cause |", page);
    for (int m = 0; m < METHODS; ++m) fprintf(page, " %s |", methods[m]);
    fputs(" beside |\n", page);
    ruler(METHODS + 2);
    for (int i = 0; i < c.rows; ++i) {
        const char *cause = text_of(&c, i, "cause"), *title = cause, *beside = NULL;
        int any_ = 0;
        if (i && same(&c, i, i - 1, "cause")) continue;
        for (int m = 0; m < METHODS; ++m) any_ |= number_at(&c, i, methods[m]) != NULL;
        if (!any_) continue;
        for (size_t k = 0; k < sizeof named / sizeof *named; ++k) if (!strcmp(named[k].cause,
            cause)) title = named[k].title;
        fprintf(page, "| %s |", title);
        static const char *const besides[] = { "no AO", "truth", "open" };
        for (int k = 0; k < 3 && !beside; ++k) beside = number_at(&c, i, besides[k]);
        for (int m = 0; m <= METHODS; ++m) {
            const char *t = m < METHODS ? number_at(&c, i, methods[m]) : beside;
            const double v = t && strcmp(t, "nan") ? atof(t) : (double)NAN;
            number(v, !(v < 1) || v < 5e-5 ? 0 : v < 0.03 ? 4 : 3, 0);
        }
        fputc('\n', page);
    }
    frames(&c);
    for (int i = 0; i < c.rows; ++i) {
        int any_ = 0;
        if (i && same(&c, i, i - 1, "cause")) continue;
        for (int m = 0; m < METHODS; ++m) any_ |= number_at(&c, i, methods[m]) != NULL;
        if (any_ || over_frames(text_of(&c, i, "cause"))) continue;
        if (!begun++) {
            heading("The library's maths alone", "Worst of each sweep: most negative irradiance of a sun as "
                "harmonics, over what faces it; largest error and step of occlusion along\n"
                "a line through a field's hull; largest change of the number of surfels in a step of 1 % of the "
                "distance.", stability_note);
            fputs("| cause | curve | worst |\n|---|---|---|\n", page);
        }
        for (int k = i; k < c.rows && same(&c, k, i, "cause"); ++k) {
            const char *t = text_of(&c, k, "number");
            if ((k > i && same(&c, k, k - 1, "method")) || !*t || !strcmp(t, "nan")) continue;
            fprintf(page, "| %s | %s |", text_of(&c, k, "cause"), text_of(&c, k, "method"));
            number(atof(t), 4, 0);
            fputc('\n', page);
        }
    }
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

/* A run's kind and, in note, where its figures come from; 0 = there was none. f, q, p. */
static char run_of(const char *name, const char **note)
{
    char *text = file_text(name), *line = text ? strchr(text, '\n') : NULL;
    if (!line) { *note = ""; return 0; }
    line[strcspn(line + 1, "\n") + 1] = 0;
    *note = line + 1;
    return *text;
}

/* A chart that the page and README.md show. */
static int kept(const char *name, kit_error *err)
{
    char path[1024], *text = file_text(name);
    snprintf(path, sizeof path, "examples/docs/pictures/%s", name);
    const int failed = text ? kit_file_write(path, text, strlen(text), err)
                            : kit_fail(err, "%s/%s: cannot be read", folder, name);
    free(text);
    return failed;
}

int main(int argc, char **argv)
{
    char path[1024], *text = NULL;
    size_t size;
    kit_error err;
    if (argc > 2 || (argc > 1 && *argv[1] == '-')) { fputs("usage: figures [FOLDER of the csv]\n", stderr); return 2; }
    if (argc > 1) folder = argv[1];
    const char chart = run_of("chart.txt", &chart_note), stable = run_of("stability.txt", &stability_note);
    if (chart == 'p' || stable == 'p') { puts("figures: left as they are, for a part alone was measured"); return 0; }
    if (!chart && !stable) { fprintf(stderr, "figures: %s: holds neither chart.txt nor stability.txt (make chart, "
        "make stability)\n", folder); return 2; }
    full = chart == 'f' && stable == 'f';
    snprintf(path, sizeof path, full ? "examples/docs/FIGURES.md" : "%s/FIGURES.md", folder);
    page = open_memstream(&text, &size);
    if (!page) { fputs("figures: out of memory\n", stderr); return 2; }
    fputs("# Figures\n\nMade by `make chart` and `make stability` from the csv that they write: change nothing here. "
        "Above each table stand the command,\n"
          "commit, machine and driver that it comes from.", page);
    fputs(full ? "\n" : " Quick runs have smaller pictures, fewer rays and fewer rows.\n", page);
    fputs("\n- Time: GL time of all passes, filter included, relative to one unblurred 16-sample `ssao` in the same "
        "interleaved run.\n"
          "- Error and share: RMSE against ray-traced truth over the RMSE of having no ambient occlusion. Raw "
          "output: no gain, no exponent.\n"
          "- Radiance, irradiance, bounce: RMSE over the mean of the truth; biases likewise, below 0 = too dark.\n"
          "- Bytes: each pass reads each of its inputs' texels once and writes its outputs, a pixel. Fetches: texel "
          "fetches a pixel.\n", page);
    if (chart) {
        fputs("\n## Ambient occlusion\n", page);
        ambient();
        fputs("\n## Light\n", page);
        tables_of("lit", "chart-lit.csv");
        pairs();
        fputs("\n## Occlusion between moving objects\n", page);
        tables_of("aof", "chart-aof.csv");
        fputs("\n## Deep screen space\n", page);
        tables_of("deep", "chart-deep.csv");
        plan();
        costs();
    }
    if (stable) stability();
    int failed = ferror(page);
    if (fclose(page) || failed) { fputs("figures: out of memory\n", stderr); return 2; }
    failed = full && (kept("chart.svg", &err) || kept("chart-lit.svg", &err) || kept("chart-deep-turn.svg", &err));
    if (failed || kit_file_write(path, text, size, &err)) { fprintf(stderr, "figures: %s\n", err.text); return 2; }
    free(text);
    printf("figures: %s%s\n", path, full ? "" : " (examples/docs/FIGURES.md is written when both runs are full ones)");
    return 0;
}
