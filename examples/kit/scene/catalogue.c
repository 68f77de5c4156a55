/* catalogue.c - reads models of Debian's packages: single files, and the furniture of Sweet Home 3D, whose catalogues
   give their sizes. Declared in kit_seed.h and kit.h. */
#include "kit/kit_seed.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#define FURNITURE "/usr/share/sweethome3d/furniture/"
#define FURNITURE_PACKAGE "sweethome3d-furniture"

static const char *const archives[] = { "BlendSwap-CC-0", "BlendSwap-CC-BY", "KatorLegaz", "Reallusion", "Scopia" };

static const struct single {
    const char *name, *path, *package;
    double height; /* metres */
} singles[] = { { "bunny", "/usr/share/glmark2/models/bunny.obj", "glmark2-data", 0.25 },
                { "spider", "/usr/share/assimp/models/OBJ/spider.obj", "assimp-testmodels", 0.9 },
                { "wuson", "/usr/share/assimp/models/OBJ/WusonOBJ.obj", "assimp-testmodels", 1.6 } };

enum { SINGLES = sizeof singles / sizeof *singles, ARCHIVES = sizeof archives / sizeof *archives, MODELS = 2000 };

/* ---- >>catalogues ------------------------------------------------------------------------------------------------ */

/* An entry of a catalogue: the model's file in its archive, the lengths of its sides and its rotation. */
typedef struct entry {
    int archive, turned;
    double side[3];
    float turn[9];
    char path[160], name[160];             /* as "scopia/armchair3/armchair3.obj"; name lacks the last part */
} entry;

/* all catalogues' entries, read at the first call; not locked, because one thread loads scenes */
static entry *entries;
static int count;

static FILE *member(int archive, const char *name)
{
    char command[512];
    snprintf(command, sizeof command, "unzip -p " FURNITURE "%s.sh3f '%s' 2>/dev/null", archives[archive], name);
    fflush(NULL);
    return popen(command, "r");
}

/* "height#12=94.9" */
static void read_line(entry *of, const char *line)
{
    static const char *const sides[] = { "width#", "height#", "depth#" };
    const char *number = strchr(line, '#'), *value = strchr(line, '=');
    const int k = number ? atoi(number + 1) : 0;
    if (!value || k < 1 || k >= MODELS) return;
    entry *e = &of[k];
    value += strspn(value, "= \t/");
    for (int i = 0; i < 3; i++)
        if (!strncmp(line, sides[i], strlen(sides[i]))) e->side[i] = 0.01 * strtod(value, NULL);
    if (!strncmp(line, "model#", 6)) snprintf(e->path, sizeof e->path, "%.*s", (int)strcspn(value, " \r\n"), value);
    if (strncmp(line, "modelRotation#", 14)) return;
    e->turned = 1;
    for (int i = 0; i < 9; i++) e->turn[i] = strtof(value, (char **)&value);
}

/* Appends the entries of one archive, numbered from 1. */
static int read_catalogue(int archive)
{
    entry *of = calloc(MODELS, sizeof *of), *more = NULL;
    char line[512];
    FILE *f = of ? member(archive, "PluginFurnitureCatalog.properties") : NULL;
    while (f && fgets(line, sizeof line, f)) read_line(of, line);
    const int failed = !f || pclose(f);
    for (int k = 0; k < MODELS && of && !failed; k++) {
        const char *const path = of[k].path, *const ending = strrchr(path, '.');
        if (!ending || strcmp(ending, ".obj") || !strchr(path, '/')) continue;
        if (!(of[k].side[0] * of[k].side[1] * of[k].side[2] > 0)) continue;
        if (!(more = realloc(entries, ((size_t)count + 1) * sizeof *more))) break;
        entries = more;
        of[k].archive = archive;
        snprintf(of[k].name, sizeof of[k].name, "%.*s", (int)(strrchr(path, '/') - path), path);
        entries[count++] = of[k];
    }
    free(of);
    return failed;
}

static void read_catalogues(void)
{
    if (count) return;
    for (int a = 0; a < ARCHIVES; a++)
        if (read_catalogue(a)) return;
}

static const struct single *single_named(const char *name, int length)
{
    for (int k = 0; k < SINGLES; k++)
        if ((int)strlen(singles[k].name) == length && !memcmp(singles[k].name, name, (size_t)length))
            return &singles[k];
    return NULL;
}

/* Returns the first entry whose path ends in the name. */
static const entry *entry_named(const char *name, int length)
{
    read_catalogues();
    for (int k = 0; k < count; k++) {
        const char *const own = entries[k].name;
        const int off = (int)strlen(own) - length;
        if (off >= 0 && !memcmp(own + off, name, (size_t)length) && (!off || own[off - 1] == '/')) return &entries[k];
    }
    return NULL;
}

const char *kit_scene_model(int i)
{
    if (i < SINGLES) return i < 0 ? NULL : singles[i].name;
    read_catalogues();
    return i - SINGLES < count ? entries[i - SINGLES].name : NULL;
}

/* ---- >>unpacking ------------------------------------------------------------------------------------------------- */

