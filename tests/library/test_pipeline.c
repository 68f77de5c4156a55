/* test_pipeline.c - the passes of AO, drawn: the march's closed forms, tiny radii, garbage and sizes (also of light's
   passes), thickness, the filter. */
#include "t.h"
#include "frames.h"
#include "kit/kit_run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;

/* 33 samples, not 32: Mesa unrolls loops of up to 32 samples, and then takes long to compile them. */
static const struct {
    const char *method, *set;
} methods[] = { { "ssao", "directions=33" },
                { "hsao", "samples=33" },
                { "hsao-best", "samples=33" },
                { "hsao-march", "samples=33" },
                { "hsao-march", "samples=33,normal_rays=2,thickness=solid" },
                { "ssao", "directions=33,normal=depth,thickness=solid" },
                { "hsao", "samples=33,normal=depth,thickness=constant" },
                { "ssdo", "slices=1,samples=33,bounce=none,environment=sh,resolution=full,blur=0" },
                { "s3ho",
                  "slices=1,samples=33,indirect=none,store=float,filtered=coefficients,resolution=full,blur=0" } };
enum { METHODS = ROWS(methods), LIT = METHODS - 2 };

/* Gives a run another G-buffer of any size, at the defaults, in uniform light, as a new run would compile anew. */
static int fit(kit_run *run, kit_gbuffer *g, float radius)
{
    static const float uniform[3] = { 3.5449077f, 3.5449077f, 3.5449077f };
    ssgi_view view;
    const char *why = "";
    if (!CHECK(ssgi_view_from_projection(&view, g->projection,
                                         g->camera.depth == KIT_DEPTH_NORMAL ? SSGI_CLIP_GL : SSGI_CLIP_ZERO,
                                         g->viewport[2], g->viewport[3], &why)
                       == SSGI_OK
                   && ssgi_gl_frame_init(&run->frame, &view, radius, &why) == SSGI_OK,
               "%s", why))
        return 0;
    ssgi_gl_harmonics_set(&run->frame, uniform, 1, NULL, NULL);
    turn(run, g);
    for (int i = 0; i < 2; ++i) run->frame.origin[i] = g->viewport[i];
    for (int i = 0; i < run->passes; ++i) {
        const int by = kit_step_part(run->pass[i].step);
        resize(&run->pass[i], (g->viewport[2] + by - 1) / by, (g->viewport[3] + by - 1) / by, NULL);
    }
    return 1;
}

/* ---- closed forms ------------------------------------------------------------------------------------------------ */

/* Returns the march's exact occlusion at a point of a floor at distance c from an endless wall, whose face is seen from
   45 degrees above, with radius 1 [HSAO08 fig. 4]: along tangents at evenly spread azimuths, as in corner_converges. */
static double exact_march(double c, int steps, int hard, int spheres)
{
    enum { AZIMUTHS = 512 };
    double sum = 0;
    for (int a = 0; a < AZIMUTHS; ++a) {
        const double x = cos(2 * pi * (a + 0.5) / AZIMUTHS), y = sin(2 * pi * (a + 0.5) / AZIMUTHS);
        double H = 0;
        for (int i = 1; i <= steps; ++i) {
            const double d = (double)i / steps, along = d * sqrt(1 - H * H);
            if (along * x <= c) continue;
            /* (up, along): where the eye's ray meets the wall's face */
            const double up = d * H + (along * x - c), l = sqrt(c * c + along * along * y * y + up * up),
                         ahead = c * x + along * y * y, rise = up / sqrt(up * up + ahead * ahead);
            if (l >= 1 || (spheres && l >= (i + 1.0) / steps) || ahead <= 0 || rise <= H) continue;
            sum += (rise * rise - H * H) * (hard ? 1 : 1 - l);
            H = rise;
        }
    }
    return sum / AZIMUTHS;
}

/* Checks the march without jitter against its closed forms. It is darker than the truth by a bound that falls with its
   steps. The visible face is nearer than a ray's end, so spheres change nothing. */
