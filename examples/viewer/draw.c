/* draw.c - draws a frame: the kit's G-buffer, each half's method on it by the kit's kit_frames, both halves into the
   window. At rest each frame's projection moves by less than a pixel, and the mean of the frames is shown, which
   smooths edges. Declared in viewer.h. */
#include "viewer.h"
#include <GLFW/glfw3.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char screen_vs[] =
    "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n";
static const char resolve_fs[] = /* draws visibility; or albedo * (light + bounce), less what both contain */
    "uniform sampler2D light, bounce, joint, albedo, depth;\n"
    "uniform int lit, margin; uniform float farthest;\n"
    "out vec4 o;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy) + margin;\n"
    "    bool seen = texelFetch(depth, p, 0).x != farthest;\n"
    "    vec3 l = lit > 0 ? texelFetch(light, p, 0).rgb : vec3(0.0);\n"
    "    if (lit > 1) l += texelFetch(bounce, p, 0).rgb;\n"
    "    if (lit > 2) l -= texelFetch(joint, p, 0).rgb;\n"
    "    vec3 sent = seen ? texelFetch(albedo, p, 0).rgb * l : vec3(0.0);\n"
    "    o = vec4(lit < 0 ? texelFetch(light, p, 0).xxx : sent, seen);\n"
    "}\n";
/* Draws a half into the window. kind 0: visibility; 1: visibility times colours; 2: radiance, without the environment.
   ray: of a pixel, in view space. */
static const char display_fs[] =
    "uniform sampler2D half0, half1, albedo, sky;\n"
    "uniform vec4 ray, window; uniform mat3 to_world; uniform float split, behind, part;\n"
    "uniform int kind0, kind1, environment; out vec4 o;\n"
    "vec3 sky_of(vec3 d) {\n"
    "    ivec2 size = textureSize(sky, 0);\n"
    "    vec2 at = vec2(0.5 - atan(d.x, d.z) / 6.28318530718, 0.5 - atan(d.y, length(d.xz)) / 3.14159265359);\n"
    "    at = at * vec2(size) - 0.5;\n"
    "    ivec2 p = ivec2(floor(at)), x = (ivec2(p.x, p.x + 1) + size.x) % size.x;\n"
    "    ivec2 y = clamp(ivec2(p.y, p.y + 1), 0, size.y - 1);\n"
    "    at -= vec2(p);\n"
    "    vec3 above = mix(texelFetch(sky, ivec2(x.x, y.x), 0).rgb, texelFetch(sky, ivec2(x.y, y.x), 0).rgb, at.x);\n"
    "    vec3 below = mix(texelFetch(sky, ivec2(x.x, y.y), 0).rgb, texelFetch(sky, ivec2(x.y, y.y), 0).rgb, at.x);\n"
    "    return mix(above, below, at.y);\n"
    "}\n"
    "void main() {\n"
    "    vec2 at = gl_FragCoord.xy * window.zw, ndc = 2.0 * at - 1.0;\n"
    "    bool first = floor(gl_FragCoord.x) < split;\n"
    "    vec4 c = first ? texture(half0, at) : texture(half1, at), a = texture(albedo, at);\n"
    "    int kind = first ? kind0 : kind1;\n"
    "    if (kind == 1) c.rgb = a.a > 0.0 ? c.rgb * a.rgb : vec3(behind);\n"
    "    if (kind == 2 && environment > 0 && c.a < 1.0) {\n"
    "        vec3 d = environment > 1 ? vec3(0.0, 0.0, -1.0) : vec3((ndc + ray.xy) * ray.zw, -1.0);\n"
    "        c.rgb += (1.0 - c.a) * sky_of(to_world * d);\n"
    "    }\n"
    "    vec3 encoded = 1.055 * pow(max(c.rgb, 0.0), vec3(1.0 / 2.4)) - 0.055;\n"
    "    if (kind > 0) c.rgb = mix(encoded, 12.92 * c.rgb, lessThan(c.rgb, vec3(0.0031308)));\n"
    "    c.rgb = clamp(c.rgb, 0.0, 1.0);\n"
    "    o = vec4(abs(gl_FragCoord.x - split) < 1.0 ? vec3(1.0, 0.6, 0.1) : c.rgb, part);\n"
    "}\n";

/* ---- >>programs -------------------------------------------------------------------------------------------------- */

static GLint place(GLuint program, const char *name) { return glGetUniformLocation(program, name); }

static void bind(GLuint unit, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture);
}

