/* report.c - the laboratory's charts: pictures beside the truth, and speed against accuracy. --help lists commands and
   options.

   Each command writes a record of its name, such as demo.js, beside index.html, which shows all records that are there.
   Truth is kept under build/cache, and so are an interrupted chart's results, which the same command continues. Bad
   input, or a write that fails: one line on stderr, status 2.

   report.c puts sections into records. A section of chart/ is a list of sets, and papers/ has a list of sheets. Both
   are lines of csv, and name their rows and views. Below lies page/: how records, tables and pictures are written, the
   results of a chart that is not complete, and the page that shows them. Below that lies measure/: lines of csv, views
   and their truth; methods drawn, scored and timed. Nothing calls upward; no section calls another. */
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include "kit/kit_gl.h"
#include "lab/chart/chart.h"
#include "lab/measure/folder.h"
#include "lab/page/page.h"
#include "lab/page/table.h"
#include "lab/papers/papers.h"

/* ---- >>commands -------------------------------------------------------------------------------------------------- */

static int begin(page *record, const options *o, const char *name, const char *command, kit_error *err)
{
    const int part = o->method || o->scenes || o->paper || o->first >= 0 || o->seeds;
    const char *const kind = part ? "part" : o->quick ? "quick" : "full";
    char line[96];
    snprintf(line, sizeof line, command, o->quick ? *command == 'm' ? " QUICK=1" : " --quick" : "");
    if (page_begin(record, name, kind, line, kit_gl_name(), err)) return -1;
    table_columns(record->file);
    return 0;
}

static int end(page *record, const options *o, const char *name, kit_error *err)
{
    units_end();
    printf("page: %s/index.html\n", o->out);
    return page_end(record, o->out, name, err);
}

/* A command. takes: bits of its options beside --out and --context. record: the command that its record names; of: its
   sections; planned: 1 if the plan is charted behind them; ahead: runs before there is a GL context. */
enum { MESH = 1, QUICK = 2, SCENES = 4, METHOD = 8, PAPER = 16, SEEDS = 32, DRAWN = 64, SOME = 128, MOST_PARTS = 6 };
typedef struct command command;
struct command {
    const char *name, *about;
    int takes;
    int (*run)(const command *c, const options *o, kit_error *err), (*ahead)(const options *o, kit_error *err);
    const char *record;
    const section *of[MOST_PARTS];
    int planned;
};

/* Makes the record of sections that have rows, and of the plan if planned is 1. */
static int record_of(const char *name, const char *record_as, const section *const *c, int count, int planned,
                     const options *o, kit_error *err)
{
    page record;
    int units = 0;
    for (int k = 0; k < count; ++k) units += section_units(c[k], o);
    units_begin(o, units);
    if (begin(&record, o, name, record_as, err)) return -1;
    for (int k = 0; k < count; ++k)
        if (section_units(c[k], o) && section_chart(record.file, c[k], o, err)) return -1;
    return (planned && plan_chart(record.file, o, err)) || end(&record, o, name, err) ? -1 : 0;
}

/* Fails if the option --method names no known method. */
static int check_asked(const options *o, kit_error *err)
{
    kit_method m;
    int known = 0;
    for (int i = 0; kit_method_at(&m, i); ++i) known |= units_asked(o, m.name);
    if (!known)
        return kit_fail(err, "--method %s: no method's name begins so (build/render --list names all)", o->method);
    return o->scenes && !ao_entries(o)
               ? kit_fail(err,
                          "--method %s: no row of ambient occlusion's chart is of such a method, and --scene shows "
                          "that alone",
                          o->method)
               : 0;
}

/* Charts a command's sections: of a mesh or of scenes ambient occlusion alone, and by --method no whole chart's seeds
   and plan. */
static int chart(const command *c, const options *o, kit_error *err)
{
    const int alone = o->mesh || o->scenes, whole = c->takes & SCENES && c->takes & DRAWN;
    int count = 0;
    while (c->of[count] && !(count && alone) && !(whole && o->method && c->of[count] == &seeds_chart)) ++count;
    if (o->mesh) ao_demo_of(o->mesh);
    const int planned = c->planned && !alone && !o->method;
    return check_asked(o, err) ? -1 : record_of(c->name, c->record, c->of, count, planned, o, err);
}

