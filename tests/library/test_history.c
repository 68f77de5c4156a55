/* test_history.c - pictures over frames: scripted sequences with known answers, noise, motion, hostile history. */
#include "t.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static kit_error err;

/* ---- scripted sequences with known counts in each frame ------------------------------------------------------- */

enum { W = 96, H = 54 };

static kit_pass *pass_of(kit_run *run, int pass)
{
    kit_pass *p = run->pass;
    while (p->desc.pass != pass) ++p;
    return p;
}

/* Checks a script that changes the light of an open plane, filtered without noise. The result is a mean over at most
   `most` frames, held near a mean over three, and that near the present value. The mean that has to be moved forgets
   frames. Frames of uneven length count by their time. */
static void light_is_followed(void)
{
    enum { FRAMES = 20 };
    static const double took[5] = { 1, 1, 4, 0.5, 2 }; /* how long each frame takes, in 60ths of a second */
    static const struct { const char *name; double from, to, by; int uneven; } row[] = {
        { "steady", 1, 1, 1, 0 }, { "brighter at once", 1, 3, 1, 0 }, { "darker at once", 1, 0.4, 1, 0 },
        { "a little brighter", 1, 1.012, 1, 0 }, { "rising", 1, 1, 1.01, 0 }, { "falling", 1, 1, 0.985, 0 },
        { "rising, uneven", 1, 1, 1.002, 1 } };
    static const double plane[1][4] = { { 0.3, 0.2, 0.932738, -2 } };
    const kit_camera c = looking_along_z(W, H, 0);
    OWN(kit_image) frame = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    OWN(kit_lighting) white = { 0 };
    OWN(kit_run) run = { 0 };
    double worst = 0;
    if (!lighten(&white, "white", NULL) || !walls(&g, &frame, &c, plane, 1, "")
        || !begin(&run, &g, "ssdo", "environment=sh,bands=1,bounce=none,history=1,restore=none,blur=1,slices=1,"
                  "samples=4", 0.3f, NULL, &white))
        return;
    for (int i = 0; i < ROWS(row); ++i) {
        double mean_ = 0, quick = 0, frames = 0, v = row[i].from;
        for (unsigned t = 0; t < FRAMES; ++t) {
            OWN(kit_image) out = { 0 };
            v = t == 12 ? row[i].to : v * row[i].by;
            if (!t) run.frame.history_frames = 0;
            else if (!TRY(kit_run_follow(&run, &run, t, &err))) return;
            /* from five frames on the filter averages five texels instead of nine, and trusts them less */
            const double now = row[i].uneven ? took[t % 5] : 1, last = row[i].uneven ? took[(t + 4) % 5] : 1;
            if (t && !CHECK(ssgi_gl_frame_time(&run.frame, 16 / 60.0f, (float)(now / 60), (float)(last / 60), NULL)
                            == SSGI_OK, "a time is refused"))
                return;
            const double most = 16 / now, n = t ? fmin(frames * last / now + 1, most) : 1,
                         few = n < 4.5 ? 1 : 9.0 / 5, deviation = 0.1 * v * sqrt((few - 1) * few),
                         drift = 0.2 * deviation + 0.005 * v,
                         jump = 0.7 * deviation + 0.02 * v;
            const float uniform[3] = { (float)(v * 3.5449077), (float)(v * 3.5449077), (float)(v * 3.5449077) };
            ssgi_gl_harmonics_set(&run.frame, uniform, 1, NULL, NULL);
            if (!drawn(&out, &run)) return;
            quick = fmin(fmax(quick + (v - quick) / fmin(n, 3), v - jump), v + jump);
            mean_ += (v - mean_) / n;
            const double by = fmin(fmax(mean_, quick - drift), quick + drift) - mean_;
            frames = fmax(n * (1 - 0.85 * fmin(fabs(by) / drift, 1)), 1);
            mean_ += by;
            const float *seen = kit_image_channel(&out, "irradiance.G");
            double off = 0;
            for (int p = 0; p < W * H; ++p)
                if (flat(&frame, p % W, p / W)) off = fmax(off, fabs((double)seen[p] / mean_ - 1));
            worst = fmax(worst, off);
            CHECK(off < 1e-3, "%s, frame %u: %.4f of the light is shown, %.4f expected, %.4f there is", row[i].name, t,
                  (double)seen[H / 2 * W + W / 2], mean_, v);
        }
    }
    t_note("%.1e of the light off at most", worst);
}

