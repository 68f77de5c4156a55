/* papers.c - all papers, one sheet after another. Declared in papers.h. */
#include "lab/papers/papers.h"
#include <string.h>
#include "lab/page/page.h"
#include "lab/papers/sheet.h"

static const paper *const papers[] = { &hsao_paper, &ssdo_paper, &s3ho_paper, &aof_paper, &dss_paper };
enum { PAPERS = COUNT(papers), MOST_SHEETS = 48 };
static row drawn[MOST_SHEETS][MOST_ROWS];

const sheet *papers_sheet(int k)
{
    for (int p = 0; p < PAPERS && k >= 0; k -= papers[p++]->count)
        if (k < papers[p]->count) return papers[p]->sheets[k];
    return NULL;
}

/* --paper: those whose key and name begin so. */
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
    return t->draw(record, o, t, rows, err) ? -1 : t->count;
}

int papers_units(const options *o)
{
    int count = 0;
    while (count < MOST_SHEETS && papers_sheet(count)) ++count;
    return units_count(paper_unit, count, o);
}

/* A sheet: its pictures, its cells. */
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
    page csv;
    if (page_open(&csv, err)) return -1;
    show_csv_head(csv.file);
    for (int p = 0, k = 0; p < PAPERS; ++p) {
        page_heading(record, 2, "[%s] %s", papers[p]->key, papers[p]->title);
        for (int i = 0; i < papers[p]->count; ++i, ++k) if (chart(record, csv.file, o, k, err)) return -1;
        if (!o->paper) show_absent_csv(csv.file, papers[p]);
    }
    if (!o->paper) page_heading(record, 2, "What is not on this page");
    for (int p = 0; p < PAPERS && !o->paper; ++p)
        for (int i = 0; i < papers[p]->absents; ++i)
            page_paragraph(record, "[%s] %s: %s", papers[p]->key, papers[p]->absent[i].name, papers[p]->absent[i].why);
    return page_close(&csv, o->out, "papers.csv", err);
}

void papers_text(FILE *f, const options *o)
{
    for (int k = 0; papers_sheet(k); ++k) if (asked(o, papers_sheet(k))) show_text(f, papers_sheet(k), drawn[k]);
}
