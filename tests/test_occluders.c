/* test_occluders.c - fields of occluders through the whole of GL: the shader against the CPU, pictures against closed
   forms and truth, what one draw covers, how occluders combine. */
#include "t.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;
#define TRY(call) CHECK(!(call), "%s", err.text)

enum { W = 160, H = 90, POINTS = 64 * 64 };

/* A turn about an axis, a uniform scale, a shift. */
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

/* What an expression is at POINTS points, given as two vec4 a point, with the functions of desc. textures:
   t_ssgi_occluders, _fields, and with cap_table _cap. 0 on failure. */
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
    float *texels = malloc(4 * POINTS * sizeof *texels);
    ok = texels && CHECK(!kit_texture_read(target, 64, 64, 4, texels), "it cannot be read");
    for (int i = 0; i < POINTS && ok; ++i) out[i] = texels[4 * i];
    free(texels);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteProgram(program);
    glDeleteTextures(2, unit + 2);
    glDeleteTextures(1, &target);
    return ok;
}

static void caps(void)
{
    static float at[4 * POINTS], out[POINTS];
    const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_FIELD };
    const GLuint none[2] = { 0, 0 };
    double worst = 0;
    for (int i = 0; i < POINTS; ++i) {         /* a grid with both ends, and small caps */
        at[4 * i] = i % 64 < 56 ? (float)(i % 64) / 55 : powf(10, (float)(55 - i % 64));
        at[4 * i + 1] = 2 * (float)(i / 64) / 63 - 1;
    }
    if (!evaluated(out, &d, "ssgi_cap(1.0 - a.x, a.x * (2.0 - a.x), a.y)", at, at, none)) return;
    for (int i = 0; i < POINTS; ++i)
        worst =
            fmax(worst, fabs((double)out[i] - (double)ssgi_cap_occlusionf(2 * (float)pi * at[4 * i], at[4 * i + 1])));
    CHECK(worst < 1e-5, "off by %.2g", worst);
    t_note("off by at most %.1e", worst);
    /* by a table: beyond both ends, too */
    static float table[48 * 48];
    const ssgi_gl_desc of_table = { .pass = SSGI_GL_PASS_FIELD, .input.cap_table = 1 };
    ssgi_cap_table(table, 48, NULL);
    const GLuint texture[3] = { 0, 0, kit_texture(48, 48, GL_R32F, table) };
    for (int i = 0; i < POINTS; ++i) {
        at[4 * i] = 2.1f * (float)(i % 64) / 63 - 0.05f;
        at[4 * i + 1] = 2.2f * (float)(i / 64) / 63 - 1.1f;
    }
    if (!evaluated(out, &of_table, "ssgi_cap_table(a.x, a.y)", at, at, texture)) return;
    for (int i = 0; i < POINTS; ++i)
        worst =
            fmax(worst, fabs((double)out[i] - (double)ssgi_cap_occlusionf(2 * (float)pi * at[4 * i], at[4 * i + 1])));
    CHECK(worst < 2e-3 && worst > 1e-4, "a table of 48: off by %.2g", worst);
    t_note("a table of 48: off by at most %.1e", worst);
    glDeleteTextures(1, &texture[2]);
}

static int scene_of(kit_scene *scene, kit_gbuffer *g, const char *name, const kit_camera *camera)
{
    return see(scene, g, name, NULL, 0, camera, W, H);
}

