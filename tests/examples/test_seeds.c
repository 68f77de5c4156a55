/* test_seeds.c - scenes by seed: the kit's seeds.c, grammar.c, look.c, parts.c; and the basis of charts of many scenes:
   the laboratory's spread.c, units.c. */
#include "owned.h"
#include "t.h"
#include "kit/kit_build.h"
#include "kit/kit_trace.h"
#include "lab/against/compared.h"
#include "lab/against/subjects.h"
#include "lab/chart/sets.h"
#include "lab/measure/spread.h"
#include "lab/page/units.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

enum { LEAST_TRIANGLES = 3000, MOST_TRIANGLES = 300000, SEEDS = 2 * KIT_KINDS };

static uint64_t hash_of(const kit_scene *s)
{
    uint64_t h = kit_hash(KIT_HASH, s->mesh.position, 9 * s->mesh.triangles * sizeof(float));
    h = kit_hash(h, &s->radius, sizeof s->radius);
    return kit_hash(h, s->camera.eye, sizeof s->camera.eye);
}

static int all_finite(const kit_mesh *m)
{
    for (size_t i = 0; i < 9 * m->triangles; ++i) {
        if (!isfinite(m->position[i]) || !isfinite(m->normal[i])) return 0;
        if (i % 3 == 0
            && !(fabsf(m->normal[i] * m->normal[i] + m->normal[i + 1] * m->normal[i + 1]
                       + m->normal[i + 2] * m->normal[i + 2] - 1)
                 < 1e-3f))
            return 0;
    }
    return 1;
}

/* Measures a camera's share of pixels with a hit, and the radius over the picture's height at median depth. */
static void seen(const kit_scene *s, double *share, double *reach)
{
    enum { ACROSS = 48, DOWN = 27 };

    const size_t size = ssgi_trace_size(s->mesh.triangles);
    FREED void *memory = malloc(size);
    float depth[ACROSS * DOWN], origin[3], way[3], ahead[3];
    kit_camera c = s->camera;
    ssgi_trace trace;
    ssgi_hit hit;
    size_t hits = 0;
    c.width = ACROSS;
    c.height = DOWN;
    for (int i = 0; i < 3; ++i) ahead[i] = c.target[i] - c.eye[i];
    const float l = sqrtf(ahead[0] * ahead[0] + ahead[1] * ahead[1] + ahead[2] * ahead[2]);
    ssgi_trace_build(&trace, memory, size, s->mesh.position, 12, NULL, s->mesh.triangles, NULL);
    for (int i = 0; i < ACROSS * DOWN; ++i) {
        kit_camera_ray(&c, i % ACROSS, i / ACROSS, origin, way);
        if (!ssgi_trace_closest(&hit, &trace, origin, way, c.znear, 1e12f)) continue;
        depth[hits++] = hit.t * (way[0] * ahead[0] + way[1] * ahead[1] + way[2] * ahead[2]) / l;
    }
    *share = (double)hits / (ACROSS * DOWN);
    const double at = hits ? (double)kit_middle(depth, hits) : 1;
    *reach = (double)s->radius / (c.fovy > 0 ? 2 * tan((double)c.fovy * KIT_PI / 360) * at : (double)c.ortho_height);
}

/* Checks two seeds of each kind. For seeds from 1000 on the figures are those of gcc's and clang's builds: whoever
   changes a scene changes the charts' scenes, and must change these lines. */
