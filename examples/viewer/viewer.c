/* viewer.c - a window onto a scene: methods live, beside another or beside the truth, with their error and GPU times.

      build/viewer room                          build/viewer model.obj --method hsao --right truth
      build/viewer model.glb --preset best       keys: h; options: --help

   To put ssgi into a program of your own, copy a page of examples/hosts, not this: here every method and setting can be
   changed while it runs. Between the two lines of "====" a method is a list of draws from ssgi_gl_steps, whichever it
   is, and one loop allocates, binds and draws them. Below it: what is chosen of a method, what changes per frame, and
   the frame itself. What an engine has already is beside: gl.c wraps GL, gbuffer.c draws the G-buffer, the kit
   loads scenes; window.c, arguments.c and panel.c are the window around the picture, truth.c and pictures.c look at
   the result. */
#include "viewer.h"
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

/* ==== >>ssgi: a method, whichever, by its steps =================================================================== */

/* Programs by ssgi_gl_key: methods share passes, and what was chosen once may be chosen again. */
static GLuint chain_program(const ssgi_gl_step *s, kit_error *err)
{
    static struct { uint64_t key; GLuint program; } kept[256];
    static int count;
    static char text[2][65536];
    const uint64_t key = ssgi_gl_key(&s->desc);
    GLuint p;
    for (int i = 0; i < count; ++i) if (kept[i].key == key) return kept[i].program;
    for (int i = 0; i < 2; ++i)
        if (ssgi_gl_emit(text[i], sizeof text[i], &s->desc, i) >= sizeof text[i])
            return kit_fail(err, "pass %s: its text is too long", ssgi_gl_pass_name(s->desc.pass)), 0u;
    p = gl_program(text[SSGI_GL_VERTEX], text[SSGI_GL_FRAGMENT], err);
    if (!p) return 0;
    glUseProgram(p);
    for (int k = 0; k < s->inputs; ++k) glUniform1i(glGetUniformLocation(p, s->input[k].name), s->input[k].unit);
    glUniformBlockBinding(p, glGetUniformBlockIndex(p, "ssgi_frame"), 0);
    if (count < 256) { kept[count].key = key; kept[count++].program = p; }
    return p;
}

static void chain_close(chain *c)
{
    for (int i = 0; i < TEXTURES; ++i) {
        if (c->texture[i][1] != c->texture[i][0]) glDeleteTextures(1, &c->texture[i][1]);
        glDeleteTextures(1, &c->texture[i][0]);
    }
    for (int i = 0; i < STEPS; ++i) {
        glDeleteFramebuffers(2, c->framebuffer[i]);
        if (c->time[i].query[0]) glDeleteQueries(RING, c->time[i].query);
    }
    glDeleteBuffers(1, &c->block);
    memset(c, 0, sizeof *c);
}

static int chain_open(chain *c, const ssgi_gl_chain *want, kit_error *err)
{
    const char *why = "more steps than this example has room for";
    memset(c, 0, sizeof *c);
    c->light = c->bounce = -1;
    c->steps = ssgi_gl_steps(c->step, STEPS, want, &why);
    if (!c->steps || c->steps > STEPS) { c->steps = 0; return kit_fail(err, "%s", why); }
    glGenBuffers(1, &c->block);
    for (int i = 0; i < c->steps; ++i) {
        const ssgi_gl_step *s = &c->step[i];
        if (!(c->program[i] = chain_program(s, err))) return -1;
        for (int turn = 0; turn < 2; ++turn) {              /* what history keeps is there twice */
            GLenum attached[6];
            glGenFramebuffers(1, &c->framebuffer[i][turn]);
            for (int o = 0; o < s->outputs; ++o) {
                const ssgi_gl_output *out = &s->output[o];
                GLuint *t = c->texture[out->texture];
                attached[o] = GL_COLOR_ATTACHMENT0 + (GLenum)o;
                if (!t[turn])
                    t[turn] = turn && !out->kept
                                  ? t[0]
                                  : gl_texture(s->width, s->height, out->slices, out->format->internal,
                                               out->format->format, out->format->type, NULL);
                glBindFramebuffer(GL_FRAMEBUFFER, c->framebuffer[i][turn]);
                if (out->slices) glFramebufferTextureLayer(GL_FRAMEBUFFER, attached[o], t[turn], 0, out->slice);
                else             glFramebufferTexture2D(GL_FRAMEBUFFER, attached[o], GL_TEXTURE_2D, t[turn], 0);
                if (out->result == SSGI_GL_RESULT_LIGHT) c->light = out->texture;
                if (out->result == SSGI_GL_RESULT_BOUNCE) c->bounce = out->texture;
            }
            glDrawBuffers(s->outputs, attached);
            if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE)
                return kit_fail(err, "%s: this GL cannot draw into its targets", ssgi_gl_pass_name(s->desc.pass));
            for (int o = 0; o < s->outputs; ++o) {          /* once, so that no first frame reads what memory held */
                if (s->output[o].format->type == GL_UNSIGNED_INT) glClearBufferuiv(GL_COLOR, o, (const GLuint[4]){ 0 });
                else glClearBufferfv(GL_COLOR, o, (const GLfloat[4]){ 0 });
            }
        }
    }
    return 0;
}

