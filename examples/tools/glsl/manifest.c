/* manifest.c - the manifest of the shaders that make glsl writes, made by the library's functions. Declared in
   manifest.h. */
#include "tools/glsl/manifest.h"
#include "tools/glsl/chains.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

const char *const endings[SSGI_GL_STAGES + 1] = { "vert", "frag", "tesc", "tese", "geom", "comp",
                                                      "glsl" };

/* Tables of the manifest's lines, each line once; other entries refer to a line by its number. */
enum { MOST = 1 << 14, BUCKETS = 1 << 15 };
typedef struct table { char *line[MOST]; int count, bucket[BUCKETS]; } table;
static table rows, lists, variants, functions, formats, chains;
static const char *fetch[2] = { "", "" };       /* desc.shader.fetch of CUSTOM variants; of those for Vulkan */

/* The number of a line, which is added if it is new; key: the part of it that identifies it. Without a line: the number
   of the line with that key, or -1. */
static int number_of(table *t, const char *key, const char *line)
{
    uint64_t h = kit_hash(KIT_HASH, key, strlen(key));
    for (;; ++h) {
        int *b = &t->bucket[h % BUCKETS];
        if (!*b && !line) return -1;
        if (!*b) {
            if (t->count == MOST || !(t->line[t->count] = strdup(line))) abort();
            *b = ++t->count;
        }
        if (strstr(t->line[*b - 1], key)) return *b - 1;
    }
}

/* Word i of a field's values; an empty one past the last. */
static const char *word_at(const ssgi_gl_choice *c, int i, int *length)
{
    const char *s = c->values;
    for (; i > 0 && *s; --i) s += strcspn(s, " ") + (strchr(s, ' ') != NULL);
    *length = (int)strcspn(s, " ");
    return s;
}

/* Writes the pass and the fields that are not 0; enums by their words. */
static void put_desc(FILE *f, const ssgi_gl_desc *d)
{
    const ssgi_gl_choice *c;
    for (int i = 0; (c = ssgi_gl_choice_at(i)) != NULL; ++i) {
        int value, n;
        memcpy(&value, (const char *)d + c->offset, sizeof value);
        const char *word = word_at(c, value, &n);
        if (!value && i) continue;
        fprintf(f, "%s\"%s\": ", i ? ", " : "{ ", c->name);
        if (n) fprintf(f, "\"%.*s\"", n, word); else fprintf(f, "%d", value);
    }
    fputs(" }", f);
}

static int row_number(const ssgi_gl_io *io)
{
    static const char *const kinds[] = { "TEXTURE", "PARAM", "OUTPUT", "CONSTANT", "ATTRIBUTE", "CAPTURE" };
    char *line = NULL;
    size_t size;
    FILE *f = open_memstream(&line, &size);
    if (!f) abort();
    fprintf(f, "{ \"name\": \"%s\", \"kind\": \"%s\", \"type\": \"%s\", \"slot\": %d, \"offset\": %zu, \"format\": ",
            io->name, kinds[io->kind], io->type, io->slot, io->offset);
    kit_json_string(f, io->format);
    fprintf(f, ", \"set\": %d, \"binding\": %d }", io->set, io->binding);
    fclose(f);
    const int number = number_of(&rows, line, line);
    free(line);
    return number;
}

