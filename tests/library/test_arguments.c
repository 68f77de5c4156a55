/* test_arguments.c - calls with bad arguments. Each argument's limits are a row; each limit is broken alone, in every
   way that the argument's kind has. The function must refuse, name the argument and write nothing. nan.c includes it,
   too, and is compiled by other rules of arithmetic: WRONG(format, ..) notes a fault. */
#include "../../ssgi_gl.h"
#include <math.h>
#include <string.h>
#ifndef WRONG
#include "t.h"
#define WRONG(...) CHECK(0, __VA_ARGS__)
#endif

/* The arguments of the next call, in their order. */
static union {
    void *p;
    int n;
    float f;
    size_t z;
} arg[9];
#define P(i) arg[i].p
#define N(i) arg[i].n
#define F(i) arg[i].f
#define Z(i) arg[i].z

/* Valid arguments. */
static float projection[16] = { 1.3f, 0, 0, 0, 0, 2.4f, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2002f, 0 };
static float rigid_[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, -2, 1 };
static float other[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0.1f, 0, -2, 1 };
static float triangle[9] = { 0, 0, -1, 1, 0, -1, 0, 1, -1 };
static float colour[3] = { 1, 2, 3 }, up[3] = { 0, 1, 0 }, coefficients[48] = { 1 }, image[8 * 8 * 3] = { 1 };
static float number = 0.5f;
static const float *faces[6] = { image, image, image, image, image, image };
static ssgi_view view;
static ssgi_sun suns[1] = { { { 0, 1, 0 }, { 1, 1, 1 } } };
static ssgi_surfel_desc surfels = { 0.2f, 4, 0.1f, 0, 5, SSGI_OVERHANG_CENTROID };
static ssgi_surfel_source source;
static ssgi_splat splat = { 0.1f, 1, 1, 0.1f, 4, 0, 0 };
static ssgi_surfel surfel[2] = { { { 0, 0, -1 }, 0.1f, { 0, 0, 1 }, 0.5f, { 1, 1, 1 }, 0 },
                                 { { 0, 1, -1 }, 0.1f, { 0, 0, 1 }, 0.5f, { 1, 1, 1 }, 0 } };
static ssgi_gl_light light = { { 0, 0, 1 }, 0, { 1, 1, 1 }, 0, { 0, 0, 0 }, 0, { { 0 } }, { 0 }, { 0 } };
static ssgi_dipole dipole;
static ssgi_field_desc baked;
static ssgi_field field;
static ssgi_field_limits limits;
static ssgi_trace trace;
static ssgi_plan_scene scene;
static uint32_t texels[432], words[9];
static float work[1 << 17];

/* Room for outputs of calls: the first output, and one half of the room behind it. */
enum { ROOM = 20000 };
static double written[ROOM], untouched[ROOM];

/* Fills in the arguments that the library itself makes. Returns 0 and a reason if it cannot. */
static int arguments_begin(const char **why)
{
    static unsigned char memory[4096];
    memset(untouched, 0x5a, sizeof untouched);
    baked.resolution = baked.radii = 4;
    memcpy(source.to_view, rigid_, sizeof rigid_);
    source.position = triangle;
    source.triangles = 1;
    scene.error = 0.03f;
    scene.screen_radius = 0.1f;
    if (ssgi_view_from_projection(&view, projection, SSGI_CLIP_GL, 64, 36, why) != SSGI_OK
        || ssgi_dipole_set(&dipole, colour, up, 1.5f, why) != SSGI_OK
        || ssgi_trace_build(&trace, memory, sizeof memory, triangle, 12, NULL, 1, why) != SSGI_OK
        || ssgi_field_bake(&field, texels, work, sizeof work, &baked, triangle, 12, NULL, 1, why) != SSGI_OK)
        return 0;
    limits = ssgi_field_limits_of(&field);
    return 1;
}

