/* test_pipeline.c - the AO passes through the whole of GL: closed forms, invariances, sizes, garbage, truth, cost, the
   filter. */
#include "t.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;
#define TRY(call) CHECK(!(call), "%s", err.text)

/* 33 samples, steps: loops of up to 32 Mesa unrolls, and is then long at compiling them. */
static const struct {
    const char *method, *set;
} methods[] = { { "ssao", "samples=33" },
                { "hsao", "steps=33" },
                { "hsao-fast", "steps=33" },
                { "hsao-best", "steps=33" },
                { "hsao-march", "steps=33" },
                { "hsao-march", "steps=33,normal_rays=2,thickness=solid" },
                { "ssao", "samples=33,normal=depth,thickness=solid" },
                { "hsao", "steps=33,normal=depth,thickness=constant" } };
enum { METHODS = (int)(sizeof methods / sizeof methods[0]) };

/* ---- pictures ---------------------------------------------------------------------------------------------------- */




static int walls(kit_gbuffer *g, kit_image *frame, const kit_camera *c, const double (*plane)[4], int planes)
{
    return planes_seen(frame, c, plane, planes, "") && TRY(kit_gbuffer_from_frame(g, frame, c, &err));
}

static int load(kit_scene *scene, int width, int height)
{
    if (!TRY(kit_scene_load(scene, "room", 0, &err))) return 0;
    scene->camera.width = width;
    scene->camera.height = height;
    return 1;
}

static int start(kit_run *run, kit_gbuffer *g, const char *name, const char *set, float radius)
{
    kit_method m;
    return CHECK(!kit_method_find(&m, name, &err) && !kit_method_set(&m, set, &err)
                     && !kit_run_open(run, g, &m, radius, NULL, &err),
                 "%s %s: %s", name, set, err.text);
}


static int draw(kit_image *out, kit_run *run)
{
    kit_run_update(run);
    kit_run_draw(run, 0);
    return TRY(kit_run_read(out, run, &err));
}

/* Turns a run to another G-buffer, whatever its size, at the defaults: compiling is what takes time. beyond: the
   targets are so much larger, the picture at (8, 6) in them. */
static int fit(kit_run *run, kit_gbuffer *g, float radius, int beyond)
{
    ssgi_view view;
    const char *why = "";
    if (!CHECK(ssgi_view_from_projection(&view, g->projection,
                                         g->camera.depth == KIT_DEPTH_NORMAL ? SSGI_CLIP_GL : SSGI_CLIP_ZERO,
                                         g->viewport[2], g->viewport[3], &why)
                       == SSGI_OK
                   && ssgi_gl_frame_init(&run->frame, &view, radius, &why) == SSGI_OK,
               "%s", why))
        return 0;
    turn(run, g);
    for (int i = 0; i < 2; ++i) run->frame.origin[i] = g->viewport[i];
    if (beyond) { run->frame.target[0] = 8; run->frame.target[1] = 6; }
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        const int width = p->desc.pass == SSGI_GL_PASS_THICKNESS, blur = p->desc.pass == SSGI_GL_PASS_BLUR;
        const int by = width || (p->desc.gather.half && !blur) ? 2 : 1;
        p->width = (g->viewport[2] + by - 1) / by + beyond;
        p->height = (g->viewport[3] + by - 1) / by + beyond;
        glBindTexture(GL_TEXTURE_2D, p->target[0]);
        glTexImage2D(GL_TEXTURE_2D, 0, width ? GL_RGBA32UI : blur ? GL_R32F : GL_RG32F, p->width, p->height, 0,
                     width ? GL_RGBA_INTEGER : blur ? GL_RED : GL_RG, width ? GL_UNSIGNED_INT : GL_FLOAT, NULL);
    }
    return 1;
}

/* run: opened with this method and set already, or all 0 */
static int picture(kit_image *out, kit_run *run, kit_gbuffer *g, const char *name, const char *set, float radius,
                   float phase, int beyond)
{
    kit_image all;
    if ((!run->passes && !start(run, g, name, set, radius)) || !fit(run, g, radius, beyond)) return 0;
    run->frame.phase = phase;
    if (!draw(&all, run)) return 0;
    if (!beyond) { *out = all; return 1; }
    const int ok = TRY(kit_image_new(out, g->viewport[2], g->viewport[3], "Y", &err));
    for (int y = 0; ok && y < out->height; ++y)
        memcpy(out->data + y * out->width, all.data + (all.height - 6 - out->height + y) * all.width + 8,
               (size_t)out->width * sizeof(float));
    kit_image_free(&all);
    return ok;
}

/* ---- closed forms ------------------------------------------------------------------------------------------------ */


static int corner(kit_gbuffer *g, double c)
{
    double plane[2][4];
    const kit_camera camera = corner_planes(plane, c, 0);
    kit_image frame;
    const int ok = walls(g, &frame, &camera, (const double (*)[4])plane, 2);
    kit_image_free(&frame);
    return ok;
}


/* The march over a floor along x, up to the face of a wall at c that rises without end, from 45 degrees above, radius 1
   [HSAO08 fig. 4]: occlusion along tangents at azimuths evenly spread, as the table of corner_converges has it. */
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
            /* the eye's ray meets the face there */
            const double up = d * H + (along * x - c), l = sqrt(c * c + along * along * y * y + up * up),
                         ahead = c * x + along * y * y, rise = up / sqrt(up * up + ahead * ahead);
            if (l >= 1 || (spheres && l >= (i + 1.0) / steps) || ahead <= 0 || rise <= H) continue;
            sum += (rise * rise - H * H) * (hard ? 1 : 1 - l);
            H = rise;
        }
    }
    return sum / AZIMUTHS;
}

static void corner_converges(void)
{
    /* the exact march at 6, 12, 24, 48 steps, no jitter; the second without attenuation */
    static const double at[] = { 0.1, 0.25, 0.5, 0.75 },
                        march[2][4][4] = { { { 0.193326, 0.236991, 0.267104, 0.285685 },
                                             { 0.098437, 0.125290, 0.144022, 0.155257 },
                                             { 0.024288, 0.034575, 0.042254, 0.046842 },
                                             { 0.002961, 0.004317, 0.005621, 0.006773 } },
                                           { { 0.354857, 0.390954, 0.411327, 0.422853 },
                                             { 0.255313, 0.295565, 0.317516, 0.329434 },
                                             { 0.106953, 0.151142, 0.172023, 0.183345 },
                                             { 0.018299, 0.035325, 0.054697, 0.063784 } } };
    static const struct { const char *method, *set; double (*truth)(double); double bound;
    } row[] = { { "hsao-best", "directions=8,steps=48,blur=0", linear_corner, 0.002 },
                { "hsao-best", "directions=8,steps=48,falloff=none,blur=0", hard_corner, 0.01 },
                { "ssao", "samples=64,thickness=solid,blur=0", linear_corner, 0.004 } };
    kit_gbuffer g[4];
    kit_run run;
    double worst = 0, scaled[2] = { 0 };
    float tile[16][4];
    for (int i = 0; i < 16; ++i) { tile[i][0] = 1; tile[i][1] = tile[i][2] = 0; tile[i][3] = (float)i / 16; }
    for (int i = 0; i < 4; ++i) if (!corner(&g[i], at[i])) return;
    for (int s = 0; s < 8; ++s) {
        char set[96];
        const int steps = 6 << s % 4, hard = s / 4;
        snprintf(set, sizeof set, "directions=32,normal_rays=0,blur=0,noise=texture,steps=%d,falloff=%s", steps,
                 hard ? "none" : "linear");
        if (!start(&run, &g[0], "hsao-march", set, 1)) return;
        glBindTexture(GL_TEXTURE_2D, run.noise);           /* steps not jittered, 16 * 32 directions */
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 16, 1, 0, GL_RGBA, GL_FLOAT, tile);
        for (int i = 0; i < 4; ++i) {
            const double exact = march[hard][i][s % 4], o = 1 - row_of(&run, &g[i], row_at(at[i]), 1),
                         low = (hard ? hard_corner : linear_corner)(at[i]) - o;
            worst = fmax(worst, fabs(o - exact));
            scaled[hard] = fmax(scaled[hard], low * steps);
            CHECK(fabs(o - exact) <= 0.004, "march, c %g, %d steps, hard %d: %g, the exact march has %g", at[i], steps,
                  hard, o, exact);
            CHECK(low <= (hard ? 1.7 : 2.5) / steps && low > -0.002, "march, c %g, %d steps, hard %d: %g below truth",
                  at[i], steps, hard, low);
        }
        kit_run_close(&run);
    }
    t_note("march: %.4f off the exact march, %.2f/steps off the truth, hard %.2f/steps", worst, scaled[0], scaled[1]);
    if (!start(&run, &g[0], "hsao-march",
               "directions=32,normal_rays=0,blur=0,noise=texture,steps=24,falloff=none,spheres=1", 1))
        return;
    glBindTexture(GL_TEXTURE_2D, run.noise);
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 16, 1, 0, GL_RGBA, GL_FLOAT, tile);
    for (int i = 0; i < 4; ++i) {
        const double exact = exact_march(at[i], 24, 1, 1), o = 1 - row_of(&run, &g[i], row_at(at[i]), 1),
                     plain = exact_march(at[i], 24, 1, 0);
        CHECK(fabs(plain - march[1][i][2]) < 5e-4, "c %g: the exact march here has %g, not %g", at[i], plain,
              march[1][i][2]);
        /* a face that is seen is nearer than the ray's end */
        CHECK(fabs(o - exact) <= 0.004 && fabs(exact - plain) < 1e-6,
              "spheres, c %g: %g, the exact march has %g, without spheres %g", at[i], o, exact, plain);
    }
    kit_run_close(&run);
    for (int m = 0; m < 3; ++m) {
        double bias = worst = 0;
        int n = 0;
        if (!start(&run, &g[0], row[m].method, row[m].set, 1)) return;
        for (int r = row_at(1) + 1; r <= row_at(0.1); r += 9, ++n) {
            const double c = at[1] + (row_at(at[1]) - r) / (double)SPAN, truth = row[m].truth(c),
                         o = 1 - row_of(&run, &g[1], r, 4) - truth;
            worst = fmax(worst, fabs(o));
            bias += o;
            CHECK(fabs(o) <= row[m].bound, "%s %s, c %.3f: %+.4f off %.4f", row[m].method, row[m].set, c, o, truth);
        }
        kit_run_close(&run);
        t_note("%s %s: worst %.4f, bias %+.4f over %d distances", row[m].method, row[m].set, worst, bias / n, n);
    }
    for (int i = 0; i < 4; ++i) kit_gbuffer_free(&g[i]);
}

