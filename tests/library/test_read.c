/* test_read.c - ssgi_gl_read: shaders that light a surface read the results of gathers and filters. Such a shader gets
   the filter pass's value if the depth buffer shows its surface, and the surface's own share of it if not. */
#include "kit/kit_run.h"
#include "frames.h"
#include <math.h>
#include <string.h>

enum { W = 192, H = 108, SIDE = 64, SAMPLES = 4 };

static kit_error err;

static const char triangle[] = "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, "
                               "0.0, 1.0); }\n";

/* Compiles a program with a desc's functions and this main. The caller binds its textures. Returns 0 on failure. */
static GLuint program_of(const ssgi_gl_desc *desc, const char *vertex, const char *main_)
{
    static char text[1 << 15];
    ssgi_gl_desc d = *desc;
    d.shader.dialect = kit_dialect();
    const size_t n = ssgi_gl_read(text, sizeof text, &d);
    if (!CHECK(n, "%s: there are no functions that read it", ssgi_gl_pass_name(d.pass))) return 0;
    snprintf(text + n, sizeof text - n, "layout(location = 0) out vec4 o;\n%s", main_);
    const GLuint program = kit_program_text("", vertex, text, &err);
    if (!CHECK(program, "%s", err.text)) return 0;
    glUseProgram(program);
    glUniformBlockBinding(program, glGetUniformBlockIndex(program, "ssgi_frame"), 0);
    return program;
}

static void bind(GLuint program, const char *name, int unit, GLenum target, GLuint texture)
{
    glActiveTexture(GL_TEXTURE0 + (GLenum)unit);
    glBindTexture(target, texture);
    glUniform1i(glGetUniformLocation(program, name), unit);
    glActiveTexture(GL_TEXTURE0);
}

static GLuint target_of(GLenum kind, GLuint texture)
{
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, kind, texture, 0);
    return framebuffer;
}

/* ---- as the filter ----------------------------------------------------------------------------------------------- */

typedef struct subject { const char *method, *set, *call; } subject;

/* Returns the index of the filter's pass, the last one, in an open run; -1: it has none. */
static int filter_of(const kit_run *run)
{
    int at = run->passes - 1;
    while (at >= 0 && run->pass[at].desc.pass != SSGI_GL_PASS_BLUR && run->pass[at].desc.pass != SSGI_GL_PASS_HISTORY)
        --at;
    return at;
}

/* Draws a picture with the functions, by the G-buffer's depths and normals, and the filter's picture. */
static int drawn_by(float *out, float *filtered, const kit_run *run, const subject *s)
{
    char main_[400];
    const kit_pass *const p = &run->pass[filter_of(run)];
    const int kept = p->desc.pass == SSGI_GL_PASS_HISTORY;
    const ssgi_gl_desc *const of = kept ? &p->desc : &p[-1].desc;
    snprintf(main_, sizeof main_,
             "uniform highp sampler2D u_depth, u_normal;\nvoid main() {\n    ivec2 p = ivec2(gl_FragCoord.xy);\n"
             "    float z = ssgi_fragment_depth(gl_FragCoord.xy, texelFetch(u_depth, p, 0).x);\n"
             "    vec3 n = texelFetch(u_normal, p, 0).xyz;\n    o = vec4(%s);\n}\n", s->call);
    const GLuint program = program_of(of, triangle, main_), target = kit_texture(W, H, GL_RGBA32F, NULL);
    if (!program) return 0;
    for (int i = 0; i < p->rows; ++i)
        if (p->io[i].kind == SSGI_GL_IO_TEXTURE && glGetUniformLocation(program, p->io[i].name) >= 0)
            bind(program, p->io[i].name, p->io[i].slot, kit_target_of(&p->io[i]),
                 kept ? p->target[0] : kit_pass_texture(run, p, p->io[i].name));
    bind(program, "u_depth", 14, GL_TEXTURE_2D, run->gbuffer->depth);
    bind(program, "u_normal", 15, GL_TEXTURE_2D, run->gbuffer->normal);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, run->block[0]);
    GLuint framebuffer = target_of(GL_TEXTURE_2D, target);
    glViewport(0, 0, W, H);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteProgram(program);
    const int ok = TRY(kit_texture_read(target, W, H, 4, out))
                && TRY(kit_texture_read(p->target[0], W, H, 4, filtered));
    glDeleteTextures(1, &target);
    return ok;
}