static void corner_converges(void)
{
    static const double at[] = { 0.1, 0.25, 0.5, 0.75 };
    static const struct { int steps, hard, spheres; } row[] = { { 6, 0, 0 },  { 12, 0, 0 }, { 24, 0, 0 },
                                                                { 48, 0, 0 }, { 6, 1, 0 },  { 12, 1, 0 },
                                                                { 24, 1, 0 }, { 48, 1, 0 }, { 24, 1, 1 } };
    kit_gbuffer g[4];
    double worst = 0, scaled[2] = { 0 };
    float tile[16][4];
    for (int i = 0; i < 16; ++i) { tile[i][0] = 1; tile[i][1] = tile[i][2] = 0; tile[i][3] = (float)i / 16; }
    for (int i = 0; i < 4; ++i) {
        double plane[2][4];
        OWN(kit_image) frame = { 0 };
        const kit_camera camera = corner_planes(plane, at[i], 0);
        if (!walls(&g[i], &frame, &camera, (const double (*)[4])plane, 2, "")) return;
    }
    for (int m = 0; m < ROWS(row); ++m) {
        OWN(kit_run) run = { 0 };
        char set[112];
        const int steps = row[m].steps, hard = row[m].hard;
        snprintf(set, sizeof set,
            "directions=32,normal_rays=0,blur=0,noise=texture,samples=%d,falloff=%s,growing_sphere=%d",
                 steps, hard ? "none" : "linear", row[m].spheres);
        if (!open_run(&run, &g[0], "hsao-march", set, 1, NULL, NULL)) return;
        glBindTexture(GL_TEXTURE_2D, run.noise);           /* noise of 16 * 32 directions that jitters no samples */
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 16, 1, 0, GL_RGBA, GL_FLOAT, tile);
        for (int i = 0; i < 4; ++i) {
            const double exact = exact_march(at[i], steps, hard, row[m].spheres),
                         o = 1 - row_of(&run, &g[i], row_at(at[i]), 1),
                         low = (hard ? hard_corner : linear_corner)(at[i]) - o;
            worst = fmax(worst, fabs(o - exact));
            scaled[hard] = fmax(scaled[hard], low * steps);
            CHECK(fabs(o - exact) <= 0.004 && low <= (hard ? 1.7 : 2.5) / steps && low > -0.002,
                  "%s, c %g: %.4f, the exact march has %.4f, and is %.4f below the truth", set, at[i], o, exact, low);
        }
    }
    t_note("%.4f off the exact march, %.2f/steps off the truth, hard %.2f/steps", worst, scaled[0], scaled[1]);
    for (int i = 0; i < 4; ++i) kit_gbuffer_free(&g[i]);
}

/* ---- the march's terms and layers: closed forms ----------------------------------------------------------------- */

enum { PIT = 160, PIT_RADIUS = 60 };      /* in pixels: the picture's width, and the radius */
static const double pit_lid = 0.6, pit_wall = 0.3;    /* in radii over the floor; pit_wall also from its centre */

/* Makes the floor at depth 4, seen straight down through the single pixel that a lid, 0.05 radii thick, leaves open;
   with wall, solid matter around it. Up to three layers. */
static int pit(kit_gbuffer *g, int lid, int wall)
{
    kit_camera camera = looking_along_z(PIT, PIT, 1);
    OWN(kit_image) frame = { 0 };
    camera.ortho_height = (float)PIT / PIT_RADIUS;
    if (!TRY(kit_image_new(&frame, PIT, PIT,
                           "Z,N.X,N.Y,N.Z,layer1.Z,layer1.N.X,layer1.N.Y,layer1.N.Z,layer2.Z,layer2.N.X,layer2.N.Y,"
                           "layer2.N.Z", &err)))
        return 0;
    for (int i = 0; i < PIT * PIT; ++i) {
        const double x = (double)(i % PIT - PIT / 2) / PIT_RADIUS, y = (double)(i / PIT - PIT / 2) / PIT_RADIUS,
                     floor_ = wall && sqrt(x * x + y * y) > pit_wall ? 4 - pit_wall : 4,
                     z[3] = { 4 - pit_lid, 4 - pit_lid + 0.05, floor_ };
        const int first = lid && (i % PIT != PIT / 2 || i / PIT != PIT / 2) ? 0 : 2;
        for (int k = first; k < 3; ++k) {
            frame.data[4 * (k - first) * PIT * PIT + i] = (float)z[k];
            frame.data[(4 * (k - first) + 3) * PIT * PIT + i] = 1;
        }
    }
    return TRY(kit_gbuffer_from_frame(g, &frame, &camera, &err));
}

