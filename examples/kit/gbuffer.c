/* gbuffer.c - the G-buffer: rasterised from a scene, or taken from a frame, and read back as one. Declared in kit_gl.h. */
#include "kit_gl.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* A face's side is decided on the CPU (facing): gl_FrontFacing would need every mesh to be wound one way. */
static const char vertex_source[] =
    "layout(location = 0) in vec3 a_position;\n"
    "layout(location = 1) in vec3 a_normal;\n"
    "layout(location = 2) in vec3 a_facing;\n"
    "layout(location = 3) in vec3 a_albedo;\n"
    "uniform mat4 u_view;\n"
    "uniform mat4 u_projection;\n"
    "out vec3 v_normal;\n"
    "flat out vec3 v_facing;\n"
    "flat out vec3 v_albedo;\n"
    "void main() {\n"
    "    v_normal = mat3(u_view) * a_normal;\n"
    "    v_facing = mat3(u_view) * a_facing;\n"
    "    v_albedo = a_albedo;\n"
    "    gl_Position = u_projection * (u_view * vec4(a_position, 1.0));\n"
    "}\n";
static const char fragment_source[] =
    "in vec3 v_normal;\n"
    "flat in vec3 v_facing;\n"
    "flat in vec3 v_albedo;\n"
    "layout(location = 0) out vec4 o_normal;\n"
    "layout(location = 1) out vec4 o_albedo;\n"
    "void main() {\n"
    "    vec3 n = dot(v_normal, v_normal) > 0.0 ? normalize(v_normal) : v_facing;\n"
    "    o_normal = vec4(dot(n, v_facing) < 0.0 ? -n : n, 0.0);\n"
    "    o_albedo = vec4(v_albedo, 1.0);\n"
    "}\n";

enum { VERTEX_FLOATS = 12 };               /* position, normal, facing, albedo */

/* The soup as vertices. facing is the face's normal turned to the side that the camera is on. */
static float *vertices_new(const kit_mesh *mesh, const kit_camera *camera)
{
    float *vertices = malloc(mesh->triangles * 3 * VERTEX_FLOATS * sizeof *vertices + 1);
    for (size_t t = 0; vertices && t < mesh->triangles; t++) {
        const float *p = mesh->position + 9 * t;
        float facing[3];
        double a[3], b[3], face[3], toward = 0, length;
        for (int i = 0; i < 3; i++) {
            a[i] = (double)p[3 + i] - (double)p[i];
            b[i] = (double)p[6 + i] - (double)p[i];
        }
        for (int i = 0; i < 3; i++)
            face[i] = a[(i + 1) % 3] * b[(i + 2) % 3] - a[(i + 2) % 3] * b[(i + 1) % 3];
        length = sqrt(face[0] * face[0] + face[1] * face[1] + face[2] * face[2]);
        for (int i = 0; i < 3; i++)
            toward += face[i] * ((double)camera->eye[i] - (double)(camera->fovy > 0 ? p[i] : camera->target[i]));
        for (int i = 0; i < 3; i++) facing[i] = length > 0 ? (float)((toward < 0 ? -face[i] : face[i]) / length) : 0.0f;
        for (size_t k = 0; k < 3; k++) {
            float *v = vertices + (3 * t + k) * VERTEX_FLOATS;
            memcpy(v, p + 3 * k, 3 * sizeof *v);
            memcpy(v + 3, mesh->normal + 9 * t + 3 * k, 3 * sizeof *v);
            memcpy(v + 6, facing, sizeof facing);
            memcpy(v + 9, mesh->albedo + 3 * t, 3 * sizeof *v);
        }
    }
    return vertices;
}

static GLuint program_new(kit_error *err)
{
    static const GLenum stage[2] = { GL_VERTEX_SHADER, GL_FRAGMENT_SHADER };
    const char *prelude = kit_gl_is_es() ? "#version 300 es\nprecision highp float;\n" : "#version 330 core\n";
    char text[2][sizeof vertex_source + sizeof fragment_source + 64];
    const char *source[2] = { text[0], text[1] };
    snprintf(text[0], sizeof text[0], "%s%s", prelude, vertex_source);
    snprintf(text[1], sizeof text[1], "%s%s", prelude, fragment_source);
    return kit_program(source, stage, 2, err);
}