/* ---- the march's terms, layers and cameras: closed forms -------------------------------------------------------- */

enum { PIT = 160, PIT_RADIUS = 60 };      /* pixels: of the picture, of the radius */
static const double pit_lid = 0.6, pit_wall = 0.3;    /* radii over the floor; the wall also from its centre */

/* The floor at depth 4, seen straight down through the one pixel that a lid of 0.05 radii leaves open; where it is
   wanted, a wall around it, solid downward. Up to three layers. */
static int pit(kit_gbuffer *g, int lid, int wall)
{
    kit_camera camera = looking_along_z(PIT, PIT, 1);
    kit_image frame;
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
    const int ok = TRY(kit_gbuffer_from_frame(g, &frame, &camera, &err));
    kit_image_free(&frame);
    return ok;
}

/* occlusion at the one pixel at a picture's centre, over phases */
static double at_centre(kit_run *run, int x, int y)
{
    enum { PHASES = 16 };
    double sum = 0;
    glEnable(GL_SCISSOR_TEST);
    glScissor(x, y, 1, 1);
    for (int k = 0; k < PHASES; ++k) {
        float visible = 0;
        run->frame.phase = (float)k / PHASES;
        kit_run_update(run);
        kit_run_draw(run, 0);
        glReadPixels(x, y, 1, 1, GL_RED, GL_FLOAT, &visible);
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
    } row[] = { /* under a lid: what is seen has no far side, and the horizon goes up to it; with its back it does not,
                   and normal rays meet it within the radius where z > 0.55. A sphere never reaches it */
                { "terms=horizon", 1, 0, 0.99, 1 },
                { "terms=horizon,spheres=1", 1, 0, 0, 0 },
                { "terms=horizon,layers=3", 1, 0, 0, 0 },
                { "terms=normal,layers=3", 1, 0, 0.68, 0.7 },
                { "terms=both,layers=3", 1, 0, 0.68, 0.7 },
                { "terms=rays,layers=3", 1, 0, 0.68, 0.7 },
                /* within a wall up to 45 degrees: half, of which normal rays find what the last step left */
                { "terms=horizon", 0, 1, 0.44, 0.5 },
                { "terms=both", 0, 1, 0.48, 0.51 },
                { "terms=rays", 0, 1, 0.48, 0.51 },
                { "terms=normal", 0, 1, 0, 0.06 },
                /* both: nothing is open, so the shares below and above the horizon are 1. It goes on to the lid */
                { "terms=horizon,layers=3", 1, 1, 0.5, 0.56 },
                { "terms=normal,layers=3", 1, 1, 0.44, 0.5 },
                { "terms=both,layers=3", 1, 1, 0.999, 1 },
                { "terms=rays,layers=3", 1, 1, 0.999, 1 },
                /* a wall seen from above: its top at x is within a step more than x where x > (0.09 - s^2) / 2s,
                   s = 1/12; found there or up to a step on, at 0.5 to 0.58 */
                { "terms=horizon,spheres=1,steps=12", 0, 1, 0.208, 0.266 } };
    enum { ROWS = (int)(sizeof row / sizeof row[0]) };
    double o[ROWS];
    for (int i = 0; i < ROWS; ++i) {
        kit_gbuffer g;
        kit_run run;
        char set[160];
        snprintf(set, sizeof set,
                 "directions=32,normal_rays=8,steps=48,falloff=none,blur=0,offset=0,thickness=solid,%s", row[i].set);
        if (!pit(&g, row[i].lid, row[i].wall) || !start(&run, &g, "hsao-march", set, 1)) return;
        o[i] = at_centre(&run, PIT / 2, PIT / 2 - 1);    /* the frame's first row is the top */
        CHECK(o[i] >= row[i].least - 1e-6 && o[i] <= row[i].most + 1e-6, "%s%s%s: %.4f, not in %g..%g", row[i].set,
              row[i].lid ? ", lid" : "", row[i].wall ? ", wall" : "", o[i], row[i].least, row[i].most);
        kit_run_close(&run);
        kit_gbuffer_free(&g);
    }
    CHECK(fabs(o[2] + o[3] - o[4]) < 1e-5 && fabs(o[6] + o[9] - o[7]) < 1e-5 && fabs(o[10] + o[11] - o[12]) < 1e-5,
          "the terms are not the sum's: %g + %g, %g; %g + %g, %g; %g + %g, %g", o[2], o[3], o[4], o[6], o[9], o[7],
          o[10], o[11], o[12]);
    t_note("lid %.4f, wall %.4f + %.4f, both %.4f + %.4f", o[4], o[6], o[9], o[10], o[11]);
}