/* Returns the occlusion at the picture's centre pixel, as a mean over phases. The frame's first row is the top. */
static double at_centre(kit_run *run)
{
    enum { PHASES = 16, X = PIT / 2, Y = PIT / 2 - 1 };
    double sum = 0;
    glEnable(GL_SCISSOR_TEST);
    glScissor(X, Y, 1, 1);
    for (int k = 0; k < PHASES; ++k) {
        float visible = 0;
        run->frame.phase = (float)k / PHASES;
        kit_run_update(run);
        kit_run_draw(run, 0);
        glReadPixels(X, Y, 1, 1, GL_RED, GL_FLOAT, &visible);
        sum += 1 - (double)visible;
    }
    glDisable(GL_SCISSOR_TEST);
    return sum / PHASES;
}

static void terms_of_the_march(void)
{
    static const struct {
        const char *set;
        int lid, wall;
        double least, most;
    } row[] = { /* Below a lid. Without its back the lid has no end, and the horizon rises up to it. With its back it
                   does not, and normal rays meet the lid within the radius if z > 0.55. A sphere never reaches it */
                { "march_terms=horizon", 1, 0, 0.99, 1 },
                { "march_terms=horizon,growing_sphere=1", 1, 0, 0, 0 },
                { "march_terms=horizon,layers=3", 1, 0, 0, 0 },
                { "march_terms=normal,layers=3", 1, 0, 0.68, 0.7 },
                { "march_terms=both,layers=3", 1, 0, 0.68, 0.7 },
                { "march_terms=rays,layers=3", 1, 0, 0.68, 0.7 },
                /* inside of a wall up to 45 degrees: half is occluded; normal rays find the part that the last step
                   left */
                { "march_terms=horizon", 0, 1, 0.44, 0.5 },
                { "march_terms=both", 0, 1, 0.48, 0.51 },
                { "march_terms=rays", 0, 1, 0.48, 0.51 },
                { "march_terms=normal", 0, 1, 0, 0.06 },
                /* lid and wall: nothing is open, so the shares below and above the horizon add up to 1 */
                { "march_terms=horizon,layers=3", 1, 1, 0.5, 0.56 },
                { "march_terms=normal,layers=3", 1, 1, 0.44, 0.5 },
                { "march_terms=both,layers=3", 1, 1, 0.999, 1 },
                { "march_terms=rays,layers=3", 1, 1, 0.999, 1 },
                /* a wall seen from above: its top at x is within a step beyond x if x > (0.09 - s^2) / 2s, s = 1/12;
                   the march finds it there or up to a step later, at 0.5 to 0.58 */
                { "march_terms=horizon,growing_sphere=1,samples=12", 0, 1, 0.208, 0.266 } };
    double o[ROWS(row)];
    for (int i = 0; i < ROWS(row); ++i) {
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_run) run = { 0 };
        char set[160];
        snprintf(set, sizeof set,
                 "directions=32,normal_rays=8,samples=48,falloff=none,blur=0,offset=0,thickness=solid,%s", row[i].set);
        if (!pit(&g, row[i].lid, row[i].wall) || !open_run(&run, &g, "hsao-march", set, 1, NULL, NULL)) return;
        o[i] = at_centre(&run);
        CHECK(o[i] >= row[i].least - 1e-6 && o[i] <= row[i].most + 1e-6, "%s%s%s: %.4f, not in %g..%g", row[i].set,
              row[i].lid ? ", lid" : "", row[i].wall ? ", wall" : "", o[i], row[i].least, row[i].most);
    }
    CHECK(fabs(o[2] + o[3] - o[4]) < 1e-5 && fabs(o[6] + o[9] - o[7]) < 1e-5 && fabs(o[10] + o[11] - o[12]) < 1e-5,
          "the terms are not the sum's: %g + %g, %g; %g + %g, %g; %g + %g, %g", o[2], o[3], o[4], o[6], o[9], o[7],
          o[10], o[11], o[12]);
    t_note("lid %.4f, wall %.4f + %.4f, both %.4f + %.4f", o[4], o[6], o[9], o[10], o[11]);
}

