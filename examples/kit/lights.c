/* lights.c - what a run needs of the world: light of what is seen, extra cameras, shadow maps; opening lit methods and
   fields. */
#include "kit_run.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979323846

/* ---- >>passes of light ----------------------------------------------------------------------------------------- */

/* ---- >>cameras: what is seen, extra cameras, shadow maps --------------------------------------------------------- */
static int by_value(const void *a, const void *b)
{
    const float x = *(const float *)a, y = *(const float *)b;
    return (x > y) - (x < y);
}

int kit_seen(const kit_gbuffer *g, kit_sight *seen, kit_error *err)
{
    const kit_camera *c = &g->camera;
    kit_image frame;
    const float *z;
    float *depths;
    double sum[4] = { 0, 0, 0, 0 }, squares = 0, median = 1;
    int count = 0;
    memset(seen, 0, sizeof *seen);
    if (kit_gbuffer_read(&frame, g, err)) return -1;
    depths = malloc((size_t)(frame.width * frame.height + 1) * sizeof *depths);
    seen->point = malloc(((size_t)(frame.width * frame.height) + 1) * sizeof *seen->point);
    if (!depths || !seen->point) {
        free(depths);
        free(seen->point);
        seen->point = NULL;
        kit_image_free(&frame);
        return kit_fail(err, "out of memory");
    }
    z = kit_image_channel(&frame, "Z");
    for (int i = 0; i < frame.width * frame.height; ++i) {
        const int x = i % frame.width, y = i / frame.width;
        float *at = seen->point[seen->points];
        if (!(z[i] > 0)) continue;
        kit_camera_point(c, x, y, (double)z[i], at);
        at[3] = z[i];
        ++seen->points;
        for (int k = 0; k < 3; ++k) {
            sum[k] += (double)at[k];
            squares += (double)at[k] * (double)at[k];
        }
        sum[3] += 1;
        if (i % 7 == 0 && abs(2 * x - frame.width) < frame.width / 2 && abs(2 * y - frame.height) < frame.height / 2)
            depths[count++] = z[i];
    }
    if (count) {
        qsort(depths, (size_t)count, sizeof *depths, by_value);
        median = (double)depths[count / 2];
    }
    free(depths);
    kit_image_free(&frame);
    if (!(sum[3] > 0)) sum[3] = 1;
    squares /= sum[3];
    for (int k = 0; k < 3; ++k) {
        seen->all.centre[k] = (float)(sum[k] / sum[3]);
        squares -= sum[k] / sum[3] * (sum[k] / sum[3]);
    }
    kit_camera_point(c, c->width / 2, c->height / 2, median, seen->middle.centre);
    seen->all.radius = (float)(1.8 * sqrt(squares > 0 ? squares : 0)) + 1e-6f;
    seen->middle.radius =
        (float)(c->fovy > 0 ? median * tan((double)c->fovy * PI / 360) : 0.5 * (double)c->ortho_height)
        * fmaxf(1, (float)c->width / (float)c->height);
    return 0;
}

int kit_view_of(ssgi_view *view, const float projection[16], int depth, int width, int height, kit_error *err)
{
    const char *why = "";
    return ssgi_view_from_projection(view, projection, depth == KIT_DEPTH_NORMAL ? SSGI_CLIP_GL : SSGI_CLIP_ZERO, width,
                                     height, &why)
                   == SSGI_OK
               ? 0
               : kit_fail(err, "%s", why);
}

void kit_rotation_of(float rotation[12], const float a[16], const float b[16])
{
    for (int c = 0; c < 3; ++c)
        for (int r = 0; r < 3; ++r) {
            rotation[4 * c + r] = 0;
            for (int k = 0; k < 3; ++k) rotation[4 * c + r] += a[4 * k + r] * (b ? b[4 * k + c] : k == c ? 1.0f : 0.0f);
        }
}

