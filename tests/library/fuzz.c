/* fuzz.c - calls the library with random bytes as descs, chains, projections, cameras, environments, harmonics, lights,
   triangles, surfels, fields and plans. Has an entry for libFuzzer, and a main that makes the bytes itself.

     clang -g -O1 -fsanitize=fuzzer,address,undefined -DSSGI_LIBFUZZER tests/library/fuzz.c -lm -o fuzz && ./fuzz
     cc -g -O1 -fsanitize=address,undefined tests/library/fuzz.c -lm -o fuzz && ./fuzz [how many] [seed] */
#define SSGI_IMPLEMENTATION
#define SSGI_GL_IMPLEMENTATION
#include "../../ssgi_gl.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

#define MUST(condition) \
    do { \
        if (!(condition)) { \
            fprintf(stderr, "fuzz.c:%d: %s\n", __LINE__, #condition); \
            abort(); \
        } \
    } while (0)

enum { FIELDS = (int)(sizeof ssgi_gl__fields / sizeof ssgi_gl__fields[0]), CODE = 16, MOST = 32 * 1024,
       FLAGS = (int)((sizeof(ssgi_gl_chain) - offsetof(ssgi_gl_chain, blur)) / sizeof(int)),
       CHAIN = 2 * FIELDS + FLAGS + 2 };    /* bytes of a chain */

/* Checks that a step's input is one of the program's own textures, one that an earlier step wrote, or one of this
   frame's textures as the last frame left it. No step reads a texture that it writes. */
static void inputs(const ssgi_gl_step *step, int count, int i)
{
    for (int k = 0; k < step[i].inputs; ++k) {
        const ssgi_gl_input *in = &step[i].input[k];
        int before = 0, anywhere = 0, by_itself = 0;
        MUST(in->unit >= 0 && in->unit < 16);
        if (in->meaning >= 0) {
            MUST(in->meaning < SSGI_GL_YOURS && in->texture == -1 && !in->last);
            continue;
        }
        for (int j = 0; j < count; ++j)
            for (int o = 0; o < step[j].outputs; ++o) {
                const int same = step[j].output[o].texture == in->texture;
                before |= same && j < i;
                anywhere |= same;
                by_itself |= same && j == i;
            }
        MUST(in->texture >= 0 && in->format && (in->last ? anywhere : before && !by_itself));
    }
}

/* Checks that blur restores exactly the light that was left out by the step which wrote its input. */
static void restored(const ssgi_gl_step *step, int i)
{
    const ssgi_gl_desc blur = ssgi_gl_resolve(&step[i].desc);
    int texture = step[i].input[0].texture;
    if (blur.pass != SSGI_GL_PASS_BLUR || blur.filter.quantity != SSGI_GL_QUANTITY_LIGHT) return;
    for (int k = 0; k < step[i].inputs; ++k)
        if (!strcmp(step[i].input[k].name, "t_ssgi_light")) texture = step[i].input[k].texture;
    for (int j = i - 1; j >= 0; --j)
        for (int o = 0; o < step[j].outputs; ++o) {
            const ssgi_gl_desc wrote = ssgi_gl_resolve(&step[j].desc);
            if (step[j].output[o].texture != texture || wrote.pass == SSGI_GL_PASS_HISTORY) continue;
            const int bounce = !strcmp(step[j].output[o].name, "o_ssgi_bounce");
            MUST(blur.light.restore == (bounce ? SSGI_GL_RESTORE_NONE : wrote.light.restore));
            const int map = blur.light.environment == SSGI_GL_ENVIRONMENT_MAP;
            MUST(!blur.light.restore
                 || (map == (wrote.light.environment == SSGI_GL_ENVIRONMENT_MAP)
                     && blur.light.shading == wrote.light.shading && blur.light.residual == wrote.light.residual
                     && blur.light.harmonic_lights == wrote.light.harmonic_lights
                     && (map || blur.light.bands == wrote.light.bands)));
            return;
        }
}

/* Sets the ints of a desc from one byte each. */
static void fill(ssgi_gl_desc *d, const uint8_t *data)
{
    memset(d, 0, sizeof *d);
    for (int i = 0; i < FIELDS; ++i) {
        const int value = data[i];
        memcpy((char *)d + ssgi_gl__fields[i].choice.offset, &value, sizeof value);
    }
    d->shader.fetch = " ";
}

/* Makes steps for a chain of two descs and flags. It is refused with a sentence, or every step can be drawn and there
   is one result: ambient visibility or light, perhaps with a bounce, a bounce alone, or your picture. */
static void chains(const uint8_t *data)
{
    ssgi_gl_chain chain;
    const char *why = NULL;
    int results[3] = { 0, 0, 0 }, pictures = 0;
    memset(&chain, 0, sizeof chain);
    fill(&chain.desc, data);
    fill(&chain.lights, data + FIELDS);
    data += 2 * FIELDS;
    for (int k = 0; k < FLAGS; ++k) {
        const int flag = data[k];
        memcpy((char *)&chain + offsetof(ssgi_gl_chain, blur) + (size_t)k * sizeof flag, &flag, sizeof flag);
    }
    chain.width = 1 + 64 * data[FLAGS];
    chain.height = data[FLAGS + 1];
    const int n = ssgi_gl_steps(NULL, 0, &chain, &why);
    const int room = data[FLAGS] % 4 == 0 && n > 1 ? n / 2 : n;
    MUST(n ? n < 200 : why && strstr(why, ": "));
    ssgi_gl_step *step = n ? (ssgi_gl_step *)malloc((size_t)room * sizeof *step) : NULL;
    if (!step) return;
    MUST(ssgi_gl_steps(step, room, &chain, NULL) == n);
    for (int i = 0; i < room; ++i) {
        MUST(ssgi_gl_check(&step[i].desc, NULL) == SSGI_OK && step[i].width > 0 && step[i].height > 0);
        if (room == n) inputs(step, n, i);
        /* surfels multiply by the light that slices left, so nothing is restored */
        if (room == n && chain.desc.pass != SSGI_GL_PASS_DSS) restored(step, i);
        for (int k = 0; k < step[i].outputs; ++k) {
            const ssgi_gl_output *o = &step[i].output[k];
            MUST(o->format ? o->texture >= 0 : o->texture == -1 && i == n - 1);
            ++results[o->result];
            pictures += !o->format;
        }
    }
    if (room == n)
        MUST(results[1] <= 1 && results[2] <= 1 && pictures == !!chain.desc.filter.onto
             && pictures + results[1] + results[2] > 0 && !(pictures && results[1] + results[2]));
    free(step);
}

/* Sets the ints of a desc from a signed byte each, and its texts. Emits one accepted desc in eight, to save time. */
static void descs(const uint8_t *data, size_t size)
{
    static char text[MOST];
    char version[CODE + 1] = "", fetch[CODE + 1] = "";
    ssgi_gl_io row[SSGI_GL_MAX_IO];
    ssgi_gl_desc d;
    const char *why = NULL;
    size_t sum = 0;
    memset(&d, 0, sizeof d);
    for (size_t i = 0; i < size && i < (size_t)FIELDS; ++i) {
        int value = (signed char)data[i];
        value = value == 127 ? INT32_MAX : value == -128 ? INT32_MIN : value;
        memcpy((char *)&d + i * sizeof value, &value, sizeof value);
    }
    for (size_t i = 0; i < size; ++i) sum += data[i];
    if (size > (size_t)FIELDS + 2) {
        memcpy(version, data + FIELDS, size - FIELDS < CODE ? size - FIELDS : CODE);
        memcpy(fetch, data + size - (size < CODE ? size : CODE), size < CODE ? size : CODE);
        if (data[FIELDS] & 1) d.shader.version = version;
        if (data[FIELDS] & 2) d.shader.fetch = fetch;
    }
    ssgi_gl_desc tuned = d;
    if (ssgi_gl_preset(&tuned, (int)(sum % 4), NULL) == SSGI_OK) MUST(ssgi_gl_check(&tuned, NULL) == SSGI_OK);
    if (ssgi_gl_check(&d, &why) != SSGI_OK) {
        MUST(why && !strncmp(why, "desc", 4));
        MUST(!ssgi_gl_emit(text, sizeof text, &d, SSGI_GL_STAGE_FRAGMENT) && !ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO)
             && !ssgi_gl_key(&d));
        return;
    }
    MUST(ssgi_gl_reflect(&d, row, SSGI_GL_MAX_IO) > 0
         && !ssgi_gl_emit(text, sizeof text, &d, (int)(sum % 100) + SSGI_GL_STAGES));
    if (sum % 8) return;
    size_t n = 0;
    int stage = (int)(sum / 8 % SSGI_GL_STAGES);
    for (int tries = 0; tries < SSGI_GL_STAGES && !n; ++tries) {    /* a pass may lack some of the stages */
        stage = (stage + 1) % SSGI_GL_STAGES;
        n = ssgi_gl_emit(text, sizeof text, &d, stage);
    }
    MUST(n > 60 && n < sizeof text && strlen(text) == n && ssgi_gl_key(&d));
    const size_t room = sum * 97 % (n + 2);
    /* ends at the end of the room, so that a sanitizer sees a byte too many */
    char *exact = (char *)malloc(room + 1);
    if (exact) MUST(ssgi_gl_emit(exact + 1, room, &d, stage) == n && (!room || !exact[room]));
    free(exact);
}

