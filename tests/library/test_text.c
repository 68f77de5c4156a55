/* test_text.c - the emitted shaders, by public functions: compilers, snprintf's rules, reflection, names, sentences. */
#include "own.h"
#include "kit/kit_gl.h"

#include <ctype.h>
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- >>variants: every two values of fields, in each pass -------------------------------------------------------- */

enum {
    MOST = 1 << 12,
    TEXT = 1 << 16,
    TOOLBOX = SSGI_GL_STAGES,
    PROGRAM
};

static ssgi_gl_desc shape[6 * SSGI_GL_PASSES];             /* each pass, by its searches and tessellated */
static int shapes;
static ssgi_gl_desc variant[MOST];
static int variants;

static void set(ssgi_gl_desc *d, const ssgi_gl_choice *c, int value)
{
    memcpy((char *)d + c->offset, &value, sizeof value);
}

/* Returns how many values of a field variants have, from 0 on: all words; of a count only the first few. */
static int values_of(const ssgi_gl_choice *c)
{
    const int own = !strncmp(c->field, "shader.", 7) || !strcmp(c->name, "pass") || !strcmp(c->name, "search")
                    || !strcmp(c->name, "tessellate");      /* fields that shapes and dialects set */
    return own ? 0 : *c->values || c->most < 3 ? c->most + 1 : c->most < 5 ? 4 : 3;
}

static const char *describe(const ssgi_gl_desc *d)
{
    static _Thread_local char text[1000];
    const ssgi_gl_choice *c;
    size_t n = (size_t)snprintf(text, sizeof text, "%s", ssgi_gl_pass_name(d->pass));
    for (int i = 1; (c = ssgi_gl_choice_at(i)) != NULL; ++i)
        if (ssgi_gl__get(d, c->offset))
            n += (size_t)snprintf(text + n, sizeof text - n, ",%s=%d", c->name, ssgi_gl__get(d, c->offset));
    return text;
}

/* Returns the stages of a pass, one bit each. */
static int stages_of(const ssgi_gl_desc *d)
{
    const int tessellated = d->surfel.tessellate && (d->pass == SSGI_GL_PASS_SURFELS || d->pass == SSGI_GL_PASS_DSS);
    if (d->shader.compute) return 1 << SSGI_GL_STAGE_COMPUTE;
    return 1 << SSGI_GL_STAGE_VERTEX | 1 << SSGI_GL_STAGE_FRAGMENT
           | (tessellated ? 1 << SSGI_GL_STAGE_TESS_CONTROL | 1 << SSGI_GL_STAGE_TESS_EVALUATION : 0)
           | (tessellated && d->pass == SSGI_GL_PASS_DSS ? 1 << SSGI_GL_STAGE_GEOMETRY : 0);
}

/* Returns the shader of a stage, or "" if the pass does not have it. */
static const char *emit(char *text, const ssgi_gl_desc *d, int stage)
{
    size_t n = ssgi_gl_emit(text, TEXT, d, stage);
    CHECK((n > 0) == (stages_of(d) >> stage & 1) && n < TEXT && (n || !*text), "%s, stage %d: a text of %zu characters",
          describe(d), stage, n);
    return text;
}

/* Returns whether the vertex stage draws more than a triangle. */
static int has_vertices(const ssgi_gl_desc *d)
{
    return d->pass == SSGI_GL_PASS_AOF || d->pass == SSGI_GL_PASS_SURFELS || d->pass == SSGI_GL_PASS_DSS;
}

/* A set of hashes. had() returns whether it had this one, and adds it. */
typedef struct set_of { uint64_t hash[1 << 15]; int count; } set_of;
static int had(set_of *s, const char *text, size_t n)
{
    const uint64_t hash = kit_hash(KIT_HASH, text, n) | 1;
    size_t i = hash >> 20 & ((1 << 15) - 1);
    while (s->hash[i] && s->hash[i] != hash) i = (i + 1) & ((1 << 15) - 1);
    if (s->hash[i]) return 1;
    if (CHECK(s->count++ < 1 << 14, "more of a kind than this test has room for")) s->hash[i] = hash;
    return 0;
}

/* Returns a desc of shape t with random values in the fields that it looks at. */
static ssgi_gl_desc drawn(int t)
{
    ssgi_gl_desc d = shape[t];
    const int first = (int)t_below(SSGI_GL__FIELDS);
    for (int k = 0; k < SSGI_GL__FIELDS; ++k) {
        const ssgi_gl__field *const f = &ssgi_gl__fields[(first + k) % SSGI_GL__FIELDS];
        const ssgi_gl_desc was = d;
        if (!values_of(&f->choice) || !ssgi_gl__holds(f->looks, &d)) continue;
        set(&d, &f->choice, (int)t_below((uint32_t)values_of(&f->choice)));
        if (ssgi_gl_check(&d, NULL) != SSGI_OK) d = was;
    }
    return d;
}

/* A table of pairs of values: 1 if some variant of the shape has both, after its fields are resolved. */
enum { VALUES = 16 };
static char together[VALUES * SSGI_GL__FIELDS][VALUES * SSGI_GL__FIELDS];

/* Returns how many pairs of values a desc has that no variant has. take: marks them as had. */
static int fresh_pairs(const ssgi_gl_desc *d, int take)
{
    const ssgi_gl_desc resolved = ssgi_gl_resolve(d);
    int at[SSGI_GL__FIELDS], fresh = 0;
    for (int i = 0; i < SSGI_GL__FIELDS; ++i) {
        at[i] = VALUES * i + ssgi_gl__get(&resolved, ssgi_gl__fields[i].choice.offset) % VALUES;
        for (int k = 0; k < i; ++k) {
            fresh += !together[at[i]][at[k]];
            together[at[i]][at[k]] |= (char)take;
        }
    }
    return fresh;
}

/* Returns whether a desc has a line that the set did not have; adds its lines. */
static int has_new_line(set_of *lines, const ssgi_gl_desc *d)
{
    static char text[TEXT];
    const int before = lines->count;
    for (int stage = 0; stage < SSGI_GL_STAGES; ++stage)
        for (const char *line = emit(text, d, stage); *line; line += strcspn(line, "\n") + 1)
            had(lines, line, strcspn(line, "\n"));
    return lines->count > before;
}

/* Makes the variants. A search or a tessellator is a shape if it changes the plain shader. Of a few random descs of a
   shape the one with the most new pairs is taken, until none has a new pair; then descs with a new line, which depends
   on more than two fields; with T_ALL as many random ones, for combinations of three. */
static void make_variants(void)
{
    enum { TRIES = 8, STALE = 4, MORE = 60 };
    static set_of lines, keys;
    t_seed(1);
    for (int i = 0; i < 6 * SSGI_GL_PASSES; ++i) {
        ssgi_gl_desc d = { .pass = i / 6, .gather.search = i % 3, .surfel.tessellate = i / 3 % 2,
                           .shader.dialect = SSGI_GL_DIALECT_450, .shader.fetch = T_FETCH };
        if (d.pass == SSGI_GL_PASS_SSDO) d.light.environment = SSGI_GL_ENVIRONMENT_SH;
        ssgi_gl_desc slices = d, whole = d;
        slices.gather.search = whole.surfel.tessellate = 0;
        const uint64_t key = ssgi_gl_key(&d);              /* 0: refused */
        if (key && (i % 3 == 0 || key != ssgi_gl_key(&slices)) && (i % 6 < 3 || key != ssgi_gl_key(&whole)))
            shape[shapes++] = d;
    }
    for (int t = 0; t < shapes; ++t) {
        const int before = variants;
        memset(together, 0, sizeof together);
        for (int stale = 0; stale < STALE && variants < MOST;) {
            int most = 0;
            for (int k = 0; k < TRIES; ++k) {
                const ssgi_gl_desc d = drawn(t);
                const int fresh = fresh_pairs(&d, 0);
                if (fresh > most) variant[variants] = d;
                most = fresh > most ? fresh : most;
            }
            stale = most ? 0 : stale + 1;
            if (!most) continue;
            fresh_pairs(&variant[variants], 1);
            const uint64_t key = ssgi_gl_key(&variant[variants]);
            /* also fields that need no input can make pairs */
            if (!had(&keys, (const char *)&key, sizeof key)) has_new_line(&lines, &variant[variants++]);
        }
        for (int more = t_all() ? variants - before : 0, k = 0; k < MORE + more && variants < MOST; ++k) {
            variant[variants] = drawn(t);
            variants += has_new_line(&lines, &variant[variants]) || k >= MORE;
        }
    }
    CHECK(variants < MOST, "more variants than this test has room for");
}

/* ---- >>compilers ------------------------------------------------------------------------------------------------- */

static struct { ssgi_gl_desc desc; int stage; } spoken[4 * MOST];       /* the shaders that are compiled */
static int texts;
static struct { int texts, vulkan, read; char problem[1000]; } glslang;

static int is_es(const ssgi_gl_desc *d)
{
    return d->shader.dialect >= SSGI_GL_DIALECT_300ES && d->shader.dialect <= SSGI_GL_DIALECT_320ES;
}

/* Writes the functions of pass AOF, or those that read the pass's result; 0: it has none. */
static size_t toolbox_of(char *out, size_t capacity, const ssgi_gl_desc *d)
{
    return d->pass == SSGI_GL_PASS_AOF ? ssgi_gl_field(out, capacity, d) : ssgi_gl_read(out, capacity, d);
}

