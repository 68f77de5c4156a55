/* passes.c - makes passes and programs of a chain's steps, and counts each pass's bytes. Declared in passes.h. */
#include "lab/cost/passes.h"
#include "tools/glsl/chains.h"
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ---- programs ---------------------------------------------------------------------------------------------------- */

/* Returns the index of the program with these shaders and formats. Takes the shaders over. */
int work_program(work *w, cost_program *p, kit_error *err)
{
    p->key = kit_hash(KIT_HASH, p->format, sizeof p->format);
    for (int i = 0; i < p->stages; ++i)
        p->key = p->text[i] ? kit_hash(p->key, p->text[i], strlen(p->text[i]))
                            : kit_hash(p->key, p->stage[i].word, 4 * p->stage[i].count);
    for (int i = 0; i < w->programs; ++i) {
        if (w->program[i].key != p->key) continue;
        for (int k = 0; k < p->stages; ++k) {
            free(p->text[k]);
            free(p->stage[k].word);
        }
        return i;
    }
    if (w->programs == MOST_PROGRAMS) return kit_fail(err, "there are more than %d programs", MOST_PROGRAMS);
    w->program[w->programs] = *p;
    return w->programs++;
}

static int program_of_step(work *w, const ssgi_gl_step *s, kit_error *err)
{
    static const VkShaderStageFlagBits kinds[SSGI_GL_STAGES] = {
        VK_SHADER_STAGE_VERTEX_BIT, VK_SHADER_STAGE_FRAGMENT_BIT, VK_SHADER_STAGE_TESSELLATION_CONTROL_BIT,
        VK_SHADER_STAGE_TESSELLATION_EVALUATION_BIT, VK_SHADER_STAGE_GEOMETRY_BIT, VK_SHADER_STAGE_COMPUTE_BIT
    };
    cost_program p = { .pass = ssgi_gl_pass_name(s->desc.pass), .desc = s->desc, .formats = s->outputs };
    for (int i = 0; i < s->outputs; ++i)
        p.format[i] = s->output[i].format ? (VkFormat)s->output[i].format->vulkan : VK_FORMAT_R16G16B16A16_SFLOAT;
    for (int k = 0; k < SSGI_GL_STAGES; ++k) {
        char *text = text_of(&s->desc, k);
        if (!text) continue;
        p.text[p.stages] = text;
        p.kind[p.stages++] = kinds[k];
    }
    return work_program(w, &p, err);
}

/* ---- bytes ------------------------------------------------------------------------------------------------------- */

/* Returns the bytes a texel of one of the caller's inputs; 0: a small texture, which stays in the caches. */
static int bytes_of_yours(const ssgi_gl_input *in, const ssgi_gl_desc *d)
{
    static const int bytes[SSGI_GL_YOURS] = {
        [SSGI_GL_YOUR_DEPTH] = 4, [SSGI_GL_YOUR_LAYERS] = 4, [SSGI_GL_YOUR_BACK] = 4, [SSGI_GL_YOUR_VIEWS] = 4,
        [SSGI_GL_YOUR_NORMAL] = 8, [SSGI_GL_YOUR_ALBEDO] = 4, [SSGI_GL_YOUR_LAYER_NORMALS] = 8,
        [SSGI_GL_YOUR_LAYER_ALBEDOS] = 4, [SSGI_GL_YOUR_DIRECT] = 8, [SSGI_GL_YOUR_SHADOW] = 4,
        [SSGI_GL_YOUR_OBJECTS] = 2, [SSGI_GL_YOUR_MOTION] = 4, [SSGI_GL_YOUR_AMBIENT] = 8
    };
    if (in->meaning == SSGI_GL_YOUR_BACK && d->gather.thickness == SSGI_GL_THICKNESS_SLABS) return 8;
    return bytes[in->meaning];
}

/* Returns how many layers of a texture the steps write. */
static int layers_of(const ssgi_gl_step *steps, int count, int texture)
{
    int layers = 1;
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < steps[i].outputs; ++k)
            if (steps[i].output[k].texture == texture && steps[i].output[k].layers > 1)
                layers = steps[i].output[k].layers;
    return layers;
}

