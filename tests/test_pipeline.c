/* test_pipeline.c - the AO passes through the whole of GL: closed forms, invariances, sizes, garbage, truth, the filter. */
#include "t.h"
#include "../examples/kit/kit_gl.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;

static const struct { const char *method, *set; } methods[] = { { "ssao", "" }, { "hsao", "" }, { "hsao-fast", "" }, { "hsao-best", "" }, { "hsao-march", "" },
    { "hsao-march", "normal_rays=2" }, { "ssao", "normal=depth,thin=0" }, { "hsao", "normal=depth,thin=1" } };
enum { METHODS = (int)(sizeof methods / sizeof methods[0]) };

static uint32_t random_state;
static uint32_t below(uint32_t n)
{
    random_state = random_state * 1664525u + 1013904223u;
    return (random_state >> 8) % n;
}

/* ---- pictures ---------------------------------------------------------------------------------------------------- */

static kit_camera looking_along_z(int width, int height, int orthographic)
{
    kit_camera c = { { 0, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 }, 45, 2, 0.01f, 1000, 0, 0, { 0, 0 }, KIT_DEPTH_NORMAL };
    c.width = width;
    c.height = height;
    if (orthographic) c.fovy = 0;
    return c;
}

static int view_of(ssgi_view *view, const kit_camera *c)
{
    float world[16], projection[16];
    const char *why = "";
    kit_camera_matrices(c, world, projection);
    return CHECK(ssgi_view_from_projection(view, projection, c->depth == KIT_DEPTH_NORMAL ? SSGI_CLIP_GL : SSGI_CLIP_ZERO, c->width, c->height, &why) == SSGI_OK, "%s", why);
}

/* The exact G-buffer of the space that planes x * n = n[3] enclose, from within. */
static int walls(kit_gbuffer *g, kit_image *frame, const kit_camera *c, const double (*plane)[4], int planes)
{
    ssgi_view view;
    memset(frame, 0, sizeof *frame);
    memset(g, 0, sizeof *g);
    if (!view_of(&view, c) || !CHECK(!kit_image_new(frame, c->width, c->height, "Z,N.X,N.Y,N.Z", &err), "%s", err.text)) return 0;
    const size_t pixels = (size_t)c->width * (size_t)c->height;
    for (int y = 0; y < c->height; ++y)
        for (int x = 0; x < c->width; ++x) {
            const size_t at = (size_t)(c->height - 1 - y) * (size_t)c->width + (size_t)x;
            const double p[2] = { (x + 0.5) * (double)view.unproject[0] + (double)view.unproject[2], (y + 0.5) * (double)view.unproject[1] + (double)view.unproject[3] };
            for (int k = 0; k < planes; ++k) {
                const double *n = plane[k], across = n[0] * p[0] + n[1] * p[1];
                const double z = c->fovy > 0 ? n[3] / (across - n[2]) : (n[3] - across) / -n[2];
                if (!(z > 0.01 && z < 500) || (frame->data[at] > 0 && z >= (double)frame->data[at])) continue;
                frame->data[at] = (float)z;
                for (size_t i = 0; i < 3; ++i) frame->data[(1 + i) * pixels + at] = (float)n[i];
            }
        }
    return CHECK(!kit_gbuffer_from_frame(g, frame, c, &err), "%s", err.text);
}

static int start(kit_run *run, const kit_gbuffer *g, const char *name, const char *set, float radius)
{
    kit_method m;
    return CHECK(!kit_method_find(&m, name, &err) && !kit_method_set(&m, set, &err) && !kit_run_open(run, g, &m, radius, &err), "%s %s: %s", name, set, err.text);
}

static int draw(kit_image *out, kit_run *run)
{
    kit_run_update(run);
    kit_run_draw(run, 0);
    return CHECK(!kit_run_read(out, run, &err), "%s", err.text);
}

static int picture(kit_image *out, const kit_gbuffer *g, const char *name, const char *set, float radius, float phase)
{
    kit_run run;
    memset(out, 0, sizeof *out);
    if (!start(&run, g, name, set, radius)) return 0;
    run.frame.phase = phase;
    const int ok = draw(out, &run);
    kit_run_close(&run);
    return ok;
}

/* between a at (x, y) and b at (x + dx, y + dy), border pixels of a left out */
static double difference(const kit_image *a, const kit_image *b, int dx, int dy, int border)
{
    double sum = 0;
    int n = 0;
    if (!a->data || !b->data) return 1;
    for (int y = border; y < a->height - border; ++y)
        for (int x = border; x < a->width - border; ++x) {
            const int u = x + dx, v = y + dy;
            if (u < 0 || v < 0 || u >= b->width || v >= b->height) continue;
            const double d = (double)a->data[y * a->width + x] - (double)b->data[v * b->width + u];
            sum += d * d;
            ++n;
        }
    return n ? sqrt(sum / n) : 1;
}

/* ---- planes -------------------------------------------------------------------------------------------------------- */

static int flat(const kit_image *frame, int x, int y)      /* nothing but surface within 3 pixels */
{
    for (int v = y - 3; v <= y + 3; ++v)
        for (int u = x - 3; u <= x + 3; ++u)
            if (u < 0 || v < 0 || u >= frame->width || v >= frame->height || !(frame->data[v * frame->width + u] > 0)) return 0;
    return 1;
}

