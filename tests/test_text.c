/* test_text.c - the emitted text, by what any program may call: compilers, snprintf's law, reflection, names,
   sentences, fuzz, speed. */
#include "own.h"
#include "kit/kit_gl.h"

#include <ctype.h>
#include <inttypes.h>
#include <locale.h>
#include <math.h>
#include <pthread.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- >>variants: every two lines of each pass, there and not ----------------------------------------------------- */

/* values first, first + step .. */
typedef struct choice { const char *name; size_t offset; int count, first, step; } choice;
#define CHOICE(field, count, first, step) { #field, offsetof(ssgi_gl_desc, field), count, first, step }
static const choice choices[] = {
    CHOICE(input.orthographic, 2, 0, 1),  CHOICE(input.depth, 3, 0, 1),    CHOICE(input.normal, 5, 0, 1),
    CHOICE(input.world_normals, 2, 0, 1), CHOICE(gather.noise, 2, 0, 1),    CHOICE(gather.steps, 2, 1, 2),
    CHOICE(gather.normal_rays, 2, 0, 2),   CHOICE(gather.thickness, 6, 0, 1),
    CHOICE(gather.terms, 4, 0, 1),         CHOICE(gather.spheres, 2, 0, 1),
    CHOICE(gather.falloff, 3, 0, 1),       CHOICE(gather.kernel, 2, 0, 1),   CHOICE(gather.fade, 3, 0, 1),
    CHOICE(gather.uniform, 2, 0, 1),       CHOICE(gather.range, 2, 0, 1),    CHOICE(gather.layers, 3, 1, 1),
    CHOICE(gather.views, 2, 0, 2),
    CHOICE(gather.view_layers, 2, 1, 1),   CHOICE(light.receiver, 2, 0, 1), CHOICE(light.environment, 3, 0, 1),
    CHOICE(light.bounce, 3, 0, 1),        CHOICE(light.bands, 4, 1, 1),    CHOICE(light.packed, 2, 0, 1),
    CHOICE(light.transfer, 3, 0, 1),      CHOICE(light.shaded, 2, 0, 1),   CHOICE(light.shading, 4, 0, 1),
    CHOICE(light.dimmed, 2, 0, 1),        CHOICE(light.harmonics, 2, 0, 1),
    CHOICE(light.lights, 2, 0, 1),        CHOICE(light.albedo, 2, 0, 1),   CHOICE(light.residual, 2, 0, 1),
    CHOICE(light.two_sided, 2, 0, 1),     CHOICE(light.shadow, 4, 0, 1),   CHOICE(light.accumulate, 2, 0, 1),
    CHOICE(light.bounced, 2, 0, 1),
    CHOICE(light.radiance, 4, 0, 1),      CHOICE(input.objects, 3, 0, 1),  CHOICE(gather.half, 5, 0, 1),
    CHOICE(filter.quantity, 3, 0, 1),        CHOICE(filter.kind, 2, 0, 1),   CHOICE(filter.normals, 2, 0, 1),
    CHOICE(surfel.effect, 6, 0, 1),        CHOICE(surfel.sends, 3, 0, 1),    CHOICE(surfel.near_samples, 2, 1, 3),
    CHOICE(surfel.overhang, 2, 0, 1),      CHOICE(surfel.enlarge, 2, 0, 1),  CHOICE(surfel.combine, 2, 0, 1),
    CHOICE(surfel.axis, 2, 0, 1),          CHOICE(light.restore, 3, 0, 1),  CHOICE(surfel.span, 2, 0, 4),
    CHOICE(input.motion, 2, 0, 1),        CHOICE(input.left_handed, 2, 0, 1), CHOICE(input.oblique, 2, 0, 1),
    CHOICE(input.multisampled, 2, 0, 1),  CHOICE(input.array, 2, 0, 1),    CHOICE(filter.onto, 4, 0, 1),
    CHOICE(input.cap_table, 2, 0, 1),     CHOICE(gather.facets, 2, 0, 1),  CHOICE(gather.lift, 2, 0, 1),
    CHOICE(light.one_sided, 2, 0, 1),     CHOICE(light.clamp, 2, 0, 1),    CHOICE(filter.radius, 2, 1, 1)
};
enum {
    CHOICES = (int)(sizeof choices / sizeof choices[0]),
    MOST = 1 << 12,
    TEXT = 1 << 16,
    TOOLBOX = SSGI_GL_STAGES,
    PROGRAM
};
#define EXTENSION "#extension GL_EXT_samplerless_texture_functions : require\n"
#define PART(c) (isalnum((unsigned char)(c)) || (c) == '_')

static ssgi_gl_desc shape[4 * SSGI_GL_PASSES];            /* the passes; those that have two ways, twice */
static int shapes;
static ssgi_gl_desc variant[MOST];
static int variants;

static int get(const ssgi_gl_desc *d, size_t offset)
{
    int v;
    memcpy(&v, (const char *)d + offset, sizeof v);
    return v;
}
static void set(ssgi_gl_desc *d, size_t offset, int v) { memcpy((char *)d + offset, &v, sizeof v); }

static const char *describe(const ssgi_gl_desc *d)
{
    static _Thread_local char text[1000];
    size_t n = (size_t)snprintf(text, sizeof text, "%s%s%s %s", ssgi_gl_pass_name(d->pass),
                                d->gather.search == SSGI_GL_SEARCH_MARCH    ? " march"
                                : d->gather.search == SSGI_GL_SEARCH_POINTS ? " points"
                                                              : "",
                                d->surfel.tessellate ? " tessellated" : "", ssgi_gl_dialect_name(d->text.dialect));
    for (int k = 0; k < CHOICES; ++k)
        if (get(d, choices[k].offset) != choices[k].first)
            n += (size_t)snprintf(text + n, sizeof text - n, ", %s %d", choices[k].name, get(d, choices[k].offset));
    return text;
}

/* The stages of a pass, a bit each. */
static int stages_of(const ssgi_gl_desc *d)
{
    const int tessellated = d->surfel.tessellate && (d->pass == SSGI_GL_PASS_SURFELS || d->pass == SSGI_GL_PASS_SPLAT);
    return 1 << SSGI_GL_STAGE_VERTEX | 1 << SSGI_GL_STAGE_FRAGMENT
           | (tessellated ? 1 << SSGI_GL_STAGE_TESS_CONTROL | 1 << SSGI_GL_STAGE_TESS_EVALUATION : 0)
           | (tessellated && d->pass == SSGI_GL_PASS_SPLAT ? 1 << SSGI_GL_STAGE_GEOMETRY : 0);
}

/* The text of a stage, "" of one that the pass does not have. */
static const char *emit(char *text, const ssgi_gl_desc *d, int stage)
{
    size_t n = ssgi_gl_emit(text, TEXT, d, stage);
    CHECK((n > 0) == (stages_of(d) >> stage & 1) && n < TEXT && (n || !*text), "%s, stage %d: a text of %zu characters",
          describe(d), stage, n);
    return text;
}

/* Is the vertex stage more than a triangle? */
static int has_vertices(const ssgi_gl_desc *d)
{
    return d->pass == SSGI_GL_PASS_FIELD || d->pass == SSGI_GL_PASS_SURFELS || d->pass == SSGI_GL_PASS_SPLAT;
}

static uint64_t hash_of(const char *text, size_t n)
{
    return kit_hash(KIT_HASH, text, n) | 1;
}

/* A set of hashes: at which place is this one? It is added where it is not there. */
typedef struct set_of { uint64_t hash[1 << 15]; int place[1 << 15], count; } set_of;
static int place_of(set_of *s, uint64_t hash)
{
    size_t i = hash >> 20 & ((1 << 15) - 1);
    while (s->hash[i] && s->hash[i] != hash) i = (i + 1) & ((1 << 15) - 1);
    if (!s->hash[i] && CHECK(s->count < 1 << 14, "more of a kind than this test has room for")) {
        s->hash[i] = hash;
        s->place[i] = s->count++;
    }
    return s->place[i];
}

/* A desc of a shape with choices at random that is accepted. */
static ssgi_gl_desc drawn(int t)
{
    ssgi_gl_desc d = shape[t];
    for (int tries = 0; tries < 4000; ++tries) {
        for (int k = 0; k < CHOICES; ++k)
            set(&d, choices[k].offset,
                choices[k].first + choices[k].step * (int)t_uniform(0, (float)choices[k].count - 0.001f));
        if (ssgi_gl_check(&d, NULL) == SSGI_OK) return d;
    }
    CHECK(0, "%s: nothing is accepted", describe(&shape[t]));
    return shape[t];
}

/* Of a pass: texts drawn, and which of all its lines each has. Lines that are always there together, and those that
   always are or never, count once. */
enum { DRAWN = 2000, WORDS = 16, LITERALS = 64 * WORDS };
typedef struct point { ssgi_gl_desc desc; uint64_t line[WORDS], literal[WORDS]; int gain; } point;
static point pool[DRAWN];
/* pairs of literals that no variant has yet; a literal: 2 * class + whether it is there */
static uint64_t missing[LITERALS][WORDS];

static int bits(uint64_t x)
{
    x -= x >> 1 & 0x5555555555555555u;
    x = (x & 0x3333333333333333u) + (x >> 2 & 0x3333333333333333u);
    return (int)(((x + (x >> 4)) & 0x0f0f0f0f0f0f0f0fu) * 0x0101010101010101u >> 56);
}

/* How many pairs of literals a point brings that are missing; take: they no longer are. */
static int pairs_of(const point *p, int literals, int take)
{
    int fresh = 0;
    for (int a = 0; a < literals; ++a) {
        if (!(p->literal[a / 64] >> a % 64 & 1)) continue;
        for (int w = 0; w <= a / 64; ++w) {
            fresh += bits(missing[a][w] & p->literal[w]);
            if (take) missing[a][w] &= ~p->literal[w];
        }
    }
    return fresh;
}

static int pool_of(int t)
{
    static char text[TEXT];
    static set_of lines, texts;
    int points = 0;
    memset(&lines, 0, sizeof lines);
    memset(&texts, 0, sizeof texts);
    memset(pool, 0, sizeof pool);
    const int draws = t_all() ? DRAWN : DRAWN / 6;
    for (int stale = 0, drawn_ = 0; drawn_ < draws && stale < 300; ++drawn_) {
        point *p = &pool[points];
        p->desc = drawn(t);
        memset(p->line, 0, sizeof p->line);
        uint64_t all = 1;
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage)
            for (const char *line = emit(text, &p->desc, stage), *end; *line; line = end) {
                end = line + strcspn(line, "\n");
                const uint64_t hash = hash_of(line, (size_t)(end - line)) + 2 * (uint64_t)stage;
                end += *end != 0;
                all = (all ^ hash) * 0x9e3779b97f4a7c15u;
                const int at = place_of(&lines, hash);
                if (CHECK(at < LITERALS, "%s: too many lines", describe(&p->desc)))
                    p->line[at / 64] |= (uint64_t)1 << at % 64;
            }
        const int before = texts.count;
        place_of(&texts, all | 1);
        stale = texts.count == before ? stale + 1 : 0;
        points += texts.count > before;
    }
    return points;
}

/* Takes a point as a variant. had: the literals of those taken. */
static void take_point(const point *p, uint64_t had[WORDS])
{
    if (!CHECK(variants < MOST, "more variants than this test has room for")) return;
    variant[variants++] = p->desc;
    for (int w = 0; w < WORDS; ++w) had[w] |= p->literal[w];
}

static int adds_line(const point *p, const uint64_t had[WORDS])
{
    for (int w = 0; w < WORDS; ++w) if (p->literal[w] & ~had[w]) return 1;
    return 0;
}

/* Greedy: of all points that with most pairs that are missing, until the best known brings none; then those with a line
   that none has yet; then as many at random, for what three lines may do together. */
static void make_variants(void)
{
    /* of a line: which points have it, as a sum of random numbers */
    static uint64_t seen[WORDS * 64];
    t_seed(1);
    for (int pass = 0; pass < SSGI_GL_PASSES; ++pass)
        for (int way = 0; way < 3; ++way) {               /* searches, tessellators: where they change the plain text */
            ssgi_gl_desc d = { .pass = pass,
                               .gather.search = way == 1 ? (pass == SSGI_GL_PASS_HSAO ? SSGI_GL_SEARCH_MARCH
                                                                                      : SSGI_GL_SEARCH_POINTS)
                                                         : 0,
                               .surfel.tessellate = way == 2,
                               .text.dialect = way == 2 ? SSGI_GL_DIALECT_410 : SSGI_GL_DIALECT_330,
                               .gather.samples = 4,
                               .gather.directions = 2,
                               .text.fetch = T_FETCH };
            for (int k = 0; k < CHOICES; ++k) set(&d, choices[k].offset, choices[k].first);
            d.light.environment = pass == SSGI_GL_PASS_SSDO ? SSGI_GL_ENVIRONMENT_SH
                                                            : 0; /* else it is refused: no key */
            ssgi_gl_desc other = d;
            other.gather.search = other.surfel.tessellate = 0;
            if (!way || ssgi_gl_key(&d) != ssgi_gl_key(&other)) shape[shapes++] = d;
        }
    for (int t = 0; t < shapes; ++t) {
        const int points = pool_of(t);
        uint64_t kinds[LITERALS], had[WORDS] = { 0 }, all = 0;
        int literals = 0;
        memset(seen, 0, sizeof seen);
        memset(missing, 0, sizeof missing);
        for (int i = 0; i < points; ++i) {
            const uint64_t mark = (uint64_t)(i + 1) * 0x9e3779b97f4a7c15u,
                           many = (mark ^ mark >> 29) * 0xbf58476d1ce4e5b9u;
            all += many;
            for (int l = 0; l < LITERALS; ++l) if (pool[i].line[l / 64] >> l % 64 & 1) seen[l] += many;
        }
        for (int l = 0; l < LITERALS; ++l) {
            int kind = 0;
            if (!seen[l] || seen[l] == all) continue;
            while (kind < literals / 2 && kinds[kind] != seen[l] && kinds[kind] != all - seen[l]) ++kind;
            if (kind < literals / 2) continue;
            if (!CHECK(literals < LITERALS, "%s: too many kinds of lines", describe(&shape[t]))) break;
            kinds[literals / 2] = seen[l];
            for (int i = 0; i < points; ++i) {
                const int at = literals + (int)(pool[i].line[l / 64] >> l % 64 & 1);
                pool[i].literal[at / 64] |= (uint64_t)1 << at % 64;
            }
            literals += 2;
        }
        for (int i = 0; i < points; ++i) {
            pool[i].gain = literals * literals + 1;
            for (int a = 0; a < literals; ++a)
                for (int w = 0; w <= a / 64 && (pool[i].literal[a / 64] >> a % 64 & 1); ++w)
                    missing[a][w] |= pool[i].literal[w];
        }
        const int before = variants;
        /* gains only fall: who was best is asked again */
        for (int most = literals * literals + 1; most > 0 && variants < MOST;) {
            int best = 0, next = 0;
            for (int i = 1; i < points; ++i) if (pool[i].gain > pool[best].gain) best = i;
            for (int i = 0; i < points; ++i) if (i != best && pool[i].gain > next) next = pool[i].gain;
            most = pool[best].gain = pairs_of(&pool[best], literals, 0);
            if (most < next || (!most && literals) || (!literals && variants > before)) continue;
            pairs_of(&pool[best], literals, 1);
            pool[best].gain = 0;
            take_point(&pool[best], had);
            if (!literals) break;
        }
        for (int i = 0; i < points; ++i) if (adds_line(&pool[i], had)) take_point(&pool[i], had);
        for (int more = t_all() ? variants - before : 0; more > 0 && variants < MOST; --more)
            variant[variants++] = pool[(int)t_uniform(0, (float)points - 0.01f)].desc;
    }
}

