/* fields.c - what report.c shows of ambient occlusion fields: pictures for the demo; what resolution buys, what
   occluders cost, what bakes take, how two occluders add up. Declared in report.h. */
#include "lab/report.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

/* Where an object of "casters" is put; a view of what is rigid. spot: all other objects are hidden in the ground (none:
   all stay). box: added, cast nothing. */
typedef struct spot { const char *name; float size, at[3]; } spot;
typedef struct setup {
    view   view;
    spot   spot[2];
    float  box[3][6];
    double time;                           /* of kit_scene_move */
    int    rays;
} setup;

#define AOF(label, settings, quick) { label, "aof", settings, quick }
#define WHOLE(name, scene)  { name, scene, 0, { 0 }, { 0 }, 0, 0, NULL }
#define CLOSE(name)         { name, "casters", 0, { 1.5f, 2.3f, 3.3f }, { 0, 0.35f, 0 }, 34, 0, NULL }
#define NO_BOXES            { { 0 } }
#define NO_SPOTS            { { NULL, 0, { 0 } } }

static const entry moving_entries[]   = { AOF("casters", "resolution=8", 1) };
static const entry pedestal_entries[] = { AOF("4 x 4", "resolution=4", 1), AOF("8 x 8", "resolution=8", 1) };
static const entry sunk_entries[] = { AOF("A_0 as measured", "resolution=8", 1),
                                      AOF("A_0 = 1, p = 2", "resolution=8,inside=1,power=2", 1) };

typedef struct field_part {
    const char *title, *about;
    setup setup;
    const entry *entries;
    int count, crop[MOST_CROPS][4];
} field_part;
#define MOVING(name, time) \
    { WHOLE(name, "casters"), NO_SPOTS, NO_BOXES, time, 128 }, moving_entries, COUNT(moving_entries), \
    { \
        { \
            0 \
        } \
    }
static const field_part field_parts[] = {
    { "Fields: occluders that move",
      "Cubes, balls, tori, cones and tables, one field a shape, of 8 x 8 texels a face. At rest,",
      MOVING("occluders-0", 0) },
    { NULL, "a third of a period later,", MOVING("occluders-1", 1 / 3.0) },
    { "Fields: how many texels",
      "The bunny on a box before a wall, its field of 4 x 4 and of 8 x 8 texels a face.",
      { { "pedestal", BUNNY, 0, { -1.9f, 0.9f, 4.3f }, { 0, -0.25f, 0 }, 34, 0, NULL },
        NO_SPOTS,
        { { -1.3f, -1.6f, -0.9f, 1.3f, -0.99f, 1.1f },
          { -5, -1.6f, -1.3f, 5, 3, -1.2f },
          { -5, -1.8f, -1.3f, 5, -1.6f, 6 } },
        0,
        256 },
      pedestal_entries,
      COUNT(pedestal_entries),
      { { 108, 114, 107, 54 }, { 70, 4, 107, 54 } } },
    { "Fields: inside of the hull",
      "A table and a torus, half of each in the ground: between a table's legs, and in a ring, there is ground inside "
      "of the convex hull, where occlusion goes to A_0.",
      { { "sunk", "casters", 0, { 0.6f, 2.6f, 3.6f }, { 0, 0, 0.1f }, 34, 0, NULL },
        { { "torus", 1.4f, { 1, 0.05f, 0.1f } }, { "table", 1.6f, { -0.7f, 0.02f, 0 } } },
        NO_BOXES,
        0,
        128 },
      sunk_entries,
      COUNT(sunk_entries),
      { { 0 } } }
};
static const char *const field_demo_title = "Ambient occlusion fields";
enum { FIELD_PARTS = COUNT(field_parts),
    FIELD_DEMO_ROWS = 2 * COUNT(moving_entries) + COUNT(pedestal_entries) + COUNT(sunk_entries) };

