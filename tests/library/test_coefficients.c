/* test_coefficients.c - s3ho and ssbn, drawn: coefficients and light against closed forms, lamps, bent normals; pairs
   of pictures of light, also by ssdo, that must be equal. */
#include "t.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;

enum { W = 96, H = 54 };
static const kit_lighting dark;

/* ---- vectors: 16 coefficients of the clamped cosine times visibility --------------------------------------------- */

static void basis(float y[16], const double d[3])
{
    const float direction[3] = { (float)d[0], (float)d[1], (float)d[2] };
    ssgi_sh_basis(y, 4, direction);
}

/* Writes light of four bands that is positive on every surface, and different in all channels. */
static void some_light(float light[48])
{
    for (int i = 0; i < 48; ++i) light[i] = i < 3 ? 3 + 0.5f * (float)i : 0.4f * sinf(2.3f * (float)i);
}

/* Returns the vectors that a pass of 4 bands wrote, by pixel, from any storage. The caller frees them; NULL: failed. */
static float *coefficients_new(const kit_run *run, int pass)
{
    const kit_pass *p = &run->pass[pass];
    const size_t texels = (size_t)p->width * (size_t)p->height, per = p->desc.light.packed_coefficients ? 8 : 4;
    FREED float *texel = malloc(4 * texels * sizeof *texel);
    float *out = malloc(16 * texels * sizeof *out);
    int ok = out && texel;
    for (size_t t = 0; t < 16 / per && ok; ++t) {
        ok = CHECK(!kit_texture_read(p->target[t], p->width, p->height, 4, texel), "vectors cannot be read");
        for (size_t i = 0; i < texels * per && ok; ++i) {
            float *to = &out[16 * (i / per) + per * t + i % per];
            uint32_t word;
            memcpy(&word, texel + (per > 4 ? i / 2 : i), sizeof word);
            if (per > 4) *to = (float)value_of((int)(word >> (i & 1 ? 16 : 0) & 0xffff));
            else memcpy(to, &word, sizeof word);
        }
    }
    if (ok) return out;
    free(out);
    return NULL;
}

/* Compiles a pass's program again, for its present desc. */
static int remade(kit_run *run, int pass)
{
    run->pass[pass].program = 0;
    return CHECK(!kit_pass_make(&run->pass[pass], &err), "%s", err.text);
}

/* ---- the corner -------------------------------------------------------------------------------------------------- */

/* A wall at distance c, in radii, whose slab ends at end; weight: how much an occluder at distance d counts. */
typedef struct wall { double c, end; int steps; double (*weight)(double d); } wall;
static double whole(double d)  { (void)d; return 1; }
static double smooth(double d) { const double t = fmin(1, fmax(0, (d - 0.5) / 0.5)); return 1 - t * t * (3 - 2 * t); }
static double lambda(double d) { return 1 / (1 + 2 * d); }
static double within(double d) { return d <= 1; }

/* Writes the expected vector of the floor before a wall, as the corner's camera shows it: quadrature over directions
   and lengths. A sample behind the wall's face is blocked by the face at its pixel. n: the floor's normal; along: from
   there down the slope to the wall. */
static void wall_vector(double v[16], const wall *w, const double n[3], const double along[3])
{
    enum { RINGS = 100, SPOKES = 200, LENGTHS = 64 };
    const double side[3] = { n[1] * along[2] - n[2] * along[1], n[2] * along[0] - n[0] * along[2],
                             n[0] * along[1] - n[1] * along[0] };
    memset(v, 0, 16 * sizeof *v);
    for (int k = 0; k < RINGS * SPOKES; ++k) {
        const double r = sqrt((k / SPOKES + 0.5) / RINGS), a = 2 * pi * (k % SPOKES + 0.5) / SPOKES, x = r * cos(a),
                     y = r * sin(a), z = sqrt(1 - r * r);
        const double d[3] = { x * along[0] + y * side[0] + z * n[0], x * along[1] + y * side[1] + z * n[1],
                              x * along[2] + y * side[2] + z * n[2] };
        double blocked = 0;
        float Y[16];
        for (int i = 0; i < LENGTHS; ++i)
            for (int j = 0; j < w->steps; ++j) {
                const double t = (j + (i + 0.5) / LENGTHS) / w->steps, behind = t * x - w->c;
                if (!(behind > 0 && t * x < w->end)) continue;
                blocked += w->weight(sqrt(w->c * w->c + t * y * t * y + (t * z + behind) * (t * z + behind))) / LENGTHS;
                break;
            }
        basis(Y, d);
        for (int i = 0; i < 16; ++i) v[i] += (1 - blocked) * (double)Y[i] * pi / (RINGS * SPOKES);
    }
}

/* Draws a row's middle columns, and the pixels around them that a filter reads; then reads the row from a pass's
   targets. Emitters are drawn whole. */
static int strip(float *out, kit_run *run, int row, int pass, int targets)
{
    const int passes = run->passes;
    FREED float *texel = malloc((size_t)WIDE * (size_t)(row + 1) * 4 * sizeof *texel);
    int ok = texel != NULL;
    for (run->passes = 0; run->pass[run->passes].desc.pass == SSGI_GL_PASS_EMITTERS; ++run->passes) {}
    kit_run_update(run);
    kit_run_draw(run, 0);
    run->passes = passes;
    glEnable(GL_SCISSOR_TEST);
    glScissor(MIDDLE - 8, row - 8, COLUMNS + 16, 17);
    kit_run_draw(run, 0);
    glDisable(GL_SCISSOR_TEST);
    for (int t = 0; t < targets && ok; ++t) {
        ok = CHECK(!kit_texture_read(run->pass[pass].target[t], WIDE, row + 1, 4, texel), "a target cannot be read");
        for (int i = 0; i < COLUMNS && ok; ++i)
            memcpy(out + 4 * (targets * i + t), texel + 4 * (row * WIDE + MIDDLE + i), 4 * sizeof *out);
    }
    return ok;
}