int kit_add_views(kit_making *m, const float picture[16], const kit_sphere *about)
{
    kit_run *run = m->run;
    const int size = (int)kit_method_value(m->method, "view_size"), layers = m->gather.view_layers;
    const size_t texels = (size_t)size * (size_t)size;
    float *depth = malloc(texels * (size_t)(m->gather.views * layers) * sizeof *depth);
    int failed = !depth;
    if (failed) kit_fail(m->err, "no memory for %d extra cameras", m->gather.views);
    for (int v = 0; v < m->gather.views && !failed; ++v) {
        const char *why = "";
        float to[16], projection[16], displacement[3];
        kit_camera c = run->gbuffer->camera;
        ssgi_view view;
        ssgi_gl_frame frame;
        kit_gbuffer *g = &run->view[v];
        ssgi_extra_displacement(v, displacement);
        if (ssgi_extra_camera(to, projection, picture, about->centre, about->radius, displacement, &why) != SSGI_OK)
            failed = kit_fail(m->err, "extra camera: %s", why);
        if (failed) break;
        for (int k = 0; k < 3; ++k) {
            c.eye[k] = -(to[4 * k] * to[12] + to[4 * k + 1] * to[13] + to[4 * k + 2] * to[14]);
            c.up[k] = to[4 * k + 1];
            c.target[k] = c.eye[k] - to[4 * k + 2] * about->radius;
        }
        c.fovy = (float)(2 * atan(1 / (double)projection[5]) * 180 / PI);
        c.ortho_height = 0;
        c.znear = projection[14] / (projection[10] - 1);
        c.zfar = 0;                         /* the sphere is of what is seen: behind it the scene goes on */
        c.depth = KIT_DEPTH_NORMAL;
        c.shift[0] = c.shift[1] = 0;
        c.width = c.height = size;
        failed = kit_gbuffer_from_scene(g, m->world->scene, &c, NULL, m->err)
                 || kit_gbuffer_peel(g, m->world->scene, layers, m->err)
                 || kit_view_of(&view, g->projection, KIT_DEPTH_NORMAL, size, size, m->err);
        if (failed) break;
        run->views = v + 1;
        kit_camera_matrices(&g->camera, to, projection);
        ssgi_gl_views_set(&run->cameras, v, &view, picture, to, NULL);
        frame = run->frame;
        ssgi_gl_frame_init(&frame, &view, run->frame.radius, NULL);
        frame.offset = run->frame.offset;
        frame.thickness = run->frame.thickness;
        frame.fade = run->frame.fade;
        frame.max_slope = run->frame.max_slope;
        frame.lights = run->frame.lights;
        ssgi_gl_harmonics_set(&frame, run->harmonics, m->gather.bands, to, NULL);
        kit_rotation_of(frame.rotation, to, NULL);
        run->extra[2 * v] = frame;
        kit_rotation_of(frame.rotation, picture, to);
        run->extra[2 * v + 1] = frame;
        for (int j = 0; j < layers && !failed; ++j) {
            float *out = depth + texels * (size_t)(v * layers + j);
            if (j ? kit_texture_slice_read(g->layer_depth, j - 1, size, size, 1, out)
                  : kit_texture_read(g->depth, size, size, 1, out))
                failed = kit_fail(m->err, "%s cannot read the extra cameras' depth back", kit_gl_name());
        }
    }
    if (!failed)
        run->view_depth =
            kit_keep(run, kit_texture_array(size, size, m->gather.views * layers, GL_DEPTH_COMPONENT32F, depth));
    free(depth);
    return failed ? -1 : 0;
}
static void look(kit_camera *c, const float eye[3], const float along[3], float fovy, float height, float znear,
                 float zfar, int size)
{
    memset(c, 0, sizeof *c);
    for (int k = 0; k < 3; ++k) { c->eye[k] = eye[k]; c->target[k] = eye[k] + along[k]; }
    c->up[fabsf(along[1]) < 0.9f * sqrtf(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]) ? 1 : 0] = 1;
    c->fovy = fovy;
    c->ortho_height = height;
    c->znear = znear;
    c->zfar = zfar;
    c->width = c->height = size;
}

/* Widens a rectangle across the light, lower x, y, then upper, by a point. */
static void widen(float rectangle[4], const float axes[16], const float p[3])
{
    for (int k = 0; k < 2; ++k) {
        const float at = axes[k] * p[0] + axes[4 + k] * p[1] + axes[8 + k] * p[2];
        rectangle[k] = fminf(rectangle[k], at);
        rectangle[2 + k] = fmaxf(rectangle[2 + k], at);
    }
}

/* A sun, and its maps as so many rows, fine ones first: of what is seen before the geometric mean of its depths, of all
   that is seen, of the whole scene (most: 3; 1: of all that is seen alone); those are left out whose next is hardly
   wider. They look from beyond all that could shadow. How many. */
