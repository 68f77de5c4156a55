/* test_errors.c - each method of build/render keeps its error within its bound in tests/examples/errors.csv, so that no
   default gets worse unnoticed. Errors are RMSE, of light over its mean; noise is the truth's. A row is repeated by
   hand so, with its settings also for the truth if TRUTH is METHOD, and with --still 16 if frames are averaged:

     build/render SCENE [--env ENV] [--light LIGHT] [--radius RADIUS] --size SIZE --method TRUTH --truth RAYS \
       --out t.exr
     build/render SCENE [..] --size SIZE --method METHOD [--set SETTINGS] --score t.exr

   make errors fills in errors, noise and bounds by this tree; in a new row they are empty. */
#include "t.h"
#include "lab/measure/csv.h"
#include "lab/measure/score.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>


enum { FINER = 8 };                        /* FINER times the rays make the truth that tells the noise */
static const double margin = 1.04, noisy = 0.4;       /* a bound over its error; the noise's part of it at most */

static csv rows;
static int now;
static double found, noise;                /* results of the row */
static int measures;                       /* 1: also measure the noise of the truth */
static kit_error err;

static const char *cell(int at, const char *key) { return csv_text(&rows, at, key); }

/* The opened scene with its light, G-buffer and truth; the index of the row that it is of, -1: none. */
static stage seen;
static kit_image finer;
static int seen_of = -1, traced_of = -1;

static int alike(int a, int b, const char *const *keys, int count)
{
    for (int k = 0; k < count && a >= 0; ++k) if (strcmp(cell(a, keys[k]), cell(b, keys[k]))) return 0;
    return a >= 0;
}

static void leave_truth(void)
{
    kit_image_free(&seen.truth);
    kit_image_free(&finer);
    traced_of = -1;
}

static void leave(void)
{
    leave_truth();
    if (seen_of >= 0) stage_close(&seen);
    seen_of = -1;
}

static int enter(int at)
{
    static lit light;
    const char *env = cell(at, "env"), *sun = cell(at, "light"), *radius = cell(at, "radius");
    const view v = { .name = cell(at, "scene"), .path = cell(at, "scene"), .radius = (float)atof(radius),
                     .lit = *env || *sun ? &light : NULL };
    int width, height;
    light = (lit){ .env = *env ? env : NULL, .light = { *sun ? sun : NULL } };
    if (!TRY(stage_load(&seen, &v, &err))
        || !CHECK(sscanf(cell(at, "size"), "%dx%d", &width, &height) == 2, "row %d: size \"%s\"", at + 2,
                  cell(at, "size"))
        || !TRY(stage_look(&seen, &v, width, height, &err)))
        return 0;
    seen_of = at;
    return 1;
}

static int trace(int at)
{
    const int own = !strcmp(cell(at, "truth"), cell(at, "method")), rays = atoi(cell(at, "rays"));
    kit_image *const truth[] = { &seen.truth, &finer };
    kit_method m;
    if (!TRY(kit_method_find(&m, cell(at, "truth"), &err))
        || !TRY(kit_method_set(&m, own ? cell(at, "settings") : "", &err)))
        return 0;
    for (int k = 0; k <= measures; ++k)
        if (!TRY(kit_method_truth(truth[k], &m, &seen.scene, &seen.gbuffer.camera, &seen.lighting, seen.radius,
                                  k ? FINER * rays : rays, 1, &err)))
            return 0;
    traced_of = at;
    return 1;
}

/* Computes the RMSE of a picture; of light, over the truth's mean. */
static int error_of(double *error, const kit_image *picture, const char *of)
{
    static const lit shown;
    stage s = seen;
    row r;
    s.lit = strcmp(of, "visibility") ? &shown : NULL;
    if (!TRY(kit_image_new(&s.unit, s.truth.width, s.truth.height, s.lit ? KIT_LIT_CHANNELS : "Y", &err))) return 0;
    const int failed = !TRY(score_picture(&r, &s, picture, &err));
    kit_image_free(&s.unit);
    *error = !s.lit ? r.score.rmse : r.error[!strcmp(of, "radiance") ? 0 : !strcmp(of, "irradiance") ? 1 : 2];
    return !failed;
}

