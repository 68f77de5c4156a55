/* test_twins.c - functions of the emitted GLSL, drawn by the CPU, against the same in C; data that C writes for GLSL:
   extra cameras, those of shadow maps, a frame's light; and weights and limits of the GLSL without a formula, by cases
   worked out by hand. */
#include "own.h"
#include "frames.h"
#include "kit/kit_gl.h"

#include <limits.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

enum { TEXT = 1 << 16, SIDE = 64, MANY = SIDE * SIDE, CENTRE = SIDE / 2 * SIDE + SIDE / 2 };
static const double pi = 3.14159265358979;
static const float still[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };

/* The camera of a probe. */
static ssgi_view view;

/* ---- >>cameras: extra ones and those of shadow maps -------------------------------------------------------------- */

/* Makes a rotation that takes +z to a direction at an angle from it, between two rotations about z: the quaternion of
   sin(angle/2) at one azimuth and cos(angle/2) at another. */
static void rotation(float m[16], double angle, double a, double b)
{
    const double x = sin(angle / 2) * cos(a), y = sin(angle / 2) * sin(a), z = cos(angle / 2) * sin(b),
                 w = cos(angle / 2) * cos(b);
    const double turn[16] = { 1 - 2 * (y * y + z * z), 2 * (x * y + z * w),     2 * (z * x - y * w),     0,
                              2 * (x * y - z * w),     1 - 2 * (z * z + x * x), 2 * (y * z + x * w),     0,
                              2 * (z * x + y * w),     2 * (y * z - x * w),     1 - 2 * (x * x + y * y), 0,
                              0,                       0,                       0,                       1 };
    for (int i = 0; i < 16; ++i) m[i] = (float)turn[i];
}

/* A random rigid matrix. */
static void rigid(float m[16])
{
    rotation(m, (double)t_uniform(0, 3.14f), (double)t_uniform(0, 6.28f), (double)t_uniform(0, 6.28f));
    for (int k = 0; k < 3; ++k) m[12 + k] = t_uniform(-9, 9);
}

/* Returns row r of a matrix times a point. lost: the allowed error, as a matrix of floats is not quite rigid. */
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

/* Makes an off-centre camera of 640 x 480 with any projection that a view decodes. starts: the view depth of an
   orthographic near plane, which may be behind the eye. */
static int any_view(int ortho, float starts)
{
    const float x = t_uniform(-0.3f, 0.3f), y = t_uniform(-0.3f, 0.3f), wide = t_uniform(0.5f, 3),
                high = t_uniform(-3, -0.5f);
    const float m[2][16] = { { wide, 0, 0, 0, 0, high, 0, 0, x, y, -1.002f, -1, 0, 0, -0.2f, 0 },
                             { wide, 0, 0, 0, 0, high, 0, 0, 0, 0, -0.02f, 0, x, y,
                               -1 - 0.02f * starts, 1 } };
    const char *why = "";
    return CHECK(ssgi_view_from_projection(&view, m[ortho], SSGI_CLIP_GL, 640, 480, &why) == SSGI_OK, "%s", why);
}

static void cameras(void)
{
    enum { TRIES = 4000 };
    double worst[2] = { 0, 0 };
    t_seed(5);
    for (int i = 0; i < TRIES; ++i) {
        const int ortho = i & 1, slot = i / 2 % 4;
        float picture[16], other[16], seen[3];
        ssgi_gl_views v, was;
        ssgi_gl_light light, bare;
        const char *why = "";
        double p[4] = { (double)t_uniform(-5, 5), (double)t_uniform(-5, 5), -(double)t_uniform(0.2f, 30), 1 },
               q[4] = { 0, 0, 0, 1 }, lost, at[4] = { 0, 0, 0, 1 };
        const float spot[3] = { (float)p[0], (float)p[1], (float)p[2] };
        const float starts = ortho && i % 3 == 0 ? -50.0f : 0.0f;
        if (!any_view(ortho, starts)) return;
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
        /* matrices from the other camera's space to the world, and to the picture's camera */
        for (int k = 0; k < 3; ++k)
            for (int c = 0; c < 3; ++c) at[k] += (double)other[4 * k + c] * (p[c] - (double)other[12 + c]);
        for (int k = 0; k < 3; ++k) q[k] = product_of(picture, k, at, &lost);
        ssgi_view_project(seen, &view, spot);
        /* the shaders' space begins a pixel's width in front of a near plane behind the eye */
        const double begins = starts < 0 ? (double)starts - (double)ssgi_pixel_footprint(&view, 1) : 0;
        for (int k = 0; k < 3; ++k) at[k] = (double)seen[k] * (ortho || k == 2 ? 1 : -p[2]) - (k == 2 ? begins : 0);
        for (int k = 0; k < 6; ++k) {                      /* there, and back */
            const int back = k / 3, row = k % 3;
            const double want = back ? q[row] : at[row],
                         got = product_of(back ? v.from[slot] : v.to[slot], row, back ? at : q, &lost),
                         off = fabs(got - want) / (lost + 4e-7 * fabs(want) - 1e-6 * begins);
            CHECK(off <= 1, "%s, %s, row %d: %.9g, ssgi_view_project says %.9g", back ? "from" : "to",
                  ortho ? "orthographic" : "perspective", row, got, want);
            worst[back] = fmax(worst[back], off);
            for (int c = 0; c < 4; ++c)
                CHECK(light.map[row][c] == v.to[slot][4 * c + row],
                      "a light's map and an extra camera differ in row %d", row);
        }
        const float decode[4] = { starts < 0 ? v.decode[slot][0] : view.depth[0], view.depth[1], view.clear,
                                  (float)ortho },
                    tile[4] = { 7, 9, 640, 480 };
        CHECK(!memcmp(decode, v.decode[slot], sizeof decode) && !memcmp(decode, light.decode, sizeof decode)
              && !memcmp(tile, light.tile, sizeof tile) && v.size[slot][0] == 640 && v.size[slot][1] == 480,
              "decode, size or tile of %s", ortho ? "orthographic" : "perspective");
        CHECK(fabs((double)v.decode[slot][0] - ((double)view.depth[0] - begins)) <= 2e-5,
              "the near plane is at %g", (double)v.decode[slot][0]);
        CHECK(light.patch == ssgi_pixel_footprint(&view, 1) && !memcmp(&light, &bare, offsetof(ssgi_gl_light, patch)),
              "a light's patch, or members that the map must not set");
        memcpy(was.to[slot], v.to[slot], sizeof was.to[slot]);
        memcpy(was.from[slot], v.from[slot], sizeof was.from[slot]);
        memcpy(was.decode[slot], v.decode[slot], sizeof was.decode[slot]);
        memcpy(was.size[slot], v.size[slot], sizeof was.size[slot]);
        CHECK(!memcmp(&was, &v, sizeof v), "camera %d wrote to another's place", slot);
    }
    t_note("share of the loss that rounding allows, at most: %.2f there, %.2f back", worst[0], worst[1]);
}

static void frame_light(void)
{
    ssgi_gl_frame frame, was;
    float c[48], turned[48], m[16];
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
}

/* Checks that each four frames halve the circle and then its halves; the next four are ahead by a quarter of 1 + the
   golden ratio's fraction g. So each quarter has multiples of g, whose largest gap is a power of g for a Fibonacci
   number of them. */
static void phases_spread(void)
{
    const double golden = 0.5 * (sqrt(5) - 1), bits = 16777216;
    for (uint32_t k = 0; k < 1024; ++k) {
        const double phase = (double)ssgi_gl_phase(k), halved = (double)(k & 1) / 2 + (double)(k >> 1 & 1) / 4,
                     off = phase - halved - (double)(k >> 2) * (1 + golden) / 4;
        CHECK(phase >= 0 && phase < 1 && fabs(off - nearbyint(off)) < 17 / bits,
              "phase %.8f of frame %u is off by %.8f", phase, k, off - nearbyint(off));
        CHECK(((uint32_t)(phase * bits) & 15) == (k & 15), "frame %u: the last bits tell another pixel", k);
    }
}

/* ---- >>probes: statements in a pass's text, and passes ----------------------------------------------------------- */

static float in[MANY][4], out[MANY][4], map[MANY][4];
static float *const ins = &in[0][0], *const outs = &out[0][0];    /* the probes' in and out as arrays of floats */

/* Inputs of probes besides in and map: extra cameras; for the next probe only, layers of an array, pass thickness. */
static ssgi_gl_views probed;
static struct { const void *texels; int count; GLenum format; GLuint made; } probed_layers;
static const uint32_t (*probed_width)[4];

static void layers_of(const void *texels, int count, GLenum format)
{
    probed_layers.texels = texels;
    probed_layers.count = count;
    probed_layers.format = format;
}

#define NEAR(got, want, within, what) \
    CHECK(fabs((double)(got) - (double)(want)) <= (double)(within), "%s at %d: %.9g, in C %.9g", what, i, \
          (double)(got), (double)(want))

static GLuint texture_of(int width, int height, int layers, GLenum format, const void *data)
{
    return layers ? kit_texture_array(width, height, layers, format, data) : kit_texture(width, height, format, data);
}

/* Returns a desc of a pass, with fields in words, as behind a method's name: "samples=2,depth=linear". */
static ssgi_gl_desc desc_of(const char *pass, const char *words)
{
    char both[200];
    snprintf(both, sizeof both, "%s,dialect=450,%s", pass, words);
    return desc_in(both);
}

/* Returns the same desc, with surfaces that face the viewer. */
static ssgi_gl_desc facing_of(const char *pass, const char *words)
{
    ssgi_gl_desc d = desc_of(pass, words);
    d.input.orthographic = 1;
    d.input.normal = SSGI_GL_NORMAL_CUSTOM;
    d.shader.fetch = "vec3 ssgi_custom_normal(ivec2 texel) { return vec3(0.0, 0.0, 1.0); }\n"
                   "float ssgi_custom_depth(ivec2 texel, int layer) { return 10.0; }\n";
    return d;
}

/* Draws a program's output number output as floats. The caller binds the textures; this binds the blocks. */
static int draw(float *result, GLuint program, int output, int components, int width, int height,
                const ssgi_gl_frame *frame)
{
    const GLenum to = GL_COLOR_ATTACHMENT0 + (GLenum)output;
    GLenum buffers[8] = { GL_NONE, GL_NONE, GL_NONE, GL_NONE, GL_NONE, GL_NONE, GL_NONE, GL_NONE };
    GLuint block[2], framebuffer, target = kit_texture(width, height, components == 1 ? GL_R32F : GL_RGBA32F, NULL);
    glGenBuffers(2, block);
    for (GLuint b = 0; b < 2; ++b) {
        glBindBuffer(GL_UNIFORM_BUFFER, block[b]);
        glBufferData(GL_UNIFORM_BUFFER, b ? (GLsizeiptr)sizeof probed : (GLsizeiptr)sizeof *frame,
                     b ? (const void *)&probed : frame, GL_STATIC_DRAW);
        glBindBufferBase(GL_UNIFORM_BUFFER, b, block[b]);
    }
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, to, GL_TEXTURE_2D, target, 0);
    buffers[output] = to;
    glDrawBuffers(1 + output, buffers);
    glViewport(0, 0, width, height);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    const int read = kit_texture_read(target, width, height, components, result);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &target);
    glDeleteBuffers(2, block);
    return CHECK(!read, "the drawn texels cannot be read");
}

/* Replaces the main function of a shader by statements that make o from in, and draws it to out. X(k): texel k of the
   pixel's four of in, a: its own; Y(k): the same of map, which also is every texture of the shader if `mapped`. */
static int probe_text(char *text, int dialect, const ssgi_gl_frame *frame, int mapped, const char *statements)
{
    static const GLenum stages[2] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER };
    static const char *const ends[] = { "void main", "flat in", "flat out", "layout(vertices" };
    static char triangle[TEXT];
    const ssgi_gl_desc plain = { .shader.dialect = dialect };
    const char *const source[2] = { triangle, text };
    kit_error err = { "" };
    for (size_t i = 0; i < sizeof ends / sizeof *ends; ++i) {
        char *const end = strstr(text, ends[i]);
        if (end) *end = 0;
    }
    const size_t n = strlen(text);
    snprintf(text + n, TEXT - n,
             "layout(location = 7) out highp vec4 o;\nuniform highp sampler2D t_in, t_maps;\n"
             "#define AT(t, k) texelFetch(t, ivec2((texel.x & ~3) + (k), texel.y), 0)\n#define X(k) AT(t_in, "
             "k)\n#define Y(k) AT(t_maps, k)\n"
             "void main()\n{\n    ivec2 texel = ivec2(gl_FragCoord.xy);\n    vec4 a = X(texel.x & 3);\n    %s\n}\n",
             statements);
    ssgi_gl_emit(triangle, TEXT, &plain, SSGI_GL_STAGE_VERTEX);
    const GLuint program = kit_program(source, stages, 2, &err);
    if (!CHECK(program, "%s: %s", statements, err.text)) return 0;
    const GLuint input = kit_texture(SIDE, SIDE, GL_RGBA32F, in[0]),
                 maps = mapped ? kit_texture(SIDE, SIDE, GL_RGBA32F, map[0]) : 0,
                 width = probed_width ? texture_of(SIDE / 2, SIDE / 2, 0, GL_RGBA32UI, probed_width) : 0,
                 layers = probed_layers.count ? texture_of(SIDE, SIDE, probed_layers.count, probed_layers.format,
                                                           probed_layers.texels)
                                              : probed_layers.made,
                 made[4] = { input, maps, width, layers };
    for (GLenum unit = 0; unit < 16; ++unit) {
        glActiveTexture(GL_TEXTURE0 + unit);
        glBindTexture(GL_TEXTURE_2D, unit == 15 ? input : unit == 2 && width ? width : maps);
        glBindTexture(GL_TEXTURE_2D_ARRAY, layers);
    }
    glUseProgram(program);
    glUniform1i(glGetUniformLocation(program, "t_in"), 15);
    glUniform1i(glGetUniformLocation(program, "t_maps"), 14);
    glUniform1i(glGetUniformLocation(program, "t_ssgi_fields"), 4); /* functions alone have no bindings */
    const int went = draw(out[0], program, 7, 4, SIDE, SIDE, frame);
    glDeleteTextures(4, made);
    glDeleteProgram(program);
    memset(&probed_layers, 0, sizeof probed_layers);
    probed_width = NULL;
    return went;
}

static int probe_stage(const ssgi_gl_desc *d, int stage, const ssgi_gl_frame *frame, int mapped, const char *statements)
{
    static char text[TEXT];
    const size_t n = ssgi_gl_emit(text, TEXT, d, stage);
    return CHECK(n && n < TEXT, "%s: a text of %zu characters", ssgi_gl_pass_name(d->pass), n)
           && probe_text(text, d->shader.dialect, frame, mapped, statements);
}

/* Probes the fragment stage, with map; probe: without it. */
static int probe_map(const ssgi_gl_desc *d, const ssgi_gl_frame *frame, const char *statements)
{
    return probe_stage(d, SSGI_GL_STAGE_FRAGMENT, frame, 1, statements);
}

static int probe(const ssgi_gl_desc *d, const ssgi_gl_frame *frame, const char *statements)
{
    return probe_stage(d, SSGI_GL_STAGE_FRAGMENT, frame, 0, statements);
}

/* A texture for a pass: floats, or bits of integers; layers 0: no array. */
typedef struct given { const char *name; GLenum format; int width, height, layers; const void *texels; } given;