/* yours: textures by their meaning. State that is expected: depth test, blending, culling and scissor off. */
static void chain_draw(chain *c, const ssgi_gl_frame *frame, const GLuint yours[SSGI_GL_YOURS])
{
    const unsigned turn = c->drawn++ & 1;
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, c->block);
    glBufferData(GL_UNIFORM_BUFFER, sizeof *frame, frame, GL_DYNAMIC_DRAW);
    for (int i = 0; i < c->steps; ++i) {
        const ssgi_gl_step *s = &c->step[i];
        for (int k = 0; k < s->inputs; ++k) {
            const ssgi_gl_input *in = &s->input[k];
            gl_bind((GLuint)in->unit, in->target,
                 in->texture < 0 ? yours[in->meaning] : c->texture[in->texture][turn ^ (unsigned)in->last]);
        }
        glBindFramebuffer(GL_FRAMEBUFFER, c->framebuffer[i][turn]);
        glViewport(0, 0, s->width, s->height);
        glUseProgram(c->program[i]);
        timer_begin(&c->time[i]);
        glDrawArraysInstanced(s->primitive, 0, s->vertices, s->instances);
        timer_end(&c->time[i]);
    }
}

static GLuint chain_result(const chain *c, int number) { return number < 0 ? 0 : c->texture[number][!(c->drawn & 1)]; }

/* ================================================================================================================== */

/* ---- >>methods: what may stand on a half of the window ----------------------------------------------------------- */

const method methods[METHODS] = {
    { "ssao", SSGI_GL_SSAO, 0, 0, 1 },
    { "hsao", SSGI_GL_HSAO, SSGI_GL_SLICES, 0, 0.6f },
    { "hsao-march", SSGI_GL_HSAO, SSGI_GL_MARCH, 0, 0.5f },
    { "ssdo", SSGI_GL_SSDO, SSGI_GL_SLICES, 1, 0.4f },
    { "ssdo-points", SSGI_GL_SSDO, SSGI_GL_POINTS, 1, 0.7f },
    { "s3ho", SSGI_GL_S3HO, SSGI_GL_SLICES, 1, 0.4f }
};
const char *const presets[3] = { "fast", "balanced", "best" };
const char *const behinds[BEHINDS] = { "auto", "constant", "solid", "width", "back", "slabs" };

/* The environment as a half's method reads it: harmonics, a map over a direction's solid angle, irradiance. */
static int environment_open(viewer *v, half *h, const ssgi_gl_desc *d)
{
    const kit_image *env = &v->lighting.env;
    const int harmonics = d->pass == SSGI_GL_S3HO;
    const double share = d->search == SSGI_GL_POINTS ? 2.0 / d->samples : 0.75 / d->directions;
    const float angle = (float)(KIT_PI * share);    /* of a direction's lobe */
    static float map[3 * MAP * MAP], open[3 * OPEN * OPEN];
    const char *why = "";
    ssgi_result r;
    if (harmonics) {
        r = ssgi_sh_project_equirect(h->harmonics, 4, v->equirect, env->width, env->height, &why);
        if (r == SSGI_OK) r = ssgi_environment_map(open, OPEN, v->equirect, env->width, env->height, 0, &why);
        if (r == SSGI_OK) r = ssgi_sh_residual(open, OPEN, h->harmonics, 4, NULL, 0, &why);
    } else {
        r = ssgi_environment_map(map, MAP, v->equirect, env->width, env->height, angle, &why);
        if (r == SSGI_OK) r = ssgi_environment_cone(open, OPEN, v->equirect, env->width, env->height, 0, &why);
        h->environment = gl_texture(MAP, MAP, 0, GL_RGBA32F, GL_RGB, GL_FLOAT, map);
    }
    h->irradiance = gl_texture(OPEN, OPEN, 1, GL_RGBA32F, GL_RGB, GL_FLOAT, open);
    return r == SSGI_OK ? 0 : kit_fail(&v->err, "--env: %s", why);
}