/* A sequence of frames drawn by a method, and the last two G-buffers. */
typedef struct sequence { kit_frames frames; kit_gbuffer g[2]; kit_method method; } sequence;

/* Draws the next frame from a picture, and frees the picture. */
static int next_frame(sequence *s, kit_image *picture, const kit_camera *c)
{
    const kit_world world = { NULL, NULL };
    kit_gbuffer *const g = &s->g[s->frames.number & 1];
    kit_gbuffer_free(g);
    if (!TRY(kit_gbuffer_from_frame(g, picture, c, &err))
        || !TRY(kit_frames_next(&s->frames, g, &s->method, 0.3f, &world, NULL, &err)))
        return 0;
    kit_run_draw(s->frames.now, 0);
    kit_image_free(picture);
    return 1;
}

static int begin_frames(sequence *s, const char *set)
{
    memset(s, 0, sizeof *s);
    return TRY(kit_method_find(&s->method, "hsao", &err)) && TRY(kit_method_set(&s->method, set, &err));
}

static void end_frames(sequence *s)
{
    kit_frames_close(&s->frames);
    for (int k = 0; k < 2; ++k) kit_gbuffer_free(&s->g[k]);
}

/* Reads how many frames each pixel of the last picture averages. */
static int frames_kept(float kept[W * H], kit_run *run)
{
    static float texel[4 * W * H];
    const kit_pass *p = pass_of(run, SSGI_GL_PASS_HISTORY);
    if (!CHECK(p->width * p->height <= W * H && !kit_texture_read(p->target[0], p->width, p->height, 4, texel),
               "the history's textures cannot be read"))
        return 0;
    for (int i = 0; i < p->width * p->height; ++i) kept[i] = texel[4 * i + 3];
    return 1;
}

/* Writes the expected counts of a frame that moved by dx, dy from one of another size: a pixel interpolates the counts
   of four pixels around its last place. The count is at most 16, and lower the farther the place is from a centre. Up
   to a pixel beyond the border it counts as at the border, up to a hundredth from a centre as at the centre. */
static void count(float kept[W * H], const int size[2], const int was[2], double dx, double dy)
{
    static float last[W * H];
    memcpy(last, kept, sizeof last);
    for (int i = 0; i < size[0] * size[1]; ++i) {
        const double x = (i % size[0] - dx + 0.5) * was[0] / size[0] - 0.5,
                     y = (i / size[0] - dy + 0.5) * was[1] / size[1] - 0.5,
                     u = fmin(fmax(1.02 * (x - floor(x)) - 0.01, 0), 1),
                     v = fmin(fmax(1.02 * (y - floor(y)) - 0.01, 0), 1);
        double sum = 0;
        kept[i] = 1;
        if (x <= -1.5 || y <= -1.5 || x >= was[0] + 0.5 || y >= was[1] + 0.5) continue;
        for (int k = 0; k < 4; ++k) {
            const int p = (int)floor(x) + (k & 1), q = (int)floor(y) + k / 2;
            sum += (k & 1 ? u : 1 - u) * (k / 2 ? v : 1 - v)
                   * (double)last[(q < 0 ? 0 : q < was[1] ? q : was[1] - 1) * was[0]
                                  + (p < 0 ? 0 : p < was[0] ? p : was[0] - 1)];
        }
        kept[i] = (float)fmin(sum + 1, 16 / (1 + 2 * (u * (1 - u) + v * (1 - v))));
    }
}

/* Checks how many frames each pixel averages while a camera over an open plane stands, turns or jumps. A bar appears:
   pixels forget where the bar fills a share of the space within the radius. told: motion vectors say that all stands
   (1), or the motion that the camera's turn otherwise gives (2). */