static void scenes(void)
{
    static const struct {
        size_t triangles;
        double sum;
    } was[KIT_KINDS] = { { 174898, 601.519 }, { 151521, 18.3181 }, { 220562, 292.149 }, { 98148, 133.947 },
                         { 179196, 89.3023 }, { 140753, 73.4077 }, { 24904, 98.5105 } };
    uint64_t known[SEEDS];
    int objects = 0, lights = 0;
    for (int n = 0; n < SEEDS; ++n) {
        const int seed = n < KIT_KINDS ? n : 1000 + n - KIT_KINDS;
        char name[64], full[64];
        OWN(kit_scene) s = { 0 }, again = { 0 };
        kit_error err;
        double share, reach, sum = 0;
        snprintf(name, sizeof name, "random:%d", seed);
        snprintf(full, sizeof full, "random:%s:%d", kit_scene_kind(seed % KIT_KINDS, NULL), seed);
        if (!CHECK(!kit_scene_load(&s, name, 0, &err) && !kit_scene_load(&again, full, 0, &err), "%s", err.text))
            return;
        known[n] = hash_of(&s);
        CHECK(known[n] == hash_of(&again), "%s is not %s", name, full);
        for (int i = 0; i < n; ++i) CHECK(known[i] != known[n], "%s: is another one, too", name);
        CHECK(all_finite(&s.mesh), "%s: not finite, or normals are not unit", full);
        CHECK(s.mesh.triangles > LEAST_TRIANGLES && s.mesh.triangles < MOST_TRIANGLES, "%s: %zu triangles", full,
              s.mesh.triangles);
        CHECK(s.env && s.lights >= 0, "%s has no light", full);
        seen(&s, &share, &reach);
        CHECK(share > 0.35 && reach > 0.012 && reach < 0.5,
              "%s shows something on %.2f of its pixels, its radius is %.3f of the height", full, share, reach);
        for (size_t i = 0; i < 9 * s.mesh.triangles; ++i) sum += fabs((double)s.mesh.position[i]);
        sum /= (double)s.mesh.triangles * (double)s.radius;
        CHECK(n < KIT_KINDS || (s.mesh.triangles == was[n - KIT_KINDS].triangles
                                && fabs(sum / was[n - KIT_KINDS].sum - 1) < 1e-4),
              "{ %zu, %.6g }, %s", s.mesh.triangles, sum, name);
        objects += s.objects;
        lights += s.lights;
    }
    CHECK(objects > 10 * SEEDS && lights > 0, "%d objects, %d lights", objects, lights);
}

static void no_seeds(void)
{
    kit_error rows = { "" };
    CHECK(!kit_check_rows(&rows), "%s", rows.text);
    static const char *const bad[][2] = { { "random:", "whole number" },   { "random:-1", "whole number" },
                                          { "random:1x", "whole number" }, { "random:9999999999", "0..999999999" },
                                          { "random:caves:1", "rooms, " }, { "random:rooms:", "whole number" },
                                          { "model:", "no name" },         { "model:bunny:x", "whole number" },
                                          { "random::7", "no name" },
                                          { "model:no such", "catalogue" } };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; ++i) {
        kit_error err = { "" };
        kit_scene s;
        memset(&s, 7, sizeof s);
        const kit_scene before = s;
        CHECK(kit_scene_load(&s, bad[i][0], 0, &err) == -1 && strstr(err.text, bad[i][1])
                  && strstr(err.text, bad[i][0]),
              "%s: \"%s\"", bad[i][0], err.text);
        CHECK(!memcmp(&before, &s, sizeof s), "%s: the scene was touched", bad[i][0]);
    }
}

/* Checks a package's model, in metres as in its catalogue, on the floor of the camera's scene. */
static void models_alone(void)
{
    static const struct { const char *name; double height; } cases[] = {
        { "model:bunny", 0.25 }, { "model:spider:5", 0.9 }, { "model:scopia/bicycle:3", 0.843 }
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        OWN(kit_scene) s = { 0 };
        kit_error err;
        double share, reach;
        if (!CHECK(!kit_scene_load(&s, cases[k].name, 0, &err), "%s", err.text)) return;
        seen(&s, &share, &reach);
        CHECK(s.objects == 2 && all_finite(&s.mesh) && fabs((double)s.mesh.lower[1]) < 1e-6
                  && fabs((double)s.mesh.upper[1] / cases[k].height - 1) < 1e-3 && share > 0.35 && reach > 0.01,
              "%s: %d objects, from %g to %g, seen on %.2f of the picture, radius %.3f of its height", cases[k].name,
              s.objects, (double)s.mesh.lower[1], (double)s.mesh.upper[1], share, reach);
    }
}