/* Draws a pass, and reads one of its outputs as floats. */
static int pass_drawn(float *result, int output, int components, int width, int height, const ssgi_gl_desc *d,
                      const ssgi_gl_frame *frame, const given *textures, int count)
{
    kit_error err = { "" };
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    const uint64_t key = ssgi_gl_key(d);
    const GLuint kept = kit_program_kept(key), program = kept ? kept : kit_pass_program(d, &err);
    GLuint made[8];
    int given_ = 0;
    if (!CHECK(program && (kept || !kit_program_keep(key, program, &err)), "%s", err.text)) return 0;
    for (int i = 0; i < count; ++i)
        made[i] = texture_of(textures[i].width, textures[i].height, textures[i].layers, textures[i].format,
                             textures[i].texels);
    for (int i = 0, rows = ssgi_gl_reflect(d, row, SSGI_GL_MAX_IO); i < rows; ++i)
        for (int k = 0; k < count && row[i].kind == SSGI_GL_IO_TEXTURE; ++k)
            if (!strcmp(row[i].name, textures[k].name)) {
                glActiveTexture(GL_TEXTURE0 + (GLenum)row[i].slot);
                glBindTexture(textures[k].layers ? GL_TEXTURE_2D_ARRAY : GL_TEXTURE_2D, made[k]);
                ++given_;
            }
    const int went = draw(result, program, output, components, width, height, frame);
    glDeleteTextures(count, made);
    return went && CHECK(given_ == count, "%s: %d of %d textures are its own", ssgi_gl_pass_name(d->pass), given_,
                         count);
}

/* Sets the camera of probes, and returns its frame. */
static ssgi_gl_frame seen_by(const float m[16], int clip, int width, int height, float radius)
{
    const char *why = "";
    ssgi_gl_frame frame;
    memset(&frame, 0, sizeof frame);
    CHECK(ssgi_view_from_projection(&view, m, clip, width, height, &why) == SSGI_OK
              && ssgi_gl_frame_init(&frame, &view, radius, &why) == SSGI_OK,
          "%s", why);
    return frame;
}

/* returns a frame: orthographic, 64 x 64 pixels, 16 a unit */
static ssgi_gl_frame facing(float radius)
{
    static const float m[16] = { 0.5f, 0, 0, 0, 0, 0.5f, 0, 0, 0, 0, -0.02f, 0, 0, 0, -1, 1 };
    return seen_by(m, SSGI_CLIP_GL, SIDE, SIDE, radius);
}

/* Returns a frame off-centre and upside down, perspective or orthographic, 640 x 480. */
static ssgi_gl_frame off_centre(int ortho)
{
    static const float m[2][16] = { { 1, 0, 0, 0, 0, -1.5f, 0, 0, 0.1f, 0.2f, -1.002002f, -1, 0, 0, -0.2002002f, 0 },
                                    { 0.5f, 0, 0, 0, 0, 0.7f, 0, 0, 0, 0, -0.02f, 0, 0.1f, -0.2f, -1, 1 } };
    return seen_by(m[ortho], SSGI_CLIP_GL, 640, 480, 1);
}

/* ---- >>twins: GLSL against C ------------------------------------------------------------------------------------- */

/* perspective: GL, reversed, reversed infinite, GL infinite, of a tiny scene; orthographic: GL, reversed */
static void twin_views(void)
{
    enum { LAYOUTS = 6 };
    static const float special[] = { 0, 1, NAN, INFINITY, -INFINITY, 1e38f, -1e38f };
    enum { SPECIAL = (int)(sizeof special / sizeof *special) };
    for (int k = 0; k < LAYOUTS; ++k) {
        const double n = k == 3 ? 1e-9 : 0.1, f = 1000; /* planes */
        const double z[LAYOUTS][2] = {
            { -(f + n) / (f - n), -2 * f * n / (f - n) }, { n / (f - n), f * n / (f - n) }, { 0, n }, { -1, -2 * n },
            { -2 / (f - n), -(f + n) / (f - n) },         { 1 / (f - n), f / (f - n) }
        };
        const float high = k & 1 ? -2.1f : 2.1f, a = (float)z[k][0], b = (float)z[k][1];
        const float m[2][16] = { { 1.3f, 0, 0, 0, 0, high, 0, 0, 0.07f, -0.03f, a, -1, 0, 0, b, 0 },
                                 { 1.3f, 0, 0, 0, 0, high, 0, 0, 0, 0, a, 0, 0.07f, -0.03f, b, 1 } };
        const int ortho = k >= 4, clip = k == 1 || k == 2 || k == 5 ? SSGI_CLIP_ZERO : SSGI_CLIP_GL;
        ssgi_gl_desc d = desc_of("ssao", ""), mapped = desc_of("lights", "shadow=map");
        d.input.orthographic = mapped.input.orthographic = ortho;
        ssgi_gl_frame frame = seen_by(m[ortho], clip, 1280, 720, 1);
        frame.offset = 1;
        for (int i = 0; i < MANY; ++i) {                  /* columns of in: window depth; a pixel; view depth */
            const float values[4] = { i < SPECIAL ? special[i]
                                      : i & 1     ? t_uniform(0, 1)
                                                  : 1 - powf(10, t_uniform(-7, 0)),
                                      t_uniform(-50, 1330), t_uniform(-50, 770), expf(t_uniform(-4, 7)) };
            memcpy(in[i], values, sizeof values);
        }
        if (!probe(&d, &frame, "o = vec4(ssgi_window_depth(a.x), ssgi_position(a.yz, a.w));")) break;
        for (int i = 0; i < MANY; ++i) {
            const double depth = (double)ssgi_view_depth(&view, in[i][0]), scale = ortho ? 1 : (double)in[i][3];
            /* lost: the rounding of the terms of the depth's sum */
            const double lost = 1.2e-7 * (fabs((double)view.depth[0]) + fabs((double)view.depth[1]));
            float p[3];
            ssgi_view_position(p, &view, in[i][1], in[i][2], in[i][3]);
            if (depth >= 1e17)
                CHECK(out[i][0] >= 1e17f, "ssgi_window_depth(%.9g), layout %d: %g, in C %g", (double)in[i][0], k,
                      (double)out[i][0], depth);
            else
                NEAR(out[i][0], depth, ortho ? lost : depth * (3e-7 + depth * lost) * (1 + depth * lost),
                     "ssgi_window_depth");
            for (int c = 0; c < 2; ++c) {
                const double x = fabs((double)(in[i][1 + c] * view.unproject[c])) + fabs((double)view.unproject[2 + c]);
                NEAR(out[i][1 + c], p[c], 3e-7 * x * scale, "ssgi_position.xy");
            }
            NEAR(out[i][3], p[2], 0, "ssgi_position.z");
        }
        if (!probe(&mapped, &frame, ortho ? "o = vec4(ssgi_view_depth(vec4(u_ssgi_decode.xyz, 1.0), a.x));"
                                          : "o = vec4(ssgi_view_depth(vec4(u_ssgi_decode.xyz, 0.0), a.x));"))
            break;
        for (int i = 0; i < MANY; ++i) {
            CHECK(ssgi_view_depth(&view, in[i][0]) < 1e17f || (out[i][0] >= 1e17f && out[i][0] <= SSGI_FAR),
                  "ssgi_view_depth(%g): %g", (double)in[i][0], (double)out[i][0]);
            ssgi_view_position(in[i], &view, in[i][1], in[i][2], in[i][3]);
        }
        if (!probe(&d, &frame, "o = vec4(ssgi_project(a.xyz), ssgi_footprint(a.w), "
                               "ssgi_lift(vec3(0.0, 0.0, -a.w), vec3(1.0, 0.0, 0.0)).x);"))
            break;
        for (int i = 0; i < MANY; ++i) {
            float p[3];
            ssgi_view_project(p, &view, in[i]);
            for (int c = 0; c < 2; ++c)
                NEAR(out[i][c], p[c], 4e-7 * (fabs((double)p[c]) + 2 * fabs((double)view.project[2 + c])),
                     "ssgi_project");
            NEAR(out[i][2], ssgi_pixel_footprint(&view, in[i][3]), 2e-7f * out[i][2], "ssgi_footprint");
            NEAR(out[i][3], ssgi_normal_offset(&view, in[i][3]), 3e-7f * out[i][3], "ssgi_lift");
        }
    }
}

static void twin_noise(void)
{
    const ssgi_gl_frame frame = { .radius = 1 };
    const ssgi_gl_desc d = desc_of("ssao", "");
    for (int i = 0; i < MANY; ++i) {
        const int x = i % SIDE, y = i / SIDE;
        const float pixels[4] = { (float)(x * 37), (float)(y * 21), (float)x, (float)y };
        memcpy(in[i], pixels, sizeof pixels);
    }
    if (!probe(&d, &frame, "o = vec4(ssgi_noise(ivec2(a.xy)), ssgi_noise(ivec2(a.zw)));")) return;
    for (int i = 0; i < 2 * MANY; ++i) {                  /* two products and their sum, rounded; in x 53 times that */
        const double x = (double)ins[2 * i], y = (double)ins[2 * i + 1], sum = 0.06711056 * x + 0.00583715 * y,
                     e = (double)outs[2 * i] - 52.9829189 * (sum - floor(sum)),
                     f = (double)outs[2 * i + 1] - (0.75487766624669276 * x + 0.56984029099805327 * y);
        CHECK(fabs(e - floor(e + 0.5)) <= 53 * 1.2e-7 * (0.0671 * x + 0.0059 * y + 1)
                  && fabs(f - floor(f + 0.5)) <= 2.4e-7 * (x + y + 1),
              "ssgi_noise(%g, %g) is off by %g %g", x, y, e, f);
        CHECK(outs[2 * i] >= 0 && outs[2 * i] < 1 && outs[2 * i + 1] >= 0 && outs[2 * i + 1] < 1,
              "ssgi_noise(%g, %g) leaves [0,1)", x, y);
    }
}

static void twin_normals(void)
{
    const float c = 0.6f, s = 0.8f;
    const ssgi_gl_frame frame = { .rotation = { c, s, 0, 0, -s, c, 0, 0, 0, 0, 1, 0 } };   /* x goes to (c, s, 0) */
    ssgi_gl_desc d = desc_of("ssao", "");
    for (int k = 0; k < 2 * (SSGI_GL_NORMAL_OCTAHEDRAL - SSGI_GL_NORMAL_SIGNED + 1); ++k) {
        d.input.normal = (ssgi_gl_normal)(SSGI_GL_NORMAL_SIGNED + k / 2);
        d.input.world_normals = k & 1;
        for (int i = 0; i < MANY; ++i) {
            float *n = in[i], *e = map[i];
            direction(n);
            for (int j = 0; j < 3 && i < 6; ++j) n[j] = (float)((i == 2 * j) - (i == 2 * j + 1));   /* the axes, too */
            memcpy(e, n, 3 * sizeof *n);
            if (d.input.normal == SSGI_GL_NORMAL_UNSIGNED) for (int j = 0; j < 3; ++j) e[j] = n[j] * 0.5f + 0.5f;
            if (d.input.normal == SSGI_GL_NORMAL_OCTAHEDRAL) ssgi_octahedral_encode(e, n);
            if (d.input.normal == SSGI_GL_NORMAL_OCTAHEDRAL) e[2] = 9;      /* not looked at */
        }
        if (!probe_map(&d, &frame, "o = vec4(ssgi_normal(texel, vec3(0.0, 0.0, -1.0)), 0.0);")) return;
        for (int i = 0; i < MANY; ++i) {
            const float *n = in[i], want[3] = { k & 1 ? c * n[0] - s * n[1] : n[0],
                                                k & 1 ? s * n[0] + c * n[1] : n[1], n[2] };
            for (int j = 0; j < 3; ++j) NEAR(out[i][j], want[j], 6e-7, "ssgi_normal");
        }
    }
}

/* Probes two statements; the result of the first is the input of the second. */
static int probe_both(const char *pack, const char *read)
{
    const ssgi_gl_desc packs = desc_of("emitters", ""), reads = desc_of("ssdo", "search=points,bounce=patch");
    const ssgi_gl_frame frame = { .radius = 0 };
    if (!probe(&packs, &frame, pack)) return 0;
    memcpy(in, out, sizeof in);
    return probe(&reads, &frame, read);
}

/* Checks emitters as packed: errors follow the formats, 9 9 9 bits and an exponent of 5; 6 and 14 bits; 6 twice. */
static void twin_emitters(void)
{
    static float rgbz[MANY][4], way[MANY][4];
    double worst = 0;
    t_seed(9);
    for (int i = 0; i < MANY; ++i) {
        const float bright = powf(10, t_uniform(-7, 5.2f));
        for (int c = 0; c < 3; ++c) rgbz[i][c] = i % 8 == c ? 0 : bright * t_uniform(0, 1);
        direction(way[i]);
        for (int c = 0; c < 3 && i < 6; ++c) way[i][c] = i / 2 == c ? i & 1 ? -1.0f : 1.0f : 0.0f;
        /* here rounding needs the next exponent */
        if (i % 64 == 9) rgbz[i][i / 64 % 3] = ldexpf(511.0f + (float)(i / 192) / 21, i / 64 % 24 - 10);
        rgbz[i][3] = powf(10, t_uniform(-6, 13));
    }
    memcpy(in, rgbz, sizeof in);
    if (!probe_both("uvec2 u = uvec2(ssgi_pack_radiance(a.xyz), ssgi_pack_place(a.w, vec3(0.0, 0.0, 1.0)));"
                    "o = vec4(u.x & 65535u, u.x >> 16u, u.y & 65535u, u.y >> 16u);",
                    "uvec2 u = uvec2(a.xz) | uvec2(a.yw) << 16u;"
                    "o = vec4(ssgi_unpack_radiance(u.x), ssgi_unpack_depth(u.y));"))
        return;
    for (int i = 0; i < MANY; ++i) {
        const uint32_t a = (uint32_t)in[i][0] | (uint32_t)in[i][1] << 16, b = (uint32_t)in[i][3] << 16;
        const float most = fmaxf(fmaxf(rgbz[i][0], rgbz[i][1]), rgbz[i][2]);
        for (int c = 0; c < 3; ++c) {
            NEAR(out[i][c], fminf(rgbz[i][c], 65408), fmax((double)most / 510, 1.2e-7), "ssgi_pack_radiance");
            NEAR(out[i][c], ldexpf((float)(a >> 9 * c & 511), (int)(a >> 27) - 24), 0, "ssgi_unpack_radiance");
        }
        NEAR(out[i][3], rgbz[i][3], 3.06e-5 * (double)out[i][3], "ssgi_pack_place");
        NEAR(ilogbf(out[i][3]), (int)(b >> 26) - 20, 0, "ssgi_unpack_depth's exponent");
    }
    memcpy(in, way, sizeof in);
    if (!probe_both("uint u = ssgi_pack_place(1.0, a.xyz); o = vec4(u & 65535u, u >> 16u, 0.0, 0.0);",
                    "o = vec4(ssgi_unpack_normal(uint(a.x) | uint(a.y) << 16u), ssgi_unpack_depth(0xffffffffu));"))
        return;
    for (int i = 0; i < MANY; ++i) {
        double cosine = 0, length = 0;
        for (int c = 0; c < 3; ++c) {
            cosine += (double)out[i][c] * (double)way[i][c];
            length += (double)out[i][c] * (double)out[i][c];
        }
        const double degrees = acos(fmin(cosine / sqrt(length), 1)) * 180 / pi;
        CHECK(degrees <= 4, "an emitter's normal is off by %.2f degrees", degrees);
        NEAR(out[i][3], SSGI_FAR, 0, "the view depth of nothing");
        worst = fmax(worst, degrees);
    }
    t_note("an emitter's normal is off by %.2f degrees at most", worst);
}