static const entry field_entries[] = { /* rows of one label make one curve */
                                       AOF("field", "resolution=4", 1), AOF("field", "resolution=8", 1),
                                       AOF("field", "resolution=16", 1)
};
typedef struct field_scene { const char *title; setup setup; const char *curve; } field_scene;
static const field_scene field_scenes[] = {
    { "Ball on a ground",
      { CLOSE("ball-on-ground"), { { "ball", 1, { 0, 0.501f, 0 } } }, NO_BOXES, 0, 512 },
      "ball" },
    { "Cube on a ground",
      { CLOSE("cube-on-ground"), { { "cube", 1, { 0, 0.501f, 0 } } }, NO_BOXES, 0, 512 },
      "cube" },
    { "Bunny on a floor",
      { { "bunny-on-floor", BUNNY, 1, { -1.4f, 1.1f, 3.7f }, { 0, -0.13f, 0 }, 33, 0, NULL },
        NO_SPOTS,
        NO_BOXES,
        0,
        512 },
      "bunny" },
    { "Two dozen occluders", { WHOLE("casters", "casters"), NO_SPOTS, NO_BOXES, 0, 512 }, NULL }
};

/* occluders: so many objects from the scene's first on that are no ground; 0: as the scene has it; -1: a cube with the
   occluder's bounding sphere in its place. */
typedef struct cost { const char *label, *settings; int occluders; float size; int quick; } cost;
static const cost of_triangles[] = { { "bunny, 69,000 triangles", "", 0, 0, 1 },
                                     { "cube, 12 triangles", "", -1, 0, 1 } };
static const cost of_pixels[] = { { "one ball, size 2", "", 0, 2, 0 },
                                  { "one ball, size 1", "", 0, 1, 1 },
                                  { "one ball, size 1/2", "", 0, 0.5f, 0 },
                                  { "one ball, size 1/4", "", 0, 0.25f, 1 },
                                  { "one ball, size 1/8", "", 0, 0.125f, 0 } };
static const cost of_occluders[] = { { "1 occluder", "", 1, 0, 1 },
                                     { "10 occluders", "", 10, 0, 1 },
                                     { "24 occluders", "", 24, 0, 1 },
                                     { "100 occluders", "", 100, 0, 1 },
                                     { "100 occluders", "reach=4", 100, 0, 0 } };
static const struct { setup setup; const cost *costs; int count;
} cost_sets[] = {
    { { { "bunny-on-floor", BUNNY, 1, { -1.4f, 1.1f, 3.7f }, { 0, -0.13f, 0 }, 33, 0, NULL },
        NO_SPOTS,
        NO_BOXES,
        0,
        16 },
      of_triangles,
      COUNT(of_triangles) },
    { { CLOSE("ball-on-ground"), { { "ball", 1, { 0, 0.501f, 0 } } }, NO_BOXES, 0, 16 }, of_pixels, COUNT(of_pixels) },
    { { WHOLE("crowd", "crowd"), NO_SPOTS, NO_BOXES, 0, 16 }, of_occluders, COUNT(of_occluders) }
};

/* triangles: of a lumpy ball; 0: the label's first word names the shape. threads: 0 = one a core. */
typedef struct bake { const char *label, *settings; int triangles, threads, quick; } bake;
static const bake bakes[] = {
    { "lumpy ball", "", 1000, 0, 1 },
    { "lumpy ball", "", 10000, 0, 0 },
    { "lumpy ball", "", 100000, 0, 0 },
    { "lumpy ball", "", 10000, 1, 0 },
    { "lumpy ball", "resolution=4", 10000, 0, 0 },
    { "lumpy ball", "resolution=8", 10000, 0, 1 },
    { "lumpy ball", "rays=32", 10000, 0, 1 },
    { "lumpy ball", "rays=64", 10000, 0, 0 },
    { "lumpy ball", "rays=256", 10000, 0, 0 },
    { "bunny", "", 0, 1, 0 },
    { "bunny", "", 0, 0, 0 },
};

static const struct { const char *label[2]; setup setup;
} pairs[] = { { { "balls, each traced", "balls, each by its field" },
                { CLOSE("two-balls"),
                  { { "ball", 1, { -0.6f, 0.501f, 0 } }, { "ball", 1, { 0.6f, 0.501f, 0 } } },
                  NO_BOXES,
                  0,
                  256 } },
              { { "cubes, each traced", "cubes, each by its field" },
                { CLOSE("two-cubes"),
                  { { "cube", 1, { -0.6f, 0.501f, 0 } }, { "cube", 1, { 0.6f, 0.501f, 0 } } },
                  NO_BOXES,
                  0,
                  256 } } };

