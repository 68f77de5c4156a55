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
#include <inttypes.h>
#include <locale.h>
#include <pthread.h>
#include <stdlib.h>
#include <unistd.h>

/* ---- >>variants: every three choices together, in each pass ------------------------------------------------------- */

typedef struct choice { const char *name; size_t offset; int count, first, step; } choice;   /* values first, first + step .. */
#define CHOICE(field, count, first, step) { #field, offsetof(ssgi_gl_desc, field), count, first, step }
static const choice choices[] = {
    CHOICE(orthographic, 2, 0, 1), CHOICE(depth, 3, 0, 1), CHOICE(normal, 5, 0, 1), CHOICE(world_normals, 2, 0, 1), CHOICE(noise, 3, 0, 1), CHOICE(steps, 2, 1, 2),
    CHOICE(normal_rays, 2, 0, 2), CHOICE(hard, 2, 0, 1), CHOICE(thin, 2, 0, 1), CHOICE(falloff, 3, 0, 1), CHOICE(kernel, 2, 0, 1), CHOICE(fade, 4, 0, 1),
    CHOICE(range, 2, 0, 1), CHOICE(layers, 3, 1, 1), CHOICE(views, 2, 0, 2), CHOICE(view_layers, 2, 1, 1), CHOICE(receiver, 2, 0, 1), CHOICE(environment, 3, 0, 1),
    CHOICE(bounce, 4, 0, 1), CHOICE(bands, 4, 1, 1), CHOICE(packed, 2, 0, 1), CHOICE(transfer, 3, 0, 1), CHOICE(shaded, 2, 0, 1), CHOICE(shading, 4, 0, 1),
    CHOICE(lamps, 2, 0, 1), CHOICE(albedo, 2, 0, 1), CHOICE(exact, 2, 0, 1), CHOICE(two_sided, 2, 0, 1), CHOICE(shadow, 4, 0, 1), CHOICE(accumulate, 2, 0, 1),
    CHOICE(radiance, 4, 0, 1), CHOICE(storage, 2, 0, 1), CHOICE(measure, 2, 0, 1), CHOICE(eight_bits, 2, 0, 1), CHOICE(cap, 2, 0, 1), CHOICE(objects, 3, 0, 1),
    CHOICE(half, 2, 0, 1), CHOICE(colour, 3, 0, 1), CHOICE(filter, 2, 0, 1), CHOICE(filter_normals, 2, 0, 1), CHOICE(effect, 5, 0, 1),
    CHOICE(fixed, 2, 0, 1), CHOICE(sends, 3, 0, 1), CHOICE(enlarge, 2, 0, 1), CHOICE(closely, 2, 1, 3), CHOICE(overlap, 2, 0, 1), CHOICE(axis, 2, 0, 1)
};
enum { CHOICES = (int)(sizeof choices / sizeof choices[0]), VALUES = 5, MOST = 1 << 13, POOL = 10000, TEXT = 1 << 16, TOOLBOX = SSGI_GL_STAGES, PROGRAM,
       WORDS = (int)(sizeof(ssgi_gl__set) / sizeof(uint64_t)) };
#define FETCH "float ssgi_custom_depth(ivec2 p, int j) { return float(p.x + j); }\nvec3 ssgi_custom_normal(ivec2 p) { return vec3(p, 1.0); }\nuint ssgi_custom_object(ivec2 p) { return uint(p.x); }\n" \
    "vec3 ssgi_custom_surfel(vec3 p, vec3 n, vec3 colour) { return colour * max(n.y, p.x); }"

static ssgi_gl_desc variant[MOST];
static int variants, first_of[SSGI_GL__ROWS + 1];         /* those of the table's pass t begin at first_of[t] */
static uint64_t random_state;

static float uniform(float lower, float upper)
{
    uint64_t z = random_state += 0x9e3779b97f4a7c15u;      /* SplitMix64: the many choices of a desc are independent */
    z = (z ^ z >> 30) * 0xbf58476d1ce4e5b9u;
    z = (z ^ z >> 27) * 0x94d049bb133111ebu;
    return lower + (upper - lower) * (float)(z >> 40) * (1.0f / 16777216.0f);
}

static int  get(const ssgi_gl_desc *d, size_t offset) { int v; memcpy(&v, (const char *)d + offset, sizeof v); return v; }
static void set(ssgi_gl_desc *d, size_t offset, int v) { memcpy((char *)d + offset, &v, sizeof v); }
static void choose(ssgi_gl_desc *d, int k, int value) { set(d, choices[k].offset, choices[k].first + value * choices[k].step); }
static int  chosen(const ssgi_gl_desc *d, int k) { return (get(d, choices[k].offset) - choices[k].first) / choices[k].step; }

static ssgi_gl_desc plain_desc(int t)      /* of the table's pass t: nothing chosen yet */
{
    const int pass = ssgi_gl__passes[t].pass, other = ssgi_gl__passes[t].variant > 0, hsao = pass == SSGI_GL_HSAO, patches = other && !hsao;
    ssgi_gl_desc d = { .pass = pass, .search = other && hsao, .tessellate = patches, .dialect = patches ? SSGI_GL_410 : SSGI_GL_330, .samples = 4, .directions = 2, .fetch = FETCH };
    for (int k = 0; k < CHOICES; ++k) choose(&d, k, 0);
    return d;
}

/* All that these choices bring into the text, its rows, chunks and constants; 0 when refused. ssgi_gl_key, but much faster. */
static uint64_t content(const ssgi_gl_desc *desc)
{
    if (ssgi_gl_check(desc, NULL) != SSGI_OK) return 0;
    ssgi_gl_desc d = ssgi_gl__resolve(desc);
    const ssgi_gl__set features = ssgi_gl__features(&d);
    const ssgi_gl__pass *pass = ssgi_gl__find(&d);
    uint64_t hash = 1;
    for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
        for (const ssgi_gl__row *const *r = pass->rows[stage]; r && *r; ++r)
            if (ssgi_gl__has(&features, (*r)->need))
                hash = (hash ^ (uint64_t)(uintptr_t)*r ^ (uint64_t)((*r)->io.kind == SSGI_GL_CONSTANT ? get(&d, (*r)->io.offset) : 0) << 56) * 0x9e3779b97f4a7c15u;
        for (const ssgi_gl__chunk *const *c = pass->chunks[stage]; c && *c; ++c)
            if (ssgi_gl__has(&features, (*c)->need)) hash = (hash ^ (uint64_t)(*c)->line) * 0x9e3779b97f4a7c15u;
    }
    return hash | 1;
}

/* The fields that matter in a desc, those of which another value gives another text, and how they are chosen: VALUES * field + value, the first that gives this text. */
typedef struct point { ssgi_gl_desc desc; uint64_t content; int place[CHOICES], places; } point;

static void locate(point *p)
{
    p->places = 0;
    for (int k = 0; k < CHOICES; ++k) {
        int same = -1, matters = 0;
        for (int v = 0; v < choices[k].count && !(matters && same >= 0); ++v) {
            ssgi_gl_desc other = p->desc;
            choose(&other, k, v);
            const uint64_t its = v == chosen(&p->desc, k) ? p->content : content(&other);
            if (its == p->content && same < 0) same = v;
            matters |= its && its != p->content;
        }
        if (matters) p->place[p->places++] = VALUES * k + same;
    }
}

/* Chooses at random, but for those whose bit is set in kept; 0 when nothing that is accepted was found. */
static uint64_t choose_freely(ssgi_gl_desc *d, uint64_t kept)
{
    uint64_t found = 0;
    for (int tries = 0; tries < 64 && !found; ++tries) {
        for (int k = 0; k < CHOICES; ++k) if (!(kept >> k & 1)) choose(d, k, (int)uniform(0, (float)choices[k].count - 0.001f));
        found = content(d);
    }
    return found;
}

static void random_point(point *p, int t)
{
    p->desc = plain_desc(t);
    p->content = choose_freely(&p->desc, 0);
    locate(p);
}

/* How many triples of a point's choices were covered fewer than so many times; mark covers them. */
static unsigned char covered[CHOICES * VALUES][CHOICES * VALUES][CHOICES * VALUES];
static int triples(const point *p, int times, int mark)
{
    int fresh = 0;
    for (int a = 0; a < p->places; ++a)
        for (int b = 0; b < a; ++b)
            for (int c = 0; c < b; ++c) {
                unsigned char *at = &covered[p->place[a]][p->place[b]][p->place[c]];
                fresh += *at < times;
                *at = (unsigned char)(*at + (mark && *at < times));
            }
    return fresh;
}

/* Greedy: from a pool of random points always the one that covers most, each another text. */
static void make_variants(void)
{
    static point pool[POOL];
    static int gain[POOL];                                 /* at most: it falls */
    static uint64_t taken[MOST];
    random_state = 1;
    for (int t = 0; t < SSGI_GL__ROWS; ++t) {
        const int times = ssgi_gl__passes[t].chunks[SSGI_GL_VERTEX] == ssgi_gl__vertex_chunks ? 2 : 1;    /* programs of several stages take long */
        memset(covered, 0, sizeof covered);
        for (int i = 0; i < POOL; ++i) {
            random_point(&pool[i], t);
            gain[i] = triples(&pool[i], times, 0);
        }
        for (int most = CHOICES * CHOICES * CHOICES / 6; most; --most)
            for (int i = 0; i < POOL; ++i) {
                if (gain[i] != most) continue;
                int v = first_of[t];
                while (v < variants && taken[v] != pool[i].content) ++v;
                gain[i] = v < variants ? 0 : triples(&pool[i], times, 0);
                if (gain[i] < most || variants == MOST) continue;
                triples(&pool[i], times, 1);
                taken[variants] = pool[i].content;
                variant[variants++] = pool[i].desc;
            }
        first_of[t + 1] = variants;
    }
}

static const char *describe(const ssgi_gl_desc *d)
{
    static _Thread_local char text[1000];
    size_t n = (size_t)snprintf(text, sizeof text, "%s%s%s %s", ssgi_gl_pass_name(d->pass), d->pass == SSGI_GL_HSAO && d->search ? " march" : "", d->tessellate ? " tessellated" : "", ssgi_gl_dialect_name(d->dialect));
    for (int k = 0; k < CHOICES; ++k)
        if (chosen(d, k)) n += (size_t)snprintf(text + n, sizeof text - n, ", %s %d", choices[k].name, get(d, choices[k].offset));
    return text;
}

static int has_stage(const ssgi_gl_desc *d, int stage) { return ssgi_gl__find(d)->chunks[stage] != NULL; }

/* The text of a stage, "" of one that the pass does not have. */
static const char *emit(char *text, const ssgi_gl_desc *d, int stage)
{
    size_t n = ssgi_gl_emit(text, TEXT, d, stage);
    CHECK((n > 0) == has_stage(d, stage) && n < TEXT && (n || !*text), "%s, stage %d: a text of %zu characters", describe(d), stage, n);
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

/* Random points that the choice of variants did not see find no triple that is not covered. */
static void covering(void)
{
    enum { DRAWN = 3000 };
    int all = 0, seen = 0;
    point p;
    random_state = 2;
    for (int t = 0; t < SSGI_GL__ROWS; ++t) {
        memset(covered, 0, sizeof covered);
        for (int v = first_of[t]; v < first_of[t + 1]; ++v) {
            p.desc = variant[v];
            p.content = content(&p.desc);
            locate(&p);
            all += triples(&p, 1, 1);
        }
        for (int i = 0; i < DRAWN; ++i, ++seen) {
            random_point(&p, t);
            const int missing = triples(&p, 1, 0);
            CHECK(!missing, "%s: %d triples of its choices are in no variant", describe(&p.desc), missing);
            if (i % 16) continue;
            ssgi_gl_desc other = p.desc;
            const int k = i / 16 % CHOICES;
            choose(&other, k, (chosen(&other, k) + 1) % choices[k].count);
            CHECK((content(&other) == p.content) == (ssgi_gl_key(&other) == ssgi_gl_key(&p.desc)),
                  "%s: another %s does not change features and text alike", describe(&p.desc), choices[k].name);
        }
    }
    t_note("%d variants hold all %d triples of choices that matter together: %d random descs have no other", variants, all, seen);
}

/* ---- >>compilers ------------------------------------------------------------------------------------------------- */

static struct { ssgi_gl_desc desc; int stage, fresh; } spoken[4 * MOST];   /* the texts that are compiled; fresh: a program whose stages declare what no other's did */
static int texts;
static struct { int texts, linked; char problem[1000]; } glslang;

/* The text of a stage; PROGRAM: of all, one after the other; TOOLBOX: of ssgi_gl_field, whatever the pass, in a fragment shader that calls it. */
static const char *source_of(char *text, const ssgi_gl_desc *d, int stage)
{
    if (stage == PROGRAM)
        for (int s = 0, at = 0; s < SSGI_GL_STAGES; ++s) at += (int)strlen(emit(text + at, d, s));
    if (stage != TOOLBOX) return stage == PROGRAM ? text : emit(text, d, stage);
    size_t n = (size_t)snprintf(text, TEXT, "%s%s", ssgi_gl__dialects[d->dialect].version, d->dialect >= SSGI_GL_300ES ? "precision highp float;\nprecision highp int;\n" : "");
    n += ssgi_gl_field(text + n, TEXT - n, d);
    snprintf(text + n, TEXT - n, "out vec4 o;\nvoid main()\n{\n    o = vec4(ssgi_field_visibility(9, 1, gl_FragCoord.xyz, vec3(0.0, 0.0, 1.0)));\n}\n");
    return text;
}

/* Is the vertex stage more than a triangle? */
static int has_vertices(const ssgi_gl_desc *d) { return ssgi_gl__find(d)->chunks[SSGI_GL_VERTEX] != ssgi_gl__vertex_chunks; }

/* Every variant in a desktop dialect and in an ES one, in turn, of those that it may have: each choice meets each other choice, and each dialect. The stages
   of their own that passes have as one program; the others' vertex stage once a dialect; every toolbox in every dialect. */
static void speak(void)
{
    static uint64_t seen[1 << 10];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    int interfaces = 0;
    for (int i = 0; i < SSGI_GL_DIALECTS; ++i, ++texts) spoken[texts].desc.dialect = i;
    for (int i = 0; i < 2 * variants; ++i, ++texts) {
        ssgi_gl_desc d = variant[i / 2];
        const int first = (int)(content(&d) >> 20 & 1023);
        d.lines = i % 16 < 2;
        for (int k = 0; k < 3; ++k) {
            d.dialect = (i & 1) * 3 + (first + k) % 3;
            if (ssgi_gl_check(&d, NULL) == SSGI_OK) break;
        }
        spoken[texts].desc = d;
        spoken[texts].stage = has_vertices(&d) ? PROGRAM : SSGI_GL_FRAGMENT;
        if (!has_vertices(&d)) continue;
        uint64_t hash = (uint64_t)(2 * d.pass + d.tessellate);
        for (int k = 0, v = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO); k < v; ++k) hash = (hash ^ (uint64_t)(uintptr_t)row[k].name ^ (uint64_t)row[k].kind << 56) * 0x9e3779b97f4a7c15u;
        int s = 0;
        while (s < interfaces && seen[s] != hash) ++s;
        spoken[texts].fresh = s == interfaces && (int)(hash >> 40 & 1) == (i & 1);      /* one in ES, the next not */
        if (spoken[texts].fresh && CHECK(s < 1 << 10, "too many interfaces")) seen[interfaces++] = hash;
    }
    for (int i = 0; i < 16 * SSGI_GL_DIALECTS; ++i, ++texts) {
        const int k = i / SSGI_GL_DIALECTS;
        const ssgi_gl_desc d = { .dialect = i % SSGI_GL_DIALECTS, .storage = k & 1, .measure = k >> 1 & 1, .eight_bits = k >> 2 & 1, .cap = k >> 3 };
        spoken[texts].desc = d;
        spoken[texts].stage = TOOLBOX;
    }
}