/* Writes the path of the folder for unpacked models in the user's cache. */
static int cache_folder(char *out, size_t size)
{
    const char *const given = getenv("XDG_CACHE_HOME"), *const home = getenv("HOME");
    snprintf(out, size, "%s%s/ssgi-models", given && *given ? given : home && *home ? home : "/tmp",
             given && *given ? "" : "/.cache");
    for (char *c = out + 1; *c; c++)
        if (*c == '/') {
            *c = 0;
            mkdir(out, 0777);
            *c = '/';
        }
    return mkdir(out, 0777) && errno != EEXIST ? -1 : 0;
}

/* Unpacks an entry's file and writes its path to path. The file is unpacked to a new folder and then moved, because
   another process may do the same. */
static int unpacked(char *path, size_t size, const entry *e, kit_error *err)
{
    static const char script[] = "unzip -qq -o \"$1\" \"$2/*\" -d \"$4\" && mkdir -p \"$3/$2\" && "
                                 "mv -f \"$4/$2\"/* \"$3/$2/\" && rm -rf \"$4\"";
    char folder[300], fresh[340], archive[128];
    int status = 0;
    if (cache_folder(folder, sizeof folder)) return kit_fail(err, "%s: cannot be made: %s", folder, strerror(errno));
    snprintf(path, size, "%s/%s", folder, e->path);
    if (!access(path, R_OK)) return 0;
    snprintf(fresh, sizeof fresh, "%s/fresh-XXXXXX", folder);
    snprintf(archive, sizeof archive, FURNITURE "%s.sh3f", archives[e->archive]);
    if (!mkdtemp(fresh)) return kit_fail(err, "%s: cannot be made: %s", fresh, strerror(errno));
    const pid_t other = fork();
    if (!other) {
        execlp("sh", "sh", "-c", script, "sh", archive, e->name, folder, fresh, (char *)NULL);
        _exit(127);
    }
    while (other > 0 && waitpid(other, &status, 0) < 0 && errno == EINTR) continue;
    if (other < 0 || status || access(path, R_OK))
        return kit_fail(err, "%s: cannot be unpacked (apt-get install unzip %s)", e->path, FURNITURE_PACKAGE);
    return 0;
}

/* ---- >>reading --------------------------------------------------------------------------------------------------- */

/* Rotates a model by the catalogue's matrix, given as rows. */
static void turn(kit_mesh *m, const float by[9])
{
    for (size_t t = 0; t < 6 * m->triangles; t++) {
        float *v = (t & 1 ? m->normal : m->position) + 3 * (t / 2), was[3];
        memcpy(was, v, sizeof was);
        for (int i = 0; i < 3; i++) v[i] = by[3 * i] * was[0] + by[3 * i + 1] * was[1] + by[3 * i + 2] * was[2];
    }
    kit_mesh_bounds(m);
}

/* Moves a model to y = 0 and its middle to the y axis, and scales its sides to these; 0: as its height. */
static void fit(kit_mesh *m, const double side[3])
{
    double scale[3];
    for (int i = 0; i < 3; i++) {
        const double is = (double)m->upper[i] - (double)m->lower[i];
        scale[i] = side[i] > 0 ? side[i] / is : side[1] / ((double)m->upper[1] - (double)m->lower[1]);
        if (!(scale[i] < 1e9)) scale[i] = 1;
    }
    for (size_t k = 0; k < 3 * m->triangles; k++) {
        double n[3];
        for (int i = 0; i < 3; i++) {
            const double low = (double)m->lower[i],
                         from = i == 1 ? low : 0.5 * (low + (double)m->upper[i]);
            m->position[3 * k + (size_t)i] = (float)(scale[i] * ((double)m->position[3 * k + (size_t)i] - from));
            n[i] = (double)m->normal[3 * k + (size_t)i] / scale[i];
        }
        if (!kit_unit(n)) n[1] = 1;
        for (int i = 0; i < 3; i++) m->normal[3 * k + (size_t)i] = (float)n[i];
    }
    kit_mesh_bounds(m);
}

static int missing(const char *path, const char *package, kit_error *err)
{
    return kit_fail(err, "%s is missing; install the package %s (apt-get install %s)", path, package, package);
}

static int read_single(kit_mesh *mesh, const struct single *s, kit_error *err)
{
    const double side[3] = { 0, s->height, 0 };
    if (access(s->path, R_OK)) return missing(s->path, s->package, err);
    if (kit_mesh_obj(mesh, NULL, NULL, s->path, err)) return -1;
    fit(mesh, side);
    return 0;
}

int kit_catalogue_has(const char *name, int length)
{
    return single_named(name, length) != NULL || entry_named(name, length) != NULL;
}

int kit_catalogue_read(kit_mesh *mesh, const char *name, int length, kit_error *err)
{
    char path[512];
    const struct single *const alone = single_named(name, length);
    if (alone) return read_single(mesh, alone, err);
    if (access(FURNITURE "Scopia.sh3f", R_OK)) return missing(FURNITURE "Scopia.sh3f", FURNITURE_PACKAGE, err);
    const entry *const e = entry_named(name, length);
    if (!count) return missing("the command unzip", "unzip", err);
    if (!e) return kit_fail(err, "model '%.*s': no package's catalogue has it", length, name);
    if (unpacked(path, sizeof path, e, err) || kit_mesh_obj(mesh, NULL, NULL, path, err)) return -1;
    if (e->turned) turn(mesh, e->turn);
    fit(mesh, e->side);
    return 0;
}
