/* test_plan.c - the plan of a scene: survey, calibration, choice. */
#include "t.h"
#include "frames.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static ssgi_plan made(const ssgi_plan_scene *s)
{
    ssgi_plan p;
    const char *why = "";
    memset(&p, 0, sizeof p);
    CHECK(ssgi_plan_make(&p, s, &why) == SSGI_OK && *p.why && strlen(p.why) < sizeof p.why,
          "a plan of good numbers: \"%s\"", why);
    return p;
}

/* Checks facts that follow from a scene's numbers, whatever the table was fitted to. */
static void follows(void)
{
    const float left[3] = { -1, 0.6f, 0.3f }, right[3] = { 1, 0.6f, 0.3f }, pink[3] = { 3.3f, 0.9f, 1.9f },
                turquoise[3] = { 0.5f, 2.3f, 2.2f };
    float sh[48] = { 0 };
    ssgi_plan_scene s = { .wanted = SSGI_PLAN_WANTED_LIGHT,
                          .screen_radius = 0.2f,
                          .calibration = { 1, 0.15f, 0.045f, 0.04f, 0, 0 },
                          .thickness = SSGI_PLAN_THICKNESS_SLABS,
                          .surfels = 0.2,
                          .map = 1 };
    ssgi_plan p;
    for (int c = 0; c < 3; ++c) sh[c] = 3.5449077f * pink[c];
    ssgi_sh_energy(s.energy, 4, sh, 3);
    CHECK(s.energy[0] > 1 && s.energy[1] + s.energy[2] + s.energy[3] < 1e-6f * s.energy[0],
          "a constant sky has energies %g %g %g %g", (double)s.energy[0], (double)s.energy[1], (double)s.energy[2],
          (double)s.energy[3]);
    for (s.error = 0.046f; s.error < 0.16f; s.error += 0.01f) {
        p = made(&s);
        CHECK(p.meets && !p.bands && (p.method == SSGI_PLAN_METHOD_HSAO || p.method == SSGI_PLAN_METHOD_NOTHING),
              "under a constant sky, for %g: %s", (double)s.error, p.why);
    }
    memset(sh, 0, sizeof sh);
    ssgi_sh_light(sh, 4, left, 0.25f, pink, SSGI_SH_WINDOW_NONE, NULL);
    ssgi_sh_light(sh, 4, right, 0.25f, turquoise, SSGI_SH_WINDOW_NONE, NULL);
    ssgi_sh_energy(s.energy, 4, sh, 3);
    s.calibration = (ssgi_calibration){ 1, 0.16f, 0.13f, 0.12f, 0, 0 };
    s.thickness = s.map = 0;
    int bands = 0;
    for (s.error = 0.106f; s.error < 0.125f; s.error += 0.004f) {
        p = made(&s);
        CHECK(!p.meets || p.method == SSGI_PLAN_METHOD_HSAO || (p.method == SSGI_PLAN_METHOD_S3HO && p.bands > 1),
              "under two lights, for %g: %s, %d bands", (double)s.error, p.why, p.bands);
        bands += p.meets && p.method == SSGI_PLAN_METHOD_S3HO;
    }
    CHECK(bands >= 2, "under two lights harmonics are taken %d times", bands);

    /* The plan may use nothing that the scene does not give. */
    memset(&s, 0, sizeof s);
    s.calibration = (ssgi_calibration){ 1, 0.15f, 0.07f, 0.03f, 0, 0 };
    s.map = 1;
    for (s.wanted = 0; s.wanted < 3; ++s.wanted)
        for (int given = 0; given <= SSGI_PLAN_THICKNESS_SLABS; ++given)
            for (s.error = 0.01f; s.error < 0.2f; s.error *= 1.3f) {
                s.thickness = given;
                p = made(&s);
                CHECK((p.thickness <= given || p.thickness == SSGI_PLAN_THICKNESS_CONSTANT) && !p.history
                          && p.method != SSGI_PLAN_METHOD_DSS,
                      "%d given, %g of %d: %s", given, (double)s.error, s.wanted, p.why);
            }
    /* Slabs are chosen if they help and depth passes are cheap. If no choice meets the error, the plan has the nearest
       one. */
    s.wanted = SSGI_PLAN_WANTED_VISIBILITY;
    s.thickness = SSGI_PLAN_THICKNESS_SLABS;
    s.error = 0.035f;
    p = made(&s);
    CHECK(p.meets && p.thickness == SSGI_PLAN_THICKNESS_SLABS
              && strstr(p.why, " slabs is the cheapest choice for an error of 0.0350: error 0.0"), "%s", p.why);
    s.depth_pass = 1000;
    s.device = SSGI_PLAN_DEVICE_GPU;
    s.calibration.hsao = 0.1f;
    s.surfels = 0.02;
    s.error = 0.0889f;
    p = made(&s);
    CHECK(p.meets && p.method == SSGI_PLAN_METHOD_DSS, "slabs at a thousand a pass: %s", p.why);
    s.surfels = 0.4;
    p = made(&s);
    CHECK(p.meets && p.method == SSGI_PLAN_METHOD_HSAO && !p.thickness, "twenty times as many surfels: %s", p.why);
    s = (ssgi_plan_scene){ .calibration = { 1, 0.15f, 0.07f, 0.03f, 0, 0 }, .error = 0.001f };
    p = made(&s);
    CHECK(!p.meets && p.method == SSGI_PLAN_METHOD_HSAO
              && !strncmp(p.why, "Cannot be met: an error of 0.0010. hsao", 39),
          "0.001 of hsao: %s", p.why);

    /* A budget is kept, and a larger one never has a larger error. A smaller error never costs less. Costs grow with
       splats and occluders. */
    s = (ssgi_plan_scene){ .calibration = { 1, 0.15f, 0.05f, 0.04f, 0, 0 },
                           .thickness = SSGI_PLAN_THICKNESS_SLABS,
                           .history = 1,
                           .surfels = 0.2,
                           .occluders = 10,
                           .map = 1 };
    for (s.wanted = 0; s.wanted < 4; ++s.wanted) {
        float last = 1e9f, cost = 0;
        s.error = 0;
        for (s.budget = 0.01f; s.budget < 200; s.budget *= 1.5f) {
            p = made(&s);
            CHECK(p.cost <= s.budget && p.error <= last + 1e-6f && !p.meets, "budget %g of %d: %s", (double)s.budget,
                  s.wanted, p.why);
            last = p.error;
        }
        s.budget = 0;
        for (s.error = 0.2f; s.error > 0.02f; s.error *= 0.8f) {
            p = made(&s);
            CHECK(!p.meets || (p.error <= 1.1f * s.error && p.cost >= cost), "error %g of %d: %s costs %g after %g",
                  (double)s.error, s.wanted, p.why, (double)p.cost, (double)cost);
            if (p.meets) cost = p.cost;
        }
    }
    int choices[4] = { 0 };
    for (int w = 0; w < 4; ++w) {
        s.wanted = w;
        for (int i = -1; i <= SSGI_PLAN_CHOICES; ++i) choices[w] += ssgi_plan_choice(&p, i, &s);
    }
    CHECK(choices[0] + choices[1] + choices[2] + choices[3] == SSGI_PLAN_CHOICES && choices[3] == 3,
          "choices: %d %d %d %d", choices[0], choices[1], choices[2], choices[3]);
}

