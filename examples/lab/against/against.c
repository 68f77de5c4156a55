/* against.c - compares two builds of the library: the picture that each method draws with the old build and with
   the new one, on scenes by seed, and the error of each.

   --help lists the arguments. Both builds draw frames that this program saves, so that the library alone differs; rows
   of the view SCENE draw the scene itself. Truth is traced at one pixel of 11x11, kept in build/cache.

   If a row's pictures mean the same, it keeps three limits on the mean over the scenes: of the bias, of the change of
   the relative error, and of the correlation of the difference between neighbouring 8x8 blocks. */
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "lab/against/compared.h"
#include "lab/against/look.h"

#define REPORT "report"

enum { SCENES = 12 }; /* seeds 0 to 11, on which settings may be tuned */

/* Limits of means over the scenes. SHARE, the limit of the relative error's change, is extended by half of the 95 %
   interval that comes from tracing the truth at few pixels: another pattern of noise changes the relative error by as
   much. If the RMSE of a scene is below SEEN, an eighth of a grey level, its correlation counts as 0. */
static const double BIAS = 0.0002, SHARE = 0.002, SHAPE = 0.2, SEEN = 0.0005;

/* ---- >>pictures -------------------------------------------------------------------------------------------------- */

/* share: the relative errors of the old build and of the new one; doubt: the standard error of their difference.
   missing: 1 if the old build cannot draw the row. */
typedef struct found {
    compared apart;
    double share[2], doubt;
    int missing, failed;
    kit_error why;
} found;

static struct {
    const char *render[2]; /* two build/render: the old build's, the new one's */
    int wanted[MOST_SUBJECTS];
    place place[SCENES]; /* place[k] is the scene random:k */
    found found[MOST_SUBJECTS][SCENES];
    int compared, broken, missing; /* numbers of rows */
} all;

/* Runs a command. If it fails, err gets the first line that the command printed. */
static int run(const char *command, kit_error *err)
{
    char line[512] = "", rest[512];
    FILE *said = popen(command, "r");
    if (!said) return kit_fail(err, "no shell");
    if (!fgets(line, sizeof line, said)) snprintf(line, sizeof line, "ended without a word");
    while (fgets(rest, sizeof rest, said)) {}
    line[strcspn(line, "\n")] = 0;
    return pclose(said) ? kit_fail(err, "%s", line) : 0;
}

/* Draws a row's picture with the old or the new build, on one core. */
static int draw(kit_image *out, const subject *u, const place *p, int is_new, kit_error *err)
{
    const int turned = u->view == TURNED, frames = turned ? LOOK_FRAMES : 1;
    char command[1024], source[160], more[64] = "", env[48] = "", frame[64], base[64], path[80];
    place_frame(frame, p, u->view);
    snprintf(base, sizeof base, LOOK_FOLDER "/%d-%s", p->seed, is_new ? "new" : "old");
    if (turned) snprintf(more, sizeof more, "--frames %d --orbit %g", LOOK_FRAMES, LOOK_ORBIT);
    if (quantities[u->quantity].lit) snprintf(env, sizeof env, "--env %s", p->env);
    if (turned || u->view == SCENE)
        snprintf(source, sizeof source, "%s --size %dx%d", p->name, LOOK_WIDTH, LOOK_HEIGHT);
    else snprintf(source, sizeof source, "--gbuffer %s", frame);
    snprintf(command, sizeof command, "LP_NUM_THREADS=0 KIT_THREADS=1 '%s' --method %s --set '%s' --set '%s' %s %s %s "
             "--out %s%s.exr 2>&1", all.render[is_new], u->method, u->settings, is_new ? u->new_alone : "", env, source,
             more, base, turned ? "-%d" : "");
    if (run(command, err)) return -1;
    for (int k = 0; k < frames; ++k) {
        snprintf(path, sizeof path, turned ? "%s-%d.exr" : "%s.exr", base, k);
        const int failed = k + 1 == frames && kit_exr_read(out, path, err);
        if (unlink(path) || failed) return -1;
    }
    return 0;
}

/* Fills in the relative errors of both builds' pictures: RMSE over the RMSE of no occlusion. */
static int judge(found *f, const subject *u, const look *l, const kit_image *const picture[2], kit_error *err)
{
    const quantity *q = &quantities[u->quantity];
    const double unit = q->lit ? l->light : 1;
    const kit_image *truth = &l->truth[q->lit];
    const float *mask = l->middles.data;
    compared nothing;
    errors e;
    kit_image middles[2] = { { 0 } };
    int failed = compared_of(&f->apart, picture[1], picture[0], q->channel, q->channels, l->shown.data, err)
              || compared_of(&nothing, &l->nothing[q->lit], truth, q->channel, q->channels, mask, err);
    for (int k = 0; k < 2 && !failed; ++k) failed = look_middles(&middles[k], picture[k], err);
    failed = failed
          || errors_of(&e, (const kit_image *const[]){ &middles[0], &middles[1] }, truth, q->channel, q->channels, mask,
                       err);
    for (int k = 0; k < 2; ++k) kit_image_free(&middles[k]);
    if (failed) return -1;
    f->apart.rmse /= unit;
    f->apart.bias /= unit;
    for (int k = 0; k < 2; ++k) f->share[k] = e.rmse[k] / nothing.rmse;
    f->doubt = e.doubt / nothing.rmse;
    return 0;
}

