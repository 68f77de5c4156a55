/* report.c - what the methods are worth: pictures beside the truth, and speed against accuracy.

      build/report demo  [--out report] [--context egl] [--mesh MODEL]     pictures, tables and demo.html, in a minute
      build/report chart [--out report] [--context egl] [--quick] [--scene NAME]... [--method NAME]     chart*.csv,
         chart*.svg and index.html, in half an hour, or 3 minutes
      build/report light [--out report] [--context egl] [--quick] [--method NAME]     chart-pairs.csv, light.html
      build/report seeds [--out report] [--context egl] [--quick] [--method NAME] [--from 1000] [--count 100]     scenes
         by seed: seeds.csv, seeds.html, seeds-KIND.html
      build/report papers [--out report] [--context egl] [--quick] [--paper "HSAO08 Table 1"]     papers.csv,
         papers.html, in some minutes
      build/report fit   [--out report] [--context egl]     plan-fit.csv, for fit.c
      build/report plan  [--out report] [--context egl]     the chart's part on the plan: plan.csv, plan.html

   With --mesh or --scene only ambient occlusion is shown; else light, fields and deep screen space, too, and with
   neither --scene nor --method scenes by seed and the plan. --method: the rows of methods whose names begin so. --from:
   the first seed; those below 1000, which settings may be tuned on, end there, and their files are called seeds-fit.
   Truth is kept under build/cache/, and so is what an interrupted chart has measured: the same command goes on from
   there. Bad input, or a write that fails: one line on stderr, status 2.

   Here are the commands, which put sections of pages together; a section is a file of chart/, a paper one of papers/,
   which sets up some of its stages as chart/ does. Below them lies page/: how pages, tables, charts and pictures are
   written, and what is kept of a chart that is not whole; below that measure/: scenes and their truth, methods drawn,
   scored and timed. Nothing calls upward; no section calls another, but for seeds.c, which has its rows from ao.c and
   pairs.c. */
#include <stdlib.h>
#include <string.h>
#include "kit/kit_gl.h"
#include "lab/chart/ao.h"
#include "lab/chart/costs.h"
#include "lab/chart/deep.h"
#include "lab/chart/fields.h"
#include "lab/chart/lit.h"
#include "lab/chart/pairs.h"
#include "lab/chart/plan.h"
#include "lab/chart/seeds.h"
#include "lab/chart/strip.h"
#include "lab/measure/folder.h"
#include "lab/page/page.h"
#include "lab/page/terms.h"
#include "lab/papers/papers.h"

/* ---- >>demo ------------------------------------------------------------------------------------------------------ */

static void demo_head(FILE *html, const stage *s, int mesh)
{
    char about[512];
    snprintf(about, sizeof about,
             "%s, %zu triangles, %d x %d pixels, radius %g. Ambient visibility: white is open, black is closed. Times: "
             "%s.",
             s->name, s->scene.mesh.triangles, s->truth.width, s->truth.height, (double)s->radius, kit_gl_name());
    page_head(html,
              mesh ? "ssgi: ambient occlusion beside the truth" : "ssgi: ambient occlusion and light beside the truth",
              about);
}

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
    printf("pictures: %s/demo.html\n", out);
}

static void all_terms(FILE *html)
{
    terms_light(html);
    terms_fields(html);
    terms_deep(html);
}