void manifest_variant(const ssgi_gl_desc *d, const char *const files[SSGI_GL_STAGES])
{
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    char *line = NULL, *list = NULL, *names = NULL;
    const char *between = "\"files\": { ";
    size_t size;
    FILE *f = open_memstream(&names, &size);
    if (!f) abort();
    for (int s = 0; s < SSGI_GL_STAGES; ++s) {
        if (!files[s]) continue;
        fprintf(f, "%s\"%s\": \"%s\"", between, endings[s], files[s]);
        between = ", ";
    }
    fputs(" }", f);
    fclose(f);
    if (number_of(&variants, names, NULL) >= 0) { free(names); return; }
    f = open_memstream(&list, &size);
    if (!f) abort();
    const int n = ssgi_gl_reflect(d, io, SSGI_GL_MAX_IO);
    for (int i = 0; i < n; ++i) fprintf(f, "%s%d", i ? ", " : "[", row_number(&io[i]));
    fputc(']', f);
    fclose(f);
    f = open_memstream(&line, &size);
    if (!f) abort();
    fputs("{ \"desc\": ", f);
    put_desc(f, d);
    if (d->shader.fetch) fetch[d->shader.dialect == SSGI_GL_DIALECT_VULKAN] = d->shader.fetch;
    fprintf(f, ",%s \"key\": \"%.*s\", %s, \"rows\": %d }", d->shader.fetch ? " \"fetch\": true," : "",
            (int)(strrchr(files[SSGI_GL_STAGE_FRAGMENT], '.') - files[SSGI_GL_STAGE_FRAGMENT]),
            files[SSGI_GL_STAGE_FRAGMENT], names, number_of(&lists, list, list));
    fclose(f);
    number_of(&variants, names, line);
    free(list);
    free(names);
    free(line);
}

/* ---- chains ------------------------------------------------------------------------------------------------------ */

static const char *const scales[] = { "FULL", "HALF", "LEVELS", "TILES", "QUARTER" };

static int format_number(const ssgi_gl_format *format)
{
    char line[256];
    snprintf(line, sizeof line,
             "{ \"name\": \"%s\", \"bytes\": %d, \"gl\": { \"internal\": %u, \"format\": %u, \"type\": %u }, "
             "\"vulkan\": \"%s\", \"vulkan_number\": %u, \"webgpu\": \"%s\" }",
             format->name, format->bytes, format->internal, format->format, format->type, format->vulkan_name,
             format->vulkan, format->webgpu);
    return number_of(&formats, line, line);
}

/* Writes the textures that steps draw into, each once, by number. */
static void put_textures(FILE *f, const ssgi_gl_step *steps, int count)
{
    static const char *const results[] = { "NONE", "LIGHT", "BOUNCE" };
    const char *between = "";
    fputs("\"textures\": [", f);
    for (int texture = 0, found = 1; found; ++texture) {
        found = 0;
        for (int i = 0; i < count && !found; ++i)
            for (int k = 0; k < steps[i].outputs && !found; ++k) {
                const ssgi_gl_output *o = &steps[i].output[k];
                if (o->texture != texture) continue;
                found = 1;
                fprintf(f, "%s\n  { \"format\": %d, \"scale\": \"%s\", \"layers\": %d, \"kept\": %d, "
                           "\"result\": \"%s\" }", between, format_number(o->format), scales[steps[i].scale], o->layers,
                        o->kept, results[o->result]);
                between = ",";
            }
    }
    fputs("]", f);
}

static void put_input(FILE *f, const ssgi_gl_input *in)
{
    static const char *const yours[SSGI_GL_YOURS] = {
        "DEPTH", "LAYERS", "BACK", "VIEWS", "NORMAL", "ALBEDO", "LAYER_NORMALS", "LAYER_ALBEDOS", "DIRECT", "NOISE",
        "KERNEL", "ENVIRONMENT", "IRRADIANCE", "LIGHTS", "SHADOW", "OCCLUDERS", "FIELDS", "OBJECTS", "MOTION",
        "AMBIENT", "CAP" };
    fprintf(f, "{ \"name\": \"%s\", \"unit\": %d, \"binding\": %d, \"dimension\": \"%s\", \"sample\": \"%s\", ",
            in->name, in->unit, in->binding, in->array ? "2d-array" : "2d",
            in->integer ? "uint" : "unfilterable-float");
    if (in->set) fprintf(f, "\"set\": %d, ", in->set);
    if (in->multisampled) fputs("\"multisampled\": true, ", f);
    if (in->meaning < 0) fprintf(f, "\"texture\": %d, \"last\": %d }", in->texture, in->last);
    else fprintf(f, "\"yours\": \"%s\" }", yours[in->meaning]);
}