/* The field of a built-in scene's object. */
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
    kit_scene scene;
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
    for (int m = 0; m < 5; ++m) {
        const ssgi_field *f[2] = { field_of(&scene, 3 + m % 4, 8), field_of(&scene, 12, 5) };
        ssgi_field full;                       /* a hull that ends where the field does */
        const ssgi_gl_desc d = { .pass = SSGI_GL_PASS_FIELD };
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
        /* in the space of the pass, around the first, in its hull too; normals any */
        for (int i = 0; i < POINTS; ++i) {
            float p[3], n[3];
            direction(p);
            direction(n);
            const float r = occluder[0].radius * (i % 4 ? powf(t_uniform(0, 1), 3) : 0.2f * t_uniform(0, 1));
            for (int k = 0; k < 3; ++k) { first[4 * i + k] = occluder[0].at[k] + r * p[k]; second[4 * i + k] = n[k]; }
            first[4 * i + 3] = second[4 * i + 3] = 0;
            expected[i] = 1;
            for (int c = 0; c < 2; ++c) {
                ssgi_field_limits l = { occluder[c].ramp, occluder[c].reach, occluder[c].inside, occluder[c].power };
                const float square = to[c][0] * to[c][0] + to[c][1] * to[c][1] + to[c][2] * to[c][2];
                float q[3] = { 0 }, turned[3] = { 0 };
                for (int k = 0; k < 3; ++k)
                    for (int j = 0; j < 3; ++j) {
                        q[k] += to[c][4 * k + j] * (first[4 * i + j] - to[c][12 + j]) / square;
                        turned[k] += to[c][4 * k + j] * n[j] / sqrtf(square);
                    }
                expected[i] *= 1 - ssgi_field_occlusion(f[c], &l, q, turned);
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
        if (!m) {                              /* an occluder that is the object itself is left out */
            if (!evaluated(out, &d,
                           "abs(ssgi_field_visibility(1, 5, a.xyz, b.xyz) - 1.0) + abs(ssgi_field_visibility(2, 6, "
                           "a.xyz, b.xyz) - ssgi_field_visibility(1, 0, a.xyz, b.xyz))",
                           first, second, textures))
                return;
            for (int i = 0; i < POINTS; ++i) CHECK(out[i] < 1e-6f, "own object: off by %g", (double)out[i]);
        }
        glDeleteTextures(2, textures);
    }
    kit_scene_free(&scene);
}

/* ---- pictures ---------------------------------------------------------------------------------------------------- */

static int drawn_aof(kit_image *out, kit_gbuffer *g, const kit_scene *scene, const char *set)
{
    const kit_world world = { scene, NULL };
    kit_method m;
    kit_run run;
    int ok = TRY(kit_method_find(&m, "aof", &err)) && TRY(kit_method_set(&m, "resolution=8,radii=8,rays=64", &err))
             && TRY(kit_method_set(&m, set, &err)) && TRY(kit_run_open(&run, g, &m, 1, &world, &err));
    if (!ok) return 0;
    kit_run_draw(&run, 0);
    ok = TRY(kit_run_read(out, &run, &err));
    kit_run_close(&run);
    return ok;
}

/* Every pixel of the plane against the closed form of a resting ball; the ball itself, and the background, are left
   alone. */
static void ball_on_a_plane(void)
{
    kit_scene scene;
    kit_gbuffer g;
    kit_image out;
    if (!scene_of(&scene, &g, "sphere", NULL)) return;
    double worst = 0, sum = 0;
    int plane = 0, own = 0;
    kit_image frame;
    if (!drawn_aof(&out, &g, &scene, "") || !TRY(kit_gbuffer_read(&frame, &g, &err))) return;
    for (int i = 0; i < W * H; ++i) {
        const float z = kit_image_channel(&frame, "Z")[i];
        float p[3];
        if (z > 0) kit_camera_point(&g.camera, i % W, i / W, (double)z, p);
        const double rho2 = z > 0 ? (double)(p[0] * p[0] + p[2] * p[2]) : 0;
        if (!(z > 0) || p[1] > 1e-3f) own += out.data[i] < 1;
        else if (rho2 < 25) {              /* beyond, the ramp */
            worst = fmax(worst, fabs(1 - (double)out.data[i] - pow(1 + rho2, -1.5)));
            sum += 1 - (double)out.data[i];
            ++plane;
        }
    }
    CHECK(worst < 0.012 && plane > 1000 && sum > 0.05 * plane && !own,
          "off by %.4f over %d pixels (mean %.3f), %d of the ball's own shaded", worst, plane,
          sum / plane, own);
    t_note("off by %.4f at most", worst);
    kit_image_free(&frame);
    kit_image_free(&out);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

/* A picture by a table is the closed form's within what the table's size says; one occluder. */
static void tables_of_caps(void)
{
    static const struct { const char *set; double most; } rows[] = { { "cap_table=128", 6.6e-4 },
                                                                     { "cap_table=32", 2.9e-3 } };
    kit_scene scene;
    kit_gbuffer g;
    kit_image closed, out;
    if (!scene_of(&scene, &g, "sphere", NULL) || !drawn_aof(&closed, &g, &scene, "")) return;
    for (int n = 0; n < 2; ++n) {
        double worst = 0;
        if (!drawn_aof(&out, &g, &scene, rows[n].set)) return;
        for (int i = 0; i < W * H; ++i) worst = fmax(worst, fabs((double)out.data[i] - (double)closed.data[i]));
        CHECK(worst < rows[n].most && worst > 0.01 * rows[n].most, "%s: off by %.2e", rows[n].set, worst);
        t_note("%s: off by at most %.1e", rows[n].set, worst);
        kit_image_free(&out);
    }
    kit_image_free(&closed);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

/* A draw covers each occluder's sphere of influence, from outside, from within, beside the picture and behind the eye:
   against all occluders at every pixel, on the CPU. */
static void what_a_draw_covers(void)
{
    static const struct { float eye[3], target[3], fovy, height; int depth;
    } camera[] = { { { 0, 6, 12 }, { 0, 0, 0 }, 45, 0, KIT_DEPTH_NORMAL },
                   { { 0.3f, 1.2f, 0.5f }, { 3, 0, -2 }, 100, 0, KIT_DEPTH_INFINITE },
                   { { 6, 8, 4 }, { 0, 0, 0 }, 0, 9, KIT_DEPTH_REVERSED },
                   { { 1, 9, 1 }, { 1, 0, 1.01f }, 30, 0, KIT_DEPTH_NORMAL },
                   { { -5, 2, 0 }, { 5, 1, 0.4f }, 60, 0, KIT_DEPTH_NORMAL } };
    enum { SHAPES = 8 };
    const char *set = "reach=2.5,ramp=0.6";
    double worst = 0;
    for (int m = 0; m < (int)(sizeof camera / sizeof camera[0]); ++m) {
        kit_scene scene;
        kit_gbuffer g;
        kit_camera c;
        kit_image out, frame;
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
        if (!TRY(kit_gbuffer_from_scene(&g, &scene, &c, margin, &err)) || !drawn_aof(&out, &g, &scene, set)
            || !TRY(kit_gbuffer_read(&frame, &g, &err)))
            return;
        float view[16], projection[16];
        float *number = malloc((size_t)g.width * (size_t)g.height * sizeof *number);
        kit_camera_matrices(&g.camera, view, projection);
        CHECK(!kit_texture_read(g.object, g.width, g.height, 1, number), "object numbers cannot be read");
        const ssgi_field_desc d = { .resolution = 8, .radii = 8, .rays = 64, .reach = 2.5f };
        const ssgi_field *field[SHAPES] = { NULL };
        double off = 0;
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
                const float *t = object->to_world, square = t[0] * t[0] + t[1] * t[1] + t[2] * t[2];
                float q[3] = { 0 }, turned[3] = { 0 };
                l.ramp = 0.6f * l.reach;
                for (int k = 0; k < 3; ++k)
                    for (int j = 0; j < 3; ++j) {
                        q[k] += t[4 * k + j] * (p[j] - t[12 + j]) / square;
                        turned[k] += t[4 * k + j] * n[j] / sqrtf(square);
                    }
                expected *= 1 - (double)ssgi_field_occlusion(f, &l, q, turned);
            }
            off = fmax(off, fabs(expected - (double)out.data[i]));
        }
        worst = fmax(worst, off);
        CHECK(off < 2e-3, "camera %d: off by %.2g", m, off);
        free(number);
        kit_image_free(&out);
        kit_image_free(&frame);
        kit_gbuffer_free(&g);
        kit_scene_free(&scene);
    }
    t_note("five cameras, off by %.1e at most", worst);
}

/* Occluders together lie between the most of them and their sum; a pixel's
   own object makes no difference to others. */
static void combination(void)
{
    kit_scene scene;
    kit_gbuffer g;
    kit_image both, single[2], other;
    int bad = 0, met = 0;
    if (!scene_of(&scene, &g, "boxes", NULL)) return;
    for (int k = 0; k < scene.objects; ++k) scene.object[k].casts = k == 1 || k == 2;
    if (!drawn_aof(&both, &g, &scene, "")) return;
    for (int s = 0; s < 2; ++s) {
        scene.object[1].casts = s == 0;
        scene.object[2].casts = s == 1;
        if (!drawn_aof(&single[s], &g, &scene, "")) return;
    }
    for (int i = 0; i < W * H; ++i) {
        const double a = 1 - (double)single[0].data[i], b = 1 - (double)single[1].data[i],
                     ab = 1 - (double)both.data[i];
        bad += !(ab >= fmax(a, b) - 1e-6 && ab <= fmin(a + b, 1) + 1e-6 && fabs(1 - ab - (1 - a) * (1 - b)) < 1e-6);
        met += a > 0.02 && b > 0.02;
    }
    CHECK(!bad && met > 300, "%d pixels are out of bounds, %d see both", bad, met);
    scene.object[1].casts = scene.object[2].casts = 0;
    if (!drawn_aof(&other, &g, &scene, "")) return;
    for (int i = 0; i < W * H; ++i) bad += other.data[i] != 1;
    CHECK(!bad, "without occluders %d pixels are not open", bad);
    kit_image_free(&other);
    kit_image_free(&both);
    for (int s = 0; s < 2; ++s) kit_image_free(&single[s]);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

/* Against rays: share of no occlusion's error, and what a coarse cube map loses. */
static void against_truth(void)
{
    static const struct {
        const char *set;
        double share;
    } row[] = { { "rays=32", 0.16 }, { "resolution=4,rays=32", 0.18 }, { "normal=depth,rays=32", 0.25 } };
    kit_scene scene;
    kit_gbuffer g;
    kit_image truth, out, none;
    kit_score score, nothing;
    if (!scene_of(&scene, &g, "casters", NULL) || !TRY(kit_truth_objects(&truth, &scene, &g.camera, 64, 1, &err))
        || !TRY(kit_image_new(&none, W, H, "Y", &err)))
        return;
    for (int i = 0; i < W * H; ++i) none.data[i] = 1;
    TRY(kit_score_channel(&nothing, &none, &truth, "Y", NULL, &err));
    for (int m = 0; m < (int)(sizeof row / sizeof row[0]); ++m) {
        if (!drawn_aof(&out, &g, &scene, row[m].set)) return;
        TRY(kit_score_channel(&score, &out, &truth, "Y", NULL, &err));
        CHECK(score.rmse < row[m].share * nothing.rmse, "%s: RMSE %.4f of %.4f", row[m].set, score.rmse, nothing.rmse);
        t_note("%s: RMSE %.4f, %.3f of no occlusion's, bias %+.4f", *row[m].set ? row[m].set : "default", score.rmse,
               score.rmse / nothing.rmse, score.bias);
        kit_image_free(&out);
    }
    kit_image_free(&truth);
    kit_image_free(&none);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

static void refusals(void)
{
    kit_scene scene;
    ssgi_gl_occluder occluder, was;
    float m[16];
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
    const ssgi_field *f = field_of(&scene, 3, 4);
    const ssgi_field_limits fine = ssgi_field_limits_of(f);
    memset(&was, 0x5a, sizeof was);
    for (int k = 0; k < 14; ++k) {
        static const char *const names[] = { "occluder",     "field",         "mesh_to_view", "slice",
                                             "slice",        "object",        "limits.reach", "limits.reach",
                                             "limits",       "limits.inside", "limits.power", "mesh_to_view",
                                             "mesh_to_view", "mesh_to_view" };
        ssgi_field_limits l = fine;
        ssgi_field none = *f;
        const char *why = "";
        placed(m, 1, 2, 0, 0, -5);
        none.texels = NULL;
        if (k == 6) l.ramp = l.reach;
        if (k == 7) l.reach *= 1.01f;
        if (k == 8) l.ramp = NAN;
        if (k == 9) l.inside = 1.1f;
        if (k == 10) l.power = 0;
        if (k == 11) for (int i = 0; i < 3; ++i) m[i] *= 1.1f;
        if (k == 12) m[4] += m[0];
        if (k == 13) m[13] = INFINITY;
        occluder = was;
        CHECK(ssgi_gl_occluder_set(k ? &occluder : NULL, k == 1 ? &none : f, &l, k == 2 ? NULL : m,
                                   k == 3   ? -1
                                   : k == 4 ? 2048
                                            : 0,
                                   k == 5 ? 1 << 24 : 0, &why)
                      == SSGI_BAD_ARGUMENT
                  && !strncmp(why, names[k], strlen(names[k])) && !memcmp(&occluder, &was, sizeof was),
              "%d: \"%s\" (expected %s)", k, why, names[k]);
    }
    placed(m, 1, 2, 0, 0, -5);
    for (int i = 2; i < 16; i += 4) m[i] = -m[i];          /* a left-handed engine's */
    CHECK(ssgi_gl_occluder_set(&occluder, f, &fine, m, 0, 0, NULL) == SSGI_OK, "a mirrored occluder is refused");
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            float to = 0;
            for (int j = 0; j < 3; ++j) to += occluder.to_field[i][j] * m[4 * k + j];
            CHECK(fabsf(to - (float)(i == k)) < 1e-6f, "a mirrored occluder: %d %d is %g", i, k, (double)to);
        }
    kit_scene_free(&scene);
}

/* ---- frames ------------------------------------------------------------------------------------------------------ */

/* Closing what was never opened, before there is any context: no function of GL may be called. */
static void closing_nothing(void)
{
    static kit_frames frames;
    static kit_run run;
    static const kit_frames closed;
    kit_run_close(&run);
    kit_frames_close(&frames);
    kit_frames_close(&frames);
    CHECK(!memcmp(&frames, &closed, sizeof closed), "what was closed is not all zero");
}

static int same_pictures(const kit_image *a, const kit_image *b)
{
    return a->width == b->width && a->height == b->height && a->channels == b->channels
           && !memcmp(a->data, b->data, sizeof *a->data * (size_t)(a->width * a->height * a->channels));
}

/* A frame of "casters" from so many degrees around, further away from frame to frame. */
static int frame_seen(kit_gbuffer *g, const kit_scene *scene, int k)
{
    kit_camera camera = scene->camera;
    camera.width = 160;
    camera.height = 90;
    for (int i = 0; i < 3; ++i) camera.eye[i] += 0.3f * (float)k * (camera.eye[i] - camera.target[i]);
    kit_camera_orbit(&camera, &camera, 3 * k);
    return TRY(kit_gbuffer_from_scene(g, scene, &camera, NULL, &err));
}

static int frame_drawn(kit_image *out, kit_run *run)
{
    kit_run_draw(run, 0);
    return TRY(kit_run_read(out, run, &err));
}

/* Frames are what is opened, followed and closed by hand; alone they are what is opened by hand and follows none; a
   margin stays as wide as the first one's; after a failure all is closed. */
static void frames_follow(void)
{
    enum { FRAMES = 3 };
    static kit_frames frames;
    static kit_run run[FRAMES];
    static const kit_frames closed;
    kit_scene scene;
    kit_gbuffer g[FRAMES];
    kit_method m;
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err)) || !TRY(kit_method_find(&m, "hsao-history", &err))) return;
    const kit_world world = { &scene, NULL }, frame = { NULL, NULL };
    for (int k = 0; k < FRAMES; ++k) if (!frame_seen(&g[k], &scene, k)) return;
    frames.number = 5;
    for (int k = 0; k < FRAMES; ++k) {
        kit_image by_hand, alone, out, single;
        float phase;
        if (!TRY(kit_run_open(&run[k], &g[k], &m, scene.radius, &world, &err))) return;
        phase = run[k].frame.phase;
        run[k].frame.phase = ssgi_gl_phase(5 + (unsigned)k);
        kit_run_update(&run[k]);
        if (!frame_drawn(&by_hand, &run[k])) return;
        run[k].frame.phase = k ? phase : run[k].frame.phase;
        if (k && !TRY(kit_run_follow(&run[k], &run[k - 1], 5 + (unsigned)k, &err))) return;
        if (!frame_drawn(&out, &run[k])) return;
        if (!TRY(kit_frames_next(&frames, &g[k], &m, scene.radius, &world, &alone, &err))
            || !frame_drawn(&single, frames.now))
            return;
        CHECK(same_pictures(&alone, &by_hand) && same_pictures(&single, &out), "frame %d is not that by hand", k);
        CHECK(!frames.run[frames.now == &frames.run[0]].textures, "frame %d: the one before is open", k);
        CHECK(same_pictures(&alone, &single) == !k, "frame %d %s history", k, k ? "has no" : "has a");
        kit_image_free(&by_hand); kit_image_free(&alone); kit_image_free(&out); kit_image_free(&single);
    }
    for (int k = 0; k < FRAMES; ++k) kit_run_close(&run[k]);
    CHECK(!kit_method_set(&m, "margin=1", &err), "%s", err.text);
    for (int turn = 0; turn < 2; ++turn) {          /* with frames that are open, and from all zero */
        err.text[0] = 0;
        CHECK(kit_frames_next(&frames, &g[1], &m, scene.radius, &frame, NULL, &err) == -1 && strstr(err.text, "margin"),
              "a margin of a frame: \"%s\"", err.text);
        CHECK(!memcmp(&frames, &closed, sizeof closed), "what failed is not closed");
    }
    int margin = 0;
    for (int k = 0; k < FRAMES; ++k) {
        if (!TRY(kit_run_open(&run[0], &g[k], &m, scene.radius, &world, &err))
            || !TRY(kit_frames_next(&frames, &g[k], &m, scene.radius, &world, NULL, &err)))
            return;
        kit_run_draw(frames.now, 0);
        if (!k) margin = run[0].margin;
        CHECK(frames.now->margin == margin && (k < FRAMES - 1 || run[0].margin < margin),
              "frame %d: a margin of %d pixels, alone %d, the first %d", k, frames.now->margin, run[0].margin, margin);
        kit_run_close(&run[0]);
    }
    kit_frames_close(&frames);
    for (int k = 0; k < FRAMES; ++k) kit_gbuffer_free(&g[k]);
    kit_scene_free(&scene);
}