/* ---- sizes, radii, garbage --------------------------------------------------------------------------------------- */

/* Returns how many pixels of any pass are not in [0,1]; of light and its coefficients, not within 2 sqrt(pi), the value
   of all light; or not 1 at pixels without a surface. On a GPU the quotient of equal sums may be 1 and a rounding. */
static int wrong(const kit_run *run, const float *nothing, int light)
{
    int n = 0;
    for (int i = 0; i < run->passes; ++i) {
        const kit_pass *p = &run->pass[i];
        float v[160 * 90];
        if (p->desc.pass == SSGI_GL_PASS_THICKNESS) continue;
        if (p->width * p->height > 160 * 90 || kit_texture_read(p->target[0], p->width, p->height, 1, v)) return -1;
        for (int k = 0; k < p->width * p->height; ++k)
            n += light ? !(fabsf(v[k]) < 3.55f)
                       : !(v[k] >= 0 && v[k] <= 1 + 2.4e-7f)
                             || (nothing && (p->desc.pass == SSGI_GL_PASS_BLUR || !p->desc.gather.resolution)
                                 && !(nothing[k] > 0) && v[k] < 1);
    }
    return n;
}

/* Makes a G-buffer of textures with these values. */
static kit_gbuffer raw(const kit_camera *c, int linear, GLenum format, const float *depth, const float *normal)
{
    kit_gbuffer g = { .width = c->width,
                      .height = c->height,
                      .viewport = { 0, 0, c->width, c->height },
                      .depth_is_linear = linear,
                      .camera = *c,
                      .layers = 1 };
    float world[16];
    g.depth = kit_texture(c->width, c->height, format, depth);
    g.normal = kit_texture(c->width, c->height, GL_RGBA32F, normal);
    kit_camera_matrices(c, world, g.projection);
    return g;
}

/* Checks that methods see nothing at a tiny radius. A point is lifted by most of a pixel, so it may lie behind a
   silhouette beside it, and solid surfaces then block it at any radius: a limit of ssao and of normal rays. */
static void tiny_radii_see_nothing(void)
{
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    if (!see(&scene, &g, "room", NULL, 0, NULL, 160, 90)) return;
    for (int m = 0; m < LIT; ++m) {
        const int allowed = strstr(methods[m].set, "thickness=solid") ? 160 * 90 / 10 : 0;
        OWN(kit_run) run = { 0 };
        OWN(kit_image) out = { 0 };
        int dark = 0;
        if (!open_run(&run, &g, methods[m].method, methods[m].set, 1e-6f, NULL, NULL) || !drawn(&out, &run)) return;
        for (int i = 0; i < out.width * out.height; ++i) dark += !(out.data[i] >= 1 - 1e-6f);
        CHECK(dark <= allowed, "%s %s: %d pixels are not 1", methods[m].method, methods[m].set, dark);
    }
}

/* Checks random values among sound texels, more in each picture; and sound pictures of every size, with holes, half of
   the sizes in each projection. One program of each method draws all of them, also kinds that it cannot tell apart. */
