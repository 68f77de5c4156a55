/* test_steps.c - an embedder that uses only ssgi_gl_steps and the rows draws the kit's pictures; ssgi_gl_step_check
   names wrong bindings; results are composed onto a picture. */
#include "own.h"
#include "frames.h"
#include "kit/kit_run.h"
#include <stdlib.h>
#include <string.h>


static kit_error err;
enum { W = 120, H = 68, STEPS = 64 };

typedef struct host {
    GLuint yours[SSGI_GL_YOURS], picture, array;     /* array: of the surfels */
    int surfels, occluders;
    kit_gbuffer *g;
    ssgi_gl_step step[STEPS];
    int steps;
    GLuint program[STEPS], framebuffer[STEPS], made[STEPS][2], block, all[256];
    int textures;
} host;

static GLuint keep(host *h, GLuint texture) { return h->all[h->textures++] = texture; }

/* Compiles a program, once for each context and key, as equal keys mean equal shaders. */
static GLuint program_of(const ssgi_gl_desc *desc)
{
    const uint64_t key = ssgi_gl_key(desc);
    GLuint program = kit_program_kept(key);
    if (program) return program;
    program = kit_pass_program(desc, &err);
    return program && !kit_program_keep(key, program, &err) ? program : 0;
}

/* Makes the programs, textures and framebuffers of a chain, once. */
static int opened(host *h, const ssgi_gl_chain *chain)
{
    const char *why = "";
    h->steps = ssgi_gl_steps(h->step, STEPS, chain, &why);
    if (!CHECK(h->steps > 0 && h->steps <= STEPS, "%d steps: %s", h->steps, why)) return 0;
    glGenBuffers(1, &h->block);
    for (int i = 0; i < h->steps; ++i) {
        const ssgi_gl_step *s = &h->step[i];
        GLenum attachments[6] = { 0 };
        if (!CHECK((h->program[i] = program_of(&s->desc)) != 0, "%s", err.text)) return 0;
        glGenFramebuffers(1, &h->framebuffer[i]);
        glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer[i]);
        for (int k = 0; k < s->outputs; ++k) {
            const ssgi_gl_output *o = &s->output[k];
            attachments[k] = GL_COLOR_ATTACHMENT0 + (GLenum)k;
            for (int j = 0; o->texture >= 0 && j <= o->kept && !h->made[o->texture][j]; ++j)
                h->made[o->texture][j] = keep(h, o->layers ? kit_texture_array(s->width, s->height, o->layers,
                                                                             o->format->internal, NULL)
                                                         : kit_texture(s->width, s->height, o->format->internal, NULL));
            if (o->layers)
                glFramebufferTextureLayer(GL_FRAMEBUFFER, attachments[k], h->made[o->texture][0], 0, o->layer);
            else
                glFramebufferTexture2D(GL_FRAMEBUFFER, attachments[k], GL_TEXTURE_2D,
                                       o->texture < 0 ? h->picture : h->made[o->texture][0], 0);
        }
        glDrawBuffers(s->outputs, attachments);
    }
    return 1;
}

static GLuint read_by(const host *h, const ssgi_gl_input *in)
{
    const GLuint *made = in->texture < 0 ? NULL : h->made[in->texture];
    return !made ? h->yours[in->meaning] : in->last && made[1] ? made[1] : made[0];
}

/* Returns the binding of a texture. */
static ssgi_gl_bound bound(GLuint texture, GLenum target)
{
    GLint value[3] = { 0 };
    if (texture && glGetTexLevelParameteriv) {
        glBindTexture(target, texture);
        glGetTexLevelParameteriv(target, 0, GL_TEXTURE_INTERNAL_FORMAT, &value[0]);
        glGetTexLevelParameteriv(target, 0, GL_TEXTURE_WIDTH, &value[1]);
        glGetTexLevelParameteriv(target, 0, GL_TEXTURE_HEIGHT, &value[2]);
    }
    return ssgi_gl_bound_of(target, (GLenum)value[0], value[1], value[2], GL_NEAREST, GL_NEAREST, GL_NONE);
}

static void draw_step(host *h, const ssgi_gl_frame *frame, int i)
{
    const ssgi_gl_step *s = &h->step[i];
    GLint was;
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, h->block);
    glBufferData(GL_UNIFORM_BUFFER, sizeof *frame, frame, GL_DYNAMIC_DRAW);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer[i]);
    for (int k = 0; k < s->outputs && s->output[k].kept; ++k)
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0 + (GLenum)k, GL_TEXTURE_2D,
                               h->made[s->output[k].texture][0], 0);
    glViewport(0, 0, s->width, s->height);
    glUseProgram(h->program[i]);
    for (int k = 0; k < s->inputs; ++k) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)s->input[k].unit);
        glBindTexture(s->input[k].target, read_by(h, &s->input[k]));
    }
    for (GLint k = 0; k < s->outputs && s->clear; ++k)
        glClearBufferfv(GL_COLOR, k, (const GLfloat[4]) { s->clear_to, s->clear_to, s->clear_to, s->clear_to });
    if (s->blend[0]) {
        glEnable(GL_BLEND);
        glBlendEquation(s->blend[0]);
        glBlendFunc(s->blend[1], s->blend[2]);
    }
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &was);
    if (s->desc.pass == SSGI_GL_PASS_DSS && h->array) glBindVertexArray(h->array);
    glDrawArraysInstanced(s->primitive, 0, s->vertices, s->instances ? s->instances
                          : s->desc.pass == SSGI_GL_PASS_DSS ? h->surfels : h->occluders);
    glBindVertexArray((GLuint)was);
    glDisable(GL_BLEND);
    for (int k = 0; k < s->outputs && s->output[k].kept; ++k) {         /* both change places */
        GLuint *pair = h->made[s->output[k].texture], other = pair[0];
        pair[0] = pair[1];
        pair[1] = other;
    }
    glActiveTexture(GL_TEXTURE0);
}

static void draw(host *h, const ssgi_gl_frame *frame)
{
    for (int i = 0; i < h->steps; ++i) draw_step(h, frame, i);
}

static void shut(host *h)
{
    glDeleteFramebuffers(h->steps, h->framebuffer);
    glDeleteTextures(h->textures, h->all);
    glDeleteBuffers(1, &h->block);
    memset(h, 0, sizeof *h);
}

/* Returns the chain of a method as the kit made it, and sets its textures as an embedder's. */
static ssgi_gl_chain chain_of(host *h, const kit_run *run, int pass)
{
    ssgi_gl_chain chain;
    const kit_gbuffer *g = run->gbuffer;
    memset(&chain, 0, sizeof chain);
    h->g = run->gbuffer;
    chain.width = W;
    chain.height = H;
    chain.precise = 1;
    chain.desc.pass = -1;
    for (int i = 0; i < run->passes; ++i) {
        const ssgi_gl_desc *d = &run->pass[i].desc;
        if (d->pass == pass && chain.desc.pass < 0) chain.desc = *d;
        if (d->pass == pass && d->light.bounce) chain.desc.light.bounce = d->light.bounce;
        if (d->pass == SSGI_GL_PASS_LIGHTS) chain.lights = *d;
        h->yours[SSGI_GL_YOUR_LIGHTS] = run->pass[i].lights;
        if (d->pass == SSGI_GL_PASS_AOF) h->yours[SSGI_GL_YOUR_OCCLUDERS] = run->pass[i].lights;
        chain.blur |= d->pass == SSGI_GL_PASS_BLUR;
    }
    h->yours[SSGI_GL_YOUR_DEPTH] = g->depth;
    h->yours[SSGI_GL_YOUR_NORMAL] = g->normal;
    h->yours[SSGI_GL_YOUR_ALBEDO] = g->albedo ? g->albedo : run->grey;
    h->yours[SSGI_GL_YOUR_OBJECTS] = g->object;
    h->yours[SSGI_GL_YOUR_ENVIRONMENT] = run->environment;
    h->yours[SSGI_GL_YOUR_IRRADIANCE] = run->irradiance;
    h->yours[SSGI_GL_YOUR_SHADOW] = run->atlas;
    h->yours[SSGI_GL_YOUR_FIELDS] = run->fields;
    h->yours[SSGI_GL_YOUR_CAP] = run->cap;
    h->array = run->arrays[0];
    h->surfels = (int)run->surfels;
    h->occluders = run->occluders;
    return chain;
}

/* Checks that ssgi_gl_step_check accepts the bindings of every step. */
static void nothing_wrong(const host *h, const char *of)
{
    for (int i = 0; i < h->steps; ++i) {
        ssgi_gl_bound inputs[16], targets[6];
        char why[256];
        for (int k = 0; k < h->step[i].inputs; ++k)
            inputs[k] = bound(read_by(h, &h->step[i].input[k]), h->step[i].input[k].target);
        for (int k = 0; k < h->step[i].outputs; ++k) {
            const ssgi_gl_output *o = &h->step[i].output[k];
            targets[k] = bound(h->made[o->texture][0], o->layers ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D);
        }
        CHECK(!glGetTexLevelParameteriv || !ssgi_gl_step_check(why, sizeof why, &h->step[i], inputs, targets), "%s: %s",
              of, why);
    }
}

