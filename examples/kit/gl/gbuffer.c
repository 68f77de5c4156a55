/* gbuffer.c - the G-buffer: rasterised from a scene or taken from a frame, and read back as a frame. Declared in
   kit_gl.h. */
#include "kit/kit_gl.h"
#include "kit/kit_trace.h"
#include <float.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The visible side of a face is the side of its plane on which u_eye lies (facing); if orthographic, the side of the
   parallel plane through u_target. (gl_FrontFacing would need all meshes to have one winding.) u_side: 1 turns normals
   toward the viewer, -1 away.

   PEEL keeps fragments that are behind u_previous, the view depths of the layer before, by more than 4e-6 of that
   depth. This same program interpolated those depths, so a surface finds its own depth again bit by bit; the tolerance
   is for surfaces that coincide (a box on a floor), whose depths differ by rounding. Window depth would be too coarse
   for it away from the near plane. SLAB is PEEL without normals and albedo. */
static const char vertex_source[] =
    "layout(location = 0) in vec3 a_position;\n"
    "layout(location = 1) in vec3 a_normal;\n"
    "layout(location = 2) in vec3 a_facing;\n"
    "layout(location = 3) in vec3 a_albedo;\n"
    "layout(location = 4) in vec3 a_object;\n"
    "uniform mat4 u_view;\n"
    "uniform mat4 u_projection;\n"
    "uniform float u_side, u_orthographic;\n"
    "uniform vec3 u_eye, u_target;\n"
    "invariant gl_Position;\n"
    "out float v_depth;\n"
    "out vec3 v_normal;\n"
    "flat out vec3 v_facing;\n"
    "flat out vec3 v_albedo;\n"
    "flat out float v_object;\n"
    "void main() {\n"
    "    v_normal = mat3(u_view) * a_normal;\n"
    "    float toward = dot(a_facing, u_eye - (u_orthographic > 0.0 ? u_target : a_position));\n"
    "    v_facing = mat3(u_view) * (toward < 0.0 ? -a_facing : a_facing) * u_side;\n"
    "    v_albedo = a_albedo;\n"
    "    v_object = a_object.x;\n"
    "    vec4 position = u_view * vec4(a_position, 1.0);\n"
    "    v_depth = -position.z;\n"
    "    gl_Position = u_projection * position;\n"
    "}\n";
static const char fragment_source[] =
    "in float v_depth;\n"
    "in vec3 v_normal;\n"
    "flat in vec3 v_facing;\n"
    "flat in vec3 v_albedo;\n"
    "flat in float v_object;\n"
    "#ifdef SLAB\n"
    "#define PEEL\n"
    "layout(location = 0) out float o_depth;\n"
    "vec4 o_normal, o_albedo;\n"
    "#else\n"
    "layout(location = 0) out vec4 o_normal;\n"
    "layout(location = 1) out vec4 o_albedo;\n"
    "#ifdef PEEL\n"
    "layout(location = 2) out float o_depth;\n"
    "#endif\n"
    "#endif\n"
    "#ifdef PEEL\n"
    "uniform sampler2D u_previous;\n"
    "#else\n"
    "layout(location = 2) out highp uint o_object;\n"
    "#endif\n"
    "void main() {\n"
    "#ifdef PEEL\n"
    "    if (!(v_depth > 1.000004 * texelFetch(u_previous, ivec2(gl_FragCoord.xy), 0).x)) discard;\n"
    "    o_depth = v_depth;\n"
    "#else\n"
    "    o_object = uint(v_object + 0.5);\n"
    "#endif\n"
    "    vec3 n = dot(v_normal, v_normal) > 0.0 ? normalize(v_normal) : v_facing;\n"
    "    o_normal = vec4(dot(n, v_facing) < 0.0 ? -n : n, 0.0);\n"
    "    o_albedo = vec4(v_albedo, 1.0);\n"
    "}\n";

/* floats of position, normal, facing, albedo, the object's number, and two of padding */
enum { VERTEX_FLOATS = 15 };

/* Returns the mesh's triangles as vertices. Their attribute facing is the face's normal. */
static float *vertices_new(const kit_mesh *mesh)
{
    float *vertices = malloc(mesh->triangles * 3 * VERTEX_FLOATS * sizeof *vertices + 1);
    for (size_t t = 0; vertices && t < mesh->triangles; t++) {
        const float *p = mesh->position + 9 * t;
        float facing[3];
        double face[3];
        const int faces = kit_face(p, face);
        for (int i = 0; i < 3; i++) facing[i] = faces ? (float)face[i] : 0.0f;
        for (size_t k = 0; k < 3; k++) {
            float *v = vertices + (3 * t + k) * VERTEX_FLOATS;
            memcpy(v, p + 3 * k, 3 * sizeof *v);
            memcpy(v + 3, mesh->normal + 9 * t + 3 * k, 3 * sizeof *v);
            memcpy(v + 6, facing, sizeof facing);
            memcpy(v + 9, mesh->albedo + 3 * t, 3 * sizeof *v);
            v[12] = mesh->object ? (float)mesh->object[t] : 0.0f;
            v[13] = v[14] = 0;
        }
    }
    return vertices;
}