/* Many files a call; stages are linked where they are fresh, as that takes long. */
static void *glslang_run(void *folder)
{
    enum { BATCH = 512 };
    static const char *const endings[SSGI_GL_STAGES + 1] = { "vert", "frag", "tesc", "tese", "geom", "frag" };
    static char text[TEXT];
    char path[400], line[400], file[400] = "0";
    int passed = 1;
    for (int first = 0; first < texts && passed; first += BATCH) {
        for (int i = first; i < first + BATCH && i < texts; ++i, ++glslang.texts) {
            const int program = spoken[i].stage == PROGRAM;
            for (int stage = program ? 0 : spoken[i].stage; stage < (program ? SSGI_GL_STAGES : spoken[i].stage + 1); ++stage) {
                const size_t n = strlen(source_of(text, &spoken[i].desc, stage));
                snprintf(path, sizeof path, "%s/%s%d.%s", (char *)folder, spoken[i].fresh ? "p" : "", i, endings[stage]);
                if (n) kit_file_write(path, text, n, NULL);
            }
            glslang.linked += spoken[i].fresh;
        }
        snprintf(path, sizeof path, "cd '%s' && ls | grep '^[0-9]' | xargs -r -n 256 -P 2 glslangValidator 2>&1 && "
                 "ls | sed -n 's/^\\(p.*\\).vert$/\\1/p' | xargs -r -P 2 -I{} sh -c 'glslangValidator -l {}.*' 2>&1 && rm *.* && echo passed", (char *)folder);
        FILE *pipe = popen(path, "r");
        for (passed = 0; pipe && fgets(line, sizeof line, pipe); passed |= !strcmp(line, "passed\n")) {
            if (isdigit((unsigned char)line[*line == 'p'])) memcpy(file, line + (*line == 'p'), sizeof file - 1);
            if (!strncmp(line, "ERROR", 5) && !glslang.problem[0]) snprintf(glslang.problem, sizeof glslang.problem, "%s%s", describe(&spoken[atoi(file)].desc), line + 5);
        }
        if (pipe) pclose(pipe);
        if (!passed && !glslang.problem[0]) strcpy(glslang.problem, "no answer");
    }
    return NULL;
}

/* A program of d's stages, the fragment stage perhaps another, with what transform feedback is to keep. */
static GLuint linked(const ssgi_gl_desc *d, const char *fragment)
{
    static char text[SSGI_GL_STAGES][TEXT];
    static const GLenum kinds[SSGI_GL_STAGES] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, GL_TESS_CONTROL_SHADER, GL_TESS_EVALUATION_SHADER, GL_GEOMETRY_SHADER };
    const char *source[SSGI_GL_STAGES], *kept[3];
    GLenum stage[SSGI_GL_STAGES];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    kit_error err = { "" };
    GLint ok = 1;
    int stages = 0, keeps = 0;
    for (int s = 0; s < SSGI_GL_STAGES; ++s) {
        source[stages] = s == SSGI_GL_FRAGMENT && fragment ? fragment : emit(text[s], d, s);
        if (s == SSGI_GL_FRAGMENT && !*source[stages] && kit_gl_is_es()) snprintf(text[s], TEXT, "%svoid main() {}\n", ssgi_gl__dialects[d->dialect].version);    /* GLES links no program without one */
        stage[stages] = kinds[s];
        stages += *source[stages] != 0;
    }
    for (int i = 0, rows = ssgi_gl_reflect(d, row, SSGI_GL_MAX_IO); i < rows; ++i)
        if (row[i].kind == SSGI_GL_CAPTURE && CHECK(row[i].slot == keeps && keeps < 3, "%s: %s is at %d of what is kept", describe(d), row[i].name, row[i].slot)) kept[keeps++] = row[i].name;
    GLuint program = kit_program(source, stage, stages, &err);
    if (!CHECK(program, "%s: %s", describe(d), err.text) || !keeps) return program;
    glTransformFeedbackVaryings(program, keeps, kept, GL_INTERLEAVED_ATTRIBS);
    glLinkProgram(program);
    glGetProgramiv(program, GL_LINK_STATUS, &ok);
    CHECK(ok, "%s: what it keeps does not link", describe(d));
    return program;
}

static int compiles(const ssgi_gl_desc *d, int stage)
{
    static char text[TEXT], log[600];
    GLint ok = 0;
    if (stage == PROGRAM) {
        const GLuint program = linked(d, NULL);
        glDeleteProgram(program);
        return program != 0;
    }
    const char *source = source_of(text, d, stage);
    GLuint shader = glCreateShader(stage == SSGI_GL_VERTEX ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
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
        int tried = 0;
        if (es && !kit_gl_open("egl-es", NULL)) { glGetIntegerv(GL_MAJOR_VERSION, &version[0]); glGetIntegerv(GL_MINOR_VERSION, &version[1]); }
        if (version[0] * 10 + version[1] < 32) desktop = CHECK(!kit_gl_open("osmesa", &err), "%s", err.text);    /* takes ES texts too: ARB_ES3_2_compatibility */
        if (version[0] * 10 + version[1] < 32 && !desktop) break;
        for (int i = 0, bad = 0; i < texts && bad < 3; ++i) {
            if ((spoken[i].desc.dialect >= SSGI_GL_300ES) != es) continue;
            bad += !compiles(&spoken[i].desc, spoken[i].stage);
            ++tried;
        }
        t_note("%d texts in %.0f s: %s", tried, kit_seconds() - began, kit_gl_name());
    }
    if (!has) return;
    pthread_join(thread, NULL);
    CHECK(!glslang.problem[0], "glslangValidator: %s", glslang.problem);
    t_note("%d texts and programs, %d of these linked: glslangValidator", glslang.texts, glslang.linked);
    snprintf(line, sizeof line, "rm -rf '%s'", folder);
    CHECK(!system(line), "%s", line);
}

/* ---- >>law: snprintf's ------------------------------------------------------------------------------------------- */

/* Text number k: all stages of some descs, then the functions of harmonics and of fields alone. */
static size_t any_text(int k, char *out, size_t capacity)
{
    static const ssgi_gl_desc descs[] = { { .samples = 3 },
        { .pass = SSGI_GL_SSDO, .dialect = SSGI_GL_320ES, .samples = 2, .environment = SSGI_GL_ENVIRONMENT_SH, .bounce = SSGI_GL_BOUNCE_PATCH, .views = 1 },
        { .pass = SSGI_GL_HSAO, .thin = 1, .dialect = SSGI_GL_310ES, .lines = 1 },
        { .pass = SSGI_GL_HSAO, .search = SSGI_GL_MARCH, .normal_rays = 2, .noise = SSGI_GL_NOISE_TEXTURE, .version = "#version 430", .fetch = "// mine" },
        { .pass = SSGI_GL_SHADE, .lamps = 1, .packed = 1, .transfer = SSGI_GL_TRANSFER_BOTH },
        { .pass = SSGI_GL_FIELD, .measure = SSGI_FIELD_SOLID_ANGLE, .cap = SSGI_GL_CAP_TABLE, .objects = SSGI_GL_OBJECTS_TEXTURE, .lines = 1 },
        { .pass = SSGI_GL_SPLAT, .dialect = SSGI_GL_320ES, .tessellate = 1, .sends = SSGI_GL_SENDS_CUSTOM, .effect = SSGI_GL_EFFECT_BOUNCE, .fetch = "// mine" } };
    const int stages = (int)(sizeof descs / sizeof descs[0]) * SSGI_GL_STAGES;
    if (k == stages) return ssgi_gl_field(out, capacity, &descs[5]);
    return k < stages ? ssgi_gl_emit(out, capacity, &descs[k / SSGI_GL_STAGES], k % SSGI_GL_STAGES) : ssgi_gl_sh(out, capacity, k - stages);
}