static void planes_stay_bright(void)
{
    static const struct { const char *method, *set; double most; } row[] = {
        { "ssao", "", 1e-3 }, { "ssao", "thin=0,blur=0", 1e-3 }, { "hsao", "", 1e-5 }, { "hsao-fast", "", 1e-5 }, { "hsao-best", "blur=0", 1e-5 }, { "hsao-best", "thin=1,hard=1,blur=0", 1e-5 },
        { "hsao-march", "normal_rays=0,blur=0", 1e-5 }, { "hsao-march", "normal_rays=2,blur=0", 1e-3 },
        { "ssao", "normal=depth", 1e-3 }, { "hsao-best", "normal=depth,blur=0", 1e-5 }, { "hsao-march", "normal=depth,normal_rays=2,blur=0", 1e-3 } };
    enum { ROWS = (int)(sizeof row / sizeof row[0]), TILTS = 5, TURNS = 3, PLANES = TILTS * TURNS };
    static const double tilts[TILTS] = { 0, 30, 60, 75, 85 }, turns[TURNS] = { 0, 90, 217 };
    kit_gbuffer g[PLANES];
    kit_image frame[PLANES];
    double worst[ROWS] = { 0 };
    int looked = 0;
    for (int orthographic = 0; orthographic < 2; ++orthographic) {
        const kit_camera c = looking_along_z(160, 90, orthographic);
        for (int i = 0; i < PLANES; ++i) {
            const double a = tilts[i / TURNS] * pi / 180, b = turns[i % TURNS] * pi / 180, n[1][4] = { { sin(a) * cos(b), sin(a) * sin(b), cos(a), -cos(a) } };
            walls(&g[i], &frame[i], &c, n, 1);
        }
        for (int m = 0; m < ROWS; ++m) {
            kit_run run;
            if (!start(&run, &g[0], row[m].method, row[m].set, 0.1f)) continue;
            for (int i = 0; i < PLANES; ++i) {
                kit_image out;
                run.gbuffer = &g[i];
                run.frame.radius = run.frame.thickness = i % 2 ? 0.5f : 0.1f;
                run.frame.phase = 0.123f * (float)i - (float)(int)(0.123f * (float)i);
                if (!draw(&out, &run)) continue;
                for (int y = 3; y < out.height - 3; ++y)
                    for (int x = 3; x < out.width - 3; ++x) {
                        if (!flat(&frame[i], x, y)) continue;
                        const double o = 1 - (double)out.data[y * out.width + x];
                        if (!(o <= worst[m])) worst[m] = o;
                        ++looked;
                        if (!(o <= row[m].most)) CHECK(0, "%s %s: tilt %g, turned %g, R %g, %s: occlusion %g at %d %d", row[m].method, row[m].set, tilts[i / TURNS],
                            turns[i % TURNS], (double)run.frame.radius, orthographic ? "orthographic" : "perspective", o, x, y);
                    }
                kit_image_free(&out);
            }
            kit_run_close(&run);
        }
        for (int i = 0; i < PLANES; ++i) { kit_gbuffer_free(&g[i]); kit_image_free(&frame[i]); }
    }
    CHECK(looked > 1000000, "only %d pixels were looked at", looked);
    for (int m = 0; m < ROWS; ++m) t_note("planes, %s %s: %.1e", row[m].method, row[m].set, worst[m]);
}

/* ---- the corner ------------------------------------------------------------------------------------------------------ */

static double linear_corner(double c) { const double s = sqrt(1 - c * c); return (acos(c) + c * s - (c > 0 ? 2 * c * log((1 + s) / c) : 0)) / pi; }
static double hard_corner(double c)   { return (acos(c) - c * sqrt(1 - c * c)) / pi; }

/* Floor and wall from 45 degrees above, orthographic; radius 1 is SPAN pixels down the floor, up the wall, and sqrt(2) times as many sideways. The
   floor at distance c from the wall is seen through the very centre of row row_at(c). What is drawn is cut to a row of the columns in the middle. */
enum { SPAN = 256, MIDDLE = 364, COLUMNS = 64, WIDE = 2 * MIDDLE + COLUMNS, HIGH = 2 * SPAN + 32 };
static int row_at(double c) { return SPAN + 16 - (int)(c * SPAN); }
static int corner(kit_gbuffer *g, double c)
{
    kit_camera camera = looking_along_z(WIDE, HIGH, 1);
    kit_image frame;
    const double r = sqrt(0.5), pixel = r / SPAN, edge = (row_at(c) + 0.5 - 0.5 * HIGH) * pixel + c * r;     /* view y of the edge */
    const double n[2][4] = { { 0, r, r, r * (edge - 4) }, { 0, -r, r, r * (-edge - 4) } };
    camera.ortho_height = (float)(HIGH * pixel);
    const int ok = walls(g, &frame, &camera, n, 2);
    kit_image_free(&frame);
    return ok;
}

/* the mean occlusion of one row of the middle columns, over phases */
static double row_of(kit_run *run, const kit_gbuffer *g, int row, int phases)
{
    double sum = 0;
    float line[COLUMNS];
    run->gbuffer = g;
    glEnable(GL_SCISSOR_TEST);
    glScissor(MIDDLE, row, COLUMNS, 1);
    for (int k = 0; k < phases; ++k) {
        run->frame.phase = ((float)k) / (float)phases;
        kit_run_update(run);
        kit_run_draw(run, 0);
        glBindFramebuffer(GL_READ_FRAMEBUFFER, run->pass[0].framebuffer);
        glReadPixels(MIDDLE, row, COLUMNS, 1, GL_RED, GL_FLOAT, line);
        for (int i = 0; i < COLUMNS; ++i) sum += 1 - (double)line[i];
    }
    glDisable(GL_SCISSOR_TEST);
    return sum / (COLUMNS * phases);
}

