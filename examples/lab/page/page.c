/* page.c - what report.c and stability.c write: text tables, CSV, SVG charts, HTML. Declared in page.h. */
#include "lab/page/page.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "kit/kit_gl.h"

/* ---- >>text: a page grows in memory and reaches the disk whole, or not at all ------------------------------------ */

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

/* A command's first line, without its end; "" if there is none. */
static void line_of(char *out, int size, const char *command)
{
    FILE *f = popen(command, "r");
    if (!f || !fgets(out, size, f)) *out = 0;
    if (f) pclose(f);
    out[strcspn(out, "\n")] = 0;
}

int run_note(const char *folder, const char *name, const char *kind, const char *command, kit_error *err)
{
    char commit[64], changed[64], processor[128];
    page p;
    line_of(commit, sizeof commit, "git log -1 --format=%h 2>/dev/null");
    line_of(changed, sizeof changed, "git status --porcelain -- ssgi.h ssgi_gl.h examples/kit 2>/dev/null");
    line_of(processor, sizeof processor, "sed -n 's/^model name[^:]*: //p' /proc/cpuinfo");
    if (page_open(&p, err)) return -1;
    fprintf(p.file, "%s\n`%s`, commit %s%s, %ld cores (%s), %s\n", kind, command, *commit ? commit : "unknown",
            *changed ? " with changes" : "", sysconf(_SC_NPROCESSORS_ONLN), *processor ? processor : "unknown",
            kit_gl_name());
    return page_close(&p, folder, name, err);
}

void page_into(page *p, FILE *f)
{
    fclose(p->file);
    fwrite(p->text, 1, p->size, f);
    free(p->text);
}

void escaped(FILE *f, const char *s)
{
    for (; *s; ++s) {
        const char *entity = *s == '&'   ? "&amp;"
                             : *s == '<' ? "&lt;"
                             : *s == '>' ? "&gt;"
                             : *s == '"' ? "&quot;"
                                         : NULL;
        if (entity) fputs(entity, f); else fputc(*s, f);
    }
}

const char *settings_of(const row *r) { return *r->settings ? r->settings : isnan(r->fetches) ? "" : "defaults"; }

/* ---- >>tables: one list of columns for text, HTML and CSV -------------------------------------------------------- */

