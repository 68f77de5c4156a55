/* nan.c - every float that a function takes is set to NaN and to the infinities: each is refused with a sentence, and
   nothing is written. Compiled by test_build.c with and without -ffast-math, which takes NaN for a number wherever the
   library compares instead of looking at the bits. */
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../ssgi_gl.h"

#include <stdio.h>

/* Arguments that are right. */
static float projection[16] = { 1.3f, 0, 0, 0, 0, 2.4f, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2002f, 0 };
static float rigid[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -2, 1 };
static float other[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1f, 0, -2, 1 };
static float triangle[9] = { 0, 0, -1, 1, 0, -1, 0, 1, -1 };
static float colour[3] = { 1, 2, 3 }, up[3] = { 0, 1, 0 }, coefficients[48] = { 1 }, image[8 * 4 * 3] = { 1 };
static float number = 0.5f;
static ssgi_view view;
static ssgi_surfel_desc surfels = { 0.2f, 4, 0.1f, 0, 5, SSGI_OVERHANG_CENTROID };
static ssgi_surfel_source source;
static ssgi_splat splat = { 0.1f, 1, 1, 0.1f, 4 };
static ssgi_surfel surfel[2] = { { { 0, 0, -1 }, 0.1f, { 0, 0, 1 }, 0.5f, { 1, 1, 1 }, 0 },
                                 { { 0, 1, -1 }, 0.1f, { 0, 0, 1 }, 0.5f, { 1, 1, 1 }, 0 } };
static ssgi_gl_light light = { { 0, 0, 1 }, 0, { 1, 1, 1 }, 0, { 0, 0, 0 }, 0, { { 0 } }, { 0 }, { 0 } };
static ssgi_dipole dipole;
static ssgi_field_desc baked;
static ssgi_field field;
static ssgi_field_limits limits;
static uint32_t texels[432];
static ssgi_trace trace;
static ssgi_plan_scene scene;

/* Outputs. */
static struct {
    ssgi_gl_frame frame;
    ssgi_gl_views views;
    ssgi_gl_light light;
    ssgi_gl_occluder occluder;
    ssgi_view view;
    ssgi_dipole dipole;
    ssgi_surfel surfel[64];
    ssgi_surfel_cost cost;
    ssgi_vpl vpl[2];
    ssgi_calibration calibration;
    ssgi_plan plan;
    float floats[3 * 64];
    size_t count;
} out;

static const char *why;
static uint32_t words[9];

#define CALL(name, expression) static ssgi_result name(void) { return expression; }
CALL(view_of, ssgi_view_from_projection(&out.view, projection, SSGI_CLIP_GL, 64, 36, &why))
CALL(extra, ssgi_extra_camera(out.floats, out.floats + 16, rigid, up, number, colour, &why))
CALL(sh_light, ssgi_sh_light(out.floats, 3, up, number, colour, SSGI_SH_WINDOW_HANN, &why))
CALL(map, ssgi_environment_map(out.floats, 8, image, 8, 4, number, &why))
CALL(cone, ssgi_environment_cone(out.floats, 8, image, 8, 4, number, &why))
CALL(area, ssgi_vpl_area(out.vpl, 2, up, up, colour, 0, image, &why))
CALL(guess, ssgi_radius_guess(out.floats, &out.count, triangle, 12, NULL, 1, up, words, 9, &why))
CALL(scale, ssgi_surfel_scale(out.floats, &surfels, &view, &why))
CALL(divide, ssgi_surfels_divide(out.floats, 2, &out.count, &surfels, &view, &source, &why))
CALL(make, ssgi_surfels(out.surfel, 64, &out.count, &surfels, &view, &source, &why))
CALL(predict, ssgi_surfels_predict(&out.cost, &surfels, &splat, &view, &source, &why))
CALL(scattering, ssgi_dipole_set(&out.dipole, colour, up, number + 1, &why))
CALL(seen, ssgi_trace_visibility(out.floats, &trace, up, up, 1, number, 2, 0, &why))
CALL(blocked, ssgi_cap_light(out.floats, coefficients, 4, number, up, colour, &why))
CALL(calibrate, ssgi_plan_calibrate(&out.calibration, &trace, up, up, &number, NULL, 1, 2, number, &why))
CALL(plan, ssgi_plan_make(&out.plan, &scene, &why))
CALL(frame, ssgi_gl_frame_init(&out.frame, &view, number, &why))
CALL(last, ssgi_gl_frame_history(&out.frame, &view, rigid, other, &why))
CALL(surfels_of, ssgi_gl_surfels_set(&out.frame, &view, &surfels, rigid, &why))
CALL(sent, ssgi_gl_sent_set(&out.frame, surfel, 2, &light, 1, up, &why))
CALL(dipole_of, ssgi_gl_dipole_set(&out.frame, &dipole, number, &why))
CALL(harmonics, ssgi_gl_harmonics_set(&out.frame, coefficients, 4, rigid, &why))
CALL(views, ssgi_gl_views_set(&out.views, 0, &view, rigid, other, &why))
CALL(mapped, ssgi_gl_light_map(&out.light, &view, 0, 0, rigid, other, &why))
CALL(occluder, ssgi_gl_occluder_set(&out.occluder, &field, &limits, rigid, 0, 1, &why))

