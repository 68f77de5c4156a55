/* test_light.c - ssdo, lights and emitters, drawn: the furnace (of s3ho, too), closed forms of corners and layers (of
   AO, too), shadows, virtual lights, margins. */
#include "t.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;

enum { W = 112, H = 63 };

/* ---- furnace ----------------------------------------------------------------------------------------------------- */

/* Replaces a run's emitters by copies with a radiance of 1, so that every surface sends light of 1. */
static int shine(kit_run *run)
{
    const ssgi_gl_desc *d = NULL;                                              /* of the last gather */
    for (int i = 0; i < run->passes; ++i)
        if (run->pass[i].desc.pass == SSGI_GL_PASS_SSDO || run->pass[i].desc.pass == SSGI_GL_PASS_S3HO)
            d = &run->pass[i].desc;
    const struct { const char *array; int width, height, slices;
    } held[2] = { { "t_ssgi_emitters", run->gbuffer->viewport[2], run->gbuffer->viewport[3],
                    d->gather.layers ? d->gather.layers : 1 },
                  { "t_ssgi_view_emitters", run->view[0].width, run->view[0].height,
                    d->gather.views * d->gather.view_layers } };
    const uint32_t one = 256u | 256u << 9 | 256u << 18 | 16u << 27;            /* 256 * 2^-8, three times */
    kit_run_update(run);
    kit_run_draw(run, 0);
    for (int k = 0; k < 2; ++k) {
        const size_t texels = (size_t)held[k].width * (size_t)held[k].height;
        FREED uint32_t *word = malloc(2 * texels * (size_t)held[k].slices * sizeof *word + 1);
        for (int s = 0; s < held[k].slices; ++s)
            if (!CHECK(!kit_texture_slice_read(kit_run_input(run, held[k].array, 0), s, held[k].width,
                                               held[k].height, 2, (float *)(word + 2 * texels * (size_t)s)),
                       "emitters cannot be read"))
                return 0;
        for (size_t i = 0; i < texels * (size_t)held[k].slices; ++i) word[2 * i] = one;
        if (held[k].slices)
            kit_run_input(run, held[k].array, run->texture[run->textures++] = kit_texture_array(
                held[k].width, held[k].height, held[k].slices, GL_RG32UI, (float *)word));
    }
    return 1;
}