static void law(void)
{
    static char full[TEXT], part[TEXT], clean[TEXT];
    const ssgi_gl_desc fine = { 0 }, bad = { .steps = 65 };
    size_t n;
    int there = 0;
    memset(clean, 0x5a, sizeof clean);
    memcpy(part, clean, sizeof part);
    for (int k = 0; k < 7 * SSGI_GL_STAGES + 5; ++k, there += n > 0) {
        n = any_text(k, NULL, 0);
        CHECK(any_text(k, full, TEXT) == n && strlen(full) == n, "text %d: the length asked for with NULL differs", k);
        for (size_t capacity = 0; capacity <= n + 1; capacity += capacity < 300 || capacity + 300 > n ? 1 : 37) {
            size_t got = any_text(k, part, capacity), used = capacity > n ? n + 1 : capacity;
            int right = got == n && (!used || (!memcmp(part, full, used - 1) && !part[used - 1])) && !memcmp(part + used, clean, n + 64 - used);
            if (!CHECK(right, "text %d, capacity %zu of %zu: length %zu, or wrong bytes in or beyond it", k, capacity, n, got)) return;
            memcpy(part, clean, used);
        }
    }
    CHECK(there == 6 * 2 + 5 + 1 + 4, "%d texts", there);   /* stages that passes lack give none */
    CHECK(!ssgi_gl_emit(part, TEXT, &bad, 0) && !ssgi_gl_emit(part, TEXT, NULL, 0) && !ssgi_gl_emit(part, TEXT, &fine, -1) && !ssgi_gl_emit(part, TEXT, &fine, SSGI_GL_STAGES)
          && !ssgi_gl_emit(NULL, 1, &fine, 0) && !ssgi_gl_sh(part, TEXT, 0) && !ssgi_gl_sh(part, TEXT, -1) && !ssgi_gl_sh(part, TEXT, 5) && !ssgi_gl_sh(NULL, 1, 4)
          && !ssgi_gl_field(part, TEXT, &bad) && !ssgi_gl_field(part, TEXT, NULL) && !ssgi_gl_field(NULL, 1, &fine) && !memcmp(part, clean, TEXT),
          "a bad desc, stage or number of bands gave text");
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

/* std140, counted here anew: a type's bytes, and what it is aligned to. */
static size_t std140(const char *type, size_t *align)
{
    const char *array = strchr(type, '[');
    const size_t word = strncmp(type, "float", 5) && strncmp(type, "int", 3) ? strcmp(type, "ivec2") && strcmp(type, "vec2") ? 16 : 8 : 4;
    const size_t one = !strncmp(type, "mat3", 4) ? 48 : !strncmp(type, "mat4", 4) ? 64 : word;
    *align = array ? 16 : word;
    return array ? (one + 15) / 16 * 16 * (size_t)atoi(array + 1) : one;
}

/* Reads the declarations back from a stage's text, line by line, and compares them with the rows, in their order where one stage has them all. Returns which of
   them are there: a bit each. */
static uint64_t compare_rows(const char *text, const ssgi_gl_desc *d, const ssgi_gl_io *row, int rows)
{
    const char *end = strstr(text, "\n\n"), *line = strchr(text, '\n') + 1, *outside = "uniform \0layout(binding\0layout(std140\0layout(location\0const int \0out vec4 o_\0in vec4 a_\0";
    int es = d->dialect >= SSGI_GL_300ES, bindings = d->dialect == SSGI_GL_450 || d->dialect >= SSGI_GL_310ES, block = -1, last = -1, precisions = 0, samplers = 0;
    uint64_t found = 0;
    size_t offset = 0;
    if (!CHECK(end, "%s: no end of the declarations", describe(d))) return 0;
    for (; line < end; line = strchr(line, '\n') + 1) {
        ssgi_gl_io io = { NULL, -1, "int", 0, 0, "" };
        char name[64] = "", type[32] = "", format[300] = "", begin[80] = "";
        int opened = -1;
        for (int b = 0; b < 2; ++b) {
            snprintf(begin, sizeof begin, "layout(std140%s%s) uniform ssgi_%s {\n", bindings ? ", binding = " : "", !bindings ? "" : b ? "1" : "0", b ? "views" : "frame");
            if (!strncmp(line, begin, strlen(begin))) opened = b;
        }
        if (opened > last && block < 0) { block = last = opened; offset = 0; continue; }
        if (es && !strncmp(line, "precision highp ", 16)) { ++precisions; continue; }
        if (!strncmp(line, "};", 2)) { block = -1; continue; }
        if (block >= 0 && sscanf(line, "    %31s %63[^;]; // %299[^\n]", type, name, format) >= 2) {
            const char *array = strchr(name, '[');
            size_t align, size;
            if (!strncmp(name, "u_ssgi_gap", 10) && array) strcat(type, array);
            size = std140(type, &align);
            offset = (offset + align - 1) / align * align;
            io.kind = SSGI_GL_PARAM;
            io.slot = block;
            io.offset = offset;
            offset += size;
            if (!strncmp(name, "u_ssgi_gap", 10)) continue;
        } else if (sscanf(line, "const int %63s = %d;", name, &io.slot) == 2) {
            io.kind = SSGI_GL_CONSTANT;
            strcpy(type, "int");
        } else if (sscanf(line, "layout(location = %d) %9s %31s %63[^;]; // %299[^\n]", &io.slot, begin, type, name, format) == 5) io.kind = strcmp(begin, "in") ? SSGI_GL_OUTPUT : SSGI_GL_ATTRIBUTE;
        else if (sscanf(line, "out %31s %63[^;]; // %299[^\n]", type, name, format) == 3) {
            if (d->pass == SSGI_GL_SPLAT) continue;        /* it goes to the next stage, nothing keeps it */
            io.kind = SSGI_GL_CAPTURE;
        }
        else if (bindings ? sscanf(line, "layout(binding = %d) uniform %31s %63[^;]; // %299[^\n]", &io.slot, type, name, format) == 4
                          : sscanf(line, "%63s %31s %63[^;]; // %299[^\n]", begin, type, name, format) == 4 && !strcmp(begin, "uniform")) io.kind = SSGI_GL_TEXTURE;
        if (io.kind == SSGI_GL_TEXTURE) samplers |= strstr(type, "Cube") ? 16 : 1 << (2 * (*type == 'u') + (strstr(type, "Array") != NULL));
        int at = 0;
        while (at < rows && (found >> at & 1 || (has_vertices(d) && strcmp(row[at].name, name)))) ++at;
        int same = at < rows && row[at].kind == io.kind && !strcmp(row[at].name, name) && !strcmp(row[at].type, type) && !strcmp(row[at].format, format)
                   && row[at].offset == io.offset && (row[at].slot == io.slot || (io.kind == SSGI_GL_TEXTURE && !bindings) || io.kind == SSGI_GL_CAPTURE);
        if (!CHECK(same, "%s: \"%.*s\" is not row %d, %s", describe(d), (int)strcspn(line, "\n"), line, at, at < rows ? row[at].name : "none")) return 0;
        found |= (uint64_t)1 << at;
    }
    for (const char *w = outside; *w; w += strlen(w) + 1) {
        char start[16] = "\n";
        CHECK(!strstr(end, strcat(start, w)), "%s: a declaration after the declarations: %s", describe(d), w);
    }
    const int kinds = (samplers & 1) + (samplers >> 1 & 1) + (samplers >> 2 & 1) + (samplers >> 3 & 1) + (samplers >> 4);
    CHECK(precisions == (es ? 2 + kinds : 0), "%s: %d precisions, %d kinds of samplers", describe(d), precisions, kinds);
    return found;
}

/* What GL says of a linked program: places in the block, bindings without a call, every texture is read. */
static int ask_gl(const ssgi_gl_desc *d, const ssgi_gl_io *row, int rows)
{
    static const struct { const char *name; size_t most; } blocks[] = { { "ssgi_frame", sizeof(ssgi_gl_frame) }, { "ssgi_views", sizeof(ssgi_gl_views) } };
    GLuint program = linked(d, NULL);
    if (!program) return 0;
    for (int b = 0; b < 2; ++b) {
        const GLuint block = glGetUniformBlockIndex(program, blocks[b].name);
        GLint size = 0, binding = -1;
        int wanted = 0;
        for (int i = 0; i < rows; ++i) wanted |= row[i].kind == SSGI_GL_PARAM && row[i].slot == b;
        CHECK((block != GL_INVALID_INDEX) == wanted, "%s: %s is %s", describe(d), blocks[b].name, wanted ? "missing" : "there");
        if (block == GL_INVALID_INDEX) continue;
        glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
        glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_BINDING, &binding);
        CHECK(binding == b && size > 0 && (size_t)size <= blocks[b].most, "%s: %s of %d bytes at %d", describe(d), blocks[b].name, size, binding);
    }
    for (int i = 0; i < rows; ++i) {
        GLuint index = GL_INVALID_INDEX;
        GLint value = -1, want = row[i].slot;
        if (row[i].kind == SSGI_GL_CONSTANT || row[i].kind == SSGI_GL_ATTRIBUTE || row[i].kind == SSGI_GL_CAPTURE) continue;
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
    static char text[SSGI_GL_STAGES][TEXT];
    static uint64_t seen[1 << 12];
    ssgi_gl_io row[SSGI_GL_MAX_IO], read[SSGI_GL_MAX_IO], few[2];
    int asked = 0, pairs = 0, read_back = 0;
    for (int i = 0; i < variants * SSGI_GL_DIALECTS; ++i) {
        ssgi_gl_desc d = variant[i / SSGI_GL_DIALECTS];
        d.dialect = i % SSGI_GL_DIALECTS;
        if (ssgi_gl_check(&d, NULL) != SSGI_OK) continue;  /* no tessellation there */
        const int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO), before = pairs;
        uint64_t params = 0, once = 0, twice = 0;
        for (int k = 0, slots[SSGI_GL_CAPTURE + 1] = { 0 }; k < rows; ++k) {
            params |= (uint64_t)(row[k].kind == SSGI_GL_PARAM) << k;
            CHECK(row[k].kind == SSGI_GL_PARAM || row[k].kind == SSGI_GL_CONSTANT || row[k].slot == slots[row[k].kind], "%s: %s is at %d, not at %d", describe(&d), row[k].name, row[k].slot, slots[row[k].kind]);
            ++slots[row[k].kind];
        }
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {     /* the stages have whole blocks in common, and nothing else */
            if (!*emit(text[stage], &d, stage)) continue;
            const uint64_t found = compare_rows(text[stage], &d, row, rows), all = ssgi_gl__find(&d)->rows[stage][0] ? params : 0;
            if (!CHECK((found & params) == all, "%s, stage %d: of the blocks' members it declares %" PRIx64 ", not %" PRIx64, describe(&d), stage, found & params, all)) break;
            twice |= once & found & ~params;
            once |= found;
            ++read_back;
        }
        if (!CHECK(once == ((uint64_t)1 << rows) - 1 && !twice, "%s: of %d rows the stages declare %" PRIx64 ", twice %" PRIx64, describe(&d), rows, once, twice)) break;
        if (d.dialect != SSGI_GL_450 || !desktop) continue;
        uint64_t last = (uint64_t)d.pass;
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage)
            for (const char *line = *text[stage] ? strchr(text[stage], '\n') + 1 : "\n"; *line != '\n'; line += strcspn(line, "\n") + 1) {     /* GL is asked where two lines are together first */
                uint64_t two = last * 31;
                int s = 0;
                last = 14695981039346656037u;
                for (size_t k = 0; k < strcspn(line, "\n"); ++k) last = (last ^ (uint64_t)line[k]) * 1099511628211u;
                two ^= last;
                while (s < pairs && seen[s] != two) ++s;
                if (s == pairs && CHECK(pairs < 1 << 12, "too many pairs of lines")) seen[pairs++] = two;
            }
        if (pairs == before) continue;
        ++asked;
        if (!ask_gl(&d, row, rows)) break;
        few[1] = row[3];
        CHECK(ssgi_gl_reflect(&d, few, 1) == rows && few[0].name == row[0].name && few[1].name == row[3].name, "more rows than there is room for");
    }
    t_note("%d texts read back, %d linked for %d different pairs of lines", read_back, asked, pairs);
    for (int k = 0; k < 4 * 2 * 3; ++k) {                  /* what s3ho writes is what blur reads, in order, name, type and format */
        ssgi_gl_desc d = { .pass = SSGI_GL_S3HO, .bands = 1 + k % 4, .packed = k / 4 % 2, .transfer = k / 8 }, blur = d;
        blur.pass = SSGI_GL_BLUR;
        blur.colour = SSGI_GL_VECTORS;
        const int targets = d.packed ? (d.transfer ? 3 : 1) * (d.bands > 2 ? 2 : 1) : d.bands < 3 ? 1 : d.bands;
        const int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO), reads = ssgi_gl_reflect(&blur, read, SSGI_GL_MAX_IO);
        int written = 0, found = 0;
        for (int i = 0, b = 0; i < rows; ++i) {
            if (row[i].kind != SSGI_GL_OUTPUT) continue;
            while (b < reads && strcmp(read[b].name + 1, row[i].name + 1)) ++b;
            found += b < reads && read[b].kind == SSGI_GL_TEXTURE && !strcmp(read[b].format, row[i].format) && !strcmp(read[b].type, d.packed ? "usampler2D" : "sampler2D")
                     && !strcmp(row[i].type, d.packed ? "uvec4" : "vec4") && row[i].slot == written;
            ++written;
        }
        CHECK(d.transfer && !d.packed ? !rows && !reads : written == targets && found == targets, "%d bands, packed %d, transfer %d: %d targets, %d of them read", d.bands,
              d.packed, d.transfer, written, found);
    }
    emit(text[0], variant, SSGI_GL_VERTEX);
    CHECK(!strstr(text[0], "ssgi") && !strstr(text[0], "uniform") && !strstr(text[0], "layout"), "the vertex stage declares something");
    CHECK(!ssgi_gl_reflect(NULL, row, 1) && !ssgi_gl_reflect(variant, NULL, 1) && ssgi_gl_reflect(variant, NULL, 0) > 0, "reflection of nothing");
}

/* ---- >>off: what is off leaves nothing ---------------------------------------------------------------------------- */

