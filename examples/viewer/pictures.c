/* pictures.c - what was drawn, read back: its error to the truth, PNG of the window, EXR of a half. */
#include "viewer.h"
#include <math.h>
#include <stdlib.h>
#include <unistd.h>

static float *half_read(const viewer *v, const half *h)      /* four floats a pixel, bottom row first */
{
    float *p = malloc((size_t)v->gbuffer.width * (size_t)v->gbuffer.height * 4 * sizeof *p);
    glBindFramebuffer(GL_FRAMEBUFFER, h->framebuffer);
    if (p) glReadPixels(0, 0, v->gbuffer.width, v->gbuffer.height, GL_RGBA, GL_FLOAT, p);
    return p;
}

void half_score(viewer *v, half *h)
{
    const int w = v->gbuffer.width, height = v->gbuffer.height;
    double sum = 0, mean = 0, count = 0;
    float *p;
    h->error = (double)NAN;
    if (h->method == TRUTH || methods[h->method].lit != v->truth.lit || !(p = half_read(v, h))) return;
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
    if (count > 0) h->error = sqrt(sum / count) / (v->truth.lit ? fmax(mean / count, 1e-9) : 1);
}

int window_save(viewer *v, const char *path)
{
    const int w = v->camera.width, h = v->camera.height;
    unsigned char *bytes = malloc((size_t)w * (size_t)h * 3);
    kit_image image;
    if (!bytes || kit_image_new(&image, w, h, "R,G,B", &v->err)) { free(bytes); return -1; }
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
    const half *h = &v->half[0];
    const int w = v->gbuffer.width, height = v->gbuffer.height;
    kit_image image;
    float *p = half_read(v, h);
    if (!p || kit_image_new(&image, w, height, methods[h->method].lit ? "R,G,B" : "Y", &v->err)) { free(p); return -1; }
    for (int i = 0; i < w * height; ++i)
        for (int c = 0; c < image.channels; ++c)
            image.data[c * w * height + i] = p[4 * ((height - 1 - i / w) * w + i % w) + c];
    free(p);
    const int failed = kit_exr_write(&image, path, &v->err);
    kit_image_free(&image);
    return failed;
}

void picture_save(viewer *v, int exr)
{
    char path[64];
    do snprintf(path, sizeof path, "ssgi-%04d.%s", ++v->shots, exr ? "exr" : "png"); while (!access(path, F_OK));
    if (exr ? result_save(v, path) : window_save(v, path)) panel_say(v, v->err.text); else panel_say(v, path);
}
