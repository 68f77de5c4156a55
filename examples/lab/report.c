/* report.c - what the methods are worth: pictures beside the truth, and speed against accuracy.

      build/report demo  [--out report] [--context egl] [--mesh MODEL]     pictures and tables, in a minute
      build/report chart [--out report] [--context egl] [--quick] [--scene NAME]... [--method NAME] [--commit HASH]
         chart*.csv and the rest, in an hour
      build/report light [--out report] [--context egl] [--quick] [--method NAME]     chart-pairs.csv
      build/report seeds [--out report] [--context egl] [--quick] [--method NAME] [--from 1000] [--count 21]
         [--commit HASH]     scenes by seed and models: seeds.csv
      build/report papers [--out report] [--context egl] [--quick] [--paper "HSAO08 Table 1"]     papers.csv, in some
         minutes
      build/report fit   [--out report] [--context egl]     plan-fit.csv, for fit.c
      build/report plan  [--out report] [--context egl]     the chart's part on the plan: plan.csv

   Each writes a record of its name, demo.js, beside index.html, which shows all that are there.
   With --mesh or --scene only ambient occlusion is shown; else light, fields and deep screen space, too, and with
   neither --scene nor --method scenes by seed and the plan. --method: the rows of methods whose names begin so. --from:
   the first seed; those below 1000, which settings may be tuned on, end there, and their files are called seeds-fit.
   --commit: its hash draws half of the scenes by seed.
   Truth is kept under build/cache/, and so is what an interrupted chart has measured: the same command goes on from
   there. Bad input, or a write that fails: one line on stderr, status 2.

   Here are the commands, which put sections of records together; a section is a file of chart/, a paper one of papers/,
   which sets up some of its stages as chart/ does. Below them lies page/: how records, tables and pictures are written,
   what is kept of a chart that is not whole, and the page that shows them; below that measure/: scenes and their truth,
   methods drawn, scored and timed. Nothing calls upward; no section calls another. */
#include <stdlib.h>
#include <string.h>
#include "kit/kit_gl.h"
#include "lab/chart/ao.h"
#include "lab/chart/deep.h"
#include "lab/chart/fields.h"
#include "lab/chart/lit.h"
#include "lab/chart/pairs.h"
#include "lab/chart/plan.h"
#include "lab/chart/seeds.h"
#include "lab/chart/strip.h"
#include "lab/measure/folder.h"
#include "lab/page/page.h"
#include "lab/page/table.h"
#include "lab/papers/papers.h"

/* ---- >>demo ------------------------------------------------------------------------------------------------------ */

static void demo_text(const char *out, int mesh)
{
    ao_demo_text(stdout);
    strip_text(stdout);
    if (!mesh) lit_demo_text(stdout);
    if (!mesh) fields_demo_text(stdout);
    if (!mesh) deep_demo_text(stdout);
    printf("\ntime: relative to one unblurred 16-sample ssao, on %s\nshare: RMSE over that of having no AO; floor: the "
           "exact answer from one depth layer\n",
           kit_gl_name());
    if (!mesh) printf("radiance, irradiance, bounce and their biases: over the truth's means\n");
    printf("pictures: %s/index.html\n", out);
}

static int demo(const options *o, kit_error *err)
{
    const int mesh = o->mesh != NULL;
    stage s;
    page record;
    if (ao_demo_measure(&s, o, err) || page_begin(&record, "demo", "full", "make demo", kit_gl_name(), err)) return -1;
    FILE *const f = record.file;
    table_columns(f);
    if (ao_demo(f, &s, o->out, err) || strip_demo(f, &s, o->out, err)) return -1;
    stage_close(&s);
    if (!mesh && (lit_demo(f, o->out, err) || fields_demo(f, o->out, err) || deep_demo(f, o->out, err))) return -1;
    if (page_end(&record, o->out, "demo", err)) return -1;
    demo_text(o->out, mesh);
    return 0;
}

/* ---- >>chart ----------------------------------------------------------------------------------------------------- */

/* What --method names must be there. */
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

/* all: not of some scenes alone; whole: nor of some methods. */
static int chart_sections(FILE *record, const options *o, int all, int whole, kit_error *err)
{
    if (ao_entries(o) && ao_chart(record, o, err)) return -1;
    if (all && (lit_chart(record, o, err) || fields_chart(record, o, err) || deep_chart(record, o, err))) return -1;
    return whole && (seeds_chart(record, o, err) || plan_chart(record, o, err)) ? -1 : 0;
}