/* es: also in a context of GLES */
static const struct { const char *method, *set; int pass, lit, es; } methods[] = {
    { "ssao", "", SSGI_GL_PASS_SSAO, 0, 0 }, { "hsao", "", SSGI_GL_PASS_HSAO, 0, 1 },
    { "hsao-march", "blur=0", SSGI_GL_PASS_HSAO, 0, 0 }, { "ssdo", "environment=sh", SSGI_GL_PASS_SSDO, 1, 0 },
    { "ssdo", "shadows=map", SSGI_GL_PASS_SSDO, 1, 1 }, { "s3ho", "indirect=none", SSGI_GL_PASS_S3HO, 1, 0 },
    { "aof", "occluders=all,field_resolution=4,rays=16,cap_table=32", SSGI_GL_PASS_AOF, 0, 1 },
    { "dss", "size=0.05", SSGI_GL_PASS_DSS, 0, 1 }
};
enum { METHODS = (int)(sizeof methods / sizeof *methods) };

static int ready(kit_run *run, host *h, ssgi_gl_chain *chain, int m, kit_scene *scene, kit_gbuffer *g, kit_lighting *l)
{
    kit_method method;
    const kit_world world = { scene, methods[m].lit ? l : NULL };
    memset(h, 0, sizeof *h);
    if (!TRY(kit_method_find(&method, methods[m].method, &err)) || !TRY(kit_method_set(&method, methods[m].set, &err))
        || !TRY(kit_run_open(run, g, &method, scene->radius, &world, &err)))
        return 0;
    *chain = chain_of(h, run, methods[m].pass);
    return opened(h, chain);
}

static const char *context;

/* Draws each method by the loop above. The picture must equal the kit's, and no binding may be wrong. */
static void every_method(void)
{
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    OWN(kit_lighting) l = { 0 };
    int draws = 0;
    if (!lighten(&l, "sky", "point:1,2,1,3,2,1") || !see(&scene, &g, "casters", NULL, 0, NULL, W, H)) return;
    for (int m = 0; m < METHODS; ++m) {
        OWN(kit_run) run = { 0 };
        host h;
        ssgi_gl_chain chain;
        if (kit_gl_is_es() && !methods[m].es) continue;
        static float want[4 * W * H], got[4 * W * H];
        GLuint result[2] = { 0, 0 }, kits[2];
        double worst = 0;
        if (!ready(&run, &h, &chain, m, &scene, &g, &l)) return;
        kit_run_draw(&run, 0);
        for (int i = 0; i < h.steps; ++i)
            for (int k = 0; k < h.step[i].outputs; ++k) {
                const ssgi_gl_output *o = &h.step[i].output[k];
                if (o->result) result[o->result - 1] = h.made[o->texture][0];
            }
        nothing_wrong(&h, methods[m].method);
        draw(&h, &run.frame);
        draws += h.steps;
        kits[0] = run.light;
        kits[1] = run.bounce;
        for (int r = 0; r < 2; ++r) {
            const int n = methods[m].lit ? 4 : 1;
            if (!kits[r]) continue;
            if (!CHECK(result[r] && !kit_texture_read(kits[r], W, H, n, want)
                           && !kit_texture_read(result[r], W, H, n, got), "%s: no result", methods[m].method))
                return;
            for (int i = 0; i < n * W * H; ++i) {
                const double off = fabs((double)got[i] - (double)want[i]);
                worst = off > worst || off != off ? off : worst;
            }
        }
        /* the sum of surfels depends on the order of blending */
        CHECK(worst <= (methods[m].pass == SSGI_GL_PASS_DSS ? 1e-4 : 0), "%s %s: %s: off by %g", context,
              methods[m].method, methods[m].set, worst);
        shut(&h);
    }
    t_note("%s: %d draws, the kit's bytes", kit_gl_name(), draws);
}

/* Checks that the library's chain for a name has the passes that build/render draws. Only the scene sets objects, if it
   has some, and levels, from the radius. */
static void methods_by_name(void)
{
    const ssgi_gl_method *named;
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    OWN(kit_lighting) sky = { 0 }, lamp = { 0 };
    if (!lighten(&sky, "sky", NULL) || !lighten(&lamp, "sky", "sun:1,2,1,3,3,3")
        || !see(&scene, &g, "casters", NULL, 0, NULL, W, H)) return;
    for (int m = 0; (named = ssgi_gl_method_at(m)) != NULL; ++m) {
        static ssgi_gl_step step[STEPS];
        const char *why = "";
        ssgi_gl_chain chain;
        kit_method method;
        OWN(kit_run) run = { 0 };
        int at = 0;
        if (!CHECK(ssgi_gl_chain_of(&chain, named->name, &why) == SSGI_OK, "%s: %s", named->name, why)
            || !TRY(kit_method_find(&method, named->name, &err))) break;
        const kit_world world = { &scene, !method.lit ? NULL : method.pass == SSGI_GL_PASS_DSS ? &lamp : &sky };
        if (method.between && !TRY(kit_method_set(&method, "occluders=all,field_resolution=4,rays=16", &err))) break;
        if (!TRY(kit_run_open(&run, &g, &method, scene.radius, &world, &err))) break;
        chain.width = W;
        chain.height = H;
        chain.precise = 1;
        chain.desc.shader.dialect = chain.lights.shader.dialect = kit_dialect();
        chain.desc.input.objects = method.between ? SSGI_GL_OBJECTS_TEXTURE : SSGI_GL_OBJECTS_NONE;
        if (!chain.desc.surfel.levels) chain.desc.surfel.levels = run.pass[run.passes - 1].desc.surfel.levels;
        const int count = ssgi_gl_steps(step, STEPS, &chain, &why);
        for (int i = 0; i < run.passes; ++i) {
            if (run.pass[i].aside) continue;
            CHECK(at < count && ssgi_gl_key(&run.pass[i].desc) == ssgi_gl_key(&step[at].desc),
                  "%s: draw %d, %s, is another by the name", named->name, at, ssgi_gl_pass_name(run.pass[i].desc.pass));
            ++at;
        }
        CHECK(at == count, "%s: %d draws, by the name %d", named->name, at, count);
    }
}

/* Checks the chain that a name gives, or the beginning of its refusal, which leaves the chain as it was. */
static void names_of_methods(void)
{
    static const struct { const char *name, *same, *why; } names[] = {
        { "HSAO-Best", "hsao_best", NULL }, { "hsao,best", "hsao-best", NULL },
        { "hsao-best,fast", "hsao-fast", NULL },
        { "hsao,resolution=quarter-in-turn", "hsao,resolution=4", NULL },
        { "hsao,", "hsao", NULL }, { "hsao-history", "hsao,history=1,slices=1,samples=12,filter_radius=1", NULL },
        { "hsao-fast,thickness=CONSTANT", "hsao-fast", NULL },
        { "gtao", NULL, "name: there is no such method; the nearest are hsao, hsao-fast" },
        { "hbao-plus", NULL, "name: there is no such method; the nearest are hsao, hsao-fast" },
        { "ssdo-bset", NULL, "name: there is no such method; the nearest are ssdo, ssdo-fast" },
        { "surfels", NULL, "name: there is no such method; the nearest are dss, dss-fast" },
        { "", NULL, "name: there is" },
        { "hsao,samplez=3", NULL, "name: there is no such field; the nearest is samples" },
        { "hsao,histori=1", NULL, "name: there is no such field; the nearest is history" },
        { "hsao,lights.shadw=1", NULL, "name: there is no such field; the nearest is shadow" },
        { "hsao,samples=65", NULL, "desc.gather.samples: must be 0..64" },
        { "hsao,samples=", NULL, "desc.gather.samples: must" },
        { "hsao,samples=-1", NULL, "desc.gather.samples: must" },
        { "hsao,samples=4294967297", NULL, "desc.gather.samples: must" },
        { "hsao,depth=near", NULL, "desc.input.depth: must be SSGI_GL_DEPTH_" },
        { "hsao,blur=2", NULL, "chain.blur: must" }, { "hsao,search=points", NULL, "desc.gather.search: hsao is" },
        { "hsao,steps", NULL, "name: must be NAME[,PRESET]" }, { "hsao,,best", NULL, "name: must be NAME[,PRESET]" },
        { "hsao,pass=1", NULL, "name: there is no such field" }, { NULL, NULL, "name: must not be NULL" }
    };
    static const float oblique[16] = { 1, 0, 0.1f, 0, 0, 1, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 };
    ssgi_view view = { .width = 0 };
    ssgi_gl_frame frame;
    const char *why = "";
    for (size_t i = 0; i < sizeof names / sizeof *names; ++i) {
        ssgi_gl_chain is, other;
        memset(&is, 1, sizeof is);
        other = is;
        const ssgi_result got = ssgi_gl_chain_of(&is, names[i].name, &why);
        if (names[i].same)
            CHECK(ssgi_gl_chain_of(&other, names[i].same, &why) == SSGI_OK, "%s: %s", names[i].same, why);
        else CHECK(!strncmp(why, names[i].why, strlen(names[i].why)), "%s: %s", names[i].name, why);
        CHECK(got == (names[i].same ? SSGI_OK : SSGI_BAD_ARGUMENT) && !memcmp(&is, &other, sizeof is), "%s is not %s",
              names[i].name, names[i].same ? names[i].same : "refused whole");
    }
    memset(&frame, 1, sizeof frame);
    const ssgi_gl_frame was = frame;
    CHECK(!ssgi_gl_steps_of(NULL, 0, &frame, "hsao", &view, 1, &why) && !strncmp(why, "view: ", 6), "%s", why);
    CHECK(!ssgi_gl_steps_of(NULL, 0, &frame, "hsoa", &view, 1, &why) && !strncmp(why, "name: ", 6), "%s", why);
    CHECK(!ssgi_gl_steps_of(NULL, 0, NULL, "hsao", &view, 1, &why) && !strncmp(why, "frame: ", 7), "%s", why);
    CHECK(!memcmp(&frame, &was, sizeof frame), "a refusal changes the frame");
    CHECK(ssgi_view_from_projection(&view, oblique, SSGI_CLIP_GL, 64, 32, NULL) == SSGI_OK, "no view");
    ssgi_gl_chain by_hand;
    ssgi_gl_chain_of(&by_hand, "hsao", NULL);
    by_hand.width = 64, by_hand.height = 32;
    by_hand.desc.input.oblique = by_hand.lights.input.oblique = 1;
    ssgi_gl_step got[SSGI_GL_MAX_STEPS], want[SSGI_GL_MAX_STEPS];
    memset(got, 0, sizeof got), memset(want, 0, sizeof want);
    const int count = ssgi_gl_steps(want, SSGI_GL_MAX_STEPS, &by_hand, &why);
    CHECK(count && ssgi_gl_steps_of(got, SSGI_GL_MAX_STEPS, &frame, "hsao", &view, 1, &why) == count
              && frame.radius == 1.0f && !memcmp(got, want, sizeof got), "an oblique view gives other steps: %s", why);
    /* A name may ask for functions of one's own, which the chain then lacks. */
    ssgi_gl_chain own;
    CHECK(ssgi_gl_chain_of(&own, "hsao,depth=custom", &why) == SSGI_OK && !own.desc.shader.fetch, "%s", why);
    own.width = own.height = 64;
    CHECK(!ssgi_gl_steps(NULL, 0, &own, &why) && !strncmp(why, "desc.shader.fetch:", 18), "%s", why);
    own.desc.shader.fetch = "float ssgi_custom_depth(ivec2 texel, int layer) { return 1.0; }\n";
    CHECK(ssgi_gl_steps(NULL, 0, &own, &why) > 0, "%s", why);
}

