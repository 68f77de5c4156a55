/* test_twins.c - functions of the emitted GLSL against the same in C, drawn by the CPU; and what C writes for GLSL to
   read: extra cameras, those of shadow maps, the light of a frame; and what a weight or a limit that no formula gives
   does in GLSL, by cases worked out by hand. */
#include "own.h"
#include "frames.h"
#include "kit/kit_gl.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 1 << 16 };
#define NAMES(sentence, start) (strncmp(sentence, start, strlen(start)) == 0)

/* ---- >>cameras: extra ones and those of shadow maps -------------------------------------------------------------- */

/* The rotation that takes +z an angle from it, between two about z: quaternion of sin(angle/2) at one azimuth,
   cos(angle/2) at another. */
static void rotation(float m[16], double angle, double a, double b)
{
    const double x = sin(angle / 2) * cos(a), y = sin(angle / 2) * sin(a), z = cos(angle / 2) * sin(b),
                 w = cos(angle / 2) * cos(b);
    const double turn[16] = { 1 - 2 * (y * y + z * z),
                              2 * (x * y + z * w),
                              2 * (z * x - y * w),
                              0,
                              2 * (x * y - z * w),
                              1 - 2 * (z * z + x * x),
                              2 * (y * z + x * w),
                              0,
                              2 * (z * x + y * w),
                              2 * (y * z - x * w),
                              1 - 2 * (x * x + y * y),
                              0,
                              0,
                              0,
                              0,
                              1 };
    for (int i = 0; i < 16; ++i) m[i] = (float)turn[i];
}

/* Any rigid matrix. */
static void rigid(float m[16])
{
    rotation(m, (double)t_uniform(0, 3.14f), (double)t_uniform(0, 6.28f), (double)t_uniform(0, 6.28f));
    for (int k = 0; k < 3; ++k) m[12 + k] = t_uniform(-9, 9);
}

/* Matrices that are not rigid: scaled, sheared, singular, of another last row, not finite. */
enum { NOT_RIGID = 7 };

static void not_rigid(float m[16], int i)
{
    rigid(m);
    for (int k = 0; k < 12 && i == 0; ++k) m[k] *= 100;
    for (int k = 0; k < 12 && i == 1; ++k) m[k] *= 1.001f;
    if (i == 2) for (int k = 0; k < 3; ++k) m[4 + k] += 0.5f * m[k];
    if (i == 3) for (int k = 0; k < 3; ++k) m[k] = m[4 + k];
    if (i == 4) m[15] = 2;
    if (i == 5) m[3] = 1e-3f;
    if (i == 6) m[14] = INFINITY;
}

/* Row r of a matrix times a point; lost: what may be lost of it, as rigid matrices of floats are not quite. */
static double product_of(const float m[16], int r, const double p[4], double *lost)
{
    double sum = 0;
    *lost = 0;
    for (int c = 0; c < 4; ++c) {
        sum += (double)m[4 * c + r] * p[c];
        *lost += 4e-6 * fabs((double)m[4 * c + r] * p[c]);
    }
    return sum;
}

/* An off-centre camera of 640 x 480; its projection may be anything that a view decodes. */
static int any_view(ssgi_view *view, int ortho)
{
    const float x = t_uniform(-0.3f, 0.3f), y = t_uniform(-0.3f, 0.3f), wide = t_uniform(0.5f, 3),
                high = t_uniform(-3, -0.5f);
    const float m[2][16] = { { wide, 0, 0, 0, 0, high, 0, 0, x, y, -1.002f, -1, 0, 0, -0.2f, 0 },
                             { wide, 0, 0, 0, 0, high, 0, 0, 0, 0, -0.02f, 0, x, y, -1, 1 } };
    const char *why = "";
    return CHECK(ssgi_view_from_projection(view, m[ortho], SSGI_CLIP_GL, 640, 480, &why) == SSGI_OK, "%s", why);
}

static void cameras(void)
{
    enum { TRIES = 4000 };
    double worst[2] = { 0, 0 };
    t_seed(5);
    for (int i = 0; i < TRIES; ++i) {
        const int ortho = i & 1, slot = i / 2 % 4;
        float picture[16], other[16], seen[3];
        ssgi_view view;
        ssgi_gl_views v, was;
        ssgi_gl_light light, bare;
        const char *why = "";
        double p[4] = { (double)t_uniform(-5, 5), (double)t_uniform(-5, 5), -(double)t_uniform(0.2f, 30), 1 },
               q[4] = { 0, 0, 0, 1 }, lost, at[4];
        const float spot[3] = { (float)p[0], (float)p[1], (float)p[2] };
        if (!any_view(&view, ortho)) return;
        rigid(picture);
        rigid(other);
        for (int k = 2; k < 16 && i % 4 > 1; k += 4) {     /* both mirrored, as left-handed engines' are */
            picture[k] = -picture[k];
            other[k] = -other[k];
        }
        memset(&was, 0x5a, sizeof was);
        memset(&bare, 0x5a, sizeof bare);
        v = was;
        light = bare;
        if (!CHECK(ssgi_gl_views_set(&v, slot, &view, picture, other, &why) == SSGI_OK
                       && ssgi_gl_light_map(&light, &view, 7, 9, picture, other, &why) == SSGI_OK,
                   "%s", why))
            return;
        /* p is in the other camera's space: to the world, then to the picture's */
        for (int k = 0; k < 3; ++k) {
            double world = 0;
            for (int c = 0; c < 3; ++c) world += (double)other[4 * k + c] * (p[c] - (double)other[12 + c]);
            at[k] = world;
        }
        at[3] = 1;
        for (int k = 0; k < 3; ++k) q[k] = product_of(picture, k, at, &lost);
        ssgi_view_project(seen, &view, spot);
        for (int k = 0; k < 3; ++k) {
            const double want = (double)seen[k] * (ortho || k == 2 ? 1 : -p[2]),
                         got = product_of(v.to[slot], k, q, &lost);
            CHECK(fabs(got - want) <= lost + 4e-7 * fabs(want), "to, %s, row %d: %.9g, ssgi_view_project says %.9g",
                  ortho ? "orthographic" : "perspective", k, got, want);
            worst[0] = fmax(worst[0], fabs(got - want) / (lost + 4e-7 * fabs(want)));
            at[k] = want;
            for (int c = 0; c < 4; ++c)
                CHECK(light.map[k][c] == v.to[slot][4 * c + k], "a light's map and an extra camera differ in row %d",
                      k);
        }
        for (int k = 0; k < 3; ++k) {
            const double got = product_of(v.from[slot], k, at, &lost);
            CHECK(fabs(got - q[k]) <= lost + 4e-7 * fabs(q[k]), "from, %s, row %d: %.9g, the point is at %.9g",
                  ortho ? "orthographic" : "perspective", k, got, q[k]);
            worst[1] = fmax(worst[1], fabs(got - q[k]) / (lost + 4e-7 * fabs(q[k])));
        }
        const float decode[4] = { view.depth[0], view.depth[1], view.clear, (float)ortho },
                    tile[4] = { 7, 9, 640, 480 };
        CHECK(!memcmp(decode, v.decode[slot], sizeof decode) && !memcmp(decode, light.decode, sizeof decode)
              && !memcmp(tile, light.tile, sizeof tile) && v.size[slot][0] == 640 && v.size[slot][1] == 480,
              "decode, size or tile of %s", ortho ? "orthographic" : "perspective");
        CHECK(light.patch == ssgi_pixel_footprint(&view, 1) && !memcmp(&light, &bare, offsetof(ssgi_gl_light, patch)),
              "a light's patch, or what is not of its map");
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
    static float right[16], odd[NOT_RIGID][16], mirrored[16];
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
    for (int i = 0; i < NOT_RIGID; ++i) not_rigid(odd[i], i);
    for (int k = 0; k < 16; ++k) mirrored[k] = right[k] * (k % 4 == 2 ? -1 : 1) * (k < 12 ? 1.0003f : 1);
    const struct { const char *start[2]; const ssgi_view *view; int i; const float *picture, *other;
    } cases[] = { { { "i:", "x:" }, &view, -1, right, right },
                  { { "i:", NULL }, &view, 4, right, right },
                  { { "view:", "view:" }, NULL, 0, right, right },
                  { { "view:", "view:" }, &none, 0, right, right },
                  { { "main_world_to_view:", "main_world_to_view:" }, &view, 0, NULL, right },
                  { { "extra_world_to_view:", "light_world_to_view:" }, &view, 0, right, NULL },
#define ODD(i) { { "main_world_to_view:", "main_world_to_view:" }, &view, 0, odd[i], right }, \
               { { "extra_world_to_view:", "light_world_to_view:" }, &view, 0, right, odd[i] }
                  ODD(0), ODD(1), ODD(2), ODD(3), ODD(4), ODD(5), ODD(6) };
    CHECK(ssgi_gl_views_set(NULL, 0, &view, right, right, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "views:")
              && ssgi_gl_light_map(NULL, &view, 0, 0, right, right, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "light:"),
          "NULL: %s", why);
    for (size_t i = 0; i < sizeof cases / sizeof cases[0]; ++i) {
        CHECK(ssgi_gl_views_set(&v, cases[i].i, cases[i].view, cases[i].picture, cases[i].other, &why)
                      == SSGI_BAD_ARGUMENT
                  && NAMES(why, cases[i].start[0])
                  && ssgi_gl_views_set(&v, cases[i].i, cases[i].view, cases[i].picture, cases[i].other, NULL)
                         == SSGI_BAD_ARGUMENT,
              "views, case %zu: %s", i, why);
        for (int y = 0; y < 2 && cases[i].start[1]; ++y)
            CHECK(ssgi_gl_light_map(&light, cases[i].view, y ? 0 : cases[i].i, y ? cases[i].i : 0, cases[i].picture,
                                    cases[i].other, &why)
                          == SSGI_BAD_ARGUMENT
                      && NAMES(why, cases[i].start[1]),
                  "light, case %zu: %s", i, why);
    }
    CHECK(!memcmp(&v, &v_was, sizeof v) && !memcmp(&light, &light_was, sizeof light),
          "what was refused was written to");
    why = "";
    CHECK(ssgi_gl_views_set(&v, 0, &view, mirrored, right, &why) == SSGI_OK
              && ssgi_gl_light_map(&light, &view, 0, 0, right, mirrored, &why) == SSGI_OK,
          "z negated and rounded is refused: %s", why);
}

/* The largest gap between neighbouring phases of so many frames in a row, round the circle. */
static double largest_gap(uint32_t from, uint32_t frames)
{
    double most = 0;
    for (uint32_t i = 0; i < frames; ++i) {
        double next = 1;
        for (uint32_t k = 0; k < frames; ++k) {
            const double ahead = (double)ssgi_gl_phase(from + k) - (double)ssgi_gl_phase(from + i);
            if (k != i) next = fmin(next, ahead - floor(ahead));
        }
        most = fmax(most, next);
    }
    return most;
}

/* Four frames halve the circle and then its halves, and the next four go on by a quarter of 1 + the golden ratio's
   fraction g. In each quarter they are multiples of g then, whose largest gap is a power of g where a Fibonacci number
   of them stands there; frames that begin amid four have three more at their ends. */
static void phases_spread(void)
{
    enum { FRAMES = 1024, POWERS = 7 };
    static const uint32_t fibonacci[POWERS] = { 1, 2, 3, 5, 8, 13, 21 };
    const double golden = 0.5 * (sqrt(5) - 1), bits = 16777216;
    for (uint32_t k = 0; k < FRAMES; ++k) {
        const double phase = (double)ssgi_gl_phase(k), halved = (double)(k & 1) / 2 + (double)(k >> 1 & 1) / 4,
                     off = phase - halved - (double)(k >> 2) * (1 + golden) / 4;
        CHECK(phase >= 0 && phase < 1 && fabs(off - nearbyint(off)) < 17 / bits,
              "phase %.8f of frame %u is off by %.8f", phase, k, off - nearbyint(off));
        CHECK(((uint32_t)(phase * bits) & 15) == (k & 15), "frame %u: the last bits tell another pixel", k);
    }
    for (uint32_t k = 0; k < 32; ++k)
        for (int i = 0; i < POWERS; ++i) {
            const double want = pow(golden, i) / 4, gap = largest_gap(k, 4 * fibonacci[i] + (k & 3 ? 3 : 0));
            CHECK(k & 3 ? gap < want + 36 / bits : fabs(gap - want) < 36 / bits,
                  "of 4 times %u frames from %u on the largest gap is %.7f, not %.7f", fibonacci[i], k, gap, want);
        }
}

/* ---- >>twins: GLSL against C ------------------------------------------------------------------------------------- */

enum { SIDE = 64, MANY = SIDE * SIDE };
static float in[MANY][4], out[MANY][4];
static float *const ins = &in[0][0], *const outs = &out[0][0];    /* the same, flat */

static ssgi_gl_views probed;               /* extra cameras that probes see, */
static GLuint probed_layers;               /* and what these see */
static GLuint probed_width;                /* Pass thickness wrote it, at its unit. */

/* A text up to its main, and a main that makes o of inputs: in to out. X(k): texel k of the pixel's four of the input,
   a: its own; Y(k): the same of maps, which all textures of the text read too. */
static int probe_text(char *text, int dialect, const ssgi_gl_frame *frame, GLuint maps, const char *statements)
{
    static const GLenum buffers[8] = { GL_NONE, GL_NONE, GL_NONE, GL_NONE,
                                       GL_NONE, GL_NONE, GL_NONE, GL_COLOR_ATTACHMENT7 };
    static const GLenum stages[2] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER };
    static char triangle[TEXT];
    const ssgi_gl_desc plain = { .text.dialect = dialect };
    const char *const source[2] = { triangle, text };
    kit_error err = { "" };
    char *end = strstr(text, "void main");
    GLuint program, block[2], framebuffer, target = kit_texture(SIDE, SIDE, GL_RGBA32F, NULL),
                                           input = kit_texture(SIDE, SIDE, GL_RGBA32F, in[0]);
    int read;
    if (!end) end = text + strlen(text);
    snprintf(end, TEXT - (size_t)(end - text),
             "layout(location = 7) out highp vec4 o;\nuniform highp sampler2D t_in, t_maps;\n"
             "#define AT(t, k) texelFetch(t, ivec2((texel.x & ~3) + (k), texel.y), 0)\n#define X(k) AT(t_in, "
             "k)\n#define Y(k) AT(t_maps, k)\n"
             "void main()\n{\n    ivec2 texel = ivec2(gl_FragCoord.xy);\n    vec4 a = X(texel.x & 3);\n    %s\n}\n",
             statements);
    ssgi_gl_emit(triangle, TEXT, &plain, SSGI_GL_STAGE_VERTEX);
    program = kit_program(source, stages, 2, &err);
    if (!CHECK(program, "%s: %s", statements, err.text)) return 0;
    glGenBuffers(2, block);
    for (GLuint b = 0; b < 2; ++b) {
        glBindBuffer(GL_UNIFORM_BUFFER, block[b]);
        glBufferData(GL_UNIFORM_BUFFER, b ? (GLsizeiptr)sizeof probed : (GLsizeiptr)sizeof *frame,
                     b ? (const void *)&probed : frame, GL_STATIC_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, b, block[b]);
    }
    for (GLenum unit = 0; unit < 16; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, unit == 15 ? input : unit == 2 && probed_width ? probed_width : maps);
        glBindTexture(GL_TEXTURE_2D_ARRAY, probed_layers);
    }
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT7, GL_TEXTURE_2D, target, 0);
    glDrawBuffers(8, buffers);
    glViewport(0, 0, SIDE, SIDE);
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "t_in"), 15);
    glUniform1i(glGetUniformLocation(program, "t_maps"), 14);
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
    const size_t n = ssgi_gl_emit(text, TEXT, d, SSGI_GL_STAGE_FRAGMENT);
    return CHECK(n && n < TEXT, "%s: a text of %zu characters", ssgi_gl_pass_name(d->pass), n)
           && probe_text(text, d->text.dialect, frame, maps, statements);
}

#define NEAR(got, want, within, what) \
    CHECK(fabs((double)(got) - (double)(want)) <= (double)(within), "%s at %d: %.9g, in C %.9g", what, i, \
          (double)(got), (double)(want))

