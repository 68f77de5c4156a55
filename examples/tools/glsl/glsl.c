/* glsl.c - writes the shaders of every pass in every dialect, with every choice that changes them, as plain files to be
   read, compared and validated.

     build/glsl-text FOLDER         FOLDER/hsao.330.frag: every choice at its default; FOLDER/hsao.330.facets.frag: one
                                    field changed; in 450 also two: FOLDER/hsao.450.thickness-slabs.half-first.frag

   Each shader is in one file: a choice that changes nothing makes no file. Stages: .vert .tesc .tese .geom .frag .comp.
   Functions for shaders of your own: FOLDER/field.glsl, FOLDER/field.vulkan.glsl (ssgi_gl_field);
   FOLDER/hsao.half-first.glsl (ssgi_gl_read: reads the result of that pass); FOLDER/sh4.glsl (ssgi_gl_sh(.., 4)), and
   so on; FOLDER/reflection.glsl (ssgi_gl_reflection). ssdo's default here is an environment map. translate.sh
   translates FOLDER/hsao.vulkan.frag and the other Vulkan shaders to WGSL, HLSL and MSL: make glsl WGSL=1.

   FOLDER/manifest.json is for build steps in any language. It lists the files that belong together with their inputs
   and outputs, the fields of ssgi_gl_desc and the members of the blocks; its "about" explains it.

     build/glsl-text FOLDER 300es   only one dialect

   FOLDER/hsao-fast.1-hsao.vulkan.frag: the first step of a method (ssgi_gl_method_at), unless a file above has the same
   shader; manifest.json has the chains with their steps in order.

     build/glsl-text --chains       lists the methods, and those with other settings that are checked, too
     build/glsl-text --chain hsao,depth=LINEAR --wgsl FOLDER   only these chains, as ssgi_gl_chain_of takes them, or
                                all; in any of --330 .. --vulkan and of translate.sh's --spv --wgsl --hlsl --msl
     build/glsl-text --types        the fields of ssgi_gl_desc and members of ssgi_gl_frame as TypeScript

     build/glsl-text --passes ssgi_gl.h   examples/docs/PASSES.md: each pass's inputs and outputs, by reflection; the
                                fields of ssgi_gl_desc, from the comments of the header. make passes rewrites it */
#include "kit/kit_gl.h"
#include <errno.h>
#include <spawn.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tools/glsl/chains.h"
#include "tools/glsl/choices.h"
#include "tools/glsl/manifest.h"

enum { MOST = 1 << 14 };

static uint64_t seen[MOST];
static char file_name[MOST][128];
static int files;

static int write_file(const char *path, char *text, size_t n)
{
    kit_error err = { "out of memory" };
    const int bad = !text || kit_file_write(path, text, n, &err);
    if (bad) fprintf(stderr, "glsl-text: %s\n", err.text);
    free(text);
    return bad ? -1 : 0;
}

/* Returns the shader of a stage, or for SSGI_GL_STAGES its functions only; the caller frees it. NULL: there is none. */
static char *text_of(const ssgi_gl_desc *d, int kind, size_t *n)
{
    char *text = NULL;
    for (int turn = 0; turn < 2; ++turn) {      /* first the length, then the shader */
        *n = kind < SSGI_GL_STAGES            ? ssgi_gl_emit(text, text ? *n + 1 : 0, d, kind)
             : d->pass == SSGI_GL_PASS_AOF ? ssgi_gl_field(text, text ? *n + 1 : 0, d)
                                              : ssgi_gl_read(text, text ? *n + 1 : 0, d);
        if (!turn) text = *n ? malloc(*n + 1) : NULL;
        if (!text) break;
    }
    return text;
}

/* Writes the shader of a stage to a file of that stem, dialect and ending, unless an earlier file has the same shader.
   *name: the file that has it; NULL: there is no such stage. */