static void add_pass(cost_chain *c, int program, const ssgi_gl_step *steps, int count, int at)
{
    const ssgi_gl_step *s = &steps[at];
    cost_pass *p = &c->pass[c->passes++];
    const double texels = (double)s->width * s->height;
    *p = (cost_pass) { .name = ssgi_gl_pass_name(s->desc.pass), .program = program, .width = s->width,
                       .height = s->height, .vertices = s->desc.pass == SSGI_GL_PASS_DSS ? s->vertices : 0 };
    for (int i = 0; i < s->inputs; ++i) {
        const ssgi_gl_input *in = &s->input[i];
        p->bytes_in += in->meaning >= 0 ? (double)WIDTH * HEIGHT * bytes_of_yours(in, &s->desc)
            : (double)in->width * in->height * in->format->bytes * layers_of(steps, count, in->texture);
    }
    for (int i = 0; i < s->outputs; ++i) {
        const double bytes = texels * (s->output[i].format ? s->output[i].format->bytes : 8);
        p->bytes_out += bytes;
        if (s->blend[0]) p->bytes_in += bytes;
    }
}

/* Returns the bytes of all textures that the steps write. */
static double target_bytes(const ssgi_gl_step *steps, int count)
{
    double bytes = 0;
    int seen[MOST_STEPS] = { 0 };
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < steps[i].outputs; ++k) {
            const ssgi_gl_output *o = &steps[i].output[k];
            if (o->texture < 0 || o->texture >= MOST_STEPS || seen[o->texture]++) continue;
            bytes += (double)steps[i].width * steps[i].height * o->format->bytes * (o->kept ? 2 : 1) *
                     (o->layers > 1 ? o->layers : 1);
        }
    return bytes;
}

/* ---- chains and files -------------------------------------------------------------------------------------------- */

cost_chain *work_chain(work *w, const char *name, kit_error *err)
{
    if (w->chains == MOST_CHAINS) return kit_fail(err, "%s: there are more than %d", name, MOST_CHAINS), NULL;
    cost_chain *c = &w->chain[w->chains++];
    snprintf(c->name, sizeof c->name, "%.120s", name);
    return c;
}

int work_add_chain(work *w, const char *text, kit_error *err)
{
    ssgi_gl_chain chain;
    return chain_parse(&chain, text, SSGI_GL_DIALECT_VULKAN, err) || work_add(w, text, &chain, err) ? -1 : 0;
}

int work_add(work *w, const char *name, const ssgi_gl_chain *chain, kit_error *err)
{
    cost_chain *c = work_chain(w, name, err);
    return c ? work_add_to(w, c, chain, err) : -1;
}

int work_add_to(work *w, cost_chain *c, const ssgi_gl_chain *chain, kit_error *err)
{
    static ssgi_gl_step steps[MOST_STEPS];
    ssgi_gl_chain described = *chain;
    described.width = WIDTH;
    described.height = HEIGHT;
    const int count = chain_steps(steps, &described, SSGI_GL_DIALECT_VULKAN, &c->lacks);
    if (count + c->passes > MOST_PASSES) return kit_fail(err, "%s: has more than %d passes", c->name, MOST_PASSES);
    if (count) c->targets = target_bytes(steps, count);
    for (int k = 0; k < count; ++k) {
        const int program = program_of_step(w, &steps[k], err);
        if (program < 0) return -1;
        add_pass(c, program, steps, count, k);
    }
    return 0;
}

static int read_stage(cost_program *p, const char *path, VkShaderStageFlagBits kind, kit_error *err)
{
    size_t size;
    const int binary = !strcmp(path + strlen(path) - 4, ".spv");
    p->kind[p->stages] = kind;
    if (binary ? spirv_read(&p->stage[p->stages], path, err) : kit_file_read(&p->text[p->stages], &size, path, err))
        return -1;
    ++p->stages;
    return 0;
}

int work_add_file(work *w, const char *path, kit_error *err)
{
    char vertex[1024];
    cost_program p = { .pass = "" };
    snprintf(vertex, sizeof vertex, "%s", path);
    char *ending = strstr(vertex, ".frag");
    if (!ending || strlen(path) >= sizeof vertex) return kit_fail(err, "%s: must be FILE.frag or FILE.frag.spv", path);
    memcpy(ending, ".vert", 5);
    const char *slash = strrchr(path, '/');
    cost_chain *c = work_chain(w, slash ? slash + 1 : path, err);
    if (!c) return -1;
    p.pass = c->name;
    const int triangle = access(vertex, R_OK) != 0;
    if (triangle ? spirv_triangle(&p.stage[0], err) : read_stage(&p, vertex, VK_SHADER_STAGE_VERTEX_BIT, err))
        return -1;
    p.stages = 1;
    if (read_stage(&p, path, VK_SHADER_STAGE_FRAGMENT_BIT, err)) return -1;
    const int program = work_program(w, &p, err);
    if (program < 0) return -1;
    c->pass[c->passes++] = (cost_pass) { .name = "", .program = program, .width = WIDTH, .height = HEIGHT };
    return 0;
}

/* ---- compiling and counting -------------------------------------------------------------------------------------- */