static int sun(kit_placed_light *out, const float at[3], const float colour[3], const kit_scene *scene,
               const kit_sight *seen, int most, int size)
{
    enum { NEAR, SEEN, WHOLE, PARTS };
    static const float origin[3];
    float axes[16], projection[16], part[PARTS][4], along[3];
    float nearest = 1e30f, farthest = -1e30f, least = 1e30f, last = 0;
    kit_camera c;
    int count = 0, rows = 0, kept[PARTS];
    memset(out, 0, (size_t)most * sizeof *out);
    for (int k = 0; k < 3; ++k) along[k] = -at[k];
    look(&c, origin, along, 0, 1, 0.1f, 1, size);
    kit_camera_matrices(&c, axes, projection);
    for (int k = 0; k < PARTS; ++k) for (int i = 0; i < 4; ++i) part[k][i] = i < 2 ? 1e30f : -1e30f;
    for (size_t i = 0; i < seen->points; ++i) {
        least = fminf(least, seen->point[i][3]);
        last = fmaxf(last, seen->point[i][3]);
    }
    for (size_t i = 0; i < seen->points; ++i) {
        widen(part[SEEN], axes, seen->point[i]);
        if (seen->point[i][3] <= sqrtf(least) * sqrtf(last)) widen(part[NEAR], axes, seen->point[i]);
    }
    for (int i = 0; scene && i < 8; ++i) {
        float corner[3], t = 0;
        for (int k = 0; k < 3; ++k) {
            corner[k] = i >> k & 1 ? scene->mesh.upper[k] : scene->mesh.lower[k];
            t += corner[k] * at[k];
        }
        widen(part[WHOLE], axes, corner);
        nearest = fminf(nearest, t);
        farthest = fmaxf(farthest, t);
    }
    for (int k = most > 1 ? WHOLE : SEEN; scene && k >= (most > 1 ? NEAR : SEEN); --k) {      /* wide ones first */
        const float *p = part[k], *q = count ? part[kept[count - 1]] : p;
        const float side = fmaxf(p[2] - p[0], p[3] - p[1]), next = fmaxf(q[2] - q[0], q[3] - q[1]);
        if (!(side > 0) && k < WHOLE) continue;
        if (!count || 1.25f * side < next) kept[count++] = k;
    }
    const float margin = 0.01f * (farthest - nearest) + 1e-6f;
    for (; count > 0; --count) {                    /* rows: fine ones first */
        const float *p = part[kept[count - 1]];
        kit_placed_light *l = &out[rows++];
        const float across = 0.5f * (p[0] + p[2]), up = 0.5f * (p[1] + p[3]), away = farthest + 2 * margin;
        float eye[3];
        for (int k = 0; k < 3; ++k) eye[k] = axes[4 * k] * across + axes[4 * k + 1] * up + at[k] * away;
        look(&l->camera, eye, along, 0, 1.01f * fmaxf(p[2] - p[0], p[3] - p[1]) + 1e-6f, margin,
             farthest - nearest + 3 * margin, size);
        l->mapped = 1;
        l->light.min_distance = (float)(count - 1);
    }
    if (!rows) rows = 1;
    for (int i = 0; i < rows; ++i) {
        memcpy(out[i].light.at, at, sizeof out[i].light.at);
        memcpy(out[i].light.colour, colour, sizeof out[i].light.colour);
        out[i].light.kind = SSGI_GL_SUN;
    }
    return rows;
}

