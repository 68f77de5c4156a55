/* test_errors.c - each method of build/render keeps its error within its bound in tests/errors.csv, so that no default
   gets worse unseen. Errors are RMSE, of light over its mean; noise is that of the truth. A row by hand, whose truth
   also has its settings where TRUTH is METHOD; with --still 16 where frames are averaged:

     build/render SCENE [--env ENV] [--light LIGHT] [--radius RADIUS] --size SIZE --method TRUTH --truth RAYS \
       --out t.exr
     build/render SCENE [..] --size SIZE --method METHOD [--set SETTINGS] --score t.exr

   make errors writes errors, noise and bounds anew, as this tree has them; a row that is added leaves them empty. */
#include "t.h"
#include "lab/measure/csv.h"
#include "lab/measure/picture.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define TRY(call) CHECK(!(call), "%s", err.text)

enum { FINER = 8 };                        /* rays of the truth that tells the noise of one, over that one's */
static const double margin = 1.04, noisy = 0.4;       /* of a bound: over the error; the most that is noise */

static csv rows;
static int now;
static double found, noise;                /* of that row */
static int measures;                       /* 1: noise is asked for */
static kit_error err;

static const char *cell(int row, const char *key) { return csv_text(&rows, row, key); }

/* The scene of a row, its light, what is seen of it, its truth; of which row they are, -1 = of none. */
static struct stage {
    int          row, traced;
    kit_scene    scene;
    kit_lighting light;
    kit_gbuffer  g;
    kit_image    frame, truth, finer;
    float        radius;
} stage = { -1, -1, .radius = 0 };

static int alike(int a, int b, const char *const *keys, int count)
{
    for (int k = 0; k < count && a >= 0; ++k) if (strcmp(cell(a, keys[k]), cell(b, keys[k]))) return 0;
    return a >= 0;
}

static void untrace(struct stage *s)
{
    if (s->traced >= 0) kit_image_free(&s->truth);
    if (s->traced >= 0 && measures) kit_image_free(&s->finer);
    s->traced = -1;
}

static void leave(struct stage *s)
{
    untrace(s);
    if (s->row >= 0) {
        kit_image_free(&s->frame);
        kit_gbuffer_free(&s->g);
        kit_image_free(&s->light.env);
        kit_scene_free(&s->scene);
    }
    s->row = -1;
}

static int enter(struct stage *s, int row)
{
    const char *env = cell(row, "env"), *light = cell(row, "light"), *radius = cell(row, "radius");
    memset(&s->light, 0, sizeof s->light);
    if (!TRY(kit_scene_load(&s->scene, cell(row, "scene"), 0, &err))
        || !CHECK(sscanf(cell(row, "size"), "%dx%d", &s->scene.camera.width, &s->scene.camera.height) == 2,
                  "row %d: size \"%s\"", row + 2, cell(row, "size"))
        || (*env && !TRY(kit_env_read(&s->light.env, env, &err)))
        || (*light && !TRY(kit_light_parse(&s->light.light[s->light.lights++], light, NULL, &err)))
        || !TRY(kit_gbuffer_from_scene(&s->g, &s->scene, &s->scene.camera, NULL, &err))
        || !TRY(kit_gbuffer_read(&s->frame, &s->g, &err)))
        return 0;
    s->radius = *radius ? (float)atof(radius) : s->scene.radius;
    s->row = row;
    return 1;
}

static int trace(struct stage *s, int row)
{
    const int own = !strcmp(cell(row, "truth"), cell(row, "method")), rays = atoi(cell(row, "rays"));
    kit_method m;
    if (!TRY(kit_method_find(&m, cell(row, "truth"), &err))
        || !TRY(kit_method_set(&m, own ? cell(row, "settings") : "", &err))
        || !TRY(kit_method_truth(&s->truth, &m, &s->scene, &s->g.camera, &s->light, s->radius, rays, 1, &err))
        || (measures
            && !TRY(kit_method_truth(&s->finer, &m, &s->scene, &s->g.camera, &s->light, s->radius, FINER * rays, 1,
                                     &err))))
        return 0;
    s->traced = row;
    return 1;
}