#define CALL(name, expression) static ssgi_result name(const char **why) { return expression; }
CALL(view_of, ssgi_view_from_projection(P(0), P(1), N(2), N(3), N(4), why))
CALL(extra, ssgi_extra_camera(P(0), P(1), P(2), P(3), F(4), P(5), why))
CALL(guess, ssgi_radius_guess(P(0), NULL, P(1), Z(2), NULL, Z(3), P(4), words, 9, why))
CALL(kernel, ssgi_kernel(P(0), N(1), N(2), why))
CALL(spread_of, ssgi_directions(P(0), N(1), N(2), N(3), why))
CALL(tile, ssgi_noise_tile(P(0), N(1), N(2), N(3), why))
CALL(equirect_sh, ssgi_sh_project_equirect(P(0), N(1), P(2), N(3), N(4), why))
CALL(cube_sh, ssgi_sh_project_cube(P(0), N(1), P(2), N(3), why))
CALL(sh_light, ssgi_sh_light(P(0), N(1), P(2), F(3), P(4), N(5), why))
CALL(map, ssgi_environment_map(P(0), N(1), P(2), N(3), N(4), F(5), why))
CALL(cone, ssgi_environment_cone(P(0), N(1), P(2), N(3), N(4), F(5), why))
CALL(cut, ssgi_environment_suns(P(0), N(1), P(2), N(3), N(4), why))
CALL(residual, ssgi_sh_residual(P(0), N(1), P(2), N(3), P(4), N(5), why))
CALL(choose, ssgi_vpl_choose(P(0), N(1), P(2), P(3), P(4), Z(5), why))
CALL(area, ssgi_vpl_area(P(0), N(1), P(2), P(3), P(4), N(5), P(6), why))
CALL(points, ssgi_tess_points(P(0), N(1), why))
CALL(scale, ssgi_surfel_scale(P(0), P(1), P(2), why))
CALL(divide, ssgi_surfels_divide(P(0), 2, P(1), P(2), P(3), P(4), why))
CALL(make, ssgi_surfels(P(0), 64, P(1), P(2), P(3), P(4), why))
CALL(splat_size, ssgi_splat_size(P(0), N(1), N(2), N(3), why))
CALL(predict, ssgi_surfels_predict(P(0), P(1), P(2), P(3), P(4), why))
CALL(scattering, ssgi_dipole_set(P(0), P(1), P(2), F(3), why))
CALL(built, ssgi_trace_build(P(0), P(1), 4096, P(2), Z(3), NULL, Z(4), why))
CALL(seen, ssgi_trace_visibility(P(0), P(1), P(2), P(3), 1, F(4), N(5), N(6), why))
CALL(caps, ssgi_cap_table(P(0), N(1), why))
CALL(blocked, ssgi_cap_light(P(0), P(1), N(2), F(3), P(4), P(5), why))
CALL(bake, ssgi_field_bake(P(0), P(1), P(2), sizeof work, P(3), P(4), Z(5), NULL, Z(6), why))
CALL(calibrate, ssgi_plan_calibrate(P(0), P(1), P(2), P(3), P(4), NULL, NULL, Z(5), N(6), F(7), why))
CALL(survey, ssgi_survey_of(P(0), P(1), P(2), P(3), NULL, 1, why))
CALL(plan, ssgi_plan_make(P(0), P(1), why))
CALL(frame_of, ssgi_gl_frame_init(P(0), P(1), F(2), why))
CALL(last, ssgi_gl_frame_history(P(0), P(1), P(2), P(3), why))
CALL(time_of, ssgi_gl_frame_time(P(0), F(1), F(2), F(3), why))
CALL(surfels_of, ssgi_gl_surfels_set(P(0), P(1), P(2), P(3), why))
CALL(sent, ssgi_gl_sent_set(P(0), P(1), 2, P(2), N(3), P(4), why))
CALL(dipole_of, ssgi_gl_dipole_set(P(0), P(1), F(2), why))
CALL(harmonics_of, ssgi_gl_harmonics_set(P(0), P(1), N(2), P(3), why))
CALL(extra_view, ssgi_gl_views_set(P(0), N(1), P(2), P(3), P(4), why))
CALL(shadow_map, ssgi_gl_light_map(P(0), P(1), N(2), N(3), P(4), P(5), why))
CALL(occluder, ssgi_gl_occluder_set(P(0), P(1), P(2), P(3), N(4), N(5), why))

/* Kinds of arguments and their bad values. COUNT, SIZE, NUMBER: both values of bad, and a NUMBER is also not finite.
   POINTER: NULL. DIRECTION: NULL and zeros. OPTIONAL: NULL is allowed. RIGID: NULL and matrices that are not rigid.
   MEMBER: floats in another argument's memory. CHOICE, LIMITED: an int and a float there, by both values of bad. */