/* ---- parts: the area vectors of closed ones add up to 0, and they hold a volume --------------------------------- */

/* Returns the length of the sum of area vectors, over the whole area. */
static double open_share(const kit_mesh *m, double *volume)
{
    double sum[3] = { 0 }, all = 0;
    *volume = 0;
    for (size_t t = 0; t < m->triangles; ++t) {
        double p[3][3], side[2][3], n[3];
        for (size_t i = 0; i < 9; ++i) p[i / 3][i % 3] = (double)m->position[9 * t + i];
        for (int i = 0; i < 6; ++i) side[i / 3][i % 3] = p[1 + i / 3][i % 3] - p[0][i % 3];
        kit_cross(side[0], side[1], n);
        for (int i = 0; i < 3; ++i) sum[i] += n[i];
        all += sqrt(kit_dot(n, n));
        *volume += kit_dot(p[0], n) / 6;
    }
    return sqrt(kit_dot(sum, sum)) / all;
}

static void closed_parts(void)
{
    static const double half[3] = { 0.5, 0.3, 0.4 }, way[4][3] = { { 0, 0, 0 }, { 1, 0, 0 }, { 1, 1, 0 }, { 1, 1, 1 } },
                        outline[5][2] = { { 0.5, 0.5 }, { 0.7, 0 }, { 0.5, -0.5 }, { -0.5, -0.5 }, { -0.5, 0.5 } };
    static const char *const names[] = { "cushion", "bevelled box", "tube", "cable", "prism" };
    static const double volumes[] = { 0.43, 0.45, 0.0942, 0.039, 1.1 }; /* of shapes like these */
    for (int k = 0; k < 5; ++k) {
        kit_build b;
        double volume;
        memset(&b, 0, sizeof b);
        kit_begin_object(&b, names[k], -1);
        const kit_frame before = kit_enter(&b, 1, 2, 3, 90, 2);
        const kit_frame inner = kit_enter(&b, 0, 1, 0, -30, 0.5);
        if (k == 0) kit_cushion(&b, half, 0.2, 12);
        if (k == 1) kit_bevelled(&b, -0.5, -0.3, -0.4, 0.5, 0.3, 0.4, 0.05);
        if (k == 2) kit_tube(&b, way, 4, 0.1, 24);
        if (k == 3) kit_cable(&b, way[0], way[1], 0.2, 0.1, 24);
        if (k == 4) kit_prism(&b, outline, 5, 1);
        kit_leave(&b, inner);
        kit_leave(&b, before);
        const double open = open_share(&b.scene.mesh, &volume);
        CHECK(open < 1e-5 && volume > 0.75 * volumes[k] && volume < 1.25 * volumes[k],
              "%s: %g of its area is open, its volume is %g, not %g", names[k], open, volume, volumes[k]);
        free(b.scene.object);
        kit_mesh_free(&b.scene.mesh);
    }
}

/* ---- many scenes: their mean and its interval ------------------------------------------------------------------- */

/* Checks the statistics of 0.2, 0.4, 0.6, 1.2 and an unknown value: mean 0.6, squares about it 0.56, so the mean's
   standard error is sqrt(0.56 / 3 / 4) = 0.216025. */
