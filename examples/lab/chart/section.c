/* section.c - measures sections and shows them. Declared in section.h. */
#include "lab/chart/section.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/page/page.h"
#include "lab/page/pictures.h"
#include "lab/page/table.h"

/* ---- >>pictures -------------------------------------------------------------------------------------------------- */

/* Writes the text above a stage's pictures. If times is not 0, it names the truth's own error, measured at every
   stride-th pixel with so many times the truth's rays. */
static int about(FILE *record, stage *s, const char *text, int times, int stride, kit_error *err)
{
    char own[128] = "", of[64] = "";
    kit_image probe;
    row noise;
    if (times) {
        if (stage_trace(&probe, s, times * s->rays, stride, err) || score_picture(&noise, s, &probe, err)) return -1;
        kit_image_free(&probe);
        if (s->lit)
            snprintf(own, sizeof own, "; its own error, over the means: radiance %.4f, irradiance %.4f, bounce %.3f",
                     noise.error[0], noise.error[1], s->lit->bounce ? noise.error[2] : 0);
        else snprintf(own, sizeof own, "; its own error: %.5f", noise.score.rmse);
    }
    if (s->stride > 1) snprintf(of, sizeof of, ", one of each %d x %d", s->stride, s->stride);
    page_paragraph(record, "%s %zu triangles, %d x %d pixels, radius %g. Truth: %d %s%s%s.", text,
                   s->scene.mesh.triangles, s->frame.width, s->frame.height, (double)s->radius, s->rays,
                   s->otherwise.kind == SCATTER ? "thousand samples" : "rays a pixel", of, own);
    return 0;
}

/* Returns a picture as the demo shows it: a picture of light is exposed. */
static int seen_of(kit_image *out, const stage *s, const kit_image *picture, kit_error *err)
{
    if (s->lit) return pictures_exposed(out, picture, s->lit->exposure, NULL, 1, err);
    if (kit_image_new(out, picture->width, picture->height, "Y", err)) return -1;
    memcpy(out->data, picture->data, (size_t)out->width * (size_t)out->height * sizeof *out->data);
    return 0;
}

/* Writes the colours of differences as a ramp, which report.js shows as the key of the pictures of differences. */
static int legend(const char *out, kit_error *err)
{
    kit_image ramp, zero;
    if (kit_image_new(&ramp, 512, 16, "Y", err) || kit_image_new(&zero, 512, 16, "Y", err)) return -1;
    for (int i = 0; i < 512 * 16; ++i) ramp.data[i] = (float)(i % 512) / 511 - 0.5f;
    const int failed = pictures_difference(&ramp, &zero, 0.5f, out, "legend", err);
    kit_image_free(&ramp);
    kit_image_free(&zero);
    return failed;
}

/* Shows one picture. If a method drew it, shows its difference to the truth as well, but only for the first picture. */
static int figure(FILE *record, const options *o, const section *c, const stage *s, const pictured *p, const row *r,
                  const kit_image *truth, kit_error *err)
{
    const int colours = p->picture->channels > 1;
    char note[64];
    if (pictures_save(p->picture, colours ? "R,G,B" : "Y", colours, o->out, p->slug, ".png", err)
        || (!colours && pictures_save(p->picture, "Y", 0, o->out, p->slug, ".exr", err)))
        return -1;
    if (!r) snprintf(note, sizeof note, "%d %s", s->rays, s->otherwise.kind == SCATTER ? "thousand samples" : "rays");
    else if (isnan(r->relative)) snprintf(note, sizeof note, "error %.3f", r->share);
    else snprintf(note, sizeof note, "time %.2f, error %.3f", r->relative, r->share);
    page_figure(record, p->slug, p->label, note, p->picture->width, p->picture->height, r != NULL);
    if (r) return pictures_difference(p->picture, truth, (float)c->range, o->out, p->slug, err);
    page_key(record, c->range);
    return legend(o->out, err);
}

/* Shows the truth, the given pictures and the methods' pictures: whole, then enlarged parts. rows: those of methods
   come first, then those of the given pictures. */
static int figures(FILE *record, const options *o, const section *c, const set *t, const stage *s, const row *rows,
                   const kit_image *picture, int methods, kit_error *err)
{
    const int beside = c->beside ? s->givens : 0, count = methods + beside;
    const int (*crop)[4] = t->see->crop;
    kit_image seen[1 + MOST_ROWS];
    pictured p[1 + MOST_ROWS];
    for (int i = 0; i <= count; ++i) {
        const int at = i > beside ? i - 1 - beside : methods + i - 1;
        const kit_image *from = !i ? &s->truth : i > beside ? &picture[at] : &s->given[i - 1].picture;
        p[i].label = i ? rows[at].label : s->otherwise.kind == SCATTER ? "dipole over samples" : "ray-traced truth";
        p[i].picture = &seen[i];
        snprintf(p[i].slug, sizeof p[i].slug, "%s-%s-", c->name, s->name);
        pictures_slug(p[i].slug + strlen(p[i].slug), p[i].label);
        if (seen_of(&seen[i], s, from, err)
            || figure(record, o, c, s, &p[i], i ? &rows[at] : NULL, &seen[0], err))
            return -1;
    }
    for (int k = 0; k < MOST_CROPS && crop[k][2]; ++k) {
        if (pictures_crops(record, o->out, p, count + 1, k, crop[k], 1, c->crop_times, err)) return -1;
        page_paragraph(record, "%d x %d pixels of each, from %d, %d on, every pixel as %d x %d.", crop[k][2],
                       crop[k][3], crop[k][0], crop[k][1], c->crop_times, c->crop_times);
    }
    for (int i = 0; i <= count; ++i) kit_image_free(&seen[i]);
    return 0;
}