kit_placed_light *kit_placed_lights_new(kit_making *m, const kit_sight *seen, int *count, int *direct)
{
    static const float face[6][3] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
    const kit_lighting *lighting = m->world->lighting;
    const kit_scene *scene = m->world->scene;
    const int suns = (int)kit_method_value(m->method, "suns"), vpls = (int)kit_method_value(m->method, "vpls"),
              mapped = scene && (m->lights.shadow == SSGI_GL_SHADOW_MAP || m->lights.shadow == SSGI_GL_SHADOW_FILL);
    const size_t room = (size_t)(6 * lighting->lights + suns + vpls + 1);
    int size = (int)kit_method_value(m->method, "shadow_size"), n = 0;
    kit_placed_light *placed = calloc(room, sizeof *placed);
    const char *why = "";
    float extent = 0;
    while (size > 16 && (double)size * ceil(sqrt((double)room)) > 8192) size /= 2;
    if (!placed) { kit_fail(m->err, "no memory for %d lights", (int)room); return NULL; }
    for (int k = 0; scene && k < 3; ++k) extent += scene->mesh.upper[k] - scene->mesh.lower[k];
    for (int i = 0; i < lighting->lights; ++i) {
        const kit_light *w = &lighting->light[i];
        if (w->kind == KIT_SUN) n += sun(&placed[n], w->at, w->colour, mapped ? scene : NULL, seen, 3, size);
        for (int f = 0; w->kind == KIT_POINT && f < (mapped ? 6 : 1); ++f) {
            kit_placed_light *l = &placed[n++];
            memcpy(l->light.at, w->at, sizeof l->light.at);
            memcpy(l->light.colour, w->colour, sizeof l->light.colour);
            l->light.kind = mapped ? SSGI_GL_SPOT : SSGI_GL_POINT;
            l->mapped = mapped;
            look(&l->camera, w->at, face[f], 90, 0, 1e-3f * seen->all.radius, extent, size);
        }
    }
    if (suns && lighting->env.data) {
        ssgi_sun *found = malloc((size_t)suns * sizeof *found);
        if (!found
            || ssgi_environment_suns(found, suns, m->run->equirect, lighting->env.width, lighting->env.height, &why)
                   != SSGI_OK) {
            kit_fail(m->err, "suns: %s", why);
            free(found);
            free(placed);
            return NULL;
        }
        for (int i = 0; i < suns; ++i)
            n += sun(&placed[n], found[i].direction, found[i].irradiance, mapped ? scene : NULL, seen, 1, size);
        free(found);
    }
    *direct = n;
    if (vpls) {
        float *position, *normal, *flux;
        size_t pixels;
        ssgi_vpl *found = malloc((size_t)vpls * sizeof *found);
        int failed;
        if (!scene || !lighting->lights || !found) {
            kit_fail(m->err, "--set vpls=%d: needs a scene and a --light", vpls);
            free(found);
            free(placed);
            return NULL;
        }
        if (kit_rsm(&position, &normal, &flux, &pixels, scene, &lighting->light[0], 256, m->err)) {
            free(found);
            free(placed);
            return NULL;
        }
        failed = ssgi_vpl_choose(found, vpls, position, normal, flux, pixels, &why) != SSGI_OK;
        free(position);
        free(normal);
        free(flux);
        if (failed) { kit_fail(m->err, "vpls: %s", why); free(found); free(placed); return NULL; }
        for (int i = 0; i < vpls; ++i) {
            kit_placed_light *l = &placed[n++];
            memcpy(l->light.at, found[i].position, sizeof l->light.at);
            memcpy(l->light.normal, found[i].normal, sizeof l->light.normal);
            memcpy(l->light.colour, found[i].intensity, sizeof l->light.colour);
            l->light.kind = SSGI_GL_VPL;
            l->light.min_distance = m->run->frame.radius;
            l->mapped = mapped;
            look(&l->camera, found[i].position, found[i].normal, 150, 0, 2e-3f * seen->all.radius, extent, size);
        }
        free(found);
    }
    *count = n;
    return placed;
}

int kit_add_atlas(kit_making *m, const kit_placed_light *placed, int count)
{
    kit_shadow_camera *camera = malloc((size_t)count * sizeof *camera);
    const int size = count && placed[0].mapped ? placed[0].camera.width : 0,
              columns = size ? 8192 / size < count ? 8192 / size : count : 1;
    int mapped = 0;
    if (!camera) return kit_fail(m->err, "no memory for %d lights", count);
    for (int i = 0; i < count; ++i)
        if (placed[i].mapped) {
            const int tile[4] = { i % columns * size, i / columns * size, size, size };
            kit_camera_matrices(&placed[i].camera, camera[mapped].view, camera[mapped].projection);
            memcpy(camera[mapped++].tile, tile, sizeof tile);
        }
    if (mapped)
        m->run->atlas = kit_keep(m->run, kit_shadow_atlas(columns * size, (count + columns - 1) / columns * size,
                                                          m->world->scene, camera, mapped, m->err));
    free(camera);
    return mapped && !m->run->atlas ? -1 : 0;
}

ssgi_gl_light *kit_lights_seen(const kit_placed_light *placed, int first, int last, const float picture[16])
{
    const int size = first < last ? placed[first].camera.width : 1,
              columns = size ? (8192 / size < last ? 8192 / size : last) : 1;
    ssgi_gl_light *rows = malloc((size_t)(last - first + 1) * sizeof *rows);
    for (int i = first; rows && i < last; ++i) {
        ssgi_gl_light *l = &rows[i - first];
        *l = placed[i].light;
        for (int k = 0; k < 3; ++k) {
            l->at[k] = l->normal[k] = l->kind > 0 ? picture[12 + k] : 0;
            if (l->kind > 0) l->normal[k] = 0;
            for (int j = 0; j < 3; ++j) {
                l->at[k] += picture[4 * j + k] * placed[i].light.at[j];
                l->normal[k] += picture[4 * j + k] * placed[i].light.normal[j];
            }
        }
        if (placed[i].mapped) {
            float view[16], projection[16];
            ssgi_view decoded;
            kit_camera_matrices(&placed[i].camera, view, projection);
            ssgi_view_from_projection(&decoded, projection, SSGI_CLIP_GL, size, size, NULL);
            ssgi_gl_light_map(l, &decoded, i % columns * size, i / columns * size, picture, view, NULL);
        }
    }
    return rows;
}