/* Writes blending in each language's words or numbers; null: off. */
static void put_blend(FILE *f, const unsigned blend[3])
{
    static const struct { unsigned gl; int vulkan; const char *webgpu; } words[] = {
        { 0x8006, 0, "add" },  { 0x800b, 2, "reverse-subtract" },               /* FUNC_ADD, FUNC_REVERSE_SUBTRACT */
        { 0x0000, 0, "zero" }, { 0x0001, 1, "one" }, { 0x0306, 4, "dst" } };    /* ZERO, ONE, DST_COLOR */
    int of[3] = { 0 };
    if (!blend[0]) { fputs("null", f); return; }
    for (int i = 0; i < 3; ++i) while (words[of[i]].gl != blend[i]) ++of[i];
    fprintf(f, "{ \"gl\": [%u, %u, %u], \"vulkan\": [%d, %d, %d], \"webgpu\": [\"%s\", \"%s\", \"%s\"] }", blend[0],
            blend[1], blend[2], words[of[0]].vulkan, words[of[1]].vulkan, words[of[2]].vulkan, words[of[0]].webgpu,
            words[of[1]].webgpu, words[of[2]].webgpu);
}

static void put_step(FILE *f, const ssgi_gl_step *s, const char *const files[SSGI_GL_STAGES])
{
    static const char *const primitives[] = { [0] = "POINTS", [4] = "TRIANGLES", [14] = "PATCHES" };
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    const char *between = "";
    fprintf(f, "{ \"pass\": \"%s\", \"files\": { ", ssgi_gl_pass_name(s->desc.pass));
    for (int k = 0; k < SSGI_GL_STAGES; ++k) {
        if (!files[k]) continue;
        fprintf(f, "%s\"%s\": \"%s\"", between, endings[k], files[k]);
        between = ", ";
    }
    fprintf(f, " }, \"scale\": \"%s\", \"frame\": %d, \"primitive\": \"%s\", \"vertices\": %d, \"instances\": %d,\n"
               "    \"blend\": ", scales[s->scale], s->frame, primitives[s->primitive], s->vertices, s->instances);
    put_blend(f, s->blend);
    fputs(", \"clear\": ", f);
    if (s->clear) fprintf(f, "%g", (double)s->clear_to); else fputs("null", f);
    fputs(", \"rows\": [", f);
    const int rows_count = ssgi_gl_reflect(&s->desc, io, SSGI_GL_MAX_IO);
    for (int i = 0; i < rows_count; ++i) fprintf(f, "%s%d", i ? ", " : "", row_number(&io[i]));
    fputs("],\n    \"inputs\": [", f);
    for (int i = 0; i < s->inputs; ++i) {
        fputs(i ? ",\n      " : "\n      ", f);
        put_input(f, &s->input[i]);
    }
    fputs("],\n    \"outputs\": [", f);
    for (int i = 0; i < s->outputs; ++i)
        fprintf(f, "%s{ \"name\": \"%s\", \"location\": %d, \"texture\": %d, \"layer\": %d }", i ? ", " : "",
                s->output[i].name, i, s->output[i].texture, s->output[i].layer);
    fputs("] }", f);
}

void manifest_chain(const char *name, const char *about, const ssgi_gl_chain *chain, const ssgi_gl_step *steps,
                    int count, const char *const (*files)[SSGI_GL_STAGES])
{
    char *line = NULL, key[4096];                           /* names as a user types them */
    const ssgi_gl_choice *choice;
    size_t size;
    int value;
    FILE *f = open_memstream(&line, &size);
    if (!f) abort();
    snprintf(key, sizeof key, "{ \"name\": \"%s\", \"dialect\": \"%s\",", name,
             ssgi_gl_dialect_name(steps[0].desc.shader.dialect));
    fprintf(f, "%s \"about\": ", key);
    kit_json_string(f, about);
    fputs(",\n\"chain\": { \"desc\": ", f);
    ssgi_gl_chain in = *chain;                              /* the same in that dialect */
    in.desc.shader.dialect = in.lights.shader.dialect = steps[0].desc.shader.dialect;
    put_desc(f, &in.desc);
    if (in.lights.pass == SSGI_GL_PASS_LIGHTS) {
        fputs(", \"lights\": ", f);
        put_desc(f, &in.lights);
    }
    for (int i = 0; (choice = ssgi_gl_chain_choice_at(i)) != NULL; ++i) {
        memcpy(&value, (const char *)chain + choice->offset, sizeof value);
        if (value) fprintf(f, ", \"%s\": %d", choice->name, value);
    }
    fputs(" },\n", f);
    put_textures(f, steps, count);
    fputs(",\n\"steps\": [", f);
    for (int i = 0; i < count; ++i) {
        fputs(i ? ",\n  " : "\n  ", f);
        put_step(f, &steps[i], files[i]);
    }
    fputs("] }", f);
    fclose(f);
    number_of(&chains, key, line);
    free(line);
}