static void corner_converges(void)
{
    static const double at[] = { 0.1, 0.25, 0.5, 0.75 }, steps[] = { 6, 12, 24, 48 };
    static const double march[4][4] = { { 0.193326, 0.236991, 0.267104, 0.285685 }, { 0.098437, 0.125290, 0.144022, 0.155257 },     /* at x steps: the paper's march */
                                        { 0.024288, 0.034575, 0.042254, 0.046842 }, { 0.002961, 0.004317, 0.005621, 0.006773 } };   /* on an exact wall, no jitter */
    static const struct { const char *method, *set; double (*truth)(double); double bound; } row[] = {
        { "hsao-best", "directions=8,steps=48,blur=0", linear_corner, 0.02 }, { "hsao-best", "directions=8,steps=48,hard=1,blur=0", hard_corner, 0.02 },
        { "ssao", "samples=64,thin=0,blur=0", linear_corner, 0.02 } };
    kit_gbuffer g[4];
    kit_run run;
    double worst = 0, scaled = 0;
    float tile[16][4];
    for (int i = 0; i < 16; ++i) { tile[i][0] = 1; tile[i][1] = tile[i][2] = 0; tile[i][3] = (float)i / 16; }
    for (int i = 0; i < 4; ++i) if (!corner(&g[i], at[i])) return;
    for (int s = 0; s < 4; ++s) {
        char set[96];
        snprintf(set, sizeof set, "directions=32,normal_rays=0,blur=0,noise=texture,steps=%g", steps[s]);
        if (!start(&run, &g[0], "hsao-march", set, 1)) return;
        glBindTexture(GL_TEXTURE_2D, run.noise);           /* steps not jittered, 16 * 32 directions */
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 16, 1, 0, GL_RGBA, GL_FLOAT, tile);
        for (int i = 0; i < 4; ++i) {
            const double o = row_of(&run, &g[i], row_at(at[i]), 1), off = o - march[i][s], from_truth = (linear_corner(at[i]) - o) * steps[s];
            worst = fmax(worst, fabs(off));
            scaled = fmax(scaled, fabs(from_truth));
            CHECK(fabs(off) <= 0.01, "march, c %g, %g steps: %g, the exact march has %g", at[i], steps[s], o, march[i][s]);
            CHECK(from_truth <= 2.5 && from_truth > -0.01 * steps[s], "march, c %g, %g steps: %g, truth %g", at[i], steps[s], o, linear_corner(at[i]));
        }
        kit_run_close(&run);
    }
    t_note("corner, march: %.4f off the exact march, %.2f/steps off the truth", worst, scaled);
    for (int m = 0; m < 3; ++m) {
        double bias = 0;
        int n = 0;
        worst = 0;
        if (!start(&run, &g[0], row[m].method, row[m].set, 1)) return;
        for (int r = row_at(1) + 1; r <= row_at(0.1); r += 9) {
            const double c = at[1] + (row_at(at[1]) - r) / (double)SPAN, truth = row[m].truth(c), o = row_of(&run, &g[1], r, 4);
            const double noise = m == 2 ? 5 * sqrt(truth * (1 - truth) / (64 * 4 * COLUMNS)) : 0;
            worst = fmax(worst, fabs(o - truth));
            bias += o - truth;
            ++n;
            CHECK(fabs(o - truth) <= row[m].bound + noise, "%s %s, c %.3f: %g, truth %g", row[m].method, row[m].set, c, o, truth);
        }
        kit_run_close(&run);
        t_note("corner, %s %s: worst %.4f, bias %+.4f over %d distances", row[m].method, row[m].set, worst, bias / n, n);
    }
    for (int i = 0; i < 4; ++i) kit_gbuffer_free(&g[i]);
}

/* ---- the same picture, whatever the camera, the layout and the units --------------------------------------------------- */

enum { RECT_W = 480, RECT_H = 270 };
static const struct { const char *method, *set; } alike[] = { { "ssao", "noise=tile" }, { "hsao", "noise=tile" }, { "hsao-best", "noise=tile" }, { "hsao-march", "noise=tile" } };
enum { ALIKE = 4 };

/* Draws into larger targets, the picture at (8, 6) in them, and cuts it out again. */
static int picture_inside(kit_image *out, const kit_gbuffer *g, const char *name, const char *set, float radius)
{
    kit_run run;
    kit_image all;
    const int w = g->viewport[2], h = g->viewport[3];
    memset(out, 0, sizeof *out);
    if (!start(&run, g, name, set, radius)) return 0;
    run.frame.target[0] = 8;
    run.frame.target[1] = 6;
    for (int i = 0; i < run.passes; ++i) {
        kit_pass *p = &run.pass[i];
        const int last = i == run.passes - 1;
        p->width += 20;
        p->height += 20;
        glBindTexture(GL_TEXTURE_2D, p->texture);
        glTexImage2D(GL_TEXTURE_2D, 0, last && run.passes > 1 ? GL_R32F : GL_RG32F, p->width, p->height, 0, last && run.passes > 1 ? GL_RED : GL_RG, GL_FLOAT, NULL);
    }
    const int ok = draw(&all, &run) && !kit_image_new(out, w, h, "Y", &err);
    for (int y = 0; ok && y < h; ++y) memcpy(out->data + y * w, all.data + (all.height - 6 - h + y) * all.width + 8, (size_t)w * sizeof(float));
    if (ok) kit_image_free(&all);
    kit_run_close(&run);
    return ok;
}