static void frames_are_counted(void)
{
    enum { FRAMES = 18, BAR = 40, ACROSS = 16, FAR_ = 30 };
    static const int sizes[4][2] = { { W, H }, { 64, 36 }, { 48, 27 }, { 80, 45 } };
    static const struct { const char *name; double x, y; int cut, bar, resized, jitter, told; float away; } row[] = {
        { "a still camera", 0, 0, FRAMES, 0, 0, 0, 0, 0 },
        { "a turn by whole pixels", 3, -2, FRAMES, 0, 0, 0, 0, 0 },
        { "the same from afar", 3, -2, FRAMES, 0, 0, 0, 0, 1e5f },
        { "a turn by half a pixel both ways", 0.5, -0.5, FRAMES, 0, 0, 0, 0, 0 },
        { "a cut", 0, 0, 13, 0, 0, 0, 0, 0 },
        { "a bar that comes", 0, 0, FRAMES, 1, 0, 0, 0, 0 },
        { "pictures of four sizes in turn", 0, 0, FRAMES, 0, 1, 0, 0, 0 },
        { "the same, and motion vectors of what stands", 0, 0, FRAMES, 0, 1, 0, 1, 0 },
        { "a projection that trembles", 0.4, -0.3, FRAMES, 0, 0, 1, 0, 0 },
        { "the same, and motion vectors leave it out", 0.4, -0.3, FRAMES, 0, 0, 1, 1, 0 },
        { "motion vectors by two and a half pixels", 2.5, -1, FRAMES, 0, 0, 0, 2, 0 } };
    for (int i = 0; i < ROWS(row); ++i) {
        const double plane[1][4] = { { 0, 0, 1, -4 - (double)row[i].away } };
        static sequence s;
        static float kept[W * H], expected[W * H];
        if (!begin_frames(&s, "resolution=full,slices=1,samples=33,blur=1,history=1")) return;
        for (int t = 0; t < FRAMES; ++t) {
            const int *const size = sizes[row[i].resized * t % 4], *const was = sizes[row[i].resized * (t + 3) % 4];
            kit_camera c = looking_along_z(size[0], size[1], 1);
            kit_image frame;
            const int jitter = row[i].jitter, went = jitter ? t & 1 : t;
            c.eye[2] = row[i].away;
            c.target[2] = row[i].away - 1;
            c.znear += 0.9f * row[i].away;
            c.zfar += 4 * row[i].away;
            if (row[i].told < 2) { c.shift[0] = (float)(row[i].x * went); c.shift[1] = (float)(row[i].y * went); }
            s.frames.jittered = jitter;
            if (!planes_seen(&frame, &c, plane, 1, row[i].told ? ",motion.X,motion.Y" : "")) return;
            for (int p = 0; p < W * H && row[i].told > 1; ++p) {
                kit_image_channel(&frame, "motion.X")[p] = (float)row[i].x;
                kit_image_channel(&frame, "motion.Y")[p] = (float)-row[i].y;
            }
            for (int p = 0; p < W * H && row[i].bar && t == FRAMES - 1; ++p)
                if (p % W >= BAR && p % W < BAR + ACROSS) frame.data[p] = 3.8f;
            if (t == row[i].cut) kit_frames_close(&s.frames);
            if (!next_frame(&s, &frame, &c)) return;
            if (t && t != row[i].cut) count(expected, size, was, jitter ? 0 : row[i].x, jitter ? 0 : row[i].y);
            else for (int p = 0; p < W * H; ++p) expected[p] = 1;
        }
        if (!frames_kept(kept, s.frames.now)) return;
        int wrong = 0, anew = 0, on = 0;
        const kit_pass *const drawn_by = pass_of(s.frames.now, SSGI_GL_PASS_HISTORY);
        for (int p = 0; p < drawn_by->width * drawn_by->height; ++p) {
            const int x = p % W;
            /* half a pixel beyond the border, rounding decides whether the last picture has the place; if not, one
               frame less */
            const float off = expected[p] - kept[p];
            wrong += !row[i].bar && !(fabsf(off) < 0.02f || (row[i].x > 1 && fabsf(off - 1) < 0.02f));
            anew += row[i].bar && x >= BAR && x < BAR + ACROSS && kept[p] < 1.001f;
            on += row[i].bar && (x < BAR - FAR_ || x >= BAR + ACROSS + FAR_) && kept[p] > 15.999f;
        }
        CHECK(!wrong && (!row[i].bar || (anew == ACROSS * H && on == (W - ACROSS - 2 * FAR_) * H)),
              "%s: %d pixels average other numbers of frames; %d of the bar begin anew, %d far from it go on; in the "
              "middle it is %g", row[i].name, wrong, anew, on, (double)kept[H / 2 * W + W / 2]);
        end_frames(&s);
    }
}