/* Binds one texture of pass blur wrongly, or in another API's words; the sentence must name step, texture, place and
   what it must be. */
static void wrong_things(void)
{
    const struct { const char *of, *says; ssgi_gl_bound is; } gl[] = {
        { "", "", { 0 } },
        { "t_ssgi_ao", "blur: t_ssgi_ao, unit 9: nothing is bound", { NULL, W / 2, H / 2, 0, 0, 0, 0 } },
        { "t_ssgi_ao", "unit 9: is of full size: 120x68, not 60x34", { "RG32F", W, H, 0, 0, 0, 0 } },
        { "t_ssgi_ao", "unit 9: must be RG32F (VK_FORMAT_R32G32_SFLOAT, rg32float), not RG16F",
          ssgi_gl_bound_of(GL_TEXTURE_2D, GL_RG16F, W / 2, H / 2, GL_NEAREST, GL_NEAREST, GL_NONE) },
        { "t_ssgi_ao", "unit 9: must be of the kind that sampler2D reads",
          ssgi_gl_bound_of(GL_TEXTURE_2D_ARRAY, GL_RG32F, W / 2, H / 2, GL_NEAREST, GL_NEAREST, GL_NONE) },
        { "t_ssgi_depth", "unit 0: is smaller than the picture: 60x68, not 120x68", { "DEPTH", W / 2, H, 0, 0, 0, 0 } },
        { "t_ssgi_depth", "unit 0: must be of the kind", { "DEPTH", W, H, 0, 1, 0, 0 } },
        { "t_ssgi_depth", "unit 0: must be read by nearest filters (GL_NEAREST): this one reads mip levels",
          ssgi_gl_bound_of(GL_TEXTURE_2D, GL_R32F, W, H, GL_NEAREST_MIPMAP_LINEAR, GL_LINEAR, GL_NONE) },
        { "t_ssgi_depth", "unit 0: must be read by nearest filters (GL_NEAREST), as",
          ssgi_gl_bound_of(GL_TEXTURE_2D, GL_DEPTH_COMPONENT24, W, H, GL_NEAREST, GL_LINEAR, GL_NONE) },
        { "t_ssgi_depth", "unit 0: must be read by nearest filters (GL_NEAREST), as",
          ssgi_gl_bound_of(GL_TEXTURE_2D, GL_DEPTH32F_STENCIL8, W, H, GL_LINEAR, GL_NEAREST, GL_NONE) },
        { "t_ssgi_depth", "unit 0: must not compare",
          ssgi_gl_bound_of(GL_TEXTURE_2D, GL_DEPTH_COMPONENT, W, H, GL_NEAREST, GL_NEAREST,
                           GL_COMPARE_REF_TO_TEXTURE) },
        { "t_ssgi_depth", "", ssgi_gl_bound_of(GL_TEXTURE_2D, GL_R16, W, H, GL_LINEAR, GL_LINEAR, GL_NONE) },
        { "t_ssgi_normal", "unit 1: must not hold integers: INT",
          ssgi_gl_bound_of(GL_TEXTURE_2D, GL_RGBA8UI, W, H, GL_NEAREST, GL_NEAREST, GL_NONE) },
        { "t_ssgi_normal", "unit 1: must not hold depth: DEPTH",
          ssgi_gl_bound_of(GL_TEXTURE_2D, GL_DEPTH_COMPONENT16, W, H, GL_NEAREST, GL_NEAREST, GL_NONE) },
        { "o_ssgi_ao", "blur: o_ssgi_ao: must be R32F (VK_FORMAT_R32_SFLOAT, r32float), not RGBA8",
          ssgi_gl_bound_of(GL_TEXTURE_2D, GL_RGBA8, W, H, GL_NEAREST, GL_NEAREST, GL_NONE) },
        { "o_ssgi_ao", "blur: o_ssgi_ao: is smaller", { "R32F", W, H - 1, 0, 0, 0, 0 } }
    }, vulkan[] = {
        { "", "", { 0 } },
        { "t_ssgi_ao", "", { "VK_FORMAT_R32G32_SFLOAT", W / 2, H / 2, 0, 0, 1, 0 } },
        { "t_ssgi_ao", "", { "rg32float", W / 2, H / 2, 0, 0, 0, 0 } },
        { "t_ssgi_ao", "blur: t_ssgi_ao, set 2, binding 2: must be RG32F (", { "rg16float", W, H, 0, 0, 0, 0 } },
        { "t_ssgi_ao", "set 2, binding 2: must be of the kind that texture2D", { "rg32float", W, H, 1, 0, 0, 0 } },
        { "t_ssgi_depth", "", { "VK_FORMAT_D24_UNORM_S8_UINT", W, H, 0, 0, 0, 0 } },
        { "t_ssgi_depth", "", { "depth24plus-stencil8", W, H, 0, 0, 0, 0 } },
        { "t_ssgi_depth", "", { "DXGI_FORMAT_R32_FLOAT", W, H, 0, 0, 1, 0 } },
        { "t_ssgi_depth", "set 2, binding 0: must be read by nearest",
          { "SDL_GPU_TEXTUREFORMAT_D16_UNORM", W, H, 0, 0, 1, 0 } },
        { "t_ssgi_depth", "set 2, binding 0: must not compare", { "MTLPixelFormatDepth32Float", W, H, 0, 0, 0, 1 } },
        { "t_ssgi_depth", "must not hold integers: r32uint", { "r32uint", W, H, 0, 0, 0, 0 } },
        { "t_ssgi_depth", "must not hold integers: R16I", { "R16I", W, H, 0, 0, 0, 0 } },
        { "t_ssgi_normal", "set 2, binding 1: must not hold depth", { "DXGI_FORMAT_D32_FLOAT", W, H, 0, 0, 0, 0 } },
        { "o_ssgi_ao", "blur: o_ssgi_ao: must be R32F (", { "VK_FORMAT_R8_UNORM", W, H, 0, 0, 0, 0 } }
    };
    for (int api = 0; api < 2; ++api)
        for (int i = 0; i < (api ? ROWS(vulkan) : ROWS(gl)); ++i) {
            ssgi_gl_step step[STEPS];
            ssgi_gl_chain chain = chain_in("hsao,resolution=HALF,blur=1,filter_normals=1,precise=1");
            ssgi_gl_bound inputs[16], target = { "R32F", W, H, 0, 0, 0, 0 };
            const ssgi_gl_bound is = api ? vulkan[i].is : gl[i].is;
            const char *const of = api ? vulkan[i].of : gl[i].of, *const says = api ? vulkan[i].says : gl[i].says;
            char why[256];
            chain.width = W;
            chain.height = H;
            chain.desc.shader.dialect = api ? SSGI_GL_DIALECT_VULKAN : SSGI_GL_DIALECT_330;
            chain.desc.shader.texture_set = 2 * api;
            chain.desc.shader.dense = api;
            const ssgi_gl_step *const blur = &step[ssgi_gl_steps(step, STEPS, &chain, NULL) - 1];
            for (int k = 0; k < blur->inputs; ++k) {
                const ssgi_gl_input *const in = &blur->input[k];
                const char *const format = in->format ? in->format->name : "FLOAT";
                const ssgi_gl_bound right = { format, in->width, in->height, 0, 0, 0, 0 };
                inputs[k] = strcmp(in->name, of) ? right : is;
            }
            if (!strcmp(of, "o_ssgi_ao")) target = is;
            const size_t n = ssgi_gl_step_check(why, sizeof why, blur, inputs, &target);
            CHECK(n == strlen(why) && (*says ? strstr(why, says) != NULL : !n), "%s %d: \"%s\" (expected \"%s\")",
                  api ? "Vulkan" : "GL", i, why, says);
        }
}

/* ---- pass debug */

enum { AS_IT_IS, ZEROS, SHIFTED, FLIPPED, WORLD, HALF, MIP_LEVELS, UNBOUND };
/* A mistake, and the fault that most of the picture then shows. how: what is wrong with the block, or with the texture
   of this meaning, whose texels are multiplied and shifted. radius: a factor. depth: KIT_DEPTH_.. */