static void twin_views(void)
{
    enum { LAYOUTS = 6 };
    /* perspective: GL, reversed, reversed infinite, GL infinite, of a tiny scene; orthographic: GL, reversed */
    for (int k = 0; k < LAYOUTS; ++k) {
        const double n = k == 3 ? 1e-9 : 0.1, f = 1000; /* planes */
        const double z[LAYOUTS][2] = {
            { -(f + n) / (f - n), -2 * f * n / (f - n) }, { n / (f - n), f * n / (f - n) }, { 0, n }, { -1, -2 * n },
            { -2 / (f - n), -(f + n) / (f - n) },         { 1 / (f - n), f / (f - n) }
        };
        float m[16] = { 1.3f,           0, 0, 0, 0, k & 1 ? -2.1f : 2.1f, 0, 0, 0.07f, -0.03f, (float)z[k][0], -1, 0, 0,
                        (float)z[k][1], 0 };
        int ortho = k >= 4, clip = k == 1 || k == 2 || k == 5 ? SSGI_CLIP_ZERO : SSGI_CLIP_GL;
        ssgi_gl_desc d = { .text.dialect = SSGI_GL_DIALECT_450, .input.orthographic = ortho }, mapped = d;
        ssgi_gl_frame frame;
        ssgi_view view;
        const char *why = "";
        mapped.pass = SSGI_GL_PASS_LIGHTS;
        mapped.light.shadow = SSGI_GL_SHADOW_MAP;
        if (ortho) { m[8] = m[9] = m[11] = 0; m[12] = 0.07f; m[13] = -0.03f; m[15] = 1; }
        if (!CHECK(ssgi_view_from_projection(&view, m, clip, 1280, 720, &why) == SSGI_OK
                       && ssgi_gl_frame_init(&frame, &view, 1, &why) == SSGI_OK,
                   "%s", why))
            continue;
        frame.offset = 1;
        for (int i = 0; i < MANY; ++i) {                  /* window depth; a pixel; view depth */
            static const float special[] = { 0, 1, NAN, INFINITY, -INFINITY, 1e38f, -1e38f };
            enum { SPECIAL = (int)(sizeof special / sizeof *special) };
            float a[4] = { i < SPECIAL ? special[i]
                           : i & 1 ? t_uniform(0, 1)
                                   : 1 - powf(10, t_uniform(-7, 0)),
                           t_uniform(-50, 1330), t_uniform(-50, 770), expf(t_uniform(-4, 7)) };
            memcpy(in[i], a, sizeof a);
        }
        if (!probe(&d, &frame, 0, "o = vec4(ssgi_window_depth(a.x), ssgi_position(a.yz, a.w));")) break;
        for (int i = 0; i < MANY; ++i) {
            double depth = (double)ssgi_view_depth(&view, in[i][0]),
                   x = fabs((double)in[i][1] * (double)view.unproject[0]) + fabs((double)view.unproject[2]);
            double y = fabs((double)in[i][2] * (double)view.unproject[1]) + fabs((double)view.unproject[3]),
                   scale = ortho ? 1 : (double)in[i][3];
            /* a rounding of the sum's terms */
            double lost = 1.2e-7 * (fabs((double)view.depth[0]) + fabs((double)view.depth[1]));
            float p[3];
            ssgi_view_position(p, &view, in[i][1], in[i][2], in[i][3]);
            if (depth >= 1e17)
                CHECK(out[i][0] >= 1e17f, "ssgi_window_depth(%.9g), layout %d: %g, in C %g", (double)in[i][0], k,
                      (double)out[i][0], depth);
            else
                NEAR(out[i][0], depth, ortho ? lost : depth * (3e-7 + depth * lost) * (1 + depth * lost),
                     "ssgi_window_depth");
            NEAR(out[i][1], p[0], 3e-7 * x * scale, "ssgi_position.x");
            NEAR(out[i][2], p[1], 3e-7 * y * scale, "ssgi_position.y");
            NEAR(out[i][3], p[2], 0, "ssgi_position.z");
        }
        if (!probe(&mapped, &frame, 0, ortho ? "o = vec4(ssgi_view_depth(vec4(u_ssgi_decode.xyz, 1.0), a.x));"
                                             : "o = vec4(ssgi_view_depth(vec4(u_ssgi_decode.xyz, 0.0), a.x));"))
            break;
        for (int i = 0; i < MANY; ++i) {
            const float depth = ssgi_view_depth(&view, in[i][0]);
            if (depth >= 1e17f) CHECK(out[i][0] >= 1e17f && out[i][0] <= SSGI_FAR, "ssgi_view_depth(%g): %g",
                                      (double)in[i][0], (double)out[i][0]);
        }
        for (int i = 0; i < MANY; ++i) ssgi_view_position(in[i], &view, in[i][1], in[i][2], in[i][3]);
        if (!probe(&d, &frame, 0,
                   "o = vec4(ssgi_project(a.xyz), ssgi_footprint(a.w), ssgi_lift(vec3(0.0, 0.0, -a.w), vec3(1.0, 0.0, "
                   "0.0)).x);"))
            break;
        for (int i = 0; i < MANY; ++i) {
            float p[3];
            ssgi_view_project(p, &view, in[i]);
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
    for (int i = 0; i < MANY; ++i) {
        in[i][0] = (float)(i % SIDE * 37);
        in[i][1] = (float)(i / SIDE * 21);
        in[i][2] = (float)(i % SIDE);
        in[i][3] = (float)(i / SIDE);
    }
    ssgi_gl_desc d = { .text.dialect = SSGI_GL_DIALECT_450, .gather.samples = 64 };
    ssgi_kernel(kernel, 1, 64, NULL);
    if (probe(&d, &frame, 0, "o = vec4(ssgi_noise(ivec2(a.xy)), ssgi_noise(ivec2(a.zw)));"))
        for (int i = 0; i < MANY; ++i)
            for (int k = 0; k < 2; ++k) {                 /* two products and their sum, rounded; in x 53 times that */
                double x = (double)in[i][2 * k], y = (double)in[i][2 * k + 1], e = 0.06711056 * x + 0.00583715 * y;
                e = (double)out[i][2 * k] - 52.9829189 * (e - floor(e));
                double f = (double)out[i][2 * k + 1] - (0.75487766624669276 * x + 0.56984029099805327 * y);
                CHECK(fabs(e - floor(e + 0.5)) <= 53 * 1.2e-7 * (0.0671 * x + 0.0059 * y + 1),
                      "ssgi_noise(%g, %g).x: off by %g", x, y, e);
                CHECK(fabs(f - floor(f + 0.5)) <= 2.4e-7 * (x + y + 1), "ssgi_noise(%g, %g).y: not R2, off by %g", x, y,
                      f);
                CHECK(out[i][2 * k] >= 0 && out[i][2 * k] < 1 && out[i][2 * k + 1] >= 0 && out[i][2 * k + 1] < 1,
                      "ssgi_noise(%g, %g) leaves [0,1)", x, y);
            }
    if (probe(&d, &frame, 0, "o = SSGI_KERNEL_TABLE[(texel.y * 64 + texel.x) % 64];"))
        for (int i = 0; i < MANY; ++i)
            for (int c = 0; c < 4; ++c) NEAR(out[i][c], kernel[4 * (i % 64) + c], 1.2e-7, "SSGI_KERNEL_TABLE");
    d.gather.uniform = 1;
    ssgi_directions(kernel, SSGI_DIRECTIONS_UNIFORM, 1, 64, NULL);
    if (probe(&d, &frame, 0, "o = SSGI_KERNEL_TABLE[(texel.y * 64 + texel.x) % 64];"))
        for (int i = 0; i < MANY; ++i)
            for (int c = 0; c < 4; ++c) NEAR(out[i][c], kernel[4 * (i % 64) + c], 1.2e-7, "SSGI_KERNEL_TABLE, uniform");
}

static void twin_normals(void)
{
    static float coded[MANY][4];
    const float c = 0.6f, s = 0.8f;
    ssgi_gl_frame frame;
    for (int world = 0; world < 2; ++world)
        for (int how = SSGI_GL_NORMAL_SIGNED; how <= SSGI_GL_NORMAL_OCTAHEDRAL; ++how) {
            ssgi_gl_desc d = { .text.dialect = SSGI_GL_DIALECT_450, .input.normal = how, .input.world_normals = world };
            const float turn[12] = { c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0 };      /* columns: x goes to (c, s, 0) */
            memset(&frame, 0, sizeof frame);
            memcpy(frame.rotation, turn, sizeof turn);
            for (int i = 0; i < MANY; ++i) {
                float z = t_uniform(-1, 1), a = t_uniform(0, 6.2831853f), r = sqrtf(1 - z * z), *n = in[i],
                      *e = coded[i];
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
                    const float *n = in[i], want[3] = { world ? c * n[0] - s * n[1] : n[0],
                                                        world ? s * n[0] + c * n[1] : n[1], n[2] };
                    for (int k = 0; k < 3; ++k) NEAR(out[i][k], want[k], 6e-7, "ssgi_normal");
                }
            glDeleteTextures(1, &map);
        }
}

/* The integral that the comment of ssgi_arc_slope names, by Simpson's rule. */
static double arc(double top, double g)
{
    enum { PARTS = 128 };
    double sum = 0;
    for (int k = 0; k <= PARTS; ++k)
        sum += sin(top * k / PARTS) * cos(g - top * k / PARTS) * (k == 0 || k == PARTS ? 1 : k & 1 ? 4 : 2);
    return sum * top / (3 * PARTS);
}

static void twin_arc(void)
{
    ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HSAO, .text.dialect = SSGI_GL_DIALECT_450 };
    ssgi_gl_frame frame;
    double worst = 0;
    memset(&frame, 0, sizeof frame);
    /* height over the tangent plane and distance along it: down to the plane, up to the normal */
    for (int i = 0; i < MANY; ++i) {
        float thin = powf(10, t_uniform(-12, 0)),
              a[4] = { i & 1 ? 1 : thin, i & 1 ? thin : 1, t_uniform(-1.57f, 1.57f), t_uniform(0.1f, 10) };
        if (i % 16 == 0) a[i / 16 & 1] = 0;
        memcpy(in[i], a, sizeof a);
    }
    if (probe(&d, &frame, 0,
              "a.xy *= a.w; float r = inversesqrt(a.x * a.x + a.y * a.y) * (1.0 + 2.4e-7 * float(texel.x & 2)), h = "
              "0.5 * sin(a.z);"
              "vec2 c = vec2(a.x, -a.x) * r;"
              "float g = 0.5 * cos(a.z);"
              "vec2 q = c * c, way = vec2(h, -h);"
              "o = vec4(g - g * q + way * vec2(ssgi_arc_odd(c.x, q.x), ssgi_arc_odd(c.y, q.y)), 0.0, 0.0);"))
        for (int i = 0; i < MANY; ++i) {
            double x = (double)in[i][0], y = (double)in[i][1], g = (double)in[i][2];
            double within = 0.5 * fabs(sin(g)) * 0.0015 + 2e-6;           /* its polynomial, and */
            /* two roundings, or what GLSL grants an inversesqrt, so that |c| > 1 */
            NEAR(out[i][0], arc(atan2(y, x), g), within, "the arc");
            NEAR(out[i][1], arc(atan2(y, -x), -g), within, "the other side's");
            worst = fmax(worst, fmax(fabs((double)out[i][0] - arc(atan2(y, x), g)),
                                     fabs((double)out[i][1] - arc(atan2(y, -x), -g))));
        }
    t_note("worst error of a horizon's occlusion: %.1e", worst);
}

/* What emitters wrote, read back as its format says: 9 9 9 bits and an exponent of 5; 6 bits of exponent and 14; two of
   6. */
static void unpack(const float halves[4], float rgb[3], float *z)
{
    const uint32_t a = (uint32_t)halves[0] | (uint32_t)halves[1] << 16,
                   b = (uint32_t)halves[2] | (uint32_t)halves[3] << 16;
    for (int c = 0; c < 3; ++c) rgb[c] = ldexpf((float)(a >> 9 * c & 511), (int)(a >> 27) - 24);
    *z = ldexpf(1 + (float)(b >> 12 & 0x3fff) / 16384, (int)(b >> 26) - 20);
}

static void twin_emitters(void)
{
    static float rgbz[MANY][4], way[MANY][3];
    const ssgi_gl_desc pack = { .pass = SSGI_GL_PASS_EMITTERS, .text.dialect = SSGI_GL_DIALECT_450 },
                       read = { .pass = SSGI_GL_PASS_SSDO,
                                .gather.search = SSGI_GL_SEARCH_POINTS,
                                .text.dialect = SSGI_GL_DIALECT_450,
                                .light.bounce = SSGI_GL_BOUNCE_PATCH };
    ssgi_gl_frame frame;
    double worst = 0;
    memset(&frame, 0, sizeof frame);
    t_seed(9);
    for (int i = 0; i < MANY; ++i) {
        const float bright = powf(10, t_uniform(-7, 5.2f)), a = t_uniform(0, 6.2831853f), h = t_uniform(-1, 1);
        for (int c = 0; c < 3; ++c) {
            rgbz[i][c] = i % 8 == c ? 0 : bright * t_uniform(0, 1);
            way[i][c] = c == 2 ? h : sqrtf(1 - h * h) * (c ? sinf(a) : cosf(a));
        }
        for (int c = 0; c < 3 && i < 6; ++c) way[i][c] = i / 2 == c ? i & 1 ? -1.0f : 1.0f : 0.0f;
        /* where rounding needs the next exponent */
        if (i % 64 == 9) rgbz[i][i / 64 % 3] = ldexpf(511.0f + (float)(i / 192) / 21, i / 64 % 24 - 10);
        rgbz[i][3] = powf(10, t_uniform(-6, 13));
    }
    memcpy(in, rgbz, sizeof in);
    if (!probe(&pack, &frame, 0,
               "uvec2 u = uvec2(ssgi_pack_radiance(a.xyz), ssgi_pack_place(a.w, vec3(0.0, 0.0, 1.0)));"
               "o = vec4(u.x & 65535u, u.x >> 16u, u.y & 65535u, u.y >> 16u);"))
        return;
    memcpy(in, out, sizeof in);
    if (!probe(&read, &frame, 0,
               "uvec2 u = uvec2(a.xz) | uvec2(a.yw) << 16u; o = vec4(ssgi_unpack_radiance(u.x), "
               "ssgi_unpack_depth(u.y));"))
        return;
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
    if (!probe(&pack, &frame, 0, "uint u = ssgi_pack_place(1.0, a.xyz); o = vec4(u & 65535u, u >> 16u, 0.0, 0.0);"))
        return;
    memcpy(in, out, sizeof in);
    if (!probe(&read, &frame, 0,
               "o = vec4(ssgi_unpack_normal(uint(a.x) | uint(a.y) << 16u), ssgi_unpack_depth(0xffffffffu));"))
        return;
    for (int i = 0; i < MANY; ++i) {
        const double x = (double)out[i][0], y = (double)out[i][1], z = (double)out[i][2];
        const double cosine = (x * (double)way[i][0] + y * (double)way[i][1] + z * (double)way[i][2])
                              / sqrt(x * x + y * y + z * z),
                     degrees = acos(fmin(cosine, 1)) * 57.29577951;
        CHECK(degrees <= 4, "an emitter's normal is off by %.2f degrees", degrees);
        NEAR(out[i][3], SSGI_FAR, 0, "the view depth of nothing");
        worst = fmax(worst, degrees);
    }
    t_note("an emitter's normal is off by %.2f degrees at most", worst);
}

/* Octahedral maps, and the point that an extra camera shows: the third of them, so that the block's strides matter. */
static void twin_views_of_others(void)
{
    const ssgi_gl_desc d = { .text.dialect = SSGI_GL_DIALECT_450, .gather.fade = 1, .gather.views = 3 }, map = {
        .pass = SSGI_GL_PASS_SSDO, .text.dialect = SSGI_GL_DIALECT_450, .light.environment = SSGI_GL_ENVIRONMENT_MAP
    };
    ssgi_gl_frame frame;
    memset(&frame, 0, sizeof frame);
    t_seed(11);
    for (int ortho = 0; ortho < 2; ++ortho) {
        float picture[16], other[16];
        ssgi_view view;
        if (!any_view(&view, ortho)) return;
        rigid(picture);
        rigid(other);
        memset(&probed, 0x5a, sizeof probed);
        ssgi_gl_views_set(&probed, 2, &view, picture, other, NULL);
        for (int i = 0; i < MANY; ++i) {
            in[i][0] = floorf(t_uniform(0, 640));
            in[i][1] = floorf(t_uniform(0, 480));
            in[i][2] = t_uniform(0.5f, 30);
            in[i][3] = 0;
        }
        if (!probe(&d, &frame, 0, "o = vec4(ssgi_point(2, ivec2(a.xy), a.z), u_ssgi_view_decode[2].x);")) return;
        for (int i = 0; i < MANY; ++i) {
            const double scale = ortho ? 1 : (double)in[i][2],
                         p[4] = { ((double)in[i][0] + 0.5) * scale, ((double)in[i][1] + 0.5) * scale, (double)in[i][2],
                                  1 };
            for (int k = 0; k < 3; ++k) {
                double lost, want = product_of(probed.from[2], k, p, &lost);
                NEAR(out[i][k], want, lost, "ssgi_point");
            }
            NEAR(out[i][3], view.depth[0], 0, "u_ssgi_view_decode");
        }
    }
    for (int i = 0; i < MANY; ++i)
        for (int c = 0; c < 3; ++c) in[i][c] = i < 6 ? (float)((i == 2 * c) - (i == 2 * c + 1)) : t_uniform(-9, 9);
    if (!probe(&map, &frame, 0, "o = vec4(ssgi_octahedral(a.xyz), 0.0, 0.0);")) return;
    for (int i = 0; i < MANY; ++i) {
        float e[2];
        ssgi_octahedral_encode(e, in[i]);
        for (int c = 0; c < 2; ++c) NEAR(out[i][c], e[c], 4e-7, "ssgi_octahedral");
    }
}

/* What ssgi_gl_sh writes, in both languages: a case is four pixels, one a word of the result. */
static void twin_harmonics(void)
{
    enum { BASIS, ZONAL, TURN, SUMS, FUNCTIONS };
    static const char *const heads[] = { "#version 330 core\n", "#version 300 es\nprecision highp float;\n" };
    static const char *const words[] = { "s.a", "s.a", "w == 0 ? s.a : w == 1 ? s.b : s.c",
                                         "w == 0 ? s.a : w == 1 ? s.b : w == 2 ? s.c : s.d" };
    static const char *const parts[] = { "", "", " s.b = b; s.c = c;", " s.b = b; s.c = c; s.d = d;" };
    static const char *const calls[] = { "s = ssgi_sh_basis(Y(2).xyz);", "s = ssgi_sh_zonal(X(0), Y(2).xyz);",
                                         "ssgi_sh_turn(s, mat3(Y(0).xyz, Y(1).xyz, Y(2).xyz));",
                                         "float both = ssgi_sh_dot(s, y); ssgi_sh_add(s, y, 0.5); s.a.x = both;" };
    static const double tilts[8] = { 1e-2, 1e-3, 1e-4, 1e-5, 2e-6, 5e-7, 1e-7, 0 };   /* of the axis from either pole */
    static float others[4 * MANY];
    static char text[TEXT], body[600];
    const ssgi_gl_frame frame = { .radius = 1 };
    const double pi = 3.14159265358979;
    double worst[FUNCTIONS] = { 0 };
    t_seed(13);
    for (int k = 0; k < 2 * 4 * FUNCTIONS; ++k) {
        const int es = k & 1, bands = k / 2 % 4 + 1, what = k / 8;
        for (int i = 0; i < 4 * MANY; ++i) {
            ins[i] = i % 16 < bands * bands || what == ZONAL ? t_uniform(-1, 1) : 0;
            others[i] = ins[i] * t_uniform(-1, 1);
        }
        /* rotations: none, half turns, the axis at a pole and near it, any */
        for (int i = 0; i < MANY / 4 && what < SUMS; ++i) {
            const double tilt = tilts[i / 2 % 8], a = (double)t_uniform(0, 6.28f), b = (double)t_uniform(0, 6.28f);
            if (i < 4) rotation(&others[16 * i], i < 2 ? pi : 0, i & 1 ? pi / 2 : 0, i & 1 ? pi / 2 : 0);
            else rotation(&others[16 * i], i & 16 ? (double)t_uniform(0, 3.14159f) : i & 1 ? tilt : pi - tilt, a, b);
            /* as a product of matrices is rounded */
            for (int j = 0; j < 11 && i & 32; ++j) others[16 * i + j] += t_uniform(-1.2e-7f, 1.2e-7f);
        }
        GLuint map = kit_texture(SIDE, SIDE, GL_RGBA32F, others);
        size_t n = (size_t)snprintf(text, sizeof text, "%s", heads[es]);
        n += ssgi_gl_sh(text + n, sizeof text - n, bands);
        snprintf(text + n, sizeof text - n,
                 "ssgi_sh given(vec4 a, vec4 b, vec4 c, vec4 d) { ssgi_sh s; s.a = a;%s return s; }\n",
                 parts[bands - 1]);
        snprintf(body, sizeof body,
                 "int w = texel.x & 3; ssgi_sh s = given(X(0), X(1), X(2), X(3)), y = given(Y(0), Y(1), Y(2), Y(3)); "
                 "%s o = %s;",
                 calls[what], words[bands - 1]);
        if (!probe_text(text, es ? SSGI_GL_DIALECT_300ES : SSGI_GL_DIALECT_330, &frame, map, body)) return;
        for (int i = 0; i < MANY / 4; ++i) {
            const float *x = &ins[16 * i], *y = &others[16 * i], *got = &outs[16 * i];
            float want[16] = { 0 };
            double both = 0;
            if (what == BASIS) ssgi_sh_basis(want, bands, y + 8);
            if (what == ZONAL) ssgi_sh_zonal(want, bands, x, y + 8);
            if (what == TURN) ssgi_sh_rotate(want, bands, x, 1, y);
            for (int j = 0; j < 16 && what == SUMS; ++j) {
                want[j] = x[j] + 0.5f * y[j];
                both += (double)x[j] * (double)y[j];
            }
            if (what == SUMS) want[0] = (float)both;
            for (int j = 0; j < (bands < 3 ? 4 : 4 * bands); ++j) {
                NEAR(got[j], want[j], 1e-5, calls[what]);
                worst[what] = fmax(worst[what], fabs((double)got[j] - (double)want[j]));
            }
        }
        glDeleteTextures(1, &map);
    }
    t_note("worst of basis %.1e, zonal %.1e, turn %.1e, sums %.1e", worst[BASIS], worst[ZONAL], worst[TURN],
           worst[SUMS]);
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

/* Every half is read as it is, and floats are rounded to it, in languages that have halves and by our own code in those
   that have not. */
static void twin_halves(void)
{
    static const int dialects[] = { SSGI_GL_DIALECT_330, SSGI_GL_DIALECT_410, SSGI_GL_DIALECT_450,
                                    SSGI_GL_DIALECT_300ES };
    static const float odd[] = {
        0,     -0.0f,         65504,         65519,         65520,         65536,         1e9f,
        1e30f, 5.9604645e-8f, 2.9802322e-8f, 2.9802326e-8f, 6.0975552e-5f, 6.1035156e-5f, 6.1005358e-5f,
        1,     1e-40f
    };
    const ssgi_gl_frame frame = { .radius = 1 };
    for (int k = 0; k < 4; ++k) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_BLUR,
                                 .filter.quantity = SSGI_GL_QUANTITY_COEFFICIENTS,
                                 .light.packed = 1,
                                 .text.dialect = dialects[k] };
        for (int round = 0; round < 4; ++round) {
            for (int i = 0; i < 4 * MANY; ++i) ins[i] = (float)(4 * MANY * round + i);
            if (!probe(&d, &frame, 0,
                       "uvec4 h = uvec4(a); uvec2 u = h.xz | h.yw << 16u; o = vec4(ssgi_unpack_half(u.x), "
                       "ssgi_unpack_half(u.y));"))
                return;
            for (int i = 0; i < 4 * MANY; ++i)
                if (((4 * MANY * round + i) & 0x7c00) != 0x7c00)
                    NEAR(outs[i], value_of(4 * MANY * round + i), 0, "ssgi_unpack_half");
        }
        t_seed(14);
        /* halves, what lies between two and beside that, anything, the odd ones */
        for (int i = 0; i < 4 * MANY; ++i) {
            const int h = (int)t_uniform(0, 0x7bff);
            const float middle = (float)(0.5 * (value_of(h) + value_of(h + 1)));
            const float x[4] = { (float)value_of(h), middle, nextafterf(middle, i & 4 ? 0.0f : 1e9f),
                                 powf(10, t_uniform(-9, 10)) };
            ins[i] = (i < 64 ? odd[i % 16] : x[i & 3]) * (i & 16 ? -1.0f : 1.0f);
        }
        if (!probe(&d, &frame, 0,
                   "uvec2 u = uvec2(ssgi_pack_half(a.xy), ssgi_pack_half(a.zw)); o = vec4(u.x & 65535u, u.x >> 16u, "
                   "u.y & 65535u, u.y >> 16u);"))
            return;
        for (int i = 0; i < 4 * MANY; ++i) {
            const float x = ins[i];
            const int got = (int)outs[i];
            CHECK(got == half_of(x), "ssgi_pack_half(%.9g), %s: 0x%04x, to nearest even 0x%04x", (double)x,
                  ssgi_gl_dialect_name(d.text.dialect), (unsigned)got, (unsigned)half_of(x));
        }
    }
}

