/* nan.c - sets every float argument of the library to NaN and to the infinities. Each call must be refused with a
   sentence and write nothing. test_build.c compiles it with and without -ffast-math, by which a comparison would take
   NaN for a number, so that the library must look at the bits. */
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"

#include <stdio.h>

static int wrong;
#define WRONG(...) (printf(__VA_ARGS__), puts(""), ++wrong)
#include "test_arguments.c"

/* Checks that functions that return a float accept anything, and return a number in 0..SSGI_FAR. */
static void formulas(void)
{
    const float good = 0.5f;
    for (size_t k = 0; k < NOT_FINITE; ++k)
        for (int i = 0; i < 6; ++i) {
            float f = 0;
            memcpy(&f, &not_finite[k], sizeof f);
            const float got = i == 0 ? ssgi_normal_offset(&view, f)
                            : i == 1 ? ssgi_shadow_patch(f, good, 8)
                            : i == 2 ? ssgi_shadow_patch(good, f, 8)
                            : i == 3 ? ssgi_shadow_bias(f, good, good, SSGI_BIAS_SAFE)
                            : i == 4 ? ssgi_shadow_bias(good, f, good, SSGI_BIAS_PUBLISHED)
                                     : ssgi_shadow_bias(good, good, f, SSGI_BIAS_SAFE);
            uint32_t bits;
            memcpy(&bits, &got, sizeof bits);
            if (bits > 0x5d5e0b6bu) /* SSGI_FAR */
                WRONG("formula %d of %08x gives %08x", i, (unsigned)not_finite[k], (unsigned)bits);
        }
}

/* Checks that plain formulas of surfels return the values that their comments name. */
static void surfel_formulas(void)
{
    for (size_t k = 0; k < NOT_FINITE; ++k) {
        float f;
        double shell[2] = { 7, 7 }, after[2] = { 7, 7 };
        memcpy(&f, &not_finite[k], sizeof f);
        const double x = (double)f;
        ssgi_surfel_shell(shell, x, 1, 2);
        ssgi_surfel_shell(after, 2, 1, x);
        if (ssgi_tess_level(x, 1) != 1 || ssgi_tess_level(99, x) != 1 || ssgi_tess_radius(x, 1) != 0
            || ssgi_tess_radius(1, x) != 0 || ssgi_surfel_radius(&view, x, 1) != 0
            || ssgi_surfel_radius(&view, 0.1, x) != 0 || ssgi_surfel_form_factor(x, 1) != 0
            || ssgi_surfel_form_factor(1, x) != 0 || ssgi_surfel_reach(x, 1, 0.1) != 0
            || ssgi_surfel_reach(1, x, 0.1) != 0 || ssgi_surfel_reach(1, 1, x) != 0 || shell[0] != 0 || shell[1] != 0
            || after[0] != 0 || after[1] != 0)
            WRONG("a formula of surfels takes %08x for a number", (unsigned)not_finite[k]);
    }
}

static const char *why = "";

static void expect(int good, const char *sentence)
{
    if (!good) WRONG("%s (\"%s\")", sentence, why);
}

