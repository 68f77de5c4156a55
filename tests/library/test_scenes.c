/* test_scenes.c - named scenes whose answer is a closed form or a sum over directions, drawn by several methods; and
   changes that must not change a picture, for all methods. */
#include "t.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;

/* Writes direction i of side x side, distributed by the cosine about +z. */
static void lobe(double d[3], int i, int side)
{
    const double z = sqrt((i / side + 0.5) / side), a = 2 * pi * (i % side + 0.5) / side, r = sqrt(1 - z * z);
    d[0] = r * cos(a);
    d[1] = r * sin(a);
    d[2] = z;
}

/* ---- bars over a floor, endless sideways, radius 1 --------------------------------------------------------------- */

/* A bar's extents: y along the floor, away from the viewer, and h above it. */
typedef struct bar { double y[2], h[2]; } bar;
/* from: the angle between the view and straight down. upper: how far the picture extends up from the receiver. */
typedef struct profile { double from, upper; int bars; bar bar[6]; } profile;

static const profile a_plate = { 45, 9, 1, { { { 0.2, 0.6 }, { 0.4, 0.5 } } } },
                     a_hidden_plate = { 45, 9, 2, { { { 0.2, 0.6 }, { 0.4, 0.5 } }, { { 0.5, 0.8 }, { 0.15, 0.2 } } } },
                     two_cards = { 45, 9, 2, { { { 0.15, 0.5 }, { 0.45, 0.46 } }, { { 0.3, 0.7 }, { 0.2, 0.21 } } } },
                     a_fence = { 0, 9, 6, { { { -0.7, -0.6 }, { 0.3, 0.31 } }, { { -0.5, -0.4 }, { 0.3, 0.31 } },
                                            { { -0.3, -0.2 }, { 0.3, 0.31 } }, { { 0.2, 0.3 }, { 0.3, 0.31 } },
                                            { { 0.4, 0.5 }, { 0.3, 0.31 } }, { { 0.6, 0.7 }, { 0.3, 0.31 } } } };
/* The profile of a card that leaves the picture by less and less. Its middle is at 0.354 upward from the receiver. */
#define LEAVING(upper) { 45, upper, 1, { { { 0.1, 0.4 }, { 0.24, 0.26 } } } }
static const profile leaving[5] = { LEAVING(0.2), LEAVING(0.3), LEAVING(0.4), LEAVING(0.6), LEAVING(9) };

/* Finds where a line from y, h along dy, dh enters and leaves a bar; 0: it misses. edge: 1 if through a side. */
static int crosses(const bar *p, double y, double h, double dy, double dh, double t[2], int *edge)
{
    const double a = (p->y[0] - y) / dy, b = (p->y[1] - y) / dy, c = (p->h[0] - h) / dh, d = (p->h[1] - h) / dh;
    t[0] = fmax(fmin(a, b), fmin(c, d));
    t[1] = fmin(fmax(a, b), fmax(c, d));
    *edge = fmin(a, b) > fmin(c, d);
    return t[0] < t[1] && t[0] > 0;
}

/* Returns the share of directions that bars block, falling off with distance. Beyond the picture nothing blocks. */
static double blocked(const profile *p)
{
    enum { N = 500 };
    const double a = p->from * pi / 180;
    double sum = 0;
    for (int i = 0; i < N * N; ++i) {
        double d[3], t[2], nearest = 1;
        int side;
        lobe(d, i, N);
        for (int k = 0; k < p->bars; ++k)
            if (crosses(&p->bar[k], 0, 0, d[0], d[2], t, &side) && t[0] * (d[0] * cos(a) + d[2] * sin(a)) < p->upper)
                nearest = fmin(nearest, t[0]);
        sum += 1 - nearest;
    }
    return sum / ((double)N * N);
}

/* Makes the G-buffer of a profile, with bars of radiance 1, 0.5, 0.5. The receiver is at the middle of a row, whose
   number is returned; 0: failed. */
static int profile_seen(kit_gbuffer *g, const profile *p)
{
    kit_camera camera = looking_along_z(WIDE, HIGH, 1);
    const double a = p->from * pi / 180 + 1e-6, s = sin(a), c = cos(a), pixel = sqrt(0.5) / SPAN;
    const int at = p->upper < 9 ? HIGH - 1 - (int)(p->upper / pixel) : HIGH / 2;
    OWN(kit_image) frame = { 0 };
    camera.ortho_height = (float)(HIGH * pixel);
    if (!TRY(kit_image_new(&frame, WIDE, HIGH, "Z,N.X,N.Y,N.Z,back.Z,front2.Z,back2.Z,direct.R,direct.G,direct.B",
                           &err)))
        return 0;
    for (int row = 0; row < HIGH; ++row) {
        /* (y, h): the point of the ray at view depth 1; the receiver is at depth 4 */
        const double up = (row - at) * pixel, y = up * c - 3 * s, h = up * s + 3 * c;
        double v[7] = { 0, 0, s, c, 0, 0, 0 }, t[2], stop[16], light = 0;
        int found = 0;
        for (int k = 0; k < p->bars; ++k) {
            int edge, i = found;
            if (!crosses(&p->bar[k], y, h, s, -c, t, &edge)) continue;
            for (; i > 0 && stop[i - 2] > 1 + t[0]; i -= 2) { stop[i] = stop[i - 2]; stop[i + 1] = stop[i - 1]; }
            stop[i] = 1 + t[0];
            stop[i + 1] = 1 + t[1];
            found += 2;
            if (!i) { v[2] = edge ? -c : s; v[3] = edge ? s : c; }
            light = 1;
        }
        stop[found++] = 1 + h / c;
        v[0] = stop[0];
        for (int k = 1; k < found && k < 4; ++k) v[3 + k] = stop[k];
        for (size_t k = 0; k < 10; ++k)
            for (size_t x = 0; x < WIDE; ++x)
                frame.data[(k * HIGH + (size_t)(HIGH - 1 - row)) * WIDE + x] =
                    (float)(k < 7 ? v[k] : k == 7 ? light : 0.5 * light);
    }
    return TRY(kit_gbuffer_from_frame(g, &frame, &camera, &err)) ? at : 0;
}

/* Beyond the picture slices expect occluders, in at most this share of the directions that are free there. */
static const double expected_beyond = 0.4;

static void bars_cover_what_they_cover(void)
{
    enum { AO, LIGHT /* of a white sky */, BOUNCE /* of the bars */, UNSEEN /* backs of one-sided bars */,
           DARK /* their backs are set to be dark */, CLAMPED /* to a luminance of 0.25 */ };
    /* the share of 1 that reaches the receiver: the library's of a back; clamped, of red */
    static const double of_it[] = { 1, 1, 1, 0.35, 0, 0.25 / (0.2126 + 0.5 * (0.7152 + 0.0722)) };
    static const char *const seen[] = { "occlusion", "light", "bounce", "bounce", "bounce", "bounce" };
    /* knows 0: the answer must differ, as these bars are not as thick as the setting assumes */
    static const struct { const char *name; const profile *p; const char *set; int sees, knows; } row[] = {
        { "a plate", &a_plate, "thickness=back", AO, 1 },
        { "a plate", &a_plate, "thickness=slabs", AO, 1 },
        { "a plate", &a_plate, "thickness=constant", AO, 0 },
        { "a plate", &a_plate, "thickness=solid", AO, 0 },
        { "a plate", &a_plate, "thickness=slabs", LIGHT, 1 },
        { "a plate that is a double-sided emitter", &a_plate, "thickness=slabs,two_sided=1", BOUNCE, 1 },
        { "a plate hidden by another", &a_hidden_plate, "thickness=slabs", AO, 1 },
        { "a plate hidden by another", &a_hidden_plate, "thickness=back", AO, 0 },
        { "two overlapping cards", &two_cards, "thickness=slabs", AO, 1 },
        { "two overlapping cards", &two_cards, "thickness=back", AO, 0 },
        { "two overlapping cards", &two_cards, "thickness=slabs", LIGHT, 1 },
        { "a fence", &a_fence, "thickness=back", AO, 1 },
        { "a fence", &a_fence, "thickness=solid", AO, 0 },
        { "a fence", &a_fence, "thickness=back", LIGHT, 1 },
        { "a fence of double-sided emitters", &a_fence, "thickness=back,two_sided=1", BOUNCE, 1 },
        { "a fence of emitters that face away", &a_fence, "thickness=back,two_sided=0", UNSEEN, 1 },
        { "a fence of emitters whose backs are dark", &a_fence, "thickness=back,one_sided=1", DARK, 1 },
        { "a fence of emitters whose backs are dark", &a_fence, "thickness=slabs,one_sided=1", DARK, 1 },
        { "a fence of clamped emitters", &a_fence, "thickness=back,two_sided=1,clamp=0.25", CLAMPED, 1 },
        { "an emitter beyond the picture", &leaving[0], "thickness=slabs,two_sided=1", BOUNCE, 1 },
        { "an emitter half in it", &leaving[1], "thickness=slabs,two_sided=1", BOUNCE, 1 },
        { "an emitter at its edge", &leaving[2], "thickness=slabs,two_sided=1", BOUNCE, 1 },
        { "an emitter within it", &leaving[3], "thickness=slabs,two_sided=1", BOUNCE, 1 },
        { "an emitter far within it", &leaving[4], "thickness=slabs,two_sided=1", BOUNCE, 1 } };
    OWN(kit_lighting) white = { 0 };
    const kit_lighting dark = { .lights = 0 };
    if (!lighten(&white, "white", NULL)) return;
    for (int i = 0; i < ROWS(row); ++i) {
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_run) run = { 0 };
        char set[128];
        snprintf(set, sizeof set, "slices=8,samples=48%s,%s", row[i].sees == LIGHT ? ",bounce=none" : "", row[i].set);
        const int at = profile_seen(&g, row[i].p);
        if (!at || !begin(&run, &g, row[i].sees == AO ? "hsao-best" : "ssdo", set, 1, NULL,
                          row[i].sees == LIGHT ? &white : &dark))
            return;
        const double got = row_of(&run, &g, at, 4), o = row[i].sees < BOUNCE ? 1 - got : got, within = 0.0035,
                     truth = of_it[row[i].sees] * blocked(row[i].p), beyond = fmax(0, 1 - row[i].p->upper),
                     guess = truth > 0 ? 0.5 * expected_beyond * beyond * beyond * (1 - truth) : 0;
        SHOW(row[i].knows == (o > truth - within && o < truth + within + guess), "%s, %s, %s: %.4f, truth %.4f",
             row[i].name, row[i].set, seen[row[i].sees], o, truth);
    }
}