/* Only an extra camera sees the wall: the picture ends before it. */
static void horizon_of_another_camera(void)
{
    enum { INNER = 16 };
    double o[2];
    for (int wall = 0; wall < 2; ++wall) {
        static float depth[PIT * PIT];
        kit_scene scene;
        kit_gbuffer g, wide, narrow;
        kit_camera camera = looking_along_z(INNER, INNER, 1);
        kit_image frame;
        kit_run run;
        kit_method method;
        ssgi_view view;
        float world[16], projection[16];
        const kit_world with = { &scene, NULL };
        camera.ortho_height = (float)INNER / PIT_RADIUS;
        if (!TRY(kit_scene_load(&scene, "plane", 0, &err)) || !pit(&wide, 0, wall)
            || !TRY(kit_gbuffer_from_scene(&g, &scene, &camera, NULL, &err))
            || !TRY(kit_image_new(&frame, INNER, INNER, "Z,N.X,N.Y,N.Z", &err)))
            return;
        for (int i = 0; i < INNER * INNER; ++i) {
            frame.data[i] = 4;
            frame.data[3 * INNER * INNER + i] = 1;
        }
        if (!TRY(kit_gbuffer_from_frame(&narrow, &frame, &camera, &err))
            || !TRY(kit_method_find(&method, "hsao-march", &err))
            || !TRY(kit_method_set(
                &method,
                "directions=32,normal_rays=0,steps=48,falloff=none,blur=0,offset=0,thickness=solid,views=1,"
                "view_size=160",
                &err))
            || !TRY(kit_run_open(&run, &narrow, &method, 1, &with, &err)) || !view_of(&view, &wide.camera, 0))
            return;
        kit_camera_matrices(&wide.camera, world, projection);
        CHECK(ssgi_gl_views_set(&run.cameras, 0, &view, world, world, NULL) == SSGI_OK, "no view");
        run.frame.radius = 1;
        for (int i = 0; i < PIT * PIT; ++i) {
            const double x = (double)(i % PIT - PIT / 2) / PIT_RADIUS, y = (double)(i / PIT - PIT / 2) / PIT_RADIUS,
                         z = wall && sqrt(x * x + y * y) > pit_wall ? 4 - pit_wall : 4;
            depth[i] = (float)((z - (double)run.cameras.decode[0][0]) / (double)run.cameras.decode[0][1]);
        }
        glBindTexture(GL_TEXTURE_2D_ARRAY, run.view_depth);
        glTexImage3D(GL_TEXTURE_2D_ARRAY, 0, GL_R32F, PIT, PIT, 1, 0, GL_RED, GL_FLOAT, depth);
        o[wall] = at_centre(&run, INNER / 2, INNER / 2);
        kit_run_close(&run);
        kit_gbuffer_free(&g); kit_gbuffer_free(&wide); kit_gbuffer_free(&narrow);
        kit_image_free(&frame);
        kit_scene_free(&scene);
    }
    CHECK(fabs(o[0]) < 1e-6 && o[1] > 0.44 && o[1] < 0.51, "the horizon of another camera's wall: %g, without %g", o[1],
          o[0]);
    t_note("wall %.4f, none %.4f", o[1], o[0]);
}

/* ---- slabs: plates over a floor, endless sideways, from 45 degrees above ----------------------------------------- */

/* The faces along a pixel's ray, told apart by their winding, are what the kit draws. */
static void back_faces_are_drawn(void)
{
    enum { W = 96, H = 54 };
    static const char *const scenes[] = { "plates", "grass" };          /* solids; sheets */
    for (int s = 0; s < 2; ++s) {
        kit_scene scene;
        kit_gbuffer g;
        kit_image frame, again;
        ssgi_trace trace;
        void *memory;
        int wrong = 0, found[3] = { 0 }, differ = 0;
        if (!TRY(kit_scene_load(&scene, scenes[s], 0, &err))) return;
        scene.camera.width = W;
        scene.camera.height = H;
        memory = malloc(ssgi_trace_size(scene.mesh.triangles));
        if (!CHECK(memory
                       && ssgi_trace_build(&trace, memory, ssgi_trace_size(scene.mesh.triangles), scene.mesh.position,
                                           12, NULL, scene.mesh.triangles, NULL)
                              == SSGI_OK,
                   "no trace")
            || !TRY(kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err))
            || !TRY(kit_gbuffer_slabs(&g, &scene, 2, &err)) || !TRY(kit_gbuffer_read(&frame, &g, &err)))
            return;
        const float *depth[4] = { kit_image_channel(&frame, "Z"), kit_image_channel(&frame, "back.Z"),
                                  kit_image_channel(&frame, "front2.Z"), kit_image_channel(&frame, "back2.Z") };
        float world[16], projection[16];
        ssgi_view view;
        if (!CHECK(depth[1] && depth[2] && depth[3], "channels are missing") || !view_of(&view, &g.camera, 0)) return;
        kit_camera_matrices(&g.camera, world, projection);
        for (int i = 0; i < W * H; ++i) {
            float p[3], d[3], t = 0;
            double z[4] = { 0 };
            int next = 1;
            ssgi_hit hit;
            ssgi_view_position(p, &view, (float)(i % W) + 0.5f, H - 0.5f - (float)(i / W), 1);
            for (int k = 0; k < 3; ++k) d[k] = world[4 * k] * p[0] + world[4 * k + 1] * p[1] + world[4 * k + 2] * p[2];
            while (next < 4 && ssgi_trace_closest(&hit, &trace, g.camera.eye, d, t, 1e6f)) {
                const float *c = scene.mesh.position + 9 * hit.triangle;
                double a[3], b[3], face = 0;
                for (int k = 0; k < 3; ++k) {
                    a[k] = (double)c[3 + k] - (double)c[k];
                    b[k] = (double)c[6 + k] - (double)c[k];
                }
                for (int k = 0; k < 3; ++k)
                    face += (double)d[k] * (a[(k + 1) % 3] * b[(k + 2) % 3] - a[(k + 2) % 3] * b[(k + 1) % 3]);
                if (!(z[0] > 0)) z[0] = (double)hit.t;
                if ((face > 0) == (next != 2)) z[next++] = (double)hit.t;
                t = hit.t * 1.000004f;
            }
            for (int k = 1; k < 4; ++k) found[k - 1] += z[k] > 0;
            for (int k = 0; k < 4; ++k)
                if (fabs((double)depth[k][i] - z[k]) > 1e-3 * z[0]) { ++wrong; break; }
        }
        CHECK(wrong < W * H / 50 && found[0] > 400 && found[1] > 200,
              "%s: %d pixels hold other faces than their rays meet; back faces, slabs: %d, %d, %d", scenes[s], wrong,
              found[0], found[1], found[2]);
        t_note("%s: %d of %d pixels hold other faces than their rays meet; %d with a back face, %d with a second "
               "slab",
               scenes[s], wrong, W * H, found[0], found[2]);
        kit_gbuffer_free(&g);
        if (!TRY(kit_gbuffer_from_frame(&g, &frame, &scene.camera, &err)) || !TRY(kit_gbuffer_read(&again, &g, &err)))
            return;
        for (int c = 0; c < frame.channels; ++c)
            if (strstr(frame.name[c], ".Z") && frame.name[c][0] != 'N')
                differ += memcmp(kit_image_channel(&again, frame.name[c]), kit_image_channel(&frame, frame.name[c]),
                                 W * H * sizeof(float))
                          != 0;
        CHECK(!differ && g.slabs && g.back, "%d channels of slabs are lost in a frame", differ);
        kit_gbuffer_free(&g);
        kit_image_free(&frame);
        kit_image_free(&again);
        kit_scene_free(&scene);
        free(memory);
    }
}

/* A wall that few taps see is as dark as it is to many. Few taps miss an expected share of the free directions: an
   occluder between two taps lies, on the mean, between their distances. */
static void taps_of_a_wall_are_joined(void)
{
    static const char *const behind[] = { "solid", "constant", "back", "slabs" };
    double plane[2][4], off[4];
    const double c = 0.25;
    const kit_camera camera = corner_planes(plane, c, 0);
    kit_image frame;
    kit_gbuffer g;
    if (!planes_seen(&frame, &camera, (const double(*)[4])plane, 2, ",back.Z,front2.Z,back2.Z")
        || !TRY(kit_gbuffer_from_frame(&g, &frame, &camera, &err)))
        return;
    for (int i = 0; i < 4; ++i) {
        kit_run run;
        char set[96];
        snprintf(set, sizeof set, "directions=2,steps=8,blur=0,thickness=%s", behind[i]);
        if (!start(&run, &g, "hsao-best", set, 1)) return;
        off[i] = 1 - row_of(&run, &g, row_at(c), 32) - linear_corner(c);
        CHECK(off[i] > 0.013 && off[i] < 0.023, "%s: %+.4f off %.4f", set, off[i], linear_corner(c));
        kit_run_close(&run);
    }
    t_note("8 steps: solid %+.4f, constant %+.4f, back %+.4f, slabs %+.4f off %.4f", off[0], off[1], off[2], off[3],
           linear_corner(c));
    kit_gbuffer_free(&g);
    kit_image_free(&frame);
}

/* ---- the same picture, whatever the camera, the layout and the units --------------------------------------------- */

enum { ROOM_W = 320, ROOM_H = 180 };

/* ---- what engines have: the same picture from a left-handed camera, drawn upside down, through an oblique near plane,
   from the first of several samples, from a slice, through a text that decodes by ours --------------------------- */

enum { ENGINE_W = 240, ENGINE_H = 136, ENGINE = ENGINE_W * ENGINE_H };

static const ssgi_gl_desc *gather_of(const kit_run *run)
{
    int i = 0;
    while (run->pass[i].desc.pass == SSGI_GL_PASS_THICKNESS) ++i;
    return &run->pass[i].desc;
}