/* A picture that stays is followed by itself; it begins anew at 0. */
static void frames_stay(void)
{
    static kit_run run[2];
    kit_scene scene;
    kit_gbuffer g;
    kit_method m;
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err)) || !frame_seen(&g, &scene, 0)
        || !TRY(kit_method_find(&m, "hsao-history", &err)))
        return;
    const kit_world world = { &scene, NULL };
    for (int r = 0; r < 2; ++r) if (!TRY(kit_run_open(&run[r], &g, &m, scene.radius, &world, &err))) return;
    for (unsigned k = 0; k < 7; ++k) {
        kit_image out[2];
        const unsigned frame = k % 4;
        if (!frame) {
            run[0].frame.history = 0;
            run[0].frame.phase = ssgi_gl_phase(9);
            kit_run_update(&run[0]);
        } else if (!TRY(kit_run_follow(&run[0], &run[0], 9 + frame, &err))) return;
        if (!frame_drawn(&out[0], &run[0]) || !TRY(kit_frames_still(&run[1], 9, frame, 0, &err))
            || !TRY(kit_run_read(&out[1], &run[1], &err)))
            return;
        CHECK(same_pictures(&out[0], &out[1]), "frame %u is not that by hand", frame);
        for (int r = 0; r < 2; ++r) kit_image_free(&out[r]);
    }
    for (int r = 0; r < 2; ++r) kit_run_close(&run[r]);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