static int all_finite(const float *f, size_t count)
{
    while (count && isfinite(*f)) { ++f; --count; }
    return !count;
}

/* Takes random floats as harmonics, lights and skies; sh is [3*i + c], and finite. */
static void harmonics(float *sh, int bands, const float *f, size_t count)
{
    float out[SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS], turned[3 * SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS],
        window[SSGI_SH_MAX_BANDS];
    const int any = (int)(count * 7 % 17) - 5;             /* also numbers that the library must clamp */
    const char *why = NULL;
    ssgi_sh_basis(out, any, f);
    ssgi_sh_window(window, any, any);
    ssgi_sh_zonal(out, any, f, f + 6);
    ssgi_sh_rotate(turned, any, count >= 3 * sizeof out / sizeof *out ? f : sh, any < bands ? 3 : 1,
                   count >= 11 ? f : NULL);
    ssgi_sh_rotate(turned, bands, sh, 3, NULL);
    MUST(all_finite(turned, (size_t)(3 * bands * bands)));
    if (ssgi_sh_light(sh, bands, f, fabsf(f[3]), f + 4, any, &why) != SSGI_OK) MUST(strchr(why, ':'));
    if (ssgi_sh_light(sh, bands, f, 0.5f, f + 4, (int)(count % 3), &why) != SSGI_OK)
        MUST(!strncmp(why, "direction:", 10) || !strncmp(why, "irradiance:", 11));
    MUST(all_finite(sh, (size_t)(3 * bands * bands)));
}