/* ---- bare planes: nothing occludes, for any method --------------------------------------------------------------- */

/* writes irradiance over pi on surfaces with these normals, three channels each */
static void cosine_integrals(double (*out)[3], const kit_image *env, const double (*n)[3], int normals)
{
    memset(out, 0, (size_t)normals * sizeof *out);
    for (int y = 0; y < env->height; ++y)
        for (int x = 0; x < env->width; ++x) {
            const double area = 2 * pi / env->width * pi / env->height * sin(pi * (y + 0.5) / env->height);
            float d[3], rgb[3];
            kit_env_direction(env, x + 0.5, y + 0.5, d);
            kit_env_radiance(env, d, rgb);
            for (int i = 0; i < normals; ++i) {
                const double cosine = (double)d[0] * n[i][0] + (double)d[1] * n[i][1] + (double)d[2] * n[i][2];
                for (int c = 0; c < 3; ++c) out[i][c] += fmax(0, cosine) * area / pi * (double)rgb[c];
            }
        }
}

/* Makes the G-buffer of a plane of thickness 0.03 in front of one of thickness 0.02. */
static int floors(kit_gbuffer *g, kit_image *frame, const kit_camera *c, const double plane[4])
{
    static const double behind[3] = { 0.03, 0.05, 0.07 };
    if (!planes_seen(frame, c, (const double (*)[4])plane, 1, ",back.Z,front2.Z,back2.Z")) return 0;
    for (size_t k = 0; k < 3; ++k) {
        const double farther[1][4] = { { plane[0], plane[1], plane[2], plane[3] - behind[k] } };
        const size_t pixels = (size_t)frame->width * (size_t)frame->height;
        OWN(kit_image) other = { 0 };
        if (!planes_seen(&other, c, farther, 1, "")) return 0;
        memcpy(frame->data + (4 + k) * pixels, other.data, pixels * sizeof(float));
    }
    return TRY(kit_gbuffer_from_frame(g, frame, c, &err));
}

/* Makes G-buffers of one plane: with normals that lean to the eye, and as splats of 3x3 pixels. */
static int disagreeing(kit_gbuffer *bent, kit_gbuffer *steps, const kit_image *frame, const kit_camera *c,
                       const float view[16])
{
    const int pixels = frame->width * frame->height;
    OWN(kit_image) other = { 0 };
    if (!TRY(kit_image_new(&other, frame->width, frame->height, "Z,N.X,N.Y,N.Z", &err))) return 0;
    for (int i = 0; i < pixels; ++i) {
        float n[3], l = 0;
        for (int j = 0; j < 3; ++j) {
            n[j] = frame->data[(1 + j) * pixels + i] + 0.5f * view[4 * j + 2];
            l += n[j] * n[j];
        }
        other.data[i] = frame->data[i];
        for (int j = 0; j < 3; ++j) other.data[(1 + j) * pixels + i] = n[j] / sqrtf(l);
    }
    if (!TRY(kit_gbuffer_from_frame(bent, &other, c, &err))) return 0;
    memcpy(other.data, frame->data, 4 * (size_t)pixels * sizeof(float));
    for (int i = 0; i < pixels; ++i) {
        const int x = i % frame->width / 3 * 3 + 1, y = i / frame->width / 3 * 3 + 1;
        other.data[i] = frame->data[(y < frame->height ? y : frame->height - 1) * frame->width
                                    + (x < frame->width ? x : frame->width - 1)];
    }
    return TRY(kit_gbuffer_from_frame(steps, &other, c, &err));
}

/* Checks planes at many slants, under a sky. Every pixel must show the value at no radius: 1, or the sky's integral as
   far as the bands hold it. */