static const struct { const char *fault, *set; int how, meaning; float scale, shift, radius; int depth; } mistakes[] = {
    { "BLOCK", "", ZEROS, 0, 1, 0, 1, 0 },
    { "BLOCK", "", SHIFTED, 0, 1, 0, 1, 0 },
    { "BLOCK", "", AS_IT_IS, 0, 1, 0, 0, 0 },
    { "SIZE", "", HALF, SSGI_GL_YOUR_DEPTH, 1, 0, 1, 0 },
    { "SIZE", "", HALF, SSGI_GL_YOUR_NORMAL, 1, 0, 1, 0 },
    { "ZERO", "", UNBOUND, SSGI_GL_YOUR_DEPTH, 1, 0, 1, 0 },
    { "RANGE", "", AS_IT_IS, SSGI_GL_YOUR_DEPTH, 10, 0, 1, 0 },
    { "RANGE", "", AS_IT_IS, SSGI_GL_YOUR_DEPTH, NAN, 0, 1, 0 },
    { "RANGE", "depth=LINEAR", AS_IT_IS, SSGI_GL_YOUR_DEPTH, -10, 0, 1, 0 },
    { "ZERO", "", MIP_LEVELS, SSGI_GL_YOUR_DEPTH, 1, 0, 1, 0 },
    { "ZERO", "", MIP_LEVELS, SSGI_GL_YOUR_NORMAL, 1, 0, 1, 0 },
    { "ZERO", "normal=UNSIGNED", MIP_LEVELS, SSGI_GL_YOUR_NORMAL, 1, 0, 1, 0 },
    { "ZERO", "", AS_IT_IS, SSGI_GL_YOUR_DEPTH, 0, 0, 1, 0 },
    { "ZERO", "", AS_IT_IS, SSGI_GL_YOUR_DEPTH, 0, 1, 1, KIT_DEPTH_REVERSED },
    { "ZERO", "normal=UNSIGNED", AS_IT_IS, SSGI_GL_YOUR_NORMAL, 0, 0, 1, 0 },
    { "BACKGROUND", "", AS_IT_IS, SSGI_GL_YOUR_DEPTH, 0, 1, 1, 0 },
    { "BACKGROUND", "", AS_IT_IS, SSGI_GL_YOUR_DEPTH, 0, 0, 1, KIT_DEPTH_INFINITE },
    { "BACKGROUND", "depth=LINEAR", AS_IT_IS, SSGI_GL_YOUR_DEPTH, 0, 0, 1, 0 },
    { "ROWS", "", FLIPPED, 0, 1, 0, 1, 0 },
    { "ROWS", "onto=MULTIPLY", FLIPPED, 0, 1, 0, 1, KIT_DEPTH_REVERSED },
    { "NORMALS", "", WORLD, SSGI_GL_YOUR_NORMAL, 1, 0, 1, 0 },
    { "NORMALS", "", AS_IT_IS, SSGI_GL_YOUR_NORMAL, -1, 0, 1, 0 },
    { "NORMALS", "", AS_IT_IS, SSGI_GL_YOUR_NORMAL, 0.5f, 0.5f, 1, 0 },
    { "NORMALS", "normal=UNSIGNED", AS_IT_IS, 0, 1, 0, 1, 0 },
    { "NORMALS", "normal=OCTAHEDRAL", AS_IT_IS, 0, 1, 0, 1, 0 },
    { "NORMALS", "left_handed=1", AS_IT_IS, 0, 1, 0, 1, 0 },
    { "NORMALS", "depth=LINEAR", AS_IT_IS, 0, 1, 0, 1, 0 },
    { "RADIUS", "", AS_IT_IS, 0, 1, 0, 1e-3f, 0 },
    { "RADIUS", "normal=FROM_DEPTH", AS_IT_IS, 0, 1, 0, 1e3f, 0 }
};

/* Makes a texture of the G-buffer anew, with the mistake. world: the camera's matrix */
static GLuint mistaken(host *h, const kit_gbuffer *g, int m, const float world[16])
{
    static float texel[4 * W * H];
    const int normal = mistakes[m].meaning == SSGI_GL_YOUR_NORMAL, n = normal ? 4 : 1, half = mistakes[m].how == HALF;
    if (!TRY(kit_texture_read(normal ? g->normal : g->depth, W, H, n, texel))) return 0;
    for (int i = 0; i < W * H && mistakes[m].how == WORLD; ++i) { /* by the transpose of the camera's rotation */
        const float was[3] = { texel[4 * i], texel[4 * i + 1], texel[4 * i + 2] };
        for (int k = 0; k < 3; ++k)
            texel[4 * i + k] = world[4 * k] * was[0] + world[4 * k + 1] * was[1] + world[4 * k + 2] * was[2];
    }
    for (int i = 0; i < n * W * H; ++i) texel[i] = texel[i] * mistakes[m].scale + mistakes[m].shift;
    const GLuint made = keep(h, kit_texture(W >> half, H >> half, normal ? GL_RGBA32F : GL_R32F, texel));
    if (mistakes[m].how != MIP_LEVELS) return made;
    glBindTexture(GL_TEXTURE_2D, made);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 9);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST_MIPMAP_LINEAR);
    return made;
}

/* Draws pass debug, and counts the pixels of each fault's colour; behind the last: of none. */
static int diagnosed(int counts[16], host *h, const ssgi_gl_chain *chain, const ssgi_gl_frame *frame)
{
    static float got[4 * W * H];
    const ssgi_gl_fault *f;
    if (chain->desc.filter.onto) h->picture = keep(h, kit_texture(W, H, GL_RGBA32F, NULL));
    if (!opened(h, chain)) return 0;
    const ssgi_gl_output *const out = &h->step[h->steps - 1].output[0];
    draw(h, frame);
    if (!CHECK(h->steps == 1 && (chain->desc.filter.onto ? out->texture < 0 : out->result == SSGI_GL_RESULT_LIGHT),
               "%d steps, result %d", h->steps, out->result)
        || !TRY(kit_texture_read(out->texture < 0 ? h->picture : h->made[out->texture][0], W, H, 4, got)))
        return 0;
    memset(counts, 0, 16 * sizeof *counts);
    for (int i = 0; i < W * H; ++i) {
        int k = 0;
        while ((f = ssgi_gl_fault_at(k)) != NULL && memcmp(f->rgb, got + 4 * i, sizeof f->rgb)) ++k;
        ++counts[k];
    }
    return 1;
}

/* Sets a chain of pass debug for a G-buffer. */
static ssgi_gl_chain debug_of(host *h, const kit_gbuffer *g, const char *set, int orthographic)
{
    char words[64];
    snprintf(words, sizeof words, "debug,precise=1,%s", set);
    ssgi_gl_chain chain = chain_in(words);
    memset(h, 0, sizeof *h);
    h->yours[SSGI_GL_YOUR_DEPTH] = g->depth;
    h->yours[SSGI_GL_YOUR_NORMAL] = g->normal;
    chain.desc.input.orthographic = orthographic;
    chain.width = W;
    chain.height = H;
    return chain;
}

/* Loads a built-in scene and makes its G-buffer, with another camera. */
static int seen_by(kit_scene *scene, kit_gbuffer *g, const char *name, int depth, int orthographic)
{
    if (!TRY(kit_scene_load(scene, name, 0, &err))) return 0;
    kit_camera *const c = &scene->camera;
    c->width = W;
    c->height = H;
    c->depth = depth;
    if (orthographic) c->ortho_height = 8 * scene->radius, c->fovy = 0;
    return TRY(kit_gbuffer_from_scene(g, scene, c, NULL, &err));
}

/* Checks that each mistake shows its fault on most of the picture. */
static void mistakes_are_seen(void)
{
    FREED char *text = NULL;
    char start[32];
    size_t size;
    if (!CHECK(!kit_file_read(&text, &size, "examples/docs/INTEGRATE.md", NULL), "INTEGRATE.md cannot be read")) return;
    for (int m = 0; m < ROWS(mistakes); ++m) {
        const int how = mistakes[m].how;
        OWN(kit_scene) scene = { 0 };
        OWN(kit_gbuffer) g = { 0 };
        host h;
        ssgi_view view;
        union { ssgi_gl_frame frame; char bytes[sizeof(ssgi_gl_frame)]; } block;
        float world[16], projection[16];
        int counts[16], at = 0, is = 0;
        if (!seen_by(&scene, &g, "casters", mistakes[m].depth, 0)) return;
        kit_camera_matrices(&g.camera, world, projection);
        for (int k = 1; k < 16 && how == FLIPPED; k += 4) g.projection[k] = -g.projection[k];
        if (!TRY(kit_view_of(&view, g.projection, g.camera.depth, W, H, &err))) return;
        ssgi_gl_frame_init(&block.frame, &view, scene.radius, NULL);
        block.frame.radius *= mistakes[m].radius;
        if (how == ZEROS) memset(&block, 0, sizeof block);
        if (how == SHIFTED) memmove(block.bytes, block.bytes + 16, sizeof block - 16);
        const ssgi_gl_chain chain = debug_of(&h, &g, mistakes[m].set, 0);
        h.yours[mistakes[m].meaning] = how == UNBOUND ? 0 : mistaken(&h, &g, m, world);
        if (!diagnosed(counts, &h, &chain, &block.frame)) return;
        for (int k = 0; ssgi_gl_fault_at(k); ++k) at = counts[k] > counts[at] ? k : at;
        while (strcmp(ssgi_gl_fault_at(is)->name, mistakes[m].fault) != 0) ++is;
        CHECK(2 * counts[is] > W * H, "mistake %d: %d of %d pixels show %s, %d show %s", m, counts[is], W * H,
              mistakes[m].fault, counts[at], ssgi_gl_fault_at(at)->name);
        snprintf(start, sizeof start, "| %s |", ssgi_gl_fault_at(is)->colour);
        CHECK(strstr(text, start), "INTEGRATE.md does not explain %s", ssgi_gl_fault_at(is)->colour);
        shut(&h);
    }
}