static ssgi_result bake_size(void)          /* 0 bytes: bad arguments */
{
    why = "desc:";
    return ssgi_field_bake_size(&baked, 1) ? SSGI_OK : SSGI_BAD_ARGUMENT;
}

static int wrong;

/* NaNs and infinities. */
static const uint32_t bad[] = { 0x7fc00000u, 0xffc00000u, 0x7f800001u, 0x7f800000u, 0xff800000u };

/* The call takes what it is given; with any of these floats no number it refuses, names it, and writes nothing. */
static void refuses(const char *name, ssgi_result (*call)(void), float *v, size_t count)
{
    static unsigned char was[sizeof out];
    if (call() != SSGI_OK) { printf("%s refuses what is right: %s\n", name, why); ++wrong; }
    memcpy(was, &out, sizeof out);
    for (size_t i = 0; i < count; ++i)
        for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k) {
            const float good = v[i];
            memcpy(&v[i], &bad[k], sizeof bad[k]);
            why = "";
            const ssgi_result result = call();
            if (result != SSGI_BAD_ARGUMENT || !strchr(why, ':')) {
                printf("%s takes %08x as its %zu. float: \"%s\"\n", name, (unsigned)bad[k], i, why);
                ++wrong;
            }
            if (memcmp(was, &out, sizeof out)) {
                printf("%s writes something although its %zu. float is %08x\n", name, i, (unsigned)bad[k]);
                memcpy(was, &out, sizeof out);
                ++wrong;
            }
            v[i] = good;
        }
}
#define REFUSES(call, v) refuses(#call, call, (float *)(v), sizeof *(v) / sizeof(float))
#define REFUSES_ONE(call, v) refuses(#call, call, v, 1)

/* Those that return a float take anything; what comes is a number in 0..SSGI_FAR. */
static void formulas(void)
{
    const float good = 0.5f;
    for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k)
        for (int i = 0; i < 6; ++i) {
            float f = 0;
            memcpy(&f, &bad[k], sizeof f);
            const float got = i == 0 ? ssgi_normal_offset(&view, f)
                            : i == 1 ? ssgi_shadow_patch(f, good, 8)
                            : i == 2 ? ssgi_shadow_patch(good, f, 8)
                            : i == 3 ? ssgi_shadow_bias(f, good, good, SSGI_BIAS_SAFE)
                            : i == 4 ? ssgi_shadow_bias(good, f, good, SSGI_BIAS_PUBLISHED)
                                     : ssgi_shadow_bias(good, good, f, SSGI_BIAS_SAFE);
            uint32_t bits;
            memcpy(&bits, &got, sizeof bits);
            if (bits > 0x5d5e0b6bu) { /* SSGI_FAR */
                printf("formula %d of %08x gives %08x\n", i, (unsigned)bad[k], (unsigned)bits);
                ++wrong;
            }
        }
}