/* The run, choices of the gather and of the passes before it changed, on another G-buffer. */
static int otherwise(kit_image *out, kit_run *run, kit_gbuffer *g, ssgi_gl_desc d, float radius, int slice)
{
    GLuint was[2];
    int ok = fit(run, g, radius, 0);
    run->frame.slice = slice;
    for (int i = 0; i < 2; ++i) {
        kit_pass *p = &run->pass[i];
        was[i] = p->program;
        d.pass = p->desc.pass;
        if (d.pass == SSGI_GL_PASS_BLUR) continue;
        p->program = kit_pass_program(&d, &err);
        ok = ok && TRY(!p->program);
    }
    ok = ok && draw(out, run);
    for (int i = 0; i < 2; ++i) {
        if (run->pass[i].program != was[i]) glDeleteProgram(run->pass[i].program);
        run->pass[i].program = was[i];
    }
    run->frame.slice = 0;
    return ok;
}

/* The pixels that differ by more than a bound, the second picture upside down. */
static int apart(const kit_image *a, const kit_image *b, float most, int turned)
{
    int n = 0;
    for (int i = 0; i < ENGINE; ++i) {
        const int k = turned ? (ENGINE_H - 1 - i / ENGINE_W) * ENGINE_W + i % ENGINE_W : i;
        n += !(fabsf(a->data[i] - b->data[k]) <= most);
    }
    return n;
}

/* Two textures of four samples, bound where the gather reads them: the first sample of each is what the G-buffer has,
   the others are nonsense. */
static int sampled(GLuint texture[2], const kit_gbuffer *g)
{
    static const char *const source[2] = {
        "#version 430\nvoid main() {\n"
        "    gl_Position = vec4(vec2(gl_VertexID % 2, gl_VertexID / 2) * 4.0 - 1.0, 0.0, 1.0);\n}\n",
        "#version 430\nlayout(binding = 0) uniform sampler2D depth;\nlayout(binding = 1) uniform sampler2D normal;\n"
        "out vec4 n;\nvoid main() {\n    ivec2 p = ivec2(gl_FragCoord.xy);\n"
        "    gl_FragDepth = gl_SampleID == 0 ? texelFetch(depth, p, 0).x : 0.3;\n"
        "    n = gl_SampleID == 0 ? texelFetch(normal, p, 0) : vec4(0.6, 0.8, 0.0, 0.0);\n}\n"
    };
    static const GLenum stages[2] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER },
                        formats[2] = { GL_DEPTH_COMPONENT32F, GL_RGBA32F },
                        places[2] = { GL_DEPTH_ATTACHMENT, GL_COLOR_ATTACHMENT0 };
    GLuint program = kit_program(source, stages, 2, &err), framebuffer;
    if (!TRY(!program)) return 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glGenTextures(2, texture);
    for (unsigned i = 0; i < 2; ++i) {
        glActiveTexture(GL_TEXTURE0 + i);
        glBindTexture(GL_TEXTURE_2D, i ? g->normal : g->depth);
        glBindTexture(GL_TEXTURE_2D_MULTISAMPLE, texture[i]);
        glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, 4, formats[i], ENGINE_W, ENGINE_H, GL_TRUE);
        glFramebufferTexture2D(GL_FRAMEBUFFER, places[i], GL_TEXTURE_2D_MULTISAMPLE, texture[i], 0);
    }
    glViewport(0, 0, ENGINE_W, ENGINE_H);
    glUseProgram(program);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_ALWAYS);
    const int ok = CHECK(glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE, "no samples");
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteProgram(program);
    return ok;
}

/* The projection with a near plane of its own, in view space, the scene beyond it [Lengyel 2005]. */
static void oblique_plane(float m[16], const double plane[4])
{
    const double q[4] = { (copysign(1, plane[0]) + (double)m[8]) / (double)m[0],
                          (copysign(1, plane[1]) + (double)m[9]) / (double)m[5], -1,
                          (1 + (double)m[10]) / (double)m[14] };
    double at = 0;
    for (int k = 0; k < 4; ++k) at += plane[k] * q[k];
    for (int k = 0; k < 4; ++k) m[4 * k + 2] = (float)(2 / at * plane[k] + (k == 2 ? 1 : 0));
}

static void what_engines_have(void)
{
    static const float none[4] = { 0, 0, 0, 0 };
    static float z[2 * ENGINE], n[8 * ENGINE], m[ENGINE], flat_[4 * ENGINE];
    kit_scene scene;
    kit_gbuffer g, other;
    kit_run run = { 0 };
    kit_image want, got, frame;
    GLuint texture[2];
    ssgi_gl_desc d;
    ssgi_view view;
    int beyond = 0;
    if (!load(&scene, ENGINE_W, ENGINE_H)) return;
    scene.camera.depth = KIT_DEPTH_NORMAL;
    if (!TRY(kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err)) || !TRY(kit_gbuffer_read(&frame, &g, &err))
        || !start(&run, &g, "hsao-best", "steps=4,directions=2,blur=0,noise=texture", scene.radius))
        return;
    glBindTexture(GL_TEXTURE_2D, run.noise);               /* upside down noise would be other noise */
    glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, none);
    if (!picture(&want, &run, &g, NULL, NULL, scene.radius, 0, 0) || !view_of(&view, &g.camera, 0)
        || !TRY(kit_texture_read(g.depth, ENGINE_W, ENGINE_H, 1, z))
        || !TRY(kit_texture_read(g.normal, ENGINE_W, ENGINE_H, 4, n)))
        return;

    other = g;                                             /* the camera along +z, normals as it has them */
    for (int k = 8; k < 12; ++k) other.projection[k] = -g.projection[k];
    for (int i = 0; i < 4 * ENGINE; ++i) flat_[i] = i % 4 == 2 ? -n[i] : n[i];
    other.normal = kit_texture(ENGINE_W, ENGINE_H, GL_RGBA32F, flat_);
    d = *gather_of(&run);
    d.input.left_handed = 1;
    if (!otherwise(&got, &run, &other, d, scene.radius, 0)) return;
    CHECK(!apart(&want, &got, 0, 0), "left-handed: %d pixels differ", apart(&want, &got, 0, 0));
    kit_image_free(&got);
    glDeleteTextures(1, &other.normal);

    kit_image right;                                       /* the kit's setting of that name does the same */
    if (!TRY(kit_run_picture(&right, &g, NULL, "hsao", "left_handed=0", scene.radius, &err))
        || !TRY(kit_run_picture(&got, &g, NULL, "hsao", "left_handed=1", scene.radius, &err))) return;
    CHECK(!apart(&right, &got, 0, 0), "left_handed=1: %d pixels differ", apart(&right, &got, 0, 0));
    kit_image_free(&right);
    kit_image_free(&got);

    if (sampled(texture, &g)) {
        d = *gather_of(&run);
        d.input.multisampled = 1;
        if (!otherwise(&got, &run, &g, d, scene.radius, 0)) return;
        CHECK(!apart(&want, &got, 0, 0), "multisampled: %d pixels differ", apart(&want, &got, 0, 0));
        kit_image_free(&got);
        glDeleteTextures(2, texture);
    }

    for (int i = 0; i < ENGINE; ++i) z[ENGINE + i] = z[i]; /* slice 0 shows nothing */
    for (int i = 0; i < 4 * ENGINE; ++i) n[4 * ENGINE + i] = n[i];
    for (int i = 0; i < ENGINE; ++i) z[i] = 0.5f;
    for (unsigned i = 0; i < 2; ++i) {
        texture[i] = kit_texture_array(ENGINE_W, ENGINE_H, 2, i ? GL_RGBA32F : GL_DEPTH_COMPONENT32F, i ? n : z);
        glActiveTexture(GL_TEXTURE0 + i);
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture[i]);
    }
    d = *gather_of(&run);
    d.input.array = 1;
    if (!otherwise(&got, &run, &g, d, scene.radius, 1)) return;
    CHECK(!apart(&want, &got, 0, 0), "a slice: %d pixels differ", apart(&want, &got, 0, 0));
    kit_image_free(&got);
    glDeleteTextures(2, texture);

    d = *gather_of(&run);
    d.input.depth = SSGI_GL_DEPTH_CUSTOM;                        /* its sampler is at unit 0, where depth is */
    d.text.fetch = "uniform sampler2D my_depth;\nfloat ssgi_custom_depth(ivec2 texel, int layer) {\n"
              "    return ssgi_decode(texelFetch(my_depth, texel, layer).x);\n}";
    if (!otherwise(&got, &run, &g, d, scene.radius, 0)) return;
    CHECK(!apart(&want, &got, 0, 0), "decoded by a text of one's own: %d pixels differ", apart(&want, &got, 0, 0));
    kit_image_free(&got);

    other = g;
    oblique_plane(other.projection, (const double[4]) { 0.1, -0.2, -1, -0.05 });
    for (int i = 0; i < ENGINE; ++i) {
        const double depth = (double)frame.data[(ENGINE_H - 1 - i / ENGINE_W) * ENGINE_W + i % ENGINE_W],
                     x = (i % ENGINE_W + 0.5) * (double)view.unproject[0] + (double)view.unproject[2],
                     y = (i / ENGINE_W + 0.5) * (double)view.unproject[1] + (double)view.unproject[3];
        const float *p = other.projection;
        const double window = 0.5 + 0.5 * ((double)p[2] * x + (double)p[6] * y - (double)p[10] + (double)p[14] / depth);
        m[i] = depth > 0 ? (float)window : 1;
        beyond += depth > 0 && !(window > 0 && window < 1);
    }
    CHECK(!beyond, "%d pixels are outside of the oblique frustum", beyond);
    other.depth = kit_texture(ENGINE_W, ENGINE_H, GL_DEPTH_COMPONENT32F, m);
    d = *gather_of(&run);
    d.input.oblique = 1;
    if (!otherwise(&got, &run, &other, d, scene.radius, 0)) return;
    t_note("oblique: RMSE %.1e, %d pixels by more than 1/255", difference(&want, &got, 0, 0, 0),
           apart(&want, &got, 1 / 255.0f, 0));
    CHECK(difference(&want, &got, 0, 0, 0) <= 5e-4, "an oblique near plane: RMSE %.5f",
          difference(&want, &got, 0, 0, 0));
    kit_image_free(&got);
    glDeleteTextures(1, &other.depth);

    other = g;                                             /* drawn upside down */
    other.projection[5] = -g.projection[5];
    other.projection[9] = -g.projection[9];
    for (int i = 0; i < ENGINE; ++i) {
        const int k = (ENGINE_H - 1 - i / ENGINE_W) * ENGINE_W + i % ENGINE_W;
        m[i] = z[ENGINE + k];
        memcpy(flat_ + 4 * i, n + 4 * k, 4 * sizeof *n);
    }
    other.depth = kit_texture(ENGINE_W, ENGINE_H, GL_DEPTH_COMPONENT32F, m);
    other.normal = kit_texture(ENGINE_W, ENGINE_H, GL_RGBA32F, flat_);
    for (int k = 0; k < 2; ++k) {
        kit_image straight;
        d = *gather_of(&run);
        d.gather.thickness = SSGI_GL_THICKNESS_CONSTANT; /* widths begin at a 2x2's lower left, which is another */
        if (k) d.input.normal = SSGI_GL_NORMAL_FROM_DEPTH;
        if (!otherwise(&straight, &run, &g, d, scene.radius, 0) || !otherwise(&got, &run, &other, d, scene.radius, 0))
            return;
        t_note("upside down%s: %d pixels differ, by more than 1/255 %d", k ? ", normals from depth" : "",
               apart(&straight, &got, 0, 1), apart(&straight, &got, 1 / 255.0f, 1));
        CHECK(apart(&straight, &got, 1 / 255.0f, 1) < 4, "upside down%s: %d pixels differ by more than 1/255",
              k ? ", normals from depth" : "", apart(&straight, &got, 1 / 255.0f, 1));
        kit_image_free(&straight);
        kit_image_free(&got);
    }
    glDeleteTextures(1, &other.depth);
    glDeleteTextures(1, &other.normal);
    glActiveTexture(GL_TEXTURE0);
    kit_image_free(&want);
    kit_image_free(&frame);
    kit_run_close(&run);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

