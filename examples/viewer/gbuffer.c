/* gbuffer.c - depth, normals, colours, and what lies behind, as an engine draws them. */
#include "viewer.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

static const char scene_vs[] =
    "#version 330 core\n"
    "layout(location = 0) in vec3 a_position; layout(location = 1) in vec3 a_normal;\n"
    "layout(location = 2) in vec3 a_face; layout(location = 3) in vec3 a_albedo;\n"
    "uniform mat4 view, projection;\n"
    "out vec3 v_position, v_normal; flat out vec3 v_face, v_albedo;\n"
    "invariant gl_Position;\n"
    "void main() {\n"
    "    vec4 p = view * vec4(a_position, 1.0);\n"
    "    v_position = p.xyz; v_normal = mat3(view) * a_normal; v_face = mat3(view) * a_face; v_albedo = a_albedo;\n"
    "    gl_Position = projection * p;\n"
    "}\n";
static const char scene_fs[] =              /* normals to the side that is seen: meshes are wound as they please */
    "#version 330 core\n"
    "in vec3 v_position, v_normal; flat in vec3 v_face, v_albedo; uniform float flat_view;\n"
    "layout(location = 0) out vec4 o_normal; layout(location = 1) out vec4 o_albedo;\n"
    "void main() {\n"
    "    vec3 face = dot(v_face, flat_view > 0.0 ? vec3(0.0, 0.0, -1.0) : v_position) > 0.0 ? -v_face : v_face;\n"
    "    vec3 n = dot(v_normal, v_normal) > 0.0 ? normalize(v_normal) : face;\n"
    "    o_normal = vec4(dot(n, face) < 0.0 ? -n : n, 0.0); o_albedo = vec4(v_albedo, 1.0);\n"
    "}\n";
static const char peel_fs[] =               /* window depth into the channel that the mask leaves */
    "#version 330 core\n"
    "in vec3 v_position; uniform sampler2D before;\n"
    "layout(location = 0) out vec4 o_slab; layout(location = 1) out float o_seen;\n"
    "void main() {\n"
    "    if (!(-v_position.z > 1.000004 * texelFetch(before, ivec2(gl_FragCoord.xy), 0).x)) discard;\n"
    "    o_slab = vec4(gl_FragCoord.z); o_seen = -v_position.z;\n"
    "}\n";

int gbuffer_open(gbuffer *g, const kit_mesh *mesh, kit_error *err)
{
    float *v = malloc(mesh->triangles * 36 * sizeof *v);
    memset(g, 0, sizeof *g);
    if (!v || mesh->triangles > 0x7fffffff / 3) {
        free(v);
        return kit_fail(err, "%zu triangles are too many", mesh->triangles);
    }
    for (size_t t = 0; t < mesh->triangles; ++t) {
        const float *p = mesh->position + 9 * t;
        float face[3], length = 0;
        for (int i = 0; i < 3; ++i) {
            const int a = (i + 1) % 3, b = (i + 2) % 3;
            face[i] = (p[3 + a] - p[a]) * (p[6 + b] - p[b]) - (p[3 + b] - p[b]) * (p[6 + a] - p[a]);
            length += face[i] * face[i];
        }
        for (int i = 0; i < 3 && length > 0; ++i) face[i] /= sqrtf(length);
        for (size_t k = 0; k < 3; ++k) {
            float *to = v + 36 * t + 12 * k;
            memcpy(to, p + 3 * k, 3 * sizeof *to);
            memcpy(to + 3, mesh->normal + 9 * t + 3 * k, 3 * sizeof *to);
            memcpy(to + 6, face, 3 * sizeof *to);
            memcpy(to + 9, mesh->albedo + 3 * t, 3 * sizeof *to);
        }
    }
    g->count = (GLsizei)(3 * mesh->triangles);
    glGenVertexArrays(1, &g->array);
    glBindVertexArray(g->array);
    glGenBuffers(1, &g->vertices);
    glBindBuffer(GL_ARRAY_BUFFER, g->vertices);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(mesh->triangles * 36 * sizeof *v), v, GL_STATIC_DRAW);
    free(v);
    for (GLuint i = 0; i < 4; ++i) {
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, 48, (const void *)(size_t)(12 * i));
        glEnableVertexAttribArray(i);
    }
    g->draw = gl_program(scene_vs, scene_fs, err);
    g->peel = gl_program(scene_vs, peel_fs, err);
    return g->draw && g->peel ? 0 : -1;
}