/* ---- >>figures: weights and limits that no formula gives, by cases worked out by hand ---------------------------- */

/* orthographic, 64 x 64 pixels, 16 a unit */
static int facing(ssgi_view *view, ssgi_gl_frame *frame, float radius)
{
    static const float m[16] = { 0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, -0.02f, 0, 0, 0, -1, 1 };
    const char *why = "";
    return CHECK(ssgi_view_from_projection(view, m, SSGI_CLIP_GL, SIDE, SIDE, &why) == SSGI_OK
                     && ssgi_gl_frame_init(frame, view, radius, &why) == SSGI_OK,
                 "%s", why);
}

/* ---- functions of numbers: a row each, GLSL beside what its comment says ----------------------------------------- */

/* From a, in [low,high], the statement makes o; want makes it of the same numbers. */
typedef struct term {
    const char *name;
    ssgi_gl_desc desc;
    const char *statement;
    float low, high;
    void (*want)(double *o, const double *a);
    double within;
} term;

static void want_ambient(double *o, const double *a)
{
    for (int k = 0; k < 3; ++k) o[k] = fmin(fmax(a[0] * 1.1283791671, 0), 1);
}

static void want_second_layer(double *o, const double *a)
{
    (void)a;
    for (int k = 0; k < 3; ++k) o[k] = 2;
}

static void want_way(double *o, const double *a) { for (int k = 0; k < 3; ++k) o[k] = a[3] - a[k]; }

/* of the radius, which is 1; and at most twice a segment's length */
static void want_width(double *o, const double *a)
{
    for (int k = 0; k < 3; ++k) o[k] = a[k] / 63;
}

static void want_short_width(double *o, const double *a)
{
    for (int k = 0; k < 3; ++k) o[k] = fmin(a[k] / 63, 2 * a[3] / 63);
}

#define LAYERS_OF(pass_, ...) { .pass = SSGI_GL_PASS_##pass_, .gather.layers = 4, .text.dialect = SSGI_GL_DIALECT_450, \
                                __VA_ARGS__ }
#define POINTS_OF(pass_) { .pass = SSGI_GL_PASS_##pass_, .gather.thickness = SSGI_GL_THICKNESS_WIDTH, \
                           .text.dialect = SSGI_GL_DIALECT_450 }
static const term terms[] = {
    { "ambient visibility of coefficients",
      { .pass = SSGI_GL_PASS_SHADE, .light.residual = 1, .text.dialect = SSGI_GL_DIALECT_450 },
      "ssgi_coefficients v; for (int c = 0; c < v.c.length(); ++c) v.c[c].a = vec4(a.x, 0.0, 0.0, 0.0);"
      " o = vec4(ssgi_ambient(v), 0.0);",
      -0.5f, 1.5f, want_ambient, 1e-6 },
    { "the normal of the layer that receives", LAYERS_OF(LIGHTS, .light.receiver = 2),
      "o = ssgi_normal_texel(texel);", 0, 1, want_second_layer, 0 },
    { "the albedo of the layer that receives", LAYERS_OF(EMITTERS, .light.receiver = 2),
      "o = vec4(ssgi_albedo(texel), 0.0);", 0, 1, want_second_layer, 0 },
    { "the way to a sample, by which emitters are chosen",
      LAYERS_OF(SSDO, .gather.search = SSGI_GL_SEARCH_POINTS, .light.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE),
      "ssgi_P = a.xyz; float found = ssgi_occlusion_at(vec3(a.w));"
      " o = vec4(ssgi_way, found);",
      -2, 2, want_way, 1e-6 },
    { "the width that a texel holds", POINTS_OF(SSAO),
      "o = vec4(ssgi_measured_width(a.x), ssgi_measured_width(a.y), ssgi_measured_width(a.z), 0.0);", 0, 63, want_width,
      1e-6 },
    { "the width that a segment to a light takes", POINTS_OF(LIGHTS),
      "ssgi_segment_length = a.w / 63.0; o = vec4(ssgi_measured_width(a.x), ssgi_measured_width(a.y), "
      "ssgi_measured_width(a.z), 0.0);",
      0, 63, want_short_width, 1e-6 },
};

static void twin_reflections(void)
{
    static const char *const statements[2] = {
        "o = vec4(ssgi_interreflected(a.x, a.yzw), 0.0);",
        "o = vec4(ssgi_specular_visibility(a.x, 2.0 * a.y - 1.0, 2.0 * a.z - 1.0, a.w));"
    };
    static char text[TEXT];
    ssgi_gl_frame frame;
    memset(&frame, 0, sizeof frame);
    for (int k = 0; k < 2; ++k) {
        const size_t head = (size_t)snprintf(text, sizeof text, "#version 330 core\n");
        if (!CHECK(ssgi_gl_reflection(text + head, sizeof text - head), "no text")) return;
        for (int i = 0; i < 4 * MANY; ++i) ins[i] = t_uniform(0, 1);
        if (!probe_text(text, SSGI_GL_DIALECT_330, &frame, 0, statements[k])) return;
        for (int i = 0; i < MANY; ++i)
            for (int c = 0; c < 3; ++c)
                NEAR(out[i][c], k ? ssgi_specular_visibility(in[i][0], 2 * in[i][1] - 1, 2 * in[i][2] - 1, in[i][3])
                                  : ssgi_interreflected(in[i][0], in[i][1 + c]), 1e-6, statements[k]);
    }
    CHECK(!ssgi_gl_reflection(NULL, 1), "written to nothing");
}

static void functions_of_numbers(void)
{
    static float layer[16 * MANY];
    ssgi_gl_frame frame;
    ssgi_view view;
    if (!facing(&view, &frame, 1)) return;
    for (int i = 0; i < 16 * MANY; ++i) layer[i] = (float)(i / (4 * MANY) + 1);
    probed_layers = kit_texture_array(SIDE, SIDE, 4, GL_RGBA32F, layer);
    for (size_t k = 0; k < sizeof terms / sizeof *terms; ++k) {
        for (int i = 0; i < 4 * MANY; ++i) ins[i] = t_uniform(terms[k].low, terms[k].high);
        if (!probe(&terms[k].desc, &frame, 0, terms[k].statement)) break;
        for (int i = 0; i < MANY; ++i) {
            const double a[4] = { (double)in[i][0], (double)in[i][1], (double)in[i][2], (double)in[i][3] };
            double o[3];
            terms[k].want(o, a);
            for (int c = 0; c < 3; ++c) NEAR(out[i][c], o[c], terms[k].within, terms[k].name);
        }
    }
    glDeleteTextures(1, &probed_layers);
    probed_layers = 0;
}

/* Four arcs, from near to far, first come first counted: a bit at a time in C; and on the mean over all roundings the
   exact union of the intervals. A span ends the arcs' shares at 2.5, from half of it on. */
static void twin_sectors(void)
{
    static const struct {
        int dialect, span;
    } row[] = { { SSGI_GL_DIALECT_330, 0 }, { SSGI_GL_DIALECT_450, 0 }, { SSGI_GL_DIALECT_450, 1 } };
    static const double share[2][4] = { { 1, 0.75, 0.5, 0.25 }, { 1, 0.75, 0.4 * 0.5, 0 } };   /* by distance, near */
    static float noise[MANY];
    ssgi_gl_frame frame;
    memset(&frame, 0, sizeof frame);
    frame.radius = 4;
    for (size_t v = 0; v < sizeof row / sizeof *row; ++v) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HSAO,
                                 .text.dialect = row[v].dialect,
                                 .surfel.span = row[v].span };
        double sum = 0, exact = 0;
        char statements[400];
        t_seed(31);
        for (int i = 0; i < MANY; ++i) {
            const float a = t_uniform(0, 1), b = t_uniform(0, 1), whole[4] = { 0, 32, 0, 1 };
            if (i % 4 == 0) noise[i / 4] = t_uniform(0, 1);
            const float n = noise[i / 4], tap[4] = { fminf(a, b) * 32 + n, fmaxf(a, b) * 32 + n, (float)(i % 4), 0 };
            memcpy(in[i], i % 1000 == 3 ? whole : tap, sizeof tap);
        }
        snprintf(statements, sizeof statements,
                 "uint one = 0xffffffffu, two = one; vec2 sum = vec2(0.0); %s"
                 "for (int k = 0; k < 4; ++k) { vec4 x = X(k);"
                 "sum.x += ssgi_cover_sectors(one, ssgi_sectors(x.x, x.y), 0.25 * x.z);"
                 "sum.y += ssgi_cover_sectors(two, ssgi_sectors(0.0, x.x), 0.25 * x.z); }"
                 "o = vec4(sum, ssgi_count(~one), ssgi_count(~two));", row[v].span ? "ssgi_span = 2.5;" : "");
        if (!probe(&d, &frame, 0, statements)) return;
        for (int i = 0; i < MANY; ++i) {
            double want[4] = { 0 }, cut[8];
            int taken[2][32] = { { 0 } }, cuts = 0;
            const float (*tap)[4] = (const float (*)[4])in[i & ~3];
            for (int k = 0; k < 4; ++k)
                for (int side = 0; side < 2; ++side)
                    for (int s = side ? 0 : (int)tap[k][0]; s < (int)tap[k][!side]; ++s) {
                        if (taken[side][s]) continue;
                        taken[side][s] = 1;
                        want[side] += share[row[v].span][(int)tap[k][2]];
                        ++want[2 + side];
                    }
            for (int k = 0; k < 4; ++k) NEAR(out[i][k], want[k], 1e-5, "sectors");
            if (i % 4 || !(i / 4 % 250)) continue;       /* those that have a whole side among them are not rounded */
            for (int k = 0; k < 4; ++k)
                for (int e = 0; e < 2; ++e) cut[cuts++] = ((double)tap[k][e] - (double)noise[i / 4]) / 32;
            for (double u = 0.0005; u < 1; u += 0.001)
                for (int k = 0; k < 4; ++k) if (u > cut[2 * k] && u < cut[2 * k + 1]) { exact += 0.001; break; }
            sum += (double)out[i][2] / 32;
        }
        CHECK(fabs(sum - exact) < 0.002 * MANY / 4, "%s: a mean of %.4f of the sectors, of the intervals %.4f",
              ssgi_gl_dialect_name(d.text.dialect), 4 * sum / MANY, 4 * exact / MANY);
        if (!d.surfel.span)
            t_note("%s: a mean of %.4f of the sectors, of the intervals %.4f", ssgi_gl_dialect_name(d.text.dialect),
                   4 * sum / MANY, 4 * exact / MANY);
    }
}

/* Depths of slabs, for points: as measured, at least a gap, at most the radius; of sheets, to a half's rounding, and of
   what has no back, the thickness. */
static void twin_deep(void)
{
    const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_SSAO,
                             .text.dialect = SSGI_GL_DIALECT_450,
                             .gather.thickness = SSGI_GL_THICKNESS_BACK };
    ssgi_gl_frame frame;
    memset(&frame, 0, sizeof frame);
    frame.radius = 0.5f;
    frame.thickness_limit = 0.3f;
    t_seed(37);
    for (int i = 0; i < MANY; ++i) {
        const float z = powf(10, t_uniform(-1, 3)),
                    backs[4] = { z * (1 + t_uniform(0, 0.00048f)), z + t_uniform(0.0006f * z, 0.0006f * z + 1),
                                 i & 4 ? 0 : 1e18f, z * t_uniform(0, 1) },
                    a[4] = { z, backs[i & 3], t_uniform(0, 0.2f), 0 };
        memcpy(in[i], a, sizeof a);
    }
    if (probe(&d, &frame, 0,
              "o = vec4(ssgi_slab_thickness(vec2(a.x, 1.0), vec2(a.y, 1.2), vec2(a.z, 0.0)), 0.0, 0.0);"))
        for (int i = 0; i < MANY; ++i) {
            const float z = in[i][0], back = in[i][1];
            NEAR(out[i][0], (i & 3) == 1 ? fmaxf(fminf(back - z, 0.5f), in[i][2]) : fmaxf(0.3f, in[i][2]),
                 2e-7f * z + 1e-6f, "ssgi_slab_thickness");
            NEAR(out[i][1], 0.2f, 1e-6f, "ssgi_slab_thickness, the second");
        }
}

/* A side's sectors with what its steps missed and what is beyond the picture, which goes on for so many radii. */
static double expected(double found, double open, int steps, double edge)
{
    const double beyond = fmax(1 - edge, 0), missed = fmax(0.09375 / steps - 0.0028, 0) * found;
    return found + open * fmin(missed + beyond * beyond * fmin(0.05 * found, 0.4), 1);
}

/* One tap in one slice, at an elevation over a plane that is tilted: what of it counts. The walk ends at the radius, or
   with the span where there is one. */
static void slices_limits(void)
{
    /* degrees; sine of the elevation; is it beyond the normal? */
    static const struct { double tilt, height; int beyond, counts, span;
    } row[] = { { 80, 0.39, 1, 0, 0 },   { 80, 0.41, 1, 1, 0 },   { 80, 0.2, 1, 0, 0 }, { 60, 0.9, 1, 1, 0 },
                { 80, 0.0039, 0, 0, 0 }, { 30, 0.0041, 0, 1, 0 }, { 60, 0.3, 0, 1, 0 }, { 20, 0.7, 0, 1, 0 },
                { 20, 0.7, 0, 1, 1 } };
    static float map[MANY][4];
    const int centre = SIDE / 2 * SIDE + SIDE / 2;
    ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HSAO,
                       .text.dialect = SSGI_GL_DIALECT_450,
                       .gather.directions = 1,
                       .gather.steps = 1,
                       .gather.falloff = SSGI_GL_FALLOFF_NONE,
                       .input.orthographic = 1,
                       .input.depth = SSGI_GL_DEPTH_LINEAR,
                       .gather.thickness = SSGI_GL_THICKNESS_SOLID };
    ssgi_gl_frame frame;
    ssgi_view view;
    if (!facing(&view, &frame, 3.512f)) return;
    frame.surfel[0] = 1.561f;
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const double tilt = row[k].tilt * 0.017453292519943,
                     up = row[k].beyond ? 3.14159265358979 - asin(row[k].height) : asin(row[k].height);
        /* of the tap from the view direction: 4 pixels aside, so much nearer */
        const double away = tilt + 1.5707963267949 - up;
        for (int i = 0; i < MANY; ++i) {
            const double from = hypot(i % SIDE - SIDE / 2, i / SIDE - SIDE / 2);
            map[i][0] = i == centre ? 10 : from > 2.5 && from < 6 ? (float)(10 - 0.25 * cos(away) / sin(away)) : 100;
        }
        in[centre][0] = (float)sin(tilt);
        in[centre][1] = (float)cos(tilt);
        /* its square of the radius or the span: 4.3 pixels. Sectors are rounded up but for 1e-5 */
        in[centre][2] = row[k].span ? 0.414937f : 0.276624f;
        d.surfel.span = row[k].span;
        GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
        const int went = probe(&d, &frame, texture,
                               "vec3 P = ssgi_position(vec2(texel) + 0.5, ssgi_depth(texel)); mat3 m = "
                               "ssgi_basis(vec3(0.0, 0.0, 1.0));"
                               "o = vec4(ssgi_gather(texel, P, m[0] * a.x + m[2] * a.y, vec2(0.0, a.z)).all);");
        glDeleteTextures(1, &texture);
        if (!went) return;
        const double whole = arc(1.5707963267949 + tilt, tilt),
                     found = row[k].counts ? ceil(32 * arc(up, tilt) / whole) : 0,
                     pixels = 4.3 / ((double)in[centre][2] * (double)in[centre][2]),
                     want = whole / 32 * expected(found, 32 - found, 1, (SIDE / 2 - 0.501) / pixels);
        CHECK(fabs((double)out[centre][0] - want) <= (row[k].counts ? 0.002 : 0)
                  && (out[centre][0] > 0) == row[k].counts,
              "tilt %g, height %g%s: %g, not %g", row[k].tilt, row[k].height, row[k].beyond ? " beyond the normal" : "",
              (double)out[centre][0], want);
    }
}

/* Sheets on both sides of a receiver, half a unit beyond the tap before them, which lies in its plane. Up to four times
   as high they are joined to that tap and hide all below them, else next to nothing. The same where a span, which is
   half of the radius then, brings taps as near to each other. */
static void steep_taps_are_not_joined(void)
{
    static const struct { float height, radius; int span, joined; } row[] = {
        { 1.98f, 4, 0, 1 }, { 2.02f, 4, 0, 0 }, { 1.98f, 8, 1, 1 }, { 2.02f, 8, 1, 0 } };
    static float map[MANY][4];
    const int centre = SIDE / 2 * SIDE + SIDE / 2;
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HSAO,
                                 .text.dialect = SSGI_GL_DIALECT_450,
                                 .gather.directions = 1,
                                 .gather.steps = 4,
                                 .gather.falloff = SSGI_GL_FALLOFF_NONE,
                                 .input.orthographic = 1,
                                 .input.depth = SSGI_GL_DEPTH_LINEAR,
                                 .surfel.span = row[k].span };
        const double high = (double)row[k].height, hidden = 32 * high * high / (high * high + 0.5625 * 0.5625);
        /* 64 pixels a side, of which the picture has half */
        const double want = expected(hidden, 32 - hidden, 4, (SIDE / 2 - 0.501) / 64) / 32;
        ssgi_gl_frame frame;
        ssgi_view view;
        if (!facing(&view, &frame, row[k].radius)) return;
        frame.thickness_limit = 1e-4f;
        frame.surfel[0] = 4;
        for (int i = 0; i < MANY; ++i) {                       /* taps: 1, 9, 25 pixels aside, and none */
            const int aside = abs(i % SIDE - SIDE / 2);
            map[i][0] = aside < 5 ? 10 : aside < 15 ? 10 - row[k].height : 100;
        }
        GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
        const int went = probe(&d, &frame, texture,
                               "vec3 P = ssgi_position(vec2(texel) + 0.5, ssgi_depth(texel));"
                               "o = vec4(ssgi_gather(texel, P, vec3(0.0, 0.0, 1.0), vec2(0.0, 0.5)).all);");
        glDeleteTextures(1, &texture);
        if (!went) return;
        CHECK(row[k].joined ? fabs((double)out[centre][0] - want) < 1.0 / 32 : out[centre][0] < 1.0f / 16,
              "height %g, %s: %g, joined %g", high, row[k].span ? "a span" : "no span", (double)out[centre][0], want);
    }
}