static void planes_stay_open(void)
{
    enum { WIDTH = 49, HEIGHT = 27, PIXELS = WIDTH * HEIGHT, PLANES = 4 };
    /* darkened: the most that is allowed; truth: the largest error against the sky's integral, over the brightest
       plane's; below 0: against the part that the bands of harmonics hold */
    /* BENT: normals lean to the eye, as smooth normals of a coarse mesh may. STEPS: squares of 3x3 pixels share one
       depth, as splats do. */
    enum { PLAIN, BENT, STEPS, KINDS };
    static const struct { const char *method, *set; double darkened, truth; } row[] = {
        { "ssao", "blur=1", 1e-3, 0 },
        { "ssao", "thickness=solid,normal=depth", 1e-3, 0 },
        { "ssao", "thickness=width", 1e-3, 0 },
        { "hsao", "resolution=half,blur=1", 1e-5, 0 },
        { "hsao-fast", "thickness=slabs,resolution=half,blur=1", 1e-5, 0 },
        { "hsao-fast", "resolution=quarter,blur=1", 1e-5, 0 },
        { "hsao-best", "falloff=none", 1e-5, 0 },
        { "hsao", "thickness=solid", 1e-5, 0 },
        { "hsao", "thickness=back", 1e-5, 0 },
        { "hsao-best", "normal=depth", 1e-5, 0 },
        { "hsao-march", "normal_rays=0,samples=6", 1e-5, 0 },
        { "hsao-march", "normal=depth,normal_rays=2,samples=6,thickness=solid", 1e-3, 0 },
        { "ssdo-points", "bounce=none,environment=map", 1e-3, 0.01 },
        { "ssdo-points", "bounce=none,environment=sh,sets=16", 1e-3, -1e-6 },
        { "ssdo-points", "bounce=none,environment=sh,bands=1,residual=1", 1e-3, 0.01 },
        { "ssdo", "bounce=none", 1e-5, 0.01 },
        { "ssdo", "bounce=none,thickness=slabs,resolution=half,blur=1", 1e-5, 0.01 },
        { "ssdo", "bounce=none,environment=sh,thickness=back", 1e-5, -1e-6 },
        { "s3ho", "indirect=none", 1e-5, 0.03 },
        { "s3ho-points", "indirect=none,store=float,filtered=coefficients,sets=16,samples=4", 1e-3, -1e-6 },
        { "s3ho-points", "indirect=none,store=float,filtered=light", 1e-3, -1e-6 },
        { "s3ho-points", "indirect=none,store=float,filtered=light,bands=2", 1e-3, -1e-6 },
        { "s3ho-points", "indirect=none,store=float,filtered=coefficients,bands=1", 1e-3, -1e-6 },
        { "s3ho", "indirect=none,residual=1,bands=2,thickness=back", 1e-5, 0.01 },
        { "s3ho", "indirect=none,bands=1,residual=1,store=float,filtered=coefficients", 1e-5, 0.01 },
        { "s3ho", "indirect=none,bands=3,store=packed,filtered=coefficients,thickness=slabs", 2e-3, 0.03 },
        { "ssbn", "store=float,thickness=solid", 1e-5, 0.01 },
        { "ssbn", "store=float,cone=normal,resolution=half,blur=1", 1e-5, 0.01 },
        { "ssbn-points", "store=packed,cone=normal", 1e-3, 0.02 },
        { "hsao", "facets=1", 1e-5, 0 },
        { "ssao", "facets=1,blur=1", 1e-3, 0 },
        { "hsao-march", "facets=1,normal_rays=2,samples=6", 1e-3, 0 },
        { "ssdo", "facets=1,bounce=none", 1e-5, 9 },
        { "s3ho", "facets=1,indirect=none", 1e-5, 9 },
        { "hsao", "lift=1,offset=8", 1e-5, 0 },
        { "ssdo", "lift=1,offset=8,bounce=none", 1e-5, 9 },
        { "hsao", "lift=1,offset=16,normal=depth", 1e-5, 0 } };
    static const double tilts[PLANES] = { 0, 40, 65, 85 };
    static const float targets[3][3] = { { 0, 0, -1 }, { 0.3f, -0.8f, -0.5f }, { 0.9f, 0.2f, 0.4f } };
    OWN(kit_lighting) sky = { 0 };
    double worst[ROWS(row)][2] = { { 0 } };
    if (!lighten(&sky, "sky", NULL)) return;
    for (int orthographic = 0; orthographic < 2; ++orthographic) {
        kit_gbuffer g[KINDS][PLANES];
        kit_image frame[PLANES];
        double world[PLANES][3], truth[PLANES][3], brightest = 0;
        float view[PLANES][16], projection[16];
        for (int k = 0; k < PLANES; ++k) {
            const double a = tilts[k] * pi / 180, b = 1 + 1.7 * k + orthographic,
                         n[4] = { sin(a) * cos(b), sin(a) * sin(b), cos(a), -cos(a) };
            kit_camera c = looking_along_z(WIDTH, HEIGHT, orthographic);
            memcpy(c.target, targets[k % 3], sizeof c.target);
            kit_camera_matrices(&c, view[k], projection);
            for (int j = 0; j < 3; ++j)
                world[k][j] = (double)view[k][4 * j] * n[0] + (double)view[k][4 * j + 1] * n[1]
                              + (double)view[k][4 * j + 2] * n[2];
            if (!floors(&g[PLAIN][k], &frame[k], &c, n)
                || !disagreeing(&g[BENT][k], &g[STEPS][k], &frame[k], &c, view[k]))
                return;
        }
        cosine_integrals(truth, &sky.env, (const double (*)[3])world, PLANES);
        for (int k = 0; k < 3 * PLANES; ++k) brightest = fmax(brightest, truth[k / 3][k % 3]);
        for (int i = 0; i < ROWS(row); ++i) {
            const int kind = strstr(row[i].set, "facets") ? BENT : strstr(row[i].set, "lift") ? STEPS : PLAIN,
                      lit_ = row[i].truth != 0, from = lit_ ? 3 : 0, channels = lit_ ? 3 : 1;
            double *const off = &worst[i][0], *const darkened = &worst[i][1];
            OWN(kit_run) run = { 0 };
            if (!begin(&run, &g[kind][0], row[i].method, row[i].set, 0.5f, NULL, &sky)) return;
            const int bands = run.pass[run.passes - 1].desc.light.bands;
            for (int k = 0; k < PLANES; ++k) {             /* a row's program is used for all planes */
                kit_image out[2];
                double vector[16], want[3];
                open_vector(vector, world[k]);
                for (int c = 0; c < 3; ++c)
                    want[c] = row[i].truth < 0 ? fmax(0, met(vector, run.harmonics, c, bands)) : truth[k][c];
                turn(&run, &g[kind][k]);
                for (int j = 0; j < 9; ++j) run.frame.rotation[j / 3 * 4 + j % 3] = view[k][j / 3 * 4 + j % 3];
                ssgi_gl_harmonics_set(&run.frame, run.harmonics, 4, view[k], NULL);
                run.frame.phase = (float)k / PLANES;
                for (int bare = 0; bare < 2; ++bare) {
                    run.frame.radius = run.frame.thickness_limit = bare ? 1e-6f : k & 1 ? 0.5f : 0.1f;
                    if (!drawn(&out[bare], &run)) return;
                }
                for (int c = from; c < from + channels; ++c)
                    for (int p = 0; p < PIXELS; ++p) {
                        const double v = (double)out[0].data[c * PIXELS + p],
                                     open = (double)out[1].data[c * PIXELS + p];
                        if (!flat(&frame[k], p % WIDTH, p / WIDTH)) continue;
                        *darkened = fmax(*darkened, fabs(v - open));
                        *off = fmax(*off, lit_ ? fabs(open - want[c - 3]) / brightest : fabs(open - 1));
                    }
                for (int bare = 0; bare < 2; ++bare) kit_image_free(&out[bare]);
            }
            CHECK(*darkened <= row[i].darkened && *off <= fmax(fabs(row[i].truth), 1e-6),
                  "%s %s: off by %.1e where it is open, darkened by %.1e", row[i].method, row[i].set, *off, *darkened);
        }
        for (int k = 0; k < KINDS * PLANES; ++k) kit_gbuffer_free(&g[k / PLANES][k % PLANES]);
        for (int k = 0; k < PLANES; ++k) kit_image_free(&frame[k]);
    }
    for (int i = 0; i < ROWS(row); ++i)
        t_note("%s %s: off by %.1e, darkened by %.1e", row[i].method, row[i].set, worst[i][0], worst[i][1]);
}

/* ---- rooms in perspective: the parts of their walls that lie in the picture ------------------------------------- */

/* A space whose walls n * x = n[3] enclose the eye, at the origin, which looks along -z. */
typedef struct space { double fovy, near; int planes; double plane[5][4]; } space;

/* Returns the share of directions from a point with normal n that meet a wall in the picture within the radius. falls:
   with linear falloff. */
static double walled(const space *s, const double at[3], const double n[3], double aspect, double radius, int falls)
{
    enum { N = 64 };
    const double up = tan(s->fovy * pi / 360), u[3] = { n[2], n[0], n[1] };      /* u: n with its axes permuted */
    const double v[3] = { n[1] * u[2] - n[2] * u[1], n[2] * u[0] - n[0] * u[2], n[0] * u[1] - n[1] * u[0] };
    double sum = 0;
    for (int i = 0; i < N * N; ++i) {
        double l[3], d[3], q[3], nearest = radius;
        lobe(l, i, N);
        for (int k = 0; k < 3; ++k) d[k] = l[0] * u[k] + l[1] * v[k] + l[2] * n[k];
        for (int p = 0; p < s->planes; ++p) {
            const double *w = s->plane[p], toward = w[0] * d[0] + w[1] * d[1] + w[2] * d[2],
                         t = (w[3] - w[0] * at[0] - w[1] * at[1] - w[2] * at[2]) / toward;
            if (toward < -1e-9 && t > 1e-6) nearest = fmin(nearest, t);
        }
        for (int k = 0; k < 3; ++k) q[k] = at[k] + nearest * d[k];
        if (nearest < radius && -q[2] >= s->near && fabs(q[1]) <= -q[2] * up && fabs(q[0]) <= -q[2] * up * aspect)
            sum += falls ? 1 - nearest / radius : 1;
    }
    return sum / (N * N);
}

/* Checks a corner of floor and wall through a wide lens, far off its axis; a wall that the near plane cuts; a white
   room seen through its open front; and the bounce of its walls in the dark, which equals the light that they block.
   Slices expect some occluders beyond the picture, so pictures are darker than the exact sum, by most. */