/* Takes pictures of random size as environments, and their pixels as a reflective shadow map. */
static void pictures(const float *f, size_t count)
{
    const size_t pixels = count / 3, width = 1 + (size_t)fabsf(isfinite(f[0]) ? fmodf(f[0], 16) : 3) % pixels,
                 height = pixels / width;
    const float *const faces[6] = { f, f, f, f, f, f };
    const int bands = 1 + (int)(count % SSGI_SH_MAX_BANDS), many = 1 + (int)(count % 17);
    float sh[3 * SSGI_SH_MAX_BANDS * SSGI_SH_MAX_BANDS], map[3 * 8 * 8], e[2], d[3];
    ssgi_sun sun[17];
    ssgi_vpl vpl[17];
    const char *why = NULL;
    MUST(ssgi_sh_project_equirect(sh, bands, f, (int)width, (int)height, &why) == SSGI_OK
         && all_finite(sh, (size_t)(3 * bands * bands)));
    if (count > 16 && count % 5 == 0) harmonics(sh, bands, f, count);
    MUST(ssgi_sh_project_cube(sh, 3, faces, (int)sqrt((double)pixels), &why) == SSGI_OK && all_finite(sh, 27));
    MUST(ssgi_sh_project_equirect(sh, bands, f, (int)width, 0, &why) == SSGI_BAD_ARGUMENT
         && !strncmp(why, "height:", 7));
    MUST(ssgi_environment_suns(sun, many, f, (int)width, (int)height, &why) == SSGI_OK);
    for (int i = 0; i < many; ++i) MUST(all_finite(sun[i].irradiance, 3) && all_finite(sun[i].direction, 3));
    if (count > 64 && count % 16 == 9) {                   /* this takes long */
        MUST(ssgi_environment_map(map, 8, f, (int)width, (int)height, fabsf(f[1]) < 10.0f ? fabsf(f[1]) : 0.0f, &why)
                 == SSGI_OK
             && all_finite(map, 3 * 8 * 8));
        if (ssgi_environment_cone(map, 8, f, (int)width, (int)height, fabsf(f[1]), &why) != SSGI_OK)
            MUST(!strncmp(why, "cosine:", 7));
        else MUST(all_finite(map, 3 * 8 * 8));
    }
    if (ssgi_vpl_choose(vpl, many, f, f, f, pixels, &why) != SSGI_OK) MUST(!strncmp(why, "flux:", 5));
    else for (int i = 0; i < many; ++i) MUST(all_finite(vpl[i].intensity, 3));
    if (count >= 9 && ssgi_vpl_area(vpl, many, f, f + 3, f + 6, many % 2, f + 1, &why) != SSGI_OK)
        MUST(strchr(why, ':'));
    else
        for (int i = 0; i < many && count >= 9; ++i)
            MUST(all_finite(vpl[i].position, 3) && all_finite(vpl[i].normal, 3) && all_finite(vpl[i].intensity, 3));
    for (size_t i = 0; i + 3 <= count; i += 3) {
        ssgi_octahedral_encode(e, f + i);
        ssgi_octahedral_decode(d, e);
        if (all_finite(f + i, 3))
            MUST(fabsf(e[0]) <= 1.0f && fabsf(e[1]) <= 1.0f
                 && fabsf(d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - 1.0f) < 1e-5f);
    }
}

