/* cost.c - computes the pixels that a run's passes draw and the bytes they move. Declared in kit_gl.h and kit_run.h. */
#include "kit/kit_run.h"
#include <math.h>

/* Returns how many pixels of its targets a pass draws. */
static double pass_pixels(const kit_pass *p)
{
    return p->box[2] ? (double)p->box[2] * p->box[3] : (double)p->width * p->height;
}

/* Returns the bytes of a texture's texel; texels gets the number of texels. */
static double texel_of(double *texels, GLuint texture, GLenum target)
{
    static const GLenum bits_of[] = { GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                                      GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE };
    const GLenum face = target == GL_TEXTURE_CUBE_MAP ? GL_TEXTURE_CUBE_MAP_POSITIVE_X : target;
    GLint size[3] = { 0 }, bits = 0, all = 0;
    glBindTexture(target, texture);
    for (GLenum i = 0; i < 2; ++i) glGetTexLevelParameteriv(face, 0, GL_TEXTURE_WIDTH + i, &size[i]);
    glGetTexLevelParameteriv(face, 0, GL_TEXTURE_DEPTH, &size[2]);
    for (size_t i = 0; i < sizeof bits_of / sizeof *bits_of; ++i, all += bits)
        glGetTexLevelParameteriv(face, 0, bits_of[i], &bits);
    glBindTexture(target, 0);
    *texels = (double)size[0] * size[1] * (target == GL_TEXTURE_CUBE_MAP ? 6 : size[2]);
    return all / 8.0;
}

/* Returns the bytes that a pass moves for one of its rows: all of an input, the drawn part of an output. */
static double row_bytes(const kit_run *run, const kit_pass *p, const ssgi_gl_io *io)
{
    const kit_gbuffer *g = p->gbuffer;
    const int in = io->kind == SSGI_GL_IO_TEXTURE;
    double texels;
    if (!in && (io->kind != SSGI_GL_IO_OUTPUT || !p->framebuffer)) return 0;
    /* A pass without targets of its own draws into an array layer. */
    const GLuint texture = in ? kit_pass_texture(run, p, io->name) : p->target[0] ? p->target[io->slot] : p->slices;
    if (!texture) return 0;
    /* Of the farther layers of the G-buffer the pass reads as many as its gather has. */
    const int slices = texture == g->layer_depth ? p->desc.gather.layers - 1
                                                 : texture == g->layer_normal || texture == g->layer_albedo;
    const double texel =
        texel_of(&texels, texture, in ? kit_target_of(io) : p->target[0] ? GL_TEXTURE_2D : GL_TEXTURE_2D_ARRAY);
    if (slices) texels *= (double)slices / (g->layers - 1);
    if (!in) texels = p->desc.pass == SSGI_GL_PASS_DSS ? 2 * run->splat_pixels : pass_pixels(p);
    return texel * texels;
}

double kit_pass_bytes(const kit_run *run, const kit_pass *p)
{
    double bytes = 0;
    if (p->aside) return 0;
    if (!glGetTexLevelParameteriv) return (double)NAN;
    for (int k = 0; k < p->rows; ++k) bytes += row_bytes(run, p, &p->io[k]);
    if (p->desc.pass == SSGI_GL_PASS_DSS || p->capture) bytes += (double)run->surfels * sizeof(ssgi_surfel);
    return bytes;
}

double kit_run_bytes(const kit_run *run)
{
    const double wide = run->frame.size[0] - 2 * run->margin, high = run->frame.size[1] - 2 * run->margin;
    double bytes = 0;
    for (int i = 0; i < run->passes; ++i) bytes += kit_pass_bytes(run, &run->pass[i]);
    return bytes / (wide * high);
}
