/* test_occluders.c - fields of occluders, drawn: the shader against the CPU, pictures against closed forms and the
   truth, the pixels that a draw covers, the combination of occluders. */
#include "t.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;

enum { W = 160, H = 90, POINTS = 64 * 64 };

/* Makes a matrix: a turn about an axis, a uniform scale and a shift. */
static void placed(float m[16], float angle, float scale, float x, float y, float z)
{
    const float u[3] = { 0.48f, 0.64f, 0.6f }, c = cosf(angle), s = sinf(angle);
    const float cross[9] = { 0, u[2], -u[1], -u[2], 0, u[0], u[1], -u[0], 0 };
    memset(m, 0, 16 * sizeof *m);
    for (int k = 0; k < 3; ++k)
        for (int i = 0; i < 3; ++i)
            m[4 * k + i] = scale * ((i == k ? c : 0) + s * cross[3 * k + i] + (1 - c) * u[k] * u[i]);
    m[12] = x;
    m[13] = y;
    m[14] = z;
    m[15] = 1;
}

/* ---- the functions of ssgi_gl_field against their twins ---------------------------------------------------------- */

/* Evaluates an expression at POINTS points with the functions of desc; each point gives it two vec4. textures:
   t_ssgi_occluders, _fields, and with cap_table _cap. Returns 0 on failure. */
static int evaluated(float *out, const ssgi_gl_desc *desc, const char *expression, const float *first,
                     const float *second, const GLuint *textures)
{
    enum { UNITS = 5 };
    static const char *const names[UNITS] = { "t_ssgi_occluders", "t_ssgi_fields", "u_first", "u_second",
                                              "t_ssgi_cap" };
    static const GLenum kinds[UNITS] = { GL_TEXTURE_2D, GL_TEXTURE_2D_ARRAY, GL_TEXTURE_2D, GL_TEXTURE_2D,
                                         GL_TEXTURE_2D };
    static char text[20000];
    GLuint framebuffer, target = kit_texture(64, 64, GL_RGBA32F, NULL), program;
    GLuint unit[UNITS] = { textures[0], textures[1] };
    size_t n = ssgi_gl_field(text, sizeof text, desc);
    int ok;
    snprintf(text + n, sizeof text - n,
             "uniform sampler2D u_first, u_second;\nlayout(location = 0) out vec4 o;\nvoid main() { vec4 a = "
             "texelFetch(u_first, ivec2(gl_FragCoord.xy), 0), "
             "b = texelFetch(u_second, ivec2(gl_FragCoord.xy), 0); o = vec4(%s); }\n",
             expression);
    program = kit_program_text("",
                               "void main() { gl_Position = vec4(float((gl_VertexID & 1) * 4) - 1.0, "
                               "float((gl_VertexID & 2) * 2) - 1.0, 0.0, 1.0); }\n",
                               text, &err);
    if (!CHECK(program != 0, "%s", err.text)) return 0;
    unit[2] = kit_texture(64, 64, GL_RGBA32F, first);
    unit[3] = kit_texture(64, 64, GL_RGBA32F, second);
    if (desc->input.cap_table) unit[4] = textures[2];
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, target, 0);
    glViewport(0, 0, 64, 64);
    glUseProgram(program);
    for (GLint k = 0; k < UNITS; ++k) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)k);
        glBindTexture(kinds[k], unit[k]);
        glUniform1i(glGetUniformLocation(program, names[k]), k);
    }
    glDrawArrays(GL_TRIANGLES, 0, 3);
    for (GLint k = UNITS - 1; k >= 0; --k) {
        glActiveTexture(GL_TEXTURE0 + (GLenum)k);
        glBindTexture(kinds[k], 0);
    }
    FREED float *texels = malloc(4 * POINTS * sizeof *texels);
    ok = texels && CHECK(!kit_texture_read(target, 64, 64, 4, texels), "it cannot be read");
    for (int i = 0; i < POINTS && ok; ++i) out[i] = texels[4 * i];
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteProgram(program);
    glDeleteTextures(2, unit + 2);
    glDeleteTextures(1, &target);
    return ok;
}