static void as_the_filter(void)
{
#define AT "(gl_FragCoord.xy, z, n)"
    static const subject subjects[] = {
        { "hsao", "", "vec3(ssgi_visibility_at" AT "), 1.0" },
        { "hsao", "blur=2", "vec3(ssgi_visibility_at" AT "), 1.0" },
        { "hsao", "resolution=full", "vec3(ssgi_visibility_at" AT "), 1.0" },
        { "hsao", "resolution=quarter", "vec3(ssgi_visibility_at" AT "), 1.0" },
        { "hsao", "history=1", "vec3(ssgi_visibility_at" AT "), 1.0" },
        { "ssdo", "bounce=none", "ssgi_irradiance_at" AT ", 1.0" },
        { "ssdo", "bounce=none,history=1", "ssgi_irradiance_at" AT ", 1.0" },
        { "ssdo", "bounce=none,environment=sh,resolution=full", "ssgi_irradiance_at" AT ", 1.0" },
        { "s3ho", "indirect=none", "ssgi_irradiance_at" AT ", 1.0" },
        { "s3ho", "indirect=none,filtered=coefficients,store=float", "ssgi_coefficients_at" AT ".channel[0].word0" }
    };
    static float out[4 * W * H], filtered[4 * W * H];
    OWN(scenery) of = { 0 };
    OWN(kit_image) frame = { 0 };
    if (!set_scene(&of, "casters", NULL, "sky", NULL, W, H) || !TRY(kit_gbuffer_read(&frame, &of.g, &err))) return;
    const float *const depth = kit_image_channel(&frame, "Z");
    for (const subject *s = subjects; s < subjects + sizeof subjects / sizeof *subjects; ++s) {
        OWN(kit_run) run = { 0 };
        int seen = 0, differ = 0;
        double worst = 0;
        if (!open_run(&run, &of.g, s->method, s->set, 0.5f, &of.scene, &of.light)) return;
        kit_run_update(&run);
        kit_run_draw(&run, 0);
        const int channels = *s->call == 'v' ? 1 : *s->set == 'i' && strstr(s->set, "coeff") ? 4 : 3;
        if (drawn_by(out, filtered, &run, s))
            for (int i = 0; i < W * H; ++i) {
                double off = 0;
                const int row = H - 1 - i / W;
                if (!(depth[row * W + i % W] > 0)) continue;
                for (int c = 0; c < channels; ++c)
                    off = fmax(off, fabs((double)out[4 * i + c] - (double)filtered[4 * i + c]));
                ++seen;
                differ += !(off < 0.002);
                worst = fmax(worst, off);
            }
        /* pixels differ where no texel shows the surface, which is more often at quarter resolution */
        SHOW(seen > W * H / 2 && differ <= seen / (strstr(s->set, "quarter") ? 100 : 1000),
             "%s %s: of %d pixels %d are not the filter's, by %.4f", s->method, s->set, seen, differ, worst);
    }
}

/* ---- edges, and surfaces that no texel shows -------------------------------------------------------------------- */

/* A wall that is not square to the view, and a card before it, as planes n P = planes[k][3]; their visibilities. */
static const float planes[2][4] = { { 0.3f, 0.2f, 0.9327379f, -5.5f }, { -0.2f, 0.1f, 0.9746794f, -3 } };
static const float visibility[2] = { 0.9f, 0.2f };
/* A card so steep that a third of a pixel aside is several footprints nearer. */
static const float steep[4] = { -0.95f, 0.2f, 0.2397916f, -3 };
/* the card's corners in NDC, turned so that each of its edges crosses pixels */
static const float corner[4][2] = { { -0.31f, -0.52f }, { 0.55f, -0.33f }, { -0.48f, 0.27f }, { 0.38f, 0.46f } };

static int inside_card(double x, double y) /* x, y: NDC */
{
    static const int round[5] = { 0, 1, 3, 2, 0 };
    int in = 1;
    for (int k = 0; k < 4; ++k) {
        const float *const a = corner[round[k]], *const b = corner[round[k + 1]];
        const double side[2] = { (double)b[0] - (double)a[0], (double)b[1] - (double)a[1] };
        in &= side[0] * (y - (double)a[1]) - side[1] * (x - (double)a[0]) > 0;
    }
    return in;
}

static double depth_at(const ssgi_gl_frame *f, int orthographic, const float plane[4], double x, double y)
{
    const double ray[2] = { x * (double)f->unproject[0] + (double)f->unproject[2],
                            y * (double)f->unproject[1] + (double)f->unproject[3] };
    const double across = ray[0] * (double)plane[0] + ray[1] * (double)plane[1];
    return orthographic ? (across - (double)plane[3]) / (double)plane[2]
                        : (double)plane[3] / (across - (double)plane[2]);
}