/* ---- >>compilers ------------------------------------------------------------------------------------------------- */

/* the texts that are compiled; fresh: a program whose stages declare what no other's did */
static struct { ssgi_gl_desc desc; int stage, fresh; } spoken[4 * MOST];
static int texts;
static struct { int texts, linked, vulkan, read; char problem[1000]; } glslang;

static int is_es(const ssgi_gl_desc *d)
{
    return d->text.dialect >= SSGI_GL_DIALECT_300ES && d->text.dialect <= SSGI_GL_DIALECT_320ES;
}

/* The functions of pass FIELD, else those that read the pass's result; 0: it has none. */
static size_t toolbox_of(char *out, size_t capacity, const ssgi_gl_desc *d)
{
    return d->pass == SSGI_GL_PASS_FIELD ? ssgi_gl_field(out, capacity, d) : ssgi_gl_read(out, capacity, d);
}

/* The text of a stage; PROGRAM: of all, one after the other; TOOLBOX: of toolbox_of, in a fragment shader that calls
   it. */
static const char *source_of(char *text, const ssgi_gl_desc *d, int stage)
{
    if (stage == PROGRAM)
        for (int s = 0, at = 0; s < SSGI_GL_STAGES; ++s) at += (int)strlen(emit(text + at, d, s));
    if (stage != TOOLBOX) return stage == PROGRAM ? text : emit(text, d, stage);
    size_t n = strcspn(emit(text, d, SSGI_GL_STAGE_VERTEX), "\n") + 1;      /* the version */
    n += (size_t)snprintf(text + n, TEXT - n, "%s",
                          is_es(d)                       ? "precision highp float;\nprecision highp int;\n"
                          : d->text.dialect == SSGI_GL_DIALECT_VULKAN ? EXTENSION
                                                         : "");
    n += toolbox_of(text + n, TEXT - n, d);
#define READ "gl_FragCoord.xy, z, vec3(0.0, 0.0, 1.0))"
    snprintf(text + n, TEXT - n,
             "layout(location = 0) out vec4 o;\nvoid main()\n{\n    float z = %s;\n    o = vec4(%s);\n}\n",
             strstr(text, " ssgi_fragment_depth(") ? "ssgi_fragment_depth(gl_FragCoord.xy, gl_FragCoord.z)" : "2.0",
             strstr(text, " ssgi_field_visibility(") ? "ssgi_field_visibility(9, 1, gl_FragCoord.xyz, vec3(z))"
             : strstr(text, " ssgi_visibility_at(")  ? "ssgi_visibility_at(" READ
             : strstr(text, " ssgi_irradiance_at(")  ? "ssgi_irradiance_at(" READ ", z"
             : "ssgi_sh_dot(ssgi_coefficients_at(" READ ".c[0], ssgi_coefficients_at(" READ ".c[0]) * "
               "ssgi_ambient(ssgi_coefficients_at(" READ ").x + ssgi_bent(ssgi_coefficients_at(" READ ".c[0])");
    return text;
}

/* Descs may have a text in common, of fields that a pass does not look at: it is compiled once. */
static void each_once(void)
{
    static char text[SSGI_GL_STAGES * TEXT];
    static set_of all;
    int kept = 0;
    for (int i = 0; i < texts; ++i) {
        const char *const source = source_of(text, &spoken[i].desc, spoken[i].stage);
        const int before = all.count;
        place_of(&all, hash_of(source, strlen(source)));
        if (all.count > before || spoken[i].fresh) spoken[kept++] = spoken[i];
    }
    memset(spoken + kept, 0, (size_t)(texts - kept) * sizeof *spoken);     /* more are to follow there */
    texts = kept;
}

/* Gives a desc a dialect of desktop GL, ES or Vulkan; 0: it has none of that kind, as surfels have not for Vulkan. */
static int takes(ssgi_gl_desc *d, int way, int turn)
{
    for (int k = 0; k < 3; ++k) {
        d->text.dialect = way == 2 ? SSGI_GL_DIALECT_VULKAN : way * 3 + (turn + k) % 3;
        if (ssgi_gl_check(d, NULL) == SSGI_OK) return 1;
    }
    return 0;
}

/* Gives a desc sets and dense bindings, others by each number: in Vulkan's dialect, which alone looks at them. */
static void placed(ssgi_gl_desc *d, int number)
{
    d->text.block_set = number % 3;
    d->text.texture_set = number / 3 % 3;
    d->text.dense = number / 9 % 2;
}

/* Every variant in a desktop dialect, in an ES one or in Vulkan's, in turn, of those that it may have; with T_ALL in
   all three: each choice meets each other choice, and each dialect. The stages of their own that passes have as one
   program, and in Vulkan's dialect the first of every pass; the others' vertex stage once a dialect; every toolbox in
   every dialect. */
static void speak(void)
{
    static set_of toolboxes_met;
    static char text[TEXT];
    static uint64_t seen[1 << 10];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    int interfaces = 0;
    for (int i = 0; i < SSGI_GL_DIALECTS; ++i, ++texts) spoken[texts].desc.text.dialect = i;
    for (int i = 0, last = -1; i < 3 * variants; ++i) {
        ssgi_gl_desc d = variant[i / 3];
        const int first = i / 3, way = i % 3;
        int turn = first % 3;                  /* the kind of dialect whose turn it is, if the desc has it */
        for (int k = 0; k < 2 && !takes(&d, turn, first); ++k) turn = (turn + 1) % 3;
        if ((!t_all() && way != turn) || !takes(&d, way, first)) continue;
        d.text.lines = first % 8 == 0;
        d.text.uniforms = first % 5 == 0 && way != 2;
        placed(&d, first);
        const int at = texts++, is = 4 * d.pass + d.gather.search + (d.surfel.tessellate ? 3 : 0);
        spoken[at].desc = d;
        spoken[at].fresh = way == 2 && is != last;
        spoken[at].stage = has_vertices(&d) || spoken[at].fresh ? PROGRAM : SSGI_GL_STAGE_FRAGMENT;
        if (way == 2) last = is;
        if (d.pass != SSGI_GL_PASS_FIELD && toolbox_of(NULL, 0, &d)) {      /* few are fresh */
            const char *const source = source_of(text, &d, TOOLBOX);
            const int before = toolboxes_met.count;
            place_of(&toolboxes_met, hash_of(source, strlen(source)));
            spoken[texts].desc = d;
            spoken[texts].stage = TOOLBOX;
            texts += toolboxes_met.count > before;
        }
        if (!has_vertices(&d)) continue;
        uint64_t hash = (uint64_t)(2 * d.pass + d.surfel.tessellate);
        for (int k = 0, v = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO); k < v; ++k)
            hash =
                (hash ^ hash_of(row[k].name, strlen(row[k].name)) ^ (uint64_t)row[k].kind << 56) * 0x9e3779b97f4a7c15u;
        int s = 0;
        while (s < interfaces && seen[s] != hash) ++s;
        if (way == 2) continue;
        spoken[at].fresh = s == interfaces && (int)(hash >> 40 & 1) == way;     /* one in ES, the next not */
        if (spoken[at].fresh && CHECK(s < 1 << 10, "too many interfaces")) seen[interfaces++] = hash;
    }
    each_once();
    for (int i = 0; i < SSGI_GL_DIALECTS; ++i, ++texts) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_FIELD, .text.dialect = i };
        spoken[texts].desc = d;
        spoken[texts].stage = TOOLBOX;
    }
}

/* Many files a call, as a call takes a fifth of a second; with T_ALL stages are linked where they are fresh (p, w). For
   Vulkan (v, w) only those become SPIR-V: glslang links what it is called with, and refuses to link many texts, but
   reads each first by Vulkan's rules, and that is what is looked at. */
static void *glslang_run(void *folder)
{
    enum { BATCH = 512 };
    static const char *const endings[SSGI_GL_STAGES + 1] = { "vert", "frag", "tesc", "tese", "geom", "frag" };
    static char text[TEXT];
    char path[1000], line[400], problem[400];
    int passed = 1;
    for (int first = 0; first < texts && passed; first += BATCH) {
        for (int i = first; i < first + BATCH && i < texts; ++i, ++glslang.texts) {
            const int program = spoken[i].stage == PROGRAM,
                      vulkan = spoken[i].desc.text.dialect == SSGI_GL_DIALECT_VULKAN,
                      links = t_all() && spoken[i].fresh;
            for (int stage = program ? 0 : spoken[i].stage; stage < (program ? SSGI_GL_STAGES : spoken[i].stage + 1);
                 ++stage) {
                const size_t n = strlen(source_of(text, &spoken[i].desc, stage));
                snprintf(path, sizeof path, "%s/%s%d.%s", (char *)folder,
                         vulkan ? (links ? "w" : "v") : (links ? "p" : ""), i, endings[stage]);
                if (n) kit_file_write(path, text, n, NULL);
                glslang.vulkan += n && vulkan;
            }
            glslang.linked += links;
        }
        snprintf(path, sizeof path,
                 "cd '%s' && ls | grep '^[0-9]' | xargs -r -n 512 -P 2 glslangValidator 2>&1 && "
                 "ls | sed -n 's/^\\(p.*\\).vert$/\\1/p' | xargs -r -P 2 -I{} sh -c 'glslangValidator -l {}.*' 2>&1 && "
                 "ls | grep '^v' | xargs -r -n 128 -P 2 sh -c 'glslangValidator -V \"$@\" 2>&1 | "
                 "grep \"^v[0-9]*[.]\\|^ERROR: v[0-9]\"' sh && "
                 "ls | sed -n 's/^\\(w.*\\).vert$/\\1/p' | xargs -r -P 2 -I{} sh -c 'mkdir d{} && cd d{} && "
                 "glslangValidator -V ../{}.*' 2>&1 && rm -r * && echo passed",
                 (char *)folder);
        FILE *pipe = popen(path, "r");
        for (passed = 0, *problem = 0; pipe && fgets(line, sizeof line, pipe); passed |= !strcmp(line, "passed\n")) {
            const int bad = !strncmp(line, "ERROR", 5);
            const char *at = line + (bad ? 7 : 0);
            at += strncmp(at, "../", 3) ? 0 : 3;           /* a file's name, or that of the last was it */
            glslang.read += !bad && (*at == 'v' || *at == 'w') && isdigit((unsigned char)at[1]);
            at += strchr("pvw", *at) != NULL;
            if (isdigit((unsigned char)*at) && at[strspn(at, "0123456789")] == '.') strcpy(problem, at);
            if (bad && !glslang.problem[0])
                snprintf(glslang.problem, sizeof glslang.problem, "%s%s", describe(&spoken[atoi(problem)].desc),
                         line + 5);
        }
        if (pipe) pclose(pipe);
        if (!passed && !glslang.problem[0]) strcpy(glslang.problem, "no answer");
    }
    return NULL;
}

/* A program of d's stages, with what transform feedback is to keep. */
static GLuint linked(const ssgi_gl_desc *d)
{
    static char text[SSGI_GL_STAGES][TEXT];
    static const GLenum kinds[SSGI_GL_STAGES] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER, GL_TESS_CONTROL_SHADER,
                                                  GL_TESS_EVALUATION_SHADER, GL_GEOMETRY_SHADER };
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
    for (int i = 0, rows = ssgi_gl_reflect(d, row, SSGI_GL_MAX_IO); i < rows; ++i)
        if (row[i].kind == SSGI_GL_IO_CAPTURE
            && CHECK(row[i].slot == keeps && keeps < 3, "%s: %s is at %d of what is kept", describe(d), row[i].name,
                     row[i].slot))
            kept[keeps++] = row[i].name;
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
        const GLuint program = linked(d);
        glDeleteProgram(program);
        return program != 0;
    }
    const char *source = source_of(text, d, stage);
    GLuint shader = glCreateShader(stage == SSGI_GL_STAGE_VERTEX ? GL_VERTEX_SHADER : GL_FRAGMENT_SHADER);
    glShaderSource(shader, 1, &source, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &ok);
    glGetShaderInfoLog(shader, sizeof log, NULL, log);
    glDeleteShader(shader);
    return CHECK(ok, "%s: %s", describe(d), log);
}

static int desktop;                        /* a context of desktop GL is open: from here to the end */

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
        /* takes ES texts too: ARB_ES3_2_compatibility */
        if (version[0] * 10 + version[1] < 32) desktop = CHECK(!kit_gl_open(NULL, &err), "%s", err.text);
        if (version[0] * 10 + version[1] < 32 && !desktop) break;
        for (int i = 0, bad = 0; i < texts && bad < 3; ++i) {
            if (is_es(&spoken[i].desc) != es || spoken[i].desc.text.dialect == SSGI_GL_DIALECT_VULKAN) continue;
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
    t_note("%d texts and programs, %d of these linked: glslangValidator; %d texts by -V", glslang.texts, glslang.linked,
           glslang.vulkan);
    snprintf(line, sizeof line, "rm -rf '%s'", folder);
    CHECK(!system(line), "%s", line);
}

/* ---- >>law: snprintf's ------------------------------------------------------------------------------------------- */

