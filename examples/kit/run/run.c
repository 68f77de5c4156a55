/* run.c - makes a method ready on a G-buffer: extends the G-buffer, then calls the files that add passes. Declared in
   kit_gl.h. */
#include "kit/kit_run.h"
#include <stdlib.h>
#include <string.h>

/* Adds the layers and slabs that the method needs to the G-buffer, if there is a scene to draw them from. */
static int ask_gbuffer(const kit_making *m, kit_gbuffer *g)
{
    const kit_scene *scene = m->world->scene;
    const ssgi_gl_desc *gather = &m->desc;
    const int two = gather->gather.thickness == SSGI_GL_THICKNESS_SLABS;
    if (gather->gather.resolution && !m->blurred)
        return kit_fail(m->err, "--set resolution=half: needs blur=1 or more, which brings it to full size");
    if (gather->gather.layers > g->layers && !scene)
        return kit_fail(m->err, "--set layers=%d: the frame has %d", gather->gather.layers, g->layers);
    if (gather->gather.views && !scene)
        return kit_fail(m->err, "--set views=%d: a frame has one camera; extra ones need a scene",
                        gather->gather.views);
    if (gather->gather.layers > g->layers && kit_gbuffer_peel(g, scene, gather->gather.layers, m->err)) return -1;
    if (gather->gather.thickness < SSGI_GL_THICKNESS_BACK || (two ? g->slabs : g->back)) return 0;
    if (!scene)
        return kit_fail(m->err, "--set thickness=%s: the frame has no channel %s", two ? "slabs" : "back",
                        g->back ? "front2.Z" : "back.Z");
    return kit_gbuffer_slabs(g, scene, 1 + two, m->err);
}

/* Adds the passes of a method of ambient visibility. */
static int open_visibility(kit_making *m, const float picture[16])
{
    kit_seen_places seen = { .point = NULL };
    const ssgi_gl_chain chain = kit_chain(m);
    const int failed = m->desc.gather.views
                    && (kit_seen(m->run->gbuffer, &seen, m->err) || kit_add_views(m, picture, &seen.middle));
    free(seen.point);
    return failed ? -1 : kit_add_steps(m, &chain, 0, &m->run->light, NULL);
}

static void add_kernel(kit_making *m)
{
    const int sets = m->set->sets, directions = m->desc.gather.directions,
              kind = m->desc.gather.uniform_directions ? SSGI_DIRECTIONS_UNIFORM : SSGI_DIRECTIONS_COSINE;
    float *kernel = malloc(4 * (size_t)(sets * directions) * sizeof *kernel);
    if (kernel) ssgi_directions(kernel, kind, sets, directions, NULL);
    m->run->kernel = kit_keep(m->run, kernel ? kit_texture(directions, sets, GL_RGBA32F, kernel) : 0);
    free(kernel);
}

/* Makes a noise tile in which each of the sets occurs equally often or, without sets, one of 16 rotations. */
static void add_noise(kit_making *m)
{
    static float tile[4 * 64 * 64];
    const int sets = m->desc.gather.kernel_texture ? m->set->sets : 16;
    int size = 4;
    while (size < 64 && size * size % sets) ++size;
    if (ssgi_noise_tile(tile, size, sets, 1, NULL) != SSGI_OK) ssgi_noise_tile(tile, size = 4, 16, 1, NULL);
    m->run->noise = kit_keep(m->run, kit_texture(size, size, GL_RGBA32F, tile));
}

/* Changes the projection to that of a camera that looks along +z, and makes normals with z negated. */
static int turn_left_handed(kit_making *m, const kit_gbuffer *g, float projection[16])
{
    const size_t texels = (size_t)g->width * (size_t)g->height;
    float *n = malloc(4 * texels * sizeof *n);
    for (int k = 8; k < 12; ++k) projection[k] = -projection[k];
    if (!n || (g->normal && kit_texture_read(g->normal, g->width, g->height, 4, n))) {
        free(n);
        return kit_fail(m->err, "--set left_handed=1: normals cannot be read");
    }
    for (size_t i = 0; i < texels && g->normal; ++i) n[4 * i + 2] = -n[4 * i + 2];
    if (g->normal) m->run->normal = kit_keep(m->run, kit_texture(g->width, g->height, GL_RGBA32F, n));
    free(n);
    return 0;
}