/* Makes the result of a gather or of pass history for wall and card. eye: how far the eye stands before them. */
static GLuint result_of(const ssgi_gl_frame *f, const ssgi_gl_desc *d, const float of_card[4], double eye)
{
    static float texel[4 * SIDE * SIDE];
    const int part = d->gather.resolution == SSGI_GL_RESOLUTION_QUARTER ? 4 : d->gather.resolution ? 2 : 1,
        side = SIDE / part,
              kept = d->pass == SSGI_GL_PASS_HISTORY, channels = kept ? 4 : 2;
    for (int i = 0; i < side * side; ++i) {
        const double x = part * (i % side) + 0.5, y = part * (i / side) + 0.5;
        const int card = inside_card(2 * x / SIDE - 1, 2 * y / SIDE - 1);
        texel[channels * i] = visibility[card];
        texel[channels * i + 1] = (float)(depth_at(f, d->input.orthographic, card ? of_card : planes[0], x, y)
                                          + eye - (double)f->decode[3]);
        for (int k = 2; k < channels; ++k) texel[channels * i + k] = 1;
    }
    return kit_texture(side, side, kept ? GL_RGBA32F : GL_RG32F, texel);
}

static int frame_of(ssgi_gl_frame *f, int orthographic, float eye)
{
    const float s = orthographic ? 0.4f : 1.5f,
                wide[16] = { s, 0, 0, 0, 0, s, 0, 0, 0, 0, -0.02f, 0, 0, 0, -1 - 0.02f * eye, 1 },
                deep[16] = { s, 0, 0, 0, 0, s, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2002f, 0 };
    ssgi_view view;
    const char *why = "";
    return CHECK(ssgi_view_from_projection(&view, orthographic ? wide : deep, SSGI_CLIP_GL, SIDE, SIDE, &why) == SSGI_OK
                     && ssgi_gl_frame_init(f, &view, 1, &why) == SSGI_OK, "%s", why);
}

static GLuint block_of(const ssgi_gl_frame *f)
{
    GLuint block;
    glGenBuffers(1, &block);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, block);
    glBufferData(GL_UNIFORM_BUFFER, sizeof *f, f, GL_STATIC_DRAW);
    return block;
}

/* Reads the mean of a multisampled texture's samples. */
static int resolved(float *out, GLuint samples)
{
    const GLuint target = kit_texture(SIDE, SIDE, GL_RGBA32F, NULL);
    static const char mean_of[] = "uniform sampler2DMS u_samples; layout(location = 0) out vec4 o;\n"
                                  "void main() { o = vec4(0.0); for (int s = 0; s < 4; ++s) o += 0.25 * "
                                  "texelFetch(u_samples, ivec2(gl_FragCoord.xy), s); }\n";
    const GLuint program = kit_program_text("", triangle, mean_of, &err);
    GLuint framebuffer = target_of(GL_TEXTURE_2D, target);
    if (!CHECK(program, "%s", err.text)) return 0;
    glUseProgram(program);
    bind(program, "u_samples", 0, GL_TEXTURE_2D_MULTISAMPLE, samples);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const int ok = TRY(kit_texture_read(target, SIDE, SIDE, 1, out));
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteProgram(program);
    glDeleteTextures(1, &target);
    return ok;
}

/* A plane that is drawn into the bound target with the functions: all over it, or only the card. aside: of samples,
   from a pixel's centre; away: how far the plane lies before the result's surface; draws share * v + is. */