/* Checks a plan's other choices against all that there are, and its sentences. */
static void beside(const ssgi_plan *p, const ssgi_plan_scene *s)
{
    float least = SSGI_FAR, dearer = SSGI_FAR;
    ssgi_plan other, cheaper;
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
        if (!ssgi_plan_choice(&other, i, s)) continue;
        if (other.cost <= p->cost / 1.05f && other.error < least) least = other.error;
        if ((double)other.error <= (double)p->error / 1.05 && other.cost < dearer) dearer = other.cost;
    }
    CHECK(ssgi_plan_choice(&other, p->choice, s) && other.method == p->method && other.samples == p->samples
              && !(fabsf(other.error - p->error) > 0), "%s: is not choice %d", p->why, p->choice);
    CHECK(ssgi_plan_choice(&cheaper, p->cheaper, s)
              ? cheaper.cost <= p->cost / 1.05f && cheaper.error <= 1.0501f * least && strstr(p->why, " Cheaper: ")
              : p->cheaper == -1 && !(p->cost > 0) && !strstr(p->why, " Cheaper: "),
          "%s: choice %d is cheaper, one has %g", p->why, p->cheaper, (double)least);
    CHECK(ssgi_plan_choice(&other, p->dearer, s)
              ? !(fabsf(other.cost - dearer) > 0) && strstr(p->why, " More accurate: ")
              : p->dearer == -1 && !(dearer < SSGI_FAR) && !strstr(p->why, " More accurate: "),
          "%s: choice %d is more accurate, one costs %g", p->why, p->dearer, (double)dearer);
    CHECK(!strncmp(p->why, "Cannot be met: ", 15) == (!p->meets && s->error > 0)
              && (strstr(p->why, " ms. ") != NULL) == (s->device == SSGI_PLAN_DEVICE_RX_6800),
          "%d, in %d: %s", p->meets, s->device, p->why);
}