/* Checks the point that an extra camera shows. It is the third camera, so that the block's strides matter. */
static void twin_views_of_others(void)
{
    const ssgi_gl_desc d = desc_of("ssao", "fade=1,views=3");
    const ssgi_gl_frame frame = { .radius = 0 };
    t_seed(11);
    for (int ortho = 0; ortho < 2; ++ortho) {
        float picture[16], other[16];
        if (!any_view(ortho, 0)) return;
        rigid(picture);
        rigid(other);
        memset(&probed, 0x5a, sizeof probed);
        ssgi_gl_views_set(&probed, 2, &view, picture, other, NULL);
        for (int i = 0; i < MANY; ++i) {
            const float pixel[4] = { floorf(t_uniform(0, 640)), floorf(t_uniform(0, 480)), t_uniform(0.5f, 30), 0 };
            memcpy(in[i], pixel, sizeof pixel);
        }
        if (!probe(&d, &frame, "o = vec4(ssgi_point(2, ivec2(a.xy), a.z), u_ssgi_view_decode[2].x);")) return;
        for (int i = 0; i < MANY; ++i) {
            const double z = (double)in[i][2], scale = ortho ? 1 : z,
                         p[4] = { ((double)in[i][0] + 0.5) * scale, ((double)in[i][1] + 0.5) * scale, z, 1 };
            for (int k = 0; k < 3; ++k) {
                double lost, want = product_of(probed.from[2], k, p, &lost);
                NEAR(out[i][k], want, lost, "ssgi_point");
            }
            NEAR(out[i][3], view.depth[0], 0, "u_ssgi_view_decode");
        }
    }
}

/* Checks the functions of ssgi_gl_sh in both languages. A case is four pixels, one for each word of the result. */
static void twin_harmonics(void)
{
    enum { BASIS, ZONAL, TURN, SUMS, FUNCTIONS };
    static const char *const heads[] = { "#version 330 core\n", "#version 300 es\nprecision highp float;\n" };
    static const char *const words[] = { "s.word0", "s.word0", "w == 0 ? s.word0 : w == 1 ? s.word1 : s.word2",
                                         "w == 0 ? s.word0 : w == 1 ? s.word1 : w == 2 ? s.word2 : s.word3" };
    static const char *const parts[] = { "", "", " s.word1 = b; s.word2 = c;",
                                         " s.word1 = b; s.word2 = c; s.word3 = d;" };
    static const char *const calls[] = { "s = ssgi_sh_basis(Y(2).xyz);", "s = ssgi_sh_zonal(X(0), Y(2).xyz);",
                                         "ssgi_sh_turn(s, mat3(Y(0).xyz, Y(1).xyz, Y(2).xyz));",
                                         "float both = ssgi_sh_dot(s, y); ssgi_sh_add(s, y, 0.5); s.word0.x = both;" };
    static const double tilts[8] = { 1e-2, 1e-3, 1e-4, 1e-5, 2e-6, 5e-7, 1e-7, 0 };   /* of the axis from a pole */
    static char text[TEXT], body[600];
    static float others[4 * MANY];
    const ssgi_gl_frame frame = { .radius = 1 };
    double worst[FUNCTIONS] = { 0 };
    t_seed(13);
    for (int k = 0; k < 2 * 4 * FUNCTIONS; ++k) {
        const int es = k & 1, bands = k / 2 % 4 + 1, what = k / 8;
        for (int i = 0; i < 4 * MANY; ++i) {
            ins[i] = i % 16 < bands * bands || what == ZONAL ? t_uniform(-1, 1) : 0;
            others[i] = ins[i] * t_uniform(-1, 1);
        }
        /* rotations: none, half turns, the axis at a pole and near it, random ones */
        for (int i = 0; i < MANY / 4 && what < SUMS; ++i) {
            const double tilt = tilts[i / 2 % 8], a = (double)t_uniform(0, 6.28f), b = (double)t_uniform(0, 6.28f);
            if (i < 4) rotation(&others[16 * i], i < 2 ? pi : 0, i & 1 ? pi / 2 : 0, i & 1 ? pi / 2 : 0);
            else rotation(&others[16 * i], i & 16 ? (double)t_uniform(0, 3.14159f) : i & 1 ? tilt : pi - tilt, a, b);
            /* rounded as a product of matrices is */
            for (int j = 0; j < 11 && i & 32; ++j) others[16 * i + j] += t_uniform(-1.2e-7f, 1.2e-7f);
        }
        size_t n = (size_t)snprintf(text, sizeof text, "%s", heads[es]);
        n += ssgi_gl_sh(text + n, sizeof text - n, bands);
        snprintf(text + n, sizeof text - n,
                 "ssgi_sh given(vec4 a, vec4 b, vec4 c, vec4 d) { ssgi_sh s; s.word0 = a;%s return s; }\n",
                 parts[bands - 1]);
        snprintf(body, sizeof body,
                 "int w = texel.x & 3; ssgi_sh s = given(X(0), X(1), X(2), X(3)), y = given(Y(0), Y(1), Y(2), Y(3)); "
                 "%s o = %s;",
                 calls[what], words[bands - 1]);
        memcpy(map, others, sizeof map);
        if (!probe_text(text, es ? SSGI_GL_DIALECT_300ES : SSGI_GL_DIALECT_330, &frame, 1, body)) return;
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
    }
    t_note("worst of basis %.1e, zonal %.1e, turn %.1e, sums %.1e", worst[BASIS], worst[ZONAL], worst[TURN],
           worst[SUMS]);
}

/* Checks that every half is read exactly and floats are rounded to halves, in languages with them or without. */
static void twin_halves(void)
{
    static const char *const dialects[] = { "330", "410", "450", "300es" };
    static const float odd[] = {
        0,     -0.0f,         65504,         65519,         65520,         65536,         1e9f,
        1e30f, 5.9604645e-8f, 2.9802322e-8f, 2.9802326e-8f, 6.0975552e-5f, 6.1035156e-5f, 6.1005358e-5f,
        1,     1e-40f
    };
    const ssgi_gl_frame frame = { .radius = 1 };
    for (int k = 0; k < 4; ++k) {
        char words[60];
        snprintf(words, sizeof words, "quantity=coefficients,packed_coefficients=1,dialect=%s", dialects[k]);
        const ssgi_gl_desc d = desc_of("blur", words);
        for (int first = 0; first < 1 << 16; first += 4 * MANY) {
            for (int i = 0; i < 4 * MANY; ++i) ins[i] = (float)(first + i);
            if (!probe(&d, &frame, "uvec4 h = uvec4(a); uvec2 u = h.xz | h.yw << 16u;"
                                   "o = vec4(ssgi_unpack_half(u.x), ssgi_unpack_half(u.y));"))
                return;
            for (int i = 0; i < 4 * MANY; ++i)
                if (((first + i) & 0x7c00) != 0x7c00) NEAR(outs[i], value_of(first + i), 0, "ssgi_unpack_half");
        }
        t_seed(14);
        /* halves, the middle between two and its neighbours, random numbers, odd ones */
        for (int i = 0; i < 4 * MANY; ++i) {
            const int h = (int)t_uniform(0, 0x7bff);
            const float middle = (float)(0.5 * (value_of(h) + value_of(h + 1)));
            const float x[4] = { (float)value_of(h), middle, nextafterf(middle, i & 4 ? 0.0f : 1e9f),
                                 powf(10, t_uniform(-9, 10)) };
            ins[i] = (i < 64 ? odd[i % 16] : x[i & 3]) * (i & 16 ? -1.0f : 1.0f);
        }
        if (!probe(&d, &frame, "uvec2 u = uvec2(ssgi_pack_half(a.xy), ssgi_pack_half(a.zw));"
                               "o = vec4(u.x & 65535u, u.x >> 16u, u.y & 65535u, u.y >> 16u);"))
            return;
        for (int i = 0; i < 4 * MANY; ++i)
            CHECK((int)outs[i] == half_of(ins[i]), "ssgi_pack_half(%.9g), %s: 0x%04x, to nearest even 0x%04x",
                  (double)ins[i], dialects[k], (unsigned)outs[i], (unsigned)half_of(ins[i]));
    }
}

/* Checks the functions of ssgi_gl_field, for two fields that are turned, scaled and moved. Points are around the first
   one, also in its hull. The last field's hull ends at its reach. An occluder that is the object itself is left out. */
static void twin_fields(void)
{
    static const char *const calls[2] = {
        "o = vec4(ssgi_field_visibility(2, 0, P, n));",
        "o = vec4(ssgi_field_visibility(1, 5, P, n), ssgi_field_visibility(2, 6, P, n), "
        "ssgi_field_visibility(1, 0, P, n), 1.0);" };
    const ssgi_gl_desc d = desc_of("aof", "");
    const ssgi_gl_frame frame = { .radius = 1 };
    const ssgi_field_desc made[2] = { { .resolution = 8, .radii = 8, .rays = 64 },
                                      { .resolution = 5, .radii = 8, .rays = 64 } };
    OWN(kit_scene) scene = { 0 };
    kit_error err = { "" };
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
    for (int m = 0; m < 6; ++m) {
        static char text[TEXT], statements[300];
        const ssgi_field *f[2];
        ssgi_gl_occluder occluder[2];
        float to[2][16];
        double sum = 0;
        for (int k = 0; k < 2; ++k) {
            const int shape = scene.object[k ? 12 : 3 + m % 4].shape;
            if (!CHECK((f[k] = kit_field(&scene.shape[shape], &made[k], NULL, &err)) != NULL, "%s", err.text)) return;
        }
        ssgi_field full = *f[0];
        full.reach = full.low[3];
        full.span[3] = 0;
        if (m == 5) f[0] = &full;
        for (int k = 0; k < 2; ++k) {
            ssgi_field_limits l = ssgi_field_limits_of(f[k]);
            l.ramp *= 0.5f + 0.2f * (float)k;
            l.power = 1.7f;
            rigid(to[k]);
            for (int j = 0; j < 12; ++j) to[k][j] *= k ? 0.4f : 3;
            to[k][13] = to[0][13] - 2.5f * (float)k;
            for (int j = 12; j < 15; j += 2) to[k][j] = to[0][j];
            if (!T_OK(ssgi_gl_occluder_set, &occluder[k], f[k], &l, to[k], k, 5 + k)) return;
            memcpy(map[k * SIDE], occluder[k].at, sizeof occluder[k]);
        }
        for (int i = 0; i < MANY; i += 2) {                /* a point, and a normal */
            const float r = occluder[0].radius * (i % 8 ? powf(t_uniform(0, 1), 3) : 0.2f * t_uniform(0, 1));
            direction(in[i]);
            direction(in[i + 1]);
            for (int k = 0; k < 3; ++k) in[i][k] = occluder[0].at[k] + r * in[i][k];
        }
        const size_t head = (size_t)snprintf(text, sizeof text, "#version 450 core\n");
        ssgi_gl_field(text + head, sizeof text - head, &d);
        snprintf(statements, sizeof statements, "vec3 P = X(texel.x & 2).xyz, n = X(texel.x & 2 | 1).xyz; %s",
                 calls[m == 4]);
        probed_layers.made = kit_field_atlas(f, 2);
        if (!probe_text(text, d.shader.dialect, &frame, 1, statements)) return;
        for (int i = 0; i < MANY; i += 2) {
            double open = 1;
            for (int k = 0; k < 2; ++k) {
                const ssgi_field_limits l = { occluder[k].ramp, occluder[k].reach, occluder[k].inside,
                                              occluder[k].power };
                open *= 1 - occluded_by(f[k], &l, to[k], in[i], in[i + 1]);
            }
            if (m == 4) NEAR(out[i][0], 1, 1e-6, "the object itself");
            if (m == 4) NEAR(out[i][1], out[i][2], 1e-6, "without the object itself");
            else NEAR(out[i][0], open, 2e-5, "ssgi_field_visibility");
            sum += open / (MANY / 2);
        }
        CHECK(sum < 0.95, "%d: the mean is %.3f", m, sum);
    }
    kit_fields_free();
}

/* ---- >>terms: functions of numbers, a row each, GLSL against the formula of its comment -------------------------- */

/* Kinds of the inputs of a row of the table of terms, and of the wanted result. */
typedef enum numbers {
    AMBIENT, SECOND_LAYER, WAY, WIDTH, SHORT_WIDTH, SHORT, LIT, GLOSS, ARC, SECTORS, SLAB, KERNEL, OCTAHEDRAL, DISC, CAP
} numbers;

/* The statement makes o of inputs a, which are in [low,high] or set by numbers_of; want makes three results in C. Pass
   "reflection" stands for the shader of ssgi_gl_reflection. by: a parameter of want. */
typedef struct term {
    const char *name, *pass, *words, *statement;
    float low, high;
    numbers what;
    int by;
    double within;
} term;

/* Returns the integral in the comment of ssgi_arc_slope, by Simpson's rule. */
static double arc(double top, double g)
{
    enum { PARTS = 128 };
    double sum = 0;
    for (int k = 0; k <= PARTS; ++k)
        sum += sin(top * k / PARTS) * cos(g - top * k / PARTS) * (k == 0 || k == PARTS ? 1 : k & 1 ? 4 : 2);
    return sum * top / (3 * PARTS);
}

static void give(float *a, const term *t, int i)
{
    for (int c = 0; c < 4; ++c) a[c] = t->what == OCTAHEDRAL && i < 6 ? (float)((i == 2 * c) - (i == 2 * c + 1))
                                                                      : t_uniform(t->low, t->high);
    /* height over the tangent plane and distance along it, down to the plane and up to the normal; the slice's angle */
    if (t->what == ARC) {
        a[i & 1] = i % 32 == 16 * (i / 16 & 1) ? 0 : powf(10, t_uniform(-12, 0));
        a[!(i & 1)] = 1;
    }
    /* view depth; depth of the back: of a sheet within a half's rounding, of a slab, none; the gap */
    if (t->what == SLAB) {
        const float z = powf(10, t_uniform(-1, 2));
        const float backs[4] = { z * (1 + t_uniform(0, 0.00048f)), z + t_uniform(0.0006f * z, 0.0006f * z + 1),
                                 i & 4 ? 0 : 1e18f, z * t_uniform(0, 1) };
        a[0] = z;
        a[1] = backs[i & 3];
        a[2] = t_uniform(0, 0.2f);
    }
    if (t->what == KERNEL) a[0] = (float)((i + i / SIDE) % 64);
    /* the distance of a disc straight ahead, and its radius squared */
    if (t->what == DISC) {
        a[0] = t_uniform(0.1f, 2);
        a[1] = powf(10, t_uniform(-2, 1));
        if (fabsf(a[0] * a[0] / (16 * a[1]) - 1) < 1e-5f) a[1] *= 2;
    }
    /* a cap's share of a half space, and the cosine of its axis; beyond the table, too */
    if (t->what == CAP && !t->by) a[0] = i % 64 < 56 ? (float)(i % 64) / 55 : powf(10, (float)(55 - i % 64));
    if (t->what == CAP && !t->by) a[1] = 2 * (float)(i / 64) / 63 - 1;
}