enum {
    FIELD_SCENES = COUNT(field_scenes),
    COST_SET = FIELD_SCENES,
    BAKE_SET,
    PAIR_SET,
    FIELD_SETS,
    MOST_FIELD_ROWS = 32,
    COST_WIDTH = 640,
    COST_HEIGHT = 360
};
typedef struct field_row_set { const char *title; row row[MOST_FIELD_ROWS]; int count; } field_row_set;
static row demo_rows[FIELD_DEMO_ROWS];
static field_row_set sets[FIELD_SETS];

/* ---- >>measuring ------------------------------------------------------------------------------------------------- */

static void place_at(float to_world[16], float size, const float at[3])
{
    memset(to_world, 0, 16 * sizeof *to_world);
    for (int k = 0; k < 3; ++k) to_world[5 * k] = size;
    memcpy(to_world + 12, at, 3 * sizeof *at);
    to_world[15] = 1;
}

/* What shows the object is not scored: it is not shaded by itself. */
static int leave_out(stage *s, int object, kit_error *err)
{
    const int width = s->gbuffer.width, height = s->gbuffer.height;
    float *z = kit_image_channel(&s->frame, "Z");
    uint32_t *shown = malloc((size_t)width * (size_t)height * sizeof *shown);
    GLuint framebuffer;
    if (!shown) return kit_fail(err, "out of memory");
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, s->gbuffer.object, 0);
    glReadPixels(0, 0, width, height, GL_RED_INTEGER, GL_UNSIGNED_INT, shown);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
            if (shown[(size_t)(height - 1 - y) * (size_t)width + (size_t)x] == (uint32_t)object + 1)
                z[(size_t)y * (size_t)width + (size_t)x] = 0;
    free(shown);
    return 0;
}

static int field_open(stage *s, const setup *f, int width, int height, kit_error *err)
{
    static const float hidden[3] = { 0, -0.1f, 0 }, grey[3] = { 0.72f, 0.72f, 0.7f };
    float to_world[16];
    int spots = 0, occluders = 0, last = 0;
    if (stage_load(s, &f->view, err)) return -1;
    const int own = s->scene.objects;
    kit_scene_move(&s->scene, f->time);
    for (int i = 0; i < COUNT(f->box) && f->box[i][4] > f->box[i][1]; ++i)
        if (kit_scene_add_box(&s->scene, f->box[i], f->box[i] + 3, grey, err)) return -1;
    for (int i = 0; i < s->scene.objects; ++i) {
        kit_object *o = &s->scene.object[i];
        const spot *at = spots < COUNT(f->spot) ? &f->spot[spots] : NULL;
        if (i >= own) o->casts = 0;
        if (!o->casts || !f->spot[0].name) continue;
        o->casts = at && at->name && !strcmp(at->name, o->name);
        spots += o->casts;
        place_at(to_world, o->casts ? at->size : 1e-3f, o->casts ? at->at : hidden);
        if (kit_scene_place(&s->scene, i, to_world, err)) return -1;
    }
    s->between = 1;
    s->rays = f->rays;
    if (stage_show(s, &f->view, width, height, err)) return -1;
    for (int i = 0; i < s->scene.objects; ++i) if (s->scene.object[i].casts) { ++occluders; last = i; }
    return occluders == 1 ? leave_out(s, last, err) : 0;
}

row blank(int of, const char *scene, const char *label, const char *settings)
{
    const double none = (double)NAN;
    row r = { .scene = scene,
              .label = label,
              .method = "aof",
              .settings = settings,
              .fetches = none,
              .bytes = none,
              .relative = none,
              .ms = none,
              .share = none,
              .score = { none, none, none, none, 0 },
              .of = of };
    for (int k = 0; k < FIGURES; ++k) r.figure[k] = none;
    return r;
}

static int desc_of(ssgi_field_desc *d, const char *settings, kit_error *err)
{
    kit_method m;
    if (kit_method_find(&m, "aof", err) || kit_method_set(&m, settings, err)) return -1;
    *d = kit_method_field(&m);
    return 0;
}

