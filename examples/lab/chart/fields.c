/* fields.c - the sections on ambient occlusion fields: the demo's pictures; the effect of resolution, the cost of
   bakes. Declared in chart.h. */
#include "lab/chart/chart.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#include "lab/chart/fields_stage.h"

/* ---- >>tables ---------------------------------------------------------------------------------------------------- */

/* A row on a bake's time. triangles: of a lumpy ball; 0: the bunny. threads: 0 = all cores. */
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
    kit_scene bunny;
    const char *threads = getenv("KIT_THREADS");
    char *was = threads ? strdup(threads) : NULL;
    if (kit_scene_load(&bunny, BUNNY, 0, err)) return -1;
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
        if (fields_baked(r, b->triangles ? &ball : bunny.shape, &d, err)) return -1;
        if (was) setenv("KIT_THREADS", was, 1); else unsetenv("KIT_THREADS");
        r->figure[THREADS] = b->threads ? b->threads : was ? atoi(was) : (double)sysconf(_SC_NPROCESSORS_ONLN);
        free(ball.position);
        ++count;
    }
    free(was);
    kit_scene_free(&bunny);
    return count;
}

/* ---- >>sections -------------------------------------------------------------------------------------------------- */

const section fields_demo = { .name = "aof", .sets = "fields-demo", .width = 320, .height = 180,
                              .measure = fields_measure, .probe_times = 8, .probe_stride = 13, .range = 0.2,
                              .crop_times = 3 };
const section fields_chart = { .name = "fields", .csv = "chart-aof.csv", .sets = "fields", .width = 240, .height = 135,
                               .measure = fields_measure, .method = "aof", .own = bakes_of, .probe_times = 8,
                               .probe_stride = 13 };