typedef struct painted { const float *plane; int card; float aside[2], away, share, is; } painted;
static int paint(const ssgi_gl_desc *d, GLuint result, double eye, const painted *p)
{
    static const char card[] = "uniform vec2 corner[4];\n"
                               "void main() { gl_Position = vec4(corner[gl_VertexID], 0.0, 1.0); }\n";
    char main_[700];
    snprintf(main_, sizeof main_, "uniform vec4 u_plane; uniform vec2 u_aside; uniform float u_away, u_share, u_is;\n"
             "void main() {\n    vec2 place = gl_FragCoord.xy + u_aside;\n"
             "    vec2 ray = place * u_ssgi_unproject.xy + u_ssgi_unproject.zw;\n    vec4 k = u_plane;\n"
             "    k.w += u_away;\n    float z = %s + %.1f;\n"
             "    o = vec4(ssgi_visibility_at(place, z, u_plane.xyz) * u_share + u_is);\n}\n",
             d->input.orthographic ? "(dot(ray, k.xy) - k.w) / k.z" : "k.w / (dot(ray, k.xy) - k.z)", eye);
    const GLuint program = program_of(d, p->card ? card : triangle, main_);
    if (!program) return 0;
    bind(program, "t_ssgi_ao", 9, GL_TEXTURE_2D, result);
    glUniform4fv(glGetUniformLocation(program, "u_plane"), 1, p->plane);
    glUniform2fv(glGetUniformLocation(program, "u_aside"), 1, p->aside);
    glUniform1f(glGetUniformLocation(program, "u_away"), p->away);
    glUniform1f(glGetUniformLocation(program, "u_share"), p->share);
    glUniform1f(glGetUniformLocation(program, "u_is"), p->is);
    if (p->card) glUniform2fv(glGetUniformLocation(program, "corner"), 4, corner[0]);
    glDrawArrays(p->card ? GL_TRIANGLE_STRIP : GL_TRIANGLES, 0, p->card ? 4 : 3);
    glDeleteProgram(program);
    return 1;
}

/* Draws wall and card multisampled. read: by the functions of ssgi_gl_read; else by the texture's values. */
static int edges(float *out, const ssgi_gl_desc *d, GLuint result, double eye, int read)
{
    GLuint samples;
    int ok = 1;
    glGenTextures(1, &samples);
    glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, samples);
    glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, SAMPLES, GL_RGBA32F, SIDE, SIDE, GL_TRUE);
    GLuint framebuffer = target_of(GL_TEXTURE_2D_MULTISAMPLE, samples);
    for (int k = 0; k < 2 && ok; ++k) {
        const painted p = { planes[k], k, { 0, 0 }, 0, read ? 1 : 1e-9f, read ? 0 : visibility[k] };
        ok = paint(d, result, eye, &p);
    }
    glDeleteFramebuffers(1, &framebuffer);
    ok = ok && resolved(out, samples);
    glDeleteTextures(1, &samples);
    return ok;
}

/* Returns the largest error of visibility in the middle of the card. */
static double beside(const float *out)
{
    double worst = 0;
    for (int y = 28; y < 36; ++y)
        for (int x = 28; x < 36; ++x)
            worst = fmax(worst, fabs((double)out[y * SIDE + x] - (double)visibility[1]));
    return worst;
}

/* A table of results' descs, and how far the eye stands before the surfaces. */
static const struct { ssgi_gl_desc desc; float eye; } results[] = {
    { { .pass = SSGI_GL_PASS_HSAO, .gather.resolution = SSGI_GL_RESOLUTION_HALF }, 0 },
    { { .pass = SSGI_GL_PASS_HSAO, .gather.resolution = SSGI_GL_RESOLUTION_QUARTER }, 0 },
    { { .pass = SSGI_GL_PASS_SSAO }, 0 },
    { { .pass = SSGI_GL_PASS_HISTORY }, 0 },
    { { .pass = SSGI_GL_PASS_HSAO, .gather.resolution = SSGI_GL_RESOLUTION_HALF, .input.orthographic = 1 }, 0 },
    { { .pass = SSGI_GL_PASS_HISTORY, .input.orthographic = 1 }, 0 },
    { { .pass = SSGI_GL_PASS_HSAO, .gather.resolution = SSGI_GL_RESOLUTION_HALF, .input.orthographic = 1 }, 1e5f },
    { { .pass = SSGI_GL_PASS_HISTORY, .input.orthographic = 1 }, 1e5f },
    { { .pass = SSGI_GL_PASS_HISTORY, .input.orthographic = 1 }, -20 }
};