static void furnace(void)
{
    enum { SMALL_W = 72, SMALL_H = 40 };
    enum {
        EXACT,
        ONE_SIDED /* at most 1 */,
        TWICE /* two gathers, whose rounded depths differ: but for a sample in 10,000 */,
        HALVES,
        KINDS
    };
    static const struct { const char *method, *scene, *set; int kind;
    } row[] = { { "ssdo-points", "room", "reuse=1,two_sided=1", EXACT },
                { "ssdo-points", "room", "reuse=1,two_sided=1,environment=sh", EXACT },
                { "ssdo-points", "room", "reuse=1,two_sided=1,fade=smooth,samples=2", EXACT },
                { "ssdo-points", "room", "reuse=1,two_sided=1,uniform_directions=1,sets=16,noise=texture", EXACT },
                { "ssdo-points", "columns", "reuse=1,two_sided=1,layers=2,views=2,view_size=64", EXACT },
                { "ssdo-points", "columns",
                  "reuse=1,two_sided=1,layers=3,views=2,view_size=64,view_layers=2,thickness=solid", EXACT },
                { "ssdo-points", "room", "reuse=1,two_sided=0", ONE_SIDED },
                { "ssdo-points", "columns", "reuse=1,two_sided=0,layers=2,views=2,view_size=64", ONE_SIDED },
                { "ssdo-points", "room", "two_sided=1", TWICE },
                { "ssdo-points", "columns", "two_sided=1,layers=2,views=2,view_size=64", TWICE },
                { "s3ho-points", "room", "two_sided=1,bands=1", EXACT },
                { "s3ho-points", "room", "two_sided=1,bands=2", EXACT },
                { "s3ho-points", "room", "two_sided=1,bands=2,uniform_directions=1", EXACT },
                { "s3ho-points", "columns", "two_sided=1,bands=3,fade=lambda,lambda=1,range_check=1,samples=2", EXACT },
                { "s3ho-points", "columns", "two_sided=1,layers=2,views=2,view_size=64", EXACT },
                { "s3ho-points", "room", "two_sided=0", ONE_SIDED },
                { "s3ho-points", "room", "two_sided=1,indirect=apart", TWICE },
                { "s3ho-points", "columns", "two_sided=1,indirect=apart,layers=2,views=2,view_size=64", TWICE },
                { "s3ho-points", "room", "two_sided=1,filtered=coefficients", HALVES },
                { "s3ho-points", "columns", "two_sided=1,filtered=coefficients,bands=3,blur=1", HALVES },
                { "ssdo", "room", "reuse=1,two_sided=1", EXACT },
                { "ssdo", "room", "reuse=1,two_sided=1,environment=sh,slices=3,falloff=square", EXACT },
                { "ssdo", "columns", "reuse=1,two_sided=1,thickness=back", EXACT },
                { "ssdo", "columns", "reuse=1,two_sided=1,thickness=slabs", ONE_SIDED },
                { "ssdo", "room", "reuse=1,two_sided=0", ONE_SIDED },
                { "ssdo", "room", "reuse=1,two_sided=1,resolution=half,blur=1,filter_normals=1", EXACT },
                { "s3ho", "room", "two_sided=1,bands=1", EXACT },
                { "s3ho", "columns", "two_sided=1,bands=2,thickness=solid", EXACT },
                { "s3ho", "room", "two_sided=1,bands=3,thickness=back", EXACT },
                { "s3ho", "room", "two_sided=1", EXACT },
                { "s3ho", "columns", "two_sided=0", ONE_SIDED },
                { "s3ho", "room", "two_sided=1,filtered=coefficients,bands=3,resolution=half,blur=1", HALVES } };
    static const float uniform[3] = { 3.5449077f, 3.5449077f, 3.5449077f };
    static const int allowed[KINDS] = { 0, SMALL_W * SMALL_H, 33 * SMALL_W * SMALL_H / 10000, 0 };
    double worst[KINDS] = { 0 };
    OWN(kit_lighting) l = { 0 };
    if (!lighten(&l, NULL, NULL) || !TRY(kit_image_new(&l.env, 32, 16, "R,G,B", &err))) return;
    for (int i = 0; i < 3 * 32 * 16; ++i) l.env.data[i] = 1;
    for (int i = 0; i < ROWS(row); ++i) {
        double least = 2, most = 0;
        const int kind = row[i].kind;
        const double within = kind == HALVES ? 2e-3 : 1e-5;
        int off = 0;
        OWN(scenery) s = { 0 };
        OWN(kit_run) run = { 0 };
        OWN(kit_image) out = { 0 };
        if (!set_scene(&s, row[i].scene, NULL, NULL, NULL, SMALL_W, SMALL_H)
            || !begin(&run, &s.g, row[i].method, row[i].set, s.scene.radius, &s.scene, &l))
            return;
        /* sets exact harmonics: those of the projected picture would have a few 1e-6 in higher bands */
        ssgi_gl_harmonics_set(&run.frame, uniform, 1, NULL, NULL);
        if (!shine(&run) || !drawn(&out, &run)) return;
        const float *light = kit_image_channel(&out, "irradiance.G"), *bounce = kit_image_channel(&out, "bounce.G");
        for (int k = 0; k < SMALL_W * SMALL_H; ++k) {
            const double v = (double)light[k] + (double)bounce[k];
            least = fmin(least, v);
            most = fmax(most, v);
            off += fabs(v - 1) > within;
        }
        CHECK(mean(&out, "bounce.G") > 0.02 && off <= allowed[kind] && most <= 1 + within + (kind == TWICE ? 0.125 : 0)
                  && (kind == ONE_SIDED) == (least < 0.9),
              "%s %s %s: %.6f to %.6f, %d pixels off", row[i].method, row[i].scene, row[i].set, least, most, off);
        worst[kind] = fmax(worst[kind], kind == TWICE ? off : fmax(most - 1, 1 - least));
    }
    t_note("one gather: %.1e off at most, with halves %.1e; two: %g pixels are", worst[EXACT], worst[HALVES],
           worst[TWICE]);
}

/* Checks that a white corner in uniform light sends all that comes in by bounces without end; by one bounce less. */
static void further_bounces(void)
{
    static const char *const sets[2] = { "reuse=1,two_sided=1", "reuse=1,two_sided=1,bounced=1" };
    double plane[2][4], least[2] = { 2, 2 }, most = 0;
    kit_camera camera = corner_planes(plane, 0.3, 0);
    OWN(kit_lighting) l = { 0 };
    OWN(kit_image) frame = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    camera.width /= 4;
    camera.height /= 4;
    if (!lighten(&l, "white", NULL)
        || !planes_seen(&frame, &camera, (const double (*)[4])plane, 2, ",albedo.R,albedo.G,albedo.B"))
        return;
    const size_t pixels = (size_t)frame.width * (size_t)frame.height;
    for (size_t i = 0; i < 3 * pixels; ++i) frame.data[4 * pixels + i] = 1;
    if (!TRY(kit_gbuffer_from_frame(&g, &frame, &camera, &err))) return;
    for (int k = 0; k < 2; ++k) {
        OWN(kit_image) out = { 0 };
        OWN(kit_run) run = { 0 };
        if (!begin(&run, &g, "ssdo", sets[k], 1, NULL, &l) || !drawn(&out, &run)) return;
        for (size_t i = 0; i < pixels; ++i) {
            const double v = (double)kit_image_channel(&out, "irradiance.G")[i]
                           + (double)kit_image_channel(&out, "bounce.G")[i];
            if (!(kit_image_channel(&frame, "Z")[i] > 0)) continue;
            least[k] = fmin(least[k], v);
            if (k) most = fmax(most, v);
        }
    }
    SHOW(least[0] < 0.9 && least[1] > 0.99 && most < 1.01, "one bounce leaves %.4f, further ones %.4f to %.4f",
         least[0], least[1], most);
}

