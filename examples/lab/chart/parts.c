/* parts.c - what demo and chart are made of: which rows are asked for, pictures, tables that an interrupted chart finds
   again. Declared in report.h. */
#include "lab/report.h"
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

int asked(const options *o, const char *method) { return !o->method || !strncmp(method, o->method, strlen(o->method)); }

/* The entries that a chart shows; how many. */
int chosen(entry *out, const entry *entries, int count, const options *o)
{
    int n = 0;
    for (int i = 0; i < count; ++i)
        if ((entries[i].quick || !o->quick) && asked(o, entries[i].method)) out[n++] = entries[i];
    return n;
}

int save(const kit_image *image, const char *names, int srgb, const char *out, const char *slug, const char *ending,
         kit_error *err)
{
    char path[4096];
    snprintf(path, sizeof path, "%s/%s%s", out, slug, ending);
    return strstr(ending, ".exr") ? kit_exr_write(image, path, err) : kit_png_write(image, names, srgb, path, err);
}

void slug_of(char slug[64], const char *label)
{
    size_t n = 0;
    for (; *label && n < 63; ++label)
        if (isalnum((unsigned char)*label)) slug[n++] = (char)tolower((unsigned char)*label);
        else if (n && slug[n - 1] != '-') slug[n++] = '-';
    slug[n] = 0;
}

/* A chart as a file of its own and inside the page. */
int chart_of(FILE *html, const char *out, const char *name, const char *title, const words *w, const row *rows,
             int count, double floor_, kit_error *err)
{
    page p;
    if (page_open(&p, err)) return -1;
    chart_svg(p.file, title, w, rows, count, floor_);
    fflush(p.file);
    fwrite(p.text, 1, p.size, html);
    return page_close(&p, out, name, err);
}

/* The part of a picture in crop (NULL: all), each pixel times x times: exposed R, G, B and their luminance Y. */
int exposed(kit_image *out, const kit_image *picture, float exposure, const int *crop, int times, kit_error *err)
{
    static const char *const names[3] = { "R", "G", "B" };
    static const float weight[3] = { 0.2126f, 0.7152f, 0.0722f };
    const int all[4] = { 0, 0, picture->width, picture->height };
    size_t i = 0;
    if (!crop) crop = all;
    if (kit_image_new(out, crop[2] * times, crop[3] * times, "R,G,B,Y", err)) return -1;
    for (int y = 0; y < out->height; ++y)
        for (int x = 0; x < out->width; ++x, ++i)
            for (size_t c = 0; c < 3; ++c) {
                const float v =
                    exposure
                    * kit_image_channel(picture, names[c])[(size_t)(crop[1] + y / times) * (size_t)picture->width
                                                           + (size_t)(crop[0] + x / times)];
                out->data[c * (size_t)out->width * (size_t)out->height + i] = v;
                out->data[3 * (size_t)out->width * (size_t)out->height + i] += weight[c] * v;
            }
    return 0;
}

/* Means of blocks of pixels, of what is known: no wider than most, blocks no smaller than least. */
static int shrunk(kit_image *out, const kit_image *picture, const char *names, int most, int least, kit_error *err)
{
    const int fits = (picture->width + most - 1) / most, block = fits > least ? fits : least;
    if (kit_image_new(out, picture->width / block, picture->height / block, names, err)) return -1;
    for (int c = 0; c < out->channels; ++c) {
        const float *from = kit_image_channel(picture, out->name[c]);
        float *to = kit_image_channel(out, out->name[c]);
        for (int i = 0; i < out->width * out->height; ++i) {
            int known = 0;
            for (int k = 0; k < block * block; ++k) {
                const int x = i % out->width * block + k % block, y = i / out->width * block + k / block;
                const float v = from[y * picture->width + x];
                if (isnan(v)) continue;
                to[i] += v;
                ++known;
            }
            to[i] /= (float)known;
        }
    }
    return 0;
}

/* ---- >>units: what a chart is made of ---------------------------------------------------------------------------- */

enum { MOST_UNITS = 96 };
static struct { uint64_t key; int all, count, measured; double begun; char now[32], path[MOST_UNITS][96]; } units;

static uint64_t hashed_file(uint64_t h, const char *path)
{
    char *data;
    size_t size;
    if (kit_file_read(&data, &size, path, NULL)) return h;
    h = kit_hash(h, data, size);
    free(data);
    return h;
}

int planned(measuring *measure_, int count, const options *o)
{
    int sum = 0;
    for (int k = 0; k < count; ++k) sum += measure_(NULL, o, k, NULL, NULL);
    return sum;
}

/* What all units depend on: the program with its tables, what it is asked for, meshes. */
void units_begin(const options *o, int all)
{
    static const char *const files[] = { BUNNY, BED, MAPLE, HOUSE };
    const char *const text[] = { kit_gl_name(), o->out, o->method ? o->method : "", o->quick ? "quick" : "" };
    memset(&units, 0, sizeof units);
    units.all = all;
    units.begun = kit_seconds();
    units.key = hashed_file(KIT_HASH, "/proc/self/exe");
    for (int i = 0; i < COUNT(files); ++i) units.key = hashed_file(units.key, files[i]);
    for (int i = 0; i < COUNT(text); ++i) units.key = kit_hash(units.key, text[i], strlen(text[i]) + 1);
    for (int i = 0; i < o->scenes; ++i)
        units.key = hashed_file(kit_hash(units.key, o->scene[i], strlen(o->scene[i]) + 1), o->scene[i]);
}