static void rooms_are_seen(void)
{
    enum { HEIGHT = 48, WIDTH = 2 * HEIGHT, PIXELS = WIDTH * HEIGHT, PHASES = 2, BORDER = 3 };
    static const space corner = { 100, 0.01, 2, { { 0, 1, 0, -0.6 }, { -1, 0, 0, -1.5 } } },
                       cut = { 60, 1, 2, { { 0, 1, 0, -0.4 }, { -1, 0, 0, -0.5 } } },
                       room = { 90, 0.01, 5, { { 0, 1, 0, -0.5 }, { 0, -1, 0, -0.5 }, { 1, 0, 0, -1 },
                                               { -1, 0, 0, -1 }, { 0, 0, 1, -1.5 } } };
    enum { ALL, OFF_AXIS, NEAR };
    static const struct {
        const char *name;
        const space *s;
        const char *method, *set;
        double radius;
        int where, sends;
        double off, darker;
    } row[] = {
        { "a corner off the axis", &corner, "hsao-best", "", 0.5, OFF_AXIS, 0, 0.015, 0.012 },
        { "a corner off the axis", &corner, "ssdo", "bounce=none", 0.5, OFF_AXIS, 0, 0.015, 0.012 },
        { "a wall across the near plane", &cut, "hsao-best", "", 0.4, NEAR, 0, 0.005, 0.005 },
        { "a wall across the near plane", &cut, "ssdo", "bounce=none", 0.4, NEAR, 0, 0.005, 0.005 },
        { "a white room", &room, "hsao-best", "falloff=none", 5, ALL, 0, 0.04, 0.04 },
        { "a white room", &room, "s3ho", "falloff=none,indirect=none", 5, ALL, 0, 0.04, 0.04 },
        { "a white room", &room, "ssbn", "falloff=none", 5, ALL, 0, 0.04, 0.04 },
        { "a white room", &room, "ssdo", "falloff=none,bounce=none", 5, ALL, 0, 0.04, 0.04 },
        { "a shining room", &room, "ssdo", "falloff=none,two_sided=1", 5, ALL, 1, 0.04, 0.04 } };
    static double got[HEIGHT][WIDTH];
    const kit_lighting dark = { .lights = 0 };
    OWN(kit_lighting) white = { 0 };
    if (!lighten(&white, "white", NULL)) return;
    for (int i = 0; i < ROWS(row); ++i) {
        const space *s = row[i].s;
        const double up = tan(s->fovy * pi / 360);
        /* the channel: ambient visibility, irradiance, or the bounce */
        const int channel = !strncmp(row[i].method, "hsao", 4) ? 0 : row[i].sends ? 7 : 4;
        double off = 0, bias = 0, whole = 0;
        int n = 0;
        kit_camera c = looking_along_z(WIDTH, HEIGHT, 0);
        OWN(kit_image) frame = { 0 };
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_run) run = { 0 };
        char set[128];
        c.fovy = (float)s->fovy;
        c.znear = (float)s->near;
        snprintf(set, sizeof set, "thickness=solid,slices=8,samples=48%s%s", *row[i].set ? "," : "", row[i].set);
        if (!planes_seen(&frame, &c, s->plane, s->planes, row[i].sends ? ",direct.R,direct.G,direct.B" : "")) return;
        for (int k = 4 * PIXELS; k < 7 * PIXELS && row[i].sends; ++k) frame.data[k] = 1;
        if (!TRY(kit_gbuffer_from_frame(&g, &frame, &c, &err))
            || !begin(&run, &g, row[i].method, set, (float)row[i].radius, NULL, row[i].sends ? &dark : &white))
            return;
        static double last[HEIGHT][WIDTH];         /* the row before's: the white room, for the shining one */
        memcpy(last, got, sizeof got);
        memset(got, 0, sizeof got);
        for (int phase = 0; phase < PHASES; ++phase) {
            OWN(kit_image) out = { 0 };
            run.frame.phase = (float)phase / PHASES;
            if (!drawn(&out, &run)) return;
            for (int k = 0; k < PIXELS; ++k) {
                const double v = (double)out.data[channel * PIXELS + k];
                got[k / WIDTH][k % WIDTH] += (row[i].sends ? 1 - v : v) / PHASES;
            }
        }
        for (int y = BORDER; y < HEIGHT - BORDER; y += 2)
            for (int x = BORDER; x < WIDTH - BORDER; x += 3) {
                const int k = y * WIDTH + x;
                const double z = (double)frame.data[k],
                             normal[3] = { (double)frame.data[PIXELS + k], (double)frame.data[2 * PIXELS + k],
                                           (double)frame.data[3 * PIXELS + k] },
                             at[3] = { (2 * (x + 0.5) / WIDTH - 1) * up * 2 * z,
                                       (1 - 2 * (y + 0.5) / HEIGHT) * up * z, -z };
                int inside = flat(&frame, x, y);
                for (int p = 0; p < s->planes; ++p) {      /* leaves out the floor, which shows through a cut wall */
                    const double *w = s->plane[p];
                    inside &= w[0] * at[0] + w[1] * at[1] + w[2] * at[2] > w[3] - 1e-3;
                }
                if (!inside || (row[i].where == OFF_AXIS && x < WIDTH * 3 / 4)
                    || (row[i].where == NEAR && z > s->near + row[i].radius))
                    continue;
                const double open = 1 - walled(s, at, normal, (double)WIDTH / HEIGHT, row[i].radius,
                                               !strstr(row[i].set, "falloff=none")), d = got[y][x] - open;
                if (open > 0.999) continue;
                off += fabs(d);
                bias += d;
                whole = fmax(whole, fabs(got[y][x] - last[y][x]));
                ++n;
            }
        SHOW(n >= 15 && off / n <= row[i].off && bias / n <= 0.003 && -bias / n <= row[i].darker,
             "%s, %s %s: at %d pixels off by %.4f, bias %+.4f", row[i].name, row[i].method, set, n, off / n, bias / n);
        CHECK(!row[i].sends || whole < 1e-5, "walls send other light than they keep out: %.1e apart", whole);
    }
}

/* ---- the same picture, whatever the camera, the layout and the units -------------------------------------------- */

enum { SEEN_W = 96, SEEN_H = 56, SEEN = SEEN_W * SEEN_H };

/* Compares visibility, or outgoing radiance with the bounce. Compiling takes most of the time, so only these rows are
   drawn: in view depth, which frames have without layers; orthographic; with an infinite far plane; by orthographic
   eyes anywhere; with loose uniforms; and with depth as engines have it, without noise, which differs upside down. */
enum { IN_VIEW_DEPTH = 1, FLAT_TOO = 2, ENDLESS_TOO = 4, AFAR = 8, LOOSELY = 16, BARE = 32, NOWHERE_ELSE = 64 };
static const struct { const char *method, *set; int also; } alike[] = {
    { "ssao", "thickness=solid", IN_VIEW_DEPTH | ENDLESS_TOO },
    { "ssao", "", NOWHERE_ELSE | AFAR },
    { "hsao", "resolution=half", IN_VIEW_DEPTH | AFAR | LOOSELY },
    { "hsao", "thickness=slabs", NOWHERE_ELSE | AFAR },
    { "hsao-best", "slices=1,samples=8", FLAT_TOO | ENDLESS_TOO },
    { "hsao-best", "slices=2,samples=4,blur=0", NOWHERE_ELSE | BARE },
    { "hsao-best", "slices=2,samples=4,blur=0,thickness=constant", NOWHERE_ELSE | BARE },
    { "hsao-best", "slices=2,samples=4,blur=0,thickness=constant,normal=depth", NOWHERE_ELSE | BARE },
    { "hsao-march", "directions=2,samples=4", IN_VIEW_DEPTH },
    { "hsao-march", "layers=2", NOWHERE_ELSE | AFAR },
    { "hsao-march", "directions=2,samples=4,views=2,view_layers=2,view_size=32", NOWHERE_ELSE | LOOSELY },
    { "hsao-history", "slices=1,blur=1", NOWHERE_ELSE | LOOSELY },
    { "ssdo-points", "bounce=solid-angle,layers=2,directions=8,fade=smooth", ENDLESS_TOO },
    { "ssdo-points", "bounce=patch,directions=8,resolution=full,shadows=segment,points=4", 0 },
    { "ssdo", "resolution=half,shadow_size=64", IN_VIEW_DEPTH | ENDLESS_TOO },
    { "ssdo", "bounce=solid-angle,shadow_size=256", NOWHERE_ELSE | AFAR },
    { "ssdo", "vpls=4,shadow_size=32", NOWHERE_ELSE | LOOSELY },
    { "s3ho", "resolution=half,bands=2", 0 },
    { "s3ho", "lights=shadowed,shadow_size=256", NOWHERE_ELSE | AFAR },
    { "s3ho-points", "layers=2,fade=lambda,range_check=1,directions=8", FLAT_TOO | ENDLESS_TOO },
    { "s3ho-points", "indirect=none,filtered=coefficients,resolution=half,blur=2,store=packed,directions=8",
      IN_VIEW_DEPTH },
    { "s3ho-points", "filtered=coefficients,indirect=apart,blur=1,resolution=half,directions=8", ENDLESS_TOO },
    { "ssbn-points", "lights=shadowed,shadow_size=64,blur=1,filtered=coefficients,fade=lambda,directions=8", 0 },
    { "dss-lit", "size=0.06,shadow_size=64", IN_VIEW_DEPTH | ENDLESS_TOO | LOOSELY },
    { "dss-lit", "size=0.06,shadow_size=256", NOWHERE_ELSE | AFAR },
    { "aof", "field_resolution=4,radii=4,rays=32", AFAR | LOOSELY } };