static int demo(const options *o, kit_error *err)
{
    const int mesh = o->mesh != NULL;
    stage s;
    page html;
    if (ao_demo_measure(&s, o, err) || page_open(&html, err)) return -1;
    demo_head(html.file, &s, mesh);
    if (ao_demo(html.file, &s, o->out, err) || strip_demo(html.file, &s, o->out, err)) return -1;
    stage_close(&s);
    if (!mesh && (lit_demo(html.file, o->out, err) || fields_demo(html.file, o->out, err)
        || deep_demo(html.file, o->out, err)))
        return -1;
    terms_chart(html.file);
    if (!mesh) all_terms(html.file);
    if (page_close(&html, o->out, "demo.html", err)) return -1;
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

static void chart_head(FILE *html, int quick)
{
    char about[512];
    snprintf(about, sizeof about,
             "Raw output against ray-traced truth: no gain, no exponent fitted; linear attenuation where nothing else "
             "is said. Times: %s.%s",
             kit_gl_name(), quick ? " The quick form: smaller pictures, fewer rays, fewer rows." : "");
    page_head(html, "ssgi: speed against accuracy", about);
}

/* all: not of some scenes alone; whole: nor of some methods. */
static int chart_sections(FILE *html, const options *o, int all, int whole, kit_error *err)
{
    if (ao_entries(o) && ao_chart(html, o, err)) return -1;
    if (all && (lit_chart(html, o, err) || pairs_chart(html, o, err) || fields_chart(html, o, err)
        || deep_chart(html, o, err)))
        return -1;
    if (whole && (seeds_chart(html, o, err) || plan_chart(html, o, err))) return -1;
    return whole && !o->quick && costs_chart(html, o->out, err) ? -1 : 0;
}

static void chart_files(FILE *html, const options *o, int all)
{
    const struct { const char *name; int rows; } csv[] = { { "chart.csv", ao_entries(o) },
        { "chart-lit.csv", all && lit_units(o) }, { "chart-pairs.csv", all && pairs_units(o) },
        { "chart-aof.csv", all && fields_units(o) },
        { "chart-deep.csv", all && deep_units(o) } };
    fputs("<p class=\"faint\">The same figures as text:", html);
    for (int i = 0; i < COUNT(csv); ++i)
        if (csv[i].rows) fprintf(html, " <a href=\"%s\">%s</a>", csv[i].name, csv[i].name);
    fputs("</p>\n", html);
}

static void chart_text(const options *o, int all, int whole)
{
    if (ao_entries(o)) ao_text(stdout);
    if (all) lit_chart_text(stdout);
    if (all) pairs_text(stdout, o);
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
    page html;
    if (check_asked(o, err)) return -1;
    if (o->quick) stage_thrift = QUICK_THRIFT;
    units_begin(o, ao_units(o) + (all ? lit_units(o) + pairs_units(o) + fields_units(o) + deep_units(o) : 0)
                       + (whole ? seeds_units(o) : 0));
    if (page_open(&html, err)) return -1;
    chart_head(html.file, o->quick);
    if (chart_sections(html.file, o, all, whole, err)) return -1;
    terms_chart(html.file);
    if (ao_entries(o)) ao_terms(html.file);
    if (all) all_terms(html.file);
    chart_files(html.file, o, all);
    if (page_close(&html, o->out, "index.html", err)
        || page_note(o->out, "chart.txt", kind, o->quick ? "make chart QUICK=1" : "make chart", kit_gl_name(), err))
        return -1;
    units_end();
    chart_text(o, all, whole);
    return 0;
}

/* Scenes by seed are not timed, so that several are measured at once. */
static int chart_ahead(const options *o, kit_error *err)
{
    return o->scenes || o->method ? 0 : seeds_ahead(o, err) || plan_ahead(o, err) ? -1 : 0;
}

/* Light on every pair alone: light.html. */
static int light(const options *o, kit_error *err)
{
    page html;
    if (o->quick) stage_thrift = QUICK_THRIFT;
    if (o->scenes) return kit_fail(err, "--scene: light shows pairs of all scenes and probes (--quick: few)");
    if (check_asked(o, err)) return -1;
    units_begin(o, pairs_units(o));
    if (page_open(&html, err)) return -1;
    page_head(html.file, "ssgi: light on every pair", kit_gl_name());
    if (pairs_chart(html.file, o, err)) return -1;
    terms_chart(html.file);
    if (page_close(&html, o->out, "light.html", err)) return -1;
    units_end();
    pairs_text(stdout, o);
    printf("\ntime: relative to one unblurred 16-sample ssao, on %s\npictures: %s/light.html\n", kit_gl_name(), o->out);
    return 0;
}

/* Scenes by seed alone: seeds.html. */
static int seeds(const options *o, kit_error *err)
{
    const char *name = o->first >= 0 && o->first < SEEDS_JUDGED ? "seeds-fit.html" : "seeds.html";
    page html;
    if (o->quick) stage_thrift = QUICK_THRIFT;
    if (!seeds_units(o)) return kit_fail(err, "--method %s: no row of the charts is of such a method", o->method);
    units_begin(o, seeds_units(o));
    if (page_open(&html, err)) return -1;
    page_head(html.file, "ssgi: scenes by seed", kit_gl_name());
    if (seeds_chart(html.file, o, err)) return -1;
    terms_chart(html.file);
    if (page_close(&html, o->out, name, err)) return -1;
    units_end();
    seeds_text(stdout);
    printf("pictures: %s/%s\n", o->out, name);
    return 0;
}

/* The plan on views that it was not fitted on, alone: plan.html. */
static int plan(const options *o, kit_error *err)
{
    page html;
    if (page_open(&html, err)) return -1;
    page_head(html.file, "ssgi: the plan", kit_gl_name());
    if (plan_chart(html.file, o, err)) return -1;
    terms_chart(html.file);
    if (page_close(&html, o->out, "plan.html", err)) return -1;
    plan_text(stdout);
    return 0;
}

/* The papers' own tables and figures: papers.html. */
static int papers(const options *o, kit_error *err)
{
    page html;
    const char *kind = o->paper ? "part" : o->quick ? "quick" : "full";
    if (!papers_units(o))
        return kit_fail(err, "--paper %s: there is none that begins so (\"HSAO08 Table 1\")", o->paper);
    if (o->quick) stage_thrift = PAPERS_THRIFT;
    units_begin(o, papers_units(o));
    if (page_open(&html, err)) return -1;
    page_head(html.file, "ssgi: the papers' own tables and figures",
              "What five papers print, and the same drawn here on a comparable scene: what agrees and what does not is "
              "worked out from this run's figures.");
    fprintf(html.file, "<p>Times here: %s.%s</p>\n", kit_gl_name(),
            o->quick ? " The quick form: small pictures, few rays, fewer rows." : "");
    if (papers_chart(html.file, o, err)) return -1;
    terms_chart(html.file);
    if (page_close(&html, o->out, "papers.html", err)
        || page_note(o->out, "papers.txt", kind, o->quick ? "make papers QUICK=1" : "make papers", kit_gl_name(), err))
        return -1;
    units_end();
    papers_text(stdout, o);
    printf("pictures: %s/papers.html\n", o->out);
    return 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int fit(const options *o, kit_error *err) { return plan_fit(o->out, err); }

/* What a command takes beside --out and --context. ahead: what it does before there is a GL context; NULL: nothing. */
enum { MESH = 1, QUICK = 2, SCENES = 4, METHOD = 8, PAPER = 16, SEEDS = 32 };
typedef int step(const options *o, kit_error *err);
static const struct command { const char *name; int takes; step *run, *ahead; } commands[] = {
    { "demo",   MESH,                    demo,   NULL },
    { "chart",  QUICK | SCENES | METHOD, chart,  chart_ahead },
    { "light",  QUICK | SCENES | METHOD, light,  NULL },
    { "seeds",  QUICK | METHOD | SEEDS,  seeds,  seeds_ahead },
    { "papers", QUICK | PAPER,           papers, NULL },
    { "fit",    MESH,                    fit,    plan_fit_ahead },
    { "plan",   MESH,                    plan,   plan_ahead }
};

static void usage(void)
{
    fputs("usage: report demo  [--out FOLDER] [--context osmesa | egl | egl-es] [--mesh MODEL]     pictures beside "
          "the truth\n"
          "       report chart [--out FOLDER] [--context ...] [--quick] [--scene NAME]... [--method NAME]     "
          "speed against accuracy\n"
          "       report light [--out FOLDER] [--context ...] [--quick] [--method NAME]     the chart's part on "
          "light, every pair\n"
          "       report seeds [--out FOLDER] [--context ...] [--quick] [--method NAME] [--from SEED] [--count N]     "
          "scenes by seed\n"
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
        { "--from", SEEDS, &from },          { "--count", SEEDS, &count }
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