static void chart_text(const options *o, int all, int whole)
{
    if (ao_entries(o)) ao_text(stdout);
    if (all) lit_chart_text(stdout);
    if (all) fields_chart_text(stdout);
    if (all) deep_chart_text(stdout);
    if (whole) seeds_text(stdout);
    if (whole) plan_text(stdout);
    printf("\ntime: relative to one unblurred 16-sample ssao, on %s\ncharts: %s/index.html\n", kit_gl_name(), o->out);
}

static int chart(const options *o, kit_error *err)
{
    const int all = !o->scenes, whole = all && !o->method;
    const char *kind = o->method || o->scenes ? "part" : o->quick ? "quick" : "full";
    page record;
    if (check_asked(o, err)) return -1;
    if (o->quick) stage_thrift = QUICK_THRIFT;
    units_begin(o, ao_units(o) + (all ? lit_units(o) + fields_units(o) + deep_units(o) : 0)
                       + (whole ? seeds_units(o) : 0));
    if (page_begin(&record, "chart", kind, o->quick ? "make chart QUICK=1" : "make chart", kit_gl_name(), err))
        return -1;
    table_columns(record.file);
    if (chart_sections(record.file, o, all, whole, err) || page_end(&record, o->out, "chart", err)) return -1;
    units_end();
    chart_text(o, all, whole);
    return 0;
}

/* Scenes by seed are not timed, so that several are measured at once. */
static int chart_ahead(const options *o, kit_error *err)
{
    return o->scenes || o->method ? 0 : seeds_ahead(o, err) || plan_ahead(o, err) ? -1 : 0;
}

/* A section of the chart alone. */
typedef int section(FILE *record, const options *o, kit_error *err);

static int alone(const char *name, const char *command, section *draw, const options *o, kit_error *err)
{
    page record;
    const char *const kind = o->method || o->paper ? "part" : o->quick ? "quick" : "full";
    if (page_begin(&record, name, kind, command, kit_gl_name(), err)) return -1;
    table_columns(record.file);
    return draw(record.file, o, err) || page_end(&record, o->out, name, err) ? -1 : 0;
}

/* Light on every pair of a scene and a probe. */
static int light(const options *o, kit_error *err)
{
    if (o->quick) stage_thrift = QUICK_THRIFT;
    if (o->scenes) return kit_fail(err, "--scene: light shows pairs of all scenes and probes (--quick: few)");
    if (check_asked(o, err)) return -1;
    units_begin(o, pairs_units(o));
    if (alone("light", "make light", pairs_chart, o, err)) return -1;
    units_end();
    pairs_text(stdout, o);
    printf("\ntime: relative to one unblurred 16-sample ssao, on %s\npictures: %s/index.html\n", kit_gl_name(), o->out);
    return 0;
}

static int seeds(const options *o, kit_error *err)
{
    const int tuned = o->first >= 0 && o->first < SEEDS_JUDGED;
    char command[96];
    if (o->quick) stage_thrift = QUICK_THRIFT;
    if (!seeds_units(o)) return kit_fail(err, "--method %s: no row of the charts is of such a method", o->method);
    units_begin(o, seeds_units(o));
    snprintf(command, sizeof command, "build/report seeds%s", o->quick ? " --quick" : "");
    if (o->first >= 0)
        snprintf(command + strlen(command), sizeof command - strlen(command), " --from %d --count %d", o->first,
                 seeds_units(o));
    if (alone(tuned ? "seeds-fit" : "seeds", command, seeds_chart, o, err)) return -1;
    units_end();
    seeds_text(stdout);
    printf("pictures: %s/index.html\n", o->out);
    return 0;
}

/* The plan on views that it was not fitted on. */
static int plan(const options *o, kit_error *err)
{
    if (alone("plan", "build/report plan", plan_chart, o, err)) return -1;
    plan_text(stdout);
    return 0;
}

