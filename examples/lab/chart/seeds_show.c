/* seeds_show.c - scenes by seed as text, CSV and pages: what their rows say together. Declared in seeds_show.h. */
#include "lab/chart/seeds_show.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include "lab/chart/seeds.h"
#include "lab/page/csv.h"
#include "lab/page/dots.h"
#include "lab/page/page.h"

enum { SHEET = 60 };                         /* pictures */

void seeds_name(char name[32], int seed)
{
    snprintf(name, 32, "%s-%d", kit_scene_kind(seed % KIT_KINDS, NULL), seed);
}

int seeds_lit(const row *r) { return (r->of & OF_LIT) != 0; }

static const char *kind_of(const seeds *s, int k) { return kit_scene_kind((s->first + k) % KIT_KINDS, NULL); }

/* A scene that was not left out; NULL: there is none. */
static const row *names_of(const seeds *s)
{
    for (int k = 0; k < s->count; ++k) if (s->row[k]) return s->row[k];
    return NULL;
}

/* The method comes first where the label does not tell it. */
static const char *settings_of(char out[160], const row *r)
{
    const int none = !strcmp(r->method, "none") || !strcmp(r->method, "floor"),
              told = none || !strcmp(r->label, r->method);
    snprintf(out, 160, "%s%s%s", told ? "" : r->method, told || !*r->settings ? "" : " ",
             told && !none && !*r->settings ? "defaults" : r->settings);
    return out;
}

/* ---- >>spread ---------------------------------------------------------------------------------------------------- */

/* The i-th row's shares over the scenes; less those of another row, where that is not below 0. */
static void shares(double *out, const seeds *s, int i, int less)
{
    for (int k = 0; k < s->count; ++k)
        out[k] = s->row[k] ? s->row[k][i].share - (less < 0 ? 0 : s->row[k][less].share) : (double)NAN;
}

static spread spread_of_row(const seeds *s, int i, int less)
{
    double share[MOST_SEEDS];
    shares(share, s, i, less);
    return spread_of(share, s->count);
}

static double mean_in(const seeds *s, int i, int kind)
{
    double share[MOST_SEEDS];
    int kinds[MOST_SEEDS];
    shares(share, s, i, -1);
    for (int k = 0; k < s->count; ++k) kinds[k] = (s->first + k) % KIT_KINDS;
    return spread_in(share, kinds, kind, s->count).mean;
}

/* The row that others are compared with, of visibility or of light: -1 = it was not asked for. */
static int reference_of(const seeds *s, int lit)
{
    const row *r = names_of(s);
    for (int i = 0; i < s->rows; ++i)
        if (seeds_lit(&r[i]) == lit && !strcmp(r[i].method, lit ? "ssdo" : "hsao")
            && !strcmp(r[i].settings, lit ? "bounce=none" : ""))
            return i;
    return -1;
}

/* The first row of light, and past the last. */
static int lit_from(const seeds *s)
{
    int i = 0;
    while (i < s->rows && !seeds_lit(&names_of(s)[i])) ++i;
    return i;
}

/* ---- >>beside ---------------------------------------------------------------------------------------------------- */

/* The mean of a row's column in a csv of the chart; NAN: not there. */
static double mean_of(const csv *c, const row *r, const char *key)
{
    double sum = 0;
    int n = 0;
    for (int i = 0; i < c->rows; ++i) {
        if (strcmp(csv_text(c, i, "label"), r->label) || strcmp(csv_text(c, i, "method"), r->method)
            || strcmp(csv_text(c, i, "settings"), r->settings))
            continue;
        sum += csv_number(c, i, key);
        ++n;
    }
    return n ? sum / n : (double)NAN;
}

void seeds_beside(seeds *s, const char *out)
{
    csv_folder = out;
    const csv ambient = csv_read("chart.csv"), pairs = csv_read("chart-pairs.csv");
    for (int i = 0; i < s->rows; ++i) {
        const row *r = &names_of(s)[i];
        const csv *from = seeds_lit(r) ? &pairs : &ambient;
        s->time[i] = mean_of(from, r, "relative_time");
        s->mean[i] = strcmp(r->method, "none") || !strstr(r->label, "noise") ? mean_of(from, r, "share") : (double)NAN;
    }
}

/* ---- >>text ------------------------------------------------------------------------------------------------------ */

static void head_text(FILE *f, int lit)
{
    fprintf(f, "%-32s %-40s %6s %6s %6s %6s %5s %3s", lit ? "light" : "ambient occlusion", "", "mean", "+-", "median",
            "worst", "seed", ">1");
    for (int k = 0; k < KIT_KINDS; ++k) fprintf(f, " %8s", kit_scene_kind(k, NULL));
    fprintf(f, " %6s %6s\n", "time", "chart");
}

static void figure_text(FILE *f, int width, int digits, double v)
{
    if (isnan(v)) fprintf(f, " %*s", width, "-");
    else fprintf(f, " %*.*f", width, digits, v);
}

