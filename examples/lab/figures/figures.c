/* figures.c - examples/docs/FIGURES.md from the csv that make chart, make stability, make papers and make cost write.

      build/figures [report]

   Reads chart.txt, stability.txt, papers.txt and cost.txt (kind, command, commit, machine, driver) and the csv beside
   them. The page has a part of each. A part whose run is a full one goes to examples/docs/FIGURES.md, where the others
   stay as they are, and the charts that it shows to examples/docs/pictures; else it goes to FIGURES.md in the folder
   of the csv, for a quick run should not replace a full one. After a run of some rows (SCENE, METHOD, PAPER) theirs
   stays as it is. Bad input, or a write that fails: one line on stderr, status 2; the page is then as it was. */
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "kit/kit.h"
#include "lab/figures/sections.h"

#define DOCS "examples/docs/"

/* A run's kind and, in note, where its figures come from; 0 = there was none. f, q, p. */
static char run_of(const char *name, const char **note)
{
    char *text = csv_file(name), *line = text ? strchr(text, '\n') : NULL;
    if (!line) { *note = ""; return 0; }
    line[strcspn(line + 1, "\n") + 1] = 0;
    *note = line + 1;
    return *text;
}

/* A chart that the page and README.md show. */
static int kept(const char *name, kit_error *err)
{
    char path[1024], *text = csv_file(name);
    snprintf(path, sizeof path, DOCS "pictures/%s", name);
    const int failed = text ? kit_file_write(path, text, strlen(text), err)
                            : kit_fail(err, "%s/%s: cannot be read", csv_folder, name);
    free(text);
    return failed;
}

static void head(const markdown *m)
{
    fputs("# Figures\n\nMade by `make chart`, `make stability`, `make papers` and `make cost` from the csv that they "
          "write: change nothing here. Above each table\n"
          "stand the command, commit, machine and driver that it comes from.", m->file);
    fputs(m->full ? "\n" : " Quick runs have smaller pictures, fewer rays and fewer rows.\n", m->file);
    fputs("\n- Time: GL time of all passes, filter included, relative to one unblurred 16-sample `ssao` in the same "
        "interleaved run.\n"
          "- Error and share: RMSE against ray-traced truth over the RMSE of having no ambient occlusion. Raw "
          "output: no gain, no exponent.\n"
          "- Radiance, irradiance, bounce: RMSE over the mean of the truth; biases likewise, below 0 = too dark.\n"
          "- Bytes: each pass reads each of its inputs' texels once and writes its outputs, a pixel. Fetches: texel "
          "fetches a pixel.\n", m->file);
}

static void chart(const markdown *m)
{
    fputs("\n## Ambient occlusion\n", m->file);
    section_ambient(m);
    fputs("\n## Light\n", m->file);
    section_tables(m, "lit", "chart-lit.csv");
    section_pairs(m);
    fputs("\n## Occlusion between moving objects\n", m->file);
    section_tables(m, "aof", "chart-aof.csv");
    fputs("\n## Deep screen space\n", m->file);
    section_tables(m, "deep", "chart-deep.csv");
    section_seeds(m);
    section_plan(m);
    section_costs(m);
}

enum { PARTS = 4 };

/* The page's parts in their order, each of a run that name.txt tells of; the first begins with the first heading. */
static const struct { const char *name, *heading; void (*write)(const markdown *); size_t note; } parts[PARTS] = {
    { "chart.txt", "\n## ", chart, offsetof(markdown, chart_note) },
    { "stability.txt", STABILITY_HEADING, section_stability, offsetof(markdown, stability_note) },
    { "papers.txt", PAPERS_HEADING, section_papers, offsetof(markdown, papers_note) },
    { "cost.txt", COST_HEADING, section_cost, offsetof(markdown, cost_note) }
};

/* The page's parts as they are in examples/docs; "" = there is none. To be freed. */
static int keep(char *old[PARTS], kit_error *err)
{
    char *page;
    size_t size;
    if (kit_file_read(&page, &size, DOCS "FIGURES.md", err)) return -1;
    for (int i = PARTS; i-- > 0;) {
        char *const at = strstr(page, parts[i].heading);
        old[i] = strdup(at ? at : "");
        if (at) *at = 0;
        if (!old[i]) { free(page); return kit_fail(err, "out of memory"); }
    }
    free(page);
    return 0;
}

/* The page, in memory first: the parts whose run is of this kind, and of others what there was. */
static int write_page(const char *path, markdown *m, const char run[PARTS], char kind, char *const old[PARTS],
                      kit_error *err)
{
    char *text = NULL;
    size_t size;
    m->file = open_memstream(&text, &size);
    if (!m->file) return kit_fail(err, "out of memory");
    head(m);
    for (int i = 0; i < PARTS; ++i) {
        if (run[i] == kind) parts[i].write(m);
        else if (old[i]) fputs(old[i], m->file);
    }
    int failed = ferror(m->file);
    if (fclose(m->file) || failed) failed = kit_fail(err, "out of memory");
    if (!failed && m->full && run[0] == kind)
        failed = kept("chart.svg", err) || kept("chart-lit.svg", err) || kept("chart-deep-turn.svg", err);
    if (!failed) failed = kit_file_write(path, text, size, err);
    free(text);
    if (!failed) printf("figures: %s%s\n", path, m->full ? "" : " (" DOCS "FIGURES.md has full runs alone)");
    return failed ? -1 : 0;
}

static int count_of(const char run[PARTS], char kind)
{
    int count = 0;
    for (int i = 0; i < PARTS; ++i) count += run[i] == kind;
    return count;
}

/* Full runs go to the documentation, others beside the csv. */
static int write_pages(markdown *m, const char run[PARTS], kit_error *err)
{
    char path[1024], *old[PARTS] = { NULL }, *const none[PARTS] = { NULL };
    int failed = 0;
    snprintf(path, sizeof path, "%s/FIGURES.md", csv_folder);
    m->full = count_of(run, 'f') > 0;
    if (m->full) failed = (count_of(run, 'f') < PARTS && keep(old, err))
        || write_page(DOCS "FIGURES.md", m, run, 'f', old, err);
    m->full = 0;
    if (!failed && count_of(run, 'q')) failed = write_page(path, m, run, 'q', none, err);
    for (int i = 0; i < PARTS; ++i) free(old[i]);
    if (count_of(run, 'p')) puts("figures: some are left as they are, for a part alone was measured");
    return failed ? -1 : 0;
}

int main(int argc, char **argv)
{
    kit_error err;
    markdown m = { 0 };
    if (argc > 2 || (argc > 1 && *argv[1] == '-')) { fputs("usage: figures [FOLDER of the csv]\n", stderr); return 2; }
    if (argc > 1) csv_folder = argv[1];
    char run[PARTS];
    int found = 0;
    for (int i = 0; i < PARTS; ++i)
        found += (run[i] = run_of(parts[i].name, (const char **)((char *)&m + parts[i].note))) != 0;
    m.seeds_run = run_of("seeds.txt", &m.seeds_note);
    if (!found) {
        fprintf(stderr, "figures: %s: holds none of chart.txt, stability.txt, papers.txt and cost.txt (make chart, "
                        "make stability, make papers, make cost)\n",
                csv_folder);
        return 2;
    }
    if (write_pages(&m, run, &err)) {
        fprintf(stderr, "figures: %s\n", err.text);
        return 2;
    }
    return 0;
}
