/* fields.c - the sections on ambient occlusion fields: the demo's pictures; the effect of resolution, the cost of
   bakes. Declared in chart.h. */
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

enum { FIELD_WIDTH = 240, FIELD_HEIGHT = 135 };

/* ---- >>own sets -------------------------------------------------------------------------------------------------- */

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
    { "Fields: costs of a bake",
      "All cores, or one. Errors are of occlusion at receivers that took no part in the bake. Error within: the "
      "smallest resolution, up to 16, and the fewest radii, up to 12, with which 95 % of them are; else the most of "
      "both.",
      .quick = 1, .own = bakes_of }
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