/* ---- the corner -------------------------------------------------------------------------------------------------- */

static double square_corner(double c)
{
    const double s = sqrt(1 - c * c);
    return (acos(c) - 3 * c * s + 2 * c * c * acos(c)) / pi;
}
/* Returns the bounce of a wall that sends 1, by the paper's patches without clamping: a sum over directions. */
static double patch_corner(double c) { return c < 0.2 ? 0.5523 : c < 0.4 ? 0.19207 : 0.050944; }

enum { DARK, SENDS, BACK /* the wall's normals point away from the floor */ };

/* Makes the corner's G-buffer. The floor sends nothing. */
static int corner(kit_gbuffer *g, double c, int wall)
{
    double plane[2][4];
    const kit_camera camera = corner_planes(plane, c, 0);
    const size_t pixels = (size_t)WIDE * HIGH;
    OWN(kit_image) frame = { 0 };
    int ok = planes_seen(&frame, &camera, (const double (*)[4])plane, 2,
                         ",direct.R,direct.G,direct.B,back.Z,front2.Z,back2.Z");
    for (size_t i = 0; ok && i < 3 * pixels; ++i)
        frame.data[4 * pixels + i] = wall && frame.data[2 * pixels + i % pixels] < 0;
    for (size_t i = 0; ok && i < 3 * pixels; ++i)
        if (wall == BACK && frame.data[4 * pixels + i % pixels] > 0) frame.data[pixels + i] *= -1;
    return ok && TRY(kit_gbuffer_from_frame(g, &frame, &camera, &err));
}

/* Checks the dark share of a white sky, and the light of the wall, before an endless wall and before slabs. Few samples
   miss an expected share of the free directions, as an occluder between two samples lies, on the mean, between their
   distances. The paper's areas of patches suit uniform directions. Our midpoints of strata miss some light near the
   horizon: 1/sqrt(N) a third. */
