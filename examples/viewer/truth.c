/* truth.c - ray-traces the ground truth by the kit in a thread beside the drawing, 1/64 of the pixels at a time. */
#include "viewer.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Returns a camera for pixel (i, j) of each 8 x 8 block. The kit skips pixels cheaply by stride 8, and shift selects
   the pixel that it does not skip. The image's sides are rounded up to multiples of 8; pixels keep their size. A
   pixel's rays depend on its number. Unused columns on the right and rows above give each (i, j) other numbers, else 8
   x 8 pixels would share their noise. */
static kit_camera truth_camera(const kit_camera *c, int i, int j)
{
    kit_camera to = *c;
    to.width = (c->width + 7) / 8 * 8 + 8 * i;
    to.height = (c->height + 7) / 8 * 8 + 8 * j;
    to.fovy = (float)(360 / KIT_PI * atan(tan((double)c->fovy * KIT_PI / 360) * to.height / c->height));
    to.ortho_height = c->ortho_height * (float)to.height / (float)c->height;
    to.shift[0] = 4 - (float)i + 0.5f * (float)(c->width - to.width);
    to.shift[1] = (float)j - 4 + 0.5f * (float)(to.height - c->height) - 8 * (float)j;
    return to;
}

/* Adds traced pixels to the ground truth; in the first round also to unknown pixels around them, so that a whole image
   shows at once. */
static void truth_add(truth *t, const kit_image *traced, int rays, int k, int i, int j)
{
    const int lit = t->method.lit, above = 8 * j;
    const int w = t->camera.width, h = t->camera.height, block = k == 0 ? 8 : k < 4 ? 4 : k < 16 ? 2 : 1;
    const size_t pixels = (size_t)traced->width * (size_t)traced->height;
    for (int y = 4 + above; y < traced->height; y += 8)
        for (int x = 4; x < traced->width; x += 8) {
            const int at[2] = { x + i - 4, y - above + j - 4 };
            if (at[0] >= w) break;
            for (int b = 0; b < block * block; ++b) {
                const int px = at[0] + b % block, py = at[1] + b / block;
                if (px >= w || py >= h || (b && t->rays[py * w + px])) continue;
                for (size_t c = 0; c < 3; ++c)
                    t->rgb[3 * (size_t)(py * w + px) + c] =
                        traced->data[(lit ? c * pixels : 0) + (size_t)y * (size_t)traced->width + (size_t)x];
                if (!b) t->rays[py * w + px] = rays;
            }
        }
    t->now.share = (float)(k + 1) / 64;
    t->now.tracing = rays;
    t->now.rounds += k == 63;
    ++t->now.version;
}

static void *truth_thread(void *context)
{
    static const int rounds[] = { 16, 64, 256, 1024 };
    truth *t = context;
    unsigned done = 0;
    pthread_mutex_lock(&t->lock);
    for (;;) {
        while (!t->quit && t->wanted == done) pthread_cond_wait(&t->wake, &t->lock);
        if (t->quit) break;
        const unsigned now = t->wanted;
        const kit_camera camera = t->camera;
        const kit_method method = t->method;
        const float radius = t->radius;
        for (int k = 0; k < 64 * 4 && t->wanted == now && !t->quit && !t->failed; ++k) {
            const int rays = rounds[k / 64], b = k % 64;
            const int i = (b & 1) * 4 + (b >> 2 & 1) * 2 + (b >> 4 & 1);
            const int j = (b >> 1 & 1) * 4 + (b >> 3 & 1) * 2 + (b >> 5 & 1);
            const kit_camera part = truth_camera(&camera, i, j);
            kit_image traced;
            kit_error err;
            pthread_mutex_unlock(&t->lock);
            const int failed = kit_method_truth(&traced, &method, t->scene, &part, t->lighting, radius, rays, 8, &err);
            pthread_mutex_lock(&t->lock);
            if (!failed && t->wanted == now) truth_add(t, &traced, rays, b, i, j);
            if (!failed) kit_image_free(&traced);
            else if (t->wanted == now) {
                t->failed = 1;
                t->err = err;
            }
        }
        done = now;
    }
    pthread_mutex_unlock(&t->lock);
    return NULL;
}

/* Returns whether the request stays. Only this thread writes the request, so it may read it without the lock. */
static int same(const truth *t, const kit_camera *camera, const kit_method *method, float radius)
{
    return !memcmp(&t->camera, camera, sizeof *camera) && t->radius == radius && t->method.number == method->number
        && !memcmp(&t->method.set, &method->set, sizeof method->set);
}

int truth_want(truth *t, const kit_camera *camera, const kit_method *method, float radius, kit_error *err)
{
    const size_t pixels = (size_t)camera->width * (size_t)camera->height;
    if (t->started && same(t, camera, method, radius)) return 0;
    float *rgb = calloc(3 * pixels, sizeof *rgb);
    int *rays = calloc(pixels, sizeof *rays);
    if (!rgb || !rays) {
        free(rgb);
        free(rays);
        return kit_fail(err, "no memory for a truth of %d x %d", camera->width, camera->height);
    }
    pthread_mutex_lock(&t->lock);
    free(t->rgb);
    free(t->rays);
    t->rgb = rgb;
    t->rays = rays;
    t->camera = *camera;
    t->radius = radius;
    t->method = *method;
    t->failed = t->quit = 0;
    t->now = (progress){ .version = t->now.version + 1 };
    ++t->wanted;
    pthread_cond_signal(&t->wake);
    pthread_mutex_unlock(&t->lock);
    if (!t->started) t->started = !pthread_create(&t->thread, NULL, truth_thread, t);
    return t->started ? 0 : kit_fail(err, "no thread for the truth");
}

void truth_stop(truth *t)
{
    if (!t->started) return;
    pthread_mutex_lock(&t->lock);
    t->quit = 1;
    ++t->wanted;
    pthread_cond_signal(&t->wake);
    pthread_mutex_unlock(&t->lock);
    pthread_join(t->thread, NULL);
    t->started = 0;
}
