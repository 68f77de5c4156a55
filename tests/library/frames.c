/* frames.c - vectors, harmonics, pictures of known geometry, and runs on them. Declared in frames.h. */
#include "t.h"
#include "frames.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

static const double pi = 3.14159265358979;
static kit_error err;

int half_of(float x)
{
    const double y = fmin(fabs((double)x), 65504);
    const int e = y < 6.103515625e-5 ? -14 : ilogb(y);
    return (signbit(x) ? 0x8000 : 0) + ((e + 14) << 10) + (int)nearbyint(ldexp(y, 10 - e));
}

double value_of(int half)
{
    const int e = half >> 10 & 31, m = half & 1023;
    return ldexp(e ? m + 1024 : m, (e ? e : 1) - 25) * (half & 0x8000 ? -1 : 1);
}

void rigid_about(float m[16], const float z[3])
{
    float axis[3][3], aside[3];
    do { direction(aside); } while (fabs(dot(aside, z)) > 0.9);
    cross(aside, z, axis[0]);
    const double length = sqrt(dot(axis[0], axis[0]));
    for (int k = 0; k < 3; ++k) axis[0][k] = (float)((double)axis[0][k] / length);
    cross(z, axis[0], axis[1]);
    memcpy(axis[2], z, sizeof axis[2]);
    for (int k = 0; k < 3; ++k) {
        for (int a = 0; a < 3; ++a) m[4 * k + a] = axis[a][k];
        m[4 * k + 3] = 0;
        m[12 + k] = t_uniform(-5, 5);
    }
    m[15] = 1;
}

void through(const float m[16], const float p[3], float w, float out[3])
{
    for (int i = 0; i < 3; ++i) out[i] = m[i] * p[0] + m[4 + i] * p[1] + m[8 + i] * p[2] + m[12 + i] * w;
}

double occluded_by(const ssgi_field *f, const ssgi_field_limits *l, const float to[16], const float p[3],
                       const float n[3])
{
    const float square = to[0] * to[0] + to[1] * to[1] + to[2] * to[2];
    float q[3] = { 0 }, turned[3] = { 0 };
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 3; ++j) {
            q[k] += to[4 * k + j] * (p[j] - to[12 + j]) / square;
            turned[k] += to[4 * k + j] * n[j] / sqrtf(square);
        }
    return (double)ssgi_field_occlusion(f, l, q, turned);
}

double series(const float *coefficients, int channels, int bands, const float d[3], const double *factor)
{
    float basis[HARMONICS];
    double sum = 0;
    ssgi_sh_basis(basis, bands, d);
    for (int l = 0, i = 0; l < bands; ++l)
        for (; i < (l + 1) * (l + 1); ++i)
            sum += (double)basis[i] * (double)coefficients[channels * i] * (factor ? factor[l] : 1);
    return sum;
}

const double of_cosine[SSGI_SH_MAX_BANDS] = { KIT_PI, 2 * KIT_PI / 3, KIT_PI / 4, 0, -KIT_PI / 24, 0 };

double equirect(float d[3], int i, int width, int height)
{
    const double lat = pi * (0.5 - (i / width + 0.5) / height), lon = pi - 2 * pi * (i % width + 0.5) / width;
    d[0] = (float)(cos(lat) * sin(lon));
    d[1] = (float)sin(lat);
    d[2] = (float)(cos(lat) * cos(lon));
    return (sin(lat + pi / 2 / height) - sin(lat - pi / 2 / height)) * 2 * pi / width;
}

void smooth_sky(float *rgb, float coefficients[27], int width, int height)
{
    float d[3];
    for (int i = 0; i < 27; ++i) coefficients[i] = i < 3 ? t_uniform(9, 12) : t_uniform(-1, 1);
    for (int i = 0; i < 3 * width * height; ++i) {
        equirect(d, i / 3, width, height);
        rgb[i] = (float)series(coefficients + i % 3, 3, 3, d, NULL);
    }
}