GLuint kit_light_rows(const kit_placed_light *placed, int first, int last, const float picture[16])
{
    ssgi_gl_light *rows = kit_lights_seen(placed, first, last, picture);
    const GLuint texture = rows ? kit_texture(8, last - first, GL_RGBA32F, &rows[0].at[0]) : 0;
    free(rows);
    return texture;
}

/* ---- >>open ----------------------------------------------------------------------------------------------------- */

/* size * size texels of three floats, as four */
static float *rgba(float *four, const float *map, int size)
{
    for (int i = 0; i < size * size; ++i) {
        memcpy(four + 4 * i, map + 3 * i, 3 * sizeof *map);
        four[4 * i + 3] = 1;
    }
    return four;
}

/* ssgi_environment_map of a solid angle, or where that is below 0 ssgi_environment_cone of a cosine, of an environment
   that is interleaved: the last few are kept, for runs on one environment ask for the same. */
static ssgi_result environment_of(float *out, int size, const float *rgb, const kit_image *env, float solid_angle,
                                  float cosine, const char **why)
{
    enum { KEPT = 16, MOST_SIZE = 64 };
    static struct { uint64_t key; float map[3 * MOST_SIZE * MOST_SIZE]; } kept[KEPT];
    static int next;
    const size_t texels = (size_t)(size * size);
    const struct { int width, height, size; float solid_angle, cosine; } of = { env->width, env->height, size,
                                                                                solid_angle, cosine };
    const uint64_t key = kit_hash(kit_hash(KIT_HASH, &of, sizeof of), rgb,
                                  3 * (size_t)env->width * (size_t)env->height * sizeof *rgb);
    for (int i = 0; i < KEPT && size <= MOST_SIZE; ++i)
        if (kept[i].key == key) {
            memcpy(out, kept[i].map, 3 * texels * sizeof *out);
            return SSGI_OK;
        }
    const ssgi_result result =
        solid_angle >= 0 ? ssgi_environment_map(out, size, rgb, env->width, env->height, solid_angle, why)
                         : ssgi_environment_cone(out, size, rgb, env->width, env->height, cosine, why);
    if (result == SSGI_OK && size <= MOST_SIZE) {
        kept[next].key = key;
        memcpy(kept[next].map, out, 3 * texels * sizeof *out);
        next = (next + 1) % KEPT;
    }
    return result;
}

int kit_add_environment(kit_making *m)
{
    enum { SIZE = 64, OPEN = 32, CONES = 8 };
    const kit_image *env = &m->world->lighting->env;
    const size_t pixels = (size_t)env->width * (size_t)env->height;
    const int s3ho = m->gather.pass == SSGI_GL_S3HO, cones = s3ho && m->gather.shading,
              mapped = !s3ho && m->gather.environment == SSGI_GL_ENVIRONMENT_MAP;
    const int slices = m->gather.shading == SSGI_GL_SHADING_BENT_CONE ? CONES : 1, open_too = mapped || cones;
    kit_run *run = m->run;
    const char *why = "out of memory";
    float *map = malloc(3 * SIZE * SIZE * sizeof *map), *four = malloc(4 * SIZE * SIZE * sizeof *four),
          *open = malloc(4 * CONES * OPEN * OPEN * sizeof *open);
    int failed;
    run->equirect = malloc(3 * pixels * sizeof *run->equirect);
    failed = !map || !four || !open || !run->equirect;
    for (size_t i = 0; !failed && i < 3 * pixels; ++i) run->equirect[i] = env->data[i % 3 * pixels + i / 3];
    if (!failed && (s3ho ? !cones : m->gather.environment == SSGI_GL_ENVIRONMENT_SH))
        failed = ssgi_sh_project_equirect(run->harmonics, m->gather.bands, run->equirect, env->width, env->height, &why)
                 != SSGI_OK;
    if (!failed && mapped)
        failed = environment_of(map, SIZE, run->equirect, env,
                                m->gather.samples ? (float)(2 * PI / m->gather.samples)
                                : m->gather.directions
                                    ? (float)(0.75 * PI / m->gather.directions)
                                    : (float)PI * run->frame.epsilon /* of surfels at the end of a shell */,
                                0, &why)
                     != SSGI_OK
                 || !(run->environment = kit_keep(run, kit_texture(SIZE, SIZE, GL_RGBA32F, rgba(four, map, SIZE))));
    for (int k = 0; k < slices && !failed && open_too; ++k) {
        failed =
            environment_of(map, OPEN, run->equirect, env, -1, (float)k / (float)slices, &why) != SSGI_OK;
        rgba(open + 4 * k * OPEN * OPEN, map, OPEN);
    }
    if (!failed && open_too)
        failed = !(run->irradiance = kit_keep(run, kit_texture_array(OPEN, OPEN, slices, GL_RGBA32F, open)));
    free(map);
    free(four);
    free(open);
    return failed ? kit_fail(m->err, "--env: %s", why) : 0;
}
/* s3ho: suns as lobes of the environment's harmonics; the placed that are left, which depend on where a pixel is, to
   the front; and what all of those harmonics lack. */