/* Text number k: all stages of some descs, then the functions of harmonics and of fields alone. */
static size_t any_text(int k, char *out, size_t capacity)
{
    static const ssgi_gl_desc descs[] = {
        { .gather.samples = 3 },
        { .pass = SSGI_GL_PASS_SSDO,
          .gather.search = SSGI_GL_SEARCH_POINTS,
          .text.dialect = SSGI_GL_DIALECT_320ES,
          .gather.samples = 2,
          .light.environment = SSGI_GL_ENVIRONMENT_SH,
          .light.bounce = SSGI_GL_BOUNCE_PATCH,
          .gather.views = 1 },
        { .pass = SSGI_GL_PASS_HSAO,
          .gather.thickness = SSGI_GL_THICKNESS_SLABS,
          .text.dialect = SSGI_GL_DIALECT_310ES,
          .text.lines = 1 },
        { .pass = SSGI_GL_PASS_HSAO,
          .gather.search = SSGI_GL_SEARCH_MARCH,
          .gather.normal_rays = 2,
          .gather.noise = SSGI_GL_NOISE_TEXTURE,
          .text.version = "#version 430",
          .text.fetch = "// mine" },
        { .pass = SSGI_GL_PASS_SHADE, .light.lights = 1, .light.packed = 1, .light.transfer = SSGI_GL_TRANSFER_BOTH },
        { .pass = SSGI_GL_PASS_FIELD, .input.objects = SSGI_GL_OBJECTS_TEXTURE, .text.lines = 1 },
        { .pass = SSGI_GL_PASS_SPLAT,
          .text.dialect = SSGI_GL_DIALECT_VULKAN,
          .surfel.tessellate = 1,
          .surfel.sends = SSGI_GL_SENDS_CUSTOM,
          .surfel.effect = SSGI_GL_EFFECT_BOUNCE,
          .text.fetch = "// mine" }
    };
    const int stages = (int)(sizeof descs / sizeof descs[0]) * SSGI_GL_STAGES;
    if (k == stages) return ssgi_gl_field(out, capacity, &descs[5]);
    return k < stages ? ssgi_gl_emit(out, capacity, &descs[k / SSGI_GL_STAGES], k % SSGI_GL_STAGES)
                      : ssgi_gl_sh(out, capacity, k - stages);
}

static void law(void)
{
    static char full[TEXT], part[TEXT], clean[TEXT];
    const ssgi_gl_desc fine = { 0 }, bad = { .gather.steps = 65 };
    size_t n;
    int there = 0;
    memset(clean, 0x5a, sizeof clean);
    memcpy(part, clean, sizeof part);
    for (int k = 0; k < 7 * SSGI_GL_STAGES + 5; ++k, there += n > 0) {
        n = any_text(k, NULL, 0);
        CHECK(any_text(k, full, TEXT) == n && strlen(full) == n, "text %d: the length asked for with NULL differs", k);
        for (size_t capacity = 0; capacity <= n + 1; capacity += capacity < 40 || capacity + 40 > n ? 1 : 97) {
            size_t got = any_text(k, part, capacity), used = capacity > n ? n + 1 : capacity;
            int right = got == n && (!used || (!memcmp(part, full, used - 1) && !part[used - 1]))
                        && !memcmp(part + used, clean, n + 64 - used);
            if (!CHECK(right, "text %d, capacity %zu of %zu: length %zu, or wrong bytes in or beyond it", k, capacity,
                       n, got))
                return;
            memcpy(part, clean, used);
        }
    }
    CHECK(there == 6 * 2 + 5 + 1 + 4, "%d texts", there);   /* stages that passes lack give none */
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
    ssgi_gl_desc a = { .text.version = "#version 330 core\n", .text.fetch = T_FETCH },
                 b = a; /* ssao: the kernel's numbers */
    char version[] = "#version 330 core\n", fetch[] = T_FETCH;
    b.text.version = version;
    b.text.fetch = fetch;
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

/* std140, counted here anew: a type's bytes, and what it is aligned to. */
static size_t std140(const char *type, size_t *align)
{
    const char *array = strchr(type, '[');
    const size_t word = strncmp(type, "float", 5) && strncmp(type, "int", 3)
                            ? strcmp(type, "ivec2") && strcmp(type, "vec2") ? 16 : 8
                            : 4;
    const size_t one = !strncmp(type, "mat3", 4) ? 48 : !strncmp(type, "mat4", 4) ? 64 : word;
    *align = array ? 16 : word;
    return array ? (one + 15) / 16 * 16 * (size_t)atoi(array + 1) : one;
}

/* Reads the declarations back from a stage's text, line by line, and compares them with the rows, in their order where
   one stage has them all. Returns which of them are there: a bit each. */
static uint64_t compare_rows(const char *text, const ssgi_gl_desc *d, const ssgi_gl_io *row, int rows)
{
    const char *end = strstr(text, "\n\n"), *line = strchr(text, '\n') + 1,
               *outside =
                   "uniform \0layout(binding\0layout(std140\0layout(location\0const int \0out vec4 o_\0in vec4 a_\0";
    int es = is_es(d), vulkan = d->text.dialect == SSGI_GL_DIALECT_VULKAN,
        bindings = d->text.dialect == SSGI_GL_DIALECT_450 || d->text.dialect >= SSGI_GL_DIALECT_310ES, block = -1,
        last = -1, precisions = 0, multisampled = 0;
    uint64_t found = 0;
    size_t offset = 0;
    if (!CHECK(end, "%s: no end of the declarations", describe(d))) return 0;
    for (; line < end; line = strchr(line, '\n') + 1) {
        ssgi_gl_io io = { NULL, -1, "int", 0, 0, "", 0, 0 };
        char name[64] = "", type[32] = "", format[300] = "", begin[80] = "", where[40] = "";
        int opened = -1;
        for (int b = 0; b < 2; ++b) {
            for (int k = 0; k < rows; ++k)
                if (row[k].kind == SSGI_GL_IO_PARAM && row[k].slot == b)
                    snprintf(where, sizeof where, vulkan ? ", set = %d, binding = %d" : ", binding = %d",
                             vulkan ? row[k].set : row[k].binding, row[k].binding);
            snprintf(begin, sizeof begin, "layout(std140%s) uniform ssgi_%s {\n", bindings ? where : "",
                     b ? "views" : "frame");
            if (!strncmp(line, begin, strlen(begin))) opened = b;
        }
        if (opened > last && block < 0) { block = last = opened; offset = 0; continue; }
        if (es && !strncmp(line, "precision highp ", 16)) { ++precisions; continue; }
        if (vulkan && !strncmp(line, EXTENSION, strlen(EXTENSION))) continue;
        if (!strncmp(line, "};", 2)) { block = -1; continue; }
        if (block >= 0 && sscanf(line, "    %31s %63[^;]; // %299[^\n]", type, name, format) >= 2) {
            const char *array = strchr(name, '[');
            size_t align, size;
            if (!strncmp(name, "u_ssgi_gap", 10) && array) strcat(type, array);
            size = std140(type, &align);
            offset = (offset + align - 1) / align * align;
            io.kind = SSGI_GL_IO_PARAM;
            io.slot = block;
            io.offset = offset;
            offset += size;
            if (!strncmp(name, "u_ssgi_gap", 10)) continue;
        } else if (sscanf(line, "const int %63s = %d;", name, &io.slot) == 2
                   || (vulkan
                       && sscanf(line, "layout(constant_id = %zu) const int %63s = %d;", &io.offset, name, &io.slot)
                              == 3)) {
            io.kind = SSGI_GL_IO_CONSTANT;
            strcpy(type, "int");
        } else if (sscanf(line, "layout(location = %d) %9s %31s %63[^;]; // %299[^\n]", &io.slot, begin, type, name,
                          format)
                   == 5) {
            if (vulkan && *name == 'v') continue;          /* between stages */
            io.kind = strcmp(begin, "in") ? SSGI_GL_IO_OUTPUT : SSGI_GL_IO_ATTRIBUTE;
        }
        else if (sscanf(line, "out %31s %63[^;]; // %299[^\n]", type, name, format) == 3) {
            if (d->pass == SSGI_GL_PASS_SPLAT) continue;        /* it goes to the next stage, nothing keeps it */
            io.kind = SSGI_GL_IO_CAPTURE;
        } else if (vulkan ? sscanf(line, "layout(set = %d, binding = %d) uniform %31s %63[^;]; // %299[^\n]", &io.set,
                                   &io.binding, type, name, format)
                                == 5
                   : bindings ? sscanf(line, "layout(binding = %d) uniform %31s %63[^;]; // %299[^\n]", &io.slot, type,
                                       name, format)
                                    == 4
                              : sscanf(line, "%63s %31s %63[^;]; // %299[^\n]", begin, type, name, format) == 4
                                    && !strcmp(begin, "uniform")) {
            io.kind = SSGI_GL_IO_TEXTURE;
        }
        multisampled |= !strcmp(type, "sampler2DMS");
        int at = 0;
        while (at < rows && (found >> at & 1 || (has_vertices(d) && strcmp(row[at].name, name)))) ++at;
        int same = at < rows && row[at].kind == io.kind && !strcmp(row[at].name, name) && !strcmp(row[at].type, type)
                && !strcmp(row[at].format, format) && row[at].offset == io.offset
                && (io.kind == SSGI_GL_IO_TEXTURE && vulkan ? row[at].set == io.set && row[at].binding == io.binding
                    : row[at].slot == io.slot || (io.kind == SSGI_GL_IO_TEXTURE && !bindings)
                          || io.kind == SSGI_GL_IO_CAPTURE);
        if (!CHECK(same, "%s: \"%.*s\" is not row %d, %s", describe(d), (int)strcspn(line, "\n"), line, at,
                   at < rows ? row[at].name : "none"))
            return 0;
        found |= (uint64_t)1 << at;
    }
    for (const char *w = outside; *w; w += strlen(w) + 1) {
        char start[16] = "\n";
        CHECK((vulkan && !strcmp(w, "layout(location")) || !strstr(end, strcat(start, w)),
              "%s: a declaration after the declarations: %s", describe(d), w);
    }
    CHECK(precisions == (es ? 6 + multisampled : 0), "%s: %d precisions", describe(d), precisions);
    return found;
}

/* What GL says of a linked program: places in the block, bindings without a call, every texture is read. */
static int ask_gl(const ssgi_gl_desc *d, const ssgi_gl_io *row, int rows)
{
    static const struct {
        const char *name;
        size_t most;
    } blocks[] = { { "ssgi_frame", sizeof(ssgi_gl_frame) }, { "ssgi_views", sizeof(ssgi_gl_views) } };
    GLuint program = linked(d);
    if (!program) return 0;
    for (int b = 0; b < 2; ++b) {
        const GLuint block = glGetUniformBlockIndex(program, blocks[b].name);
        GLint size = 0, binding = -1;
        int wanted = 0;
        for (int i = 0; i < rows; ++i) wanted |= row[i].kind == SSGI_GL_IO_PARAM && row[i].slot == b;
        CHECK((block != GL_INVALID_INDEX) == wanted, "%s: %s is %s", describe(d), blocks[b].name,
              wanted ? "missing" : "there");
        if (block == GL_INVALID_INDEX) continue;
        glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_DATA_SIZE, &size);
        glGetActiveUniformBlockiv(program, block, GL_UNIFORM_BLOCK_BINDING, &binding);
        CHECK(binding == b && size > 0 && (size_t)size <= blocks[b].most, "%s: %s of %d bytes at %d", describe(d),
              blocks[b].name, size, binding);
    }
    for (int i = 0; i < rows; ++i) {
        GLuint index = GL_INVALID_INDEX;
        GLint value = -1, want = row[i].slot;
        if (row[i].kind == SSGI_GL_IO_CONSTANT || row[i].kind == SSGI_GL_IO_ATTRIBUTE
            || row[i].kind == SSGI_GL_IO_CAPTURE)
            continue;
        if (row[i].kind == SSGI_GL_IO_PARAM) {
            want = (GLint)row[i].offset;
            glGetUniformIndices(program, 1, &row[i].name, &index);
            if (index != GL_INVALID_INDEX) glGetActiveUniformsiv(program, 1, &index, GL_UNIFORM_OFFSET, &value);
        } else if (row[i].kind == SSGI_GL_IO_OUTPUT) value = glGetFragDataLocation(program, row[i].name);
        else if (glGetUniformLocation(program, row[i].name) >= 0)
            glGetUniformiv(program, glGetUniformLocation(program, row[i].name), &value);
        /* light of one band is the same for all normals, as GL's compilers find out */
        if (value < 0 && ssgi_gl_resolve(d).light.bands == 1 && row[i].kind == SSGI_GL_IO_TEXTURE && row[i].slot < 2)
            continue;
        CHECK(value == want, "%s: %s is at %d for GL, the row says %d", describe(d), row[i].name, value, want);
    }
    glDeleteProgram(program);
    return 1;
}

/* A texture has one unit, 0 to 15, in every variant of a pass, and textures of a variant have different ones. */
static void check_units(const ssgi_gl_desc *d, const ssgi_gl_io *row, int rows)
{
    static struct { const char *name; int slot; } units[SSGI_GL_PASSES][64];
    int taken = 0;
    for (int k = 0, u = 0; k < rows; ++k, u = 0) {
        if (row[k].kind != SSGI_GL_IO_TEXTURE) continue;
        while (units[d->pass][u].name && strcmp(units[d->pass][u].name, row[k].name)) ++u;
        if (!units[d->pass][u].name) { units[d->pass][u].name = row[k].name; units[d->pass][u].slot = row[k].slot; }
        CHECK(row[k].slot == units[d->pass][u].slot && row[k].slot >= 0 && row[k].slot < 16
                  && !(taken >> row[k].slot & 1),
              "%s: %s at unit %d, else at %d, units taken %x", describe(d), row[k].name, row[k].slot,
              units[d->pass][u].slot, (unsigned)taken);
        taken |= 1 << row[k].slot;
    }
}