/* RMSE of a picture, of light over the truth's mean. */
static int error_of(double *error, const kit_image *picture, const struct stage *s, const char *of)
{
    const int lit = strcmp(of, "visibility") != 0, radiance = !strcmp(of, "radiance");
    const float *seen = kit_image_channel(&s->frame, "Z");
    char name[3][32] = { "Y" };
    const char *const names[3] = { name[0], name[1], name[2] };
    kit_score score, dark;
    kit_image none;
    for (int c = 0; c < 3 && lit; ++c)
        snprintf(name[c], sizeof *name, "%s%s%c", radiance ? "" : of, radiance ? "" : ".", "RGB"[c]);
    if (!TRY(kit_score_channels(&score, picture, &s->truth, names, lit ? 3 : 1, seen, &err))
        || !TRY(kit_image_new(&none, s->truth.width, s->truth.height, lit ? KIT_LIT_CHANNELS : "Y", &err)))
        return 0;
    const int failed = !TRY(kit_score_channels(&dark, &none, &s->truth, names, lit ? 3 : 1, seen, &err));
    kit_image_free(&none);
    *error = score.rmse / (lit ? -dark.bias : 1);
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
    if (!alike(stage.row, now, place, 5)) {
        leave(&stage);
        if (!enter(&stage, now)) return;
    }
    if (!alike(stage.traced, now, traced, 2)) {
        untrace(&stage);
        if (!trace(&stage, now)) return;
    }
    const kit_world world = { &stage.scene, &stage.light };
    if (!TRY(picture_run(&run, &stage.g, &world, cell(now, "method"), cell(now, "settings"), stage.radius, &err)))
        return;
    const int drawn = TRY(picture_settled(&run, 0, 0, &err) < 0) && TRY(kit_run_read(&picture, &run, &err));
    kit_run_close(&run);
    if (!drawn) return;
    const int scored = error_of(&found, &picture, &stage, of);
    kit_image_free(&picture);
    if (!scored) return;
    if (measures) {
        if (error_of(&noise, &stage.finer, &stage, of)) noise /= sqrt(1 + 1.0 / FINER);
        return;
    }
    CHECK(found <= bound, "%s: its error is %.4f, more than %.4f", cell(now, "method"), found, bound);
    CHECK(known <= noisy * bound, "%s: the truth has a noise of %.4f, of a bound of %.4f", cell(now, "method"), known,
          bound);
    t_note("%.4f of %.4f", found, bound);
}

static int rowless;                        /* methods without a row */

/* Each method of build/render --list has a row. */
static void complete(void)
{
    kit_method m;
    for (int i = 0; kit_method_at(&m, i); ++i) {
        int row = 0;
        while (row < rows.rows && strcmp(cell(row, "method"), m.name)) ++row;
        rowless += !CHECK(row < rows.rows, "%s has no row in tests/errors.csv: copy that of its nearest relative",
                          m.name);
    }
}

static void write_row(FILE *f, int row)
{
    for (int k = 0; k < rows.columns; ++k) {
        const char *key = rows.cell[k];
        if (k) fputc(',', f);
        if (!strcmp(key, "error")) fprintf(f, "%.4f", found);
        else if (!strcmp(key, "noise")) fprintf(f, "%.4f", noise);
        else if (!strcmp(key, "bound")) fprintf(f, "%.4f", margin * found);
        else fprintf(f, strchr(cell(row, key), ',') ? "\"%s\"" : "%s", cell(row, key));
    }
    fputc('\n', f);
}

void test_errors(void)
{
    const char *const out = getenv("T_ERRORS"), *const was = csv_folder;
    FILE *f = NULL;
    csv_folder = "tests";
    rows = csv_read("errors.csv");
    csv_folder = was;
    RUN("every method has a bound", complete);
    if (out && rowless) return;            /* before a minute of figures that would be made again */
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
    leave(&stage);
    kit_fields_free();
    kit_gl_close();
}