/* ---- >>sets ------------------------------------------------------------------------------------------------------ */

/* Keeps rows and sets the section's own columns; if it has any, the floor's row goes. Returns how many are left. */
static int kept_of(row *rows, int count, const section *c, const stage *s, const char *scene)
{
    int kept = 0;
    for (int i = 0; i < count; ++i) {
        if (c->of[0] && !strcmp(rows[i].method, "floor")) continue;
        rows[kept] = rows[i];
        rows[kept].scene = scene;
        if (c->of[0]) rows[kept].of = c->of[s->lit != NULL];
        ++kept;
    }
    return kept;
}

static int open_set(stage *s, const section *c, const set *t, kit_error *err)
{
    if (stage_load(s, t->see, err)) return -1;
    if (s->lit) s->stride = c->stride;
    return stage_show(s, t->see, c->width, c->height, err);
}

static int set_measure(FILE *record, const section *c, const set *t, const options *o, entry *entries, int count,
                       row *rows, kit_error *err)
{
    const int rounds = o->quick ? (c->rounds + 1) / 2 : c->rounds;
    kit_image picture[MOST_ENTRIES];
    stage s;
    if (open_set(&s, c, t, err)) return -1;
    if (c->more && (count = c->more(record, &s, entries, count, err)) < 0) return -1;
    if (c->measure ? c->measure(rows, &s, entries, count, picture, err)
                   : measure_entries(rows, &s, entries, count, rounds, t->phases, picture, err))
        return -1;
    if (about(record, &s, t->about, c->probe_times, c->probe_stride, err)) return -1;
    const int kept = kept_of(rows, count + s.givens, c, &s, t->see->name);
    if (c->range > 0 && figures(record, o, c, t, &s, rows, picture, count, err)) return -1;
    for (int i = 0; i < count; ++i) kit_image_free(&picture[i]);
    stage_close(&s);
    return kept;
}

static const section *now;                       /* the section whose sets unit_of_set measures */

static int unit_of_set(FILE *record, const options *o, int k, row *rows, kit_error *err)
{
    const set *t = set_of(now->sets, k);
    entry entries[MOST_ENTRIES];
    const int count = t->see ? units_chosen(entries, t->rows, o) : units_asked(o, now->method);
    if (!count || (o->quick && !t->quick)) return 0;
    if (!rows) return 1;
    if (t->see) return set_measure(record, now, t, o, entries, count, rows, err);
    page_paragraph(record, "%s", t->about);
    return now->own(record, o, rows, err);
}

static measuring *unit_of(const section *c)
{
    now = c;
    return c->unit ? c->unit : unit_of_set;
}

static int count_of(const section *c, const options *o)
{
    int count = 0;
    if (c->units) return c->units(o);
    while (set_of(c->sets, count)) ++count;
    return count;
}

int section_units(const section *c, const options *o) { return units_count(unit_of(c), count_of(c, o), o); }

/* ---- >>sections -------------------------------------------------------------------------------------------------- */

static const char *title_of(const section *c, int k)
{
    while (k && !set_of(c->sets, k)->title) --k;
    return set_of(c->sets, k)->title;
}

/* Measures the k-th unit of a section and keeps its rows. */
static int find(FILE *record, const section *c, const options *o, int k, found *f, kit_error *err)
{
    static row rows[MOST_SET_ROWS];
    f->count = units_measure(record, o, c->name, k, unit_of(c), rows, err);
    if (f->count <= 0) return f->count;
    f->row = malloc((size_t)f->count * sizeof *rows);
    if (!f->row) return kit_fail(err, "out of memory");
    memcpy(f->row, rows, (size_t)f->count * sizeof *rows);
    return f->count;
}

int section_chart(FILE *record, const section *c, const options *o, kit_error *err)
{
    const int count = count_of(c, o);
    const char *heading = NULL;
    int shown = 0;
    page csv, each;
    found *const all = calloc((size_t)count, sizeof *all);
    if (!all) return kit_fail(err, "out of memory");
    if (page_open(&csv, err) || page_open(&each, err)) return -1;
    for (int k = 0; k < count; ++k) {
        const int there = unit_of(c)(NULL, o, k, NULL, NULL);
        if (c->sets && there && heading != title_of(c, k))
            page_heading(each.file, 2, "%s", heading = title_of(c, k));
        const int rows = find(each.file, c, o, k, &all[k], err);
        const char *const kind = c->sets && set_of(c->sets, k)->kind ? set_of(c->sets, k)->kind : "rows";
        if (rows < 0 || (rows && c->sets && table_page(each.file, kind, all[k].row, rows, err))) return -1;
        if (rows && !c->write) table_csv(csv.file, all[k].row, rows, !shown++);
    }
    if (c->write) c->write(csv.file, o, all, count);
    for (int k = 0; k < count; ++k) free(all[k].row);
    free(all);
    if (c->title) page_heading(record, 2, "%s", c->title);
    if (c->head) c->head(record, o);
    if (!c->csv) {
        fclose(csv.file);
        free(csv.text);
    } else if (c->kind ? page_csv(record, c->kind, &csv, o->out, c->csv, err) : page_close(&csv, o->out, c->csv, err))
        return -1;
    page_into(&each, record);
    return 0;
}