typedef struct column { int of; const char *head, *key, *about; size_t offset; int digits, sign; } column;
static const column columns[] = {
    { OF_BAKE, "triangles", "triangles", "of the occluder", offsetof(row, figure[TRIANGLES]), 0, 0 },
    { OF_BAKE, "texels", "resolution", "along the side of a face of the cube map", offsetof(row, figure[RESOLUTION]), 0,
      0 },
    { OF_BAKE, "radii", "radii", "distances sampled along each direction", offsetof(row, figure[RADII]), 0, 0 },
    { OF_BAKE, "rays", "rays", "a sample", offsetof(row, figure[BAKE_RAYS]), 0, 0 },
    { OF_BAKE, "threads", "threads", "of the bake", offsetof(row, figure[THREADS]), 0, 0 },
    { OF_FIELD | OF_BAKE, "kB", "kilobytes", "of all fields, 1000 bytes each", offsetof(row, figure[BYTES]), 1, 0 },
    { OF_BAKE, "work, MB", "work_megabytes", "memory of the bake, free again afterwards", offsetof(row, figure[WORK]),
      1, 0 },
    { OF_FIELD | OF_BAKE, "bake, s", "bake_seconds", "the clock's, of all fields' bakes",
      offsetof(row, figure[SECONDS]), 2, 0 },
    { OF_FIELD | OF_BAKE, "b. median", "baked_median",
      "error of occlusion that the bake reports, at receivers that took no part in it: half are off by less; of "
      "several fields the worst",
      offsetof(row, figure[BAKED_MEDIAN]), 4, 0 },
    { OF_FIELD | OF_BAKE, "b. p95", "baked_p95", "the same: 95 % of them", offsetof(row, figure[BAKED_P95]), 4, 0 },
    { OF_FIELD | OF_BAKE, "b. most", "baked_most", "the same: all of them", offsetof(row, figure[BAKED_MOST]), 4, 0 },
    { OF_COST, "covered", "covered", "pixels within an occluder's reach over all pixels, summed over the occluders",
      offsetof(row, figure[COVERED]), 3, 0 },
    { OF_GROWTH | OF_STAGES, "pixels", "pixels_thousands", "of the picture, thousands", offsetof(row, figure[PICTURE]),
      1, 0 },
    { OF_DEEP | OF_DEEP_LIT | OF_GROWTH | OF_STAGES, "surfels", "surfels", "how many discs the triangles became",
      offsetof(row, figure[SURFELS]), 0, 0 },
    { OF_DEEP | OF_DEEP_LIT | OF_GROWTH | OF_STAGES, "splats", "splat_pixels",
      "texels that splats cover at all levels, over the picture's pixels; predicted", offsetof(row, figure[SPLATS]), 1,
      0 },
    { OF_TURN, "degrees", "degrees", "that the camera has turned away", offsetof(row, figure[DEGREES]), 1, 0 },
    { OF_AO | OF_LIT | OF_SPLIT, "fetches", "fetches", "texel fetches per pixel, all passes", offsetof(row, fetches), 1,
      0 },
    { OF_AO | OF_LIT | OF_SPLIT | OF_COST | OF_DEEP | OF_DEEP_LIT | OF_GROWTH, "bytes", "bytes",
      "moved per pixel, all passes, each texel of a pass's inputs and outputs once", offsetof(row, bytes), 0, 0 },
    { OF_AO | OF_LIT | OF_SPLIT | OF_COST | OF_DEEP | OF_DEEP_LIT | OF_GROWTH | OF_STAGES, "time", "relative_time",
      "GL time relative to one unblurred 16-sample ssao", offsetof(row, relative), 2, 0 },
    { OF_AO | OF_LIT | OF_SPLIT | OF_COST | OF_DEEP | OF_DEEP_LIT | OF_GROWTH | OF_STAGES, "ms", "ms",
      "GL time, milliseconds", offsetof(row, ms), 1, 0 },
    { OF_FIELD, "median", "median", "half of the pixels are off by less", offsetof(row, figure[MEDIAN]), 4, 0 },
    { OF_AO | OF_FIELD | OF_DEEP | OF_TURN, "RMSE", "rmse", "root mean square difference to the truth",
      offsetof(row, score.rmse), 4, 0 },
    { OF_AO | OF_FIELD | OF_DEEP | OF_TURN, "share", "share", "RMSE over the RMSE of having no AO",
      offsetof(row, share), 3, 0 },
    { OF_PEER, "fitted", "share_fitted", "the share after the best fit of two numbers to this picture",
      offsetof(row, figure[FITTED]), 3, 0 },
    { OF_AO | OF_FIELD | OF_DEEP | OF_TURN, "bias", "bias", "mean difference to the truth; below 0: too dark",
      offsetof(row, score.bias), 4, 1 },
    { OF_AO | OF_FIELD | OF_DEEP, "p95", "p95", "95 % of the pixels are off by less", offsetof(row, score.p95), 4, 0 },
    { OF_PHASES, "model", "model_error",
      "RMSE of the mean over the phases of the noise, less what noise that still has", offsetof(row, split[1]), 4, 0 },
    { OF_PHASES, "noise", "noise", "root of a pixel's variance over the phases of the noise, its mean over the pixels",
      offsetof(row, split[2]), 4, 0 },
    { OF_FIELD, "most", "most", "the worst pixel", offsetof(row, figure[MOST]), 3, 0 },
    { OF_PAIR, "product", "product", "RMSE of 1 - (1 - a)(1 - b), a and b being the two occluders' occlusions",
      offsetof(row, figure[BY_PRODUCT]), 4, 0 },
    { OF_PAIR, "max", "max_of_two", "RMSE of the larger one", offsetof(row, figure[BY_MOST]), 4, 0 },
    { OF_PAIR, "sum", "sum_of_two", "RMSE of the sum, at most 1", offsetof(row, figure[BY_SUM]), 4, 0 },
    { OF_PAIR, "between", "between", "share of the pixels whose true occlusion lies from the larger one to the sum",
      offsetof(row, figure[BETWEEN]), 3, 0 },
    { OF_LIT | OF_DEEP_LIT, "radiance", "radiance", "RMSE of outgoing radiance over the truth's mean",
      offsetof(row, error[0]), 4, 0 },
    { OF_LIT | OF_DEEP_LIT, "bias", "radiance_bias", "mean difference of radiance over the truth's mean",
      offsetof(row, bias[0]), 4, 1 },
    { OF_LIT | OF_DEEP_LIT, "irradiance", "irradiance", "RMSE of irradiance over the truth's mean",
      offsetof(row, error[1]), 4, 0 },
    { OF_LIT | OF_DEEP_LIT, "bias", "irradiance_bias", "mean difference of irradiance over the truth's mean",
      offsetof(row, bias[1]), 4, 1 },
    { OF_LIT | OF_DEEP_LIT, "bounce", "bounce", "RMSE of the bounce over the truth's mean bounce",
      offsetof(row, error[2]), 3, 0 },
    { OF_LIT | OF_DEEP_LIT, "bias", "bounce_bias", "mean difference of the bounce over the truth's mean bounce",
      offsetof(row, bias[2]), 3, 1 },
    { OF_STAGES, "surfels", "share_surfels", "share of the time: made and captured, lit",
      offsetof(row, figure[STAGE + 0]), 3, 0 },
    { OF_STAGES, "shuffle", "share_shuffle", "share of the time: positions and normals dealt out to all levels",
      offsetof(row, figure[STAGE + 1]), 3, 0 },
    { OF_STAGES, "splat", "share_splat", "share of the time: of all effects", offsetof(row, figure[STAGE + 2]), 3, 0 },
    { OF_STAGES, "unshuffle", "share_unshuffle", "share of the time: pixels back in place",
      offsetof(row, figure[STAGE + 3]), 3, 0 },
    { OF_STAGES, "smooth", "share_smooth", "share of the time: both axes", offsetof(row, figure[STAGE + 4]), 3, 0 },
    { OF_STAGES, "sum", "share_sum", "share of the time: of the levels", offsetof(row, figure[STAGE + 5]), 3, 0 },
    { OF_STAGES, "light", "share_light", "share of the time: the lights on what is seen",
      offsetof(row, figure[STAGE + 6]), 3, 0 },
    { OF_MOTION, "varies", "varies",
      "standard deviation of a place's ambient visibility over the frames, RMS over the places",
      offsetof(row, figure[FLICKER]), 4, 0 },
    { OF_MOTION, "truth's", "varies_true", "the same of the truth: pixels fall elsewhere",
      offsetof(row, figure[FLICKER_TRUE]), 4, 0 },
    { OF_MOTION, "added", "varies_added", "root of the difference of their squares",
      offsetof(row, figure[FLICKER_ADDED]), 4, 0 },
    { OF_SPLIT, "irradiance", "irradiance_phases",
      "RMSE of irradiance over the truth's mean, over all phases of the noise", offsetof(row, split[0]), 4, 0 },
    { OF_SPLIT, "bias error", "irradiance_bias_error",
      "RMSE of the mean over the phases of the noise, less what noise that still has", offsetof(row, split[1]), 4, 0 },
    { OF_SPLIT, "noise", "irradiance_noise",
      "root of a pixel's variance over the phases of the noise, its mean over the pixels", offsetof(row, split[2]), 4,
      0 },
    { OF_SPLIT, "hue, deg", "hue_degrees",
      "mean angle between the rgb of the mean picture and of the truth, weighted by the truth's luminance",
      offsetof(row, split[3]), 2, 0 },
    { OF_SPLIT, "in shade", "hue_in_shade_degrees",
      "the same over pixels that blockers keep 5 % or more of their light from", offsetof(row, split[4]), 2, 0 },
    { OF_PLACES, "edge", "edge_error", "share of the squared error within 3 pixels of a jump in depth",
      offsetof(row, figure[PLACE_ERROR + 0]), 3, 0 },
    { OF_PLACES, NULL, "edge_pixels", "share of the pixels", offsetof(row, figure[PLACE_AREA + 0]), 3, 0 },
    { OF_PLACES, NULL, "edge_rmse", "RMSE there", offsetof(row, figure[PLACE_RMSE + 0]), 4, 0 },
    { OF_PLACES, NULL, "edge_bias", "bias there", offsetof(row, figure[PLACE_BIAS + 0]), 4, 1 },
    { OF_PLACES, "border", "border_error",
      "share of the squared error elsewhere, nearer to the border than the radius is long",
      offsetof(row, figure[PLACE_ERROR + 1]), 3, 0 },
    { OF_PLACES, NULL, "border_pixels", "share of the pixels", offsetof(row, figure[PLACE_AREA + 1]), 3, 0 },
    { OF_PLACES, NULL, "border_rmse", "RMSE there", offsetof(row, figure[PLACE_RMSE + 1]), 4, 0 },
    { OF_PLACES, NULL, "border_bias", "bias there", offsetof(row, figure[PLACE_BIAS + 1]), 4, 1 },
    { OF_PLACES, "inside", "interior_error", "share of the squared error of what is left",
      offsetof(row, figure[PLACE_ERROR + 2]), 3, 0 },
    { OF_PLACES, NULL, "interior_pixels", "share of the pixels", offsetof(row, figure[PLACE_AREA + 2]), 3, 0 },
    { OF_PLACES, NULL, "interior_rmse", "RMSE there", offsetof(row, figure[PLACE_RMSE + 2]), 4, 0 },
    { OF_PLACES, NULL, "interior_bias", "bias there", offsetof(row, figure[PLACE_BIAS + 2]), 4, 1 },
    { OF_AO | OF_LIT | OF_DEEP, "SSIM", "ssim", "structural similarity with the truth, 1 = the same",
      offsetof(row, score.ssim), 4, 0 }
};