static int write_text(const char *folder, const ssgi_gl_desc *d, int kind, const char *stem, const char *more,
                      const char **name)
{
    const int named = kind < SSGI_GL_STAGES || d->shader.dialect == SSGI_GL_DIALECT_VULKAN;
    uint64_t key = ((uint64_t)d->pass * 16 + (uint64_t)(named ? d->shader.dialect : 0)) * 8 + (uint64_t)kind;
    size_t n;
    char path[1024], *text = text_of(d, kind, &n);
    int i = 0;
    *name = NULL;
    if (!n || files >= MOST) { free(text); return 0; }
    if (text) key = kit_hash(key, text, strlen(text));
    while (i < files && seen[i] != key) ++i;
    *name = file_name[i];
    if (text && i < files) { free(text); return 0; }
    seen[files++] = key;
    snprintf(file_name[i], sizeof file_name[i], "%s%s%s%s.%s", stem, named ? "." : "",
             named ? ssgi_gl_dialect_name(d->shader.dialect) : "", more, endings[kind]);
    snprintf(path, sizeof path, "%s/%s", folder, file_name[i]);
    return write_file(path, text, n);
}

/* Writes the shaders of a desc: of every stage, and its functions if at most one choice is changed. */
static int write_texts(const char *folder, const ssgi_gl_desc *d, const char *first, const char *second)
{
    const char *together[SSGI_GL_STAGES + 1] = { NULL };
    char more[96];
    snprintf(more, sizeof more, "%s%s%s%s", *first ? "." : "", first, *second ? "." : "", second);
    for (int kind = 0; kind <= (*second ? SSGI_GL_STAGES - 1 : SSGI_GL_STAGES); ++kind)
        if (write_text(folder, d, kind, ssgi_gl_pass_name(d->pass), more, &together[kind])) return -1;
    if (together[SSGI_GL_STAGE_FRAGMENT]) manifest_variant(d, together);
    if (together[SSGI_GL_STAGES]) manifest_functions(together[SSGI_GL_STAGES]);
    return 0;
}

/* ---- >>chains ---------------------------------------------------------------------------------------------------- */

/* Writes a chain's shaders in a dialect. Returns 0 also if the dialect lacks a feature of the chain (*err names it). */
static int write_chain(const char *folder, const char *name, const char *about, const ssgi_gl_chain *chain, int dialect,
                       kit_error *err)
{
    static ssgi_gl_step steps[MOST_STEPS];
    const char *together[MOST_STEPS][SSGI_GL_STAGES] = { { NULL } };
    char stem[112];
    const int count = chain_steps(steps, chain, dialect, err);
    for (int i = 0; i < count; ++i) {
        snprintf(stem, sizeof stem, "%.90s.%d-%s", name, i + 1, ssgi_gl_pass_name(steps[i].desc.pass));
        for (char *c = stem; *c; ++c) if (*c == ',' || *c == '=') *c = '-';
        for (int kind = 0; kind < SSGI_GL_STAGES; ++kind)
            if (write_text(folder, &steps[i].desc, kind, stem, "", &together[i][kind])) return -1;
    }
    if (count) manifest_chain(name, about, chain, steps, count, (const char *const (*)[SSGI_GL_STAGES])together);
    return 0;
}

/* Writes the named chains in the dialects that have the features that they need. */
static int write_named_chains(const char *folder, int dialect, kit_error *err)
{
    const char *name;
    for (int i = 0; (name = chain_at(i)) != NULL; ++i) {
        ssgi_gl_chain chain;
        kit_error lacks = { "" };
        if (chain_parse(&chain, name, SSGI_GL_DIALECT_330, err)
            || write_chain(folder, name, chain_about(name), &chain, dialect, &lacks)) return -1;
    }
    return 0;
}

static int make_folder(const char *path, kit_error *err)
{
    return mkdir(path, 0777) && errno != EEXIST ? kit_fail(err, "%s: %s", path, strerror(errno)) : 0;
}

static int write_manifest(const char *folder, kit_error *err)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/manifest.json", folder);
    if (manifest_write(path, err)) return -1;
    printf("%s: %d texts\n", folder, files);
    return 0;
}