/* Checks that a survey leaves out a pixel that is not finite in any one of its pictures. */
static void surveyed(void)
{
    static float picture[4][4] = { { 0.5f, 0.5f, 0.5f, 0.9f }, { 0.5f, 0.6f, 0.5f, 0.8f },
                                   { 0.4f, 0.5f, 0.5f, 0.8f }, { 0.5f, 0.5f, 0.6f, 0.9f } };
    for (int i = 0; i < 16; ++i)
        for (size_t k = 0; k < NOT_FINITE; ++k) {
            const float was = picture[i / 4][i % 4];
            float left[4][3]; /* the other pixels */
            ssgi_survey all, others;
            for (int n = 0; n < 12; ++n) left[n / 3][n % 3] = picture[n / 3][n % 3 + (n % 3 >= i % 4)];
            memcpy(&picture[i / 4][i % 4], &not_finite[k], sizeof not_finite[k]);
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

/* Checks that colours count as 0 in components that are not finite, and so do such normals. The others stay. */
static void coloured(void)
{
    static float given[18] = { 0.5f, 0.25f, 1, 0.5f, 0.25f, 1, 0.5f, 0.25f, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1 };
    static const float kept[9] = { 0, 0, -1, 0, 0, 0, 0.5f, 0, 1 }, none = 0; /* of the first corner */
    static ssgi_surfel made[64];
    float divided[54];
    size_t count, patches;
    source.colour = given;
    source.normal = given + 9;
    for (size_t k = 0; k < NOT_FINITE; ++k) {
        for (int c = 0; c < 3; ++c) memcpy(&given[3 * c + 1], &not_finite[k], sizeof not_finite[k]);
        memcpy(&given[9], &not_finite[k], sizeof not_finite[k]);
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

/* Checks that rays that are not finite hit nothing, in both queries, and write nothing. */
static void rays(void)
{
    for (size_t k = 0; k < NOT_FINITE; ++k)
        for (int i = 0; i < 6; ++i) {
            float ray[6] = { 0.2f, 0.2f, 1, 0, 0, -1 };
            ssgi_hit hit = { -1, -1, -1, 7 };
            expect(ssgi_trace_any(&trace, ray, ray + 3, 0, 10) && !ssgi_trace_any(&trace, ray, ray + 3, 0, 1),
                   "the triangle is not two away");
            memcpy(&ray[i], &not_finite[k], sizeof not_finite[k]);
            expect(!ssgi_trace_any(&trace, ray, ray + 3, 0, 10)
                       && !ssgi_trace_closest(&hit, &trace, ray, ray + 3, 0, 10) && hit.triangle == 7,
                   "a ray that is not finite hits");
        }
}

/* Tries finite input whose squares, inverses or products are not finite. */
static void extremes(void)
{
    static const float nothing[16] = { 1.2f, 0, 0, 0, 0, 1.6f, 0, 0, 0, 0, -1.002f, -1, 0, 0, 0.2002f, 0 };
    static const int thickness[] = { -100000000, -1, 4, 7 };
    static const float dark[] = { 1e-45f, 1e-38f, 9e-31f };
    float wide[16];
    ssgi_view seen;
    ssgi_gl_desc desc = { 0 };
    ssgi_plan planned;
    ssgi_gl_frame frame;
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
    frame.last_footprint = 7;
    expect(ssgi_view_from_projection(&seen, wide_ortho, SSGI_CLIP_GL, 1, 1, &why) == SSGI_OK
               && ssgi_gl_frame_init(&frame, &view, number, &why) == SSGI_OK
               && ssgi_gl_frame_history(&frame, &seen, rigid_, other, &why) == SSGI_OK
               && ssgi_gl__within(&frame.last_footprint, 1, SSGI_FAR) && frame.last_footprint > 9e17f,
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
        frame.sent = 7;
        expect(ssgi_gl_sent_set(&frame, surfel, 2, NULL, 0, sky, &why) == SSGI_OK && frame.sent == 7,
               "a radiance that texts cannot divide by counts as bright");
    }
}

/* Checks that functions that return a size return 0 for a bad argument. */
static void rooms(void)
{
    for (size_t k = 0; k < NOT_FINITE; ++k) {
        memcpy(&baked.reach, &not_finite[k], sizeof baked.reach);
        expect(!ssgi_field_bake_size(&baked, 1), "a bake's reach that is not finite is taken");
    }
    baked.reach = 0;
    expect(ssgi_field_bake_size(&baked, 1) > 0, "a bake takes no room");
}

int main(void)
{
    arguments_refused();
    formulas();
    surfel_formulas();
    extremes();
    surveyed();
    coloured();
    rays();
    rooms();
    return wrong != 0;
}