/* Checks that a bar leaves no trail on a floor: once it is farther away than the radius, all is open at once. */
static void nothing_trails(void)
{
    enum { FRAMES = 14, WIDE_ = 14, STEP = 4 };
    static const double plane[1][4] = { { 0, 0, 1, -4 } };
    const kit_camera c = looking_along_z(W, H, 1);         /* 2 units high: a radius of 0.3 is 8.1 pixels */
    static sequence s;
    double behind[3] = { 1, 1, 1 }, beside = 1;
    if (!begin_frames(&s, "resolution=full,slices=4,samples=33,blur=1,history=1")) return;
    for (int t = 0; t < FRAMES; ++t) {
        OWN(kit_image) frame = { 0 }, out = { 0 };
        const int left = STEP * t;
        if (!planes_seen(&frame, &c, plane, 1, "")) return;
        for (int p = 0; p < W * H; ++p) if (p % W >= left && p % W < left + WIDE_) frame.data[p] = 3.75f;
        if (!next_frame(&s, &frame, &c) || !TRY(kit_run_read(&out, s.frames.now, &err))) return;
        for (int p = 0; p < W * H && t > 6; ++p) {
            const int gap = left - 1 - p % W;              /* pixels between this place and the bar that has passed */
            if (gap >= 0 && gap < 3) beside = fmin(beside, (double)out.data[p]);
            for (int k = 0; k < 3; ++k)                    /* for k frames so far beyond the radius and the filter */
                if (gap >= 11 + k * STEP && gap < 11 + (k + 1) * STEP) behind[k] = fmin(behind[k], (double)out.data[p]);
        }
    }
    SHOW(beside < 0.9 && behind[0] > 0.999 && behind[1] > 0.999 && behind[2] > 0.999,
         "beside the bar %.3f is open, where it has gone %.4f, %.4f, %.4f", beside, behind[0], behind[1], behind[2]);
    end_frames(&s);
}

/* Checks that a camera that glides past solids forgets little: depths differ at edges, but nothing appears. */
static void little_is_forgotten(void)
{
    enum { FRAMES = 8 };
    static sequence s;
    static float kept[W * H];
    OWN(kit_scene) scene = { 0 };
    double frames = 0;
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err))
        || !begin_frames(&s, "resolution=full,slices=1,samples=33,blur=1,history=1"))
        return;
    const kit_world world = { &scene, NULL };
    scene.camera.width = W;
    scene.camera.height = H;
    for (int t = 0; t < FRAMES; ++t) {
        kit_gbuffer *const g = &s.g[s.frames.number & 1];
        scene.camera.eye[0] += 0.06f;
        scene.camera.target[0] += 0.06f;
        kit_gbuffer_free(g);
        if (!TRY(kit_gbuffer_from_scene(g, &scene, &scene.camera, NULL, &err))
            || !TRY(kit_frames_next(&s.frames, g, &s.method, scene.radius, &world, NULL, &err)))
            return;
        kit_run_draw(s.frames.now, 0);
    }
    if (!frames_kept(kept, s.frames.now)) return;
    for (int p = 0; p < W * H; ++p) frames += (double)kept[p] / (W * H);
    SHOW(frames > 5.5, "of %d frames a pixel averages %.2f", FRAMES, frames);
    end_frames(&s);
}

/* ---- noise, motion, hostile input ------------------------------------------------------------------------------- */

/* Opens a run of a method on a built-in scene at a small size. */
static int seen_as(kit_run *run, kit_gbuffer *g, const kit_scene *scene, const kit_lighting *lighting, int width,
                   const char *name, const char *set)
{
    kit_camera c = scene->camera;
    c.width = width;
    c.height = width * 9 / 16;
    return TRY(kit_gbuffer_from_scene(g, scene, &c, NULL, &err))
        && open_run(run, g, name, set, scene->radius, scene, lighting);
}

/* Compares the difference between two single frames with other noise with that between two means over sixteen such
   frames. Then checks a cut. */
