/* shadow.c - views from lights: an atlas of shadow maps, a light's reflective shadow map. Declared in kit_gl.h. */
#include "kit/kit_gl.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* ---- >>atlas ------------------------------------------------------------------------------------------------ */

static const char vertex_source[] =
    "layout(location = 0) in vec3 a_position;\n"
    "uniform mat4 u_clip;\n"
    "void main() { gl_Position = u_clip * vec4(a_position, 1.0); }\n";
static const char fragment_source[] = "void main() {}\n";

static void draw(const kit_mesh *mesh, const kit_shadow_camera *camera, GLint at)
{
    float clip[16];
    for (int i = 0; i < 16; i++) {
        double sum = 0;
        for (int k = 0; k < 4; k++)
            sum += (double)camera->projection[4 * k + i % 4] * (double)camera->view[i / 4 * 4 + k];
        clip[i] = (float)sum;
    }
    glUniformMatrix4fv(at, 1, GL_FALSE, clip);
    glViewport(camera->tile[0], camera->tile[1], camera->tile[2], camera->tile[3]);
    glScissor(camera->tile[0], camera->tile[1], camera->tile[2], camera->tile[3]);
    glDrawArrays(GL_TRIANGLES, 0, (GLsizei)(3 * mesh->triangles));
}

/* Checks that the context can draw an atlas of that size and that the tiles are inside it. */
static int check_atlas(int width, int height, const kit_scene *scene, const kit_shadow_camera *camera, int count,
                       kit_error *err)
{
    const size_t triangles = scene->mesh.triangles, most = 0x7fffffff / 3;
    GLint limit = 0;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (width < 1 || height < 1 || width > limit || height > limit || triangles > most)
        return kit_fail(err, "shadow atlas of %s: %d x %d texels with %zu triangles is more or less than this context "
                             "can draw (1 to %d texels, %zu triangles)",
                        scene->name, width, height, triangles, (int)limit, most);
    for (int i = 0; i < count; i++) {
        const int *t = camera[i].tile;
        if (t[0] < 0 || t[1] < 0 || t[2] < 1 || t[3] < 1 || t[0] > width - t[2] || t[1] > height - t[3])
            return kit_fail(err, "shadow atlas of %s: tile %d (%d, %d, %d x %d) is not inside %d x %d texels",
                            scene->name, i, t[0], t[1], t[2], t[3], width, height);
    }
    return 0;
}

GLuint kit_shadow_atlas(int width, int height, const kit_scene *scene, const kit_shadow_camera *camera, int count,
                        kit_error *err)
{
    static const GLenum none = GL_NONE;
    static const GLfloat clear = 1;
    const kit_mesh *mesh = &scene->mesh;
    GLuint atlas, framebuffer, program;
    int drawn;
    kit_soup soup;
    if (check_atlas(width, height, scene, camera, count, err)) return 0;
    program = kit_program_kept_text("", vertex_source, fragment_source, err);
    if (!program) return 0;
    while (glGetError() != GL_NO_ERROR) {}
    atlas = kit_texture(width, height, GL_DEPTH_COMPONENT32F, NULL);
    kit_soup *stays = kit_mesh_kept(mesh);
    if (!stays) kit_soup_open(&soup, mesh->position, 3 * mesh->triangles, 1);
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, atlas, 0);
    glDrawBuffers(1, &none);
    drawn = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
    if (drawn) {
        glClearBufferfv(GL_DEPTH, 0, &clear);
        glEnable(GL_SCISSOR_TEST);
        glUseProgram(program);
        for (int i = 0; i < count; i++) draw(mesh, &camera[i], glGetUniformLocation(program, "u_clip"));
    }
    if (stays) kit_soup_rest(stays); else kit_soup_close(&soup);
    glDeleteFramebuffers(1, &framebuffer);
    if (!drawn || glGetError() != GL_NO_ERROR) {
        glDeleteTextures(1, &atlas);
        kit_fail(err, "shadow atlas of %s: %s cannot draw %d x %d texels of depth with %zu triangles",
                 scene->name, kit_gl_name(), width, height, mesh->triangles);
        return 0;
    }
    return atlas;
}

/* ---- >>rsm -------------------------------------------------------------------------------------------------- */

/* Returns the camera of face i: for a point light a face of a cube around it, for a sun a view along it around the
   bounds. direction: unit, to the sun. */