/* The next column after c (-1: the first) that is of one of these kinds; -1 past the last. A software rasteriser's
   milliseconds would mislead. Those without a head are in CSV alone. */
static int next_key(int c, int of)
{
    while (++c < (int)(sizeof columns / sizeof columns[0]))
        if (columns[c].of & of && !(columns[c].offset == offsetof(row, ms) && kit_gl_is_software())) return c;
    return -1;
}

static int next_column(int c, int of)
{
    do c = next_key(c, of); while (c >= 0 && !columns[c].head);
    return c;
}

static double figure_of(const row *r, int c)
{
    double v;
    memcpy(&v, (const char *)r + columns[c].offset, sizeof v);
    return v;
}

static const char *cell(char out[32], const row *r, int c, const char *none)
{
    double v = figure_of(r, c);
    if (isnan(v)) return none;
    snprintf(out, 32, columns[c].sign ? "%+.*f" : "%.*f", columns[c].digits, v);
    return out;
}

void table_text(FILE *f, const row *rows, int count)
{
    int label = 6, settings = 8;
    char text[32];
    for (int i = 0; i < count; ++i) {
        int l = (int)strlen(rows[i].label), s = (int)strlen(settings_of(&rows[i]));
        if (l > label) label = l;
        if (s > settings) settings = s;
    }
    fprintf(f, "%-*s  %-*s", label, "method", settings, "settings");
    for (int c = -1; (c = next_column(c, rows->of)) >= 0;) fprintf(f, " %10s", columns[c].head);
    fputc('\n', f);
    for (int i = 0; i < count; ++i) {
        fprintf(f, "%-*s  %-*s", label, rows[i].label, settings, settings_of(&rows[i]));
        for (int c = -1; (c = next_column(c, rows->of)) >= 0;) fprintf(f, " %10s", cell(text, &rows[i], c, "-"));
        fputc('\n', f);
    }
}