/* The back of a tap lies on the tap's own ray, not the receiver's, in perspective and without: how far along the
   receiver's plane and how high over it that is, and in which sector of its side. */
static void backs_lie_on_their_rays(void)
{
    t_seed(61);
    for (int flat_ = 0; flat_ < 2; ++flat_) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HSAO,
                                 .text.dialect = SSGI_GL_DIALECT_450,
                                 .input.orthographic = flat_ };
        const ssgi_gl_frame frame = { .radius = 1, .project = { 100, 100 }, .unproject = { 0.01f, 0.01f } };
        /* the receiver and the slice's turn; its normal and the thickness; the tap, along the slice and to the eye */
        for (int i = 0; i < MANY; i += 4) {
            const float z = t_uniform(1, 20), P[4] = { z * t_uniform(-2, 2), z * t_uniform(-2, 2), -z,
                                                          t_uniform(0, 6.28f) };
            float n[4] = { t_uniform(-1, 1), t_uniform(-1, 1), t_uniform(0.1f, 1), 0.1f * z * t_uniform(0, 1) };
            const float tap[4] = { 0.1f * z * t_uniform(-1, 1), 0.1f * z * t_uniform(-1, 1), 0, 0 };
            const float l = sqrtf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
            for (int c = 0; c < 3; ++c) n[c] /= l;
            memcpy(in[i], P, sizeof P);
            memcpy(in[i + 1], n, sizeof n);
            memcpy(in[i + 2], tap, sizeof tap);
            in[i + 3][0] = (float)flat_;
        }
        if (!probe(&d, &frame, 0,
                   "vec3 P = X(0).xyz; vec2 turn = vec2(cos(X(0).w), sin(X(0).w));"
                   "ssgi_receiver r = ssgi_receiver_of(P, X(1).xyz); mat3 m = r.basis;"
                   "vec3 along = m[0] * turn.x + m[1] * turn.y, at = along * X(2).x + m[2] * X(2).y;"
                   "ssgi_slice s = ssgi_slice_of(r, ivec2(0), turn);"
                   "vec3 Q = P + at; vec2 way = Q.xy / mix(-Q.z, 1.0, X(3).x) - P.xy / mix(-P.z, 1.0, X(3).x), sector;"
                   "vec4 back; for (int i = 0; i < 2; ++i) {"
                   "ssgi_side e = ssgi_side_of(s, 1.0 - 2.0 * float(i), 0.5, 1.0);"
                   "vec2 b = ssgi_on_ray(s, e, ssgi_ray_of(s, e, 100.0 * way), X(1).w - P.z - at.z);"
                   "float c = b.x * inversesqrt(dot(b, b)); back[i] = b.x, back[i + 2] = b.y;"
                   "sector[i] = ssgi_sector(e, c, c * c, b.y > 0.0, 32.0); }"
                   "int w = texel.x & 3; o = w == 0 ? back : w == 1 ? sector.xyxy : along.xyzz;"))
            return;
        for (int i = 0; i < MANY; i += 4) {
            double P[3], V[3], to[3], n[2] = { 0, 0 }, x[2] = { 0, 0 }, far = 0;
            for (int c = 0; c < 3; ++c) { P[c] = (double)in[i][c]; far += P[c] * P[c]; }
            for (int c = 0; c < 3; ++c) {
                V[c] = flat_ ? c == 2 : -P[c] / sqrt(far);
                to[c] = P[c] + (double)out[i + 2][c] * (double)in[i + 2][0] + V[c] * (double)in[i + 2][1];
            }
            for (int c = 0; c < 3; ++c) {
                const double back = to[c] - (double)in[i + 1][3] * (flat_ ? c == 2 : to[c] / to[2]);
                n[0] += (double)in[i + 1][c] * (double)out[i + 2][c];
                n[1] += (double)in[i + 1][c] * V[c];
                x[0] += (back - P[c]) * (double)out[i + 2][c];
                x[1] += (back - P[c]) * V[c];
            }
            /* the normal's angle from the view direction; the back's place along the tangent and up */
            const double g = atan2(n[0], n[1]), t = x[0] * cos(g) - x[1] * sin(g), up = x[0] * sin(g) + x[1] * cos(g),
                         within = 3e-6 * sqrt(far);
            if (n[1] < 0.1 || hypot(t, up) < 1e-3 * sqrt(far)) continue;
            for (int side = 0; side < 2; ++side) {
                const double ahead = side ? -t : t, turn = side ? -g : g, whole = arc(1.5707963267949 + turn, turn),
                             sector = 32 * arc(atan2(up, ahead), turn) / whole + 0.5;
                NEAR(out[i][side], ahead, within, "how far along the plane a back is");
                NEAR(out[i][2 + side], up, within, "how high it is");
                if (up > 0.005 * hypot(t, up))
                    NEAR(out[i + 1][side], fmax(fmin(sector, 32), 0), 0.05 / whole, "its sector");
            }
        }
    }
}

/* What pass thickness would write of view depths in x and thicknesses in w, in radii / 63. It leaves there what is read
   back. */
static GLuint measured(float (*map)[4], int orthographic)
{
    static uint32_t packed[MANY / 4][4];
    for (int t = 0; t < MANY / 4; ++t) {                   /* a texel a 2x2 */
        float z[4];
        unsigned thickness[4];
        for (int i = 0; i < 8; ++i) {                      /* in, then out */
            float *const of = map[(t / (SIDE / 2) * 2 + (i >> 1 & 1)) * SIDE + t % (SIDE / 2) * 2 + (i & 1)];
            if (i == 4) pack_measured(packed[t], z, thickness, orthographic);
            if (i < 4) { z[i] = of[0]; thickness[i] = (unsigned)of[3]; }
            else { of[0] = unpack_measured(thickness, packed[t], i & 3, orthographic); of[3] = (float)*thickness; }
        }
    }
    return kit_texture(SIDE / 2, SIDE / 2, GL_RGBA32UI, (const float *)(const void *)packed);
}

/* What stands before the receiver and a wall beside it: a pole farther away than the radius; and a second slab that
   begins behind a plane turned from the viewer. Neither covers anything, however deep it is, or hides the wall. */
static void what_covers_nothing(void)
{
    static const struct { int thickness; double tilt; float back[2]; } row[] = {
        { SSGI_GL_THICKNESS_CONSTANT, 0, { 0, 0 } }, { SSGI_GL_THICKNESS_SOLID, 0, { 0, 0 } },
        { SSGI_GL_THICKNESS_BACK, 0, { 0, 0 } },     { SSGI_GL_THICKNESS_SLABS, 0, { 0, 0 } },
        { SSGI_GL_THICKNESS_SLABS, 95, { 8.5f, 9.7f } } };
    static float map[MANY][4];
    const int centre = SIDE / 2 * SIDE + SIDE / 2;
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HSAO,
                                 .text.dialect = SSGI_GL_DIALECT_450,
                                 .gather.directions = 1,
                                 .gather.steps = 2,
                                 .gather.falloff = SSGI_GL_FALLOFF_NONE,
                                 .input.orthographic = 1,
                                 .input.depth = SSGI_GL_DEPTH_LINEAR,
                                 .gather.thickness = row[k].thickness };
        const double tilt = row[k].tilt * 0.017453292519943;
        ssgi_gl_frame frame;
        ssgi_view view;
        float covered[2];
        if (!facing(&view, &frame, 2)) return;
        frame.thickness_limit = 2;
        in[centre][0] = (float)sin(tilt);
        in[centre][1] = (float)cos(tilt);
        for (int pole = 0; pole < 2; ++pole) {
            memset(map, 0, sizeof map);
            for (int i = 0; i < MANY; ++i) {               /* taps: 2 and 18 pixels aside; the back is what is seen */
                const int aside = abs(i % SIDE - SIDE / 2);
                map[i][0] = !aside ? 10 : aside > 8 ? 9 : pole ? 7.9f : 100;
                if (pole && aside <= 8) memcpy(&map[i][1], row[k].back, sizeof row[k].back);
                map[i][3] = 63;
            }
            GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
            probed_width = measured(map, 1);
            const int went = probe(&d, &frame, texture,
                                   "vec3 P = ssgi_position(vec2(texel) + 0.5, ssgi_depth(texel));"
                                   "o = vec4(ssgi_gather(texel, P, vec3(a.x, 0.0, a.y), vec2(0.0, 0.5)).all);");
            glDeleteTextures(1, &texture);
            glDeleteTextures(1, &probed_width);
            probed_width = 0;
            if (!went) return;
            covered[pole] = out[centre][0];
        }
        CHECK(covered[0] > 0.1f && covered[1] == covered[0], "thickness %d, tilt %g: a wall covers %g, with more %g",
              row[k].thickness, row[k].tilt, (double)covered[0], (double)covered[1]);
    }
}

/* A slice's side of the walk as it is defined, by vectors and a sector at a time; frame and map as walks_by_vectors has
   them. Width is a map's w, in radii / 63. */
typedef struct walk { const ssgi_gl_frame *frame; const float (*map)[4]; int flat, thickness, steps; } walk;
typedef struct walked { double l, z, end, low, high, c, h; int seen; } walked;

static double dot3(const double *a, const double *b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

static void seen_at(const walk *w, double x, double y, double z, double *Q)
{
    const float *k = w->frame->unproject;
    const double by = w->flat ? 1 : z;
    Q[0] = (x * (double)k[0] + (double)k[2]) * by;
    Q[1] = (y * (double)k[1] + (double)k[3]) * by;
    Q[2] = -z;
}

/* The sector of a cosine, by the polynomial of ssgi_arc_odd, which twin_arc holds. */
static double sector_of(double c, double g, double whole, double noise)
{
    const double q = c * c;
    const double odd = 1.57079633 - c * (2.01098408 + q * (-0.43954273 + q * (0.21090284 - 0.21154786 * q)));
    return fmax(fmin((0.5 * cos(g) * (1 - q) + 0.5 * sin(g) * odd) * 32 / whole + noise, 32), 0);
}

/* Of sectors from low to high those that are free, which are taken. */
static int taken(uint32_t *mask, double low, double high)
{
    int fresh = 0;
    for (int s = (int)low; s < (int)high; ++s) {
        fresh += !(*mask >> s & 1);
        *mask |= UINT32_C(1) << s;
    }
    return fresh;
}

static void toward(double *sum, double c, double h, double share)
{
    const double l = fmax(hypot(c, h), 1e-6);
    sum[0] += share * c / l;
    sum[1] += share * h / l;
}

/* Attenuated sectors; where: times their elevation, along and up. t: along the tangent plane; n: the normal over the
   length of its projection; g: its angle. */
static double side_walked(double *where, const walk *w, const int *p, const double *P, const double *t, const double *n,
                          double g, const double *pixels, double xi, double noise)
{
    const double R = (double)w->frame->radius, whole = fmax(sector_of(-sin(g), g, 32, 0), 1e-5);
    /* a 20th of a pixel, under which the walk hides rounding */
    const float *per = w->frame->unproject;
    const double near = 0.05 * fmax(fabs((double)per[0]), fabs((double)per[1])) * (w->flat ? 1 : -P[2]);
    walked last = { 0, -P[2], -P[2], 0, 0, 1, 0, 1 };
    uint32_t mask = 0;
    double sum = 0, before = 0;
    for (int k = 0; k < w->steps; ++k) {
        const double root = (k + xi) / w->steps, u = root * root, gap = (u - before) * R;
        const int x = (int)floor(p[0] + 0.5 + pixels[0] * u), y = (int)floor(p[1] + 0.5 + pixels[1] * u);
        const int inside = x >= 0 && y >= 0 && x < SIDE && y < SIDE;
        const float *tap = w->map[inside ? y * SIDE + x : 0];
        double z[4] = { (double)tap[0], 0, (double)tap[1], 0 }, Q[3], at[4][3], e[4][2], L[4];
        const double width = (double)tap[3] * R / 63 + 0.5 * gap;
        z[1] = z[0] + (w->thickness == SSGI_GL_THICKNESS_CONSTANT ? (double)w->frame->thickness_limit : width);
        if (z[2] <= 0) z[2] = 1e18;
        z[3] = z[2] + fmax(fmin(tap[2] > tap[1] ? (double)(tap[2] - tap[1]) : (double)tap[3] * R / 63, R), 2 * gap);
        for (int i = 0; i < 4; ++i) {               /* front, back, second front, its back: along and up */
            seen_at(w, x + 0.5, y + 0.5, z[i], Q);
            for (int c = 0; c < 3; ++c) at[i][c] = Q[c] - P[c];
            e[i][0] = dot3(at[i], t);
            e[i][1] = dot3(at[i], n);
            L[i] = sqrt((i ? e[i][0] * e[i][0] + e[i][1] * e[i][1] : dot3(at[0], at[0])) + near * near);
        }
        const double h = fmax(fmin(e[0][1] / L[0], 1), 0), c = sqrt(1 - h * h) * (e[0][0] < -1e-9 ? -1 : 1);
        walked now = { L[0], z[0], z[1], 0, 0, c, h, inside && L[0] < R };
        double share;
        if (now.seen && h > (e[0][0] < -1e-9 ? 0.4 : 0.004)) now.high = sector_of(c, g, whole, noise);
        if (w->thickness == SSGI_GL_THICKNESS_SOLID) {
            share = taken(&mask, 0, now.high) * fmax(1 - 0.5 * (now.l + last.l) / R, 0);
            toward(where, c + last.c, h + last.h, share);
        } else {
            const int constant = w->thickness == SSGI_GL_THICKNESS_CONSTANT;
            if (e[1][1] / L[1] > 0.004) now.low = fmin(sector_of(e[1][0] / L[1], g, whole, noise), now.high);
            if (!constant) now.l = 0.5 * (now.l + fmin(now.l, L[1]));
            const double apart = constant ? fabs(now.z - last.z) / 4 : fmax(now.z - last.end, last.z - now.end);
            const int joined = now.seen && last.seen && apart < gap;
            const double d = now.l + (last.l - now.l) * (joined ? 0.5 : 0.125);
            share = taken(&mask, joined ? fmin(now.low, last.low) : now.low,
                          joined ? fmax(now.high, last.high) : now.high) * fmax(1 - d / R, 0);
            if (joined) toward(where, c + last.c, h + last.h, share);
            else toward(where, c + (e[1][1] > 0 ? e[1][0] / L[1] : 1), h + fmax(e[1][1], 0) / L[1], share);
        }
        sum += share;
        if (w->thickness == SSGI_GL_THICKNESS_SLABS && inside && L[2] < R && e[2][1] / L[2] > 0.004) {
            const double high = sector_of(e[2][0] / L[2], g, whole, noise);
            const double low = e[3][1] / L[3] > 0.004 ? sector_of(e[3][0] / L[3], g, whole, noise) : 0;
            share = taken(&mask, fmin(low, high), high) * fmax(1 - 0.5 * (L[2] + fmin(L[2], L[3])) / R, 0);
            toward(where, e[2][0], e[2][1], share);
            sum += share;
        }
        now.l = fmin(now.l, R);
        last = now;
        before = u;
    }
    const double edge[2] = { (pixels[0] < 0 ? p[0] + 0.499 : SIDE - p[0] - 0.501) / (fabs(pixels[0]) + 1e-9),
                             (pixels[1] < 0 ? p[1] + 0.499 : SIDE - p[1] - 0.501) / (fabs(pixels[1]) + 1e-9) };
    double open = 32;
    for (int i = 0; i < 32; ++i) open -= mask >> i & 1;
    return expected(sum, open, w->steps, fmin(edge[0], edge[1])) * whole / 32;
}

static double fraction(double x) { return x - floor(x); }

/* The walk of every pixel of a rough map, some of it turned far from the viewer, beside linear forms in GLSL; and what
   it takes from the first band of light's harmonics, which tells where. A sector that rounding moves is a 32nd of a
   slice's side: few pixels have one. */
static void walks_by_vectors(void)
{
    enum { SLICES = 2, STEPS = 5 };
    static float map[MANY][4], blocked[MANY];
    static const float m[2][16] = { { 2, 0, 0, 0, 0, 2.5f, 0, 0, 0.1f, -0.05f, -1.02f, -1, 0, 0, -0.2f, 0 },
                                    { 0.3f, 0, 0, 0, 0, 0.25f, 0, 0, 0, 0, -0.02f, 0, 0, 0, -1, 1 } };
    for (int k = 0; k < 8; ++k) {
        static const int thick[4] = { SSGI_GL_THICKNESS_SOLID, SSGI_GL_THICKNESS_CONSTANT, SSGI_GL_THICKNESS_WIDTH,
                                      SSGI_GL_THICKNESS_SLABS };
        ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HSAO,
                           .text.dialect = SSGI_GL_DIALECT_450,
                           .gather.directions = SLICES,
                           .gather.steps = STEPS,
                           .input.orthographic = k & 1,
                           .input.depth = SSGI_GL_DEPTH_LINEAR,
                           .gather.thickness = thick[k / 2] };
        ssgi_gl_frame frame;
        ssgi_view view;
        const char *why = "";
        const walk w = { &frame, (const float (*)[4])map, k & 1, d.gather.thickness, STEPS };
        if (!CHECK(ssgi_view_from_projection(&view, m[k & 1], SSGI_CLIP_GL, SIDE, SIDE, &why) == SSGI_OK
                       && ssgi_gl_frame_init(&frame, &view, 1.5f, &why) == SSGI_OK, "%s", why))
            return;
        frame.thickness_limit = 0.3f;
        t_seed(71 + (uint32_t)k);
        for (int i = 0; i < MANY; ++i) {                   /* a slope with blocks, a step down, holes */
            const int x = i % SIDE, y = i / SIDE, block = (x / 6 * 7 + y / 9 * 5) % 4;
            const float z = 8 + 0.02f * (float)x - 0.01f * (float)y - 0.4f * (float)block + (x > 40 ? 0.9f : 0);
            const float a = t_uniform(0, 6.28f), tilt = t_uniform(0, 1.5f);
            const float n[4] = { sinf(tilt) * cosf(a), sinf(tilt) * sinf(a), cosf(tilt), t_uniform(0, 1) };
            memcpy(in[i], n, sizeof n);
            map[i][0] = block == 3 && x % 5 == 0 ? 1e18f : z;
            map[i][1] = x % 3 ? z + t_uniform(0.1f, 0.5f) : 0;
            map[i][2] = map[i][1] > 0 && y % 3 ? map[i][1] + t_uniform(0.1f, 1) : 0;
            map[i][3] = (float)(1 + (int)t_uniform(0, 62.9f));
        }
        GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
        if (d.gather.thickness > SSGI_GL_THICKNESS_SOLID) probed_width = measured(map, k & 1);
#define WALK "float z = ssgi_depth(texel); vec2 xi = vec2(a.w, fract(7.0 * a.w)); " \
             "ssgi_sums s = ssgi_gather(texel, ssgi_position(vec2(texel) + 0.5, z), a.xyz, xi);"
        int went = probe(&d, &frame, texture, WALK "o = vec4(s.all);");
        for (int i = 0; i < MANY; ++i) blocked[i] = out[i][0];
        d.pass = SSGI_GL_PASS_SSDO;
        d.light.environment = SSGI_GL_ENVIRONMENT_SH;
        went = went && probe(&d, &frame, texture,
                             WALK "o = (ssgi_sh_zonal(SSGI_COSINE, a.xyz).a - s.lobe.a) / SSGI_PI;");
#undef WALK
        glDeleteTextures(1, &texture);
        glDeleteTextures(1, &probed_width);
        probed_width = 0;
        if (!went) return;
        int off = 0, many = 0, astray = 0;
        double bias = 0, mean = 0;
        for (int i = 0; i < MANY; ++i) {
            if (!(map[i][0] < 1e17f)) continue;
            const int p[2] = { i % SIDE, i / SIDE };
            const double n[3] = { (double)in[i][0], (double)in[i][1], (double)in[i][2] }, xi[2] = {
                (double)in[i][3], (double)fmodf(7 * in[i][3], 1) };
            double P[3], V[3] = { 0, 0, 1 }, B[2][3], want = 0, light[3] = { 0, 0, 0 };
            seen_at(&w, p[0] + 0.5, p[1] + 0.5, (double)map[i][0], P);
            for (int c = 0; c < 3 && !w.flat; ++c) V[c] = -P[c] / sqrt(dot3(P, P));
            /* [Duff et al. 2017] */
            const double q = -1 / (1 + V[2]), b = V[0] * V[1] * q;
            const double basis[2][3] = { { 1 + V[0] * V[0] * q, b, -V[0] }, { b, 1 + V[1] * V[1] * q, -V[1] } };
            memcpy(B, basis, sizeof B);
            for (int s = 0; s < SLICES; ++s) {
                const double phi = 3.14159265 * (s + xi[0]) / SLICES, wide = 0.61803399 * s + 3.7 * xi[0];
                double along[3], t[2][3], over[3], pixels[2][2];
                for (int c = 0; c < 3; ++c) along[c] = B[0][c] * cos(phi) + B[1][c] * sin(phi);
                const double sine = dot3(n, along), cosine = dot3(n, V), l = fmax(hypot(sine, cosine), 1e-4);
                for (int c = 0; c < 3; ++c) {
                    t[0][c] = (along[c] * cosine - V[c] * sine) / l;
                    t[1][c] = -t[0][c];
                    over[c] = n[c] / l;
                }
                for (int c = 0; c < 2; ++c) {
                    const double by = w.flat ? along[c] : (along[c] - P[c] * along[2] / P[2]) / -P[2];
                    pixels[0][c] = by * (double)frame.project[c] * (double)frame.radius;
                    pixels[1][c] = -pixels[0][c];
                }
                for (int side = 0; side < 2; ++side) {
                    double at[2] = { 0, 0 }, way[3];
                    const double share = l / SLICES * side_walked(at, &w, p, P, t[side], over,
                        (side ? -1 : 1) * atan2(sine, cosine), pixels[side], side ? 1 - xi[1] : xi[1],
                        fraction(xi[1] * (side ? 11.41 : 7.23) + wide));
                    want += share;
                    for (int c = 0; c < 3; ++c)
                        way[c] = t[side][c] * at[0] + (along[c] * sine + V[c] * cosine) / l * at[1];
                    for (int c = 0; c < 3; ++c) light[c] += share * way[c] / fmax(sqrt(dot3(way, way)), 1e-12);
                }
            }
            /* lanes y, z, w have the components y, z, x, times 0.4886 */
            for (int c = 0; c < 3; ++c)
                astray += fabs((double)out[i][1 + (c + 2) % 3] - 0.48860251 * light[c]) > 0.002;
            off += fabs((double)blocked[i] - want) > 0.002;
            bias += (double)blocked[i] - want;
            mean += want;
            ++many;
        }
        /* how far a texel is off its slice is taken at the receiver's depth */
        CHECK(off < many * (k & 1 ? 0.004 : 0.06) && fabs(bias) < many * 0.0004 && mean > many * 0.2,
              "%s, thickness %d: %d of %d pixels are off by more than 0.002, by %g on the mean",
              k & 1 ? "orthographic" : "perspective", d.gather.thickness, off, many, bias / many);
        /* of what lies behind a hole solids keep an elevation, which rounding decides */
        CHECK(astray < 3 * many * (k & 1 ? 0.015 : 0.06), "%s, thickness %d: of light %d of %d components are",
              k & 1 ? "orthographic" : "perspective", d.gather.thickness, astray, 3 * many);
        t_note("%s, thickness %d: %.4f blocked, by %.6f less; off by over 0.002: %d of %d, %d of light",
               k & 1 ? "orthographic" : "perspective", d.gather.thickness, mean / many, -bias / many, off, many,
               astray);
    }
}

