/* glsl.c - writes the text of every pass in every dialect, with every choice that changes it, as plain files for
   reading, diffing and validating.

      build/glsl-text FOLDER         FOLDER/hsao.330.frag: every choice at its default; FOLDER/hsao.330.half.frag: one
         choice changed; in 450 two, too:
                                     FOLDER/hsao.450.half.slabs.frag

   One file a text: a choice that changes nothing makes no file. Stages: .vert .tesc .tese .geom .frag; the functions of
   fields alone: FOLDER/field.glsl, FOLDER/field.vulkan.glsl (ssgi_gl_field). ssdo's default here is an environment map.
   FOLDER/sh4.glsl: ssgi_gl_sh(.., 4), and so on. translate.sh makes WGSL, HLSL and MSL of FOLDER/hsao.vulkan.frag and
   its like: make glsl WGSL=1.

   FOLDER/manifest.json says which files belong together and what they read and write, and what the fields of
   ssgi_gl_desc and the members of the blocks are (its "about" explains it): for build steps in any language.

      build/glsl-text FOLDER 300es   one dialect alone
      build/glsl-text --types        the fields of ssgi_gl_desc as TypeScript

      build/glsl-text --passes ssgi_gl.h   examples/docs/PASSES.md: what each pass reads and writes, from reflection;
                                 the fields of ssgi_gl_desc, from the comments of the header. make passes rewrites it
      build/glsl-text --golden       tests/golden.txt: a hash of the text of each pass and choice in a stage, over all
                                     dialects of GL, where the choice changes it; "+" is of all pairs of choices in
                                     450, "vulkan" of all choices in that dialect. make golden rewrites that file: its
                                     diff shows which variants a change touches */
#include "kit/kit_gl.h"
#include <errno.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "tools/glsl/choices.h"
#include "tools/glsl/manifest.h"

enum { MOST = 1 << 14 };

static uint64_t seen[MOST];
static char file_name[MOST][80];
static int files;

static int write_file(const char *path, char *text, size_t n)
{
    kit_error err = { "out of memory" };
    const int bad = !text || kit_file_write(path, text, n, &err);
    if (bad) fprintf(stderr, "glsl-text: %s\n", err.text);
    free(text);
    return bad ? -1 : 0;
}

/* The texts of a desc that none before was: of every stage, of functions alone. */
static int write_texts(const char *folder, const ssgi_gl_desc *d, const char *first, const char *second)
{
    const char *together[SSGI_GL_STAGES + 1] = { NULL };
    for (int kind = 0; kind <= SSGI_GL_STAGES; ++kind) {
        const int alone = kind == SSGI_GL_STAGES, named = !alone || d->dialect == SSGI_GL_VULKAN;
        const size_t n = !alone                     ? ssgi_gl_emit(NULL, 0, d, kind)
                         : d->pass == SSGI_GL_FIELD ? ssgi_gl_field(NULL, 0, d)
                                                    : 0;
        uint64_t key = ((uint64_t)d->pass * 16 + (uint64_t)(named ? d->dialect : 0)) * 8 + (uint64_t)kind;
        char path[1024], *text = n && files < MOST ? malloc(n + 1) : NULL;
        int i = 0;
        if (!n || files >= MOST) continue;
        if (text && alone) ssgi_gl_field(text, n + 1, d);
        if (text && !alone) ssgi_gl_emit(text, n + 1, d, kind);
        if (text) key = kit_hash(key, text, strlen(text));
        while (i < files && seen[i] != key) ++i;
        together[kind] = file_name[i];
        if (text && i < files) { free(text); continue; }
        seen[files++] = key;
        snprintf(file_name[i], sizeof file_name[i], "%s%s%s%s%s%s%s.%s", ssgi_gl_pass_name(d->pass), named ? "." : "",
                 named ? ssgi_gl_dialect_name(d->dialect) : "", *first ? "." : "", first, *second ? "." : "", second,
                 endings[kind]);
        snprintf(path, sizeof path, "%s/%s", folder, file_name[i]);
        if (write_file(path, text, n)) return -1;
    }
    if (together[SSGI_GL_FRAGMENT]) manifest_variant(d, together);
    if (together[SSGI_GL_STAGES]) manifest_functions(together[SSGI_GL_STAGES]);
    return 0;
}

