/* capture.c - writes a method's chain, all inputs of its steps and its picture as files, for tests that draw the same
   with another API.

      build/capture FOLDER SCENE METHOD [set K=V,..] [frames N] [env NAME] [light TEXT] [size WxH]

   Draws N frames (1) one after another, and turns the camera by a degree after each. Lit methods have env sky unless
   an env or a light is given. Makes FOLDER, with

      N-PASS.vulkan.vert ..   texts of step N, from 1; examples/tools/glsl/translate.sh FOLDER spv (wgsl) adds others
      manifest.json           as make glsl writes it, with one chain, chains[0], which has the method's name
      capture.json            the inputs of its steps, and the results
      N.bin                   the data with number N: little-endian, no header, equal data once

   capture.json:
      width, height      of the picture
      textures           inputs and results: data (a number); format, vulkan, webgpu (names and VkFormat's number of
                         R32F RG32F RGBA32F R32UI RG32UI RGBA32UI), bytes of a texel, width, height, layers (0: 2D,
                         else an array of so many; layer after layer, rows bottom-up as GL has them, without padding).
                         Values of narrower formats and of depth are stored as floats, exactly
      frames             in their order. The steps' textures begin as 0. After each frame the two textures of a kept
                         output change places
        draws            how often all steps are drawn, one after another (kept ones change places after the last)
        surfels          null; or data, stride in bytes and count of the instances' vertex buffer, which has one vec4
                         attribute after another, as the step's rows name them
        steps            one for each of the chain's:
          width, height  of its targets, all of which is the viewport
          frame          data of the block ssgi_frame, binding 0
          instances      how many to draw
          yours          for each of the step's inputs a number in textures; -1: a step writes it
        results          texture: a number in the chain's textures; is: the number in this file of its expected values

   Targets have the formats of manifest.json. A capture cannot hold extra cameras, margins and patches; these are
   refused. The surfels that pass surfels makes are stored in place of that pass. */
#include "kit/kit_run.h"
#include "tools/glsl/manifest.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

enum { MOST_DATA = 1024, MOST_TEXTURES = 256 };

typedef struct options {
    const char *folder, *scene, *method, *set, *env, *light;
    int frames, width, height;
} options;

static struct {
    uint64_t hash[MOST_DATA]; /* a hash of each piece of data written so far */
    int pieces;
    char *line[MOST_TEXTURES]; /* lines of textures for capture.json */
    int textures;
    GLuint made[MOST_TEXTURES]; /* textures that the steps write, by their numbers; two for a kept output */
    GLuint last[MOST_TEXTURES];
    int writes;
} all;

/* ---- writing ----------------------------------------------------------------------------------------------------- */

/* Writes data to a file once, and returns its number, or -1. */
static int put_data(const options *o, const void *data, size_t size, kit_error *err)
{
    const uint64_t hash = kit_hash(kit_hash(KIT_HASH, &size, sizeof size), data, size);
    char path[1024];
    int i = 0;
    while (i < all.pieces && all.hash[i] != hash) ++i;
    if (i < all.pieces) return i;
    if (i == MOST_DATA) return kit_fail(err, "more than %d pieces of data", MOST_DATA);
    all.hash[all.pieces++] = hash;
    snprintf(path, sizeof path, "%s/%d.bin", o->folder, i);
    return kit_file_write(path, data, size, err) ? -1 : i;
}

/* Reads the texels of a texture, 4 bytes a component. */
static void *texels_of(GLuint texture, GLenum target, const GLint size[3], int components)
{
    const size_t slice = (size_t)size[0] * (size_t)size[1] * (size_t)components;
    float *texels = malloc(slice * (size_t)size[2] * sizeof *texels);
    int failed = !texels;
    if (target == GL_TEXTURE_2D) failed = failed || kit_texture_read(texture, size[0], size[1], components, texels);
    for (int k = 0; target == GL_TEXTURE_2D_ARRAY && k < size[2] && !failed; ++k)
        failed = kit_texture_slice_read(texture, k, size[0], size[1], components, texels + (size_t)k * slice);
    if (!failed) return texels;
    free(texels);
    return NULL;
}

