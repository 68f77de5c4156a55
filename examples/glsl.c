/* glsl.c - writes the text of every pass in every dialect, with every choice that changes it, as plain files for reading, diffing and validating.

      build/glsl-text FOLDER         FOLDER/hsao.330.frag: every choice at its default; FOLDER/hsao.330.half.frag: one choice changed; in 450 two, too:
                                     FOLDER/hsao.450.half.thin.frag

   One file a text: a choice that changes nothing makes no file. Stages: .vert .tesc .tese .geom .frag; the functions of fields alone: FOLDER/field.table.glsl (ssgi_gl_field).
   ssdo's default here is an environment map. FOLDER/sh4.glsl: ssgi_gl_sh(.., 4), and so on.

      build/glsl-text --passes       the README's table of passes, from reflection */
#include "../ssgi_gl.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

static const char custom[] =
    "uniform sampler2D my_gbuffer;\n"
    "float ssgi_custom_depth(ivec2 texel, int layer) { return layer == 0 ? texelFetch(my_gbuffer, texel, 0).w : 0.0; }\n"
    "vec3 ssgi_custom_normal(ivec2 texel) { return texelFetch(my_gbuffer, texel, 0).xyz; }\n"
    "vec3 ssgi_custom_surfel(vec3 position, vec3 normal, vec3 colour) { return colour * max(normal.y, 0.0); }\n"
    "uint ssgi_custom_object(ivec2 texel) { return texelFetch(my_gbuffer, texel, 0).w > 1.0 ? 1u : 0u; }\n";

