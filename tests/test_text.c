/* test_text.c - the emitted text: compilers, snprintf's law, reflection, what is off leaves nothing, sentences, twins in C, fuzz, speed. */
#include "t.h"

#define SSGI_STATIC                        /* white-box: this file has its own copy of the library, for the table of chunks */
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#if defined(__GNUC__)
#pragma GCC diagnostic ignored "-Wunused-function"
#endif
#include "../ssgi_gl.h"
#include "../examples/kit/kit_gl.h"

#include <ctype.h>
#include <locale.h>
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

/* ---- >>variants: every choice of every field, each text once ----------------------------------------------------- */

typedef struct choice { const char *name; size_t offset; int count, step; } choice;   /* values 0, step, 2 step .. */
#define CHOICE(field, count, step) { #field, offsetof(ssgi_gl_desc, field), count, step }
static const choice choices[] = {
    CHOICE(pass, SSGI_GL_PASSES, 1), CHOICE(orthographic, 2, 1), CHOICE(depth, 3, 1), CHOICE(normal, 5, 1), CHOICE(world_normals, 2, 1),
    CHOICE(noise, 3, 1), CHOICE(search, 2, 1), CHOICE(normal_rays, 2, 2), CHOICE(hard, 2, 1), CHOICE(thin, 2, 1), CHOICE(half, 2, 1),
    CHOICE(filter, 2, 1), CHOICE(filter_normals, 2, 1)
};
enum { CHOICES = (int)(sizeof choices / sizeof choices[0]), MOST = 1 << 13, SLOTS = 4 * MOST, TEXT = 1 << 16 };
#define FETCH "float ssgi_custom_depth(ivec2 p) { return float(p.x); }\nvec3 ssgi_custom_normal(ivec2 p) { return vec3(p, 1.0); }"

static ssgi_gl_desc variant[MOST];
static int variants;

static int  get(const ssgi_gl_desc *d, size_t offset) { int v; memcpy(&v, (const char *)d + offset, sizeof v); return v; }
static void set(ssgi_gl_desc *d, size_t offset, int v) { memcpy((char *)d + offset, &v, sizeof v); }

static void make_variants(void)
{
    static uint64_t seen[SLOTS];           /* a hash set; 0 is the key of what ssgi_gl_check refuses */
    for (int i = 0, rest = 0; !rest; ++i) {
        ssgi_gl_desc d = { .samples = 4, .directions = 2, .steps = 3, .fetch = FETCH };
        rest = i;
        for (int k = 0; k < CHOICES; rest /= choices[k++].count) set(&d, choices[k].offset, rest % choices[k].count * choices[k].step);
        uint64_t key = rest ? 0 : ssgi_gl_key(&d), at = key;
        while (seen[at % SLOTS] && seen[at % SLOTS] != key) ++at;
        if (!key || seen[at % SLOTS] || variants == MOST) continue;
        seen[at % SLOTS] = key;
        variant[variants++] = d;
    }
}

static const char *describe(const ssgi_gl_desc *d)
{
    static _Thread_local char text[400];
    size_t n = (size_t)snprintf(text, sizeof text, "%s %s", ssgi_gl_pass_name(d->pass), ssgi_gl_dialect_name(d->dialect));
    for (int k = 1; k < CHOICES; ++k)
        if (get(d, choices[k].offset)) n += (size_t)snprintf(text + n, sizeof text - n, ", %s %d", choices[k].name, get(d, choices[k].offset));
    return text;
}

static const char *emit(char *text, const ssgi_gl_desc *d, int stage)
{
    size_t n = ssgi_gl_emit(text, TEXT, d, stage);
    CHECK(n > 0 && n < TEXT, "%s: a text of %zu characters", describe(d), n);
    return text;
}

/* Counts the places where a word stands; one that ends in a letter or digit must end there, likewise its beginning. */
static int count(const char *text, const char *word)
{
    size_t n = strlen(word);
    int found = 0;
#define PART(c) (isalnum((unsigned char)(c)) || (c) == '_')
    for (const char *p = text; (p = strstr(p, word)) != NULL; p += n)
        found += !(p > text && PART(p[-1]) && PART(*word)) && !(PART(p[n]) && PART(word[n - 1]));
    return found;
}

/* ---- >>compilers ------------------------------------------------------------------------------------------------- */

static struct { int texts; char problem[1000]; } glslang;

/* Every variant in a desktop dialect and in an ES one, in turn: each choice meets each other choice, and each dialect. Many files a call. */
static void *glslang_run(void *folder)
{
    enum { BATCH = 128 };
    static char text[TEXT];
    char path[200], line[400], file[400] = "0";
    int total = 2 * variants + SSGI_GL_DIALECTS, passed = 1;
    for (int first = 0; first < total && passed; first += BATCH) {
        for (int i = first; i < first + BATCH && i < total; ++i, ++glslang.texts) {
            int fragment = i < 2 * variants;
            ssgi_gl_desc d = variant[i / 2 % variants];
            d.dialect = fragment ? (i & 1) * 3 + (int)(ssgi_gl_key(&d) >> 20 & 1023) % 3 : i - 2 * variants;
            d.lines = i % 16 < 2;
            snprintf(path, sizeof path, "%s/%d.%s", (char *)folder, i, fragment ? "frag" : "vert");
            kit_file_write(path, text, ssgi_gl_emit(text, TEXT, &d, fragment ? SSGI_GL_FRAGMENT : SSGI_GL_VERTEX), NULL);
        }
        snprintf(path, sizeof path, "cd '%s' && glslangValidator $(ls) 2>&1 && rm *.* && echo passed", (char *)folder);
        FILE *pipe = popen(path, "r");
        for (passed = 0; pipe && fgets(line, sizeof line, pipe); passed |= !strcmp(line, "passed\n")) {
            if (isdigit((unsigned char)line[0])) memcpy(file, line, sizeof file);
            if (!strncmp(line, "ERROR", 5) && !glslang.problem[0]) snprintf(glslang.problem, sizeof glslang.problem, "%s%s", describe(&variant[atoi(file) / 2 % variants]), line + 5);
        }
        if (pipe) pclose(pipe);
        if (!passed && !glslang.problem[0]) strcpy(glslang.problem, "no answer");
    }
    return NULL;
}