/* Writes a texture to capture.json once, and returns its number, or -1. */
static int put_texture(const options *o, GLuint texture, GLenum target, const char *name, kit_error *err)
{
    static const struct {
        const char *name;
        int vulkan;
        const char *webgpu;
    } formats[2][5] = {
        { { 0 }, { "R32F", 100, "r32float" }, { "RG32F", 103, "rg32float" }, { 0 }, { "RGBA32F", 109, "rgba32float" } },
        { { 0 }, { "R32UI", 98, "r32uint" }, { "RG32UI", 101, "rg32uint" }, { 0 }, { "RGBA32UI", 107, "rgba32uint" } }
    };

    static const GLenum sizes[3] = { GL_TEXTURE_WIDTH, GL_TEXTURE_HEIGHT, GL_TEXTURE_DEPTH };
    static const GLenum depths[5] = { GL_TEXTURE_RED_SIZE, GL_TEXTURE_GREEN_SIZE, GL_TEXTURE_BLUE_SIZE,
                                      GL_TEXTURE_ALPHA_SIZE, GL_TEXTURE_DEPTH_SIZE };
    GLint size[3], bits, type, components = 0;
    char line[256];
    if (!texture) return kit_fail(err, "%s: there is no such texture", name);
    glBindTexture(target, texture);
    for (int k = 0; k < 3; ++k) glGetTexLevelParameteriv(target, 0, sizes[k], &size[k]);
    for (int k = 0; k < 5; ++k) {
        glGetTexLevelParameteriv(target, 0, depths[k], &bits);
        components += bits > 0;
    }
    glGetTexLevelParameteriv(target, 0, GL_TEXTURE_RED_TYPE, &type);
    const int layers = target == GL_TEXTURE_2D_ARRAY ? size[2] : 0, integer = type == GL_UNSIGNED_INT;
    if (components > 4 || !formats[integer][components].name) return kit_fail(err, "%s: has no format here", name);
    void *texels = texels_of(texture, target, size, components);
    if (!texels) return kit_fail(err, "%s: cannot be read back", name);
    const int data = put_data(o, texels, (size_t)size[0] * (size_t)size[1] * (size_t)size[2] * (size_t)components * 4,
                              err);
    free(texels);
    if (data < 0) return -1;
    snprintf(line, sizeof line,
             "{ \"data\": %d, \"format\": \"%s\", \"vulkan\": %d, \"webgpu\": \"%s\", \"bytes\": %d, \"width\": %d, "
             "\"height\": %d, \"layers\": %d }",
             data, formats[integer][components].name, formats[integer][components].vulkan,
             formats[integer][components].webgpu, 4 * components, size[0], size[1], layers);
    for (int i = 0; i < all.textures; ++i)
        if (!strcmp(all.line[i], line)) return i;
    if (all.textures == MOST_TEXTURES || !(all.line[all.textures] = strdup(line)))
        return kit_fail(err, "more than %d textures", MOST_TEXTURES);
    return all.textures++;
}

/* Writes the shaders of a step. Their files' names live as long as the program. */
static int put_texts(const options *o, const ssgi_gl_desc *d, int number, const char *files[SSGI_GL_STAGES],
                     kit_error *err)
{
    static char names[KIT_MAX_PASSES][SSGI_GL_STAGES][64];
    for (int stage = 0; stage < SSGI_GL_STAGES; ++stage) {
        const size_t n = ssgi_gl_emit(NULL, 0, d, stage);
        char *text = malloc(n + 1), *name = names[number][stage], path[1024];
        if (!text) return kit_fail(err, "out of memory");
        if (n) {
            ssgi_gl_emit(text, n + 1, d, stage);
            snprintf(name, sizeof names[0][0], "%d-%s.vulkan.%s", number + 1, ssgi_gl_pass_name(d->pass),
                     endings[stage]);
            snprintf(path, sizeof path, "%s/%s", o->folder, name);
            files[stage] = name;
        }
        const int failed = n && kit_file_write(path, text, n, err);
        free(text);
        if (failed) return -1;
    }
    return 0;
}

/* ---- a run as a chain -------------------------------------------------------------------------------------------- */

