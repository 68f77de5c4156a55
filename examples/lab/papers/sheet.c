/* sheet.c - draws a paper's table or figure. Declared in sheet.h. */
#include "lab/papers/sheet.h"
#include <math.h>
#include <string.h>
#include "lab/chart/fields_stage.h"
#include "lab/measure/halved.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"

int sheet_rounds(const options *o) { return o->quick ? 1 : SHEET_ROUNDS; }

void sheet_blank(const sheet *t, row *rows)
{
    for (int i = 0; i < t->count; ++i)
        rows[i] = row_blank(OF_AO, t->paper, t->rows[i].what, t->rows[i].method ? t->rows[i].method : "",
                            t->rows[i].settings ? t->rows[i].settings : "");
}

/* ---- >>values ---------------------------------------------------------------------------------------------------- */

int sheet_heads(const sheet *t)
{
    int n = 0;
    while (n < MOST_HEADS && t->head[n]) ++n;
    return n;
}

int sheet_columns(const sheet *t)
{
    int n = 0;
    while (n < MOST_HEADS && t->column[n].head) ++n;
    return n;
}

/* The index of the column with a quantity, or -1. */
static int column_of(const sheet *t, quantity of)
{
    for (int c = 0; c < sheet_columns(t); ++c) if (t->column[c].of == (int)of) return c;
    return -1;
}

/* The overhead, by the times that the sheet also shows. */
static double overhead(const sheet *t, const row *rows, int i)
{
    const int base = t->rows[i].base - 1, ms = column_of(t, MILLISECONDS), shown = ms < 0 ? column_of(t, TIME) : ms;
    if (base < 0) return (double)NAN;
    return shown < 0 ? 100 * (rows[i].relative / rows[base].relative - 1)
                     : 100 * (sheet_value(t, rows, i, shown) / sheet_value(t, rows, base, shown) - 1);
}

static double measured(const sheet *t, const row *rows, int i, int of)
{
    const row *r = &rows[i];
    switch (of) {
    case TIME: return r->relative;
    case MILLISECONDS: return r->ms;
    case OVERHEAD: return overhead(t, rows, i);
    case ERROR: return isnan(r->error[1]) ? r->share : r->error[1];
    case BIAS: return isnan(r->bias[1]) ? r->score.bias : r->bias[1];
    case BOUNCE_ERROR: return r->error[2];
    case RADIANCE_ERROR: return r->error[0];
    case BOUNCE_NOISE: return r->split[SPLIT_BOUNCE];
    case NOISE: return r->split[SPLIT_NOISE];
    case MODEL_ERROR: return r->split[SPLIT_MODEL];
    case HUE: return r->split[SPLIT_HUE_IN_SHADE];
    case MEAN: return r->figure[LEVEL];
    case SURFELS_DRAWN: return r->figure[SURFELS];
    case RMSE: return r->score.rmse;
    case KILOBYTES: return r->figure[BYTES];
    case BAKE_SECONDS: return r->figure[SECONDS];
    default: return r->figure[STAGE + of - OWN];
    }
}

double sheet_value(const sheet *t, const row *rows, int i, int c)
{
    const double unit = pow(10, t->column[c].digits);
    return round(measured(t, rows, i, t->column[c].of) * unit) / unit;
}

double sheet_judged(const sheet *t, const claim *c, const row *rows)
{
    const double v = sheet_value(t, rows, c->row, c->column);
    return c->beside == ALONE ? v : v / sheet_value(t, rows, c->beside, c->column);
}

int sheet_timed(const sheet *t, int c)
{
    const int of = t->column[c].of;
    return of <= OVERHEAD || of >= BAKE_SECONDS;
}

int sheet_holds(const sheet *t, const claim *c, const row *rows)
{
    if (!(rows = sheet_judge(&t, c, rows))) return UNJUDGED;
    const double v = sheet_judged(t, c, rows);
    return isnan(v) ? UNKNOWN : v > c->least && v < c->most;
}

int sheet_own(claim *own, const sheet *t, const claim *c)
{
    const int ours = t->rows[c->row].ours, beside = c->beside == ALONE ? 0 : t->rows[c->beside].ours;
    *own = *c;
    if (ours) own->row = ours - 1;
    if (beside) own->beside = beside - 1;
    return ours || beside;
}

