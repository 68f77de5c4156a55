/* lights.c - adds a scene's light: placed lights with their shadow maps, the environment. Declared in kit_run.h. */
#include "kit/kit_run.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>lamps ----------------------------------------------------------------------------------------------------- */

static void look(kit_camera *c, const float eye[3], const float along[3], float fovy, float height, float znear,
                 float zfar, int size)
{
    float step = 1; /* at an eye at 1e9, a target 1 away would round to the eye */
    memset(c, 0, sizeof *c);
    while (step < 1e-3f * fmaxf(fabsf(eye[0]), fmaxf(fabsf(eye[1]), fabsf(eye[2])))) step *= 2;
    for (int k = 0; k < 3; ++k) { c->eye[k] = eye[k]; c->target[k] = eye[k] + step * along[k]; }
    c->up[fabsf(along[1]) < 0.9f * sqrtf(along[0] * along[0] + along[1] * along[1] + along[2] * along[2]) ? 1 : 0] = 1;
    c->fovy = fovy;
    c->ortho_height = height;
    c->znear = znear;
    c->zfar = zfar;
    c->width = c->height = size;
}

/* Widens a rectangle perpendicular to the light (least x, y, then greatest x, y) to hold a point. */
static void widen(float rectangle[4], const float axes[16], const float p[3])
{
    for (int k = 0; k < 2; ++k) {
        const float at = axes[k] * p[0] + axes[4 + k] * p[1] + axes[8 + k] * p[2];
        rectangle[k] = fminf(rectangle[k], at);
        rectangle[2 + k] = fmaxf(rectangle[2 + k], at);
    }
}

/* Finds the parts of a scene that a sun's maps cover: visible surfaces nearer than the geometric mean of their depths,
   all visible surfaces, the whole scene. Rectangles are perpendicular to the light: least x, y, then greatest x, y. */
enum { NEAR, SEEN, WHOLE, PARTS };
static void parts_of(float part[PARTS][4], float range[2], const float axes[16], const float at[3],
                     const kit_scene *scene, const kit_seen_places *seen)
{
    float least = 1e30f, last = 0;
    range[0] = 1e30f;
    range[1] = -1e30f;
    for (int k = 0; k < PARTS; ++k) for (int i = 0; i < 4; ++i) part[k][i] = i < 2 ? 1e30f : -1e30f;
    for (size_t i = 0; i < seen->points; ++i) {
        least = fminf(least, seen->point[i][3]);
        last = fmaxf(last, seen->point[i][3]);
    }
    for (size_t i = 0; i < seen->points; ++i) {
        widen(part[SEEN], axes, seen->point[i]);
        if (seen->point[i][3] <= sqrtf(least) * sqrtf(last)) widen(part[NEAR], axes, seen->point[i]);
    }
    for (int i = 0; i < 8; ++i) {
        float corner[3], t = 0;
        for (int k = 0; k < 3; ++k) {
            corner[k] = i >> k & 1 ? scene->mesh.upper[k] : scene->mesh.lower[k];
            t += corner[k] * at[k];
        }
        widen(part[WHOLE], axes, corner);
        range[0] = fminf(range[0], t);
        range[1] = fmaxf(range[1], t);
    }
}

/* Makes a sun's shadow maps, a row each, of small parts first, and returns their number. most: 3, or 1 for a map of all
   visible surfaces. A map that is hardly smaller than the next is left out. Cameras stand beyond all occluders. */