/* What the half's method is, as a chain: the desc, and what is drawn around it. */
static int half_open(viewer *v, half *h)
{
    const int m = h->method;
    ssgi_gl_chain want;
    const char *why = "";
    chain_close(&h->chain);
    glDeleteTextures(1, &h->environment);
    glDeleteTextures(1, &h->irradiance);
    glDeleteTextures(1, &h->picture);
    glDeleteFramebuffers(1, &h->framebuffer);
    h->environment = h->irradiance = 0;
    h->known = 0;
    h->picture = gl_texture(v->gbuffer.width, v->gbuffer.height, 0, GL_RGBA32F, GL_RGBA, GL_FLOAT, NULL);
    h->framebuffer = gl_framebuffer(&h->picture, 1, 0);
    if (m == TRUTH) return 0;
    memset(&want, 0, sizeof want);
    want.desc.pass = methods[m].pass;
    want.desc.search = methods[m].search;
    want.desc.environment = methods[m].lit ? SSGI_GL_ENVIRONMENT_MAP : SSGI_GL_ENVIRONMENT_NONE;
    if (ssgi_gl_preset(&want.desc, h->preset, &why) != SSGI_OK) return kit_fail(&v->err, "%s", why);
    want.desc.thickness = v->behind;
    want.desc.orthographic = !(v->camera.fovy > 0);
    want.desc.normal = v->from_depth ? SSGI_GL_NORMAL_FROM_DEPTH : SSGI_GL_NORMAL_SIGNED;
    if (methods[m].pass == SSGI_GL_SSDO) want.desc.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE;
    if (methods[m].pass == SSGI_GL_S3HO) {
        want.desc.bands = 4;
        want.desc.packed = want.desc.shaded = want.desc.residual = 1;
        want.desc.transfer = SSGI_GL_TRANSFER_BOTH;
        want.desc.restore = SSGI_GL_RESTORE_DIFFERENCE;
    }
    want.width = v->gbuffer.width;
    want.height = v->gbuffer.height;
    want.blur = 1;
    want.history = v->history;
    if (methods[m].lit && environment_open(v, h, &want.desc)) return -1;
    return chain_open(&h->chain, &want, &v->err);
}

/* The uniform block of a half: what changes per frame. */
static int frame_of(viewer *v, half *h, ssgi_gl_frame *f, const float to_view[16], const float projection[16])
{
    const char *why = "";
    ssgi_view view;
    if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, v->camera.width, v->camera.height, &why)
        || ssgi_gl_frame_init(f, &view, v->radius, &why)) return kit_fail(&v->err, "%s", why);
    f->thickness = methods[h->method].thickness * v->radius;
    for (int i = 0; i < 12; ++i) f->rotation[i] = i % 4 < 3 ? to_view[i] : 0;
    if (methods[h->method].pass == SSGI_GL_S3HO && ssgi_gl_harmonics_set(f, h->harmonics, 4, to_view, &why))
        return kit_fail(&v->err, "%s", why);
    if (v->history) {
        f->phase = ssgi_gl_phase(v->frame);
        if (h->known && ssgi_gl_frame_history(f, &h->last, to_view, h->last_to_view, &why))
            return kit_fail(&v->err, "%s", why);
    }
    h->last = view;
    memcpy(h->last_to_view, to_view, sizeof h->last_to_view);
    h->known = 1;
    return 0;
}