/* What five papers print, and the same drawn here on a comparable scene. */
static int papers(const options *o, kit_error *err)
{
    if (!papers_units(o))
        return kit_fail(err, "--paper %s: there is none that begins so (\"HSAO08 Table 1\")", o->paper);
    if (o->quick) stage_thrift = PAPERS_THRIFT;
    units_begin(o, papers_units(o));
    if (alone("papers", o->quick ? "make papers QUICK=1" : "make papers", papers_chart, o, err)) return -1;
    units_end();
    papers_text(stdout, o);
    printf("pictures: %s/index.html\n", o->out);
    return 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int fit(const options *o, kit_error *err) { return plan_fit(o->out, err); }

/* What a command takes beside --out and --context. ahead: what it does before there is a GL context; NULL: nothing. */
enum { MESH = 1, QUICK = 2, SCENES = 4, METHOD = 8, PAPER = 16, SEEDS = 32, COMMIT = 64 };
typedef int step(const options *o, kit_error *err);
static const struct command { const char *name; int takes; step *run, *ahead; } commands[] = {
    { "demo",   MESH,                    demo,   NULL },
    { "chart",  QUICK | SCENES | METHOD | COMMIT, chart, chart_ahead },
    { "light",  QUICK | SCENES | METHOD, light,  NULL },
    { "seeds",  QUICK | METHOD | SEEDS | COMMIT, seeds, seeds_ahead },
    { "papers", QUICK | PAPER,           papers, NULL },
    { "fit",    MESH,                    fit,    plan_fit_ahead },
    { "plan",   MESH,                    plan,   plan_ahead }
};

static void usage(void)
{
    fputs("usage: report demo  [--out FOLDER] [--context osmesa | egl | egl-es] [--mesh MODEL]     pictures beside "
          "the truth\n"
          "       report chart [--out FOLDER] [--context ...] [--quick] [--scene NAME]... [--method NAME] "
          "[--commit HASH]     speed against accuracy\n"
          "       report light [--out FOLDER] [--context ...] [--quick] [--method NAME]     the chart's part on "
          "light, every pair\n"
          "       report seeds [--out FOLDER] [--context ...] [--quick] [--method NAME] [--from SEED] [--count N] "
          "[--commit HASH]     scenes by seed\n"
          "       report papers [--out FOLDER] [--context ...] [--quick] [--paper HSAO08]     the papers' tables and "
          "figures\n"
          "       report fit   [--out FOLDER] [--context ...]     what the plan's table is fitted to\n"
          "       report plan  [--out FOLDER] [--context ...]     the plan on views that it was not fitted on\n",
          stderr);
}

static int add_scene(options *o, const char *name, kit_error *err)
{
    if (o->scenes == MOST_SCENES) return kit_fail(err, "--scene %s: at most %d of them", name, MOST_SCENES);
    o->scene[o->scenes++] = name;
    return 0;
}

/* text: a whole number from least to most; NULL: it is not asked for, and *to stays. */
static int number(int *to, const char *name, const char *text, int least, int most, kit_error *err)
{
    char *end;
    if (!text) return 0;
    const long v = strtol(text, &end, 10);
    if (end == text || *end || v < least || v > most)
        return kit_fail(err, "%s %s: must be a whole number %d..%d", name, text, least, most);
    *to = (int)v;
    return 0;
}

static int parse(options *o, const struct command *c, int argc, char **argv, kit_error *err)
{
    const char *from = NULL, *count = NULL;
    const struct { const char *name; int of; const char **to; } known[] = {
        { "--out", 0, &o->out },             { "--context", 0, &o->context }, { "--mesh", MESH, &o->mesh },
        { "--method", METHOD, &o->method },  { "--paper", PAPER, &o->paper }, { "--scene", SCENES, NULL },
        { "--from", SEEDS, &from },          { "--count", SEEDS, &count },
        { "--commit", COMMIT, &o->commit }
    };
    memset(o, 0, sizeof *o);
    o->out = "report";
    for (int i = 2; i < argc; ++i) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        int k = 0;
        if (c->takes & QUICK && !strcmp(a, "--quick")) { o->quick = 1; continue; }
        while (k < COUNT(known) && (strcmp(a, known[k].name) || (known[k].of && !(c->takes & known[k].of)))) ++k;
        if (k == COUNT(known))
            return kit_fail(err, "%s: %s takes no such argument (report alone prints what there is)", a, argv[1]);
        if (!v || !*v) return kit_fail(err, "%s: needs a value", a);
        ++i;
        if (known[k].to) *known[k].to = v;
        else if (add_scene(o, v, err)) return -1;
    }
    o->first = -1;
    return number(&o->first, "--from", from, 0, 999999, err) || number(&o->seeds, "--count", count, 1, MOST_SEEDS, err)
               ? -1
               : 0;
}

static int run(const struct command *c, int argc, char **argv, kit_error *err)
{
    options o;
    return parse(&o, c, argc, argv, err) || folder_make(o.out, err) || (c->ahead && c->ahead(&o, err))
                   || kit_gl_open(o.context, err)
                   || c->run(&o, err)
               ? -1
               : kit_streams_close(err);
}

int main(int argc, char **argv)
{
    const struct command *c = commands;
    kit_error err = { "" };
    kit_streams_open();
    if (argc < 2) { usage(); return 2; }
    while (c < commands + COUNT(commands) && strcmp(c->name, argv[1])) ++c;
    if (c == commands + COUNT(commands))
        kit_fail(&err, "%s: there is no such command (demo, chart, light, seeds, papers, fit, plan)", argv[1]);
    else run(c, argc, argv, &err);
    if (*err.text) {
        kit_progress("", 1);
        fprintf(stderr, "report: %s\n", err.text);
        return 2;
    }
    kit_gl_close();
    return 0;
}