const assumed assumptions[] = {
    { "change_mask", { 16, 0 } },           /* of the 16 places of a tile all have changed, or none */
    { "lights", { 1, 1 } },
    { "smooth", { 5, 5 } }                  /* the mean of four levels, rounded up */
};
const int assumptions_count = (int)(sizeof assumptions / sizeof *assumptions);

static const int *turns_of(const char *pass)
{
    static const int once[2] = { 1, 1 };
    for (int i = 0; i < assumptions_count; ++i) if (!strcmp(assumptions[i].pass, pass)) return assumptions[i].turns;
    return once;
}

static void make_spirv(void *context, int i)
{
    cost_program *p = &((work *)context)->program[i];
    const double start = compile_seconds();
    for (int k = 0; k < p->stages && !*p->err.text; ++k)
        if (p->text[k]) spirv_make(&p->stage[k], p->text[k], p->kind[k], p->relaxed, &p->err);
    p->seconds = compile_seconds() - start;
}

/* Compiles a shader untimed: the first compilation is slow, as glslang then parses GLSL's built-in functions. */
static void warm_up(const work *w)
{
    for (int i = 0; i < 2 && w->programs; ++i) {
        const cost_program *p = &w->program[0];
        spirv s = { NULL, 0, 0 };
        if (i < p->stages && p->text[i]) spirv_make(&s, p->text[i], p->kind[i], p->relaxed, NULL);
        free(s.word);
    }
}

/* Fills in a program's counts for the weighed ways. A body without a recorded share counts whole. */
static void weigh_ways(const work *w, const cost_program *p, compiled *to, const counted *c)
{
    int of[BODIES];
    const int count = p->text[1] ? bodies_of(of, p->text[1]) : 0;           /* text[1]: the fragment stage */
    to->way[BUSY] = c->busy;
    to->way[CALM] = c->calm;
    for (int t = SQUARE; t <= FLAT; ++t) {
        double share[BODIES];
        for (int i = 0; i < count; ++i) {
            const double known = share_recorded(&w->shares, of[i], &p->desc, &tiles[t]);
            share[i] = known >= 0 ? known : 1;
        }
        to->untold = weigh(&to->way[WEIGHED + t], c, share, count) < 0;
    }
}

static int count_part(const work *w, const cost_program *p, compiled *to, const executable *e, kit_error *err)
{
    const char *bad;
    counted c;
    if (count_instructions(&c, e->assembly, turns_of(p->pass), &bad))
        return kit_fail(err, "%s: not understood: %.80s", p->pass, bad);
    if (!(e->stages & (VK_SHADER_STAGE_FRAGMENT_BIT | VK_SHADER_STAGE_COMPUTE_BIT))) {
        to->vertex += c.busy.vector;
        return 0;
    }
    weigh_ways(w, p, to, &c);
    to->report = c.report;
    to->vgprs = e->vgprs;
    to->spilled = e->spilled;
    to->scratch = e->scratch;
    to->waves = e->waves;
    return 0;
}

typedef struct job { work *w; compiler compiler[MOST_FAMILIES]; } job;

static void compile_one(void *context, int i)
{
    job *j = context;
    const int family = i % j->w->families;
    cost_program *p = &j->w->program[i / j->w->families];
    pipeline made;
    kit_error err = { "" };
    if (*p->err.text) return;
    int failed = compile(&j->compiler[family], &made, p->stage, p->stages, p->formats ? p->format : NULL, &err);
    for (int k = 0; !failed && k < made.parts; ++k) failed = count_part(j->w, p, &p->of[family], &made.part[k], &err);
    p->of[family].seconds = made.seconds;
    pipeline_free(&made);
    if (failed) p->err = err;
}

int work_do(work *w, kit_error *err)
{
    job j = { .w = w };
    int failed = 0, open = 0;
    warm_up(w);
    kit_parallel(NULL, w->programs, make_spirv, w);
    for (; open < w->families && !failed; ++open) failed = compiler_open(&j.compiler[open], w->family[open], err);
    if (!failed) {
        snprintf(w->driver, sizeof w->driver, "%s", j.compiler[0].driver);
        kit_parallel(NULL, w->programs * w->families, compile_one, &j);
    }
    for (int i = 0; i < w->programs && !failed; ++i)
        if (*w->program[i].err.text) failed = kit_fail(err, "%.40s: %.900s", w->program[i].pass,
                                                       w->program[i].err.text);
    while (open-- > 0) compiler_close(&j.compiler[open]);
    return failed;
}

void work_free(work *w)
{
    for (int i = 0; i < w->programs; ++i)
        for (int k = 0; k < w->program[i].stages; ++k) {
            free(w->program[i].text[k]);
            free(w->program[i].stage[k].word);
        }
    w->programs = w->chains = 0;
}