static void spreads(void)
{
    static const double value[5] = { 0.4, (double)NAN, 1.2, 0.2, 0.6 };
    const spread all = spread_of(value, 5), alone = spread_of(value, 2);
    CHECK(all.count == 4 && all.above == 1 && all.worst == 2 && fabs(all.mean - 0.6) < 1e-12
              && fabs(all.half - 1.96 * 0.2160247) < 1e-6 && fabs(all.median - 0.5) < 1e-12 && !(all.most < 1.2),
          "of %d: mean %g +- %g, median %g, worst %g, number %d; %d above 1", all.count, all.mean, all.half, all.median,
          all.most, all.worst, all.above);
    CHECK(alone.count == 1 && isnan(alone.half), "of one alone: +- %g", alone.half);
}

/* ---- two builds: their differences, and the rows that are compared ---------------------------------------------- */

enum { ACROSS_DIFFERS = 32, DOWN_DIFFERS = 16 };

/* Returns 1, 1, -1, -1, 1 .. along each row: 32 columns have 31 pairs of neighbours, of which 16 are equal, and 29
   pairs three apart, of which 14 are. Patches of eight columns have mean 0. */
static double stripes(int x, int y) { return (void)y, x & 2 ? -1 : 1; }

/* Returns 1 in the left half, -1 in the right: 1 of 31 pairs of neighbours differs, and 3 of 29 three apart. Of two
   rows of four patches, 1 of three pairs across differs, and none of the four above each other. */
static double halves(int x, int y) { return (void)y, x < ACROSS_DIFFERS / 2 ? 1 : -1; }

static double checks(int x, int y) { return (x + y) & 1 ? -1 : 1; }

static void differences(void)
{
    static const char *const both[2] = { "A", "B" };
    static const struct { const char *name; double (*at)(int x, int y), across[2], down, patches; } cases[] = {
        { "stripes", stripes, { 1.0 / 31, -1.0 / 29 }, 1, 0 },
        { "halves", halves, { 29.0 / 31, 23.0 / 29 }, 1, (1.0 / 3 + 1) / 2 },
        { "checks", checks, { -1, -1 }, -1, 0 }
    };
    static float mask[ACROSS_DIFFERS * DOWN_DIFFERS];
    kit_error err;
    OWN(kit_image) a = { 0 }, b = { 0 };
    compared c;
    if (!CHECK(!kit_image_new(&a, ACROSS_DIFFERS, DOWN_DIFFERS, "A,B", &err)
                   && !kit_image_new(&b, ACROSS_DIFFERS, DOWN_DIFFERS, "B,A", &err), "%s", err.text)) return;
    const int pixels = ACROSS_DIFFERS * DOWN_DIFFERS;
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < pixels; ++i) {
            const double d = 0.125 * cases[k].at(i % ACROSS_DIFFERS, i / ACROSS_DIFFERS);
            for (int n = 0; n < 2; ++n) {
                kit_image_channel(&b, both[n])[i] = (float)(0.5 + n);
                kit_image_channel(&a, both[n])[i] = (float)(0.75 + n + (n ? -d : d));
            }
        }
        CHECK(!compared_of(&c, &a, &b, both, 2, NULL, &err) && c.values == (size_t)(2 * pixels)
                  && fabs(c.bias - 0.25) < 1e-9 && fabs(c.rmse - sqrt(0.25 * 0.25 + 0.125 * 0.125)) < 1e-9,
              "%s: %zu values, bias %g, RMSE %g", cases[k].name, c.values, c.bias, c.rmse);
        CHECK(fabs(c.across[0] - cases[k].across[0]) < 1e-9 && fabs(c.across[1] - cases[k].across[1]) < 1e-9
                  && fabs(c.down[0] - cases[k].down) < 1e-9 && fabs(c.down[1] - cases[k].down) < 1e-9
                  && fabs(c.patches - cases[k].patches) < 1e-9,
              "%s: like itself %g, %g across, %g, %g down, %g from patch to patch", cases[k].name, c.across[0],
              c.across[1], c.down[0], c.down[1], c.patches);
    }
    /* Leaves 25 columns: 16 of value 1 and 9 of value -1, which differ from their mean by 18/25 and -32/25. */
    for (int i = 0; i < pixels; ++i) {
        mask[i] = i % ACROSS_DIFFERS < 25;
        kit_image_channel(&a, "A")[i] = mask[i] > 0 ? (float)halves(i % ACROSS_DIFFERS, 0) : NAN;
    }
    CHECK(!compared_of(&c, &a, &b, both, 1, mask, &err)
              && fabs(c.across[0] - (15 * 324 + 8 * 1024 - 576) / 24.0 / 576) < 1e-9 && fabs(c.down[0] - 1) < 1e-9,
          "halves, a part of them: like itself %g across, %g down", c.across[0], c.down[0]);
    CHECK(!compared_of(&c, &a, &b, both, 1, NULL, &err) && isnan(c.rmse), "NaN pixels: RMSE %g", c.rmse);
}