/* Makes an extra camera by any matrix and bounds; extra and light cameras by any two matrices. */
static void cameras(const float *f, size_t count, const ssgi_view *view)
{
    const float *last = f + count - 16, turn[16] = { 1, 0, 0, 0, 0, 0, 1, 0, 0, -1, 0, 0, f[12], f[13], f[14], 1 };
    float to[16], projection[16], displacement[3];
    ssgi_view other;
    ssgi_gl_views views;
    ssgi_gl_light light;
    const char *why = NULL;
    ssgi_extra_displacement(displacement, (int)(count % 4));
    for (int k = 0; k < 2; ++k) {                          /* 0: random matrices, hardly ever rigid; 1: rigid ones */
        if (ssgi_extra_camera(to, projection, k ? turn : f, f + 3, last[5], k && count % 2 ? displacement : last, &why)
            != SSGI_OK)
            MUST(strchr(why, ':'));
        else
            MUST(ssgi_view_from_projection(&other, projection, SSGI_CLIP_GL, 64, 64, &why) == SSGI_OK
                 && all_finite(to, 16));
    }
    if (ssgi_gl_views_set(&views, (int)(count % 4), view, f, last, &why) != SSGI_OK)
        MUST((strstr(why, "_world_to_view:") || !strncmp(why, "view: ", 6))
             && ssgi_gl_light_map(&light, view, 0, 0, f, last, NULL) != SSGI_OK);
    else MUST(ssgi_gl_light_map(&light, view, 1, 2, f, last, NULL) == SSGI_OK && light.tile[1] == 2.0f);
}

/* Makes surfels of a few triangles, anywhere and moved in any way, and predicts the cost of splatting them. */
static void surfels(const float *f, size_t count, const ssgi_view *view)
{
    static const float still[16] = { 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1 };
    static ssgi_surfel made[256];
    const int levels = (int)(count % 10) - 1;
    ssgi_surfel_source source = { 0 };
    ssgi_surfel_desc d = { 0 };
    ssgi_splat splat = { 0 };
    ssgi_surfel_cost cost;
    ssgi_gl_frame frame;
    const char *why = NULL;
    size_t many = 0, maxima;
    uint32_t work[18];
    float radius;
    d.size = count % 3 ? 0.3f : fabsf(f[3]);
    d.splits = (int)(count % 4);
    d.offscreen_growth = count % 7 ? 0.1f : f[6];
    d.keep_small = (int)(count & 1);
    d.overhang = (int)(count % 5) - 1;
    splat.levels = levels;
    splat.two_sided = (int)(count & 1);
    source.position = f;
    source.normal = count & 2 ? f + 3 : NULL;
    source.triangles = count >= 21 ? 2 : 1;
    memcpy(source.to_view, count & 4 ? f : still, sizeof still);
    if (ssgi_surfels(made, 256, &many, &d, view, &source, &why) != SSGI_OK) MUST(strchr(why, ':'));
    else for (size_t i = 0; i < many && i < 256; ++i) {
            const float *p = made[i].position, *n = made[i].normal,
                        side = fabsf(n[0] * n[0] + n[1] * n[1] + n[2] * n[2] - 1.0f);
            MUST(all_finite(p, 3) && made[i].radius > 0.0f && isfinite(made[i].radius) && side < 1e-5f
                 && made[i].seed >= 0.0f && made[i].seed < 1.0f);
    }
    if (ssgi_radius_guess(&radius, &maxima, f, 12, NULL, source.triangles, count & 8 ? f + 3 : NULL, work, 18, &why)
        == SSGI_OK)
        MUST(radius > 0.0f && isfinite(radius) && maxima < 7);
    else MUST(!strncmp(why, "position:", 9) || !strncmp(why, "up:", 3));
    if (ssgi_surfels_predict(&cost, &d, &splat, view, &source, &why) != SSGI_OK) MUST(strchr(why, ':'));
    else {
        MUST(cost.surfels == many);
        for (int l = 0; l < SSGI_SPLAT_LEVELS; ++l) MUST(cost.pixels[l] >= 0.0);
    }
    if (ssgi_gl_surfels_set(&frame, view, &d, source.to_view, &why) != SSGI_OK) MUST(strchr(why, ':'));
}