enum { REVERSED, NORMAL, ENDLESS, LINEAR, INSIDE, SHIFTED, EIGHTH, EIGHT, TENTH, TEN, ROLLED, DISTANT, DISTANT_LINEAR,
       DISTANT_DECODED, DISTANT_OWN, WITHIN, WITHIN_LINEAR, WITHIN_DECODED, WITHIN_OWN, LOOSE, LEFT_HANDED, SLICED,
       SAMPLED, OBLIQUE, UPSIDE_DOWN, WAYS };
/* most: the share of values that may differ by over 1 % of the mean, as rounding moves samples across edges; or with
   rmse the RMSE over the mean. Powers of two change no digit of a float. away: distance of an orthographic eye, in
   sevenths. decodes: the function that a shader's own fetch calls. */
static const struct { const char *name; double scale, most; int rmse, needs, linear; float away; const char *decodes;
} way_of[WAYS] = { { "reversed depth", 1, 0, 0, 0, 0, 1.5f, NULL },
                   { "normal depth", 1, 0.03, 0, 0, 0, 1.5f, NULL },
                   { "infinite far plane", 1, 0.01, 0, ENDLESS_TOO, 0, 1.5f, NULL },
                   { "view depth", 1, 0.01, 0, IN_VIEW_DEPTH, 1, 1.5f, NULL },
                   { "inside larger textures", 1, 0.01, 0, 0, 0, 1.5f, NULL },
                   { "shifted", 1, 0.01, 0, 0, 0, 1.5f, NULL },
                   { "1/8", 0.125, 0, 0, 0, 0, 1.5f, NULL },
                   { "8", 8, 0, 0, 0, 0, 1.5f, NULL },
                   { "1/10", 0.1, 0.02, 0, 0, 0, 1.5f, NULL },
                   { "10", 10, 0.02, 0, 0, 0, 1.5f, NULL },
                   { "rolled", 1, 0, 1, 0, 0, 1.5f, NULL },
                   { "from afar", 1, 0.008, 1, AFAR, 0, 14336, NULL },
                   { "from afar, view depth", 1, 0.006, 1, AFAR | IN_VIEW_DEPTH, 1, 14336, NULL },
                   { "from afar, decoded", 1, 0.006, 1, AFAR | IN_VIEW_DEPTH, 0, 14336, "ssgi_decode" },
                   { "from afar, view depth of one's own", 1, 0.006, 1, AFAR | IN_VIEW_DEPTH, 1, 14336, "" },
                   { "from within", 1, 0.006, 1, AFAR | IN_VIEW_DEPTH, 0, 1.5f, NULL },
                   { "from within, view depth", 1, 0.006, 1, AFAR | IN_VIEW_DEPTH, 1, 1.5f, NULL },
                   { "from within, decoded", 1, 0.006, 1, AFAR | IN_VIEW_DEPTH, 0, 1.5f, "ssgi_decode" },
                   { "from within, view depth of one's own", 1, 0.006, 1, AFAR | IN_VIEW_DEPTH, 1, 1.5f, "" },
                   { "loose uniforms", 1, 0, 0, LOOSELY, 0, 1.5f, NULL },
                   { "left-handed", 1, 0, 0, BARE, 0, 1.5f, NULL },
                   { "a slice", 1, 0, 0, BARE, 0, 1.5f, NULL },
                   { "multisampled", 1, 0, 0, BARE, 0, 1.5f, NULL },
                   { "an oblique near plane", 1, 0.003, 1, BARE, 0, 1.5f, NULL },
                   { "upside down", 1, 0.001, 0, BARE, 0, 1.5f, NULL } };

/* Makes two textures of four samples for the gather: the first is the G-buffer's, the others are nonsense. */
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
        glTexImage2DMultisample(GL_TEXTURE_2D_MULTISAMPLE, 4, formats[i], SEEN_W, SEEN_H, GL_TRUE);
        glFramebufferTexture2D(GL_FRAMEBUFFER, places[i], GL_TEXTURE_2D_MULTISAMPLE, texture[i], 0);
    }
    glViewport(0, 0, SEEN_W, SEEN_H);
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

/* Gives the projection another near plane, in view space; the scene must lie beyond it [Lengyel 2005]. */
static void oblique_plane(float m[16], const double plane[4])
{
    const double q[4] = { (copysign(1, plane[0]) + (double)m[8]) / (double)m[0],
                          (copysign(1, plane[1]) + (double)m[9]) / (double)m[5], -1,
                          (1 + (double)m[10]) / (double)m[14] };
    double at = 0;
    for (int k = 0; k < 4; ++k) at += plane[k] * q[k];
    for (int k = 0; k < 4; ++k) m[4 * k + 2] = (float)(2 / at * plane[k] + (k == 2 ? 1 : 0));
}

/* Moves an orthographic camera's eye forward until the near plane is two units behind it. */
static int step_within(kit_gbuffer *g, int linear)
{
    static float z[SEEN];
    const float by = -2 - g->camera.znear;
    float view[16];
    g->camera.znear += by;
    g->camera.zfar += by;
    kit_camera_matrices(&g->camera, view, g->projection);
    if (!linear) return 1;
    if (!TRY(kit_texture_read(g->depth, SEEN_W, SEEN_H, 1, z))) return 0;
    for (int i = 0; i < SEEN; ++i) z[i] = z[i] > 0 ? z[i] + by : 1e18f;
    glDeleteTextures(1, &g->depth);
    g->depth = kit_texture(SEEN_W, SEEN_H, GL_R32F, z);
    return 1;
}

/* Gives a G-buffer depth and normals as engines store them. */
static int as_engines_have(kit_gbuffer *g, int way)
{
    static float z[SEEN], n[4 * SEEN], depth[2 * SEEN], normal[8 * SEEN];
    const int layer = way == SLICED;                       /* layer 0 of the array shows no surface */
    const float *const p = g->projection, was[16] = { p[0], p[1], p[2], p[3], p[4], p[5], p[6], p[7], p[8], p[9], p[10],
                                                      p[11], p[12], p[13], p[14], p[15] };
    GLuint texture[2];
    int beyond = 0;
    if (way >= WITHIN && way <= WITHIN_OWN) return step_within(g, way_of[way].linear);
    if (way < LEFT_HANDED) return 1;
    if (!TRY(kit_texture_read(g->depth, SEEN_W, SEEN_H, 1, z))
        || !TRY(kit_texture_read(g->normal, SEEN_W, SEEN_H, 4, n)))
        return 0;
    if (way == OBLIQUE) oblique_plane(g->projection, (const double[4]) { 0.1, -0.2, -1, -0.05 });
    for (int k = 8; k < 12 && way == LEFT_HANDED; ++k) g->projection[k] = -was[k];
    for (int i = 0; i < SEEN; ++i) {
        const int to = layer * SEEN + (way == UPSIDE_DOWN ? (SEEN_H - 1 - i / SEEN_W) * SEEN_W + i % SEEN_W : i);
        const double x = (2 * (i % SEEN_W + 0.5) / SEEN_W - 1 + (double)was[8]) / (double)was[0],
                     y = (2 * (i / SEEN_W + 0.5) / SEEN_H - 1 + (double)was[9]) / (double)was[5],
                     ahead = (double)was[14] / (2 * (double)z[i] - 1 + (double)was[10]),
                     window = 0.5 + 0.5 * ((double)p[2] * x + (double)p[6] * y - (double)p[10] + (double)p[14] / ahead);
        memcpy(normal + 4 * to, n + 4 * i, 4 * sizeof *n);
        if (way == LEFT_HANDED) normal[4 * to + 2] = -n[4 * i + 2];
        depth[to] = way == OBLIQUE && z[i] < 1 ? (float)window : z[i];
        beyond += way == OBLIQUE && z[i] < 1 && !(window > 0 && window < 1);
    }
    for (int i = 0; i < 2 && way != SAMPLED; ++i) {
        const GLenum format = i ? GL_RGBA32F : GL_DEPTH_COMPONENT32F;
        texture[i] = layer ? kit_texture_array(SEEN_W, SEEN_H, 2, format, i ? normal : depth)
                           : kit_texture(SEEN_W, SEEN_H, format, i ? normal : depth);
    }
    CHECK(!beyond, "%d pixels are outside of the oblique frustum", beyond);
    if (way == SAMPLED && !sampled(texture, g)) return 0;
    glDeleteTextures(1, &g->depth);
    glDeleteTextures(1, &g->normal);
    g->depth = texture[0];
    g->normal = texture[1];
    return 1;
}

