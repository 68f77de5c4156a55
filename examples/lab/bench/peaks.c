/* peaks.c - the highest rate at which the machine copies. Declared in bench.h. */
#include "lab/bench/bench.h"
#include <math.h>

static const char *const triangle =
    "void main() {\n"
    "    gl_Position = vec4(gl_VertexID == 1 ? 3.0 : -1.0, gl_VertexID == 2 ? 3.0 : -1.0, 0.0, 1.0);\n"
    "}\n";

/* GLSL of noise, which the copied texture holds so that the GPU cannot compress it. */
static const char *const noise = "out vec4 o_noise;\n"
                                 "void main() {\n"
                                 "    uvec2 p = uvec2(gl_FragCoord.xy);\n"
                                 "    uint h = (p.x * 1973u ^ p.y * 9277u) * 2654435769u;\n"
                                 "    h = (h ^ (h >> 15)) * 2246822519u;\n"
                                 "    h ^= h >> 13;\n"
                                 "    o_noise = vec4(h & 255u, (h >> 8) & 255u, (h >> 16) & 255u, h >> 24) / 255.0;\n"
                                 "}\n";

static const char *const copy = "uniform sampler2D t_from;\n"
                                "out vec4 o_to;\n"
                                "void main() { o_to = texelFetch(t_from, ivec2(gl_FragCoord.xy), 0); }\n";

/* The sizes of the copied texture, on a GPU and on a CPU. */
static const int sizes[2][2] = { { 3840, 2160 }, { 1280, 720 } };

enum { MOVED = 16 }; /* bytes a pixel that a copy reads and writes */

static void draw(GLuint program, GLuint framebuffer, GLuint to, const int size[2])
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, to, 0);
    glViewport(0, 0, size[0], size[1]);
    glUseProgram(program);
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/* Returns the shortest of some draws' times in milliseconds, after a few draws that warm up. */
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

int peaks_measure(double *best, kit_error *err)
{
    const int *size = sizes[kit_gl_is_software()];
    const GLuint texture[2] = { kit_texture(size[0], size[1], GL_RGBA16F, NULL),
                                kit_texture(size[0], size[1], GL_RGBA16F, NULL) };
    const GLuint program[2] = { kit_program_text("", triangle, noise, err),
                                kit_program_text("", triangle, copy, err) };
    GLuint framebuffer;
    double ms = 0;
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glGenFramebuffers(1, &framebuffer);
    if (!texture[0] || !texture[1]) kit_fail(err, "traffic: no texture to measure it");
    else if (program[0] && program[1]) {
        glActiveTexture(GL_TEXTURE0);
        draw(program[0], framebuffer, texture[0], size);
        glBindTexture(GL_TEXTURE_2D, texture[0]);
        ms = shortest(program[1], framebuffer, texture[1], size);
        glBindTexture(GL_TEXTURE_2D, 0);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glUseProgram(0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteTextures(2, texture);
    for (int i = 0; i < 2; ++i) glDeleteProgram(program[i]);
    if (!(ms > 0)) return -1;
    *best = fmax(*best, MOVED * (double)size[0] * size[1] / ms * 1e3);
    return 0;
}