static int half_draw(viewer *v, half *h, const float to_view[16], const float projection[16])
{
    GLuint yours[SSGI_GL_YOURS] = { 0 };
    ssgi_gl_frame frame;
    const chain *c = &h->chain;
    if (frame_of(v, h, &frame, to_view, projection)) return -1;
    yours[SSGI_GL_YOUR_DEPTH] = v->gbuffer.depth;
    yours[SSGI_GL_YOUR_NORMAL] = v->gbuffer.normal;
    yours[SSGI_GL_YOUR_ALBEDO] = v->gbuffer.albedo;
    yours[SSGI_GL_YOUR_BACK] = v->behind == SSGI_GL_THICKNESS_SLABS ? v->gbuffer.slabs : v->gbuffer.back;
    yours[SSGI_GL_YOUR_ENVIRONMENT] = h->environment;
    yours[SSGI_GL_YOUR_IRRADIANCE] = h->irradiance;
    chain_draw(&h->chain, &frame, yours);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    glViewport(0, 0, v->gbuffer.width, v->gbuffer.height);
    glUseProgram(v->resolve);
    gl_bind(0, GL_TEXTURE_2D, chain_result(c, c->light));
    gl_bind(1, GL_TEXTURE_2D, chain_result(c, c->bounce));
    gl_bind(2, GL_TEXTURE_2D, v->gbuffer.albedo);
    gl_bind(3, GL_TEXTURE_2D, v->gbuffer.depth);
    glUniform1i(glGetUniformLocation(v->resolve, "lit"), !methods[h->method].lit ? 0 : c->bounce < 0 ? 1 : 2);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return 0;
}

/* ---- >>frame ----------------------------------------------------------------------------------------------------- */

static const char screen_vs[] =
    "#version 330 core\n"
    "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n";
static const char resolve_fs[] =            /* ambient visibility; or albedo * (light + bounce) */
    "#version 330 core\n"
    "uniform sampler2D light, bounce, albedo, depth; uniform int lit; out vec4 o;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
    "    bool seen = texelFetch(depth, p, 0).x < 1.0;\n"
    "    vec3 l = texelFetch(light, p, 0).rgb + (lit > 1 ? texelFetch(bounce, p, 0).rgb : vec3(0.0));\n"
    "    vec3 sent = seen ? texelFetch(albedo, p, 0).rgb * l : vec3(0.0);\n"
    "    o = vec4(lit == 0 ? texelFetch(light, p, 0).xxx : sent, seen);\n"
    "}\n";
static const char display_fs[] =
    "#version 330 core\n"
    "uniform sampler2D half0, half1, albedo; uniform float split; uniform ivec2 kind; out vec4 o;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
    "    bool first = float(p.x) < split;\n"
    "    vec3 c = first ? texelFetch(half0, p, 0).rgb : texelFetch(half1, p, 0).rgb;\n"
    "    int k = first ? kind.x : kind.y; // 0: visibility; 1: the same on colours; 2: radiance\n"
    "    vec4 a = texelFetch(albedo, p, 0);\n"
    "    if (k == 1) c = a.a > 0.0 ? c * a.rgb : vec3(0.2);\n"
    "    vec3 encoded = 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055;\n"
    "    if (k > 0) c = mix(encoded, 12.92 * c, lessThan(c, vec3(0.0031308)));\n"
    "    o = vec4(abs(float(p.x) + 0.5 - split) < 1.0 ? vec3(1.0, 0.6, 0.1) : c, 1.0);\n"
    "}\n";

/* The truth so far as a texture; rows turn over. */
static int truth_upload(viewer *v)
{
    const int w = v->truth.camera.width, height = v->truth.camera.height;
    const size_t row = 3 * (size_t)w;
    float *p = NULL;
    pthread_mutex_lock(&v->truth.lock);
    const int failed = v->truth.failed, is_new = v->shown.version != v->truth.now.version;
    if (is_new) p = malloc(row * (size_t)height * sizeof *p);
    for (int y = 0; y < height && p; ++y)
        memcpy(p + row * (size_t)y, v->truth.rgb + row * (size_t)(height - 1 - y), row * sizeof *p);
    v->shown = v->truth.now;
    if (failed) v->err = v->truth.err;
    pthread_mutex_unlock(&v->truth.lock);
    if (failed || !is_new) { free(p); return failed ? -1 : 0; }
    if (!p) return kit_fail(&v->err, "no memory for a truth of %d x %d", w, height);
    glDeleteTextures(1, &v->truth_picture);
    v->truth_picture = gl_texture(w, height, 0, GL_RGBA32F, GL_RGB, GL_FLOAT, p);
    free(p);
    return 0;
}