enum { NONE, COUNT_, SIZE_, NUMBER_, POINTER_, DIRECTION_, OPTIONAL_, RIGID_, MEMBER_, CHOICE_, LIMITED_ };

typedef struct argument {
    const char *name; /* the name with which a refusal must begin */
    int kind, floats; /* floats: how many of the argument's must be finite */
    void *at;
    double is, bad[2];
} argument;

#define COUNT(name, low, high) { name, COUNT_, 0, NULL, low, { (low) - 1.0, (high) + 1.0 } }
#define SIZE(name, is, bad) { name, SIZE_, 0, NULL, is, { bad, bad } }
#define STRIDE { "stride_bytes", SIZE_, 0, NULL, 12, { 8, 14 } }
#define TRIANGLES { "triangles", SIZE_, 0, NULL, 1, { 0, SSGI_TRACE_MAX_TRIANGLES + 1.0 } }
#define NUMBER(name, is, below, above) { name, NUMBER_, 0, NULL, is, { below, above } }
#define OUT(name) { name, POINTER_, 0, written, 0, { 0, 0 } }
#define SECOND(name) { name, POINTER_, 0, written + ROOM / 2, 0, { 0, 0 } }
#define GIVEN(name, at) { name, POINTER_, 0, at, 0, { 0, 0 } }
#define FLOATS(name, at, count) { name, POINTER_, count, at, 0, { 0, 0 } }
#define DIRECTION(name, at) { name, DIRECTION_, 3, at, 0, { 0, 0 } }
#define RIGID(name, at) { name, RIGID_, 16, at, 0, { 0, 0 } }
#define OPTIONAL(name, at, count) { name, OPTIONAL_, count, at, 0, { 0, 0 } }
#define MEMBER(name, at, count) { name, MEMBER_, count, at, 0, { 0, 0 } }
#define CHOICE(name, at, below, above) { name, CHOICE_, 0, at, 0, { below, above } }
#define LIMITED(name, at, below, above) { name, LIMITED_, 1, at, 0, { below, above } }
#define SURFELS LIMITED("desc.size", &surfels.size, 1e-5, 2), CHOICE("desc.splits", &surfels.splits, -1, 33), \
                LIMITED("desc.offscreen_growth", &surfels.offscreen_growth, -1, 2), \
                CHOICE("desc.keep_small", &surfels.keep_small, -1, 2), \
                LIMITED("desc.max_distance", &surfels.max_distance, -1, -1), \
                CHOICE("desc.overhang", &surfels.overhang, -1, 2)
#define SOURCE GIVEN("source", &source), MEMBER("source.to_view", source.to_view, 16), \
               CHOICE("source", &source.position_stride, 13, 14), CHOICE("source", &source.normal_stride, 13, 14), \
               CHOICE("source", &source.colour_stride, 13, 14)
#define SIDES(size, low, high) OUT("out"), COUNT(size, low, high), GIVEN("rgb", image), COUNT("width", 1, 65536), \
                               COUNT("height", 1, 65536)