static void corners_are_closed_forms(void)
{
#define POINTS "bounce=none,directions=64,thickness=solid,"
#define LAYERED(layers) POINTS "thickness_limit=0.282843,layers=" layers
#define WITHIN(off) -(off), off
#define ENDLESS 0, 0, 0, 0
#define FEW_TAPS 0.013, 0.023, 0.25, 0, 0, 0
    static const double at[3] = { 0.1, 0.25, 0.5 }, gap = 0.15, reach = 0.2; /* across, without a back */
    static const struct {
        const char *method, *set;
        double (*falls)(double c);
        int steps, wall, phases;
        double low, high;                      /* limits of the error; in rows of SENDS, as a share of the truth */
        double c, thickness;                   /* of a slab */
        int layers, ends;
    } row[] = {
        { "ssdo-points", POINTS "falloff=linear", linear_corner, 1, DARK, 8, WITHIN(0.003), ENDLESS },
        { "ssdo-points", POINTS "falloff=square", square_corner, 1, DARK, 8, WITHIN(0.003), ENDLESS },
        { "ssdo-points", POINTS "samples=2", linear_corner, 2, DARK, 8, WITHIN(0.003), ENDLESS },
        { "ssdo-points", POINTS "samples=4", linear_corner, 4, DARK, 8, WITHIN(0.003), ENDLESS },
        { "ssdo-points", POINTS "uniform_directions=1", linear_corner, 1, DARK, 8, WITHIN(0.003), ENDLESS },
        { "ssdo-points", POINTS "uniform_directions=1,environment=sh", linear_corner, 1, DARK, 8, WITHIN(0.003),
          ENDLESS },
        { "ssdo-points", POINTS "environment=sh", linear_corner, 1, DARK, 8, WITHIN(0.003), ENDLESS },
        { "ssao", "directions=64,samples=1,thickness=solid", linear_corner, 1, DARK, 4, WITHIN(0.004), ENDLESS },
        { "hsao-best", "slices=8,samples=48", linear_corner, 1, DARK, 4, WITHIN(0.002), ENDLESS },
        { "hsao-best", "slices=8,samples=48,falloff=none", hard_corner, 1, DARK, 4, WITHIN(0.01), ENDLESS },
        { "hsao-best", "slices=2,samples=8,thickness=solid", linear_corner, 1, DARK, 32, FEW_TAPS },
        { "hsao-best", "slices=2,samples=8,thickness=constant", linear_corner, 1, DARK, 32, FEW_TAPS },
        { "hsao-best", "slices=2,samples=8,thickness=back", linear_corner, 1, DARK, 32, FEW_TAPS },
        { "hsao-best", "slices=2,samples=8,thickness=slabs", linear_corner, 1, DARK, 32, FEW_TAPS },
        { "ssdo-points", "thickness=solid,directions=16", linear_corner, 1, SENDS, 64, WITHIN(0.01), ENDLESS },
        { "ssdo-points", "thickness=solid,directions=16,uniform_directions=1", linear_corner, 1, SENDS, 64,
          WITHIN(0.02), ENDLESS },
        { "ssdo", "thickness=solid,slices=8", linear_corner, 1, SENDS, 64, WITHIN(0.02), ENDLESS },
        { "ssdo-points", "thickness=solid,bounce=patch,distance_clamp=0,directions=64", patch_corner, 1, SENDS, 64,
          WITHIN(0.05), ENDLESS },
        { "ssdo-points", "thickness=solid,bounce=patch,distance_clamp=0,directions=16", patch_corner, 1, SENDS, 64,
          WITHIN(0.1), ENDLESS },
        { "ssdo-points", "thickness=solid,bounce=patch,distance_clamp=0,directions=16,uniform_directions=1,sets=16",
          patch_corner, 1,
          SENDS, 64, WITHIN(0.06), ENDLESS },
        { "ssdo-points", "thickness=solid,directions=16,two_sided=1", linear_corner, 1, BACK, 64, WITHIN(0.01),
          ENDLESS },
        { "ssdo-points", "thickness=solid,directions=16,two_sided=0", linear_corner, 1, BACK, 8, -1, -1, ENDLESS },
        { "ssdo-points", LAYERED("2"), linear_corner, 1, DARK, 8, WITHIN(0.003), 0.1, 0.05, 2, 0 },
        { "ssdo-points", LAYERED("2"), linear_corner, 1, DARK, 8, WITHIN(0.003), 0.1, 0.25, 2, 0 },
        { "ssdo-points", LAYERED("2"), linear_corner, 1, DARK, 8, WITHIN(0.003), 0.25, 0.1, 2, 0 },
        { "ssdo-points", LAYERED("2"), linear_corner, 1, DARK, 8, WITHIN(0.003), 0.5, 0.25, 2, 0 },
        { "ssdo-points", LAYERED("1"), linear_corner, 1, DARK, 8, WITHIN(0.003), 0.1, 0.05, 1, 0 },
        { "ssdo-points", LAYERED("3"), linear_corner, 1, DARK, 8, WITHIN(0.003), 0.25, 0.1, 3, 0 },
        { "ssdo-points", LAYERED("3,thickness=constant"), linear_corner, 1, DARK, 8, WITHIN(0.003), 0.25, 0.1, 3, 1 },
        { "ssdo-points", LAYERED("1,thickness=constant"), linear_corner, 1, DARK, 8, WITHIN(0.003), 0.25, 0.1, 1, 1 } };
    const kit_lighting dark = { .lights = 0 };
    OWN(kit_lighting) white = { 0 };
    kit_gbuffer g[3];
    if (!lighten(&white, "white", NULL)) return;
    for (int m = 0, seen = -1; m < ROWS(row); ++m) {
        OWN(kit_gbuffer) slabs = { 0 };
        OWN(kit_run) run = { 0 };
        const int layers = row[m].layers;
        const double k = row[m].steps;
        double got = 0;
        int judged = 0;
        if (layers ? !slab(&slabs, row[m].c, row[m].thickness, gap, layers) : 0) return;
        for (int i = 0; i < 3 && seen != row[m].wall; ++i) {
            if (seen >= 0) kit_gbuffer_free(&g[i]);
            if (!corner(&g[i], at[i], row[m].wall)) return;
        }
        seen = row[m].wall;
        if (!begin(&run, layers ? &slabs : &g[0], row[m].method, row[m].set, 1, NULL, seen == DARK ? &white : &dark))
            return;
        for (int i = 0; i < 3; ++i) {
            const double c = layers ? row[m].c : at[i], back = c + row[m].thickness, next = back + gap;
            if (row[m].c > 0 && (layers ? i > 0 : fabs(c - row[m].c) > 0)) continue;
            double truth = k * row[m].falls(c) - (k > 1 ? (k - 1) * row[m].falls(fmin(1, k * c / (k - 1))) : 0);
            if (layers > 1) truth -= linear_corner(back);
            else if (row[m].ends) truth -= linear_corner(c + reach);
            if (layers > 2) truth += linear_corner(next) - (row[m].ends ? linear_corner(next + reach) : 0);
            got = row_of(&run, layers ? &slabs : &g[i], row_at(c), row[m].phases);
            const double off = seen == DARK ? 1 - got - truth : got / truth - 1;
            ++judged;
            CHECK(off >= row[m].low && off <= row[m].high, "%s %s, c %g, %g thick: %+.4f off %.4f", row[m].method,
                  row[m].set, c, row[m].thickness, off, truth);
            if (seen == SENDS && run.kernel && i == 2) {   /* replaces a kernel direction by a level one */
                static const float level[4] = { 0.6f, 0.8f, 0, 0.5f };
                glBindTexture(GL_TEXTURE_2D, run.kernel);
                glTexSubImage2D(GL_TEXTURE_2D, 0, 3, 0, 1, 1, GL_RGBA, GL_FLOAT, level);
                const double is = row_of(&run, &g[i], row_at(c), 64);
                CHECK(fabs(is - got) < 0.01 * got, "%s, a level direction: %.4f, without it %.4f", row[m].set, is, got);
            }
        }
        CHECK(judged, "%s %s: %g is none of the distances before an endless wall", row[m].method, row[m].set, row[m].c);
    }
    for (int i = 0; i < 3; ++i) kit_gbuffer_free(&g[i]);
}