/* Adds a bake to a row that is blank or has others: memory and time add up, of errors the worst stays. */
static int baked(row *r, const kit_mesh *shape, const ssgi_field_desc *d, kit_error *err)
{
    double seconds;
    const ssgi_field *f = kit_field(shape, d, &seconds, err);
    if (!f) return -1;
    r->figure[TRIANGLES] = fmax(r->figure[TRIANGLES], (double)shape->triangles);
    r->figure[RESOLUTION] = f->resolution;
    r->figure[RADII] = f->radii;
    r->figure[BAKE_RAYS] = d->rays;
    r->figure[WORK] = fmax(r->figure[WORK], 1e-6 * (double)ssgi_field_bake_size(d, shape->triangles));
    r->figure[BYTES] = fmax(r->figure[BYTES], 0) + 1e-3 * (double)ssgi_field_size(f->resolution);
    r->figure[SECONDS] = fmax(r->figure[SECONDS], 0) + seconds;
    r->figure[BAKED_MEDIAN] = fmax(r->figure[BAKED_MEDIAN], (double)f->median);
    r->figure[BAKED_P95] = fmax(r->figure[BAKED_P95], (double)f->p95);
    r->figure[BAKED_MOST] = fmax(r->figure[BAKED_MOST], (double)f->max_error);
    return 0;
}

static int casts(const kit_scene *scene, int shape)
{
    for (int i = 0; i < scene->objects; ++i) if (scene->object[i].casts && scene->object[i].shape == shape) return 1;
    return 0;
}

/* Occlusions and their fields: fills a row an entry, and one of no AO, beside the entries' pictures. */
static int field_measure(row *rows, stage *s, const entry *entries, int count, kit_image *picture, kit_error *err)
{
    const float *z = kit_image_channel(&s->frame, "Z");
    const size_t pixels = (size_t)s->truth.width * (size_t)s->truth.height;
    double *off = malloc(pixels * sizeof *off);
    if (!off) return kit_fail(err, "out of memory");
    if (measure(rows, s, entries, count, QUICK_ROUNDS, 0, picture, err)) return -1;
    for (int i = 0; i <= count; ++i) {
        const kit_image *shown = i < count ? &picture[i] : &s->given[0].picture;
        size_t n = 0;
        ssgi_field_desc d;
        for (int k = 0; k < FIGURES; ++k) rows[i].figure[k] = (double)NAN;
        for (size_t k = 0; k < pixels; ++k) if (z[k] > 0) off[n++] = fabs((double)(shown->data[k] - s->truth.data[k]));
        rows[i].figure[MEDIAN] = kit_median(off, (int)n);
        rows[i].figure[MOST] = off[n - 1];
        if (i == count || desc_of(&d, entries[i].settings, err)) continue;
        for (int k = 0; k < s->scene.shapes; ++k)
            if (casts(&s->scene, k) && baked(&rows[i], &s->scene.shape[k], &d, err)) return -1;
    }
    free(off);
    return 0;
}

/* What stands under a heading, and how far the truth itself is off, by tracing some of it with more rays. */
static int field_about(FILE *html, stage *s, const char *text, kit_error *err)
{
    kit_image probe;
    row noise;
    if (trace(&probe, s, 8 * s->rays, 13, err) || score(&noise, s, &probe, err)) return -1;
    kit_image_free(&probe);
    fprintf(html, "<p>%s %zu triangles, %d x %d pixels. Truth: %d rays a pixel; its own error: %.5f.</p>\n", text,
            s->scene.mesh.triangles, s->truth.width, s->truth.height, s->rays, noise.score.rmse);
    return 0;
}

/* ---- >>demo ------------------------------------------------------------------------------------------------------ */

/* What white light from everywhere leaves of the colours. */
static int dimmed(kit_image *out, const stage *s, const kit_image *visibility, kit_error *err)
{
    static const char *const names[3] = { "albedo.R", "albedo.G", "albedo.B" };
    const size_t pixels = (size_t)s->frame.width * (size_t)s->frame.height;
    if (kit_image_new(out, s->frame.width, s->frame.height, "R,G,B", err)) return -1;
    for (size_t c = 0; c < 3; ++c)
        for (size_t i = 0; i < pixels; ++i)
            out->data[c * pixels + i] = kit_image_channel(&s->frame, names[c])[i] * visibility->data[i];
    return 0;
}