/* Writes the means of strip's results over columns and phases of the noise. */
static int strip_mean(double *mean_, kit_run *run, kit_gbuffer *g, int row, int phases, int pass, int targets)
{
    float texel[COLUMNS * 16];
    int ok = 1;
    turn(run, g);
    memset(mean_, 0, 4 * (size_t)targets * sizeof *mean_);
    for (int k = 0; k < phases && ok; ++k) {
        run->frame.phase = (float)k / (float)phases;
        ok = strip(texel, run, row, pass, targets);
        for (int i = 0; i < COLUMNS * 4 * targets && ok; ++i)
            mean_[i % (4 * targets)] += (double)texel[i] / (COLUMNS * phases);
    }
    return ok;
}

static void walls_block(void)
{
    static const double oracle[16] = { 0.73715139,  0,           0.87559242,   -0.16423885, 0, 0,
                                       0.47457613,  -0.19608595, -0.072164136, 0,           0, 0,
                                       0.076696803, -0.10079881, -0.099015153, -0.001256478 };
    static const struct { const char *set; wall w;
    } row[] = { { "", { 0.25, 9, 1, whole } },
                { "", { 0.1, 9, 1, whole } },
                { "", { 0.5, 9, 1, whole } },
                { "sets=16", { 0.25, 9, 1, whole } },
                { "samples=4", { 0.25, 9, 4, whole } },
                { "layers=2,samples=4", { 0.25, 0.35, 4, whole } },
                { "fade=smooth,fade_from=0.5", { 0.25, 9, 1, smooth } },
                { "fade=lambda,lambda=2", { 0.25, 9, 1, lambda } },
                { "fade=lambda,lambda=2,layers=2", { 0.25, 0.35, 1, lambda } },
                { "range_check=1", { 0.25, 9, 1, within } } };
    static const double up[3] = { 0, 0, 1 }, right[3] = { 1, 0, 0 };
    double v[16], found[16], worst = 0;
    wall_vector(v, &row[0].w, up, right);
    for (int i = 0; i < 16; ++i) worst = fmax(worst, fabs(v[i] - oracle[i]));
    SHOW(worst < 1e-3, "the quadrature itself is off by %.1e", worst);
    worst = 0;
    for (int m = 0; m < ROWS(row); ++m) {
        const wall *w = &row[m].w;
        double plane[2][4], along[3], off = 0;
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_run) run = { 0 };
        char set[128];
        snprintf(set, sizeof set, "indirect=none,filtered=coefficients,store=float,thickness=solid,directions=64,%s",
                 row[m].set);
        corner_planes(plane, w->c, 0);
        for (int i = 0; i < 3; ++i) along[i] = -plane[1][i];
        wall_vector(v, w, plane[0], along);
        if (!slab(&g, w->c, w->end - w->c, 0, w->end < 1 ? 2 : 1)
            || !begin(&run, &g, "s3ho-points", set, 1, NULL, &dark)
            || !strip_mean(found, &run, &g, row_at(w->c), 8, 0, 4))
            return;
        for (int i = 0; i < 16; ++i) off = fmax(off, fabs(found[i] - v[i]));
        CHECK(off <= 0.003, "%s, c %g: a coefficient is off by %.4f", row[m].set, w->c, off);
        worst = fmax(worst, off);
    }
    t_note("a coefficient is off by %.4f at most", worst);
}

/* Checks light that grows toward the wall, away from it, or sideways. Slices must take away the light of the very
   directions that they block. In the corner upside down the wall is on the slices' other side. */
static void slices_know_directions(void)
{
    static const struct { const char *method, *set; } row[] = {
        { "ssdo", "bounce=none,environment=sh,bands=2" }, { "s3ho", "indirect=none,bands=2" },
        { "s3ho", "indirect=none,bands=4,thickness=solid" } };
    static const wall w = { 0.25, 9, 1, whole };
    double v[2][16], worst = 0;
    OWN(kit_lighting) white = { 0 };
    kit_gbuffer g[2];
    if (!lighten(&white, "white", NULL)) return;
    for (int down = 0; down < 2; ++down) {
        double plane[2][4], along[3];
        const kit_camera camera = corner_planes(plane, w.c, 0);
        OWN(kit_image) frame = { 0 };
        for (int i = 0; i < 2 && down; ++i) plane[i][1] = -plane[i][1];
        for (int i = 0; i < 3; ++i) along[i] = -plane[1][i];
        wall_vector(v[down], &w, plane[0], along);
        if (!walls(&g[down], &frame, &camera, (const double (*)[4])plane, 2, "")) return;
    }
    for (int m = 0; m < ROWS(row); ++m) {
        OWN(kit_run) run = { 0 };
        char set[128];
        snprintf(set, sizeof set, "slices=2,%s", row[m].set);
        if (!begin(&run, &g[0], row[m].method, set, 1, NULL, &white)) return;
        for (int k = 0; k < 4; ++k) {
            const int down = k & 1, row_ = down ? HIGH - 1 - row_at(w.c) : row_at(w.c);
            const double toward = (k & 2 ? 0.6 : -0.6) * sqrt(0.5), b[3] = { down ? -toward : toward, -toward, 0.3 };
            float light[12];
            for (int i = 0; i < 12; ++i) light[i] = i < 3 ? 3.5449077f : (float)(b[i / 3 - 1] / 0.48860251);
            ssgi_gl_harmonics_set(&run.frame, light, 2, NULL, NULL);
            const double got = row_of(&run, &g[down], row_, 16), want = met(v[down], light, 0, 2);
            worst = fmax(worst, fabs(got - want));
            CHECK(fabs(got - want) < 0.006, "%s %s, light %s the wall, %s: %.4f, truth %.4f", row[m].method, set,
                  k & 2 ? "toward" : "off", down ? "down" : "up", got, want);
        }
    }
    for (int i = 0; i < 2; ++i) kit_gbuffer_free(&g[i]);
    t_note("%.4f off at most", worst);
}

