/* markdown.c - the page as it is written: headings, tables. Declared in markdown.h. */
#include "lab/figures/markdown.h"
#include <math.h>
#include <string.h>

void markdown_number(const markdown *m, double v, int digits, int sign)
{
    if (isnan(v)) fputs(" |", m->file);
    else fprintf(m->file, sign ? " %+.*f |" : " %.*f |", digits, fabs(v) < 0.5 * pow(10, -digits) ? 0.0 : v);
}

void markdown_heading(const markdown *m, const char *title, const char *about, const char *note)
{
    fprintf(m->file, "\n### %s\n\n", title);
    for (const char *s = about; *s; ++s) {        /* beside the csv the pictures are in no folder */
        fputc(*s, m->file);
        if (!m->full && !strncmp(s, "(pictures/", 10)) s += 9;
    }
    if (*about) fputs("\n\n", m->file);
    fprintf(m->file, "*%s*\n\n", note);
}

void markdown_ruler(const markdown *m, int columns)
{
    fputc('|', m->file);
    while (columns--) fputs("---|", m->file);
    fputc('\n', m->file);
}

/* The method's own name comes first where the label does not tell it. */
void markdown_settings(const markdown *m, const csv *c, int row)
{
    const char *label = csv_text(c, row, "label"), *method = csv_text(c, row, "method"),
               *set = csv_text(c, row, "settings");
    if (!strcmp(method, "none")) { fputs("| nothing |", m->file); return; }
    if (!strcmp(method, "floor")) { fputs("| exact answer from one layer, thin sheets |", m->file); return; }
    fprintf(m->file, "| %s", label);
    if (strcmp(label, method) && strstr("hsao hsao-fast hsao-best hsao-march hsao-history ssao ssdo ssdo-fast "
        "s3ho s3ho-fast", method))
        fprintf(m->file, ", `%s`", method);
    const char *const mark = strchr(set, ' ') ? "" : "`";      /* others' passes have words, ours have settings */
    if (*set) fprintf(m->file, ": %s", mark);
    for (const char *s = set; *s; ++s) {
        fputc(*s, m->file);
        if (*s == ',' && s[1] != ' ') fputc(' ', m->file);
    }
    fprintf(m->file, "%s |", *set ? mark : "");
}