/* Makes the G-buffer of the room, under a sky and a lamp, in these units, by a camera that differs. */
static int seen_in(kit_scene *scene, kit_gbuffer *g, kit_lighting *l, int way, int orthographic)
{
    static const int margin[4] = { 8, 4, 12, 16 };
    const float scale = (float)way_of[way].scale;
    char light[160];
    snprintf(light, sizeof light, "point:%.9g,%.9g,%.9g,%.9g,%.9g,%.9g", 1.5 * (double)scale, 2.2 * (double)scale,
             2.5 * (double)scale, 4 * (double)(scale * scale), 3 * (double)(scale * scale),
             2 * (double)(scale * scale));
    l->lights = 0;
    if (!TRY(kit_light_parse(&l->light[l->lights++], light, NULL, &err))
        || !TRY(kit_scene_load(scene, "room", 0, &err)))
        return 0;
    kit_camera *c = &scene->camera;
    c->width = way == ROLLED ? SEEN_H : SEEN_W;
    c->height = way == ROLLED ? SEEN_W : SEEN_H;
    c->depth = way == NORMAL || way == OBLIQUE   ? KIT_DEPTH_NORMAL
               : way == ENDLESS && !orthographic ? KIT_DEPTH_INFINITE
                                                 : KIT_DEPTH_REVERSED;
    if (orthographic) {
        static const float toward[3] = { 2, 3, 6 };        /* of length 7, so that floats hold a far eye's position */
        c->fovy = c->znear = c->zfar = 0;
        c->ortho_height = 3.6f;
        for (int i = 0; i < 3; ++i) {
            c->target[i] = floorf(128 * c->target[i]) / 128;
            c->eye[i] = c->target[i] + way_of[way].away * toward[i];
        }
    }
    /* shifts by multiples of the noise's tile */
    if (way == SHIFTED) { c->shift[0] = 16; c->shift[1] = -8; }
    if (way == ROLLED) {                                   /* left becomes up */
        c->up[0] = c->target[2] - c->eye[2]; c->up[1] = 0; c->up[2] = c->eye[0] - c->target[0];
        c->fovy = (float)(360 / pi * atan(tan((double)c->fovy * pi / 360) * SEEN_W / SEEN_H));
    }
    for (size_t i = 0; i < 9 * scene->mesh.triangles; ++i) scene->mesh.position[i] *= scale;
    for (int i = 0; i < 3; ++i) {
        c->eye[i] *= scale;
        c->target[i] *= scale;
        scene->mesh.lower[i] *= scale;
        scene->mesh.upper[i] *= scale;
    }
    c->znear *= scale; c->zfar *= scale; c->ortho_height *= scale;
    if (!TRY(kit_gbuffer_from_scene(g, scene, c, way == INSIDE ? margin : NULL, &err))) return 0;
    if (way_of[way].linear) {
        OWN(kit_gbuffer) window = *g;
        OWN(kit_image) frame = { 0 };
        if (!TRY(kit_gbuffer_read(&frame, &window, &err))
            || !TRY(kit_gbuffer_from_frame(g, &frame, &window.camera, &err)))
            return 0;
    }
    if (!as_engines_have(g, way)) return 0;
    for (int y = 0; y < g->height && way == INSIDE; ++y) {   /* the depths around the picture must not matter */
        float beside[SEEN_W + 20];
        for (int i = 0; i < SEEN_W + 20; ++i) beside[i] = 0.9f;
        glBindTexture(GL_TEXTURE_2D, g->depth);
        if (y < 4 || y >= 4 + SEEN_H)
            glTexSubImage2D(GL_TEXTURE_2D, 0, 0, y, SEEN_W + 20, 1, GL_DEPTH_COMPONENT, GL_FLOAT, beside);
    }
    return 1;
}

/* Returns the share of values in the first channels that differ by over 1 % of a's mean, and the RMSE over that mean. b
   is shifted to the right and down by dx, dy. */
static double apart(double *rmse, const kit_image *a, const kit_image *b, int dx, int dy, int border)
{
    const int channels = a->channels > 1 ? 3 : 1;
    const double middle = mean(a, a->channels > 1 ? "G" : "Y");
    double sum = 0;
    int n = 0, off = 0;
    for (int c = 0; c < channels; ++c)
        for (int y = border; y < SEEN_H - border; ++y)
            for (int x = border; x < SEEN_W - border; ++x, ++n) {
                const double d = (double)a->data[c * SEEN + y * SEEN_W + x]
                                 - (double)b->data[c * SEEN + (y + dy) * SEEN_W + x + dx];
                sum += d * d;
                off += !(fabs(d) <= 0.01 * middle);
            }
    *rmse = sqrt(sum / n) / middle;
    return (double)off / n;
}

/* Draws a picture by camera, layout or units of a way. plain: without noise. Passes get programs of their own. */
static int seen_by(kit_image *out, kit_gbuffer *g, int m, const char *set, int way, int plain, const kit_scene *scene,
                   const kit_lighting *l)
{
    static const float none[4] = { 0, 0, 0, 0 };
    const char *const decodes = way_of[way].decodes;
    const int otherwise = way >= LOOSE || decodes;
    char text[200];
    OWN(kit_run) run = { 0 };
    GLuint was[KIT_MAX_PASSES];
    int ok = open_run(&run, g, alike[m].method, set, 0.15f * (float)way_of[way].scale, scene, l);
    snprintf(text, sizeof text, "uniform sampler2D my_depth;\nfloat ssgi_custom_depth(ivec2 texel, int layer) {\n"
             "    return %s(texelFetch(my_depth, texel, layer).x);\n}", decodes ? decodes : "");
    if (plain && ok) {
        glBindTexture(GL_TEXTURE_2D, run.noise);
        glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, 1, 1, 0, GL_RGBA, GL_FLOAT, none);
    }
    for (int k = 0; k < run.passes && otherwise; ++k) {
        kit_pass *p = &run.pass[k];
        was[k] = p->program;
        if (decodes && p->desc.pass == SSGI_GL_PASS_BLUR) continue;
        p->program = 0;
        if (way == LOOSE) p->desc.shader.uniforms = SSGI_GL_UNIFORMS_LOOSE;
        p->desc.input.left_handed = way == LEFT_HANDED;
        p->desc.input.array = way == SLICED;
        p->desc.input.multisampled = way == SAMPLED;
        p->desc.input.oblique = way == OBLIQUE;
        if (decodes) {                                     /* a sampler at unit 0, where rows have depth */
            p->desc.input.depth = SSGI_GL_DEPTH_CUSTOM;
            p->desc.shader.fetch = text;
            ok = ok && TRY(!(p->program = kit_pass_program(&p->desc, &err)));
        } else ok = ok && TRY(kit_pass_make(p, &err));
    }
    run.frame.layer = way == SLICED;
    if (way == UPSIDE_DOWN) {
        ssgi_view view;
        ssgi_gl_frame turned;
        ok = ok && CHECK(ssgi_view_from_projection(&view, g->projection, SSGI_CLIP_ZERO + SSGI_CLIP_ROWS_DOWN, SEEN_W,
                                                   SEEN_H, NULL) == SSGI_OK, "a view with rows that run down");
        ssgi_gl_frame_init(&turned, &view, 1, NULL);
        memcpy(run.frame.project, turned.project, sizeof turned.project);
        memcpy(run.frame.unproject, turned.unproject, sizeof turned.unproject);
    }
    for (GLuint block = 0; block < 2 && way == LOOSE; ++block) glBindBufferBase(GL_UNIFORM_BUFFER, block, 0);
    ok = ok && drawn(out, &run);
    for (int k = 0; k < run.passes && otherwise; ++k) {
        if (run.pass[k].program != was[k]) glDeleteProgram(run.pass[k].program);
        run.pass[k].program = was[k];
    }
    return ok;
}