/* Emits a stage's shader; PROGRAM: all stages, one after another; TOOLBOX: toolbox_of, and a main that calls it. */
static const char *source_of(char *text, const ssgi_gl_desc *d, int stage)
{
    if (stage == PROGRAM)
        for (int s = 0, at = 0; s < SSGI_GL_STAGES; ++s) at += (int)strlen(emit(text + at, d, s));
    if (stage != TOOLBOX) return stage == PROGRAM ? text : emit(text, d, stage);
    size_t n = strcspn(emit(text, d, SSGI_GL_STAGE_VERTEX), "\n") + 1;      /* the version line */
    n += (size_t)snprintf(text + n, TEXT - n, "%s",
                          is_es(d) ? "precision highp float;\nprecision highp int;\n"
                          : d->shader.dialect == SSGI_GL_DIALECT_VULKAN
                              ? "#extension GL_EXT_samplerless_texture_functions : require\n"
                              : "");
    n += toolbox_of(text + n, TEXT - n, d);
#define READ "gl_FragCoord.xy, z, vec3(0.0, 0.0, 1.0))"
    snprintf(text + n, TEXT - n,
             "layout(location = 0) out vec4 o;\nvoid main()\n{\n    float z = %s;\n    o = vec4(%s);\n}\n",
             strstr(text, " ssgi_fragment_depth(") ? "ssgi_fragment_depth(gl_FragCoord.xy, gl_FragCoord.z)" : "2.0",
             strstr(text, " ssgi_field_visibility(") ? "ssgi_field_visibility(9, 1, gl_FragCoord.xyz, vec3(z))"
             : strstr(text, " ssgi_visibility_at(")  ? "ssgi_visibility_at(" READ
             : strstr(text, " ssgi_irradiance_at(")  ? "ssgi_irradiance_at(" READ ", z"
             : "ssgi_sh_dot(ssgi_coefficients_at(" READ ".channel[0], ssgi_coefficients_at(" READ ".channel[0]) * "
               "ssgi_ambient(ssgi_coefficients_at(" READ ").x + ssgi_bent(ssgi_coefficients_at(" READ ".channel[0])");
    return text;
}

/* Adds a desc's shader, unless another desc has the same, as a pass does not look at all fields. */
static void speak_once(const ssgi_gl_desc *d, int stage)
{
    static char text[SSGI_GL_STAGES * TEXT];
    static set_of spoken_of;
    const char *const source = source_of(text, d, stage);
    if (had(&spoken_of, source, strlen(source)) || !CHECK(texts < 4 * MOST, "too many texts")) return;
    spoken[texts].desc = *d;
    spoken[texts++].stage = stage;
}

/* Gives a desc a dialect of desktop GL, ES or Vulkan; returns 0 if it has none, as surfels lack Vulkan's. */
static int takes(ssgi_gl_desc *d, int way, int turn)
{
    for (int k = 0; k < 3; ++k) {
        d->shader.dialect = way == 2 ? SSGI_GL_DIALECT_VULKAN : way * 3 + (turn + k) % 3;
        if (ssgi_gl_check(d, NULL) == SSGI_OK) return 1;
    }
    return 0;
}

/* Gives a desc sets and dense bindings by a number, for Vulkan's dialect, which alone looks at them. */
static void placed(ssgi_gl_desc *d, int number)
{
    d->shader.block_set = number % 3;
    d->shader.texture_set = number / 3 % 3;
    d->shader.dense = number / 9 % 2;
}

/* Adds every variant in a desktop dialect, an ES one or Vulkan's, in turn; with T_ALL in all three, so that each choice
   meets each dialect. A pass with a vertex stage of its own is added with all stages; the other passes' vertex stage
   once for each dialect; every toolbox in every dialect. Of every fourth variant the compute stage is added, too. */
static void speak(void)
{
    for (int i = 0; i < 3 * variants; ++i) {
        ssgi_gl_desc d = variant[i / 3];
        const int first = i / 3;
        int turn = first % 3;                  /* which dialect comes next, if the desc has it */
        for (int k = 0; k < 2 && !takes(&d, turn, first); ++k) turn = (turn + 1) % 3;
        if ((!t_all() && i % 3 != turn) || !takes(&d, i % 3, first)) continue;
        d.shader.lines = first % 8 == 0;
        d.shader.uniforms = first % 5 == 0 && i % 3 != 2;
        placed(&d, first);
        speak_once(&d, has_vertices(&d) ? PROGRAM : SSGI_GL_STAGE_FRAGMENT);
        if (d.pass != SSGI_GL_PASS_AOF && toolbox_of(NULL, 0, &d)) speak_once(&d, TOOLBOX);
        d.shader.compute = SSGI_GL_COMPUTE_ALL;
        if ((t_all() || first % 4 == 0) && takes(&d, i % 3, first)) speak_once(&d, SSGI_GL_STAGE_COMPUTE);
    }
    for (int i = 0; i < SSGI_GL_DIALECTS; ++i) {
        const ssgi_gl_desc plain = { .shader.dialect = i }, field = { .pass = SSGI_GL_PASS_AOF, .shader.dialect = i };
        speak_once(&plain, SSGI_GL_STAGE_VERTEX);
        speak_once(&field, TOOLBOX);
    }
}

/* endings of the stages' files, then of TOOLBOX's */
static const char *const endings[SSGI_GL_STAGES + 1] = { "vert", "frag", "tesc", "tese", "geom", "comp", "frag" };

/* Compiles many files in a call, as a call takes a fifth of a second. For Vulkan (v) glslang links all files of a call,
   and fails at many. But first it reads each file by Vulkan's rules, and only that result counts. */
static void *glslang_run(void *folder)
{
    static char text[TEXT];
    char path[1000], line[400], name[400] = "0";
    int passed = 0;
    for (int i = 0; i < texts; ++i, ++glslang.texts) {
        const int all = spoken[i].stage == PROGRAM, vulkan = spoken[i].desc.shader.dialect == SSGI_GL_DIALECT_VULKAN;
        for (int stage = all ? 0 : spoken[i].stage; stage < (all ? SSGI_GL_STAGES : spoken[i].stage + 1); ++stage) {
            const size_t n = strlen(source_of(text, &spoken[i].desc, stage));
            snprintf(path, sizeof path, "%s/%s%d.%s", (char *)folder, vulkan ? "v" : "", i, endings[stage]);
            if (n) kit_file_write(path, text, n, NULL);
            glslang.vulkan += n && vulkan;
        }
    }
    snprintf(path, sizeof path,
             "cd '%s' && ls | grep '^[0-9]' | xargs -n 512 -P 2 glslangValidator 2>&1 && ls | grep '^v' | "
             "xargs -n 128 -P 2 sh -c 'glslangValidator -V \"$@\" 2>&1 | grep \"^v[0-9]*[.]\\|^ERROR: v[0-9]\"' sh && "
             "echo passed", (char *)folder);
    FILE *pipe = popen(path, "r");
    for (; pipe && fgets(line, sizeof line, pipe); passed |= !strcmp(line, "passed\n")) {
        const int bad = !strncmp(line, "ERROR: ", 7);
        const char *at = line + (bad ? 7 : 0);
        glslang.read += !bad && *at == 'v';
        at += *at == 'v';
        if (isdigit((unsigned char)*at) && at[strspn(at, "0123456789")] == '.') strcpy(name, at);
        if (bad && !glslang.problem[0])
            snprintf(glslang.problem, sizeof glslang.problem, "%s: %s", describe(&spoken[atoi(name)].desc), line);
    }
    if (pipe) pclose(pipe);
    if (!passed && !glslang.problem[0]) strcpy(glslang.problem, "no answer");
    return NULL;
}

/* the stages, then TOOLBOX */
static const GLenum kinds[SSGI_GL_STAGES + 1] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, GL_TESS_CONTROL_SHADER,
                                                  GL_TESS_EVALUATION_SHADER, GL_GEOMETRY_SHADER, GL_COMPUTE_SHADER,
                                                  GL_FRAGMENT_SHADER };