static void same_picture(void)
{
    enum { NORMAL, REVERSED, INFINITE, LINEAR, INSIDE, SHIFTED, ROLLED, SMALL, LARGE, WAYS };
    static const char *const names[WAYS] = { "normal depth", "reversed", "infinite", "linear", "inside larger textures", "shifted", "rolled", "1/1000", "1000" };
    static const int margin[4] = { 8, 4, 12, 16 };
    kit_scene scene;
    double worst[WAYS] = { 0 };
    for (int orthographic = 0; orthographic < 2; ++orthographic) {
        kit_gbuffer g[WAYS];
        kit_image reference[ALIKE], other[ALIKE];
        for (int w = REVERSED; w <= WAYS; ++w) {                   /* reversed depth is the reference: the most precise; normal depth comes last */
            const int way = w == WAYS ? NORMAL : w;
            const float scale = way == SMALL ? 1e-3f : way == LARGE ? 1e3f : 1;
            kit_image frame;
            if (!CHECK(!kit_scene_load(&scene, "room", 0, &err), "%s", err.text)) return;
            kit_camera c = scene.camera;
            c.width = RECT_W;
            c.height = RECT_H;
            c.depth = way == NORMAL ? KIT_DEPTH_NORMAL : way == INFINITE && !orthographic ? KIT_DEPTH_INFINITE : KIT_DEPTH_REVERSED;
            if (orthographic) { c.fovy = 0; c.ortho_height = 3.6f; }
            if (way == SHIFTED) { c.shift[0] = 16; c.shift[1] = -32; }
            if (way == ROLLED) {
                c.up[0] = c.target[2] - c.eye[2]; c.up[1] = 0; c.up[2] = c.eye[0] - c.target[0];       /* what was to the left is up */
                c.width = RECT_H;
                c.height = RECT_W;
                if (orthographic) c.ortho_height *= (float)RECT_W / RECT_H;
                else c.fovy = (float)(360 / pi * atan(tan((double)c.fovy * pi / 360) * RECT_W / RECT_H));
            }
            for (size_t i = 0; i < 9 * scene.mesh.triangles; ++i) scene.mesh.position[i] *= scale;
            for (int i = 0; i < 3; ++i) { c.eye[i] *= scale; c.target[i] *= scale; scene.mesh.lower[i] *= scale; scene.mesh.upper[i] *= scale; }
            c.znear *= scale; c.zfar *= scale; c.ortho_height *= scale;
            if (way == LINEAR) {
                CHECK(!kit_gbuffer_read(&frame, &g[REVERSED], &err) && !kit_gbuffer_from_frame(&g[way], &frame, &g[REVERSED].camera, &err), "%s", err.text);
                kit_image_free(&frame);
            } else if (!CHECK(!kit_gbuffer_from_scene(&g[way], &scene, &c, way == INSIDE ? margin : NULL, &err), "%s", err.text)) return;
            for (int m = 0; m < ALIKE; ++m) {
                double d, most = 2e-3;
                if (way == ROLLED && m == 1) continue;             /* at half size another pixel of each 2x2 is drawn: another picture */
                const int dx = way == SHIFTED ? 16 : 0, dy = way == SHIFTED ? 32 : 0;
                (way == INSIDE ? picture_inside(&other[m], &g[way], alike[m].method, alike[m].set, scale * scene.radius)
                               : picture(&other[m], &g[way], alike[m].method, alike[m].set, scale * scene.radius, 0));
                if (way == REVERSED) { reference[m] = other[m]; continue; }
                if (way == ROLLED) {                               /* turned back; and no more than noise apart */
                    kit_image turned, phase;
                    kit_image_new(&turned, RECT_W, RECT_H, "Y", &err);
                    for (int y = 0; y < RECT_H; ++y)
                        for (int x = 0; x < RECT_W; ++x) turned.data[y * RECT_W + x] = other[m].data[x * RECT_H + RECT_H - 1 - y];
                    picture(&phase, &g[REVERSED], alike[m].method, alike[m].set, scene.radius, 0.39f);
                    most = 1.25 * difference(&reference[m], &phase, 0, 0, 0);
                    d = difference(&reference[m], &turned, 0, 0, 0);
                    t_note("%s, %s: rolled %.5f, noise %.5f", orthographic ? "orthographic" : "perspective", alike[m].method, d, most / 1.25);
                    kit_image_free(&turned);
                    kit_image_free(&phase);
                } else d = difference(&reference[m], &other[m], dx, dy, way == SHIFTED ? 100 : 0);
                if (way != ROLLED) worst[way] = fmax(worst[way], d);
                CHECK(d <= most, "%s, %s, %s: RMSE %.5f of reversed depth", orthographic ? "orthographic" : "perspective", alike[m].method, names[way], d);
                kit_image_free(&other[m]);
            }
            if (way != REVERSED) kit_gbuffer_free(&g[way]);
            kit_scene_free(&scene);
        }
        for (int m = 0; m < ALIKE; ++m) kit_image_free(&reference[m]);
        kit_gbuffer_free(&g[REVERSED]);
    }
    for (int w = 0; w < WAYS; ++w) if (w != REVERSED && w != ROLLED) t_note("%s: RMSE %.1e of reversed depth", names[w], worst[w]);
}

/* ---- sizes, radii, garbage ----------------------------------------------------------------------------------------------- */