/* Returns whether an embedder would draw the pass. */
static int is_captured(const kit_pass *p) { return !p->aside && p->desc.pass != SSGI_GL_PASS_SURFELS; }

static GLuint written(const kit_pass *p, int output)
{
    return p->step->output[output].layers ? p->slices : p->target[output];
}

static int number_of(const GLuint *textures, GLuint texture)
{
    for (int i = 0; i < all.writes; ++i)
        if (textures[i] == texture) return i;
    return -1;
}

/* Numbers the textures that the run's steps write, from 0. A run of several chains is written as one chain. */
static void number_textures(const kit_run *run)
{
    all.writes = 0;
    for (int i = 0; i < run->passes; ++i)
        for (int k = 0; k < run->pass[i].step->outputs && is_captured(&run->pass[i]); ++k) {
            const kit_pass *p = &run->pass[i];
            if (number_of(all.made, written(p, k)) >= 0 || all.writes == MOST_TEXTURES) continue;
            all.made[all.writes] = written(p, k);
            all.last[all.writes++] = p->step->output[k].kept ? p->last[k] : 0;
        }
}

/* Returns a pass's step in Vulkan's GLSL, with textures by these numbers. */
static ssgi_gl_step step_of(const kit_pass *p)
{
    ssgi_gl_step s = *p->step;
    ssgi_gl_io io[SSGI_GL_MAX_IO];
    s.desc = p->desc;
    s.desc.shader.dialect = SSGI_GL_DIALECT_VULKAN;
    for (int k = 0, rows = ssgi_gl_reflect(&s.desc, io, SSGI_GL_MAX_IO); k < rows; ++k)
        for (int o = 0; o < s.outputs && io[k].kind == SSGI_GL_IO_OUTPUT; ++o)
            if (!strcmp(io[k].name, s.output[o].name)) s.output[o].binding = io[k].binding;
    for (int k = 0; k < s.outputs; ++k) s.output[k].texture = number_of(all.made, written(p, k));
    for (int k = 0; k < s.inputs; ++k) {
        if (s.input[k].meaning >= 0) continue;
        const int kept = number_of(all.last, p->input[k]);
        s.input[k].texture = kept >= 0 ? kept : number_of(all.made, p->input[k]);
    }
    return s;
}

/* Writes the run as one chain of manifest.json. pass: the one that has the method's name */
static int put_chain(const options *o, const kit_run *run, int pass, kit_error *err)
{
    static ssgi_gl_step steps[KIT_MAX_PASSES];
    static const char *files[KIT_MAX_PASSES][SSGI_GL_STAGES];
    char path[1024];
    ssgi_gl_chain chain;
    int count = 0;
    memset(&chain, 0, sizeof chain);
    for (int i = 0; i < run->passes; ++i) {
        const kit_pass *p = &run->pass[i];
        if (p->box[2]) return kit_fail(err, "margin: only whole pictures are captured");
        if (p->desc.gather.views || p->desc.surfel.tessellate)
            return kit_fail(err, "%s: is not captured", p->desc.gather.views ? "views" : "way=direct, way=capture");
        if (!is_captured(p)) continue;
        steps[count] = step_of(p);
        if (put_texts(o, &steps[count].desc, count, files[count], err)) return -1;
        ++count;
    }
    if (!count) return kit_fail(err, "%s draws nothing there", o->method);
    for (int i = count - 1; i >= 0; --i)
        if (steps[i].desc.pass == pass) chain.desc = steps[i].desc;
    manifest_chain(o->method, o->set, &chain, steps, count, (const char *const(*)[SSGI_GL_STAGES])files);
    snprintf(path, sizeof path, "%s/manifest.json", o->folder);
    return manifest_write(path, err);
}

/* ---- a frame ----------------------------------------------------------------------------------------------------- */