/* A relative error is one of an image without occlusion, as the calibration, the survey or a guess has it. */
static void relative(void)
{
    /* by how the scene is known, and by the wanted quantity */
    static const double unoccluded[3][4] = { { 0.15, 0.15, 0.15, 0.15 },
                                             { 0.111808, 0.114022, 0.097113, 0.111808 },
                                             { 0.141421, 0.141421, 0.141421, 0.141421 } };
    ssgi_plan_scene s = { .surfels = 0.2, .thickness = SSGI_PLAN_THICKNESS_SLABS, .occluders = 9, .map = 1 };
    for (int known = 0; known < 3; ++known)
        for (int k = 0; k < 4 * 12; ++k) {
            s.wanted = k % 4;
            s.device = k % 3;
            s.budget = k % 5 ? 0 : 0.3f;
            s.calibration = known ? (ssgi_calibration){ 0 } : (ssgi_calibration){ 1, 0.15f, 0.07f, 0.03f, 0, 0 };
            s.survey = known == 1 ? (ssgi_survey){ 0.1f, 0.02f, 0.01f, 0 } : (ssgi_survey){ 0 };
            s.unit = SSGI_PLAN_UNIT_RELATIVE;
            s.error = 0.1f + 0.08f * (float)(k / 4);
            const ssgi_plan by_share = made(&s);
            beside(&by_share, &s);
            s.unit = SSGI_PLAN_UNIT_RMSE;
            s.error *= by_share.unoccluded;
            const ssgi_plan p = made(&s);
            beside(&p, &s);
            CHECK(fabs((double)p.unoccluded / unoccluded[known][k % 4] - 1) < 1e-4 && p.choice == by_share.choice
                      && p.meets == by_share.meets && p.bands == by_share.bands,
                  "%g of %g: %s; %s", (double)s.error, (double)p.unoccluded, by_share.why, p.why);
        }
    /* where nothing is occluded, no choice has a smaller error than nothing, and each relative error is met */
    s = (ssgi_plan_scene){ .unit = SSGI_PLAN_UNIT_RELATIVE, .error = 0.1f, .calibration.known = 1 };
    const ssgi_plan p = made(&s);
    CHECK(p.method == SSGI_PLAN_METHOD_NOTHING && p.meets && p.dearer == -1 && !(p.error > 0), "%s", p.why);
}

/* Checks predicted errors and costs of choices by hand from the table. The squared error sums nothing's^2, hsao's^2,
   slabs'^2, that of FAST or of s3ho, nothing's^2 size / radius, nothing's^2 unevenness and 1e-4, each times the row's
   number. */