static void garbage_is_survived(void)
{
    /* the squares of some are not finite */
    static const float odd[] = { NAN,    INFINITY, -INFINITY, 0,      -0.0f,  -1,    1e-45f, 1e-39f, 1e-30f,
                                 1e-20f, 1e-19f,   1e-17f,    1e-12f, 1e-6f,  0.25f, 0.5f,   0.999f, 1,
                                 2,      1e6f,     1e12f,     9e17f,  1e18f,  1e30f, 1e38f,  -1e38f };
    static const int widths[] = { 1, 2, 3, 5, 17, 64 }, heights[] = { 1, 2, 3, 7, 33 };
    enum { SEEDS = 8, SIZES = ROWS(widths) * ROWS(heights), MOST = 64 * 33 };
    static const struct { const char *name; int linear, orthographic, layout; GLenum format;
    } kind[] = { { "view depth", 1, 0, KIT_DEPTH_NORMAL, GL_R32F },
                 { "view depth, orthographic", 1, 1, KIT_DEPTH_NORMAL, GL_R32F },
                 { "orthographic", 0, 1, KIT_DEPTH_REVERSED, GL_R32F },
                 { "window depth", 0, 0, KIT_DEPTH_NORMAL, GL_R32F },
                 { "reversed", 0, 0, KIT_DEPTH_REVERSED, GL_R32F },
                 { "infinite", 0, 0, KIT_DEPTH_INFINITE, GL_R32F },
                 { "hardware depth", 0, 0, KIT_DEPTH_NORMAL, GL_DEPTH_COMPONENT32F } };
    static float depth[SEEDS + SIZES / 2][MOST], normal[4 * MOST];
    static kit_run runs[METHODS];
    OWN(kit_lighting) white = { 0 };
    kit_gbuffer g[SEEDS + SIZES / 2];
    if (!lighten(&white, "white", NULL)) return;
    for (int k = 0; k < ROWS(kind); ++k) {
        const int pictures = kind[k].linear ? SEEDS + SIZES / 2 : SEEDS;
        for (int s = 0; s < pictures; ++s) {
            const int size = 2 * (s - SEEDS) + k, width = s < SEEDS ? 24 : widths[size % ROWS(widths)],
                      height = s < SEEDS ? 13 : heights[size / ROWS(widths)];
            kit_camera c = looking_along_z(width, height, kind[k].orthographic);
            c.depth = kind[k].layout;
            t_seed((uint32_t)s);
            for (int i = 0; i < width * height; ++i)
                depth[s][i] = s >= SEEDS                 ? t_below(4) ? 1 + 0.01f * (float)t_below(100) : 0
                              : (int)t_below(SEEDS) <= s ? odd[t_below(ROWS(odd))]
                                                         : 0.5f + 0.004f * (float)t_below(100);
            for (int i = 0; i < 4 * width * height; ++i)
                normal[i] = s < SEEDS && (int)t_below(SEEDS) <= s ? odd[t_below(ROWS(odd))]
                                                                  : 0.01f * (float)t_below(200) - 1;
            g[s] = raw(&c, kind[k].linear, kind[k].format, depth[s], normal);
            if (!kind[k].linear)                           /* from here on view depth only marks surfaces */
                for (int i = 0; i < width * height; ++i)
                    depth[s][i] = depth[s][i] == (kind[k].layout == KIT_DEPTH_NORMAL ? 1.0f : 0.0f) ? 0.0f : 1.0f;
        }
        for (int m = 0; m < METHODS; ++m) {
            kit_run *run = &runs[m];
            if (k < 4 && !open_run(run, &g[0], methods[m].method, methods[m].set, 0.5f, NULL, &white)) return;
            for (int s = 0; s < pictures; ++s) {
                if (!fit(run, &g[s], s < SEEDS && s % 3 == 0 ? 1e5f : 0.5f)) return;
                kit_run_update(run);
                kit_run_draw(run, 0);
                const int n = wrong(run, depth[s], m >= LIT);
                CHECK(!n, "%s, %s %s, picture %d, %d x %d: %d pixels are NaN, out of range or dark where nothing is",
                      kind[k].name, methods[m].method, methods[m].set, s, g[s].width, g[s].height, n);
            }
            if (k < 3 || k == ROWS(kind) - 1) kit_run_close(run);
        }
        for (int s = 0; s < pictures; ++s) kit_gbuffer_free(&g[s]);
    }
}

/* Checks a post 12 pixels wide and a pole of one pixel before a wall: the measured thickness of each, by its own width,
   also if it is turned from the viewer; by back faces; and as a sheet, which is seen by its back face. View depths are
   stored, too. */