static void off(void)
{
    static char text[TEXT];
    for (int v = 0; v < variants; ++v) {
        ssgi_gl_desc copy = variant[v], *d = &copy;
        d->lines = v & 1;
        d->dialect = v % SSGI_GL_DIALECTS;
        if (ssgi_gl_check(d, NULL) != SSGI_OK) d->dialect = SSGI_GL_320ES;
        int ssao = d->pass == SSGI_GL_SSAO, hsao = d->pass == SSGI_GL_HSAO, ssdo = d->pass == SSGI_GL_SSDO, lights = d->pass == SSGI_GL_LIGHTS, senders = d->pass == SSGI_GL_SENDERS;
        int s3ho = d->pass == SSGI_GL_S3HO, shade = d->pass == SSGI_GL_SHADE, field = d->pass == SSGI_GL_FIELD, atlas = field && !d->storage, closed_cap = field && !d->cap;
        int blur = d->pass == SSGI_GL_BLUR, survey = d->pass == SSGI_GL_SURVEY, march = hsao && d->search == SSGI_GL_MARCH, slices = hsao && !march, points = ssao || ssdo || s3ho, ortho = d->orthographic;
        int grey = blur && d->colour == SSGI_GL_GREY, colour = blur && d->colour == SSGI_GL_COLOUR, vectors = blur && !grey && !colour;
        int sh = ssdo && d->environment == SSGI_GL_ENVIRONMENT_SH, light = sh || (s3ho && d->shaded) || (shade && !d->shading), exact = light && d->exact && (sh || d->transfer != SSGI_GL_TRANSFER_REFLECTED);
        int surfels = d->pass == SSGI_GL_SURFELS, shuffle = d->pass == SSGI_GL_SHUFFLE, splat = d->pass == SSGI_GL_SPLAT, unshuffle = d->pass == SSGI_GL_UNSHUFFLE, smooth = d->pass == SSGI_GL_SMOOTH;
        int sum = d->pass == SSGI_GL_SUM, made = surfels || splat, placed = shuffle || smooth, dealt = shuffle || unshuffle, levels = splat || unshuffle || smooth, deep_space = made || placed || unshuffle || sum;
        int patches = made && d->tessellate, buffer = made && !patches, sends = surfels || (patches && d->effect > SSGI_GL_EFFECT_LIGHT), sunlit = sends && d->sends == SSGI_GL_SENDS_LIGHTS, skylit = sunlit && d->environment;
        int effect = levels || sum ? d->effect : -1, form = effect >= 0 && effect != SSGI_GL_EFFECT_SCATTER, hides = effect == SSGI_GL_EFFECT_LIGHT;
        int rays = march && d->normal_rays, box = blur && d->filter == SSGI_GL_BILATERAL, normals = blur ? box : deep_space ? placed || (sum && hides) : !shade || exact;
        int from_depth = normals && d->normal == SSGI_GL_NORMAL_FROM_DEPTH, depth = deep_space ? placed || sum : !blur || d->half || from_depth || vectors, map = normals && d->normal < SSGI_GL_NORMAL_FROM_DEPTH, window = depth && d->depth == SSGI_GL_DEPTH_WINDOW;
        int fill = d->shadow == SSGI_GL_SHADOW_FILL, maps = (lights || sunlit) && (d->shadow == SSGI_GL_SHADOW_MAP || fill), segments = lights && (d->shadow == SSGI_GL_SHADOW_SEGMENT || fill);
        int tested = points || rays || segments, projected = points || march || segments || survey, noise = hsao || tested || survey;
        int reflected = s3ho && d->transfer, bounce = (ssdo && d->bounce) || reflected, areas = ssdo && d->bounce > SSGI_GL_BOUNCE_SOLID_ANGLE;
        int facing = areas || (bounce && !d->two_sided), env = (ssdo && d->environment == SSGI_GL_ENVIRONMENT_MAP) || (splat && hides);
        int views = tested && d->views, deep = views || (tested && d->layers > 1), textures = tested && !bounce, hidden = d->receiver && (ssdo || lights || senders);
        int layers = hidden || (textures && d->layers > 1), range = points && d->range, faded = range || (points && d->fade), half = d->half && !lights && !senders && !field && !deep_space && !survey;
        int toward = slices || from_depth || (splat && effect == SSGI_GL_EFFECT_SPECULAR);
        int custom = d->depth == SSGI_GL_DEPTH_CUSTOM, bent = shade && d->shading == SSGI_GL_SHADING_BENT, cone = shade && d->shading == SSGI_GL_SHADING_BENT_CONE;
        int open = (env && !splat) || cone || exact || (shade && d->shading == SSGI_GL_SHADING_BENT_NORMAL) || skylit || (sum && hides), lamps = shade && !bent && d->lamps;
        int albedo = senders ? d->radiance != SSGI_GL_RADIANCE_DIRECT : shade && !bent && d->albedo;
        int lit = senders && (d->radiance == SSGI_GL_RADIANCE_LIGHT || d->radiance == SSGI_GL_RADIANCE_BOTH), direct = senders && d->radiance % 3;
        int reads = shade || vectors, writes = vectors || (s3ho && !d->shaded), kept = reads || writes, sums = sh || s3ho;
        int turned = sh || (s3ho && d->transfer != SSGI_GL_TRANSFER_REFLECTED), lobes = sums || lamps || (vectors && half), any = kept || sums, three = any && d->transfer && !sh;
        int bands = !any ? 0 : shade && d->shading && !lamps && d->bands > 2 ? 2 : d->bands, packed = kept && d->packed, words = kept && !packed, one = packed && !three;
        int native = d->dialect == SSGI_GL_450 || d->dialect >= SSGI_GL_300ES;
        const struct { const char *word; int wanted; } table[] = {
            { "#line", d->lines }, { "SSGI_KERNEL", points && !d->kernel }, { "t_ssgi_kernel", points && d->kernel }, { "SSGI_SAMPLES", points || segments || survey }, { "o_ssgi_survey", survey },
            { "SSGI_STEPS", hsao || (points && d->steps > 1) }, { "SSGI_DIRECTIONS", hsao }, { "SSGI_FILTER_RADIUS", blur }, { "SSGI_LAYERS", deep },
            { "SSGI_VIEWS", views }, { "SSGI_VIEW_LAYERS", views }, { "SSGI_RECEIVER", hidden }, { "SSGI_NORMAL_RAYS", rays }, { "ssgi_ray(", rays },
            { "ssgi_above(", rays }, { "ssgi_horizon(", march }, { "ssgi_attenuation(", march }, { "max(1.0 - d / u_ssgi_radius", march && !d->hard },
            { "d < u_ssgi_radius ?", march && d->hard }, { "ssgi_arc(", slices }, { "ssgi_screen(", slices }, { "vec2 last", slices && !d->hard },
            { "vec3 back", slices && d->thin }, { "u_ssgi_thickness", d->thin && (slices || tested) }, { "ssgi_thickness(", d->thin && tested },
            { "ssgi_reach", d->thin && segments }, { "ssgi_blocked(", tested }, { "ssgi_lift(", projected }, { "u_ssgi_offset", projected },
            { "u_ssgi_radius", projected || slices || box || splat || patches }, { "ssgi_noise(", noise }, { "u_ssgi_phase", noise },
            { "t_ssgi_noise", noise && d->noise == SSGI_GL_NOISE_TEXTURE }, { "52.9829189", noise && d->noise == SSGI_GL_NOISE_GRADIENT },
            { "& 3", noise && d->noise == SSGI_GL_NOISE_TILE4 }, { "ssgi_length(", points }, { "return xi;", points && d->falloff == SSGI_GL_FALLOFF_LINEAR },
            { "sqrt(xi)", points && d->falloff == SSGI_GL_FALLOFF_SQUARE }, { "pow(xi", points && d->falloff == SSGI_GL_FALLOFF_CUBE }, { "ssgi_faded(", faded },
            { "u_ssgi_fade", points && d->fade == SSGI_GL_FADE_SMOOTH }, { "smoothstep(", field || (points && d->fade == SSGI_GL_FADE_SMOOTH) },
            { "u_ssgi_lambda", points && d->fade >= SSGI_GL_FADE_LAMBDA }, { "weight -= t;", points && d->fade == SSGI_GL_FADE_LAMBDA_ENDED },
            { "if (t > 1.0", range }, { "ssgi_matter(", deep }, { "ssgi_surface(", deep && textures }, { "ssgi_view_layer(", views && textures },
            { "ssgi_layer(", layers }, { "t_ssgi_layers", layers && !custom }, { "t_ssgi_views", views && textures }, { "u_ssgi_view_to", views },
            { "u_ssgi_view_from", views && (faded || bounce) }, { "u_ssgi_view_decode", views }, { "u_ssgi_view_size", views }, { "t_ssgi_senders", bounce },
            { "t_ssgi_view_senders", bounce && views }, { "ssgi_sent(", bounce }, { "ssgi_held(", bounce }, { "ssgi_sender", bounce },
            { "ssgi_offer(", bounce && deep }, { "ssgi_sender_place", reflected }, { "ssgi_point(", faded || bounce }, { "ssgi_unpack_radiance(", bounce },
            { "ssgi_unpack_depth(", bounce }, { "ssgi_unpack_normal(", facing || reflected }, { "ssgi_P", faded || facing || (bounce && deep) },
            { "ssgi_way", bounce && deep }, { "ssgi_n", areas || range }, { "u_ssgi_nearest", bounce && d->bounce == SSGI_GL_BOUNCE_PATCH && ssdo },
            { "u_ssgi_gain", areas }, { "c = abs(c)", areas && d->two_sided }, { "o = -o", reflected && d->two_sided }, { "o_ssgi_bounce", (bounce && ssdo) || (sum && effect == SSGI_GL_EFFECT_BOUNCE) },
            { "area / float(SSGI_SAMPLES)", ssdo && d->bounce == SSGI_GL_BOUNCE_DISC }, { "ssgi_pack_radiance(", senders }, { "ssgi_pack_place(", senders },
            { "ssgi_octahedral(", senders || open || env || shuffle }, { "t_ssgi_environment", env }, { "t_ssgi_irradiance", open }, { "ssgi_environment(", env },
            { "ssgi_open(", open }, { "t_ssgi_irradiance, 0).z", cone }, { "t_ssgi_lights", lights || lamps || sunlit }, { "u_ssgi_lights", lights || lamps || sunlit },
            { "t_ssgi_shadow", maps }, { "ssgi_shadow(", maps }, { "u_ssgi_steepest", maps }, { "ssgi_segment(", segments },
            { "min(reach, max(bias", maps && segments }, { "t_ssgi_light", colour || (lights && d->accumulate) || lit }, { "t_ssgi_albedo", albedo },
            { "t_ssgi_direct", direct }, { "o_ssgi_light", lights || colour || light || (env && ssdo) || (shade && !bent) || (sum && hides) }, { "o_ssgi_sender", senders }, { "u_ssgi_target / 2", half },
            { "p *= 2", half && !blur && !shade }, { "h * 2", half && blur }, { "ssgi_off_plane(", box || smooth }, { "exp(", (blur && !box) || (splat && !form) || (sum && form && !d->overlap) },
            { "dot(n, ssgi_normal(q", box && d->filter_normals }, { "tent", box && half }, { "t_ssgi_ao", grey }, { "vec2 o_ssgi_ao", ssao || hsao || (sum && !effect) },
            { "float o_ssgi_ao", grey || field }, { "u_ssgi_decode", window }, { "ssgi_decode(", window },
            { "sampler2D t_ssgi_depth", depth && !custom && (textures || !hidden) }, { "ssgi_custom_depth(p +", depth && custom },
            { "ssgi_depth(", depth && (!hidden || (textures && !custom)) }, { "t_ssgi_normal", map }, { "ssgi_unit(", normals },
            { "ssgi_custom_normal(p +", normals && d->normal == SSGI_GL_NORMAL_CUSTOM }, { "ssgi_tangent(", from_depth },
            { "xyz * 2.0", normals && d->normal == SSGI_GL_NORMAL_UNSIGNED }, { "1.0 - abs(e.x)", (normals && d->normal == SSGI_GL_NORMAL_OCTAHEDRAL) || (splat && form) },
            { "u_ssgi_rotation", (normals && d->world_normals) || open || env }, { "ssgi_toward(", toward }, { "ssgi_project(", projected },
            { "ssgi_inside(", blur || hsao || survey || tested || from_depth || placed }, { "u_ssgi_size", field || blur || hsao || survey || tested || from_depth || placed || splat || patches || unshuffle },
            { "ssgi_position(", deep_space ? normals : !shade || lamps || exact },
            { "(u_ssgi_project.xy / -P.z)", (projected || slices) && !ortho }, { "-inversesqrt(dot(P, P))", toward && !ortho },
            { "SSGI_FAR ? 1.0 / w", window && !ortho },
            /* vectors: how many bands, how many of them, how they are stored, what light they meet */
            { "ssgi_sh", any }, { ".b", bands > 2 }, { ".d", bands > 3 }, { "n.yzx", lobes && bands > 1 }, { "0.54627422", lobes && bands > 2 },
            { "0.59004359", lobes && bands > 3 }, { "zonal.xyyy", lobes }, { "vec4 SSGI_COSINE", sums || (lamps && exact) }, { "ssgi_lacking", exact },
            { "ssgi_free(", exact }, { "dot(n, l), 0.0) -", lamps && exact }, { "ssgi_sh_add(", sums || vectors }, { "ssgi_sh_dot(", lamps }, { "ssgi_sh_turn(", turned },
            { "R * s", turned && bands > 1 }, { "ssgi_sh_about_z(", turned && bands > 2 }, { "ssgi_sh_quarter(", turned && bands > 2 },
            { "0.79056942", turned && bands > 3 }, { "0.86602540", turned && bands > 2 }, { "ssgi_sh c[1]", any && !three }, { "ssgi_sh c[3]", three },
            { "ssgi_load(", reads }, { "ssgi_store(", writes }, { "ssgi_pack_half(", packed && writes }, { "packHalf2x16(", packed && writes && native },
            { "floatBitsToUint(clamp(v", packed && writes && !native }, { "ssgi_unpack_half(", packed && reads }, { "unpackHalf2x16(", packed && reads && native },
            { "5.9604645e-8", packed && reads && !native }, { "sampler2D t_ssgi_sh0", reads && words }, { "usampler2D t_ssgi_sh0", reads && one },
            { "usampler2D t_ssgi_red0", reads && packed && three }, { "t_ssgi_sh1", reads && !three && bands > 2 }, { "t_ssgi_sh3", reads && words && bands > 3 },
            { "t_ssgi_blue1", reads && three && bands > 2 }, { "out vec4 o_ssgi_sh0", writes && words }, { "out uvec4 o_ssgi_sh0", writes && one },
            { "out uvec4 o_ssgi_red0", writes && packed && three }, { "o_ssgi_sh1", writes && !three && bands > 2 }, { "o_ssgi_sh3", writes && words && bands > 3 },
            { "o_ssgi_blue1", writes && three && bands > 2 }, { "u_ssgi_harmonics", light }, { "u_ssgi_harmonics[6", light && bands > 2 },
            { "u_ssgi_harmonics[9", light && bands > 3 }, { "u_ssgi_window", lamps }, { "0.5 * w.y", lamps && bands > 1 }, { "0.3125 * w.z", lamps && bands > 2 },
            { "ssgi_bent(", shade && d->shading }, { "o_ssgi_bent", bent },
            /* fields: how they are kept, how a cap becomes occlusion, whom a pixel belongs to; the vertex stage */
            { "v_ssgi_caster", field }, { "t_ssgi_casters", field }, { "ssgi_field_occlusion(", field }, { "smoothstep(caster[3].x, caster[3].y, at.w)", field },
            { "t_ssgi_fields", atlas }, { "1.0 / 65535.0", atlas && !d->eight_bits }, { "1.0 / 255.0", atlas && d->eight_bits }, { "t_ssgi_field", field && !atlas },
            { "t_ssgi_field_centre", field && !atlas }, { "fill", field && !d->measure }, { "0.0795774715", field && d->measure }, { "ssgi_cap(", closed_cap },
            { "ssgi_cap_any(", field && (d->cap || d->measure) }, { "abs(1.0 - h)", closed_cap && d->measure }, { "t_ssgi_cap", field && d->cap }, { "ssgi_object(", field && d->objects },
            { "t_ssgi_objects", field && d->objects == SSGI_GL_OBJECTS_TEXTURE }, { "ssgi_custom_object(p +", field && d->objects == SSGI_GL_OBJECTS_CUSTOM },
            { "vec4(from, to)", (field || splat) && !ortho }, { "at.w - at.z <= u_ssgi_front", (field || splat) && ortho }, { "u_ssgi_front", field || splat },
            /* deep screen space: where surfels come from, what they send, how pixels are dealt out, what surfels do to them */
            { "a_ssgi_position", patches }, { "a_ssgi_surfel0", buffer }, { "v_ssgi_surfel0", surfels || patches }, { "u_ssgi_mesh", patches }, { "u_ssgi_surfel", patches }, { "u_ssgi_more", patches },
            { "ssgi_hash(", patches }, { "low * low", patches && !ortho }, { "min(a, b) - P.xy", patches && ortho }, { "point_mode", patches }, { "v_ssgi_patch", patches },
            { "EmitVertex()", splat && patches }, { "gl_VertexID % 6", splat && buffer }, { "ssgi_surfel_light(", sunlit }, { "colour.xyz * g", lights || sunlit }, { "ssgi_custom_surfel(P", sends && d->sends == SSGI_GL_SENDS_CUSTOM },
            { "as if nothing stood before it", skylit }, { "ssgi_deal(", dealt }, { "2891336453u", patches || (dealt && !d->fixed) }, { "ivec2(0);", dealt && d->fixed }, { "o_ssgi_shuffled", shuffle },
            { "t_ssgi_shuffled", splat }, { "u_ssgi_level", shuffle || levels || sum }, { "t_ssgi_levels", unshuffle || smooth || sum }, { "float o_ssgi_levels", levels && !effect },
            { "vec4 o_ssgi_levels", levels && effect }, { "SSGI_LEVELS", splat || sum }, { "SSGI_AXIS", smooth }, { "dot(n, ssgi_normal(p", smooth && d->filter_normals }, { "u_ssgi_epsilon", splat },
            { "ssgi_shell(", splat }, { "most / u_ssgi_epsilon", splat && effect > SSGI_GL_EFFECT_LIGHT }, { "at.w * at.w * block", splat && d->enlarge }, { "vec4(turned.xyz, block", splat && !d->enlarge },
            { "v_ssgi_at.w, form", form && splat }, { "float form", form && sum }, { "fronts alone", form && splat && !d->two_sided }, { "away = abs(away)", form && splat && d->two_sided }, { "SSGI_NEAR", form && splat && d->closely > 1 }, { "form *= max", splat && !effect && !d->hard }, { "form * vec4(v_ssgi_sent", splat && effect == SSGI_GL_EFFECT_BOUNCE }, { "u_ssgi_exponent", splat && effect == SSGI_GL_EFFECT_SPECULAR },
            { "u_ssgi_dipole", splat && !form }, { "ssgi_once(", sum && form }, { "1.0 / max(form", sum && form && d->overlap }, { "o_ssgi_specular", sum && effect == SSGI_GL_EFFECT_SPECULAR },
            { "o_ssgi_scatter", sum && !form } };
        source_of(text, d, PROGRAM);
        for (size_t i = 0; i < sizeof table / sizeof table[0]; ++i)
            CHECK((count(text, table[i].word) > 0) == (table[i].wanted != 0), "%s: \"%s\" is %s", describe(d), table[i].word, table[i].wanted ? "missing" : "there");
    }
}

/* ---- >>names: of all variants, not only those that are compiled ----------------------------------------------------- */

typedef struct names { uint64_t bit[4]; } names;
typedef struct part { uint64_t need; int stage; names defines, uses; } part;      /* a row or a chunk */
static char known[256][32];
static int  knowns;

static void name_add(names *set_, const char *word, size_t n)
{
    int i = 0;
    while (i < knowns && !(strlen(known[i]) == n && !memcmp(known[i], word, n))) ++i;
    if (i == knowns && CHECK(knowns < 256 && n < sizeof known[0], "more names than this test has room for")) memcpy(known[knowns++], word, n);
    set_->bit[i / 64 & 3] |= (uint64_t)1 << i % 64;
}

static int name_in(const names *set_, int i) { return (int)(set_->bit[i / 64] >> i % 64 & 1); }

/* What a chunk defines: our words on lines that begin at global scope. What it uses: the others, types too, without comments. Variables: their value,
   "ssgi_P =", is defined where they are written and used where they are read. */
static void read_names(part *p, const char *text)
{
    for (const char *line = text; *line; line += strcspn(line, "\n") + 1) {
        const size_t comment = strstr(line, "//") ? (size_t)(strstr(line, "//") - line) : SIZE_MAX, end = comment < strcspn(line, "\n") ? comment : strcspn(line, "\n");
        for (size_t i = 0, n = 0; i < end; i += n ? n : 1, n = 0) {
            const char *word = line + i, *after;
            char value[40];
            while (PART(word[n])) ++n;
            const char *stem = n > 2 && word[1] == '_' ? word + 2 : word;
            if (n < 6 || (strncmp(stem, "ssgi_", 5) && strncmp(stem, "SSGI_", 5)) || !strncmp(word, "ssgi_custom_", 12)) continue;
            after = word + n;
            if (*after == '.') after += 1 + strspn(after + 1, "xyzw");
            const int type = *after == ' ' && isalpha((unsigned char)after[1]), global = isalpha((unsigned char)*line) && !type;
            const int variable = *word == 's' && *after != '(' && !type && !global, written = variable && !strncmp(after, " = ", 3);
            snprintf(value, sizeof value, "%.*s =", (int)n, word);
            if (!variable || written) name_add(global ? &p->defines : &p->uses, word, n);
            if (variable) name_add(written ? &p->defines : &p->uses, value, n + 2);
        }
    }
}

static ssgi_gl__set features_of(const ssgi_gl_desc *d) { const ssgi_gl_desc whole = ssgi_gl__resolve(d); return ssgi_gl__features(&whole); }