void manifest_functions(const char *file)
{
    char line[256];
    snprintf(line, sizeof line, "\"%s\"", file);
    number_of(&functions, line, line);
}

static void put_table(FILE *f, const char *name, const table *t)
{
    fprintf(f, ",\n\"%s\": [", name);
    for (int i = 0; i < t->count; ++i) fprintf(f, "%s%s", i ? ",\n" : "\n", t->line[i]);
    fputs("\n]", f);
}

/* Bytes of a member in std140, the same as in the struct. */
static size_t bytes_of(const char *type)
{
    static const struct { const char *name; size_t bytes; } types[] = { { "float", 4 }, { "int", 4 }, { "vec2", 8 },
        { "ivec2", 8 }, { "vec4", 16 }, { "mat3", 48 }, { "mat4", 64 } };
    const size_t n = strcspn(type, "[");
    for (size_t i = 0; i < sizeof types / sizeof *types; ++i)
        if (strlen(types[i].name) == n && !memcmp(types[i].name, type, n))
            return types[i].bytes * (type[n] ? strtoul(type + n + 1, NULL, 10) : 1);
    abort();
}

/* Writes the value that ssgi_gl_frame_init gives a member: numbers, times the radius if they depend on it; "view" if
   they depend on the camera. */
static void put_default(FILE *f, const ssgi_gl_frame frame[3], const ssgi_gl_io *m)
{
    const char *at[3];
    for (int i = 0; i < 3; ++i) at[i] = (const char *)&frame[i] + m->offset;
    const size_t bytes = bytes_of(m->type);
    const int scaled = memcmp(at[0], at[1], bytes) != 0, whole = *m->type == 'i';
    if (memcmp(at[0], at[2], bytes)) {
        fputs(", \"default\": \"view\"", f);
        return;
    }
    fprintf(f, ", \"default\": %s", bytes > 4 ? "[" : "");
    for (size_t i = 0; i < bytes; i += 4) {
        int32_t n;
        float x;
        memcpy(&n, at[0] + i, 4);
        memcpy(&x, at[0] + i, 4);
        fprintf(f, "%s%.9g", i ? ", " : "", whole ? (double)n : (double)x);
    }
    fprintf(f, "%s%s", bytes > 4 ? "]" : "", scaled ? ", \"times\": \"radius\"" : "");
}

/* Frames of a camera, of the same camera with twice the radius, and of another camera. */
static void frames_to_compare(ssgi_gl_frame frame[3])
{
    for (int i = 0; i < 3; ++i) {
        const float wide = i < 2 ? 1.0f : 1.5f, zfar = 100, znear = i < 2 ? 0.25f : 0.5f;
        const float projection[16] = { wide, 0, 0, 0, 0, wide, 0, 0, 0, 0, (zfar + znear) / (znear - zfar), -1, 0, 0,
                                       2 * zfar * znear / (znear - zfar), 0 };
        ssgi_view view;
        memset(&frame[i], 0, sizeof frame[i]);
        ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, 64 << (i / 2), 64 << (i / 2), NULL);
        ssgi_gl_frame_init(&frame[i], &view, i == 1 ? 2.0f : 1.0f, NULL);
    }
}

