/* fields.c - the sections on ambient occlusion fields: the demo's pictures; the effect of resolution, the cost of
   occluders and of bakes, the sum of two occluders. Declared in chart.h. */
#include "lab/chart/chart.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "lab/chart/fields_stage.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

#define ON_FLOOR(rays) \
    { { "bunny-on-floor", BUNNY, 1, { -1.4f, 1.1f, 3.7f }, { 0, -0.13f, 0 }, 33, 0, NULL }, NO_SPOTS, \
      NO_BOXES, 0, rays }
#define ON_GROUND(shape, rays) \
    { CLOSE(shape "-on-ground"), { { shape, 1, { 0, 0.501f, 0 } } }, NO_BOXES, 0, rays }
#define TWO(shape) \
    { CLOSE("two-" shape "s"), { { shape, 1, { -0.6f, 0.501f, 0 } }, { shape, 1, { 0.6f, 0.501f, 0 } } }, \
      NO_BOXES, 0, 256 }

/* A row on the cost of occluders. seen: an index of cost_setups; rows of one setup follow each other. occluders: how
   many objects cast, from object 1 on; 0: as in the scene; -1: a cube with the occluder's bounding sphere takes its
   place. */
typedef struct cost { int seen; const char *label, *settings; int occluders; float size; int quick; } cost;
static const setup cost_setups[] = { ON_FLOOR(16), ON_GROUND("ball", 16),
                                     { WHOLE("crowd", "crowd"), NO_SPOTS, NO_BOXES, 0, 16 } };
static const cost costs[] = {
    { 0, "bunny, 69,000 triangles", "", 0, 0, 1 },
    { 0, "cube, 12 triangles", "", -1, 0, 1 },
    { 1, "one ball, size 2", "", 0, 2, 0 },
    { 1, "one ball, size 1", "", 0, 1, 1 },
    { 1, "one ball, size 1/2", "", 0, 0.5f, 0 },
    { 1, "one ball, size 1/4", "", 0, 0.25f, 1 },
    { 1, "one ball, size 1/8", "", 0, 0.125f, 0 },
    { 2, "1 occluder", "", 1, 0, 1 },
    { 2, "10 occluders", "", 10, 0, 1 },
    { 2, "24 occluders", "", 24, 0, 1 },
    { 2, "100 occluders", "", 100, 0, 1 },
    { 2, "100 occluders", "reach=4", 100, 0, 0 }
};

/* A row on a bake's time. triangles: of a lumpy ball; 0: the label's first word names the mesh. threads: 0 = all
   cores. */
typedef struct bake { const char *label, *settings; int triangles, threads, quick; } bake;
static const bake bakes[] = {
    { "lumpy ball", "", 1000, 0, 1 },
    { "lumpy ball", "", 10000, 0, 0 },
    { "lumpy ball", "", 100000, 0, 0 },
    { "lumpy ball", "", 10000, 1, 0 },
    { "lumpy ball", "", 100000, 1, 0 },
    { "lumpy ball", "field_resolution=32", 100000, 1, 0 },
    { "lumpy ball", "field_resolution=4", 10000, 0, 0 },
    { "lumpy ball", "field_resolution=8", 10000, 0, 1 },
    { "lumpy ball", "rays=32", 10000, 0, 1 },
    { "lumpy ball", "rays=64", 10000, 0, 0 },
    { "lumpy ball", "rays=256", 10000, 0, 0 },
    { "bunny", "", 0, 1, 0 },
    { "bunny", "", 0, 0, 0 },
};

static const struct { const char *label[2]; setup setup; } pairs[] = {
    { { "balls, each traced", "balls, each by its field" }, TWO("ball") },
    { { "cubes, each traced", "cubes, each by its field" }, TWO("cube") }
};

enum { FIELD_WIDTH = 240, FIELD_HEIGHT = 135, COST_WIDTH = 640, COST_HEIGHT = 360 };

/* ---- >>own sets -------------------------------------------------------------------------------------------------- */