/* For each name, all combinations of the choices that its parts depend on, the others at random: it is there if and only if it is used. */
static void closed(void)
{
    enum { DRAWN = 1000 };
    static part parts[SSGI_GL_MAX_IO * SSGI_GL_STAGES + 200];
    int tried = 0;
    random_state = 3;
    for (int t = 0; t < SSGI_GL__ROWS; ++t) {
        ssgi_gl__set moved[CHOICES];                       /* the features that a choice changes in any of many descs */
        int many = 0;
        memset(moved, 0, sizeof moved);
        memset(parts, 0, sizeof parts);
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
            for (const ssgi_gl__row *const *r = ssgi_gl__passes[t].rows[stage]; r && *r; ++r) {
                parts[many].need = (*r)->need;
                parts[many].stage = 1 << stage;
                name_add(&parts[many++].defines, (*r)->io.name, strlen((*r)->io.name));
            }
            for (const ssgi_gl__chunk *const *c = ssgi_gl__passes[t].chunks[stage]; c && *c; ++c) {
                parts[many].need = (*c)->need;
                parts[many].stage = 1 << stage;
                if (*c == &ssgi_gl__kernel) name_add(&parts[many].defines, "SSGI_KERNEL", 11);
                read_names(&parts[many++], (*c)->text);
            }
        }
        for (int i = 0; i < DRAWN; ++i) {
            ssgi_gl_desc d = plain_desc(t), other;
            choose_freely(&d, 0);
            const ssgi_gl__set its = features_of(&d);
            for (int k = 0; k < CHOICES; ++k)
                for (int v = 0; v < choices[k].count; ++v) {
                    other = d;
                    choose(&other, k, v);
                    if (ssgi_gl_check(&other, NULL) != SSGI_OK) continue;
                    const ssgi_gl__set others = features_of(&other);
                    for (int w = 0; w < WORDS; ++w) moved[k].word[w] |= its.word[w] ^ others.word[w];
                }
        }
        for (int n = 0; n < knowns; ++n) {
            uint64_t kept = 0;
            int wrong[2] = { 0, 0 }, rest = 0;
            char first[2][200] = { "", "" };
            for (int p = 0; p < many; ++p)
                for (int k = 0; k < CHOICES && (name_in(&parts[p].defines, n) || name_in(&parts[p].uses, n)); ++k)
                    if (moved[k].word[parts[p].need >> 62] & parts[p].need & (SSGI_GL__BIT(62) - 1)) kept |= (uint64_t)1 << k;
            for (int i = 0; !rest; ++i) {
                ssgi_gl_desc d = plain_desc(t);
                d.dialect = i & 1 ? SSGI_GL_450 : SSGI_GL_410;     /* where one has what the other lacks */
                rest = i / 2;
                for (int k = 0; k < CHOICES; ++k)
                    if (kept >> k & 1) { choose(&d, k, rest % choices[k].count); rest /= choices[k].count; }
                if (rest || !choose_freely(&d, kept)) continue;
                const ssgi_gl__set features = features_of(&d);
                int defined = 0, used = 0;                 /* stages; a block's members are in all, so they are used somewhere */
                for (int p = 0; p < many; ++p) {
                    if (!ssgi_gl__has(&features, parts[p].need)) continue;
                    if (name_in(&parts[p].defines, n)) defined |= known[n][0] == 'u' ? 1 : parts[p].stage;
                    if (name_in(&parts[p].uses, n)) used |= known[n][0] == 'u' ? 1 : parts[p].stage;
                }
                ++tried;
                const int missing = (used & ~defined) != 0;
                if (defined != used && !wrong[missing]++) snprintf(first[missing], sizeof first[missing], "%s", describe(&d));
            }
            for (int used = 0; used < 2; ++used)
                CHECK(!wrong[used], "%s is %s in %d, as in %s", known[n], used ? "not there, but used," : "there, but not used,", wrong[used], first[used]);
        }
    }
    t_note("%d names in %d descs", knowns, tried);
}

/* ssgi_gl_field declares what it uses and nothing else, and its functions are the pass' own. */
static void toolboxes(void)
{
    static char text[TEXT], whole[TEXT];
    for (int i = 0; i < texts; ++i) {
        ssgi_gl_desc d = spoken[i].desc;
        part p;
        if (spoken[i].stage != TOOLBOX) continue;
        memset(&p, 0, sizeof p);
        read_names(&p, source_of(text, &d, TOOLBOX));
        d.pass = SSGI_GL_FIELD;
        char *first = strstr(text, "\n\n"), *last = strstr(text, "\n// what casters");
        CHECK(!memcmp(&p.defines, &p.uses, sizeof p.uses), "%s: its functions alone declare other names than they use", describe(&d));
        if (CHECK(first && last, "%s: no functions", describe(&d))) *last = 0;
        CHECK(!last || strstr(emit(whole, &d, SSGI_GL_FRAGMENT), first), "%s: its functions alone are others", describe(&d));
    }
}

/* ---- >>lint ------------------------------------------------------------------------------------------------------ */

static int reserved(const char *word, size_t n)   /* in any dialect, and not used by us as what it is */
{
    static const char words[] = " common partition active asm class union enum typedef template this resource goto inline noinline public static extern external interface long "
        "short half fixed unsigned superp input output filter sizeof cast namespace using sample patch subroutine coherent volatile restrict readonly writeonly shared buffer "
        "atomic_uint precise smooth noperspective centroid attribute varying double switch case default do while image1D image2D lowp mediump invariant "
        "hvec2 hvec3 hvec4 fvec2 fvec3 fvec4 dvec2 dvec3 dvec4 sampler3DRect texture texture2D noise1 noise2 row_major packed ";
    char key[64];
    if (n > 60) return 1;
    snprintf(key, sizeof key, " %.*s ", (int)n, word);
    return strstr(words, key) != NULL;
}

static void lint_chunk(const ssgi_gl__chunk *c)
{
    const char *t = c->text;
    const size_t n = strlen(t);
    CHECK(n <= 4095 && (!n || t[n - 1] == '\n'), "line %d: a chunk of %zu characters, or without \\n at its end", c->line, n);
    for (int fresh = 1; *t; fresh = *t++ == '\n') {
        size_t k = 0;
        if (t[0] == '/' && t[1] == '/') t += strcspn(t, "\n");
        if (fresh && isalpha((unsigned char)*t) && strncmp(t, "layout(", 7)) {     /* at global scope: the last word before what begins a value, arguments or members */
            const char *name = t + strcspn(t, " ([=;{\n");
            for (const char *next; *name == ' ' && PART(name[1]); name = next) { next = name + 1; while (PART(*next)) ++next; }
            while (name > t && PART(name[-1])) --name;
            CHECK(!strncmp(name, "ssgi_", 5) || !strncmp(name, "SSGI_", 5) || !strncmp(name, "v_ssgi_", 7) || !strncmp(name, "main(", 5), "line %d: not our name: %.30s", c->line, name);
        }
        if (!isalpha((unsigned char)*t)) continue;
        while (PART(t[k])) ++k;
        CHECK(!reserved(t, k) || (fresh && (!strncmp(t, "patch in ", 9) || !strncmp(t, "patch out ", 10))), "line %d: reserved: %.*s", c->line, (int)k, t);
        t += k - 1;
    }
}

static void lint(void)
{
    static char text[TEXT];
    for (int p = 0; p < SSGI_GL__ROWS; ++p)
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage)
            for (const ssgi_gl__chunk *const *c = ssgi_gl__passes[p].chunks[stage]; c && *c; ++c) lint_chunk(*c);
    lint_chunk(&ssgi_gl__field_all);
    for (int i = 0; i < texts; ++i) {
        const char *c = source_of(text, &spoken[i].desc, spoken[i].stage);
        while (((*c >= ' ' && *c < 127) || *c == '\n') && !(c[0] == '_' && c[1] == '_') && !(c[0] == ' ' && c[1] == '\n') && *c != '\\') ++c;
        if (!CHECK(!*c, "%s: not ASCII, a tab, __, a backslash or a space at a line's end: \"%.20s\"", describe(&spoken[i].desc), c)) return;
        CHECK(c[-1] == '\n', "%s: the text does not end its line", describe(&spoken[i].desc));
    }
}

/* ---- >>sentences -------------------------------------------------------------------------------------------------- */

#define NAMES(sentence, start) (strncmp(sentence, start, strlen(start)) == 0)

static void sentences(void)
{
#define INT(field, most) { "desc." #field ":", offsetof(ssgi_gl_desc, field), most }
    static const struct { const char *start; size_t offset; int most; } ints[] = {
        INT(pass, 15), INT(dialect, 5), INT(orthographic, 1), INT(depth, 2), INT(normal, 4), INT(world_normals, 1), INT(noise, 2), INT(samples, 64), INT(search, 1),
        INT(directions, 32), INT(steps, 64), INT(normal_rays, 8), INT(hard, 1), INT(thin, 1), INT(falloff, 2), INT(kernel, 1), INT(fade, 3), INT(range, 1),
        INT(layers, 8), INT(views, 4), INT(view_layers, 8), INT(receiver, 7), INT(environment, 2), INT(bounce, 3), INT(bands, 4), INT(packed, 1), INT(transfer, 2),
        INT(shaded, 1), INT(shading, 3), INT(lamps, 1), INT(albedo, 1), INT(exact, 1), INT(two_sided, 1), INT(shadow, 3), INT(accumulate, 1), INT(radiance, 3),
        INT(storage, 1), INT(measure, 1), INT(eight_bits, 1), INT(cap, 1), INT(objects, 2), INT(effect, 4), INT(levels, 7),
        INT(fixed, 1), INT(tessellate, 1), INT(sends, 2), INT(enlarge, 1), INT(closely, 16), INT(overlap, 1), INT(axis, 1), INT(half, 1), INT(colour, 2), INT(filter, 1), INT(filter_radius, 4),
        INT(filter_normals, 1), INT(lines, 1) };
    static const struct { const char *start; ssgi_gl_desc desc; } rules[] = {
        { "desc.normal_rays:", { .pass = SSGI_GL_HSAO, .normal_rays = 1 } }, { "desc.world_normals:", { .normal = SSGI_GL_NORMAL_FROM_DEPTH, .world_normals = 1 } },
        { "desc.filter:", { .pass = SSGI_GL_BLUR, .half = 1, .filter = SSGI_GL_GAUSSIAN } }, { "desc.environment:", { .pass = SSGI_GL_SSDO } },
        { "desc.receiver:", { .pass = SSGI_GL_LIGHTS, .receiver = 1 } }, { "desc.receiver:", { .pass = SSGI_GL_SENDERS, .layers = 3, .receiver = 3 } },
        { "desc.receiver:", { .pass = SSGI_GL_LIGHTS, .layers = 2, .receiver = 1, .normal = SSGI_GL_NORMAL_FROM_DEPTH } },
        { "desc.fetch:", { .depth = SSGI_GL_DEPTH_CUSTOM } }, { "desc.fetch:", { .normal = SSGI_GL_NORMAL_CUSTOM } },
        { "desc.fetch:", { .pass = SSGI_GL_FIELD, .objects = SSGI_GL_OBJECTS_CUSTOM } },
        { "desc.packed:", { .pass = SSGI_GL_S3HO, .transfer = 1 } }, { "desc.packed:", { .pass = SSGI_GL_SHADE, .transfer = 2 } },
        { "desc.packed:", { .pass = SSGI_GL_BLUR, .colour = SSGI_GL_VECTORS, .transfer = 1 } }, { "desc.shading:", { .pass = SSGI_GL_SHADE, .shading = 1, .bands = 1 } },
        { "desc.shading:", { .pass = SSGI_GL_SHADE, .shading = 3, .packed = 1, .transfer = 1 } }, { "desc.fetch:", { .pass = SSGI_GL_SURFELS, .sends = SSGI_GL_SENDS_CUSTOM } },
        { "desc.tessellate:", { .pass = SSGI_GL_SURFELS, .tessellate = 1 } }, { "desc.tessellate:", { .pass = SSGI_GL_SPLAT, .tessellate = 1, .dialect = SSGI_GL_310ES } },
        /* and these are none: what is not kept has as many vectors as it likes, what a pass does not look at is no matter */
        { NULL, { .pass = SSGI_GL_S3HO, .transfer = 1, .shaded = 1 } }, { NULL, { .pass = SSGI_GL_BLUR, .colour = SSGI_GL_COLOUR, .transfer = 1, .shading = 1, .bands = 1 } },
        { NULL, { .pass = SSGI_GL_SPLAT, .tessellate = 1, .dialect = SSGI_GL_320ES } }, { NULL, { .pass = SSGI_GL_SUM, .tessellate = 1 } },
        { NULL, { .pass = SSGI_GL_SHADE, .shading = 1, .bands = 2 } }, { NULL, { .pass = SSGI_GL_SHADE, .bands = 1, .packed = 1, .transfer = 2 } } };
    const char *why = "";
    CHECK(sizeof ints / sizeof ints[0] == sizeof ssgi_gl__fields / sizeof ssgi_gl__fields[0]
          && offsetof(ssgi_gl_desc, version) / sizeof(int) - sizeof ints / sizeof ints[0] < 2, "desc has ints that this test does not know");
    CHECK(ssgi_gl_check(NULL, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "desc:"), "NULL: %s", why);
    for (size_t i = 0; i < sizeof ints / sizeof ints[0]; ++i)
        for (int k = 0; k < 4; ++k) {
            const int value[4] = { -1, ints[i].most + 1, INT32_MIN, INT32_MAX };
            ssgi_gl_desc d = { .search = SSGI_GL_MARCH, .layers = 8, .environment = SSGI_GL_ENVIRONMENT_SH, .fetch = FETCH }, was;
            if (ints[i].offset == offsetof(ssgi_gl_desc, environment)) d.pass = SSGI_GL_SSDO;
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
        const char *start = rules[i].start ? rules[i].start : "";
        why = "";
        CHECK(ssgi_gl_check(&rules[i].desc, &why) == (*start ? SSGI_BAD_ARGUMENT : SSGI_OK) && (*start ? NAMES(why, start) : !*why), "rule %zu, %s \"%s\"", i, start, why);
    }
    for (int v = 0; v < variants; ++v)
        for (int preset = -1; preset < 4; ++preset) {
            ssgi_gl_desc d = variant[v];
            ssgi_result r = ssgi_gl_preset(&d, preset, &why), want = preset < 0 || preset > 2 ? SSGI_BAD_ARGUMENT : SSGI_OK;
            CHECK(r == want && (r == SSGI_OK || NAMES(why, "preset:")) && ((r == SSGI_OK && (d.pass < SSGI_GL_FIELD || d.pass == SSGI_GL_BLUR)) || !memcmp(&d, &variant[v], sizeof d)), "preset %d: \"%s\"", preset, why);
            CHECK(ssgi_gl_check(&d, &why) == SSGI_OK, "preset %d of %s leaves a bad desc: %s", preset, describe(&variant[v]), why);
        }

    static const float m[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 }, radii[] = { 0, -1, NAN, INFINITY, -INFINITY, 2e18f };
    ssgi_view view, none;
    ssgi_gl_frame frame, was;
    float light = 0;
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
          && frame.fade == 0.3f * 0.5f && frame.nearest == 0.25f && frame.gain == 1.0f && frame.steepest == 20.0f && !frame.lights && frame.lambda == 4.0f
          && frame.window[0] == 1.0f && fabsf(frame.window[1] - 0.8535534f) < 1e-6f && fabsf(frame.window[3] - 0.1464466f) < 1e-6f
          && frame.rotation[0] == 1.0f && frame.rotation[5] == 1.0f && frame.rotation[10] == 1.0f && frame.size[0] == 64 && frame.size[1] == 32
          && frame.mesh[0] == 1.0f && frame.mesh[5] == 1.0f && frame.mesh[10] == 1.0f && frame.mesh[15] == 1.0f && frame.front == ssgi_view_near(&view) && frame.epsilon == 0.1f
          && frame.exponent == 32.0f, "the frame's defaults");
    for (int i = 0; i < 48; ++i) light += fabsf(frame.harmonics[i]);
    CHECK(light == 0.0f, "a frame's light is not black");
}