/* The rows first .. last - 1 of the comparison, which share one picture. */
typedef struct drawing {
    int first, last;
} drawing;

static void draw_both(void *of, int k)
{
    const drawing *d = of;
    const subject *u = &subjects[d->first];
    place *p = &all.place[k];
    found *f = &all.found[d->first][k];
    kit_image old = { 0 }, new = { 0 };
    f->missing = draw(&old, u, p, 0, &f->why);
    f->failed = !f->missing && draw(&new, u, p, 1, &f->why);
    for (int i = d->first; i < d->last && !f->missing && !f->failed; ++i)
        f->failed = judge(&all.found[i][k], &subjects[i], place_look(p, u->view),
                          (const kit_image *const[]){ &old, &new }, &f->why);
    kit_image_free(&old);
    kit_image_free(&new);
}

/* ---- >>results --------------------------------------------------------------------------------------------------- */

enum { RMSE, BIASED, CHANGE, SHAPED, FIGURED };

static double figure(const found *f, int which)
{
    return which == RMSE   ? f->apart.rmse
         : which == BIASED ? f->apart.bias
         : which == CHANGE ? f->share[1] - f->share[0]
                           : f->apart.rmse > SEEN ? f->apart.patches : 0;
}

/* One quantity over all scenes. mean: over the scenes; worst: the value that is farthest from 0, and its scene. */
typedef struct summary {
    double mean, worst;
    int whose;
} summary;

static summary summarise(const found f[SCENES], int which)
{
    summary s = { 0, 0, 0 };
    for (int k = 0; k < SCENES; ++k) {
        const double v = figure(&f[k], which);
        s.mean += v / SCENES;
        if (isnan(v) || fabs(v) > fabs(s.worst)) {
            s.worst = v;
            s.whose = k;
        }
    }
    return s;
}

/* Writes the two builds' difference as a picture; it is red at pixels that are brighter in the new picture. */
static int show(const subject *u, place *p, double rmse, kit_error *err)
{
    const char *channel = quantities[u->quantity].channel[quantities[u->quantity].lit];
    const double unit = quantities[u->quantity].lit ? place_look(p, u->view)->light : 1,
                 range = unit * (rmse > 0 ? 4 * rmse : 0.01);
    kit_image old, new, difference;
    char path[128];
    snprintf(path, sizeof path, REPORT "/against-%s-%s.png", u->name, quantities[u->quantity].word);
    if (draw(&old, u, p, 0, err) || draw(&new, u, p, 1, err)
        || kit_image_difference(&difference, &new, &old, channel, (float)range, err)
        || kit_png_write(&difference, "R,G,B", 0, path, err))
        return -1;
    printf("%-18s %s: %s, full colour at +-%.2g\n", "", path, p->name, range);
    kit_image_free(&old);
    kit_image_free(&new);
    kit_image_free(&difference);
    return 0;
}

static void print_head(void)
{
    printf("Means over %d scenes, and in brackets the worst with its seed. Like itself: the difference, 1 and 3 "
           "pixels\nacross, 1 and 3 down, and from 8x8 pixels to the next.\n\n%-18s %-10s  %-23s  %-25s  %-34s  %s\n",
           SCENES, "row", "quantity", "RMSE", "bias", "share of error", "like itself");
    fflush(stdout);
}

/* Prints the line of row i of the comparison. Returns how many limits the row breaks. */
static int print_row(int i)
{
    static const char *const limited[FIGURED] = { NULL, "bias", "share", "shape" };
    const found *f = all.found[i];
    double like[2 * COMPARED_LAGS] = { 0 }, share = 0, half = 0;
    char verdict[64] = "DIFFERS:";
    summary s[FIGURED];
    for (int k = 0; k < FIGURED; ++k) s[k] = summarise(f, k);
    for (int k = 0; k < SCENES; ++k) {
        share += f[k].share[0] / SCENES;
        half = hypot(half, 1.96 * f[k].doubt / SCENES);
        for (int l = 0; l < COMPARED_LAGS; ++l) {
            like[l] += f[k].apart.across[l] / SCENES;
            like[COMPARED_LAGS + l] += f[k].apart.down[l] / SCENES;
        }
    }
    const int breaks[FIGURED] = { 0, !(fabs(s[BIASED].mean) <= BIAS), !(fabs(s[CHANGE].mean) <= SHARE + half),
                                  s[SHAPED].mean > SHAPE };
    const int broken = breaks[BIASED] + breaks[CHANGE] + breaks[SHAPED];
    for (int k = 0; k < FIGURED; ++k)
        if (breaks[k]) snprintf(verdict + strlen(verdict), sizeof verdict - strlen(verdict), " %s", limited[k]);
    printf("%-18s %-10s  %.5f (%.5f %3d)", subjects[i].name, quantities[subjects[i].quantity].word, s[RMSE].mean,
           s[RMSE].worst, s[RMSE].whose);
    printf("  %+.5f (%+.5f %3d)", s[BIASED].mean, s[BIASED].worst, s[BIASED].whose);
    printf("  %.4f %+.4f +- %.4f (%+.4f %3d) ", share, s[CHANGE].mean, half, s[CHANGE].worst, s[CHANGE].whose);
    for (int l = 0; l < 2 * COMPARED_LAGS; ++l) printf(" %+.2f", like[l]);
    printf(" %+.2f (%+.2f %3d)  %s\n", s[SHAPED].mean, s[SHAPED].worst, s[SHAPED].whose,
           broken              ? verdict
           : s[RMSE].mean == 0 ? "same"
                               : "equal");
    return broken;
}