static int sun_maps(kit_placed_light *out, const float at[3], const kit_scene *scene, const kit_seen_places *seen,
                    int most, int size)
{
    static const float origin[3];
    const float along[3] = { -at[0], -at[1], -at[2] };
    float axes[16], projection[16], part[PARTS][4], range[2];
    kit_camera c;
    int count = 0, rows = 0, kept[PARTS];
    look(&c, origin, along, 0, 1, 0.1f, 1, size);
    kit_camera_matrices(&c, axes, projection);
    parts_of(part, range, axes, at, scene, seen);
    for (int k = most > 1 ? WHOLE : SEEN; k >= (most > 1 ? NEAR : SEEN); --k) {      /* the wide maps first */
        const float *p = part[k], *q = count ? part[kept[count - 1]] : p;
        const float side = fmaxf(p[2] - p[0], p[3] - p[1]), next = fmaxf(q[2] - q[0], q[3] - q[1]);
        if (!(side > 0) && k < WHOLE) continue;
        if (!count || 1.25f * side < next) kept[count++] = k;
    }
    const float *all = part[WHOLE], deep = range[1] - range[0];
    const float wide = fmaxf(all[2] - all[0], all[3] - all[1]);
    const float spare = 1e-6f * fminf(1, fmaxf(deep, wide)); /* if either is 0 */
    const float margin = 0.01f * deep + spare, away = range[1] + 2 * margin;
    for (; count > 0; --count) {                    /* in the order of rows, small parts first */
        const float *p = part[kept[count - 1]];
        kit_placed_light *l = &out[rows++];
        const float across = 0.5f * (p[0] + p[2]), up = 0.5f * (p[1] + p[3]);
        float eye[3];
        for (int k = 0; k < 3; ++k) eye[k] = axes[4 * k] * across + axes[4 * k + 1] * up + at[k] * away;
        look(&l->camera, eye, along, 0, 1.01f * fmaxf(p[2] - p[0], p[3] - p[1]) + spare, margin,
             deep + 3 * margin, size);
        l->mapped = 1;
        l->light.min_distance = (float)(count - 1);
    }
    return rows;
}

/* Makes a sun, with maps if there is a scene to shadow it. Returns the number of rows, at least one. */
static int sun(kit_placed_light *out, const float at[3], const float colour[3], const kit_scene *scene,
               const kit_seen_places *seen, int most, int size)
{
    memset(out, 0, (size_t)most * sizeof *out);
    int rows = scene ? sun_maps(out, at, scene, seen, most, size) : 0;
    if (!rows) rows = 1;
    for (int i = 0; i < rows; ++i) {
        memcpy(out[i].light.at, at, sizeof out[i].light.at);
        memcpy(out[i].light.colour, colour, sizeof out[i].light.colour);
        out[i].light.kind = SSGI_GL_LIGHT_SUN;
    }
    return rows;
}

/* Places a light of --light and returns the number of lights that it makes. */
static int place_light(kit_placed_light *out, const kit_light *w, const kit_scene *scene, const kit_seen_places *seen,
                       float extent, int size)
{
    static const float face[6][3] = { { 1, 0, 0 }, { -1, 0, 0 }, { 0, 1, 0 }, { 0, -1, 0 }, { 0, 0, 1 }, { 0, 0, -1 } };
    const int faces = scene ? 6 : 1;
    if (w->kind == KIT_SUN) return sun(out, w->at, w->colour, scene, seen, 3, size);
    for (int f = 0; f < faces; ++f) {
        kit_placed_light *l = &out[f];
        memcpy(l->light.at, w->at, sizeof l->light.at);
        memcpy(l->light.colour, w->colour, sizeof l->light.colour);
        l->light.kind = scene ? SSGI_GL_LIGHT_SPOT : SSGI_GL_LIGHT_POINT;
        l->mapped = scene != NULL;
        look(&l->camera, w->at, face[f], 90, 0, 1e-3f * seen->all.radius, extent, size);
    }
    return faces;
}

/* Approximates the environment by suns. Returns the number of lights; -1: failure. */
static int place_suns(kit_placed_light *out, const kit_making *m, const kit_scene *scene, const kit_seen_places *seen,
                      int size)
{
    const kit_image *env = &m->world->lighting->env;
    const int suns = m->set->suns;
    const char *why = "out of memory";
    ssgi_sun *found = malloc((size_t)suns * sizeof *found);
    int n = 0;
    if (!found || ssgi_environment_suns(found, suns, m->run->equirect, env->width, env->height, &why) != SSGI_OK)
        n = kit_fail(m->err, "suns: %s", why);
    for (int i = 0; i < suns && n >= 0; ++i)
        n += sun(&out[n], found[i].direction, found[i].irradiance, scene, seen, 1, size);
    free(found);
    return n;
}

