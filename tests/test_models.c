/* test_models.c - what a model's file may cost to read, and what is said where there is none: the kit's mesh.c and
   scene.c. What files mean stands in test_files.c. */
#include "t.h"
#include "kit/kit.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define CORNERS "v 0 0 0\nv 1 0 0\nv 0 1 0\n"

static char folder[512];

static const char *in_folder(const char *name)  /* valid until the next call */
{
    static char path[1024];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    return path;
}

/* ---- cost ---------------------------------------------------------------------------------------------------- */

static uint32_t chance(uint32_t *state, uint32_t below)
{
    *state = *state * 1664525u + 1013904223u;
    return (uint32_t)((uint64_t)*state * below >> 32);
}

static void plain(FILE *obj, FILE *mtl)         /* a grid: what its bytes cost is what bytes may cost */
{
    enum { SIDE = 120 };
    (void)mtl;
    for (int i = 0; i < SIDE * SIDE; ++i) fprintf(obj, "v %d.5 %.6f %d.25\n", i % SIDE, sin(i), i / SIDE);
    for (int i = 0; i < SIDE * (SIDE - 1) - 1; ++i)
        if (i % SIDE < SIDE - 1)
            fprintf(obj, "f %d %d %d\nf %d %d %d\n", i + 1, i + 2, i + SIDE + 2, i + 1, i + SIDE + 2, i + SIDE + 1);
}

static void one_file_often(FILE *obj, FILE *mtl)
{
    for (int i = 0; i < 3000; ++i) fprintf(mtl, "newmtl m%d\nKd 1 0 0\n", i);
    fputs(CORNERS, obj);
    for (int i = 0; i < 1000; ++i) fputs("mtllib a.mtl\nmtllib ./a.mtl\n", obj);
    fputs("f 1 2 3\n", obj);
}

static void many_materials(FILE *obj, FILE *mtl)
{
    enum { MANY = 40000 };
    for (int i = 0; i < MANY; ++i) fprintf(mtl, "newmtl m%d\nKd 1 0 0\n", i);
    fputs(CORNERS "mtllib a.mtl\n", obj);
    for (int i = 0; i < MANY; ++i) fprintf(obj, "usemtl m%d # %d\nf 1 2 3\n", i, i);
}

static void crossed_polygons(FILE *obj, FILE *mtl)
{
    enum { MOST = 1000, FACES = 20 };
    uint32_t state = 1;
    (void)mtl;
    for (int i = 0; i < MOST; ++i) fprintf(obj, "v .%u .%u 0\n", chance(&state, 1000000), chance(&state, 1000000));
    for (int k = 0; k < FACES; ++k) {
        fputc('f', obj);
        for (int i = 1; i <= MOST; ++i) fprintf(obj, " %d", i);
        fputc('\n', obj);
    }
}

/* 32 choices of four letters, three times: 32,768 names whose FNV-1a agree in their last 17 bits. */
static void names_of_one_hash(FILE *obj, FILE *mtl)
{
    enum { WAYS = 32, BLOCKS = 3, MASK = (1 << 17) - 1 };
    char block[BLOCKS][WAYS][5];
    uint32_t state = 2166136261u;
    (void)mtl;
    for (int b = 0; b < BLOCKS; ++b) {
        const uint32_t wanted = state + 1;
        for (uint32_t i = 0, found = 0; found < WAYS; ++i) {
            uint32_t h = state;
            char *letters = block[b][found];
            for (int k = 0; k < 4; ++k) {
                letters[k] = (char)('0' + (i >> 6 * k & 63));
                h = (h ^ (uint8_t)letters[k]) * 16777619u;
            }
            letters[4] = 0;
            found += ((h ^ wanted) & MASK) == 0;
        }
        state = wanted;
    }
    fputs(CORNERS, obj);
    for (int i = 0; i < WAYS * WAYS * WAYS; ++i)
        fprintf(obj, "o %s%s%s\nf 1 2 3\n", block[0][i % WAYS], block[1][i / WAYS % WAYS], block[2][i / WAYS / WAYS]);
}

typedef struct cost { double seconds, bytes, megabytes; } cost;