/* One orthographic depth buffer, whose eye is said to stand elsewhere: far away, at the near plane, beyond that. */
static void orthographic_eyes(void)
{
    static const double eyes[] = { 100000, 0, -2, -4 };
    static const char fetch[] = "uniform sampler2D my_depth;\nfloat ssgi_custom_depth(ivec2 texel, int layer) {\n"
                                "    return %s(texelFetch(my_depth, texel, layer).x);\n}";
    static const struct { const char *name, *decodes; int depth; } ways[] = {
        { "window depth", NULL, SSGI_GL_DEPTH_WINDOW }, { "view depth", NULL, SSGI_GL_DEPTH_LINEAR },
        { "window depth that is decoded", "ssgi_decode", SSGI_GL_DEPTH_CUSTOM },
        { "view depth of one's own", "", SSGI_GL_DEPTH_CUSTOM } };
    static float z[ENGINE], window[ENGINE];
    kit_scene scene;
    kit_gbuffer g;
    kit_run run = { 0 };
    kit_image want, got, frame;
    double worst = 0;
    if (!TRY(kit_scene_load(&scene, "boxes", 0, &err))) return;
    scene.camera.width = ENGINE_W;
    scene.camera.height = ENGINE_H;
    scene.camera.znear = scene.camera.zfar = 0;
    scene.camera.fovy = 0;
    scene.camera.ortho_height = 3.6f;
    if (!TRY(kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err)) || !TRY(kit_gbuffer_read(&frame, &g, &err))
        || !TRY(kit_texture_read(g.depth, ENGINE_W, ENGINE_H, 1, window))
        || !start(&run, &g, "hsao-best", "steps=4,directions=2,blur=0,noise=texture", scene.radius)
        || !picture(&want, &run, &g, NULL, NULL, scene.radius, 0, 0))
        return;
    for (int e = 0; e < (int)(sizeof eyes / sizeof *eyes); ++e)
        for (int w = 0; w < (int)(sizeof ways / sizeof *ways); ++w) {
            char text[sizeof fetch + 16];
            float view[16];
            kit_gbuffer other = g;
            ssgi_gl_desc d = *gather_of(&run);
            const double near = (double)g.camera.znear;
            other.camera.znear = (float)eyes[e];
            other.camera.zfar = (float)(eyes[e] + (double)g.camera.zfar - near);
            kit_camera_matrices(&other.camera, view, other.projection);
            for (int i = 0; i < ENGINE; ++i) {             /* frames begin with the top row, textures with the last */
                const float deep = frame.data[(ENGINE_H - 1 - i / ENGINE_W) * ENGINE_W + i % ENGINE_W];
                z[i] = deep > 0 ? (float)((double)deep - near + eyes[e]) : 1e18f;
            }
            d.input.depth = ways[w].depth;
            if (ways[w].decodes) {
                snprintf(text, sizeof text, fetch, ways[w].decodes);
                d.text.fetch = text;
            }
            other.depth = w & 1 ? kit_texture(ENGINE_W, ENGINE_H, GL_R32F, z)
                                : kit_texture(ENGINE_W, ENGINE_H, GL_DEPTH_COMPONENT32F, window);
            const int drawn = otherwise(&got, &run, &other, d, scene.radius, 0);
            glDeleteTextures(1, &other.depth);
            if (!drawn) return;
            const double off = difference(&want, &got, 0, 0, 0);
            worst = fmax(worst, off);
            CHECK(off < 0.006, "%s, near plane at %g: RMSE %.4f", ways[w].name, eyes[e], off);
            kit_image_free(&got);
        }
    t_note("RMSE %.4f at most", worst);
    kit_image_free(&want);
    kit_image_free(&frame);
    kit_run_close(&run);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

/* ---- sizes, radii, garbage --------------------------------------------------------------------------------------- */

/* How many pixels of any pass that writes visibility are not in [0,1], or not 1 where nothing holds no depth. A GPU's
   quotient of equal sums may be 1 and its rounding. */
static int wrong(const kit_run *run, const float *nothing)
{
    int n = 0;
    for (int i = 0; i < run->passes; ++i) {
        const kit_pass *p = &run->pass[i];
        float v[160 * 90];
        if (p->desc.pass == SSGI_GL_PASS_THICKNESS) continue;
        if (p->width * p->height > 160 * 90 || kit_texture_read(p->target[0], p->width, p->height, 1, v)) return -1;
        for (int k = 0; k < p->width * p->height; ++k)
            n += !(v[k] >= 0 && v[k] <= 1 + 2.4e-7f)
              || (nothing && (p->desc.pass == SSGI_GL_PASS_BLUR || !p->desc.gather.half) && !(nothing[k] > 0)
                  && v[k] < 1);
    }
    return n;
}