static void reflection(void)
{
    static char text[SSGI_GL_STAGES][TEXT];
    static uint64_t seen[1 << 12];
    ssgi_gl_io row[SSGI_GL_MAX_IO], read[SSGI_GL_MAX_IO], few[2];
    int asked = 0, pairs = 0, read_back = 0;
    for (int i = 0; i < variants * SSGI_GL_DIALECTS; ++i) {
        ssgi_gl_desc d = variant[i / SSGI_GL_DIALECTS];
        d.text.dialect = i % SSGI_GL_DIALECTS;
        placed(&d, i / SSGI_GL_DIALECTS);
        if (!t_all() && i % 3) continue;    /* the dialects in turn, as their number is no multiple of 3 */
        if (ssgi_gl_check(&d, NULL) != SSGI_OK) continue;  /* no tessellation there */
        const int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO), before = pairs;
        uint64_t params[2] = { 0, 0 }, once = 0, twice = 0;
        check_units(&d, row, rows);
        for (int k = 0, slots[SSGI_GL_IO_CAPTURE + 1] = { 0 }; k < rows; ++k) {
            if (row[k].kind == SSGI_GL_IO_PARAM) params[row[k].slot] |= (uint64_t)1 << k;
            CHECK(row[k].kind == SSGI_GL_IO_PARAM || row[k].kind == SSGI_GL_IO_CONSTANT
                      || row[k].kind == SSGI_GL_IO_TEXTURE || row[k].slot == slots[row[k].kind],
                  "%s: %s is at %d, not at %d", describe(&d), row[k].name, row[k].slot, slots[row[k].kind]);
            ++slots[row[k].kind];
        }
        /* the stages have whole blocks in common, and nothing else */
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
            if (!*emit(text[stage], &d, stage)) continue;
            const uint64_t found = compare_rows(text[stage], &d, row, rows);
            int whole = 1;
            for (int b = 0; b < 2; ++b)
                whole &= (found & params[b])
                         == (strstr(text[stage], b ? "u_ssgi_view_" : "uniform ssgi_frame") ? params[b] : 0);
            if (!CHECK(whole, "%s, stage %d: a part of a block: %" PRIx64, describe(&d), stage, found)) break;
            twice |= once & found & ~params[0] & ~params[1];
            once |= found;
            ++read_back;
        }
        if (!CHECK(once == ((uint64_t)1 << rows) - 1 && !twice,
                   "%s: of %d rows the stages declare %" PRIx64 ", twice %" PRIx64, describe(&d), rows, once, twice))
            break;
        if (d.text.dialect != SSGI_GL_DIALECT_450 || !desktop) continue;
        uint64_t last = (uint64_t)d.pass;
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage)
            /* GL is asked where two lines are together first */
            for (const char *line = *text[stage] ? strchr(text[stage], '\n') + 1 : "\n"; *line != '\n';
                 line += strcspn(line, "\n") + 1) {
                uint64_t two = last * 31;
                int s = 0;
                last = kit_hash(KIT_HASH, line, strcspn(line, "\n"));
                two ^= last;
                while (s < pairs && seen[s] != two) ++s;
                if (s == pairs && CHECK(pairs < 1 << 12, "too many pairs of lines")) seen[pairs++] = two;
            }
        if (pairs == before) continue;
        ++asked;
        if (!ask_gl(&d, row, rows)) break;
        few[1] = row[3];
        CHECK(ssgi_gl_reflect(&d, few, 1) == rows && few[0].name == row[0].name && few[1].name == row[3].name,
              "more rows than there is room for");
    }
    t_note("%d texts read back, %d linked for %d different pairs of lines", read_back, asked, pairs);
    /* what s3ho writes is what blur reads, in order, name, type and format */
    for (int k = 0; k < 4 * 2 * 3; ++k) {
        ssgi_gl_desc d = { .pass = SSGI_GL_PASS_S3HO,
                           .light.bands = 1 + k % 4,
                           .light.packed = k / 4 % 2,
                           .light.transfer = k / 8 },
                     blur = d;
        blur.pass = SSGI_GL_PASS_BLUR;
        blur.filter.quantity = SSGI_GL_QUANTITY_COEFFICIENTS;
        const int targets = d.light.packed    ? (d.light.transfer ? 3 : 1) * (d.light.bands > 2 ? 2 : 1)
                          : d.light.bands < 3 ? 1
                                              : d.light.bands;
        const int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO), reads = ssgi_gl_reflect(&blur, read, SSGI_GL_MAX_IO);
        int written = 0, found = 0;
        for (int i = 0, b = 0; i < rows; ++i) {
            if (row[i].kind != SSGI_GL_IO_OUTPUT) continue;
            while (b < reads && strcmp(read[b].name + 1, row[i].name + 1)) ++b;
            found += b < reads && read[b].kind == SSGI_GL_IO_TEXTURE && !strcmp(read[b].format, row[i].format)
                     && !strcmp(read[b].type, d.light.packed ? "usampler2D" : "sampler2D")
                     && !strcmp(row[i].type, d.light.packed ? "uvec4" : "vec4") && row[i].slot == written;
            ++written;
        }
        CHECK(d.light.transfer && !d.light.packed ? !rows && !reads : written == targets && found == targets,
              "%d bands, packed %d, transfer %d: %d targets, %d of them read", d.light.bands, d.light.packed,
              d.light.transfer, written, found);
    }
    emit(text[0], variant, SSGI_GL_STAGE_VERTEX);
    CHECK(!strstr(text[0], "ssgi") && !strstr(text[0], "uniform") && !strstr(text[0], "layout"),
          "the vertex stage declares something");
    CHECK(!ssgi_gl_reflect(NULL, row, 1) && !ssgi_gl_reflect(variant, NULL, 1) && ssgi_gl_reflect(variant, NULL, 0) > 0,
          "reflection of nothing");
}

/* Loose uniforms: the text is that with blocks, but for a line each of the members that the stage reads; the rows are
   the same. */
static void loose_uniforms(void)
{
    static char text[TEXT], want[TEXT], got[TEXT];
    ssgi_gl_io row[2][SSGI_GL_MAX_IO];
    int read = 0, same = 1;
    for (int i = 0; i < variants && same; ++i) {
        ssgi_gl_desc d = variant[i], loose;
        if (!takes(&d, i & 1, i)) continue;
        loose = d;
        loose.text.uniforms = SSGI_GL_UNIFORMS_LOOSE;
        const int rows = ssgi_gl_reflect(&d, row[0], SSGI_GL_MAX_IO),
                  others = ssgi_gl_reflect(&loose, row[1], SSGI_GL_MAX_IO);
        for (int k = 0; k < rows && others == rows; ++k) {
            const ssgi_gl_io *const a = &row[0][k], *const b = &row[1][k];
            same &= !strcmp(a->name, b->name) && a->kind == b->kind && !strcmp(a->type, b->type) && a->slot == b->slot
                    && a->offset == b->offset && !strcmp(a->format, b->format);
        }
        CHECK(rows == others && same, "%s: loose uniforms have other rows", describe(&d));
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
            size_t n = 0;
            int inside = 0;
            emit(text, &d, stage);
            for (const char *line = text, *end; *line; line = end) {
                const size_t length = strcspn(line, "\n") + 1;
                char name[64], type[32];
                end = line + length;
                if (strstr(line, "uniform ssgi_") && strstr(line, "uniform ssgi_") < end) { inside = 1; continue; }
                if (inside && !strncmp(line, "};", 2)) { inside = 0; continue; }
                if (inside && sscanf(line, " %31s %63[a-z_]", type, name) == 2) {
                    const char *at = strchr(line, '\n');
                    while ((at = strstr(at, name)) != NULL && PART(at[strlen(name)])) ++at;
                    if (!at) continue;                     /* a gap, or a member of another stage */
                    n += (size_t)snprintf(want + n, TEXT - n, "uniform ");
                    line += strspn(line, " ");
                }
                n += (size_t)snprintf(want + n, TEXT - n, "%.*s", (int)(end - line), line);
            }
            want[n] = 0;
            emit(got, &loose, stage);
            size_t at = 0;
            while (got[at] && got[at] == want[at]) ++at;
            same &= CHECK(got[at] == want[at], "%s, stage %d: with loose uniforms it has \"%.60s\", not \"%.60s\"",
                          describe(&d), stage, got + at, want + at);
            read += strstr(got, "uniform float u_ssgi_radius;") != NULL;
        }
    }
    CHECK(read > variants / 8, "%d texts read u_ssgi_radius", read);
    t_note("%d texts with a loose u_ssgi_radius", read);
}

/* ---- >>vulkan ---------------------------------------------------------------------------------------------------- */

/* The name that a declaration at `at` ends with, before ; [ or {. */
static int name_of(char name[64], const char *at)
{
    const char *end = at + strcspn(at, ";[{\n"), *start;
    while (end > at && !PART(end[-1])) --end;
    for (start = end; start > at && PART(start[-1]);) --start;
    return snprintf(name, 64, "%.*s", (int)(end - start), start) > 0;
}

/* Bindings and locations of a program's text, as any reader may count them: bound[s][b] is the name of binding b of set
   s, passed[s][l] of what stage s hands on at location l. */
typedef struct places { char bound[3][32][64], passed[SSGI_GL_STAGES][32][64]; int count; } places;

static int read_places(places *p, const char *text, const ssgi_gl_desc *d, int stage, int before)
{
    char name[64];
    for (const char *at = text; (at = strstr(at, "layout(")) != NULL; ++at) {
        const char *binding = strstr(at, "binding = "), *location = strstr(at, "location = "),
                   *end = at + strcspn(at, ")");
        if (binding && binding < end) {
            const int b = atoi(binding + strlen("binding = ")), set = binding[-3] - '0',
                      is = !strncmp(binding - 9, "set = ", 6) && set >= 0 && set < 3 && b >= 0 && b < 32;
            if (!CHECK(is && name_of(name, end) && (!*p->bound[set][b] || !strcmp(p->bound[set][b], name)),
                       "%s, stage %d: %.*s: %s is at that binding", describe(d), stage, (int)strcspn(at, "\n"), at,
                       is ? p->bound[set][b] : "none"))
                return 0;
            p->count += !*p->bound[set][b];
            strcpy(p->bound[set][b], name);
        } else if (location && location < end && name_of(name, end) && *name == 'v') {
            const char *array = end + strcspn(end, ";["), *in = strstr(end, "in ");
            const int l = atoi(location + strlen("location = ")), many = *array == '[' ? atoi(array + 1) : 1;
            if (in && in < array) {
                if (!CHECK(l < 32 && before >= 0 && !strcmp(p->passed[before][l], name),
                           "%s, stage %d: %s is read at location %d, where %s is", describe(d), stage, name, l,
                           l < 32 && before >= 0 ? p->passed[before][l] : "nothing"))
                    return 0;
                continue;
            }
            for (int k = l; k < l + (many ? many : 1); ++k) {
                if (!CHECK(k < 32 && !*p->passed[stage][k], "%s, stage %d: %s and %s at location %d", describe(d),
                           stage, name, k < 32 ? p->passed[stage][k] : "none", k))
                    return 0;
                strcpy(p->passed[stage][k], name);
            }
        }
    }
    for (const char *at = text; (at = strstr(at, "_ssgi_")) != NULL; ++at)     /* every one has its place */
        if (at > text && strchr("uotav", at[-1]) && (at - text < 2 || !PART(at[-2]))) {
            const char *line = at;
            while (line > text && line[-1] != '\n') --line;
            if (strncmp(line, "uniform ", 8) && strncmp(line, "in ", 3) && strncmp(line, "out ", 4)
                && strncmp(line, "flat ", 5) && strncmp(line, "patch ", 6))
                continue;
            return CHECK(0, "%s, stage %d: has no place: %.*s", describe(d), stage, (int)strcspn(line, "\n"), line);
        }
    return CHECK(!strstr(text, "sampler2D") && !strstr(text, "gl_VertexID") && !strstr(text, "gl_InstanceID"),
                 "%s, stage %d: has words of GL", describe(d), stage);
}

/* By the rules of the header: blocks at 0 and 1, the texture of unit u at 2 + u; or dense, from 0 on in each set, first
   the blocks, then the textures in the order of the rows. No two are at one place; stages read what they are handed
   where it is. */
static void bindings(void)
{
    static char text[TEXT];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    int tried = 0, told = 0;
    for (int i = 0; i <= variants; ++i) {
        /* in the order of the pipeline; the last is of fields alone */
        static const int order[SSGI_GL_STAGES] = { SSGI_GL_STAGE_VERTEX, SSGI_GL_STAGE_TESS_CONTROL,
                                                   SSGI_GL_STAGE_TESS_EVALUATION, SSGI_GL_STAGE_GEOMETRY,
                                                   SSGI_GL_STAGE_FRAGMENT };
        static places p;
        ssgi_gl_desc d = variant[i < variants ? i : 0];
        int before = -1, rows, blocks[2] = { 0, 0 }, textures = 0;
        d.text.dialect = SSGI_GL_DIALECT_VULKAN;
        placed(&d, i < variants ? i : 0);
        if (ssgi_gl_check(&d, NULL) != SSGI_OK) continue;  /* surfels */
        memset(&p, 0, sizeof p);
        if (i == variants) {
            d.pass = SSGI_GL_PASS_FIELD;
            d.input.cap_table = 1;
            CHECK(read_places(&p, source_of(text, &d, TOOLBOX), &d, TOOLBOX, -1) && p.count == 3
                      && !strcmp(p.bound[0][4], "t_ssgi_occluders") && !strcmp(p.bound[0][6], "t_ssgi_fields")
                      && !strcmp(p.bound[0][7], "t_ssgi_cap"),
                  "fields alone: %s, %s, %s, %d in all", p.bound[0][4], p.bound[0][6], p.bound[0][7], p.count);
            break;
        }
        for (int k = 0; k < SSGI_GL_STAGES; ++k)
            if (*emit(text, &d, order[k])) {
                if (!read_places(&p, text, &d, order[k], before)) return;
                before = order[k];
            }
        rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO);
        for (int k = 0; k < rows; ++k) {
            const int kind = row[k].kind, texture = kind == SSGI_GL_IO_TEXTURE;
            const char *wanted = texture ? row[k].name : row[k].slot ? "ssgi_views" : "ssgi_frame";
            if (!texture && kind != SSGI_GL_IO_PARAM) continue;
            if (!texture) blocks[row[k].slot] = 1;         /* the rows of a block come before all textures' */
            const int set = texture ? d.text.texture_set : d.text.block_set, first = blocks[0] + blocks[1],
                      at = !d.text.dense ? row[k].slot + (texture ? 2 : 0)
                           : !texture    ? first - 1
                                         : textures + (d.text.block_set == set ? first : 0);
            if (!CHECK(row[k].set == set && row[k].binding == at && !strcmp(p.bound[set][at], wanted),
                       "%s: %s of slot %d is not at %d of set %d, where it should be; its row says %d of %d",
                       describe(&d), wanted, row[k].slot, at, set, row[k].binding, row[k].set))
                return;
            textures += texture;
        }
        CHECK(p.count == textures + blocks[0] + blocks[1], "%s: %d bindings for %d textures and %d blocks",
              describe(&d), p.count, textures, blocks[0] + blocks[1]);
        told += p.count;
        ++tried;
    }
    CHECK(tried > 9 * variants / 10, "only %d of %d have this dialect", tried, variants);
    t_note("%d bindings of %d programs", told, tried);
}