static void widths_are_measured(void)
{
    enum { W = 96, H = 64, POST = 20, ACROSS = 12, POLE = 45 };
    static const struct { int orthographic; double slant; /* footprints of depth a
                                                             pixel */ const char *set; } rows[] = {
        { 1, 0, "thickness=width" }, { 1, 0, "thickness=back" }, { 1, 3, "thickness=width" },
        { 0, 1.5, "thickness=width" } };
    static float depth[W * H], back[W * H], normal[4 * W * H];
    static uint32_t got[W * H];
    for (size_t r = 0; r < sizeof rows / sizeof *rows; ++r) {
        const int orthographic = rows[r].orthographic, m = !strcmp(rows[r].set, "thickness=back");
        const kit_camera c = looking_along_z(W, H, orthographic);
        const double wide = orthographic ? 2.0 / H : 2 * tan(acos(-1) / 8) / H,      /* a pixel's width at depth 1 */
                     close = orthographic ? wide : 5 * wide, radius = 32 * close;
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_run) run = { 0 };
        int bad[4] = { 0 };
        for (int i = 0; i < W * H; ++i) {
            const int x = i % W, y = i / W, post = x >= POST && x < POST + ACROSS;
            const double off = rows[r].slant * close * (x - POST);
            depth[i] = (float)(x == POLE ? 4 : !post ? 10 : orthographic ? 5 + off : 1 / (0.2 - off / 25));
            back[i] = x == POLE ? 4 : !post ? 0 : y < H / 2 ? 5.5f : 5; /* the post: a solid below, a sheet above */
            normal[4 * i + 2] = 1;
        }
        g = raw(&c, 1, GL_R32F, depth, normal);
        g.back = kit_texture(W, H, GL_R32F, back);
        if (!open_run(&run, &g, "hsao", rows[r].set, (float)radius, NULL, NULL)) return;
        run.frame.thickness_limit = (float)radius;
        kit_run_update(&run);
        kit_run_draw(&run, 0);
        if (!CHECK(run.pass[0].desc.pass == SSGI_GL_PASS_THICKNESS, "row %zu: the first pass is another", r)) return;
        glBindFramebuffer(GL_FRAMEBUFFER, run.pass[0].framebuffer);
        glReadPixels(0, 0, W / 2, H / 2, GL_RGBA_INTEGER, GL_UNSIGNED_INT, got);
        for (int y = 8; y < H - 8; ++y)
            for (int x = 8; x < W - 8; ++x) {
                unsigned code;
                const float z = unpack_measured(&code, &got[4 * (y / 2 * W / 2 + x / 2)], 2 * (y & 1) + (x & 1),
                                                orthographic), is = depth[y * W + x];
                const double most = radius / (orthographic ? wide : wide * (double)depth[y * W + (x & ~1)]),
                             thick = code / 63.0 * most;                            /* in pixels */
                const int post = x >= POST && x < POST + ACROSS;
                bad[0] += orthographic ? z != is : fabsf(z - is) > 1e-5f * is;
                if (post && m && y < H / 2) bad[1] += fabs(thick - 16) > 0.3;        /* 0.5 units */
                else if (post) bad[1] += !(thick >= (m ? 0.25 : 0.5) * ACROSS - 0.3 && thick <= (m ? 0.5 : 1) * ACROSS);
                else if (x == POLE) bad[2] += fabs(thick / most - (m ? 0.05 : 0.1)) > 0.01; /* not its 2x2's surface */
                else bad[3] += thick < 0.99 * most && x != POLE - 1;                 /* the wall must have no end */
            }
        CHECK(!bad[0] && !bad[1] && !bad[2] && !bad[3], "row %zu: wrong are %d depths, %d pixels of the post, %d of "
              "the pole, %d of the wall", r, bad[0], bad[1], bad[2], bad[3]);
    }
}

/* ---- the filter -------------------------------------------------------------------------------------------------- */

static float constant_value(int x, int y) { (void)x; (void)y; return 0.37f; }
static float side_value(int x, int y)     { (void)y; return x < 30 ? 0.2f : 0.9f; }
static float tile_value(int x, int y)
{
    return (float)((5 * (x & 3) + 7 * (y & 3) * (y & 3) + (x & 3) * (y & 3)) % 16) / 15;
}
static float mean_value(int x, int y)
{
    float sum = 0;
    for (int i = 0; i < 16; ++i) sum += tile_value(i & 3, i / 4) / 16;
    (void)x;
    (void)y;
    return sum;
}
static float ramp_value(int x, int y)     { return 0.1f + 0.001f * (float)x + 0.002f * (float)y; }