/* Checks that right inputs show no fault, but on a few pixels. */
static void right_is_grey(void)
{
    static const struct { const char *scene, *set; int depth, orthographic; } row[] = {
        { "room", "", KIT_DEPTH_NORMAL, 0 },          { "grass", "", KIT_DEPTH_REVERSED, 0 },
        { "colonnade", "", KIT_DEPTH_INFINITE, 0 },   { "slats", "", KIT_DEPTH_NORMAL, 1 },
        { "pebbles", "", KIT_DEPTH_REVERSED, 1 },     { "spheres", "normal=FROM_DEPTH", KIT_DEPTH_NORMAL, 0 },
        { "plates", "normal=FROM_DEPTH", KIT_DEPTH_REVERSED, 1 }, { "cornell", "depth=LINEAR", KIT_DEPTH_NORMAL, 0 },
        { "casters", "depth=LINEAR", KIT_DEPTH_NORMAL, 1 }
    };
    int most = 0;
    for (int i = 0; i < ROWS(row); ++i) {
        const int linear = strstr(row[i].set, "LINEAR") != NULL;
        OWN(kit_scene) scene = { 0 };
        OWN(kit_gbuffer) g = { 0 }, drawn_ = { 0 };
        OWN(kit_image) image = { 0 };
        host h;
        ssgi_view view;
        ssgi_gl_frame frame;
        int counts[16], faults = 0, k = 0;
        if (!seen_by(&scene, &g, row[i].scene, row[i].depth, row[i].orthographic)) return;
        if (linear) {
            drawn_ = g;
            if (!TRY(kit_gbuffer_read(&image, &drawn_, &err))
                || !TRY(kit_gbuffer_from_frame(&g, &image, &scene.camera, &err)))
                return;
        }
        if (!TRY(kit_view_of(&view, g.projection, g.camera.depth, W, H, &err))) return;
        ssgi_gl_frame_init(&frame, &view, scene.radius, NULL);
        const ssgi_gl_chain chain = debug_of(&h, &g, row[i].set, row[i].orthographic);
        if (!diagnosed(counts, &h, &chain, &frame)) return;
        for (; ssgi_gl_fault_at(k); ++k) faults += counts[k];
        most = faults > most ? faults : most;
        CHECK(20 * faults <= W * H && counts[k] + faults == W * H, "%s, %s: %d of %d pixels show a fault", row[i].scene,
              row[i].set, faults, W * H);
        shut(&h);
    }
    t_note("at most %.1f %% of the pixels of a right picture show a fault", 100.0 * most / (W * H));
}

/* Composes visibility onto a picture of 0.5, of which 0.25 is ambient, in each way, and compares with the visibility
   that was read back. There are three strengths; 4 makes some pixels black. */
static void onto_a_picture(void)
{
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    OWN(kit_run) run = { 0 };
    host h;
    ssgi_gl_chain chain;
    static float filtered[W * H], raw[W * H], got[4 * W * H], half[4 * W * H], quarter[4 * W * H];
    if (!see(&scene, &g, "casters", NULL, 0, NULL, W, H) || !ready(&run, &h, &chain, 1, &scene, &g, NULL)) return;
    draw(&h, &run.frame);
    for (int i = 0; i < h.steps; ++i)
        if (h.step[i].output[0].result)
            if (!TRY(kit_texture_read(h.made[h.step[i].output[0].texture][0], W, H, 1, filtered))) return;
    shut(&h);
    for (int i = 0; i < 4 * W * H; ++i) { half[i] = 0.5f; quarter[i] = 0.25f; }
    for (int onto = 1; onto <= SSGI_GL_ONTO_AMBIENT; ++onto)
        for (int way = 0; way < 4; ++way) {
            const int blur = way != 0;                         /* 1: by the filter; 0: by compose */
            const double strength = way == 2 ? 0.3 : way == 3 ? 4 : 1;
            const ssgi_gl_chain was = chain;
            double worst = 0;
            memset(&h, 0, sizeof h);
            chain = chain_of(&h, &run, SSGI_GL_PASS_HSAO);
            chain.desc.filter.onto = onto;
            chain.blur = blur;
            if (!blur) chain.desc.gather.resolution = 0;
            h.picture = keep(&h, kit_texture(W, H, GL_RGBA32F, half));
            h.yours[SSGI_GL_YOUR_AMBIENT] = keep(&h, kit_texture(W, H, GL_RGBA32F, quarter));
            if (!opened(&h, &chain)) return;
            if (way > 1) run.frame.strength = (float)strength; /* else its default */
            draw(&h, &run.frame);
            run.frame.strength = 1;
            CHECK(h.step[h.steps - 1].desc.pass == (blur ? SSGI_GL_PASS_BLUR : SSGI_GL_PASS_COMPOSE)
                      && h.step[h.steps - 1].output[0].texture == -1, "onto %d: the last step is another", onto);
            if (!TRY(kit_texture_read(h.picture, W, H, 4, got))) return;
            const GLuint gathered = h.made[h.step[h.steps - 2].output[0].texture][0];
            if (!blur && !TRY(kit_texture_read(gathered, W, H, 1, raw))) return;
            for (int i = 0; i < 4 * W * H; ++i) {
                const double v = fmax(1 + strength * ((double)(blur ? filtered : raw)[i / 4] - 1), 0),
                             want = i % 4 == 3 ? 0.5
                    : onto == 1 ? 0.5 * v : onto == 2 ? 0.5 * pow(v, 1 / 2.2) : 0.5 - 0.25 * (1 - v);
                worst = fmax(worst, fabs((double)got[i] - want));
            }
            CHECK(worst < 1e-5, "onto %d, blur %d, strength %g: off by %g", onto, blur, strength, worst);
            shut(&h);
            chain = was;
        }
}

/* Checks that a wrong field of a chain is named, and that nothing is written. */
static void refusals(void)
{
    static const char *const row[][2] = {
        { "chain.desc.pass", "blur" },
        { "chain.history", "s3ho,blur=1,history=1,coefficients=1" },
        { "chain.history: filters", "hsao,history=1" },
        { "chain: nothing lights", "ssdo,bounce=1" },
        { "chain: nothing lights", "ssdo,bounce=1,onto=MULTIPLY" },
        { "chain: nothing lights", "dss,effect=LIGHT" },
        { "chain.direct", "ssdo,search=POINTS,bounce=1,views=1,direct=1" },
        { "chain.direct", "ssdo,search=POINTS,bounce=1,layers=2,direct=1" },
        { "chain.desc.light.shading", "s3ho,shading=BENT,blur=1" },
        { "chain.desc.light.shading", "s3ho,shading=BENT,blur=1,history=1" },
        { "chain.desc.light.shading", "s3ho,shading=BENT,onto=MULTIPLY" },
        { "chain.desc.light.shading", "s3ho,shading=BENT,lights.samples=0" },
        { "chain.desc.light.occluded_emitters",
          "s3ho,packed_coefficients=1,transfer=BOTH,occluded_emitters=1,coefficients=1" },
        { "chain.desc.light.occluded_emitters",
          "s3ho,packed_coefficients=1,transfer=BOTH,occluded_emitters=1,blur=1" },
        { "chain.desc.light.occluded_emitters",
          "s3ho,packed_coefficients=1,transfer=REFLECTED,occluded_emitters=1,blur=1,coefficients=1" },
        { "desc.light.packed_coefficients", "s3ho,transfer=BOTH" }
    };
    const ssgi_gl_chain flat = { .desc.pass = SSGI_GL_PASS_HSAO, .height = 8 },
                        many = { .desc = { .pass = SSGI_GL_PASS_HSAO, .gather.samples = 65 }, .width = 8, .height = 8 };
    ssgi_gl_step step, was;
    const char *why = "";
    memset(&step, 7, sizeof step);
    was = step;
    for (size_t i = 0; i < sizeof row / sizeof *row; ++i) {
        const ssgi_gl_chain chain = chain_in(row[i][1]);
        why = "";
        const int n = ssgi_gl_steps(&step, 1, &chain, &why);
        CHECK(!n && !strncmp(why, row[i][0], strlen(row[i][0])) && !memcmp(&step, &was, sizeof was),
              "%s: %d, \"%s\" (expected %s)", row[i][1], n, why, row[i][0]);
    }
    CHECK(!ssgi_gl_steps(&step, 1, &flat, &why) && !strncmp(why, "chain.width, height", 19), "no width: %s", why);
    CHECK(!ssgi_gl_steps(&step, 1, &many, &why) && !strncmp(why, "desc.gather.samples", 19), "65 samples: %s", why);
    CHECK(!ssgi_gl_steps(NULL, 0, NULL, NULL), "a chain of NULL");
}

/* ---- two eyes over frames */

enum { EYES = 2, EYE_FRAMES = 6 };
static const int eye_size[EYE_FRAMES][2] = { { W, H }, { W, H }, { 88, 52 }, { 100, 60 }, { 100, 60 }, { W, H } };

