/* deep.c - deep screen space: surfels of a scene, and the passes that splat them. Declared in kit_run.h. */
#include "kit/kit_run.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Makes a vertex array of interleaved vec3 or vec4 attributes. */
static GLuint array_of(GLuint buffer, int attributes, int components, GLuint divisor)
{
    GLuint array;
    GLint was;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &was);
    glGenVertexArrays(1, &array);
    glBindVertexArray(array);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    for (GLuint i = 0; i < (GLuint)attributes; ++i) {
        glEnableVertexAttribArray(i);
        glVertexAttribPointer(i, components, GL_FLOAT, GL_FALSE, attributes * components * 4,
                              (const void *)(size_t)(i * (GLuint)components * 4));
        glVertexAttribDivisor(i, divisor);
    }
    glBindVertexArray((GLuint)was);
    return array;
}

static GLuint buffer_of(const void *data, size_t size)
{
    GLuint buffer;
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)size, data, GL_STATIC_DRAW);
    return buffer;
}

/* Returns the scene's triangles, 9 floats a vertex, with huge ones divided: first small triangles, then those that the
   GPU splits (GL_PATCHES). NULL: no memory. */
static float *patches_of(const kit_scene *scene, const ssgi_surfel_desc *d, const ssgi_view *view,
                         const float picture[16], int grey, int patches[2])
{
    const kit_mesh *mesh = &scene->mesh;
    const ssgi_splat splat = { 0 };
    ssgi_surfel_source source = { .position = mesh->position, .normal = mesh->normal, .triangles = mesh->triangles };
    float *colour = malloc((9 * mesh->triangles + 1) * sizeof *colour), *divided = NULL, *sorted = NULL;
    size_t count = 0, n[2] = { 0, 0 };
    for (size_t i = 0; colour && i < 9 * mesh->triangles; ++i) colour[i] = grey ? 1 : mesh->albedo[i / 9 * 3 + i % 3];
    source.colour = colour;
    memcpy(source.to_view, picture, sizeof source.to_view);
    if (colour && ssgi_surfels_divide(NULL, 0, &count, d, view, &source, NULL) == SSGI_OK) {
        divided = malloc((27 * count + 1) * sizeof *divided);
        sorted = malloc((27 * count + 1) * sizeof *sorted);
        if (divided) ssgi_surfels_divide(divided, count, &count, d, view, &source, NULL);
    }
    for (size_t t = 0; t < count && divided && sorted; ++t) {      /* large triangles are put at the end of the array */
        ssgi_surfel_cost cost = { 0 };
        ssgi_surfel_source one = { .position = divided + 27 * t, .position_stride = 36, .triangles = 1 };
        memcpy(one.to_view, picture, sizeof one.to_view);
        ssgi_surfels_predict(&cost, d, &splat, view, &one, NULL);
        const int large = cost.splits > 1;
        memcpy(sorted + 27 * (large ? count - ++n[1] : n[0]++), divided + 27 * t, 27 * sizeof *sorted);
    }
    for (int k = 0; k < 2; ++k) patches[k] = (int)n[k];
    if (!divided) { free(sorted); sorted = NULL; }
    free(divided);
    free(colour);
    return sorted;
}

/* Computes the environment's mean radiance. */
static void mean_of(float sky[3], const kit_image *env)
{
    const size_t texels = (size_t)env->width * (size_t)env->height;
    double sum[4] = { 0 };
    for (size_t i = 0; i < texels; ++i) {
        const double area = sin(KIT_PI * ((double)(i / (size_t)env->width) + 0.5) / env->height);
        for (size_t c = 0; c < 3; ++c) sum[c] += area * (double)env->data[c * texels + i];
        sum[3] += area;
    }
    for (int c = 0; c < 3; ++c) sky[c] = (float)(sum[c] / sum[3]);
}

/* The surfels of a run and what they are made from, until passes exist for them. */
typedef struct surfels {
    ssgi_surfel_desc desc;
    ssgi_surfel     *surfel;               /* run->surfels of them */
    float           *vertices;             /* of triangles, 9 floats a vertex */
    int              patches[2];
    ssgi_gl_light   *rows;                 /* `lights` lights in the view space of the picture's camera */
    int              lamps;
} surfels;

/* Reads the frame's depth for two settings. The near depth is set a little below the least depth, or stays if there is
   none. The number of levels suits the projected radius; with an unlimited radius the library's default stays. */
static int look_at_frame(kit_making *m, const surfels *s)
{
    kit_run *run = m->run;
    kit_image frame;
    float least = INFINITY;
    if (!m->set->near_depth && (m->desc.surfel.levels || !(s->desc.max_distance > 0))) return 0;
    if (kit_gbuffer_read_depth(&frame, run->gbuffer, m->err)) return -1;
    const float *z = kit_image_channel(&frame, "Z");
    for (int i = 0; i < frame.width * frame.height; ++i) if (z[i] > 0 && z[i] < least) least = z[i];
    if (m->set->near_depth && least < INFINITY) run->frame.near_depth = fmaxf(0.999f * least, run->frame.near_depth);
    if (!m->desc.surfel.levels && s->desc.max_distance > 0) {
        const double radius = kit_screen_radius(&frame, &run->gbuffer->camera, run->frame.radius);
        m->desc.surfel.levels = kit_method_levels(m->method, radius);
    }
    kit_image_free(&frame);
    return 0;
}