/* Links a program of d's stages, with the outputs that transform feedback keeps. */
static GLuint linked(const ssgi_gl_desc *d)
{
    static char text[SSGI_GL_STAGES][TEXT];
    const char *source[SSGI_GL_STAGES], *kept[3];
    GLenum stage[SSGI_GL_STAGES];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    kit_error err = { "" };
    GLint ok = 1;
    int stages = 0, keeps = 0;
    for (int s = 0; s < SSGI_GL_STAGES; ++s) {
        source[stages] = emit(text[s], d, s);
        stage[stages] = kinds[s];
        stages += *source[stages] != 0;
    }
    const GLuint program = kit_program(source, stage, stages, &err);
    for (int i = 0, rows = ssgi_gl_reflect(d, row, SSGI_GL_MAX_IO); i < rows; ++i)
        if (row[i].kind == SSGI_GL_IO_CAPTURE && keeps < 3) kept[keeps++] = row[i].name;
    if (!CHECK(program, "%s: %s", describe(d), err.text) || !keeps) return program;
    glTransformFeedbackVaryings(program, keeps, kept, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    CHECK(ok, "%s: the kept stages do not link", describe(d));
    return program;
}

static int compiles(const ssgi_gl_desc *d, int stage)
{
    static char text[TEXT], log[600];
    GLint ok = 0;
    if (stage == PROGRAM) {
        const GLuint program = linked(d);
        glDeleteProgram(program);
        return program != 0;
    }
    const char *source = source_of(text, d, stage);
    GLuint shader = glCreateShader(kinds[stage]);
    glShaderSource(shader, 1, &source, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    glDeleteShader(shader);
    return CHECK(ok, "%s: %s", describe(d), log);
}

static int desktop;                        /* 1: a context of desktop GL stays open until the end */

static void compilers(void)
{
    char folder[] = "/tmp/ssgi-text-XXXXXX", line[100];
    pthread_t thread;
    int has = !system("command -v glslangValidator >/dev/null 2>&1") && mkdtemp(folder)
              && !pthread_create(&thread, NULL, glslang_run, folder);
    CHECK(has, "glslangValidator is missing (Debian: apt-get install glslang-tools), or there is no folder in /tmp");
    for (int es = 1; es >= 0; --es) {
        kit_error err = { "" };
        GLint version[2] = { 0, 0 };
        int tried = 0;
        if (es && !kit_gl_open("egl-es", NULL)) {
            glGetIntegerv(GL_MAJOR_VERSION, &version[0]);
            glGetIntegerv(GL_MINOR_VERSION, &version[1]);
        }
        /* compiles ES shaders, too: ARB_ES3_2_compatibility */
        if (version[0] * 10 + version[1] < 32) desktop = CHECK(!kit_gl_open(NULL, &err), "%s", err.text);
        if (version[0] * 10 + version[1] < 32 && !desktop) break;
        for (int i = 0, bad = 0; i < texts && bad < 3; ++i) {
            if (is_es(&spoken[i].desc) != es || spoken[i].desc.shader.dialect == SSGI_GL_DIALECT_VULKAN) continue;
            bad += !compiles(&spoken[i].desc, spoken[i].stage);
            ++tried;
        }
        t_note("%d texts: %s", tried, kit_gl_name());
    }
    if (!has) return;
    pthread_join(thread, NULL);
    CHECK(!glslang.problem[0], "glslangValidator: %s", glslang.problem);
    CHECK(glslang.read == glslang.vulkan, "of %d texts for Vulkan glslangValidator -V has read %d", glslang.vulkan,
          glslang.read);
    t_note("%d texts and programs: glslangValidator; %d texts by -V", glslang.texts, glslang.vulkan);
    snprintf(line, sizeof line, "rm -rf '%s'", folder);
    CHECK(!system(line), "%s", line);
}

/* ---- >>law: snprintf's ------------------------------------------------------------------------------------------- */

/* Emits shader number k: first stages of some variants, then the functions that stand alone. */
static size_t any_text(int k, char *out, size_t capacity)
{
    const ssgi_gl_desc *const d = &variant[k * (variants / 40)];
    return k < 34   ? ssgi_gl_emit(out, capacity, d, k % 2 ? SSGI_GL_STAGE_FRAGMENT : k / 2 % SSGI_GL_STAGES)
           : k < 38 ? ssgi_gl_sh(out, capacity, k - 33)
           : k < 39 ? ssgi_gl_field(out, capacity, d)
                    : ssgi_gl_reflection(out, capacity);
}

static void law(void)
{
    static char full[TEXT], part[TEXT], clean[TEXT];
    const ssgi_gl_desc fine = { 0 }, bad = { .gather.samples = 65 };
    memset(clean, 0x5a, sizeof clean);
    memcpy(part, clean, sizeof part);
    for (int k = 0; k < 40; ++k) {
        const size_t n = any_text(k, NULL, 0);
        CHECK(any_text(k, full, TEXT) == n && strlen(full) == n, "text %d: the length asked for with NULL differs", k);
        for (size_t capacity = 0; capacity <= n + 1; capacity += capacity < 40 || capacity + 40 > n ? 1 : 197) {
            const size_t got = any_text(k, part, capacity), used = capacity > n ? n + 1 : capacity;
            int right = got == n && (!used || (!memcmp(part, full, used - 1) && !part[used - 1]))
                        && !memcmp(part + used, clean, n + 64 - used);
            if (!CHECK(right, "text %d, capacity %zu of %zu: length %zu, or wrong bytes in or beyond it", k, capacity,
                       n, got))
                return;
            memcpy(part, clean, used);
        }
    }
    CHECK(!ssgi_gl_emit(part, TEXT, &bad, 0) && !ssgi_gl_emit(part, TEXT, NULL, 0)
              && !ssgi_gl_emit(part, TEXT, &fine, -1) && !ssgi_gl_emit(part, TEXT, &fine, SSGI_GL_STAGES)
              && !ssgi_gl_emit(NULL, 1, &fine, 0) && !ssgi_gl_sh(part, TEXT, 0) && !ssgi_gl_sh(part, TEXT, -1)
              && !ssgi_gl_sh(part, TEXT, 5) && !ssgi_gl_sh(NULL, 1, 4) && !ssgi_gl_field(part, TEXT, &bad)
              && !ssgi_gl_field(part, TEXT, NULL) && !ssgi_gl_field(NULL, 1, &fine) && !memcmp(part, clean, TEXT),
          "a bad desc, stage or number of bands gave text");
}

static void same_bytes(void)
{
    static char one[TEXT], two[TEXT];
    static const char *const names[] = { "de_DE.UTF-8", "de_DE.utf8",  "de_DE",      "fr_FR.UTF-8",
                                         "fr_FR.utf8",  "nl_NL.UTF-8", "it_IT.UTF-8" };
    const char *with = NULL;
    ssgi_gl_desc a = { .shader.version = "#version 330 core\n", .shader.fetch = T_FETCH },
                 b = a; /* ssao's shader has decimals: the kernel's */
    char version[] = "#version 330 core\n", fetch[] = T_FETCH;
    b.shader.version = version;
    b.shader.fetch = fetch;
    emit(one, &a, SSGI_GL_STAGE_FRAGMENT);
    CHECK(!strcmp(one, emit(two, &b, SSGI_GL_STAGE_FRAGMENT)) && ssgi_gl_key(&a) == ssgi_gl_key(&b),
          "equal strings at another place change the text or the key");
    for (size_t i = 0; i < sizeof names / sizeof names[0] && !with; ++i)
        if (setlocale(LC_ALL, names[i])) with = names[i];
    if (with) {
        snprintf(two, sizeof two, "%.1f", 0.5);
        CHECK(two[1] == ',', "locale %s has no decimal comma", with);
        CHECK(!strcmp(one, emit(two, &a, SSGI_GL_STAGE_FRAGMENT)), "another text under locale %s", with);
        setlocale(LC_ALL, "C");
    }
    t_note(with ? "locale tried: %s" : "no locale with a decimal comma is installed: %s not tried",
           with ? with : names[0]);
    version[9] = '4';
    CHECK(ssgi_gl_key(&a) != ssgi_gl_key(&b), "another version has the same key");
}

/* ---- >>reflection ------------------------------------------------------------------------------------------------ */

/* Checks that GL agrees with the rows of a linked program: offsets in the block, bindings without a call if the dialect
   has them. Every texture is read, and nothing lacks a row. */
static void ask_gl(const ssgi_gl_desc *d, const ssgi_gl_io *row, int rows)
{
    static const struct { const char *name; size_t most; } blocks[] = { { "ssgi_frame", sizeof(ssgi_gl_frame) },
                                                                        { "ssgi_views", sizeof(ssgi_gl_views) } };
    const int bound = d->shader.dialect == SSGI_GL_DIALECT_450;
    GLint uniforms = 0;
    GLuint program = linked(d);
    if (!program) return;
    glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &uniforms);
    for (int b = 0; b < 2; ++b) {
        const GLuint block = glGetUniformBlockIndex(program, blocks[b].name);
        GLint size = 0, binding = -1, members = 0;
        int wanted = 0;
        for (int i = 0; i < rows; ++i) wanted |= row[i].kind == SSGI_GL_IO_PARAM && row[i].slot == b;
        CHECK((block != GL_INVALID_INDEX) == wanted, "%s: %s is %s", describe(d), blocks[b].name,
              wanted ? "missing" : "there");
        if (block == GL_INVALID_INDEX) continue;
        glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
        glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_BINDING, &binding);
        glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_ACTIVE_UNIFORMS, &members);
        CHECK(binding == (bound ? b : 0) && size > 0 && (size_t)size <= blocks[b].most, "%s: %s of %d bytes at %d",
              describe(d), blocks[b].name, size, binding);
        uniforms -= members;
    }
    for (int i = 0; i < rows; ++i) {
        const int texture = row[i].kind == SSGI_GL_IO_TEXTURE;
        GLuint index = GL_INVALID_INDEX;
        GLint value = -1, want = texture && !bound ? 0 : row[i].slot;
        if (row[i].kind == SSGI_GL_IO_PARAM) {
            want = (GLint)row[i].offset;
            glGetUniformIndices(program, 1, &row[i].name, &index);
            if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &value);
        } else if (row[i].kind == SSGI_GL_IO_OUTPUT) value = glGetFragDataLocation(program, row[i].name);
        else if (!texture) continue;
        else if (glGetUniformLocation(program, row[i].name) >= 0)
            glGetUniformiv(program, glGetUniformLocation(program, row[i].name), &value);
        /* light of one band is the same for all normals, so GL's compilers drop them */
        if (value < 0 && ssgi_gl_resolve(d).light.bands == 1 && texture && row[i].slot < 2) continue;
        uniforms -= texture;
        CHECK(value == want, "%s: %s is at %d for GL, the row says %d", describe(d), row[i].name, value, want);
    }
    CHECK(!uniforms, "%s: %d uniforms have no row", describe(d), uniforms);
    glDeleteProgram(program);
}

/* Checks that each texture has its own unit, or in Vulkan's dialect its own binding, apart from the blocks. Outputs,
   attributes and captures are numbered from 0 on. A constant is declared with its value. */
