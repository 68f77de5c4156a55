/* sections.h - the sections of FIGURES.md, each of one csv or two; nothing where that is not there. */
#ifndef LAB_SECTIONS_H
#define LAB_SECTIONS_H

#include "lab/figures/markdown.h"

void section_ambient(const markdown *m);
void section_pairs(const markdown *m);
/* kind: "lit", "aof" or "deep", of the csv of that name */
void section_tables(const markdown *m, const char *kind, const char *name);
void section_seeds(const markdown *m);
void section_plan(const markdown *m);
void section_costs(const markdown *m);
void section_stability(const markdown *m);
/* Begins with this line: what stands from it to the page's end. */
#define STABILITY_HEADING "\n## Where methods fail\n"
#define PAPERS_HEADING "\n## The papers' own tables and figures\n"
void section_papers(const markdown *m);
#define COST_HEADING "\n## What chains cost a GPU, modelled\n"
void section_cost(const markdown *m);

#endif
