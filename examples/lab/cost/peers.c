/* peers.c - effects as peers.mjs writes them become chains. Declared in peers.h. */
#include "lab/cost/peers.h"
#include <stdlib.h>
#include <string.h>
#include "lab/measure/script.h"

#define OUT "build/peers/cost"
enum { MOST_TEXTURES = 160, GIVEN = 4 };

/* Those given are the caller's: 0 depth, 1 and 3 normals, 2 the picture. */
typedef struct texture { double texels, bytes; } texture;
typedef struct reading {
    work *w;
    cost_chain *chain;
    texture texture[MOST_TEXTURES];
    int textures, pass;                     /* pass: the one whose lines follow; -1: none */
    char *text[2];                          /* its vertex and fragment stage */
} reading;

static double bytes_of(int format)
{
    switch (format) {
    case 0x8229: return 1;                  /* R8 */
    case 0x881A: return 8;                  /* RGBA16F */
    case 0x8814: return 16;                 /* RGBA32F */
    default: return 4;
    }
}

static VkFormat format_of(double bytes)
{
    return bytes < 2 ? VK_FORMAT_R8_UNORM : bytes > 8 ? VK_FORMAT_R32G32B32A32_SFLOAT
         : bytes > 4 ? VK_FORMAT_R16G16B16A16_SFLOAT : VK_FORMAT_R8G8B8A8_UNORM;
}

static int add_texture(reading *r, const char *text, int is_depth, kit_error *err)
{
    int width = WIDTH, height = HEIGHT, format = 0;
    if (r->textures == MOST_TEXTURES || (!is_depth && sscanf(text, "%*d %d %d %d", &width, &height, &format) != 3))
        return kit_fail(err, OUT "/manifest.txt: texture %.40s", text);
    r->texture[r->textures++] = (texture){ (double)width * height, bytes_of(format) };
    return 0;
}

/* A text as Vulkan's compilers read it. */
static char *text_of(const char *path, kit_error *err)
{
    static const char head[] = "#version 450\n#define gl_VertexID gl_VertexIndex\n";
    char *text, *whole;
    size_t size;
    if (kit_file_read(&text, &size, path, err)) return NULL;
    whole = malloc(sizeof head + size);
    if (whole) snprintf(whole, sizeof head + size, "%s%s", head, text);
    else kit_fail(err, "out of memory");
    free(text);
    return whole;
}

/* The pass whose lines were read becomes a program. */
static int end_pass(reading *r, kit_error *err)
{
    if (r->pass < 0) return 0;
    cost_pass *p = &r->chain->pass[r->pass];
    cost_program made = { .pass = "", .relaxed = 1, .stages = 2, .formats = 1,
                          .format = { format_of(p->bytes_out / ((double)p->width * p->height)) },
                          .text = { r->text[0], r->text[1] },
                          .kind = { VK_SHADER_STAGE_VERTEX_BIT, VK_SHADER_STAGE_FRAGMENT_BIT } };
    r->pass = -1;
    return (p->program = work_program(r->w, &made, err)) < 0 ? -1 : 0;
}

static int begin_pass(reading *r, const char *text, kit_error *err)
{
    char number[16], path[64];
    int shown, at = 0, target, more = 0;
    if (end_pass(r, err)) return -1;
    if (!r->chain || r->chain->passes == MOST_PASSES
        || sscanf(text, "%15s %d %*d %*f %*f %*f%n", number, &shown, &at) != 2 || !at)
        return kit_fail(err, OUT "/manifest.txt: pass %.40s", text);
    if (shown) return 0;                    /* it is no cost of the effect */
    cost_pass *p = &r->chain->pass[r->pass = r->chain->passes++];
    *p = (cost_pass){ .name = "" };
    for (text += at; sscanf(text, "%d%n", &target, &more) == 1; text += more) {
        const texture *t = &r->texture[target < r->textures ? target : 0];
        p->bytes_out += t->texels * t->bytes;
        p->width = t->texels < WIDTH * HEIGHT / 2.0 ? WIDTH / 2 : WIDTH;
        p->height = t->texels < WIDTH * HEIGHT / 2.0 ? HEIGHT / 2 : HEIGHT;
    }
    for (int k = 0; k < 2; ++k) {
        snprintf(path, sizeof path, OUT "/%s.%s", number, k ? "frag" : "vert");
        if (!(r->text[k] = text_of(path, err))) return -1;
    }
    return 0;
}