static int add_harmonics(kit_making *m, kit_placed_light *placed, int *count)
{
    enum { OPEN = 32 };
    const kit_image *env = &m->world->lighting->env;
    const int window = (int)kit_method_value(m->method, "window"), bands = m->gather.bands;
    kit_run *run = m->run;
    const char *why = "out of memory";
    ssgi_sun suns[KIT_MAX_LIGHTS];
    float *map = calloc(3 * OPEN * OPEN, sizeof *map), *four = malloc(4 * OPEN * OPEN * sizeof *four);
    int left = 0, n = 0, failed = !map || !four;
    for (int i = 0; i < *count && !failed; ++i) {
        const ssgi_gl_light *l = &placed[i].light;
        if (l->kind > 0 || m->gather.shading) { placed[left++] = placed[i]; continue; }
        memcpy(suns[n].direction, l->at, sizeof suns[n].direction);
        memcpy(suns[n].irradiance, l->colour, sizeof suns[n].irradiance);
        failed = ssgi_sh_light(run->harmonics, bands, l->at, 0, suns[n++].irradiance, window, &why) != SSGI_OK;
    }
    *count = left;
    memset(run->frame.window, 0, sizeof run->frame.window);
    ssgi_sh_window(run->frame.window, bands, window);
    if (m->gather.residual && !m->gather.shading && !failed)
        failed =
            (env->data && environment_of(map, OPEN, run->equirect, env, 0, 0, &why) != SSGI_OK)
            || ssgi_sh_residual(map, OPEN, run->harmonics, bands, suns, n, &why) != SSGI_OK
            || !(run->irradiance = kit_keep(run, kit_texture_array(OPEN, OPEN, 1, GL_RGBA32F, rgba(four, map, OPEN))));
    free(map);
    free(four);
    return failed ? kit_fail(m->err, "harmonics: %s", why) : 0;
}

void kit_add_grey(kit_making *m)
{
    const kit_gbuffer *g = m->run->gbuffer;
    const size_t texels = (size_t)g->width * (size_t)g->height;
    float *grey = malloc(4 * texels * sizeof *grey);
    for (size_t i = 0; grey && i < 4 * texels; ++i) grey[i] = 0.8f;
    m->run->grey = kit_keep(m->run, grey ? kit_texture(g->width, g->height, GL_RGBA16F, grey) : 0);
    free(grey);
}

/* s3ho: indirect: 0 no bounce, 1 in one gather with the occlusion, 2 in one of its own. What one gather does is told
   apart by a second, without it. */