void gbuffer_size(gbuffer *g, int width, int height)
{
    GLuint *const made[] = { &g->depth, &g->normal, &g->albedo, &g->back,
                             &g->slabs, &g->slab_depth, &g->seen[0], &g->seen[1] };
    for (size_t i = 0; i < sizeof made / sizeof *made; ++i) glDeleteTextures(1, made[i]);
    glDeleteFramebuffers(1, &g->framebuffer);
    glDeleteFramebuffers(1, &g->back_framebuffer);
    glDeleteFramebuffers(2, g->slab_framebuffer);
    g->width = width;
    g->height = height;
    g->depth = gl_texture(width, height, 0, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    g->normal = gl_texture(width, height, 0, GL_RGBA16F, GL_RGBA, GL_FLOAT, NULL);
    g->albedo = gl_texture(width, height, 0, GL_RGBA16F, GL_RGBA, GL_FLOAT, NULL);
    g->framebuffer = gl_framebuffer((const GLuint[]){ g->normal, g->albedo }, 2, g->depth);
    g->back = gl_texture(width, height, 0, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    g->back_framebuffer = gl_framebuffer(NULL, 0, g->back);
    g->slabs = gl_texture(width, height, 0, GL_RGBA32F, GL_RGBA, GL_FLOAT, NULL);
    g->slab_depth = gl_texture(width, height, 0, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, NULL);
    for (int i = 0; i < 2; ++i) g->seen[i] = gl_texture(width, height, 0, GL_R32F, GL_RED, GL_FLOAT, NULL);
    for (int i = 0; i < 2; ++i)
        g->slab_framebuffer[i] = gl_framebuffer((const GLuint[]){ g->slabs, g->seen[i] }, 2, g->slab_depth);
}

static void gbuffer_use(const gbuffer *g, GLuint program, GLuint framebuffer, const float view[16],
                        const float projection[16])
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, g->width, g->height);
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "view"), 1, GL_FALSE, view);
    glUniformMatrix4fv(glGetUniformLocation(program, "projection"), 1, GL_FALSE, projection);
}

void gbuffer_draw(gbuffer *g, const float view[16], const float projection[16], int behind)
{
    static const GLfloat none[4], all_far[4] = { 1, 1, 1, 1 }, farthest = 1;
    glBindVertexArray(g->array);
    glEnable(GL_DEPTH_TEST);
    timer_begin(&g->time);
    gbuffer_use(g, g->draw, g->framebuffer, view, projection);
    glUniform1f(glGetUniformLocation(g->draw, "flat_view"), projection[15]);
    for (GLint i = 0; i < 2; ++i) glClearBufferfv(GL_COLOR, i, none);
    glClearBufferfv(GL_DEPTH, 0, &farthest);
    glDrawArrays(GL_TRIANGLES, 0, g->count);
    timer_end(&g->time);
    if (behind < SSGI_GL_THICKNESS_BACK) { glDisable(GL_DEPTH_TEST); return; }
    glEnable(GL_CULL_FACE);
    glCullFace(GL_FRONT);
    timer_begin(&g->slab_time);
    if (behind == SSGI_GL_THICKNESS_BACK) {
        gbuffer_use(g, g->draw, g->back_framebuffer, view, projection);
        glClearBufferfv(GL_DEPTH, 0, &farthest);
        glDrawArrays(GL_TRIANGLES, 0, g->count);
    }
    for (int i = 0; i < 3 && behind == SSGI_GL_THICKNESS_SLABS; ++i) {
        gbuffer_use(g, g->peel, g->slab_framebuffer[i & 1], view, projection);
        if (!i) {
            glBindFramebuffer(GL_FRAMEBUFFER, g->slab_framebuffer[1]);
            glClearBufferfv(GL_COLOR, 0, all_far);
            glClearBufferfv(GL_COLOR, 1, none);
            glBindFramebuffer(GL_FRAMEBUFFER, g->slab_framebuffer[0]);
        }
        glClearBufferfv(GL_COLOR, 1, (const GLfloat[4]){ 1e18f, 0, 0, 0 });
        glClearBufferfv(GL_DEPTH, 0, &farthest);
        gl_bind(0, GL_TEXTURE_2D, g->seen[!(i & 1)]);
        glColorMaski(0, i == 0, i == 1, i == 2, GL_FALSE);
        glCullFace(i == 1 ? GL_BACK : GL_FRONT);
        glDrawArrays(GL_TRIANGLES, 0, g->count);
    }
    timer_end(&g->slab_time);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DEPTH_TEST);
}