static void check_places(const ssgi_gl_desc *d, const ssgi_gl_io *row, int rows, const char *fragment)
{
    const int vulkan = d->shader.dialect == SSGI_GL_DIALECT_VULKAN;
    uint32_t taken[3] = { 0 };
    int next[SSGI_GL_IO_CAPTURE + 1] = { 0 }, block = -1;
    char line[100];
    for (int k = 0; k < rows; ++k) {
        const ssgi_gl_io *const io = &row[k];
        const int texture = io->kind == SSGI_GL_IO_TEXTURE, at = vulkan ? io->binding : io->slot;
        if (texture || (io->kind == SSGI_GL_IO_PARAM && io->slot != block)) {
            uint32_t *const set_ = &taken[vulkan ? io->set : texture];
            CHECK(at >= 0 && at < 18 && io->slot < 16 && !(*set_ >> at & 1), "%s: %s is at %d, where another is",
                  describe(d), io->name, at);
            *set_ |= 1u << at;
            if (!texture) block = io->slot;
        } else if (io->kind == SSGI_GL_IO_CONSTANT) {
            snprintf(line, sizeof line, io->offset ? "layout(constant_id = %zu) " : "%.0zu", io->offset);
            snprintf(line + strlen(line), sizeof line - strlen(line), "const int %s = %d;\n", io->name, io->slot);
            CHECK(!strstr(fragment, io->name) || strstr(fragment, line), "%s: no %s", describe(d), line);
        } else if (io->kind != SSGI_GL_IO_PARAM)
            CHECK(io->slot == next[io->kind]++, "%s: %s is at %d", describe(d), io->name, io->slot);
    }
}

static void reflection(void)
{
    static char text[TEXT];
    ssgi_gl_io row[SSGI_GL_MAX_IO], few[2];
    int asked = 0, tried = 0;
    for (int i = 0; i < variants * SSGI_GL_DIALECTS; ++i) {
        ssgi_gl_desc d = variant[i / SSGI_GL_DIALECTS];
        d.shader.dialect = i % SSGI_GL_DIALECTS;
        placed(&d, i / SSGI_GL_DIALECTS);
        if (!t_all() && i % 5) continue;    /* one in five: dialects take turns, as their number is no multiple of 5 */
        if (ssgi_gl_check(&d, NULL) != SSGI_OK) continue;  /* no tessellation there */
        const int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO);
        check_places(&d, row, rows, emit(text, &d, SSGI_GL_STAGE_FRAGMENT));
        few[1] = row[3];
        CHECK(ssgi_gl_reflect(&d, few, 1) == rows && few[0].name == row[0].name && few[1].name == row[3].name,
              "more rows than there is room for");
        ++tried;
        if (d.shader.dialect > SSGI_GL_DIALECT_450 || !desktop || i % 3) continue;
        ask_gl(&d, row, rows);
        ++asked;
    }
    t_note("%d descs, %d of them linked", tried, asked);
    emit(text, variant, SSGI_GL_STAGE_VERTEX);
    CHECK(!strstr(text, "ssgi") && !strstr(text, "uniform") && !strstr(text, "layout"),
          "the vertex stage declares something");
    CHECK(!ssgi_gl_reflect(NULL, row, 1) && !ssgi_gl_reflect(variant, NULL, 1) && ssgi_gl_reflect(variant, NULL, 0) > 0,
          "reflection of nothing");
}

/* Checks that with loose uniforms the rows are the same, and so is the shader behind its declarations. A compiler finds
   a missing declaration; the test "what is off leaves nothing" finds one too many. */
static void loose_uniforms(void)
{
    static char text[TEXT], got[TEXT];
    ssgi_gl_io row[2][SSGI_GL_MAX_IO];
    int read = 0;
    for (int i = 0; i < variants; ++i) {
        ssgi_gl_desc d = variant[i], loose;
        if (!takes(&d, i & 1, i)) continue;
        loose = d;
        loose.shader.uniforms = SSGI_GL_UNIFORMS_LOOSE;
        memset(row, 0, sizeof row);
        CHECK(ssgi_gl_reflect(&d, row[0], SSGI_GL_MAX_IO) == ssgi_gl_reflect(&loose, row[1], SSGI_GL_MAX_IO)
                  && !memcmp(row[0], row[1], sizeof row[0]),
              "%s: loose uniforms have other rows", describe(&d));
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
            if (!*emit(text, &d, stage)) continue;
            const char *const body = strstr(text, "\n\n"), *const is = strstr(emit(got, &loose, stage), "\n\n");
            CHECK(body && is && !strcmp(body, is), "%s, stage %d: another text", describe(&d), stage);
            read += strstr(got, "uniform float u_ssgi_radius;") != NULL;
        }
    }
    CHECK(read > variants / 8, "%d texts read u_ssgi_radius", read);
    t_note("%d texts with a loose u_ssgi_radius", read);
}

/* ---- >>vulkan ---------------------------------------------------------------------------------------------------- */

/* Returns the set and the binding of a name in SPIR-V, as 100 * set + binding; -1: it has none. */
static int place_in(const uint32_t *word, size_t words, const char *name)
{
    enum { NAME = 5, DECORATE = 71, VARIABLE = 59, POINTER = 32, BINDING = 33, SET = 34 };
    uint32_t id = 0, type = 0, variable = 0;
    int set = -1, binding = -1;
    /* A block goes by the name of its type, as it has no instance name. Variables follow names and decorations. */
    for (size_t i = 5; i < words; i += word[i] >> 16) {
        const uint32_t *const w = word + i, op = *w & 0xffff;
        if (!(*w >> 16)) return -1;
        if (op == NAME && !strcmp((const char *)(w + 2), name)) id = w[1];
        if (op == POINTER && w[3] == id) type = w[1];
        if (op == VARIABLE && (w[2] == id || w[1] == type)) variable = w[2];
    }
    for (size_t i = 5; i < words; i += word[i] >> 16) {
        const uint32_t *const w = word + i;
        if ((*w & 0xffff) != DECORATE || w[1] != variable) continue;
        if (w[2] == SET) set = (int)w[3];
        if (w[2] == BINDING) binding = (int)w[3];
    }
    return set < 0 || binding < 0 ? -1 : 100 * set + binding;
}

/* Returns whether a shader uses a word that it declares, such as a member of a block. */
static int reads(const char *text, const char *word)
{
    int times = 0;
    for (const char *at = text; (at = strstr(at, word)) != NULL; ++at) times += !ssgi_gl__letter(at[strlen(word)]);
    return times > 1;
}

/* Checks that in SPIR-V that glslang makes of all linked stages for Vulkan, the block and the textures of the fragment
   stage, or also the images of the compute stage, have the sets and bindings of their rows. Returns how many. */
static int asked_of_spirv(const char *in, const ssgi_gl_desc *d, const char *name, int place)
{
    static char text[TEXT];
    char path[100], line[300], *spirv;
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    size_t size;
    int told = 0, named = 0;
    for (int stage = SSGI_GL_STAGES - 1; stage >= 0; --stage) {
        snprintf(path, sizeof path, "%s/a.%s", in, endings[stage]);
        remove(path);
        if (*emit(text, d, stage)) CHECK(!kit_file_write(path, text, strlen(text), NULL), "%s: not written", path);
    }
    const int judged = d->shader.compute ? SSGI_GL_STAGE_COMPUTE : SSGI_GL_STAGE_FRAGMENT;
    emit(text, d, judged);
    snprintf(line, sizeof line, "cd '%s' && glslangValidator -V a.* >log || ! cat log", in);
    snprintf(path, sizeof path, "%s/%s.spv", in, endings[judged]);
    if (!CHECK(!system(line) && !kit_file_read(&spirv, &size, path, NULL), "%s: %s", describe(d), line)) return 0;
    const uint32_t *const word = (const uint32_t *)(void *)spirv;
    for (int k = 0, n = ssgi_gl_reflect(d, io, SSGI_GL_MAX_IO); k < n; ++k) {
        const int block = io[k].kind == SSGI_GL_IO_PARAM, image = io[k].kind == SSGI_GL_IO_OUTPUT && d->shader.compute;
        const char *const is = !block ? io[k].name : io[k].slot ? "ssgi_views" : "ssgi_frame";
        if (!(io[k].kind == SSGI_GL_IO_TEXTURE ? reads(text, is) : (block || image) && strstr(text, is))) continue;
        const int at = place_in(word, size / 4, is), want = 100 * io[k].set + io[k].binding;
        CHECK(at == want && (!name || strcmp(is, name) || at == place), "%s: %s is at %d in SPIR-V, its row says %d",
              describe(d), is, at, want);
        named += name && !strcmp(is, name);
        ++told;
    }
    CHECK(!name || named, "%s: no row is named %s", describe(d), name);
    free(spirv);
    return told;
}