/* Of every pass's target: finite, in [0,1]; ones: 1 where the depth holds nothing. Returns how many pixels are not so. */
static int wrong(const kit_run *run, const float *nothing)
{
    int n = 0;
    for (int i = 0; i < run->passes; ++i) {
        const kit_pass *p = &run->pass[i];
        float *v = malloc(sizeof(float) * (size_t)p->width * (size_t)p->height);
        if (!CHECK(v && !kit_texture_read(p->texture, p->width, p->height, 1, v), "cannot be read back")) { free(v); return 1; }
        for (int k = 0; k < p->width * p->height; ++k) n += !(v[k] >= 0 && v[k] <= 1) || (nothing && p->width == run->gbuffer->width && !(nothing[k] > 0) && v[k] < 1);
        free(v);
    }
    return n;
}

/* Raw textures, as they are. */
static kit_gbuffer raw(const kit_camera *c, int linear, GLenum format, const float *depth, const float *normal)
{
    kit_gbuffer g;
    float world[16];
    memset(&g, 0, sizeof g);
    g.camera = *c;
    g.width = g.viewport[2] = c->width;
    g.height = g.viewport[3] = c->height;
    g.depth_is_linear = linear;
    g.depth = kit_texture(c->width, c->height, format, depth);
    g.normal = kit_texture(c->width, c->height, GL_RGBA32F, normal);
    kit_camera_matrices(c, world, g.projection);
    return g;
}

/* Turns a run to a G-buffer of another size. */
static void fit(kit_run *run, const kit_gbuffer *g)
{
    ssgi_view view;
    if (!view_of(&view, &g->camera)) return;
    ssgi_gl_frame_init(&run->frame, &view, run->frame.radius, NULL);
    run->gbuffer = g;
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        const int half = p->desc.half && p->desc.pass != SSGI_GL_BLUR;
        p->width = half ? (g->width + 1) / 2 : g->width;
        p->height = half ? (g->height + 1) / 2 : g->height;
        glBindTexture(GL_TEXTURE_2D, p->texture);
        glTexImage2D(GL_TEXTURE_2D, 0, i ? GL_R32F : GL_RG32F, p->width, p->height, 0, i ? GL_RED : GL_RG, GL_FLOAT, NULL);
    }
    kit_run_update(run);
}

static void sizes_do_not_matter(void)
{
    static const int widths[] = { 1, 2, 3, 5, 17, 64 }, heights[] = { 1, 2, 3, 7, 33 };
    kit_scene scene;
    kit_image out;
    kit_gbuffer g;
    kit_run run;
    float depth[64 * 33] = { 0 }, normal[4 * 64 * 33] = { 0 };
    for (int m = 0; m < 2 * METHODS; ++m) {
        kit_camera c = looking_along_z(64, 33, m & 1);
        g = raw(&c, 1, GL_R32F, depth, normal);
        if (!start(&run, &g, methods[m / 2].method, methods[m / 2].set, 0.5f)) return;
        kit_gbuffer_free(&g);
        for (int i = 0; i < 30; ++i) {
            c.width = widths[i % 6];
            c.height = heights[i / 6];
            random_state = (uint32_t)i;
            for (int k = 0; k < c.width * c.height; ++k) {
                depth[k] = below(4) ? 1 + 0.01f * (float)below(100) : 0;
                for (int j = 0; j < 4; ++j) normal[4 * k + j] = 0.01f * (float)below(200) - 1;
            }
            g = raw(&c, 1, GL_R32F, depth, normal);
            fit(&run, &g);
            kit_run_draw(&run, 0);
            const int n = wrong(&run, depth);
            CHECK(!n, "%s %s: %d pixels of %d x %d are wrong", methods[m / 2].method, methods[m / 2].set, n, c.width, c.height);
            kit_gbuffer_free(&g);
        }
        kit_run_close(&run);
    }
    if (!CHECK(!kit_scene_load(&scene, "room", 0, &err), "%s", err.text)) return;
    scene.camera.width = 160;
    scene.camera.height = 90;
    if (!CHECK(!kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err), "%s", err.text)) return;
    for (int m = 0; m < METHODS; ++m) {
        if (!start(&run, &g, methods[m].method, methods[m].set, 1e-6f)) continue;
        int dark = 0;
        if (draw(&out, &run)) {
            for (int i = 0; i < out.width * out.height; ++i) dark += !(out.data[i] >= 1 - 1e-6f);
        }
        /* Points lifted by most of a pixel stand behind a silhouette beside them, and what is solid blocks them at any radius: a limit of ssao with
           thin=0 and of normal rays. All else sees nothing. */
        const int solid = !strcmp(methods[m].method, "hsao-march") || strstr(methods[m].set, "thin=0") != NULL;
        CHECK(dark <= (solid ? out.width * out.height / 10 : 0), "%s %s, tiny radius: %d pixels are not 1", methods[m].method, methods[m].set, dark);
        kit_image_free(&out);
        run.frame.radius = run.frame.thickness = 1e6f;
        if (draw(&out, &run)) kit_image_free(&out);
        CHECK(!wrong(&run, NULL), "%s %s, huge radius: %d pixels are wrong", methods[m].method, methods[m].set, wrong(&run, NULL));
        kit_run_close(&run);
    }
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