static void draw(const kit_gbuffer *g, const kit_mesh *mesh, const float *vertices, const float view[16], GLuint program)
{
    static const GLfloat zero[4] = { 0, 0, 0, 0 };
    const int reversed = g->camera.depth != KIT_DEPTH_NORMAL;
    const GLfloat clear = reversed ? 0.0f : 1.0f;
    GLuint vertex_array, buffer;
    GLint vertex_array_was = 0;
    glGetIntegerv(GL_VERTEX_ARRAY_BINDING, &vertex_array_was);
    glGenVertexArrays(1, &vertex_array);
    glBindVertexArray(vertex_array);
    glGenBuffers(1, &buffer);
    glBindBuffer(GL_ARRAY_BUFFER, buffer);
    glBufferData(GL_ARRAY_BUFFER, (GLsizeiptr)(mesh->triangles * 3 * VERTEX_FLOATS * sizeof *vertices), vertices, GL_STATIC_DRAW);
    for (GLuint i = 0; i < 4; i++) {
        glVertexAttribPointer(i, 3, GL_FLOAT, GL_FALSE, VERTEX_FLOATS * sizeof *vertices, (const void *)(3 * i * sizeof *vertices));
        glEnableVertexAttribArray(i);
    }
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "u_view"), 1, GL_FALSE, view);
    glUniformMatrix4fv(glGetUniformLocation(program, "u_projection"), 1, GL_FALSE, g->projection);

    glDisable(GL_SCISSOR_TEST); glDisable(GL_BLEND); glDisable(GL_CULL_FACE); glDisable(GL_STENCIL_TEST);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    glDepthMask(GL_TRUE);
    glDepthRangef(0, 1);
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(reversed ? GL_GREATER : GL_LESS);
    if (reversed) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    glClearBufferfv(GL_COLOR, 0, zero);
    glClearBufferfv(GL_COLOR, 1, zero);
    glClearBufferfv(GL_DEPTH, 0, &clear);
    glViewport(g->viewport[0], g->viewport[1], g->viewport[2], g->viewport[3]);
    glDrawArrays(GL_TRIANGLES, 0, (GLsizei)(3 * mesh->triangles));
    if (reversed) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glDepthFunc(GL_LESS);
    glDisable(GL_DEPTH_TEST);
    glUseProgram(0);
    glBindVertexArray((GLuint)vertex_array_was);
    glBindBuffer(GL_ARRAY_BUFFER, 0);
    glDeleteBuffers(1, &buffer);
    glDeleteVertexArrays(1, &vertex_array);
}