/* Plain formulas of surfels give what their comments say. */
static void surfel_formulas(void)
{
    for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k) {
        float f;
        double shell[2] = { 7, 7 }, other[2] = { 7, 7 };
        memcpy(&f, &bad[k], sizeof f);
        const double x = (double)f;
        ssgi_surfel_shell(shell, x, 1, 2);
        ssgi_surfel_shell(other, 2, 1, x);
        if (ssgi_tess_level(x, 1) != 1 || ssgi_tess_level(99, x) != 1 || ssgi_tess_radius(x, 1) != 0
            || ssgi_tess_radius(1, x) != 0 || ssgi_surfel_radius(&view, x, 1) != 0
            || ssgi_surfel_radius(&view, 0.1, x) != 0 || ssgi_surfel_form_factor(x, 1) != 0
            || ssgi_surfel_form_factor(1, x) != 0 || ssgi_surfel_reach(x, 1, 0.1) != 0
            || ssgi_surfel_reach(1, x, 0.1) != 0 || ssgi_surfel_reach(1, 1, x) != 0 || shell[0] != 0 || shell[1] != 0
            || other[0] != 0 || other[1] != 0) {
            printf("a formula of surfels takes %08x for a number\n", (unsigned)bad[k]);
            ++wrong;
        }
    }
}

static void expect(int good, const char *sentence)
{
    if (good) return;
    printf("%s (\"%s\")\n", sentence, why);
    ++wrong;
}

/* A pixel that is not finite in one picture of a survey, whichever, is left out. */
static void surveyed(void)
{
    static float picture[4][4] = { { 0.5f, 0.5f, 0.5f, 0.9f }, { 0.5f, 0.6f, 0.5f, 0.8f },
                                   { 0.4f, 0.5f, 0.5f, 0.8f }, { 0.5f, 0.5f, 0.6f, 0.9f } };
    for (int i = 0; i < 16; ++i)
        for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k) {
            const float was = picture[i / 4][i % 4];
            float left[4][3]; /* the other pixels */
            ssgi_survey all, others;
            for (int n = 0; n < 12; ++n) left[n / 3][n % 3] = picture[n / 3][n % 3 + (n % 3 >= i % 4)];
            memcpy(&picture[i / 4][i % 4], &bad[k], sizeof bad[k]);
            ssgi_survey_of(&all, picture[0], picture[1], picture[2], picture[3], 4, &why);
            ssgi_survey_of(&others, left[0], left[1], left[2], left[3], 3, &why);
            expect(!memcmp(&all, &others, sizeof all), "a survey counts a pixel that is not finite in one picture");
            picture[i / 4][i % 4] = was;
        }
    float far_apart[2] = { 3e38f, -3e38f };
    ssgi_survey s;
    ssgi_survey_of(&s, far_apart, far_apart + 1, far_apart, NULL, 1, &why);
    expect(ssgi_gl__within(&s.occlusion, 4, SSGI_FAR), "a survey is larger than SSGI_FAR");
}

/* Parts of a vertex's colour that are not finite count as 0, and so does such a normal; what is beside them stays. */
static void coloured(void)
{
    static float given[18] = { 0.5f, 0.25f, 1, 0.5f, 0.25f, 1, 0.5f, 0.25f, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1 };
    static const float kept[9] = { 0, 0, -1, 0, 0, 0, 0.5f, 0, 1 }, none = 0; /* of the first corner */
    static ssgi_surfel made[64];
    float divided[54];
    size_t count, patches;
    source.colour = given;
    source.normal = given + 9;
    for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k) {
        for (int c = 0; c < 3; ++c) memcpy(&given[3 * c + 1], &bad[k], sizeof bad[k]);
        memcpy(&given[9], &bad[k], sizeof bad[k]);
        expect(ssgi_surfels(made, 64, &count, &surfels, &view, &source, &why) == SSGI_OK && count > 0 && count <= 64,
               "surfels of bad colours are refused");
        for (size_t i = 0; i < count; ++i)
            expect(!memcmp(&made[i].colour[1], &none, sizeof none) && fabsf(made[i].colour[0] - 0.5f) < 1e-5f
                       && fabsf(made[i].colour[2] - 1.0f) < 1e-5f,
                   "a colour that is not finite reaches a surfel, or takes others along");
        expect(ssgi_surfels_divide(divided, 2, &patches, &surfels, &view, &source, &why) == SSGI_OK && patches == 1
                   && !memcmp(divided, kept, sizeof kept) && divided[14] == 1.0f,
               "an attribute that is not finite reaches a patch, or takes others along");
    }
    source.colour = source.normal = NULL;
}