static void by_hand(void)
{
    static const ssgi_plan_scene dim = { .wanted = SSGI_PLAN_WANTED_VISIBILITY,
                                         .calibration = { 1, 0.02f, 0.001f, 0.0005f, 0, 0 } },
                                 hidden = { .wanted = SSGI_PLAN_WANTED_VISIBILITY,
                                            .calibration = { 1, 0.15f, 0.05f, 0.04f, 0, 0 },
                                            .surfels = 0.2,
                                            .splats = 250,
                                            .screen_radius = 0.15f },
                                 lit = { .wanted = SSGI_PLAN_WANTED_LIGHT,
                                         .calibration = { 1, 0.01f, 0.005f, 0.004f, 0, 0 },
                                         .energy = { 1, 0.5f, 0.25f, 0.25f },
                                         .map = 1 },
                                 bounced = { .wanted = SSGI_PLAN_WANTED_BOUNCE,
                                             .calibration = { 1, 0.01f, 0.005f, 0.004f, 0, 0 },
                                             .energy = { 1, 0.5f, 0.25f, 0.25f } },
                                 dim_fast = { .calibration = { 1, 0.02f, 0.001f, 0.0005f, 0.0015f, 0 } },
                                 lit_s3ho = { .wanted = SSGI_PLAN_WANTED_LIGHT,
                                              .calibration = { 1, 0.01f, 0.005f, 0.004f, 0, 0.003f },
                                              .energy = { 1, 0.5f, 0.25f, 0.25f },
                                              .map = 1 };
    const struct {
        const ssgi_plan_scene *scene;
        int method, thickness, resolution, slices, bands;
        float size;
        double error, cost;
    } row[] = {
        /* hsao 0.9 */
        { &dim, SSGI_PLAN_METHOD_HSAO, SSGI_PLAN_THICKNESS_WIDTH, 0, 2, 0, 0, 0.00094868330, 4.92 },
        /* FAST 1; its squared error is nothing's 0.0283, hsao's 0.983; then as it was calibrated */
        { &dim, SSGI_PLAN_METHOD_HSAO, SSGI_PLAN_THICKNESS_CONSTANT, 1, 1, 0, 0, 0.0035075632, 1.27 },
        { &dim_fast, SSGI_PLAN_METHOD_HSAO, SSGI_PLAN_THICKNESS_CONSTANT, 1, 1, 0, 0, 0.0015, 1.27 },
        /* terms: nothing 0.006, hsao 0.83, coarse 0.012, 1e-4 0.07; cost: a quarter of 250 texels, 0.2 surfels */
        { &hidden, SSGI_PLAN_METHOD_DSS, SSGI_PLAN_THICKNESS_WIDTH, 1, 2, 0, 0.03f, 0.047655010, 17.5925 },
        /* terms: nothing 0.024, hsao 0.86, coarse 0.039, 1e-4 0.6; cost: a sixteenth of the texels */
        { &hidden, SSGI_PLAN_METHOD_DSS, SSGI_PLAN_THICKNESS_WIDTH, 3, 2, 0, 0.03f, 0.054087892, 8.243125 },
        /* s3ho 0.97, which is hsao's 0.704; then as it was calibrated */
        { &lit, SSGI_PLAN_METHOD_SSDO, SSGI_PLAN_THICKNESS_WIDTH, 1, 2, 0, 0, 0.0041318277, 2.41 },
        { &lit_s3ho, SSGI_PLAN_METHOD_SSDO, SSGI_PLAN_THICKNESS_WIDTH, 1, 2, 0, 0, 0.0029546573, 2.41 },
        /* s3ho 1, which is nothing's 0.173 and uneven 0.0407, hsao's 0.111 */
        { &bounced, SSGI_PLAN_METHOD_S3HO, SSGI_PLAN_THICKNESS_WIDTH, 1, 2, 4, 0, 0.0049137562, 4.92 },
    };
    for (size_t k = 0; k < sizeof row / sizeof row[0]; ++k) {
        int met = 0;
        for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
            ssgi_plan p;
            if (!ssgi_plan_choice(&p, i, row[k].scene) || p.method != row[k].method || p.resolution != row[k].resolution
                || p.slices != row[k].slices || p.bands != row[k].bands || fabsf(p.surfel_size - row[k].size) > 1e-6f
                || p.thickness != row[k].thickness || p.history || p.samples == 12)
                continue;
            CHECK(fabs((double)p.error / row[k].error - 1) < 1e-4 && fabs((double)p.cost / row[k].cost - 1) < 1e-4,
                  "row %zu: %.8g predicted at %.8g, %.8g at %g by hand", k, (double)p.error, (double)p.cost,
                  row[k].error, row[k].cost);
            /* half of the radius is 0.075; levels of surfels of 0.03 end at 0.0229, 0.0458 and 0.0917 */
            CHECK(p.levels == (p.method == SSGI_PLAN_METHOD_DSS ? 3 : 0), "row %zu: %d levels", k, p.levels);
            ++met;
        }
        CHECK(met == 1, "row %zu: %d choices are meant", k, met);
    }
    /* Depth passes, the cover of fields, the other column of costs. Without a calibration the survey predicts it: 1e-6
       + 1.27 * 0.1^2 + 0.632 * 0.03^2 of nothing with slabs, 1e-6 + 1.25 * 0.1^2 without. A
       calibration without slabs scales the prediction for slabs, which is the survey's or a guess of 0.003, the same as
       hsao's. */
    static const float passes[4] = { 0, 0, 1, 3 }, slabs[2] = { 0, 0.03f };
    ssgi_plan_scene s = {
        .thickness = SSGI_PLAN_THICKNESS_SLABS, .history = 1, .occluders = 10, .coverage = 0.5f, .map = 1
    };
    for (s.wanted = 0; s.wanted < 4; ++s.wanted)
        for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
            static const int device[4] = { SSGI_PLAN_DEVICE_SOFTWARE, SSGI_PLAN_DEVICE_GPU, SSGI_PLAN_DEVICE_SOFTWARE,
                                           SSGI_PLAN_DEVICE_RX_6800 };
            ssgi_plan p[4];
            for (int k = 0; k < 4; ++k) {
                s.device = device[k];
                s.depth_pass = k == 2 ? 2 : 0;
                p[k].method = -1;
                ssgi_plan_choice(&p[k], i, &s);
            }
            if (p[0].method < 0) continue;
            CHECK(fabsf(p[2].cost - p[0].cost - 2 * passes[p[0].thickness]) < 1e-5f, "choice %d: depth passes cost %g",
                  i, (double)(p[2].cost - p[0].cost));
            CHECK(p[0].method == SSGI_PLAN_METHOD_NOTHING || fabsf(p[1].cost / p[0].cost - 1) > 0.001f,
                  "choice %d: %g in either column", i, (double)p[0].cost);
            CHECK(i != 4 || (fabsf(p[0].cost - 2.03f) < 1e-4f && fabsf(p[1].cost - 1.83f) < 1e-4f
                             && fabsf(p[3].cost - 0.33672f) < 1e-4f),
                  "hsao costs %g, %g, %g ms", (double)p[0].cost, (double)p[1].cost, (double)p[3].cost);
            CHECK(p[0].method != SSGI_PLAN_METHOD_AOF
                      || (fabsf(p[0].cost - 3.81f) < 1e-4f && fabsf(p[1].cost - 1.55f) < 1e-4f),
                  "fields over 5 frames' pixels cost %g, %g", (double)p[0].cost, (double)p[1].cost);
        }
    s = (ssgi_plan_scene){ .survey = { 0.1f, 0.02f, 0.01f, 0 } };
    for (int k = 0; k < 2; ++k) {
        ssgi_plan p;
        s.survey.slabs = slabs[k];
        CHECK(ssgi_plan_choice(&p, 0, &s) && fabs((double)p.error - (k ? 0.115195 : 0.111808)) < 1e-5,
              "a survey %s slabs: nothing errs by %g", k ? "with" : "without", (double)p.error);
    }
    s = (ssgi_plan_scene){ .calibration = { 1, 0.1f, 0.04f, 0, 0, 0 }, .thickness = SSGI_PLAN_THICKNESS_SLABS };
    for (int i = 0, met = 0; i < SSGI_PLAN_CHOICES; ++i) {
        ssgi_plan p;
        if (!ssgi_plan_choice(&p, i, &s) || p.thickness != SSGI_PLAN_THICKNESS_SLABS || p.slices != 2 || !p.resolution
            || p.samples != 8)
            continue;
        CHECK(!met++ && fabsf(p.error - 0.04f) < 1e-6f, "slabs that were not calibrated err by %g", (double)p.error);
    }
}