static int compiles(const ssgi_gl_desc *d, int stage)
{
    static char text[TEXT], log[600];
    const char *source = emit(text, d, stage);
    GLuint shader = glCreateShader(stage == SSGI_GL_VERTEX ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
    GLint ok = 0;
    glShaderSource(shader, 1, &source, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    glDeleteShader(shader);
    return CHECK(ok, "%s: %s", describe(d), log);
}

static int desktop;                        /* an OSMesa context is open: from here to the end */

static void compilers(void)
{
    char folder[] = "/tmp/ssgi-text-XXXXXX", line[100];
    pthread_t thread;
    int has = !system("command -v glslangValidator >/dev/null 2>&1") && mkdtemp(folder) && !pthread_create(&thread, NULL, glslang_run, folder);
    CHECK(has, "glslangValidator is missing (Debian: apt-get install glslang-tools), or there is no folder in /tmp");
    for (int es = 1; es >= 0; --es) {
        double began = kit_seconds();
        kit_error err = { "" };
        GLint version[2] = { 0, 0 };
        int texts = 0;
        if (es && !kit_gl_open("egl-es", NULL)) { glGetIntegerv(GL_MAJOR_VERSION, &version[0]); glGetIntegerv(GL_MINOR_VERSION, &version[1]); }
        if (version[0] * 10 + version[1] < 32) desktop = CHECK(!kit_gl_open("osmesa", &err), "%s", err.text);    /* takes ES texts too: ARB_ES3_2_compatibility */
        if (version[0] * 10 + version[1] < 32 && !desktop) break;
        for (int dialect = es ? SSGI_GL_300ES : SSGI_GL_330; dialect < (es ? SSGI_GL_DIALECTS : SSGI_GL_300ES); ++dialect)
            for (int v = -1; v < variants; ++v, ++texts) {
                ssgi_gl_desc d = variant[v < 0 ? 0 : v];
                d.dialect = dialect;
                if (!compiles(&d, v < 0 ? SSGI_GL_VERTEX : SSGI_GL_FRAGMENT)) break;
            }
        t_note("%d texts in %.0f s: %s", texts, kit_seconds() - began, kit_gl_name());
    }
    if (!has) return;
    pthread_join(thread, NULL);
    CHECK(!glslang.problem[0], "glslangValidator: %s", glslang.problem);
    t_note("%d texts: glslangValidator; all %d variants, each in a desktop and an ES dialect in turn", glslang.texts, variants);
    snprintf(line, sizeof line, "rm -rf '%s'", folder);
    CHECK(!system(line), "%s", line);
}

/* ---- >>law: snprintf's ------------------------------------------------------------------------------------------- */

static void law(void)
{
    static char full[TEXT], part[TEXT], clean[TEXT];
    const ssgi_gl_desc descs[] = { { .samples = 3 }, { .pass = SSGI_GL_HSAO, .thin = 1, .dialect = SSGI_GL_310ES, .lines = 1 },
                                   { .pass = SSGI_GL_HSAO, .search = SSGI_GL_MARCH, .normal_rays = 2, .noise = SSGI_GL_NOISE_TEXTURE, .version = "#version 430", .fetch = "// mine" },
                                   { .pass = SSGI_GL_BLUR, .normal = SSGI_GL_NORMAL_FROM_DEPTH, .half = 1, .filter_normals = 1 } };
    memset(clean, 0x5a, sizeof clean);
    memcpy(part, clean, sizeof part);
    for (size_t k = 0; k < sizeof descs / sizeof descs[0]; ++k)
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
            size_t n = strlen(emit(full, &descs[k], stage));
            CHECK(ssgi_gl_emit(NULL, 0, &descs[k], stage) == n, "the length asked for with NULL differs");
            for (size_t capacity = 0; capacity <= n + 1; ++capacity) {
                size_t got = ssgi_gl_emit(part, capacity, &descs[k], stage), used = capacity > n ? n + 1 : capacity;
                int right = got == n && (!used || (!memcmp(part, full, used - 1) && !part[used - 1])) && !memcmp(part + used, clean, n + 64 - used);
                if (!CHECK(right, "capacity %zu of %zu: length %zu, or wrong bytes in or beyond it", capacity, n, got)) return;
                memcpy(part, clean, used);
            }
        }
    ssgi_gl_desc bad = { .steps = 65 };
    CHECK(!ssgi_gl_emit(part, TEXT, &bad, 0) && !ssgi_gl_emit(part, TEXT, NULL, 0) && !ssgi_gl_emit(part, TEXT, descs, -1) && !ssgi_gl_emit(part, TEXT, descs, SSGI_GL_STAGES)
          && !ssgi_gl_emit(NULL, 1, descs, 0) && !memcmp(part, clean, TEXT), "a bad desc or stage gave text");
}

static void same_bytes(void)
{
    static char one[TEXT], two[TEXT];
    static const char *const names[] = { "de_DE.UTF-8", "de_DE.utf8", "de_DE", "fr_FR.UTF-8", "fr_FR.utf8", "nl_NL.UTF-8", "it_IT.UTF-8" };
    const char *with = NULL;
    ssgi_gl_desc a = { .version = "#version 330 core\n", .fetch = FETCH }, b = a;   /* ssao: the kernel's numbers */
    char version[] = "#version 330 core\n", fetch[] = FETCH;
    b.version = version;
    b.fetch = fetch;
    emit(one, &a, SSGI_GL_FRAGMENT);
    CHECK(!strcmp(one, emit(two, &b, SSGI_GL_FRAGMENT)) && ssgi_gl_key(&a) == ssgi_gl_key(&b), "equal strings at another place change the text or the key");
    for (size_t i = 0; i < sizeof names / sizeof names[0] && !with; ++i) if (setlocale(LC_ALL, names[i])) with = names[i];
    if (with) {
        snprintf(two, sizeof two, "%.1f", 0.5);
        CHECK(two[1] == ',', "locale %s has no decimal comma", with);
        CHECK(!strcmp(one, emit(two, &a, SSGI_GL_FRAGMENT)), "another text under locale %s", with);
        setlocale(LC_ALL, "C");
    }
    t_note(with ? "locale tried: %s" : "no locale with a decimal comma is installed: %s not tried", with ? with : names[0]);
    version[9] = '4';
    CHECK(ssgi_gl_key(&a) != ssgi_gl_key(&b), "another version has the same key");
}

/* ---- >>reflection ------------------------------------------------------------------------------------------------ */

/* Reads the declarations back from the text, line by line, and compares them with the rows in their order. */
static int compare_rows(const char *text, const ssgi_gl_desc *d, const ssgi_gl_io *row, int rows)
{
    const char *end = strstr(text, "\n\n"), *line = strchr(text, '\n') + 1, *outside = "uniform \0layout(\0const int \0out \0in ";
    int es = d->dialect >= SSGI_GL_300ES, bindings = d->dialect == SSGI_GL_450 || d->dialect >= SSGI_GL_310ES, at = 0, block = 0;
    size_t offset = 0;
    if (!CHECK(end, "%s: no end of the declarations", describe(d))) return 0;
    for (; line < end; line = strchr(line, '\n') + 1) {
        ssgi_gl_io io = { NULL, -1, "int", 0, 0, "" };
        char name[64] = "", type[32] = "", format[200] = "", begin[64] = "";
        if (es && !strncmp(line, "precision highp ", 16)) continue;
        if (!strncmp(line, "};", 2)) { block = 0; continue; }
        if (!strncmp(line, bindings ? "layout(std140, binding = 0) uniform ssgi_frame {\n" : "layout(std140) uniform ssgi_frame {\n", 36)) { block = 1; continue; }
        if (block && sscanf(line, "    %31s %63[^;]; // %199[^\n]", type, name, format) >= 2) {   /* std140, counted here anew */
            size_t align = !strcmp(type, "float") ? 4 : !strcmp(type, "ivec2") ? 8 : 16, size = !strcmp(type, "mat3") ? 48 : align;
            offset = (offset + align - 1) / align * align;
            io.kind = SSGI_GL_PARAM;
            io.offset = offset;
            offset += size;
            if (!strncmp(name, "u_ssgi_gap", 10)) continue;
        } else if (sscanf(line, "const int %63s = %d;", name, &io.slot) == 2) {
            io.kind = SSGI_GL_CONSTANT;
            strcpy(type, "int");
        } else if (sscanf(line, "layout(location = %d) out %31s %63[^;]; // %199[^\n]", &io.slot, type, name, format) == 4) io.kind = SSGI_GL_OUTPUT;
        else if (bindings ? sscanf(line, "layout(binding = %d) uniform %31s %63[^;]; // %199[^\n]", &io.slot, type, name, format) == 4
                          : sscanf(line, "%63s %31s %63[^;]; // %199[^\n]", begin, type, name, format) == 4 && !strcmp(begin, "uniform")) io.kind = SSGI_GL_TEXTURE;
        int same = at < rows && row[at].kind == io.kind && !strcmp(row[at].name, name) && !strcmp(row[at].type, type) && !strcmp(row[at].format, format)
                   && row[at].offset == io.offset && (row[at].slot == io.slot || (io.kind == SSGI_GL_TEXTURE && !bindings));
        if (!CHECK(same, "%s: \"%.*s\" is not row %d, %s", describe(d), (int)strcspn(line, "\n"), line, at, at < rows ? row[at].name : "none")) return 0;
        ++at;
    }
    for (const char *w = outside; *w; w += strlen(w) + 1) {
        char start[16] = "\n";
        CHECK(!strstr(end, strcat(start, w)), "%s: a declaration after the declarations: %s", describe(d), w);
    }
    return CHECK(at == rows, "%s: %d declarations, %d rows", describe(d), at, rows);
}

/* What GL says of a linked program: places in the block, bindings without a call, every texture is read. */
static int ask_gl(const char *text, const ssgi_gl_desc *d, const ssgi_gl_io *row, int rows)
{
    static char vertex[TEXT];
    static const GLenum stage[] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER };
    const char *const source[] = { emit(vertex, d, SSGI_GL_VERTEX), text };
    kit_error err = { "" };
    GLuint program = kit_program(source, stage, 2, &err), block;
    GLint size = 0, binding = -1;
    if (!CHECK(program, "%s: %s", describe(d), err.text)) return 0;
    block = glGetUniformBlockIndex(program, "ssgi_frame");
    glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
    glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_BINDING, &binding);
    CHECK(binding == 0 && size > 0 && (size_t)size <= sizeof(ssgi_gl_frame), "%s: block of %d bytes at %d", describe(d), size, binding);
    for (int i = 0; i < rows; ++i) {
        GLuint index = GL_INVALID_INDEX;
        GLint value = -1, want = row[i].slot;
        if (row[i].kind == SSGI_GL_CONSTANT) continue;
        if (row[i].kind == SSGI_GL_PARAM) {
            want = (GLint)row[i].offset;
            glGetUniformIndices(program, 1, &row[i].name, &index);
            if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &value);
        } else if (row[i].kind == SSGI_GL_OUTPUT) value = glGetFragDataLocation(program, row[i].name);
        else if (glGetUniformLocation(program, row[i].name) >= 0) glGetUniformiv(program, glGetUniformLocation(program, row[i].name), &value);
        CHECK(value == want, "%s: %s is at %d for GL, the row says %d", describe(d), row[i].name, value, want);
    }
    glDeleteProgram(program);
    return 1;
}