static void history_is_quiet(void)
{
    enum { FIRST = 100 };                                  /* the number of the first of the second sixteen frames */
    static const struct { const char *method, *set; double alone, kept; } kept[] = {
        { "hsao-fast", "history=1", 0.027, 0.012 }, { "hsao", "resolution=full,history=1", 0.015, 0.0026 },
        { "hsao-fast", "resolution=quarter,slices=2,history=1", 0.036, 0.013 },
        { "ssdo-fast", "samples=6,history=1", 0.0165, 0.0088 },
        { "s3ho-fast", "history=1", 0.0175, 0.01 },
        { "hsao-fast", "thickness=slabs,history=1", 0.0275, 0.0123 },
        { "hsao-march", "views=1,directions=2,samples=4,history=1", 0.028, 0.0058 } };
    OWN(kit_lighting) lighting = { 0 };
    OWN(kit_scene) scene = { 0 };
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err)) || !TRY(kit_env_read(&lighting.env, "sky", &err))) return;
    for (size_t i = 0; i < sizeof kept / sizeof *kept; ++i) {
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_run) run = { 0 };
        kit_image first[2], last[2], cut;
        double noise[2];
        if (!seen_as(&run, &g, &scene, &lighting, 96, kept[i].method, kept[i].set)) return;
        for (unsigned turn = 0; turn < 2; ++turn) {
            for (unsigned k = 0; k < 16 && TRY(kit_frames_still(&run, FIRST * turn, k, 0, &err)); ++k)
                if (!k && !TRY(kit_run_read(&first[turn], &run, &err))) return;
            if (!TRY(kit_run_read(&last[turn], &run, &err))) return;
        }
        noise[0] = difference(&first[0], &first[1]);
        noise[1] = difference(&last[0], &last[1]);
        SHOW(noise[0] > 0.003 && noise[0] < kept[i].alone && noise[1] < kept[i].kept,
             "%s %s: noise of %.4f becomes %.4f", kept[i].method, kept[i].set, noise[0], noise[1]);
        run.frame.history_frames = 0;
        run.frame.phase = 0;
        kit_run_update(&run);
        kit_run_draw(&run, 0);
        TRY(kit_run_read(&cut, &run, &err));
        CHECK(!memcmp(cut.data, first[0].data, (size_t)(cut.width * cut.height) * sizeof *cut.data),
              "%s: the first frame after a cut is not a single one", kept[i].method);
        kit_image *const all[] = { &first[0], &first[1], &last[0], &last[1], &cut };
        for (int k = 0; k < 5; ++k) kit_image_free(all[k]);
    }
}

/* Returns the texture that a pass reads by this name. */
static GLuint *read_as(kit_pass *p, const char *name)
{
    for (int k = 0; k < p->step->inputs; ++k) if (!strcmp(p->step->input[k].name, name)) return &p->input[k];
    return NULL;
}

static const float odd[] = { NAN, INFINITY, -INFINITY, 0, -1, 1e38f, -1e38f, 1e9f, 1e-30f, 0.5f, 1, 3, 528 };
enum { ODD = ROWS(odd) };

/* Damages a copy of a pass's texture. Below ANYTHING: one lane of every third texel has a value, and the other lanes,
   depth too, are right. From ANYTHING on: all lanes are random, of one kind or mixed. */
enum { ANYTHING = 4 };
static GLuint poisoned(const kit_pass *p, GLuint texture, int lane, float value, unsigned seed)
{
    const size_t texels = (size_t)p->width * (size_t)p->height;
    float *const texel = malloc(4 * texels * sizeof *texel);
    GLuint copy = 0;
    if (CHECK(!kit_texture_read(texture, p->width, p->height, 4, texel), "no texture to poison")) {
        t_seed(seed);
        for (size_t i = 0; i < 4 * texels && lane == ANYTHING; ++i)
            texel[i] = seed < ODD ? odd[seed] : t_below(4) ? odd[t_below(ODD)] : (float)t_below(1000) * 0.01f;
        for (size_t i = 0; i < texels && lane < ANYTHING; i += 3) texel[4 * i + (size_t)lane] = value;
        copy = kit_texture(p->width, p->height, GL_RGBA32F, texel);
    }
    free(texel);
    return copy;
}

/* Checks history with bad texels: a frame in which a lane is NaN or infinity and depths are right, for each kind of
   restoring; then a hundred frames with random values, depth too. All frames must be finite and in range, and after a
   few sound frames nothing of it may be left. */