/* Checks caps by the closed form and a table. x: the cap's share of a half space; both grids, and beyond the table. */
static void caps(void)
{
    static float at[4 * POINTS], out[POINTS], table[48 * 48];
    ssgi_cap_table(table, 48, NULL);
    for (int tabled = 0; tabled < 2; ++tabled) {
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_AOF, .input.cap_table = tabled };
        const GLuint texture[3] = { 0, 0, tabled ? kit_texture(48, 48, GL_R32F, table) : 0 };
        double worst = 0;
        for (int i = 0; i < POINTS; ++i) {
            const float x = (float)(i % 64) / 63, y = (float)(i / 64) / 63, small = powf(10, (float)(55 - i % 64));
            at[4 * i] = tabled ? 2.1f * x - 0.05f : i % 64 < 56 ? (float)(i % 64) / 55 : small;
            at[4 * i + 1] = tabled ? 2.2f * y - 1.1f : 2 * y - 1;
        }
        if (!evaluated(out, &d, tabled ? "ssgi_cap_table(a.x, a.y)" : "ssgi_cap(1.0 - a.x, a.x * (2.0 - a.x), a.y)", at,
                       at, texture))
            return;
        for (int i = 0; i < POINTS; ++i) {
            const float exact = (float)ssgi_cap_occlusion(2 * pi * (double)at[4 * i], (double)at[4 * i + 1]);
            worst = fmax(worst, fabs((double)(out[i] - exact)));
        }
        CHECK(tabled ? worst < 2e-3 && worst > 1e-4 : worst < 1e-5, "table %d: off by %.2g", tabled, worst);
        t_note("%s: off by at most %.1e", tabled ? "a table of 48" : "closed form", worst);
        glDeleteTextures(1, &texture[2]);
    }
}

static int scene_of(kit_scene *scene, kit_gbuffer *g, const char *name, const kit_camera *camera)
{
    return see(scene, g, name, NULL, 0, camera, W, H);
}

/* Returns the occlusion of a point with a normal by a field that is placed elsewhere. */
static double occluded(const ssgi_field *f, const ssgi_field_limits *l, const float to[16], const float p[3],
                       const float n[3])
{
    const float square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
    float q[3] = { 0 }, turned[3] = { 0 };
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) {
            q[k] += to[4 * k + j] * (p[j] - to[12 + j]) / square;
            turned[k] += to[4 * k + j] * n[j] / sqrtf(square);
        }
    return (double)ssgi_field_occlusion(f, l, q, turned);
}

/* Returns the field of an object of a built-in scene. */
static const ssgi_field *field_of(const kit_scene *scene, int object, int resolution)
{
    const ssgi_field_desc d = { .resolution = resolution, .radii = 8, .rays = 64 };
    const ssgi_field *f = kit_field(&scene->shape[scene->object[object].shape], &d, NULL, &err);
    CHECK(f != NULL, "%s", err.text);
    return f;
}