/* the mesh that kit_mesh_keep uploaded */
static struct { const kit_mesh *mesh; kit_soup soup; } kept;

static int soup_open(kit_soup *soup, const kit_mesh *mesh, kit_error *err)
{
    float *vertices = vertices_new(mesh);
    if (!vertices) return kit_fail(err, "no memory for %zu triangles", mesh->triangles);
    kit_soup_open(soup, vertices, mesh->triangles * 3, VERTEX_FLOATS / 3);
    free(vertices);
    return 0;
}

int kit_mesh_keep(const kit_mesh *mesh, kit_error *err)
{
    kit_mesh_forget();
    if (soup_open(&kept.soup, mesh, err)) return -1;
    kit_soup_rest(&kept.soup);
    kept.mesh = mesh;
    return 0;
}

void kit_mesh_forget(void)
{
    if (kept.mesh) kit_soup_close(&kept.soup);
    kept.mesh = NULL;
}

kit_soup *kit_mesh_kept(const kit_mesh *mesh)
{
    if (kept.mesh != mesh) return NULL;
    kit_soup_use(&kept.soup);
    return &kept.soup;
}

/* Sets GL's state to draw triangles with g's camera, and returns a framebuffer without targets. */
static GLuint begin(const kit_gbuffer *g, GLuint program)
{
    const int reversed = g->camera.depth != KIT_DEPTH_NORMAL;
    float view[16], projection[16];
    GLuint framebuffer;
    kit_camera_matrices(&g->camera, view, projection);
    memcpy(projection, g->projection, sizeof projection);
    /* Floats would round the depths of a distant orthographic eye; they are drawn relative to the near plane. */
    if (!(g->camera.fovy > 0) && g->camera.znear > g->camera.zfar - g->camera.znear) {
        const double near = (double)g->camera.znear;
        double axes[3][3], eye = near;
        kit_camera_axes(&g->camera, axes);
        for (int i = 0; i < 3; i++) eye -= axes[2][i] * (double)g->camera.eye[i];
        view[14] = (float)eye;
        projection[14] = (float)((double)projection[14] - (double)projection[10] * near);
    }
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glUseProgram(program);
    glUniformMatrix4fv(glGetUniformLocation(program, "u_view"), 1, GL_FALSE, view);
    glUniformMatrix4fv(glGetUniformLocation(program, "u_projection"), 1, GL_FALSE, projection);
    glUniform3fv(glGetUniformLocation(program, "u_eye"), 1, g->camera.eye);
    glUniform3fv(glGetUniformLocation(program, "u_target"), 1, g->camera.target);
    glUniform1f(glGetUniformLocation(program, "u_orthographic"), g->camera.fovy > 0 ? 0.0f : 1.0f);
    glViewport(g->viewport[0], g->viewport[1], g->viewport[2], g->viewport[3]);
    glDepthFunc(reversed ? GL_GREATER : GL_LESS);
    if (reversed) glClipControl(GL_LOWER_LEFT, GL_ZERO_TO_ONE);
    return framebuffer;
}

/* Draws the nearest back face, the next front face behind it, and the next back face behind that, as window depths.
   Each pass also writes view depth, by which the next pass peels. */
static int draw_slabs(kit_gbuffer *g, const kit_mesh *mesh, GLuint program, const GLuint depth[3])
{
    static const GLfloat zero[4] = { 0, 0, 0, 0 }, farthest[4] = { SSGI_FAR, 0, 0, 0 };
    const int reversed = g->camera.depth != KIT_DEPTH_NORMAL, passes = depth[2] ? 3 : 1;
    const GLfloat clear = reversed ? 0.0f : 1.0f;
    GLuint framebuffer, view_depth[2];
    int complete = 1;
    framebuffer = begin(g, program);
    for (int i = 0; i < 2; i++) view_depth[i] = kit_texture(g->width, g->height, GL_R32F, NULL);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, view_depth[1], 0);
    glClearBufferfv(GL_COLOR, 0, zero);
    glActiveTexture(GL_TEXTURE0);
    glEnable(GL_CULL_FACE);
    kit_timer_begin();
    for (int i = 0; i < passes && complete; i++) {
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, view_depth[i % 2], 0);
        glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, depth[i], 0);
        glBindTexture(GL_TEXTURE_2D, view_depth[(i + 1) % 2]);
        complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
        glClearBufferfv(GL_COLOR, 0, farthest);
        glClearBufferfv(GL_DEPTH, 0, &clear);
        glCullFace(i == 1 ? GL_BACK : GL_FRONT);
        if (complete) glDrawArrays(GL_TRIANGLES, 0, (GLsizei)(3 * mesh->triangles));
    }
    g->slab_ms[passes > 1] = kit_timer_end();
    glDisable(GL_CULL_FACE);
    glCullFace(GL_BACK);
    if (reversed) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteTextures(2, view_depth);
    glDeleteFramebuffers(1, &framebuffer);
    return complete && glGetError() == GL_NO_ERROR;
}