/* Compares ways first .. last with reversed depth; in perspective (0) or orthographic (1), from .. to. */
static void nothing_changes(int first, int last, int from, int to)
{
    const int apart_from_others = way_of[first].needs & (AFAR | LOOSELY | BARE), plain = way_of[first].needs == BARE;
    double worst[WAYS] = { 0 };
    OWN(kit_lighting) l = { 0 };
    if (!lighten(&l, NULL, NULL) || !TRY(kit_image_new(&l.env, 16, 8, "R,G,B", &err))) return;
    for (int i = 0; i < 3 * 128; ++i) l.env.data[i] = 0.5f + (float)(i % 7) / 7 + (float)(i / 16 % 8) / 8;
    for (int orthographic = from; orthographic <= to; ++orthographic) {
        kit_image reference[ROWS(alike)] = { 0 }, other, turned;
        for (int way = 0; way < WAYS; ++way) {
            if (way != REVERSED && (way < first || way > last)) continue;
            const int needs = way_of[way ? way : first].needs | (orthographic > from ? FLAT_TOO : 0);
            OWN(kit_scene) scene = { 0 };
            OWN(kit_gbuffer) g = { 0 };
            if (!seen_in(&scene, &g, &l, way, orthographic)) return;
            for (int m = 0; m < ROWS(alike); ++m) {
                char set[128];
                const int gathers = strncmp(alike[m].method, "dss", 3) && strcmp(alike[m].method, "aof");
                snprintf(set, sizeof set, "%s%s", gathers ? "noise=texture," : "", alike[m].set);
                /* at half resolution another pixel of each 2x2 is drawn, so the picture differs */
                if (way == ROLLED && (!gathers || strstr(set, "resolution=half"))) continue;
                if (way == SHIFTED && !strncmp(alike[m].method, "dss", 3)) continue; /* blocks are of 32 pixels */
                if ((alike[m].also & needs) != needs
                    || (alike[m].also & NOWHERE_ELSE && !apart_from_others))
                    continue;
                /* thickness begins at a 2x2's lower left pixel, which is another one upside down */
                if (way == UPSIDE_DOWN && !strstr(set, "thickness=constant")) continue;
                if (!seen_by(&other, &g, m, set, way, plain, &scene, &l)) return;
                if (way == REVERSED) { reference[m] = other; continue; }
                double most = way_of[way].most;
                if (way == ROLLED || way == UPSIDE_DOWN) {                     /* turned back */
                    if (!TRY(kit_image_new(&turned, SEEN_W, SEEN_H, other.channels > 1 ? "R,G,B" : "Y", &err))) return;
                    for (int i = 0; i < turned.channels * SEEN; ++i) {
                        const int x = i % SEEN_W, y = SEEN_H - 1 - i % SEEN / SEEN_W,
                                  from_there = way == ROLLED ? x * SEEN_H + y : y * SEEN_W + x;
                        turned.data[i] = other.data[i / SEEN * SEEN + from_there];
                    }
                }
                if (way == ROLLED) {           /* differs by at most as much as another phase of the noise */
                    snprintf(set + strlen(set), 16, ",phase=0.39");
                    OWN(kit_image) again = { 0 };
                    if (!seen_by(&again, &g, m, set, way, plain, &scene, &l)) return;
                    double sum = 0;
                    for (int i = 0; i < turned.channels * SEEN; ++i)
                        sum += pow((double)other.data[i] - (double)again.data[i], 2) / (turned.channels * SEEN);
                    most = 1.4 * sqrt(sum) / mean(&other, turned.channels > 1 ? "G" : "Y");
                }
                if (way == ROLLED || way == UPSIDE_DOWN) { kit_image_free(&other); other = turned; }
                const int dx = way == SHIFTED ? 16 : 0, dy = dx / 2, border = 3 * dx / 2;
                double rmse, share = apart(&rmse, &reference[m], &other, dx, dy, border);
                if (way_of[way].rmse) share = rmse;
                worst[way] = fmax(worst[way], share);
                CHECK(share <= most, "%s %s, %s, %s: %.4f", alike[m].method, set,
                      orthographic ? "orthographic" : "perspective", way_of[way].name, share);
                kit_image_free(&other);
            }
        }
        for (int m = 0; m < ROWS(alike); ++m) kit_image_free(&reference[m]);
    }
    for (int w = first; w <= last; ++w) t_note("%s: %.4f", way_of[w].name, worst[w]);
}

static void layouts_do_not_matter(void)    { nothing_changes(NORMAL, SHIFTED, 0, 1); }
static void units_do_not_matter(void)      { nothing_changes(EIGHTH, ROLLED, 0, 0); }
static void eyes_stand_anywhere(void)      { nothing_changes(DISTANT, WITHIN_OWN, 1, 1); }
static void uniforms_may_be_loose(void)    { nothing_changes(LOOSE, LOOSE, 0, 0); }
static void what_engines_have(void)        { nothing_changes(LEFT_HANDED, UPSIDE_DOWN, 0, 0); }

/* Checks larger targets, with the picture at (8, 6) in them. Around it they must keep their old values. */
static void targets_have_room(void)
{
    enum { BEYOND = 20, WIDE_ = SEEN_W + BEYOND, HIGH_ = SEEN_H + BEYOND };
    static const struct { const char *method, *set; } row[] = {
        { "ssao", "directions=8,blur=2" },
        { "hsao", "resolution=half,blur=1" },
        { "hsao", "resolution=quarter,blur=1" },
        { "hsao-march", "directions=2,samples=4,blur=1" },
        { "s3ho-points", "directions=8,store=float,indirect=none,filtered=coefficients,resolution=half,blur=2" },
        { "s3ho-points", "directions=8,indirect=joint,filtered=light,blur=1" },
        { "s3ho", "indirect=joint,filtered=light,resolution=half,blur=2" } };
    static float texel[4 * WIDE_ * HIGH_], sevens[4 * WIDE_ * HIGH_];
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    OWN(kit_lighting) l = { 0 };
    double worst = 0;
    for (int k = 0; k < 4 * WIDE_ * HIGH_; ++k) sevens[k] = 7;
    if (!lighten(&l, "white", NULL) || !seen_in(&scene, &g, &l, REVERSED, 0)) return;
    for (int i = 0; i < ROWS(row); ++i) {
        OWN(kit_run) run = { 0 };
        OWN(kit_image) out = { 0 };
        int wrong = 0;
        if (!open_run(&run, &g, row[i].method, row[i].set, 0.15f, &scene, &l) || !drawn(&out, &run)) return;
        run.frame.target[0] = 8; run.frame.target[1] = 6;
        for (int k = 0; k < run.passes; ++k) {
            kit_pass *p = &run.pass[k];
            resize(p, p->width + BEYOND, p->height + BEYOND, sevens);
            if (p->target[0]) continue;
            const GLuint array = run.texture[run.textures++] =  /* its target is one layer of the emitters' array */
                kit_texture_array(p->width, p->height, 1, p->step->output[0].format->internal, sevens);
            kit_run_input(&run, "t_ssgi_emitters", array);
            glBindFramebuffer(GL_FRAMEBUFFER, p->framebuffer);
            glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, array, 0, 0);
        }
        kit_run_update(&run);
        kit_run_draw(&run, 0);
        const int channels = out.channels > 1 ? 3 : 1;
        if (!CHECK(!kit_texture_read(run.bounce ? run.bounce : run.light, WIDE_, HIGH_, channels, texel),
                   "a target cannot be read"))
            return;
        for (int k = 0; k < channels * WIDE_ * HIGH_; ++k) {
            const int x = k / channels % WIDE_ - 8, y = SEEN_H - 1 - (k / channels / WIDE_ - 6), c = k % channels,
                      inside = x >= 0 && x < SEEN_W && y >= 0 && y < SEEN_H;
            const float *at = out.data + y * SEEN_W + x;
            const double truth = !inside ? 7 : channels < 3 ? (double)*at
                                                            : (double)(at[(3 + c) * SEEN] + at[(6 + c) * SEEN]),
                         off = fabs((double)texel[k] - truth);
            worst = fmax(worst, off);
            wrong += !(off <= 3e-5);
        }
        CHECK(!wrong, "%s %s: %d values are wrong, the worst by %.1e", row[i].method, row[i].set, wrong, worst);
    }
    t_note("%.1e off at most", worst);
}

/* ---- beside rays ------------------------------------------------------------------------------------------------- */

/* Reverses the winding of every triangle. */
static void turn_inside_out(kit_mesh *mesh)
{
    for (size_t t = 0; t < mesh->triangles; ++t)
        for (int k = 0; k < 3; ++k) {
            float *const p = mesh->position + 9 * t, *const n = mesh->normal + 9 * t;
            const float was[2] = { p[3 + k], n[3 + k] };
            p[3 + k] = p[6 + k], p[6 + k] = was[0];
            n[3 + k] = n[6 + k], n[6 + k] = was[1];
        }
}