/* Runs translate.sh on a folder's Vulkan shaders for these languages. */
static int translate(const char *folder, const char *const *targets, int count, kit_error *err)
{
    static const char script[] = "examples/tools/glsl/translate.sh";
    extern char **environ;
    char *arguments[8] = { "sh", (char *)(uintptr_t)script, (char *)(uintptr_t)folder };
    pid_t child;
    int status = 0;
    for (int i = 0; i < count; ++i) arguments[3 + i] = (char *)(uintptr_t)targets[i];
    if (access(script, R_OK)) return kit_fail(err, "--%s: needs %s: run it where the Makefile is", targets[0], script);
    fflush(stdout);
    if (posix_spawnp(&child, "sh", NULL, NULL, arguments, environ) || waitpid(child, &status, 0) < 0)
        return kit_fail(err, "--%s: sh cannot be run", targets[0]);
    return status ? kit_fail(err, "--%s: translate.sh failed", targets[0]) : 0;
}

/* ---- >>passes: as Markdown --------------------------------------------------------------------------------------- */

/* One entry of a list, which is collected and then printed in lines of at most 120 columns. */
static struct { char text[8192]; size_t length; } item;

static void __attribute__((format(printf, 1, 2))) add(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    const int n = vsnprintf(item.text + item.length, sizeof item.text - item.length, format, arguments);
    va_end(arguments);
    if (n > 0) item.length += (size_t)n;
    if (item.length >= sizeof item.text) item.length = sizeof item.text - 1;
}

static void print_item(void)
{
    while (item.length && strchr(": ", item.text[item.length - 1])) item.text[--item.length] = 0;
    printf("- ");
    kit_print_words(item.text, 2, 2, 120);
    item.length = 0;
}

/* Adds a word and the content of the first [tag: ..] of a field's comment. */
static void add_tag(const char *word, const char *comment, const char *end, const char *tag)
{
    const char *at = strstr(comment, tag);
    if (at && at < end) add("%s %.*s", word, (int)strcspn(at + strlen(tag), "]"), at + strlen(tag));
}

/* Finds the header's comment on a field: returns its beginning, and its end in *end; NULL: it has none. A field is
   "gather.samples" or "shader.version", or "gather" for the group itself. */
static const char *comment_of(const char *header, const char *field, const char **end)
{
    const char *const dot = strchr(field, '.');
    char mark[96];
    snprintf(mark, sizeof mark, dot ? "typedef struct ssgi_gl_%.*s_desc {" : "/* ---- desc.%.*s: ",
             (int)(dot ? dot - field : (int)strlen(field)), field);
    const char *at = strstr(header, mark), *stop = at ? strchr(at, dot ? '}' : '\n') : NULL;
    if (at && !dot) at += strlen(mark);
    if (at && dot) {
        snprintf(mark, sizeof mark, "%s;", dot + 1);
        for (at = strstr(at, mark); at && !strchr(" *", at[-1]); at = strstr(at + 1, mark)) {}
        const char *next = at ? strchr(at + strlen(mark), ';') : NULL;
        at = at && at < stop ? strstr(at, "/*") : NULL;
        if (!at || at > stop || (next && next < at)) return NULL;
        at += 2;
    }
    *end = at ? strstr(at, "*/") : NULL;
    return *end ? at : NULL;
}

static void add_comment(const char *comment, const char *stop)
{
    const char *limit = strstr(comment, "[limit: "), *value = strstr(comment, "[default: ");
    for (const char *c = comment; c < stop; ++c) {
        if (c == limit || c == value) c = strchr(c, ']');
        else if (c > comment && !strncmp(c, "   ", 3) && c[3] != ' ' && c[-1] != ' ' && c[-1] != ']') add(": ");
        else add("%c", *c);
    }
}