/* Checks that a wall reflects uniform light by its albedo, as far as it blocks the floor. Normals have 6 bits. */
static void walls_reflect(void)
{
    static const float albedo[3] = { 0.75f, 0.25f, 0.5f };
    static const char *const sets[2] = { "indirect=joint,two_sided=0", "indirect=apart,bands=3,two_sided=1" };
    static const wall w = { 0.25, 9, 1, lambda };
    const size_t pixels = (size_t)WIDE * HIGH;
    double plane[2][4], along[3], v[16], open[16], found[4], worst = 0;
    float light[48];
    OWN(kit_image) frame = { 0 };
    const kit_camera c = corner_planes(plane, w.c, 0);
    some_light(light);
    for (int i = 0; i < 3; ++i) along[i] = -plane[1][i];
    wall_vector(v, &w, plane[0], along);
    open_vector(open, plane[1]);
    if (!planes_seen(&frame, &c, (const double (*)[4])plane, 2, ",albedo.R,albedo.G,albedo.B")) return;
    for (size_t i = 0; i < 3 * pixels; ++i)
        frame.data[4 * pixels + i] = frame.data[2 * pixels + i % pixels] < 0 ? albedo[i / pixels] : 0;
    for (int m = 0; m < 2; ++m) {
        /* the wall's normals point away from the floor */
        if (m)
            for (size_t i = 0; i < 3 * pixels; ++i)
                if (frame.data[4 * pixels + i % pixels] > 0) frame.data[pixels + i] *= -1;
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_run) run = { 0 };
        if (!TRY(kit_gbuffer_from_frame(&g, &frame, &c, &err))) return;
        char set[96];
        snprintf(set, sizeof set, "thickness=solid,directions=64,fade=lambda,lambda=2,%s", sets[m]);
        if (!begin(&run, &g, "s3ho-points", set, 1, NULL, &dark)) return;
        ssgi_gl_harmonics_set(&run.frame, light, 4, NULL, NULL);
        int last = 0;                                   /* the index of the pass that draws the bounce */
        while (run.pass[last].target[0] != run.bounce) ++last;
        if (!strip_mean(found, &run, &g, row_at(w.c), 8, last, 1)) return;
        for (int j = 0; j < 3; ++j) {
            const double truth =
                (1 - v[0] / 0.886226925) * (double)albedo[j] * met(open, light, j, 3) + (m ? 0 : met(v, light, j, 4));
            worst = fmax(worst, fabs(found[j] / truth - 1));
            CHECK(fabs(found[j] / truth - 1) <= 0.01, "%s, channel %d: %.4f, expected %.4f", sets[m], j, found[j],
                  truth);
        }
    }
    t_note("%.2e of it off at most", worst);
}

/* Writes vectors of the last frame, which the pass reads: a fully open lobe on the wall if bit 0 of `open` is set, on
   the back if bit 1 is; else 0. */
static void leave_lobes(const kit_run *run, int pass, const kit_image *frame, int open)
{
    static uint32_t texel[2][W * H][4];
    for (int i = 0; i < W * H; ++i) {
        const int from = (H - 1 - i / W) * W + i % W, upright = frame->data[W * H + from] > 0.5f;
        const double n[3] = { upright, 0, !upright };
        double v[16] = { 0 };
        if (open >> !upright & 1) open_vector(v, n);
        for (int k = 0; k < 8; ++k)
            texel[k / 4][i][k % 4] = (uint32_t)half_of((float)v[2 * k]) | (uint32_t)half_of((float)v[2 * k + 1]) << 16;
    }
    const kit_pass *p = &run->pass[pass];
    for (int k = 0; k < p->step->inputs; ++k) {
        const char *name = p->step->input[k].name;
        if (strncmp(name, "t_ssgi_last_", 12)) continue;
        glBindTexture(GL_TEXTURE_2D, p->input[k]);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, W, H, GL_RGBA_INTEGER, GL_UNSIGNED_INT,
                        texel[name[strlen(name) - 1] - '0']);
    }
    glBindTexture(GL_TEXTURE_2D, 0);
}

/* Checks that the last frame's vectors tell how much light reaches a wall and the back of a room, and so how much these
   send: all of it with open lobes, none with lobes of 0, and one may be open alone. Normals along axes are exact. */
static void emitters_are_dimmed(void)
{
    static const double planes[2][4] = { { 1, 0, 0, -0.5 }, { 0, 0, 1, -4 } };
    static const char *const methods[2] = { "s3ho-points", "s3ho" };
    const kit_camera c = looking_along_z(W, H, 0);
    OWN(kit_image) frame = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    if (!planes_seen(&frame, &c, planes, 2, ",albedo.R,albedo.G,albedo.B")) return;
    for (int i = 4 * W * H; i < 7 * W * H; ++i) frame.data[i] = 0.8f;
    if (!TRY(kit_gbuffer_from_frame(&g, &frame, &c, &err))) return;
    for (int m = 0; m < 2; ++m) {
        float *vector[6];  /* results: fully open; no reflection; vectors of none, wall, back, both */
        double worst = 0, sent = 0;
        kit_run run;
        for (int k = 0, pass; k < 6; ++k) {
            char set[96];
            snprintf(set, sizeof set, "indirect=%s,store=packed,filtered=coefficients,blur=1,occluded_emitters=%d,%s",
                     k == 1 ? "none" : "joint", k > 1, m ? "samples=6" : "directions=8");
            if (k < 3 && !begin(&run, &g, methods[m], set, 1, NULL, &dark)) return;
            for (pass = 0; run.pass[pass].desc.pass != SSGI_GL_PASS_S3HO; ++pass) {}
            const int passes = run.passes;
            if (k > 1) leave_lobes(&run, pass, &frame, k - 2);
            run.passes = pass + 1;
            kit_run_update(&run);
            kit_run_draw(&run, 0);
            run.passes = passes;
            if (!(vector[k] = coefficients_new(&run, pass))) return;
            if (k < 2 || k == 5) kit_run_close(&run);
        }
        for (int i = 0; i < 16 * W * H; ++i) {
            const int at = i / 16, from = (H - 1 - at / W) * W + at % W, upright = frame.data[W * H + from] > 0.5f;
            sent = fmax(sent, fabs((double)vector[0][i] - (double)vector[1][i]));
            for (int k = 2; k < 6; ++k) /* each of the two surfaces receives the other one's light */
                worst = fmax(worst, fabs((double)vector[k][i] - (double)vector[(k - 2) >> upright & 1 ? 0 : 1][i]));
        }
        CHECK(sent > 0.1 && worst < 1.5e-3, "%s: %.4f off, where %.4f is sent", methods[m], worst, sent);
        t_note("%s: %.1e off, where %.2f is sent", methods[m], worst, sent);
        for (int k = 0; k < 6; ++k) free(vector[k]);
    }
}