static void row_text(FILE *f, const seeds *s, int i)
{
    const row *r = &names_of(s)[i];
    const spread all = spread_of_row(s, i, -1);
    char text[160];
    fprintf(f, "%-32s %-40s", r->label, settings_of(text, r));
    figure_text(f, 6, 3, all.mean);
    figure_text(f, 6, 3, all.half);
    figure_text(f, 6, 3, all.median);
    figure_text(f, 6, 3, all.most);
    fprintf(f, " %5d %3d", s->first + all.worst, all.above);
    for (int k = 0; k < KIT_KINDS; ++k) figure_text(f, 8, 3, mean_in(s, i, k));
    figure_text(f, 6, 2, s->time[i]);
    figure_text(f, 6, 3, s->mean[i]);
    fputc('\n', f);
}

static int left_out(const seeds *s)
{
    int n = 0;
    for (int k = 0; k < s->count; ++k) n += !s->row[k];
    return n;
}

void seeds_table_text(FILE *f, const seeds *s)
{
    if (!s->rows) return;
    fprintf(f, "\nscenes by seed, %d to %d: RMSE over that of no occlusion; %d left out for want of a package\n",
            s->first, s->first + s->count - 1, left_out(s));
    for (int i = 0; i < s->rows; ++i) {
        if (!i || i == lit_from(s)) head_text(f, i == lit_from(s));
        row_text(f, s, i);
    }
}

/* ---- >>csv ------------------------------------------------------------------------------------------------------- */

static void figure_csv(FILE *f, double v)
{
    if (isnan(v)) fputc(',', f);
    else fprintf(f, ",%.6g", v);
}

void seeds_csv(FILE *f, const seeds *s)
{
    fputs("seed,kind,what,label,method,settings,share,bias,time\n", f);
    for (int k = 0; k < s->count; ++k)
        for (int i = 0; i < s->rows && s->row[k]; ++i) {
            const row *r = &s->row[k][i];
            fprintf(f, "%d,%s,%s,\"%s\",%s,\"%s\"", s->first + k, kind_of(s, k), seeds_lit(r) ? "light" : "ao",
                    r->label, r->method, r->settings);
            figure_csv(f, r->share);
            figure_csv(f, seeds_lit(r) ? r->bias[1] : r->score.bias);
            fputs(",\n", f);
        }
}

/* ---- >>pages ----------------------------------------------------------------------------------------------------- */

static void cell(FILE *f, double v, int digits, int sign)
{
    if (isnan(v)) fputs("<td>&ndash;", f);
    else fprintf(f, sign ? "<td>%+.*f" : "<td>%.*f", digits, v);
}

static void table_head(FILE *f, const seeds *s, int lit)
{
    fprintf(f,
            "<div class=\"wide\"><table>\n<tr><th>method<th>settings<th title=\"over the seeds\">mean<th title=\"of "
            "the mean's 95 %% interval, half\">&plusmn;<th title=\"mean difference to that row, scene by scene\">less "
            "%s<th title=\"of that difference's 95 %% interval, half\">&plusmn;<th>median<th>worst<th>seed<th "
            "title=\"scenes on which it is worse than nothing\">&gt; 1",
            lit ? "ssdo's" : "hsao's");
    for (int k = 0; k < KIT_KINDS; ++k)
        fprintf(f, "<th><a href=\"%s-%s.html\">%s</a>", s->base, kit_scene_kind(k, NULL), kit_scene_kind(k, NULL));
    fprintf(f,
            "<th title=\"of the same rows in this folder's chart, whose scenes are timed\">time<th title=\"share, mean "
            "of %s\">chart's\n",
            lit ? "its pairs of a scene and a probe" : "its scenes");
}

static void table_row(FILE *f, const seeds *s, int i, int less)
{
    const row *r = &names_of(s)[i];
    spread all = spread_of_row(s, i, -1), off = spread_of_row(s, i, less);
    char text[160], name[32];
    const int known = less >= 0 && less != i;
    if (all.worst < 0) all.worst = 0;
    fprintf(f, "<tr%s><td>", i && strcmp(r->label, r[-1].label) ? " class=\"first\"" : "");
    page_escaped(f, r->label);
    fprintf(f, "<td><code>%s</code>", settings_of(text, r));
    cell(f, all.mean, 3, 0);
    cell(f, all.half, 3, 0);
    cell(f, known ? off.mean : (double)NAN, 3, 1);
    cell(f, known ? off.half : (double)NAN, 3, 0);
    cell(f, all.median, 3, 0);
    cell(f, all.most, 3, 0);
    seeds_name(name, s->first + all.worst);
    fprintf(f, "<td><a href=\"%s-%s.html#%s\">%s</a><td>%d", s->base, kind_of(s, all.worst), name, name, all.above);
    for (int k = 0; k < KIT_KINDS; ++k) cell(f, mean_in(s, i, k), 3, 0);
    cell(f, s->time[i], 2, 0);
    cell(f, s->mean[i], 3, 0);
    fputc('\n', f);
}

