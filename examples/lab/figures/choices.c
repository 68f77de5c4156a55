/* choices.c - the pages on the plan and on what choices cost. Declared in sections.h. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "lab/figures/sections.h"

void section_plan(const markdown *m)
{
    const csv c = csv_read("plan.csv"), all = csv_read("plan-summary.csv");
    if (!c.rows) return;
    fputs("\n## The plan, on views that it was not fitted on\n", m->file);
    markdown_heading(m, "Good plans",
                     "Good: at most 1.25 times the cost of the cheapest choice that meets the error, and at most 1.2 "
                     "times the error asked for.",
                     m->chart_note);
    fputs("| | good |\n|---|---|\n", m->file);
    for (int i = 0; i < all.rows; ++i)
        fprintf(m->file, "| %s | %s of %s |\n", csv_text(&all, i, "what"), csv_text(&all, i, "good"),
                csv_text(&all, i, "pairs"));
    markdown_heading(m, "View by view, without history", "", m->chart_note);
    fputs("| scene, radius, light | wanted | good |\n|---|---|---|\n", m->file);
    for (int from = 0, to; from < c.rows; from = to) {
        int good = 0;
        for (to = from; to < c.rows && csv_same(&c, to, from, "scene") && csv_same(&c, to, from, "wanted"); ++to)
            good += atoi(csv_text(&c, to, "good"));
        fprintf(m->file, "| %s | %s | %d of %d |\n", csv_text(&c, from, "scene"), csv_text(&c, from, "wanted"), good,
                to - from);
    }
}

void section_costs(const markdown *m)
{
    const csv c = csv_read("costs.csv");
    if (!c.rows) return;
    fputs("\n## What choices cost\n", m->file);
    markdown_heading(m, "Instructions and fetches of the fragment stages",
                     "As glslang compiles them to SPIR-V, loops counted once, not optimised. Fetching: instructions "
                     "that fetch; texels: the most that a pixel fetches.",
                     m->chart_note);
    fputs("| pass | instructions | fetching | texels | what choices add, instructions |\n|---|---|---|---|---|\n",
        m->file);
    const char *const base = csv_text(&c, 0, "choice");
    for (int i = 0; i < c.rows; ++i) {
        int more = 0;
        if (strcmp(csv_text(&c, i, "stage"), "frag") || strcmp(csv_text(&c, i, "choice"), base)) continue;
        fprintf(m->file, "| %s | %s | %s | %s |", csv_text(&c, i, "pass"), csv_text(&c, i, "instructions"),
                csv_text(&c, i, "fetch_instructions"), csv_text(&c, i, "texels_a_pixel"));
        for (int k = 0; k < c.rows; ++k) {
            const double d = csv_number(&c, k, "instructions") - csv_number(&c, i, "instructions");
            if (k == i || !csv_same(&c, i, k, "pass") || strcmp(csv_text(&c, k, "stage"), "frag") || fabs(d) < 0.5)
                continue;
            fprintf(m->file, "%s %s %+.0f", more++ ? "," : "", csv_text(&c, k, "choice"), d);
        }
        fputs(" |\n", m->file);
    }
}