/* Rays that are not finite hit nothing, by either question, and write nothing. */
static void rays(void)
{
    for (size_t k = 0; k < sizeof bad / sizeof *bad; ++k)
        for (int i = 0; i < 6; ++i) {
            float ray[6] = { 0.2f, 0.2f, 1, 0, 0, -1 };
            ssgi_hit hit = { -1, -1, -1, 7 };
            expect(ssgi_trace_any(&trace, ray, ray + 3, 0, 10) && !ssgi_trace_any(&trace, ray, ray + 3, 0, 1),
                   "the triangle is not two away");
            memcpy(&ray[i], &bad[k], sizeof bad[k]);
            expect(!ssgi_trace_any(&trace, ray, ray + 3, 0, 10)
                       && !ssgi_trace_closest(&hit, &trace, ray, ray + 3, 0, 10) && hit.triangle == 7,
                   "a ray that is not finite hits");
        }
}

/* Finite input whose squares, inverses or products are none. */
static void extremes(void)
{
    static const float nothing[16] = { 1.2f, 0, 0, 0, 0, 1.6f, 0, 0, 0, 0, -1.002f, -1, 0, 0, 0.2002f, 0 };
    static const int thickness[] = { -100000000, -1, 4, 7 };
    static const float dark[] = { 1e-45f, 1e-38f, 9e-31f };
    float wide[16];
    ssgi_view seen;
    ssgi_gl_desc desc = { 0 };
    ssgi_plan planned;
    ssgi_plan_scene many = scene;
    why = "";
    expect(ssgi_surfel_form_factor(1e-300, 0) == 0.0, "the form factor of a radius that is 0 as a float is not 0");
    expect(ssgi_tess_radius(1, 5e-324) == 0.0, "the radius of fewer discs than a float can count is not 0");
    expect(ssgi_dipole_reflectance(&dipole, 1, 1e308) == 0.0, "the reflectance beyond all floats is not 0");
    memcpy(wide, projection, sizeof wide);
    wide[0] = wide[5] = 1e-30f;
    expect(ssgi_view_from_projection(&seen, wide, SSGI_CLIP_GL, 64, 36, &why) == SSGI_OK
               && ssgi_normal_offset(&seen, 1e18f) == SSGI_FAR,
           "a normal offset is larger than SSGI_FAR");
    expect(ssgi_view_from_projection(&seen, nothing, SSGI_CLIP_GL, 64, 36, &why) == SSGI_BAD_ARGUMENT
               && !strncmp(why, "projection: ", 12),
           "a projection that shows nothing is taken");

    const float wide_ortho[16] = { 2e-38f, 0, 0, 0, 0, 2e-38f, 0, 0, 0, 0, -0.1f, 0, 0, 0, -1, 1 };
    out.frame.last_footprint = 7;
    expect(ssgi_view_from_projection(&seen, wide_ortho, SSGI_CLIP_GL, 1, 1, &why) == SSGI_OK
               && ssgi_gl_frame_init(&out.frame, &view, number, &why) == SSGI_OK
               && ssgi_gl_frame_history(&out.frame, &seen, rigid, other, &why) == SSGI_OK
               && ssgi_gl__within(&out.frame.last_footprint, 1, SSGI_FAR) && out.frame.last_footprint > 9e17f,
           "the last frame's pixels are wider than SSGI_FAR times");

    many.wanted = SSGI_PLAN_WANTED_OBJECTS;
    many.occluders = 2000000000;
    many.coverage = many.calibration.unoccluded = 3e38f;
    many.calibration.known = 1;
    for (int i = 0; i < SSGI_PLAN_CHOICES; ++i)
        expect(!ssgi_plan_choice(&planned, i, &many) || (planned.cost <= SSGI_FAR && planned.error <= SSGI_FAR),
               "a plan's cost or error is larger than SSGI_FAR");
    expect(ssgi_plan_make(&planned, &many, &why) == SSGI_OK, "many occluders cannot be planned for");
    for (size_t i = 0; i < sizeof thickness / sizeof *thickness; ++i) {
        planned.method = SSGI_PLAN_METHOD_HSAO;
        planned.thickness = thickness[i];
        expect(ssgi_gl_plan(&desc, &planned, &why) == SSGI_BAD_ARGUMENT && !strncmp(why, "plan.thickness: ", 16),
               "a plan of another thickness is taken");
    }
    for (size_t i = 0; i < sizeof dark / sizeof *dark; ++i) {
        const float sky[3] = { dark[i], dark[i], dark[i] };
        out.frame.sent = 7;
        expect(ssgi_gl_sent_set(&out.frame, surfel, 2, NULL, 0, sky, &why) == SSGI_OK && out.frame.sent == 7,
               "a radiance that texts cannot divide by counts as bright");
    }
}