static void defaults(void)
{
#define LIST(...) __VA_ARGS__
#define ROW(fetches, plain, more) { { LIST plain }, { LIST plain, LIST more }, fetches }
    static const struct { ssgi_gl_desc plain, whole; int fetches; } rows[] = {
        ROW(2 + 16, (.pass = SSGI_GL_SSAO), (.samples = 16, .steps = 1, .layers = 1, .view_layers = 1)),
        ROW(2 + 6 * 2, (.pass = SSGI_GL_HSAO), (.directions = 1, .steps = 6)),
        ROW(2 + 6 * 6 * (1 + 2), (.pass = SSGI_GL_HSAO, .search = SSGI_GL_MARCH, .normal_rays = 1, .views = 1), (.directions = 6, .steps = 6, .view_layers = 1)),
        ROW(2 + 16 * 2 + 4, (.pass = SSGI_GL_SSDO, .environment = SSGI_GL_ENVIRONMENT_MAP), (.samples = 16, .steps = 1, .layers = 1)),
        ROW(3 + 16 * (2 * (2 + 2 * 3) + 1), (.pass = SSGI_GL_SSDO, .bounce = SSGI_GL_BOUNCE_DISC, .kernel = 1, .layers = 2, .views = 2, .view_layers = 3, .steps = 2,
            .noise = SSGI_GL_NOISE_TEXTURE), (.samples = 16)),
        ROW(2 + 3 + 8, (.pass = SSGI_GL_LIGHTS), (.samples = 8, .layers = 1)),
        ROW(2 + 3 + 6 + 8 + 1, (.pass = SSGI_GL_LIGHTS, .shadow = SSGI_GL_SHADOW_FILL, .accumulate = 1), (.samples = 8)),
        ROW(2 + 3, (.pass = SSGI_GL_LIGHTS, .shadow = SSGI_GL_SHADOW_NONE), (.samples = 64, .noise = SSGI_GL_NOISE_TEXTURE, .thin = 1)),
        ROW(2 + 2 + 1, (.pass = SSGI_GL_SENDERS, .radiance = SSGI_GL_RADIANCE_BOTH), (.layers = 1)),
        ROW(2 + 16, (.pass = SSGI_GL_SSDO, .environment = SSGI_GL_ENVIRONMENT_SH), (.bands = 3)),
        ROW(2 + 16, (.pass = SSGI_GL_S3HO), (.samples = 16, .steps = 1, .layers = 1, .bands = 4)),
        ROW(3 + 16 * (2 * (3 + 2) + 1), (.pass = SSGI_GL_S3HO, .transfer = 1, .packed = 1, .kernel = 1, .layers = 3, .views = 1, .view_layers = 2, .steps = 2,
            .noise = SSGI_GL_NOISE_TEXTURE), (.samples = 16)),
        ROW(2 + 16 + 4, (.pass = SSGI_GL_S3HO, .shaded = 1, .exact = 1), (.bands = 4)),
        ROW(1 + 4, (.pass = SSGI_GL_SHADE), (.bands = 4)),
        ROW(2 + 4 + 4 + 3, (.pass = SSGI_GL_SHADE, .exact = 1, .lamps = 1), (.bands = 4)),
        ROW(1 + 1 + 3, (.pass = SSGI_GL_SHADE, .bands = 2, .lamps = 1), (.samples = 1)),
        { { .pass = SSGI_GL_SHADE, .packed = 1, .transfer = 1, .albedo = 1 }, { .pass = SSGI_GL_SHADE, .packed = 1, .transfer = 2, .albedo = 1, .bands = 4 }, 1 + 6 + 1 },
        ROW(1 + 1 + 8, (.pass = SSGI_GL_SHADE, .shading = 2), (.bands = 2)),
        ROW(1 + 4 + 4 + 3, (.pass = SSGI_GL_SHADE, .shading = 1, .lamps = 1), (.bands = 4)),
        { { .pass = SSGI_GL_SHADE, .shading = 3, .packed = 1, .lamps = 1, .albedo = 1 }, { .pass = SSGI_GL_SHADE, .shading = 3, .packed = 1, .bands = 3 }, 1 + 1 },
        ROW(2 + 4, (.pass = SSGI_GL_FIELD), (.samples = 64, .layers = 8, .half = 1)),
        ROW(5 + 2 + 1 + 1, (.pass = SSGI_GL_FIELD, .storage = SSGI_GL_STORAGE_CUBE, .cap = 1, .objects = SSGI_GL_OBJECTS_TEXTURE, .normal = SSGI_GL_NORMAL_FROM_DEPTH), (.eight_bits = 1)),
        ROW(0, (.pass = SSGI_GL_SURFELS), (.shadow = SSGI_GL_SHADOW_MAP, .environment = SSGI_GL_ENVIRONMENT_MAP, .effect = SSGI_GL_EFFECT_BOUNCE)),
        ROW(3 + 6 + 4, (.pass = SSGI_GL_SURFELS, .dialect = SSGI_GL_410, .tessellate = 1, .sends = SSGI_GL_SENDS_LIGHTS, .shadow = SSGI_GL_SHADOW_MAP, .environment = SSGI_GL_ENVIRONMENT_SH), (.half = 1)),
        ROW(5, (.pass = SSGI_GL_SHUFFLE, .normal = SSGI_GL_NORMAL_FROM_DEPTH), (.levels = 5)),
        ROW(1, (.pass = SSGI_GL_SPLAT), (.levels = 5, .closely = 1, .sends = SSGI_GL_SENDS_LIGHTS)),
        ROW(1 + 1, (.pass = SSGI_GL_SPLAT, .effect = SSGI_GL_EFFECT_LIGHT), (.levels = 5, .hard = 1)),
        ROW(1, (.pass = SSGI_GL_UNSHUFFLE, .effect = SSGI_GL_EFFECT_SCATTER), (.levels = 7)),
        ROW(2 + 1 + 16 * 2, (.pass = SSGI_GL_SMOOTH), (.levels = 5)),
        ROW(5 + 1 + 2 * (1 + 1 + 4), (.pass = SSGI_GL_SMOOTH, .levels = 2, .filter_normals = 1, .normal = SSGI_GL_NORMAL_FROM_DEPTH), (.overlap = 1)),
        ROW(1 + 5, (.pass = SSGI_GL_SUM), (.levels = 5)),
        ROW(2 + 3 + 4, (.pass = SSGI_GL_SUM, .levels = 3, .effect = SSGI_GL_EFFECT_LIGHT), (.axis = 1)),
        ROW(2 + 4 + 8 * 5, (.pass = SSGI_GL_BLUR, .colour = SSGI_GL_VECTORS), (.bands = 4, .filter_radius = 1)),
        ROW(2 + 9 * (1 + 3 + 1), (.pass = SSGI_GL_BLUR, .colour = SSGI_GL_VECTORS, .half = 1, .bands = 3, .filter_normals = 1), (.filter_radius = 1)),
        { { .pass = SSGI_GL_BLUR, .colour = SSGI_GL_VECTORS, .packed = 1, .transfer = 2, .filter = SSGI_GL_GAUSSIAN },
          { .pass = SSGI_GL_BLUR, .colour = SSGI_GL_VECTORS, .packed = 1, .transfer = 1, .filter = SSGI_GL_GAUSSIAN, .filter_radius = 2 }, 1 + 6 + 24 * 7 },
        ROW(1 + 9, (.pass = SSGI_GL_BLUR), (.filter_radius = 1)),
        ROW(2 + 32, (.pass = SSGI_GL_SURVEY), (.samples = 32)),
        ROW(25, (.pass = SSGI_GL_BLUR, .colour = 1, .filter = SSGI_GL_GAUSSIAN), (.filter_radius = 2)) };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        CHECK(ssgi_gl_key(&rows[i].plain) == ssgi_gl_key(&rows[i].whole), "row %zu, %s: its defaults written out give another text", i, ssgi_gl_pass_name(rows[i].plain.pass));
        const int read[2] = { kit_fetches(&rows[i].plain), kit_fetches(&rows[i].whole) };
        CHECK(read[0] == rows[i].fetches && read[1] == rows[i].fetches, "row %zu, %s: %d, %d fetches, by hand %d", i,
              ssgi_gl_pass_name(rows[i].plain.pass), read[0], read[1], rows[i].fetches);
    }
}

/* ---- >>cameras: extra ones and those of shadow maps ---------------------------------------------------------------- */

/* The rotation that takes +z an angle from it, between two about z: quaternion of sin(angle/2) at one azimuth, cos(angle/2) at another. */
static void rotation(float m[16], double angle, double a, double b)
{
    const double x = sin(angle / 2) * cos(a), y = sin(angle / 2) * sin(a), z = cos(angle / 2) * sin(b), w = cos(angle / 2) * cos(b);
    const double turn[16] = { 1 - 2 * (y * y + z * z), 2 * (x * y + z * w), 2 * (z * x - y * w), 0, 2 * (x * y - z * w), 1 - 2 * (z * z + x * x), 2 * (y * z + x * w), 0,
                              2 * (z * x + y * w), 2 * (y * z - x * w), 1 - 2 * (x * x + y * y), 0, 0, 0, 0, 1 };
    for (int i = 0; i < 16; ++i) m[i] = (float)turn[i];
}

/* Any rigid matrix. */
static void rigid(float m[16])
{
    rotation(m, (double)uniform(0, 3.14f), (double)uniform(0, 6.28f), (double)uniform(0, 6.28f));
    for (int k = 0; k < 3; ++k) m[12 + k] = uniform(-9, 9);
}

/* Row r of a matrix times a point; lost: what may be lost of it, as rigid matrices of floats are not quite. */
static double row_of(const float m[16], int r, const double p[4], double *lost)
{
    double sum = 0;
    *lost = 0;
    for (int c = 0; c < 4; ++c) { sum += (double)m[4 * c + r] * p[c]; *lost += 4e-6 * fabs((double)m[4 * c + r] * p[c]); }
    return sum;
}

/* An off-centre camera of 640 x 480; its projection may be anything that a view decodes. */
static int any_view(ssgi_view *view, int ortho)
{
    const float x = uniform(-0.3f, 0.3f), y = uniform(-0.3f, 0.3f), wide = uniform(0.5f, 3), high = uniform(-3, -0.5f);
    const float m[2][16] = { { wide, 0, 0, 0, 0, high, 0, 0, x, y, -1.002f, -1, 0, 0, -0.2f, 0 }, { wide, 0, 0, 0, 0, high, 0, 0, 0, 0, -0.02f, 0, x, y, -1, 1 } };
    const char *why = "";
    return CHECK(ssgi_view_from_projection(view, m[ortho], SSGI_CLIP_GL, 640, 480, &why) == SSGI_OK, "%s", why);
}

static void cameras(void)
{
    enum { TRIES = 4000 };
    double worst[2] = { 0, 0 };
    random_state = 5;
    for (int i = 0; i < TRIES; ++i) {
        const int ortho = i & 1, slot = i / 2 % 4;
        float picture[16], other[16], seen[3];
        ssgi_view view;
        ssgi_gl_views v, was;
        ssgi_gl_light light, bare;
        const char *why = "";
        double p[4] = { (double)uniform(-5, 5), (double)uniform(-5, 5), -(double)uniform(0.2f, 30), 1 }, q[4] = { 0, 0, 0, 1 }, lost, at[4];
        const float spot[3] = { (float)p[0], (float)p[1], (float)p[2] };
        if (!any_view(&view, ortho)) return;
        rigid(picture);
        rigid(other);
        memset(&was, 0x5a, sizeof was);
        memset(&bare, 0x5a, sizeof bare);
        v = was;
        light = bare;
        if (!CHECK(ssgi_gl_views_set(&v, slot, &view, picture, other, &why) == SSGI_OK && ssgi_gl_light_map(&light, &view, 7, 9, picture, other, &why) == SSGI_OK, "%s", why)) return;
        for (int k = 0; k < 3; ++k) {                      /* p is in the other camera's space: to the world, then to the picture's */
            double world = 0;
            for (int c = 0; c < 3; ++c) world += (double)other[4 * k + c] * (p[c] - (double)other[12 + c]);
            at[k] = world;
        }
        at[3] = 1;
        for (int k = 0; k < 3; ++k) q[k] = row_of(picture, k, at, &lost);
        ssgi_view_project(&view, spot, seen);
        for (int k = 0; k < 3; ++k) {
            const double want = (double)seen[k] * (ortho || k == 2 ? 1 : -p[2]), got = row_of(v.to[slot], k, q, &lost);
            CHECK(fabs(got - want) <= lost + 4e-7 * fabs(want), "to, %s, row %d: %.9g, ssgi_view_project says %.9g", ortho ? "orthographic" : "perspective", k, got, want);
            worst[0] = fmax(worst[0], fabs(got - want) / (lost + 4e-7 * fabs(want)));
            at[k] = want;
            for (int c = 0; c < 4; ++c) CHECK(light.map[k][c] == v.to[slot][4 * c + k], "a light's map and an extra camera differ in row %d", k);
        }
        for (int k = 0; k < 3; ++k) {
            const double got = row_of(v.from[slot], k, at, &lost);
            CHECK(fabs(got - q[k]) <= lost + 4e-7 * fabs(q[k]), "from, %s, row %d: %.9g, the point is at %.9g", ortho ? "orthographic" : "perspective", k, got, q[k]);
            worst[1] = fmax(worst[1], fabs(got - q[k]) / (lost + 4e-7 * fabs(q[k])));
        }
        const float decode[4] = { view.depth[0], view.depth[1], view.clear, (float)ortho }, tile[4] = { 7, 9, 640, 480 };
        CHECK(!memcmp(decode, v.decode[slot], sizeof decode) && !memcmp(decode, light.decode, sizeof decode)
              && !memcmp(tile, light.tile, sizeof tile) && v.size[slot][0] == 640 && v.size[slot][1] == 480,
              "decode, size or tile of %s", ortho ? "orthographic" : "perspective");
        CHECK(light.patch == ssgi_pixel_footprint(&view, 1) && !memcmp(&light, &bare, offsetof(ssgi_gl_light, patch)), "a light's patch, or what is not of its map");
        memcpy(was.to[slot], v.to[slot], sizeof was.to[slot]);
        memcpy(was.from[slot], v.from[slot], sizeof was.from[slot]);
        memcpy(was.decode[slot], v.decode[slot], sizeof was.decode[slot]);
        memcpy(was.size[slot], v.size[slot], sizeof was.size[slot]);
        CHECK(!memcmp(&was, &v, sizeof v), "camera %d wrote to another's place", slot);
    }
    t_note("of what rounding may lose, at most: %.2f there, %.2f back", worst[0], worst[1]);
}