/* What another process takes to read the files that are written here. */
static cost cost_of(const char *about, void (*write)(FILE *obj, FILE *mtl))
{
    FILE *obj = fopen(in_folder("a.obj"), "wb"), *mtl = fopen(in_folder("a.mtl"), "wb");
    struct rusage spent;
    cost c = { 0 };
    int status = -1;
    if (!CHECK(obj && mtl, "%s: files cannot be made", about)) return c;
    write(obj, mtl);
    c.bytes = (double)ftell(obj) + (double)ftell(mtl);
    fclose(obj);
    fclose(mtl);
    fflush(stdout);
    const pid_t reader = fork();
    if (!reader) {
        const struct rlimit most = { 60, 60 };
        kit_mesh mesh;
        setrlimit(RLIMIT_CPU, &most);
        _exit(kit_mesh_obj(&mesh, NULL, NULL, in_folder("a.obj"), NULL) ? 1 : 0);
    }
    const pid_t ended = reader < 0 ? -1 : wait4(reader, &status, 0, &spent);
    if (!CHECK(ended == reader && status == 0, "%s: cannot be read in a minute: status %d", about, status)) return c;
    c.seconds = t_seconds(&spent);
    c.megabytes = (double)spent.ru_maxrss / 1024;
    return c;
}

/* most: as many times what a byte of a plain file takes. Without bounds these take 150 to 2000 times as long. */
static void costs(void)
{
    static const struct { const char *about; void (*write)(FILE *, FILE *); double most; } hostile[] = {
        { "2,000 lines name one file of materials", one_file_often, 50 },
        { "40,000 materials, each used", many_materials, 30 },
        { "polygons of 1,000 corners that cross themselves", crossed_polygons, 200 },
        { "32,768 names of one hash", names_of_one_hash, 20 },
    };
    const cost usual = cost_of("a plain file", plain);
    for (size_t i = 0; i < sizeof hostile / sizeof *hostile && usual.bytes > 0; ++i) {
        const cost c = cost_of(hostile[i].about, hostile[i].write);
        const double times = c.seconds / c.bytes / (usual.seconds / usual.bytes);
        CHECK(times < hostile[i].most, "%s: a byte takes %.1f times as long as a plain file's, not %g at most",
              hostile[i].about, times, hostile[i].most);
        CHECK(c.megabytes < usual.megabytes + 100 * c.bytes / 1048576, "%s: %.0f MiB for %.1f MiB; a plain file %.0f",
              hostile[i].about, c.megabytes, c.bytes / 1048576, usual.megabytes);
    }
}

/* ---- what is read -------------------------------------------------------------------------------------------- */

static void put(const char *name, const char *text)
{
    FILE *file = fopen(in_folder(name), "wb");
    if (!CHECK(file != NULL, "%s cannot be made", name)) return;
    fputs(text, file);
    fclose(file);
}

/* As if each line read its file again: what the last one names counts, wherever else the file is named. */
static void materials_by_order(void)
{
    static const struct { const char *lines; float red; } files[] = {
        { "mtllib one.mtl\nmtllib two.mtl\n", 0.5f },
        { "mtllib one.mtl\nmtllib two.mtl\nmtllib .//one.mtl # again\n", 0.25f },
        { "mtllib two.mtl\nmtllib one.mtl\nmtllib link.mtl\n", 0.5f },
        { "mtllib two.mtl\nmtllib one.mtl\nmtllib absent.mtl\n", 0.25f },
    };
    char text[500], one[1024];
    put("one.mtl", "newmtl x\nKd .75\nnewmtl x\nKd .25\n");
    put("two.mtl", "newmtl x # y\nKd .75\nnewmtl x\nKd .5\n");
    snprintf(one, sizeof one, "%s", in_folder("two.mtl"));
    CHECK(!symlink(one, in_folder("link.mtl")), "no link can be made");
    for (size_t i = 0; i < sizeof files / sizeof *files; ++i) {
        kit_error err = {{0}};
        kit_mesh mesh;
        snprintf(text, sizeof text, CORNERS "%susemtl x\nf 1 2 3\n", files[i].lines);
        put("order.obj", text);
        if (!CHECK(!kit_mesh_obj(&mesh, NULL, NULL, in_folder("order.obj"), &err), "%s", err.text)) return;
        CHECK(mesh.albedo[0] == files[i].red, "file %zu: red is %g, not %g", i, (double)mesh.albedo[0],
              (double)files[i].red);
        kit_mesh_free(&mesh);
    }
}