int draw_open(viewer *v)
{
    static const char *const samplers[2][5] = { { "light", "bounce", "joint", "albedo", "depth" },
                                                { "half0", "half1", "albedo", "sky", NULL } };
    const GLuint *const of[2] = { &v->resolve, &v->display };
    v->resolve = kit_program_text("", screen_vs, resolve_fs, &v->err);
    v->display = v->resolve ? kit_program_text("", screen_vs, display_fs, &v->err) : 0;
    if (!v->display) return -1;
    for (int p = 0; p < 2; ++p) {
        v->side[p].frames.jittered = 1;
        glUseProgram(*of[p]);
        for (int i = 0; i < 5 && samplers[p][i]; ++i) glUniform1i(place(*of[p], samplers[p][i]), i);
    }
    return motion_open(v) || panel_open(v) ? -1 : 0;
}

void draw_forget(viewer *v)
{
    if (v->kept) kit_mesh_forget();
    v->kept = 0;
}

void draw_close(viewer *v)
{
    draw_forget(v);
    for (int i = 0; i < 2; ++i) {
        kit_frames_close(&v->side[i].frames);
        if (v->gbuffer[i].depth) kit_gbuffer_free(&v->gbuffer[i]);
    }
}

/* ---- >>frame ----------------------------------------------------------------------------------------------------- */

/* Replaces a texture that is drawn into by one of another size. */
static void renew(GLuint *picture, GLuint *framebuffer, const int size[2])
{
    if (*picture) glDeleteTextures(1, picture);
    if (!*framebuffer) glGenFramebuffers(1, framebuffer);
    *picture = kit_texture(size[0], size[1], GL_RGBA32F, NULL);
    bind(0, *picture);
    kit_texture_linear(GL_TEXTURE_2D);
    glBindFramebuffer(GL_FRAMEBUFFER, *framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, *picture, 0);
}

static int drawn(const viewer *v, int i) { return (!i || v->split_on) && !v->side[i].truth; }

/* Fits the size of both halves' textures to the window, or a share of it. Returns 1 if it has changed. */
static int fit(viewer *v)
{
    int size[2];
    glfwGetFramebufferSize(v->window, &v->size[0], &v->size[1]);
    if (v->size[0] < 1 || v->size[1] < 1) return 0;
    pace_size(&v->pace, v->size, size);
    if (!memcmp(size, v->drawn, sizeof size) && v->side[0].picture) return 0;
    memcpy(v->drawn, size, sizeof size);
    for (int i = 0; i < 2; ++i) renew(&v->side[i].picture, &v->side[i].framebuffer, size);
    v->camera.width = size[0];
    v->camera.height = size[1];
    return 1;
}

/* Draws a half's result into its texture. */
static void resolve(const viewer *v, const side *s)
{
    const kit_run *run = s->frames.now;
    const int lit = !run->lit ? -1 : !run->light ? 0 : !run->bounce ? 1 : !run->joint ? 2 : 3;
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffer);
    glViewport(0, 0, v->drawn[0], v->drawn[1]);
    glUseProgram(v->resolve);
    bind(0, run->light);
    bind(1, run->bounce);
    bind(2, run->joint);
    bind(3, run->gbuffer->albedo);
    bind(4, run->gbuffer->depth);
    glUniform1i(place(v->resolve, "lit"), lit);
    glUniform1i(place(v->resolve, "margin"), run->margin);
    glUniform1f(place(v->resolve, "farthest"), run->gbuffer->camera.depth == KIT_DEPTH_NORMAL ? 1.0f : 0.0f);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/* Reports a method's failure once; the method is not tried again until the user chooses something. */
static int side_failed(viewer *v, side *s)
{
    static const GLfloat grey[4] = { 0.05f, 0.05f, 0.05f, 1 };
    s->failed = v->err;
    glBindFramebuffer(GL_FRAMEBUFFER, s->framebuffer);
    glClearBufferfv(GL_COLOR, 0, grey);
    panel_say(v, s->failed.text);
    return v->shot ? -1 : 0;
}

static int side_draw(viewer *v, side *s, int opens)
{
    const kit_world world = { &v->scene, &v->light.now };
    if (v->restart) {
        kit_frames_close(&s->frames);
        *s->failed.text = 0;
    }
    if (*s->failed.text) return 0;
    kit_method method = s->method;
    method.set.size *= pace_coarse(&v->pace);
    if (opens || !s->frames.now ? kit_frames_next(&s->frames, v->seen, &method, v->radius, &world, NULL, &v->err)
                                : kit_frames_again(&s->frames, &v->err))
        return side_failed(v, s);
    kit_run_draw(s->frames.now, v->panel ? KIT_PASSES : KIT_UNTIMED);
    resolve(v, s);
    return 0;
}

/* Returns whether frames are averaged. Not beside the ground truth: that is traced at the pixels' centres, and so the
   image must be drawn there. */
static int averages(const viewer *v) { return v->pace.still && !v->error && !(v->split_on && v->side[1].truth); }

