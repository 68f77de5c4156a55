/* sets.c - reads the charts' sets and views. Declared in sets.h. */
#include "lab/chart/sets.h"
#include <string.h>
#include "lab/measure/views.h"
#include "lab/page/units.h"

static struct { const char *key; int charted; view view; lit lit; } views[MOST_VIEWS];
static set sets[MOST_SETS];

static void read_views(void)
{
    line l = { UNITS_FOLDER, .file = "views" };
    for (line_open(&l); l.at < l.of.rows; ++l.at) {
        if (l.at == MOST_VIEWS) line_fault(&l, "view");
        view_read(&views[l.at].view, &views[l.at].lit, &l);
        views[l.at].key = line_text(&l, "view");
        views[l.at].charted = line_whole(&l, "chart");
    }
}

view *view_named(const char *name)
{
    int k = 0;
    if (!views->key) read_views();
    while (k < MOST_VIEWS && views[k].key && strcmp(views[k].key, name)) ++k;
    return k < MOST_VIEWS && views[k].key ? &views[k].view : NULL;
}

const view *view_charted(int k)
{
    if (!views->key) read_views();
    for (int i = 0; i < MOST_VIEWS; ++i)
        if (views[i].charted && !k--) return &views[i].view;
    return NULL;
}

static void read_sets(void)
{
    line l = { UNITS_FOLDER, .file = "sets" };
    for (line_open(&l); l.at < l.of.rows; ++l.at) {
        const char *const name = line_text(&l, "view");
        if (l.at == MOST_SETS) line_fault(&l, "section");
        sets[l.at] = (set){ .section = line_text(&l, "section"), .title = line_text(&l, "title"),
                            .about = line_text(&l, "about"), .rows = line_text(&l, "rows"),
                            .kind = line_text(&l, "kind"), .see = name ? view_named(name) : NULL,
                            .quick = line_whole(&l, "quick"), .phases = line_whole(&l, "phases") };
        if (name && !sets[l.at].see) line_fault(&l, "view");
    }
}

const set *set_of(const char *section, int k)
{
    if (!sets->section) read_sets();
    for (int i = 0; i < MOST_SETS && sets[i].section; ++i)
        if (!strcmp(sets[i].section, section) && !k--) return &sets[i];
    return NULL;
}