/* Draws g's first layer or, with a program that peels, all others; 0 if the context cannot. Peeling draws the first
   layer again for its view depth, into the slices of the second layer. View depths pass from layer to layer through a
   pair of textures, so that no pass reads the array that it writes. */
static int draw(const kit_gbuffer *g, const kit_mesh *mesh, GLuint program, int peels)
{
    static const GLenum targets[3] = { GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2 };
    static const GLuint none[4] = { 0, 0, 0, 0 };
    static const GLfloat zero[4] = { 0, 0, 0, 0 }, farthest[4] = { SSGI_FAR, 0, 0, 0 };
    const int reversed = g->camera.depth != KIT_DEPTH_NORMAL;
    const GLfloat clear = reversed ? 0.0f : 1.0f;
    GLuint framebuffer, view_depth[2] = { 0, 0 };
    int complete = 1;
    framebuffer = begin(g, program);
    glDrawBuffers(3, targets);
    if (peels) {
        for (int i = 0; i < 2; i++) view_depth[i] = kit_texture(g->width, g->height, GL_R32F, NULL);
        glFramebufferTexture2D(GL_FRAMEBUFFER, targets[2], GL_TEXTURE_2D, view_depth[1], 0);
        glClearBufferfv(GL_COLOR, 2, zero);                    /* PEEL's previous depth for the first layer is 0 */
        glActiveTexture(GL_TEXTURE0);
    }
    for (int layer = 0; layer < (peels ? g->layers : 1) && complete; layer++) {
        const int slice = layer ? layer - 1 : 0;
        if (peels) {
            glFramebufferTextureLayer(GL_FRAMEBUFFER, targets[0], g->layer_normal, 0, slice);
            glFramebufferTextureLayer(GL_FRAMEBUFFER, targets[1], g->layer_albedo, 0, slice);
            glFramebufferTextureLayer(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, g->layer_depth, 0, slice);
            glFramebufferTexture2D(GL_FRAMEBUFFER, targets[2], GL_TEXTURE_2D, view_depth[layer % 2], 0);
            glBindTexture(GL_TEXTURE_2D, view_depth[(layer + 1) % 2]);
        } else {
            glFramebufferTexture2D(GL_FRAMEBUFFER, targets[0], GL_TEXTURE_2D, g->normal, 0);
            glFramebufferTexture2D(GL_FRAMEBUFFER, targets[1], GL_TEXTURE_2D, g->albedo, 0);
            glFramebufferTexture2D(GL_FRAMEBUFFER, targets[2], GL_TEXTURE_2D, g->object, 0);
            glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, g->depth, 0);
        }
        complete = glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
        if (!complete) break;
        for (int i = 0; i < 2; i++) glClearBufferfv(GL_COLOR, i, zero);
        if (peels) glClearBufferfv(GL_COLOR, 2, farthest);
        else       glClearBufferuiv(GL_COLOR, 2, none);
        glClearBufferfv(GL_DEPTH, 0, &clear);
        glUniform1f(glGetUniformLocation(program, "u_side"), layer % 2 ? -1.0f : 1.0f);
        glDrawArrays(GL_TRIANGLES, 0, (GLsizei)(3 * mesh->triangles));
    }
    if (reversed) glClipControl(GL_LOWER_LEFT, GL_NEGATIVE_ONE_TO_ONE);
    if (peels) glBindTexture(GL_TEXTURE_2D, 0);
    glBindFramebuffer(GL_FRAMEBUFFER, 0);
    glDeleteTextures(2, view_depth);
    glDeleteFramebuffers(1, &framebuffer);
    return complete && glGetError() == GL_NO_ERROR;
}

static int rasterise(kit_gbuffer *g, const kit_scene *scene, int peels, const GLuint *slab, kit_error *err)
{
    const kit_mesh *mesh = &scene->mesh;
    kit_soup soup;
    GLuint program;
    int drawn;
    if (scene->mesh.triangles > 0x7fffffff / 3)
        return kit_fail(err, "G-buffer of %s: %zu triangles are more than one draw call takes", scene->name,
                        scene->mesh.triangles);
    program = kit_program_kept_text(slab    ? "#define SLAB\n"
                                    : peels ? "#define PEEL\n"
                                            : "",
                                    vertex_source, fragment_source, err);
    if (!program) return -1;
    while (glGetError() != GL_NO_ERROR) {}
    kit_soup *stays = kit_mesh_kept(mesh);
    if (!stays && soup_open(&soup, mesh, err)) return -1;
    drawn = slab ? draw_slabs(g, mesh, program, slab) : draw(g, mesh, program, peels);
    if (stays) kit_soup_rest(stays); else kit_soup_close(&soup);
    if (!drawn)
        return kit_fail(err,
                        "G-buffer of %s: %s cannot draw %d layers of %d x %d RGBA32F and RGBA16F texels with %zu "
                        "triangles",
                        scene->name, kit_gl_name(), g->layers, g->width, g->height, scene->mesh.triangles);
    return 0;
}