/* Draws both halves. Their runs refer to the last frame's G-buffer until they have opened this frame's. */
static int draw_sides(viewer *v, int opens)
{
    kit_gbuffer *next = v->seen == &v->gbuffer[0] ? &v->gbuffer[1] : &v->gbuffer[0];
    kit_gbuffer *last = v->seen;
    kit_camera camera = v->camera;
    for (unsigned k = 0; k < 2 && averages(v); ++k) camera.shift[k] += ssgi_radical_inverse(2 + k, v->mean + 1) - 0.5f;
    if (opens) {
        if (!v->kept && kit_mesh_keep(&v->scene.mesh, &v->err)) return -1;
        v->kept = 1;
        if (kit_gbuffer_from_scene(next, &v->scene, &camera, NULL, &v->err)) return -1;
        memcpy(v->stood[next - v->gbuffer], v->slid, sizeof v->slid);
        if (last && v->slides && motion_draw(v, next, last)) return -1;
        v->seen = next;
    }
    for (int i = 0; i < 2; ++i) {
        if (!drawn(v, i)) kit_frames_close(&v->side[i].frames);
        else if (side_draw(v, &v->side[i], opens)) return -1;
    }
    if (opens && last) kit_gbuffer_free(last);
    return 0;
}

/* ---- >>window ---------------------------------------------------------------------------------------------------- */

/* Returns the texture of the environment, which is shown behind the scene. */
static GLuint sky_of(viewer *v)
{
    const kit_image *env = &v->light.now.env;
    const size_t texels = (size_t)env->width * (size_t)env->height;
    if (!env->data || v->light.texture) return v->light.texture;
    float *rgba = malloc(4 * texels * sizeof *rgba);
    for (size_t i = 0; rgba && i < 4 * texels; ++i) rgba[i] = i % 4 < 3 ? env->data[i % 4 * texels + i / 4] : 1;
    if (rgba) v->light.texture = kit_texture(env->width, env->height, GL_RGBA32F, rgba);
    free(rgba);
    return v->light.texture;
}

/* Sets the uniforms from which a shader computes each pixel's ray. */
static void aim(const viewer *v, GLuint program, int sky)
{
    const float *p = v->seen->projection, width = (float)v->size[0], height = (float)v->size[1];
    const float ray[4] = { p[8], p[9], 1 / p[0], 1 / p[5] }, window[4] = { width, height, 1 / width, 1 / height };
    float view[16], projection[16], to_world[9];
    kit_camera_matrices(&v->seen->camera, view, projection);
    for (int i = 0; i < 9; ++i) to_world[i] = view[4 * (i % 3) + i / 3];
    glUniform4fv(place(program, "ray"), 1, ray);
    glUniform4fv(place(program, "window"), 1, window);
    glUniformMatrix3fv(place(program, "to_world"), 1, GL_FALSE, to_world);
    glUniform1i(place(program, "environment"), !sky ? 0 : v->seen->camera.fovy > 0 ? 1 : 2);
}

static int kind_of(const viewer *v, const side *s)
{
    return (s->truth ? v->truth.method.lit : s->method.lit) ? 2 : v->colours;
}

/* Shows both halves in a framebuffer; part: the weight of the new image over the framebuffer's old content. */
static void show(viewer *v, GLuint framebuffer, float part)
{
    const side *s = v->side, *right = v->split_on ? &s[1] : s;
    const GLuint sky = sky_of(v);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, v->size[0], v->size[1]);
    glUseProgram(v->display);
    bind(0, s->picture);
    bind(1, right->truth ? v->truth_picture : right->picture);
    bind(2, v->seen->albedo);
    bind(3, sky);
    aim(v, v->display, sky != 0);
    glUniform1f(place(v->display, "split"), v->split_on ? floorf(v->split * (float)v->size[0]) : 4 * (float)v->size[0]);
    glUniform1f(place(v->display, "behind"), KIT_BEHIND);
    glUniform1f(place(v->display, "part"), part);
    glUniform1i(place(v->display, "kind0"), kind_of(v, s));
    glUniform1i(place(v->display, "kind1"), kind_of(v, right));
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glActiveTexture(GL_TEXTURE0);
}

/* Adds a frame to the mean. Its first frame is not blended, because a new texture may hold NaN. */
static void add_to_mean(viewer *v)
{
    if (v->mean) glEnable(GL_BLEND);
    else renew(&v->mean_picture, &v->mean_framebuffer, v->size);
    ++v->mean;
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA);
    show(v, v->mean_framebuffer, 1 / (float)v->mean);
    glDisable(GL_BLEND);
}