static void want(double *o, const term *t, const double *a, int i)
{
    const float f[4] = { (float)a[0], (float)a[1], (float)a[2], (float)a[3] };
    float kernel[4 * 64], e[2];
    o[0] = o[1] = o[2] = 0;
    switch (t->what) {
    case AMBIENT: o[0] = o[1] = o[2] = fmin(fmax(a[0] * 1.1283791671, 0), 1); break;
    case SECOND_LAYER: o[0] = o[1] = o[2] = 2; break;
    case WAY: for (int k = 0; k < 3; ++k) o[k] = a[3] - a[k]; break;
    case WIDTH: for (int k = 0; k < 3; ++k) o[k] = a[k] / 63; break;             /* in radii, as the radius is 1 */
    case SHORT_WIDTH:                                                            /* at most twice a segment's length */
        for (int k = 0; k < 3; ++k) o[k] = fmin(a[k] / 63, 2 * a[3] / 63);
        break;
    case SHORT: o[0] = o[1] = o[2] = fmin(0.3, 2 * a[3] / 63); break;
    case LIT: for (int c = 0; c < 3; ++c) o[c] = (double)ssgi_interreflected(f[0], f[1 + c]); break;
    case GLOSS:
        o[0] = o[1] = o[2] = (double)ssgi_specular_visibility(f[0], 2 * f[1] - 1, 2 * f[2] - 1, f[3]);
        break;
    case ARC:                      /* an arc on both sides; the polynomial's error grows with the sine */
        o[0] = arc(atan2(a[1], a[0]), a[2]) / (fabs(sin(a[2])) + 0.003);
        o[1] = arc(atan2(a[1], -a[0]), -a[2]) / (fabs(sin(a[2])) + 0.003);
        break;
    case SECTORS:                  /* sectors from one end to the other; from 0 to the other, twice */
        o[1] = o[2] = floor(fmin(fmax(a[0], a[1]), 32));
        o[0] = o[1] - floor(fmin(fmin(a[0], a[1]), 32));
        break;
    case SLAB:                     /* a slab from a gap to the radius; of sheets, the thickness */
        o[0] = (i & 3) == 1 ? fmax(fmin(a[1] - a[0], 0.5), a[2]) : fmax(0.3, a[2]);
        o[1] = 0.2;
        break;
    case KERNEL:                   /* from the kernel's first number on or from its last */
        ssgi_directions(kernel, t->by, 1, 64, NULL);
        for (int c = 0; c < 3; ++c) o[c] = (double)kernel[4 * (int)a[0] + (i & 1 ? 3 - c : c)];
        break;
    case CAP: o[0] = o[1] = o[2] = ssgi_cap_occlusion(2 * pi * a[0], a[1]); break;
    case OCTAHEDRAL:
        ssgi_octahedral_encode(e, f);
        for (int c = 0; c < 2; ++c) o[c] = (double)e[c];
        break;
    case DISC: {                   /* over the whole disc's: middles of rings of equal area, whose sum telescopes */
        const double h = a[0], rr = a[1], half = 0.5 * rr / t->by,
                     several = h / rr * (1 / (h * h + half) - 1 / (h * h + rr + half));
        o[0] = h * h < 16 * rr ? several * h * (h * h + rr) : 1;   /* beyond four radii only the disc's centre counts */
    }
    }
}

#define BITS "vec2 s = min(vec2(min(a.x, a.y), max(a.x, a.y)), 32.0); uint m = ssgi_sectors(s.x, s.y);" \
             "uint all = ssgi_sectors(0.0, s.y), low = ssgi_sectors(0.0, s.x);" \
             "o = vec4(ssgi_count(m), ssgi_count(m ^ low), ssgi_count(all), 0.0);"
#define POINTS "vec3 d = vec3(0.0, 0.0, a.x), n = vec3(0.0, 0.0, 1.0);" \
               "o = vec4(ssgi_form(d, n, -n, a.y) * a.x * (a.x * a.x + a.y), vec3(0.0));"
#define TABLE "vec4 k = SSGI_KERNEL_TABLE[int(a.x)]; o = (texel.x & 1) == 0 ? k : k.wzyx;"
#define WIDTHS "o = vec4(ssgi_measured_width(a.x), ssgi_measured_width(a.y), ssgi_measured_width(a.z), 0.0);"
static const term terms[] = {
    { "ambient visibility of coefficients", "shade", "residual=1",
      "ssgi_coefficients v; for (int c = 0; c < v.channel.length(); ++c) v.channel[c].word0 = vec4(a.x, 0.0, 0.0, 0.0);"
      " o = vec4(ssgi_ambient(v), 0.0);",
      -0.5f, 1.5f, AMBIENT, 0, 1e-6 },
    { "the normal of the layer that receives", "lights", "layers=4,receiver=2", "o = ssgi_normal_texel(texel);", 0, 1,
      SECOND_LAYER, 0, 0 },
    { "the albedo of the layer that receives", "emitters", "layers=4,receiver=2", "o = vec4(ssgi_albedo(texel), 0.0);",
      0, 1, SECOND_LAYER, 0, 0 },
    { "the way to a sample, by which emitters are chosen", "ssdo", "layers=4,search=points,bounce=solid_angle",
      "ssgi_P = a.xyz; float found = ssgi_occlusion_at(vec3(a.w)); o = vec4(ssgi_way, found);", -2, 2, WAY, 0, 1e-6 },
    { "the width that a texel holds", "ssao", "thickness=width", WIDTHS, 0, 63, WIDTH, 0, 1e-6 },
    { "the width that a segment to a light takes", "lights", "thickness=width",
      "ssgi_segment_length = a.w / 63.0;" WIDTHS, 0, 63, SHORT_WIDTH, 0, 1e-6 },
    { "the constant thickness that a segment to a light takes", "lights", "thickness=constant",
      "ssgi_segment_length = a.w / 63.0; o = vec4(vec3(ssgi_thickness()), 0.0);", 0, 63, SHORT, 0, 1e-6 },
    { "interreflected light", "reflection", "", "o = vec4(ssgi_interreflected(a.x, a.yzw), 0.0);", 0, 1, LIT, 0, 1e-6 },
    { "visibility of a lobe", "reflection", "",
      "o = vec4(ssgi_specular_visibility(a.x, 2.0 * a.y - 1.0, 2.0 * a.z - 1.0, a.w));", 0, 1, GLOSS, 0, 1e-6 },
    { "a slice's arc: the integral that it says", "hsao", "",   /* and roundings by which |c| > 1 */
      "float r = inversesqrt(a.x * a.x + a.y * a.y) * (1.0 + 2.4e-7 * float(texel.x & 2)), h = 0.5 * sin(a.z),"
      " g = 0.5 * cos(a.z); vec2 c = vec2(a.x, -a.x) * r, q = c * c, way = vec2(h, -h);"
      "vec2 arcs = g - g * q + way * vec2(ssgi_arc_odd(c.x, q.x), ssgi_arc_odd(c.y, q.y));"
      "o = vec4(arcs / (abs(sin(a.z)) + 0.003), 0.0, 0.0);",
      -1.57f, 1.57f, ARC, 0, 0.5 * 0.0015 },
    { "sectors", "hsao", "dialect=450", BITS, 0, 33, SECTORS, 0, 0 },
    { "sectors in a language that does not count bits", "hsao", "dialect=330", BITS, 0, 33, SECTORS, 0, 0 },
    { "slabs are as deep as their backs say, sheets by the thickness", "ssao", "thickness=back",
      "o = vec4(ssgi_slab_thickness(vec2(a.x, 1.0), vec2(a.y, 1.2), vec2(a.z, 0.0)), 0.0, 0.0);", 0, 1, SLAB, 0, 2e-5 },
    { "the kernel", "ssao", "directions=64", TABLE, 0, 1, KERNEL, SSGI_DIRECTIONS_COSINE, 1.2e-7 },
    { "the uniform kernel", "ssao", "directions=64,uniform_directions=1", TABLE, 0, 1, KERNEL, SSGI_DIRECTIONS_UNIFORM,
      1.2e-7 },
    { "the octahedral map", "ssdo", "environment=map", "o = vec4(ssgi_octahedral(a.xyz), 0.0, 0.0);", -9, 9, OCTAHEDRAL,
      0, 4e-7 },
    { "two points over a disc", "dss", "near_samples=2", POINTS, 0, 1, DISC, 2, 2e-5 },
    { "four points over a disc", "dss", "near_samples=4", POINTS, 0, 1, DISC, 4, 2e-5 },
    { "16 points over a disc", "dss", "near_samples=16", POINTS, 0, 1, DISC, 16, 2e-5 },
    { "a cap", "aof", "", "o = vec4(ssgi_cap(1.0 - a.x, a.x * (2.0 - a.x), a.y));", 0, 1, CAP, 0, 1e-5 },
    { "a cap by a table", "aof", "cap_table=1", "o = vec4(ssgi_cap_table(a.x, a.y));", -1.1f, 2.05f, CAP, SIDE,
      1.5e-3 },
};
#undef BITS
#undef POINTS
#undef TABLE
#undef WIDTHS

static void functions_of_numbers(void)
{
    static float layer[16 * MANY], table[MANY];
    static char text[TEXT];
    ssgi_gl_frame frame = facing(1);
    frame.thickness_limit = 0.3f;
    for (int i = 0; i < 16 * MANY; ++i) layer[i] = (float)(i / (4 * MANY) + 1);
    ssgi_cap_table(table, SIDE, NULL);
    for (int i = 0; i < MANY; ++i) map[i][0] = table[i];
    for (size_t k = 0; k < sizeof terms / sizeof *terms; ++k) {
        const term *const t = &terms[k];
        const int alone = !strcmp(t->pass, "reflection");
        const ssgi_gl_desc d = desc_of(alone ? "ssao" : t->pass, t->words);
        t_seed(31 + k);
        for (int i = 0; i < MANY; ++i) give(in[i], t, i);
        layers_of(layer, 4, GL_RGBA32F);
        frame.radius = t->what == SLAB ? 0.5f : 1;
        const size_t head = (size_t)snprintf(text, sizeof text, "#version 450 core\n");
        if (alone) ssgi_gl_reflection(text + head, sizeof text - head);
        if (!(alone ? probe_text(text, d.shader.dialect, &frame, 1, t->statement)
                    : probe_map(&d, &frame, t->statement)))
            return;
        for (int i = 0; i < MANY; ++i) {
            const double a[4] = { (double)in[i][0], (double)in[i][1], (double)in[i][2], (double)in[i][3] };
            double o[3];
            want(o, t, a, i);
            for (int c = 0; c < 3; ++c) NEAR(out[i][c], o[c], t->within, t->name);
        }
    }
    CHECK(!ssgi_gl_reflection(NULL, 1), "written to nothing");
}

/* ---- >>walk: slices, by GLSL's bits and by vectors --------------------------------------------------------------- */

/* Returns a side's occluded sectors, with an expectation for occluders that its samples missed and for those beyond the
   picture, which ends after so many radii. */
static double expected(double found, double open, int steps, double edge)
{
    const double beyond = fmax(1 - edge, 0), missed = fmax(0.09375 / steps - 0.0028, 0) * found;
    return found + open * fmin(missed + beyond * beyond * fmin(0.05 * found, 0.4), 1);
}

/* Checks one sample in one slice, at an elevation over a tilted plane: whether and how much it counts. The walk ends at
   the radius, or at the span if there is one. */
static void slices_limits(void)
{
    /* tilt of the plane in degrees; sine of the sample's elevation; beyond 1: behind the normal */
    static const struct { double tilt, height; int beyond, counts, span;
    } row[] = { { 80, 0.39, 1, 0, 0 },   { 80, 0.41, 1, 1, 0 },   { 80, 0.2, 1, 0, 0 }, { 60, 0.9, 1, 1, 0 },
                { 80, 0.0039, 0, 0, 0 }, { 30, 0.0041, 0, 1, 0 }, { 60, 0.3, 0, 1, 0 }, { 20, 0.7, 0, 1, 0 },
                { 20, 0.7, 0, 1, 1 } };
    ssgi_gl_desc d = desc_of("hsao", "slices=1,samples=1,falloff=none,orthographic=1,depth=linear,thickness=solid");
    ssgi_gl_frame frame = facing(3.512f);
    frame.surfel[0] = 1.561f;
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const double tilt = row[k].tilt * pi / 180, up = row[k].beyond ? pi - asin(row[k].height) : asin(row[k].height);
        /* of the sample from the view direction: 4 pixels aside, and nearer */
        const double away = tilt + pi / 2 - up;
        for (int i = 0; i < MANY; ++i) {
            const double from = hypot(i % SIDE - SIDE / 2, i / SIDE - SIDE / 2);
            map[i][0] = i == CENTRE ? 10 : from > 2.5 && from < 6 ? (float)(10 - 0.25 * cos(away) / sin(away)) : 100;
        }
        in[CENTRE][0] = (float)sin(tilt);
        in[CENTRE][1] = (float)cos(tilt);
        /* this depth squared, times the radius or the span, is 4.3 pixels. Sectors are rounded up, but for 1e-5 */
        in[CENTRE][2] = row[k].span ? 0.414937f : 0.276624f;
        d.surfel.span = row[k].span;
        if (!probe_map(&d, &frame, "vec3 P = ssgi_position(vec2(texel) + 0.5, ssgi_depth(texel));"
                                   "mat3 m = ssgi_basis(vec3(0.0, 0.0, 1.0)); vec3 n = m[0] * a.x + m[2] * a.y;"
                                   "o = vec4(ssgi_gather(texel, P, n, vec2(0.0, a.z)).all);"))
            return;
        const double whole = arc(pi / 2 + tilt, tilt), got = (double)out[CENTRE][0],
                     found = row[k].counts ? ceil(32 * arc(up, tilt) / whole) : 0,
                     pixels = 4.3 / ((double)in[CENTRE][2] * (double)in[CENTRE][2]),
                     want = whole / 32 * expected(found, 32 - found, 1, (SIDE / 2 - 0.501) / pixels);
        CHECK(fabs(got - want) <= (row[k].counts ? 0.002 : 0) && (got > 0) == row[k].counts,
              "tilt %g, height %g%s: %g, not %g", row[k].tilt, row[k].height, row[k].beyond ? " beyond the normal" : "",
              got, want);
    }
}

/* Returns the texels of pass thickness for map's view depths in x and thicknesses in w, in radii / 63. Writes the
   values that are read back into map. */
static const uint32_t (*measured(int orthographic))[4]
{
    static uint32_t packed[MANY / 4][4];
    for (int t = 0; t < MANY / 4; ++t) {                   /* one texel of pass thickness for each 2x2 pixels */
        float z[4];
        unsigned thickness[4];
        for (int i = 0; i < 8; ++i) {                      /* writes, then reads */
            float *const of = map[(t / (SIDE / 2) * 2 + (i >> 1 & 1)) * SIDE + t % (SIDE / 2) * 2 + (i & 1)];
            if (i == 4) pack_measured(packed[t], z, thickness, orthographic);
            if (i < 4) { z[i] = of[0]; thickness[i] = (unsigned)of[3]; }
            else { of[0] = unpack_measured(thickness, packed[t], i & 3, orthographic); of[3] = (float)*thickness; }
        }
    }
    return (const uint32_t (*)[4])packed;
}