int field_demo(FILE *html, const char *out, kit_error *err)
{
    row *rows = demo_rows;
    enum { TIMES = 3 };
    const double range = 0.2;
    for (int k = 0; k < FIELD_PARTS; ++k) {
        const field_part *part = &field_parts[k];
        row all[MOST_ENTRIES + 1];
        kit_image picture[MOST_ENTRIES], whole[1 + MOST_ENTRIES], crop, difference;
        char slug[1 + MOST_ENTRIES][128], name[160], note[64];
        stage s;
        if (field_open(&s, &part->setup, 320, 180, err)) return -1;
        if (field_measure(all, &s, part->entries, part->count, picture, err)) return -1;
        if (part->title) fprintf(html, "<h2>%s</h2>\n", part->title);
        if (field_about(html, &s, part->about, err)) return -1;
        fputs("<div class=\"grid\">\n", html);
        for (int i = 0; i <= part->count; ++i) {
            const row *r = &all[i - !!i];
            const kit_image *from = i ? &picture[i - 1] : &s.truth;
            snprintf(slug[i], sizeof slug[i], "aof-%s-", part->setup.view.name);
            slug_of(slug[i] + strlen(slug[i]), i ? r->label : "truth");
            if (i) snprintf(note, sizeof note, "time %.2f, RMSE %.4f", r->relative, r->score.rmse);
            else snprintf(note, sizeof note, "%d rays a pixel", s.rays);
            if (dimmed(&whole[i], &s, from, err) || save(&whole[i], "R,G,B", 1, out, slug[i], ".png", err)) return -1;
            if (kit_image_difference(&difference, from, &s.truth, "Y", (float)range, err)
                || (i && save(&difference, "R,G,B", 0, out, slug[i], "-difference.png", err)))
                return -1;
            figure_html(html, slug[i], i ? r->label : "ray-traced truth", note, from->width, from->height, i > 0);
            if (!i) key_html(html, range);
            fputs("</figure>\n", html);
            kit_image_free(&difference);
        }
        fputs("</div>\n", html);
        for (int j = 0; j < MOST_CROPS && part->crop[j][2]; ++j) {
            fputs("<div class=\"grid crops\">\n", html);
            for (int i = 0; i <= part->count; ++i) {
                snprintf(name, sizeof name, "%s-crop%s", slug[i], j ? "-2" : "");
                if (exposed(&crop, &whole[i], 1, part->crop[j], TIMES, err)
                    || save(&crop, "R,G,B", 1, out, name, ".png", err))
                    return -1;
                figure_html(html, name, i ? all[i - 1].label : "ray-traced truth", "", crop.width, crop.height, 0);
                fputs("</figure>\n", html);
                kit_image_free(&crop);
            }
            fputs("</div>\n", html);
        }
        for (int i = 0; i < part->count; ++i, ++rows) {
            *rows = all[i];
            rows->scene = part->setup.view.name;
            kit_image_free(&picture[i]);
        }
        for (int i = 0; i <= part->count; ++i) kit_image_free(&whole[i]);
        if (k + 1 == FIELD_PARTS || field_parts[k + 1].title) {
            fputs("<h3>Figures</h3>\n", html);
            table_html(html, all, part->count + 1);
        }
        stage_close(&s);
    }
    return 0;
}

void field_demo_text(FILE *f)
{
    fprintf(f, "\n%s\n", field_demo_title);
    table_text(f, demo_rows, FIELD_DEMO_ROWS);
}

/* ---- >>chart ----------------------------------------------------------------------------------------------------- */

