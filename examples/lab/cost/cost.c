/* cost.c - the cost of passes on a GPU, from the instructions that Mesa's compiler makes of them. Nothing is executed,
   and no time is measured: milliseconds come from a model (model.h). --help lists the options.

   busy: the body of every `if` is executed; calm: inside loops no body is executed that a wave may skip; weighed: each
   such body counts by the share of waves of 8x8 texels that enter it while the camera turns. Status 1: --check found a
   fault. If RADV or its null device is missing, a line says so, and the status is 0. */
#include "lab/cost/against.h"
#include "lab/cost/entered.h"
#include "lab/cost/peers.h"
#include "lab/cost/plan.h"
#include "lab/cost/sheets.h"
#include "lab/cost/show.h"
#include "lab/cost/xegtao.h"
#include "lab/measure/folder.h"
#include "lab/page/page.h"
#include "tools/glsl/chains.h"
#include <stdlib.h>
#include <string.h>

#define ROOM     "examples/lab/cost"
#define RECORDED ROOM "/recorded.csv"

/* The command line; some: it names chains or files. */
typedef struct asked { const char *against; work *of; int check, record, plan, papers, peers, some; } asked;

static work work_of_all;

static int is_file(const char *text)
{
    const char *ending = strstr(text, ".frag");
    return ending && (!ending[5] || !strcmp(ending + 5, ".spv"));
}

static int take_chain(void *to, const char *text, kit_error *err)
{
    asked *const a = to;
    a->some = 1;
    return is_file(text) ? work_add_file(a->of, text, err) : work_add_chain(a->of, text, err);
}

/* Adds to the work what is asked for. */
static int add_work(work *w, const asked *a, kit_error *err)
{
    if (a->plan) return plan_add(w, err);
    if (a->peers) return peers_add(w, err) || xegtao_add(w, err);
    if (a->papers) return sheets_add(w, err);
    for (int i = 0; !a->some && chain_at(i); ++i)
        if (work_add_chain(w, chain_at(i), err)) return -1;
    return 0;
}

static int write_record(page *table, const work *w, int peers, kit_error *err)
{
    const char *const name = peers ? "cost-peers" : "cost", *const command = peers ? "build/cost --peers" : "make cost";
    char file[32];
    page record;
    snprintf(file, sizeof file, "%s.csv", name);
    if (folder_make("report", err) || page_begin(&record, name, "full", command, w->driver, err)) return -1;
    page_heading(record.file, 2, "What passes%s cost, modelled", peers ? " of others" : "");
    page_paragraph(record.file, "A compiler's count of the instructions of every pass, and milliseconds of a few "
                                "devices by a model of theirs, at 1920x1080, the G-buffer of room.");
    return page_csv(record.file, "cost", table, "report", file, err) ||
           (peers && xegtao_published(record.file, w, err)) ||
           page_end(&record, "report", name, err) ? -1 : 0;
}

static int write_shares(kit_error *err)
{
    page p;
    return page_open(&p, err) || entered_write(p.file, err) || page_close(&p, ROOM, "shares.csv", err) ? -1 : 0;
}

static int write_recorded(const csv *now, kit_error *err)
{
    page p;
    if (page_open(&p, err)) return -1;
    csv_put(p.file, now, RECORDED_KEYS, "pass", 0);
    return page_close(&p, ROOM, "recorded.csv", err);
}

static int run(work *w, const asked *a, kit_error *err)
{
    page table;
    if (work_do(w, err) || folder_make("report", err) || page_open(&table, err)) return -1;
    if (a->plan) {
        plan_write(table.file, w);
        return page_close(&table, "report", "plan-cost.csv", err);
    }
    if (a->papers) {
        sheets_write(table.file, w);
        return page_close(&table, "examples/lab/papers", "modelled.csv", err);
    }
    write_costs(table.file, w);
    if (a->peers) xegtao_keep(table.file);
    fflush(table.file);
    const csv now = csv_of(strdup(table.text), "cost.csv");
    if (a->check) return against_check(&now, RECORDED, err);
    if (a->record) return write_recorded(&now, err);
    show_costs(&now, a->some);
    show_notes(w, a->some);
    if (!a->some && write_record(&table, w, a->peers, err)) return -1;
    return a->against ? against_show(&now, a->against, err) : 0;
}

static const char usage[] = "cost [options] [CHAIN ..] [FILE.frag ..] | cost --shares | --plan | --papers | --peers";
#define FLAG(member) .kind = KIT_FLAG, .at = offsetof(asked, member)
static const kit_option options[] = {
    { .about = "Compiles passes by Mesa's compiler for GPUs that need not be here, counts their instructions, and "
               "estimates milliseconds at 1920x1080. Nothing is executed. Without arguments it prints every chain "
               "that build/glsl-text --chains names, and writes report/cost.csv and report/index.html." },
    { "CHAIN", NULL, "A chain, as build/glsl-text --chain takes it, with each of its passes: hsao,samples=12.",
      .kind = KIT_TOLD },
    { "FILE.frag", NULL, "A shader of yours, or FILE.frag.spv, with its vertex stage beside it.", .kind = KIT_TOLD },
    { "--against", "F.csv", "Prints what has changed since the run that wrote this file.",
      .kind = KIT_TEXT,
      .at = offsetof(asked, against) },
    { "--check", NULL, "Compares with examples/lab/cost/recorded.csv. The status is 1 if something has changed.",
      FLAG(check) },
    { "--record", NULL, "Writes examples/lab/cost/recorded.csv anew.", FLAG(record) },
    { "--shares", NULL, "Measures how many waves enter the branches that they may skip, on the scenes by seed 0 to "
                        "11, and writes examples/lab/cost/shares.csv anew, in three minutes. It draws with GL.",
      .kind = KIT_TOLD },
    { "--plan", NULL, "Estimates the planner's choices on an RX 6800: report/plan-cost.csv.", FLAG(plan) },
    { "--papers", NULL, "Models the papers' rows that have times: examples/lab/papers/modelled.csv.", FLAG(papers) },
    { "--peers", NULL, "Estimates the effects that make peers has brought: report/cost-peers.csv.", FLAG(peers) },
    { NULL }
};

int main(int argc, char **argv)
{
    kit_error err = { "" };
    work *w = &work_of_all;
    asked a = { .of = w };
    if (kit_help(argc, argv, usage, options)) return 0;
    kit_streams_open();
    if (argc == 2 && !strcmp(argv[1], "--shares")) {
        const int failed = write_shares(&err);
        if (failed) fprintf(stderr, "cost: %s\n", err.text);
        return failed ? 2 : 0;
    }
    if (!compiler_exists(&err)) {
        printf("skipped: everything: %s\n", err.text);
        return 0;
    }
    w->family[0] = "navi21";
    w->family[1] = "polaris10";
    w->families = 2;
    w->shares = csv_read(ROOM, "shares.csv");
    int status = w->shares.rows ? 0 : kit_fail(&err, ROOM "/shares.csv: cannot be read: make cost-shares");
    if (!status) status = kit_options(&a, options, argc, argv, take_chain, &err) || add_work(w, &a, &err);
    status = status ? -1 : run(w, &a, &err);
    work_free(w);
    if (status >= 0 && kit_streams_close(&err)) status = -1;
    if (status < 0) fprintf(stderr, "cost: %s\n", err.text);
    return status < 0 ? 2 : status > 0;
}