/* Checks edges of wall and card; a pane before the card, at these distances in radii; samples off the centre. */
static void edges_and_panes(void)
{
    static const float away[] = { 0, 0.1f, 0.5f, 2 };
    static float read[SIDE * SIDE], want[SIDE * SIDE], out[SIDE * SIDE];
    GLuint target = kit_texture(SIDE, SIDE, GL_RGBA32F, NULL);
    glViewport(0, 0, SIDE, SIDE);
    for (int r = 0; r < ROWS(results); ++r) {
        const ssgi_gl_desc *const d = &results[r].desc;
        const double eye = (double)results[r].eye;
        char name[96];
        ssgi_gl_frame f;
        double got[ROWS(away)], worst = 0, plain = 0, lies = 0;
        if (!frame_of(&f, d->input.orthographic, results[r].eye)) return;
        GLuint result[2] = { result_of(&f, d, planes[1], eye), result_of(&f, d, steep, eye) }, block = block_of(&f);
        snprintf(name, sizeof name, "%s, half %d, orthographic %d, eye %g", ssgi_gl_pass_name(d->pass),
            d->gather.resolution,
                 d->input.orthographic, eye);
        if (glTexImage2DMultisample) {
            if (!edges(read, d, result[0], eye, 1) || !edges(want, d, result[0], eye, 0)) return;
            for (int i = 0; i < SIDE * SIDE; ++i) {
                const double x = 2 * (i % SIDE + 0.5) / SIDE - 1, y = 2 * (i / SIDE + 0.5) / SIDE - 1;
                worst = fmax(worst, fabs((double)read[i] - (double)want[i]));
                plain = fmax(plain, fabs((double)visibility[inside_card(x, y)] - (double)want[i]));
            }
            SHOW(worst < 2e-3 && plain > 0.3, "%s: off by %.4f; of one value a pixel by %.4f", name, worst, plain);
        }
        GLuint framebuffer = target_of(GL_TEXTURE_2D, target);
        for (int a = 0; a <= ROWS(away); ++a) {            /* the last round is the steep card's, which is not away */
            const int last = a == ROWS(away);
            const painted p = { last ? steep : planes[1], 0, { 0.375f, -0.125f }, last ? 0 : away[a], 1, 0 };
            if (!paint(d, result[last], eye, &p) || !TRY(kit_texture_read(target, SIDE, SIDE, 1, out))) return;
            if (!last) got[a] = (double)out[SIDE / 2 * SIDE + SIDE / 2];
            if (last || !a) lies = fmax(lies, beside(out));
        }
        /* At full resolution a texel of another surface must have no weight at all. */
        SHOW(lies < 1e-3
                 && (d->gather.resolution ? got[1] < 0.21 && got[2] > 0.25 && got[2] < 0.4 && got[3] > 0.65
                     && got[3] < 0.9
                                    : got[1] > 0.999 && got[2] > 0.999 && got[3] > 0.999 && got[3] < 1.0001),
             "%s: %.4f beside it; %.3f %.3f %.3f %.3f before it", name, lies, got[0], got[1], got[2], got[3]);
        glDeleteFramebuffers(1, &framebuffer);
        glDeleteTextures(2, result);
        glDeleteBuffers(1, &block);
    }
    glDeleteTextures(1, &target);
}

static void refused(void)
{
    static const struct { ssgi_gl_desc desc; int reads; } rows[] = {
        { { .pass = SSGI_GL_PASS_SHADE }, 1 },
        { { .pass = SSGI_GL_PASS_LIGHTS }, 1 },
        { { .pass = SSGI_GL_PASS_SUM }, 1 },
        { { .pass = SSGI_GL_PASS_BLUR, .filter.quantity = SSGI_GL_QUANTITY_LIGHT }, 1 },
        { { .pass = SSGI_GL_PASS_BLUR }, 0 },
        { { .pass = SSGI_GL_PASS_SHADE, .light.shading = SSGI_GL_SHADING_BENT }, 0 },
        { { .pass = SSGI_GL_PASS_EMITTERS }, 0 },
        { { .pass = SSGI_GL_PASS_COMPOSE }, 0 },
        { { .pass = SSGI_GL_PASS_HSAO, .gather.samples = 99 }, 0 }
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; ++i) {
        char text[8] = "as was";
        const size_t n = ssgi_gl_read(text, sizeof text, &rows[i].desc);
        CHECK((n != 0) == rows[i].reads && (n || !strcmp(text, "as was")) && (!n || strlen(text) == 7),
              "%s, row %d: %zu characters, \"%s\"", ssgi_gl_pass_name(rows[i].desc.pass), (int)i, n, text);
    }
    CHECK(!ssgi_gl_read(NULL, 1, &rows[0].desc) && !ssgi_gl_read(NULL, 0, NULL), "nothing to write to, or to read");
}

void test_read(void)
{
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("functions that read a result give what the filter gives: visibility, light, coefficients", as_the_filter);
    RUN("on edges each surface reads its own, a pane what it lies on; far before all else nothing occludes it",
        edges_and_panes);
    RUN("passes that leave nothing to read are refused", refused);
    kit_gl_close();
}