/* ---- >>passes: as Markdown --------------------------------------------------------------------------------------- */

/* An item of a list, gathered, then printed in lines of at most 120 columns. */
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
    int column = 1;
    while (item.length && strchr(": ", item.text[item.length - 1])) item.text[--item.length] = 0;
    putchar('-');
    for (const char *word = strtok(item.text, " \n"); word; word = strtok(NULL, " \n")) {
        const int n = (int)strlen(word);
        if (column + 1 + n > 120) column = printf("\n ") - 1;
        column += printf(" %s", word);
    }
    putchar('\n');
    item.length = 0;
}

/* The first [tag: ..] of a comment, after a word. */
static void add_tag(const char *word, const char *comment, const char *end, const char *tag)
{
    const char *at = strstr(comment, tag);
    if (at && at < end) add("%s %.*s", word, (int)strcspn(at + strlen(tag), "]"), at + strlen(tag));
}

/* The enumerators from the one that a comment names on, to the end of its enum; as in "SSGI_GL_BILATERAL,
   SSGI_GL_GAUSSIAN" or "SSGI_GL_SSAO ..". */
static void add_names(const char *header, const char *comment, const char *end)
{
    char first[80] = "enum {\n    "; /* as make format leaves it */
    const char *name = strstr(comment, "SSGI_"), *at;
    const size_t length = name && name < end ? strspn(name, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_") : 0;
    const char *between = ", ";
    if (!length || length > 64) return;
    strncat(first, name, length);
    at = strstr(header, first);
    if (!at) return;
    for (at += strlen("enum {"); *at && *at != '}';) {
        const size_t n = strspn(at, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_");
        if (!strncmp(at, "/*", 2)) { at = strstr(at, "*/"); if (!at) return; at += 2; continue; }
        if (!strncmp(at, "SSGI_", 5) && strncmp(at, "SSGI_GL_PASSES", n)
            && strncmp(at, "SSGI_GL_DIALECTS", n)) {
            add("%s`%.*s`", between, (int)n, at);
            between = " ";
        }
        at += n ? n : 1;
    }
}

/* The fields of ssgi_gl_desc, from the header's text: name, values, default, what the comment says. */
static int print_fields(const char *path, kit_error *err)
{
    char *header;
    const char *at, *end;
    size_t size;
    if (kit_file_read(&header, &size, path, err)) return -1;
    at = strstr(header, "typedef struct ssgi_gl_desc {");
    end = at ? strstr(at, "} ssgi_gl_desc;") : NULL;
    if (!end) {
        free(header);
        return kit_fail(err, "%s: has no ssgi_gl_desc", path);
    }
    puts("\n## Fields of `ssgi_gl_desc`\n\n0 is each field's default, and means what follows `default` where that "
         "is there.\n");
    while ((at = strchr(at, '\n')) != NULL && ++at < end) {
        const char *comment = strstr(at, "/*"), *stop = comment ? strstr(comment, "*/") : NULL,
            *semicolon = strchr(at, ';'), *name = semicolon;
        if (!semicolon || !stop || semicolon > comment || comment > end) continue;
        while (name[-1] != ' ' && name[-1] != '*') --name;
        add("`%.*s`", (int)(semicolon - name), name);
        add_tag(",", comment, stop, "[limit: ");
        add_names(header, comment, stop);
        add_tag(", default", comment, stop, "[default: ");
        add(":");
        const char *limit = strstr(comment, "[limit: "), *value = strstr(comment, "[default: ");
        for (const char *c = comment + 2; c < stop; ++c) {
            if (c == limit || c == value) c = strchr(c, ']');
            else if (!strncmp(c, "SSGI_", 5)) c += strspn(c, "ABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_,. ;") - 1;
            else if (c > comment + 2 && !strncmp(c, "   ", 3) && c[3] != ' ' && c[-1] != ' ' && c[-1] != ']') add(": ");
            else add("%c", *c);
        }
        print_item();
        at = stop;
    }
    free(header);
    return 0;
}

/* What each pass reads and writes. */
static void print_passes(void)
{
    static const char *const words[3] = { "reads", "per frame", "writes" };
    static const int kinds[3][2] = { { SSGI_GL_TEXTURE, SSGI_GL_ATTRIBUTE },
                                     { SSGI_GL_PARAM, SSGI_GL_PARAM },
                                     { SSGI_GL_OUTPUT, SSGI_GL_CAPTURE } };
    puts("# Passes\n\nMade by `make passes`. `ssgi_gl_reflect` returns these rows for your variant, with formats, "
         "slots, and offsets in\n`ssgi_gl_frame`; the declarations in the text are printed from them. Fetches: the "
         "most that a pixel (of `surfels`: a\nsurfel) takes at default counts, as the text has it.");
    for (int i = 0; i < variants_count; ++i) {
        ssgi_gl_io io[SSGI_GL_MAX_IO];
        const int n = ssgi_gl_reflect(&variants[i].desc, io, SSGI_GL_MAX_IO);
        printf("\n### %s: %d fetches\n\n", variants[i].title, kit_fetches(&variants[i].desc));
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
    }
}

static ssgi_gl_desc variant_of(int pass, int dialect, int a, int b)
{
    ssgi_gl_desc d;
    memset(&d, 0, sizeof d);
    d.pass = pass;
    d.dialect = dialect;
    if (pass == SSGI_GL_SSDO) d.environment = SSGI_GL_ENVIRONMENT_MAP;
    return with_choice(with_choice(d, b), a);
}

/* The hash with a text added; unchanged where there is none. */
static uint64_t hash_of(uint64_t hash, size_t (*emit)(char *, size_t, const ssgi_gl_desc *, int), const ssgi_gl_desc *d,
                        int stage)
{
    static char text[1 << 17];
    const size_t n = emit(text, sizeof text, d, stage);
    return n ? kit_hash(hash, text, n + 1 < sizeof text ? n + 1 : sizeof text) : hash;          /* with its end */
}

static size_t emit_field(char *out, size_t capacity, const ssgi_gl_desc *d, int stage)
{
    (void)stage;
    return ssgi_gl_field(out, capacity, d);
}
static size_t emit_sh(char *out, size_t capacity, const ssgi_gl_desc *d, int stage)
{
    (void)stage;
    return ssgi_gl_sh(out, capacity, d->bands);
}

static void print_golden(void)
{
    static const uint64_t basis = KIT_HASH;
    for (int pass = 0; pass < SSGI_GL_PASSES; ++pass)
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
            uint64_t plain = 0, pairs = basis, vulkan = basis;
            for (int a = 0; a < choices_count && !ferror(stdout); ++a) {
                uint64_t hash = basis;
                for (int dialect = 0; dialect < SSGI_GL_DIALECTS; ++dialect) {
                    const ssgi_gl_desc d = variant_of(pass, dialect, a, 0);
                    uint64_t *of = dialect == SSGI_GL_VULKAN ? &vulkan : &hash;
                    *of = hash_of(*of, ssgi_gl_emit, &d, stage);
                }
                for (int b = 1; b < a; ++b) {
                    const ssgi_gl_desc d = variant_of(pass, SSGI_GL_450, a, b);
                    pairs = hash_of(pairs, ssgi_gl_emit, &d, stage);
                }
                if (hash != basis && hash != plain)
                    printf("%016llx %s.%s%s%s\n", (unsigned long long)hash, ssgi_gl_pass_name(pass), choices[a].name,
                           a ? "." : "", endings[stage]);
                if (!a) plain = hash;
            }
            if (pairs != basis)
                printf("%016llx %s.+.%s\n", (unsigned long long)pairs, ssgi_gl_pass_name(pass), endings[stage]);
            if (vulkan != basis)
                printf("%016llx %s.vulkan.%s\n", (unsigned long long)vulkan, ssgi_gl_pass_name(pass), endings[stage]);
        }
    const ssgi_gl_desc vulkan = variant_of(SSGI_GL_FIELD, SSGI_GL_VULKAN, 0, 0);
    printf("%016llx field.vulkan.glsl\n", (unsigned long long)hash_of(basis, emit_field, &vulkan, 0));
    for (int a = 0; a < choices_count; ++a) {
        const ssgi_gl_desc d = variant_of(SSGI_GL_FIELD, SSGI_GL_450, a, 0),
                           plain = variant_of(SSGI_GL_FIELD, SSGI_GL_450, 0, 0);
        const uint64_t hash = hash_of(basis, emit_field, &d, 0);
        if (!a || hash != hash_of(basis, emit_field, &plain, 0))
            printf("%016llx field.%s%sglsl\n", (unsigned long long)hash, choices[a].name, a ? "." : "");
    }
    for (int bands = 1; bands <= 4; ++bands) {
        const ssgi_gl_desc d = { .bands = bands };
        printf("%016llx sh%d.glsl\n", (unsigned long long)hash_of(basis, emit_sh, &d, 0), bands);
    }
}

static int fail(const kit_error *err)
{
    if (*err->text) fprintf(stderr, "glsl-text: %s\n", err->text);
    return *err->text ? 2 : 0;
}

static int dialect_named(const char *name)          /* -1: there is none */
{
    int i = 0;
    while (ssgi_gl_dialect_name(i) && strcmp(ssgi_gl_dialect_name(i), name)) ++i;
    return i < SSGI_GL_DIALECTS ? i : -1;
}

int main(int argc, char **argv)
{
    kit_error err = { "" };
    kit_streams_open();
    if (argc == 3 && !strcmp(argv[1], "--passes")) {
        print_passes();
        if (!print_fields(argv[2], &err)) kit_streams_close(&err);
        return fail(&err);
    }
    if (argc == 2 && !strcmp(argv[1], "--types")) {
        manifest_types();
        kit_streams_close(&err);
        return fail(&err);
    }
    if (argc < 2 || argc > 3 || (!strncmp(argv[1], "--", 2) && (argc > 2 || strcmp(argv[1], "--golden")))
        || (argc == 3 && dialect_named(argv[2]) < 0)) {
        fputs("usage: glsl-text FOLDER [DIALECT] | --passes ssgi_gl.h | --golden | --types\n", stderr);
        return 2;
    }
    if (!strcmp(argv[1], "--golden")) {
        print_golden();
        kit_streams_close(&err);
        return fail(&err);
    }
    if (mkdir(argv[1], 0777) && errno != EEXIST) {
        kit_fail(&err, "%s: %s", argv[1], strerror(errno));
        return fail(&err);
    }
    for (int pass = 0; pass < SSGI_GL_PASSES; ++pass)
        for (int dialect = 0; dialect < SSGI_GL_DIALECTS; ++dialect)
            for (int a = 0; a < choices_count; ++a)
                for (int b = 0; b <= (dialect == SSGI_GL_450 ? a : 0); ++b) {
                    const ssgi_gl_desc d = variant_of(pass, dialect, a, b);
                    if (argc == 3 && dialect_named(argv[2]) != dialect) continue;
                    if (write_texts(argv[1], &d, choices[a].name, choices[b].name)) return 2;
                }
    for (int bands = 1; bands <= 4; ++bands) {
        const size_t n = ssgi_gl_sh(NULL, 0, bands);
        char *text = malloc(n + 1), path[1024];
        if (text) ssgi_gl_sh(text, n + 1, bands);
        snprintf(path, sizeof path, "%s/sh%d.glsl", argv[1], bands);
        if (write_file(path, text, n)) return 2;
        manifest_functions(strrchr(path, '/') + 1);
    }
    char manifest[1024];
    snprintf(manifest, sizeof manifest, "%s/manifest.json", argv[1]);
    if (manifest_write(manifest, &err)) return fail(&err);
    printf("%s: %d texts\n", argv[1], files);
    kit_streams_close(&err);
    return fail(&err);
}