/* Draws one picture in all scenes by both builds, and prints the rows that belong to this picture. */
static int compare(const drawing *d, kit_error *err)
{
    const subject *u = &subjects[d->first];
    char what[64];
    snprintf(what, sizeof what, "%s, row %d of %d", u->name, d->first + 1, subjects_count);
    kit_parallel(what, SCENES, draw_both, (void *)(uintptr_t)d);
    for (int k = 0; k < SCENES; ++k) {
        const found *f = &all.found[d->first][k];
        if (f->missing) {
            printf("%-18s not compared on %s, the old build says: %s\n", u->name, all.place[k].name, f->why.text);
            all.missing += d->last - d->first;
            return 0;
        }
        if (f->failed) return kit_fail(err, "row %s on %s: %s", u->name, all.place[k].name, f->why.text);
    }
    for (int i = d->first; i < d->last; ++i) {
        const int breaks = print_row(i) > 0;
        const summary rmse = summarise(all.found[i], RMSE);
        if (breaks && show(&subjects[i], &all.place[rmse.whose], rmse.worst, err)) return -1;
        all.broken += breaks;
        ++all.compared;
        fflush(stdout);
    }
    return 0;
}

/* ---- >>main ------------------------------------------------------------------------------------------------------ */

static int want(const char *name, kit_error *err)
{
    int exactly = 0, some = 0;
    for (int i = 0; i < subjects_count; ++i) exactly |= !strcmp(subjects[i].name, name);
    for (int i = 0; i < subjects_count; ++i) {
        if (exactly ? strcmp(subjects[i].name, name) : strncmp(subjects[i].name, name, strlen(name))) continue;
        all.wanted[i] = some = 1;
    }
    return some ? 0 : kit_fail(err, "%s: there is no such row", name);
}

static const char usage[] = "against OLD_RENDER NEW_RENDER [ROW ..]";
static const kit_option help[] = {
    { .about = "Compares what two builds of the library draw, on 12 scenes by seed, and the errors of both. It "
               "prints a line for each row, and writes the worst scene of a row that breaks a limit as "
               "report/against-ROW-QUANTITY.png. The status is 1 if a row breaks a limit, and 2 after an "
               "error. make against OLD=REVISION builds both programs." },
    { "OLD_RENDER, NEW_RENDER", NULL, "build/render of two checkouts.", .kind = KIT_TOLD },
    { "ROW", NULL, "The row of that name, or all rows whose names begin so [all rows].", .kind = KIT_TOLD },
    { NULL }
};

static int parse(int argc, char **argv, kit_error *err)
{
    if (argc < 3) return kit_fail(err, "a program is missing: %s (--help explains it)", usage);
    for (int k = 0; k < 2; ++k) {
        all.render[k] = argv[1 + k];
        if (access(argv[1 + k], X_OK)) return kit_fail(err, "%s: cannot be run", argv[1 + k]);
    }
    for (int i = 0; i < subjects_count; ++i) all.wanted[i] = argc == 3;
    for (int i = 3; i < argc; ++i)
        if (want(argv[i], err)) return -1;
    return 0;
}

static int visit_all(kit_error *err)
{
    if (kit_gl_open(NULL, err)) return -1;
    kit_progress("scenes and their truth", 0);
    for (int k = 0; k < SCENES; ++k) {
        if (place_open(&all.place[k], k, all.wanted, err)) return -1;
        kit_progress("scenes and their truth", (k + 1.0) / SCENES);
    }
    kit_gl_close();
    return 0;
}

int main(int argc, char **argv)
{
    kit_error err = { "" };
    if (kit_help(argc, argv, usage, help)) return 0;
    subjects_load();
    int failed = parse(argc, argv, &err) || folder_make(LOOK_FOLDER, &err) || folder_make(REPORT, &err)
              || visit_all(&err);
    if (!failed) print_head();
    for (drawing d = { 0, 0 }; d.first < subjects_count && !failed; d.first = d.last) {
        while (d.last < subjects_count && !strcmp(subjects[d.first].name, subjects[d.last].name)) ++d.last;
        failed = all.wanted[d.first] && compare(&d, &err);
    }
    if (!failed && !all.compared) failed = kit_fail(&err, "no row was compared");
    if (failed) {
        fprintf(stderr, "against: %s\n", err.text);
        return 2;
    }
    printf("\n%d rows compared, %d differ; not compared: %d\n", all.compared, all.broken, all.missing);
    return all.broken > 0;
}