static void refused_cameras(void)
{
    static float right[16], odd[2][16];
    ssgi_view view, none;
    ssgi_gl_views v, v_was;
    ssgi_gl_light light, light_was;
    const char *why = "";
    memset(&none, 0, sizeof none);
    memset(&v_was, 0x5a, sizeof v_was);
    memset(&light_was, 0x5a, sizeof light_was);
    v = v_was;
    light = light_was;
    if (!any_view(&view, 0)) return;
    rigid(right);
    memcpy(odd[0], right, sizeof right);
    memcpy(odd[1], right, sizeof right);
    odd[0][5] = NAN;
    odd[1][14] = INFINITY;
    const struct { const char *start[2]; const ssgi_view *view; int i; const float *picture, *other; } cases[] = {
        { { "i:", "x:" }, &view, -1, right, right }, { { "i:", NULL }, &view, 4, right, right },
        { { "view:", "view:" }, NULL, 0, right, right }, { { "view:", "view:" }, &none, 0, right, right },
        { { "picture_world_to_view:", "picture_world_to_view:" }, &view, 0, NULL, right }, { { "extra_world_to_view:", "light_world_to_view:" }, &view, 0, right, NULL },
        { { "picture_world_to_view:", "picture_world_to_view:" }, &view, 0, odd[0], right }, { { "picture_world_to_view:", "picture_world_to_view:" }, &view, 0, right, odd[1] } };
    CHECK(ssgi_gl_views_set(NULL, 0, &view, right, right, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "views:") && ssgi_gl_light_map(NULL, &view, 0, 0, right, right, &why) == SSGI_BAD_ARGUMENT
          && NAMES(why, "light:"), "NULL: %s", why);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        CHECK(ssgi_gl_views_set(&v, cases[i].i, cases[i].view, cases[i].picture, cases[i].other, &why) == SSGI_BAD_ARGUMENT && NAMES(why, cases[i].start[0])
              && ssgi_gl_views_set(&v, cases[i].i, cases[i].view, cases[i].picture, cases[i].other, NULL) == SSGI_BAD_ARGUMENT, "views, case %zu: %s", i, why);
        for (int y = 0; y < 2 && cases[i].start[1]; ++y)
            CHECK(ssgi_gl_light_map(&light, cases[i].view, y ? 0 : cases[i].i, y ? cases[i].i : 0, cases[i].picture, cases[i].other, &why) == SSGI_BAD_ARGUMENT
                  && NAMES(why, cases[i].start[1]),
                  "light, case %zu: %s", i, why);
    }
    CHECK(!memcmp(&v, &v_was, sizeof v) && !memcmp(&light, &light_was, sizeof light), "what was refused was written to");
}

/* ---- >>twins: GLSL against C --------------------------------------------------------------------------------------- */

enum { SIDE = 64, MANY = SIDE * SIDE };
static float in[MANY][4], out[MANY][4];
static float *const ins = &in[0][0], *const outs = &out[0][0];    /* the same, flat */

static ssgi_gl_views probed;               /* extra cameras that probes see */

/* A text up to its main, and a main that makes o of inputs: in to out. X(k): texel k of the pixel's four of the input, a: its own; Y(k): the same of maps,
   which all textures of the text read too. */
static int probe_text(char *text, int dialect, const ssgi_gl_frame *frame, GLuint maps, const char *statements)
{
    static const GLenum buffers[8] = { GL_NONE, GL_NONE, GL_NONE, GL_NONE, GL_NONE, GL_NONE, GL_NONE, GL_COLOR_ATTACHMENT7 };
    const ssgi_gl_desc plain = { .dialect = dialect };
    char *end = strstr(text, "void main");
    GLuint program, block[2], framebuffer, target = kit_texture(SIDE, SIDE, GL_RGBA32F, NULL), input = kit_texture(SIDE, SIDE, GL_RGBA32F, in[0]);
    int read;
    if (!end) end = text + strlen(text);
    snprintf(end, TEXT - (size_t)(end - text), "layout(location = 7) out highp vec4 o;\nuniform highp sampler2D t_in, t_maps;\n"
             "#define AT(t, k) texelFetch(t, ivec2((texel.x & ~3) + (k), texel.y), 0)\n#define X(k) AT(t_in, k)\n#define Y(k) AT(t_maps, k)\n"
             "void main()\n{\n    ivec2 texel = ivec2(gl_FragCoord.xy);\n    vec4 a = X(texel.x & 3);\n    %s\n}\n", statements);
    program = linked(&plain, text);
    if (!program) return 0;
    glGenBuffers(2, block);
    for (GLuint b = 0; b < 2; ++b) {
        glBindBuffer(GL_UNIFORM_BUFFER, block[b]);
        glBufferData(GL_UNIFORM_BUFFER, b ? (GLsizeiptr)sizeof probed : (GLsizeiptr)sizeof *frame, b ? (const void *)&probed : frame, GL_STATIC_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, b, block[b]);
    }
    for (GLenum unit = 0; unit < 8; ++unit) { glActiveTexture(GL_TEXTURE0 + unit); glBindTexture(GL_TEXTURE_2D, unit == 7 ? input : maps); }
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT7, GL_TEXTURE_2D, target, 0);
    glDrawBuffers(8, buffers);
    glViewport(0, 0, SIDE, SIDE);
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "t_in"), 7);
    glUniform1i(glGetUniformLocation(program, "t_maps"), 6);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    read = kit_texture_read(target, SIDE, SIDE, 4, out[0]);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &target);
    glDeleteTextures(1, &input);
    glDeleteBuffers(2, block);
    glDeleteProgram(program);
    return CHECK(!read, "the probe cannot be read");
}