/* Sets an eye's frame, with the frame before as the last one. */
static int eye_frame(ssgi_gl_frame *f, const kit_gbuffer *now, const kit_gbuffer *last, float radius, int k)
{
    const char *why = "";
    ssgi_view view;
    float to[16], from[16], projection[16];
    if (!TRY(kit_view_of(&view, now->projection, now->camera.depth, now->width, now->height, &err))
        || !CHECK(ssgi_gl_frame_init(f, &view, radius, &why) == SSGI_OK, "%s", why))
        return 0;
    f->phase = ssgi_gl_phase((uint32_t)k);
    if (!k) return 1;
    kit_camera_matrices(&now->camera, to, projection);
    kit_camera_matrices(&last->camera, from, projection);
    return TRY(kit_view_of(&view, last->projection, last->camera.depth, last->width, last->height, &err))
        && CHECK(ssgi_gl_frame_history(f, &view, to, from, &why) == SSGI_OK, "%s", why);
}

/* Returns the texture that the last step wrote in this frame. */
static GLuint written_by(const host *h)
{
    const ssgi_gl_output *o = &h->step[h->steps - 1].output[0];
    return h->made[o->texture][o->kept];
}

/* Makes textures of another size, but keeps those that the last frame wrote. */
static int resized(host *h, const ssgi_gl_chain *chain)
{
    host old = *h;
    memset(h, 0, sizeof *h);
    memcpy(h->yours, old.yours, sizeof h->yours);
    if (!opened(h, chain)) return 0;
    for (int i = 0; i < h->steps; ++i)
        for (int k = 0; k < h->step[i].outputs && h->step[i].output[k].kept; ++k) {
            GLuint *const pair = h->made[h->step[i].output[k].texture];
            for (int t = 0; t < old.textures; ++t)
                if (old.all[t] == old.made[h->step[i].output[k].texture][1]) old.all[t] = pair[1];
            for (int t = 0; t < h->textures; ++t)
                if (h->all[t] == pair[1]) h->all[t] = old.made[h->step[i].output[k].texture][1];
            pair[1] = old.made[h->step[i].output[k].texture][1];
        }
    shut(&old);
    return 1;
}

/* Copies both eyes' G-buffers into a corner of the layers of array textures. */
static int into_layers(GLuint array[2], const kit_gbuffer g[EYES])
{
    static float texel[4 * W * H], layers[EYES * 4 * W * H];
    const int w = g->width, h = g->height;
    glDeleteTextures(2, array);
    for (int i = 0; i < 2; ++i) {
        const int n = i ? 4 : 1;
        memset(layers, 0, sizeof layers);
        for (int eye = 0; eye < EYES; ++eye) {
            if (!CHECK(!kit_texture_read(i ? g[eye].normal : g[eye].depth, w, h, n, texel), "no G-buffer")) return 0;
            for (int y = 0; y < h; ++y)
                memcpy(layers + n * ((eye * H + y) * W), texel + n * y * w, (size_t)(n * w) * sizeof *texel);
        }
        array[i] = kit_texture_array(W, H, EYES, i ? GL_RGBA32F : GL_R32F, layers);
    }
    return 1;
}

/* Makes a camera's G-buffer, with depth in a format that any kind of texture has. */
static int eye_seen(kit_gbuffer *g, const kit_scene *scene, int k, int eye)
{
    kit_camera c = scene->camera;
    OWN(kit_gbuffer) drawn = { 0 };
    OWN(kit_image) frame = { 0 };
    c.width = eye_size[k][0];
    c.height = eye_size[k][1];
    c.eye[0] += 0.06f * (float)(k + eye);
    c.target[0] += 0.06f * (float)(k + eye);
    return TRY(kit_gbuffer_from_scene(&drawn, scene, &c, NULL, &err)) && TRY(kit_gbuffer_read(&frame, &drawn, &err))
           && TRY(kit_gbuffer_from_frame(g, &frame, &c, &err));
}

/* Checks two eyes, each with its own history, while the picture's size changes: as layers of array textures of the
   largest size, of which the picture is a part; and with single textures that are made anew at each size. */
static void eyes(void)
{
    static kit_gbuffer g[EYE_FRAMES][EYES];
    static host layers[EYES], alone[EYES];
    static float want[4 * W * H], got[4 * W * H];
    OWN(kit_scene) scene = { 0 };
    OWN(kit_run) run = { 0 };
    ssgi_gl_chain chain[2];
    double all = 0;
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
    for (int k = 0; k < EYE_FRAMES; ++k)
        for (int eye = 0; eye < EYES; ++eye)
            if (!eye_seen(&g[k][eye], &scene, k, eye)) return;
    const kit_world world = { &scene, NULL };
    kit_method m;
    if (!TRY(kit_method_find(&m, "hsao-history", &err))
        || !TRY(kit_run_open(&run, &g[0][0], &m, scene.radius, &world, &err)))
        return;
    chain[0] = chain_of(&alone[0], &run, SSGI_GL_PASS_HSAO);
    chain[0].blur = chain[0].history = 1;
    chain[1] = chain[0];
    chain[1].desc.input.array = 1;
    GLuint array[2] = { 0, 0 };
    for (int eye = 0; eye < EYES; ++eye)
        if (!opened(&layers[eye], &chain[1]) || !opened(&alone[eye], &chain[0])) return;
    for (int k = 0; k < EYE_FRAMES; ++k) {
        if (!into_layers(array, g[k])) return;
        for (int eye = 0; eye < EYES; ++eye) {
            /* of a kept output's two textures one is made anew now, and the other one frame later */
            const int w = eye_size[k][0], h = eye_size[k][1],
                      anew = (k && w != eye_size[k - 1][0]) || (k > 1 && w != eye_size[k - 2][0]);
            ssgi_gl_frame frame;
            for (int c = 0; c < 2; ++c) chain[c].width = w, chain[c].height = h;
            if (anew && !resized(&alone[eye], &chain[0])) return;
            ssgi_gl_steps(layers[eye].step, STEPS, &chain[1], NULL);
            alone[eye].yours[SSGI_GL_YOUR_DEPTH] = g[k][eye].depth;
            alone[eye].yours[SSGI_GL_YOUR_NORMAL] = g[k][eye].normal;
            layers[eye].yours[SSGI_GL_YOUR_DEPTH] = array[0];
            layers[eye].yours[SSGI_GL_YOUR_NORMAL] = array[1];
            nothing_wrong(&alone[eye], "an eye");
            if (!eye_frame(&frame, &g[k][eye], k ? &g[k - 1][eye] : NULL, scene.radius, k)) return;
            draw(&alone[eye], &frame);
            frame.layer = eye;
            draw(&layers[eye], &frame);
            if (!CHECK(!kit_texture_read(written_by(&alone[eye]), w, h, 4, want)
                           && !kit_texture_read(written_by(&layers[eye]), W, H, 4, got), "no result"))
                return;
            int differ = 0, grown = 0;
            for (int i = 0; i < w * h; ++i) {
                differ += memcmp(want + 4 * i, got + 4 * (i / w * W + i % w), 4 * sizeof *want) != 0;
                grown += want[4 * i + 3] > (float)k;
            }
            CHECK(!differ && grown > w * h / 4, "frame %d, eye %d: %d pixels differ, %d average all frames", k, eye,
                  differ, grown);
            all += grown;
        }
    }
    t_note("%.0f pixels average all frames", all / (EYES * EYE_FRAMES));
    for (int eye = 0; eye < EYES; ++eye) {
        shut(&layers[eye]);
        shut(&alone[eye]);
        for (int k = 0; k < EYE_FRAMES; ++k) kit_gbuffer_free(&g[k][eye]);
    }
    glDeleteTextures(2, array);
}

/* Checks that pass thickness is drawn once, before all passes that read it, with the settings of the pass that needs
   most; and only if slices read it. A sample costs as many fetches with it as without. */
static void widths(void)
{
    static const struct { int at, thickness; const char *chain; } row[] = {
        { 0, SSGI_GL_THICKNESS_WIDTH, "hsao" },
        { 0, SSGI_GL_THICKNESS_WIDTH, "s3ho,coefficients=1,blur=1" },
        { 0, SSGI_GL_THICKNESS_SLABS, "ssdo,environment=MAP,bounce=SOLID_ANGLE,thickness=SLABS,blur=1" },
        { 1, SSGI_GL_THICKNESS_WIDTH, "ssdo,bounce=SOLID_ANGLE,direct=1" },
        { 0, SSGI_GL_THICKNESS_BACK, "hsao,thickness=BACK" },
        { -1, 0, "hsao,thickness=CONSTANT" },
        { -1, 0, "hsao,search=MARCH,layers=2" },
        { -1, 0, "ssao" },
        { -1, 0, "ssao,thickness=BACK" },
        { 1, SSGI_GL_THICKNESS_WIDTH, "dss,span=4" },
        { -1, 0, "dss,span=4,thickness=CONSTANT" },
        { 0, SSGI_GL_THICKNESS_WIDTH, "ssao,thickness=WIDTH" }
    };
    const ssgi_gl_desc alone = { .pass = SSGI_GL_PASS_HSAO }, resolved = ssgi_gl_resolve(&alone);
    for (int i = 0; i < (int)(sizeof row / sizeof *row); ++i) {
        ssgi_gl_step step[STEPS];
        const ssgi_gl_chain chain = chain_in(row[i].chain);
        const char *why = "";
        int times = 0, at = -1;
        const int n = ssgi_gl_steps(step, STEPS, &chain, &why);
        if (!CHECK(n > 0, "%s: %s", row[i].chain, why)) continue;
        for (int k = n - 1; k >= 0; --k) {
            if (step[k].desc.pass != SSGI_GL_PASS_THICKNESS) continue;
            at = k;
            ++times;
        }
        CHECK(at == row[i].at && times == (at >= 0) && (at < 0 || step[at].desc.gather.thickness == row[i].thickness),
              "%s: step %d, %d of them, thickness %d", row[i].chain, at, times,
              at < 0 ? 0 : step[at].desc.gather.thickness);
    }
    for (int thickness = SSGI_GL_THICKNESS_WIDTH; thickness <= SSGI_GL_THICKNESS_SLABS; ++thickness) {
        ssgi_gl_step step[STEPS];
        ssgi_gl_chain chain = chain_in("ssdo,search=POINTS,views=1,bounce=SOLID_ANGLE,lights.samples=0");
        chain.lights.gather.thickness = thickness;
        const char *why = "";
        const int n = ssgi_gl_steps(step, STEPS, &chain, &why);
        int others = 0, wide = 0;
        CHECK(n > 0, "lights by thickness %d: %s", thickness, why);
        for (int k = 0; k < n; ++k) {
            others += step[k].frame > 0;
            wide += step[k].frame > 0 && step[k].desc.gather.thickness > SSGI_GL_THICKNESS_SOLID;
        }
        CHECK(others && !wide, "%d of %d steps of another camera read the main one's thickness", wide, others);
    }
    CHECK(resolved.gather.thickness == SSGI_GL_THICKNESS_CONSTANT, "a text alone has thickness %d",
          resolved.gather.thickness);
    int fetches[2] = { 0, 0 };
    for (int k = 0; k < 2; ++k) {
        static char text[1 << 16];
        const ssgi_gl_desc desc = { .pass = SSGI_GL_PASS_HSAO,
                                    .gather.thickness = k ? SSGI_GL_THICKNESS_WIDTH : SSGI_GL_THICKNESS_CONSTANT };
        ssgi_gl_emit(text, sizeof text, &desc, SSGI_GL_STAGE_FRAGMENT);
        for (const char *at = text; (at = strstr(at, "texelFetch(")) != NULL; ++at) ++fetches[k];
    }
    CHECK(fetches[0] > 1 && fetches[0] == fetches[1], "%d fetches with widths, %d without", fetches[1], fetches[0]);
}