/* Rows from .. to - 1 as a chart. */
static int drawn(FILE *html, const seeds *s, const char *out, int from, int to, const char *name, const char *title,
                 kit_error *err)
{
    const char *label[MOST_SEED_ROWS], *settings[MOST_SEED_ROWS], *kind[KIT_KINDS];
    char text[MOST_SEED_ROWS][160];
    int kinds[MOST_SEEDS];
    double *value = calloc((size_t)(to - from) * (size_t)s->count, sizeof *value);
    if (!value) return kit_fail(err, "out of memory");
    for (int k = 0; k < KIT_KINDS; ++k) kind[k] = kit_scene_kind(k, NULL);
    for (int k = 0; k < s->count; ++k) kinds[k] = (s->first + k) % KIT_KINDS;
    for (int i = from; i < to; ++i) {
        label[i - from] = names_of(s)[i].label;
        settings[i - from] = settings_of(text[i - from], &names_of(s)[i]);
        shares(value + (i - from) * s->count, s, i, -1);
    }
    const dots d = { to - from, s->count, KIT_KINDS, label, settings, kind, value, s->mean + from, kinds,
                     "RMSE over that of no occlusion, a dot a scene",
                     from ? "mean of make chart's pairs" : "mean of make chart's scenes" };
    const int failed = dots_chart(html, out, name, title, &d, err);
    free(value);
    return failed;
}

static void sheet(FILE *f, const seeds *s)
{
    fputs("<div style=\"display: grid; gap: .5rem; grid-template-columns: repeat(auto-fill, minmax(150px, 1fr))\">\n",
          f);
    for (int k = 0, shown = 0; k < s->count && shown < SHEET; ++k) {
        char name[32];
        seeds_name(name, s->first + k);
        if (!s->row[k]) continue;
        fprintf(f, "<a href=\"%s-%s.html#%s\"><img src=\"%s.png\" loading=\"lazy\" width=\"320\" height=\"180\" "
                   "alt=\"%s\" title=\"%s\"></a>\n",
                s->base, kind_of(s, k), name, name, name, name);
        ++shown;
    }
    fputs("</div>\n", f);
}

static void section_head(FILE *f, const seeds *s)
{
    fprintf(f, "<h2>Scenes by seed</h2>\n<p>Seeds %d to %d, %d scenes of %d kinds, none of them picked by hand: kind, "
               "things, camera, radius, units and light are drawn from the seed. %s Shares: RMSE over that of no "
               "occlusion, so a pass above 1 is worse than none.%s</p>\n<p>By kind, with pictures:",
            s->first, s->first + s->count - 1, s->count - left_out(s), KIT_KINDS,
            s->first < SEEDS_JUDGED ? "Seeds below 1000 may be looked at while settings are tuned."
                                    : "Seeds from 1000 on only report: settings are tuned on those below 1000 alone.",
            left_out(s) ? " Some are left out for want of a package." : "");
    for (int k = 0; k < KIT_KINDS; ++k)
        fprintf(f, " <a href=\"%s-%s.html\">%s</a>", s->base, kit_scene_kind(k, NULL), kit_scene_kind(k, NULL));
    fprintf(f, ". As text: <a href=\"%s.csv\">%s.csv</a>.</p>\n", s->base, s->base);
}

int seeds_section(FILE *html, const seeds *s, const char *out, kit_error *err)
{
    static const char *const titles[] = { "Ambient occlusion on scenes by seed", "Light on scenes by seed" };
    if (!s->rows) return 0;
    section_head(html, s);
    sheet(html, s);
    for (int lit = 0; lit < 2; ++lit) {
        const int from = lit ? lit_from(s) : 0, to = lit ? s->rows : lit_from(s);
        char name[64];
        snprintf(name, sizeof name, "%s-%s.svg", s->base, lit ? "light" : "ao");
        if (from == to) continue;
        fprintf(html, "<h3>%s</h3>\n", titles[lit]);
        if (drawn(html, s, out, from, to, name, titles[lit], err)) return -1;
        table_head(html, s, lit);
        for (int i = from; i < to; ++i) table_row(html, s, i, reference_of(s, lit));
        fputs("</table></div>\n", html);
    }
    return 0;
}

void seeds_kind_head(FILE *html, int tuned, int kind)
{
    const char *about, *name = kit_scene_kind(kind, &about);
    char title[128];
    snprintf(title, sizeof title, "ssgi: scenes by seed, %s", name);
    page_head(html, title, about);
    fprintf(html,
            "<p>Each under the light that its seed brings; its true visibility; what hsao makes of that. %s</p>\n"
            "<div class=\"charts\">\n",
            tuned ? "Seeds below 1000 may be looked at while settings are tuned." : "");
}