/* Bakes fields of a few random triangles. Each is saved, damaged (with a checksum that fits) and loaded. */
static void fields(const float *f, size_t count, const uint8_t *data, size_t size)
{
    static uint32_t texels[6 * 4 * 4 * 2];
    static unsigned char kept[4 * (SSGI__FIELD_HEAD + 6 * 4 * 4 * 2 + 2)], file[sizeof kept];
    static size_t length, calls;
    ssgi_field_desc d = { 0 };
    ssgi_field field;
    const char *why = NULL;
    double q[3], c[3], radii[8], values[8], directions[24] = { 0 };
    d.resolution = 2;
    d.radii = 4;
    d.rays = 16;
    d.unfiltered = (int)(size & 1);
    if (!length || (count >= 27 && calls % 16000 == 15999)) {
        static const float one[9] = { 0, 0, 0, 1, 0, 0, 0, 1, 1 };
        const float *from = length ? f : one;
        const size_t triangles = length ? count / 9 : 1, room = ssgi_field_bake_size(&d, triangles);
        void *work = malloc(room);
        if (work && ssgi_field_bake(&field, texels, work, room, &d, from, 12, NULL, triangles, &why) == SSGI_OK) {
            MUST(field.p95 >= 0.0f && field.p95 <= 1.0f && all_finite(field.low, 8) && all_finite(field.span, 8));
            length = ssgi_field_save(kept, sizeof kept, &field);
            MUST(length && ssgi_field_load(&field, texels, sizeof texels, kept, length, NULL) == SSGI_OK);
        } else MUST(length && !strncmp(why, "position:", 9));
        free(work);
    }
    ++calls;
    memcpy(file, kept, length);
    for (size_t i = 0; i + 3 <= size && i < 24; i += 3)
        file[(data[i] & 1 ? data[i + 1] % 128u : (data[i] * 256u + data[i + 1])) % (length - 8)] = data[i + 2];
    if (size % 8) {
        const uint64_t h = ssgi__field_checksum(file, length - 8);
        ssgi__field_put(file, length / 4 - 2, (uint32_t)h);
        ssgi__field_put(file, length / 4 - 1, (uint32_t)(h >> 32));
    }
    const size_t cut = size % 16 == 5 ? calls % length : length;
    unsigned char *exact = (unsigned char *)malloc(cut + !cut);
    if (exact) memcpy(exact, file, cut);
    if (exact && ssgi_field_load(&field, texels, sizeof texels, exact, cut, &why) == SSGI_OK) {
        for (size_t i = 0; i + 6 <= count && i < 60; i += 3) {
            const float near_by[3] = { field.centre[0] + field.radius * (float)(data[i] - 128) / 64,
                                       field.centre[1] + field.radius * (float)(data[i + 1] - 128) / 64,
                                       field.centre[2] },
                        a = ssgi_field_occlusion(&field, NULL, f + i, f + i + 3),
                        cap = (float)ssgi_cap_occlusion((double)f[i], (double)f[i + 1]);
            const float b = ssgi_field_occlusion(&field, NULL, near_by, f + i + 3);
            MUST(a >= 0.0f && a <= 1.0f && b >= 0.0f && b <= 1.0f && cap >= 0.0f && cap <= 1.0f);
        }
    } else MUST(!exact || !strncmp(why, "file:", 5));
    free(exact);
    for (int i = 0; i < 8; ++i) {
        radii[i] = i + 1.0;
        values[i] = data[i] / 255.0;
        for (int k = 0; k < 3; ++k) directions[3 * i + k] = data[i] % 5 ? (data[(i + k) % 9] - 127.5) : 0;
        ssgi__normalise(directions + 3 * i);
    }
    const double w[3] = { 0, 0, 1 };
    if (calls % 16 == 0)
        MUST(isfinite(ssgi__field_fit(q, radii, values, 3 + (int)(size % 6), 1.0)) && q[0] >= 1.0 && q[2] >= 1.0
             && isfinite(q[1]));
    if (calls % 16 == 1)
        MUST(isfinite(ssgi__field_centre(c, w, radii, directions, 1 + (int)(size % 8), 1e-14))
             && isfinite(c[0] + c[1] + c[2]));
}

