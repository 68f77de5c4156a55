/* stability.c - where methods fail: each method is swept through causes of failure, and its error or flicker is plotted
   against each. --help lists the options. Truth is traced anew each time. Bad input, or a write that fails: one line on
   stderr, status 2. sweeps.c has the methods and causes; sweep.c measures a sweep over shot.c's frames; maths.c sweeps
   the CPU functions alone; show.c shows the results; moves.c moves cameras. */
#include <stdlib.h>
#include <string.h>
#include "kit/kit_gl.h"
#include "lab/measure/folder.h"
#include "lab/measure/rows.h"
#include "lab/measure/stage.h"
#include "lab/page/page.h"
#include "lab/stability/moves.h"
#include "lab/stability/show.h"
#include "lab/stability/sweep.h"

/* Adds tables of cameras that move through scenes on which nothing was tuned, and of frames as hosts make them. */
static int add_moves(page *record, const sweep_options *o, kit_error *err)
{
    for (int hosts = 0; hosts < 2; ++hosts) {
        moves_options m = { MOVES_OF_CHARTS, .from = SEEDS_JUDGED, .quick = o->quick };
        page csv;
        if (hosts) moves_of_hosts(&m);
        if (o->quick) m.width = 320, m.count = 4;
        if (page_open(&csv, err)) return -1;
        if (moves(&m, csv.file, err)) return -1;
        page_heading(record->file, 3, hosts ? "Frames as hosts make them" : "Cameras that move");
        page_paragraph(record->file,
                       "%dx%d, 16 frames. Deviation of places that are followed, less the truth's: in the first eight "
                       "frames, in which history fills, and in the next; error of the last frame, and that over the "
                       "error of the frame alone; where the camera stands, the error of TAA's picture.",
                       m.width, m.width * 9 / 16);
        if (page_csv(record->file, "rows", &csv, o->out, hosts ? "stability-hosts.csv" : "stability-moves.csv", err))
            return -1;
    }
    return 0;
}

/* Sweeps the causes that are asked for. Prints their numbers, and writes the record and the CSV. */
static int stability(const sweep_options *o, kit_error *err)
{
    static result r;
    int count = 0, done = 0;
    char what[128];
    page record, csv;
    for (int k = 0; k < sweeps_causes; ++k) count += sweep_asked(&sweeps_cause[k], o);
    if (!count) return kit_fail(err, "--method: none of these is swept through the causes that are named");
    if (folder_make(o->out, err)
        || page_begin(&record, "stability", o->causes || o->methods ? "part" : o->quick ? "quick" : "full",
                      o->quick ? "make stability QUICK=1" : "make stability", kit_gl_name(), err)
        || page_open(&csv, err))
        return -1;
    page_paragraph(record.file,
                   "Each method is swept through cases in which such methods fail. Errors are of ambient visibility (0 "
                   "closed, 1 open), against ray-traced truth; no gain, no fit. Methods with light are under white "
                   "light from everywhere, where irradiance is ambient visibility.");
    show_csv_head(csv.file);
    puts("cause,what,method,number");
    for (int k = 0; k < sweeps_causes; ++k) {
        const cause *c = &sweeps_cause[k];
        if (!sweep_asked(c, o)) continue;
        snprintf(what, sizeof what, "%d of %d: %s", ++done, count, c->name);
        if (sweep(&r, c, o, what, err) || show_cause(record.file, csv.file, &r, o->out, err)) return -1;
        show_numbers(stdout, &r);
    }
    if (!o->causes && !o->methods && add_moves(&record, o, err)) return -1;
    return page_close(&csv, o->out, "stability.csv", err) || page_end(&record, o->out, "stability", err) ? -1 : 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int take_cause(void *to, const char *name, const char *text, kit_error *err)
{
    sweep_options *const o = to;
    int k = 0;
    while (k < sweeps_causes && strcmp(sweeps_cause[k].name, text)) ++k;
    if (k == sweeps_causes)
        return kit_fail(err, "%s %s: is none (the first column of stability.csv has them)", name, text);
    o->causes += !o->cause[k];
    o->cause[k] = 1;
    return 0;
}

static int take_method(void *to, const char *name, const char *text, kit_error *err)
{
    sweep_options *const o = to;
    int k = 0;
    while (k < sweeps_methods && strcmp(sweeps_method[k].label, text)) ++k;
    if (k == sweeps_methods) return kit_fail(err, "%s %s: is not swept", name, text);
    o->methods += !o->method[k];
    o->method[k] = 1;
    return 0;
}

static const char usage[] = "stability [options] | stability --moves [options]";
/* The options of sweeps, and behind the second paragraph those of --moves. */
enum { OF_SWEEPS = 5 };
#define MOVES(member) .at = offsetof(moves_options, member)
#define LIST_OF(list, count) .kind = KIT_LIST, MOVES(list), .most = MOST_MOVES, .said = offsetof(moves_options, count)
static const kit_option options[] = {
    { .about = "Sweeps each method through each cause of failure and measures its error or flicker. It writes "
               "stability.csv and report/index.html, and prints the number of each curve as csv. --cause and --method "
               "may be given several times." },
    { "--cause", "NAME", "Sweeps that cause alone. The first column of stability.csv has the names.",
      .kind = KIT_TAKEN, .take = take_cause },
    { "--method", "NAME", "Sweeps that method alone.", .kind = KIT_TAKEN, .take = take_method },
    { "--quick", NULL, "A smaller run.", .kind = KIT_FLAG, .at = offsetof(sweep_options, quick) },
    { "--out", "FOLDER", "The folder to write into [report].", .kind = KIT_TEXT, .at = offsetof(sweep_options, out) },
    { .about = "With --moves it prints another csv: how steady methods are while a camera moves past things that "
               "stand still. --scene and --method may be given several times." },
    { "--moves", NULL, "Must be the first argument.", .kind = KIT_TOLD },
    { "--scene", "NAME", "That scene alone.",
      LIST_OF(scene, scenes) },
    { "--method", "METHOD", "That method alone. Settings may follow: hsao:samples=12.",
      LIST_OF(method, methods) },
    { NULL }
};

static int parse(sweep_options *o, int argc, char **argv, kit_error *err)
{
    kit_option table[OF_SWEEPS + 1] = { { NULL } };
    memcpy(table, options, OF_SWEEPS * sizeof *table);
    *o = (sweep_options){ .out = "report" };
    return kit_options(o, table, argc, argv, NULL, err);
}

static int parse_moves(moves_options *o, int argc, char **argv, kit_error *err)
{
    *o = (moves_options){ MOVES_OF_CHARTS };
    return kit_options(o, options + OF_SWEEPS, argc - 1, argv + 1, NULL, err);   /* behind --moves */
}

int main(int argc, char **argv)
{
    const int moving = argc > 1 && !strcmp(argv[1], "--moves");
    moves_options m;
    sweep_options o;
    kit_error err = { "" };
    if (kit_help(argc, argv, usage, options)) return 0;
    kit_streams_open();
    sweeps_load();
    if (!(moving ? parse_moves(&m, argc, argv, &err) : parse(&o, argc, argv, &err))
        && !kit_gl_open(NULL, &err) && !(moving ? moves(&m, stdout, &err) : stability(&o, &err)))
        kit_streams_close(&err);
    if (*err.text) {
        kit_progress("", 1);
        fprintf(stderr, "stability: %s\n", err.text);
        return 2;
    }
    kit_fields_free();
    kit_gl_close();
    return 0;
}