/* Checks that a chain's gather reads, of the last frame, the vectors that the filter wrote. */
static void filtered_sets_are_left(void)
{
    const ssgi_gl_chain chain = { .desc = { .pass = SSGI_GL_PASS_S3HO,
                                            .gather.resolution = 1,
                                            .light.packed_coefficients = 1,
                                            .light.transfer = SSGI_GL_TRANSFER_BOTH,
                                            .light.occluded_emitters = 1 },
                                  .width = 64,
                                  .height = 48,
                                  .blur = 1,
                                  .coefficients = 1 };
    static ssgi_gl_step step[8];
    const int count = ssgi_gl_steps(step, 8, &chain, NULL);
    int read = 0;
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < step[i].inputs; ++k) {
            const ssgi_gl_input *in = &step[i].input[k];
            for (int m = i + 1; m < count && !strncmp(in->name, "t_ssgi_last_", 12); ++m)
                for (int o = 0; o < step[m].outputs && step[m].desc.pass == SSGI_GL_PASS_BLUR; ++o)
                    read += in->texture == step[m].output[o].texture && in->last && in->width == 64 && in->height == 48
                         && !strcmp(in->name + strlen("t_ssgi_last_"), step[m].output[o].name + strlen("o_ssgi_"))
                         && in->format == step[m].output[o].format;
        }
    CHECK(read == 6, "%d of 6 sets' textures have the values that the filter wrote", read);
}

/* ---- light ------------------------------------------------------------------------------------------------------- */

/* Returns the light of a lobe on an open surface, over that on one that faces it; with one band, over the irradiance
   there. cap is the cosine of the half-angle that the light fills. */
static double lobe(double cosine, double cap, int bands, const float *window)
{
    const double f[3] = { 1, 0.5 + 0.5 * cap, 0.5 * cap * (1 + cap) }, a[3] = { 0.25, 0.5, 0.3125 },
                 p[3] = { 1, cosine, 1.5 * cosine * cosine - 0.5 };
    double sum = 0, facing = 0;
    for (int i = 0; i < 3 && i < bands; ++i) {
        sum += a[i] * (double)window[i] * f[i] * p[i];
        facing += a[i] * (double)window[i] * f[i];
    }
    return fmax(0, sum / (bands > 1 ? facing : 1));
}

/* Checks the middle pixel of a plane that faces the camera, lit by one lamp after another. Outgoing radiance must be
   incoming light times albedo, in the kit and in pass shade. */
static void lamps_light_what_faces_them(void)
{
    enum { WIDTH = 17, HEIGHT = 9, MIDDLE_X = 8, MIDDLE_Y = 4 };
    /* back: a light behind a sun, by 4 bands */
    static const double plane[1][4] = { { 0, 0, 1, -2 } }, angles[] = { 0, 40, 85, 120, 180 },
                        back[3] = { 0.0588235, 0, 0.0204082 };
    static const struct {
        double kind, distance, radius;
    } row[] = { { SSGI_GL_LIGHT_SUN, 1, 0 },
                { SSGI_GL_LIGHT_POINT, 0.7, 0 },
                { SSGI_GL_LIGHT_POINT, 1.6, 0.8 },
                { SSGI_GL_LIGHT_POINT, 0.5, 0.49 } };
    const kit_camera c = looking_along_z(WIDTH, HEIGHT, 1);
    float P[3];
    double worst = 0;
    kit_lighting l;
    OWN(kit_image) frame = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    kit_camera_point(&c, MIDDLE_X, MIDDLE_Y, 2, P);
    if (!lighten(&l, NULL, "point:0,0,0,1,1,1") || !walls(&g, &frame, &c, plane, 1, "")) return;
    for (int bands = 1; bands <= 4; ++bands) {
        OWN(kit_run) run = { 0 };
        char set[64];
        snprintf(set, sizeof set, "indirect=none,store=float,bands=%d", bands);
        if (!begin(&run, &g, "s3ho-points", set, 0.5f, NULL, &l)) return;
        for (int k = 0; k < 3 * 4 * 5; ++k) {
            OWN(kit_image) out = { 0 }, sent = { 0 };
            const int window = k / 20, m = k / 5 % 4, last = k == 3 * 4 * 5 - 1;
            const double angle = angles[k % 5] * pi / 180, sun = row[m].kind > 0 ? 0 : 1, d = row[m].distance,
                         cap = sqrt(1 - row[m].radius * row[m].radius / (d * d));
            ssgi_gl_light lamp = { .kind = (float)row[m].kind,
                                   .colour = { 2, 1, 0.5f },
                                   .min_distance = (float)row[m].radius };
            lamp.at[0] = (float)(d * sin(angle) * 0.6 + (1 - sun) * (double)P[0]);
            lamp.at[1] = (float)(d * sin(angle) * 0.8 + (1 - sun) * (double)P[1]);
            lamp.at[2] = (float)(d * cos(angle) + (1 - sun) * (double)P[2]);
            memset(run.frame.window, 0, sizeof run.frame.window);
            ssgi_sh_window(run.frame.window, bands, window);
            run.frame.lights = 1;
            run.pass[1].lights = kit_texture(8, 1, GL_RGBA32F, lamp.at);
            if (!drawn(&out, &run)) return;
            run.pass[1].desc.light.albedo = last;
            if (last && (!remade(&run, 1) || !drawn(&sent, &run))) return;
            for (int j = 0; j < 3; ++j) {
                const double found = (double)out.data[((3 + j) * HEIGHT + MIDDLE_Y) * WIDTH + MIDDLE_X] * pi * d * d
                                     / (double)lamp.colour[j],
                             truth = lobe(cos(angle), cap, bands, run.frame.window);
                worst = fmax(worst, fabs(found - truth));
                CHECK(found >= 0 && fabs(found - truth) <= 1e-5
                          && (k % 5 || fabs(found - (bands > 1 ? 1 : 0.25)) <= 1e-5)
                          && (bands < 4 || m || k % 5 < 4 || fabs(found - back[window]) <= 1e-5),
                      "%d bands, window %d, lamp %d, %g degrees: %.6f, expected %.6f", bands, window, m, angles[k % 5],
                      found, truth);
                const float *const goes = out.data + j * WIDTH * HEIGHT, *const comes = goes + 3 * WIDTH * HEIGHT;
                for (int i = 0; i < WIDTH * HEIGHT && last; ++i)
                    CHECK(fabsf(goes[i] - 0.8f * comes[i]) < 1e-3f * comes[i]
                              && fabsf(sent.data[(3 + j) * WIDTH * HEIGHT + i] - goes[i]) < 1e-3f * goes[i],
                          "%g comes in, %g goes out, by pass shade %g", (double)comes[i], (double)goes[i],
                          (double)sent.data[(3 + j) * WIDTH * HEIGHT + i]);
            }
            glDeleteTextures(1, &run.pass[1].lights);
        }
    }
    t_note("%.1e off at most", worst);
}