/* Raw textures, as they are. */
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

static void sizes_do_not_matter(void)
{
    static const int widths[] = { 1, 2, 3, 5, 17, 64 }, heights[] = { 1, 2, 3, 7, 33 };
    float depth[64 * 33] = { 0 }, normal[4 * 64 * 33] = { 0 };
    kit_gbuffer g;
    kit_run run;
    for (int m = 0; m < METHODS; ++m) {
        kit_camera c = looking_along_z(64, 33, m & 1);
        g = raw(&c, 1, GL_R32F, depth, normal);
        if (!start(&run, &g, methods[m].method, methods[m].set, 0.5f)) return;
        kit_gbuffer_free(&g);
        for (int i = 0; i < 30; ++i) {                     /* one program a method, turned to targets of every size */
            c.width = widths[i % 6];
            c.height = heights[i / 6];
            t_seed((uint32_t)i);
            for (int k = 0; k < c.width * c.height; ++k) depth[k] = t_below(4) ? 1 + 0.01f * (float)t_below(100) : 0;
            for (int k = 0; k < 4 * c.width * c.height; ++k) normal[k] = 0.01f * (float)t_below(200) - 1;
            g = raw(&c, 1, GL_R32F, depth, normal);
            if (!fit(&run, &g, 0.5f, 0)) return;
            kit_run_update(&run);
            kit_run_draw(&run, 0);
            CHECK(!wrong(&run, depth), "%s %s: %d pixels of %d x %d are wrong", methods[m].method, methods[m].set,
                  wrong(&run, depth), c.width, c.height);
            kit_gbuffer_free(&g);
        }
        kit_run_close(&run);
    }
}

static void radii_do_not_matter(void)
{
    kit_scene scene;
    kit_gbuffer g;
    kit_run run;
    kit_image out;
    if (!load(&scene, 160, 90) || !TRY(kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err))) return;
    for (int m = 0; m < METHODS; ++m) {
        /* Points lifted by most of a pixel stand behind a silhouette beside them, and what is solid blocks them at any
           radius: a limit of ssao and of normal rays. All else sees nothing. */
        const int allowed = strstr(methods[m].set, "thickness=solid") ? 160 * 90 / 10 : 0;
        int dark = 0;
        if (!start(&run, &g, methods[m].method, methods[m].set, 1e-6f) || !draw(&out, &run)) return;
        for (int i = 0; i < out.width * out.height; ++i) dark += !(out.data[i] >= 1 - 1e-6f);
        CHECK(dark <= allowed, "%s %s, tiny radius: %d pixels are not 1", methods[m].method, methods[m].set, dark);
        kit_image_free(&out);
        run.frame.radius = run.frame.thickness_limit = 1e6f;
        kit_run_update(&run);
        kit_run_draw(&run, 0);
        CHECK(!wrong(&run, NULL), "%s %s, huge radius: %d pixels are wrong", methods[m].method, methods[m].set,
              wrong(&run, NULL));
        kit_run_close(&run);
    }
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

static void garbage_is_survived(void)
{
    static const float odd[] = { NAN,    INFINITY, -INFINITY, 0,     -0.0f, -1,     1e-45f, 1e-39f,
                                 1e-30f, 1e-12f,   1e-6f,     0.25f, 0.5f,  0.999f, 1,      2,
                                 1e6f,   1e12f,    9e17f,     1e18f, 1e30f, 1e38f,  -1e38f };
    enum { ODD = (int)(sizeof odd / sizeof odd[0]), W = 24, H = 13, SEEDS = 12 };
    /* of one program: side by side */
    static const struct { const char *name; int linear, orthographic, layout; GLenum format;
    } kind[] = { { "view depth", 1, 0, KIT_DEPTH_NORMAL, GL_R32F },
                 { "view depth, orthographic", 1, 1, KIT_DEPTH_NORMAL, GL_R32F },
                 { "orthographic", 0, 1, KIT_DEPTH_REVERSED, GL_R32F },
                 { "window depth", 0, 0, KIT_DEPTH_NORMAL, GL_R32F },
                 { "reversed", 0, 0, KIT_DEPTH_REVERSED, GL_R32F },
                 { "infinite", 0, 0, KIT_DEPTH_INFINITE, GL_R32F },
                 { "hardware depth", 0, 0, KIT_DEPTH_NORMAL, GL_DEPTH_COMPONENT32F } };
    float depth[SEEDS][W * H], normal[4 * W * H];
    kit_gbuffer g[SEEDS];
    kit_run runs[METHODS];
    for (int k = 0; k < 7; ++k) {
        kit_camera c = looking_along_z(W, H, kind[k].orthographic);
        c.depth = kind[k].layout;
        for (int s = 0; s < SEEDS; ++s) {                  /* more and more of it among sound texels */
            t_seed((uint32_t)s);
            for (int i = 0; i < W * H; ++i)
                depth[s][i] = (int)t_below(SEEDS) <= s ? odd[t_below(ODD)] : 0.5f + 0.004f * (float)t_below(100);
            for (int i = 0; i < 4 * W * H; ++i)
                normal[i] = (int)t_below(SEEDS) <= s ? odd[t_below(ODD)] : 0.01f * (float)t_below(200) - 1;
            g[s] = raw(&c, kind[k].linear, kind[k].format, depth[s], normal);
            if (!kind[k].linear)                           /* from here on only: where is something */
                for (int i = 0; i < W * H; ++i)
                    depth[s][i] = depth[s][i] == (kind[k].layout == KIT_DEPTH_NORMAL ? 1.0f : 0.0f) ? 0.0f : 1.0f;
        }
        for (int m = 0; m < METHODS; ++m) {
            int n = 0;
            kit_run *run = &runs[m];
            if (k < 4 && !start(run, &g[0], methods[m].method, methods[m].set, 0.5f)) return;
            for (int s = 0; s < SEEDS; ++s) {
                if (!fit(run, &g[s], s % 3 ? 0.5f : 1e5f, 0)) return;
                kit_run_update(run);
                kit_run_draw(run, 0);
                n += wrong(run, depth[s]);
            }
            CHECK(!n, "%s, %s %s: %d pixels are NaN, beyond [0,1] or dark where nothing is", kind[k].name,
                  methods[m].method, methods[m].set, n);
            if (k < 3 || k == 6) kit_run_close(run);
        }
        for (int s = 0; s < SEEDS; ++s) kit_gbuffer_free(&g[s]);
    }
}

/* ---- truth, and what it costs ------------------------------------------------------------------------------------ */

static void near_the_truth(void)
{
    static const struct {
        const char *name;
        double share, bias;
    } row[] = { { "hsao", 0.47, 0.02 },
                { "hsao-fast", 0.55, 0.04 },
                { "hsao-best", 0.41, 0.02 },
                { "ssao", 0.6, 0.04 },
                { "hsao-march", 0.52, 0.02 } };
    kit_scene scene;
    kit_gbuffer g;
    kit_image truth, out;
    kit_score none, score;
    double share[5] = { 0 };
    if (!load(&scene, ROOM_W, ROOM_H)
        || !TRY(kit_truth_ao(&truth, &scene, &scene.camera, scene.radius, KIT_ATTENUATION_LINEAR, 32, 1, &err))
        || !TRY(kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err))
        || !TRY(kit_image_new(&out, ROOM_W, ROOM_H, "Y", &err)))
        return;
    for (int i = 0; i < ROOM_W * ROOM_H; ++i) out.data[i] = 1;
    kit_score_channel(&none, &out, &truth, "Y", NULL, &err);
    for (int m = 0; m < 5; ++m) {
        kit_image_free(&out);
        kit_run run = { 0 };
        if (!picture(&out, &run, &g, row[m].name, "", scene.radius, 0, 0)
            || !TRY(kit_score_channel(&score, &out, &truth, "Y", NULL, &err)))
            return;
        kit_run_close(&run);
        share[m] = score.rmse / none.rmse;
        t_note("%s: RMSE %.4f, %.3f of no AO's, bias %+.4f", row[m].name, score.rmse, share[m], score.bias);
        CHECK(share[m] <= row[m].share && fabs(score.bias) <= row[m].bias, "%s: %.3f of no AO's RMSE, bias %+.4f",
              row[m].name, share[m], score.bias);
    }
    CHECK(share[2] < share[0] && share[0] < share[1], "best, balanced, fast are not in this order");
    kit_image_free(&out);
    kit_image_free(&truth);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