static int probe(const ssgi_gl_desc *d, const ssgi_gl_frame *frame, GLuint maps, const char *statements)
{
    static char text[TEXT];
    emit(text, d, SSGI_GL_FRAGMENT);
    return probe_text(text, d->dialect, frame, maps, statements);
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

/* Interleaved gradient noise [Jimenez 2014]. */
static double gradient_noise(double x, double y)
{
    const double inner = 0.06711056 * x + 0.00583715 * y, outer = 52.9829189 * (inner - floor(inner));
    return outer - floor(outer);
}

static void twin_noise_and_kernel(void)
{
    float kernel[4 * 64];
    ssgi_gl_frame frame;
    memset(&frame, 0, sizeof frame);
    for (int i = 0; i < MANY; ++i) { in[i][0] = (float)(i % SIDE * 37); in[i][1] = (float)(i / SIDE * 21); in[i][2] = (float)(i % SIDE); in[i][3] = (float)(i / SIDE); }
    ssgi_gl_desc d = { .dialect = SSGI_GL_450, .samples = 64 };
    ssgi_kernel(kernel, 1, 64, NULL);
    for (int y = 0; y < 200; ++y)
        for (int x = 0; x < 200; ++x) {                   /* any 3x3: at most 2 values in a ninth, so gaps stay below 3 of them */
            int cell[9] = { 0 }, most = 0;
            for (int i = 0; i < 9; ++i) {
                int *c = &cell[(int)(9 * gradient_noise(x + i % 3, y + i / 3))];
                if (++*c > most) most = *c;
            }
            CHECK(most <= 2, "gradient noise: %d of 9 values in one ninth at %d, %d", most, x, y);
        }
    if (probe(&d, &frame, 0, "o = vec4(ssgi_noise(ivec2(a.xy)), ssgi_noise(ivec2(a.zw)));"))
        for (int i = 0; i < MANY; ++i)
            for (int k = 0; k < 2; ++k) {                 /* two products and their sum, rounded; in x 53 times that */
                double x = (double)in[i][2 * k], y = (double)in[i][2 * k + 1], e = (double)out[i][2 * k] - gradient_noise(x, y);
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

/* What senders wrote, read back as its format says: 9 9 9 bits and an exponent of 5; 6 bits of exponent and 14; two of 6. */
static void unpack(const float halves[4], float rgb[3], float *z)
{
    const uint32_t a = (uint32_t)halves[0] | (uint32_t)halves[1] << 16, b = (uint32_t)halves[2] | (uint32_t)halves[3] << 16;
    for (int c = 0; c < 3; ++c) rgb[c] = ldexpf((float)(a >> 9 * c & 511), (int)(a >> 27) - 24);
    *z = ldexpf(1 + (float)(b >> 12 & 0x3fff) / 16384, (int)(b >> 26) - 20);
}

static void twin_senders(void)
{
    static float rgbz[MANY][4], way[MANY][3];
    const ssgi_gl_desc pack = { .pass = SSGI_GL_SENDERS, .dialect = SSGI_GL_450 }, read = { .pass = SSGI_GL_SSDO, .dialect = SSGI_GL_450, .bounce = SSGI_GL_BOUNCE_DISC };
    ssgi_gl_frame frame;
    double worst = 0;
    memset(&frame, 0, sizeof frame);
    random_state = 9;
    for (int i = 0; i < MANY; ++i) {
        const float bright = powf(10, uniform(-7, 5.2f)), a = uniform(0, 6.2831853f), h = uniform(-1, 1);
        for (int c = 0; c < 3; ++c) { rgbz[i][c] = i % 8 == c ? 0 : bright * uniform(0, 1); way[i][c] = c == 2 ? h : sqrtf(1 - h * h) * (c ? sinf(a) : cosf(a)); }
        for (int c = 0; c < 3 && i < 6; ++c) way[i][c] = i / 2 == c ? i & 1 ? -1.0f : 1.0f : 0.0f;
        if (i % 64 == 9) rgbz[i][i / 64 % 3] = ldexpf(511.0f + (float)(i / 192) / 21, i / 64 % 24 - 10);   /* where rounding needs the next exponent */
        rgbz[i][3] = powf(10, uniform(-6, 13));
    }
    memcpy(in, rgbz, sizeof in);
    if (!probe(&pack, &frame, 0, "uvec2 u = uvec2(ssgi_pack_radiance(a.xyz), ssgi_pack_place(a.w, vec3(0.0, 0.0, 1.0)));"
               "o = vec4(u.x & 65535u, u.x >> 16u, u.y & 65535u, u.y >> 16u);")) return;
    memcpy(in, out, sizeof in);
    if (!probe(&read, &frame, 0, "uvec2 u = uvec2(a.xz) | uvec2(a.yw) << 16u; o = vec4(ssgi_unpack_radiance(u.x), ssgi_unpack_depth(u.y));")) return;
    for (int i = 0; i < MANY; ++i) {
        float rgb[3], z, most = fmaxf(fmaxf(rgbz[i][0], rgbz[i][1]), rgbz[i][2]);
        unpack(in[i], rgb, &z);
        for (int c = 0; c < 3; ++c) {
            NEAR(rgb[c], fminf(rgbz[i][c], 65408), fmax((double)most / 510, 1.2e-7), "ssgi_pack_radiance");
            NEAR(out[i][c], rgb[c], 0, "ssgi_unpack_radiance");
        }
        NEAR(z, rgbz[i][3], 3.06e-5 * (double)z, "ssgi_pack_place");
        NEAR(out[i][3], z, 0, "ssgi_unpack_depth");
        memcpy(in[i], way[i], sizeof way[i]);
    }
    if (!probe(&pack, &frame, 0, "uint u = ssgi_pack_place(1.0, a.xyz); o = vec4(u & 65535u, u >> 16u, 0.0, 0.0);")) return;
    memcpy(in, out, sizeof in);
    if (!probe(&read, &frame, 0, "o = vec4(ssgi_unpack_normal(uint(a.x) | uint(a.y) << 16u), ssgi_unpack_depth(0xffffffffu));")) return;
    for (int i = 0; i < MANY; ++i) {
        const double x = (double)out[i][0], y = (double)out[i][1], z = (double)out[i][2];
        const double cosine = (x * (double)way[i][0] + y * (double)way[i][1] + z * (double)way[i][2]) / sqrt(x * x + y * y + z * z), degrees = acos(fmin(cosine, 1)) * 57.29577951;
        CHECK(degrees <= 4, "a sender's normal is off by %.2f degrees", degrees);
        NEAR(out[i][3], SSGI_FAR, 0, "the view depth of nothing");
        worst = fmax(worst, degrees);
    }
    t_note("a sender's normal is off by %.2f degrees at most", worst);
}

/* Octahedral maps, and the point that an extra camera shows: the third of them, so that the block's strides matter. */
static void twin_views_of_others(void)
{
    const ssgi_gl_desc d = { .dialect = SSGI_GL_450, .fade = 1, .views = 3 }, map = { .pass = SSGI_GL_SSDO, .dialect = SSGI_GL_450, .environment = SSGI_GL_ENVIRONMENT_MAP };
    ssgi_gl_frame frame;
    memset(&frame, 0, sizeof frame);
    random_state = 11;
    for (int ortho = 0; ortho < 2; ++ortho) {
        float picture[16], other[16];
        ssgi_view view;
        if (!any_view(&view, ortho)) return;
        rigid(picture);
        rigid(other);
        memset(&probed, 0x5a, sizeof probed);
        ssgi_gl_views_set(&probed, 2, &view, picture, other, NULL);
        for (int i = 0; i < MANY; ++i) { in[i][0] = floorf(uniform(0, 640)); in[i][1] = floorf(uniform(0, 480)); in[i][2] = uniform(0.5f, 30); in[i][3] = 0; }
        if (!probe(&d, &frame, 0, "o = vec4(ssgi_point(2, ivec2(a.xy), a.z), u_ssgi_view_decode[2].x);")) return;
        for (int i = 0; i < MANY; ++i) {
            const double scale = ortho ? 1 : (double)in[i][2], p[4] = { ((double)in[i][0] + 0.5) * scale, ((double)in[i][1] + 0.5) * scale, (double)in[i][2], 1 };
            for (int k = 0; k < 3; ++k) { double lost, want = row_of(probed.from[2], k, p, &lost); NEAR(out[i][k], want, lost, "ssgi_point"); }
            NEAR(out[i][3], view.depth[0], 0, "u_ssgi_view_decode");
        }
    }
    for (int i = 0; i < MANY; ++i) for (int c = 0; c < 3; ++c) in[i][c] = i < 6 ? (float)((i == 2 * c) - (i == 2 * c + 1)) : uniform(-9, 9);
    if (!probe(&map, &frame, 0, "o = vec4(ssgi_octahedral(a.xyz), 0.0, 0.0);")) return;
    for (int i = 0; i < MANY; ++i) {
        float e[2];
        ssgi_octahedral_encode(in[i], e);
        for (int c = 0; c < 2; ++c) NEAR(out[i][c], e[c], 4e-7, "ssgi_octahedral");
    }
}

/* What ssgi_gl_sh writes, in both languages: a case is four pixels, one a word of the result. */
static void twin_harmonics(void)
{
    enum { BASIS, ZONAL, TURN, PRODUCT, SUMS, FUNCTIONS };
    static const char *const heads[] = { "#version 330 core\n", "#version 300 es\nprecision highp float;\n" };
    static const char *const words[] = { "s.a", "s.a", "w == 0 ? s.a : w == 1 ? s.b : s.c", "w == 0 ? s.a : w == 1 ? s.b : w == 2 ? s.c : s.d" };
    static const char *const parts[] = { "", "", " s.b = b; s.c = c;", " s.b = b; s.c = c; s.d = d;" };
    static const char *const calls[] = { "s = ssgi_sh_basis(Y(2).xyz);", "s = ssgi_sh_zonal(X(0), Y(2).xyz);", "ssgi_sh_turn(s, mat3(Y(0).xyz, Y(1).xyz, Y(2).xyz));",
        "s = ssgi_sh_product(s, y);", "float both = ssgi_sh_dot(s, y); ssgi_sh_add(s, y, 0.5); s.a.x = both;" };
    static const double tilts[8] = { 1e-2, 1e-3, 1e-4, 1e-5, 2e-6, 5e-7, 1e-7, 0 };   /* of the axis from either pole */
    static float others[4 * MANY];
    static char text[TEXT], body[600];
    const ssgi_gl_frame frame = { .radius = 1 };
    const double pi = 3.14159265358979;
    double worst[FUNCTIONS] = { 0 };
    random_state = 13;
    for (int k = 0; k < 2 * 4 * FUNCTIONS; ++k) {
        const int es = k & 1, bands = k / 2 % 4 + 1, what = k / 8;
        for (int i = 0; i < 4 * MANY; ++i) {
            ins[i] = i % 16 < bands * bands || what == ZONAL ? uniform(-1, 1) : 0;
            others[i] = ins[i] * uniform(-1, 1);
        }
        for (int i = 0; i < MANY / 4 && what < PRODUCT; ++i) {     /* rotations: none, half turns, the axis at a pole and near it, any */
            const double tilt = tilts[i / 2 % 8], a = (double)uniform(0, 6.28f), b = (double)uniform(0, 6.28f);
            if (i < 4) rotation(&others[16 * i], i < 2 ? pi : 0, i & 1 ? pi / 2 : 0, i & 1 ? pi / 2 : 0);
            else rotation(&others[16 * i], i & 16 ? (double)uniform(0, 3.14159f) : i & 1 ? tilt : pi - tilt, a, b);
            for (int j = 0; j < 11 && i & 32; ++j) others[16 * i + j] += uniform(-1.2e-7f, 1.2e-7f);    /* as a product of matrices is rounded */
        }
        GLuint map = kit_texture(SIDE, SIDE, GL_RGBA32F, others);
        size_t n = (size_t)snprintf(text, sizeof text, "%s", heads[es]);
        n += ssgi_gl_sh(text + n, sizeof text - n, bands);
        snprintf(text + n, sizeof text - n, "ssgi_sh given(vec4 a, vec4 b, vec4 c, vec4 d) { ssgi_sh s; s.a = a;%s return s; }\n", parts[bands - 1]);
        snprintf(body, sizeof body, "int w = texel.x & 3; ssgi_sh s = given(X(0), X(1), X(2), X(3)), y = given(Y(0), Y(1), Y(2), Y(3)); %s o = %s;", calls[what], words[bands - 1]);
        if (!probe_text(text, es ? SSGI_GL_300ES : SSGI_GL_330, &frame, map, body)) return;
        for (int i = 0; i < MANY / 4; ++i) {
            const float *x = &ins[16 * i], *y = &others[16 * i], *got = &outs[16 * i];
            float want[16] = { 0 };
            double both = 0;
            if (what == BASIS) ssgi_sh_basis(want, bands, y + 8);
            if (what == ZONAL) ssgi_sh_zonal(want, bands, x, y + 8);
            if (what == TURN) ssgi_sh_rotate(want, bands, x, 1, y);
            if (what == PRODUCT) ssgi_sh_product(want, bands, x, y);
            for (int j = 0; j < 16 && what == SUMS; ++j) { want[j] = x[j] + 0.5f * y[j]; both += (double)x[j] * (double)y[j]; }
            if (what == SUMS) want[0] = (float)both;
            for (int j = 0; j < (bands < 3 ? 4 : 4 * bands); ++j) {
                NEAR(got[j], want[j], 1e-5, calls[what]);
                worst[what] = fmax(worst[what], fabs((double)got[j] - (double)want[j]));
            }
        }
        glDeleteTextures(1, &map);
    }
    t_note("worst of basis %.1e, zonal %.1e, turn %.1e, product %.1e, sums %.1e", worst[BASIS], worst[ZONAL], worst[TURN], worst[PRODUCT], worst[SUMS]);
}

/* A half's bits: to nearest, to even between two; and its value. */
static int half_of(float x)
{
    const double y = fmin(fabs((double)x), 65504);
    const int e = y < 6.103515625e-5 ? -14 : ilogb(y);
    return (signbit(x) ? 0x8000 : 0) + ((e + 14) << 10) + (int)nearbyint(ldexp(y, 10 - e));
}

static double value_of(int half)
{
    const int e = half >> 10 & 31, m = half & 1023;
    return ldexp(e ? m + 1024 : m, (e ? e : 1) - 25) * (half & 0x8000 ? -1 : 1);
}

/* Every half is read as it is, and floats are rounded to it, in languages that have halves and by our own code in those that have not. */
static void twin_halves(void)
{
    static const int dialects[] = { SSGI_GL_330, SSGI_GL_410, SSGI_GL_450, SSGI_GL_300ES };
    static const float odd[] = { 0, -0.0f, 65504, 65519, 65520, 65536, 1e9f, 1e30f, 5.9604645e-8f, 2.9802322e-8f, 2.9802326e-8f, 6.0975552e-5f, 6.1035156e-5f, 6.1005358e-5f, 1, 1e-40f };
    const ssgi_gl_frame frame = { .radius = 1 };
    for (int k = 0; k < 4; ++k) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_BLUR, .colour = SSGI_GL_VECTORS, .packed = 1, .dialect = dialects[k] };
        for (int round = 0; round < 4; ++round) {
            for (int i = 0; i < 4 * MANY; ++i) ins[i] = (float)(4 * MANY * round + i);
            if (!probe(&d, &frame, 0, "uvec4 h = uvec4(a); uvec2 u = h.xz | h.yw << 16u; o = vec4(ssgi_unpack_half(u.x), ssgi_unpack_half(u.y));")) return;
            for (int i = 0; i < 4 * MANY; ++i)
                if (((4 * MANY * round + i) & 0x7c00) != 0x7c00) NEAR(outs[i], value_of(4 * MANY * round + i), 0, "ssgi_unpack_half");
        }
        random_state = 14;
        for (int i = 0; i < 4 * MANY; ++i) {               /* halves, what lies between two and beside that, anything, the odd ones */
            const int h = (int)uniform(0, 0x7bff);
            const float middle = (float)(0.5 * (value_of(h) + value_of(h + 1)));
            const float x[4] = { (float)value_of(h), middle, nextafterf(middle, i & 4 ? 0.0f : 1e9f), powf(10, uniform(-9, 10)) };
            ins[i] = (i < 64 ? odd[i % 16] : x[i & 3]) * (i & 16 ? -1.0f : 1.0f);
        }
        if (!probe(&d, &frame, 0, "uvec2 u = uvec2(ssgi_pack_half(a.xy), ssgi_pack_half(a.zw)); o = vec4(u.x & 65535u, u.x >> 16u, u.y & 65535u, u.y >> 16u);")) return;
        for (int i = 0; i < 4 * MANY; ++i) {
            const float x = ins[i];
            const int got = (int)outs[i];
            CHECK(got == half_of(x), "ssgi_pack_half(%.9g), %s: 0x%04x, to nearest even 0x%04x", (double)x, ssgi_gl_dialect_name(d.dialect), (unsigned)got, (unsigned)half_of(x));
        }
    }
}

/* ---- >>light of a frame ---------------------------------------------------------------------------------------------- */

static void frame_light(void)
{
    static const struct { const char *start; int frame, coefficients, bands; } bad[] = {
        { "frame:", 0, 1, 3 }, { "coefficients:", 1, 0, 3 }, { "bands:", 1, 1, 0 }, { "bands:", 1, 1, 5 }, { "bands:", 1, 1, -1 } };
    ssgi_gl_frame frame, was;
    float c[48], turned[48], m[16];
    const char *why = "";
    memset(&was, 0x5a, sizeof was);
    random_state = 15;
    for (int i = 0; i < 64; ++i) {
        const int bands = 1 + i % 4, matrix = i & 4;
        rigid(m);
        for (int k = 0; k < 48; ++k) c[k] = uniform(-1, 1);
        memset(turned, 0, sizeof turned);
        ssgi_sh_rotate(turned, bands, c, 3, matrix ? m : NULL);
        frame = was;
        CHECK(ssgi_gl_harmonics_set(&frame, c, bands, matrix ? m : NULL, &why) == SSGI_OK, "%s", why);
        for (int k = 0; k < 48; ++k)
            CHECK(fabsf(frame.harmonics[12 * (k / 12) + 4 * (k % 3) + k / 3 % 4] - turned[k]) <= 1e-6f, "%d bands: coefficient %d, channel %d", bands, k / 3, k % 3);
        memcpy(frame.harmonics, was.harmonics, sizeof was.harmonics);
        CHECK(!memcmp(&frame, &was, sizeof was), "other members were written to");
    }
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i)
        CHECK(ssgi_gl_harmonics_set(bad[i].frame ? &frame : NULL, bad[i].coefficients ? c : NULL, bad[i].bands, m, &why) == SSGI_BAD_ARGUMENT && NAMES(why, bad[i].start)
              && !memcmp(&frame, &was, sizeof was), "%s \"%s\", or the frame was written to", bad[i].start, why);
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
        int broken = uniform(0, 1) < 0.5f;
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
        int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO), bad = r != SSGI_OK, stages = 0, there = 0, whole = 1;
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
            const size_t n = ssgi_gl_emit(text, TEXT, &d, stage);
            stages |= (n > 0) << stage;
            there |= (!bad && has_stage(&d, stage)) << stage;
            whole &= !n || (n > (stage == SSGI_GL_VERTEX ? 150 : d.pass == SSGI_GL_SURFELS && stage == SSGI_GL_FRAGMENT ? 60 : 500) && n < TEXT && strlen(text) == n);
        }
        emitted += !bad;
        CHECK(bad ? !rows && !ssgi_gl_key(&d) && !ssgi_gl_field(NULL, 0, &d) : rows > 3 && rows <= SSGI_GL_MAX_IO && ssgi_gl_key(&d) && ssgi_gl_field(NULL, 0, &d),
              "%s: %d rows", bad ? "refused" : describe(&d), rows);
        CHECK(stages == there && whole, "%s: stages %x, of the pass %x, whole: %d", bad ? "refused" : describe(&d), (unsigned)stages, (unsigned)there, whole);
    }
    t_note("%d descs, %d accepted, %d emitted", TRIES, accepted, emitted);
}

static int ascending(const void *a, const void *b) { double x = *(const double *)a, y = *(const double *)b; return (x > y) - (x < y); }

static void speed(void)
{
    enum { RUNS = 2001 };
    static char text[TEXT];
    static double took[RUNS];
    static const ssgi_gl_desc descs[] = { { .samples = 64 }, { .pass = SSGI_GL_HSAO }, { .pass = SSGI_GL_BLUR },
        { .pass = SSGI_GL_SSDO, .environment = SSGI_GL_ENVIRONMENT_MAP, .bounce = SSGI_GL_BOUNCE_PATCH, .layers = 2, .views = 2, .fade = 1, .samples = 64 },
        { .pass = SSGI_GL_S3HO, .transfer = SSGI_GL_TRANSFER_BOTH, .packed = 1, .layers = 2, .views = 2, .fade = 3, .range = 1, .samples = 64 } };
    double us[5];
    for (int k = 0; k < 5; ++k) {
        for (int i = 0; i < RUNS; ++i) {
            double began = kit_seconds();
            ssgi_gl_emit(text, TEXT, &descs[k], SSGI_GL_FRAGMENT);
            took[i] = kit_seconds() - began;
        }
        qsort(took, RUNS, sizeof took[0], ascending);
        us[k] = took[RUNS / 2] * 1e6;
        CHECK(us[k] < (k < 3 ? 50 : 100), "%s: %.1f us", ssgi_gl_pass_name(descs[k].pass), us[k]);
    }
    t_note("ssao of 64 points %.1f us, hsao %.1f us, blur %.1f us; of 64 with all they have: ssdo %.1f us, s3ho %.1f us", us[0], us[1], us[2], us[3], us[4]);
}

void test_text(void)
{
    make_variants();
    speak();
    RUN("the variants tried hold every three choices that matter together, in each pass", covering);
    RUN("every text compiles: each pass, dialect and choice, with Khronos' compiler and Mesa's; a vertex stage of its own links", compilers);
    RUN("emit keeps snprintf's law at every capacity", law);
    RUN("the same desc gives the same bytes, under any locale", same_bytes);
    RUN("rows and declarations agree both ways, and with GL's own places", reflection);
    RUN("what is off leaves nothing", off);
    RUN("every name that any text uses is declared there, and every one declared is used", closed);
    RUN("the functions of fields alone are those of the pass, and declare what they use", toolboxes);
    RUN("text is plain: ASCII, our own names, nothing reserved in any dialect, chunks that C99 takes", lint);
    RUN("every bad field is named, and what was given stays untouched", sentences);
    RUN("defaults written out give the same text, and as many fetches as counted by hand", defaults);
    RUN("extra cameras and shadow maps see what ssgi_view_project says, and lead back", cameras);
    RUN("cameras that are wrong are named, and nothing is written", refused_cameras);
    RUN("a frame's light is the world's, turned, word by word; what is wrong is named, and nothing is written", frame_light);
    if (desktop) {
        RUN("twins: depth, position, projection, footprint and offset as in C", twin_views);
        RUN("twins: noise and kernel as in C, the tile even over every block", twin_noise_and_kernel);
        RUN("twins: normals of every encoding and frame come back", twin_normals);
        RUN("twins: what senders pack comes back, as its format says", twin_senders);
        RUN("twins: an extra camera's points and the octahedral map as in C", twin_views_of_others);
        RUN("twins: harmonics of one to four bands in both languages as in C", twin_harmonics);
        RUN("twins: halves, where the language has them and where it has not", twin_halves);
        RUN("twins: a slice's arc is the integral that it says", twin_arc);
    }
    kit_gl_close();
    RUN("a million random descs: refused with a sentence, or emitted whole", fuzz);
    RUN("a text takes less than 50 microseconds, the longest less than 100", speed);
}