static const struct call {
    const char *name;
    ssgi_result (*call)(const char **why);
    argument arguments[16];
} calls[] = {
    { "ssgi_view_from_projection", view_of,
      { OUT("view"), FLOATS("projection", projection, 16), COUNT("clip", 0, 3), COUNT("width", 1, 65536),
        COUNT("height", 1, 65536) } },
    { "ssgi_extra_camera", extra,
      { OUT("world_to_view"), SECOND("projection"), RIGID("main_world_to_view", rigid_), FLOATS("centre", up, 3),
        NUMBER("radius", 1, 0, -1), FLOATS("displacement", colour, 3) } },
    { "ssgi_radius_guess", guess,
      { OUT("radius"), FLOATS("position", triangle, 9), SIZE("stride_bytes", 12, 8), SIZE("triangles", 1, 0),
        OPTIONAL("up", up, 3) } },
    { "ssgi_kernel", kernel, { OUT("out"), COUNT("sets", 1, 4096), COUNT("samples", 1, 4096) } },
    { "ssgi_directions", spread_of,
      { OUT("out"), COUNT("kind", 0, 2), COUNT("sets", 1, 4096), COUNT("samples", 1, 4096) } },
    { "ssgi_noise_tile", tile,
      { OUT("out"), COUNT("size", 1, 64), COUNT("sets", 1, 1), COUNT("directions", 1, 1024) } },
    { "ssgi_sh_project_equirect", equirect_sh, { SIDES("bands", 1, 6) } },
    { "ssgi_sh_project_cube", cube_sh,
      { OUT("out"), COUNT("bands", 1, 6), GIVEN("faces", faces), COUNT("size", 1, 65536) } },
    { "ssgi_sh_light", sh_light,
      { OUT("coefficients"), COUNT("bands", 1, 6), DIRECTION("direction", up), NUMBER("sine", 0, -0.1, 1.1),
        FLOATS("irradiance", colour, 3), COUNT("window", 0, 2) } },
    { "ssgi_environment_map", map, { SIDES("size", 8, 256), NUMBER("solid_angle", 0, -1, -1) } },
    { "ssgi_environment_cone", cone, { SIDES("size", 8, 256), NUMBER("cosine", 0, -0.1, 0.96) } },
    { "ssgi_environment_suns", cut, { SIDES("count", 1, 1024) } },
    { "ssgi_sh_residual", residual,
      { OUT("map"), COUNT("size", 8, 256), GIVEN("coefficients", coefficients), COUNT("bands", 1, 6),
        GIVEN("suns", suns), { "suns", COUNT_, 0, NULL, 1, { -1, -9 } } } },
    { "ssgi_vpl_choose", choose,
      { OUT("out"), COUNT("count", 1, 4096), GIVEN("position", triangle), GIVEN("normal", triangle),
        GIVEN("flux", image), SIZE("pixels", 1, 0) } },
    { "ssgi_vpl_area", area,
      { OUT("out"), COUNT("count", 1, 4096), FLOATS("corner", triangle, 3), DIRECTION("a", up), FLOATS("b", image, 3),
        COUNT("triangle", 0, 1), FLOATS("radiance", colour, 3) } },
    { "ssgi_tess_points", points, { OUT("uvw"), COUNT("level", 1, 64) } },
    { "ssgi_surfel_scale", scale, { OUT("scale"), GIVEN("desc", &surfels), GIVEN("view", &view), SURFELS } },
    { "ssgi_surfels_divide", divide,
      { OUT("out"), SECOND("count"), GIVEN("desc", &surfels), GIVEN("view", &view), SOURCE, SURFELS } },
    { "ssgi_surfels", make,
      { OUT("out"), SECOND("count"), GIVEN("desc", &surfels), GIVEN("view", &view), SOURCE, SURFELS } },
    { "ssgi_splat_size", splat_size,
      { OUT("size"), COUNT("width", 1, 65536), COUNT("height", 1, 65536), COUNT("levels", 1, 7) } },
    { "ssgi_surfels_predict", predict,
      { OUT("cost"), GIVEN("desc", &surfels), GIVEN("splat", &splat), GIVEN("view", &view), SOURCE,
        LIMITED("splat.epsilon", &splat.epsilon, -1, 2), LIMITED("splat.max_distance", &splat.max_distance, -1, -1),
        LIMITED("splat.max_radiance", &splat.max_radiance, -1, -1),
        LIMITED("splat.near_depth", &splat.near_depth, -1, -1), CHOICE("splat.levels", &splat.levels, -1, 8),
        CHOICE("splat.part", &splat.part, 3, 5), CHOICE("splat.two_sided", &splat.two_sided, -1, 2) } },
    { "ssgi_dipole_set", scattering,
      { OUT("dipole"), FLOATS("sigma_s", colour, 3), FLOATS("sigma_a", up, 3), NUMBER("eta", 1.5, 0.9, 3.1) } },
    { "ssgi_trace_build", built, { OUT("trace"), SECOND("memory"), GIVEN("position", triangle), STRIDE, TRIANGLES } },
    { "ssgi_trace_visibility", seen,
      { OUT("out"), GIVEN("trace", &trace), GIVEN("position", up), GIVEN("normal", up), NUMBER("radius", 1, 0, -1),
        COUNT("rays", 1, 65536), COUNT("hard", 0, 1) } },
    { "ssgi_cap_table", caps, { OUT("out"), COUNT("size", 2, 4096) } },
    { "ssgi_cap_light", blocked,
      { OUT("out"), FLOATS("coefficients", coefficients, 3), COUNT("bands", 1, 6),
        NUMBER("solid_angle", 0.5, 0.5, 0.5), DIRECTION("axis", up), DIRECTION("normal", colour) } },
    { "ssgi_field_bake", bake,
      { OUT("field"), SECOND("texels"), GIVEN("work", work), GIVEN("desc", &baked), GIVEN("position", triangle), STRIDE,
        TRIANGLES, MEMBER("desc.reach", &baked.reach, 1) } },
    { "ssgi_plan_calibrate", calibrate,
      { OUT("calibration"), GIVEN("trace", &trace), GIVEN("position", up), GIVEN("normal", up), GIVEN("hsao", &number),
        SIZE("count", 1, 0), COUNT("rays", 2, 65536), NUMBER("radius", 1, 0, -1) } },
    { "ssgi_survey_of", survey,
      { OUT("survey"), GIVEN("hsao", &number), GIVEN("best", &number), GIVEN("solid", &number) } },
    { "ssgi_plan_make", plan,
      { OUT("plan"), GIVEN("scene", &scene), CHOICE("scene.wanted", &scene.wanted, -1, 4),
        CHOICE("scene.unit", &scene.unit, -1, 2), CHOICE("scene.device", &scene.device, -1, 3),
        CHOICE("scene.device", &scene.thickness, -1, 4), CHOICE("scene.device", &scene.history, -1, 2),
        CHOICE("scene.device", &scene.occluders, -1, -1), LIMITED("scene.error", &scene.error, -1, -1),
        LIMITED("scene.error", &scene.budget, -1, -1), LIMITED("scene.error", &scene.screen_radius, -1, -1),
        LIMITED("scene.error", &scene.depth_pass, -1, -1), LIMITED("scene.error", &scene.coverage, -1, -1),
        MEMBER("scene", &scene.survey, sizeof scene.survey / sizeof(float)),
        MEMBER("scene", scene.energy, sizeof scene.energy / sizeof(float)),
        MEMBER("scene", &scene.calibration.unoccluded, 5) } },
    { "ssgi_gl_frame_init", frame_of, { OUT("frame"), GIVEN("view", &view), NUMBER("radius", 1, 0, -1) } },
    { "ssgi_gl_frame_history", last,
      { OUT("frame"), GIVEN("view", &view), RIGID("main_world_to_view", rigid_), RIGID("last_world_to_view", other) } },
    { "ssgi_gl_frame_time", time_of,
      { OUT("frame"), NUMBER("memory", 1, 0, -1), NUMBER("elapsed", 1, 0, -1), NUMBER("last", 1, 0, -1) } },
    { "ssgi_gl_surfels_set", surfels_of,
      { OUT("frame"), GIVEN("view", &view), GIVEN("desc", &surfels), OPTIONAL("mesh_to_view", rigid_, 16),
        SURFELS } },
    { "ssgi_gl_sent_set", sent,
      { OUT("frame"), GIVEN("surfels", surfel), GIVEN("lights", &light),
        { "light_count", COUNT_, 0, NULL, 1, { -1, -9 } }, OPTIONAL("sky", up, 3),
        MEMBER("surfels", surfel[1].position, 11), MEMBER("lights", &light, sizeof light / sizeof(float)) } },
    { "ssgi_gl_dipole_set", dipole_of, { OUT("frame"), GIVEN("frame", &dipole), NUMBER("unit", 1, 0, -1) } },
    { "ssgi_gl_harmonics_set", harmonics_of,
      { OUT("frame"), FLOATS("coefficients", coefficients, 3), COUNT("bands", 1, 4),
        OPTIONAL("world_to_view", rigid_, 16) } },
    { "ssgi_gl_views_set", extra_view,
      { OUT("views"), COUNT("i", 0, 3), GIVEN("view", &view), RIGID("main_world_to_view", rigid_),
        RIGID("extra_world_to_view", other) } },
    { "ssgi_gl_light_map", shadow_map,
      { OUT("light"), GIVEN("view", &view), { "x", COUNT_, 0, NULL, 0, { -1, -9 } },
        { "x", COUNT_, 0, NULL, 0, { -1, -9 } }, RIGID("main_world_to_view", rigid_),
        RIGID("light_world_to_view", other) } },
    { "ssgi_gl_occluder_set", occluder,
      { OUT("occluder"), GIVEN("field", &field), OPTIONAL("limits", &limits, sizeof limits / sizeof(float)),
        FLOATS("mesh_to_view", rigid_, 16), COUNT("slice", 0, 2047), COUNT("object", 0, 16777215) } },
};
enum { CALLS = sizeof calls / sizeof *calls, ARGUMENTS = sizeof calls->arguments / sizeof *calls->arguments };

