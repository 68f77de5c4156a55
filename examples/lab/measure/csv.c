/* csv.c - reads and prints tables. Declared in csv.h. */
#include "lab/measure/csv.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include "kit/kit.h"

/* Copies the next cell of a csv from *in to *out without quotes. Returns the character that ended the cell. */
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

csv csv_of(char *text, const char *name)
{
    csv c = { text, NULL, 0, 0 };
    char *in = text, *out = text;
    int cells = 0;
    if (!in || !*in) return c;
    c.cell = malloc(sizeof *c.cell * (strlen(in) + 2));
    if (!c.cell) { fprintf(stderr, "%s: out of memory\n", program_invocation_short_name); exit(2); }
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

csv csv_read(const char *folder, const char *name)
{
    char path[1024], *text;
    size_t size;
    if (*name == '/') snprintf(path, sizeof path, "%s", name);
    else snprintf(path, sizeof path, "%s/%s", folder, name);
    return csv_of(kit_file_read(&text, &size, path, NULL) ? NULL : text, name);
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

/* ---- >>out ------------------------------------------------------------------------------------------------------- */

void csv_quote(FILE *f, const char *text)
{
    fputc('"', f);
    for (; *text; ++text) {
        if (*text == '"') fputc('"', f);
        fputc(*text, f);
    }
    fputc('"', f);
}

void csv_figure(FILE *f, const char *format, double v)
{
    if (isnan(v)) fputc(',', f);
    else fprintf(f, format, v);
}

enum { MOST_COLUMNS = 64 };

static int is_empty(const csv *c, int column)
{
    int row = 1;
    while (row <= c->rows && !*c->cell[row * c->columns + column]) ++row;
    return row > c->rows;
}

/* Finds the columns of keys. A key without a column is left out; if aligned, a column without any cell, too. */
static int columns_of(int column[MOST_COLUMNS], const csv *c, const char *keys, int aligned)
{
    int count = 0;
    for (size_t length; *keys && count < MOST_COLUMNS; keys += length + (keys[length] == ',')) {
        length = strcspn(keys, ",");
        for (int i = 0; i < c->columns; ++i)
            if (!strncmp(c->cell[i], keys, length) && !c->cell[i][length] && !(aligned && is_empty(c, i)))
                column[count++] = i;
    }
    return count;
}

/* Writes one cell of a row. last: it is the row's last one. */
static void put_cell(FILE *f, const csv *c, int row, int column, int aligned, int last)
{
    const char *is = c->cell[row * c->columns + column];
    size_t width = strlen(c->cell[column]);
    int numbers = 1;
    char *end;
    for (int r = 1; r <= c->rows; ++r) {
        const char *other = c->cell[r * c->columns + column];
        if (strlen(other) > width) width = strlen(other);
        strtod(other, &end);
        numbers &= !*end;
    }
    if (aligned) fprintf(f, numbers ? "%*s" : "%-*s", numbers || !last ? (int)width : 0, is);
    else if (strpbrk(is, ",\"")) csv_quote(f, is);
    else fputs(is, f);
}

void csv_put(FILE *f, const csv *c, const char *keys, const char *empty, int aligned)
{
    int column[MOST_COLUMNS];
    const int count = columns_of(column, c, keys, aligned);
    for (int row = 0; row <= c->rows; ++row) {
        if (row && empty && *csv_text(c, row - 1, empty)) continue;
        for (int k = 0; k < count; ++k) {
            if (k) fputs(aligned ? "  " : ",", f);
            put_cell(f, c, row, column[k], aligned, k + 1 == count);
        }
        fputc('\n', f);
    }
}