static void hostile_history(void)
{
    static const struct { const char *method, *set; } kept[] = {
        { "hsao-fast", "history=1" }, { "ssdo-fast", "bounce=none,history=1,restore=none" },
        { "ssdo-fast", "bounce=none,history=1,restore=ratio" },
        { "ssdo-fast", "bounce=none,history=1,restore=difference" },
        { "s3ho-fast", "indirect=joint,history=1,restore=difference" } };
    /* name NULL: the texture of this frame's visibility or light. The first row is sound, for comparison. */
    static const struct { const char *name; int lane; float value; unsigned frames; } poison[] = {
        { "none", 0, 0, 0 }, { "t_ssgi_history", 0, NAN, 1 }, { "t_ssgi_history", 0, INFINITY, 1 },
        { "t_ssgi_history", 2, NAN, 1 }, { "t_ssgi_history", 3, NAN, 1 }, { "t_ssgi_means", 0, NAN, 1 },
        { "t_ssgi_means", 1, NAN, 1 }, { "t_ssgi_means", 0, -INFINITY, 1 }, { "t_ssgi_motion", 0, NAN, 1 },
        { "t_ssgi_motion", 1, INFINITY, 1 }, { NULL, 0, NAN, 1 }, { NULL, 0, -INFINITY, 1 },
        { "t_ssgi_history", ANYTHING, 0, 100 } };
    enum { BEFORE = 3, AFTER = 6 };
    OWN(kit_lighting) lighting = { 0 };
    OWN(kit_scene) scene = { 0 };
    if (!TRY(kit_scene_load(&scene, "casters", 0, &err)) || !lighten(&lighting, "sky", NULL)) return;
    scene.camera.width = 48;
    scene.camera.height = 27;
    for (int m = 0; m < ROWS(kept); ++m) {
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_run) run = { 0 };
        OWN(kit_image) sound = { 0 };
        double left = 0;
        const int grey = !strcmp(kept[m].method, "hsao-fast");
        if (!TRY(kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err))) return;
        g.motion = kit_texture(g.width, g.height, GL_RG32F, NULL);             /* nothing moves */
        if (!open_run(&run, &g, kept[m].method, kept[m].set, scene.radius, &scene, &lighting)) return;
        kit_pass *const p = pass_of(&run, SSGI_GL_PASS_HISTORY);
        for (int i = 0; i < ROWS(poison); ++i) {
            const char *const of = poison[i].name ? poison[i].name : grey ? "t_ssgi_ao" : "t_ssgi_light";
            const unsigned last = BEFORE + poison[i].frames + AFTER;
            int bad = 0;
            run.frame.history_frames = 0;
            run.frame.phase = 0;
            kit_run_update(&run);
            kit_run_draw(&run, 0);
            for (unsigned f = 1; f <= last; ++f) {
                GLuint copy[3] = { 0 }, was[3] = { 0 }, *at[3] = { NULL };     /* textures; grey methods lack means */
                kit_image out;
                TRY(kit_run_follow(&run, &run, 200 - last + f, &err));         /* the last frames have one noise */
                if (f >= BEFORE && f < BEFORE + poison[i].frames) {
                    at[0] = read_as(p, of);
                    if (poison[i].lane == ANYTHING) {
                        at[1] = read_as(p, "t_ssgi_means");
                        at[2] = read_as(pass_of(&run, SSGI_GL_PASS_CHANGE_MASK), of);
                    }
                }
                for (int k = 0; k < 3; ++k) {
                    if (!at[k]) continue;
                    was[k] = *at[k];                       /* 0: the G-buffer's */
                    *at[k] = copy[k] = poisoned(p, was[k] ? was[k] : g.motion, poison[i].lane, poison[i].value, f);
                }
                kit_run_draw(&run, 0);
                for (int k = 0; k < 3; ++k) if (at[k]) *at[k] = was[k];
                glDeleteTextures(3, copy);
                if (!TRY(kit_run_read(&out, &run, &err))) return;
                for (int k = 0; k < out.channels * out.width * out.height; ++k)
                    bad += grey ? !(out.data[k] >= 0 && out.data[k] < 1.001f) : !(fabsf(out.data[k]) < 1e10f);
                if (f == last && !i) { sound = out; continue; }
                if (f == last) left = fmax(left, difference(&out, &sound));
                kit_image_free(&out);
            }
            CHECK(!bad, "%s %s: %s %d %g: %d values are none, or none that can be", kept[m].method, kept[m].set, of,
                  poison[i].lane, (double)poison[i].value, bad);
        }
        SHOW(left < 0.03, "%s %s: %.4f is left of it after %d sound frames", kept[m].method, kept[m].set, left, AFTER);
    }
}

