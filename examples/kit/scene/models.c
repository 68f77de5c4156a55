/* models.c - finds a model's format and reads it: OBJ by mesh.c, all else by Assimp in a process of its own. Declared
   in kit_models.h.

   Damaged files may crash that process (a third of PLY files with some bytes changed do) or never let it end. So its
   time and memory are limited by the file's size, and its end is an error like any other. */
#include "kit/kit_models.h"
#include <errno.h>
#include <float.h>
#include <math.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <sys/wait.h>
#include <unistd.h>

/* ---- >>notes ----------------------------------------------------------------------------------------------------- */

/* Writes into the note the origin about which a model is drawn, and the rounding of doubles there. */
static void note_origin(char *note, const kit_mesh *mesh)
{
    const double *at = mesh->origin, away = fmax(fabs(at[0]), fmax(fabs(at[1]), fabs(at[2])));
    if (away == 0) return;
    kit_note_gap(note, "doubles", DBL_EPSILON * away, mesh->lower, mesh->upper);
    kit_note(note,
             "it lies far from 0 beside its size, and is drawn about %.12g,%.12g,%.12g; --camera and --light stay in "
             "its own coordinates",
             at[0], at[1], at[2]);
}

/* ---- >>formats --------------------------------------------------------------------------------------------------- */

/* A format of models, known by the first bytes of its files or, if these decide nothing, by their ending. */
typedef struct kind {
    const char *name, *start, *ending;
} kind;

static const kind formats[] = {
    { "glTF binary", "glTF", ".glb" },
    { "FBX binary", "Kaydara FBX Binary", ".fbx" },
    { "FBX text", "; FBX", NULL },
    { "PLY", "ply\n", ".ply" },
    { "PLY", "ply\r", NULL },
    { "glTF", NULL, ".gltf" },
    { "STL", NULL, ".stl" },
    { "Collada", NULL, ".dae" },
    { "3DS", NULL, ".3ds" },
    { "IFC", "ISO-10303-21", ".ifc" },
    { "a Blender file", "BLENDER", ".blend" },
    { "USD binary", "PXR-USDC", ".usdc" },
    { "USD text", "#usda", ".usda" },
    { "USD", NULL, ".usd" },
    { "USDZ", NULL, ".usdz" },
    { "Alembic", "Ogawa", ".abc" },
    /* formats of containers and files that are not models: used if no ending says more */
    { "a ZIP file", "PK\3\4", NULL },
    { "a gzip file", "\037\213", NULL },
    { "a PNG picture", "\211PNG", NULL },
    { "an OpenEXR picture", "v/1\1", NULL },
};

enum { OTHERS = 4 };

static int begins(const char *bytes, size_t size, const char *with)
{
    return with && size >= strlen(with) && !memcmp(bytes, with, strlen(with));
}

/* "": none */
static const char *ending_of(const char *path)
{
    const char *slash = strrchr(path, '/'), *dot = strrchr(slash ? slash : path, '.');
    return dot ? dot : "";
}

/* Returns the name of a file's format; NULL: it may be an OBJ. */
static const char *format_of(const char *path, const char *bytes, size_t size)
{
    const char *ending = ending_of(path);
    const size_t count = sizeof formats / sizeof *formats;
    static char other[32];
    for (size_t i = 0; i < count - OTHERS; ++i)
        if (begins(bytes, size, formats[i].start)) return formats[i].name;
    for (size_t i = 0; i < count; ++i)
        if (formats[i].ending && !strcasecmp(ending, formats[i].ending)) return formats[i].name;
    for (size_t i = count - OTHERS; i < count; ++i)
        if (begins(bytes, size, formats[i].start)) return formats[i].name;
    if (!strcasecmp(ending, ".obj") || !*ending || strlen(ending) > 8 || !kit_assimp_takes(ending)) return NULL;
    snprintf(other, sizeof other, "%s", ending + 1);
    for (char *c = other; *c; ++c)
        if (*c >= 'a' && *c <= 'z') *c = (char)(*c - 'a' + 'A');
    return other;
}

/* ---- >>glTF ------------------------------------------------------------------------------------------------------ */

/* glTF extensions that a file may require: they are read, or change nothing here, as textures only give colours. */
static const char *const harmless[] = { "KHR_draco_mesh_compression",
                                        "KHR_texture_transform",
                                        "KHR_lights_punctual",
                                        "KHR_materials_",
                                        "KHR_xmp",
                                        "KHR_node_visibility",
                                        "KHR_audio" };
static const char *const pictures[] = { "KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif",
                                        "MSFT_texture_dds" };

static int is_of(const char *name, size_t length, const char *const *list, size_t count)
{
    for (size_t i = 0; i < count; ++i)
        if (length >= strlen(list[i]) && !memcmp(name, list[i], strlen(list[i]))) return 1;
    return 0;
}