/* Checks that with desc.light.residual an open plane gets the exact light of suns and point lights: with any bands,
   with light or coefficients filtered, with any window. So it does by bent cones, under a black sky and without one. */
static void open_is_exact(void)
{
    static const char *const lights[] = { "sun:0,1,0,2,1,3", "sun:1,0.3,0.2,2,1,3", "sun:0.3,-1,0.1,2,1,3",
                                          "point:0.4,0.7,0.2,1,2,0.5" };
    double worst[2] = { 0, 0 };
    for (int k = 0; k < 24; ++k) {
        OWN(scenery) s = { 0 };
        OWN(kit_image) out = { 0 };
        char set[128];
        const int cones = k >= 16, lamp = k % 4 == 3;
        if (cones) snprintf(set, sizeof set, "residual=1,lights=harmonics,");
        else snprintf(set, sizeof set, "indirect=none,bands=%d,residual=1,lights=harmonics,", 1 + k / 4);
        snprintf(set + strlen(set), 64, "window=%s,store=float,filtered=%s", k % 3 ? "hann" : "none",
                 k % 2 ? "light" : "coefficients");
        if (!set_scene(&s, "plane", NULL, NULL, lights[k % 4], W, H)
            || (k >= 20 && !TRY(kit_image_new(&s.light.env, 16, 8, "R,G,B", &err)))
            || !lit(&out, &s.g, cones ? "ssbn-points" : "s3ho-points", set, s.scene.radius, &s.scene, &s.light))
            return;
        const kit_light *const l = &s.light.light[0];
        for (int i = 5 * W + 3; i < W * H; i += 13) {
            float o[3], d[3];
            kit_camera_ray(&s.g.camera, i % W, i / W, o, d);
            const double t = -(double)o[1] / (double)d[1], x = (double)o[0] + t * (double)d[0],
                         z = (double)o[2] + t * (double)d[2], to[3] = { (double)l->at[0] - x, (double)l->at[1],
                                                                       (double)l->at[2] - z },
                         dd = to[0] * to[0] + to[1] * to[1] + to[2] * to[2],
                         cosine = lamp ? to[1] / sqrt(dd) / dd : (double)l->at[1];
            if (!(t > 0) || fmax(fabs(x), fabs(z)) > 0.9) continue;
            for (int c = 0; c < 3; ++c) {
                const double sends = (double)l->colour[c] / pi, got = (double)out.data[(3 + c) * W * H + i],
                             off = fabs(got - fmax(cosine, 0) * sends) / sends;
                worst[lamp] = fmax(worst[lamp], off / (lamp ? fmax(cosine, 0.01) : 1));
            }
        }
    }
    SHOW(worst[0] < 0.004 && worst[1] < 1e-4,
         "suns, through a map of 32 x 32, are off by %.1e of the light sent, lamps by %.1e", worst[0], worst[1]);
}

/* ---- two pictures that are one ----------------------------------------------------------------------------------- */

/* Makes a ridge under a street's lamps: nothing occludes, and light differs across the edge. */
static int ridge(kit_gbuffer *g)
{
    static const double side[2][1][4] = { { { 0.6, 0.1, 0.79372539, -1.5 } }, { { -0.6, 0.1, 0.79372539, -1.5 } } };
    static const char slabs[] = ",back.Z,front2.Z,back2.Z";
    enum { WIDTH = 97, PIXELS = WIDTH * 55 };
    const kit_camera c = looking_along_z(WIDTH, PIXELS / WIDTH, 0);
    OWN(kit_image) frame = { 0 }, other = { 0 };
    if (!planes_seen(&frame, &c, side[0], 1, slabs) || !planes_seen(&other, &c, side[1], 1, slabs)) return 0;
    for (int i = 0; i < PIXELS; ++i)                       /* keeps the farther one of the ridge's two slopes */
        for (int k = 3; other.data[i] > frame.data[i] && k >= 0; --k)
            frame.data[k * PIXELS + i] = other.data[k * PIXELS + i];
    return TRY(kit_gbuffer_from_frame(g, &frame, &c, &err));
}

/* Checks pairs of pictures that must be equal, or must not: their difference, over the first one's mean. A sun whose
   series is below 0 behind it. Vectors filtered and then lit, or lit and then filtered, without restoring; and in other
   storage, so with other rounding. With one band most of a lamp is residual, and a gather of light and bounce together
   must not add that to the bounce. What the filter restores of open light must not change the bounce. Default filters
   keep a ridge sharp, as no filter does; a filter of light without restoring does not. */
