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

/* A column's cells of a way: its head, behind a device's name. */
static double of_way(const csv *c, int r, const char *device, const char *way)
{
    char head[96];
    snprintf(head, sizeof head, "%s%s%s", device, *device ? " " : "", way);
    return csv_number(c, r, head);
}

/* As one cell "weighed (busy, calm)", or as one number where all are the same. device "": instructions. */
static void ways(const markdown *m, const csv *c, int r, const char *device, int digits)
{
    static const char *const way[3] = { "weighed", "busy", "calm" };
    char text[3][32];
    for (int i = 0; i < 3; ++i) snprintf(text[i], sizeof text[i], "%.*f", digits, of_way(c, r, device, way[i]));
    const int same = !strcmp(text[0], text[1]) && !strcmp(text[0], text[2]);
    fprintf(m->file, same ? " %s |" : " %s (%s, %s) |", text[0], text[1], text[2]);
}

/* Columns of devices: a head ends in " weighed", and some chain has it. */
static int device_of(const csv *c, int column, char name[64])
{
    const char *head = c->cell[column], *end = strstr(head, " weighed");
    if (!end || end[8]) return 0;
    snprintf(name, 64, "%.*s", (int)(end - head), head);
    for (int r = 0; r < c->rows; ++r) if (*csv_text(c, r, head)) return 1;
    return 0;
}

static void families(const markdown *m, const csv *c, int first)
{
    char name[64];
    int columns = 12;
    markdown_heading(m, "Instructions and milliseconds",
                     "Never measured: Mesa's compiler made these instructions of the passes, for GPUs "
                     "that were not there; each counts as often as it is executed, a pixel.\n"
                     "Milliseconds are a model's of a picture of 1920x1080: a pass takes as long as the slowest of its "
                     "arithmetic, its fetches, what hides their\n"
                     "latency and its bytes, each read or written once (examples/lab/cost/model.h). In brackets the "
                     "bounds, where it depends on the picture: busy, whatever an\n"
                     "`if` guards is executed; calm, inside loops nothing is that a wave may leave out, and history "
                     "has settled. Before them weighed: as often\n"
                     "as waves of 8x8 texels that show something enter, on twelve scenes by seed at 1280x720, history "
                     "by a camera that turns\n"
                     "(examples/lab/cost/shares.csv). Of march, points, lights and surfels that was not measured: "
                     "weighed is busy. Splats and surfels are left out:\n"
                     "they cost as much as there are. Registers: the most of a pass; waves of 64 that share a SIMD: "
                     "the fewest.",
                     m->cost_note);
    const int other = beside(c, first);
    const char *const family[2] = { csv_text(c, first, "family"), other < 0 ? "" : csv_text(c, other, "family") };
    fprintf(m->file, "| chain | %s: instructions | transcendental | scalar loads | fetches | bytes in | out | "
                     "registers | waves | %s: instructions | registers | waves |", family[0], family[1]);
    for (int i = 0; i < c->columns; ++i) {
        if (!device_of(c, i, name)) continue;
        fprintf(m->file, " %s, ms |", name);
        ++columns;
    }
    fputc('\n', m->file);
    markdown_ruler(m, columns);
    for (int r = 0; r < c->rows; ++r) {
        const int second = beside(c, r);
        if (!is_chain(c, r) || !csv_same(c, r, first, "family") || second < 0) continue;
        fprintf(m->file, "| %s%s |", csv_text(c, r, "chain"), *csv_text(c, r, "splats") == '0' ? "" : ", less splats");
        ways(m, c, r, "", 0);
        markdown_number(m, csv_number(c, r, "transcendental_busy"), 0, 0);
        markdown_number(m, csv_number(c, r, "scalar_loads"), 0, 0);
        markdown_number(m, csv_number(c, r, "fetches"), 1, 0);
        markdown_number(m, csv_number(c, r, "bytes_in"), 1, 0);
        markdown_number(m, csv_number(c, r, "bytes_out"), 1, 0);
        markdown_number(m, csv_number(c, r, "vgprs"), 0, 0);
        markdown_number(m, csv_number(c, r, "waves"), 0, 0);
        ways(m, c, second, "", 0);
        markdown_number(m, csv_number(c, second, "vgprs"), 0, 0);
        markdown_number(m, csv_number(c, second, "waves"), 0, 0);
        for (int i = 0; i < c->columns; ++i)
            if (device_of(c, i, name)) ways(m, c, *csv_text(c, r, c->cell[i]) ? r : second, name, 3);
        fputc('\n', m->file);
    }
}

/* Only what holds by every figure of the table above. */
static void ranks(const markdown *m, const csv *c, int first)
{
    fputs("\nChains that are cheaper than others by every figure above: instructions and milliseconds, in both "
          "families, weighed, busy and calm. Each is cheaper than the chain\nbehind it, and than all of its kind "
          "(occlusion, light) that take more instructions than that one.\n\n", m->file);
    for (int r = 0; r < c->rows; ++r)
        if (is_chain(c, r) && csv_same(c, r, first, "family") && *csv_text(c, r, "cheaper_than"))
            fprintf(m->file, "- %s < %s\n", csv_text(c, r, "chain"), csv_text(c, r, "cheaper_than"));
}

static void budget(const markdown *m, const csv *c, int first)
{
    static const char *const sizes[] = { "targets_720", "targets_1080", "targets_1440", "targets_2160" };
    markdown_heading(m, "An engine's budget",
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