static kit_camera camera_of(const kit_light *light, const double direction[3], int face, const kit_mesh *mesh,
                            int resolution)
{
    kit_camera camera;
    double diagonal = 0;
    for (int i = 0; i < 3; i++) diagonal += pow((double)mesh->upper[i] - (double)mesh->lower[i], 2);
    diagonal = diagonal > 0 ? sqrt(diagonal) : 1;
    memset(&camera, 0, sizeof camera);
    camera.up[1] = 1;
    camera.width = camera.height = resolution;
    camera.depth = glClipControl ? KIT_DEPTH_REVERSED : KIT_DEPTH_NORMAL;
    for (int i = 0; i < 3; i++) {
        const double centre = 0.5 * ((double)mesh->lower[i] + (double)mesh->upper[i]);
        camera.target[i] = (float)(light->kind == KIT_SUN
                                       ? centre
                                       : (double)light->at[i] + (i == face / 2 ? face % 2 ? -diagonal : diagonal : 0));
        camera.eye[i]    = (float)(light->kind == KIT_SUN ? centre + diagonal * direction[i] : (double)light->at[i]);
    }
    if (light->kind == KIT_SUN) {
        float view[16], projection[16];
        /* only the camera's axes are used, along which the bounds' extent is measured */
        kit_camera_matrices(&camera, view, projection);
        for (int r = 0; r < 2; r++) {
            double extent = 0;
            for (int i = 0; i < 3; i++)
                extent += fabs((double)view[4 * i + r]) * ((double)mesh->upper[i] - (double)mesh->lower[i]);
            camera.ortho_height = fmaxf(camera.ortho_height, (float)extent);
        }
        if (!(camera.ortho_height > 0)) camera.ortho_height = (float)diagonal;
    } else {
        camera.fovy = 90;
        camera.znear = (float)(1e-4 * diagonal);
    }
    return camera;
}

/* Returns the solid angle of the rectangle from the axis to the corner x, y of a square at distance 1. */
static double corner_angle(double x, double y) { return atan2(x * y, sqrt(x * x + y * y + 1)); }

/* Returns the solid angle of a cube face's pixel. */
static double pixel_angle(size_t x, size_t y, size_t resolution)
{
    const double w = 2.0 / (double)resolution, u = w * (double)x - 1, v = w * (double)y - 1;
    return corner_angle(u + w, v + w) - corner_angle(u, v + w) - corner_angle(u + w, v) + corner_angle(u, v);
}

/* Renders a face of a light's map and writes its visible surface into the pixels from `first` on. */
static int rsm_face(float *const map[3], const kit_scene *scene, const kit_light *light, const kit_camera *camera,
                    kit_error *err)
{
    const size_t size = (size_t)camera->width, pixels = size * size;
    const double area = pow((double)camera->ortho_height / camera->width, 2);
    float view[16], projection[16];
    kit_gbuffer gbuffer;
    kit_image frame;
    if (kit_gbuffer_from_scene(&gbuffer, scene, camera, NULL, err)) return -1;
    const int failed = kit_gbuffer_read(&frame, &gbuffer, err);
    kit_gbuffer_free(&gbuffer);
    if (failed) return -1;
    kit_camera_matrices(camera, view, projection);
    for (size_t i = 0; i < pixels; i++) {
        const size_t x = i % size, y = i / size, at = 3 * i;
        const double power = light->kind == KIT_SUN ? area : pixel_angle(x, y, size);
        if (!(frame.data[i] > 0)) continue;
        kit_camera_point(camera, (int)x, (int)y, (double)frame.data[i], map[0] + at);
        for (size_t c = 0; c < 3; c++) {
            for (size_t r = 0; r < 3; r++) map[1][at + c] += view[4 * c + r] * frame.data[(1 + r) * pixels + i];
            map[2][at + c] = (float)((double)frame.data[(4 + c) * pixels + i] * (double)light->colour[c] * power);
        }
    }
    kit_image_free(&frame);
    return 0;
}

int kit_rsm(float **position, float **normal, float **flux, size_t *pixels, const kit_scene *scene,
            const kit_light *light, int resolution, kit_error *err)
{
    const size_t face_pixels = (size_t)resolution * (size_t)resolution, faces = light->kind == KIT_POINT ? 6 : 1,
                 count = faces * face_pixels;
    double direction[3], length = 0;
    float *map[3];
    int failed = 0;
    for (int i = 0; i < 3; i++) length += (double)light->at[i] * (double)light->at[i];
    length = sqrt(length);
    for (int i = 0; i < 3; i++) direction[i] = (double)light->at[i] / length;
    if ((light->kind != KIT_SUN && light->kind != KIT_POINT) || !isfinite(length)
        || (light->kind == KIT_SUN && !(length > 0)))
        return kit_fail(err, "light: must be a sun with a direction, or a point light at a finite place");
    if (resolution < 1 || resolution > 4096) return kit_fail(err, "resolution %d: must be 1..4096", resolution);
    for (int i = 0; i < 3; i++) map[i] = calloc(3 * count, sizeof *map[i]);
    if (!map[0] || !map[1] || !map[2])
        failed = kit_fail(err, "resolution %d: no memory for %zu pixels", resolution, count);
    for (size_t face = 0; face < faces && !failed; face++) {
        const kit_camera camera = camera_of(light, direction, (int)face, &scene->mesh, resolution);
        float *const of[3] = { map[0] + 3 * face * face_pixels, map[1] + 3 * face * face_pixels,
                               map[2] + 3 * face * face_pixels };
        failed = rsm_face(of, scene, light, &camera, err);
    }
    if (failed) {
        for (int i = 0; i < 3; i++) free(map[i]);
        return -1;
    }
    *position = map[0];
    *normal = map[1];
    *flux = map[2];
    *pixels = count;
    return 0;
}