int kit_gbuffer_from_scene(kit_gbuffer *gbuffer, const kit_scene *scene, const kit_camera *camera, const int margin[4], kit_error *err)
{
    static const GLenum targets[2] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1 };
    static const int none[4] = { 0, 0, 0, 0 };
    kit_gbuffer g;
    float view[16], *vertices;
    GLuint framebuffer, program;
    GLint limit = 0;
    int complete;
    memset(&g, 0, sizeof g);
    if (!margin) margin = none;
    g.camera = *camera;
    kit_camera_planes(&g.camera, &scene->mesh);
    kit_camera_matrices(&g.camera, view, g.projection);
    g.width  = camera->width + margin[0] + margin[2];
    g.height = camera->height + margin[1] + margin[3];
    g.viewport[0] = margin[0]; g.viewport[1] = margin[1]; g.viewport[2] = camera->width; g.viewport[3] = camera->height;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (camera->width < 1 || camera->height < 1 || margin[0] < 0 || margin[1] < 0 || margin[2] < 0 || margin[3] < 0 ||
        g.width > limit || g.height > limit)
        return kit_fail(err, "G-buffer of %s: %d x %d texels is not a size that this context can draw (1 to %d)", scene->name, g.width, g.height, (int)limit);
    if (camera->depth != KIT_DEPTH_NORMAL && !glClipControl)
        return kit_fail(err, "G-buffer of %s: reversed depth needs glClipControl, which %s lacks", scene->name, kit_gl_name());
    if (scene->mesh.triangles > 0x7fffffff / 3)
        return kit_fail(err, "G-buffer of %s: %zu triangles are more than one draw call takes", scene->name, scene->mesh.triangles);
    vertices = vertices_new(&scene->mesh, &g.camera);
    if (!vertices) return kit_fail(err, "G-buffer of %s: no memory for %zu triangles", scene->name, scene->mesh.triangles);
    program = program_new(err);
    if (!program) { free(vertices); return -1; }

    g.depth  = kit_texture(g.width, g.height, GL_DEPTH_COMPONENT32F, NULL);
    g.normal = kit_texture(g.width, g.height, GL_RGBA32F, NULL);
    g.albedo = kit_texture(g.width, g.height, GL_RGBA16F, NULL);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, g.normal, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT1, GL_TEXTURE_2D, g.albedo, 0);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, g.depth, 0);
    glDrawBuffers(2, targets);
    complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    while (glGetError() != GL_NO_ERROR) {}
    if (complete) draw(&g, &scene->mesh, vertices, view, program);
    complete = complete && glGetError() == GL_NO_ERROR;
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteFramebuffers(1, &framebuffer);
    glDeleteProgram(program);
    free(vertices);
    if (!complete) {
        kit_gbuffer_free(&g);
        return kit_fail(err, "G-buffer of %s: %s cannot draw %d x %d RGBA32F and RGBA16F targets with %zu triangles",
                        scene->name, kit_gl_name(), g.width, g.height, scene->mesh.triangles);
    }
    *gbuffer = g;
    return 0;
}

/* the camera's planes where they are 0, from the frame's own depths */
static void planes_from_depths(kit_camera *camera, const float *z, size_t count)
{
    float nearest = FLT_MAX, farthest = 0;
    for (size_t i = 0; i < count; i++)
        if (z[i] > 0 && z[i] <= FLT_MAX) {
            nearest = z[i] < nearest ? z[i] : nearest;
            farthest = z[i] > farthest ? z[i] : farthest;
        }
    if (farthest <= 0) { nearest = 1; farthest = 100; }
    if (!(camera->znear > 0)) camera->znear = 0.5f * nearest;
    if (!(camera->zfar > 0))  camera->zfar  = 2.0f * farthest;
    if (!(camera->zfar > camera->znear)) camera->zfar = 2.0f * camera->znear;
}

int kit_gbuffer_from_frame(kit_gbuffer *gbuffer, const kit_image *frame, const kit_camera *camera, kit_error *err)
{
    static const char *const names[7] = { "Z", "N.X", "N.Y", "N.Z", "albedo.R", "albedo.G", "albedo.B" };
    const size_t width = (size_t)frame->width, texels = width * (size_t)frame->height;
    const float *channel[7];
    float view[16], *depth, *normal, *albedo;
    kit_gbuffer g;
    GLint limit = 0;
    int colours = 0;
    for (int c = 0; c < 7; c++) {
        channel[c] = kit_image_channel(frame, names[c]);
        if (c >= 4) colours += channel[c] != NULL;
        else if (!channel[c]) return kit_fail(err, "frame: channel %s is missing; Z, N.X, N.Y and N.Z are needed", names[c]);
    }
    for (int c = 4; c < 7; c++)
        if (colours && !channel[c]) return kit_fail(err, "frame: channel %s is missing; albedo has all of R, G and B, or none", names[c]);
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (frame->width > limit || frame->height > limit)
        return kit_fail(err, "frame: %d x %d is larger than this context's textures (%d)", frame->width, frame->height, (int)limit);
    memset(&g, 0, sizeof g);
    g.camera = *camera;
    g.camera.width  = g.width  = g.viewport[2] = frame->width;
    g.camera.height = g.height = g.viewport[3] = frame->height;
    g.depth_is_linear = 1;
    planes_from_depths(&g.camera, channel[0], texels);
    kit_camera_matrices(&g.camera, view, g.projection);
    depth = calloc(texels * 9, sizeof *depth);
    if (!depth) return kit_fail(err, "frame: no memory for %d x %d texels", frame->width, frame->height);
    normal = depth + texels;
    albedo = normal + 4 * texels;
    for (size_t i = 0; i < texels; i++) {
        const size_t from = (size_t)frame->height * width - (i / width + 1) * width + i % width;      /* rows turn over */
        double n[3], length;
        if (!(channel[0][from] > 0 && channel[0][from] <= FLT_MAX)) continue;
        depth[i] = channel[0][from];
        for (int c = 0; c < 3; c++) n[c] = (double)channel[1 + c][from];
        length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
        normal[4 * i + 2] = 1;
        for (size_t c = 0; c < 3 && length > 0 && length <= DBL_MAX; c++) normal[4 * i + c] = (float)(n[c] / length);
        for (size_t c = 0; c < 3 && colours; c++) albedo[4 * i + c] = channel[4 + c][from];
        albedo[4 * i + 3] = 1;
    }
    g.depth  = kit_texture(g.width, g.height, GL_R32F, depth);
    g.normal = kit_texture(g.width, g.height, GL_RGBA32F, normal);
    if (colours) g.albedo = kit_texture(g.width, g.height, GL_RGBA16F, albedo);
    free(depth);
    *gbuffer = g;
    return 0;
}