static int accuracy_of(FILE *html, const field_scene *f, const options *o, row *rows, kit_error *err)
{
    const int count = COUNT(field_entries);
    kit_image picture[COUNT(field_entries)];
    stage s;
    if (field_open(&s, &f->setup, 240, 135, err) || field_measure(rows, &s, field_entries, count, picture, err)
        || field_about(html, &s, "", err))
        return -1;
    if (thumbs(html, o->out, &s, rows, picture, count, err)) return -1;
    for (int i = 0; i <= count; ++i) rows[i].scene = f->setup.view.name;
    for (int i = 0; i < count; ++i) kit_image_free(&picture[i]);
    stage_close(&s);
    return count + 1;
}

/* Points of the chart of error against memory. */
static void curve_of(row *curve, int *points, const field_scene *f, const row *rows, int count)
{
    for (int i = 0; i + 1 < count; ++i) {                       /* the last is no field's */
        if (!f->curve) continue;
        curve[*points] = rows[i];
        curve[*points].label = f->curve;
        curve[*points].relative = rows[i].figure[BYTES];
        curve[*points].fetches = rows[i].figure[RESOLUTION];
        curve[(*points)++].share = 100 * rows[i].score.rmse;
    }
}

/* Who casts, after the G-buffer was drawn: that stays as it is. */
static int cast_by(stage *s, const cost *c, const ssgi_field_desc *d, kit_error *err)
{
    static const float grey[3] = { 0.7f, 0.7f, 0.7f };
    int one = 0;
    for (int i = 1; i < s->scene.objects && c->occluders > 0; ++i) s->scene.object[i].casts = i <= c->occluders;
    while (!s->scene.object[one].casts) ++one;
    if (c->size > 0) {
        const float at[3] = { 0, 0.5f * c->size + 0.001f, 0 };
        float to_world[16];
        place_at(to_world, c->size, at);
        if (kit_scene_place(&s->scene, one, to_world, err)) return -1;
    }
    if (c->occluders < 0) {
        const ssgi_field *f = kit_field(&s->scene.shape[s->scene.object[one].shape], d, NULL, err);
        float lower[3], upper[3];
        for (int k = 0; k < 3 && f; ++k) {
            lower[k] = f->centre[k] - f->radius * 0.57735f;
            upper[k] = f->centre[k] + f->radius * 0.57735f;
        }
        if (!f || kit_scene_add_box(&s->scene, lower, upper, grey, err)) return -1;
        for (int i = 0; i < s->scene.objects; ++i) s->scene.object[i].casts = i + 1 == s->scene.objects;
    }
    return 0;
}

static int costs_of(row *all, int quick, kit_error *err)
{
    int sum = 0;
    for (int k = 0; k < COUNT(cost_sets); ++k) {
        kit_run run[COUNT(of_occluders)];
        row *const rows = all + sum;
        int count = 0;
        stage s;
        if (field_open(&s, &cost_sets[k].setup, COST_WIDTH, COST_HEIGHT, err)) return -1;
        for (int i = 0; i < cost_sets[k].count; ++i) {
            const cost *c = &cost_sets[k].costs[i];
            ssgi_field_desc d;
            if (quick && !c->quick) continue;
            rows[count] = blank(OF_COST, cost_sets[k].setup.view.name, c->label, c->settings);
            if (desc_of(&d, c->settings, err) || cast_by(&s, c, &d, err)
                || kit_fields_cover(&rows[count].figure[COVERED], &s.frame, &s.gbuffer.camera, &s.scene, &d, err))
                return -1;
            if (run_open(&run[count], &s, "aof", c->settings, s.radius, err)) return -1;
            kit_run_draw(&run[count++], 1);
        }
        if (clock_runs(rows, &s, run, count, quick ? QUICK_ROUNDS : CHART_ROUNDS, err)) return -1;
        sum += count;
        stage_close(&s);
    }
    return sum;
}