/* Finds `vpls` virtual point lights, which bounce the light of the first --light; -1: failure. */
static int choose_vpls(ssgi_vpl *found, int vpls, const kit_making *m)
{
    const kit_lighting *lighting = m->world->lighting;
    const kit_scene *scene = m->world->scene;
    float *position, *normal, *flux;
    size_t pixels;
    const char *why = "";
    if (!scene || !lighting->lights || !found)
        return kit_fail(m->err, "--set vpls=%d: needs a scene and a --light", vpls);
    if (kit_rsm(&position, &normal, &flux, &pixels, scene, &lighting->light[0], 256, m->err)) return -1;
    const int failed = ssgi_vpl_choose(found, vpls, position, normal, flux, pixels, &why) != SSGI_OK;
    free(position);
    free(normal);
    free(flux);
    return failed ? kit_fail(m->err, "vpls: %s", why) : 0;
}

static int place_vpls(kit_placed_light *out, const kit_making *m, const kit_seen_places *seen, int mapped, float extent,
                      int size)
{
    const int vpls = m->set->vpls;
    ssgi_vpl *found = malloc((size_t)vpls * sizeof *found);
    const int failed = choose_vpls(found, vpls, m);
    for (int i = 0; i < vpls && !failed; ++i) {
        kit_placed_light *l = &out[i];
        memcpy(l->light.at, found[i].position, sizeof l->light.at);
        memcpy(l->light.normal, found[i].normal, sizeof l->light.normal);
        memcpy(l->light.colour, found[i].intensity, sizeof l->light.colour);
        l->light.kind = SSGI_GL_LIGHT_VPL;
        l->light.min_distance = m->run->frame.radius;
        l->mapped = mapped;
        look(&l->camera, found[i].position, found[i].normal, 150, 0, 2e-3f * seen->all.radius, extent, size);
    }
    free(found);
    return failed ? -1 : vpls;
}

kit_placed_light *kit_placed_lights_new(kit_making *m, const kit_seen_places *seen, int *count, int *direct)
{
    const kit_lighting *lighting = m->world->lighting;
    const kit_scene *scene = m->world->scene;
    const int suns = m->set->suns, vpls = m->set->vpls,
              mapped = scene
                    && (m->lights.light.shadow == SSGI_GL_SHADOW_MAP || m->lights.light.shadow == SSGI_GL_SHADOW_FILL);
    const kit_scene *shadows = mapped ? scene : NULL;
    const size_t room = (size_t)(6 * lighting->lights + suns + vpls + 1);
    int size = m->set->shadow_size, n = 0, added = 0;
    kit_placed_light *placed = calloc(room, sizeof *placed);
    float extent = 0;
    while (size > 16 && (double)size * ceil(sqrt((double)room)) > 8192) size /= 2;
    if (!placed) { kit_fail(m->err, "no memory for %d lights", (int)room); return NULL; }
    for (int k = 0; scene && k < 3; ++k) extent += scene->mesh.upper[k] - scene->mesh.lower[k];
    for (int i = 0; i < lighting->lights; ++i)
        n += place_light(&placed[n], &lighting->light[i], shadows, seen, extent, size);
    if (suns && lighting->env.data) added = place_suns(&placed[n], m, shadows, seen, size);
    n += added;
    *direct = n;
    if (vpls && added >= 0) n += added = place_vpls(&placed[n], m, seen, mapped, extent, size);
    if (added < 0) { free(placed); return NULL; }
    *count = n;
    return placed;
}