/* A post 12 pixels wide and a pole of one before a wall: how thick each is taken to be, by its own width, though it be
   turned from the viewer, by back faces, and as a sheet, whose back face is what is seen; and that view depths come
   along. */
static void widths_are_measured(void)
{
    enum { W = 96, H = 64, POST = 20, ACROSS = 12, POLE = 45 };
    static const struct { int orthographic; double slant; /* footprints a pixel */ const char *set; } rows[] = {
        { 1, 0, "thickness=width" }, { 1, 0, "thickness=back" }, { 1, 3, "thickness=width" },
        { 0, 1.5, "thickness=width" } };
    static float depth[W * H], back[W * H], normal[4 * W * H];
    static uint32_t got[W * H];
    for (size_t r = 0; r < sizeof rows / sizeof *rows; ++r) {
        const int orthographic = rows[r].orthographic, m = !strcmp(rows[r].set, "thickness=back");
        const kit_camera c = looking_along_z(W, H, orthographic);
        const double wide = orthographic ? 2.0 / H : 2 * tan(acos(-1) / 8) / H,      /* a pixel, at depth 1 */
                     close = orthographic ? wide : 5 * wide, radius = 32 * close;
        kit_run run;
        int bad[4] = { 0 };
        for (int i = 0; i < W * H; ++i) {
            const int x = i % W, y = i / W, post = x >= POST && x < POST + ACROSS;
            const double off = rows[r].slant * close * (x - POST);
            depth[i] = (float)(x == POLE ? 4 : !post ? 10 : orthographic ? 5 + off : 1 / (0.2 - off / 25));
            back[i] = x == POLE ? 4 : !post ? 0 : y < H / 2 ? 5.5f : 5; /* the post: a solid below, a sheet above */
            normal[4 * i + 2] = 1;
        }
        kit_gbuffer g = raw(&c, 1, GL_R32F, depth, normal);
        g.back = kit_texture(W, H, GL_R32F, back);
        if (!start(&run, &g, "hsao", rows[r].set, (float)radius)) return;
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
                             thick = code / 63.0 * most;                            /* pixels */
                const int post = x >= POST && x < POST + ACROSS;
                bad[0] += orthographic ? z != is : fabsf(z - is) > 1e-5f * is;
                if (post && m && y < H / 2) bad[1] += fabs(thick - 16) > 0.3;        /* 0.5 units */
                else if (post) bad[1] += !(thick >= (m ? 0.25 : 0.5) * ACROSS - 0.3 && thick <= (m ? 0.5 : 1) * ACROSS);
                else if (x == POLE) bad[2] += fabs(thick / most - (m ? 0.05 : 0.1)) > 0.01; /* not its 2x2's surface */
                else bad[3] += thick < 0.99 * most && x != POLE - 1;                 /* the wall has no end */
            }
        CHECK(!bad[0] && !bad[1] && !bad[2] && !bad[3], "row %zu: wrong are %d depths, %d pixels of the post, %d of "
              "the pole, %d of the wall", r, bad[0], bad[1], bad[2], bad[3]);
        kit_run_close(&run);
        kit_gbuffer_free(&g);
    }
}

/* A ball whose winding is the wrong way round looks like a sheet to who reads back faces: that costs little. */
static void wrong_winding(void)
{
    enum { W = 160, H = 90 };
    static const char *const sets[3] = { "thickness=width", "thickness=back", "thickness=slabs" };
    kit_scene scene;
    kit_gbuffer g;
    kit_image truth, out;
    kit_score score[3];
    if (!TRY(kit_scene_load(&scene, "sphere", 0, &err))) return;
    scene.camera.width = W;
    scene.camera.height = H;
    if (!TRY(kit_truth_ao(&truth, &scene, &scene.camera, 0.7f, KIT_ATTENUATION_LINEAR, 128, 1, &err))) return;
    for (size_t t = 0; t < scene.mesh.triangles; ++t)
        for (int k = 0; k < 3; ++k) {
            float *const p = scene.mesh.position + 9 * t, *const n = scene.mesh.normal + 9 * t;
            const float was[2] = { p[3 + k], n[3 + k] };
            p[3 + k] = p[6 + k], p[6 + k] = was[0];
            n[3 + k] = n[6 + k], n[6 + k] = was[1];
        }
    if (!TRY(kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err))) return;
    const kit_world world = { &scene, NULL };
    for (int m = 0; m < 3; ++m) {
        char set[64];
        snprintf(set, sizeof set, "directions=4,steps=16,%s", sets[m]);
        if (!TRY(kit_run_picture(&out, &g, &world, "hsao-best", set, 0.7f, &err))
            || !TRY(kit_score_channel(&score[m], &out, &truth, "Y", NULL, &err)))
            return;
        kit_image_free(&out);
        CHECK(score[m].rmse < 1.3 * score[0].rmse, "%s: RMSE %.4f, by widths %.4f", sets[m], score[m].rmse,
              score[0].rmse);
    }
    t_note("RMSE by widths %.4f, back faces %.4f, slabs %.4f", score[0].rmse, score[1].rmse, score[2].rmse);
    kit_image_free(&truth);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

/* Thin plates that hover over the ground, in perspective, to the left, to the right and across: with their back faces
   many slices come near the truth, and without they do not. */
static void plates_in_perspective(void)
{
    enum { W = 192, H = 108 };
    static const box thin[3] = { { { -1.4f, 0.35f, -0.5f }, { -0.6f, 0.37f, 0.6f } },
                                   { { 0.6f, 0.35f, -0.5f }, { 1.4f, 0.37f, 0.6f } },
                                   { { -0.5f, 0.2f, -1.3f }, { 0.5f, 0.22f, -0.9f } } };
    static const struct { const char *set; double share; } row[] = { { "thickness=back", 0.045 },
                                                                     { "thickness=slabs", 0.045 } };
    const kit_camera camera = { { 0, 1.6f, 2.2f }, { 0, 0.2f, 0 }, { 0, 1, 0 }, 42, 0, 0.1f, 20, W, H, { 0 },
                                KIT_DEPTH_NORMAL };
    kit_scene scene;
    kit_gbuffer g;
    kit_image truth, out;
    kit_score none, score;
    if (!see(&scene, &g, "plane", thin, 3, &camera, W, H)
        || !TRY(kit_truth_ao(&truth, &scene, &camera, 0.7f, KIT_ATTENUATION_LINEAR, 192, 1, &err))
        || !TRY(kit_image_new(&out, W, H, "Y", &err)))
        return;
    const kit_world world = { &scene, NULL };
    for (int i = 0; i < W * H; ++i) out.data[i] = 1;
    kit_score_channel(&none, &out, &truth, "Y", NULL, &err);
    kit_image_free(&out);
    for (int m = 0; m < 2; ++m) {
        kit_method method;
        kit_run run;
        if (!TRY(kit_method_find(&method, "hsao-best", &err))
            || !TRY(kit_method_set(&method, "directions=16,steps=48,blur=0", &err))
            || !TRY(kit_method_set(&method, row[m].set, &err))
            || !TRY(kit_run_open(&run, &g, &method, 0.7f, &world, &err)))
            return;
        kit_run_draw(&run, 0);
        if (!TRY(kit_run_read(&out, &run, &err)) || !TRY(kit_score_channel(&score, &out, &truth, "Y", NULL, &err)))
            return;
        CHECK(score.rmse <= row[m].share * none.rmse, "%s: %.3f of no AO's RMSE, bias %+.4f", row[m].set,
              score.rmse / none.rmse, score.bias);
        t_note("%s: %.3f of no AO's RMSE, bias %+.4f", row[m].set, score.rmse / none.rmse, score.bias);
        kit_run_close(&run);
        kit_image_free(&out);
    }
    kit_image_free(&truth);
    kit_gbuffer_free(&g);
    kit_scene_free(&scene);
}

#define COUNTING "layout(std430, binding = 3) buffer counts { uint count[]; };\n" \
                 "void tick() { atomicAdd(count[uint(gl_FragCoord.y) * 64u + uint(gl_FragCoord.x)], 1u); }\n"

