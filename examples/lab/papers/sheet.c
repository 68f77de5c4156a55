/* sheet.c - what a paper's table or figure shows, drawn here. Declared in sheet.h. */
#include "lab/papers/sheet.h"
#include <math.h>
#include <string.h>
#include "lab/measure/halved.h"
#include "lab/page/page.h"
#include "lab/page/pictures.h"

int sheet_rounds(const options *o) { return o->quick ? 1 : SHEET_ROUNDS; }

int sheet_load(stage *s, const sheet *t, kit_error *err)
{
    if (deep_load(s, &t->see, err)) return -1;
    if (t->rays) s->rays = t->rays;
    else if (!s->lit) s->rays = SHEET_RAYS;
    s->stride = t->stride;
    if (t->truth > 0) s->otherwise.hard = 1;
    return 0;
}

/* ---- >>values ---------------------------------------------------------------------------------------------------- */

/* The column of what is shown, else -1. */
static int column_of(const sheet *t, quantity of)
{
    for (int c = 0; c < MOST_HEADS && t->column[c].head; ++c) if (t->column[c].of == (int)of) return c;
    return -1;
}

/* By the times that a reader has beside it. */
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
    const double a = sheet_value(t, rows, c->a, c->column);
    return c->b == ALONE ? a : a / sheet_value(t, rows, c->b, c->column);
}

int sheet_holds(const sheet *t, const claim *c, const row *rows)
{
    const double v = sheet_judged(t, c, rows);
    return isnan(v) ? -1 : v > c->least && v < c->most;
}

int sheet_own(claim *own, const sheet *t, const claim *c)
{
    const int a = t->rows[c->a].ours, b = c->b == ALONE ? 0 : t->rows[c->b].ours;
    *own = *c;
    if (a) own->a = a - 1;
    if (b) own->b = b - 1;
    return a || b;
}

/* ---- >>pictures -------------------------------------------------------------------------------------------------- */

enum { SLUG = 96 };

/* What picture number k of a sheet is called. */
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

/* A row's picture; under it its first two columns. */
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

/* The mean of ambient visibility, or of the bounce, where something is seen. */
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

enum { CROP_TIMES = 4 };

/* ---- >>drawing --------------------------------------------------------------------------------------------------- */

void sheet_blank(const sheet *t, row *rows)
{
    for (int i = 0; i < t->count; ++i)
        rows[i] = row_blank(OF_AO, t->paper, t->rows[i].what, t->rows[i].method ? t->rows[i].method : "",
                            t->rows[i].settings ? t->rows[i].settings : "");
}