#define IS_OF(name, length, list) is_of(name, length, list, sizeof(list) / sizeof *(list))

/* Refuses a glTF that requires another extension, because Assimp ignores extensions that it does not know. */
static int check_extensions(char *note, const char *path, const char *json, kit_error *err)
{
    const char *at = strstr(json, "\"extensionsRequired\""), *end = at ? strchr(at, ']') : NULL;
    at = end ? memchr(at, '[', (size_t)(end - at)) : NULL;
    while (at && (at = memchr(at, '"', (size_t)(end - at))) != NULL) {
        const char *stop = memchr(at + 1, '"', (size_t)(end - at - 1));
        if (!stop) break;
        ++at;
        const size_t length = strspn(at, "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789_");
        if (IS_OF(at, length, pictures))
            kit_note(note, "textures in %.*s are not read, and are left out", length < 80 ? (int)length : 80, at);
        else if (!IS_OF(at, length, harmless))
            return kit_fail(err, "%s: is glTF that needs the extension %.*s, which is not read", path,
                            length < 80 ? (int)length : 80, at);
        at = stop + 1;
    }
    return 0;
}

static int check_gltf(char *note, const char *path, kit_error *err)
{
    kit_gltf g;
    if (kit_gltf_text(&g, path, err)) return -1;
    const int failed = check_extensions(note, path, g.text, err);
    free(g.data);
    return failed;
}

/* ---- >>another process ------------------------------------------------------------------------------------------- */

/* The head of the other process's answer; the arrays of the mesh and the objects follow it. */
typedef struct answer {
    int failed, objects;
    size_t triangles;
    float lower[3], upper[3];
    double origin[3];
    char note[KIT_NOTE];
    kit_error err;
} answer;

/* Writes all of data into a pipe, or reads it from there. */
enum { SEND, TAKE };
static int move_all(int way, int file, void *data, size_t size)
{
    for (char *p = data; size > 0;) {
        const size_t part = size < 1 << 30 ? size : 1 << 30;
        const ssize_t n = way == SEND ? write(file, p, part) : read(file, p, part);
        if (n < 0 && errno == EINTR) continue;
        if (n <= 0) return -1;
        p += n;
        size -= (size_t)n;
    }
    return 0;
}

/* Makes a text of a file, which may contain anything, one line. */
static void one_line(char *text)
{
    for (char *c = text; *c; ++c)
        if ((unsigned char)*c < ' ') *c = ' ';
}

/* An array of the answer; of: the address of the pointer to it. */
typedef struct array { void *of; size_t bytes; } array;
enum { ARRAYS = 5 };

static void arrays_of(array all[ARRAYS], const answer *a, kit_mesh *mesh, kit_object **object)
{
    const size_t n = a->triangles;
    all[0] = (array){ &mesh->position, 9 * n * sizeof *mesh->position };
    all[1] = (array){ &mesh->normal, 9 * n * sizeof *mesh->normal };
    all[2] = (array){ &mesh->albedo, 3 * n * sizeof *mesh->albedo };
    all[3] = (array){ &mesh->object, n * sizeof *mesh->object };
    all[4] = (array){ object, (size_t)a->objects * sizeof **object };
}

/* Reads a model in the other process; it does not return. */
static void read_apart(int to, size_t size, const char *note, const char *path, const char *format)
{
    static answer a;
    kit_soup soup = { 0 };
    kit_mesh mesh = { 0 };
    kit_object *object = NULL;
    memcpy(a.note, note, KIT_NOTE);
    a.failed = kit_assimp_read(&soup, a.note, size, path, format, &a.err) ? -1 : 0;
    one_line(a.note);
    one_line(a.err.text);
    if (!a.failed) {
        kit_soup_take(&soup, &mesh, &object, &a.objects);
        a.triangles = mesh.triangles;
        memcpy(a.lower, mesh.lower, sizeof a.lower);
        memcpy(a.upper, mesh.upper, sizeof a.upper);
        memcpy(a.origin, mesh.origin, sizeof a.origin);
    }
    array all[ARRAYS];
    void *data;
    arrays_of(all, &a, &mesh, &object);
    int failed = move_all(SEND, to, &a, sizeof a);
    for (int i = 0; i < ARRAYS && !failed; ++i) {
        memcpy(&data, all[i].of, sizeof data);
        failed = move_all(SEND, to, data, all[i].bytes);
    }
    _exit(failed != 0);
}