/* A frame of other passes follows none: it is as if it were the first of its number; one of another size goes on. One
   more of the same G-buffer is what opening that again makes. */
static void frames_restart(void)
{
    enum { FRAMES = 7 };
    static const struct { const char *method; int width; unsigned since; } frame[FRAMES] = {
        { "hsao-history", 160, 1 }, { "hsao-history", 160, 2 }, { "hsao-history", 96, 3 }, { "hsao-history", 96, 4 },
        { "hsao-best", 96, 1 },     { "hsao-best", 96, 2 },     { "hsao-history", 96, 1 } };
    static kit_frames frames, again;
    kit_scene scene;
    kit_gbuffer g[FRAMES];
    kit_method m;
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
    const kit_world world = { &scene, NULL };
    for (int k = 0; k < FRAMES; ++k) {
        static kit_frames first;
        kit_camera camera = scene.camera;
        kit_image out[2];
        camera.width = frame[k].width;
        camera.height = 90;
        if (!TRY(kit_gbuffer_from_scene(&g[k], &scene, &camera, NULL, &err))
            || !TRY(kit_method_find(&m, frame[k].method, &err)) || !TRY(kit_method_set(&m, "history=1", &err))
            || !TRY(kit_frames_next(&frames, &g[k], &m, scene.radius, &world, NULL, &err)))
            return;
        CHECK(frames.since == frame[k].since, "frame %d: the %u. of those that follow each other", k, frames.since);
        first.number = (unsigned)k;
        if (!frame_drawn(&out[0], frames.now)
            || !TRY(kit_frames_next(&first, &g[k], &m, scene.radius, &world, NULL, &err))
            || !frame_drawn(&out[1], first.now))
            return;
        CHECK(same_pictures(&out[0], &out[1]) == (frame[k].since == 1), "frame %d %s history", k,
              frame[k].since == 1 ? "has a" : "has no");
        kit_image_free(&out[1]);
        kit_frames_close(&first);
        if (k < 4) {
            if (!TRY(k & 1 ? kit_frames_again(&again, &err)
                           : kit_frames_next(&again, &g[k], &m, scene.radius, &world, NULL, &err))
                || !frame_drawn(&out[1], again.now))
                return;
            CHECK(same_pictures(&out[0], &out[1]) && again.since == frames.since && again.number == frames.number,
                  "frame %d of a G-buffer that stays is not that of one opened again", k);
            kit_image_free(&out[1]);
        }
        kit_image_free(&out[0]);
    }
    kit_frames_close(&frames);
    kit_frames_close(&again);
    for (int k = 0; k < FRAMES; ++k) kit_gbuffer_free(&g[k]);
    kit_scene_free(&scene);
}