int sheet_chosen(int *at, entry *entries, const options *o, const sheet *t, int from, int to)
{
    int count = 0;
    for (int i = from; i < to; ++i) {
        const paper_row *p = &t->rows[i];
        if (!p->method || (o->quick && p->slow)) continue;
        entries[count] = (entry){ p->what, p->method, p->settings ? p->settings : "", 1 };
        at[count++] = i;
    }
    return count;
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

/* Close-ups of the truth, where it has every pixel, and of each row, as the light names them. */
static int draw_crops(FILE *record, const options *o, const sheet *t, const stage *s, const kit_image *picture,
                      const int *at, int count, kit_error *err)
{
    const int gaps = s->stride > 1;
    pictured p[1 + MOST_PAPER_ROWS];
    for (int i = 0; i <= count; ++i) {
        p[i].label = i ? t->rows[at[i - 1]].what : "ray-traced";
        p[i].picture = i ? &picture[i - 1] : &s->truth;
        sheet_slug(p[i].slug, t, i ? at[i - 1] + 1 : 100);
    }
    for (int k = 0; k < MOST_CROPS && s->lit->crop[k][2]; ++k) {
        int crop[4];
        for (int j = 0; j < 4; ++j) crop[j] = s->lit->crop[k][j] / stage_thrift;
        if (pictures_crops(record, o->out, p + gaps, count + 1 - gaps, k, crop, s->lit->exposure, CROP_TIMES, err))
            return -1;
    }
    return 0;
}

int sheet_show(FILE *record, const options *o, const sheet *t, const stage *s, kit_image *picture, const row *drawn,
               const int *at, int count, row *rows, kit_error *err)
{
    if (t->pictured && sheet_picture(record, o, t, s, &s->truth, 100 + at[0], "ray-traced", "", err)) return -1;
    for (int i = 0; i < count; ++i) {
        rows[at[i]] = drawn[i];
        rows[at[i]].figure[LEVEL] = level_of(&picture[i], &s->frame);
        if (t->pictured && show_row(record, o, t, s, &picture[i], rows, at[i], err)) return -1;
    }
    if (t->pictured > 1 && draw_crops(record, o, t, s, picture, at, count, err)) return -1;
    for (int i = 0; i < count; ++i) kit_image_free(&picture[i]);
    return 0;
}

/* Rows from .. to - 1, which have one radius. */
static int draw_group(FILE *record, const options *o, const sheet *t, int from, int to, row *rows, kit_error *err)
{
    const float reach = t->rows[from].reach > 0 ? t->rows[from].reach : 1;
    int at[MOST_PAPER_ROWS];
    entry entries[MOST_PAPER_ROWS];
    kit_image picture[MOST_PAPER_ROWS];
    row drawn[MOST_PAPER_ROWS + 2];
    view seen = t->see.view;
    const int count = sheet_chosen(at, entries, o, t, from, to), phases = o->quick && t->phases ? 2 : t->phases;
    stage s;
    if (!count) return 0;
    if (sheet_load(&s, t, err)) return -1;
    const float own = seen.radius > 0 ? seen.radius : s.scene.radius;
    seen.radius = t->truth > 0 ? t->truth : own * reach;
    if (stage_show(&s, &seen, t->width ? t->width : SHEET_WIDTH, t->height ? t->height : SHEET_HEIGHT, err)) return -1;
    s.radius = own * reach;
    if (measure_entries(drawn, &s, entries, count, sheet_rounds(o), phases, picture, err)) return -1;
    sheet_about(record, &s);
    if (sheet_show(record, o, t, &s, picture, drawn, at, count, rows, err)) return -1;
    stage_close(&s);
    return 0;
}

int sheet_draw(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    sheet_blank(t, rows);
    for (int from = 0, to; from < t->count; from = to) {
        for (to = from + 1; to < t->count && t->rows[to].reach == t->rows[from].reach;) ++to;
        if (draw_group(record, o, t, from, to, rows, err)) return -1;
    }
    return 0;
}

int sheet_times(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    sheet_blank(t, rows);
    for (int from = 0, to; from < t->count; from = to) {
        int at[MOST_PAPER_ROWS];
        entry entries[MOST_PAPER_ROWS];
        row timed[MOST_PAPER_ROWS];
        stage s;
        for (to = from + 1; to < t->count && t->rows[to].width == t->rows[from].width;) ++to;
        const int count = sheet_chosen(at, entries, o, t, from, to);
        const int width = t->rows[from].width, height = t->rows[from].height;
        if (!count) continue;
        if (sheet_load(&s, t, err)
            || stage_look(&s, &t->see.view, width ? width : t->width, height ? height : t->height, err)
            || (s.lit && stage_light(&s, err)) || measure_times(timed, &s, entries, count, sheet_rounds(o), err))
            return -1;
        if (!from) sheet_about(record, &s);
        for (int i = 0; i < count; ++i) rows[at[i]] = timed[i];
        stage_close(&s);
    }
    return 0;
}

int sheet_halves(FILE *record, const options *o, const sheet *t, row *rows, kit_error *err)
{
    int at[MOST_PAPER_ROWS];
    entry chosen[MOST_PAPER_ROWS];
    sized entries[MOST_PAPER_ROWS];
    const int count = sheet_chosen(at, chosen, o, t, 0, t->count);
    kit_image picture[MOST_PAPER_ROWS];
    row drawn[MOST_PAPER_ROWS];
    stage s;
    sheet_blank(t, rows);
    for (int i = 0; i < count; ++i) entries[i] = (sized){ chosen[i], t->rows[at[i]].half };
    if (sheet_load(&s, t, err) || stage_show(&s, &t->see.view, SHEET_WIDTH, HALVED_HEIGHT, err)
        || halved_entries(drawn, &s, entries, count, sheet_rounds(o), picture, err))
        return -1;
    sheet_about(record, &s);
    if (sheet_show(record, o, t, &s, picture, drawn, at, count, rows, err)) return -1;
    stage_close(&s);
    return 0;
}