int kit_gbuffer_from_scene(kit_gbuffer *gbuffer, const kit_scene *scene, const kit_camera *camera, const int margin[4],
                           kit_error *err)
{
    static const int none[4] = { 0, 0, 0, 0 };
    kit_gbuffer g;
    float view[16];
    GLint limit = 0;
    memset(&g, 0, sizeof g);
    if (!margin) margin = none;
    g.layers = 1;
    g.camera = *camera;
    kit_camera_planes(&g.camera, &scene->mesh);
    kit_camera_matrices(&g.camera, view, g.projection);
    g.width  = camera->width + margin[0] + margin[2];
    g.height = camera->height + margin[1] + margin[3];
    g.viewport[0] = margin[0]; g.viewport[1] = margin[1]; g.viewport[2] = camera->width; g.viewport[3] = camera->height;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (camera->width < 1 || camera->height < 1 || margin[0] < 0 || margin[1] < 0 || margin[2] < 0 || margin[3] < 0 ||
        g.width > limit || g.height > limit)
        return kit_fail(err, "G-buffer of %s: %d x %d texels is not a size that this context can draw (1 to %d)",
                        scene->name, g.width, g.height, (int)limit);
    if (camera->depth != KIT_DEPTH_NORMAL && !glClipControl)
        return kit_fail(err, "G-buffer of %s: reversed depth needs glClipControl, which %s lacks", scene->name,
                        kit_gl_name());
    g.depth  = kit_texture(g.width, g.height, GL_DEPTH_COMPONENT32F, NULL);
    g.normal = kit_texture(g.width, g.height, GL_RGBA32F, NULL);
    g.albedo = kit_texture(g.width, g.height, GL_RGBA16F, NULL);
    g.object = kit_texture(g.width, g.height, GL_R32UI, NULL);
    if (rasterise(&g, scene, 0, NULL, err)) {
        kit_gbuffer_free(&g);
        return -1;
    }
    *gbuffer = g;
    return 0;
}

int kit_gbuffer_widen(kit_gbuffer *wide, const kit_gbuffer *g, const kit_scene *scene, int pixels, kit_error *err)
{
    const double more = 1 + 2.0 * pixels / g->viewport[3];
    kit_camera c = g->camera;
    c.width = g->viewport[2] + 2 * pixels;
    c.height = g->viewport[3] + 2 * pixels;
    c.fovy = (float)(360 / KIT_PI * atan(more * tan((double)c.fovy * KIT_PI / 360)));
    c.ortho_height = (float)(more * (double)c.ortho_height);
    return kit_gbuffer_from_scene(wide, scene, &c, NULL, err);
}

static void layers_free(kit_gbuffer *g)
{
    glDeleteTextures(1, &g->layer_depth);
    glDeleteTextures(1, &g->layer_normal);
    glDeleteTextures(1, &g->layer_albedo);
    g->layer_depth = g->layer_normal = g->layer_albedo = 0;
    g->layers = 1;
}

int kit_gbuffer_peel(kit_gbuffer *gbuffer, const kit_scene *scene, int layers, kit_error *err)
{
    kit_gbuffer g = *gbuffer;
    if (layers < 1 || layers > KIT_MAX_LAYERS) return kit_fail(err, "layers %d: must be 1..%d", layers, KIT_MAX_LAYERS);
    if (g.depth_is_linear) return kit_fail(err, "G-buffer: it came from a frame, which has no scene to peel");
    if (layers > 1) {
        g.layers       = layers;
        g.layer_depth  = kit_texture_array(g.width, g.height, layers - 1, GL_DEPTH_COMPONENT32F, NULL);
        g.layer_normal = kit_texture_array(g.width, g.height, layers - 1, GL_RGBA32F, NULL);
        g.layer_albedo = kit_texture_array(g.width, g.height, layers - 1, GL_RGBA16F, NULL);
        if (rasterise(&g, scene, 1, NULL, err)) {
            layers_free(&g);
            return -1;
        }
        layers_free(gbuffer);
        *gbuffer = g;
    } else layers_free(gbuffer);
    return 0;
}