static void surfels_free(surfels *s)
{
    free(s->surfel);
    free(s->vertices);
    free(s->rows);
}

/* Adds the environment, the lights and their shadow maps that light the surfels. For methods with light only. */
static int light_surfels(kit_making *m, surfels *s, const float picture[16])
{
    const kit_image *env = &m->world->lighting->env;
    kit_run *run = m->run;
    kit_seen_places seen;
    int count;
    kit_rotation_of(run->frame.rotation, picture, NULL);
    m->desc.light.environment = SSGI_GL_ENVIRONMENT_MAP;
    if (env->data && kit_add_environment(m)) return -1;
    /* Surfels that pixels show have their light; without slices ssgi_gl_steps lights all surfels. */
    if (!env->data || !m->set->sky) m->desc.light.environment = SSGI_GL_ENVIRONMENT_NONE;
    if (kit_seen(run->gbuffer, &seen, m->err)) return -1;
    kit_placed_light *placed = kit_placed_lights_new(m, &seen, &count, &s->lamps);
    free(seen.point);
    if (!placed) return -1;
    const int failed = kit_add_atlas(m, placed, count);
    if (!failed)
        m->rows[0] = kit_keep(run, s->lamps ? kit_light_rows(placed, 0, s->lamps, picture)
                                            : kit_texture(8, 1, GL_RGBA32F, NULL));
    s->rows = kit_lights_seen(placed, 0, s->lamps, picture);
    free(placed);
    run->frame.lights = s->lamps;
    m->desc.light.shadow = m->lights.light.shadow;
    m->desc.surfel.sends = SSGI_GL_SENDS_LIGHTS;
    return failed;
}

/* Makes the surfels of the scene's triangles, predicts the cost of their splats, and finds the light that they send. */
static int make_surfels(kit_making *m, surfels *s, const ssgi_view *view, const float picture[16])
{
    const kit_image *env = &m->world->lighting->env;
    const int scatter = m->desc.surfel.effect == SSGI_GL_EFFECT_SCATTER,
              custom = m->desc.surfel.effect == SSGI_GL_EFFECT_CUSTOM;
    kit_run *run = m->run;
    const ssgi_splat splat = { .epsilon = run->frame.epsilon, .max_distance = s->desc.max_distance,
                               .levels = m->desc.surfel.levels, .near_depth = run->frame.near_depth,
                               .part = !m->desc.gather.resolution ? 1
                                       : m->desc.gather.resolution < SSGI_GL_RESOLUTION_QUARTER ? 2 : 4,
                               .two_sided = m->desc.light.two_sided || scatter || custom };
    ssgi_surfel_cost cost;
    const char *why = "out of memory";
    float sky[3] = { 0, 0, 0 };
    s->vertices = patches_of(m->world->scene, &s->desc, view, picture, scatter, s->patches);
    if (!s->vertices) return kit_fail(m->err, "surfels: %s", why);
    ssgi_surfel_source source = { .position = s->vertices,
                                  .normal = s->vertices + 3,
                                  .colour = s->vertices + 6,
                                  .position_stride = 36,
                                  .normal_stride = 36,
                                  .colour_stride = 36,
                                  .triangles = (size_t)(s->patches[0] + s->patches[1]) };
    memcpy(source.to_view, picture, sizeof source.to_view);
    int failed = ssgi_surfels(NULL, 0, &run->surfels, &s->desc, view, &source, &why) != SSGI_OK;   /* counts */
    if (!failed) s->surfel = malloc((run->surfels + 1) * sizeof *s->surfel);
    failed = failed || !s->surfel
          || ssgi_surfels(s->surfel, run->surfels, &run->surfels, &s->desc, view, &source, &why) != SSGI_OK
          || ssgi_surfels_predict(&cost, &s->desc, &splat, view, &source, &why) != SSGI_OK;
    if (!failed && m->run->lit) {
        if (env->data && (m->desc.light.environment || m->desc.surfel.effect == SSGI_GL_EFFECT_LIGHT))
            mean_of(sky, env);
        failed = !s->rows || ssgi_gl_sent_set(&run->frame, s->surfel, run->surfels, s->rows, s->lamps, sky, &why)
                                 != SSGI_OK;
    }
    if (failed) return kit_fail(m->err, "surfels: %s", why);
    for (int l = 0; l < SSGI_SPLAT_LEVELS; ++l) run->splat_pixels += run->level_pixels[l] = cost.pixels[l];
    return 0;
}