/* The set and the binding of a name in SPIR-V, 100 * set + binding; -1: it has none. */
static int place_in(const uint32_t *word, size_t words, const char *name)
{
    enum { NAME = 5, DECORATE = 71, VARIABLE = 59, POINTER = 32, BINDING = 33, SET = 34 };
    uint32_t id = 0, type = 0, variable = 0;
    int set = -1, binding = -1;
    /* A block's name is that of its type, as it has no instance name. Variables come after names and decorations. */
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

/* What glslang makes of texts for Vulkan has the sets and bindings of the rows, and of the steps' inputs. */
static void places_in_spirv(void)
{
    static const struct { const char *name, *first; int frame, texture; } row[] = {
        { "hsao,block_set=3,texture_set=2,dense=1,depth=linear", "t_ssgi_depth", 300, 200 },
        { "ssao,dense=1,blur=0", "t_ssgi_depth", 0, 1 },
        { "ssao,block_set=1,views=1,blur=0", "t_ssgi_views", 100, 6 } };
    static char text[TEXT];
    char folder[] = "/tmp/ssgi-text-XXXXXX", path[100], line[300];
    int told = 0;
    if (!CHECK(mkdtemp(folder), "no folder in /tmp")) return;
    snprintf(path, sizeof path, "%s/a.frag", folder);
    for (size_t i = 0; i < sizeof row / sizeof *row; ++i) {
        static ssgi_gl_step step[SSGI_GL_MAX_STEPS];
        ssgi_gl_io io[SSGI_GL_MAX_IO];
        ssgi_gl_chain chain;
        const char *why = "";
        if (!CHECK(ssgi_gl_chain_of(&chain, row[i].name, &why) == SSGI_OK, "%s: %s", row[i].name, why)) break;
        chain.width = chain.height = 64;
        chain.desc.text.dialect = SSGI_GL_DIALECT_VULKAN;
        const int steps = ssgi_gl_steps(step, SSGI_GL_MAX_STEPS, &chain, &why);
        CHECK(steps > 0, "%s: %s", row[i].name, why);
        for (int s = 0; s < steps; ++s) {
            char *spirv;
            size_t size;
            emit(text, &step[s].desc, SSGI_GL_STAGE_FRAGMENT);
            snprintf(line, sizeof line, "cd '%s' && glslangValidator -V -o a.spv a.frag >/dev/null", folder);
            if (!CHECK(!kit_file_write(path, text, strlen(text), NULL) && !system(line), "%s", line)) break;
            snprintf(line, sizeof line, "%s/a.spv", folder);
            if (!CHECK(!kit_file_read(&spirv, &size, line, NULL), "%s cannot be read", line)) break;
            const uint32_t *const word = (const uint32_t *)(void *)spirv;
            for (int k = 0, n = ssgi_gl_reflect(&step[s].desc, io, SSGI_GL_MAX_IO); k < n; ++k) {
                const int texture = io[k].kind == SSGI_GL_IO_TEXTURE;
                const char *name = texture ? io[k].name : io[k].slot ? "ssgi_views" : "ssgi_frame";
                if (!texture && io[k].kind != SSGI_GL_IO_PARAM) continue;
                const int at = place_in(word, size / 4, name);
                CHECK(at == 100 * io[k].set + io[k].binding, "%s, step %d: %s is at %d in SPIR-V, its row says %d, %d",
                      row[i].name, s, name, at, io[k].set, io[k].binding);
                ++told;
            }
            for (int k = 0; k < step[s].inputs; ++k) {
                const ssgi_gl_input *const in = &step[s].input[k];
                const int at = place_in(word, size / 4, in->name);
                CHECK(at == 100 * in->set + in->binding
                          && (!chain.desc.text.dense || in->binding == k + (in->set ? 0 : 1)),
                      "%s, step %d: input %d, %s, is at %d in SPIR-V, it says %d, %d", row[i].name, s, k, in->name, at,
                      in->set, in->binding);
            }
            const int frame = place_in(word, size / 4, "ssgi_frame"),
                      texture = place_in(word, size / 4, row[i].first);
            CHECK(frame == row[i].frame && (s || texture == row[i].texture), "%s, step %d: ssgi_frame at %d, %s at %d",
                  row[i].name, s, frame, row[i].first, texture);
            free(spirv);
        }
    }
    t_note("%d rows at their places", told);
    snprintf(line, sizeof line, "rm -rf '%s'", folder);
    CHECK(!system(line), "%s", line);
}

/* Is `what` with this number, and then something that is none, in the text? */
static int has_place(const char *text, const char *what, int number)
{
    char key[64];
    const int n = snprintf(key, sizeof key, what, number);
    for (; (text = strstr(text, key)) != NULL; ++text) if (!isdigit((unsigned char)text[n])) return 1;
    return 0;
}

/* examples/tools/glsl/translate.sh: in every language every texture is at its binding, and vertex stages turn y. */
static void translated(void)
{
    static const struct { const char *ending, *texture, *turned, *has;
    } into[] = { { "wgsl", "@group(0) @binding(%d) var t_ssgi_", "gl_Position.y = -(",
                   "test -s build/tint/twgsl.wasm && command -v node || ! echo tint: make glsl WGSL=1 brings it" },
                 { "hlsl", "register(t%d);", "gl_Position.y = -",
                   "command -v spirv-cross || ! echo spirv-cross: apt-get install spirv-cross" },
                 { "msl", "[[texture(%d)]]", "gl_Position.y = -",
                   "command -v spirv-cross || ! echo spirv-cross: apt-get install spirv-cross" } };

    static const ssgi_gl_desc descs[] = { { .pass = SSGI_GL_PASS_HSAO },
                                          { .pass = SSGI_GL_PASS_SSDO,
                                            .light.environment = SSGI_GL_ENVIRONMENT_MAP,
                                            .light.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE },
                                          { .pass = SSGI_GL_PASS_S3HO },
                                          { .pass = SSGI_GL_PASS_BLUR, .text.dense = 1 },
                                          { .pass = SSGI_GL_PASS_HISTORY },
                                          { .pass = SSGI_GL_PASS_FIELD },
                                          { .pass = SSGI_GL_PASS_SPLAT } };
    enum { DESCS = (int)(sizeof descs / sizeof descs[0]) };
    static char text[TEXT];
    char folder[] = "/tmp/ssgi-text-XXXXXX", path[300], line[400], to[40] = "";
    int has[3];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    if (!CHECK(mkdtemp(folder), "no folder in /tmp")) return;
    for (int i = 0; i < 2 * DESCS; ++i) {
        ssgi_gl_desc d = descs[i / 2];
        d.text.dialect = SSGI_GL_DIALECT_VULKAN;
        snprintf(path, sizeof path, "%s/%s.vulkan.%s", folder, ssgi_gl_pass_name(d.pass), i % 2 ? "frag" : "vert");
        emit(text, &d, i % 2 ? SSGI_GL_STAGE_FRAGMENT : SSGI_GL_STAGE_VERTEX);
        CHECK(!kit_file_write(path, text, strlen(text), NULL), "%s cannot be written", path);
    }
    for (int k = 0; k < 3; ++k) {
        FILE *pipe = popen(into[k].has, "r");
        if (pipe && !fgets(line, sizeof line, pipe)) *line = 0;
        has[k] = pipe && !pclose(pipe);
        if (has[k]) snprintf(to + strlen(to), sizeof to - strlen(to), " %s", into[k].ending);
        else t_note("%s skipped, without %.*s", into[k].ending, (int)strcspn(line, "\n"), line);
    }
    if (*to) {
        snprintf(path, sizeof path, "sh examples/tools/glsl/translate.sh %s%s 2>&1", folder, to);
        FILE *pipe = popen(path, "r");
        while (pipe && fgets(line, sizeof line, pipe)) CHECK(strstr(line, " 14 of 14\n"), "%s", line);
        CHECK(pipe && !pclose(pipe), "%s: fails", path);
    }
    for (int k = 0; k < 3; ++k) {
        int textures = 0;
        if (!has[k]) continue;
        for (int i = 0; i < 2 * DESCS; ++i) {
            ssgi_gl_desc d = descs[i / 2];
            char *got;
            size_t size;
            d.text.dialect = SSGI_GL_DIALECT_VULKAN;
            snprintf(path, sizeof path, "%s/%s.vulkan.%s.%s", folder, ssgi_gl_pass_name(d.pass),
                     i % 2 ? "frag" : "vert", into[k].ending);
            if (!CHECK(!kit_file_read(&got, &size, path, NULL), "%s is missing", path)) continue;
            CHECK(i % 2 || strstr(got, into[k].turned), "%s: y is not turned", path);
            emit(text, &d, i % 2 ? SSGI_GL_STAGE_FRAGMENT : SSGI_GL_STAGE_VERTEX);
            for (int r = 0, rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO); r < rows; ++r) {
                if (row[r].kind != SSGI_GL_IO_TEXTURE || !strstr(text, row[r].name)) continue;
                CHECK(has_place(got, into[k].texture, row[r].binding), "%s: nothing at the place of %s", path,
                      row[r].name);
                ++textures;
            }
            free(got);
        }
        CHECK(textures > 15, "%s: %d textures", into[k].ending, textures);
        t_note("%s: %d texts, %d textures at their bindings", into[k].ending, 2 * DESCS, textures);
    }
    snprintf(line, sizeof line, "rm -rf '%s'", folder);
    CHECK(!system(line), "%s", line);
}

/* ---- >>names ----------------------------------------------------------------------------------------------------- */

enum { NAMES_ = 512 };
typedef struct names { uint64_t bit[NAMES_ / 64]; } names;
static char known[NAMES_][48];
static set_of knowns;

static void name_add(names *to, const char *word, size_t n)
{
    const int i = place_of(&knowns, hash_of(word, n));
    if (!CHECK(i < NAMES_ && n < sizeof known[0], "more names than this test has room for")) return;
    memcpy(known[i], word, n);
    to->bit[i / 64] |= (uint64_t)1 << i % 64;
}

/* What a text defines: our words on lines that begin at global scope, and members of blocks. What it uses: the others,
   types too, without comments. Variables: their value, "ssgi_P =", is defined where they are written and used where
   they are read. */
static void read_names(names *defines, names *uses, const char *text)
{
    int block = 0;
    for (const char *line = text; *line; line += strcspn(line, "\n") + (line[strcspn(line, "\n")] != 0)) {
        const size_t whole = strcspn(line, "\n"),
                     comment = strstr(line, "//") ? (size_t)(strstr(line, "//") - line) : SIZE_MAX,
                     end = comment < whole ? comment : whole;
        if (whole > 2 && line[whole - 1] == '{'
            && (!strncmp(line, "uniform ", 8) || !strncmp(line, "layout(std140", 13))) {
            block = 1;
            continue;
        }
        if (*line == '}') block = 0;
        for (size_t i = 0, n = 0; i < end; i += n ? n : 1, n = 0) {
            const char *word = line + i, *after;
            char value[64];
            while (PART(word[n])) ++n;
            const char *stem = n > 2 && word[1] == '_' ? word + 2 : word;
            if (n < 6 || n > 40 || (strncmp(stem, "ssgi_", 5) && strncmp(stem, "SSGI_", 5))
                || !strncmp(word, "ssgi_custom_", 12) || !strncmp(word, "u_ssgi_gap", 10))
                continue;
            after = word + n;
            if (*after == '.') after += 1 + strspn(after + 1, "xyzw");
            const int type = *after == ' ' && isalpha((unsigned char)after[1]),
                      global = block || (isalpha((unsigned char)*line) && !type);
            const int variable = *word == 's' && *after != '(' && !type && !global,
                      written = variable && !strncmp(after, " = ", 3);
            snprintf(value, sizeof value, "%.*s =", (int)n, word);
            if (!variable || written) name_add(global ? defines : uses, word, n);
            if (variable) name_add(written ? defines : uses, value, n + 2);
        }
    }
}

/* What is off leaves nothing, and nothing is missing: in every stage the names that stand there are those that are
   declared there. The members of blocks are in all stages, and used in one. */
static int is_closed(const ssgi_gl_desc *d)
{
    static char text[TEXT];
    names all_defined, all_used;
    memset(&all_defined, 0, sizeof all_defined);
    memset(&all_used, 0, sizeof all_used);
    for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
        names defined, used;
        memset(&defined, 0, sizeof defined);
        memset(&used, 0, sizeof used);
        read_names(&defined, &used, emit(text, d, stage));
        for (int i = 0; i < knowns.count; ++i) {
            const int is = (int)(defined.bit[i / 64] >> i % 64 & 1), wanted = (int)(used.bit[i / 64] >> i % 64 & 1);
            if (!CHECK(is >= wanted && (is == wanted || *known[i] == 'u'), "%s, stage %d: %s is %s", describe(d), stage,
                       known[i], is ? "there, but not used" : "used, but not there"))
                return 0;
        }
        for (int w = 0; w < NAMES_ / 64; ++w) { all_defined.bit[w] |= defined.bit[w]; all_used.bit[w] |= used.bit[w]; }
    }
    for (int i = 0; i < knowns.count; ++i)
        if (!CHECK((all_defined.bit[i / 64] & ~all_used.bit[i / 64]) >> i % 64 % 2 == 0, "%s: %s is in no stage used",
                   describe(d), known[i]))
            return 0;
    return 1;
}

static void closed(void)
{
    enum { EACH = 40 };
    int tried = 0, bad = 0;
    t_seed(3);
    for (int i = 0; i < 2 * variants + EACH * shapes && bad < 5; ++i) {
        ssgi_gl_desc d = i < 2 * variants ? variant[i / 2] : drawn(i % shapes);
        const int dialect = d.text.dialect;
        /* where one has what the other lacks */
        d.text.dialect = i < 2 * variants ? i & 1 ? SSGI_GL_DIALECT_450 : SSGI_GL_DIALECT_410
                                          : i / shapes % SSGI_GL_DIALECTS;
        if (ssgi_gl_check(&d, NULL) != SSGI_OK) d.text.dialect = dialect;
        bad += !is_closed(&d);
        ++tried;
    }
    t_note("%d names in %d descs", knowns.count, tried);
}