static void places_in_spirv(void)
{
    /* place: where SPIR-V has the name, 100 * set + binding. */
    static const struct { const char *desc, *name; int place; } row[] = {
        { "hsao,block_set=3,texture_set=2,dense=1,depth=linear", "t_ssgi_depth", 200 },
        { "hsao,block_set=3,texture_set=2,dense=1,depth=linear", "ssgi_frame", 300 },
        { "ssao,dense=1", "t_ssgi_depth", 1 },
        { "ssao,block_set=1,views=1", "t_ssgi_views", 6 },
        { "ssao,block_set=1,views=1", "ssgi_views", 101 },
        { "aof,texture_set=1,cap_table=1", "t_ssgi_cap", 107 },
        { "ssao,compute=all", "o_ssgi_ao", 18 },
        { "ssao,compute=all,output_set=2", "o_ssgi_ao", 218 },
        { "ssao,compute=all,dense=1,depth=linear", "o_ssgi_ao", 3 },    /* behind the block, depth and normals */
        { "ssao,compute=all,dense=1,depth=linear,texture_set=1", "o_ssgi_ao", 1 },
        { "ssao,compute=all,dense=1,depth=linear,block_set=1", "o_ssgi_ao", 2 },
        { "s3ho,compute=all,dense=1,depth=linear,block_set=1,output_set=2", "o_ssgi_sh1", 201 } };
    char folder[] = "/tmp/ssgi-text-XXXXXX", line[100];
    int told = 0, programs = 0;
    if (!CHECK(mkdtemp(folder), "no folder in /tmp")) return;
    for (size_t i = 0; i < sizeof row / sizeof *row; ++i) {
        ssgi_gl_desc d = desc_in(row[i].desc);
        d.shader.dialect = SSGI_GL_DIALECT_VULKAN;
        told += asked_of_spirv(folder, &d, row[i].name, row[i].place);
    }
    for (int i = 0; i < variants; ++i) {                   /* adds stages that have a varying besides the position */
        ssgi_gl_desc d = variant[i];
        if (!has_vertices(&d) || !takes(&d, 2, 0) || (programs++ % 12 && !t_all())) continue;
        placed(&d, i);
        told += asked_of_spirv(folder, &d, NULL, 0);
    }
    t_note("%d rows at their places", told);
    snprintf(line, sizeof line, "rm -rf '%s'", folder);
    CHECK(!system(line), "%s", line);
}

/* Checks examples/tools/glsl/translate.sh: in every language each texture is at its binding, members of blocks keep
   their names, and vertex stages flip y. */
static void translated(void)
{
    static const struct { const char *ending, *texture, *turned, *has, *tool; } into[] = {
        { "wgsl", "@group(0) @binding(%d) var t_ssgi_", "gl_Position.y = -(",
          "test -s build/tint/twgsl.wasm && command -v node", "tint: make glsl WGSL=1 brings it" },
        { "hlsl", "register(t%d);", "gl_Position.y = -", "command -v spirv-cross", "spirv-cross (apt-get)" },
        { "msl", "[[texture(%d)]]", "gl_Position.y = -", "command -v spirv-cross", "spirv-cross (apt-get)" } };
    static const char *const descs[] = { "hsao", "ssdo,environment=map,bounce=1", "s3ho", "blur,dense=1", "history",
                                         "aof", "dss" };
    enum { TEXTS = 2 * (int)(sizeof descs / sizeof *descs) };
    static char text[TEXT];
    char folder[] = "/tmp/ssgi-text-XXXXXX", path[300], line[400], *got;
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    size_t size;
    if (!CHECK(mkdtemp(folder), "no folder in /tmp")) return;
    for (int i = 0; i < TEXTS; ++i) {
        ssgi_gl_desc d = desc_in(descs[i / 2]);
        d.shader.dialect = SSGI_GL_DIALECT_VULKAN;
        snprintf(path, sizeof path, "%s/%s.vulkan.%s", folder, ssgi_gl_pass_name(d.pass), endings[i % 2]);
        CHECK(!kit_file_write(path, text, strlen(emit(text, &d, i % 2)), NULL), "%s cannot be written", path);
    }
    for (int k = 0; k < 3; ++k) {
        int textures = 0;
        snprintf(line, sizeof line, "{ %s; } >/dev/null", into[k].has);
        if (system(line)) { t_note("%s skipped, without %s", into[k].ending, into[k].tool); continue; }
        snprintf(line, sizeof line, "sh examples/tools/glsl/translate.sh %s %s | grep -q ' %d of %d$'", folder,
                 into[k].ending, TEXTS, TEXTS);
        if (!CHECK(!system(line), "%s", line)) continue;
        for (int i = 0; i < TEXTS; ++i) {
            ssgi_gl_desc d = desc_in(descs[i / 2]);
            d.shader.dialect = SSGI_GL_DIALECT_VULKAN;
            snprintf(path, sizeof path, "%s/%s.vulkan.%s.%s", folder, ssgi_gl_pass_name(d.pass), endings[i % 2],
                     into[k].ending);
            if (!CHECK(!kit_file_read(&got, &size, path, NULL), "%s is missing", path)) continue;
            CHECK(i % 2 || strstr(got, into[k].turned), "%s: y is not turned", path);
            emit(text, &d, i % 2);
            for (int r = 0, rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO); r < rows; ++r) {
                if (!strstr(text, row[r].name)) continue;
                snprintf(line, sizeof line, " %s", row[r].name);
                CHECK(row[r].kind != SSGI_GL_IO_PARAM || !k || strstr(got, line), "%s: has no name%s", path, line);
                if (row[r].kind != SSGI_GL_IO_TEXTURE) continue;
                snprintf(line, sizeof line, into[k].texture, row[r].binding);
                CHECK(strstr(got, line), "%s: nothing at the place of %s", path, row[r].name);
                ++textures;
            }
            free(got);
        }
        CHECK(textures > 15, "%s: %d textures", into[k].ending, textures);
        t_note("%s: %d texts, %d textures at their bindings", into[k].ending, TEXTS, textures);
    }
    snprintf(line, sizeof line, "rm -rf '%s'", folder);
    CHECK(!system(line), "%s", line);
}

/* ---- >>names ----------------------------------------------------------------------------------------------------- */

/* Returns whether a shader uses every name of ours that it declares; compilers check the reverse. An output of a stage
   counts as used in the next one; a global variable must be read as well. Members of a block may be unused. */
static int all_used(const char *text, const char *of)
{
    enum { KNOWN = 400 };
    typedef struct used_name { const char *word; size_t length; int declared, used; } used_name;
    static used_name known[KNOWN];
    int count = 0, block = 0;
    for (const char *line = text; *line; line += strcspn(line, "\n"), line += *line != 0) {
        const size_t whole = strcspn(line, "\n");
        const char *const comment = strstr(line, "//"), *const end = comment && comment < line + whole ? comment
                                                                                                       : line + whole;
        block = *line == '}' ? 0 : block || (whole > 2 && line[whole - 1] == '{' && strstr(line, "uniform ssgi_")
                                             && strstr(line, "uniform ssgi_") < end);
        for (const char *word = line, *after; word < end; word = after + (after == word)) {
            size_t n = 0;
            int k = 0;
            while (ssgi_gl__letter(word[n])) ++n;
            after = word + n;
            const char *const stem = n > 2 && word[1] == '_' ? word + 2 : word;
            if (block || n < 6 || *word == 'o' || *word == 'v' || !strncmp(word, "ssgi_custom_", 12)
                || (strncmp(stem, "ssgi_", 5) && strncmp(stem, "SSGI_", 5)))
                continue;
            while (k < count && (known[k].length != n || memcmp(known[k].word, word, n))) ++k;
            if (!CHECK(k < KNOWN, "%s: too many names", of)) return 0;
            if (k == count) known[count++] = (used_name){ word, n, 0, 0 };
            const char *const value = after + (*after == '.' ? 1 + strspn(after + 1, "xyzw") : 0);
            const int global = isalpha((unsigned char)*line), written = !global && !strncmp(value, " = ", 3);
            /* a type, which its variable follows */
            const int type = global && *after == ' ' && isalpha((unsigned char)after[1]);
            if (global && !type && !known[k].declared) known[k].declared = 1;
            else known[k].used += !written;
        }
    }
    for (int k = 0; k < count; ++k)
        if (!CHECK(!known[k].declared || known[k].used, "%s: %.*s is not used", of, (int)known[k].length,
                   known[k].word))
            return 0;
    return 1;
}

static void closed(void)
{
    static char text[TEXT];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    for (int i = 0, bad = 0; i < texts && bad < 5; ++i) {
        const ssgi_gl_desc *const d = &spoken[i].desc;
        const int all = spoken[i].stage == PROGRAM,
                  rows = spoken[i].stage == TOOLBOX ? 0 : ssgi_gl_reflect(d, row, SSGI_GL_MAX_IO);
        char read[SSGI_GL_MAX_IO] = { 0 };
        for (int stage = all ? 0 : spoken[i].stage; stage < (all ? SSGI_GL_STAGES : spoken[i].stage + 1); ++stage) {
            bad += !all_used(source_of(text, d, stage), describe(d));
            for (int k = 0; k < rows; ++k) read[k] |= (char)reads(text, row[k].name);
        }
        for (int k = 0; k < rows; ++k)
            bad += !CHECK(read[k] || row[k].kind != SSGI_GL_IO_PARAM || spoken[i].stage == SSGI_GL_STAGE_VERTEX,
                          "%s: %s is in no stage used", describe(d), row[k].name);
    }
    t_note("%d texts", texts);
}

/* ---- >>lint ------------------------------------------------------------------------------------------------------ */

/* The words of reserved.txt, each between blanks, without those that the shaders use as GLSL means them. */
static char reserved_words[1 << 14];

static int reserved_words_read(void)
{
    static const char ours[] =
        " break const continue discard else false for if layout return struct true bool float int uint void vec2 vec3 "
        "vec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 bvec2 bvec3 bvec4 mat2 mat3 mat4 mat3x4 in out inout uniform flat "
        "precision highp patch writeonly image2D uimage2D sampler2D sampler2DArray sampler2DMS sampler2DMSArray "
        "usampler2D usampler2DArray texture2DArray texture2DMS texture2DMSArray utexture2D utexture2DArray ";
    char path[4096], line[256], word[64];
    size_t used = 1;
    snprintf(path, sizeof path, "%s/tests/library/reserved.txt", t_root);
    FILE *file = fopen(path, "r");
    if (!file) return 0;
    reserved_words[0] = ' ';
    while (fgets(line, sizeof line, file)) {
        if (*line == '#' || strchr(line, ':')) continue;   /* the first line of a paragraph names its language */
        for (const char *at = line; (at += strspn(at, " \n")), *at; at += strcspn(at, " \n")) {
            snprintf(word, sizeof word, " %.*s ", (int)strcspn(at, " \n"), at);
            if (!strstr(ours, word) && used + strlen(word) < sizeof reserved_words)
                used += (size_t)sprintf(reserved_words + used, "%s", word + 1);
        }
    }
    fclose(file);
    return used > 4000 && used < sizeof reserved_words - 64;
}