static void reflection(void)
{
    static char text[TEXT];
    static uint64_t seen[1024];
    ssgi_gl_io row[SSGI_GL_MAX_IO], few[2];
    int linked = 0;
    for (int i = 0; i < variants * SSGI_GL_DIALECTS; ++i) {
        ssgi_gl_desc d = variant[i / SSGI_GL_DIALECTS];
        d.dialect = i % SSGI_GL_DIALECTS;
        int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO), s = 0;
        uint64_t hash = 14695981039346656037u;
        if (!compare_rows(emit(text, &d, SSGI_GL_FRAGMENT), &d, row, rows)) break;
        if (d.dialect != SSGI_GL_450 || !desktop) continue;
        for (const char *c = text; c < strstr(text, "\n\n"); ++c) hash = (hash ^ (uint64_t)*c) * 1099511628211u;
        while (s < linked && seen[s] != hash) ++s;
        if (s < linked || linked == 1024) continue;
        seen[linked++] = hash;
        if (!ask_gl(text, &d, row, rows)) break;
        few[1] = row[3];
        CHECK(ssgi_gl_reflect(&d, few, 1) == rows && few[0].name == row[0].name && few[1].name == row[3].name, "more rows than there is room for");
    }
    t_note("%d texts read back, %d different sets of declarations linked", variants * SSGI_GL_DIALECTS, linked);
    emit(text, variant, SSGI_GL_VERTEX);
    CHECK(!strstr(text, "ssgi") && !strstr(text, "uniform") && !strstr(text, "layout"), "the vertex stage declares something");
    CHECK(!ssgi_gl_reflect(NULL, row, 1) && !ssgi_gl_reflect(variant, NULL, 1) && ssgi_gl_reflect(variant, NULL, 0) > 0, "reflection of nothing");
}

/* ---- >>off: what is off leaves nothing ---------------------------------------------------------------------------- */