/* Packs three planes of texels as one array of four components, with the rows in the same order. */
static GLuint packed_slabs(const kit_gbuffer *g, const float *planes)
{
    const size_t texels = (size_t)g->width * (size_t)g->height;
    float *packed = calloc(4 * texels, sizeof *packed);
    GLuint texture;
    if (!packed) return 0;
    for (size_t i = 0; i < 3 * texels; i++) packed[4 * (i % texels) + i / texels] = planes[i];
    texture = kit_texture(g->width, g->height, GL_RGBA32F, packed);
    free(packed);
    return texture;
}

int kit_gbuffer_slabs(kit_gbuffer *gbuffer, const kit_scene *scene, int slabs, kit_error *err)
{
    const size_t texels = (size_t)gbuffer->width * (size_t)gbuffer->height;
    kit_gbuffer g = *gbuffer;
    GLuint depth[3] = { 0, 0, 0 };
    float *planes;
    int failed;
    if (slabs < 1 || slabs > 2) return kit_fail(err, "slabs %d: must be 1 or 2", slabs);
    if (g.depth_is_linear)
        return kit_fail(err, "G-buffer: it came from a frame, which has no scene to draw back faces of");
    for (int i = 0; i < (slabs > 1 ? 3 : 1); i++)
        depth[i] = kit_texture(g.width, g.height, GL_DEPTH_COMPONENT32F, NULL);
    failed = rasterise(&g, scene, 0, depth, err);
    if (!failed && slabs > 1) {
        planes = malloc(3 * texels * sizeof *planes);
        failed = !planes;
        for (int i = 0; i < 3 && !failed; i++)
            failed = kit_texture_read(depth[i], g.width, g.height, 1, planes + (size_t)i * texels);
        g.slabs = failed ? 0 : packed_slabs(&g, planes);
        failed = !g.slabs && kit_fail(err, "G-buffer of %s: no memory for slabs", scene->name);
        free(planes);
    } else if (!failed) { g.back = depth[0]; depth[0] = 0; }
    glDeleteTextures(3, depth);
    if (failed) return -1;
    glDeleteTextures(1, slabs > 1 ? &gbuffer->slabs : &gbuffer->back);
    *gbuffer = g;
    return 0;
}

/* Sets the camera's near and far planes, if they are 0, from the frame's depths. */
static void planes_from_depths(kit_camera *camera, const float *z, size_t count)
{
    float nearest = FLT_MAX, farthest = 0;
    for (size_t i = 0; i < count; i++)
        if (z[i] > 0 && z[i] < SSGI_FAR) {
            nearest = z[i] < nearest ? z[i] : nearest;
            farthest = z[i] > farthest ? z[i] : farthest;
        }
    if (farthest <= 0) { nearest = 1; farthest = 100; }
    if (!(camera->fovy > 0) && !(camera->znear > 0)) {     /* place the plane near the eye, where depth then begins */
        const float spare = 1e-3f * nearest + 0.01f * (farthest - nearest);
        camera->znear = nearest - spare;
        if (!(camera->zfar > 0)) camera->zfar = farthest + spare;
    }
    if (!(camera->znear > 0)) camera->znear = 0.5f * nearest;
    if (!(camera->zfar > 0))  camera->zfar  = 2.0f * farthest;
    if (!(camera->zfar > camera->znear)) camera->zfar = 2.0f * camera->znear;
}

/* indices of a layer's channels; only the first layer has DIRECT */
enum { Z, N, ALBEDO = 4, DIRECT = 7, CHANNELS = 10 };
static const char *const channel_names[CHANNELS] =
    { "Z", "N.X", "N.Y", "N.Z", "albedo.R", "albedo.G", "albedo.B", "direct.R", "direct.G", "direct.B" };

static const char *const slab_names[3] = { "back.Z", "front2.Z", "back2.Z" };

static void channel_name(char out[32], int layer, int c)
{
    if (layer) snprintf(out, 32, "layer%d.%s", layer, channel_names[c]);
    else       snprintf(out, 32, "%s", channel_names[c]);
}

/* Finds channels first .. last - 1 of a layer. Returns 1 if it has all, 0 if none, -1 if some; the error names a
   missing one. */
static int channels_find(const float **channel, const kit_image *frame, int layer, int first, int last, kit_error *err)
{
    char name[32], missing[32] = "";
    int found = 0;
    for (int c = first; c < last; c++) {
        channel_name(name, layer, c);
        channel[c] = kit_image_channel(frame, name);
        found += channel[c] != NULL;
        if (!channel[c] && !missing[0]) memcpy(missing, name, sizeof missing);
    }
    return !missing[0] ? 1
           : !found    ? 0
                       : kit_fail(err,
                                  "frame: channel %s is missing; a layer has all of Z, N.X, N.Y and N.Z (the only "
                                     "one perhaps Z alone), and all of albedo.R/G/B or none, as all of direct.R/G/B",
                                  missing);
}