/* Checks that steps' formats are among those in their outputs' rows, and inputs at the units of their rows. */
static void formats(void)
{
    static const char *const chains[] = {
        "ssao,blur=1", "hsao,resolution=half,blur=1", "aof", "ssdo,environment=MAP,bounce=1,blur=1",
        "s3ho,bands=1,blur=1",
        "s3ho,packed_coefficients=1,bands=3,blur=1,dialect=VULKAN,dense=1,texture_set=1",
        "dss,blur=1", "dss,effect=LIGHT,environment=MAP,blur=1" };
    for (int i = 0; i < (int)(sizeof chains / sizeof *chains); ++i) {
        ssgi_gl_step step[STEPS];
        ssgi_gl_chain chain = chain_in(chains[i]);
        const char *why = "";
        const int n = ssgi_gl_steps(step, STEPS, &chain, &why);
        const ssgi_gl_format *const last = step[n > 0 ? n - 1 : 0].output[0].format;
        CHECK(n > 0, "%s: %s", chains[i], why);
        if (!strcmp(last->name, "R8")) { /* R8: of this output alone also RGBA8 */
            chain.rgba8 = 1;
            ssgi_gl_steps(step, STEPS, &chain, &why);
            CHECK(step[n - 1].output[0].format->internal == GL_RGBA8 && (n < 2 || step[0].output[0].format->bytes != 4
                  || strcmp(step[0].output[0].format->name, "RGBA8")), "%s: bytes in RGBA8", chains[i]);
        }
        for (int k = 0; k < n; ++k) {
            ssgi_gl_io row[SSGI_GL_MAX_IO];
            const int rows = ssgi_gl_reflect(&step[k].desc, row, SSGI_GL_MAX_IO);
            for (int o = 0; o < step[k].outputs; ++o)
                for (int r = 0; r < rows; ++r)
                    if (row[r].kind == SSGI_GL_IO_OUTPUT && !strcmp(row[r].name, step[k].output[o].name))
                        CHECK(strstr(row[r].format, step[k].output[o].format->name), "%s: %s is %s, its row says %s",
                              ssgi_gl_pass_name(step[k].desc.pass), row[r].name, step[k].output[o].format->name,
                              row[r].format);
            for (int m = 0; m < step[k].inputs; ++m) {
                const ssgi_gl_input *const in = &step[k].input[m];
                int r = 0;
                while (r < rows && strcmp(row[r].name, in->name)) ++r;
                CHECK(r < rows && in->unit == row[r].slot
                          && (step[k].desc.shader.dialect != SSGI_GL_DIALECT_VULKAN
                              || (in->set == row[r].set && in->binding == row[r].binding)),
                      "%s: %s is not where its row says", ssgi_gl_pass_name(step[k].desc.pass), in->name);
            }
        }
    }
}

/* Checks the output of a chain's last step by its name, and whether it is a result or your picture. */
static void results(void)
{
    static const struct { const char *output; int steps; const char *chain; } row[] = {
        { "o_ssgi_bent", 3, "s3ho,shading=BENT" },
        { "o_ssgi_bent", 4, "s3ho,shading=BENT,blur=1,coefficients=1" },
        { "o_ssgi_light", 3, "ssdo,environment=SH,blur=1" },
        /* of light that no filter writes: composed onto the picture */
        { "o_ssgi_picture", 3, "ssdo,environment=MAP,onto=AMBIENT" },
        /* of the light of virtual point lights, added to the bounce */
        { "o_ssgi_light", 6, "ssdo,environment=MAP,bounce=SOLID_ANGLE,vpls=1,direct=1,lights.samples=0" },
        { "o_ssgi_picture", 10, "dss,span=4,levels=2,onto=AMBIENT" },
        { "o_ssgi_ao", 1, "aof,objects=TEXTURE" },
        { "o_ssgi_ao", 1, "ssao,layers=2" },
        { "o_ssgi_ao", 5, "hsao,thickness=SLABS,motion=1,blur=1,history=1" }
    };
    for (int i = 0; i < (int)(sizeof row / sizeof *row); ++i) {
        ssgi_gl_step step[STEPS];
        const ssgi_gl_chain chain = chain_in(row[i].chain);
        const char *why = "";
        const int n = ssgi_gl_steps(step, STEPS, &chain, &why), picture = chain.desc.filter.onto != 0;
        if (!CHECK(n == row[i].steps, "%s: %d steps: %s", row[i].chain, n, why)) continue;
        const ssgi_gl_output *last = step[n - 1].output;
        CHECK(!strcmp(last->name, row[i].output) && picture == (last->texture < 0)
                  && last->result == (picture ? SSGI_GL_RESULT_NONE
                                      : chain.vpls ? SSGI_GL_RESULT_BOUNCE : SSGI_GL_RESULT_LIGHT),
              "%d: the last step writes %s, result %d, texture %d", i, last->name, last->result, last->texture);
        for (int k = 0; k < n - 1; ++k)
            for (int o = 0; o < step[k].outputs; ++o)
                CHECK(step[k].output[o].texture >= 0 && (!picture || !step[k].output[o].result),
                      "%d: step %d writes texture %d, result %d", i, k, step[k].output[o].texture,
                      step[k].output[o].result);
        CHECK(!picture || last->texture == -1, "%d: the picture is texture %d", i, last->texture);
        for (int k = 0; k < n; ++k)
            for (int m = 0; m < step[k].inputs; ++m) {
                static const char others[] = "t_ssgi_environment t_ssgi_irradiance t_ssgi_lights t_ssgi_occluders "
                                             "t_ssgi_fields"; /* of any size */
                const ssgi_gl_input *in = &step[k].input[m];
                const int size = strstr(others, in->name) ? 0 : 8;
                CHECK(in->texture >= 0 ? in->meaning == -1 : in->texture == -1 && in->meaning >= 0,
                      "%d: step %d reads texture %d, meaning %d", i, k, in->texture, in->meaning);
                CHECK(in->texture >= 0 || (in->width == size && in->height == size), "%d: step %d, %s: %dx%d", i, k,
                      in->name, in->width, in->height);
            }
    }
}

/* Checks the passes of methods at 1920x1080, and the bytes of their own textures, of which some are kept twice. */
static void megabytes(void)
{
    static const struct { const char *name, *passes; double megabytes; } row[] = {
        { "hsao", "thickness 960x540 hsao 960x540 blur 1920x1080 ", 12.4 },
        { "hsao-history",
          "thickness 960x540 hsao 960x540 change_mask 240x135 change_share 240x135 history 1920x1080 ", 43.9 } };
    for (int i = 0; i < ROWS(row); ++i) {
        static ssgi_gl_step step[STEPS];
        ssgi_gl_chain chain;
        char passes[400] = "";
        double bytes = 0;
        if (!T_OK(ssgi_gl_chain_of, &chain, row[i].name)) return;
        chain.width = 1920;
        chain.height = 1080;
        const int n = ssgi_gl_steps(step, STEPS, &chain, NULL);
        for (int k = 0, made = 0; k < n; ++k) {
            snprintf(passes + strlen(passes), sizeof passes - strlen(passes), "%s %dx%d ",
                     ssgi_gl_pass_name(step[k].desc.pass), step[k].width, step[k].height);
            for (int o = 0; o < step[k].outputs; ++o)
                if (step[k].output[o].texture == made && ++made)
                    bytes += (double)step[k].width * step[k].height * step[k].output[o].format->bytes
                           * (1 + step[k].output[o].kept);
        }
        CHECK(fabs(bytes / 1e6 - row[i].megabytes) < 0.05 && !strcmp(passes, row[i].passes), "%s: %.1f MB, %s",
              row[i].name, bytes / 1e6, passes);
    }
}