/* ---- lights ------------------------------------------------------------------------------------------------------ */

/* Checks the floor y = 0 before a wall from z = -1 to -1.1, with one light before and one behind the wall, both nearer
   than the radius. */
static void segments_end_at_lights(void)
{
    static const box wall = { { -3, 0, -1.1f }, { 3, 1.5f, -1 } };
    static const struct { const char *light, *set; double z; int shadowed; } row[] = {
        { "point:0,0.3,-0.6,2,2,2", "solid=1", -0.6, 0 }, { "point:0,0.3,-0.6,2,2,2", "solid=0", -0.6, 0 },
        { "point:0,0.3,-1.6,2,2,2", "solid=1", -1.6, 1 }, { "point:0,0.3,-1.6,2,2,2", "solid=0", -1.6, 1 } };
    const kit_camera camera = { { 0, 3, 2 }, { 0, 0.2f, -0.6f }, { 0, 1, 0 },     40, 0, 0.1f, 20, W,
                                H,           { 0, 0 },           KIT_DEPTH_NORMAL };
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    if (!see(&scene, &g, "plane", &wall, 1, &camera, W, H)) return;
    for (int m = 0; m < 4; ++m) {
        OWN(kit_image) out = { 0 };
        kit_lighting l;
        char set[96];
        double worst = 0;
        int n = 0, dark = 0;
        snprintf(set, sizeof set, "bounce=none,shadows=segment,points=32,%s", row[m].set);
        if (!lighten(&l, NULL, row[m].light) || !lit(&out, &g, "ssdo-points", set, 2, NULL, &l)) return;
        for (int i = 0; i < W * H; ++i) {
            float o[3], d[3];
            kit_camera_ray(&scene.camera, i % W, i / W, o, d);
            const double t = -(double)o[1] / (double)d[1], x = (double)o[0] + t * (double)d[0],
                         z = (double)o[2] + t * (double)d[2];
            if (fabs(x) > 0.5 || z < -0.5 || z > 0.3) continue;
            const double dd = x * x + 0.3 * 0.3 + (z - row[m].z) * (z - row[m].z),
                         open = 2 * 0.3 / (dd * sqrt(dd)) / pi, v = (double)out.data[3 * W * H + i];
            worst = fmax(worst, fabs(v / open - 1));
            dark += v <= 0;
            ++n;
        }
        CHECK(n > 300 && (row[m].shadowed ? dark == n : worst < 1e-3), "%s, %s: %d of %d pixels are dark, off by %.2e",
              row[m].light, row[m].set, dark, n, worst);
    }
}

/* ---- shadow maps ------------------------------------------------------------------------------------------------- */

/* Checks a sun that shines down -z on a plane that is tilted by this angle, half to the right and half up, so that it
   slopes along the diagonal of the map's texels. */