/* Checks the RMSE of 512 pixels with two channels, of which every fourth has an error of 0.5 in the first picture:
   0.25. The second picture has it at half of those, so its squared error is less by 0.25 at an eighth of the pixels,
   whose deviation is 0.25 sqrt(7 / 64). */
static void errors_by_hand(void)
{
    static const char *const both[2] = { "A", "B" };
    kit_error err;
    kit_image p[3];
    errors e = { 0 };
    const int pixels = ACROSS_DIFFERS * DOWN_DIFFERS;
    for (int k = 0; k < 3; ++k)
        if (!CHECK(!kit_image_new(&p[k], ACROSS_DIFFERS, DOWN_DIFFERS, "A,B", &err), "%s", err.text)) return;
    for (int i = 0; i < 2 * pixels; ++i) {
        p[2].data[i] = 1;
        p[0].data[i] = i % 4 ? 1 : 1.5f;
        p[1].data[i] = i % 8 ? 1 : 0.5f;
    }
    const double second = 0.5 * sqrt(1.0 / 8), doubt = 0.25 * sqrt(7.0 / 64 / pixels) / (0.25 + second);
    CHECK(!errors_of(&e, (const kit_image *const[]){ &p[0], &p[1] }, &p[2], both, 2, NULL, &err)
              && fabs(e.rmse[0] - 0.25) < 1e-9 && fabs(e.rmse[1] - second) < 1e-9 && fabs(e.doubt - doubt) < 1e-9,
          "errors of %g and %g, %g in doubt, which should be %g", e.rmse[0], e.rmse[1], e.doubt, doubt);
    for (int k = 0; k < 3; ++k) kit_image_free(&p[k]);
}

/* Checks that each row has a method that exists, settings that it accepts, and a frame with the inputs of both. Rows of
   one picture follow each other. */
static void subjects_sound(void)
{
    kit_method m;
    kit_error err = { "" };
    subjects_load();
    for (int i = 0; i < subjects_count; ++i) {
        const subject *u = &subjects[i];
        const int method = !kit_method_find(&m, u->method, &err) && !kit_method_set(&m, u->settings, &err)
                        && !kit_method_set(&m, u->new_alone, &err);
        CHECK(method, "%s: %s", u->name, err.text);
        CHECK(method && m.lit == quantities[u->quantity].lit, "%s: %s is not what %s draws", u->name,
              quantities[u->quantity].word, u->method);
        CHECK(m.set.thickness < SSGI_GL_THICKNESS_BACK || u->view == SLABS, "%s: its frame has no back faces", u->name);
        for (int k = 0; k < i; ++k) {
            const int same = !strcmp(subjects[k].name, u->name);
            CHECK(!same || (k + (u->quantity - subjects[k].quantity) == i && !strcmp(subjects[k].method, u->method)
                            && !strcmp(subjects[k].settings, u->settings) && subjects[k].view == u->view),
                  "%s: is the name of two pictures", u->name);
        }
    }
}