static int put_step(FILE *f, const options *o, kit_run *run, const kit_pass *p, kit_error *err)
{
    const ssgi_gl_step *s = p->step;
    ssgi_gl_frame frame = run->frame;
    if (s->frame == KIT_FRAME_VPLS) frame.lights = run->vpls;
    const int block = put_data(o, &frame, sizeof frame, err);
    if (block < 0) return -1;
    fprintf(f, "{ \"width\": %d, \"height\": %d, \"frame\": %d, \"instances\": %d, \"yours\": [", p->width, p->height,
            block,
            p->array       ? (int)run->surfels
            : s->instances ? s->instances
                           : p->instances);
    for (int k = 0; k < s->inputs; ++k) {
        const ssgi_gl_input *in = &s->input[k];
        const int number = in->meaning < 0
                             ? -1
                             : put_texture(o, kit_pass_texture(run, p, in->name), in->target, in->name, err);
        if (in->meaning >= 0 && number < 0) return -1;
        fprintf(f, "%s%d", k ? ", " : "", number);
    }
    fputs("] }", f);
    return 0;
}

static int put_surfels(FILE *f, const options *o, const kit_run *run, kit_error *err)
{
    const size_t size = run->surfels * sizeof(ssgi_surfel);
    void *surfels = malloc(size + 1);
    if (!surfels) return kit_fail(err, "out of memory");
    glBindBuffer(GL_ARRAY_BUFFER, run->buffers[run->arrays[1] != 0]);
    glGetBufferSubData(GL_ARRAY_BUFFER, 0, (GLsizeiptr)size, surfels);
    const int data = put_data(o, surfels, size, err);
    free(surfels);
    fprintf(f, "{ \"data\": %d, \"stride\": %zu, \"count\": %zu }", data, sizeof(ssgi_surfel), run->surfels);
    return data < 0 ? -1 : 0;
}

/* Draws a frame and writes it to capture.json. */
static int put_frame(FILE *f, const options *o, kit_run *run, int draws, kit_error *err)
{
    const GLuint results[2] = { run->light, run->bounce };
    const char *between = "";
    int failed = 0;
    number_textures(run);
    fprintf(f, "{ \"draws\": %d, \"surfels\": ", draws);
    if (!run->surfels) fputs("null", f);
    else failed = put_surfels(f, o, run, err);
    fputs(",\n  \"steps\": [", f);
    for (int i = 0; i < run->passes && !failed; ++i) {
        if (!is_captured(&run->pass[i])) continue;
        fprintf(f, "%s\n    ", between);
        failed = put_step(f, o, run, &run->pass[i], err);
        between = ",";
    }
    fputs("],\n  \"results\": [", f);
    between = "";
    for (int k = 0; k < 2 && !failed; ++k) {
        const int texture = results[k] ? number_of(all.made, results[k]) : -1;
        if (texture < 0) continue; /* has no texture, or one to which a later pass adds */
        const int is = put_texture(o, results[k], GL_TEXTURE_2D, "result", err);
        failed = is < 0;
        fprintf(f, "%s{ \"texture\": %d, \"is\": %d }", between, texture, is);
        between = ", ";
    }
    fputs("] }", f);
    return failed ? -1 : 0;
}

static int put_frames(FILE *f, const options *o, const kit_method *method, const kit_scene *scene,
                      const kit_lighting *light, kit_error *err)
{
    const kit_world world = { scene, light };
    const int again = method->set.reuse || method->set.occluded_emitters;
    kit_gbuffer seen[2] = { { 0 } };
    kit_frames frames = { 0 };
    int failed = 0;
    if (again && o->frames > 1) return kit_fail(err, "frames: of reuse and dimmed there is one");
    for (int k = 0; k < o->frames && !failed; ++k) {
        kit_gbuffer *g = &seen[k & 1];
        kit_camera camera = scene->camera;
        kit_camera_orbit(&camera, &scene->camera, k);
        failed = kit_gbuffer_from_scene(g, scene, &camera, NULL, err)
              || kit_frames_next(&frames, g, method, scene->radius, &world, NULL, err);
        if (!failed) {
            fputs(k ? ",\n" : "\n", f);
            kit_run_draw(frames.now, 0);
            failed = put_frame(f, o, frames.now, again ? 3 : 1, err)
                  || (!k && put_chain(o, frames.now, method->pass, err));
        }
        kit_gbuffer_free(&seen[!(k & 1)]);
    }
    kit_frames_close(&frames);
    for (int k = 0; k < 2; ++k) kit_gbuffer_free(&seen[k]);
    return failed ? -1 : 0;
}