static void compare(int ridges)
{
    enum { UNDER_SKY, UNDER_SUN, BY_LAMP, AMONG_COLUMNS, RIDGE, LIT_RIDGE, STAGES };
    enum { WORST, RMSE, MEANS };
    static const char *const stages[STAGES][3] = { { "room", "sky", NULL }, { "room", "sky", NULL },
                                                   { "cornell", NULL, "point:0,5,-2.8,20,20,20" },
                                                   { "columns", "sky", NULL }, { "a ridge", "street", NULL },
                                                   { "a ridge", "street", "point:0.5,1,1,2,1,1" } };
    static const char light_of[] = "irradiance.R", bounce[] = "bounce.R", points[] = "s3ho-points";
    static const float at[3] = { 0.5f, 0.7f, 0.4f }, colour[3] = { 3, 2, 1 };
    static const struct { const char *method[2], *set, *own[2], *channel; int stage, by; double least, most; } row[] = {
        { { "ssdo-points", points }, "bands=3,fade=smooth,", { "bounce=none,environment=sh",
          "indirect=none,store=float,filtered=coefficients" }, light_of, UNDER_SUN, WORST, 0, 3e-6 },
        { { "ssdo-points", points }, "bands=3,fade=smooth,", { "bounce=none,environment=sh",
          "indirect=none,filtered=light" }, light_of, UNDER_SUN, WORST, 0, 3e-6 },
#define ORDER(set, seen, most) \
        { { points, points }, "restore=none," set ",filtered=", { "light", "coefficients" }, seen, UNDER_SKY, WORST, \
          0, most }
        ORDER("store=float,indirect=none,blur=2", light_of, 1e-5),
        /* off the plane, a filter's weights are not quite 0 */
        ORDER("store=float,indirect=none,blur=1,resolution=half", light_of, 1e-4),
        ORDER("store=float,indirect=none,blur=3,filter=gaussian", light_of, 1e-5),
        ORDER("store=float,indirect=none,blur=1,filter_normals=1", light_of, 1e-5),
        ORDER("store=packed,indirect=joint,blur=1", light_of, 2e-3),
        ORDER("store=packed,indirect=joint,blur=1", bounce, 0.12),
        ORDER("store=packed,indirect=apart,blur=1,resolution=half", bounce, 0.03),
#define STORES(set, a, b, most) \
        { { points, points }, "filtered=coefficients," set ",store=", { a, b }, light_of, UNDER_SKY, WORST, 1e-9, most }
        STORES("indirect=none,bands=4", "float", "half", 1.5e-3),
        STORES("indirect=none,bands=4,blur=2", "float", "packed", 8e-4),
        STORES("indirect=none,bands=3", "float", "packed", 5e-4),
        STORES("indirect=apart,bands=2", "half", "packed", 1.5e-3),
        STORES("indirect=apart,bands=1", "float", "half", 8e-4),
        { { "s3ho", "s3ho" }, "residual=1,bands=1,blur=1,resolution=half,indirect=", { "joint", "apart" }, bounce,
          BY_LAMP,
          MEANS, 0, 0.05 },
#define RESTORES(stage, how) \
        { { "s3ho", "s3ho" }, "residual=1,blur=1,resolution=half,indirect=apart,restore=", { "none", how }, bounce, \
          stage, RMSE, 0, 1e-3 }
        RESTORES(BY_LAMP, "ratio"), RESTORES(AMONG_COLUMNS, "difference"),
        { { "hsao", "hsao" }, "left_handed=", { "0", "1" }, "Y", UNDER_SKY, WORST, 0, 0 },
#define CREASE(method, set, half, stage, least, most) \
        { { method, method }, set, { ",blur=1,samples=4,resolution=" half, ",blur=0,resolution=full,restore=none" }, \
          light_of, stage, RMSE, least, most }
        CREASE("ssdo", "bounce=none", "1", RIDGE, 0, 0.003),
        CREASE("ssdo", "bounce=none,environment=sh", "1", RIDGE, 0, 0.003),
        CREASE("ssdo-best", "bounce=none", "0", RIDGE, 0, 0.003),
        CREASE("ssdo-points", "bounce=none", "1", RIDGE, 0, 0.003),
        CREASE("ssdo", "bounce=none,thickness=slabs,restore=difference", "1", RIDGE, 0, 0.003),
        CREASE("ssdo", "bounce=none,restore=none", "1", RIDGE, 0.005, 1),
        CREASE("s3ho", "residual=1", "1", RIDGE, 0, 0.003),
        CREASE("s3ho", "residual=1,bands=2,indirect=joint", "1", RIDGE, 0, 0.003),
        CREASE("s3ho", "residual=1,bands=1,store=packed,lights=harmonics", "1", LIT_RIDGE, 0, 0.003),
        CREASE("s3ho", "residual=1,restore=none", "1", RIDGE, 0.005, 1),
        CREASE("ssbn", "cone=cone", "1", RIDGE, 0, 0.003), CREASE("ssbn", "cone=normal", "1", RIDGE, 0, 0.003) };
    static scenery s;                      /* the last row's */
    float light[27] = { 0 }, view[16], projection[16];
    ssgi_sh_light(light, 3, at, 0, colour, SSGI_SH_WINDOW_NONE, NULL);
    for (int m = 0, last = -1; m < ROWS(row); ++m) {
        const char *const *const of = stages[row[m].stage];
        const int on_ridge = row[m].stage >= RIDGE, stays = row[m].stage == last;
        if (on_ridge != ridges) continue;
        if (last >= 0 && !stays) strike(&s);
        last = row[m].stage;
        kit_image out[2];
        double worst = 0, square = 0, sum[2] = { 0 };
        if (!stays
            && (on_ridge ? !ridge(&s.g) || !lighten(&s.light, of[1], of[2])
                         : !set_scene(&s, of[0], NULL, of[1], of[2], W, H)))
            return;
        kit_camera_matrices(&s.g.camera, view, projection);
        for (int k = 0; k < 2; ++k) {
            const float radius = !on_ridge ? s.scene.radius : k ? 1e-6f : 0.1f;
            OWN(kit_run) run = { 0 };
            char set[160];
            snprintf(set, sizeof set, "%s%s", row[m].set, row[m].own[k]);
            if (!begin(&run, &s.g, row[m].method[k], set, radius, on_ridge ? NULL : &s.scene, &s.light)) return;
            if (row[m].stage == UNDER_SUN) ssgi_gl_harmonics_set(&run.frame, light, 3, view, NULL);
            if (!drawn(&out[k], &run)) return;
        }
        const float *const a = kit_image_channel(&out[0], row[m].channel),
                    *const b = kit_image_channel(&out[1], row[m].channel);
        const int values = (out[0].channels > 1 ? 3 : 1) * out[0].width * out[0].height;
        for (int i = 0; i < values; ++i) {
            const double off = (double)a[i] - (double)b[i];
            worst = fmax(worst, fabs(off));
            square += off * off / values;
            sum[0] += (double)a[i] / values;
            sum[1] += (double)b[i] / values;
        }
        const double apart_ = row[m].by == WORST ? worst : row[m].by == RMSE ? sqrt(square) : fabs(sum[0] - sum[1]),
                     off = apart_ / sum[0];
        SHOW(sum[0] > 1e-4 && off >= row[m].least && off <= row[m].most, "%s: %s of %s%s and %s %s: %.1e of %.4f apart",
             of[0], row[m].channel, row[m].set, row[m].own[0], row[m].method[1], row[m].own[1], off, sum[0]);
        for (int k = 0; k < 2; ++k) kit_image_free(&out[k]);
    }
    strike(&s);
}