/* The planes of a frame's channels; NULL: the frame lacks the channel. */
typedef struct frame_channels {
    const float *layer[KIT_MAX_LAYERS][CHANNELS], *slab[3], *motion[2];
    int          layers, normals, colours, lit;
    size_t       slabs;                    /* 0: none; 1: the nearest back face; 3: two slabs */
} frame_channels;

static int channels_of(frame_channels *f, const kit_image *frame, kit_error *err)
{
    memset(f, 0, sizeof *f);
    f->layer[0][Z] = kit_image_channel(frame, channel_names[Z]);
    if (!f->layer[0][Z]) return kit_fail(err, "frame: channel Z is missing");
    f->normals = channels_find(f->layer[0], frame, 0, N, ALBEDO, err);
    if (f->normals < 0) return -1;
    for (f->layers = 1; f->layers < KIT_MAX_LAYERS; f->layers++) {
        const int found = channels_find(f->layer[f->layers], frame, f->layers, Z, ALBEDO, err);
        if (found < 0) return -1;
        if (!found) break;
        if (!f->normals) return kit_fail(err, "frame: channel N.X is missing, which a frame of several layers needs");
    }
    f->colours = channels_find(f->layer[0], frame, 0, ALBEDO, DIRECT, err);
    f->lit = channels_find(f->layer[0], frame, 0, DIRECT, CHANNELS, err);
    if (f->colours < 0 || f->lit < 0) return -1;
    for (int layer = 1; layer < f->layers && f->colours; layer++)
        if (channels_find(f->layer[layer], frame, layer, ALBEDO, DIRECT, err) != 1)
            return kit_fail(err, "frame: layer%d lacks albedo, which the first layer has", layer);
    for (int i = 0; i < 3; i++) f->slab[i] = kit_image_channel(frame, slab_names[i]);
    f->motion[0] = kit_image_channel(frame, "motion.X");
    f->motion[1] = kit_image_channel(frame, "motion.Y");
    if ((f->slab[1] || f->slab[2]) && !(f->slab[0] && f->slab[1] && f->slab[2]))
        return kit_fail(err, "frame: front2.Z and back2.Z need each other and back.Z");
    f->slabs = f->slab[2] ? 3 : f->slab[0] ? 1 : 0;
    return 0;
}

/* Returns the frame's index of texel i of a texture, whose rows run the other way. */
static size_t frame_row(const kit_gbuffer *g, size_t i)
{
    const size_t width = (size_t)g->width;
    return (size_t)g->height * width - (i / width + 1) * width + i % width;
}

/* Reads depth, normal and colours of texel `at` from the frame; texels of all layers are numbered in one sequence. */
static void take_texel(const kit_gbuffer *g, const frame_channels *f, size_t at, float *depth, float *normal,
                       float *albedo, float *direct)
{
    const size_t texels = (size_t)g->width * (size_t)g->height, layer = at / texels, i = at % texels;
    const size_t from = frame_row(g, i);
    const float *const *c_of = f->layer[layer];
    double n[3];
    if (!(c_of[Z][from] > 0 && c_of[Z][from] < SSGI_FAR)) return;
    depth[at] = c_of[Z][from];
    for (int c = 0; c < 3; c++) n[c] = f->normals ? (double)c_of[N + c][from] : 0;
    const double length = sqrt(n[0] * n[0] + n[1] * n[1] + n[2] * n[2]);
    normal[4 * at + 2] = layer % 2 ? -1.0f : 1.0f;
    for (size_t c = 0; c < 3 && length > 0 && length <= DBL_MAX; c++) normal[4 * at + c] = (float)(n[c] / length);
    for (size_t c = 0; c < 3 && f->colours; c++) albedo[4 * at + c] = c_of[ALBEDO + c][from];
    albedo[4 * at + 3] = 1;
    for (size_t c = 0; c < 3 && f->lit && !layer; c++) {
        const float value = c_of[DIRECT + c][from];
        direct[4 * i + c] = value > 0 && value <= FLT_MAX ? value : 0.0f;
    }
}

/* Fills the textures of all layers from the frame. room: 9 floats a texel of each layer and 4 more a texel, all 0 */
static void take_layers(kit_gbuffer *g, const frame_channels *f, float *room)
{
    const size_t texels = (size_t)g->width * (size_t)g->height, all = (size_t)g->layers * texels;
    float *depth = room, *normal = depth + all, *albedo = normal + 4 * all, *direct = albedo + 4 * all;
    for (size_t at = 0; at < all; at++) take_texel(g, f, at, depth, normal, albedo, direct);
    g->depth  = kit_texture(g->width, g->height, GL_R32F, depth);
    if (f->normals) g->normal = kit_texture(g->width, g->height, GL_RGBA32F, normal);
    if (f->colours) g->albedo = kit_texture(g->width, g->height, GL_RGBA16F, albedo);
    if (f->lit)     g->direct = kit_texture(g->width, g->height, GL_RGBA32F, direct);
    if (g->layers == 1) return;
    g->layer_depth  = kit_texture_array(g->width, g->height, g->layers - 1, GL_R32F, depth + texels);
    g->layer_normal = kit_texture_array(g->width, g->height, g->layers - 1, GL_RGBA32F, normal + 4 * texels);
    if (f->colours)
        g->layer_albedo = kit_texture_array(g->width, g->height, g->layers - 1, GL_RGBA16F, albedo + 4 * texels);
}