/* ssgi_gl_field and ssgi_gl_read declare what they use and nothing else; the functions of fields are the pass' own. */
static void toolboxes(void)
{
    static char text[TEXT], whole[TEXT];
    for (int i = 0; i < texts; ++i) {
        ssgi_gl_desc d = spoken[i].desc;
        names defined, used;
        if (spoken[i].stage != TOOLBOX) continue;
        memset(&defined, 0, sizeof defined);
        memset(&used, 0, sizeof used);
        read_names(&defined, &used, source_of(text, &d, TOOLBOX));
        char *first = strstr(text, "\n\n"), *last = strstr(text, " ssgi_field_visibility(");
        while (last && memcmp(last, "\n}\n", 3) != 0) last = last > text ? last - 1 : 0; /* its comment is its own */
        CHECK(!memcmp(&defined, &used, sizeof used), "%s: its functions alone declare other names than they use",
              describe(&d));
        if (d.pass != SSGI_GL_PASS_FIELD) continue;
        if (CHECK(first && last, "%s: no functions", describe(&d))) *last = 0;
        CHECK(!last || strstr(emit(whole, &d, SSGI_GL_STAGE_FRAGMENT), first), "%s: its functions alone are others",
              describe(&d));
    }
}

/* ---- >>lint ------------------------------------------------------------------------------------------------------ */

/* The words of tests/reserved.txt, with a blank before and behind each, less those that we use as what they are. */
static char reserved_words[1 << 14];

static int reserved_words_read(void)
{
    static const char ours[] =
        " break const continue discard else false for if layout return struct true bool float int uint void vec2 vec3 "
        "vec4 ivec2 ivec3 ivec4 uvec2 uvec3 uvec4 bvec2 bvec3 bvec4 mat2 mat3 mat4 mat3x4 in out inout uniform flat "
        "precision highp sampler2D sampler2DArray sampler2DMS sampler2DMSArray usampler2D usampler2DArray "
        "texture2DArray texture2DMS "
        "texture2DMSArray utexture2D utexture2DArray ";
    char path[4096], line[256], word[64];
    size_t used = 1;
    int used_line = 0;
    snprintf(path, sizeof path, "%s/tests/reserved.txt", t_root);
    FILE *file = fopen(path, "r");
    if (!file) return 0;
    reserved_words[0] = ' ';
    while (fgets(line, sizeof line, file)) {
        const int blank = *line == '\n';
        used_line = blank || *line == '#' ? 0 : used_line + 1;             /* a paragraph's first names its language */
        if (used_line < 2) continue;
        for (const char *at = line; (at += strspn(at, " \n")), *at; at += strcspn(at, " \n")) {
            snprintf(word, sizeof word, " %.*s ", (int)strcspn(at, " \n"), at);
            if (!strstr(ours, word) && used + strlen(word) < sizeof reserved_words)
                used += (size_t)sprintf(reserved_words + used, "%s", word + 1);
        }
    }
    fclose(file);
    return used > 4000 && used < sizeof reserved_words - 64;
}

static int reserved(const char *word, size_t n)            /* in any language, and not used by us as what it is */
{
    char key[64];
    if (n > 60) return 1;
    snprintf(key, sizeof key, " %.*s ", (int)n, word);
    return strstr(reserved_words, key) != NULL;
}

