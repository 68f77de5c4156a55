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

static int paper_unit(FILE *html, const options *o, int k, row *rows, kit_error *err)
{
    const sheet *t = papers_sheet(k);
    if (!rows) return asked(o, t);
    return t->draw(html, o, t, rows, err) ? -1 : t->count;
}

int papers_units(const options *o)
{
    int count = 0;
    while (count < MOST_SHEETS && papers_sheet(count)) ++count;
    return units_count(paper_unit, count, o);
}

static void head(FILE *f, const sheet *t)
{
    fputs("<h3>", f);
    page_escaped(f, t->name);
    fputs(": ", f);
    page_escaped(f, t->title);
    fputs("</h3>\n<p><b>The paper:</b> ", f);
    page_escaped(f, t->theirs);
    if (t->erratum) { fputs(" <b>Erratum:</b> ", f); page_escaped(f, t->erratum); }
    fputs("</p>\n<p><b>Here:</b> ", f);
    page_escaped(f, t->ours);
    fputs("</p>\n", f);
}

/* A sheet: what it is of, its table, its pictures. */
static int chart(FILE *html, FILE *csv, const options *o, int k, kit_error *err)
{
    const sheet *t = papers_sheet(k);
    page pictures;
    if (!asked(o, t)) return 0;
    head(html, t);
    if (page_open(&pictures, err) || units_measure(pictures.file, o, "papers", k, paper_unit, drawn[k], err) < 0)
        return -1;
    show_html(html, t, drawn[k]);
    show_csv(csv, t, drawn[k]);
    page_into(&pictures, html);
    return 0;
}

static void not_here(FILE *html)
{
    fputs("<h2>What is not on this page</h2>\n<ul>\n", html);
    for (int p = 0; p < PAPERS; ++p) show_absent_html(html, papers[p]);
    fputs("</ul>\n", html);
}

int papers_chart(FILE *html, const options *o, kit_error *err)
{
    page csv;
    if (page_open(&csv, err)) return -1;
    show_csv_head(csv.file);
    for (int p = 0, k = 0; p < PAPERS; ++p) {
        fprintf(html, "<h2>[%s] %s</h2>\n", papers[p]->key, papers[p]->title);
        for (int i = 0; i < papers[p]->count; ++i, ++k) if (chart(html, csv.file, o, k, err)) return -1;
        if (!o->paper) show_absent_csv(csv.file, papers[p]);
    }
    if (!o->paper) not_here(html);
    return page_close(&csv, o->out, "papers.csv", err);
}

void papers_text(FILE *f, const options *o)
{
    for (int k = 0; papers_sheet(k); ++k) if (asked(o, papers_sheet(k))) show_text(f, papers_sheet(k), drawn[k]);
}
