/* figures.c - examples/docs/FIGURES.md from the csv that make chart and make stability write.

      build/figures [report]

   Reads chart.txt and stability.txt (kind, command, commit, machine, driver) and the csv beside them. When both are of
   full runs the page is examples/docs/FIGURES.md, and the charts that it shows go to examples/docs/pictures; else it is
   FIGURES.md in the folder of the csv, for a quick run should not replace a full one. After a run of a part (SCENE,
   METHOD) all stays as it is. Bad input, or a write that fails: one line on stderr, status 2; the page is then as it
   was. */
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
    fputs("# Figures\n\nMade by `make chart` and `make stability` from the csv that they write: change nothing here. "
        "Above each table stand the command,\n"
          "commit, machine and driver that it comes from.", m->file);
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
    section_plan(m);
    section_costs(m);
}

/* The page, in memory first; of full runs with its charts. */
static int write_page(const char *path, markdown *m, int has_chart, int has_stability, kit_error *err)
{
    char *text = NULL;
    size_t size;
    m->file = open_memstream(&text, &size);
    if (!m->file) return kit_fail(err, "out of memory");
    head(m);
    if (has_chart) chart(m);
    if (has_stability) section_stability(m);
    int failed = ferror(m->file);
    if (fclose(m->file) || failed) failed = kit_fail(err, "out of memory");
    if (!failed && m->full)
        failed = kept("chart.svg", err) || kept("chart-lit.svg", err) || kept("chart-deep-turn.svg", err);
    if (!failed) failed = kit_file_write(path, text, size, err);
    free(text);
    return failed ? -1 : 0;
}

int main(int argc, char **argv)
{
    char path[1024];
    kit_error err;
    markdown m = { 0 };
    if (argc > 2 || (argc > 1 && *argv[1] == '-')) { fputs("usage: figures [FOLDER of the csv]\n", stderr); return 2; }
    if (argc > 1) csv_folder = argv[1];
    const char chart_run = run_of("chart.txt", &m.chart_note),
               stability_run = run_of("stability.txt", &m.stability_note);
    if (chart_run == 'p' || stability_run == 'p') {
        puts("figures: left as they are, for a part alone was measured");
        return 0;
    }
    if (!chart_run && !stability_run) {
        fprintf(stderr, "figures: %s: holds neither chart.txt nor stability.txt (make chart, make stability)\n",
                csv_folder);
        return 2;
    }
    m.full = chart_run == 'f' && stability_run == 'f';
    snprintf(path, sizeof path, m.full ? DOCS "FIGURES.md" : "%s/FIGURES.md", csv_folder);
    if (write_page(path, &m, chart_run != 0, stability_run != 0, &err)) {
        fprintf(stderr, "figures: %s\n", err.text);
        return 2;
    }
    printf("figures: %s%s\n", path, m.full ? "" : " (" DOCS "FIGURES.md is written when both runs are full ones)");
    return 0;
}