/* A table of bad values, each of one argument: at an element of its memory, or -1: as the argument itself. */
static const struct odd {
    ssgi_result (*call)(const char **why);
    const char *name;
    int element;
    double value;
} odd[] = { { view_of, "projection", 11, 0 },     { view_of, "projection", 3, 0.1 },    /* w is 0; w has x, y, both */
            { view_of, "projection", 7, 0.1 },    { view_of, "projection", 15, 1 },
            { view_of, "projection", 1, 0.1 },    { view_of, "projection", 4, 0.1 },    /* rolled */
            { view_of, "projection", 0, 0 },      { view_of, "projection", 5, 0 },      /* flat */
            { view_of, "projection", 14, 0 },     { view_of, "projection", 14, 1e-42 }, /* z is 0, or too little */
            { view_of, "projection", 0, 1e-42 },  { extra, "radius", -1, 1e-37 },
            { extra, "radius", -1, 1e-44 },       { guess, "up", 1, 0 },
            { cube_sh, "size", -1, 1e6 },         { choose, "flux", 0, 0 },             /* a map without flux */
            { choose, "flux", 0, -1 },            { area, "radiance", 1, -1 },
            { scattering, "sigma_s", 0, 0 },      { scattering, "sigma_a", 0, -1 },
            { extra_view, "i", -1, 1e6 },         { occluder, "mesh_to_view", 0, 1.1 },
            { sent, "sky", 2, -1 },               { scattering, "sigma_s", 1, 0 },
            { make, "source.to_view", 0, 0 },     { predict, "source.to_view", 0, 0 },
            { frame_of, "radius", -1, 2e18 },     { frame_of, "view", 12, 0 } };         /* a view without a width */

