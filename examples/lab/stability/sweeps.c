/* sweeps.c - the methods that are swept, and the causes of failure, each a scene and one thing in it that changes:
   lines of methods.csv and causes.csv. Declared in sweeps.h. */
#include "lab/stability/sweeps.h"
#include <stdlib.h>
#include <string.h>
#include "lab/measure/line.h"
#include "lab/stability/maths.h"

/* ---- >>methods --------------------------------------------------------------------------------------------------- */

swept sweeps_method[MOST_METHODS];
int sweeps_methods;

/* ---- >>causes ---------------------------------------------------------------------------------------------------- */

static const struct { const char *name; int (*curves)(result *r, kit_error *err); } of_maths[] = {
    { "ringing-open", maths_ringing_open }, { "ringing-in-shade", maths_ringing_in_shade }, { "hull", maths_hull },
    { "hull-steps", maths_hull_steps }, { "popping", maths_popping }
};

cause sweeps_cause[MOST_CAUSES];
int sweeps_causes;

/* Returns the groups of methods in a line's column of. */
static int groups(const line *l)
{
    int of = 0;
    for (const char *at = line_cell(l, "of"); *at; at += strcspn(at, "+"), at += *at == '+')
        of |= 1 << line_word(l, "of", "screen light surfels field thin turned kept kept-light bounced shadowed counted "
                                      "far", at, strcspn(at, "+"));
    return of;
}

static void read_cause(cause *c, const line *l)
{
    const char *placed = line_cell(l, "look"), *kind = line_cell(l, "kind"), *depth = line_cell(l, "depth"),
               *at = line_cell(l, "values");
    char *end;
    *c = (cause){ .name = line_cell(l, "name"), .title = line_cell(l, "title"), .across = line_cell(l, "across"),
                  .about = line_cell(l, "about"), .holds = line_cell(l, "holds"), .bounds = line_cell(l, "bounds"),
                  .number = line_text(l, "number"), .up = line_text(l, "up"), .of = groups(l),
                  .width = line_whole(l, "width"), .rays = line_whole(l, "rays"), .log = line_whole(l, "log"),
                  .told = line_whole(l, "told") };
    c->kind = line_word(l, "kind", "error precision deviation second lit-second follows after newly trail held "
                                   "shades", kind, strlen(kind));
    if (*depth)
        c->format = EXACT + line_word(l, "depth", "exact half unorm24 float32 reversed32", depth, strlen(depth));
    if (looks_has(placed)) c->look = placed;
    for (size_t i = 0; i < sizeof of_maths / sizeof *of_maths; ++i)
        if (!strcmp(of_maths[i].name, placed)) c->curves = of_maths[i].curves;
    for (int i = 0; i < MOST_VALUES && *at; ++i, at = end) c->value[i] = strtod(at, &end);
    if (*at || (!c->curves && !(c->look && c->of && c->width > 0 && *line_cell(l, "values")))) line_fault(l, "look");
}

void sweeps_load(void)
{
    line m = { SWEEPS_FOLDER, .file = "methods" }, l = { SWEEPS_FOLDER, .file = "causes" };
    for (line_open(&m), sweeps_methods = 0; m.at < m.of.rows; ++m.at) {
        if (sweeps_methods == MOST_METHODS) line_fault(&m, "label");
        sweeps_method[sweeps_methods++] = (swept){ line_cell(&m, "label"), line_cell(&m, "method"),
                                                   line_cell(&m, "settings"), groups(&m), line_whole(&m, "widest") };
    }
    for (line_open(&l), sweeps_causes = 0; l.at < l.of.rows; ++l.at) {
        if (sweeps_causes == MOST_CAUSES) line_fault(&l, "name");
        read_cause(&sweeps_cause[sweeps_causes++], &l);
    }
}