/* Fills the textures of back faces and motion from the frame; room as for take_layers. */
static void take_slabs_and_motion(kit_gbuffer *g, const frame_channels *f, float *room)
{
    const size_t texels = (size_t)g->width * (size_t)g->height;
    for (size_t at = 0; at < f->slabs * texels; at++) {
        const float z = f->slab[at / texels][frame_row(g, at % texels)];
        room[at] = z > 0 && z < SSGI_FAR ? z : 0;
    }
    if (f->slabs) g->back = kit_texture(g->width, g->height, GL_R32F, room);
    if (f->slabs > 1) g->slabs = packed_slabs(g, room);
    if (!f->motion[0] || !f->motion[1]) return;
    for (size_t i = 0; i < texels; i++)
        for (size_t c = 0; c < 2; c++) {   /* the frame's +y is up in channel 1; rows are bottom first */
            const float v = f->motion[c][frame_row(g, i)];
            room[2 * i + c] = !isfinite(v) ? 0 : c ? -v : v;
        }
    g->motion = kit_texture(g->width, g->height, GL_RG32F, room);
}

int kit_gbuffer_from_frame(kit_gbuffer *gbuffer, const kit_image *frame, const kit_camera *camera, kit_error *err)
{
    const size_t texels = (size_t)frame->width * (size_t)frame->height;
    frame_channels f;
    kit_gbuffer g;
    float view[16];
    GLint limit = 0;
    if (channels_of(&f, frame, err)) return -1;
    glGetIntegerv(GL_MAX_TEXTURE_SIZE, &limit);
    if (frame->width > limit || frame->height > limit)
        return kit_fail(err, "frame: %d x %d is larger than this context's textures (%d)", frame->width, frame->height,
                        (int)limit);
    memset(&g, 0, sizeof g);
    g.layers = f.layers;
    g.camera = *camera;
    g.camera.width  = g.width  = g.viewport[2] = frame->width;
    g.camera.height = g.height = g.viewport[3] = frame->height;
    g.depth_is_linear = 1;
    planes_from_depths(&g.camera, f.layer[0][Z], texels);
    kit_camera_matrices(&g.camera, view, g.projection);
    float *room = calloc(texels * (9 * (size_t)g.layers + 4), sizeof *room);
    if (!room)
        return kit_fail(err, "frame: no memory for %d x %d texels in %d layers", frame->width, frame->height, g.layers);
    take_layers(&g, &f, room);
    take_slabs_and_motion(&g, &f, room);
    free(room);
    *gbuffer = g;
    return 0;
}

/* Converts window depth to view depth, the clear value to 0; by the projection matrix, so for any frustum. */
static double view_depth(const kit_gbuffer *g, double depth)
{
    const float *p = g->projection;
    const int normal = g->camera.depth == KIT_DEPTH_NORMAL;
    const double z = normal ? 2 * depth - 1 : depth;
    if (g->depth_is_linear) return depth > 0 ? depth : 0;
    if (depth == (normal ? 1.0 : 0.0)) return 0;
    return ((double)p[14] - z * (double)p[15]) / ((double)p[10] - z * (double)p[11]);
}

/* Reads a layer's texels: the first from a 2D texture, the others from an array texture. */
static int layer_read(GLuint texture, GLuint array, int layer, const kit_gbuffer *g, int components, float *out)
{
    return layer ? kit_texture_slice_read(array, layer - 1, g->width, g->height, components, out)
                 : kit_texture_read(texture, g->width, g->height, components, out);
}

/* Adds the names of channels first .. last - 1 of a layer to a list. */
static void names_add(char *names, size_t size, int layer, int first, int last)
{
    for (int c = first; c < last; c++) {
        size_t length = strlen(names);
        char name[32];
        channel_name(name, layer, c);
        snprintf(names + length, size - length, "%s%s", length ? "," : "", name);
    }
}

/* Returns the texture's index of pixel i of the image, whose rows run the other way. */
static size_t texel_of(const kit_gbuffer *g, size_t i)
{
    const size_t width = (size_t)g->viewport[2], y = (size_t)g->viewport[3] - 1 - i / width;
    return ((size_t)g->viewport[1] + y) * (size_t)g->width + (size_t)g->viewport[0] + i % width;
}