typedef struct choice { const char *name; size_t offset; int value; } choice;
#define CHOICE(name, field, value) { name, offsetof(ssgi_gl_desc, field), value }
static const choice choices[] = {
    { "", 0, 0 }, CHOICE("orthographic", orthographic, 1), CHOICE("linear", depth, SSGI_GL_DEPTH_LINEAR), CHOICE("customdepth", depth, SSGI_GL_DEPTH_CUSTOM),
    CHOICE("unsigned", normal, SSGI_GL_NORMAL_UNSIGNED), CHOICE("octahedral", normal, SSGI_GL_NORMAL_OCTAHEDRAL), CHOICE("fromdepth", normal, SSGI_GL_NORMAL_FROM_DEPTH),
    CHOICE("customnormal", normal, SSGI_GL_NORMAL_CUSTOM), CHOICE("world", world_normals, 1), CHOICE("tile", noise, SSGI_GL_NOISE_TILE4), CHOICE("jitter", noise, SSGI_GL_NOISE_TEXTURE),
    CHOICE("march", search, SSGI_GL_MARCH), CHOICE("rays", normal_rays, 1), CHOICE("hard", hard, 1), CHOICE("thin", thin, 1), CHOICE("steps", steps, 3),
    CHOICE("square", falloff, SSGI_GL_FALLOFF_SQUARE), CHOICE("cube", falloff, SSGI_GL_FALLOFF_CUBE), CHOICE("kernel", kernel, 1), CHOICE("fade", fade, SSGI_GL_FADE_SMOOTH),
    CHOICE("lambda", fade, SSGI_GL_FADE_LAMBDA), CHOICE("ended", fade, SSGI_GL_FADE_LAMBDA_ENDED), CHOICE("range", range, 1),
    CHOICE("layers", layers, 2), CHOICE("receiver", receiver, 1), CHOICE("views", views, 2), CHOICE("viewlayers", view_layers, 2), CHOICE("sh", environment, SSGI_GL_ENVIRONMENT_SH),
    CHOICE("solidangle", bounce, SSGI_GL_BOUNCE_SOLID_ANGLE), CHOICE("patch", bounce, SSGI_GL_BOUNCE_PATCH), CHOICE("disc", bounce, SSGI_GL_BOUNCE_DISC), CHOICE("twosided", two_sided, 1),
    CHOICE("1band", bands, 1), CHOICE("2bands", bands, 2), CHOICE("3bands", bands, 3), CHOICE("4bands", bands, 4), CHOICE("packed", packed, 1), CHOICE("transfer", transfer, SSGI_GL_TRANSFER_BOTH),
    CHOICE("reflected", transfer, SSGI_GL_TRANSFER_REFLECTED), CHOICE("shaded", shaded, 1), CHOICE("exact", exact, 1), CHOICE("bentnormal", shading, SSGI_GL_SHADING_BENT_NORMAL), CHOICE("bentcone", shading, SSGI_GL_SHADING_BENT_CONE),
    CHOICE("bent", shading, SSGI_GL_SHADING_BENT), CHOICE("lamps", lamps, 1), CHOICE("albedo", albedo, 1),
    CHOICE("map", shadow, SSGI_GL_SHADOW_MAP), CHOICE("fill", shadow, SSGI_GL_SHADOW_FILL), CHOICE("unshadowed", shadow, SSGI_GL_SHADOW_NONE), CHOICE("accumulate", accumulate, 1),
    CHOICE("direct", radiance, SSGI_GL_RADIANCE_DIRECT), CHOICE("both", radiance, SSGI_GL_RADIANCE_BOTH), CHOICE("albedos", radiance, SSGI_GL_RADIANCE_ALBEDO),
    CHOICE("cubemaps", storage, SSGI_GL_STORAGE_CUBE), CHOICE("angle", measure, SSGI_FIELD_SOLID_ANGLE), CHOICE("8bit", eight_bits, 1), CHOICE("table", cap, SSGI_GL_CAP_TABLE),
    CHOICE("objects", objects, SSGI_GL_OBJECTS_TEXTURE), CHOICE("customobjects", objects, SSGI_GL_OBJECTS_CUSTOM),
    CHOICE("light", effect, SSGI_GL_EFFECT_LIGHT), CHOICE("bounce", effect, SSGI_GL_EFFECT_BOUNCE), CHOICE("specular", effect, SSGI_GL_EFFECT_SPECULAR),
    CHOICE("scatter", effect, SSGI_GL_EFFECT_SCATTER), CHOICE("levels", levels, 6), CHOICE("fixed", fixed, 1), CHOICE("tessellate", tessellate, 1), CHOICE("lit", sends, SSGI_GL_SENDS_LIGHTS),
    CHOICE("customlight", sends, SSGI_GL_SENDS_CUSTOM), CHOICE("enlarge", enlarge, 1), CHOICE("near", closely, 4), CHOICE("add", overlap, SSGI_GL_OVERLAP_ADD), CHOICE("vertical", axis, 1),
    CHOICE("half", half, 1), CHOICE("colour", colour, SSGI_GL_COLOUR), CHOICE("vectors", colour, SSGI_GL_VECTORS),
    CHOICE("gaussian", filter, SSGI_GL_GAUSSIAN), CHOICE("normals", filter_normals, 1)
};
enum { CHOICES = (int)(sizeof choices / sizeof choices[0]), MOST = 1 << 14 };

static uint64_t seen[MOST];
static int files;

static int write_file(const char *path, char *text, size_t n)
{
    FILE *file = text ? fopen(path, "wb") : NULL;
    int bad = !file || fwrite(text, 1, n, file) != n;
    if (file) bad |= fclose(file);
    if (bad) { fprintf(stderr, "glsl: %s: %s\n", path, strerror(errno)); remove(path); }
    free(text);
    return bad ? -1 : 0;
}