static void lint_line(const char *t, const char *end, int vulkan)
{
    const char *const line = t;
    if (*t == '#') return;
    /* at global scope: the last word before what begins a value, arguments or members */
    if (isalpha((unsigned char)*t) && strncmp(t, "layout(", 7) && strncmp(t, "precision ", 10)) {
        const char *name = t + strcspn(t, " ([=;{\n");
        for (const char *next; *name == ' ' && PART(name[1]); name = next) {
            next = name + 1;
            while (PART(*next)) ++next;
            if (!strncmp(next + strcspn(next, "] ;(="), "] u_", 4)) next += strcspn(next, "]") + 1;    /* a type's */
        }
        while (name > t && PART(name[-1])) --name;
        if (name[1] == '_' && strchr("tuova", *name)) name += 2;
        CHECK(!strncmp(name, "ssgi_", 5) || !strncmp(name, "SSGI_", 5) || !strncmp(name, "main(", 5),
              "not our name: %.*s", (int)(end - line), line);
    }
    if (!strncmp(t, "layout(", 7)) t += strcspn(t, ")") + 1;               /* qualifiers have words of their own */
    while (t < end && !(t[0] == '/' && t[1] == '/')) {
        size_t k = 0;
        while (PART(t[k])) ++k;
        CHECK(!k || isdigit((unsigned char)*t) || !reserved(t, k) || (vulkan && !strncmp(t, "texture2D t", 11))
                  || ((t == line || (vulkan && t[-2] == ')'))
                      && (!strncmp(t, "patch in ", 9) || !strncmp(t, "patch out ", 10))),
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
               "tests/reserved.txt cannot be read"))
        return;
    for (int i = 0; i < texts; ++i) {
        const char *c = source_of(text, &spoken[i].desc, spoken[i].stage);
        for (const char *line = c, *end; *line && spoken[i].stage != TOOLBOX; line = end + 1) {
            end = line + strcspn(line, "\n");
            const int before = lines.count;
            place_of(&lines, hash_of(line, (size_t)(end - line)));
            if (lines.count > before) lint_line(line, end, spoken[i].desc.text.dialect == SSGI_GL_DIALECT_VULKAN);
            if (!*end) break;
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

#define INT(field, most) { "desc." #field ":", offsetof(ssgi_gl_desc, field), most }
static const struct { const char *start; size_t offset; int most;
} ints[] = { /* all of a desc */
             INT(pass, SSGI_GL_PASSES - 1),
             INT(text.dialect, 6),
             INT(input.orthographic, 1),
             INT(input.depth, 2),
             INT(input.normal, 4),
             INT(input.world_normals, 1),
             INT(gather.noise, 1),
             INT(gather.samples, 64),
             INT(gather.search, 2),
             INT(gather.directions, 32),
             INT(gather.steps, 64),
             INT(gather.normal_rays, 8),
             INT(gather.thickness, 5),
             INT(gather.falloff, 2),
             INT(gather.uniform, 1),
             INT(gather.kernel, 1),
             INT(gather.fade, 2),
             INT(gather.range, 1),
             INT(gather.layers, 8),
             INT(gather.views, 4),
             INT(gather.view_layers, 8),
             INT(light.receiver, 7),
             INT(light.environment, 2),
             INT(light.bounce, 2),
             INT(light.bands, 4),
             INT(light.packed, 1),
             INT(light.transfer, 2),
             INT(light.shaded, 1),
             INT(light.shading, 3),
             INT(light.lights, 1),
             INT(light.albedo, 1),
             INT(light.residual, 1),
             INT(light.two_sided, 1),
             INT(light.shadow, 3),
             INT(light.accumulate, 1),
             INT(light.bounced, 1),
             INT(light.radiance, 3),
             INT(input.objects, 2),
             INT(surfel.effect, 5),
             INT(surfel.levels, 7),
             INT(surfel.tessellate, 1),
             INT(surfel.sends, 2),
             INT(surfel.near_samples, 16),
             INT(surfel.axis, 1),
             INT(gather.half, 4),
             INT(filter.quantity, 2),
             INT(filter.kind, 1),
             INT(filter.radius, 4),
             INT(filter.normals, 1),
             INT(text.uniforms, 1),
             INT(text.block_set, 31),
             INT(text.texture_set, 31),
             INT(text.dense, 1),
             INT(text.lines, 1),
             INT(light.restore, 2),
             INT(surfel.span, 64),
             INT(input.motion, 1),
             INT(input.left_handed, 1),
             INT(input.oblique, 1),
             INT(input.array, 1),
             INT(input.multisampled, 1),
             INT(filter.onto, 3),
             INT(input.cap_table, 1),
             INT(light.dimmed, 1),
             INT(light.harmonics, 1),
             INT(gather.terms, 3),
             INT(gather.spheres, 1),
             INT(surfel.overhang, 1),
             INT(surfel.enlarge, 1),
             INT(surfel.combine, 1),
             INT(gather.facets, 1),
             INT(gather.lift, 1),
             INT(light.one_sided, 1),
             INT(light.clamp, 1)
};
enum { INTS = (int)(sizeof ints / sizeof ints[0]) };

static void sentences(void)
{
    static const struct { const char *start; ssgi_gl_desc desc;
    } rules[] = {
        { "desc.gather.normal_rays:", { .pass = SSGI_GL_PASS_HSAO, .gather.normal_rays = 1 } },
        { "desc.input.world_normals:", { .input.normal = SSGI_GL_NORMAL_FROM_DEPTH, .input.world_normals = 1 } },
        { "desc.gather.search:", { .pass = SSGI_GL_PASS_HSAO, .gather.search = SSGI_GL_SEARCH_POINTS } },
        { "desc.gather.search:", { .pass = SSGI_GL_PASS_S3HO, .gather.search = SSGI_GL_SEARCH_MARCH } },
        { "desc.gather.layers:", { .pass = SSGI_GL_PASS_S3HO, .gather.layers = 2 } },
        { "desc.gather.views:", { .pass = SSGI_GL_PASS_SSDO, .light.environment = 1, .gather.views = 1 } },
        { "desc.light.bounce:", { .pass = SSGI_GL_PASS_SSDO, .light.bounce = SSGI_GL_BOUNCE_PATCH } },
        { NULL, { .pass = SSGI_GL_PASS_SSAO, .gather.search = SSGI_GL_SEARCH_MARCH, .gather.views = 1 } },
        { "desc.gather.thickness:", { .gather.layers = 2, .gather.thickness = SSGI_GL_THICKNESS_BACK } },
        { "desc.gather.thickness:",
          { .pass = SSGI_GL_PASS_LIGHTS, .gather.views = 1, .gather.thickness = SSGI_GL_THICKNESS_SLABS } },
        { NULL, { .pass = SSGI_GL_PASS_EMITTERS, .gather.layers = 2, .gather.thickness = SSGI_GL_THICKNESS_BACK } },
        { "desc.gather.falloff:", { .gather.falloff = SSGI_GL_FALLOFF_NONE } },
        { "desc.gather.falloff:",
          { .pass = SSGI_GL_PASS_S3HO,
            .gather.search = SSGI_GL_SEARCH_POINTS,
            .gather.falloff = SSGI_GL_FALLOFF_NONE } },
        { NULL, { .pass = SSGI_GL_PASS_S3HO, .gather.falloff = SSGI_GL_FALLOFF_NONE } },
        { "desc.filter.quantity:", { .pass = SSGI_GL_PASS_HISTORY, .filter.quantity = SSGI_GL_QUANTITY_COEFFICIENTS } },
        { "desc.filter.kind:",
          { .pass = SSGI_GL_PASS_BLUR, .gather.half = 1, .filter.kind = SSGI_GL_FILTER_GAUSSIAN } },
        { "desc.light.environment:", { .pass = SSGI_GL_PASS_SSDO } },
        { "desc.filter.quantity:", { .pass = SSGI_GL_PASS_HISTORY, .filter.quantity = SSGI_GL_QUANTITY_COEFFICIENTS } },
        { "desc.light.restore:",
          { .pass = SSGI_GL_PASS_SHADE,
            .light.packed = 1,
            .light.transfer = 1,
            .light.restore = SSGI_GL_RESTORE_RATIO } },
        { NULL,
          { .pass = SSGI_GL_PASS_SHADE,
            .light.packed = 1,
            .light.transfer = 1,
            .light.restore = SSGI_GL_RESTORE_DIFFERENCE } },
        { "desc.light.receiver:", { .pass = SSGI_GL_PASS_LIGHTS, .light.receiver = 1 } },
        { "desc.light.receiver:", { .pass = SSGI_GL_PASS_EMITTERS, .gather.layers = 3, .light.receiver = 3 } },
        { "desc.light.receiver:",
          { .pass = SSGI_GL_PASS_LIGHTS,
            .gather.layers = 2,
            .light.receiver = 1,
            .input.normal = SSGI_GL_NORMAL_FROM_DEPTH } },
        { "desc.input.multisampled:", { .input.multisampled = 1, .text.dialect = SSGI_GL_DIALECT_300ES } },
        { "desc.input.multisampled:", { .input.multisampled = 1, .input.array = 1 } },
        { "desc.input.multisampled:",
          { .pass = SSGI_GL_PASS_EMITTERS, .input.multisampled = 1, .gather.layers = 2, .light.receiver = 1 } },
        { NULL, { .input.multisampled = 1, .text.dialect = SSGI_GL_DIALECT_310ES } },
        { "desc.input.array:", { .gather.layers = 2, .input.array = 1 } },
        { "desc.text.fetch:", { .input.depth = SSGI_GL_DEPTH_CUSTOM } },
        { "desc.text.fetch:", { .input.normal = SSGI_GL_NORMAL_CUSTOM } },
        { "desc.text.fetch:", { .pass = SSGI_GL_PASS_FIELD, .input.objects = SSGI_GL_OBJECTS_CUSTOM } },
        { "desc.text.fetch:", { .pass = SSGI_GL_PASS_SHADE, .light.harmonics = SSGI_GL_HARMONICS_CUSTOM } },
        { "desc.light.residual:",
          { .pass = SSGI_GL_PASS_SHADE,
            .light.residual = 1,
            .light.harmonics = SSGI_GL_HARMONICS_CUSTOM,
            .text.fetch = T_FETCH } },
        { "desc.light.dimmed:",
          { .pass = SSGI_GL_PASS_S3HO,
            .gather.search = 1,
            .light.packed = 1,
            .light.transfer = 1,
            .light.dimmed = 1,
            .gather.layers = 2 } },
        { "desc.light.dimmed:",
          { .pass = SSGI_GL_PASS_S3HO,
            .gather.search = 1,
            .light.packed = 1,
            .light.transfer = 2,
            .light.dimmed = 1,
            .gather.views = 1 } },
        { NULL, { .pass = SSGI_GL_PASS_S3HO, .gather.search = 1, .light.dimmed = 1, .gather.layers = 2 } },
        { "desc.light.packed:", { .pass = SSGI_GL_PASS_S3HO, .light.transfer = 1 } },
        { "desc.light.packed:", { .pass = SSGI_GL_PASS_SHADE, .light.transfer = 2 } },
        { "desc.light.packed:",
          { .pass = SSGI_GL_PASS_BLUR, .filter.quantity = SSGI_GL_QUANTITY_COEFFICIENTS, .light.transfer = 1 } },
        { "desc.light.shading:", { .pass = SSGI_GL_PASS_SHADE, .light.shading = 1, .light.bands = 1 } },
        { "desc.light.shading:",
          { .pass = SSGI_GL_PASS_SHADE, .light.shading = 3, .light.packed = 1, .light.transfer = 1 } },
        { "desc.text.fetch:", { .pass = SSGI_GL_PASS_SURFELS, .surfel.sends = SSGI_GL_SENDS_CUSTOM } },
        { "desc.text.fetch:", { .pass = SSGI_GL_PASS_SPLAT, .surfel.effect = SSGI_GL_EFFECT_CUSTOM } },
        { "desc.surfel.tessellate:", { .pass = SSGI_GL_PASS_SURFELS, .surfel.tessellate = 1 } },
        { "desc.surfel.tessellate:",
          { .pass = SSGI_GL_PASS_SPLAT, .surfel.tessellate = 1, .text.dialect = SSGI_GL_DIALECT_310ES } },
        { "desc.pass:", { .pass = SSGI_GL_PASS_SURFELS, .text.dialect = SSGI_GL_DIALECT_VULKAN } },
        { "desc.text.uniforms:",
          { .text.uniforms = SSGI_GL_UNIFORMS_LOOSE, .text.dialect = SSGI_GL_DIALECT_VULKAN } },
        { "desc.pass:",
          { .pass = SSGI_GL_PASS_SURFELS, .surfel.tessellate = 1, .text.dialect = SSGI_GL_DIALECT_VULKAN } },
        /* and these are none: what is not kept has as many vectors as it likes, what a pass does not look at is no
           matter */
        { NULL, { .pass = SSGI_GL_PASS_S3HO, .light.transfer = 1, .light.shaded = 1 } },
        { NULL,
          { .pass = SSGI_GL_PASS_BLUR,
            .filter.quantity = SSGI_GL_QUANTITY_LIGHT,
            .light.transfer = 1,
            .light.shading = 1,
            .light.bands = 1 } },
        { NULL, { .pass = SSGI_GL_PASS_SPLAT, .surfel.tessellate = 1, .text.dialect = SSGI_GL_DIALECT_320ES } },
        { NULL, { .pass = SSGI_GL_PASS_SPLAT, .surfel.tessellate = 1, .text.dialect = SSGI_GL_DIALECT_VULKAN } },
        { NULL, { .pass = SSGI_GL_PASS_SUM, .surfel.tessellate = 1 } },
        { NULL, { .pass = SSGI_GL_PASS_SHADE, .light.shading = 1, .light.bands = 2 } },
        { NULL, { .pass = SSGI_GL_PASS_SHADE, .light.bands = 1, .light.packed = 1, .light.transfer = 2 } }
    };
    const char *why = "";
    CHECK(ssgi_gl_check(NULL, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "desc:"), "NULL: %s", why);
    for (size_t i = 0; i < INTS; ++i)
        for (int k = 0; k < 4; ++k) {
            const int value[4] = { -1, ints[i].most + 1, INT32_MIN, INT32_MAX };
            ssgi_gl_desc d = { .gather.search = SSGI_GL_SEARCH_POINTS,
                               .gather.layers = 8,
                               .light.environment = SSGI_GL_ENVIRONMENT_SH,
                               .text.fetch = T_FETCH },
                         was;
            if (ints[i].offset == offsetof(ssgi_gl_desc, light.environment)) d.pass = SSGI_GL_PASS_SSDO;
            if (ints[i].offset == offsetof(ssgi_gl_desc, gather.falloff)) /* points have no NONE */
                d = (ssgi_gl_desc){ .pass = SSGI_GL_PASS_SPLAT };
            if (ints[i].offset == offsetof(ssgi_gl_desc, gather.thickness)
                || ints[i].offset == offsetof(ssgi_gl_desc, input.array))
                d.gather.layers = 0;
            set(&d, ints[i].offset, ints[i].most);
            CHECK(ssgi_gl_check(&d, &why) == SSGI_OK, "%s %d is refused: %s", ints[i].start, ints[i].most, why);
            set(&d, ints[i].offset, value[k]);
            why = "";
            CHECK(ssgi_gl_check(&d, &why) == SSGI_BAD_ARGUMENT && NAMES(why, ints[i].start)
                      && ssgi_gl_check(&d, NULL) == SSGI_BAD_ARGUMENT,
                  "%s %d: \"%s\"", ints[i].start, value[k], why);
            was = d;
            why = "";
            CHECK(ssgi_gl_preset(&d, SSGI_GL_PRESET_BEST, &why) == SSGI_BAD_ARGUMENT && NAMES(why, ints[i].start)
                      && !memcmp(&d, &was, sizeof d),
                  "preset: \"%s\"", why);
        }
    for (size_t i = 0; i < sizeof rules / sizeof rules[0]; ++i) {
        const char *start = rules[i].start ? rules[i].start : "";
        why = "";
        CHECK(ssgi_gl_check(&rules[i].desc, &why) == (*start ? SSGI_BAD_ARGUMENT : SSGI_OK)
                  && (*start ? NAMES(why, start) : !*why),
              "rule %zu, %s \"%s\"", i, start, why);
    }
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

    static const float m[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 },
                       radii[] = { 0, -1, NAN, INFINITY, -INFINITY, 2e18f };
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
        CHECK(ssgi_gl_frame_init(&frame, &view, radii[i], &why) == SSGI_BAD_ARGUMENT && NAMES(why, "radius:"),
              "radius %g: %s", (double)radii[i], why);
    CHECK(!memcmp(&frame, &was, sizeof frame), "a refused frame was written to");
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

static void defaults(void)
{
#define LIST(...) __VA_ARGS__
#define ROW(plain, more) { { LIST plain }, { LIST plain, LIST more } }
    static const struct { ssgi_gl_desc plain, whole;
    } rows[] = {
        ROW((.pass = SSGI_GL_PASS_SSAO),
            (.gather.samples = 16, .gather.steps = 1, .gather.layers = 1, .gather.view_layers = 1)),
        ROW((.pass = SSGI_GL_PASS_HSAO), (.gather.directions = 1, .gather.steps = 6)),
        ROW((.pass = SSGI_GL_PASS_HSAO, .gather.steps = 4, .gather.thickness = SSGI_GL_THICKNESS_SLABS),
            (.gather.directions = 1)),
        ROW((.pass = SSGI_GL_PASS_SSAO, .gather.thickness = SSGI_GL_THICKNESS_BACK), (.gather.samples = 16)),
        ROW((.pass = SSGI_GL_PASS_HSAO, .gather.search = SSGI_GL_SEARCH_MARCH, .gather.normal_rays = 1,
             .gather.views = 1),
            (.gather.directions = 6, .gather.steps = 6, .gather.view_layers = 1)),
        ROW((.pass = SSGI_GL_PASS_HSAO, .gather.search = SSGI_GL_SEARCH_MARCH, .gather.terms = SSGI_GL_TERMS_RAYS,
             .gather.layers = 3),
            (.gather.normal_rays = 1, .gather.spheres = 1)),
        { { .pass = SSGI_GL_PASS_HSAO, .gather.search = SSGI_GL_SEARCH_MARCH, .gather.layers = 2 },
          { .pass = SSGI_GL_PASS_HSAO,
            .gather.search = SSGI_GL_SEARCH_MARCH,
            .gather.layers = 2,
            .gather.terms = SSGI_GL_TERMS_HORIZON,
            .gather.normal_rays = 2 } },
        ROW((.pass = SSGI_GL_PASS_HSAO), (.gather.terms = SSGI_GL_TERMS_RAYS, .gather.spheres = 1)),
        ROW((.pass = SSGI_GL_PASS_SSDO, .gather.search = SSGI_GL_SEARCH_POINTS,
             .light.environment = SSGI_GL_ENVIRONMENT_MAP),
            (.gather.samples = 16, .gather.steps = 1, .gather.layers = 1)),
        ROW((.pass = SSGI_GL_PASS_SSDO, .gather.search = SSGI_GL_SEARCH_POINTS,
             .light.bounce = SSGI_GL_BOUNCE_PATCH, .gather.kernel = 1, .gather.layers = 2, .gather.views = 2,
             .gather.view_layers = 3, .gather.steps = 2, .gather.noise = SSGI_GL_NOISE_TEXTURE),
            (.gather.samples = 16)),
        ROW((.pass = SSGI_GL_PASS_LIGHTS), (.gather.samples = 8, .gather.layers = 1)),
        ROW((.pass = SSGI_GL_PASS_LIGHTS, .light.shadow = SSGI_GL_SHADOW_FILL, .light.accumulate = 1),
            (.gather.samples = 8)),
        ROW((.pass = SSGI_GL_PASS_LIGHTS, .light.shadow = SSGI_GL_SHADOW_NONE),
            (.gather.samples = 64, .gather.noise = SSGI_GL_NOISE_TEXTURE,
             .gather.thickness = SSGI_GL_THICKNESS_SOLID)),
        ROW((.pass = SSGI_GL_PASS_EMITTERS, .light.radiance = SSGI_GL_RADIANCE_BOTH), (.gather.layers = 1)),
        ROW((.pass = SSGI_GL_PASS_SSDO, .gather.search = SSGI_GL_SEARCH_POINTS,
             .light.environment = SSGI_GL_ENVIRONMENT_SH),
            (.light.bands = 3)),
        ROW((.pass = SSGI_GL_PASS_S3HO, .gather.search = SSGI_GL_SEARCH_POINTS),
            (.gather.samples = 16, .gather.steps = 1, .gather.layers = 1, .light.bands = 4)),
        ROW((.pass = SSGI_GL_PASS_S3HO, .gather.search = SSGI_GL_SEARCH_POINTS, .light.transfer = 1,
             .light.packed = 1, .gather.kernel = 1, .gather.layers = 3, .gather.views = 1, .gather.view_layers = 2,
             .gather.steps = 2, .gather.noise = SSGI_GL_NOISE_TEXTURE),
            (.gather.samples = 16)),
        ROW((.pass = SSGI_GL_PASS_S3HO, .gather.search = SSGI_GL_SEARCH_POINTS, .light.shaded = 1,
             .light.residual = 1),
            (.light.bands = 4)),
        ROW((.pass = SSGI_GL_PASS_SHADE), (.light.bands = 4)),
        ROW((.pass = SSGI_GL_PASS_SHADE, .light.residual = 1, .light.lights = 1), (.light.bands = 4)),
        ROW((.pass = SSGI_GL_PASS_SHADE, .light.bands = 2, .light.lights = 1), (.gather.samples = 1)),
        { { .pass = SSGI_GL_PASS_SHADE, .light.packed = 1, .light.transfer = 1, .light.albedo = 1 },
          { .pass = SSGI_GL_PASS_SHADE, .light.packed = 1, .light.transfer = 2, .light.albedo = 1, .light.bands = 4 } },
        ROW((.pass = SSGI_GL_PASS_SHADE, .light.shading = 2), (.light.bands = 2)),
        ROW((.pass = SSGI_GL_PASS_SHADE, .light.shading = 1, .light.lights = 1), (.light.bands = 4)),
        { { .pass = SSGI_GL_PASS_SHADE, .light.shading = 3, .light.packed = 1, .light.lights = 1, .light.albedo = 1 },
          { .pass = SSGI_GL_PASS_SHADE, .light.shading = 3, .light.packed = 1, .light.bands = 3 } },
        ROW((.pass = SSGI_GL_PASS_FIELD), (.gather.samples = 64, .gather.layers = 8, .gather.half = 1)),
        ROW((.pass = SSGI_GL_PASS_FIELD, .input.objects = SSGI_GL_OBJECTS_TEXTURE,
             .input.normal = SSGI_GL_NORMAL_FROM_DEPTH),
            (.gather.half = 1)),
        ROW((.pass = SSGI_GL_PASS_FIELD, .input.cap_table = 1), (.gather.half = 1)),
        ROW((.pass = SSGI_GL_PASS_SURFELS),
            (.light.shadow = SSGI_GL_SHADOW_MAP, .light.environment = SSGI_GL_ENVIRONMENT_MAP,
             .surfel.effect = SSGI_GL_EFFECT_BOUNCE)),
        ROW((.pass = SSGI_GL_PASS_SURFELS, .text.dialect = SSGI_GL_DIALECT_410, .surfel.tessellate = 1,
             .surfel.sends = SSGI_GL_SENDS_LIGHTS, .light.shadow = SSGI_GL_SHADOW_MAP,
             .light.environment = SSGI_GL_ENVIRONMENT_SH),
            (.gather.half = 1)),
        ROW((.pass = SSGI_GL_PASS_INTERLEAVE, .input.normal = SSGI_GL_NORMAL_FROM_DEPTH), (.surfel.levels = 4)),
        ROW((.pass = SSGI_GL_PASS_SPLAT),
            (.surfel.levels = 4, .surfel.near_samples = 1, .surfel.sends = SSGI_GL_SENDS_LIGHTS)),
        ROW((.pass = SSGI_GL_PASS_SPLAT, .surfel.effect = SSGI_GL_EFFECT_LIGHT),
            (.surfel.levels = 4, .gather.falloff = SSGI_GL_FALLOFF_NONE)),
        ROW((.pass = SSGI_GL_PASS_DEINTERLEAVE, .surfel.effect = SSGI_GL_EFFECT_SCATTER), (.surfel.levels = 4)),
        ROW((.pass = SSGI_GL_PASS_SMOOTH), (.surfel.levels = 4)),
        ROW((.pass = SSGI_GL_PASS_SMOOTH, .surfel.levels = 2, .filter.normals = 1,
             .input.normal = SSGI_GL_NORMAL_FROM_DEPTH),
            (.surfel.near_samples = 1)),
        ROW((.pass = SSGI_GL_PASS_SUM), (.surfel.levels = 4)),
        ROW((.pass = SSGI_GL_PASS_SUM, .surfel.levels = 3, .surfel.effect = SSGI_GL_EFFECT_LIGHT), (.surfel.axis = 1)),
        ROW((.pass = SSGI_GL_PASS_BLUR, .filter.quantity = SSGI_GL_QUANTITY_COEFFICIENTS),
            (.light.bands = 4, .filter.radius = 1)),
        ROW((.pass = SSGI_GL_PASS_BLUR, .filter.quantity = SSGI_GL_QUANTITY_COEFFICIENTS, .gather.half = 1,
             .light.bands = 3, .filter.normals = 1),
            (.filter.radius = 1)),
        { { .pass = SSGI_GL_PASS_BLUR,
            .filter.quantity = SSGI_GL_QUANTITY_COEFFICIENTS,
            .light.packed = 1,
            .light.transfer = 2,
            .filter.kind = SSGI_GL_FILTER_GAUSSIAN },
          { .pass = SSGI_GL_PASS_BLUR,
            .filter.quantity = SSGI_GL_QUANTITY_COEFFICIENTS,
            .light.packed = 1,
            .light.transfer = 1,
            .filter.kind = SSGI_GL_FILTER_GAUSSIAN,
            .filter.radius = 2 } },
        ROW((.pass = SSGI_GL_PASS_BLUR), (.filter.radius = 1)),
        ROW((.pass = SSGI_GL_PASS_BLUR, .filter.quantity = 1, .light.restore = 1,
             .light.environment = SSGI_GL_ENVIRONMENT_MAP),
            (.filter.radius = 1)),
        ROW((.pass = SSGI_GL_PASS_BLUR, .filter.quantity = 1, .filter.kind = SSGI_GL_FILTER_GAUSSIAN),
            (.filter.radius = 2))
    };
    for (size_t i = 0; i < sizeof rows / sizeof rows[0]; ++i) {
        CHECK(ssgi_gl_key(&rows[i].plain) == ssgi_gl_key(&rows[i].whole),
              "row %zu, %s: its defaults written out give another text", i, ssgi_gl_pass_name(rows[i].plain.pass));
    }
}

/* ---- >>fuzz, >>speed --------------------------------------------------------------------------------------------- */

static void fuzz(void)
{
    enum { TRIES = 100000, EVERY = 8 };
    static char text[TEXT];
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    int accepted = 0, emitted = 0;
    t_seed(7);
    for (int i = 0; i < TRIES; ++i) {
        ssgi_gl_desc d = { .text.fetch = i & 2 ? T_FETCH : NULL, .text.version = i & 4 ? "" : NULL };
        int broken = t_uniform(0, 1) < 0.5f;
        const char *why = NULL;
        for (int k = 0; k < INTS; ++k) set(&d, ints[k].offset, (int)t_uniform(0, (float)ints[k].most + 0.999f));
        if (broken) {
            const int k = (int)t_uniform(0, (float)INTS - 0.01f),
                      wrong = (int)((uint32_t)t_uniform(0, 65535) << 16 | (uint32_t)t_uniform(0, 65535));
            set(&d, ints[k].offset, wrong >= 0 && wrong <= ints[k].most ? ints[k].most + 1 : wrong);
        }
        ssgi_result r = ssgi_gl_check(&d, &why);
        CHECK(r == SSGI_OK ? !broken && !why : why && NAMES(why, "desc."), "check: %d, %s", (int)r,
              why ? why : "no sentence");
        accepted += r == SSGI_OK;
        if (i % EVERY) continue;
        int rows = ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO), bad = r != SSGI_OK, stages = 0, there = 0, whole = 1;
        for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
            const size_t n = ssgi_gl_emit(text, TEXT, &d, stage);
            stages |= (n > 0) << stage;
            there |= (!bad && (stages_of(&d) >> stage & 1)) << stage;
            whole &= !n
                     || (n > (d.pass == SSGI_GL_PASS_SURFELS && stage == SSGI_GL_STAGE_FRAGMENT ? 60 : 150)
                         && n < TEXT && strlen(text) == n);
        }
        emitted += !bad;
        CHECK(bad ? !rows && !ssgi_gl_key(&d) && !ssgi_gl_field(NULL, 0, &d)
                  : rows > 0 && rows <= SSGI_GL_MAX_IO && ssgi_gl_key(&d) && ssgi_gl_field(NULL, 0, &d),
              "%s: %d rows", bad ? "refused" : describe(&d), rows);
        CHECK(stages == there && whole, "%s: stages %x, of the pass %x, whole: %d", bad ? "refused" : describe(&d),
              (unsigned)stages, (unsigned)there, whole);
    }
    t_note("%d descs, %d accepted, %d emitted", TRIES, accepted, emitted);
}

/* Against a plain loop over the text on the same machine, which nobody can do without who makes it: its hash, byte by
   byte. The fastest of many, by turns. Processors differ by a third in it (blur: 11.2 and 14.9), so
   that the limit is twice what was seen. */
static void speed(void)
{
    enum { RUNS = 400 };
    static char text[TEXT];
    static const ssgi_gl_desc descs[] = { { .gather.samples = 64 },
                                          { .pass = SSGI_GL_PASS_HSAO },
                                          { .pass = SSGI_GL_PASS_BLUR },
                                          { .pass = SSGI_GL_PASS_SSDO,
                                            .gather.search = SSGI_GL_SEARCH_POINTS,
                                            .light.environment = SSGI_GL_ENVIRONMENT_MAP,
                                            .light.bounce = SSGI_GL_BOUNCE_PATCH,
                                            .gather.layers = 2,
                                            .gather.views = 2,
                                            .gather.fade = 1,
                                            .gather.samples = 64 },
                                          { .pass = SSGI_GL_PASS_S3HO,
                                            .gather.search = SSGI_GL_SEARCH_POINTS,
                                            .light.transfer = SSGI_GL_TRANSFER_BOTH,
                                            .light.packed = 1,
                                            .gather.layers = 2,
                                            .gather.views = 2,
                                            .gather.fade = 2,
                                            .gather.range = 1,
                                            .gather.samples = 64 } };
    double times[5];
    uint64_t sum = 0;
    for (int k = 0; k < 5; ++k) {
        double best[2] = { 1, 1 };
        for (int i = 0; i < RUNS; ++i) {
            const double began = kit_seconds();
            const size_t n = ssgi_gl_emit(text, TEXT, &descs[k], SSGI_GL_STAGE_FRAGMENT);
            const double made = kit_seconds();
            sum += hash_of(text, n);
            best[0] = fmin(best[0], made - began);
            best[1] = fmin(best[1], kit_seconds() - made);
        }
        times[k] = best[0] / best[1];
        CHECK(times[k] < 30 && sum, "%s: its emission takes %.2f times as long as its hash",
              ssgi_gl_pass_name(descs[k].pass), times[k]);
    }
    t_note("times as long as their hash take ssao of 64 points %.2f, hsao %.2f, blur %.2f; of 64 with all they have: "
           "ssdo %.2f, s3ho %.2f",
           times[0], times[1], times[2], times[3], times[4]);
}

/* ---- >>complete: whoever adds something is told where it is missing ---------------------------------------------- */

/* Fields that no choice of >>variants need vary. */
static const char *const unvaried[][2] = {
    { "pass", "a shape" }, { "dialect", "each text has several" }, { "search", "a shape" }, { "tessellate", "a shape" },
    { "lines", "every eighth text" }, { "uniforms", "every fifth text" }, { "block_set", "texts for Vulkan" },
    { "texture_set", "texts for Vulkan" }, { "dense", "texts for Vulkan" }, { "samples", "a constant" },
    { "directions", "a constant" },
    { "levels", "a constant" }, { "filter_radius", "a constant" } };

/* Every field of the struct's groups, as the header has it, is in the library's table and in both of this file. */
static void every_field(void)
{
    char *header, name[64], type[64], group[64] = "", field[160], end_ = 0;
    size_t size;
    int found = 1; /* desc.pass */
    if (!CHECK(!kit_file_read(&header, &size, "ssgi_gl.h", NULL), "ssgi_gl.h cannot be read")) return;
    const char *at = strstr(header, "/* ---- desc."), *end = at ? strstr(at, "} ssgi_gl_desc;") : NULL;
    for (; end && (at = strchr(at, '\n')) != NULL && at++ < end;) {
        const ssgi_gl_choice *row = NULL, *c;
        int in_ints = 0, in_choices = 0;
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
        for (int i = 0; i < INTS; ++i)
            in_ints |= ints[i].offset == row->offset && ints[i].most == row->most;
        for (int i = 0; i < CHOICES; ++i) in_choices |= choices[i].offset == row->offset;
        for (size_t i = 0; i < sizeof unvaried / sizeof *unvaried; ++i)
            in_choices |= !strcmp(unvaried[i][0], row->name);
        CHECK(in_ints, "desc.%s: add INT(%s, %d) to ints (tests/test_text.c, >>sentences)", field, field, row->most);
        CHECK(in_choices, "desc.%s: no text is compiled with it: add CHOICE(%s, ..) to choices (tests/test_text.c, "
              ">>variants) and to those of glsl-text's choices.c", field, field);
    }
    free(header);
    CHECK(found == INTS, "%d fields in the header, %d in ints (tests/test_text.c, >>sentences)", found, INTS);
}

/* Every line of the library and every row is in a text that is compiled. */
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
            place_of(&lines, hash_of(line, (size_t)(end - line)));
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
            const int length = (int)((guard ? guard - 4 : end) - line), before = lines.count;
            snprintf(line_of, sizeof line_of, "%.*s", length, line);
            place_of(&lines, hash_of(line_of, strlen(line_of)));
            CHECK(lines.count == before, "%s: no text that is compiled has \"%s\": its #if wants a choice in choices "
                  "(tests/test_text.c, >>variants), or it cannot be reached", c->name, line_of);
        }
    }
    for (int r = 0; r < SSGI_GL__ROWS; ++r)
        CHECK(met[r], "row %s, \"%.40s\": no text that is compiled has it: choices (tests/test_text.c, >>variants)",
              ssgi_gl__rows[r].io.name, ssgi_gl__rows[r].io.format);
}