/* A surface just before what a shadow map shows, which faces its light and whose texels are points: lit as long as that
   is what rounding does. */
static void shadow_slack(void)
{
    /* of a far point, of a map that is deep; 3e-7 of the scale, times depth squared where 1/z is stored, and 2e-5 of
       the depth */
    static const struct { float depth, scale; int flat; double slack; } row[] = {
        { 1000, 1, 1, 0.0200003 }, { 1, 1000, 1, 3.2e-4 }, { 10, 10, 0, 5e-4 }, { 1, 500, 0, 1.7e-4 } };
    static float map[MANY][4];
    const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_LIGHTS,
                             .text.dialect = SSGI_GL_DIALECT_450,
                             .light.shadow = SSGI_GL_SHADOW_MAP };
    ssgi_gl_frame frame = { .radius = 1, .max_slope = 20 };
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const float light[5][4] = { { 1, 0, 0, 0 },
                                    { 0, 1, 0, 0 },
                                    { 0, 0, -1, 0 },
                                    { 0, row[k].scale, -1, (float)row[k].flat },
                                    { 0, 32, SIDE, 1 } };
        memset(map, 0, sizeof map);
        memcpy(map[3], light, sizeof light);
        for (int i = 0; i < SIDE; ++i) {
            const double shown = (double)row[k].depth - row[k].slack * i / 32, w = row[k].flat ? shown : 1 / shown;
            const float to = row[k].flat ? 1 : row[k].depth,
                        p[4] = { ((float)i + 0.5f) * to, 0.5f * to, -row[k].depth, 0 };
            map[32 * SIDE + i][0] = (float)(w / (double)row[k].scale);
            memcpy(in[i], p, sizeof p);
        }
        GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
        const int went =
            probe(&d, &frame, texture,
                  "ssgi_light s; s.distance = length(a.xyz), s.facing = vec4(0.0);"
                  "float bias; o = vec4(ssgi_shadow(0, a.xyz, vec3(0.0, 0.0, 1.0), s, 1.0, bias));");
        glDeleteTextures(1, &texture);
        if (!went) return;
        for (int i = 0; i < SIDE; ++i)
            if (i != 32)
                CHECK(out[i][0] == (i > 32), "depth %g, scale %g, %s: %g of the slack before it is %s",
                      (double)row[k].depth, (double)row[k].scale, row[k].flat ? "orthographic" : "perspective",
                      i / 32.0, out[i][0] > 0 ? "dark" : "lit");
    }
}

/* Planes that slope against a sun's map, whose axis is the way to the light, or against a spot's at its axis. The map
   has a surface before them, by up to twice the bias in C: it shadows from the bias on. */
static void shadow_bias(void)
{
    static float map[MANY][4];
    const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_LIGHTS,
                             .text.dialect = SSGI_GL_DIALECT_450,
                             .light.shadow = SSGI_GL_SHADOW_MAP };
    ssgi_gl_frame frame = { .radius = 1, .max_slope = 6 };
    for (int k = 0; k < 10; ++k) {
        const int flat_ = k & 1, tilt = k / 2;
        const double c = 0.9 - 0.2 * tilt, depth = 20, width = flat_ ? 0.25 : 0.0125;
        const float patch = 0.25f, most = (float)(0.25 * sqrt(0.5) * 6); /* which the last is cut to */
        const double bias = (double)ssgi_shadow_bias(patch, (float)c, most, SSGI_BIAS_SAFE);
        const float light[5][4] = {
            { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, -1, 0 }, { 0, 1, -1, (float)flat_ }, { 0, 32, SIDE, 1 }
        };
        char statements[300];
        memset(map, 0, sizeof map);
        memcpy(map[3], light, sizeof light);
        for (int i = 0; i < SIDE; ++i) {
            const double shown = depth - bias * (i + 0.5) / 32;
            const float to = flat_ ? 1 : (float)depth, p[4] = { ((float)i + 0.5f) * to, 0.5f * to, -(float)depth, 0 };
            map[32 * SIDE + i][0] = (float)(flat_ ? shown : 1 / shown);
            memcpy(in[i], p, sizeof p);
        }
        GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
        /* at the axis the way to the light is as long as the depth */
        snprintf(statements, sizeof statements,
                 "ssgi_light s; s.distance = %f, s.facing = vec4(%f); float contact;"
                 "o = vec4(ssgi_shadow(0, a.xyz, vec3(%f, 0.0, %f), s, %f, contact));",
                 depth, width, sqrt(1 - c * c), c, c);
        const int went = probe(&d, &frame, texture, statements);
        glDeleteTextures(1, &texture);
        if (!went) return;
        int lit = 0;
        for (int i = 0; i < SIDE; ++i) lit += out[i][0] < 0.5f;
        /* a fiftieth of a texel of slack */
        CHECK(fabs(lit - 32 * (1 + 0.02 * (double)patch / bias)) <= 1.5, "cosine %g, %s: lit for %g of the bias", c,
              flat_ ? "a sun" : "a spot", lit / 32.0);
    }
}

/* As many rows as the texture has, each a sun that its map shows. The first says how many of the others are the same
   sun with wider maps; where that is no number of rows, it may be none or all, but no row is visited again. */
static void rows_are_visited_once(void)
{
    static const struct { float wider; int lights; float sum, or_; } row[] = {
        { 0, 3, 3, 3 },    { 1, 3, 2, 2 },   { 2, 3, 1, 1 },       { 3, 3, 1, 1 },         { -1, 3, 3, 3 },
        { -9, 3, 3, 3 },   { 3e9f, 3, 3, 1 }, { -3e9f, 3, 3, 1 },  { INFINITY, 3, 3, 1 }, { NAN, 3, 3, 1 },
        { 0, -5, 0, 0 },   { 0, INT_MAX, SIDE, SIDE } };
    static float map[MANY][4];
    const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_LIGHTS,
                             .text.dialect = SSGI_GL_DIALECT_450,
                             .light.shadow = SSGI_GL_SHADOW_MAP };
    for (int i = 0; i < SIDE; ++i) {
        const float light[8][4] = { { 0, 0, 1, SSGI_GL_LIGHT_SUN }, { 1, 1, 1, 0 }, { 0 }, { 1, 0, 0, 0 },
                                    { 0, 1, 0, 0 },                 { 0, 0, -1, 0 }, { 0, 1, -1, 1 }, { 8, 32, 8, 1 } };
        memcpy(map[SIDE * i], light, sizeof light);
        map[SIDE * 32 + 8][0] = 1000;                    /* what the map shows is far behind the point */
        memcpy(in[i], (float[4]){ 0.5f, 0.5f, -1, 0 }, sizeof in[i]);
    }
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const ssgi_gl_frame frame = { .radius = 1, .max_slope = 20, .lights = row[k].lights };
        map[1][3] = row[k].wider;
        GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
        const int went = probe(&d, &frame, texture, "o = vec4(ssgi_lit(a.xyz, vec3(0.0, 0.0, 1.0), 0.0), 1.0);");
        glDeleteTextures(1, &texture);
        if (!went) return;
        CHECK(out[0][0] == row[k].sum || out[0][0] == row[k].or_,
              "%g rows follow of %d lights: they sum up to %g, not %g", (double)row[k].wider, row[k].lights,
              (double)out[0][0], (double)row[k].sum);
    }
}

/* A point that the picture has in matter, and an extra camera before a wall at depth 2: it is open if it stands before
   that by more than two pixels there, which are 2/32 of its depth. */
static void view_slack(void)
{
    static const float m[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.002002f, -1, 0, 0, -0.2002002f, 0 },
                       still[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    static float map[MANY][4], wall[MANY];
    const ssgi_gl_desc d = { .text.dialect = SSGI_GL_DIALECT_450,
                             .gather.views = 1,
                             .gather.samples = 4,
                             .input.depth = SSGI_GL_DEPTH_LINEAR,
                             .gather.thickness = SSGI_GL_THICKNESS_SOLID };
    ssgi_view view;
    ssgi_gl_frame frame;
    const char *why = "";
    int open = 0;
    if (!CHECK(ssgi_view_from_projection(&view, m, SSGI_CLIP_GL, SIDE, SIDE, &why) == SSGI_OK
                   && ssgi_gl_frame_init(&frame, &view, 1, &why) == SSGI_OK
                   && ssgi_gl_views_set(&probed, 0, &view, still, still, &why) == SSGI_OK,
               "%s", why))
        return;
    for (int i = 0; i < MANY; ++i) {
        const float z = 1.5f + 0.6f * (float)i / MANY;
        map[i][0] = 1;
        wall[i] = (0.5f - view.depth[0]) / view.depth[1];
        ssgi_view_position(in[i], &view, 5.5f + (float)(i % 50), 9.5f + (float)(i / 97), z);
    }
    GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
    probed_layers = kit_texture_array(SIDE, SIDE, 1, GL_R32F, wall);
    if (probe(&d, &frame, texture, "o = vec4(ssgi_occlusion_at(a.xyz));"))
        for (int i = 0; i < MANY; ++i) {
            const double z = -(double)in[i][2], from = 2 / (1 + 2.0 / 32);
            if (fabs(z - from) > 1e-3)
                CHECK(out[i][0] == (z > from), "at depth %g, where two pixels end at %g: %g", z, from,
                      (double)out[i][0]);
            open += out[i][0] < 0.5f;
        }
    CHECK(open > MANY / 2 && open < MANY, "%d of %d are open", open, MANY);
    glDeleteTextures(1, &texture);
    glDeleteTextures(1, &probed_layers);
    probed_layers = 0;
}

typedef struct given { const char *name; GLuint texture; } given;

/* One of a pass's outputs alone, into floats. */
static int pass_drawn(float *result, int output, int components, int width, int height, const ssgi_gl_desc *d,
                      const ssgi_gl_frame *frame, const given *textures, int count)
{
    const GLenum to = GL_COLOR_ATTACHMENT0 + (GLenum)output, buffers[2] = { output ? GL_NONE : to, to };
    kit_error err = { "" };
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    const uint64_t key = ssgi_gl_key(d);
    const GLuint kept = kit_program_kept(key), program = kept ? kept : kit_pass_program(d, &err);
    GLuint block, framebuffer, target = kit_texture(width, height, components == 1 ? GL_R32F : GL_RGBA32F, NULL);
    int given_ = 0;
    if (!CHECK(program && (kept || !kit_program_keep(key, program, &err)), "%s", err.text)) return 0;
    glGenBuffers(1, &block);
    glBindBuffer(GL_UNIFORM_BUFFER, block);
    glBufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)sizeof *frame, frame, GL_STATIC_DRAW);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, block);
    glUseProgram(program);
    for (int i = 0, rows = ssgi_gl_reflect(d, row, SSGI_GL_MAX_IO); i < rows; ++i)
        for (int k = 0; k < count && row[i].kind == SSGI_GL_IO_TEXTURE; ++k)
            if (!strcmp(row[i].name, textures[k].name)) {
                glActiveTexture(GL_TEXTURE0 + (GLenum)row[i].slot);
                glBindTexture(strstr(row[i].type, "Array") ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, textures[k].texture);
                ++given_;
            }
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, to, GL_TEXTURE_2D, target, 0);
    glDrawBuffers(1 + output, buffers);
    glViewport(0, 0, width, height);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const int read = kit_texture_read(target, width, height, components, result);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &target);
    glDeleteBuffers(1, &block);
    return CHECK(!read && given_ == count, "%s: %d of %d textures are its own", ssgi_gl_pass_name(d->pass), given_,
                 count);
}

/* a texture of one channel that is another there */
static GLuint grey(int width, int height, float value, int at, float there)
{
    float *texel = malloc((size_t)width * (size_t)height * sizeof *texel);
    for (int i = 0; i < width * height; ++i) texel[i] = i == at ? there : value;
    const GLuint texture = kit_texture(width, height, GL_R32F, texel);
    free(texel);
    return texture;
}

/* One bright pixel of each level: 2^l pixels are averaged, and of 2^l + 1 around one the ends share a weight. */
static void smooth_weights(void)
{
    enum { LEVELS = 4 };
    static float got[LEVELS * MANY], normal[MANY][4], level[LEVELS * MANY];
    ssgi_gl_frame frame;
    ssgi_view view;
    if (!facing(&view, &frame, 1)) return;
    for (int i = 0; i < MANY; ++i) normal[i][2] = 1;
    for (int l = 0; l < LEVELS; ++l) level[l * MANY + 32 * SIDE + 32] = 1;
    const given t[3] = { { "t_ssgi_levels", kit_texture(SIDE, LEVELS * SIDE, GL_R32F, level) },
                         { "t_ssgi_depth", grey(SIDE, SIDE, 5, -1, 0) },
                         { "t_ssgi_normal", kit_texture(SIDE, SIDE, GL_RGBA32F, normal[0]) } };
    ssgi_gl_desc d = { .pass = SSGI_GL_PASS_SMOOTH,
                       .text.dialect = SSGI_GL_DIALECT_450,
                       .surfel.levels = LEVELS,
                       .input.orthographic = 1,
                       .input.depth = SSGI_GL_DEPTH_LINEAR };
    for (d.surfel.axis = 0; d.surfel.axis < 2; ++d.surfel.axis) {
        const int axis = d.surfel.axis;
        if (!pass_drawn(got, 0, 1, SIDE, LEVELS * SIDE, &d, &frame, t, 3)) return;
        for (int l = 0; l < LEVELS; ++l)
            for (int k = -8; k <= 8; ++k) {
                const int reach = 1 << l >> 1, away = abs(k);
                const double want = away > reach ? 0 : (away == reach && l ? 0.5 : 1) / (1 << l),
                             is = (double)got[l * MANY + (32 + (axis ? k : 0)) * SIDE + 32 + (axis ? 0 : k)];
                CHECK(fabs(is - want) < 1e-6, "axis %d, level %d, %d away: %g, not %g", axis, l, k, is, want);
            }
    }
    /* beside it, 0.7 of how far off a neighbour may be: its weight of a half has 0.3 left */
    const float off = 0.7f * 2 * ssgi_pixel_footprint(&view, 5);
    const given beside[3] = { t[0], { "t_ssgi_depth", grey(SIDE, SIDE, 5, 32 * SIDE + 31, 5 - off) }, t[2] };
    d.surfel.axis = 0;
    if (!pass_drawn(got, 0, 1, SIDE, LEVELS * SIDE, &d, &frame, beside, 3)) return;
    CHECK(fabs((double)got[MANY + 32 * SIDE + 32] - 1 / 1.65) < 1e-5, "beside a step: %g",
          (double)got[MANY + 32 * SIDE + 32]);
    glDeleteTextures(1, &beside[1].texture);
    for (int k = 0; k < 3; ++k) glDeleteTextures(1, &t[k].texture);
}

/* One bright pixel: a Gaussian whose variance is that of a radius of two deviations, and of a pixel: for 2 pixels
   5/4. */
static void gaussian_weights(void)
{
    static float got[MANY], ao[MANY][2];
    const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_BLUR,
                             .text.dialect = SSGI_GL_DIALECT_450,
                             .filter.kind = SSGI_GL_FILTER_GAUSSIAN,
                             .filter.radius = 2,
                             .input.orthographic = 1 };
    ssgi_gl_frame frame;
    ssgi_view view;
    if (!facing(&view, &frame, 1)) return;
    for (int i = 0; i < MANY; ++i) { ao[i][0] = i == 32 * SIDE + 32; ao[i][1] = 5; }
    const given t = { "t_ssgi_ao", kit_texture(SIDE, SIDE, GL_RG32F, ao[0]) };
    if (!pass_drawn(got, 0, 1, SIDE, SIDE, &d, &frame, &t, 1)) return;
    for (int y = -2; y <= 2; ++y)
        for (int x = -2; x <= 2; ++x) {
            const double is = (double)(got[(32 + y) * SIDE + 32 + x] / got[32 * SIDE + 32]),
                         want = exp(-0.4 * (x * x + y * y));
            CHECK(fabs(is - want) < 1e-5, "%d, %d away: %g of the centre's weight, not %g", x, y, is, want);
        }
    glDeleteTextures(1, &t.texture);
}

