/* stability.c - where methods fail: each method is swept through causes of failure, and its error or flicker is plotted
   against each. --help lists the options. Truth is traced anew each time. Bad input, or a write that fails: one line on
   stderr, status 2. sweeps.c has the methods and causes; sweep.c measures a sweep over shot.c's frames; maths.c sweeps
   the CPU functions alone; show.c shows the results. */
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
        moves_options m = { .width = 640, .rays = 64, .from = SEEDS_JUDGED, .quick = o->quick };
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

/* Writes the record and the CSV of all sweeps. */
static int write_all(const sweep_options *o, const result *results, const int *shown, kit_error *err)
{
    page record, csv;
    if (page_begin(&record, "stability", o->causes || o->methods ? "part" : o->quick ? "quick" : "full",
                   o->quick ? "make stability QUICK=1" : "make stability", kit_gl_name(), err)
        || page_open(&csv, err))
        return -1;
    page_paragraph(record.file,
                   "Each method is swept through cases in which such methods fail. Errors are of ambient visibility (0 "
                   "closed, 1 open), against ray-traced truth; no gain, no fit. Methods with light are under white "
                   "light from everywhere, where irradiance is ambient visibility.");
    show_csv_head(csv.file);
    for (int k = 0; k < sweeps_causes; ++k)
        if (shown[k] && show_cause(record.file, csv.file, &results[k], o->out, err)) return -1;
    if (!o->causes && !o->methods && add_moves(&record, o, err)) return -1;
    return page_close(&csv, o->out, "stability.csv", err) || page_end(&record, o->out, "stability", err) ? -1 : 0;
}

static int stability(const sweep_options *o, kit_error *err)
{
    static result results[MOST_CAUSES];
    int shown[MOST_CAUSES], count = 0, done = 0;
    char what[128];
    if (folder_make(o->out, err)) return -1;
    for (int k = 0; k < sweeps_causes; ++k)
        count += shown[k] = (!o->causes || o->cause[k]) && sweep_has(&sweeps_cause[k], o);
    if (!count) return kit_fail(err, "--method: none of these is swept through the causes that are named");
    for (int k = 0; k < sweeps_causes; ++k) {
        if (!shown[k]) continue;
        snprintf(what, sizeof what, "%d of %d: %s", ++done, count, sweeps_cause[k].name);
        if (sweep(&results[k], &sweeps_cause[k], o, what, err)) return -1;
    }
    if (write_all(o, results, shown, err)) return -1;
    show_table_text(stdout, results, shown);
    printf("charts and pictures: %s/index.html\n", o->out);
    return 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int parse(sweep_options *o, int argc, char **argv, kit_error *err)
{
    memset(o, 0, sizeof *o);
    o->out = "report";
    for (int i = 1; i < argc; ++i) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        int k = 0;
        if (!strcmp(a, "--quick")) {
            o->quick = 1;
            continue;
        }
        if (strcmp(a, "--out") && strcmp(a, "--cause") && strcmp(a, "--method"))
            return kit_fail(err, "%s: there is no such argument (--out FOLDER, --quick, --cause NAME, --method NAME)",
                            a);
        if (!v || !*v) return kit_fail(err, "%s: needs a value", a);
        ++i;
        if (!strcmp(a, "--out")) {
            o->out = v;
            continue;
        }
        if (!strcmp(a, "--cause")) {
            while (k < sweeps_causes && strcmp(sweeps_cause[k].name, v)) ++k;
            if (k == sweeps_causes)
                return kit_fail(err, "--cause %s: is none (the first column of stability.csv has them)", v);
            o->causes += !o->cause[k];
            o->cause[k] = 1;
        } else {
            while (k < sweeps_methods && strcmp(sweeps_method[k].label, v)) ++k;
            if (k == sweeps_methods) return kit_fail(err, "--method %s: is not swept", v);
            o->methods += !o->method[k];
            o->method[k] = 1;
        }
    }
    return 0;
}

static int parse_moves(moves_options *o, int argc, char **argv, kit_error *err)
{
    const struct { const char *name, **list; int *number, least; } options[] = {
        { "--scene", o->scene, NULL, 0 },   { "--method", o->method, NULL, 0 }, { "--kind", o->kind, NULL, 0 },
        { "--width", NULL, &o->width, 64 }, { "--rays", NULL, &o->rays, 16 },   { "--from", NULL, &o->from, 0 } };
    *o = (moves_options){ .width = 640, .rays = 64 };
    for (int i = 2; i < argc; i += 2) {
        const char *a = argv[i], *v = i + 1 < argc ? argv[i + 1] : NULL;
        int k = 0, n = 0;
        while (k < COUNT(options) && strcmp(a, options[k].name)) ++k;
        if (k == COUNT(options))
            return kit_fail(err,
                            "--moves %s: there is no such argument (--scene NAME, --method METHOD[:SETTINGS], --kind "
                            "NAME, --width PIXELS, --rays N, --from SEED)",
                            a);
        if (!v || !*v) return kit_fail(err, "%s: needs a value", a);
        if (options[k].number) {
            char *end;
            const long value = strtol(v, &end, 10);
            if (*end || value < options[k].least || value > 4096)
                return kit_fail(err, "%s %s: must be %d..4096", a, v, options[k].least);
            *options[k].number = (int)value;
            continue;
        }
        while (options[k].list[n]) ++n;
        if (n == MOST_MOVES) return kit_fail(err, "%s: at most %d", a, MOST_MOVES);
        options[k].list[n] = v;
    }
    return 0;
}

static const char usage[] = "stability [options] | stability --moves [options]";
static const kit_help_entry help[] = {
    { NULL, "Sweeps each method through each cause of failure and measures its error or flicker. It writes "
            "stability.csv, pictures of each cause and report/index.html, which shows them, and prints a table. "
            "--cause and --method may be given several times." },
    { "--cause NAME", "Sweeps that cause alone. The first column of stability.csv has the names." },
    { "--method NAME", "Sweeps that method alone." },
    { "--quick", "A smaller run." },
    { "--out FOLDER", "The folder to write into [report]." },
    { NULL, "With --moves it prints a table instead: how steady methods are while a camera moves past things that "
            "stand still. --scene, --method and --kind may be given several times." },
    { "--scene NAME", "That scene alone." },
    { "--method METHOD", "That method alone. Settings may follow: hsao:samples=12." },
    { "--kind NAME", "That kind of movement alone: aside, forward, roll, orbit, cut, \"stop and go\", fast, slow, "
                     "still, jittered, resized or uneven." },
    { "--from SEED", "The first seed of the scenes [0]." },
    { "--width PIXELS", "The width of the images, at least 64 [640]. The height is 9/16 of it." },
    { "--rays N", "The rays of the ground truth for each pixel, at least 16 [64]." },
    { NULL, NULL }
};

int main(int argc, char **argv)
{
    const int moving = argc > 1 && !strcmp(argv[1], "--moves");
    moves_options m;
    sweep_options o;
    kit_error err = { "" };
    if (kit_help(argc, argv, usage, help)) return 0;
    kit_streams_open();
    if (!sweeps_load(&err) && !(moving ? parse_moves(&m, argc, argv, &err) : parse(&o, argc, argv, &err))
        && !kit_gl_open(NULL, &err) && !(moving ? moves(&m, NULL, &err) : stability(&o, &err)))
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