/* The text of a document, wherever it is kept. */
static char *document(const char *name)
{
    static const char *const folders[] = { "examples/docs", "examples" };
    char path[200], *data = NULL;
    size_t size;
    for (int i = 0; i < 2 && !data; ++i) {
        snprintf(path, sizeof path, "%s/%s", folders[i], name);
        if (access(path, R_OK) || kit_file_read(&data, &size, path, NULL)) data = NULL;
    }
    CHECK(data, "%s cannot be read", name);
    return data;
}

/* The passes of a chain's steps, none of which reads a texture that it writes. */
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

/* The passes that ssgi_gl_steps draws, of chains that between them ask for everything. */
static uint64_t drawn_passes(void)
{
    static const ssgi_gl_desc descs[] = {
        { .pass = SSGI_GL_PASS_SSAO },
        { .pass = SSGI_GL_PASS_HSAO },
        { .pass = SSGI_GL_PASS_HSAO, .filter.onto = SSGI_GL_ONTO_MULTIPLY },
        { .pass = SSGI_GL_PASS_SSDO,
          .light.environment = SSGI_GL_ENVIRONMENT_MAP,
          .light.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE },
        { .pass = SSGI_GL_PASS_S3HO },
        { .pass = SSGI_GL_PASS_FIELD },
        { .pass = SSGI_GL_PASS_SPLAT },
        { .pass = SSGI_GL_PASS_SPLAT, .surfel.effect = SSGI_GL_EFFECT_LIGHT, .filter.onto = SSGI_GL_ONTO_MULTIPLY }
    };
    uint64_t passes = 0;
    for (int pass = 0; pass < SSGI_GL_PASSES; ++pass) {
        const ssgi_gl_chain own = { .desc = { .pass = pass, .light.environment = SSGI_GL_ENVIRONMENT_SH },
                                    .width = 64,
                                    .height = 36 };
        passes |= passes_of(&own);
    }
    for (size_t i = 0; i < sizeof descs / sizeof *descs; ++i)
        for (int flags = 0; flags < 8; ++flags) {
            ssgi_gl_chain chain = { .desc = descs[i], .width = 64, .height = 36 };
            chain.desc.text.dialect = SSGI_GL_DIALECT_450;
            chain.blur = flags & 1;
            chain.history = flags >> 1 & 1;
            chain.lights.pass = flags & 4 ? SSGI_GL_PASS_LIGHTS : 0;
            passes |= passes_of(&chain);
        }
    return passes;
}

/* Every pass has its section of PASSES.md, steps that draw it, and a group that tests it. */
static void every_pass(void)
{
    char *passes = document("PASSES.md");
    const uint64_t drawn_ = drawn_passes();
    for (int pass = 0; pass < SSGI_GL_PASSES && passes; ++pass) {
        char start[80], command[80];
        const char *const name = ssgi_gl_pass_name(pass);
        snprintf(command, sizeof command, "sh tests/groups.sh %s >/dev/null", name);
        snprintf(start, sizeof start, "### %s", name);
        CHECK(strstr(passes, start), "%s: PASSES.md has no section on it: make passes", name);
        /* surfels fills a buffer of yours, once */
        CHECK(drawn_ >> pass & 1 || pass == SSGI_GL_PASS_SURFELS,
              "%s: ssgi_gl_steps never draws it: ssgi_gl.h, >>steps, "
              "and a chain that asks for it in drawn_passes (tests/test_text.c)",
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
    RUN("what is off leaves nothing: every name that a text uses is declared there, and every one declared is used",
        closed);
    RUN("the functions of fields alone are those of the pass, and declare what they use", toolboxes);
    RUN("text is plain: ASCII, our own names, nothing reserved in GLSL, HLSL, MSL or WGSL", lint);
    RUN("random descs are refused with a sentence, or emitted whole", fuzz);
    RUN("a text takes a few times as long as reading it", speed);
    RUN("every text compiles: each pass, dialect and choice, with Khronos' compiler and Mesa's; a vertex stage of its "
        "own links",
        compilers);
    RUN("rows and declarations agree both ways, and with GL's own places", reflection);
    RUN("loose uniforms: the same rows, and the same text but for their declarations", loose_uniforms);
    RUN("for Vulkan everything has its own binding, which its row tells, and stages agree on locations", bindings);
    RUN("SPIR-V has the sets and bindings that rows and steps tell", places_in_spirv);
    RUN("WGSL by tint, HLSL and MSL by spirv-cross: everything is at its binding, y is turned", translated);
    RUN("defaults written out give the same text, and as many fetches as counted by hand", defaults);
    if (desktop) kit_gl_close();
}