static void put_block(FILE *f, const char *name, int block, const char *prefix, size_t size)
{
    const ssgi_gl_io *m;
    const char *between = "";
    ssgi_gl_frame compared[3];
    frames_to_compare(compared);
    fprintf(f, ",\n\"%s\": { \"size\": %zu, \"members\": [", name, size);
    for (int i = 0; (m = ssgi_gl_member_at(i)) != NULL; ++i) {
        if (m->slot != block) continue;
        fprintf(f, "%s\n{ \"name\": \"%s\", \"glsl\": \"%s\", \"type\": \"%s\", \"offset\": %zu, \"bytes\": %zu, "
                   "\"units\": ", between, m->name + strlen(prefix), m->name, m->type, m->offset, bytes_of(m->type));
        kit_json_string(f, m->format);
        if (!block) put_default(f, compared, m);
        fputs(" }", f);
        between = ",";
    }
    fputs("\n] }", f);
}

/* The explanation of the manifest, an entry a line. */
static const char *const about[] = {
    "variants: sets of files that belong together. desc: the fields of ssgi_gl_desc that are not 0, enums by their "
    "words (this manifest's desc.fields lists these in order, from 0); fetch: true: desc.shader.fetch is this "
    "manifest's fetch (vulkan: fetch_vulkan); files: by stage; rows: a number in row_lists.",
    "key of a variant: identifies it: the file of its fragment stage without the ending.",
    "chains: the draws of methods, by the names of build/render, one entry a dialect. chain: the members of "
    "ssgi_gl_chain that are not 0. textures: the targets of its steps, by number. format: a number in formats; "
    "scale: FULL, HALF (rounded up), QUARTER (rounded up), TILES (an eighth, rounded up), LEVELS (ssgi_splat_size "
    "of the picture at desc.gather.resolution, with the height times the number of levels); layers: 0: 2D, else an "
    "array of so many layers; kept: 1: two textures, which are exchanged after each frame; clear them to 0 when "
    "you make them. steps, in order. files; rows: numbers in rows; frame: ssgi_gl_step.frame; vertices, instances: "
    "0: as many as you have; blend: null: off, else equation, source, destination; clear: null, or the value that "
    "clears the targets first. inputs. yours: the meaning, SSGI_GL_YOUR_ without the prefix; without it, texture "
    "is a number in textures, and last 1 means as the last frame left it; binding, dimension and (if it is not 0) "
    "set are those of Vulkan and WebGPU, unit is GL's. outputs. texture -1: your picture; layer: the layer that is "
    "drawn.",
    "translated shaders: in the same folder as those of dialect vulkan, with .spv, .wgsl, .hlsl or .msl after the "
    "file's name. Constants in rows with an offset other than 0 are specialisation constants of that id, or "
    "overrides in WGSL.",
    "row_lists: lists of numbers in rows. rows: ssgi_gl_io, the inputs and outputs of a program, in the order of "
    "its source.",
    "frame, views: ssgi_gl_frame and ssgi_gl_views; the blocks have the same layout (std140); a mat3 has 3 columns "
    "of 4 floats. desc: ssgi_gl_desc, in C; the offsets of ints are the same on every machine; most is the "
    "greatest value, 0 the least. defaults: the values that zeros in a desc of that pass stand for "
    "(ssgi_gl_resolve).",
    "functions: files without a main, for shaders of your own (ssgi_gl_field, _read, _reflection, _sh).",
    "Python: the field pass is a keyword there: setattr(desc, 'pass', ..), getattr. cffi takes the "
    "output of gcc -E -P '-D__attribute__(x)=' ssgi_gl.h.",
    "Rust: bindgen ssgi_gl.h -- --target=x86_64-pc-windows-msvc -ffreestanding gives constants the fields' type, "
    "i32, on any 64-bit machine; without it they are u32."
};

static void put_about(FILE *f)
{
    fprintf(f, "{ \"ssgi\": \"%d.%d\",\n\"about\": [", SSGI_VERSION_MAJOR, SSGI_VERSION_MINOR);
    for (size_t i = 0; i < sizeof about / sizeof *about; ++i) {
        fputs(i ? ",\n" : "\n", f);
        kit_json_string(f, about[i]);
    }
}