/* Checks how many steps chains with one camera and one layer of depth have: each part on and off, in each preset. */
static void room_for_steps(void)
{
    enum { ENVIRONMENT = 1, BOUNCE = 2, LIGHTS = 4, HISTORY = 8, ONTO = 16, A = 32, B = 64, C = 128, ALL = 256 };
    static const struct { ssgi_gl_pass pass; int parts, effects; } row[] = {
        { SSGI_GL_PASS_SSAO, HISTORY | ONTO, 1 }, { SSGI_GL_PASS_HSAO, HISTORY | ONTO, 1 },
        { SSGI_GL_PASS_SSDO, ALL - 1, 1 },        { SSGI_GL_PASS_S3HO, ALL - 1 - ENVIRONMENT, 1 },
        { SSGI_GL_PASS_AOF, ONTO, 1 },          { SSGI_GL_PASS_DSS, ALL - 1 - C, SSGI_GL_EFFECT_SPECULAR } };
    static ssgi_gl_step step[STEPS];
    int most = 0, textures = 0, chains = 0;
    for (size_t i = 0; i < sizeof row / sizeof *row; ++i)
        for (int way = 0; way < 3 * row[i].effects * ALL; ++way) {
            const int has = way % ALL, effect = way / ALL % row[i].effects, ssdo = row[i].pass == SSGI_GL_PASS_SSDO;
            if (has & ~row[i].parts) continue;
            ssgi_gl_chain c = { .desc = { .pass = row[i].pass,
                                          .gather.thickness = SSGI_GL_THICKNESS_SLABS,
                                          .light.environment = has & ENVIRONMENT ? SSGI_GL_ENVIRONMENT_MAP : 0,
                                          .light.bounce = has & BOUNCE ? SSGI_GL_BOUNCE_SOLID_ANGLE : 0,
                                          .light.transfer = has & BOUNCE ? SSGI_GL_TRANSFER_BOTH : 0,
                                          .light.packed_coefficients = (has & BOUNCE) != 0,
                                          .light.shaded = (has & B) != 0,
                                          .surfel.effect = effect,
                                          .surfel.span = has & B ? 6 : 0,
                                          .filter.onto = has & ONTO ? SSGI_GL_ONTO_MULTIPLY : 0 },
                                .lights = { .pass = has & LIGHTS ? SSGI_GL_PASS_LIGHTS : SSGI_GL_PASS_SSAO },
                                .width = 8,
                                .height = 8,
                                .blur = 1,
                                .history = (has & HISTORY) != 0,
                                .coefficients = (has & A) != 0,
                                .vpls = ssdo && has & A,
                                .direct = ssdo && has & B,
                                .reuse = ssdo && has & C,
                                .surfels = (has & A) != 0 };
            ssgi_gl_preset(&c.desc, way / ALL / row[i].effects, NULL);
            const int n = ssgi_gl_steps(step, STEPS, &c, NULL);
            chains += n > 0;
            most = n > most ? n : most;
            for (int k = 0; k < n && k < STEPS; ++k)
                for (int o = 0; o < step[k].outputs; ++o)
                    if (step[k].output[o].texture >= textures) textures = step[k].output[o].texture + 1;
        }
    CHECK(most == 22 && textures <= SSGI_GL_MAX_STEPS, "%d steps and %d textures at most, not 22 and %d", most,
          textures, SSGI_GL_MAX_STEPS);
    CHECK(chains > 500, "only %d chains", chains);
    t_note("%d chains, of up to %d steps and %d textures", chains, most, textures);
}

/* ---- >>chains by chance ------------------------------------------------------------------------------------------ */

/* Makes a random desc most of whose fields have their default. */
static void any_desc(ssgi_gl_desc *d)
{
    const ssgi_gl_choice *c;
    memset(d, 0, sizeof *d);
    for (int i = 0; (c = ssgi_gl_choice_at(i)) != NULL; ++i) {
        const int value = t_below(4) ? 0 : (int)t_below((uint32_t)c->most + 1);
        memcpy((char *)d + c->offset, &value, sizeof value);
    }
    d->shader.dialect = SSGI_GL_DIALECT_450;
    d->shader.fetch = T_FETCH;
}

static ssgi_gl_chain any_chain(void)
{
    static const int passes[] = { SSGI_GL_PASS_SSAO, SSGI_GL_PASS_HSAO,  SSGI_GL_PASS_SSDO,
                                  SSGI_GL_PASS_S3HO, SSGI_GL_PASS_AOF, SSGI_GL_PASS_DSS };
    ssgi_gl_chain chain;
    memset(&chain, 0, sizeof chain);
    any_desc(&chain.desc);
    any_desc(&chain.lights);
    chain.desc.pass = passes[t_below(6)];
    chain.lights.pass = t_below(2) ? SSGI_GL_PASS_LIGHTS : SSGI_GL_PASS_SSAO;
    chain.width = 1 + (int)t_below(24);
    chain.height = 1 + (int)t_below(24);
    const ssgi_gl_choice *c;
    for (int i = 0; (c = ssgi_gl_chain_choice_at(i)) != NULL; ++i) {
        const int value = (int)t_below(2);
        memcpy((char *)&chain + c->offset, &value, sizeof value);
    }
    chain.surfels = 0; /* surfels go into a buffer, which this test has not */
    return chain;
}

/* Makes a texture of zeros, as large as a sampler of this type needs. */
static GLuint anything(const ssgi_gl_input *in)
{
    const int width = in->width > 8 ? in->width : 8, height = in->height > 8 ? in->height : 8;
    const GLenum format = *in->type == 'u' ? GL_RG32UI : GL_RGBA32F;
    GLuint t;
    if (in->target == GL_TEXTURE_2D) return kit_texture(width, height, format, NULL);
    if (in->target == GL_TEXTURE_2D_ARRAY) return kit_texture_array(width, height, 40, format, NULL);
    glGenTextures(1, &t);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, t);
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, 4, GL_RGBA32F, width, height, GL_TRUE);
    return t;
}

/* Checks that every accepted chain compiles, has complete framebuffers, and draws without an error. T_CHAINS in the
   environment: how many chains, instead of a few. */
static void random_chains(void)
{
    const char *const many = getenv("T_CHAINS");
    const int wanted = many ? atoi(many) : 5;
    static ssgi_gl_frame frame;
    GLuint cameras, grey = kit_texture(64, 64, GL_RGBA32F, NULL);
    int drawn = 0, refused = 0;
    frame.size[0] = frame.size[1] = 1;
    glGenBuffers(1, &cameras);
    glBindBufferBase(GL_UNIFORM_BUFFER, 1, cameras);
    glBufferData(GL_UNIFORM_BUFFER, sizeof(ssgi_gl_views), NULL, GL_STATIC_DRAW);
    while (drawn < wanted) {
        static host h;
        const ssgi_gl_chain chain = any_chain();
        const int n = ssgi_gl_steps(NULL, 0, &chain, NULL);
        if (!n || n > STEPS) { ++refused; continue; }
        memset(&h, 0, sizeof h);
        h.surfels = h.occluders = 1;
        h.picture = grey;
        if (!opened(&h, &chain)) return;
        for (int i = 0; i < h.steps; ++i) {
            glBindFramebuffer(GL_FRAMEBUFFER, h.framebuffer[i]);
            CHECK(!h.step[i].outputs || glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE,
                  "chain %d: the targets of %s", drawn, ssgi_gl_pass_name(h.step[i].desc.pass));
            for (int k = 0; k < h.step[i].inputs; ++k) {
                const ssgi_gl_input *in = &h.step[i].input[k];
                if (in->meaning >= 0) h.yours[in->meaning] = keep(&h, anything(in));
            }
            frame.size[0] = chain.width, frame.size[1] = chain.height;
            draw_step(&h, &frame, i);
            const GLenum error = glGetError();
            CHECK(!error, "chain %d: %s: GL error %x", drawn, ssgi_gl_pass_name(h.step[i].desc.pass), error);
        }
        shut(&h);
        ++drawn;
    }
    t_note("%d chains drawn, %d refused", drawn, refused);
    glDeleteTextures(1, &grey);
    glDeleteBuffers(1, &cameras);
}

void test_steps(void)
{
    static const char *const contexts[] = { "desktop", "egl-es" };
    for (int c = 0; c < 2; ++c) {
        context = contexts[c];
        if (kit_gl_open(c ? context : NULL, &err)) {
            if (c) printf("skipped: %s: %s\n", context, err.text);
            else CHECK(0, "%s", err.text);
            continue;
        }
        RUN("an embedder that knows steps and rows alone draws what the kit draws", every_method);
        if (!c) {
            RUN("a method's name gives the passes that build/render draws", methods_by_name);
            RUN("names of methods are read in any spelling, or refused with those near them", names_of_methods);
            RUN("what is bound wrong is named before it is drawn", wrong_things);
            RUN("pass debug shows each mistake in its own colour", mistakes_are_seen);
            RUN("pass debug is grey where nothing is wrong", right_is_grey);
            RUN("ambient visibility stands on a picture", onto_a_picture);
            RUN("a chain that cannot be drawn is refused", refusals);
            RUN("pass thickness is drawn once, where slices read it, and costs a tap nothing", widths);
            RUN("two eyes as layers have histories of their own, in parts of textures as in textures made anew", eyes);
            RUN("formats of targets are those that rows name", formats);
            RUN("every chain ends with its result, or on the picture", results);
            RUN("at 1920x1080 hsao has three passes and textures of 12.4 MB, hsao-history of 43.9 MB", megabytes);
            RUN("every chain of one camera and one layer has steps and textures for which there is room",
                room_for_steps);
            RUN("chains by chance are refused, or draw without an error", random_chains);
        }
        kit_fields_free();
        kit_gl_close();
    }
}