static void off(void)
{
    static char text[TEXT];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    for (int v = 0; v < 2 * variants; ++v) {
        ssgi_gl_desc copy = variant[v / 2], *d = &copy;
        d->lines = v & 1;
        int ssao = d->pass == SSGI_GL_SSAO, hsao = d->pass == SSGI_GL_HSAO, blur = d->pass == SSGI_GL_BLUR, march = hsao && d->search == SSGI_GL_MARCH, slices = hsao && !march;
        int rays = march && d->normal_rays, box = blur && d->filter == SSGI_GL_BILATERAL, normals = !blur || box, from_depth = normals && d->normal == SSGI_GL_NORMAL_FROM_DEPTH;
        int depth = !blur || d->half || from_depth, map = normals && d->normal < SSGI_GL_NORMAL_FROM_DEPTH, ortho = d->orthographic;
        const struct { const char *word; int wanted; } table[] = {
            { "#line", d->lines }, { "SSGI_KERNEL", ssao }, { "SSGI_SAMPLES", ssao }, { "SSGI_STEPS", hsao }, { "SSGI_DIRECTIONS", hsao }, { "SSGI_FILTER_RADIUS", blur },
            { "SSGI_NORMAL_RAYS", rays }, { "ssgi_ray(", rays }, { "ssgi_above(", rays }, { "ssgi_horizon(", march }, { "ssgi_attenuation(", march },
            { "max(1.0 - d / u_ssgi_radius", march && !d->hard }, { "d < u_ssgi_radius ?", march && d->hard }, { "ssgi_arc(", slices }, { "ssgi_screen(", slices },
            { "last", slices && !d->hard }, { "back", slices && d->thin }, { "u_ssgi_thickness", d->thin && (ssao || slices || rays) },
            { "ssgi_blocked(", ssao || rays }, { "ssgi_lift(", ssao || march }, { "u_ssgi_offset", ssao || march },
            { "ssgi_noise(", !blur }, { "u_ssgi_phase", !blur }, { "t_ssgi_noise", !blur && d->noise == SSGI_GL_NOISE_TEXTURE },
            { "52.9829189", !blur && d->noise == SSGI_GL_NOISE_GRADIENT }, { "& 3", !blur && d->noise == SSGI_GL_NOISE_TILE4 },
            { "/ 2", d->half }, { "p *= 2", d->half && !blur }, { "h * 2", d->half && blur }, { "ssgi_off_plane(", box }, { "exp(", blur && !box },
            { "dot(n, ssgi_normal(q", box && d->filter_normals }, { "tent", box && d->half }, { "t_ssgi_ao", blur }, { "vec2 o_ssgi_ao", !blur }, { "float o_ssgi_ao", blur },
            { "u_ssgi_decode", depth && d->depth == SSGI_GL_DEPTH_WINDOW }, { "ssgi_decode(", depth && d->depth == SSGI_GL_DEPTH_WINDOW },
            { "t_ssgi_depth", depth && d->depth != SSGI_GL_DEPTH_CUSTOM }, { "ssgi_custom_depth(p +", depth && d->depth == SSGI_GL_DEPTH_CUSTOM }, { "ssgi_depth(", depth },
            { "t_ssgi_normal", map }, { "ssgi_unit(", normals }, { "ssgi_custom_normal(p +", normals && d->normal == SSGI_GL_NORMAL_CUSTOM }, { "ssgi_tangent(", from_depth },
            { "xyz * 2.0", normals && d->normal == SSGI_GL_NORMAL_UNSIGNED }, { "abs(e.x)", normals && d->normal == SSGI_GL_NORMAL_OCTAHEDRAL },
            { "u_ssgi_rotation", normals && d->world_normals }, { "ssgi_toward(", slices || from_depth }, { "ssgi_project(", ssao || march },
            { "(u_ssgi_project.xy / -P.z)", (ssao || hsao) && !ortho }, { "-inversesqrt(dot(P, P))", (slices || from_depth) && !ortho },
            { "1.0 / w", depth && d->depth == SSGI_GL_DEPTH_WINDOW && !ortho } };
        emit(text, d, SSGI_GL_FRAGMENT);
        for (size_t i = 0; i < sizeof table / sizeof table[0]; ++i)
            CHECK((count(text, table[i].word) > 0) == table[i].wanted, "%s: \"%s\" is %s", describe(d), table[i].word, table[i].wanted ? "missing" : "there");
        for (int i = 0, n = ssgi_gl_reflect(d, row, SSGI_GL_MAX_IO); i < n; ++i)
            CHECK(count(text, row[i].name) > 1, "%s: %s is declared and not used", describe(d), row[i].name);
        for (const char *line = text; *line; line += strcspn(line, "\n") + 1) {          /* "type ssgi_name(": defined once, called */
            char name[64];
            if (!islower((unsigned char)*line) || sscanf(line, "%*[a-z0-9] %61[a-z_](", name) != 1 || strncmp(name, "ssgi_", 5) || !strncmp(name, "ssgi_custom", 11)) continue;
            CHECK(strchr(strstr(text, strcat(name, "(")) + 1, '\n') && count(text, name) > 1, "%s: %s is never called", describe(d), name);
        }
    }
}

/* ---- >>lint ------------------------------------------------------------------------------------------------------ */

static int reserved(const char *word, size_t n)   /* in any dialect, and not used by us as what it is */
{
    static const char words[] = " common partition active asm class union enum typedef template this resource goto inline noinline public static extern external interface long "
        "short half fixed unsigned superp input output filter sizeof cast namespace using sample patch subroutine coherent volatile restrict readonly writeonly shared buffer "
        "atomic_uint precise smooth flat noperspective centroid attribute varying double switch case default do while discard inout image1D image2D lowp mediump invariant "
        "hvec2 hvec3 hvec4 fvec2 fvec3 fvec4 dvec2 dvec3 dvec4 sampler3DRect struct in texture texture2D noise1 noise2 row_major packed ";
    char key[64];
    if (n > 60) return 1;
    snprintf(key, sizeof key, " %.*s ", (int)n, word);
    return strstr(words, key) != NULL;
}