static void planes_do_not_shadow_themselves(void)
{
    static const double tilts[] = { 60, 70, 80 };
    kit_lighting l;
    int wrong = 0, seen = 0;
    if (!lighten(&l, NULL, "sun:0,0,1,3,3,3")) return;
    for (int k = 0; k < 6; ++k) {
        const double tilt = tilts[k % 3] * pi / 180, r = sqrt(0.5);
        const double n[3] = { r * sin(tilt), r * sin(tilt), cos(tilt) }, u[3] = { r, -r, 0 },
                     v[3] = { r * cos(tilt), r * cos(tilt), -sin(tilt) };
        OWN(kit_scene) scene = { 0 };
        OWN(kit_gbuffer) g = { 0 };
        OWN(kit_image) out = { 0 };
        if (!TRY(kit_scene_load(&scene, "plane", 0, &err))) return;
        for (size_t i = 0; i < 3 * scene.mesh.triangles; ++i) {     /* moves the vertices of the plane y = 0 */
            float *p = scene.mesh.position + 3 * i, *m = scene.mesh.normal + 3 * i;
            const double x = (double)p[0], z = (double)p[2];
            for (int j = 0; j < 3; ++j) { p[j] = (float)(0.02 * (x * u[j] + z * v[j])); m[j] = (float)n[j]; }
        }
        for (int j = 0; j < 3; ++j) {
            scene.mesh.lower[j] = -2; scene.mesh.upper[j] = 2;
            scene.camera.eye[j] = (float)(2 * n[j] + 0.5 * u[j]);
            scene.camera.target[j] = 0;
        }
        scene.camera.width = W; scene.camera.height = H;
        if (!TRY(kit_gbuffer_from_scene(&g, &scene, &scene.camera, NULL, &err))
            || !lit(&out, &g, "ssdo-points",
                    k < 3 ? "bounce=none,shadows=map,shadow_size=256" : "bounce=none,shadows=fill,shadow_size=256",
                    0.2f, &scene, &l))
            return;
        for (int i = 0; i < W * H; ++i) {
            const double light = (double)out.data[3 * W * H + i];
            seen += light > 0;
            wrong += !(fabs(light - 3 * cos(tilt) / pi) < 1e-4);
        }
    }
    CHECK(!wrong && seen > 3 * W * H, "%d pixels of a bare plane, of %d, are in shadow or wrong", wrong, seen);
}

/* Returns the distance from each pixel's surface to a sun's first occluder; 0: none, -1: no surface. To be freed. */
static float *blockers_new(const kit_scene *scene, const kit_light *sun)
{
    const int width = scene->camera.width, height = scene->camera.height;
    const size_t size = ssgi_trace_size(scene->mesh.triangles);
    float *distance = calloc((size_t)width * (size_t)height, sizeof *distance);
    FREED void *memory = malloc(size);
    ssgi_trace trace;
    if (!CHECK(distance && memory
                   && ssgi_trace_build(&trace, memory, size, scene->mesh.position, 12, NULL, scene->mesh.triangles,
                                       NULL)
                          == SSGI_OK,
               "no trace"))
        return NULL;
    for (int i = 0; i < width * height; ++i) {
        float o[3], d[3];
        ssgi_hit hit, occluder;
        kit_camera_ray(&scene->camera, i % width, i / width, o, d);
        distance[i] = -1;
        if (!ssgi_trace_closest(&hit, &trace, o, d, 0, INFINITY)) continue;
        for (int k = 0; k < 3; ++k) o[k] += d[k] * (hit.t - 1e-4f);
        distance[i] = ssgi_trace_closest(&occluder, &trace, o, sun->at, 0, INFINITY) ? occluder.t : 0;
    }
    return distance;
}

/* Checks a sun's maps, with and without filling, against rays toward the sun. COVERED: over a hundred shapes to the far
   end of the ground; far ones still get their shadows. FILLED, pebbles: the maps' bias loses contact shadows, and
   filling brings a third back. SPARED: coarse maps, and creases a pixel wide: filling hardly adds a wrong shadow. */