static void same_as_on_the_cpu(void)
{
    static float first[4 * POINTS], second[4 * POINTS], out[POINTS], expected[POINTS];
    OWN(kit_scene) scene = { 0 };
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
    for (int m = 0; m < 5; ++m) {
        const ssgi_field *f[2] = { field_of(&scene, 3 + m % 4, 8), field_of(&scene, 12, 5) };
        ssgi_field full;                       /* a field whose hull ends at its reach */
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_AOF };
        ssgi_gl_occluder occluder[2];
        GLuint textures[2];
        float to[2][16];
        double worst = 0, sum = 0;
        const char *why = "";
        if (!f[0] || !f[1]) return;
        if (m == 4) {
            full = *f[0];
            full.reach = full.low[3];
            full.span[3] = 0;
            f[0] = &full;
        }
        for (int k = 0; k < 2; ++k) {
            ssgi_field_limits l = ssgi_field_limits_of(f[k]);
            l.ramp *= 0.5f + 0.2f * (float)k;
            l.power = 1.7f;
            placed(to[k], 0.7f + (float)m, k ? 0.4f : 3, 1, -2.5f * (float)k, 0.5f);
            if (!CHECK(ssgi_gl_occluder_set(&occluder[k], f[k], &l, to[k], k, 5 + k, &why) == SSGI_OK, "%s", why))
                return;
        }
        /* points in view space around the first occluder, also in its hull, with any normals */
        for (int i = 0; i < POINTS; ++i) {
            float p[3], n[3];
            direction(p);
            direction(n);
            const float r = occluder[0].radius * (i % 4 ? powf(t_uniform(0, 1), 3) : 0.2f * t_uniform(0, 1));
            for (int k = 0; k < 3; ++k) { first[4 * i + k] = occluder[0].at[k] + r * p[k]; second[4 * i + k] = n[k]; }
            first[4 * i + 3] = second[4 * i + 3] = 0;
            expected[i] = 1;
            for (int c = 0; c < 2; ++c) {
                const ssgi_field_limits l = { occluder[c].ramp, occluder[c].reach, occluder[c].inside,
                                              occluder[c].power };
                expected[i] *= (float)(1 - occluded(f[c], &l, to[c], &first[4 * i], n));
            }
        }
        textures[0] = kit_texture(10, 2, GL_RGBA32F, occluder[0].at);
        textures[1] = kit_field_atlas(f, 2);
        if (!evaluated(out, &d, "ssgi_field_visibility(2, 0, a.xyz, b.xyz)", first, second, textures)) return;
        for (int i = 0; i < POINTS; ++i) {
            worst = fmax(worst, fabs((double)out[i] - (double)expected[i]));
            sum += (double)expected[i] / POINTS;
        }
        CHECK(worst < 2e-5 && sum < 0.95, "%d: off by %.2g, mean %.3f", m, worst, sum);
        t_note("off by %.1e at most", worst);
        if (!m) {                              /* the occluder that is the object itself is left out */
            if (!evaluated(out, &d,
                           "abs(ssgi_field_visibility(1, 5, a.xyz, b.xyz) - 1.0) + abs(ssgi_field_visibility(2, 6, "
                           "a.xyz, b.xyz) - ssgi_field_visibility(1, 0, a.xyz, b.xyz))",
                           first, second, textures))
                return;
            for (int i = 0; i < POINTS; ++i) CHECK(out[i] < 1e-6f, "own object: off by %g", (double)out[i]);
        }
        glDeleteTextures(2, textures);
    }
}

/* ---- pictures ---------------------------------------------------------------------------------------------------- */

static int drawn_aof(kit_image *out, kit_gbuffer *g, const kit_scene *scene, const char *set)
{
    const kit_world world = { scene, NULL };
    kit_method m;
    OWN(kit_run) run = { 0 };
    if (!TRY(kit_method_find(&m, "aof", &err)) || !TRY(kit_method_set(&m, "field_resolution=8,radii=8,rays=64", &err))
        || !TRY(kit_method_set(&m, set, &err)) || !TRY(kit_run_open(&run, g, &m, 1, &world, &err)))
        return 0;
    kit_run_draw(&run, 0);
    return TRY(kit_run_read(out, &run, &err));
}

/* Checks every pixel of the plane against the closed form of a ball that rests on it. The ball and the background stay
   open. By a table the picture keeps the error that the table's size allows. */
static void ball_on_a_plane(void)
{
    static const struct { const char *set; double most; } tables[] = { { "cap_table=128", 6.6e-4 },
                                                                       { "cap_table=32", 2.9e-3 } };
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    OWN(kit_image) closed = { 0 }, frame = { 0 };
    double off = 0, sum = 0;
    int plane = 0, own = 0;
    if (!scene_of(&scene, &g, "sphere", NULL) || !drawn_aof(&closed, &g, &scene, "")
        || !TRY(kit_gbuffer_read(&frame, &g, &err)))
        return;
    for (int i = 0; i < W * H; ++i) {
        const float z = kit_image_channel(&frame, "Z")[i];
        float p[3];
        if (z > 0) kit_camera_point(&g.camera, i % W, i / W, (double)z, p);
        const double rho2 = z > 0 ? (double)(p[0] * p[0] + p[2] * p[2]) : 0, dark = 1 - (double)closed.data[i];
        if (!(z > 0) || p[1] > 1e-3f) own += closed.data[i] < 1;
        else if (rho2 < 25) {              /* farther away, occlusion is that of the ramp */
            off = fmax(off, fabs(dark - pow(1 + rho2, -1.5)));
            sum += dark;
            ++plane;
        }
    }
    CHECK(off < 0.012 && plane > 1000 && sum > 0.05 * plane && !own,
          "off by %.4f over %d pixels (mean %.3f), %d of the ball's own shaded", off, plane, sum / plane, own);
    t_note("off by %.4f at most", off);
    for (int n = 0; n < 2; ++n) {
        OWN(kit_image) out = { 0 };
        double worst = 0;
        if (!drawn_aof(&out, &g, &scene, tables[n].set)) return;
        for (int i = 0; i < W * H; ++i) worst = fmax(worst, fabs((double)out.data[i] - (double)closed.data[i]));
        CHECK(worst < tables[n].most && worst > 0.01 * tables[n].most, "%s: off by %.2e", tables[n].set, worst);
        t_note("%s: off by at most %.1e", tables[n].set, worst);
    }
}