static void lint(void)
{
    static char text[TEXT];
    for (int p = 0; p < SSGI_GL__ROWS; ++p)
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage)
            for (const ssgi_gl__chunk *const *c = ssgi_gl__passes[p].chunks[stage]; *c; ++c) {
                const char *chunk = (*c)->text, *t = chunk;
                size_t n = strlen(chunk);
                CHECK(n <= 4095 && (!n || chunk[n - 1] == '\n'), "line %d: a chunk of %zu characters, or without \\n at its end", (*c)->line, n);
                for (int fresh = 1; *t; fresh = *t++ == '\n') {
                    size_t k = 0;
                    if (t[0] == '/' && t[1] == '/') t += strcspn(t, "\n");
                    if (fresh && isalpha((unsigned char)*t)) {                      /* at global scope */
                        const char *name = strchr(t + (strncmp(t, "const ", 6) ? 0 : 6), ' ') + 1;
                        CHECK(!strncmp(name, "ssgi_", 5) || !strncmp(name, "SSGI_", 5) || !strncmp(name, "main(", 5), "line %d: not our name: %.30s", (*c)->line, name);
                    }
                    if (!isalpha((unsigned char)*t)) continue;
                    while (PART(t[k])) ++k;
                    CHECK(!reserved(t, k), "line %d: reserved: %.*s", (*c)->line, (int)k, t);
                    t += k - 1;
                }
            }
    for (int i = 0; i < variants * SSGI_GL_DIALECTS; i += 7) {
        ssgi_gl_desc d = variant[i / SSGI_GL_DIALECTS];
        d.dialect = i % SSGI_GL_DIALECTS;
        const char *c = emit(text, &d, SSGI_GL_FRAGMENT);
        for (; *c; ++c) {
            int ok = ((*c >= ' ' && *c < 127) || *c == '\n') && !(c[0] == '_' && c[1] == '_') && !(c[0] == ' ' && c[1] == '\n') && !(c[0] == '\\');
            if (!CHECK(ok, "%s: not ASCII, a tab, __, a backslash or a space at a line's end: \"%.20s\"", describe(&d), c)) return;
        }
        CHECK(c[-1] == '\n', "%s: the text does not end its line", describe(&d));
    }
}

/* ---- >>sentences -------------------------------------------------------------------------------------------------- */

#define NAMES(sentence, start) (strncmp(sentence, start, strlen(start)) == 0)

static void sentences(void)
{
#define INT(field, most) { "desc." #field ":", offsetof(ssgi_gl_desc, field), most }
    static const struct { const char *start; size_t offset; int most; } ints[] = {
        INT(pass, 2), INT(dialect, 5), INT(orthographic, 1), INT(depth, 2), INT(normal, 4), INT(world_normals, 1), INT(noise, 2), INT(samples, 64), INT(search, 1),
        INT(directions, 32), INT(steps, 64), INT(normal_rays, 8), INT(hard, 1), INT(thin, 1), INT(half, 1), INT(filter, 1), INT(filter_radius, 4), INT(filter_normals, 1), INT(lines, 1) };
    static const struct { const char *start; ssgi_gl_desc desc; } rules[] = {
        { "desc.normal_rays:", { .pass = SSGI_GL_HSAO, .normal_rays = 1 } }, { "desc.world_normals:", { .normal = SSGI_GL_NORMAL_FROM_DEPTH, .world_normals = 1 } },
        { "desc.filter:", { .pass = SSGI_GL_BLUR, .half = 1, .filter = SSGI_GL_GAUSSIAN } },
        { "desc.fetch:", { .depth = SSGI_GL_DEPTH_CUSTOM } }, { "desc.fetch:", { .normal = SSGI_GL_NORMAL_CUSTOM } } };
    const char *why = "";
    CHECK(offsetof(ssgi_gl_desc, version) / sizeof(int) - sizeof ints / sizeof ints[0] < 2, "desc has ints that this test does not know");
    CHECK(ssgi_gl_check(NULL, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "desc:"), "NULL: %s", why);
    for (size_t i = 0; i < sizeof ints / sizeof ints[0]; ++i)
        for (int k = 0; k < 4; ++k) {
            const int value[4] = { -1, ints[i].most + 1, INT32_MIN, INT32_MAX };
            ssgi_gl_desc d = { .search = SSGI_GL_MARCH, .fetch = FETCH }, was;
            set(&d, ints[i].offset, ints[i].most);
            CHECK(ssgi_gl_check(&d, &why) == SSGI_OK, "%s %d is refused: %s", ints[i].start, ints[i].most, why);
            set(&d, ints[i].offset, value[k]);
            why = "";
            CHECK(ssgi_gl_check(&d, &why) == SSGI_BAD_ARGUMENT && NAMES(why, ints[i].start) && ssgi_gl_check(&d, NULL) == SSGI_BAD_ARGUMENT, "%s %d: \"%s\"", ints[i].start, value[k], why);
            was = d;
            why = "";
            CHECK(ssgi_gl_preset(&d, SSGI_GL_BEST, &why) == SSGI_BAD_ARGUMENT && NAMES(why, ints[i].start) && !memcmp(&d, &was, sizeof d), "preset: \"%s\"", why);
        }
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; ++i) {
        why = "";
        CHECK(ssgi_gl_check(&rules[i].desc, &why) == SSGI_BAD_ARGUMENT && NAMES(why, rules[i].start), "%s \"%s\"", rules[i].start, why);
    }
    for (int v = 0; v < variants; ++v)
        for (int preset = -1; preset < 4; ++preset) {
            ssgi_gl_desc d = variant[v];
            ssgi_result r = ssgi_gl_preset(&d, preset, &why), want = preset < 0 || preset > 2 ? SSGI_BAD_ARGUMENT : SSGI_OK;
            CHECK(r == want && (r == SSGI_OK || (NAMES(why, "preset:") && !memcmp(&d, &variant[v], sizeof d))), "preset %d: \"%s\"", preset, why);
            CHECK(ssgi_gl_check(&d, &why) == SSGI_OK, "preset %d of %s leaves a bad desc: %s", preset, describe(&variant[v]), why);
        }

    static const float m[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 }, radii[] = { 0, -1, NAN, INFINITY, -INFINITY, 2e18f };
    ssgi_view view, none;
    ssgi_gl_frame frame, was;
    memset(&none, 0, sizeof none);
    memset(&was, 0x5a, sizeof was);
    frame = was;
    ssgi_view_from_projection(&view, m, SSGI_CLIP_GL, 64, 32, NULL);
    CHECK(ssgi_gl_frame_init(NULL, &view, 1, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "frame:"), "%s", why);
    CHECK(ssgi_gl_frame_init(&frame, NULL, 1, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "view:"), "%s", why);
    CHECK(ssgi_gl_frame_init(&frame, &none, 1, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "view:"), "%s", why);
    for (size_t i = 0; i < sizeof radii / sizeof radii[0]; ++i)
        CHECK(ssgi_gl_frame_init(&frame, &view, radii[i], &why) == SSGI_BAD_ARGUMENT && NAMES(why, "radius:"), "radius %g: %s", (double)radii[i], why);
    CHECK(!memcmp(&frame, &was, sizeof frame), "a refused frame was written to");
    CHECK(ssgi_gl_frame_init(&frame, &view, 0.5f, NULL) == SSGI_OK && frame.radius == 0.5f && frame.thickness == 0.5f && frame.offset == 1.5f && frame.phase == 0.0f
          && frame.rotation[0] == 1.0f && frame.rotation[5] == 1.0f && frame.rotation[10] == 1.0f && frame.size[0] == 64 && frame.size[1] == 32, "the frame's defaults");
}