/* Measures scenes by seed ahead, several at once, as they are not timed. */
static int chart_ahead(const options *o, kit_error *err)
{
    return o->scenes || o->method ? 0 : seeds_ahead(o, err) || plan_ahead(o, err) ? -1 : 0;
}

static int seeds(const command *of, const options *o, kit_error *err)
{
    const int tuned = o->first >= 0 && o->first < SEEDS_JUDGED;
    section own = seeds_chart;
    const section *const c = &own;
    char shown[96];
    const int units = section_units(&own, o);
    if (!units) return kit_fail(err, "--method %s: no row of the charts is of such a method", o->method);
    if (tuned) own.csv = "seeds-fit.csv";
    snprintf(shown, sizeof shown, "%s", of->record);
    if (o->first >= 0)
        snprintf(shown + strlen(shown), sizeof shown - strlen(shown), " --from %d --count %d", o->first, units);
    return record_of(tuned ? "seeds-fit" : "seeds", shown, &c, 1, 0, o, err);
}

/* Makes the record of the tables and figures of five papers, beside those of comparable scenes drawn here. */
static int papers(const command *c, const options *o, kit_error *err)
{
    page record;
    if (!papers_units(o))
        return kit_fail(err, "--paper %s: there is none that begins so (\"HSAO08 Table 1\")", o->paper);
    if (o->quick) stage_thrift = PAPERS_THRIFT;
    units_begin(o, papers_units(o));
    return begin(&record, o, c->name, c->record, err) || papers_chart(record.file, o, err)
                   || end(&record, o, c->name, err)
               ? -1
               : 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int fit(const command *c, const options *o, kit_error *err)
{
    (void)c;
    return plan_fit(o, err);
}

static const command commands[] = {
    { "demo", "Images and tables of every method beside the ground truth, in two minutes.", MESH, chart, NULL,
      "make demo", { &ao_demo, &lit_demo, &fields_demo, &deep_demo }, 0 },
    { "chart", "Speed against accuracy, in an hour: chart*.csv.", QUICK | SCENES | METHOD | DRAWN, chart, chart_ahead,
      "make chart%s", { &ao_chart, &lit_chart, &fields_chart, &deep_chart, &seeds_chart }, 1 },
    { "ambient", "Its part on ambient occlusion: chart.csv.", QUICK | SCENES | METHOD, chart, NULL,
      "build/report ambient%s", { &ao_chart }, 0 },
    { "lit", "Its part on light: chart-lit.csv.", QUICK | METHOD, chart, NULL, "build/report lit%s",
      { &lit_chart }, 0 },
    { "fields", "Its part on ambient occlusion fields: chart-aof.csv.", QUICK | METHOD, chart, NULL,
      "build/report fields%s", { &fields_chart }, 0 },
    { "deep", "Its part on deep screen space: chart-deep.csv.", QUICK | METHOD, chart, NULL, "build/report deep%s",
      { &deep_chart }, 0 },
    { "light", "Light on every pair of a scene and a probe: chart-pairs.csv.", QUICK | METHOD, chart, NULL,
      "make light%s", { &pairs_chart }, 0 },
    { "seeds", "Ambient occlusion on scenes by seed and on models: seeds.csv.", QUICK | METHOD | SEEDS | DRAWN, seeds,
      seeds_ahead, "build/report seeds%s", { NULL }, 0 },
    { "papers", "The papers' tables and figures, in some minutes: papers.csv.", QUICK | PAPER, papers, NULL,
      "make papers%s", { NULL }, 0 },
    { "fit", "The errors that build/fit fits the planner's table to: plan-fit.csv.", QUICK | SOME, fit, plan_fit_ahead,
      "", { NULL }, 0 },
    { "plan", "The planner on views that it was not fitted on: plan.csv.", QUICK | SOME, chart, plan_ahead,
      "build/report plan", { NULL }, 1 }
};
/* The options. of: the commands that take one; 0: all. */
#define TO(member) .at = offsetof(options, member)
static const struct argument { kit_option option; int of; } arguments[] = {
    { { "--out", "FOLDER", "The folder to write into [report].", .kind = KIT_TEXT, TO(out) }, 0 },
    { { "--context", "NAME", "osmesa, egl or egl-es: the source of the GL context.", .kind = KIT_TEXT, TO(context) },
      0 },
    { { "--mesh", "MODEL", "Ambient occlusion of that model alone.", .kind = KIT_TEXT, TO(mesh) }, MESH },
    { { "--quick", NULL, "Smaller images and fewer rows.", .kind = KIT_FLAG, TO(quick) }, QUICK },
    { { "--visibility", NULL, "Ambient visibility alone, without light.", .kind = KIT_FLAG, TO(visibility) }, SOME },
    { { "--scene", "NAME", "Ambient occlusion of that scene alone. It may be given several times.", .kind = KIT_LIST,
        TO(scene), .most = MOST_SCENES, .said = offsetof(options, scenes) }, SCENES },
    { { "--method", "NAME", "Methods whose names begin so, without scenes by seed and the planner.", .kind = KIT_TEXT,
        TO(method) }, METHOD },
    { { "--paper", "NAME", "Papers, tables and figures whose names begin so: HSAO08, \"DSS14 Figure 7\".",
        .kind = KIT_TEXT, TO(paper) }, PAPER },
    { { "--from", "SEED", "The first seed [1000]. Settings may be tuned on those below 1000: a run that begins there "
                          "ends there, and writes seeds-fit.csv.", .kind = KIT_WHOLE, TO(first), .most = 999999 },
      SEEDS },
    { { "--count", "N", "The number of scenes by seed.", .kind = KIT_WHOLE, TO(seeds), .least = 1,
        .most = MOST_SEEDS }, SEEDS },
    { { "--drawn", "TEXT", "The text whose hash draws half of the scenes by seed.", .kind = KIT_TEXT, TO(drawn) },
      DRAWN }
};

static const char usage[] = "report COMMAND [options]";

/* Prints the help: the commands, and behind them the options, each with the commands that take it. */
static int helped(int argc, char **argv)
{
    static char text[COUNT(arguments)][320];
    kit_option help[1 + COUNT(commands) + COUNT(arguments) + 1] = {
        { .about = "Measures the methods, and adds a page of the command's name to index.html." } }, *to = help + 1;
    for (const command *c = commands; c < commands + COUNT(commands); ++c)
        *to++ = (kit_option){ .name = c->name, .about = c->about };
    for (int k = 0; k < COUNT(arguments); ++k) {
        const struct argument *a = arguments + k;
        int used = snprintf(text[k], sizeof *text, "%s%s", a->option.about, a->of ? " For" : "");
        for (const command *c = commands; c < commands + COUNT(commands) && a->of; ++c)
            if (c->takes & a->of) used += snprintf(text[k] + used, sizeof *text - (size_t)used, " %s,", c->name);
        if (a->of) text[k][used - 1] = '.';
        *to = a->option;
        to++->about = text[k];
    }
    return kit_help(argc, argv, usage, help);
}

static int parse(options *o, const command *c, int argc, char **argv, kit_error *err)
{
    kit_option table[COUNT(arguments) + 1] = { { NULL } }, *to = table;
    for (const struct argument *a = arguments; a < arguments + COUNT(arguments); ++a)
        if (!a->of || (c->takes & a->of)) *to++ = a->option;
    *o = (options){ .out = "report", .first = -1 };
    return kit_options(o, table, argc - 1, argv + 1, NULL, err);
}

static int run(const command *c, int argc, char **argv, kit_error *err)
{
    options o;
    if (parse(&o, c, argc, argv, err)) return -1;
    if (o.quick) stage_thrift = QUICK_THRIFT;
    units_load();
    return folder_make(o.out, err) || (c->ahead && c->ahead(&o, err))
                   || kit_gl_open(o.context, err) || c->run(c, &o, err)
               ? -1
               : kit_streams_close(err);
}

int main(int argc, char **argv)
{
    const command *c = commands;
    kit_error err = { "" };
    if (helped(argc, argv)) return 0;
    kit_streams_open();
    while (argc > 1 && c < commands + COUNT(commands) && strcmp(c->name, argv[1])) ++c;
    if (argc < 2) kit_fail(&err, "a command is missing: %s (--help explains it)", usage);
    else if (c == commands + COUNT(commands))
        kit_fail(&err, "%s: there is no such command (--help lists them)", argv[1]);
    else run(c, argc, argv, &err);
    if (*err.text) {
        kit_progress("", 1);
        fprintf(stderr, "report: %s\n", err.text);
        return 2;
    }
    kit_gl_close();
    return 0;
}