void table_html(FILE *f, const row *rows, int count)
{
    char text[32];
    fputs("<div class=\"wide\"><table>\n<tr><th>method<th>settings", f);
    for (int c = -1; (c = next_column(c, rows->of)) >= 0;)
        fprintf(f, "<th title=\"%s\">%s", columns[c].about, columns[c].head);
    fputs("\n", f);
    for (int i = 0; i < count; ++i) {
        fprintf(f, i && strcmp(rows[i].label, rows[i - 1].label) ? "<tr class=\"first\"><td>" : "<tr><td>");
        escaped(f, rows[i].label);
        fputs("<td><code>", f);
        escaped(f, settings_of(&rows[i]));
        fputs("</code>", f);
        for (int c = -1; (c = next_column(c, rows->of)) >= 0;) fprintf(f, "<td>%s", cell(text, &rows[i], c, "&ndash;"));
        fputs("\n", f);
    }
    fputs("</table></div>\n", f);
}

static void csv_field(FILE *f, const char *s)
{
    fputc('"', f);
    for (; *s; ++s) { if (*s == '"') fputc('"', f); fputc(*s, f); }
    fputc('"', f);
}

void table_csv(FILE *f, const row *rows, int count, int head)
{
    /* all that is lit makes one table, all of fields another, all of deep screen space a third */
    const int of = rows->of & OF_AO       ? OF_PHASES | (rows->of & (OF_AO | OF_PEER))
                   : rows->of & OF_FIELDS ? OF_FIELDS
                   : rows->of & OF_DEEPS  ? OF_DEEPS
                                          : OF_LIT | OF_SPLIT;
    if (head) {
        fputs("scene,label,method,settings", f);
        for (int c = -1; (c = next_key(c, of)) >= 0;) fprintf(f, ",%s", columns[c].key);
        fputs(",pixels\n", f);
    }
    for (int i = 0; i < count; ++i) {
        const char *const names[] = { rows[i].scene, rows[i].label, rows[i].method, rows[i].settings };
        for (int k = 0; k < 4; ++k) { if (k) fputc(',', f); csv_field(f, names[k]); }
        for (int c = -1; (c = next_key(c, of)) >= 0;) {
            double v = figure_of(&rows[i], c);
            if (isnan(v)) fputc(',', f); else fprintf(f, ",%.6g", v);
        }
        fprintf(f, ",%zu\n", rows[i].score.pixels);
    }
}

/* ---- >>chart: relative time (or memory) across, share of the error (or the error) up; one curve a label ---------- */

typedef struct box { double x, y, w, h; } box;

enum { MOST_BOXES = 512 };
/* Okabe and Ito's palette, told apart by colour-blind eyes too; orange and sky are left for curves five and six. */
static const char *const colours[] = { "#0072B2", "#D55E00", "#009E73", "#CC79A7", "#B07A00", "#3A9BD9" };
enum { NOBODY = 1 << 30 };
static int others = NOBODY;                          /* curves from this one on are other people's, fitted: grey */

const char *colour_of(int series)
{
    return series < others ? colours[series % (int)(sizeof colours / sizeof colours[0])] : "#77777f";
}

double across(const scale *s, double v)
{
    return LEFT + (RIGHT - LEFT) * ((s->even ? v : log(v)) - s->x0) / (s->x1 - s->x0);
}
double up(const scale *s, double v) { return BOTTOM - (BOTTOM - TOP) * (v - s->y0) / (s->y1 - s->y0); }

void marker(FILE *f, int series, double x, double y)
{
    fprintf(f, "fill=\"%s\" stroke=\"#fff\" stroke-width=\"1.5\"", colour_of(series));
    if (series % 4 == 0) fprintf(f, " d=\"M%.1f %.1fa5.5 5.5 0 1 0 11 0a5.5 5.5 0 1 0 -11 0z\"", x - 5.5, y);
    if (series % 4 == 1) fprintf(f, " d=\"M%.1f %.1fh10v10h-10z\"", x - 5, y - 5);
    if (series % 4 == 2) fprintf(f, " d=\"M%.1f %.1fl6.5 11.5h-13z\"", x, y - 7);
    if (series % 4 == 3) fprintf(f, " d=\"M%.1f %.1fl7 7l-7 7l-7 -7z\"", x, y - 7);
}

static double covered(const box *b, const box *taken, int count)
{
    double sum = 0;
    for (const box *t = taken; t < taken + count; ++t) {
        double w = fmin(b->x + b->w, t->x + t->w) - fmax(b->x, t->x),
               h = fmin(b->y + b->h, t->y + t->h) - fmax(b->y, t->y);
        if (w > 0 && h > 0) sum += w * h;
    }
    return sum;
}

/* The place beside a point where its label covers least of what is there already. */
static box place(double x, double y, double w, const box *taken, int count)
{
    static const double offset[8][2] = { { 0, -15 }, { 0, 15 },   { 1, 0 },  { -1, 0 },
                                         { 1, -11 }, { -1, -11 }, { 1, 11 }, { -1, 11 } };
    box best = { 0, 0, 0, 0 };
    double least = HUGE_VAL;
    for (int k = 0; k < 8; ++k) {
        box b = { x - w / 2 + offset[k][0] * (w / 2 + (k < 4 ? 10 : 5)), y + offset[k][1] - 6, w, 12 };
        double cost = 2.0 * k;
        if (b.x < LEFT || b.x + b.w > RIGHT || b.y < TOP || b.y + b.h > BOTTOM) cost += 1000;
        cost += covered(&b, taken, count);
        if (cost < least) { least = cost; best = b; }
    }
    return best;
}

static int by_relative(const void *a, const void *b)
{
    double x = (*(const row *const *)a)->relative, y = (*(const row *const *)b)->relative;
    return (x > y) - (x < y);
}