/* Reads a layer into its channels. room: 13 floats a texel. */
static int read_layer(kit_image *image, const kit_gbuffer *g, int layer, float *room)
{
    const size_t texels = (size_t)g->width * (size_t)g->height, colours = g->normal ? ALBEDO : N,
                 channels = colours + (g->albedo ? DIRECT - ALBEDO : 0),
                 pixels = (size_t)g->viewport[2] * (size_t)g->viewport[3];
    float *depth = room, *normal = depth + texels, *albedo = normal + 4 * texels, *direct = albedo + 4 * texels;
    float *out = image->data + (size_t)layer * channels * pixels,
          *out_direct = image->data + (size_t)g->layers * channels * pixels;
    const int lit = g->direct && !layer;
    if ((lit && kit_texture_read(g->direct, g->width, g->height, 4, direct))
        || layer_read(g->depth, g->layer_depth, layer, g, 1, depth)
        || (g->normal && layer_read(g->normal, g->layer_normal, layer, g, 4, normal))
        || (g->albedo && layer_read(g->albedo, g->layer_albedo, layer, g, 4, albedo)))
        return -1;
    for (size_t i = 0; i < pixels; i++) {
        const size_t from = texel_of(g, i);
        const double z = view_depth(g, (double)depth[from]);
        if (!(z > 0)) continue;
        out[i] = (float)z;
        for (size_t c = 0; c < 3; c++) {
            if (g->normal) out[(N + c) * pixels + i] = normal[4 * from + c];
            if (g->albedo) out[(colours + c) * pixels + i] = albedo[4 * from + c];
            if (lit) out_direct[c * pixels + i] = direct[4 * from + c];
        }
    }
    return 0;
}

/* Reads the depths of slabs; room: 4 floats a texel. */
static int read_slabs(kit_image *image, const kit_gbuffer *g, size_t slabs, float *room)
{
    const size_t pixels = (size_t)g->viewport[2] * (size_t)g->viewport[3];
    if (!slabs) return 0;
    if (kit_texture_read(slabs > 1 ? g->slabs : g->back, g->width, g->height, slabs > 1 ? 4 : 1, room)) return -1;
    for (size_t k = 0; k < slabs; k++) {
        float *out = kit_image_channel(image, slab_names[k]);
        for (size_t i = 0; i < pixels; i++) {
            const size_t from = texel_of(g, i);
            out[i] = (float)view_depth(g, (double)room[slabs > 1 ? 4 * from + k : from]);
        }
    }
    return 0;
}

int kit_gbuffer_read(kit_image *frame, const kit_gbuffer *g, kit_error *err)
{
    const size_t texels = (size_t)g->width * (size_t)g->height, slabs = g->slabs ? 3 : g->back ? 1 : 0;
    char names[KIT_MAX_CHANNELS * 32] = "";
    kit_image image;
    int failed = 0;
    for (int layer = 0; layer < g->layers; layer++) {
        names_add(names, sizeof names, layer, Z, g->normal ? ALBEDO : N);
        if (g->albedo) names_add(names, sizeof names, layer, ALBEDO, DIRECT);
    }
    if (g->direct) names_add(names, sizeof names, 0, DIRECT, CHANNELS);
    for (size_t i = 0; i < slabs; i++) {
        const size_t length = strlen(names);
        snprintf(names + length, sizeof names - length, ",%s", slab_names[i]);
    }
    float *room = malloc(texels * 13 * sizeof *room);
    if (!room) return kit_fail(err, "G-buffer: no memory to read %d x %d texels", g->width, g->height);
    if (kit_image_new(&image, g->viewport[2], g->viewport[3], names, err)) {
        free(room);
        return -1;
    }
    for (int layer = 0; layer < g->layers && !failed; layer++) failed = read_layer(&image, g, layer, room);
    failed = failed || read_slabs(&image, g, slabs, room);
    free(room);
    if (failed) {
        kit_image_free(&image);
        return kit_fail(err, "G-buffer: %s cannot read its textures back", kit_gl_name());
    }
    *frame = image;
    return 0;
}

int kit_gbuffer_read_depth(kit_image *frame, const kit_gbuffer *g, kit_error *err)
{
    kit_gbuffer first = *g;
    first.layers = 1;
    first.normal = first.albedo = first.direct = first.back = first.slabs = 0;
    return kit_gbuffer_read(frame, &first, err);
}

void kit_gbuffer_free(kit_gbuffer *gbuffer)
{
    const GLuint textures[] = { gbuffer->back,   gbuffer->slabs,  gbuffer->motion, gbuffer->depth,
                                gbuffer->normal, gbuffer->albedo, gbuffer->object, gbuffer->direct };
    layers_free(gbuffer);
    glDeleteTextures((GLsizei)(sizeof textures / sizeof *textures), textures);
    memset(gbuffer, 0, sizeof *gbuffer);
}