/* A slice's side of the walk by its definition, with vectors, one sector after another; the frame is that of
   walks_by_vectors. Thickness is map's w, in radii / 63. span: where the walk ends if that is before the radius, in
   perspective times the receiver's depth. In its second half it fades. */
typedef struct walk { const ssgi_gl_frame *frame; int flat, thickness, steps; double span; } walk;
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

/* Returns the sector of a cosine, by the polynomial of ssgi_arc_odd, which twin_arc tests. */
static double sector_of(double c, double g, double whole, double noise)
{
    const double q = c * c;
    const double odd = 1.57079633 - c * (2.01098408 + q * (-0.43954273 + q * (0.21090284 - 0.21154786 * q)));
    return fmax(fmin((0.5 * cos(g) * (1 - q) + 0.5 * sin(g) * odd) * 32 / whole + noise, 32), 0);
}

/* Takes sectors from low to high, and returns how many of them were free. */
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

/* Returns the attenuated sectors. where: sums them times their elevation, along t and up. t: in the tangent plane; n:
   the normal over the length of its projection; g: its angle. */
static double side_walked(double *where, const walk *w, const int *p, const double *P, const double *t, const double *n,
                          double g, const double *pixels, double xi, double noise)
{
    const double R = (double)w->frame->radius, reach = w->span > 0 ? fmin(w->span, R) : R;
    const double whole = fmax(sector_of(-sin(g), g, 32, 0), 1e-5);
    /* a 20th of a pixel, by which the walk hides rounding */
    const float *per = w->frame->unproject;
    const double near = 0.05 * fmax(fabs((double)per[0]), fabs((double)per[1])) * (w->flat ? 1 : -P[2]);
    walked last = { 0, -P[2], -P[2], 0, 0, 1, 0, 1 };
    uint32_t mask = 0;
    double sum = 0, before = 0;
    for (int k = 0; k < w->steps; ++k) {
        const double root = (k + xi) / w->steps, u = root * root, gap = (u - before) * reach;
        const int x = (int)floor(p[0] + 0.5 + pixels[0] * u), y = (int)floor(p[1] + 0.5 + pixels[1] * u);
        const int inside = x >= 0 && y >= 0 && x < SIDE && y < SIDE;
        const float *tap = map[inside ? y * SIDE + x : 0];
        double z[4] = { (double)tap[0], 0, (double)tap[1], 0 }, Q[3], at[4][3], e[4][2], L[4];
        const double width = (double)tap[3] * R / 63 + 0.5 * gap;
        z[1] = z[0] + (w->thickness == SSGI_GL_THICKNESS_CONSTANT ? (double)w->frame->thickness_limit : width);
        if (z[2] <= 0) z[2] = 1e18;
        z[3] = z[2] + fmax(fmin(tap[2] > tap[1] ? (double)(tap[2] - tap[1]) : (double)tap[3] * R / 63, R), 2 * gap);
        for (int i = 0; i < 4; ++i) {               /* (along, up) of the front, its back, the second front, its back */
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
            if (w->span > 0) share *= fmax(fmin(2 - 2 * d / w->span, 1), 0);
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

/* Returns the occlusion that the walk of pixel i must have. light: its share of the first band, along x, y, z. */
static double walk_of(double light[3], const walk *of, int i, int slices)
{
    const ssgi_gl_frame *const frame = of->frame;
    const walk here = { frame, of->flat, of->thickness, of->steps, of->span * (of->flat ? 1 : (double)map[i][0]) };
    const walk *const w = &here;
    const int p[2] = { i % SIDE, i / SIDE };
    const double n[3] = { (double)in[i][0], (double)in[i][1], (double)in[i][2] },
                 xi[2] = { (double)in[i][3], (double)fmodf(7 * in[i][3], 1) },
                 reach = w->span > 0 ? w->span : (double)frame->radius;
    double P[3], V[3] = { 0, 0, 1 }, want = 0;
    light[0] = light[1] = light[2] = 0;
    seen_at(w, p[0] + 0.5, p[1] + 0.5, (double)map[i][0], P);
    for (int c = 0; c < 3 && !w->flat; ++c) V[c] = -P[c] / sqrt(dot3(P, P));
    /* [Duff et al. 2017] */
    const double q = -1 / (1 + V[2]), b = V[0] * V[1] * q;
    const double basis[2][3] = { { 1 + V[0] * V[0] * q, b, -V[0] }, { b, 1 + V[1] * V[1] * q, -V[1] } };
    for (int s = 0; s < 2 * slices; ++s) {               /* two sides each */
        const int back = s & 1;
        const double phi = pi * (s / 2 + xi[0]) / slices, wide = 0.61803399 * (s / 2) + 3.7 * xi[0];
        double along[3], t[3], over[3], pixels[2], at[2] = { 0, 0 }, way[3];
        for (int c = 0; c < 3; ++c) along[c] = basis[0][c] * cos(phi) + basis[1][c] * sin(phi);
        const double sine = dot3(n, along), cosine = dot3(n, V), l = fmax(hypot(sine, cosine), 1e-4);
        for (int c = 0; c < 3; ++c) {
            t[c] = (back ? -1 : 1) * (along[c] * cosine - V[c] * sine) / l;
            over[c] = n[c] / l;
        }
        for (int c = 0; c < 2; ++c) {
            const double by = w->flat ? along[c] : (along[c] - P[c] * along[2] / P[2]) / -P[2];
            pixels[c] = (back ? -1 : 1) * by * (double)frame->project[c] * reach;
        }
        const double share = l / slices * side_walked(at, w, p, P, t, over, (back ? -1 : 1) * atan2(sine, cosine),
                                                      pixels, back ? 1 - xi[1] : xi[1],
                                                      fraction(xi[1] * (back ? 11.41 : 7.23) + wide));
        want += share;
        for (int c = 0; c < 3; ++c) way[c] = t[c] * at[0] + (along[c] * sine + V[c] * cosine) / l * at[1];
        for (int c = 0; c < 3; ++c) light[c] += share * way[c] / fmax(sqrt(dot3(way, way)), 1e-12);
    }
    return want;
}

/* Compares the walk at every pixel of a rough map, with some normals far from the viewer, in GLSL and by vectors; and
   its light in the first band of harmonics, which tells directions. If rounding moves a sector, a slice's side changes
   by a 32nd: few pixels may. */
static void walks_by_vectors(void)
{
    static const char *const thickness[5] = { "solid", "constant", "width", "slabs", "constant,span=4" };
    static float blocked[MANY];
    static const float m[2][16] = { { 2, 0, 0, 0, 0, 2.5f, 0, 0, 0.1f, -0.05f, -1.02f, -1, 0, 0, -0.2f, 0 },
                                    { 0.3f, 0, 0, 0, 0, 0.25f, 0, 0, 0, 0, -0.02f, 0, 0, 0, -1, 1 } };
    for (int k = 0; k < 10; ++k) {
        char words[100];
        snprintf(words, sizeof words, "slices=2,samples=5,depth=linear,orthographic=%d,thickness=%s", k & 1,
                 thickness[k / 2]);
        ssgi_gl_desc d = desc_of("hsao", words), lit = desc_of("ssdo", words);
        ssgi_gl_frame frame = seen_by(m[k & 1], SSGI_CLIP_GL, SIDE, SIDE, 1.5f);
        const walk w = { &frame, k & 1, d.gather.thickness, 5, k < 8 ? 0 : 4 * (k & 1 ? 0.2 : 0.025) };
        frame.thickness_limit = 0.3f;
        frame.surfel[0] = k & 1 ? 0.2f : 0.025f;
        t_seed(71 + (uint32_t)k);
        for (int i = 0; i < MANY; ++i) {                   /* makes a slope with blocks, a step down, holes */
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
        const uint32_t (*width)[4] = d.gather.thickness > SSGI_GL_THICKNESS_SOLID ? measured(k & 1) : NULL;
#define WALK "float z = ssgi_depth(texel); vec2 xi = vec2(a.w, fract(7.0 * a.w)); " \
             "ssgi_sums s = ssgi_gather(texel, ssgi_position(vec2(texel) + 0.5, z), a.xyz, xi);"
        probed_width = width;
        if (!probe_map(&d, &frame, WALK "o = vec4(s.all);")) return;
        for (int i = 0; i < MANY; ++i) blocked[i] = out[i][0];
        lit.light.environment = SSGI_GL_ENVIRONMENT_SH;
        probed_width = width;
        if (!probe_map(&lit, &frame,
                       WALK "o = (ssgi_sh_zonal(SSGI_COSINE, a.xyz).word0 - s.lobe.word0) / SSGI_PI;"))
            return;
#undef WALK
        int off = 0, many = 0, astray = 0;
        double bias = 0, mean = 0, light[3];
        for (int i = 0; i < MANY; ++i) {
            if (!(map[i][0] < 1e17f)) continue;
            const double want = walk_of(light, &w, i, 2);
            /* lanes y, z, w have the components y, z, x, times 0.4886 */
            for (int c = 0; c < 3; ++c)
                astray += fabs((double)out[i][1 + (c + 2) % 3] - 0.48860251 * light[c]) > 0.002;
            off += fabs((double)blocked[i] - want) > 0.002;
            bias += (double)blocked[i] - want;
            mean += want;
            ++many;
        }
        /* a texel's distance from its slice is taken at the receiver's depth */
        CHECK(off < many * (k & 1 ? 0.004 : 0.06) && fabs(bias) < many * 0.0004 && mean > many * 0.2,
              "%s: %d of %d pixels are off by more than 0.002, by %g on the mean", words, off, many, bias / many);
        /* behind a hole solids keep an elevation that rounding decides */
        CHECK(astray < 3 * many * (k & 1 ? 0.015 : 0.06), "%s: of light %d of %d components are", words, astray,
              3 * many);
        t_note("%s: %.4f blocked, by %.6f less; off by over 0.002: %d of %d, %d of light", words, mean / many,
               -bias / many, off, many, astray);
    }
}

/* ---- >>figures: weights and limits that no formula gives, by cases worked out by hand ---------------------------- */

/* Puts a light's row of t_ssgi_lights, from its map on, into map's first texels. The map looks along -z, in tile
   0,32. */
static void light_rows(int texel, float scale, int flat_, int wide)
{
    const float light[5][4] = { { 1, 0, 0, 0 }, { 0, 1, 0, 0 }, { 0, 0, -1, 0 }, { 0, scale, -1, (float)flat_ },
                                { 0, 32, (float)wide, 1 } };
    memset(map, 0, sizeof map);
    memcpy(map[texel], light, sizeof light);
}

/* Puts points of a plane before a map. Before each the map shows a surface, the last one nearer by almost `before`. */
static void light_points(float depth, float scale, int flat_, double before)
{
    light_rows(3, scale, flat_, SIDE);
    for (int i = 0; i < SIDE; ++i) {
        const double shown = (double)depth - before * i / SIDE;
        const float to = flat_ ? 1 : depth, p[4] = { ((float)i + 0.5f) * to, 0.5f * to, -depth, 0 };
        map[32 * SIDE + i][0] = (float)((flat_ ? shown : 1 / shown) / (double)scale);
        memcpy(in[i], p, sizeof p);
    }
}

/* Checks a shadow map that shows a surface just before a point that faces its light, with texels as small as points. It
   must stay lit as long as rounding alone may explain the difference. */
static void shadow_slack(void)
{
    /* slack of a far point; of a deep map: 3e-7 of scale, times depth squared if 1/z is stored, and 2e-5 of depth */
    static const struct { float depth, scale; int flat; double slack; } row[] = {
        { 1000, 1, 1, 0.0200003 }, { 1, 1000, 1, 3.2e-4 }, { 10, 10, 0, 5e-4 }, { 1, 500, 0, 1.7e-4 } };
    const ssgi_gl_desc d = desc_of("lights", "shadow=map");
    const ssgi_gl_frame frame = { .radius = 1, .max_slope = 20 };
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        light_points(row[k].depth, row[k].scale, row[k].flat, 2 * row[k].slack);
        if (!probe_map(&d, &frame, "ssgi_light s; s.distance = length(a.xyz), s.facing = vec4(0.0); float bias;"
                                   "o = vec4(ssgi_shadow(0, a.xyz, vec3(0.0, 0.0, 1.0), s, 1.0, bias));"))
            return;
        for (int i = 0; i < SIDE; ++i)
            CHECK(i == 32 || out[i][0] == (i > 32), "depth %g, scale %g, %s: %g of the slack before it is %s",
                  (double)row[k].depth, (double)row[k].scale, row[k].flat ? "orthographic" : "perspective", i / 32.0,
                  out[i][0] > 0 ? "dark" : "lit");
    }
}

/* Checks planes that slope against a sun's map, whose axis points to the light, or against a spot's at its axis. The
   map shows a surface before them by up to twice the bias in C, and must shadow from the bias on. */
static void shadow_bias(void)
{
    const ssgi_gl_desc d = desc_of("lights", "shadow=map");
    const ssgi_gl_frame frame = { .radius = 1, .max_slope = 6 };
    for (int k = 0; k < 10; ++k) {
        const int flat_ = k & 1;
        const double c = 0.9 - 0.2 * (k / 2), depth = 20, width = flat_ ? 0.25 : 0.0125;
        const float patch = 0.25f, most = (float)(0.25 * sqrt(0.5) * 6); /* most: the limit of the last plane's bias */
        const double bias = (double)ssgi_shadow_bias(patch, (float)c, most, SSGI_BIAS_SAFE);
        char statements[300];
        int lit = 0;
        light_points((float)depth, 1, flat_, 2 * bias);
        /* at the axis the light's distance is the depth */
        snprintf(statements, sizeof statements,
                 "ssgi_light s; s.distance = %f, s.facing = vec4(%f); float contact;"
                 "o = vec4(ssgi_shadow(0, a.xyz, vec3(%f, 0.0, %f), s, %f, contact));",
                 depth, width, sqrt(1 - c * c), c, c);
        if (!probe_map(&d, &frame, statements)) return;
        for (int i = 0; i < SIDE; ++i) lit += out[i][0] < 0.5f;
        /* expects the bias with a slack of a fiftieth of a texel */
        CHECK(fabs(lit - 0.5 - 32 * (1 + 0.02 * (double)patch / bias)) <= 1.5, "cosine %g, %s: lit for %g of the bias",
              c, flat_ ? "a sun" : "a spot", lit / 32.0);
    }
}

/* Checks that no more rows are read than the texture has. Each row is a sun that its map shows; the first tells how
   many others are the same sun with wider maps. A number out of range counts as none or all, and no row is read
   again. */
static void rows_are_visited_once(void)
{
    static const struct { float wider; int lights; float sum, or_; } row[] = {
        { 0, 3, 3, 3 },    { 1, 3, 2, 2 },   { 2, 3, 1, 1 },       { 3, 3, 1, 1 },         { -1, 3, 3, 3 },
        { -9, 3, 3, 3 },   { 3e9f, 3, 3, 1 }, { -3e9f, 3, 3, 1 },  { INFINITY, 3, 3, 1 }, { NAN, 3, 3, 1 },
        { 0, -5, 0, 0 },   { 0, INT_MAX, SIDE, SIDE } };
    static const float sun[2][4] = { { 0, 0, 1, SSGI_GL_LIGHT_SUN }, { 1, 1, 1, 0 } };
    const ssgi_gl_desc d = desc_of("lights", "shadow=map");
    light_rows(3, 1, 1, 8);
    map[7][0] = 8;
    memcpy(map[0], sun, sizeof sun);
    for (int i = 1; i < SIDE; ++i) memcpy(map[SIDE * i], map[0], 8 * sizeof map[0]);
    for (int i = 0; i < SIDE; ++i) memcpy(in[i], (float[4]){ 0.5f, 0.5f, -1, 0 }, sizeof in[i]);
    map[SIDE * 32 + 8][0] = 1000;                        /* a depth far behind the point */
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const ssgi_gl_frame frame = { .radius = 1, .max_slope = 20, .lights = row[k].lights };
        map[1][3] = row[k].wider;
        if (!probe_map(&d, &frame, "o = vec4(ssgi_lit(a.xyz, vec3(0.0, 0.0, 1.0), 0.0), 1.0);")) return;
        CHECK(out[0][0] == row[k].sum || out[0][0] == row[k].or_,
              "%g rows follow of %d lights: they sum up to %g, not %g", (double)row[k].wider, row[k].lights,
              (double)out[0][0], (double)row[k].sum);
    }
}

/* Checks a point that is inside of matter for the picture, and an extra camera before a wall at depth 2. The point is
   open if it is before the wall by more than two pixels there, which are 2/32 of its depth. */
static void view_slack(void)
{
    static const float m[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, -1.002002f, -1, 0, 0, -0.2002002f, 0 };
    static float wall[MANY];
    const ssgi_gl_desc d = desc_of("ssao", "views=1,directions=4,depth=linear,thickness=solid");
    const ssgi_gl_frame frame = seen_by(m, SSGI_CLIP_GL, SIDE, SIDE, 1);
    int open = 0;
    CHECK(ssgi_gl_views_set(&probed, 0, &view, still, still, NULL) == SSGI_OK, "refused");
    for (int i = 0; i < MANY; ++i) {
        map[i][0] = 1;
        wall[i] = (0.5f - view.depth[0]) / view.depth[1];
        ssgi_view_position(in[i], &view, 5.5f + (float)(i % 50), 9.5f + (float)(i / 97), 1.5f + 0.6f * (float)i / MANY);
    }
    layers_of(wall, 1, GL_R32F);
    if (!probe_map(&d, &frame, "o = vec4(ssgi_occlusion_at(a.xyz));")) return;
    for (int i = 0; i < MANY; ++i) {
        const double z = -(double)in[i][2], from = 2 / (1 + 2.0 / 32);
        CHECK(fabs(z - from) <= 1e-3 || out[i][0] == (z > from), "at depth %g, where two pixels end at %g: %g", z, from,
              (double)out[i][0]);
        open += out[i][0] < 0.5f;
    }
    CHECK(open > MANY / 2 && open < MANY, "%d of %d are open", open, MANY);
}

/* Checks one bright pixel by level: 2^l pixels are averaged, of the 2^l + 1 around one, whose ends share a weight. */
static void smooth_weights(void)
{
    enum { LEVELS = 4 };
    static float got[LEVELS * MANY], level[LEVELS * MANY], depth[MANY];
    ssgi_gl_desc d = desc_of("smooth", "levels=4,orthographic=1,depth=linear");
    const given t[3] = { { "t_ssgi_levels", GL_R32F, SIDE, LEVELS * SIDE, 0, level },
                         { "t_ssgi_depth", GL_R32F, SIDE, SIDE, 0, depth },
                         { "t_ssgi_normal", GL_RGBA32F, SIDE, SIDE, 0, map } };
    ssgi_gl_frame frame = facing(1);
    memset(map, 0, sizeof map);
    for (int i = 0; i < MANY; ++i) map[i][2] = 1, depth[i] = 5;
    for (int l = 0; l < LEVELS; ++l) level[l * MANY + CENTRE] = 1;
    for (d.surfel.axis = 0; d.surfel.axis < 2; ++d.surfel.axis) {
        const int axis = d.surfel.axis;
        if (!pass_drawn(got, 0, 1, SIDE, LEVELS * SIDE, &d, &frame, t, 3)) return;
        for (int l = 0; l < LEVELS; ++l)
            for (int k = -8; k <= 8; ++k) {
                const int reach = 1 << l >> 1, away = abs(k);
                const double want = away > reach ? 0 : (away == reach && l ? 0.5 : 1) / (1 << l),
                             is = (double)got[l * MANY + CENTRE + k * (axis ? SIDE : 1)];
                CHECK(fabs(is - want) < 1e-6, "axis %d, level %d, %d away: %g, not %g", axis, l, k, is, want);
            }
    }
    /* a texel beside it, at 0.7 of the largest difference that counts: of its weight of a half 0.3 is left */
    depth[CENTRE - 1] -= 0.7f * 2 * ssgi_pixel_footprint(&view, 5);
    d.surfel.axis = 0;
    if (!pass_drawn(got, 0, 1, SIDE, LEVELS * SIDE, &d, &frame, t, 3)) return;
    CHECK(fabs((double)got[MANY + CENTRE] - 1 / 1.65) < 1e-5, "beside a step: %g", (double)got[MANY + CENTRE]);
}

/* Checks one bright pixel: the variance is that of a radius of two deviations, and a pixel's: 5/4 for 2 pixels. */
static void gaussian_weights(void)
{
    static float got[MANY], ao[MANY][2];
    const ssgi_gl_desc d = desc_of("blur", "filter=gaussian,filter_radius=2,orthographic=1");
    const given t = { "t_ssgi_ao", GL_RG32F, SIDE, SIDE, 0, ao };
    ssgi_gl_frame frame = facing(1);
    for (int i = 0; i < MANY; ++i) ao[i][0] = i == CENTRE, ao[i][1] = 5;
    if (!pass_drawn(got, 0, 1, SIDE, SIDE, &d, &frame, &t, 1)) return;
    for (int i = 0; i < 25; ++i) {
        const int x = i % 5 - 2, y = i / 5 - 2;
        NEAR(got[CENTRE + y * SIDE + x] / got[CENTRE], exp(-0.4 * (x * x + y * y)), 1e-5, "a share of the centre's");
    }
}

/* Checks that an emitter seen by its unseen side sends 0.35 of its front's light, and edge-on nothing; a second slab
   behind it sends half. With two_sided it always sends all. */
static void unseen_sides(void)
{
    static const struct { float d[3], share[3]; } row[] = {    /* the normal is +z: before it, behind it, beside it */
        { { 0.3f, 0, -1 }, { 1, 1, 1 } },       { { 0, 0.2f, 1 }, { 0.35f, 0.35f, 1 } },
        { { 1, 0, -0.04f }, { 1, 1, 1 } },      { { 1, 0, 0.04f }, { 0.35f, 0.35f, 1 } },
        { { 0, 1, -0.02f }, { 0, 0, 1 } },      { { 0, -1, 0.02f }, { 0, 0, 1 } } };
    static const char *const words[] = { "thickness=solid", "thickness=slabs", "thickness=solid,two_sided=1" };
    enum { ROWS = (int)(sizeof row / sizeof row[0]) };
    static uint32_t emitter[MANY][2];
    const ssgi_gl_frame frame = { .radius = 1 };
    for (int i = 0; i < MANY; ++i) {
        emitter[i][0] = 256u | 128u << 9 | 64u << 18 | 16u << 27;           /* packs a light of 1, 1/2, 1/4 */
        emitter[i][1] = 32u | 32u << 6;
    }
    for (int kind = 0; kind < 3; ++kind) {
        ssgi_gl_desc d = desc_of("ssdo", words[kind]);
        d.light.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE;
        for (int i = 0; i < ROWS; ++i) memcpy(in[i], row[i].d, sizeof row[i].d);
        layers_of(emitter, 1, GL_RG32UI);
        if (!probe(&d, &frame, "ssgi_sums s = ssgi_sums_none(vec3(0.0, 0.0, 1.0));"
                               "ssgi_add_sent(s, ivec2(0), a.xyz, 0.125, 0.25); o = vec4(s.bounce, 0.0);"))
            return;
        for (int i = 0; i < 3 * ROWS; ++i) {
            const float want = 0.125f * row[i / 3].share[kind] + (kind == 1 ? 0.5f * 0.25f : 0);
            NEAR(out[i / 3][i % 3], ldexpf(want, -(i % 3)), 1e-6, "ssgi_add_sent");
        }
    }
}

/* Checks a surfel that faces receivers at growing distances: its form factor is r^2 / (d^2 + r^2). Slices have all of
   that up to half a span, and less and less up to a whole span, if they see the surfel: before the eye, within two
   radii of the depth at its pixel; other pixels have another depth. A surfel that they see, and that faces the eye,
   sends the light of the picture's surface, others their own. */
static void slices_see_surfels(void)
{
    static const struct { float x, z, radius, toward; int seen; } row[] = {
        { 0.06f, -10, 0.3f, -1, 1 },     { 0.06f, -9.41f, 0.3f, -1, 1 },  { 0.06f, -9.39f, 0.3f, -1, 0 },
        { 0.06f, -10.59f, 0.3f, -1, 1 }, { 0.06f, -10.61f, 0.3f, -1, 0 }, { 0.07f, -10, 0.3f, -1, 0 },
        { -0.01f, -10, 0.3f, -1, 0 },    { 2.1f, -50, 0.3f, -1, 0 },      { 0.06f, -0.001f, 5.1f, -1, 1 },
        { 0.06f, 0.001f, 5.1f, -1, 0 },  { 0.06f, -10, 0.3f, 1, 1 },      { 0.06f, -9.39f, 0.3f, 1, 0 } };
    static const float own[3] = { 0.75f, 1, 2 };
    static float got[MANY][4], depth[2 * MANY];
    static uint32_t texel[MANY][4], emitter[MANY][2];
    const ssgi_gl_desc d = desc_of("dss", "orthographic=1,levels=1,span=8,effect=bounce,depth=linear");
    const given t[3] = { { "t_ssgi_interleaved", GL_RGBA32UI, SIDE, SIDE, 0, texel },
                         { "t_ssgi_depth", GL_R32F, 2 * SIDE, SIDE, 0, depth },
                         { "t_ssgi_emitters", GL_RG32UI, SIDE, SIDE, 1, emitter } };
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
    for (int i = 0; i < 2 * MANY; ++i) depth[i] = i == MANY + SIDE / 2 ? 10 : 50;
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const ssgi_surfel surfel = { .position = { row[k].x, 0.03f, row[k].z }, .radius = row[k].radius,
                                     .normal = { 0, 0, row[k].toward }, .colour = { own[0], own[1], own[2] } };
        ssgi_gl_frame frame = facing(50);
        frame.surfel[0] = 0.25f;
        frame.epsilon = 1e-4f;
        for (int i = 0; i < MANY; ++i) {
            const float P[3] = { row[k].x, 0.03f, row[k].z + row[k].toward * (float)(1.25 * span * (i + 1) / MANY) };
            memcpy(texel[i], P, sizeof P);
            texel[i][3] = row[k].toward < 0 ? 0x80008000u : 0xffffffffu;       /* +z, -z */
        }
        glBufferData(GL_ARRAY_BUFFER, sizeof surfel, &surfel, GL_STATIC_DRAW);
        if (!pass_drawn(got[0], 0, 4, SIDE, SIDE, &d, &frame, t, 3)) return;
        for (int i = 0; i < MANY; ++i) {                       /* the rectangle's lower half */
            const double away = 1.25 * span * (i + 1) / MANY, rr = (double)row[k].radius * (double)row[k].radius,
                         sliced = row[k].seen ? fmax(fmin(2 - 2 * away / span, 1), 0) : 0,
                         form = rr / (away * away + rr) * (1 - sliced);
            if (i % SIDE + i / SIDE >= SIDE - 1) continue;
            NEAR(got[i][3], form, 1e-5, row[k].seen ? "a surfel that slices see" : "one that they do not see");
            for (int c = 0; c < 3; ++c)
                NEAR(got[i][c], form * (row[k].seen && row[k].toward > 0 ? ldexp(1, -c) : (double)own[c]), 2e-5,
                     "its light");
        }
    }
    glBindVertexArray((GLuint)was);
    glDeleteVertexArrays(1, &array);
    glDeleteBuffers(1, &buffer);
}

/* Checks pixel bounds of spheres and of half spheres, also if the near depth cuts them. */
static void twin_spheres(void)
{
    static const float normal[8][3] = {
        [4] = { 0, 0.6f, 0.8f }, { 0.6f, 0, -0.8f }, { -0.8f, 0.36f, -0.48f }, { -0.36f, -0.8f, 0.48f }
    };
    ssgi_gl_desc d = desc_of("aof", "");
    t_seed(41);
    for (int k = 0; k < 8; ++k) {
        char code[160];
        int cut = 0, empty = 0;
        d.input.orthographic = k & 1;
        snprintf(code, sizeof code,
                 "vec3 n = vec3(%g, %g, %g); o = vec4(ssgi_sphere(a, n, vec2(0.0)), ssgi_sphere(a, n, vec2(1.0)));",
                 (double)normal[k][0], (double)normal[k][1], (double)normal[k][2]);
        ssgi_gl_frame frame = off_centre(k & 1);
        frame.near_depth = k < 2 ? frame.near_depth : t_uniform(0.1f, 2);
        for (int i = 0; i < MANY; ++i) {
            const float r = powf(10, t_uniform(-1, 0.5f)),
                        s[4] = { t_uniform(-4, 4), t_uniform(-4, 4), -t_uniform(-2, 6), r };
            memcpy(in[i], s, sizeof s);
        }
        if (!probe_stage(&d, SSGI_GL_STAGE_VERTEX, &frame, 0, code)) return;
        for (int i = 0; i < MANY; ++i) {
            float b[4] = { 0, 0, 0, 0 }, got[4];
            const int is = ssgi__sphere_bounds(b, &view, in[i], normal[k], in[i][3], frame.near_depth);
            for (int c = 0; c < 4; ++c) got[c] = fminf(fmaxf(out[i][c], 0), c & 1 ? 480 : 640);
            if (is) for (int c = 0; c < 4; ++c) NEAR(got[c], b[c], 0.02, "ssgi_sphere");
            else CHECK(got[2] - got[0] < 0.02f || got[3] - got[1] < 0.02f, "a sphere that is not seen is drawn");
            if (in[i][3] - in[i][2] < frame.near_depth)    /* no width is a texel if it is rounded outwards */
                for (int c = 0; c < 4; ++c) NEAR(out[i][c], 0, 0, "ssgi_sphere before the near depth");
            cut += is && -in[i][2] - in[i][3] < frame.near_depth;
            empty += !is;
        }
        CHECK(cut > 100 && empty > 100, "%d spheres are cut, %d not seen", cut, empty);
    }
}

/* Checks parts of a triangle's edges, from the finest surfels in it, wherever it is relative to near plane and eye. */
static void twin_parts(void)
{
    enum { MOST = 40 };
    static const float scale[4] = { 0.002f, 0.5f, 0, MOST };
    ssgi_gl_desc d = desc_of("surfels", "dialect=410,tessellate=1");
    t_seed(43);
    for (int k = 0; k < 2; ++k) {
        int parts[2] = { 0, 0 };
        d.input.orthographic = k;
        ssgi_gl_frame frame = off_centre(k);
        memcpy(frame.surfel, scale, sizeof scale);
        for (int i = 0; i < MANY; ++i) {                   /* view depths, area */
            for (int c = 0; c < 3; ++c) in[i][c] = t_uniform(-1, 2) * (i & 1 ? 1 : 0.3f);
            in[i][3] = powf(10, t_uniform(-3, 0.5f));
        }
        if (!probe_stage(&d, SSGI_GL_STAGE_TESS_CONTROL, &frame, 0, "o = vec4(ssgi_parts(a.xyz, a.w));")) return;
        for (int i = 0; i < MANY; ++i) {
            ssgi__surfel_maker maker = { .view = &view, .scale = { (double)scale[0], (double)scale[1] } };
            ssgi__patch whole = { .area = (double)in[i][3] };
            for (int c = 0; c < 3; ++c) whole.at[c][2] = -(double)in[i][c];
            const double r = ssgi__surfel_finest(&whole, &maker), exact = sqrt((double)in[i][3] / (pi * 3169 * r * r));
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

/* Checks levels, their points, radii, and the corners of triangles that shrink, as in ssgi_surfels. */
static void twin_tessellation(void)
{
    ssgi_gl_desc d = desc_of("surfels", "dialect=410,tessellate=1");
    t_seed(53);
    for (int k = 0; k < 4; ++k) {
        const ssgi_surfel_desc made = { .size = 0.02f, .overhang = k / 2 };
        d.input.orthographic = k & 1;
        d.surfel.overhang = k / 2;
        ssgi_gl_frame frame = off_centre(k & 1);
        CHECK(ssgi_gl_surfels_set(&frame, &view, &made, NULL, NULL) == SSGI_OK, "refused");
        for (int i = 0; i < MANY; ++i) {                   /* discs, view depth, level */
            const float v[4] = { powf(10, t_uniform(-1, 4)), t_uniform(-2, 9), (float)(1 + i % 64), 0 };
            memcpy(in[i], v, sizeof v);
        }
        if (!probe_stage(&d, SSGI_GL_STAGE_TESS_CONTROL, &frame, 0,
                         "o = vec4(ssgi_tess_level(a.x), ssgi_surfel_radius(a.y), ssgi_tess_count(int(a.z)), 0.0);"))
            return;
        for (int i = 0; i < MANY; ++i) {
            const double discs = (double)in[i][0], radius = ssgi_surfel_radius(&view, 0.02, (double)in[i][1]),
                         level = sqrt((4 * discs - 1) / 3) - 1;
            if (fabs(level - nearbyint(level) - 1e-5) > 1e-4)
                NEAR(out[i][0], ssgi_tess_level(pi * discs * 0.09, 0.3), 0, "ssgi_tess_level");
            NEAR(out[i][1], radius, 1e-5 * radius, "ssgi_surfel_radius");
            NEAR(out[i][2], ssgi_tess_count((int)in[i][2]), 0, "ssgi_tess_count");
        }
        for (int i = 0; i < MANY; ++i) {                   /* two corners in the plane of x and y, a radius, which */
            const float v[4] = { t_uniform(0.2f, 3), t_uniform(0.1f, 2), powf(10, t_uniform(-2, 0.5f)),
                                 (float)(i % 3) };
            memcpy(in[i], v, sizeof v);
        }
        if (!probe_stage(&d, SSGI_GL_STAGE_TESS_CONTROL, &frame, 0,
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

/* ---- >>history: how passes read the last frame ------------------------------------------------------------------- */

/* Makes the last frame of a camera that stands, or that went so far sideways and back. */
static ssgi_gl_frame follows(float radius, float by, float back)
{
    ssgi_gl_frame frame = facing(radius);
    float before[16];
    const char *why = "";
    memcpy(before, still, sizeof before);
    before[12] = before[13] = by;
    before[14] = -back;
    CHECK(ssgi_gl_frame_history(&frame, &view, still, before, &why) == SSGI_OK, "%s", why);
    return frame;
}

/* Two frames of a plane at depth 10, as a pass reads them. */
static float now[MANY][4], last[MANY][4], went[MANY][2], means[MANY][2], nearby[MANY], got[MANY][4];

static const given frames[4] = { { "t_ssgi_ao", GL_RGBA32F, SIDE, SIDE, 0, now },
                                 { "t_ssgi_history", GL_RGBA32F, SIDE, SIDE, 0, last },
                                 { "t_ssgi_change_share", GL_R32F, SIDE, SIDE, 0, nearby },
                                 { "t_ssgi_motion", GL_RG32F, SIDE, SIDE, 0, went } };

/* Sets now: value, depth; last: value, depth, mean, frames; the share that changed nearby; the plane's own motion. */
static void plane(float kept, float changed, float x, float y)
{
    for (int i = 0; i < MANY; ++i) {
        const float texel[4] = { 0.5f, 10, 0.5f, kept }, moved[2] = { x, y };
        memcpy(now[i], texel, sizeof texel);
        memcpy(last[i], texel, sizeof texel);
        memcpy(went[i], moved, sizeof moved);
        nearby[i] = changed;
    }
}

/* Checks the last frame's value at a place between four texels: of a ramp the interpolated one, and how much it is
   blurred. A hundredth of a texel counts as none. */
static void history_lies_between(void)
{
    static const float moved[] = { 0, 0.005f, 0.25f, 0.5f, 0.8f };
    const ssgi_gl_desc d = facing_of("history", "");
    for (int i = 0; i < MANY; ++i) {                       /* value, depth, frames */
        const float texel[4] = { (float)(i % SIDE + 2 * (i / SIDE)), 10, 0.5f, 5 };
        memcpy(map[i], texel, sizeof texel);
    }
    for (size_t k = 0; k < sizeof moved / sizeof *moved; ++k) {
        const double by = fmax(1.02 * (double)moved[k] - 0.01, 0);
        ssgi_gl_frame frame = follows(1, moved[k] / 16, 0);
        if (!probe_map(&d, &frame, "vec3 P = ssgi_position(vec2(texel) + 0.5, 10.0);"
                                   "ssgi_last l = ssgi_last_of(texel, P, vec3(0.0, 0.0, 1.0));"
                                   "o = vec4(l.kept.light.x, l.kept.means.y, l.known, l.blurred);"))
            return;
        for (int i = 0; i < MANY; ++i) {
            if (i % SIDE == SIDE - 1 || i / SIDE == SIDE - 1) continue;
            NEAR(out[i][0], (double)map[i][0] + 3 * by, 2e-3, "the ramp");
            NEAR(out[i][1], 5, 1e-4, "frames");
            NEAR(out[i][2], 1, 1e-4, "known");
            NEAR(out[i][3], 2 * by * (1 - by), 1e-3, "blurred");
        }
    }
}

/* Checks that a frame is counted if the last one shows the same plane, up to a pixel beyond its picture. One of four
   texels counts whole if it weighs a quarter. The count is at most 16, between two texels 10.7, between four 8. If .007
   of the space within the radius changed, two frames are left; but things that move by themselves by more than half a
   pixel, by motion vectors, keep theirs. */
static void history_counts_on(void)
{
    static const struct { float by, nearby; int alone; float own, kept; double frames; } cases[] = {
        { 0.25f, 0, 1, 0, 5, 6 },   { 0.45f, 0, 1, 0, 5, 6 },  { 0.55f, 0, 1, 0, 5, 1 },    { 0, 0, 0, 0, 5, 6 },
        { 0, 0, 0, 0, 40, 16 },     { 0, 0, 0, 0.5f, 40, 16 / 1.5 }, { 0.5f, 0, 0, 0, 40, 8 }, { 32.9f, 0, 0, 0, 5, 6 },
        { 33.1f, 0, 0, 0, 5, 1 },   { 0, 0.007f, 0, 0, 5, 2 }, { 0, 1, 0, 0, 5, 1.007 },
        { 0, 1, 0, 0.45f, 5, 1.007 },
        { 0, 1, 0, 0.55f, 5, 6 },   { 0, 1, 0, 2, 5, 6 } };
    ssgi_gl_desc d = facing_of("history", "");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        d.input.motion = cases[k].own > 0;
        ssgi_gl_frame frame = follows(cases[k].alone ? 0.01f : 1, cases[k].by / 16, 0);
        plane(cases[k].kept, cases[k].nearby, cases[k].own, 0);
        for (int i = 0; i < MANY; ++i) if (cases[k].alone && i != CENTRE) last[i][1] = 50;
        if (!pass_drawn(got[0], 0, 4, SIDE, SIDE, &d, &frame, frames, 3 + d.input.motion)) return;
        CHECK(fabs((double)got[CENTRE][3] - cases[k].frames) < 1e-3
                  && (!cases[k].alone || got[CENTRE + 3 * SIDE + 3][3] == 1),
              "case %zu: %g frames, of none %g", k, (double)got[CENTRE][3], (double)got[CENTRE + 3 * SIDE + 3][3]);
    }
}

/* Checks a last frame with a plane that is off by up to twice the slack: half a pixel, a thousandth of the depth, and
   the pixels that a thing moved beyond half a pixel. The difference is measured across the plane, though depths are
   along the view; if the camera came nearer, from the depth that it had before. */
static void history_keeps_its_plane(void)
{
    static const struct { const char *normal; double cosine; float own, nearer, coarser; } row[] = {
        { "0.0, 0.0, 1.0", 1, 0, 0, 1 }, { "0.0, 0.8, 0.6", 0.6, 0, 0, 1 }, { "0.0, 0.0, 1.0", 1, 0, 3, 1 },
        { "0.0, 0.0, 1.0", 1, 1, 0, 1 }, { "0.0, 0.0, 1.0", 1, 3, 0, 1 }, { "0.0, 0.0, 1.0", 1, 0, 0, 1.7f } };
    ssgi_gl_desc d = facing_of("history", "motion=1");
    for (int k = 0; k < (int)(sizeof row / sizeof row[0]); ++k) {
        const double pixel = (double)row[k].coarser / 16;
        const double slack = 0.5 * pixel + 0.001 * 10 + fmax((double)row[k].own - 0.5, 0) * pixel;
        const int moved = (int)row[k].own;
        char fetch[100];
        snprintf(fetch, sizeof fetch, "vec3 ssgi_custom_normal(ivec2 texel) { return vec3(%s); }\n", row[k].normal);
        d.shader.fetch = fetch;
        ssgi_gl_frame frame = follows(1, 0, row[k].nearer);
        frame.last_footprint = row[k].coarser;
        plane(5, 0, 0, -row[k].own);
        for (int i = 0; i < MANY; ++i)
            last[i][1] += row[k].nearer + (float)(slack / row[k].cosine * (4.0 * i / MANY - 2));
        if (!pass_drawn(got[0], 0, 4, SIDE, SIDE, &d, &frame, frames, 4)) return;
        for (int i = 0; i < MANY - (moved + 1) * SIDE; ++i) {  /* it moved up by so many rows */
            const double off = fabs(4.0 * (i + moved * SIDE) / MANY - 2);
            CHECK(fabs(off - 1) <= 2e-3 || (got[i][3] > 1) == (off < 1), "row %d: off by %g of the slack: %g frames", k,
                  off, (double)got[i][3]);
        }
    }
}

/* Checks random last values, and a frame of which half is a checkerboard, half is even. A pixel's value is the mean of
   3x3 texels up to four frames, of five from then on. The mean over three frames goes a third of the way there, and
   stays within 0.7 deviations and 2 %. The mean over all frames, at most 16, goes 1/frames of the way, and stays within
   0.2 deviations and 0.5 % of the former; to be pulled, it forgets up to 0.85 of the frames. Light that becomes three
   times as bright begins anew. */
static void history_follows(void)
{
    static float kept[MANY][4];
    const double tint[2][3] = { { 1, 1, 1 }, { 2, (1 - 2 * 0.2126) / 0.7152, 0 } };   /* as bright as grey */
    int held = 0, pulled = 0, neither = 0, anew = 0;
    t_seed(67);
    for (int colour = 0; colour < 2; ++colour) {
        const ssgi_gl_desc d = facing_of("history", colour ? "quantity=light" : "quantity=visibility");
        const given t[4] = { { colour ? "t_ssgi_light" : "t_ssgi_ao", GL_RGBA32F, SIDE, SIDE, 0, now }, frames[1],
                             frames[2], { "t_ssgi_means", GL_RG32F, SIDE, SIDE, 0, means } };
        ssgi_gl_frame frame = follows(1, 0, 0);
        plane(0, 0, 0, 0);
        for (int i = 0; i < MANY; ++i) {
            const float value = i % SIDE < SIDE / 2 ? 0.5f : (i + i / SIDE) & 1 ? 0.4f : 0.6f,
                        mean = value + t_uniform(-0.4f, 0.3f);
            means[i][0] = mean + t_uniform(-0.1f, 0.1f);
            means[i][1] = t_uniform(0, 20);
            for (int c = 0; c < 3; ++c) {
                now[i][c] = value * (float)tint[colour][c];
                last[i][c] = mean * (float)tint[colour][c];
            }
            now[i][colour ? 3 : 1] = last[i][colour ? 3 : 1] = 10;
            if (!colour) memcpy(&last[i][2], means[i], sizeof means[i]);
        }
        if (!pass_drawn(got[0], colour, 4, SIDE, SIDE, &d, &frame, t, 3 + colour)
            || (colour && !pass_drawn(kept[0], 0, 4, SIDE, SIDE, &d, &frame, t, 4)))
            return;
        for (int i = 0; i < MANY; ++i) {
            const int x = i % SIDE, y = i / SIDE, even = x < SIDE / 2;
            if ((x + 1) % (SIDE / 2) < 2 || (y + 1) % SIDE < 2) continue;          /* other neighbours */
            const double h = even ? 0 : (i + y) & 1 ? -0.1 : 0.1, n = (double)means[i][1],
                         most = n < 1 ? 1 : fmin(n + 1, 16), value = 0.5 + h * (most < 4.5 ? 1 / 9.0 : -3 / 5.0);
            /* expected deviation: of nine texels; of five texels, which are few, also a tenth of the value */
            const double deviation = most < 4.5 ? fabs(h) * sqrt(10 / 9.0) : 1.2 * sqrt(h * h + 0.01 * value * value),
                         jump = 0.7 * deviation + 0.02 * value, drift = 0.2 * deviation + 0.005 * value;
            double quick = value + ((double)means[i][0] - value) * (1 - 1 / fmin(most, 3)),
                   mean = value + ((double)last[i][0] / tint[colour][0] - value) * (1 - 1 / most), count = most;
            held += fabs(quick - value) > jump;
            quick = fmax(fmin(quick, value + jump), value - jump);
            const double by = fmax(fmin(mean, quick + drift), quick - drift) - mean;
            pulled += fabs(by) > 0;
            neither += !(fabs(by) > 0) && n > 3;
            mean += by;
            count = fmax(count * (1 - 0.85 * fmin(fabs(by) / drift, 1)), 1);
            if (colour && by > 2 * (mean - by)) mean = quick = value, count = 1, ++anew;
            for (int c = 0; c < (colour ? 3 : 1); ++c) NEAR(got[i][c], mean * tint[colour][c], 1e-5, "the mean");
            NEAR(colour ? kept[i][0] : got[i][2], quick, 1e-5, "the mean over three frames");
            NEAR(colour ? kept[i][1] : got[i][3], count, 2e-3, "frames");
        }
    }
    CHECK(held > MANY / 4 && pulled > MANY / 4 && neither > MANY / 16 && anew > MANY / 64,
          "%d are held, %d pulled, %d neither, %d begin anew", held, pulled, neither, anew);
}

/* Checks a nearer rectangle that appears or goes, a camera that passes one, and one that moves by a pixel before a
   trembling camera. Of the 4x4 pixels that are tested in a tile, those at its depth that changed count. Depths of one
   surface differ by less than a pixel and a 500th. With motion vectors of 0 fewer than four pixels are an edge. */
static void changes_are_counted(void)
{
    enum { TILES = SIDE / 8, LOW = TILES / 2 - 1, TALL = TILES / 2 };
    static float depth[MANY];
    static const struct { int came, went, wide, high_, motion, moved; float by, depth; double low, high; } cases[] = {
        { 0, 0, 6, 6, 0, 0, 0, 9, 0, 0 },
        { 1, 0, 6, 6, 0, 0, 0, 9, 4 / 16.0, 9 / 16.0 },
        { 0, 1, 6, 6, 0, 0, 0, 9, 4 / 16.0, 9 / 16.0 },
        { 1, 0, 6, 6, 0, 0, 0, 9.915f, 4 / 16.0, 9 / 16.0 },   /* 1/16 and 0.02 */
        { 1, 0, 6, 6, 0, 0, 0, 9.92f, 0, 0 },
        { 1, 1, 6, 6, 0, 1, 0.7f, 9, 0, 0 },
        { 1, 1, 6, 6, 0, 1, 0.03f, 9, 0, 0 },                  /* its edge reached another pixel's centre */
        { 1, 1, 6, 6, 0, 1, 0.015f, 9, 0, 3 / 16.0 },          /* at x = 6, which it left: y = 0, 2 and 4 */
        { 1, 0, 2, 2, 0, 0, 0, 9, 0, 1 / 16.0 },
        { 1, 0, 2, 2, 1, 0, 0, 9, 0, 0 },
        { 1, 0, 3, 7, 0, 0, 0, 9, 3 / 16.0, 8 / 16.0 },
        { 1, 0, 3, 7, 1, 0, 0, 9, 0, 8 / 16.0 },
        { 1, 0, 6, 6, 1, 0, 0, 9, 4 / 16.0, 9 / 16.0 } };
    const given t[3] = { { "t_ssgi_depth", GL_R32F, SIDE, SIDE, 0, depth }, frames[1], frames[3] };
    ssgi_gl_desc d = facing_of("change_mask", "depth=linear");
    for (size_t k = 0; k < sizeof cases / sizeof *cases; ++k) {
        d.input.motion = cases[k].motion;
        ssgi_gl_frame frame = follows(1, cases[k].by / 16, 0);
        plane(5, 0, 0, 0);
        for (int i = 0; i < MANY; ++i) {
            const int x = i % SIDE - SIDE / 2, y = i / SIDE - SIDE / 2, wide = cases[k].wide, high = cases[k].high_;
            const int is = abs(x) < wide && abs(y) < high, was = abs(x - cases[k].moved) < wide && abs(y) < high;
            depth[i] = cases[k].came && is ? cases[k].depth : 10;
            if (cases[k].went && was) last[i][1] = cases[k].depth;
        }
        if (!pass_drawn(got[0], 0, 4, TILES, TILES, &d, &frame, t, 2 + cases[k].motion)) return;
        const float *low = got[LOW * TILES + LOW], *high = got[TALL * TILES + TALL], *away = got[0];
        CHECK(fabs((double)low[0] - cases[k].low) + fabs((double)high[0] - cases[k].high) + (double)away[0] < 1e-6
                  && fabsf(away[1] - 10) + fabsf(away[2] - 10) + fabsf(away[3] - 10) < 1e-3f
                  && (high[0] <= 0 || fabsf(high[1] - cases[k].depth) + fabsf(high[2] - cases[k].depth) < 1e-3f),
              "case %zu: shares %g %g, away %g, depths %g %g", k, (double)low[0], (double)high[0], (double)away[0],
              (double)high[1], (double)high[2]);
    }
}

/* Checks one whole tile that changed, with a radius of two tiles. Within the radius and one tile more, a sixteenth of
   the space has changed, unless the tile is nearer or farther than the radius. With a radius of six tiles every second
   tile is read and counts for four; with one tile a quarter changed. */
static void changes_are_nearby(void)
{
    enum { TILES = SIDE / 8, AT = TILES / 2 };
    static float changes[TILES * TILES][4];
    static const struct { float radius, depth; int tiles, apart; double share; } cases[] = {
        { 1, 9.5f, 3, 1, 1 / 16.0 }, { 1, 8.9f, 0, 1, 0 }, { 1, 11.1f, 0, 1, 1 / 16.0 }, { 3, 9.5f, 7, 2, 4 / 144.0 },
        { 0.5f, 9.7f, 2, 1, 1 / 4.0 } };
    const ssgi_gl_desc d = desc_of("change_share", "orthographic=1");
    const given t = { "t_ssgi_change_mask", GL_RGBA32F, TILES, TILES, 0, changes };
    for (int k = 0; k < (int)(sizeof cases / sizeof *cases); ++k) {
        const float changed[4] = { 1, cases[k].depth, cases[k].depth, 10 };
        ssgi_gl_frame frame = facing(cases[k].radius);
        for (int i = 0; i < TILES * TILES; ++i) changes[i][1] = changes[i][2] = changes[i][3] = 10;
        memcpy(changes[AT * TILES + AT], changed, sizeof changed);
        if (!pass_drawn(outs, 0, 1, TILES, TILES, &d, &frame, &t, 1)) return;
        for (int i = 0; i < TILES * TILES; ++i) {
            const int x = abs(i % TILES - AT), y = abs(i / TILES - AT);
            const int met = x <= cases[k].tiles && y <= cases[k].tiles && !((x | y) % cases[k].apart);
            NEAR(outs[i], met ? cases[k].share : 0, 1e-6, "the share nearby");
        }
    }
}

/* Checks pass history's filter, where 1 to 9 of 3x3 texels show the surface. It takes the mean of these. If they are
   equal, it expects a deviation of a tenth of the mean times sqrt(few (few - 1)), where few is 9 over their number. */
static void history_spreads(void)
{
    const ssgi_gl_desc d = facing_of("history", "");
    ssgi_gl_frame frame = facing(1);
    for (int i = 0; i < MANY; ++i) {                       /* blocks of 4x4: block b holds 1 + b % 9 of the surface */
        const int x = i % SIDE % 4, y = i / SIDE % 4, block = i % SIDE / 4 + SIDE / 4 * (i / SIDE / 4),
                  place = (3 * y + x + 5) % 9;             /* the middle first */
        const int on = x < 3 && y < 3 && place <= block % 9;
        map[i][0] = on ? 0.6f : 0.1f;
        map[i][1] = on ? 10 : 50;
    }
    if (!probe_map(&d, &frame, "ssgi_blurred c = ssgi_blurred_at(texel); c.frames = 1.0;"
                               "ssgi_filtered f = ssgi_filter(texel, c); float mean = f.light.x / f.light.w;"
                               "o = vec4(mean, ssgi_deviation(f, mean), 0.0, 0.0);"))
        return;
    for (int i = 0; i < MANY; ++i) {
        const double few = 9.0 / (1 + (i % SIDE / 4 + SIDE / 4 * (i / SIDE / 4)) % 9);
        if (i % SIDE % 4 != 1 || i / SIDE % 4 != 1) continue;
        NEAR(out[i][0], 0.6, 1e-6, "the mean");
        NEAR(out[i][1], 0.06 * sqrt(few * (few - 1)), 1e-3, "the deviation");
    }
}

/* Checks texels of half size on a plane at depth 10, of which every second one is off it. History averages 4x4 by tents
   of two and a half texels. They count less the farther they are off the plane and the more frames there are. Of a
   settled pixel the four nearest texels count more. All of them count as 7 samples, as their weights fall off. Blur
   averages 3x3 texels by tents of 4 pixels, 5x5 without corners by 5.5. */
static void half_size_spreads(void)
{
    static const struct { const char *pass; int frames, radius; float low, high, most; } row[] = {
        { "history", 1, 0, 0.4f, 0.6f, 0.5f }, { "history", 6, 0, 0.4f, 0.6f, 0.5f },
        { "history", 11, 0, 0.4f, 0.6f, 0.5f }, { "blur", 0, 1, 0, 1, 2 }, { "blur", 0, 2, 0, 1, 2 } };
    const ssgi_gl_frame frame = facing(1);
    t_seed(71);
    for (int r = 0; r < ROWS(row); ++r) {
        const int count = row[r].frames, radius = row[r].radius, side = count ? 4 : 2 * radius + 1;
        const double wide = count ? 5 : 2.5 + 1.5 * radius;
        ssgi_gl_desc d = facing_of(row[r].pass, "resolution=half,depth=custom");
        char statements[300];
        d.filter.radius = radius;
        for (int i = 0; i < MANY; ++i) {    /* off by up to most times a 100th of the radius and a pixel */
            map[i][0] = t_uniform(row[r].low, row[r].high);
            map[i][1] = 10 + t_uniform(0, row[r].most) * (0.01f + 1.0f / 16) * (float)(i & 1);
        }
        snprintf(statements, sizeof statements,
                 "ssgi_blurred c = ssgi_blurred_at(texel); %s = %d.0; ssgi_filtered f = ssgi_filter(texel, c);"
                 "float mean = f.light.x / f.light.w; o = vec4(mean, %s, 0.0, 0.0);",
                 count ? "c.frames" : "float none", count, count ? "ssgi_deviation(f, mean)" : "none");
        if (!probe_map(&d, &frame, statements)) return;
        for (int i = 0; i < MANY; ++i) {
            const int x = i % SIDE, y = i / SIDE;
            double weights = 0, both = 0, sum = 0, squares = 0;
            if (count && (x < 4 || y < 4 || x >= SIDE - 4 || y >= SIDE - 4)) continue;
            for (int k = 0; k < side * side; ++k) {
                const int a = k % side - side / 2 + (count ? x & 1 : 0), b = k / side - side / 2 + (count ? y & 1 : 0),
                          h[2] = { x / 2 + a, y / 2 + b };
                if (h[0] < 0 || h[1] < 0 || 2 * h[0] >= SIDE || 2 * h[1] >= SIDE) continue;
                if (!count && abs(a) + abs(b) == 4) continue;
                const float *const at = map[h[1] * SIDE + h[0]];
                const double tent = (wide - abs(2 * h[0] - x)) * (wide - abs(2 * h[1] - y)), value = (double)at[0],
                             off = ((double)at[1] - 10) / (0.01 + 1.0 / 16),
                             nearest = count > 4 ? (k % 4 % 3 && k / 4 % 3) * (12 + tent) : 1,
                             weight = nearest * tent / ((count ? 0.3 / count : 0.1) + off * off);
                weights += weight, both += weight * weight;
                sum += weight * value, squares += weight * value * value;
            }
            const double mean = sum / weights, share = both / (weights * weights), few = 7 * share,
                         variance = (squares / weights - mean * mean) / fmax(1 - share, 0.2);
            NEAR(out[i][0], mean, 1e-5, "the mean");
            if (count)
                NEAR(out[i][1], sqrt((variance + 0.01 * mean * mean * fmax(few - 1, 0)) * few), 1e-4, "the deviation");
        }
    }
}

/* Checks that at half resolution the four pixels are drawn in turn, equally often and with any directions. Texels
   beyond the image stay beyond it. */
static void pixels_take_turns(void)
{
    const ssgi_gl_desc d = desc_of("hsao", "resolution=half_in_turn,orthographic=1");
    int drawn[4][4] = { { 0 } };
    ssgi_gl_frame frame = facing(1);
    for (uint32_t k = 0; k < 64; ++k) {
        frame.phase = ssgi_gl_phase(k);
        if (!probe_map(&d, &frame, "o = vec4(ssgi_gathered(ivec2(4, 6)), ssgi_gathered(ivec2(1000)));")) return;
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

/* Checks that at a quarter sixteen frames draw each pixel of a 4x4 once, and any four successive frames one of each 2x2
   of it. A filter's texel 0, 0 is that of the nearest gathered pixel. */
static void quarters(void)
{
    ssgi_gl_frame frame = facing(1);
    for (int turns = 0; turns < 2; ++turns) {
        const ssgi_gl_desc d = desc_of("blur", turns ? "resolution=quarter-in-turn" : "resolution=quarter");
        int met[16] = { 0 }, quadrant[32] = { 0 };
        for (uint32_t k = 0; k < (turns ? 32 : 1); ++k) {
            frame.phase = ssgi_gl_phase(k + 3);
            for (int i = 0; i < MANY; ++i) in[i][0] = (float)(20 + i / 2 % 8), in[i][1] = (float)(20 + i / 16 % 8);
            if (!probe_map(&d, &frame, "ivec2 p = ivec2(a.xy); ssgi_neighbour t = ssgi_neighbour_at(p, 0, 0),"
                                       " s = ssgi_neighbour_at(p, -1, 1);"
                                       "o = texel.x % 2 == 0 ? vec4(t.texel, t.pixel)"
                                       " : vec4(t.offset, s.pixel - t.pixel);"))
                return;
            for (int i = 0; i < MANY / 2; ++i) {
                const float *of = out[2 * i], *rest = out[2 * i + 1], *pixel = in[2 * i];
                const int x = (int)(of[2] - 4 * of[0]), y = (int)(of[3] - 4 * of[1]); /* in its 4x4 */
                int right = x >= 0 && x < 4 && y >= 0 && y < 4 && (turns || (!x && !y)) && fabsf(rest[2] + 4) < 0.1f
                         && fabsf(rest[3] - 4) < 0.1f;
                for (int c = 0; c < 2; ++c)
                    right &= fabsf(rest[c]) < 2.5f && fabsf(pixel[c] + rest[c] - of[2 + c]) < 0.1f;
                if (!CHECK(right, "frame %u, pixel %g %g: texel %g %g of pixel %g %g, %g %g away", k, (double)pixel[0],
                           (double)pixel[1], (double)of[0], (double)of[1], (double)of[2], (double)of[3],
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

void test_twins(void)
{
    kit_error err = { "" };
    RUN("extra cameras and shadow maps see what ssgi_view_project says, and lead back", cameras);
    RUN("a frame's light is the world's, turned, word by word", frame_light);
    RUN("any few frames' phases spread as multiples of the golden ratio do, in every quarter", phases_spread);
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("depth, position, projection, footprint and offset as in C", twin_views);
    RUN("noise as in C", twin_noise);
    RUN("normals of every encoding and frame come back", twin_normals);
    RUN("what emitters pack comes back, as its format says", twin_emitters);
    RUN("an extra camera's points as in C", twin_views_of_others);
    RUN("harmonics of one to four bands in both languages as in C", twin_harmonics);
    RUN("a quarter of the size: the nearest pixel of those that are gathered, each in its turn", quarters);
    RUN("halves, where the language has them and where it has not", twin_halves);
    RUN("the shader's fields are the CPU's: turned, scaled and moved", twin_fields);
    RUN("functions of numbers are what their comments say", functions_of_numbers);
    RUN("a slice leaves out taps below 0.004 over the plane, and beyond the normal below 0.4", slices_limits);
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
    RUN("of half size texels count by tents and planes, the nearest more where frames are averaged, no corners",
        half_size_spreads);
    RUN("of half size each pixel of four is drawn in turn", pixels_take_turns);
    kit_gl_close();
}