double step_of(double least, double span)     /* 1, 2 or 5 times a power of ten: at most six lines in span */
{
    double s = least;
    for (int i = 0; span / s > 5; ++i) s *= i % 3 == 1 ? 2.5 : 2;
    return s;
}

const words ao_words = {
    "left is faster, down is closer to the truth; numbers: texel fetches per pixel; grey band: nothing beats these",
    "GL time relative to one unblurred 16-sample SSAO (log scale)",
    "error (RMSE), share of having no AO at all",
    "time",
    "fetches",
    0
};
const words lit_words = {
    "left is faster, down is closer to the truth; numbers: texel fetches per pixel; grey band: nothing beats these",
    "GL time relative to one unblurred 16-sample SSAO (log scale)",
    "error (RMSE), share of the truth's mean radiance",
    "time",
    "fetches",
    0
};
const words turn_words = { "down is closer to the truth; 1 is as far off as no ambient occlusion at all",
                           "degrees that the camera has turned away from what occludes",
                           "error (RMSE) on the same ground, share of having no AO at all",
                           "degrees",
                           NULL,
                           1 };
const words field_words = { "left is smaller, down is closer to the truth; numbers: texels along a side of the cube "
                            "map; grey band: nothing beats these",
                            "bytes of the field, thousands (log scale)",
                            "RMSE of occlusion, hundredths",
                            "kB",
                            "texels a side",
                            0 };