static void plans(const float *f, size_t count, const uint8_t *data, size_t size)
{
    const char *why = NULL;
    ssgi_plan_scene s;
    ssgi_plan plan, was;
    memset(&s, 0, sizeof s);
    memset(&was, 7, sizeof was);
    plan = was;
    s.wanted = data[0] % 6 - 1;
    s.thickness = data[1 % size] % 6 - 1;
    s.device = data[2 % size] % 4 - 1;
    s.history = data[7 % size] % 2;
    s.occluders = data[3 % size];
    s.map = data[4 % size] % 2;
    s.surfels = data[5 % size] % 2 ? (double)f[count - 1] : 0.0;
    s.unit = data[9 % size] % 4 - 1;
    s.error = f[0];
    s.budget = f[1];
    s.screen_radius = f[2];
    s.calibration.known = data[6 % size] % 2;
    s.calibration.unoccluded = f[4];
    s.calibration.hsao = f[5];
    s.calibration.slabs = f[6 % count];
    memcpy(s.energy, f + count - 4, sizeof s.energy);
    if (ssgi_survey_of(&s.survey, f, f + count / 4, f + count / 2, data[8 % size] % 2 ? f + 3 * count / 4 : NULL,
                       count / 4, NULL) != SSGI_OK)
        abort();
    if (ssgi_plan_make(&plan, &s, &why) == SSGI_OK)
        MUST(plan.method >= SSGI_PLAN_METHOD_NOTHING && plan.method <= SSGI_PLAN_METHOD_AOF && !isnan(plan.error)
             && plan.cost >= 0.0f && plan.levels <= SSGI_SPLAT_LEVELS && strlen(plan.why) > 8
             && strlen(plan.why) < sizeof plan.why - 1);
    else MUST(!strncmp(why, "scene.", 6) && !memcmp(&plan, &was, sizeof plan));
}

static void floats(const float *f, size_t count)
{
    static char memory[64 * 1024];
    ssgi_view view;
    ssgi_gl_frame frame;
    ssgi_trace trace;
    ssgi_hit hit;
    const char *why = NULL;
    if (count >= 16) {
        const int clip = f[10] > 0 ? SSGI_CLIP_ZERO : SSGI_CLIP_GL, width = 1 + (int)(count * 37 % 65536);
        if (ssgi_view_from_projection(&view, f, clip, width, 65537 - width, &why) == SSGI_OK) {
            MUST(ssgi_gl_frame_init(&frame, &view, 1.0f, NULL) == SSGI_OK);
            for (size_t i = 0; i < count; ++i) {
                float p[3], z = ssgi_view_depth(&view, f[i]);
                MUST(z > 0.0f && z <= SSGI_FAR);
                ssgi_view_position(p, &view, f[i], f[count - 1 - i], z);
                ssgi_view_project(p, &view, p);
                MUST(ssgi_pixel_footprint(&view, z) >= 0.0f);
                MUST(isfinite(ssgi_shadow_bias(ssgi_shadow_patch(f[i], z, (int)i), f[i], z, (int)i & 1)));
            }
            cameras(f, count, &view);
            surfels(f, count, &view);
        } else MUST(why && !strncmp(why, "projection:", 11));
    }
    pictures(f, count);
    for (size_t i = 1; i * 9 <= count && i <= 256; i += i < 4 ? 1 : i / 2) {
        MUST(ssgi_trace_build(&trace, memory, sizeof memory, f, 12, NULL, i, &why) == SSGI_OK && trace.skipped <= i);
        float seen[2] = { -1.0f, -1.0f };
        MUST(ssgi_trace_visibility(seen, &trace, f, f + 3, 1, 0.0f, 4, 1, NULL) == SSGI_OK
             && ssgi_trace_visibility(seen + 1, &trace, f, f + 3, 1, 2.0f, 4, 0, NULL) == SSGI_OK && seen[0] >= 0.0f
             && seen[0] <= 1.0f && seen[1] >= 0.0f && seen[1] <= 1.0f);
        if (!ssgi_trace_closest(&hit, &trace, f, f + 3, 0.0f, 1e30f)) continue;
        MUST(hit.triangle < i && hit.t > 0.0f && hit.u >= 0.0f && hit.v >= 0.0f && hit.u + hit.v <= 1.00001f
             && ssgi_trace_any(&trace, f, f + 3, 0.0f, 1e30f));
    }
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    static float f[256 * 9];
    const size_t count = size / sizeof *f < sizeof f / sizeof *f ? size / sizeof *f : sizeof f / sizeof *f;
    if (size == CHAIN) { chains(data); return 0; }
    if (size) descs(data, size);
    if (count) memcpy(f, data, count * sizeof *f);
    if (count >= 9) {
        floats(f, count);
        fields(f, count, data, size);
        plans(f, count, data, size);
    }
    return 0;
}