/* A band wound up: two ears at a time, far from each other, and a look at nearly all corners for each. */
static void wound_polygon(void)
{
    enum { CORNERS_EACH = 500, ALL = 2 * CORNERS_EACH };
    static double p[ALL][2];
    FILE *file = fopen(in_folder("wound.obj"), "wb");
    double area = 0, covered = 0;
    size_t turned = 0;
    kit_error err = {{0}};
    kit_mesh mesh;
    if (!CHECK(file != NULL, "no file")) return;
    for (int i = 0; i < ALL; ++i) {
        const double angle = 0.35 * (i < CORNERS_EACH ? i : ALL - 1 - i), radius = angle + (i < CORNERS_EACH ? 3 : 1);
        p[i][0] = rint(1024 * radius * cos(angle)) / 1024;
        p[i][1] = rint(1024 * radius * sin(angle)) / 1024;
        fprintf(file, "v %.10f %.10f 0\n", p[i][0], p[i][1]);
    }
    for (int i = 0; i < ALL; ++i) {
        const double *a = p[i], *b = p[(i + 1) % ALL];
        area += 0.5 * (a[0] * b[1] - a[1] * b[0]);
    }
    fputc('f', file);
    for (int i = 1; i <= ALL; ++i) fprintf(file, " %d", i);
    fclose(file);
    if (!CHECK(!kit_mesh_obj(&mesh, NULL, NULL, in_folder("wound.obj"), &err), "%s", err.text)) return;
    for (size_t t = 0; t < mesh.triangles; ++t) {
        const float *q = mesh.position + 9 * t;
        covered += 0.5 * fabs(((double)q[3] - (double)q[0]) * ((double)q[7] - (double)q[1])
                              - ((double)q[4] - (double)q[1]) * ((double)q[6] - (double)q[0]));
        turned += mesh.normal[9 * t + 2] * (float)area <= 0;
    }
    CHECK(mesh.triangles == ALL - 2, "%zu triangles, not %d", mesh.triangles, ALL - 2);
    CHECK(fabs(covered - fabs(area)) < 1e-6 * fabs(area), "covers %g, not %g", covered, fabs(area));
    CHECK(turned == 0, "%zu triangles are turned over", turned);
    kit_mesh_free(&mesh);
}

/* ---- what is none -------------------------------------------------------------------------------------------- */

static void no_scene(void)
{
    kit_error err = {{0}};
    kit_scene scene;
    const char *name;
    CHECK(kit_scene_load(&scene, in_folder("nowhere"), 0, &err) == -1, "a scene that is nowhere was found");
    CHECK(strstr(err.text, "nowhere") != NULL, "\"%s\"", err.text);
    for (int i = 0; (name = kit_scene_builtin(i, NULL)) != NULL; ++i)
        CHECK(strstr(err.text, name) != NULL, "%s is not named: \"%s\"", name, err.text);
    if (!CHECK(!mkfifo(in_folder("pipe"), 0600), "no pipe can be made")) return;
    alarm(60);                             /* waiting for who writes it would last for ever */
    CHECK(kit_scene_load(&scene, in_folder("pipe"), 0, &err) == -1 && strstr(err.text, "not a regular file"), "\"%s\"",
          err.text);
    alarm(0);
}

void test_models(void)
{
    static const char *const made[] = { "a.obj", "a.mtl", "one.mtl", "two.mtl", "link.mtl", "order.obj", "wound.obj",
                                        "pipe" };
    const char *tmp = getenv("TMPDIR");
    snprintf(folder, sizeof folder, "%s/kit-test-XXXXXX", tmp && *tmp ? tmp : "/tmp");
    if (!mkdtemp(folder)) {
        printf("test_models: no folder for temporary files can be made: %s\n", folder);
        exit(1);
    }
    RUN("what an OBJ costs to read is in proportion to its size, whatever is in it", costs);
    RUN("a file of materials that is named often counts where it is named last", materials_by_order);
    RUN("a polygon of 1,000 corners that is wound up is covered once", wound_polygon);
    RUN("a scene that is none: all built-in ones are named; a pipe is not waited for", no_scene);
    for (size_t i = 0; i < sizeof made / sizeof *made; ++i) remove(in_folder(made[i]));
    rmdir(folder);
}
