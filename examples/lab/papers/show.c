/* show.c - a paper's table or figure and what was drawn for it, side by side: HTML, csv, text. Declared in sheet.h. */
#include <math.h>
#include "lab/page/page.h"
#include "lab/papers/sheet.h"

static int heads(const sheet *t)
{
    int n = 0;
    while (n < MOST_HEADS && t->head[n]) ++n;
    return n;
}

static int columns(const sheet *t)
{
    int n = 0;
    while (n < MOST_HEADS && t->column[n].head) ++n;
    return n;
}

/* Our cell of a row; "" where there is nothing. */
static const char *cell(char text[32], const sheet *t, const row *rows, int i, int c)
{
    const double v = sheet_value(t, rows, i, c);
    if (isnan(v)) return "";
    snprintf(text, 32, "%.*f", t->column[c].digits, fabs(v) < 0.5 * pow(10, -t->column[c].digits) ? 0.0 : v);
    return text;
}

/* A claim, what came of it, and the figures that it is of. */
static const char *sentence(char out[512], const sheet *t, const claim *c, const row *rows)
{
    const int holds = sheet_holds(t, c, rows);
    char a[32], b[32];
    if (holds < 0) {
        snprintf(out, 512, "%s: not known, for a row of it was not drawn", c->says);
        return out;
    }
    snprintf(out, 512, "%s: %s (%s%s%s)%s%s", c->says, holds ? "agrees" : "does not agree",
             cell(a, t, rows, c->a, c->column), c->b == ALONE ? "" : " beside ",
             c->b == ALONE ? "" : cell(b, t, rows, c->b, c->column), c->why && !holds ? "; " : "",
             c->why && !holds ? c->why : "");
    return out;
}

/* ---- >>html ------------------------------------------------------------------------------------------------------ */

static void html_row(FILE *f, const sheet *t, const row *rows, int i)
{
    const paper_row *p = &t->rows[i];
    char text[32];
    fputs("<tr><td>", f);
    page_escaped(f, p->what);
    fputs("<td>", f);
    if (!p->method) fputs("not drawn: ", f);
    else fprintf(f, "<code>%s %s</code>%s", p->method, p->settings ? p->settings : "", p->note ? "; " : "");
    if (p->note) page_escaped(f, p->note);
    for (int k = 0; k < heads(t); ++k) { fputs("<td>", f); page_escaped(f, p->printed[k] ? p->printed[k] : ""); }
    for (int c = 0; c < columns(t); ++c) fprintf(f, "<td>%s", cell(text, t, rows, i, c));
    fputs("\n", f);
}

void show_html(FILE *f, const sheet *t, const row *rows)
{
    char text[512];
    fputs("<div class=\"wide\"><table>\n<tr><th>the paper's<th>ours", f);
    for (int k = 0; k < heads(t); ++k) { fputs("<th>paper: ", f); page_escaped(f, t->head[k]); }
    for (int c = 0; c < columns(t); ++c) { fputs("<th>", f); page_escaped(f, t->column[c].head); }
    fputs("\n", f);
    for (int i = 0; i < t->count; ++i) html_row(f, t, rows, i);
    fputs("</table></div>\n<ul>\n", f);
    for (int k = 0; k < t->claimed; ++k) {
        fputs("<li>", f);
        page_escaped(f, sentence(text, t, &t->claims[k], rows));
        fputs("\n", f);
    }
    fputs("</ul>\n", f);
}

/* ---- >>csv: a line a cell, as FIGURES.md's part is made of ------------------------------------------------------- */

static void csv_text(FILE *f, const char *s)
{
    fputc('"', f);
    for (; *s; ++s) { if (*s == '"') fputc('"', f); fputc(*s, f); }
    fputc('"', f);
}

static void csv_cell(FILE *f, const sheet *t, int r, const char *kind, const char *head, const char *text)
{
    csv_text(f, t->paper);
    fputc(',', f);
    csv_text(f, t->name);
    fprintf(f, ",%d,%s,", r, kind);
    csv_text(f, head);
    fputc(',', f);
    csv_text(f, text ? text : "");
    fputc('\n', f);
}

void show_csv_head(FILE *f) { fputs("paper,figure,row,kind,head,text\n", f); }

void show_csv(FILE *f, const sheet *t, const row *rows)
{
    static const char *const came_to[] = { "unknown", "differs", "agrees" };
    char text[32], said[512];
    csv_cell(f, t, 0, "title", "", t->title);
    csv_cell(f, t, 0, "theirs", "", t->theirs);
    if (t->erratum) csv_cell(f, t, 0, "erratum", "", t->erratum);
    csv_cell(f, t, 0, "ours", "", t->ours);
    for (int i = 0; i < t->count; ++i) {
        const paper_row *p = &t->rows[i];
        csv_cell(f, t, i + 1, "what", "", p->what);
        csv_cell(f, t, i + 1, "method", p->method ? p->method : "", p->method ? p->settings : NULL);
        if (p->note) csv_cell(f, t, i + 1, "note", "", p->note);
        for (int k = 0; k < heads(t); ++k) csv_cell(f, t, i + 1, "printed", t->head[k], p->printed[k]);
        for (int c = 0; c < columns(t); ++c)
            csv_cell(f, t, i + 1, "measured", t->column[c].head, cell(text, t, rows, i, c));
    }
    for (int k = 0; k < t->claimed; ++k)
        csv_cell(f, t, 0, "claim", came_to[1 + sheet_holds(t, &t->claims[k], rows)],
                 sentence(said, t, &t->claims[k], rows));
}

/* ---- >>text ------------------------------------------------------------------------------------------------------ */

void show_text(FILE *f, const sheet *t, const row *rows)
{
    int agree = 0, known = 0;
    char said[512];
    for (int k = 0; k < t->claimed; ++k) {
        const int holds = sheet_holds(t, &t->claims[k], rows);
        agree += holds > 0;
        known += holds >= 0;
    }
    fprintf(f, "%s %s, %s: %d of %d statements agree\n", t->paper, t->name, t->title, agree, known);
    for (int k = 0; k < t->claimed; ++k)
        if (sheet_holds(t, &t->claims[k], rows) < 1) fprintf(f, "    %s\n", sentence(said, t, &t->claims[k], rows));
}