/* NaNs and infinities, as the bits of floats. */
static const uint32_t not_finite[] = { 0x7fc00000u, 0xffc00000u, 0x7f800001u, 0x7f800000u, 0xff800000u };
enum { NOT_FINITE = sizeof not_finite / sizeof *not_finite };

static void arguments_right(const struct call *c)
{
    for (int k = 0; k < 9; ++k) {
        const argument *const a = &c->arguments[k];
        if (a->kind == COUNT_) N(k) = (int)a->is;
        else if (a->kind == SIZE_) Z(k) = (size_t)a->is;
        else if (a->kind == NUMBER_) F(k) = (float)a->is;
        else if (a->kind < MEMBER_) P(k) = a->at;
    }
}

/* Checks that a call refuses its bad argument k, names it and writes nothing, with and without a pointer to why. */
static void refuses(const struct call *c, int k, const char *how)
{
    const char *const name = c->arguments[k].name;
    const size_t length = strlen(name);
    for (int silent = 0; silent < 2; ++silent) {
        const char *why = "";
        const ssgi_result result = c->call(silent ? NULL : &why);
        if (result != SSGI_BAD_ARGUMENT
            || (!silent && (strncmp(why, name, length) != 0 || !why[length] || !strchr(":.[,", why[length]))))
            WRONG("%s with %s %s returns %d: \"%s\"", c->name, name, how, (int)result, why);
        if (memcmp(written, untouched, sizeof written) != 0) {
            WRONG("%s writes something although its %s is %s", c->name, name, how);
            memcpy(written, untouched, sizeof written);
        }
    }
}

/* Checks the same with other bits in one float of the argument. */
static void refuses_float(const struct call *c, int k, float *v, const void *bits, const char *how)
{
    float was;
    memcpy(&was, v, sizeof was);
    memcpy(v, bits, sizeof *v);
    refuses(c, k, how);
    memcpy(v, &was, sizeof was);
}

/* Checks that a call refuses matrices that are scaled, sheared, singular or have another last row, and takes a rigid
   one with z negated, and with rounded values. */