/* Checks that the chart's rows can be drawn, as one that cannot would be found after an hour, and that sets have rows. */
static void rows_sound(void)
{
    static const char *const sections[] = { "ao-demo", "lit-demo", "lit", "fields-demo", "fields", "deep-demo", "deep" };
    const options all = { .quick = 1 };
    const set *t;
    entry some[MOST_ENTRIES];
    kit_method m;
    kit_error err = { "" };
    const entry *e;
    int k = 0;
    units_load();
    for (; (e = units_row(k)) != NULL; ++k)
        CHECK(!kit_method_find(&m, e->method, &err) && !kit_method_set(&m, e->settings, &err), "%s: %s", e->label,
              err.text);
    CHECK(k > 200 && units_chosen(some, "ao-demo", &all) == 5 && !strcmp(some[4].method, "hsao-march"), "%d rows", k);
    for (int i = 0; i < COUNT(sections); ++i) {
        CHECK(set_of(sections[i], 0) != NULL, "%s: has no sets", sections[i]);
        for (k = 0; (t = set_of(sections[i], k)) != NULL; ++k)
            CHECK(!t->see || units_chosen(some, t->rows, &all), "%s: set %d has no rows", sections[i], k + 1);
    }
}

static int measured;

static int one_row(FILE *html, const options *o, int k, row *rows, kit_error *err)
{
    char name[16];
    (void)o, (void)err;
    if (!rows) return 1;
    ++measured;
    snprintf(name, sizeof name, "part %d", k);
    fputs(name, html);
    rows[0] = row_blank(OF_AO, "a scene", "a label", "ssao", "directions=8");
    rows[0].share = k;
    return 1;
}

/* Measures a chart of so many units, or continues it. Returns whether each unit has the rows that were measured. */
static int charted(const options *o, int count)
{
    int good = 1;
    units_begin(o, count);
    for (int k = 0; k < count && good; ++k) {
        char text[64] = "", wanted[16];
        FILE *html = fmemopen(text, sizeof text, "w");
        row r;
        snprintf(wanted, sizeof wanted, "part %d", k);
        good = units_measure(html, o, "test-seed", k, one_row, &r, NULL) == 1 && !strcmp(r.label, "a label")
            && !strcmp(r.settings, "directions=8") && fabs(r.share - k) < 1e-9;
        fclose(html);
        good = good && !strcmp(text, wanted);
    }
    return good;
}

static void units_resumed(void)
{
    static const struct { int count, measured, whole; } charts[] = { { 2, 2, 0 }, { 3, 3, 1 }, { 1, 4, 1 } };
    char out[32];
    kit_error err;
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    snprintf(out, sizeof out, "of process %d", (int)getpid()); /* of this process alone */
    const options o = { .out = out };
    measured = 0;
    for (int i = 0; i < 3; ++i) {
        CHECK(charted(&o, charts[i].count) && measured == charts[i].measured, "chart %d of %d units: %d measured", i,
              charts[i].count, measured);
        if (charts[i].whole) units_end();
    }
    kit_gl_close();
}

void test_seeds(void)
{
    RUN("scenes by seed are those that charts were drawn of: finite, of a size, the camera sees them, the radius fits",
        scenes);
    RUN("models of packages: as large as their catalogues say, on a floor, seen", models_alone);
    RUN("all that rows name is there; a seed that is none: what is wrong is told, the scene is untouched", no_seeds);
    RUN("what they are built of is closed, faces outwards and holds its volume, in frames within frames", closed_parts);
    RUN("what many scenes say together: mean, interval, median, worst from known numbers", spreads);
    RUN("pictures apart: RMSE, bias and what is like itself, worked out by hand", differences);
    RUN("how far the pixels of a truth leave it in doubt which of two pictures errs more", errors_by_hand);
    RUN("rows that two builds are compared by can be drawn", subjects_sound);
    RUN("rows of charts are of methods that there are, with settings that they take", rows_sound);
    RUN("a chart of seeds that was interrupted goes on from what it measured", units_resumed);
}
