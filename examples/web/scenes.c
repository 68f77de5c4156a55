/* scenes.c - the kit's scenes as files that the page of make web fetches: scenes FOLDER writes FOLDER/NAME.bin and
   FOLDER/scenes.json, so that page and build/render draw the same triangles from the same camera. scenes --list prints
   each name and what build/render calls it; FOLDER/NAME.png, if it is there, is named as the scene's picture.

   NAME.bin, little-endian: vertices, indices (uint32); positions (3 floats a vertex); normals (3 int16 and a 0, of
   32767; all 0 in a scan, whose corners at one place share the mean of their faces'); albedo (3 uint16, linear, of
   65535, and the number of its finish, 0: none); indices (uint32, counter-clockwise as their normals say). */
#include "kit/kit.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the page covers surfaces of these colours with: numbers of finishes.mjs. */
static const struct { const char *scene; float albedo[3]; uint16_t finish; } finishes[] = {
    { "room", { 0.62f, 0.52f, 0.42f }, 1 },                                                                /* floor */
    { "room", { 0.66f, 0.24f, 0.18f }, 2 }, { "room", { 0.30f, 0.50f, 0.34f }, 2 },                        /* walls */
    { "room", { 0.60f, 0.42f, 0.25f }, 3 }, { "room", { 0.55f, 0.38f, 0.22f }, 3 },            /* table, bookcase */
    { "room", { 0.25f, 0.17f, 0.10f }, 3 }, { "room", { 0.70f, 0.62f, 0.48f }, 3 },                /* frame, boxes */
    { "room", { 0.45f, 0.12f, 0.14f }, 4 }, { "room", { 0.75f, 0.70f, 0.55f }, 5 },                 /* rug, picture */
    { "colonnade", { 0.72f, 0.70f, 0.64f }, 6 }, { "colonnade", { 0.70f, 0.58f, 0.46f }, 7 }       /* floor, walls */
};

typedef struct corner { float at[3]; int16_t normal[4]; uint16_t albedo[4]; } corner;

static int16_t snorm(float v) { return (int16_t)lrintf(32767 * fminf(fmaxf(v, -1), 1)); }
static uint16_t unorm(float v) { return (uint16_t)lrintf(65535 * fminf(fmaxf(v, 0), 1)); }

static uint16_t finish_of(const char *scene, const float *albedo)
{
    for (size_t i = 0; i < sizeof finishes / sizeof *finishes; ++i)
        if (!strcmp(scene, finishes[i].scene) && !memcmp(albedo, finishes[i].albedo, sizeof finishes[i].albedo))
            return finishes[i].finish;
    return 0;
}

static corner corner_of(const kit_mesh *mesh, const char *scene, int scan, size_t triangle, size_t k)
{
    corner c;
    memset(&c, 0, sizeof c);
    for (size_t i = 0; i < 3; ++i) {
        c.at[i] = mesh->position[9 * triangle + 3 * k + i];
        c.normal[i] = scan ? 0 : snorm(mesh->normal[9 * triangle + 3 * k + i]);
        c.albedo[i] = unorm(mesh->albedo[3 * triangle + i]);
    }
    c.albedo[3] = finish_of(scene, mesh->albedo + 3 * triangle);
    return c;
}

/* 1: its corners run clockwise seen from where its normals point; culling wants all of them the other way. */
static int turned(const kit_mesh *mesh, size_t triangle)
{
    const float *p = mesh->position + 9 * triangle, *n = mesh->normal + 9 * triangle;
    double sum = 0;
    for (int i = 0; i < 3; ++i) {
        const int j = (i + 1) % 3, k = (i + 2) % 3;
        const double face = (double)(p[3 + j] - p[j]) * (double)(p[6 + k] - p[k])
                          - (double)(p[3 + k] - p[k]) * (double)(p[6 + j] - p[j]);
        sum += face * ((double)n[i] + (double)n[3 + i] + (double)n[6 + i]);
    }
    return sum < 0;
}

/* A scan is nearly white, as is its ground: in grey it shows what light and occlusion do to it. */
static void grey(kit_mesh *mesh)
{
    for (size_t i = 0; i < 3 * mesh->triangles; ++i) mesh->albedo[i] *= 0.6f;
}