/* Checks errors against ray tracing. A ball inside out looks like a sheet if a method reads back faces, which costs a
   little. Lenses: 720 rows through a telescope, where the rounding of depth must not be seen. Extra cameras know what a
   picture from above lacks: a wall beside it, and a plate's underside, without which points below the plate seem
   blocked. Lamps alone, whose shadows bent normals take from maps, and with a sky. Fields of occluders: a coarse cube
   map and normals from depth raise the error. */
static void near_their_truth(void)
{
    enum { BALL, LENS, NARROW, NARROWEST, BESIDE, AFLOAT, LAMP, UNDER_SKY, AMONG_OBJECTS, PLACES };
    static const box beside = { { -3, 0, -1.2f }, { 3, 0.8f, -0.56f } },
                     afloat = { { -0.25f, 0.2f, -0.15f }, { 0.25f, 0.55f, 0.15f } };
    static const kit_camera above = { { 0, 1.8f, 0 }, { 0, 0, 0 }, { 0, 0, -1 }, 0, 1, 0.1f, 10, 0, 0, { 0 },
                                      KIT_DEPTH_NORMAL };
    static const struct {
        const char *name, *scene;
        const box *added;
        int boxes;
        const kit_camera *camera;
        float lens, radius;                    /* degrees; 0: the scene's */
        const char *env, *light;
        int width, height, rays;
    } place[PLACES] = {
        { "a ball inside out", "sphere", NULL, 0, NULL, 0, 0.7f, NULL, NULL, 160, 90, 64 },
        { "a common lens", "boxes", NULL, 0, NULL, 20, 0, NULL, NULL, 40, 720, 48 },
        { "a narrow lens", "boxes", NULL, 0, NULL, 1, 0, NULL, NULL, 40, 720, 48 },
        { "a narrower lens", "boxes", NULL, 0, NULL, 0.2f, 0, NULL, NULL, 40, 720, 48 },
        { "a wall beside the picture", "plane", &beside, 1, &above, 0, 0.4f, NULL, NULL, 112, 63, 64 },
        { "a plate afloat", "plane", &afloat, 1, &above, 0, 0.3f, NULL, NULL, 112, 63, 64 },
        { "a lamp in a box", "cornell", NULL, 0, NULL, 0, 0, NULL, "point:0,5,-2.8,20,20,20", 96, 54, 1 },
        { "columns under a sun and a sky", "columns", NULL, 0, NULL, 0, 0, "sky", "sun:1,2,1,3,3,3", 96, 54, 32 },
        { "two dozen occluders", "casters", NULL, 0, NULL, 0, 1, NULL, NULL, 160, 90, 64 } };
    /* most, least: limits of the RMSE over that of no occlusion, or with lamps over the mean; bias: its limit */
#define POINTS "bounce=none,blur=0,directions=33,samples=1,range_check=0,fade=none,thickness=solid"
#define CAMERAS ",views=3,view_layers=2"
#define FIELDS "radii=8,rays=32,field_resolution="
    static const struct { int place; const char *method, *set; double least, most, bias; } row[] = {
        { BALL, "hsao-best", "slices=4,samples=16,thickness=width", 0, 0.8, 0.012 },
        { BALL, "hsao-best", "slices=4,samples=16,thickness=back", 0, 0.96, 0.015 },
        { BALL, "hsao-best", "slices=4,samples=16,thickness=slabs", 0, 0.33, 0.004 },
        { LENS, "hsao", "", 0, 0.32, 0.01 },
        { NARROW, "hsao", "", 0, 0.32, 0.01 },
        { NARROWEST, "hsao", "", 0, 0.32, 0.01 },
        { BESIDE, "ssdo-points", POINTS, 0.9, 9, 1 },
        { BESIDE, "ssdo-points", POINTS CAMERAS, 0, 0.3, 0.003 },
        { BESIDE, "hsao-march", "directions=16,samples=24,blur=0,thickness=solid" CAMERAS, 0, 0.14, 0.003 },
        { AFLOAT, "ssdo-points", POINTS, 5, 9, 1 },
        { AFLOAT, "ssdo-points", POINTS CAMERAS, 0, 1.7, 0.006 },
        { LAMP, "ssbn", "", 0, 0.03, 0.001 },
        { UNDER_SKY, "ssbn", "", 0, 0.08, 0.04 },
        { AMONG_OBJECTS, "aof", FIELDS "8", 0, 0.16, 0.01 },
        { AMONG_OBJECTS, "aof", FIELDS "4", 0, 0.18, 0.01 },
        { AMONG_OBJECTS, "aof", FIELDS "8,normal=depth", 0, 0.25, 0.01 } };
    for (int p = 0, r = 0; p < PLACES; ++p) {
        const int width = place[p].width, height = place[p].height, lamps = place[p].light != NULL;
        OWN(kit_lighting) l = { 0 };
        OWN(kit_scene) scene = { 0 };
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_image) truth = { 0 };
        double open = 0;
        if (!see(&scene, &g, place[p].scene, place[p].added, place[p].boxes, place[p].camera, width, height)) return;
        kit_camera *const c = &scene.camera;
        for (int k = 0; k < 3 && place[p].lens > 0; ++k)
            c->eye[k] = c->target[k] + (float[3]) { 2, 3, 6 }[k] / 7 * 1.8f / tanf(place[p].lens * 0.00872664626f);
        if (place[p].lens > 0) { c->fovy = place[p].lens; c->znear = c->zfar = 0; }
        kit_gbuffer_free(&g);
        if (!lighten(&l, lamps ? place[p].env : "white", place[p].light)
            || !TRY(kit_gbuffer_from_scene(&g, &scene, c, NULL, &err)))
            return;
        const float radius = place[p].radius > 0 ? place[p].radius : scene.radius;
        const int rays = place[p].rays, linear = KIT_ATTENUATION_LINEAR;
        if (!TRY(lamps                ? kit_truth_lit(&truth, &scene, &g.camera, &l, radius, linear, 0, rays, 1, &err)
                 : p == AMONG_OBJECTS ? kit_truth_objects(&truth, &scene, &g.camera, rays, 1, &err)
                                      : kit_truth_ao(&truth, &scene, &g.camera, radius, linear, rays, 1, &err)))
            return;
        if (p == BALL) {
            turn_inside_out(&scene.mesh);
            kit_gbuffer_free(&g);
            if (!TRY(kit_gbuffer_from_scene(&g, &scene, c, NULL, &err))) return;
        }
        const float *const is = kit_image_channel(&truth, lamps ? "irradiance.G" : "Y");
        for (int i = 0; i < width * height; ++i)
            open += (lamps ? (double)is[i] : pow(1 - (double)is[i], 2)) / (width * height);
        for (; r < ROWS(row) && row[r].place == p; ++r) {
            const kit_world world = { &scene, &l };
            OWN(kit_image) out = { 0 };
            double square = 0, bias = 0;
            if (!TRY(kit_run_picture(&out, &g, &world, row[r].method, row[r].set, radius, &err))) return;
            const float *const got = kit_image_channel(&out, out.channels > 1 ? "irradiance.G" : "Y");
            for (int i = 0; i < width * height; ++i) {
                const double off = (double)got[i] - (double)is[i];
                square += off * off / (width * height);
                bias += off / (width * height);
            }
            const double share = sqrt(square) / (lamps ? open : sqrt(open));
            SHOW(share >= row[r].least && share <= row[r].most && fabs(bias) <= row[r].bias,
                 "%s, %s %s: RMSE %.4f, %.3f of it, bias %+.4f", place[p].name, row[r].method, row[r].set, sqrt(square),
                 share, bias);
        }
    }
}

void test_scenes(void)
{
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("plates, cards, a fence and emitters over a floor cover and send what they do", bars_cover_what_they_cover);
    RUN("bare planes at every slant stay open and get the sky's cosine integral, by every method", planes_stay_open);
    RUN("corners off the axis, a wall across the near plane and a white room are what directions meet",
        rooms_are_seen);
    RUN("depth layout, place in the textures and shift change no method's picture", layouts_do_not_matter);
    RUN("neither do units nor roll", units_do_not_matter);
    RUN("values that are set one by one, by their names, draw the same", uniforms_may_be_loose);
    RUN("nor does an orthographic eye that is far away or within what is seen, whichever way depth is given",
        eyes_stand_anywhere);
    RUN("nor does what engines have: left-handed, upside down, oblique, sampled, sliced", what_engines_have);
    RUN("pictures stand where they should in larger targets", targets_have_room);
    RUN("a ball turned inside out, narrow lenses, extra cameras and lamps are near their truth",
        near_their_truth);
    kit_fields_free();
    kit_gl_close();
}