static void add_field(const char *header, const char *field, const ssgi_gl_choice *c)
{
    const char *stop, *comment = comment_of(header, field, &stop);
    add("`%s`", field);
    if (comment) add_tag(",", comment, stop, "[limit: ");
    const char *const prefix = c && *c->values ? strstr(c->sentence, "SSGI_") : NULL;
    for (const char *word = prefix ? c->values : ""; *word;) {
        const int n = (int)strcspn(word, " ");
        add("%s`%.*s%.*s`", word == c->values ? ", " : " ", (int)strcspn(prefix, " "), prefix, n, word);
        word += n + (word[n] == ' ');
    }
    if (comment) add_tag(", default", comment, stop, "[default: ");
    if (comment) {
        add(": ");
        add_comment(comment, stop);
    }
    print_item();
}

/* Prints the fields of ssgi_gl_desc by their groups: name, values, default, and the header's comment. */
static int print_fields(const char *path, kit_error *err)
{
    const ssgi_gl_choice *c;
    char *header, group[32] = "";
    size_t size;
    if (kit_file_read(&header, &size, path, err)) return -1;
    puts("\n## Fields of `ssgi_gl_desc`\n\n0 is each field's default, and means what follows `default` where that "
         "is there. The last part of a field's\nname is that of `ssgi_gl_choice_at` and of JavaScript's descs, but "
         "`filter.kind`, `.radius` and `.normals` are `filter`,\n`filter_radius` and `filter_normals` there.\n");
    for (int i = 0; (c = ssgi_gl_choice_at(i)) != NULL; ++i) {
        const size_t n = strcspn(c->field, ".");
        if (c->field[n] && (strncmp(group, c->field, n) || group[n])) {
            const char *stop, *about;
            snprintf(group, sizeof group, "%.*s", (int)n, c->field);
            about = comment_of(header, group, &stop);
            printf("\n### `%s`%s", group, about ? ": " : "");
            for (const char *at = about; at && at < stop && strncmp(at, " */", 3); ++at) {
                if (*at == '\n') at += strspn(at, "\n ") - 1;
                putchar(*at == '\n' || *at == ' ' ? ' ' : *at);
            }
            puts("\n");
        }
        add_field(header, c->field, c);
    }
    add_field(header, "shader.version", NULL);
    add_field(header, "shader.fetch", NULL);
    free(header);
    return 0;
}

/* Prints the inputs and outputs of each pass. */
static void print_passes(void)
{
    static const char *const words[3] = { "reads", "per frame", "writes" };
    static const int kinds[3][2] = { { SSGI_GL_IO_TEXTURE, SSGI_GL_IO_ATTRIBUTE },
                                     { SSGI_GL_IO_PARAM, SSGI_GL_IO_PARAM },
                                     { SSGI_GL_IO_OUTPUT, SSGI_GL_IO_CAPTURE } };
    puts("# Passes\n\nMade by `make passes`. `ssgi_gl_reflect` returns these rows for your variant, with formats, "
         "slots, and offsets in\n`ssgi_gl_frame`; the declarations in the text are printed from them.");
    variant v;
    for (int i = 0; variant_at(&v, i); ++i) {
        ssgi_gl_io io[SSGI_GL_MAX_IO];
        const int n = ssgi_gl_reflect(&v.desc, io, SSGI_GL_MAX_IO);
        printf("\n### %s\n\n", v.title);
        for (size_t k = 0; k < 3; ++k) {
            const char *between = " ";
            for (int r = 0; r < n; ++r) {
                if (io[r].kind != kinds[k][0] && io[r].kind != kinds[k][1]) continue;
                if (*between == ' ') add("%s", words[k]);
                if (k == 2) add("%s`%s` %s: %s", between, io[r].name, io[r].type, io[r].format);
                else add("%s`%s`", between, io[r].name);
                between = k == 2 ? "; " : ", ";
            }
            if (*between != ' ') print_item();
        }
        const ssgi_gl_fault *fault;
        for (int k = 0; v.desc.pass == SSGI_GL_PASS_DEBUG && (fault = ssgi_gl_fault_at(k)) != NULL; ++k) {
            add("%s: %s", fault->colour, fault->sentence);
            print_item();
        }
    }
}