/* Equal corners become one vertex. */
static int write_mesh(const kit_mesh *mesh, const char *scene, int scan, const char *path, uint32_t head[2])
{
    const size_t corners = 3 * mesh->triangles;
    size_t slots = 16;
    while (slots < 2 * corners) slots *= 2;
    corner *vertex = malloc((corners + 1) * sizeof *vertex);
    uint32_t *index = malloc((corners + 1) * sizeof *index), *slot = calloc(slots, sizeof *slot);
    FILE *file = vertex && index && slot ? fopen(path, "wb") : NULL;
    uint32_t vertices = 0;
    int failed = !file;
    for (size_t i = 0; i < corners && !failed; ++i) {
        const size_t t = i / 3, k = i % 3, flip = k && turned(mesh, t) ? 3 - k : k;
        const corner c = corner_of(mesh, scene, scan, t, flip);
        size_t at = (size_t)kit_hash(KIT_HASH, &c, sizeof c) & (slots - 1);
        while (slot[at] && memcmp(&vertex[slot[at] - 1], &c, sizeof c)) at = (at + 1) & (slots - 1);
        if (!slot[at]) { vertex[vertices] = c; slot[at] = ++vertices; }
        index[i] = slot[at] - 1;
    }
    head[0] = vertices;
    head[1] = (uint32_t)corners;
    failed = failed || fwrite(head, sizeof *head, 2, file) != 2;
    for (uint32_t i = 0; i < vertices && !failed; ++i) failed = fwrite(vertex[i].at, sizeof vertex[i].at, 1, file) != 1;
    for (uint32_t i = 0; i < vertices && !failed; ++i) failed = fwrite(vertex[i].normal, 8, 1, file) != 1;
    for (uint32_t i = 0; i < vertices && !failed; ++i) failed = fwrite(vertex[i].albedo, 8, 1, file) != 1;
    failed = failed || fwrite(index, sizeof *index, corners, file) != corners;
    if (file && fclose(file)) failed = 1;
    free(vertex);
    free(index);
    free(slot);
    return failed;
}

static int is_there(const char *path)
{
    FILE *file = fopen(path, "rb");
    if (file) fclose(file);
    return file != NULL;
}

int main(int count, char **word)
{
    static const struct { const char *name, *title, *from; int scan; } wanted[] = {
        { "bunny", "Bunny", "/usr/share/glmark2/models/bunny.obj", 1 },
        { "room", "Room", "room", 0 }, { "colonnade", "Colonnade", "colonnade", 0 },
        { "cornell", "Cornell box", "cornell", 0 }, { "casters", "Shapes", "casters", 0 },
        { "slats", "Veranda", "slats", 0 }, { "grass", "Grass", "grass", 0 }, { "plates", "Plates", "plates", 0 }
    };
    char path[1024];
    kit_error err;
    int written = 0;
    FILE *list;
    if (count != 2) { fprintf(stderr, "usage: scenes FOLDER | --list\n"); return 2; }
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted && !strcmp(word[1], "--list"); ++i)
        printf("%s %s\n", wanted[i].name, wanted[i].from);
    if (!strcmp(word[1], "--list")) return 0;
    snprintf(path, sizeof path, "%s/scenes.json", word[1]);
    list = fopen(path, "w");
    if (!list) { fprintf(stderr, "scenes: %s: cannot be written\n", path); return 2; }
    fprintf(list, "[");
    for (size_t i = 0; i < sizeof wanted / sizeof *wanted; ++i) {
        kit_scene scene;
        kit_camera c;
        uint32_t head[2];
        if (kit_scene_load(&scene, wanted[i].from, wanted[i].scan, &err)) {
            fprintf(stderr, "scenes: %s is left out: %s\n", wanted[i].name, err.text);
            continue;
        }
        c = scene.camera;
        kit_camera_planes(&c, &scene.mesh);
        snprintf(path, sizeof path, "%s/%s.bin", word[1], wanted[i].name);
        if (wanted[i].scan) grey(&scene.mesh);
        if (write_mesh(&scene.mesh, wanted[i].name, wanted[i].scan, path, head)) {
            fprintf(stderr, "scenes: %s: cannot be written\n", path);
            return 2;
        }
        fprintf(list, "%s\n{ \"name\": \"%s\", \"title\": \"%s\", \"triangles\": %u, \"radius\": %.9g, \"fovy\": %.9g, "
                "\"near\": %.9g, \"far\": %.9g, \"eye\": [%.9g, %.9g, %.9g], \"target\": [%.9g, %.9g, %.9g]",
                written++ ? "," : "", wanted[i].name, wanted[i].title, head[1] / 3, (double)scene.radius,
                (double)c.fovy, (double)c.znear, (double)c.zfar, (double)c.eye[0], (double)c.eye[1], (double)c.eye[2],
                (double)c.target[0], (double)c.target[1], (double)c.target[2]);
        snprintf(path, sizeof path, "%s/%s.png", word[1], wanted[i].name);
        if (is_there(path)) fprintf(list, ", \"picture\": \"%s.png\"", wanted[i].name);
        fprintf(list, " }");
        kit_scene_free(&scene);
    }
    fprintf(list, "\n]\n");
    return fclose(list) || !written ? 2 : 0;
}