/* The texts of a desc that none before was: of every stage, of functions alone. */
static int write_texts(const char *folder, const ssgi_gl_desc *d, const char *first, const char *second)
{
    static const char *const endings[SSGI_GL_STAGES + 1] = { "vert", "frag", "tesc", "tese", "geom", "glsl" };
    for (int kind = 0; kind <= SSGI_GL_STAGES; ++kind) {
        const int alone = kind == SSGI_GL_STAGES;
        const size_t n = !alone ? ssgi_gl_emit(NULL, 0, d, kind) : d->pass == SSGI_GL_FIELD ? ssgi_gl_field(NULL, 0, d) : 0;
        uint64_t key = ((uint64_t)d->pass * 16 + (uint64_t)(alone ? 0 : d->dialect)) * 8 + (uint64_t)kind;
        char path[1024], *text = n && files < MOST ? malloc(n + 1) : NULL;
        int i = 0;
        if (!n || files >= MOST) continue;
        if (text && alone) ssgi_gl_field(text, n + 1, d);
        if (text && !alone) ssgi_gl_emit(text, n + 1, d, kind);
        for (const char *c = text; c && *c; ++c) key = (key ^ (uint64_t)(unsigned char)*c) * 1099511628211u;
        while (i < files && seen[i] != key) ++i;
        if (text && i < files) { free(text); continue; }
        seen[files++] = key;
        snprintf(path, sizeof path, "%s/%s%s%s%s%s%s%s.%s", folder, ssgi_gl_pass_name(d->pass), alone ? "" : ".", alone ? "" : ssgi_gl_dialect_name(d->dialect),
                 *first ? "." : "", first, *second ? "." : "", second, endings[kind]);
        if (write_file(path, text, n)) return -1;
    }
    return 0;
}

/* What each pass reads and writes, as Markdown. */
static void print_passes(void)
{
    static const struct { const char *title; ssgi_gl_desc desc; } rows[] = {
        { "`ssao`", { .pass = SSGI_GL_SSAO } }, { "`hsao`, slices", { .pass = SSGI_GL_HSAO } }, { "`hsao`, march", { .pass = SSGI_GL_HSAO, .search = SSGI_GL_MARCH } },
        { "`ssdo`, map", { .pass = SSGI_GL_SSDO, .environment = SSGI_GL_ENVIRONMENT_MAP } }, { "`ssdo`, sh", { .pass = SSGI_GL_SSDO, .environment = SSGI_GL_ENVIRONMENT_SH } },
        { "`ssdo`, bounce", { .pass = SSGI_GL_SSDO, .bounce = SSGI_GL_BOUNCE_SOLID_ANGLE } }, { "`s3ho`", { .pass = SSGI_GL_S3HO } },
        { "`s3ho`, transfer, packed", { .pass = SSGI_GL_S3HO, .transfer = SSGI_GL_TRANSFER_BOTH, .packed = 1 } }, { "`s3ho`, shaded", { .pass = SSGI_GL_S3HO, .shaded = 1 } }, { "`lights`", { .pass = SSGI_GL_LIGHTS } },
        { "`lights`, maps", { .pass = SSGI_GL_LIGHTS, .shadow = SSGI_GL_SHADOW_FILL } }, { "`senders`", { .pass = SSGI_GL_SENDERS } }, { "`shade`", { .pass = SSGI_GL_SHADE } },
        { "`shade`, packed, lamps", { .pass = SSGI_GL_SHADE, .packed = 1, .lamps = 1 } }, { "`shade`, bent cone", { .pass = SSGI_GL_SHADE, .shading = SSGI_GL_SHADING_BENT_CONE } }, { "`field`", { .pass = SSGI_GL_FIELD } },
        { "`field`, cube maps, objects", { .pass = SSGI_GL_FIELD, .storage = SSGI_GL_STORAGE_CUBE, .objects = SSGI_GL_OBJECTS_TEXTURE } },
        { "`surfels`, from triangles", { .pass = SSGI_GL_SURFELS, .dialect = SSGI_GL_410, .tessellate = 1 } }, { "`surfels`, lit", { .pass = SSGI_GL_SURFELS, .sends = SSGI_GL_SENDS_LIGHTS } },
        { "`shuffle`", { .pass = SSGI_GL_SHUFFLE } }, { "`splat`, occlusion", { .pass = SSGI_GL_SPLAT } }, { "`splat`, light", { .pass = SSGI_GL_SPLAT, .effect = SSGI_GL_EFFECT_LIGHT } },
        { "`unshuffle`", { .pass = SSGI_GL_UNSHUFFLE } }, { "`smooth`", { .pass = SSGI_GL_SMOOTH } }, { "`sum`", { .pass = SSGI_GL_SUM } }, { "`blur`", { .pass = SSGI_GL_BLUR } },
        { "`blur`, colour", { .pass = SSGI_GL_BLUR, .colour = SSGI_GL_COLOUR } }, { "`blur`, vectors", { .pass = SSGI_GL_BLUR, .colour = SSGI_GL_VECTORS } }
    };
    puts("| pass | reads | per frame | writes | fetches |\n|---|---|---|---|---|");
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        static const int kinds[3][2] = { { SSGI_GL_TEXTURE, SSGI_GL_ATTRIBUTE }, { SSGI_GL_PARAM, SSGI_GL_PARAM }, { SSGI_GL_OUTPUT, SSGI_GL_CAPTURE } };
        ssgi_gl_io io[SSGI_GL_MAX_IO];
        const int n = ssgi_gl_reflect(&rows[i].desc, io, SSGI_GL_MAX_IO);
        printf("| %s ", rows[i].title);
        for (size_t k = 0; k < 3; ++k) {
            const char *between = "| ";
            for (int r = 0; r < n; ++r) {
                if (io[r].kind != kinds[k][0] && io[r].kind != kinds[k][1]) continue;
                if (k == 2) printf("%s`%s` %s: %s", between, io[r].name, io[r].type, io[r].format);
                else printf("%s`%s`", between, io[r].name);
                between = ", ";
            }
            printf(" ");
        }
        printf("| %d |\n", ssgi_gl_fetches(&rows[i].desc));
    }
}