/* An emitter that shows its unseen side sends 0.35 of what is seen of it, edge-on nothing; a second slab behind it
   half; what shines from both sides all. */
static void unseen_sides(void)
{
    static const struct { float d[3], share[3]; } row[] = {    /* the normal is +z: before it, behind it, beside it */
        { { 0.3f, 0, -1 }, { 1, 1, 1 } },       { { 0, 0.2f, 1 }, { 0.35f, 0.35f, 1 } },
        { { 1, 0, -0.04f }, { 1, 1, 1 } },      { { 1, 0, 0.04f }, { 0.35f, 0.35f, 1 } },
        { { 0, 1, -0.02f }, { 0, 0, 1 } },      { { 0, -1, 0.02f }, { 0, 0, 1 } } };
    enum { ROWS = (int)(sizeof row / sizeof row[0]) };
    static uint32_t emitter[MANY][2];
    const float share = 0.125f, second = 0.25f;
    for (int i = 0; i < MANY; ++i) {
        emitter[i][0] = 256u | 128u << 9 | 64u << 18 | 16u << 27;           /* 1, 1/2, 1/4 */
        emitter[i][1] = 32u | 32u << 6;
    }
    probed_layers = kit_texture_array(SIDE, SIDE, 1, GL_RG32UI, (const float *)(const void *)emitter);
    for (int kind = 0; kind < 3; ++kind) {     /* plain, slabs, both sides */
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_SSDO,
                                 .text.dialect = SSGI_GL_DIALECT_450,
                                 .light.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE,
                                 .gather.thickness = kind == 1 ? SSGI_GL_THICKNESS_SLABS : SSGI_GL_THICKNESS_SOLID,
                                 .light.two_sided = kind == 2 };
        const ssgi_gl_frame frame = { .radius = 1 };
        memset(in, 0, sizeof in);
        for (int i = 0; i < ROWS; ++i) memcpy(in[i], row[i].d, sizeof row[i].d);
        if (!probe(&d, &frame, 0,
                   "ssgi_sums s = ssgi_sums_none(vec3(0.0, 0.0, 1.0)); ssgi_add_sent(s, ivec2(0), a.xyz, 0.125, 0.25);"
                   "o = vec4(s.bounce, 0.0);"))
            break;
        for (int i = 0; i < ROWS; ++i) {
            const float want = share * row[i].share[kind] + (kind == 1 ? 0.5f * second : 0);
            for (int c = 0; c < 3; ++c) NEAR(out[i][c], ldexpf(want, -c), 1e-6, "ssgi_add_sent");
        }
    }
    glDeleteTextures(1, &probed_layers);
    probed_layers = 0;
}

/* Several points over a disc straight ahead stand in the middles of rings of equal area: their sum telescopes. Beyond
   four radii it is its centre alone. */
static void points_over_a_disc(void)
{
    static const int points[] = { 2, 4, 16 };
    static char text[TEXT];
    const ssgi_gl_frame frame = { .radius = 1 };
    t_seed(47);
    for (int k = 0; k < 3; ++k) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_SPLAT,
                                 .text.dialect = SSGI_GL_DIALECT_450,
                                 .surfel.near_samples = points[k] };
        for (int i = 0; i < MANY; ++i) { in[i][0] = t_uniform(0.1f, 2); in[i][1] = powf(10, t_uniform(-2, 1)); }
        ssgi_gl_emit(text, TEXT, &d, SSGI_GL_STAGE_FRAGMENT);
        char *const rest = strstr(text, "flat in");
        if (rest) *rest = 0;
        if (!CHECK(rest, "no varyings")
            || !probe_text(text, d.text.dialect, &frame, 0,
                           "o = vec4(ssgi_form(vec3(0.0, 0.0, a.x), vec3(0.0, 0.0, 1.0), vec3(0.0, 0.0, -1.0), a.y));"))
            return;
        for (int i = 0; i < MANY; ++i) {
            const double h = (double)in[i][0], rr = (double)in[i][1], half = 0.5 * rr / points[k],
                         several = h / rr * (1 / (h * h + half) - 1 / (h * h + rr + half)),
                         want = h * h < 16 * rr ? several : 1 / (h * (h * h + rr));
            if (fabs(h * h / (16 * rr) - 1) > 1e-5) NEAR(out[i][0], want, 2e-5 * want, "ssgi_form");
        }
    }
}

/* A surfel that faces receivers farther and farther from it: its form factor is r^2 / (d^2 + r^2). Of that slices have
   all up to half a span, and less and less up to a whole one, if they see it: before the eye, and within two radii of
   the depth at its pixel, which others surround at another depth. One that they see and that faces the eye sends the
   light of the picture's surface, others their own. */
static void slices_see_surfels(void)
{
    static const struct { float x, z, radius, toward; int seen; } row[] = {
        { 0.06f, -10, 0.3f, -1, 1 },     { 0.06f, -9.41f, 0.3f, -1, 1 },  { 0.06f, -9.39f, 0.3f, -1, 0 },
        { 0.06f, -10.59f, 0.3f, -1, 1 }, { 0.06f, -10.61f, 0.3f, -1, 0 }, { 0.07f, -10, 0.3f, -1, 0 },
        { -0.01f, -10, 0.3f, -1, 0 },    { 2.1f, -50, 0.3f, -1, 0 },      { 0.06f, -0.001f, 5.1f, -1, 1 },
        { 0.06f, 0.001f, 5.1f, -1, 0 },  { 0.06f, -10, 0.3f, 1, 1 },      { 0.06f, -9.39f, 0.3f, 1, 0 } };
    static const float own[3] = { 0.75f, 1, 2 };
    static float got[MANY][4];
    static uint32_t texel[MANY][4], emitter[MANY][2];
    const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_SPLAT,
                             .text.dialect = SSGI_GL_DIALECT_450,
                             .input.orthographic = 1,
                             .surfel.levels = 1,
                             .surfel.span = 8,
                             .surfel.effect = SSGI_GL_EFFECT_BOUNCE,
                             .input.depth = SSGI_GL_DEPTH_LINEAR };
    const double span = 8 * 0.25;
    GLuint array, buffer;
    GLint was;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &was);
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    for (GLuint i = 0; i < 3; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, 4, GL_FLOAT, GL_FALSE, sizeof(ssgi_surfel), (const void *)(size_t)(16 * i));
        glVertexAttribDivisor(i, 1);                           /* the same at each corner */
    }
    for (int i = 0; i < MANY; ++i) emitter[i][0] = 256u | 128u << 9 | 64u << 18 | 16u << 27;      /* 1, 1/2, 1/4 */
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const ssgi_surfel surfel = { .position = { row[k].x, 0.03f, row[k].z }, .radius = row[k].radius,
                                     .normal = { 0, 0, row[k].toward }, .colour = { own[0], own[1], own[2] } };
        ssgi_gl_frame frame;
        ssgi_view view;
        if (!facing(&view, &frame, 50)) return;
        frame.surfel[0] = 0.25f;
        frame.epsilon = 1e-4f;
        for (int i = 0; i < MANY; ++i) {
            const float P[3] = { row[k].x, 0.03f, row[k].z + row[k].toward * (float)(1.25 * span * (i + 1) / MANY) };
            memcpy(texel[i], P, sizeof P);
            texel[i][3] = row[k].toward < 0 ? 0x80008000u : 0xffffffffu;       /* +z, -z */
        }
        const given t[3] = {
            { "t_ssgi_interleaved", kit_texture(SIDE, SIDE, GL_RGBA32UI, (const float *)(const void *)texel) },
            { "t_ssgi_depth", grey(2 * SIDE, SIDE, 50, SIDE * SIDE + SIDE / 2, 10) },
            { "t_ssgi_emitters", kit_texture_array(SIDE, SIDE, 1, GL_RG32UI, (const float *)(const void *)emitter) } };
        glBufferData(GL_ARRAY_BUFFER, sizeof surfel, &surfel, GL_STATIC_DRAW);
        if (!pass_drawn(got[0], 0, 4, SIDE, SIDE, &d, &frame, t, 3)) return;
        for (int i = 0; i < MANY; ++i) {                       /* of its rectangle the lower half is drawn */
            const double away = 1.25 * span * (i + 1) / MANY, rr = (double)row[k].radius * (double)row[k].radius,
                         sliced = row[k].seen ? fmax(fmin(2 - 2 * away / span, 1), 0) : 0,
                         form = rr / (away * away + rr) * (1 - sliced);
            if (i % SIDE + i / SIDE >= SIDE - 1) continue;
            NEAR(got[i][3], form, 1e-5, row[k].seen ? "a surfel that slices see" : "one that they do not see");
            for (int c = 0; c < 3; ++c)
                NEAR(got[i][c], form * (row[k].seen && row[k].toward > 0 ? ldexp(1, -c) : (double)own[c]), 2e-5,
                     "its light");
        }
        for (int i = 0; i < 3; ++i) glDeleteTextures(1, &t[i].texture);
    }
    glBindVertexArray((GLuint)was);
    glDeleteVertexArrays(1, &array);
    glDeleteBuffers(1, &buffer);
}

/* Pixel bounds of spheres and of halves of them, also of those that the near depth cuts. */
static void twin_spheres(void)
{
    static const float m[2][16] = { { 1, 0, 0, 0, 0, -1.5f, 0, 0, 0.1f, 0.2f, -1.002002f, -1, 0, 0, -0.2002002f, 0 },
                                    { 0.5f, 0, 0, 0, 0, 0.7f, 0, 0, 0, 0, -0.02f, 0, 0.1f, -0.2f, -1, 1 } };
    static const float normal[8][3] = {
        [4] = { 0, 0.6f, 0.8f }, { 0.6f, 0, -0.8f }, { -0.8f, 0.36f, -0.48f }, { -0.36f, -0.8f, 0.48f }
    };
    static char text[TEXT];
    t_seed(41);
    for (int k = 0; k < 8; ++k) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_FIELD,
                                 .text.dialect = SSGI_GL_DIALECT_450,
                                 .input.orthographic = k & 1 };
        const char *why = "";
        ssgi_gl_frame frame;
        ssgi_view view;
        char code[160];
        int cut = 0, empty = 0;
        snprintf(code, sizeof code,
                 "vec3 n = vec3(%g, %g, %g); o = vec4(ssgi_sphere(a, n, vec2(0.0)), ssgi_sphere(a, n, vec2(1.0)));",
                 (double)normal[k][0], (double)normal[k][1], (double)normal[k][2]);
        if (!CHECK(ssgi_view_from_projection(&view, m[k & 1], SSGI_CLIP_GL, 640, 480, &why) == SSGI_OK
                       && ssgi_gl_frame_init(&frame, &view, 1, &why) == SSGI_OK, "%s", why))
            return;
        frame.near_depth = k < 2 ? frame.near_depth : t_uniform(0.1f, 2);
        for (int i = 0; i < MANY; ++i) {
            const float r = powf(10, t_uniform(-1, 0.5f)),
                        s[4] = { t_uniform(-4, 4), t_uniform(-4, 4), -t_uniform(-2, 6), r };
            memcpy(in[i], s, sizeof s);
        }
        ssgi_gl_emit(text, TEXT, &d, SSGI_GL_STAGE_VERTEX);
        char *const rest = strstr(text, "flat out");
        if (rest) *rest = 0;
        if (!CHECK(rest, "no vertex stage") || !probe_text(text, d.text.dialect, &frame, 0, code)) return;
        for (int i = 0; i < MANY; ++i) {
            float b[4] = { 0, 0, 0, 0 }, got[4];
            const int is = ssgi__sphere_bounds(b, &view, in[i], normal[k], in[i][3], frame.near_depth);
            for (int c = 0; c < 4; ++c) got[c] = fminf(fmaxf(out[i][c], 0), c & 1 ? 480 : 640);
            if (is) for (int c = 0; c < 4; ++c) NEAR(got[c], b[c], 0.02, "ssgi_sphere");
            else CHECK(got[2] - got[0] < 0.02f || got[3] - got[1] < 0.02f, "a sphere that is not seen is drawn");
            if (in[i][3] - in[i][2] < frame.near_depth)    /* no width would be a texel when it is rounded outwards */
                for (int c = 0; c < 4; ++c) NEAR(out[i][c], 0, 0, "ssgi_sphere before the near depth");
            cut += is && -in[i][2] - in[i][3] < frame.near_depth;
            empty += !is;
        }
        CHECK(cut > 100 && empty > 100, "%d spheres are cut, %d not seen", cut, empty);
    }
}

/* Parts that a triangle's edges need: by the finest surfels in it, wherever it is about the near plane and the eye. */
static void twin_parts(void)
{
    enum { MOST = 40 };
    static const float m[2][16] = { { 1, 0, 0, 0, 0, 1.5f, 0, 0, 0, 0, -1.002002f, -1, 0, 0, -0.2002002f, 0 },
                                    { 0.5f, 0, 0, 0, 0, 0.7f, 0, 0, 0, 0, -0.02f, 0, 0, 0, -1, 1 } };
    static char text[TEXT];
    t_seed(43);
    for (int k = 0; k < 2; ++k) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_SURFELS,
                                 .text.dialect = SSGI_GL_DIALECT_410,
                                 .surfel.tessellate = 1,
                                 .input.orthographic = k };
        const char *why = "";
        ssgi_gl_frame frame;
        ssgi_view view;
        int parts[2] = { 0, 0 };
        if (!CHECK(ssgi_view_from_projection(&view, m[k], SSGI_CLIP_GL, 640, 480, &why) == SSGI_OK
                       && ssgi_gl_frame_init(&frame, &view, 1, &why) == SSGI_OK, "%s", why))
            return;
        const float scale[4] = { 0.002f, 0.5f, 0, MOST };
        memcpy(frame.surfel, scale, sizeof scale);
        for (int i = 0; i < MANY; ++i) {                   /* view depths, area */
            for (int c = 0; c < 3; ++c) in[i][c] = t_uniform(-1, 2) * (i & 1 ? 1 : 0.3f);
            in[i][3] = powf(10, t_uniform(-3, 0.5f));
        }
        ssgi_gl_emit(text, TEXT, &d, SSGI_GL_STAGE_TESS_CONTROL);
        char *const rest = strstr(text, "layout(vertices");
        if (rest) *rest = 0;
        if (!CHECK(rest, "no tessellator") || !probe_text(text, SSGI_GL_DIALECT_410, &frame, 0,
                                                          "o = vec4(ssgi_parts(a.xyz, a.w));"))
            return;
        for (int i = 0; i < MANY; ++i) {
            ssgi__surfel_maker maker = { .view = &view, .scale = { (double)scale[0], (double)scale[1] } };
            ssgi__patch whole = { .area = (double)in[i][3] };
            for (int c = 0; c < 3; ++c) whole.at[c][2] = -(double)in[i][c];
            const double r = ssgi__surfel_finest(&whole, &maker),
                         exact = sqrt((double)in[i][3] / (3.14159265358979 * 3169 * r * r));
            if (fabs(exact - nearbyint(exact)) < 1e-4) continue;
            const int want = ssgi__surfel_splits(&whole, &maker, MOST);
            NEAR(out[i][0], want, 0, "ssgi_parts");
            parts[0] += want > 1;
            parts[1] += want < MOST;
        }
        CHECK(parts[0] > MANY / 4 && parts[1] > MANY / 4, "%d triangles in parts, %d in fewer than most", parts[0],
              parts[1]);
    }
}

/* Levels, their points, radii, and corners of triangles that shrink, as ssgi_surfels has them. */
static void twin_tessellation(void)
{
    static const float m[2][16] = { { 1, 0, 0, 0, 0, 1.5f, 0, 0, 0, 0, -1.002002f, -1, 0, 0, -0.2002002f, 0 },
                                    { 0.5f, 0, 0, 0, 0, 0.7f, 0, 0, 0, 0, -0.02f, 0, 0, 0, -1, 1 } };
    static char text[TEXT];
    t_seed(53);
    for (int k = 0; k < 4; ++k) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_SURFELS,
                                 .text.dialect = SSGI_GL_DIALECT_410,
                                 .surfel.tessellate = 1,
                                 .input.orthographic = k & 1,
                                 .surfel.overhang = k / 2 };
        const ssgi_surfel_desc made = { .size = 0.02f, .overhang = k / 2 };
        const char *why = "";
        ssgi_gl_frame frame;
        ssgi_view view;
        if (!CHECK(ssgi_view_from_projection(&view, m[k & 1], SSGI_CLIP_GL, 640, 480, &why) == SSGI_OK
                       && ssgi_gl_frame_init(&frame, &view, 1, &why) == SSGI_OK
                       && ssgi_gl_surfels_set(&frame, &view, &made, NULL, &why) == SSGI_OK, "%s", why))
            return;
        ssgi_gl_emit(text, TEXT, &d, SSGI_GL_STAGE_TESS_CONTROL);
        char *const rest = strstr(text, "layout(vertices");
        if (!CHECK(rest, "no tessellator")) return;
        *rest = 0;
        for (int i = 0; i < MANY; ++i) {                   /* discs, view depth, level */
            const float v[4] = { powf(10, t_uniform(-1, 4)), t_uniform(-2, 9), (float)(1 + i % 64), 0 };
            memcpy(in[i], v, sizeof v);
        }
        if (!probe_text(text, SSGI_GL_DIALECT_410, &frame, 0,
                        "o = vec4(ssgi_tess_level(a.x), ssgi_surfel_radius(a.y), ssgi_tess_count(int(a.z)), 0.0);"))
            return;
        for (int i = 0; i < MANY; ++i) {
            const double discs = (double)in[i][0], radius = ssgi_surfel_radius(&view, 0.02, (double)in[i][1]),
                         level = sqrt((4 * discs - 1) / 3) - 1;
            if (fabs(level - nearbyint(level) - 1e-5) > 1e-4)
                NEAR(out[i][0], ssgi_tess_level(3.14159265358979 * discs * 0.09, 0.3), 0, "ssgi_tess_level");
            NEAR(out[i][1], radius, 1e-5 * radius, "ssgi_surfel_radius");
            NEAR(out[i][2], ssgi_tess_count((int)in[i][2]), 0, "ssgi_tess_count");
        }
        for (int i = 0; i < MANY; ++i) {                   /* two corners in the plane of x and y, a radius, which */
            const float v[4] = { t_uniform(0.2f, 3), t_uniform(0.1f, 2), powf(10, t_uniform(-2, 0.5f)),
                                 (float)(i % 3) };
            memcpy(in[i], v, sizeof v);
        }
        ssgi_gl_emit(text, TEXT, &d, SSGI_GL_STAGE_TESS_CONTROL);
        *rest = 0;
        if (!probe_text(text, SSGI_GL_DIALECT_410, &frame, 0,
                        "vec3 at[3] = vec3[3](vec3(0.0, 0.0, -1.0), vec3(a.x, 0.0, -1.0), vec3(0.4, a.y, -1.0));"
                        "o = vec4(ssgi_inset(at, int(a.w), a.z, 0.5 * a.x * a.y), 0.0);"))
            return;
        for (int i = 0; i < MANY; ++i) {
            ssgi__patch p = { .at = { { 0, 0, -1 }, { (double)in[i][0], 0, -1 }, { 0.4, (double)in[i][1], -1 } },
                              .area = 0.5 * (double)in[i][0] * (double)in[i][1], .radius = (double)in[i][2] };
            ssgi__surfel_inset(&p, k / 2);
            for (int c = 0; c < 3; ++c) NEAR(out[i][c], p.at[i % 3][c], 1e-5, "ssgi_inset");
        }
    }
}

