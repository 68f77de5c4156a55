/* papers.c - the papers' own tables and figures, theirs beside ours: papers.csv, a line a cell. Declared in
   sections.h. */
#include <stdlib.h>
#include <string.h>
#include "lab/figures/sections.h"

static int is(const csv *c, int r, const char *kind) { return !strcmp(csv_text(c, r, "kind"), kind); }

static int same_figure(const csv *c, int a, int b) { return csv_same(c, a, b, "paper") && csv_same(c, a, b, "figure"); }

/* The text of a kind from .. to - 1; "" = there is none. */
static const char *text_of(const csv *c, int from, int to, const char *kind)
{
    for (int r = from; r < to; ++r) if (is(c, r, kind)) return csv_text(c, r, "text");
    return "";
}

static void heading(const markdown *m, const csv *c, int from, int to)
{
    const char *const erratum = text_of(c, from, to, "erratum");
    char title[256], about[2048];
    snprintf(title, sizeof title, "[%s] %s: %s", csv_text(c, from, "paper"), csv_text(c, from, "figure"),
             text_of(c, from, to, "title"));
    snprintf(about, sizeof about, "The paper: %s%s%s\n\nHere: %s", text_of(c, from, to, "theirs"),
             *erratum ? " Erratum: " : "", erratum, text_of(c, from, to, "ours"));
    markdown_heading(m, title, about, m->papers_note);
}

/* The cell that says what is drawn. */
static void drawn(const markdown *m, const csv *c, int from, int to)
{
    const char *note = "", *method = "", *set = "";
    for (int r = from; r < to; ++r) {
        if (is(c, r, "method")) { method = csv_text(c, r, "head"); set = csv_text(c, r, "text"); }
        if (is(c, r, "note")) note = csv_text(c, r, "text");
    }
    if (!*method) { fprintf(m->file, " not drawn: %s |", note); return; }
    fprintf(m->file, " `%s`%s", method, *set ? ": `" : "");
    for (const char *s = set; *s; ++s) {
        fputc(*s, m->file);
        if (*s == ',') fputc(' ', m->file);
    }
    fprintf(m->file, "%s%s%s |", *set ? "`" : "", *note ? "; " : "", note);
}

/* Lines from .. to - 1: a row's cells follow each other. */
static void table(const markdown *m, const csv *c, int from, int to)
{
    int columns = 2, first = from;
    while (first < to && !is(c, first, "what")) ++first;
    fputs("| the paper's | ours |", m->file);
    for (int r = first; r < to && csv_same(c, first, r, "row"); ++r) {
        const int printed = is(c, r, "printed");
        if (!printed && !is(c, r, "measured")) continue;
        fprintf(m->file, " %s%s |", printed ? "paper: " : "", csv_text(c, r, "head"));
        ++columns;
    }
    fputc('\n', m->file);
    markdown_ruler(m, columns);
    for (int end; first < to && atoi(csv_text(c, first, "row")); first = end) {
        for (end = first; end < to && csv_same(c, first, end, "row");) ++end;
        fprintf(m->file, "| %s |", csv_text(c, first, "text"));
        drawn(m, c, first, end);
        for (int r = first; r < end; ++r)
            if (is(c, r, "printed") || is(c, r, "measured")) fprintf(m->file, " %s |", csv_text(c, r, "text"));
        fputc('\n', m->file);
    }
}

/* How many statements of each paper agree. */
static void summary(const markdown *m, const csv *c)
{
    fputs("| paper | figures | statements that agree | that do not |\n|---|---|---|---|\n", m->file);
    for (int from = 0, to; from < c->rows; from = to) {
        int figures = 0, agree = 0, differ = 0;
        for (to = from; to < c->rows && csv_same(c, from, to, "paper"); ++to) {
            figures += is(c, to, "title");
            agree += is(c, to, "claim") && !strcmp(csv_text(c, to, "head"), "agrees");
            differ += is(c, to, "claim") && !strcmp(csv_text(c, to, "head"), "differs");
        }
        fprintf(m->file, "| %s | %d | %d | %d |\n", csv_text(c, from, "paper"), figures, agree, differ);
    }
}

/* What no table or figure here is of, from every paper. */
static void absent(const markdown *m, const csv *c)
{
    const char *head = "\n### What is not here\n\n";
    for (int r = 0; r < c->rows; ++r) {
        if (!is(c, r, "absent")) continue;
        fprintf(m->file, "%s- [%s] %s: %s\n", head, csv_text(c, r, "paper"), csv_text(c, r, "figure"),
                csv_text(c, r, "text"));
        head = "";
    }
}

void section_papers(const markdown *m)
{
    const csv c = csv_read("papers.csv");
    if (!c.rows) return;
    fputs(PAPERS_HEADING "\nMade by `make papers`, whose page has the pictures. What the papers print stands beside "
          "what is drawn here on a comparable scene;\nbelow each table what the paper says of it, whether this "
          "run's figures agree, and the figure at which that would change.\n\n", m->file);
    summary(m, &c);
    for (int from = 0, to; from < c.rows; from = to) {
        for (to = from; to < c.rows && same_figure(&c, from, to);) ++to;
        if (is(&c, from, "absent")) continue;
        heading(m, &c, from, to);
        table(m, &c, from, to);
        fputs(*text_of(&c, from, to, "claim") ? "\n" : "", m->file);
        for (int r = from; r < to; ++r) if (is(&c, r, "claim")) fprintf(m->file, "- %s\n", csv_text(&c, r, "text"));
    }
    absent(m, &c);
}