kit_camera looking_along_z(int width, int height, int orthographic)
{
    kit_camera c = { { 0, 0, 0 }, { 0, 0, -1 }, { 0, 1, 0 }, orthographic ? 0 : 45, 2, 0.01f, 1000,
                     width,       height,       { 0, 0 },    KIT_DEPTH_NORMAL };
    return c;
}

int view_of(ssgi_view *view, const kit_camera *c, int flipped)
{
    float world[16], projection[16];
    kit_camera_matrices(c, world, projection);
    for (int k = 1; flipped && k < 16; k += 4) projection[k] = -projection[k];
    return T_OK(ssgi_view_from_projection, view, projection,
                c->depth == KIT_DEPTH_NORMAL ? SSGI_CLIP_GL : SSGI_CLIP_ZERO, c->width, c->height);
}

int planes_seen(kit_image *frame, const kit_camera *c, const double (*plane)[4], int planes, const char *more)
{
    ssgi_view view;
    char names[256];
    const size_t width = (size_t)c->width, pixels = width * (size_t)c->height;
    snprintf(names, sizeof names, "Z,N.X,N.Y,N.Z%s", more);
    if (!view_of(&view, c, 0) || !TRY(kit_image_new(frame, c->width, c->height, names, &err))) return 0;
    for (size_t at = 0; at < pixels; ++at) {
        const double x = (double)(at % width) + 0.5, y = (double)((pixels - 1 - at) / width) + 0.5;
        const double p[2] = { x * (double)view.unproject[0] + (double)view.unproject[2],
                              y * (double)view.unproject[1] + (double)view.unproject[3] };
        for (int k = 0; k < planes; ++k) {
            const double *n = plane[k], across = n[0] * p[0] + n[1] * p[1],
                         z = c->fovy > 0 ? n[3] / (across - n[2]) : (n[3] - across) / -n[2];
            if (!(z > (double)c->znear && z < 0.5 * (double)c->zfar)) continue;
            if (frame->data[at] > 0 && z >= (double)frame->data[at]) continue;
            frame->data[at] = (float)z;
            for (size_t i = 0; i < 3; ++i) frame->data[(1 + i) * pixels + at] = (float)n[i];
        }
    }
    return 1;
}

int walls(kit_gbuffer *g, kit_image *frame, const kit_camera *c, const double (*plane)[4], int planes,
          const char *more)
{
    return planes_seen(frame, c, plane, planes, more) && TRY(kit_gbuffer_from_frame(g, frame, c, &err));
}

void turn(kit_run *run, kit_gbuffer *g)
{
    run->gbuffer = g;
    for (int i = 0; i < run->passes; ++i) run->pass[i].gbuffer = g;
}

void resize(kit_pass *p, int width, int height, const float *data)
{
    p->width = width;
    p->height = height;
    for (int t = 0; t < p->step->outputs; ++t) {
        const ssgi_gl_format *f = p->step->output[t].format;
        if (!p->target[t]) continue;
        glBindTexture(GL_TEXTURE_2D, p->target[t]);
        glTexImage2D(GL_TEXTURE_2D, 0, (GLint)f->internal, width, height, 0, f->format,
                     f->type == GL_UNSIGNED_INT ? f->type : GL_FLOAT, data);
    }
}

int flat(const kit_image *frame, int x, int y)
{
    for (int k = 0; k < 49; ++k) {
        const int u = x + k % 7 - 3, v = y + k / 7 - 3;
        if (u < 0 || v < 0 || u >= frame->width || v >= frame->height || !(frame->data[v * frame->width + u] > 0))
            return 0;
    }
    return 1;
}

double linear_corner(double c)
{
    const double s = sqrt(1 - c * c);
    return (acos(c) + c * s - 2 * c * log((1 + s) / c)) / pi;
}

double hard_corner(double c)   { return (acos(c) - c * sqrt(1 - c * c)) / pi; }