/* Triangles that are kept are drawn as others are, also what light sees of them, until they are forgotten. */
static void mesh_kept(void)
{
    static const float by[3] = { 0.8f, 0, 0 };
    kit_scene scene;
    kit_lighting sun = { .lights = 1, .light = { { KIT_SUN, { 0.6f, 0.6f, 0.529f }, { 1, 1, 1 } } } };
    kit_image out[4];
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err))) return;
    const kit_world world = { &scene, &sun };
    for (int k = 0; k < 4; ++k) {          /* as they are; kept; moved, but not forgotten; forgotten */
        kit_gbuffer g;
        if (k == 1 && !TRY(kit_mesh_keep(&scene.mesh, &err))) return;
        if (k == 2 && !TRY(kit_scene_slide(&scene, by, 1, &err))) return;
        if (k == 3) kit_mesh_forget();
        if (!frame_seen(&g, &scene, 0)
            || !TRY(kit_run_picture(&out[k], &g, &world, "ssdo", "bounce=none", scene.radius, &err)))
            return;
        kit_gbuffer_free(&g);
    }
    CHECK(same_pictures(&out[0], &out[1]), "kept triangles are drawn otherwise");
    CHECK(same_pictures(&out[1], &out[2]), "triangles that are kept were uploaded again");
    CHECK(!same_pictures(&out[2], &out[3]), "forgotten triangles are where they were");
    for (int k = 0; k < 4; ++k) kit_image_free(&out[k]);
    kit_scene_free(&scene);
}

void test_occluders(void)
{
    RUN("what was never opened can be closed, with no context", closing_nothing);
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("the shader's caps are the CPU's", caps);
    RUN("the shader's fields are the CPU's: turned, scaled and moved", same_as_on_the_cpu);
    RUN("a ball on a plane is its closed form", ball_on_a_plane);
    RUN("caps from a table are within its error of the closed form's", tables_of_caps);
    RUN("a draw covers each occluder's sphere of influence from anywhere", what_a_draw_covers);
    RUN("occluders combine to between the most and the sum; one draw and a draw each agree", combination);
    RUN("two dozen occluders against rays", against_truth);
    RUN("an occluder that cannot be set is refused", refusals);
    RUN("frames follow the one before, a failed one ends them", frames_follow);
    RUN("frames of a picture that stays follow themselves", frames_stay);
    RUN("frames of other passes begin anew, of another size they go on", frames_restart);
    RUN("triangles that are kept are drawn as others are", mesh_kept);
    kit_fields_free();
    kit_gl_close();
}