static void pictures_are_alike(void) { compare(0); }
static void creases_stay(void)       { compare(1); }

/* ---- bent normals and cones -------------------------------------------------------------------------------------- */

/* Makes the last pass of ssbn write mean directions instead of light. */
static int show_bent(kit_run *run)
{
    run->pass[run->passes - 1].desc.light.shading = SSGI_GL_SHADING_BENT;
    return remade(run, run->passes - 1);
}

/* Checks vectors of cones, which are written into the first pass's target: the free directions are a cone. The next
   pass must find its direction, its half-angle and its light. */
static void cones_are_found(void)
{
    enum { SIZE = 32, CONES = 8 };
    static const double plane[1][4] = { { 0, 0, 1, -2 } };
    const kit_camera c = looking_along_z(SIZE, SIZE, 1);
    double worst[3] = { 0 };
    FREED float *vector = malloc(4 * SIZE * SIZE * sizeof *vector), *map = malloc(3 * SIZE * SIZE * sizeof *map),
          *bent = malloc(4 * SIZE * SIZE * sizeof *bent);
    OWN(kit_lighting) l = { 0 };
    OWN(kit_image) frame = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    OWN(kit_run) run = { 0 };
    if (!vector || !map || !bent || !lighten(&l, "sky", NULL) || !walls(&g, &frame, &c, plane, 1, "")
        || !begin(&run, &g, "ssbn-points", "store=float", 0.5f, NULL, &l))
        return;
    glBindFramebuffer(GL_FRAMEBUFFER, run.pass[0].framebuffer);
    glDrawBuffers(1, &(GLenum){ GL_NONE });
    for (int k = 0; k < 2 * CONES; ++k) {
        const double cosine = (double)(k % CONES) / CONES, free_ = 1 - cosine * cosine;
        if (k == CONES && !show_bent(&run)) return;
        if (k < CONES
            && !TRY(ssgi_environment_cone(map, SIZE, run.equirect, l.env.width, l.env.height, (float)cosine, NULL)
                    != SSGI_OK))
            return;
        for (int i = 0; i < SIZE * SIZE; ++i) {
            const int x = i % SIZE, y = i / SIZE;
            /* (x, y): the direction through a texel's centre, or through an edge */
            const float e[2] = { x ? (float)(2 * x + 1) / SIZE - 1 : -1, y || !x ? (float)(2 * y + 1) / SIZE - 1 : -1 };
            float d[3];
            ssgi_octahedral_decode(d, e);
            vector[4 * i] = (float)(free_ * sqrt(pi) / 2);
            for (int j = 0; j < 3; ++j)
                vector[4 * i + 1 + j] = (float)((1 - cosine * cosine * cosine) * sqrt(pi / 3) * (double)d[(j + 1) % 3]);
        }
        glBindTexture(GL_TEXTURE_2D, run.pass[0].target[0]);
        glTexSubImage2D(GL_TEXTURE_2D, 0, 0, 0, SIZE, SIZE, GL_RGBA, GL_FLOAT, vector);
        if (k < CONES) {
            OWN(kit_image) out = { 0 };
            if (!drawn(&out, &run)) return;
            for (int i = 0; i < 3 * SIZE * SIZE; ++i) {
                /* beyond an edge the map continues mirrored */
                const int x = i / 3 % SIZE, y = i / 3 / SIZE, u = x && !y ? SIZE - 1 - x : x, v = x ? y : SIZE - 1 - y;
                const double truth = free_ * 0.5 * ((double)map[i] + (double)map[3 * (v * SIZE + u) + i % 3]);
                worst[0] =
                    fmax(worst[0], fabs((double)out.data[((3 + i % 3) * SIZE + SIZE - 1 - y) * SIZE + x] / truth - 1));
            }
        } else {
            kit_run_draw(&run, 0);
            if (!CHECK(!kit_texture_read(run.pass[1].target[0], SIZE, SIZE, 4, bent), "a target cannot be read"))
                return;
            for (int i = 0; i < SIZE * SIZE; ++i) {
                const double length = sqrt(pow((double)vector[4 * i + 1], 2) + pow((double)vector[4 * i + 2], 2)
                                           + pow((double)vector[4 * i + 3], 2));
                for (int j = 0; j < 3; ++j)
                    worst[1] = fmax(worst[1],
                                    fabs((double)bent[4 * i + (j + 1) % 3] - (double)vector[4 * i + 1 + j] / length));
                worst[2] = fmax(worst[2], fabs((double)bent[4 * i + 3] - cosine));
            }
        }
    }
    SHOW(worst[0] <= 2e-5 && worst[1] <= 1e-6 && worst[2] <= 1e-5,
         "light is off by %.1e of it, directions by %.1e, cosines by %.1e", worst[0], worst[1], worst[2]);
}