/* Checks that a plan of nothing gives no desc. */
static void refused(void)
{
    const ssgi_plan plan = { .choice = 0 };
    ssgi_gl_desc desc = { .input.depth = SSGI_GL_DEPTH_LINEAR }, kept = desc;
    CHECK(ssgi_gl_plan(&desc, &plan, NULL) == SSGI_BAD_ARGUMENT && ssgi_gl_plan(&desc, NULL, NULL) == SSGI_BAD_ARGUMENT
              && !memcmp(&desc, &kept, sizeof desc),
          "nothing becomes a desc");
}

/* Checks the limits of the numbers of surfels and of splats: 0 and 1e18, both included. */
static void counts(void)
{
    static const double good[] = { 0, 1e18 }, bad[] = { -1e-9, 1.1e18, (double)NAN };
    for (int k = 0; k < 10; ++k) {
        ssgi_plan_scene s = { .error = 0.1f };
        const int is_good = k / 2 < 2;
        const char *why = "";
        ssgi_plan plan;
        *(k % 2 ? &s.surfels : &s.splats) = is_good ? good[k / 2] : bad[k / 2 - 2];
        CHECK(ssgi_plan_make(&plan, &s, &why) == (is_good ? SSGI_OK : SSGI_BAD_ARGUMENT)
                  && (is_good || !strncmp(why, "scene.surfels, .splats: ", 24)),
              "%g surfels and %g splats: \"%s\"", s.surfels, s.splats, why);
    }
}

/* Checks that the kit draws the passes of a chain with the same shaders, except for the frame's format. */
static void draws(const kit_run *run, const ssgi_gl_chain *chain, int i)
{
    static ssgi_gl_step step[KIT_MAX_PASSES];
    const char *why = "";
    const int steps = ssgi_gl_steps(step, KIT_MAX_PASSES, chain, &why);
    int n = 0;
    for (int k = 0; k < run->passes; ++k) {
        if (run->pass[k].aside) continue;
        if (n++ >= steps) break;
        ssgi_gl_desc want = step[n - 1].desc;
        want.input = run->pass[k].desc.input;
        want.shader = run->pass[k].desc.shader;
        CHECK(ssgi_gl_key(&run->pass[k].desc) == ssgi_gl_key(&want), "choice %d: the kit has another pass %s", i,
              ssgi_gl_pass_name(want.pass));
    }
    CHECK(n == steps, "choice %d: the kit draws %d passes, ssgi_gl_plan has %d: %s", i, n, steps, why);
}

