/* line.c - reads the cells of the laboratory's tables. Declared in line.h. */
#include "lab/measure/line.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>

void line_open(line *l)
{
    char name[32];
    snprintf(name, sizeof name, "%s.csv", l->file);
    l->of = csv_read(l->folder, name);
    l->at = 0;
    if (!l->of.rows) line_fault(l, "");
}

void line_fault(const line *l, const char *key)
{
    fprintf(stderr, "%s: %s/%s.csv", program_invocation_short_name, l->folder, l->file);
    if (!l->of.rows) fputs(": cannot be read, or has no rows\n", stderr);
    else fprintf(stderr, ", line %d: %s \"%s\"\n", l->at + 2, key, l->at < l->of.rows ? line_cell(l, key) : "");
    exit(2);
}

int line_find(line *l, const char *key, const char *text, size_t length)
{
    for (l->at = 0; l->at < l->of.rows; ++l->at) {
        const char *is = line_cell(l, key);
        if (strlen(is) == length && !strncmp(is, text, length)) return 1;
    }
    return 0;
}

const char *line_cell(const line *l, const char *key) { return csv_text(&l->of, l->at, key); }

const char *line_text(const line *l, const char *key)
{
    static line words = { .file = "words" };
    const char *at = line_cell(l, key), *end;
    char *out = NULL;
    size_t size;
    if (!*at || !strchr(at, '{')) return *at ? at : NULL;
    if (!words.folder || strcmp(words.folder, l->folder)) {
        words.folder = l->folder;
        line_open(&words);
    }
    FILE *f = open_memstream(&out, &size);
    for (; f && *at; ++at) {
        if (*at != '{') {
            fputc(*at, f);
            continue;
        }
        if (!(end = strchr(at, '}')) || !line_find(&words, "word", at + 1, (size_t)(end - at - 1))) line_fault(l, key);
        fputs(line_cell(&words, "text"), f);
        at = end;
    }
    if (!f || fclose(f)) line_fault(l, key);
    return out;
}

int line_whole(const line *l, const char *key) { return atoi(line_cell(l, key)); }
float line_real(const line *l, const char *key) { return (float)atof(line_cell(l, key)); }

void line_reals(const line *l, const char *key, const char *text, float *v, int count)
{
    char *end = NULL;
    for (int k = 0; *text && k < count; ++k, text = end) {
        v[k] = strtof(text, &end);
        if (end == text) line_fault(l, key);
    }
}

void line_split(const line *l, const char *key, const char **out, int most)
{
    char *text = strdup(line_cell(l, key));
    for (int k = 0; text && *text; ++k) {
        char *const part = strsep(&text, "|");
        if (k == most) line_fault(l, key);
        out[k] = *part ? part : NULL;
    }
}

int line_word(const line *l, const char *key, const char *words, const char *text, size_t length)
{
    int n = 0;
    for (const char *at = words; *at; ++n, at += strspn(at, " ")) {
        const size_t own = strcspn(at, " ");
        if (own == length && !memcmp(at, text, own)) return n;
        at += own;
    }
    line_fault(l, key);
    return -1;
}