static int add_sampler(reading *r, const char *text)
{
    int number = 0;
    if (sscanf(text, "%*s %d", &number) == 1 && number < r->textures)
        r->chain->pass[r->pass].bytes_in += r->texture[number].texels * r->texture[number].bytes;
    return 0;
}

/* Whole numbers, and counts that are floats: "uniform int N;" in a text becomes "const int N = int(3);". */
static int make_constant(reading *r, const char *text, kit_error *err)
{
    char type[16], name[64], is[96], now[160], values[64] = "";
    double value[2];
    const int known = sscanf(text, "%15s %63s 1 %lf %lf", type, name, &value[0], &value[1]) - 2;
    if (known < 1 || (strcmp(type, "int") && strcmp(type, "uint") && strcmp(type, "bool") && !strstr(name, "Count")))
        return 0;
    for (int i = 0; i < known && i < 2; ++i)
        snprintf(values + strlen(values), sizeof values - strlen(values), "%s%.9g", i ? ", " : "", value[i]);
    snprintf(is, sizeof is, "uniform %s %s;", type, name);
    snprintf(now, sizeof now, "const %s %s = %s(%s);", type, name, type, values);
    for (int k = 0; k < 2; ++k) {
        char *at = strstr(r->text[k], is), *whole;
        if (!at) continue;
        const size_t size = strlen(r->text[k]) + sizeof now;
        if (!(whole = malloc(size))) return kit_fail(err, "out of memory");
        snprintf(whole, size, "%.*s%s%s", (int)(at - r->text[k]), r->text[k], now, at + strlen(is));
        free(r->text[k]);
        r->text[k] = whole;
    }
    return 0;
}

static int begin_peer(reading *r, const char *text, kit_error *err)
{
    if (end_pass(r, err)) return -1;
    r->chain = work_chain(r->w, text, err);
    return r->chain ? 0 : -1;
}

static int read_line(reading *r, char *line, kit_error *err)
{
    char *text = strchr(line, ' ');
    if (!text) return 0;
    *text++ = 0;
    return !strcmp(line, "texture") || !strcmp(line, "depth") ? add_texture(r, text, *line == 'd', err)
         : !strcmp(line, "peer")                              ? begin_peer(r, text, err)
         : !strcmp(line, "pass")                              ? begin_pass(r, text, err)
         : !strcmp(line, "sampler") && r->pass >= 0           ? add_sampler(r, text)
         : !strcmp(line, "uniform") && r->pass >= 0           ? make_constant(r, text, err)
                                                              : 0;
}

int peers_add(work *w, kit_error *err)
{
    const kit_camera camera = { .fovy = 45, .width = WIDTH, .height = HEIGHT, .znear = 0.1f, .zfar = 50,
                                .eye = { 0, 1, 4 }, .up = { 0, 1, 0 } };
    static reading r;
    char *all, *rest;
    size_t size;
    int failed = 0;
    const int ran = script_run(OUT, &camera, 0.5f, 4, 0, err);
    if (ran < 0) return -1;
    if (!ran) return kit_fail(err, "node cannot run " SCRIPT ": make peers");
    if (kit_file_read(&all, &size, OUT "/manifest.txt", err)) return -1;
    r = (reading){ .w = w, .pass = -1, .textures = GIVEN };
    for (int i = 0; i < GIVEN; ++i) r.texture[i] = (texture){ (double)WIDTH * HEIGHT, i ? 8 : 4 };
    for (char *line = strtok_r(all, "\n", &rest); line && !failed; line = strtok_r(NULL, "\n", &rest))
        failed = read_line(&r, line, err);
    free(all);
    return failed || end_pass(&r, err) ? -1 : 0;
}
