/* sets.h - the sets of the charts' sections, each a table of rows on one view: lines of sets.csv and of views.csv. */
#ifndef LAB_SETS_H
#define LAB_SETS_H

#include "lab/measure/stage.h"

/* section: the name of the section in sets.csv. title NULL: the set stands under the heading of the one before it. see
   NULL: the section's own() measures the set. rows: a set of lines of rows.csv; quick 1: --quick shows the set, too;
   kind: the view of report.js that shows it; phases: of noise, which split error from noise (0: no split). */
typedef struct set {
    const char *section, *title, *about, *rows, *kind;
    const view *see;
    int quick, phases;
} set;

enum { MOST_SETS = 64, MOST_VIEWS = 64 };
/* Returns the k-th set of a section; NULL past the last. */
const set *set_of(const char *section, int k);
/* Returns the view of that name; NULL: there is none. view_charted: the k-th of the chart of ambient occlusion. */
view       *view_named(const char *name);
const view *view_charted(int k);

#endif
