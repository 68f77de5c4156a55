/* deep.c - deep screen space: surfels of a scene, and the passes that splat them. */
#include "kit/kit_run.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>deep: surfels, and the passes that splat them ------------------------------------------------------------- */

/* A vertex array of vec3 or vec4 attributes, interleaved. */
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

/* The scene's triangles for patches, 9 floats a vertex, huge ones divided: small ones first, then those that ask for
   splits. NULL: no memory. */
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
    for (size_t t = 0; t < count && divided && sorted; ++t) {      /* large ones from the end on */
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

/* The least depth that the G-buffer shows, a little less; stays where it shows nothing. */
static int nearest_of(float *front, const kit_gbuffer *g, kit_error *err)
{
    kit_image frame;
    float least = INFINITY;
    if (kit_gbuffer_read(&frame, g, err)) return -1;
    const float *z = kit_image_channel(&frame, "Z");
    for (int i = 0; i < frame.width * frame.height; ++i) if (z[i] > 0 && z[i] < least) least = z[i];
    if (least < INFINITY) *front = fmaxf(0.999f * least, *front);
    kit_image_free(&frame);
    return 0;
}

/* The environment's mean radiance. */
static void mean_of(float sky[3], const kit_image *env)
{
    const size_t texels = (size_t)env->width * (size_t)env->height;
    double sum[4] = { 0 };
    for (size_t i = 0; i < texels; ++i) {
        const double area = sin(3.14159265358979 * ((double)(i / (size_t)env->width) + 0.5) / env->height);
        for (size_t c = 0; c < 3; ++c) sum[c] += area * (double)env->data[c * texels + i];
        sum[3] += area;
    }
    for (int c = 0; c < 3; ++c) sky[c] = (float)(sum[c] / sum[3]);
}

int kit_open_deep(kit_making *m, const ssgi_view *view, const float picture[16])
{
    static const kit_lighting dark;
    kit_run *run = m->run;
    kit_gbuffer *g = run->gbuffer;
    const kit_scene *scene = m->world->scene;
    const int way = (int)kit_method_value(m->method, "way"), effect = m->gather.effect,
              lit = effect != SSGI_GL_EFFECT_OCCLUSION;
    const ssgi_surfel_desc d = { (float)kit_method_value(m->method, "size"), (int)kit_method_value(m->method, "splits"),
                                 fmaxf((float)kit_method_value(m->method, "offscreen_growth"), 1e-6f),
                                 (int)kit_method_value(m->method, "keep_small"),
                                 run->frame.radius < 1e17f ? run->frame.radius : 0 };
    ssgi_splat splat = { .epsilon = run->frame.epsilon,
                         .max_distance = run->frame.radius < 1e17f ? run->frame.radius : 0,
                         .levels = m->gather.levels };
    const kit_lighting *lighting = m->world->lighting ? m->world->lighting : &dark;
    const kit_world world = { scene, lighting };
    ssgi_surfel_cost cost;
    ssgi_gl_chain chain;
    const char *why = "";
    float *vertices;
    ssgi_surfel *surfels = NULL;
    int patches[2], failed = 0, direct = 0, placed_count = 0;
    ssgi_gl_light *rows = NULL;
    if (!scene)
        return kit_fail(m->err, "method %s: a frame has no triangles to make surfels of; it needs a scene",
                        m->method->name);
    if (way && !glPatchParameteri) return kit_fail(m->err, "--set way: %s has no tessellation", kit_gl_name());
    if (ssgi_gl_surfels_set(&run->frame, view, &d, m->gather.levels, picture, &why) != SSGI_OK)
        return kit_fail(m->err, "%s", why);
    m->world = &world;
    if (kit_method_value(m->method, "near_depth") > 0 && nearest_of(&run->frame.near_depth, g, m->err)) return -1;
    splat.near_depth = run->frame.near_depth;
    if (lit) {
        kit_sight seen;
        kit_placed_light *placed;
        kit_rotation_of(run->frame.rotation, picture, NULL);
        m->gather.environment = SSGI_GL_ENVIRONMENT_MAP;
        if (lighting->env.data && kit_add_environment(m)) return -1;
        /* of surfels: what splats hide is seen all the same */
        if (!lighting->env.data || !(kit_method_value(m->method, "sky") > 0))
            m->gather.environment = SSGI_GL_ENVIRONMENT_NONE;
        if (kit_seen(g, &seen, m->err)) return -1;
        placed = kit_placed_lights_new(m, &seen, &placed_count, &direct);
        free(seen.point);
        if (!placed) return -1;
        failed = kit_add_atlas(m, placed, placed_count);
        m->rows[0] = failed ? 0
                            : kit_keep(run, direct ? kit_light_rows(placed, 0, direct, picture)
                                                   : kit_texture(8, 1, GL_RGBA32F, NULL));
        rows = kit_lights_seen(placed, 0, direct, picture);
        free(placed);
        run->frame.lights = direct;
        m->gather.shadow = m->lights.shadow;
        m->gather.sends = SSGI_GL_SENDS_LIGHTS;
        if (failed) return -1;
    }
    vertices = patches_of(scene, &d, view, picture, effect == SSGI_GL_EFFECT_SCATTER, patches);
    ssgi_surfel_source source = { .position = vertices,
                                  .normal = vertices ? vertices + 3 : NULL,
                                  .colour = vertices ? vertices + 6 : NULL,
                                  .position_stride = 36,
                                  .normal_stride = 36,
                                  .colour_stride = 36,
                                  .triangles = (size_t)(patches[0] + patches[1]) };
    memcpy(source.to_view, picture, sizeof source.to_view);
    for (int pass = 0; pass < 2 && vertices && !failed; ++pass) {           /* counts, then surfels */
        if (pass) surfels = malloc((run->surfels + 1) * sizeof *surfels);
        failed = (pass && !surfels)
                 || ssgi_surfels(surfels, pass ? run->surfels : 0, &run->surfels, &d, view, &source, &why) != SSGI_OK;
    }
    if (vertices && !failed) failed = ssgi_surfels_predict(&cost, &d, &splat, view, &source, &why) != SSGI_OK;
    if (lit && !failed && vertices) {
        float sky[3] = { 0, 0, 0 };
        if (lighting->env.data && (m->gather.environment || m->gather.span)) mean_of(sky, &lighting->env);
        failed = !rows || ssgi_gl_sent_set(&run->frame, surfels, run->surfels, rows, direct, sky, &why) != SSGI_OK;
    }
    free(rows);
    if (!vertices || failed) {
        free(vertices);
        free(surfels);
        return kit_fail(m->err, "surfels: %s", *why ? why : "out of memory");
    }
    for (int l = 0; l < m->gather.levels; ++l) run->splat_pixels += cost.pixels[l];
    run->fetches += run->splat_pixels / ((double)view->width * view->height);
    if (way) run->buffers[0] = buffer_of(vertices, 27 * (size_t)(patches[0] + patches[1]) * sizeof *vertices);
    else run->buffers[0] = buffer_of(surfels, (run->surfels + 1) * sizeof *surfels);
    run->arrays[0] = array_of(run->buffers[0], 3, way ? 3 : 4, way ? 0 : 1);
    if (way == 1 || lit)
        run->buffers[1] = buffer_of(NULL, (3 * run->surfels + run->surfels / 16 + 1024) * sizeof *surfels);
    free(vertices);
    free(surfels);
    chain = kit_chain(m);
    chain.blur = chain.history = 0;
    chain.desc.tessellate = way > 0;
    chain.desc.bounce = effect == SSGI_GL_EFFECT_LIGHT;
    chain.desc.environment = lit && lighting->env.data ? SSGI_GL_ENVIRONMENT_MAP : SSGI_GL_ENVIRONMENT_NONE;
    chain.hidden_sky = m->gather.environment != SSGI_GL_ENVIRONMENT_NONE;
    chain.unsmoothed = !(kit_method_value(m->method, "smooth") > 0);
    chain.surfels = way == 1 || (lit && !way);          /* surfels come out of a pass: from patches, or lit */
    if (direct) chain.lights = m->lights;
    if (way) chain.desc.dialect = kit_gl_is_es() ? SSGI_GL_320ES : SSGI_GL_410;
    if (effect == SSGI_GL_EFFECT_SCATTER) {
        const kit_material *material = kit_material_of((int)kit_method_value(m->method, "material"));
        ssgi_dipole dipole;
        ssgi_dipole_set(&dipole, material->sigma_s, material->sigma_a, material->eta, NULL);
        ssgi_gl_dipole_set(&run->frame, &dipole, (float)kit_method_value(m->method, "unit"), NULL);
    }
    if (lit && !g->albedo) kit_add_grey(m);
    if (kit_add_steps(m, &chain, 0, &run->light, &run->bounce)) return -1;
    if (chain.surfels) {
        if (!way) run->arrays[2] = array_of(run->buffers[0], 3, 4, 0);
        run->arrays[1] = array_of(run->buffers[1], 3, 4, 1);
        if (way) glGenQueries(1, &run->query);
    }
    for (int i = 0; i < run->passes; ++i) {
        kit_pass *p = &run->pass[i];
        const int made = p->desc.pass == SSGI_GL_SURFELS;
        if (!made && p->desc.pass != SSGI_GL_SPLAT) continue;
        p->array = !made ? run->arrays[chain.surfels] : way ? run->arrays[0] : run->arrays[2];
        if (p->desc.tessellate) memcpy(p->patches, patches, sizeof patches);
        p->splits = d.splits;
        if (made) p->capture = run->buffers[1];
    }
    return 0;
}
/* Makes surfels or splats them, from patches or from a buffer. */
void kit_draw_surfels(kit_run *run, const kit_pass *p)
{
    const int capture = p->capture != 0, counted = capture && run->query;
    GLint was;
    GLuint written = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &was);
    glBindVertexArray(p->array);
    if (capture) {
        glEnable(GL_RASTERIZER_DISCARD);
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, p->capture);
        if (counted) glBeginQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN, run->query);
        glBeginTransformFeedback(GL_POINTS);
    }
    if (p->desc.tessellate) {
        glPatchParameteri(GL_PATCH_VERTICES, 3);
        /* Mesa mixes up points beyond 65536 that one draw tessellates */
        const int all = p->patches[0] + p->patches[1], most = kit_gl_is_software() ? 20 : all;
        for (int first = 0, count; first < all; first += count) {
            const int end = first < p->patches[0] ? p->patches[0] : all;
            count = end - first < most ? end - first : most;
            glDrawArraysInstanced(GL_PATCHES, 3 * first, 3 * count, first < p->patches[0] ? 1 : p->splits * p->splits);
        }
    } else if (capture) glDrawArrays(GL_POINTS, 0, (GLsizei)run->surfels);
    else glDrawArraysInstanced(p->step->primitive, 0, p->step->vertices, (GLsizei)run->surfels);
    if (capture) {
        glEndTransformFeedback();
        if (counted) {
            glEndQuery(GL_TRANSFORM_FEEDBACK_PRIMITIVES_WRITTEN);
            glGetQueryObjectuiv(run->query, GL_QUERY_RESULT, &written);
            run->surfels = written;
        }
        glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
        glDisable(GL_RASTERIZER_DISCARD);
    }
    glBindVertexArray((GLuint)was);
}