static int reserved(const char *word, size_t n)            /* in any language; our own words are excepted */
{
    char key[64];
    if (n > 60) return 1;
    snprintf(key, sizeof key, " %.*s ", (int)n, word);
    return strstr(reserved_words, key) != NULL;
}

static void lint_line(const char *line, const char *end, int vulkan)
{
    if (*line == '#') return;
    const char *t = strncmp(line, "layout(", 7) ? line : line + strcspn(line, ")"); /* these have words of their own */
    while (t < end && !(t[0] == '/' && t[1] == '/')) {
        size_t k = 0;
        while (ssgi_gl__letter(t[k])) ++k;
        CHECK(!k || isdigit((unsigned char)*t) || !reserved(t, k)
                  || (vulkan && (!strncmp(t, "texture2D t_", 12) || !strncmp(t, "texture2D source,", 17))),
              "reserved, %.*s: %.*s", (int)k, t, (int)(end - line), line);
        t += k ? k : 1;
    }
}

static void lint(void)
{
    static char text[TEXT];
    static set_of lines;
    if (!CHECK(reserved_words_read() && reserved("from", 4) && reserved("lineadj", 7) && reserved("kernel", 6)
                   && reserved("float3x4", 8) && reserved("hvec3", 5) && !reserved("ssgi", 4),
               "tests/library/reserved.txt cannot be read"))
        return;
    for (int i = 0; i < texts; ++i) {
        const char *c = source_of(text, &spoken[i].desc, spoken[i].stage);
        for (const char *line = c, *end; *line && spoken[i].stage != TOOLBOX; line = end + (*end != 0)) {
            end = line + strcspn(line, "\n");
            if (!had(&lines, line, (size_t)(end - line)))
                lint_line(line, end, spoken[i].desc.shader.dialect == SSGI_GL_DIALECT_VULKAN);
        }
        while (((*c >= ' ' && *c < 127) || *c == '\n') && !(c[0] == '_' && c[1] == '_')
               && !(c[0] == ' ' && c[1] == '\n') && *c != '\\')
            ++c;
        if (!CHECK(!*c, "%s: not ASCII, a tab, __, a backslash or a space at a line's end: \"%.20s\"",
                   describe(&spoken[i].desc), c))
            return;
        CHECK(c[-1] == '\n', "%s: the text does not end its line", describe(&spoken[i].desc));
    }
    t_note("%d lines", lines.count);
}

/* ---- >>sentences ------------------------------------------------------------------------------------------------- */

#define NAMES(sentence, start) (strncmp(sentence, start, strlen(start)) == 0)

/* Descs and how the sentence on each must begin; NULL: it is accepted. Those on desc.shader.fetch lack one. */
static const struct { const char *start, *desc; } rules[] = {
    { "desc.gather.normal_rays:", "hsao,normal_rays=1" },
    { "desc.input.world_normals:", "ssao,normal=from_depth,world_normals=1" },
    { "desc.gather.search:", "hsao,search=points" },
    { "desc.gather.search:", "s3ho,search=march" },
    { "desc.gather.layers:", "s3ho,layers=2" },
    { "desc.gather.views:", "ssdo,environment=sh,views=1" },
    { "desc.light.one_sided:", "ssdo,environment=sh,two_sided=1,one_sided=1" },
    { "desc.light.bounce:", "ssdo,bounce=patch" },
    { NULL, "ssao,search=march,views=1" },
    { "desc.gather.thickness:", "ssao,layers=2,thickness=back" },
    { "desc.gather.thickness:", "lights,views=1,thickness=slabs" },
    { NULL, "emitters,layers=2,thickness=back" },
    { "desc.gather.falloff:", "ssao,falloff=none" },
    { "desc.gather.falloff:", "s3ho,search=points,falloff=none" },
    { NULL, "s3ho,falloff=none" },
    { "desc.filter.quantity:", "history,quantity=coefficients" },
    { "desc.filter.kind:", "blur,resolution=half,filter=gaussian" },
    { "desc.light.environment:", "ssdo" },
    { "desc.light.restore:", "shade,packed_coefficients=1,transfer=1,restore=ratio" },
    { NULL, "shade,packed_coefficients=1,transfer=1,restore=difference" },
    { "desc.light.receiver:", "lights,receiver=1" },
    { "desc.light.receiver:", "emitters,layers=3,receiver=3" },
    { "desc.light.receiver:", "lights,layers=2,receiver=1,normal=from_depth" },
    { "desc.input.multisampled:", "ssao,multisampled=1,dialect=300es" },
    { "desc.input.multisampled:", "ssao,multisampled=1,array=1" },
    { "desc.input.multisampled:", "emitters,multisampled=1,layers=2,receiver=1" },
    { NULL, "ssao,multisampled=1,dialect=310es" },
    { "desc.input.array:", "ssao,layers=2,array=1" },
    { "desc.shader.fetch:", "ssao,depth=custom" },
    { "desc.shader.fetch:", "ssao,normal=custom" },
    { "desc.shader.fetch:", "aof,objects=custom" },
    { "desc.shader.fetch:", "shade,harmonics=custom" },
    { "desc.shader.fetch:", "surfels,sends=custom" },
    { "desc.shader.fetch:", "dss,effect=custom" },
    { "desc.light.residual:", "shade,residual=1,harmonics=custom" },
    { "desc.light.occluded_emitters:",
      "s3ho,search=points,packed_coefficients=1,transfer=1,occluded_emitters=1,layers=2" },
    { "desc.light.occluded_emitters:",
      "s3ho,search=points,packed_coefficients=1,transfer=2,occluded_emitters=1,views=1" },
    { NULL, "s3ho,search=points,occluded_emitters=1,layers=2" },
    { "desc.light.packed_coefficients:", "s3ho,transfer=1" },
    { "desc.light.packed_coefficients:", "shade,transfer=2" },
    { "desc.light.packed_coefficients:", "blur,quantity=coefficients,transfer=1" },
    { "desc.light.shading:", "shade,shading=1,bands=1" },
    { "desc.light.shading:", "shade,shading=3,packed_coefficients=1,transfer=1" },
    { "desc.surfel.tessellate:", "surfels,tessellate=1" },
    { "desc.surfel.tessellate:", "dss,tessellate=1,dialect=310es" },
    { "desc.pass:", "surfels,dialect=vulkan" },
    { "desc.shader.uniforms:", "ssao,uniforms=loose,dialect=vulkan" },
    { "desc.shader.compute: needs", "ssao,compute=all" },
    { "desc.shader.compute: aof", "aof,compute=all,dialect=450" },
    { "desc.shader.compute: GLES", "s3ho,compute=all,packed_coefficients=1,transfer=1,dialect=310es" },
    { "desc.shader.compute: GLES",
      "blur,compute=all,packed_coefficients=1,transfer=2,quantity=coefficients,bands=3,dialect=320es" },
    { NULL, "s3ho,compute=all,packed_coefficients=1,transfer=1,dialect=450" },
    { NULL, "s3ho,compute=all,packed_coefficients=1,transfer=1,bands=2,dialect=310es" },
    { NULL, "s3ho,compute=all,packed_coefficients=1,transfer=1,shaded=1,dialect=310es" },
    { "desc.shader.compute: blends", "blur,compute=all,onto=multiply,dialect=450" },
    { "desc.shader.compute: blends", "debug,compute=all,onto=multiply,dialect=450" },
    { "desc.pass:", "surfels,tessellate=1,dialect=vulkan" },
    /* A value that is not kept may have many vectors; a field that a pass does not look at may have any value. */
    { NULL, "s3ho,transfer=1,shaded=1" },
    { NULL, "blur,quantity=light,transfer=1,shading=1,bands=1" },
    { NULL, "dss,tessellate=1,dialect=320es" },
    { NULL, "dss,tessellate=1,dialect=vulkan" },
    { NULL, "sum,tessellate=1" },
    { NULL, "shade,shading=1,bands=2" },
    { NULL, "shade,bands=1,packed_coefficients=1,transfer=2" }
};