static int add_harmonic_light(kit_making *m, int indirect)
{
    kit_run *run = m->run;
    const int joint = indirect == 1, store = (int)kit_method_value(m->method, "store");
    ssgi_gl_chain chain = kit_chain(m), bounce;
    chain.vectors = !(kit_method_value(m->method, "filtered") > 0);
    chain.precise = store == 2 ? 2 : 1;
    chain.desc.packed = store == 1 || joint;            /* alike, so that both are rounded alike */
    chain.desc.shaded = !chain.vectors && !chain.desc.shading && !chain.desc.lights;
    bounce = chain;
    bounce.desc.packed = 1;
    bounce.desc.transfer = joint ? SSGI_GL_TRANSFER_BOTH : SSGI_GL_TRANSFER_REFLECTED;
    /* blockers may send more than is missing */
    if (chain.desc.restore) bounce.desc.restore = SSGI_GL_RESTORE_DIFFERENCE;
    if (joint) chain.desc.restore = bounce.desc.restore;
    if (m->rows[0] && kit_method_value(m->method, "lights") > 0) chain.lights = m->lights;
    /* shadowed lamps alone: nothing is left for coefficients */
    if (chain.lights.pass == SSGI_GL_LIGHTS && !m->world->lighting->env.data) {
        chain.desc.pass = SSGI_GL_SSDO;
        chain.desc.environment = chain.desc.bounce = 0;
        return kit_add_steps(m, &chain, 0, &run->light, NULL);
    }
    if ((indirect && kit_add_steps(m, &bounce, 0, &run->bounce, NULL))
        || kit_add_steps(m, &chain, joint, &run->light, NULL))
        return -1;
    if (joint) {
        const kit_pass *last = &run->pass[run->passes - 1];
        run->joint = run->light;
        for (int k = 0; k < last->step->inputs && last->desc.pass == SSGI_GL_LIGHTS; ++k)
            if (!strcmp(last->step->input[k].name, "t_ssgi_light")) run->joint = last->input[k];
    }
    return 0;
}

/* ssdo: what arrives at once, then the bounce of it. vpls: these bring the bounce but for what their clamp leaves
   out. */
static int add_occluded_light(kit_making *m, const kit_placed_light *placed, int direct, int count,
                              const float picture[16])
{
    kit_run *run = m->run;
    ssgi_gl_chain chain = kit_chain(m);
    chain.reuse = kit_method_value(m->method, "reuse") > 0;
    chain.vpls = kit_method_value(m->method, "vpls") > 0;
    chain.direct = run->gbuffer->direct != 0;
    if (m->rows[0]) chain.lights = m->lights;
    if (!chain.desc.environment && !m->rows[0] && !chain.direct) return 0;     /* nothing lights anything */
    if (kit_add_steps(m, &chain, 0, &run->light, &run->bounce)) return -1;
    for (int i = 0; i < run->passes; ++i)
        if (run->pass[i].step->frame == KIT_FRAME_VPLS)
            run->pass[i].lights = kit_keep(run, kit_light_rows(placed, direct, count, picture));
    run->vpls = count - direct;
    return 0;
}

/* The placed with their maps, the extra cameras, and the placed as each camera has them. */
static int add_sources(kit_making *m, const kit_placed_light *placed, int direct, int count, const float picture[16],
                       const kit_sphere *middle)
{
    kit_run *run = m->run;
    if (m->gather.views && kit_add_views(m, picture, middle)) return -1;
    if (kit_add_atlas(m, placed, count)) return -1;
    for (int v = -1; v < run->views && direct; ++v) {
        float to[16], projection[16];
        if (v >= 0) kit_camera_matrices(&run->view[v].camera, to, projection);
        m->rows[1 + v] = kit_keep(run, kit_light_rows(placed, 0, direct, v < 0 ? picture : to));
        if (!m->rows[1 + v]) return kit_fail(m->err, "no memory for %d lights", direct);
    }
    return 0;
}

int kit_open_lit(kit_making *m, const float picture[16])
{
    static const int environments[] = { SSGI_GL_ENVIRONMENT_MAP, SSGI_GL_ENVIRONMENT_SH, SSGI_GL_ENVIRONMENT_NONE };
    static const kit_lighting dark;
    kit_run *run = m->run;
    kit_gbuffer *g = run->gbuffer;
    const int suns = kit_method_value(m->method, "suns") > 0, s3ho = m->gather.pass == SSGI_GL_S3HO,
              indirect = (int)kit_method_value(m->method, "indirect");
    const int harmonics = s3ho && !(kit_method_value(m->method, "lights") > 0);
    const kit_lighting *lighting = m->world->lighting ? m->world->lighting : &dark;
    const kit_world world = { m->world->scene, lighting };
    int count = 0, direct = 0, failed;
    kit_sight seen;
    kit_placed_light *placed;
    if (s3ho && indirect && g->direct)
        return kit_fail(m->err, "method %s: its bounce is of --env and --light alone, the frame's direct.R .. would be "
                                "left out: take ssdo, or --set indirect=none", m->method->name);
    m->world = &world;
    if (!lighting->env.data) m->gather.shading = SSGI_GL_SHADING_HARMONICS;
    m->gather.environment = lighting->env.data && !suns ? environments[(int)kit_method_value(m->method, "environment")]
                                                        : SSGI_GL_ENVIRONMENT_NONE;
    if (s3ho) m->gather.environment = SSGI_GL_ENVIRONMENT_SH;
    if (!m->blurred || !m->gather.environment) m->gather.restore = 0;
    if (lighting->env.data && kit_add_environment(m)) return -1;
    kit_rotation_of(run->frame.rotation, picture, NULL);
    if (kit_seen(g, &seen, m->err)) return -1;
    placed = kit_placed_lights_new(m, &seen, &count, &direct);
    free(seen.point);
    if (!placed) return -1;
    if (s3ho) {
        int lobes = harmonics ? direct : 0;
        if (add_harmonics(m, placed, &lobes)) { free(placed); return -1; }
        if (harmonics) count = direct = lobes;
        m->gather.lights = lobes > 0;
    }
    ssgi_gl_harmonics_set(&run->frame, run->harmonics, m->gather.bands, picture, NULL);
    run->frame.lights = direct;
    failed = add_sources(m, placed, direct, count, picture, &seen.middle);
    if (!failed && !g->albedo) kit_add_grey(m);
    failed = failed || (s3ho ? add_harmonic_light(m, indirect) : add_occluded_light(m, placed, direct, count, picture));
    free(placed);
    return failed ? -1 : 0;
}