static void garbage_is_survived(void)
{
    static const float odd[] = { NAN, INFINITY, -INFINITY, 0, -0.0f, -1, 1e-45f, 1e-39f, 1e-30f, 1e-12f, 1e-6f, 0.25f, 0.5f, 0.999f, 1, 2, 1e6f, 1e12f, 9e17f, 1e18f, 1e30f, 1e38f, -1e38f };
    enum { ODD = (int)(sizeof odd / sizeof odd[0]), W = 24, H = 13, SEEDS = 12 };
    static const struct { const char *name; int linear, orthographic, layout; GLenum format; } kind[] = {
        { "view depth", 1, 0, KIT_DEPTH_NORMAL, GL_R32F }, { "view depth, orthographic", 1, 1, KIT_DEPTH_NORMAL, GL_R32F }, { "window depth", 0, 0, KIT_DEPTH_NORMAL, GL_R32F },
        { "hardware depth", 0, 0, KIT_DEPTH_NORMAL, GL_DEPTH_COMPONENT32F }, { "infinite", 0, 0, KIT_DEPTH_INFINITE, GL_R32F }, { "orthographic", 0, 1, KIT_DEPTH_REVERSED, GL_R32F } };
    float depth[W * H], normal[4 * W * H];
    for (int k = 0; k < 6; ++k) {
        kit_camera c = looking_along_z(W, H, kind[k].orthographic);
        kit_gbuffer g[SEEDS];
        c.depth = kind[k].layout;
        for (int s = 0; s < SEEDS; ++s) {
            random_state = (uint32_t)s;
            for (int i = 0; i < W * H; ++i) {              /* more and more of it among sound texels */
                depth[i] = (int)below(SEEDS) <= s ? odd[below(ODD)] : 0.5f + 0.004f * (float)below(100);
                for (int j = 0; j < 4; ++j) normal[4 * i + j] = (int)below(SEEDS) <= s ? odd[below(ODD)] : 0.01f * (float)below(200) - 1;
            }
            g[s] = raw(&c, kind[k].linear, kind[k].format, depth, normal);
        }
        for (int m = 0; m < METHODS; ++m) {
            kit_run run;
            int n = 0;
            if (!start(&run, &g[0], methods[m].method, methods[m].set, 0.5f)) continue;
            for (int s = 0; s < SEEDS; ++s) {
                run.gbuffer = &g[s];
                run.frame.radius = s % 3 ? 0.5f : 1e5f;
                kit_run_update(&run);
                kit_run_draw(&run, 0);
                n += wrong(&run, NULL);
            }
            CHECK(!n, "%s, %s %s: %d pixels are NaN or beyond [0,1]", kind[k].name, methods[m].method, methods[m].set, n);
            kit_run_close(&run);
        }
        for (int s = 0; s < SEEDS; ++s) kit_gbuffer_free(&g[s]);
    }
}

/* ---- truth, and what it costs --------------------------------------------------------------------------------------------- */

static void near_the_truth(void)
{
    static const struct { const char *name; double most; } row[] = { { "ssao", 1 }, { "hsao", 0.47 }, { "hsao-fast", 0.55 }, { "hsao-best", 0.42 }, { "hsao-march", 1 } };
    kit_scene scene;
    kit_gbuffer g;
    kit_image truth, one;
    kit_score none, score;
    double hsao = 0;
    if (!CHECK(!kit_scene_load(&scene, "room", 0, &err), "%s", err.text)) return;
    scene.camera.width = RECT_W;
    scene.camera.height = RECT_H;
    if (!CHECK(!kit_truth_ao(&truth, &scene, &scene.camera, scene.radius, KIT_ATTENUATION_LINEAR, 64, 1, &err) && !kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err)
               && !kit_image_new(&one, RECT_W, RECT_H, "Y", &err), "%s", err.text)) return;
    float *mask = calloc((size_t)(RECT_W * RECT_H), sizeof *mask);
    for (int i = 0; mask && i < RECT_W * RECT_H; ++i) {
        one.data[i] = 1;
        mask[i] = truth.data[i] >= 0 ? 1 : 0;
        if (!(mask[i] > 0)) truth.data[i] = 1;
    }
    kit_score_channel(&none, &one, &truth, "Y", mask, &err);
    for (int m = 0; m < 5; ++m) {
        kit_image out;
        if (!picture(&out, &g, row[m].name, "", scene.radius, 0) || !CHECK(!kit_score_channel(&score, &out, &truth, "Y", mask, &err), "%s", err.text)) continue;
        const double share = score.rmse / none.rmse;
        t_note("room, %s: RMSE %.4f, %.3f of no AO's, bias %+.4f", row[m].name, score.rmse, share, score.bias);
        CHECK(share <= row[m].most, "%s: %.3f of no AO's RMSE", row[m].name, share);
        CHECK(m != 1 || fabs(score.bias) <= 0.02, "%s: bias %+.4f", row[m].name, score.bias);
        CHECK(m != 3 || share < hsao, "%s: %.3f, hsao has %.3f", row[m].name, share, hsao);
        if (m == 1) hsao = share;
        kit_image_free(&out);
    }
    free(mask);
    kit_image_free(&one);
    kit_image_free(&truth);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

