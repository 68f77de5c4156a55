/* motion.c - draws the motion of the sliding object since the last frame into a texture of the G-buffer, which history
   reads. Declared in viewer.h. */
#include "viewer.h"
#include "kit/kit_run.h"

static const char vertex_text[] =
    "void main() { gl_Position = vec4(vec2(gl_VertexID & 1, gl_VertexID >> 1) * 4.0 - 1.0, 0.0, 1.0); }\n";
static const char fragment_text[] =
    "uniform sampler2D depth; uniform highp usampler2D object;\n"
    "uniform vec4 now, decode, last; // as ssgi_view has them: unproject; depth, clear, orthographic; project\n"
    "uniform mat4 to_last; uniform vec3 by; uniform int slides;\n"
    "out vec2 o;\n"
    "void main() {\n"
    "    ivec2 p = ivec2(gl_FragCoord.xy);\n"
    "    float d = texelFetch(depth, p, 0).x, z = decode.x + decode.y * d;\n"
    "    o = vec2(0.0);\n"
    "    if (d == decode.z) return;\n"
    "    if (decode.w == 0.0) z = 1.0 / z;\n"
    "    vec2 xy = (gl_FragCoord.xy * now.xy + now.zw) * (decode.w > 0.0 ? 1.0 : z);\n"
    "    vec4 was = to_last * vec4(xy, -z, 1.0);\n"
    "    if (int(texelFetch(object, p, 0).x) == slides) was.xyz -= by;\n"
    "    o = gl_FragCoord.xy - (was.xy / (decode.w > 0.0 ? 1.0 : -was.z) * last.xy + last.zw);\n"
    "}\n";

static GLint place(GLuint program, const char *name) { return glGetUniformLocation(program, name); }

int motion_open(viewer *v)
{
    v->motion = kit_program_text("", vertex_text, fragment_text, &v->err);
    if (!v->motion) return -1;
    glUseProgram(v->motion);
    glUniform1i(place(v->motion, "object"), 1);
    return 0;
}

/* Writes the matrix from one rigid view space to another, and a world-space direction in the latter. */
static void relate(float to[16], float by[3], const float from[16], const float into[16], const float world[3])
{
    float back[16] = { [15] = 1 };
    for (int i = 0; i < 3; ++i)
        for (int k = 0; k < 3; ++k) {
            back[4 * i + k] = from[4 * k + i];
            back[12 + i] -= from[4 * i + k] * from[12 + k];
        }
    for (int i = 0; i < 16; ++i) {
        to[i] = 0;
        for (int k = 0; k < 4; ++k) to[i] += into[4 * k + i % 4] * back[i / 4 * 4 + k];
    }
    for (int i = 0; i < 3; ++i) by[i] = into[i] * world[0] + into[4 + i] * world[1] + into[8 + i] * world[2];
}

int motion_draw(viewer *v, kit_gbuffer *next, const kit_gbuffer *last)
{
    const float *is = v->stood[next - v->gbuffer], *was = v->stood[last - v->gbuffer];
    const float moved[3] = { is[0] - was[0], is[1] - was[1], is[2] - was[2] };
    const GLuint textures[2] = { next->depth, next->object };
    float now[16], then[16], projection[16], to[16], by[3];
    ssgi_view view, before;
    GLuint framebuffer;
    int k = 0;
    while (k < v->scene.objects && !v->scene.object[k].casts) ++k;
    if (!next->object || kit_view_of(&view, next->projection, next->camera.depth, next->width, next->height, &v->err)
        || kit_view_of(&before, last->projection, last->camera.depth, last->width, last->height, &v->err))
        return next->object ? -1 : 0;
    const float decode[4] = { view.depth[0], view.depth[1], view.clear, (float)view.orthographic };
    kit_camera_matrices(&next->camera, now, projection);
    kit_camera_matrices(&last->camera, then, projection);
    relate(to, by, now, then, moved);
    next->motion = kit_texture(next->width, next->height, GL_RG32F, NULL);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, next->motion, 0);
    glViewport(0, 0, next->width, next->height);
    glUseProgram(v->motion);
    for (GLuint i = 0; i < 2; ++i) {
        glActiveTexture(GL_TEXTURE0 + i);
        glBindTexture(GL_TEXTURE_2D, textures[i]);
    }
    glUniform4fv(place(v->motion, "now"), 1, view.unproject);
    glUniform4fv(place(v->motion, "last"), 1, before.project);
    glUniform4fv(place(v->motion, "decode"), 1, decode);
    glUniformMatrix4fv(place(v->motion, "to_last"), 1, GL_FALSE, to);
    glUniform3fv(place(v->motion, "by"), 1, by);
    glUniform1i(place(v->motion, "slides"), k + 1);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    return 0;
}