/* Checks the floor before a wall: the mean free direction, its cone's cosine, the free share of uniform light. */
static void bent_normals_bend(void)
{
    static const wall walls[2] = { { 0.1, 9, 1, whole }, { 0.25, 9, 1, whole } };
    OWN(kit_lighting) l = { 0 };
    if (!lighten(&l, "white", NULL)) return;
    for (int m = 0; m < ROWS(walls); ++m) {
        double plane[2][4], along[3], v[16], light[4], direction = 0;
        float texel[4 * COLUMNS];
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_run) run = { 0 };
        corner_planes(plane, walls[m].c, 0);
        for (int i = 0; i < 3; ++i) along[i] = -plane[1][i];
        wall_vector(v, &walls[m], plane[0], along);
        if (!slab(&g, walls[m].c, 9, 0, 1)
            || !begin(&run, &g, "ssbn-points",
                      "filtered=coefficients,store=float,thickness=solid,noise=texture,blur=4,directions=64", 1,
                      NULL, &l)
            || !strip_mean(light, &run, &g, row_at(walls[m].c), 4, 2, 1) || !show_bent(&run)
            || !strip(texel, &run, row_at(walls[m].c), 2, 1))
            return;
        const double length = sqrt(v[1] * v[1] + v[2] * v[2] + v[3] * v[3]),
                     mean_length = length / sqrt(3 / (4 * pi)) / (v[0] * 2 * sqrt(pi));
        /* solves 2/3 (1 + c + c^2) / (1 + c) = mean_length for the cosine c */
        const double q = 1.5 * mean_length - 1, cosine = 0.5 * (q + sqrt(q * q + 4 * q));
        for (int j = 0; j < 3; ++j) direction += (double)texel[j] * v[1 + (j + 2) % 3] / length;
        const double off[3] = { acos(fmin(1, direction)), (double)texel[3] - cosine, light[0] - v[0] / 0.886226925 };
        SHOW(off[0] <= 0.02 && fabs(off[1]) <= 0.02 && fabs(off[2]) <= 0.003,
             "c %g: the direction is off by %.4f, the cosine %.4f by %+.4f, light by %+.4f", walls[m].c, off[0], cosine,
             off[1], off[2]);
    }
}

/* ---- light that varies ------------------------------------------------------------------------------------------- */

/* Writes GLSL that returns harmonics [3*i + c], and so many times these beyond x = 0. */
static void hook(char *text, size_t size, const float *light, int count, double more)
{
    size_t n = (size_t)snprintf(text, size, "const vec3 mine[%d] = vec3[%d](", count, count);
    for (int i = 0; i < 3 * count; i += 3)
        n += (size_t)snprintf(text + n, size - n, "%svec3(%.9f, %.9f, %.9f)", i ? ", " : "", (double)light[i],
                              (double)light[i + 1], (double)light[i + 2]);
    snprintf(text + n, size - n,
             ");\nvec3 ssgi_custom_harmonic(int i, vec3 p) { return mine[i] * (p.x > 0.0 ? %.3f : 1.0); }", more);
}

/* Checks the user's own function of harmonics: those of frame.harmonics on one side of the eye, twice those on the
   other. The light must be equal and double: in the gather, in pass shade and where blur restores. */
static void light_varies(void)
{
    static const struct { const char *method, *set; int bands;
    } row[] = { { "ssdo-points", "bounce=none,environment=sh", 3 },
                { "ssdo", "bounce=none,environment=sh,blur=1,restore=ratio,bands=1", 1 },
                { "s3ho-points", "indirect=joint,filtered=light,blur=1,restore=difference", 4 },
                { "s3ho-points", "indirect=none,filtered=coefficients,bands=2", 2 } };
    OWN(scenery) s = { 0 };
    float light[48], view[16], projection[16];
    double worst = 0;
    some_light(light);
    if (!set_scene(&s, "room", NULL, "sky", NULL, W, H)) return;
    kit_camera_matrices(&s.g.camera, view, projection);
    for (int m = 0; m < ROWS(row); ++m) {
        kit_image out[2];
        for (int own = 0; own < 2; ++own) {
            OWN(kit_run) run = { 0 };
            char text[2048];
            if (!begin(&run, &s.g, row[m].method, row[m].set, s.scene.radius, &s.scene, &s.light)) return;
            if (own) memset(run.frame.harmonics, 0, sizeof run.frame.harmonics);
            else ssgi_gl_harmonics_set(&run.frame, light, row[m].bands, view, NULL);
            hook(text, sizeof text, light, row[m].bands * row[m].bands, 2);
            for (int i = 0; i < run.passes && own; ++i) {
                run.pass[i].desc.light.harmonics = SSGI_GL_HARMONICS_CUSTOM;
                run.pass[i].desc.shader.fetch = text;
                if (!remade(&run, i)) return;
            }
            if (!drawn(&out[own], &run)) return;
        }
        const float *const is = kit_image_channel(&out[0], "irradiance.R"),
                    *const of_own = kit_image_channel(&out[1], "irradiance.R");
        for (int i = 0; i < 3 * W * H; ++i)
            if (abs(i % W - W / 2) > 4)                    /* not near the edge, where the filter mixes both sides */
                worst = fmax(worst, fabs((double)of_own[i] - (i % W * 2 + 1 > W ? 2 : 1) * (double)is[i]));
        SHOW(worst < 4e-5 && mean(&out[0], "irradiance.G") > 0.5, "%s %s: %.1e off", row[m].method, row[m].set, worst);
        for (int k = 0; k < 2; ++k) kit_image_free(&out[k]);
    }
}

void test_coefficients(void)
{
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("a wall's vector is its expectation, whatever the samples, layers and fading", walls_block);
    RUN("what slices block of light that has a direction is what comes from there", slices_know_directions);
    RUN("a wall reflects its own lobe, times its albedo", walls_reflect);
    RUN("emitters reflect what the last frame let through to them", emitters_are_dimmed);
    RUN("what a gather reads of the last frame is what its filter wrote", filtered_sets_are_left);
    RUN("what faces a sun, a point light, a sphere gets its irradiance; what turns away its window's",
        lamps_light_what_faces_them);
    RUN("what is open gets exactly what comes in, however few the bands", open_is_exact);
    RUN("ssdo's harmonics are s3ho's, filtered and lit is lit and filtered, a bounce is itself", pictures_are_alike);
    RUN("creases stay sharp where nothing is occluded, with the default filters", creases_stay);
    RUN("cones that are free are found again, with their light", cones_are_found);
    RUN("bent normals point where it is free", bent_normals_bend);
    RUN("light may be your own function of the place", light_varies);
    kit_gl_close();
}