/* Breaks each limit and each rule. A preset must refuse a desc as the check does. */
static void sentences(void)
{
    char broken[sizeof ssgi_gl__refusals / sizeof *ssgi_gl__refusals] = { 0 };
    const ssgi_gl_choice *c;
    const char *why = "";
    CHECK(ssgi_gl_check(NULL, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "desc:"), "NULL: %s", why);
    for (int i = 0; (c = ssgi_gl_choice_at(i)) != NULL; ++i) {
        const int bad[] = { -1, c->most + 1, INT32_MIN, INT32_MAX };
        char start[80];
        int taken = 0;
        snprintf(start, sizeof start, "desc.%s:", c->field);
        for (int v = 0; v < variants && !taken; ++v) {
            ssgi_gl_desc d = variant[v];
            if (c->offset == offsetof(ssgi_gl_desc, light.receiver)) d.gather.layers = 8;  /* it is below that */
            set(&d, c, c->most);
            taken = ssgi_gl_check(&d, NULL) == SSGI_OK;
        }
        CHECK(taken, "%s no variant can have %d", start, c->most);
        for (int k = 0; k < 4; ++k) {
            ssgi_gl_desc d = variant[0];
            set(&d, c, bad[k]);
            const ssgi_gl_desc was = d;
            why = "";
            CHECK(ssgi_gl_check(&d, &why) == SSGI_BAD_ARGUMENT && NAMES(why, start)
                      && ssgi_gl_check(&d, NULL) == SSGI_BAD_ARGUMENT,
                  "%s %d: \"%s\"", start, bad[k], why);
            why = "";
            CHECK(ssgi_gl_preset(&d, SSGI_GL_PRESET_BEST, &why) == SSGI_BAD_ARGUMENT && NAMES(why, start)
                      && !memcmp(&d, &was, sizeof d),
                  "preset: \"%s\"", why);
        }
    }
    for (size_t i = 0; i < sizeof rules / sizeof *rules; ++i) {
        ssgi_gl_desc d = desc_in(rules[i].desc);
        const char *const start = rules[i].start ? rules[i].start : "";
        d.shader.fetch = NAMES(start, "desc.shader.fetch:") ? NULL : T_FETCH;
        why = "";
        CHECK(ssgi_gl_check(&d, &why) == (*start ? SSGI_BAD_ARGUMENT : SSGI_OK) && (*start ? NAMES(why, start) : !*why),
              "%s: \"%s\"", rules[i].desc, why);
        for (size_t k = 0; k < sizeof broken; ++k) broken[k] |= (char)(why == ssgi_gl__refusals[k][1]);
    }
    for (size_t k = 0; k < sizeof broken; ++k)
        CHECK(broken[k], "no row of rules breaks \"%s\"", ssgi_gl__refusals[k][0]);
    for (int v = 0; v < variants; ++v)
        for (int preset = -1; preset < 4; ++preset) {
            ssgi_gl_desc d = variant[v];
            ssgi_result r = ssgi_gl_preset(&d, preset, &why),
                        want = preset < 0 || preset > 2 ? SSGI_BAD_ARGUMENT : SSGI_OK;
            CHECK(r == want && (r == SSGI_OK || NAMES(why, "preset:"))
                      && ((r == SSGI_OK && ssgi_gl__pass_of(d.pass)->preset)
                          || !memcmp(&d, &variant[v], sizeof d)),
                  "preset %d: \"%s\"", preset, why);
            CHECK(ssgi_gl_check(&d, &why) == SSGI_OK, "preset %d of %s leaves a bad desc: %s", preset,
                  describe(&variant[v]), why);
        }
}

/* Checks that a compute stage has at most 4 images, which is all that GLES promises. */
static void images_of_gles(void)
{
    const int dialects[] = { SSGI_GL_DIALECT_310ES, SSGI_GL_DIALECT_320ES };
    int most = 0;
    for (int v = 0; v < 2 * variants; ++v) {
        ssgi_gl_desc d = variant[v / 2];
        ssgi_gl_io row[SSGI_GL_MAX_IO];
        int images = 0;
        d.shader.compute = SSGI_GL_COMPUTE_ALL;
        d.shader.dialect = dialects[v % 2];
        for (int i = 0, n = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO); i < n; ++i)
            images += row[i].kind == SSGI_GL_IO_OUTPUT;
        CHECK(images <= 4, "%s: %d images", describe(&d), images);
        if (images > most) most = images;
    }
    CHECK(most == 4, "the most images are %d", most);
}

/* Checks that the name of each dialect begins with the version that its texts have. */
static void names_of_dialects(void)
{
    static char text[TEXT];
    ssgi_gl_desc d = { .pass = SSGI_GL_PASS_SSAO };
    for (int i = 0; i < SSGI_GL_DIALECTS; ++i) {
        const char *const name = ssgi_gl_dialect_name(i);
        d.shader.dialect = i;
        const int version = atoi(emit(text, &d, SSGI_GL_STAGE_VERTEX) + strlen("#version "));
        CHECK(name && version == (i == SSGI_GL_DIALECT_VULKAN ? 450 : atoi(name)),
              "dialect %s begins with %.16s", name ? name : "NULL", text);
    }
    CHECK(!ssgi_gl_dialect_name(SSGI_GL_DIALECTS) && !ssgi_gl_dialect_name(-1), "there are more names than dialects");
}

/* Checks the defaults of a frame. */
static void frames(void)
{
    static const float m[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 };
    ssgi_view view;
    ssgi_gl_frame frame;
    float light = 0;
    ssgi_view_from_projection(&view, m, SSGI_CLIP_GL, 64, 32, NULL);
    memset(&frame, 0x5a, sizeof frame);
    CHECK(ssgi_gl_frame_init(&frame, &view, 0.5f, NULL) == SSGI_OK && frame.radius == 0.5f
              && frame.thickness_limit == 0.6f * 0.5f && frame.offset == 1.5f && frame.phase == 0.0f
              && frame.fade == 0.3f * 0.5f && frame.distance_clamp == 0.25f && frame.gain == 1.0f
              && frame.max_slope == 20.0f && !frame.lights && frame.lambda == 4.0f && frame.window[0] == 1.0f
              && fabsf(frame.window[1] - 0.8535534f) < 1e-6f && fabsf(frame.window[3] - 0.1464466f) < 1e-6f
              && frame.rotation[0] == 1.0f && frame.rotation[5] == 1.0f && frame.rotation[10] == 1.0f
              && frame.size[0] == 64 && frame.size[1] == 32 && frame.mesh[0] == 1.0f && frame.mesh[5] == 1.0f
              && frame.mesh[10] == 1.0f && frame.mesh[15] == 1.0f && frame.near_depth == ssgi_view_near(&view)
              && frame.epsilon == 0.3f && frame.exponent == 32.0f,
          "the frame's defaults");
    for (int i = 0; i < 48; ++i) light += fabsf(frame.harmonics[i]);
    CHECK(light == 0.0f, "a frame's light is not black");
}

/* Checks that a desc equals the same one with its defaults written out and with fields that it does not look at. */
static void defaults(void)
{
    static const struct { const char *plain, *more; } rows[] = {
        { "ssao", "directions=16,samples=1,layers=1,view_layers=1" },
        { "hsao", "slices=1,samples=6" },
        { "hsao,samples=4,thickness=slabs", "slices=1" },
        { "ssao,thickness=back", "directions=16" },
        { "hsao,search=march,normal_rays=1,views=1", "directions=6,samples=6,view_layers=1" },
        { "hsao,search=march,march_terms=rays,layers=3", "normal_rays=1,growing_sphere=1" },
        { "hsao,search=march,layers=2", "march_terms=horizon,normal_rays=2" },
        { "hsao", "march_terms=rays,growing_sphere=1" },
        { "ssdo,search=points,environment=map", "directions=16,samples=1,layers=1" },
        { "ssdo,search=points,bounce=patch,kernel_texture=1,layers=2,views=2,view_layers=3,samples=2,noise=texture",
          "directions=16" },
        { "lights", "samples=8,layers=1" },
        { "lights,shadow=fill,accumulate=1", "samples=8" },
        { "lights,shadow=none", "samples=64,noise=texture,thickness=solid" },
        { "emitters,radiance=both", "layers=1" },
        { "ssdo,search=points,environment=sh", "bands=3" },
        { "s3ho,search=points", "directions=16,samples=1,layers=1,bands=4" },
        { "s3ho,search=points,transfer=1,packed_coefficients=1,kernel_texture=1,layers=3,views=1,view_layers=2,"
          "samples=2,noise=texture",
          "directions=16" },
        { "s3ho,search=points,shaded=1,residual=1", "bands=4" },
        { "shade", "bands=4" },
        { "shade,residual=1,harmonic_lights=1", "bands=4" },
        { "shade,bands=2,harmonic_lights=1", "directions=1" },
        { "shade,packed_coefficients=1,transfer=1,albedo=1", "transfer=2,bands=4" },
        { "shade,shading=2", "bands=2" },
        { "shade,shading=1,harmonic_lights=1", "bands=4" },
        { "shade,shading=3,packed_coefficients=1,harmonic_lights=1,albedo=1", "harmonic_lights=0,albedo=0,bands=3" },
        { "aof", "directions=64,layers=8,resolution=half" },
        { "aof,objects=texture,normal=from_depth", "resolution=half" },
        { "aof,cap_table=1", "resolution=half" },
        { "surfels", "shadow=map,environment=map,effect=bounce" },
        { "surfels,dialect=410,tessellate=1,sends=lights,shadow=map,environment=sh", "resolution=half" },
        { "interleave,normal=from_depth", "levels=4" },
        { "dss", "levels=4,near_samples=1,sends=lights" },
        { "dss,effect=light", "levels=4,falloff=none" },
        { "deinterleave,effect=scatter", "levels=4" },
        { "smooth", "levels=4" },
        { "smooth,levels=2,filter_normals=1,normal=from_depth", "near_samples=1" },
        { "sum", "levels=4" },
        { "sum,levels=3,effect=light", "axis=1" },
        { "blur,quantity=coefficients", "bands=4,filter_radius=1" },
        { "blur,quantity=coefficients,resolution=half,bands=3,filter_normals=1", "filter_radius=1" },
        { "blur,quantity=coefficients,packed_coefficients=1,transfer=2,filter=gaussian",
          "transfer=1,filter_radius=2" },
        { "blur", "filter_radius=1" },
        { "blur,quantity=light,restore=ratio,environment=map", "filter_radius=1" },
        { "blur,quantity=light,filter=gaussian", "filter_radius=2" }
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        char words[400];
        snprintf(words, sizeof words, "%s,%s", rows[i].plain, rows[i].more);
        const ssgi_gl_desc plain = desc_in(rows[i].plain), whole = desc_in(words);
        CHECK(ssgi_gl_key(&plain) == ssgi_gl_key(&whole), "%s: its defaults written out give another text", words);
    }
}