/* Checks a frame's data on the last frame: it follows size, jitter and field of view. */
static void last_frames(void)
{
    /* footprint: the width of a pixel of the last frame in this frame's pixels, at least 1 */
    static const struct { int width, height; double footprint; } sizes[] = { { 256, 144, 1 }, { 96, 18, 1.757404 },
                                                                             { 64, 36, 1 } };
    const kit_camera c = looking_along_z(64, 36, 0);
    kit_camera other = c;
    const char *why = "";
    float now[16], then[16], projection[16];
    ssgi_view view, last;
    ssgi_gl_frame frame;
    other.eye[0] = 0.2f;
    other.target[0] = 0.1f;
    other.fovy = 40;
    other.shift[0] = 0.3f;
    kit_camera_matrices(&c, now, projection);
    if (!view_of(&view, &c, 0)) return;
    CHECK(ssgi_gl_frame_init(&frame, &view, 1, &why) == SSGI_OK && !(frame.history_frames > 0),
        "the first has a last one");
    for (int k = 0; k < ROWS(sizes); ++k) {
        other.width = sizes[k].width;
        other.height = sizes[k].height;
        kit_camera_matrices(&other, then, projection);
        CHECK(view_of(&last, &other, 0) && ssgi_gl_frame_history(&frame, &last, now, then, &why) == SSGI_OK
                  && frame.history_frames == 16 && (int)frame.last_size[0] == other.width
                  && (int)frame.last_size[1] == other.height
                  && fabs((double)frame.last_footprint / sizes[k].footprint - 1) < 1e-5,
              "of another size: %s; %d x %d, pixels %.6f times as wide", why, (int)frame.last_size[0],
              (int)frame.last_size[1], (double)frame.last_footprint);
    }
    for (int i = 0; i < 8; ++i) {                          /* one point through both cameras and back */
        const double p[3] = { 0.3 * (i & 1), 0.2 * (i & 2), -3.0 - i };
        double to[3], v[3], at[2];
        for (int r = 0; r < 3; ++r) {
            to[r] = (double)frame.last_to[12 + r];
            v[r] = (double)then[12 + r];
            for (int k = 0; k < 3; ++k) to[r] += (double)frame.last_to[4 * k + r] * p[k];
            for (int k = 0; k < 3; ++k) v[r] += (double)then[4 * k + r] * p[k];     /* the first camera is the world */
        }
        for (int k = 0; k < 2; ++k) at[k] = v[k] / -v[2] * (double)last.project[k] + (double)last.project[2 + k];
        CHECK(fabs(to[0] / to[2] - at[0]) + fabs(to[1] / to[2] - at[1]) < 1e-3, "%g %g is at %g %g", at[0], at[1],
              to[0] / to[2], to[1] / to[2]);
        for (int r = 0; r < 3; ++r) {
            const double back = (double)frame.last_from[r] * to[0] + (double)frame.last_from[4 + r] * to[1]
                + (double)frame.last_from[8 + r] * to[2] + (double)frame.last_from[12 + r];
            CHECK(fabs(back - p[r]) < 1e-3, "%g comes back as %g", p[r], back);
        }
    }
    CHECK(ssgi_gl_frame_time(&frame, 1e-30f, 1e18f, 1e-30f, &why) == SSGI_OK && frame.pace > 0
        && frame.history_frames >= 1,
          "a frame that took for ever: pace %g", (double)frame.pace);
}

void test_history(void)
{
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("light that steps, rises and falls is followed as its recurrence says", light_is_followed);
    RUN("frames are counted while a camera turns by whole and half pixels, after a cut, where a bar comes, at other "
        "sizes, under jitter",
        frames_are_counted);
    RUN("a bar that passes leaves no trail", nothing_trails);
    RUN("a camera that glides past solids forgets little", little_is_forgotten);
    RUN("frames of NaN at depths that are right, and a hundred of anything, leave no trace, whatever is restored",
        hostile_history);
    RUN("a last frame is where both cameras say, of whatever size", last_frames);
    RUN("over sixteen frames noise falls; the first after a cut is a single one", history_is_quiet);
    kit_gl_close();
}