static ssgi_gl_desc variant_of(int pass, int dialect, int a, int b)
{
    ssgi_gl_desc d;
    memset(&d, 0, sizeof d);
    d.pass = pass;
    d.shader.dialect = dialect;
    if (pass == SSGI_GL_PASS_SSDO) d.light.environment = SSGI_GL_ENVIRONMENT_MAP;
    return with_choice(with_choice(d, b), a);
}

/* ---- >>command line ---------------------------------------------------------------------------------------------- */

enum { MOST_CHAINS = 64, TARGETS = 4 };
static const char *const targets[TARGETS] = { "spv", "wgsl", "hlsl", "msl" };      /* of translate.sh */

typedef struct asked {
    const char *chain[MOST_CHAINS], *folder, *header;
    int         chains, dialects[SSGI_GL_DIALECTS], translated[TARGETS], types, list;
    int         alone;                      /* the only dialect, plus 1; 0: all */
} asked;

/* Takes the folder, and behind it a dialect. */
static int take_folder(void *to, const char *text, kit_error *err)
{
    asked *const a = to;
    if (!a->folder) {
        a->folder = text;
        return 0;
    }
    while (a->alone < SSGI_GL_DIALECTS && strcmp(ssgi_gl_dialect_name(a->alone++), text)) {}
    const int known = !strcmp(ssgi_gl_dialect_name(a->alone - 1), text);
    return known && !a->chains
             ? 0 : kit_fail(err, "%s: only one folder can be given (%s is one already)", text, a->folder);
}

static const char usage[] = "glsl-text --chain CHAIN .. --LANGUAGE .. FOLDER | FOLDER [DIALECT] | --chains | ..";
#define TO(member) .at = offsetof(asked, member)
#define DIALECT(name, number) { name, NULL, "GLSL of that version.", .kind = KIT_FLAG, TO(dialects[number]) }
#define TARGET(name, number, about) { name, NULL, about, .kind = KIT_FLAG, TO(translated[number]) }
static const kit_option table[] = {
    { "FOLDER [DIALECT]", NULL, "Every pass in every variant, with manifest.json: thousands of files.",
      .kind = KIT_TOLD },
    { "--chain", "CHAIN", "The shaders of chains, as hsao,balanced,thickness=back, or of all, within seconds; in:",
      .kind = KIT_LIST, TO(chain), .most = MOST_CHAINS, .said = offsetof(asked, chains) },
    DIALECT("--330", SSGI_GL_DIALECT_330), DIALECT("--410", SSGI_GL_DIALECT_410),
    DIALECT("--450", SSGI_GL_DIALECT_450), DIALECT("--300es", SSGI_GL_DIALECT_300ES),
    DIALECT("--310es", SSGI_GL_DIALECT_310ES), DIALECT("--320es", SSGI_GL_DIALECT_320ES),
    DIALECT("--vulkan", SSGI_GL_DIALECT_VULKAN), TARGET("--spv", 0, "SPIR-V."),
    TARGET("--wgsl", 1, "WGSL, for WebGPU."), TARGET("--hlsl", 2, "HLSL."), TARGET("--msl", 3, "Metal's language."),
    { "--chains", NULL, "The names of chains.", .kind = KIT_FLAG, TO(list) },
    { "--passes", "ssgi_gl.h", "The table of passes and fields, as PASSES.md has it.", .kind = KIT_TEXT, TO(header) },
    { "--types", NULL, "The TypeScript types of fields.", .kind = KIT_FLAG, TO(types) },
    { NULL }
};

/* ---- >>commands -------------------------------------------------------------------------------------------------- */