/* ---- >>complete: a part that is missing is named ----------------------------------------------------------------- */

/* Checks that every field in the header is in the library's table, and that a count's comment has its limit. */
static void every_field(void)
{
    char *header, name[64], type[64], group[64] = "", field[160], limit[40], end_ = 0;
    size_t size;
    int found = 1; /* desc.pass */
    if (!CHECK(!kit_file_read(&header, &size, "ssgi_gl.h", NULL), "ssgi_gl.h cannot be read")) return;
    const char *at = strstr(header, "/* ---- desc."), *end = at ? strstr(at, "} ssgi_gl_desc;") : NULL;
    for (; end && (at = strchr(at, '\n')) != NULL && at++ < end;) {
        const ssgi_gl_choice *row = NULL, *c;
        if (sscanf(at, "typedef struct ssgi_gl_%63[a-z_] {", group) == 1) continue;
        if (!strncmp(at, "} ", 2)) *group = 0;
        if (!*group || !strcmp(group, "desc") || sscanf(at, " %63[a-z_] %63[a-z_]%c", type, name, &end_) != 3
            || end_ != ';' || (strcmp(type, "int") && strncmp(type, "ssgi_", 5))) continue;
        snprintf(field, sizeof field, "%.*s.%s", (int)(strlen(group) - strlen("_desc")), group, name);
        ++found;
        for (int i = 0; (c = ssgi_gl_choice_at(i)) != NULL; ++i) if (!strcmp(c->field, field)) row = c;
        if (!CHECK(row, "desc.%s is not in ssgi_gl__fields (ssgi_gl.h, >>desc): no check, no #if, no key knows it",
                   field))
            continue;
        CHECK((!strncmp(type, "ssgi_", 5)) == (*row->values != 0), "desc.%s: an enum has words, a number has none",
              field);
        snprintf(limit, sizeof limit, "[limit: 0..%d", row->most);
        const char *const told = strstr(at, "[limit: ");
        CHECK(*row->values || row->most == 1 || (told && told < at + 120 && !strncmp(told, limit, strlen(limit))
                                                 && !isdigit((unsigned char)told[strlen(limit)])),
              "desc.%s: its comment does not say %s]", field, limit);
    }
    free(header);
    CHECK(found == SSGI_GL__FIELDS, "%d fields in the header, %d in ssgi_gl__fields", found, SSGI_GL__FIELDS);
}

/* Checks that every line and every row of the library are in a compiled shader. */
static void every_line(void)
{
    static char text[SSGI_GL_STAGES * TEXT], line_of[400];
    static set_of lines;
    static char met[SSGI_GL__ROWS];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    for (int i = 0; i < texts + 5; ++i) {
        if (i == texts + 4) ssgi_gl_reflection(text, sizeof text);
        else if (i >= texts) ssgi_gl_sh(text, sizeof text, i - texts + 1);
        else source_of(text, &spoken[i].desc, spoken[i].stage);
        for (const char *line = text, *end; *line; line = end + (*end != 0)) {
            end = line + strcspn(line, "\n");
            had(&lines, line, (size_t)(end - line));
        }
        for (int k = 0, n = i < texts ? ssgi_gl_reflect(&spoken[i].desc, row, SSGI_GL_MAX_IO) : 0; k < n; ++k)
            for (int r = 0; r < SSGI_GL__ROWS; ++r)
                met[r] |= ssgi_gl__rows[r].io.name == row[k].name && ssgi_gl__rows[r].io.format == row[k].format;
    }
    for (int i = 0; i < SSGI_GL__CODES; ++i) {
        const ssgi_gl__code *c = &ssgi_gl__library[i];
        if (!strcmp(c->name, "SSGI_KERNEL_TABLE")) continue;     /* its numbers are printed */
        for (const char *line = c->text, *end; *line; line = end + 1) {
            end = strchr(line, '\n');
            const char *guard = memchr(line, '#', (size_t)(end - line));
            if (guard == line) continue;
            const int length = (int)((guard ? guard - 4 : end) - line);
            snprintf(line_of, sizeof line_of, "%.*s", length, line);
            CHECK(had(&lines, line_of, strlen(line_of)), "%s: no text that is compiled has \"%s\": it cannot be "
                  "reached, or by values that no variant has (test_text.c, >>variants)", c->name, line_of);
        }
    }
    for (int r = 0; r < SSGI_GL__ROWS; ++r)
        CHECK(met[r], "row %s, \"%.40s\": no text that is compiled has it (test_text.c, >>variants)",
              ssgi_gl__rows[r].io.name, ssgi_gl__rows[r].io.format);
}

/* Returns the passes of a chain's steps as bits. No step may read a texture that it writes. */
static uint64_t passes_of(const ssgi_gl_chain *chain)
{
    static ssgi_gl_step step[128];
    const int n = ssgi_gl_steps(step, 128, chain, NULL);
    uint64_t passes = 0;
    for (int k = 0; k < n && k < 128; ++k) {
        passes |= (uint64_t)1 << step[k].desc.pass;
        for (int i = 0; i < step[k].inputs; ++i)
            for (int o = 0; o < step[k].outputs; ++o)
                CHECK(step[k].input[i].texture < 0 || step[k].input[i].last
                          || step[k].input[i].texture != step[k].output[o].texture,
                      "pass %s reads %s, which it writes: a texture that is new needs a row of its own in "
                      "ssgi_gl__rows", ssgi_gl_pass_name(step[k].desc.pass), step[k].input[i].name);
    }
    return passes;
}

/* Returns the passes that ssgi_gl_steps draws for chains that together use everything: each method by its name, and
   each pass alone, with and without each part that a chain may add. */
static uint64_t drawn_passes(void)
{
    const ssgi_gl_method *method;
    uint64_t passes = 0;
    for (int m = 0; m < SSGI_GL_PASSES || ssgi_gl_method_at(m); ++m)
        for (int flags = 0; flags < 16; ++flags) {
            ssgi_gl_chain chain = { .desc = { .pass = m, .light.environment = SSGI_GL_ENVIRONMENT_SH },
                                    .width = 64,
                                    .height = 36 };
            if (!flags && m < SSGI_GL_PASSES) passes |= passes_of(&chain);
            if ((method = ssgi_gl_method_at(m)) == NULL || ssgi_gl_chain_of(&chain, method->name, NULL)) continue;
            chain.width = 64;
            chain.height = 36;
            chain.desc.shader.dialect = chain.lights.shader.dialect = SSGI_GL_DIALECT_450;
            chain.blur = flags & 1;
            chain.history = flags >> 1 & 1;
            chain.lights.pass = flags & 4 ? SSGI_GL_PASS_LIGHTS : 0;
            chain.desc.filter.onto = flags & 8 ? SSGI_GL_ONTO_MULTIPLY : SSGI_GL_ONTO_NONE;
            passes |= passes_of(&chain);
        }
    return passes;
}

/* Checks that every pass has its section of PASSES.md, steps that draw it, and a group that tests it. */
static void every_pass(void)
{
    char *passes;
    size_t size;
    const uint64_t drawn_ = drawn_passes();
    if (!CHECK(!kit_file_read(&passes, &size, "examples/docs/PASSES.md", NULL), "PASSES.md cannot be read")) return;
    for (int pass = 0; pass < SSGI_GL_PASSES; ++pass) {
        char start[80], command[80];
        const char *const name = ssgi_gl_pass_name(pass);
        snprintf(command, sizeof command, "sh tests/groups.sh %s >/dev/null", name);
        snprintf(start, sizeof start, "### %s", name);
        CHECK(strstr(passes, start), "%s: PASSES.md has no section on it: make passes", name);
        /* surfels fills a buffer of yours, once */
        CHECK(drawn_ >> pass & 1 || pass == SSGI_GL_PASS_SURFELS,
              "%s: ssgi_gl_steps never draws it: ssgi_gl.h, >>steps, "
              "and a chain that asks for it in drawn_passes (tests/library/test_text.c)",
              name);
        CHECK(!system(command), "%s: no group of tests judges it: add a case to twins or steps", name);
    }
    free(passes);
}

void test_text(void)
{
    if (!every_pass_has_a_row()) return;
    make_variants();
    speak();
    RUN("every field of a desc is varied, refused by name and known to the library's table", every_field);
    RUN("every pass is described, drawn by steps and judged by a group of tests", every_pass);
    RUN("every line of the library and every row is in a text that is compiled", every_line);
    RUN("emit keeps snprintf's law at every capacity", law);
    RUN("the same desc gives the same bytes, under any locale", same_bytes);
    RUN("every bad field is named, and what was given stays untouched", sentences);
    RUN("no compute stage of GLES has more than 4 images", images_of_gles);
    RUN("each dialect is named by its version", names_of_dialects);
    RUN("a frame has its defaults", frames);
    RUN("what is off leaves nothing: every name that a text declares is used, in functions that stand alone, too",
        closed);
    RUN("text is plain: ASCII, our own names, nothing reserved in GLSL, HLSL, MSL or WGSL", lint);
    RUN("every text compiles: each pass, dialect and choice, with Khronos' compiler and Mesa's; a vertex stage of its "
        "own links",
        compilers);
    RUN("rows and declarations agree both ways, and with GL's own places", reflection);
    RUN("loose uniforms: the same rows, and the same text but for their declarations", loose_uniforms);
    RUN("SPIR-V has the sets and bindings that rows tell, and its stages link", places_in_spirv);
    RUN("WGSL by tint, HLSL and MSL by spirv-cross: everything is at its binding, y is turned", translated);
    RUN("defaults written out give the same text", defaults);
    if (desktop) kit_gl_close();
}
