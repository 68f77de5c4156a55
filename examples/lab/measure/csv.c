/* csv.c - tables as make cost writes them. Declared in csv.h. */
#include "lab/measure/csv.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *csv_folder = "report";

char *csv_file(const char *name)
{
    char path[1024];
    FILE *f;
    char *text = NULL;
    long size = -1;
    snprintf(path, sizeof path, "%s/%s", csv_folder, name);
    f = fopen(path, "rb");
    if (!f) return NULL;
    if (!fseek(f, 0, SEEK_END) && (size = ftell(f)) >= 0 && !fseek(f, 0, SEEK_SET)) text = calloc((size_t)size + 1, 1);
    if (text && fread(text, 1, (size_t)size, f) != (size_t)size) { free(text); text = NULL; }
    fclose(f);
    return text;
}

/* The next cell from *in, its quotes taken off, at *out; returns what ended it. */
static char cell(char **in, char **out)
{
    int quoted = 0;
    for (; **in && (quoted || (**in != ',' && **in != '\n')); ++*in) {
        if (**in != '"') *(*out)++ = **in;
        else if (quoted && (*in)[1] == '"') *(*out)++ = *(*in)++;
        else quoted = !quoted;
    }
    const char end = **in;
    if (end) ++*in;
    *(*out)++ = 0;
    return end;
}

csv csv_read(const char *name)
{
    csv c = { NULL, NULL, 0, 0 };
    char *in = csv_file(name), *out;
    int cells = 0;
    if (!in || !*in) return c;
    c.cell = malloc(sizeof *c.cell * (strlen(in) + 2));
    if (!c.cell) { fprintf(stderr, "%s: out of memory\n", program_invocation_short_name); exit(2); }
    c.text = out = in;
    while (*in) {
        c.cell[cells++] = out;
        if (cell(&in, &out) == ',') continue;
        if (!c.columns) c.columns = cells;
        if (cells % c.columns) {
            fprintf(stderr, "%s: %s: line %d has another number of columns\n", program_invocation_short_name, name,
                    cells / c.columns + 1);
            exit(2);
        }
    }
    c.rows = c.columns ? cells / c.columns - 1 : 0;
    return c;
}

const char *csv_text(const csv *c, int row, const char *key)
{
    for (int i = 0; i < c->columns; ++i) if (!strcmp(c->cell[i], key)) return c->cell[(row + 1) * c->columns + i];
    return "";
}

double csv_number(const csv *c, int row, const char *key)
{
    const char *t = csv_text(c, row, key);
    return *t ? atof(t) : (double)NAN;
}