int row_at(double c) { return SPAN + 16 - (int)(c * SPAN); }

kit_camera corner_planes(double plane[2][4], double c, double behind)
{
    kit_camera camera = looking_along_z(WIDE, HIGH, 1);
    /* the edge between floor and wall: its y in view space */
    const double r = sqrt(0.5), pixel = r / SPAN, edge = (row_at(c) + 0.5 - 0.5 * HIGH) * pixel + c * r;
    const double n[2][4] = { { 0, r, r, r * (edge - 4) }, { 0, -r, r, r * (-edge - 4) - behind } };
    memcpy(plane, n, sizeof n);
    camera.ortho_height = (float)(HIGH * pixel);
    return camera;
}

double row_of(kit_run *run, kit_gbuffer *g, int row, int phases)
{
    double sum = 0;
    float line[COLUMNS];
    turn(run, g);
    --run->passes;                                         /* draws the last pass in part, its inputs whole */
    kit_run_update(run);
    kit_run_draw(run, 0);
    ++run->passes;
    glEnable(GL_SCISSOR_TEST);
    glScissor(MIDDLE, row, COLUMNS, 1);
    for (int k = 0; k < phases; ++k) {
        run->frame.phase = (float)k / (float)phases;
        kit_run_update(run);
        kit_run_draw(run, 0);
        glReadPixels(MIDDLE, row, COLUMNS, 1, GL_RED, GL_FLOAT, line);
        for (int i = 0; i < COLUMNS; ++i) sum += (double)line[i];
    }
    glDisable(GL_SCISSOR_TEST);
    return sum / (COLUMNS * phases);
}

int lighten(kit_lighting *l, const char *env, const char *light)
{
    memset(l, 0, sizeof *l);
    if (light && !TRY(kit_light_parse(&l->light[l->lights++], light, NULL, &err))) return 0;
    if (!env) return 1;
    if (strcmp(env, "white")) return TRY(kit_env_read(&l->env, env, &err));
    /* a map so fine that harmonics do not notice its rows */
    if (!TRY(kit_image_new(&l->env, 512, 256, "R,G,B", &err))) return 0;
    for (int i = 0; i < 3 * 512 * 256; ++i) l->env.data[i] = 1;
    return 1;
}

static const float grey[3] = { 0.5f, 0.5f, 0.5f };

int see(kit_scene *scene, kit_gbuffer *g, const char *name, const box *boxes, int count, const kit_camera *camera,
        int width, int height)
{
    if (!TRY(kit_scene_load(scene, name, 0, &err))) return 0;
    for (int i = 0; i < count; ++i)
        if (!TRY(kit_scene_add_box(scene, boxes[i].lower, boxes[i].upper, grey, &err))) return 0;
    if (camera) scene->camera = *camera;
    scene->camera.width = width;
    scene->camera.height = height;
    return TRY(kit_gbuffer_from_scene(g, scene, &scene->camera, NULL, &err));
}

int set_scene(scenery *s, const char *name, const kit_camera *camera, const char *env, const char *light, int width,
              int height)
{
    return lighten(&s->light, env, light) && see(&s->scene, &s->g, name, NULL, 0, camera, width, height);
}

void strike(scenery *s)
{
    kit_image_free(&s->light.env);
    kit_gbuffer_free(&s->g);
    kit_scene_free(&s->scene);
}

int open_run(kit_run *run, kit_gbuffer *g, const char *method, const char *set, float radius, const kit_scene *scene,
             const kit_lighting *lighting)
{
    const kit_world world = { scene, lighting };
    kit_method m;
    memset(run, 0, sizeof *run);
    return CHECK(!kit_method_find(&m, method, &err) && !kit_method_set(&m, set, &err)
                     && !kit_run_open(run, g, &m, radius, &world, &err),
                 "%s %s: %s", method, set, err.text);
}