int main(int argc, char **argv)
{
    if (argc == 2 && !strcmp(argv[1], "--passes")) { print_passes(); return 0; }
    if (argc != 2) { fputs("usage: glsl-text FOLDER | --passes\n", stderr); return 2; }
    if (mkdir(argv[1], 0777) && errno != EEXIST) { fprintf(stderr, "glsl: %s: %s\n", argv[1], strerror(errno)); return 2; }
    for (int pass = 0; pass < SSGI_GL_PASSES; ++pass)
        for (int dialect = 0; dialect < SSGI_GL_DIALECTS; ++dialect)
            for (int a = 0; a < CHOICES; ++a)
                for (int b = 0; b <= (dialect == SSGI_GL_450 ? a : 0); ++b) {
                    ssgi_gl_desc d;
                    memset(&d, 0, sizeof d);
                    d.pass = pass;
                    d.dialect = dialect;
                    if (pass == SSGI_GL_SSDO) d.environment = SSGI_GL_ENVIRONMENT_MAP;
                    memcpy((char *)&d + choices[b].offset, &choices[b].value, b ? sizeof(int) : 0);
                    memcpy((char *)&d + choices[a].offset, &choices[a].value, a ? sizeof(int) : 0);
                    if (d.depth == SSGI_GL_DEPTH_CUSTOM || d.normal == SSGI_GL_NORMAL_CUSTOM || d.objects == SSGI_GL_OBJECTS_CUSTOM
                        || (d.sends == SSGI_GL_SENDS_CUSTOM && (pass == SSGI_GL_SURFELS || pass == SSGI_GL_SPLAT))) d.fetch = custom;
                    if (write_texts(argv[1], &d, choices[a].name, choices[b].name)) return 2;
                }
    for (int bands = 1; bands <= 4; ++bands) {
        const size_t n = ssgi_gl_sh(NULL, 0, bands);
        char *text = malloc(n + 1), path[1024];
        if (text) ssgi_gl_sh(text, n + 1, bands);
        snprintf(path, sizeof path, "%s/sh%d.glsl", argv[1], bands);
        if (write_file(path, text, n)) return 2;
    }
    printf("%s: %d texts\n", argv[1], files);
    return 0;
}
