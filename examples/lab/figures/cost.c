/* cost.c - the page on what chains cost a GPU by a model, which make cost writes: cost.csv. Declared in sections.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/figures/sections.h"

/* Whether a row is of a whole chain. */
static int is_chain(const csv *c, int r) { return !*csv_text(c, r, "pass"); }

/* The row of a chain in another family; -1: there is none. */
static int beside(const csv *c, int r)
{
    for (int i = 0; i < c->rows; ++i)
        if (i != r && is_chain(c, i) && csv_same(c, i, r, "chain") && !csv_same(c, i, r, "family")) return i;
    return -1;
}

/* What is busy and what is calm as one cell, or as one number where both are the same. */
static void pair(const markdown *m, const csv *c, int r, const char *busy, const char *calm, int digits)
{
    char text[2][32];
    const char *const key[2] = { busy, calm };
    for (int i = 0; i < 2; ++i) snprintf(text[i], sizeof text[i], "%.*f", digits, csv_number(c, r, key[i]));
    if (!*csv_text(c, r, busy)) fputs(" |", m->file);
    else fprintf(m->file, strcmp(text[0], text[1]) ? " %s; %s |" : " %s |", text[0], text[1]);
}

/* Columns of devices: a head ends in " busy". */
static int device_of(const csv *c, int column, char name[64], char calm[80])
{
    const char *head = c->cell[column], *end = strstr(head, " busy");
    if (!end || end[5]) return 0;
    snprintf(name, 64, "%.*s", (int)(end - head), head);
    snprintf(calm, 80, "%.60s calm", name);
    for (int r = 0; r < c->rows; ++r) if (*csv_text(c, r, head)) return 1;
    return 0;
}

static void families(const markdown *m, const csv *c, int first)
{
    char name[64], calm[80];
    int columns = 12;
    markdown_heading(m, "Instructions and milliseconds",
                     "Never measured: what Mesa's compiler makes of the passes for GPUs that were not there, each "
                     "instruction as often as it is executed, a pixel.\n"
                     "Milliseconds are a model's of a picture of 1920x1080: a pass takes as long as the slowest of its "
                     "arithmetic, its fetches, what hides their\n"
                     "latency and its bytes, each read or written once (examples/lab/cost/model.h). Busy; calm: "
                     "whatever an `if` guards is executed; inside loops\n"
                     "nothing is that a wave may skip, and history has settled. Splats and surfels are left out: "
                     "they cost as much as there are. Registers: the\n"
                     "most of a pass; waves of 64 that share a SIMD: the fewest.",
                     m->cost_note);
    const int other = beside(c, first);
    const char *const family[2] = { csv_text(c, first, "family"), other < 0 ? "" : csv_text(c, other, "family") };
    fprintf(m->file, "| chain | %s: instructions | transcendental | scalar loads | fetches | bytes in | out | "
                     "registers | waves | %s: instructions | registers | waves |", family[0], family[1]);
    for (int i = 0; i < c->columns; ++i) {
        if (!device_of(c, i, name, calm)) continue;
        fprintf(m->file, " %s, ms |", name);
        ++columns;
    }
    fputc('\n', m->file);
    markdown_ruler(m, columns);
    for (int r = 0; r < c->rows; ++r) {
        const int second = beside(c, r);
        if (!is_chain(c, r) || !csv_same(c, r, first, "family") || second < 0) continue;
        fprintf(m->file, "| %s%s |", csv_text(c, r, "chain"), *csv_text(c, r, "splats") == '0' ? "" : ", less splats");
        pair(m, c, r, "busy", "calm", 0);
        pair(m, c, r, "transcendental_busy", "transcendental_calm", 0);
        markdown_number(m, csv_number(c, r, "scalar_loads"), 0, 0);
        markdown_number(m, csv_number(c, r, "fetches"), 1, 0);
        markdown_number(m, csv_number(c, r, "bytes_in"), 1, 0);
        markdown_number(m, csv_number(c, r, "bytes_out"), 1, 0);
        markdown_number(m, csv_number(c, r, "vgprs"), 0, 0);
        markdown_number(m, csv_number(c, r, "waves"), 0, 0);
        pair(m, c, second, "busy", "calm", 0);
        markdown_number(m, csv_number(c, second, "vgprs"), 0, 0);
        markdown_number(m, csv_number(c, second, "waves"), 0, 0);
        for (int i = 0; i < c->columns; ++i)
            if (device_of(c, i, name, calm))
                pair(m, c, *csv_text(c, r, c->cell[i]) ? r : second, c->cell[i], calm, 3);
        fputc('\n', m->file);
    }
}

/* Only what holds by every figure of the table above. */
static void ranks(const markdown *m, const csv *c, int first)
{
    fputs("\nWhat is cheaper than what, by every figure above: instructions and milliseconds, in both families, busy "
          "and calm. Each is cheaper than the chain behind it, and\nthan all of its kind (occlusion, light) that take "
          "more instructions than that one.\n\n", m->file);
    for (int r = 0; r < c->rows; ++r)
        if (is_chain(c, r) && csv_same(c, r, first, "family") && *csv_text(c, r, "cheaper_than"))
            fprintf(m->file, "- %s < %s\n", csv_text(c, r, "chain"), csv_text(c, r, "cheaper_than"));
}

static void budget(const markdown *m, const csv *c, int first)
{
    static const char *const sizes[] = { "targets_720", "targets_1080", "targets_1440", "targets_2160" };
    markdown_heading(m, "What an engine budgets",
                     "Targets: megabytes of all textures that the steps write, by lines of a picture of 16:9.\n"
                     "Compiled: milliseconds of processor, of glslang and of RADV, on the machine named below.",
                     m->cost_note);
    fputs("| chain | programs | text, kB | compiled, ms | 720 | 1080 | 1440 | 2160 |\n", m->file);
    markdown_ruler(m, 8);
    for (int r = 0; r < c->rows; ++r) {
        if (!is_chain(c, r) || !csv_same(c, r, first, "family")) continue;
        fprintf(m->file, "| %s | %s |", csv_text(c, r, "chain"), csv_text(c, r, "programs"));
        markdown_number(m, csv_number(c, r, "text_bytes") / 1e3, 1, 0);
        markdown_number(m, csv_number(c, r, "compile_ms"), 0, 0);
        for (int k = 0; k < 4; ++k) markdown_number(m, csv_number(c, r, sizes[k]) / 1e6, 1, 0);
        fputc('\n', m->file);
    }
}

void section_cost(const markdown *m)
{
    const csv c = csv_read("cost.csv");
    if (!c.rows) return;
    fputs(COST_HEADING, m->file);
    families(m, &c, 0);
    ranks(m, &c, 0);
    budget(m, &c, 0);
}