#ifndef SSGI_LIBFUZZER
static uint32_t next(uint32_t *state) { *state = *state * 1664525u + 1013904223u; return *state >> 8; }

static uint8_t legal(size_t field, uint32_t *state)
{
    return (uint8_t)(next(state) % ((uint32_t)ssgi_gl__fields[field].choice.most + 1u));
}

/* Makes the bytes of a chain whose fields mostly have their default. */
static void random_chain(uint8_t bytes[CHAIN], uint32_t *state)
{
    static const uint8_t passes[] = { SSGI_GL_PASS_SSAO,  SSGI_GL_PASS_HSAO, SSGI_GL_PASS_SSDO, SSGI_GL_PASS_SSDO,
                                      SSGI_GL_PASS_SSDO,  SSGI_GL_PASS_S3HO, SSGI_GL_PASS_S3HO, SSGI_GL_PASS_AOF,
                                      SSGI_GL_PASS_DSS, SSGI_GL_PASS_DSS };
    for (size_t k = 0; k < 2 * FIELDS; ++k) bytes[k] = next(state) % 3 ? 0 : legal(k % FIELDS, state);
    bytes[0] = passes[next(state) % sizeof passes];        /* pass is the desc's first field */
    bytes[FIELDS] = next(state) % 2 ? SSGI_GL_PASS_LIGHTS : 0;
    for (size_t k = 2 * FIELDS; k < CHAIN; ++k) bytes[k] = next(state) % 2;
    for (size_t k = CHAIN - 2; k < CHAIN; ++k) bytes[k] = (uint8_t)next(state);
}

int main(int argc, char **argv)
{
    static const float plain[16] = { 1.3f, 0, 0, 0, 0, 2.4f, 0, 0, 0, 0, -1.002f, -1, 0, 0, -0.2f, 0 };
    const long times = argc > 1 ? atol(argv[1]) : 1000000;
    uint32_t state = argc > 2 ? (uint32_t)atol(argv[2]) : 1;
    uint8_t bytes[4 * 9 * 64];
    for (long i = 0; i < times; ++i) {
        if (i % 2) {
            random_chain(bytes, &state);
            LLVMFuzzerTestOneInput(bytes, CHAIN);
            continue;
        }
        /* most inputs are a valid desc with at most one wrong byte */
        size_t size = FIELDS + next(&state) % CODE, k;
        if (i % 32 == 0) size = next(&state) % (sizeof bytes + 1);
        for (k = 0; k < size; ++k)
            bytes[k] = k < FIELDS && i % 32 ? legal(k, &state) : (uint8_t)next(&state);
        if (i % 3 == 0) bytes[next(&state) % FIELDS] = (uint8_t)next(&state);
        /* bytes of floats of a sensible size, and of a projection */
        if (i % 64 == 0)
            for (k = 0; 4 * k + 4 <= size; ++k) {
                float x = k < 16 && i % 128 == 0 ? plain[k] : ((float)next(&state) - 8e6f) * (i % 5 ? 1e-6f : 1e24f);
                memcpy(bytes + 4 * k, &x, sizeof x);
            }
        LLVMFuzzerTestOneInput(bytes, size);
    }
    printf("%ld inputs, nothing found\n", times);
    return 0;
}
#endif