static int write_chains(const asked *a, kit_error *err)
{
    const char *target[TARGETS];
    int dialects[SSGI_GL_DIALECTS], count = 0, languages = 0;
    memcpy(dialects, a->dialects, sizeof dialects);
    for (int k = 0; k < TARGETS; ++k)
        if (a->translated[k]) target[count++] = targets[k];
    dialects[SSGI_GL_DIALECT_VULKAN] |= count > 0;
    for (int k = 0; k < SSGI_GL_DIALECTS; ++k) languages += dialects[k];
    if (!a->folder) return kit_fail(err, "--chain: the folder is missing");
    if (!languages) return kit_fail(err, "--chain: in which language: --330 .. --vulkan, --spv, --wgsl, --hlsl, --msl");
    if (make_folder(a->folder, err)) return -1;
    for (int i = 0; i < a->chains; ++i) {
        const char *const text = a->chain[i];
        const int all = !strcmp(text, "all");
        ssgi_gl_chain chain;
        for (int dialect = 0; dialect < SSGI_GL_DIALECTS; ++dialect) {
            kit_error lacks = { "" };
            if (!dialects[dialect]) continue;
            if (!all && chain_parse(&chain, text, dialect, err)) return -1;
            if (all ? write_named_chains(a->folder, dialect, err)
                    : write_chain(a->folder, text, chain_about(text), &chain, dialect, &lacks)) return -1;
            if (*lacks.text) return kit_fail(err, "--chain %s: %s", text, lacks.text);
        }
    }
    return write_manifest(a->folder, err) || (count && translate(a->folder, target, count, err)) ? -1 : 0;
}

static void list_chains(void)
{
    const char *name;
    for (int i = 0; (name = chain_at(i)) != NULL; ++i)
        printf("%-14s%s%s\n", name, *chain_about(name) ? " " : "", chain_about(name));
}

/* Writes every pass and choice in every dialect (or in one, >= 0), and every chain that has a name. */
static int write_all(const char *folder, int alone, kit_error *err)
{
    if (make_folder(folder, err)) return -1;
    choice first, second;
    for (int pass = 0; pass < SSGI_GL_PASSES; ++pass)
        for (int dialect = 0; dialect < SSGI_GL_DIALECTS; ++dialect)
            for (int a = 0; choice_at(&first, a) && (alone < 0 || alone == dialect); ++a)
                for (int b = 0; b <= (dialect == SSGI_GL_DIALECT_450 ? a : 0) && choice_at(&second, b); ++b) {
                    const ssgi_gl_desc d = variant_of(pass, dialect, a, b);
                    if (write_texts(folder, &d, first.name, second.name)) return -1;
                }
    for (int dialect = 0; dialect < SSGI_GL_DIALECTS; ++dialect)
        if ((alone < 0 || alone == dialect) && write_named_chains(folder, dialect, err)) return -1;
    for (int bands = 0; bands <= 4; ++bands) {      /* 0 bands: the functions for reflections */
        const size_t n = bands ? ssgi_gl_sh(NULL, 0, bands) : ssgi_gl_reflection(NULL, 0);
        char *text = malloc(n + 1), path[1024];
        if (text && bands) ssgi_gl_sh(text, n + 1, bands);
        if (text && !bands) ssgi_gl_reflection(text, n + 1);
        snprintf(path, sizeof path, bands ? "%s/sh%d.glsl" : "%s/reflection.glsl", folder, bands);
        if (write_file(path, text, n)) return -1;
        manifest_functions(strrchr(path, '/') + 1);
    }
    return write_manifest(folder, err);
}

static int run(const asked *a, kit_error *err)
{
    if (a->chains) return write_chains(a, err);
    if (a->header) print_passes();
    if (a->header) return print_fields(a->header, err);
    if (a->types) manifest_types();
    if (a->list) list_chains();
    if (a->types || a->list) return 0;
    return a->folder ? write_all(a->folder, a->alone - 1, err) : kit_fail(err, "the folder is missing (see --help)");
}

int main(int argc, char **argv)
{
    kit_error err = { "" };
    asked a = { .folder = NULL };
    kit_streams_open();
    const int failed = !kit_help(argc, argv, usage, table)
                    && (kit_options(&a, table, argc, argv, take_folder, &err) || run(&a, &err));
    if (!failed && !kit_streams_close(&err)) return 0;
    if (*err.text) fprintf(stderr, "glsl-text: %s\n", err.text);    /* else write_file has said why */
    return 2;
}