/* The casting objects' fields, and where they stand. */
int kit_open_field(kit_making *m, const float picture[16])
{
    const kit_scene *scene = m->world->scene;
    const int all = kit_method_value(m->method, "occluders") > 0;
    kit_run *run = m->run;
    ssgi_field_desc d;
    const ssgi_field **field;
    int *slice, fields = 0, count = 0, failed = 0;
    ssgi_gl_occluder *rows;
    const char *why = "";
    if (!scene) return kit_fail(m->err, "method aof: a frame has no objects to bake; it needs a scene");
    d = kit_method_field(m->method);
    if (kit_method_value(m->method, "own") <= 0 && run->gbuffer->object) m->gather.objects = SSGI_GL_OBJECTS_TEXTURE;
    field = malloc((size_t)(scene->shapes + 1) * sizeof *field);
    slice = malloc((size_t)(scene->shapes + 1) * sizeof *slice);
    rows = calloc((size_t)(scene->objects + 1), sizeof *rows);
    if (!field || !slice || !rows) failed = kit_fail(m->err, "no memory for %d objects", scene->objects);
    for (int s = 0; s < scene->shapes && !failed; ++s) {       /* rows come shape after shape */
        slice[s] = -1;
        for (int i = 0; i < scene->objects && !failed; ++i) {
            const kit_object *o = &scene->object[i];
            float to_view[16];
            ssgi_field_limits limits;
            if (o->shape != s || !(all || o->casts)) continue;
            if (slice[s] < 0) {
                slice[s] = fields;
                field[fields] = kit_field(&scene->shape[s], &d, NULL, m->err);
                if (!field[fields]) { failed = -1; break; }
                run->field_bytes += ssgi_field_size(field[fields]->resolution);
                ++fields;
            }
            for (int c = 0; c < 4; ++c)
                for (int r = 0; r < 4; ++r) {
                    to_view[4 * c + r] = 0;
                    for (int k = 0; k < 4; ++k) to_view[4 * c + r] += picture[4 * k + r] * o->to_world[4 * c + k];
                }
            limits = ssgi_field_limits_of(field[slice[s]]);
            limits.ramp = (float)kit_method_value(m->method, "ramp") * limits.reach;
            limits.power = (float)kit_method_value(m->method, "power");
            if (kit_method_value(m->method, "inside") >= 0)
                limits.inside = (float)kit_method_value(m->method, "inside");
            if (ssgi_gl_occluder_set(&rows[count++], field[slice[s]], &limits, to_view, slice[s], i + 1, &why)
                != SSGI_OK)
                failed = kit_fail(m->err, "object %s: %s", o->name, why);
        }
    }
    if (!failed && count && !(run->fields = kit_keep(run, kit_field_atlas(field, fields))))
        failed = kit_fail(m->err, "no memory for %d fields", fields);
    if (!failed && !(m->rows[0] = kit_keep(run, kit_texture(10, count ? count : 1, GL_RGBA32F, rows[0].at))))
        failed = kit_fail(m->err, "no memory for %d occluders", count);
    if (!failed) {
        const ssgi_gl_chain chain = kit_chain(m);
        failed = kit_add_steps(m, &chain, 0, &run->light, NULL);
        if (!failed) run->pass[run->passes - 1].instances = count;
    }
    run->occluders = count;
    free(field);
    free(slice);
    free(rows);
    return failed ? -1 : 0;
}