static int put_capture(const options *o, const char *frames, kit_error *err)
{
    char *text = NULL, path[1024];
    size_t size;
    FILE *f = open_memstream(&text, &size);
    if (!f) return kit_fail(err, "out of memory");
    fprintf(f, "{ \"width\": %d, \"height\": %d,\n\"textures\": [", o->width, o->height);
    for (int i = 0; i < all.textures; ++i) fprintf(f, "%s\n%s", i ? "," : "", all.line[i]);
    fprintf(f, "\n],\n\"frames\": [%s\n] }\n", frames);
    fclose(f);
    snprintf(path, sizeof path, "%s/capture.json", o->folder);
    const int failed = kit_file_write(path, text, size, err);
    free(text);
    return failed ? -1 : 0;
}

/* ---- the command line -------------------------------------------------------------------------------------------- */

static int read_options(options *o, int argc, char **argv, kit_error *err)
{
    *o = (options){ argv[1], argv[2], argv[3], "", NULL, NULL, 1, 320, 180 };
    for (int i = 4; i < argc; i += 2) {
        const char *key = argv[i], *value = i + 1 < argc ? argv[i + 1] : "";
        int bad = 0;
        if (!strcmp(key, "set")) o->set = value;
        else if (!strcmp(key, "env")) o->env = value;
        else if (!strcmp(key, "light")) o->light = value;
        else if (!strcmp(key, "frames")) bad = sscanf(value, "%d", &o->frames) != 1 || o->frames < 1;
        else if (!strcmp(key, "size"))
            bad = sscanf(value, "%dx%d", &o->width, &o->height) != 2 || o->width < 1 || o->height < 1;
        else bad = 1;
        if (bad)
            return kit_fail(err, "%s %s: must be set K=V,.., frames N, env NAME, light TEXT or size WxH", key, value);
    }
    return 0;
}

static int light_it(kit_lighting *light, const options *o, const kit_method *method, const kit_scene *scene,
                    kit_error *err)
{
    if (!method->lit) return 0;
    if (o->light && kit_light_parse(&light->light[light->lights++], o->light, NULL, err)) return -1;
    if (!o->env && !o->light && kit_scene_seeded(o->scene)) return kit_light_scene(light, scene, err);
    return o->env || !o->light ? kit_env_read(&light->env, o->env ? o->env : "sky", err) : 0;
}

static int capture(const options *o, kit_error *err)
{
    kit_method method;
    kit_scene scene = { 0 };
    kit_lighting light = { 0 };
    char *frames = NULL;
    size_t size;
    if (kit_method_find(&method, o->method, err) || kit_method_set(&method, o->set, err)) return -1;
    if (mkdir(o->folder, 0777) && errno != EEXIST) return kit_fail(err, "%s: %s", o->folder, strerror(errno));
    if (kit_gl_open(NULL, err)) return -1;
    int failed = kit_scene_load(&scene, o->scene, 0, err) || light_it(&light, o, &method, &scene, err);
    FILE *f = open_memstream(&frames, &size);
    if (!f) failed = kit_fail(err, "out of memory");
    scene.camera.width = o->width;
    scene.camera.height = o->height;
    failed = failed || put_frames(f, o, &method, &scene, &light, err);
    if (f) fclose(f);
    failed = failed || put_capture(o, frames, err);
    free(frames);
    for (int i = 0; i < all.textures; ++i) free(all.line[i]);
    kit_image_free(&light.env);
    kit_scene_free(&scene);
    kit_fields_free();
    kit_gl_close();
    return failed ? -1 : 0;
}

int main(int argc, char **argv)
{
    kit_error err = { "" };
    options o;
    if (argc < 4) {
        fputs("usage: capture FOLDER SCENE METHOD [set K=V,..] [frames N] [env NAME] [light TEXT] [size WxH]\n",
              stderr);
        return 2;
    }
    if (!read_options(&o, argc, argv, &err) && !capture(&o, &err)) return 0;
    fprintf(stderr, "capture: %s\n", err.text);
    return 2;
}