static void refuses_matrices(const struct call *c, int k)
{
    static const char *const how[] = { "scaled", "hardly scaled", "sheared", "singular", "of w 2", "of another row" };
    float *const m = c->arguments[k].at, was[16];
    const char *why = "";
    memcpy(was, m, sizeof was);
    for (int i = 0; i < 6; ++i) {
        for (int e = 0; e < 12 && i < 2; ++e) m[e] *= i ? 1.001f : 100;
        for (int e = 0; e < 3 && i == 2; ++e) m[4 + e] += 0.5f * m[e];
        for (int e = 0; e < 3 && i == 3; ++e) m[e] = m[4 + e];
        if (i == 4) m[15] = 2;
        if (i == 5) m[3] = 1e-3f;
        refuses(c, k, how[i]);
        memcpy(m, was, sizeof was);
    }
    for (int e = 0; e < 16; ++e) m[e] *= (e % 4 == 2 ? -1 : 1) * (e < 12 ? 1.0003f : 1);
    if (c->call(&why) != SSGI_OK) WRONG("%s with %s negated and rounded: \"%s\"", c->name, c->arguments[k].name, why);
    memcpy(m, was, sizeof was);
    memcpy(written, untouched, sizeof written);
}

/* Breaks argument k in each way that its kind has, and checks that the call refuses it. */
static void refuses_argument(const struct call *c, int k)
{
    const argument *const a = &c->arguments[k];
    for (int i = 0; i < 2 && a->kind < POINTER_ && a->bad[i] != a->is; ++i) {
        if (a->kind == COUNT_) N(k) = (int)a->bad[i];
        else if (a->kind == SIZE_) Z(k) = (size_t)a->bad[i];
        else F(k) = (float)a->bad[i];
        refuses(c, k, i ? "too large" : "too small");
        arguments_right(c);
    }
    if (a->kind == POINTER_ || a->kind == DIRECTION_ || a->kind == RIGID_) {
        P(k) = NULL;
        refuses(c, k, "NULL");
        arguments_right(c);
    }
    for (int i = 0; i < NOT_FINITE && a->kind == NUMBER_; ++i)
        refuses_float(c, k, &F(k), &not_finite[i], "not finite");
    for (int i = 0; i < NOT_FINITE * a->floats; ++i)
        refuses_float(c, k, (float *)a->at + i / NOT_FINITE, &not_finite[i % NOT_FINITE], "not finite");
    for (int i = 0; i < 2 && a->kind >= CHOICE_; ++i) {
        const int whole = (int)a->bad[i];
        const float real = (float)a->bad[i];
        refuses_float(c, k, a->at, a->kind == CHOICE_ ? (const void *)&whole : &real, i ? "too large" : "too small");
    }
    if (a->kind == DIRECTION_) {
        float zeros[3] = { 0, 0, 0 };
        P(k) = zeros;
        refuses(c, k, "0");
        arguments_right(c);
    }
    if (a->kind == RIGID_) refuses_matrices(c, k);
}

/* Breaks every argument of every call, and checks that valid arguments are accepted. */
static void arguments_refused(void)
{
    const char *why = "";
    if (!arguments_begin(&why)) WRONG("arguments that are right: %s", why);
    memcpy(written, untouched, sizeof written);
    for (int i = 0; i < CALLS; ++i) {
        const struct call *const c = &calls[i];
        arguments_right(c);
        if (c->call(&why) != SSGI_OK) WRONG("%s refuses what is right: %s", c->name, why);
        memcpy(written, untouched, sizeof written);
        for (int k = 0; k < ARGUMENTS; ++k) {
            const argument *const a = &c->arguments[k];
            if (a->kind != NONE) refuses_argument(c, k);
            for (size_t o = 0; o < sizeof odd / sizeof *odd && a->kind != NONE; ++o) {
                const float value = (float)odd[o].value;
                if (odd[o].call != c->call || strcmp(odd[o].name, a->name) != 0) continue;
                if (odd[o].element >= 0) refuses_float(c, k, (float *)a->at + odd[o].element, &value, "odd");
                else if (a->kind == COUNT_) N(k) = (int)value;
                else F(k) = value;
                if (odd[o].element < 0) refuses(c, k, "odd");
                arguments_right(c);
            }
        }
    }
}

#ifdef RUN
void test_arguments(void)
{
    RUN("bad arguments are named, outputs stay", arguments_refused);
}
#endif