/* Returns the largest difference between the filtered picture of value and expected (x, y: full-size pixel from below),
   without border pixels, on a plane or on two, the second from column 30 on. run: open with this set, or all 0. */
static double filtered(kit_run *run, const kit_camera *c, const double (*plane)[4], int planes, const char *set,
                       float (*value)(int x, int y), float (*expected)(int x, int y), int border)
{
    OWN(kit_gbuffer) g = { 0 };
    OWN(kit_image) frame = { 0 }, right = { 0 }, out = { 0 };
    double worst = 0;
    if (!planes_seen(&frame, c, plane, 1, "") || !planes_seen(&right, c, plane + planes - 1, 1, "")) return 1;
    for (int i = 0; i < frame.width * frame.height; ++i) if (i % frame.width >= 30) frame.data[i] = right.data[i];
    if (!TRY(kit_gbuffer_from_frame(&g, &frame, c, &err))) return 1;
    if ((!run->passes && !open_run(run, &g, "ssao", set, 0.5f, NULL, NULL)) || !fit(run, &g, 0.5f)) return 1;
    kit_pass *p = &run->pass[0];
    const int step = p->desc.gather.resolution ? 2 : 1;
    glBindTexture(GL_TEXTURE_2D, p->target[0]);
    for (int y = 0; y < p->height; ++y)
        for (int x = 0; x < p->width; ++x) {
            const float ao[2] = { value(x * step, y * step),
                                  frame.data[(frame.height - 1 - y * step) * frame.width + x * step] };
            glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, 1, 1, GL_RG, GL_FLOAT, ao);
        }
    /* the first pass writes nothing, so the texture keeps our values */
    glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer);
    glDrawBuffers(1, &(GLenum){ GL_NONE });
    if (!drawn(&out, run)) return 1;
    for (int y = border; y < out.height - border; ++y)
        for (int x = border; x < out.width - border; ++x) {
            const double d = fabs((double)out.data[y * out.width + x] - (double)expected(x, out.height - 1 - y));
            if (!(d <= worst)) worst = d;
        }
    return worst;
}

static void filter_keeps_its_word(void)
{
    static const double facing[2][4] = { { 0, 0, 1, -2 }, { 0, 0, 1, -4 } },
                        tilted[1][4] = { { 0.48, 0.36, 0.8, -1.6 } };
    static const struct {
        const char *set;
        double edge;
        int tile, ramp;
    } row[] = { { "blur=1", 1e-3, 0, 0 },
                { "blur=2", 1e-3, 1, 0 },
                { "blur=4", 1e-3, 0, 0 },
                { "blur=2,filter_normals=1", 1e-3, 1, 0 },
                /* its weight is a pixel's width over the distance, and never 0 */
                { "blur=2,normal=depth", 1e-3, 0, 0 },
                { "blur=2,filter=gaussian", 0.02, 0, 0 },
                { "resolution=half,blur=1", 1e-3, 0, 1 },
                { "resolution=half,blur=2,filter_normals=1", 1e-3, 0, 1 } };
    double worst[5] = { 0 };
    for (int i = 0; i < 16; ++i) {
        const kit_camera c = looking_along_z(61 + 2 * i, 45, i & 1);
        const char *set = row[i / 2].set;
        OWN(kit_run) run = { 0 };
        const double constant = filtered(&run, &c, tilted, 1, set, constant_value, constant_value, 0),
                     edge = filtered(&run, &c, facing, 2, set, side_value, side_value, 0),
                     tile = row[i / 2].tile ? fmax(filtered(&run, &c, facing, 1, set, tile_value, mean_value, 3),
                                                   filtered(&run, &c, tilted, 1, set, tile_value, mean_value, 3))
                                            : 0,
                     ramp = row[i / 2].ramp ? filtered(&run, &c, facing, 1, set, ramp_value, ramp_value, 8) : 0;
        /* half resolution: odd pixels have one more sample to the left and below, which shifts the result by less than
           half a pixel */
        CHECK(constant <= 1e-6 && edge <= row[i / 2].edge, "%s: a constant is off by %g, %g crosses an edge", set,
              constant, edge);
        CHECK(tile <= 1e-6 && ramp <= 0.5 * (0.001 + 0.002), "%s: a tile's mean is off by %g, a ramp by %g", set, tile,
              ramp);
        worst[0] = fmax(worst[0], constant);
        worst[1 + (i / 2 == 5)] = fmax(worst[1 + (i / 2 == 5)], edge);
        worst[3] = fmax(worst[3], tile);
        worst[4] = fmax(worst[4], ramp);
    }
    t_note("constant %.1e, edge %.1e, Gaussian's %.1e, tile %.1e, ramp %.1e", worst[0], worst[1], worst[2], worst[3],
           worst[4]);
}