/* Positions alone, of so many triangles or a few less. */
static int lumpy_ball(kit_mesh *mesh, int triangles, kit_error *err)
{
    const int n = (int)(sqrt(triangles) / 2);
    memset(mesh, 0, sizeof *mesh);
    mesh->triangles = 4 * (size_t)n * (size_t)n;
    mesh->position = malloc(9 * mesh->triangles * sizeof(float));
    if (!mesh->position) return kit_fail(err, "out of memory");
    for (int k = 0; k < 12 * n * n; ++k) {                      /* two triangles a cell, of 2n x n */
        static const int corner[6][2] = { { 0, 0 }, { 1, 0 }, { 1, 1 }, { 0, 0 }, { 1, 1 }, { 0, 1 } };
        const int cell = k / 6;
        const double a = acos(-1) * (cell % (2 * n) + corner[k % 6][0]) / n,
                     b = acos(-1) * (cell / (2 * n) + corner[k % 6][1]) / n,
                     r = 0.5 + 0.1 * sin(b) * sin(4 * a) * sin(5 * b);
        mesh->position[3 * k]     = (float)(r * sin(b) * cos(a));
        mesh->position[3 * k + 1] = (float)(r * cos(b));
        mesh->position[3 * k + 2] = (float)(r * sin(b) * sin(a));
    }
    return 0;
}

static int bakes_of(row *rows, int quick, kit_error *err)
{
    int count = 0;
    kit_scene occluders, bunny;
    const kit_mesh *cube = NULL;
    const char *threads = getenv("KIT_THREADS");
    char *was = threads ? strdup(threads) : NULL;
    if (kit_scene_load(&occluders, "casters", 0, err) || kit_scene_load(&bunny, BUNNY, 0, err)) return -1;
    for (int i = 0; i < occluders.objects && !cube; ++i)
        if (!strcmp(occluders.object[i].name, "cube")) cube = &occluders.shape[occluders.object[i].shape];
    for (int i = 0; i < COUNT(bakes); ++i) {
        const bake *b = &bakes[i];
        row *r = &rows[count];
        ssgi_field_desc d;
        kit_mesh ball = { 0 };
        if (quick && !b->quick) continue;
        *r = blank(OF_BAKE, "bake", b->label, b->settings);
        kit_fields_free();                                      /* all are baked anew, for their times */
        if (b->threads) setenv("KIT_THREADS", "1", 1);
        if (desc_of(&d, b->settings, err) || (b->triangles && lumpy_ball(&ball, b->triangles, err))) return -1;
        if (baked(r, b->triangles ? &ball : *b->label == 'c' ? cube : bunny.shape, &d, err)) return -1;
        if (was) setenv("KIT_THREADS", was, 1); else unsetenv("KIT_THREADS");
        r->figure[THREADS] = b->threads ? b->threads : was ? atoi(was) : (double)sysconf(_SC_NPROCESSORS_ONLN);
        free(ball.position);
        ++count;
    }
    free(was);
    kit_scene_free(&occluders);
    kit_scene_free(&bunny);
    return count;
}

/* Two occluders' visibilities, each alone, against that of both. */
static void combined(row *r, const stage *s, const kit_image *each)
{
    const double tolerance = 0.002;                             /* the truth's own error */
    const float *z = kit_image_channel(&s->frame, "Z");
    double square[3] = { 0 };
    size_t n = 0, between = 0;
    for (int i = 0; i < s->truth.width * s->truth.height; ++i) {
        const double a = 1 - (double)each[0].data[i], b = 1 - (double)each[1].data[i],
                     is = 1 - (double)s->truth.data[i], by[3] = { 1 - (1 - a) * (1 - b), fmax(a, b), fmin(a + b, 1) };
        if (!(z[i] > 0)) continue;
        for (int k = 0; k < 3; ++k) square[k] += (by[k] - is) * (by[k] - is);
        between += is > by[1] - tolerance && is < by[2] + tolerance;
        ++n;
    }
    for (int k = 0; k < 3; ++k) r->figure[BY_PRODUCT + k] = sqrt(square[k] / (double)n);
    r->figure[BETWEEN] = (double)between / (double)n;
}