void chart_svg(FILE *f, const char *title, const words *w, const row *rows, int count, double floor_)
{
    static const double ticks[] = { 1, 1.5, 2, 3, 5, 7 };
    const row *sorted[256];
    box taken[MOST_BOXES];
    scale s = { HUGE_VAL, -HUGE_VAL, HUGE_VAL, -HUGE_VAL, w->even };
    int points = 0, boxes = 0, series = 0, at = 0, legend = LEFT, line = 76;
    double step, last = -100;
    for (int i = 0; i < count && points < 256; ++i) {
        if (isnan(rows[i].relative)) continue;
        sorted[points++] = &rows[i];
        s.x0 = fmin(s.x0, rows[i].relative); s.x1 = fmax(s.x1, rows[i].relative);
        s.y0 = fmin(s.y0, rows[i].share); s.y1 = fmax(s.y1, rows[i].share);
    }
    const double every = w->even ? step_of(1, s.x1 - s.x0) : 0, room_ = 0.04 * (s.x1 - s.x0);
    s.x0 = s.even ? s.x0 - room_ : log(s.x0 * 0.87); s.x1 = s.even ? s.x1 + room_ : log(s.x1 * 1.15);
    if (!isnan(floor_)) { s.y0 = fmin(s.y0, floor_); s.y1 = fmax(s.y1, floor_); }
    if (s.y0 < 0.35 * s.y1) s.y0 = 0;
    step = step_of(0.01, s.y1 - s.y0);
    s.y0 = fmax(0, step * floor(s.y0 / step - 0.25));
    s.y1 = step * ceil(s.y1 / step + 0.2);

    fprintf(f,
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\" role=\"img\" "
            "font-family=\"system-ui, -apple-system, 'Segoe UI', 'DejaVu Sans', sans-serif\" font-size=\"13\" "
            "fill=\"#444\">\n<title>",
            WIDE, HIGH, WIDE, HIGH);
    escaped(f, title);
    fprintf(f,
            "</title>\n<rect width=\"%d\" height=\"%d\" rx=\"6\" fill=\"#fff\"/>\n<text x=\"%d\" y=\"32\" "
            "font-size=\"17\" font-weight=\"600\" fill=\"#111\">",
            WIDE, HIGH, LEFT);
    escaped(f, title);
    fprintf(f, "</text>\n<text x=\"%d\" y=\"54\">%s</text>\n", LEFT, w->about);
    for (double v = s.y0; v < s.y1 + step / 2; v += step)
        fprintf(f, "<path d=\"M%d %.1fH%d\" stroke=\"%s\"/><text x=\"%d\" y=\"%.1f\" text-anchor=\"end\">%.*f</text>\n",
                LEFT, up(&s, v), RIGHT, v > s.y0 ? "#e4e4e4" : "#888", LEFT - 9, up(&s, v) + 4.5, step < 0.095 ? 2 : 1,
                v);
    for (double v = every * ceil(s.x0 / fmax(every, 1)); s.even && v < s.x1; v += every)
        fprintf(f,
                "<path d=\"M%.1f %dV%d\" stroke=\"#eeeeee\"/><text x=\"%.1f\" y=\"%d\" "
                "text-anchor=\"middle\">%g</text>\n",
                across(&s, v), TOP, BOTTOM, across(&s, v), BOTTOM + 20, fabs(v) < 1e-9 ? 0 : v);
    for (int power = -3; power < 4 && !s.even; ++power)
        for (int k = 0; k < 6; ++k) {
            double v = ticks[k] * pow(10, power), x;
            if (log(v) < s.x0 || log(v) > s.x1) continue;
            x = across(&s, v);
            fprintf(f, "<path d=\"M%.1f %dV%d\" stroke=\"%s\"/>", x, TOP, BOTTOM,
                    fabs(v - 1) < 1e-9 ? "#b0b0b0" : "#eeeeee");
            if (x - last > 36) {
                fprintf(f, "<text x=\"%.1f\" y=\"%d\" text-anchor=\"middle\">%g</text>\n", x, BOTTOM + 20, v);
                last = x;
            }
        }
    fprintf(f, "<text x=\"%d\" y=\"%d\" text-anchor=\"middle\">%s</text>\n", (LEFT + RIGHT) / 2, BOTTOM + 46,
            w->across);
    fprintf(f, "<text transform=\"translate(24 %d) rotate(-90)\" text-anchor=\"middle\">%s</text>\n",
            (TOP + BOTTOM) / 2, w->up);
    if (!isnan(floor_)) {
        fprintf(f, "<path d=\"M%d %.1fH%d\" stroke=\"#333\" stroke-width=\"1.5\" stroke-dasharray=\"7 5\"/>\n", LEFT,
                up(&s, floor_), RIGHT);
        taken[boxes++] = (box){ LEFT, up(&s, floor_) - 1.5, RIGHT - LEFT, 3 };
    }

    if (!s.even) {                       /* the Pareto front: what no other point beats */
        const row *front[256];
        double least = HUGE_VAL;
        memcpy(front, sorted, (size_t)points * sizeof *front);
        qsort(front, (size_t)points, sizeof *front, by_relative);
        fputs("<path fill=\"none\" stroke=\"#dedede\" stroke-width=\"15\" stroke-linejoin=\"round\" "
              "stroke-linecap=\"round\" d=\"",
              f);
        for (int i = 0; i < points; ++i) {
            if (!(front[i]->share < least)) continue;
            fprintf(f, "%c%.1f %.1f", least < HUGE_VAL ? 'L' : 'M', across(&s, front[i]->relative),
                    up(&s, front[i]->share));
            least = front[i]->share;
        }
        fputs("\"/>\n", f);
    }
    /* Curves, and the boxes of markers and lines for the labels to avoid; then markers with tooltips; then labels. */
    for (int i = 0; i < points; i = at, ++series) {
        for (at = i; at < points && !strcmp(sorted[at]->label, sorted[i]->label);) ++at;
        qsort(sorted + i, (size_t)(at - i), sizeof *sorted, by_relative);
        if (!series || !(sorted[i]->of & OF_PEER) || isnan(sorted[i]->figure[FITTED])) others = series + 1;
        fprintf(f, "<path fill=\"none\" stroke-width=\"2.5\" stroke-linejoin=\"round\" stroke=\"%s\"%s d=\"",
            colour_of(series), series < others ? "" : " stroke-dasharray=\"6 4\"");
        for (int k = i; k < at; ++k) {
            double x = across(&s, sorted[k]->relative), y = up(&s, sorted[k]->share);
            fprintf(f, "%c%.1f %.1f", k > i ? 'L' : 'M', x, y);
            if (boxes < MOST_BOXES) taken[boxes++] = (box){ x - 8, y - 8, 16, 16 };
            for (int j = 1; k > i && j < 12 && boxes < MOST_BOXES; ++j) {
                double x0 = across(&s, sorted[k - 1]->relative), y0 = up(&s, sorted[k - 1]->share), t = j / 12.0;
                taken[boxes++] = (box){ x0 + (x - x0) * t - 3, y0 + (y - y0) * t - 3, 6, 6 };
            }
        }
        const char *fitted = series < others ? "" : ", fitted";
        const int room = 32 + (int)(6.8 * (double)(strlen(sorted[i]->label) + strlen(fitted)));
        if (legend > LEFT && legend + room > RIGHT) { legend = LEFT; line += 17; }
        fputs("\"/>\n<path ", f);
        marker(f, series, legend + 7, line);
        fprintf(f, "/><text x=\"%d\" y=\"%.1f\" fill=\"#222\">", legend + 21, line + 4.5);
        escaped(f, sorted[i]->label);
        fprintf(f, "%s</text>\n", fitted);
        legend += room;
    }
    if (!isnan(floor_)) {                /* its words: above or below, where along the line they cover least */
        box best = { 0, 0, 0, 0 };
        double least = HUGE_VAL;
        for (int k = 0; k < 40; ++k) {
            box b = { RIGHT - 412 - (k / 2) * (RIGHT - LEFT - 412) / 19.0, up(&s, floor_) + (k % 2 ? 5 : -21), 412,
                      16 };
            double cost = covered(&b, taken, boxes) + k + (b.y < TOP || b.y + b.h > BOTTOM ? 1e5 : 0);
            if (cost < least) { least = cost; best = b; }
        }
        fprintf(f,
                "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" fill=\"#222\" stroke=\"#fff\" stroke-width=\"3\" "
                "paint-order=\"stroke\">floor %.3f: exact answer from one depth layer, as thin sheets</text>\n",
                best.x + best.w / 2, best.y + 12.5, floor_);
        if (boxes < MOST_BOXES) taken[boxes++] = best;
    }
    for (int pass = 0; pass < 2; ++pass)
        for (int i = 0, group = 0; i < points; ++i) {
            const row *r = sorted[i];
            double x = across(&s, r->relative), y = up(&s, r->share);
            char text[32];
            if (i && strcmp(r->label, sorted[i - 1]->label)) ++group;
            if (!pass) {
                fputs("<path ", f);
                marker(f, group, x, y);
                fputs("><title>", f);
                escaped(f, r->label);
                fputs(": ", f);
                escaped(f, settings_of(r));
                fprintf(f, "\n%s %.2f, error %.3f", w->relative, r->relative, r->share);
                if (w->fetches) fprintf(f, ", %.1f %s", r->fetches, w->fetches);
                fputs("</title></path>\n", f);
            } else if (w->fetches) {
                int n = snprintf(text, sizeof text, r->fetches < 100 ? "%.3g" : "%.0f", r->fetches);
                box b = place(x, y, 7.2 * n, taken, boxes);
                fprintf(f,
                        "<text x=\"%.1f\" y=\"%.1f\" text-anchor=\"middle\" font-size=\"12\" fill=\"%s\" "
                        "stroke=\"#fff\" stroke-width=\"3\" paint-order=\"stroke\">%s</text>\n",
                        b.x + b.w / 2, b.y + 10.5, colour_of(group), text);
                if (boxes < MOST_BOXES) taken[boxes++] = b;
            }
        }
    others = NOBODY;
    fputs("</svg>\n", f);
}