/* Makes the buffers from which passes make surfels, and those into which they write them. */
static void add_buffers(kit_run *run, const surfels *s, int way)
{
    const size_t patches = (size_t)(s->patches[0] + s->patches[1]), size = sizeof *s->surfel;
    if (way) run->buffers[0] = buffer_of(s->vertices, 27 * patches * sizeof *s->vertices);
    else run->buffers[0] = buffer_of(s->surfel, (run->surfels + 1) * size);
    run->arrays[0] = array_of(run->buffers[0], 3, way ? 3 : 4, way ? 0 : 1);
    if (way == KIT_WAY_CAPTURE || run->lit)
        run->buffers[1] = buffer_of(NULL, (3 * run->surfels + run->surfels / 16 + 1024) * size);
}

static ssgi_gl_chain chain_of(const kit_making *m, const surfels *s)
{
    const int way = m->set->way, lit = m->run->lit;
    ssgi_gl_chain chain = kit_chain(m);
    chain.history = 0;
    chain.desc.surfel.tessellate = way != KIT_WAY_CPU;
    chain.desc.light.bounce = m->desc.surfel.effect == SSGI_GL_EFFECT_LIGHT && m->set->bounce;
    chain.desc.light.environment =
        lit && m->world->lighting->env.data ? SSGI_GL_ENVIRONMENT_MAP : SSGI_GL_ENVIRONMENT_NONE;
    chain.hidden_sky = m->desc.light.environment != SSGI_GL_ENVIRONMENT_NONE;
    chain.unsmoothed = !m->set->smooth;
    /* a pass makes surfels from triangles, or lights them */
    chain.surfels = way == KIT_WAY_CAPTURE || (lit && way == KIT_WAY_CPU);
    if (s->lamps) chain.lights = m->lights;
    if (way) chain.desc.shader.dialect = kit_gl_is_es() ? SSGI_GL_DIALECT_320ES : SSGI_GL_DIALECT_410;
    return chain;
}

/* Gives each pass the buffer that it draws from, and gives the pass that makes surfels the buffer that it writes. */
static void connect_buffers(kit_run *run, const surfels *s, int way, int captured)
{
    if (captured) {
        if (!way) run->arrays[2] = array_of(run->buffers[0], 3, 4, 0);
        run->arrays[1] = array_of(run->buffers[1], 3, 4, 1);
        if (way) glGenQueries(1, &run->query);
    }
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        const int made = p->desc.pass == SSGI_GL_PASS_SURFELS;
        if (!made && p->desc.pass != SSGI_GL_PASS_DSS) continue;
        p->array = !made ? run->arrays[captured] : way ? run->arrays[0] : run->arrays[2];
        if (p->desc.surfel.tessellate) memcpy(p->patches, s->patches, sizeof s->patches);
        p->splits = s->desc.splits;
        if (made) p->capture = run->buffers[1];
    }
}

static void add_dipole(kit_making *m)
{
    const kit_material *material = kit_material_of(m->set->material);
    ssgi_dipole dipole;
    ssgi_dipole_set(&dipole, material->sigma_s, material->sigma_a, material->eta, NULL);
    ssgi_gl_dipole_set(&m->run->frame, &dipole, (float)m->set->unit, NULL);
}

static int add_surfel_passes(kit_making *m, surfels *s, const ssgi_view *view, const float picture[16])
{
    kit_run *run = m->run;
    if ((run->lit && light_surfels(m, s, picture)) || make_surfels(m, s, view, picture)) return -1;
    add_buffers(run, s, m->set->way);
    const ssgi_gl_chain chain = chain_of(m, s);
    if (m->desc.surfel.effect == SSGI_GL_EFFECT_SCATTER) add_dipole(m);
    if (run->lit && !run->gbuffer->albedo) kit_add_grey(m);
    if (kit_add_steps(m, &chain, 0, &run->light, &run->bounce)) return -1;
    connect_buffers(run, s, m->set->way, chain.surfels);
    return 0;
}

int kit_open_deep(kit_making *m, const ssgi_view *view, const float picture[16])
{
    const kit_settings *set = m->set;
    kit_run *run = m->run;
    surfels s = { .desc = { .size = (float)set->size,
                            .splits = set->splits,
                            .offscreen_growth = fmaxf((float)set->offscreen_growth, 1e-6f),
                            .keep_small = set->keep_small,
                            .overhang = set->overhang,
                            .max_distance = run->frame.radius < 1e17f ? run->frame.radius : 0 } };
    const char *why = "";
    if (!m->world->scene)
        return kit_fail(m->err, "method %s: a frame has no triangles to make surfels of; it needs a scene",
                        m->method->name);
    if (set->way && !glPatchParameteri) return kit_fail(m->err, "--set way: %s has no tessellation", kit_gl_name());
    if (ssgi_gl_surfels_set(&run->frame, view, &s.desc, picture, &why) != SSGI_OK)
        return kit_fail(m->err, "%s", why);
    if (look_at_frame(m, &s)) return -1;
    const int failed = add_surfel_passes(m, &s, view, picture);
    surfels_free(&s);
    return failed;
}
