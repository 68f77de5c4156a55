/* peaks.c - what the machine does at best: copying, fetching, computing. Declared in bench.h. */
#include "lab/bench/bench.h"
#include <math.h>

static const char *const bound_name[BOUNDS] = { "traffic", "fetches", "operations" };

static const char *const triangle =
    "void main() {\n"
    "    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);\n"
    "}\n";

/* What is copied must not compress. */
static const char *const noise = "out vec4 o_noise;\n"
                                 "void main() {\n"
                                 "    uvec2 p = uvec2(gl_FragCoord.xy);\n"
                                 "    uint h = (p.x * 1973u ^ p.y * 9277u) * 2654435769u;\n"
                                 "    h = (h ^ (h >> 15)) * 2246822519u;\n"
                                 "    h ^= h >> 13;\n"
                                 "    o_noise = vec4(h & 255u, (h >> 8) & 255u, (h >> 16) & 255u, h >> 24) / 255.0;\n"
                                 "}\n";

#define HEAD "uniform sampler2D t_from;\nout vec4 o_to;\nvoid main() {\n    ivec2 p = ivec2(gl_FragCoord.xy);\n"

enum { WINDOW = 8 }; /* texels that are fetched each way */

/* amount: bytes, texels or operations a pixel. A CPU draws the smaller size, whose shortest draw is one that nothing
   else interrupted. */
static const struct {
    const char *text;
    double amount;
    GLenum from;
    int size[2][2];
} probes[BOUNDS] = {
    { HEAD "    o_to = texelFetch(t_from, p, 0);\n}\n", 16, GL_RGBA16F, { { 3840, 2160 }, { 1280, 720 } } },
    { HEAD "    float sum = 0.0;\n"
           "    for (int y = 0; y < 8; ++y)\n"
           "        for (int x = 0; x < 8; ++x) sum += texelFetch(t_from, p + ivec2(x, y), 0).r;\n"
           "    o_to = vec4(sum);\n}\n",
      WINDOW *WINDOW,
      GL_R32F,
      { { 3840, 2160 }, { 256, 128 } } },
    /* eight chains of four floats, so that none waits for the one before; a multiplication and an addition each */
    { HEAD "    vec4 m = fract(vec4(p, p.yx) * 0.0137) * 0.5, n = m + 0.25;\n"
           "    vec4 a = m, b = m + 0.1, c = m + 0.2, d = m + 0.3;\n"
           "    vec4 e = m + 0.4, f = m + 0.5, g = m + 0.6, h = m + 0.7;\n"
           "    for (int i = 0; i < 128; ++i) {\n"
           "        a = a * m + n; b = b * m + n; c = c * m + n; d = d * m + n;\n"
           "        e = e * m + n; f = f * m + n; g = g * m + n; h = h * m + n;\n"
           "    }\n"
           "    o_to = a + b + c + d + e + f + g + h;\n}\n",
      128 * 8 * 4 * 2,
      GL_R32F,
      { { 3840, 2160 }, { 256, 128 } } }
};

static void draw(GLuint program, GLuint framebuffer, GLuint to, const int size[2])
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, to, 0);
    glViewport(0, 0, size[0], size[1]);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/* The shortest of some draws, in milliseconds, after a few that warm up. */
static double shortest(GLuint program, GLuint framebuffer, GLuint to, const int size[2])
{
    const double began = kit_seconds(), seconds = kit_gl_is_software() ? 0.3 : 0.15;
    double least = HUGE_VAL;
    for (int k = 0; k < 4 || (k < 200 && kit_seconds() < began + seconds); ++k) {
        kit_timer_begin();
        draw(program, framebuffer, to, size);
        const double ms = kit_timer_end();
        if (k) least = fmin(least, ms);
    }
    return least;
}

/* A second; 0: it cannot be measured here. */
static double probe(int k, kit_error *err)
{
    const int *size = probes[k].size[kit_gl_is_software()], beyond[2] = { size[0] + WINDOW, size[1] + WINDOW };
    const GLuint texture[2] = { kit_texture(beyond[0], beyond[1], probes[k].from, NULL),
                                kit_texture(size[0], size[1], GL_RGBA16F, NULL) };
    const GLuint program[2] = { kit_program_text("", triangle, noise, err),
                                kit_program_text("", triangle, probes[k].text, err) };
    GLuint framebuffer;
    double ms = 0;
    glGenFramebuffers(1, &framebuffer);
    if (!texture[0] || !texture[1]) kit_fail(err, "%s: no texture to measure it", bound_name[k]);
    else if (program[0] && program[1]) {
        glActiveTexture(GL_TEXTURE0);
        draw(program[0], framebuffer, texture[0], beyond);
        glBindTexture(GL_TEXTURE_2D, texture[0]);
        ms = shortest(program[1], framebuffer, texture[1], size);
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glUseProgram(0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(2, texture);
    for (int i = 0; i < 2; ++i) glDeleteProgram(program[i]);
    return ms > 0 ? probes[k].amount * size[0] * size[1] / ms * 1e3 : 0;
}

int peaks_measure(peaks *p, kit_error *err)
{
    double *const best[BOUNDS] = { &p->bytes, &p->fetches, &p->operations };
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    for (int k = 0; k < BOUNDS; ++k) {
        const double rate = probe(k, err);
        if (!(rate > 0)) return -1;
        *best[k] = fmax(*best[k], rate);
    }
    return 0;
}

void peaks_bounds(double ms[BOUNDS], const peaks *p, const kit_cost *cost, double covered)
{
    ms[BOUND_TRAFFIC] = cost->bytes / p->bytes * 1e3;
    ms[BOUND_FETCHES] = covered * cost->fetches / p->fetches * 1e3;
    ms[BOUND_OPERATIONS] = covered * cost->operations / p->operations * 1e3;
}