/* ---- >>html ------------------------------------------------------------------------------------------------------ */

void html_head(FILE *f, const char *title, const char *about)
{
    fputs("<!doctype html>\n<html lang=\"en\">\n<meta charset=\"utf-8\">\n<meta name=\"viewport\" "
          "content=\"width=device-width, initial-scale=1\">\n<meta name=\"color-scheme\" content=\"light "
          "dark\">\n<title>",
          f);
    escaped(f, title);
    fputs("</title>\n<style>\n"
          ":root { --ink: #1c1c1e; --faint: #62626a; --paper: #fbfbfa; --line: #dededb; --panel: #fff }\n"
          "@media (prefers-color-scheme: dark) { :root { --ink: #e8e8e6; --faint: #a0a0a6; --paper: #17181a; --line: "
          "#35363a; --panel: #202124 } }\n"
          "* { box-sizing: border-box }\n"
          "body { margin: 0 auto; padding: 2rem clamp(1rem, 3vw, 3rem) 4rem; max-width: 1680px; color: var(--ink); "
          "background: var(--paper); font: 16px/1.5 system-ui, -apple-system, 'Segoe UI', sans-serif }\n"
          "h1 { font-size: 1.6rem; line-height: 1.25; margin: 0 0 .4rem } h2 { font-size: 1.15rem; margin: 2.4rem 0 "
          ".8rem } h3 { font-size: 1rem; margin: 1.6rem 0 .6rem }\n"
          "p, dl { max-width: 76ch; margin: .4rem 0 } dt { font-weight: 600; margin-top: .6rem } dd { margin: 0 } "
          ".faint, figcaption span, dd { color: var(--faint) }\n"
          ".grid { display: grid; gap: 1.4rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 400px), 1fr)) "
          "}\n"
          ".crops { grid-template-columns: repeat(auto-fit, minmax(min(100%, 260px), 1fr)); margin-top: 1.4rem }\n"
          ".thumbs { grid-template-columns: repeat(auto-fit, minmax(min(100%, 200px), 1fr)); gap: .8rem; max-width: "
          "900px; margin: .8rem 0 } .thumbs figure { align-self: end } .thumbs figcaption, .thumbs figcaption span { "
          "display: block; font-size: .85rem; overflow-wrap: anywhere }\n"
          ".charts { display: grid; gap: 1.4rem; grid-template-columns: repeat(auto-fit, minmax(min(100%, 600px), "
          "1fr)) } svg { display: block; width: 100%; height: auto; max-width: 900px }\n"
          "figure { margin: 0 } figcaption { margin: 0 0 .35rem; display: flex; justify-content: space-between; gap: "
          "1rem } figcaption span { font-variant-numeric: tabular-nums }\n"
          "img { display: block; width: 100%; height: auto; border: 1px solid var(--line) } img + img, a + a img { "
          "border-top: 0 }\n"
          ".key { padding: 1rem 0 } .key img { height: 18px } .key div { display: flex; justify-content: "
          "space-between; font-size: .85rem; color: var(--faint) }\n"
          ".wide { overflow-x: auto } table { border-collapse: collapse; font-variant-numeric: tabular-nums; "
          "font-size: .92rem; background: var(--panel) }\n"
          "th, td { padding: .3rem .8rem; text-align: right; border-bottom: 1px solid var(--line); white-space: nowrap "
          "} th { color: var(--faint); font-weight: 500 } .first td { border-top: 2px solid var(--line) }\n"
          "th:nth-child(-n+2), td:nth-child(-n+2) { text-align: left } code { font: .88em ui-monospace, Menlo, "
          "Consolas, monospace } summary { cursor: pointer; padding: .3rem 0 }\n"
          "</style>\n<h1>",
          f);
    escaped(f, title);
    fputs("</h1>\n<p>", f);
    escaped(f, about);
    fputs("</p>\n", f);
}

void figure_html(FILE *f, const char *slug, const char *label, const char *note, int width, int height, int difference)
{
    fprintf(f, "<figure><figcaption><b>%s</b><span>%s</span></figcaption>", label, note);
    for (int k = 0; k <= difference; ++k)
        fprintf(f, "<a href=\"%s%s.png\"><img src=\"%s%s.png\" width=\"%d\" height=\"%d\" alt=\"%s%s\"></a>", slug,
                k ? "-difference" : "", slug, k ? "-difference" : "", width, height, k ? "difference of " : "", label);
}

void key_html(FILE *f, double range)
{
    fprintf(f,
            "<div class=\"key\"><img src=\"difference-legend.png\" alt=\"blue over white to red\"><div><span>&minus;%g "
            "too dark</span><span>0</span><span>too bright +%g</span></div>"
            "<p class=\"faint\">Under each picture: its difference to the truth, in these colours.</p></div>",
            range, range);
}

