/* papers.c - draws the sheets of all papers, one after another. Declared in papers.h. */
#include "lab/papers/papers.h"
#include <string.h>
#include "lab/page/page.h"
#include "lab/papers/sheet.h"

static const struct { const char *key, *title; } papers[] = {
    { "HSAO08", "Dimitrov, Bavoil, Sainz 2008, Horizon-split ambient occlusion" },
    { "SSDO09", "Ritschel, Grosch, Seidel 2009, Approximating dynamic global illumination in image space" },
    { "S3HO12", "Herholz, Schairer, Schilling, Strasser 2012, Screen space spherical harmonic occlusion" },
    { "AOF05", "Kontkanen, Laine 2005, Ambient occlusion fields" },
    { "DSS14", "Nalbach, Ritschel, Seidel 2014, Deep screen space" }
};
static row drawn[MOST_SHEETS][MOST_ROWS];

/* Whether --paper allows a sheet: its key and name must begin so. */
static int asked(const options *o, const sheet *t)
{
    char name[64];
    snprintf(name, sizeof name, "%s %s", t->paper, t->name);
    return !o->paper || !strncmp(name, o->paper, strlen(o->paper));
}

static int paper_unit(FILE *record, const options *o, int k, row *rows, kit_error *err)
{
    const sheet *t = papers_sheet(k);
    if (!rows) return asked(o, t);
    return sheet_draw(record, o, t, rows, err) ? -1 : t->count;
}

int papers_units(const options *o)
{
    int count = 0;
    while (count < MOST_SHEETS && papers_sheet(count)) ++count;
    return units_count(paper_unit, count, o);
}

/* Draws a sheet: its pictures and its cells. */
static int chart(FILE *record, FILE *csv, const options *o, int k, kit_error *err)
{
    const sheet *t = papers_sheet(k);
    page own;
    if (!asked(o, t)) return 0;
    page_heading(record, 3, "%s: %s", t->name, t->title);
    if (units_measure(record, o, "papers", k, paper_unit, drawn[k], err) < 0 || page_open(&own, err)) return -1;
    show_csv_head(own.file);
    show_csv(own.file, t, drawn[k]);
    show_csv(csv, t, drawn[k]);
    page_table(record, "paper", &own);
    return 0;
}

int papers_chart(FILE *record, const options *o, kit_error *err)
{
    const sheet *t;
    page csv;
    if (page_open(&csv, err)) return -1;
    show_csv_head(csv.file);
    for (int p = 0; p < COUNT(papers); ++p) {
        page_heading(record, 2, "[%s] %s", papers[p].key, papers[p].title);
        for (int k = 0; (t = papers_sheet(k)) != NULL; ++k)
            if (!strcmp(t->paper, papers[p].key) && chart(record, csv.file, o, k, err)) return -1;
        if (!o->paper) show_absent(NULL, csv.file, papers[p].key);
    }
    if (!o->paper) page_heading(record, 2, "What is not on this page");
    for (int p = 0; p < COUNT(papers) && !o->paper; ++p) show_absent(record, NULL, papers[p].key);
    return page_close(&csv, o->out, "papers.csv", err);
}