static int fit(viewer *v)                   /* sizes are the window's, programs the choices' */
{
    int w, h;
    glfwGetFramebufferSize(v->window, &w, &h);
    if (w < 1 || h < 1) return 0;
    const int sized = w != v->gbuffer.width || h != v->gbuffer.height;
    if (sized) gbuffer_size(&v->gbuffer, w, h);
    v->camera.width = w;
    v->camera.height = h;
    for (int i = 0; i < 1 + v->split_on && (sized || v->dirty); ++i) if (half_open(v, &v->half[i])) return -1;
    if ((sized || v->dirty) && glGetError() == GL_OUT_OF_MEMORY)
        return kit_fail(&v->err, "the GPU has no memory for a window of %d x %d", w, h);
    v->dirty = 0;
    return 0;
}

/* The truth beside what is drawn, and what that errs by. */
static int show_truth(viewer *v, const kit_camera *seen)
{
    if (truth_want(&v->truth, seen, v->radius, methods[v->half[0].method].lit, &v->err)) return -1;
    if (kit_seconds() > v->scored + 0.5) {
        for (int i = 0; i < 1 + v->split_on; ++i) half_score(v, &v->half[i]);
        v->scored = kit_seconds();
    }
    return truth_upload(v);
}

/* Both halves into the window. */
static void compose(const viewer *v)
{
    int kind[2];
    for (int i = 0; i < 2; ++i) {
        const int lit = v->half[i].method == TRUTH ? v->truth.lit : methods[v->half[i].method].lit;
        kind[i] = lit ? 2 : v->colours;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, v->camera.width, v->camera.height);
    glUseProgram(v->display);
    gl_bind(0, GL_TEXTURE_2D, v->half[0].picture);
    gl_bind(1, GL_TEXTURE_2D, !v->split_on                 ? v->half[0].picture
                           : v->half[1].method == TRUTH ? v->truth_picture
                                                        : v->half[1].picture);
    gl_bind(2, GL_TEXTURE_2D, v->gbuffer.albedo);
    glUniform1f(glGetUniformLocation(v->display, "split"),
                v->split_on ? floorf(v->split * (float)v->camera.width) : 4 * (float)v->camera.width);
    glUniform2i(glGetUniformLocation(v->display, "kind"), kind[0], kind[1]);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

static int show(viewer *v)
{
    kit_camera seen = v->camera;
    float to_view[16], projection[16];
    if (fit(v)) return -1;
    seen = v->camera;
    kit_camera_planes(&seen, &v->scene.mesh);
    kit_camera_matrices(&seen, to_view, projection);
    gbuffer_draw(&v->gbuffer, to_view, projection, v->behind);
    for (int i = 0; i < 1 + v->split_on; ++i)
        if (v->half[i].method != TRUTH && half_draw(v, &v->half[i], to_view, projection)) return -1;
    ++v->frame;
    if ((v->error || (v->split_on && v->half[1].method == TRUTH)) && show_truth(v, &seen)) return -1;
    compose(v);
    panel_draw(v);
    return 0;
}

static int programs_open(viewer *v)
{
    static const char *const samplers[][4] = { { "light", "bounce", "albedo", "depth" },
                                               { "half0", "half1", "albedo" } };
    const GLuint *const of[2] = { &v->resolve, &v->display };
    v->resolve = gl_program(screen_vs, resolve_fs, &v->err);
    v->display = gl_program(screen_vs, display_fs, &v->err);
    if (!v->resolve || !v->display) return -1;
    for (int p = 0; p < 2; ++p) {
        glUseProgram(*of[p]);
        for (int i = 0; i < 4 - p; ++i) glUniform1i(glGetUniformLocation(*of[p], samplers[p][i]), i);
    }
    return panel_open(v);
}

/* The scene's camera, or what was asked for instead. */
static int camera_of(viewer *v, const asked *to)
{
    kit_camera *c = &v->camera;
    double away[3], length = 0, up = 0, along = 0;
    *c = v->scene.camera;
    c->depth = KIT_DEPTH_NORMAL;
    if (to->camera) { memcpy(c->eye, to->place, sizeof c->eye); memcpy(c->target, to->place + 3, sizeof c->target); }
    if (to->up) memcpy(c->up, to->upward, sizeof c->up);
    for (int i = 0; i < 3; ++i) {
        away[i] = (double)c->eye[i] - (double)c->target[i];
        length += away[i] * away[i];
        up += (double)c->up[i] * (double)c->up[i];
        along += away[i] * (double)c->up[i];
    }
    if (!(length > 0)) return kit_fail(&v->err, "--camera: eye and target must differ");
    if (!(up > 0) || along * along > 0.999999 * length * up)
        return kit_fail(&v->err, "--up: must not be zero or along the view direction");
    v->home = *c;
    return 0;
}

static int open_scene(viewer *v, const asked *to)
{
    if (kit_scene_load(&v->scene, to->scene, to->ground, &v->err)) return -1;
    if (*v->scene.note) fprintf(stderr, "viewer: note: %s: %s\n", to->scene, v->scene.note);
    if (camera_of(v, to)) return -1;
    v->radius = to->radius[0] > 0 ? to->radius[0] : v->scene.radius;
    if (kit_env_read(&v->lighting.env, v->env, &v->err)) return -1;
    v->equirect = kit_env_interleaved(&v->lighting.env);
    return v->equirect ? 0 : kit_fail(&v->err, "out of memory");
}

/* The frame that --shot is of comes now: those before are drawn, a truth that is looked at has had its first rays. */
static int shot_next(const viewer *v)
{
    return v->shot && v->frame + 1 >= (unsigned)(v->frames ? v->frames : 1)
           && (!v->error || v->shown.rounds);
}

static int run(viewer *v)                   /* until the window is closed, or the picture is taken */
{
    v->truth.scene = &v->scene;
    v->truth.lighting = &v->lighting;
    v->dirty = 1;
    while (!glfwWindowShouldClose(v->window)) {
        glfwPollEvents();
        const int shot = shot_next(v);
        if (shot) v->scored = 0;
        if (show(v)) return -1;
        if (shot && v->error) printf("RMSE %.5f\n", v->half[0].error);
        if (shot) return window_save(v, v->shot);
        glfwSwapBuffers(v->window);
    }
    return 0;
}

int main(int argc, char **argv)
{
    static viewer v;
    asked to = { .size = { 1280, 720 } };
    char cores[32];
    kit_streams_open();
    pthread_mutex_init(&v.truth.lock, NULL);
    pthread_cond_init(&v.truth.wake, NULL);
    v.half[0].error = v.half[1].error = (double)NAN;
    v.half[0].method = v.half[1].method = 1;
    v.half[0].preset = v.half[1].preset = SSGI_GL_BALANCED;
    v.split = 0.5f;
    v.panel = -1;
    v.env = "sky";
    snprintf(cores, sizeof cores, "%ld", sysconf(_SC_NPROCESSORS_ONLN) > 1 ? sysconf(_SC_NPROCESSORS_ONLN) - 1 : 1);
    setenv("KIT_THREADS", cores, 0);        /* one core is left to draw */
    int failed = arguments(&v, &to, argc, argv);
    if (v.panel < 0) v.panel = !v.shot;
    if (!failed && to.help) fputs(usage, stdout);
    else if (!failed)
        failed = open_scene(&v, &to) || window_open(&v, to.size) || gbuffer_open(&v.gbuffer, &v.scene.mesh, &v.err)
              || programs_open(&v) || run(&v);
    truth_close(&v.truth);
    if (v.window) glfwDestroyWindow(v.window);
    glfwTerminate();
    if (!failed) failed = kit_streams_close(&v.err);
    if (failed) fprintf(stderr, "viewer: %s\n", v.err.text);
    kit_image_free(&v.lighting.env);
    kit_scene_free(&v.scene);
    free(v.equirect);
    return failed ? 2 : 0;
}