void html_terms(FILE *f)
{
    fputs("<h2>What the figures mean</h2>\n<dl>\n"
          "<dt>fetches<dd>Texel fetches per pixel, summed over all passes of the method.\n"
          "<dt>bytes<dd>What a frame moves per pixel at the least: each pass reads each texel of its inputs once and "
          "writes each texel of its outputs once, in the formats in which they are stored; "
          "of splats, which are blended, each texel that they cover is read and written, and surfels are read once.\n"
          "<dt>time<dd>GL time of all passes, over that of one unblurred 16-sample SSAO drawn right before and after "
          "it in the same run; the median of several rounds. Below 1 is cheaper than that SSAO.\n"
          "<dt>RMSE, share<dd>Root mean square difference to the ray-traced truth, over the pixels that show "
          "something, of ambient visibility (0 closed, 1 open), as it comes, with no fit or gain. "
          "The share is RMSE over the RMSE of having no AO at all, so 1 means that the pass might as well be left "
          "out.\n"
          "<dt>bias, p95, SSIM<dd>The mean difference (below 0: too dark), the difference that 95 % of the pixels stay "
          "under, the structural similarity.\n"
          "<dt>edge, border, inside<dd>Which shares of the squared error sit within 3 pixels of a jump in depth; "
          "elsewhere, nearer to the picture's border than the radius is long; and in the rest. With light: of "
          "irradiance. The CSV has their shares of the pixels, RMSE and bias as well.\n"
          "<dt>model, noise<dd>Drawn with two phases of its noise: the model's error is what their mean picture is "
          "off, the noise what a pixel varies by, as under light below. The noise is 0 where no phase changes the "
          "picture.\n"
          "<dt>margin<dd>The depth buffer is larger than the picture on each side, by so many radii as projected at "
          "the "
          "border; time is that of the passes: a larger depth buffer has to be drawn, too.\n"
          "<dt>grey band<dd>The Pareto front: no other point of the chart is both faster and closer to the truth.\n"
          "<dt>floor<dd>The exact answer from one depth layer, ray-traced against the visible surface taken as thin "
          "sheets. What lies between it and the truth is not in the depth buffer: "
          "more layers or cameras buy it. A method above the floor can win by more samples; one below it does so by "
          "assuming how thick things are.\n</dl>\n",
          f);
}

void lit_terms(FILE *f)
{
    fputs("<dl>\n<dt>radiance, irradiance, bounce<dd>Root mean square difference to the ray-traced truth, over the "
          "truth's mean, red, green and blue together, over the pixels that show something: of the light that "
          "leaves the surface; of the light that arrives, over pi, from the environment and from lights with their "
          "shadows; and of light that was reflected once before. The bias after each is the mean difference, over "
          "the same mean. No gain, no fit.\n"
          "<dt>time, of light<dd>As above: all passes of a frame, among them the lights' shadows and the light of "
          "hidden senders. Not in it: drawing the G-buffer, its farther layers, extra cameras' G-buffers and shadow "
          "maps.\n"
          "<dt>truth, of light<dd>The environment and the bounce are weighted by 1 &minus; t/radius of the nearest "
          "hit, as the methods take them; lights are shadowed by the whole scene, "
          "unless it says that suns are local: then they are small discs, blocked like the environment.\n"
          "<dt>bias error, noise, hue<dd>Each method drawn with eight phases of its noise. The bias error is what "
          "their mean picture is off, the noise what a pixel varies by (the mean over the pixels of its variance; what "
          "is left of "
          "it in the mean picture is taken off the bias error): the squares of both add up to that of the irradiance's "
          "error. All over the truth's mean. Hue: the angle between the red, green and blue of the mean picture's "
          "irradiance and the truth's, "
          "its mean over the pixels weighted by the truth's luminance; and over those that blockers keep 5 % or more "
          "of their light from.\n</dl>\n",
          f);
}

void field_terms(FILE *f)
{
    fputs("<dl>\n<dt>occlusion between objects<dd>What rigid occluders take from the ambient light of other things, at "
          "any distance; occluders do not shade themselves. Its truth: rays that are blocked by all occluders but the "
          "one "
          "that the pixel shows, at any distance; the fields end at eight radii of an occluder's bounding sphere. "
          "Errors are of occlusion, over the pixels that show something else than the only occluder.\n</dl>\n",
          f);
}

void deep_terms(FILE *f)
{
    fputs("<dl>\n<dt>surfels, splats<dd>Deep screen space makes discs of all triangles, seen or not, of a size in "
          "picture heights, and draws each over the pixels that it reaches. Splats: the texels so drawn, all levels, "
          "over the "
          "picture's pixels; a graphics card and a software rasteriser spend nearly all of the time there.\n"
          "<dt>truth, of deep screen space<dd>Ambient visibility: as above, weighted by 1 &minus; t/radius. Light of "
          "surfels has no such weight: what is within the radius counts whole, in the truth of its rows, too, while "
          "ssdo's rows keep their own. "
          "One specular bounce: rays by the lobe, their hits lit and shadowed. Scattering: the dipole's sum over "
          "samples on all of the mesh, shadowed by rays.\n"
          "<dt>varies<dd>A place's ambient visibility in a few frames of a camera that moves, between four pixels "
          "around it; places that any frame does not show are left out.\n</dl>\n",
          f);
}