/* ---- >>twins: GLSL against C --------------------------------------------------------------------------------------- */

enum { SIDE = 64, MANY = SIDE * SIDE };
static float in[MANY][4], out[MANY][4];
static uint32_t random_state;

static float uniform(float lower, float upper)
{
    random_state = random_state * 1664525u + 1013904223u;
    return lower + (upper - lower) * (float)(random_state >> 8) * (1.0f / 16777216.0f);
}

/* The text of a pass up to its main, and a main that makes o of a, one input: in to out. maps: what all its textures read. */
static int probe(const ssgi_gl_desc *d, const ssgi_gl_frame *frame, GLuint maps, const char *statements)
{
    static char vertex[TEXT], text[TEXT], rest[2000];
    static const GLenum stage[] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER }, buffers[] = { GL_NONE, GL_COLOR_ATTACHMENT1 };
    const char *const source[] = { emit(vertex, d, SSGI_GL_VERTEX), emit(text, d, SSGI_GL_FRAGMENT) };
    kit_error err = { "" };
    GLuint program, block, framebuffer, target = kit_texture(SIDE, SIDE, GL_RGBA32F, NULL), input = kit_texture(SIDE, SIDE, GL_RGBA32F, in[0]);
    int read;
    snprintf(rest, sizeof rest, "layout(location = 1) out vec4 o;\nlayout(binding = 7) uniform sampler2D t_in;\n"
             "void main()\n{\n    ivec2 texel = ivec2(gl_FragCoord.xy);\n    vec4 a = texelFetch(t_in, texel, 0);\n    %s\n}\n", statements);
    strcpy(strstr(text, "void main"), rest);
    program = kit_program(source, stage, 2, &err);
    if (!CHECK(program, "%s", err.text)) return 0;
    glGenBuffers(1, &block);
    glBindBuffer(GL_UNIFORM_BUFFER, block);
    glBufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)sizeof *frame, frame, GL_STATIC_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, block);
    for (GLenum unit = 0; unit < 8; ++unit) { glActiveTexture(GL_TEXTURE0 + unit); glBindTexture(GL_TEXTURE_2D, unit == 7 ? input : maps); }
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, target, 0);
    glDrawBuffers(2, buffers);
    glViewport(0, 0, SIDE, SIDE);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    read = kit_texture_read(target, SIDE, SIDE, 4, out[0]);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &target);
    glDeleteTextures(1, &input);
    glDeleteBuffers(1, &block);
    glDeleteProgram(program);
    return CHECK(!read, "the probe cannot be read");
}

#define NEAR(got, want, within, what) CHECK(fabs((double)(got) - (double)(want)) <= (double)(within), "%s at %d: %.9g, in C %.9g", what, i, (double)(got), (double)(want))

static void twin_views(void)
{
    enum { LAYOUTS = 6 };
    static const double n = 0.1, f = 1000;                /* planes */
    for (int k = 0; k < LAYOUTS; ++k) {                   /* perspective: GL, reversed, reversed infinite, GL infinite; orthographic: GL, reversed */
        const double z[LAYOUTS][2] = { { -(f + n) / (f - n), -2 * f * n / (f - n) }, { n / (f - n), f * n / (f - n) }, { 0, n }, { -1, -2 * n },
                                       { -2 / (f - n), -(f + n) / (f - n) }, { 1 / (f - n), f / (f - n) } };
        float m[16] = { 1.3f, 0, 0, 0, 0, k & 1 ? -2.1f : 2.1f, 0, 0, 0.07f, -0.03f, (float)z[k][0], -1, 0, 0, (float)z[k][1], 0 };
        int ortho = k >= 4, clip = k == 1 || k == 2 || k == 5 ? SSGI_CLIP_ZERO : SSGI_CLIP_GL;
        ssgi_gl_desc d = { .dialect = SSGI_GL_450, .orthographic = ortho };
        ssgi_gl_frame frame;
        ssgi_view view;
        const char *why = "";
        if (ortho) { m[8] = m[9] = m[11] = 0; m[12] = 0.07f; m[13] = -0.03f; m[15] = 1; }
        if (!CHECK(ssgi_view_from_projection(&view, m, clip, 1280, 720, &why) == SSGI_OK && ssgi_gl_frame_init(&frame, &view, 1, &why) == SSGI_OK, "%s", why)) continue;
        frame.offset = 1;
        for (int i = 0; i < MANY; ++i) {                  /* window depth; a pixel; view depth */
            float a[4] = { i < 2 ? (float)i : i & 1 ? uniform(0, 1) : 1 - powf(10, uniform(-7, 0)), uniform(-50, 1330), uniform(-50, 770), expf(uniform(-4, 7)) };
            memcpy(in[i], a, sizeof a);
        }
        if (!probe(&d, &frame, 0, "o = vec4(ssgi_decode(a.x), ssgi_position(a.yz, a.w));")) break;
        for (int i = 0; i < MANY; ++i) {
            double depth = (double)ssgi_view_depth(&view, in[i][0]), x = fabs((double)in[i][1] * (double)view.unproject[0]) + fabs((double)view.unproject[2]);
            double y = fabs((double)in[i][2] * (double)view.unproject[1]) + fabs((double)view.unproject[3]), scale = ortho ? 1 : (double)in[i][3];
            double lost = 1.2e-7 * (fabs((double)view.depth[0]) + fabs((double)view.depth[1]));      /* a rounding of the sum's terms */
            float p[3];
            ssgi_view_position(&view, in[i][1], in[i][2], in[i][3], p);
            if (depth >= 1e17) CHECK(out[i][0] >= 1e17f, "ssgi_decode(%.9g), layout %d: %g, in C %g", (double)in[i][0], k, (double)out[i][0], depth);
            else NEAR(out[i][0], depth, ortho ? lost : depth * (3e-7 + depth * lost) * (1 + depth * lost), "ssgi_decode");
            NEAR(out[i][1], p[0], 3e-7 * x * scale, "ssgi_position.x");
            NEAR(out[i][2], p[1], 3e-7 * y * scale, "ssgi_position.y");
            NEAR(out[i][3], p[2], 0, "ssgi_position.z");
        }
        for (int i = 0; i < MANY; ++i) ssgi_view_position(&view, in[i][1], in[i][2], in[i][3], in[i]);
        if (!probe(&d, &frame, 0, "o = vec4(ssgi_project(a.xyz), ssgi_footprint(a.w), ssgi_lift(vec3(0.0, 0.0, -a.w), vec3(1.0, 0.0, 0.0)).x);")) break;
        for (int i = 0; i < MANY; ++i) {
            float p[3];
            ssgi_view_project(&view, in[i], p);
            NEAR(out[i][0], p[0], 4e-7 * (fabs((double)p[0]) + 2 * fabs((double)view.project[2])), "ssgi_project.x");
            NEAR(out[i][1], p[1], 4e-7 * (fabs((double)p[1]) + 2 * fabs((double)view.project[3])), "ssgi_project.y");
            NEAR(out[i][2], ssgi_pixel_footprint(&view, in[i][3]), 2e-7f * out[i][2], "ssgi_footprint");
            NEAR(out[i][3], ssgi_normal_offset(&view, in[i][3]), 3e-7f * out[i][3], "ssgi_lift");
        }
    }
}