static void show_mean(const viewer *v)
{
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glViewport(0, 0, v->size[0], v->size[1]);
    glUseProgram(v->display);
    bind(0, v->mean_picture);
    glUniform1f(place(v->display, "split"), 4 * (float)v->size[0]);
    glUniform1i(place(v->display, "kind0"), 0);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/* ---- >>next ---------------------------------------------------------------------------------------------------- */

/* Returns whether a frame is drawn in full. After a choice of the user one frame compiles, and two measure the time. */
static int opens_again(const viewer *v)
{
    return v->moved || v->restart || !v->seen || averages(v) || (v->pace.opened < (v->pace.still ? 1 : 3) && !v->shot);
}

/* Returns whether another frame of the same size would look the same. */
static int drawn_enough(const viewer *v)
{
    int more = opens_again(v);
    for (int i = 0; i < 2; ++i)
        if (drawn(v, i) && v->side[i].method.set.history && !*v->side[i].failed.text) more |= v->still < VIEWER_STILL;
    return !more;
}

int draw_settled(const viewer *v)
{
    if (averages(v) && !v->moved && !v->restart) return v->mean >= VIEWER_STILL;
    return drawn_enough(v) && pace_waits(&v->pace);
}

/* Returns whether a shown method uses surfels. */
static int of_surfels(const viewer *v)
{
    int found = 0;
    for (int i = 0; i < 2; ++i) found |= drawn(v, i) && v->side[i].method.set.size > 0;
    return found;
}

int draw_frame(viewer *v)
{
    const double coarse = pace_coarse(&v->pace);
    if (v->moved || v->restart) pace_moves(&v->pace);
    else if (!v->shot) pace_stays(&v->pace);
    const int sized = fit(v) || coarse != pace_coarse(&v->pace);
    if (v->restart || sized) v->pace.opened = 0;
    if (v->moved || v->restart || sized) v->still = v->mean = 0;
    const int opens = sized || opens_again(v);
    const double began = kit_seconds();
    if (draw_sides(v, opens)) return -1;
    if (averages(v)) add_to_mean(v);
    glFinish();
    if (glGetError() == GL_OUT_OF_MEMORY)
        return kit_fail(&v->err, "the GPU has no memory for a window of %d x %d", v->size[0], v->size[1]);
    v->ms = (kit_seconds() - began) * 1e3;
    v->moved = v->restart = 0;
    ++v->still;
    ++v->frame;
    if (!opens || ++v->pace.opened < 2 || !pace_took(&v->pace, v->ms, of_surfels(v))) return 0;
    if (!v->panel) panel_say(v, "the size is chosen by the frame's time (f: fixed)");
    return 0;
}

/* ---- >>truth ---------------------------------------------------------------------------------------------------- */

/* Uploads the present ground truth as a texture, with its rows reversed. */
static int truth_upload(viewer *v)
{
    const int w = v->truth.camera.width, height = v->truth.camera.height, lit = v->truth.method.lit;
    float *p = NULL;
    pthread_mutex_lock(&v->truth.lock);
    const int failed = v->truth.failed, is_new = v->shown.version != v->truth.now.version;
    if (is_new) p = malloc(4 * (size_t)w * (size_t)height * sizeof *p);
    for (int i = 0; i < w * height && p; ++i) {
        const float *from = v->truth.rgb + 3 * ((height - 1 - i / w) * w + i % w);
        memcpy(p + 4 * i, from, 3 * sizeof *p);
        p[4 * i + 3] = !lit || from[0] > 0 || from[1] > 0 || from[2] > 0 ? 1.0f : 0.0f;
    }
    v->shown = v->truth.now;
    if (failed) v->err = v->truth.err;
    pthread_mutex_unlock(&v->truth.lock);
    if (failed || !is_new) {
        free(p);
        return failed ? -1 : 0;
    }
    if (!p) return kit_fail(&v->err, "no memory for a truth of %d x %d", w, height);
    if (v->truth_picture) glDeleteTextures(1, &v->truth_picture);
    v->truth_picture = kit_texture(w, height, GL_RGBA32F, p);
    free(p);
    return 0;
}

/* Shows the ground truth beside the method, and the method's error. */
static void show_truth(viewer *v)
{
    int failed = truth_want(&v->truth, &v->seen->camera, &v->side[0].method, v->radius, &v->err);
    if (!failed && kit_seconds() > v->scored + 0.5) {
        for (int i = 0; i < 2; ++i)
            if (drawn(v, i)) side_score(v, &v->side[i]);
        v->scored = kit_seconds();
    }
    if (failed || truth_upload(v)) panel_say(v, v->err.text);
}

void draw_window(viewer *v)
{
    if (v->error || (v->split_on && v->side[1].truth)) show_truth(v);
    if (v->mean) show_mean(v);
    else show(v, 0, 1);
}