static void fetches_are_counted(void)
{
    enum { W = 64, H = 48, INSIDE = 16 };
    static const char *const fetch[2] = {
        "layout(std430, binding = 3) buffer counts { uint count[]; };\n"
        "void tick() { atomicAdd(count[uint(gl_FragCoord.y) * 64u + uint(gl_FragCoord.x)], 1u); }\n"
        "vec3 ssgi_custom_normal(ivec2 p) { tick(); return vec3(0.0, 0.0, 1.0); }\n"
        "float ssgi_custom_depth(ivec2 p) { tick(); return 2.0; }\n",
        "layout(std430, binding = 3) buffer counts { uint count[]; };\n"
        "void tick() { atomicAdd(count[uint(gl_FragCoord.y) * 64u + uint(gl_FragCoord.x)], 1u); }\n"
        "vec3 ssgi_custom_normal(ivec2 p) { tick(); return vec3(0.3, 0.0, 1.0); }\n"
        "float ssgi_custom_depth(ivec2 p) { tick(); return ((p.x / 5 + p.y / 4) & 1) == 0 ? 2.0 : 1.8; }\n" };
    static const struct { int pass, search, rays, thin, normal; } row[] = { { SSGI_GL_SSAO, 0, 0, 1, SSGI_GL_NORMAL_CUSTOM }, { SSGI_GL_HSAO, SSGI_GL_SLICES, 0, 0, SSGI_GL_NORMAL_CUSTOM },
        { SSGI_GL_HSAO, SSGI_GL_SLICES, 0, 1, SSGI_GL_NORMAL_FROM_DEPTH }, { SSGI_GL_HSAO, SSGI_GL_MARCH, 0, 0, SSGI_GL_NORMAL_CUSTOM }, { SSGI_GL_HSAO, SSGI_GL_MARCH, 2, 0, SSGI_GL_NORMAL_CUSTOM } };
    const kit_camera c = looking_along_z(W, H, 0);
    uint32_t count[W * H];
    ssgi_view view;
    ssgi_gl_frame frame;
    GLuint buffer[2], framebuffer, texture;
    GLint blocks = 0;
    glGetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &blocks);
    if (blocks < 1) { t_note("fetches: not counted, %s has no storage blocks in fragment shaders", kit_gl_name()); return; }
    if (!view_of(&view, &c) || ssgi_gl_frame_init(&frame, &view, 0.3f, NULL) != SSGI_OK) return;
    texture = kit_texture(W, H, GL_RG32F, NULL);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    glGenBuffers(2, buffer);
    glBindBufferBase(GL_UNIFORM_BUFFER, 0, buffer[0]);
    glBufferData(GL_UNIFORM_BUFFER, (GLsizeiptr)sizeof frame, &frame, GL_DYNAMIC_DRAW);
    glBindBufferBase(GL_SHADER_STORAGE_BUFFER, 3, buffer[1]);
    glViewport(0, 0, W, H);
    for (int i = 0; i < 10; ++i) {
        ssgi_gl_desc d;
        memset(&d, 0, sizeof d);
        d.dialect = SSGI_GL_450;
        d.depth = SSGI_GL_DEPTH_CUSTOM;
        d.fetch = fetch[i & 1];
        d.pass = row[i / 2].pass;
        d.search = row[i / 2].search;
        d.normal_rays = row[i / 2].rays;
        d.thin = row[i / 2].thin;
        d.normal = row[i / 2].normal;
        d.directions = 3;
        const GLuint program = kit_pass_program(&d, &err);
        const uint32_t told = (uint32_t)ssgi_gl_fetches(&d);
        uint32_t least = ~0u, most = 0;
        if (!CHECK(program != 0, "%s", err.text)) continue;
        memset(count, 0, sizeof count);
        glBufferData(GL_SHADER_STORAGE_BUFFER, (GLsizeiptr)sizeof count, count, GL_DYNAMIC_READ);
        glUseProgram(program);
        glDrawArrays(GL_TRIANGLES, 0, 3);
        glMemoryBarrier(GL_BUFFER_UPDATE_BARRIER_BIT);
        glGetBufferSubData(GL_SHADER_STORAGE_BUFFER, 0, (GLsizeiptr)sizeof count, count);
        for (int k = 0; k < W * H; ++k) {
            const int x = k % W, y = k / W;
            if (count[k] > most) most = count[k];
            if (x >= INSIDE && y >= INSIDE && x < W - INSIDE && y < H - INSIDE && count[k] < least) least = count[k];
        }
        CHECK(most <= told && most > 0, "%s: up to %u fetches a pixel, %u foretold", ssgi_gl_pass_name(d.pass), most, told);
        CHECK((i & 1) || least == told, "%s: %u fetches on a plane, %u foretold", ssgi_gl_pass_name(d.pass), least, told);
        glDeleteProgram(program);
    }
    glDeleteBuffers(2, buffer);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
}

/* ---- the filter -------------------------------------------------------------------------------------------------------------- */

/* What the filter makes of value(x, y, z) in the ao texture (x, y: full-size pixel from below), on the G-buffer of planes. */
static int filtered(kit_image *out, const kit_camera *c, const double (*plane)[4], int planes, const char *set, float (*value)(int x, int y, float z))
{
    kit_gbuffer g, other;
    kit_image frame, right;
    kit_run run;
    memset(out, 0, sizeof *out);
    if (!walls(&g, &frame, c, plane, 1)) return 0;
    if (planes > 1 && walls(&other, &right, c, plane + 1, 1)) {    /* side by side: the second from the middle on */
        for (int i = 0; i < frame.width * frame.height; ++i) if (i % frame.width >= frame.width / 2) frame.data[i] = right.data[i];
        kit_gbuffer_free(&g);
        kit_gbuffer_free(&other);
        kit_image_free(&right);
        if (!CHECK(!kit_gbuffer_from_frame(&g, &frame, c, &err), "%s", err.text)) return 0;
    }
    if (!start(&run, &g, "ssao", set, 0.5f)) return 0;
    kit_pass *p = &run.pass[0];
    const int step = p->desc.half ? 2 : 1;
    float *ao = malloc(2 * sizeof *ao * (size_t)p->width * (size_t)p->height);
    for (int i = 0; i < p->width * p->height; ++i) {
        const int x = i % p->width * step, y = i / p->width * step;
        const float z = frame.data[(frame.height - 1 - y) * frame.width + x];
        ao[2 * i] = value(x, y, z);
        ao[2 * i + 1] = z > 0 ? z : 1e18f;
    }
    glBindTexture(GL_TEXTURE_2D, p->texture);
    glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, p->width, p->height, GL_RG, GL_FLOAT, ao);
    glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer);             /* the first pass draws nowhere: the texture stays ours */
    glDrawBuffers(1, &(GLenum){ GL_NONE });
    const int ok = draw(out, &run);
    free(ao);
    kit_run_close(&run);
    kit_gbuffer_free(&g);
    kit_image_free(&frame);
    return ok;
}