static void twin_noise_and_kernel(void)
{
    float kernel[4 * 64];
    ssgi_gl_frame frame;
    memset(&frame, 0, sizeof frame);
    for (int i = 0; i < MANY; ++i) { in[i][0] = (float)(i % SIDE * 37); in[i][1] = (float)(i / SIDE * 21); in[i][2] = (float)(i % SIDE); in[i][3] = (float)(i / SIDE); }
    ssgi_gl_desc d = { .dialect = SSGI_GL_450, .samples = 64 };
    ssgi_kernel(kernel, 1, 64, SSGI_COSINE, NULL);
    if (probe(&d, &frame, 0, "o = vec4(ssgi_noise(ivec2(a.xy)), ssgi_noise(ivec2(a.zw)));"))
        for (int i = 0; i < MANY; ++i)
            for (int k = 0; k < 2; ++k) {                 /* two products and their sum, rounded; in x 53 times that */
                double x = (double)in[i][2 * k], y = (double)in[i][2 * k + 1], e = (double)out[i][2 * k] - (double)ssgi_gradient_noise((int)x, (int)y);
                double f = (double)out[i][2 * k + 1] - (0.75487766624669276 * x + 0.56984029099805327 * y);
                CHECK(fabs(e - floor(e + 0.5)) <= 53 * 1.2e-7 * (0.0671 * x + 0.0059 * y + 1), "ssgi_noise(%g, %g).x: off by %g", x, y, e);
                CHECK(fabs(f - floor(f + 0.5)) <= 2.4e-7 * (x + y + 1), "ssgi_noise(%g, %g).y: not R2, off by %g", x, y, f);
                CHECK(out[i][2 * k] >= 0 && out[i][2 * k] < 1 && out[i][2 * k + 1] >= 0 && out[i][2 * k + 1] < 1, "ssgi_noise(%g, %g) leaves [0,1)", x, y);
            }
    if (probe(&d, &frame, 0, "o = SSGI_KERNEL[(texel.y * 64 + texel.x) % 64];"))
        for (int i = 0; i < MANY; ++i)
            for (int c = 0; c < 4; ++c) NEAR(out[i][c], kernel[4 * (i % 64) + c], 1.2e-7, "SSGI_KERNEL");
    d.noise = SSGI_GL_NOISE_TILE4;
    if (probe(&d, &frame, 0, "o = vec4(ssgi_noise(texel), 0.0, 0.0);"))
        for (int y = 0; y < SIDE - 3; ++y)
            for (int x = 0; x < SIDE - 3; ++x) {          /* any 4x4 block: 16 different x, and 4 different y four times */
                int first[16] = { 0 }, second[4] = { 0 }, right = 1;
                for (int i = 0; i < 16; ++i) { const float *o = out[(y + i / 4) * SIDE + x + i % 4]; ++first[(int)(o[0] * 16) & 15]; ++second[(int)(o[1] * 4) & 3]; }
                for (int i = 0; i < 16; ++i) right &= first[i] == 1 && second[i / 4] == 4;
                CHECK(right, "the tile is uneven at %d, %d", x, y);
            }
}

static void twin_normals(void)
{
    static float coded[MANY][4];
    const float c = 0.6f, s = 0.8f;
    ssgi_gl_frame frame;
    for (int world = 0; world < 2; ++world)
        for (int how = SSGI_GL_NORMAL_SIGNED; how <= SSGI_GL_NORMAL_OCTAHEDRAL; ++how) {
            ssgi_gl_desc d = { .dialect = SSGI_GL_450, .normal = how, .world_normals = world };
            const float turn[12] = { c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0 };      /* columns: x goes to (c, s, 0) */
            memset(&frame, 0, sizeof frame);
            memcpy(frame.rotation, turn, sizeof turn);
            for (int i = 0; i < MANY; ++i) {
                float z = uniform(-1, 1), a = uniform(0, 6.2831853f), r = sqrtf(1 - z * z), *n = in[i], *e = coded[i];
                n[0] = i < 6 ? (float)((i == 0) - (i == 1)) : r * cosf(a);      /* the axes too */
                n[1] = i < 6 ? (float)((i == 2) - (i == 3)) : r * sinf(a);
                n[2] = i < 6 ? (float)((i == 4) - (i == 5)) : z;
                memcpy(e, n, 3 * sizeof *n);
                if (how == SSGI_GL_NORMAL_UNSIGNED) for (int k = 0; k < 3; ++k) e[k] = n[k] * 0.5f + 0.5f;
                if (how == SSGI_GL_NORMAL_OCTAHEDRAL) {
                    float sum = fabsf(n[0]) + fabsf(n[1]) + fabsf(n[2]), x = n[0] / sum, y = n[1] / sum;
                    e[0] = n[2] < 0 ? (1 - fabsf(y)) * (x < 0 ? -1.0f : 1.0f) : x;
                    e[1] = n[2] < 0 ? (1 - fabsf(x)) * (y < 0 ? -1.0f : 1.0f) : y;
                    e[2] = 9;                              /* not looked at */
                }
            }
            GLuint map = kit_texture(SIDE, SIDE, GL_RGBA32F, coded[0]);
            if (probe(&d, &frame, map, "o = vec4(ssgi_normal(texel, vec3(0.0, 0.0, -1.0)), 0.0);"))
                for (int i = 0; i < MANY; ++i) {
                    const float *n = in[i], want[3] = { world ? c * n[0] - s * n[1] : n[0], world ? s * n[0] + c * n[1] : n[1], n[2] };
                    for (int k = 0; k < 3; ++k) NEAR(out[i][k], want[k], 6e-7, "ssgi_normal");
                }
            glDeleteTextures(1, &map);
        }
}

/* The integral that ssgi_arc documents, by Simpson's rule. */
static double arc(double top, double g)
{
    enum { PARTS = 128 };
    double sum = 0;
    for (int k = 0; k <= PARTS; ++k) sum += sin(top * k / PARTS) * cos(g - top * k / PARTS) * (k == 0 || k == PARTS ? 1 : k & 1 ? 4 : 2);
    return sum * top / (3 * PARTS);
}