static int pairs_of(row *rows, kit_error *err)
{
    int count = 0;
    for (int k = 0; k < COUNT(pairs); ++k) {
        kit_image each[2][2];                                   /* traced, by its field */
        int one = 0, other;
        stage s;
        if (field_open(&s, &pairs[k].setup, 240, 135, err)) return -1;
        while (!s.scene.object[one].casts) ++one;
        for (other = one + 1; !s.scene.object[other].casts;) ++other;
        for (int i = 0; i < 2; ++i) {
            kit_run run;
            s.scene.object[one].casts = !i;
            s.scene.object[other].casts = i;
            if (trace(&each[0][i], &s, s.rays, 1, err) || run_open(&run, &s, "aof", "", s.radius, err)) return -1;
            kit_run_draw(&run, 0);
            if (kit_run_read(&each[1][i], &run, err)) return -1;
            kit_run_close(&run);
        }
        for (int i = 0; i < 2; ++i) {
            row *r = &rows[count++];
            *r = blank(OF_PAIR, pairs[k].setup.view.name, pairs[k].label[i], "");
            combined(r, &s, each[i]);
            for (int j = 0; j < 2; ++j) kit_image_free(&each[i][j]);
        }
        stage_close(&s);
    }
    return count;
}

static const char *field_title(int k)
{
    return k < FIELD_SCENES ? field_scenes[k].title
           : k == COST_SET  ? "Fields: what occluders cost"
           : k == BAKE_SET  ? "Fields: what a bake takes"
                            : "Fields: two occluders";
}

static int field_unit(FILE *html, const options *o, int k, row *rows, kit_error *err)
{
    static const char *const about[] = {
        "Who casts changes, the picture does not: the cube has the bunny's bounding sphere; sizes of the ball stand "
        "for distances. Times are of the pass alone. Covered: pixels within the occluders' reach, "
        "each occluder's; a software rasteriser works for all pixels of the rectangles around those spheres.",
        "All cores, or one. Errors are of occlusion at receivers that took no part in the bake. Error within: the "
        "smallest resolution, up to 16, and the fewest radii, up to 12, with which 95 % of them are; else the most of "
        "both.",
        "Two occluders by each other on a ground, one's occlusion a, the other's b, and what both take together. "
        "Between: 0.002 are for noise."
    };
    if (!asked(o, "aof") || (o->quick && (k == FIELD_SCENES - 1 || k == PAIR_SET))) return 0;
    if (!rows) return 1;
    if (!k) fputs("<h2>Fields: error against memory</h2>\n", html);
    fprintf(html, "<h%d>%s</h%d>\n", k < FIELD_SCENES ? 3 : 2, field_title(k), k < FIELD_SCENES ? 3 : 2);
    if (k == COST_SET) fprintf(html, "<p>%d x %d pixels. ", COST_WIDTH / thrift, COST_HEIGHT / thrift);
    if (k >= FIELD_SCENES) fprintf(html, "%s%s</p>\n", k == COST_SET ? "" : "<p>", about[k - FIELD_SCENES]);
    return k < FIELD_SCENES ? accuracy_of(html, &field_scenes[k], o, rows, err)
           : k == COST_SET  ? costs_of(rows, o->quick, err)
           : k == BAKE_SET  ? bakes_of(rows, o->quick, err)
                            : pairs_of(rows, err);
}

int field_units(const options *o) { return planned(field_unit, FIELD_SETS, o); }

int field_chart(FILE *html, const options *o, kit_error *err)
{
    row curve[FIELD_SCENES * COUNT(field_entries)];
    int points = 0, shown = 0;
    page csv;
    if (page_open(&csv, err)) return -1;
    for (int k = 0; k < FIELD_SETS; ++k) {
        field_row_set *set = &sets[k];
        set->title = field_title(k);
        set->count = unit(html, o, "fields", k, field_unit, set->row, err);
        if (set->count < 0) return -1;
        if (set->count) table_html(html, set->row, set->count);
        if (set->count) table_csv(csv.file, set->row, set->count, !shown++);
        if (k < FIELD_SCENES) curve_of(curve, &points, &field_scenes[k], set->row, set->count);
        if (k + 1 == FIELD_SCENES && points
            && chart_of(html, o->out, "chart-aof.svg", "Fields: error against memory", &field_words, curve, points,
                        (double)NAN, err))
            return -1;
    }
    return page_close(&csv, o->out, "chart-aof.csv", err);
}

void field_chart_text(FILE *f)
{
    for (int k = 0; k < FIELD_SETS; ++k) {
        if (!sets[k].count) continue;
        fprintf(f, "\n%s\n", sets[k].title);
        table_text(f, sets[k].row, sets[k].count);
    }
}