/* ---- >>history: what is read of the last frame ------------------------------------------------------------------- */

/* A camera that stands still, or went so far sideways. */
static int follows_itself(ssgi_view *view, ssgi_gl_frame *frame, float radius, float by)
{
    const float now[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    float last[16];
    const char *why = "";
    memcpy(last, now, sizeof last);
    last[12] = last[13] = by;
    return facing(view, frame, radius)
        && CHECK(ssgi_gl_frame_history(frame, view, now, last, &why) == SSGI_OK, "%s", why);
}

#define FACING "vec3 ssgi_custom_normal(ivec2 texel) { return vec3(0.0, 0.0, 1.0); }\n"

/* What the last frame knows lies between four texels: of a ramp its value at the place, and how much that is blurred. A
   hundredth of a texel counts as none. */
static void history_lies_between(void)
{
    static float map[MANY][4];
    static const float moved[] = { 0, 0.005f, 0.25f, 0.5f, 0.8f };
    const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HISTORY,
                             .text.dialect = SSGI_GL_DIALECT_450,
                             .input.orthographic = 1,
                             .input.normal = SSGI_GL_NORMAL_CUSTOM,
                             .text.fetch = FACING };
    for (int i = 0; i < MANY; ++i) {                       /* value, depth, frames */
        const float texel[4] = { (float)(i % SIDE + 2 * (i / SIDE)), 10, 0.5f, 5 };
        memcpy(map[i], texel, sizeof texel);
    }
    for (size_t k = 0; k < sizeof moved / sizeof *moved; ++k) {
        const double by = fmax(1.02 * (double)moved[k] - 0.01, 0);
        ssgi_gl_frame frame;
        ssgi_view view;
        if (!follows_itself(&view, &frame, 1, moved[k] / 16)) return;
        GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
        const int went = probe(&d, &frame, texture,
                               "vec3 P = ssgi_position(vec2(texel) + 0.5, 10.0);"
                               "ssgi_last l = ssgi_last_of(texel, P, vec3(0.0, 0.0, 1.0));"
                               "o = vec4(l.kept.light.x, l.kept.means.y, l.known, l.blurred);");
        glDeleteTextures(1, &texture);
        if (!went) return;
        for (int i = 0; i < MANY; ++i) {
            if (i % SIDE == SIDE - 1 || i / SIDE == SIDE - 1) continue;
            NEAR(out[i][0], (double)map[i][0] + 3 * by, 2e-3, "the ramp");
            NEAR(out[i][1], 5, 1e-4, "frames");
            NEAR(out[i][2], 1, 1e-4, "known");
            NEAR(out[i][3], 2 * by * (1 - by), 1e-3, "blurred");
        }
    }
}

static GLuint filled(float value)
{
    static float texel[MANY];
    for (int i = 0; i < MANY; ++i) texel[i] = value;
    return kit_texture(SIDE, SIDE, GL_R32F, texel);
}

/* Frames are counted on where the last one shows the same plane, up to a pixel beyond its picture: of four texels one
   alone counts whole, if it weighs a quarter. They are 16 at most, amid two texels 10.7, amid four 8. Where .007 of
   what lies within the radius changed two are left; things that move by more than half a pixel on their own, by
   motion vectors, keep theirs. */
static void history_counts_on(void)
{
    static float now[MANY][2], last[MANY][4], went[MANY][2], got[MANY][4];
    const int centre = SIDE / 2 * SIDE + SIDE / 2;
    const struct { float by, nearby; int alone; float own, kept; double frames; } cases[] = {
        { 0.25f, 0, 1, 0, 5, 6 },   { 0.45f, 0, 1, 0, 5, 6 },  { 0.55f, 0, 1, 0, 5, 1 },    { 0, 0, 0, 0, 5, 6 },
        { 0, 0, 0, 0, 40, 16 },     { 0, 0, 0, 0.5f, 40, 16 / 1.5 }, { 0.5f, 0, 0, 0, 40, 8 }, { 32.9f, 0, 0, 0, 5, 6 },
        { 33.1f, 0, 0, 0, 5, 1 },   { 0, 0.007f, 0, 0, 5, 2 }, { 0, 1, 0, 0, 5, 1.007 },
        { 0, 1, 0, 0.45f, 5, 1.007 },
        { 0, 1, 0, 0.55f, 5, 6 },   { 0, 1, 0, 2, 5, 6 } };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HISTORY,
                                 .text.dialect = SSGI_GL_DIALECT_450,
                                 .input.orthographic = 1,
                                 .input.motion = cases[k].own > 0,
                                 .input.normal = SSGI_GL_NORMAL_CUSTOM,
                                 .text.fetch = FACING };
        ssgi_gl_frame frame;
        ssgi_view view;
        if (!follows_itself(&view, &frame, cases[k].alone ? 0.01f : 1, cases[k].by / 16)) return;
        for (int i = 0; i < MANY; ++i) {
            const float texel[4] = { 0.5f, cases[k].alone && i != centre ? 50 : 10, 0.5f, cases[k].kept };
            went[i][0] = cases[k].own;
            now[i][0] = 0.5f;
            now[i][1] = 10;
            memcpy(last[i], texel, sizeof texel);
        }
        const given t[4] = { { "t_ssgi_ao", kit_texture(SIDE, SIDE, GL_RG32F, now[0]) },
                             { "t_ssgi_history", kit_texture(SIDE, SIDE, GL_RGBA32F, last[0]) },
                             { "t_ssgi_change_share", filled(cases[k].nearby) },
                             { "t_ssgi_motion", kit_texture(SIDE, SIDE, GL_RG32F, went[0]) } };
        if (!pass_drawn(got[0], 0, 4, SIDE, SIDE, &d, &frame, t, 3 + d.input.motion)) return;
        CHECK(fabs((double)got[centre][3] - cases[k].frames) < 1e-3
                  && (!cases[k].alone || got[centre + 3 * SIDE + 3][3] == 1),
              "case %zu: %g frames, of none %g", k, (double)got[centre][3], (double)got[centre + 3 * SIDE + 3][3]);
        for (int i = 0; i < 4; ++i) glDeleteTextures(1, &t[i].texture);
    }
}

/* The last frame saw a plane that is off by up to twice the slack, which is half a pixel and a thousandth of the depth,
   and as many pixels more as a thing moved beyond half a one. It is measured across the plane, though depths are along
   the view, and where a camera came nearer from what it saw before. */
static void history_keeps_its_plane(void)
{
    static const struct { const char *normal; double cosine; float own, nearer, coarser; } row[] = {
        { "0.0, 0.0, 1.0", 1, 0, 0, 1 }, { "0.0, 0.8, 0.6", 0.6, 0, 0, 1 }, { "0.0, 0.0, 1.0", 1, 0, 3, 1 },
        { "0.0, 0.0, 1.0", 1, 1, 0, 1 }, { "0.0, 0.0, 1.0", 1, 3, 0, 1 }, { "0.0, 0.0, 1.0", 1, 0, 0, 1.7f } };
    static float now[MANY][2], last[MANY][4], went[MANY][2], got[MANY][4];
    const float still[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const double pixel = (double)row[k].coarser / 16;
        const double slack = 0.5 * pixel + 0.001 * 10 + fmax((double)row[k].own - 0.5, 0) * pixel;
        const int moved = (int)row[k].own;
        char fetch[100];
        snprintf(fetch, sizeof fetch, "vec3 ssgi_custom_normal(ivec2 texel) { return vec3(%s); }\n", row[k].normal);
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HISTORY,
                                 .text.dialect = SSGI_GL_DIALECT_450,
                                 .input.orthographic = 1,
                                 .input.motion = 1,
                                 .input.normal = SSGI_GL_NORMAL_CUSTOM,
                                 .text.fetch = fetch };
        ssgi_gl_frame frame;
        ssgi_view view;
        float before[16];
        const char *why = "";
        memcpy(before, still, sizeof before);
        before[14] = -row[k].nearer;
        if (!facing(&view, &frame, 1)
            || !CHECK(ssgi_gl_frame_history(&frame, &view, still, before, &why) == SSGI_OK, "%s", why))
            return;
        frame.last_footprint = row[k].coarser;
        for (int i = 0; i < MANY; ++i) {
            const double off = slack / row[k].cosine * (4.0 * i / MANY - 2);
            const float texel[4] = { 0.5f, (float)(10 + (double)row[k].nearer + off), 0.5f, 5 };
            now[i][0] = 0.5f;
            now[i][1] = 10;
            went[i][1] = -row[k].own;
            memcpy(last[i], texel, sizeof texel);
        }
        const given t[4] = { { "t_ssgi_ao", kit_texture(SIDE, SIDE, GL_RG32F, now[0]) },
                             { "t_ssgi_history", kit_texture(SIDE, SIDE, GL_RGBA32F, last[0]) },
                             { "t_ssgi_change_share", filled(0) },
                             { "t_ssgi_motion", kit_texture(SIDE, SIDE, GL_RG32F, went[0]) } };
        if (!pass_drawn(got[0], 0, 4, SIDE, SIDE, &d, &frame, t, 4)) return;
        for (int i = 0; i < MANY - (moved + 1) * SIDE; ++i) {  /* it moved up by so many rows */
            const double off = 4.0 * (i + moved * SIDE) / MANY - 2;
            if (fabs(fabs(off) - 1) > 2e-3)
                CHECK((got[i][3] > 1) == (fabs(off) < 1), "row %d: off by %g of the slack: %g frames", k, off,
                      (double)got[i][3]);
        }
        for (int i = 0; i < 4; ++i) glDeleteTextures(1, &t[i].texture);
    }
}

/* Any last state, and this frame a checkerboard beside an even half. A pixel's value is the mean of 3x3 texels up to
   four frames, of five from five on. The mean over three frames goes a third of the way to it and stays within 0.7
   deviations and 2 % of it; that over all goes 1/frames of it, at most 16, and stays within 0.2 and 0.5 % of the other,
   for which it forgets up to 0.85 of the frames. Light that has to become three times as bright begins anew. */
static void history_follows(void)
{
    static float now[MANY][4], last[MANY][4], means[MANY][2], light[MANY][4], kept[MANY][4];
    const double tint[2][3] = { { 1, 1, 1 }, { 2, (1 - 2 * 0.2126) / 0.7152, 0 } };   /* as bright as grey */
    int held = 0, pulled = 0, neither = 0, anew = 0;
    t_seed(67);
    for (int colour = 0; colour < 2; ++colour) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HISTORY,
                                 .text.dialect = SSGI_GL_DIALECT_450,
                                 .input.orthographic = 1,
                                 .filter.quantity = colour ? SSGI_GL_QUANTITY_LIGHT : SSGI_GL_QUANTITY_VISIBILITY,
                                 .input.normal = SSGI_GL_NORMAL_CUSTOM,
                                 .text.fetch = FACING };
        ssgi_gl_frame frame;
        ssgi_view view;
        if (!follows_itself(&view, &frame, 1, 0)) return;
        for (int i = 0; i < MANY; ++i) {
            const float value = i % SIDE < SIDE / 2 ? 0.5f : (i + i / SIDE) & 1 ? 0.4f : 0.6f,
                        mean = value + t_uniform(-0.4f, 0.3f), quick = mean + t_uniform(-0.1f, 0.1f);
            means[i][0] = quick;
            means[i][1] = t_uniform(0, 20);
            for (int c = 0; c < 3; ++c) {
                now[i][c] = value * (float)tint[colour][c];
                last[i][c] = mean * (float)tint[colour][c];
            }
            now[i][colour ? 3 : 1] = last[i][colour ? 3 : 1] = 10;
            if (!colour) memcpy(&last[i][2], means[i], sizeof means[i]);
        }
        const given t[4] = { { colour ? "t_ssgi_light" : "t_ssgi_ao", kit_texture(SIDE, SIDE, GL_RGBA32F, now[0]) },
                             { "t_ssgi_history", kit_texture(SIDE, SIDE, GL_RGBA32F, last[0]) },
                             { "t_ssgi_change_share", filled(0) },
                             { "t_ssgi_means", kit_texture(SIDE, SIDE, GL_RG32F, means[0]) } };
        if (!pass_drawn(light[0], colour, 4, SIDE, SIDE, &d, &frame, t, 3 + colour)
            || (colour && !pass_drawn(kept[0], 0, 4, SIDE, SIDE, &d, &frame, t, 4)))
            return;
        for (int i = 0; i < MANY; ++i) {
            const int x = i % SIDE, y = i / SIDE, even = x < SIDE / 2;
            if ((x + 1) % (SIDE / 2) < 2 || (y + 1) % SIDE < 2) continue;          /* has other neighbours */
            const double h = even ? 0 : (i + y) & 1 ? -0.1 : 0.1, n = (double)means[i][1],
                         most = n < 1 ? 1 : fmin(n + 1, 16), value = 0.5 + h * (most < 4.5 ? 1 / 9.0 : -3 / 5.0);
            /* of nine texels; of five, which are few: a tenth of the value more */
            const double deviation = most < 4.5 ? fabs(h) * sqrt(10 / 9.0) : 1.2 * sqrt(h * h + 0.01 * value * value),
                         jump = 0.7 * deviation + 0.02 * value, drift = 0.2 * deviation + 0.005 * value;
            double quick = value + ((double)means[i][0] - value) * (1 - 1 / fmin(most, 3)),
                   mean = value + ((double)last[i][0] / tint[colour][0] - value) * (1 - 1 / most), frames = most;
            held += fabs(quick - value) > jump;
            quick = fmax(fmin(quick, value + jump), value - jump);
            const double by = fmax(fmin(mean, quick + drift), quick - drift) - mean;
            pulled += fabs(by) > 0;
            neither += !(fabs(by) > 0) && n > 3;
            mean += by;
            frames = fmax(frames * (1 - 0.85 * fmin(fabs(by) / drift, 1)), 1);
            if (colour && by > 2 * (mean - by)) mean = quick = value, frames = 1, ++anew;
            for (int c = 0; c < (colour ? 3 : 1); ++c) NEAR(light[i][c], mean * tint[colour][c], 1e-5, "the mean");
            NEAR(colour ? kept[i][0] : light[i][2], quick, 1e-5, "the mean over three frames");
            NEAR(colour ? kept[i][1] : light[i][3], frames, 2e-3, "frames");
        }
        for (int i = 0; i < 4; ++i) glDeleteTextures(1, &t[i].texture);
    }
    CHECK(held > MANY / 4 && pulled > MANY / 4 && neither > MANY / 16 && anew > MANY / 64,
          "%d are held, %d pulled, %d neither, %d begin anew", held, pulled, neither, anew);
}

/* A nearer rectangle comes or goes, a camera passes by one that stays, or it moves by a pixel before a camera that
   trembles: of 4x4 pixels that are tested in a tile those that changed, at its depth. Depths of one surface differ by
   less than a pixel and a 500th. With motion vectors of 0 fewer than four pixels are an edge's, not a change. */
static void changes_are_counted(void)
{
    enum { TILES = SIDE / 8, LOW = TILES / 2 - 1, TALL = TILES / 2 };
    static float depth[MANY], last[MANY][4], still[MANY][2], got[TILES * TILES][4];
    const struct { int came, went, wide, high_, motion, moved; float by, depth; double low, high; } cases[] = {
        { 0, 0, 6, 6, 0, 0, 0, 9, 0, 0 },
        { 1, 0, 6, 6, 0, 0, 0, 9, 4 / 16.0, 9 / 16.0 },
        { 0, 1, 6, 6, 0, 0, 0, 9, 4 / 16.0, 9 / 16.0 },
        { 1, 0, 6, 6, 0, 0, 0, 9.915f, 4 / 16.0, 9 / 16.0 },   /* 1/16 and 0.02 */
        { 1, 0, 6, 6, 0, 0, 0, 9.92f, 0, 0 },
        { 1, 1, 6, 6, 0, 1, 0.7f, 9, 0, 0 },
        { 1, 1, 6, 6, 0, 1, 0.03f, 9, 0, 0 },                  /* its edge reached another pixel's centre */
        { 1, 1, 6, 6, 0, 1, 0.015f, 9, 0, 3 / 16.0 },          /* of x = 6, which it left, y = 0, 2 and 4 */
        { 1, 0, 2, 2, 0, 0, 0, 9, 0, 1 / 16.0 },
        { 1, 0, 2, 2, 1, 0, 0, 9, 0, 0 },
        { 1, 0, 3, 7, 0, 0, 0, 9, 3 / 16.0, 8 / 16.0 },
        { 1, 0, 3, 7, 1, 0, 0, 9, 0, 8 / 16.0 },
        { 1, 0, 6, 6, 1, 0, 0, 9, 4 / 16.0, 9 / 16.0 } };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_CHANGE_MASK,
                                 .text.dialect = SSGI_GL_DIALECT_450,
                                 .input.orthographic = 1,
                                 .input.depth = SSGI_GL_DEPTH_LINEAR,
                                 .input.motion = cases[k].motion,
                                 .input.normal = SSGI_GL_NORMAL_CUSTOM,
                                 .text.fetch = FACING };
        ssgi_gl_frame frame;
        ssgi_view view;
        if (!follows_itself(&view, &frame, 1, cases[k].by / 16)) return;
        for (int i = 0; i < MANY; ++i) {
            const int x = i % SIDE - SIDE / 2, y = i / SIDE - SIDE / 2, wide = cases[k].wide, high = cases[k].high_;
            const int is = abs(x) < wide && abs(y) < high, was = abs(x - cases[k].moved) < wide && abs(y) < high;
            const float texel[4] = { 0.5f, cases[k].went && was ? cases[k].depth : 10, 0.5f, 5 };
            depth[i] = cases[k].came && is ? cases[k].depth : 10;
            memcpy(last[i], texel, sizeof texel);
        }
        const given t[3] = { { "t_ssgi_depth", kit_texture(SIDE, SIDE, GL_R32F, depth) },
                             { "t_ssgi_history", kit_texture(SIDE, SIDE, GL_RGBA32F, last[0]) },
                             { "t_ssgi_motion", kit_texture(SIDE, SIDE, GL_RG32F, still[0]) } };
        if (!pass_drawn(got[0], 0, 4, TILES, TILES, &d, &frame, t, 2 + cases[k].motion)) return;
        const float *low = got[LOW * TILES + LOW], *high = got[TALL * TILES + TALL], *away = got[0];
        CHECK(fabs((double)low[0] - cases[k].low) + fabs((double)high[0] - cases[k].high) + (double)away[0] < 1e-6
                  && fabsf(away[1] - 10) + fabsf(away[2] - 10) + fabsf(away[3] - 10) < 1e-3f
                  && (high[0] <= 0 || fabsf(high[1] - cases[k].depth) + fabsf(high[2] - cases[k].depth) < 1e-3f),
              "case %zu: shares %g %g, away %g, depths %g %g", k, (double)low[0], (double)high[0], (double)away[0],
              (double)high[1], (double)high[2]);
        for (int i = 0; i < 3; ++i) glDeleteTextures(1, &t[i].texture);
    }
}

/* One tile changed, whole; the radius is two tiles long. Within it and a tile more a sixteenth of what lies there did,
   unless that is nearer or farther than the radius; of its own surfaces those that changed are some. Where it is six
   tiles every other one is looked at, and counts for four; where it is one, a quarter changed. */