/* Writes the offsets and words of ssgi_gl_desc's fields. */
static void put_fields(FILE *f)
{
    const ssgi_gl_choice *c;
    fprintf(f,
            "\n],\n\"desc\": { \"size\": %zu, \"pointer\": %zu, \"strings\": [\n"
            "{ \"name\": \"version\", \"offset\": %zu }, { \"name\": \"fetch\", \"offset\": %zu }\n], \"fields\": [",
            sizeof(ssgi_gl_desc), sizeof(char *), offsetof(ssgi_gl_desc, shader.version),
            offsetof(ssgi_gl_desc, shader.fetch));
    for (int i = 0; (c = ssgi_gl_choice_at(i)) != NULL; ++i) {
        fprintf(f, "%s\n{ \"name\": \"%s\", \"offset\": %zu, \"most\": %d, \"values\": [", i ? "," : "", c->name,
                c->offset, c->most);
        for (int k = 0, n; *c->values && k <= c->most; ++k) {
            const char *word = word_at(c, k, &n);
            fprintf(f, "%s\"%.*s\"", k ? ", " : "", n, word);
        }
        fputs("], \"sentence\": ", f);
        kit_json_string(f, c->sentence);
        fputs(" }", f);
    }
}

static void put_defaults(FILE *f)
{
    const char *name;
    fputs("\n] },\n\"defaults\": {", f);
    for (int pass = 0; (name = ssgi_gl_pass_name(pass)) != NULL; ++pass) {
        ssgi_gl_desc d;
        memset(&d, 0, sizeof d);
        d.pass = pass;
        d = ssgi_gl_resolve(&d);
        fprintf(f, "%s\n\"%s\": ", pass ? "," : "", name);
        put_desc(f, &d);
    }
    fputs("\n}", f);
}

int manifest_write(const char *path, kit_error *err)
{
    char *text = NULL;
    size_t size;
    FILE *f = open_memstream(&text, &size);
    if (!f) return kit_fail(err, "%s: out of memory", path);
    put_about(f);
    put_fields(f);
    put_defaults(f);
    put_block(f, "frame", 0, "u_ssgi_", sizeof(ssgi_gl_frame));
    put_block(f, "views", 1, "u_ssgi_view_", sizeof(ssgi_gl_views));
    put_table(f, "rows", &rows);
    put_table(f, "row_lists", &lists);
    put_table(f, "variants", &variants);
    put_table(f, "functions", &functions);
    put_table(f, "formats", &formats);
    put_table(f, "chains", &chains);
    fprintf(f, ",\n\"fetch\": ");
    kit_json_string(f, fetch[0]);
    fprintf(f, ",\n\"fetch_vulkan\": ");
    kit_json_string(f, fetch[1]);
    fputs(" }\n", f);
    fclose(f);
    const int bad = kit_file_write(path, text, size, err);
    free(text);
    return bad;
}

void manifest_types(void)
{
    const ssgi_gl_choice *c;
    puts("/** The fields of ssgi_gl_desc: 0 is each one's default. */\nexport interface Desc {");
    for (int i = 0; (c = ssgi_gl_choice_at(i)) != NULL; ++i) {
        printf("  /** %s */\n  %s?: ", c->sentence, c->name);
        for (int k = 0, n; *c->values && k <= c->most; ++k) {
            const char *word = word_at(c, k, &n);
            printf("'%.*s' | ", n, word);
        }
        puts("number;");
    }
    puts("  /** the first line(s) in place of \"#version ..\" */\n  version?: string;\n"
         "  /** GLSL of CUSTOM choices */\n  fetch?: string;\n}");
    puts("/** ssgi_gl_frame: buffer is the uniform block \"ssgi_frame\"; its members are arrays in it. */\n"
         "export interface Frame {\n  readonly buffer: ArrayBuffer;");
    const ssgi_gl_io *m;
    for (int i = 0; (m = ssgi_gl_member_at(i)) != NULL; ++i) {
        if (m->slot) continue;
        printf("  /** %s */\n  readonly %s: %s;\n", m->type, m->name + strlen("u_ssgi_"),
               m->type[0] == 'i' ? "Int32Array" : "Float32Array");
    }
    puts("}");
}