/* ---- compute stages ---------------------------------------------------------------------------------------------- */

/* Draws three frames of a moving camera in fragment stages or in compute stages, and keeps the last one. */
static int by_stages(kit_image *out, const char *method, const char *set, int compute, const kit_scene *scene,
                     const kit_lighting *l)
{
    kit_camera c = scene->camera;
    kit_gbuffer g[3];
    kit_run run[3];
    int ok = 1, opened = 0;
    if (compute) setenv("KIT_COMPUTE", "1", 1);
    for (; ok && opened < 3; ++opened) {
        c.eye[0] += 0.02f;
        c.width = 101;
        c.height = 67;
        ok = TRY(kit_gbuffer_from_scene(&g[opened], scene, &c, NULL, &err))
             && open_run(&run[opened], &g[opened], method, set, 0.4f, scene, l)
             && CHECK((run[opened].pass[0].step->groups[0] > 0) == compute, "%s: stages of another kind", method);
    }
    unsetenv("KIT_COMPUTE");
    for (int t = 0; ok && t < opened; ++t) {
        if (t && run[0].pass[run[0].passes - 1].last[0])
            ok = TRY(kit_run_follow(&run[t], &run[t - 1], (unsigned)t, &err));
        kit_run_update(&run[t]);
        kit_run_draw(&run[t], KIT_UNTIMED);
    }
    ok = ok && TRY(kit_run_read(out, &run[2], &err));
    for (int t = 0; t < opened; ++t) {
        kit_run_close(&run[t]);
        kit_gbuffer_free(&g[t]);
    }
    return ok;
}

static void compute_writes_the_same(void)
{
    static const char *const row[][2] = { { "hsao", "" },
                                          { "hsao-history", "" },
                                          { "ssdo", "bounce=solid-angle,samples=4,shadow_size=64" },
                                          { "s3ho", "samples=4,shadow_size=64" } };
    OWN(kit_scene) scene = { 0 };
    kit_lighting l;
    if (!TRY(kit_scene_load(&scene, "room", 0, &err)) || !lighten(&l, "sky", "point:0,2,0,8,8,8")) return;
    for (int i = 0; i < ROWS(row); ++i) {
        OWN(kit_image) is = { 0 }, was = { 0 };
        if (!by_stages(&was, row[i][0], row[i][1], 0, &scene, &l)
            || !by_stages(&is, row[i][0], row[i][1], 1, &scene, &l)) return;
        const int n = is.width * is.height * is.channels;
        int differ = 0;
        for (int k = 0; k < n; ++k) differ += memcmp(&is.data[k], &was.data[k], sizeof *is.data) != 0;
        CHECK(!differ, "%s,%s: %d of %d values differ by a compute stage", row[i][0], row[i][1], differ, n);
        t_note("%s: %d of %d values differ", row[i][0], differ, n);
    }
}

void test_pipeline(void)
{
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("the corner agrees with the paper's march, and that with closed forms", corner_converges);
    RUN("the march's terms, its layers and its spheres are what closed forms say", terms_of_the_march);
    RUN("a tiny radius sees nothing", tiny_radii_see_nothing);
    RUN("garbage in depth and normals stays within [0,1], of light within all of it; so does every size of picture",
        garbage_is_survived);
    RUN("a post is as thick as it is wide, or as its back face says; a sheet half as thick", widths_are_measured);
    RUN("the filter keeps constants, edges and ramps, and averages a tile of noise", filter_keeps_its_word);
    RUN("compute stages write the bits that fragments do, over frames and of light, too", compute_writes_the_same);
    kit_gl_close();
}