/* Reads the other process's answer. Returns 1 if it is complete; else the process ended too early, or no memory. */
static int take_answer(answer *a, kit_mesh *mesh, kit_object **object, int from)
{
    *mesh = (kit_mesh){ 0 };
    *object = NULL;
    if (move_all(TAKE, from, a, sizeof *a)) return 0;
    if (a->failed) return 1;
    array all[ARRAYS];
    int failed = 0;
    mesh->triangles = a->triangles;
    arrays_of(all, a, mesh, object);
    for (int i = 0; i < ARRAYS && !failed; ++i) {
        void *const data = malloc(all[i].bytes);
        memcpy(all[i].of, &data, sizeof data);
        failed = !data || move_all(TAKE, from, data, all[i].bytes);
    }
    memcpy(mesh->lower, a->lower, sizeof a->lower);
    memcpy(mesh->upper, a->upper, sizeof a->upper);
    memcpy(mesh->origin, a->origin, sizeof a->origin);
    return !failed;
}

static int ended(int status, const char *path, const char *format, kit_error *err)
{
    if (WIFSIGNALED(status) && (WTERMSIG(status) == SIGXCPU || WTERMSIG(status) == SIGKILL))
        return kit_fail(err, "%s: is %s that Assimp %s does not finish, or has no memory for", path, format,
                        kit_assimp_version());
    return kit_fail(err, "%s: is %s that Assimp %s fails on: it may be damaged", path, format, kit_assimp_version());
}

static int assimp_read(kit_mesh *mesh, kit_object **object, int *objects, char *note, size_t size, const char *path,
                       const char *format, kit_error *err)
{
    static answer a;
    int pipe_[2], status = 0;
    fflush(NULL);
    if (pipe(pipe_)) return kit_fail(err, "%s: cannot be read: %s", path, strerror(errno));
    const pid_t other = fork();
    if (!other) {
        close(pipe_[0]);
        read_apart(pipe_[1], size, note, path, format);
    }
    close(pipe_[1]);
    const int whole = other > 0 && take_answer(&a, mesh, object, pipe_[0]);
    close(pipe_[0]);
    while (other > 0 && waitpid(other, &status, 0) < 0 && errno == EINTR) continue;
    if (whole && !a.failed) {
        memcpy(note, a.note, KIT_NOTE);
        *objects = a.objects;
        return 0;
    }
    if (other > 0) {
        kit_mesh_free(mesh);
        free(*object);
    }
    if (whole) return kit_fail(err, "%s", a.err.text);
    return other > 0 ? ended(status, path, format, err)
                     : kit_fail(err, "%s: cannot be read: %s", path, strerror(errno));
}

/* ---- >>OBJ ------------------------------------------------------------------------------------------------------- */

/* Reads a file that has no other known format as OBJ. */
static int obj_read(kit_mesh *mesh, kit_object **object, int *objects, const char *path, kit_error *err)
{
    kit_error why;
    if (!strcasecmp(ending_of(path), ".obj")) return kit_mesh_obj(mesh, object, objects, path, err);
    if (!kit_mesh_obj(mesh, object, objects, path, &why)) return 0;
    const size_t named = strncmp(why.text, path, strlen(path)) ? 0 : strlen(path);
    const char *text = why.text + named + (named && why.text[named] == ':' ? 1 : 0);
    return kit_fail(err, "%s: is of no format that is known; read as an OBJ:%s", path, text);
}

/* ---- >>all ------------------------------------------------------------------------------------------------------- */

static int read_any(kit_mesh *mesh, kit_object **object, int *objects, char *note, const char *path, kit_error *err)
{
    char bytes[64] = "";
    size_t size;
    FILE *file = kit_file_open(&size, path, err);
    if (!file) return -1;
    const size_t got = fread(bytes, 1, sizeof bytes, file);
    const char *format = format_of(path, bytes, got), *ending = ending_of(path);
    fclose(file);
    *note = 0;
    if (!format && (strcasecmp(ending, ".obj") || !kit_assimp_takes(ending)))
        return obj_read(mesh, object, objects, path, err);
    if (!format) format = "OBJ";
    if (!kit_assimp_version())
        return kit_fail(err, "%s: is %s; this build reads OBJ alone: apt-get install libassimp-dev, then make", path,
                        format);
    if (!kit_assimp_takes(ending) && strncmp(format, "glTF", 4) && strcmp(format, "PLY") && strncmp(format, "FBX", 3))
        return kit_fail(err, "%s: is %s, which is not read: OBJ, glTF, PLY, FBX and what else Assimp knows are", path,
                        format);
    if (!strncmp(format, "glTF", 4) && check_gltf(note, path, err)) return -1;
    return assimp_read(mesh, object, objects, note, size, path, format, err);
}

int kit_model_read(kit_mesh *mesh, kit_object **object, int *objects, char *note, const char *path, kit_error *err)
{
    if (read_any(mesh, object, objects, note, path, err)) return -1;
    note_origin(note, mesh);
    return 0;
}