/* Adds all passes on a G-buffer, which is the caller's or a wider one with a margin. */
static int open_on(kit_making *m, kit_gbuffer *g, float radius)
{
    kit_run *run = m->run;
    ssgi_view view;
    const char *why = "";
    float picture[16], projection[16];
    memcpy(projection, g->projection, sizeof projection);
    if (m->set->left_handed && turn_left_handed(m, g, projection)) return -1;
    if (kit_view_of(&view, projection, g->camera.depth, g->viewport[2], g->viewport[3], m->err)) return -1;
    if (ssgi_gl_frame_init(&run->frame, &view, radius, &why) != SSGI_OK) return kit_fail(m->err, "%s", why);
    run->gbuffer = g;
    run->lit = m->method->lit;
    run->frame.origin[0] = g->viewport[0];
    run->frame.origin[1] = g->viewport[1];
    m->desc.shader.dialect = kit_dialect();
    if (m->desc.pass != SSGI_GL_PASS_DSS && m->desc.pass != SSGI_GL_PASS_AOF) m->desc.shader.compute = kit_compute();
    if (m->desc.shader.compute) m->desc.shader.dialect = SSGI_GL_DIALECT_450;
    m->desc.input.orthographic = view.orthographic;
    m->desc.input.depth = g->depth_is_linear ? SSGI_GL_DEPTH_LINEAR : SSGI_GL_DEPTH_WINDOW;
    if (kit_settings_apply(m, radius) || ask_gbuffer(m, g)) return -1;
    kit_camera_matrices(&g->camera, picture, projection);
    const int failed = m->desc.pass == SSGI_GL_PASS_DSS   ? kit_open_deep(m, &view, picture)
                       : m->desc.pass == SSGI_GL_PASS_AOF ? kit_open_field(m, picture)
                       : run->lit                        ? kit_open_lit(m, picture)
                                                         : open_visibility(m, picture);
    if (failed) return -1;
    if (m->desc.gather.kernel_texture) add_kernel(m);
    if (m->desc.gather.noise == SSGI_GL_NOISE_TEXTURE) add_noise(m);
    kit_limit_passes(run);
    run->bytes = kit_run_bytes(run);
    glGenBuffers(KIT_FRAMES, run->block);
    kit_run_update(run);
    /* frames until history is complete: reuse reads the last frame's light, occluded emitters its coefficients; bounced
       adds one bounce each frame, of which the ninth is negligible */
    const int frames = m->set->bounced ? 8 : m->set->reuse || m->set->occluded_emitters ? 2 : 0;
    for (int i = 0; i < frames; ++i) kit_run_draw(run, 0);
    return 0;
}

int kit_run_open_wide(kit_run *run, kit_gbuffer *g, const kit_method *method, float radius, const kit_world *world,
                      int margin, kit_error *err)
{
    static const kit_lighting dark;
    const kit_world whole = { world ? world->scene : NULL, world && world->lighting ? world->lighting : &dark };
    kit_making m = { .run = run, .method = method, .set = &method->set, .world = &whole, .err = err };
    memset(run, 0, sizeof *run);       /* run is filled in place, because passes point to its frames of extra cameras */
    const int failed = kit_add_margin(&m, &g, radius, margin) || open_on(&m, g, radius);
    if (failed) kit_run_close(run);
    return failed ? -1 : 0;
}

int kit_run_open(kit_run *run, kit_gbuffer *g, const kit_method *method, float radius, const kit_world *world,
                 kit_error *err)
{
    return kit_run_open_wide(run, g, method, radius, world, -1, err);
}

int kit_run_picture(kit_image *out, kit_gbuffer *g, const kit_world *world, const char *method, const char *set,
                    float radius, kit_error *err)
{
    kit_method m;
    kit_run run;
    if (kit_method_find(&m, method, err) || kit_method_set(&m, set, err)
        || kit_run_open(&run, g, &m, radius, world, err))
        return -1;
    kit_run_draw(&run, 0);
    const int failed = kit_run_read(out, &run, err);
    kit_run_close(&run);
    return failed;
}