/* Checks that every choice becomes a valid desc, and that the kit draws it. */
static void drawable(void)
{
    static const int thickness[] = { [SSGI_PLAN_THICKNESS_WIDTH] = SSGI_GL_THICKNESS_DEFAULT,
                                     [SSGI_PLAN_THICKNESS_CONSTANT] = SSGI_GL_THICKNESS_CONSTANT,
                                     [SSGI_PLAN_THICKNESS_BACK] = SSGI_GL_THICKNESS_BACK,
                                     [SSGI_PLAN_THICKNESS_SLABS] = SSGI_GL_THICKNESS_SLABS };
    ssgi_plan_scene s = {
        .thickness = SSGI_PLAN_THICKNESS_SLABS, .history = 1, .surfels = 1, .occluders = 1, .map = 1
    };
    kit_error err = { "" };
    OWN(kit_lighting) light = { 0 };
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    CHECK(!kit_gl_open(NULL, &err), "%s", err.text);
    if (!lighten(&light, "white", NULL) || !see(&scene, &g, "boxes", NULL, 0, NULL, 16, 16)) return;
    const kit_world world = { &scene, &light };
    for (s.wanted = 0; s.wanted < 4; ++s.wanted)
        for (int i = 0; i < SSGI_PLAN_CHOICES; ++i) {
            const int bounces = s.wanted == SSGI_PLAN_WANTED_BOUNCE;
            ssgi_gl_chain chain = { .desc.input.depth = SSGI_GL_DEPTH_LINEAR, .width = 16, .height = 16, .blur = 1 };
            ssgi_gl_desc *desc = &chain.desc;
            const char *why = "";
            kit_method m;
            OWN(kit_run) run = { 0 };
            ssgi_plan p;
            if (!ssgi_plan_choice(&p, i, &s) || p.method == SSGI_PLAN_METHOD_NOTHING) continue;
            if (bounces && p.method == SSGI_PLAN_METHOD_S3HO) desc->light.transfer = SSGI_GL_TRANSFER_BOTH;
            desc->light.packed_coefficients = desc->light.transfer > 0;
            CHECK(ssgi_gl_plan(desc, &p, &why) == SSGI_OK && desc->input.depth == SSGI_GL_DEPTH_LINEAR
                      && desc->gather.samples == p.samples && desc->gather.thickness == thickness[p.thickness]
                      && desc->gather.resolution == p.resolution,
                  "choice %d: %s", i, why);
            CHECK(desc->surfel.span == (p.method == SSGI_PLAN_METHOD_DSS ? 6 : 0)
                      && desc->light.environment == (p.method == SSGI_PLAN_METHOD_SSDO ? SSGI_GL_ENVIRONMENT_MAP : 0),
                  "choice %d: span %d, environment %d", i, desc->surfel.span, (int)desc->light.environment);
            const int s3ho = desc->pass == SSGI_GL_PASS_S3HO;
            CHECK(desc->light.shaded == s3ho && desc->light.residual == s3ho
                      && (!s3ho
                          || (desc->light.bands == p.bands
                              && desc->light.restore
                                     == (bounces ? SSGI_GL_RESTORE_DIFFERENCE : SSGI_GL_RESTORE_RATIO))),
                  "choice %d: shaded %d, residual %d, restore %d, %d bands", i, desc->light.shaded,
                  desc->light.residual, desc->light.restore, desc->light.bands);
            chain.history = p.history;
            if (bounces && p.method == SSGI_PLAN_METHOD_SSDO) {
                desc->light.bounce = SSGI_GL_BOUNCE_SOLID_ANGLE;
                chain.reuse = 1;
            }
            const int steps = ssgi_gl_steps(NULL, 0, &chain, &why);
            CHECK(steps > 0 && steps <= SSGI_GL_MAX_STEPS, "choice %d has %d steps: %s", i, steps, why);
            if (!CHECK(!kit_plan_method(&m, &p, s.wanted, &err)
                           && !kit_run_open(&run, &g, &m, scene.radius, &world, &err),
                       "choice %d: %s", i, err.text))
                continue;
            draws(&run, &chain, i);
        }
}

/* Checks that choices filter as the methods by name do that draw the same at the same resolution. */
static void as_named(void)
{
    static const char *const names[] = { "hsao", "hsao-fast", "hsao-best", "hsao-quarter", "hsao-history", "ssdo",
                                         "ssdo-best", "s3ho", "s3ho-best", "dss", "dss-fast", "dss-best" };
    const ssgi_plan_scene s = {
        .thickness = SSGI_PLAN_THICKNESS_SLABS, .history = 1, .surfels = 1, .occluders = 1, .map = 1
    };
    for (size_t k = 0; k < sizeof names / sizeof *names; ++k) {
        ssgi_gl_chain named;
        int met = 0;
        memset(&named, 0, sizeof named);
        CHECK(ssgi_gl_chain_of(&named, names[k], NULL) == SSGI_OK, "%s", names[k]);
        for (int i = 0; i < 4 * SSGI_PLAN_CHOICES; ++i) {
            ssgi_plan_scene wanted = s;
            ssgi_gl_desc d = { .input.depth = SSGI_GL_DEPTH_LINEAR };
            ssgi_plan p;
            wanted.wanted = i % 4;
            if (!ssgi_plan_choice(&p, i / 4, &wanted) || !p.slices || ssgi_gl_plan(&d, &p, NULL) != SSGI_OK
                || d.pass != named.desc.pass || d.gather.resolution != named.desc.gather.resolution
                || p.history != named.history)
                continue;
            ++met;
            CHECK(d.filter.radius == named.desc.filter.radius, "choice %d filters by %d, and %s by %d", i / 4,
                  d.filter.radius, names[k], named.desc.filter.radius);
        }
        CHECK(met, "no choice draws as %s does", names[k]);
    }
}