/* Changes which objects cast. The G-buffer was drawn before and is not drawn again. */
static int cast_by(stage *s, const cost *c, const ssgi_field_desc *d, kit_error *err)
{
    static const float grey[3] = { 0.7f, 0.7f, 0.7f };
    int one = 0;
    for (int i = 1; i < s->scene.objects && c->occluders > 0; ++i) s->scene.object[i].casts = i <= c->occluders;
    while (!s->scene.object[one].casts) ++one;
    if (c->size > 0) {
        const float at[3] = { 0, 0.5f * c->size + 0.001f, 0 };
        float to_world[16];
        fields_place(to_world, c->size, at);
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

static int costs_of(FILE *record, const options *o, row *all, kit_error *err)
{
    (void)record;
    int sum = 0;
    for (int k = 0; k < COUNT(cost_setups); ++k) {
        kit_run run[COUNT(costs)];
        row *const rows = all + sum;
        int count = 0;
        stage s;
        if (fields_open(&s, &cost_setups[k], COST_WIDTH, COST_HEIGHT, err)) return -1;
        for (const cost *c = costs; c < costs + COUNT(costs); ++c) {
            ssgi_field_desc d;
            if (c->seen != k || (o->quick && !c->quick)) continue;
            rows[count] = row_blank(OF_COST, cost_setups[k].view.name, c->label, "aof", c->settings);
            if (fields_desc(&d, c->settings, err) || cast_by(&s, c, &d, err)
                || kit_fields_cover(&rows[count].figure[COVERED], &s.frame, &s.gbuffer.camera, &s.scene, &d, err)
                || stage_run(&run[count], &s, "aof", c->settings, s.radius, err))
                return -1;
            kit_run_draw(&run[count++], 1);
        }
        if (clock_runs(rows, &s, run, count, o->quick ? QUICK_ROUNDS : CHART_ROUNDS, err)) return -1;
        sum += count;
        stage_close(&s);
    }
    return sum;
}

/* Makes a ball of at most that many triangles with a lumpy surface: positions alone. */
static int lumpy_ball(kit_mesh *mesh, int triangles, kit_error *err)
{
    const int n = (int)(sqrt(triangles) / 2);
    memset(mesh, 0, sizeof *mesh);
    mesh->triangles = 4 * (size_t)n * (size_t)n;
    mesh->position = malloc(9 * mesh->triangles * sizeof(float));
    if (!mesh->position) return kit_fail(err, "out of memory");
    for (int k = 0; k < 12 * n * n; ++k) {                      /* two triangles for each of 6 n^2 cells */
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

static int bakes_of(FILE *record, const options *o, row *rows, kit_error *err)
{
    (void)record;
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
        if (o->quick && !b->quick) continue;
        *r = row_blank(OF_BAKE, "bake", b->label, "aof", b->settings);
        kit_fields_free();                                      /* drops kept fields, so that each bake is timed */
        if (b->threads) setenv("KIT_THREADS", "1", 1);
        if (fields_desc(&d, b->settings, err) || (b->triangles && lumpy_ball(&ball, b->triangles, err))) return -1;
        if (fields_baked(r, b->triangles ? &ball : *b->label == 'c' ? cube : bunny.shape, &d, err)) return -1;
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

/* Combines the visibilities of two occluders in three ways, and compares these with the visibility under both. */
static void combined(row *r, const stage *s, const kit_image *each)
{
    const double tolerance = 0.002;                             /* the RMSE that the two truths themselves have */
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

static int pairs_of(FILE *record, const options *o, row *rows, kit_error *err)
{
    (void)record;
    (void)o;
    int count = 0;
    for (int k = 0; k < COUNT(pairs); ++k) {
        kit_image each[2][2];                                   /* [0]: ray-traced, [1]: by the object's field */
        int one = 0, other;
        stage s;
        if (fields_open(&s, &pairs[k].setup, FIELD_WIDTH, FIELD_HEIGHT, err)) return -1;
        while (!s.scene.object[one].casts) ++one;
        for (other = one + 1; !s.scene.object[other].casts;) ++other;
        for (int i = 0; i < 2; ++i) {
            s.scene.object[one].casts = !i;
            s.scene.object[other].casts = i;
            if (stage_trace(&each[0][i], &s, s.rays, 1, err)
                || stage_drawn(&each[1][i], &s, "aof", "", s.radius, err))
                return -1;
        }
        for (int i = 0; i < 2; ++i) {
            row *r = &rows[count++];
            *r = row_blank(OF_PAIR, pairs[k].setup.view.name, pairs[k].label[i], "aof", "");
            combined(r, &s, each[i]);
            for (int j = 0; j < 2; ++j) kit_image_free(&each[i][j]);
        }
        stage_close(&s);
    }
    return count;
}

/* ---- >>sections -------------------------------------------------------------------------------------------------- */

#define SEEN &(const setup)
#define MOVING(name, time) SEEN { WHOLE(name, "casters"), NO_SPOTS, NO_BOXES, time, 128 }, \
    .rows = "fields-demo"
static const set demos[] = {
    { "Fields: occluders that move",
      "Cubes, balls, tori, cones and tables, one field a shape, of 8 x 8 texels a face. At rest.",
      MOVING("occluders-0", 0) },
    { NULL, "A third of a period later.", MOVING("occluders-1", 1 / 3.0) },
    { "Fields: how many texels",
      "The bunny on a box before a wall, its field of 4 x 4 and of 8 x 8 texels a face.",
      SEEN { { "pedestal", BUNNY, 0, { -1.9f, 0.9f, 4.3f }, { 0, -0.25f, 0 }, 34, 0, NULL },
             NO_SPOTS,
             { { -1.3f, -1.6f, -0.9f, 1.3f, -0.99f, 1.1f },
               { -5, -1.6f, -1.3f, 5, 3, -1.2f },
               { -5, -1.8f, -1.3f, 5, -1.6f, 6 } },
             0, 256 },
      .rows = "fields-demo-texels",
      .crop = { { 108, 114, 107, 54 }, { 70, 4, 107, 54 } } },
    { "Fields: inside of the hull",
      "A table and a torus, half of each in the ground: between a table's legs, and in a ring, there is ground inside "
      "of the convex hull, where occlusion goes to A_0.",
      SEEN { { "sunk", "casters", 0, { 0.6f, 2.6f, 3.6f }, { 0, 0, 0.1f }, 34, 0, NULL },
             { { "torus", 1.4f, { 1, 0.05f, 0.1f } }, { "table", 1.6f, { -0.7f, 0.02f, 0 } } },
             NO_BOXES, 0, 128 },
      .rows = "fields-demo-inside" }
};
static const set sets[] = {
    { "Fields: error against memory", "Ball on a ground.", SEEN ON_GROUND("ball", 512), .rows = "fields", .quick = 1,
      .kind = "memory" },
    { NULL, "Cube on a ground.", SEEN ON_GROUND("cube", 512), .rows = "fields", .quick = 1, .kind = "memory" },
    { NULL, "Bunny on a floor.", SEEN ON_FLOOR(512), .rows = "fields", .quick = 1, .kind = "memory" },
    { NULL, "Two dozen occluders.", SEEN { WHOLE("casters", "casters"), NO_SPOTS, NO_BOXES, 0, 512 },
      .rows = "fields", .kind = "memory" },
    { "Fields: costs of occluders",
      "The occluder changes, the picture does not: the cube has the bunny's bounding sphere; sizes of the ball "
      "stand for distances. Times are of the pass alone, on 640 x 360 pixels (of a quick chart 320 x 180). Covered: "
      "pixels within the occluders' reach, each occluder's; a software rasteriser works for all pixels of the "
      "rectangles around those spheres.",
      .quick = 1, .own = costs_of },
    { "Fields: costs of a bake",
      "All cores, or one. Errors are of occlusion at receivers that took no part in the bake. Error within: the "
      "smallest resolution, up to 16, and the fewest radii, up to 12, with which 95 % of them are; else the most of "
      "both.",
      .quick = 1, .own = bakes_of },
    { "Fields: two occluders",
      "Two occluders by each other on a ground, one's occlusion a, the other's b, and that of both together. "
      "Between: 0.002 are for noise.",
      .own = pairs_of }
};

static int open(stage *s, const section *c, const set *t, kit_error *err)
{
    return fields_open(s, t->see, c->width, c->height, err);
}

static int measure(FILE *record, row *rows, stage *s, const entry *entries, int count, kit_image *picture,
                   kit_error *err)
{
    (void)record;
    return fields_measure(rows, s, entries, count, picture, err) ? -1 : count;
}

/* Writes the scene's colours in white light from everywhere, dimmed by channel Y of visibility. */
static int dimmed(kit_image *out, const stage *s, const kit_image *visibility, kit_error *err)
{
    static const char *const names[3] = { "albedo.R", "albedo.G", "albedo.B" };
    const size_t pixels = (size_t)s->frame.width * (size_t)s->frame.height;
    if (kit_image_new(out, s->frame.width, s->frame.height, "R,G,B,Y", err)) return -1;
    for (size_t c = 0; c < 4; ++c)
        for (size_t i = 0; i < pixels; ++i)
            out->data[c * pixels + i] =
                (c < 3 ? kit_image_channel(&s->frame, names[c])[i] : 1) * visibility->data[i];
    return 0;
}

static found demo_found[COUNT(demos)], chart_found[COUNT(sets)];
const section fields_demo = { .name = "aof", .sets = WITH_COUNT(demos), .width = 320, .height = 180, .open = open,
                              .measure = measure, .probe_times = 8, .probe_stride = 13, .range = 0.2, .crop_times = 3,
                              .seen = dimmed, .found = demo_found };
const section fields_chart = { .name = "fields", .csv = "chart-aof.csv", .method = "aof", .sets = WITH_COUNT(sets),
                               .width = FIELD_WIDTH, .height = FIELD_HEIGHT, .open = open, .measure = measure,
                               .probe_times = 8, .probe_stride = 13, .found = chart_found };
