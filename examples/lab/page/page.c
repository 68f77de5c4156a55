/* page.c - writes files that reach the disk whole, and the records that the page shows. Declared in page.h. */
#include "lab/page/page.h"
#include <stdarg.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- >>page ------------------------------------------------------------------------------------------------------ */

int page_open(page *p, kit_error *err)
{
    p->text = NULL;
    p->file = open_memstream(&p->text, &p->size);
    return p->file ? 0 : kit_fail(err, "out of memory");
}

int page_close(page *p, const char *folder, const char *name, kit_error *err)
{
    char path[4096];
    int status = ferror(p->file);
    snprintf(path, sizeof path, "%s/%s", folder, name);
    if (fclose(p->file) || status) status = kit_fail(err, "%s: out of memory", path);
    else status = kit_file_write(path, p->text, p->size, err);
    free(p->text);
    return status;
}

void page_into(page *p, FILE *f)
{
    fclose(p->file);
    fwrite(p->text, 1, p->size, f);
    free(p->text);
}

/* Copies the first line of a command's output, without its end; "" if there is none. */
static void line_of(char *out, int size, const char *command)
{
    FILE *f = popen(command, "r");
    if (!f || !fgets(out, size, f)) *out = 0;
    if (f) pclose(f);
    out[strcspn(out, "\n")] = 0;
}

/* ---- >>records --------------------------------------------------------------------------------------------------- */

static void put_format(FILE *f, const char *format, va_list list)
{
    char text[4096];
    vsnprintf(text, sizeof text, format, list);
    kit_json_string(f, text);
}

int page_begin(page *p, const char *name, const char *kind, const char *command, const char *driver, kit_error *err)
{
    char value[4][160];
    line_of(value[0], sizeof *value, "git log -1 --format=%h 2>/dev/null");
    line_of(value[1], sizeof *value, "git status --porcelain -- ssgi.h ssgi_gl.h examples/kit 2>/dev/null");
    line_of(value[2], sizeof *value, "sed -n 's/^model name[^:]*: //p' /proc/cpuinfo");
    snprintf(value[3], sizeof *value, "%.100s%s", *value[0] ? value[0] : "unknown", *value[1] ? " with changes" : "");
    const char *const key[] = { "name", "kind", "command", "commit", "processor", "driver" },
               *const is[] = { name, kind, command, value[3], *value[2] ? value[2] : "unknown", driver };
    if (page_open(p, err)) return -1;
    fputs("ssgi_record({", p->file);
    for (int i = 0; i < 6; ++i) {
        fprintf(p->file, "\"%s\":", key[i]);
        kit_json_string(p->file, is[i]);
        fputc(',', p->file);
    }
    fprintf(p->file, "\"cores\":%ld,\"entries\":[\n", sysconf(_SC_NPROCESSORS_ONLN));
    return 0;
}

/* Copies the page's files beside the records, and README's pictures, which the demo opens with. The last two files are
   for charts; make page-deps takes them from npm. */
static int copy_page(const char *folder, kit_error *err)
{
    static const char *const from[] = { "examples/lab/page/index.html", "examples/lab/page/report.js",
                                        "examples/docs/pictures/lit.png", "examples/docs/pictures/beside-1001.png",
                                        "examples/docs/pictures/moving.png",
                                        "build/page/node_modules/d3/dist/d3.min.js",
                                        "build/page/node_modules/@observablehq/plot/dist/plot.umd.min.js" };
    for (size_t i = 0; i < sizeof from / sizeof *from; ++i) {
        char *text, path[4096];
        size_t size;
        if (kit_file_read(&text, &size, from[i], NULL)) continue;
        snprintf(path, sizeof path, "%s/%s", folder, strrchr(from[i], '/') + 1);
        const int failed = kit_file_write(path, text, size, err);
        free(text);
        if (failed) return -1;
    }
    return 0;
}

int page_end(page *p, const char *folder, const char *name, kit_error *err)
{
    char file[128];
    snprintf(file, sizeof file, "%s.js", name);
    fputs("null]})\n", p->file);
    return page_close(p, folder, file, err) || copy_page(folder, err) ? -1 : 0;
}

void page_heading(FILE *f, int level, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    fprintf(f, "{\"level\":%d,\"heading\":", level);
    put_format(f, format, list);
    fputs("},\n", f);
    va_end(list);
}

void page_paragraph(FILE *f, const char *format, ...)
{
    va_list list;
    va_start(list, format);
    fputs("{\"paragraph\":", f);
    put_format(f, format, list);
    fputs("},\n", f);
    va_end(list);
}

void page_figure(FILE *f, const char *slug, const char *label, const char *note, int width, int height, int difference)
{
    fputs("{\"picture\":", f);
    kit_json_string(f, slug);
    fputs(",\"label\":", f);
    kit_json_string(f, label);
    fputs(",\"note\":", f);
    kit_json_string(f, note);
    fprintf(f, ",\"width\":%d,\"height\":%d,\"difference\":%d},\n", width, height, difference);
}

void page_key(FILE *f, double range) { fprintf(f, "{\"key\":%g},\n", range); }

static void put_table(FILE *f, const char *kind, const page *csv)
{
    fflush(csv->file);
    fputs("{\"table\":", f);
    kit_json_string(f, kind);
    fputs(",\"csv\":", f);
    kit_json_string(f, csv->text);
    fputs("},\n", f);
}

void page_table(FILE *f, const char *kind, page *csv)
{
    put_table(f, kind, csv);
    fclose(csv->file);
    free(csv->text);
}

int page_csv(FILE *f, const char *kind, page *csv, const char *folder, const char *name, kit_error *err)
{
    put_table(f, kind, csv);
    return page_close(csv, folder, name, err);
}