void units_end(void)
{
    for (int i = 0; i < units.count; ++i) remove(units.path[i]);
}

/* Whether the pictures that a part of the page shows are still in the folder. */
static int pictured(const char *html, const char *out)
{
    char path[4096];
    while ((html = strstr(html, "src=\"")) != NULL) {
        html += strlen("src=\"");
        snprintf(path, sizeof path, "%s/%.*s", out, (int)strcspn(html, "\""), html);
        if (access(path, R_OK)) return 0;
    }
    return 1;
}

/* One table on one scene: measured, or as an interrupted chart left it. How many rows, 0: none are asked for; -1 =
   failed. */
int unit(FILE *html, const options *o, const char *kind, int k, measuring *measure_, row *rows, kit_error *err)
{
    char *path = units.path[units.count], *text, *at, left[64] = "";
    size_t size;
    int count = measure_(NULL, o, k, NULL, NULL);
    page part, kept;
    kit_error note;
    if (!count) return 0;
    ++units.count;
    snprintf(units.now, sizeof units.now, "%s-%d", kind, k);
    snprintf(path, sizeof *units.path, "build/cache/unit-%s-%016llx", units.now, (unsigned long long)units.key);
    if (!kit_file_read(&text, &size, path, NULL)) {            /* text stays: rows point into it */
        memcpy(&count, text, sizeof count);
        memcpy(rows, text + sizeof count, (size_t)count * sizeof *rows);
        at = text + sizeof count + (size_t)count * sizeof *rows;
        for (int i = 0; i < count; ++i) {
            const char **name[] = { &rows[i].scene, &rows[i].label, &rows[i].method, &rows[i].settings };
            for (int j = 0; j < COUNT(name); ++j, at += strlen(at) + 1) *name[j] = at;
        }
        if (pictured(at, o->out)) {
            fputs(at, html);
            return count;
        }
    }
    if (units.measured)
        snprintf(left, sizeof left, ", about %.0f min left",
                 ceil((kit_seconds() - units.begun) / units.measured * (units.all - units.count + 1) / 60));
    if (isatty(2)) fprintf(stderr, "%d of %d%s\n", units.count, units.all, left);
    if (page_open(&part, err)) return -1;
    count = measure_(part.file, o, k, rows, err);
    ++units.measured;
    fflush(part.file);
    if (count >= 0 && !page_open(&kept, err)) {
        fwrite(&count, sizeof count, 1, kept.file);
        fwrite(rows, sizeof *rows, (size_t)count, kept.file);
        for (int i = 0; i < count; ++i)
            fprintf(kept.file, "%s%c%s%c%s%c%s%c", rows[i].scene, 0, rows[i].label, 0, rows[i].method, 0,
                    rows[i].settings, 0);
        fwrite(part.text, 1, part.size, kept.file);
        if (folder("build/cache", &note) || page_close(&kept, "build/cache", path + strlen("build/cache/"), &note))
            fprintf(stderr, "report: note: what is measured is not kept: %s\n", note.text);
    }
    page_into(&part, html);
    return count;
}

/* Small pictures: the truth, the best row of those that take no longer than the reference (else the fastest), the best
   of all. */
int thumbs(FILE *html, const char *out, const stage *s, const row *rows, const kit_image *pictures, int count,
           kit_error *err)
{
    static const char *const endings[] = { "truth", "fast", "best" };
    const char *const names = s->lit ? "R,G,B" : "Y";
    int fast = 0, best = 0;
    for (int i = 1; i < count; ++i) {
        const row *r = &rows[i], *f = &rows[fast];
        if (f->relative > 1 ? r->relative < f->relative : r->relative < 1 && r->score.rmse < f->score.rmse) fast = i;
        if (r->score.rmse < rows[best].score.rmse) best = i;
    }
    fputs("<div class=\"grid thumbs\">\n", html);
    for (int k = 0; k < (best == fast ? 2 : 3); ++k) {
        const row *r = &rows[k > 1 ? best : fast];
        const kit_image *from = k ? &pictures[r - rows] : &s->truth;
        kit_image bright = { 0 }, small;
        char slug[160], label[160], note[64] = "";
        if (s->lit && exposed(&bright, from, s->lit->exposure, NULL, 1, err)) return -1;
        if (shrunk(&small, s->lit ? &bright : from, names, 320, s->stride, err)) return -1;
        snprintf(slug, sizeof slug, "thumb-%s-", units.now);
        slug_of(slug + strlen(slug), s->name);
        snprintf(slug + strlen(slug), sizeof slug - strlen(slug), "-%s", endings[k]);
        snprintf(label, sizeof label, k ? "%s, %s" : "ray-traced truth", r->label, settings_of(r));
        if (k) snprintf(note, sizeof note, "time %.2f, error %.3f", r->relative, r->share);
        if (save(&small, names, s->lit != NULL, out, slug, ".png", err)) return -1;
        figure_html(html, slug, label, note, small.width, small.height, 0);
        fputs("</figure>\n", html);
        kit_image_free(&bright);
        kit_image_free(&small);
    }
    fputs("</div>\n", html);
    return 0;
}