int kit_add_atlas(kit_making *m, const kit_placed_light *placed, int count)
{
    kit_shadow_camera *camera = malloc((size_t)(count + 1) * sizeof *camera);
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

/* ---- >>environment ----------------------------------------------------------------------------------------------- */

float *kit_rgba(float *four, const float *map, int size)
{
    for (int i = 0; i < size * size; ++i) {
        memcpy(four + 4 * i, map + 3 * i, 3 * sizeof *map);
        four[4 * i + 3] = 1;
    }
    return four;
}

/* Returns the hash of an environment's texels. It is only computed if they differ from the last ones, because a
   comparison is much faster. */
static uint64_t key_of(const float *rgb, size_t size)
{
    static void *last;
    static size_t last_size;
    static uint64_t key;
    if (last && last_size == size && !memcmp(last, rgb, size)) return key;
    free(last);
    last = malloc(size);
    last_size = size;
    if (last) memcpy(last, rgb, size);
    return key = kit_hash(KIT_HASH, rgb, size);
}

/* Keeps the last few results, because runs with one environment ask for the same. */
ssgi_result kit_environment_of(float *out, int size, const float *rgb, const kit_image *env, float solid_angle,
                               float cosine, const char **why)
{
    enum { KEPT = 16, MOST_SIZE = 64 };
    static struct { uint64_t key; float map[3 * MOST_SIZE * MOST_SIZE]; } kept[KEPT];
    static int next;
    const size_t texels = (size_t)(size * size);
    const struct { int width, height, size; float solid_angle, cosine; } of = { env->width, env->height, size,
                                                                                solid_angle, cosine };
    const uint64_t texel_key = key_of(rgb, 3 * (size_t)env->width * (size_t)env->height * sizeof *rgb);
    const uint64_t key = kit_hash(kit_hash(KIT_HASH, &of, sizeof of), &texel_key, sizeof texel_key);
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
    const int s3ho = m->desc.pass == SSGI_GL_PASS_S3HO, cones = s3ho && m->desc.light.shading,
              mapped = !s3ho && m->desc.light.environment == SSGI_GL_ENVIRONMENT_MAP;
    const int slices = m->desc.light.shading == SSGI_GL_SHADING_BENT_CONE ? CONES : 1, open_too = mapped || cones;
    kit_run *run = m->run;
    const char *why = "out of memory";
    float *map = malloc(3 * SIZE * SIZE * sizeof *map), *four = malloc(4 * SIZE * SIZE * sizeof *four),
          *open = malloc(4 * CONES * OPEN * OPEN * sizeof *open);
    int failed;
    run->equirect = kit_env_interleaved(env);
    failed = !map || !four || !open || !run->equirect;
    if (!failed && (s3ho ? !cones : m->desc.light.environment == SSGI_GL_ENVIRONMENT_SH))
        failed = ssgi_sh_project_equirect(run->harmonics, m->desc.light.bands, run->equirect, env->width, env->height,
                                          &why)
              != SSGI_OK;
    if (!failed && mapped)
        failed = kit_environment_of(map, SIZE, run->equirect, env,
                                    m->set->lobes ? (float)(2 * KIT_PI / m->set->lobes)
                                    : m->desc.gather.directions ? (float)(2 * KIT_PI / m->desc.gather.directions)
                                    : m->desc.gather.slices
                                        ? (float)(0.75 * KIT_PI / m->desc.gather.slices)
                                        : (float)KIT_PI * run->frame.epsilon /* surfels' area at the end of a shell */,
                                    0, &why)
                     != SSGI_OK
                 || !(run->environment = kit_keep(run, kit_texture(SIZE, SIZE, GL_RGBA32F, kit_rgba(four, map, SIZE))));
    for (int k = 0; k < slices && !failed && open_too; ++k) {
        failed =
            kit_environment_of(map, OPEN, run->equirect, env, -1, (float)k / (float)slices, &why) != SSGI_OK;
        kit_rgba(open + 4 * k * OPEN * OPEN, map, OPEN);
    }
    if (!failed && open_too)
        failed = !(run->irradiance = kit_keep(run, kit_texture_array(OPEN, OPEN, slices, GL_RGBA32F, open)));
    free(map);
    free(four);
    free(open);
    return failed ? kit_fail(m->err, "--env: %s", why) : 0;
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