int main(void)
{
    static float work[1 << 17];
    static unsigned char memory[4096];
    memset(&out, 0x5a, sizeof out);
    baked.resolution = baked.radii = 4;
    memcpy(source.to_view, rigid, sizeof rigid);
    source.position = triangle;
    source.triangles = 1;
    scene.error = 0.03f;
    scene.screen_radius = 0.1f;
    if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, 64, 36, &why) != SSGI_OK
        || ssgi_dipole_set(&dipole, colour, up, 1.5f, &why) != SSGI_OK
        || ssgi_trace_build(&trace, memory, sizeof memory, triangle, 12, NULL, 1, &why) != SSGI_OK
        || ssgi_field_bake(&field, texels, work, sizeof work, &baked, triangle, 12, NULL, 1, &why) != SSGI_OK) {
        puts(why);
        return 1;
    }
    limits = ssgi_field_limits_of(&field);

    formulas();
    surfel_formulas();
    extremes();
    surveyed();
    coloured();
    rays();
    REFUSES(view_of, &projection);
    REFUSES(extra, &rigid); REFUSES(extra, &up); REFUSES(extra, &colour); REFUSES_ONE(extra, &number);
    REFUSES(sh_light, &up); REFUSES(sh_light, &colour); REFUSES_ONE(sh_light, &number);
    REFUSES_ONE(map, &number);
    REFUSES_ONE(cone, &number);
    REFUSES(area, &up);
    REFUSES(area, &colour);
    refuses("area", area, image, 3);
    REFUSES(guess, &up);
    refuses("guess", guess, triangle, 9);
    REFUSES_ONE(scale, &surfels.size); REFUSES_ONE(scale, &surfels.offscreen_growth);
    REFUSES_ONE(scale, &surfels.max_distance);
    REFUSES(divide, &source.to_view);
    REFUSES(make, &source.to_view);
    REFUSES(predict, &source.to_view); REFUSES_ONE(predict, &splat.epsilon); REFUSES_ONE(predict, &splat.near_depth);
    REFUSES_ONE(predict, &splat.max_distance); REFUSES_ONE(predict, &splat.max_radiance);
    REFUSES(scattering, &colour); REFUSES(scattering, &up); REFUSES_ONE(scattering, &number);
    REFUSES_ONE(bake_size, &baked.reach);
    REFUSES_ONE(seen, &number);
    REFUSES(blocked, &coefficients); REFUSES_ONE(blocked, &number); REFUSES(blocked, &up); REFUSES(blocked, &colour);
    REFUSES_ONE(calibrate, &number);
    REFUSES_ONE(plan, &scene.error); REFUSES_ONE(plan, &scene.budget); REFUSES_ONE(plan, &scene.screen_radius);
    REFUSES(plan, &scene.survey); REFUSES(plan, &scene.energy);
    REFUSES_ONE(plan, &scene.depth_pass); REFUSES_ONE(plan, &scene.coverage);
    REFUSES_ONE(plan, &scene.calibration.unoccluded); REFUSES_ONE(plan, &scene.calibration.hsao);
    REFUSES_ONE(plan, &scene.calibration.slabs);

    REFUSES_ONE(frame, &number);
    REFUSES(last, &rigid); REFUSES(last, &other);
    REFUSES(surfels_of, &rigid); REFUSES_ONE(surfels_of, &surfels.size);
    refuses("sent", sent, surfel[1].position, 11);                      /* position to colour */
    REFUSES(sent, &light); REFUSES(sent, &up);
    REFUSES_ONE(dipole_of, &number);
    REFUSES(harmonics, &coefficients); REFUSES(harmonics, &rigid);
    REFUSES(views, &rigid); REFUSES(views, &other);
    REFUSES(mapped, &rigid); REFUSES(mapped, &other);
    REFUSES(occluder, &rigid); REFUSES(occluder, &limits);
    return wrong != 0;
}