/* Checks that a draw covers each occluder's sphere of influence: seen from outside, from within, beside the picture and
   behind the eye. Each leaves its share of what the others leave: compared with the product over all occluders at every
   pixel, on the CPU. In the last row no object occludes. */
static void what_a_draw_covers(void)
{
    static const struct { float eye[3], target[3], fovy, height; int depth;
    } camera[] = { { { 0, 6, 12 }, { 0, 0, 0 }, 45, 0, KIT_DEPTH_NORMAL },
                   { { 0.3f, 1.2f, 0.5f }, { 3, 0, -2 }, 100, 0, KIT_DEPTH_INFINITE },
                   { { 6, 8, 4 }, { 0, 0, 0 }, 0, 9, KIT_DEPTH_REVERSED },
                   { { 1, 9, 1 }, { 1, 0, 1.01f }, 30, 0, KIT_DEPTH_NORMAL },
                   { { -5, 2, 0 }, { 5, 1, 0.4f }, 60, 0, KIT_DEPTH_NORMAL },
                   { { 0, 6, 12 }, { 0, 0, 0 }, 45, 0, KIT_DEPTH_NORMAL } };
    enum { SHAPES = 8 };
    const char *set = "reach=2.5,ramp=0.6";
    double worst = 0;
    for (int m = 0; m < ROWS(camera); ++m) {
        OWN(kit_scene) scene = { 0 };
        OWN(kit_gbuffer) g = { 0 };
        kit_camera c;
        OWN(kit_image) out = { 0 }, frame = { 0 };
        if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
        c = scene.camera;
        memcpy(c.eye, camera[m].eye, sizeof c.eye);
        memcpy(c.target, camera[m].target, sizeof c.target);
        c.fovy = camera[m].fovy;
        c.ortho_height = camera[m].height;
        c.depth = camera[m].depth;
        c.shift[0] = 7;
        c.width = W;
        c.height = H;
        const int margin[4] = { 5, 3, 2, 9 };
        kit_scene_move(&scene, 0.2 * m);
        for (int o = 0; o < scene.objects; ++o) scene.object[o].casts &= m + 1 < ROWS(camera);
        if (!TRY(kit_gbuffer_from_scene(&g, &scene, &c, margin, &err)) || !drawn_aof(&out, &g, &scene, set)
            || !TRY(kit_gbuffer_read(&frame, &g, &err)))
            return;
        float view[16], projection[16];
        FREED float *number = malloc((size_t)g.width * (size_t)g.height * sizeof *number);
        kit_camera_matrices(&g.camera, view, projection);
        CHECK(!kit_texture_read(g.object, g.width, g.height, 1, number), "object numbers cannot be read");
        const ssgi_field_desc d = { .resolution = 8, .radii = 8, .rays = 64, .reach = 2.5f };
        const ssgi_field *field[SHAPES] = { NULL };
        double off = 0;
        int met = 0;
        if (!CHECK(scene.shapes <= SHAPES, "%d shapes", scene.shapes)) return;
        for (int o = 0; o < scene.objects; ++o) {
            const int shape = scene.object[o].shape;
            if (scene.object[o].casts
                && !CHECK((field[shape] = kit_field(&scene.shape[shape], &d, NULL, &err)) != NULL, "%s", err.text))
                return;
        }
        for (int i = 0; i < W * H; ++i) {
            const float z = kit_image_channel(&frame, "Z")[i];
            uint32_t shown;
            double expected = 1;
            int by = 0;
            float p[3], n[3];
            memcpy(&shown, &number[(g.viewport[1] + H - 1 - i / W) * g.width + g.viewport[0] + i % W], sizeof shown);
            if (z > 0) {
                kit_camera_point(&g.camera, i % W, i / W, (double)z, p);
                for (int k = 0; k < 3; ++k) {
                    static const char *const names[3] = { "N.X", "N.Y", "N.Z" };
                    n[k] = 0;
                    for (int j = 0; j < 3; ++j) n[k] += view[4 * k + j] * kit_image_channel(&frame, names[j])[i];
                }
            }
            for (int o = 0; o < scene.objects && z > 0; ++o) {
                const kit_object *object = &scene.object[o];
                if (!object->casts || shown == (uint32_t)o + 1) continue;
                const ssgi_field *f = field[object->shape];
                ssgi_field_limits l = ssgi_field_limits_of(f);
                l.ramp = 0.6f * l.reach;
                const double taken = occluded(f, &l, object->to_world, p, n);
                expected *= 1 - taken;
                by += taken > 0.02;
            }
            off = fmax(off, fabs(expected - (double)out.data[i]));
            met += by > 1;
        }
        worst = fmax(worst, off);
        CHECK(off < 2e-3 && (met > 300) == (m + 1 < ROWS(camera)), "camera %d: off by %.2g, %d pixels see several", m,
              off, met);
    }
    t_note("six cameras, off by %.1e at most", worst);
}