/* Fills in a calibration by pixels of a frame and their truth, in another way than the kit. */
static void calibrated(const kit_scene *scene, const kit_gbuffer *g, const ssgi_plan_scene *s)
{
    enum { MOST = 2000 };
    static float position[MOST][3], normal[MOST][3], seen[MOST], open[MOST];
    static const char *const names[] = { "Z", "N.X", "N.Y", "N.Z" };
    const float *channel[4];
    ssgi_trace trace;
    ssgi_calibration c[2];
    OWN(kit_image) frame = { 0 }, truth = { 0 };
    kit_error err;
    float to_view[16], projection[16];
    double square = 0;
    size_t count = 0, pixels = 0;
    if (!CHECK(!kit_gbuffer_read(&frame, g, &err)
                   && !kit_truth_ao(&truth, scene, &g->camera, scene->radius, KIT_ATTENUATION_LINEAR, 256, 1, &err),
               "%s", err.text))
        return;
    for (int i = 0; i < 4; ++i) channel[i] = kit_image_channel(&frame, names[i]);
    kit_camera_matrices(&g->camera, to_view, projection);
    for (int i = 0; i < frame.width * frame.height; ++i) {
        const float z = channel[0][i];
        if (!(z > 0)) continue;
        square += pow(1 - (double)truth.data[i], 2);
        ++pixels;
        if (i % 23 || count == MOST) continue;
        kit_camera_point(&g->camera, i % frame.width, i / frame.width, (double)z, position[count]);
        for (int k = 0; k < 3; ++k)
            for (int n = 0; n < 3; ++n) normal[count][k] += to_view[4 * k + n] * channel[n + 1][i];
        seen[count] = truth.data[i];
        open[count++] = 1;
    }
    const size_t size = ssgi_trace_size(scene->mesh.triangles);
    FREED void *const memory = malloc(size);
    CHECK(ssgi_trace_build(&trace, memory, size, scene->mesh.position, 12, NULL, scene->mesh.triangles, NULL)
              == SSGI_OK, "no tree");
    for (int with = 0; with < 2; ++with)
        CHECK(ssgi_plan_calibrate(&c[with], &trace, *position, *normal, seen, with ? open : NULL,
                                  with ? open : NULL, count, 16, scene->radius, NULL) == SSGI_OK, "no calibration");
    const double nothing = sqrt(square / (double)pixels);
    CHECK(fabsf(c[1].slabs - c[1].unoccluded) < 1e-6f && !(c[0].slabs > 0), "slabs that find nothing err by %g, %g",
          (double)c[1].slabs, (double)c[0].slabs);
    CHECK(fabsf(c[1].fast - c[1].unoccluded) < 1e-6f && !(c[0].fast > 0), "FAST that finds nothing errs by %g, %g",
          (double)c[1].fast, (double)c[0].fast);
    CHECK(c[0].known && c[0].hsao < 0.006f && fabs((double)c[0].unoccluded / nothing - 1) < 0.05,
          "a calibration of the truth: %g, of nothing %g, which is %g", (double)c[0].hsao, (double)c[0].unoccluded,
          nothing);
    CHECK(fabs((double)s->calibration.unoccluded / nothing - 1) < 0.05 && s->calibration.hsao > 0.1f * (float)nothing
              && s->calibration.hsao < 0.22f * (float)nothing,
          "the kit's calibration: open %g of %g, hsao %g", (double)s->calibration.unoccluded, nothing,
          (double)s->calibration.hsao);
    CHECK(fabs((double)s->survey.occlusion / nothing - 1) < 0.25 && s->calibration.slabs > 0 && s->surfels > 0.01
              && s->splats > 10,
          "the survey finds an occlusion of %g, of %g; %g surfels, %g splats", (double)s->survey.occlusion, nothing,
          s->surfels, s->splats);
}