static void twin_arc(void)
{
    ssgi_gl_desc d = { .pass = SSGI_GL_HSAO, .dialect = SSGI_GL_450 };
    ssgi_gl_frame frame;
    double worst = 0;
    memset(&frame, 0, sizeof frame);
    for (int i = 0; i < MANY; ++i) {                      /* height over the tangent plane and distance along it: down to the plane, up to the normal */
        float thin = powf(10, uniform(-12, 0)), a[4] = { i & 1 ? 1 : thin, i & 1 ? thin : 1, uniform(-1.57f, 1.57f), uniform(0.1f, 10) };
        if (i % 16 == 0) a[i / 16 & 1] = 0;
        memcpy(in[i], a, sizeof a);
    }
    if (probe(&d, &frame, 0, "a.xy *= a.w; float r = inversesqrt(a.x * a.x + a.y * a.y) * (1.0 + 2.4e-7 * float(texel.x & 2)), h = 0.5 * sin(a.z);"
              "o = vec4(ssgi_arc(vec2(a.x, -a.x) * r, vec2(a.y) * r, 0.5 * cos(a.z), vec2(h, -h)), 0.0, 0.0);"))
        for (int i = 0; i < MANY; ++i) {
            double x = (double)in[i][0], y = (double)in[i][1], g = (double)in[i][2], s = fabs(y) / hypot(x, y);
            double lost = i & 2 ? 1.6e-6 : 4e-7, within = 0.5 * fabs(sin(g)) * (7e-5 + lost / fmax(s, sqrt(lost))) + 2e-6;   /* its acos, and how far c's error moves one: */
            NEAR(out[i][0], arc(atan2(y, x), g), within, "ssgi_arc.x");          /* two roundings, or what GLSL grants an inversesqrt, so that |c| > 1 */
            NEAR(out[i][1], arc(atan2(y, -x), -g), within, "ssgi_arc.y");
            worst = fmax(worst, fmax(fabs((double)out[i][0] - arc(atan2(y, x), g)), fabs((double)out[i][1] - arc(atan2(y, -x), -g))));
        }
    t_note("worst error of a horizon's occlusion: %.1e", worst);
}

/* ---- >>fuzz, >>speed ----------------------------------------------------------------------------------------------- */

static void fuzz(void)
{
    enum { TRIES = 1000000, EVERY = 24 };
    static char text[TEXT];
    const size_t fields = sizeof ssgi_gl__fields / sizeof ssgi_gl__fields[0];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    int accepted = 0, emitted = 0;
    random_state = 7;
    for (int i = 0; i < TRIES; ++i) {
        ssgi_gl_desc d = { .fetch = i & 2 ? FETCH : NULL, .version = i & 4 ? "" : NULL };
        int broken = (int)(random_state >> 31);
        const char *why = NULL;
        for (size_t k = 0; k < fields; ++k) set(&d, ssgi_gl__fields[k].offset, (int)uniform(0, (float)ssgi_gl__fields[k].most + 0.999f));
        if (broken) {
            const ssgi_gl__field *f = &ssgi_gl__fields[(size_t)uniform(0, (float)fields - 0.01f)];
            int wrong = (int)((uint32_t)uniform(0, 65535) << 16 | (uint32_t)uniform(0, 65535));
            set(&d, f->offset, wrong >= 0 && wrong <= f->most ? f->most + 1 : wrong);
        }
        ssgi_result r = ssgi_gl_check(&d, &why);
        CHECK(r == SSGI_OK ? !broken && !why : why && NAMES(why, "desc."), "check: %d, %s", (int)r, why ? why : "no sentence");
        accepted += r == SSGI_OK;
        if (i % EVERY) continue;
        size_t n = ssgi_gl_emit(text, TEXT, &d, SSGI_GL_FRAGMENT);
        int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO), fetches = ssgi_gl_fetches(&d), bad = r != SSGI_OK;
        emitted += !bad;
        CHECK(bad ? !n && !rows && !fetches && !ssgi_gl_key(&d) : n > 500 && n < TEXT && strlen(text) == n && rows > 5 && rows <= SSGI_GL_MAX_IO && fetches > 0 && ssgi_gl_key(&d),
              "%s: %zu characters, %d rows, %d fetches", bad ? "refused" : describe(&d), n, rows, fetches);
    }
    t_note("%d descs, %d accepted, %d emitted", TRIES, accepted, emitted);
}

static int ascending(const void *a, const void *b) { double x = *(const double *)a, y = *(const double *)b; return (x > y) - (x < y); }

static void speed(void)
{
    enum { TIMES = 2001 };
    static char text[TEXT];
    static double took[TIMES];
    static const ssgi_gl_desc descs[] = { { .samples = 64 }, { .pass = SSGI_GL_HSAO }, { .pass = SSGI_GL_BLUR } };
    double us[3];
    for (int k = 0; k < 3; ++k) {
        for (int i = 0; i < TIMES; ++i) {
            double began = kit_seconds();
            ssgi_gl_emit(text, TEXT, &descs[k], SSGI_GL_FRAGMENT);
            took[i] = kit_seconds() - began;
        }
        qsort(took, TIMES, sizeof took[0], ascending);
        us[k] = took[TIMES / 2] * 1e6;
        CHECK(us[k] < 50, "%s: %.1f us", ssgi_gl_pass_name(descs[k].pass), us[k]);
    }
    t_note("ssao of 64 points %.1f us, hsao %.1f us, blur %.1f us", us[0], us[1], us[2]);
}

void test_text(void)
{
    make_variants();
    RUN("every text compiles: each pass, dialect and choice, with Khronos' compiler and Mesa's", compilers);
    RUN("emit keeps snprintf's law at every capacity", law);
    RUN("the same desc gives the same bytes, under any locale", same_bytes);
    RUN("rows and declarations agree both ways, and with GL's own places", reflection);
    RUN("what is off leaves nothing; nothing is declared or defined in vain", off);
    RUN("text is plain: ASCII, our own names, nothing reserved in any dialect, chunks that C99 takes", lint);
    RUN("every bad field is named, and what was given stays untouched", sentences);
    if (desktop) {
        RUN("twins: depth, position, projection, footprint and offset as in C", twin_views);
        RUN("twins: noise and kernel as in C, the tile even over every block", twin_noise_and_kernel);
        RUN("twins: normals of every encoding and frame come back", twin_normals);
        RUN("twins: a slice's arc is the integral that it says", twin_arc);
    }
    kit_gl_close();
    RUN("a million random descs: refused with a sentence, or emitted whole", fuzz);
    RUN("a text takes less than 50 microseconds", speed);
}