/* ---- >>pictures -------------------------------------------------------------------------------------------------- */

enum { SLUG = 96 };

/* The name of a sheet's picture number k. */
static void sheet_slug(char slug[SLUG], const sheet *t, int k)
{
    char name[64];
    snprintf(name, sizeof name, "papers %s %s", t->paper, t->name);
    pictures_slug(slug, name);
    snprintf(slug + strlen(slug), SLUG - strlen(slug), "-%d", k);
}

static int sheet_picture(FILE *record, const options *o, const sheet *t, const stage *s, const kit_image *picture,
                         int k, const char *label, const char *note, kit_error *err)
{
    char slug[SLUG];
    sheet_slug(slug, t, k);
    return pictures_thumb(record, o->out, slug, label, note, s, picture, err);
}

/* Shows a row's picture, with the row's first two columns below it. */
static int show_row(FILE *record, const options *o, const sheet *t, const stage *s, const kit_image *picture,
                    const row *rows, int i, kit_error *err)
{
    char note[96] = "";
    for (int c = 0; c < 2; ++c) {
        const double v = t->column[c].head ? sheet_value(t, rows, i, c) : (double)NAN;
        if (!isnan(v))
            snprintf(note + strlen(note), sizeof note - strlen(note), "%s%s %.*f", *note ? ", " : "",
                     t->column[c].head, t->column[c].digits, v);
    }
    return sheet_picture(record, o, t, s, picture, i + 1, t->rows[i].what, note, err);
}

/* The mean of ambient visibility, or of the bounce, over the pixels that show a surface. */
static double level_of(const kit_image *picture, const kit_image *frame)
{
    const float *z = kit_image_channel(frame, "Z"),
                *y = kit_image_channel(picture, picture->channels > 1 ? "bounce.G" : "Y");
    double sum = 0;
    size_t seen = 0;
    for (int i = 0; y && i < picture->width * picture->height; ++i)
        if (z[i] > 0) { sum += (double)y[i]; ++seen; }
    return seen ? sum / (double)seen : (double)NAN;
}

/* The rows of a group that are drawn, and their entries. */
typedef struct chosen { int at[MOST_PAPER_ROWS], count; entry entry[MOST_PAPER_ROWS]; } chosen;
enum { CROP_TIMES = 4 };

/* Close-ups of the truth, if it has every pixel, and of each row, at the crops of the light. */
static int draw_crops(FILE *record, const options *o, const sheet *t, const stage *s, const kit_image *picture,
                      const chosen *c, kit_error *err)
{
    const int gaps = s->stride > 1;
    pictured p[1 + MOST_PAPER_ROWS];
    for (int i = 0; i <= c->count; ++i) {
        p[i].label = i ? t->rows[c->at[i - 1]].what : "ray-traced";
        p[i].picture = i ? &picture[i - 1] : &s->truth;
        sheet_slug(p[i].slug, t, i ? c->at[i - 1] + 1 : 100);
    }
    for (int k = 0; k < MOST_CROPS && t->see.crop[k][2]; ++k) {
        int crop[4];
        for (int j = 0; j < 4; ++j) crop[j] = t->see.crop[k][j] / stage_thrift;
        if (pictures_crops(record, o->out, p + gaps, c->count + 1 - gaps, k, crop, s->lit->exposure, CROP_TIMES, err))
            return -1;
    }
    return 0;
}

void sheet_about(FILE *record, const stage *s)
{
    char truth[64] = "";
    if (s->truth.data)
        snprintf(truth, sizeof truth, "; truth: %d%s", s->rays,
                 s->otherwise.kind == SCATTER ? " thousand samples" : " rays a pixel");
    page_paragraph(record, "%zu triangles, %d x %d pixels, radius %g%s.", s->scene.mesh.triangles,
                   s->gbuffer.camera.width, s->gbuffer.camera.height, (double)s->radius, truth);
}

/* ---- >>drawing --------------------------------------------------------------------------------------------------- */

