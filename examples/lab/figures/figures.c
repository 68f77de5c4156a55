/* figures.c - examples/docs/FIGURES.md from the csv that make chart, make stability and make papers write.

      build/figures [report]

   Reads chart.txt, stability.txt and papers.txt (kind, command, commit, machine, driver) and the csv beside them. The
   page has a part of each. A part whose run is a full one goes to examples/docs/FIGURES.md, where the others stay as
   they are, and the charts that it shows to examples/docs/pictures; else it goes to FIGURES.md in the folder of the
   csv, for a quick run should not replace a full one. After a run of some rows (SCENE, METHOD, PAPER) theirs stays as
   it is. Bad input, or a write that fails: one line on stderr, status 2; the page is then as it was. */
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
    fputs("# Figures\n\nMade by `make chart`, `make stability` and `make papers` from the csv that they write: change "
          "nothing here. Above each table\n"
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

/* What is to be written: the parts, and whether each is measured anew. */
typedef struct parts { char chart, stability, papers; char *kept, *kept_stability, *kept_papers; } parts;

/* The page's parts as they are in examples/docs; "" = there is none. To be freed. */
static int keep(parts *p, kit_error *err)
{
    size_t size;
    if (kit_file_read(&p->kept, &size, DOCS "FIGURES.md", err)) return -1;
    char *const first = strstr(p->kept, "\n## "), *const papers = strstr(p->kept, PAPERS_HEADING);
    char *const stability = strstr(p->kept, STABILITY_HEADING);
    p->kept_papers = strdup(papers ? papers : "");
    if (papers) *papers = 0;
    p->kept_stability = strdup(stability ? stability : "");
    if (stability) *stability = 0;
    if (!p->kept_papers || !p->kept_stability) return kit_fail(err, "out of memory");
    if (first) memmove(p->kept, first, strlen(first) + 1);
    return 0;
}

/* The page, in memory first. */
static int write_page(const char *path, markdown *m, const parts *p, kit_error *err)
{
    char *text = NULL;
    size_t size;
    m->file = open_memstream(&text, &size);
    if (!m->file) return kit_fail(err, "out of memory");
    head(m);
    if (p->chart) chart(m);
    else if (m->full) fputs(p->kept, m->file);
    if (p->stability) section_stability(m);
    else if (m->full) fputs(p->kept_stability, m->file);
    if (p->papers) section_papers(m);
    else if (m->full) fputs(p->kept_papers, m->file);
    int failed = ferror(m->file);
    if (fclose(m->file) || failed) failed = kit_fail(err, "out of memory");
    if (!failed && m->full && p->chart)
        failed = kept("chart.svg", err) || kept("chart-lit.svg", err) || kept("chart-deep-turn.svg", err);
    if (!failed) failed = kit_file_write(path, text, size, err);
    free(text);
    if (!failed) printf("figures: %s%s\n", path, m->full ? "" : " (" DOCS "FIGURES.md has full runs alone)");
    return failed ? -1 : 0;
}

/* Full runs go to the documentation, others beside the csv. */
static int write_pages(markdown *m, char chart_run, char stability_run, char papers_run, kit_error *err)
{
    const int part = chart_run == 'p' || stability_run == 'p';
    const parts quick = { chart_run == 'q' ? 'q' : 0, stability_run == 'q' ? 'q' : 0, papers_run == 'q' ? 'q' : 0,
                          NULL, NULL, NULL };
    parts whole = { chart_run == 'f' ? 'f' : 0, stability_run == 'f' ? 'f' : 0, papers_run == 'f' ? 'f' : 0,
                    NULL, NULL, NULL };
    char path[1024];
    snprintf(path, sizeof path, "%s/FIGURES.md", csv_folder);
    m->full = whole.chart || whole.stability || whole.papers;
    int failed = m->full && (((!whole.chart || !whole.stability || !whole.papers) && keep(&whole, err))
        || write_page(DOCS "FIGURES.md", m, &whole, err));
    m->full = 0;
    if (!failed && (quick.chart || quick.stability || quick.papers)) failed = write_page(path, m, &quick, err);
    free(whole.kept);
    free(whole.kept_stability);
    free(whole.kept_papers);
    if (part || papers_run == 'p') puts("figures: some are left as they are, for a part alone was measured");
    return failed ? -1 : 0;
}

int main(int argc, char **argv)
{
    kit_error err;
    markdown m = { 0 };
    if (argc > 2 || (argc > 1 && *argv[1] == '-')) { fputs("usage: figures [FOLDER of the csv]\n", stderr); return 2; }
    if (argc > 1) csv_folder = argv[1];
    const char chart_run = run_of("chart.txt", &m.chart_note),
               stability_run = run_of("stability.txt", &m.stability_note),
               papers_run = run_of("papers.txt", &m.papers_note);
    m.seeds_run = run_of("seeds.txt", &m.seeds_note);
    if (!chart_run && !stability_run && !papers_run) {
        fprintf(stderr, "figures: %s: holds none of chart.txt, stability.txt and papers.txt (make chart, make "
                        "stability, make papers)\n",
                csv_folder);
        return 2;
    }
    if (write_pages(&m, chart_run, stability_run, papers_run, &err)) {
        fprintf(stderr, "figures: %s\n", err.text);
        return 2;
    }
    return 0;
}