static void suns_shadow_what_they_should(void)
{
    enum { COVERED, FILLED, SPARED };
    enum { LOST /* lit, though occluded */, CONTACT /* of these, near the occluder */, RIGHT, PARTS };
    static const struct { const char *scene, *light, *set; int width; } row[] = {
        { "crowd", "sun:1,0.3,0.5,3,3,3", "bounce=none,shadow_size=2048", 320 },
        { "pebbles", "sun:1,0.35,0.3,3,3,3", "bounce=none,shadow_size=512", 640 },
        { "boxes", "sun:1,0.35,0.3,3,3,3", "bounce=none,shadow_size=128", 320 } };
    static const kit_camera low = { { 0, 0.6f, 9 }, { 0, 0.3f, -5 }, { 0, 1, 0 }, 40, 0, 0.05f, 60, 0, 0, { 0 },
                                    KIT_DEPTH_REVERSED };
    for (int r = 0; r < ROWS(row); ++r) {
        const int width = row[r].width, height = width * 9 / 16;
        int count[2][PARTS] = { { 0 } }, dark = 0, open = 0;
        OWN(scenery) s = { 0 };
        if (!set_scene(&s, row[r].scene, r == COVERED ? &low : NULL, NULL, row[r].light, width, height)) return;
        FREED float *distance = blockers_new(&s.scene, &s.light.light[0]);
        for (int fill = 0; fill < 2 && distance; ++fill) {
            OWN(kit_image) out = { 0 };
            char set[96];
            snprintf(set, sizeof set, "%s,shadows=%s", row[r].set, fill ? "fill" : "map");
            if (!lit(&out, &s.g, "ssdo-points", set, s.scene.radius, &s.scene, &s.light)) return;
            for (int i = 0; i < width * height; ++i) {
                const int shines = out.data[3 * width * height + i] > 0;
                count[fill][LOST] += shines && distance[i] > 0;
                count[fill][CONTACT] += shines && distance[i] > 0 && distance[i] < 0.01f;
                count[fill][RIGHT] += shines && !(distance[i] > 0);
                dark += !fill && distance[i] > 0;
                open += !fill && distance[i] <= 0 && distance[i] > -1;
            }
        }
        const int *const map = count[0], *const fill = count[1], spoilt = map[RIGHT] - fill[RIGHT];
        SHOW(r == COVERED  ? map[LOST] <= 160 && open - map[RIGHT] <= 200 && dark > 10000
             : r == FILLED ? fill[CONTACT] <= 0.7 * map[CONTACT] && map[CONTACT] > 100 && spoilt < 0.0015 * map[RIGHT]
                           : spoilt <= map[LOST] - fill[LOST],
             "%s: of %d dark pixels %d are lit by maps, %d filled, at contacts %d and %d; of %d lit ones %d and %d",
             row[r].scene, dark, map[LOST], fill[LOST], map[CONTACT], fill[CONTACT], open, map[RIGHT], fill[RIGHT]);
    }
}

/* Checks that in a closed box direct light is exact, and virtual lights add the bounce from beyond the radius. */
static void point_light_in_a_box(void)
{
    enum { MAP, FILL, VIRTUAL, BOTH, NEAR_ALONE, WAYS };
    static const char *const sets[WAYS] = { "bounce=none,shadows=map", "bounce=none,shadows=fill",
                                            "bounce=none,vpls=64,shadow_size=256",
                                            "bounce=solid-angle,vpls=64,shadow_size=256", "bounce=solid-angle" };
    OWN(scenery) s = { 0 };
    OWN(kit_image) truth = { 0 };
    double share[WAYS] = { 0 }, splash = 0;
    if (!set_scene(&s, "cornell", NULL, NULL, "point:0,5,-2.8,15,15,15", W, H)
        || !TRY(kit_truth_lit(&truth, &s.scene, &s.scene.camera, &s.light, INFINITY, KIT_ATTENUATION_NONE, 1, 64, 1,
                              &err)))
        return;
    const float *const direct = kit_image_channel(&truth, "irradiance.G"),
                *const bounced = kit_image_channel(&truth, "bounce.G");
    for (int m = 0; m < WAYS; ++m) {
        OWN(kit_image) out = { 0 };
        int bright = 0, dark = 0;
        if (!lit(&out, &s.g, "ssdo-points", sets[m], s.scene.radius, &s.scene, &s.light)) return;
        const float *const a = kit_image_channel(&out, "irradiance.G"), *const b = kit_image_channel(&out, "bounce.G");
        for (int i = 0; i < W * H; ++i) {
            bright += a[i] - direct[i] > 0.1f * a[i];
            dark += direct[i] - a[i] > 0.1f * direct[i];
            if (m == VIRTUAL) splash = fmax(splash, (double)(b[i] - bounced[i]) / mean(&truth, "bounce.G"));
        }
        share[m] = mean(&out, "bounce.G") / mean(&truth, "bounce.G");
        CHECK(bright + dark < W * H / 100, "%s: %d of %d pixels too bright, %d too dark", sets[m], bright, W * H, dark);
    }
    SHOW(splash < 4 && fabs(share[VIRTUAL] - 1) < 0.25 && share[BOTH] <= 1.1 && share[BOTH] > share[VIRTUAL],
         "virtual lights bring %.3f of the bounce, with the near bounce %.3f, a bounce within the radius alone %.3f; "
         "brightest splash %.2f of the mean",
         share[VIRTUAL], share[BOTH], share[NEAR_ALONE], splash);
}