static float constant_value(int x, int y, float z) { (void)x; (void)y; (void)z; return 0.37f; }
static float side_value(int x, int y, float z)     { (void)x; (void)y; return z < 3 ? 0.2f : 0.9f; }
static float tile_value(int x, int y, float z)     { (void)z; return (float)((5 * (x & 3) + 7 * (y & 3) * (y & 3) + (x & 3) * (y & 3)) % 16) / 15; }
static float ramp_value(int x, int y, float z)     { (void)z; return 0.1f + 0.001f * (float)x + 0.002f * (float)y; }

/* how far the picture is from value, or from one number, border pixels left out */
static double off(const kit_image *out, float (*value)(int, int, float), double number, int border)
{
    double worst = 0;
    for (int y = border; y < out->height - border; ++y)
        for (int x = border; x < out->width - border; ++x) {
            const double d = fabs((double)out->data[y * out->width + x] - (value ? (double)value(x, out->height - 1 - y, x < out->width / 2 ? 2 : 4) : number));
            if (!(d <= worst)) worst = d;
        }
    return worst;
}

static void filter_keeps_its_word(void)
{
    static const double facing[2][4] = { { 0, 0, 1, -2 }, { 0, 0, 1, -4 } }, tilted[1][4] = { { 0.48, 0.36, 0.8, -1.6 } };
    static const char *const sets[] = { "blur=1", "blur=2", "blur=4", "blur=2,filter_normals=1", "blur=2,filter=gaussian", "half=1,blur=1", "half=1,blur=2,filter_normals=1", "blur=2,normal=depth" };
    double worst[5] = { 0 }, mean = 0;
    kit_image out;
    for (int i = 0; i < 16; ++i) mean += (double)tile_value(i % 4, i / 4, 1) / 16;
    for (int i = 0; i < 16; ++i) {
        const kit_camera c = looking_along_z(61 + 2 * i, 45, i & 1);
        const char *set = sets[i / 2];
        const int half = !strncmp(set, "half", 4), gaussian = strstr(set, "gaussian") != NULL;
        double d;
        if (!filtered(&out, &c, tilted, 1, set, constant_value)) return;
        worst[0] = fmax(worst[0], d = off(&out, constant_value, 0, 0));
        CHECK(d <= 1e-6, "%s: a constant is off by %g", set, d);
        kit_image_free(&out);
        if (!filtered(&out, &c, facing, 2, set, side_value)) return;
        d = off(&out, side_value, 0, 0);
        worst[gaussian] = fmax(worst[gaussian], gaussian ? d : worst[gaussian]);
        worst[2] = fmax(worst[2], gaussian ? 0 : d);
        CHECK(d <= (gaussian ? 1e-2 : 1e-3), "%s: %g crosses an edge", set, d);     /* the Gaussian's weight is 1 pixel's width over the distance: never 0 */
        kit_image_free(&out);
        if (!half && !gaussian && strncmp(set, "blur=2", 6) == 0) {
            for (int k = 0; k < 2; ++k) {
                if (!filtered(&out, &c, k ? tilted : facing, 1, set, tile_value)) return;
                worst[3] = fmax(worst[3], d = off(&out, NULL, mean, 3));
                CHECK(d <= (k ? 3e-5 : 1e-6), "%s: a tile's mean is off by %g on a plane that is %s", set, d, k ? "tilted" : "facing");
                kit_image_free(&out);
            }
        }
        if (!half) continue;
        if (!filtered(&out, &c, facing, 1, set, ramp_value)) return;
        worst[4] = fmax(worst[4], d = off(&out, ramp_value, 0, 8));
        CHECK(d <= 1e-5, "%s: a ramp is off by %g", set, d);
        kit_image_free(&out);
    }
    t_note("filter: constant %.1e, edge %.1e (Gaussian %.1e), tile %.1e, ramp at half size %.1e", worst[0], worst[2], worst[1], worst[3], worst[4]);
}

void test_pipeline(void)
{
    struct { const char *name; void (*f)(void); } part[] = { { "planes", planes_stay_bright }, { "corner", corner_converges }, { "same", same_picture }, { "sizes", sizes_do_not_matter }, { "garbage", garbage_is_survived }, { "truth", near_the_truth }, { "fetch", fetches_are_counted }, { "filter", filter_keeps_its_word } };
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    for (size_t i = 0; i < sizeof part / sizeof part[0]; ++i) {
        double t = kit_seconds();
        if (getenv("ONLY") && strcmp(getenv("ONLY"), part[i].name)) continue;
        part[i].f();
        t_note("%s %.1f s", part[i].name, kit_seconds() - t);
    }
    kit_gl_close();
}