/* window depth to view depth, 0 where it is the clear value; from the projection itself, so any frustum will do */
static double view_depth(const kit_gbuffer *g, double depth)
{
    const float *p = g->projection;
    const int normal = g->camera.depth == KIT_DEPTH_NORMAL;
    const double z = normal ? 2 * depth - 1 : depth;
    if (g->depth_is_linear) return depth > 0 ? depth : 0;
    if (depth == (normal ? 1.0 : 0.0)) return 0;
    return ((double)p[14] - z * (double)p[15]) / ((double)p[10] - z * (double)p[11]);
}

int kit_gbuffer_read(kit_image *frame, const kit_gbuffer *g, kit_error *err)
{
    const size_t texels = (size_t)g->width * (size_t)g->height;
    const size_t width = (size_t)g->viewport[2], height = (size_t)g->viewport[3], pixels = width * height;
    float *depth = malloc(texels * 9 * sizeof *depth), *normal, *albedo;
    kit_image image;
    if (!depth) return kit_fail(err, "G-buffer: no memory to read %d x %d texels", g->width, g->height);
    normal = depth + texels;
    albedo = normal + 4 * texels;
    if (kit_texture_read(g->depth, g->width, g->height, 1, depth) || kit_texture_read(g->normal, g->width, g->height, 4, normal) ||
        (g->albedo && kit_texture_read(g->albedo, g->width, g->height, 4, albedo))) {
        free(depth);
        return kit_fail(err, "G-buffer: %s cannot read its textures back", kit_gl_name());
    }
    if (kit_image_new(&image, g->viewport[2], g->viewport[3],
                      g->albedo ? "Z,N.X,N.Y,N.Z,albedo.R,albedo.G,albedo.B" : "Z,N.X,N.Y,N.Z", err)) {
        free(depth);
        return -1;
    }
    for (size_t i = 0; i < pixels; i++) {
        const size_t y = height - 1 - i / width;
        const size_t from = ((size_t)g->viewport[1] + y) * (size_t)g->width + (size_t)g->viewport[0] + i % width;
        const double z = view_depth(g, (double)depth[from]);
        if (!(z > 0)) continue;
        image.data[i] = (float)z;
        for (size_t c = 0; c < 3; c++) {
            image.data[(1 + c) * pixels + i] = normal[4 * from + c];
            if (g->albedo) image.data[(4 + c) * pixels + i] = albedo[4 * from + c];
        }
    }
    free(depth);
    *frame = image;
    return 0;
}

void kit_gbuffer_free(kit_gbuffer *gbuffer)
{
    glDeleteTextures(1, &gbuffer->depth);
    glDeleteTextures(1, &gbuffer->normal);
    glDeleteTextures(1, &gbuffer->albedo);
    memset(gbuffer, 0, sizeof *gbuffer);
}