/* Checks that a calibration is of the surfaces that the frame shows, and not of those before the near plane. */
static void calibrated_beyond_near(void)
{
    kit_error err = { "" };
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    OWN(kit_image) truth = { 0 };
    ssgi_plan_scene s;
    double square = 0;
    if (!see(&scene, &g, "random:27", NULL, 0, NULL, 64, 36)) return;
    const kit_world world = { &scene, NULL };
    const int pixels = 64 * 36;
    CHECK(!kit_plan_numbers(&s, &g, &world, scene.radius, SSGI_PLAN_WANTED_VISIBILITY, &err)
              && !kit_truth_ao(&truth, &scene, &g.camera, scene.radius, KIT_ATTENUATION_LINEAR, 64, 1, &err),
          "%s", err.text);
    for (int i = 0; i < pixels; ++i) square += pow(1 - (double)truth.data[i], 2); /* nothing is occluded in the sky */
    CHECK(fabs((double)s.calibration.unoccluded / sqrt(square / pixels) - 1) < 0.05,
          "an occlusion of %g is calibrated as %g", sqrt(square / pixels), (double)s.calibration.unoccluded);
}

/* Checks the kit's calibration of light: s3ho has an error, and a smaller one than no occlusion. */
static void calibrated_light(void)
{
    kit_error err = { "" };
    OWN(kit_lighting) light = { 0 };
    OWN(kit_scene) scene = { 0 };
    OWN(kit_gbuffer) g = { 0 };
    ssgi_plan_scene s;
    if (!lighten(&light, "sky", NULL) || !see(&scene, &g, "corner", NULL, 0, NULL, 32, 18)) return;
    const kit_world world = { &scene, &light };
    CHECK(!kit_plan_numbers(&s, &g, &world, scene.radius, SSGI_PLAN_WANTED_LIGHT, &err), "%s", err.text);
    CHECK(s.calibration.s3ho > 0 && s.calibration.s3ho < 0.9f * s.calibration.unoccluded,
          "the error of s3ho is %g, of no occlusion %g", (double)s.calibration.s3ho,
          (double)s.calibration.unoccluded);
}

/* Checks a survey's figures by pixels worked out by hand; a plane's are 0, a corner's are not. A calibration by the
   truth itself finds no error, with any number of rays, and for nothing the error of the truth's picture. */
static void measured(void)
{
    static const float hsao[3] = { 0.5f, 1, NAN }, best[3] = { 0.4f, 1, 0 }, solid[3] = { 0.3f, 1, 0 },
                       slabs[3] = { 0.8f, 1, 0 };
    kit_error err = { "" };
    ssgi_survey survey;
    for (int with = 0; with < 2; ++with)
        CHECK(ssgi_survey_of(&survey, hsao, best, solid, with ? slabs : NULL, 3, NULL) == SSGI_OK
                  && fabsf(survey.occlusion - sqrtf(with ? 0.02f : 0.125f)) < 1e-6f
                  && fabsf(survey.detail - sqrtf(0.005f)) < 1e-6f && fabsf(survey.solid - sqrtf(0.02f)) < 1e-6f
                  && fabsf(survey.slabs - (with ? sqrtf(0.045f) : 0)) < 1e-6f,
              "a survey: %g %g %g %g", (double)survey.occlusion, (double)survey.detail, (double)survey.solid,
              (double)survey.slabs);
    CHECK(!kit_gl_open(NULL, &err), "%s", err.text);
    for (int k = 0; k < 2; ++k) {
        OWN(kit_scene) scene = { 0 };
        OWN(kit_gbuffer) g = { 0 };
        ssgi_plan_scene s;
        if (!see(&scene, &g, k ? "corner" : "plane", NULL, 0, NULL, 288, 162)) return;
        const kit_world world = { &scene, NULL };
        CHECK(!kit_plan_numbers(&s, &g, &world, scene.radius, SSGI_PLAN_WANTED_VISIBILITY, &err), "%s", err.text);
        if (k) calibrated(&scene, &g, &s);
        else
            CHECK(s.survey.occlusion < 2e-3f && s.survey.slabs < 2e-3f && s.calibration.unoccluded < 1e-3f,
                  "a plane occludes by %g, and errs by %g", (double)s.survey.occlusion,
                  (double)s.calibration.unoccluded);
    }
}

void test_plan(void)
{
    RUN("plan: constant skies want no harmonics, two lights do; what is not given is not taken; budgets hold",
        follows);
    RUN("plan: relative errors are those of an image without occlusion; the next choices are the next", relative);
    RUN("plan: predicted errors and costs are what the table's numbers come to by hand", by_hand);
    RUN("plan: of nothing there is no desc", refused);
    RUN("plan: there may be from 0 to 1e18 surfels and splats, and no other number of them", counts);
    RUN("plan: the kit draws every choice as ssgi_gl_plan has it, by the same shaders", drawable);
    RUN("plan: a choice filters as the preset of its method does", as_named);
    RUN("plan: survey and calibration find what the truth says", measured);
    RUN("plan: what lies before the near plane calibrates nothing", calibrated_beyond_near);
    RUN("plan: the calibration of light has the error of s3ho", calibrated_light);
}