static void bounded(void)
{
    static const char *const place[] = { "scene", "env", "light", "radius", "size" },
                      *const traced[] = { "truth", "rays" };
    const char *const of = cell(now, "of");
    const double bound = csv_number(&rows, now, "bound"), known = csv_number(&rows, now, "noise");
    kit_image picture;
    kit_run run;
    found = noise = (double)NAN;
    if (!alike(seen_of, now, place, 5)) {
        leave();
        if (!enter(now)) return;
    }
    if (!alike(traced_of, now, traced, 2)) {
        leave_truth();
        if (!trace(now)) return;
    }
    if (!TRY(stage_run(&run, &seen, cell(now, "method"), cell(now, "settings"), seen.radius, &err))) return;
    const int drawn = TRY(picture_settled(&run, 0, 0, &err) < 0) && TRY(kit_run_read(&picture, &run, &err));
    kit_run_close(&run);
    if (!drawn) return;
    const int scored = error_of(&found, &picture, of);
    kit_image_free(&picture);
    if (!scored) return;
    if (measures) {
        if (error_of(&noise, &finer, of)) noise /= sqrt(1 + 1.0 / FINER);
        return;
    }
    CHECK(found <= bound, "%s: its error is %.4f, more than %.4f", cell(now, "method"), found, bound);
    CHECK(known <= noisy * bound, "%s: the truth has a noise of %.4f, of a bound of %.4f", cell(now, "method"), known,
          bound);
    t_note("%.4f of %.4f", found, bound);
}

static int rowless;                        /* how many methods have no row */

/* Checks that each method of build/render --list has a row. */
static void complete(void)
{
    kit_method m;
    for (int i = 0; kit_method_at(&m, i); ++i) {
        int at = 0;
        while (at < rows.rows && strcmp(cell(at, "method"), m.name)) ++at;
        rowless += !CHECK(at < rows.rows, "%s has no row in errors.csv: copy that of its nearest relative",
                          m.name);
    }
}

static void write_row(FILE *f, int at)
{
    for (int k = 0; k < rows.columns; ++k) {
        const char *key = rows.cell[k];
        if (k) fputc(',', f);
        if (!strcmp(key, "error")) fprintf(f, "%.4f", found);
        else if (!strcmp(key, "noise")) fprintf(f, "%.4f", noise);
        else if (!strcmp(key, "bound")) fprintf(f, "%.4f", margin * found);
        else fprintf(f, strchr(cell(at, key), ',') ? "\"%s\"" : "%s", cell(at, key));
    }
    fputc('\n', f);
}

void test_errors(void)
{
    const char *const out = getenv("T_ERRORS");
    FILE *f = NULL;
    rows = csv_read("tests/examples", "errors.csv");
    RUN("every method has a bound", complete);
    if (out && rowless) return;            /* a method without a row: writes no figures */
    if (!TRY(kit_gl_open(NULL, &err))) return;
    if (out && !CHECK((f = fopen(out, "w")) != NULL, "T_ERRORS=%s: cannot be written", out)) return;
    measures = f != NULL;
    for (int k = 0; k < rows.columns && f; ++k) fprintf(f, "%s%s", rows.cell[k], k + 1 < rows.columns ? "," : "\n");
    for (now = 0; now < rows.rows; ++now) {
        char sentence[256];
        snprintf(sentence, sizeof sentence, "%s%s%s: the error of its %s of %s is within its bound",
                 cell(now, "method"), *cell(now, "settings") ? ", " : "", cell(now, "settings"),
                 cell(now, "of"), cell(now, "scene"));
        RUN(sentence, bounded);
        if (f) write_row(f, now);
    }
    if (f) CHECK(!fclose(f), "T_ERRORS=%s: cannot be written", out);
    leave();
    kit_fields_free();
    kit_gl_close();
}