/* Checks what no row of test_arguments.c can break: a field without texels, limits of this field, a sheared matrix. */
static void refusals(void)
{
    OWN(kit_scene) scene = { 0 };
    ssgi_gl_occluder occluder, was;
    float m[16];
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
    const ssgi_field *f = field_of(&scene, 3, 4);
    const ssgi_field_limits fine = ssgi_field_limits_of(f);
    memset(&was, 0x5a, sizeof was);
    occluder = was;
    placed(m, 1, 2, 0, 0, -5);
#define REFUSED(name, ...) T_REFUSED(ssgi_gl_occluder_set(__VA_ARGS__, &why), SSGI_BAD_ARGUMENT, name, occluder, was)
    const ssgi_field none = { .resolution = f->resolution, .reach = f->reach };
    REFUSED("field", &occluder, &none, &fine, m, 0, 0);
    const struct { const char *name; ssgi_field_limits l; } bad[] = {
        { "limits.reach", { fine.reach, fine.reach, fine.inside, 1 } },
        { "limits.reach", { fine.ramp, 1.01f * fine.reach, fine.inside, 1 } },
        { "limits.inside", { fine.ramp, fine.reach, 1.1f, 1 } },
        { "limits.power", { fine.ramp, fine.reach, fine.inside, 0 } } };
    for (int k = 0; k < ROWS(bad); ++k) REFUSED(bad[k].name, &occluder, f, &bad[k].l, m, 0, 0);
    m[4] += m[0];                              /* sheared */
    REFUSED("mesh_to_view", &occluder, f, &fine, m, 0, 0);
#undef REFUSED
    placed(m, 1, 2, 0, 0, -5);
    for (int i = 2; i < 16; i += 4) m[i] = -m[i];          /* a left-handed engine's */
    CHECK(ssgi_gl_occluder_set(&occluder, f, &fine, m, 0, 0, NULL) == SSGI_OK, "a mirrored occluder is refused");
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            float to = 0;
            for (int j = 0; j < 3; ++j) to += occluder.to_field[i][j] * m[4 * k + j];
            CHECK(fabsf(to - (float)(i == k)) < 1e-6f, "a mirrored occluder: %d %d is %g", i, k, (double)to);
        }
}

void test_occluders(void)
{
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("the shader's caps are the CPU's", caps);
    RUN("the shader's fields are the CPU's: turned, scaled and moved", same_as_on_the_cpu);
    RUN("a ball on a plane is its closed form", ball_on_a_plane);
    RUN("a draw covers each occluder's sphere of influence from anywhere, and takes its share of what is left",
        what_a_draw_covers);
    RUN("an occluder that cannot be set is refused", refusals);
    kit_fields_free();
    kit_gl_close();
}
