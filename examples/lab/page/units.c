/* units.c - measures units of a chart, and keeps them until the chart is complete. Declared in units.h. */
#include "lab/page/units.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kit/kit_gl.h"
#include "lab/measure/folder.h"
#include "lab/measure/line.h"
#include "lab/measure/stage.h"
#include "lab/page/page.h"

int units_asked(const options *o, const char *method)
{
    return !o->method || !strncmp(method, o->method, strlen(o->method));
}

/* ---- >>rows ------------------------------------------------------------------------------------------------------ */

enum { MOST_LINES = 512 };
static struct { const char *set; entry entry; } lines[MOST_LINES + 1];

void units_load(void)
{
    line l = { UNITS_FOLDER, .file = "rows" };
    int of_set = 0;
    for (line_open(&l); l.at < l.of.rows; ++l.at) {
        lines[l.at].set = line_cell(&l, "set");
        lines[l.at].entry = (entry){ line_cell(&l, "label"), line_cell(&l, "method"), line_cell(&l, "settings"),
                                     line_whole(&l, "quick") };
        of_set = l.at && !strcmp(lines[l.at - 1].set, lines[l.at].set) ? of_set + 1 : 1;
        if (l.at == MOST_LINES || of_set > MOST_ENTRIES) line_fault(&l, "set");
    }
}

const entry *units_row(int k) { return lines[k].set ? &lines[k].entry : NULL; }

int units_chosen(entry out[MOST_ENTRIES], const char *set, const options *o)
{
    int n = 0;
    for (int i = 0; lines[i].set; ++i)
        if (!strcmp(lines[i].set, set) && (lines[i].entry.quick || !o->quick) && units_asked(o, lines[i].entry.method))
            out[n++] = lines[i].entry;
    return n;
}

/* ---- >>units ----------------------------------------------------------------------------------------------------- */

enum { MOST_UNITS = 96 + MOST_SEEDS };
static struct { uint64_t key; int all, count, measured; double begun; char path[MOST_UNITS][96]; } units;

uint64_t units_hash(uint64_t h, const char *path)
{
    char *data;
    size_t size;
    if (kit_file_read(&data, &size, path, NULL)) return h;
    h = kit_hash(h, data, size);
    free(data);
    return h;
}

int units_count(measuring *measure, int count, const options *o)
{
    int sum = 0;
    for (int k = 0; k < count; ++k) sum += measure(NULL, o, k, NULL, NULL);
    return sum;
}

/* Sets the key of all units, which depends on the program with its tables, the command's options and the meshes. */
void units_begin(const options *o, int all)
{
    static const char *const files[] = { BUNNY, BED, "build/models/maple.obj", "build/models/fzk-house.obj",
                                         UNITS_FOLDER "/rows.csv", UNITS_FOLDER "/sets.csv",
                                         UNITS_FOLDER "/views.csv" };
    const char *const text[] = { kit_gl_name(), o->out, o->method ? o->method : "", o->paper ? o->paper : "",
                                 o->drawn ? o->drawn : "", o->mesh ? o->mesh : "", o->quick ? "quick" : "" };
    memset(&units, 0, sizeof units);
    units.all = all;
    units.begun = kit_seconds();
    units.key = units_hash(KIT_HASH, "/proc/self/exe");
    for (int i = 0; i < COUNT(files); ++i) units.key = units_hash(units.key, files[i]);
    for (int i = 0; i < COUNT(text); ++i) units.key = kit_hash(units.key, text[i], strlen(text[i]) + 1);
    for (int i = 0; i < o->scenes; ++i)
        units.key = units_hash(kit_hash(units.key, o->scene[i], strlen(o->scene[i]) + 1), o->scene[i]);
}

void units_end(void)
{
    for (int i = 0; i < units.count; ++i) remove(units.path[i]);
}

/* Returns whether the pictures that a part of the page names are still in the folder. */
static int pictured(const char *part, const char *out)
{
    static const char key[] = "{\"picture\":\"";
    char path[4096];
    while ((part = strstr(part, key)) != NULL) {
        part += strlen(key);
        snprintf(path, sizeof path, "%s/%.*s.png", out, (int)strcspn(part, "\""), part);
        if (access(path, R_OK)) return 0;
    }
    return 1;
}

/* Reads a unit that an interrupted chart left. Returns how many rows; -1: there is no such file. */
static int recalled(FILE *f, const options *o, const char *path, row *rows)
{
    char *text, *at;
    size_t size;
    int count;
    if (kit_file_read(&text, &size, path, NULL)) return -1;    /* not freed, as rows point into this text */
    memcpy(&count, text, sizeof count);
    memcpy(rows, text + sizeof count, (size_t)count * sizeof *rows);
    at = text + sizeof count + (size_t)count * sizeof *rows;
    for (int i = 0; i < count; ++i) {
        const char **name[] = { &rows[i].scene, &rows[i].label, &rows[i].method, &rows[i].settings };
        for (int j = 0; j < COUNT(name); ++j, at += strlen(at) + 1) *name[j] = at;
    }
    if (!pictured(at, o->out)) return -1;
    fputs(at, f);
    return count;
}

static void keep(const char *path, const page *part, const row *rows, int count)
{
    page kept;
    kit_error note;
    if (page_open(&kept, NULL)) return;
    fwrite(&count, sizeof count, 1, kept.file);
    fwrite(rows, sizeof *rows, (size_t)count, kept.file);
    for (int i = 0; i < count; ++i)
        fprintf(kept.file, "%s%c%s%c%s%c%s%c", rows[i].scene, 0, rows[i].label, 0, rows[i].method, 0,
                rows[i].settings, 0);
    fwrite(part->text, 1, part->size, kept.file);
    if (folder_make(FOLDER_CACHE, &note) || page_close(&kept, FOLDER_CACHE, path + strlen(FOLDER_CACHE "/"), &note))
        fprintf(stderr, "report: note: measurements are not kept: %s\n", note.text);
}

int units_measure(FILE *f, const options *o, const char *kind, int k, measuring *measure, row *rows, kit_error *err)
{
    char *path = units.path[units.count], left[64] = "";
    page part;
    if (!measure(NULL, o, k, NULL, NULL)) return 0;
    ++units.count;
    snprintf(path, sizeof *units.path, FOLDER_CACHE "/unit-%s-%d-%016llx", kind, k, (unsigned long long)units.key);
    const int before = recalled(f, o, path, rows);
    if (before >= 0) return before;
    if (units.measured)
        snprintf(left, sizeof left, ", about %.0f min left",
                 ceil((kit_seconds() - units.begun) / units.measured * (units.all - units.count + 1) / 60));
    if (isatty(2)) fprintf(stderr, "%d of %d%s\n", units.count, units.all, left);
    if (page_open(&part, err)) return -1;
    const int count = measure(part.file, o, k, rows, err);
    ++units.measured;
    fflush(part.file);
    if (count >= 0) keep(path, &part, rows, count);
    page_into(&part, f);
    return count;
}