static void changes_are_nearby(void)
{
    enum { TILES = SIDE / 8, AT = TILES / 2 };
    static float changes[TILES * TILES][4], got[TILES * TILES];
    const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_CHANGE_SHARE,
                             .text.dialect = SSGI_GL_DIALECT_450,
                             .input.orthographic = 1 };
    const struct { float radius, depth; int tiles, apart; double share; } cases[] = {
        { 1, 9.5f, 3, 1, 1 / 16.0 }, { 1, 8.9f, 0, 1, 0 }, { 1, 11.1f, 0, 1, 1 / 16.0 }, { 3, 9.5f, 7, 2, 4 / 144.0 },
        { 0.5f, 9.7f, 2, 1, 1 / 4.0 } };
    for (int k = 0; k < (int)(sizeof cases / sizeof *cases); ++k) {
        const float changed[4] = { 1, cases[k].depth, cases[k].depth, 10 };
        ssgi_gl_frame frame;
        ssgi_view view;
        if (!facing(&view, &frame, cases[k].radius)) return;
        for (int i = 0; i < TILES * TILES; ++i) changes[i][1] = changes[i][2] = changes[i][3] = 10;
        memcpy(changes[AT * TILES + AT], changed, sizeof changed);
        const given t[1] = { { "t_ssgi_change_mask", kit_texture(TILES, TILES, GL_RGBA32F, changes[0]) } };
        if (!pass_drawn(got, 0, 1, TILES, TILES, &d, &frame, t, 1)) return;
        for (int i = 0; i < TILES * TILES; ++i) {
            const int x = abs(i % TILES - AT), y = abs(i / TILES - AT);
            const int met = x <= cases[k].tiles && y <= cases[k].tiles && !((x | y) % cases[k].apart);
            NEAR(got[i], met ? cases[k].share : 0, 1e-6, "the share nearby");
        }
        glDeleteTextures(1, &t[0].texture);
    }
}

/* Where 1 to 9 of 3x3 texels are of the surface: their mean, and of values that are all alike a tenth of it times
   sqrt(few (few - 1)), few = 9 over their number. */
static void history_spreads(void)
{
    static float map[MANY][4];
    const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_HISTORY,
                             .text.dialect = SSGI_GL_DIALECT_450,
                             .input.orthographic = 1,
                             .input.normal = SSGI_GL_NORMAL_CUSTOM,
                             .text.fetch = FACING };
    ssgi_gl_frame frame;
    ssgi_view view;
    if (!facing(&view, &frame, 1)) return;
    for (int i = 0; i < MANY; ++i) {                       /* blocks of 4x4: block b holds 1 + b % 9 of the surface */
        const int x = i % SIDE % 4, y = i / SIDE % 4, block = i % SIDE / 4 + SIDE / 4 * (i / SIDE / 4),
                  place = (3 * y + x + 5) % 9;             /* the middle first */
        const int on = x < 3 && y < 3 && place <= block % 9;
        map[i][0] = on ? 0.6f : 0.1f;
        map[i][1] = on ? 10 : 50;
    }
    GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
    const int went = probe(&d, &frame, texture,
                           "ssgi_blurred c = ssgi_blurred_at(texel);"
                           "c.frames = 1.0;"
                           "ssgi_filtered f = ssgi_filter(texel, c);"
                           "float mean = f.light.x / f.light.w;"
                           "o = vec4(mean, ssgi_deviation(f, mean), 0.0, 0.0);");
    glDeleteTextures(1, &texture);
    for (int i = 0; went && i < MANY; ++i) {
        const double few = 9.0 / (1 + (i % SIDE / 4 + SIDE / 4 * (i / SIDE / 4)) % 9);
        if (i % SIDE % 4 != 1 || i / SIDE % 4 != 1) continue;
        NEAR(out[i][0], 0.6, 1e-6, "the mean");
        NEAR(out[i][1], 0.06 * sqrt(few * (few - 1)), 1e-3, "the deviation");
    }
}

/* A filter from half size of a plane that faces an orthographic camera, 10 away. */
static ssgi_gl_desc from_half_size(ssgi_gl_pass pass, int radius)
{
    return (ssgi_gl_desc) { .pass = pass,
                            .text.dialect = SSGI_GL_DIALECT_450,
                            .input.orthographic = 1,
                            .gather.half = 1,
                            .filter.radius = radius,
                            .input.depth = SSGI_GL_DEPTH_CUSTOM,
                            .input.normal = SSGI_GL_NORMAL_CUSTOM,
                            .text.fetch = FACING
                            "float ssgi_custom_depth(ivec2 texel, int layer) { return 10.0; }\n" };
}

/* Of half size 4x4 texels are averaged by tents of two and a half of them, the less the farther they are off the plane
   and the more frames there are; where five are averaged, the four next to a pixel by steeper ones. Their weights fall
   off: all of them count as 7. */
static void history_spreads_half_size(void)
{
    static float map[MANY][4];
    const ssgi_gl_desc d = from_half_size(SSGI_GL_PASS_HISTORY, 0);
    ssgi_gl_frame frame;
    ssgi_view view;
    if (!facing(&view, &frame, 1)) return;
    t_seed(71);
    for (int i = 0; i < MANY; ++i) {                       /* off by up to half of a 100th of the radius and a pixel */
        map[i][0] = t_uniform(0.4f, 0.6f);
        map[i][1] = 10 + t_uniform(0, 0.5f) * (0.01f + 1.0f / 16) * (float)(i & 1);
    }
    GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
    for (int frames = 1; frames < 16; frames += 5) {
        char statements[300];
        snprintf(statements, sizeof statements,
                 "ssgi_blurred c = ssgi_blurred_at(texel); c.frames = %d.0;"
                 "ssgi_filtered f = ssgi_filter(texel, c); float mean = f.light.x / f.light.w;"
                 "o = vec4(mean, ssgi_deviation(f, mean), 0.0, 0.0);", frames);
        if (!probe(&d, &frame, texture, statements)) break;
        for (int i = 0; i < MANY; ++i) {
            const int x = i % SIDE, y = i / SIDE;
            double weights = 0, both = 0, sum = 0, squares = 0;
            if (x < 4 || y < 4 || x >= SIDE - 4 || y >= SIDE - 4) continue;
            for (int k = 0; k < 16; ++k) {
                const int h[2] = { x / 2 + k % 4 - 2 + (x & 1), y / 2 + k / 4 - 2 + (y & 1) }, settled = frames > 4;
                const int beside = k % 4 % 3 && k / 4 % 3;
                const double tent = (5 - abs(2 * h[0] - x)) * (5 - abs(2 * h[1] - y)),
                             value = (double)map[h[1] * SIDE + h[0]][0],
                             off = ((double)map[h[1] * SIDE + h[0]][1] - 10) / (0.01 + 1.0 / 16),
                             weight = (settled ? beside * (12 + tent) : 1) * tent / (0.3 / frames + off * off);
                weights += weight, both += weight * weight;
                sum += weight * value, squares += weight * value * value;
            }
            const double mean = sum / weights, share = both / (weights * weights), few = 7 * share,
                         variance = (squares / weights - mean * mean) / fmax(1 - share, 0.2);
            NEAR(out[i][0], mean, 1e-5, "the mean");
            NEAR(out[i][1], sqrt((variance + 0.01 * mean * mean * fmax(few - 1, 0)) * few), 1e-4, "the deviation");
        }
    }
    glDeleteTextures(1, &texture);
}

/* From half size blur averages 3x3 texels by tents of 4 pixels, and 5x5 without their corners by tents of 5.5. */
static void blur_spreads_half_size(void)
{
    static float map[MANY][4];
    ssgi_gl_frame frame;
    ssgi_view view;
    if (!facing(&view, &frame, 1)) return;
    t_seed(73);
    for (int i = 0; i < MANY; ++i) {
        map[i][0] = t_uniform(0, 1);
        map[i][1] = 10 + t_uniform(0, 2) * (0.01f + 1.0f / 16) * (float)(i & 1);
    }
    GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]);
    for (int radius = 1; radius <= 2; ++radius) {
        const ssgi_gl_desc d = from_half_size(SSGI_GL_PASS_BLUR, radius);
        if (!probe(&d, &frame, texture, "ssgi_blurred c = ssgi_blurred_at(texel); ssgi_filtered f = "
                                        "ssgi_filter(texel, c); o = vec4(f.light.x / f.light.w);"))
            break;
        for (int i = 0; i < MANY; ++i) {
            const int x = i % SIDE, y = i / SIDE;
            double weights = 0, sum = 0;
            for (int k = 0; k < 25; ++k) {
                const int o[2] = { k % 5 - 2, k / 5 - 2 }, h[2] = { x / 2 + o[0], y / 2 + o[1] };
                const double most = 2.5 + 1.5 * radius,
                             tent[2] = { most - abs(2 * h[0] - x), most - abs(2 * h[1] - y) };
                if (abs(o[0]) > radius || abs(o[1]) > radius || abs(o[0]) + abs(o[1]) == 4) continue;
                if (h[0] < 0 || h[1] < 0 || 2 * h[0] >= SIDE || 2 * h[1] >= SIDE) continue;
                const float *const at = map[h[1] * SIDE + h[0]];
                const double off = ((double)at[1] - 10) / (0.01 + 1.0 / 16),
                             weight = tent[0] * tent[1] / (0.1 + off * off);
                weights += weight, sum += weight * (double)at[0];
            }
            NEAR(out[i][0], sum / weights, 1e-5, "the mean");
        }
    }
    glDeleteTextures(1, &texture);
}

/* Of half size each of the four pixels is drawn in turn, as often as the others, whatever its directions; texels beyond
   the image stay beyond. */
static void pixels_take_turns(void)
{
    const ssgi_gl_desc d = {
        .pass = SSGI_GL_PASS_HSAO, .gather.half = 2, .text.dialect = SSGI_GL_DIALECT_450, .input.orthographic = 1
    };
    int drawn[4][4] = { { 0 } };
    for (uint32_t k = 0; k < 64; ++k) {
        ssgi_gl_frame frame;
        ssgi_view view;
        if (!facing(&view, &frame, 1)) return;
        frame.phase = ssgi_gl_phase(k);
        GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, NULL);
        const int went = probe(&d, &frame, texture,
                               "o = vec4(ssgi_gathered(ivec2(4, 6)), ssgi_gathered(ivec2(1000)));");
        glDeleteTextures(1, &texture);
        if (!went) return;
        const int turn = (int)out[0][0] - 8 + 2 * ((int)out[0][1] - 12);
        if (!CHECK(turn >= 0 && turn < 4 && (int)out[0][2] >= 2000, "frame %u: %g %g", k, (double)out[0][0],
                   (double)out[0][1]))
            return;
        ++drawn[turn][(int)(frame.phase * 4)];
    }
    for (int i = 0; i < 4; ++i) {
        const int *of = drawn[i];
        CHECK(of[0] + of[1] + of[2] + of[3] == 16 && of[0] > 2 && of[1] > 2 && of[2] > 2 && of[3] > 2,
              "pixel %d: %d %d %d %d of 64 frames by quarters of the phase", i, of[0], of[1], of[2], of[3]);
    }
}

/* Of quarter size sixteen frames draw each pixel of a 4x4 once, any four in a row one of each 2x2 of it. The texel 0, 0
   of a filter is that of the nearest pixel that is gathered. */
static void quarters(void)
{
    static const char *const statement =
        "ivec2 p = ivec2(a.xy); ssgi_neighbour t = ssgi_neighbour_at(p, 0, 0), s = ssgi_neighbour_at(p, -1, 1);"
        " o = texel.x % 2 == 0 ? vec4(t.at, t.q) : vec4(t.o, s.q - t.q);";
    for (int turns = 0; turns < 2; ++turns) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_BLUR, .text.dialect = SSGI_GL_DIALECT_450,
                                 .gather.half = turns ? SSGI_GL_HALF_QUARTER_IN_TURN : SSGI_GL_HALF_QUARTER };
        int met[16] = { 0 }, quadrant[32] = { 0 };
        ssgi_gl_frame frame;
        ssgi_view view;
        if (!facing(&view, &frame, 1)) return;
        for (uint32_t k = 0; k < (turns ? 32 : 1); ++k) {
            GLuint texture = kit_texture(SIDE, SIDE, GL_RGBA32F, NULL);
            frame.phase = ssgi_gl_phase(k + 3);
            for (int i = 0; i < MANY; ++i) in[i][0] = (float)(20 + i / 2 % 8), in[i][1] = (float)(20 + i / 16 % 8);
            const int went = probe(&d, &frame, texture, statement);
            glDeleteTextures(1, &texture);
            if (!went) return;
            for (int i = 0; i < MANY / 2; ++i) {
                const float *of = out[2 * i], *rest = out[2 * i + 1];
                const int x = (int)(of[2] - 4 * of[0]), y = (int)(of[3] - 4 * of[1]); /* of its 4x4 */
                if (!CHECK(x >= 0 && x < 4 && y >= 0 && y < 4 && (turns || (!x && !y)) && fabsf(rest[0]) < 2.5f
                               && fabsf(rest[1]) < 2.5f && fabsf(in[2 * i][0] + rest[0] - of[2]) < 0.1f
                               && fabsf(in[2 * i][1] + rest[1] - of[3]) < 0.1f && fabsf(rest[2] + 4) < 0.1f
                               && fabsf(rest[3] - 4) < 0.1f,
                           "frame %u, pixel %g %g: texel %g %g of pixel %g %g, %g %g away", k, (double)in[2 * i][0],
                           (double)in[2 * i][1], (double)of[0], (double)of[1], (double)of[2], (double)of[3],
                           (double)rest[0], (double)rest[1]))
                    return;
                if (!i) ++met[4 * y + x], quadrant[k] = x / 2 + 2 * (y / 2);
            }
        }
        for (int i = 0; i < 16 && turns; ++i) CHECK(met[i] == 2, "pixel %d of 4x4: %d of 32 frames", i, met[i]);
        for (int k = 0; k + 4 <= 32 && turns; ++k)
            CHECK((1 << quadrant[k] | 1 << quadrant[k + 1] | 1 << quadrant[k + 2] | 1 << quadrant[k + 3]) == 15,
                  "frames %d to %d leave a 2x2 out", k, k + 3);
    }
}

/* ---- >>light of a frame ------------------------------------------------------------------------------------------ */

static void frame_light(void)
{
    static const struct { const char *start; int frame, coefficients, bands;
    } bad[] = { { "frame:", 0, 1, 3 },
                { "coefficients:", 1, 0, 3 },
                { "bands:", 1, 1, 0 },
                { "bands:", 1, 1, 5 },
                { "bands:", 1, 1, -1 } };
    ssgi_gl_frame frame, was;
    float c[48], turned[48], m[16], odd[16];
    const char *why = "";
    memset(&was, 0x5a, sizeof was);
    t_seed(15);
    for (int i = 0; i < 64; ++i) {
        const int bands = 1 + i % 4, matrix = i & 4;
        rigid(m);
        for (int k = 0; k < 48; ++k) c[k] = t_uniform(-1, 1);
        memset(turned, 0, sizeof turned);
        ssgi_sh_rotate(turned, bands, c, 3, matrix ? m : NULL);
        frame = was;
        CHECK(ssgi_gl_harmonics_set(&frame, c, bands, matrix ? m : NULL, &why) == SSGI_OK, "%s", why);
        for (int k = 0; k < 48; ++k)
            CHECK(fabsf(frame.harmonics[12 * (k / 12) + 4 * (k % 3) + k / 3 % 4] - turned[k]) <= 1e-6f,
                  "%d bands: coefficient %d, channel %d", bands, k / 3, k % 3);
        memcpy(frame.harmonics, was.harmonics, sizeof was.harmonics);
        CHECK(!memcmp(&frame, &was, sizeof was), "other members were written to");
    }
    for (size_t i = 0; i < sizeof bad / sizeof bad[0]; ++i)
        CHECK(ssgi_gl_harmonics_set(bad[i].frame ? &frame : NULL, bad[i].coefficients ? c : NULL, bad[i].bands, m, &why)
                      == SSGI_BAD_ARGUMENT
                  && NAMES(why, bad[i].start) && !memcmp(&frame, &was, sizeof was),
              "%s \"%s\", or the frame was written to", bad[i].start, why);
    for (int i = 0; i < NOT_RIGID; ++i) {
        not_rigid(odd, i);
        CHECK(ssgi_gl_harmonics_set(&frame, c, 3, odd, &why) == SSGI_BAD_ARGUMENT && NAMES(why, "world_to_view:")
                  && !memcmp(&frame, &was, sizeof was),
              "matrix %d that is not rigid: \"%s\", or the frame was written to", i, why);
    }
}

void test_twins(void)
{
    kit_error err = { "" };
    RUN("extra cameras and shadow maps see what ssgi_view_project says, and lead back", cameras);
    RUN("cameras that are wrong are named, and nothing is written", refused_cameras);
    RUN("a frame's light is the world's, turned, word by word; what is wrong is named, and nothing is written",
        frame_light);
    RUN("any few frames' phases spread as multiples of the golden ratio do, in every quarter", phases_spread);
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("depth, position, projection, footprint and offset as in C", twin_views);
    RUN("noise and kernel as in C", twin_noise_and_kernel);
    RUN("normals of every encoding and frame come back", twin_normals);
    RUN("what emitters pack comes back, as its format says", twin_emitters);
    RUN("an extra camera's points and the octahedral map as in C", twin_views_of_others);
    RUN("harmonics of one to four bands in both languages as in C", twin_harmonics);
    RUN("reflections as in C", twin_reflections);
    RUN("a quarter of the size: the nearest pixel of those that are gathered, each in its turn", quarters);
    RUN("halves, where the language has them and where it has not", twin_halves);
    RUN("functions of numbers are what their comments say", functions_of_numbers);
    RUN("a slice's arc is the integral that it says", twin_arc);
    RUN("sectors are covered once, by the nearest; on the mean as much as intervals are", twin_sectors);
    RUN("slabs are as deep as their back faces say; sheets and open things by the thickness", twin_deep);
    RUN("a slice leaves out taps below 0.004 over the plane, and beyond the normal below 0.4", slices_limits);
    RUN("taps are joined up to a slope of four, whatever the walk's length", steep_taps_are_not_joined);
    RUN("the back of a tap lies on its own ray, as deep as it is thick", backs_lie_on_their_rays);
    RUN("what is beyond the radius, or begins behind the plane, covers nothing, however deep", what_covers_nothing);
    RUN("the walk by linear forms is that by vectors, whatever the thickness, with perspective and without",
        walks_by_vectors);
    RUN("before a shadow map's surface it is lit for as far as depths are rounded", shadow_slack);
    RUN("a shadow map's bias as in C, up to the largest slope", shadow_bias);
    RUN("of lights each row is visited once, whatever a sun says of its maps and the frame of their number",
        rows_are_visited_once);
    RUN("an extra camera knows what is open two pixels before its surfaces", view_slack);
    RUN("smooth averages 2^l pixels, whose ends share a weight", smooth_weights);
    RUN("the Gaussian filter has its radius' deviation", gaussian_weights);
    RUN("of an emitter's unseen side counts 0.35, edge-on nothing, of a second slab half", unseen_sides);
    RUN("several points over a disc stand in the middles of equal rings", points_over_a_disc);
    RUN("slices see surfels within two radii of the picture's depth, and have the near share of them",
        slices_see_surfels);
    RUN("a sphere's bounds in the picture as in C, before and across the near depth", twin_spheres);
    RUN("a triangle's parts are as many as in C, about the near plane, too", twin_parts);
    RUN("levels, counts, radii and shrunk corners of triangles are those of C", twin_tessellation);
    RUN("what the last frame knows lies between four texels of its plane", history_lies_between);
    RUN("frames are counted on where the surface was seen, the fewer the more of what is nearby changed",
        history_counts_on);
    RUN("the last frame's plane is known up to half a pixel and a thousandth of the depth, and as far as things moved",
        history_keeps_its_plane);
    RUN("a mean over three frames tells change: that over all follows it and forgets", history_follows);
    RUN("an occluder that came or went is counted in tiles; a camera that moves, and edges, are not",
        changes_are_counted);
    RUN("changes are nearby within the radius, in the picture and in depth", changes_are_nearby);
    RUN("the fewer texels a surface has, the farther its mean may be off", history_spreads);
    RUN("from half size texels count by tents and planes, of radius 2 without the corners", blur_spreads_half_size);
    RUN("of half size texels count by tents and planes, and a pixel's four neighbours more where frames are averaged",
        history_spreads_half_size);
    RUN("of half size each pixel of four is drawn in turn", pixels_take_turns);
    kit_gl_close();
}