static void fetches_are_counted(void)
{
    enum { W = 64, H = 48, INSIDE = 16 };
    static const char *const fetch[2] = {
        COUNTING "vec3 ssgi_custom_normal(ivec2 p) { tick(); return vec3(0.0, 0.0, 1.0); }\nfloat "
                 "ssgi_custom_depth(ivec2 p, int layer) { tick(); return 2.0; }\n",
        COUNTING
        "vec3 ssgi_custom_normal(ivec2 p) { tick(); return vec3(0.3, 0.0, 1.0); }\n"
        "float ssgi_custom_depth(ivec2 p, int layer) { tick(); return ((p.x / 5 + p.y / 4) & 1) == 0 ? 2.0 : 1.8; }\n"
    };
    static const struct {
        int pass, search, rays, behind, normal;
    } row[] = { { SSGI_GL_PASS_SSAO, 0, 0, 0, SSGI_GL_NORMAL_CUSTOM },
                { SSGI_GL_PASS_HSAO, SSGI_GL_SEARCH_SLICES, 0, 1, SSGI_GL_NORMAL_CUSTOM },
                { SSGI_GL_PASS_HSAO, SSGI_GL_SEARCH_SLICES, 0, 0, SSGI_GL_NORMAL_FROM_DEPTH },
                { SSGI_GL_PASS_HSAO, SSGI_GL_SEARCH_MARCH, 0, 1, SSGI_GL_NORMAL_CUSTOM },
                { SSGI_GL_PASS_HSAO, SSGI_GL_SEARCH_MARCH, 2, 1, SSGI_GL_NORMAL_CUSTOM } };
    const kit_camera c = looking_along_z(W, H, 0);
    uint32_t count[W * H];
    ssgi_view view;
    ssgi_gl_frame frame;
    GLuint buffer[2], framebuffer, texture;
    GLint blocks = 0;
    glGetIntegerv(GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, &blocks);
    if (blocks < 1) { t_note("not counted: %s has no storage blocks in fragment shaders", kit_gl_name()); return; }
    if (!view_of(&view, &c, 0) || ssgi_gl_frame_init(&frame, &view, 0.3f, NULL) != SSGI_OK) return;
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
        ssgi_gl_desc d = { 0 };
        d.text.dialect = SSGI_GL_DIALECT_450;
        d.input.depth = SSGI_GL_DEPTH_CUSTOM;
        d.text.fetch = fetch[i & 1];
        d.pass = row[i / 2].pass;
        d.gather.search = row[i / 2].search;
        d.gather.normal_rays = row[i / 2].rays;
        d.gather.thickness = row[i / 2].behind;
        d.input.normal = row[i / 2].normal;
        d.gather.directions = 3;
        const GLuint program = kit_pass_program(&d, &err);
        const uint32_t told = (uint32_t)kit_fetches(&d);
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
        CHECK(most <= told && most > 0, "%s: up to %u fetches a pixel, %u foretold", ssgi_gl_pass_name(d.pass), most,
              told);
        CHECK((i & 1) || least == told, "%s: %u fetches on a plane, %u foretold", ssgi_gl_pass_name(d.pass), least,
              told);
        glDeleteProgram(program);
    }
    glDeleteBuffers(2, buffer);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(1, &texture);
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

/* The largest difference of expected to what the filter makes of value (x, y: full-size pixel from below), border
   pixels left out, on a plane or on two, the second from column 30 on. run: opened with this set already, or all 0. */
static double filtered(kit_run *run, const kit_camera *c, const double (*plane)[4], int planes, const char *set,
                       float (*value)(int x, int y), float (*expected)(int x, int y), int border)
{
    kit_gbuffer g;
    kit_image frame, right, out;
    double worst = 0;
    if (!walls(&g, &frame, c, plane, 1)) return 1;
    if (planes > 1) {
        kit_gbuffer_free(&g);
        if (!walls(&g, &right, c, plane + 1, 1)) return 1;
        for (int i = 0; i < frame.width * frame.height; ++i) if (i % frame.width >= 30) frame.data[i] = right.data[i];
        kit_gbuffer_free(&g);
        kit_image_free(&right);
        if (!TRY(kit_gbuffer_from_frame(&g, &frame, c, &err))) return 1;
    }
    if ((!run->passes && !start(run, &g, "ssao", set, 0.5f)) || !fit(run, &g, 0.5f, 0)) return 1;
    kit_pass *p = &run->pass[0];
    const int step = p->desc.gather.half ? 2 : 1;
    glBindTexture(GL_TEXTURE_2D, p->target[0]);
    for (int y = 0; y < p->height; ++y)
        for (int x = 0; x < p->width; ++x) {
            const float ao[2] = { value(x * step, y * step),
                                  frame.data[(frame.height - 1 - y * step) * frame.width + x * step] };
            glTexSubImage2D(GL_TEXTURE_2D, 0, x, y, 1, 1, GL_RG, GL_FLOAT, ao);
        }
    /* the first pass draws nowhere: the texture stays ours */
    glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer);
    glDrawBuffers(1, &(GLenum){ GL_NONE });
    if (!draw(&out, run)) return 1;
    for (int y = border; y < out.height - border; ++y)
        for (int x = border; x < out.width - border; ++x) {
            const double d = fabs((double)out.data[y * out.width + x] - (double)expected(x, out.height - 1 - y));
            if (!(d <= worst)) worst = d;
        }
    kit_gbuffer_free(&g);
    kit_image_free(&frame);
    kit_image_free(&out);
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
                /* its weight is a pixel's width over the distance: never 0 */
                { "blur=2,normal=depth", 1e-3, 0, 0 },
                { "blur=2,filter=gaussian", 0.02, 0, 0 },
                { "half=1,blur=1", 1e-3, 0, 1 },
                { "half=1,blur=2,filter_normals=1", 1e-3, 0, 1 } };
    double worst[5] = { 0 };
    for (int i = 0; i < 16; ++i) {
        const kit_camera c = looking_along_z(61 + 2 * i, 45, i & 1);
        const char *set = row[i / 2].set;
        kit_run run = { 0 };
        const double constant = filtered(&run, &c, tilted, 1, set, constant_value, constant_value, 0),
                     edge = filtered(&run, &c, facing, 2, set, side_value, side_value, 0),
                     tile = row[i / 2].tile ? fmax(filtered(&run, &c, facing, 1, set, tile_value, mean_value, 3),
                                                   filtered(&run, &c, tilted, 1, set, tile_value, mean_value, 3))
                                            : 0,
                     ramp = row[i / 2].ramp ? filtered(&run, &c, facing, 1, set, ramp_value, ramp_value, 8) : 0;
        /* half size: odd pixels have one more tap to the left and below, which moves what they see by less than half a
           pixel */
        kit_run_close(&run);
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

void test_pipeline(void)
{
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("the corner agrees with its closed forms and with the paper's march", corner_converges);
    RUN("the march's terms, its layers and its spheres are what closed forms say", terms_of_the_march);
    RUN("an extra camera's solids raise the horizon", horizon_of_another_camera);
    RUN("taps of a wall are joined: few see it as dark as many", taps_of_a_wall_are_joined);
    RUN("back faces and slabs are what rays meet, and come back from a frame", back_faces_are_drawn);
    RUN("what engines have: left-handed, upside down, oblique, sampled, sliced, decoded by a text of one's own",
        what_engines_have);
    RUN("an orthographic eye may stand anywhere, whichever way depth is given", orthographic_eyes);
    RUN("every size of picture gives sound values, and 1 where nothing is", sizes_do_not_matter);
    RUN("a tiny radius sees nothing, a huge one no nonsense", radii_do_not_matter);
    RUN("garbage in depth and normals stays within [0,1]", garbage_is_survived);
    RUN("a room is near its ray-traced truth", near_the_truth);
    RUN("thin plates seen in perspective, with their back faces, are near their truth", plates_in_perspective);
    RUN("a post is as thick as it is wide, or as its back face says; a sheet half as thick", widths_are_measured);
    RUN("a ball whose winding is wrong is nearly as true with back faces as without", wrong_winding);
    RUN("the foretold number of fetches is what shaders make", fetches_are_counted);
    RUN("the filter keeps constants, edges and ramps, and averages a tile of noise", filter_keeps_its_word);
    kit_gl_close();
}
