/* pictures.c - reads images back: their error against the ground truth, PNG of the window, EXR of the left half. */
#include "viewer.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>

/* Returns whether two methods have the same ground truth. */
static int of_that_kind(const kit_method *a, const kit_method *b)
{
    return a->lit == b->lit && a->between == b->between && a->effect == b->effect
        && kit_method_attenuation(a) == kit_method_attenuation(b);
}

void side_score(viewer *v, side *s)
{
    const int w = v->drawn[0], height = v->drawn[1];
    double sum = 0, mean = 0, count = 0;
    float *p = NULL;
    s->error = (double)NAN;
    if (s->truth || !of_that_kind(&s->method, &v->truth.method)) return;
    if (!(p = malloc((size_t)w * (size_t)height * 4 * sizeof *p)) || kit_texture_read(s->picture, w, height, 4, p)) {
        free(p);
        return;
    }
    pthread_mutex_lock(&v->truth.lock);
    for (int i = 0; i < w * height; ++i) {
        const int from = (height - 1 - i / w) * w + i % w;
        if (!v->truth.rays[i] || !(p[4 * from + 3] > 0)) continue;
        for (int c = 0; c < 3; ++c) {
            const double is = (double)v->truth.rgb[3 * i + c];
            sum += ((double)p[4 * from + c] - is) * ((double)p[4 * from + c] - is);
            mean += is;
            count += 1;
        }
    }
    pthread_mutex_unlock(&v->truth.lock);
    free(p);
    if (count > 0) s->error = sqrt(sum / count) / (s->method.lit ? fmax(mean / count, 1e-9) : 1);
}

int window_save(viewer *v, const char *path)
{
    const int w = v->size[0], h = v->size[1];
    unsigned char *bytes = malloc((size_t)w * (size_t)h * 3);
    kit_image image;
    if (!bytes || kit_image_new(&image, w, h, "R,G,B", &v->err)) {
        free(bytes);
        return -1;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, w, h, GL_RGB, GL_UNSIGNED_BYTE, bytes);
    for (int i = 0; i < w * h; ++i)
        for (int c = 0; c < 3; ++c)
            image.data[c * w * h + i] = (float)bytes[3 * ((h - 1 - i / w) * w + i % w) + c] / 255;
    const int failed = kit_png_write(&image, "R,G,B", 0, path, &v->err);
    kit_image_free(&image);
    free(bytes);
    return failed;
}

static int result_save(viewer *v, const char *path)
{
    kit_image image;
    if (!v->side[0].frames.now) return kit_fail(&v->err, "%s: the left half shows nothing", path);
    if (kit_run_read(&image, v->side[0].frames.now, &v->err)) return -1;
    const int failed = kit_exr_write(&image, path, &v->err);
    kit_image_free(&image);
    return failed;
}

void picture_save(viewer *v, int exr)
{
    char path[64], text[100];
    do snprintf(path, sizeof path, "ssgi-%04d.%s", ++v->shots, exr ? "exr" : "png");
    while (!access(path, F_OK));
    snprintf(text, sizeof text, "saved: %s", path);
    panel_say(v, (exr ? result_save(v, path) : window_save(v, path)) ? v->err.text : text);
}