/* begin: 33 samples, as Mesa unrolls loops of up to 32, and then takes long to compile them. */
int begin(kit_run *run, kit_gbuffer *g, const char *method, const char *set, float radius, const kit_scene *scene,
          const kit_lighting *lighting)
{
    char all[300];
    snprintf(all, sizeof all, "%s%s%s%s",
             strstr(method, "-points") ? "blur=0,directions=33,samples=1,range_check=0,fade=none"
                 : "blur=0,resolution=full,samples=33",
             strncmp(method, "s3ho", 4) && strncmp(method, "ssdo", 4) ? "" : ",residual=0", *set ? "," : "", set);
    return open_run(run, g, method, all, radius, scene, lighting);
}

int drawn(kit_image *out, kit_run *run)
{
    kit_run_update(run);
    kit_run_draw(run, 0);
    return TRY(kit_run_read(out, run, &err));
}

int lit(kit_image *out, kit_gbuffer *g, const char *method, const char *set, float radius, const kit_scene *scene,
        const kit_lighting *lighting)
{
    OWN(kit_run) run = { 0 };
    return begin(&run, g, method, set, radius, scene, lighting) && drawn(out, &run);
}

double mean(const kit_image *image, const char *name)
{
    const float *channel = kit_image_channel(image, name);
    double sum = 0;
    for (int i = 0; i < image->width * image->height; ++i) sum += (double)channel[i];
    return sum / (image->width * image->height);
}

void open_vector(double v[16], const double n[3])
{
    /* factors of zonal harmonics of max(0, cos) */
    static const double lobe[4] = { 0.886226925453, 1.02332670795, 0.4954159122, 0 };
    const float direction[3] = { (float)n[0], (float)n[1], (float)n[2] };
    float y[16];
    ssgi_sh_basis(y, 4, direction);
    for (int i = 0; i < 16; ++i) {
        const int band = i < 1 ? 0 : i < 4 ? 1 : i < 9 ? 2 : 3;
        v[i] = lobe[band] * sqrt(4 * pi / (2 * band + 1)) * (double)y[i];
    }
}

double met(const double v[16], const float *light, int c, int bands)
{
    double sum = 0;
    for (int i = 0; i < bands * bands; ++i) sum += v[i] * (double)light[3 * i + c];
    return sum / pi;
}

int slab(kit_gbuffer *g, double c, double thickness, double gap, int layers)
{
    static const char *const more[3] = {
        "", ",layer1.Z,layer1.N.X,layer1.N.Y,layer1.N.Z",
        ",layer1.Z,layer1.N.X,layer1.N.Y,layer1.N.Z,layer2.Z,layer2.N.X,layer2.N.Y,layer2.N.Z"
    };
    double plane[2][4];
    const kit_camera camera = corner_planes(plane, c, 0);
    const size_t pixels = (size_t)WIDE * HIGH;
    OWN(kit_image) frame = { 0 };
    int ok = planes_seen(&frame, &camera, (const double (*)[4])plane, 2, more[layers - 1]);
    for (int j = 1; j < layers && ok; ++j) {
        OWN(kit_image) behind = { 0 };
        corner_planes(plane, c, j == 1 ? thickness : thickness + gap);
        ok = planes_seen(&behind, &camera, (const double (*)[4])plane + 1, 1, "");
        for (size_t i = 0; ok && i < 4 * pixels; ++i)
            if (frame.data[2 * pixels + i % pixels] < 0)
                frame.data[4 * pixels * (size_t)j + i] = i < pixels || j == 2 ? behind.data[i] : -behind.data[i];
    }
    return ok && TRY(kit_gbuffer_from_frame(g, &frame, &camera, &err));
}

double difference(const kit_image *a, const kit_image *b)
{
    const int pixels = a->width * a->height;
    double sum = 0;
    for (int i = 0; i < pixels; ++i) sum += pow((double)a->data[i] - (double)b->data[i], 2);
    return sqrt(sum / pixels);
}