int sheet_open(stage *s, const sheet *t, const paper_row *first, kit_error *err)
{
    const int width = first->width ? first->width : t->width ? t->width : SHEET_WIDTH;
    const int height = first->height ? first->height : t->height ? t->height : SHEET_HEIGHT;
    const float reach = first->reach > 0 ? first->reach : 1;
    view seen = t->see;
    seen.between = t->drawn == FIELDS;
    if (stage_load(s, &seen, err)) return -1;
    s->stride = t->stride;
    if (t->rays) s->rays = t->rays;
    else if (!s->lit) s->rays = SHEET_RAYS;
    if (t->truth > 0) s->otherwise.hard = 1;
    if (t->drawn >= TIMES) return stage_look(s, &seen, width, height, err);
    const float own = seen.radius > 0 ? seen.radius : s->scene.radius;
    seen.radius = t->truth > 0 ? t->truth : own * reach;
    if (t->truth < 0) s->traced.reach = own * reach;
    if (stage_show(s, &seen, width, height, err)) return -1;
    s->radius = own * reach;
    return 0;
}

/* Chooses the rows of from .. to - 1 that are drawn. */
static chosen choose(const options *o, const sheet *t, int from, int to)
{
    chosen c = { .count = 0 };
    for (int i = from; i < to; ++i) {
        const paper_row *p = &t->rows[i];
        if (!p->method || (o->quick && p->slow)) continue;
        c.entry[c.count] = (entry){ p->what, p->method, p->settings, 1 };
        c.at[c.count++] = i;
    }
    return c;
}

static int measure(row *drawn, stage *s, const options *o, const sheet *t, const chosen *c, kit_image *picture,
                   kit_error *err)
{
    const int rounds = sheet_rounds(o), phases = o->quick && t->phases ? 2 : t->phases;
    sized each[MOST_PAPER_ROWS];
    for (int i = 0; i < c->count; ++i) each[i] = (sized){ c->entry[i], t->rows[c->at[i]].half };
    switch (t->drawn) {
    case FIELDS: return fields_measure(drawn, s, c->entry, c->count, picture, err);
    case HALVES: return halved_entries(drawn, s, each, c->count, rounds, picture, err);
    case PICTURES: return measure_entries(drawn, s, c->entry, c->count, rounds, phases, picture, err);
    default: return (s->lit && stage_light(s, err)) || measure_times(drawn, s, c->entry, c->count, rounds, err);
    }
}

/* Copies results into the sheet's rows and, if the sheet is pictured, shows the pictures on the page. */
static int show(FILE *record, const options *o, const sheet *t, const stage *s, const kit_image *picture,
                const row *drawn, const chosen *c, row *rows, kit_error *err)
{
    const int from = c->at[0];
    if (t->drawn < TIMES || !from) sheet_about(record, s);
    if (t->pictured && sheet_picture(record, o, t, s, &s->truth, 100 + from, "ray-traced", "", err)) return -1;
    for (int i = 0; i < c->count; ++i) {
        rows[c->at[i]] = drawn[i];
        if (picture[i].data) rows[c->at[i]].figure[LEVEL] = level_of(&picture[i], &s->frame);
        if (t->pictured && show_row(record, o, t, s, &picture[i], rows, c->at[i], err)) return -1;
    }
    return t->pictured > 1 ? draw_crops(record, o, t, s, picture, c, err) : 0;
}

/* Draws the rows from .. to - 1, which have one radius and one size. */
static int draw_group(FILE *record, const options *o, const sheet *t, int from, int to, row *rows, kit_error *err)
{
    const chosen c = choose(o, t, from, to);
    kit_image picture[MOST_PAPER_ROWS] = { { .data = NULL } };
    row drawn[MOST_PAPER_ROWS + 2];
    stage s;
    if (!c.count) return 0;
    if (sheet_open(&s, t, &t->rows[from], err) || measure(drawn, &s, o, t, &c, picture, err)
        || show(record, o, t, &s, picture, drawn, &c, rows, err))
        return -1;
    for (int i = 0; i < c.count; ++i) kit_image_free(&picture[i]);
    stage_close(&s);
    return 0;
}

static int alike(const paper_row *a, const paper_row *b) { return a->reach == b->reach && a->width == b->width; }

int sheet_draw(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    sheet_blank(t, rows);
    if (t->drawn > TIMES) return sheet_own_draw(record, o, t, rows, err);
    for (int from = 0, to; from < t->count; from = to) {
        for (to = from + 1; to < t->count && alike(&t->rows[to], &t->rows[from]);) ++to;
        if (draw_group(record, o, t, from, to, rows, err)) return -1;
    }
    return 0;
}