/* Checks that a picture with a margin is the middle of a larger one, bit by bit, and nothing else is drawn. */
static void margins(void)
{
    static const struct { const char *method, *set; int rim; } rows[] = {
        { "ssao", "directions=5,normal=depth,blur=2", 6 }, { "hsao", "slices=1,samples=3,blur=2", 6 },
        { "hsao-best", "slices=1,samples=3,blur=0", 0 },
        { "hsao-march", "directions=2,samples=3,normal_rays=1,layers=2", 4 },
        { "ssdo-points", "directions=4,samples=1,environment=none", -1 },
        { "ssdo", "slices=1,samples=3,resolution=half,bounce=none", 4 },
        { "ssdo", "slices=1,samples=3,resolution=full,reuse=1", -1 },
        { "s3ho", "slices=1,samples=3,bands=2,resolution=half", -1 },
        { "s3ho-points", "directions=4,samples=1,bands=2,filtered=coefficients,indirect=apart,blur=2", -1 },
        { "ssbn", "slices=1,samples=3,resolution=full,blur=0", 0 } };
    const kit_camera camera = { { 4.55f, 1.75f, 4.25f }, { 1.35f, 0.85f, 0.85f }, { 0, 1, 0 }, 0, 3, 0.1f, 12, 67, 49,
                                { 3, -2 }, KIT_DEPTH_NORMAL };
    OWN(scenery) s = { 0 };
    if (!set_scene(&s, "room", &camera, "sky", "sun:1,2,1,3,3,3", 67, 49)) return;
    for (int r = 0; r < ROWS(rows); ++r) {
        OWN(kit_run) run = { 0 };
        OWN(kit_gbuffer) wide = { 0 };
        char set[128];
        OWN(kit_image) inner = { 0 }, whole = { 0 };
        int off = 0, shown = 0;
        /* orthographic: 0.45 units are 0.45 * 49 / 3 = 7.35 pixels, 1.5 radii 11.03: more than 49 / 16 * 4 */
        const int expected = r % 2 ? 12 : 8;
        snprintf(set, sizeof set, "%s,margin=%s", rows[r].set, r % 2 ? "1.7" : "1");
        if (!TRY(kit_gbuffer_widen(&wide, &s.g, &s.scene, expected, &err))
            || !open_run(&run, &wide, rows[r].method, rows[r].set, 0.45f, &s.scene, &s.light) || !drawn(&whole, &run))
            return;
        kit_run_close(&run);
        if (!open_run(&run, &s.g, rows[r].method, set, 0.45f, &s.scene, &s.light) || !drawn(&inner, &run)) return;
        CHECK(run.margin == expected, "%s: a margin of %d pixels, not %d", rows[r].method, run.margin, expected);
        CHECK(inner.width == 67 && inner.height == 49, "%s: the picture is %d x %d", rows[r].method, inner.width,
              inner.height);
        for (int c = 0; c < inner.channels; ++c)
            for (int y = 0; y < inner.height; ++y)
                off += memcmp(inner.data + (c * 49 + y) * 67, kit_image_channel(&whole, inner.name[c])
                              + (y + expected) * whole.width + expected, 67 * sizeof(float)) != 0;
        CHECK(!off, "%s %s: %d rows are not those of a larger picture", rows[r].method, rows[r].set, off);
        const kit_pass *p =
            &run.pass[run.pass[0].desc.pass == SSGI_GL_PASS_THICKNESS]; /* thickness is measured on all that is seen */
        const int half = p->desc.gather.resolution ? 2 : 1, drawn_columns = half * p->box[2];
        CHECK(rows[r].rim < 0 ? !p->box[2] : abs(drawn_columns - 67 - 2 * rows[r].rim) < half, "%s %s: its first pass "
              "draws %d columns", rows[r].method, rows[r].set, drawn_columns);
        for (int i = 0; i < run.passes; ++i) shown += run.pass[i].box[2] == 67 && run.pass[i].box[3] == 49;
        CHECK(shown, "%s %s: no pass draws the picture alone", rows[r].method, rows[r].set);
    }
}

void test_light(void)
{
    if (!CHECK(!kit_gl_open(NULL, &err), "%s", err.text)) return;
    RUN("furnace: in uniform light every pixel gets exactly what comes in", furnace);
    RUN("further bounces: a white corner in uniform light ends as bright as what comes in", further_bounces);
    RUN("a corner and slabs darken and send by their closed forms, whatever the estimator", corners_are_closed_forms);
    RUN("a segment ends at its light", segments_end_at_lights);
    RUN("with a margin the picture is the middle of a larger one, drawn alone", margins);
    RUN("a plane does not shadow itself in a map", planes_do_not_shadow_themselves);
    RUN("a sun's maps cover all that is seen, and what is filled is in shadow", suns_shadow_what_they_should);
    RUN("a point light, and its virtual lights", point_light_in_a_box);
    kit_gl_close();
}
